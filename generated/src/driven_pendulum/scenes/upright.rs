//! Pendulum on a driven pivot: Upright, and it stays.
//!
//! Generated from `models/driven_pendulum/scenes/upright.toml`. Do not edit; run `tripos regenerate`.
//! It asks for what `falling` asks for, with the same parameters, and has its equations.

pub use super::falling::*;

/// What a program needs to find these equations and to trust them.
pub const SCENE: tripos_traits::CompiledScene = tripos_traits::CompiledScene {
    name: "upright",
    ..super::falling::SCENE
};
