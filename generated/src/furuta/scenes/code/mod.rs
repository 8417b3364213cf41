//! Furuta pendulum: the code of the equations of its scenes.
//!
//! Generated from `models/furuta/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod swing;
