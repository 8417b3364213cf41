//! Pendulum: the equations of its scenes.
//!
//! Generated from `models/pendulum/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod over;
#[rustfmt::skip]
pub mod swing;

/// The equations of every scene.
pub const SCENES: &[tripos_traits::CompiledScene] = &[over::SCENE, swing::SCENE];
