//! Symmetric heavy top about a fixed point: the equations of its scenes.
//!
//! Generated from `models/heavy_top/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod looping;
#[rustfmt::skip]
pub mod sleeping;
#[rustfmt::skip]
pub mod waking;

/// The equations of every scene.
pub const SCENES: &[tripos_traits::CompiledScene] = &[
    looping::SCENE,
    sleeping::SCENE,
    waking::SCENE,
];
