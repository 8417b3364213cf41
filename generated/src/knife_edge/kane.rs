//! Knife edge on an incline: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/knife_edge/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u', w').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by nothing.

pub use super::code::kane::{Kane, derivative, inverse_dynamics, jacobian_product};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u, w. Entries that are not listed are 0.
///
/// ```text
/// M11 = m
/// M22 = J
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (u', w'). Entries that are not listed are 0.
///
/// ```text
/// f1 = m*g*sin(alpha)*cos(phi)
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (u', w'), solved for when this code was generated. Entries that are not listed are 0.
///
/// ```text
/// u' = g*sin(alpha)*cos(phi)
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// x' = u*cos(phi)
/// y' = u*sin(phi)
/// phi' = w
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = m*u^2/2 + J*w^2/2
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = -m*g*x*sin(alpha)
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;
