//! Gyroscope in gimbals: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/gimbals/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{coordinate_rates, potential_energy};

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows outer moment outer_frame1, outer moment outer_frame2, outer moment outer_frame3, inner moment inner_frame1, inner moment inner_frame2, inner moment inner_frame3, rotor moment rotor_frame1, rotor moment rotor_frame2, rotor moment rotor_frame3.
///
/// 16 operations, 3 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    _u: &[S; 3],
) -> [[S; 9]; 9] {
    let Parameters { Iz, Ax, Ay, Az, B, C, .. } = *p;
    let [psi, theta, phi] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // x_inner_frame_2_2 = Ay*sin(theta)
    let x_inner_frame_2_2 = Ay * sin_theta;
    // x_inner_frame_3_2 = Az*cos(theta)
    let x_inner_frame_3_2 = Az * cos_theta;
    // alpha_inner_frame_in_rotor_frame_1_2 = sin(theta)*sin(phi)
    let alpha_inner_frame_in_rotor_frame_1_2 = sin_theta * sin_phi;
    // x_rotor_frame_1_2 = B*alpha_inner_frame_in_rotor_frame_1_2
    let x_rotor_frame_1_2 = B * alpha_inner_frame_in_rotor_frame_1_2;
    // x_rotor_frame_1_3 = B*cos(phi)
    let x_rotor_frame_1_3 = B * cos_phi;
    // alpha_inner_frame_in_rotor_frame_2_2 = sin(theta)*cos(phi)
    let alpha_inner_frame_in_rotor_frame_2_2 = sin_theta * cos_phi;
    // x_rotor_frame_2_2 = B*alpha_inner_frame_in_rotor_frame_2_2
    let x_rotor_frame_2_2 = B * alpha_inner_frame_in_rotor_frame_2_2;
    // x_rotor_frame_2_3 = B*sin(phi)
    let x_rotor_frame_2_3 = B * sin_phi;
    // x_rotor_frame_3_2 = C*cos(theta)
    let x_rotor_frame_3_2 = C * cos_theta;
    // -cos(psi)
    let minus_cos_psi = -cos_psi;
    // -cos(theta)
    let minus_cos_theta = -cos_theta;
    // -cos(phi)
    let minus_cos_phi = -cos_phi;
    // Entries that are not zero.
    // M18 = -cos(psi)
    let m18 = minus_cos_psi;
    // M19 = -sin(psi)
    let m19 = -sin_psi;
    // M26 = 1
    let m26 = S::int(1);
    // M28 = sin(psi)
    let m28 = sin_psi;
    // M29 = -cos(psi)
    let m29 = minus_cos_psi;
    // M31 = Iz
    let m31 = Iz;
    // M37 = 1
    let m37 = S::int(1);
    // M42 = Ax
    let m42 = Ax;
    // M44 = 1
    let m44 = S::int(1);
    // M55 = 1
    let m55 = S::int(1);
    // M56 = -cos(theta)
    let m56 = minus_cos_theta;
    // M57 = -sin(theta)
    let m57 = -sin_theta;
    // M66 = sin(theta)
    let m66 = sin_theta;
    // M67 = -cos(theta)
    let m67 = minus_cos_theta;
    // M74 = -cos(phi)
    let m74 = minus_cos_phi;
    // M75 = -sin(phi)
    let m75 = -sin_phi;
    // M82 = -x_rotor_frame_2_3
    let m82 = -x_rotor_frame_2_3;
    // M84 = sin(phi)
    let m84 = sin_phi;
    // M85 = -cos(phi)
    let m85 = minus_cos_phi;
    // M93 = C
    let m93 = C;
    let zero = S::int(0);
    [
        [zero, zero, zero, zero, zero, zero, zero, m18, m19],
        [zero, zero, zero, zero, zero, m26, zero, m28, m29],
        [m31, zero, zero, zero, zero, zero, m37, zero, zero],
        [zero, m42, zero, m44, zero, zero, zero, zero, zero],
        [x_inner_frame_2_2, zero, zero, zero, m55, m56, m57, zero, zero],
        [x_inner_frame_3_2, zero, zero, zero, zero, m66, m67, zero, zero],
        [x_rotor_frame_1_2, x_rotor_frame_1_3, zero, m74, m75, zero, zero, zero, zero],
        [x_rotor_frame_2_2, m82, zero, m84, m85, zero, zero, zero, zero],
        [x_rotor_frame_3_2, zero, m93, zero, zero, zero, zero, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (u_psi', u_theta', u_phi', rotor_torque_inner_frame1, rotor_torque_inner_frame2, inner_torque_outer_frame2, inner_torque_outer_frame3, outer_torque_n1, outer_torque_n2).
///
/// 55 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 3]) -> [S; 9] {
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
    // H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
    let H_inner_2 = Ay * w_outer_frame_in_inner_frame_2;
    // H_inner_3 = Az*w_outer_frame_in_inner_frame_3
    let H_inner_3 = Az * w_outer_frame_in_inner_frame_3;
    // x_inner_frame_1 = w_outer_frame_in_inner_frame_2*H_inner_3 -
    //   w_outer_frame_in_inner_frame_3*H_inner_2
    let x_inner_frame_1 = (-w_outer_frame_in_inner_frame_3)
        .mul_add(H_inner_2, w_outer_frame_in_inner_frame_2 * H_inner_3);
    // w_inner_frame_13 = u_theta*w_outer_frame_in_inner_frame_3
    let w_inner_frame_13 = u_theta * w_outer_frame_in_inner_frame_3;
    // H_inner_1 = Ax*u_theta
    let H_inner_1 = Ax * u_theta;
    // x_inner_frame_2 = Ay*w_inner_frame_13 - u_theta*H_inner_3 + w_outer_frame_in_inner_frame_3*H_inner_1
    let x_inner_frame_2 = (-u_theta).mul_add(H_inner_3, Ay * w_inner_frame_13)
        + w_outer_frame_in_inner_frame_3 * H_inner_1;
    // w_inner_frame_12 = u_theta*w_outer_frame_in_inner_frame_2
    let w_inner_frame_12 = u_theta * w_outer_frame_in_inner_frame_2;
    // x_inner_frame_3 = u_theta*H_inner_2 - w_outer_frame_in_inner_frame_2*H_inner_1 - Az*w_inner_frame_12
    let x_inner_frame_3 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(H_inner_1, u_theta * H_inner_2) - Az * w_inner_frame_12;
    // w_inner_frame_in_rotor_frame_2 = u_theta*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(cos_phi, u_theta * sin_phi);
    // w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3
    let w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3;
    // H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
    let H_rotor_2 = B * w_inner_frame_in_rotor_frame_2;
    // H_rotor_3 = C*w_rotor_frame_3
    let H_rotor_3 = C * w_rotor_frame_3;
    // alpha_inner_frame_in_rotor_frame_1 = w_inner_frame_13*sin(phi)
    let alpha_inner_frame_in_rotor_frame_1 = w_inner_frame_13 * sin_phi;
    // alpha_rotor_frame_1 = u_phi*w_inner_frame_in_rotor_frame_2 - alpha_inner_frame_in_rotor_frame_1
    let alpha_rotor_frame_1 = u_phi
        .mul_add(w_inner_frame_in_rotor_frame_2, -alpha_inner_frame_in_rotor_frame_1);
    // x_rotor_frame_1 = w_inner_frame_in_rotor_frame_2*H_rotor_3 - w_rotor_frame_3*H_rotor_2 +
    //   B*alpha_rotor_frame_1
    let x_rotor_frame_1 = (-w_rotor_frame_3)
        .mul_add(H_rotor_2, w_inner_frame_in_rotor_frame_2 * H_rotor_3) + B * alpha_rotor_frame_1;
    // w_inner_frame_in_rotor_frame_1 = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1 = w_outer_frame_in_inner_frame_2
        .mul_add(sin_phi, u_theta * cos_phi);
    // H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
    let H_rotor_1 = B * w_inner_frame_in_rotor_frame_1;
    // alpha_inner_frame_in_rotor_frame_2 = w_inner_frame_13*cos(phi)
    let alpha_inner_frame_in_rotor_frame_2 = w_inner_frame_13 * cos_phi;
    // alpha_rotor_frame_2 = u_phi*w_inner_frame_in_rotor_frame_1 - alpha_inner_frame_in_rotor_frame_2
    let alpha_rotor_frame_2 = u_phi
        .mul_add(w_inner_frame_in_rotor_frame_1, -alpha_inner_frame_in_rotor_frame_2);
    // x_rotor_frame_2 = w_rotor_frame_3*H_rotor_1 - H_rotor_3*w_inner_frame_in_rotor_frame_1 -
    //   B*alpha_rotor_frame_2
    let x_rotor_frame_2 = (-H_rotor_3)
        .mul_add(w_inner_frame_in_rotor_frame_1, w_rotor_frame_3 * H_rotor_1)
        - B * alpha_rotor_frame_2;
    // x_rotor_frame_3 = C*w_inner_frame_12 + H_rotor_2*w_inner_frame_in_rotor_frame_1 -
    //   w_inner_frame_in_rotor_frame_2*H_rotor_1
    let x_rotor_frame_3 = H_rotor_2
        .mul_add(w_inner_frame_in_rotor_frame_1, C * w_inner_frame_12)
        - w_inner_frame_in_rotor_frame_2 * H_rotor_1;
    // Values.
    // f4 = -x_inner_frame_1
    let f4 = -x_inner_frame_1;
    // f5 = -x_inner_frame_2
    let f5 = -x_inner_frame_2;
    // f6 = -x_inner_frame_3
    let f6 = -x_inner_frame_3;
    // f8 = -x_rotor_frame_2
    let f8 = -x_rotor_frame_2;
    let zero = S::int(0);
    [zero, zero, zero, f4, f5, f6, x_rotor_frame_1, f8, x_rotor_frame_3]
}

/// The accelerations (u_psi', u_theta', u_phi'), solved for when this code was generated.
///
/// 103 operations, 2 sines and cosines.
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
    // H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
    let H_inner_2 = Ay * w_outer_frame_in_inner_frame_2;
    // H_inner_3 = Az*w_outer_frame_in_inner_frame_3
    let H_inner_3 = Az * w_outer_frame_in_inner_frame_3;
    // x_inner_frame_1 = w_outer_frame_in_inner_frame_2*H_inner_3 -
    //   w_outer_frame_in_inner_frame_3*H_inner_2
    let x_inner_frame_1 = (-w_outer_frame_in_inner_frame_3)
        .mul_add(H_inner_2, w_outer_frame_in_inner_frame_2 * H_inner_3);
    // w_inner_frame_13 = u_theta*w_outer_frame_in_inner_frame_3
    let w_inner_frame_13 = u_theta * w_outer_frame_in_inner_frame_3;
    // H_inner_1 = Ax*u_theta
    let H_inner_1 = Ax * u_theta;
    // x_inner_frame_2 = Ay*w_inner_frame_13 - u_theta*H_inner_3 + w_outer_frame_in_inner_frame_3*H_inner_1
    let x_inner_frame_2 = (-u_theta).mul_add(H_inner_3, Ay * w_inner_frame_13)
        + w_outer_frame_in_inner_frame_3 * H_inner_1;
    // w_inner_frame_12 = u_theta*w_outer_frame_in_inner_frame_2
    let w_inner_frame_12 = u_theta * w_outer_frame_in_inner_frame_2;
    // x_inner_frame_3 = u_theta*H_inner_2 - w_outer_frame_in_inner_frame_2*H_inner_1 - Az*w_inner_frame_12
    let x_inner_frame_3 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(H_inner_1, u_theta * H_inner_2) - Az * w_inner_frame_12;
    // w_inner_frame_in_rotor_frame_2 = u_theta*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(cos_phi, u_theta * sin_phi);
    // w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3
    let w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3;
    // H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
    let H_rotor_2 = B * w_inner_frame_in_rotor_frame_2;
    // H_rotor_3 = C*w_rotor_frame_3
    let H_rotor_3 = C * w_rotor_frame_3;
    // alpha_inner_frame_in_rotor_frame_1 = w_inner_frame_13*sin(phi)
    let alpha_inner_frame_in_rotor_frame_1 = w_inner_frame_13 * sin_phi;
    // alpha_rotor_frame_1 = u_phi*w_inner_frame_in_rotor_frame_2 - alpha_inner_frame_in_rotor_frame_1
    let alpha_rotor_frame_1 = u_phi
        .mul_add(w_inner_frame_in_rotor_frame_2, -alpha_inner_frame_in_rotor_frame_1);
    // x_rotor_frame_1 = w_inner_frame_in_rotor_frame_2*H_rotor_3 - w_rotor_frame_3*H_rotor_2 +
    //   B*alpha_rotor_frame_1
    let x_rotor_frame_1 = (-w_rotor_frame_3)
        .mul_add(H_rotor_2, w_inner_frame_in_rotor_frame_2 * H_rotor_3) + B * alpha_rotor_frame_1;
    // w_inner_frame_in_rotor_frame_1 = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1 = w_outer_frame_in_inner_frame_2
        .mul_add(sin_phi, u_theta * cos_phi);
    // H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
    let H_rotor_1 = B * w_inner_frame_in_rotor_frame_1;
    // alpha_inner_frame_in_rotor_frame_2 = w_inner_frame_13*cos(phi)
    let alpha_inner_frame_in_rotor_frame_2 = w_inner_frame_13 * cos_phi;
    // alpha_rotor_frame_2 = u_phi*w_inner_frame_in_rotor_frame_1 - alpha_inner_frame_in_rotor_frame_2
    let alpha_rotor_frame_2 = u_phi
        .mul_add(w_inner_frame_in_rotor_frame_1, -alpha_inner_frame_in_rotor_frame_2);
    // x_rotor_frame_2 = w_rotor_frame_3*H_rotor_1 - H_rotor_3*w_inner_frame_in_rotor_frame_1 -
    //   B*alpha_rotor_frame_2
    let x_rotor_frame_2 = (-H_rotor_3)
        .mul_add(w_inner_frame_in_rotor_frame_1, w_rotor_frame_3 * H_rotor_1)
        - B * alpha_rotor_frame_2;
    // x_rotor_frame_3 = C*w_inner_frame_12 + H_rotor_2*w_inner_frame_in_rotor_frame_1 -
    //   w_inner_frame_in_rotor_frame_2*H_rotor_1
    let x_rotor_frame_3 = H_rotor_2
        .mul_add(w_inner_frame_in_rotor_frame_1, C * w_inner_frame_12)
        - w_inner_frame_in_rotor_frame_2 * H_rotor_1;
    // x_inner_frame_2_2 = Ay*sin(theta)
    let x_inner_frame_2_2 = Ay * sin_theta;
    // x_inner_frame_3_2 = Az*cos(theta)
    let x_inner_frame_3_2 = Az * cos_theta;
    // alpha_inner_frame_in_rotor_frame_1_2 = sin(theta)*sin(phi)
    let alpha_inner_frame_in_rotor_frame_1_2 = sin_theta * sin_phi;
    // x_rotor_frame_1_2 = B*alpha_inner_frame_in_rotor_frame_1_2
    let x_rotor_frame_1_2 = B * alpha_inner_frame_in_rotor_frame_1_2;
    // x_rotor_frame_1_3 = B*cos(phi)
    let x_rotor_frame_1_3 = B * cos_phi;
    // alpha_inner_frame_in_rotor_frame_2_2 = sin(theta)*cos(phi)
    let alpha_inner_frame_in_rotor_frame_2_2 = sin_theta * cos_phi;
    // x_rotor_frame_2_2 = B*alpha_inner_frame_in_rotor_frame_2_2
    let x_rotor_frame_2_2 = B * alpha_inner_frame_in_rotor_frame_2_2;
    // x_rotor_frame_2_3 = B*sin(phi)
    let x_rotor_frame_2_3 = B * sin_phi;
    // x_rotor_frame_3_2 = C*cos(theta)
    let x_rotor_frame_3_2 = C * cos_theta;
    // x_rotor_frame_1*cos(phi) + x_rotor_frame_2*sin(phi)
    let u_psi_dot_of_place = x_rotor_frame_2.mul_add(sin_phi, x_rotor_frame_1 * cos_phi);
    // x_inner_frame_1 - u_psi_dot_of_place
    let u_psi_dot_of_place_2 = x_inner_frame_1 - u_psi_dot_of_place;
    // 1/(Ax + x_rotor_frame_1_3*cos(phi) + x_rotor_frame_2_3*sin(phi))
    let u_psi_dot_of_place_3 = S::int(1)
        / (x_rotor_frame_1_3.mul_add(cos_phi, Ax) + x_rotor_frame_2_3 * sin_phi);
    // u_psi_dot_of_place_3*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)
    let u_psi_dot_of_place_4 = u_psi_dot_of_place_3
        * (-alpha_inner_frame_in_rotor_frame_2_2)
            .mul_add(
                x_rotor_frame_2_3,
                alpha_inner_frame_in_rotor_frame_1_2 * x_rotor_frame_1_3,
            );
    // x_rotor_frame_1_2*cos(phi) - x_rotor_frame_2_2*sin(phi)
    let u_psi_dot_of_place_5 = (-x_rotor_frame_2_2)
        .mul_add(sin_phi, x_rotor_frame_1_2 * cos_phi);
    // u_psi' = (x_rotor_frame_1*alpha_inner_frame_in_rotor_frame_1_2 - x_inner_frame_2*sin(theta) -
    //   x_inner_frame_3*cos(theta) - x_rotor_frame_2*alpha_inner_frame_in_rotor_frame_2_2 -
    //   (x_rotor_frame_1*cos(phi) - x_inner_frame_1 +
    //   x_rotor_frame_2*sin(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))/(Iz + x_inner_frame_2_2*sin(theta) + x_inner_frame_3_2*cos(theta) +
    //   alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_2 +
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_2 + (x_rotor_frame_2_2*sin(phi) -
    //   x_rotor_frame_1_2*cos(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))
    let u_psi_dot = ((-x_inner_frame_2)
        .mul_add(sin_theta, x_rotor_frame_1 * alpha_inner_frame_in_rotor_frame_1_2)
        - x_inner_frame_3 * cos_theta - x_rotor_frame_2 * alpha_inner_frame_in_rotor_frame_2_2
        + u_psi_dot_of_place_2 * u_psi_dot_of_place_4)
        / (x_inner_frame_2_2.mul_add(sin_theta, Iz) + x_inner_frame_3_2 * cos_theta
            + alpha_inner_frame_in_rotor_frame_1_2 * x_rotor_frame_1_2
            + alpha_inner_frame_in_rotor_frame_2_2 * x_rotor_frame_2_2
            - u_psi_dot_of_place_4 * u_psi_dot_of_place_5);
    // u_theta' = (x_rotor_frame_1*cos(phi) - x_inner_frame_1 + x_rotor_frame_2*sin(phi) -
    //   u_psi'*(x_rotor_frame_1_2*cos(phi) - x_rotor_frame_2_2*sin(phi)))/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi))
    let u_theta_dot = -u_psi_dot_of_place_3
        * u_psi_dot.mul_add(u_psi_dot_of_place_5, u_psi_dot_of_place_2);
    // u_phi' = (x_rotor_frame_3 - u_psi'*x_rotor_frame_3_2)/C
    let u_phi_dot = (-u_psi_dot).mul_add(x_rotor_frame_3_2, x_rotor_frame_3) / C;
    [u_psi_dot, u_theta_dot, u_phi_dot]
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
    // H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
    let H_inner_2 = Ay * w_outer_frame_in_inner_frame_2;
    // H_inner_3 = Az*w_outer_frame_in_inner_frame_3
    let H_inner_3 = Az * w_outer_frame_in_inner_frame_3;
    // H_inner_1 = Ax*u_theta
    let H_inner_1 = Ax * u_theta;
    // w_inner_frame_in_rotor_frame_2 = u_theta*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(cos_phi, u_theta * sin_phi);
    // w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3
    let w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3;
    // H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
    let H_rotor_2 = B * w_inner_frame_in_rotor_frame_2;
    // H_rotor_3 = C*w_rotor_frame_3
    let H_rotor_3 = C * w_rotor_frame_3;
    // w_inner_frame_in_rotor_frame_1 = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1 = w_outer_frame_in_inner_frame_2
        .mul_add(sin_phi, u_theta * cos_phi);
    // H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
    let H_rotor_1 = B * w_inner_frame_in_rotor_frame_1;
    // H_outer_3 = Iz*u_psi
    let H_outer_3 = Iz * u_psi;
    // u_theta*H_inner_1 + u_psi*H_outer_3
    let energy_of_motion = u_psi.mul_add(H_outer_3, u_theta * H_inner_1);
    // w_outer_frame_in_inner_frame_2*H_inner_2 + w_outer_frame_in_inner_frame_3*H_inner_3
    let energy_of_place = w_outer_frame_in_inner_frame_3
        .mul_add(H_inner_3, w_outer_frame_in_inner_frame_2 * H_inner_2);
    // w_inner_frame_in_rotor_frame_2*H_rotor_2 + w_inner_frame_in_rotor_frame_1*H_rotor_1
    let energy_of_place_2 = w_inner_frame_in_rotor_frame_1
        .mul_add(H_rotor_1, w_inner_frame_in_rotor_frame_2 * H_rotor_2);
    // w_rotor_frame_3*H_rotor_3 + energy_of_motion
    let energy_of_motion_2 = w_rotor_frame_3.mul_add(H_rotor_3, energy_of_motion);
    // energy_of_place + energy_of_place_2
    let energy_of_place_3 = energy_of_place + energy_of_place_2;
    // energy_of_motion_2 + energy_of_place_3
    let energy_of_motion_3 = energy_of_motion_2 + energy_of_place_3;
    // Values.
    // T = w_outer_frame_in_inner_frame_2*H_inner_2/2 + w_outer_frame_in_inner_frame_3*H_inner_3/2 +
    //   u_theta*H_inner_1/2 + w_inner_frame_in_rotor_frame_2*H_rotor_2/2 + w_rotor_frame_3*H_rotor_3/2 +
    //   w_inner_frame_in_rotor_frame_1*H_rotor_1/2 + u_psi*H_outer_3/2
    let energy = S::ratio(1, 2) * energy_of_motion_3;
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 103 operations, 2 sines and cosines.
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
    // H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
    let H_inner_2 = Ay * w_outer_frame_in_inner_frame_2;
    // H_inner_3 = Az*w_outer_frame_in_inner_frame_3
    let H_inner_3 = Az * w_outer_frame_in_inner_frame_3;
    // x_inner_frame_1 = w_outer_frame_in_inner_frame_2*H_inner_3 -
    //   w_outer_frame_in_inner_frame_3*H_inner_2
    let x_inner_frame_1 = (-w_outer_frame_in_inner_frame_3)
        .mul_add(H_inner_2, w_outer_frame_in_inner_frame_2 * H_inner_3);
    // w_inner_frame_13 = u_theta*w_outer_frame_in_inner_frame_3
    let w_inner_frame_13 = u_theta * w_outer_frame_in_inner_frame_3;
    // H_inner_1 = Ax*u_theta
    let H_inner_1 = Ax * u_theta;
    // x_inner_frame_2 = Ay*w_inner_frame_13 - u_theta*H_inner_3 + w_outer_frame_in_inner_frame_3*H_inner_1
    let x_inner_frame_2 = (-u_theta).mul_add(H_inner_3, Ay * w_inner_frame_13)
        + w_outer_frame_in_inner_frame_3 * H_inner_1;
    // w_inner_frame_12 = u_theta*w_outer_frame_in_inner_frame_2
    let w_inner_frame_12 = u_theta * w_outer_frame_in_inner_frame_2;
    // x_inner_frame_3 = u_theta*H_inner_2 - w_outer_frame_in_inner_frame_2*H_inner_1 - Az*w_inner_frame_12
    let x_inner_frame_3 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(H_inner_1, u_theta * H_inner_2) - Az * w_inner_frame_12;
    // w_inner_frame_in_rotor_frame_2 = u_theta*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(cos_phi, u_theta * sin_phi);
    // w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3
    let w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3;
    // H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
    let H_rotor_2 = B * w_inner_frame_in_rotor_frame_2;
    // H_rotor_3 = C*w_rotor_frame_3
    let H_rotor_3 = C * w_rotor_frame_3;
    // alpha_inner_frame_in_rotor_frame_1 = w_inner_frame_13*sin(phi)
    let alpha_inner_frame_in_rotor_frame_1 = w_inner_frame_13 * sin_phi;
    // alpha_rotor_frame_1 = u_phi*w_inner_frame_in_rotor_frame_2 - alpha_inner_frame_in_rotor_frame_1
    let alpha_rotor_frame_1 = u_phi
        .mul_add(w_inner_frame_in_rotor_frame_2, -alpha_inner_frame_in_rotor_frame_1);
    // x_rotor_frame_1 = w_inner_frame_in_rotor_frame_2*H_rotor_3 - w_rotor_frame_3*H_rotor_2 +
    //   B*alpha_rotor_frame_1
    let x_rotor_frame_1 = (-w_rotor_frame_3)
        .mul_add(H_rotor_2, w_inner_frame_in_rotor_frame_2 * H_rotor_3) + B * alpha_rotor_frame_1;
    // w_inner_frame_in_rotor_frame_1 = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1 = w_outer_frame_in_inner_frame_2
        .mul_add(sin_phi, u_theta * cos_phi);
    // H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
    let H_rotor_1 = B * w_inner_frame_in_rotor_frame_1;
    // alpha_inner_frame_in_rotor_frame_2 = w_inner_frame_13*cos(phi)
    let alpha_inner_frame_in_rotor_frame_2 = w_inner_frame_13 * cos_phi;
    // alpha_rotor_frame_2 = u_phi*w_inner_frame_in_rotor_frame_1 - alpha_inner_frame_in_rotor_frame_2
    let alpha_rotor_frame_2 = u_phi
        .mul_add(w_inner_frame_in_rotor_frame_1, -alpha_inner_frame_in_rotor_frame_2);
    // x_rotor_frame_2 = w_rotor_frame_3*H_rotor_1 - H_rotor_3*w_inner_frame_in_rotor_frame_1 -
    //   B*alpha_rotor_frame_2
    let x_rotor_frame_2 = (-H_rotor_3)
        .mul_add(w_inner_frame_in_rotor_frame_1, w_rotor_frame_3 * H_rotor_1)
        - B * alpha_rotor_frame_2;
    // x_rotor_frame_3 = C*w_inner_frame_12 + H_rotor_2*w_inner_frame_in_rotor_frame_1 -
    //   w_inner_frame_in_rotor_frame_2*H_rotor_1
    let x_rotor_frame_3 = H_rotor_2
        .mul_add(w_inner_frame_in_rotor_frame_1, C * w_inner_frame_12)
        - w_inner_frame_in_rotor_frame_2 * H_rotor_1;
    // x_inner_frame_2_2 = Ay*sin(theta)
    let x_inner_frame_2_2 = Ay * sin_theta;
    // x_inner_frame_3_2 = Az*cos(theta)
    let x_inner_frame_3_2 = Az * cos_theta;
    // alpha_inner_frame_in_rotor_frame_1_2 = sin(theta)*sin(phi)
    let alpha_inner_frame_in_rotor_frame_1_2 = sin_theta * sin_phi;
    // x_rotor_frame_1_2 = B*alpha_inner_frame_in_rotor_frame_1_2
    let x_rotor_frame_1_2 = B * alpha_inner_frame_in_rotor_frame_1_2;
    // x_rotor_frame_1_3 = B*cos(phi)
    let x_rotor_frame_1_3 = B * cos_phi;
    // alpha_inner_frame_in_rotor_frame_2_2 = sin(theta)*cos(phi)
    let alpha_inner_frame_in_rotor_frame_2_2 = sin_theta * cos_phi;
    // x_rotor_frame_2_2 = B*alpha_inner_frame_in_rotor_frame_2_2
    let x_rotor_frame_2_2 = B * alpha_inner_frame_in_rotor_frame_2_2;
    // x_rotor_frame_2_3 = B*sin(phi)
    let x_rotor_frame_2_3 = B * sin_phi;
    // x_rotor_frame_3_2 = C*cos(theta)
    let x_rotor_frame_3_2 = C * cos_theta;
    // x_rotor_frame_1*cos(phi) + x_rotor_frame_2*sin(phi)
    let u_psi_dot_of_place = x_rotor_frame_2.mul_add(sin_phi, x_rotor_frame_1 * cos_phi);
    // x_inner_frame_1 - u_psi_dot_of_place
    let u_psi_dot_of_place_2 = x_inner_frame_1 - u_psi_dot_of_place;
    // 1/(Ax + x_rotor_frame_1_3*cos(phi) + x_rotor_frame_2_3*sin(phi))
    let u_psi_dot_of_place_3 = S::int(1)
        / (x_rotor_frame_1_3.mul_add(cos_phi, Ax) + x_rotor_frame_2_3 * sin_phi);
    // u_psi_dot_of_place_3*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)
    let u_psi_dot_of_place_4 = u_psi_dot_of_place_3
        * (-alpha_inner_frame_in_rotor_frame_2_2)
            .mul_add(
                x_rotor_frame_2_3,
                alpha_inner_frame_in_rotor_frame_1_2 * x_rotor_frame_1_3,
            );
    // x_rotor_frame_1_2*cos(phi) - x_rotor_frame_2_2*sin(phi)
    let u_psi_dot_of_place_5 = (-x_rotor_frame_2_2)
        .mul_add(sin_phi, x_rotor_frame_1_2 * cos_phi);
    // u_psi' = (x_rotor_frame_1*alpha_inner_frame_in_rotor_frame_1_2 - x_inner_frame_2*sin(theta) -
    //   x_inner_frame_3*cos(theta) - x_rotor_frame_2*alpha_inner_frame_in_rotor_frame_2_2 -
    //   (x_rotor_frame_1*cos(phi) - x_inner_frame_1 +
    //   x_rotor_frame_2*sin(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))/(Iz + x_inner_frame_2_2*sin(theta) + x_inner_frame_3_2*cos(theta) +
    //   alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_2 +
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_2 + (x_rotor_frame_2_2*sin(phi) -
    //   x_rotor_frame_1_2*cos(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))
    let u_psi_dot = ((-x_inner_frame_2)
        .mul_add(sin_theta, x_rotor_frame_1 * alpha_inner_frame_in_rotor_frame_1_2)
        - x_inner_frame_3 * cos_theta - x_rotor_frame_2 * alpha_inner_frame_in_rotor_frame_2_2
        + u_psi_dot_of_place_2 * u_psi_dot_of_place_4)
        / (x_inner_frame_2_2.mul_add(sin_theta, Iz) + x_inner_frame_3_2 * cos_theta
            + alpha_inner_frame_in_rotor_frame_1_2 * x_rotor_frame_1_2
            + alpha_inner_frame_in_rotor_frame_2_2 * x_rotor_frame_2_2
            - u_psi_dot_of_place_4 * u_psi_dot_of_place_5);
    // u_theta' = (x_rotor_frame_1*cos(phi) - x_inner_frame_1 + x_rotor_frame_2*sin(phi) -
    //   u_psi'*(x_rotor_frame_1_2*cos(phi) - x_rotor_frame_2_2*sin(phi)))/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi))
    let u_theta_dot = -u_psi_dot_of_place_3
        * u_psi_dot.mul_add(u_psi_dot_of_place_5, u_psi_dot_of_place_2);
    // u_phi' = (x_rotor_frame_3 - u_psi'*x_rotor_frame_3_2)/C
    let u_phi_dot = (-u_psi_dot).mul_add(x_rotor_frame_3_2, x_rotor_frame_3) / C;
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
/// 390 operations, 2 sines and cosines.
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
    // H_inner_2 = Ay*w_outer_frame_in_inner_frame_2
    let H_inner_2 = Ay * w_outer_frame_in_inner_frame_2;
    // H_inner_3 = Az*w_outer_frame_in_inner_frame_3
    let H_inner_3 = Az * w_outer_frame_in_inner_frame_3;
    // x_inner_frame_1 = w_outer_frame_in_inner_frame_2*H_inner_3 -
    //   w_outer_frame_in_inner_frame_3*H_inner_2
    let x_inner_frame_1 = (-w_outer_frame_in_inner_frame_3)
        .mul_add(H_inner_2, w_outer_frame_in_inner_frame_2 * H_inner_3);
    // w_inner_frame_13 = u_theta*w_outer_frame_in_inner_frame_3
    let w_inner_frame_13 = u_theta * w_outer_frame_in_inner_frame_3;
    // H_inner_1 = Ax*u_theta
    let H_inner_1 = Ax * u_theta;
    // x_inner_frame_2 = Ay*w_inner_frame_13 - u_theta*H_inner_3 + w_outer_frame_in_inner_frame_3*H_inner_1
    let x_inner_frame_2 = (-u_theta).mul_add(H_inner_3, Ay * w_inner_frame_13)
        + w_outer_frame_in_inner_frame_3 * H_inner_1;
    // w_inner_frame_12 = u_theta*w_outer_frame_in_inner_frame_2
    let w_inner_frame_12 = u_theta * w_outer_frame_in_inner_frame_2;
    // x_inner_frame_3 = u_theta*H_inner_2 - w_outer_frame_in_inner_frame_2*H_inner_1 - Az*w_inner_frame_12
    let x_inner_frame_3 = (-w_outer_frame_in_inner_frame_2)
        .mul_add(H_inner_1, u_theta * H_inner_2) - Az * w_inner_frame_12;
    let u_theta_sin_phi = u_theta * sin_phi;
    // w_inner_frame_in_rotor_frame_1_by_phi = w_outer_frame_in_inner_frame_2*cos(phi) - u_theta*sin(phi)
    let w_inner_frame_in_rotor_frame_1_by_phi = w_outer_frame_in_inner_frame_2
        .mul_add(cos_phi, -u_theta_sin_phi);
    // w_inner_frame_in_rotor_frame_2 = u_theta*sin(phi) - w_outer_frame_in_inner_frame_2*cos(phi)
    let w_inner_frame_in_rotor_frame_2 = -w_inner_frame_in_rotor_frame_1_by_phi;
    // w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3
    let w_rotor_frame_3 = u_phi + w_outer_frame_in_inner_frame_3;
    // H_rotor_2 = B*w_inner_frame_in_rotor_frame_2
    let H_rotor_2 = B * w_inner_frame_in_rotor_frame_2;
    // H_rotor_3 = C*w_rotor_frame_3
    let H_rotor_3 = C * w_rotor_frame_3;
    // alpha_inner_frame_in_rotor_frame_1 = w_inner_frame_13*sin(phi)
    let alpha_inner_frame_in_rotor_frame_1 = w_inner_frame_13 * sin_phi;
    // alpha_rotor_frame_1 = u_phi*w_inner_frame_in_rotor_frame_2 - alpha_inner_frame_in_rotor_frame_1
    let alpha_rotor_frame_1 = u_phi
        .mul_add(w_inner_frame_in_rotor_frame_2, -alpha_inner_frame_in_rotor_frame_1);
    // x_rotor_frame_1 = w_inner_frame_in_rotor_frame_2*H_rotor_3 - w_rotor_frame_3*H_rotor_2 +
    //   B*alpha_rotor_frame_1
    let x_rotor_frame_1 = (-w_rotor_frame_3)
        .mul_add(H_rotor_2, w_inner_frame_in_rotor_frame_2 * H_rotor_3) + B * alpha_rotor_frame_1;
    let u_theta_cos_phi = u_theta * cos_phi;
    // w_inner_frame_in_rotor_frame_1 = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_1 = w_outer_frame_in_inner_frame_2
        .mul_add(sin_phi, u_theta_cos_phi);
    // H_rotor_1 = B*w_inner_frame_in_rotor_frame_1
    let H_rotor_1 = B * w_inner_frame_in_rotor_frame_1;
    // alpha_inner_frame_in_rotor_frame_2 = w_inner_frame_13*cos(phi)
    let alpha_inner_frame_in_rotor_frame_2 = w_inner_frame_13 * cos_phi;
    // alpha_rotor_frame_2 = u_phi*w_inner_frame_in_rotor_frame_1 - alpha_inner_frame_in_rotor_frame_2
    let alpha_rotor_frame_2 = u_phi
        .mul_add(w_inner_frame_in_rotor_frame_1, -alpha_inner_frame_in_rotor_frame_2);
    // x_rotor_frame_2 = w_rotor_frame_3*H_rotor_1 - H_rotor_3*w_inner_frame_in_rotor_frame_1 -
    //   B*alpha_rotor_frame_2
    let x_rotor_frame_2 = (-H_rotor_3)
        .mul_add(w_inner_frame_in_rotor_frame_1, w_rotor_frame_3 * H_rotor_1)
        - B * alpha_rotor_frame_2;
    // x_inner_frame_2_2 = Ay*sin(theta)
    let x_inner_frame_2_2 = Ay * sin_theta;
    // x_inner_frame_3_2 = Az*cos(theta)
    let x_inner_frame_3_2 = Az * cos_theta;
    // alpha_inner_frame_in_rotor_frame_1_2 = sin(theta)*sin(phi)
    let alpha_inner_frame_in_rotor_frame_1_2 = sin_theta * sin_phi;
    // x_rotor_frame_1_2 = B*alpha_inner_frame_in_rotor_frame_1_2
    let x_rotor_frame_1_2 = B * alpha_inner_frame_in_rotor_frame_1_2;
    // x_rotor_frame_1_3 = B*cos(phi)
    let x_rotor_frame_1_3 = B * cos_phi;
    // alpha_inner_frame_in_rotor_frame_2_2 = sin(theta)*cos(phi)
    let alpha_inner_frame_in_rotor_frame_2_2 = sin_theta * cos_phi;
    // x_rotor_frame_2_2 = B*alpha_inner_frame_in_rotor_frame_2_2
    let x_rotor_frame_2_2 = B * alpha_inner_frame_in_rotor_frame_2_2;
    // x_rotor_frame_2_3 = B*sin(phi)
    let x_rotor_frame_2_3 = B * sin_phi;
    // x_rotor_frame_3_2 = C*cos(theta)
    let x_rotor_frame_3_2 = C * cos_theta;
    // alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3
    let u_psi_dot_of_place = (-alpha_inner_frame_in_rotor_frame_2_2)
        .mul_add(
            x_rotor_frame_2_3,
            alpha_inner_frame_in_rotor_frame_1_2 * x_rotor_frame_1_3,
        );
    // x_rotor_frame_2_2*sin(phi) - x_rotor_frame_1_2*cos(phi)
    let u_psi_dot_of_place_2 = (-x_rotor_frame_1_2)
        .mul_add(cos_phi, x_rotor_frame_2_2 * sin_phi);
    // 1/(Ax + x_rotor_frame_1_3*cos(phi) + x_rotor_frame_2_3*sin(phi))
    let u_psi_dot_of_place_3 = S::int(1)
        / (x_rotor_frame_1_3.mul_add(cos_phi, Ax) + x_rotor_frame_2_3 * sin_phi);
    // x_inner_frame_2_2*sin(theta) + x_inner_frame_3_2*cos(theta)
    let u_psi_dot_of_place_4 = x_inner_frame_3_2
        .mul_add(cos_theta, x_inner_frame_2_2 * sin_theta);
    // alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_2 +
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_2
    let u_psi_dot_of_place_5 = alpha_inner_frame_in_rotor_frame_2_2
        .mul_add(
            x_rotor_frame_2_2,
            alpha_inner_frame_in_rotor_frame_1_2 * x_rotor_frame_1_2,
        );
    // Iz + u_psi_dot_of_place_4
    let u_psi_dot_of_place_6 = Iz + u_psi_dot_of_place_4;
    // u_psi_dot_of_place_5 + u_psi_dot_of_place_6
    let u_psi_dot_of_place_7 = u_psi_dot_of_place_5 + u_psi_dot_of_place_6;
    // 1/(u_psi_dot_of_place*u_psi_dot_of_place_2*u_psi_dot_of_place_3 + u_psi_dot_of_place_7)
    let u_psi_dot_of_place_8 = S::int(1)
        / (u_psi_dot_of_place * u_psi_dot_of_place_2)
            .mul_add(u_psi_dot_of_place_3, u_psi_dot_of_place_7);
    // x_inner_frame_2*sin(theta) + x_inner_frame_3*cos(theta)
    let u_psi_dot_of_place_9 = x_inner_frame_3
        .mul_add(cos_theta, x_inner_frame_2 * sin_theta);
    let u_psi_dot_of_place_10 = u_psi_dot_of_place_3 * sin_phi;
    // u_psi_dot_of_place_8*(alpha_inner_frame_in_rotor_frame_2_2 +
    //   u_psi_dot_of_place*u_psi_dot_of_place_10)
    let u_psi_dot_of_place_11 = u_psi_dot_of_place_8
        * u_psi_dot_of_place
            .mul_add(u_psi_dot_of_place_10, alpha_inner_frame_in_rotor_frame_2_2);
    let u_psi_dot_of_place_12 = u_psi_dot_of_place_3 * cos_phi;
    // u_psi_dot_of_place_8*(u_psi_dot_of_place*u_psi_dot_of_place_12 -
    //   alpha_inner_frame_in_rotor_frame_1_2)
    let u_psi_dot_of_place_13 = u_psi_dot_of_place_8
        * u_psi_dot_of_place
            .mul_add(u_psi_dot_of_place_12, -alpha_inner_frame_in_rotor_frame_1_2);
    let u_psi_dot_of_place_14 = u_psi_dot_of_place * u_psi_dot_of_place_3;
    let u_psi_dot_of_place_15 = u_psi_dot_of_place_8 * u_psi_dot_of_place_14;
    // u_psi' = (x_rotor_frame_1*alpha_inner_frame_in_rotor_frame_1_2 - x_inner_frame_2*sin(theta) -
    //   x_inner_frame_3*cos(theta) - x_rotor_frame_2*alpha_inner_frame_in_rotor_frame_2_2 -
    //   (x_rotor_frame_1*cos(phi) - x_inner_frame_1 +
    //   x_rotor_frame_2*sin(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))/(Iz + x_inner_frame_2_2*sin(theta) + x_inner_frame_3_2*cos(theta) +
    //   alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_2 +
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_2 + (x_rotor_frame_2_2*sin(phi) -
    //   x_rotor_frame_1_2*cos(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))
    let u_psi_dot = (-u_psi_dot_of_place_8)
        .mul_add(u_psi_dot_of_place_9, x_inner_frame_1 * u_psi_dot_of_place_15)
        - x_rotor_frame_2 * u_psi_dot_of_place_11 - x_rotor_frame_1 * u_psi_dot_of_place_13;
    // Az*w_outer_frame_in_inner_frame_2 - H_inner_2
    let x_inner_frame_1_by_theta_of_place = Az
        .mul_add(w_outer_frame_in_inner_frame_2, -H_inner_2);
    // Ay*w_outer_frame_in_inner_frame_3 - H_inner_3
    let x_inner_frame_1_by_theta_of_place_2 = Ay
        .mul_add(w_outer_frame_in_inner_frame_3, -H_inner_3);
    // x_inner_frame_1_by_theta = u_psi*(sin(theta)*(H_inner_2 - Az*w_outer_frame_in_inner_frame_2) +
    //   cos(theta)*(H_inner_3 - Ay*w_outer_frame_in_inner_frame_3))
    let x_inner_frame_1_by_theta = (-w_outer_frame_in_inner_frame_3)
        .mul_add(
            x_inner_frame_1_by_theta_of_place_2,
            -w_outer_frame_in_inner_frame_2 * x_inner_frame_1_by_theta_of_place,
        );
    // Ay - Az
    let ay_minus_az = Ay - Az;
    let u_theta_ay_minus_az = u_theta * ay_minus_az;
    // H_inner_1 + u_theta_ay_minus_az
    let x_inner_frame_2_by_theta_of_u_theta = H_inner_1 + u_theta_ay_minus_az;
    // x_inner_frame_2_by_theta = -u_psi*sin(theta)*(u_theta*(Ay - Az) + H_inner_1)
    let x_inner_frame_2_by_theta = -w_outer_frame_in_inner_frame_2
        * x_inner_frame_2_by_theta_of_u_theta;
    // u_theta_ay_minus_az - H_inner_1
    let x_inner_frame_3_by_theta_of_u_theta = u_theta_ay_minus_az - H_inner_1;
    // x_inner_frame_3_by_theta = -u_psi*cos(theta)*(u_theta*(Az - Ay) + H_inner_1)
    let x_inner_frame_3_by_theta = w_outer_frame_in_inner_frame_3
        * x_inner_frame_3_by_theta_of_u_theta;
    // w_inner_frame_in_rotor_frame_2_by_theta = -u_psi*cos(theta)*cos(phi)
    let w_inner_frame_in_rotor_frame_2_by_theta = -w_outer_frame_in_inner_frame_3 * cos_phi;
    // alpha_inner_frame_in_rotor_frame_1_by_theta = -u_psi*u_theta*sin(theta)*sin(phi)
    let alpha_inner_frame_in_rotor_frame_1_by_theta = -w_outer_frame_in_inner_frame_2
        * u_theta_sin_phi;
    // B*w_rotor_frame_3 - H_rotor_3
    let x_rotor_frame_1_by_theta_of_place = B.mul_add(w_rotor_frame_3, -H_rotor_3);
    // B*u_phi - x_rotor_frame_1_by_theta_of_place
    let x_rotor_frame_1_by_theta_of_u_phi = B
        .mul_add(u_phi, -x_rotor_frame_1_by_theta_of_place);
    let x_rotor_frame_1_by_theta_of_place_2 = C * w_inner_frame_in_rotor_frame_2;
    // x_rotor_frame_1_by_theta_of_place_2 - H_rotor_2
    let x_rotor_frame_1_by_theta_of_place_3 = x_rotor_frame_1_by_theta_of_place_2 - H_rotor_2;
    // x_rotor_frame_1_by_theta = u_psi*sin(theta)*(H_rotor_2 - C*w_inner_frame_in_rotor_frame_2) +
    //   H_rotor_3*w_inner_frame_in_rotor_frame_2_by_theta -
    //   B*(w_inner_frame_in_rotor_frame_2_by_theta*(w_rotor_frame_3 - u_phi) +
    //   alpha_inner_frame_in_rotor_frame_1_by_theta)
    let x_rotor_frame_1_by_theta = (-B)
        .mul_add(
            alpha_inner_frame_in_rotor_frame_1_by_theta,
            w_inner_frame_in_rotor_frame_2_by_theta * x_rotor_frame_1_by_theta_of_u_phi,
        ) - w_outer_frame_in_inner_frame_2 * x_rotor_frame_1_by_theta_of_place_3;
    // w_inner_frame_in_rotor_frame_1_by_theta = u_psi*cos(theta)*sin(phi)
    let w_inner_frame_in_rotor_frame_1_by_theta = w_outer_frame_in_inner_frame_3 * sin_phi;
    // alpha_inner_frame_in_rotor_frame_2_by_theta = -u_psi*u_theta*sin(theta)*cos(phi)
    let alpha_inner_frame_in_rotor_frame_2_by_theta = -w_outer_frame_in_inner_frame_2
        * u_theta_cos_phi;
    let x_rotor_frame_2_by_theta_of_place = C * w_inner_frame_in_rotor_frame_1;
    // x_rotor_frame_2_by_theta_of_place - H_rotor_1
    let x_rotor_frame_2_by_theta_of_place_2 = x_rotor_frame_2_by_theta_of_place - H_rotor_1;
    // x_rotor_frame_2_by_theta = u_psi*sin(theta)*(C*w_inner_frame_in_rotor_frame_1 - H_rotor_1) -
    //   H_rotor_3*w_inner_frame_in_rotor_frame_1_by_theta +
    //   B*(w_inner_frame_in_rotor_frame_1_by_theta*(w_rotor_frame_3 - u_phi) +
    //   alpha_inner_frame_in_rotor_frame_2_by_theta)
    let x_rotor_frame_2_by_theta = (-w_inner_frame_in_rotor_frame_1_by_theta)
        .mul_add(
            x_rotor_frame_1_by_theta_of_u_phi,
            B * alpha_inner_frame_in_rotor_frame_2_by_theta,
        ) + w_outer_frame_in_inner_frame_2 * x_rotor_frame_2_by_theta_of_place_2;
    // x_rotor_frame_3_by_theta = C*u_psi*u_theta*cos(theta) -
    //   H_rotor_1*w_inner_frame_in_rotor_frame_2_by_theta +
    //   H_rotor_2*w_inner_frame_in_rotor_frame_1_by_theta +
    //   B*(w_inner_frame_in_rotor_frame_1*w_inner_frame_in_rotor_frame_2_by_theta -
    //   w_inner_frame_in_rotor_frame_2*w_inner_frame_in_rotor_frame_1_by_theta)
    let x_rotor_frame_3_by_theta = C * w_inner_frame_13;
    // alpha_inner_frame_in_rotor_frame_1_2_by_theta = cos(theta)*sin(phi)
    let alpha_inner_frame_in_rotor_frame_1_2_by_theta = cos_theta * sin_phi;
    // alpha_inner_frame_in_rotor_frame_2_2_by_theta = cos(theta)*cos(phi)
    let alpha_inner_frame_in_rotor_frame_2_2_by_theta = cos_theta * cos_phi;
    // x_rotor_frame_1_3*alpha_inner_frame_in_rotor_frame_1_2_by_theta -
    //   x_rotor_frame_2_3*alpha_inner_frame_in_rotor_frame_2_2_by_theta
    let u_psi_dot_by_theta_of_place = (-x_rotor_frame_2_3)
        .mul_add(
            alpha_inner_frame_in_rotor_frame_2_2_by_theta,
            x_rotor_frame_1_3 * alpha_inner_frame_in_rotor_frame_1_2_by_theta,
        );
    // x_inner_frame_1 - x_rotor_frame_1*cos(phi) - x_rotor_frame_2*sin(phi)
    let u_psi_dot_by_theta_of_place_2 = (-x_rotor_frame_1)
        .mul_add(cos_phi, x_inner_frame_1) - x_rotor_frame_2 * sin_phi;
    let u_psi_dot_by_theta_of_place_3 = u_psi_dot_of_place_3 * u_psi_dot_by_theta_of_place_2;
    // -u_psi_dot_of_place_2
    let u_psi_dot_by_theta_of_place_4 = -u_psi_dot_of_place_2;
    // 1/(u_psi_dot_of_place_7 - u_psi_dot_of_place_14*u_psi_dot_by_theta_of_place_4)
    let u_psi_dot_by_theta_of_place_5 = S::int(1)
        / (-u_psi_dot_of_place_14)
            .mul_add(u_psi_dot_by_theta_of_place_4, u_psi_dot_of_place_7);
    let u_psi_dot_by_theta_of_place_6 = S::int(2) * x_rotor_frame_1_2;
    let u_psi_dot_by_theta_of_place_7 = S::int(2) * x_rotor_frame_2_2;
    let u_psi_dot_by_theta_of_place_8 = u_psi_dot_of_place_3 * u_psi_dot_by_theta_of_place_4;
    // u_psi_dot_by_theta_of_place_5^2*(x_rotor_frame_2*alpha_inner_frame_in_rotor_frame_2_2 -
    //   x_rotor_frame_1*alpha_inner_frame_in_rotor_frame_1_2 + u_psi_dot_of_place_9 -
    //   u_psi_dot_of_place_14*u_psi_dot_by_theta_of_place_2)
    let u_psi_dot_by_theta_of_place_9 = u_psi_dot_by_theta_of_place_5
        * u_psi_dot_by_theta_of_place_5
        * ((-x_rotor_frame_1)
            .mul_add(
                alpha_inner_frame_in_rotor_frame_1_2,
                x_rotor_frame_2 * alpha_inner_frame_in_rotor_frame_2_2,
            ) + u_psi_dot_of_place_9 - u_psi_dot_of_place_14 * u_psi_dot_by_theta_of_place_2);
    // u_psi_dot_by_theta = (x_inner_frame_2*sin(theta) + x_inner_frame_3*cos(theta) -
    //   x_rotor_frame_1*alpha_inner_frame_in_rotor_frame_1_2 +
    //   x_rotor_frame_2*alpha_inner_frame_in_rotor_frame_2_2 + (x_rotor_frame_1*cos(phi) - x_inner_frame_1 +
    //   x_rotor_frame_2*sin(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))*(Ay*sin(theta)*cos(theta) - Az*sin(theta)*cos(theta) +
    //   x_inner_frame_2_2*cos(theta) - x_inner_frame_3_2*sin(theta) +
    //   B*alpha_inner_frame_in_rotor_frame_1_2*alpha_inner_frame_in_rotor_frame_1_2_by_theta +
    //   x_rotor_frame_1_2*alpha_inner_frame_in_rotor_frame_1_2_by_theta +
    //   B*alpha_inner_frame_in_rotor_frame_2_2*alpha_inner_frame_in_rotor_frame_2_2_by_theta +
    //   x_rotor_frame_2_2*alpha_inner_frame_in_rotor_frame_2_2_by_theta + (x_rotor_frame_2_2*sin(phi) -
    //   x_rotor_frame_1_2*cos(phi))*(x_rotor_frame_1_3*alpha_inner_frame_in_rotor_frame_1_2_by_theta -
    //   x_rotor_frame_2_3*alpha_inner_frame_in_rotor_frame_2_2_by_theta)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)) + (alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3 -
    //   alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3)*(B*alpha_inner_frame_in_rotor_frame_1_2_by_theta*cos(phi)
    //   - B*alpha_inner_frame_in_rotor_frame_2_2_by_theta*sin(phi))/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))/(Iz + x_inner_frame_2_2*sin(theta) + x_inner_frame_3_2*cos(theta) +
    //   alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_2 +
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_2 + (x_rotor_frame_2_2*sin(phi) -
    //   x_rotor_frame_1_2*cos(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))^2 + (x_inner_frame_3*sin(theta) - x_inner_frame_2*cos(theta) -
    //   x_inner_frame_2_by_theta*sin(theta) - x_inner_frame_3_by_theta*cos(theta) +
    //   alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_by_theta -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_by_theta -
    //   (alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3 -
    //   alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3)*(x_inner_frame_1_by_theta -
    //   x_rotor_frame_1_by_theta*cos(phi) - x_rotor_frame_2_by_theta*sin(phi))/(Ax +
    //   x_rotor_frame_1_3*cos(phi) + x_rotor_frame_2_3*sin(phi)) +
    //   x_rotor_frame_1*alpha_inner_frame_in_rotor_frame_1_2_by_theta -
    //   x_rotor_frame_2*alpha_inner_frame_in_rotor_frame_2_2_by_theta - (x_rotor_frame_1*cos(phi) -
    //   x_inner_frame_1 +
    //   x_rotor_frame_2*sin(phi))*(x_rotor_frame_1_3*alpha_inner_frame_in_rotor_frame_1_2_by_theta -
    //   x_rotor_frame_2_3*alpha_inner_frame_in_rotor_frame_2_2_by_theta)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))/(Iz + x_inner_frame_2_2*sin(theta) + x_inner_frame_3_2*cos(theta) +
    //   alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_2 +
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_2 + (x_rotor_frame_2_2*sin(phi) -
    //   x_rotor_frame_1_2*cos(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))
    let u_psi_dot_by_theta = u_psi_dot_by_theta_of_place_5
        * (sin_theta * (x_inner_frame_3 - x_inner_frame_2_by_theta)
            - cos_theta * (x_inner_frame_2 + x_inner_frame_3_by_theta)
            + alpha_inner_frame_in_rotor_frame_1_2 * x_rotor_frame_1_by_theta
            - alpha_inner_frame_in_rotor_frame_2_2 * x_rotor_frame_2_by_theta
            + x_rotor_frame_1 * alpha_inner_frame_in_rotor_frame_1_2_by_theta
            - x_rotor_frame_2 * alpha_inner_frame_in_rotor_frame_2_2_by_theta
            + u_psi_dot_of_place_14
                * ((-x_rotor_frame_1_by_theta).mul_add(cos_phi, x_inner_frame_1_by_theta)
                    - x_rotor_frame_2_by_theta * sin_phi)
            + u_psi_dot_by_theta_of_place * u_psi_dot_by_theta_of_place_3)
        + u_psi_dot_by_theta_of_place_9
            * (cos_theta * ay_minus_az.mul_add(sin_theta, x_inner_frame_2_2)
                - x_inner_frame_3_2 * sin_theta
                - u_psi_dot_of_place_14 * u_psi_dot_by_theta_of_place
                + alpha_inner_frame_in_rotor_frame_1_2_by_theta * u_psi_dot_by_theta_of_place_6
                + alpha_inner_frame_in_rotor_frame_2_2_by_theta * u_psi_dot_by_theta_of_place_7
                - u_psi_dot_by_theta_of_place * u_psi_dot_by_theta_of_place_8);
    let u_theta_dot_by_theta_of_place = u_psi_dot_of_place_2 * u_psi_dot_of_place_3;
    // u_theta_dot_by_theta = (sin(phi)*(x_rotor_frame_2_by_theta +
    //   B*u_psi'*alpha_inner_frame_in_rotor_frame_2_2_by_theta + x_rotor_frame_2_2*u_psi_dot_by_theta) -
    //   x_inner_frame_1_by_theta - cos(phi)*(B*u_psi'*alpha_inner_frame_in_rotor_frame_1_2_by_theta -
    //   x_rotor_frame_1_by_theta + x_rotor_frame_1_2*u_psi_dot_by_theta))/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi))
    let u_theta_dot_by_theta = x_rotor_frame_2_by_theta * u_psi_dot_of_place_10
        - x_inner_frame_1_by_theta * u_psi_dot_of_place_3
        + x_rotor_frame_1_by_theta * u_psi_dot_of_place_12
        + B * u_psi_dot
            * (-alpha_inner_frame_in_rotor_frame_1_2_by_theta)
                .mul_add(
                    u_psi_dot_of_place_12,
                    alpha_inner_frame_in_rotor_frame_2_2_by_theta * u_psi_dot_of_place_10,
                ) + u_psi_dot_by_theta * u_theta_dot_by_theta_of_place;
    let c_inv = S::int(1) / C;
    let x_rotor_frame_3_2_c_inv = x_rotor_frame_3_2 * c_inv;
    // u_phi_dot_by_theta = u_psi'*sin(theta) + (x_rotor_frame_3_by_theta -
    //   x_rotor_frame_3_2*u_psi_dot_by_theta)/C
    let u_phi_dot_by_theta = x_rotor_frame_3_by_theta
        .mul_add(c_inv, u_psi_dot * sin_theta) - u_psi_dot_by_theta * x_rotor_frame_3_2_c_inv;
    // w_inner_frame_in_rotor_frame_2_by_phi = u_theta*cos(phi) + w_outer_frame_in_inner_frame_2*sin(phi)
    let w_inner_frame_in_rotor_frame_2_by_phi = w_inner_frame_in_rotor_frame_1;
    // alpha_rotor_frame_1_by_phi = u_phi*w_inner_frame_in_rotor_frame_2_by_phi - w_inner_frame_13*cos(phi)
    let alpha_rotor_frame_1_by_phi = u_phi
        .mul_add(
            w_inner_frame_in_rotor_frame_2_by_phi, -alpha_inner_frame_in_rotor_frame_2,
        );
    // alpha_rotor_frame_2_by_phi = w_inner_frame_13*sin(phi) + u_phi*w_inner_frame_in_rotor_frame_1_by_phi
    let alpha_rotor_frame_2_by_phi = u_phi
        .mul_add(
            w_inner_frame_in_rotor_frame_1_by_phi, alpha_inner_frame_in_rotor_frame_1,
        );
    // x_rotor_frame_3_by_phi = H_rotor_2*w_inner_frame_in_rotor_frame_1_by_phi -
    //   H_rotor_1*w_inner_frame_in_rotor_frame_2_by_phi +
    //   B*(w_inner_frame_in_rotor_frame_1*w_inner_frame_in_rotor_frame_2_by_phi -
    //   w_inner_frame_in_rotor_frame_2*w_inner_frame_in_rotor_frame_1_by_phi)
    let x_rotor_frame_3_by_phi = S::int(0);
    // alpha_inner_frame_in_rotor_frame_1_2_by_phi = sin(theta)*cos(phi)
    let alpha_inner_frame_in_rotor_frame_1_2_by_phi = alpha_inner_frame_in_rotor_frame_2_2;
    // alpha_inner_frame_in_rotor_frame_2_2_by_phi = -sin(theta)*sin(phi)
    let alpha_inner_frame_in_rotor_frame_2_2_by_phi = -alpha_inner_frame_in_rotor_frame_1_2;
    // H_rotor_3*w_inner_frame_in_rotor_frame_2_by_phi + B*(alpha_rotor_frame_1_by_phi -
    //   w_rotor_frame_3*w_inner_frame_in_rotor_frame_2_by_phi)
    let u_psi_dot_by_phi_of_place = B
        * (-w_rotor_frame_3)
            .mul_add(w_inner_frame_in_rotor_frame_2_by_phi, alpha_rotor_frame_1_by_phi)
        + H_rotor_3 * w_inner_frame_in_rotor_frame_2_by_phi;
    // H_rotor_3*w_inner_frame_in_rotor_frame_1_by_phi + B*(alpha_rotor_frame_2_by_phi -
    //   w_rotor_frame_3*w_inner_frame_in_rotor_frame_1_by_phi)
    let u_psi_dot_by_phi_of_place_2 = B
        * (-w_rotor_frame_3)
            .mul_add(w_inner_frame_in_rotor_frame_1_by_phi, alpha_rotor_frame_2_by_phi)
        + H_rotor_3 * w_inner_frame_in_rotor_frame_1_by_phi;
    // x_rotor_frame_1_3*sin(phi) - x_rotor_frame_2_3*cos(phi)
    let u_psi_dot_by_phi_of_place_3 = (-x_rotor_frame_2_3)
        .mul_add(cos_phi, x_rotor_frame_1_3 * sin_phi);
    // x_rotor_frame_1_3*(alpha_inner_frame_in_rotor_frame_1_2_by_phi -
    //   alpha_inner_frame_in_rotor_frame_2_2) - x_rotor_frame_1_2*sin(phi) -
    //   x_rotor_frame_2_3*alpha_inner_frame_in_rotor_frame_2_2_by_phi
    let u_psi_dot_by_phi_of_place_4 = x_rotor_frame_1_3
        * (alpha_inner_frame_in_rotor_frame_1_2_by_phi
            - alpha_inner_frame_in_rotor_frame_2_2) - x_rotor_frame_1_2 * sin_phi
        - x_rotor_frame_2_3 * alpha_inner_frame_in_rotor_frame_2_2_by_phi;
    // u_psi_dot_of_place_14*u_psi_dot_by_phi_of_place_3 + u_psi_dot_by_phi_of_place_4
    let u_psi_dot_by_phi_of_place_5 = u_psi_dot_of_place_14
        .mul_add(u_psi_dot_by_phi_of_place_3, u_psi_dot_by_phi_of_place_4);
    // B*alpha_inner_frame_in_rotor_frame_1_2_by_phi - x_rotor_frame_2_2
    let u_psi_dot_by_phi_of_place_6 = B
        .mul_add(alpha_inner_frame_in_rotor_frame_1_2_by_phi, -x_rotor_frame_2_2);
    // x_rotor_frame_1_2 + B*alpha_inner_frame_in_rotor_frame_2_2_by_phi
    let u_psi_dot_by_phi_of_place_7 = B
        .mul_add(alpha_inner_frame_in_rotor_frame_2_2_by_phi, x_rotor_frame_1_2);
    // u_psi_dot_by_phi = (x_inner_frame_2*sin(theta) + x_inner_frame_3*cos(theta) -
    //   x_rotor_frame_1*alpha_inner_frame_in_rotor_frame_1_2 +
    //   x_rotor_frame_2*alpha_inner_frame_in_rotor_frame_2_2 + (x_rotor_frame_1*cos(phi) - x_inner_frame_1 +
    //   x_rotor_frame_2*sin(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))*((x_rotor_frame_2_2*sin(phi) -
    //   x_rotor_frame_1_2*cos(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)*(x_rotor_frame_1_3*sin(phi) -
    //   x_rotor_frame_2_3*cos(phi))/(Ax + x_rotor_frame_1_3*cos(phi) + x_rotor_frame_2_3*sin(phi))^2 +
    //   B*alpha_inner_frame_in_rotor_frame_1_2*alpha_inner_frame_in_rotor_frame_1_2_by_phi +
    //   x_rotor_frame_1_2*alpha_inner_frame_in_rotor_frame_1_2_by_phi +
    //   B*alpha_inner_frame_in_rotor_frame_2_2*alpha_inner_frame_in_rotor_frame_2_2_by_phi +
    //   x_rotor_frame_2_2*alpha_inner_frame_in_rotor_frame_2_2_by_phi + (x_rotor_frame_2_2*sin(phi) -
    //   x_rotor_frame_1_2*cos(phi))*(x_rotor_frame_1_3*alpha_inner_frame_in_rotor_frame_1_2_by_phi -
    //   B*alpha_inner_frame_in_rotor_frame_1_2*sin(phi) - B*alpha_inner_frame_in_rotor_frame_2_2*cos(phi) -
    //   x_rotor_frame_2_3*alpha_inner_frame_in_rotor_frame_2_2_by_phi)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)) + (alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)*(x_rotor_frame_1_2*sin(phi) +
    //   x_rotor_frame_2_2*cos(phi) - B*alpha_inner_frame_in_rotor_frame_1_2_by_phi*cos(phi) +
    //   B*alpha_inner_frame_in_rotor_frame_2_2_by_phi*sin(phi))/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))/(Iz + x_inner_frame_2_2*sin(theta) + x_inner_frame_3_2*cos(theta) +
    //   alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_2 +
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_2 + (x_rotor_frame_2_2*sin(phi) -
    //   x_rotor_frame_1_2*cos(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))^2 + ((x_inner_frame_1 - x_rotor_frame_1*cos(phi) -
    //   x_rotor_frame_2*sin(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)*(x_rotor_frame_1_3*sin(phi) -
    //   x_rotor_frame_2_3*cos(phi))/(Ax + x_rotor_frame_1_3*cos(phi) + x_rotor_frame_2_3*sin(phi))^2 +
    //   alpha_inner_frame_in_rotor_frame_1_2*(H_rotor_3*w_inner_frame_in_rotor_frame_2_by_phi +
    //   B*(alpha_rotor_frame_1_by_phi - w_rotor_frame_3*w_inner_frame_in_rotor_frame_2_by_phi)) +
    //   alpha_inner_frame_in_rotor_frame_2_2*(H_rotor_3*w_inner_frame_in_rotor_frame_1_by_phi +
    //   B*(alpha_rotor_frame_2_by_phi - w_rotor_frame_3*w_inner_frame_in_rotor_frame_1_by_phi)) +
    //   (alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)*(x_rotor_frame_1*sin(phi) -
    //   x_rotor_frame_2*cos(phi) - cos(phi)*(H_rotor_3*w_inner_frame_in_rotor_frame_2_by_phi +
    //   B*(alpha_rotor_frame_1_by_phi - w_rotor_frame_3*w_inner_frame_in_rotor_frame_2_by_phi)) +
    //   sin(phi)*(H_rotor_3*w_inner_frame_in_rotor_frame_1_by_phi + B*(alpha_rotor_frame_2_by_phi -
    //   w_rotor_frame_3*w_inner_frame_in_rotor_frame_1_by_phi)))/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)) + x_rotor_frame_1*alpha_inner_frame_in_rotor_frame_1_2_by_phi -
    //   x_rotor_frame_2*alpha_inner_frame_in_rotor_frame_2_2_by_phi + (x_inner_frame_1 -
    //   x_rotor_frame_1*cos(phi) -
    //   x_rotor_frame_2*sin(phi))*(x_rotor_frame_1_3*alpha_inner_frame_in_rotor_frame_1_2_by_phi -
    //   B*alpha_inner_frame_in_rotor_frame_1_2*sin(phi) - B*alpha_inner_frame_in_rotor_frame_2_2*cos(phi) -
    //   x_rotor_frame_2_3*alpha_inner_frame_in_rotor_frame_2_2_by_phi)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))/(Iz + x_inner_frame_2_2*sin(theta) + x_inner_frame_3_2*cos(theta) +
    //   alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_2 +
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_2 + (x_rotor_frame_2_2*sin(phi) -
    //   x_rotor_frame_1_2*cos(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))
    let u_psi_dot_by_phi = u_psi_dot_by_theta_of_place_5
        * (x_rotor_frame_1 * alpha_inner_frame_in_rotor_frame_1_2_by_phi
            - x_rotor_frame_2 * alpha_inner_frame_in_rotor_frame_2_2_by_phi
            + alpha_inner_frame_in_rotor_frame_1_2 * u_psi_dot_by_phi_of_place
            + alpha_inner_frame_in_rotor_frame_2_2 * u_psi_dot_by_phi_of_place_2
            + u_psi_dot_of_place_14
                * (sin_phi * (x_rotor_frame_1 + u_psi_dot_by_phi_of_place_2)
                    - cos_phi * (x_rotor_frame_2 + u_psi_dot_by_phi_of_place))
            + u_psi_dot_by_theta_of_place_3 * u_psi_dot_by_phi_of_place_5)
        + u_psi_dot_by_theta_of_place_9
            * (alpha_inner_frame_in_rotor_frame_1_2_by_phi * u_psi_dot_by_theta_of_place_6
                - u_psi_dot_by_theta_of_place_8 * u_psi_dot_by_phi_of_place_5
                + alpha_inner_frame_in_rotor_frame_2_2_by_phi * u_psi_dot_by_theta_of_place_7
                - u_psi_dot_of_place_14
                    * (-u_psi_dot_by_phi_of_place_7)
                        .mul_add(sin_phi, u_psi_dot_by_phi_of_place_6 * cos_phi));
    // x_inner_frame_1*u_psi_dot_of_place_3 - x_rotor_frame_2*u_psi_dot_of_place_10
    let u_theta_dot_by_phi_of_place = (-x_rotor_frame_2)
        .mul_add(u_psi_dot_of_place_10, x_inner_frame_1 * u_psi_dot_of_place_3);
    // x_rotor_frame_1*u_psi_dot_of_place_12 + u_psi'*u_theta_dot_by_theta_of_place
    let u_theta_dot_by_phi_of_u_psi_dot = u_psi_dot
        .mul_add(u_theta_dot_by_theta_of_place, x_rotor_frame_1 * u_psi_dot_of_place_12);
    // u_theta_dot_by_phi = (x_rotor_frame_1*cos(phi) - x_inner_frame_1 + x_rotor_frame_2*sin(phi) -
    //   u_psi'*(x_rotor_frame_1_2*cos(phi) - x_rotor_frame_2_2*sin(phi)))*(x_rotor_frame_1_3*sin(phi) -
    //   x_rotor_frame_2_3*cos(phi))/(Ax + x_rotor_frame_1_3*cos(phi) + x_rotor_frame_2_3*sin(phi))^2 +
    //   (x_rotor_frame_2*cos(phi) - x_rotor_frame_1*sin(phi) +
    //   cos(phi)*(H_rotor_3*w_inner_frame_in_rotor_frame_2_by_phi + B*(alpha_rotor_frame_1_by_phi -
    //   w_rotor_frame_3*w_inner_frame_in_rotor_frame_2_by_phi)) -
    //   sin(phi)*(H_rotor_3*w_inner_frame_in_rotor_frame_1_by_phi + B*(alpha_rotor_frame_2_by_phi -
    //   w_rotor_frame_3*w_inner_frame_in_rotor_frame_1_by_phi)) -
    //   u_psi'*(B*alpha_inner_frame_in_rotor_frame_1_2_by_phi*cos(phi) - x_rotor_frame_1_2*sin(phi) -
    //   x_rotor_frame_2_2*cos(phi) - B*alpha_inner_frame_in_rotor_frame_2_2_by_phi*sin(phi)) -
    //   u_psi_dot_by_phi*(x_rotor_frame_1_2*cos(phi) - x_rotor_frame_2_2*sin(phi)))/(Ax +
    //   x_rotor_frame_1_3*cos(phi) + x_rotor_frame_2_3*sin(phi))
    let u_theta_dot_by_phi = u_psi_dot_of_place_12
        * B.mul_add(alpha_rotor_frame_1_by_phi, x_rotor_frame_2)
        - u_psi_dot_of_place_10 * B.mul_add(alpha_rotor_frame_2_by_phi, x_rotor_frame_1)
        + x_rotor_frame_1_by_theta_of_place
            * (-w_inner_frame_in_rotor_frame_2_by_phi)
                .mul_add(
                    u_psi_dot_of_place_12,
                    w_inner_frame_in_rotor_frame_1_by_phi * u_psi_dot_of_place_10,
                ) + u_psi_dot_by_phi * u_theta_dot_by_theta_of_place
        + u_psi_dot
            * (-u_psi_dot_of_place_12)
                .mul_add(
                    u_psi_dot_by_phi_of_place_6,
                    u_psi_dot_of_place_10 * u_psi_dot_by_phi_of_place_7,
                )
        + u_psi_dot_of_place_3 * u_psi_dot_by_phi_of_place_3
            * (u_theta_dot_by_phi_of_u_psi_dot - u_theta_dot_by_phi_of_place);
    // x_inner_frame_1_by_theta_of_place_2*sin(theta) - x_inner_frame_1_by_theta_of_place*cos(theta)
    let x_inner_frame_1_by_u_psi_of_place = (-x_inner_frame_1_by_theta_of_place)
        .mul_add(cos_theta, x_inner_frame_1_by_theta_of_place_2 * sin_theta);
    // x_inner_frame_1_by_u_psi = cos(theta)*(Az*w_outer_frame_in_inner_frame_2 - H_inner_2) +
    //   sin(theta)*(H_inner_3 - Ay*w_outer_frame_in_inner_frame_3)
    let x_inner_frame_1_by_u_psi = -x_inner_frame_1_by_u_psi_of_place;
    // x_inner_frame_2_by_u_psi = cos(theta)*(u_theta*(Ay - Az) + H_inner_1)
    let x_inner_frame_2_by_u_psi = x_inner_frame_2_by_theta_of_u_theta * cos_theta;
    // x_inner_frame_3_by_u_psi = -sin(theta)*(u_theta*(Az - Ay) + H_inner_1)
    let x_inner_frame_3_by_u_psi = x_inner_frame_3_by_theta_of_u_theta * sin_theta;
    // w_inner_frame_in_rotor_frame_2_by_u_psi = -sin(theta)*cos(phi)
    let w_inner_frame_in_rotor_frame_2_by_u_psi = -alpha_inner_frame_in_rotor_frame_2_2;
    // alpha_inner_frame_in_rotor_frame_1_by_u_psi = u_theta*cos(theta)*sin(phi)
    let alpha_inner_frame_in_rotor_frame_1_by_u_psi = u_theta_sin_phi * cos_theta;
    // x_rotor_frame_1_by_u_psi = cos(theta)*(C*w_inner_frame_in_rotor_frame_2 - H_rotor_2) +
    //   H_rotor_3*w_inner_frame_in_rotor_frame_2_by_u_psi -
    //   B*(w_inner_frame_in_rotor_frame_2_by_u_psi*(w_rotor_frame_3 - u_phi) +
    //   alpha_inner_frame_in_rotor_frame_1_by_u_psi)
    let x_rotor_frame_1_by_u_psi = (-B)
        .mul_add(
            alpha_inner_frame_in_rotor_frame_1_by_u_psi,
            w_inner_frame_in_rotor_frame_2_by_u_psi * x_rotor_frame_1_by_theta_of_u_phi,
        ) + x_rotor_frame_1_by_theta_of_place_3 * cos_theta;
    // w_inner_frame_in_rotor_frame_1_by_u_psi = sin(theta)*sin(phi)
    let w_inner_frame_in_rotor_frame_1_by_u_psi = alpha_inner_frame_in_rotor_frame_1_2;
    // alpha_inner_frame_in_rotor_frame_2_by_u_psi = u_theta*cos(theta)*cos(phi)
    let alpha_inner_frame_in_rotor_frame_2_by_u_psi = u_theta_cos_phi * cos_theta;
    // x_rotor_frame_2_by_u_psi = cos(theta)*(H_rotor_1 - C*w_inner_frame_in_rotor_frame_1) -
    //   H_rotor_3*w_inner_frame_in_rotor_frame_1_by_u_psi +
    //   B*(w_inner_frame_in_rotor_frame_1_by_u_psi*(w_rotor_frame_3 - u_phi) +
    //   alpha_inner_frame_in_rotor_frame_2_by_u_psi)
    let x_rotor_frame_2_by_u_psi = (-w_inner_frame_in_rotor_frame_1_by_u_psi)
        .mul_add(
            x_rotor_frame_1_by_theta_of_u_phi,
            B * alpha_inner_frame_in_rotor_frame_2_by_u_psi,
        ) - x_rotor_frame_2_by_theta_of_place_2 * cos_theta;
    // x_rotor_frame_3_by_u_psi = C*u_theta*sin(theta) - H_rotor_1*w_inner_frame_in_rotor_frame_2_by_u_psi
    //   + H_rotor_2*w_inner_frame_in_rotor_frame_1_by_u_psi +
    //   B*(w_inner_frame_in_rotor_frame_1*w_inner_frame_in_rotor_frame_2_by_u_psi -
    //   w_inner_frame_in_rotor_frame_2*w_inner_frame_in_rotor_frame_1_by_u_psi)
    let x_rotor_frame_3_by_u_psi = C * u_theta * sin_theta;
    // u_psi_dot_by_u_psi = (alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_by_u_psi -
    //   x_inner_frame_2_by_u_psi*sin(theta) - x_inner_frame_3_by_u_psi*cos(theta) -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_by_u_psi -
    //   (alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3 -
    //   alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3)*(x_inner_frame_1_by_u_psi -
    //   x_rotor_frame_1_by_u_psi*cos(phi) - x_rotor_frame_2_by_u_psi*sin(phi))/(Ax +
    //   x_rotor_frame_1_3*cos(phi) + x_rotor_frame_2_3*sin(phi)))/(Iz + x_inner_frame_2_2*sin(theta) +
    //   x_inner_frame_3_2*cos(theta) + alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_2 +
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_2 + (x_rotor_frame_2_2*sin(phi) -
    //   x_rotor_frame_1_2*cos(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))
    let u_psi_dot_by_u_psi = -u_psi_dot_of_place_8
        * x_inner_frame_3_by_u_psi
            .mul_add(cos_theta, x_inner_frame_2_by_u_psi * sin_theta)
        + x_inner_frame_1_by_u_psi * u_psi_dot_of_place_15
        - x_rotor_frame_2_by_u_psi * u_psi_dot_of_place_11
        - x_rotor_frame_1_by_u_psi * u_psi_dot_of_place_13;
    // u_theta_dot_by_u_psi = (sin(phi)*(x_rotor_frame_2_by_u_psi + x_rotor_frame_2_2*u_psi_dot_by_u_psi) -
    //   x_inner_frame_1_by_u_psi - cos(phi)*(x_rotor_frame_1_2*u_psi_dot_by_u_psi -
    //   x_rotor_frame_1_by_u_psi))/(Ax + x_rotor_frame_1_3*cos(phi) + x_rotor_frame_2_3*sin(phi))
    let u_theta_dot_by_u_psi = (-x_inner_frame_1_by_u_psi)
        .mul_add(u_psi_dot_of_place_3, x_rotor_frame_2_by_u_psi * u_psi_dot_of_place_10)
        + x_rotor_frame_1_by_u_psi * u_psi_dot_of_place_12
        + u_psi_dot_by_u_psi * u_theta_dot_by_theta_of_place;
    // B*w_outer_frame_in_inner_frame_3 - x_rotor_frame_1_by_theta_of_u_phi
    let x_rotor_frame_1_by_u_theta_of_u_phi = B
        .mul_add(w_outer_frame_in_inner_frame_3, -x_rotor_frame_1_by_theta_of_u_phi);
    // x_rotor_frame_1_by_u_theta = sin(phi)*(B*(u_phi - w_outer_frame_in_inner_frame_3 - w_rotor_frame_3)
    //   + H_rotor_3)
    let x_rotor_frame_1_by_u_theta = -x_rotor_frame_1_by_u_theta_of_u_phi * sin_phi;
    // x_rotor_frame_2_by_u_theta = -cos(phi)*(B*(u_phi - w_outer_frame_in_inner_frame_3 - w_rotor_frame_3)
    //   + H_rotor_3)
    let x_rotor_frame_2_by_u_theta = x_rotor_frame_1_by_u_theta_of_u_phi * cos_phi;
    // x_rotor_frame_3_by_u_theta = C*w_outer_frame_in_inner_frame_2 + H_rotor_2*cos(phi) +
    //   B*(w_inner_frame_in_rotor_frame_1*sin(phi) - w_inner_frame_in_rotor_frame_2*cos(phi)) -
    //   H_rotor_1*sin(phi)
    let x_rotor_frame_3_by_u_theta = C * w_outer_frame_in_inner_frame_2;
    // u_psi_dot_by_u_theta = (cos(theta)*(w_outer_frame_in_inner_frame_2*(Ax + Az) - H_inner_2) +
    //   sin(theta)*(H_inner_3 - w_outer_frame_in_inner_frame_3*(Ax + Ay)) +
    //   alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_by_u_theta -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_by_u_theta +
    //   (alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3 -
    //   alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3)*(x_rotor_frame_1_by_u_theta*cos(phi) +
    //   x_rotor_frame_2_by_u_theta*sin(phi))/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))/(Iz + x_inner_frame_2_2*sin(theta) + x_inner_frame_3_2*cos(theta) +
    //   alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_2 +
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_2 + (x_rotor_frame_2_2*sin(phi) -
    //   x_rotor_frame_1_2*cos(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))
    let u_psi_dot_by_u_theta = -x_rotor_frame_2_by_u_theta * u_psi_dot_of_place_11
        - x_rotor_frame_1_by_u_theta * u_psi_dot_of_place_13
        - u_psi_dot_of_place_8
            * (Ax
                * (-w_outer_frame_in_inner_frame_2)
                    .mul_add(cos_theta, w_outer_frame_in_inner_frame_3 * sin_theta)
                + x_inner_frame_1_by_u_psi_of_place);
    // u_theta_dot_by_u_theta = (sin(phi)*(x_rotor_frame_2_by_u_theta +
    //   x_rotor_frame_2_2*u_psi_dot_by_u_theta) + cos(phi)*(x_rotor_frame_1_by_u_theta -
    //   x_rotor_frame_1_2*u_psi_dot_by_u_theta))/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi))
    let u_theta_dot_by_u_theta = x_rotor_frame_1_by_u_theta
        .mul_add(
            u_psi_dot_of_place_12,
            x_rotor_frame_2_by_u_theta * u_psi_dot_of_place_10,
        ) + u_psi_dot_by_u_theta * u_theta_dot_by_theta_of_place;
    // u_psi_dot_by_u_phi = -(alpha_inner_frame_in_rotor_frame_1_2*(H_rotor_2 -
    //   w_inner_frame_in_rotor_frame_2*(B + C)) + alpha_inner_frame_in_rotor_frame_2_2*(H_rotor_1 -
    //   w_inner_frame_in_rotor_frame_1*(B + C)) + (cos(phi)*(H_rotor_2 - w_inner_frame_in_rotor_frame_2*(B +
    //   C)) + sin(phi)*(w_inner_frame_in_rotor_frame_1*(B + C) -
    //   H_rotor_1))*(alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3 -
    //   alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))/(Iz + x_inner_frame_2_2*sin(theta) + x_inner_frame_3_2*cos(theta) +
    //   alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_2 +
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_2 + (x_rotor_frame_2_2*sin(phi) -
    //   x_rotor_frame_1_2*cos(phi))*(alpha_inner_frame_in_rotor_frame_1_2*x_rotor_frame_1_3 -
    //   alpha_inner_frame_in_rotor_frame_2_2*x_rotor_frame_2_3)/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi)))
    let u_psi_dot_by_u_phi = (-u_psi_dot_of_place_13)
        .mul_add(
            x_rotor_frame_1_by_theta_of_place_2,
            u_psi_dot_of_place_11 * x_rotor_frame_2_by_theta_of_place,
        );
    // u_theta_dot_by_u_phi = (sin(phi)*(H_rotor_1 - w_inner_frame_in_rotor_frame_1*(B + C) +
    //   x_rotor_frame_2_2*u_psi_dot_by_u_phi) + cos(phi)*(w_inner_frame_in_rotor_frame_2*(B + C) - H_rotor_2
    //   - x_rotor_frame_1_2*u_psi_dot_by_u_phi))/(Ax + x_rotor_frame_1_3*cos(phi) +
    //   x_rotor_frame_2_3*sin(phi))
    let u_theta_dot_by_u_phi = (-u_psi_dot_of_place_10)
        .mul_add(
            x_rotor_frame_2_by_theta_of_place,
            u_psi_dot_of_place_12 * x_rotor_frame_1_by_theta_of_place_2,
        ) + u_psi_dot_by_u_phi * u_theta_dot_by_theta_of_place;
    // Entries that are not zero.
    // d(psi')/d(u_psi) = 1
    let psi_dot_by_u_psi_value = S::int(1);
    // d(theta')/d(u_theta) = 1
    let theta_dot_by_u_theta_value = S::int(1);
    // d(phi')/d(u_phi) = 1
    let phi_dot_by_u_phi_value = S::int(1);
    // d(u_phi')/d(phi) = (x_rotor_frame_3_by_phi - x_rotor_frame_3_2*u_psi_dot_by_phi)/C
    let u_phi_dot_by_phi_value = (-u_psi_dot_by_phi)
        .mul_add(x_rotor_frame_3_2_c_inv, x_rotor_frame_3_by_phi * c_inv);
    // d(u_phi')/d(u_psi) = (x_rotor_frame_3_by_u_psi - x_rotor_frame_3_2*u_psi_dot_by_u_psi)/C
    let u_phi_dot_by_u_psi_value = (-u_psi_dot_by_u_psi)
        .mul_add(x_rotor_frame_3_2_c_inv, x_rotor_frame_3_by_u_psi * c_inv);
    // d(u_phi')/d(u_theta) = (x_rotor_frame_3_by_u_theta - x_rotor_frame_3_2*u_psi_dot_by_u_theta)/C
    let u_phi_dot_by_u_theta_value = (-u_psi_dot_by_u_theta)
        .mul_add(x_rotor_frame_3_2_c_inv, x_rotor_frame_3_by_u_theta * c_inv);
    // d(u_phi')/d(u_phi) = -x_rotor_frame_3_2*u_psi_dot_by_u_phi/C
    let u_phi_dot_by_u_phi_value = -u_psi_dot_by_u_phi * x_rotor_frame_3_2_c_inv;
    let zero = S::int(0);
    [
        [zero, zero, zero, psi_dot_by_u_psi_value, zero, zero],
        [zero, zero, zero, zero, theta_dot_by_u_theta_value, zero],
        [zero, zero, zero, zero, zero, phi_dot_by_u_phi_value],
        [
            zero, u_psi_dot_by_theta, u_psi_dot_by_phi, u_psi_dot_by_u_psi, u_psi_dot_by_u_theta,
            u_psi_dot_by_u_phi,
        ],
        [
            zero, u_theta_dot_by_theta, u_theta_dot_by_phi, u_theta_dot_by_u_psi,
            u_theta_dot_by_u_theta, u_theta_dot_by_u_phi,
        ],
        [
            zero, u_phi_dot_by_theta, u_phi_dot_by_phi_value, u_phi_dot_by_u_psi_value,
            u_phi_dot_by_u_theta_value, u_phi_dot_by_u_phi_value,
        ],
    ]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 53 convolutions and 98 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 6]],
    history: &mut [Factors<S, 56>],
) {
    let Parameters { Iz, Ax, Ay, Az, B, C, .. } = *p;
    let [_, theta_0, phi_0, u_psi_0, u_theta_0, u_phi_0] = series[0];
    // Constant in time.
    // minus_ay = -Ay
    let minus_ay = -Ay;
    // minus_az = -Az
    let minus_az = -Az;
    // minus_ax = -Ax
    let minus_ax = -Ax;
    // minus_b = -B
    let minus_b = -B;
    // minus_c = -C
    let minus_c = -C;
    // weight = 1/C
    let weight = S::int(1) / C;
    // Order 0.
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    let u_psi_sin_theta_0 = u_psi_0 * sin_theta_0;
    let u_psi_cos_theta_0 = u_psi_0 * cos_theta_0;
    let x_inner_frame_1_of_u_psi_0 = u_psi_sin_theta_0 * u_psi_cos_theta_0;
    let x_inner_frame_1_of_u_psi_2_0 = u_psi_cos_theta_0 * u_psi_sin_theta_0;
    let x_inner_frame_1_of_place_0 = x_inner_frame_1_of_u_psi_2_0
        .mul_add(minus_ay, Az * x_inner_frame_1_of_u_psi_0);
    let u_psi_u_theta_cos_theta_0 = u_theta_0 * u_psi_cos_theta_0;
    let u_psi_u_theta_cos_theta_2_0 = u_psi_cos_theta_0 * u_theta_0;
    let u_psi_u_theta_cos_theta_3_0 = u_theta_0 * u_psi_cos_theta_0;
    let x_inner_frame_2_of_u_theta_0 = u_psi_u_theta_cos_theta_0
        .mul_add(
            Ay,
            u_psi_u_theta_cos_theta_3_0
                .mul_add(minus_az, Ax * u_psi_u_theta_cos_theta_2_0),
        );
    let u_psi_u_theta_sin_theta_0 = u_theta_0 * u_psi_sin_theta_0;
    let u_psi_u_theta_sin_theta_2_0 = u_theta_0 * u_psi_sin_theta_0;
    let u_psi_u_theta_sin_theta_3_0 = u_psi_sin_theta_0 * u_theta_0;
    let x_inner_frame_3_of_u_theta_0 = u_psi_u_theta_sin_theta_0
        .mul_add(
            minus_az,
            u_psi_u_theta_sin_theta_3_0
                .mul_add(minus_ax, Ay * u_psi_u_theta_sin_theta_2_0),
        );
    let (sin_phi_0, cos_phi_0) = phi_0.sin_cos();
    let u_theta_sin_phi_0 = u_theta_0 * sin_phi_0;
    let u_psi_sin_theta_cos_phi_0 = cos_phi_0 * u_psi_sin_theta_0;
    let w_inner_frame_in_rotor_frame_2_of_u_theta_0 = u_theta_sin_phi_0 - u_psi_sin_theta_cos_phi_0;
    let w_rotor_frame_3_of_u_phi_0 = u_phi_0 + u_psi_cos_theta_0;
    let alpha_inner_frame_in_rotor_frame_1_of_motion_0 = sin_phi_0 * u_psi_u_theta_cos_theta_0;
    let alpha_rotor_frame_1_of_motion_0 = u_phi_0 * w_inner_frame_in_rotor_frame_2_of_u_theta_0;
    let x_rotor_frame_1_of_motion_0 = w_inner_frame_in_rotor_frame_2_of_u_theta_0
        * w_rotor_frame_3_of_u_phi_0;
    let x_rotor_frame_1_of_motion_2_0 = w_rotor_frame_3_of_u_phi_0
        * w_inner_frame_in_rotor_frame_2_of_u_theta_0;
    let x_rotor_frame_1_of_place_0 = alpha_rotor_frame_1_of_motion_0
        .mul_add(
            B,
            x_rotor_frame_1_of_motion_2_0
                .mul_add(
                    minus_b,
                    x_rotor_frame_1_of_motion_0
                        .mul_add(
                            C,
                            minus_b * alpha_inner_frame_in_rotor_frame_1_of_motion_0,
                        ),
                ),
        );
    let u_theta_cos_phi_0 = u_theta_0 * cos_phi_0;
    let u_psi_sin_theta_sin_phi_0 = sin_phi_0 * u_psi_sin_theta_0;
    let w_inner_frame_in_rotor_frame_1_of_u_theta_0 = u_theta_cos_phi_0 + u_psi_sin_theta_sin_phi_0;
    let alpha_inner_frame_in_rotor_frame_2_of_motion_0 = cos_phi_0 * u_psi_u_theta_cos_theta_0;
    let alpha_rotor_frame_2_of_motion_0 = u_phi_0 * w_inner_frame_in_rotor_frame_1_of_u_theta_0;
    let x_rotor_frame_2_of_motion_0 = w_rotor_frame_3_of_u_phi_0
        * w_inner_frame_in_rotor_frame_1_of_u_theta_0;
    let x_rotor_frame_2_of_motion_2_0 = w_rotor_frame_3_of_u_phi_0
        * w_inner_frame_in_rotor_frame_1_of_u_theta_0;
    let x_rotor_frame_2_of_place_0 = alpha_rotor_frame_2_of_motion_0
        .mul_add(
            minus_b,
            x_rotor_frame_2_of_motion_2_0
                .mul_add(
                    minus_c,
                    x_rotor_frame_2_of_motion_0
                        .mul_add(B, B * alpha_inner_frame_in_rotor_frame_2_of_motion_0),
                ),
        );
    let x_rotor_frame_3_of_u_theta_0 = w_inner_frame_in_rotor_frame_2_of_u_theta_0
        * w_inner_frame_in_rotor_frame_1_of_u_theta_0;
    let x_rotor_frame_3_of_u_theta_2_0 = w_inner_frame_in_rotor_frame_2_of_u_theta_0
        * w_inner_frame_in_rotor_frame_1_of_u_theta_0;
    let sin_theta_sin_phi_0 = sin_theta_0 * sin_phi_0;
    let sin_theta_cos_phi_0 = sin_theta_0 * cos_phi_0;
    let sin_theta_sq_0 = sin_theta_0 * sin_theta_0;
    let cos_theta_sq_0 = cos_theta_0 * cos_theta_0;
    let sin_theta_sq_sin_phi_sq_0 = sin_theta_sin_phi_0 * sin_theta_sin_phi_0;
    let sin_theta_sq_cos_phi_sq_0 = sin_theta_cos_phi_0 * sin_theta_cos_phi_0;
    let u_psi_dot_of_theta_phi_0 = sin_theta_sin_phi_0 * cos_phi_0;
    let u_psi_dot_of_theta_phi_2_0 = sin_theta_cos_phi_0 * sin_phi_0;
    let u_psi_dot_of_place_0 = u_psi_dot_of_theta_phi_2_0
        .mul_add(minus_b, B * u_psi_dot_of_theta_phi_0);
    let u_psi_dot_of_u_theta_0 = sin_theta_0 * x_inner_frame_2_of_u_theta_0;
    let u_psi_dot_of_u_theta_2_0 = cos_theta_0 * x_inner_frame_3_of_u_theta_0;
    let u_psi_dot_of_place_2_0 = x_rotor_frame_1_of_place_0 * sin_theta_sin_phi_0;
    let u_psi_dot_of_place_3_0 = x_rotor_frame_2_of_place_0 * sin_theta_cos_phi_0;
    let u_psi_dot_of_theta_phi_3_0 = cos_phi_0 * sin_theta_sin_phi_0;
    let u_psi_dot_of_theta_phi_4_0 = sin_phi_0 * sin_theta_cos_phi_0;
    let u_psi_dot_of_place_4_0 = u_psi_dot_of_theta_phi_4_0
        .mul_add(minus_b, B * u_psi_dot_of_theta_phi_3_0);
    let cos_phi_sq_0 = cos_phi_0 * cos_phi_0;
    let sin_phi_sq_0 = sin_phi_0 * sin_phi_0;
    let u_psi_dot_of_place_5_0 = sin_phi_sq_0.mul_add(B, cos_phi_sq_0.mul_add(B, Ax));
    let over_u_psi_dot_of_place_5 = S::int(1) / u_psi_dot_of_place_5_0;
    let u_psi_dot_of_place_6_0 = cos_phi_0 * x_rotor_frame_1_of_place_0;
    let u_psi_dot_of_place_7_0 = sin_phi_0 * x_rotor_frame_2_of_place_0;
    let u_psi_dot_of_place_8_0 = u_psi_dot_of_place_0 * over_u_psi_dot_of_place_5;
    let u_psi_dot_of_place_9_0 = u_psi_dot_of_place_4_0 * u_psi_dot_of_place_8_0;
    let u_psi_dot_of_place_10_0 = sin_theta_sq_cos_phi_sq_0
        .mul_add(
            B,
            sin_theta_sq_sin_phi_sq_0
                .mul_add(B, cos_theta_sq_0.mul_add(Az, sin_theta_sq_0.mul_add(Ay, Iz))),
        ) - u_psi_dot_of_place_9_0;
    let over_u_psi_dot_of_place_10 = S::int(1) / u_psi_dot_of_place_10_0;
    let u_psi_dot_of_place_11_0 = x_inner_frame_1_of_place_0 - u_psi_dot_of_place_6_0
        - u_psi_dot_of_place_7_0;
    let u_psi_dot_of_place_12_0 = u_psi_dot_of_place_11_0 * u_psi_dot_of_place_8_0;
    let u_psi_dot_of_place_13_0 = u_psi_dot_of_u_theta_0 + u_psi_dot_of_u_theta_2_0
        + u_psi_dot_of_place_3_0 - u_psi_dot_of_place_2_0 - u_psi_dot_of_place_12_0;
    let u_psi_dot_of_place_14_0 = u_psi_dot_of_place_13_0 * over_u_psi_dot_of_place_10;
    let u_theta_dot_of_place_0 = u_psi_dot_of_place_14_0 * u_psi_dot_of_place_4_0;
    let u_theta_dot_of_u_psi_dot_0 = x_inner_frame_1_of_place_0 - u_psi_dot_of_place_6_0
        - u_psi_dot_of_place_7_0 - u_theta_dot_of_place_0;
    let u_theta_dot_of_u_psi_dot_2_0 = u_theta_dot_of_u_psi_dot_0 * over_u_psi_dot_of_place_5;
    let u_phi_dot_of_place_0 = u_psi_dot_of_place_14_0 * cos_theta_0;
    let u_phi_dot_of_u_psi_dot_0 = u_phi_dot_of_place_0
        .mul_add(
            C,
            x_rotor_frame_3_of_u_theta_2_0
                .mul_add(
                    minus_b,
                    x_rotor_frame_3_of_u_theta_0
                        .mul_add(B, C * u_psi_u_theta_sin_theta_0),
                ),
        );
    // Order 1: the rates, and what follows from them.
    let psi_1 = u_psi_0;
    let theta_1 = u_theta_0;
    let phi_1 = u_phi_0;
    let u_psi_1 = -u_psi_dot_of_place_14_0;
    let u_theta_1 = -u_theta_dot_of_u_psi_dot_2_0;
    let u_phi_1 = weight * u_phi_dot_of_u_psi_dot_0;
    if series.len() > 1 {
        series[1] = [psi_1, theta_1, phi_1, u_psi_1, u_theta_1, u_phi_1];
    }
    let sin_theta_1 = theta_1 * cos_theta_0;
    let cos_theta_1 = -theta_1 * sin_theta_0;
    let u_psi_sin_theta_1 = sin_theta_1.mul_add(u_psi_0, u_psi_1 * sin_theta_0);
    let u_psi_cos_theta_1 = cos_theta_1.mul_add(u_psi_0, u_psi_1 * cos_theta_0);
    let x_inner_frame_1_of_u_psi_1 = u_psi_cos_theta_1
        .mul_add(u_psi_sin_theta_0, u_psi_sin_theta_1 * u_psi_cos_theta_0);
    let x_inner_frame_1_of_u_psi_2_1 = u_psi_sin_theta_1
        .mul_add(u_psi_cos_theta_0, u_psi_cos_theta_1 * u_psi_sin_theta_0);
    let x_inner_frame_1_of_place_1 = x_inner_frame_1_of_u_psi_2_1
        .mul_add(minus_ay, Az * x_inner_frame_1_of_u_psi_1);
    let u_psi_u_theta_cos_theta_1 = u_psi_cos_theta_1
        .mul_add(u_theta_0, u_theta_1 * u_psi_cos_theta_0);
    let u_psi_u_theta_cos_theta_2_1 = u_psi_cos_theta_1
        .mul_add(u_theta_0, u_theta_1 * u_psi_cos_theta_0);
    let u_psi_u_theta_cos_theta_3_1 = u_psi_cos_theta_1
        .mul_add(u_theta_0, u_theta_1 * u_psi_cos_theta_0);
    let x_inner_frame_2_of_u_theta_1 = u_psi_u_theta_cos_theta_1
        .mul_add(
            Ay,
            u_psi_u_theta_cos_theta_3_1
                .mul_add(minus_az, Ax * u_psi_u_theta_cos_theta_2_1),
        );
    let u_psi_u_theta_sin_theta_1 = u_psi_sin_theta_1
        .mul_add(u_theta_0, u_theta_1 * u_psi_sin_theta_0);
    let u_psi_u_theta_sin_theta_2_1 = u_psi_sin_theta_1
        .mul_add(u_theta_0, u_theta_1 * u_psi_sin_theta_0);
    let u_psi_u_theta_sin_theta_3_1 = u_psi_sin_theta_1
        .mul_add(u_theta_0, u_theta_1 * u_psi_sin_theta_0);
    let x_inner_frame_3_of_u_theta_1 = u_psi_u_theta_sin_theta_1
        .mul_add(
            minus_az,
            u_psi_u_theta_sin_theta_3_1
                .mul_add(minus_ax, Ay * u_psi_u_theta_sin_theta_2_1),
        );
    let sin_phi_1 = phi_1 * cos_phi_0;
    let cos_phi_1 = -phi_1 * sin_phi_0;
    let u_theta_sin_phi_1 = sin_phi_1.mul_add(u_theta_0, u_theta_1 * sin_phi_0);
    let u_psi_sin_theta_cos_phi_1 = u_psi_sin_theta_1
        .mul_add(cos_phi_0, cos_phi_1 * u_psi_sin_theta_0);
    let w_inner_frame_in_rotor_frame_2_of_u_theta_1 = u_theta_sin_phi_1 - u_psi_sin_theta_cos_phi_1;
    let w_rotor_frame_3_of_u_phi_1 = u_phi_1 + u_psi_cos_theta_1;
    let alpha_inner_frame_in_rotor_frame_1_of_motion_1 = u_psi_u_theta_cos_theta_1
        .mul_add(sin_phi_0, sin_phi_1 * u_psi_u_theta_cos_theta_0);
    let alpha_rotor_frame_1_of_motion_1 = w_inner_frame_in_rotor_frame_2_of_u_theta_1
        .mul_add(u_phi_0, u_phi_1 * w_inner_frame_in_rotor_frame_2_of_u_theta_0);
    let x_rotor_frame_1_of_motion_1 = w_inner_frame_in_rotor_frame_2_of_u_theta_1
        .mul_add(
            w_rotor_frame_3_of_u_phi_0,
            w_rotor_frame_3_of_u_phi_1 * w_inner_frame_in_rotor_frame_2_of_u_theta_0,
        );
    let x_rotor_frame_1_of_motion_2_1 = w_inner_frame_in_rotor_frame_2_of_u_theta_1
        .mul_add(
            w_rotor_frame_3_of_u_phi_0,
            w_rotor_frame_3_of_u_phi_1 * w_inner_frame_in_rotor_frame_2_of_u_theta_0,
        );
    let x_rotor_frame_1_of_place_1 = alpha_rotor_frame_1_of_motion_1
        .mul_add(
            B,
            x_rotor_frame_1_of_motion_2_1
                .mul_add(
                    minus_b,
                    x_rotor_frame_1_of_motion_1
                        .mul_add(
                            C,
                            minus_b * alpha_inner_frame_in_rotor_frame_1_of_motion_1,
                        ),
                ),
        );
    let u_theta_cos_phi_1 = cos_phi_1.mul_add(u_theta_0, u_theta_1 * cos_phi_0);
    let u_psi_sin_theta_sin_phi_1 = u_psi_sin_theta_1
        .mul_add(sin_phi_0, sin_phi_1 * u_psi_sin_theta_0);
    let w_inner_frame_in_rotor_frame_1_of_u_theta_1 = u_theta_cos_phi_1 + u_psi_sin_theta_sin_phi_1;
    let alpha_inner_frame_in_rotor_frame_2_of_motion_1 = u_psi_u_theta_cos_theta_1
        .mul_add(cos_phi_0, cos_phi_1 * u_psi_u_theta_cos_theta_0);
    let alpha_rotor_frame_2_of_motion_1 = w_inner_frame_in_rotor_frame_1_of_u_theta_1
        .mul_add(u_phi_0, u_phi_1 * w_inner_frame_in_rotor_frame_1_of_u_theta_0);
    let x_rotor_frame_2_of_motion_1 = w_inner_frame_in_rotor_frame_1_of_u_theta_1
        .mul_add(
            w_rotor_frame_3_of_u_phi_0,
            w_rotor_frame_3_of_u_phi_1 * w_inner_frame_in_rotor_frame_1_of_u_theta_0,
        );
    let x_rotor_frame_2_of_motion_2_1 = w_inner_frame_in_rotor_frame_1_of_u_theta_1
        .mul_add(
            w_rotor_frame_3_of_u_phi_0,
            w_rotor_frame_3_of_u_phi_1 * w_inner_frame_in_rotor_frame_1_of_u_theta_0,
        );
    let x_rotor_frame_2_of_place_1 = alpha_rotor_frame_2_of_motion_1
        .mul_add(
            minus_b,
            x_rotor_frame_2_of_motion_2_1
                .mul_add(
                    minus_c,
                    x_rotor_frame_2_of_motion_1
                        .mul_add(B, B * alpha_inner_frame_in_rotor_frame_2_of_motion_1),
                ),
        );
    let x_rotor_frame_3_of_u_theta_1 = w_inner_frame_in_rotor_frame_1_of_u_theta_1
        .mul_add(
            w_inner_frame_in_rotor_frame_2_of_u_theta_0,
            w_inner_frame_in_rotor_frame_2_of_u_theta_1
                * w_inner_frame_in_rotor_frame_1_of_u_theta_0,
        );
    let x_rotor_frame_3_of_u_theta_2_1 = w_inner_frame_in_rotor_frame_1_of_u_theta_1
        .mul_add(
            w_inner_frame_in_rotor_frame_2_of_u_theta_0,
            w_inner_frame_in_rotor_frame_2_of_u_theta_1
                * w_inner_frame_in_rotor_frame_1_of_u_theta_0,
        );
    let sin_theta_sin_phi_1 = sin_phi_1.mul_add(sin_theta_0, sin_theta_1 * sin_phi_0);
    let sin_theta_cos_phi_1 = cos_phi_1.mul_add(sin_theta_0, sin_theta_1 * cos_phi_0);
    let sin_theta_sq_1 = sin_theta_1 * (sin_theta_0 + sin_theta_0);
    let cos_theta_sq_1 = cos_theta_1 * (cos_theta_0 + cos_theta_0);
    let sin_theta_sq_sin_phi_sq_1 = sin_theta_sin_phi_1
        * (sin_theta_sin_phi_0 + sin_theta_sin_phi_0);
    let sin_theta_sq_cos_phi_sq_1 = sin_theta_cos_phi_1
        * (sin_theta_cos_phi_0 + sin_theta_cos_phi_0);
    let u_psi_dot_of_theta_phi_1 = sin_theta_sin_phi_1
        .mul_add(cos_phi_0, cos_phi_1 * sin_theta_sin_phi_0);
    let u_psi_dot_of_theta_phi_2_1 = sin_theta_cos_phi_1
        .mul_add(sin_phi_0, sin_phi_1 * sin_theta_cos_phi_0);
    let u_psi_dot_of_place_1 = u_psi_dot_of_theta_phi_2_1
        .mul_add(minus_b, B * u_psi_dot_of_theta_phi_1);
    let u_psi_dot_of_u_theta_1 = x_inner_frame_2_of_u_theta_1
        .mul_add(sin_theta_0, sin_theta_1 * x_inner_frame_2_of_u_theta_0);
    let u_psi_dot_of_u_theta_2_1 = x_inner_frame_3_of_u_theta_1
        .mul_add(cos_theta_0, cos_theta_1 * x_inner_frame_3_of_u_theta_0);
    let u_psi_dot_of_place_2_1 = x_rotor_frame_1_of_place_1
        .mul_add(sin_theta_sin_phi_0, sin_theta_sin_phi_1 * x_rotor_frame_1_of_place_0);
    let u_psi_dot_of_place_3_1 = x_rotor_frame_2_of_place_1
        .mul_add(sin_theta_cos_phi_0, sin_theta_cos_phi_1 * x_rotor_frame_2_of_place_0);
    let u_psi_dot_of_theta_phi_3_1 = sin_theta_sin_phi_1
        .mul_add(cos_phi_0, cos_phi_1 * sin_theta_sin_phi_0);
    let u_psi_dot_of_theta_phi_4_1 = sin_theta_cos_phi_1
        .mul_add(sin_phi_0, sin_phi_1 * sin_theta_cos_phi_0);
    let u_psi_dot_of_place_4_1 = u_psi_dot_of_theta_phi_4_1
        .mul_add(minus_b, B * u_psi_dot_of_theta_phi_3_1);
    let cos_phi_sq_1 = cos_phi_1 * (cos_phi_0 + cos_phi_0);
    let sin_phi_sq_1 = sin_phi_1 * (sin_phi_0 + sin_phi_0);
    let u_psi_dot_of_place_5_1 = sin_phi_sq_1.mul_add(B, B * cos_phi_sq_1);
    let u_psi_dot_of_place_6_1 = x_rotor_frame_1_of_place_1
        .mul_add(cos_phi_0, cos_phi_1 * x_rotor_frame_1_of_place_0);
    let u_psi_dot_of_place_7_1 = x_rotor_frame_2_of_place_1
        .mul_add(sin_phi_0, sin_phi_1 * x_rotor_frame_2_of_place_0);
    let u_psi_dot_of_place_8_1 = u_psi_dot_of_place_5_1
        .mul_add(
            -(u_psi_dot_of_place_8_0 * over_u_psi_dot_of_place_5),
            u_psi_dot_of_place_1 * over_u_psi_dot_of_place_5,
        );
    let u_psi_dot_of_place_9_1 = u_psi_dot_of_place_8_1
        .mul_add(
            u_psi_dot_of_place_4_0,
            u_psi_dot_of_place_4_1 * u_psi_dot_of_place_8_0,
        );
    let u_psi_dot_of_place_10_1 = sin_theta_sq_cos_phi_sq_1
        .mul_add(
            B,
            sin_theta_sq_sin_phi_sq_1
                .mul_add(B, cos_theta_sq_1.mul_add(Az, Ay * sin_theta_sq_1)),
        ) - u_psi_dot_of_place_9_1;
    let u_psi_dot_of_place_11_1 = x_inner_frame_1_of_place_1 - u_psi_dot_of_place_6_1
        - u_psi_dot_of_place_7_1;
    let u_psi_dot_of_place_12_1 = u_psi_dot_of_place_11_1
        .mul_add(
            u_psi_dot_of_place_8_0,
            u_psi_dot_of_place_8_1 * u_psi_dot_of_place_11_0,
        );
    let u_psi_dot_of_place_13_1 = u_psi_dot_of_u_theta_1 + u_psi_dot_of_u_theta_2_1
        + u_psi_dot_of_place_3_1 - u_psi_dot_of_place_2_1 - u_psi_dot_of_place_12_1;
    let u_psi_dot_of_place_14_1 = u_psi_dot_of_place_10_1
        .mul_add(
            -(u_psi_dot_of_place_14_0 * over_u_psi_dot_of_place_10),
            u_psi_dot_of_place_13_1 * over_u_psi_dot_of_place_10,
        );
    let u_theta_dot_of_place_1 = u_psi_dot_of_place_14_1
        .mul_add(
            u_psi_dot_of_place_4_0,
            u_psi_dot_of_place_4_1 * u_psi_dot_of_place_14_0,
        );
    let u_theta_dot_of_u_psi_dot_1 = x_inner_frame_1_of_place_1 - u_psi_dot_of_place_6_1
        - u_psi_dot_of_place_7_1 - u_theta_dot_of_place_1;
    let u_theta_dot_of_u_psi_dot_2_1 = u_psi_dot_of_place_5_1
        .mul_add(
            -(u_theta_dot_of_u_psi_dot_2_0 * over_u_psi_dot_of_place_5),
            u_theta_dot_of_u_psi_dot_1 * over_u_psi_dot_of_place_5,
        );
    let u_phi_dot_of_place_1 = u_psi_dot_of_place_14_1
        .mul_add(cos_theta_0, cos_theta_1 * u_psi_dot_of_place_14_0);
    let u_phi_dot_of_u_psi_dot_1 = u_phi_dot_of_place_1
        .mul_add(
            C,
            x_rotor_frame_3_of_u_theta_2_1
                .mul_add(
                    minus_b,
                    x_rotor_frame_3_of_u_theta_1
                        .mul_add(B, C * u_psi_u_theta_sin_theta_1),
                ),
        );
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                theta_1, theta_1, u_psi_1, u_psi_1, u_psi_sin_theta_1, u_psi_cos_theta_1, u_theta_1,
                u_psi_cos_theta_1, u_theta_1, u_theta_1, u_theta_1, u_psi_sin_theta_1, phi_1, phi_1,
                u_theta_1, cos_phi_1, sin_phi_1, u_phi_1,
                w_inner_frame_in_rotor_frame_2_of_u_theta_1, w_rotor_frame_3_of_u_phi_1, u_theta_1,
                sin_phi_1, cos_phi_1, u_phi_1, w_rotor_frame_3_of_u_phi_1,
                w_rotor_frame_3_of_u_phi_1, w_inner_frame_in_rotor_frame_2_of_u_theta_1,
                w_inner_frame_in_rotor_frame_2_of_u_theta_1, sin_theta_1, sin_theta_1, sin_theta_1,
                cos_theta_1, sin_theta_sin_phi_1, sin_theta_cos_phi_1, sin_theta_sin_phi_1,
                sin_theta_cos_phi_1, sin_theta_1, cos_theta_1, x_rotor_frame_1_of_place_1,
                x_rotor_frame_2_of_place_1, cos_phi_1, sin_phi_1, cos_phi_1, sin_phi_1, cos_phi_1,
                sin_phi_1, u_psi_dot_of_place_5_1, u_psi_dot_of_place_4_1, u_psi_dot_of_place_11_1,
                u_psi_dot_of_place_10_1, u_psi_dot_of_place_14_1, u_psi_dot_of_place_5_1,
                u_psi_dot_of_place_14_1,
            ]),
            padded([
                cos_theta_1, sin_theta_1, sin_theta_1, cos_theta_1, u_psi_cos_theta_1,
                u_psi_sin_theta_1, u_psi_cos_theta_1, u_theta_1, u_psi_cos_theta_1,
                u_psi_sin_theta_1, u_psi_sin_theta_1, u_theta_1, cos_phi_1, sin_phi_1, sin_phi_1,
                u_psi_sin_theta_1, u_psi_u_theta_cos_theta_1,
                w_inner_frame_in_rotor_frame_2_of_u_theta_1, w_rotor_frame_3_of_u_phi_1,
                w_inner_frame_in_rotor_frame_2_of_u_theta_1, cos_phi_1, u_psi_sin_theta_1,
                u_psi_u_theta_cos_theta_1, w_inner_frame_in_rotor_frame_1_of_u_theta_1,
                w_inner_frame_in_rotor_frame_1_of_u_theta_1,
                w_inner_frame_in_rotor_frame_1_of_u_theta_1,
                w_inner_frame_in_rotor_frame_1_of_u_theta_1,
                w_inner_frame_in_rotor_frame_1_of_u_theta_1, sin_phi_1, cos_phi_1, sin_theta_1,
                cos_theta_1, sin_theta_sin_phi_1, sin_theta_cos_phi_1, cos_phi_1, sin_phi_1,
                x_inner_frame_2_of_u_theta_1, x_inner_frame_3_of_u_theta_1, sin_theta_sin_phi_1,
                sin_theta_cos_phi_1, sin_theta_sin_phi_1, sin_theta_cos_phi_1, cos_phi_1, sin_phi_1,
                x_rotor_frame_1_of_place_1, x_rotor_frame_2_of_place_1, u_psi_dot_of_place_8_1,
                u_psi_dot_of_place_8_1, u_psi_dot_of_place_8_1, u_psi_dot_of_place_14_1,
                u_psi_dot_of_place_4_1, u_theta_dot_of_u_psi_dot_2_1, cos_theta_1,
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
    let mut u_psi_u_theta_cos_theta_last = u_psi_u_theta_cos_theta_1;
    let mut x_inner_frame_2_of_u_theta_last = x_inner_frame_2_of_u_theta_1;
    let mut x_inner_frame_3_of_u_theta_last = x_inner_frame_3_of_u_theta_1;
    let mut sin_phi_last = sin_phi_1;
    let mut cos_phi_last = cos_phi_1;
    let mut w_inner_frame_in_rotor_frame_2_of_u_theta_last = w_inner_frame_in_rotor_frame_2_of_u_theta_1;
    let mut w_rotor_frame_3_of_u_phi_last = w_rotor_frame_3_of_u_phi_1;
    let mut x_rotor_frame_1_of_place_last = x_rotor_frame_1_of_place_1;
    let mut w_inner_frame_in_rotor_frame_1_of_u_theta_last = w_inner_frame_in_rotor_frame_1_of_u_theta_1;
    let mut x_rotor_frame_2_of_place_last = x_rotor_frame_2_of_place_1;
    let mut sin_theta_sin_phi_last = sin_theta_sin_phi_1;
    let mut sin_theta_cos_phi_last = sin_theta_cos_phi_1;
    let mut u_psi_dot_of_place_4_last = u_psi_dot_of_place_4_1;
    let mut u_psi_dot_of_place_5_last = u_psi_dot_of_place_5_1;
    let mut u_psi_dot_of_place_8_last = u_psi_dot_of_place_8_1;
    let mut u_psi_dot_of_place_10_last = u_psi_dot_of_place_10_1;
    let mut u_psi_dot_of_place_11_last = u_psi_dot_of_place_11_1;
    let mut u_psi_dot_of_place_14_last = u_psi_dot_of_place_14_1;
    let mut u_theta_dot_of_u_psi_dot_2_last = u_theta_dot_of_u_psi_dot_2_1;
    let mut next = [S::int(0); 56];
    // Rates at order k - 1.
    let mut psi_rate = u_psi_1;
    let mut theta_rate = u_theta_1;
    let mut phi_rate = u_phi_1;
    let mut u_psi_rate = -u_psi_dot_of_place_14_1;
    let mut u_theta_rate = -u_theta_dot_of_u_psi_dot_2_1;
    let mut u_phi_rate = weight * u_phi_dot_of_u_psi_dot_1;
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
                u_psi_sin_theta_1
                    .mul_add(
                        u_psi_cos_theta_last,
                        u_psi_sin_theta_last.mul_add(u_psi_cos_theta_1, next[4]),
                    ),
                u_psi_cos_theta_1
                    .mul_add(
                        u_psi_sin_theta_last,
                        u_psi_cos_theta_last.mul_add(u_psi_sin_theta_1, next[5]),
                    ),
                u_theta_1
                    .mul_add(
                        u_psi_cos_theta_last,
                        u_theta_last.mul_add(u_psi_cos_theta_1, next[6]),
                    ),
                u_psi_cos_theta_1
                    .mul_add(
                        u_theta_last,
                        u_psi_cos_theta_last.mul_add(u_theta_1, next[7]),
                    ),
                u_theta_1
                    .mul_add(
                        u_psi_cos_theta_last,
                        u_theta_last.mul_add(u_psi_cos_theta_1, next[8]),
                    ),
                u_theta_1
                    .mul_add(
                        u_psi_sin_theta_last,
                        u_theta_last.mul_add(u_psi_sin_theta_1, next[9]),
                    ),
                u_theta_1
                    .mul_add(
                        u_psi_sin_theta_last,
                        u_theta_last.mul_add(u_psi_sin_theta_1, next[10]),
                    ),
                u_psi_sin_theta_1
                    .mul_add(
                        u_theta_last,
                        u_psi_sin_theta_last.mul_add(u_theta_1, next[11]),
                    ),
                phi_1
                    .mul_add(
                        cos_phi_last,
                        (count_last * phi_last).mul_add(cos_phi_1, next[12]),
                    ),
                phi_1
                    .mul_add(
                        sin_phi_last,
                        (count_last * phi_last).mul_add(sin_phi_1, next[13]),
                    ),
                u_theta_1
                    .mul_add(sin_phi_last, u_theta_last.mul_add(sin_phi_1, next[14])),
                cos_phi_1
                    .mul_add(
                        u_psi_sin_theta_last,
                        cos_phi_last.mul_add(u_psi_sin_theta_1, next[15]),
                    ),
                sin_phi_1
                    .mul_add(
                        u_psi_u_theta_cos_theta_last,
                        sin_phi_last.mul_add(u_psi_u_theta_cos_theta_1, next[16]),
                    ),
                u_phi_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_2_of_u_theta_last,
                        u_phi_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_2_of_u_theta_1, next[17],
                            ),
                    ),
                w_inner_frame_in_rotor_frame_2_of_u_theta_1
                    .mul_add(
                        w_rotor_frame_3_of_u_phi_last,
                        w_inner_frame_in_rotor_frame_2_of_u_theta_last
                            .mul_add(w_rotor_frame_3_of_u_phi_1, next[18]),
                    ),
                w_rotor_frame_3_of_u_phi_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_2_of_u_theta_last,
                        w_rotor_frame_3_of_u_phi_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_2_of_u_theta_1, next[19],
                            ),
                    ),
                u_theta_1
                    .mul_add(cos_phi_last, u_theta_last.mul_add(cos_phi_1, next[20])),
                sin_phi_1
                    .mul_add(
                        u_psi_sin_theta_last,
                        sin_phi_last.mul_add(u_psi_sin_theta_1, next[21]),
                    ),
                cos_phi_1
                    .mul_add(
                        u_psi_u_theta_cos_theta_last,
                        cos_phi_last.mul_add(u_psi_u_theta_cos_theta_1, next[22]),
                    ),
                u_phi_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_1_of_u_theta_last,
                        u_phi_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_1_of_u_theta_1, next[23],
                            ),
                    ),
                w_rotor_frame_3_of_u_phi_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_1_of_u_theta_last,
                        w_rotor_frame_3_of_u_phi_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_1_of_u_theta_1, next[24],
                            ),
                    ),
                w_rotor_frame_3_of_u_phi_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_1_of_u_theta_last,
                        w_rotor_frame_3_of_u_phi_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_1_of_u_theta_1, next[25],
                            ),
                    ),
                w_inner_frame_in_rotor_frame_2_of_u_theta_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_1_of_u_theta_last,
                        w_inner_frame_in_rotor_frame_2_of_u_theta_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_1_of_u_theta_1, next[26],
                            ),
                    ),
                w_inner_frame_in_rotor_frame_2_of_u_theta_1
                    .mul_add(
                        w_inner_frame_in_rotor_frame_1_of_u_theta_last,
                        w_inner_frame_in_rotor_frame_2_of_u_theta_last
                            .mul_add(
                                w_inner_frame_in_rotor_frame_1_of_u_theta_1, next[27],
                            ),
                    ),
                sin_theta_1
                    .mul_add(sin_phi_last, sin_theta_last.mul_add(sin_phi_1, next[28])),
                sin_theta_1
                    .mul_add(cos_phi_last, sin_theta_last.mul_add(cos_phi_1, next[29])),
                (sin_theta_1 + sin_theta_1).mul_add(sin_theta_last, next[30]),
                (cos_theta_1 + cos_theta_1).mul_add(cos_theta_last, next[31]),
                (sin_theta_sin_phi_1 + sin_theta_sin_phi_1)
                    .mul_add(sin_theta_sin_phi_last, next[32]),
                (sin_theta_cos_phi_1 + sin_theta_cos_phi_1)
                    .mul_add(sin_theta_cos_phi_last, next[33]),
                sin_theta_sin_phi_1
                    .mul_add(
                        cos_phi_last,
                        sin_theta_sin_phi_last.mul_add(cos_phi_1, next[34]),
                    ),
                sin_theta_cos_phi_1
                    .mul_add(
                        sin_phi_last,
                        sin_theta_cos_phi_last.mul_add(sin_phi_1, next[35]),
                    ),
                sin_theta_1
                    .mul_add(
                        x_inner_frame_2_of_u_theta_last,
                        sin_theta_last.mul_add(x_inner_frame_2_of_u_theta_1, next[36]),
                    ),
                cos_theta_1
                    .mul_add(
                        x_inner_frame_3_of_u_theta_last,
                        cos_theta_last.mul_add(x_inner_frame_3_of_u_theta_1, next[37]),
                    ),
                x_rotor_frame_1_of_place_1
                    .mul_add(
                        sin_theta_sin_phi_last,
                        x_rotor_frame_1_of_place_last
                            .mul_add(sin_theta_sin_phi_1, next[38]),
                    ),
                x_rotor_frame_2_of_place_1
                    .mul_add(
                        sin_theta_cos_phi_last,
                        x_rotor_frame_2_of_place_last
                            .mul_add(sin_theta_cos_phi_1, next[39]),
                    ),
                cos_phi_1
                    .mul_add(
                        sin_theta_sin_phi_last,
                        cos_phi_last.mul_add(sin_theta_sin_phi_1, next[40]),
                    ),
                sin_phi_1
                    .mul_add(
                        sin_theta_cos_phi_last,
                        sin_phi_last.mul_add(sin_theta_cos_phi_1, next[41]),
                    ),
                (cos_phi_1 + cos_phi_1).mul_add(cos_phi_last, next[42]),
                (sin_phi_1 + sin_phi_1).mul_add(sin_phi_last, next[43]),
                cos_phi_1
                    .mul_add(
                        x_rotor_frame_1_of_place_last,
                        cos_phi_last.mul_add(x_rotor_frame_1_of_place_1, next[44]),
                    ),
                sin_phi_1
                    .mul_add(
                        x_rotor_frame_2_of_place_last,
                        sin_phi_last.mul_add(x_rotor_frame_2_of_place_1, next[45]),
                    ),
                u_psi_dot_of_place_5_1
                    .mul_add(
                        u_psi_dot_of_place_8_last,
                        u_psi_dot_of_place_5_last
                            .mul_add(u_psi_dot_of_place_8_1, next[46]),
                    ),
                u_psi_dot_of_place_4_1
                    .mul_add(
                        u_psi_dot_of_place_8_last,
                        u_psi_dot_of_place_4_last
                            .mul_add(u_psi_dot_of_place_8_1, next[47]),
                    ),
                u_psi_dot_of_place_11_1
                    .mul_add(
                        u_psi_dot_of_place_8_last,
                        u_psi_dot_of_place_11_last
                            .mul_add(u_psi_dot_of_place_8_1, next[48]),
                    ),
                u_psi_dot_of_place_10_1
                    .mul_add(
                        u_psi_dot_of_place_14_last,
                        u_psi_dot_of_place_10_last
                            .mul_add(u_psi_dot_of_place_14_1, next[49]),
                    ),
                u_psi_dot_of_place_14_1
                    .mul_add(
                        u_psi_dot_of_place_4_last,
                        u_psi_dot_of_place_14_last
                            .mul_add(u_psi_dot_of_place_4_1, next[50]),
                    ),
                u_psi_dot_of_place_5_1
                    .mul_add(
                        u_theta_dot_of_u_psi_dot_2_last,
                        u_psi_dot_of_place_5_last
                            .mul_add(u_theta_dot_of_u_psi_dot_2_1, next[51]),
                    ),
                u_psi_dot_of_place_14_1
                    .mul_add(
                        cos_theta_last,
                        u_psi_dot_of_place_14_last.mul_add(cos_theta_1, next[52]),
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
        // x_inner_frame_1_of_u_psi = u_psi_sin_theta*u_psi_cos_theta
        let x_inner_frame_1_of_u_psi = u_psi_cos_theta
            .mul_add(
                u_psi_sin_theta_0,
                u_psi_sin_theta.mul_add(u_psi_cos_theta_0, sums[4]),
            );
        // x_inner_frame_1_of_u_psi_2 = u_psi_cos_theta*u_psi_sin_theta
        let x_inner_frame_1_of_u_psi_2 = u_psi_sin_theta
            .mul_add(
                u_psi_cos_theta_0,
                u_psi_cos_theta.mul_add(u_psi_sin_theta_0, sums[5]),
            );
        // x_inner_frame_1_of_place = Az*x_inner_frame_1_of_u_psi + minus_ay*x_inner_frame_1_of_u_psi_2
        let x_inner_frame_1_of_place = x_inner_frame_1_of_u_psi_2
            .mul_add(minus_ay, Az * x_inner_frame_1_of_u_psi);
        // u_psi_u_theta_cos_theta = u_theta*u_psi_cos_theta
        let u_psi_u_theta_cos_theta = u_psi_cos_theta
            .mul_add(u_theta_0, u_theta.mul_add(u_psi_cos_theta_0, sums[6]));
        // u_psi_u_theta_cos_theta_2 = u_psi_cos_theta*u_theta
        let u_psi_u_theta_cos_theta_2 = u_psi_cos_theta
            .mul_add(u_theta_0, u_theta.mul_add(u_psi_cos_theta_0, sums[7]));
        // u_psi_u_theta_cos_theta_3 = u_theta*u_psi_cos_theta
        let u_psi_u_theta_cos_theta_3 = u_psi_cos_theta
            .mul_add(u_theta_0, u_theta.mul_add(u_psi_cos_theta_0, sums[8]));
        // x_inner_frame_2_of_u_theta = Ax*u_psi_u_theta_cos_theta_2 + minus_az*u_psi_u_theta_cos_theta_3 +
        //   Ay*u_psi_u_theta_cos_theta
        let x_inner_frame_2_of_u_theta = u_psi_u_theta_cos_theta
            .mul_add(
                Ay,
                u_psi_u_theta_cos_theta_3
                    .mul_add(minus_az, Ax * u_psi_u_theta_cos_theta_2),
            );
        // u_psi_u_theta_sin_theta = u_theta*u_psi_sin_theta
        let u_psi_u_theta_sin_theta = u_psi_sin_theta
            .mul_add(u_theta_0, u_theta.mul_add(u_psi_sin_theta_0, sums[9]));
        // u_psi_u_theta_sin_theta_2 = u_theta*u_psi_sin_theta
        let u_psi_u_theta_sin_theta_2 = u_psi_sin_theta
            .mul_add(u_theta_0, u_theta.mul_add(u_psi_sin_theta_0, sums[10]));
        // u_psi_u_theta_sin_theta_3 = u_psi_sin_theta*u_theta
        let u_psi_u_theta_sin_theta_3 = u_psi_sin_theta
            .mul_add(u_theta_0, u_theta.mul_add(u_psi_sin_theta_0, sums[11]));
        // x_inner_frame_3_of_u_theta = Ay*u_psi_u_theta_sin_theta_2 + minus_ax*u_psi_u_theta_sin_theta_3 +
        //   minus_az*u_psi_u_theta_sin_theta
        let x_inner_frame_3_of_u_theta = u_psi_u_theta_sin_theta
            .mul_add(
                minus_az,
                u_psi_u_theta_sin_theta_3
                    .mul_add(minus_ax, Ay * u_psi_u_theta_sin_theta_2),
            );
        // sin_phi = sin(phi)
        let sin_phi = phi.mul_add(cos_phi_0, sums[12] * over_k);
        // cos_phi = cos(phi)
        let cos_phi = -phi.mul_add(sin_phi_0, sums[13] * over_k);
        // u_theta_sin_phi = u_theta*sin_phi
        let u_theta_sin_phi = sin_phi
            .mul_add(u_theta_0, u_theta.mul_add(sin_phi_0, sums[14]));
        // u_psi_sin_theta_cos_phi = cos_phi*u_psi_sin_theta
        let u_psi_sin_theta_cos_phi = u_psi_sin_theta
            .mul_add(cos_phi_0, cos_phi.mul_add(u_psi_sin_theta_0, sums[15]));
        // w_inner_frame_in_rotor_frame_2_of_u_theta = u_theta_sin_phi - u_psi_sin_theta_cos_phi
        let w_inner_frame_in_rotor_frame_2_of_u_theta = u_theta_sin_phi - u_psi_sin_theta_cos_phi;
        // w_rotor_frame_3_of_u_phi = u_phi + u_psi_cos_theta
        let w_rotor_frame_3_of_u_phi = u_phi + u_psi_cos_theta;
        // alpha_inner_frame_in_rotor_frame_1_of_motion = sin_phi*u_psi_u_theta_cos_theta
        let alpha_inner_frame_in_rotor_frame_1_of_motion = u_psi_u_theta_cos_theta
            .mul_add(sin_phi_0, sin_phi.mul_add(u_psi_u_theta_cos_theta_0, sums[16]));
        // alpha_rotor_frame_1_of_motion = u_phi*w_inner_frame_in_rotor_frame_2_of_u_theta
        let alpha_rotor_frame_1_of_motion = w_inner_frame_in_rotor_frame_2_of_u_theta
            .mul_add(
                u_phi_0,
                u_phi.mul_add(w_inner_frame_in_rotor_frame_2_of_u_theta_0, sums[17]),
            );
        // x_rotor_frame_1_of_motion = w_inner_frame_in_rotor_frame_2_of_u_theta*w_rotor_frame_3_of_u_phi
        let x_rotor_frame_1_of_motion = w_inner_frame_in_rotor_frame_2_of_u_theta
            .mul_add(
                w_rotor_frame_3_of_u_phi_0,
                w_rotor_frame_3_of_u_phi
                    .mul_add(w_inner_frame_in_rotor_frame_2_of_u_theta_0, sums[18]),
            );
        // x_rotor_frame_1_of_motion_2 = w_rotor_frame_3_of_u_phi*w_inner_frame_in_rotor_frame_2_of_u_theta
        let x_rotor_frame_1_of_motion_2 = w_inner_frame_in_rotor_frame_2_of_u_theta
            .mul_add(
                w_rotor_frame_3_of_u_phi_0,
                w_rotor_frame_3_of_u_phi
                    .mul_add(w_inner_frame_in_rotor_frame_2_of_u_theta_0, sums[19]),
            );
        // x_rotor_frame_1_of_place = C*x_rotor_frame_1_of_motion + minus_b*x_rotor_frame_1_of_motion_2 +
        //   minus_b*alpha_inner_frame_in_rotor_frame_1_of_motion + B*alpha_rotor_frame_1_of_motion
        let x_rotor_frame_1_of_place = alpha_rotor_frame_1_of_motion
            .mul_add(
                B,
                x_rotor_frame_1_of_motion_2
                    .mul_add(
                        minus_b,
                        x_rotor_frame_1_of_motion
                            .mul_add(
                                C,
                                minus_b * alpha_inner_frame_in_rotor_frame_1_of_motion,
                            ),
                    ),
            );
        // u_theta_cos_phi = u_theta*cos_phi
        let u_theta_cos_phi = cos_phi
            .mul_add(u_theta_0, u_theta.mul_add(cos_phi_0, sums[20]));
        // u_psi_sin_theta_sin_phi = sin_phi*u_psi_sin_theta
        let u_psi_sin_theta_sin_phi = u_psi_sin_theta
            .mul_add(sin_phi_0, sin_phi.mul_add(u_psi_sin_theta_0, sums[21]));
        // w_inner_frame_in_rotor_frame_1_of_u_theta = u_theta_cos_phi + u_psi_sin_theta_sin_phi
        let w_inner_frame_in_rotor_frame_1_of_u_theta = u_theta_cos_phi + u_psi_sin_theta_sin_phi;
        // alpha_inner_frame_in_rotor_frame_2_of_motion = cos_phi*u_psi_u_theta_cos_theta
        let alpha_inner_frame_in_rotor_frame_2_of_motion = u_psi_u_theta_cos_theta
            .mul_add(cos_phi_0, cos_phi.mul_add(u_psi_u_theta_cos_theta_0, sums[22]));
        // alpha_rotor_frame_2_of_motion = u_phi*w_inner_frame_in_rotor_frame_1_of_u_theta
        let alpha_rotor_frame_2_of_motion = w_inner_frame_in_rotor_frame_1_of_u_theta
            .mul_add(
                u_phi_0,
                u_phi.mul_add(w_inner_frame_in_rotor_frame_1_of_u_theta_0, sums[23]),
            );
        // x_rotor_frame_2_of_motion = w_rotor_frame_3_of_u_phi*w_inner_frame_in_rotor_frame_1_of_u_theta
        let x_rotor_frame_2_of_motion = w_inner_frame_in_rotor_frame_1_of_u_theta
            .mul_add(
                w_rotor_frame_3_of_u_phi_0,
                w_rotor_frame_3_of_u_phi
                    .mul_add(w_inner_frame_in_rotor_frame_1_of_u_theta_0, sums[24]),
            );
        // x_rotor_frame_2_of_motion_2 = w_rotor_frame_3_of_u_phi*w_inner_frame_in_rotor_frame_1_of_u_theta
        let x_rotor_frame_2_of_motion_2 = w_inner_frame_in_rotor_frame_1_of_u_theta
            .mul_add(
                w_rotor_frame_3_of_u_phi_0,
                w_rotor_frame_3_of_u_phi
                    .mul_add(w_inner_frame_in_rotor_frame_1_of_u_theta_0, sums[25]),
            );
        // x_rotor_frame_2_of_place = B*x_rotor_frame_2_of_motion + minus_c*x_rotor_frame_2_of_motion_2 +
        //   B*alpha_inner_frame_in_rotor_frame_2_of_motion + minus_b*alpha_rotor_frame_2_of_motion
        let x_rotor_frame_2_of_place = alpha_rotor_frame_2_of_motion
            .mul_add(
                minus_b,
                x_rotor_frame_2_of_motion_2
                    .mul_add(
                        minus_c,
                        x_rotor_frame_2_of_motion
                            .mul_add(B, B * alpha_inner_frame_in_rotor_frame_2_of_motion),
                    ),
            );
        // x_rotor_frame_3_of_u_theta =
        //   w_inner_frame_in_rotor_frame_2_of_u_theta*w_inner_frame_in_rotor_frame_1_of_u_theta
        let x_rotor_frame_3_of_u_theta = w_inner_frame_in_rotor_frame_1_of_u_theta
            .mul_add(
                w_inner_frame_in_rotor_frame_2_of_u_theta_0,
                w_inner_frame_in_rotor_frame_2_of_u_theta
                    .mul_add(w_inner_frame_in_rotor_frame_1_of_u_theta_0, sums[26]),
            );
        // x_rotor_frame_3_of_u_theta_2 =
        //   w_inner_frame_in_rotor_frame_2_of_u_theta*w_inner_frame_in_rotor_frame_1_of_u_theta
        let x_rotor_frame_3_of_u_theta_2 = w_inner_frame_in_rotor_frame_1_of_u_theta
            .mul_add(
                w_inner_frame_in_rotor_frame_2_of_u_theta_0,
                w_inner_frame_in_rotor_frame_2_of_u_theta
                    .mul_add(w_inner_frame_in_rotor_frame_1_of_u_theta_0, sums[27]),
            );
        // sin_theta_sin_phi = sin_theta*sin_phi
        let sin_theta_sin_phi = sin_phi
            .mul_add(sin_theta_0, sin_theta.mul_add(sin_phi_0, sums[28]));
        // sin_theta_cos_phi = sin_theta*cos_phi
        let sin_theta_cos_phi = cos_phi
            .mul_add(sin_theta_0, sin_theta.mul_add(cos_phi_0, sums[29]));
        // sin_theta_sq = sin_theta*sin_theta
        let sin_theta_sq = sin_theta.mul_add(sin_theta_0 + sin_theta_0, sums[30]);
        // cos_theta_sq = cos_theta*cos_theta
        let cos_theta_sq = cos_theta.mul_add(cos_theta_0 + cos_theta_0, sums[31]);
        // sin_theta_sq_sin_phi_sq = sin_theta_sin_phi*sin_theta_sin_phi
        let sin_theta_sq_sin_phi_sq = sin_theta_sin_phi
            .mul_add(sin_theta_sin_phi_0 + sin_theta_sin_phi_0, sums[32]);
        // sin_theta_sq_cos_phi_sq = sin_theta_cos_phi*sin_theta_cos_phi
        let sin_theta_sq_cos_phi_sq = sin_theta_cos_phi
            .mul_add(sin_theta_cos_phi_0 + sin_theta_cos_phi_0, sums[33]);
        // u_psi_dot_of_theta_phi = sin_theta_sin_phi*cos_phi
        let u_psi_dot_of_theta_phi = sin_theta_sin_phi
            .mul_add(cos_phi_0, cos_phi.mul_add(sin_theta_sin_phi_0, sums[34]));
        // u_psi_dot_of_theta_phi_2 = sin_theta_cos_phi*sin_phi
        let u_psi_dot_of_theta_phi_2 = sin_theta_cos_phi
            .mul_add(sin_phi_0, sin_phi.mul_add(sin_theta_cos_phi_0, sums[35]));
        // u_psi_dot_of_place = B*u_psi_dot_of_theta_phi + minus_b*u_psi_dot_of_theta_phi_2
        let u_psi_dot_of_place = u_psi_dot_of_theta_phi_2
            .mul_add(minus_b, B * u_psi_dot_of_theta_phi);
        // u_psi_dot_of_u_theta = sin_theta*x_inner_frame_2_of_u_theta
        let u_psi_dot_of_u_theta = x_inner_frame_2_of_u_theta
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(x_inner_frame_2_of_u_theta_0, sums[36]),
            );
        // u_psi_dot_of_u_theta_2 = cos_theta*x_inner_frame_3_of_u_theta
        let u_psi_dot_of_u_theta_2 = x_inner_frame_3_of_u_theta
            .mul_add(
                cos_theta_0,
                cos_theta.mul_add(x_inner_frame_3_of_u_theta_0, sums[37]),
            );
        // u_psi_dot_of_place_2 = x_rotor_frame_1_of_place*sin_theta_sin_phi
        let u_psi_dot_of_place_2 = x_rotor_frame_1_of_place
            .mul_add(
                sin_theta_sin_phi_0,
                sin_theta_sin_phi.mul_add(x_rotor_frame_1_of_place_0, sums[38]),
            );
        // u_psi_dot_of_place_3 = x_rotor_frame_2_of_place*sin_theta_cos_phi
        let u_psi_dot_of_place_3 = x_rotor_frame_2_of_place
            .mul_add(
                sin_theta_cos_phi_0,
                sin_theta_cos_phi.mul_add(x_rotor_frame_2_of_place_0, sums[39]),
            );
        // u_psi_dot_of_theta_phi_3 = cos_phi*sin_theta_sin_phi
        let u_psi_dot_of_theta_phi_3 = sin_theta_sin_phi
            .mul_add(cos_phi_0, cos_phi.mul_add(sin_theta_sin_phi_0, sums[40]));
        // u_psi_dot_of_theta_phi_4 = sin_phi*sin_theta_cos_phi
        let u_psi_dot_of_theta_phi_4 = sin_theta_cos_phi
            .mul_add(sin_phi_0, sin_phi.mul_add(sin_theta_cos_phi_0, sums[41]));
        // u_psi_dot_of_place_4 = B*u_psi_dot_of_theta_phi_3 + minus_b*u_psi_dot_of_theta_phi_4
        let u_psi_dot_of_place_4 = u_psi_dot_of_theta_phi_4
            .mul_add(minus_b, B * u_psi_dot_of_theta_phi_3);
        // cos_phi_sq = cos_phi*cos_phi
        let cos_phi_sq = cos_phi.mul_add(cos_phi_0 + cos_phi_0, sums[42]);
        // sin_phi_sq = sin_phi*sin_phi
        let sin_phi_sq = sin_phi.mul_add(sin_phi_0 + sin_phi_0, sums[43]);
        // u_psi_dot_of_place_5 = Ax + B*cos_phi_sq + B*sin_phi_sq
        let u_psi_dot_of_place_5 = sin_phi_sq.mul_add(B, B * cos_phi_sq);
        // u_psi_dot_of_place_6 = cos_phi*x_rotor_frame_1_of_place
        let u_psi_dot_of_place_6 = x_rotor_frame_1_of_place
            .mul_add(cos_phi_0, cos_phi.mul_add(x_rotor_frame_1_of_place_0, sums[44]));
        // u_psi_dot_of_place_7 = sin_phi*x_rotor_frame_2_of_place
        let u_psi_dot_of_place_7 = x_rotor_frame_2_of_place
            .mul_add(sin_phi_0, sin_phi.mul_add(x_rotor_frame_2_of_place_0, sums[45]));
        // u_psi_dot_of_place_8 = u_psi_dot_of_place/u_psi_dot_of_place_5
        let u_psi_dot_of_place_8 = u_psi_dot_of_place
            .mul_add(
                over_u_psi_dot_of_place_5,
                -(u_psi_dot_of_place_5.mul_add(u_psi_dot_of_place_8_0, sums[46])
                    * over_u_psi_dot_of_place_5),
            );
        // u_psi_dot_of_place_9 = u_psi_dot_of_place_4*u_psi_dot_of_place_8
        let u_psi_dot_of_place_9 = u_psi_dot_of_place_8
            .mul_add(
                u_psi_dot_of_place_4_0,
                u_psi_dot_of_place_4.mul_add(u_psi_dot_of_place_8_0, sums[47]),
            );
        // u_psi_dot_of_place_10 = Iz + Ay*sin_theta_sq + Az*cos_theta_sq + B*sin_theta_sq_sin_phi_sq +
        //   B*sin_theta_sq_cos_phi_sq - u_psi_dot_of_place_9
        let u_psi_dot_of_place_10 = sin_theta_sq_cos_phi_sq
            .mul_add(
                B,
                sin_theta_sq_sin_phi_sq
                    .mul_add(B, cos_theta_sq.mul_add(Az, Ay * sin_theta_sq)),
            ) - u_psi_dot_of_place_9;
        // u_psi_dot_of_place_11 = x_inner_frame_1_of_place - u_psi_dot_of_place_6 - u_psi_dot_of_place_7
        let u_psi_dot_of_place_11 = x_inner_frame_1_of_place - u_psi_dot_of_place_6
            - u_psi_dot_of_place_7;
        // u_psi_dot_of_place_12 = u_psi_dot_of_place_11*u_psi_dot_of_place_8
        let u_psi_dot_of_place_12 = u_psi_dot_of_place_11
            .mul_add(
                u_psi_dot_of_place_8_0,
                u_psi_dot_of_place_8.mul_add(u_psi_dot_of_place_11_0, sums[48]),
            );
        // u_psi_dot_of_place_13 = u_psi_dot_of_u_theta + u_psi_dot_of_u_theta_2 - u_psi_dot_of_place_2 +
        //   u_psi_dot_of_place_3 - u_psi_dot_of_place_12
        let u_psi_dot_of_place_13 = u_psi_dot_of_u_theta + u_psi_dot_of_u_theta_2
            + u_psi_dot_of_place_3 - u_psi_dot_of_place_2 - u_psi_dot_of_place_12;
        // u_psi_dot_of_place_14 = u_psi_dot_of_place_13/u_psi_dot_of_place_10
        let u_psi_dot_of_place_14 = u_psi_dot_of_place_13
            .mul_add(
                over_u_psi_dot_of_place_10,
                -(u_psi_dot_of_place_10.mul_add(u_psi_dot_of_place_14_0, sums[49])
                    * over_u_psi_dot_of_place_10),
            );
        // u_theta_dot_of_place = u_psi_dot_of_place_14*u_psi_dot_of_place_4
        let u_theta_dot_of_place = u_psi_dot_of_place_14
            .mul_add(
                u_psi_dot_of_place_4_0,
                u_psi_dot_of_place_4.mul_add(u_psi_dot_of_place_14_0, sums[50]),
            );
        // u_theta_dot_of_u_psi_dot = x_inner_frame_1_of_place - u_psi_dot_of_place_6 -
        //   u_psi_dot_of_place_7 - u_theta_dot_of_place
        let u_theta_dot_of_u_psi_dot = x_inner_frame_1_of_place - u_psi_dot_of_place_6
            - u_psi_dot_of_place_7 - u_theta_dot_of_place;
        // u_theta_dot_of_u_psi_dot_2 = u_theta_dot_of_u_psi_dot/u_psi_dot_of_place_5
        let u_theta_dot_of_u_psi_dot_2 = u_theta_dot_of_u_psi_dot
            .mul_add(
                over_u_psi_dot_of_place_5,
                -(u_psi_dot_of_place_5.mul_add(u_theta_dot_of_u_psi_dot_2_0, sums[51])
                    * over_u_psi_dot_of_place_5),
            );
        // u_phi_dot_of_place = u_psi_dot_of_place_14*cos_theta
        let u_phi_dot_of_place = u_psi_dot_of_place_14
            .mul_add(cos_theta_0, cos_theta.mul_add(u_psi_dot_of_place_14_0, sums[52]));
        // u_phi_dot_of_u_psi_dot = B*x_rotor_frame_3_of_u_theta + minus_b*x_rotor_frame_3_of_u_theta_2 +
        //   C*u_psi_u_theta_sin_theta + C*u_phi_dot_of_place
        let u_phi_dot_of_u_psi_dot = u_phi_dot_of_place
            .mul_add(
                C,
                x_rotor_frame_3_of_u_theta_2
                    .mul_add(
                        minus_b,
                        x_rotor_frame_3_of_u_theta
                            .mul_add(B, C * u_psi_u_theta_sin_theta),
                    ),
            );
        psi_rate = u_psi;
        theta_rate = u_theta;
        phi_rate = u_phi;
        u_psi_rate = -u_psi_dot_of_place_14;
        u_theta_rate = -u_theta_dot_of_u_psi_dot_2;
        u_phi_rate = weight * u_phi_dot_of_u_psi_dot;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * theta,
                count * theta,
                u_psi, u_psi, u_psi_sin_theta, u_psi_cos_theta, u_theta, u_psi_cos_theta, u_theta,
                u_theta, u_theta, u_psi_sin_theta,
                count * phi,
                count * phi,
                u_theta, cos_phi, sin_phi, u_phi, w_inner_frame_in_rotor_frame_2_of_u_theta,
                w_rotor_frame_3_of_u_phi, u_theta, sin_phi, cos_phi, u_phi,
                w_rotor_frame_3_of_u_phi, w_rotor_frame_3_of_u_phi,
                w_inner_frame_in_rotor_frame_2_of_u_theta,
                w_inner_frame_in_rotor_frame_2_of_u_theta, sin_theta, sin_theta, sin_theta,
                cos_theta, sin_theta_sin_phi, sin_theta_cos_phi, sin_theta_sin_phi,
                sin_theta_cos_phi, sin_theta, cos_theta, x_rotor_frame_1_of_place,
                x_rotor_frame_2_of_place, cos_phi, sin_phi, cos_phi, sin_phi, cos_phi, sin_phi,
                u_psi_dot_of_place_5, u_psi_dot_of_place_4, u_psi_dot_of_place_11,
                u_psi_dot_of_place_10, u_psi_dot_of_place_14, u_psi_dot_of_place_5,
                u_psi_dot_of_place_14,
            ]),
            padded([
                cos_theta, sin_theta, sin_theta, cos_theta, u_psi_cos_theta, u_psi_sin_theta,
                u_psi_cos_theta, u_theta, u_psi_cos_theta, u_psi_sin_theta, u_psi_sin_theta,
                u_theta, cos_phi, sin_phi, sin_phi, u_psi_sin_theta, u_psi_u_theta_cos_theta,
                w_inner_frame_in_rotor_frame_2_of_u_theta, w_rotor_frame_3_of_u_phi,
                w_inner_frame_in_rotor_frame_2_of_u_theta, cos_phi, u_psi_sin_theta,
                u_psi_u_theta_cos_theta, w_inner_frame_in_rotor_frame_1_of_u_theta,
                w_inner_frame_in_rotor_frame_1_of_u_theta,
                w_inner_frame_in_rotor_frame_1_of_u_theta,
                w_inner_frame_in_rotor_frame_1_of_u_theta,
                w_inner_frame_in_rotor_frame_1_of_u_theta, sin_phi, cos_phi, sin_theta, cos_theta,
                sin_theta_sin_phi, sin_theta_cos_phi, cos_phi, sin_phi, x_inner_frame_2_of_u_theta,
                x_inner_frame_3_of_u_theta, sin_theta_sin_phi, sin_theta_cos_phi, sin_theta_sin_phi,
                sin_theta_cos_phi, cos_phi, sin_phi, x_rotor_frame_1_of_place,
                x_rotor_frame_2_of_place, u_psi_dot_of_place_8, u_psi_dot_of_place_8,
                u_psi_dot_of_place_8, u_psi_dot_of_place_14, u_psi_dot_of_place_4,
                u_theta_dot_of_u_psi_dot_2, cos_theta,
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
        u_psi_u_theta_cos_theta_last = u_psi_u_theta_cos_theta;
        x_inner_frame_2_of_u_theta_last = x_inner_frame_2_of_u_theta;
        x_inner_frame_3_of_u_theta_last = x_inner_frame_3_of_u_theta;
        sin_phi_last = sin_phi;
        cos_phi_last = cos_phi;
        w_inner_frame_in_rotor_frame_2_of_u_theta_last = w_inner_frame_in_rotor_frame_2_of_u_theta;
        w_rotor_frame_3_of_u_phi_last = w_rotor_frame_3_of_u_phi;
        x_rotor_frame_1_of_place_last = x_rotor_frame_1_of_place;
        w_inner_frame_in_rotor_frame_1_of_u_theta_last = w_inner_frame_in_rotor_frame_1_of_u_theta;
        x_rotor_frame_2_of_place_last = x_rotor_frame_2_of_place;
        sin_theta_sin_phi_last = sin_theta_sin_phi;
        sin_theta_cos_phi_last = sin_theta_cos_phi;
        u_psi_dot_of_place_4_last = u_psi_dot_of_place_4;
        u_psi_dot_of_place_5_last = u_psi_dot_of_place_5;
        u_psi_dot_of_place_8_last = u_psi_dot_of_place_8;
        u_psi_dot_of_place_10_last = u_psi_dot_of_place_10;
        u_psi_dot_of_place_11_last = u_psi_dot_of_place_11;
        u_psi_dot_of_place_14_last = u_psi_dot_of_place_14;
        u_theta_dot_of_u_psi_dot_2_last = u_theta_dot_of_u_psi_dot_2;
    }
}

/// Newton–Euler equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEuler;

impl<S: Scalar> System<S> for NewtonEuler {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 9,
            coordinates: 3,
            variables: 3,
            speeds: 3,
            reactions: 6,
        }
    }
    fn symmetric(&self) -> bool {
        false
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
