//! Symmetric heavy top about a fixed point: Awake.
//!
//! Generated from `models/heavy_top/scenes/waking.toml`. Do not edit; run `tripos regenerate`.
//! It asks for what `looping` asks for, with the same parameters, and has its equations.

pub use super::looping::*;

/// What a program needs to find these equations and to trust them.
pub const SCENE: tripos_traits::CompiledScene = tripos_traits::CompiledScene {
    name: "waking",
    ..super::looping::SCENE
};
