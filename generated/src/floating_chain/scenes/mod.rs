//! Chain of three rods floating in a plane: the equations of its scenes.
//!
//! Generated from `models/floating_chain/model.toml`. Do not edit; run `tripos regenerate`.

/// The code of the equations.
#[rustfmt::skip]
#[allow(non_snake_case, clippy::let_and_return)]
pub mod code;
#[rustfmt::skip]
pub mod folding;
#[rustfmt::skip]
pub mod straight;

/// The equations of every scene.
pub const SCENES: &[tripos_traits::CompiledScene] = &[folding::SCENE, straight::SCENE];
