//! Rust target: turns plans into Rust tokens, and tokens into text by prettyplease. It decides only the form of a
//! line, not the computation.

mod expression;
mod formulation;
mod jacobian_product;
mod library;
mod module;
mod names;
mod rust_function;
mod rust_target;
mod rust_text;
mod scene;
mod sorted_functions;
mod system_methods;
mod taylor;

pub use formulation::{FormulationFiles, rust_formulation_files as formulation_files};
pub use library::generated_library_text;
pub use module::{ModuleEquations, ModuleHeaderData, rust_module_files as module_files};
pub use names::{LANGUAGE, is_name};
pub(crate) use rust_target::RustTarget;
pub use scene::{SceneFile, SceneHeaderData, rust_scene_file as scene_file, rust_scene_module_files as scene_list};
pub use sorted_functions::WrittenFunctions;
