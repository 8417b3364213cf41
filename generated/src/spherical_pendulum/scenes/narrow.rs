//! Spherical pendulum: Nearly in a plane.
//!
//! Generated from `models/spherical_pendulum/scenes/narrow.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: theta, phi, u1, u2.
//! States: theta, u1. Quadratures: phi.
//! p_phi = u2*sin(theta): momentum p_phi = ∂L/∂phi'.
//! Parameters that the scene fixes: m = 1, l = 1.
//! Singular where sin(theta) = 0.

pub use super::code::narrow::{
    OUTPUTS, PARAMETERS, Parameters, Reduced, SCENE, derivative, divisors,
    energy_gradient, half_differences, jacobian_product, potential_slope,
};

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// ```text
/// g
/// p_phi = u2*sin(theta)
/// ```
#[doc(inline)]
pub use super::code::narrow::constants;

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// ```text
/// theta
/// phi
/// u1
/// ```
#[doc(inline)]
pub use super::code::narrow::start;

/// The accelerations (u1'), solved for when this code was generated.
///
/// ```text
/// u2 = p_phi/sin(theta)
/// u1' = u2^2/tan(theta) - g*sin(theta)
/// ```
#[doc(inline)]
pub use super::code::narrow::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// u2 = p_phi/sin(theta)
/// theta' = u1
/// phi' = u2/sin(theta)
/// ```
#[doc(inline)]
pub use super::code::narrow::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = u1^2/2
/// ```
#[doc(inline)]
pub use super::code::narrow::kinetic_energy;

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// ```text
/// u2 = p_phi/sin(theta)
/// V = g*(1 - cos(theta)) + u2^2/2
/// ```
#[doc(inline)]
pub use super::code::narrow::potential_energy;

/// What the scene asks for, a time t after the start.
///
/// ```text
/// u2 = p_phi/sin(theta)
/// theta
/// phi
/// u1
/// ```
#[doc(inline)]
pub use super::code::narrow::outputs;
