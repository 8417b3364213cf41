//! Thin disk sliding on a frictionless plane: The report's simulation, to t = 10 s.
//!
//! Generated from `models/disk/scenes/report-10s.toml`. Do not edit; run `tripos regenerate`.
//! It asks for what `flat_fall` asks for, with the same parameters, and has its equations.

pub use super::flat_fall::*;

/// What a program needs to find these equations and to trust them.
pub const SCENE: tripos_traits::CompiledScene = tripos_traits::CompiledScene {
    name: "report-10s",
    ..super::flat_fall::SCENE
};
