//! The commands of the program `tripos`: equations of motion from a model file, derived by several formulations,
//! compiled and run.
//!
//! [`run_program`] is the program itself. [`run_command`] runs a command inside another program and returns the printed
//! text. The Python package has every command by this function.

mod arguments;
mod chart;
mod commands;
mod files;
mod glossary;
mod latex;
mod page;
mod phrases;
mod picture;
mod plot;
mod run_panels;
mod sketch;
mod stability;
mod sweep;
mod terminal;
mod urdf;
mod view;

use arguments::{Arguments, Command};
use clap::Parser;
use commands::derive::latex::LatexExtent;
use commands::diff::coordinates::in_found_coordinates;
use commands::diff::{Compare, diff_with_file};
use commands::inverse::Shape;
use commands::linearise::LinearSystemFormat;
use files::scene_file::read_scene_with;
use std::ffi::OsString;
use std::process::ExitCode;
use std::sync::{Arc, Mutex, PoisonError};
use terminal::failure::{Failure, Output, print_json, print_to_stderr};
use tripos::studies::chart_case::PrintedEquationsChoice;
use tripos::studies::steady::LinearisationOptions;
use tripos::studies::work_precision_chart::ChartPlan;
use tripos_derive::mechanics::RegressorParameters;

/// Runs the command in the command line of this process, and prints its results.
///
/// Returns the exit status: 0 done, 1 the answer is "no", 2 bad input, 3 a run that stopped, 130 an interruption.
#[must_use]
pub fn run_program() -> ExitCode {
    let words: Vec<OsString> = std::env::args_os().collect();
    match Arguments::try_parse_from(&words) {
        Ok(arguments) => ExitCode::from(finish_command(arguments.command)),
        Err(error) => {
            print_json_of_wrong_arguments(&error, &words);
            error.exit()
        }
    }
}

/// Results of a command that ran inside another program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CommandOutput {
    /// Exit status: 0 done, 1 the answer is "no", 2 bad input, 3 a run that stopped, 130 an interruption.
    pub status: u8,
    /// Text that the program would print to standard output: the result.
    pub output: String,
    /// Text that the program would print to standard error: warnings, notes and errors, each on one or more lines.
    pub messages: String,
}

/// Returns the lock that lets the commands of a process run one after another, since an interruption affects the whole
/// process. A forked process has a lock of its own, since no command of its parent runs in it.
fn command_lock() -> Arc<Mutex<()>> {
    static LOCK: Mutex<Option<(u32, Arc<Mutex<()>>)>> = Mutex::new(None);
    let process = std::process::id();
    let mut known = LOCK.lock().unwrap_or_else(PoisonError::into_inner);
    match &*known {
        Some((owner, lock)) if *owner == process => Arc::clone(lock),
        _ => Arc::clone(&known.insert((process, Arc::default())).1),
    }
}

/// Runs a command of the program `tripos`. `words` are the words of its command line, without the name of the program.
///
/// Nothing is printed: the result contains the texts for standard output and standard error. Signals are left to the
/// caller, who can end the command from another thread by [`interrupt_command`]. Calls from several threads run one
/// after another.
pub fn run_command(words: impl IntoIterator<Item = OsString>) -> CommandOutput {
    let lock = command_lock();
    let _alone = lock.lock().unwrap_or_else(PoisonError::into_inner);
    terminal::interruption::forget_interruption();
    let words: Vec<OsString> = std::iter::once("tripos".into()).chain(words).collect();
    let (status, printed) = terminal::console::captured(|| match Arguments::try_parse_from(&words) {
        Ok(arguments) => finish_command(arguments.command),
        Err(error) => {
            print_json_of_wrong_arguments(&error, &words);
            let text = error.render().to_string();
            if error.use_stderr() {
                print_to_stderr(text.trim_end());
            } else {
                // The text is kept in memory, so that writing cannot fail.
                let _ = terminal::failure::print(&text);
            }
            u8::try_from(error.exit_code()).unwrap_or(terminal::failure::status::BAD_INPUT)
        }
    });
    CommandOutput { status, output: printed.output, messages: printed.messages }
}

/// Asks the command that [`run_command`] runs on another thread to end soon. Its finished results are kept.
pub fn interrupt_command() {
    terminal::interruption::ask_for_interruption();
}

/// Runs a command, and prints its failure. Returns the exit status.
fn finish_command(command: Command) -> u8 {
    let is_json = command.is_json();
    match run(command) {
        Ok(status) => status,
        Err(Failure::Hangup) => Failure::Hangup.status(),
        Err(failure) => {
            // If the user interrupted the command, a failure that follows from this is reported as an interruption.
            let is_own = matches!(failure, Failure::Interrupted(_) | Failure::Output(..));
            let failure = if terminal::interruption::is_interrupted() && !is_own {
                Failure::Interrupted(String::new())
            } else {
                failure
            };
            print_to_stderr(&failure.to_string());
            if is_json {
                // If standard output is closed, the error cannot be reported there either.
                let _ = print_json(&failure.json());
            }
            failure.status()
        }
    }
}

/// Prints the error of the command line as JSON if JSON was requested.
fn print_json_of_wrong_arguments(error: &clap::Error, words: &[OsString]) {
    let has = |word: &str| words.iter().any(|given| given == word);
    let is_json =
        has("--json") || has("--format=json") || words.windows(2).any(|w| w[0] == "--format" && w[1] == "json");
    if error.use_stderr() && is_json {
        let text = error.render().to_string();
        let (what, help) = text.trim_start_matches("error: ").split_once("\n\n").unwrap_or((text.as_str(), ""));
        let _ = print_json(&Failure::request(what.to_owned(), help.trim_end().to_owned()).json());
    }
}

