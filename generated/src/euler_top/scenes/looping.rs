//! Symmetric heavy top in Euler's angles: Looping.
//!
//! Generated from `models/euler_top/scenes/looping.toml`. Do not edit; run `tripos regenerate`.
//! It asks for what `cusps` asks for, with the same parameters, and has its equations.

pub use super::cusps::*;

/// What a program needs to find these equations and to trust them.
pub const SCENE: tripos_traits::CompiledScene = tripos_traits::CompiledScene {
    name: "looping",
    ..super::cusps::SCENE
};
