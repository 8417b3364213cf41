//! Gyroscope in gimbals: the code of the equations of its scenes.
//!
//! Generated from `models/gimbals/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod nutation;
