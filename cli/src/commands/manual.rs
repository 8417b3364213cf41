//! Commands `tripos completions` and `tripos man`: they write descriptions of the command line for shells and for
//! `man`.

use crate::arguments::Arguments;
use crate::files::output_files::{make_folder, write_text_file};
use crate::terminal::failure::{Failure, print};
use clap::CommandFactory;
use clap_complete::Shell;
use clap_mangen::Man;
use std::path::Path;
use tripos_derive::plain_text::path_as_plain_text;

/// Prints the script with a shell's completions to standard output. Returns the exit status.
///
/// # Errors
/// [`Failure`] if the completions cannot be printed.
pub fn completions(shell: Shell) -> Result<u8, Failure> {
    let mut written = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "tripos", &mut written);
    print(&String::from_utf8_lossy(&written))?;
    Ok(0)
}

/// Prints the manual page of `tripos`. If `out` is given, instead writes this page and the pages of all subcommands
/// into that folder. Returns the exit status.
///
/// # Errors
/// [`Failure`] if a page cannot be printed or written.
pub fn man(out: Option<&Path>) -> Result<u8, Failure> {
    let mut command = Arguments::command();
    // This call gives subcommands their full names.
    command.build();
    let Some(out) = out else {
        print(&page(&Man::new(command))?)?;
        return Ok(0);
    };
    make_folder(out)?;
    let commands: Vec<clap::Command> = command.get_subcommands().cloned().collect();
    for command in std::iter::once(command).chain(commands) {
        let man = Man::new(command);
        let place = out.join(man.get_filename());
        write_text_file(&place, &page(&man)?)?;
        print(&format!("page     {}\n", path_as_plain_text(&place)))?;
    }
    Ok(0)
}

/// Returns the text of a manual page.
/// `Err` if the page cannot be rendered.
fn page(man: &Man) -> Result<String, Failure> {
    let mut written = Vec::new();
    man.render(&mut written).map_err(|error| Failure::Output("the manual page".to_owned(), error))?;
    Ok(String::from_utf8_lossy(&written).into_owned())
}
