//! Symmetric rigid body free of forces: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/free_body/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (x'', y'', z'', psi'', theta'', phi'').
//! The kinematic equations are singular where sin(theta) = 0.
//! The accelerations divide by I1, by sin(theta).

pub use super::code::lagrange::{
    Lagrange, derivative, divisors, inverse_dynamics, jacobian_product,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows x, y, z, psi, theta, phi. Entries that are not listed are 0.
///
/// ```text
/// M11 = m
/// M22 = m
/// M33 = m
/// M44 = I1*sin(theta)^2 + I3*cos(theta)^2
/// M46 = I3*cos(theta)
/// M55 = I1
/// M66 = I3
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (x'', y'', z'', psi'', theta'', phi''). Entries that are not listed are 0.
///
/// ```text
/// f4 = theta'*sin(theta)*(I3*(2*psi'*cos(theta) + phi') - 2*I1*psi'*cos(theta))
/// f5 = psi'*sin(theta)*(I1*psi'*cos(theta) - I3*(psi'*cos(theta) + phi'))
/// f6 = I3*psi'*theta'*sin(theta)
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (x'', y'', z'', psi'', theta'', phi''), solved for when this code was generated. Entries that are not listed are 0.
///
/// ```text
/// psi'' = theta'*(I3*(psi'*cos(theta) + phi')/I1 - 2*psi'*cos(theta))/sin(theta)
/// phi'' = psi'*theta'*sin(theta) - psi''*cos(theta)
/// theta'' = psi'*sin(theta)*(psi'*cos(theta) - I3*(psi'*cos(theta) + phi')/I1)
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// x'
/// y'
/// z'
/// psi'
/// theta'
/// phi'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = m*x'^2/2 + m*y'^2/2 + m*z'^2/2 + psi'^2*(I1*sin(theta)^2 + I3*cos(theta)^2)/2 + I1*theta'^2/2 + I3*phi'^2/2 + I3*psi'*phi'*cos(theta)
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// v1 = x'
/// v2 = y'
/// v3 = z'
/// w1 = theta'
/// w2 = psi'*sin(theta)
/// w3 = psi'*cos(theta) + phi'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// v1' = x''
/// v2' = y''
/// v3' = z''
/// w1' = theta''
/// w2' = psi'*theta'*cos(theta) + psi''*sin(theta)
/// w3' = psi''*cos(theta) - psi'*theta'*sin(theta) + phi''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// x' = v1
/// y' = v2
/// z' = v3
/// psi' = w2/sin(theta)
/// theta' = w1
/// phi' = w3 - w2/tan(theta)
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
