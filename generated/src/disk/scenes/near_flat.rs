//! Thin disk sliding on a frictionless plane: Near flat: a ladder of passages.
//!
//! Generated from `models/disk/scenes/near-flat.toml`. Do not edit; run `tripos regenerate`.
//! It asks for what `flat_fall` asks for, with the same parameters, and has its equations.

pub use super::flat_fall::*;

/// What a program needs to find these equations and to trust them.
pub const SCENE: tripos_traits::CompiledScene = tripos_traits::CompiledScene {
    name: "near-flat",
    ..super::flat_fall::SCENE
};
