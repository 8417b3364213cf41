//! Elastic pendulum: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/elastic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u', v').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by m, by x^2 + y^2.

pub use super::code::newton_euler::{NewtonEuler, derivative, divisors, jacobian_product};

pub use super::kane::{
    accelerations, coordinate_rates, forcing, kinetic_energy, potential_energy,
};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows bob force n1, bob force n2. Entries that are not listed are 0.
///
/// ```text
/// M11 = m
/// M22 = m
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;
