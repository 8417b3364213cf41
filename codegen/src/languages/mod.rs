//! Generated modules of equations in C, Python, MATLAB and CasADi.
//!
//! Derived equations give a [`ModulePlan`](crate::plan::ModulePlan), and the plan gives a [`Module`]. A [`Dialect`]
//! writes the module's files. All dialects write functions with the same names, arguments and orders of entries.

pub mod c;
pub mod casadi;
mod composite;
pub mod description;
mod dialect;
mod language_target;
pub mod matlab;
mod module_contents;
pub mod python;
mod scene_run;

pub use composite::CompositeFunction;
pub use dialect::Dialect;
pub use language_target::{LanguageEmission, Selection, emit_language_modules};
pub use module_contents::Module;
pub(crate) use module_contents::module_identifier_word;
pub use scene_run::SceneRun;
