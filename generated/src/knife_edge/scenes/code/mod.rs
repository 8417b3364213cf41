//! Knife edge on an incline: the code of the equations of its scenes.
//!
//! Generated from `models/knife_edge/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod cycloid;
