//! Furuta pendulum: the equations of its scenes.
//!
//! Generated from `models/furuta/model.toml`. Do not edit; run `tripos regenerate`.

/// The code of the equations.
#[rustfmt::skip]
#[allow(non_snake_case, clippy::let_and_return)]
pub mod code;
#[rustfmt::skip]
pub mod swing;

/// The equations of every scene.
pub const SCENES: &[tripos_traits::CompiledScene] = &[swing::SCENE];
