//! Symmetric heavy top about a fixed point: the code of the equations of its scenes.
//!
//! Generated from `models/heavy_top/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod looping;
