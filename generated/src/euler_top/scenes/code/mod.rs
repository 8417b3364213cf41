//! Symmetric heavy top in Euler's angles: the code of the equations of its scenes.
//!
//! Generated from `models/euler_top/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod cusps;
