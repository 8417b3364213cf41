//! Gyroscope in gimbals: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/gimbals/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

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

/// Jacobian of the derivative by the state; columns psi, theta, phi, u_psi, u_theta, u_phi.
///
/// 243 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 3]) -> [[S; 6]; 6] {
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
    // w_inner_frame_in_rotor_frame_1_by_phi = w_outer_frame_in_inner_frame_2*cos(phi) - u_theta*sin(phi)
    let w_inner_frame_in_rotor_frame_1_by_phi = (-u_theta)
        .mul_add(sin_phi, w_outer_frame_in_inner_frame_2 * cos_phi);
    // w_inner_frame_in_rotor_frame_2 = u_theta*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2 = -w_inner_frame_in_rotor_frame_1_by_phi;
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
    let b_u_phi = B * u_phi;
    // b = b_alpha_rotor_frame_2_2 - B*u_phi*w_inner_frame_in_rotor_frame_1
    let b = (-w_inner_frame_in_rotor_frame_1).mul_add(b_u_phi, b_alpha_rotor_frame_2_2);
    // b_alpha_rotor_frame_1_2 = w_inner_frame_in_rotor_frame_2*H_rotor_3 - w_rotor_frame_3*H_rotor_2
    let b_alpha_rotor_frame_1_2 = (-w_rotor_frame_3)
        .mul_add(H_rotor_2, w_inner_frame_in_rotor_frame_2 * H_rotor_3);
    // b_2 = B*u_phi*w_inner_frame_in_rotor_frame_2 + b_alpha_rotor_frame_1_2
    let b_2 = w_inner_frame_in_rotor_frame_2.mul_add(b_u_phi, b_alpha_rotor_frame_1_2);
    // b_alpha_inner_frame_3_2 = u_theta*H_inner_2 - w_outer_frame_in_inner_frame_2*H_inner_1
    let b_alpha_inner_frame_3_2 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(H_inner_1, u_theta * H_inner_2);
    let az_u_theta = Az * u_theta;
    // b_3 = b_alpha_inner_frame_3_2 - Az*u_theta*w_outer_frame_in_inner_frame_2
    let b_3 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(az_u_theta, b_alpha_inner_frame_3_2);
    // b_alpha_inner_frame_2_2 = w_outer_frame_in_inner_frame_3*H_inner_1 - u_theta*H_inner_3 + b*cos(phi)
    //   - b_2*sin(phi)
    let b_alpha_inner_frame_2_2 = (-u_theta)
        .mul_add(H_inner_3, w_outer_frame_in_inner_frame_3 * H_inner_1) + b * cos_phi
        - b_2 * sin_phi;
    let u_theta_j_inner_frame_22 = u_theta * J_inner_frame_22;
    // b_4 = u_theta*w_outer_frame_in_inner_frame_3*J_inner_frame_22 + b_alpha_inner_frame_2_2
    let b_4 = w_outer_frame_in_inner_frame_3
        .mul_add(u_theta_j_inner_frame_22, b_alpha_inner_frame_2_2);
    // b_u_psi_dot = b_3*cos(theta) + b_4*sin(theta)
    let b_u_psi_dot = b_4.mul_add(sin_theta, b_3 * cos_theta);
    // cos(theta)*(Az - J_inner_frame_22)
    let K_u_psi_dot_of_place = cos_theta * (Az - J_inner_frame_22);
    // K_u_psi_dot = Iz + Az*cos(theta)^2 + J_inner_frame_22*sin(theta)^2
    let K_u_psi_dot = K_u_psi_dot_of_place.mul_add(cos_theta, Iz + J_inner_frame_22);
    let k_u_psi_dot_inv = S::int(1) / K_u_psi_dot;
    // over_D_u_psi_dot = 1/K_u_psi_dot
    let over_D_u_psi_dot = k_u_psi_dot_inv;
    // G_u_psi_dot = b_u_psi_dot*over_D_u_psi_dot
    let G_u_psi_dot = b_u_psi_dot * over_D_u_psi_dot;
    // u_psi' = -G_u_psi_dot
    let u_psi_dot = -G_u_psi_dot;
    // J_inner_frame_11 = Ax + B
    let J_inner_frame_11 = Ax + B;
    // over_D_u_theta_dot = 1/J_inner_frame_11
    let over_D_u_theta_dot = S::int(1) / J_inner_frame_11;
    // over_D_alpha_rotor_frame_3 = 1/C
    let over_D_alpha_rotor_frame_3 = S::int(1) / C;
    // w_inner_frame_in_rotor_frame_1_by_theta = u_psi*cos(theta)*sin(phi)
    let w_inner_frame_in_rotor_frame_1_by_theta = w_outer_frame_in_inner_frame_3 * sin_phi;
    // w_inner_frame_in_rotor_frame_2_by_theta = -u_psi*cos(theta)*cos(phi)
    let w_inner_frame_in_rotor_frame_2_by_theta = -w_outer_frame_in_inner_frame_3 * cos_phi;
    // B*w_rotor_frame_3 - H_rotor_3
    let b_alpha_rotor_frame_2_2_by_theta_of_place = B
        .mul_add(w_rotor_frame_3, -H_rotor_3);
    let b_alpha_rotor_frame_2_2_by_theta_of_place_2 = C * w_inner_frame_in_rotor_frame_1;
    // b_alpha_rotor_frame_2_2_by_theta_of_place_2 - H_rotor_1
    let b_alpha_rotor_frame_2_2_by_theta_of_place_3 = b_alpha_rotor_frame_2_2_by_theta_of_place_2
        - H_rotor_1;
    // b_alpha_rotor_frame_2_2_by_theta = u_psi*sin(theta)*(C*w_inner_frame_in_rotor_frame_1 - H_rotor_1) +
    //   w_inner_frame_in_rotor_frame_1_by_theta*(B*w_rotor_frame_3 - H_rotor_3)
    let b_alpha_rotor_frame_2_2_by_theta = w_outer_frame_in_inner_frame_2
        .mul_add(
            b_alpha_rotor_frame_2_2_by_theta_of_place_3,
            w_inner_frame_in_rotor_frame_1_by_theta * b_alpha_rotor_frame_2_2_by_theta_of_place,
        );
    let b_alpha_rotor_frame_1_2_by_theta_of_place = C * w_inner_frame_in_rotor_frame_2;
    // b_alpha_rotor_frame_1_2_by_theta_of_place - H_rotor_2
    let b_alpha_rotor_frame_1_2_by_theta_of_place_2 = b_alpha_rotor_frame_1_2_by_theta_of_place
        - H_rotor_2;
    // b_alpha_rotor_frame_1_2_by_theta = u_psi*sin(theta)*(H_rotor_2 - C*w_inner_frame_in_rotor_frame_2) +
    //   w_inner_frame_in_rotor_frame_2_by_theta*(H_rotor_3 - B*w_rotor_frame_3)
    let b_alpha_rotor_frame_1_2_by_theta = (-w_outer_frame_in_inner_frame_2)
        .mul_add(
            b_alpha_rotor_frame_1_2_by_theta_of_place_2,
            -w_inner_frame_in_rotor_frame_2_by_theta * b_alpha_rotor_frame_2_2_by_theta_of_place,
        );
    // Ay*u_theta - H_inner_1
    let b_alpha_inner_frame_3_2_by_theta_of_u_theta = Ay.mul_add(u_theta, -H_inner_1);
    // b_alpha_inner_frame_3_2_by_theta = u_psi*cos(theta)*(Ay*u_theta - H_inner_1)
    let b_alpha_inner_frame_3_2_by_theta = w_outer_frame_in_inner_frame_3
        * b_alpha_inner_frame_3_2_by_theta_of_u_theta;
    // b_3_by_theta = b_alpha_inner_frame_3_2_by_theta - Az*u_psi*u_theta*cos(theta)
    let b_3_by_theta = (-w_outer_frame_in_inner_frame_3)
        .mul_add(az_u_theta, b_alpha_inner_frame_3_2_by_theta);
    let sin_phi_b_u_phi = b_u_phi * sin_phi;
    let cos_phi_b_u_phi = b_u_phi * cos_phi;
    // H_inner_1 - az_u_theta
    let b_alpha_inner_frame_2_2_by_theta_of_u_theta = H_inner_1 - az_u_theta;
    // b_alpha_inner_frame_2_2_by_theta = u_psi*sin(theta)*(Az*u_theta - H_inner_1) -
    //   B*u_phi*(w_inner_frame_in_rotor_frame_1_by_theta*cos(phi) +
    //   w_inner_frame_in_rotor_frame_2_by_theta*sin(phi)) + b_alpha_rotor_frame_2_2_by_theta*cos(phi) -
    //   b_alpha_rotor_frame_1_2_by_theta*sin(phi)
    let b_alpha_inner_frame_2_2_by_theta = (-b_alpha_rotor_frame_1_2_by_theta)
        .mul_add(sin_phi, b_alpha_rotor_frame_2_2_by_theta * cos_phi)
        - w_inner_frame_in_rotor_frame_2_by_theta * sin_phi_b_u_phi
        - w_inner_frame_in_rotor_frame_1_by_theta * cos_phi_b_u_phi
        - w_outer_frame_in_inner_frame_2 * b_alpha_inner_frame_2_2_by_theta_of_u_theta;
    // b_4_by_theta = b_alpha_inner_frame_2_2_by_theta - u_psi*u_theta*J_inner_frame_22*sin(theta)
    let b_4_by_theta = (-w_outer_frame_in_inner_frame_2)
        .mul_add(u_theta_j_inner_frame_22, b_alpha_inner_frame_2_2_by_theta);
    // b_u_psi_dot_by_theta = cos(theta)*(b_4 + b_3_by_theta) + sin(theta)*(b_4_by_theta - b_3)
    let b_u_psi_dot_by_theta = cos_theta * (b_4 + b_3_by_theta) + sin_theta * (b_4_by_theta - b_3);
    // K_u_psi_dot_by_theta = 2*sin(theta)*cos(theta)*(J_inner_frame_22 - Az)
    let K_u_psi_dot_by_theta = -S::int(2) * K_u_psi_dot_of_place * sin_theta;
    // Az*w_outer_frame_in_inner_frame_2 - H_inner_2
    let b_u_theta_dot_by_theta_of_place = Az
        .mul_add(w_outer_frame_in_inner_frame_2, -H_inner_2);
    // Ay*w_outer_frame_in_inner_frame_3 - H_inner_3
    let b_u_theta_dot_by_theta_of_place_2 = Ay
        .mul_add(w_outer_frame_in_inner_frame_3, -H_inner_3);
    // b_u_theta_dot_by_theta = u_psi*(sin(theta)*(H_inner_2 - Az*w_outer_frame_in_inner_frame_2) +
    //   cos(theta)*(H_inner_3 - Ay*w_outer_frame_in_inner_frame_3)) +
    //   B*u_phi*(w_inner_frame_in_rotor_frame_1_by_theta*sin(phi) -
    //   w_inner_frame_in_rotor_frame_2_by_theta*cos(phi)) - b_alpha_rotor_frame_2_2_by_theta*sin(phi) -
    //   b_alpha_rotor_frame_1_2_by_theta*cos(phi)
    let b_u_theta_dot_by_theta = (-b_alpha_rotor_frame_2_2_by_theta)
        .mul_add(sin_phi, w_inner_frame_in_rotor_frame_1_by_theta * sin_phi_b_u_phi)
        - b_alpha_rotor_frame_1_2_by_theta * cos_phi
        - w_inner_frame_in_rotor_frame_2_by_theta * cos_phi_b_u_phi
        - w_outer_frame_in_inner_frame_2 * b_u_theta_dot_by_theta_of_place
        - w_outer_frame_in_inner_frame_3 * b_u_theta_dot_by_theta_of_place_2;
    // b_alpha_rotor_frame_3_by_theta = H_rotor_2*w_inner_frame_in_rotor_frame_1_by_theta -
    //   H_rotor_1*w_inner_frame_in_rotor_frame_2_by_theta +
    //   B*(w_inner_frame_in_rotor_frame_1*w_inner_frame_in_rotor_frame_2_by_theta -
    //   w_inner_frame_in_rotor_frame_2*w_inner_frame_in_rotor_frame_1_by_theta)
    let b_alpha_rotor_frame_3_by_theta = S::int(0);
    // b_u_psi_dot*K_u_psi_dot_by_theta*k_u_psi_dot_inv^2 - over_D_u_psi_dot*b_u_psi_dot_by_theta
    let alpha_outer_frame_in_inner_frame_3_by_theta_of_place = (-over_D_u_psi_dot)
        .mul_add(
            b_u_psi_dot_by_theta,
            b_u_psi_dot * K_u_psi_dot_by_theta * k_u_psi_dot_inv * k_u_psi_dot_inv,
        );
    // alpha_outer_frame_in_inner_frame_3_by_theta =
    //   cos(theta)*(b_u_psi_dot*K_u_psi_dot_by_theta/K_u_psi_dot^2 - over_D_u_psi_dot*b_u_psi_dot_by_theta)
    //   - u_psi'*sin(theta)
    let alpha_outer_frame_in_inner_frame_3_by_theta = (-u_psi_dot)
        .mul_add(
            sin_theta,
            alpha_outer_frame_in_inner_frame_3_by_theta_of_place * cos_theta,
        );
    // alpha_inner_frame_3_2_by_theta = u_psi*u_theta*cos(theta) -
    //   alpha_outer_frame_in_inner_frame_3_by_theta
    let alpha_inner_frame_3_2_by_theta = u_theta
        .mul_add(
            w_outer_frame_in_inner_frame_3, -alpha_outer_frame_in_inner_frame_3_by_theta,
        );
    // w_inner_frame_in_rotor_frame_2_by_phi = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_2_by_phi = w_inner_frame_in_rotor_frame_1;
    // b_alpha_rotor_frame_2_2_by_theta_of_place - b_u_phi
    let b_alpha_inner_frame_2_2_by_phi_of_u_phi = b_alpha_rotor_frame_2_2_by_theta_of_place
        - b_u_phi;
    // b - w_inner_frame_in_rotor_frame_2_by_phi*b_alpha_inner_frame_2_2_by_phi_of_u_phi
    let b_alpha_inner_frame_2_2_by_phi_of_u_phi_2 = (-w_inner_frame_in_rotor_frame_2_by_phi)
        .mul_add(b_alpha_inner_frame_2_2_by_phi_of_u_phi, b);
    // b_2 - w_inner_frame_in_rotor_frame_1_by_phi*b_alpha_inner_frame_2_2_by_phi_of_u_phi
    let b_alpha_inner_frame_2_2_by_phi_of_u_phi_3 = (-w_inner_frame_in_rotor_frame_1_by_phi)
        .mul_add(b_alpha_inner_frame_2_2_by_phi_of_u_phi, b_2);
    // b_alpha_inner_frame_2_2_by_phi = -cos(phi)*(b_2 + w_inner_frame_in_rotor_frame_1_by_phi*(B*(u_phi -
    //   w_rotor_frame_3) + H_rotor_3)) - sin(phi)*(b + w_inner_frame_in_rotor_frame_2_by_phi*(B*(u_phi -
    //   w_rotor_frame_3) + H_rotor_3))
    let b_alpha_inner_frame_2_2_by_phi = (-b_alpha_inner_frame_2_2_by_phi_of_u_phi_3)
        .mul_add(cos_phi, -b_alpha_inner_frame_2_2_by_phi_of_u_phi_2 * sin_phi);
    // b_u_theta_dot_by_phi = sin(phi)*(b_2 + w_inner_frame_in_rotor_frame_1_by_phi*(B*(u_phi -
    //   w_rotor_frame_3) + H_rotor_3)) - cos(phi)*(b + w_inner_frame_in_rotor_frame_2_by_phi*(B*(u_phi -
    //   w_rotor_frame_3) + H_rotor_3))
    let b_u_theta_dot_by_phi = (-b_alpha_inner_frame_2_2_by_phi_of_u_phi_2)
        .mul_add(cos_phi, b_alpha_inner_frame_2_2_by_phi_of_u_phi_3 * sin_phi);
    // b_alpha_rotor_frame_3_by_phi = H_rotor_2*w_inner_frame_in_rotor_frame_1_by_phi -
    //   H_rotor_1*w_inner_frame_in_rotor_frame_2_by_phi +
    //   B*(w_inner_frame_in_rotor_frame_1*w_inner_frame_in_rotor_frame_2_by_phi -
    //   w_inner_frame_in_rotor_frame_2*w_inner_frame_in_rotor_frame_1_by_phi)
    let b_alpha_rotor_frame_3_by_phi = S::int(0);
    let alpha_outer_frame_in_inner_frame_3_by_phi_of_place = over_D_u_psi_dot * cos_theta;
    let alpha_outer_frame_in_inner_frame_3_by_phi_of_place_2 = alpha_outer_frame_in_inner_frame_3_by_phi_of_place
        * sin_theta;
    // alpha_outer_frame_in_inner_frame_3_by_phi =
    //   -over_D_u_psi_dot*b_alpha_inner_frame_2_2_by_phi*sin(theta)*cos(theta)
    let alpha_outer_frame_in_inner_frame_3_by_phi = -b_alpha_inner_frame_2_2_by_phi
        * alpha_outer_frame_in_inner_frame_3_by_phi_of_place_2;
    // w_inner_frame_in_rotor_frame_1_by_u_psi = sin(theta)*sin(phi)
    let w_inner_frame_in_rotor_frame_1_by_u_psi = sin_theta * sin_phi;
    // w_inner_frame_in_rotor_frame_2_by_u_psi = -sin(theta)*cos(phi)
    let w_inner_frame_in_rotor_frame_2_by_u_psi = -sin_theta * cos_phi;
    // b_alpha_rotor_frame_2_2_by_u_psi = cos(theta)*(H_rotor_1 - C*w_inner_frame_in_rotor_frame_1) +
    //   w_inner_frame_in_rotor_frame_1_by_u_psi*(B*w_rotor_frame_3 - H_rotor_3)
    let b_alpha_rotor_frame_2_2_by_u_psi = (-b_alpha_rotor_frame_2_2_by_theta_of_place_3)
        .mul_add(
            cos_theta,
            w_inner_frame_in_rotor_frame_1_by_u_psi * b_alpha_rotor_frame_2_2_by_theta_of_place,
        );
    // b_alpha_rotor_frame_1_2_by_u_psi = cos(theta)*(C*w_inner_frame_in_rotor_frame_2 - H_rotor_2) +
    //   w_inner_frame_in_rotor_frame_2_by_u_psi*(H_rotor_3 - B*w_rotor_frame_3)
    let b_alpha_rotor_frame_1_2_by_u_psi = (-w_inner_frame_in_rotor_frame_2_by_u_psi)
        .mul_add(
            b_alpha_rotor_frame_2_2_by_theta_of_place,
            b_alpha_rotor_frame_1_2_by_theta_of_place_2 * cos_theta,
        );
    // b_alpha_inner_frame_3_2_by_u_psi = sin(theta)*(Ay*u_theta - H_inner_1)
    let b_alpha_inner_frame_3_2_by_u_psi = b_alpha_inner_frame_3_2_by_theta_of_u_theta * sin_theta;
    // b_3_by_u_psi = b_alpha_inner_frame_3_2_by_u_psi - Az*u_theta*sin(theta)
    let b_3_by_u_psi = (-az_u_theta)
        .mul_add(sin_theta, b_alpha_inner_frame_3_2_by_u_psi);
    // b_alpha_inner_frame_2_2_by_u_psi = cos(theta)*(H_inner_1 - Az*u_theta) -
    //   B*u_phi*(w_inner_frame_in_rotor_frame_1_by_u_psi*cos(phi) +
    //   w_inner_frame_in_rotor_frame_2_by_u_psi*sin(phi)) + b_alpha_rotor_frame_2_2_by_u_psi*cos(phi) -
    //   b_alpha_rotor_frame_1_2_by_u_psi*sin(phi)
    let b_alpha_inner_frame_2_2_by_u_psi = (-b_alpha_rotor_frame_1_2_by_u_psi)
        .mul_add(sin_phi, b_alpha_rotor_frame_2_2_by_u_psi * cos_phi)
        - w_inner_frame_in_rotor_frame_2_by_u_psi * sin_phi_b_u_phi
        - w_inner_frame_in_rotor_frame_1_by_u_psi * cos_phi_b_u_phi
        + b_alpha_inner_frame_2_2_by_theta_of_u_theta * cos_theta;
    // b_4_by_u_psi = u_theta*J_inner_frame_22*cos(theta) + b_alpha_inner_frame_2_2_by_u_psi
    let b_4_by_u_psi = u_theta_j_inner_frame_22
        .mul_add(cos_theta, b_alpha_inner_frame_2_2_by_u_psi);
    // b_u_psi_dot_by_u_psi = b_3_by_u_psi*cos(theta) + b_4_by_u_psi*sin(theta)
    let b_u_psi_dot_by_u_psi = b_4_by_u_psi.mul_add(sin_theta, b_3_by_u_psi * cos_theta);
    let b_u_theta_dot_by_u_psi_of_place = b_u_theta_dot_by_theta_of_place * cos_theta;
    // b_u_theta_dot_by_u_psi = cos(theta)*(Az*w_outer_frame_in_inner_frame_2 - H_inner_2) +
    //   sin(theta)*(H_inner_3 - Ay*w_outer_frame_in_inner_frame_3) +
    //   B*u_phi*(w_inner_frame_in_rotor_frame_1_by_u_psi*sin(phi) -
    //   w_inner_frame_in_rotor_frame_2_by_u_psi*cos(phi)) - b_alpha_rotor_frame_2_2_by_u_psi*sin(phi) -
    //   b_alpha_rotor_frame_1_2_by_u_psi*cos(phi)
    let b_u_theta_dot_by_u_psi = (-b_alpha_rotor_frame_2_2_by_u_psi)
        .mul_add(sin_phi, w_inner_frame_in_rotor_frame_1_by_u_psi * sin_phi_b_u_phi)
        - b_alpha_rotor_frame_1_2_by_u_psi * cos_phi
        - w_inner_frame_in_rotor_frame_2_by_u_psi * cos_phi_b_u_phi
        - b_u_theta_dot_by_theta_of_place_2 * sin_theta + b_u_theta_dot_by_u_psi_of_place;
    // b_alpha_rotor_frame_3_by_u_psi = H_rotor_2*w_inner_frame_in_rotor_frame_1_by_u_psi -
    //   H_rotor_1*w_inner_frame_in_rotor_frame_2_by_u_psi +
    //   B*(w_inner_frame_in_rotor_frame_1*w_inner_frame_in_rotor_frame_2_by_u_psi -
    //   w_inner_frame_in_rotor_frame_2*w_inner_frame_in_rotor_frame_1_by_u_psi)
    let b_alpha_rotor_frame_3_by_u_psi = S::int(0);
    // alpha_inner_frame_3_2_by_u_psi = u_theta*sin(theta) +
    //   over_D_u_psi_dot*b_u_psi_dot_by_u_psi*cos(theta)
    let alpha_inner_frame_3_2_by_u_psi = b_u_psi_dot_by_u_psi
        .mul_add(
            alpha_outer_frame_in_inner_frame_3_by_phi_of_place,
            u_theta * sin_theta,
        );
    // b_alpha_rotor_frame_2_2_by_u_theta = cos(phi)*(B*w_rotor_frame_3 - H_rotor_3)
    let b_alpha_rotor_frame_2_2_by_u_theta = b_alpha_rotor_frame_2_2_by_theta_of_place * cos_phi;
    // b_by_u_theta = b_alpha_rotor_frame_2_2_by_u_theta - B*u_phi*cos(phi)
    let b_by_u_theta = b_alpha_rotor_frame_2_2_by_u_theta - cos_phi_b_u_phi;
    // b_alpha_rotor_frame_1_2_by_u_theta = sin(phi)*(H_rotor_3 - B*w_rotor_frame_3)
    let b_alpha_rotor_frame_1_2_by_u_theta = -b_alpha_rotor_frame_2_2_by_theta_of_place * sin_phi;
    // b_2_by_u_theta = B*u_phi*sin(phi) + b_alpha_rotor_frame_1_2_by_u_theta
    let b_2_by_u_theta = b_alpha_rotor_frame_1_2_by_u_theta + sin_phi_b_u_phi;
    // b_alpha_inner_frame_2_2_by_u_theta = Ax*w_outer_frame_in_inner_frame_3 - H_inner_3 +
    //   b_by_u_theta*cos(phi) - b_2_by_u_theta*sin(phi)
    let b_alpha_inner_frame_2_2_by_u_theta = Ax
        .mul_add(w_outer_frame_in_inner_frame_3, -H_inner_3) + b_by_u_theta * cos_phi
        - b_2_by_u_theta * sin_phi;
    // b_u_psi_dot_by_u_theta = cos(theta)*(H_inner_2 - w_outer_frame_in_inner_frame_2*(Ax + Az)) +
    //   sin(theta)*(w_outer_frame_in_inner_frame_3*J_inner_frame_22 + b_alpha_inner_frame_2_2_by_u_theta)
    let b_u_psi_dot_by_u_theta = sin_theta
        * w_outer_frame_in_inner_frame_3
            .mul_add(J_inner_frame_22, b_alpha_inner_frame_2_2_by_u_theta)
        - Ax * w_outer_frame_in_inner_frame_2 * cos_theta - b_u_theta_dot_by_u_psi_of_place;
    // b_u_theta_dot_by_u_theta = -b_by_u_theta*sin(phi) - b_2_by_u_theta*cos(phi)
    let b_u_theta_dot_by_u_theta = (-b_2_by_u_theta)
        .mul_add(cos_phi, -b_by_u_theta * sin_phi);
    // b_alpha_rotor_frame_3_by_u_theta = B*(w_inner_frame_in_rotor_frame_1*sin(phi) -
    //   w_inner_frame_in_rotor_frame_2*cos(phi)) - H_rotor_1*sin(phi) + H_rotor_2*cos(phi)
    let b_alpha_rotor_frame_3_by_u_theta = S::int(0);
    // alpha_inner_frame_3_2_by_u_theta = w_outer_frame_in_inner_frame_2 +
    //   over_D_u_psi_dot*b_u_psi_dot_by_u_theta*cos(theta)
    let alpha_inner_frame_3_2_by_u_theta = b_u_psi_dot_by_u_theta
        .mul_add(
            alpha_outer_frame_in_inner_frame_3_by_phi_of_place, w_outer_frame_in_inner_frame_2,
        );
    // b_alpha_inner_frame_2_2_by_u_phi = cos(phi)*(H_rotor_1 - w_inner_frame_in_rotor_frame_1*(B + C)) +
    //   sin(phi)*(H_rotor_2 - w_inner_frame_in_rotor_frame_2*(B + C))
    let b_alpha_inner_frame_2_2_by_u_phi = (-b_alpha_rotor_frame_1_2_by_theta_of_place)
        .mul_add(sin_phi, -b_alpha_rotor_frame_2_2_by_theta_of_place_2 * cos_phi);
    // b_u_theta_dot_by_u_phi = sin(phi)*(w_inner_frame_in_rotor_frame_1*(B + C) - H_rotor_1) +
    //   cos(phi)*(H_rotor_2 - w_inner_frame_in_rotor_frame_2*(B + C))
    let b_u_theta_dot_by_u_phi = (-b_alpha_rotor_frame_1_2_by_theta_of_place)
        .mul_add(cos_phi, b_alpha_rotor_frame_2_2_by_theta_of_place_2 * sin_phi);
    // alpha_outer_frame_in_inner_frame_3_by_u_phi =
    //   -over_D_u_psi_dot*b_alpha_inner_frame_2_2_by_u_phi*sin(theta)*cos(theta)
    let alpha_outer_frame_in_inner_frame_3_by_u_phi = -b_alpha_inner_frame_2_2_by_u_phi
        * alpha_outer_frame_in_inner_frame_3_by_phi_of_place_2;
    let u_psi_dot_by_phi_value_of_place = over_D_u_psi_dot * sin_theta;
    // Entries that are not zero.
    // d(psi')/d(u_psi) = 1
    let psi_dot_by_u_psi_value = S::int(1);
    // d(theta')/d(u_theta) = 1
    let theta_dot_by_u_theta_value = S::int(1);
    // d(phi')/d(u_phi) = 1
    let phi_dot_by_u_phi_value = S::int(1);
    // d(u_psi')/d(theta) = b_u_psi_dot*K_u_psi_dot_by_theta/K_u_psi_dot^2 -
    //   over_D_u_psi_dot*b_u_psi_dot_by_theta
    let u_psi_dot_by_theta_value = alpha_outer_frame_in_inner_frame_3_by_theta_of_place;
    // d(u_psi')/d(phi) = -over_D_u_psi_dot*b_alpha_inner_frame_2_2_by_phi*sin(theta)
    let u_psi_dot_by_phi_value = -b_alpha_inner_frame_2_2_by_phi * u_psi_dot_by_phi_value_of_place;
    // d(u_psi')/d(u_psi) = -over_D_u_psi_dot*b_u_psi_dot_by_u_psi
    let u_psi_dot_by_u_psi_value = -over_D_u_psi_dot * b_u_psi_dot_by_u_psi;
    // d(u_psi')/d(u_theta) = -over_D_u_psi_dot*b_u_psi_dot_by_u_theta
    let u_psi_dot_by_u_theta_value = -over_D_u_psi_dot * b_u_psi_dot_by_u_theta;
    // d(u_psi')/d(u_phi) = -over_D_u_psi_dot*b_alpha_inner_frame_2_2_by_u_phi*sin(theta)
    let u_psi_dot_by_u_phi_value = -b_alpha_inner_frame_2_2_by_u_phi
        * u_psi_dot_by_phi_value_of_place;
    // d(u_theta')/d(theta) = -over_D_u_theta_dot*b_u_theta_dot_by_theta
    let u_theta_dot_by_theta_value = -over_D_u_theta_dot * b_u_theta_dot_by_theta;
    // d(u_theta')/d(phi) = -over_D_u_theta_dot*b_u_theta_dot_by_phi
    let u_theta_dot_by_phi_value = -over_D_u_theta_dot * b_u_theta_dot_by_phi;
    // d(u_theta')/d(u_psi) = -over_D_u_theta_dot*b_u_theta_dot_by_u_psi
    let u_theta_dot_by_u_psi_value = -over_D_u_theta_dot * b_u_theta_dot_by_u_psi;
    // d(u_theta')/d(u_theta) = -over_D_u_theta_dot*b_u_theta_dot_by_u_theta
    let u_theta_dot_by_u_theta_value = -over_D_u_theta_dot * b_u_theta_dot_by_u_theta;
    // d(u_theta')/d(u_phi) = -over_D_u_theta_dot*b_u_theta_dot_by_u_phi
    let u_theta_dot_by_u_phi_value = -over_D_u_theta_dot * b_u_theta_dot_by_u_phi;
    // d(u_phi')/d(theta) = over_D_alpha_rotor_frame_3*b_alpha_rotor_frame_3_by_theta +
    //   alpha_inner_frame_3_2_by_theta
    let u_phi_dot_by_theta_value = over_D_alpha_rotor_frame_3
        .mul_add(b_alpha_rotor_frame_3_by_theta, alpha_inner_frame_3_2_by_theta);
    // d(u_phi')/d(phi) = over_D_alpha_rotor_frame_3*b_alpha_rotor_frame_3_by_phi -
    //   alpha_outer_frame_in_inner_frame_3_by_phi
    let u_phi_dot_by_phi_value = over_D_alpha_rotor_frame_3
        .mul_add(
            b_alpha_rotor_frame_3_by_phi, -alpha_outer_frame_in_inner_frame_3_by_phi,
        );
    // d(u_phi')/d(u_psi) = over_D_alpha_rotor_frame_3*b_alpha_rotor_frame_3_by_u_psi +
    //   alpha_inner_frame_3_2_by_u_psi
    let u_phi_dot_by_u_psi_value = over_D_alpha_rotor_frame_3
        .mul_add(b_alpha_rotor_frame_3_by_u_psi, alpha_inner_frame_3_2_by_u_psi);
    // d(u_phi')/d(u_theta) = over_D_alpha_rotor_frame_3*b_alpha_rotor_frame_3_by_u_theta +
    //   alpha_inner_frame_3_2_by_u_theta
    let u_phi_dot_by_u_theta_value = over_D_alpha_rotor_frame_3
        .mul_add(b_alpha_rotor_frame_3_by_u_theta, alpha_inner_frame_3_2_by_u_theta);
    // d(u_phi')/d(u_phi) = -alpha_outer_frame_in_inner_frame_3_by_u_phi
    let u_phi_dot_by_u_phi_value = -alpha_outer_frame_in_inner_frame_3_by_u_phi;
    let zero = S::int(0);
    [
        [zero, zero, zero, psi_dot_by_u_psi_value, zero, zero],
        [zero, zero, zero, zero, theta_dot_by_u_theta_value, zero],
        [zero, zero, zero, zero, zero, phi_dot_by_u_phi_value],
        [
            zero, u_psi_dot_by_theta_value, u_psi_dot_by_phi_value, u_psi_dot_by_u_psi_value,
            u_psi_dot_by_u_theta_value, u_psi_dot_by_u_phi_value,
        ],
        [
            zero, u_theta_dot_by_theta_value, u_theta_dot_by_phi_value, u_theta_dot_by_u_psi_value,
            u_theta_dot_by_u_theta_value, u_theta_dot_by_u_phi_value,
        ],
        [
            zero, u_phi_dot_by_theta_value, u_phi_dot_by_phi_value, u_phi_dot_by_u_psi_value,
            u_phi_dot_by_u_theta_value, u_phi_dot_by_u_phi_value,
        ],
    ]
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

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 37 convolutions and 64 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 6]],
    history: &mut [Factors<S, 40>],
) {
    let Parameters { Iz, Ax, Ay, Az, B, C, .. } = *p;
    let [_, theta_0, phi_0, u_psi_0, u_theta_0, u_phi_0] = series[0];
    // Shared terms.
    let b_c_inv = B / C;
    // Constant in time.
    // minus_c = -C
    let minus_c = -C;
    // minus_b = -B
    let minus_b = -B;
    // minus_ax = -Ax
    let minus_ax = -Ax;
    // minus_az = -Az
    let minus_az = -Az;
    // ay_plus_b = Ay + B
    let ay_plus_b = Ay + B;
    // minus_ay = -Ay
    let minus_ay = -Ay;
    // b_by_c = B/C
    let b_by_c = b_c_inv;
    // minus_b_by_c = -B/C
    let minus_b_by_c = -b_c_inv;
    // minus_1_by_ax_plus_b = -1/(Ax + B)
    let minus_1_by_ax_plus_b = -S::int(1) / (Ax + B);
    // Order 0.
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    let u_psi_sin_theta_0 = u_psi_0 * sin_theta_0;
    let u_psi_cos_theta_0 = u_psi_0 * cos_theta_0;
    let (sin_phi_0, cos_phi_0) = phi_0.sin_cos();
    let u_theta_cos_phi_0 = u_theta_0 * cos_phi_0;
    let u_psi_sin_theta_sin_phi_0 = sin_phi_0 * u_psi_sin_theta_0;
    let w_inner_frame_in_rotor_frame_1_of_u_theta_0 = u_theta_cos_phi_0 + u_psi_sin_theta_sin_phi_0;
    let u_theta_sin_phi_0 = u_theta_0 * sin_phi_0;
    let u_psi_sin_theta_cos_phi_0 = cos_phi_0 * u_psi_sin_theta_0;
    let w_inner_frame_in_rotor_frame_2_of_u_theta_0 = u_theta_sin_phi_0 - u_psi_sin_theta_cos_phi_0;
    let w_rotor_frame_3_of_u_phi_0 = u_phi_0 + u_psi_cos_theta_0;
    let b_alpha_rotor_frame_2_2_of_motion_0 = w_rotor_frame_3_of_u_phi_0
        * w_inner_frame_in_rotor_frame_1_of_u_theta_0;
    let b_alpha_rotor_frame_2_2_of_motion_2_0 = w_inner_frame_in_rotor_frame_1_of_u_theta_0
        * w_rotor_frame_3_of_u_phi_0;
    let b_of_motion_0 = u_phi_0 * w_inner_frame_in_rotor_frame_1_of_u_theta_0;
    let b_of_u_phi_0 = b_of_motion_0
        .mul_add(
            minus_b,
            b_alpha_rotor_frame_2_2_of_motion_2_0
                .mul_add(minus_c, B * b_alpha_rotor_frame_2_2_of_motion_0),
        );
    let b_alpha_rotor_frame_1_2_of_motion_0 = w_inner_frame_in_rotor_frame_2_of_u_theta_0
        * w_rotor_frame_3_of_u_phi_0;
    let b_alpha_rotor_frame_1_2_of_motion_2_0 = w_rotor_frame_3_of_u_phi_0
        * w_inner_frame_in_rotor_frame_2_of_u_theta_0;
    let b_2_of_motion_0 = u_phi_0 * w_inner_frame_in_rotor_frame_2_of_u_theta_0;
    let b_2_of_u_phi_0 = b_2_of_motion_0
        .mul_add(
            B,
            b_alpha_rotor_frame_1_2_of_motion_2_0
                .mul_add(minus_b, C * b_alpha_rotor_frame_1_2_of_motion_0),
        );
    let u_psi_u_theta_sin_theta_0 = u_theta_0 * u_psi_sin_theta_0;
    let u_psi_u_theta_sin_theta_2_0 = u_psi_sin_theta_0 * u_theta_0;
    let u_psi_u_theta_sin_theta_3_0 = u_theta_0 * u_psi_sin_theta_0;
    let b_3_of_u_theta_0 = u_psi_u_theta_sin_theta_3_0
        .mul_add(
            minus_az,
            u_psi_u_theta_sin_theta_2_0.mul_add(minus_ax, Ay * u_psi_u_theta_sin_theta_0),
        );
    let u_psi_u_theta_cos_theta_0 = u_psi_cos_theta_0 * u_theta_0;
    let u_psi_u_theta_cos_theta_2_0 = u_theta_0 * u_psi_cos_theta_0;
    let b_alpha_inner_frame_2_2_of_u_phi_0 = cos_phi_0 * b_of_u_phi_0;
    let b_alpha_inner_frame_2_2_of_u_phi_2_0 = sin_phi_0 * b_2_of_u_phi_0;
    let u_psi_u_theta_cos_theta_3_0 = u_theta_0 * u_psi_cos_theta_0;
    let b_4_of_u_theta_0 = u_psi_u_theta_cos_theta_3_0
        .mul_add(
            ay_plus_b,
            u_psi_u_theta_cos_theta_2_0.mul_add(minus_az, Ax * u_psi_u_theta_cos_theta_0),
        ) + b_alpha_inner_frame_2_2_of_u_phi_0 - b_alpha_inner_frame_2_2_of_u_phi_2_0;
    let b_u_psi_dot_of_u_theta_0 = cos_theta_0 * b_3_of_u_theta_0;
    let b_u_psi_dot_of_u_theta_2_0 = sin_theta_0 * b_4_of_u_theta_0;
    let b_u_psi_dot_of_place_0 = b_u_psi_dot_of_u_theta_0 + b_u_psi_dot_of_u_theta_2_0;
    let cos_theta_sq_0 = cos_theta_0 * cos_theta_0;
    let sin_theta_sq_0 = sin_theta_0 * sin_theta_0;
    let K_u_psi_dot_of_place_0 = sin_theta_sq_0
        .mul_add(ay_plus_b, cos_theta_sq_0.mul_add(Az, Iz));
    let over_K_u_psi_dot_of_place = S::int(1) / K_u_psi_dot_of_place_0;
    let over_D_u_psi_dot_of_place_0 = over_K_u_psi_dot_of_place;
    let G_u_psi_dot_of_place_0 = b_u_psi_dot_of_place_0 * over_D_u_psi_dot_of_place_0;
    let b_u_theta_dot_of_u_psi_0 = u_psi_sin_theta_0 * u_psi_cos_theta_0;
    let b_u_theta_dot_of_u_psi_2_0 = u_psi_cos_theta_0 * u_psi_sin_theta_0;
    let b_u_theta_dot_of_u_phi_0 = sin_phi_0 * b_of_u_phi_0;
    let b_u_theta_dot_of_u_phi_2_0 = cos_phi_0 * b_2_of_u_phi_0;
    let b_u_theta_dot_of_place_0 = b_u_theta_dot_of_u_psi_2_0
        .mul_add(minus_ay, Az * b_u_theta_dot_of_u_psi_0) - b_u_theta_dot_of_u_phi_0
        - b_u_theta_dot_of_u_phi_2_0;
    let b_alpha_rotor_frame_3_of_u_theta_0 = w_inner_frame_in_rotor_frame_1_of_u_theta_0
        * w_inner_frame_in_rotor_frame_2_of_u_theta_0;
    let b_alpha_rotor_frame_3_of_u_theta_2_0 = w_inner_frame_in_rotor_frame_2_of_u_theta_0
        * w_inner_frame_in_rotor_frame_1_of_u_theta_0;
    let alpha_outer_frame_in_inner_frame_3_of_place_0 = G_u_psi_dot_of_place_0 * cos_theta_0;
    let u_phi_dot_2_0 = b_alpha_rotor_frame_3_of_u_theta_2_0
        .mul_add(
            minus_b_by_c,
            b_alpha_rotor_frame_3_of_u_theta_0
                .mul_add(b_by_c, u_psi_u_theta_sin_theta_3_0),
        ) + alpha_outer_frame_in_inner_frame_3_of_place_0;
    // Order 1: the rates, and what follows from them.
    let psi_1 = u_psi_0;
    let theta_1 = u_theta_0;
    let phi_1 = u_phi_0;
    let u_psi_1 = -G_u_psi_dot_of_place_0;
    let u_theta_1 = minus_1_by_ax_plus_b * b_u_theta_dot_of_place_0;
    let u_phi_1 = u_phi_dot_2_0;
    if series.len() > 1 {
        series[1] = [psi_1, theta_1, phi_1, u_psi_1, u_theta_1, u_phi_1];
    }
    let sin_theta_1 = theta_1 * cos_theta_0;
    let cos_theta_1 = -theta_1 * sin_theta_0;
    let u_psi_sin_theta_1 = sin_theta_1.mul_add(u_psi_0, u_psi_1 * sin_theta_0);
    let u_psi_cos_theta_1 = cos_theta_1.mul_add(u_psi_0, u_psi_1 * cos_theta_0);
    let sin_phi_1 = phi_1 * cos_phi_0;
    let cos_phi_1 = -phi_1 * sin_phi_0;
    let u_theta_cos_phi_1 = cos_phi_1.mul_add(u_theta_0, u_theta_1 * cos_phi_0);
    let u_psi_sin_theta_sin_phi_1 = u_psi_sin_theta_1
        .mul_add(sin_phi_0, sin_phi_1 * u_psi_sin_theta_0);
    let w_inner_frame_in_rotor_frame_1_of_u_theta_1 = u_theta_cos_phi_1 + u_psi_sin_theta_sin_phi_1;
    let u_theta_sin_phi_1 = sin_phi_1.mul_add(u_theta_0, u_theta_1 * sin_phi_0);
    let u_psi_sin_theta_cos_phi_1 = u_psi_sin_theta_1
        .mul_add(cos_phi_0, cos_phi_1 * u_psi_sin_theta_0);
    let w_inner_frame_in_rotor_frame_2_of_u_theta_1 = u_theta_sin_phi_1 - u_psi_sin_theta_cos_phi_1;
    let w_rotor_frame_3_of_u_phi_1 = u_phi_1 + u_psi_cos_theta_1;
    let b_alpha_rotor_frame_2_2_of_motion_1 = w_inner_frame_in_rotor_frame_1_of_u_theta_1
        .mul_add(
            w_rotor_frame_3_of_u_phi_0,
            w_rotor_frame_3_of_u_phi_1 * w_inner_frame_in_rotor_frame_1_of_u_theta_0,
        );
    let b_alpha_rotor_frame_2_2_of_motion_2_1 = w_inner_frame_in_rotor_frame_1_of_u_theta_1
        .mul_add(
            w_rotor_frame_3_of_u_phi_0,
            w_rotor_frame_3_of_u_phi_1 * w_inner_frame_in_rotor_frame_1_of_u_theta_0,
        );
    let b_of_motion_1 = w_inner_frame_in_rotor_frame_1_of_u_theta_1
        .mul_add(u_phi_0, u_phi_1 * w_inner_frame_in_rotor_frame_1_of_u_theta_0);
    let b_of_u_phi_1 = b_of_motion_1
        .mul_add(
            minus_b,
            b_alpha_rotor_frame_2_2_of_motion_2_1
                .mul_add(minus_c, B * b_alpha_rotor_frame_2_2_of_motion_1),
        );
    let b_alpha_rotor_frame_1_2_of_motion_1 = w_inner_frame_in_rotor_frame_2_of_u_theta_1
        .mul_add(
            w_rotor_frame_3_of_u_phi_0,
            w_rotor_frame_3_of_u_phi_1 * w_inner_frame_in_rotor_frame_2_of_u_theta_0,
        );
    let b_alpha_rotor_frame_1_2_of_motion_2_1 = w_inner_frame_in_rotor_frame_2_of_u_theta_1
        .mul_add(
            w_rotor_frame_3_of_u_phi_0,
            w_rotor_frame_3_of_u_phi_1 * w_inner_frame_in_rotor_frame_2_of_u_theta_0,
        );
    let b_2_of_motion_1 = w_inner_frame_in_rotor_frame_2_of_u_theta_1
        .mul_add(u_phi_0, u_phi_1 * w_inner_frame_in_rotor_frame_2_of_u_theta_0);
    let b_2_of_u_phi_1 = b_2_of_motion_1
        .mul_add(
            B,
            b_alpha_rotor_frame_1_2_of_motion_2_1
                .mul_add(minus_b, C * b_alpha_rotor_frame_1_2_of_motion_1),
        );
    let u_psi_u_theta_sin_theta_1 = u_psi_sin_theta_1
        .mul_add(u_theta_0, u_theta_1 * u_psi_sin_theta_0);
    let u_psi_u_theta_sin_theta_2_1 = u_psi_sin_theta_1
        .mul_add(u_theta_0, u_theta_1 * u_psi_sin_theta_0);
    let u_psi_u_theta_sin_theta_3_1 = u_psi_sin_theta_1
        .mul_add(u_theta_0, u_theta_1 * u_psi_sin_theta_0);
    let b_3_of_u_theta_1 = u_psi_u_theta_sin_theta_3_1
        .mul_add(
            minus_az,
            u_psi_u_theta_sin_theta_2_1.mul_add(minus_ax, Ay * u_psi_u_theta_sin_theta_1),
        );
    let u_psi_u_theta_cos_theta_1 = u_psi_cos_theta_1
        .mul_add(u_theta_0, u_theta_1 * u_psi_cos_theta_0);
    let u_psi_u_theta_cos_theta_2_1 = u_psi_cos_theta_1
        .mul_add(u_theta_0, u_theta_1 * u_psi_cos_theta_0);
    let b_alpha_inner_frame_2_2_of_u_phi_1 = b_of_u_phi_1
        .mul_add(cos_phi_0, cos_phi_1 * b_of_u_phi_0);
    let b_alpha_inner_frame_2_2_of_u_phi_2_1 = b_2_of_u_phi_1
        .mul_add(sin_phi_0, sin_phi_1 * b_2_of_u_phi_0);
    let u_psi_u_theta_cos_theta_3_1 = u_psi_cos_theta_1
        .mul_add(u_theta_0, u_theta_1 * u_psi_cos_theta_0);
    let b_4_of_u_theta_1 = u_psi_u_theta_cos_theta_3_1
        .mul_add(
            ay_plus_b,
            u_psi_u_theta_cos_theta_2_1.mul_add(minus_az, Ax * u_psi_u_theta_cos_theta_1),
        ) + b_alpha_inner_frame_2_2_of_u_phi_1 - b_alpha_inner_frame_2_2_of_u_phi_2_1;
    let b_u_psi_dot_of_u_theta_1 = b_3_of_u_theta_1
        .mul_add(cos_theta_0, cos_theta_1 * b_3_of_u_theta_0);
    let b_u_psi_dot_of_u_theta_2_1 = b_4_of_u_theta_1
        .mul_add(sin_theta_0, sin_theta_1 * b_4_of_u_theta_0);
    let b_u_psi_dot_of_place_1 = b_u_psi_dot_of_u_theta_1 + b_u_psi_dot_of_u_theta_2_1;
    let cos_theta_sq_1 = cos_theta_1 * (cos_theta_0 + cos_theta_0);
    let sin_theta_sq_1 = sin_theta_1 * (sin_theta_0 + sin_theta_0);
    let K_u_psi_dot_of_place_1 = sin_theta_sq_1.mul_add(ay_plus_b, Az * cos_theta_sq_1);
    let over_D_u_psi_dot_of_place_1 = -K_u_psi_dot_of_place_1
        * (over_D_u_psi_dot_of_place_0 * over_K_u_psi_dot_of_place);
    let G_u_psi_dot_of_place_1 = b_u_psi_dot_of_place_1
        .mul_add(
            over_D_u_psi_dot_of_place_0,
            over_D_u_psi_dot_of_place_1 * b_u_psi_dot_of_place_0,
        );
    let b_u_theta_dot_of_u_psi_1 = u_psi_cos_theta_1
        .mul_add(u_psi_sin_theta_0, u_psi_sin_theta_1 * u_psi_cos_theta_0);
    let b_u_theta_dot_of_u_psi_2_1 = u_psi_sin_theta_1
        .mul_add(u_psi_cos_theta_0, u_psi_cos_theta_1 * u_psi_sin_theta_0);
    let b_u_theta_dot_of_u_phi_1 = b_of_u_phi_1
        .mul_add(sin_phi_0, sin_phi_1 * b_of_u_phi_0);
    let b_u_theta_dot_of_u_phi_2_1 = b_2_of_u_phi_1
        .mul_add(cos_phi_0, cos_phi_1 * b_2_of_u_phi_0);
    let b_u_theta_dot_of_place_1 = b_u_theta_dot_of_u_psi_2_1
        .mul_add(minus_ay, Az * b_u_theta_dot_of_u_psi_1) - b_u_theta_dot_of_u_phi_1
        - b_u_theta_dot_of_u_phi_2_1;
    let b_alpha_rotor_frame_3_of_u_theta_1 = w_inner_frame_in_rotor_frame_2_of_u_theta_1
        .mul_add(
            w_inner_frame_in_rotor_frame_1_of_u_theta_0,
            w_inner_frame_in_rotor_frame_1_of_u_theta_1
                * w_inner_frame_in_rotor_frame_2_of_u_theta_0,
        );
    let b_alpha_rotor_frame_3_of_u_theta_2_1 = w_inner_frame_in_rotor_frame_1_of_u_theta_1
        .mul_add(
            w_inner_frame_in_rotor_frame_2_of_u_theta_0,
            w_inner_frame_in_rotor_frame_2_of_u_theta_1
                * w_inner_frame_in_rotor_frame_1_of_u_theta_0,
        );
    let alpha_outer_frame_in_inner_frame_3_of_place_1 = G_u_psi_dot_of_place_1
        .mul_add(cos_theta_0, cos_theta_1 * G_u_psi_dot_of_place_0);
    let u_phi_dot_2_1 = b_alpha_rotor_frame_3_of_u_theta_2_1
        .mul_add(
            minus_b_by_c,
            b_alpha_rotor_frame_3_of_u_theta_1
                .mul_add(b_by_c, u_psi_u_theta_sin_theta_3_1),
        ) + alpha_outer_frame_in_inner_frame_3_of_place_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                theta_1, theta_1, u_psi_1, u_psi_1, phi_1, phi_1, u_theta_1, sin_phi_1, u_theta_1,
                cos_phi_1, w_rotor_frame_3_of_u_phi_1, w_inner_frame_in_rotor_frame_1_of_u_theta_1,
                u_phi_1, w_inner_frame_in_rotor_frame_2_of_u_theta_1, w_rotor_frame_3_of_u_phi_1,
                u_phi_1, u_theta_1, u_psi_sin_theta_1, u_theta_1, u_psi_cos_theta_1, u_theta_1,
                cos_phi_1, sin_phi_1, u_theta_1, cos_theta_1, sin_theta_1, cos_theta_1, sin_theta_1,
                K_u_psi_dot_of_place_1, b_u_psi_dot_of_place_1, u_psi_sin_theta_1,
                u_psi_cos_theta_1, sin_phi_1, cos_phi_1,
                w_inner_frame_in_rotor_frame_1_of_u_theta_1,
                w_inner_frame_in_rotor_frame_2_of_u_theta_1, G_u_psi_dot_of_place_1,
            ]),
            padded([
                cos_theta_1, sin_theta_1, sin_theta_1, cos_theta_1, cos_phi_1, sin_phi_1, cos_phi_1,
                u_psi_sin_theta_1, sin_phi_1, u_psi_sin_theta_1,
                w_inner_frame_in_rotor_frame_1_of_u_theta_1, w_rotor_frame_3_of_u_phi_1,
                w_inner_frame_in_rotor_frame_1_of_u_theta_1, w_rotor_frame_3_of_u_phi_1,
                w_inner_frame_in_rotor_frame_2_of_u_theta_1,
                w_inner_frame_in_rotor_frame_2_of_u_theta_1, u_psi_sin_theta_1, u_theta_1,
                u_psi_sin_theta_1, u_theta_1, u_psi_cos_theta_1, b_of_u_phi_1, b_2_of_u_phi_1,
                u_psi_cos_theta_1, b_3_of_u_theta_1, b_4_of_u_theta_1, cos_theta_1, sin_theta_1,
                over_D_u_psi_dot_of_place_1, over_D_u_psi_dot_of_place_1, u_psi_cos_theta_1,
                u_psi_sin_theta_1, b_of_u_phi_1, b_2_of_u_phi_1,
                w_inner_frame_in_rotor_frame_2_of_u_theta_1,
                w_inner_frame_in_rotor_frame_1_of_u_theta_1, cos_theta_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta_last = theta_1;
    let mut phi_last = phi_1;
    let mut u_psi_last = u_psi_1;
    let mut u_theta_last = u_theta_1;
    let mut u_phi_last = u_phi_1;
    let mut sin_theta_last = sin_theta_1;
    let mut cos_theta_last = cos_theta_1;
    let mut u_psi_sin_theta_last = u_psi_sin_theta_1;
    let mut u_psi_cos_theta_last = u_psi_cos_theta_1;
    let mut sin_phi_last = sin_phi_1;
    let mut cos_phi_last = cos_phi_1;
    let mut w_inner_frame_in_rotor_frame_1_of_u_theta_last = w_inner_frame_in_rotor_frame_1_of_u_theta_1;
    let mut w_inner_frame_in_rotor_frame_2_of_u_theta_last = w_inner_frame_in_rotor_frame_2_of_u_theta_1;
    let mut w_rotor_frame_3_of_u_phi_last = w_rotor_frame_3_of_u_phi_1;
    let mut b_of_u_phi_last = b_of_u_phi_1;
    let mut b_2_of_u_phi_last = b_2_of_u_phi_1;
    let mut b_3_of_u_theta_last = b_3_of_u_theta_1;
    let mut b_4_of_u_theta_last = b_4_of_u_theta_1;
    let mut b_u_psi_dot_of_place_last = b_u_psi_dot_of_place_1;
    let mut K_u_psi_dot_of_place_last = K_u_psi_dot_of_place_1;
    let mut over_D_u_psi_dot_of_place_last = over_D_u_psi_dot_of_place_1;
    let mut G_u_psi_dot_of_place_last = G_u_psi_dot_of_place_1;
    let mut next = [S::int(0); 40];
    // Rates at order k - 1.
    let mut psi_rate = u_psi_1;
    let mut theta_rate = u_theta_1;
    let mut phi_rate = u_phi_1;
    let mut u_psi_rate = -G_u_psi_dot_of_place_1;
    let mut u_theta_rate = minus_1_by_ax_plus_b * b_u_theta_dot_of_place_1;
    let mut u_phi_rate = u_phi_dot_2_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let psi = psi_rate * over_k;
        let theta = theta_rate * over_k;
        let phi = phi_rate * over_k;
        let u_psi = u_psi_rate * over_k;
        let u_theta = u_theta_rate * over_k;
        let u_phi = u_phi_rate * over_k;
        series[order] = [psi, theta, phi, u_psi, u_theta, u_phi];
        if order + 1 == series.len() {
            break;
        }
        let count = S::int(order as i64);
        let sums = if order % 2 == 0 {
            // All convolutions of order k, and of order k + 1 but for the terms with coefficients of order
            //   k.
            let pair = pair_sums(&history[..order]);
            next = pair[1];
            pair[0]
        } else {
            // Those terms, which also have coefficients of order 1.
            padded([
                theta_1
                    .mul_add(
                        cos_theta_last,
                        (count_last * theta_last).mul_add(cos_theta_1, next[0]),
                    ),
                theta_1
                    .mul_add(
                        sin_theta_last,
                        (count_last * theta_last).mul_add(sin_theta_1, next[1]),
                    ),
                u_psi_1
                    .mul_add(sin_theta_last, u_psi_last.mul_add(sin_theta_1, next[2])),
                u_psi_1
                    .mul_add(cos_theta_last, u_psi_last.mul_add(cos_theta_1, next[3])),
                phi_1
                    .mul_add(
                        cos_phi_last,
                        (count_last * phi_last).mul_add(cos_phi_1, next[4]),
                    ),
                phi_1
                    .mul_add(
                        sin_phi_last,
                        (count_last * phi_last).mul_add(sin_phi_1, next[5]),
                    ),
                u_theta_1
                    .mul_add(cos_phi_last, u_theta_last.mul_add(cos_phi_1, next[6])),
                sin_phi_1
                    .mul_add(
                        u_psi_sin_theta_last,
                        sin_phi_last.mul_add(u_psi_sin_theta_1, next[7]),
                    ),
                u_theta_1
                    .mul_add(sin_phi_last, u_theta_last.mul_add(sin_phi_1, next[8])),
                cos_phi_1
                    .mul_add(
                        u_psi_sin_theta_last,
                        cos_phi_last.mul_add(u_psi_sin_theta_1, next[9]),
                    ),
                w_rotor_frame_3_of_u_phi_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_1_of_u_theta_last,
                        w_rotor_frame_3_of_u_phi_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_1_of_u_theta_1, next[10],
                            ),
                    ),
                w_inner_frame_in_rotor_frame_1_of_u_theta_1
                    .mul_add(
                        w_rotor_frame_3_of_u_phi_last,
                        w_inner_frame_in_rotor_frame_1_of_u_theta_last
                            .mul_add(w_rotor_frame_3_of_u_phi_1, next[11]),
                    ),
                u_phi_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_1_of_u_theta_last,
                        u_phi_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_1_of_u_theta_1, next[12],
                            ),
                    ),
                w_inner_frame_in_rotor_frame_2_of_u_theta_1
                    .mul_add(
                        w_rotor_frame_3_of_u_phi_last,
                        w_inner_frame_in_rotor_frame_2_of_u_theta_last
                            .mul_add(w_rotor_frame_3_of_u_phi_1, next[13]),
                    ),
                w_rotor_frame_3_of_u_phi_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_2_of_u_theta_last,
                        w_rotor_frame_3_of_u_phi_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_2_of_u_theta_1, next[14],
                            ),
                    ),
                u_phi_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_2_of_u_theta_last,
                        u_phi_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_2_of_u_theta_1, next[15],
                            ),
                    ),
                u_theta_1
                    .mul_add(
                        u_psi_sin_theta_last,
                        u_theta_last.mul_add(u_psi_sin_theta_1, next[16]),
                    ),
                u_psi_sin_theta_1
                    .mul_add(
                        u_theta_last,
                        u_psi_sin_theta_last.mul_add(u_theta_1, next[17]),
                    ),
                u_theta_1
                    .mul_add(
                        u_psi_sin_theta_last,
                        u_theta_last.mul_add(u_psi_sin_theta_1, next[18]),
                    ),
                u_psi_cos_theta_1
                    .mul_add(
                        u_theta_last,
                        u_psi_cos_theta_last.mul_add(u_theta_1, next[19]),
                    ),
                u_theta_1
                    .mul_add(
                        u_psi_cos_theta_last,
                        u_theta_last.mul_add(u_psi_cos_theta_1, next[20]),
                    ),
                cos_phi_1
                    .mul_add(
                        b_of_u_phi_last,
                        cos_phi_last.mul_add(b_of_u_phi_1, next[21]),
                    ),
                sin_phi_1
                    .mul_add(
                        b_2_of_u_phi_last,
                        sin_phi_last.mul_add(b_2_of_u_phi_1, next[22]),
                    ),
                u_theta_1
                    .mul_add(
                        u_psi_cos_theta_last,
                        u_theta_last.mul_add(u_psi_cos_theta_1, next[23]),
                    ),
                cos_theta_1
                    .mul_add(
                        b_3_of_u_theta_last,
                        cos_theta_last.mul_add(b_3_of_u_theta_1, next[24]),
                    ),
                sin_theta_1
                    .mul_add(
                        b_4_of_u_theta_last,
                        sin_theta_last.mul_add(b_4_of_u_theta_1, next[25]),
                    ),
                (cos_theta_1 + cos_theta_1).mul_add(cos_theta_last, next[26]),
                (sin_theta_1 + sin_theta_1).mul_add(sin_theta_last, next[27]),
                K_u_psi_dot_of_place_1
                    .mul_add(
                        over_D_u_psi_dot_of_place_last,
                        K_u_psi_dot_of_place_last
                            .mul_add(over_D_u_psi_dot_of_place_1, next[28]),
                    ),
                b_u_psi_dot_of_place_1
                    .mul_add(
                        over_D_u_psi_dot_of_place_last,
                        b_u_psi_dot_of_place_last
                            .mul_add(over_D_u_psi_dot_of_place_1, next[29]),
                    ),
                u_psi_sin_theta_1
                    .mul_add(
                        u_psi_cos_theta_last,
                        u_psi_sin_theta_last.mul_add(u_psi_cos_theta_1, next[30]),
                    ),
                u_psi_cos_theta_1
                    .mul_add(
                        u_psi_sin_theta_last,
                        u_psi_cos_theta_last.mul_add(u_psi_sin_theta_1, next[31]),
                    ),
                sin_phi_1
                    .mul_add(
                        b_of_u_phi_last,
                        sin_phi_last.mul_add(b_of_u_phi_1, next[32]),
                    ),
                cos_phi_1
                    .mul_add(
                        b_2_of_u_phi_last,
                        cos_phi_last.mul_add(b_2_of_u_phi_1, next[33]),
                    ),
                w_inner_frame_in_rotor_frame_1_of_u_theta_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_2_of_u_theta_last,
                        w_inner_frame_in_rotor_frame_1_of_u_theta_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_2_of_u_theta_1, next[34],
                            ),
                    ),
                w_inner_frame_in_rotor_frame_2_of_u_theta_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_1_of_u_theta_last,
                        w_inner_frame_in_rotor_frame_2_of_u_theta_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_1_of_u_theta_1, next[35],
                            ),
                    ),
                G_u_psi_dot_of_place_1
                    .mul_add(
                        cos_theta_last,
                        G_u_psi_dot_of_place_last.mul_add(cos_theta_1, next[36]),
                    ),
            ])
        };
        // sin_theta = sin(theta)
        let sin_theta = theta.mul_add(cos_theta_0, sums[0] * over_k);
        // cos_theta = cos(theta)
        let cos_theta = -theta.mul_add(sin_theta_0, sums[1] * over_k);
        // u_psi_sin_theta = u_psi*sin_theta
        let u_psi_sin_theta = sin_theta
            .mul_add(u_psi_0, u_psi.mul_add(sin_theta_0, sums[2]));
        // u_psi_cos_theta = u_psi*cos_theta
        let u_psi_cos_theta = cos_theta
            .mul_add(u_psi_0, u_psi.mul_add(cos_theta_0, sums[3]));
        // sin_phi = sin(phi)
        let sin_phi = phi.mul_add(cos_phi_0, sums[4] * over_k);
        // cos_phi = cos(phi)
        let cos_phi = -phi.mul_add(sin_phi_0, sums[5] * over_k);
        // u_theta_cos_phi = u_theta*cos_phi
        let u_theta_cos_phi = cos_phi
            .mul_add(u_theta_0, u_theta.mul_add(cos_phi_0, sums[6]));
        // u_psi_sin_theta_sin_phi = sin_phi*u_psi_sin_theta
        let u_psi_sin_theta_sin_phi = u_psi_sin_theta
            .mul_add(sin_phi_0, sin_phi.mul_add(u_psi_sin_theta_0, sums[7]));
        // w_inner_frame_in_rotor_frame_1_of_u_theta = u_theta_cos_phi + u_psi_sin_theta_sin_phi
        let w_inner_frame_in_rotor_frame_1_of_u_theta = u_theta_cos_phi + u_psi_sin_theta_sin_phi;
        // u_theta_sin_phi = u_theta*sin_phi
        let u_theta_sin_phi = sin_phi
            .mul_add(u_theta_0, u_theta.mul_add(sin_phi_0, sums[8]));
        // u_psi_sin_theta_cos_phi = cos_phi*u_psi_sin_theta
        let u_psi_sin_theta_cos_phi = u_psi_sin_theta
            .mul_add(cos_phi_0, cos_phi.mul_add(u_psi_sin_theta_0, sums[9]));
        // w_inner_frame_in_rotor_frame_2_of_u_theta = u_theta_sin_phi - u_psi_sin_theta_cos_phi
        let w_inner_frame_in_rotor_frame_2_of_u_theta = u_theta_sin_phi - u_psi_sin_theta_cos_phi;
        // w_rotor_frame_3_of_u_phi = u_phi + u_psi_cos_theta
        let w_rotor_frame_3_of_u_phi = u_phi + u_psi_cos_theta;
        // b_alpha_rotor_frame_2_2_of_motion =
        //   w_rotor_frame_3_of_u_phi*w_inner_frame_in_rotor_frame_1_of_u_theta
        let b_alpha_rotor_frame_2_2_of_motion = w_inner_frame_in_rotor_frame_1_of_u_theta
            .mul_add(
                w_rotor_frame_3_of_u_phi_0,
                w_rotor_frame_3_of_u_phi
                    .mul_add(w_inner_frame_in_rotor_frame_1_of_u_theta_0, sums[10]),
            );
        // b_alpha_rotor_frame_2_2_of_motion_2 =
        //   w_inner_frame_in_rotor_frame_1_of_u_theta*w_rotor_frame_3_of_u_phi
        let b_alpha_rotor_frame_2_2_of_motion_2 = w_inner_frame_in_rotor_frame_1_of_u_theta
            .mul_add(
                w_rotor_frame_3_of_u_phi_0,
                w_rotor_frame_3_of_u_phi
                    .mul_add(w_inner_frame_in_rotor_frame_1_of_u_theta_0, sums[11]),
            );
        // b_of_motion = u_phi*w_inner_frame_in_rotor_frame_1_of_u_theta
        let b_of_motion = w_inner_frame_in_rotor_frame_1_of_u_theta
            .mul_add(
                u_phi_0,
                u_phi.mul_add(w_inner_frame_in_rotor_frame_1_of_u_theta_0, sums[12]),
            );
        // b_of_u_phi = B*b_alpha_rotor_frame_2_2_of_motion + minus_c*b_alpha_rotor_frame_2_2_of_motion_2 +
        //   minus_b*b_of_motion
        let b_of_u_phi = b_of_motion
            .mul_add(
                minus_b,
                b_alpha_rotor_frame_2_2_of_motion_2
                    .mul_add(minus_c, B * b_alpha_rotor_frame_2_2_of_motion),
            );
        // b_alpha_rotor_frame_1_2_of_motion =
        //   w_inner_frame_in_rotor_frame_2_of_u_theta*w_rotor_frame_3_of_u_phi
        let b_alpha_rotor_frame_1_2_of_motion = w_inner_frame_in_rotor_frame_2_of_u_theta
            .mul_add(
                w_rotor_frame_3_of_u_phi_0,
                w_rotor_frame_3_of_u_phi
                    .mul_add(w_inner_frame_in_rotor_frame_2_of_u_theta_0, sums[13]),
            );
        // b_alpha_rotor_frame_1_2_of_motion_2 =
        //   w_rotor_frame_3_of_u_phi*w_inner_frame_in_rotor_frame_2_of_u_theta
        let b_alpha_rotor_frame_1_2_of_motion_2 = w_inner_frame_in_rotor_frame_2_of_u_theta
            .mul_add(
                w_rotor_frame_3_of_u_phi_0,
                w_rotor_frame_3_of_u_phi
                    .mul_add(w_inner_frame_in_rotor_frame_2_of_u_theta_0, sums[14]),
            );
        // b_2_of_motion = u_phi*w_inner_frame_in_rotor_frame_2_of_u_theta
        let b_2_of_motion = w_inner_frame_in_rotor_frame_2_of_u_theta
            .mul_add(
                u_phi_0,
                u_phi.mul_add(w_inner_frame_in_rotor_frame_2_of_u_theta_0, sums[15]),
            );
        // b_2_of_u_phi = C*b_alpha_rotor_frame_1_2_of_motion + minus_b*b_alpha_rotor_frame_1_2_of_motion_2
        //   + B*b_2_of_motion
        let b_2_of_u_phi = b_2_of_motion
            .mul_add(
                B,
                b_alpha_rotor_frame_1_2_of_motion_2
                    .mul_add(minus_b, C * b_alpha_rotor_frame_1_2_of_motion),
            );
        // u_psi_u_theta_sin_theta = u_theta*u_psi_sin_theta
        let u_psi_u_theta_sin_theta = u_psi_sin_theta
            .mul_add(u_theta_0, u_theta.mul_add(u_psi_sin_theta_0, sums[16]));
        // u_psi_u_theta_sin_theta_2 = u_psi_sin_theta*u_theta
        let u_psi_u_theta_sin_theta_2 = u_psi_sin_theta
            .mul_add(u_theta_0, u_theta.mul_add(u_psi_sin_theta_0, sums[17]));
        // u_psi_u_theta_sin_theta_3 = u_theta*u_psi_sin_theta
        let u_psi_u_theta_sin_theta_3 = u_psi_sin_theta
            .mul_add(u_theta_0, u_theta.mul_add(u_psi_sin_theta_0, sums[18]));
        // b_3_of_u_theta = Ay*u_psi_u_theta_sin_theta + minus_ax*u_psi_u_theta_sin_theta_2 +
        //   minus_az*u_psi_u_theta_sin_theta_3
        let b_3_of_u_theta = u_psi_u_theta_sin_theta_3
            .mul_add(
                minus_az,
                u_psi_u_theta_sin_theta_2.mul_add(minus_ax, Ay * u_psi_u_theta_sin_theta),
            );
        // u_psi_u_theta_cos_theta = u_psi_cos_theta*u_theta
        let u_psi_u_theta_cos_theta = u_psi_cos_theta
            .mul_add(u_theta_0, u_theta.mul_add(u_psi_cos_theta_0, sums[19]));
        // u_psi_u_theta_cos_theta_2 = u_theta*u_psi_cos_theta
        let u_psi_u_theta_cos_theta_2 = u_psi_cos_theta
            .mul_add(u_theta_0, u_theta.mul_add(u_psi_cos_theta_0, sums[20]));
        // b_alpha_inner_frame_2_2_of_u_phi = cos_phi*b_of_u_phi
        let b_alpha_inner_frame_2_2_of_u_phi = b_of_u_phi
            .mul_add(cos_phi_0, cos_phi.mul_add(b_of_u_phi_0, sums[21]));
        // b_alpha_inner_frame_2_2_of_u_phi_2 = sin_phi*b_2_of_u_phi
        let b_alpha_inner_frame_2_2_of_u_phi_2 = b_2_of_u_phi
            .mul_add(sin_phi_0, sin_phi.mul_add(b_2_of_u_phi_0, sums[22]));
        // u_psi_u_theta_cos_theta_3 = u_theta*u_psi_cos_theta
        let u_psi_u_theta_cos_theta_3 = u_psi_cos_theta
            .mul_add(u_theta_0, u_theta.mul_add(u_psi_cos_theta_0, sums[23]));
        // b_4_of_u_theta = Ax*u_psi_u_theta_cos_theta + minus_az*u_psi_u_theta_cos_theta_2 +
        //   b_alpha_inner_frame_2_2_of_u_phi - b_alpha_inner_frame_2_2_of_u_phi_2 +
        //   ay_plus_b*u_psi_u_theta_cos_theta_3
        let b_4_of_u_theta = u_psi_u_theta_cos_theta_3
            .mul_add(
                ay_plus_b,
                u_psi_u_theta_cos_theta_2.mul_add(minus_az, Ax * u_psi_u_theta_cos_theta),
            ) + b_alpha_inner_frame_2_2_of_u_phi - b_alpha_inner_frame_2_2_of_u_phi_2;
        // b_u_psi_dot_of_u_theta = cos_theta*b_3_of_u_theta
        let b_u_psi_dot_of_u_theta = b_3_of_u_theta
            .mul_add(cos_theta_0, cos_theta.mul_add(b_3_of_u_theta_0, sums[24]));
        // b_u_psi_dot_of_u_theta_2 = sin_theta*b_4_of_u_theta
        let b_u_psi_dot_of_u_theta_2 = b_4_of_u_theta
            .mul_add(sin_theta_0, sin_theta.mul_add(b_4_of_u_theta_0, sums[25]));
        // b_u_psi_dot_of_place = b_u_psi_dot_of_u_theta + b_u_psi_dot_of_u_theta_2
        let b_u_psi_dot_of_place = b_u_psi_dot_of_u_theta + b_u_psi_dot_of_u_theta_2;
        // cos_theta_sq = cos_theta*cos_theta
        let cos_theta_sq = cos_theta.mul_add(cos_theta_0 + cos_theta_0, sums[26]);
        // sin_theta_sq = sin_theta*sin_theta
        let sin_theta_sq = sin_theta.mul_add(sin_theta_0 + sin_theta_0, sums[27]);
        // K_u_psi_dot_of_place = Iz + Az*cos_theta_sq + ay_plus_b*sin_theta_sq
        let K_u_psi_dot_of_place = sin_theta_sq.mul_add(ay_plus_b, Az * cos_theta_sq);
        // over_D_u_psi_dot_of_place = 1/K_u_psi_dot_of_place
        let over_D_u_psi_dot_of_place = K_u_psi_dot_of_place
            .mul_add(
                -(over_D_u_psi_dot_of_place_0 * over_K_u_psi_dot_of_place),
                -(sums[28] * over_K_u_psi_dot_of_place),
            );
        // G_u_psi_dot_of_place = b_u_psi_dot_of_place*over_D_u_psi_dot_of_place
        let G_u_psi_dot_of_place = b_u_psi_dot_of_place
            .mul_add(
                over_D_u_psi_dot_of_place_0,
                over_D_u_psi_dot_of_place.mul_add(b_u_psi_dot_of_place_0, sums[29]),
            );
        // b_u_theta_dot_of_u_psi = u_psi_sin_theta*u_psi_cos_theta
        let b_u_theta_dot_of_u_psi = u_psi_cos_theta
            .mul_add(
                u_psi_sin_theta_0,
                u_psi_sin_theta.mul_add(u_psi_cos_theta_0, sums[30]),
            );
        // b_u_theta_dot_of_u_psi_2 = u_psi_cos_theta*u_psi_sin_theta
        let b_u_theta_dot_of_u_psi_2 = u_psi_sin_theta
            .mul_add(
                u_psi_cos_theta_0,
                u_psi_cos_theta.mul_add(u_psi_sin_theta_0, sums[31]),
            );
        // b_u_theta_dot_of_u_phi = sin_phi*b_of_u_phi
        let b_u_theta_dot_of_u_phi = b_of_u_phi
            .mul_add(sin_phi_0, sin_phi.mul_add(b_of_u_phi_0, sums[32]));
        // b_u_theta_dot_of_u_phi_2 = cos_phi*b_2_of_u_phi
        let b_u_theta_dot_of_u_phi_2 = b_2_of_u_phi
            .mul_add(cos_phi_0, cos_phi.mul_add(b_2_of_u_phi_0, sums[33]));
        // b_u_theta_dot_of_place = Az*b_u_theta_dot_of_u_psi + minus_ay*b_u_theta_dot_of_u_psi_2 -
        //   b_u_theta_dot_of_u_phi - b_u_theta_dot_of_u_phi_2
        let b_u_theta_dot_of_place = b_u_theta_dot_of_u_psi_2
            .mul_add(minus_ay, Az * b_u_theta_dot_of_u_psi) - b_u_theta_dot_of_u_phi
            - b_u_theta_dot_of_u_phi_2;
        // b_alpha_rotor_frame_3_of_u_theta =
        //   w_inner_frame_in_rotor_frame_1_of_u_theta*w_inner_frame_in_rotor_frame_2_of_u_theta
        let b_alpha_rotor_frame_3_of_u_theta = w_inner_frame_in_rotor_frame_2_of_u_theta
            .mul_add(
                w_inner_frame_in_rotor_frame_1_of_u_theta_0,
                w_inner_frame_in_rotor_frame_1_of_u_theta
                    .mul_add(w_inner_frame_in_rotor_frame_2_of_u_theta_0, sums[34]),
            );
        // b_alpha_rotor_frame_3_of_u_theta_2 =
        //   w_inner_frame_in_rotor_frame_2_of_u_theta*w_inner_frame_in_rotor_frame_1_of_u_theta
        let b_alpha_rotor_frame_3_of_u_theta_2 = w_inner_frame_in_rotor_frame_1_of_u_theta
            .mul_add(
                w_inner_frame_in_rotor_frame_2_of_u_theta_0,
                w_inner_frame_in_rotor_frame_2_of_u_theta
                    .mul_add(w_inner_frame_in_rotor_frame_1_of_u_theta_0, sums[35]),
            );
        // alpha_outer_frame_in_inner_frame_3_of_place = G_u_psi_dot_of_place*cos_theta
        let alpha_outer_frame_in_inner_frame_3_of_place = G_u_psi_dot_of_place
            .mul_add(cos_theta_0, cos_theta.mul_add(G_u_psi_dot_of_place_0, sums[36]));
        // u_phi_dot_2 = u_psi_u_theta_sin_theta_3 + alpha_outer_frame_in_inner_frame_3_of_place +
        //   b_by_c*b_alpha_rotor_frame_3_of_u_theta + minus_b_by_c*b_alpha_rotor_frame_3_of_u_theta_2
        let u_phi_dot_2 = b_alpha_rotor_frame_3_of_u_theta_2
            .mul_add(
                minus_b_by_c,
                b_alpha_rotor_frame_3_of_u_theta
                    .mul_add(b_by_c, u_psi_u_theta_sin_theta_3),
            ) + alpha_outer_frame_in_inner_frame_3_of_place;
        psi_rate = u_psi;
        theta_rate = u_theta;
        phi_rate = u_phi;
        u_psi_rate = -G_u_psi_dot_of_place;
        u_theta_rate = minus_1_by_ax_plus_b * b_u_theta_dot_of_place;
        u_phi_rate = u_phi_dot_2;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * theta,
                count * theta,
                u_psi, u_psi,
                count * phi,
                count * phi,
                u_theta, sin_phi, u_theta, cos_phi, w_rotor_frame_3_of_u_phi,
                w_inner_frame_in_rotor_frame_1_of_u_theta, u_phi,
                w_inner_frame_in_rotor_frame_2_of_u_theta, w_rotor_frame_3_of_u_phi, u_phi, u_theta,
                u_psi_sin_theta, u_theta, u_psi_cos_theta, u_theta, cos_phi, sin_phi, u_theta,
                cos_theta, sin_theta, cos_theta, sin_theta, K_u_psi_dot_of_place,
                b_u_psi_dot_of_place, u_psi_sin_theta, u_psi_cos_theta, sin_phi, cos_phi,
                w_inner_frame_in_rotor_frame_1_of_u_theta,
                w_inner_frame_in_rotor_frame_2_of_u_theta, G_u_psi_dot_of_place,
            ]),
            padded([
                cos_theta, sin_theta, sin_theta, cos_theta, cos_phi, sin_phi, cos_phi,
                u_psi_sin_theta, sin_phi, u_psi_sin_theta,
                w_inner_frame_in_rotor_frame_1_of_u_theta, w_rotor_frame_3_of_u_phi,
                w_inner_frame_in_rotor_frame_1_of_u_theta, w_rotor_frame_3_of_u_phi,
                w_inner_frame_in_rotor_frame_2_of_u_theta,
                w_inner_frame_in_rotor_frame_2_of_u_theta, u_psi_sin_theta, u_theta,
                u_psi_sin_theta, u_theta, u_psi_cos_theta, b_of_u_phi, b_2_of_u_phi,
                u_psi_cos_theta, b_3_of_u_theta, b_4_of_u_theta, cos_theta, sin_theta,
                over_D_u_psi_dot_of_place, over_D_u_psi_dot_of_place, u_psi_cos_theta,
                u_psi_sin_theta, b_of_u_phi, b_2_of_u_phi,
                w_inner_frame_in_rotor_frame_2_of_u_theta,
                w_inner_frame_in_rotor_frame_1_of_u_theta, cos_theta,
            ]),
        ];
        count_last = count;
        theta_last = theta;
        phi_last = phi;
        u_psi_last = u_psi;
        u_theta_last = u_theta;
        u_phi_last = u_phi;
        sin_theta_last = sin_theta;
        cos_theta_last = cos_theta;
        u_psi_sin_theta_last = u_psi_sin_theta;
        u_psi_cos_theta_last = u_psi_cos_theta;
        sin_phi_last = sin_phi;
        cos_phi_last = cos_phi;
        w_inner_frame_in_rotor_frame_1_of_u_theta_last = w_inner_frame_in_rotor_frame_1_of_u_theta;
        w_inner_frame_in_rotor_frame_2_of_u_theta_last = w_inner_frame_in_rotor_frame_2_of_u_theta;
        w_rotor_frame_3_of_u_phi_last = w_rotor_frame_3_of_u_phi;
        b_of_u_phi_last = b_of_u_phi;
        b_2_of_u_phi_last = b_2_of_u_phi;
        b_3_of_u_theta_last = b_3_of_u_theta;
        b_4_of_u_theta_last = b_4_of_u_theta;
        b_u_psi_dot_of_place_last = b_u_psi_dot_of_place;
        K_u_psi_dot_of_place_last = K_u_psi_dot_of_place;
        over_D_u_psi_dot_of_place_last = over_D_u_psi_dot_of_place;
        G_u_psi_dot_of_place_last = G_u_psi_dot_of_place;
    }
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
        out.copy_from_slice(
            jacobian(&Parameters::from_slice(p), array(q), array(v)).as_flattened(),
        );
    }
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, order: usize) -> usize {
        80 * order + SLACK
    }
    fn taylor(&self, p: &[S], order: usize, x: &mut [S], work: &mut [S]) {
        S::dispatch(
            #[inline(always)]
            || {
                let x = &mut x.as_chunks_mut().0[..=order];
                taylor(&Parameters::from_slice(p), x, rows(work));
            },
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
    slice.try_into().expect("a slice of the length that System states")
}
