//! Pendulum: Over the top.
//!
//! Generated from `models/pendulum/scenes/over.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: theta, omega.
//! States: theta, omega. Quadratures: none.
//! Parameters that the scene fixes: m = 1, l = 1.
//! Singular nowhere.

pub use super::code::over::{
    OUTPUTS, PARAMETERS, Parameters, Reduced, SCENE, derivative, energy_gradient,
    half_differences, jacobian_product, potential_slope, taylor,
};

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// ```text
/// g
/// ```
#[doc(inline)]
pub use super::code::over::constants;

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// ```text
/// theta
/// omega
/// ```
#[doc(inline)]
pub use super::code::over::start;

/// The accelerations (omega'), solved for when this code was generated.
///
/// ```text
/// omega' = -g*sin(theta)
/// ```
#[doc(inline)]
pub use super::code::over::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// theta' = omega
/// ```
#[doc(inline)]
pub use super::code::over::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = omega^2/2
/// ```
#[doc(inline)]
pub use super::code::over::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// V = g*(1 - cos(theta))
/// ```
#[doc(inline)]
pub use super::code::over::potential_energy;

/// What the scene asks for, a time t after the start.
///
/// ```text
/// theta
/// omega
/// ```
#[doc(inline)]
pub use super::code::over::outputs;
