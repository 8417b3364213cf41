//! Gyroscope in gimbals: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/gimbals/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u_psi, u_theta, u_phi.
///
/// 9 operations, 1 sine and cosine.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    _u: &[S; 3],
) -> [[S; 3]; 3] {
    let Parameters { Iz, Ax, Ay, Az, B, C, .. } = *p;
    let [_, theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // J_inner_frame_22 = Ay + B
    let J_inner_frame_22 = Ay + B;
    // J_inner_frame_33 = Az + C
    let J_inner_frame_33 = Az + C;
    // J_inner_frame_in_outer_frame_23 = J_inner_frame_22 - J_inner_frame_33
    let J_inner_frame_in_outer_frame_23 = J_inner_frame_22 - J_inner_frame_33;
    // J_inner_frame_in_outer_frame = J_inner_frame_in_outer_frame_23*sin(theta)
    let J_inner_frame_in_outer_frame = J_inner_frame_in_outer_frame_23 * sin_theta;
    // J_inner_frame_in_outer_frame_2 = J_inner_frame_in_outer_frame*sin(theta)
    let J_inner_frame_in_outer_frame_2 = J_inner_frame_in_outer_frame * sin_theta;
    // J_inner_frame_in_outer_frame_33 = J_inner_frame_33 + J_inner_frame_in_outer_frame_2
    let J_inner_frame_in_outer_frame_33 = J_inner_frame_33 + J_inner_frame_in_outer_frame_2;
    // J_outer_frame_33 = Iz + J_inner_frame_in_outer_frame_33
    let J_outer_frame_33 = Iz + J_inner_frame_in_outer_frame_33;
    // h_rotor_frame_in_inner_frame_3 = C*cos(theta)
    let h_rotor_frame_in_inner_frame_3 = C * cos_theta;
    // J_inner_frame_11 = Ax + B
    let J_inner_frame_11 = Ax + B;
    // Entries that are not zero; upper triangle.
    // M33 = C
    let m33 = C;
    let zero = S::int(0);
    [
        [J_outer_frame_33, zero, h_rotor_frame_in_inner_frame_3],
        [zero, J_inner_frame_11, zero],
        [h_rotor_frame_in_inner_frame_3, zero, m33],
    ]
}

/// Right-hand side of the linear system; unknowns (u_psi', u_theta', u_phi').
///
/// 64 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 3]) -> [S; 3] {
    let Parameters { Ax, Ay, Az, B, C, .. } = *p;
    let [_, theta, phi] = *q;
    let [u_psi, u_theta, u_phi] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w_outer_frame_in_inner_frame_2 = u_psi*sin(theta)
    let w_outer_frame_in_inner_frame_2 = u_psi * sin_theta;
    // w_outer_frame_in_inner_frame_3 = u_psi*cos(theta)
    let w_outer_frame_in_inner_frame_3 = u_psi * cos_theta;
    // w_inner_frame_in_rotor_frame_1 = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1 = w_outer_frame_in_inner_frame_2
        .mul_add(sin_phi, u_theta * cos_phi);
    // w_inner_frame_in_rotor_frame_2 = u_theta*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(cos_phi, u_theta * sin_phi);
    // w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3
    let w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3;
    // alpha_inner_frame_2 = u_theta*w_outer_frame_in_inner_frame_3
    let alpha_inner_frame_2 = u_theta * w_outer_frame_in_inner_frame_3;
    // alpha_inner_frame_3 = u_theta*w_outer_frame_in_inner_frame_2
    let alpha_inner_frame_3 = u_theta * w_outer_frame_in_inner_frame_2;
    // alpha_inner_frame_in_rotor_frame_1 = u_theta*w_outer_frame_in_inner_frame_3*sin(phi)
    let alpha_inner_frame_in_rotor_frame_1 = alpha_inner_frame_2 * sin_phi;
    // alpha_inner_frame_in_rotor_frame_2 = u_theta*w_outer_frame_in_inner_frame_3*cos(phi)
    let alpha_inner_frame_in_rotor_frame_2 = alpha_inner_frame_2 * cos_phi;
    // alpha_rotor_frame_1 = u_phi*w_inner_frame_in_rotor_frame_2 - alpha_inner_frame_in_rotor_frame_1
    let alpha_rotor_frame_1 = u_phi
        .mul_add(w_inner_frame_in_rotor_frame_2, -alpha_inner_frame_in_rotor_frame_1);
    // alpha_rotor_frame_2 = u_phi*w_inner_frame_in_rotor_frame_1 - alpha_inner_frame_in_rotor_frame_2
    let alpha_rotor_frame_2 = u_phi
        .mul_add(w_inner_frame_in_rotor_frame_1, -alpha_inner_frame_in_rotor_frame_2);
    // H_inner_1 = Ax*u_theta
    let H_inner_1 = Ax * u_theta;
    // H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
    let H_inner_2 = Ay * w_outer_frame_in_inner_frame_2;
    // H_inner_3 = Az*w_outer_frame_in_inner_frame_3
    let H_inner_3 = Az * w_outer_frame_in_inner_frame_3;
    // H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
    let H_rotor_1 = B * w_inner_frame_in_rotor_frame_1;
    // H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
    let H_rotor_2 = B * w_inner_frame_in_rotor_frame_2;
    // H_rotor_3 = C*w_rotor_frame_3
    let H_rotor_3 = C * w_rotor_frame_3;
    // F_w_rotor_frame_3 = C*alpha_inner_frame_3 - w_inner_frame_in_rotor_frame_2*H_rotor_1 +
    //   w_inner_frame_in_rotor_frame_1*H_rotor_2
    let F_w_rotor_frame_3 = (-w_inner_frame_in_rotor_frame_2)
        .mul_add(H_rotor_1, C * alpha_inner_frame_3) + w_inner_frame_in_rotor_frame_1 * H_rotor_2;
    // F_w_inner_frame_in_rotor_frame_2 = w_rotor_frame_3*H_rotor_1 - B*alpha_rotor_frame_2 -
    //   w_inner_frame_in_rotor_frame_1*H_rotor_3
    let F_w_inner_frame_in_rotor_frame_2 = (-B)
        .mul_add(alpha_rotor_frame_2, w_rotor_frame_3 * H_rotor_1)
        - w_inner_frame_in_rotor_frame_1 * H_rotor_3;
    // F_w_inner_frame_in_rotor_frame_1 = B*alpha_rotor_frame_1 - w_rotor_frame_3*H_rotor_2 +
    //   w_inner_frame_in_rotor_frame_2*H_rotor_3
    let F_w_inner_frame_in_rotor_frame_1 = (-w_rotor_frame_3)
        .mul_add(H_rotor_2, B * alpha_rotor_frame_1) + w_inner_frame_in_rotor_frame_2 * H_rotor_3;
    // F_w_outer_frame_in_inner_frame_3 = u_theta*H_inner_2 - Az*alpha_inner_frame_3 -
    //   w_outer_frame_in_inner_frame_2*H_inner_1 - F_w_rotor_frame_3
    let F_w_outer_frame_in_inner_frame_3 = (-Az)
        .mul_add(alpha_inner_frame_3, u_theta * H_inner_2)
        - w_outer_frame_in_inner_frame_2 * H_inner_1 - F_w_rotor_frame_3;
    // F_w_outer_frame_in_inner_frame_2 = Ay*alpha_inner_frame_2 + w_outer_frame_in_inner_frame_3*H_inner_1
    //   - u_theta*H_inner_3 + F_w_inner_frame_in_rotor_frame_2*cos(phi) -
    //   F_w_inner_frame_in_rotor_frame_1*sin(phi)
    let F_w_outer_frame_in_inner_frame_2 = w_outer_frame_in_inner_frame_3
        .mul_add(H_inner_1, Ay * alpha_inner_frame_2) - u_theta * H_inner_3
        + F_w_inner_frame_in_rotor_frame_2 * cos_phi - F_w_inner_frame_in_rotor_frame_1 * sin_phi;
    // Values.
    // f1 = -F_w_outer_frame_in_inner_frame_3*cos(theta) - F_w_outer_frame_in_inner_frame_2*sin(theta)
    let f1 = (-F_w_outer_frame_in_inner_frame_2)
        .mul_add(sin_theta, -F_w_outer_frame_in_inner_frame_3 * cos_theta);
    // f2 = w_outer_frame_in_inner_frame_3*H_inner_2 - w_outer_frame_in_inner_frame_2*H_inner_3 +
    //   F_w_inner_frame_in_rotor_frame_2*sin(phi) + F_w_inner_frame_in_rotor_frame_1*cos(phi)
    let f2 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(H_inner_3, w_outer_frame_in_inner_frame_3 * H_inner_2)
        + F_w_inner_frame_in_rotor_frame_2 * sin_phi + F_w_inner_frame_in_rotor_frame_1 * cos_phi;
    [f1, f2, F_w_rotor_frame_3]
}

