//! Gyroscope in gimbals: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/gimbals/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{coordinate_rates, potential_energy};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

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
