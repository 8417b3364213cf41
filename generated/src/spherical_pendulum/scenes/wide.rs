//! Spherical pendulum: A wide swing.
//!
//! Generated from `models/spherical_pendulum/scenes/wide.toml`. Do not edit; run `tripos regenerate`.
//! It asks for what `narrow` asks for, with the same parameters, and has its equations.

pub use super::narrow::*;

/// What a program needs to find these equations and to trust them.
pub const SCENE: tripos_traits::CompiledScene = tripos_traits::CompiledScene {
    name: "wide",
    ..super::narrow::SCENE
};
