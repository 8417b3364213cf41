//! Cart with spring: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/cart_with_spring/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (x'').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by x, by m.

pub use super::code::lagrange::{
    Lagrange, derivative, divisors, inverse_dynamics, jacobian_product,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows x.
///
/// ```text
/// M11 = m
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (x'').
///
/// ```text
/// f1 = sqrt(x^2)*(k*(l - sqrt(x^2)) - c*x'*sqrt(x^2)/x)/x
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (x''), solved for when this code was generated.
///
/// ```text
/// x'' = sqrt(x^2)*(k*(l - sqrt(x^2)) - c*x'*sqrt(x^2)/x)/(m*x)
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// x'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = m*x'^2/2
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The power of the loads that have no potential: the rate of T + V.
///
/// ```text
/// d(T + V)/dt = -c*x'^2
/// ```
#[doc(inline)]
pub use super::code::lagrange::power;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// v = x'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// v' = x''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// x' = v
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
