//! Pendulum on a driven pivot: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/driven_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by l.

pub use super::code::kane::{Kane, derivative, inverse_dynamics, jacobian_product};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u.
///
/// ```text
/// M11 = m*l^2
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (u').
///
/// ```text
/// f1 = m*l*sin(q)*(a*w^2*sin(w*t) - g)
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (u'), solved for when this code was generated.
///
/// ```text
/// u' = sin(q)*(a*w^2*sin(w*t) - g)/l
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q' = u
/// t' = 1
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = m*(a^2*w^2*cos(w*t)^2 + l*u*(2*a*w*sin(q)*cos(w*t) + l*u))/2
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = m*g*(a*sin(w*t) - l*cos(q))
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;
