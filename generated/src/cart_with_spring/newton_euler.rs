//! Cart with spring: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/cart_with_spring/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (v').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by x, by m.

pub use super::code::newton_euler::{NewtonEuler, derivative, divisors, jacobian_product};

pub use super::kane::{
    accelerations, coordinate_rates, forcing, kinetic_energy, potential_energy, power,
};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows cart force n1.
///
/// ```text
/// M11 = m
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;
