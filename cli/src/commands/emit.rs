//! `tripos emit`: the generated Rust of any model file, as a module for a crate of the user's own.

use crate::failure::{Failure, print, say};
use crate::workspace::model_file;
use std::path::{Path, PathBuf};
use tripos::code::formulation;
use tripos_codegen::emit::{PlaceError, emit as emission, place};
use tripos_derive::plain::path_in_line;

/// Writes the module, and says what became of each file.
pub fn emit(model: &Path, out: &Path, formulations: &[String]) -> Result<u8, Failure> {
    let formulations = formulations.iter().map(|name| formulation(name)).collect::<Result<Vec<_>, _>>()?;
    let module = module(out)?;
    let emission = emission(&model_file(model), &module, &formulations)?;
    for (_, error) in &emission.left_out {
        say(&format!("not emitted: {error}"));
    }
    let placed = place(&emission, out).map_err(|error| match error {
        PlaceError::Foreign(_) => {
            Failure::request(error.to_string(), "give another folder, or move the file away".to_owned())
        }
        PlaceError::Write(error) => error.into(),
        PlaceError::Io(path, error) => Failure::Output(path_in_line(&path), error),
    })?;
    let lines: Vec<String> = placed.iter().map(|file| format!("{file}\n")).collect();
    print(&lines.concat())?;
    say(&format!(
        "declare it as `pub mod {module};` in a crate that depends on tripos-traits, or include its mod.rs in a module"
    ));
    Ok(0)
}

/// The name of the module: that of its folder.
fn module(out: &Path) -> Result<String, Failure> {
    // `.` and `..` have no name of their own.
    let named =
        if out.file_name().is_some() { out.to_owned() } else { out.canonicalize().unwrap_or_else(|_| PathBuf::new()) };
    named.file_name().map(|name| name.to_string_lossy().into_owned()).ok_or_else(|| {
        let what = format!("`{}` has no name that a module could have", path_in_line(out));
        Failure::request(what, "give a folder whose name is a Rust module, as in `--out src/pendulum`".to_owned())
    })
}
