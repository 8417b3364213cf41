//! Symmetric heavy top about a fixed point: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/heavy_top/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (q1'', q2'', q3'').
//! The kinematic equations are singular where cos(q2) = 0.
//! The accelerations divide by I1, by cos(q2).

pub use super::code::lagrange::{
    Lagrange, derivative, divisors, inverse_dynamics, jacobian_product,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows q1, q2, q3. Entries that are not listed are 0.
///
/// ```text
/// M11 = I3*sin(q2)^2 + I1*cos(q2)^2
/// M13 = I3*sin(q2)
/// M22 = I1
/// M33 = I3
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (q1'', q2'', q3'').
///
/// ```text
/// f1 = cos(q2)*(m*l*g*sin(q1) - q2'*(I3*(2*q1'*sin(q2) + q3') - 2*I1*q1'*sin(q2)))
/// f2 = m*l*g*cos(q1)*sin(q2) + q1'*cos(q2)*(I3*(q1'*sin(q2) + q3') - I1*q1'*sin(q2))
/// f3 = -I3*q1'*q2'*cos(q2)
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (q1'', q2'', q3''), solved for when this code was generated.
///
/// ```text
/// q1'' = (m*l*g*sin(q1) + q2'*(2*I1*q1'*sin(q2) - I3*(q1'*sin(q2) + q3')))/(I1*cos(q2))
/// q3'' = -q1'*q2'*cos(q2) - q1''*sin(q2)
/// q2'' = (m*l*g*cos(q1)*sin(q2) + q1'*cos(q2)*(I3*(q1'*sin(q2) + q3') - I1*q1'*sin(q2)))/I1
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q1'
/// q2'
/// q3'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = q1'^2*(I3*sin(q2)^2 + I1*cos(q2)^2)/2 + I1*q2'^2/2 + I3*q3'^2/2 + I3*q1'*q3'*sin(q2)
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// u1 = q1'*cos(q2)
/// u2 = q2'
/// u3 = q1'*sin(q2) + q3'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u1' = q1''*cos(q2) - q1'*q2'*sin(q2)
/// u2' = q2''
/// u3' = q1'*q2'*cos(q2) + q1''*sin(q2) + q3''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// q1' = u1/cos(q2)
/// q2' = u2
/// q3' = u3 - u1*tan(q2)
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