/// Runs a subcommand and returns its exit status. `Err` is the failure of the subcommand.
fn run(command: Command) -> Result<u8, Failure> {
    match command {
        Command::New { folder, like, from, loops, floating, as_written } => {
            let options = tripos_robots::Options { is_floating: floating, is_as_written: as_written };
            commands::new::new(&folder, &commands::new::Beginning { like, from, loops, options })
        }
        Command::Completions { shell } => commands::manual::completions(shell),
        Command::Man { out } => commands::manual::man(out.as_deref()),
        Command::Schema { format } => commands::schema::schema(&format),
        Command::Page(request) => commands::page::page(&request),
        Command::Derive { model, by, form, format, fragment, json } => {
            let format = if json { arguments::Format::Json } else { format };
            let part = if fragment { LatexExtent::Fragment } else { LatexExtent::Document };
            commands::derive::derive(&model, by.as_deref(), form, format, part)
        }
        Command::Diff { model, others, certificate: Some(path), json, .. } => {
            commands::diff::diff_with_certificate(&model, &others, &path, Output::of_flag(json))
        }
        Command::Diff { model, others, find_coordinates, json, .. } => {
            let compare: Compare = if find_coordinates { in_found_coordinates } else { diff_with_file };
            commands::diff::diff(&model, &others, compare, Output::of_flag(json))
        }
        Command::Shelf { folder, out, json } => {
            commands::shelf::shelf(folder.as_deref(), out.as_deref(), Output::of_flag(json))
        }
        Command::Grade(request) => commands::grade::grade(&request),
        Command::Check { model, json } => commands::check::check(&model, Output::of_flag(json)),
        Command::Equilibria { model, from, starts, over, wanted, out, json } => {
            let from = commands::equilibria::StartingPoints { file: from.as_deref(), starts };
            commands::equilibria::equilibria(&model, &from, &over, &wanted, out.as_deref(), Output::of_flag(json))
        }
        Command::Linearise { model, about, inputs, outputs, letters, whole, as_is, format, json } => {
            let wanted = LinearisationOptions { inputs, whole, as_is };
            let written = if json { LinearSystemFormat::Json } else { LinearSystemFormat::Notation(format) };
            commands::linearise::linearise(&model, &about, &wanted, &outputs, &letters, written)
        }
        Command::Inverse { model, motion, inputs, csv, json } => {
            commands::inverse::inverse(&model, &motion, &inputs, Shape::of(json, csv))
        }
        Command::Identify { model, declared, at, csv, json } => {
            let varied = if declared { RegressorParameters::Declared } else { RegressorParameters::Bodies };
            commands::identify::identify(&model, varied, at.as_deref(), Shape::of(json, csv))
        }
        Command::Fit(request) => commands::fit::fit(&request),
        Command::Excite(request) => commands::excite::excite(&request),
        Command::Prove { model, also, certificate, format, exact, json } => {
            let certificate = certificate.as_deref().map(|path| (path, format));
            commands::prove::prove(&model, &also, certificate, exact, Output::of_flag(json))
        }
        Command::Regenerate { models, check: true, json } => {
            commands::regenerate::check(&models, Output::of_flag(json))
        }
        Command::Regenerate { models, check: false, json } => {
            commands::regenerate::regenerate(&models, Output::of_flag(json))
        }
        Command::Emit { model, out, language, formulations, with, functions, base, json } => {
            let in_base_parameters = base;
            let request =
                commands::emit::EmitRequest { model, out, language, formulations, with, functions, in_base_parameters };
            commands::emit::emit(&request, Output::of_flag(json))
        }
        Command::Fmu { scene, out, fmi, set, only_sources, json } => {
            let request = commands::fmu::UnitRequest { scene, out, set, fmi, only_sources };
            commands::fmu::fmu(&request, Output::of_flag(json))
        }
        Command::Evaluate { model, by, at, json } => {
            commands::evaluate::evaluate(&model, &by.as_str().into(), &at, Output::of_flag(json))
        }
        Command::Stability { scene, set, quick, out, json } => {
            commands::stability::stability(&read_scene_with(&scene, &set.set)?, quick, &out, Output::of_flag(json))
        }
        Command::Chart { scene, set, quick, printed, out, json } => {
            let plan = if quick { ChartPlan::quick() } else { ChartPlan::full() };
            let printed = if printed { PrintedEquationsChoice::Included } else { PrintedEquationsChoice::LeftOut };
            commands::chart::chart(&read_scene_with(&scene, &set.set)?, &plan, printed, &out, Output::of_flag(json))
        }
        Command::Scene { scene, set, within, certificate, json } => {
            let (scene, output) = (read_scene_with(&scene, &set.set)?, Output::of_flag(json));
            match within {
                Some(within) => commands::abbreviated_scene::abbreviated_scene(&scene, within, output),
                None => commands::scene::scene(&scene, certificate.as_deref(), output),
            }
        }
        Command::Plot(request) => commands::plot::plot(&request),
        Command::Simulate(request) => commands::simulate::simulate(&request),
        Command::Sketch { model, at, out, json } => {
            commands::sketch::sketch(&model, at.as_deref(), &out, Output::of_flag(json))
        }
        Command::View(request) => commands::view::view(&request),
        Command::Sweep(request) => commands::sweep::sweep(&request),
    }
}
