//! Symmetric heavy top in Euler's angles: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/euler_top/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (psi'', theta'', phi'').
//! The kinematic equations are singular where sin(theta) = 0.
//! The accelerations divide by I1, by sin(theta).

pub use super::code::lagrange::{
    Lagrange, derivative, divisors, inverse_dynamics, jacobian_product,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows psi, theta, phi. Entries that are not listed are 0.
///
/// ```text
/// M11 = I1*sin(theta)^2 + I3*cos(theta)^2
/// M13 = I3*cos(theta)
/// M22 = I1
/// M33 = I3
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (psi'', theta'', phi'').
///
/// ```text
/// f1 = theta'*sin(theta)*(I3*(2*psi'*cos(theta) + phi') - 2*I1*psi'*cos(theta))
/// f2 = sin(theta)*(m*l*g - psi'*(I3*(psi'*cos(theta) + phi') - I1*psi'*cos(theta)))
/// f3 = I3*psi'*theta'*sin(theta)
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (psi'', theta'', phi''), solved for when this code was generated.
///
/// ```text
/// psi'' = theta'*(I3*(psi'*cos(theta) + phi')/I1 - 2*psi'*cos(theta))/sin(theta)
/// phi'' = psi'*theta'*sin(theta) - psi''*cos(theta)
/// theta'' = sin(theta)*(m*l*g - psi'*(I3*(psi'*cos(theta) + phi') - I1*psi'*cos(theta)))/I1
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// psi'
/// theta'
/// phi'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = psi'^2*(I1*sin(theta)^2 + I3*cos(theta)^2)/2 + I1*theta'^2/2 + I3*phi'^2/2 + I3*psi'*phi'*cos(theta)
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// u1 = theta'
/// u2 = psi'*sin(theta)
/// u3 = psi'*cos(theta) + phi'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u1' = theta''
/// u2' = psi'*theta'*cos(theta) + psi''*sin(theta)
/// u3' = psi''*cos(theta) - psi'*theta'*sin(theta) + phi''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// psi' = u2/sin(theta)
/// theta' = u1
/// phi' = u3 - u2/tan(theta)
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
