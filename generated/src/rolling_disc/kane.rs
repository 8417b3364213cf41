//! Thin disc rolling on a plane: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/rolling_disc/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', u3').
//! The kinematic equations are singular where cos(q2) = 0.
//! The accelerations divide by cos(q2), by r.

pub use super::code::kane::{
    Kane, derivative, divisors, inverse_dynamics, jacobian_product,
};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1, u2, u3. Entries that are not listed are 0.
///
/// ```text
/// M11 = 5*r^2*m/4
/// M22 = 3*r^2*m/2
/// M33 = r^2*m/4
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', u2', u3').
///
/// ```text
/// f1 = r*m*(4*g*sin(q2) + r*u3*(6*u2 - u3*tan(q2)))/4
/// f2 = -r^2*m*u1*u3
/// f3 = r^2*m*u1*(u3*tan(q2) - 2*u2)/4
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (u1', u2', u3'), solved for when this code was generated.
///
/// ```text
/// u3' = u1*(u3*tan(q2) - 2*u2)
/// u2' = -2*u1*u3/3
/// u1' = 4*g*sin(q2)/(5*r) + u3*(6*u2 - u3*tan(q2))/5
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q1' = u3/cos(q2)
/// q2' = u1
/// q3' = u2 - u3*tan(q2)
/// x' = r*cos(q1)*(u2 - u3*tan(q2))
/// y' = r*sin(q1)*(u2 - u3*tan(q2))
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = 5*r^2*m*u1^2/8 + 3*r^2*m*u2^2/4 + r^2*m*u3^2/8
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = r*m*g*cos(q2)
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;
