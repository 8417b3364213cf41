//! Chaotic pendulum: a swinging rod with a plate turning about it: the equations of its scenes.
//!
//! Generated from `models/chaotic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod swing;

/// The equations of every scene.
pub const SCENES: &[tripos_traits::CompiledScene] = &[swing::SCENE];
