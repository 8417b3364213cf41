//! Flyball governor: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/governor/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (psi'', theta'', q_right_top'', q_left_ball'', q_right_ball'', lambda_left_end_1, lambda_right_end_1, lambda_right_end_3).
//! The kinematic equations are singular where cos(theta + q_left_ball) = 0 and where sin(q_right_ball) = 0.
//! The accelerations divide by 5 pivots, which are positive where the mass matrix is.

pub use super::code::lagrange::{
    Lagrange, constraint_slopes, constraints, divisors, jacobian_product,
};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows psi, theta, q_right_top, q_left_ball, q_right_ball, constraint left_end_1, constraint right_end_1, constraint right_end_3. Entries that are not listed are 0.
///
/// 129 operations, 6 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::mass_matrix;

/// Right-hand side of the linear system; unknowns (psi'', theta'', q_right_top'', q_left_ball'', q_right_ball'', lambda_left_end_1, lambda_right_end_1, lambda_right_end_3).
///
/// 337 operations, 6 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::forcing;

/// The accelerations (psi'', theta'', q_right_top'', q_left_ball'', q_right_ball''), solved for when this code was generated.
///
/// 529 operations, 6 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// psi'
/// theta'
/// q_right_top'
/// q_left_ball'
/// q_right_ball'
/// ```
#[doc(inline)]
pub use super::code::lagrange::coordinate_rates;

/// Kinetic energy T.
///
/// 99 operations, 5 sines and cosines, step by step: the code names every term.
#[doc(inline)]
pub use super::code::lagrange::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// ```text
/// mp_left_arm_frame_3 = 3*l*m + 2*l*mb
/// mp_left_link_frame_3 = l*m
/// x_right_link_frame_in_right_arm_frame_1 = mp_left_link_frame_3*sin(q_right_ball)
/// x_right_link_frame_in_right_arm_frame_3 = mp_left_link_frame_3*cos(q_right_ball)
/// x_N_3 = mp_left_arm_frame_3 + x_right_link_frame_in_right_arm_frame_3
/// mp_spindle_frame_3 = l*ms*(cos(theta) + cos(theta + q_left_ball))
/// x_left_link_frame_in_left_arm_frame_1 = mp_left_link_frame_3*sin(q_left_ball)
/// x_left_link_frame_in_left_arm_frame_3 = mp_left_link_frame_3*cos(q_left_ball)
/// x_N_3_2 = mp_left_arm_frame_3 + x_left_link_frame_in_left_arm_frame_3
/// x_left_arm_frame_in_spindle_frame_3 = x_N_3_2*cos(theta) - x_left_link_frame_in_left_arm_frame_1*sin(theta)
/// x_N_3_3 = 2*mp_spindle_frame_3 + x_left_arm_frame_in_spindle_frame_3
/// x_right_arm_frame_in_spindle_frame_3 = x_N_3*cos(q_right_top) - x_right_link_frame_in_right_arm_frame_1*sin(q_right_top)
/// x_N_3_4 = x_N_3_3 + x_right_arm_frame_in_spindle_frame_3
/// V = -g*x_N_3_4/2
/// ```
#[doc(inline)]
pub use super::code::lagrange::potential_energy;

/// The generalized speeds u, from q and q'.
///
/// ```text
/// spin = psi'
/// opening = theta'
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speeds;

/// Their time derivatives u', from q, q' and q''.
///
/// ```text
/// spin' = psi''
/// opening' = theta''
/// ```
#[doc(inline)]
pub use super::code::lagrange::generalized_speed_rates;

/// q' from q and the generalized speeds u.
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
pub use super::code::lagrange::motion_variables;
