//! Symmetric rigid body free of forces: the equations of its scenes.
//!
//! Generated from `models/free_body/model.toml`. Do not edit; run `tripos regenerate`.

/// The code of the equations.
#[rustfmt::skip]
#[allow(non_snake_case, clippy::let_and_return)]
pub mod code;
#[rustfmt::skip]
pub mod steady;
#[rustfmt::skip]
pub mod tumbling;

/// The equations of every scene.
pub const SCENES: &[tripos_traits::CompiledScene] = &[steady::SCENE, tumbling::SCENE];
