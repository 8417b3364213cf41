//! Symmetric heavy top about a fixed point: the equations of its scenes.
//!
//! Generated from `models/heavy_top/model.toml`. Do not edit; run `tripos regenerate`.

/// The code of the equations.
#[rustfmt::skip]
#[allow(non_snake_case, clippy::let_and_return)]
pub mod code;
#[rustfmt::skip]
pub mod looping;
#[rustfmt::skip]
pub mod sleeping;
#[rustfmt::skip]
pub mod waking;

/// The equations of every scene.
pub const SCENES: &[tripos_traits::CompiledScene] = &[
    looping::SCENE, sleeping::SCENE, waking::SCENE,
];
