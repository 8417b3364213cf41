//! Elastic pendulum: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/elastic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (x'', y'').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by m, by x^2 + y^2.

pub use super::code::lagrange::{
    Lagrange, derivative, divisors, inverse_dynamics, jacobian_product,
};

pub use super::kane::potential_energy;

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows x, y. Entries that are not listed are 0.
///
/// ```text
/// M11 = m
/// M22 = m
/// ```
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (x'', y'').
///
/// ```text
/// f1 = k*x*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(x^2 + y^2)
/// f2 = k*y*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(x^2 + y^2) - m*g
/// ```
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (x'', y''), solved for when this code was generated.
///
/// ```text
/// y'' = k*y*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2)) - g
/// x'' = k*x*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2))
/// ```
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// x'
/// y'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = m*x'^2/2 + m*y'^2/2
/// ```
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// u = x'
/// v = y'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// u' = x''
/// v' = y''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
///
/// ```text
/// x' = u
/// y' = v
/// ```
#[doc(inline)]
pub use super::code::lagrange::motion_variables;
