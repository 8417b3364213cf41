//! Knife edge on an incline: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/knife_edge/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (x'', y'', phi'', lambda_edge).
//! The kinematic equations are singular nowhere.
//! The accelerations divide by nothing.

pub use super::code::lagrange::{
    Lagrange, constraint_slopes, constraints, derivative, jacobian_product,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows x, y, phi, constraint edge. Entries that are not listed are 0.
///
/// ```text
/// M11 = m
/// M14 = sin(phi)
/// M22 = m
/// M24 = -cos(phi)
/// M33 = J
/// M41 = -sin(phi)
/// M42 = cos(phi)
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (x'', y'', phi'', lambda_edge). Entries that are not listed are 0.
///
/// ```text
/// f1 = m*g*sin(alpha)
/// f4 = phi'*(x'*cos(phi) + y'*sin(phi))
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (x'', y'', phi''), solved for when this code was generated.
///
/// ```text
/// w' = 0
/// u' = g*sin(alpha)*cos(phi)
/// x'' = u'*cos(phi) - phi'*sin(phi)*(x'*cos(phi) + y'*sin(phi))
/// y'' = phi'*cos(phi)*(x'*cos(phi) + y'*sin(phi)) + u'*sin(phi)
/// phi'' = w'
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// x'
/// y'
/// phi'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = m*x'^2/2 + m*y'^2/2 + J*phi'^2/2
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// u = x'*cos(phi) + y'*sin(phi)
/// w = phi'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u' = phi'*(y'*cos(phi) - x'*sin(phi)) + x''*cos(phi) + y''*sin(phi)
/// w' = phi''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// x' = u*cos(phi)
/// y' = u*sin(phi)
/// phi' = w
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
