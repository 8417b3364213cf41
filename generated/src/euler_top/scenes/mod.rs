//! Symmetric heavy top in Euler's angles: the equations of its scenes.
//!
//! Generated from `models/euler_top/model.toml`. Do not edit; run `tripos regenerate`.

/// The code of the equations.
#[rustfmt::skip]
#[allow(non_snake_case, clippy::let_and_return)]
pub mod code;
#[rustfmt::skip]
pub mod cusps;
#[rustfmt::skip]
pub mod looping;

/// The equations of every scene.
pub const SCENES: &[tripos_traits::CompiledScene] = &[cusps::SCENE, looping::SCENE];
