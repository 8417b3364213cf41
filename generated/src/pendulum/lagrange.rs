//! Pendulum: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (theta'').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by l.

pub use super::code::lagrange::{
    Lagrange, derivative, inverse_dynamics, jacobian_product, taylor,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows theta.
///
/// ```text
/// M11 = m*l^2
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (theta'').
///
/// ```text
/// f1 = -m*l*g*sin(theta)
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (theta''), solved for when this code was generated.
///
/// ```text
/// theta'' = -g*sin(theta)/l
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// theta'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = m*l^2*theta'^2/2
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// omega = theta'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// omega' = theta''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// theta' = omega
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
