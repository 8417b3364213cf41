//! Thin disk sliding on a frictionless plane: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/disk/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (q1'', q2'', q3'', q4'', q5'').
//! The kinematic equations are singular where cos(q2) = 0.
//! The accelerations divide by cos(q2), by R, by 4*cos(q2)^2 - 5.

pub use super::code::lagrange::{
    Lagrange, derivative, divisors, inverse_dynamics, jacobian, taylor,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows q1, q2, q3, q4, q5. Entries that are not listed are 0.
///
/// ```text
/// M11 = M*R^2*(6 - 5*cos(q2)^2)/4
/// M13 = M*R^2*sin(q2)/2
/// M14 = -M*R*cos(q1)*sin(q2)
/// M15 = -M*R*sin(q1)*sin(q2)
/// M22 = 5*M*R^2/4
/// M24 = -M*R*sin(q1)*cos(q2)
/// M25 = M*R*cos(q1)*cos(q2)
/// M33 = M*R^2/2
/// M44 = M
/// M55 = M
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (q1'', q2'', q3'', q4'', q5'').
///
/// ```text
/// f1 = -M*R^2*q2'*cos(q2)*(5*q1'*sin(q2) + q3')/2
/// f2 = M*R*(4*g*sin(q2) + R*q1'*cos(q2)*(5*q1'*sin(q2) + 2*q3'))/4
/// f3 = -M*R^2*q1'*q2'*cos(q2)/2
/// f4 = -M*R*(q2'^2*sin(q1)*sin(q2) + q1'*(q1'*sin(q1)*sin(q2) - 2*q2'*cos(q1)*cos(q2)))
/// f5 = M*R*(q2'^2*cos(q1)*sin(q2) + q1'*(q1'*cos(q1)*sin(q2) + 2*q2'*sin(q1)*cos(q2)))
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (q1'', q2'', q3'', q4'', q5''), solved for when this code was generated.
///
/// ```text
/// q1'' = -2*q2'*q3'/cos(q2)
/// q2'' = (4*g*sin(q2) + R*cos(q2)*(q1'*(q1'*sin(q2) + 2*q3') - 4*q2'^2*sin(q2)))/(R*(5 - 4*cos(q2)^2))
/// q5'' = R*(sin(q2)*(cos(q1)*(q1'^2 + q2'^2) + q1''*sin(q1)) + cos(q2)*(2*q1'*q2'*sin(q1) - q2''*cos(q1)))
/// q4'' = R*(cos(q2)*(2*q1'*q2'*cos(q1) + q2''*sin(q1)) - sin(q2)*(sin(q1)*(q1'^2 + q2'^2) - q1''*cos(q1)))
/// q3'' = -q1'*q2'*cos(q2) - q1''*sin(q2)
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q1'
/// q2'
/// q3'
/// q4'
/// q5'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = M*R^2*q1'^2*(6 - 5*cos(q2)^2)/8 + 5*M*R^2*q2'^2/8 + M*R^2*q3'^2/4 + M*R^2*q1'*q3'*sin(q2)/2 + M*q4'^2/2 - M*R*q1'*q4'*cos(q1)*sin(q2) -
///     M*R*q2'*q4'*sin(q1)*cos(q2) + M*q5'^2/2 - M*R*q1'*q5'*sin(q1)*sin(q2) + M*R*q2'*q5'*cos(q1)*cos(q2)
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// u1 = -q2'
/// u2 = q1'*cos(q2)
/// u3 = q1'*sin(q2) + q3'
/// u4 = q4'
/// u5 = q5'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u1' = -q2''
/// u2' = q1''*cos(q2) - q1'*q2'*sin(q2)
/// u3' = q1'*q2'*cos(q2) + q1''*sin(q2) + q3''
/// u4' = q4''
/// u5' = q5''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// q1' = u2/cos(q2)
/// q2' = -u1
/// q3' = u3 - u2*tan(q2)
/// q4' = u4
/// q5' = u5
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
