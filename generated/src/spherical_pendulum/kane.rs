//! Spherical pendulum: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/spherical_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2').
//! The kinematic equations are singular where sin(theta) = 0.
//! The accelerations divide by sin(theta), by l.

pub use super::code::kane::{
    Kane, derivative, divisors, inverse_dynamics, jacobian_product,
};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1, u2. Entries that are not listed are 0.
///
/// ```text
/// M11 = m*l^2
/// M22 = m*l^2
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', u2').
///
/// ```text
/// f1 = m*l*(l*u2^2/tan(theta) - g*sin(theta))
/// f2 = -m*l^2*u1*u2/tan(theta)
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (u1', u2'), solved for when this code was generated.
///
/// ```text
/// u2' = -u1*u2/tan(theta)
/// u1' = u2^2/tan(theta) - g*sin(theta)/l
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// theta' = u1
/// phi' = u2/sin(theta)
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = m*l^2*u1^2/2 + m*l^2*u2^2/2
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = m*l*g*(1 - cos(theta))
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;
