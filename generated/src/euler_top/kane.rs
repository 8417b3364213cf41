//! Symmetric heavy top in Euler's angles: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/euler_top/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', u3').
//! The kinematic equations are singular where sin(theta) = 0.
//! The accelerations divide by sin(theta), by I1.

pub use super::code::kane::{
    Kane, derivative, divisors, inverse_dynamics, jacobian_product,
};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1, u2, u3. Entries that are not listed are 0.
///
/// ```text
/// M11 = I1
/// M22 = I1
/// M33 = I3
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', u2', u3'). Entries that are not listed are 0.
///
/// ```text
/// f1 = m*l*g*sin(theta) + u2*(I1*u2/tan(theta) - I3*u3)
/// f2 = u1*(I3*u3 - I1*u2/tan(theta))
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (u1', u2', u3'), solved for when this code was generated. Entries that are not listed are 0.
///
/// ```text
/// u2' = u1*(I3*u3/I1 - u2/tan(theta))
/// u1' = (m*l*g*sin(theta) + u2*(I1*u2/tan(theta) - I3*u3))/I1
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// psi' = u2/sin(theta)
/// theta' = u1
/// phi' = u3 - u2/tan(theta)
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = I1*u1^2/2 + I1*u2^2/2 + I3*u3^2/2
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = m*l*g*cos(theta)
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;
