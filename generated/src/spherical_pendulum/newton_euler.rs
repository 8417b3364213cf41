//! Spherical pendulum: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/spherical_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', rod).
//! The kinematic equations are singular where sin(theta) = 0.
//! The accelerations divide by sin(theta), by l.

pub use super::code::newton_euler::{NewtonEuler, derivative, divisors, jacobian_product};

pub use super::kane::{accelerations, coordinate_rates, kinetic_energy, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows bob force n1, bob force n2, bob force n3. Entries that are not listed are 0.
///
/// ```text
/// M11 = m*l*cos(theta)*cos(phi)
/// M12 = -m*l*sin(phi)
/// M13 = sin(theta)*cos(phi)
/// M21 = m*l*cos(theta)*sin(phi)
/// M22 = m*l*cos(phi)
/// M23 = sin(theta)*sin(phi)
/// M31 = m*l*sin(theta)
/// M33 = -cos(theta)
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', u2', rod).
///
/// ```text
/// f1 = m*l*(u2^2*cos(phi)/sin(theta) + u1*(u1*sin(theta)*cos(phi) + u2*sin(phi)/tan(theta)))
/// f2 = m*l*(u2^2*sin(phi)/sin(theta) + u1*(u1*sin(theta)*sin(phi) - u2*cos(phi)/tan(theta)))
/// f3 = -m*(g + l*u1^2*cos(theta))
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;
