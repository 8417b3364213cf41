//! Pendulum on a driven pivot: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/driven_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u', rod).
//! The kinematic equations are singular nowhere.
//! The accelerations divide by l.

pub use super::code::newton_euler::{NewtonEuler, derivative, jacobian_product};

pub use super::kane::{accelerations, coordinate_rates, kinetic_energy, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows bob force n1, bob force n2.
///
/// ```text
/// M11 = m*l*cos(q)
/// M12 = sin(q)
/// M21 = m*l*sin(q)
/// M22 = -cos(q)
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (u', rod).
///
/// ```text
/// f1 = m*l*u^2*sin(q)
/// f2 = m*(a*w^2*sin(w*t) - g - l*u^2*cos(q))
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;
