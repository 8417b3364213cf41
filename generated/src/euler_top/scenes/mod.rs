//! Symmetric heavy top in Euler's angles: the equations of its scenes.
//!
//! Generated from `models/euler_top/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod cusps;
#[rustfmt::skip]
pub mod looping;

/// The equations of every scene.
pub const SCENES: &[tripos_traits::CompiledScene] = &[cusps::SCENE, looping::SCENE];