/// The accelerations (u_psi', u_theta', u_phi'), solved for when this code was generated.
///
/// 72 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 3]) -> [S; 3] {
    let Parameters { Iz, Ax, Ay, Az, B, C, .. } = *p;
    let [_, theta, phi] = *q;
    let [u_psi, u_theta, u_phi] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w_outer_frame_in_inner_frame_2 = u_psi*sin(theta)
    let w_outer_frame_in_inner_frame_2 = u_psi * sin_theta;
    // w_outer_frame_in_inner_frame_3 = u_psi*cos(theta)
    let w_outer_frame_in_inner_frame_3 = u_psi * cos_theta;
    // w_inner_frame_in_rotor_frame_1 = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1 = w_outer_frame_in_inner_frame_2
        .mul_add(sin_phi, u_theta * cos_phi);
    // w_inner_frame_in_rotor_frame_2 = u_theta*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(cos_phi, u_theta * sin_phi);
    // w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3
    let w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3;
    // H_inner_1 = Ax*u_theta
    let H_inner_1 = Ax * u_theta;
    // H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
    let H_inner_2 = Ay * w_outer_frame_in_inner_frame_2;
    // H_inner_3 = Az*w_outer_frame_in_inner_frame_3
    let H_inner_3 = Az * w_outer_frame_in_inner_frame_3;
    // H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
    let H_rotor_1 = B * w_inner_frame_in_rotor_frame_1;
    // H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
    let H_rotor_2 = B * w_inner_frame_in_rotor_frame_2;
    // H_rotor_3 = C*w_rotor_frame_3
    let H_rotor_3 = C * w_rotor_frame_3;
    // J_inner_frame_22 = Ay + B
    let J_inner_frame_22 = Ay + B;
    // b_alpha_rotor_frame_2_2 = w_rotor_frame_3*H_rotor_1 - w_inner_frame_in_rotor_frame_1*H_rotor_3
    let b_alpha_rotor_frame_2_2 = (-w_inner_frame_in_rotor_frame_1)
        .mul_add(H_rotor_3, w_rotor_frame_3 * H_rotor_1);
    // b = b_alpha_rotor_frame_2_2 - B*u_phi*w_inner_frame_in_rotor_frame_1
    let b = (-u_phi).mul_add(H_rotor_1, b_alpha_rotor_frame_2_2);
    // b_alpha_rotor_frame_1_2 = w_inner_frame_in_rotor_frame_2*H_rotor_3 - w_rotor_frame_3*H_rotor_2
    let b_alpha_rotor_frame_1_2 = (-w_rotor_frame_3)
        .mul_add(H_rotor_2, w_inner_frame_in_rotor_frame_2 * H_rotor_3);
    // b_2 = B*u_phi*w_inner_frame_in_rotor_frame_2 + b_alpha_rotor_frame_1_2
    let b_2 = u_phi.mul_add(H_rotor_2, b_alpha_rotor_frame_1_2);
    // b_alpha_inner_frame_3_2 = u_theta*H_inner_2 - w_outer_frame_in_inner_frame_2*H_inner_1
    let b_alpha_inner_frame_3_2 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(H_inner_1, u_theta * H_inner_2);
    let b_3_of_u_theta = u_theta * w_outer_frame_in_inner_frame_2;
    // b_3 = b_alpha_inner_frame_3_2 - Az*u_theta*w_outer_frame_in_inner_frame_2
    let b_3 = (-Az).mul_add(b_3_of_u_theta, b_alpha_inner_frame_3_2);
    // b_alpha_inner_frame_2_2 = w_outer_frame_in_inner_frame_3*H_inner_1 - u_theta*H_inner_3 + b*cos(phi)
    //   - b_2*sin(phi)
    let b_alpha_inner_frame_2_2 = (-u_theta)
        .mul_add(H_inner_3, w_outer_frame_in_inner_frame_3 * H_inner_1) + b * cos_phi
        - b_2 * sin_phi;
    // b_4 = u_theta*w_outer_frame_in_inner_frame_3*J_inner_frame_22 + b_alpha_inner_frame_2_2
    let b_4 = (u_theta * w_outer_frame_in_inner_frame_3)
        .mul_add(J_inner_frame_22, b_alpha_inner_frame_2_2);
    // b_u_psi_dot = b_3*cos(theta) + b_4*sin(theta)
    let b_u_psi_dot = b_4.mul_add(sin_theta, b_3 * cos_theta);
    // K_u_psi_dot = Iz + Az*cos(theta)^2 + J_inner_frame_22*sin(theta)^2
    let K_u_psi_dot = Iz + J_inner_frame_22 + cos_theta * cos_theta * (Az - J_inner_frame_22);
    // over_D_u_psi_dot = 1/K_u_psi_dot
    let over_D_u_psi_dot = S::int(1) / K_u_psi_dot;
    // G_u_psi_dot = b_u_psi_dot*over_D_u_psi_dot
    let G_u_psi_dot = b_u_psi_dot * over_D_u_psi_dot;
    // u_psi' = -G_u_psi_dot
    let u_psi_dot = -G_u_psi_dot;
    // J_inner_frame_11 = Ax + B
    let J_inner_frame_11 = Ax + B;
    // b_u_theta_dot = w_outer_frame_in_inner_frame_2*H_inner_3 - w_outer_frame_in_inner_frame_3*H_inner_2
    //   - b*sin(phi) - b_2*cos(phi)
    let b_u_theta_dot = (-w_outer_frame_in_inner_frame_3)
        .mul_add(H_inner_2, w_outer_frame_in_inner_frame_2 * H_inner_3) - b * sin_phi
        - b_2 * cos_phi;
    // over_D_u_theta_dot = 1/J_inner_frame_11
    let over_D_u_theta_dot = S::int(1) / J_inner_frame_11;
    // G_u_theta_dot = b_u_theta_dot*over_D_u_theta_dot
    let G_u_theta_dot = b_u_theta_dot * over_D_u_theta_dot;
    // u_theta' = -G_u_theta_dot
    let u_theta_dot = -G_u_theta_dot;
    // b_alpha_rotor_frame_3 = w_inner_frame_in_rotor_frame_1*H_rotor_2 -
    //   w_inner_frame_in_rotor_frame_2*H_rotor_1
    let b_alpha_rotor_frame_3 = (-w_inner_frame_in_rotor_frame_2)
        .mul_add(H_rotor_1, w_inner_frame_in_rotor_frame_1 * H_rotor_2);
    // over_D_alpha_rotor_frame_3 = 1/C
    let over_D_alpha_rotor_frame_3 = S::int(1) / C;
    // G_alpha_rotor_frame_3 = b_alpha_rotor_frame_3*over_D_alpha_rotor_frame_3
    let G_alpha_rotor_frame_3 = b_alpha_rotor_frame_3 * over_D_alpha_rotor_frame_3;
    // alpha_rotor_frame_3 = G_alpha_rotor_frame_3
    let alpha_rotor_frame_3 = G_alpha_rotor_frame_3;
    // alpha_outer_frame_in_inner_frame_3 = u_psi'*cos(theta)
    let alpha_outer_frame_in_inner_frame_3 = u_psi_dot * cos_theta;
    // alpha_inner_frame_3_2 = u_theta*w_outer_frame_in_inner_frame_2 - alpha_outer_frame_in_inner_frame_3
    let alpha_inner_frame_3_2 = b_3_of_u_theta - alpha_outer_frame_in_inner_frame_3;
    // u_phi' = alpha_inner_frame_3_2 + alpha_rotor_frame_3
    let u_phi_dot = alpha_inner_frame_3_2 + alpha_rotor_frame_3;
    [u_psi_dot, u_theta_dot, u_phi_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 3],
    u: &[S; 3],
) -> [S; 3] {
    let [u_psi, u_theta, u_phi] = *u;
    // Values.
    // psi' = u_psi
    let psi_dot_value = u_psi;
    // theta' = u_theta
    let theta_dot_value = u_theta;
    // phi' = u_phi
    let phi_dot_value = u_phi;
    [psi_dot_value, theta_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 30 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 3]) -> S {
    let Parameters { Iz, Ax, Ay, Az, B, C, .. } = *p;
    let [_, theta, phi] = *q;
    let [u_psi, u_theta, u_phi] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w_outer_frame_in_inner_frame_2 = u_psi*sin(theta)
    let w_outer_frame_in_inner_frame_2 = u_psi * sin_theta;
    // w_outer_frame_in_inner_frame_3 = u_psi*cos(theta)
    let w_outer_frame_in_inner_frame_3 = u_psi * cos_theta;
    // w_inner_frame_in_rotor_frame_1 = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1 = w_outer_frame_in_inner_frame_2
        .mul_add(sin_phi, u_theta * cos_phi);
    // w_inner_frame_in_rotor_frame_2 = u_theta*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(cos_phi, u_theta * sin_phi);
    // w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3
    let w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3;
    // H_inner_1 = Ax*u_theta
    let H_inner_1 = Ax * u_theta;
    // H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
    let H_inner_2 = Ay * w_outer_frame_in_inner_frame_2;
    // H_inner_3 = Az*w_outer_frame_in_inner_frame_3
    let H_inner_3 = Az * w_outer_frame_in_inner_frame_3;
    // H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
    let H_rotor_1 = B * w_inner_frame_in_rotor_frame_1;
    // H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
    let H_rotor_2 = B * w_inner_frame_in_rotor_frame_2;
    // H_rotor_3 = C*w_rotor_frame_3
    let H_rotor_3 = C * w_rotor_frame_3;
    // H_outer_3 = Iz*u_psi
    let H_outer_3 = Iz * u_psi;
    // u_theta*H_inner_1 + u_psi*H_outer_3
    let energy_of_motion = u_psi.mul_add(H_outer_3, u_theta * H_inner_1);
    // w_outer_frame_in_inner_frame_2*H_inner_2 + w_outer_frame_in_inner_frame_3*H_inner_3
    let energy_of_place = w_outer_frame_in_inner_frame_3
        .mul_add(H_inner_3, w_outer_frame_in_inner_frame_2 * H_inner_2);
    // w_inner_frame_in_rotor_frame_1*H_rotor_1 + w_inner_frame_in_rotor_frame_2*H_rotor_2
    let energy_of_place_2 = w_inner_frame_in_rotor_frame_2
        .mul_add(H_rotor_2, w_inner_frame_in_rotor_frame_1 * H_rotor_1);
    // w_rotor_frame_3*H_rotor_3 + energy_of_motion
    let energy_of_motion_2 = w_rotor_frame_3.mul_add(H_rotor_3, energy_of_motion);
    // energy_of_place + energy_of_place_2
    let energy_of_place_3 = energy_of_place + energy_of_place_2;
    // energy_of_motion_2 + energy_of_place_3
    let energy_of_motion_3 = energy_of_motion_2 + energy_of_place_3;
    // Values.
    // T = u_theta*H_inner_1/2 + w_outer_frame_in_inner_frame_2*H_inner_2/2 +
    //   w_outer_frame_in_inner_frame_3*H_inner_3/2 + w_inner_frame_in_rotor_frame_1*H_rotor_1/2 +
    //   w_inner_frame_in_rotor_frame_2*H_rotor_2/2 + w_rotor_frame_3*H_rotor_3/2 + u_psi*H_outer_3/2
    let energy = S::ratio(1, 2) * energy_of_motion_3;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 0 operations.
#[must_use]
pub fn potential_energy<S: Scalar>(_p: &Parameters<S>, _q: &[S; 3]) -> S {
    let zero = S::int(0);
    zero
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 72 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 3],
) -> ([S; 3], [S; 3]) {
    let Parameters { Iz, Ax, Ay, Az, B, C, .. } = *p;
    let [_, theta, phi] = *q;
    let [u_psi, u_theta, u_phi] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w_outer_frame_in_inner_frame_2 = u_psi*sin(theta)
    let w_outer_frame_in_inner_frame_2 = u_psi * sin_theta;
    // w_outer_frame_in_inner_frame_3 = u_psi*cos(theta)
    let w_outer_frame_in_inner_frame_3 = u_psi * cos_theta;
    // w_inner_frame_in_rotor_frame_1 = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1 = w_outer_frame_in_inner_frame_2
        .mul_add(sin_phi, u_theta * cos_phi);
    // w_inner_frame_in_rotor_frame_2 = u_theta*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(cos_phi, u_theta * sin_phi);
    // w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3
    let w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3;
    // H_inner_1 = Ax*u_theta
    let H_inner_1 = Ax * u_theta;
    // H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
    let H_inner_2 = Ay * w_outer_frame_in_inner_frame_2;
    // H_inner_3 = Az*w_outer_frame_in_inner_frame_3
    let H_inner_3 = Az * w_outer_frame_in_inner_frame_3;
    // H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
    let H_rotor_1 = B * w_inner_frame_in_rotor_frame_1;
    // H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
    let H_rotor_2 = B * w_inner_frame_in_rotor_frame_2;
    // H_rotor_3 = C*w_rotor_frame_3
    let H_rotor_3 = C * w_rotor_frame_3;
    // J_inner_frame_22 = Ay + B
    let J_inner_frame_22 = Ay + B;
    // b_alpha_rotor_frame_2_2 = w_rotor_frame_3*H_rotor_1 - w_inner_frame_in_rotor_frame_1*H_rotor_3
    let b_alpha_rotor_frame_2_2 = (-w_inner_frame_in_rotor_frame_1)
        .mul_add(H_rotor_3, w_rotor_frame_3 * H_rotor_1);
    // b = b_alpha_rotor_frame_2_2 - B*u_phi*w_inner_frame_in_rotor_frame_1
    let b = (-u_phi).mul_add(H_rotor_1, b_alpha_rotor_frame_2_2);
    // b_alpha_rotor_frame_1_2 = w_inner_frame_in_rotor_frame_2*H_rotor_3 - w_rotor_frame_3*H_rotor_2
    let b_alpha_rotor_frame_1_2 = (-w_rotor_frame_3)
        .mul_add(H_rotor_2, w_inner_frame_in_rotor_frame_2 * H_rotor_3);
    // b_2 = B*u_phi*w_inner_frame_in_rotor_frame_2 + b_alpha_rotor_frame_1_2
    let b_2 = u_phi.mul_add(H_rotor_2, b_alpha_rotor_frame_1_2);
    // b_alpha_inner_frame_3_2 = u_theta*H_inner_2 - w_outer_frame_in_inner_frame_2*H_inner_1
    let b_alpha_inner_frame_3_2 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(H_inner_1, u_theta * H_inner_2);
    let b_3_of_u_theta = u_theta * w_outer_frame_in_inner_frame_2;
    // b_3 = b_alpha_inner_frame_3_2 - Az*u_theta*w_outer_frame_in_inner_frame_2
    let b_3 = (-Az).mul_add(b_3_of_u_theta, b_alpha_inner_frame_3_2);
    // b_alpha_inner_frame_2_2 = w_outer_frame_in_inner_frame_3*H_inner_1 - u_theta*H_inner_3 + b*cos(phi)
    //   - b_2*sin(phi)
    let b_alpha_inner_frame_2_2 = (-u_theta)
        .mul_add(H_inner_3, w_outer_frame_in_inner_frame_3 * H_inner_1) + b * cos_phi
        - b_2 * sin_phi;
    // b_4 = u_theta*w_outer_frame_in_inner_frame_3*J_inner_frame_22 + b_alpha_inner_frame_2_2
    let b_4 = (u_theta * w_outer_frame_in_inner_frame_3)
        .mul_add(J_inner_frame_22, b_alpha_inner_frame_2_2);
    // b_u_psi_dot = b_3*cos(theta) + b_4*sin(theta)
    let b_u_psi_dot = b_4.mul_add(sin_theta, b_3 * cos_theta);
    // K_u_psi_dot = Iz + Az*cos(theta)^2 + J_inner_frame_22*sin(theta)^2
    let K_u_psi_dot = Iz + J_inner_frame_22 + cos_theta * cos_theta * (Az - J_inner_frame_22);
    // over_D_u_psi_dot = 1/K_u_psi_dot
    let over_D_u_psi_dot = S::int(1) / K_u_psi_dot;
    // G_u_psi_dot = b_u_psi_dot*over_D_u_psi_dot
    let G_u_psi_dot = b_u_psi_dot * over_D_u_psi_dot;
    // u_psi' = -G_u_psi_dot
    let u_psi_dot = -G_u_psi_dot;
    // J_inner_frame_11 = Ax + B
    let J_inner_frame_11 = Ax + B;
    // b_u_theta_dot = w_outer_frame_in_inner_frame_2*H_inner_3 - w_outer_frame_in_inner_frame_3*H_inner_2
    //   - b*sin(phi) - b_2*cos(phi)
    let b_u_theta_dot = (-w_outer_frame_in_inner_frame_3)
        .mul_add(H_inner_2, w_outer_frame_in_inner_frame_2 * H_inner_3) - b * sin_phi
        - b_2 * cos_phi;
    // over_D_u_theta_dot = 1/J_inner_frame_11
    let over_D_u_theta_dot = S::int(1) / J_inner_frame_11;
    // G_u_theta_dot = b_u_theta_dot*over_D_u_theta_dot
    let G_u_theta_dot = b_u_theta_dot * over_D_u_theta_dot;
    // u_theta' = -G_u_theta_dot
    let u_theta_dot = -G_u_theta_dot;
    // b_alpha_rotor_frame_3 = w_inner_frame_in_rotor_frame_1*H_rotor_2 -
    //   w_inner_frame_in_rotor_frame_2*H_rotor_1
    let b_alpha_rotor_frame_3 = (-w_inner_frame_in_rotor_frame_2)
        .mul_add(H_rotor_1, w_inner_frame_in_rotor_frame_1 * H_rotor_2);
    // over_D_alpha_rotor_frame_3 = 1/C
    let over_D_alpha_rotor_frame_3 = S::int(1) / C;
    // G_alpha_rotor_frame_3 = b_alpha_rotor_frame_3*over_D_alpha_rotor_frame_3
    let G_alpha_rotor_frame_3 = b_alpha_rotor_frame_3 * over_D_alpha_rotor_frame_3;
    // alpha_rotor_frame_3 = G_alpha_rotor_frame_3
    let alpha_rotor_frame_3 = G_alpha_rotor_frame_3;
    // alpha_outer_frame_in_inner_frame_3 = u_psi'*cos(theta)
    let alpha_outer_frame_in_inner_frame_3 = u_psi_dot * cos_theta;
    // alpha_inner_frame_3_2 = u_theta*w_outer_frame_in_inner_frame_2 - alpha_outer_frame_in_inner_frame_3
    let alpha_inner_frame_3_2 = b_3_of_u_theta - alpha_outer_frame_in_inner_frame_3;
    // u_phi' = alpha_inner_frame_3_2 + alpha_rotor_frame_3
    let u_phi_dot = alpha_inner_frame_3_2 + alpha_rotor_frame_3;
    // Values.
    // psi' = u_psi
    let psi_dot_value = u_psi;
    // theta' = u_theta
    let theta_dot_value = u_theta;
    // phi' = u_phi
    let phi_dot_value = u_phi;
    (
        [psi_dot_value, theta_dot_value, phi_dot_value],
        [u_psi_dot, u_theta_dot, u_phi_dot],
    )
}

