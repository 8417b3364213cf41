//! Gyroscope in gimbals: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/gimbals/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u_psi', u_theta', u_phi').
//! The kinematic equations are singular nowhere.
//! The accelerations divide by C, by K_u_psi_dot, by J_inner_frame_11.

pub use super::code::kane::{Kane, derivative, inverse_dynamics, jacobian_product};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u_psi, u_theta, u_phi. Entries that are not listed are 0.
///
/// ```text
/// J_inner_frame_22 = Ay + B
/// J_inner_frame_33 = Az + C
/// J_inner_frame_in_outer_frame_23 = J_inner_frame_22 - J_inner_frame_33
/// J_inner_frame_in_outer_frame = J_inner_frame_in_outer_frame_23*sin(theta)
/// J_inner_frame_in_outer_frame_2 = J_inner_frame_in_outer_frame*sin(theta)
/// J_inner_frame_in_outer_frame_33 = J_inner_frame_33 + J_inner_frame_in_outer_frame_2
/// J_outer_frame_33 = Iz + J_inner_frame_in_outer_frame_33
/// h_rotor_frame_in_inner_frame_3 = C*cos(theta)
/// J_inner_frame_11 = Ax + B
/// M33 = C
/// ```
#[doc(inline)]
pub use super::code::kane::mass_matrix;

/// Right-hand side of the linear system; unknowns (u_psi', u_theta', u_phi').
///
/// ```text
/// w_outer_frame_in_inner_frame_2 = u_psi*sin(theta)
/// w_outer_frame_in_inner_frame_3 = u_psi*cos(theta)
/// w_inner_frame_in_rotor_frame_1 = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
/// w_inner_frame_in_rotor_frame_2 = u_theta*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
/// w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3
/// alpha_inner_frame_2 = u_theta*w_outer_frame_in_inner_frame_3
/// alpha_inner_frame_3 = u_theta*w_outer_frame_in_inner_frame_2
/// alpha_inner_frame_in_rotor_frame_1 = u_theta*w_outer_frame_in_inner_frame_3*sin(phi)
/// alpha_inner_frame_in_rotor_frame_2 = u_theta*w_outer_frame_in_inner_frame_3*cos(phi)
/// alpha_rotor_frame_1 = u_phi*w_inner_frame_in_rotor_frame_2 - alpha_inner_frame_in_rotor_frame_1
/// alpha_rotor_frame_2 = u_phi*w_inner_frame_in_rotor_frame_1 - alpha_inner_frame_in_rotor_frame_2
/// H_inner_1 = Ax*u_theta
/// H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
/// H_inner_3 = Az*w_outer_frame_in_inner_frame_3
/// H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
/// H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
/// H_rotor_3 = C*w_rotor_frame_3
/// F_w_rotor_frame_3 = C*alpha_inner_frame_3 - w_inner_frame_in_rotor_frame_2*H_rotor_1 + w_inner_frame_in_rotor_frame_1*H_rotor_2
/// F_w_inner_frame_in_rotor_frame_2 = w_rotor_frame_3*H_rotor_1 - B*alpha_rotor_frame_2 - w_inner_frame_in_rotor_frame_1*H_rotor_3
/// F_w_inner_frame_in_rotor_frame_1 = B*alpha_rotor_frame_1 - w_rotor_frame_3*H_rotor_2 + w_inner_frame_in_rotor_frame_2*H_rotor_3
/// F_w_outer_frame_in_inner_frame_3 = u_theta*H_inner_2 - Az*alpha_inner_frame_3 - w_outer_frame_in_inner_frame_2*H_inner_1 - F_w_rotor_frame_3
/// F_w_outer_frame_in_inner_frame_2 = Ay*alpha_inner_frame_2 + w_outer_frame_in_inner_frame_3*H_inner_1 - u_theta*H_inner_3 +
///     F_w_inner_frame_in_rotor_frame_2*cos(phi) - F_w_inner_frame_in_rotor_frame_1*sin(phi)
/// f1 = -F_w_outer_frame_in_inner_frame_3*cos(theta) - F_w_outer_frame_in_inner_frame_2*sin(theta)
/// f2 = w_outer_frame_in_inner_frame_3*H_inner_2 - w_outer_frame_in_inner_frame_2*H_inner_3 + F_w_inner_frame_in_rotor_frame_2*sin(phi) +
///     F_w_inner_frame_in_rotor_frame_1*cos(phi)
/// ```
#[doc(inline)]
pub use super::code::kane::forcing;

