//! Gyroscope in gimbals: Nutation makes the outer ring walk.
//!
//! Generated from `models/gimbals/scenes/nutation.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: psi, theta, phi, u_psi, u_theta, u_phi.
//! States: theta, u_theta. Quadratures: phi, psi.
//! p_psi = u_psi*(Iz + sin(theta)^2*(Ay + B) + cos(theta)^2*(Az + C)) + C*u_phi*cos(theta): momentum p_psi = ∂L/∂psi'.
//! p_phi = C*(u_psi*cos(theta) + u_phi): momentum p_phi = ∂L/∂phi'.
//! p_phi_per_C = u_psi*cos(theta) + u_phi: p_phi/C.
//! Parameters that the scene fixes: mo = 1, mi = 1, m = 2.
//! Singular nowhere.

pub use super::code::nutation::{
    OUTPUTS, PARAMETERS, Parameters, Reduced, SCENE, derivative, divisors,
    energy_gradient, half_differences, jacobian_product, potential_slope,
};

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// ```text
/// Iz
/// Ax
/// Ay
/// Az
/// B
/// C
/// p_psi = u_psi*(Iz + sin(theta)^2*(Ay + B) + cos(theta)^2*(Az + C)) + C*u_phi*cos(theta)
/// p_phi = C*(u_psi*cos(theta) + u_phi)
/// p_phi_per_C = u_psi*cos(theta) + u_phi
/// ```
#[doc(inline)]
pub use super::code::nutation::constants;

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// ```text
/// theta
/// phi
/// psi
/// u_theta
/// ```
#[doc(inline)]
pub use super::code::nutation::start;

/// The accelerations (u_theta'), solved for when this code was generated.
///
/// ```text
/// u_psi = (p_psi - p_phi*cos(theta))/(Iz + Az + sin(theta)^2*(Ay - Az + B))
/// u_phi = p_phi_per_C - u_psi*cos(theta)
/// u_theta' = u_psi*sin(theta)*(u_psi*cos(theta)*(Ay - Az + B - C) - C*u_phi)/(Ax + B)
/// ```
#[doc(inline)]
pub use super::code::nutation::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// u_psi = (p_psi - p_phi*cos(theta))/(Iz + Az + sin(theta)^2*(Ay - Az + B))
/// u_phi = p_phi_per_C - u_psi*cos(theta)
/// theta' = u_theta
/// ```
#[doc(inline)]
pub use super::code::nutation::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = u_theta^2*(Ax + B)/2
/// ```
#[doc(inline)]
pub use super::code::nutation::kinetic_energy;

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// ```text
/// u_psi = (p_psi - p_phi*cos(theta))/(Iz + Az + sin(theta)^2*(Ay - Az + B))
/// u_phi = p_phi_per_C - u_psi*cos(theta)
/// V = u_psi^2*(Iz + sin(theta)^2*(Ay + B) + cos(theta)^2*(Az + C))/2 + C*u_phi^2/2 + C*u_psi*u_phi*cos(theta)
/// ```
#[doc(inline)]
pub use super::code::nutation::potential_energy;

/// What the scene asks for, a time t after the start.
///
/// ```text
/// u_psi = (p_psi - p_phi*cos(theta))/(Iz + Az + sin(theta)^2*(Ay - Az + B))
/// u_phi = p_phi_per_C - u_psi*cos(theta)
/// psi
/// theta
/// phi
/// u_theta
/// ```
#[doc(inline)]
pub use super::code::nutation::outputs;