/// Inverse dynamics: the generalized forces along (u_psi, u_theta, u_phi) that must act beside the loads of the model for the accelerations to be (u_psi', u_theta', u_phi').
///
/// 77 operations, 2 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 3],
    v_dot: &[S; 3],
) -> [S; 3] {
    let Parameters { Iz, Ax, Ay, Az, B, C, .. } = *p;
    let [_, theta, phi] = *q;
    let [u_psi, u_theta, u_phi] = *u;
    let [u_psi_dot, u_theta_dot, u_phi_dot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w_outer_frame_in_inner_frame_2 = u_psi*sin(theta)
    let w_outer_frame_in_inner_frame_2 = u_psi * sin_theta;
    // w_outer_frame_in_inner_frame_3 = u_psi*cos(theta)
    let w_outer_frame_in_inner_frame_3 = u_psi * cos_theta;
    // w_inner_frame_in_rotor_frame_1 = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1 = w_outer_frame_in_inner_frame_2
        .mul_add(sin_phi, u_theta * cos_phi);
    // w_inner_frame_in_rotor_frame_2 = u_theta*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(cos_phi, u_theta * sin_phi);
    // w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3
    let w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3;
    // H_inner_1 = Ax*u_theta
    let H_inner_1 = Ax * u_theta;
    // H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
    let H_inner_2 = Ay * w_outer_frame_in_inner_frame_2;
    // H_inner_3 = Az*w_outer_frame_in_inner_frame_3
    let H_inner_3 = Az * w_outer_frame_in_inner_frame_3;
    // H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
    let H_rotor_1 = B * w_inner_frame_in_rotor_frame_1;
    // H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
    let H_rotor_2 = B * w_inner_frame_in_rotor_frame_2;
    // H_rotor_3 = C*w_rotor_frame_3
    let H_rotor_3 = C * w_rotor_frame_3;
    // alpha_outer_frame_in_inner_frame_2 = u_psi'*sin(theta)
    let alpha_outer_frame_in_inner_frame_2 = u_psi_dot * sin_theta;
    // alpha_outer_frame_in_inner_frame_3 = u_psi'*cos(theta)
    let alpha_outer_frame_in_inner_frame_3 = u_psi_dot * cos_theta;
    // alpha_inner_frame_2_2 = u_theta*w_outer_frame_in_inner_frame_3 + alpha_outer_frame_in_inner_frame_2
    let alpha_inner_frame_2_2 = u_theta
        .mul_add(w_outer_frame_in_inner_frame_3, alpha_outer_frame_in_inner_frame_2);
    // alpha_inner_frame_3_2 = u_theta*w_outer_frame_in_inner_frame_2 - alpha_outer_frame_in_inner_frame_3
    let alpha_inner_frame_3_2 = u_theta
        .mul_add(w_outer_frame_in_inner_frame_2, -alpha_outer_frame_in_inner_frame_3);
    // alpha_inner_frame_in_rotor_frame_1_2 = u_theta'*cos(phi) + alpha_inner_frame_2_2*sin(phi)
    let alpha_inner_frame_in_rotor_frame_1_2 = alpha_inner_frame_2_2
        .mul_add(sin_phi, u_theta_dot * cos_phi);
    // alpha_inner_frame_in_rotor_frame_2_2 = u_theta'*sin(phi) - alpha_inner_frame_2_2*cos(phi)
    let alpha_inner_frame_in_rotor_frame_2_2 = (-alpha_inner_frame_2_2)
        .mul_add(cos_phi, u_theta_dot * sin_phi);
    // alpha_rotor_frame_1_2 = u_phi*w_inner_frame_in_rotor_frame_2 - alpha_inner_frame_in_rotor_frame_1_2
    let alpha_rotor_frame_1_2 = u_phi
        .mul_add(w_inner_frame_in_rotor_frame_2, -alpha_inner_frame_in_rotor_frame_1_2);
    // alpha_rotor_frame_2_2 = u_phi*w_inner_frame_in_rotor_frame_1 + alpha_inner_frame_in_rotor_frame_2_2
    let alpha_rotor_frame_2_2 = u_phi
        .mul_add(w_inner_frame_in_rotor_frame_1, alpha_inner_frame_in_rotor_frame_2_2);
    // alpha_rotor_frame_3 = u_phi' - alpha_inner_frame_3_2
    let alpha_rotor_frame_3 = u_phi_dot - alpha_inner_frame_3_2;
    // F_w_rotor_frame_3_2 = w_inner_frame_in_rotor_frame_1*H_rotor_2 -
    //   w_inner_frame_in_rotor_frame_2*H_rotor_1 - C*alpha_rotor_frame_3
    let F_w_rotor_frame_3_2 = (-w_inner_frame_in_rotor_frame_2)
        .mul_add(H_rotor_1, w_inner_frame_in_rotor_frame_1 * H_rotor_2) - C * alpha_rotor_frame_3;
    // F_w_inner_frame_in_rotor_frame_2_2 = w_rotor_frame_3*H_rotor_1 -
    //   w_inner_frame_in_rotor_frame_1*H_rotor_3 - B*alpha_rotor_frame_2_2
    let F_w_inner_frame_in_rotor_frame_2_2 = (-w_inner_frame_in_rotor_frame_1)
        .mul_add(H_rotor_3, w_rotor_frame_3 * H_rotor_1) - B * alpha_rotor_frame_2_2;
    // F_w_inner_frame_in_rotor_frame_1_2 = w_inner_frame_in_rotor_frame_2*H_rotor_3 -
    //   w_rotor_frame_3*H_rotor_2 + B*alpha_rotor_frame_1_2
    let F_w_inner_frame_in_rotor_frame_1_2 = (-w_rotor_frame_3)
        .mul_add(H_rotor_2, w_inner_frame_in_rotor_frame_2 * H_rotor_3) + B * alpha_rotor_frame_1_2;
    // F_w_outer_frame_in_inner_frame_3_2 = u_theta*H_inner_2 - w_outer_frame_in_inner_frame_2*H_inner_1 -
    //   Az*alpha_inner_frame_3_2 - F_w_rotor_frame_3_2
    let F_w_outer_frame_in_inner_frame_3_2 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(H_inner_1, u_theta * H_inner_2) - Az * alpha_inner_frame_3_2 - F_w_rotor_frame_3_2;
    // F_w_outer_frame_in_inner_frame_2_2 = w_outer_frame_in_inner_frame_3*H_inner_1 - u_theta*H_inner_3 +
    //   Ay*alpha_inner_frame_2_2 + F_w_inner_frame_in_rotor_frame_2_2*cos(phi) -
    //   F_w_inner_frame_in_rotor_frame_1_2*sin(phi)
    let F_w_outer_frame_in_inner_frame_2_2 = (-u_theta)
        .mul_add(H_inner_3, w_outer_frame_in_inner_frame_3 * H_inner_1)
        + Ay * alpha_inner_frame_2_2 + F_w_inner_frame_in_rotor_frame_2_2 * cos_phi
        - F_w_inner_frame_in_rotor_frame_1_2 * sin_phi;
    // Values.
    // tau1 = Iz*u_psi' + F_w_outer_frame_in_inner_frame_3_2*cos(theta) +
    //   F_w_outer_frame_in_inner_frame_2_2*sin(theta)
    let tau1 = F_w_outer_frame_in_inner_frame_3_2.mul_add(cos_theta, Iz * u_psi_dot)
        + F_w_outer_frame_in_inner_frame_2_2 * sin_theta;
    // tau2 = Ax*u_theta' - w_outer_frame_in_inner_frame_3*H_inner_2 +
    //   w_outer_frame_in_inner_frame_2*H_inner_3 - F_w_inner_frame_in_rotor_frame_2_2*sin(phi) -
    //   F_w_inner_frame_in_rotor_frame_1_2*cos(phi)
    let tau2 = (-w_outer_frame_in_inner_frame_3).mul_add(H_inner_2, Ax * u_theta_dot)
        + w_outer_frame_in_inner_frame_2 * H_inner_3 - F_w_inner_frame_in_rotor_frame_2_2 * sin_phi
        - F_w_inner_frame_in_rotor_frame_1_2 * cos_phi;
    // tau3 = -F_w_rotor_frame_3_2
    let tau3 = -F_w_rotor_frame_3_2;
    [tau1, tau2, tau3]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 3],
    direction: &[S; 6],
) -> [S; 6] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[3 + i],
    });
    let (of_q, of_v) = derivative(&p, &q, &v);
    let mut slopes = of_q.into_iter().chain(of_v).map(|rate| rate.slope);
    core::array::from_fn(|_| {
        slopes.next().expect("a slope for each component of the state")
    })
}

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 9,
            coordinates: 3,
            variables: 3,
            speeds: 3,
            reactions: 0,
        }
    }
    fn symmetric(&self) -> bool {
        true
    }
    fn coordinate_rates(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &coordinate_rates(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn mass_matrix(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            mass_matrix(&Parameters::from_slice(p), array(q), array(v)).as_flattened(),
        );
    }
    fn forcing(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&forcing(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn output_count(&self) -> usize {
        6
    }
    fn outputs(&self, p: &[S], _t: S, q: &[S], v: &[S], out: &mut [S]) {
        self.whole_state(p, q, v, out);
    }
    fn has_accelerations(&self) -> bool {
        true
    }
    fn accelerations(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        S::dispatch(
            #[inline(always)]
            || {
                out
                    .copy_from_slice(
                        &accelerations(&Parameters::from_slice(p), array(q), array(v)),
                    )
            },
        );
    }
    fn derivative(&self, p: &[S], q: &[S], v: &[S], q_dot: &mut [S], v_dot: &mut [S]) {
        S::dispatch(
            #[inline(always)]
            || {
                let (of_q, of_v) = derivative(
                    &Parameters::from_slice(p),
                    array(q),
                    array(v),
                );
                q_dot.copy_from_slice(&of_q);
                v_dot.copy_from_slice(&of_v);
            },
        );
    }
    fn jacobian(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        by_columns(
            out,
            |direction| jacobian_product(
                &Parameters::from_slice(p),
                array(q),
                array(v),
                direction,
            ),
        );
    }
    fn generalized_speeds(&self, _p: &[S], _q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(v);
    }
    fn generalized_speed_rates(
        &self,
        _p: &[S],
        _q: &[S],
        _v: &[S],
        v_dot: &[S],
        out: &mut [S],
    ) {
        out.copy_from_slice(v_dot);
    }
    fn motion_variables(&self, _p: &[S], _q: &[S], u: &[S], out: &mut [S]) {
        out.copy_from_slice(u);
    }
    fn kinetic_energy(&self, p: &[S], q: &[S], v: &[S]) -> S {
        kinetic_energy(&Parameters::from_slice(p), array(q), array(v))
    }
    fn potential_energy(&self, p: &[S], q: &[S]) -> S {
        potential_energy(&Parameters::from_slice(p), array(q))
    }
}

#[inline(always)]
fn array<S, const N: usize>(slice: &[S]) -> &[S; N] {
    slice.try_into().expect("a slice of the length that `System` requires")
}
