//! Thin disk sliding on a frictionless plane: The lean alone, to t = 10 s.
//!
//! Generated from `models/disk/scenes/lean.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: q2, u1.
//! States: q2, u1. Quadratures: none.
//! u3: generalized speed, constant with the momentum p_q3 = ∂L/∂q3'.
//! H_a3_scaled = u2*cos(q2) + 2*u3*sin(q2): 4 times the angular momentum about a3 through the mass centre.
//! u3_times_2 = 2*u3.
//! g_times_4 = 4*g.
//! Parameters that the scene fixes: M = 1, R = 1.
//! Singular where cos(q2) = 0.

pub use super::code::lean::{
    OUTPUTS, PARAMETERS, Parameters, Reduced, SCENE, derivative, divisors,
    energy_gradient, half_differences, jacobian, potential_slope, taylor,
};

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// ```text
/// g
/// u3
/// H_a3_scaled = u2*cos(q2) + 2*u3*sin(q2)
/// u3_times_2 = 2*u3
/// g_times_4 = 4*g
/// ```
#[doc(inline)]
pub use super::code::lean::constants;

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// ```text
/// q2
/// u1
/// ```
#[doc(inline)]
pub use super::code::lean::start;

/// The accelerations (u1'), solved for when this code was generated.
///
/// ```text
/// u2 = (H_a3_scaled - u3_times_2*sin(q2))/cos(q2)
/// u1' = (sin(q2)*(4*u1^2*cos(q2) + u2^2/cos(q2) - g_times_4) - u2*u3_times_2)/(5 - 4*cos(q2)^2)
/// ```
#[doc(inline)]
pub use super::code::lean::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// q2' = -u1
/// ```
#[doc(inline)]
pub use super::code::lean::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// T = u1^2*(5 - 4*cos(q2)^2)/8
/// ```
#[doc(inline)]
pub use super::code::lean::kinetic_energy;

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// ```text
/// u2 = (H_a3_scaled - u3_times_2*sin(q2))/cos(q2)
/// V = g*(cos(q2) - 1) + u2^2/8 + u3^2/4
/// ```
#[doc(inline)]
pub use super::code::lean::potential_energy;

/// What the scene asks for, a time t after the start.
///
/// ```text
/// q2
/// u1
/// ```
#[doc(inline)]
pub use super::code::lean::outputs;
