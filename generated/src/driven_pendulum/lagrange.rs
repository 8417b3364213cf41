//! Pendulum on a driven pivot: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/driven_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (q'', t'', lambda_t).
//! The kinematic equations are singular nowhere.
//! The accelerations divide by l.

pub use super::code::lagrange::{Lagrange, derivative, jacobian_product};

pub use super::kane::potential_energy;

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows q, t, constraint t. Entries that are not listed are 0.
///
/// ```text
/// M11 = m*l^2
/// M12 = m*l*a*w*sin(q)*cos(w*t)
/// M21 = m*l*a*w*sin(q)*cos(w*t)
/// M22 = m*a^2*w^2*cos(w*t)^2
/// M23 = -1
/// M32 = 1
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (q'', t'', lambda_t). Entries that are not listed are 0.
///
/// ```text
/// f1 = m*l*sin(q)*(a*w^2*t'^2*sin(w*t) - g)
/// f2 = m*a*w*cos(w*t)*(a*w^2*t'^2*sin(w*t) - g - l*q'^2*cos(q))
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (q'', t''), solved for when this code was generated. Entries that are not listed are 0.
///
/// ```text
/// u' = sin(q)*(a*w^2*t'^2*sin(w*t) - g)/l
/// q'' = u'
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q'
/// t'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = m*l^2*q'^2/2 + m*a^2*w^2*t'^2*cos(w*t)^2/2 + m*l*a*w*q'*t'*sin(q)*cos(w*t)
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// u = q'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u' = q''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// q' = u
/// t' = 1
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
