//! Flyball governor: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/governor/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (spin', opening').
//! The kinematic equations are singular where cos(theta + q_left_ball) = 0 and where sin(q_right_ball) = 0.
//! The accelerations divide by 5 pivots, which are positive where the mass matrix is.

pub use super::code::kane::{
    Kane, constraint_slopes, constraints, divisors, inverse_dynamics, jacobian_product,
};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows spin, opening. Entries that are not listed are 0.
///
/// 104 operations, 4 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (spin', opening').
///
/// 294 operations, 6 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (spin', opening'), solved for when this code was generated.
///
/// 394 operations, 6 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// psi' = spin
/// theta' = opening
/// q_right_top' = opening*sin(q_left_ball)*cos(q_right_top + q_right_ball)/(cos(theta + q_left_ball)*sin(q_right_ball))
/// q_left_ball' = -opening*(cos(theta) + cos(theta + q_left_ball))/cos(theta + q_left_ball)
/// q_right_ball' = opening*sin(q_left_ball)*(sin(q_right_top)*sin(q_right_ball) - cos(q_right_top)*(1 + cos(q_right_ball)))/(cos(theta +
///     q_left_ball)*sin(q_right_ball))
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// 111 operations, 6 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// mr_right_link_frame_3 = l*m
/// s_right_link_frame_in_right_arm_frame_1 = mr_right_link_frame_3*sin(q_right_ball)
/// s_right_link_frame_in_right_arm_frame_3 = mr_right_link_frame_3*cos(q_right_ball)
/// s_left_link_frame_in_left_arm_frame_1 = mr_right_link_frame_3*sin(q_left_ball)
/// s_left_link_frame_in_left_arm_frame_3 = mr_right_link_frame_3*cos(q_left_ball)
/// mr_spindle_frame_3 = l*ms*(cos(theta) + cos(theta + q_left_ball))
/// mp_left_arm_frame_3 = 3*l*m + 2*l*mb
/// x_N_3 = s_left_link_frame_in_left_arm_frame_3 + mp_left_arm_frame_3
/// x_N_3_2 = s_right_link_frame_in_right_arm_frame_3 + mp_left_arm_frame_3
/// x_left_arm_frame_in_spindle_frame_3 = s_left_link_frame_in_left_arm_frame_1*sin(theta) - x_N_3*cos(theta)
/// x_N_3_3 = 2*mr_spindle_frame_3 - x_left_arm_frame_in_spindle_frame_3
/// x_right_arm_frame_in_spindle_frame_3 = s_right_link_frame_in_right_arm_frame_1*sin(q_right_top) - x_N_3_2*cos(q_right_top)
/// x_N_3_4 = x_N_3_3 - x_right_arm_frame_in_spindle_frame_3
/// V = -g*x_N_3_4/2
/// ```
#[doc(inline)]
pub use super::code::kane::potential_energy;
