//! Gyroscope in gimbals: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/gimbals/model.toml`. Do not edit; run `tripos regenerate`.
//! Unknowns: (u_psi', u_theta', u_phi', rotor_torque_inner_frame1, rotor_torque_inner_frame2, inner_torque_outer_frame2, inner_torque_outer_frame3, outer_torque_n1, outer_torque_n2).
//! The kinematic equations are singular nowhere.
//! The accelerations divide by Ax + x_rotor_frame_1_3*cos(phi) + x_rotor_frame_2_3*sin(phi), by Iz + x_inner_frame_2_2*sin(theta) + x_inner_frame_3_2*cos(theta) + alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_2 + alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_2 + (x_rotor_frame_2_2*sin(phi) - x_rotor_frame_1_2*cos(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 - alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax + x_rotor_frame_1_3*cos(phi) + x_rotor_frame_2_3*sin(phi)), by C.

pub use super::code::newton_euler::{NewtonEuler, derivative, jacobian_product};

pub use super::kane::{coordinate_rates, potential_energy};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows outer moment outer_frame1, outer moment outer_frame2, outer moment outer_frame3, inner moment inner_frame1, inner moment inner_frame2, inner moment inner_frame3, rotor moment rotor_frame1, rotor moment rotor_frame2, rotor moment rotor_frame3. Entries that are not listed are 0.
///
/// ```text
/// x_inner_frame_2_2 = Ay*sin(theta)
/// x_inner_frame_3_2 = Az*cos(theta)
/// alpha_inner_frame_in_rotor_frame_1_2 = sin(theta)*sin(phi)
/// x_rotor_frame_1_2 = B*alpha_inner_frame_in_rotor_frame_1_2
/// x_rotor_frame_1_3 = B*cos(phi)
/// alpha_inner_frame_in_rotor_frame_2_2 = sin(theta)*cos(phi)
/// x_rotor_frame_2_2 = B*alpha_inner_frame_in_rotor_frame_2_2
/// x_rotor_frame_2_3 = B*sin(phi)
/// x_rotor_frame_3_2 = C*cos(theta)
/// M18 = -cos(psi)
/// M19 = -sin(psi)
/// M26 = 1
/// M28 = sin(psi)
/// M29 = -cos(psi)
/// M31 = Iz
/// M37 = 1
/// M42 = Ax
/// M44 = 1
/// M55 = 1
/// M56 = -cos(theta)
/// M57 = -sin(theta)
/// M66 = sin(theta)
/// M67 = -cos(theta)
/// M74 = -cos(phi)
/// M75 = -sin(phi)
/// M82 = -x_rotor_frame_2_3
/// M84 = sin(phi)
/// M85 = -cos(phi)
/// M93 = C
/// ```
#[doc(inline)]
pub use super::code::newton_euler::mass_matrix;

/// Right-hand side of the linear system; unknowns (u_psi', u_theta', u_phi', rotor_torque_inner_frame1, rotor_torque_inner_frame2, inner_torque_outer_frame2, inner_torque_outer_frame3, outer_torque_n1, outer_torque_n2). Entries that are not listed are 0.
///
/// ```text
/// w_outer_frame_in_inner_frame_2 = u_psi*sin(theta)
/// w_outer_frame_in_inner_frame_3 = u_psi*cos(theta)
/// H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
/// H_inner_3 = Az*w_outer_frame_in_inner_frame_3
/// x_inner_frame_1 = w_outer_frame_in_inner_frame_2*H_inner_3 - w_outer_frame_in_inner_frame_3*H_inner_2
/// w_inner_frame_13 = u_theta*w_outer_frame_in_inner_frame_3
/// H_inner_1 = Ax*u_theta
/// x_inner_frame_2 = Ay*w_inner_frame_13 - u_theta*H_inner_3 + w_outer_frame_in_inner_frame_3*H_inner_1
/// w_inner_frame_12 = u_theta*w_outer_frame_in_inner_frame_2
/// x_inner_frame_3 = u_theta*H_inner_2 - w_outer_frame_in_inner_frame_2*H_inner_1 - Az*w_inner_frame_12
/// w_inner_frame_in_rotor_frame_2 = u_theta*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
/// w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3
/// H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
/// H_rotor_3 = C*w_rotor_frame_3
/// alpha_inner_frame_in_rotor_frame_1 = w_inner_frame_13*sin(phi)
/// alpha_rotor_frame_1 = u_phi*w_inner_frame_in_rotor_frame_2 - alpha_inner_frame_in_rotor_frame_1
/// x_rotor_frame_1 = w_inner_frame_in_rotor_frame_2*H_rotor_3 - w_rotor_frame_3*H_rotor_2 + B*alpha_rotor_frame_1
/// w_inner_frame_in_rotor_frame_1 = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
/// H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
/// alpha_inner_frame_in_rotor_frame_2 = w_inner_frame_13*cos(phi)
/// alpha_rotor_frame_2 = u_phi*w_inner_frame_in_rotor_frame_1 - alpha_inner_frame_in_rotor_frame_2
/// x_rotor_frame_2 = w_rotor_frame_3*H_rotor_1 - H_rotor_3*w_inner_frame_in_rotor_frame_1 - B*alpha_rotor_frame_2
/// x_rotor_frame_3 = C*w_inner_frame_12 + H_rotor_2*w_inner_frame_in_rotor_frame_1 - w_inner_frame_in_rotor_frame_2*H_rotor_1
/// f4 = -x_inner_frame_1
/// f5 = -x_inner_frame_2
/// f6 = -x_inner_frame_3
/// f8 = -x_rotor_frame_2
/// ```
#[doc(inline)]
pub use super::code::newton_euler::forcing;

