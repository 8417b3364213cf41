//! Trait of the languages in which modules of equations are written.

use super::{CompositeFunction, Module, SceneRun};
use crate::plan::Language;

/// Language in which modules of equations are written: C, Python, MATLAB or CasADi.
pub trait Dialect {
    /// Returns the rules for names of variables in this language.
    fn language(&self) -> &'static Language;

    /// Returns the subcommand of `tripos` that writes the files, as their headers state it. Each dialect has a
    /// different subcommand, so that modules of a model in several languages can share a folder.
    fn command(&self) -> &'static str;

    /// Returns the file name extensions that this language uses, without dots.
    fn extensions(&self) -> &'static [&'static str];

    /// Returns the name of the file that a program imports or includes to use a module. `model` and `equations` are
    /// the words for the model and its equations in file names.
    fn main_file(&self, model: &str, equations: &str) -> String;

    /// Returns the files of one module, each as (name, text).
    fn files(&self, module: &Module<'_>) -> Vec<(String, String)>;

    /// Returns the names of all files that a module can have besides those that every module has: the files of single
    /// functions and scripts. `model` and `equations` are the words for the model and the equations in file names.
    fn possible_files(&self, _model: &str, _equations: &str) -> Vec<String> {
        Vec::new()
    }

    /// Returns the files that are the same for every model, such as helpers, each as (name, text). `origin` is a
    /// sentence for their headers.
    fn shared_files(&self, origin: &str) -> Vec<(String, String)>;

    /// Returns a script that runs a scene by the functions of a module, as (name, text). `None` if the language has
    /// no such script.
    fn script(&self, _module: &Module<'_>, _run: &SceneRun) -> Option<(String, String)> {
        None
    }

    /// Functions that modules can contain in addition to the planned functions, which they call.
    fn composites(&self) -> &'static [CompositeFunction];
}
