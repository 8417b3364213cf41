//! Symmetric rigid body free of forces: Steady precession.
//!
//! Generated from `models/free_body/scenes/steady.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: x, y, z, psi, theta, phi, v1, v2, v3, w1, w2, w3.
//! States: theta, w1. Quadratures: phi, psi.
//! p_x = 2*v1: momentum p_x = ∂L/∂x'.
//! p_y = 2*v2: momentum p_y = ∂L/∂y'.
//! p_z = 2*v3: momentum p_z = ∂L/∂z'.
//! p_psi_there = I1*w2*sin(theta) + w3*(cos(theta) - 1)/2: momentum p_psi = ∂L/∂psi', what is left of it on the singular surface.
//! w3: generalized speed, constant with the momentum p_phi = ∂L/∂phi'.
//! centre_x = 2*x: 2*x at the start.
//! centre_y = 2*y: 2*y at the start.
//! centre_z = 2*z: 2*z at the start.
//! p_z_by_2 = v3: p_z/2.
//! p_y_by_2 = v2: p_y/2.
//! p_x_by_2 = v1: p_x/2.
//! w3_per_I1 = w3/I1.
//! Parameters that the scene fixes: m = 2, I3 = 0.5.
//! Singular where sin(theta) = 0.

pub use super::code::steady::{
    OUTPUTS, PARAMETERS, Parameters, Reduced, SCENE, derivative, divisors,
    energy_gradient, half_differences, jacobian_product, potential_slope,
};

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// ```text
/// I1
/// p_x = 2*v1
/// p_y = 2*v2
/// p_z = 2*v3
/// p_psi_there = I1*w2*sin(theta) + w3*(cos(theta) - 1)/2
/// w3
/// centre_x = 2*x
/// centre_y = 2*y
/// centre_z = 2*z
/// p_z_by_2 = v3
/// p_y_by_2 = v2
/// p_x_by_2 = v1
/// w3_per_I1 = w3/I1
/// ```
#[doc(inline)]
pub use super::code::steady::constants;

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// ```text
/// theta
/// phi
/// psi
/// w1
/// ```
#[doc(inline)]
pub use super::code::steady::start;

/// The accelerations (w1'), solved for when this code was generated.
///
/// ```text
/// w2 = (w3*sin(theta/2)^2 + p_psi_there)/(I1*sin(theta))
/// w1' = w2*(2*w2/tan(theta) - w3_per_I1)/2
/// ```
#[doc(inline)]
pub use super::code::steady::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// w2 = (w3*sin(theta/2)^2 + p_psi_there)/(I1*sin(theta))
/// theta' = w1
/// phi' = w3 - w2/tan(theta)
/// psi' = w2/sin(theta)
/// ```
#[doc(inline)]
pub use super::code::steady::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = I1*w1^2/2
/// ```
#[doc(inline)]
pub use super::code::steady::kinetic_energy;

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// ```text
/// w2 = (w3*sin(theta/2)^2 + p_psi_there)/(I1*sin(theta))
/// v3 = p_z_by_2
/// v2 = p_y_by_2
/// v1 = p_x_by_2
/// V = v1^2 + v2^2 + v3^2 + I1*w2^2/2 + w3^2/4
/// ```
#[doc(inline)]
pub use super::code::steady::potential_energy;

/// What the scene asks for, a time t after the start.
///
/// ```text
/// w2 = (w3*sin(theta/2)^2 + p_psi_there)/(I1*sin(theta))
/// v3 = p_z_by_2
/// v2 = p_y_by_2
/// v1 = p_x_by_2
/// x = p_x*t/2 + centre_x/2
/// y = p_y*t/2 + centre_y/2
/// z = p_z*t/2 + centre_z/2
/// psi
/// theta
/// phi
/// w1
/// w3
/// ```
#[doc(inline)]
pub use super::code::steady::outputs;
