//! Elastic pendulum: the code of the equations of its scenes.
//!
//! Generated from `models/elastic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod bouncing;
