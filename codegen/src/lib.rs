//! Readable code generated from equations of motion. Equal model text gives equal bytes on every machine.
//!
//! [`tripos_derive::Equations`] become a plan of functions ([`plan`], [`taylor`]), which is independent of languages.
//! From the plan, a target (`rust`, `js`, `languages`, each behind the feature of its name) writes text. The text
//! becomes files (`workspace`, `emit`). The recurrences of [`taylor`] can also be interpreted. No code here reads a
//! clock, an environment variable or the order of a hash map.

// The examples of the README are compiled and run as tests.
#![cfg_attr(all(doctest, feature = "rust"), doc = include_str!("../README.md"))]

#[cfg(feature = "files")]
pub mod draft_file;
#[cfg(any(feature = "rust", feature = "js", feature = "languages"))]
pub mod emit;
#[cfg(feature = "languages")]
pub mod fmu;
#[cfg(feature = "rust")]
pub mod generated_workspace;
#[cfg(feature = "js")]
pub mod js;
#[cfg(feature = "languages")]
pub mod languages;
#[cfg(any(feature = "rust", feature = "js", feature = "languages"))]
mod lines;
#[cfg(feature = "files")]
pub mod model_folders;
#[cfg(feature = "rust")]
mod optional_functions;
#[cfg(any(feature = "rust", feature = "js", feature = "languages"))]
mod origin;
pub mod plan;
#[cfg(feature = "rust")]
pub mod rust;
#[cfg(any(feature = "js", feature = "languages"))]
pub mod syntax;
#[cfg(any(feature = "rust", feature = "js", feature = "languages"))]
pub mod target;
pub mod taylor;

#[cfg(feature = "rust")]
pub use generated_workspace::{Freshness, GeneratedFileDifference, GeneratedFiles, freshness};
#[cfg(feature = "rust")]
pub use optional_functions::Extras;
