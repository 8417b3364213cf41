//! Failures of commands: messages, exit statuses and JSON. Also prints results and warnings.

use super::console::{write_message, write_output};
use serde_json::{Value, json};
use std::fmt;
use tripos::Error;
use tripos_codegen::draft_file::WriteError;
use tripos_derive::SCHEMA;
use tripos_derive::diagnostic::{Diagnostic, Diagnostics};
use tripos_derive::plain_text::{is_forbidden, path_as_plain_text, with_visible_characters};

/// Exit statuses, which mean the same for every command.
pub mod status {
    /// Exit status for the answer "no", such as a difference or outdated generated text.
    pub const NO: u8 = 1;
    /// Exit status after bad input: a file, an option or a request.
    pub const BAD_INPUT: u8 = 2;
    /// Exit status after a run that stopped before its end.
    pub const STOPPED: u8 = 3;
    /// Exit status after an interruption by the user. Finished results are kept.
    pub const INTERRUPTED: u8 = 130;
}

/// Reason why a command failed.
#[derive(Debug)]
pub enum Failure {
    /// A request was refused, or has no result. The error is the reason.
    Refused(Error),
    /// A file could not be written. The fields are its name and the error of the system.
    Output(String, std::io::Error),
    /// The user interrupted the command. The text names the results that are kept; empty if there are none.
    Interrupted(String),
    /// The program that reads standard output has closed it.
    Hangup,
}

impl Failure {
    /// Creates the failure of a request that cannot be fulfilled. `what` says what is wrong, and `help` what the user
    /// can do.
    pub fn request(what: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Refused(Error::request(what, help))
    }

    /// Returns the first line of the failure's message, without help.
    pub fn first_line(&self) -> String {
        self.message_and_help().0.lines().next().unwrap_or_default().to_owned()
    }

    /// Returns the exit status of the command after this failure.
    pub fn status(&self) -> u8 {
        match self {
            Self::Refused(Error::Stopped(_)) => status::STOPPED,
            Self::Refused(_) | Self::Output(..) => status::BAD_INPUT,
            Self::Interrupted(_) => status::INTERRUPTED,
            Self::Hangup => 0,
        }
    }

    /// Returns the failure as JSON: message, help, every place in a file, and exit status.
    pub fn json(&self) -> Value {
        let places = if let Self::Refused(error) = self { places(error.files()) } else { Vec::new() };
        let (message, help) = self.message_and_help();
        json!({ "error": { "message": message, "help": help, "places": places }, "exit_status": self.status() })
    }

    /// Returns the message of the failure, and its help; `None` without help. Of several errors, the first is used.
    fn message_and_help(&self) -> (String, Option<String>) {
        match self {
            Self::Refused(error) => error.message_and_advice(),
            Self::Output(path, error) => {
                (format!("cannot write `{path}`: {error}"), Some("give a path that can be written".to_owned()))
            }
            Self::Interrupted(kept) if kept.is_empty() => {
                ("interrupted before there was anything to keep: nothing is written".to_owned(), None)
            }
            Self::Interrupted(kept) => (format!("interrupted: {kept}"), None),
            Self::Hangup => Default::default(),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self, self.message_and_help()) {
            (Self::Refused(error), _) => write!(f, "{error}"),
            (Self::Output(..), (what, Some(help))) => write!(f, "error: {what}\nhelp: {help}"),
            // An interruption by the user is no error, so that the message does not contain the word `error`.
            (_, (what, _)) => f.write_str(&what),
        }
    }
}

/// Returns every error of these files as JSON, with file, line and column.
fn places(files: &[Diagnostics]) -> Vec<Value> {
    let of = |file: &Diagnostics| {
        let place = |d: &Diagnostic| {
            let path = file.file(d).path.display().to_string();
            let (line, column) = file.place(d).unzip();
            json!({ "file": path, "line": line, "column": column, "message": d.message, "help": d.help })
        };
        file.list.iter().map(place).collect::<Vec<_>>()
    };
    files.iter().flat_map(of).collect()
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        if matches!(error, Error::Interrupted) { Self::Interrupted(String::new()) } else { Self::Refused(error) }
    }
}

