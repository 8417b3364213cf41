//! Symmetric heavy top about a fixed point: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/heavy_top/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', u3').
//! The kinematic equations are singular where cos(q2) = 0.
//! The accelerations divide by cos(q2), by I1.

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
/// f1 = m*l*g*sin(q1) + u2*(I1*u1*tan(q2) - I3*u3)
/// f2 = m*l*g*cos(q1)*sin(q2) + u1*(I3*u3 - I1*u1*tan(q2))
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (u1', u2', u3'), solved for when this code was generated. Entries that are not listed are 0.
///
/// ```text
/// u2' = (m*l*g*cos(q1)*sin(q2) + u1*(I3*u3 - I1*u1*tan(q2)))/I1
/// u1' = (m*l*g*sin(q1) + u2*(I1*u1*tan(q2) - I3*u3))/I1
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q1' = u1/cos(q2)
/// q2' = u2
/// q3' = u3 - u1*tan(q2)
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
/// V = m*l*g*cos(q1)*cos(q2)
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;
