//! Equations to readable Rust, the same bytes for the same model text on every machine.
//!
//! The flow: [`tripos_derive::Equations`] → [`program::Program`] (ordered, shared, named) → tokens →
//! text through prettyplease → [`workspace::Generated`] files. Nothing here reads a clock, an
//! environment variable or a hash map's order.

pub mod emit;
pub mod files;
pub mod formulation;
mod function;
mod identifiers;
mod module;
mod origin;
pub mod program;
pub mod scene;
pub mod scene_files;
mod system;
pub mod taylor;
pub mod tokens;
pub mod workspace;

pub use workspace::{Difference, Freshness, Generated, freshness};