/// The accelerations (u_psi', u_theta', u_phi'), solved for when this code was generated.
///
/// ```text
/// w_outer_frame_in_inner_frame_2 = u_psi*sin(theta)
/// w_outer_frame_in_inner_frame_3 = u_psi*cos(theta)
/// w_inner_frame_in_rotor_frame_1 = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
/// w_inner_frame_in_rotor_frame_2 = u_theta*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
/// w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3
/// H_inner_1 = Ax*u_theta
/// H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
/// H_inner_3 = Az*w_outer_frame_in_inner_frame_3
/// H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
/// H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
/// H_rotor_3 = C*w_rotor_frame_3
/// J_inner_frame_22 = Ay + B
/// b_alpha_rotor_frame_2_2 = w_rotor_frame_3*H_rotor_1 - w_inner_frame_in_rotor_frame_1*H_rotor_3
/// b = b_alpha_rotor_frame_2_2 - B*u_phi*w_inner_frame_in_rotor_frame_1
/// b_alpha_rotor_frame_1_2 = w_inner_frame_in_rotor_frame_2*H_rotor_3 - w_rotor_frame_3*H_rotor_2
/// b_2 = B*u_phi*w_inner_frame_in_rotor_frame_2 + b_alpha_rotor_frame_1_2
/// b_alpha_inner_frame_3_2 = u_theta*H_inner_2 - w_outer_frame_in_inner_frame_2*H_inner_1
/// b_3 = b_alpha_inner_frame_3_2 - Az*u_theta*w_outer_frame_in_inner_frame_2
/// b_alpha_inner_frame_2_2 = w_outer_frame_in_inner_frame_3*H_inner_1 - u_theta*H_inner_3 + b*cos(phi) - b_2*sin(phi)
/// b_4 = u_theta*w_outer_frame_in_inner_frame_3*J_inner_frame_22 + b_alpha_inner_frame_2_2
/// b_u_psi_dot = b_3*cos(theta) + b_4*sin(theta)
/// K_u_psi_dot = Iz + Az*cos(theta)^2 + J_inner_frame_22*sin(theta)^2
/// over_D_u_psi_dot = 1/K_u_psi_dot
/// G_u_psi_dot = b_u_psi_dot*over_D_u_psi_dot
/// u_psi' = -G_u_psi_dot
/// J_inner_frame_11 = Ax + B
/// b_u_theta_dot = w_outer_frame_in_inner_frame_2*H_inner_3 - w_outer_frame_in_inner_frame_3*H_inner_2 - b*sin(phi) - b_2*cos(phi)
/// over_D_u_theta_dot = 1/J_inner_frame_11
/// G_u_theta_dot = b_u_theta_dot*over_D_u_theta_dot
/// u_theta' = -G_u_theta_dot
/// b_alpha_rotor_frame_3 = w_inner_frame_in_rotor_frame_1*H_rotor_2 - w_inner_frame_in_rotor_frame_2*H_rotor_1
/// over_D_alpha_rotor_frame_3 = 1/C
/// G_alpha_rotor_frame_3 = b_alpha_rotor_frame_3*over_D_alpha_rotor_frame_3
/// alpha_rotor_frame_3 = G_alpha_rotor_frame_3
/// alpha_outer_frame_in_inner_frame_3 = u_psi'*cos(theta)
/// alpha_inner_frame_3_2 = u_theta*w_outer_frame_in_inner_frame_2 - alpha_outer_frame_in_inner_frame_3
/// u_phi' = alpha_inner_frame_3_2 + alpha_rotor_frame_3
/// ```
#[doc(inline)]
pub use super::code::kane::accelerations;

/// Kinematic equations: the time derivatives of the coordinates.
///
/// ```text
/// psi' = u_psi
/// theta' = u_theta
/// phi' = u_phi
/// ```
#[doc(inline)]
pub use super::code::kane::coordinate_rates;

/// Kinetic energy T.
///
/// ```text
/// w_outer_frame_in_inner_frame_2 = u_psi*sin(theta)
/// w_outer_frame_in_inner_frame_3 = u_psi*cos(theta)
/// w_inner_frame_in_rotor_frame_1 = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
/// w_inner_frame_in_rotor_frame_2 = u_theta*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
/// w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3
/// H_inner_1 = Ax*u_theta
/// H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
/// H_inner_3 = Az*w_outer_frame_in_inner_frame_3
/// H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
/// H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
/// H_rotor_3 = C*w_rotor_frame_3
/// H_outer_3 = Iz*u_psi
/// T = u_theta*H_inner_1/2 + w_outer_frame_in_inner_frame_2*H_inner_2/2 + w_outer_frame_in_inner_frame_3*H_inner_3/2 + w_inner_frame_in_rotor_frame_1*H_rotor_1/2 +
///     w_inner_frame_in_rotor_frame_2*H_rotor_2/2 + w_rotor_frame_3*H_rotor_3/2 + u_psi*H_outer_3/2
/// ```
#[doc(inline)]
pub use super::code::kane::kinetic_energy;

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// All entries are 0.
#[doc(inline)]
pub use super::code::kane::potential_energy;
