//! Pendulum: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (omega').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by l.

pub use super::code::kane::{
    Kane, derivative, inverse_dynamics, jacobian_product, taylor,
};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows omega.
///
/// ```text
/// M11 = m*l^2
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (omega').
///
/// ```text
/// f1 = -m*l*g*sin(theta)
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (omega'), solved for when this code was generated.
///
/// ```text
/// omega' = -g*sin(theta)/l
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// theta' = omega
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = m*l^2*omega^2/2
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = m*l*g*(1 - cos(theta))
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;