/// The accelerations (u_psi', u_theta', u_phi'), solved for when this code was generated.
///
/// ```text
/// w_outer_frame_in_inner_frame_2 = u_psi*sin(theta)
/// w_outer_frame_in_inner_frame_3 = u_psi*cos(theta)
/// H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
/// H_inner_3 = Az*w_outer_frame_in_inner_frame_3
/// x_inner_frame_1 = w_outer_frame_in_inner_frame_2*H_inner_3 - w_outer_frame_in_inner_frame_3*H_inner_2
/// w_inner_frame_13 = u_theta*w_outer_frame_in_inner_frame_3
/// H_inner_1 = Ax*u_theta
/// x_inner_frame_2 = Ay*w_inner_frame_13 - u_theta*H_inner_3 + w_outer_frame_in_inner_frame_3*H_inner_1
/// w_inner_frame_12 = u_theta*w_outer_frame_in_inner_frame_2
/// x_inner_frame_3 = u_theta*H_inner_2 - w_outer_frame_in_inner_frame_2*H_inner_1 - Az*w_inner_frame_12
/// w_inner_frame_in_rotor_frame_2 = u_theta*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
/// w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3
/// H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
/// H_rotor_3 = C*w_rotor_frame_3
/// alpha_inner_frame_in_rotor_frame_1 = w_inner_frame_13*sin(phi)
/// alpha_rotor_frame_1 = u_phi*w_inner_frame_in_rotor_frame_2 - alpha_inner_frame_in_rotor_frame_1
/// x_rotor_frame_1 = w_inner_frame_in_rotor_frame_2*H_rotor_3 - w_rotor_frame_3*H_rotor_2 + B*alpha_rotor_frame_1
/// w_inner_frame_in_rotor_frame_1 = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
/// H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
/// alpha_inner_frame_in_rotor_frame_2 = w_inner_frame_13*cos(phi)
/// alpha_rotor_frame_2 = u_phi*w_inner_frame_in_rotor_frame_1 - alpha_inner_frame_in_rotor_frame_2
/// x_rotor_frame_2 = w_rotor_frame_3*H_rotor_1 - H_rotor_3*w_inner_frame_in_rotor_frame_1 - B*alpha_rotor_frame_2
/// x_rotor_frame_3 = C*w_inner_frame_12 + H_rotor_2*w_inner_frame_in_rotor_frame_1 - w_inner_frame_in_rotor_frame_2*H_rotor_1
/// x_inner_frame_2_2 = Ay*sin(theta)
/// x_inner_frame_3_2 = Az*cos(theta)
/// alpha_inner_frame_in_rotor_frame_1_2 = sin(theta)*sin(phi)
/// x_rotor_frame_1_2 = B*alpha_inner_frame_in_rotor_frame_1_2
/// x_rotor_frame_1_3 = B*cos(phi)
/// alpha_inner_frame_in_rotor_frame_2_2 = sin(theta)*cos(phi)
/// x_rotor_frame_2_2 = B*alpha_inner_frame_in_rotor_frame_2_2
/// x_rotor_frame_2_3 = B*sin(phi)
/// x_rotor_frame_3_2 = C*cos(theta)
/// u_psi' = (x_rotor_frame_1*alpha_inner_frame_in_rotor_frame_1_2 - x_inner_frame_2*sin(theta) - x_inner_frame_3*cos(theta) -
///     x_rotor_frame_2*alpha_inner_frame_in_rotor_frame_2_2 - (x_rotor_frame_1*cos(phi) - x_inner_frame_1 +
///     x_rotor_frame_2*sin(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 - alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax +
///     x_rotor_frame_1_3*cos(phi) + x_rotor_frame_2_3*sin(phi)))/(Iz + x_inner_frame_2_2*sin(theta) + x_inner_frame_3_2*cos(theta) +
///     alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_2 + alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_2 + (x_rotor_frame_2_2*sin(phi) -
///     x_rotor_frame_1_2*cos(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 - alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax +
///     x_rotor_frame_1_3*cos(phi) + x_rotor_frame_2_3*sin(phi)))
/// u_theta' = (x_rotor_frame_1*cos(phi) - x_inner_frame_1 + x_rotor_frame_2*sin(phi) - u_psi'*(x_rotor_frame_1_2*cos(phi) - x_rotor_frame_2_2*sin(phi)))/(Ax +
///     x_rotor_frame_1_3*cos(phi) + x_rotor_frame_2_3*sin(phi))
/// u_phi' = (x_rotor_frame_3 - u_psi'*x_rotor_frame_3_2)/C
/// ```
#[doc(inline)]
pub use super::code::newton_euler::accelerations;

/// Kinetic energy T.
///
/// ```text
/// w_outer_frame_in_inner_frame_2 = u_psi*sin(theta)
/// w_outer_frame_in_inner_frame_3 = u_psi*cos(theta)
/// H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
/// H_inner_3 = Az*w_outer_frame_in_inner_frame_3
/// H_inner_1 = Ax*u_theta
/// w_inner_frame_in_rotor_frame_2 = u_theta*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
/// w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3
/// H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
/// H_rotor_3 = C*w_rotor_frame_3
/// w_inner_frame_in_rotor_frame_1 = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
/// H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
/// H_outer_3 = Iz*u_psi
/// T = w_outer_frame_in_inner_frame_2*H_inner_2/2 + w_outer_frame_in_inner_frame_3*H_inner_3/2 + u_theta*H_inner_1/2 + w_inner_frame_in_rotor_frame_2*H_rotor_2/2 +
///     w_rotor_frame_3*H_rotor_3/2 + w_inner_frame_in_rotor_frame_1*H_rotor_1/2 + u_psi*H_outer_3/2
/// ```
#[doc(inline)]
pub use super::code::newton_euler::kinetic_energy;
