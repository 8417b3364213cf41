//! Elastic pendulum: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/elastic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u', v').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by m, by x^2 + y^2.

pub use super::code::kane::{
    Kane, derivative, divisors, inverse_dynamics, jacobian_product,
};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u, v. Entries that are not listed are 0.
///
/// ```text
/// M11 = m
/// M22 = m
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (u', v').
///
/// ```text
/// f1 = k*x*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(x^2 + y^2)
/// f2 = k*y*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(x^2 + y^2) - m*g
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (u', v'), solved for when this code was generated.
///
/// ```text
/// v' = k*y*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2)) - g
/// u' = k*x*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2))
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// x' = u
/// y' = v
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = m*u^2/2 + m*v^2/2
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = m*g*y + k*(l - sqrt(x^2 + y^2))^2/2
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;
