//! Failures of commands: their messages, exit statuses and JSON.

use serde_json::{Value, json};
use std::fmt;
use tripos::Error;
use tripos_codegen::files::WriteError;
use tripos_derive::SCHEMA;
use tripos_derive::diagnostic::{Diagnostic, Diagnostics};
use tripos_derive::plain::{is_forbidden, path_in_line, visible};

/// Exit statuses, equal for every command.
pub mod status {
    /// Status of the answer "no": a difference, stale text.
    pub const NO: u8 = 1;
    /// Status after bad input: a file, an option or a request.
    pub const BAD_INPUT: u8 = 2;
    /// Status after a run that could not go on.
    pub const STOPPED: u8 = 3;
    /// Status after an interruption by the user; finished results are kept.
    pub const INTERRUPTED: u8 = 130;
}

/// Reason why a command could not do its work.
#[derive(Debug)]
pub enum Failure {
    /// A request was refused, or has no result, for this reason.
    Refused(Error),
    /// A file could not be written: its name and the error.
    Output(String, std::io::Error),
    /// The user interrupted the command: words for the results that are kept; empty if there are none.
    Interrupted(String),
    /// The reader of standard output has closed it.
    Hangup,
}

impl Failure {
    /// Makes the failure of a request that makes no sense, with a help on what to do instead.
    pub fn request(what: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Refused(Error::request(what, help))
    }

    /// First line of the failure's message.
    pub fn first_line(&self) -> String {
        self.message_and_help().0.lines().next().unwrap_or_default().to_owned()
    }

    /// Exit status of the command after this failure.
    pub fn status(&self) -> u8 {
        match self {
            Self::Refused(Error::Stopped(_)) => status::STOPPED,
            Self::Refused(_) | Self::Output(..) => status::BAD_INPUT,
            Self::Interrupted(_) => status::INTERRUPTED,
            Self::Hangup => 0,
        }
    }

    /// Failure as JSON for programs: the message, the help, every place in a file, and the exit status.
    pub fn json(&self) -> Value {
        let places = if let Self::Refused(error) = self { places(error.files()) } else { Vec::new() };
        let (message, help) = self.message_and_help();
        json!({ "error": { "message": message, "help": help, "places": places }, "exit_status": self.status() })
    }

    /// Message and help of the failure; those of the first error if there are several.
    fn message_and_help(&self) -> (String, Option<String>) {
        match self {
            Self::Refused(error) => error.what_and_help(),
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
            // An interruption is no error: the user wanted it.
            (_, (what, _)) => f.write_str(&what),
        }
    }
}

/// Every error of these files as JSON, with its place if it has one.
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
            // The reader of the output is gone.
            WriteError::Io(_, error) if error.kind() == std::io::ErrorKind::BrokenPipe => Self::Hangup,
            WriteError::Io(path, error) => Self::Output(path_in_line(&path), error),
        }
    }
}

/// Prints a warning on standard error. A failure to write it is ignored, since no other channel is left.
pub fn warn(text: &str) {
    say(&format!("warning: {text}"));
}

/// Prints a line on standard error, for people.
pub fn say(text: &str) {
    use std::io::Write;
    let _ = writeln!(std::io::stderr().lock(), "{}", visible(text));
}

/// Writes text for people to standard output. A closed pipe is a [`Failure::Hangup`].
pub fn print(text: &str) -> Result<(), Failure> {
    write_out(&visible(text))
}

/// Writes JSON to standard output, with the version of its format first. Control characters and those that change the
/// direction of text are escaped; JSON restores them.
pub fn print_json(value: &serde_json::Value) -> Result<(), Failure> {
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
    write_out(&out)
}

/// Form in which a command prints its result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Output {
    /// Lines for people.
    Text,
    /// JSON for programs.
    Json,
}

impl Output {
    /// Form for the flag `--json`: JSON if it is given.
    pub fn of_flag(json: bool) -> Self {
        if json { Self::Json } else { Self::Text }
    }
}

/// Prints the result of a command: lines for people, or JSON for programs.
///
/// # Errors
/// [`Failure`] if standard output cannot be written.
pub fn print_either(output: Output, lines: &str, value: &serde_json::Value) -> Result<(), Failure> {
    match output {
        Output::Text => print(lines),
        Output::Json => print_json(value),
    }
}

fn write_out(text: &str) -> Result<(), Failure> {
    use std::io::Write;
    let mut out = std::io::stdout().lock();
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(|error| match error.kind() {
        std::io::ErrorKind::BrokenPipe => Failure::Hangup,
        _ => Failure::Output("standard output".to_owned(), error),
    })
}
