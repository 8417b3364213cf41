//! Thin disc rolling on a plane: A steady turn, which is not stable.
//!
//! Generated from `models/rolling_disc/scenes/steady-turn.toml`. Do not edit; run `tripos regenerate`.
//! It asks for what `roll` asks for, with the same parameters, and has its equations.

pub use super::roll::*;

/// What a program needs to find these equations and to trust them.
pub const SCENE: tripos_traits::CompiledScene = tripos_traits::CompiledScene {
    name: "steady-turn",
    ..super::roll::SCENE
};
