//! Three-link pendulum on a cart: the code of the equations of its scenes.
//!
//! Generated from `models/cart_pendulum_3/model.toml`. Do not edit; run `tripos regenerate`.

#[rustfmt::skip]
pub mod fall;
