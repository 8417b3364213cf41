//! How a command ends when it does not end well.

use std::fmt;
use tripos_derive::diagnostic::Diagnostics;
use tripos_derive::plain::{is_forbidden, visible};

/// Exit statuses, the same for every command.
pub mod status {
    /// The answer is "no": a difference, stale text.
    pub const NO: u8 = 1;
    /// Bad input.
    pub const BAD_INPUT: u8 = 2;
    /// A run that could not go on.
    pub const STOPPED: u8 = 3;
}

/// Why a command could not do its work.
#[derive(Debug)]
pub enum Failure {
    /// A file with errors.
    Input(Diagnostics),
    /// A formulation that this model does not have.
    Unsupported(Diagnostics),
    /// Several files with errors.
    Inputs(Vec<Diagnostics>),
    /// A wrong request: what, and what to do.
    Request(String, String),
    /// A file that could not be written.
    Output(String, std::io::Error),
    /// A state or run that has no answer.
    Stopped(String),
    /// The reader of standard output has gone.
    Hangup,
}

impl Failure {
    /// What went wrong, in a line.
    pub fn first_line(&self) -> String {
        self.to_string().lines().next().unwrap_or_default().trim_start_matches("error: ").to_owned()
    }

    /// The exit status.
    pub fn status(&self) -> u8 {
        match self {
            Self::Input(_) | Self::Unsupported(_) | Self::Inputs(_) | Self::Request(..) | Self::Output(..) => {
                status::BAD_INPUT
            }
            Self::Stopped(_) => status::STOPPED,
            Self::Hangup => 0,
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(diagnostics) | Self::Unsupported(diagnostics) => write!(f, "{diagnostics}"),
            Self::Inputs(list) => {
                let texts: Vec<String> = list.iter().map(ToString::to_string).collect();
                f.write_str(&texts.join("\n\n"))
            }
            Self::Request(what, help) => write!(f, "error: {what}\nhelp: {help}"),
            Self::Output(path, error) => {
                write!(f, "error: cannot write `{path}`: {error}\nhelp: give a path that can be written")
            }
            Self::Stopped(why) => write!(f, "error: {why}"),
            Self::Hangup => Ok(()),
        }
    }
}

impl From<Diagnostics> for Failure {
    fn from(diagnostics: Diagnostics) -> Self {
        Self::Input(diagnostics)
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

/// Writes JSON to standard output. What steers a terminal or turns a line is escaped, which JSON reads back as it was.
pub fn print_json(value: &serde_json::Value) -> Result<(), Failure> {
    let mut out = String::new();
    for c in format!("{value:#}\n").chars() {
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
