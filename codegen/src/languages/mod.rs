//! Modules of equations in C, Python, MATLAB and CasADi.
//!
//! The flow: derived equations → a [`ModulePlan`](crate::plan::ModulePlan) → a [`Module`] → the files of a [`Dialect`].
//! All dialects write the same functions, with the same names, arguments and orders of entries.

pub mod c;
pub mod casadi;
mod composite;
pub mod matlab;
mod module;
pub mod python;
mod scene_run;
mod target;

pub use composite::Composite;
pub use module::Module;
pub(crate) use module::word;
pub use scene_run::SceneRun;
pub(crate) use target::stem_of;
pub use target::{Emitted, Selection, emit_model};

use crate::plan::Language;

/// Language in which modules of equations are written.
pub trait Dialect {
    /// Rules for the names of variables.
    fn language(&self) -> &'static Language;

    /// Command of `tripos` that writes the files, as their headers state it. No two dialects have the same, so that
    /// modules of one model in several languages share a folder.
    fn command(&self) -> &'static str;

    /// Extensions of the names of the files.
    fn extensions(&self) -> &'static [&'static str];

    /// Name of the file by which a program uses the equations of a module. `model` and `equations` are words.
    fn main_file(&self, model: &str, equations: &str) -> String;

    /// Files of one module, by name.
    fn files(&self, module: &Module<'_>) -> Vec<(String, String)>;

    /// Files that are the same for every model, by name. `origin` is a sentence of their headers.
    fn shared_files(&self, origin: &str) -> Vec<(String, String)>;

    /// Script that runs a scene by the functions of a module, with its name; `None` if the dialect has none.
    fn script(&self, _module: &Module<'_>, _run: &SceneRun) -> Option<(String, String)> {
        None
    }

    /// Functions that modules contain beside the planned ones.
    fn composites(&self) -> &'static [Composite];
}
