//! Gyroscope in gimbals: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/gimbals/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows psi, theta, phi.
///
/// 27 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    _q_dot: &[S; 3],
) -> [[S; 3]; 3] {
    let Parameters { Iz, Ax, Ay, Az, B, C, .. } = *p;
    let [_, theta, phi] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w_inner_frame_in_rotor_frame_1_4 = sin(theta)*sin(phi)
    let w_inner_frame_in_rotor_frame_1_4 = sin_theta * sin_phi;
    // w_inner_frame_in_rotor_frame_2_4 = sin(theta)*cos(phi)
    let w_inner_frame_in_rotor_frame_2_4 = sin_theta * cos_phi;
    // H_inner_2_4 = Ay*sin(theta)
    let H_inner_2_4 = Ay * sin_theta;
    // H_inner_3_4 = Az*cos(theta)
    let H_inner_3_4 = Az * cos_theta;
    // H_rotor_1_4 = B*w_inner_frame_in_rotor_frame_1_4
    let H_rotor_1_4 = B * w_inner_frame_in_rotor_frame_1_4;
    // H_rotor_2_4 = B*w_inner_frame_in_rotor_frame_2_4
    let H_rotor_2_4 = B * w_inner_frame_in_rotor_frame_2_4;
    let c_cos_theta = C * cos_theta;
    // H_rotor_3_4 = C*cos(theta)
    let H_rotor_3_4 = c_cos_theta;
    // p_w_outer_frame_in_inner_frame_3_4 = H_inner_3_4 + H_rotor_3_4
    let p_w_outer_frame_in_inner_frame_3_4 = H_inner_3_4 + H_rotor_3_4;
    // p_w_outer_frame_in_inner_frame_2_4 = H_inner_2_4 + H_rotor_1_4*sin(phi) + H_rotor_2_4*cos(phi)
    let p_w_outer_frame_in_inner_frame_2_4 = H_rotor_1_4.mul_add(sin_phi, H_inner_2_4)
        + H_rotor_2_4 * cos_phi;
    // H_rotor_1_5 = B*cos(phi)
    let H_rotor_1_5 = B * cos_phi;
    // H_rotor_2_5 = B*sin(phi)
    let H_rotor_2_5 = B * sin_phi;
    // p_w_outer_frame_in_inner_frame_2_5 = H_rotor_2_5*cos(phi) - H_rotor_1_5*sin(phi)
    let p_w_outer_frame_in_inner_frame_2_5 = (-H_rotor_1_5)
        .mul_add(sin_phi, H_rotor_2_5 * cos_phi);
    // Entries that are not zero; upper triangle.
    // M11 = Iz + p_w_outer_frame_in_inner_frame_3_4*cos(theta) +
    //   p_w_outer_frame_in_inner_frame_2_4*sin(theta)
    let m11 = p_w_outer_frame_in_inner_frame_3_4.mul_add(cos_theta, Iz)
        + p_w_outer_frame_in_inner_frame_2_4 * sin_theta;
    // M12 = -p_w_outer_frame_in_inner_frame_2_5*sin(theta)
    let m12 = -p_w_outer_frame_in_inner_frame_2_5 * sin_theta;
    // M13 = C*cos(theta)
    let m13 = c_cos_theta;
    // M22 = Ax + H_rotor_1_5*cos(phi) + H_rotor_2_5*sin(phi)
    let m22 = H_rotor_1_5.mul_add(cos_phi, Ax) + H_rotor_2_5 * sin_phi;
    // M33 = C
    let m33 = C;
    let zero = S::int(0);
    [[m11, m12, m13], [m12, m22, zero], [m13, zero, m33]]
}

