//! Spherical pendulum: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/spherical_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (theta'', phi'').
//! The kinematic equations are singular where sin(theta) = 0.
//! The accelerations divide by sin(theta), by l.

pub use super::code::lagrange::{
    Lagrange, derivative, divisors, inverse_dynamics, jacobian_product,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows theta, phi. Entries that are not listed are 0.
///
/// ```text
/// M11 = m*l^2
/// M22 = m*l^2*sin(theta)^2
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (theta'', phi'').
///
/// ```text
/// f1 = m*l*sin(theta)*(l*phi'^2*cos(theta) - g)
/// f2 = -2*m*l^2*theta'*phi'*sin(theta)*cos(theta)
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (theta'', phi''), solved for when this code was generated.
///
/// ```text
/// phi'' = -2*theta'*phi'/tan(theta)
/// theta'' = sin(theta)*(phi'^2*cos(theta) - g/l)
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
/// T = m*l^2*theta'^2/2 + m*l^2*phi'^2*sin(theta)^2/2
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// u1 = theta'
/// u2 = phi'*sin(theta)
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u1' = theta''
/// u2' = theta'*phi'*cos(theta) + phi''*sin(theta)
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// theta' = u1
/// phi' = u2/sin(theta)
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
