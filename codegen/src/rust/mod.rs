//! Rust target: turns plans into Rust tokens, then into text by prettyplease. It decides only how a
//! line is written.

mod expression;
mod formulation;
mod function;
mod library;
mod module;
mod names;
mod scene;
mod slopes;
mod system;
mod target;
mod taylor;
mod text;
mod written_functions;

pub use formulation::{FormulationFiles, files as formulation_files};
pub use library::library;
pub use module::{About, Entry, files as module_files};
pub use names::{LANGUAGE, is_name};
pub use scene::{Named, SceneFile, file as scene_file, list as scene_list};
pub(crate) use target::{RustModule, unsolved};
pub use written_functions::Written;
