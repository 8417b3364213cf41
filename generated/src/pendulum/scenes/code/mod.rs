//! Pendulum: the code of the equations of its scenes.
//!
//! Generated from `models/pendulum/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod over;
