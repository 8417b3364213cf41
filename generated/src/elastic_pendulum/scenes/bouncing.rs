//! Elastic pendulum: Bouncing turns into swinging.
//!
//! Generated from `models/elastic_pendulum/scenes/bouncing.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: x, y, u, v.
//! States: x, y, u, v. Quadratures: none.
//! Parameters that the scene fixes: m = 1, l = 1.
//! Singular nowhere.

pub use super::code::bouncing::{
    OUTPUTS, PARAMETERS, Parameters, Reduced, SCENE, derivative, divisors,
    energy_gradient, jacobian_product,
};

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// ```text
/// k
/// g
/// ```
#[doc(inline)]
pub use super::code::bouncing::constants;

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// ```text
/// x
/// y
/// u
/// v
/// ```
#[doc(inline)]
pub use super::code::bouncing::start;

/// The accelerations (u', v'), solved for when this code was generated.
///
/// ```text
/// v' = k*y*sqrt(x^2 + y^2)*(1 - sqrt(x^2 + y^2))/(x^2 + y^2) - g
/// u' = k*x*sqrt(x^2 + y^2)*(1 - sqrt(x^2 + y^2))/(x^2 + y^2)
/// ```
#[doc(inline)]
pub use super::code::bouncing::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// x' = u
/// y' = v
/// ```
#[doc(inline)]
pub use super::code::bouncing::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = u^2/2 + v^2/2
/// ```
#[doc(inline)]
pub use super::code::bouncing::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = g*y + k*(sqrt(x^2 + y^2) - 1)^2/2
/// ```
#[doc(inline)]
pub use super::code::bouncing::potential_energy;

/// What the scene asks for, a time t after the start.
///
/// ```text
/// x
/// y
/// u
/// v
/// ```
#[doc(inline)]
pub use super::code::bouncing::outputs;
