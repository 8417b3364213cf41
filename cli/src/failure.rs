//! Failures of commands: their messages, exit statuses and JSON.

use serde_json::{Value, json};
use std::fmt;
use tripos::Error;
use tripos_codegen::files::WriteError;
use tripos_derive::SCHEMA;
use tripos_derive::diagnostic::{Diagnostic, Diagnostics};
use tripos_derive::plain::{is_forbidden, path_in_line, visible};

/// Exit statuses, the same for every command.
pub mod status {
    /// The answer is "no": a difference, stale text.
    pub const NO: u8 = 1;
    /// Bad input.
    pub const BAD_INPUT: u8 = 2;
    /// A run that could not go on.
    pub const STOPPED: u8 = 3;
    /// Somebody ended the command; what it had finished is kept.
    pub const INTERRUPTED: u8 = 130;
}

/// Why a command could not do its work.
#[derive(Debug)]
pub enum Failure {
    /// A refused request, or one that has no result, with the reason.
    Refused(Error),
    /// A file that could not be written.
    Output(String, std::io::Error),
    /// Somebody ended the command: what is kept, if anything is.
    Interrupted(String),
    /// The reader of standard output has gone.
    Hangup,
}

impl Failure {
    /// A request that makes no sense, and what to do instead.
    pub fn request(what: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Refused(Error::request(what, help))
    }

    /// The first line of the message.
    pub fn first_line(&self) -> String {
        self.said().0.lines().next().unwrap_or_default().to_owned()
    }

    /// The exit status.
    pub fn status(&self) -> u8 {
        match self {
            Self::Refused(Error::Stopped(_)) => status::STOPPED,
            Self::Refused(_) | Self::Output(..) => status::BAD_INPUT,
            Self::Interrupted(_) => status::INTERRUPTED,
            Self::Hangup => 0,
        }
    }

    /// A failure as programs read it: what is wrong, what to do, and every place in a file, with the exit status.
    pub fn json(&self) -> Value {
        let places = if let Self::Refused(error) = self { places(error.files()) } else { Vec::new() };
        let (message, help) = self.said();
        json!({ "error": { "message": message, "help": help, "places": places }, "exit_status": self.status() })
    }

    /// The message and the help. Of several errors the first is told.
    fn said(&self) -> (String, Option<String>) {
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
        match (self, self.said()) {
            (Self::Refused(error), _) => write!(f, "{error}"),
            (Self::Output(..), (what, Some(help))) => write!(f, "error: {what}\nhelp: {help}"),
            // No error: it was asked for.
            (_, (what, _)) => f.write_str(&what),
        }
    }
}

/// Every error of these files, with its place if it has one.
fn places(files: &[Diagnostics]) -> Vec<Value> {
    let of = |file: &Diagnostics| {
        let path = file.source.path.display().to_string();
        let place = |d: &Diagnostic| {
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
            WriteError::Appeared(..) => Self::request(what, "rename it to what you want to keep it as".to_owned()),
            WriteError::Busy(_) => Self::request(what, "wait for it, or give another file".to_owned()),
            // Nobody listens any more.
            WriteError::Io(_, error) if error.kind() == std::io::ErrorKind::BrokenPipe => Self::Hangup,
            WriteError::Io(path, error) => Self::Output(path_in_line(&path), error),
        }
    }
}

/// A warning on standard error; one that cannot be written is lost, as nothing is left to say so on.
pub fn warn(text: &str) {
    say(&format!("warning: {text}"));
}

/// A line on standard error, for people.
pub fn say(text: &str) {
    use std::io::Write;
    let _ = writeln!(std::io::stderr().lock(), "{}", visible(text));
}

/// Writes text for people to standard output; a closed pipe is not an error of ours.
pub fn print(text: &str) -> Result<(), Failure> {
    write_out(&visible(text))
}

/// Writes JSON to standard output, the version of its format first. Control characters and those that turn a line are
/// escaped, which JSON reads back as they were.
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

fn write_out(text: &str) -> Result<(), Failure> {
    use std::io::Write;
    let mut out = std::io::stdout().lock();
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(|error| match error.kind() {
        std::io::ErrorKind::BrokenPipe => Failure::Hangup,
        _ => Failure::Output("standard output".to_owned(), error),
    })
}
