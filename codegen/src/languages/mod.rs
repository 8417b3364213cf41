//! Generated modules of equations in C, Python, MATLAB and CasADi.
//!
//! The flow: derived equations → a [`ModulePlan`](crate::plan::ModulePlan) → a [`Module`] → the
//! files of a [`Dialect`]. All dialects write functions with the same names, arguments and orders
//! of entries.

pub mod c;
pub mod casadi;
mod composite;
mod language_target;
pub mod matlab;
mod module_contents;
pub mod python;
mod scene_run;

pub use composite::CompositeFunction;
pub(crate) use language_target::model_name_of_origin;
pub use language_target::{LanguageEmission, Selection, emit_language_modules};
pub use module_contents::Module;
pub(crate) use module_contents::module_identifier_word;
pub use scene_run::SceneRun;

use crate::plan::Language;

/// Language in which modules of equations are written: C, Python, MATLAB or CasADi.
pub trait Dialect {
    /// Returns the rules for names of variables in this language.
    fn language(&self) -> &'static Language;

    /// Returns the subcommand of `tripos` that writes the files, as their headers state it. Each
    /// dialect has a different command, so that modules of a model in several languages can share a
    /// folder.
    fn command(&self) -> &'static str;

    /// Returns the file name extensions that this language uses, without dots.
    fn extensions(&self) -> &'static [&'static str];

    /// Returns the name of the file that a program imports or includes to use a module. `model` and
    /// `equations` are words.
    fn main_file(&self, model: &str, equations: &str) -> String;

    /// Writes the files of one module. Returns their names and texts.
    fn files(&self, module: &Module<'_>) -> Vec<(String, String)>;

    /// Writes the files that are the same for every model, such as helpers. Returns their names and
    /// texts. `origin` is a sentence for their headers.
    fn shared_files(&self, origin: &str) -> Vec<(String, String)>;

    /// Writes a script that runs a scene by the functions of a module. Returns its name and text;
    /// `None` if this language has no script.
    fn script(&self, _module: &Module<'_>, _run: &SceneRun) -> Option<(String, String)> {
        None
    }

    /// Lists the functions that modules can contain in addition to the planned functions, and that
    /// call these.
    fn composites(&self) -> &'static [CompositeFunction];
}
