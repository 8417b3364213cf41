//! Chaotic pendulum: a swinging rod with a plate turning about it: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/chaotic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (theta'', phi'').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2, by IBzz.

pub use super::code::lagrange::{
    Lagrange, derivative, inverse_dynamics, jacobian_product,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows theta, phi. Entries that are not listed are 0.
///
/// ```text
/// M11 = mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2
/// M22 = IBzz
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (theta'', phi'').
///
/// ```text
/// f1 = 2*theta'*phi'*sin(phi)*cos(phi)*(IByy - IBxx) - g*sin(theta)*(mA*lA + mB*lB)
/// f2 = theta'^2*sin(phi)*cos(phi)*(IBxx - IByy)
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (theta'', phi''), solved for when this code was generated.
///
/// ```text
/// theta'' = -(g*sin(theta)*(mA*lA + mB*lB) + 2*theta'*phi'*sin(phi)*cos(phi)*(IBxx - IByy))/(mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2)
/// phi'' = theta'^2*sin(phi)*cos(phi)*(IBxx - IByy)/IBzz
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// theta'
/// phi'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = theta'^2*(mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2)/2 + IBzz*phi'^2/2
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// omega = theta'
/// alpha = phi'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// omega' = theta''
/// alpha' = phi''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// theta' = omega
/// phi' = alpha
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
