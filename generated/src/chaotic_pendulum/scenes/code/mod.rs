//! Chaotic pendulum: a swinging rod with a plate turning about it: the code of the equations of its scenes.
//!
//! Generated from `models/chaotic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod swing;
