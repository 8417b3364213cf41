//! Thin disk sliding on a frictionless plane: the code of the equations of its scenes.
//!
//! Generated from `models/disk/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod flat_fall;
#[rustfmt::skip]
pub mod lean;
