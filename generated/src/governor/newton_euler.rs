//! Flyball governor: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/governor/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (spin', opening', left_end_force1, left_end_force3, right_end_force1, right_end_force3, right_link_force_right_arm_frame1, right_link_force_right_arm_frame2, right_link_force_right_arm_frame3, right_link_torque_right_arm_frame1, right_link_torque_right_arm_frame3, left_link_force_left_arm_frame1, left_link_force_left_arm_frame2, left_link_force_left_arm_frame3, left_link_torque_left_arm_frame1, left_link_torque_left_arm_frame3, right_force_right_arm_frame1, right_force_right_arm_frame2, right_force_right_arm_frame3, left_force_left_arm_frame1, left_force_left_arm_frame2, left_force_left_arm_frame3, sleeve_force_spindle_frame1, sleeve_torque_spindle_frame2, sleeve_torque_spindle_frame3, right_arm_force_spindle_frame1, right_arm_force_spindle_frame2, right_arm_force_spindle_frame3, right_arm_torque_spindle_frame1, right_arm_torque_spindle_frame3, left_arm_force_spindle_frame1, left_arm_force_spindle_frame2, left_arm_force_spindle_frame3, left_arm_torque_spindle_frame1, left_arm_torque_spindle_frame3, spindle_force_n1, spindle_force_n2, spindle_force_n3, spindle_torque_n1, spindle_torque_n2).
//! The kinematic equations are singular where cos(theta + q_left_ball) = 0 and where sin(q_right_ball) = 0.
//! The accelerations divide by 2 pivots, which are positive where the mass matrix is.

pub use super::code::newton_euler::{
    NewtonEuler, constraint_slopes, constraints, divisors, jacobian_product,
};

pub use super::kane::coordinate_rates;

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows spindle force spindle_frame1, spindle force spindle_frame2, spindle force spindle_frame3, spindle moment spindle_frame1, spindle moment spindle_frame2, spindle moment spindle_frame3, left_arm force left_arm_frame1, left_arm force left_arm_frame2, left_arm force left_arm_frame3, left_arm moment left_arm_frame1, left_arm moment left_arm_frame2, left_arm moment left_arm_frame3, right_arm force right_arm_frame1, right_arm force right_arm_frame2, right_arm force right_arm_frame3, right_arm moment right_arm_frame1, right_arm moment right_arm_frame2, right_arm moment right_arm_frame3, left_link force left_link_frame1, left_link force left_link_frame2, left_link force left_link_frame3, left_link moment left_link_frame1, left_link moment left_link_frame2, left_link moment left_link_frame3, right_link force right_link_frame1, right_link force right_link_frame2, right_link force right_link_frame3, right_link moment right_link_frame1, right_link moment right_link_frame2, right_link moment right_link_frame3, sleeve force sleeve_frame1, sleeve force sleeve_frame3, sleeve moment sleeve_frame2, sleeve moment sleeve_frame3, left force n1, left force n2, left force n3, right force n1, right force n2, right force n3. Entries that are not listed are 0.
///
/// 241 operations, 7 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (spin', opening', left_end_force1, left_end_force3, right_end_force1, right_end_force3, right_link_force_right_arm_frame1, right_link_force_right_arm_frame2, right_link_force_right_arm_frame3, right_link_torque_right_arm_frame1, right_link_torque_right_arm_frame3, left_link_force_left_arm_frame1, left_link_force_left_arm_frame2, left_link_force_left_arm_frame3, left_link_torque_left_arm_frame1, left_link_torque_left_arm_frame3, right_force_right_arm_frame1, right_force_right_arm_frame2, right_force_right_arm_frame3, left_force_left_arm_frame1, left_force_left_arm_frame2, left_force_left_arm_frame3, sleeve_force_spindle_frame1, sleeve_torque_spindle_frame2, sleeve_torque_spindle_frame3, right_arm_force_spindle_frame1, right_arm_force_spindle_frame2, right_arm_force_spindle_frame3, right_arm_torque_spindle_frame1, right_arm_torque_spindle_frame3, left_arm_force_spindle_frame1, left_arm_force_spindle_frame2, left_arm_force_spindle_frame3, left_arm_torque_spindle_frame1, left_arm_torque_spindle_frame3, spindle_force_n1, spindle_force_n2, spindle_force_n3, spindle_torque_n1, spindle_torque_n2). Entries that are not listed are 0.
///
/// 290 operations, 7 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::newton_euler::forcing;

/// The accelerations (spin', opening'), solved for when this code was generated.
///
/// 492 operations, 7 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::newton_euler::accelerations;

/// Kinetic energy T.
///
/// 111 operations, 6 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::newton_euler::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// x_left_arm_frame_1_3 = l*m
/// mp_spindle_frame_3 = l*ms*(cos(theta) + cos(theta + q_left_ball))
/// mp_left_arm_frame_3 = 3*l*m + 2*l*mb
/// x_left_link_frame_in_left_arm_frame_1_2 = x_left_arm_frame_1_3*sin(q_left_ball)
/// x_left_link_frame_in_left_arm_frame_3_2 = x_left_arm_frame_1_3*cos(q_left_ball)
/// x_N_3 = mp_left_arm_frame_3 + x_left_link_frame_in_left_arm_frame_3_2
/// x_right_link_frame_in_right_arm_frame_1_2 = x_left_arm_frame_1_3*sin(q_right_ball)
/// x_right_link_frame_in_right_arm_frame_3_2 = x_left_arm_frame_1_3*cos(q_right_ball)
/// x_N_3_2 = mp_left_arm_frame_3 + x_right_link_frame_in_right_arm_frame_3_2
/// x_left_arm_frame_in_spindle_frame_3_6 = x_N_3*cos(theta) - x_left_link_frame_in_left_arm_frame_1_2*sin(theta)
/// x_N_3_3 = 2*mp_spindle_frame_3 + x_left_arm_frame_in_spindle_frame_3_6
/// x_right_arm_frame_in_spindle_frame_3_7 = x_N_3_2*cos(q_right_top) - x_right_link_frame_in_right_arm_frame_1_2*sin(q_right_top)
/// x_N_3_4 = x_N_3_3 + x_right_arm_frame_in_spindle_frame_3_7
/// V = -g*x_N_3_4/2
/// ```
#[doc(inline)]
pub use super::code::newton_euler::potential_energy;