/// Right-hand side of the linear system; unknowns (psi'', theta'', phi'').
///
/// 63 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], q_dot: &[S; 3]) -> [S; 3] {
    let Parameters { Ay, Az, B, C, .. } = *p;
    let [_, theta, phi] = *q;
    let [psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w_outer_frame_in_inner_frame_2 = psi'*sin(theta)
    let w_outer_frame_in_inner_frame_2 = psi_dot * sin_theta;
    // w_outer_frame_in_inner_frame_3 = psi'*cos(theta)
    let w_outer_frame_in_inner_frame_3 = psi_dot * cos_theta;
    // w_inner_frame_in_rotor_frame_1 = theta'*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1 = w_outer_frame_in_inner_frame_2
        .mul_add(sin_phi, theta_dot * cos_phi);
    // w_outer_frame_in_inner_frame_2*cos(phi) - theta'*sin(phi)
    let w_inner_frame_in_rotor_frame_2_of_theta_dot = (-theta_dot)
        .mul_add(sin_phi, w_outer_frame_in_inner_frame_2 * cos_phi);
    // w_inner_frame_in_rotor_frame_2 = theta'*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2 = -w_inner_frame_in_rotor_frame_2_of_theta_dot;
    // w_rotor_frame_3 = phi' + w_outer_frame_in_inner_frame_3
    let w_rotor_frame_3 = phi_dot + w_outer_frame_in_inner_frame_3;
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
    // p_w_outer_frame_in_inner_frame_3 = H_inner_3 + H_rotor_3
    let p_w_outer_frame_in_inner_frame_3 = H_inner_3 + H_rotor_3;
    // H_rotor_2*cos(phi) - H_rotor_1*sin(phi)
    let p_w_outer_frame_in_inner_frame_2_of_place = (-H_rotor_1)
        .mul_add(sin_phi, H_rotor_2 * cos_phi);
    // p_w_outer_frame_in_inner_frame_2 = H_inner_2 + H_rotor_1*sin(phi) - H_rotor_2*cos(phi)
    let p_w_outer_frame_in_inner_frame_2 = H_inner_2 - p_w_outer_frame_in_inner_frame_2_of_place;
    // w_outer_frame_in_inner_frame_2_2 = psi'*theta'*cos(theta)
    let w_outer_frame_in_inner_frame_2_2 = theta_dot * w_outer_frame_in_inner_frame_3;
    // w_outer_frame_in_inner_frame_3_2 = psi'*theta'*sin(theta)
    let w_outer_frame_in_inner_frame_3_2 = theta_dot * w_outer_frame_in_inner_frame_2;
    // w_inner_frame_in_rotor_frame_1_2 = theta'*phi'*sin(phi) -
    //   phi'*w_outer_frame_in_inner_frame_2*cos(phi) - w_outer_frame_in_inner_frame_2_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1_2 = (-phi_dot)
        .mul_add(
            w_inner_frame_in_rotor_frame_2_of_theta_dot,
            -w_outer_frame_in_inner_frame_2_2 * sin_phi,
        );
    // w_inner_frame_in_rotor_frame_2_2 = theta'*phi'*cos(phi) +
    //   phi'*w_outer_frame_in_inner_frame_2*sin(phi) - w_outer_frame_in_inner_frame_2_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2_2 = (-w_outer_frame_in_inner_frame_2_2)
        .mul_add(cos_phi, phi_dot * w_inner_frame_in_rotor_frame_1);
    // H_inner_2_2 = Ay*w_outer_frame_in_inner_frame_2_2
    let H_inner_2_2 = Ay * w_outer_frame_in_inner_frame_2_2;
    // H_inner_3_2 = Az*w_outer_frame_in_inner_frame_3_2
    let H_inner_3_2 = Az * w_outer_frame_in_inner_frame_3_2;
    // H_rotor_1_2 = B*w_inner_frame_in_rotor_frame_1_2
    let H_rotor_1_2 = B * w_inner_frame_in_rotor_frame_1_2;
    // H_rotor_2_2 = B*w_inner_frame_in_rotor_frame_2_2
    let H_rotor_2_2 = B * w_inner_frame_in_rotor_frame_2_2;
    // H_rotor_3_2 = C*w_outer_frame_in_inner_frame_3_2
    let H_rotor_3_2 = C * w_outer_frame_in_inner_frame_3_2;
    // p_w_outer_frame_in_inner_frame_3_2 = H_inner_3_2 + H_rotor_3_2
    let p_w_outer_frame_in_inner_frame_3_2 = H_inner_3_2 + H_rotor_3_2;
    // p_w_outer_frame_in_inner_frame_2_2 = phi'*H_rotor_1*cos(phi) + phi'*H_rotor_2*sin(phi) + H_inner_2_2
    //   - H_rotor_1_2*sin(phi) - H_rotor_2_2*cos(phi)
    let p_w_outer_frame_in_inner_frame_2_2 = phi_dot
        * H_rotor_2.mul_add(sin_phi, H_rotor_1 * cos_phi) + H_inner_2_2
        - H_rotor_1_2 * sin_phi - H_rotor_2_2 * cos_phi;
    // p_w_outer_frame_in_inner_frame_3*sin(theta) - p_w_outer_frame_in_inner_frame_2*cos(theta)
    let f1_of_place = (-p_w_outer_frame_in_inner_frame_2)
        .mul_add(cos_theta, p_w_outer_frame_in_inner_frame_3 * sin_theta);
    // Values.
    // f1 = theta'*(p_w_outer_frame_in_inner_frame_3*sin(theta) -
    //   p_w_outer_frame_in_inner_frame_2*cos(theta)) + p_w_outer_frame_in_inner_frame_3_2*cos(theta) -
    //   p_w_outer_frame_in_inner_frame_2_2*sin(theta)
    let f1 = (-p_w_outer_frame_in_inner_frame_2_2)
        .mul_add(sin_theta, p_w_outer_frame_in_inner_frame_3_2 * cos_theta)
        + theta_dot * f1_of_place;
    // f2 = phi'*(H_rotor_1*sin(phi) - H_rotor_2*cos(phi)) +
    //   psi'*(p_w_outer_frame_in_inner_frame_2*cos(theta) - p_w_outer_frame_in_inner_frame_3*sin(theta)) +
    //   H_rotor_1_2*cos(phi) - H_rotor_2_2*sin(phi)
    let f2 = (-H_rotor_2_2).mul_add(sin_phi, H_rotor_1_2 * cos_phi)
        - phi_dot * p_w_outer_frame_in_inner_frame_2_of_place - psi_dot * f1_of_place;
    // f3 = H_rotor_1*(w_outer_frame_in_inner_frame_2*cos(phi) - theta'*sin(phi)) +
    //   H_rotor_2*(theta'*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)) + H_rotor_3_2
    let f3 = w_inner_frame_in_rotor_frame_1.mul_add(H_rotor_2, H_rotor_3_2)
        + H_rotor_1 * w_inner_frame_in_rotor_frame_2_of_theta_dot;
    [f1, f2, f3]
}

