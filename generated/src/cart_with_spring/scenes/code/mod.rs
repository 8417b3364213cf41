//! Cart with spring: the code of the equations of its scenes.
//!
//! Generated from `models/cart_with_spring/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod released;
