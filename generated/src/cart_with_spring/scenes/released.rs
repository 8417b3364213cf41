//! Cart with spring: Released from a drawn spring.
//!
//! Generated from `models/cart_with_spring/scenes/released.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: x, v.
//! States: x, v. Quadratures: none.
//! Parameters that the scene fixes: m = 1.5.
//! Singular nowhere.

pub use super::code::released::{
    OUTPUTS, PARAMETERS, Parameters, Reduced, SCENE, derivative, divisors,
    jacobian_product,
};

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// ```text
/// k
/// l
/// c
/// ```
#[doc(inline)]
pub use super::code::released::constants;

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// ```text
/// x
/// v
/// ```
#[doc(inline)]
pub use super::code::released::start;

/// The accelerations (v'), solved for when this code was generated.
///
/// ```text
/// v' = 2*sqrt(x^2)*(k*(l - sqrt(x^2)) - c*v*sqrt(x^2)/x)/(3*x)
/// ```
#[doc(inline)]
pub use super::code::released::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// x' = v
/// ```
#[doc(inline)]
pub use super::code::released::coordinate_rates;

/// Kinetic energy T.
///
/// All entries are 0.
#[doc(inline)]
pub use super::code::released::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// All entries are 0.
#[doc(inline)]
pub use super::code::released::potential_energy;

/// What the scene asks for, a time t after the start.
///
/// ```text
/// x
/// v
/// ```
#[doc(inline)]
pub use super::code::released::outputs;
