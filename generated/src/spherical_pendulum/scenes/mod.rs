//! Spherical pendulum: the equations of its scenes.
//!
//! Generated from `models/spherical_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod narrow;
#[rustfmt::skip]
pub mod wide;

/// The equations of every scene.
pub const SCENES: &[tripos_traits::CompiledScene] = &[narrow::SCENE, wide::SCENE];
