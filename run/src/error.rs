//! Errors of model files, scene files and requests.

use std::fmt;
use tripos_derive::diagnostic::{Diagnostics, UnknownName};
use tripos_derive::plain::path_in_line;
use tripos_derive::scene::Scene;
use tripos_sim::SimError;

/// Error of a model, a scene or a request to them.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Error {
    /// A file with errors, each with its line and column.
    Input(Diagnostics),
    /// Several files with errors.
    Inputs(Vec<Diagnostics>),
    /// A formulation that the model does not have.
    Unsupported(Diagnostics),
    /// A request that is not possible, with advice.
    Request {
        /// Description of the mistake.
        what: String,
        /// Advice on the remedy.
        help: String,
    },
    /// A state or a run without a result, with the reason.
    Stopped(String),
    /// The caller asked to end the work early.
    Interrupted,
}

impl Error {
    /// Creates an error for a request that is not possible, with advice.
    pub fn request(what: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Request { what: what.into(), help: help.into() }
    }

    /// Message of the error, the first if there are several, and its advice; `None` without advice.
    #[must_use]
    pub fn what_and_help(&self) -> (String, Option<String>) {
        let of_first = |list: &[Diagnostics]| {
            let first = list.iter().find_map(|file| file.list.first());
            first.map_or_else(Default::default, |d| (d.message.clone(), d.help.clone()))
        };
        match self {
            Self::Input(file) | Self::Unsupported(file) => of_first(std::slice::from_ref(file)),
            Self::Inputs(files) => of_first(files),
            Self::Request { what, help } => (what.clone(), Some(help.clone())),
            Self::Stopped(why) => (why.clone(), None),
            Self::Interrupted => ("interrupted".to_owned(), None),
        }
    }

    /// First line of the error's message.
    #[must_use]
    pub fn first_line(&self) -> String {
        self.what_and_help().0.lines().next().unwrap_or_default().to_owned()
    }

    /// Diagnostics of the files with errors; empty for an error of another kind.
    #[must_use]
    pub fn files(&self) -> &[Diagnostics] {
        match self {
            Self::Input(file) | Self::Unsupported(file) => std::slice::from_ref(file),
            Self::Inputs(files) => files,
            _ => &[],
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Input(file) | Self::Unsupported(file) => write!(f, "{file}"),
            Self::Inputs(files) => {
                let texts: Vec<String> = files.iter().map(ToString::to_string).collect();
                f.write_str(&texts.join("\n\n"))
            }
            Self::Request { what, help } => write!(f, "error: {what}\nhelp: {help}"),
            Self::Stopped(why) => write!(f, "error: {why}"),
            Self::Interrupted => f.write_str("interrupted"),
        }
    }
}

impl std::error::Error for Error {}

impl From<Diagnostics> for Error {
    fn from(diagnostics: Diagnostics) -> Self {
        Self::Input(diagnostics)
    }
}

/// Error for a scene that the simulator refuses to run.
#[must_use]
pub fn refused(scene: &Scene, error: &SimError) -> Error {
    Error::request(error.to_string(), format!("check {}", path_in_line(&scene.source.path)))
}

impl From<UnknownName> for Error {
    fn from(error: UnknownName) -> Self {
        Self::Request { what: error.message, help: error.help }
    }
}
