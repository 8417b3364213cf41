//! Pendulum: Large swings.
//!
//! Generated from `models/pendulum/scenes/swing.toml`. Do not edit; run `tripos regenerate`.
//! It asks for what `over` asks for, with the same parameters, and has its equations.

pub use super::over::*;

/// What a program needs to find these equations and to trust them.
pub const SCENE: tripos_traits::CompiledScene = tripos_traits::CompiledScene {
    name: "swing",
    ..super::over::SCENE
};
