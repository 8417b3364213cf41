//! Rust target: turns plans into Rust tokens, then into text by prettyplease. It decides only how a
//! line is written.

mod expression;
mod formulation;
mod jacobian_product;
mod library;
mod module;
mod names;
mod rust_function;
mod rust_text;
mod scene;
mod system_impl;
mod target;
mod taylor;
mod written_functions;

pub use formulation::{FormulationFiles, rust_formulation_files as formulation_files};
pub use library::generated_library_text;
pub use module::{ModuleEquations, ModuleHeaderData, rust_model_files as module_files};
pub use names::{LANGUAGE, is_name};
pub use scene::{SceneFile, SceneHeaderData, rust_scene_file as scene_file, rust_scene_list as scene_list};
pub(crate) use target::{RustModule, unsolved_equations_error};
pub use written_functions::WrittenFunctions;
