//! Thin disk sliding on a frictionless plane: the code of the equations.
//!
//! Generated from `models/disk/model.toml`. Do not edit; run `tripos regenerate`.

/// Kane's method.
#[rustfmt::skip]
pub mod kane;

/// Lagrange's equations.
#[rustfmt::skip]
pub mod lagrange;

/// Newton–Euler equations.
#[rustfmt::skip]
pub mod newton_euler;

/// Kane's method as printed (kane-final).
#[rustfmt::skip]
pub mod printed_kane_final;

/// Lagrange's equations as printed (lagrange-final).
#[rustfmt::skip]
pub mod printed_lagrange_final;

/// Newton–Euler equations as printed (newton-euler-final).
#[rustfmt::skip]
pub mod printed_newton_euler_final;

/// Kane's method as printed (listing-5.4).
#[rustfmt::skip]
pub mod printed_listing_5_4;

/// Lagrange's equations as printed (listing-5.5).
#[rustfmt::skip]
pub mod printed_listing_5_5;

/// Newton–Euler equations as printed (listing-5.6).
#[rustfmt::skip]
pub mod printed_listing_5_6;

/// Kane's method in q2-90°.
#[rustfmt::skip]
pub mod kane_q2_90deg;

/// Lagrange's equations in q2-90°.
#[rustfmt::skip]
pub mod lagrange_q2_90deg;

/// Newton–Euler equations in q2-90°.
#[rustfmt::skip]
pub mod newton_euler_q2_90deg;