impl From<Diagnostics> for Failure {
    fn from(diagnostics: Diagnostics) -> Self {
        Self::Refused(diagnostics.into())
    }
}

impl From<WriteError> for Failure {
    fn from(error: WriteError) -> Self {
        let what = error.to_string();
        match error {
            WriteError::There(_) => {
                Self::request(what, "give another file, or --overwrite to replace this one".to_owned())
            }
            WriteError::Appeared(..) => Self::request(what, "rename this file, so that it is kept".to_owned()),
            WriteError::Busy(_) => Self::request(what, "wait for it, or give another file".to_owned()),
            // The program that reads the output has ended.
            WriteError::Io(_, error) if error.kind() == std::io::ErrorKind::BrokenPipe => Self::Hangup,
            WriteError::Io(path, error) => Self::Output(path_as_plain_text(&path), error),
        }
    }
}

/// Prints a warning on standard error. A failure to write it is ignored, since no other channel is left.
pub fn warn(text: &str) {
    print_to_stderr(&format!("warning: {text}"));
}

/// Prints a line for the user on standard error. A failure to write it is ignored.
pub fn print_to_stderr(text: &str) {
    write_message(&with_visible_characters(text));
}

/// Writes text for the user to standard output.
///
/// # Errors
/// [`Failure::Hangup`] for a closed pipe, `Failure::Output` for another error.
pub fn print(text: &str) -> Result<(), Failure> {
    write_out(&with_visible_characters(text))
}

/// Writes JSON to standard output, with the version of its format first. Control characters and
/// characters that change the direction of text are escaped.
///
/// # Errors
/// [`Failure::Hangup`] for a closed pipe, `Failure::Output` for another error.
pub fn print_json(value: &serde_json::Value) -> Result<(), Failure> {
    write_out(&json_text(value))
}

/// Returns JSON as [`print_json`] writes it, byte for byte, with the version of its format first.
pub fn json_text(value: &serde_json::Value) -> String {
    let mut versioned = serde_json::Map::from_iter([("schema".to_owned(), SCHEMA.into())]);
    let versioned = match value {
        serde_json::Value::Object(entries) => {
            versioned.extend(entries.clone());
            &versioned.into()
        }
        other => other,
    };
    let mut out = String::new();
    for c in format!("{versioned:#}\n").chars() {
        if c == '\n' || !is_forbidden(c) {
            out.push(c);
        } else {
            out.extend(c.encode_utf16(&mut [0; 2]).iter().map(|unit| format!("\\u{unit:04x}")));
        }
    }
    out
}

/// Format in which a command prints its result: text or JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// The result is printed as lines of text for the user.
    Text,
    /// The result is printed as JSON for other programs.
    Json,
}

impl Output {
    /// Returns the format for the flag `--json`: JSON if the flag is given, else text.
    pub fn of_flag(json: bool) -> Self {
        if json { Self::Json } else { Self::Text }
    }
}

/// Prints the result of a command: lines of text for the user, or JSON for other programs.
///
/// # Errors
/// [`Failure`] if standard output cannot be written.
pub fn print_result(output: Output, lines: &str, value: &serde_json::Value) -> Result<(), Failure> {
    match output {
        Output::Text => print(lines),
        Output::Json => print_json(value),
    }
}

/// Writes text to standard output and flushes it.
/// `Err` is `Failure::Hangup` for a closed pipe, otherwise `Failure::Output`.
fn write_out(text: &str) -> Result<(), Failure> {
    write_output(text).map_err(|error| match error.kind() {
        std::io::ErrorKind::BrokenPipe => Failure::Hangup,
        _ => Failure::Output("standard output".to_owned(), error),
    })
}
