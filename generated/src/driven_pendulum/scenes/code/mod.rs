//! Pendulum on a driven pivot: the code of the equations of its scenes.
//!
//! Generated from `models/driven_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod falling;
