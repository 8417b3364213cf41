//! How a command ends when it does not end well.

use std::fmt;
use tripos_codegen::files::WriteError;
use tripos_derive::diagnostic::Diagnostics;

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
    /// A file with errors.
    Input(Diagnostics),
    /// Several files with errors.
    Inputs(Vec<Diagnostics>),
    /// A wrong request: what, and what to do.
    Request(String, String),
    /// A file that could not be written.
    Output(String, std::io::Error),
    /// A state or run that has no answer.
    Stopped(String),
    /// Somebody ended the command: what is kept, if anything is.
    Interrupted(String),
    /// The reader of standard output has gone.
    Hangup,
}

impl Failure {
    /// The exit status.
    pub fn status(&self) -> u8 {
        match self {
            Self::Input(_) | Self::Inputs(_) | Self::Request(..) | Self::Output(..) => status::BAD_INPUT,
            Self::Stopped(_) => status::STOPPED,
            Self::Interrupted(_) => status::INTERRUPTED,
            Self::Hangup => 0,
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(diagnostics) => write!(f, "{diagnostics}"),
            Self::Inputs(list) => {
                let texts: Vec<String> = list.iter().map(ToString::to_string).collect();
                f.write_str(&texts.join("\n\n"))
            }
            Self::Request(what, help) => write!(f, "error: {what}\nhelp: {help}"),
            Self::Output(path, error) => {
                write!(f, "error: cannot write `{path}`: {error}\nhelp: give a path that can be written")
            }
            Self::Stopped(why) => write!(f, "error: {why}"),
            Self::Interrupted(kept) if kept.is_empty() => {
                f.write_str("interrupted before there was anything to keep: nothing is written")
            }
            Self::Interrupted(kept) => write!(f, "interrupted: {kept}"),
            Self::Hangup => Ok(()),
        }
    }
}

impl From<Diagnostics> for Failure {
    fn from(diagnostics: Diagnostics) -> Self {
        Self::Input(diagnostics)
    }
}

impl From<WriteError> for Failure {
    fn from(error: WriteError) -> Self {
        let what = error.to_string();
        match error {
            WriteError::There(_) => {
                Self::Request(what, "give another file, or --overwrite to replace this one".to_owned())
            }
            WriteError::Appeared(..) => Self::Request(what, "rename it to what you want to keep it as".to_owned()),
            WriteError::Busy(_) => Self::Request(what, "wait for it, or give another file".to_owned()),
            // Nobody listens any more.
            WriteError::Io(_, error) if error.kind() == std::io::ErrorKind::BrokenPipe => Self::Hangup,
            WriteError::Io(path, error) => Self::Output(path.display().to_string(), error),
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
    let _ = writeln!(std::io::stderr().lock(), "{text}");
}

/// Writes to standard output; a closed pipe is not an error of ours.
pub fn print(text: &str) -> Result<(), Failure> {
    use std::io::Write;
    let mut out = std::io::stdout().lock();
    out.write_all(text.as_bytes()).and_then(|()| out.flush()).map_err(|error| match error.kind() {
        std::io::ErrorKind::BrokenPipe => Failure::Hangup,
        _ => Failure::Output("standard output".to_owned(), error),
    })
}
