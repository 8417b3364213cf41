//! Chain of three rods floating in a plane: Straight and turning.
//!
//! Generated from `models/floating_chain/scenes/straight.toml`. Do not edit; run `tripos regenerate`.
//! It asks for what `folding` asks for, with the same parameters, and has its equations.

pub use super::folding::*;

/// What a program needs to find these equations and to trust them.
pub const SCENE: tripos_traits::CompiledScene = tripos_traits::CompiledScene {
    name: "straight",
    ..super::folding::SCENE
};
