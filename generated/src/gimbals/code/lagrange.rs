//! Gyroscope in gimbals: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/gimbals/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

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

/// Jacobian of the derivative by the state; columns psi, theta, phi, psi', theta', phi'.
///
/// 405 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> [[S; 6]; 6] {
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
    // w_inner_frame_in_rotor_frame_1_by_phi = w_outer_frame_in_inner_frame_2*cos(phi) - theta'*sin(phi)
    let w_inner_frame_in_rotor_frame_1_by_phi = (-theta_dot)
        .mul_add(sin_phi, w_outer_frame_in_inner_frame_2 * cos_phi);
    // -w_inner_frame_in_rotor_frame_1_by_phi
    let w_inner_frame_in_rotor_frame_2_of_place = -w_inner_frame_in_rotor_frame_1_by_phi;
    // w_inner_frame_in_rotor_frame_2 = theta'*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2 = w_inner_frame_in_rotor_frame_2_of_place;
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
    // w_inner_frame_in_rotor_frame_2_2_by_phi = phi'*(w_outer_frame_in_inner_frame_2*cos(phi) -
    //   theta'*sin(phi)) + w_outer_frame_in_inner_frame_2_2*sin(phi)
    let w_inner_frame_in_rotor_frame_2_2_by_phi = phi_dot
        .mul_add(
            w_inner_frame_in_rotor_frame_1_by_phi,
            w_outer_frame_in_inner_frame_2_2 * sin_phi,
        );
    // w_inner_frame_in_rotor_frame_1_2 = theta'*phi'*sin(phi) -
    //   phi'*w_outer_frame_in_inner_frame_2*cos(phi) - w_outer_frame_in_inner_frame_2_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1_2 = -w_inner_frame_in_rotor_frame_2_2_by_phi;
    // w_outer_frame_in_inner_frame_2_2*cos(phi) - phi'*w_inner_frame_in_rotor_frame_1
    let w_inner_frame_in_rotor_frame_2_2_of_phi_dot = (-phi_dot)
        .mul_add(
            w_inner_frame_in_rotor_frame_1,
            w_outer_frame_in_inner_frame_2_2 * cos_phi,
        );
    // -w_inner_frame_in_rotor_frame_2_2_of_phi_dot
    let w_inner_frame_in_rotor_frame_2_2_of_phi_dot_2 = -w_inner_frame_in_rotor_frame_2_2_of_phi_dot;
    // w_inner_frame_in_rotor_frame_2_2 = theta'*phi'*cos(phi) +
    //   phi'*w_outer_frame_in_inner_frame_2*sin(phi) - w_outer_frame_in_inner_frame_2_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2_2 = w_inner_frame_in_rotor_frame_2_2_of_phi_dot_2;
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
    // H_rotor_1*cos(phi) + H_rotor_2*sin(phi)
    let p_w_outer_frame_in_inner_frame_2_2_of_place = H_rotor_2
        .mul_add(sin_phi, H_rotor_1 * cos_phi);
    // H_rotor_1_2*sin(phi) + H_rotor_2_2*cos(phi)
    let p_w_outer_frame_in_inner_frame_2_2_of_place_2 = H_rotor_2_2
        .mul_add(cos_phi, H_rotor_1_2 * sin_phi);
    // phi'*p_w_outer_frame_in_inner_frame_2_2_of_place - p_w_outer_frame_in_inner_frame_2_2_of_place_2
    let p_w_outer_frame_in_inner_frame_2_2_of_phi_dot = phi_dot
        .mul_add(
            p_w_outer_frame_in_inner_frame_2_2_of_place,
            -p_w_outer_frame_in_inner_frame_2_2_of_place_2,
        );
    // p_w_outer_frame_in_inner_frame_2_2 = phi'*H_rotor_1*cos(phi) + phi'*H_rotor_2*sin(phi) + H_inner_2_2
    //   - H_rotor_1_2*sin(phi) - H_rotor_2_2*cos(phi)
    let p_w_outer_frame_in_inner_frame_2_2 = H_inner_2_2
        + p_w_outer_frame_in_inner_frame_2_2_of_phi_dot;
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
    let c_l1 = C * l1;
    // c_l1 - p_w_outer_frame_in_inner_frame_3_4
    let s2_of_place = c_l1 - p_w_outer_frame_in_inner_frame_3_4;
    // s2 = Iz + p_w_outer_frame_in_inner_frame_2_4*sin(theta) +
    //   cos(theta)*(p_w_outer_frame_in_inner_frame_3_4 - C*l1)
    let s2 = p_w_outer_frame_in_inner_frame_2_4.mul_add(sin_theta, Iz) - s2_of_place * cos_theta;
    let theta_dot_cos_theta = theta_dot * cos_theta;
    let theta_dot_sin_theta = theta_dot * sin_theta;
    // w_inner_frame_in_rotor_frame_1*H_rotor_2 + H_rotor_1*w_inner_frame_in_rotor_frame_1_by_phi
    let r3_of_place = H_rotor_1
        .mul_add(
            w_inner_frame_in_rotor_frame_1_by_phi,
            w_inner_frame_in_rotor_frame_1 * H_rotor_2,
        );
    // H_rotor_3_2 + r3_of_place
    let r3_of_place_2 = H_rotor_3_2 + r3_of_place;
    // r3 = theta'*(p_w_outer_frame_in_inner_frame_3*sin(theta) -
    //   p_w_outer_frame_in_inner_frame_2*cos(theta)) + p_w_outer_frame_in_inner_frame_3_2*cos(theta) -
    //   p_w_outer_frame_in_inner_frame_2_2*sin(theta) -
    //   l1*(H_rotor_1*(w_outer_frame_in_inner_frame_2*cos(phi) - theta'*sin(phi)) +
    //   H_rotor_2*(theta'*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)) + H_rotor_3_2)
    let r3 = (-p_w_outer_frame_in_inner_frame_2_2)
        .mul_add(sin_theta, p_w_outer_frame_in_inner_frame_3_2 * cos_theta)
        - p_w_outer_frame_in_inner_frame_2 * theta_dot_cos_theta
        + p_w_outer_frame_in_inner_frame_3 * theta_dot_sin_theta - l1 * r3_of_place_2;
    let s2_inv = S::int(1) / s2;
    let sin_theta_s2_inv = s2_inv * sin_theta;
    let l4_of_place = p_w_outer_frame_in_inner_frame_2_5 * sin_theta_s2_inv;
    // l4 = -p_w_outer_frame_in_inner_frame_2_5*sin(theta)/s2
    let l4 = -l4_of_place;
    // H_rotor_1_5*cos(phi) + H_rotor_2_5*sin(phi)
    let s5_of_place = H_rotor_2_5.mul_add(sin_phi, H_rotor_1_5 * cos_phi);
    let s5_of_place_2 = p_w_outer_frame_in_inner_frame_2_5 * sin_theta;
    // s5 = Ax + H_rotor_1_5*cos(phi) + H_rotor_2_5*sin(phi) +
    //   p_w_outer_frame_in_inner_frame_2_5*l4*sin(theta)
    let s5 = l4.mul_add(s5_of_place_2, Ax + s5_of_place);
    // H_rotor_1_2*cos(phi) - H_rotor_2_2*sin(phi)
    let r6_of_place = (-H_rotor_2_2).mul_add(sin_phi, H_rotor_1_2 * cos_phi);
    // phi'*p_w_outer_frame_in_inner_frame_2_of_place - r6_of_place
    let r6_of_phi_dot = phi_dot
        .mul_add(p_w_outer_frame_in_inner_frame_2_of_place, -r6_of_place);
    // r6 = phi'*(H_rotor_1*sin(phi) - H_rotor_2*cos(phi)) +
    //   psi'*(p_w_outer_frame_in_inner_frame_2*cos(theta) - p_w_outer_frame_in_inner_frame_3*sin(theta)) +
    //   H_rotor_1_2*cos(phi) - H_rotor_2_2*sin(phi) - r3*l4
    let r6 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(
            p_w_outer_frame_in_inner_frame_3,
            w_outer_frame_in_inner_frame_3 * p_w_outer_frame_in_inner_frame_2,
        ) - r3 * l4 - r6_of_phi_dot;
    let s5_inv = S::int(1) / s5;
    // theta'' = r6/s5
    let theta_ddot = r6 * s5_inv;
    // psi'' = (theta''*p_w_outer_frame_in_inner_frame_2_5*sin(theta) + r3)/s2
    let psi_ddot = theta_ddot.mul_add(l4_of_place, r3 * s2_inv);
    // w_inner_frame_in_rotor_frame_1_by_theta = psi'*cos(theta)*sin(phi)
    let w_inner_frame_in_rotor_frame_1_by_theta = w_outer_frame_in_inner_frame_3 * sin_phi;
    let w_inner_frame_in_rotor_frame_2_by_theta_of_place = w_outer_frame_in_inner_frame_3 * cos_phi;
    // w_inner_frame_in_rotor_frame_2_by_theta = -psi'*cos(theta)*cos(phi)
    let w_inner_frame_in_rotor_frame_2_by_theta = -w_inner_frame_in_rotor_frame_2_by_theta_of_place;
    // Az + C
    let az_plus_c = Az + C;
    // p_w_outer_frame_in_inner_frame_3_2_by_theta_dot = psi'*sin(theta)*(Az + C)
    let p_w_outer_frame_in_inner_frame_3_2_by_theta_dot = w_outer_frame_in_inner_frame_2
        * az_plus_c;
    // p_w_outer_frame_in_inner_frame_3_by_theta = -psi'*sin(theta)*(Az + C)
    let p_w_outer_frame_in_inner_frame_3_by_theta = -p_w_outer_frame_in_inner_frame_3_2_by_theta_dot;
    let p_w_outer_frame_in_inner_frame_2_by_theta_of_place = Ay * w_outer_frame_in_inner_frame_3;
    // p_w_outer_frame_in_inner_frame_2_by_theta = Ay*psi'*cos(theta) +
    //   B*(w_inner_frame_in_rotor_frame_1_by_theta*sin(phi) -
    //   w_inner_frame_in_rotor_frame_2_by_theta*cos(phi))
    let p_w_outer_frame_in_inner_frame_2_by_theta = (-H_rotor_1_5)
        .mul_add(
            w_inner_frame_in_rotor_frame_2_by_theta,
            H_rotor_2_5 * w_inner_frame_in_rotor_frame_1_by_theta,
        ) + p_w_outer_frame_in_inner_frame_2_by_theta_of_place;
    // w_inner_frame_in_rotor_frame_1_2_by_theta = psi'*(theta'*sin(theta)*sin(phi) -
    //   phi'*cos(theta)*cos(phi))
    let w_inner_frame_in_rotor_frame_1_2_by_theta = (-phi_dot)
        .mul_add(
            w_inner_frame_in_rotor_frame_2_by_theta_of_place,
            w_outer_frame_in_inner_frame_3_2 * sin_phi,
        );
    // w_inner_frame_in_rotor_frame_2_2_by_theta = psi'*(theta'*sin(theta)*cos(phi) +
    //   phi'*cos(theta)*sin(phi))
    let w_inner_frame_in_rotor_frame_2_2_by_theta = phi_dot
        .mul_add(
            w_inner_frame_in_rotor_frame_1_by_theta,
            w_outer_frame_in_inner_frame_3_2 * cos_phi,
        );
    // H_inner_2_2_by_theta = -Ay*psi'*theta'*sin(theta)
    let H_inner_2_2_by_theta = -Ay * w_outer_frame_in_inner_frame_3_2;
    // H_inner_3_2_by_theta = Az*psi'*theta'*cos(theta)
    let H_inner_3_2_by_theta = Az * w_outer_frame_in_inner_frame_2_2;
    // H_rotor_3_2_by_theta = C*psi'*theta'*cos(theta)
    let H_rotor_3_2_by_theta = C * w_outer_frame_in_inner_frame_2_2;
    let phi_dot_h_rotor_1_5 = phi_dot * H_rotor_1_5;
    let phi_dot_h_rotor_2_5 = phi_dot * H_rotor_2_5;
    // p_w_outer_frame_in_inner_frame_2_2_by_theta =
    //   B*(phi'*(w_inner_frame_in_rotor_frame_1_by_theta*cos(phi) +
    //   w_inner_frame_in_rotor_frame_2_by_theta*sin(phi)) -
    //   w_inner_frame_in_rotor_frame_1_2_by_theta*sin(phi) -
    //   w_inner_frame_in_rotor_frame_2_2_by_theta*cos(phi)) + H_inner_2_2_by_theta
    let p_w_outer_frame_in_inner_frame_2_2_by_theta = (-H_rotor_2_5)
        .mul_add(w_inner_frame_in_rotor_frame_1_2_by_theta, H_inner_2_2_by_theta)
        - H_rotor_1_5 * w_inner_frame_in_rotor_frame_2_2_by_theta
        + w_inner_frame_in_rotor_frame_1_by_theta * phi_dot_h_rotor_1_5
        + w_inner_frame_in_rotor_frame_2_by_theta * phi_dot_h_rotor_2_5;
    // w_inner_frame_in_rotor_frame_1_4_by_theta = cos(theta)*sin(phi)
    let w_inner_frame_in_rotor_frame_1_4_by_theta = cos_theta * sin_phi;
    // w_inner_frame_in_rotor_frame_2_4_by_theta = cos(theta)*cos(phi)
    let w_inner_frame_in_rotor_frame_2_4_by_theta = cos_theta * cos_phi;
    // p_w_outer_frame_in_inner_frame_2_4_by_theta = Ay*cos(theta) +
    //   B*(w_inner_frame_in_rotor_frame_1_4_by_theta*sin(phi) +
    //   w_inner_frame_in_rotor_frame_2_4_by_theta*cos(phi))
    let p_w_outer_frame_in_inner_frame_2_4_by_theta = H_rotor_2_5
        .mul_add(w_inner_frame_in_rotor_frame_1_4_by_theta, Ay * cos_theta)
        + H_rotor_1_5 * w_inner_frame_in_rotor_frame_2_4_by_theta;
    // p_w_outer_frame_in_inner_frame_2_4_by_theta + s2_of_place
    let s2_by_theta_of_place = p_w_outer_frame_in_inner_frame_2_4_by_theta + s2_of_place;
    // s2_by_theta = p_w_outer_frame_in_inner_frame_2_4*cos(theta) + sin(theta)*(C*l1 - Az*cos(theta) -
    //   p_w_outer_frame_in_inner_frame_3_4 + p_w_outer_frame_in_inner_frame_2_4_by_theta)
    let s2_by_theta = sin_theta * (s2_by_theta_of_place - H_inner_3_4)
        + p_w_outer_frame_in_inner_frame_2_4 * cos_theta;
    // p_w_outer_frame_in_inner_frame_2 + p_w_outer_frame_in_inner_frame_3_by_theta
    let r3_by_theta_of_place = p_w_outer_frame_in_inner_frame_2
        + p_w_outer_frame_in_inner_frame_3_by_theta;
    // p_w_outer_frame_in_inner_frame_3 - p_w_outer_frame_in_inner_frame_2_by_theta
    let r3_by_theta_of_place_2 = p_w_outer_frame_in_inner_frame_3
        - p_w_outer_frame_in_inner_frame_2_by_theta;
    // B*(w_inner_frame_in_rotor_frame_1*w_inner_frame_in_rotor_frame_2_by_theta +
    //   w_inner_frame_in_rotor_frame_1_by_theta*w_inner_frame_in_rotor_frame_1_by_phi) +
    //   w_outer_frame_in_inner_frame_3*p_w_outer_frame_in_inner_frame_2_2_of_place
    let r3_by_theta_of_place_3 = B
        * w_inner_frame_in_rotor_frame_1_by_theta
            .mul_add(
                w_inner_frame_in_rotor_frame_1_by_phi,
                w_inner_frame_in_rotor_frame_1 * w_inner_frame_in_rotor_frame_2_by_theta,
            ) + w_outer_frame_in_inner_frame_3 * p_w_outer_frame_in_inner_frame_2_2_of_place;
    // H_rotor_3_2_by_theta + r3_by_theta_of_place_3
    let r3_by_theta_of_place_4 = H_rotor_3_2_by_theta + r3_by_theta_of_place_3;
    // p_w_outer_frame_in_inner_frame_3_2 + p_w_outer_frame_in_inner_frame_2_2_by_theta
    let r3_by_theta_of_place_5 = p_w_outer_frame_in_inner_frame_3_2
        + p_w_outer_frame_in_inner_frame_2_2_by_theta;
    // p_w_outer_frame_in_inner_frame_2_2 - H_inner_3_2_by_theta
    let r3_by_theta_of_place_6 = p_w_outer_frame_in_inner_frame_2_2 - H_inner_3_2_by_theta;
    // r3_by_theta = cos(theta)*(H_inner_3_2_by_theta - p_w_outer_frame_in_inner_frame_2_2 -
    //   theta'*(p_w_outer_frame_in_inner_frame_2_by_theta - p_w_outer_frame_in_inner_frame_3) +
    //   H_rotor_3_2_by_theta) - l1*(psi'*cos(theta)*(H_rotor_1*cos(phi) + H_rotor_2*sin(phi)) +
    //   B*(w_outer_frame_in_inner_frame_2*(w_inner_frame_in_rotor_frame_1_by_theta*cos(phi) +
    //   w_inner_frame_in_rotor_frame_2_by_theta*sin(phi)) -
    //   theta'*(w_inner_frame_in_rotor_frame_1_by_theta*sin(phi) -
    //   w_inner_frame_in_rotor_frame_2_by_theta*cos(phi))) + H_rotor_3_2_by_theta) +
    //   sin(theta)*(w_outer_frame_in_inner_frame_2*(H_rotor_1*cos(phi) + H_rotor_2*sin(phi)) + H_rotor_3_2 -
    //   p_w_outer_frame_in_inner_frame_3_2 + theta'*(H_rotor_2*cos(phi) - H_rotor_1*sin(phi) +
    //   p_w_outer_frame_in_inner_frame_2 + p_w_outer_frame_in_inner_frame_3_by_theta) -
    //   p_w_outer_frame_in_inner_frame_2_2_by_theta)
    let r3_by_theta = theta_dot_sin_theta * r3_by_theta_of_place
        + theta_dot_cos_theta * r3_by_theta_of_place_2 - l1 * r3_by_theta_of_place_4
        + sin_theta * (r3_of_place_2 - r3_by_theta_of_place_5)
        + cos_theta * (H_rotor_3_2_by_theta - r3_by_theta_of_place_6);
    let s2_by_theta_s2_inv = s2_by_theta * s2_inv;
    let l4_by_theta_of_place = p_w_outer_frame_in_inner_frame_2_5 * cos_theta;
    let l4_by_theta_of_place_2 = s2_inv * l4_by_theta_of_place;
    // l4_by_theta = p_w_outer_frame_in_inner_frame_2_5*(s2_by_theta*sin(theta)/s2 - cos(theta))/s2
    let l4_by_theta = l4_of_place.mul_add(s2_by_theta_s2_inv, -l4_by_theta_of_place_2);
    // s5_by_theta = p_w_outer_frame_in_inner_frame_2_5*(l4*cos(theta) + l4_by_theta*sin(theta))
    let s5_by_theta = l4.mul_add(l4_by_theta_of_place, l4_by_theta * s5_of_place_2);
    // r6_by_theta = B*(phi'*(w_inner_frame_in_rotor_frame_1_by_theta*sin(phi) -
    //   w_inner_frame_in_rotor_frame_2_by_theta*cos(phi)) +
    //   w_inner_frame_in_rotor_frame_1_2_by_theta*cos(phi) -
    //   w_inner_frame_in_rotor_frame_2_2_by_theta*sin(phi)) -
    //   psi'*(sin(theta)*(p_w_outer_frame_in_inner_frame_2 + p_w_outer_frame_in_inner_frame_3_by_theta) +
    //   cos(theta)*(p_w_outer_frame_in_inner_frame_3 - p_w_outer_frame_in_inner_frame_2_by_theta)) -
    //   l4*r3_by_theta - r3*l4_by_theta
    let r6_by_theta = (-H_rotor_2_5)
        .mul_add(
            w_inner_frame_in_rotor_frame_2_2_by_theta,
            H_rotor_1_5 * w_inner_frame_in_rotor_frame_1_2_by_theta,
        ) - l4 * r3_by_theta - r3 * l4_by_theta
        - w_inner_frame_in_rotor_frame_2_by_theta * phi_dot_h_rotor_1_5
        + w_inner_frame_in_rotor_frame_1_by_theta * phi_dot_h_rotor_2_5
        - w_outer_frame_in_inner_frame_2 * r3_by_theta_of_place
        - w_outer_frame_in_inner_frame_3 * r3_by_theta_of_place_2;
    // theta''*s5_by_theta - r6_by_theta
    let psi_ddot_by_theta_of_theta_ddot = theta_ddot.mul_add(s5_by_theta, -r6_by_theta);
    let l4_of_place_s5_inv = l4_of_place * s5_inv;
    // psi_ddot_by_theta = (r3_by_theta - r3*s2_by_theta/s2 +
    //   p_w_outer_frame_in_inner_frame_2_5*(theta''*cos(theta) + sin(theta)*((r6_by_theta -
    //   r6*s5_by_theta/s5)/s5 - theta''*s2_by_theta/s2)))/s2
    let psi_ddot_by_theta = (-psi_ddot).mul_add(s2_by_theta_s2_inv, r3_by_theta * s2_inv)
        + theta_ddot * l4_by_theta_of_place_2
        - psi_ddot_by_theta_of_theta_ddot * l4_of_place_s5_inv;
    let c_inv = S::int(1) / C;
    // phi_ddot_by_theta = psi''*sin(theta) + (psi'*cos(theta)*(H_rotor_1*cos(phi) + H_rotor_2*sin(phi)) +
    //   B*(w_outer_frame_in_inner_frame_2*(w_inner_frame_in_rotor_frame_1_by_theta*cos(phi) +
    //   w_inner_frame_in_rotor_frame_2_by_theta*sin(phi)) -
    //   theta'*(w_inner_frame_in_rotor_frame_1_by_theta*sin(phi) -
    //   w_inner_frame_in_rotor_frame_2_by_theta*cos(phi))) + H_rotor_3_2_by_theta)/C -
    //   psi_ddot_by_theta*cos(theta)
    let phi_ddot_by_theta = (-psi_ddot_by_theta).mul_add(cos_theta, psi_ddot * sin_theta)
        + r3_by_theta_of_place_4 * c_inv;
    // w_inner_frame_in_rotor_frame_2_by_phi = theta'*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_2_by_phi = w_inner_frame_in_rotor_frame_1;
    // p_w_outer_frame_in_inner_frame_2_by_phi = H_rotor_1*cos(phi) + H_rotor_2*sin(phi) +
    //   B*(w_inner_frame_in_rotor_frame_1_by_phi*sin(phi) - w_inner_frame_in_rotor_frame_2_by_phi*cos(phi))
    let p_w_outer_frame_in_inner_frame_2_by_phi = (-H_rotor_1_5)
        .mul_add(
            w_inner_frame_in_rotor_frame_2_by_phi,
            H_rotor_2_5 * w_inner_frame_in_rotor_frame_1_by_phi,
        ) + p_w_outer_frame_in_inner_frame_2_2_of_place;
    // w_inner_frame_in_rotor_frame_1_2_by_phi = phi'*(theta'*cos(phi) +
    //   w_outer_frame_in_inner_frame_2*sin(phi)) - w_outer_frame_in_inner_frame_2_2*cos(phi)
    let w_inner_frame_in_rotor_frame_1_2_by_phi = w_inner_frame_in_rotor_frame_2_2_of_phi_dot_2;
    // p_w_outer_frame_in_inner_frame_2_2_by_phi = phi'*(H_rotor_2*cos(phi) - H_rotor_1*sin(phi)) -
    //   H_rotor_1_2*cos(phi) + H_rotor_2_2*sin(phi) +
    //   B*(phi'*(w_inner_frame_in_rotor_frame_1_by_phi*cos(phi) +
    //   w_inner_frame_in_rotor_frame_2_by_phi*sin(phi)) - w_inner_frame_in_rotor_frame_1_2_by_phi*sin(phi) -
    //   w_inner_frame_in_rotor_frame_2_2_by_phi*cos(phi))
    let p_w_outer_frame_in_inner_frame_2_2_by_phi = (-H_rotor_2_5)
        .mul_add(w_inner_frame_in_rotor_frame_1_2_by_phi, r6_of_phi_dot)
        - H_rotor_1_5 * w_inner_frame_in_rotor_frame_2_2_by_phi
        + w_inner_frame_in_rotor_frame_1_by_phi * phi_dot_h_rotor_1_5
        + w_inner_frame_in_rotor_frame_2_by_phi * phi_dot_h_rotor_2_5;
    // w_inner_frame_in_rotor_frame_1_4_by_phi = sin(theta)*cos(phi)
    let w_inner_frame_in_rotor_frame_1_4_by_phi = w_inner_frame_in_rotor_frame_2_4;
    // w_inner_frame_in_rotor_frame_2_4_by_phi = -sin(theta)*sin(phi)
    let w_inner_frame_in_rotor_frame_2_4_by_phi = -w_inner_frame_in_rotor_frame_1_4;
    // p_w_outer_frame_in_inner_frame_2_4_by_phi = H_rotor_1_4*cos(phi) - H_rotor_2_4*sin(phi) +
    //   B*(w_inner_frame_in_rotor_frame_1_4_by_phi*sin(phi) +
    //   w_inner_frame_in_rotor_frame_2_4_by_phi*cos(phi))
    let p_w_outer_frame_in_inner_frame_2_4_by_phi = (-H_rotor_2_4)
        .mul_add(sin_phi, H_rotor_1_4 * cos_phi)
        + H_rotor_2_5 * w_inner_frame_in_rotor_frame_1_4_by_phi
        + H_rotor_1_5 * w_inner_frame_in_rotor_frame_2_4_by_phi;
    // p_w_outer_frame_in_inner_frame_2_5_by_phi = B - H_rotor_1_5*cos(phi) - H_rotor_2_5*sin(phi)
    let p_w_outer_frame_in_inner_frame_2_5_by_phi = B - s5_of_place;
    // w_inner_frame_in_rotor_frame_1*H_rotor_1 - H_rotor_2*w_inner_frame_in_rotor_frame_1_by_phi
    let r3_by_phi_of_place = (-H_rotor_2)
        .mul_add(
            w_inner_frame_in_rotor_frame_1_by_phi,
            w_inner_frame_in_rotor_frame_1 * H_rotor_1,
        );
    // B*(w_inner_frame_in_rotor_frame_1_by_phi^2 +
    //   w_inner_frame_in_rotor_frame_1*w_inner_frame_in_rotor_frame_2_by_phi) - r3_by_phi_of_place
    let r3_by_phi_of_place_2 = B
        * w_inner_frame_in_rotor_frame_1
            .mul_add(
                w_inner_frame_in_rotor_frame_2_by_phi,
                w_inner_frame_in_rotor_frame_1_by_phi * w_inner_frame_in_rotor_frame_1_by_phi,
            ) - r3_by_phi_of_place;
    // r3_by_phi = l1*(H_rotor_1*(theta'*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)) +
    //   H_rotor_2*(theta'*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)) +
    //   B*w_inner_frame_in_rotor_frame_1_by_phi*(theta'*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi))
    //   - B*w_inner_frame_in_rotor_frame_2_by_phi*(theta'*cos(phi) +
    //   w_outer_frame_in_inner_frame_2*sin(phi))) -
    //   theta'*p_w_outer_frame_in_inner_frame_2_by_phi*cos(theta) -
    //   p_w_outer_frame_in_inner_frame_2_2_by_phi*sin(theta)
    let r3_by_phi = (-p_w_outer_frame_in_inner_frame_2_by_phi)
        .mul_add(
            theta_dot_cos_theta,
            -p_w_outer_frame_in_inner_frame_2_2_by_phi * sin_theta,
        ) - l1 * r3_by_phi_of_place_2;
    let l4_by_phi_of_place = p_w_outer_frame_in_inner_frame_2_5_by_phi * sin_theta_s2_inv;
    let l4_by_phi_of_place_2 = p_w_outer_frame_in_inner_frame_2_4_by_phi * sin_theta_s2_inv;
    // l4_by_phi =
    //   sin(theta)*(p_w_outer_frame_in_inner_frame_2_5*p_w_outer_frame_in_inner_frame_2_4_by_phi*sin(theta)/s2
    //   - p_w_outer_frame_in_inner_frame_2_5_by_phi)/s2
    let l4_by_phi = l4_of_place.mul_add(l4_by_phi_of_place_2, -l4_by_phi_of_place);
    // s5_by_phi = H_rotor_2_5*cos(phi) - H_rotor_1_5*sin(phi) +
    //   sin(theta)*(l4*p_w_outer_frame_in_inner_frame_2_5_by_phi +
    //   p_w_outer_frame_in_inner_frame_2_5*l4_by_phi)
    let s5_by_phi = (l4 * p_w_outer_frame_in_inner_frame_2_5_by_phi)
        .mul_add(sin_theta, p_w_outer_frame_in_inner_frame_2_5) + l4_by_phi * s5_of_place_2;
    // r6_by_phi = phi'*(H_rotor_1*cos(phi) + H_rotor_2*sin(phi)) - H_rotor_1_2*sin(phi) -
    //   H_rotor_2_2*cos(phi) + psi'*p_w_outer_frame_in_inner_frame_2_by_phi*cos(theta) +
    //   B*(phi'*(w_inner_frame_in_rotor_frame_1_by_phi*sin(phi) -
    //   w_inner_frame_in_rotor_frame_2_by_phi*cos(phi)) + w_inner_frame_in_rotor_frame_1_2_by_phi*cos(phi) -
    //   w_inner_frame_in_rotor_frame_2_2_by_phi*sin(phi)) - l4*r3_by_phi - r3*l4_by_phi
    let r6_by_phi = H_rotor_1_5
        .mul_add(
            w_inner_frame_in_rotor_frame_1_2_by_phi,
            w_outer_frame_in_inner_frame_3 * p_w_outer_frame_in_inner_frame_2_by_phi,
        ) - H_rotor_2_5 * w_inner_frame_in_rotor_frame_2_2_by_phi - l4 * r3_by_phi
        - r3 * l4_by_phi + p_w_outer_frame_in_inner_frame_2_2_of_phi_dot
        - w_inner_frame_in_rotor_frame_2_by_phi * phi_dot_h_rotor_1_5
        + w_inner_frame_in_rotor_frame_1_by_phi * phi_dot_h_rotor_2_5;
    // theta''*s5_by_phi - r6_by_phi
    let psi_ddot_by_phi_of_theta_ddot = theta_ddot.mul_add(s5_by_phi, -r6_by_phi);
    // psi_ddot_by_phi = (r3_by_phi + sin(theta)*(theta''*p_w_outer_frame_in_inner_frame_2_5_by_phi -
    //   r3*p_w_outer_frame_in_inner_frame_2_4_by_phi/s2 + p_w_outer_frame_in_inner_frame_2_5*((r6_by_phi -
    //   r6*s5_by_phi/s5)/s5 - theta''*p_w_outer_frame_in_inner_frame_2_4_by_phi*sin(theta)/s2)))/s2
    let psi_ddot_by_phi = theta_ddot.mul_add(l4_by_phi_of_place, r3_by_phi * s2_inv)
        - psi_ddot * l4_by_phi_of_place_2 - l4_of_place_s5_inv * psi_ddot_by_phi_of_theta_ddot;
    // phi_ddot_by_phi = -(w_outer_frame_in_inner_frame_2*(H_rotor_1*sin(phi) - H_rotor_2*cos(phi)) +
    //   theta'*(H_rotor_1*cos(phi) + H_rotor_2*sin(phi)) +
    //   B*(theta'*(w_inner_frame_in_rotor_frame_1_by_phi*sin(phi) -
    //   w_inner_frame_in_rotor_frame_2_by_phi*cos(phi)) -
    //   w_outer_frame_in_inner_frame_2*(w_inner_frame_in_rotor_frame_1_by_phi*cos(phi) +
    //   w_inner_frame_in_rotor_frame_2_by_phi*sin(phi))))/C - psi_ddot_by_phi*cos(theta)
    let phi_ddot_by_phi = (-psi_ddot_by_phi)
        .mul_add(cos_theta, c_inv * r3_by_phi_of_place_2);
    // w_inner_frame_in_rotor_frame_1_by_psi_dot = sin(theta)*sin(phi)
    let w_inner_frame_in_rotor_frame_1_by_psi_dot = w_inner_frame_in_rotor_frame_1_4;
    // w_inner_frame_in_rotor_frame_2_by_psi_dot = -sin(theta)*cos(phi)
    let w_inner_frame_in_rotor_frame_2_by_psi_dot = -w_inner_frame_in_rotor_frame_2_4;
    // p_w_outer_frame_in_inner_frame_2_by_psi_dot = Ay*sin(theta) +
    //   B*(w_inner_frame_in_rotor_frame_1_by_psi_dot*sin(phi) -
    //   w_inner_frame_in_rotor_frame_2_by_psi_dot*cos(phi))
    let p_w_outer_frame_in_inner_frame_2_by_psi_dot = H_rotor_2_5
        .mul_add(w_inner_frame_in_rotor_frame_1_by_psi_dot, H_inner_2_4)
        - H_rotor_1_5 * w_inner_frame_in_rotor_frame_2_by_psi_dot;
    // w_inner_frame_in_rotor_frame_1_2_by_psi_dot = -theta'*cos(theta)*sin(phi) - phi'*sin(theta)*cos(phi)
    let w_inner_frame_in_rotor_frame_1_2_by_psi_dot = (-theta_dot_cos_theta)
        .mul_add(sin_phi, -phi_dot * w_inner_frame_in_rotor_frame_2_4);
    // w_inner_frame_in_rotor_frame_2_2_by_psi_dot = phi'*sin(theta)*sin(phi) - theta'*cos(theta)*cos(phi)
    let w_inner_frame_in_rotor_frame_2_2_by_psi_dot = (-theta_dot_cos_theta)
        .mul_add(cos_phi, phi_dot * w_inner_frame_in_rotor_frame_1_4);
    // p_w_outer_frame_in_inner_frame_3_2_by_psi_dot = theta'*sin(theta)*(Az + C)
    let p_w_outer_frame_in_inner_frame_3_2_by_psi_dot = theta_dot_sin_theta * az_plus_c;
    // p_w_outer_frame_in_inner_frame_2_2_by_psi_dot = Ay*theta'*cos(theta) +
    //   B*(phi'*(w_inner_frame_in_rotor_frame_1_by_psi_dot*cos(phi) +
    //   w_inner_frame_in_rotor_frame_2_by_psi_dot*sin(phi)) -
    //   w_inner_frame_in_rotor_frame_1_2_by_psi_dot*sin(phi) -
    //   w_inner_frame_in_rotor_frame_2_2_by_psi_dot*cos(phi))
    let p_w_outer_frame_in_inner_frame_2_2_by_psi_dot = (-H_rotor_2_5)
        .mul_add(w_inner_frame_in_rotor_frame_1_2_by_psi_dot, Ay * theta_dot_cos_theta)
        - H_rotor_1_5 * w_inner_frame_in_rotor_frame_2_2_by_psi_dot
        + w_inner_frame_in_rotor_frame_1_by_psi_dot * phi_dot_h_rotor_1_5
        + w_inner_frame_in_rotor_frame_2_by_psi_dot * phi_dot_h_rotor_2_5;
    // B*(w_inner_frame_in_rotor_frame_1_by_phi*w_inner_frame_in_rotor_frame_1_by_psi_dot +
    //   w_inner_frame_in_rotor_frame_1*w_inner_frame_in_rotor_frame_2_by_psi_dot) +
    //   p_w_outer_frame_in_inner_frame_2_2_of_place*sin(theta)
    let r3_by_psi_dot_of_place = B
        * w_inner_frame_in_rotor_frame_1
            .mul_add(
                w_inner_frame_in_rotor_frame_2_by_psi_dot,
                w_inner_frame_in_rotor_frame_1_by_phi * w_inner_frame_in_rotor_frame_1_by_psi_dot,
            ) + p_w_outer_frame_in_inner_frame_2_2_of_place * sin_theta;
    // az_plus_c*sin(theta) - p_w_outer_frame_in_inner_frame_2_by_psi_dot
    let r3_by_psi_dot_of_place_2 = az_plus_c
        .mul_add(sin_theta, -p_w_outer_frame_in_inner_frame_2_by_psi_dot);
    // r3_by_psi_dot = l1*(B*(theta'*(w_inner_frame_in_rotor_frame_1_by_psi_dot*sin(phi) -
    //   w_inner_frame_in_rotor_frame_2_by_psi_dot*cos(phi)) -
    //   w_outer_frame_in_inner_frame_2*(w_inner_frame_in_rotor_frame_1_by_psi_dot*cos(phi) +
    //   w_inner_frame_in_rotor_frame_2_by_psi_dot*sin(phi))) - sin(theta)*(C*theta' + H_rotor_1*cos(phi) +
    //   H_rotor_2*sin(phi))) + cos(theta)*(theta'*(sin(theta)*(Az + C) -
    //   p_w_outer_frame_in_inner_frame_2_by_psi_dot) + p_w_outer_frame_in_inner_frame_3_2_by_psi_dot) -
    //   p_w_outer_frame_in_inner_frame_2_2_by_psi_dot*sin(theta)
    let r3_by_psi_dot = (-p_w_outer_frame_in_inner_frame_2_2_by_psi_dot)
        .mul_add(sin_theta, p_w_outer_frame_in_inner_frame_3_2_by_psi_dot * cos_theta)
        - c_l1 * theta_dot_sin_theta - l1 * r3_by_psi_dot_of_place
        + theta_dot_cos_theta * r3_by_psi_dot_of_place_2;
    // p_w_outer_frame_in_inner_frame_3*sin(theta) - p_w_outer_frame_in_inner_frame_2*cos(theta)
    let r6_by_psi_dot_of_place = (-p_w_outer_frame_in_inner_frame_2)
        .mul_add(cos_theta, p_w_outer_frame_in_inner_frame_3 * sin_theta);
    // r6_by_psi_dot = cos(theta)*(p_w_outer_frame_in_inner_frame_2 +
    //   psi'*(p_w_outer_frame_in_inner_frame_2_by_psi_dot - sin(theta)*(Az + C))) -
    //   p_w_outer_frame_in_inner_frame_3*sin(theta) +
    //   B*(phi'*(w_inner_frame_in_rotor_frame_1_by_psi_dot*sin(phi) -
    //   w_inner_frame_in_rotor_frame_2_by_psi_dot*cos(phi)) +
    //   w_inner_frame_in_rotor_frame_1_2_by_psi_dot*cos(phi) -
    //   w_inner_frame_in_rotor_frame_2_2_by_psi_dot*sin(phi)) - l4*r3_by_psi_dot
    let r6_by_psi_dot = (-H_rotor_2_5)
        .mul_add(
            w_inner_frame_in_rotor_frame_2_2_by_psi_dot,
            H_rotor_1_5 * w_inner_frame_in_rotor_frame_1_2_by_psi_dot,
        ) - l4 * r3_by_psi_dot - w_inner_frame_in_rotor_frame_2_by_psi_dot * phi_dot_h_rotor_1_5
        + w_inner_frame_in_rotor_frame_1_by_psi_dot * phi_dot_h_rotor_2_5
        - w_outer_frame_in_inner_frame_3 * r3_by_psi_dot_of_place_2 - r6_by_psi_dot_of_place;
    // psi_ddot_by_psi_dot = (r3_by_psi_dot +
    //   p_w_outer_frame_in_inner_frame_2_5*r6_by_psi_dot*sin(theta)/s5)/s2
    let psi_ddot_by_psi_dot = r6_by_psi_dot
        .mul_add(l4_of_place_s5_inv, r3_by_psi_dot * s2_inv);
    // phi_ddot_by_psi_dot = theta'*sin(theta) + (sin(theta)*(H_rotor_1*cos(phi) + H_rotor_2*sin(phi)) -
    //   B*(theta'*(w_inner_frame_in_rotor_frame_1_by_psi_dot*sin(phi) -
    //   w_inner_frame_in_rotor_frame_2_by_psi_dot*cos(phi)) -
    //   w_outer_frame_in_inner_frame_2*(w_inner_frame_in_rotor_frame_1_by_psi_dot*cos(phi) +
    //   w_inner_frame_in_rotor_frame_2_by_psi_dot*sin(phi))))/C - psi_ddot_by_psi_dot*cos(theta)
    let phi_ddot_by_psi_dot = (-psi_ddot_by_psi_dot)
        .mul_add(cos_theta, theta_dot_sin_theta) + c_inv * r3_by_psi_dot_of_place;
    // w_outer_frame_in_inner_frame_3 - phi'
    let w_inner_frame_in_rotor_frame_1_2_by_theta_dot_of_phi_dot = w_outer_frame_in_inner_frame_3
        - phi_dot;
    // w_inner_frame_in_rotor_frame_1_2_by_theta_dot = sin(phi)*(phi' - psi'*cos(theta))
    let w_inner_frame_in_rotor_frame_1_2_by_theta_dot = -w_inner_frame_in_rotor_frame_1_2_by_theta_dot_of_phi_dot
        * sin_phi;
    // w_inner_frame_in_rotor_frame_2_2_by_theta_dot = cos(phi)*(phi' - psi'*cos(theta))
    let w_inner_frame_in_rotor_frame_2_2_by_theta_dot = -w_inner_frame_in_rotor_frame_1_2_by_theta_dot_of_phi_dot
        * cos_phi;
    // p_w_outer_frame_in_inner_frame_2_2_by_theta_dot = Ay*psi'*cos(theta) + B*(phi' -
    //   w_inner_frame_in_rotor_frame_1_2_by_theta_dot*sin(phi) -
    //   w_inner_frame_in_rotor_frame_2_2_by_theta_dot*cos(phi))
    let p_w_outer_frame_in_inner_frame_2_2_by_theta_dot = (-H_rotor_2_5)
        .mul_add(w_inner_frame_in_rotor_frame_1_2_by_theta_dot, B * phi_dot)
        - H_rotor_1_5 * w_inner_frame_in_rotor_frame_2_2_by_theta_dot
        + p_w_outer_frame_in_inner_frame_2_by_theta_of_place;
    // B*w_outer_frame_in_inner_frame_2 + p_w_outer_frame_in_inner_frame_2_of_place
    let r3_by_theta_dot_of_place = B
        .mul_add(
            w_outer_frame_in_inner_frame_2, p_w_outer_frame_in_inner_frame_2_of_place,
        );
    // r3_by_theta_dot = l1*(H_rotor_1*sin(phi) - C*psi'*sin(theta) - B*w_outer_frame_in_inner_frame_2 -
    //   H_rotor_2*cos(phi)) + cos(theta)*(p_w_outer_frame_in_inner_frame_3_2_by_theta_dot -
    //   p_w_outer_frame_in_inner_frame_2) + sin(theta)*(p_w_outer_frame_in_inner_frame_3 -
    //   p_w_outer_frame_in_inner_frame_2_2_by_theta_dot)
    let r3_by_theta_dot = (-p_w_outer_frame_in_inner_frame_2_2_by_theta_dot)
        .mul_add(sin_theta, p_w_outer_frame_in_inner_frame_3_2_by_theta_dot * cos_theta)
        - w_outer_frame_in_inner_frame_2 * c_l1 + r6_by_psi_dot_of_place
        - l1 * r3_by_theta_dot_of_place;
    // r6_by_theta_dot = B*(w_inner_frame_in_rotor_frame_1_2_by_theta_dot*cos(phi) -
    //   w_inner_frame_in_rotor_frame_2_2_by_theta_dot*sin(phi)) - l4*r3_by_theta_dot
    let r6_by_theta_dot = (-H_rotor_2_5)
        .mul_add(
            w_inner_frame_in_rotor_frame_2_2_by_theta_dot,
            H_rotor_1_5 * w_inner_frame_in_rotor_frame_1_2_by_theta_dot,
        ) - l4 * r3_by_theta_dot;
    // psi_ddot_by_theta_dot = (r3_by_theta_dot +
    //   p_w_outer_frame_in_inner_frame_2_5*r6_by_theta_dot*sin(theta)/s5)/s2
    let psi_ddot_by_theta_dot = r6_by_theta_dot
        .mul_add(l4_of_place_s5_inv, r3_by_theta_dot * s2_inv);
    // phi_ddot_by_theta_dot = psi'*sin(theta) + (B*w_outer_frame_in_inner_frame_2 - H_rotor_1*sin(phi) +
    //   H_rotor_2*cos(phi))/C - psi_ddot_by_theta_dot*cos(theta)
    let phi_ddot_by_theta_dot = (-psi_ddot_by_theta_dot)
        .mul_add(cos_theta, w_outer_frame_in_inner_frame_2) + c_inv * r3_by_theta_dot_of_place;
    // w_inner_frame_in_rotor_frame_1_2_by_phi_dot = theta'*sin(phi) -
    //   w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_1_2_by_phi_dot = w_inner_frame_in_rotor_frame_2_of_place;
    // w_inner_frame_in_rotor_frame_2_2_by_phi_dot = theta'*cos(phi) +
    //   w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_2_2_by_phi_dot = w_inner_frame_in_rotor_frame_1;
    // p_w_outer_frame_in_inner_frame_2_2_by_phi_dot = H_rotor_1*cos(phi) + H_rotor_2*sin(phi) -
    //   B*(w_inner_frame_in_rotor_frame_1_2_by_phi_dot*sin(phi) +
    //   w_inner_frame_in_rotor_frame_2_2_by_phi_dot*cos(phi))
    let p_w_outer_frame_in_inner_frame_2_2_by_phi_dot = (-H_rotor_2_5)
        .mul_add(
            w_inner_frame_in_rotor_frame_1_2_by_phi_dot,
            p_w_outer_frame_in_inner_frame_2_2_of_place,
        ) - H_rotor_1_5 * w_inner_frame_in_rotor_frame_2_2_by_phi_dot;
    // r3_by_phi_dot = sin(theta)*(C*theta' - p_w_outer_frame_in_inner_frame_2_2_by_phi_dot)
    let r3_by_phi_dot = (-p_w_outer_frame_in_inner_frame_2_2_by_phi_dot)
        .mul_add(sin_theta, C * theta_dot_sin_theta);
    // r6_by_phi_dot = H_rotor_1*sin(phi) - C*psi'*sin(theta) - H_rotor_2*cos(phi) +
    //   B*(w_inner_frame_in_rotor_frame_1_2_by_phi_dot*cos(phi) -
    //   w_inner_frame_in_rotor_frame_2_2_by_phi_dot*sin(phi)) - l4*r3_by_phi_dot
    let r6_by_phi_dot = (-C)
        .mul_add(
            w_outer_frame_in_inner_frame_2,
            H_rotor_1_5 * w_inner_frame_in_rotor_frame_1_2_by_phi_dot,
        ) - H_rotor_2_5 * w_inner_frame_in_rotor_frame_2_2_by_phi_dot
        - l4 * r3_by_phi_dot - p_w_outer_frame_in_inner_frame_2_of_place;
    // psi_ddot_by_phi_dot = (r3_by_phi_dot +
    //   p_w_outer_frame_in_inner_frame_2_5*r6_by_phi_dot*sin(theta)/s5)/s2
    let psi_ddot_by_phi_dot = r6_by_phi_dot
        .mul_add(l4_of_place_s5_inv, r3_by_phi_dot * s2_inv);
    // Entries that are not zero.
    // d(psi')/d(psi') = 1
    let psi_dot_by_psi_dot_value = S::int(1);
    // d(theta')/d(theta') = 1
    let theta_dot_by_theta_dot_value = S::int(1);
    // d(phi')/d(phi') = 1
    let phi_dot_by_phi_dot_value = S::int(1);
    // d(theta'')/d(theta) = (r6_by_theta - r6*s5_by_theta/s5)/s5
    let theta_ddot_by_theta_value = -s5_inv * psi_ddot_by_theta_of_theta_ddot;
    // d(theta'')/d(phi) = (r6_by_phi - r6*s5_by_phi/s5)/s5
    let theta_ddot_by_phi_value = -s5_inv * psi_ddot_by_phi_of_theta_ddot;
    // d(theta'')/d(psi') = r6_by_psi_dot/s5
    let theta_ddot_by_psi_dot_value = r6_by_psi_dot * s5_inv;
    // d(theta'')/d(theta') = r6_by_theta_dot/s5
    let theta_ddot_by_theta_dot_value = r6_by_theta_dot * s5_inv;
    // d(theta'')/d(phi') = r6_by_phi_dot/s5
    let theta_ddot_by_phi_dot_value = r6_by_phi_dot * s5_inv;
    // d(phi'')/d(phi') = -psi_ddot_by_phi_dot*cos(theta)
    let phi_ddot_by_phi_dot_value = -psi_ddot_by_phi_dot * cos_theta;
    let zero = S::int(0);
    [
        [zero, zero, zero, psi_dot_by_psi_dot_value, zero, zero],
        [zero, zero, zero, zero, theta_dot_by_theta_dot_value, zero],
        [zero, zero, zero, zero, zero, phi_dot_by_phi_dot_value],
        [
            zero, psi_ddot_by_theta, psi_ddot_by_phi, psi_ddot_by_psi_dot, psi_ddot_by_theta_dot,
            psi_ddot_by_phi_dot,
        ],
        [
            zero, theta_ddot_by_theta_value, theta_ddot_by_phi_value, theta_ddot_by_psi_dot_value,
            theta_ddot_by_theta_dot_value, theta_ddot_by_phi_dot_value,
        ],
        [
            zero, phi_ddot_by_theta, phi_ddot_by_phi, phi_ddot_by_psi_dot, phi_ddot_by_theta_dot,
            phi_ddot_by_phi_dot_value,
        ],
    ]
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

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 53 convolutions and 104 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 6]],
    history: &mut [Factors<S, 56>],
) {
    let Parameters { Iz, Ax, Ay, Az, B, C, .. } = *p;
    let [_, theta_0, phi_0, psi_dot_0, theta_dot_0, phi_dot_0] = series[0];
    // Shared terms.
    let b_c_inv = B / C;
    // Constant in time.
    // az_plus_c = Az + C
    let az_plus_c = Az + C;
    // minus_b = -B
    let minus_b = -B;
    // b_by_c = B/C
    let b_by_c = b_c_inv;
    // minus_b_by_c = -B/C
    let minus_b_by_c = -b_c_inv;
    // Order 0.
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    let psi_dot_sin_theta_0 = psi_dot_0 * sin_theta_0;
    let psi_dot_cos_theta_0 = psi_dot_0 * cos_theta_0;
    let (sin_phi_0, cos_phi_0) = phi_0.sin_cos();
    let theta_dot_cos_phi_0 = theta_dot_0 * cos_phi_0;
    let w_inner_frame_in_rotor_frame_1_of_psi_dot_0 = sin_phi_0 * psi_dot_sin_theta_0;
    let w_inner_frame_in_rotor_frame_1_of_theta_dot_0 = theta_dot_cos_phi_0
        + w_inner_frame_in_rotor_frame_1_of_psi_dot_0;
    let theta_dot_sin_phi_0 = theta_dot_0 * sin_phi_0;
    let w_inner_frame_in_rotor_frame_2_of_psi_dot_0 = cos_phi_0 * psi_dot_sin_theta_0;
    let w_inner_frame_in_rotor_frame_2_of_theta_dot_0 = theta_dot_sin_phi_0
        - w_inner_frame_in_rotor_frame_2_of_psi_dot_0;
    let h_inner_3_plus_h_rotor_3_0 = psi_dot_cos_theta_0
        .mul_add(az_plus_c, C * phi_dot_0);
    let p_w_outer_frame_in_inner_frame_2_of_theta_dot_0 = cos_phi_0
        * w_inner_frame_in_rotor_frame_2_of_theta_dot_0;
    let p_w_outer_frame_in_inner_frame_2_of_theta_dot_2_0 = sin_phi_0
        * w_inner_frame_in_rotor_frame_1_of_theta_dot_0;
    let p_w_outer_frame_in_inner_frame_2_of_place_0 = p_w_outer_frame_in_inner_frame_2_of_theta_dot_2_0
        .mul_add(
            B,
            p_w_outer_frame_in_inner_frame_2_of_theta_dot_0
                .mul_add(minus_b, Ay * psi_dot_sin_theta_0),
        );
    let w_outer_frame_in_inner_frame_2_2_of_motion_0 = theta_dot_0 * psi_dot_cos_theta_0;
    let w_outer_frame_in_inner_frame_3_2_of_motion_0 = theta_dot_0 * psi_dot_sin_theta_0;
    let w_inner_frame_in_rotor_frame_1_2_of_motion_0 = phi_dot_0
        * w_inner_frame_in_rotor_frame_2_of_psi_dot_0;
    let theta_dot_phi_dot_0 = theta_dot_0 * phi_dot_0;
    let w_inner_frame_in_rotor_frame_1_2_of_motion_2_0 = -theta_dot_phi_dot_0
        + w_outer_frame_in_inner_frame_2_2_of_motion_0;
    let w_inner_frame_in_rotor_frame_1_2_of_motion_3_0 = sin_phi_0
        * w_inner_frame_in_rotor_frame_1_2_of_motion_2_0;
    let w_inner_frame_in_rotor_frame_2_2_of_motion_0 = phi_dot_0
        * w_inner_frame_in_rotor_frame_1_of_psi_dot_0;
    let w_inner_frame_in_rotor_frame_2_2_of_motion_2_0 = cos_phi_0
        * w_inner_frame_in_rotor_frame_1_2_of_motion_2_0;
    let p_w_outer_frame_in_inner_frame_2_2_of_motion_0 = phi_dot_0
        * w_inner_frame_in_rotor_frame_1_of_theta_dot_0;
    let p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_0 = p_w_outer_frame_in_inner_frame_2_2_of_motion_0
        .mul_add(
            minus_b,
            w_inner_frame_in_rotor_frame_2_2_of_motion_2_0
                .mul_add(minus_b, B * w_inner_frame_in_rotor_frame_2_2_of_motion_0),
        );
    let p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_2_0 = cos_phi_0
        * p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_0;
    let p_w_outer_frame_in_inner_frame_2_2_of_motion_2_0 = phi_dot_0
        * w_inner_frame_in_rotor_frame_2_of_theta_dot_0;
    let p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_0 = p_w_outer_frame_in_inner_frame_2_2_of_motion_2_0
        .mul_add(
            minus_b,
            w_inner_frame_in_rotor_frame_1_2_of_motion_3_0
                .mul_add(minus_b, minus_b * w_inner_frame_in_rotor_frame_1_2_of_motion_0),
        );
    let p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_4_0 = sin_phi_0
        * p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_0;
    let sin_theta_sin_phi_0 = sin_theta_0 * sin_phi_0;
    let sin_theta_cos_phi_0 = sin_theta_0 * cos_phi_0;
    let sin_theta_cos_phi_sq_0 = cos_phi_0 * sin_theta_cos_phi_0;
    let sin_theta_sin_phi_sq_0 = sin_phi_0 * sin_theta_sin_phi_0;
    let p_w_outer_frame_in_inner_frame_2_4_of_place_0 = sin_theta_sin_phi_sq_0
        .mul_add(B, sin_theta_cos_phi_sq_0.mul_add(B, Ay * sin_theta_0));
    let sin_phi_cos_phi_0 = cos_phi_0 * sin_phi_0;
    let sin_phi_cos_phi_2_0 = sin_phi_0 * cos_phi_0;
    let p_w_outer_frame_in_inner_frame_2_5_of_place_0 = sin_phi_cos_phi_2_0
        .mul_add(minus_b, B * sin_phi_cos_phi_0);
    let s2_of_place_0 = sin_theta_0 * p_w_outer_frame_in_inner_frame_2_4_of_place_0;
    let s2_of_place_2_0 = Az * cos_theta_0;
    let s2_of_place_3_0 = cos_theta_0 * s2_of_place_2_0;
    let s2_of_place_4_0 = Iz + s2_of_place_3_0 + s2_of_place_0;
    let over_s2_of_place_4 = S::int(1) / s2_of_place_4_0;
    let r3_of_theta_dot_0 = w_inner_frame_in_rotor_frame_1_of_theta_dot_0
        * w_inner_frame_in_rotor_frame_2_of_theta_dot_0;
    let r3_of_theta_dot_2_0 = w_inner_frame_in_rotor_frame_2_of_theta_dot_0
        * w_inner_frame_in_rotor_frame_1_of_theta_dot_0;
    let r3_of_theta_dot_3_0 = r3_of_theta_dot_2_0
        .mul_add(
            minus_b,
            r3_of_theta_dot_0
                .mul_add(B, C * w_outer_frame_in_inner_frame_3_2_of_motion_0),
        );
    let r3_of_theta_dot_4_0 = r3_of_theta_dot_3_0 * cos_theta_0;
    let r3_of_theta_dot_5_0 = theta_dot_0 * p_w_outer_frame_in_inner_frame_2_of_place_0;
    let r3_of_theta_dot_6_0 = az_plus_c * w_outer_frame_in_inner_frame_3_2_of_motion_0
        - r3_of_theta_dot_5_0;
    let r3_of_theta_dot_7_0 = cos_theta_0 * r3_of_theta_dot_6_0;
    let r3_of_theta_dot_8_0 = theta_dot_0 * h_inner_3_plus_h_rotor_3_0;
    let r3_of_theta_dot_9_0 = Ay * w_outer_frame_in_inner_frame_2_2_of_motion_0
        - r3_of_theta_dot_8_0 - p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_2_0
        - p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_4_0;
    let r3_of_theta_dot_10_0 = sin_theta_0 * r3_of_theta_dot_9_0;
    let r3_of_theta_dot_11_0 = -r3_of_theta_dot_4_0 + r3_of_theta_dot_7_0 - r3_of_theta_dot_10_0;
    let l4_of_place_0 = sin_theta_0 * p_w_outer_frame_in_inner_frame_2_5_of_place_0;
    let l4_of_place_2_0 = l4_of_place_0 * over_s2_of_place_4;
    let sin_phi_sq_0 = sin_phi_0 * sin_phi_0;
    let cos_phi_sq_0 = cos_phi_0 * cos_phi_0;
    let s5_of_place_0 = l4_of_place_2_0 * l4_of_place_0;
    let s5_of_place_2_0 = cos_phi_sq_0.mul_add(B, sin_phi_sq_0.mul_add(B, Ax)) - s5_of_place_0;
    let over_s5_of_place_2 = S::int(1) / s5_of_place_2_0;
    let r6_of_place_0 = sin_theta_0 * h_inner_3_plus_h_rotor_3_0;
    let r6_of_place_2_0 = cos_theta_0 * p_w_outer_frame_in_inner_frame_2_of_place_0;
    let r6_of_place_3_0 = r6_of_place_0 - r6_of_place_2_0;
    let r6_of_psi_dot_0 = psi_dot_0 * r6_of_place_3_0;
    let r6_of_theta_dot_0 = r3_of_theta_dot_11_0 * l4_of_place_2_0;
    let r6_of_phi_dot_0 = cos_phi_0 * p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_0;
    let r6_of_phi_dot_2_0 = sin_phi_0 * p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_0;
    let r6_of_motion_0 = r6_of_phi_dot_0 - r6_of_phi_dot_2_0 - r6_of_psi_dot_0 + r6_of_theta_dot_0;
    let theta_dot_dot_0 = r6_of_motion_0 * over_s5_of_place_2;
    let psi_ddot_of_motion_0 = theta_dot_dot_0 * l4_of_place_0;
    let psi_ddot_of_theta_ddot_0 = r3_of_theta_dot_11_0 + psi_ddot_of_motion_0;
    let psi_dot_dot_0 = psi_ddot_of_theta_ddot_0 * over_s2_of_place_4;
    let phi_ddot_of_theta_ddot_0 = psi_dot_dot_0 * cos_theta_0;
    let phi_dot_dot_0 = r3_of_theta_dot_2_0
        .mul_add(
            minus_b_by_c,
            r3_of_theta_dot_0
                .mul_add(b_by_c, w_outer_frame_in_inner_frame_3_2_of_motion_0),
        ) - phi_ddot_of_theta_ddot_0;
    // Order 1: the rates, and what follows from them.
    let psi_1 = psi_dot_0;
    let theta_1 = theta_dot_0;
    let phi_1 = phi_dot_0;
    let psi_dot_1 = psi_dot_dot_0;
    let theta_dot_1 = theta_dot_dot_0;
    let phi_dot_1 = phi_dot_dot_0;
    if series.len() > 1 {
        series[1] = [psi_1, theta_1, phi_1, psi_dot_1, theta_dot_1, phi_dot_1];
    }
    let sin_theta_1 = theta_1 * cos_theta_0;
    let cos_theta_1 = -theta_1 * sin_theta_0;
    let psi_dot_sin_theta_1 = sin_theta_1.mul_add(psi_dot_0, psi_dot_1 * sin_theta_0);
    let psi_dot_cos_theta_1 = cos_theta_1.mul_add(psi_dot_0, psi_dot_1 * cos_theta_0);
    let sin_phi_1 = phi_1 * cos_phi_0;
    let cos_phi_1 = -phi_1 * sin_phi_0;
    let theta_dot_cos_phi_1 = cos_phi_1.mul_add(theta_dot_0, theta_dot_1 * cos_phi_0);
    let w_inner_frame_in_rotor_frame_1_of_psi_dot_1 = psi_dot_sin_theta_1
        .mul_add(sin_phi_0, sin_phi_1 * psi_dot_sin_theta_0);
    let w_inner_frame_in_rotor_frame_1_of_theta_dot_1 = theta_dot_cos_phi_1
        + w_inner_frame_in_rotor_frame_1_of_psi_dot_1;
    let theta_dot_sin_phi_1 = sin_phi_1.mul_add(theta_dot_0, theta_dot_1 * sin_phi_0);
    let w_inner_frame_in_rotor_frame_2_of_psi_dot_1 = psi_dot_sin_theta_1
        .mul_add(cos_phi_0, cos_phi_1 * psi_dot_sin_theta_0);
    let w_inner_frame_in_rotor_frame_2_of_theta_dot_1 = theta_dot_sin_phi_1
        - w_inner_frame_in_rotor_frame_2_of_psi_dot_1;
    let h_inner_3_plus_h_rotor_3_1 = psi_dot_cos_theta_1
        .mul_add(az_plus_c, C * phi_dot_1);
    let p_w_outer_frame_in_inner_frame_2_of_theta_dot_1 = w_inner_frame_in_rotor_frame_2_of_theta_dot_1
        .mul_add(cos_phi_0, cos_phi_1 * w_inner_frame_in_rotor_frame_2_of_theta_dot_0);
    let p_w_outer_frame_in_inner_frame_2_of_theta_dot_2_1 = w_inner_frame_in_rotor_frame_1_of_theta_dot_1
        .mul_add(sin_phi_0, sin_phi_1 * w_inner_frame_in_rotor_frame_1_of_theta_dot_0);
    let p_w_outer_frame_in_inner_frame_2_of_place_1 = p_w_outer_frame_in_inner_frame_2_of_theta_dot_2_1
        .mul_add(
            B,
            p_w_outer_frame_in_inner_frame_2_of_theta_dot_1
                .mul_add(minus_b, Ay * psi_dot_sin_theta_1),
        );
    let w_outer_frame_in_inner_frame_2_2_of_motion_1 = psi_dot_cos_theta_1
        .mul_add(theta_dot_0, theta_dot_1 * psi_dot_cos_theta_0);
    let w_outer_frame_in_inner_frame_3_2_of_motion_1 = psi_dot_sin_theta_1
        .mul_add(theta_dot_0, theta_dot_1 * psi_dot_sin_theta_0);
    let w_inner_frame_in_rotor_frame_1_2_of_motion_1 = w_inner_frame_in_rotor_frame_2_of_psi_dot_1
        .mul_add(phi_dot_0, phi_dot_1 * w_inner_frame_in_rotor_frame_2_of_psi_dot_0);
    let theta_dot_phi_dot_1 = phi_dot_1.mul_add(theta_dot_0, theta_dot_1 * phi_dot_0);
    let w_inner_frame_in_rotor_frame_1_2_of_motion_2_1 = -theta_dot_phi_dot_1
        + w_outer_frame_in_inner_frame_2_2_of_motion_1;
    let w_inner_frame_in_rotor_frame_1_2_of_motion_3_1 = w_inner_frame_in_rotor_frame_1_2_of_motion_2_1
        .mul_add(sin_phi_0, sin_phi_1 * w_inner_frame_in_rotor_frame_1_2_of_motion_2_0);
    let w_inner_frame_in_rotor_frame_2_2_of_motion_1 = w_inner_frame_in_rotor_frame_1_of_psi_dot_1
        .mul_add(phi_dot_0, phi_dot_1 * w_inner_frame_in_rotor_frame_1_of_psi_dot_0);
    let w_inner_frame_in_rotor_frame_2_2_of_motion_2_1 = w_inner_frame_in_rotor_frame_1_2_of_motion_2_1
        .mul_add(cos_phi_0, cos_phi_1 * w_inner_frame_in_rotor_frame_1_2_of_motion_2_0);
    let p_w_outer_frame_in_inner_frame_2_2_of_motion_1 = w_inner_frame_in_rotor_frame_1_of_theta_dot_1
        .mul_add(phi_dot_0, phi_dot_1 * w_inner_frame_in_rotor_frame_1_of_theta_dot_0);
    let p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_1 = p_w_outer_frame_in_inner_frame_2_2_of_motion_1
        .mul_add(
            minus_b,
            w_inner_frame_in_rotor_frame_2_2_of_motion_2_1
                .mul_add(minus_b, B * w_inner_frame_in_rotor_frame_2_2_of_motion_1),
        );
    let p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_2_1 = p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_1
        .mul_add(cos_phi_0, cos_phi_1 * p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_0);
    let p_w_outer_frame_in_inner_frame_2_2_of_motion_2_1 = w_inner_frame_in_rotor_frame_2_of_theta_dot_1
        .mul_add(phi_dot_0, phi_dot_1 * w_inner_frame_in_rotor_frame_2_of_theta_dot_0);
    let p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_1 = p_w_outer_frame_in_inner_frame_2_2_of_motion_2_1
        .mul_add(
            minus_b,
            w_inner_frame_in_rotor_frame_1_2_of_motion_3_1
                .mul_add(minus_b, minus_b * w_inner_frame_in_rotor_frame_1_2_of_motion_1),
        );
    let p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_4_1 = p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_1
        .mul_add(
            sin_phi_0,
            sin_phi_1 * p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_0,
        );
    let sin_theta_sin_phi_1 = sin_phi_1.mul_add(sin_theta_0, sin_theta_1 * sin_phi_0);
    let sin_theta_cos_phi_1 = cos_phi_1.mul_add(sin_theta_0, sin_theta_1 * cos_phi_0);
    let sin_theta_cos_phi_sq_1 = sin_theta_cos_phi_1
        .mul_add(cos_phi_0, cos_phi_1 * sin_theta_cos_phi_0);
    let sin_theta_sin_phi_sq_1 = sin_theta_sin_phi_1
        .mul_add(sin_phi_0, sin_phi_1 * sin_theta_sin_phi_0);
    let p_w_outer_frame_in_inner_frame_2_4_of_place_1 = sin_theta_sin_phi_sq_1
        .mul_add(B, sin_theta_cos_phi_sq_1.mul_add(B, Ay * sin_theta_1));
    let sin_phi_cos_phi_1 = sin_phi_1.mul_add(cos_phi_0, cos_phi_1 * sin_phi_0);
    let sin_phi_cos_phi_2_1 = cos_phi_1.mul_add(sin_phi_0, sin_phi_1 * cos_phi_0);
    let p_w_outer_frame_in_inner_frame_2_5_of_place_1 = sin_phi_cos_phi_2_1
        .mul_add(minus_b, B * sin_phi_cos_phi_1);
    let s2_of_place_1 = p_w_outer_frame_in_inner_frame_2_4_of_place_1
        .mul_add(
            sin_theta_0,
            sin_theta_1 * p_w_outer_frame_in_inner_frame_2_4_of_place_0,
        );
    let s2_of_place_2_1 = Az * cos_theta_1;
    let s2_of_place_3_1 = s2_of_place_2_1
        .mul_add(cos_theta_0, cos_theta_1 * s2_of_place_2_0);
    let s2_of_place_4_1 = s2_of_place_3_1 + s2_of_place_1;
    let r3_of_theta_dot_1 = w_inner_frame_in_rotor_frame_2_of_theta_dot_1
        .mul_add(
            w_inner_frame_in_rotor_frame_1_of_theta_dot_0,
            w_inner_frame_in_rotor_frame_1_of_theta_dot_1
                * w_inner_frame_in_rotor_frame_2_of_theta_dot_0,
        );
    let r3_of_theta_dot_2_1 = w_inner_frame_in_rotor_frame_1_of_theta_dot_1
        .mul_add(
            w_inner_frame_in_rotor_frame_2_of_theta_dot_0,
            w_inner_frame_in_rotor_frame_2_of_theta_dot_1
                * w_inner_frame_in_rotor_frame_1_of_theta_dot_0,
        );
    let r3_of_theta_dot_3_1 = r3_of_theta_dot_2_1
        .mul_add(
            minus_b,
            r3_of_theta_dot_1
                .mul_add(B, C * w_outer_frame_in_inner_frame_3_2_of_motion_1),
        );
    let r3_of_theta_dot_4_1 = r3_of_theta_dot_3_1
        .mul_add(cos_theta_0, cos_theta_1 * r3_of_theta_dot_3_0);
    let r3_of_theta_dot_5_1 = p_w_outer_frame_in_inner_frame_2_of_place_1
        .mul_add(theta_dot_0, theta_dot_1 * p_w_outer_frame_in_inner_frame_2_of_place_0);
    let r3_of_theta_dot_6_1 = az_plus_c * w_outer_frame_in_inner_frame_3_2_of_motion_1
        - r3_of_theta_dot_5_1;
    let r3_of_theta_dot_7_1 = r3_of_theta_dot_6_1
        .mul_add(cos_theta_0, cos_theta_1 * r3_of_theta_dot_6_0);
    let r3_of_theta_dot_8_1 = h_inner_3_plus_h_rotor_3_1
        .mul_add(theta_dot_0, theta_dot_1 * h_inner_3_plus_h_rotor_3_0);
    let r3_of_theta_dot_9_1 = Ay * w_outer_frame_in_inner_frame_2_2_of_motion_1
        - r3_of_theta_dot_8_1 - p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_2_1
        - p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_4_1;
    let r3_of_theta_dot_10_1 = r3_of_theta_dot_9_1
        .mul_add(sin_theta_0, sin_theta_1 * r3_of_theta_dot_9_0);
    let r3_of_theta_dot_11_1 = -r3_of_theta_dot_4_1 + r3_of_theta_dot_7_1 - r3_of_theta_dot_10_1;
    let l4_of_place_1 = p_w_outer_frame_in_inner_frame_2_5_of_place_1
        .mul_add(
            sin_theta_0,
            sin_theta_1 * p_w_outer_frame_in_inner_frame_2_5_of_place_0,
        );
    let l4_of_place_2_1 = s2_of_place_4_1
        .mul_add(
            -(l4_of_place_2_0 * over_s2_of_place_4),
            l4_of_place_1 * over_s2_of_place_4,
        );
    let sin_phi_sq_1 = sin_phi_1 * (sin_phi_0 + sin_phi_0);
    let cos_phi_sq_1 = cos_phi_1 * (cos_phi_0 + cos_phi_0);
    let s5_of_place_1 = l4_of_place_2_1
        .mul_add(l4_of_place_0, l4_of_place_1 * l4_of_place_2_0);
    let s5_of_place_2_1 = cos_phi_sq_1.mul_add(B, B * sin_phi_sq_1) - s5_of_place_1;
    let r6_of_place_1 = h_inner_3_plus_h_rotor_3_1
        .mul_add(sin_theta_0, sin_theta_1 * h_inner_3_plus_h_rotor_3_0);
    let r6_of_place_2_1 = p_w_outer_frame_in_inner_frame_2_of_place_1
        .mul_add(cos_theta_0, cos_theta_1 * p_w_outer_frame_in_inner_frame_2_of_place_0);
    let r6_of_place_3_1 = r6_of_place_1 - r6_of_place_2_1;
    let r6_of_psi_dot_1 = r6_of_place_3_1
        .mul_add(psi_dot_0, psi_dot_1 * r6_of_place_3_0);
    let r6_of_theta_dot_1 = r3_of_theta_dot_11_1
        .mul_add(l4_of_place_2_0, l4_of_place_2_1 * r3_of_theta_dot_11_0);
    let r6_of_phi_dot_1 = p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_1
        .mul_add(
            cos_phi_0,
            cos_phi_1 * p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_0,
        );
    let r6_of_phi_dot_2_1 = p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_1
        .mul_add(sin_phi_0, sin_phi_1 * p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_0);
    let r6_of_motion_1 = r6_of_phi_dot_1 - r6_of_phi_dot_2_1 - r6_of_psi_dot_1 + r6_of_theta_dot_1;
    let theta_dot_dot_1 = s5_of_place_2_1
        .mul_add(
            -(theta_dot_dot_0 * over_s5_of_place_2),
            r6_of_motion_1 * over_s5_of_place_2,
        );
    let psi_ddot_of_motion_1 = theta_dot_dot_1
        .mul_add(l4_of_place_0, l4_of_place_1 * theta_dot_dot_0);
    let psi_ddot_of_theta_ddot_1 = r3_of_theta_dot_11_1 + psi_ddot_of_motion_1;
    let psi_dot_dot_1 = s2_of_place_4_1
        .mul_add(
            -(psi_dot_dot_0 * over_s2_of_place_4),
            psi_ddot_of_theta_ddot_1 * over_s2_of_place_4,
        );
    let phi_ddot_of_theta_ddot_1 = psi_dot_dot_1
        .mul_add(cos_theta_0, cos_theta_1 * psi_dot_dot_0);
    let phi_dot_dot_1 = r3_of_theta_dot_2_1
        .mul_add(
            minus_b_by_c,
            r3_of_theta_dot_1
                .mul_add(b_by_c, w_outer_frame_in_inner_frame_3_2_of_motion_1),
        ) - phi_ddot_of_theta_ddot_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                theta_1, theta_1, psi_dot_1, psi_dot_1, phi_1, phi_1, theta_dot_1, sin_phi_1,
                theta_dot_1, cos_phi_1, cos_phi_1, sin_phi_1, theta_dot_1, theta_dot_1, phi_dot_1,
                theta_dot_1, sin_phi_1, phi_dot_1, cos_phi_1, phi_dot_1, cos_phi_1, phi_dot_1,
                sin_phi_1, sin_theta_1, sin_theta_1, cos_phi_1, sin_phi_1, cos_phi_1, sin_phi_1,
                sin_theta_1, cos_theta_1, w_inner_frame_in_rotor_frame_1_of_theta_dot_1,
                w_inner_frame_in_rotor_frame_2_of_theta_dot_1, r3_of_theta_dot_3_1, theta_dot_1,
                cos_theta_1, theta_dot_1, sin_theta_1, sin_theta_1, s2_of_place_4_1, sin_phi_1,
                cos_phi_1, l4_of_place_2_1, sin_theta_1, cos_theta_1, psi_dot_1,
                r3_of_theta_dot_11_1, cos_phi_1, sin_phi_1, s5_of_place_2_1, theta_dot_dot_1,
                s2_of_place_4_1, psi_dot_dot_1,
            ]),
            padded([
                cos_theta_1, sin_theta_1, sin_theta_1, cos_theta_1, cos_phi_1, sin_phi_1, cos_phi_1,
                psi_dot_sin_theta_1, sin_phi_1, psi_dot_sin_theta_1,
                w_inner_frame_in_rotor_frame_2_of_theta_dot_1,
                w_inner_frame_in_rotor_frame_1_of_theta_dot_1, psi_dot_cos_theta_1,
                psi_dot_sin_theta_1, w_inner_frame_in_rotor_frame_2_of_psi_dot_1, phi_dot_1,
                w_inner_frame_in_rotor_frame_1_2_of_motion_2_1,
                w_inner_frame_in_rotor_frame_1_of_psi_dot_1,
                w_inner_frame_in_rotor_frame_1_2_of_motion_2_1,
                w_inner_frame_in_rotor_frame_1_of_theta_dot_1,
                p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_1,
                w_inner_frame_in_rotor_frame_2_of_theta_dot_1,
                p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_1, sin_phi_1, cos_phi_1,
                sin_theta_cos_phi_1, sin_theta_sin_phi_1, sin_phi_1, cos_phi_1,
                p_w_outer_frame_in_inner_frame_2_4_of_place_1, s2_of_place_2_1,
                w_inner_frame_in_rotor_frame_2_of_theta_dot_1,
                w_inner_frame_in_rotor_frame_1_of_theta_dot_1, cos_theta_1,
                p_w_outer_frame_in_inner_frame_2_of_place_1, r3_of_theta_dot_6_1,
                h_inner_3_plus_h_rotor_3_1, r3_of_theta_dot_9_1,
                p_w_outer_frame_in_inner_frame_2_5_of_place_1, l4_of_place_2_1, sin_phi_1,
                cos_phi_1, l4_of_place_1, h_inner_3_plus_h_rotor_3_1,
                p_w_outer_frame_in_inner_frame_2_of_place_1, r6_of_place_3_1, l4_of_place_2_1,
                p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_1,
                p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_1, theta_dot_dot_1, l4_of_place_1,
                psi_dot_dot_1, cos_theta_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta_last = theta_1;
    let mut phi_last = phi_1;
    let mut psi_dot_last = psi_dot_1;
    let mut theta_dot_last = theta_dot_1;
    let mut phi_dot_last = phi_dot_1;
    let mut sin_theta_last = sin_theta_1;
    let mut cos_theta_last = cos_theta_1;
    let mut psi_dot_sin_theta_last = psi_dot_sin_theta_1;
    let mut psi_dot_cos_theta_last = psi_dot_cos_theta_1;
    let mut sin_phi_last = sin_phi_1;
    let mut cos_phi_last = cos_phi_1;
    let mut w_inner_frame_in_rotor_frame_1_of_psi_dot_last = w_inner_frame_in_rotor_frame_1_of_psi_dot_1;
    let mut w_inner_frame_in_rotor_frame_1_of_theta_dot_last = w_inner_frame_in_rotor_frame_1_of_theta_dot_1;
    let mut w_inner_frame_in_rotor_frame_2_of_psi_dot_last = w_inner_frame_in_rotor_frame_2_of_psi_dot_1;
    let mut w_inner_frame_in_rotor_frame_2_of_theta_dot_last = w_inner_frame_in_rotor_frame_2_of_theta_dot_1;
    let mut h_inner_3_plus_h_rotor_3_last = h_inner_3_plus_h_rotor_3_1;
    let mut p_w_outer_frame_in_inner_frame_2_of_place_last = p_w_outer_frame_in_inner_frame_2_of_place_1;
    let mut w_inner_frame_in_rotor_frame_1_2_of_motion_2_last = w_inner_frame_in_rotor_frame_1_2_of_motion_2_1;
    let mut p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_last = p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_1;
    let mut p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_last = p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_1;
    let mut sin_theta_sin_phi_last = sin_theta_sin_phi_1;
    let mut sin_theta_cos_phi_last = sin_theta_cos_phi_1;
    let mut p_w_outer_frame_in_inner_frame_2_4_of_place_last = p_w_outer_frame_in_inner_frame_2_4_of_place_1;
    let mut p_w_outer_frame_in_inner_frame_2_5_of_place_last = p_w_outer_frame_in_inner_frame_2_5_of_place_1;
    let mut s2_of_place_2_last = s2_of_place_2_1;
    let mut s2_of_place_4_last = s2_of_place_4_1;
    let mut r3_of_theta_dot_3_last = r3_of_theta_dot_3_1;
    let mut r3_of_theta_dot_6_last = r3_of_theta_dot_6_1;
    let mut r3_of_theta_dot_9_last = r3_of_theta_dot_9_1;
    let mut r3_of_theta_dot_11_last = r3_of_theta_dot_11_1;
    let mut l4_of_place_last = l4_of_place_1;
    let mut l4_of_place_2_last = l4_of_place_2_1;
    let mut s5_of_place_2_last = s5_of_place_2_1;
    let mut r6_of_place_3_last = r6_of_place_3_1;
    let mut theta_dot_dot_last = theta_dot_dot_1;
    let mut psi_dot_dot_last = psi_dot_dot_1;
    let mut next = [S::int(0); 56];
    // Rates at order k - 1.
    let mut psi_rate = psi_dot_1;
    let mut theta_rate = theta_dot_1;
    let mut phi_rate = phi_dot_1;
    let mut psi_dot_rate = psi_dot_dot_1;
    let mut theta_dot_rate = theta_dot_dot_1;
    let mut phi_dot_rate = phi_dot_dot_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let psi = psi_rate * over_k;
        let theta = theta_rate * over_k;
        let phi = phi_rate * over_k;
        let psi_dot = psi_dot_rate * over_k;
        let theta_dot = theta_dot_rate * over_k;
        let phi_dot = phi_dot_rate * over_k;
        series[order] = [psi, theta, phi, psi_dot, theta_dot, phi_dot];
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
                psi_dot_1
                    .mul_add(sin_theta_last, psi_dot_last.mul_add(sin_theta_1, next[2])),
                psi_dot_1
                    .mul_add(cos_theta_last, psi_dot_last.mul_add(cos_theta_1, next[3])),
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
                theta_dot_1
                    .mul_add(cos_phi_last, theta_dot_last.mul_add(cos_phi_1, next[6])),
                sin_phi_1
                    .mul_add(
                        psi_dot_sin_theta_last,
                        sin_phi_last.mul_add(psi_dot_sin_theta_1, next[7]),
                    ),
                theta_dot_1
                    .mul_add(sin_phi_last, theta_dot_last.mul_add(sin_phi_1, next[8])),
                cos_phi_1
                    .mul_add(
                        psi_dot_sin_theta_last,
                        cos_phi_last.mul_add(psi_dot_sin_theta_1, next[9]),
                    ),
                cos_phi_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_2_of_theta_dot_last,
                        cos_phi_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_2_of_theta_dot_1, next[10],
                            ),
                    ),
                sin_phi_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_1_of_theta_dot_last,
                        sin_phi_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_1_of_theta_dot_1, next[11],
                            ),
                    ),
                theta_dot_1
                    .mul_add(
                        psi_dot_cos_theta_last,
                        theta_dot_last.mul_add(psi_dot_cos_theta_1, next[12]),
                    ),
                theta_dot_1
                    .mul_add(
                        psi_dot_sin_theta_last,
                        theta_dot_last.mul_add(psi_dot_sin_theta_1, next[13]),
                    ),
                phi_dot_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_2_of_psi_dot_last,
                        phi_dot_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_2_of_psi_dot_1, next[14],
                            ),
                    ),
                theta_dot_1
                    .mul_add(phi_dot_last, theta_dot_last.mul_add(phi_dot_1, next[15])),
                sin_phi_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_1_2_of_motion_2_last,
                        sin_phi_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_1_2_of_motion_2_1, next[16],
                            ),
                    ),
                phi_dot_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_1_of_psi_dot_last,
                        phi_dot_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_1_of_psi_dot_1, next[17],
                            ),
                    ),
                cos_phi_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_1_2_of_motion_2_last,
                        cos_phi_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_1_2_of_motion_2_1, next[18],
                            ),
                    ),
                phi_dot_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_1_of_theta_dot_last,
                        phi_dot_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_1_of_theta_dot_1, next[19],
                            ),
                    ),
                cos_phi_1
                    .mul_add(
                        p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_last,
                        cos_phi_last
                            .mul_add(
                                p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_1, next[20],
                            ),
                    ),
                phi_dot_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_2_of_theta_dot_last,
                        phi_dot_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_2_of_theta_dot_1, next[21],
                            ),
                    ),
                sin_phi_1
                    .mul_add(
                        p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_last,
                        sin_phi_last
                            .mul_add(
                                p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_1, next[22],
                            ),
                    ),
                sin_theta_1
                    .mul_add(sin_phi_last, sin_theta_last.mul_add(sin_phi_1, next[23])),
                sin_theta_1
                    .mul_add(cos_phi_last, sin_theta_last.mul_add(cos_phi_1, next[24])),
                cos_phi_1
                    .mul_add(
                        sin_theta_cos_phi_last,
                        cos_phi_last.mul_add(sin_theta_cos_phi_1, next[25]),
                    ),
                sin_phi_1
                    .mul_add(
                        sin_theta_sin_phi_last,
                        sin_phi_last.mul_add(sin_theta_sin_phi_1, next[26]),
                    ),
                cos_phi_1
                    .mul_add(sin_phi_last, cos_phi_last.mul_add(sin_phi_1, next[27])),
                sin_phi_1
                    .mul_add(cos_phi_last, sin_phi_last.mul_add(cos_phi_1, next[28])),
                sin_theta_1
                    .mul_add(
                        p_w_outer_frame_in_inner_frame_2_4_of_place_last,
                        sin_theta_last
                            .mul_add(
                                p_w_outer_frame_in_inner_frame_2_4_of_place_1, next[29],
                            ),
                    ),
                cos_theta_1
                    .mul_add(
                        s2_of_place_2_last,
                        cos_theta_last.mul_add(s2_of_place_2_1, next[30]),
                    ),
                w_inner_frame_in_rotor_frame_1_of_theta_dot_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_2_of_theta_dot_last,
                        w_inner_frame_in_rotor_frame_1_of_theta_dot_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_2_of_theta_dot_1, next[31],
                            ),
                    ),
                w_inner_frame_in_rotor_frame_2_of_theta_dot_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_1_of_theta_dot_last,
                        w_inner_frame_in_rotor_frame_2_of_theta_dot_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_1_of_theta_dot_1, next[32],
                            ),
                    ),
                r3_of_theta_dot_3_1
                    .mul_add(
                        cos_theta_last,
                        r3_of_theta_dot_3_last.mul_add(cos_theta_1, next[33]),
                    ),
                theta_dot_1
                    .mul_add(
                        p_w_outer_frame_in_inner_frame_2_of_place_last,
                        theta_dot_last
                            .mul_add(
                                p_w_outer_frame_in_inner_frame_2_of_place_1, next[34],
                            ),
                    ),
                cos_theta_1
                    .mul_add(
                        r3_of_theta_dot_6_last,
                        cos_theta_last.mul_add(r3_of_theta_dot_6_1, next[35]),
                    ),
                theta_dot_1
                    .mul_add(
                        h_inner_3_plus_h_rotor_3_last,
                        theta_dot_last.mul_add(h_inner_3_plus_h_rotor_3_1, next[36]),
                    ),
                sin_theta_1
                    .mul_add(
                        r3_of_theta_dot_9_last,
                        sin_theta_last.mul_add(r3_of_theta_dot_9_1, next[37]),
                    ),
                sin_theta_1
                    .mul_add(
                        p_w_outer_frame_in_inner_frame_2_5_of_place_last,
                        sin_theta_last
                            .mul_add(
                                p_w_outer_frame_in_inner_frame_2_5_of_place_1, next[38],
                            ),
                    ),
                s2_of_place_4_1
                    .mul_add(
                        l4_of_place_2_last,
                        s2_of_place_4_last.mul_add(l4_of_place_2_1, next[39]),
                    ),
                (sin_phi_1 + sin_phi_1).mul_add(sin_phi_last, next[40]),
                (cos_phi_1 + cos_phi_1).mul_add(cos_phi_last, next[41]),
                l4_of_place_2_1
                    .mul_add(
                        l4_of_place_last,
                        l4_of_place_2_last.mul_add(l4_of_place_1, next[42]),
                    ),
                sin_theta_1
                    .mul_add(
                        h_inner_3_plus_h_rotor_3_last,
                        sin_theta_last.mul_add(h_inner_3_plus_h_rotor_3_1, next[43]),
                    ),
                cos_theta_1
                    .mul_add(
                        p_w_outer_frame_in_inner_frame_2_of_place_last,
                        cos_theta_last
                            .mul_add(
                                p_w_outer_frame_in_inner_frame_2_of_place_1, next[44],
                            ),
                    ),
                psi_dot_1
                    .mul_add(
                        r6_of_place_3_last,
                        psi_dot_last.mul_add(r6_of_place_3_1, next[45]),
                    ),
                r3_of_theta_dot_11_1
                    .mul_add(
                        l4_of_place_2_last,
                        r3_of_theta_dot_11_last.mul_add(l4_of_place_2_1, next[46]),
                    ),
                cos_phi_1
                    .mul_add(
                        p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_last,
                        cos_phi_last
                            .mul_add(
                                p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_1, next[47],
                            ),
                    ),
                sin_phi_1
                    .mul_add(
                        p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_last,
                        sin_phi_last
                            .mul_add(
                                p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_1, next[48],
                            ),
                    ),
                s5_of_place_2_1
                    .mul_add(
                        theta_dot_dot_last,
                        s5_of_place_2_last.mul_add(theta_dot_dot_1, next[49]),
                    ),
                theta_dot_dot_1
                    .mul_add(
                        l4_of_place_last,
                        theta_dot_dot_last.mul_add(l4_of_place_1, next[50]),
                    ),
                s2_of_place_4_1
                    .mul_add(
                        psi_dot_dot_last,
                        s2_of_place_4_last.mul_add(psi_dot_dot_1, next[51]),
                    ),
                psi_dot_dot_1
                    .mul_add(
                        cos_theta_last,
                        psi_dot_dot_last.mul_add(cos_theta_1, next[52]),
                    ),
            ])
        };
        // sin_theta = sin(theta)
        let sin_theta = theta.mul_add(cos_theta_0, sums[0] * over_k);
        // cos_theta = cos(theta)
        let cos_theta = -theta.mul_add(sin_theta_0, sums[1] * over_k);
        // psi_dot_sin_theta = psi_dot*sin_theta
        let psi_dot_sin_theta = sin_theta
            .mul_add(psi_dot_0, psi_dot.mul_add(sin_theta_0, sums[2]));
        // psi_dot_cos_theta = psi_dot*cos_theta
        let psi_dot_cos_theta = cos_theta
            .mul_add(psi_dot_0, psi_dot.mul_add(cos_theta_0, sums[3]));
        // sin_phi = sin(phi)
        let sin_phi = phi.mul_add(cos_phi_0, sums[4] * over_k);
        // cos_phi = cos(phi)
        let cos_phi = -phi.mul_add(sin_phi_0, sums[5] * over_k);
        // theta_dot_cos_phi = theta_dot*cos_phi
        let theta_dot_cos_phi = cos_phi
            .mul_add(theta_dot_0, theta_dot.mul_add(cos_phi_0, sums[6]));
        // w_inner_frame_in_rotor_frame_1_of_psi_dot = sin_phi*psi_dot_sin_theta
        let w_inner_frame_in_rotor_frame_1_of_psi_dot = psi_dot_sin_theta
            .mul_add(sin_phi_0, sin_phi.mul_add(psi_dot_sin_theta_0, sums[7]));
        // w_inner_frame_in_rotor_frame_1_of_theta_dot = theta_dot_cos_phi +
        //   w_inner_frame_in_rotor_frame_1_of_psi_dot
        let w_inner_frame_in_rotor_frame_1_of_theta_dot = theta_dot_cos_phi
            + w_inner_frame_in_rotor_frame_1_of_psi_dot;
        // theta_dot_sin_phi = theta_dot*sin_phi
        let theta_dot_sin_phi = sin_phi
            .mul_add(theta_dot_0, theta_dot.mul_add(sin_phi_0, sums[8]));
        // w_inner_frame_in_rotor_frame_2_of_psi_dot = cos_phi*psi_dot_sin_theta
        let w_inner_frame_in_rotor_frame_2_of_psi_dot = psi_dot_sin_theta
            .mul_add(cos_phi_0, cos_phi.mul_add(psi_dot_sin_theta_0, sums[9]));
        // w_inner_frame_in_rotor_frame_2_of_theta_dot = theta_dot_sin_phi -
        //   w_inner_frame_in_rotor_frame_2_of_psi_dot
        let w_inner_frame_in_rotor_frame_2_of_theta_dot = theta_dot_sin_phi
            - w_inner_frame_in_rotor_frame_2_of_psi_dot;
        // h_inner_3_plus_h_rotor_3 = az_plus_c*psi_dot_cos_theta + C*phi_dot
        let h_inner_3_plus_h_rotor_3 = psi_dot_cos_theta.mul_add(az_plus_c, C * phi_dot);
        // p_w_outer_frame_in_inner_frame_2_of_theta_dot =
        //   cos_phi*w_inner_frame_in_rotor_frame_2_of_theta_dot
        let p_w_outer_frame_in_inner_frame_2_of_theta_dot = w_inner_frame_in_rotor_frame_2_of_theta_dot
            .mul_add(
                cos_phi_0,
                cos_phi.mul_add(w_inner_frame_in_rotor_frame_2_of_theta_dot_0, sums[10]),
            );
        // p_w_outer_frame_in_inner_frame_2_of_theta_dot_2 =
        //   sin_phi*w_inner_frame_in_rotor_frame_1_of_theta_dot
        let p_w_outer_frame_in_inner_frame_2_of_theta_dot_2 = w_inner_frame_in_rotor_frame_1_of_theta_dot
            .mul_add(
                sin_phi_0,
                sin_phi.mul_add(w_inner_frame_in_rotor_frame_1_of_theta_dot_0, sums[11]),
            );
        // p_w_outer_frame_in_inner_frame_2_of_place = Ay*psi_dot_sin_theta +
        //   minus_b*p_w_outer_frame_in_inner_frame_2_of_theta_dot +
        //   B*p_w_outer_frame_in_inner_frame_2_of_theta_dot_2
        let p_w_outer_frame_in_inner_frame_2_of_place = p_w_outer_frame_in_inner_frame_2_of_theta_dot_2
            .mul_add(
                B,
                p_w_outer_frame_in_inner_frame_2_of_theta_dot
                    .mul_add(minus_b, Ay * psi_dot_sin_theta),
            );
        // w_outer_frame_in_inner_frame_2_2_of_motion = theta_dot*psi_dot_cos_theta
        let w_outer_frame_in_inner_frame_2_2_of_motion = psi_dot_cos_theta
            .mul_add(theta_dot_0, theta_dot.mul_add(psi_dot_cos_theta_0, sums[12]));
        // w_outer_frame_in_inner_frame_3_2_of_motion = theta_dot*psi_dot_sin_theta
        let w_outer_frame_in_inner_frame_3_2_of_motion = psi_dot_sin_theta
            .mul_add(theta_dot_0, theta_dot.mul_add(psi_dot_sin_theta_0, sums[13]));
        // w_inner_frame_in_rotor_frame_1_2_of_motion = phi_dot*w_inner_frame_in_rotor_frame_2_of_psi_dot
        let w_inner_frame_in_rotor_frame_1_2_of_motion = w_inner_frame_in_rotor_frame_2_of_psi_dot
            .mul_add(
                phi_dot_0,
                phi_dot.mul_add(w_inner_frame_in_rotor_frame_2_of_psi_dot_0, sums[14]),
            );
        // theta_dot_phi_dot = theta_dot*phi_dot
        let theta_dot_phi_dot = phi_dot
            .mul_add(theta_dot_0, theta_dot.mul_add(phi_dot_0, sums[15]));
        // w_inner_frame_in_rotor_frame_1_2_of_motion_2 = w_outer_frame_in_inner_frame_2_2_of_motion -
        //   theta_dot_phi_dot
        let w_inner_frame_in_rotor_frame_1_2_of_motion_2 = -theta_dot_phi_dot
            + w_outer_frame_in_inner_frame_2_2_of_motion;
        // w_inner_frame_in_rotor_frame_1_2_of_motion_3 =
        //   sin_phi*w_inner_frame_in_rotor_frame_1_2_of_motion_2
        let w_inner_frame_in_rotor_frame_1_2_of_motion_3 = w_inner_frame_in_rotor_frame_1_2_of_motion_2
            .mul_add(
                sin_phi_0,
                sin_phi.mul_add(w_inner_frame_in_rotor_frame_1_2_of_motion_2_0, sums[16]),
            );
        // w_inner_frame_in_rotor_frame_2_2_of_motion = phi_dot*w_inner_frame_in_rotor_frame_1_of_psi_dot
        let w_inner_frame_in_rotor_frame_2_2_of_motion = w_inner_frame_in_rotor_frame_1_of_psi_dot
            .mul_add(
                phi_dot_0,
                phi_dot.mul_add(w_inner_frame_in_rotor_frame_1_of_psi_dot_0, sums[17]),
            );
        // w_inner_frame_in_rotor_frame_2_2_of_motion_2 =
        //   cos_phi*w_inner_frame_in_rotor_frame_1_2_of_motion_2
        let w_inner_frame_in_rotor_frame_2_2_of_motion_2 = w_inner_frame_in_rotor_frame_1_2_of_motion_2
            .mul_add(
                cos_phi_0,
                cos_phi.mul_add(w_inner_frame_in_rotor_frame_1_2_of_motion_2_0, sums[18]),
            );
        // p_w_outer_frame_in_inner_frame_2_2_of_motion =
        //   phi_dot*w_inner_frame_in_rotor_frame_1_of_theta_dot
        let p_w_outer_frame_in_inner_frame_2_2_of_motion = w_inner_frame_in_rotor_frame_1_of_theta_dot
            .mul_add(
                phi_dot_0,
                phi_dot.mul_add(w_inner_frame_in_rotor_frame_1_of_theta_dot_0, sums[19]),
            );
        // p_w_outer_frame_in_inner_frame_2_2_of_phi_dot = B*w_inner_frame_in_rotor_frame_2_2_of_motion +
        //   minus_b*w_inner_frame_in_rotor_frame_2_2_of_motion_2 +
        //   minus_b*p_w_outer_frame_in_inner_frame_2_2_of_motion
        let p_w_outer_frame_in_inner_frame_2_2_of_phi_dot = p_w_outer_frame_in_inner_frame_2_2_of_motion
            .mul_add(
                minus_b,
                w_inner_frame_in_rotor_frame_2_2_of_motion_2
                    .mul_add(minus_b, B * w_inner_frame_in_rotor_frame_2_2_of_motion),
            );
        // p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_2 =
        //   cos_phi*p_w_outer_frame_in_inner_frame_2_2_of_phi_dot
        let p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_2 = p_w_outer_frame_in_inner_frame_2_2_of_phi_dot
            .mul_add(
                cos_phi_0,
                cos_phi
                    .mul_add(p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_0, sums[20]),
            );
        // p_w_outer_frame_in_inner_frame_2_2_of_motion_2 =
        //   phi_dot*w_inner_frame_in_rotor_frame_2_of_theta_dot
        let p_w_outer_frame_in_inner_frame_2_2_of_motion_2 = w_inner_frame_in_rotor_frame_2_of_theta_dot
            .mul_add(
                phi_dot_0,
                phi_dot.mul_add(w_inner_frame_in_rotor_frame_2_of_theta_dot_0, sums[21]),
            );
        // p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3 =
        //   minus_b*w_inner_frame_in_rotor_frame_1_2_of_motion +
        //   minus_b*w_inner_frame_in_rotor_frame_1_2_of_motion_3 +
        //   minus_b*p_w_outer_frame_in_inner_frame_2_2_of_motion_2
        let p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3 = p_w_outer_frame_in_inner_frame_2_2_of_motion_2
            .mul_add(
                minus_b,
                w_inner_frame_in_rotor_frame_1_2_of_motion_3
                    .mul_add(
                        minus_b,
                        minus_b * w_inner_frame_in_rotor_frame_1_2_of_motion,
                    ),
            );
        // p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_4 =
        //   sin_phi*p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3
        let p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_4 = p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3
            .mul_add(
                sin_phi_0,
                sin_phi
                    .mul_add(p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_0, sums[22]),
            );
        // sin_theta_sin_phi = sin_theta*sin_phi
        let sin_theta_sin_phi = sin_phi
            .mul_add(sin_theta_0, sin_theta.mul_add(sin_phi_0, sums[23]));
        // sin_theta_cos_phi = sin_theta*cos_phi
        let sin_theta_cos_phi = cos_phi
            .mul_add(sin_theta_0, sin_theta.mul_add(cos_phi_0, sums[24]));
        // sin_theta_cos_phi_sq = cos_phi*sin_theta_cos_phi
        let sin_theta_cos_phi_sq = sin_theta_cos_phi
            .mul_add(cos_phi_0, cos_phi.mul_add(sin_theta_cos_phi_0, sums[25]));
        // sin_theta_sin_phi_sq = sin_phi*sin_theta_sin_phi
        let sin_theta_sin_phi_sq = sin_theta_sin_phi
            .mul_add(sin_phi_0, sin_phi.mul_add(sin_theta_sin_phi_0, sums[26]));
        // p_w_outer_frame_in_inner_frame_2_4_of_place = Ay*sin_theta + B*sin_theta_cos_phi_sq +
        //   B*sin_theta_sin_phi_sq
        let p_w_outer_frame_in_inner_frame_2_4_of_place = sin_theta_sin_phi_sq
            .mul_add(B, sin_theta_cos_phi_sq.mul_add(B, Ay * sin_theta));
        // sin_phi_cos_phi = cos_phi*sin_phi
        let sin_phi_cos_phi = sin_phi
            .mul_add(cos_phi_0, cos_phi.mul_add(sin_phi_0, sums[27]));
        // sin_phi_cos_phi_2 = sin_phi*cos_phi
        let sin_phi_cos_phi_2 = cos_phi
            .mul_add(sin_phi_0, sin_phi.mul_add(cos_phi_0, sums[28]));
        // p_w_outer_frame_in_inner_frame_2_5_of_place = B*sin_phi_cos_phi + minus_b*sin_phi_cos_phi_2
        let p_w_outer_frame_in_inner_frame_2_5_of_place = sin_phi_cos_phi_2
            .mul_add(minus_b, B * sin_phi_cos_phi);
        // s2_of_place = sin_theta*p_w_outer_frame_in_inner_frame_2_4_of_place
        let s2_of_place = p_w_outer_frame_in_inner_frame_2_4_of_place
            .mul_add(
                sin_theta_0,
                sin_theta
                    .mul_add(p_w_outer_frame_in_inner_frame_2_4_of_place_0, sums[29]),
            );
        // s2_of_place_2 = Az*cos_theta
        let s2_of_place_2 = Az * cos_theta;
        // s2_of_place_3 = cos_theta*s2_of_place_2
        let s2_of_place_3 = s2_of_place_2
            .mul_add(cos_theta_0, cos_theta.mul_add(s2_of_place_2_0, sums[30]));
        // s2_of_place_4 = Iz + s2_of_place + s2_of_place_3
        let s2_of_place_4 = s2_of_place_3 + s2_of_place;
        // r3_of_theta_dot =
        //   w_inner_frame_in_rotor_frame_1_of_theta_dot*w_inner_frame_in_rotor_frame_2_of_theta_dot
        let r3_of_theta_dot = w_inner_frame_in_rotor_frame_2_of_theta_dot
            .mul_add(
                w_inner_frame_in_rotor_frame_1_of_theta_dot_0,
                w_inner_frame_in_rotor_frame_1_of_theta_dot
                    .mul_add(w_inner_frame_in_rotor_frame_2_of_theta_dot_0, sums[31]),
            );
        // r3_of_theta_dot_2 =
        //   w_inner_frame_in_rotor_frame_2_of_theta_dot*w_inner_frame_in_rotor_frame_1_of_theta_dot
        let r3_of_theta_dot_2 = w_inner_frame_in_rotor_frame_1_of_theta_dot
            .mul_add(
                w_inner_frame_in_rotor_frame_2_of_theta_dot_0,
                w_inner_frame_in_rotor_frame_2_of_theta_dot
                    .mul_add(w_inner_frame_in_rotor_frame_1_of_theta_dot_0, sums[32]),
            );
        // r3_of_theta_dot_3 = C*w_outer_frame_in_inner_frame_3_2_of_motion + B*r3_of_theta_dot +
        //   minus_b*r3_of_theta_dot_2
        let r3_of_theta_dot_3 = r3_of_theta_dot_2
            .mul_add(
                minus_b,
                r3_of_theta_dot
                    .mul_add(B, C * w_outer_frame_in_inner_frame_3_2_of_motion),
            );
        // r3_of_theta_dot_4 = r3_of_theta_dot_3*cos_theta
        let r3_of_theta_dot_4 = r3_of_theta_dot_3
            .mul_add(cos_theta_0, cos_theta.mul_add(r3_of_theta_dot_3_0, sums[33]));
        // r3_of_theta_dot_5 = theta_dot*p_w_outer_frame_in_inner_frame_2_of_place
        let r3_of_theta_dot_5 = p_w_outer_frame_in_inner_frame_2_of_place
            .mul_add(
                theta_dot_0,
                theta_dot.mul_add(p_w_outer_frame_in_inner_frame_2_of_place_0, sums[34]),
            );
        // r3_of_theta_dot_6 = az_plus_c*w_outer_frame_in_inner_frame_3_2_of_motion - r3_of_theta_dot_5
        let r3_of_theta_dot_6 = az_plus_c * w_outer_frame_in_inner_frame_3_2_of_motion
            - r3_of_theta_dot_5;
        // r3_of_theta_dot_7 = cos_theta*r3_of_theta_dot_6
        let r3_of_theta_dot_7 = r3_of_theta_dot_6
            .mul_add(cos_theta_0, cos_theta.mul_add(r3_of_theta_dot_6_0, sums[35]));
        // r3_of_theta_dot_8 = theta_dot*h_inner_3_plus_h_rotor_3
        let r3_of_theta_dot_8 = h_inner_3_plus_h_rotor_3
            .mul_add(
                theta_dot_0,
                theta_dot.mul_add(h_inner_3_plus_h_rotor_3_0, sums[36]),
            );
        // r3_of_theta_dot_9 = Ay*w_outer_frame_in_inner_frame_2_2_of_motion -
        //   p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_2 -
        //   p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_4 - r3_of_theta_dot_8
        let r3_of_theta_dot_9 = Ay * w_outer_frame_in_inner_frame_2_2_of_motion
            - r3_of_theta_dot_8 - p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_2
            - p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_4;
        // r3_of_theta_dot_10 = sin_theta*r3_of_theta_dot_9
        let r3_of_theta_dot_10 = r3_of_theta_dot_9
            .mul_add(sin_theta_0, sin_theta.mul_add(r3_of_theta_dot_9_0, sums[37]));
        // r3_of_theta_dot_11 = -r3_of_theta_dot_4 + r3_of_theta_dot_7 - r3_of_theta_dot_10
        let r3_of_theta_dot_11 = -r3_of_theta_dot_4 + r3_of_theta_dot_7 - r3_of_theta_dot_10;
        // l4_of_place = sin_theta*p_w_outer_frame_in_inner_frame_2_5_of_place
        let l4_of_place = p_w_outer_frame_in_inner_frame_2_5_of_place
            .mul_add(
                sin_theta_0,
                sin_theta
                    .mul_add(p_w_outer_frame_in_inner_frame_2_5_of_place_0, sums[38]),
            );
        // l4_of_place_2 = l4_of_place/s2_of_place_4
        let l4_of_place_2 = s2_of_place_4
            .mul_add(
                -(l4_of_place_2_0 * over_s2_of_place_4),
                (l4_of_place - sums[39]) * over_s2_of_place_4,
            );
        // sin_phi_sq = sin_phi*sin_phi
        let sin_phi_sq = sin_phi.mul_add(sin_phi_0 + sin_phi_0, sums[40]);
        // cos_phi_sq = cos_phi*cos_phi
        let cos_phi_sq = cos_phi.mul_add(cos_phi_0 + cos_phi_0, sums[41]);
        // s5_of_place = l4_of_place_2*l4_of_place
        let s5_of_place = l4_of_place_2
            .mul_add(l4_of_place_0, l4_of_place.mul_add(l4_of_place_2_0, sums[42]));
        // s5_of_place_2 = Ax + B*sin_phi_sq + B*cos_phi_sq - s5_of_place
        let s5_of_place_2 = cos_phi_sq.mul_add(B, B * sin_phi_sq) - s5_of_place;
        // r6_of_place = sin_theta*h_inner_3_plus_h_rotor_3
        let r6_of_place = h_inner_3_plus_h_rotor_3
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(h_inner_3_plus_h_rotor_3_0, sums[43]),
            );
        // r6_of_place_2 = cos_theta*p_w_outer_frame_in_inner_frame_2_of_place
        let r6_of_place_2 = p_w_outer_frame_in_inner_frame_2_of_place
            .mul_add(
                cos_theta_0,
                cos_theta.mul_add(p_w_outer_frame_in_inner_frame_2_of_place_0, sums[44]),
            );
        // r6_of_place_3 = r6_of_place - r6_of_place_2
        let r6_of_place_3 = r6_of_place - r6_of_place_2;
        // r6_of_psi_dot = psi_dot*r6_of_place_3
        let r6_of_psi_dot = r6_of_place_3
            .mul_add(psi_dot_0, psi_dot.mul_add(r6_of_place_3_0, sums[45]));
        // r6_of_theta_dot = r3_of_theta_dot_11*l4_of_place_2
        let r6_of_theta_dot = r3_of_theta_dot_11
            .mul_add(
                l4_of_place_2_0,
                l4_of_place_2.mul_add(r3_of_theta_dot_11_0, sums[46]),
            );
        // r6_of_phi_dot = cos_phi*p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3
        let r6_of_phi_dot = p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3
            .mul_add(
                cos_phi_0,
                cos_phi
                    .mul_add(p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_0, sums[47]),
            );
        // r6_of_phi_dot_2 = sin_phi*p_w_outer_frame_in_inner_frame_2_2_of_phi_dot
        let r6_of_phi_dot_2 = p_w_outer_frame_in_inner_frame_2_2_of_phi_dot
            .mul_add(
                sin_phi_0,
                sin_phi
                    .mul_add(p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_0, sums[48]),
            );
        // r6_of_motion = -r6_of_psi_dot + r6_of_theta_dot + r6_of_phi_dot - r6_of_phi_dot_2
        let r6_of_motion = r6_of_phi_dot - r6_of_phi_dot_2 - r6_of_psi_dot + r6_of_theta_dot;
        // theta_dot_dot = r6_of_motion/s5_of_place_2
        let theta_dot_dot = r6_of_motion
            .mul_add(
                over_s5_of_place_2,
                -(s5_of_place_2.mul_add(theta_dot_dot_0, sums[49]) * over_s5_of_place_2),
            );
        // psi_ddot_of_motion = theta_dot_dot*l4_of_place
        let psi_ddot_of_motion = theta_dot_dot
            .mul_add(l4_of_place_0, l4_of_place.mul_add(theta_dot_dot_0, sums[50]));
        // psi_ddot_of_theta_ddot = r3_of_theta_dot_11 + psi_ddot_of_motion
        let psi_ddot_of_theta_ddot = r3_of_theta_dot_11 + psi_ddot_of_motion;
        // psi_dot_dot = psi_ddot_of_theta_ddot/s2_of_place_4
        let psi_dot_dot = psi_ddot_of_theta_ddot
            .mul_add(
                over_s2_of_place_4,
                -(s2_of_place_4.mul_add(psi_dot_dot_0, sums[51]) * over_s2_of_place_4),
            );
        // phi_ddot_of_theta_ddot = psi_dot_dot*cos_theta
        let phi_ddot_of_theta_ddot = psi_dot_dot
            .mul_add(cos_theta_0, cos_theta.mul_add(psi_dot_dot_0, sums[52]));
        // phi_dot_dot = -phi_ddot_of_theta_ddot + w_outer_frame_in_inner_frame_3_2_of_motion +
        //   b_by_c*r3_of_theta_dot + minus_b_by_c*r3_of_theta_dot_2
        let phi_dot_dot = r3_of_theta_dot_2
            .mul_add(
                minus_b_by_c,
                r3_of_theta_dot
                    .mul_add(b_by_c, w_outer_frame_in_inner_frame_3_2_of_motion),
            ) - phi_ddot_of_theta_ddot;
        psi_rate = psi_dot;
        theta_rate = theta_dot;
        phi_rate = phi_dot;
        psi_dot_rate = psi_dot_dot;
        theta_dot_rate = theta_dot_dot;
        phi_dot_rate = phi_dot_dot;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * theta,
                count * theta,
                psi_dot, psi_dot,
                count * phi,
                count * phi,
                theta_dot, sin_phi, theta_dot, cos_phi, cos_phi, sin_phi, theta_dot, theta_dot,
                phi_dot, theta_dot, sin_phi, phi_dot, cos_phi, phi_dot, cos_phi, phi_dot, sin_phi,
                sin_theta, sin_theta, cos_phi, sin_phi, cos_phi, sin_phi, sin_theta, cos_theta,
                w_inner_frame_in_rotor_frame_1_of_theta_dot,
                w_inner_frame_in_rotor_frame_2_of_theta_dot, r3_of_theta_dot_3, theta_dot,
                cos_theta, theta_dot, sin_theta, sin_theta, s2_of_place_4, sin_phi, cos_phi,
                l4_of_place_2, sin_theta, cos_theta, psi_dot, r3_of_theta_dot_11, cos_phi, sin_phi,
                s5_of_place_2, theta_dot_dot, s2_of_place_4, psi_dot_dot,
            ]),
            padded([
                cos_theta, sin_theta, sin_theta, cos_theta, cos_phi, sin_phi, cos_phi,
                psi_dot_sin_theta, sin_phi, psi_dot_sin_theta,
                w_inner_frame_in_rotor_frame_2_of_theta_dot,
                w_inner_frame_in_rotor_frame_1_of_theta_dot, psi_dot_cos_theta, psi_dot_sin_theta,
                w_inner_frame_in_rotor_frame_2_of_psi_dot, phi_dot,
                w_inner_frame_in_rotor_frame_1_2_of_motion_2,
                w_inner_frame_in_rotor_frame_1_of_psi_dot,
                w_inner_frame_in_rotor_frame_1_2_of_motion_2,
                w_inner_frame_in_rotor_frame_1_of_theta_dot,
                p_w_outer_frame_in_inner_frame_2_2_of_phi_dot,
                w_inner_frame_in_rotor_frame_2_of_theta_dot,
                p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3, sin_phi, cos_phi,
                sin_theta_cos_phi, sin_theta_sin_phi, sin_phi, cos_phi,
                p_w_outer_frame_in_inner_frame_2_4_of_place, s2_of_place_2,
                w_inner_frame_in_rotor_frame_2_of_theta_dot,
                w_inner_frame_in_rotor_frame_1_of_theta_dot, cos_theta,
                p_w_outer_frame_in_inner_frame_2_of_place, r3_of_theta_dot_6,
                h_inner_3_plus_h_rotor_3, r3_of_theta_dot_9,
                p_w_outer_frame_in_inner_frame_2_5_of_place, l4_of_place_2, sin_phi, cos_phi,
                l4_of_place, h_inner_3_plus_h_rotor_3, p_w_outer_frame_in_inner_frame_2_of_place,
                r6_of_place_3, l4_of_place_2, p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3,
                p_w_outer_frame_in_inner_frame_2_2_of_phi_dot, theta_dot_dot, l4_of_place,
                psi_dot_dot, cos_theta,
            ]),
        ];
        count_last = count;
        theta_last = theta;
        phi_last = phi;
        psi_dot_last = psi_dot;
        theta_dot_last = theta_dot;
        phi_dot_last = phi_dot;
        sin_theta_last = sin_theta;
        cos_theta_last = cos_theta;
        psi_dot_sin_theta_last = psi_dot_sin_theta;
        psi_dot_cos_theta_last = psi_dot_cos_theta;
        sin_phi_last = sin_phi;
        cos_phi_last = cos_phi;
        w_inner_frame_in_rotor_frame_1_of_psi_dot_last = w_inner_frame_in_rotor_frame_1_of_psi_dot;
        w_inner_frame_in_rotor_frame_1_of_theta_dot_last = w_inner_frame_in_rotor_frame_1_of_theta_dot;
        w_inner_frame_in_rotor_frame_2_of_psi_dot_last = w_inner_frame_in_rotor_frame_2_of_psi_dot;
        w_inner_frame_in_rotor_frame_2_of_theta_dot_last = w_inner_frame_in_rotor_frame_2_of_theta_dot;
        h_inner_3_plus_h_rotor_3_last = h_inner_3_plus_h_rotor_3;
        p_w_outer_frame_in_inner_frame_2_of_place_last = p_w_outer_frame_in_inner_frame_2_of_place;
        w_inner_frame_in_rotor_frame_1_2_of_motion_2_last = w_inner_frame_in_rotor_frame_1_2_of_motion_2;
        p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_last = p_w_outer_frame_in_inner_frame_2_2_of_phi_dot;
        p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3_last = p_w_outer_frame_in_inner_frame_2_2_of_phi_dot_3;
        sin_theta_sin_phi_last = sin_theta_sin_phi;
        sin_theta_cos_phi_last = sin_theta_cos_phi;
        p_w_outer_frame_in_inner_frame_2_4_of_place_last = p_w_outer_frame_in_inner_frame_2_4_of_place;
        p_w_outer_frame_in_inner_frame_2_5_of_place_last = p_w_outer_frame_in_inner_frame_2_5_of_place;
        s2_of_place_2_last = s2_of_place_2;
        s2_of_place_4_last = s2_of_place_4;
        r3_of_theta_dot_3_last = r3_of_theta_dot_3;
        r3_of_theta_dot_6_last = r3_of_theta_dot_6;
        r3_of_theta_dot_9_last = r3_of_theta_dot_9;
        r3_of_theta_dot_11_last = r3_of_theta_dot_11;
        l4_of_place_last = l4_of_place;
        l4_of_place_2_last = l4_of_place_2;
        s5_of_place_2_last = s5_of_place_2;
        r6_of_place_3_last = r6_of_place_3;
        theta_dot_dot_last = theta_dot_dot;
        psi_dot_dot_last = psi_dot_dot;
    }
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
        out.copy_from_slice(
            jacobian(&Parameters::from_slice(p), array(q), array(v)).as_flattened(),
        );
    }
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, order: usize) -> usize {
        112 * order + SLACK
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
    slice.try_into().expect("a slice of the length that System states")
}
