//! Symmetric rigid body free of forces: the equations of its scenes.
//!
//! Generated from `models/free_body/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod steady;
#[rustfmt::skip]
pub mod tumbling;

/// The equations of every scene.
pub const SCENES: &[tripos_traits::CompiledScene] = &[steady::SCENE, tumbling::SCENE];
