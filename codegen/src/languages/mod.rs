//! Generated modules of equations in C, Python, MATLAB and CasADi.
//!
//! The flow: derived equations → a [`ModulePlan`](crate::plan::ModulePlan) → a [`Module`] → the
//! files of a [`Dialect`]. All dialects write functions with the same names, arguments and orders
//! of entries.

pub mod c;
pub mod casadi;
mod composite;
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
