//! Plans as Rust: tokens, then text through prettyplease. Nothing is computed or decided here but how a line is written.

mod expression;
mod formulation;
mod function;
mod library;
mod module;
mod names;
mod scene;
mod system;
mod taylor;
mod text;

pub use formulation::file as formulation_file;
pub use library::library;
pub use module::{Entry, file as module_file};
pub use names::{LANGUAGE, is_name};
pub use scene::{Named, SceneFile, file as scene_file, list as scene_list};
