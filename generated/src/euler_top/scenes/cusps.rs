//! Symmetric heavy top in Euler's angles: Let go.
//!
//! Generated from `models/euler_top/scenes/cusps.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: psi, theta, phi, u1, u2, u3.
//! States: theta, u1. Quadratures: phi, psi.
//! p_psi_there = I1*u2*sin(theta) + I3*u3*(cos(theta) - 1): momentum p_psi = ∂L/∂psi', what is left of it on the singular surface.
//! p_phi = I3*u3: momentum p_phi = ∂L/∂phi'.
//! p_phi_times_2 = 2*I3*u3: 2*p_phi.
//! m_l_g = m*l*g.
//! Singular where sin(theta) = 0.

pub use super::code::cusps::{
    OUTPUTS, PARAMETERS, Parameters, Reduced, SCENE, derivative, divisors,
    energy_gradient, half_differences, jacobian_product, potential_slope,
};

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// ```text
/// m
/// l
/// I1
/// I3
/// g
/// p_psi_there = I1*u2*sin(theta) + I3*u3*(cos(theta) - 1)
/// p_phi = I3*u3
/// p_phi_times_2 = 2*I3*u3
/// m_l_g = m*l*g
/// ```
#[doc(inline)]
pub use super::code::cusps::constants;

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// ```text
/// theta
/// phi
/// psi
/// u1
/// ```
#[doc(inline)]
pub use super::code::cusps::start;

/// The accelerations (u1'), solved for when this code was generated.
///
/// ```text
/// u2 = (p_psi_there + p_phi_times_2*sin(theta/2)^2)/(I1*sin(theta))
/// u3 = p_phi/I3
/// u1' = (m_l_g*sin(theta) - u2*(I3*u3 - I1*u2/tan(theta)))/I1
/// ```
#[doc(inline)]
pub use super::code::cusps::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// u2 = (p_psi_there + p_phi_times_2*sin(theta/2)^2)/(I1*sin(theta))
/// u3 = p_phi/I3
/// theta' = u1
/// phi' = u3 - u2/tan(theta)
/// psi' = u2/sin(theta)
/// ```
#[doc(inline)]
pub use super::code::cusps::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = I1*u1^2/2
/// ```
#[doc(inline)]
pub use super::code::cusps::kinetic_energy;

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// ```text
/// u2 = (p_psi_there + p_phi_times_2*sin(theta/2)^2)/(I1*sin(theta))
/// u3 = p_phi/I3
/// V = m*l*g*cos(theta) + I1*u2^2/2 + I3*u3^2/2
/// ```
#[doc(inline)]
pub use super::code::cusps::potential_energy;

/// What the scene asks for, a time t after the start.
///
/// ```text
/// u2 = (p_psi_there + p_phi_times_2*sin(theta/2)^2)/(I1*sin(theta))
/// u3 = p_phi/I3
/// psi
/// theta
/// phi
/// u1
/// ```
#[doc(inline)]
pub use super::code::cusps::outputs;
