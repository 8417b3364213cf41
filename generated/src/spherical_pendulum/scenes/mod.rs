//! Spherical pendulum: the equations of its scenes.
//!
//! Generated from `models/spherical_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

/// The code of the equations.
#[rustfmt::skip]
#[allow(non_snake_case, clippy::let_and_return)]
pub mod code;
#[rustfmt::skip]
pub mod narrow;
#[rustfmt::skip]
pub mod wide;

/// The equations of every scene.
pub const SCENES: &[tripos_traits::CompiledScene] = &[narrow::SCENE, wide::SCENE];