/// The accelerations (psi'', theta'', phi''), solved for when this code was generated.
///
/// 107 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 3] {
    let Parameters { Iz, Ax, Ay, Az, B, C, .. } = *p;
    let [_, theta, phi] = *q;
    let [psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w_outer_frame_in_inner_frame_2 = psi'*sin(theta)
    let w_outer_frame_in_inner_frame_2 = psi_dot * sin_theta;
    // w_outer_frame_in_inner_frame_3 = psi'*cos(theta)
    let w_outer_frame_in_inner_frame_3 = psi_dot * cos_theta;
    // w_inner_frame_in_rotor_frame_1 = theta'*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1 = w_outer_frame_in_inner_frame_2
        .mul_add(sin_phi, theta_dot * cos_phi);
    // w_outer_frame_in_inner_frame_2*cos(phi) - theta'*sin(phi)
    let w_inner_frame_in_rotor_frame_2_of_theta_dot = (-theta_dot)
        .mul_add(sin_phi, w_outer_frame_in_inner_frame_2 * cos_phi);
    // w_inner_frame_in_rotor_frame_2 = theta'*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2 = -w_inner_frame_in_rotor_frame_2_of_theta_dot;
    // w_rotor_frame_3 = phi' + w_outer_frame_in_inner_frame_3
    let w_rotor_frame_3 = phi_dot + w_outer_frame_in_inner_frame_3;
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
    // p_w_outer_frame_in_inner_frame_3 = H_inner_3 + H_rotor_3
    let p_w_outer_frame_in_inner_frame_3 = H_inner_3 + H_rotor_3;
    // H_rotor_2*cos(phi) - H_rotor_1*sin(phi)
    let p_w_outer_frame_in_inner_frame_2_of_place = (-H_rotor_1)
        .mul_add(sin_phi, H_rotor_2 * cos_phi);
    // p_w_outer_frame_in_inner_frame_2 = H_inner_2 + H_rotor_1*sin(phi) - H_rotor_2*cos(phi)
    let p_w_outer_frame_in_inner_frame_2 = H_inner_2 - p_w_outer_frame_in_inner_frame_2_of_place;
    // w_outer_frame_in_inner_frame_2_2 = psi'*theta'*cos(theta)
    let w_outer_frame_in_inner_frame_2_2 = theta_dot * w_outer_frame_in_inner_frame_3;
    // w_outer_frame_in_inner_frame_3_2 = psi'*theta'*sin(theta)
    let w_outer_frame_in_inner_frame_3_2 = theta_dot * w_outer_frame_in_inner_frame_2;
    // w_inner_frame_in_rotor_frame_1_2 = theta'*phi'*sin(phi) -
    //   phi'*w_outer_frame_in_inner_frame_2*cos(phi) - w_outer_frame_in_inner_frame_2_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1_2 = (-phi_dot)
        .mul_add(
            w_inner_frame_in_rotor_frame_2_of_theta_dot,
            -w_outer_frame_in_inner_frame_2_2 * sin_phi,
        );
    // w_inner_frame_in_rotor_frame_2_2 = theta'*phi'*cos(phi) +
    //   phi'*w_outer_frame_in_inner_frame_2*sin(phi) - w_outer_frame_in_inner_frame_2_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2_2 = (-w_outer_frame_in_inner_frame_2_2)
        .mul_add(cos_phi, phi_dot * w_inner_frame_in_rotor_frame_1);
    // H_inner_2_2 = Ay*w_outer_frame_in_inner_frame_2_2
    let H_inner_2_2 = Ay * w_outer_frame_in_inner_frame_2_2;
    // H_inner_3_2 = Az*w_outer_frame_in_inner_frame_3_2
    let H_inner_3_2 = Az * w_outer_frame_in_inner_frame_3_2;
    // H_rotor_1_2 = B*w_inner_frame_in_rotor_frame_1_2
    let H_rotor_1_2 = B * w_inner_frame_in_rotor_frame_1_2;
    // H_rotor_2_2 = B*w_inner_frame_in_rotor_frame_2_2
    let H_rotor_2_2 = B * w_inner_frame_in_rotor_frame_2_2;
    // H_rotor_3_2 = C*w_outer_frame_in_inner_frame_3_2
    let H_rotor_3_2 = C * w_outer_frame_in_inner_frame_3_2;
    // p_w_outer_frame_in_inner_frame_3_2 = H_inner_3_2 + H_rotor_3_2
    let p_w_outer_frame_in_inner_frame_3_2 = H_inner_3_2 + H_rotor_3_2;
    // p_w_outer_frame_in_inner_frame_2_2 = phi'*H_rotor_1*cos(phi) + phi'*H_rotor_2*sin(phi) + H_inner_2_2
    //   - H_rotor_1_2*sin(phi) - H_rotor_2_2*cos(phi)
    let p_w_outer_frame_in_inner_frame_2_2 = phi_dot
        * H_rotor_2.mul_add(sin_phi, H_rotor_1 * cos_phi) + H_inner_2_2
        - H_rotor_1_2 * sin_phi - H_rotor_2_2 * cos_phi;
    // w_inner_frame_in_rotor_frame_1_4 = sin(theta)*sin(phi)
    let w_inner_frame_in_rotor_frame_1_4 = sin_theta * sin_phi;
    // w_inner_frame_in_rotor_frame_2_4 = sin(theta)*cos(phi)
    let w_inner_frame_in_rotor_frame_2_4 = sin_theta * cos_phi;
    // H_inner_2_4 = Ay*sin(theta)
    let H_inner_2_4 = Ay * sin_theta;
    // H_inner_3_4 = Az*cos(theta)
    let H_inner_3_4 = Az * cos_theta;
    // H_rotor_1_4 = B*w_inner_frame_in_rotor_frame_1_4
    let H_rotor_1_4 = B * w_inner_frame_in_rotor_frame_1_4;
    // H_rotor_2_4 = B*w_inner_frame_in_rotor_frame_2_4
    let H_rotor_2_4 = B * w_inner_frame_in_rotor_frame_2_4;
    // H_rotor_3_4 = C*cos(theta)
    let H_rotor_3_4 = C * cos_theta;
    // p_w_outer_frame_in_inner_frame_3_4 = H_inner_3_4 + H_rotor_3_4
    let p_w_outer_frame_in_inner_frame_3_4 = H_inner_3_4 + H_rotor_3_4;
    // p_w_outer_frame_in_inner_frame_2_4 = H_inner_2_4 + H_rotor_1_4*sin(phi) + H_rotor_2_4*cos(phi)
    let p_w_outer_frame_in_inner_frame_2_4 = H_rotor_1_4.mul_add(sin_phi, H_inner_2_4)
        + H_rotor_2_4 * cos_phi;
    // H_rotor_1_5 = B*cos(phi)
    let H_rotor_1_5 = B * cos_phi;
    // H_rotor_2_5 = B*sin(phi)
    let H_rotor_2_5 = B * sin_phi;
    // p_w_outer_frame_in_inner_frame_2_5 = H_rotor_2_5*cos(phi) - H_rotor_1_5*sin(phi)
    let p_w_outer_frame_in_inner_frame_2_5 = (-H_rotor_1_5)
        .mul_add(sin_phi, H_rotor_2_5 * cos_phi);
    // l1 = cos(theta)
    let l1 = cos_theta;
    // s2 = Iz + p_w_outer_frame_in_inner_frame_2_4*sin(theta) +
    //   cos(theta)*(p_w_outer_frame_in_inner_frame_3_4 - C*l1)
    let s2 = p_w_outer_frame_in_inner_frame_3_4.mul_add(cos_theta, Iz)
        + p_w_outer_frame_in_inner_frame_2_4 * sin_theta - H_rotor_3_4 * l1;
    // p_w_outer_frame_in_inner_frame_3*sin(theta) - p_w_outer_frame_in_inner_frame_2*cos(theta)
    let r3_of_place = (-p_w_outer_frame_in_inner_frame_2)
        .mul_add(cos_theta, p_w_outer_frame_in_inner_frame_3 * sin_theta);
    // w_inner_frame_in_rotor_frame_1*H_rotor_2 + H_rotor_1*w_inner_frame_in_rotor_frame_2_of_theta_dot
    let r3_of_theta_dot = H_rotor_1
        .mul_add(
            w_inner_frame_in_rotor_frame_2_of_theta_dot,
            w_inner_frame_in_rotor_frame_1 * H_rotor_2,
        );
    // H_rotor_3_2 + r3_of_theta_dot
    let r3_of_theta_dot_2 = H_rotor_3_2 + r3_of_theta_dot;
    // r3 = theta'*(p_w_outer_frame_in_inner_frame_3*sin(theta) -
    //   p_w_outer_frame_in_inner_frame_2*cos(theta)) + p_w_outer_frame_in_inner_frame_3_2*cos(theta) -
    //   p_w_outer_frame_in_inner_frame_2_2*sin(theta) -
    //   l1*(H_rotor_1*(w_outer_frame_in_inner_frame_2*cos(phi) - theta'*sin(phi)) +
    //   H_rotor_2*(theta'*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)) + H_rotor_3_2)
    let r3 = (-p_w_outer_frame_in_inner_frame_2_2)
        .mul_add(sin_theta, p_w_outer_frame_in_inner_frame_3_2 * cos_theta)
        + theta_dot * r3_of_place - l1 * r3_of_theta_dot_2;
    let s2_inv = S::int(1) / s2;
    let l4_of_place = p_w_outer_frame_in_inner_frame_2_5 * sin_theta;
    let s2_inv_l4_of_place = s2_inv * l4_of_place;
    // l4 = -p_w_outer_frame_in_inner_frame_2_5*sin(theta)/s2
    let l4 = -s2_inv_l4_of_place;
    // s5 = Ax + H_rotor_1_5*cos(phi) + H_rotor_2_5*sin(phi) +
    //   p_w_outer_frame_in_inner_frame_2_5*l4*sin(theta)
    let s5 = H_rotor_1_5.mul_add(cos_phi, Ax) + H_rotor_2_5 * sin_phi + l4 * l4_of_place;
    // r6 = phi'*(H_rotor_1*sin(phi) - H_rotor_2*cos(phi)) +
    //   psi'*(p_w_outer_frame_in_inner_frame_2*cos(theta) - p_w_outer_frame_in_inner_frame_3*sin(theta)) +
    //   H_rotor_1_2*cos(phi) - H_rotor_2_2*sin(phi) - r3*l4
    let r6 = (-H_rotor_2_2).mul_add(sin_phi, H_rotor_1_2 * cos_phi) - r3 * l4
        - phi_dot * p_w_outer_frame_in_inner_frame_2_of_place - psi_dot * r3_of_place;
    // theta'' = r6/s5
    let theta_ddot = r6 / s5;
    // psi'' = (theta''*p_w_outer_frame_in_inner_frame_2_5*sin(theta) + r3)/s2
    let psi_ddot = theta_ddot.mul_add(s2_inv_l4_of_place, r3 * s2_inv);
    // phi'' = (theta'*(H_rotor_2*cos(phi) - H_rotor_1*sin(phi)) +
    //   w_outer_frame_in_inner_frame_2*(H_rotor_1*cos(phi) + H_rotor_2*sin(phi)) + H_rotor_3_2)/C -
    //   psi''*cos(theta)
    let phi_ddot = (-psi_ddot).mul_add(cos_theta, r3_of_theta_dot_2 / C);
    [psi_ddot, theta_ddot, phi_ddot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 3] {
    let [psi_dot, theta_dot, phi_dot] = *q_dot;
    // Values.
    // psi'
    let psi_dot_value = psi_dot;
    // theta'
    let theta_dot_value = theta_dot;
    // phi'
    let phi_dot_value = phi_dot;
    [psi_dot_value, theta_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 30 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3], q_dot: &[S; 3]) -> S {
    let Parameters { Iz, Ax, Ay, Az, B, C, .. } = *p;
    let [_, theta, phi] = *q;
    let [psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w_outer_frame_in_inner_frame_2 = psi'*sin(theta)
    let w_outer_frame_in_inner_frame_2 = psi_dot * sin_theta;
    // w_outer_frame_in_inner_frame_3 = psi'*cos(theta)
    let w_outer_frame_in_inner_frame_3 = psi_dot * cos_theta;
    // w_inner_frame_in_rotor_frame_1 = theta'*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1 = w_outer_frame_in_inner_frame_2
        .mul_add(sin_phi, theta_dot * cos_phi);
    // w_inner_frame_in_rotor_frame_2 = theta'*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(cos_phi, theta_dot * sin_phi);
    // w_rotor_frame_3 = phi' + w_outer_frame_in_inner_frame_3
    let w_rotor_frame_3 = phi_dot + w_outer_frame_in_inner_frame_3;
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
    // H_outer_3_2 = Iz*psi'
    let H_outer_3_2 = Iz * psi_dot;
    // H_inner_1_2 = Ax*theta'
    let H_inner_1_2 = Ax * theta_dot;
    // psi'*H_outer_3_2 + theta'*H_inner_1_2
    let energy_of_motion = theta_dot.mul_add(H_inner_1_2, psi_dot * H_outer_3_2);
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
    // T = w_outer_frame_in_inner_frame_2*H_inner_2/2 + w_outer_frame_in_inner_frame_3*H_inner_3/2 +
    //   w_inner_frame_in_rotor_frame_1*H_rotor_1/2 + w_inner_frame_in_rotor_frame_2*H_rotor_2/2 +
    //   w_rotor_frame_3*H_rotor_3/2 + psi'*H_outer_3_2/2 + theta'*H_inner_1_2/2
    let energy = S::ratio(1, 2) * energy_of_motion_3;
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 0 operations.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 3] {
    let [psi_dot, theta_dot, phi_dot] = *q_dot;
    // Values.
    // u_psi = psi'
    let u_psi_value = psi_dot;
    // u_theta = theta'
    let u_theta_value = theta_dot;
    // u_phi = phi'
    let u_phi_value = phi_dot;
    [u_psi_value, u_theta_value, u_phi_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 0 operations.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 3],
    _q_dot: &[S; 3],
    v_dot: &[S; 3],
) -> [S; 3] {
    let [psi_ddot, theta_ddot, phi_ddot] = *v_dot;
    // Values.
    // u_psi' = psi''
    let u_psi_dot_value = psi_ddot;
    // u_theta' = theta''
    let u_theta_dot_value = theta_ddot;
    // u_phi' = phi''
    let u_phi_dot_value = phi_ddot;
    [u_psi_dot_value, u_theta_dot_value, u_phi_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 0 operations.
#[must_use]
pub fn motion_variables<S: Scalar>(
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

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 107 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> ([S; 3], [S; 3]) {
    let Parameters { Iz, Ax, Ay, Az, B, C, .. } = *p;
    let [_, theta, phi] = *q;
    let [psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w_outer_frame_in_inner_frame_2 = psi'*sin(theta)
    let w_outer_frame_in_inner_frame_2 = psi_dot * sin_theta;
    // w_outer_frame_in_inner_frame_3 = psi'*cos(theta)
    let w_outer_frame_in_inner_frame_3 = psi_dot * cos_theta;
    // w_inner_frame_in_rotor_frame_1 = theta'*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1 = w_outer_frame_in_inner_frame_2
        .mul_add(sin_phi, theta_dot * cos_phi);
    // w_outer_frame_in_inner_frame_2*cos(phi) - theta'*sin(phi)
    let w_inner_frame_in_rotor_frame_2_of_theta_dot = (-theta_dot)
        .mul_add(sin_phi, w_outer_frame_in_inner_frame_2 * cos_phi);
    // w_inner_frame_in_rotor_frame_2 = theta'*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2 = -w_inner_frame_in_rotor_frame_2_of_theta_dot;
    // w_rotor_frame_3 = phi' + w_outer_frame_in_inner_frame_3
    let w_rotor_frame_3 = phi_dot + w_outer_frame_in_inner_frame_3;
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
    // p_w_outer_frame_in_inner_frame_3 = H_inner_3 + H_rotor_3
    let p_w_outer_frame_in_inner_frame_3 = H_inner_3 + H_rotor_3;
    // H_rotor_2*cos(phi) - H_rotor_1*sin(phi)
    let p_w_outer_frame_in_inner_frame_2_of_place = (-H_rotor_1)
        .mul_add(sin_phi, H_rotor_2 * cos_phi);
    // p_w_outer_frame_in_inner_frame_2 = H_inner_2 + H_rotor_1*sin(phi) - H_rotor_2*cos(phi)
    let p_w_outer_frame_in_inner_frame_2 = H_inner_2 - p_w_outer_frame_in_inner_frame_2_of_place;
    // w_outer_frame_in_inner_frame_2_2 = psi'*theta'*cos(theta)
    let w_outer_frame_in_inner_frame_2_2 = theta_dot * w_outer_frame_in_inner_frame_3;
    // w_outer_frame_in_inner_frame_3_2 = psi'*theta'*sin(theta)
    let w_outer_frame_in_inner_frame_3_2 = theta_dot * w_outer_frame_in_inner_frame_2;
    // w_inner_frame_in_rotor_frame_1_2 = theta'*phi'*sin(phi) -
    //   phi'*w_outer_frame_in_inner_frame_2*cos(phi) - w_outer_frame_in_inner_frame_2_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1_2 = (-phi_dot)
        .mul_add(
            w_inner_frame_in_rotor_frame_2_of_theta_dot,
            -w_outer_frame_in_inner_frame_2_2 * sin_phi,
        );
    // w_inner_frame_in_rotor_frame_2_2 = theta'*phi'*cos(phi) +
    //   phi'*w_outer_frame_in_inner_frame_2*sin(phi) - w_outer_frame_in_inner_frame_2_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2_2 = (-w_outer_frame_in_inner_frame_2_2)
        .mul_add(cos_phi, phi_dot * w_inner_frame_in_rotor_frame_1);
    // H_inner_2_2 = Ay*w_outer_frame_in_inner_frame_2_2
    let H_inner_2_2 = Ay * w_outer_frame_in_inner_frame_2_2;
    // H_inner_3_2 = Az*w_outer_frame_in_inner_frame_3_2
    let H_inner_3_2 = Az * w_outer_frame_in_inner_frame_3_2;
    // H_rotor_1_2 = B*w_inner_frame_in_rotor_frame_1_2
    let H_rotor_1_2 = B * w_inner_frame_in_rotor_frame_1_2;
    // H_rotor_2_2 = B*w_inner_frame_in_rotor_frame_2_2
    let H_rotor_2_2 = B * w_inner_frame_in_rotor_frame_2_2;
    // H_rotor_3_2 = C*w_outer_frame_in_inner_frame_3_2
    let H_rotor_3_2 = C * w_outer_frame_in_inner_frame_3_2;
    // p_w_outer_frame_in_inner_frame_3_2 = H_inner_3_2 + H_rotor_3_2
    let p_w_outer_frame_in_inner_frame_3_2 = H_inner_3_2 + H_rotor_3_2;
    // p_w_outer_frame_in_inner_frame_2_2 = phi'*H_rotor_1*cos(phi) + phi'*H_rotor_2*sin(phi) + H_inner_2_2
    //   - H_rotor_1_2*sin(phi) - H_rotor_2_2*cos(phi)
    let p_w_outer_frame_in_inner_frame_2_2 = phi_dot
        * H_rotor_2.mul_add(sin_phi, H_rotor_1 * cos_phi) + H_inner_2_2
        - H_rotor_1_2 * sin_phi - H_rotor_2_2 * cos_phi;
    // w_inner_frame_in_rotor_frame_1_4 = sin(theta)*sin(phi)
    let w_inner_frame_in_rotor_frame_1_4 = sin_theta * sin_phi;
    // w_inner_frame_in_rotor_frame_2_4 = sin(theta)*cos(phi)
    let w_inner_frame_in_rotor_frame_2_4 = sin_theta * cos_phi;
    // H_inner_2_4 = Ay*sin(theta)
    let H_inner_2_4 = Ay * sin_theta;
    // H_inner_3_4 = Az*cos(theta)
    let H_inner_3_4 = Az * cos_theta;
    // H_rotor_1_4 = B*w_inner_frame_in_rotor_frame_1_4
    let H_rotor_1_4 = B * w_inner_frame_in_rotor_frame_1_4;
    // H_rotor_2_4 = B*w_inner_frame_in_rotor_frame_2_4
    let H_rotor_2_4 = B * w_inner_frame_in_rotor_frame_2_4;
    // H_rotor_3_4 = C*cos(theta)
    let H_rotor_3_4 = C * cos_theta;
    // p_w_outer_frame_in_inner_frame_3_4 = H_inner_3_4 + H_rotor_3_4
    let p_w_outer_frame_in_inner_frame_3_4 = H_inner_3_4 + H_rotor_3_4;
    // p_w_outer_frame_in_inner_frame_2_4 = H_inner_2_4 + H_rotor_1_4*sin(phi) + H_rotor_2_4*cos(phi)
    let p_w_outer_frame_in_inner_frame_2_4 = H_rotor_1_4.mul_add(sin_phi, H_inner_2_4)
        + H_rotor_2_4 * cos_phi;
    // H_rotor_1_5 = B*cos(phi)
    let H_rotor_1_5 = B * cos_phi;
    // H_rotor_2_5 = B*sin(phi)
    let H_rotor_2_5 = B * sin_phi;
    // p_w_outer_frame_in_inner_frame_2_5 = H_rotor_2_5*cos(phi) - H_rotor_1_5*sin(phi)
    let p_w_outer_frame_in_inner_frame_2_5 = (-H_rotor_1_5)
        .mul_add(sin_phi, H_rotor_2_5 * cos_phi);
    // l1 = cos(theta)
    let l1 = cos_theta;
    // s2 = Iz + p_w_outer_frame_in_inner_frame_2_4*sin(theta) +
    //   cos(theta)*(p_w_outer_frame_in_inner_frame_3_4 - C*l1)
    let s2 = p_w_outer_frame_in_inner_frame_3_4.mul_add(cos_theta, Iz)
        + p_w_outer_frame_in_inner_frame_2_4 * sin_theta - H_rotor_3_4 * l1;
    // p_w_outer_frame_in_inner_frame_3*sin(theta) - p_w_outer_frame_in_inner_frame_2*cos(theta)
    let r3_of_place = (-p_w_outer_frame_in_inner_frame_2)
        .mul_add(cos_theta, p_w_outer_frame_in_inner_frame_3 * sin_theta);
    // w_inner_frame_in_rotor_frame_1*H_rotor_2 + H_rotor_1*w_inner_frame_in_rotor_frame_2_of_theta_dot
    let r3_of_theta_dot = H_rotor_1
        .mul_add(
            w_inner_frame_in_rotor_frame_2_of_theta_dot,
            w_inner_frame_in_rotor_frame_1 * H_rotor_2,
        );
    // H_rotor_3_2 + r3_of_theta_dot
    let r3_of_theta_dot_2 = H_rotor_3_2 + r3_of_theta_dot;
    // r3 = theta'*(p_w_outer_frame_in_inner_frame_3*sin(theta) -
    //   p_w_outer_frame_in_inner_frame_2*cos(theta)) + p_w_outer_frame_in_inner_frame_3_2*cos(theta) -
    //   p_w_outer_frame_in_inner_frame_2_2*sin(theta) -
    //   l1*(H_rotor_1*(w_outer_frame_in_inner_frame_2*cos(phi) - theta'*sin(phi)) +
    //   H_rotor_2*(theta'*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)) + H_rotor_3_2)
    let r3 = (-p_w_outer_frame_in_inner_frame_2_2)
        .mul_add(sin_theta, p_w_outer_frame_in_inner_frame_3_2 * cos_theta)
        + theta_dot * r3_of_place - l1 * r3_of_theta_dot_2;
    let s2_inv = S::int(1) / s2;
    let l4_of_place = p_w_outer_frame_in_inner_frame_2_5 * sin_theta;
    let s2_inv_l4_of_place = s2_inv * l4_of_place;
    // l4 = -p_w_outer_frame_in_inner_frame_2_5*sin(theta)/s2
    let l4 = -s2_inv_l4_of_place;
    // s5 = Ax + H_rotor_1_5*cos(phi) + H_rotor_2_5*sin(phi) +
    //   p_w_outer_frame_in_inner_frame_2_5*l4*sin(theta)
    let s5 = H_rotor_1_5.mul_add(cos_phi, Ax) + H_rotor_2_5 * sin_phi + l4 * l4_of_place;
    // r6 = phi'*(H_rotor_1*sin(phi) - H_rotor_2*cos(phi)) +
    //   psi'*(p_w_outer_frame_in_inner_frame_2*cos(theta) - p_w_outer_frame_in_inner_frame_3*sin(theta)) +
    //   H_rotor_1_2*cos(phi) - H_rotor_2_2*sin(phi) - r3*l4
    let r6 = (-H_rotor_2_2).mul_add(sin_phi, H_rotor_1_2 * cos_phi) - r3 * l4
        - phi_dot * p_w_outer_frame_in_inner_frame_2_of_place - psi_dot * r3_of_place;
    // theta'' = r6/s5
    let theta_ddot = r6 / s5;
    // psi'' = (theta''*p_w_outer_frame_in_inner_frame_2_5*sin(theta) + r3)/s2
    let psi_ddot = theta_ddot.mul_add(s2_inv_l4_of_place, r3 * s2_inv);
    // phi'' = (theta'*(H_rotor_2*cos(phi) - H_rotor_1*sin(phi)) +
    //   w_outer_frame_in_inner_frame_2*(H_rotor_1*cos(phi) + H_rotor_2*sin(phi)) + H_rotor_3_2)/C -
    //   psi''*cos(theta)
    let phi_ddot = (-psi_ddot).mul_add(cos_theta, r3_of_theta_dot_2 / C);
    // Values.
    // psi'
    let psi_dot_value = psi_dot;
    // theta'
    let theta_dot_value = theta_dot;
    // phi'
    let phi_dot_value = phi_dot;
    ([psi_dot_value, theta_dot_value, phi_dot_value], [psi_ddot, theta_ddot, phi_ddot])
}

/// Inverse dynamics: the generalized forces along (psi', theta', phi') that must act beside the loads of the model for the accelerations to be (psi'', theta'', phi'').
///
/// 76 operations, 2 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
    v_dot: &[S; 3],
) -> [S; 3] {
    let Parameters { Iz, Ax, Ay, Az, B, C, .. } = *p;
    let [_, theta, phi] = *q;
    let [psi_dot, theta_dot, phi_dot] = *q_dot;
    let [psi_ddot, theta_ddot, phi_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w_outer_frame_in_inner_frame_2 = psi'*sin(theta)
    let w_outer_frame_in_inner_frame_2 = psi_dot * sin_theta;
    // w_outer_frame_in_inner_frame_3 = psi'*cos(theta)
    let w_outer_frame_in_inner_frame_3 = psi_dot * cos_theta;
    // w_inner_frame_in_rotor_frame_1 = theta'*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1 = w_outer_frame_in_inner_frame_2
        .mul_add(sin_phi, theta_dot * cos_phi);
    // w_outer_frame_in_inner_frame_2*cos(phi) - theta'*sin(phi)
    let w_inner_frame_in_rotor_frame_2_of_theta_dot = (-theta_dot)
        .mul_add(sin_phi, w_outer_frame_in_inner_frame_2 * cos_phi);
    // w_inner_frame_in_rotor_frame_2 = theta'*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2 = -w_inner_frame_in_rotor_frame_2_of_theta_dot;
    // w_rotor_frame_3 = phi' + w_outer_frame_in_inner_frame_3
    let w_rotor_frame_3 = phi_dot + w_outer_frame_in_inner_frame_3;
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
    // p_w_outer_frame_in_inner_frame_3 = H_inner_3 + H_rotor_3
    let p_w_outer_frame_in_inner_frame_3 = H_inner_3 + H_rotor_3;
    // H_rotor_2*cos(phi) - H_rotor_1*sin(phi)
    let p_w_outer_frame_in_inner_frame_2_of_place = (-H_rotor_1)
        .mul_add(sin_phi, H_rotor_2 * cos_phi);
    // p_w_outer_frame_in_inner_frame_2 = H_inner_2 + H_rotor_1*sin(phi) - H_rotor_2*cos(phi)
    let p_w_outer_frame_in_inner_frame_2 = H_inner_2 - p_w_outer_frame_in_inner_frame_2_of_place;
    // w_outer_frame_in_inner_frame_2_3 = psi'*theta'*cos(theta) + psi''*sin(theta)
    let w_outer_frame_in_inner_frame_2_3 = theta_dot
        .mul_add(w_outer_frame_in_inner_frame_3, psi_ddot * sin_theta);
    // w_outer_frame_in_inner_frame_3_3 = psi'*theta'*sin(theta) - psi''*cos(theta)
    let w_outer_frame_in_inner_frame_3_3 = (-psi_ddot)
        .mul_add(cos_theta, theta_dot * w_outer_frame_in_inner_frame_2);
    // w_inner_frame_in_rotor_frame_1_3 = theta'*phi'*sin(phi) - theta''*cos(phi) -
    //   phi'*w_outer_frame_in_inner_frame_2*cos(phi) - w_outer_frame_in_inner_frame_2_3*sin(phi)
    let w_inner_frame_in_rotor_frame_1_3 = (-w_outer_frame_in_inner_frame_2_3)
        .mul_add(sin_phi, -theta_ddot * cos_phi)
        - phi_dot * w_inner_frame_in_rotor_frame_2_of_theta_dot;
    // w_inner_frame_in_rotor_frame_2_3 = theta'*phi'*cos(phi) + theta''*sin(phi) +
    //   phi'*w_outer_frame_in_inner_frame_2*sin(phi) - w_outer_frame_in_inner_frame_2_3*cos(phi)
    let w_inner_frame_in_rotor_frame_2_3 = phi_dot
        .mul_add(w_inner_frame_in_rotor_frame_1, theta_ddot * sin_phi)
        - w_outer_frame_in_inner_frame_2_3 * cos_phi;
    // w_rotor_frame_3_2 = phi'' - w_outer_frame_in_inner_frame_3_3
    let w_rotor_frame_3_2 = phi_ddot - w_outer_frame_in_inner_frame_3_3;
    // H_outer_3 = Iz*psi''
    let H_outer_3 = Iz * psi_ddot;
    // H_inner_2_3 = Ay*w_outer_frame_in_inner_frame_2_3
    let H_inner_2_3 = Ay * w_outer_frame_in_inner_frame_2_3;
    // H_inner_3_3 = Az*w_outer_frame_in_inner_frame_3_3
    let H_inner_3_3 = Az * w_outer_frame_in_inner_frame_3_3;
    // H_rotor_1_3 = B*w_inner_frame_in_rotor_frame_1_3
    let H_rotor_1_3 = B * w_inner_frame_in_rotor_frame_1_3;
    // H_rotor_2_3 = B*w_inner_frame_in_rotor_frame_2_3
    let H_rotor_2_3 = B * w_inner_frame_in_rotor_frame_2_3;
    // H_rotor_3_3 = C*w_rotor_frame_3_2
    let H_rotor_3_3 = C * w_rotor_frame_3_2;
    // p_w_outer_frame_in_inner_frame_3_3 = H_inner_3_3 - H_rotor_3_3
    let p_w_outer_frame_in_inner_frame_3_3 = H_inner_3_3 - H_rotor_3_3;
    // p_w_outer_frame_in_inner_frame_2_3 = phi'*H_rotor_1*cos(phi) + phi'*H_rotor_2*sin(phi) + H_inner_2_3
    //   - H_rotor_1_3*sin(phi) - H_rotor_2_3*cos(phi)
    let p_w_outer_frame_in_inner_frame_2_3 = phi_dot
        * H_rotor_2.mul_add(sin_phi, H_rotor_1 * cos_phi) + H_inner_2_3
        - H_rotor_1_3 * sin_phi - H_rotor_2_3 * cos_phi;
    // H_inner_1 = Ax*theta''
    let H_inner_1 = Ax * theta_ddot;
    // p_w_outer_frame_in_inner_frame_3*sin(theta) - p_w_outer_frame_in_inner_frame_2*cos(theta)
    let tau1_of_place = (-p_w_outer_frame_in_inner_frame_2)
        .mul_add(cos_theta, p_w_outer_frame_in_inner_frame_3 * sin_theta);
    // Values.
    // tau1 = theta'*p_w_outer_frame_in_inner_frame_2*cos(theta) -
    //   theta'*p_w_outer_frame_in_inner_frame_3*sin(theta) + H_outer_3 -
    //   p_w_outer_frame_in_inner_frame_3_3*cos(theta) + p_w_outer_frame_in_inner_frame_2_3*sin(theta)
    let tau1 = (-p_w_outer_frame_in_inner_frame_3_3).mul_add(cos_theta, H_outer_3)
        + p_w_outer_frame_in_inner_frame_2_3 * sin_theta - theta_dot * tau1_of_place;
    // tau2 = phi'*H_rotor_2*cos(phi) - phi'*H_rotor_1*sin(phi) +
    //   psi'*p_w_outer_frame_in_inner_frame_3*sin(theta) - psi'*p_w_outer_frame_in_inner_frame_2*cos(theta)
    //   - H_rotor_1_3*cos(phi) + H_rotor_2_3*sin(phi) + H_inner_1
    let tau2 = (-H_rotor_1_3).mul_add(cos_phi, H_rotor_2_3 * sin_phi) + H_inner_1
        + phi_dot * p_w_outer_frame_in_inner_frame_2_of_place + psi_dot * tau1_of_place;
    // tau3 = H_rotor_1*(theta'*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)) -
    //   H_rotor_2*(theta'*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)) + H_rotor_3_3
    let tau3 = (-w_inner_frame_in_rotor_frame_1).mul_add(H_rotor_2, H_rotor_3_3)
        - H_rotor_1 * w_inner_frame_in_rotor_frame_2_of_theta_dot;
    [tau1, tau2, tau3]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
    direction: &[S; 6],
) -> [S; 6] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: q_dot[i],
        slope: direction[3 + i],
    });
    let (of_q, of_v) = derivative(&p, &q, &v);
    let mut slopes = of_q.into_iter().chain(of_v).map(|rate| rate.slope);
    core::array::from_fn(|_| {
        slopes.next().expect("a slope for each component of the state")
    })
}

/// Lagrange's equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Lagrange;

impl<S: Scalar> System<S> for Lagrange {
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
    fn generalized_speeds(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &generalized_speeds(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn generalized_speed_rates(
        &self,
        p: &[S],
        q: &[S],
        v: &[S],
        v_dot: &[S],
        out: &mut [S],
    ) {
        out.copy_from_slice(
            &generalized_speed_rates(
                &Parameters::from_slice(p),
                array(q),
                array(v),
                array(v_dot),
            ),
        );
    }
    fn motion_variables(&self, p: &[S], q: &[S], u: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &motion_variables(&Parameters::from_slice(p), array(q), array(u)),
        );
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
