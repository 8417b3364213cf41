//! Thin disc rolling on a plane: the code of the equations.
//!
//! Generated from `models/rolling_disc/model.toml`. Do not edit; run `tripos regenerate`.

/// Kane's method.
#[rustfmt::skip]
pub mod kane;

/// Lagrange's equations.
#[rustfmt::skip]
pub mod lagrange;

/// Newton–Euler equations.
#[rustfmt::skip]
pub mod newton_euler;

/// Kane's method in q2-90°.
#[rustfmt::skip]
pub mod kane_q2_90deg;

/// Lagrange's equations in q2-90°.
#[rustfmt::skip]
pub mod lagrange_q2_90deg;

/// Newton–Euler equations in q2-90°.
#[rustfmt::skip]
pub mod newton_euler_q2_90deg;
