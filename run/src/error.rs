//! Errors of model files, of scene files, and of requests to models or scenes.

use std::fmt;
use tripos_derive::diagnostic::{Diagnostics, UnknownName};
use tripos_derive::plain_text::message_text;
use tripos_derive::plain_text::path_as_plain_text;
use tripos_derive::scene::Scene;
use tripos_sim::SimError;

/// Error of the library: a faulty file, an impossible request, or a run that stopped.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum Error {
    /// One file has errors. Each error has its line and column.
    Input(Diagnostics),
    /// Several files have errors. Each error has its line and column.
    Inputs(Vec<Diagnostics>),
    /// The model does not support the requested formulation. The diagnostics give the reason.
    Unsupported(Diagnostics),
    /// The request is impossible, such as an unknown name or a forbidden setting.
    Request {
        /// Description of the mistake in the request.
        what: String,
        /// Advice on how to correct the request.
        help: String,
    },
    /// A computation or a run stopped without a result. The text gives the reason.
    Stopped(String),
    /// The caller ended the work early.
    Interrupted,
}

impl Error {
    /// Makes an `Error::Request` from a description of the mistake and advice.
    pub fn request(what: impl Into<String>, help: impl Into<String>) -> Self {
        Self::Request { what: message_text(&what.into()), help: message_text(&help.into()) }
    }

    /// Returns the message of the first error, and its advice. The advice is `None` if there is none.
    #[must_use]
    pub fn message_and_advice(&self) -> (String, Option<String>) {
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

    /// First line of the message of this error.
    #[must_use]
    pub fn first_line(&self) -> String {
        self.message_and_advice().0.lines().next().unwrap_or_default().to_owned()
    }

    /// Diagnostics of the files that have errors, one for each file. Empty if the error is about no file.
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

/// Makes the error for a scene that the simulator refuses to run. It has the simulator's message, and the
/// advice to check the scene file.
#[must_use]
pub fn refused_scene_error(scene: &Scene, error: &SimError) -> Error {
    Error::request(error.to_string(), format!("check {}", path_as_plain_text(&scene.source.path)))
}

impl From<UnknownName> for Error {
    fn from(error: UnknownName) -> Self {
        Self::Request { what: error.message, help: error.help }
    }
}
