//! Thin disk sliding on a frictionless plane: the equations of its scenes.
//!
//! Generated from `models/disk/model.toml`. Do not edit; run `tripos regenerate`.

/// The code of the equations.
#[rustfmt::skip]
#[allow(non_snake_case, clippy::let_and_return)]
pub mod code;
#[rustfmt::skip]
pub mod flat_fall;
#[rustfmt::skip]
pub mod lean;
#[rustfmt::skip]
pub mod near_flat;
#[rustfmt::skip]
pub mod report_10s;
#[rustfmt::skip]
pub mod report_tight;
#[rustfmt::skip]
pub mod report;

/// The equations of every scene.
pub const SCENES: &[tripos_traits::CompiledScene] = &[
    flat_fall::SCENE, lean::SCENE, near_flat::SCENE, report_10s::SCENE, report_tight::SCENE,
    report::SCENE,
];
