//! Chain of three rods floating in a plane: the code of the equations of its scenes.
//!
//! Generated from `models/floating_chain/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod folding;
