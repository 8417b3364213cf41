//! Thin disc rolling on a plane: the equations of its scenes.
//!
//! Generated from `models/rolling_disc/model.toml`. Do not edit; run `tripos regenerate`.

/// The code of the equations.
#[rustfmt::skip]
#[allow(non_snake_case, clippy::let_and_return)]
pub mod code;
#[rustfmt::skip]
pub mod roll;
#[rustfmt::skip]
pub mod steady_turn;

/// The equations of every scene.
pub const SCENES: &[tripos_traits::CompiledScene] = &[roll::SCENE, steady_turn::SCENE];
