//! Thin disk sliding on a frictionless plane: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/disk/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u1', u2', u3', u4', u5').
//! The kinematic equations are singular where cos(q2) = 0.
//! The accelerations divide by cos(q2), by R, by 4*cos(q2)^2 - 5.

pub use super::code::kane::{
    Kane, derivative, divisors, inverse_dynamics, jacobian, taylor,
};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1, u2, u3, u4, u5. Entries that are not listed are 0.
///
/// ```text
/// M11 = 5*M*R^2/4
/// M14 = M*R*sin(q1)*cos(q2)
/// M15 = -M*R*cos(q1)*cos(q2)
/// M22 = M*R^2*(1 + 4*tan(q2)^2)/4
/// M24 = -M*R*cos(q1)*tan(q2)
/// M25 = -M*R*sin(q1)*tan(q2)
/// M33 = M*R^2/2
/// M44 = M
/// M55 = M
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5'). Entries that are not listed are 0.
///
/// ```text
/// f1 = -M*R*(4*g*sin(q2) + R*u2*(3*u2*tan(q2) + 2*u3))/4
/// f2 = M*R^2*u1*(u2*tan(q2)*(7 + 4*tan(q2)^2) + 2*u3)/4
/// f4 = -M*R*(u2^2*sin(q1)*tan(q2)/cos(q2) + u1*(u1*sin(q1)*sin(q2) + u2*cos(q1)*(1 + 1/cos(q2)^2)))
/// f5 = M*R*(u2^2*cos(q1)*tan(q2)/cos(q2) - u1*(u2*sin(q1)*(1 + 1/cos(q2)^2) - u1*cos(q1)*sin(q2)))
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (u1', u2', u3', u4', u5'), solved for when this code was generated. Entries that are not listed are 0.
///
/// ```text
/// u1' = (sin(q2)*(4*g/R - 4*u1^2*cos(q2) - u2^2/cos(q2)) + 2*u2*u3)/(4*cos(q2)^2 - 5)
/// u2' = u1*(2*u3 - u2*tan(q2))
/// u5' = R*(u1'*cos(q1)*cos(q2) - u1*(u2*sin(q1)*(1 + 1/cos(q2)^2) - u1*cos(q1)*sin(q2)) + tan(q2)*(u2^2*cos(q1)/cos(q2) + u2'*sin(q1)))
/// u4' = -R*(u1*(u1*sin(q1)*sin(q2) + u2*cos(q1)*(1 + 1/cos(q2)^2)) + u1'*sin(q1)*cos(q2) + tan(q2)*(u2^2*sin(q1)/cos(q2) - u2'*cos(q1)))
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q1' = u2/cos(q2)
/// q2' = -u1
/// q3' = u3 - u2*tan(q2)
/// q4' = u4
/// q5' = u5
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = 5*M*R^2*u1^2/8 + M*R^2*u2^2*(1 + 4*tan(q2)^2)/8 + M*R^2*u3^2/4 + M*u4^2/2 + M*R*u1*u4*sin(q1)*cos(q2) - M*R*u2*u4*cos(q1)*tan(q2) + M*u5^2/2 -
///     M*R*u1*u5*cos(q1)*cos(q2) - M*R*u2*u5*sin(q1)*tan(q2)
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = M*R*g*(cos(q2) - 1)
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;
