//! Thin disk sliding on a frictionless plane: The flat fall.
//!
//! Generated from `models/disk/scenes/flat-fall.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: q1, q2, q3, q4, q5, u1, u2, u3, u4, u5.
//! States: q2_minus_90deg, u1. Quadratures: q3, q1.
//! u3: generalized speed, constant with the momentum p_q3 = ∂L/∂q3'.
//! p_q4 = u1*sin(q1)*cos(q2) - u2*cos(q1)*tan(q2) + u4: momentum p_q4 = ∂L/∂q4'.
//! p_q5 = u5 - u1*cos(q1)*cos(q2) - u2*sin(q1)*tan(q2): momentum p_q5 = ∂L/∂q5'.
//! H_a3_there_scaled = 2*u3*(1 - sin(q2)) - u2*cos(q2): -4 times the angular momentum about a3 through the mass centre, what is left of it on the singular surface.
//! centre_q4 = q4 - sin(q1)*sin(q2): q4 - sin(q1)*cos(q2_minus_90deg) at the start.
//! centre_q5 = cos(q1)*sin(q2) + q5: q5 + cos(q1)*cos(q2_minus_90deg) at the start.
//! u3_times_4 = 4*u3.
//! g_times_4 = 4*g.
//! u3_times_2 = 2*u3.
//! Parameters that the scene fixes: M = 1, R = 1.
//! Singular where sin(q2_minus_90deg) = 0.

pub use super::code::flat_fall::{
    OUTPUTS, PARAMETERS, Parameters, Reduced, SCENE, derivative, divisors,
    energy_gradient, half_differences, jacobian, potential_slope, taylor,
};

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// ```text
/// g
/// u3
/// p_q4 = u1*sin(q1)*cos(q2) - u2*cos(q1)*tan(q2) + u4
/// p_q5 = u5 - u1*cos(q1)*cos(q2) - u2*sin(q1)*tan(q2)
/// H_a3_there_scaled = 2*u3*(1 - sin(q2)) - u2*cos(q2)
/// centre_q4 = q4 - sin(q1)*sin(q2)
/// centre_q5 = cos(q1)*sin(q2) + q5
/// u3_times_4 = 4*u3
/// g_times_4 = 4*g
/// u3_times_2 = 2*u3
/// ```
#[doc(inline)]
pub use super::code::flat_fall::constants;

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// ```text
/// q2_minus_90deg = q2 - pi/2
/// q3
/// q1
/// u1
/// ```
#[doc(inline)]
pub use super::code::flat_fall::start;

/// The accelerations (u1'), solved for when this code was generated.
///
/// ```text
/// u2 = (H_a3_there_scaled - u3_times_4*sin(q2_minus_90deg/2)^2)/sin(q2_minus_90deg)
/// u1' = (cos(q2_minus_90deg)*(4*u1^2*sin(q2_minus_90deg) + u2^2/sin(q2_minus_90deg) + g_times_4) + u2*u3_times_2)/(4*sin(q2_minus_90deg)^2 - 5)
/// ```
#[doc(inline)]
pub use super::code::flat_fall::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// u2 = (H_a3_there_scaled - u3_times_4*sin(q2_minus_90deg/2)^2)/sin(q2_minus_90deg)
/// q2_minus_90deg' = -u1
/// q3' = u3 + u2/tan(q2_minus_90deg)
/// q1' = -u2/sin(q2_minus_90deg)
/// ```
#[doc(inline)]
pub use super::code::flat_fall::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = u1^2*(5 - 4*sin(q2_minus_90deg)^2)/8
/// ```
#[doc(inline)]
pub use super::code::flat_fall::kinetic_energy;

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// ```text
/// u2 = (H_a3_there_scaled - u3_times_4*sin(q2_minus_90deg/2)^2)/sin(q2_minus_90deg)
/// V = u2^2/8 + u3^2/4 - g*(1 + sin(q2_minus_90deg)) + p_q4^2/2 + p_q5^2/2
/// ```
#[doc(inline)]
pub use super::code::flat_fall::potential_energy;

/// What the scene asks for, a time t after the start.
///
/// ```text
/// u2 = (H_a3_there_scaled - u3_times_4*sin(q2_minus_90deg/2)^2)/sin(q2_minus_90deg)
/// u5 = p_q5 - u1*cos(q1)*sin(q2_minus_90deg) - u2*sin(q1)/tan(q2_minus_90deg)
/// u4 = u1*sin(q1)*sin(q2_minus_90deg) - u2*cos(q1)/tan(q2_minus_90deg) + p_q4
/// q1
/// q2 = pi/2 + q2_minus_90deg
/// q3
/// q4 = sin(q1)*cos(q2_minus_90deg) + p_q4*t + centre_q4
/// q5 = p_q5*t - cos(q1)*cos(q2_minus_90deg) + centre_q5
/// u1
/// u3
/// ```
#[doc(inline)]
pub use super::code::flat_fall::outputs;
