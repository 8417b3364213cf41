//! Andrews' squeezing mechanism: the code of the equations.
//!
//! Generated from `models/squeezer/model.toml`. Do not edit; run `tripos regenerate`.

/// Kane's method.
#[rustfmt::skip]
pub mod kane;

/// Lagrange's equations.
#[rustfmt::skip]
pub mod lagrange;

/// Newton–Euler equations.
#[rustfmt::skip]
pub mod newton_euler;

/// Kane's method in phi-90°.
#[rustfmt::skip]
pub mod kane_phi_90deg;

/// Kane's method in omega-90°.
#[rustfmt::skip]
pub mod kane_omega_90deg;

/// Lagrange's equations in phi-90°.
#[rustfmt::skip]
pub mod lagrange_phi_90deg;

/// Lagrange's equations in omega-90°.
#[rustfmt::skip]
pub mod lagrange_omega_90deg;

/// Newton–Euler equations in phi-90°.
#[rustfmt::skip]
pub mod newton_euler_phi_90deg;

/// Newton–Euler equations in omega-90°.
#[rustfmt::skip]
pub mod newton_euler_omega_90deg;
