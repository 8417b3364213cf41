//! Symmetric rigid body free of forces: Tumbling.
//!
//! Generated from `models/free_body/scenes/tumbling.toml`. Do not edit; run `tripos regenerate`.
//! It asks for what `steady` asks for, with the same parameters, and has its equations.

pub use super::steady::*;

/// What a program needs to find these equations and to trust them.
pub const SCENE: tripos_traits::CompiledScene = tripos_traits::CompiledScene {
    name: "tumbling",
    ..super::steady::SCENE
};
