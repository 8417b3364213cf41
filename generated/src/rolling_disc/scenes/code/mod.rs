//! Thin disc rolling on a plane: the code of the equations of its scenes.
//!
//! Generated from `models/rolling_disc/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod roll;
