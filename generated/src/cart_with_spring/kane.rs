//! Cart with spring: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/cart_with_spring/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (v').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by x, by m.

pub use super::code::kane::{
    Kane, derivative, divisors, inverse_dynamics, jacobian_product,
};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows v.
///
/// ```text
/// M11 = m
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (v').
///
/// ```text
/// f1 = sqrt(x^2)*(k*(l - sqrt(x^2)) - c*v*sqrt(x^2)/x)/x
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (v'), solved for when this code was generated.
///
/// ```text
/// v' = sqrt(x^2)*(k*(l - sqrt(x^2)) - c*v*sqrt(x^2)/x)/(m*x)
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// x' = v
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = m*v^2/2
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = k*(l - sqrt(x^2))^2/2
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;

/// The power of the loads that have no potential: the rate of T + V.
///
/// ```text
/// d(T + V)/dt = -c*v^2
/// ```
#[doc(inline)]
pub use super::code::kane::power;
