//! Pendulum in Cartesian coordinates: the code of the equations.
//!
//! Generated from `models/cartesian_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

/// Kane's method.
#[rustfmt::skip]
pub mod kane;

/// Lagrange's equations.
#[rustfmt::skip]
pub mod lagrange;

/// Newton–Euler equations.
#[rustfmt::skip]
pub mod newton_euler;
