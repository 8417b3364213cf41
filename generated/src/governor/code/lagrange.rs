//! Flyball governor: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/governor/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows psi, theta, q_right_top, q_left_ball, q_right_ball, constraint left_end_1, constraint right_end_1, constraint right_end_3.
///
/// 132 operations, 6 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _q_dot: &[S; 5],
) -> [[S; 8]; 8] {
    let Parameters { l, m, mb, ms, J, Js, .. } = *p;
    let [_, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    // Step by step, each after the terms that it needs.
    let mp_left_link_frame_3 = l * m;
    let w_left_arm_frame_in_left_link_frame_1_3 = sin_theta
        .mul_add(cos_q_left_ball, cos_theta * sin_q_left_ball);
    let w_right_arm_frame_in_right_link_frame_1_3 = sin_q_right_top
        .mul_add(cos_q_right_ball, cos_q_right_top * sin_q_right_ball);
    let v_left_arm_centre_2_3 = l * sin_theta;
    let H_left_arm_2 = l * mp_left_link_frame_3;
    let H_left_arm_1_3 = H_left_arm_2 * sin_theta;
    let v_right_arm_centre_2_3 = l * sin_q_right_top;
    let H_right_arm_1_3 = H_left_arm_2 * sin_q_right_top;
    let v_left_link_centre_2_3 = v_left_arm_centre_2_3
        .mul_add(S::int(2), l * w_left_arm_frame_in_left_link_frame_1_3);
    let H_left_link_1_3 = w_left_arm_frame_in_left_link_frame_1_3 * H_left_arm_2;
    let v_right_link_centre_2_3 = v_right_arm_centre_2_3
        .mul_add(S::int(2), l * w_right_arm_frame_in_right_link_frame_1_3);
    let H_right_link_1_3 = w_right_arm_frame_in_right_link_frame_1_3 * H_left_arm_2;
    let p_v_right_link_centre_2_3 = m * v_right_link_centre_2_3;
    let p_v_left_link_centre_2_3 = m * v_left_link_centre_2_3;
    let m_plus_mb_times_4 = mb.mul_add(S::int(4), m);
    let p_v_right_arm_centre_2_3 = v_right_arm_centre_2_3
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_right_link_centre_2_3);
    let p_v_left_arm_centre_2_3 = v_left_arm_centre_2_3
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_left_link_centre_2_3);
    let l_times_3 = S::int(3) * l;
    let p_w_right_arm_frame_in_right_link_frame_1_3 = p_v_right_link_centre_2_3
        .mul_add(l_times_3, H_right_link_1_3);
    let p_w_left_arm_frame_in_left_link_frame_1_3 = p_v_left_link_centre_2_3
        .mul_add(l_times_3, H_left_link_1_3);
    let p_w_spindle_frame_in_right_arm_frame_3_3 = p_w_right_arm_frame_in_right_link_frame_1_3
        * sin_q_right_ball;
    let p_w_spindle_frame_in_right_arm_frame_1_3 = p_w_right_arm_frame_in_right_link_frame_1_3
        .mul_add(cos_q_right_ball, H_right_arm_1_3) + p_v_right_arm_centre_2_3 * l_times_3;
    let p_w_spindle_frame_in_left_arm_frame_3_3 = p_w_left_arm_frame_in_left_link_frame_1_3
        * sin_q_left_ball;
    let p_w_spindle_frame_in_left_arm_frame_1_3 = p_w_left_arm_frame_in_left_link_frame_1_3
        .mul_add(cos_q_left_ball, H_left_arm_1_3) + p_v_left_arm_centre_2_3 * l_times_3;
    let v_left_arm_frame_in_left_link_frame_1_3 = l * cos_q_left_ball;
    let v_left_arm_frame_in_left_link_frame_3_3 = l * sin_q_left_ball;
    let v_left_link_centre_1_2 = v_left_arm_frame_in_left_link_frame_1_3
        .mul_add(S::int(2), l);
    let theta_plus_q_left_ball = theta + q_left_ball;
    let (sin_theta_plus_q_left_ball, cos_theta_plus_q_left_ball) = theta_plus_q_left_ball
        .sin_cos();
    let v_sleeve_centre_3_2_of_place = sin_theta + sin_theta_plus_q_left_ball;
    let v_sleeve_centre_3_2 = l * v_sleeve_centre_3_2_of_place;
    let p_v_sleeve_centre_3_2 = ms * v_sleeve_centre_3_2;
    let p_v_left_link_centre_1_3 = m * v_left_link_centre_1_2;
    let p_v_left_arm_frame_in_left_link_frame_3_3 = m * v_left_arm_frame_in_left_link_frame_3_3;
    let p_v_left_arm_centre_1 = l * m_plus_mb_times_4;
    let p_w_left_link_frame_2_2 = p_v_left_link_centre_1_3
        .mul_add(l_times_3, H_left_arm_2);
    let v_sleeve_centre_3_3 = l * sin_theta_plus_q_left_ball;
    let p_v_sleeve_centre_3_3 = ms * v_sleeve_centre_3_3;
    let p_w_left_link_frame_2_3 = mp_left_link_frame_3.mul_add(l_times_3, H_left_arm_2);
    let v_right_arm_frame_in_right_link_frame_1_3 = l * cos_q_right_ball;
    let v_right_arm_frame_in_right_link_frame_3_3 = l * sin_q_right_ball;
    let v_right_link_centre_1_2 = v_right_arm_frame_in_right_link_frame_1_3
        .mul_add(S::int(2), l);
    let p_v_right_link_centre_1_3 = m * v_right_link_centre_1_2;
    let p_v_right_arm_frame_in_right_link_frame_3_3 = m * v_right_arm_frame_in_right_link_frame_3_3;
    let p_w_right_link_frame_2_2 = p_v_right_link_centre_1_3
        .mul_add(l_times_3, H_left_arm_2);
    let m11_of_place = p_w_spindle_frame_in_right_arm_frame_1_3
        .mul_add(
            sin_q_right_top,
            p_w_spindle_frame_in_right_arm_frame_3_3 * cos_q_right_top,
        );
    let m11_of_place_2 = p_w_spindle_frame_in_left_arm_frame_1_3
        .mul_add(sin_theta, p_w_spindle_frame_in_left_arm_frame_3_3 * cos_theta);
    let m11_of_place_3 = m11_of_place + m11_of_place_2;
    let h_left_arm_2_by_12 = S::ratio(1, 12) * H_left_arm_2;
    let m22_of_place = p_v_sleeve_centre_3_2
        .mul_add(
            v_sleeve_centre_3_2_of_place,
            p_v_left_arm_frame_in_left_link_frame_3_3 * sin_q_left_ball,
        );
    let l_by_4 = S::ratio(1, 4) * l;
    let m24_of_place = S::ratio(1, 12) * p_w_left_link_frame_2_3;
    let h_left_arm_2_halved = S::ratio(1, 2) * H_left_arm_2;
    let m24_of_place_2 = h_left_arm_2_halved
        .mul_add(cos_q_left_ball, v_sleeve_centre_3_2 * p_v_sleeve_centre_3_3);
    let m24_of_place_3 = m24_of_place + m24_of_place_2;
    let m26_of_place = l * (cos_theta + cos_theta_plus_q_left_ball);
    let m35_of_place = h_left_arm_2_halved.mul_add(cos_q_right_ball, m24_of_place);
    let m37_of_place = q_right_top + q_right_ball;
    let (sin_angle, cos_angle) = m37_of_place.sin_cos();
    let m37_of_place_2 = l * (cos_q_right_top + cos_angle);
    let m38_of_place = l * (sin_q_right_top + sin_angle);
    let m46_of_place = l * cos_theta_plus_q_left_ball;
    let l_cos_angle = l * cos_angle;
    let l_sin_angle = l * sin_angle;
    // Entries that are not zero.
    let m11 = J + Js + S::ratio(1, 12) * m11_of_place_3;
    let m22 = S::ratio(1, 12) * p_w_left_link_frame_2_2 + h_left_arm_2_by_12
        + l_by_4
            * ((p_v_left_link_centre_1_3 * cos_q_left_ball)
                .mul_add(S::int(2), p_v_left_arm_centre_1) + S::int(4) * m22_of_place);
    let m24 = m24_of_place_3;
    let m26 = m26_of_place;
    let m28 = v_sleeve_centre_3_2;
    let m33 = S::ratio(1, 12) * p_w_right_link_frame_2_2 + h_left_arm_2_by_12
        + l_by_4
            * ((p_v_right_link_centre_1_3 * cos_q_right_ball)
                .mul_add(S::int(2), p_v_left_arm_centre_1)
                + S::int(4) * p_v_right_arm_frame_in_right_link_frame_3_3 * sin_q_right_ball);
    let m35 = m35_of_place;
    let m37 = m37_of_place_2;
    let m38 = -m38_of_place;
    let m42 = m24_of_place_3;
    let m44 = v_sleeve_centre_3_3.mul_add(p_v_sleeve_centre_3_3, m24_of_place);
    let m46 = m46_of_place;
    let m48 = v_sleeve_centre_3_3;
    let m53 = m35_of_place;
    let m55 = m24_of_place;
    let m57 = l_cos_angle;
    let m58 = -l_sin_angle;
    let m62 = -m26_of_place;
    let m64 = -m46_of_place;
    let m73 = -m37_of_place_2;
    let m75 = -l_cos_angle;
    let m82 = -v_sleeve_centre_3_2;
    let m83 = m38_of_place;
    let m84 = -v_sleeve_centre_3_3;
    let m85 = l_sin_angle;
    let zero = S::int(0);
    [
        [m11, zero, zero, zero, zero, zero, zero, zero],
        [zero, m22, zero, m24, zero, m26, zero, m28],
        [zero, zero, m33, zero, m35, zero, m37, m38],
        [zero, m42, zero, m44, zero, m46, zero, m48],
        [zero, zero, m53, zero, m55, zero, m57, m58],
        [zero, m62, zero, m64, zero, zero, zero, zero],
        [zero, zero, m73, zero, m75, zero, zero, zero],
        [zero, m82, m83, m84, m85, zero, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (psi'', theta'', q_right_top'', q_left_ball'', q_right_ball'', lambda_left_end_1, lambda_right_end_1, lambda_right_end_3).
///
/// 292 operations, 6 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> [S; 8] {
    let Parameters { l, m, mb, ms, g, .. } = *p;
    let [_, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    let [psi_dot, theta_dot, q_right_top_dot, q_left_ball_dot, q_right_ball_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_spindle_frame_in_left_arm_frame_1 = psi_dot * sin_theta;
    let w_spindle_frame_in_left_arm_frame_3 = psi_dot * cos_theta;
    let w_spindle_frame_in_right_arm_frame_1 = psi_dot * sin_q_right_top;
    let w_spindle_frame_in_right_arm_frame_3 = psi_dot * cos_q_right_top;
    let w_left_arm_frame_in_left_link_frame_1 = w_spindle_frame_in_left_arm_frame_3
        .mul_add(sin_q_left_ball, w_spindle_frame_in_left_arm_frame_1 * cos_q_left_ball);
    let w_right_arm_frame_in_right_link_frame_1 = w_spindle_frame_in_right_arm_frame_3
        .mul_add(
            sin_q_right_ball,
            w_spindle_frame_in_right_arm_frame_1 * cos_q_right_ball,
        );
    let v_left_arm_centre_2 = l * w_spindle_frame_in_left_arm_frame_1;
    let mp_left_link_frame_3 = l * m;
    let l_mp_left_link_frame_3 = l * mp_left_link_frame_3;
    let H_left_arm_1 = w_spindle_frame_in_left_arm_frame_1 * l_mp_left_link_frame_3;
    let v_right_arm_centre_2 = l * w_spindle_frame_in_right_arm_frame_1;
    let H_right_arm_1 = w_spindle_frame_in_right_arm_frame_1 * l_mp_left_link_frame_3;
    let v_left_link_centre_2 = v_left_arm_centre_2
        .mul_add(S::int(2), l * w_left_arm_frame_in_left_link_frame_1);
    let H_left_link_1 = w_left_arm_frame_in_left_link_frame_1 * l_mp_left_link_frame_3;
    let v_right_link_centre_2 = v_right_arm_centre_2
        .mul_add(S::int(2), l * w_right_arm_frame_in_right_link_frame_1);
    let H_right_link_1 = w_right_arm_frame_in_right_link_frame_1 * l_mp_left_link_frame_3;
    let p_v_right_link_centre_2 = m * v_right_link_centre_2;
    let p_v_left_link_centre_2 = m * v_left_link_centre_2;
    let m_plus_mb_times_4 = mb.mul_add(S::int(4), m);
    let p_v_right_arm_centre_2 = v_right_arm_centre_2
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_right_link_centre_2);
    let p_v_left_arm_centre_2 = v_left_arm_centre_2
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_left_link_centre_2);
    let l_times_3 = S::int(3) * l;
    let p_w_right_arm_frame_in_right_link_frame_1 = p_v_right_link_centre_2
        .mul_add(l_times_3, H_right_link_1);
    let p_w_left_arm_frame_in_left_link_frame_1 = p_v_left_link_centre_2
        .mul_add(l_times_3, H_left_link_1);
    let p_w_spindle_frame_in_right_arm_frame_3 = p_w_right_arm_frame_in_right_link_frame_1
        * sin_q_right_ball;
    let p_w_spindle_frame_in_right_arm_frame_1 = p_w_right_arm_frame_in_right_link_frame_1
        .mul_add(cos_q_right_ball, H_right_arm_1) + p_v_right_arm_centre_2 * l_times_3;
    let p_w_spindle_frame_in_left_arm_frame_3 = p_w_left_arm_frame_in_left_link_frame_1
        * sin_q_left_ball;
    let p_w_spindle_frame_in_left_arm_frame_1 = p_w_left_arm_frame_in_left_link_frame_1
        .mul_add(cos_q_left_ball, H_left_arm_1) + p_v_left_arm_centre_2 * l_times_3;
    let theta_dot_cos_theta = theta_dot * cos_theta;
    let w_spindle_frame_in_left_arm_frame_1_2 = psi_dot * theta_dot_cos_theta;
    let w_spindle_frame_in_left_arm_frame_3_2 = theta_dot * w_spindle_frame_in_left_arm_frame_1;
    let w_spindle_frame_in_right_arm_frame_1_2 = q_right_top_dot
        * w_spindle_frame_in_right_arm_frame_3;
    let w_spindle_frame_in_right_arm_frame_3_2 = q_right_top_dot
        * w_spindle_frame_in_right_arm_frame_1;
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion = q_left_ball_dot * cos_q_left_ball;
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion_2 = q_left_ball_dot * sin_q_left_ball;
    let w_left_arm_frame_in_left_link_frame_1_2 = (-w_spindle_frame_in_left_arm_frame_3_2)
        .mul_add(
            sin_q_left_ball,
            w_spindle_frame_in_left_arm_frame_1_2 * cos_q_left_ball,
        )
        + w_spindle_frame_in_left_arm_frame_3 * w_left_arm_frame_in_left_link_frame_1_2_of_motion
        - w_spindle_frame_in_left_arm_frame_1 * w_left_arm_frame_in_left_link_frame_1_2_of_motion_2;
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion = q_right_ball_dot * cos_q_right_ball;
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion_2 = q_right_ball_dot * sin_q_right_ball;
    let w_right_arm_frame_in_right_link_frame_1_2 = (-w_spindle_frame_in_right_arm_frame_3_2)
        .mul_add(
            sin_q_right_ball,
            w_spindle_frame_in_right_arm_frame_1_2 * cos_q_right_ball,
        )
        + w_spindle_frame_in_right_arm_frame_3 * w_right_arm_frame_in_right_link_frame_1_2_of_motion
        - w_spindle_frame_in_right_arm_frame_1
            * w_right_arm_frame_in_right_link_frame_1_2_of_motion_2;
    let v_left_arm_centre_2_2 = l * w_spindle_frame_in_left_arm_frame_1_2;
    let H_left_arm_1_2 = w_spindle_frame_in_left_arm_frame_1_2 * l_mp_left_link_frame_3;
    let v_right_arm_centre_2_2 = l * w_spindle_frame_in_right_arm_frame_1_2;
    let H_right_arm_1_2 = w_spindle_frame_in_right_arm_frame_1_2 * l_mp_left_link_frame_3;
    let v_left_link_centre_2_2 = v_left_arm_centre_2_2
        .mul_add(S::int(2), l * w_left_arm_frame_in_left_link_frame_1_2);
    let H_left_link_1_2 = w_left_arm_frame_in_left_link_frame_1_2 * l_mp_left_link_frame_3;
    let v_right_link_centre_2_2 = v_right_arm_centre_2_2
        .mul_add(S::int(2), l * w_right_arm_frame_in_right_link_frame_1_2);
    let H_right_link_1_2 = w_right_arm_frame_in_right_link_frame_1_2 * l_mp_left_link_frame_3;
    let p_v_right_link_centre_2_2 = m * v_right_link_centre_2_2;
    let p_v_left_link_centre_2_2 = m * v_left_link_centre_2_2;
    let p_v_right_arm_centre_2_2 = v_right_arm_centre_2_2
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_right_link_centre_2_2);
    let p_v_left_arm_centre_2_2 = v_left_arm_centre_2_2
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_left_link_centre_2_2);
    let p_w_right_arm_frame_in_right_link_frame_1_2 = p_v_right_link_centre_2_2
        .mul_add(l_times_3, H_right_link_1_2);
    let p_w_left_arm_frame_in_left_link_frame_1_2 = p_v_left_link_centre_2_2
        .mul_add(l_times_3, H_left_link_1_2);
    let p_w_spindle_frame_in_right_arm_frame_3_2 = p_w_right_arm_frame_in_right_link_frame_1
        .mul_add(
            w_right_arm_frame_in_right_link_frame_1_2_of_motion,
            p_w_right_arm_frame_in_right_link_frame_1_2 * sin_q_right_ball,
        );
    let p_w_spindle_frame_in_right_arm_frame_1_2 = p_w_right_arm_frame_in_right_link_frame_1_2
        .mul_add(cos_q_right_ball, H_right_arm_1_2) + p_v_right_arm_centre_2_2 * l_times_3
        - p_w_right_arm_frame_in_right_link_frame_1
            * w_right_arm_frame_in_right_link_frame_1_2_of_motion_2;
    let p_w_spindle_frame_in_left_arm_frame_3_2 = p_w_left_arm_frame_in_left_link_frame_1
        .mul_add(
            w_left_arm_frame_in_left_link_frame_1_2_of_motion,
            p_w_left_arm_frame_in_left_link_frame_1_2 * sin_q_left_ball,
        );
    let p_w_spindle_frame_in_left_arm_frame_1_2 = p_w_left_arm_frame_in_left_link_frame_1_2
        .mul_add(cos_q_left_ball, H_left_arm_1_2) + p_v_left_arm_centre_2_2 * l_times_3
        - p_w_left_arm_frame_in_left_link_frame_1
            * w_left_arm_frame_in_left_link_frame_1_2_of_motion_2;
    let w_left_link_frame_2 = theta_dot + q_left_ball_dot;
    let mp_left_arm_frame_3 = mp_left_link_frame_3
        .mul_add(S::int(3), S::int(2) * l * mb);
    let x_left_link_frame_in_left_arm_frame_1 = mp_left_link_frame_3 * sin_q_left_ball;
    let x_left_link_frame_in_left_arm_frame_3 = mp_left_link_frame_3 * cos_q_left_ball;
    let x_N_3 = mp_left_arm_frame_3 + x_left_link_frame_in_left_arm_frame_3;
    let l_theta_dot = l * theta_dot;
    let v_left_arm_frame_in_left_link_frame_1 = l_theta_dot * cos_q_left_ball;
    let v_left_arm_frame_in_left_link_frame_3 = l_theta_dot * sin_q_left_ball;
    let v_left_link_centre_1 = v_left_arm_frame_in_left_link_frame_1
        .mul_add(S::int(2), l * w_left_link_frame_2);
    let p_v_left_link_centre_1 = m * v_left_link_centre_1;
    let p_v_left_arm_frame_in_left_link_frame_3 = m * v_left_arm_frame_in_left_link_frame_3;
    let v_left_arm_frame_in_left_link_frame_1_2 = w_left_arm_frame_in_left_link_frame_1_2_of_motion_2
        * l_theta_dot;
    let v_left_arm_frame_in_left_link_frame_3_2 = w_left_arm_frame_in_left_link_frame_1_2_of_motion
        * l_theta_dot;
    let theta_plus_q_left_ball = theta + q_left_ball;
    let (sin_theta_plus_q_left_ball, cos_theta_plus_q_left_ball) = theta_plus_q_left_ball
        .sin_cos();
    let v_sleeve_centre_3_of_place = w_left_link_frame_2 * cos_theta_plus_q_left_ball;
    let v_sleeve_centre_3 = l
        * w_left_link_frame_2
            .mul_add(v_sleeve_centre_3_of_place, theta_dot * theta_dot_cos_theta);
    let p_v_sleeve_centre_3 = ms * v_sleeve_centre_3;
    let p_v_left_link_centre_1_2 = m * v_left_arm_frame_in_left_link_frame_1_2;
    let p_v_left_arm_frame_in_left_link_frame_3_2 = m * v_left_arm_frame_in_left_link_frame_3_2;
    let p_w_left_link_frame_2 = l * p_v_left_link_centre_1_2;
    let w_right_link_frame_2 = q_right_top_dot + q_right_ball_dot;
    let x_right_link_frame_in_right_arm_frame_1 = mp_left_link_frame_3 * sin_q_right_ball;
    let x_right_link_frame_in_right_arm_frame_3 = mp_left_link_frame_3 * cos_q_right_ball;
    let x_N_3_2 = mp_left_arm_frame_3 + x_right_link_frame_in_right_arm_frame_3;
    let l_q_right_top_dot = l * q_right_top_dot;
    let v_right_arm_frame_in_right_link_frame_1 = l_q_right_top_dot * cos_q_right_ball;
    let v_right_arm_frame_in_right_link_frame_3 = l_q_right_top_dot * sin_q_right_ball;
    let v_right_link_centre_1 = v_right_arm_frame_in_right_link_frame_1
        .mul_add(S::int(2), l * w_right_link_frame_2);
    let p_v_right_link_centre_1 = m * v_right_link_centre_1;
    let p_v_right_arm_frame_in_right_link_frame_3 = m * v_right_arm_frame_in_right_link_frame_3;
    let v_right_arm_frame_in_right_link_frame_1_2 = w_right_arm_frame_in_right_link_frame_1_2_of_motion_2
        * l_q_right_top_dot;
    let v_right_arm_frame_in_right_link_frame_3_2 = w_right_arm_frame_in_right_link_frame_1_2_of_motion
        * l_q_right_top_dot;
    let p_v_right_link_centre_1_2 = m * v_right_arm_frame_in_right_link_frame_1_2;
    let p_v_right_arm_frame_in_right_link_frame_3_2 = m * v_right_arm_frame_in_right_link_frame_3_2;
    let p_w_right_link_frame_2 = l * p_v_right_link_centre_1_2;
    let F_x_N_3 = g * cos_theta;
    let F_x_left_link_frame_in_left_arm_frame_1 = g * sin_theta;
    let F_x_N_3_2 = g * cos_q_right_top;
    let F_x_right_link_frame_in_right_arm_frame_1 = g * sin_q_right_top;
    let f1_of_place = (-p_w_spindle_frame_in_left_arm_frame_1)
        .mul_add(cos_theta, p_w_spindle_frame_in_left_arm_frame_3 * sin_theta);
    let f1_of_place_by_12 = S::ratio(1, 12) * f1_of_place;
    let f1_of_place_2 = (-p_w_spindle_frame_in_right_arm_frame_1)
        .mul_add(
            cos_q_right_top,
            p_w_spindle_frame_in_right_arm_frame_3 * sin_q_right_top,
        );
    let f1_of_place_2_by_12 = S::ratio(1, 12) * f1_of_place_2;
    let f1_of_place_3 = p_w_spindle_frame_in_right_arm_frame_1_2
        .mul_add(
            sin_q_right_top,
            p_w_spindle_frame_in_right_arm_frame_3_2 * cos_q_right_top,
        );
    let f1_of_place_4 = p_w_spindle_frame_in_left_arm_frame_1_2
        .mul_add(sin_theta, p_w_spindle_frame_in_left_arm_frame_3_2 * cos_theta);
    let f1_of_place_5 = f1_of_place_3 + f1_of_place_4;
    let cos_q_left_ball_doubled = S::int(2) * cos_q_left_ball;
    let f2_of_place = (-p_v_left_arm_frame_in_left_link_frame_3)
        .mul_add(cos_q_left_ball_doubled, p_v_left_link_centre_1 * sin_q_left_ball);
    let f2_of_place_2 = ms.mul_add(g, p_v_sleeve_centre_3);
    let f2_of_place_2_doubled = S::int(2) * f2_of_place_2;
    let l_halved = S::ratio(1, 2) * l;
    let f2_of_place_3 = S::ratio(1, 2) * p_w_left_link_frame_2;
    let g_halved = S::ratio(1, 2) * g;
    let cos_q_right_ball_doubled = S::int(2) * cos_q_right_ball;
    let f3_of_place = S::ratio(1, 2) * p_w_right_link_frame_2;
    let f4_of_place = S::int(6) * mp_left_link_frame_3;
    let f4_of_place_2 = sin_q_left_ball
        * F_x_N_3
            .mul_add(
                f4_of_place,
                w_spindle_frame_in_left_arm_frame_1 * p_w_left_arm_frame_in_left_link_frame_1,
            )
        + cos_q_left_ball
            * (-w_spindle_frame_in_left_arm_frame_3)
                .mul_add(
                    p_w_left_arm_frame_in_left_link_frame_1,
                    F_x_left_link_frame_in_left_arm_frame_1 * f4_of_place,
                );
    let f5_of_motion = sin_q_right_ball
        * ((p_v_right_link_centre_1 * l_q_right_top_dot)
            .mul_add(
                S::int(6),
                w_spindle_frame_in_right_arm_frame_1 * p_w_right_arm_frame_in_right_link_frame_1,
            ) + F_x_N_3_2 * f4_of_place)
        + cos_q_right_ball
            * ((-w_spindle_frame_in_right_arm_frame_3)
                .mul_add(
                    p_w_right_arm_frame_in_right_link_frame_1,
                    F_x_right_link_frame_in_right_arm_frame_1 * f4_of_place,
                )
                - S::int(12) * p_v_right_arm_frame_in_right_link_frame_3 * l_q_right_top_dot);
    let f7_of_place = q_right_top + q_right_ball;
    let (sin_angle, cos_angle) = f7_of_place.sin_cos();
    let f8_of_place = w_right_link_frame_2 * cos_angle;
    // Values.
    let f1 = q_right_top_dot.mul_add(f1_of_place_2_by_12, theta_dot * f1_of_place_by_12)
        - S::ratio(1, 12) * f1_of_place_5;
    let f2 = l_halved
        * (p_v_left_link_centre_1_2 * cos_q_left_ball_doubled
            - S::int(2) * p_v_left_arm_frame_in_left_link_frame_3_2 * sin_q_left_ball
            + q_left_ball_dot * f2_of_place
            - f2_of_place_2_doubled * (sin_theta + sin_theta_plus_q_left_ball))
        - psi_dot * f1_of_place_by_12 + f2_of_place_3
        - g_halved
            * x_N_3
                .mul_add(sin_theta, x_left_link_frame_in_left_arm_frame_1 * cos_theta);
    let f3 = l_halved
        * (p_v_right_link_centre_1_2 * cos_q_right_ball_doubled
            - S::int(2) * p_v_right_arm_frame_in_right_link_frame_3_2 * sin_q_right_ball
            - q_right_ball_dot
                * (-p_v_right_link_centre_1)
                    .mul_add(
                        sin_q_right_ball,
                        p_v_right_arm_frame_in_right_link_frame_3 * cos_q_right_ball_doubled,
                    )) - psi_dot * f1_of_place_2_by_12
        - g_halved
            * x_N_3_2
                .mul_add(
                    sin_q_right_top,
                    x_right_link_frame_in_right_arm_frame_1 * cos_q_right_top,
                ) + f3_of_place;
    let f4 = f2_of_place_3
        - l_halved
            * f2_of_place_2_doubled
                .mul_add(sin_theta_plus_q_left_ball, theta_dot * f2_of_place)
        - S::ratio(1, 12) * f4_of_place_2;
    let f5 = f3_of_place - S::ratio(1, 12) * f5_of_motion;
    let f6 = -l
        * (theta_dot * theta_dot * sin_theta
            + w_left_link_frame_2 * w_left_link_frame_2 * sin_theta_plus_q_left_ball);
    let f7 = -l
        * (q_right_top_dot * q_right_top_dot * sin_q_right_top
            + w_right_link_frame_2 * w_right_link_frame_2 * sin_angle);
    let f8 = l
        * (theta_dot * (theta_dot_cos_theta + v_sleeve_centre_3_of_place)
            + q_left_ball_dot * v_sleeve_centre_3_of_place - q_right_ball_dot * f8_of_place
            - q_right_top_dot * q_right_top_dot.mul_add(cos_q_right_top, f8_of_place));
    [f1, f2, f3, f4, f5, f6, f7, f8]
}

/// The accelerations (psi'', theta'', q_right_top'', q_left_ball'', q_right_ball''), solved for when this code was generated.
///
/// 486 operations, 6 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 5] {
    let Parameters { l, m, mb, ms, J, Js, g } = *p;
    let [_, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    let [psi_dot, theta_dot, q_right_top_dot, q_left_ball_dot, q_right_ball_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_spindle_frame_in_left_arm_frame_1 = psi_dot * sin_theta;
    let w_spindle_frame_in_left_arm_frame_3 = psi_dot * cos_theta;
    let w_spindle_frame_in_right_arm_frame_1 = psi_dot * sin_q_right_top;
    let w_spindle_frame_in_right_arm_frame_3 = psi_dot * cos_q_right_top;
    let w_left_arm_frame_in_left_link_frame_1 = w_spindle_frame_in_left_arm_frame_3
        .mul_add(sin_q_left_ball, w_spindle_frame_in_left_arm_frame_1 * cos_q_left_ball);
    let w_right_arm_frame_in_right_link_frame_1 = w_spindle_frame_in_right_arm_frame_3
        .mul_add(
            sin_q_right_ball,
            w_spindle_frame_in_right_arm_frame_1 * cos_q_right_ball,
        );
    let v_left_arm_centre_2 = l * w_spindle_frame_in_left_arm_frame_1;
    let mp_left_link_frame_3 = l * m;
    let H_left_arm_2 = l * mp_left_link_frame_3;
    let H_left_arm_1 = w_spindle_frame_in_left_arm_frame_1 * H_left_arm_2;
    let v_right_arm_centre_2 = l * w_spindle_frame_in_right_arm_frame_1;
    let H_right_arm_1 = w_spindle_frame_in_right_arm_frame_1 * H_left_arm_2;
    let v_left_link_centre_2 = v_left_arm_centre_2
        .mul_add(S::int(2), l * w_left_arm_frame_in_left_link_frame_1);
    let H_left_link_1 = w_left_arm_frame_in_left_link_frame_1 * H_left_arm_2;
    let v_right_link_centre_2 = v_right_arm_centre_2
        .mul_add(S::int(2), l * w_right_arm_frame_in_right_link_frame_1);
    let H_right_link_1 = w_right_arm_frame_in_right_link_frame_1 * H_left_arm_2;
    let p_v_right_link_centre_2 = m * v_right_link_centre_2;
    let p_v_left_link_centre_2 = m * v_left_link_centre_2;
    let m_plus_mb_times_4 = mb.mul_add(S::int(4), m);
    let p_v_right_arm_centre_2 = v_right_arm_centre_2
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_right_link_centre_2);
    let p_v_left_arm_centre_2 = v_left_arm_centre_2
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_left_link_centre_2);
    let l_times_3 = S::int(3) * l;
    let p_w_right_arm_frame_in_right_link_frame_1 = p_v_right_link_centre_2
        .mul_add(l_times_3, H_right_link_1);
    let p_w_left_arm_frame_in_left_link_frame_1 = p_v_left_link_centre_2
        .mul_add(l_times_3, H_left_link_1);
    let p_w_spindle_frame_in_right_arm_frame_3 = p_w_right_arm_frame_in_right_link_frame_1
        * sin_q_right_ball;
    let p_w_spindle_frame_in_right_arm_frame_1 = p_w_right_arm_frame_in_right_link_frame_1
        .mul_add(cos_q_right_ball, H_right_arm_1) + p_v_right_arm_centre_2 * l_times_3;
    let p_w_spindle_frame_in_left_arm_frame_3 = p_w_left_arm_frame_in_left_link_frame_1
        * sin_q_left_ball;
    let p_w_spindle_frame_in_left_arm_frame_1 = p_w_left_arm_frame_in_left_link_frame_1
        .mul_add(cos_q_left_ball, H_left_arm_1) + p_v_left_arm_centre_2 * l_times_3;
    let w_spindle_frame_in_left_arm_frame_1_2 = theta_dot * w_spindle_frame_in_left_arm_frame_3;
    let w_spindle_frame_in_left_arm_frame_3_2 = theta_dot * w_spindle_frame_in_left_arm_frame_1;
    let w_spindle_frame_in_right_arm_frame_1_2 = q_right_top_dot
        * w_spindle_frame_in_right_arm_frame_3;
    let w_spindle_frame_in_right_arm_frame_3_2 = q_right_top_dot
        * w_spindle_frame_in_right_arm_frame_1;
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion = q_left_ball_dot * cos_q_left_ball;
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion_2 = q_left_ball_dot * sin_q_left_ball;
    let w_left_arm_frame_in_left_link_frame_1_2 = (-w_spindle_frame_in_left_arm_frame_3_2)
        .mul_add(
            sin_q_left_ball,
            w_spindle_frame_in_left_arm_frame_1_2 * cos_q_left_ball,
        )
        + w_spindle_frame_in_left_arm_frame_3 * w_left_arm_frame_in_left_link_frame_1_2_of_motion
        - w_spindle_frame_in_left_arm_frame_1 * w_left_arm_frame_in_left_link_frame_1_2_of_motion_2;
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion = q_right_ball_dot * cos_q_right_ball;
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion_2 = q_right_ball_dot * sin_q_right_ball;
    let w_right_arm_frame_in_right_link_frame_1_2 = (-w_spindle_frame_in_right_arm_frame_3_2)
        .mul_add(
            sin_q_right_ball,
            w_spindle_frame_in_right_arm_frame_1_2 * cos_q_right_ball,
        )
        + w_spindle_frame_in_right_arm_frame_3 * w_right_arm_frame_in_right_link_frame_1_2_of_motion
        - w_spindle_frame_in_right_arm_frame_1
            * w_right_arm_frame_in_right_link_frame_1_2_of_motion_2;
    let v_left_arm_centre_2_2 = l * w_spindle_frame_in_left_arm_frame_1_2;
    let H_left_arm_1_2 = w_spindle_frame_in_left_arm_frame_1_2 * H_left_arm_2;
    let v_right_arm_centre_2_2 = l * w_spindle_frame_in_right_arm_frame_1_2;
    let H_right_arm_1_2 = w_spindle_frame_in_right_arm_frame_1_2 * H_left_arm_2;
    let v_left_link_centre_2_2 = v_left_arm_centre_2_2
        .mul_add(S::int(2), l * w_left_arm_frame_in_left_link_frame_1_2);
    let H_left_link_1_2 = w_left_arm_frame_in_left_link_frame_1_2 * H_left_arm_2;
    let v_right_link_centre_2_2 = v_right_arm_centre_2_2
        .mul_add(S::int(2), l * w_right_arm_frame_in_right_link_frame_1_2);
    let H_right_link_1_2 = w_right_arm_frame_in_right_link_frame_1_2 * H_left_arm_2;
    let p_v_right_link_centre_2_2 = m * v_right_link_centre_2_2;
    let p_v_left_link_centre_2_2 = m * v_left_link_centre_2_2;
    let p_v_right_arm_centre_2_2 = v_right_arm_centre_2_2
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_right_link_centre_2_2);
    let p_v_left_arm_centre_2_2 = v_left_arm_centre_2_2
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_left_link_centre_2_2);
    let p_w_right_arm_frame_in_right_link_frame_1_2 = p_v_right_link_centre_2_2
        .mul_add(l_times_3, H_right_link_1_2);
    let p_w_left_arm_frame_in_left_link_frame_1_2 = p_v_left_link_centre_2_2
        .mul_add(l_times_3, H_left_link_1_2);
    let p_w_spindle_frame_in_right_arm_frame_3_2 = p_w_right_arm_frame_in_right_link_frame_1
        .mul_add(
            w_right_arm_frame_in_right_link_frame_1_2_of_motion,
            p_w_right_arm_frame_in_right_link_frame_1_2 * sin_q_right_ball,
        );
    let p_w_spindle_frame_in_right_arm_frame_1_2 = p_w_right_arm_frame_in_right_link_frame_1_2
        .mul_add(cos_q_right_ball, H_right_arm_1_2) + p_v_right_arm_centre_2_2 * l_times_3
        - p_w_right_arm_frame_in_right_link_frame_1
            * w_right_arm_frame_in_right_link_frame_1_2_of_motion_2;
    let p_w_spindle_frame_in_left_arm_frame_3_2 = p_w_left_arm_frame_in_left_link_frame_1
        .mul_add(
            w_left_arm_frame_in_left_link_frame_1_2_of_motion,
            p_w_left_arm_frame_in_left_link_frame_1_2 * sin_q_left_ball,
        );
    let p_w_spindle_frame_in_left_arm_frame_1_2 = p_w_left_arm_frame_in_left_link_frame_1_2
        .mul_add(cos_q_left_ball, H_left_arm_1_2) + p_v_left_arm_centre_2_2 * l_times_3
        - p_w_left_arm_frame_in_left_link_frame_1
            * w_left_arm_frame_in_left_link_frame_1_2_of_motion_2;
    let w_left_link_frame_2 = theta_dot + q_left_ball_dot;
    let mp_left_arm_frame_3 = m.mul_add(l_times_3, S::int(2) * l * mb);
    let x_left_link_frame_in_left_arm_frame_1 = mp_left_link_frame_3 * sin_q_left_ball;
    let x_left_link_frame_in_left_arm_frame_3 = mp_left_link_frame_3 * cos_q_left_ball;
    let x_N_3 = mp_left_arm_frame_3 + x_left_link_frame_in_left_arm_frame_3;
    let l_theta_dot = l * theta_dot;
    let v_left_arm_frame_in_left_link_frame_1 = l_theta_dot * cos_q_left_ball;
    let v_left_arm_frame_in_left_link_frame_3 = l_theta_dot * sin_q_left_ball;
    let v_left_link_centre_1 = v_left_arm_frame_in_left_link_frame_1
        .mul_add(S::int(2), l * w_left_link_frame_2);
    let p_v_left_link_centre_1 = m * v_left_link_centre_1;
    let p_v_left_arm_frame_in_left_link_frame_3 = m * v_left_arm_frame_in_left_link_frame_3;
    let v_left_arm_frame_in_left_link_frame_1_2 = w_left_arm_frame_in_left_link_frame_1_2_of_motion_2
        * l_theta_dot;
    let v_left_arm_frame_in_left_link_frame_3_2 = w_left_arm_frame_in_left_link_frame_1_2_of_motion
        * l_theta_dot;
    let theta_dot_sq = theta_dot * theta_dot;
    let theta_plus_q_left_ball = theta + q_left_ball;
    let (sin_theta_plus_q_left_ball, cos_theta_plus_q_left_ball) = theta_plus_q_left_ball
        .sin_cos();
    let v_sleeve_centre_3 = l
        * theta_dot_sq
            .mul_add(
                cos_theta,
                w_left_link_frame_2 * w_left_link_frame_2 * cos_theta_plus_q_left_ball,
            );
    let p_v_sleeve_centre_3 = ms * v_sleeve_centre_3;
    let p_v_left_link_centre_1_2 = m * v_left_arm_frame_in_left_link_frame_1_2;
    let p_v_left_arm_frame_in_left_link_frame_3_2 = m * v_left_arm_frame_in_left_link_frame_3_2;
    let p_w_left_link_frame_2 = l * p_v_left_link_centre_1_2;
    let w_right_link_frame_2 = q_right_top_dot + q_right_ball_dot;
    let x_right_link_frame_in_right_arm_frame_1 = mp_left_link_frame_3 * sin_q_right_ball;
    let x_right_link_frame_in_right_arm_frame_3 = mp_left_link_frame_3 * cos_q_right_ball;
    let x_N_3_2 = mp_left_arm_frame_3 + x_right_link_frame_in_right_arm_frame_3;
    let l_q_right_top_dot = l * q_right_top_dot;
    let v_right_arm_frame_in_right_link_frame_1 = l_q_right_top_dot * cos_q_right_ball;
    let v_right_arm_frame_in_right_link_frame_3 = l_q_right_top_dot * sin_q_right_ball;
    let v_right_link_centre_1 = v_right_arm_frame_in_right_link_frame_1
        .mul_add(S::int(2), l * w_right_link_frame_2);
    let p_v_right_link_centre_1 = m * v_right_link_centre_1;
    let p_v_right_arm_frame_in_right_link_frame_3 = m * v_right_arm_frame_in_right_link_frame_3;
    let v_right_arm_frame_in_right_link_frame_1_2 = w_right_arm_frame_in_right_link_frame_1_2_of_motion_2
        * l_q_right_top_dot;
    let v_right_arm_frame_in_right_link_frame_3_2 = w_right_arm_frame_in_right_link_frame_1_2_of_motion
        * l_q_right_top_dot;
    let p_v_right_link_centre_1_2 = m * v_right_arm_frame_in_right_link_frame_1_2;
    let p_v_right_arm_frame_in_right_link_frame_3_2 = m * v_right_arm_frame_in_right_link_frame_3_2;
    let p_w_right_link_frame_2 = l * p_v_right_link_centre_1_2;
    let F_x_N_3 = g * cos_theta;
    let F_x_left_link_frame_in_left_arm_frame_1 = g * sin_theta;
    let F_x_N_3_2 = g * cos_q_right_top;
    let F_x_right_link_frame_in_right_arm_frame_1 = g * sin_q_right_top;
    let w_left_arm_frame_in_left_link_frame_1_3 = sin_theta
        .mul_add(cos_q_left_ball, cos_theta * sin_q_left_ball);
    let w_right_arm_frame_in_right_link_frame_1_3_of_place = sin_q_right_top * cos_q_right_ball;
    let w_right_arm_frame_in_right_link_frame_1_3 = cos_q_right_top
        .mul_add(sin_q_right_ball, w_right_arm_frame_in_right_link_frame_1_3_of_place);
    let v_left_arm_centre_2_3 = l * sin_theta;
    let H_left_arm_1_3 = H_left_arm_2 * sin_theta;
    let v_right_arm_centre_2_3 = l * sin_q_right_top;
    let H_right_arm_1_3 = H_left_arm_2 * sin_q_right_top;
    let v_left_link_centre_2_3 = v_left_arm_centre_2_3
        .mul_add(S::int(2), l * w_left_arm_frame_in_left_link_frame_1_3);
    let H_left_link_1_3 = w_left_arm_frame_in_left_link_frame_1_3 * H_left_arm_2;
    let v_right_link_centre_2_3 = v_right_arm_centre_2_3
        .mul_add(S::int(2), l * w_right_arm_frame_in_right_link_frame_1_3);
    let H_right_link_1_3 = w_right_arm_frame_in_right_link_frame_1_3 * H_left_arm_2;
    let p_v_right_link_centre_2_3 = m * v_right_link_centre_2_3;
    let p_v_left_link_centre_2_3 = m * v_left_link_centre_2_3;
    let p_v_right_arm_centre_2_3 = v_right_arm_centre_2_3
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_right_link_centre_2_3);
    let p_v_left_arm_centre_2_3 = v_left_arm_centre_2_3
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_left_link_centre_2_3);
    let p_w_right_arm_frame_in_right_link_frame_1_3 = p_v_right_link_centre_2_3
        .mul_add(l_times_3, H_right_link_1_3);
    let p_w_left_arm_frame_in_left_link_frame_1_3 = p_v_left_link_centre_2_3
        .mul_add(l_times_3, H_left_link_1_3);
    let p_w_spindle_frame_in_right_arm_frame_3_3 = p_w_right_arm_frame_in_right_link_frame_1_3
        * sin_q_right_ball;
    let p_w_spindle_frame_in_right_arm_frame_1_3 = p_w_right_arm_frame_in_right_link_frame_1_3
        .mul_add(cos_q_right_ball, H_right_arm_1_3) + p_v_right_arm_centre_2_3 * l_times_3;
    let p_w_spindle_frame_in_left_arm_frame_3_3 = p_w_left_arm_frame_in_left_link_frame_1_3
        * sin_q_left_ball;
    let p_w_spindle_frame_in_left_arm_frame_1_3 = p_w_left_arm_frame_in_left_link_frame_1_3
        .mul_add(cos_q_left_ball, H_left_arm_1_3) + p_v_left_arm_centre_2_3 * l_times_3;
    let v_left_arm_frame_in_left_link_frame_1_3 = l * cos_q_left_ball;
    let v_left_arm_frame_in_left_link_frame_3_3 = l * sin_q_left_ball;
    let v_left_link_centre_1_2 = v_left_arm_frame_in_left_link_frame_1_3
        .mul_add(S::int(2), l);
    let v_sleeve_centre_3_2_of_place = sin_theta + sin_theta_plus_q_left_ball;
    let v_sleeve_centre_3_2 = l * v_sleeve_centre_3_2_of_place;
    let p_v_sleeve_centre_3_2 = ms * v_sleeve_centre_3_2;
    let p_v_left_link_centre_1_3 = m * v_left_link_centre_1_2;
    let p_v_left_arm_frame_in_left_link_frame_3_3 = m * v_left_arm_frame_in_left_link_frame_3_3;
    let p_v_left_arm_centre_1 = l * m_plus_mb_times_4;
    let p_w_left_link_frame_2_2 = p_v_left_link_centre_1_3
        .mul_add(l_times_3, H_left_arm_2);
    let v_sleeve_centre_3_3 = l * sin_theta_plus_q_left_ball;
    let p_v_sleeve_centre_3_3 = ms * v_sleeve_centre_3_3;
    let p_w_left_link_frame_2_3 = mp_left_link_frame_3.mul_add(l_times_3, H_left_arm_2);
    let v_right_arm_frame_in_right_link_frame_1_3 = l * cos_q_right_ball;
    let v_right_arm_frame_in_right_link_frame_3_3 = l * sin_q_right_ball;
    let v_right_link_centre_1_2 = v_right_arm_frame_in_right_link_frame_1_3
        .mul_add(S::int(2), l);
    let p_v_right_link_centre_1_3 = m * v_right_link_centre_1_2;
    let p_v_right_arm_frame_in_right_link_frame_3_3 = m * v_right_arm_frame_in_right_link_frame_3_3;
    let p_w_right_link_frame_2_2 = p_v_right_link_centre_1_3
        .mul_add(l_times_3, H_left_arm_2);
    let d1_of_place = p_w_spindle_frame_in_right_arm_frame_1_3
        .mul_add(
            sin_q_right_top,
            p_w_spindle_frame_in_right_arm_frame_3_3 * cos_q_right_top,
        );
    let d1_of_place_2 = p_w_spindle_frame_in_left_arm_frame_1_3
        .mul_add(sin_theta, p_w_spindle_frame_in_left_arm_frame_3_3 * cos_theta);
    let d1_of_place_3 = d1_of_place + d1_of_place_2;
    let d1 = J + Js + S::ratio(1, 12) * d1_of_place_3;
    let cos_q_left_ball_doubled = S::int(2) * cos_q_left_ball;
    let d2_of_place = p_v_sleeve_centre_3_2
        .mul_add(
            v_sleeve_centre_3_2_of_place,
            p_v_left_arm_frame_in_left_link_frame_3_3 * sin_q_left_ball,
        );
    let cos_q_right_ball_doubled = S::int(2) * cos_q_right_ball;
    let sin_q_right_ball_inv = S::int(1) / sin_q_right_ball;
    let d2_of_place_2 = S::int(1) / cos_theta_plus_q_left_ball;
    let d2_of_place_3 = d2_of_place_2 * sin_q_left_ball;
    let d2_of_place_4 = sin_q_right_ball_inv * d2_of_place_3;
    let d2_of_place_5 = q_right_top + q_right_ball;
    let (sin_angle, cos_angle) = d2_of_place_5.sin_cos();
    let cos_angle_d2_of_place_4 = d2_of_place_4 * cos_angle;
    let h_left_arm_2_times_6 = S::int(6) * H_left_arm_2;
    let d2_of_place_6 = h_left_arm_2_times_6 * cos_q_right_ball;
    let d2_of_q_right_ball = S::int(1) + cos_q_right_ball;
    let d2_of_place_7 = d2_of_q_right_ball * cos_q_right_top;
    let d2_of_place_8 = d2_of_place_4 * (-sin_q_right_top).mul_add(sin_q_right_ball, d2_of_place_7);
    let d2_of_place_9 = cos_angle_d2_of_place_4
        * (H_left_arm_2 + p_w_right_link_frame_2_2
            + l_times_3
                * ((p_v_right_arm_frame_in_right_link_frame_3_3 * sin_q_right_ball)
                    .mul_add(S::int(4), p_v_left_arm_centre_1)
                    + p_v_right_link_centre_1_3 * cos_q_right_ball_doubled))
        - d2_of_place_8 * (p_w_left_link_frame_2_3 + d2_of_place_6);
    let d2_of_place_10 = d2_of_place_2 * (cos_theta + cos_theta_plus_q_left_ball);
    let d2_of_place_11 = cos_theta * cos_q_left_ball;
    let l_times_6 = S::int(6) * l;
    let d2_of_place_12 = (l_times_6
        * (sin_q_left_ball
            * p_v_sleeve_centre_3_3
                .mul_add(S::int(2), x_left_link_frame_in_left_arm_frame_3 * sin_theta)
            - x_left_link_frame_in_left_arm_frame_3 * d2_of_place_11)
        + p_w_left_link_frame_2_3 * cos_theta)
        / sin_theta.mul_add(sin_q_left_ball, -d2_of_place_11);
    let d2_of_place_13 = (v_sleeve_centre_3_2 * p_v_sleeve_centre_3_3)
        .mul_add(S::int(12), p_w_left_link_frame_2_3) + h_left_arm_2_times_6 * cos_q_left_ball;
    let d2_of_place_14 = d2_of_place_3
        * (sin_q_right_ball_inv
            * (p_w_left_link_frame_2_3 * (cos_angle - d2_of_place_7) + d2_of_place_6 * cos_angle)
            + p_w_left_link_frame_2_3 * sin_q_right_top);
    let d2_of_place_15 = H_left_arm_2 + p_w_left_link_frame_2_2;
    let d2_of_place_16 = -d2_of_place_10 * (d2_of_place_12 + d2_of_place_13)
        + cos_angle_d2_of_place_4 * d2_of_place_9;
    let d2_of_place_17 = d2_of_place_8.mul_add(d2_of_place_14, -d2_of_place_15);
    let d2_of_place_18 = d2_of_place_16 - d2_of_place_17;
    let d2 = S::ratio(1, 4) * l
        * (p_v_left_link_centre_1_3
            .mul_add(cos_q_left_ball_doubled, p_v_left_arm_centre_1)
            + S::int(4) * d2_of_place) + S::ratio(1, 12) * d2_of_place_18;
    let opening_dot_of_place = (-p_w_spindle_frame_in_left_arm_frame_1)
        .mul_add(cos_theta, p_w_spindle_frame_in_left_arm_frame_3 * sin_theta);
    let opening_dot_of_place_2 = (-p_v_left_arm_frame_in_left_link_frame_3)
        .mul_add(cos_q_left_ball_doubled, p_v_left_link_centre_1 * sin_q_left_ball);
    let opening_dot_of_place_3 = ms.mul_add(g, p_v_sleeve_centre_3);
    let opening_dot_of_place_4 = S::int(2) * opening_dot_of_place_3;
    let opening_dot_of_place_5 = S::int(6) * mp_left_link_frame_3;
    let opening_dot_of_place_6 = S::int(6) * p_w_left_link_frame_2;
    let opening_dot_of_place_7 = (-p_w_spindle_frame_in_right_arm_frame_1)
        .mul_add(
            cos_q_right_top,
            p_w_spindle_frame_in_right_arm_frame_3 * sin_q_right_top,
        );
    let opening_dot_of_place_8 = S::int(6) * p_w_right_link_frame_2;
    let g_times_6 = S::int(6) * g;
    let cos_theta_d2_of_place_2 = d2_of_place_2 * cos_theta;
    let opening_dot_of_place_9 = cos_theta_d2_of_place_2 * sin_theta_plus_q_left_ball;
    let opening_dot_of_theta_dot = theta_dot_sq * d2_of_place_2;
    let opening_dot_of_theta_dot_2 = opening_dot_of_theta_dot
        * cos_theta_d2_of_place_2.mul_add(opening_dot_of_place_9, sin_theta);
    let opening_dot_of_place_10 = d2_of_q_right_ball * sin_q_right_top;
    let opening_dot_of_place_11 = sin_q_right_ball_inv * d2_of_place_7;
    let opening_dot_of_place_12 = sin_q_right_ball_inv * cos_angle;
    let opening_dot_of_theta_dot_3 = opening_dot_of_theta_dot
        * (cos_q_left_ball * (opening_dot_of_place_11 - sin_q_right_top)
            + d2_of_place_2
                * (sin_q_right_ball_inv
                    * (cos_q_right_top
                        * (sin_q_left_ball
                            * (sin_q_left_ball
                                * (cos_q_right_top + cos_angle
                                    + sin_q_right_ball_inv
                                        * (-opening_dot_of_place_11)
                                            .mul_add(S::int(2), opening_dot_of_place_10))
                                + d2_of_q_right_ball * opening_dot_of_place_9)
                            + d2_of_q_right_ball * d2_of_place_11)
                        + opening_dot_of_place_10 * opening_dot_of_place_12
                            * sin_q_left_ball * sin_q_left_ball)
                    - cos_theta * sin_q_right_top
                        * d2_of_place_3
                            .mul_add(sin_theta_plus_q_left_ball, cos_q_left_ball)));
    let opening_dot_of_theta_dot_4 = -sin_q_right_ball_inv * opening_dot_of_theta_dot
        * (d2_of_place_2
            * (sin_q_left_ball
                * (sin_q_left_ball
                    * (sin_q_right_ball_inv
                        * (cos_angle
                            * (sin_angle + w_right_arm_frame_in_right_link_frame_1_3_of_place)
                            - cos_q_right_top
                                * (sin_angle
                                    + cos_q_right_ball
                                        * d2_of_q_right_ball
                                            .mul_add(opening_dot_of_place_12, sin_angle)))
                        + sin_q_right_top * sin_angle)
                    + opening_dot_of_place_9 * cos_angle) + d2_of_place_11 * cos_angle)
            + cos_q_left_ball * cos_angle);
    let opening_dot = S::ratio(1, 12)
        * (l_times_6
            * ((-(p_v_left_arm_frame_in_left_link_frame_3_2 * sin_q_left_ball))
                .mul_add(S::int(2), p_v_left_link_centre_1_2 * cos_q_left_ball_doubled)
                + q_left_ball_dot * opening_dot_of_place_2
                - v_sleeve_centre_3_2_of_place * opening_dot_of_place_4)
            - psi_dot * opening_dot_of_place + opening_dot_of_place_6
            + d2_of_place_10
                * (l_times_6
                    * opening_dot_of_place_4
                        .mul_add(
                            sin_theta_plus_q_left_ball,
                            theta_dot * opening_dot_of_place_2,
                        )
                    - cos_q_left_ball
                        * (-F_x_left_link_frame_in_left_arm_frame_1)
                            .mul_add(
                                opening_dot_of_place_5,
                                w_spindle_frame_in_left_arm_frame_3
                                    * p_w_left_arm_frame_in_left_link_frame_1,
                            )
                    + sin_q_left_ball
                        * F_x_N_3
                            .mul_add(
                                opening_dot_of_place_5,
                                w_spindle_frame_in_left_arm_frame_1
                                    * p_w_left_arm_frame_in_left_link_frame_1,
                            ) - opening_dot_of_place_6)
            + d2_of_place_8
                * (sin_q_right_ball
                    * ((p_v_right_link_centre_1 * l_q_right_top_dot)
                        .mul_add(
                            S::int(6),
                            w_spindle_frame_in_right_arm_frame_1
                                * p_w_right_arm_frame_in_right_link_frame_1,
                        ) + F_x_N_3_2 * opening_dot_of_place_5)
                    - cos_q_right_ball
                        * ((p_v_right_arm_frame_in_right_link_frame_3 * l_q_right_top_dot)
                            .mul_add(
                                S::int(12),
                                w_spindle_frame_in_right_arm_frame_3
                                    * p_w_right_arm_frame_in_right_link_frame_1,
                            )
                            - F_x_right_link_frame_in_right_arm_frame_1
                                * opening_dot_of_place_5) - opening_dot_of_place_8)
            - g_times_6
                * x_N_3
                    .mul_add(
                        sin_theta,
                        x_left_link_frame_in_left_arm_frame_1 * cos_theta,
                    )
            + cos_angle_d2_of_place_4
                * (l_times_6
                    * (p_v_right_link_centre_1_2 * cos_q_right_ball_doubled
                        - S::int(2) * p_v_right_arm_frame_in_right_link_frame_3_2 * sin_q_right_ball
                        - q_right_ball_dot
                            * (-p_v_right_link_centre_1)
                                .mul_add(
                                    sin_q_right_ball,
                                    p_v_right_arm_frame_in_right_link_frame_3
                                        * cos_q_right_ball_doubled,
                                )) - psi_dot * opening_dot_of_place_7 + opening_dot_of_place_8
                    - g_times_6
                        * x_N_3_2
                            .mul_add(
                                sin_q_right_top,
                                x_right_link_frame_in_right_arm_frame_1 * cos_q_right_top,
                            )) - d2_of_place_12 * opening_dot_of_theta_dot_2
            - d2_of_place_14 * opening_dot_of_theta_dot_3
            - d2_of_place_9 * opening_dot_of_theta_dot_4) / d2;
    let spin_dot = S::ratio(1, 12)
        * ((-p_w_spindle_frame_in_right_arm_frame_3_2)
            .mul_add(cos_q_right_top, theta_dot * opening_dot_of_place)
            - p_w_spindle_frame_in_right_arm_frame_1_2 * sin_q_right_top
            - p_w_spindle_frame_in_left_arm_frame_3_2 * cos_theta
            - p_w_spindle_frame_in_left_arm_frame_1_2 * sin_theta
            + q_right_top_dot * opening_dot_of_place_7) / d1;
    let psi_ddot = spin_dot;
    let theta_ddot = opening_dot;
    let q_right_top_ddot = opening_dot
        .mul_add(cos_angle_d2_of_place_4, opening_dot_of_theta_dot_4);
    let q_left_ball_ddot = (-opening_dot)
        .mul_add(d2_of_place_10, opening_dot_of_theta_dot_2);
    let q_right_ball_ddot = (-opening_dot)
        .mul_add(d2_of_place_8, opening_dot_of_theta_dot_3);
    [psi_ddot, theta_ddot, q_right_top_ddot, q_left_ball_ddot, q_right_ball_ddot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 5] {
    let [psi_dot, theta_dot, q_right_top_dot, q_left_ball_dot, q_right_ball_dot] = *q_dot;
    // Values.
    // psi'
    let psi_dot_value = psi_dot;
    // theta'
    let theta_dot_value = theta_dot;
    // q_right_top'
    let q_right_top_dot_value = q_right_top_dot;
    // q_left_ball'
    let q_left_ball_dot_value = q_left_ball_dot;
    // q_right_ball'
    let q_right_ball_dot_value = q_right_ball_dot;
    [
        psi_dot_value, theta_dot_value, q_right_top_dot_value, q_left_ball_dot_value,
        q_right_ball_dot_value,
    ]
}

/// Kinetic energy T.
///
/// 99 operations, 5 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> S {
    let Parameters { l, m, mb, ms, J, Js, .. } = *p;
    let [_, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    let [psi_dot, theta_dot, q_right_top_dot, q_left_ball_dot, q_right_ball_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_spindle_frame_in_left_arm_frame_1 = psi_dot * sin_theta;
    let w_spindle_frame_in_left_arm_frame_3 = psi_dot * cos_theta;
    let w_spindle_frame_in_right_arm_frame_1 = psi_dot * sin_q_right_top;
    let w_spindle_frame_in_right_arm_frame_3 = psi_dot * cos_q_right_top;
    let w_left_arm_frame_in_left_link_frame_1 = w_spindle_frame_in_left_arm_frame_3
        .mul_add(sin_q_left_ball, w_spindle_frame_in_left_arm_frame_1 * cos_q_left_ball);
    let w_right_arm_frame_in_right_link_frame_1 = w_spindle_frame_in_right_arm_frame_3
        .mul_add(
            sin_q_right_ball,
            w_spindle_frame_in_right_arm_frame_1 * cos_q_right_ball,
        );
    let v_left_arm_centre_2 = l * w_spindle_frame_in_left_arm_frame_1;
    let l_sq_m = l * l * m;
    let H_left_arm_1 = w_spindle_frame_in_left_arm_frame_1 * l_sq_m;
    let v_right_arm_centre_2 = l * w_spindle_frame_in_right_arm_frame_1;
    let H_right_arm_1 = w_spindle_frame_in_right_arm_frame_1 * l_sq_m;
    let v_left_link_centre_2 = v_left_arm_centre_2
        .mul_add(S::int(2), l * w_left_arm_frame_in_left_link_frame_1);
    let H_left_link_1 = w_left_arm_frame_in_left_link_frame_1 * l_sq_m;
    let v_right_link_centre_2 = v_right_arm_centre_2
        .mul_add(S::int(2), l * w_right_arm_frame_in_right_link_frame_1);
    let H_right_link_1 = w_right_arm_frame_in_right_link_frame_1 * l_sq_m;
    let w_left_link_frame_2 = theta_dot + q_left_ball_dot;
    let v_left_arm_centre_1 = l * theta_dot;
    let v_left_arm_frame_in_left_link_frame_1 = v_left_arm_centre_1 * cos_q_left_ball;
    let v_left_arm_frame_in_left_link_frame_3 = v_left_arm_centre_1 * sin_q_left_ball;
    let v_left_link_centre_1 = v_left_arm_frame_in_left_link_frame_1
        .mul_add(S::int(2), l * w_left_link_frame_2);
    let w_right_link_frame_2 = q_right_top_dot + q_right_ball_dot;
    let v_right_arm_centre_1 = l * q_right_top_dot;
    let v_right_arm_frame_in_right_link_frame_1 = v_right_arm_centre_1 * cos_q_right_ball;
    let v_right_arm_frame_in_right_link_frame_3 = v_right_arm_centre_1 * sin_q_right_ball;
    let v_right_link_centre_1 = v_right_arm_frame_in_right_link_frame_1
        .mul_add(S::int(2), l * w_right_link_frame_2);
    let H_spindle_3 = J * psi_dot;
    let H_left_arm_2_2 = theta_dot * l_sq_m;
    let H_right_arm_2 = q_right_top_dot * l_sq_m;
    let H_left_link_2 = w_left_link_frame_2 * l_sq_m;
    let H_right_link_2 = w_right_link_frame_2 * l_sq_m;
    let (sin_theta_plus_q_left_ball, _) = (theta + q_left_ball).sin_cos();
    let v_sleeve_centre_3_4 = l
        * w_left_link_frame_2.mul_add(sin_theta_plus_q_left_ball, theta_dot * sin_theta);
    let H_sleeve_3 = Js * psi_dot;
    let m_plus_mb_times_4 = mb.mul_add(S::int(4), m);
    let energy_of_place = v_left_arm_centre_1
        .mul_add(v_left_arm_centre_1, v_left_arm_centre_2 * v_left_arm_centre_2);
    let energy_of_place_2 = v_right_arm_centre_1
        .mul_add(v_right_arm_centre_1, v_right_arm_centre_2 * v_right_arm_centre_2);
    let energy_of_place_3 = v_left_link_centre_1
        .mul_add(v_left_link_centre_1, v_left_link_centre_2 * v_left_link_centre_2);
    let energy_of_place_4 = v_right_link_centre_1
        .mul_add(v_right_link_centre_1, v_right_link_centre_2 * v_right_link_centre_2);
    let energy_of_place_5 = m
        * v_right_arm_frame_in_right_link_frame_3
            .mul_add(
                v_right_arm_frame_in_right_link_frame_3,
                v_left_arm_frame_in_left_link_frame_3 * v_left_arm_frame_in_left_link_frame_3,
            ) + ms * v_sleeve_centre_3_4 * v_sleeve_centre_3_4;
    let energy_of_theta_dot = theta_dot
        .mul_add(H_left_arm_2_2, w_spindle_frame_in_left_arm_frame_1 * H_left_arm_1);
    let energy_of_motion = q_right_top_dot
        .mul_add(H_right_arm_2, w_spindle_frame_in_right_arm_frame_1 * H_right_arm_1);
    let energy_of_place_6 = w_left_link_frame_2
        .mul_add(H_left_link_2, w_left_arm_frame_in_left_link_frame_1 * H_left_link_1);
    let energy_of_place_7 = w_right_link_frame_2
        .mul_add(
            H_right_link_2,
            w_right_arm_frame_in_right_link_frame_1 * H_right_link_1,
        );
    let energy_of_motion_2 = energy_of_theta_dot + energy_of_motion;
    let energy_of_place_8 = energy_of_place_6 + energy_of_place_7;
    let energy_of_psi_dot = psi_dot * (H_spindle_3 + H_sleeve_3) + energy_of_place_5;
    let energy_of_motion_3 = energy_of_motion_2 + energy_of_place_8;
    // Values.
    let energy = S::ratio(1, 8) * m_plus_mb_times_4 * (energy_of_place + energy_of_place_2)
        + S::ratio(1, 8) * m * (energy_of_place_3 + energy_of_place_4)
        + S::ratio(1, 2) * energy_of_psi_dot + S::ratio(1, 24) * energy_of_motion_3;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 27 operations, 5 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5]) -> S {
    let Parameters { l, m, mb, ms, g, .. } = *p;
    let [_, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    // Sines and cosines.
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let l_m = l * m;
    // mp_left_arm_frame_3 = 3*l*m + 2*l*mb
    let mp_left_arm_frame_3 = (l * mb).mul_add(S::int(2), S::int(3) * l_m);
    // mp_left_link_frame_3 = l*m
    let mp_left_link_frame_3 = l_m;
    // x_left_link_frame_in_left_arm_frame_1 = mp_left_link_frame_3*sin(q_left_ball)
    let x_left_link_frame_in_left_arm_frame_1 = mp_left_link_frame_3 * sin_q_left_ball;
    // x_left_link_frame_in_left_arm_frame_3 = mp_left_link_frame_3*cos(q_left_ball)
    let x_left_link_frame_in_left_arm_frame_3 = mp_left_link_frame_3 * cos_q_left_ball;
    // x_N_3 = mp_left_arm_frame_3 + x_left_link_frame_in_left_arm_frame_3
    let x_N_3 = mp_left_arm_frame_3 + x_left_link_frame_in_left_arm_frame_3;
    // x_right_link_frame_in_right_arm_frame_1 = mp_left_link_frame_3*sin(q_right_ball)
    let x_right_link_frame_in_right_arm_frame_1 = mp_left_link_frame_3 * sin_q_right_ball;
    // x_right_link_frame_in_right_arm_frame_3 = mp_left_link_frame_3*cos(q_right_ball)
    let x_right_link_frame_in_right_arm_frame_3 = mp_left_link_frame_3 * cos_q_right_ball;
    // x_N_3_2 = mp_left_arm_frame_3 + x_right_link_frame_in_right_arm_frame_3
    let x_N_3_2 = mp_left_arm_frame_3 + x_right_link_frame_in_right_arm_frame_3;
    let (_, cos_theta_plus_q_left_ball) = (theta + q_left_ball).sin_cos();
    // mp_spindle_frame_3 = l*ms*(cos(theta) + cos(theta + q_left_ball))
    let mp_spindle_frame_3 = l * ms * (cos_theta + cos_theta_plus_q_left_ball);
    // x_left_arm_frame_in_spindle_frame_3 = x_N_3*cos(theta) -
    //   x_left_link_frame_in_left_arm_frame_1*sin(theta)
    let x_left_arm_frame_in_spindle_frame_3 = (-x_left_link_frame_in_left_arm_frame_1)
        .mul_add(sin_theta, x_N_3 * cos_theta);
    // x_N_3_3 = 2*mp_spindle_frame_3 + x_left_arm_frame_in_spindle_frame_3
    let x_N_3_3 = mp_spindle_frame_3
        .mul_add(S::int(2), x_left_arm_frame_in_spindle_frame_3);
    // x_right_arm_frame_in_spindle_frame_3 = x_N_3_2*cos(q_right_top) -
    //   x_right_link_frame_in_right_arm_frame_1*sin(q_right_top)
    let x_right_arm_frame_in_spindle_frame_3 = (-x_right_link_frame_in_right_arm_frame_1)
        .mul_add(sin_q_right_top, x_N_3_2 * cos_q_right_top);
    // x_N_3_4 = x_N_3_3 + x_right_arm_frame_in_spindle_frame_3
    let x_N_3_4 = x_N_3_3 + x_right_arm_frame_in_spindle_frame_3;
    // Values.
    // V = -g*x_N_3_4/2
    let energy = -S::ratio(1, 2) * g * x_N_3_4;
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 0 operations.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 2] {
    let [psi_dot, theta_dot, _, _, _] = *q_dot;
    // Values.
    // spin = psi'
    let spin_value = psi_dot;
    // opening = theta'
    let opening_value = theta_dot;
    [spin_value, opening_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 0 operations.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 5],
    _q_dot: &[S; 5],
    v_dot: &[S; 5],
) -> [S; 2] {
    let [psi_ddot, theta_ddot, _, _, _] = *v_dot;
    // Values.
    // spin' = psi''
    let spin_dot_value = psi_ddot;
    // opening' = theta''
    let opening_dot_value = theta_ddot;
    [spin_dot_value, opening_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 14 operations, 6 sines and cosines.
#[must_use]
pub fn motion_variables<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 2],
) -> [S; 5] {
    let [_, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    let [spin, opening] = *u;
    // Sines and cosines.
    let (sin_q_left_ball, _) = q_left_ball.sin_cos();
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    let (_, cos_theta) = theta.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    let (_, cos_theta_plus_q_left_ball) = (theta + q_left_ball).sin_cos();
    // Shared terms.
    let q_right_top_dot_value_of_place = opening / cos_theta_plus_q_left_ball;
    let q_right_top_dot_value_of_place_2 = q_right_top_dot_value_of_place
        * sin_q_left_ball / sin_q_right_ball;
    let (_, cos_angle) = (q_right_top + q_right_ball).sin_cos();
    // Values.
    // psi' = spin
    let psi_dot_value = spin;
    // theta' = opening
    let theta_dot_value = opening;
    // q_right_top' = opening*sin(q_left_ball)*cos(q_right_top + q_right_ball)/(cos(theta +
    //   q_left_ball)*sin(q_right_ball))
    let q_right_top_dot_value = q_right_top_dot_value_of_place_2 * cos_angle;
    // q_left_ball' = -opening*(cos(theta) + cos(theta + q_left_ball))/cos(theta + q_left_ball)
    let q_left_ball_dot_value = -q_right_top_dot_value_of_place
        * (cos_theta + cos_theta_plus_q_left_ball);
    // q_right_ball' = opening*sin(q_left_ball)*(sin(q_right_top)*sin(q_right_ball) - cos(q_right_top)*(1 +
    //   cos(q_right_ball)))/(cos(theta + q_left_ball)*sin(q_right_ball))
    let q_right_ball_dot_value = q_right_top_dot_value_of_place_2
        * (-cos_q_right_top * (S::int(1) + cos_q_right_ball) + sin_q_right_top * sin_q_right_ball);
    [
        psi_dot_value, theta_dot_value, q_right_top_dot_value, q_left_ball_dot_value,
        q_right_ball_dot_value,
    ]
}

/// Jacobian of the derivative by the state; columns psi, theta, q_right_top, q_left_ball, q_right_ball, psi', theta', q_right_top', q_left_ball', q_right_ball'.
///
/// 2050 operations, 6 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [[S; 10]; 10] {
    let Parameters { l, m, mb, ms, J, Js, g } = *p;
    let [_, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    let [psi_dot, theta_dot, q_right_top_dot, q_left_ball_dot, q_right_ball_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_spindle_frame_in_left_arm_frame_1 = psi_dot * sin_theta;
    let w_spindle_frame_in_left_arm_frame_3 = psi_dot * cos_theta;
    let w_spindle_frame_in_right_arm_frame_1 = psi_dot * sin_q_right_top;
    let w_spindle_frame_in_right_arm_frame_3 = psi_dot * cos_q_right_top;
    let w_left_arm_frame_in_left_link_frame_1 = w_spindle_frame_in_left_arm_frame_3
        .mul_add(sin_q_left_ball, w_spindle_frame_in_left_arm_frame_1 * cos_q_left_ball);
    let w_right_arm_frame_in_right_link_frame_1 = w_spindle_frame_in_right_arm_frame_3
        .mul_add(
            sin_q_right_ball,
            w_spindle_frame_in_right_arm_frame_1 * cos_q_right_ball,
        );
    let v_left_arm_centre_2 = l * w_spindle_frame_in_left_arm_frame_1;
    let mp_left_link_frame_3 = l * m;
    let H_left_arm_2 = l * mp_left_link_frame_3;
    let H_left_arm_1 = w_spindle_frame_in_left_arm_frame_1 * H_left_arm_2;
    let v_right_arm_centre_2 = l * w_spindle_frame_in_right_arm_frame_1;
    let H_right_arm_1 = w_spindle_frame_in_right_arm_frame_1 * H_left_arm_2;
    let v_left_link_centre_2 = v_left_arm_centre_2
        .mul_add(S::int(2), l * w_left_arm_frame_in_left_link_frame_1);
    let H_left_link_1 = w_left_arm_frame_in_left_link_frame_1 * H_left_arm_2;
    let v_right_link_centre_2 = v_right_arm_centre_2
        .mul_add(S::int(2), l * w_right_arm_frame_in_right_link_frame_1);
    let H_right_link_1 = w_right_arm_frame_in_right_link_frame_1 * H_left_arm_2;
    let p_v_right_link_centre_2 = m * v_right_link_centre_2;
    let p_v_left_link_centre_2 = m * v_left_link_centre_2;
    let mb_times_4 = S::int(4) * mb;
    let m_plus_mb_times_4 = m + mb_times_4;
    let p_v_right_arm_centre_2 = v_right_arm_centre_2
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_right_link_centre_2);
    let p_v_left_arm_centre_2 = v_left_arm_centre_2
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_left_link_centre_2);
    let l_times_3 = S::int(3) * l;
    let p_w_right_arm_frame_in_right_link_frame_1 = p_v_right_link_centre_2
        .mul_add(l_times_3, H_right_link_1);
    let p_w_left_arm_frame_in_left_link_frame_1 = p_v_left_link_centre_2
        .mul_add(l_times_3, H_left_link_1);
    let p_w_spindle_frame_in_right_arm_frame_3 = p_w_right_arm_frame_in_right_link_frame_1
        * sin_q_right_ball;
    let p_w_spindle_frame_in_right_arm_frame_1_of_place = p_w_right_arm_frame_in_right_link_frame_1
        * cos_q_right_ball;
    let p_w_spindle_frame_in_right_arm_frame_1 = p_v_right_arm_centre_2
        .mul_add(l_times_3, H_right_arm_1) + p_w_spindle_frame_in_right_arm_frame_1_of_place;
    let p_w_spindle_frame_in_left_arm_frame_3 = p_w_left_arm_frame_in_left_link_frame_1
        * sin_q_left_ball;
    let p_w_spindle_frame_in_left_arm_frame_1_of_place = p_w_left_arm_frame_in_left_link_frame_1
        * cos_q_left_ball;
    let p_w_spindle_frame_in_left_arm_frame_1 = p_v_left_arm_centre_2
        .mul_add(l_times_3, H_left_arm_1) + p_w_spindle_frame_in_left_arm_frame_1_of_place;
    let w_spindle_frame_in_left_arm_frame_1_2 = theta_dot * w_spindle_frame_in_left_arm_frame_3;
    let w_spindle_frame_in_left_arm_frame_3_2 = theta_dot * w_spindle_frame_in_left_arm_frame_1;
    let w_spindle_frame_in_right_arm_frame_1_2 = q_right_top_dot
        * w_spindle_frame_in_right_arm_frame_3;
    let w_spindle_frame_in_right_arm_frame_3_2 = q_right_top_dot
        * w_spindle_frame_in_right_arm_frame_1;
    let w_left_arm_frame_in_left_link_frame_1_2_of_place = (-w_spindle_frame_in_left_arm_frame_3)
        .mul_add(cos_q_left_ball, w_spindle_frame_in_left_arm_frame_1 * sin_q_left_ball);
    let w_left_arm_frame_in_left_link_frame_1_2 = (-w_spindle_frame_in_left_arm_frame_3_2)
        .mul_add(
            sin_q_left_ball,
            w_spindle_frame_in_left_arm_frame_1_2 * cos_q_left_ball,
        ) - q_left_ball_dot * w_left_arm_frame_in_left_link_frame_1_2_of_place;
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion = q_right_ball_dot * cos_q_right_ball;
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion_2 = q_right_ball_dot * sin_q_right_ball;
    let w_right_arm_frame_in_right_link_frame_1_2 = (-w_spindle_frame_in_right_arm_frame_3_2)
        .mul_add(
            sin_q_right_ball,
            w_spindle_frame_in_right_arm_frame_1_2 * cos_q_right_ball,
        )
        + w_spindle_frame_in_right_arm_frame_3 * w_right_arm_frame_in_right_link_frame_1_2_of_motion
        - w_spindle_frame_in_right_arm_frame_1
            * w_right_arm_frame_in_right_link_frame_1_2_of_motion_2;
    let v_left_arm_centre_2_2 = l * w_spindle_frame_in_left_arm_frame_1_2;
    let H_left_arm_1_2 = w_spindle_frame_in_left_arm_frame_1_2 * H_left_arm_2;
    let v_right_arm_centre_2_2 = l * w_spindle_frame_in_right_arm_frame_1_2;
    let H_right_arm_1_2 = w_spindle_frame_in_right_arm_frame_1_2 * H_left_arm_2;
    let v_left_link_centre_2_2 = v_left_arm_centre_2_2
        .mul_add(S::int(2), l * w_left_arm_frame_in_left_link_frame_1_2);
    let H_left_link_1_2 = w_left_arm_frame_in_left_link_frame_1_2 * H_left_arm_2;
    let v_right_link_centre_2_2 = v_right_arm_centre_2_2
        .mul_add(S::int(2), l * w_right_arm_frame_in_right_link_frame_1_2);
    let H_right_link_1_2 = w_right_arm_frame_in_right_link_frame_1_2 * H_left_arm_2;
    let p_v_right_link_centre_2_2 = m * v_right_link_centre_2_2;
    let p_v_left_link_centre_2_2 = m * v_left_link_centre_2_2;
    let p_v_right_arm_centre_2_2 = v_right_arm_centre_2_2
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_right_link_centre_2_2);
    let p_v_left_arm_centre_2_2 = v_left_arm_centre_2_2
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_left_link_centre_2_2);
    let p_w_right_arm_frame_in_right_link_frame_1_2 = p_v_right_link_centre_2_2
        .mul_add(l_times_3, H_right_link_1_2);
    let p_w_left_arm_frame_in_left_link_frame_1_2 = p_v_left_link_centre_2_2
        .mul_add(l_times_3, H_left_link_1_2);
    let p_w_spindle_frame_in_right_arm_frame_3_2 = p_w_right_arm_frame_in_right_link_frame_1
        .mul_add(
            w_right_arm_frame_in_right_link_frame_1_2_of_motion,
            p_w_right_arm_frame_in_right_link_frame_1_2 * sin_q_right_ball,
        );
    let p_w_spindle_frame_in_right_arm_frame_1_2_of_motion = (-p_w_right_arm_frame_in_right_link_frame_1)
        .mul_add(
            w_right_arm_frame_in_right_link_frame_1_2_of_motion_2,
            p_w_right_arm_frame_in_right_link_frame_1_2 * cos_q_right_ball,
        );
    let p_w_spindle_frame_in_right_arm_frame_1_2 = p_v_right_arm_centre_2_2
        .mul_add(l_times_3, H_right_arm_1_2) + p_w_spindle_frame_in_right_arm_frame_1_2_of_motion;
    let p_w_spindle_frame_in_left_arm_frame_3_2 = q_left_ball_dot
        .mul_add(
            p_w_spindle_frame_in_left_arm_frame_1_of_place,
            p_w_left_arm_frame_in_left_link_frame_1_2 * sin_q_left_ball,
        );
    let p_w_spindle_frame_in_left_arm_frame_1_2_of_motion = q_left_ball_dot * sin_q_left_ball;
    let p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2 = (-p_w_left_arm_frame_in_left_link_frame_1)
        .mul_add(
            p_w_spindle_frame_in_left_arm_frame_1_2_of_motion,
            p_w_left_arm_frame_in_left_link_frame_1_2 * cos_q_left_ball,
        );
    let p_w_spindle_frame_in_left_arm_frame_1_2 = p_v_left_arm_centre_2_2
        .mul_add(l_times_3, H_left_arm_1_2) + p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2;
    let w_left_link_frame_2 = theta_dot + q_left_ball_dot;
    let l_doubled = S::int(2) * l;
    let mp_left_arm_frame_3 = mb.mul_add(l_doubled, S::int(3) * mp_left_link_frame_3);
    let x_left_link_frame_in_left_arm_frame_1 = mp_left_link_frame_3 * sin_q_left_ball;
    let x_left_link_frame_in_left_arm_frame_3 = mp_left_link_frame_3 * cos_q_left_ball;
    let x_N_3 = mp_left_arm_frame_3 + x_left_link_frame_in_left_arm_frame_3;
    let l_theta_dot = l * theta_dot;
    let v_left_arm_frame_in_left_link_frame_1 = l_theta_dot * cos_q_left_ball;
    let v_left_arm_frame_in_left_link_frame_3 = l_theta_dot * sin_q_left_ball;
    let v_left_link_centre_1 = v_left_arm_frame_in_left_link_frame_1
        .mul_add(S::int(2), l * w_left_link_frame_2);
    let p_v_left_link_centre_1 = m * v_left_link_centre_1;
    let p_v_left_arm_frame_in_left_link_frame_3 = m * v_left_arm_frame_in_left_link_frame_3;
    let v_left_arm_frame_in_left_link_frame_1_2 = p_w_spindle_frame_in_left_arm_frame_1_2_of_motion
        * l_theta_dot;
    let v_left_arm_frame_in_left_link_frame_3_2_of_motion = q_left_ball_dot * cos_q_left_ball;
    let v_left_arm_frame_in_left_link_frame_3_2 = l_theta_dot
        * v_left_arm_frame_in_left_link_frame_3_2_of_motion;
    let theta_dot_sq = theta_dot * theta_dot;
    let w_left_link_frame_2_sq = w_left_link_frame_2 * w_left_link_frame_2;
    let theta_plus_q_left_ball = theta + q_left_ball;
    let (sin_theta_plus_q_left_ball, cos_theta_plus_q_left_ball) = theta_plus_q_left_ball
        .sin_cos();
    let v_sleeve_centre_3 = l
        * w_left_link_frame_2_sq
            .mul_add(cos_theta_plus_q_left_ball, theta_dot_sq * cos_theta);
    let p_v_sleeve_centre_3 = ms * v_sleeve_centre_3;
    let p_v_left_link_centre_1_2 = m * v_left_arm_frame_in_left_link_frame_1_2;
    let p_v_left_arm_frame_in_left_link_frame_3_2 = m * v_left_arm_frame_in_left_link_frame_3_2;
    let p_w_left_link_frame_2 = l * p_v_left_link_centre_1_2;
    let w_right_link_frame_2 = q_right_top_dot + q_right_ball_dot;
    let x_right_link_frame_in_right_arm_frame_1 = mp_left_link_frame_3 * sin_q_right_ball;
    let x_right_link_frame_in_right_arm_frame_3 = mp_left_link_frame_3 * cos_q_right_ball;
    let x_N_3_2 = mp_left_arm_frame_3 + x_right_link_frame_in_right_arm_frame_3;
    let l_q_right_top_dot = l * q_right_top_dot;
    let v_right_arm_frame_in_right_link_frame_1 = l_q_right_top_dot * cos_q_right_ball;
    let v_right_arm_frame_in_right_link_frame_3 = l_q_right_top_dot * sin_q_right_ball;
    let v_right_link_centre_1 = v_right_arm_frame_in_right_link_frame_1
        .mul_add(S::int(2), l * w_right_link_frame_2);
    let p_v_right_link_centre_1 = m * v_right_link_centre_1;
    let p_v_right_arm_frame_in_right_link_frame_3 = m * v_right_arm_frame_in_right_link_frame_3;
    let v_right_arm_frame_in_right_link_frame_1_2 = w_right_arm_frame_in_right_link_frame_1_2_of_motion_2
        * l_q_right_top_dot;
    let v_right_arm_frame_in_right_link_frame_3_2 = w_right_arm_frame_in_right_link_frame_1_2_of_motion
        * l_q_right_top_dot;
    let p_v_right_link_centre_1_2 = m * v_right_arm_frame_in_right_link_frame_1_2;
    let p_v_right_arm_frame_in_right_link_frame_3_2 = m * v_right_arm_frame_in_right_link_frame_3_2;
    let p_w_right_link_frame_2 = l * p_v_right_link_centre_1_2;
    let F_x_N_3 = g * cos_theta;
    let F_x_left_link_frame_in_left_arm_frame_1 = g * sin_theta;
    let F_x_N_3_2 = g * cos_q_right_top;
    let F_x_right_link_frame_in_right_arm_frame_1 = g * sin_q_right_top;
    let w_left_arm_frame_in_left_link_frame_1_3_of_place = sin_theta * cos_q_left_ball;
    let w_left_arm_frame_in_left_link_frame_1_3_of_place_2 = cos_theta * sin_q_left_ball;
    let w_left_arm_frame_in_left_link_frame_1_3 = w_left_arm_frame_in_left_link_frame_1_3_of_place
        + w_left_arm_frame_in_left_link_frame_1_3_of_place_2;
    let w_right_arm_frame_in_right_link_frame_1_3_of_place = cos_q_right_top * sin_q_right_ball;
    let w_right_arm_frame_in_right_link_frame_1_3_of_place_2 = sin_q_right_top * cos_q_right_ball;
    let w_right_arm_frame_in_right_link_frame_1_3 = w_right_arm_frame_in_right_link_frame_1_3_of_place
        + w_right_arm_frame_in_right_link_frame_1_3_of_place_2;
    let v_left_arm_centre_2_3 = l * sin_theta;
    let H_left_arm_1_3 = H_left_arm_2 * sin_theta;
    let v_right_arm_centre_2_3 = l * sin_q_right_top;
    let H_right_arm_1_3 = H_left_arm_2 * sin_q_right_top;
    let v_left_link_centre_2_3 = v_left_arm_centre_2_3
        .mul_add(S::int(2), l * w_left_arm_frame_in_left_link_frame_1_3);
    let H_left_link_1_3 = w_left_arm_frame_in_left_link_frame_1_3 * H_left_arm_2;
    let v_right_link_centre_2_3 = v_right_arm_centre_2_3
        .mul_add(S::int(2), l * w_right_arm_frame_in_right_link_frame_1_3);
    let H_right_link_1_3 = w_right_arm_frame_in_right_link_frame_1_3 * H_left_arm_2;
    let p_v_right_link_centre_2_3 = m * v_right_link_centre_2_3;
    let p_v_left_link_centre_2_3 = m * v_left_link_centre_2_3;
    let p_v_right_arm_centre_2_3 = v_right_arm_centre_2_3
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_right_link_centre_2_3);
    let p_v_left_arm_centre_2_3 = v_left_arm_centre_2_3
        .mul_add(m_plus_mb_times_4, S::int(2) * p_v_left_link_centre_2_3);
    let p_w_right_arm_frame_in_right_link_frame_1_3 = p_v_right_link_centre_2_3
        .mul_add(l_times_3, H_right_link_1_3);
    let p_w_left_arm_frame_in_left_link_frame_1_3 = p_v_left_link_centre_2_3
        .mul_add(l_times_3, H_left_link_1_3);
    let p_w_spindle_frame_in_right_arm_frame_3_3 = p_w_right_arm_frame_in_right_link_frame_1_3
        * sin_q_right_ball;
    let p_w_spindle_frame_in_right_arm_frame_1_3_of_place = p_w_right_arm_frame_in_right_link_frame_1_3
        * cos_q_right_ball;
    let p_w_spindle_frame_in_right_arm_frame_1_3 = p_v_right_arm_centre_2_3
        .mul_add(l_times_3, H_right_arm_1_3) + p_w_spindle_frame_in_right_arm_frame_1_3_of_place;
    let p_w_spindle_frame_in_left_arm_frame_3_3 = p_w_left_arm_frame_in_left_link_frame_1_3
        * sin_q_left_ball;
    let p_w_spindle_frame_in_left_arm_frame_1_3_of_place = p_w_left_arm_frame_in_left_link_frame_1_3
        * cos_q_left_ball;
    let p_w_spindle_frame_in_left_arm_frame_1_3 = p_v_left_arm_centre_2_3
        .mul_add(l_times_3, H_left_arm_1_3) + p_w_spindle_frame_in_left_arm_frame_1_3_of_place;
    let v_left_arm_frame_in_left_link_frame_1_3 = l * cos_q_left_ball;
    let v_left_arm_frame_in_left_link_frame_3_3 = l * sin_q_left_ball;
    let v_left_link_centre_1_2 = v_left_arm_frame_in_left_link_frame_1_3
        .mul_add(S::int(2), l);
    let v_sleeve_centre_3_2_of_place = sin_theta + sin_theta_plus_q_left_ball;
    let v_sleeve_centre_3_2 = l * v_sleeve_centre_3_2_of_place;
    let p_v_sleeve_centre_3_2 = ms * v_sleeve_centre_3_2;
    let p_v_left_link_centre_1_3 = m * v_left_link_centre_1_2;
    let p_v_left_arm_frame_in_left_link_frame_3_3 = m * v_left_arm_frame_in_left_link_frame_3_3;
    let p_v_left_arm_centre_1 = l.mul_add(mb_times_4, mp_left_link_frame_3);
    let p_w_left_link_frame_2_2 = p_v_left_link_centre_1_3
        .mul_add(l_times_3, H_left_arm_2);
    let v_sleeve_centre_3_3 = l * sin_theta_plus_q_left_ball;
    let p_v_sleeve_centre_3_3 = ms * v_sleeve_centre_3_3;
    let h_left_arm_2_times_4 = S::int(4) * H_left_arm_2;
    let p_w_left_link_frame_2_3 = h_left_arm_2_times_4;
    let v_right_arm_frame_in_right_link_frame_1_3 = l * cos_q_right_ball;
    let v_right_arm_frame_in_right_link_frame_3_3 = l * sin_q_right_ball;
    let v_right_link_centre_1_2 = v_right_arm_frame_in_right_link_frame_1_3
        .mul_add(S::int(2), l);
    let p_v_right_link_centre_1_3 = m * v_right_link_centre_1_2;
    let p_v_right_arm_frame_in_right_link_frame_3_3 = m * v_right_arm_frame_in_right_link_frame_3_3;
    let p_w_right_link_frame_2_2 = p_v_right_link_centre_1_3
        .mul_add(l_times_3, H_left_arm_2);
    let cos_q_right_top_by_12 = S::ratio(1, 12) * cos_q_right_top;
    let sin_q_right_top_by_12 = S::ratio(1, 12) * sin_q_right_top;
    let cos_theta_by_12 = S::ratio(1, 12) * cos_theta;
    let sin_theta_by_12 = S::ratio(1, 12) * sin_theta;
    let d1 = p_w_spindle_frame_in_right_arm_frame_3_3
        .mul_add(cos_q_right_top_by_12, J + Js)
        + p_w_spindle_frame_in_right_arm_frame_1_3 * sin_q_right_top_by_12
        + p_w_spindle_frame_in_left_arm_frame_3_3 * cos_theta_by_12
        + p_w_spindle_frame_in_left_arm_frame_1_3 * sin_theta_by_12;
    let cos_q_right_ball_doubled = S::int(2) * cos_q_right_ball;
    let d2_of_place = p_v_right_link_centre_1_3
        .mul_add(cos_q_right_ball_doubled, p_v_left_arm_centre_1);
    let d2_of_place_2 = S::int(4) * p_v_right_arm_frame_in_right_link_frame_3_3;
    let d2_of_place_3 = H_left_arm_2 + p_w_right_link_frame_2_2;
    let d2_of_place_4 = l_times_3 * d2_of_place_2.mul_add(sin_q_right_ball, d2_of_place)
        + d2_of_place_3;
    let d2_of_place_5 = S::int(1) / cos_theta_plus_q_left_ball;
    let sin_q_right_ball_inv = S::int(1) / sin_q_right_ball;
    let d2_of_place_6 = d2_of_place_5 * sin_q_right_ball_inv;
    let d2_of_place_7 = d2_of_place_6 * sin_q_left_ball;
    let d2_of_place_8 = q_right_top + q_right_ball;
    let (sin_angle, cos_angle) = d2_of_place_8.sin_cos();
    let cos_angle_d2_of_place_7 = d2_of_place_7 * cos_angle;
    let h_left_arm_2_times_6 = S::int(6) * H_left_arm_2;
    let d2_of_place_9 = h_left_arm_2_times_6 * cos_q_right_ball;
    let d2_of_place_10 = p_w_left_link_frame_2_3 + d2_of_place_9;
    let d2_of_q_right_ball = S::int(1) + cos_q_right_ball;
    let d2_of_place_11 = d2_of_q_right_ball * cos_q_right_top;
    let d2_of_place_12 = sin_q_right_top * sin_q_right_ball;
    let d2_of_place_13 = d2_of_place_11 - d2_of_place_12;
    let d2_of_place_14 = d2_of_place_7 * d2_of_place_13;
    let d2_of_place_15 = d2_of_place_10 * d2_of_place_14;
    let d2_of_place_16 = d2_of_place_4.mul_add(cos_angle_d2_of_place_7, -d2_of_place_15);
    let d2_of_place_17 = S::ratio(1, 12) * cos_angle_d2_of_place_7;
    let d2_of_place_18 = cos_theta + cos_theta_plus_q_left_ball;
    let d2_of_place_19 = d2_of_place_5 * d2_of_place_18;
    let d2_of_place_20 = (v_sleeve_centre_3_2 * p_v_sleeve_centre_3_3)
        .mul_add(S::int(12), p_w_left_link_frame_2_3) + h_left_arm_2_times_6 * cos_q_left_ball;
    let d2_of_place_21 = p_v_sleeve_centre_3_3
        .mul_add(S::int(2), x_left_link_frame_in_left_arm_frame_3 * sin_theta);
    let d2_of_place_22 = cos_theta * cos_q_left_ball;
    let l_times_6 = S::int(6) * l;
    let d2_of_place_23 = sin_theta.mul_add(sin_q_left_ball, -d2_of_place_22);
    let d2_of_place_23_inv = S::int(1) / d2_of_place_23;
    let d2_of_place_24 = d2_of_place_23_inv
        * (l_times_6
            * (-x_left_link_frame_in_left_arm_frame_3)
                .mul_add(d2_of_place_22, d2_of_place_21 * sin_q_left_ball)
            + p_w_left_link_frame_2_3 * cos_theta);
    let d2_of_place_25 = d2_of_place_20 + d2_of_place_24;
    let d2_of_place_25_by_12 = S::ratio(1, 12) * d2_of_place_25;
    let cos_q_left_ball_doubled = S::int(2) * cos_q_left_ball;
    let d2_of_place_26 = p_v_sleeve_centre_3_2
        .mul_add(
            v_sleeve_centre_3_2_of_place,
            p_v_left_arm_frame_in_left_link_frame_3_3 * sin_q_left_ball,
        );
    let l_by_4 = S::ratio(1, 4) * l;
    let d2_of_place_27 = cos_angle - d2_of_place_11;
    let d2_of_place_28 = p_w_left_link_frame_2_3
        .mul_add(d2_of_place_27, d2_of_place_9 * cos_angle);
    let d2_of_place_29 = p_w_left_link_frame_2_3 * sin_q_right_top;
    let d2_of_place_30 = sin_q_right_ball_inv.mul_add(d2_of_place_28, d2_of_place_29);
    let d2_of_place_31 = d2_of_place_5 * sin_q_left_ball;
    let d2_of_place_32 = d2_of_place_30 * d2_of_place_31;
    let d2_of_place_33 = d2_of_place_14 * d2_of_place_32;
    let d2_of_place_34 = H_left_arm_2 + p_w_left_link_frame_2_2;
    let d2_of_place_35 = d2_of_place_34 - d2_of_place_33;
    let d2 = d2_of_place_16 * d2_of_place_17 - d2_of_place_19 * d2_of_place_25_by_12
        + l_by_4
            * (p_v_left_link_centre_1_3
                .mul_add(cos_q_left_ball_doubled, p_v_left_arm_centre_1)
                + S::int(4) * d2_of_place_26) + S::ratio(1, 12) * d2_of_place_35;
    let opening_dot_of_place = (-p_w_spindle_frame_in_left_arm_frame_1)
        .mul_add(cos_theta, p_w_spindle_frame_in_left_arm_frame_3 * sin_theta);
    let opening_dot_of_place_2 = (-p_v_left_arm_frame_in_left_link_frame_3)
        .mul_add(cos_q_left_ball_doubled, p_v_left_link_centre_1 * sin_q_left_ball);
    let sin_q_left_ball_doubled = S::int(2) * sin_q_left_ball;
    let opening_dot_of_place_3 = ms.mul_add(g, p_v_sleeve_centre_3);
    let opening_dot_of_place_4 = S::int(2) * opening_dot_of_place_3;
    let opening_dot_of_theta_dot = theta_dot_sq * d2_of_place_5;
    let opening_dot_of_place_5 = d2_of_q_right_ball * sin_q_right_top;
    let opening_dot_of_q_right_ball = sin_q_right_ball_inv * d2_of_q_right_ball;
    let cos_q_right_top_doubled = S::int(2) * cos_q_right_top;
    let opening_dot_of_place_6 = opening_dot_of_q_right_ball * cos_q_right_top_doubled;
    let opening_dot_of_place_7 = opening_dot_of_place_5 - opening_dot_of_place_6;
    let opening_dot_of_place_8 = cos_q_right_top + cos_angle;
    let opening_dot_of_place_9 = sin_q_right_ball_inv
        .mul_add(opening_dot_of_place_7, opening_dot_of_place_8);
    let opening_dot_of_place_10 = d2_of_place_5 * sin_theta_plus_q_left_ball;
    let opening_dot_of_place_11 = opening_dot_of_place_10 * cos_theta;
    let opening_dot_of_place_12 = d2_of_q_right_ball
        .mul_add(opening_dot_of_place_11, opening_dot_of_place_9 * sin_q_left_ball);
    let opening_dot_of_place_13 = opening_dot_of_place_12
        .mul_add(sin_q_left_ball, d2_of_q_right_ball * d2_of_place_22);
    let opening_dot_of_place_14 = opening_dot_of_q_right_ball * sin_q_right_top;
    let opening_dot_of_place_15 = sin_q_left_ball * cos_angle;
    let opening_dot_of_place_16 = opening_dot_of_place_15 * sin_q_left_ball;
    let opening_dot_of_place_17 = opening_dot_of_place_14
        .mul_add(opening_dot_of_place_16, opening_dot_of_place_13 * cos_q_right_top);
    let opening_dot_of_place_18 = opening_dot_of_place_10 * sin_q_left_ball;
    let opening_dot_of_place_19 = cos_q_left_ball + opening_dot_of_place_18;
    let opening_dot_of_place_20 = cos_theta * sin_q_right_top;
    let opening_dot_of_place_21 = (-opening_dot_of_place_19)
        .mul_add(
            opening_dot_of_place_20,
            sin_q_right_ball_inv * opening_dot_of_place_17,
        );
    let opening_dot_of_place_22 = opening_dot_of_q_right_ball * cos_q_right_top;
    let opening_dot_of_place_23 = sin_q_right_top - opening_dot_of_place_22;
    let opening_dot_of_place_24 = opening_dot_of_place_23 * cos_q_left_ball;
    let opening_dot_of_place_25 = d2_of_place_5
        .mul_add(opening_dot_of_place_21, -opening_dot_of_place_24);
    let opening_dot_of_place_26 = d2_of_place_32 * opening_dot_of_place_25;
    let cos_theta_d2_of_place_5 = d2_of_place_5 * cos_theta;
    let opening_dot_of_place_27 = opening_dot_of_place_11
        .mul_add(cos_theta_d2_of_place_5, sin_theta);
    let opening_dot_of_place_28 = d2_of_place_24 * opening_dot_of_place_27;
    let opening_dot_of_place_29 = opening_dot_of_place_26 + opening_dot_of_place_28;
    let g_times_6 = S::int(6) * g;
    let opening_dot_of_place_30 = S::int(6) * mp_left_link_frame_3;
    let opening_dot_of_place_31 = w_spindle_frame_in_right_arm_frame_1
        * p_w_right_arm_frame_in_right_link_frame_1;
    let opening_dot_of_motion = F_x_N_3_2
        .mul_add(
            opening_dot_of_place_30,
            q_right_top_dot * p_v_right_link_centre_1 * l_times_6,
        ) + opening_dot_of_place_31;
    let opening_dot_of_place_32 = w_spindle_frame_in_right_arm_frame_3
        * p_w_right_arm_frame_in_right_link_frame_1;
    let opening_dot_of_motion_2 = (-F_x_right_link_frame_in_right_arm_frame_1)
        .mul_add(
            opening_dot_of_place_30,
            S::int(12) * p_v_right_arm_frame_in_right_link_frame_3 * l_q_right_top_dot,
        ) + opening_dot_of_place_32;
    let opening_dot_of_place_33 = S::int(6) * p_w_right_link_frame_2;
    let opening_dot_of_motion_3 = (-opening_dot_of_motion)
        .mul_add(sin_q_right_ball, opening_dot_of_motion_2 * cos_q_right_ball)
        + opening_dot_of_place_33;
    let opening_dot_of_place_34 = sin_angle + w_right_arm_frame_in_right_link_frame_1_3_of_place_2;
    let opening_dot_of_place_35 = opening_dot_of_q_right_ball
        .mul_add(cos_angle, sin_angle);
    let opening_dot_of_place_36 = opening_dot_of_place_35
        .mul_add(cos_q_right_ball, sin_angle);
    let opening_dot_of_place_37 = opening_dot_of_place_36 * cos_q_right_top;
    let opening_dot_of_place_38 = (-opening_dot_of_place_34)
        .mul_add(cos_angle, opening_dot_of_place_37);
    let opening_dot_of_place_39 = sin_q_right_top * sin_angle;
    let opening_dot_of_place_40 = sin_q_right_ball_inv
        .mul_add(opening_dot_of_place_38, -opening_dot_of_place_39);
    let opening_dot_of_place_41 = (-opening_dot_of_place_11)
        .mul_add(cos_angle, opening_dot_of_place_40 * sin_q_left_ball);
    let opening_dot_of_place_42 = (-d2_of_place_22)
        .mul_add(cos_angle, opening_dot_of_place_41 * sin_q_left_ball);
    let opening_dot_of_place_43 = cos_q_left_ball * cos_angle;
    let opening_dot_of_place_44 = d2_of_place_5
        .mul_add(opening_dot_of_place_42, -opening_dot_of_place_43);
    let opening_dot_of_theta_dot_2 = theta_dot_sq * d2_of_place_6;
    let opening_dot_of_theta_dot_3 = d2_of_place_16 * opening_dot_of_theta_dot_2;
    let opening_dot_of_motion_4 = opening_dot_of_place_44
        .mul_add(opening_dot_of_theta_dot_3, d2_of_place_14 * opening_dot_of_motion_3);
    let opening_dot_of_place_45 = (-p_w_spindle_frame_in_right_arm_frame_1)
        .mul_add(
            cos_q_right_top,
            p_w_spindle_frame_in_right_arm_frame_3 * sin_q_right_top,
        );
    let sin_q_right_ball_doubled = S::int(2) * sin_q_right_ball;
    let opening_dot_of_motion_5 = opening_dot_of_place_33
        - g_times_6
            * x_N_3_2
                .mul_add(
                    sin_q_right_top,
                    x_right_link_frame_in_right_arm_frame_1 * cos_q_right_top,
                ) - psi_dot * opening_dot_of_place_45
        + l_times_6
            * (q_right_ball_dot
                * (-p_v_right_arm_frame_in_right_link_frame_3)
                    .mul_add(
                        cos_q_right_ball_doubled,
                        p_v_right_link_centre_1 * sin_q_right_ball,
                    ) + p_v_right_link_centre_1_2 * cos_q_right_ball_doubled
                - p_v_right_arm_frame_in_right_link_frame_3_2 * sin_q_right_ball_doubled);
    let opening_dot_of_place_46 = w_spindle_frame_in_left_arm_frame_1
        * p_w_left_arm_frame_in_left_link_frame_1;
    let opening_dot_of_place_47 = F_x_N_3
        .mul_add(opening_dot_of_place_30, opening_dot_of_place_46);
    let opening_dot_of_place_48 = w_spindle_frame_in_left_arm_frame_3
        * p_w_left_arm_frame_in_left_link_frame_1;
    let opening_dot_of_place_49 = (-F_x_left_link_frame_in_left_arm_frame_1)
        .mul_add(opening_dot_of_place_30, opening_dot_of_place_48);
    let opening_dot_of_place_50 = S::int(6) * p_w_left_link_frame_2;
    let opening_dot_of_theta_dot_4 = -l_times_6
        * opening_dot_of_place_4
            .mul_add(sin_theta_plus_q_left_ball, theta_dot * opening_dot_of_place_2)
        + opening_dot_of_place_49 * cos_q_left_ball
        - opening_dot_of_place_47 * sin_q_left_ball + opening_dot_of_place_50;
    let opening_dot_of_motion_6 = (-d2_of_place_19)
        .mul_add(
            opening_dot_of_theta_dot_4,
            cos_angle_d2_of_place_7 * opening_dot_of_motion_5,
        );
    let opening_dot_of_motion_7 = opening_dot_of_motion_4 - opening_dot_of_motion_6;
    let d2_inv = S::int(1) / d2;
    let d2_inv_by_12 = S::ratio(1, 12) * d2_inv;
    let opening_dot = d2_inv_by_12
        * (l_times_6
            * (q_left_ball_dot
                .mul_add(
                    opening_dot_of_place_2,
                    p_v_left_link_centre_1_2 * cos_q_left_ball_doubled,
                ) - p_v_left_arm_frame_in_left_link_frame_3_2 * sin_q_left_ball_doubled
                - v_sleeve_centre_3_2_of_place * opening_dot_of_place_4)
            - psi_dot * opening_dot_of_place - opening_dot_of_theta_dot * opening_dot_of_place_29
            - g_times_6
                * x_N_3
                    .mul_add(
                        sin_theta,
                        x_left_link_frame_in_left_arm_frame_1 * cos_theta,
                    ) + opening_dot_of_place_50 - opening_dot_of_motion_7);
    let psi_dot_d2_of_place_23 = psi_dot * d2_of_place_23;
    let w_left_arm_frame_in_left_link_frame_1_by_theta_of_psi_dot = -psi_dot_d2_of_place_23;
    let w_left_arm_frame_in_left_link_frame_1_by_theta = w_left_arm_frame_in_left_link_frame_1_by_theta_of_psi_dot;
    let H_left_arm_1_by_theta = w_spindle_frame_in_left_arm_frame_3 * H_left_arm_2;
    let v_left_link_centre_2_by_theta_of_place = S::int(2) * w_spindle_frame_in_left_arm_frame_3;
    let v_left_link_centre_2_by_theta = l
        * (w_left_arm_frame_in_left_link_frame_1_by_theta + v_left_link_centre_2_by_theta_of_place);
    let m_doubled = S::int(2) * m;
    let l_m_plus_mb_times_4 = l * m_plus_mb_times_4;
    let p_v_left_arm_centre_2_by_theta_of_place = w_spindle_frame_in_left_arm_frame_3
        * l_m_plus_mb_times_4;
    let p_v_left_arm_centre_2_by_theta = v_left_link_centre_2_by_theta
        .mul_add(m_doubled, p_v_left_arm_centre_2_by_theta_of_place);
    let p_w_spindle_frame_in_left_arm_frame_3_by_theta_of_place = v_left_link_centre_2_by_theta
        .mul_add(S::int(3), l * w_left_arm_frame_in_left_link_frame_1_by_theta);
    let p_w_spindle_frame_in_left_arm_frame_3_by_theta = x_left_link_frame_in_left_arm_frame_1
        * p_w_spindle_frame_in_left_arm_frame_3_by_theta_of_place;
    let m_cos_q_left_ball = m * cos_q_left_ball;
    let p_w_spindle_frame_in_left_arm_frame_1_by_theta = H_left_arm_1_by_theta
        + l
            * p_w_spindle_frame_in_left_arm_frame_3_by_theta_of_place
                .mul_add(m_cos_q_left_ball, S::int(3) * p_v_left_arm_centre_2_by_theta);
    let w_left_arm_frame_in_left_link_frame_1_2_by_theta = -psi_dot * w_left_link_frame_2
        * w_left_arm_frame_in_left_link_frame_1_3;
    let v_left_arm_centre_2_2_by_theta = -w_spindle_frame_in_left_arm_frame_1 * l_theta_dot;
    let H_left_arm_1_2_by_theta = -theta_dot * H_left_arm_1;
    let p_v_left_arm_centre_2_2_by_theta_of_place = w_left_arm_frame_in_left_link_frame_1_2_by_theta
        * l_doubled;
    let p_v_left_arm_centre_2_2_by_theta = m
        * v_left_arm_centre_2_2_by_theta
            .mul_add(S::int(5), p_v_left_arm_centre_2_2_by_theta_of_place)
        + v_left_arm_centre_2_2_by_theta * mb_times_4;
    let p_w_left_arm_frame_in_left_link_frame_1_2_by_theta_of_place = S::int(2)
        * mp_left_link_frame_3;
    let p_w_left_arm_frame_in_left_link_frame_1_2_by_theta = p_w_left_arm_frame_in_left_link_frame_1_2_by_theta_of_place
        * v_left_arm_centre_2_2_by_theta
            .mul_add(S::int(3), p_v_left_arm_centre_2_2_by_theta_of_place);
    let p_v_left_arm_frame_in_left_link_frame_3_2_by_theta_dot = q_left_ball_dot
        * x_left_link_frame_in_left_arm_frame_3;
    let p_w_spindle_frame_in_left_arm_frame_3_2_by_theta = p_v_left_arm_frame_in_left_link_frame_3_2_by_theta_dot
        .mul_add(
            p_w_spindle_frame_in_left_arm_frame_3_by_theta_of_place,
            p_w_left_arm_frame_in_left_link_frame_1_2_by_theta * sin_q_left_ball,
        );
    let p_w_spindle_frame_in_left_arm_frame_1_2_by_theta = H_left_arm_1_2_by_theta
        + p_w_left_arm_frame_in_left_link_frame_1_2_by_theta * cos_q_left_ball
        + l
            * (-(m * p_w_spindle_frame_in_left_arm_frame_1_2_of_motion))
                .mul_add(
                    p_w_spindle_frame_in_left_arm_frame_3_by_theta_of_place,
                    S::int(3) * p_v_left_arm_centre_2_2_by_theta,
                );
    let v_sleeve_centre_3_by_theta = -l
        * w_left_link_frame_2_sq
            .mul_add(sin_theta_plus_q_left_ball, theta_dot_sq * sin_theta);
    let minus_d2_of_place_23 = -d2_of_place_23;
    let w_left_arm_frame_in_left_link_frame_1_3_by_theta = minus_d2_of_place_23;
    let H_left_arm_1_3_by_theta = H_left_arm_2 * cos_theta;
    let v_left_link_centre_2_3_by_theta = l
        * cos_theta.mul_add(S::int(2), w_left_arm_frame_in_left_link_frame_1_3_by_theta);
    let p_v_left_arm_centre_2_3_by_theta = l_m_plus_mb_times_4
        .mul_add(cos_theta, v_left_link_centre_2_3_by_theta * m_doubled);
    let p_w_spindle_frame_in_left_arm_frame_3_3_by_theta_of_place = v_left_link_centre_2_3_by_theta
        .mul_add(S::int(3), l * w_left_arm_frame_in_left_link_frame_1_3_by_theta);
    let p_w_spindle_frame_in_left_arm_frame_3_3_by_theta = x_left_link_frame_in_left_arm_frame_1
        * p_w_spindle_frame_in_left_arm_frame_3_3_by_theta_of_place;
    let p_w_spindle_frame_in_left_arm_frame_1_3_by_theta = H_left_arm_1_3_by_theta
        + l
            * m_cos_q_left_ball
                .mul_add(
                    p_w_spindle_frame_in_left_arm_frame_3_3_by_theta_of_place,
                    S::int(3) * p_v_left_arm_centre_2_3_by_theta,
                );
    let v_sleeve_centre_3_2_by_theta = l * d2_of_place_18;
    let p_v_sleeve_centre_3_3_by_theta = l * ms * cos_theta_plus_q_left_ball;
    let d1_by_theta = cos_theta_by_12
        * (p_w_spindle_frame_in_left_arm_frame_1_3
            + p_w_spindle_frame_in_left_arm_frame_3_3_by_theta)
        + sin_theta_by_12
            * (p_w_spindle_frame_in_left_arm_frame_1_3_by_theta
                - p_w_spindle_frame_in_left_arm_frame_3_3);
    let d2_by_theta_of_place = ms * v_sleeve_centre_3_2_of_place;
    let d2_by_theta_of_place_2 = v_sleeve_centre_3_2_of_place * d2_of_place_5;
    let d2_by_theta_of_place_3 = mp_left_link_frame_3 * d2_of_place_22;
    let d2_by_theta_of_place_4 = l_times_6
        * (sin_q_left_ball
            * p_v_sleeve_centre_3_3_by_theta.mul_add(S::int(2), d2_by_theta_of_place_3)
            + x_left_link_frame_in_left_arm_frame_3
                * w_left_arm_frame_in_left_link_frame_1_3_of_place)
        - p_w_left_link_frame_2_3 * sin_theta;
    let d2_by_theta_of_place_5 = d2_of_place_19 * d2_of_place_23_inv;
    let d2_by_theta_of_place_6 = w_left_arm_frame_in_left_link_frame_1_3
        .mul_add(d2_of_place_23_inv, -opening_dot_of_place_10);
    let d2_by_theta_of_place_7 = S::int(2) * opening_dot_of_place_10;
    let d2_by_theta_of_place_8 = d2_of_place_19
        * (-d2_of_place_24)
            .mul_add(d2_by_theta_of_place_6, d2_of_place_20 * opening_dot_of_place_10)
        + d2_of_place_33 * d2_by_theta_of_place_7;
    let d2_by_theta_of_place_9 = S::ratio(1, 12) * d2_by_theta_of_place_8;
    let d2_by_theta_of_place_10 = d2_of_place_16 * opening_dot_of_place_10;
    let d2_by_theta_of_place_11 = d2_of_place_17 * d2_by_theta_of_place_10;
    let d2_by_theta = l
        * v_sleeve_centre_3_2_by_theta
            .mul_add(d2_by_theta_of_place, p_v_sleeve_centre_3_2 * d2_of_place_18)
        - d2_of_place_19
            * v_sleeve_centre_3_2
                .mul_add(
                    p_v_sleeve_centre_3_3_by_theta,
                    p_v_sleeve_centre_3_3 * v_sleeve_centre_3_2_by_theta,
                ) + d2_of_place_25_by_12 * d2_by_theta_of_place_2
        - S::ratio(1, 12) * d2_by_theta_of_place_4 * d2_by_theta_of_place_5
        - d2_by_theta_of_place_9 + S::int(2) * d2_by_theta_of_place_11;
    let opening_dot_by_theta_of_place = sin_theta
        * (p_w_spindle_frame_in_left_arm_frame_1 + p_w_spindle_frame_in_left_arm_frame_3_by_theta)
        + cos_theta
            * (p_w_spindle_frame_in_left_arm_frame_3
                - p_w_spindle_frame_in_left_arm_frame_1_by_theta);
    let opening_dot_by_theta_of_place_2 = g * opening_dot_of_place_30;
    let opening_dot_by_theta_of_place_3 = w_spindle_frame_in_left_arm_frame_1
        * mp_left_link_frame_3;
    let opening_dot_by_theta_of_place_4 = w_spindle_frame_in_left_arm_frame_3
        * mp_left_link_frame_3;
    let l_times_12 = S::int(12) * l;
    let opening_dot_by_theta_of_place_5 = x_left_link_frame_in_left_arm_frame_1 * sin_theta;
    let opening_dot_by_theta_of_place_6 = opening_dot_of_place_10
        .mul_add(opening_dot_of_place_11, cos_theta);
    let opening_dot_by_theta_of_place_7 = opening_dot_of_place_10 * sin_theta;
    let opening_dot_by_theta_of_place_8 = opening_dot_by_theta_of_place_7
        - opening_dot_by_theta_of_place_6;
    let opening_dot_by_theta_of_place_9 = d2_of_place_5 * opening_dot_of_place_10;
    let opening_dot_by_theta_of_place_10 = opening_dot_of_place_42
        * opening_dot_by_theta_of_place_9;
    let opening_dot_by_theta_of_place_11 = sin_q_right_ball_inv * cos_q_right_top;
    let opening_dot_by_theta_of_place_12 = opening_dot_of_place_21
        * opening_dot_by_theta_of_place_9;
    let opening_dot_by_theta_of_theta_dot = d2_of_place_32 * opening_dot_of_theta_dot;
    let opening_dot_by_theta_of_theta_dot_2 = opening_dot_of_place_44 * opening_dot_of_theta_dot_2;
    let opening_dot_by_theta_of_theta_dot_3 = opening_dot_of_theta_dot
        * (-opening_dot_of_place_26)
            .mul_add(
                d2_by_theta_of_place_7,
                opening_dot_of_place_28 * d2_by_theta_of_place_6,
            );
    let opening_dot_by_theta_of_place_13 = d2_of_place_5 * opening_dot_of_place_11;
    let opening_dot_by_theta_of_place_14 = (opening_dot_of_place_11
        * opening_dot_by_theta_of_place_13)
        .mul_add(S::int(2), cos_theta_d2_of_place_5 * cos_theta);
    let sin_theta_doubled = S::int(2) * sin_theta;
    let opening_dot_by_theta_of_theta_dot_4 = d2_of_place_24 * opening_dot_of_theta_dot;
    let opening_dot_by_theta_of_theta_dot_5 = d2_of_place_23_inv
        * opening_dot_of_theta_dot * opening_dot_of_place_27;
    let opening_dot_d2_inv = opening_dot * d2_inv;
    let opening_dot_by_theta = d2_inv_by_12
        * (opening_dot_of_theta_dot_4 * d2_by_theta_of_place_2
            - opening_dot_of_place_10 * opening_dot_of_motion_7
            - psi_dot * opening_dot_by_theta_of_place
            - l_times_12
                * v_sleeve_centre_3_by_theta
                    .mul_add(
                        d2_by_theta_of_place,
                        d2_of_place_18 * opening_dot_of_place_3,
                    )
            + d2_of_place_19
                * (sin_q_left_ball
                    * ((-opening_dot_by_theta_of_place_2)
                        .mul_add(sin_theta, opening_dot_of_place_48)
                        + p_w_spindle_frame_in_left_arm_frame_3_by_theta_of_place
                            * opening_dot_by_theta_of_place_3)
                    + cos_q_left_ball
                        * (opening_dot_by_theta_of_place_2
                            .mul_add(cos_theta, opening_dot_of_place_46)
                            - p_w_spindle_frame_in_left_arm_frame_3_by_theta_of_place
                                * opening_dot_by_theta_of_place_4)
                    + l_times_12
                        * opening_dot_of_place_3
                            .mul_add(
                                cos_theta_plus_q_left_ball,
                                ms * v_sleeve_centre_3_by_theta * sin_theta_plus_q_left_ball,
                            ))
            + g_times_6 * (-x_N_3).mul_add(cos_theta, opening_dot_by_theta_of_place_5)
            - opening_dot_of_theta_dot_3
                * (d2_of_place_5
                    * (opening_dot_by_theta_of_place_8 * sin_q_left_ball)
                        .mul_add(
                            cos_angle,
                            w_left_arm_frame_in_left_link_frame_1_3_of_place * cos_angle,
                        ) + opening_dot_by_theta_of_place_10)
            - opening_dot_by_theta_of_theta_dot
                * (d2_of_place_5
                    * (-opening_dot_of_place_20
                        * opening_dot_of_place_10
                            .mul_add(opening_dot_of_place_18, sin_q_left_ball)
                        + opening_dot_of_place_19 * sin_theta * sin_q_right_top
                        - opening_dot_by_theta_of_place_11
                            * (d2_of_q_right_ball * opening_dot_by_theta_of_place_8)
                                .mul_add(
                                    sin_q_left_ball,
                                    w_left_arm_frame_in_left_link_frame_1_3_of_place
                                        * d2_of_q_right_ball,
                                )) + opening_dot_by_theta_of_place_12)
            - d2_by_theta_of_place_10 * opening_dot_by_theta_of_theta_dot_2
            + opening_dot_by_theta_of_theta_dot_3
            + opening_dot_by_theta_of_theta_dot_4
                * (opening_dot_by_theta_of_place_13
                    .mul_add(sin_theta_doubled, -cos_theta) - opening_dot_by_theta_of_place_14)
            - d2_by_theta_of_place_4 * opening_dot_by_theta_of_theta_dot_5)
        - d2_by_theta * opening_dot_d2_inv;
    let d1_inv = S::int(1) / d1;
    let spin_dot_by_theta_of_motion = d1_inv
        * (p_w_spindle_frame_in_right_arm_frame_1_2
            .mul_add(
                sin_q_right_top,
                p_w_spindle_frame_in_right_arm_frame_3_2 * cos_q_right_top,
            ) + p_w_spindle_frame_in_left_arm_frame_3_2 * cos_theta
            + p_w_spindle_frame_in_left_arm_frame_1_2 * sin_theta - theta_dot * opening_dot_of_place
            - q_right_top_dot * opening_dot_of_place_45);
    let d1_inv_by_12 = S::ratio(1, 12) * d1_inv;
    let spin_dot_by_theta = d1_inv_by_12
        * (sin_theta
            * (p_w_spindle_frame_in_left_arm_frame_3_2
                - p_w_spindle_frame_in_left_arm_frame_1_2_by_theta)
            - cos_theta
                * (p_w_spindle_frame_in_left_arm_frame_1_2
                    + p_w_spindle_frame_in_left_arm_frame_3_2_by_theta)
            + theta_dot * opening_dot_by_theta_of_place
            + d1_by_theta * spin_dot_by_theta_of_motion);
    let q_right_top_ddot_by_theta_of_place = S::int(3) * opening_dot_of_place_11;
    let q_right_top_ddot_by_theta_of_place_2 = sin_theta - q_right_top_ddot_by_theta_of_place;
    let q_right_top_ddot_by_theta_of_place_3 = cos_q_left_ball_doubled * cos_theta;
    let q_right_top_ddot_by_theta_of_place_4 = w_left_arm_frame_in_left_link_frame_1_3_of_place
        - w_left_arm_frame_in_left_link_frame_1_3_of_place_2;
    let q_right_top_ddot_by_theta_of_place_5 = -q_right_top_ddot_by_theta_of_place_4;
    let q_right_top_ddot_by_theta_of_opening_dot = opening_dot * sin_theta_plus_q_left_ball;
    let q_right_top_ddot_by_theta = d2_of_place_6
        * (-d2_of_place_5
            * (theta_dot_sq
                * (sin_theta_plus_q_left_ball
                    * (opening_dot_of_place_43
                        + d2_of_place_5
                            * (-sin_q_left_ball
                                * q_right_top_ddot_by_theta_of_place_2
                                    .mul_add(
                                        cos_angle,
                                        sin_q_left_ball_doubled * opening_dot_of_place_40,
                                    ) + q_right_top_ddot_by_theta_of_place_3 * cos_angle))
                    + q_right_top_ddot_by_theta_of_place_5 * cos_angle)
                - opening_dot_of_place_15 * q_right_top_ddot_by_theta_of_opening_dot)
            + opening_dot_by_theta * opening_dot_of_place_15);
    let q_left_ball_ddot_by_theta_of_place = cos_theta
        * (S::int(1) + S::int(3) * opening_dot_of_place_10 * opening_dot_of_place_10);
    let q_left_ball_ddot_by_theta_of_opening_dot = opening_dot * opening_dot_of_place_10;
    let q_left_ball_ddot_by_theta = d2_of_place_5
        * (sin_theta * theta_dot_sq.mul_add(opening_dot_of_place_10, opening_dot)
            - cos_theta
                * (opening_dot_by_theta
                    - theta_dot_sq
                        * (S::int(1)
                            + d2_of_place_5
                                * (-opening_dot_of_place_10)
                                    .mul_add(
                                        sin_theta_doubled, q_left_ball_ddot_by_theta_of_place,
                                    )) + q_left_ball_ddot_by_theta_of_opening_dot))
        - opening_dot_by_theta;
    let q_right_ball_ddot_by_theta_of_place = d2_of_q_right_ball
        .mul_add(
            q_right_top_ddot_by_theta_of_place,
            sin_q_left_ball_doubled * opening_dot_of_place_9,
        );
    let q_right_ball_ddot_by_theta_of_place_2 = S::int(2) * opening_dot_of_place_14;
    let q_right_ball_ddot_by_theta_of_place_3 = opening_dot_of_place_23 * sin_q_left_ball;
    let q_right_ball_ddot_by_theta = d2_of_place_5
        * (-d2_of_place_5
            * (theta_dot_sq
                * (d2_of_q_right_ball * opening_dot_by_theta_of_place_11
                    * q_right_top_ddot_by_theta_of_place_4
                    + q_right_top_ddot_by_theta_of_place_5 * sin_q_right_top
                    + sin_theta_plus_q_left_ball
                        * (opening_dot_of_place_24
                            + d2_of_place_5
                                * (-sin_q_left_ball
                                    * (sin_q_right_ball_inv
                                        * (cos_q_right_top
                                            * (-d2_of_q_right_ball)
                                                .mul_add(sin_theta, q_right_ball_ddot_by_theta_of_place)
                                            + opening_dot_of_place_15
                                                * q_right_ball_ddot_by_theta_of_place_2)
                                        + q_right_top_ddot_by_theta_of_place_2 * sin_q_right_top)
                                    + opening_dot_of_place_23
                                        * q_right_top_ddot_by_theta_of_place_3)))
                - q_right_top_ddot_by_theta_of_opening_dot * q_right_ball_ddot_by_theta_of_place_3)
            + opening_dot_by_theta * q_right_ball_ddot_by_theta_of_place_3);
    let w_right_arm_frame_in_right_link_frame_1_by_q_right_top_of_place = cos_q_right_top
        * cos_q_right_ball;
    let w_right_arm_frame_in_right_link_frame_1_by_q_right_top_of_place_2 = d2_of_place_12
        - w_right_arm_frame_in_right_link_frame_1_by_q_right_top_of_place;
    let w_right_arm_frame_in_right_link_frame_1_by_q_right_top_of_psi_dot = psi_dot
        * w_right_arm_frame_in_right_link_frame_1_by_q_right_top_of_place_2;
    let w_right_arm_frame_in_right_link_frame_1_by_q_right_top_of_psi_dot_2 = -w_right_arm_frame_in_right_link_frame_1_by_q_right_top_of_psi_dot;
    let w_right_arm_frame_in_right_link_frame_1_by_q_right_top = w_right_arm_frame_in_right_link_frame_1_by_q_right_top_of_psi_dot_2;
    let H_right_arm_1_by_q_right_top = w_spindle_frame_in_right_arm_frame_3 * H_left_arm_2;
    let v_right_link_centre_2_by_q_right_top_of_psi_dot = psi_dot * cos_q_right_top_doubled;
    let v_right_link_centre_2_by_q_right_top = l
        * (w_right_arm_frame_in_right_link_frame_1_by_q_right_top
            + v_right_link_centre_2_by_q_right_top_of_psi_dot);
    let p_v_right_arm_centre_2_by_q_right_top_of_place = w_spindle_frame_in_right_arm_frame_3
        * l_m_plus_mb_times_4;
    let p_v_right_arm_centre_2_by_q_right_top = v_right_link_centre_2_by_q_right_top
        .mul_add(m_doubled, p_v_right_arm_centre_2_by_q_right_top_of_place);
    let p_w_spindle_frame_in_right_arm_frame_3_by_q_right_top_of_place = v_right_link_centre_2_by_q_right_top
        .mul_add(S::int(3), l * w_right_arm_frame_in_right_link_frame_1_by_q_right_top);
    let p_w_spindle_frame_in_right_arm_frame_3_by_q_right_top = x_right_link_frame_in_right_arm_frame_1
        * p_w_spindle_frame_in_right_arm_frame_3_by_q_right_top_of_place;
    let m_cos_q_right_ball = m * cos_q_right_ball;
    let p_w_spindle_frame_in_right_arm_frame_1_by_q_right_top = H_right_arm_1_by_q_right_top
        + l
            * p_w_spindle_frame_in_right_arm_frame_3_by_q_right_top_of_place
                .mul_add(
                    m_cos_q_right_ball,
                    S::int(3) * p_v_right_arm_centre_2_by_q_right_top,
                );
    let w_right_arm_frame_in_right_link_frame_1_2_by_q_right_top = -psi_dot
        * w_right_link_frame_2 * w_right_arm_frame_in_right_link_frame_1_3;
    let v_right_arm_centre_2_2_by_q_right_top = -w_spindle_frame_in_right_arm_frame_1
        * l_q_right_top_dot;
    let H_right_arm_1_2_by_q_right_top_of_motion = q_right_top_dot * H_left_arm_2;
    let H_right_arm_1_2_by_q_right_top = -w_spindle_frame_in_right_arm_frame_1
        * H_right_arm_1_2_by_q_right_top_of_motion;
    let p_v_right_arm_centre_2_2_by_q_right_top_of_place = w_right_arm_frame_in_right_link_frame_1_2_by_q_right_top
        * l_doubled;
    let p_v_right_arm_centre_2_2_by_q_right_top = m
        * v_right_arm_centre_2_2_by_q_right_top
            .mul_add(S::int(5), p_v_right_arm_centre_2_2_by_q_right_top_of_place)
        + v_right_arm_centre_2_2_by_q_right_top * mb_times_4;
    let p_w_right_arm_frame_in_right_link_frame_1_2_by_q_right_top = p_w_left_arm_frame_in_left_link_frame_1_2_by_theta_of_place
        * v_right_arm_centre_2_2_by_q_right_top
            .mul_add(S::int(3), p_v_right_arm_centre_2_2_by_q_right_top_of_place);
    let p_w_spindle_frame_in_right_arm_frame_3_2_by_q_right_top_of_place = mp_left_link_frame_3
        * p_w_spindle_frame_in_right_arm_frame_3_by_q_right_top_of_place;
    let p_w_spindle_frame_in_right_arm_frame_3_2_by_q_right_top = w_right_arm_frame_in_right_link_frame_1_2_of_motion
        .mul_add(
            p_w_spindle_frame_in_right_arm_frame_3_2_by_q_right_top_of_place,
            p_w_right_arm_frame_in_right_link_frame_1_2_by_q_right_top * sin_q_right_ball,
        );
    let p_w_spindle_frame_in_right_arm_frame_1_2_by_q_right_top = H_right_arm_1_2_by_q_right_top
        + p_w_right_arm_frame_in_right_link_frame_1_2_by_q_right_top * cos_q_right_ball
        + l
            * (-(m * w_right_arm_frame_in_right_link_frame_1_2_of_motion_2))
                .mul_add(
                    p_w_spindle_frame_in_right_arm_frame_3_by_q_right_top_of_place,
                    S::int(3) * p_v_right_arm_centre_2_2_by_q_right_top,
                );
    let w_right_arm_frame_in_right_link_frame_1_3_by_q_right_top_of_place = -w_right_arm_frame_in_right_link_frame_1_by_q_right_top_of_place_2;
    let w_right_arm_frame_in_right_link_frame_1_3_by_q_right_top = w_right_arm_frame_in_right_link_frame_1_3_by_q_right_top_of_place;
    let H_right_arm_1_3_by_q_right_top = H_left_arm_2 * cos_q_right_top;
    let v_right_link_centre_2_3_by_q_right_top = l
        * (w_right_arm_frame_in_right_link_frame_1_3_by_q_right_top + cos_q_right_top_doubled);
    let p_v_right_arm_centre_2_3_by_q_right_top_of_place = l_m_plus_mb_times_4 * cos_q_right_top;
    let p_v_right_arm_centre_2_3_by_q_right_top = v_right_link_centre_2_3_by_q_right_top
        .mul_add(m_doubled, p_v_right_arm_centre_2_3_by_q_right_top_of_place);
    let p_w_spindle_frame_in_right_arm_frame_3_3_by_q_right_top_of_place = v_right_link_centre_2_3_by_q_right_top
        .mul_add(
            S::int(3),
            l * w_right_arm_frame_in_right_link_frame_1_3_by_q_right_top,
        );
    let p_w_spindle_frame_in_right_arm_frame_3_3_by_q_right_top = x_right_link_frame_in_right_arm_frame_1
        * p_w_spindle_frame_in_right_arm_frame_3_3_by_q_right_top_of_place;
    let p_w_spindle_frame_in_right_arm_frame_1_3_by_q_right_top = H_right_arm_1_3_by_q_right_top
        + l
            * m_cos_q_right_ball
                .mul_add(
                    p_w_spindle_frame_in_right_arm_frame_3_3_by_q_right_top_of_place,
                    S::int(3) * p_v_right_arm_centre_2_3_by_q_right_top,
                );
    let d1_by_q_right_top = cos_q_right_top_by_12
        * (p_w_spindle_frame_in_right_arm_frame_1_3
            + p_w_spindle_frame_in_right_arm_frame_3_3_by_q_right_top)
        + sin_q_right_top_by_12
            * (p_w_spindle_frame_in_right_arm_frame_1_3_by_q_right_top
                - p_w_spindle_frame_in_right_arm_frame_3_3);
    let d2_by_q_right_top_of_place = cos_q_right_top * sin_angle;
    let d2_by_q_right_top_of_place_2 = p_w_left_link_frame_2_3 * cos_q_right_top;
    let d2_by_q_right_top_of_place_3 = cos_q_right_top - cos_angle;
    let d2_by_q_right_top_of_place_4 = sin_angle - opening_dot_of_place_5;
    let cos_angle_doubled = S::int(2) * cos_angle;
    let d2_by_q_right_top_of_place_5 = cos_q_right_top * cos_angle;
    let d2_of_place_31_sq = d2_of_place_31 * d2_of_place_31;
    let d2_by_q_right_top = S::ratio(1, 6) * d2_of_place_31_sq
        * (sin_q_right_ball_inv
            * (sin_q_right_ball_inv
                * (cos_q_right_ball
                    * (p_w_left_link_frame_2_3
                        * (sin_q_right_top
                            * (cos_angle - cos_q_right_top * (S::int(2) + cos_q_right_ball))
                            + d2_by_q_right_top_of_place)
                        + l_times_6
                            * (mp_left_link_frame_3
                                * d2_of_q_right_ball
                                    .mul_add(
                                        d2_by_q_right_top_of_place,
                                        opening_dot_of_place_5 * cos_angle,
                                    ) - p_v_right_link_centre_1_3 * sin_angle * cos_angle))
                    + sin_angle
                        * (d2_by_q_right_top_of_place_2
                            - cos_angle * p_v_left_arm_centre_1.mul_add(l_times_3, d2_of_place_3))
                    - d2_of_place_29 * d2_by_q_right_top_of_place_3)
                + p_w_left_link_frame_2_3
                    * (-d2_by_q_right_top_of_place_4)
                        .mul_add(sin_q_right_top, d2_of_place_27 * cos_q_right_top)
                + l_times_6
                    * (-sin_angle
                        * p_v_right_arm_frame_in_right_link_frame_3_3
                            .mul_add(
                                cos_angle_doubled,
                                x_right_link_frame_in_right_arm_frame_3 * sin_q_right_top,
                            )
                        + x_right_link_frame_in_right_arm_frame_3 * d2_by_q_right_top_of_place_5))
            + d2_of_place_29 * cos_q_right_top);
    let opening_dot_by_q_right_top_of_place = sin_q_right_top
        * (p_w_spindle_frame_in_right_arm_frame_1
            + p_w_spindle_frame_in_right_arm_frame_3_by_q_right_top)
        + cos_q_right_top
            * (p_w_spindle_frame_in_right_arm_frame_3
                - p_w_spindle_frame_in_right_arm_frame_1_by_q_right_top);
    let opening_dot_by_q_right_top_of_place_2 = x_right_link_frame_in_right_arm_frame_1
        * sin_q_right_top;
    let opening_dot_by_q_right_top_of_place_3 = opening_dot_of_place_34 * sin_angle;
    let opening_dot_by_q_right_top_of_place_4 = sin_q_right_top * cos_angle;
    let opening_dot_by_q_right_top_of_place_5 = opening_dot_of_place_11 * sin_angle;
    let sin_angle_d2_of_place_22 = d2_of_place_22 * sin_angle;
    let opening_dot_by_q_right_top_of_place_6 = cos_q_left_ball * sin_angle;
    let sin_q_left_ball_sq = sin_q_left_ball * sin_q_left_ball;
    let opening_dot_by_q_right_top_of_place_7 = sin_q_right_top + sin_angle;
    let opening_dot_by_q_right_top_of_place_8 = w_right_arm_frame_in_right_link_frame_1_3_of_place
        + opening_dot_of_place_5;
    let sin_angle_d2_of_place_9 = d2_of_place_9 * sin_angle;
    let opening_dot_by_q_right_top_of_theta_dot = opening_dot_of_theta_dot
        * opening_dot_of_place_25;
    let opening_dot_by_q_right_top_of_theta_dot_2 = d2_of_place_31
        * opening_dot_by_q_right_top_of_theta_dot;
    let opening_dot_by_q_right_top = d2_inv_by_12
        * (d2_of_place_14
            * (sin_q_right_ball
                * ((-opening_dot_by_theta_of_place_2)
                    .mul_add(sin_q_right_top, opening_dot_of_place_32)
                    + w_spindle_frame_in_right_arm_frame_1
                        * p_w_spindle_frame_in_right_arm_frame_3_2_by_q_right_top_of_place)
                + cos_q_right_ball
                    * (opening_dot_by_theta_of_place_2
                        .mul_add(cos_q_right_top, opening_dot_of_place_31)
                        - w_spindle_frame_in_right_arm_frame_3
                            * p_w_spindle_frame_in_right_arm_frame_3_2_by_q_right_top_of_place))
            - cos_angle_d2_of_place_7
                * (g_times_6
                    * x_N_3_2
                        .mul_add(cos_q_right_top, -opening_dot_by_q_right_top_of_place_2)
                    + psi_dot * opening_dot_by_q_right_top_of_place)
            - opening_dot_of_theta_dot_3
                * (d2_of_place_5
                    * (sin_q_left_ball
                        * (opening_dot_by_q_right_top_of_place_5
                            - sin_q_left_ball
                                * (d2_by_q_right_top_of_place
                                    + sin_q_right_ball_inv
                                        * (-cos_q_right_top
                                            * (cos_angle
                                                + cos_q_right_ball
                                                    * (-opening_dot_of_q_right_ball)
                                                        .mul_add(sin_angle, cos_angle))
                                            + opening_dot_of_place_36 * sin_q_right_top
                                            + cos_angle
                                                * (cos_angle
                                                    + w_right_arm_frame_in_right_link_frame_1_by_q_right_top_of_place)
                                            - opening_dot_by_q_right_top_of_place_3)
                                    + opening_dot_by_q_right_top_of_place_4))
                        + sin_angle_d2_of_place_22) + opening_dot_by_q_right_top_of_place_6)
            + opening_dot_by_theta_of_theta_dot
                * (cos_q_left_ball * (cos_q_right_top + opening_dot_of_place_14)
                    + d2_of_place_5
                        * (sin_q_right_ball_inv
                            * (opening_dot_of_place_13 * sin_q_right_top
                                - opening_dot_of_place_16 * opening_dot_of_place_22
                                + sin_q_left_ball_sq
                                    * (cos_q_right_top
                                        * (opening_dot_by_q_right_top_of_place_7
                                            - sin_q_right_ball_inv
                                                * (d2_of_place_11 + q_right_ball_ddot_by_theta_of_place_2))
                                        + opening_dot_of_place_14 * sin_angle))
                            + opening_dot_of_place_19 * cos_theta * cos_q_right_top))
            - d2_of_place_7 * opening_dot_by_theta_of_theta_dot_2
                * (-d2_of_place_4)
                    .mul_add(
                        sin_angle,
                        d2_of_place_10 * opening_dot_by_q_right_top_of_place_8,
                    )
            - d2_of_place_7
                * (-opening_dot_of_motion_3)
                    .mul_add(
                        opening_dot_by_q_right_top_of_place_8,
                        opening_dot_of_motion_5 * sin_angle,
                    )
            - opening_dot_by_q_right_top_of_theta_dot_2
                * (d2_by_q_right_top_of_place_2
                    - sin_q_right_ball_inv
                        * p_w_left_link_frame_2_3
                            .mul_add(
                                d2_by_q_right_top_of_place_4, sin_angle_d2_of_place_9,
                            ))) - d2_by_q_right_top * opening_dot_d2_inv;
    let spin_dot_by_q_right_top = d1_inv_by_12
        * (sin_q_right_top
            * (p_w_spindle_frame_in_right_arm_frame_3_2
                - p_w_spindle_frame_in_right_arm_frame_1_2_by_q_right_top)
            - cos_q_right_top
                * (p_w_spindle_frame_in_right_arm_frame_1_2
                    + p_w_spindle_frame_in_right_arm_frame_3_2_by_q_right_top)
            + d1_by_q_right_top * spin_dot_by_theta_of_motion
            + q_right_top_dot * opening_dot_by_q_right_top_of_place);
    let sin_angle_opening_dot = opening_dot * sin_angle;
    let q_right_top_ddot_by_q_right_top = d2_of_place_6
        * (theta_dot_sq
            * (d2_of_place_5
                * (sin_q_left_ball
                    * (opening_dot_by_q_right_top_of_place_5
                        - sin_q_right_ball_inv * sin_q_left_ball
                            * (sin_angle * (sin_q_right_top - sin_angle + opening_dot_of_place_22)
                                + cos_angle
                                    * (opening_dot_of_place_14 - d2_by_q_right_top_of_place_3)))
                    + sin_angle_d2_of_place_22) + opening_dot_by_q_right_top_of_place_6)
            + sin_q_left_ball
                * opening_dot_by_q_right_top.mul_add(cos_angle, -sin_angle_opening_dot));
    let q_left_ball_ddot_by_q_right_top = -opening_dot_by_q_right_top * d2_of_place_19;
    let q_right_ball_ddot_by_q_right_top_of_place = sin_q_right_top * sin_q_left_ball;
    let q_right_ball_ddot_by_q_right_top = d2_of_place_5
        * (cos_q_right_top
            * (-theta_dot_sq
                * opening_dot_of_place_19
                    .mul_add(cos_theta_d2_of_place_5, cos_q_left_ball)
                + opening_dot * sin_q_left_ball)
            + sin_q_right_ball_inv
                * (sin_q_left_ball
                    * (-opening_dot_by_q_right_top)
                        .mul_add(d2_of_place_11, opening_dot * opening_dot_of_place_5)
                    - theta_dot_sq
                        * (d2_of_place_5
                            * (sin_q_left_ball
                                * (sin_q_left_ball
                                    * (sin_q_right_top * (cos_angle + cos_q_right_top_doubled)
                                        + d2_by_q_right_top_of_place
                                        - sin_q_right_ball_inv
                                            * (cos_q_right_top
                                                * d2_of_q_right_ball.mul_add(cos_angle, d2_of_place_11)
                                                + d2_of_q_right_ball * sin_q_right_top
                                                    * opening_dot_by_theta_of_place_11
                                                        .mul_add(
                                                            S::int(4),
                                                            -opening_dot_by_q_right_top_of_place_7,
                                                        ))) + opening_dot_of_place_5 * opening_dot_of_place_11)
                                + d2_of_place_22 * opening_dot_of_place_5)
                            + opening_dot_of_place_5 * cos_q_left_ball))
            + opening_dot_by_q_right_top * q_right_ball_ddot_by_q_right_top_of_place);
    let w_left_arm_frame_in_left_link_frame_1_by_q_left_ball_of_place = -w_left_arm_frame_in_left_link_frame_1_2_of_place;
    let w_left_arm_frame_in_left_link_frame_1_by_q_left_ball = w_left_arm_frame_in_left_link_frame_1_by_q_left_ball_of_place;
    let p_w_spindle_frame_in_left_arm_frame_3_by_q_left_ball_of_place = h_left_arm_2_times_4
        * sin_q_left_ball;
    let p_w_spindle_frame_in_left_arm_frame_3_by_q_left_ball = w_left_arm_frame_in_left_link_frame_1_by_q_left_ball
        .mul_add(
            p_w_spindle_frame_in_left_arm_frame_3_by_q_left_ball_of_place,
            p_w_spindle_frame_in_left_arm_frame_1_of_place,
        );
    let p_w_spindle_frame_in_left_arm_frame_1_by_q_left_ball_of_q_left_ball = S::int(3)
        + cos_q_left_ball_doubled;
    let h_left_arm_2_doubled = S::int(2) * H_left_arm_2;
    let p_w_spindle_frame_in_left_arm_frame_1_by_q_left_ball_of_place = p_w_spindle_frame_in_left_arm_frame_1_by_q_left_ball_of_q_left_ball
        * h_left_arm_2_doubled;
    let p_w_spindle_frame_in_left_arm_frame_1_by_q_left_ball = w_left_arm_frame_in_left_link_frame_1_by_q_left_ball
        .mul_add(
            p_w_spindle_frame_in_left_arm_frame_1_by_q_left_ball_of_place,
            -p_w_spindle_frame_in_left_arm_frame_3,
        );
    let w_left_arm_frame_in_left_link_frame_1_2_by_q_left_ball = (-w_spindle_frame_in_left_arm_frame_1_2)
        .mul_add(
            sin_q_left_ball,
            -q_left_ball_dot * w_left_arm_frame_in_left_link_frame_1,
        ) - w_spindle_frame_in_left_arm_frame_3_2 * cos_q_left_ball;
    let p_w_spindle_frame_in_left_arm_frame_3_2_by_q_left_ball = p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2
        + h_left_arm_2_times_4
            * w_left_arm_frame_in_left_link_frame_1_by_q_left_ball
                .mul_add(
                    v_left_arm_frame_in_left_link_frame_3_2_of_motion,
                    w_left_arm_frame_in_left_link_frame_1_2_by_q_left_ball * sin_q_left_ball,
                );
    let p_w_spindle_frame_in_left_arm_frame_1_2_by_q_left_ball = h_left_arm_2_doubled
        * (-(q_left_ball_dot * w_left_arm_frame_in_left_link_frame_1_by_q_left_ball))
            .mul_add(
                sin_q_left_ball_doubled,
                w_left_arm_frame_in_left_link_frame_1_2_by_q_left_ball
                    * p_w_spindle_frame_in_left_arm_frame_1_by_q_left_ball_of_q_left_ball,
            ) - p_w_spindle_frame_in_left_arm_frame_3_2;
    let v_left_link_centre_1_by_q_left_ball = -theta_dot * l_doubled * sin_q_left_ball;
    let p_v_left_arm_frame_in_left_link_frame_3_by_q_left_ball = theta_dot
        * x_left_link_frame_in_left_arm_frame_3;
    let v_left_arm_frame_in_left_link_frame_1_2_by_q_left_ball = v_left_arm_frame_in_left_link_frame_3_2;
    let v_left_arm_frame_in_left_link_frame_3_2_by_q_left_ball = -v_left_arm_frame_in_left_link_frame_1_2;
    let v_sleeve_centre_3_by_q_left_ball = -v_sleeve_centre_3_3 * w_left_link_frame_2_sq;
    let w_left_arm_frame_in_left_link_frame_1_3_by_q_left_ball = minus_d2_of_place_23;
    let p_w_spindle_frame_in_left_arm_frame_3_3_by_q_left_ball = w_left_arm_frame_in_left_link_frame_1_3_by_q_left_ball
        .mul_add(
            p_w_spindle_frame_in_left_arm_frame_3_by_q_left_ball_of_place,
            p_w_spindle_frame_in_left_arm_frame_1_3_of_place,
        );
    let p_w_spindle_frame_in_left_arm_frame_1_3_by_q_left_ball = w_left_arm_frame_in_left_link_frame_1_3_by_q_left_ball
        .mul_add(
            p_w_spindle_frame_in_left_arm_frame_1_by_q_left_ball_of_place,
            -p_w_spindle_frame_in_left_arm_frame_3_3,
        );
    let p_v_sleeve_centre_3_2_by_q_left_ball = p_v_sleeve_centre_3_3_by_theta;
    let p_v_left_link_centre_1_3_by_q_left_ball = -S::int(2)
        * x_left_link_frame_in_left_arm_frame_1;
    let p_v_sleeve_centre_3_3_by_q_left_ball = p_v_sleeve_centre_3_3_by_theta;
    let d1_by_q_left_ball = p_w_spindle_frame_in_left_arm_frame_1_3_by_q_left_ball
        .mul_add(
            sin_theta_by_12,
            p_w_spindle_frame_in_left_arm_frame_3_3_by_q_left_ball * cos_theta_by_12,
        );
    let d2_by_q_left_ball_of_place = d2_of_place_7
        .mul_add(opening_dot_of_place_10, d2_of_place_6 * cos_q_left_ball);
    let d2_by_q_left_ball_of_place_2 = d2_by_q_left_ball_of_place * cos_angle;
    let d2_by_q_left_ball_of_place_3 = d2_of_place_13 * d2_by_q_left_ball_of_place;
    let d2_by_q_left_ball_of_place_4 = (-d2_of_place_10)
        .mul_add(
            d2_by_q_left_ball_of_place_3,
            d2_of_place_4 * d2_by_q_left_ball_of_place_2,
        );
    let d2_by_q_left_ball_of_place_5 = d2_of_place_5 * d2_of_place_30 * cos_q_left_ball;
    let l_halved = S::ratio(1, 2) * l;
    let d2_by_q_left_ball_of_place_6 = x_left_link_frame_in_left_arm_frame_1
        * cos_q_left_ball_doubled;
    let d2_by_q_left_ball_of_place_7 = p_v_sleeve_centre_3_2_by_q_left_ball
        .mul_add(
            v_sleeve_centre_3_2_of_place,
            p_v_sleeve_centre_3_2 * cos_theta_plus_q_left_ball,
        );
    let d2_by_q_left_ball_of_place_8 = sin_q_left_ball
        * p_v_sleeve_centre_3_3_by_q_left_ball
            .mul_add(S::int(2), -opening_dot_by_theta_of_place_5) + d2_of_place_21 * cos_q_left_ball
        + x_left_link_frame_in_left_arm_frame_1 * q_right_top_ddot_by_theta_of_place_3;
    let d2_by_q_left_ball_of_place_9 = (-p_v_left_link_centre_1_3)
        .mul_add(
            sin_q_left_ball,
            p_v_left_link_centre_1_3_by_q_left_ball * cos_q_left_ball,
        ) + p_v_left_arm_frame_in_left_link_frame_3_3 * cos_q_left_ball_doubled
        + d2_by_q_left_ball_of_place_6 + S::int(2) * d2_by_q_left_ball_of_place_7;
    let d2_by_q_left_ball = S::ratio(1, 2) * d2_of_place_19
        * (-l_doubled
            * p_v_sleeve_centre_3_3_by_q_left_ball
                .mul_add(
                    v_sleeve_centre_3_2_of_place,
                    p_v_sleeve_centre_3_3 * cos_theta_plus_q_left_ball,
                ) + H_left_arm_2 * sin_q_left_ball)
        + p_v_left_link_centre_1_3_by_q_left_ball * l_by_4
        + d2_of_place_25_by_12 * opening_dot_of_place_10 - d2_by_theta_of_place_9
        + S::ratio(1, 12) * d2_of_place_16 * d2_by_q_left_ball_of_place_2
        + d2_of_place_17 * d2_by_q_left_ball_of_place_4
        - S::ratio(1, 6) * d2_of_place_14 * d2_by_q_left_ball_of_place_5
        + l_halved
            * (-d2_by_theta_of_place_5)
                .mul_add(d2_by_q_left_ball_of_place_8, d2_by_q_left_ball_of_place_9);
    let opening_dot_by_q_left_ball_of_place = (-p_w_spindle_frame_in_left_arm_frame_1_by_q_left_ball)
        .mul_add(
            cos_theta,
            p_w_spindle_frame_in_left_arm_frame_3_by_q_left_ball * sin_theta,
        );
    let opening_dot_by_q_left_ball_of_theta_dot = opening_dot_of_place_10
        * opening_dot_of_theta_dot_4;
    let opening_dot_by_q_left_ball_of_place_2 = opening_dot_of_place_15
        + d2_of_place_5
            * (opening_dot_of_place_15 * cos_theta + opening_dot_of_place_41 * cos_q_left_ball
                + sin_q_left_ball
                    * (-opening_dot_by_theta_of_place_6)
                        .mul_add(cos_angle, opening_dot_of_place_40 * cos_q_left_ball))
        + opening_dot_by_theta_of_place_10;
    let opening_dot_by_q_left_ball_of_place_3 = v_left_arm_frame_in_left_link_frame_1_2_by_q_left_ball
        * opening_dot_of_place_30;
    let m_sin_q_left_ball = m * sin_q_left_ball;
    let opening_dot_by_q_left_ball_of_place_4 = (-p_v_left_arm_frame_in_left_link_frame_3_by_q_left_ball)
        .mul_add(cos_q_left_ball_doubled, p_v_left_link_centre_1 * cos_q_left_ball)
        + p_v_left_arm_frame_in_left_link_frame_3 * sin_q_left_ball_doubled
        + v_left_link_centre_1_by_q_left_ball * m_sin_q_left_ball;
    let ms_doubled = S::int(2) * ms;
    let opening_dot_by_q_left_ball_of_place_5 = ms_doubled * sin_theta_plus_q_left_ball;
    let opening_dot_by_q_left_ball_of_place_6 = opening_dot_of_place_4 * cos_theta_plus_q_left_ball;
    let opening_dot_by_q_left_ball_of_theta_dot_2 = opening_dot_of_place_47
        * cos_q_left_ball + opening_dot_of_place_49 * sin_q_left_ball
        + w_left_arm_frame_in_left_link_frame_1_by_q_left_ball
            * w_left_arm_frame_in_left_link_frame_1_2_of_place * h_left_arm_2_times_4
        - opening_dot_by_q_left_ball_of_place_3
        + l_times_6
            * (v_sleeve_centre_3_by_q_left_ball
                .mul_add(
                    opening_dot_by_q_left_ball_of_place_5,
                    theta_dot * opening_dot_by_q_left_ball_of_place_4,
                ) + opening_dot_by_q_left_ball_of_place_6);
    let opening_dot_by_q_left_ball_of_place_7 = v_sleeve_centre_3_2_of_place * ms_doubled;
    let opening_dot_by_q_left_ball_of_motion = cos_q_left_ball_doubled
        * (-m)
            .mul_add(
                v_left_arm_frame_in_left_link_frame_1_2_by_q_left_ball,
                p_v_left_arm_frame_in_left_link_frame_3_2,
            ) + p_v_left_link_centre_1_2 * sin_q_left_ball_doubled
        + v_left_arm_frame_in_left_link_frame_3_2_by_q_left_ball * m_doubled
            * sin_q_left_ball - q_left_ball_dot * opening_dot_by_q_left_ball_of_place_4
        + opening_dot_by_q_left_ball_of_place_6
        + v_sleeve_centre_3_by_q_left_ball * opening_dot_by_q_left_ball_of_place_7;
    let opening_dot_by_q_left_ball = d2_inv_by_12
        * (g_times_6 * (opening_dot_by_theta_of_place_5 - d2_by_theta_of_place_3)
            + opening_dot_by_theta_of_theta_dot_3
            - opening_dot_by_theta_of_place_14 * opening_dot_by_theta_of_theta_dot_4
            - opening_dot_by_theta_of_theta_dot
                * (d2_of_place_5
                    * (sin_q_right_ball_inv
                        * (cos_q_right_top
                            * (opening_dot_of_place_12 * cos_q_left_ball
                                - w_left_arm_frame_in_left_link_frame_1_3_of_place_2
                                    * d2_of_q_right_ball
                                + sin_q_left_ball
                                    * d2_of_q_right_ball
                                        .mul_add(
                                            opening_dot_by_theta_of_place_6,
                                            opening_dot_of_place_9 * cos_q_left_ball,
                                        ))
                            + cos_q_left_ball_doubled * opening_dot_of_place_14
                                * opening_dot_of_place_15)
                        - opening_dot_of_place_10 * opening_dot_of_place_19
                            * opening_dot_of_place_20) + opening_dot_by_theta_of_place_12
                    + q_right_ball_ddot_by_theta_of_place_3)
            + opening_dot_of_motion_5 * d2_by_q_left_ball_of_place_2
            - opening_dot_of_motion_3 * d2_by_q_left_ball_of_place_3
            - opening_dot_by_theta_of_theta_dot_2 * d2_by_q_left_ball_of_place_4
            - opening_dot_by_q_right_top_of_theta_dot * d2_by_q_left_ball_of_place_5
            - psi_dot * opening_dot_by_q_left_ball_of_place
            + opening_dot_by_q_left_ball_of_theta_dot
            - opening_dot_of_theta_dot_3
                * opening_dot_of_place_10
                    .mul_add(
                        opening_dot_of_place_44, opening_dot_by_q_left_ball_of_place_2,
                    ) + opening_dot_by_q_left_ball_of_place_3
            + d2_of_place_19
                * (opening_dot_by_q_left_ball_of_theta_dot_2
                    - opening_dot_by_q_left_ball_of_theta_dot)
            - l_times_6
                * opening_dot_by_theta_of_theta_dot_5
                    .mul_add(
                        d2_by_q_left_ball_of_place_8, opening_dot_by_q_left_ball_of_motion,
                    )) - d2_by_q_left_ball * opening_dot_d2_inv;
    let spin_dot_by_q_left_ball = d1_inv_by_12
        * ((-p_w_spindle_frame_in_left_arm_frame_3_2_by_q_left_ball)
            .mul_add(cos_theta, d1_by_q_left_ball * spin_dot_by_theta_of_motion)
            - p_w_spindle_frame_in_left_arm_frame_1_2_by_q_left_ball * sin_theta
            + theta_dot * opening_dot_by_q_left_ball_of_place);
    let q_right_top_ddot_by_q_left_ball_of_opening_dot = opening_dot_by_q_left_ball
        + q_left_ball_ddot_by_theta_of_opening_dot;
    let q_right_top_ddot_by_q_left_ball_of_opening_dot_2 = opening_dot * cos_q_left_ball;
    let q_right_top_ddot_by_q_left_ball_of_opening_dot_3 = q_right_top_ddot_by_q_left_ball_of_opening_dot
        .mul_add(sin_q_left_ball, q_right_top_ddot_by_q_left_ball_of_opening_dot_2);
    let q_right_top_ddot_by_q_left_ball_of_place = d2_of_q_right_ball * opening_dot_of_place_19;
    let q_right_top_ddot_by_q_left_ball_of_place_2 = opening_dot_of_place_19 * sin_angle;
    let q_right_top_ddot_by_q_left_ball_of_q_right_ball = S::int(2) * sin_q_right_ball_inv;
    let q_right_top_ddot_by_q_left_ball_of_place_3 = S::int(2) * opening_dot_of_place_39;
    let q_right_top_ddot_by_q_left_ball_of_place_4 = S::int(3) * cos_theta_d2_of_place_5;
    let q_right_top_ddot_by_q_left_ball_of_place_5 = S::int(1)
        + q_right_top_ddot_by_q_left_ball_of_place_4;
    let q_right_top_ddot_by_q_left_ball = d2_of_place_6
        * (theta_dot_sq
            * (opening_dot_of_place_15
                - d2_of_place_5
                    * (sin_q_left_ball
                        * (q_right_top_ddot_by_q_left_ball_of_q_right_ball
                            * (-cos_q_right_top
                                * (q_right_top_ddot_by_q_left_ball_of_place_2
                                    + cos_q_right_ball
                                        * (sin_q_right_ball_inv
                                            * q_right_top_ddot_by_q_left_ball_of_place)
                                            .mul_add(
                                                cos_angle,
                                                q_right_top_ddot_by_q_left_ball_of_place_2,
                                            ))
                                + opening_dot_of_place_19 * opening_dot_of_place_34 * cos_angle)
                            + opening_dot_of_place_10
                                * q_right_top_ddot_by_theta_of_place * cos_angle
                            + opening_dot_of_place_19 * q_right_top_ddot_by_q_left_ball_of_place_3)
                        + opening_dot_of_place_43 * q_right_top_ddot_by_q_left_ball_of_place_5
                            * sin_theta_plus_q_left_ball))
            + q_right_top_ddot_by_q_left_ball_of_opening_dot_3 * cos_angle);
    let q_left_ball_ddot_by_q_left_ball = d2_of_place_5
        * (-cos_theta
            * (opening_dot_by_q_left_ball
                + d2_of_place_5
                    * (-theta_dot_sq)
                        .mul_add(
                            q_left_ball_ddot_by_theta_of_place,
                            q_right_top_ddot_by_theta_of_opening_dot,
                        )) + theta_dot_sq * opening_dot_by_theta_of_place_7)
        - opening_dot_by_q_left_ball;
    let sin_q_right_top_doubled = S::int(2) * sin_q_right_top;
    let q_right_ball_ddot_by_q_left_ball = d2_of_place_5
        * (sin_q_right_top
            * (q_right_top_ddot_by_q_left_ball_of_opening_dot_3
                + theta_dot_sq
                    * (sin_q_left_ball
                        - opening_dot_of_place_10
                            * opening_dot_of_place_19
                                .mul_add(
                                    q_right_top_ddot_by_q_left_ball_of_place_4, cos_q_left_ball,
                                )))
            - sin_q_right_ball_inv
                * (cos_q_right_top
                    * (d2_of_q_right_ball * q_right_top_ddot_by_q_left_ball_of_opening_dot
                        * sin_q_left_ball
                        + d2_of_q_right_ball * q_right_top_ddot_by_q_left_ball_of_opening_dot_2
                        + theta_dot_sq
                            * (-d2_of_place_5
                                * (sin_q_left_ball
                                    * opening_dot_of_place_10
                                        .mul_add(
                                            q_right_ball_ddot_by_theta_of_place,
                                            cos_q_left_ball_doubled * opening_dot_of_place_9,
                                        )
                                    + d2_of_q_right_ball
                                        * q_right_top_ddot_by_q_left_ball_of_place_5
                                        * sin_theta_plus_q_left_ball * cos_q_left_ball)
                                + d2_of_q_right_ball * sin_q_left_ball))
                    - theta_dot_sq * cos_angle_d2_of_place_7
                        * q_right_top_ddot_by_q_left_ball_of_place * sin_q_right_top_doubled));
    let w_right_arm_frame_in_right_link_frame_1_by_q_right_ball_of_place = (-w_spindle_frame_in_right_arm_frame_3)
        .mul_add(
            cos_q_right_ball,
            w_spindle_frame_in_right_arm_frame_1 * sin_q_right_ball,
        );
    let w_right_arm_frame_in_right_link_frame_1_by_q_right_ball_of_place_2 = -w_right_arm_frame_in_right_link_frame_1_by_q_right_ball_of_place;
    let w_right_arm_frame_in_right_link_frame_1_by_q_right_ball = w_right_arm_frame_in_right_link_frame_1_by_q_right_ball_of_place_2;
    let p_w_spindle_frame_in_right_arm_frame_3_by_q_right_ball_of_place = h_left_arm_2_times_4
        * sin_q_right_ball;
    let p_w_spindle_frame_in_right_arm_frame_3_by_q_right_ball = w_right_arm_frame_in_right_link_frame_1_by_q_right_ball
        .mul_add(
            p_w_spindle_frame_in_right_arm_frame_3_by_q_right_ball_of_place,
            p_w_spindle_frame_in_right_arm_frame_1_of_place,
        );
    let p_w_spindle_frame_in_right_arm_frame_1_by_q_right_ball_of_q_right_ball = S::int(
        3,
    ) + cos_q_right_ball_doubled;
    let p_w_spindle_frame_in_right_arm_frame_1_by_q_right_ball_of_place = h_left_arm_2_doubled
        * p_w_spindle_frame_in_right_arm_frame_1_by_q_right_ball_of_q_right_ball;
    let p_w_spindle_frame_in_right_arm_frame_1_by_q_right_ball = w_right_arm_frame_in_right_link_frame_1_by_q_right_ball
        .mul_add(
            p_w_spindle_frame_in_right_arm_frame_1_by_q_right_ball_of_place,
            -p_w_spindle_frame_in_right_arm_frame_3,
        );
    let w_right_arm_frame_in_right_link_frame_1_2_by_q_right_ball = (-w_spindle_frame_in_right_arm_frame_1_2)
        .mul_add(
            sin_q_right_ball,
            -q_right_ball_dot * w_right_arm_frame_in_right_link_frame_1,
        ) - w_spindle_frame_in_right_arm_frame_3_2 * cos_q_right_ball;
    let p_w_spindle_frame_in_right_arm_frame_3_2_by_q_right_ball = p_w_spindle_frame_in_right_arm_frame_1_2_of_motion
        + h_left_arm_2_times_4
            * w_right_arm_frame_in_right_link_frame_1_by_q_right_ball
                .mul_add(
                    w_right_arm_frame_in_right_link_frame_1_2_of_motion,
                    w_right_arm_frame_in_right_link_frame_1_2_by_q_right_ball * sin_q_right_ball,
                );
    let p_w_spindle_frame_in_right_arm_frame_1_2_by_q_right_ball = h_left_arm_2_doubled
        * (-(w_right_arm_frame_in_right_link_frame_1_by_q_right_ball
            * w_right_arm_frame_in_right_link_frame_1_2_of_motion_2))
            .mul_add(
                S::int(2),
                w_right_arm_frame_in_right_link_frame_1_2_by_q_right_ball
                    * p_w_spindle_frame_in_right_arm_frame_1_by_q_right_ball_of_q_right_ball,
            ) - p_w_spindle_frame_in_right_arm_frame_3_2;
    let v_right_link_centre_1_by_q_right_ball = -q_right_top_dot * l_doubled * sin_q_right_ball;
    let p_v_right_arm_frame_in_right_link_frame_3_by_q_right_ball = q_right_top_dot
        * x_right_link_frame_in_right_arm_frame_3;
    let v_right_arm_frame_in_right_link_frame_1_2_by_q_right_ball = v_right_arm_frame_in_right_link_frame_3_2;
    let v_right_arm_frame_in_right_link_frame_3_2_by_q_right_ball = -v_right_arm_frame_in_right_link_frame_1_2;
    let w_right_arm_frame_in_right_link_frame_1_3_by_q_right_ball = w_right_arm_frame_in_right_link_frame_1_3_by_q_right_top_of_place;
    let p_w_spindle_frame_in_right_arm_frame_3_3_by_q_right_ball = w_right_arm_frame_in_right_link_frame_1_3_by_q_right_ball
        .mul_add(
            p_w_spindle_frame_in_right_arm_frame_3_by_q_right_ball_of_place,
            p_w_spindle_frame_in_right_arm_frame_1_3_of_place,
        );
    let p_w_spindle_frame_in_right_arm_frame_1_3_by_q_right_ball = w_right_arm_frame_in_right_link_frame_1_3_by_q_right_ball
        .mul_add(
            p_w_spindle_frame_in_right_arm_frame_1_by_q_right_ball_of_place,
            -p_w_spindle_frame_in_right_arm_frame_3_3,
        );
    let p_v_right_link_centre_1_3_by_q_right_ball = -S::int(2)
        * x_right_link_frame_in_right_arm_frame_1;
    let d1_by_q_right_ball = p_w_spindle_frame_in_right_arm_frame_1_3_by_q_right_ball
        .mul_add(
            sin_q_right_top_by_12,
            p_w_spindle_frame_in_right_arm_frame_3_3_by_q_right_ball * cos_q_right_top_by_12,
        );
    let sin_angle_doubled = S::int(2) * sin_angle;
    let d2_by_q_right_ball_of_place = p_w_left_link_frame_2_3 * cos_q_right_top_doubled;
    let d2_by_q_right_ball_of_place_2 = sin_q_right_ball_inv
        .mul_add(cos_q_right_top_doubled, -opening_dot_by_q_right_top_of_place_7);
    let d2_by_q_right_ball_of_place_3 = d2_of_q_right_ball * sin_angle;
    let d2_by_q_right_ball_of_place_4 = mp_left_link_frame_3 * cos_q_right_ball_doubled;
    let d2_by_q_right_ball = S::ratio(1, 12) * d2_of_place_31_sq
        * (sin_q_right_ball_inv
            * (S::int(2) * p_w_left_link_frame_2_3
                * d2_by_q_right_top_of_place_3
                    .mul_add(cos_q_right_top, -opening_dot_of_place_39)
                + sin_q_right_ball_inv
                    * (cos_angle
                        * (l_times_3
                            * (cos_angle
                                * (p_v_right_link_centre_1_3_by_q_right_ball
                                    - S::int(4) * p_v_right_link_centre_1_3 * sin_q_right_ball_inv
                                    + cos_q_right_ball_doubled
                                        * ((-p_v_right_arm_frame_in_right_link_frame_3_3)
                                            .mul_add(
                                                S::int(2),
                                                p_v_right_link_centre_1_3_by_q_right_ball,
                                            ) - p_v_left_arm_centre_1 * sin_q_right_ball_inv))
                                + S::int(4) * mp_left_link_frame_3
                                    * (opening_dot_of_place_6 - sin_q_right_top)
                                - d2_of_place * sin_angle_doubled)
                            - cos_q_right_ball_doubled * d2_of_place_29
                            - d2_of_place_3 * sin_angle_doubled
                            + q_right_top_ddot_by_q_left_ball_of_q_right_ball
                                * (d2_by_q_right_ball_of_place
                                    + cos_q_right_ball
                                        * (-d2_of_place_3)
                                            .mul_add(cos_angle, d2_by_q_right_ball_of_place)))
                        + cos_q_right_top_doubled
                            * (-p_w_left_link_frame_2_3
                                * d2_by_q_right_ball_of_place_2
                                    .mul_add(cos_q_right_ball, d2_by_q_right_ball_of_place_2)
                                + h_left_arm_2_times_6 * d2_by_q_right_ball_of_place_3))
                + l_times_6
                    * (cos_angle
                        * (cos_angle * (p_v_right_link_centre_1_3 + d2_by_q_right_ball_of_place_4)
                            - d2_of_place_2 * sin_angle
                            - mp_left_link_frame_3 * cos_q_right_top_doubled)
                        - opening_dot_of_place_39 * d2_by_q_right_ball_of_place_4))
            - S::int(12) * H_left_arm_2 * d2_by_q_right_top_of_place);
    let opening_dot_by_q_right_ball_of_place = (-p_w_spindle_frame_in_right_arm_frame_1_by_q_right_ball)
        .mul_add(
            cos_q_right_top,
            p_w_spindle_frame_in_right_arm_frame_3_by_q_right_ball * sin_q_right_top,
        );
    let m_sin_q_right_ball = m * sin_q_right_ball;
    let opening_dot_by_q_right_ball_of_place_2 = v_right_arm_frame_in_right_link_frame_1_2_by_q_right_ball
        * opening_dot_of_place_30;
    let opening_dot_by_q_right_ball_of_motion = q_right_top_dot * mp_left_link_frame_3;
    let opening_dot_by_q_right_ball_of_motion_2 = (q_right_top_dot
        * p_v_right_arm_frame_in_right_link_frame_3_by_q_right_ball)
        .mul_add(
            l_times_3,
            H_right_arm_1_by_q_right_top * w_right_arm_frame_in_right_link_frame_1_by_q_right_ball,
        );
    let opening_dot_by_q_right_ball_of_q_right_ball = sin_q_right_ball_inv * cos_q_right_ball;
    let opening_dot_by_q_right_ball_of_place_3 = opening_dot_by_q_right_ball_of_q_right_ball
        .mul_add(cos_angle, sin_angle);
    let opening_dot_by_q_right_ball_of_q_right_ball_2 = sin_q_right_ball_inv
        * opening_dot_by_q_right_ball_of_q_right_ball;
    let opening_dot_by_q_right_ball_of_place_4 = x_right_link_frame_in_right_arm_frame_1
        * cos_q_right_ball_doubled;
    let opening_dot_by_q_right_ball_of_place_5 = w_right_arm_frame_in_right_link_frame_1_3
        * d2_of_place_7;
    let opening_dot_by_q_right_ball_of_place_6 = d2_of_place_7
        * opening_dot_by_q_right_ball_of_place_3;
    let opening_dot_by_q_right_ball = d2_inv_by_12
        * (cos_angle_d2_of_place_7
            * (g_times_6
                * (-x_right_link_frame_in_right_arm_frame_3)
                    .mul_add(cos_q_right_top, opening_dot_by_q_right_top_of_place_2)
                - psi_dot * opening_dot_by_q_right_ball_of_place
                + l_times_6
                    * (cos_q_right_ball_doubled
                        * m
                            .mul_add(
                                v_right_arm_frame_in_right_link_frame_1_2_by_q_right_ball,
                                -p_v_right_arm_frame_in_right_link_frame_3_2,
                            ) - p_v_right_link_centre_1_2 * sin_q_right_ball_doubled
                        - v_right_arm_frame_in_right_link_frame_3_2_by_q_right_ball
                            * m_doubled * sin_q_right_ball
                        + q_right_ball_dot
                            * ((-p_v_right_arm_frame_in_right_link_frame_3_by_q_right_ball)
                                .mul_add(
                                    cos_q_right_ball_doubled,
                                    p_v_right_link_centre_1 * cos_q_right_ball,
                                )
                                + p_v_right_arm_frame_in_right_link_frame_3
                                    * sin_q_right_ball_doubled
                                + v_right_link_centre_1_by_q_right_ball * m_sin_q_right_ball))
                + opening_dot_by_q_right_ball_of_place_2)
            + d2_of_place_14
                * (-opening_dot_by_q_right_ball_of_place_2
                    + opening_dot_of_motion_2 * sin_q_right_ball
                    + sin_q_right_ball_doubled
                        * (v_right_link_centre_1_by_q_right_ball
                            * opening_dot_by_q_right_ball_of_motion)
                            .mul_add(
                                S::int(3),
                                w_spindle_frame_in_right_arm_frame_1
                                    * w_right_arm_frame_in_right_link_frame_1_by_q_right_ball
                                    * h_left_arm_2_doubled,
                            )
                    - cos_q_right_ball
                        * opening_dot_by_q_right_ball_of_motion_2
                            .mul_add(S::int(4), -opening_dot_of_motion))
            + opening_dot_of_motion_4 * opening_dot_by_q_right_ball_of_q_right_ball
            - opening_dot_of_theta_dot_3
                * (opening_dot_by_q_right_top_of_place_6
                    + d2_of_place_5
                        * (sin_angle_d2_of_place_22
                            + sin_q_left_ball
                                * (opening_dot_by_q_right_top_of_place_5
                                    + sin_q_left_ball
                                        * (sin_q_right_ball_inv
                                            * (cos_angle * (d2_of_place_12 - cos_angle)
                                                + opening_dot_by_q_right_top_of_place_3
                                                + cos_q_right_top
                                                    * ((-opening_dot_of_place_35)
                                                        .mul_add(sin_q_right_ball, cos_angle)
                                                        - opening_dot_of_q_right_ball
                                                            * opening_dot_by_q_right_ball_of_place_3
                                                            * cos_q_right_ball)) - opening_dot_by_q_right_top_of_place_4
                                            - opening_dot_of_place_38
                                                * opening_dot_by_q_right_ball_of_q_right_ball_2))))
            + opening_dot_by_theta_of_theta_dot
                * (cos_q_left_ball
                    * opening_dot_of_place_22
                        .mul_add(
                            opening_dot_by_q_right_ball_of_q_right_ball, cos_q_right_top,
                        )
                    + d2_of_place_5
                        * (sin_q_right_ball_inv
                            * (opening_dot_of_place_15 * q_right_ball_ddot_by_q_right_top_of_place
                                + opening_dot_of_place_14 * sin_q_left_ball_sq
                                    * opening_dot_by_q_right_ball_of_place_3
                                + cos_q_right_top
                                    * (sin_q_left_ball
                                        * (sin_q_left_ball
                                            * (sin_angle
                                                + sin_q_right_ball_inv
                                                    * (-(cos_q_right_ball_doubled * sin_q_right_ball_inv))
                                                        .mul_add(
                                                            opening_dot_of_place_22,
                                                            d2_of_place_12 - cos_q_right_top_doubled,
                                                        )
                                                + opening_dot_of_place_7
                                                    * opening_dot_by_q_right_ball_of_q_right_ball_2)
                                            + opening_dot_of_place_11 * sin_q_right_ball)
                                        + d2_of_place_22 * sin_q_right_ball))
                            + opening_dot_of_place_17
                                * opening_dot_by_q_right_ball_of_q_right_ball_2))
            + opening_dot_by_q_right_top_of_theta_dot_2
                * (sin_q_right_ball_inv
                    * (p_w_left_link_frame_2_3
                        * (sin_angle - w_right_arm_frame_in_right_link_frame_1_3_of_place)
                        + h_left_arm_2_times_6 * sin_q_right_ball * cos_angle
                        + sin_angle_d2_of_place_9)
                    + d2_of_place_28 * opening_dot_by_q_right_ball_of_q_right_ball_2)
            + opening_dot_of_motion_3 * opening_dot_by_q_right_ball_of_place_5
            - opening_dot_of_motion_5 * opening_dot_by_q_right_ball_of_place_6
            + opening_dot_by_theta_of_theta_dot_2
                * (d2_of_place_4 * opening_dot_by_q_right_ball_of_place_6
                    - h_left_arm_2_times_6 * d2_of_place_13 * d2_of_place_31
                    - d2_of_place_15 * opening_dot_by_q_right_ball_of_q_right_ball
                    - S::int(3) * cos_angle_d2_of_place_7
                        * (l_doubled
                            * ((-p_v_right_link_centre_1_3)
                                .mul_add(
                                    sin_q_right_ball,
                                    p_v_right_link_centre_1_3_by_q_right_ball * cos_q_right_ball,
                                )
                                + p_v_right_arm_frame_in_right_link_frame_3_3
                                    * cos_q_right_ball_doubled
                                + opening_dot_by_q_right_ball_of_place_4)
                            + l * p_v_right_link_centre_1_3_by_q_right_ball)
                    - d2_of_place_10 * opening_dot_by_q_right_ball_of_place_5))
        - d2_by_q_right_ball * opening_dot_d2_inv;
    let spin_dot_by_q_right_ball = d1_inv_by_12
        * ((-p_w_spindle_frame_in_right_arm_frame_3_2_by_q_right_ball)
            .mul_add(cos_q_right_top, d1_by_q_right_ball * spin_dot_by_theta_of_motion)
            - p_w_spindle_frame_in_right_arm_frame_1_2_by_q_right_ball * sin_q_right_top
            + q_right_top_dot * opening_dot_by_q_right_ball_of_place);
    let q_right_top_ddot_by_q_right_ball = -d2_of_place_6
        * (sin_q_left_ball
            * (sin_angle_opening_dot
                + cos_angle
                    * opening_dot
                        .mul_add(
                            opening_dot_by_q_right_ball_of_q_right_ball,
                            -opening_dot_by_q_right_ball,
                        ))
            + theta_dot_sq
                * (d2_of_place_5
                    * (sin_q_left_ball
                        * (sin_q_left_ball
                            * (d2_by_q_right_top_of_place
                                + sin_q_right_ball_inv
                                    * (cos_angle * cos_angle - sin_angle * sin_angle
                                        + cos_q_right_ball
                                            * (sin_q_right_ball_inv
                                                * (-opening_dot_of_place_34)
                                                    .mul_add(
                                                        cos_angle_doubled,
                                                        S::int(3) * opening_dot_of_place_37,
                                                    ) + d2_by_q_right_top_of_place_5
                                                - q_right_top_ddot_by_q_left_ball_of_place_3)))
                            - opening_dot_of_place_11 * opening_dot_by_q_right_ball_of_place_3)
                        - d2_of_place_22 * opening_dot_by_q_right_ball_of_place_3)
                    - opening_dot_by_q_right_ball_of_place_3 * cos_q_left_ball));
    let q_left_ball_ddot_by_q_right_ball = -opening_dot_by_q_right_ball * d2_of_place_19;
    let q_right_ball_ddot_by_q_right_ball = d2_of_place_5
        * (-sin_q_right_ball_inv
            * (cos_q_right_top * sin_q_left_ball
                * (-opening_dot)
                    .mul_add(
                        opening_dot_of_q_right_ball,
                        opening_dot_by_q_right_ball * d2_of_q_right_ball,
                    )
                + theta_dot_sq
                    * (d2_of_place_5
                        * (sin_q_left_ball
                            * (sin_q_left_ball
                                * (d2_by_q_right_top_of_place
                                    - opening_dot_of_place_8 * sin_q_right_top
                                    + sin_q_right_ball_inv
                                        * (cos_q_right_top
                                            * (cos_q_right_top
                                                * (-(sin_q_right_ball_inv * opening_dot_of_q_right_ball))
                                                    .mul_add(S::int(6), S::int(4) + cos_q_right_ball)
                                                + cos_angle * cos_q_right_ball
                                                + q_right_ball_ddot_by_theta_of_place_2)
                                            + sin_q_right_top
                                                * opening_dot_of_q_right_ball
                                                    .mul_add(cos_angle_doubled, d2_by_q_right_ball_of_place_3)))
                                + opening_dot_of_place_11 * opening_dot_of_place_22)
                            + d2_of_place_22 * opening_dot_of_place_22)
                        + opening_dot_of_place_22 * cos_q_left_ball))
            + opening_dot_by_q_right_ball * q_right_ball_ddot_by_q_right_top_of_place);
    let w_left_arm_frame_in_left_link_frame_1_by_psi_dot = w_left_arm_frame_in_left_link_frame_1_3;
    let w_right_arm_frame_in_right_link_frame_1_by_psi_dot = w_right_arm_frame_in_right_link_frame_1_3;
    let H_left_arm_1_by_psi_dot = H_left_arm_1_3;
    let H_right_arm_1_by_psi_dot = H_right_arm_1_3;
    let v_left_link_centre_2_by_psi_dot = l
        * (w_left_arm_frame_in_left_link_frame_1_by_psi_dot + sin_theta_doubled);
    let v_right_link_centre_2_by_psi_dot = l
        * (w_right_arm_frame_in_right_link_frame_1_by_psi_dot + sin_q_right_top_doubled);
    let p_v_right_arm_centre_2_by_psi_dot = l_m_plus_mb_times_4
        .mul_add(sin_q_right_top, v_right_link_centre_2_by_psi_dot * m_doubled);
    let p_v_left_arm_centre_2_by_psi_dot = l_m_plus_mb_times_4
        .mul_add(sin_theta, v_left_link_centre_2_by_psi_dot * m_doubled);
    let p_w_spindle_frame_in_right_arm_frame_3_by_psi_dot_of_place = S::int(3)
        * v_right_link_centre_2_by_psi_dot;
    let p_w_spindle_frame_in_right_arm_frame_3_by_psi_dot_of_place_2 = l
        .mul_add(
            w_right_arm_frame_in_right_link_frame_1_by_psi_dot,
            p_w_spindle_frame_in_right_arm_frame_3_by_psi_dot_of_place,
        );
    let p_w_spindle_frame_in_right_arm_frame_3_by_psi_dot = x_right_link_frame_in_right_arm_frame_1
        * p_w_spindle_frame_in_right_arm_frame_3_by_psi_dot_of_place_2;
    let p_w_spindle_frame_in_right_arm_frame_1_by_psi_dot = H_right_arm_1_by_psi_dot
        + l
            * m_cos_q_right_ball
                .mul_add(
                    p_w_spindle_frame_in_right_arm_frame_3_by_psi_dot_of_place_2,
                    S::int(3) * p_v_right_arm_centre_2_by_psi_dot,
                );
    let p_w_spindle_frame_in_left_arm_frame_3_by_psi_dot_of_place = S::int(3)
        * v_left_link_centre_2_by_psi_dot;
    let p_w_spindle_frame_in_left_arm_frame_3_by_psi_dot_of_place_2 = l
        .mul_add(
            w_left_arm_frame_in_left_link_frame_1_by_psi_dot,
            p_w_spindle_frame_in_left_arm_frame_3_by_psi_dot_of_place,
        );
    let p_w_spindle_frame_in_left_arm_frame_3_by_psi_dot = x_left_link_frame_in_left_arm_frame_1
        * p_w_spindle_frame_in_left_arm_frame_3_by_psi_dot_of_place_2;
    let p_w_spindle_frame_in_left_arm_frame_1_by_psi_dot = H_left_arm_1_by_psi_dot
        + l
            * m_cos_q_left_ball
                .mul_add(
                    p_w_spindle_frame_in_left_arm_frame_3_by_psi_dot_of_place_2,
                    S::int(3) * p_v_left_arm_centre_2_by_psi_dot,
                );
    let w_left_arm_frame_in_left_link_frame_1_2_by_psi_dot = -w_left_link_frame_2 * d2_of_place_23;
    let w_right_arm_frame_in_right_link_frame_1_2_by_psi_dot = -w_right_link_frame_2
        * w_right_arm_frame_in_right_link_frame_1_by_q_right_top_of_place_2;
    let theta_dot_cos_theta = theta_dot * cos_theta;
    let H_left_arm_1_2_by_psi_dot = H_left_arm_2 * theta_dot_cos_theta;
    let H_right_arm_1_2_by_psi_dot = H_right_arm_1_2_by_q_right_top_of_motion * cos_q_right_top;
    let v_left_link_centre_2_2_by_psi_dot = l
        * theta_dot_cos_theta
            .mul_add(S::int(2), w_left_arm_frame_in_left_link_frame_1_2_by_psi_dot);
    let v_right_link_centre_2_2_by_psi_dot = l
        * q_right_top_dot
            .mul_add(
                cos_q_right_top_doubled, w_right_arm_frame_in_right_link_frame_1_2_by_psi_dot,
            );
    let p_v_right_arm_centre_2_2_by_psi_dot = q_right_top_dot
        .mul_add(
            p_v_right_arm_centre_2_3_by_q_right_top_of_place,
            v_right_link_centre_2_2_by_psi_dot * m_doubled,
        );
    let p_v_left_arm_centre_2_2_by_psi_dot = l_m_plus_mb_times_4
        .mul_add(theta_dot_cos_theta, v_left_link_centre_2_2_by_psi_dot * m_doubled);
    let p_w_spindle_frame_in_right_arm_frame_3_2_by_psi_dot_of_place = S::int(3)
        * v_right_link_centre_2_2_by_psi_dot;
    let p_w_spindle_frame_in_right_arm_frame_3_2_by_psi_dot_of_place_2 = mp_left_link_frame_3
        * p_w_spindle_frame_in_right_arm_frame_3_by_psi_dot_of_place_2;
    let p_w_spindle_frame_in_right_arm_frame_3_2_by_psi_dot = x_right_link_frame_in_right_arm_frame_1
        * l
            .mul_add(
                w_right_arm_frame_in_right_link_frame_1_2_by_psi_dot,
                p_w_spindle_frame_in_right_arm_frame_3_2_by_psi_dot_of_place,
            )
        + w_right_arm_frame_in_right_link_frame_1_2_of_motion
            * p_w_spindle_frame_in_right_arm_frame_3_2_by_psi_dot_of_place_2;
    let p_w_spindle_frame_in_right_arm_frame_1_2_by_psi_dot = H_right_arm_1_2_by_psi_dot
        + l
            * (m
                * (l
                    * (-w_right_arm_frame_in_right_link_frame_1_by_psi_dot)
                        .mul_add(
                            w_right_arm_frame_in_right_link_frame_1_2_of_motion_2,
                            w_right_arm_frame_in_right_link_frame_1_2_by_psi_dot * cos_q_right_ball,
                        )
                    - w_right_arm_frame_in_right_link_frame_1_2_of_motion_2
                        * p_w_spindle_frame_in_right_arm_frame_3_by_psi_dot_of_place
                    + p_w_spindle_frame_in_right_arm_frame_3_2_by_psi_dot_of_place
                        * cos_q_right_ball) + S::int(3) * p_v_right_arm_centre_2_2_by_psi_dot);
    let p_w_spindle_frame_in_left_arm_frame_3_2_by_psi_dot_of_place = S::int(3)
        * v_left_link_centre_2_2_by_psi_dot;
    let p_w_spindle_frame_in_left_arm_frame_3_2_by_psi_dot = x_left_link_frame_in_left_arm_frame_1
        * l
            .mul_add(
                w_left_arm_frame_in_left_link_frame_1_2_by_psi_dot,
                p_w_spindle_frame_in_left_arm_frame_3_2_by_psi_dot_of_place,
            )
        + p_v_left_arm_frame_in_left_link_frame_3_2_by_theta_dot
            * p_w_spindle_frame_in_left_arm_frame_3_by_psi_dot_of_place_2;
    let p_w_spindle_frame_in_left_arm_frame_1_2_by_psi_dot = H_left_arm_1_2_by_psi_dot
        + l
            * (m
                * (l
                    * (-w_left_arm_frame_in_left_link_frame_1_by_psi_dot)
                        .mul_add(
                            p_w_spindle_frame_in_left_arm_frame_1_2_of_motion,
                            w_left_arm_frame_in_left_link_frame_1_2_by_psi_dot * cos_q_left_ball,
                        )
                    - p_w_spindle_frame_in_left_arm_frame_1_2_of_motion
                        * p_w_spindle_frame_in_left_arm_frame_3_by_psi_dot_of_place
                    + p_w_spindle_frame_in_left_arm_frame_3_2_by_psi_dot_of_place * cos_q_left_ball)
                + S::int(3) * p_v_left_arm_centre_2_2_by_psi_dot);
    let opening_dot_by_psi_dot_of_place = (-p_w_spindle_frame_in_left_arm_frame_1_by_psi_dot)
        .mul_add(
            cos_theta,
            p_w_spindle_frame_in_left_arm_frame_3_by_psi_dot * sin_theta,
        );
    let opening_dot_by_psi_dot_of_place_2 = (-p_w_spindle_frame_in_right_arm_frame_1_by_psi_dot)
        .mul_add(
            cos_q_right_top,
            p_w_spindle_frame_in_right_arm_frame_3_by_psi_dot * sin_q_right_top,
        );
    let opening_dot_by_psi_dot = -d2_inv_by_12
        * (opening_dot_of_place
            + d2_of_place_19
                * (cos_q_left_ball
                    * opening_dot_by_theta_of_place_4
                        .mul_add(
                            p_w_spindle_frame_in_left_arm_frame_3_by_psi_dot_of_place_2,
                            p_w_left_arm_frame_in_left_link_frame_1 * cos_theta,
                        )
                    - sin_q_left_ball
                        * opening_dot_by_theta_of_place_3
                            .mul_add(
                                p_w_spindle_frame_in_left_arm_frame_3_by_psi_dot_of_place_2,
                                p_w_left_arm_frame_in_left_link_frame_1 * sin_theta,
                            ))
            + d2_of_place_14
                * (cos_q_right_ball
                    * w_spindle_frame_in_right_arm_frame_3
                        .mul_add(
                            p_w_spindle_frame_in_right_arm_frame_3_2_by_psi_dot_of_place_2,
                            p_w_right_arm_frame_in_right_link_frame_1 * cos_q_right_top,
                        )
                    - sin_q_right_ball
                        * w_spindle_frame_in_right_arm_frame_1
                            .mul_add(
                                p_w_spindle_frame_in_right_arm_frame_3_2_by_psi_dot_of_place_2,
                                p_w_right_arm_frame_in_right_link_frame_1 * sin_q_right_top,
                            )) + psi_dot * opening_dot_by_psi_dot_of_place
            + cos_angle_d2_of_place_7
                * psi_dot
                    .mul_add(
                        opening_dot_by_psi_dot_of_place_2, opening_dot_of_place_45,
                    ));
    let spin_dot_by_psi_dot = d1_inv_by_12
        * ((-p_w_spindle_frame_in_right_arm_frame_3_2_by_psi_dot)
            .mul_add(cos_q_right_top, theta_dot * opening_dot_by_psi_dot_of_place)
            - p_w_spindle_frame_in_right_arm_frame_1_2_by_psi_dot * sin_q_right_top
            - p_w_spindle_frame_in_left_arm_frame_3_2_by_psi_dot * cos_theta
            - p_w_spindle_frame_in_left_arm_frame_1_2_by_psi_dot * sin_theta
            + q_right_top_dot * opening_dot_by_psi_dot_of_place_2);
    let q_right_top_ddot_by_psi_dot = opening_dot_by_psi_dot * cos_angle_d2_of_place_7;
    let q_left_ball_ddot_by_psi_dot = -opening_dot_by_psi_dot * d2_of_place_19;
    let q_right_ball_ddot_by_psi_dot = -opening_dot_by_psi_dot * d2_of_place_14;
    let w_left_arm_frame_in_left_link_frame_1_2_by_theta_dot = w_left_arm_frame_in_left_link_frame_1_by_theta_of_psi_dot;
    let H_left_arm_1_2_by_theta_dot = H_left_arm_1_by_theta;
    let v_left_link_centre_2_2_by_theta_dot = l
        * (w_left_arm_frame_in_left_link_frame_1_2_by_theta_dot
            + v_left_link_centre_2_by_theta_of_place);
    let p_v_left_arm_centre_2_2_by_theta_dot = v_left_link_centre_2_2_by_theta_dot
        .mul_add(m_doubled, p_v_left_arm_centre_2_by_theta_of_place);
    let p_w_spindle_frame_in_left_arm_frame_3_2_by_theta_dot_of_place = v_left_link_centre_2_2_by_theta_dot
        .mul_add(S::int(3), l * w_left_arm_frame_in_left_link_frame_1_2_by_theta_dot);
    let p_w_spindle_frame_in_left_arm_frame_3_2_by_theta_dot = x_left_link_frame_in_left_arm_frame_1
        * p_w_spindle_frame_in_left_arm_frame_3_2_by_theta_dot_of_place;
    let p_w_spindle_frame_in_left_arm_frame_1_2_by_theta_dot = H_left_arm_1_2_by_theta_dot
        + l
            * m_cos_q_left_ball
                .mul_add(
                    p_w_spindle_frame_in_left_arm_frame_3_2_by_theta_dot_of_place,
                    S::int(3) * p_v_left_arm_centre_2_2_by_theta_dot,
                );
    let v_left_link_centre_1_by_theta_dot = l.mul_add(cos_q_left_ball_doubled, l);
    let v_sleeve_centre_3_by_theta_dot_of_place = w_left_link_frame_2 * cos_theta_plus_q_left_ball;
    let v_sleeve_centre_3_by_theta_dot = l_doubled
        * (theta_dot_cos_theta + v_sleeve_centre_3_by_theta_dot_of_place);
    let p_v_left_link_centre_1_2_by_theta_dot = q_left_ball_dot
        * x_left_link_frame_in_left_arm_frame_1;
    let opening_dot_by_theta_dot_of_place = (-v_left_link_centre_1_by_theta_dot)
        .mul_add(m_sin_q_left_ball, d2_by_q_left_ball_of_place_6);
    let opening_dot_by_theta_dot_of_theta_dot = v_sleeve_centre_3_by_theta_dot
        .mul_add(opening_dot_by_q_left_ball_of_place_5, opening_dot_of_place_2)
        - theta_dot * opening_dot_by_theta_dot_of_place;
    let opening_dot_by_theta_dot_of_motion = (-p_v_left_link_centre_1_2_by_theta_dot)
        .mul_add(
            cos_q_left_ball_doubled,
            p_v_left_arm_frame_in_left_link_frame_3_2_by_theta_dot * sin_q_left_ball_doubled,
        ) + v_sleeve_centre_3_by_theta_dot * opening_dot_by_q_left_ball_of_place_7
        + q_left_ball_dot * opening_dot_by_theta_dot_of_place;
    let opening_dot_by_theta_dot = -S::ratio(1, 6) * d2_inv
        * (theta_dot
            * (d2_of_place_6 * d2_of_place_16)
                .mul_add(
                    opening_dot_of_place_44,
                    d2_of_place_5 * opening_dot_of_place_29,
                )
            + S::int(3) * l * d2_of_place_19
                * (p_v_left_link_centre_1_2_by_theta_dot - opening_dot_by_theta_dot_of_theta_dot)
            + l_times_3
                * (opening_dot_by_theta_dot_of_motion - p_v_left_link_centre_1_2_by_theta_dot));
    let spin_dot_by_theta_dot = d1_inv_by_12
        * (sin_theta
            * (p_w_spindle_frame_in_left_arm_frame_3
                - p_w_spindle_frame_in_left_arm_frame_1_2_by_theta_dot)
            - cos_theta
                * (p_w_spindle_frame_in_left_arm_frame_1
                    + p_w_spindle_frame_in_left_arm_frame_3_2_by_theta_dot));
    let theta_dot_doubled = S::int(2) * theta_dot;
    let q_right_top_ddot_by_theta_dot = d2_of_place_6
        * opening_dot_of_place_44
            .mul_add(
                theta_dot_doubled,
                opening_dot_by_theta_dot * opening_dot_of_place_15,
            );
    let q_left_ball_ddot_by_theta_dot = d2_of_place_5
        * (-opening_dot_by_theta_dot)
            .mul_add(cos_theta, opening_dot_of_place_27 * theta_dot_doubled)
        - opening_dot_by_theta_dot;
    let q_right_ball_ddot_by_theta_dot = d2_of_place_5
        * opening_dot_of_place_25
            .mul_add(
                theta_dot_doubled,
                opening_dot_by_theta_dot * q_right_ball_ddot_by_theta_of_place_3,
            );
    let w_right_arm_frame_in_right_link_frame_1_2_by_q_right_top_dot = w_right_arm_frame_in_right_link_frame_1_by_q_right_top_of_psi_dot_2;
    let H_right_arm_1_2_by_q_right_top_dot = H_right_arm_1_by_q_right_top;
    let v_right_link_centre_2_2_by_q_right_top_dot = l
        * (w_right_arm_frame_in_right_link_frame_1_2_by_q_right_top_dot
            + v_right_link_centre_2_by_q_right_top_of_psi_dot);
    let p_v_right_arm_centre_2_2_by_q_right_top_dot = v_right_link_centre_2_2_by_q_right_top_dot
        .mul_add(m_doubled, p_v_right_arm_centre_2_by_q_right_top_of_place);
    let p_w_spindle_frame_in_right_arm_frame_3_2_by_q_right_top_dot_of_place = v_right_link_centre_2_2_by_q_right_top_dot
        .mul_add(
            S::int(3),
            l * w_right_arm_frame_in_right_link_frame_1_2_by_q_right_top_dot,
        );
    let p_w_spindle_frame_in_right_arm_frame_3_2_by_q_right_top_dot = x_right_link_frame_in_right_arm_frame_1
        * p_w_spindle_frame_in_right_arm_frame_3_2_by_q_right_top_dot_of_place;
    let p_w_spindle_frame_in_right_arm_frame_1_2_by_q_right_top_dot = H_right_arm_1_2_by_q_right_top_dot
        + l
            * m_cos_q_right_ball
                .mul_add(
                    p_w_spindle_frame_in_right_arm_frame_3_2_by_q_right_top_dot_of_place,
                    S::int(3) * p_v_right_arm_centre_2_2_by_q_right_top_dot,
                );
    let v_right_link_centre_1_by_q_right_top_dot = l
        .mul_add(cos_q_right_ball_doubled, l);
    let p_v_right_link_centre_1_2_by_q_right_top_dot = q_right_ball_dot
        * x_right_link_frame_in_right_arm_frame_1;
    let p_v_right_arm_frame_in_right_link_frame_3_2_by_q_right_top_dot = mp_left_link_frame_3
        * w_right_arm_frame_in_right_link_frame_1_2_of_motion;
    let opening_dot_by_q_right_top_dot_of_place = l * p_v_right_link_centre_1_2_by_q_right_top_dot;
    let opening_dot_by_q_right_top_dot = S::ratio(1, 2) * d2_inv
        * (cos_angle_d2_of_place_7
            * (l
                * (p_v_right_link_centre_1_2_by_q_right_top_dot * cos_q_right_ball_doubled
                    - p_v_right_arm_frame_in_right_link_frame_3_2_by_q_right_top_dot
                        * sin_q_right_ball_doubled
                    - q_right_ball_dot
                        * (-v_right_link_centre_1_by_q_right_top_dot)
                            .mul_add(
                                m_sin_q_right_ball, opening_dot_by_q_right_ball_of_place_4,
                            )) + opening_dot_by_q_right_top_dot_of_place)
            + d2_of_place_14
                * (sin_q_right_ball
                    * v_right_link_centre_1_by_q_right_top_dot
                        .mul_add(
                            opening_dot_by_q_right_ball_of_motion,
                            l * p_v_right_link_centre_1,
                        )
                    - cos_q_right_ball_doubled
                        * H_right_arm_1_2_by_q_right_top_of_motion
                            .mul_add(
                                sin_q_right_ball,
                                l * p_v_right_arm_frame_in_right_link_frame_3,
                            ) - opening_dot_by_q_right_top_dot_of_place));
    let spin_dot_by_q_right_top_dot = d1_inv_by_12
        * (sin_q_right_top
            * (p_w_spindle_frame_in_right_arm_frame_3
                - p_w_spindle_frame_in_right_arm_frame_1_2_by_q_right_top_dot)
            - cos_q_right_top
                * (p_w_spindle_frame_in_right_arm_frame_1
                    + p_w_spindle_frame_in_right_arm_frame_3_2_by_q_right_top_dot));
    let q_right_top_ddot_by_q_right_top_dot = opening_dot_by_q_right_top_dot
        * cos_angle_d2_of_place_7;
    let q_left_ball_ddot_by_q_right_top_dot = -opening_dot_by_q_right_top_dot * d2_of_place_19;
    let q_right_ball_ddot_by_q_right_top_dot = -opening_dot_by_q_right_top_dot * d2_of_place_14;
    let w_left_arm_frame_in_left_link_frame_1_2_by_q_left_ball_dot = w_left_arm_frame_in_left_link_frame_1_by_q_left_ball_of_place;
    let p_w_spindle_frame_in_left_arm_frame_3_2_by_q_left_ball_dot = w_left_arm_frame_in_left_link_frame_1_2_by_q_left_ball_dot
        .mul_add(
            p_w_spindle_frame_in_left_arm_frame_3_by_q_left_ball_of_place,
            p_w_spindle_frame_in_left_arm_frame_1_of_place,
        );
    let p_w_spindle_frame_in_left_arm_frame_1_2_by_q_left_ball_dot = w_left_arm_frame_in_left_link_frame_1_2_by_q_left_ball_dot
        .mul_add(
            p_w_spindle_frame_in_left_arm_frame_1_by_q_left_ball_of_place,
            -p_w_spindle_frame_in_left_arm_frame_3,
        );
    let v_sleeve_centre_3_by_q_left_ball_dot = l_doubled * v_sleeve_centre_3_by_theta_dot_of_place;
    let p_v_left_link_centre_1_2_by_q_left_ball_dot = theta_dot
        * x_left_link_frame_in_left_arm_frame_1;
    let p_v_left_arm_frame_in_left_link_frame_3_2_by_q_left_ball_dot = p_v_left_arm_frame_in_left_link_frame_3_by_q_left_ball;
    let opening_dot_by_q_left_ball_dot_of_place = w_left_link_frame_2
        .mul_add(mp_left_link_frame_3, p_v_left_link_centre_1)
        - S::int(2) * p_v_left_arm_frame_in_left_link_frame_3_2_by_q_left_ball_dot;
    let opening_dot_by_q_left_ball_dot_of_place_2 = p_v_left_arm_frame_in_left_link_frame_3
        - p_v_left_link_centre_1_2_by_q_left_ball_dot;
    let d2_inv_l_halved = d2_inv * l_halved;
    let opening_dot_by_q_left_ball_dot = d2_of_place_23_inv * d2_inv_l_halved
        * (cos_theta
            * p_v_left_arm_frame_in_left_link_frame_3
                .mul_add(S::int(2), -p_v_left_link_centre_1_2_by_q_left_ball_dot)
            - sin_q_left_ball
                * (cos_theta
                    * (opening_dot_by_q_left_ball_dot_of_place
                        .mul_add(cos_q_left_ball, theta_dot * mp_left_link_frame_3)
                        + sin_q_left_ball_doubled * opening_dot_by_q_left_ball_dot_of_place_2)
                    + v_sleeve_centre_3_by_q_left_ball_dot * ms_doubled
                    + sin_theta
                        * (-opening_dot_by_q_left_ball_dot_of_place)
                            .mul_add(
                                sin_q_left_ball,
                                cos_q_left_ball_doubled * opening_dot_by_q_left_ball_dot_of_place_2,
                            )));
    let spin_dot_by_q_left_ball_dot = -d1_inv_by_12
        * p_w_spindle_frame_in_left_arm_frame_1_2_by_q_left_ball_dot
            .mul_add(
                sin_theta,
                p_w_spindle_frame_in_left_arm_frame_3_2_by_q_left_ball_dot * cos_theta,
            );
    let q_right_top_ddot_by_q_left_ball_dot = opening_dot_by_q_left_ball_dot
        * cos_angle_d2_of_place_7;
    let q_left_ball_ddot_by_q_left_ball_dot = -opening_dot_by_q_left_ball_dot * d2_of_place_19;
    let q_right_ball_ddot_by_q_left_ball_dot = -opening_dot_by_q_left_ball_dot * d2_of_place_14;
    let w_right_arm_frame_in_right_link_frame_1_2_by_q_right_ball_dot = w_right_arm_frame_in_right_link_frame_1_by_q_right_ball_of_place_2;
    let p_w_spindle_frame_in_right_arm_frame_3_2_by_q_right_ball_dot = w_right_arm_frame_in_right_link_frame_1_2_by_q_right_ball_dot
        .mul_add(
            p_w_spindle_frame_in_right_arm_frame_3_by_q_right_ball_of_place,
            p_w_spindle_frame_in_right_arm_frame_1_of_place,
        );
    let p_w_spindle_frame_in_right_arm_frame_1_2_by_q_right_ball_dot = w_right_arm_frame_in_right_link_frame_1_2_by_q_right_ball_dot
        .mul_add(
            p_w_spindle_frame_in_right_arm_frame_1_by_q_right_ball_of_place,
            -p_w_spindle_frame_in_right_arm_frame_3,
        );
    let p_v_right_link_centre_1_2_by_q_right_ball_dot = q_right_top_dot
        * x_right_link_frame_in_right_arm_frame_1;
    let p_v_right_arm_frame_in_right_link_frame_3_2_by_q_right_ball_dot = p_v_right_arm_frame_in_right_link_frame_3_by_q_right_ball;
    let opening_dot_by_q_right_ball_dot = d2_of_place_31 * d2_inv_l_halved
        * (cos_angle
            * (p_v_right_link_centre_1 + q_right_ball_dot * mp_left_link_frame_3
                - S::int(2) * p_v_right_arm_frame_in_right_link_frame_3_2_by_q_right_ball_dot
                + sin_q_right_ball_inv
                    * (p_v_right_link_centre_1_2_by_q_right_ball_dot
                        + cos_q_right_ball_doubled
                            * (p_v_right_link_centre_1_2_by_q_right_ball_dot
                                - p_v_right_arm_frame_in_right_link_frame_3)))
            + cos_q_right_top
                * (-p_v_right_link_centre_1_2_by_q_right_ball_dot)
                    .mul_add(
                        opening_dot_of_q_right_ball,
                        d2_of_q_right_ball * opening_dot_by_q_right_ball_of_motion,
                    ));
    let spin_dot_by_q_right_ball_dot = -d1_inv_by_12
        * p_w_spindle_frame_in_right_arm_frame_1_2_by_q_right_ball_dot
            .mul_add(
                sin_q_right_top,
                p_w_spindle_frame_in_right_arm_frame_3_2_by_q_right_ball_dot * cos_q_right_top,
            );
    let q_right_top_ddot_by_q_right_ball_dot = opening_dot_by_q_right_ball_dot
        * cos_angle_d2_of_place_7;
    let q_left_ball_ddot_by_q_right_ball_dot = -opening_dot_by_q_right_ball_dot * d2_of_place_19;
    let q_right_ball_ddot_by_q_right_ball_dot = -opening_dot_by_q_right_ball_dot * d2_of_place_14;
    // Entries that are not zero.
    let psi_dot_by_psi_dot_value = S::int(1);
    let theta_dot_by_theta_dot_value = S::int(1);
    let q_right_top_dot_by_q_right_top_dot_value = S::int(1);
    let q_left_ball_dot_by_q_left_ball_dot_value = S::int(1);
    let q_right_ball_dot_by_q_right_ball_dot_value = S::int(1);
    let zero = S::int(0);
    [
        [zero, zero, zero, zero, zero, psi_dot_by_psi_dot_value, zero, zero, zero, zero],
        [
            zero, zero, zero, zero, zero, zero, theta_dot_by_theta_dot_value, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, q_right_top_dot_by_q_right_top_dot_value,
            zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero,
            q_left_ball_dot_by_q_left_ball_dot_value, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero,
            q_right_ball_dot_by_q_right_ball_dot_value,
        ],
        [
            zero, spin_dot_by_theta, spin_dot_by_q_right_top, spin_dot_by_q_left_ball,
            spin_dot_by_q_right_ball, spin_dot_by_psi_dot, spin_dot_by_theta_dot,
            spin_dot_by_q_right_top_dot, spin_dot_by_q_left_ball_dot, spin_dot_by_q_right_ball_dot,
        ],
        [
            zero, opening_dot_by_theta, opening_dot_by_q_right_top, opening_dot_by_q_left_ball,
            opening_dot_by_q_right_ball, opening_dot_by_psi_dot, opening_dot_by_theta_dot,
            opening_dot_by_q_right_top_dot, opening_dot_by_q_left_ball_dot,
            opening_dot_by_q_right_ball_dot,
        ],
        [
            zero, q_right_top_ddot_by_theta, q_right_top_ddot_by_q_right_top,
            q_right_top_ddot_by_q_left_ball, q_right_top_ddot_by_q_right_ball,
            q_right_top_ddot_by_psi_dot, q_right_top_ddot_by_theta_dot,
            q_right_top_ddot_by_q_right_top_dot, q_right_top_ddot_by_q_left_ball_dot,
            q_right_top_ddot_by_q_right_ball_dot,
        ],
        [
            zero, q_left_ball_ddot_by_theta, q_left_ball_ddot_by_q_right_top,
            q_left_ball_ddot_by_q_left_ball, q_left_ball_ddot_by_q_right_ball,
            q_left_ball_ddot_by_psi_dot, q_left_ball_ddot_by_theta_dot,
            q_left_ball_ddot_by_q_right_top_dot, q_left_ball_ddot_by_q_left_ball_dot,
            q_left_ball_ddot_by_q_right_ball_dot,
        ],
        [
            zero, q_right_ball_ddot_by_theta, q_right_ball_ddot_by_q_right_top,
            q_right_ball_ddot_by_q_left_ball, q_right_ball_ddot_by_q_right_ball,
            q_right_ball_ddot_by_psi_dot, q_right_ball_ddot_by_theta_dot,
            q_right_ball_ddot_by_q_right_top_dot, q_right_ball_ddot_by_q_left_ball_dot,
            q_right_ball_ddot_by_q_right_ball_dot,
        ],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 1 operation, 2 sines and cosines.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 5], _q_dot: &[S; 5]) -> [S; 2] {
    let [_, theta, _, q_left_ball, q_right_ball] = *q;
    // Sines and cosines.
    let (sin_q_right_ball, _) = q_right_ball.sin_cos();
    let (_, cos_theta_plus_q_left_ball) = (theta + q_left_ball).sin_cos();
    // Values.
    // divisor1 = sin(q_right_ball)
    let divisor1 = sin_q_right_ball;
    // divisor2 = cos(theta + q_left_ball)
    let divisor2 = cos_theta_plus_q_left_ball;
    [divisor1, divisor2]
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 32 operations, 4 sines and cosines.
#[must_use]
pub fn constraints<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> [S; 6] {
    let Parameters { l, .. } = *p;
    let [_, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    let [_, theta_dot, q_right_top_dot, q_left_ball_dot, q_right_ball_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    // Shared terms.
    // theta + q_left_ball
    let theta_plus_q_left_ball = theta + q_left_ball;
    let (sin_theta_plus_q_left_ball, cos_theta_plus_q_left_ball) = theta_plus_q_left_ball
        .sin_cos();
    // sin(theta) + sin(theta + q_left_ball)
    let residual1_of_place = sin_theta + sin_theta_plus_q_left_ball;
    // q_right_top + q_right_ball
    let residual2_of_place = q_right_top + q_right_ball;
    let (sin_angle, cos_angle) = residual2_of_place.sin_cos();
    // sin(q_right_top) + sin(q_right_top + q_right_ball)
    let residual2_of_place_2 = sin_q_right_top + sin_angle;
    // cos(theta) + cos(theta + q_left_ball)
    let residual3_of_place = cos_theta + cos_theta_plus_q_left_ball;
    // cos(q_right_top) + cos(q_right_top + q_right_ball)
    let residual3_of_place_2 = cos_q_right_top + cos_angle;
    // Values.
    // left_end_1 = -l*(sin(theta) + sin(theta + q_left_ball))
    let residual1 = -l * residual1_of_place;
    // right_end_1 = -l*(sin(q_right_top) + sin(q_right_top + q_right_ball))
    let residual2 = -l * residual2_of_place_2;
    // right_end_3 = l*(cos(theta) + cos(theta + q_left_ball)) - l*(cos(q_right_top) + cos(q_right_top +
    //   q_right_ball))
    let residual3 = l * (residual3_of_place - residual3_of_place_2);
    // left_end_1' = -l*(theta'*cos(theta) + cos(theta + q_left_ball)*(theta' + q_left_ball'))
    let residual4 = -l
        * (cos_theta_plus_q_left_ball * (theta_dot + q_left_ball_dot) + theta_dot * cos_theta);
    // right_end_1' = -l*(q_right_top'*cos(q_right_top) + cos(q_right_top + q_right_ball)*(q_right_top' +
    //   q_right_ball'))
    let residual5 = -l
        * (cos_angle * (q_right_top_dot + q_right_ball_dot) + q_right_top_dot * cos_q_right_top);
    // right_end_3' = l*(q_right_top'*(sin(q_right_top) + sin(q_right_top + q_right_ball)) -
    //   theta'*(sin(theta) + sin(theta + q_left_ball)) - q_left_ball'*sin(theta + q_left_ball) +
    //   q_right_ball'*sin(q_right_top + q_right_ball))
    let residual6 = l
        * ((-q_left_ball_dot)
            .mul_add(sin_theta_plus_q_left_ball, q_right_ball_dot * sin_angle)
            - theta_dot * residual1_of_place + q_right_top_dot * residual2_of_place_2);
    [residual1, residual2, residual3, residual4, residual5, residual6]
}

/// Slopes of the constraints, one after the other, along psi, theta, q_right_top, q_left_ball, q_right_ball, psi', theta', q_right_top', q_left_ball', q_right_ball'.
///
/// 44 operations, 4 sines and cosines.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 60] {
    let Parameters { l, .. } = *p;
    let [_, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    let [_, theta_dot, q_right_top_dot, q_left_ball_dot, q_right_ball_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    // Step by step, each after the terms that it needs.
    let theta_plus_q_left_ball = theta + q_left_ball;
    let (sin_theta_plus_q_left_ball, cos_theta_plus_q_left_ball) = theta_plus_q_left_ball
        .sin_cos();
    let residual1_by_theta_of_place = cos_theta + cos_theta_plus_q_left_ball;
    let residual1_by_theta_of_place_2 = l * residual1_by_theta_of_place;
    let residual1_by_q_left_ball_of_place = l * cos_theta_plus_q_left_ball;
    let residual2_by_q_right_top_of_place = q_right_top + q_right_ball;
    let (sin_angle, cos_angle) = residual2_by_q_right_top_of_place.sin_cos();
    let residual2_by_q_right_top_of_place_2 = cos_q_right_top + cos_angle;
    let residual2_by_q_right_top_of_place_3 = l * residual2_by_q_right_top_of_place_2;
    let l_cos_angle = l * cos_angle;
    let residual3_by_theta_of_place = l * (sin_theta + sin_theta_plus_q_left_ball);
    let residual3_by_q_right_top_of_place = l * (sin_q_right_top + sin_angle);
    let residual3_by_q_left_ball_of_place = l * sin_theta_plus_q_left_ball;
    let l_sin_angle = l * sin_angle;
    let residual4_by_theta_of_motion = theta_dot + q_left_ball_dot;
    let residual5_by_q_right_top_of_motion = q_right_top_dot + q_right_ball_dot;
    let residual1_by_theta_of_place_3 = -residual1_by_theta_of_place_2;
    let residual1_by_q_left_ball_of_place_2 = -residual1_by_q_left_ball_of_place;
    let residual2_by_q_right_top_of_place_4 = -residual2_by_q_right_top_of_place_3;
    let minus_l_cos_angle = -l_cos_angle;
    let residual3_by_theta_of_place_2 = -residual3_by_theta_of_place;
    let residual3_by_q_left_ball_of_place_2 = -residual3_by_q_left_ball_of_place;
    // Values.
    let residual1_by_theta = residual1_by_theta_of_place_3;
    let residual1_by_q_left_ball = residual1_by_q_left_ball_of_place_2;
    let residual2_by_q_right_top = residual2_by_q_right_top_of_place_4;
    let residual2_by_q_right_ball = minus_l_cos_angle;
    let residual3_by_theta = residual3_by_theta_of_place_2;
    let residual3_by_q_right_top = residual3_by_q_right_top_of_place;
    let residual3_by_q_left_ball = residual3_by_q_left_ball_of_place_2;
    let residual3_by_q_right_ball = l_sin_angle;
    let residual4_by_theta = l
        * residual4_by_theta_of_motion
            .mul_add(sin_theta_plus_q_left_ball, theta_dot * sin_theta);
    let residual4_by_q_left_ball = residual3_by_q_left_ball_of_place * residual4_by_theta_of_motion;
    let residual4_by_theta_dot = residual1_by_theta_of_place_3;
    let residual4_by_q_left_ball_dot = residual1_by_q_left_ball_of_place_2;
    let residual5_by_q_right_top = l
        * residual5_by_q_right_top_of_motion
            .mul_add(sin_angle, q_right_top_dot * sin_q_right_top);
    let residual5_by_q_right_ball = l_sin_angle * residual5_by_q_right_top_of_motion;
    let residual5_by_q_right_top_dot = residual2_by_q_right_top_of_place_4;
    let residual5_by_q_right_ball_dot = minus_l_cos_angle;
    let residual6_by_theta = -l
        * theta_dot
            .mul_add(
                residual1_by_theta_of_place,
                q_left_ball_dot * cos_theta_plus_q_left_ball,
            );
    let residual6_by_q_right_top = l
        * q_right_top_dot
            .mul_add(residual2_by_q_right_top_of_place_2, q_right_ball_dot * cos_angle);
    let residual6_by_q_left_ball = -residual1_by_q_left_ball_of_place
        * residual4_by_theta_of_motion;
    let residual6_by_q_right_ball = l_cos_angle * residual5_by_q_right_top_of_motion;
    let residual6_by_theta_dot = residual3_by_theta_of_place_2;
    let residual6_by_q_right_top_dot = residual3_by_q_right_top_of_place;
    let residual6_by_q_left_ball_dot = residual3_by_q_left_ball_of_place_2;
    let residual6_by_q_right_ball_dot = l_sin_angle;
    let zero = S::int(0);
    [
        zero, residual1_by_theta, zero, residual1_by_q_left_ball, zero, zero, zero, zero, zero,
        zero, zero, zero, residual2_by_q_right_top, zero, residual2_by_q_right_ball, zero, zero,
        zero, zero, zero, zero, residual3_by_theta, residual3_by_q_right_top,
        residual3_by_q_left_ball, residual3_by_q_right_ball, zero, zero, zero, zero, zero, zero,
        residual4_by_theta, zero, residual4_by_q_left_ball, zero, zero, residual4_by_theta_dot,
        zero, residual4_by_q_left_ball_dot, zero, zero, zero, residual5_by_q_right_top, zero,
        residual5_by_q_right_ball, zero, zero, residual5_by_q_right_top_dot, zero,
        residual5_by_q_right_ball_dot, zero, residual6_by_theta, residual6_by_q_right_top,
        residual6_by_q_left_ball, residual6_by_q_right_ball, zero, residual6_by_theta_dot,
        residual6_by_q_right_top_dot, residual6_by_q_left_ball_dot, residual6_by_q_right_ball_dot,
    ]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 189 convolutions and 436 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 10]],
    history: &mut [Factors<S, 192>],
) {
    let Parameters { l, m, mb, ms, J, Js, g } = *p;
    let [_, theta_0, q_right_top_0, q_left_ball_0, q_right_ball_0, psi_dot_0,
    theta_dot_0, q_right_top_dot_0, q_left_ball_dot_0, q_right_ball_dot_0] = series[0];
    // Step by step, each after the terms that it needs.
    let l_sq_m = l * l * m;
    let l_m_2 = l * m;
    let l_mb = l * mb;
    let l_ms_2 = l * ms;
    let l_sq_ms = l * l * ms;
    let l_m_g = l * m * g;
    let weight_3_of_l_m_mb = l * l_mb.mul_add(S::int(4), l_m_2);
    // Constant in time.
    // weight = 2*l
    let weight = S::int(2) * l;
    // l_2_m = l^2*m
    let l_2_m = l_sq_m;
    // weight_2 = 3*l*m
    let weight_2 = S::int(3) * l_m_2;
    // weight_3 = l^2*m + 3*l*(l*m + 4*l*mb)
    let weight_3 = weight_3_of_l_m_mb.mul_add(S::int(3), l_sq_m);
    // weight_4 = 6*l*m
    let weight_4 = S::int(6) * l_m_2;
    // weight_5 = 3*l*m + 2*l*mb
    let weight_5 = l_mb.mul_add(S::int(2), S::int(3) * l_m_2);
    // l_m = l*m
    let l_m = l_m_2;
    // j_plus_js = J + Js
    let j_plus_js = J + Js;
    // weight_6 = 4*l^2*m
    let weight_6 = S::int(4) * l_sq_m;
    // weight_7 = 12*l^2*ms
    let weight_7 = S::int(12) * l_sq_ms;
    // weight_8 = 6*l^2*m
    let weight_8 = S::int(6) * l_sq_m;
    // weight_9 = 2*l^2*m + 3*l*(l*m + 4*l*mb)
    let weight_9 = weight_3_of_l_m_mb.mul_add(S::int(3), S::int(2) * l_sq_m);
    // weight_10 = 12*l^2*m
    let weight_10 = S::int(12) * l_sq_m;
    // weight_11 = 2*l*ms
    let weight_11 = S::int(2) * l_ms_2;
    // weight_12 = 6*l
    let weight_12 = S::int(6) * l;
    // minus_6_l_2_m = -6*l^2*m
    let minus_6_l_2_m = -S::int(6) * l_sq_m;
    // minus_4_l_2_m = -4*l^2*m
    let minus_4_l_2_m = -S::int(4) * l_sq_m;
    // weight_13 = l^2*m/6 + l*(l*m + 4*l*mb)/4
    let weight_13 = S::ratio(1, 6) * l_sq_m + S::ratio(1, 4) * weight_3_of_l_m_mb;
    // l_m_by_4 = l*m/4
    let l_m_by_4 = S::ratio(1, 4) * l_m_2;
    // l_2_ms = l^2*ms
    let l_2_ms = l_sq_ms;
    // l_m_by_2 = l*m/2
    let l_m_by_2 = S::ratio(1, 2) * l_m_2;
    // minus_2_l_m = -2*l*m
    let minus_2_l_m = -S::int(2) * l_m_2;
    // ms_g = ms*g
    let ms_g = ms * g;
    // l_ms = l*ms
    let l_ms = l_ms_2;
    // weight_14 = 6*l*m*g
    let weight_14 = S::int(6) * l_m_g;
    // minus_6_l_m_g = -6*l*m*g
    let minus_6_l_m_g = -S::int(6) * l_m_g;
    // minus_6_g = -6*g
    let minus_6_g = -S::int(6) * g;
    // minus_12_l_2_m = -12*l^2*m
    let minus_12_l_2_m = -S::int(12) * l_sq_m;
    // minus_6_l = -6*l
    let minus_6_l = -S::int(6) * l;
    // minus_12_l = -12*l
    let minus_12_l = -S::int(12) * l;
    // minus_12_l_ms_g = -12*l*ms*g
    let minus_12_l_ms_g = -S::int(12) * l * ms * g;
    // minus_12_l_2_ms = -12*l^2*ms
    let minus_12_l_2_ms = -S::int(12) * l_sq_ms;
    // Order 0.
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    let psi_dot_sin_theta_0 = psi_dot_0 * sin_theta_0;
    let psi_dot_cos_theta_0 = psi_dot_0 * cos_theta_0;
    let (sin_q_right_top_0, cos_q_right_top_0) = q_right_top_0.sin_cos();
    let psi_dot_sin_q_right_top_0 = psi_dot_0 * sin_q_right_top_0;
    let psi_dot_cos_q_right_top_0 = psi_dot_0 * cos_q_right_top_0;
    let (sin_q_left_ball_0, cos_q_left_ball_0) = q_left_ball_0.sin_cos();
    let w_left_arm_frame_in_left_link_frame_1_of_psi_dot_0 = sin_q_left_ball_0
        * psi_dot_cos_theta_0;
    let w_left_arm_frame_in_left_link_frame_1_of_psi_dot_2_0 = cos_q_left_ball_0
        * psi_dot_sin_theta_0;
    let w_left_arm_frame_in_left_link_frame_1_of_place_0 = w_left_arm_frame_in_left_link_frame_1_of_psi_dot_0
        + w_left_arm_frame_in_left_link_frame_1_of_psi_dot_2_0;
    let (sin_q_right_ball_0, cos_q_right_ball_0) = q_right_ball_0.sin_cos();
    let over_sin_q_right_ball = S::int(1) / sin_q_right_ball_0;
    let w_right_arm_frame_in_right_link_frame_1_of_psi_dot_0 = sin_q_right_ball_0
        * psi_dot_cos_q_right_top_0;
    let w_right_arm_frame_in_right_link_frame_1_of_psi_dot_2_0 = cos_q_right_ball_0
        * psi_dot_sin_q_right_top_0;
    let w_right_arm_frame_in_right_link_frame_1_of_place_0 = w_right_arm_frame_in_right_link_frame_1_of_psi_dot_0
        + w_right_arm_frame_in_right_link_frame_1_of_psi_dot_2_0;
    let v_left_link_centre_2_of_place_0 = w_left_arm_frame_in_left_link_frame_1_of_place_0
        .mul_add(l, weight * psi_dot_sin_theta_0);
    let v_right_link_centre_2_of_place_0 = w_right_arm_frame_in_right_link_frame_1_of_place_0
        .mul_add(l, weight * psi_dot_sin_q_right_top_0);
    let p_w_right_arm_frame_in_right_link_frame_1_of_place_0 = v_right_link_centre_2_of_place_0
        .mul_add(weight_2, l_2_m * w_right_arm_frame_in_right_link_frame_1_of_place_0);
    let p_w_left_arm_frame_in_left_link_frame_1_of_place_0 = v_left_link_centre_2_of_place_0
        .mul_add(weight_2, l_2_m * w_left_arm_frame_in_left_link_frame_1_of_place_0);
    let p_w_spindle_frame_in_right_arm_frame_3_of_place_0 = sin_q_right_ball_0
        * p_w_right_arm_frame_in_right_link_frame_1_of_place_0;
    let p_w_spindle_frame_in_right_arm_frame_1_of_place_0 = cos_q_right_ball_0
        * p_w_right_arm_frame_in_right_link_frame_1_of_place_0;
    let p_w_spindle_frame_in_right_arm_frame_1_of_place_2_0 = v_right_link_centre_2_of_place_0
        .mul_add(weight_4, weight_3 * psi_dot_sin_q_right_top_0)
        + p_w_spindle_frame_in_right_arm_frame_1_of_place_0;
    let p_w_spindle_frame_in_left_arm_frame_3_of_place_0 = sin_q_left_ball_0
        * p_w_left_arm_frame_in_left_link_frame_1_of_place_0;
    let p_w_spindle_frame_in_left_arm_frame_1_of_place_0 = cos_q_left_ball_0
        * p_w_left_arm_frame_in_left_link_frame_1_of_place_0;
    let p_w_spindle_frame_in_left_arm_frame_1_of_place_2_0 = v_left_link_centre_2_of_place_0
        .mul_add(weight_4, weight_3 * psi_dot_sin_theta_0)
        + p_w_spindle_frame_in_left_arm_frame_1_of_place_0;
    let w_spindle_frame_in_left_arm_frame_1_2_of_motion_0 = theta_dot_0 * psi_dot_cos_theta_0;
    let w_spindle_frame_in_left_arm_frame_3_2_of_motion_0 = theta_dot_0 * psi_dot_sin_theta_0;
    let w_spindle_frame_in_right_arm_frame_1_2_of_motion_0 = q_right_top_dot_0
        * psi_dot_cos_q_right_top_0;
    let w_spindle_frame_in_right_arm_frame_3_2_of_motion_0 = q_right_top_dot_0
        * psi_dot_sin_q_right_top_0;
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion_0 = q_left_ball_dot_0 * cos_q_left_ball_0;
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion_2_0 = psi_dot_cos_theta_0
        * w_left_arm_frame_in_left_link_frame_1_2_of_motion_0;
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion_3_0 = sin_q_left_ball_0
        * w_spindle_frame_in_left_arm_frame_3_2_of_motion_0;
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_0 = q_left_ball_dot_0
        * sin_q_left_ball_0;
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion_5_0 = psi_dot_sin_theta_0
        * w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_0;
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion_6_0 = cos_q_left_ball_0
        * w_spindle_frame_in_left_arm_frame_1_2_of_motion_0;
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion_7_0 = w_left_arm_frame_in_left_link_frame_1_2_of_motion_2_0
        - w_left_arm_frame_in_left_link_frame_1_2_of_motion_5_0
        + w_left_arm_frame_in_left_link_frame_1_2_of_motion_6_0
        - w_left_arm_frame_in_left_link_frame_1_2_of_motion_3_0;
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion_0 = q_right_ball_dot_0
        * cos_q_right_ball_0;
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion_2_0 = psi_dot_cos_q_right_top_0
        * w_right_arm_frame_in_right_link_frame_1_2_of_motion_0;
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion_3_0 = sin_q_right_ball_0
        * w_spindle_frame_in_right_arm_frame_3_2_of_motion_0;
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_0 = q_right_ball_dot_0
        * sin_q_right_ball_0;
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion_5_0 = psi_dot_sin_q_right_top_0
        * w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_0;
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion_6_0 = cos_q_right_ball_0
        * w_spindle_frame_in_right_arm_frame_1_2_of_motion_0;
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion_7_0 = w_right_arm_frame_in_right_link_frame_1_2_of_motion_2_0
        - w_right_arm_frame_in_right_link_frame_1_2_of_motion_5_0
        + w_right_arm_frame_in_right_link_frame_1_2_of_motion_6_0
        - w_right_arm_frame_in_right_link_frame_1_2_of_motion_3_0;
    let v_left_link_centre_2_2_of_place_0 = w_left_arm_frame_in_left_link_frame_1_2_of_motion_7_0
        .mul_add(l, weight * w_spindle_frame_in_left_arm_frame_1_2_of_motion_0);
    let v_right_link_centre_2_2_of_place_0 = w_right_arm_frame_in_right_link_frame_1_2_of_motion_7_0
        .mul_add(l, weight * w_spindle_frame_in_right_arm_frame_1_2_of_motion_0);
    let p_w_right_arm_frame_in_right_link_frame_1_2_of_place_0 = v_right_link_centre_2_2_of_place_0
        .mul_add(
            weight_2,
            l_2_m * w_right_arm_frame_in_right_link_frame_1_2_of_motion_7_0,
        );
    let p_w_left_arm_frame_in_left_link_frame_1_2_of_place_0 = v_left_link_centre_2_2_of_place_0
        .mul_add(
            weight_2,
            l_2_m * w_left_arm_frame_in_left_link_frame_1_2_of_motion_7_0,
        );
    let p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_0 = p_w_right_arm_frame_in_right_link_frame_1_of_place_0
        * w_right_arm_frame_in_right_link_frame_1_2_of_motion_0;
    let p_w_spindle_frame_in_right_arm_frame_3_2_of_place_0 = sin_q_right_ball_0
        * p_w_right_arm_frame_in_right_link_frame_1_2_of_place_0;
    let p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_2_0 = p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_0
        + p_w_spindle_frame_in_right_arm_frame_3_2_of_place_0;
    let p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_0 = p_w_right_arm_frame_in_right_link_frame_1_of_place_0
        * w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_0;
    let p_w_spindle_frame_in_right_arm_frame_1_2_of_place_0 = cos_q_right_ball_0
        * p_w_right_arm_frame_in_right_link_frame_1_2_of_place_0;
    let p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_2_0 = v_right_link_centre_2_2_of_place_0
        .mul_add(weight_4, weight_3 * w_spindle_frame_in_right_arm_frame_1_2_of_motion_0)
        - p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_0
        + p_w_spindle_frame_in_right_arm_frame_1_2_of_place_0;
    let p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_0 = p_w_left_arm_frame_in_left_link_frame_1_of_place_0
        * w_left_arm_frame_in_left_link_frame_1_2_of_motion_0;
    let p_w_spindle_frame_in_left_arm_frame_3_2_of_place_0 = sin_q_left_ball_0
        * p_w_left_arm_frame_in_left_link_frame_1_2_of_place_0;
    let p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_2_0 = p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_0
        + p_w_spindle_frame_in_left_arm_frame_3_2_of_place_0;
    let p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_0 = p_w_left_arm_frame_in_left_link_frame_1_of_place_0
        * w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_0;
    let p_w_spindle_frame_in_left_arm_frame_1_2_of_place_0 = cos_q_left_ball_0
        * p_w_left_arm_frame_in_left_link_frame_1_2_of_place_0;
    let p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2_0 = v_left_link_centre_2_2_of_place_0
        .mul_add(weight_4, weight_3 * w_spindle_frame_in_left_arm_frame_1_2_of_motion_0)
        - p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_0
        + p_w_spindle_frame_in_left_arm_frame_1_2_of_place_0;
    let w_left_link_frame_2_of_motion_0 = theta_dot_0 + q_left_ball_dot_0;
    let x_N_3_of_place_0 = cos_q_left_ball_0.mul_add(l_m, weight_5);
    let v_left_arm_frame_in_left_link_frame_1_of_theta_dot_0 = theta_dot_0 * cos_q_left_ball_0;
    let v_left_arm_frame_in_left_link_frame_3_of_theta_dot_0 = theta_dot_0 * sin_q_left_ball_0;
    let v_left_link_centre_1_of_place_0 = v_left_arm_frame_in_left_link_frame_1_of_theta_dot_0
        .mul_add(weight, l * w_left_link_frame_2_of_motion_0);
    let v_left_arm_frame_in_left_link_frame_1_2_of_motion_0 = theta_dot_0
        * w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_0;
    let v_left_arm_frame_in_left_link_frame_3_2_of_motion_0 = theta_dot_0
        * w_left_arm_frame_in_left_link_frame_1_2_of_motion_0;
    let theta_plus_q_left_ball_0 = theta_0 + q_left_ball_0;
    let (sin_theta_plus_q_left_ball_0, cos_theta_plus_q_left_ball_0) = theta_plus_q_left_ball_0
        .sin_cos();
    let over_cos_theta_plus_q_left_ball = S::int(1) / cos_theta_plus_q_left_ball_0;
    let theta_dot_sq_0 = theta_dot_0 * theta_dot_0;
    let theta_dot_sq_cos_theta_0 = cos_theta_0 * theta_dot_sq_0;
    let v_sleeve_centre_3_of_motion_0 = w_left_link_frame_2_of_motion_0
        * w_left_link_frame_2_of_motion_0;
    let v_sleeve_centre_3_of_motion_2_0 = cos_theta_plus_q_left_ball_0
        * v_sleeve_centre_3_of_motion_0;
    let v_sleeve_centre_3_of_motion_3_0 = theta_dot_sq_cos_theta_0
        + v_sleeve_centre_3_of_motion_2_0;
    let x_N_3_2_of_place_0 = cos_q_right_ball_0.mul_add(l_m, weight_5);
    let v_right_arm_frame_in_right_link_frame_1_of_motion_0 = q_right_top_dot_0
        * cos_q_right_ball_0;
    let v_right_arm_frame_in_right_link_frame_3_of_motion_0 = q_right_top_dot_0
        * sin_q_right_ball_0;
    let v_right_link_centre_1_of_place_0 = v_right_arm_frame_in_right_link_frame_1_of_motion_0
        .mul_add(weight, q_right_ball_dot_0.mul_add(l, l * q_right_top_dot_0));
    let v_right_arm_frame_in_right_link_frame_1_2_of_motion_0 = q_right_top_dot_0
        * w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_0;
    let v_right_arm_frame_in_right_link_frame_3_2_of_motion_0 = q_right_top_dot_0
        * w_right_arm_frame_in_right_link_frame_1_2_of_motion_0;
    let w_left_arm_frame_in_left_link_frame_1_3_of_place_0 = cos_theta_0 * sin_q_left_ball_0;
    let w_left_arm_frame_in_left_link_frame_1_3_of_place_2_0 = sin_theta_0 * cos_q_left_ball_0;
    let w_left_arm_frame_in_left_link_frame_1_3_of_place_3_0 = w_left_arm_frame_in_left_link_frame_1_3_of_place_0
        + w_left_arm_frame_in_left_link_frame_1_3_of_place_2_0;
    let w_right_arm_frame_in_right_link_frame_1_3_of_place_0 = cos_q_right_top_0
        * sin_q_right_ball_0;
    let w_right_arm_frame_in_right_link_frame_1_3_of_place_2_0 = sin_q_right_top_0
        * cos_q_right_ball_0;
    let w_right_arm_frame_in_right_link_frame_1_3_of_place_3_0 = w_right_arm_frame_in_right_link_frame_1_3_of_place_0
        + w_right_arm_frame_in_right_link_frame_1_3_of_place_2_0;
    let v_left_link_centre_2_3_of_place_0 = w_left_arm_frame_in_left_link_frame_1_3_of_place_3_0
        .mul_add(l, weight * sin_theta_0);
    let v_right_link_centre_2_3_of_place_0 = w_right_arm_frame_in_right_link_frame_1_3_of_place_3_0
        .mul_add(l, weight * sin_q_right_top_0);
    let p_w_right_arm_frame_in_right_link_frame_1_3_of_place_0 = v_right_link_centre_2_3_of_place_0
        .mul_add(
            weight_2,
            l_2_m * w_right_arm_frame_in_right_link_frame_1_3_of_place_3_0,
        );
    let p_w_left_arm_frame_in_left_link_frame_1_3_of_place_0 = v_left_link_centre_2_3_of_place_0
        .mul_add(weight_2, l_2_m * w_left_arm_frame_in_left_link_frame_1_3_of_place_3_0);
    let p_w_spindle_frame_in_right_arm_frame_3_3_of_place_0 = sin_q_right_ball_0
        * p_w_right_arm_frame_in_right_link_frame_1_3_of_place_0;
    let p_w_spindle_frame_in_right_arm_frame_1_3_of_place_0 = cos_q_right_ball_0
        * p_w_right_arm_frame_in_right_link_frame_1_3_of_place_0;
    let p_w_spindle_frame_in_right_arm_frame_1_3_of_place_2_0 = v_right_link_centre_2_3_of_place_0
        .mul_add(weight_4, weight_3 * sin_q_right_top_0)
        + p_w_spindle_frame_in_right_arm_frame_1_3_of_place_0;
    let p_w_spindle_frame_in_left_arm_frame_3_3_of_place_0 = sin_q_left_ball_0
        * p_w_left_arm_frame_in_left_link_frame_1_3_of_place_0;
    let p_w_spindle_frame_in_left_arm_frame_1_3_of_place_0 = cos_q_left_ball_0
        * p_w_left_arm_frame_in_left_link_frame_1_3_of_place_0;
    let p_w_spindle_frame_in_left_arm_frame_1_3_of_place_2_0 = v_left_link_centre_2_3_of_place_0
        .mul_add(weight_4, weight_3 * sin_theta_0)
        + p_w_spindle_frame_in_left_arm_frame_1_3_of_place_0;
    let v_left_link_centre_1_2_of_place_0 = cos_q_left_ball_0.mul_add(weight, l);
    let v_sleeve_centre_3_2_of_place_0 = sin_theta_0 + sin_theta_plus_q_left_ball_0;
    let v_right_link_centre_1_2_of_place_0 = cos_q_right_ball_0.mul_add(weight, l);
    let d1_of_place_0 = cos_q_right_top_0 * p_w_spindle_frame_in_right_arm_frame_3_3_of_place_0;
    let d1_of_place_2_0 = sin_q_right_top_0 * p_w_spindle_frame_in_right_arm_frame_1_3_of_place_2_0;
    let d1_of_place_3_0 = cos_theta_0 * p_w_spindle_frame_in_left_arm_frame_3_3_of_place_0;
    let d1_of_place_4_0 = sin_theta_0 * p_w_spindle_frame_in_left_arm_frame_1_3_of_place_2_0;
    let d1_of_place_5_0 = d1_of_place_4_0
        .mul_add(
            S::ratio(1, 12),
            d1_of_place_2_0
                .mul_add(
                    S::ratio(1, 12),
                    d1_of_place_3_0
                        .mul_add(
                            S::ratio(1, 12),
                            d1_of_place_0.mul_add(S::ratio(1, 12), j_plus_js),
                        ),
                ),
        );
    let over_d1_of_place_5 = S::int(1) / d1_of_place_5_0;
    let d2_of_place_0 = q_right_top_0 + q_right_ball_0;
    let (sin_angle_0, cos_angle_0) = d2_of_place_0.sin_cos();
    let d2_of_place_2_0 = sin_theta_0 * sin_q_left_ball_0;
    let d2_of_place_3_0 = cos_theta_0 + cos_theta_plus_q_left_ball_0;
    let d2_of_q_right_ball_0 = S::int(1) + cos_q_right_ball_0;
    let d2_of_place_4_0 = cos_q_right_top_0 * d2_of_q_right_ball_0;
    let d2_of_place_5_0 = sin_q_right_top_0 * sin_q_right_ball_0;
    let d2_of_place_6_0 = -d2_of_place_5_0 + d2_of_place_4_0;
    let d2_of_place_7_0 = cos_theta_0 * cos_q_left_ball_0;
    let d2_of_place_8_0 = d2_of_place_2_0 - d2_of_place_7_0;
    let over_d2_of_place_8 = S::int(1) / d2_of_place_8_0;
    let d2_of_place_9_0 = v_sleeve_centre_3_2_of_place_0 * v_sleeve_centre_3_2_of_place_0;
    let sin_q_left_ball_sq_0 = sin_q_left_ball_0 * sin_q_left_ball_0;
    let d2_of_place_10_0 = cos_q_left_ball_0 * v_left_link_centre_1_2_of_place_0;
    let d2_of_place_11_0 = v_sleeve_centre_3_2_of_place_0 * sin_theta_plus_q_left_ball_0;
    let sin_q_right_ball_sq_0 = sin_q_right_ball_0 * sin_q_right_ball_0;
    let d2_of_place_12_0 = cos_q_right_ball_0 * v_right_link_centre_1_2_of_place_0;
    let d2_of_place_13_0 = d2_of_place_11_0
        .mul_add(weight_7, cos_q_left_ball_0.mul_add(weight_8, weight_6));
    let d2_of_place_14_0 = d2_of_place_3_0 * over_cos_theta_plus_q_left_ball;
    let d2_of_place_15_0 = d2_of_place_13_0 * d2_of_place_14_0;
    let d2_of_place_16_0 = d2_of_place_12_0
        .mul_add(
            weight_4,
            sin_q_right_ball_sq_0
                .mul_add(
                    weight_10,
                    v_right_link_centre_1_2_of_place_0.mul_add(weight_2, weight_9),
                ),
        );
    let d2_of_place_17_0 = cos_theta_plus_q_left_ball_0 * sin_q_right_ball_0;
    let over_d2_of_place_17 = S::int(1) / d2_of_place_17_0;
    let d2_of_place_18_0 = sin_q_left_ball_0 * over_d2_of_place_17;
    let d2_of_place_19_0 = cos_angle_0 * d2_of_place_18_0;
    let d2_of_place_20_0 = d2_of_place_16_0 * d2_of_place_19_0;
    let d2_of_place_21_0 = cos_q_right_ball_0.mul_add(weight_8, weight_6);
    let d2_of_place_22_0 = d2_of_place_6_0 * d2_of_place_18_0;
    let d2_of_place_23_0 = d2_of_place_21_0 * d2_of_place_22_0;
    let d2_of_place_24_0 = w_left_arm_frame_in_left_link_frame_1_3_of_place_2_0
        .mul_add(l_m, weight_11 * sin_theta_plus_q_left_ball_0);
    let d2_of_place_25_0 = sin_q_left_ball_0 * d2_of_place_24_0;
    let d2_of_place_26_0 = cos_q_left_ball_0 * d2_of_place_7_0;
    let d2_of_place_27_0 = d2_of_place_25_0
        .mul_add(
            weight_12,
            d2_of_place_26_0.mul_add(minus_6_l_2_m, weight_6 * cos_theta_0),
        );
    let d2_of_place_28_0 = cos_angle_0 * cos_q_right_ball_0;
    let d2_of_place_29_0 = d2_of_place_28_0
        .mul_add(
            weight_8,
            d2_of_place_4_0.mul_add(minus_4_l_2_m, weight_6 * cos_angle_0),
        );
    let d2_of_place_30_0 = d2_of_place_29_0 * over_sin_q_right_ball;
    let d2_of_place_31_0 = weight_6 * sin_q_right_top_0 + d2_of_place_30_0;
    let d2_of_place_32_0 = d2_of_place_20_0 - d2_of_place_23_0;
    let d2_of_place_33_0 = d2_of_place_32_0 * d2_of_place_19_0;
    let d2_of_place_34_0 = d2_of_place_27_0 * over_d2_of_place_8;
    let d2_of_place_35_0 = d2_of_place_14_0 * d2_of_place_34_0;
    let d2_of_place_36_0 = sin_q_left_ball_0 * over_cos_theta_plus_q_left_ball;
    let d2_of_place_37_0 = d2_of_place_31_0 * d2_of_place_36_0;
    let d2_of_place_38_0 = d2_of_place_22_0 * d2_of_place_37_0;
    let d2_of_place_39_0 = d2_of_place_33_0
        .mul_add(
            S::ratio(1, 12),
            d2_of_place_38_0
                .mul_add(
                    -S::ratio(1, 12),
                    d2_of_place_35_0
                        .mul_add(
                            -S::ratio(1, 12),
                            d2_of_place_15_0
                                .mul_add(
                                    -S::ratio(1, 12),
                                    d2_of_place_9_0
                                        .mul_add(
                                            l_2_ms,
                                            d2_of_place_10_0
                                                .mul_add(
                                                    l_m_by_2,
                                                    sin_q_left_ball_sq_0
                                                        .mul_add(
                                                            l_2_m,
                                                            v_left_link_centre_1_2_of_place_0
                                                                .mul_add(l_m_by_4, weight_13),
                                                        ),
                                                ),
                                        ),
                                ),
                        ),
                ),
        );
    let over_d2_of_place_39 = S::int(1) / d2_of_place_39_0;
    let opening_dot_of_place_0 = sin_q_right_top_0 * d2_of_q_right_ball_0;
    let opening_dot_of_place_2_0 = d2_of_q_right_ball_0 * d2_of_place_7_0;
    let opening_dot_of_q_right_ball_0 = d2_of_q_right_ball_0 * over_sin_q_right_ball;
    let opening_dot_of_place_3_0 = cos_q_right_top_0 * opening_dot_of_q_right_ball_0;
    let opening_dot_of_place_4_0 = sin_q_right_top_0 - opening_dot_of_place_3_0;
    let opening_dot_of_place_5_0 = cos_angle_0 * opening_dot_of_q_right_ball_0;
    let opening_dot_of_place_6_0 = sin_angle_0 + opening_dot_of_place_5_0;
    let opening_dot_of_place_7_0 = cos_q_right_ball_0 * opening_dot_of_place_6_0;
    let opening_dot_of_place_8_0 = sin_angle_0 + opening_dot_of_place_7_0;
    let opening_dot_of_place_9_0 = cos_q_right_top_0 * opening_dot_of_place_8_0;
    let opening_dot_of_place_10_0 = sin_angle_0
        + w_right_arm_frame_in_right_link_frame_1_3_of_place_2_0;
    let opening_dot_of_place_11_0 = cos_angle_0 * opening_dot_of_place_10_0;
    let opening_dot_of_place_12_0 = -opening_dot_of_place_11_0 + opening_dot_of_place_9_0;
    let opening_dot_of_place_13_0 = opening_dot_of_place_12_0 * over_sin_q_right_ball;
    let opening_dot_of_place_14_0 = sin_q_right_top_0 * sin_angle_0;
    let opening_dot_of_place_15_0 = -opening_dot_of_place_14_0 + opening_dot_of_place_13_0;
    let opening_dot_of_place_16_0 = sin_q_left_ball_0 * opening_dot_of_place_15_0;
    let opening_dot_of_place_17_0 = sin_theta_plus_q_left_ball_0 * over_cos_theta_plus_q_left_ball;
    let opening_dot_of_place_18_0 = cos_theta_0 * opening_dot_of_place_17_0;
    let opening_dot_of_place_19_0 = cos_angle_0 * opening_dot_of_place_18_0;
    let opening_dot_of_place_20_0 = -opening_dot_of_place_19_0 + opening_dot_of_place_16_0;
    let opening_dot_of_place_21_0 = sin_q_left_ball_0 * opening_dot_of_place_20_0;
    let opening_dot_of_place_22_0 = cos_angle_0 * d2_of_place_7_0;
    let opening_dot_of_place_23_0 = -opening_dot_of_place_22_0 + opening_dot_of_place_21_0;
    let opening_dot_of_place_24_0 = opening_dot_of_place_23_0 * over_cos_theta_plus_q_left_ball;
    let opening_dot_of_place_25_0 = cos_q_left_ball_0 * cos_angle_0;
    let opening_dot_of_place_26_0 = -opening_dot_of_place_25_0 + opening_dot_of_place_24_0;
    let opening_dot_of_place_27_0 = cos_theta_0 * over_cos_theta_plus_q_left_ball;
    let opening_dot_of_place_28_0 = opening_dot_of_place_18_0 * opening_dot_of_place_27_0;
    let opening_dot_of_place_29_0 = sin_theta_0 + opening_dot_of_place_28_0;
    let opening_dot_of_place_30_0 = opening_dot_of_place_3_0
        .mul_add(-S::int(2), opening_dot_of_place_0);
    let opening_dot_of_place_31_0 = opening_dot_of_place_30_0 * over_sin_q_right_ball;
    let opening_dot_of_place_32_0 = cos_q_right_top_0 + cos_angle_0 + opening_dot_of_place_31_0;
    let opening_dot_of_place_33_0 = sin_q_left_ball_0 * opening_dot_of_place_32_0;
    let opening_dot_of_place_34_0 = d2_of_q_right_ball_0 * opening_dot_of_place_18_0;
    let opening_dot_of_place_35_0 = opening_dot_of_place_34_0 + opening_dot_of_place_33_0;
    let opening_dot_of_place_36_0 = sin_q_left_ball_0 * opening_dot_of_place_35_0;
    let opening_dot_of_place_37_0 = opening_dot_of_place_2_0 + opening_dot_of_place_36_0;
    let opening_dot_of_place_38_0 = cos_q_right_top_0 * opening_dot_of_place_37_0;
    let sin_q_left_ball_sq_2_0 = sin_q_left_ball_0 * sin_q_left_ball_0;
    let opening_dot_of_place_39_0 = sin_q_right_top_0 * sin_q_left_ball_sq_2_0;
    let opening_dot_of_place_40_0 = opening_dot_of_place_5_0 * opening_dot_of_place_39_0;
    let opening_dot_of_place_41_0 = opening_dot_of_place_40_0 + opening_dot_of_place_38_0;
    let opening_dot_of_place_42_0 = opening_dot_of_place_41_0 * over_sin_q_right_ball;
    let opening_dot_of_place_43_0 = sin_q_left_ball_0 * opening_dot_of_place_17_0;
    let opening_dot_of_place_44_0 = cos_q_left_ball_0 + opening_dot_of_place_43_0;
    let opening_dot_of_place_45_0 = cos_theta_0 * sin_q_right_top_0;
    let opening_dot_of_place_46_0 = opening_dot_of_place_44_0 * opening_dot_of_place_45_0;
    let opening_dot_of_place_47_0 = -opening_dot_of_place_46_0 + opening_dot_of_place_42_0;
    let opening_dot_of_place_48_0 = opening_dot_of_place_47_0 * over_cos_theta_plus_q_left_ball;
    let opening_dot_of_place_49_0 = cos_q_left_ball_0 * opening_dot_of_place_4_0;
    let opening_dot_of_place_50_0 = -opening_dot_of_place_49_0 + opening_dot_of_place_48_0;
    let opening_dot_of_place_51_0 = sin_theta_0 * p_w_spindle_frame_in_left_arm_frame_3_of_place_0;
    let opening_dot_of_place_52_0 = cos_theta_0
        * p_w_spindle_frame_in_left_arm_frame_1_of_place_2_0;
    let opening_dot_of_place_53_0 = opening_dot_of_place_51_0 - opening_dot_of_place_52_0;
    let opening_dot_of_place_54_0 = sin_q_right_top_0
        * p_w_spindle_frame_in_right_arm_frame_3_of_place_0;
    let opening_dot_of_place_55_0 = cos_q_right_top_0
        * p_w_spindle_frame_in_right_arm_frame_1_of_place_2_0;
    let opening_dot_of_place_56_0 = opening_dot_of_place_54_0 - opening_dot_of_place_55_0;
    let opening_dot_of_place_57_0 = sin_theta_0 * x_N_3_of_place_0;
    let opening_dot_of_place_58_0 = cos_theta_0 * sin_q_left_ball_0;
    let opening_dot_of_place_59_0 = sin_q_left_ball_0 * v_left_link_centre_1_of_place_0;
    let opening_dot_of_theta_dot_0 = cos_q_left_ball_0
        * v_left_arm_frame_in_left_link_frame_3_of_theta_dot_0;
    let opening_dot_of_place_60_0 = opening_dot_of_place_59_0
        .mul_add(m, minus_2_l_m * opening_dot_of_theta_dot_0);
    let opening_dot_of_motion_0 = q_left_ball_dot_0 * opening_dot_of_place_60_0;
    let opening_dot_of_motion_2_0 = v_sleeve_centre_3_2_of_place_0
        * v_sleeve_centre_3_of_motion_3_0;
    let opening_dot_of_motion_3_0 = sin_q_left_ball_0
        * v_left_arm_frame_in_left_link_frame_3_2_of_motion_0;
    let opening_dot_of_motion_4_0 = cos_q_left_ball_0
        * v_left_arm_frame_in_left_link_frame_1_2_of_motion_0;
    let opening_dot_of_psi_dot_0 = psi_dot_0 * opening_dot_of_place_53_0;
    let opening_dot_of_place_61_0 = sin_q_right_top_0 * x_N_3_2_of_place_0;
    let opening_dot_of_place_62_0 = cos_q_right_top_0 * sin_q_right_ball_0;
    let opening_dot_of_place_63_0 = sin_q_right_ball_0 * v_right_link_centre_1_of_place_0;
    let opening_dot_of_motion_5_0 = cos_q_right_ball_0
        * v_right_arm_frame_in_right_link_frame_3_of_motion_0;
    let opening_dot_of_place_64_0 = opening_dot_of_place_63_0
        .mul_add(m, minus_2_l_m * opening_dot_of_motion_5_0);
    let opening_dot_of_motion_6_0 = q_right_ball_dot_0 * opening_dot_of_place_64_0;
    let opening_dot_of_motion_7_0 = sin_q_right_ball_0
        * v_right_arm_frame_in_right_link_frame_3_2_of_motion_0;
    let opening_dot_of_motion_8_0 = cos_q_right_ball_0
        * v_right_arm_frame_in_right_link_frame_1_2_of_motion_0;
    let opening_dot_of_psi_dot_2_0 = psi_dot_0 * opening_dot_of_place_56_0;
    let opening_dot_of_theta_dot_2_0 = theta_dot_0 * opening_dot_of_place_60_0;
    let opening_dot_of_place_65_0 = v_sleeve_centre_3_of_motion_3_0.mul_add(l_ms, ms_g);
    let opening_dot_of_place_66_0 = sin_theta_plus_q_left_ball_0 * opening_dot_of_place_65_0;
    let opening_dot_of_psi_dot_3_0 = psi_dot_sin_theta_0
        * p_w_left_arm_frame_in_left_link_frame_1_of_place_0;
    let opening_dot_of_place_67_0 = weight_14 * cos_theta_0 + opening_dot_of_psi_dot_3_0;
    let opening_dot_of_place_68_0 = sin_q_left_ball_0 * opening_dot_of_place_67_0;
    let opening_dot_of_psi_dot_4_0 = psi_dot_cos_theta_0
        * p_w_left_arm_frame_in_left_link_frame_1_of_place_0;
    let opening_dot_of_place_69_0 = minus_6_l_m_g * sin_theta_0 + opening_dot_of_psi_dot_4_0;
    let opening_dot_of_place_70_0 = cos_q_left_ball_0 * opening_dot_of_place_69_0;
    let opening_dot_of_motion_9_0 = q_right_top_dot_0 * v_right_link_centre_1_of_place_0;
    let opening_dot_of_psi_dot_5_0 = psi_dot_sin_q_right_top_0
        * p_w_right_arm_frame_in_right_link_frame_1_of_place_0;
    let opening_dot_of_motion_10_0 = opening_dot_of_motion_9_0
        .mul_add(weight_4, weight_14 * cos_q_right_top_0) + opening_dot_of_psi_dot_5_0;
    let opening_dot_of_motion_11_0 = sin_q_right_ball_0 * opening_dot_of_motion_10_0;
    let opening_dot_of_motion_12_0 = q_right_top_dot_0
        * v_right_arm_frame_in_right_link_frame_3_of_motion_0;
    let opening_dot_of_psi_dot_6_0 = psi_dot_cos_q_right_top_0
        * p_w_right_arm_frame_in_right_link_frame_1_of_place_0;
    let opening_dot_of_motion_13_0 = opening_dot_of_motion_12_0
        .mul_add(weight_10, minus_6_l_m_g * sin_q_right_top_0) + opening_dot_of_psi_dot_6_0;
    let opening_dot_of_motion_14_0 = cos_q_right_ball_0 * opening_dot_of_motion_13_0;
    let opening_dot_of_motion_15_0 = opening_dot_of_motion_6_0
        .mul_add(
            weight_12,
            opening_dot_of_motion_8_0
                .mul_add(
                    weight_10,
                    opening_dot_of_motion_7_0
                        .mul_add(
                            minus_12_l_2_m,
                            v_right_arm_frame_in_right_link_frame_1_2_of_motion_0
                                .mul_add(
                                    weight_8,
                                    opening_dot_of_place_61_0
                                        .mul_add(
                                            minus_6_g,
                                            minus_6_l_m_g * opening_dot_of_place_62_0,
                                        ),
                                ),
                        ),
                ),
        ) - opening_dot_of_psi_dot_2_0;
    let opening_dot_of_motion_16_0 = opening_dot_of_motion_15_0 * d2_of_place_19_0;
    let opening_dot_of_theta_dot_3_0 = opening_dot_of_theta_dot_2_0
        .mul_add(
            minus_6_l,
            opening_dot_of_place_66_0
                .mul_add(
                    minus_12_l,
                    weight_8 * v_left_arm_frame_in_left_link_frame_1_2_of_motion_0,
                ),
        ) + opening_dot_of_place_70_0 - opening_dot_of_place_68_0;
    let opening_dot_of_theta_dot_4_0 = opening_dot_of_theta_dot_3_0 * d2_of_place_14_0;
    let opening_dot_of_motion_17_0 = weight_8
        * v_right_arm_frame_in_right_link_frame_1_2_of_motion_0
        + opening_dot_of_motion_14_0 - opening_dot_of_motion_11_0;
    let opening_dot_of_motion_18_0 = opening_dot_of_motion_17_0 * d2_of_place_22_0;
    let opening_dot_of_place_71_0 = opening_dot_of_place_26_0 * over_d2_of_place_17;
    let opening_dot_of_theta_dot_5_0 = theta_dot_sq_0 * opening_dot_of_place_71_0;
    let opening_dot_of_theta_dot_6_0 = d2_of_place_32_0 * opening_dot_of_theta_dot_5_0;
    let opening_dot_of_theta_dot_7_0 = theta_dot_sq_0 * over_cos_theta_plus_q_left_ball;
    let opening_dot_of_theta_dot_8_0 = opening_dot_of_place_29_0 * opening_dot_of_theta_dot_7_0;
    let opening_dot_of_theta_dot_9_0 = opening_dot_of_theta_dot_8_0 * d2_of_place_34_0;
    let opening_dot_of_theta_dot_10_0 = opening_dot_of_place_50_0 * opening_dot_of_theta_dot_7_0;
    let opening_dot_of_theta_dot_11_0 = opening_dot_of_theta_dot_10_0 * d2_of_place_37_0;
    let opening_dot_of_motion_19_0 = opening_dot_of_motion_0
        .mul_add(
            weight_12,
            opening_dot_of_motion_4_0
                .mul_add(
                    weight_10,
                    opening_dot_of_motion_3_0
                        .mul_add(
                            minus_12_l_2_m,
                            opening_dot_of_motion_2_0
                                .mul_add(
                                    minus_12_l_2_ms,
                                    v_left_arm_frame_in_left_link_frame_1_2_of_motion_0
                                        .mul_add(
                                            weight_8,
                                            opening_dot_of_place_57_0
                                                .mul_add(
                                                    minus_6_g,
                                                    v_sleeve_centre_3_2_of_place_0
                                                        .mul_add(
                                                            minus_12_l_ms_g,
                                                            minus_6_l_m_g * opening_dot_of_place_58_0,
                                                        ),
                                                ),
                                        ),
                                ),
                        ),
                ),
        ) - opening_dot_of_theta_dot_9_0 - opening_dot_of_psi_dot_0
        - opening_dot_of_theta_dot_4_0 - opening_dot_of_motion_18_0
        + opening_dot_of_motion_16_0 - opening_dot_of_theta_dot_11_0 - opening_dot_of_theta_dot_6_0;
    let opening_dot_of_motion_20_0 = opening_dot_of_motion_19_0 * over_d2_of_place_39;
    let spin_dot_of_motion_0 = cos_q_right_top_0
        * p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_2_0;
    let spin_dot_of_motion_2_0 = sin_q_right_top_0
        * p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_2_0;
    let spin_dot_of_motion_3_0 = cos_theta_0
        * p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_2_0;
    let spin_dot_of_motion_4_0 = sin_theta_0
        * p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2_0;
    let spin_dot_of_theta_dot_0 = theta_dot_0 * opening_dot_of_place_53_0;
    let spin_dot_of_motion_5_0 = q_right_top_dot_0 * opening_dot_of_place_56_0;
    let spin_dot_of_motion_6_0 = spin_dot_of_motion_0 + spin_dot_of_motion_2_0
        + spin_dot_of_motion_3_0 + spin_dot_of_motion_4_0 - spin_dot_of_theta_dot_0
        - spin_dot_of_motion_5_0;
    let spin_dot_of_motion_7_0 = spin_dot_of_motion_6_0 * over_d1_of_place_5;
    let q_right_top_ddot_of_motion_0 = opening_dot_of_motion_20_0 * d2_of_place_19_0;
    let q_right_top_dot_dot_0 = q_right_top_ddot_of_motion_0
        .mul_add(S::ratio(1, 12), opening_dot_of_theta_dot_5_0);
    let q_left_ball_ddot_of_motion_0 = opening_dot_of_motion_20_0 * d2_of_place_14_0;
    let q_left_ball_dot_dot_0 = q_left_ball_ddot_of_motion_0
        .mul_add(-S::ratio(1, 12), opening_dot_of_theta_dot_8_0);
    let q_right_ball_ddot_of_motion_0 = opening_dot_of_motion_20_0 * d2_of_place_22_0;
    let q_right_ball_dot_dot_0 = q_right_ball_ddot_of_motion_0
        .mul_add(-S::ratio(1, 12), opening_dot_of_theta_dot_10_0);
    // Order 1: the rates, and what follows from them.
    let psi_1 = psi_dot_0;
    let theta_1 = theta_dot_0;
    let q_right_top_1 = q_right_top_dot_0;
    let q_left_ball_1 = q_left_ball_dot_0;
    let q_right_ball_1 = q_right_ball_dot_0;
    let psi_dot_1 = -S::ratio(1, 12) * spin_dot_of_motion_7_0;
    let theta_dot_1 = S::ratio(1, 12) * opening_dot_of_motion_20_0;
    let q_right_top_dot_1 = q_right_top_dot_dot_0;
    let q_left_ball_dot_1 = q_left_ball_dot_dot_0;
    let q_right_ball_dot_1 = q_right_ball_dot_dot_0;
    if series.len() > 1 {
        series[1] = [
            psi_1, theta_1, q_right_top_1, q_left_ball_1, q_right_ball_1, psi_dot_1, theta_dot_1,
            q_right_top_dot_1, q_left_ball_dot_1, q_right_ball_dot_1,
        ];
    }
    let sin_theta_1 = theta_1 * cos_theta_0;
    let cos_theta_1 = -theta_1 * sin_theta_0;
    let psi_dot_sin_theta_1 = sin_theta_1.mul_add(psi_dot_0, psi_dot_1 * sin_theta_0);
    let psi_dot_cos_theta_1 = cos_theta_1.mul_add(psi_dot_0, psi_dot_1 * cos_theta_0);
    let sin_q_right_top_1 = q_right_top_1 * cos_q_right_top_0;
    let cos_q_right_top_1 = -q_right_top_1 * sin_q_right_top_0;
    let psi_dot_sin_q_right_top_1 = sin_q_right_top_1
        .mul_add(psi_dot_0, psi_dot_1 * sin_q_right_top_0);
    let psi_dot_cos_q_right_top_1 = cos_q_right_top_1
        .mul_add(psi_dot_0, psi_dot_1 * cos_q_right_top_0);
    let sin_q_left_ball_1 = q_left_ball_1 * cos_q_left_ball_0;
    let cos_q_left_ball_1 = -q_left_ball_1 * sin_q_left_ball_0;
    let w_left_arm_frame_in_left_link_frame_1_of_psi_dot_1 = psi_dot_cos_theta_1
        .mul_add(sin_q_left_ball_0, sin_q_left_ball_1 * psi_dot_cos_theta_0);
    let w_left_arm_frame_in_left_link_frame_1_of_psi_dot_2_1 = psi_dot_sin_theta_1
        .mul_add(cos_q_left_ball_0, cos_q_left_ball_1 * psi_dot_sin_theta_0);
    let w_left_arm_frame_in_left_link_frame_1_of_place_1 = w_left_arm_frame_in_left_link_frame_1_of_psi_dot_1
        + w_left_arm_frame_in_left_link_frame_1_of_psi_dot_2_1;
    let sin_q_right_ball_1 = q_right_ball_1 * cos_q_right_ball_0;
    let cos_q_right_ball_1 = -q_right_ball_1 * sin_q_right_ball_0;
    let w_right_arm_frame_in_right_link_frame_1_of_psi_dot_1 = psi_dot_cos_q_right_top_1
        .mul_add(sin_q_right_ball_0, sin_q_right_ball_1 * psi_dot_cos_q_right_top_0);
    let w_right_arm_frame_in_right_link_frame_1_of_psi_dot_2_1 = psi_dot_sin_q_right_top_1
        .mul_add(cos_q_right_ball_0, cos_q_right_ball_1 * psi_dot_sin_q_right_top_0);
    let w_right_arm_frame_in_right_link_frame_1_of_place_1 = w_right_arm_frame_in_right_link_frame_1_of_psi_dot_1
        + w_right_arm_frame_in_right_link_frame_1_of_psi_dot_2_1;
    let v_left_link_centre_2_of_place_1 = w_left_arm_frame_in_left_link_frame_1_of_place_1
        .mul_add(l, weight * psi_dot_sin_theta_1);
    let v_right_link_centre_2_of_place_1 = w_right_arm_frame_in_right_link_frame_1_of_place_1
        .mul_add(l, weight * psi_dot_sin_q_right_top_1);
    let p_w_right_arm_frame_in_right_link_frame_1_of_place_1 = v_right_link_centre_2_of_place_1
        .mul_add(weight_2, l_2_m * w_right_arm_frame_in_right_link_frame_1_of_place_1);
    let p_w_left_arm_frame_in_left_link_frame_1_of_place_1 = v_left_link_centre_2_of_place_1
        .mul_add(weight_2, l_2_m * w_left_arm_frame_in_left_link_frame_1_of_place_1);
    let p_w_spindle_frame_in_right_arm_frame_3_of_place_1 = p_w_right_arm_frame_in_right_link_frame_1_of_place_1
        .mul_add(
            sin_q_right_ball_0,
            sin_q_right_ball_1 * p_w_right_arm_frame_in_right_link_frame_1_of_place_0,
        );
    let p_w_spindle_frame_in_right_arm_frame_1_of_place_1 = p_w_right_arm_frame_in_right_link_frame_1_of_place_1
        .mul_add(
            cos_q_right_ball_0,
            cos_q_right_ball_1 * p_w_right_arm_frame_in_right_link_frame_1_of_place_0,
        );
    let p_w_spindle_frame_in_right_arm_frame_1_of_place_2_1 = v_right_link_centre_2_of_place_1
        .mul_add(weight_4, weight_3 * psi_dot_sin_q_right_top_1)
        + p_w_spindle_frame_in_right_arm_frame_1_of_place_1;
    let p_w_spindle_frame_in_left_arm_frame_3_of_place_1 = p_w_left_arm_frame_in_left_link_frame_1_of_place_1
        .mul_add(
            sin_q_left_ball_0,
            sin_q_left_ball_1 * p_w_left_arm_frame_in_left_link_frame_1_of_place_0,
        );
    let p_w_spindle_frame_in_left_arm_frame_1_of_place_1 = p_w_left_arm_frame_in_left_link_frame_1_of_place_1
        .mul_add(
            cos_q_left_ball_0,
            cos_q_left_ball_1 * p_w_left_arm_frame_in_left_link_frame_1_of_place_0,
        );
    let p_w_spindle_frame_in_left_arm_frame_1_of_place_2_1 = v_left_link_centre_2_of_place_1
        .mul_add(weight_4, weight_3 * psi_dot_sin_theta_1)
        + p_w_spindle_frame_in_left_arm_frame_1_of_place_1;
    let w_spindle_frame_in_left_arm_frame_1_2_of_motion_1 = psi_dot_cos_theta_1
        .mul_add(theta_dot_0, theta_dot_1 * psi_dot_cos_theta_0);
    let w_spindle_frame_in_left_arm_frame_3_2_of_motion_1 = psi_dot_sin_theta_1
        .mul_add(theta_dot_0, theta_dot_1 * psi_dot_sin_theta_0);
    let w_spindle_frame_in_right_arm_frame_1_2_of_motion_1 = psi_dot_cos_q_right_top_1
        .mul_add(q_right_top_dot_0, q_right_top_dot_1 * psi_dot_cos_q_right_top_0);
    let w_spindle_frame_in_right_arm_frame_3_2_of_motion_1 = psi_dot_sin_q_right_top_1
        .mul_add(q_right_top_dot_0, q_right_top_dot_1 * psi_dot_sin_q_right_top_0);
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion_1 = cos_q_left_ball_1
        .mul_add(q_left_ball_dot_0, q_left_ball_dot_1 * cos_q_left_ball_0);
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion_2_1 = w_left_arm_frame_in_left_link_frame_1_2_of_motion_1
        .mul_add(
            psi_dot_cos_theta_0,
            psi_dot_cos_theta_1 * w_left_arm_frame_in_left_link_frame_1_2_of_motion_0,
        );
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion_3_1 = w_spindle_frame_in_left_arm_frame_3_2_of_motion_1
        .mul_add(
            sin_q_left_ball_0,
            sin_q_left_ball_1 * w_spindle_frame_in_left_arm_frame_3_2_of_motion_0,
        );
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_1 = sin_q_left_ball_1
        .mul_add(q_left_ball_dot_0, q_left_ball_dot_1 * sin_q_left_ball_0);
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion_5_1 = w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_1
        .mul_add(
            psi_dot_sin_theta_0,
            psi_dot_sin_theta_1 * w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_0,
        );
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion_6_1 = w_spindle_frame_in_left_arm_frame_1_2_of_motion_1
        .mul_add(
            cos_q_left_ball_0,
            cos_q_left_ball_1 * w_spindle_frame_in_left_arm_frame_1_2_of_motion_0,
        );
    let w_left_arm_frame_in_left_link_frame_1_2_of_motion_7_1 = w_left_arm_frame_in_left_link_frame_1_2_of_motion_2_1
        - w_left_arm_frame_in_left_link_frame_1_2_of_motion_5_1
        + w_left_arm_frame_in_left_link_frame_1_2_of_motion_6_1
        - w_left_arm_frame_in_left_link_frame_1_2_of_motion_3_1;
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion_1 = cos_q_right_ball_1
        .mul_add(q_right_ball_dot_0, q_right_ball_dot_1 * cos_q_right_ball_0);
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion_2_1 = w_right_arm_frame_in_right_link_frame_1_2_of_motion_1
        .mul_add(
            psi_dot_cos_q_right_top_0,
            psi_dot_cos_q_right_top_1 * w_right_arm_frame_in_right_link_frame_1_2_of_motion_0,
        );
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion_3_1 = w_spindle_frame_in_right_arm_frame_3_2_of_motion_1
        .mul_add(
            sin_q_right_ball_0,
            sin_q_right_ball_1 * w_spindle_frame_in_right_arm_frame_3_2_of_motion_0,
        );
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_1 = sin_q_right_ball_1
        .mul_add(q_right_ball_dot_0, q_right_ball_dot_1 * sin_q_right_ball_0);
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion_5_1 = w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_1
        .mul_add(
            psi_dot_sin_q_right_top_0,
            psi_dot_sin_q_right_top_1 * w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_0,
        );
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion_6_1 = w_spindle_frame_in_right_arm_frame_1_2_of_motion_1
        .mul_add(
            cos_q_right_ball_0,
            cos_q_right_ball_1 * w_spindle_frame_in_right_arm_frame_1_2_of_motion_0,
        );
    let w_right_arm_frame_in_right_link_frame_1_2_of_motion_7_1 = w_right_arm_frame_in_right_link_frame_1_2_of_motion_2_1
        - w_right_arm_frame_in_right_link_frame_1_2_of_motion_5_1
        + w_right_arm_frame_in_right_link_frame_1_2_of_motion_6_1
        - w_right_arm_frame_in_right_link_frame_1_2_of_motion_3_1;
    let v_left_link_centre_2_2_of_place_1 = w_left_arm_frame_in_left_link_frame_1_2_of_motion_7_1
        .mul_add(l, weight * w_spindle_frame_in_left_arm_frame_1_2_of_motion_1);
    let v_right_link_centre_2_2_of_place_1 = w_right_arm_frame_in_right_link_frame_1_2_of_motion_7_1
        .mul_add(l, weight * w_spindle_frame_in_right_arm_frame_1_2_of_motion_1);
    let p_w_right_arm_frame_in_right_link_frame_1_2_of_place_1 = v_right_link_centre_2_2_of_place_1
        .mul_add(
            weight_2,
            l_2_m * w_right_arm_frame_in_right_link_frame_1_2_of_motion_7_1,
        );
    let p_w_left_arm_frame_in_left_link_frame_1_2_of_place_1 = v_left_link_centre_2_2_of_place_1
        .mul_add(
            weight_2,
            l_2_m * w_left_arm_frame_in_left_link_frame_1_2_of_motion_7_1,
        );
    let p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_1 = p_w_right_arm_frame_in_right_link_frame_1_of_place_1
        .mul_add(
            w_right_arm_frame_in_right_link_frame_1_2_of_motion_0,
            w_right_arm_frame_in_right_link_frame_1_2_of_motion_1
                * p_w_right_arm_frame_in_right_link_frame_1_of_place_0,
        );
    let p_w_spindle_frame_in_right_arm_frame_3_2_of_place_1 = p_w_right_arm_frame_in_right_link_frame_1_2_of_place_1
        .mul_add(
            sin_q_right_ball_0,
            sin_q_right_ball_1 * p_w_right_arm_frame_in_right_link_frame_1_2_of_place_0,
        );
    let p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_2_1 = p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_1
        + p_w_spindle_frame_in_right_arm_frame_3_2_of_place_1;
    let p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_1 = p_w_right_arm_frame_in_right_link_frame_1_of_place_1
        .mul_add(
            w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_0,
            w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_1
                * p_w_right_arm_frame_in_right_link_frame_1_of_place_0,
        );
    let p_w_spindle_frame_in_right_arm_frame_1_2_of_place_1 = p_w_right_arm_frame_in_right_link_frame_1_2_of_place_1
        .mul_add(
            cos_q_right_ball_0,
            cos_q_right_ball_1 * p_w_right_arm_frame_in_right_link_frame_1_2_of_place_0,
        );
    let p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_2_1 = v_right_link_centre_2_2_of_place_1
        .mul_add(weight_4, weight_3 * w_spindle_frame_in_right_arm_frame_1_2_of_motion_1)
        - p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_1
        + p_w_spindle_frame_in_right_arm_frame_1_2_of_place_1;
    let p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_1 = p_w_left_arm_frame_in_left_link_frame_1_of_place_1
        .mul_add(
            w_left_arm_frame_in_left_link_frame_1_2_of_motion_0,
            w_left_arm_frame_in_left_link_frame_1_2_of_motion_1
                * p_w_left_arm_frame_in_left_link_frame_1_of_place_0,
        );
    let p_w_spindle_frame_in_left_arm_frame_3_2_of_place_1 = p_w_left_arm_frame_in_left_link_frame_1_2_of_place_1
        .mul_add(
            sin_q_left_ball_0,
            sin_q_left_ball_1 * p_w_left_arm_frame_in_left_link_frame_1_2_of_place_0,
        );
    let p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_2_1 = p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_1
        + p_w_spindle_frame_in_left_arm_frame_3_2_of_place_1;
    let p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_1 = p_w_left_arm_frame_in_left_link_frame_1_of_place_1
        .mul_add(
            w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_0,
            w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_1
                * p_w_left_arm_frame_in_left_link_frame_1_of_place_0,
        );
    let p_w_spindle_frame_in_left_arm_frame_1_2_of_place_1 = p_w_left_arm_frame_in_left_link_frame_1_2_of_place_1
        .mul_add(
            cos_q_left_ball_0,
            cos_q_left_ball_1 * p_w_left_arm_frame_in_left_link_frame_1_2_of_place_0,
        );
    let p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2_1 = v_left_link_centre_2_2_of_place_1
        .mul_add(weight_4, weight_3 * w_spindle_frame_in_left_arm_frame_1_2_of_motion_1)
        - p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_1
        + p_w_spindle_frame_in_left_arm_frame_1_2_of_place_1;
    let w_left_link_frame_2_of_motion_1 = theta_dot_1 + q_left_ball_dot_1;
    let x_N_3_of_place_1 = l_m * cos_q_left_ball_1;
    let v_left_arm_frame_in_left_link_frame_1_of_theta_dot_1 = cos_q_left_ball_1
        .mul_add(theta_dot_0, theta_dot_1 * cos_q_left_ball_0);
    let v_left_arm_frame_in_left_link_frame_3_of_theta_dot_1 = sin_q_left_ball_1
        .mul_add(theta_dot_0, theta_dot_1 * sin_q_left_ball_0);
    let v_left_link_centre_1_of_place_1 = v_left_arm_frame_in_left_link_frame_1_of_theta_dot_1
        .mul_add(weight, l * w_left_link_frame_2_of_motion_1);
    let v_left_arm_frame_in_left_link_frame_1_2_of_motion_1 = w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_1
        .mul_add(
            theta_dot_0,
            theta_dot_1 * w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_0,
        );
    let v_left_arm_frame_in_left_link_frame_3_2_of_motion_1 = w_left_arm_frame_in_left_link_frame_1_2_of_motion_1
        .mul_add(
            theta_dot_0,
            theta_dot_1 * w_left_arm_frame_in_left_link_frame_1_2_of_motion_0,
        );
    let theta_plus_q_left_ball_1 = theta_1 + q_left_ball_1;
    let sin_theta_plus_q_left_ball_1 = theta_plus_q_left_ball_1 * cos_theta_plus_q_left_ball_0;
    let cos_theta_plus_q_left_ball_1 = -theta_plus_q_left_ball_1 * sin_theta_plus_q_left_ball_0;
    let theta_dot_sq_1 = theta_dot_1 * (theta_dot_0 + theta_dot_0);
    let theta_dot_sq_cos_theta_1 = theta_dot_sq_1
        .mul_add(cos_theta_0, cos_theta_1 * theta_dot_sq_0);
    let v_sleeve_centre_3_of_motion_1 = w_left_link_frame_2_of_motion_1
        * (w_left_link_frame_2_of_motion_0 + w_left_link_frame_2_of_motion_0);
    let v_sleeve_centre_3_of_motion_2_1 = v_sleeve_centre_3_of_motion_1
        .mul_add(
            cos_theta_plus_q_left_ball_0,
            cos_theta_plus_q_left_ball_1 * v_sleeve_centre_3_of_motion_0,
        );
    let v_sleeve_centre_3_of_motion_3_1 = theta_dot_sq_cos_theta_1
        + v_sleeve_centre_3_of_motion_2_1;
    let x_N_3_2_of_place_1 = l_m * cos_q_right_ball_1;
    let v_right_arm_frame_in_right_link_frame_1_of_motion_1 = cos_q_right_ball_1
        .mul_add(q_right_top_dot_0, q_right_top_dot_1 * cos_q_right_ball_0);
    let v_right_arm_frame_in_right_link_frame_3_of_motion_1 = sin_q_right_ball_1
        .mul_add(q_right_top_dot_0, q_right_top_dot_1 * sin_q_right_ball_0);
    let v_right_link_centre_1_of_place_1 = v_right_arm_frame_in_right_link_frame_1_of_motion_1
        .mul_add(weight, q_right_ball_dot_1.mul_add(l, l * q_right_top_dot_1));
    let v_right_arm_frame_in_right_link_frame_1_2_of_motion_1 = w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_1
        .mul_add(
            q_right_top_dot_0,
            q_right_top_dot_1 * w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_0,
        );
    let v_right_arm_frame_in_right_link_frame_3_2_of_motion_1 = w_right_arm_frame_in_right_link_frame_1_2_of_motion_1
        .mul_add(
            q_right_top_dot_0,
            q_right_top_dot_1 * w_right_arm_frame_in_right_link_frame_1_2_of_motion_0,
        );
    let w_left_arm_frame_in_left_link_frame_1_3_of_place_1 = sin_q_left_ball_1
        .mul_add(cos_theta_0, cos_theta_1 * sin_q_left_ball_0);
    let w_left_arm_frame_in_left_link_frame_1_3_of_place_2_1 = cos_q_left_ball_1
        .mul_add(sin_theta_0, sin_theta_1 * cos_q_left_ball_0);
    let w_left_arm_frame_in_left_link_frame_1_3_of_place_3_1 = w_left_arm_frame_in_left_link_frame_1_3_of_place_1
        + w_left_arm_frame_in_left_link_frame_1_3_of_place_2_1;
    let w_right_arm_frame_in_right_link_frame_1_3_of_place_1 = sin_q_right_ball_1
        .mul_add(cos_q_right_top_0, cos_q_right_top_1 * sin_q_right_ball_0);
    let w_right_arm_frame_in_right_link_frame_1_3_of_place_2_1 = cos_q_right_ball_1
        .mul_add(sin_q_right_top_0, sin_q_right_top_1 * cos_q_right_ball_0);
    let w_right_arm_frame_in_right_link_frame_1_3_of_place_3_1 = w_right_arm_frame_in_right_link_frame_1_3_of_place_1
        + w_right_arm_frame_in_right_link_frame_1_3_of_place_2_1;
    let v_left_link_centre_2_3_of_place_1 = w_left_arm_frame_in_left_link_frame_1_3_of_place_3_1
        .mul_add(l, weight * sin_theta_1);
    let v_right_link_centre_2_3_of_place_1 = w_right_arm_frame_in_right_link_frame_1_3_of_place_3_1
        .mul_add(l, weight * sin_q_right_top_1);
    let p_w_right_arm_frame_in_right_link_frame_1_3_of_place_1 = v_right_link_centre_2_3_of_place_1
        .mul_add(
            weight_2,
            l_2_m * w_right_arm_frame_in_right_link_frame_1_3_of_place_3_1,
        );
    let p_w_left_arm_frame_in_left_link_frame_1_3_of_place_1 = v_left_link_centre_2_3_of_place_1
        .mul_add(weight_2, l_2_m * w_left_arm_frame_in_left_link_frame_1_3_of_place_3_1);
    let p_w_spindle_frame_in_right_arm_frame_3_3_of_place_1 = p_w_right_arm_frame_in_right_link_frame_1_3_of_place_1
        .mul_add(
            sin_q_right_ball_0,
            sin_q_right_ball_1 * p_w_right_arm_frame_in_right_link_frame_1_3_of_place_0,
        );
    let p_w_spindle_frame_in_right_arm_frame_1_3_of_place_1 = p_w_right_arm_frame_in_right_link_frame_1_3_of_place_1
        .mul_add(
            cos_q_right_ball_0,
            cos_q_right_ball_1 * p_w_right_arm_frame_in_right_link_frame_1_3_of_place_0,
        );
    let p_w_spindle_frame_in_right_arm_frame_1_3_of_place_2_1 = v_right_link_centre_2_3_of_place_1
        .mul_add(weight_4, weight_3 * sin_q_right_top_1)
        + p_w_spindle_frame_in_right_arm_frame_1_3_of_place_1;
    let p_w_spindle_frame_in_left_arm_frame_3_3_of_place_1 = p_w_left_arm_frame_in_left_link_frame_1_3_of_place_1
        .mul_add(
            sin_q_left_ball_0,
            sin_q_left_ball_1 * p_w_left_arm_frame_in_left_link_frame_1_3_of_place_0,
        );
    let p_w_spindle_frame_in_left_arm_frame_1_3_of_place_1 = p_w_left_arm_frame_in_left_link_frame_1_3_of_place_1
        .mul_add(
            cos_q_left_ball_0,
            cos_q_left_ball_1 * p_w_left_arm_frame_in_left_link_frame_1_3_of_place_0,
        );
    let p_w_spindle_frame_in_left_arm_frame_1_3_of_place_2_1 = v_left_link_centre_2_3_of_place_1
        .mul_add(weight_4, weight_3 * sin_theta_1)
        + p_w_spindle_frame_in_left_arm_frame_1_3_of_place_1;
    let v_left_link_centre_1_2_of_place_1 = weight * cos_q_left_ball_1;
    let v_sleeve_centre_3_2_of_place_1 = sin_theta_1 + sin_theta_plus_q_left_ball_1;
    let v_right_link_centre_1_2_of_place_1 = weight * cos_q_right_ball_1;
    let d1_of_place_1 = p_w_spindle_frame_in_right_arm_frame_3_3_of_place_1
        .mul_add(
            cos_q_right_top_0,
            cos_q_right_top_1 * p_w_spindle_frame_in_right_arm_frame_3_3_of_place_0,
        );
    let d1_of_place_2_1 = p_w_spindle_frame_in_right_arm_frame_1_3_of_place_2_1
        .mul_add(
            sin_q_right_top_0,
            sin_q_right_top_1 * p_w_spindle_frame_in_right_arm_frame_1_3_of_place_2_0,
        );
    let d1_of_place_3_1 = p_w_spindle_frame_in_left_arm_frame_3_3_of_place_1
        .mul_add(
            cos_theta_0,
            cos_theta_1 * p_w_spindle_frame_in_left_arm_frame_3_3_of_place_0,
        );
    let d1_of_place_4_1 = p_w_spindle_frame_in_left_arm_frame_1_3_of_place_2_1
        .mul_add(
            sin_theta_0,
            sin_theta_1 * p_w_spindle_frame_in_left_arm_frame_1_3_of_place_2_0,
        );
    let d1_of_place_5_1 = d1_of_place_4_1
        .mul_add(
            S::ratio(1, 12),
            d1_of_place_2_1
                .mul_add(
                    S::ratio(1, 12),
                    d1_of_place_3_1
                        .mul_add(S::ratio(1, 12), S::ratio(1, 12) * d1_of_place_1),
                ),
        );
    let d2_of_place_1 = q_right_top_1 + q_right_ball_1;
    let sin_angle_1 = d2_of_place_1 * cos_angle_0;
    let cos_angle_1 = -d2_of_place_1 * sin_angle_0;
    let d2_of_place_2_1 = sin_q_left_ball_1
        .mul_add(sin_theta_0, sin_theta_1 * sin_q_left_ball_0);
    let d2_of_place_3_1 = cos_theta_1 + cos_theta_plus_q_left_ball_1;
    let d2_of_q_right_ball_1 = cos_q_right_ball_1;
    let d2_of_place_4_1 = d2_of_q_right_ball_1
        .mul_add(cos_q_right_top_0, cos_q_right_top_1 * d2_of_q_right_ball_0);
    let d2_of_place_5_1 = sin_q_right_ball_1
        .mul_add(sin_q_right_top_0, sin_q_right_top_1 * sin_q_right_ball_0);
    let d2_of_place_6_1 = -d2_of_place_5_1 + d2_of_place_4_1;
    let d2_of_place_7_1 = cos_q_left_ball_1
        .mul_add(cos_theta_0, cos_theta_1 * cos_q_left_ball_0);
    let d2_of_place_8_1 = d2_of_place_2_1 - d2_of_place_7_1;
    let d2_of_place_9_1 = v_sleeve_centre_3_2_of_place_1
        * (v_sleeve_centre_3_2_of_place_0 + v_sleeve_centre_3_2_of_place_0);
    let sin_q_left_ball_sq_1 = sin_q_left_ball_1 * (sin_q_left_ball_0 + sin_q_left_ball_0);
    let d2_of_place_10_1 = v_left_link_centre_1_2_of_place_1
        .mul_add(
            cos_q_left_ball_0,
            cos_q_left_ball_1 * v_left_link_centre_1_2_of_place_0,
        );
    let d2_of_place_11_1 = v_sleeve_centre_3_2_of_place_1
        .mul_add(
            sin_theta_plus_q_left_ball_0,
            sin_theta_plus_q_left_ball_1 * v_sleeve_centre_3_2_of_place_0,
        );
    let sin_q_right_ball_sq_1 = sin_q_right_ball_1 * (sin_q_right_ball_0 + sin_q_right_ball_0);
    let d2_of_place_12_1 = v_right_link_centre_1_2_of_place_1
        .mul_add(
            cos_q_right_ball_0,
            cos_q_right_ball_1 * v_right_link_centre_1_2_of_place_0,
        );
    let d2_of_place_13_1 = d2_of_place_11_1
        .mul_add(weight_7, weight_8 * cos_q_left_ball_1);
    let d2_of_place_14_1 = cos_theta_plus_q_left_ball_1
        .mul_add(
            -(d2_of_place_14_0 * over_cos_theta_plus_q_left_ball),
            d2_of_place_3_1 * over_cos_theta_plus_q_left_ball,
        );
    let d2_of_place_15_1 = d2_of_place_13_1
        .mul_add(d2_of_place_14_0, d2_of_place_14_1 * d2_of_place_13_0);
    let d2_of_place_16_1 = d2_of_place_12_1
        .mul_add(
            weight_4,
            sin_q_right_ball_sq_1
                .mul_add(weight_10, weight_2 * v_right_link_centre_1_2_of_place_1),
        );
    let d2_of_place_17_1 = cos_theta_plus_q_left_ball_1
        .mul_add(sin_q_right_ball_0, sin_q_right_ball_1 * cos_theta_plus_q_left_ball_0);
    let d2_of_place_18_1 = d2_of_place_17_1
        .mul_add(
            -(d2_of_place_18_0 * over_d2_of_place_17),
            sin_q_left_ball_1 * over_d2_of_place_17,
        );
    let d2_of_place_19_1 = d2_of_place_18_1
        .mul_add(cos_angle_0, cos_angle_1 * d2_of_place_18_0);
    let d2_of_place_20_1 = d2_of_place_19_1
        .mul_add(d2_of_place_16_0, d2_of_place_16_1 * d2_of_place_19_0);
    let d2_of_place_21_1 = weight_8 * cos_q_right_ball_1;
    let d2_of_place_22_1 = d2_of_place_18_1
        .mul_add(d2_of_place_6_0, d2_of_place_6_1 * d2_of_place_18_0);
    let d2_of_place_23_1 = d2_of_place_22_1
        .mul_add(d2_of_place_21_0, d2_of_place_21_1 * d2_of_place_22_0);
    let d2_of_place_24_1 = w_left_arm_frame_in_left_link_frame_1_3_of_place_2_1
        .mul_add(l_m, weight_11 * sin_theta_plus_q_left_ball_1);
    let d2_of_place_25_1 = d2_of_place_24_1
        .mul_add(sin_q_left_ball_0, sin_q_left_ball_1 * d2_of_place_24_0);
    let d2_of_place_26_1 = d2_of_place_7_1
        .mul_add(cos_q_left_ball_0, cos_q_left_ball_1 * d2_of_place_7_0);
    let d2_of_place_27_1 = d2_of_place_25_1
        .mul_add(
            weight_12,
            d2_of_place_26_1.mul_add(minus_6_l_2_m, weight_6 * cos_theta_1),
        );
    let d2_of_place_28_1 = cos_angle_1
        .mul_add(cos_q_right_ball_0, cos_q_right_ball_1 * cos_angle_0);
    let d2_of_place_29_1 = d2_of_place_28_1
        .mul_add(
            weight_8,
            d2_of_place_4_1.mul_add(minus_4_l_2_m, weight_6 * cos_angle_1),
        );
    let d2_of_place_30_1 = sin_q_right_ball_1
        .mul_add(
            -(d2_of_place_30_0 * over_sin_q_right_ball),
            d2_of_place_29_1 * over_sin_q_right_ball,
        );
    let d2_of_place_31_1 = weight_6 * sin_q_right_top_1 + d2_of_place_30_1;
    let d2_of_place_32_1 = d2_of_place_20_1 - d2_of_place_23_1;
    let d2_of_place_33_1 = d2_of_place_32_1
        .mul_add(d2_of_place_19_0, d2_of_place_19_1 * d2_of_place_32_0);
    let d2_of_place_34_1 = d2_of_place_8_1
        .mul_add(
            -(d2_of_place_34_0 * over_d2_of_place_8),
            d2_of_place_27_1 * over_d2_of_place_8,
        );
    let d2_of_place_35_1 = d2_of_place_34_1
        .mul_add(d2_of_place_14_0, d2_of_place_14_1 * d2_of_place_34_0);
    let d2_of_place_36_1 = cos_theta_plus_q_left_ball_1
        .mul_add(
            -(d2_of_place_36_0 * over_cos_theta_plus_q_left_ball),
            sin_q_left_ball_1 * over_cos_theta_plus_q_left_ball,
        );
    let d2_of_place_37_1 = d2_of_place_31_1
        .mul_add(d2_of_place_36_0, d2_of_place_36_1 * d2_of_place_31_0);
    let d2_of_place_38_1 = d2_of_place_37_1
        .mul_add(d2_of_place_22_0, d2_of_place_22_1 * d2_of_place_37_0);
    let d2_of_place_39_1 = d2_of_place_33_1
        .mul_add(
            S::ratio(1, 12),
            d2_of_place_38_1
                .mul_add(
                    -S::ratio(1, 12),
                    d2_of_place_35_1
                        .mul_add(
                            -S::ratio(1, 12),
                            d2_of_place_15_1
                                .mul_add(
                                    -S::ratio(1, 12),
                                    d2_of_place_9_1
                                        .mul_add(
                                            l_2_ms,
                                            d2_of_place_10_1
                                                .mul_add(
                                                    l_m_by_2,
                                                    sin_q_left_ball_sq_1
                                                        .mul_add(
                                                            l_2_m,
                                                            l_m_by_4 * v_left_link_centre_1_2_of_place_1,
                                                        ),
                                                ),
                                        ),
                                ),
                        ),
                ),
        );
    let opening_dot_of_place_1 = d2_of_q_right_ball_1
        .mul_add(sin_q_right_top_0, sin_q_right_top_1 * d2_of_q_right_ball_0);
    let opening_dot_of_place_2_1 = d2_of_place_7_1
        .mul_add(d2_of_q_right_ball_0, d2_of_q_right_ball_1 * d2_of_place_7_0);
    let opening_dot_of_q_right_ball_1 = sin_q_right_ball_1
        .mul_add(
            -(opening_dot_of_q_right_ball_0 * over_sin_q_right_ball),
            d2_of_q_right_ball_1 * over_sin_q_right_ball,
        );
    let opening_dot_of_place_3_1 = opening_dot_of_q_right_ball_1
        .mul_add(cos_q_right_top_0, cos_q_right_top_1 * opening_dot_of_q_right_ball_0);
    let opening_dot_of_place_4_1 = sin_q_right_top_1 - opening_dot_of_place_3_1;
    let opening_dot_of_place_5_1 = opening_dot_of_q_right_ball_1
        .mul_add(cos_angle_0, cos_angle_1 * opening_dot_of_q_right_ball_0);
    let opening_dot_of_place_6_1 = sin_angle_1 + opening_dot_of_place_5_1;
    let opening_dot_of_place_7_1 = opening_dot_of_place_6_1
        .mul_add(cos_q_right_ball_0, cos_q_right_ball_1 * opening_dot_of_place_6_0);
    let opening_dot_of_place_8_1 = sin_angle_1 + opening_dot_of_place_7_1;
    let opening_dot_of_place_9_1 = opening_dot_of_place_8_1
        .mul_add(cos_q_right_top_0, cos_q_right_top_1 * opening_dot_of_place_8_0);
    let opening_dot_of_place_10_1 = sin_angle_1
        + w_right_arm_frame_in_right_link_frame_1_3_of_place_2_1;
    let opening_dot_of_place_11_1 = opening_dot_of_place_10_1
        .mul_add(cos_angle_0, cos_angle_1 * opening_dot_of_place_10_0);
    let opening_dot_of_place_12_1 = -opening_dot_of_place_11_1 + opening_dot_of_place_9_1;
    let opening_dot_of_place_13_1 = sin_q_right_ball_1
        .mul_add(
            -(opening_dot_of_place_13_0 * over_sin_q_right_ball),
            opening_dot_of_place_12_1 * over_sin_q_right_ball,
        );
    let opening_dot_of_place_14_1 = sin_angle_1
        .mul_add(sin_q_right_top_0, sin_q_right_top_1 * sin_angle_0);
    let opening_dot_of_place_15_1 = -opening_dot_of_place_14_1 + opening_dot_of_place_13_1;
    let opening_dot_of_place_16_1 = opening_dot_of_place_15_1
        .mul_add(sin_q_left_ball_0, sin_q_left_ball_1 * opening_dot_of_place_15_0);
    let opening_dot_of_place_17_1 = cos_theta_plus_q_left_ball_1
        .mul_add(
            -(opening_dot_of_place_17_0 * over_cos_theta_plus_q_left_ball),
            sin_theta_plus_q_left_ball_1 * over_cos_theta_plus_q_left_ball,
        );
    let opening_dot_of_place_18_1 = opening_dot_of_place_17_1
        .mul_add(cos_theta_0, cos_theta_1 * opening_dot_of_place_17_0);
    let opening_dot_of_place_19_1 = opening_dot_of_place_18_1
        .mul_add(cos_angle_0, cos_angle_1 * opening_dot_of_place_18_0);
    let opening_dot_of_place_20_1 = -opening_dot_of_place_19_1 + opening_dot_of_place_16_1;
    let opening_dot_of_place_21_1 = opening_dot_of_place_20_1
        .mul_add(sin_q_left_ball_0, sin_q_left_ball_1 * opening_dot_of_place_20_0);
    let opening_dot_of_place_22_1 = d2_of_place_7_1
        .mul_add(cos_angle_0, cos_angle_1 * d2_of_place_7_0);
    let opening_dot_of_place_23_1 = -opening_dot_of_place_22_1 + opening_dot_of_place_21_1;
    let opening_dot_of_place_24_1 = cos_theta_plus_q_left_ball_1
        .mul_add(
            -(opening_dot_of_place_24_0 * over_cos_theta_plus_q_left_ball),
            opening_dot_of_place_23_1 * over_cos_theta_plus_q_left_ball,
        );
    let opening_dot_of_place_25_1 = cos_angle_1
        .mul_add(cos_q_left_ball_0, cos_q_left_ball_1 * cos_angle_0);
    let opening_dot_of_place_26_1 = -opening_dot_of_place_25_1 + opening_dot_of_place_24_1;
    let opening_dot_of_place_27_1 = cos_theta_plus_q_left_ball_1
        .mul_add(
            -(opening_dot_of_place_27_0 * over_cos_theta_plus_q_left_ball),
            cos_theta_1 * over_cos_theta_plus_q_left_ball,
        );
    let opening_dot_of_place_28_1 = opening_dot_of_place_18_1
        .mul_add(
            opening_dot_of_place_27_0,
            opening_dot_of_place_27_1 * opening_dot_of_place_18_0,
        );
    let opening_dot_of_place_29_1 = sin_theta_1 + opening_dot_of_place_28_1;
    let opening_dot_of_place_30_1 = opening_dot_of_place_3_1
        .mul_add(-S::int(2), opening_dot_of_place_1);
    let opening_dot_of_place_31_1 = sin_q_right_ball_1
        .mul_add(
            -(opening_dot_of_place_31_0 * over_sin_q_right_ball),
            opening_dot_of_place_30_1 * over_sin_q_right_ball,
        );
    let opening_dot_of_place_32_1 = cos_q_right_top_1 + cos_angle_1 + opening_dot_of_place_31_1;
    let opening_dot_of_place_33_1 = opening_dot_of_place_32_1
        .mul_add(sin_q_left_ball_0, sin_q_left_ball_1 * opening_dot_of_place_32_0);
    let opening_dot_of_place_34_1 = opening_dot_of_place_18_1
        .mul_add(d2_of_q_right_ball_0, d2_of_q_right_ball_1 * opening_dot_of_place_18_0);
    let opening_dot_of_place_35_1 = opening_dot_of_place_34_1 + opening_dot_of_place_33_1;
    let opening_dot_of_place_36_1 = opening_dot_of_place_35_1
        .mul_add(sin_q_left_ball_0, sin_q_left_ball_1 * opening_dot_of_place_35_0);
    let opening_dot_of_place_37_1 = opening_dot_of_place_2_1 + opening_dot_of_place_36_1;
    let opening_dot_of_place_38_1 = opening_dot_of_place_37_1
        .mul_add(cos_q_right_top_0, cos_q_right_top_1 * opening_dot_of_place_37_0);
    let sin_q_left_ball_sq_2_1 = sin_q_left_ball_1 * (sin_q_left_ball_0 + sin_q_left_ball_0);
    let opening_dot_of_place_39_1 = sin_q_left_ball_sq_2_1
        .mul_add(sin_q_right_top_0, sin_q_right_top_1 * sin_q_left_ball_sq_2_0);
    let opening_dot_of_place_40_1 = opening_dot_of_place_5_1
        .mul_add(
            opening_dot_of_place_39_0,
            opening_dot_of_place_39_1 * opening_dot_of_place_5_0,
        );
    let opening_dot_of_place_41_1 = opening_dot_of_place_40_1 + opening_dot_of_place_38_1;
    let opening_dot_of_place_42_1 = sin_q_right_ball_1
        .mul_add(
            -(opening_dot_of_place_42_0 * over_sin_q_right_ball),
            opening_dot_of_place_41_1 * over_sin_q_right_ball,
        );
    let opening_dot_of_place_43_1 = opening_dot_of_place_17_1
        .mul_add(sin_q_left_ball_0, sin_q_left_ball_1 * opening_dot_of_place_17_0);
    let opening_dot_of_place_44_1 = cos_q_left_ball_1 + opening_dot_of_place_43_1;
    let opening_dot_of_place_45_1 = sin_q_right_top_1
        .mul_add(cos_theta_0, cos_theta_1 * sin_q_right_top_0);
    let opening_dot_of_place_46_1 = opening_dot_of_place_44_1
        .mul_add(
            opening_dot_of_place_45_0,
            opening_dot_of_place_45_1 * opening_dot_of_place_44_0,
        );
    let opening_dot_of_place_47_1 = -opening_dot_of_place_46_1 + opening_dot_of_place_42_1;
    let opening_dot_of_place_48_1 = cos_theta_plus_q_left_ball_1
        .mul_add(
            -(opening_dot_of_place_48_0 * over_cos_theta_plus_q_left_ball),
            opening_dot_of_place_47_1 * over_cos_theta_plus_q_left_ball,
        );
    let opening_dot_of_place_49_1 = opening_dot_of_place_4_1
        .mul_add(cos_q_left_ball_0, cos_q_left_ball_1 * opening_dot_of_place_4_0);
    let opening_dot_of_place_50_1 = -opening_dot_of_place_49_1 + opening_dot_of_place_48_1;
    let opening_dot_of_place_51_1 = p_w_spindle_frame_in_left_arm_frame_3_of_place_1
        .mul_add(
            sin_theta_0,
            sin_theta_1 * p_w_spindle_frame_in_left_arm_frame_3_of_place_0,
        );
    let opening_dot_of_place_52_1 = p_w_spindle_frame_in_left_arm_frame_1_of_place_2_1
        .mul_add(
            cos_theta_0,
            cos_theta_1 * p_w_spindle_frame_in_left_arm_frame_1_of_place_2_0,
        );
    let opening_dot_of_place_53_1 = opening_dot_of_place_51_1 - opening_dot_of_place_52_1;
    let opening_dot_of_place_54_1 = p_w_spindle_frame_in_right_arm_frame_3_of_place_1
        .mul_add(
            sin_q_right_top_0,
            sin_q_right_top_1 * p_w_spindle_frame_in_right_arm_frame_3_of_place_0,
        );
    let opening_dot_of_place_55_1 = p_w_spindle_frame_in_right_arm_frame_1_of_place_2_1
        .mul_add(
            cos_q_right_top_0,
            cos_q_right_top_1 * p_w_spindle_frame_in_right_arm_frame_1_of_place_2_0,
        );
    let opening_dot_of_place_56_1 = opening_dot_of_place_54_1 - opening_dot_of_place_55_1;
    let opening_dot_of_place_57_1 = x_N_3_of_place_1
        .mul_add(sin_theta_0, sin_theta_1 * x_N_3_of_place_0);
    let opening_dot_of_place_58_1 = sin_q_left_ball_1
        .mul_add(cos_theta_0, cos_theta_1 * sin_q_left_ball_0);
    let opening_dot_of_place_59_1 = v_left_link_centre_1_of_place_1
        .mul_add(sin_q_left_ball_0, sin_q_left_ball_1 * v_left_link_centre_1_of_place_0);
    let opening_dot_of_theta_dot_1 = v_left_arm_frame_in_left_link_frame_3_of_theta_dot_1
        .mul_add(
            cos_q_left_ball_0,
            cos_q_left_ball_1 * v_left_arm_frame_in_left_link_frame_3_of_theta_dot_0,
        );
    let opening_dot_of_place_60_1 = opening_dot_of_place_59_1
        .mul_add(m, minus_2_l_m * opening_dot_of_theta_dot_1);
    let opening_dot_of_motion_1 = opening_dot_of_place_60_1
        .mul_add(q_left_ball_dot_0, q_left_ball_dot_1 * opening_dot_of_place_60_0);
    let opening_dot_of_motion_2_1 = v_sleeve_centre_3_of_motion_3_1
        .mul_add(
            v_sleeve_centre_3_2_of_place_0,
            v_sleeve_centre_3_2_of_place_1 * v_sleeve_centre_3_of_motion_3_0,
        );
    let opening_dot_of_motion_3_1 = v_left_arm_frame_in_left_link_frame_3_2_of_motion_1
        .mul_add(
            sin_q_left_ball_0,
            sin_q_left_ball_1 * v_left_arm_frame_in_left_link_frame_3_2_of_motion_0,
        );
    let opening_dot_of_motion_4_1 = v_left_arm_frame_in_left_link_frame_1_2_of_motion_1
        .mul_add(
            cos_q_left_ball_0,
            cos_q_left_ball_1 * v_left_arm_frame_in_left_link_frame_1_2_of_motion_0,
        );
    let opening_dot_of_psi_dot_1 = opening_dot_of_place_53_1
        .mul_add(psi_dot_0, psi_dot_1 * opening_dot_of_place_53_0);
    let opening_dot_of_place_61_1 = x_N_3_2_of_place_1
        .mul_add(sin_q_right_top_0, sin_q_right_top_1 * x_N_3_2_of_place_0);
    let opening_dot_of_place_62_1 = sin_q_right_ball_1
        .mul_add(cos_q_right_top_0, cos_q_right_top_1 * sin_q_right_ball_0);
    let opening_dot_of_place_63_1 = v_right_link_centre_1_of_place_1
        .mul_add(
            sin_q_right_ball_0,
            sin_q_right_ball_1 * v_right_link_centre_1_of_place_0,
        );
    let opening_dot_of_motion_5_1 = v_right_arm_frame_in_right_link_frame_3_of_motion_1
        .mul_add(
            cos_q_right_ball_0,
            cos_q_right_ball_1 * v_right_arm_frame_in_right_link_frame_3_of_motion_0,
        );
    let opening_dot_of_place_64_1 = opening_dot_of_place_63_1
        .mul_add(m, minus_2_l_m * opening_dot_of_motion_5_1);
    let opening_dot_of_motion_6_1 = opening_dot_of_place_64_1
        .mul_add(q_right_ball_dot_0, q_right_ball_dot_1 * opening_dot_of_place_64_0);
    let opening_dot_of_motion_7_1 = v_right_arm_frame_in_right_link_frame_3_2_of_motion_1
        .mul_add(
            sin_q_right_ball_0,
            sin_q_right_ball_1 * v_right_arm_frame_in_right_link_frame_3_2_of_motion_0,
        );
    let opening_dot_of_motion_8_1 = v_right_arm_frame_in_right_link_frame_1_2_of_motion_1
        .mul_add(
            cos_q_right_ball_0,
            cos_q_right_ball_1 * v_right_arm_frame_in_right_link_frame_1_2_of_motion_0,
        );
    let opening_dot_of_psi_dot_2_1 = opening_dot_of_place_56_1
        .mul_add(psi_dot_0, psi_dot_1 * opening_dot_of_place_56_0);
    let opening_dot_of_theta_dot_2_1 = opening_dot_of_place_60_1
        .mul_add(theta_dot_0, theta_dot_1 * opening_dot_of_place_60_0);
    let opening_dot_of_place_65_1 = l_ms * v_sleeve_centre_3_of_motion_3_1;
    let opening_dot_of_place_66_1 = opening_dot_of_place_65_1
        .mul_add(
            sin_theta_plus_q_left_ball_0,
            sin_theta_plus_q_left_ball_1 * opening_dot_of_place_65_0,
        );
    let opening_dot_of_psi_dot_3_1 = p_w_left_arm_frame_in_left_link_frame_1_of_place_1
        .mul_add(
            psi_dot_sin_theta_0,
            psi_dot_sin_theta_1 * p_w_left_arm_frame_in_left_link_frame_1_of_place_0,
        );
    let opening_dot_of_place_67_1 = weight_14 * cos_theta_1 + opening_dot_of_psi_dot_3_1;
    let opening_dot_of_place_68_1 = opening_dot_of_place_67_1
        .mul_add(sin_q_left_ball_0, sin_q_left_ball_1 * opening_dot_of_place_67_0);
    let opening_dot_of_psi_dot_4_1 = p_w_left_arm_frame_in_left_link_frame_1_of_place_1
        .mul_add(
            psi_dot_cos_theta_0,
            psi_dot_cos_theta_1 * p_w_left_arm_frame_in_left_link_frame_1_of_place_0,
        );
    let opening_dot_of_place_69_1 = minus_6_l_m_g * sin_theta_1 + opening_dot_of_psi_dot_4_1;
    let opening_dot_of_place_70_1 = opening_dot_of_place_69_1
        .mul_add(cos_q_left_ball_0, cos_q_left_ball_1 * opening_dot_of_place_69_0);
    let opening_dot_of_motion_9_1 = v_right_link_centre_1_of_place_1
        .mul_add(
            q_right_top_dot_0,
            q_right_top_dot_1 * v_right_link_centre_1_of_place_0,
        );
    let opening_dot_of_psi_dot_5_1 = p_w_right_arm_frame_in_right_link_frame_1_of_place_1
        .mul_add(
            psi_dot_sin_q_right_top_0,
            psi_dot_sin_q_right_top_1 * p_w_right_arm_frame_in_right_link_frame_1_of_place_0,
        );
    let opening_dot_of_motion_10_1 = opening_dot_of_motion_9_1
        .mul_add(weight_4, weight_14 * cos_q_right_top_1) + opening_dot_of_psi_dot_5_1;
    let opening_dot_of_motion_11_1 = opening_dot_of_motion_10_1
        .mul_add(sin_q_right_ball_0, sin_q_right_ball_1 * opening_dot_of_motion_10_0);
    let opening_dot_of_motion_12_1 = v_right_arm_frame_in_right_link_frame_3_of_motion_1
        .mul_add(
            q_right_top_dot_0,
            q_right_top_dot_1 * v_right_arm_frame_in_right_link_frame_3_of_motion_0,
        );
    let opening_dot_of_psi_dot_6_1 = p_w_right_arm_frame_in_right_link_frame_1_of_place_1
        .mul_add(
            psi_dot_cos_q_right_top_0,
            psi_dot_cos_q_right_top_1 * p_w_right_arm_frame_in_right_link_frame_1_of_place_0,
        );
    let opening_dot_of_motion_13_1 = opening_dot_of_motion_12_1
        .mul_add(weight_10, minus_6_l_m_g * sin_q_right_top_1) + opening_dot_of_psi_dot_6_1;
    let opening_dot_of_motion_14_1 = opening_dot_of_motion_13_1
        .mul_add(cos_q_right_ball_0, cos_q_right_ball_1 * opening_dot_of_motion_13_0);
    let opening_dot_of_motion_15_1 = opening_dot_of_motion_6_1
        .mul_add(
            weight_12,
            opening_dot_of_motion_8_1
                .mul_add(
                    weight_10,
                    opening_dot_of_motion_7_1
                        .mul_add(
                            minus_12_l_2_m,
                            v_right_arm_frame_in_right_link_frame_1_2_of_motion_1
                                .mul_add(
                                    weight_8,
                                    opening_dot_of_place_61_1
                                        .mul_add(
                                            minus_6_g,
                                            minus_6_l_m_g * opening_dot_of_place_62_1,
                                        ),
                                ),
                        ),
                ),
        ) - opening_dot_of_psi_dot_2_1;
    let opening_dot_of_motion_16_1 = opening_dot_of_motion_15_1
        .mul_add(d2_of_place_19_0, d2_of_place_19_1 * opening_dot_of_motion_15_0);
    let opening_dot_of_theta_dot_3_1 = opening_dot_of_theta_dot_2_1
        .mul_add(
            minus_6_l,
            opening_dot_of_place_66_1
                .mul_add(
                    minus_12_l,
                    weight_8 * v_left_arm_frame_in_left_link_frame_1_2_of_motion_1,
                ),
        ) + opening_dot_of_place_70_1 - opening_dot_of_place_68_1;
    let opening_dot_of_theta_dot_4_1 = opening_dot_of_theta_dot_3_1
        .mul_add(d2_of_place_14_0, d2_of_place_14_1 * opening_dot_of_theta_dot_3_0);
    let opening_dot_of_motion_17_1 = weight_8
        * v_right_arm_frame_in_right_link_frame_1_2_of_motion_1
        + opening_dot_of_motion_14_1 - opening_dot_of_motion_11_1;
    let opening_dot_of_motion_18_1 = opening_dot_of_motion_17_1
        .mul_add(d2_of_place_22_0, d2_of_place_22_1 * opening_dot_of_motion_17_0);
    let opening_dot_of_place_71_1 = d2_of_place_17_1
        .mul_add(
            -(opening_dot_of_place_71_0 * over_d2_of_place_17),
            opening_dot_of_place_26_1 * over_d2_of_place_17,
        );
    let opening_dot_of_theta_dot_5_1 = opening_dot_of_place_71_1
        .mul_add(theta_dot_sq_0, theta_dot_sq_1 * opening_dot_of_place_71_0);
    let opening_dot_of_theta_dot_6_1 = opening_dot_of_theta_dot_5_1
        .mul_add(d2_of_place_32_0, d2_of_place_32_1 * opening_dot_of_theta_dot_5_0);
    let opening_dot_of_theta_dot_7_1 = cos_theta_plus_q_left_ball_1
        .mul_add(
            -(opening_dot_of_theta_dot_7_0 * over_cos_theta_plus_q_left_ball),
            theta_dot_sq_1 * over_cos_theta_plus_q_left_ball,
        );
    let opening_dot_of_theta_dot_8_1 = opening_dot_of_place_29_1
        .mul_add(
            opening_dot_of_theta_dot_7_0,
            opening_dot_of_theta_dot_7_1 * opening_dot_of_place_29_0,
        );
    let opening_dot_of_theta_dot_9_1 = opening_dot_of_theta_dot_8_1
        .mul_add(d2_of_place_34_0, d2_of_place_34_1 * opening_dot_of_theta_dot_8_0);
    let opening_dot_of_theta_dot_10_1 = opening_dot_of_place_50_1
        .mul_add(
            opening_dot_of_theta_dot_7_0,
            opening_dot_of_theta_dot_7_1 * opening_dot_of_place_50_0,
        );
    let opening_dot_of_theta_dot_11_1 = opening_dot_of_theta_dot_10_1
        .mul_add(d2_of_place_37_0, d2_of_place_37_1 * opening_dot_of_theta_dot_10_0);
    let opening_dot_of_motion_19_1 = opening_dot_of_motion_1
        .mul_add(
            weight_12,
            opening_dot_of_motion_4_1
                .mul_add(
                    weight_10,
                    opening_dot_of_motion_3_1
                        .mul_add(
                            minus_12_l_2_m,
                            opening_dot_of_motion_2_1
                                .mul_add(
                                    minus_12_l_2_ms,
                                    v_left_arm_frame_in_left_link_frame_1_2_of_motion_1
                                        .mul_add(
                                            weight_8,
                                            opening_dot_of_place_57_1
                                                .mul_add(
                                                    minus_6_g,
                                                    v_sleeve_centre_3_2_of_place_1
                                                        .mul_add(
                                                            minus_12_l_ms_g,
                                                            minus_6_l_m_g * opening_dot_of_place_58_1,
                                                        ),
                                                ),
                                        ),
                                ),
                        ),
                ),
        ) - opening_dot_of_theta_dot_9_1 - opening_dot_of_psi_dot_1
        - opening_dot_of_theta_dot_4_1 - opening_dot_of_motion_18_1
        + opening_dot_of_motion_16_1 - opening_dot_of_theta_dot_11_1 - opening_dot_of_theta_dot_6_1;
    let opening_dot_of_motion_20_1 = d2_of_place_39_1
        .mul_add(
            -(opening_dot_of_motion_20_0 * over_d2_of_place_39),
            opening_dot_of_motion_19_1 * over_d2_of_place_39,
        );
    let spin_dot_of_motion_1 = p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_2_1
        .mul_add(
            cos_q_right_top_0,
            cos_q_right_top_1 * p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_2_0,
        );
    let spin_dot_of_motion_2_1 = p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_2_1
        .mul_add(
            sin_q_right_top_0,
            sin_q_right_top_1 * p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_2_0,
        );
    let spin_dot_of_motion_3_1 = p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_2_1
        .mul_add(
            cos_theta_0,
            cos_theta_1 * p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_2_0,
        );
    let spin_dot_of_motion_4_1 = p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2_1
        .mul_add(
            sin_theta_0,
            sin_theta_1 * p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2_0,
        );
    let spin_dot_of_theta_dot_1 = opening_dot_of_place_53_1
        .mul_add(theta_dot_0, theta_dot_1 * opening_dot_of_place_53_0);
    let spin_dot_of_motion_5_1 = opening_dot_of_place_56_1
        .mul_add(q_right_top_dot_0, q_right_top_dot_1 * opening_dot_of_place_56_0);
    let spin_dot_of_motion_6_1 = spin_dot_of_motion_1 + spin_dot_of_motion_2_1
        + spin_dot_of_motion_3_1 + spin_dot_of_motion_4_1 - spin_dot_of_theta_dot_1
        - spin_dot_of_motion_5_1;
    let spin_dot_of_motion_7_1 = d1_of_place_5_1
        .mul_add(
            -(spin_dot_of_motion_7_0 * over_d1_of_place_5),
            spin_dot_of_motion_6_1 * over_d1_of_place_5,
        );
    let q_right_top_ddot_of_motion_1 = opening_dot_of_motion_20_1
        .mul_add(d2_of_place_19_0, d2_of_place_19_1 * opening_dot_of_motion_20_0);
    let q_right_top_dot_dot_1 = q_right_top_ddot_of_motion_1
        .mul_add(S::ratio(1, 12), opening_dot_of_theta_dot_5_1);
    let q_left_ball_ddot_of_motion_1 = opening_dot_of_motion_20_1
        .mul_add(d2_of_place_14_0, d2_of_place_14_1 * opening_dot_of_motion_20_0);
    let q_left_ball_dot_dot_1 = q_left_ball_ddot_of_motion_1
        .mul_add(-S::ratio(1, 12), opening_dot_of_theta_dot_8_1);
    let q_right_ball_ddot_of_motion_1 = opening_dot_of_motion_20_1
        .mul_add(d2_of_place_22_0, d2_of_place_22_1 * opening_dot_of_motion_20_0);
    let q_right_ball_dot_dot_1 = q_right_ball_ddot_of_motion_1
        .mul_add(-S::ratio(1, 12), opening_dot_of_theta_dot_10_1);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                theta_1, theta_1, psi_dot_1, psi_dot_1, q_right_top_1, q_right_top_1, psi_dot_1,
                psi_dot_1, q_left_ball_1, q_left_ball_1, sin_q_left_ball_1, cos_q_left_ball_1,
                q_right_ball_1, q_right_ball_1, sin_q_right_ball_1, cos_q_right_ball_1,
                sin_q_right_ball_1, cos_q_right_ball_1, sin_q_left_ball_1, cos_q_left_ball_1,
                theta_dot_1, theta_dot_1, q_right_top_dot_1, q_right_top_dot_1, q_left_ball_dot_1,
                psi_dot_cos_theta_1, sin_q_left_ball_1, q_left_ball_dot_1, psi_dot_sin_theta_1,
                cos_q_left_ball_1, q_right_ball_dot_1, psi_dot_cos_q_right_top_1,
                sin_q_right_ball_1, q_right_ball_dot_1, psi_dot_sin_q_right_top_1,
                cos_q_right_ball_1, p_w_right_arm_frame_in_right_link_frame_1_of_place_1,
                sin_q_right_ball_1, p_w_right_arm_frame_in_right_link_frame_1_of_place_1,
                cos_q_right_ball_1, p_w_left_arm_frame_in_left_link_frame_1_of_place_1,
                sin_q_left_ball_1, p_w_left_arm_frame_in_left_link_frame_1_of_place_1,
                cos_q_left_ball_1, theta_dot_1, theta_dot_1, theta_dot_1, theta_dot_1,
                theta_plus_q_left_ball_1, theta_plus_q_left_ball_1, theta_dot_1, cos_theta_1,
                w_left_link_frame_2_of_motion_1, cos_theta_plus_q_left_ball_1, q_right_top_dot_1,
                q_right_top_dot_1, q_right_top_dot_1, q_right_top_dot_1, cos_theta_1, sin_theta_1,
                cos_q_right_top_1, sin_q_right_top_1, sin_q_right_ball_1, cos_q_right_ball_1,
                sin_q_left_ball_1, cos_q_left_ball_1, cos_q_right_top_1, sin_q_right_top_1,
                cos_theta_1, sin_theta_1, d2_of_place_1, d2_of_place_1, sin_theta_1,
                cos_q_right_top_1, sin_q_right_top_1, cos_theta_1, v_sleeve_centre_3_2_of_place_1,
                sin_q_left_ball_1, cos_q_left_ball_1, v_sleeve_centre_3_2_of_place_1,
                sin_q_right_ball_1, cos_q_right_ball_1, cos_theta_plus_q_left_ball_1,
                d2_of_place_13_1, cos_theta_plus_q_left_ball_1, d2_of_place_17_1, cos_angle_1,
                d2_of_place_16_1, d2_of_place_6_1, d2_of_place_21_1, sin_q_left_ball_1,
                cos_q_left_ball_1, cos_angle_1, sin_q_right_ball_1, d2_of_place_32_1,
                d2_of_place_8_1, d2_of_place_14_1, cos_theta_plus_q_left_ball_1, d2_of_place_31_1,
                d2_of_place_22_1, sin_q_right_top_1, d2_of_q_right_ball_1, sin_q_right_ball_1,
                cos_q_right_top_1, cos_angle_1, cos_q_right_ball_1, cos_q_right_top_1, cos_angle_1,
                sin_q_right_ball_1, sin_q_right_top_1, sin_q_left_ball_1,
                cos_theta_plus_q_left_ball_1, cos_theta_1, cos_angle_1, sin_q_left_ball_1,
                cos_angle_1, cos_theta_plus_q_left_ball_1, cos_q_left_ball_1,
                cos_theta_plus_q_left_ball_1, opening_dot_of_place_18_1, sin_q_right_ball_1,
                sin_q_left_ball_1, d2_of_q_right_ball_1, sin_q_left_ball_1, cos_q_right_top_1,
                sin_q_left_ball_1, sin_q_right_top_1, opening_dot_of_place_5_1, sin_q_right_ball_1,
                sin_q_left_ball_1, cos_theta_1, opening_dot_of_place_44_1,
                cos_theta_plus_q_left_ball_1, cos_q_left_ball_1, sin_theta_1, cos_theta_1,
                sin_q_right_top_1, cos_q_right_top_1, sin_theta_1, cos_theta_1, sin_q_left_ball_1,
                cos_q_left_ball_1, q_left_ball_dot_1, v_sleeve_centre_3_2_of_place_1,
                sin_q_left_ball_1, cos_q_left_ball_1, psi_dot_1, sin_q_right_top_1,
                cos_q_right_top_1, sin_q_right_ball_1, cos_q_right_ball_1, q_right_ball_dot_1,
                sin_q_right_ball_1, cos_q_right_ball_1, psi_dot_1, theta_dot_1,
                sin_theta_plus_q_left_ball_1, psi_dot_sin_theta_1, sin_q_left_ball_1,
                psi_dot_cos_theta_1, cos_q_left_ball_1, q_right_top_dot_1,
                psi_dot_sin_q_right_top_1, sin_q_right_ball_1, q_right_top_dot_1,
                psi_dot_cos_q_right_top_1, cos_q_right_ball_1, opening_dot_of_motion_15_1,
                opening_dot_of_theta_dot_3_1, opening_dot_of_motion_17_1, d2_of_place_17_1,
                theta_dot_sq_1, d2_of_place_32_1, cos_theta_plus_q_left_ball_1,
                opening_dot_of_place_29_1, opening_dot_of_theta_dot_8_1, opening_dot_of_place_50_1,
                opening_dot_of_theta_dot_10_1, d2_of_place_39_1, cos_q_right_top_1,
                sin_q_right_top_1, cos_theta_1, sin_theta_1, theta_dot_1, q_right_top_dot_1,
                d1_of_place_5_1, opening_dot_of_motion_20_1, opening_dot_of_motion_20_1,
                opening_dot_of_motion_20_1,
            ]),
            padded([
                cos_theta_1, sin_theta_1, sin_theta_1, cos_theta_1, cos_q_right_top_1,
                sin_q_right_top_1, sin_q_right_top_1, cos_q_right_top_1, cos_q_left_ball_1,
                sin_q_left_ball_1, psi_dot_cos_theta_1, psi_dot_sin_theta_1, cos_q_right_ball_1,
                sin_q_right_ball_1, psi_dot_cos_q_right_top_1, psi_dot_sin_q_right_top_1,
                p_w_right_arm_frame_in_right_link_frame_1_of_place_1,
                p_w_right_arm_frame_in_right_link_frame_1_of_place_1,
                p_w_left_arm_frame_in_left_link_frame_1_of_place_1,
                p_w_left_arm_frame_in_left_link_frame_1_of_place_1, psi_dot_cos_theta_1,
                psi_dot_sin_theta_1, psi_dot_cos_q_right_top_1, psi_dot_sin_q_right_top_1,
                cos_q_left_ball_1, w_left_arm_frame_in_left_link_frame_1_2_of_motion_1,
                w_spindle_frame_in_left_arm_frame_3_2_of_motion_1, sin_q_left_ball_1,
                w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_1,
                w_spindle_frame_in_left_arm_frame_1_2_of_motion_1, cos_q_right_ball_1,
                w_right_arm_frame_in_right_link_frame_1_2_of_motion_1,
                w_spindle_frame_in_right_arm_frame_3_2_of_motion_1, sin_q_right_ball_1,
                w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_1,
                w_spindle_frame_in_right_arm_frame_1_2_of_motion_1,
                w_right_arm_frame_in_right_link_frame_1_2_of_motion_1,
                p_w_right_arm_frame_in_right_link_frame_1_2_of_place_1,
                w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_1,
                p_w_right_arm_frame_in_right_link_frame_1_2_of_place_1,
                w_left_arm_frame_in_left_link_frame_1_2_of_motion_1,
                p_w_left_arm_frame_in_left_link_frame_1_2_of_place_1,
                w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_1,
                p_w_left_arm_frame_in_left_link_frame_1_2_of_place_1, cos_q_left_ball_1,
                sin_q_left_ball_1, w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_1,
                w_left_arm_frame_in_left_link_frame_1_2_of_motion_1, cos_theta_plus_q_left_ball_1,
                sin_theta_plus_q_left_ball_1, theta_dot_1, theta_dot_sq_1,
                w_left_link_frame_2_of_motion_1, v_sleeve_centre_3_of_motion_1, cos_q_right_ball_1,
                sin_q_right_ball_1, w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_1,
                w_right_arm_frame_in_right_link_frame_1_2_of_motion_1, sin_q_left_ball_1,
                cos_q_left_ball_1, sin_q_right_ball_1, cos_q_right_ball_1,
                p_w_right_arm_frame_in_right_link_frame_1_3_of_place_1,
                p_w_right_arm_frame_in_right_link_frame_1_3_of_place_1,
                p_w_left_arm_frame_in_left_link_frame_1_3_of_place_1,
                p_w_left_arm_frame_in_left_link_frame_1_3_of_place_1,
                p_w_spindle_frame_in_right_arm_frame_3_3_of_place_1,
                p_w_spindle_frame_in_right_arm_frame_1_3_of_place_2_1,
                p_w_spindle_frame_in_left_arm_frame_3_3_of_place_1,
                p_w_spindle_frame_in_left_arm_frame_1_3_of_place_2_1, cos_angle_1, sin_angle_1,
                sin_q_left_ball_1, d2_of_q_right_ball_1, sin_q_right_ball_1, cos_q_left_ball_1,
                v_sleeve_centre_3_2_of_place_1, sin_q_left_ball_1,
                v_left_link_centre_1_2_of_place_1, sin_theta_plus_q_left_ball_1, sin_q_right_ball_1,
                v_right_link_centre_1_2_of_place_1, d2_of_place_14_1, d2_of_place_14_1,
                sin_q_right_ball_1, d2_of_place_18_1, d2_of_place_18_1, d2_of_place_19_1,
                d2_of_place_18_1, d2_of_place_22_1, d2_of_place_24_1, d2_of_place_7_1,
                cos_q_right_ball_1, d2_of_place_30_1, d2_of_place_19_1, d2_of_place_34_1,
                d2_of_place_34_1, d2_of_place_36_1, d2_of_place_36_1, d2_of_place_37_1,
                d2_of_q_right_ball_1, d2_of_place_7_1, opening_dot_of_q_right_ball_1,
                opening_dot_of_q_right_ball_1, opening_dot_of_q_right_ball_1,
                opening_dot_of_place_6_1, opening_dot_of_place_8_1, opening_dot_of_place_10_1,
                opening_dot_of_place_13_1, sin_angle_1, opening_dot_of_place_15_1,
                opening_dot_of_place_17_1, opening_dot_of_place_17_1, opening_dot_of_place_18_1,
                opening_dot_of_place_20_1, d2_of_place_7_1, opening_dot_of_place_24_1, cos_angle_1,
                opening_dot_of_place_27_1, opening_dot_of_place_27_1, opening_dot_of_place_31_1,
                opening_dot_of_place_32_1, opening_dot_of_place_18_1, opening_dot_of_place_35_1,
                opening_dot_of_place_37_1, sin_q_left_ball_1, sin_q_left_ball_sq_2_1,
                opening_dot_of_place_39_1, opening_dot_of_place_42_1, opening_dot_of_place_17_1,
                sin_q_right_top_1, opening_dot_of_place_45_1, opening_dot_of_place_48_1,
                opening_dot_of_place_4_1, p_w_spindle_frame_in_left_arm_frame_3_of_place_1,
                p_w_spindle_frame_in_left_arm_frame_1_of_place_2_1,
                p_w_spindle_frame_in_right_arm_frame_3_of_place_1,
                p_w_spindle_frame_in_right_arm_frame_1_of_place_2_1, x_N_3_of_place_1,
                sin_q_left_ball_1, v_left_link_centre_1_of_place_1,
                v_left_arm_frame_in_left_link_frame_3_of_theta_dot_1, opening_dot_of_place_60_1,
                v_sleeve_centre_3_of_motion_3_1,
                v_left_arm_frame_in_left_link_frame_3_2_of_motion_1,
                v_left_arm_frame_in_left_link_frame_1_2_of_motion_1, opening_dot_of_place_53_1,
                x_N_3_2_of_place_1, sin_q_right_ball_1, v_right_link_centre_1_of_place_1,
                v_right_arm_frame_in_right_link_frame_3_of_motion_1, opening_dot_of_place_64_1,
                v_right_arm_frame_in_right_link_frame_3_2_of_motion_1,
                v_right_arm_frame_in_right_link_frame_1_2_of_motion_1, opening_dot_of_place_56_1,
                opening_dot_of_place_60_1, opening_dot_of_place_65_1,
                p_w_left_arm_frame_in_left_link_frame_1_of_place_1, opening_dot_of_place_67_1,
                p_w_left_arm_frame_in_left_link_frame_1_of_place_1, opening_dot_of_place_69_1,
                v_right_link_centre_1_of_place_1,
                p_w_right_arm_frame_in_right_link_frame_1_of_place_1, opening_dot_of_motion_10_1,
                v_right_arm_frame_in_right_link_frame_3_of_motion_1,
                p_w_right_arm_frame_in_right_link_frame_1_of_place_1, opening_dot_of_motion_13_1,
                d2_of_place_19_1, d2_of_place_14_1, d2_of_place_22_1, opening_dot_of_place_71_1,
                opening_dot_of_place_71_1, opening_dot_of_theta_dot_5_1,
                opening_dot_of_theta_dot_7_1, opening_dot_of_theta_dot_7_1, d2_of_place_34_1,
                opening_dot_of_theta_dot_7_1, d2_of_place_37_1, opening_dot_of_motion_20_1,
                p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_2_1,
                p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_2_1,
                p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_2_1,
                p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2_1, opening_dot_of_place_53_1,
                opening_dot_of_place_56_1, spin_dot_of_motion_7_1, d2_of_place_19_1,
                d2_of_place_14_1, d2_of_place_22_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta_last = theta_1;
    let mut q_right_top_last = q_right_top_1;
    let mut q_left_ball_last = q_left_ball_1;
    let mut q_right_ball_last = q_right_ball_1;
    let mut psi_dot_last = psi_dot_1;
    let mut theta_dot_last = theta_dot_1;
    let mut q_right_top_dot_last = q_right_top_dot_1;
    let mut q_left_ball_dot_last = q_left_ball_dot_1;
    let mut q_right_ball_dot_last = q_right_ball_dot_1;
    let mut sin_theta_last = sin_theta_1;
    let mut cos_theta_last = cos_theta_1;
    let mut psi_dot_sin_theta_last = psi_dot_sin_theta_1;
    let mut psi_dot_cos_theta_last = psi_dot_cos_theta_1;
    let mut sin_q_right_top_last = sin_q_right_top_1;
    let mut cos_q_right_top_last = cos_q_right_top_1;
    let mut psi_dot_sin_q_right_top_last = psi_dot_sin_q_right_top_1;
    let mut psi_dot_cos_q_right_top_last = psi_dot_cos_q_right_top_1;
    let mut sin_q_left_ball_last = sin_q_left_ball_1;
    let mut cos_q_left_ball_last = cos_q_left_ball_1;
    let mut sin_q_right_ball_last = sin_q_right_ball_1;
    let mut cos_q_right_ball_last = cos_q_right_ball_1;
    let mut p_w_right_arm_frame_in_right_link_frame_1_of_place_last = p_w_right_arm_frame_in_right_link_frame_1_of_place_1;
    let mut p_w_left_arm_frame_in_left_link_frame_1_of_place_last = p_w_left_arm_frame_in_left_link_frame_1_of_place_1;
    let mut p_w_spindle_frame_in_right_arm_frame_3_of_place_last = p_w_spindle_frame_in_right_arm_frame_3_of_place_1;
    let mut p_w_spindle_frame_in_right_arm_frame_1_of_place_2_last = p_w_spindle_frame_in_right_arm_frame_1_of_place_2_1;
    let mut p_w_spindle_frame_in_left_arm_frame_3_of_place_last = p_w_spindle_frame_in_left_arm_frame_3_of_place_1;
    let mut p_w_spindle_frame_in_left_arm_frame_1_of_place_2_last = p_w_spindle_frame_in_left_arm_frame_1_of_place_2_1;
    let mut w_spindle_frame_in_left_arm_frame_1_2_of_motion_last = w_spindle_frame_in_left_arm_frame_1_2_of_motion_1;
    let mut w_spindle_frame_in_left_arm_frame_3_2_of_motion_last = w_spindle_frame_in_left_arm_frame_3_2_of_motion_1;
    let mut w_spindle_frame_in_right_arm_frame_1_2_of_motion_last = w_spindle_frame_in_right_arm_frame_1_2_of_motion_1;
    let mut w_spindle_frame_in_right_arm_frame_3_2_of_motion_last = w_spindle_frame_in_right_arm_frame_3_2_of_motion_1;
    let mut w_left_arm_frame_in_left_link_frame_1_2_of_motion_last = w_left_arm_frame_in_left_link_frame_1_2_of_motion_1;
    let mut w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_last = w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_1;
    let mut w_right_arm_frame_in_right_link_frame_1_2_of_motion_last = w_right_arm_frame_in_right_link_frame_1_2_of_motion_1;
    let mut w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_last = w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_1;
    let mut p_w_right_arm_frame_in_right_link_frame_1_2_of_place_last = p_w_right_arm_frame_in_right_link_frame_1_2_of_place_1;
    let mut p_w_left_arm_frame_in_left_link_frame_1_2_of_place_last = p_w_left_arm_frame_in_left_link_frame_1_2_of_place_1;
    let mut p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_2_last = p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_2_1;
    let mut p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_2_last = p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_2_1;
    let mut p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_2_last = p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_2_1;
    let mut p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2_last = p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2_1;
    let mut w_left_link_frame_2_of_motion_last = w_left_link_frame_2_of_motion_1;
    let mut x_N_3_of_place_last = x_N_3_of_place_1;
    let mut v_left_arm_frame_in_left_link_frame_3_of_theta_dot_last = v_left_arm_frame_in_left_link_frame_3_of_theta_dot_1;
    let mut v_left_link_centre_1_of_place_last = v_left_link_centre_1_of_place_1;
    let mut v_left_arm_frame_in_left_link_frame_1_2_of_motion_last = v_left_arm_frame_in_left_link_frame_1_2_of_motion_1;
    let mut v_left_arm_frame_in_left_link_frame_3_2_of_motion_last = v_left_arm_frame_in_left_link_frame_3_2_of_motion_1;
    let mut theta_plus_q_left_ball_last = theta_plus_q_left_ball_1;
    let mut sin_theta_plus_q_left_ball_last = sin_theta_plus_q_left_ball_1;
    let mut cos_theta_plus_q_left_ball_last = cos_theta_plus_q_left_ball_1;
    let mut theta_dot_sq_last = theta_dot_sq_1;
    let mut v_sleeve_centre_3_of_motion_last = v_sleeve_centre_3_of_motion_1;
    let mut v_sleeve_centre_3_of_motion_3_last = v_sleeve_centre_3_of_motion_3_1;
    let mut x_N_3_2_of_place_last = x_N_3_2_of_place_1;
    let mut v_right_arm_frame_in_right_link_frame_3_of_motion_last = v_right_arm_frame_in_right_link_frame_3_of_motion_1;
    let mut v_right_link_centre_1_of_place_last = v_right_link_centre_1_of_place_1;
    let mut v_right_arm_frame_in_right_link_frame_1_2_of_motion_last = v_right_arm_frame_in_right_link_frame_1_2_of_motion_1;
    let mut v_right_arm_frame_in_right_link_frame_3_2_of_motion_last = v_right_arm_frame_in_right_link_frame_3_2_of_motion_1;
    let mut p_w_right_arm_frame_in_right_link_frame_1_3_of_place_last = p_w_right_arm_frame_in_right_link_frame_1_3_of_place_1;
    let mut p_w_left_arm_frame_in_left_link_frame_1_3_of_place_last = p_w_left_arm_frame_in_left_link_frame_1_3_of_place_1;
    let mut p_w_spindle_frame_in_right_arm_frame_3_3_of_place_last = p_w_spindle_frame_in_right_arm_frame_3_3_of_place_1;
    let mut p_w_spindle_frame_in_right_arm_frame_1_3_of_place_2_last = p_w_spindle_frame_in_right_arm_frame_1_3_of_place_2_1;
    let mut p_w_spindle_frame_in_left_arm_frame_3_3_of_place_last = p_w_spindle_frame_in_left_arm_frame_3_3_of_place_1;
    let mut p_w_spindle_frame_in_left_arm_frame_1_3_of_place_2_last = p_w_spindle_frame_in_left_arm_frame_1_3_of_place_2_1;
    let mut v_left_link_centre_1_2_of_place_last = v_left_link_centre_1_2_of_place_1;
    let mut v_sleeve_centre_3_2_of_place_last = v_sleeve_centre_3_2_of_place_1;
    let mut v_right_link_centre_1_2_of_place_last = v_right_link_centre_1_2_of_place_1;
    let mut d1_of_place_5_last = d1_of_place_5_1;
    let mut d2_of_place_last = d2_of_place_1;
    let mut sin_angle_last = sin_angle_1;
    let mut cos_angle_last = cos_angle_1;
    let mut d2_of_q_right_ball_last = d2_of_q_right_ball_1;
    let mut d2_of_place_6_last = d2_of_place_6_1;
    let mut d2_of_place_7_last = d2_of_place_7_1;
    let mut d2_of_place_8_last = d2_of_place_8_1;
    let mut d2_of_place_13_last = d2_of_place_13_1;
    let mut d2_of_place_14_last = d2_of_place_14_1;
    let mut d2_of_place_16_last = d2_of_place_16_1;
    let mut d2_of_place_17_last = d2_of_place_17_1;
    let mut d2_of_place_18_last = d2_of_place_18_1;
    let mut d2_of_place_19_last = d2_of_place_19_1;
    let mut d2_of_place_21_last = d2_of_place_21_1;
    let mut d2_of_place_22_last = d2_of_place_22_1;
    let mut d2_of_place_24_last = d2_of_place_24_1;
    let mut d2_of_place_30_last = d2_of_place_30_1;
    let mut d2_of_place_31_last = d2_of_place_31_1;
    let mut d2_of_place_32_last = d2_of_place_32_1;
    let mut d2_of_place_34_last = d2_of_place_34_1;
    let mut d2_of_place_36_last = d2_of_place_36_1;
    let mut d2_of_place_37_last = d2_of_place_37_1;
    let mut d2_of_place_39_last = d2_of_place_39_1;
    let mut opening_dot_of_q_right_ball_last = opening_dot_of_q_right_ball_1;
    let mut opening_dot_of_place_4_last = opening_dot_of_place_4_1;
    let mut opening_dot_of_place_5_last = opening_dot_of_place_5_1;
    let mut opening_dot_of_place_6_last = opening_dot_of_place_6_1;
    let mut opening_dot_of_place_8_last = opening_dot_of_place_8_1;
    let mut opening_dot_of_place_10_last = opening_dot_of_place_10_1;
    let mut opening_dot_of_place_13_last = opening_dot_of_place_13_1;
    let mut opening_dot_of_place_15_last = opening_dot_of_place_15_1;
    let mut opening_dot_of_place_17_last = opening_dot_of_place_17_1;
    let mut opening_dot_of_place_18_last = opening_dot_of_place_18_1;
    let mut opening_dot_of_place_20_last = opening_dot_of_place_20_1;
    let mut opening_dot_of_place_24_last = opening_dot_of_place_24_1;
    let mut opening_dot_of_place_27_last = opening_dot_of_place_27_1;
    let mut opening_dot_of_place_29_last = opening_dot_of_place_29_1;
    let mut opening_dot_of_place_31_last = opening_dot_of_place_31_1;
    let mut opening_dot_of_place_32_last = opening_dot_of_place_32_1;
    let mut opening_dot_of_place_35_last = opening_dot_of_place_35_1;
    let mut opening_dot_of_place_37_last = opening_dot_of_place_37_1;
    let mut sin_q_left_ball_sq_2_last = sin_q_left_ball_sq_2_1;
    let mut opening_dot_of_place_39_last = opening_dot_of_place_39_1;
    let mut opening_dot_of_place_42_last = opening_dot_of_place_42_1;
    let mut opening_dot_of_place_44_last = opening_dot_of_place_44_1;
    let mut opening_dot_of_place_45_last = opening_dot_of_place_45_1;
    let mut opening_dot_of_place_48_last = opening_dot_of_place_48_1;
    let mut opening_dot_of_place_50_last = opening_dot_of_place_50_1;
    let mut opening_dot_of_place_53_last = opening_dot_of_place_53_1;
    let mut opening_dot_of_place_56_last = opening_dot_of_place_56_1;
    let mut opening_dot_of_place_60_last = opening_dot_of_place_60_1;
    let mut opening_dot_of_place_64_last = opening_dot_of_place_64_1;
    let mut opening_dot_of_place_65_last = opening_dot_of_place_65_1;
    let mut opening_dot_of_place_67_last = opening_dot_of_place_67_1;
    let mut opening_dot_of_place_69_last = opening_dot_of_place_69_1;
    let mut opening_dot_of_motion_10_last = opening_dot_of_motion_10_1;
    let mut opening_dot_of_motion_13_last = opening_dot_of_motion_13_1;
    let mut opening_dot_of_motion_15_last = opening_dot_of_motion_15_1;
    let mut opening_dot_of_theta_dot_3_last = opening_dot_of_theta_dot_3_1;
    let mut opening_dot_of_motion_17_last = opening_dot_of_motion_17_1;
    let mut opening_dot_of_place_71_last = opening_dot_of_place_71_1;
    let mut opening_dot_of_theta_dot_5_last = opening_dot_of_theta_dot_5_1;
    let mut opening_dot_of_theta_dot_7_last = opening_dot_of_theta_dot_7_1;
    let mut opening_dot_of_theta_dot_8_last = opening_dot_of_theta_dot_8_1;
    let mut opening_dot_of_theta_dot_10_last = opening_dot_of_theta_dot_10_1;
    let mut opening_dot_of_motion_20_last = opening_dot_of_motion_20_1;
    let mut spin_dot_of_motion_7_last = spin_dot_of_motion_7_1;
    let mut next = [S::int(0); 192];
    // Rates at order k - 1.
    let mut psi_rate = psi_dot_1;
    let mut theta_rate = theta_dot_1;
    let mut q_right_top_rate = q_right_top_dot_1;
    let mut q_left_ball_rate = q_left_ball_dot_1;
    let mut q_right_ball_rate = q_right_ball_dot_1;
    let mut psi_dot_rate = -S::ratio(1, 12) * spin_dot_of_motion_7_1;
    let mut theta_dot_rate = S::ratio(1, 12) * opening_dot_of_motion_20_1;
    let mut q_right_top_dot_rate = q_right_top_dot_dot_1;
    let mut q_left_ball_dot_rate = q_left_ball_dot_dot_1;
    let mut q_right_ball_dot_rate = q_right_ball_dot_dot_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let psi = psi_rate * over_k;
        let theta = theta_rate * over_k;
        let q_right_top = q_right_top_rate * over_k;
        let q_left_ball = q_left_ball_rate * over_k;
        let q_right_ball = q_right_ball_rate * over_k;
        let psi_dot = psi_dot_rate * over_k;
        let theta_dot = theta_dot_rate * over_k;
        let q_right_top_dot = q_right_top_dot_rate * over_k;
        let q_left_ball_dot = q_left_ball_dot_rate * over_k;
        let q_right_ball_dot = q_right_ball_dot_rate * over_k;
        series[order] = [
            psi, theta, q_right_top, q_left_ball, q_right_ball, psi_dot, theta_dot, q_right_top_dot,
            q_left_ball_dot, q_right_ball_dot,
        ];
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
                q_right_top_1
                    .mul_add(
                        cos_q_right_top_last,
                        (count_last * q_right_top_last)
                            .mul_add(cos_q_right_top_1, next[4]),
                    ),
                q_right_top_1
                    .mul_add(
                        sin_q_right_top_last,
                        (count_last * q_right_top_last)
                            .mul_add(sin_q_right_top_1, next[5]),
                    ),
                psi_dot_1
                    .mul_add(
                        sin_q_right_top_last,
                        psi_dot_last.mul_add(sin_q_right_top_1, next[6]),
                    ),
                psi_dot_1
                    .mul_add(
                        cos_q_right_top_last,
                        psi_dot_last.mul_add(cos_q_right_top_1, next[7]),
                    ),
                q_left_ball_1
                    .mul_add(
                        cos_q_left_ball_last,
                        (count_last * q_left_ball_last)
                            .mul_add(cos_q_left_ball_1, next[8]),
                    ),
                q_left_ball_1
                    .mul_add(
                        sin_q_left_ball_last,
                        (count_last * q_left_ball_last)
                            .mul_add(sin_q_left_ball_1, next[9]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        psi_dot_cos_theta_last,
                        sin_q_left_ball_last.mul_add(psi_dot_cos_theta_1, next[10]),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        psi_dot_sin_theta_last,
                        cos_q_left_ball_last.mul_add(psi_dot_sin_theta_1, next[11]),
                    ),
                q_right_ball_1
                    .mul_add(
                        cos_q_right_ball_last,
                        (count_last * q_right_ball_last)
                            .mul_add(cos_q_right_ball_1, next[12]),
                    ),
                q_right_ball_1
                    .mul_add(
                        sin_q_right_ball_last,
                        (count_last * q_right_ball_last)
                            .mul_add(sin_q_right_ball_1, next[13]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        psi_dot_cos_q_right_top_last,
                        sin_q_right_ball_last
                            .mul_add(psi_dot_cos_q_right_top_1, next[14]),
                    ),
                cos_q_right_ball_1
                    .mul_add(
                        psi_dot_sin_q_right_top_last,
                        cos_q_right_ball_last
                            .mul_add(psi_dot_sin_q_right_top_1, next[15]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_of_place_last,
                        sin_q_right_ball_last
                            .mul_add(
                                p_w_right_arm_frame_in_right_link_frame_1_of_place_1, next[16],
                            ),
                    ),
                cos_q_right_ball_1
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_of_place_last,
                        cos_q_right_ball_last
                            .mul_add(
                                p_w_right_arm_frame_in_right_link_frame_1_of_place_1, next[17],
                            ),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_of_place_last,
                        sin_q_left_ball_last
                            .mul_add(
                                p_w_left_arm_frame_in_left_link_frame_1_of_place_1, next[18],
                            ),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_of_place_last,
                        cos_q_left_ball_last
                            .mul_add(
                                p_w_left_arm_frame_in_left_link_frame_1_of_place_1, next[19],
                            ),
                    ),
                theta_dot_1
                    .mul_add(
                        psi_dot_cos_theta_last,
                        theta_dot_last.mul_add(psi_dot_cos_theta_1, next[20]),
                    ),
                theta_dot_1
                    .mul_add(
                        psi_dot_sin_theta_last,
                        theta_dot_last.mul_add(psi_dot_sin_theta_1, next[21]),
                    ),
                q_right_top_dot_1
                    .mul_add(
                        psi_dot_cos_q_right_top_last,
                        q_right_top_dot_last.mul_add(psi_dot_cos_q_right_top_1, next[22]),
                    ),
                q_right_top_dot_1
                    .mul_add(
                        psi_dot_sin_q_right_top_last,
                        q_right_top_dot_last.mul_add(psi_dot_sin_q_right_top_1, next[23]),
                    ),
                q_left_ball_dot_1
                    .mul_add(
                        cos_q_left_ball_last,
                        q_left_ball_dot_last.mul_add(cos_q_left_ball_1, next[24]),
                    ),
                psi_dot_cos_theta_1
                    .mul_add(
                        w_left_arm_frame_in_left_link_frame_1_2_of_motion_last,
                        psi_dot_cos_theta_last
                            .mul_add(
                                w_left_arm_frame_in_left_link_frame_1_2_of_motion_1, next[25],
                            ),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        w_spindle_frame_in_left_arm_frame_3_2_of_motion_last,
                        sin_q_left_ball_last
                            .mul_add(
                                w_spindle_frame_in_left_arm_frame_3_2_of_motion_1, next[26],
                            ),
                    ),
                q_left_ball_dot_1
                    .mul_add(
                        sin_q_left_ball_last,
                        q_left_ball_dot_last.mul_add(sin_q_left_ball_1, next[27]),
                    ),
                psi_dot_sin_theta_1
                    .mul_add(
                        w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_last,
                        psi_dot_sin_theta_last
                            .mul_add(
                                w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_1, next[28],
                            ),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        w_spindle_frame_in_left_arm_frame_1_2_of_motion_last,
                        cos_q_left_ball_last
                            .mul_add(
                                w_spindle_frame_in_left_arm_frame_1_2_of_motion_1, next[29],
                            ),
                    ),
                q_right_ball_dot_1
                    .mul_add(
                        cos_q_right_ball_last,
                        q_right_ball_dot_last.mul_add(cos_q_right_ball_1, next[30]),
                    ),
                psi_dot_cos_q_right_top_1
                    .mul_add(
                        w_right_arm_frame_in_right_link_frame_1_2_of_motion_last,
                        psi_dot_cos_q_right_top_last
                            .mul_add(
                                w_right_arm_frame_in_right_link_frame_1_2_of_motion_1, next[31],
                            ),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        w_spindle_frame_in_right_arm_frame_3_2_of_motion_last,
                        sin_q_right_ball_last
                            .mul_add(
                                w_spindle_frame_in_right_arm_frame_3_2_of_motion_1, next[32],
                            ),
                    ),
                q_right_ball_dot_1
                    .mul_add(
                        sin_q_right_ball_last,
                        q_right_ball_dot_last.mul_add(sin_q_right_ball_1, next[33]),
                    ),
                psi_dot_sin_q_right_top_1
                    .mul_add(
                        w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_last,
                        psi_dot_sin_q_right_top_last
                            .mul_add(
                                w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_1, next[34],
                            ),
                    ),
                cos_q_right_ball_1
                    .mul_add(
                        w_spindle_frame_in_right_arm_frame_1_2_of_motion_last,
                        cos_q_right_ball_last
                            .mul_add(
                                w_spindle_frame_in_right_arm_frame_1_2_of_motion_1, next[35],
                            ),
                    ),
                p_w_right_arm_frame_in_right_link_frame_1_of_place_1
                    .mul_add(
                        w_right_arm_frame_in_right_link_frame_1_2_of_motion_last,
                        p_w_right_arm_frame_in_right_link_frame_1_of_place_last
                            .mul_add(
                                w_right_arm_frame_in_right_link_frame_1_2_of_motion_1, next[36],
                            ),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_2_of_place_last,
                        sin_q_right_ball_last
                            .mul_add(
                                p_w_right_arm_frame_in_right_link_frame_1_2_of_place_1, next[37],
                            ),
                    ),
                p_w_right_arm_frame_in_right_link_frame_1_of_place_1
                    .mul_add(
                        w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_last,
                        p_w_right_arm_frame_in_right_link_frame_1_of_place_last
                            .mul_add(
                                w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_1, next[38],
                            ),
                    ),
                cos_q_right_ball_1
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_2_of_place_last,
                        cos_q_right_ball_last
                            .mul_add(
                                p_w_right_arm_frame_in_right_link_frame_1_2_of_place_1, next[39],
                            ),
                    ),
                p_w_left_arm_frame_in_left_link_frame_1_of_place_1
                    .mul_add(
                        w_left_arm_frame_in_left_link_frame_1_2_of_motion_last,
                        p_w_left_arm_frame_in_left_link_frame_1_of_place_last
                            .mul_add(
                                w_left_arm_frame_in_left_link_frame_1_2_of_motion_1, next[40],
                            ),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_2_of_place_last,
                        sin_q_left_ball_last
                            .mul_add(
                                p_w_left_arm_frame_in_left_link_frame_1_2_of_place_1, next[41],
                            ),
                    ),
                p_w_left_arm_frame_in_left_link_frame_1_of_place_1
                    .mul_add(
                        w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_last,
                        p_w_left_arm_frame_in_left_link_frame_1_of_place_last
                            .mul_add(
                                w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_1, next[42],
                            ),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_2_of_place_last,
                        cos_q_left_ball_last
                            .mul_add(
                                p_w_left_arm_frame_in_left_link_frame_1_2_of_place_1, next[43],
                            ),
                    ),
                theta_dot_1
                    .mul_add(
                        cos_q_left_ball_last,
                        theta_dot_last.mul_add(cos_q_left_ball_1, next[44]),
                    ),
                theta_dot_1
                    .mul_add(
                        sin_q_left_ball_last,
                        theta_dot_last.mul_add(sin_q_left_ball_1, next[45]),
                    ),
                theta_dot_1
                    .mul_add(
                        w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_last,
                        theta_dot_last
                            .mul_add(
                                w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_1, next[46],
                            ),
                    ),
                theta_dot_1
                    .mul_add(
                        w_left_arm_frame_in_left_link_frame_1_2_of_motion_last,
                        theta_dot_last
                            .mul_add(
                                w_left_arm_frame_in_left_link_frame_1_2_of_motion_1, next[47],
                            ),
                    ),
                theta_plus_q_left_ball_1
                    .mul_add(
                        cos_theta_plus_q_left_ball_last,
                        (count_last * theta_plus_q_left_ball_last)
                            .mul_add(cos_theta_plus_q_left_ball_1, next[48]),
                    ),
                theta_plus_q_left_ball_1
                    .mul_add(
                        sin_theta_plus_q_left_ball_last,
                        (count_last * theta_plus_q_left_ball_last)
                            .mul_add(sin_theta_plus_q_left_ball_1, next[49]),
                    ),
                (theta_dot_1 + theta_dot_1).mul_add(theta_dot_last, next[50]),
                cos_theta_1
                    .mul_add(
                        theta_dot_sq_last,
                        cos_theta_last.mul_add(theta_dot_sq_1, next[51]),
                    ),
                (w_left_link_frame_2_of_motion_1 + w_left_link_frame_2_of_motion_1)
                    .mul_add(w_left_link_frame_2_of_motion_last, next[52]),
                cos_theta_plus_q_left_ball_1
                    .mul_add(
                        v_sleeve_centre_3_of_motion_last,
                        cos_theta_plus_q_left_ball_last
                            .mul_add(v_sleeve_centre_3_of_motion_1, next[53]),
                    ),
                q_right_top_dot_1
                    .mul_add(
                        cos_q_right_ball_last,
                        q_right_top_dot_last.mul_add(cos_q_right_ball_1, next[54]),
                    ),
                q_right_top_dot_1
                    .mul_add(
                        sin_q_right_ball_last,
                        q_right_top_dot_last.mul_add(sin_q_right_ball_1, next[55]),
                    ),
                q_right_top_dot_1
                    .mul_add(
                        w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_last,
                        q_right_top_dot_last
                            .mul_add(
                                w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_1, next[56],
                            ),
                    ),
                q_right_top_dot_1
                    .mul_add(
                        w_right_arm_frame_in_right_link_frame_1_2_of_motion_last,
                        q_right_top_dot_last
                            .mul_add(
                                w_right_arm_frame_in_right_link_frame_1_2_of_motion_1, next[57],
                            ),
                    ),
                cos_theta_1
                    .mul_add(
                        sin_q_left_ball_last,
                        cos_theta_last.mul_add(sin_q_left_ball_1, next[58]),
                    ),
                sin_theta_1
                    .mul_add(
                        cos_q_left_ball_last,
                        sin_theta_last.mul_add(cos_q_left_ball_1, next[59]),
                    ),
                cos_q_right_top_1
                    .mul_add(
                        sin_q_right_ball_last,
                        cos_q_right_top_last.mul_add(sin_q_right_ball_1, next[60]),
                    ),
                sin_q_right_top_1
                    .mul_add(
                        cos_q_right_ball_last,
                        sin_q_right_top_last.mul_add(cos_q_right_ball_1, next[61]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_3_of_place_last,
                        sin_q_right_ball_last
                            .mul_add(
                                p_w_right_arm_frame_in_right_link_frame_1_3_of_place_1, next[62],
                            ),
                    ),
                cos_q_right_ball_1
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_3_of_place_last,
                        cos_q_right_ball_last
                            .mul_add(
                                p_w_right_arm_frame_in_right_link_frame_1_3_of_place_1, next[63],
                            ),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_3_of_place_last,
                        sin_q_left_ball_last
                            .mul_add(
                                p_w_left_arm_frame_in_left_link_frame_1_3_of_place_1, next[64],
                            ),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_3_of_place_last,
                        cos_q_left_ball_last
                            .mul_add(
                                p_w_left_arm_frame_in_left_link_frame_1_3_of_place_1, next[65],
                            ),
                    ),
                cos_q_right_top_1
                    .mul_add(
                        p_w_spindle_frame_in_right_arm_frame_3_3_of_place_last,
                        cos_q_right_top_last
                            .mul_add(
                                p_w_spindle_frame_in_right_arm_frame_3_3_of_place_1, next[66],
                            ),
                    ),
                sin_q_right_top_1
                    .mul_add(
                        p_w_spindle_frame_in_right_arm_frame_1_3_of_place_2_last,
                        sin_q_right_top_last
                            .mul_add(
                                p_w_spindle_frame_in_right_arm_frame_1_3_of_place_2_1, next[67],
                            ),
                    ),
                cos_theta_1
                    .mul_add(
                        p_w_spindle_frame_in_left_arm_frame_3_3_of_place_last,
                        cos_theta_last
                            .mul_add(
                                p_w_spindle_frame_in_left_arm_frame_3_3_of_place_1, next[68],
                            ),
                    ),
                sin_theta_1
                    .mul_add(
                        p_w_spindle_frame_in_left_arm_frame_1_3_of_place_2_last,
                        sin_theta_last
                            .mul_add(
                                p_w_spindle_frame_in_left_arm_frame_1_3_of_place_2_1, next[69],
                            ),
                    ),
                d2_of_place_1
                    .mul_add(
                        cos_angle_last,
                        (count_last * d2_of_place_last).mul_add(cos_angle_1, next[70]),
                    ),
                d2_of_place_1
                    .mul_add(
                        sin_angle_last,
                        (count_last * d2_of_place_last).mul_add(sin_angle_1, next[71]),
                    ),
                sin_theta_1
                    .mul_add(
                        sin_q_left_ball_last,
                        sin_theta_last.mul_add(sin_q_left_ball_1, next[72]),
                    ),
                cos_q_right_top_1
                    .mul_add(
                        d2_of_q_right_ball_last,
                        cos_q_right_top_last.mul_add(d2_of_q_right_ball_1, next[73]),
                    ),
                sin_q_right_top_1
                    .mul_add(
                        sin_q_right_ball_last,
                        sin_q_right_top_last.mul_add(sin_q_right_ball_1, next[74]),
                    ),
                cos_theta_1
                    .mul_add(
                        cos_q_left_ball_last,
                        cos_theta_last.mul_add(cos_q_left_ball_1, next[75]),
                    ),
                (v_sleeve_centre_3_2_of_place_1 + v_sleeve_centre_3_2_of_place_1)
                    .mul_add(v_sleeve_centre_3_2_of_place_last, next[76]),
                (sin_q_left_ball_1 + sin_q_left_ball_1)
                    .mul_add(sin_q_left_ball_last, next[77]),
                cos_q_left_ball_1
                    .mul_add(
                        v_left_link_centre_1_2_of_place_last,
                        cos_q_left_ball_last
                            .mul_add(v_left_link_centre_1_2_of_place_1, next[78]),
                    ),
                v_sleeve_centre_3_2_of_place_1
                    .mul_add(
                        sin_theta_plus_q_left_ball_last,
                        v_sleeve_centre_3_2_of_place_last
                            .mul_add(sin_theta_plus_q_left_ball_1, next[79]),
                    ),
                (sin_q_right_ball_1 + sin_q_right_ball_1)
                    .mul_add(sin_q_right_ball_last, next[80]),
                cos_q_right_ball_1
                    .mul_add(
                        v_right_link_centre_1_2_of_place_last,
                        cos_q_right_ball_last
                            .mul_add(v_right_link_centre_1_2_of_place_1, next[81]),
                    ),
                cos_theta_plus_q_left_ball_1
                    .mul_add(
                        d2_of_place_14_last,
                        cos_theta_plus_q_left_ball_last
                            .mul_add(d2_of_place_14_1, next[82]),
                    ),
                d2_of_place_13_1
                    .mul_add(
                        d2_of_place_14_last,
                        d2_of_place_13_last.mul_add(d2_of_place_14_1, next[83]),
                    ),
                cos_theta_plus_q_left_ball_1
                    .mul_add(
                        sin_q_right_ball_last,
                        cos_theta_plus_q_left_ball_last
                            .mul_add(sin_q_right_ball_1, next[84]),
                    ),
                d2_of_place_17_1
                    .mul_add(
                        d2_of_place_18_last,
                        d2_of_place_17_last.mul_add(d2_of_place_18_1, next[85]),
                    ),
                cos_angle_1
                    .mul_add(
                        d2_of_place_18_last,
                        cos_angle_last.mul_add(d2_of_place_18_1, next[86]),
                    ),
                d2_of_place_16_1
                    .mul_add(
                        d2_of_place_19_last,
                        d2_of_place_16_last.mul_add(d2_of_place_19_1, next[87]),
                    ),
                d2_of_place_6_1
                    .mul_add(
                        d2_of_place_18_last,
                        d2_of_place_6_last.mul_add(d2_of_place_18_1, next[88]),
                    ),
                d2_of_place_21_1
                    .mul_add(
                        d2_of_place_22_last,
                        d2_of_place_21_last.mul_add(d2_of_place_22_1, next[89]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        d2_of_place_24_last,
                        sin_q_left_ball_last.mul_add(d2_of_place_24_1, next[90]),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        d2_of_place_7_last,
                        cos_q_left_ball_last.mul_add(d2_of_place_7_1, next[91]),
                    ),
                cos_angle_1
                    .mul_add(
                        cos_q_right_ball_last,
                        cos_angle_last.mul_add(cos_q_right_ball_1, next[92]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        d2_of_place_30_last,
                        sin_q_right_ball_last.mul_add(d2_of_place_30_1, next[93]),
                    ),
                d2_of_place_32_1
                    .mul_add(
                        d2_of_place_19_last,
                        d2_of_place_32_last.mul_add(d2_of_place_19_1, next[94]),
                    ),
                d2_of_place_8_1
                    .mul_add(
                        d2_of_place_34_last,
                        d2_of_place_8_last.mul_add(d2_of_place_34_1, next[95]),
                    ),
                d2_of_place_14_1
                    .mul_add(
                        d2_of_place_34_last,
                        d2_of_place_14_last.mul_add(d2_of_place_34_1, next[96]),
                    ),
                cos_theta_plus_q_left_ball_1
                    .mul_add(
                        d2_of_place_36_last,
                        cos_theta_plus_q_left_ball_last
                            .mul_add(d2_of_place_36_1, next[97]),
                    ),
                d2_of_place_31_1
                    .mul_add(
                        d2_of_place_36_last,
                        d2_of_place_31_last.mul_add(d2_of_place_36_1, next[98]),
                    ),
                d2_of_place_22_1
                    .mul_add(
                        d2_of_place_37_last,
                        d2_of_place_22_last.mul_add(d2_of_place_37_1, next[99]),
                    ),
                sin_q_right_top_1
                    .mul_add(
                        d2_of_q_right_ball_last,
                        sin_q_right_top_last.mul_add(d2_of_q_right_ball_1, next[100]),
                    ),
                d2_of_q_right_ball_1
                    .mul_add(
                        d2_of_place_7_last,
                        d2_of_q_right_ball_last.mul_add(d2_of_place_7_1, next[101]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        opening_dot_of_q_right_ball_last,
                        sin_q_right_ball_last
                            .mul_add(opening_dot_of_q_right_ball_1, next[102]),
                    ),
                cos_q_right_top_1
                    .mul_add(
                        opening_dot_of_q_right_ball_last,
                        cos_q_right_top_last
                            .mul_add(opening_dot_of_q_right_ball_1, next[103]),
                    ),
                cos_angle_1
                    .mul_add(
                        opening_dot_of_q_right_ball_last,
                        cos_angle_last.mul_add(opening_dot_of_q_right_ball_1, next[104]),
                    ),
                cos_q_right_ball_1
                    .mul_add(
                        opening_dot_of_place_6_last,
                        cos_q_right_ball_last
                            .mul_add(opening_dot_of_place_6_1, next[105]),
                    ),
                cos_q_right_top_1
                    .mul_add(
                        opening_dot_of_place_8_last,
                        cos_q_right_top_last.mul_add(opening_dot_of_place_8_1, next[106]),
                    ),
                cos_angle_1
                    .mul_add(
                        opening_dot_of_place_10_last,
                        cos_angle_last.mul_add(opening_dot_of_place_10_1, next[107]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        opening_dot_of_place_13_last,
                        sin_q_right_ball_last
                            .mul_add(opening_dot_of_place_13_1, next[108]),
                    ),
                sin_q_right_top_1
                    .mul_add(
                        sin_angle_last,
                        sin_q_right_top_last.mul_add(sin_angle_1, next[109]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        opening_dot_of_place_15_last,
                        sin_q_left_ball_last
                            .mul_add(opening_dot_of_place_15_1, next[110]),
                    ),
                cos_theta_plus_q_left_ball_1
                    .mul_add(
                        opening_dot_of_place_17_last,
                        cos_theta_plus_q_left_ball_last
                            .mul_add(opening_dot_of_place_17_1, next[111]),
                    ),
                cos_theta_1
                    .mul_add(
                        opening_dot_of_place_17_last,
                        cos_theta_last.mul_add(opening_dot_of_place_17_1, next[112]),
                    ),
                cos_angle_1
                    .mul_add(
                        opening_dot_of_place_18_last,
                        cos_angle_last.mul_add(opening_dot_of_place_18_1, next[113]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        opening_dot_of_place_20_last,
                        sin_q_left_ball_last
                            .mul_add(opening_dot_of_place_20_1, next[114]),
                    ),
                cos_angle_1
                    .mul_add(
                        d2_of_place_7_last,
                        cos_angle_last.mul_add(d2_of_place_7_1, next[115]),
                    ),
                cos_theta_plus_q_left_ball_1
                    .mul_add(
                        opening_dot_of_place_24_last,
                        cos_theta_plus_q_left_ball_last
                            .mul_add(opening_dot_of_place_24_1, next[116]),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        cos_angle_last,
                        cos_q_left_ball_last.mul_add(cos_angle_1, next[117]),
                    ),
                cos_theta_plus_q_left_ball_1
                    .mul_add(
                        opening_dot_of_place_27_last,
                        cos_theta_plus_q_left_ball_last
                            .mul_add(opening_dot_of_place_27_1, next[118]),
                    ),
                opening_dot_of_place_18_1
                    .mul_add(
                        opening_dot_of_place_27_last,
                        opening_dot_of_place_18_last
                            .mul_add(opening_dot_of_place_27_1, next[119]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        opening_dot_of_place_31_last,
                        sin_q_right_ball_last
                            .mul_add(opening_dot_of_place_31_1, next[120]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        opening_dot_of_place_32_last,
                        sin_q_left_ball_last
                            .mul_add(opening_dot_of_place_32_1, next[121]),
                    ),
                d2_of_q_right_ball_1
                    .mul_add(
                        opening_dot_of_place_18_last,
                        d2_of_q_right_ball_last
                            .mul_add(opening_dot_of_place_18_1, next[122]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        opening_dot_of_place_35_last,
                        sin_q_left_ball_last
                            .mul_add(opening_dot_of_place_35_1, next[123]),
                    ),
                cos_q_right_top_1
                    .mul_add(
                        opening_dot_of_place_37_last,
                        cos_q_right_top_last
                            .mul_add(opening_dot_of_place_37_1, next[124]),
                    ),
                (sin_q_left_ball_1 + sin_q_left_ball_1)
                    .mul_add(sin_q_left_ball_last, next[125]),
                sin_q_right_top_1
                    .mul_add(
                        sin_q_left_ball_sq_2_last,
                        sin_q_right_top_last.mul_add(sin_q_left_ball_sq_2_1, next[126]),
                    ),
                opening_dot_of_place_5_1
                    .mul_add(
                        opening_dot_of_place_39_last,
                        opening_dot_of_place_5_last
                            .mul_add(opening_dot_of_place_39_1, next[127]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        opening_dot_of_place_42_last,
                        sin_q_right_ball_last
                            .mul_add(opening_dot_of_place_42_1, next[128]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        opening_dot_of_place_17_last,
                        sin_q_left_ball_last
                            .mul_add(opening_dot_of_place_17_1, next[129]),
                    ),
                cos_theta_1
                    .mul_add(
                        sin_q_right_top_last,
                        cos_theta_last.mul_add(sin_q_right_top_1, next[130]),
                    ),
                opening_dot_of_place_44_1
                    .mul_add(
                        opening_dot_of_place_45_last,
                        opening_dot_of_place_44_last
                            .mul_add(opening_dot_of_place_45_1, next[131]),
                    ),
                cos_theta_plus_q_left_ball_1
                    .mul_add(
                        opening_dot_of_place_48_last,
                        cos_theta_plus_q_left_ball_last
                            .mul_add(opening_dot_of_place_48_1, next[132]),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        opening_dot_of_place_4_last,
                        cos_q_left_ball_last.mul_add(opening_dot_of_place_4_1, next[133]),
                    ),
                sin_theta_1
                    .mul_add(
                        p_w_spindle_frame_in_left_arm_frame_3_of_place_last,
                        sin_theta_last
                            .mul_add(
                                p_w_spindle_frame_in_left_arm_frame_3_of_place_1, next[134],
                            ),
                    ),
                cos_theta_1
                    .mul_add(
                        p_w_spindle_frame_in_left_arm_frame_1_of_place_2_last,
                        cos_theta_last
                            .mul_add(
                                p_w_spindle_frame_in_left_arm_frame_1_of_place_2_1, next[135],
                            ),
                    ),
                sin_q_right_top_1
                    .mul_add(
                        p_w_spindle_frame_in_right_arm_frame_3_of_place_last,
                        sin_q_right_top_last
                            .mul_add(
                                p_w_spindle_frame_in_right_arm_frame_3_of_place_1, next[136],
                            ),
                    ),
                cos_q_right_top_1
                    .mul_add(
                        p_w_spindle_frame_in_right_arm_frame_1_of_place_2_last,
                        cos_q_right_top_last
                            .mul_add(
                                p_w_spindle_frame_in_right_arm_frame_1_of_place_2_1, next[137],
                            ),
                    ),
                sin_theta_1
                    .mul_add(
                        x_N_3_of_place_last,
                        sin_theta_last.mul_add(x_N_3_of_place_1, next[138]),
                    ),
                cos_theta_1
                    .mul_add(
                        sin_q_left_ball_last,
                        cos_theta_last.mul_add(sin_q_left_ball_1, next[139]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        v_left_link_centre_1_of_place_last,
                        sin_q_left_ball_last
                            .mul_add(v_left_link_centre_1_of_place_1, next[140]),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        v_left_arm_frame_in_left_link_frame_3_of_theta_dot_last,
                        cos_q_left_ball_last
                            .mul_add(
                                v_left_arm_frame_in_left_link_frame_3_of_theta_dot_1, next[141],
                            ),
                    ),
                q_left_ball_dot_1
                    .mul_add(
                        opening_dot_of_place_60_last,
                        q_left_ball_dot_last
                            .mul_add(opening_dot_of_place_60_1, next[142]),
                    ),
                v_sleeve_centre_3_2_of_place_1
                    .mul_add(
                        v_sleeve_centre_3_of_motion_3_last,
                        v_sleeve_centre_3_2_of_place_last
                            .mul_add(v_sleeve_centre_3_of_motion_3_1, next[143]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        v_left_arm_frame_in_left_link_frame_3_2_of_motion_last,
                        sin_q_left_ball_last
                            .mul_add(
                                v_left_arm_frame_in_left_link_frame_3_2_of_motion_1, next[144],
                            ),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        v_left_arm_frame_in_left_link_frame_1_2_of_motion_last,
                        cos_q_left_ball_last
                            .mul_add(
                                v_left_arm_frame_in_left_link_frame_1_2_of_motion_1, next[145],
                            ),
                    ),
                psi_dot_1
                    .mul_add(
                        opening_dot_of_place_53_last,
                        psi_dot_last.mul_add(opening_dot_of_place_53_1, next[146]),
                    ),
                sin_q_right_top_1
                    .mul_add(
                        x_N_3_2_of_place_last,
                        sin_q_right_top_last.mul_add(x_N_3_2_of_place_1, next[147]),
                    ),
                cos_q_right_top_1
                    .mul_add(
                        sin_q_right_ball_last,
                        cos_q_right_top_last.mul_add(sin_q_right_ball_1, next[148]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        v_right_link_centre_1_of_place_last,
                        sin_q_right_ball_last
                            .mul_add(v_right_link_centre_1_of_place_1, next[149]),
                    ),
                cos_q_right_ball_1
                    .mul_add(
                        v_right_arm_frame_in_right_link_frame_3_of_motion_last,
                        cos_q_right_ball_last
                            .mul_add(
                                v_right_arm_frame_in_right_link_frame_3_of_motion_1, next[150],
                            ),
                    ),
                q_right_ball_dot_1
                    .mul_add(
                        opening_dot_of_place_64_last,
                        q_right_ball_dot_last
                            .mul_add(opening_dot_of_place_64_1, next[151]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        v_right_arm_frame_in_right_link_frame_3_2_of_motion_last,
                        sin_q_right_ball_last
                            .mul_add(
                                v_right_arm_frame_in_right_link_frame_3_2_of_motion_1, next[152],
                            ),
                    ),
                cos_q_right_ball_1
                    .mul_add(
                        v_right_arm_frame_in_right_link_frame_1_2_of_motion_last,
                        cos_q_right_ball_last
                            .mul_add(
                                v_right_arm_frame_in_right_link_frame_1_2_of_motion_1, next[153],
                            ),
                    ),
                psi_dot_1
                    .mul_add(
                        opening_dot_of_place_56_last,
                        psi_dot_last.mul_add(opening_dot_of_place_56_1, next[154]),
                    ),
                theta_dot_1
                    .mul_add(
                        opening_dot_of_place_60_last,
                        theta_dot_last.mul_add(opening_dot_of_place_60_1, next[155]),
                    ),
                sin_theta_plus_q_left_ball_1
                    .mul_add(
                        opening_dot_of_place_65_last,
                        sin_theta_plus_q_left_ball_last
                            .mul_add(opening_dot_of_place_65_1, next[156]),
                    ),
                psi_dot_sin_theta_1
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_of_place_last,
                        psi_dot_sin_theta_last
                            .mul_add(
                                p_w_left_arm_frame_in_left_link_frame_1_of_place_1, next[157],
                            ),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        opening_dot_of_place_67_last,
                        sin_q_left_ball_last
                            .mul_add(opening_dot_of_place_67_1, next[158]),
                    ),
                psi_dot_cos_theta_1
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_of_place_last,
                        psi_dot_cos_theta_last
                            .mul_add(
                                p_w_left_arm_frame_in_left_link_frame_1_of_place_1, next[159],
                            ),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        opening_dot_of_place_69_last,
                        cos_q_left_ball_last
                            .mul_add(opening_dot_of_place_69_1, next[160]),
                    ),
                q_right_top_dot_1
                    .mul_add(
                        v_right_link_centre_1_of_place_last,
                        q_right_top_dot_last
                            .mul_add(v_right_link_centre_1_of_place_1, next[161]),
                    ),
                psi_dot_sin_q_right_top_1
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_of_place_last,
                        psi_dot_sin_q_right_top_last
                            .mul_add(
                                p_w_right_arm_frame_in_right_link_frame_1_of_place_1, next[162],
                            ),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        opening_dot_of_motion_10_last,
                        sin_q_right_ball_last
                            .mul_add(opening_dot_of_motion_10_1, next[163]),
                    ),
                q_right_top_dot_1
                    .mul_add(
                        v_right_arm_frame_in_right_link_frame_3_of_motion_last,
                        q_right_top_dot_last
                            .mul_add(
                                v_right_arm_frame_in_right_link_frame_3_of_motion_1, next[164],
                            ),
                    ),
                psi_dot_cos_q_right_top_1
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_of_place_last,
                        psi_dot_cos_q_right_top_last
                            .mul_add(
                                p_w_right_arm_frame_in_right_link_frame_1_of_place_1, next[165],
                            ),
                    ),
                cos_q_right_ball_1
                    .mul_add(
                        opening_dot_of_motion_13_last,
                        cos_q_right_ball_last
                            .mul_add(opening_dot_of_motion_13_1, next[166]),
                    ),
                opening_dot_of_motion_15_1
                    .mul_add(
                        d2_of_place_19_last,
                        opening_dot_of_motion_15_last
                            .mul_add(d2_of_place_19_1, next[167]),
                    ),
                opening_dot_of_theta_dot_3_1
                    .mul_add(
                        d2_of_place_14_last,
                        opening_dot_of_theta_dot_3_last
                            .mul_add(d2_of_place_14_1, next[168]),
                    ),
                opening_dot_of_motion_17_1
                    .mul_add(
                        d2_of_place_22_last,
                        opening_dot_of_motion_17_last
                            .mul_add(d2_of_place_22_1, next[169]),
                    ),
                d2_of_place_17_1
                    .mul_add(
                        opening_dot_of_place_71_last,
                        d2_of_place_17_last.mul_add(opening_dot_of_place_71_1, next[170]),
                    ),
                theta_dot_sq_1
                    .mul_add(
                        opening_dot_of_place_71_last,
                        theta_dot_sq_last.mul_add(opening_dot_of_place_71_1, next[171]),
                    ),
                d2_of_place_32_1
                    .mul_add(
                        opening_dot_of_theta_dot_5_last,
                        d2_of_place_32_last
                            .mul_add(opening_dot_of_theta_dot_5_1, next[172]),
                    ),
                cos_theta_plus_q_left_ball_1
                    .mul_add(
                        opening_dot_of_theta_dot_7_last,
                        cos_theta_plus_q_left_ball_last
                            .mul_add(opening_dot_of_theta_dot_7_1, next[173]),
                    ),
                opening_dot_of_place_29_1
                    .mul_add(
                        opening_dot_of_theta_dot_7_last,
                        opening_dot_of_place_29_last
                            .mul_add(opening_dot_of_theta_dot_7_1, next[174]),
                    ),
                opening_dot_of_theta_dot_8_1
                    .mul_add(
                        d2_of_place_34_last,
                        opening_dot_of_theta_dot_8_last
                            .mul_add(d2_of_place_34_1, next[175]),
                    ),
                opening_dot_of_place_50_1
                    .mul_add(
                        opening_dot_of_theta_dot_7_last,
                        opening_dot_of_place_50_last
                            .mul_add(opening_dot_of_theta_dot_7_1, next[176]),
                    ),
                opening_dot_of_theta_dot_10_1
                    .mul_add(
                        d2_of_place_37_last,
                        opening_dot_of_theta_dot_10_last
                            .mul_add(d2_of_place_37_1, next[177]),
                    ),
                d2_of_place_39_1
                    .mul_add(
                        opening_dot_of_motion_20_last,
                        d2_of_place_39_last
                            .mul_add(opening_dot_of_motion_20_1, next[178]),
                    ),
                cos_q_right_top_1
                    .mul_add(
                        p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_2_last,
                        cos_q_right_top_last
                            .mul_add(
                                p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_2_1, next[179],
                            ),
                    ),
                sin_q_right_top_1
                    .mul_add(
                        p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_2_last,
                        sin_q_right_top_last
                            .mul_add(
                                p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_2_1, next[180],
                            ),
                    ),
                cos_theta_1
                    .mul_add(
                        p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_2_last,
                        cos_theta_last
                            .mul_add(
                                p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_2_1, next[181],
                            ),
                    ),
                sin_theta_1
                    .mul_add(
                        p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2_last,
                        sin_theta_last
                            .mul_add(
                                p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2_1, next[182],
                            ),
                    ),
                theta_dot_1
                    .mul_add(
                        opening_dot_of_place_53_last,
                        theta_dot_last.mul_add(opening_dot_of_place_53_1, next[183]),
                    ),
                q_right_top_dot_1
                    .mul_add(
                        opening_dot_of_place_56_last,
                        q_right_top_dot_last
                            .mul_add(opening_dot_of_place_56_1, next[184]),
                    ),
                d1_of_place_5_1
                    .mul_add(
                        spin_dot_of_motion_7_last,
                        d1_of_place_5_last.mul_add(spin_dot_of_motion_7_1, next[185]),
                    ),
                opening_dot_of_motion_20_1
                    .mul_add(
                        d2_of_place_19_last,
                        opening_dot_of_motion_20_last
                            .mul_add(d2_of_place_19_1, next[186]),
                    ),
                opening_dot_of_motion_20_1
                    .mul_add(
                        d2_of_place_14_last,
                        opening_dot_of_motion_20_last
                            .mul_add(d2_of_place_14_1, next[187]),
                    ),
                opening_dot_of_motion_20_1
                    .mul_add(
                        d2_of_place_22_last,
                        opening_dot_of_motion_20_last
                            .mul_add(d2_of_place_22_1, next[188]),
                    ),
            ])
        };
        let sin_theta = theta.mul_add(cos_theta_0, sums[0] * over_k);
        let cos_theta = -theta.mul_add(sin_theta_0, sums[1] * over_k);
        let psi_dot_sin_theta = sin_theta
            .mul_add(psi_dot_0, psi_dot.mul_add(sin_theta_0, sums[2]));
        let psi_dot_cos_theta = cos_theta
            .mul_add(psi_dot_0, psi_dot.mul_add(cos_theta_0, sums[3]));
        let sin_q_right_top = q_right_top.mul_add(cos_q_right_top_0, sums[4] * over_k);
        let cos_q_right_top = -q_right_top.mul_add(sin_q_right_top_0, sums[5] * over_k);
        let psi_dot_sin_q_right_top = sin_q_right_top
            .mul_add(psi_dot_0, psi_dot.mul_add(sin_q_right_top_0, sums[6]));
        let psi_dot_cos_q_right_top = cos_q_right_top
            .mul_add(psi_dot_0, psi_dot.mul_add(cos_q_right_top_0, sums[7]));
        let sin_q_left_ball = q_left_ball.mul_add(cos_q_left_ball_0, sums[8] * over_k);
        let cos_q_left_ball = -q_left_ball.mul_add(sin_q_left_ball_0, sums[9] * over_k);
        let w_left_arm_frame_in_left_link_frame_1_of_psi_dot = psi_dot_cos_theta
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(psi_dot_cos_theta_0, sums[10]),
            );
        let w_left_arm_frame_in_left_link_frame_1_of_psi_dot_2 = psi_dot_sin_theta
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball.mul_add(psi_dot_sin_theta_0, sums[11]),
            );
        let w_left_arm_frame_in_left_link_frame_1_of_place = w_left_arm_frame_in_left_link_frame_1_of_psi_dot
            + w_left_arm_frame_in_left_link_frame_1_of_psi_dot_2;
        let sin_q_right_ball = q_right_ball
            .mul_add(cos_q_right_ball_0, sums[12] * over_k);
        let cos_q_right_ball = -q_right_ball
            .mul_add(sin_q_right_ball_0, sums[13] * over_k);
        let w_right_arm_frame_in_right_link_frame_1_of_psi_dot = psi_dot_cos_q_right_top
            .mul_add(
                sin_q_right_ball_0,
                sin_q_right_ball.mul_add(psi_dot_cos_q_right_top_0, sums[14]),
            );
        let w_right_arm_frame_in_right_link_frame_1_of_psi_dot_2 = psi_dot_sin_q_right_top
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball.mul_add(psi_dot_sin_q_right_top_0, sums[15]),
            );
        let w_right_arm_frame_in_right_link_frame_1_of_place = w_right_arm_frame_in_right_link_frame_1_of_psi_dot
            + w_right_arm_frame_in_right_link_frame_1_of_psi_dot_2;
        let v_left_link_centre_2_of_place = w_left_arm_frame_in_left_link_frame_1_of_place
            .mul_add(l, weight * psi_dot_sin_theta);
        let v_right_link_centre_2_of_place = w_right_arm_frame_in_right_link_frame_1_of_place
            .mul_add(l, weight * psi_dot_sin_q_right_top);
        let p_w_right_arm_frame_in_right_link_frame_1_of_place = v_right_link_centre_2_of_place
            .mul_add(weight_2, l_2_m * w_right_arm_frame_in_right_link_frame_1_of_place);
        let p_w_left_arm_frame_in_left_link_frame_1_of_place = v_left_link_centre_2_of_place
            .mul_add(weight_2, l_2_m * w_left_arm_frame_in_left_link_frame_1_of_place);
        let p_w_spindle_frame_in_right_arm_frame_3_of_place = p_w_right_arm_frame_in_right_link_frame_1_of_place
            .mul_add(
                sin_q_right_ball_0,
                sin_q_right_ball
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_of_place_0, sums[16],
                    ),
            );
        let p_w_spindle_frame_in_right_arm_frame_1_of_place = p_w_right_arm_frame_in_right_link_frame_1_of_place
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_of_place_0, sums[17],
                    ),
            );
        let p_w_spindle_frame_in_right_arm_frame_1_of_place_2 = v_right_link_centre_2_of_place
            .mul_add(weight_4, weight_3 * psi_dot_sin_q_right_top)
            + p_w_spindle_frame_in_right_arm_frame_1_of_place;
        let p_w_spindle_frame_in_left_arm_frame_3_of_place = p_w_left_arm_frame_in_left_link_frame_1_of_place
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_of_place_0, sums[18],
                    ),
            );
        let p_w_spindle_frame_in_left_arm_frame_1_of_place = p_w_left_arm_frame_in_left_link_frame_1_of_place
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_of_place_0, sums[19],
                    ),
            );
        let p_w_spindle_frame_in_left_arm_frame_1_of_place_2 = v_left_link_centre_2_of_place
            .mul_add(weight_4, weight_3 * psi_dot_sin_theta)
            + p_w_spindle_frame_in_left_arm_frame_1_of_place;
        let w_spindle_frame_in_left_arm_frame_1_2_of_motion = psi_dot_cos_theta
            .mul_add(theta_dot_0, theta_dot.mul_add(psi_dot_cos_theta_0, sums[20]));
        let w_spindle_frame_in_left_arm_frame_3_2_of_motion = psi_dot_sin_theta
            .mul_add(theta_dot_0, theta_dot.mul_add(psi_dot_sin_theta_0, sums[21]));
        let w_spindle_frame_in_right_arm_frame_1_2_of_motion = psi_dot_cos_q_right_top
            .mul_add(
                q_right_top_dot_0,
                q_right_top_dot.mul_add(psi_dot_cos_q_right_top_0, sums[22]),
            );
        let w_spindle_frame_in_right_arm_frame_3_2_of_motion = psi_dot_sin_q_right_top
            .mul_add(
                q_right_top_dot_0,
                q_right_top_dot.mul_add(psi_dot_sin_q_right_top_0, sums[23]),
            );
        let w_left_arm_frame_in_left_link_frame_1_2_of_motion = cos_q_left_ball
            .mul_add(
                q_left_ball_dot_0,
                q_left_ball_dot.mul_add(cos_q_left_ball_0, sums[24]),
            );
        let w_left_arm_frame_in_left_link_frame_1_2_of_motion_2 = w_left_arm_frame_in_left_link_frame_1_2_of_motion
            .mul_add(
                psi_dot_cos_theta_0,
                psi_dot_cos_theta
                    .mul_add(
                        w_left_arm_frame_in_left_link_frame_1_2_of_motion_0, sums[25],
                    ),
            );
        let w_left_arm_frame_in_left_link_frame_1_2_of_motion_3 = w_spindle_frame_in_left_arm_frame_3_2_of_motion
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball
                    .mul_add(w_spindle_frame_in_left_arm_frame_3_2_of_motion_0, sums[26]),
            );
        let w_left_arm_frame_in_left_link_frame_1_2_of_motion_4 = sin_q_left_ball
            .mul_add(
                q_left_ball_dot_0,
                q_left_ball_dot.mul_add(sin_q_left_ball_0, sums[27]),
            );
        let w_left_arm_frame_in_left_link_frame_1_2_of_motion_5 = w_left_arm_frame_in_left_link_frame_1_2_of_motion_4
            .mul_add(
                psi_dot_sin_theta_0,
                psi_dot_sin_theta
                    .mul_add(
                        w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_0, sums[28],
                    ),
            );
        let w_left_arm_frame_in_left_link_frame_1_2_of_motion_6 = w_spindle_frame_in_left_arm_frame_1_2_of_motion
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball
                    .mul_add(w_spindle_frame_in_left_arm_frame_1_2_of_motion_0, sums[29]),
            );
        let w_left_arm_frame_in_left_link_frame_1_2_of_motion_7 = w_left_arm_frame_in_left_link_frame_1_2_of_motion_2
            - w_left_arm_frame_in_left_link_frame_1_2_of_motion_5
            + w_left_arm_frame_in_left_link_frame_1_2_of_motion_6
            - w_left_arm_frame_in_left_link_frame_1_2_of_motion_3;
        let w_right_arm_frame_in_right_link_frame_1_2_of_motion = cos_q_right_ball
            .mul_add(
                q_right_ball_dot_0,
                q_right_ball_dot.mul_add(cos_q_right_ball_0, sums[30]),
            );
        let w_right_arm_frame_in_right_link_frame_1_2_of_motion_2 = w_right_arm_frame_in_right_link_frame_1_2_of_motion
            .mul_add(
                psi_dot_cos_q_right_top_0,
                psi_dot_cos_q_right_top
                    .mul_add(
                        w_right_arm_frame_in_right_link_frame_1_2_of_motion_0, sums[31],
                    ),
            );
        let w_right_arm_frame_in_right_link_frame_1_2_of_motion_3 = w_spindle_frame_in_right_arm_frame_3_2_of_motion
            .mul_add(
                sin_q_right_ball_0,
                sin_q_right_ball
                    .mul_add(
                        w_spindle_frame_in_right_arm_frame_3_2_of_motion_0, sums[32],
                    ),
            );
        let w_right_arm_frame_in_right_link_frame_1_2_of_motion_4 = sin_q_right_ball
            .mul_add(
                q_right_ball_dot_0,
                q_right_ball_dot.mul_add(sin_q_right_ball_0, sums[33]),
            );
        let w_right_arm_frame_in_right_link_frame_1_2_of_motion_5 = w_right_arm_frame_in_right_link_frame_1_2_of_motion_4
            .mul_add(
                psi_dot_sin_q_right_top_0,
                psi_dot_sin_q_right_top
                    .mul_add(
                        w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_0, sums[34],
                    ),
            );
        let w_right_arm_frame_in_right_link_frame_1_2_of_motion_6 = w_spindle_frame_in_right_arm_frame_1_2_of_motion
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball
                    .mul_add(
                        w_spindle_frame_in_right_arm_frame_1_2_of_motion_0, sums[35],
                    ),
            );
        let w_right_arm_frame_in_right_link_frame_1_2_of_motion_7 = w_right_arm_frame_in_right_link_frame_1_2_of_motion_2
            - w_right_arm_frame_in_right_link_frame_1_2_of_motion_5
            + w_right_arm_frame_in_right_link_frame_1_2_of_motion_6
            - w_right_arm_frame_in_right_link_frame_1_2_of_motion_3;
        let v_left_link_centre_2_2_of_place = w_left_arm_frame_in_left_link_frame_1_2_of_motion_7
            .mul_add(l, weight * w_spindle_frame_in_left_arm_frame_1_2_of_motion);
        let v_right_link_centre_2_2_of_place = w_right_arm_frame_in_right_link_frame_1_2_of_motion_7
            .mul_add(l, weight * w_spindle_frame_in_right_arm_frame_1_2_of_motion);
        let p_w_right_arm_frame_in_right_link_frame_1_2_of_place = v_right_link_centre_2_2_of_place
            .mul_add(
                weight_2,
                l_2_m * w_right_arm_frame_in_right_link_frame_1_2_of_motion_7,
            );
        let p_w_left_arm_frame_in_left_link_frame_1_2_of_place = v_left_link_centre_2_2_of_place
            .mul_add(
                weight_2,
                l_2_m * w_left_arm_frame_in_left_link_frame_1_2_of_motion_7,
            );
        let p_w_spindle_frame_in_right_arm_frame_3_2_of_motion = p_w_right_arm_frame_in_right_link_frame_1_of_place
            .mul_add(
                w_right_arm_frame_in_right_link_frame_1_2_of_motion_0,
                w_right_arm_frame_in_right_link_frame_1_2_of_motion
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_of_place_0, sums[36],
                    ),
            );
        let p_w_spindle_frame_in_right_arm_frame_3_2_of_place = p_w_right_arm_frame_in_right_link_frame_1_2_of_place
            .mul_add(
                sin_q_right_ball_0,
                sin_q_right_ball
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_2_of_place_0, sums[37],
                    ),
            );
        let p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_2 = p_w_spindle_frame_in_right_arm_frame_3_2_of_motion
            + p_w_spindle_frame_in_right_arm_frame_3_2_of_place;
        let p_w_spindle_frame_in_right_arm_frame_1_2_of_motion = p_w_right_arm_frame_in_right_link_frame_1_of_place
            .mul_add(
                w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_0,
                w_right_arm_frame_in_right_link_frame_1_2_of_motion_4
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_of_place_0, sums[38],
                    ),
            );
        let p_w_spindle_frame_in_right_arm_frame_1_2_of_place = p_w_right_arm_frame_in_right_link_frame_1_2_of_place
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_2_of_place_0, sums[39],
                    ),
            );
        let p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_2 = v_right_link_centre_2_2_of_place
            .mul_add(
                weight_4,
                weight_3 * w_spindle_frame_in_right_arm_frame_1_2_of_motion,
            ) - p_w_spindle_frame_in_right_arm_frame_1_2_of_motion
            + p_w_spindle_frame_in_right_arm_frame_1_2_of_place;
        let p_w_spindle_frame_in_left_arm_frame_3_2_of_motion = p_w_left_arm_frame_in_left_link_frame_1_of_place
            .mul_add(
                w_left_arm_frame_in_left_link_frame_1_2_of_motion_0,
                w_left_arm_frame_in_left_link_frame_1_2_of_motion
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_of_place_0, sums[40],
                    ),
            );
        let p_w_spindle_frame_in_left_arm_frame_3_2_of_place = p_w_left_arm_frame_in_left_link_frame_1_2_of_place
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_2_of_place_0, sums[41],
                    ),
            );
        let p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_2 = p_w_spindle_frame_in_left_arm_frame_3_2_of_motion
            + p_w_spindle_frame_in_left_arm_frame_3_2_of_place;
        let p_w_spindle_frame_in_left_arm_frame_1_2_of_motion = p_w_left_arm_frame_in_left_link_frame_1_of_place
            .mul_add(
                w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_0,
                w_left_arm_frame_in_left_link_frame_1_2_of_motion_4
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_of_place_0, sums[42],
                    ),
            );
        let p_w_spindle_frame_in_left_arm_frame_1_2_of_place = p_w_left_arm_frame_in_left_link_frame_1_2_of_place
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_2_of_place_0, sums[43],
                    ),
            );
        let p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2 = v_left_link_centre_2_2_of_place
            .mul_add(
                weight_4,
                weight_3 * w_spindle_frame_in_left_arm_frame_1_2_of_motion,
            ) - p_w_spindle_frame_in_left_arm_frame_1_2_of_motion
            + p_w_spindle_frame_in_left_arm_frame_1_2_of_place;
        let w_left_link_frame_2_of_motion = theta_dot + q_left_ball_dot;
        let x_N_3_of_place = l_m * cos_q_left_ball;
        let v_left_arm_frame_in_left_link_frame_1_of_theta_dot = cos_q_left_ball
            .mul_add(theta_dot_0, theta_dot.mul_add(cos_q_left_ball_0, sums[44]));
        let v_left_arm_frame_in_left_link_frame_3_of_theta_dot = sin_q_left_ball
            .mul_add(theta_dot_0, theta_dot.mul_add(sin_q_left_ball_0, sums[45]));
        let v_left_link_centre_1_of_place = v_left_arm_frame_in_left_link_frame_1_of_theta_dot
            .mul_add(weight, l * w_left_link_frame_2_of_motion);
        let v_left_arm_frame_in_left_link_frame_1_2_of_motion = w_left_arm_frame_in_left_link_frame_1_2_of_motion_4
            .mul_add(
                theta_dot_0,
                theta_dot
                    .mul_add(
                        w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_0, sums[46],
                    ),
            );
        let v_left_arm_frame_in_left_link_frame_3_2_of_motion = w_left_arm_frame_in_left_link_frame_1_2_of_motion
            .mul_add(
                theta_dot_0,
                theta_dot
                    .mul_add(
                        w_left_arm_frame_in_left_link_frame_1_2_of_motion_0, sums[47],
                    ),
            );
        let theta_plus_q_left_ball = theta + q_left_ball;
        let sin_theta_plus_q_left_ball = theta_plus_q_left_ball
            .mul_add(cos_theta_plus_q_left_ball_0, sums[48] * over_k);
        let cos_theta_plus_q_left_ball = -theta_plus_q_left_ball
            .mul_add(sin_theta_plus_q_left_ball_0, sums[49] * over_k);
        let theta_dot_sq = theta_dot.mul_add(theta_dot_0 + theta_dot_0, sums[50]);
        let theta_dot_sq_cos_theta = theta_dot_sq
            .mul_add(cos_theta_0, cos_theta.mul_add(theta_dot_sq_0, sums[51]));
        let v_sleeve_centre_3_of_motion = w_left_link_frame_2_of_motion
            .mul_add(
                w_left_link_frame_2_of_motion_0 + w_left_link_frame_2_of_motion_0,
                sums[52],
            );
        let v_sleeve_centre_3_of_motion_2 = v_sleeve_centre_3_of_motion
            .mul_add(
                cos_theta_plus_q_left_ball_0,
                cos_theta_plus_q_left_ball
                    .mul_add(v_sleeve_centre_3_of_motion_0, sums[53]),
            );
        let v_sleeve_centre_3_of_motion_3 = theta_dot_sq_cos_theta + v_sleeve_centre_3_of_motion_2;
        let x_N_3_2_of_place = l_m * cos_q_right_ball;
        let v_right_arm_frame_in_right_link_frame_1_of_motion = cos_q_right_ball
            .mul_add(
                q_right_top_dot_0,
                q_right_top_dot.mul_add(cos_q_right_ball_0, sums[54]),
            );
        let v_right_arm_frame_in_right_link_frame_3_of_motion = sin_q_right_ball
            .mul_add(
                q_right_top_dot_0,
                q_right_top_dot.mul_add(sin_q_right_ball_0, sums[55]),
            );
        let v_right_link_centre_1_of_place = v_right_arm_frame_in_right_link_frame_1_of_motion
            .mul_add(weight, q_right_ball_dot.mul_add(l, l * q_right_top_dot));
        let v_right_arm_frame_in_right_link_frame_1_2_of_motion = w_right_arm_frame_in_right_link_frame_1_2_of_motion_4
            .mul_add(
                q_right_top_dot_0,
                q_right_top_dot
                    .mul_add(
                        w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_0, sums[56],
                    ),
            );
        let v_right_arm_frame_in_right_link_frame_3_2_of_motion = w_right_arm_frame_in_right_link_frame_1_2_of_motion
            .mul_add(
                q_right_top_dot_0,
                q_right_top_dot
                    .mul_add(
                        w_right_arm_frame_in_right_link_frame_1_2_of_motion_0, sums[57],
                    ),
            );
        let w_left_arm_frame_in_left_link_frame_1_3_of_place = sin_q_left_ball
            .mul_add(cos_theta_0, cos_theta.mul_add(sin_q_left_ball_0, sums[58]));
        let w_left_arm_frame_in_left_link_frame_1_3_of_place_2 = cos_q_left_ball
            .mul_add(sin_theta_0, sin_theta.mul_add(cos_q_left_ball_0, sums[59]));
        let w_left_arm_frame_in_left_link_frame_1_3_of_place_3 = w_left_arm_frame_in_left_link_frame_1_3_of_place
            + w_left_arm_frame_in_left_link_frame_1_3_of_place_2;
        let w_right_arm_frame_in_right_link_frame_1_3_of_place = sin_q_right_ball
            .mul_add(
                cos_q_right_top_0,
                cos_q_right_top.mul_add(sin_q_right_ball_0, sums[60]),
            );
        let w_right_arm_frame_in_right_link_frame_1_3_of_place_2 = cos_q_right_ball
            .mul_add(
                sin_q_right_top_0,
                sin_q_right_top.mul_add(cos_q_right_ball_0, sums[61]),
            );
        let w_right_arm_frame_in_right_link_frame_1_3_of_place_3 = w_right_arm_frame_in_right_link_frame_1_3_of_place
            + w_right_arm_frame_in_right_link_frame_1_3_of_place_2;
        let v_left_link_centre_2_3_of_place = w_left_arm_frame_in_left_link_frame_1_3_of_place_3
            .mul_add(l, weight * sin_theta);
        let v_right_link_centre_2_3_of_place = w_right_arm_frame_in_right_link_frame_1_3_of_place_3
            .mul_add(l, weight * sin_q_right_top);
        let p_w_right_arm_frame_in_right_link_frame_1_3_of_place = v_right_link_centre_2_3_of_place
            .mul_add(
                weight_2,
                l_2_m * w_right_arm_frame_in_right_link_frame_1_3_of_place_3,
            );
        let p_w_left_arm_frame_in_left_link_frame_1_3_of_place = v_left_link_centre_2_3_of_place
            .mul_add(
                weight_2,
                l_2_m * w_left_arm_frame_in_left_link_frame_1_3_of_place_3,
            );
        let p_w_spindle_frame_in_right_arm_frame_3_3_of_place = p_w_right_arm_frame_in_right_link_frame_1_3_of_place
            .mul_add(
                sin_q_right_ball_0,
                sin_q_right_ball
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_3_of_place_0, sums[62],
                    ),
            );
        let p_w_spindle_frame_in_right_arm_frame_1_3_of_place = p_w_right_arm_frame_in_right_link_frame_1_3_of_place
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_3_of_place_0, sums[63],
                    ),
            );
        let p_w_spindle_frame_in_right_arm_frame_1_3_of_place_2 = v_right_link_centre_2_3_of_place
            .mul_add(weight_4, weight_3 * sin_q_right_top)
            + p_w_spindle_frame_in_right_arm_frame_1_3_of_place;
        let p_w_spindle_frame_in_left_arm_frame_3_3_of_place = p_w_left_arm_frame_in_left_link_frame_1_3_of_place
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_3_of_place_0, sums[64],
                    ),
            );
        let p_w_spindle_frame_in_left_arm_frame_1_3_of_place = p_w_left_arm_frame_in_left_link_frame_1_3_of_place
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_3_of_place_0, sums[65],
                    ),
            );
        let p_w_spindle_frame_in_left_arm_frame_1_3_of_place_2 = v_left_link_centre_2_3_of_place
            .mul_add(weight_4, weight_3 * sin_theta)
            + p_w_spindle_frame_in_left_arm_frame_1_3_of_place;
        let v_left_link_centre_1_2_of_place = weight * cos_q_left_ball;
        let v_sleeve_centre_3_2_of_place = sin_theta + sin_theta_plus_q_left_ball;
        let v_right_link_centre_1_2_of_place = weight * cos_q_right_ball;
        let d1_of_place = p_w_spindle_frame_in_right_arm_frame_3_3_of_place
            .mul_add(
                cos_q_right_top_0,
                cos_q_right_top
                    .mul_add(
                        p_w_spindle_frame_in_right_arm_frame_3_3_of_place_0, sums[66],
                    ),
            );
        let d1_of_place_2 = p_w_spindle_frame_in_right_arm_frame_1_3_of_place_2
            .mul_add(
                sin_q_right_top_0,
                sin_q_right_top
                    .mul_add(
                        p_w_spindle_frame_in_right_arm_frame_1_3_of_place_2_0, sums[67],
                    ),
            );
        let d1_of_place_3 = p_w_spindle_frame_in_left_arm_frame_3_3_of_place
            .mul_add(
                cos_theta_0,
                cos_theta
                    .mul_add(
                        p_w_spindle_frame_in_left_arm_frame_3_3_of_place_0, sums[68],
                    ),
            );
        let d1_of_place_4 = p_w_spindle_frame_in_left_arm_frame_1_3_of_place_2
            .mul_add(
                sin_theta_0,
                sin_theta
                    .mul_add(
                        p_w_spindle_frame_in_left_arm_frame_1_3_of_place_2_0, sums[69],
                    ),
            );
        let d1_of_place_5 = d1_of_place_4
            .mul_add(
                S::ratio(1, 12),
                d1_of_place_2
                    .mul_add(
                        S::ratio(1, 12),
                        d1_of_place_3
                            .mul_add(S::ratio(1, 12), S::ratio(1, 12) * d1_of_place),
                    ),
            );
        let d2_of_place = q_right_top + q_right_ball;
        let sin_angle = d2_of_place.mul_add(cos_angle_0, sums[70] * over_k);
        let cos_angle = -d2_of_place.mul_add(sin_angle_0, sums[71] * over_k);
        let d2_of_place_2 = sin_q_left_ball
            .mul_add(sin_theta_0, sin_theta.mul_add(sin_q_left_ball_0, sums[72]));
        let d2_of_place_3 = cos_theta + cos_theta_plus_q_left_ball;
        let d2_of_q_right_ball = cos_q_right_ball;
        let d2_of_place_4 = d2_of_q_right_ball
            .mul_add(
                cos_q_right_top_0,
                cos_q_right_top.mul_add(d2_of_q_right_ball_0, sums[73]),
            );
        let d2_of_place_5 = sin_q_right_ball
            .mul_add(
                sin_q_right_top_0,
                sin_q_right_top.mul_add(sin_q_right_ball_0, sums[74]),
            );
        let d2_of_place_6 = -d2_of_place_5 + d2_of_place_4;
        let d2_of_place_7 = cos_q_left_ball
            .mul_add(cos_theta_0, cos_theta.mul_add(cos_q_left_ball_0, sums[75]));
        let d2_of_place_8 = d2_of_place_2 - d2_of_place_7;
        let d2_of_place_9 = v_sleeve_centre_3_2_of_place
            .mul_add(
                v_sleeve_centre_3_2_of_place_0 + v_sleeve_centre_3_2_of_place_0,
                sums[76],
            );
        let sin_q_left_ball_sq = sin_q_left_ball
            .mul_add(sin_q_left_ball_0 + sin_q_left_ball_0, sums[77]);
        let d2_of_place_10 = v_left_link_centre_1_2_of_place
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball.mul_add(v_left_link_centre_1_2_of_place_0, sums[78]),
            );
        let d2_of_place_11 = v_sleeve_centre_3_2_of_place
            .mul_add(
                sin_theta_plus_q_left_ball_0,
                sin_theta_plus_q_left_ball
                    .mul_add(v_sleeve_centre_3_2_of_place_0, sums[79]),
            );
        let sin_q_right_ball_sq = sin_q_right_ball
            .mul_add(sin_q_right_ball_0 + sin_q_right_ball_0, sums[80]);
        let d2_of_place_12 = v_right_link_centre_1_2_of_place
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball.mul_add(v_right_link_centre_1_2_of_place_0, sums[81]),
            );
        let d2_of_place_13 = d2_of_place_11
            .mul_add(weight_7, weight_8 * cos_q_left_ball);
        let d2_of_place_14 = d2_of_place_3
            .mul_add(
                over_cos_theta_plus_q_left_ball,
                -(cos_theta_plus_q_left_ball.mul_add(d2_of_place_14_0, sums[82])
                    * over_cos_theta_plus_q_left_ball),
            );
        let d2_of_place_15 = d2_of_place_13
            .mul_add(
                d2_of_place_14_0,
                d2_of_place_14.mul_add(d2_of_place_13_0, sums[83]),
            );
        let d2_of_place_16 = d2_of_place_12
            .mul_add(
                weight_4,
                sin_q_right_ball_sq
                    .mul_add(weight_10, weight_2 * v_right_link_centre_1_2_of_place),
            );
        let d2_of_place_17 = cos_theta_plus_q_left_ball
            .mul_add(
                sin_q_right_ball_0,
                sin_q_right_ball.mul_add(cos_theta_plus_q_left_ball_0, sums[84]),
            );
        let d2_of_place_18 = d2_of_place_17
            .mul_add(
                -(d2_of_place_18_0 * over_d2_of_place_17),
                (sin_q_left_ball - sums[85]) * over_d2_of_place_17,
            );
        let d2_of_place_19 = d2_of_place_18
            .mul_add(cos_angle_0, cos_angle.mul_add(d2_of_place_18_0, sums[86]));
        let d2_of_place_20 = d2_of_place_19
            .mul_add(
                d2_of_place_16_0,
                d2_of_place_16.mul_add(d2_of_place_19_0, sums[87]),
            );
        let d2_of_place_21 = weight_8 * cos_q_right_ball;
        let d2_of_place_22 = d2_of_place_18
            .mul_add(d2_of_place_6_0, d2_of_place_6.mul_add(d2_of_place_18_0, sums[88]));
        let d2_of_place_23 = d2_of_place_22
            .mul_add(
                d2_of_place_21_0,
                d2_of_place_21.mul_add(d2_of_place_22_0, sums[89]),
            );
        let d2_of_place_24 = w_left_arm_frame_in_left_link_frame_1_3_of_place_2
            .mul_add(l_m, weight_11 * sin_theta_plus_q_left_ball);
        let d2_of_place_25 = d2_of_place_24
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(d2_of_place_24_0, sums[90]),
            );
        let d2_of_place_26 = d2_of_place_7
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball.mul_add(d2_of_place_7_0, sums[91]),
            );
        let d2_of_place_27 = d2_of_place_25
            .mul_add(
                weight_12,
                d2_of_place_26.mul_add(minus_6_l_2_m, weight_6 * cos_theta),
            );
        let d2_of_place_28 = cos_angle
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball.mul_add(cos_angle_0, sums[92]),
            );
        let d2_of_place_29 = d2_of_place_28
            .mul_add(
                weight_8,
                d2_of_place_4.mul_add(minus_4_l_2_m, weight_6 * cos_angle),
            );
        let d2_of_place_30 = d2_of_place_29
            .mul_add(
                over_sin_q_right_ball,
                -(sin_q_right_ball.mul_add(d2_of_place_30_0, sums[93]) * over_sin_q_right_ball),
            );
        let d2_of_place_31 = weight_6 * sin_q_right_top + d2_of_place_30;
        let d2_of_place_32 = d2_of_place_20 - d2_of_place_23;
        let d2_of_place_33 = d2_of_place_32
            .mul_add(
                d2_of_place_19_0,
                d2_of_place_19.mul_add(d2_of_place_32_0, sums[94]),
            );
        let d2_of_place_34 = d2_of_place_27
            .mul_add(
                over_d2_of_place_8,
                -(d2_of_place_8.mul_add(d2_of_place_34_0, sums[95]) * over_d2_of_place_8),
            );
        let d2_of_place_35 = d2_of_place_34
            .mul_add(
                d2_of_place_14_0,
                d2_of_place_14.mul_add(d2_of_place_34_0, sums[96]),
            );
        let d2_of_place_36 = cos_theta_plus_q_left_ball
            .mul_add(
                -(d2_of_place_36_0 * over_cos_theta_plus_q_left_ball),
                (sin_q_left_ball - sums[97]) * over_cos_theta_plus_q_left_ball,
            );
        let d2_of_place_37 = d2_of_place_31
            .mul_add(
                d2_of_place_36_0,
                d2_of_place_36.mul_add(d2_of_place_31_0, sums[98]),
            );
        let d2_of_place_38 = d2_of_place_37
            .mul_add(
                d2_of_place_22_0,
                d2_of_place_22.mul_add(d2_of_place_37_0, sums[99]),
            );
        let d2_of_place_39 = d2_of_place_33
            .mul_add(
                S::ratio(1, 12),
                d2_of_place_38
                    .mul_add(
                        -S::ratio(1, 12),
                        d2_of_place_35
                            .mul_add(
                                -S::ratio(1, 12),
                                d2_of_place_15
                                    .mul_add(
                                        -S::ratio(1, 12),
                                        d2_of_place_9
                                            .mul_add(
                                                l_2_ms,
                                                d2_of_place_10
                                                    .mul_add(
                                                        l_m_by_2,
                                                        sin_q_left_ball_sq
                                                            .mul_add(l_2_m, l_m_by_4 * v_left_link_centre_1_2_of_place),
                                                    ),
                                            ),
                                    ),
                            ),
                    ),
            );
        let opening_dot_of_place = d2_of_q_right_ball
            .mul_add(
                sin_q_right_top_0,
                sin_q_right_top.mul_add(d2_of_q_right_ball_0, sums[100]),
            );
        let opening_dot_of_place_2 = d2_of_place_7
            .mul_add(
                d2_of_q_right_ball_0,
                d2_of_q_right_ball.mul_add(d2_of_place_7_0, sums[101]),
            );
        let opening_dot_of_q_right_ball = d2_of_q_right_ball
            .mul_add(
                over_sin_q_right_ball,
                -(sin_q_right_ball.mul_add(opening_dot_of_q_right_ball_0, sums[102])
                    * over_sin_q_right_ball),
            );
        let opening_dot_of_place_3 = opening_dot_of_q_right_ball
            .mul_add(
                cos_q_right_top_0,
                cos_q_right_top.mul_add(opening_dot_of_q_right_ball_0, sums[103]),
            );
        let opening_dot_of_place_4 = sin_q_right_top - opening_dot_of_place_3;
        let opening_dot_of_place_5 = opening_dot_of_q_right_ball
            .mul_add(
                cos_angle_0,
                cos_angle.mul_add(opening_dot_of_q_right_ball_0, sums[104]),
            );
        let opening_dot_of_place_6 = sin_angle + opening_dot_of_place_5;
        let opening_dot_of_place_7 = opening_dot_of_place_6
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball.mul_add(opening_dot_of_place_6_0, sums[105]),
            );
        let opening_dot_of_place_8 = sin_angle + opening_dot_of_place_7;
        let opening_dot_of_place_9 = opening_dot_of_place_8
            .mul_add(
                cos_q_right_top_0,
                cos_q_right_top.mul_add(opening_dot_of_place_8_0, sums[106]),
            );
        let opening_dot_of_place_10 = sin_angle
            + w_right_arm_frame_in_right_link_frame_1_3_of_place_2;
        let opening_dot_of_place_11 = opening_dot_of_place_10
            .mul_add(
                cos_angle_0,
                cos_angle.mul_add(opening_dot_of_place_10_0, sums[107]),
            );
        let opening_dot_of_place_12 = -opening_dot_of_place_11 + opening_dot_of_place_9;
        let opening_dot_of_place_13 = opening_dot_of_place_12
            .mul_add(
                over_sin_q_right_ball,
                -(sin_q_right_ball.mul_add(opening_dot_of_place_13_0, sums[108])
                    * over_sin_q_right_ball),
            );
        let opening_dot_of_place_14 = sin_angle
            .mul_add(sin_q_right_top_0, sin_q_right_top.mul_add(sin_angle_0, sums[109]));
        let opening_dot_of_place_15 = -opening_dot_of_place_14 + opening_dot_of_place_13;
        let opening_dot_of_place_16 = opening_dot_of_place_15
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(opening_dot_of_place_15_0, sums[110]),
            );
        let opening_dot_of_place_17 = cos_theta_plus_q_left_ball
            .mul_add(
                -(opening_dot_of_place_17_0 * over_cos_theta_plus_q_left_ball),
                (sin_theta_plus_q_left_ball - sums[111]) * over_cos_theta_plus_q_left_ball,
            );
        let opening_dot_of_place_18 = opening_dot_of_place_17
            .mul_add(
                cos_theta_0,
                cos_theta.mul_add(opening_dot_of_place_17_0, sums[112]),
            );
        let opening_dot_of_place_19 = opening_dot_of_place_18
            .mul_add(
                cos_angle_0,
                cos_angle.mul_add(opening_dot_of_place_18_0, sums[113]),
            );
        let opening_dot_of_place_20 = -opening_dot_of_place_19 + opening_dot_of_place_16;
        let opening_dot_of_place_21 = opening_dot_of_place_20
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(opening_dot_of_place_20_0, sums[114]),
            );
        let opening_dot_of_place_22 = d2_of_place_7
            .mul_add(cos_angle_0, cos_angle.mul_add(d2_of_place_7_0, sums[115]));
        let opening_dot_of_place_23 = -opening_dot_of_place_22 + opening_dot_of_place_21;
        let opening_dot_of_place_24 = opening_dot_of_place_23
            .mul_add(
                over_cos_theta_plus_q_left_ball,
                -(cos_theta_plus_q_left_ball
                    .mul_add(opening_dot_of_place_24_0, sums[116])
                    * over_cos_theta_plus_q_left_ball),
            );
        let opening_dot_of_place_25 = cos_angle
            .mul_add(cos_q_left_ball_0, cos_q_left_ball.mul_add(cos_angle_0, sums[117]));
        let opening_dot_of_place_26 = -opening_dot_of_place_25 + opening_dot_of_place_24;
        let opening_dot_of_place_27 = cos_theta_plus_q_left_ball
            .mul_add(
                -(opening_dot_of_place_27_0 * over_cos_theta_plus_q_left_ball),
                (cos_theta - sums[118]) * over_cos_theta_plus_q_left_ball,
            );
        let opening_dot_of_place_28 = opening_dot_of_place_18
            .mul_add(
                opening_dot_of_place_27_0,
                opening_dot_of_place_27.mul_add(opening_dot_of_place_18_0, sums[119]),
            );
        let opening_dot_of_place_29 = sin_theta + opening_dot_of_place_28;
        let opening_dot_of_place_30 = opening_dot_of_place_3
            .mul_add(-S::int(2), opening_dot_of_place);
        let opening_dot_of_place_31 = opening_dot_of_place_30
            .mul_add(
                over_sin_q_right_ball,
                -(sin_q_right_ball.mul_add(opening_dot_of_place_31_0, sums[120])
                    * over_sin_q_right_ball),
            );
        let opening_dot_of_place_32 = cos_q_right_top + cos_angle + opening_dot_of_place_31;
        let opening_dot_of_place_33 = opening_dot_of_place_32
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(opening_dot_of_place_32_0, sums[121]),
            );
        let opening_dot_of_place_34 = opening_dot_of_place_18
            .mul_add(
                d2_of_q_right_ball_0,
                d2_of_q_right_ball.mul_add(opening_dot_of_place_18_0, sums[122]),
            );
        let opening_dot_of_place_35 = opening_dot_of_place_34 + opening_dot_of_place_33;
        let opening_dot_of_place_36 = opening_dot_of_place_35
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(opening_dot_of_place_35_0, sums[123]),
            );
        let opening_dot_of_place_37 = opening_dot_of_place_2 + opening_dot_of_place_36;
        let opening_dot_of_place_38 = opening_dot_of_place_37
            .mul_add(
                cos_q_right_top_0,
                cos_q_right_top.mul_add(opening_dot_of_place_37_0, sums[124]),
            );
        let sin_q_left_ball_sq_2 = sin_q_left_ball
            .mul_add(sin_q_left_ball_0 + sin_q_left_ball_0, sums[125]);
        let opening_dot_of_place_39 = sin_q_left_ball_sq_2
            .mul_add(
                sin_q_right_top_0,
                sin_q_right_top.mul_add(sin_q_left_ball_sq_2_0, sums[126]),
            );
        let opening_dot_of_place_40 = opening_dot_of_place_5
            .mul_add(
                opening_dot_of_place_39_0,
                opening_dot_of_place_39.mul_add(opening_dot_of_place_5_0, sums[127]),
            );
        let opening_dot_of_place_41 = opening_dot_of_place_40 + opening_dot_of_place_38;
        let opening_dot_of_place_42 = opening_dot_of_place_41
            .mul_add(
                over_sin_q_right_ball,
                -(sin_q_right_ball.mul_add(opening_dot_of_place_42_0, sums[128])
                    * over_sin_q_right_ball),
            );
        let opening_dot_of_place_43 = opening_dot_of_place_17
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(opening_dot_of_place_17_0, sums[129]),
            );
        let opening_dot_of_place_44 = cos_q_left_ball + opening_dot_of_place_43;
        let opening_dot_of_place_45 = sin_q_right_top
            .mul_add(cos_theta_0, cos_theta.mul_add(sin_q_right_top_0, sums[130]));
        let opening_dot_of_place_46 = opening_dot_of_place_44
            .mul_add(
                opening_dot_of_place_45_0,
                opening_dot_of_place_45.mul_add(opening_dot_of_place_44_0, sums[131]),
            );
        let opening_dot_of_place_47 = -opening_dot_of_place_46 + opening_dot_of_place_42;
        let opening_dot_of_place_48 = opening_dot_of_place_47
            .mul_add(
                over_cos_theta_plus_q_left_ball,
                -(cos_theta_plus_q_left_ball
                    .mul_add(opening_dot_of_place_48_0, sums[132])
                    * over_cos_theta_plus_q_left_ball),
            );
        let opening_dot_of_place_49 = opening_dot_of_place_4
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball.mul_add(opening_dot_of_place_4_0, sums[133]),
            );
        let opening_dot_of_place_50 = -opening_dot_of_place_49 + opening_dot_of_place_48;
        let opening_dot_of_place_51 = p_w_spindle_frame_in_left_arm_frame_3_of_place
            .mul_add(
                sin_theta_0,
                sin_theta
                    .mul_add(p_w_spindle_frame_in_left_arm_frame_3_of_place_0, sums[134]),
            );
        let opening_dot_of_place_52 = p_w_spindle_frame_in_left_arm_frame_1_of_place_2
            .mul_add(
                cos_theta_0,
                cos_theta
                    .mul_add(
                        p_w_spindle_frame_in_left_arm_frame_1_of_place_2_0, sums[135],
                    ),
            );
        let opening_dot_of_place_53 = opening_dot_of_place_51 - opening_dot_of_place_52;
        let opening_dot_of_place_54 = p_w_spindle_frame_in_right_arm_frame_3_of_place
            .mul_add(
                sin_q_right_top_0,
                sin_q_right_top
                    .mul_add(
                        p_w_spindle_frame_in_right_arm_frame_3_of_place_0, sums[136],
                    ),
            );
        let opening_dot_of_place_55 = p_w_spindle_frame_in_right_arm_frame_1_of_place_2
            .mul_add(
                cos_q_right_top_0,
                cos_q_right_top
                    .mul_add(
                        p_w_spindle_frame_in_right_arm_frame_1_of_place_2_0, sums[137],
                    ),
            );
        let opening_dot_of_place_56 = opening_dot_of_place_54 - opening_dot_of_place_55;
        let opening_dot_of_place_57 = x_N_3_of_place
            .mul_add(sin_theta_0, sin_theta.mul_add(x_N_3_of_place_0, sums[138]));
        let opening_dot_of_place_58 = sin_q_left_ball
            .mul_add(cos_theta_0, cos_theta.mul_add(sin_q_left_ball_0, sums[139]));
        let opening_dot_of_place_59 = v_left_link_centre_1_of_place
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(v_left_link_centre_1_of_place_0, sums[140]),
            );
        let opening_dot_of_theta_dot = v_left_arm_frame_in_left_link_frame_3_of_theta_dot
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball
                    .mul_add(
                        v_left_arm_frame_in_left_link_frame_3_of_theta_dot_0, sums[141],
                    ),
            );
        let opening_dot_of_place_60 = opening_dot_of_place_59
            .mul_add(m, minus_2_l_m * opening_dot_of_theta_dot);
        let opening_dot_of_motion = opening_dot_of_place_60
            .mul_add(
                q_left_ball_dot_0,
                q_left_ball_dot.mul_add(opening_dot_of_place_60_0, sums[142]),
            );
        let opening_dot_of_motion_2 = v_sleeve_centre_3_of_motion_3
            .mul_add(
                v_sleeve_centre_3_2_of_place_0,
                v_sleeve_centre_3_2_of_place
                    .mul_add(v_sleeve_centre_3_of_motion_3_0, sums[143]),
            );
        let opening_dot_of_motion_3 = v_left_arm_frame_in_left_link_frame_3_2_of_motion
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball
                    .mul_add(
                        v_left_arm_frame_in_left_link_frame_3_2_of_motion_0, sums[144],
                    ),
            );
        let opening_dot_of_motion_4 = v_left_arm_frame_in_left_link_frame_1_2_of_motion
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball
                    .mul_add(
                        v_left_arm_frame_in_left_link_frame_1_2_of_motion_0, sums[145],
                    ),
            );
        let opening_dot_of_psi_dot = opening_dot_of_place_53
            .mul_add(psi_dot_0, psi_dot.mul_add(opening_dot_of_place_53_0, sums[146]));
        let opening_dot_of_place_61 = x_N_3_2_of_place
            .mul_add(
                sin_q_right_top_0,
                sin_q_right_top.mul_add(x_N_3_2_of_place_0, sums[147]),
            );
        let opening_dot_of_place_62 = sin_q_right_ball
            .mul_add(
                cos_q_right_top_0,
                cos_q_right_top.mul_add(sin_q_right_ball_0, sums[148]),
            );
        let opening_dot_of_place_63 = v_right_link_centre_1_of_place
            .mul_add(
                sin_q_right_ball_0,
                sin_q_right_ball.mul_add(v_right_link_centre_1_of_place_0, sums[149]),
            );
        let opening_dot_of_motion_5 = v_right_arm_frame_in_right_link_frame_3_of_motion
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball
                    .mul_add(
                        v_right_arm_frame_in_right_link_frame_3_of_motion_0, sums[150],
                    ),
            );
        let opening_dot_of_place_64 = opening_dot_of_place_63
            .mul_add(m, minus_2_l_m * opening_dot_of_motion_5);
        let opening_dot_of_motion_6 = opening_dot_of_place_64
            .mul_add(
                q_right_ball_dot_0,
                q_right_ball_dot.mul_add(opening_dot_of_place_64_0, sums[151]),
            );
        let opening_dot_of_motion_7 = v_right_arm_frame_in_right_link_frame_3_2_of_motion
            .mul_add(
                sin_q_right_ball_0,
                sin_q_right_ball
                    .mul_add(
                        v_right_arm_frame_in_right_link_frame_3_2_of_motion_0, sums[152],
                    ),
            );
        let opening_dot_of_motion_8 = v_right_arm_frame_in_right_link_frame_1_2_of_motion
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball
                    .mul_add(
                        v_right_arm_frame_in_right_link_frame_1_2_of_motion_0, sums[153],
                    ),
            );
        let opening_dot_of_psi_dot_2 = opening_dot_of_place_56
            .mul_add(psi_dot_0, psi_dot.mul_add(opening_dot_of_place_56_0, sums[154]));
        let opening_dot_of_theta_dot_2 = opening_dot_of_place_60
            .mul_add(
                theta_dot_0,
                theta_dot.mul_add(opening_dot_of_place_60_0, sums[155]),
            );
        let opening_dot_of_place_65 = l_ms * v_sleeve_centre_3_of_motion_3;
        let opening_dot_of_place_66 = opening_dot_of_place_65
            .mul_add(
                sin_theta_plus_q_left_ball_0,
                sin_theta_plus_q_left_ball.mul_add(opening_dot_of_place_65_0, sums[156]),
            );
        let opening_dot_of_psi_dot_3 = p_w_left_arm_frame_in_left_link_frame_1_of_place
            .mul_add(
                psi_dot_sin_theta_0,
                psi_dot_sin_theta
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_of_place_0, sums[157],
                    ),
            );
        let opening_dot_of_place_67 = weight_14 * cos_theta + opening_dot_of_psi_dot_3;
        let opening_dot_of_place_68 = opening_dot_of_place_67
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(opening_dot_of_place_67_0, sums[158]),
            );
        let opening_dot_of_psi_dot_4 = p_w_left_arm_frame_in_left_link_frame_1_of_place
            .mul_add(
                psi_dot_cos_theta_0,
                psi_dot_cos_theta
                    .mul_add(
                        p_w_left_arm_frame_in_left_link_frame_1_of_place_0, sums[159],
                    ),
            );
        let opening_dot_of_place_69 = minus_6_l_m_g * sin_theta + opening_dot_of_psi_dot_4;
        let opening_dot_of_place_70 = opening_dot_of_place_69
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball.mul_add(opening_dot_of_place_69_0, sums[160]),
            );
        let opening_dot_of_motion_9 = v_right_link_centre_1_of_place
            .mul_add(
                q_right_top_dot_0,
                q_right_top_dot.mul_add(v_right_link_centre_1_of_place_0, sums[161]),
            );
        let opening_dot_of_psi_dot_5 = p_w_right_arm_frame_in_right_link_frame_1_of_place
            .mul_add(
                psi_dot_sin_q_right_top_0,
                psi_dot_sin_q_right_top
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_of_place_0, sums[162],
                    ),
            );
        let opening_dot_of_motion_10 = opening_dot_of_motion_9
            .mul_add(weight_4, weight_14 * cos_q_right_top) + opening_dot_of_psi_dot_5;
        let opening_dot_of_motion_11 = opening_dot_of_motion_10
            .mul_add(
                sin_q_right_ball_0,
                sin_q_right_ball.mul_add(opening_dot_of_motion_10_0, sums[163]),
            );
        let opening_dot_of_motion_12 = v_right_arm_frame_in_right_link_frame_3_of_motion
            .mul_add(
                q_right_top_dot_0,
                q_right_top_dot
                    .mul_add(
                        v_right_arm_frame_in_right_link_frame_3_of_motion_0, sums[164],
                    ),
            );
        let opening_dot_of_psi_dot_6 = p_w_right_arm_frame_in_right_link_frame_1_of_place
            .mul_add(
                psi_dot_cos_q_right_top_0,
                psi_dot_cos_q_right_top
                    .mul_add(
                        p_w_right_arm_frame_in_right_link_frame_1_of_place_0, sums[165],
                    ),
            );
        let opening_dot_of_motion_13 = opening_dot_of_motion_12
            .mul_add(weight_10, minus_6_l_m_g * sin_q_right_top) + opening_dot_of_psi_dot_6;
        let opening_dot_of_motion_14 = opening_dot_of_motion_13
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball.mul_add(opening_dot_of_motion_13_0, sums[166]),
            );
        let opening_dot_of_motion_15 = opening_dot_of_motion_6
            .mul_add(
                weight_12,
                opening_dot_of_motion_8
                    .mul_add(
                        weight_10,
                        opening_dot_of_motion_7
                            .mul_add(
                                minus_12_l_2_m,
                                v_right_arm_frame_in_right_link_frame_1_2_of_motion
                                    .mul_add(
                                        weight_8,
                                        opening_dot_of_place_61
                                            .mul_add(minus_6_g, minus_6_l_m_g * opening_dot_of_place_62),
                                    ),
                            ),
                    ),
            ) - opening_dot_of_psi_dot_2;
        let opening_dot_of_motion_16 = opening_dot_of_motion_15
            .mul_add(
                d2_of_place_19_0,
                d2_of_place_19.mul_add(opening_dot_of_motion_15_0, sums[167]),
            );
        let opening_dot_of_theta_dot_3 = opening_dot_of_theta_dot_2
            .mul_add(
                minus_6_l,
                opening_dot_of_place_66
                    .mul_add(
                        minus_12_l,
                        weight_8 * v_left_arm_frame_in_left_link_frame_1_2_of_motion,
                    ),
            ) + opening_dot_of_place_70 - opening_dot_of_place_68;
        let opening_dot_of_theta_dot_4 = opening_dot_of_theta_dot_3
            .mul_add(
                d2_of_place_14_0,
                d2_of_place_14.mul_add(opening_dot_of_theta_dot_3_0, sums[168]),
            );
        let opening_dot_of_motion_17 = weight_8
            * v_right_arm_frame_in_right_link_frame_1_2_of_motion
            + opening_dot_of_motion_14 - opening_dot_of_motion_11;
        let opening_dot_of_motion_18 = opening_dot_of_motion_17
            .mul_add(
                d2_of_place_22_0,
                d2_of_place_22.mul_add(opening_dot_of_motion_17_0, sums[169]),
            );
        let opening_dot_of_place_71 = opening_dot_of_place_26
            .mul_add(
                over_d2_of_place_17,
                -(d2_of_place_17.mul_add(opening_dot_of_place_71_0, sums[170])
                    * over_d2_of_place_17),
            );
        let opening_dot_of_theta_dot_5 = opening_dot_of_place_71
            .mul_add(
                theta_dot_sq_0,
                theta_dot_sq.mul_add(opening_dot_of_place_71_0, sums[171]),
            );
        let opening_dot_of_theta_dot_6 = opening_dot_of_theta_dot_5
            .mul_add(
                d2_of_place_32_0,
                d2_of_place_32.mul_add(opening_dot_of_theta_dot_5_0, sums[172]),
            );
        let opening_dot_of_theta_dot_7 = cos_theta_plus_q_left_ball
            .mul_add(
                -(opening_dot_of_theta_dot_7_0 * over_cos_theta_plus_q_left_ball),
                (theta_dot_sq - sums[173]) * over_cos_theta_plus_q_left_ball,
            );
        let opening_dot_of_theta_dot_8 = opening_dot_of_place_29
            .mul_add(
                opening_dot_of_theta_dot_7_0,
                opening_dot_of_theta_dot_7.mul_add(opening_dot_of_place_29_0, sums[174]),
            );
        let opening_dot_of_theta_dot_9 = opening_dot_of_theta_dot_8
            .mul_add(
                d2_of_place_34_0,
                d2_of_place_34.mul_add(opening_dot_of_theta_dot_8_0, sums[175]),
            );
        let opening_dot_of_theta_dot_10 = opening_dot_of_place_50
            .mul_add(
                opening_dot_of_theta_dot_7_0,
                opening_dot_of_theta_dot_7.mul_add(opening_dot_of_place_50_0, sums[176]),
            );
        let opening_dot_of_theta_dot_11 = opening_dot_of_theta_dot_10
            .mul_add(
                d2_of_place_37_0,
                d2_of_place_37.mul_add(opening_dot_of_theta_dot_10_0, sums[177]),
            );
        let opening_dot_of_motion_19 = opening_dot_of_motion
            .mul_add(
                weight_12,
                opening_dot_of_motion_4
                    .mul_add(
                        weight_10,
                        opening_dot_of_motion_3
                            .mul_add(
                                minus_12_l_2_m,
                                opening_dot_of_motion_2
                                    .mul_add(
                                        minus_12_l_2_ms,
                                        v_left_arm_frame_in_left_link_frame_1_2_of_motion
                                            .mul_add(
                                                weight_8,
                                                opening_dot_of_place_57
                                                    .mul_add(
                                                        minus_6_g,
                                                        v_sleeve_centre_3_2_of_place
                                                            .mul_add(
                                                                minus_12_l_ms_g,
                                                                minus_6_l_m_g * opening_dot_of_place_58,
                                                            ),
                                                    ),
                                            ),
                                    ),
                            ),
                    ),
            ) - opening_dot_of_theta_dot_9 - opening_dot_of_psi_dot
            - opening_dot_of_theta_dot_4 - opening_dot_of_motion_18
            + opening_dot_of_motion_16 - opening_dot_of_theta_dot_11 - opening_dot_of_theta_dot_6;
        let opening_dot_of_motion_20 = opening_dot_of_motion_19
            .mul_add(
                over_d2_of_place_39,
                -(d2_of_place_39.mul_add(opening_dot_of_motion_20_0, sums[178])
                    * over_d2_of_place_39),
            );
        let spin_dot_of_motion = p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_2
            .mul_add(
                cos_q_right_top_0,
                cos_q_right_top
                    .mul_add(
                        p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_2_0, sums[179],
                    ),
            );
        let spin_dot_of_motion_2 = p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_2
            .mul_add(
                sin_q_right_top_0,
                sin_q_right_top
                    .mul_add(
                        p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_2_0, sums[180],
                    ),
            );
        let spin_dot_of_motion_3 = p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_2
            .mul_add(
                cos_theta_0,
                cos_theta
                    .mul_add(
                        p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_2_0, sums[181],
                    ),
            );
        let spin_dot_of_motion_4 = p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2
            .mul_add(
                sin_theta_0,
                sin_theta
                    .mul_add(
                        p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2_0, sums[182],
                    ),
            );
        let spin_dot_of_theta_dot = opening_dot_of_place_53
            .mul_add(
                theta_dot_0,
                theta_dot.mul_add(opening_dot_of_place_53_0, sums[183]),
            );
        let spin_dot_of_motion_5 = opening_dot_of_place_56
            .mul_add(
                q_right_top_dot_0,
                q_right_top_dot.mul_add(opening_dot_of_place_56_0, sums[184]),
            );
        let spin_dot_of_motion_6 = spin_dot_of_motion + spin_dot_of_motion_2
            + spin_dot_of_motion_3 + spin_dot_of_motion_4 - spin_dot_of_theta_dot
            - spin_dot_of_motion_5;
        let spin_dot_of_motion_7 = spin_dot_of_motion_6
            .mul_add(
                over_d1_of_place_5,
                -(d1_of_place_5.mul_add(spin_dot_of_motion_7_0, sums[185]) * over_d1_of_place_5),
            );
        let q_right_top_ddot_of_motion = opening_dot_of_motion_20
            .mul_add(
                d2_of_place_19_0,
                d2_of_place_19.mul_add(opening_dot_of_motion_20_0, sums[186]),
            );
        let q_right_top_dot_dot = q_right_top_ddot_of_motion
            .mul_add(S::ratio(1, 12), opening_dot_of_theta_dot_5);
        let q_left_ball_ddot_of_motion = opening_dot_of_motion_20
            .mul_add(
                d2_of_place_14_0,
                d2_of_place_14.mul_add(opening_dot_of_motion_20_0, sums[187]),
            );
        let q_left_ball_dot_dot = q_left_ball_ddot_of_motion
            .mul_add(-S::ratio(1, 12), opening_dot_of_theta_dot_8);
        let q_right_ball_ddot_of_motion = opening_dot_of_motion_20
            .mul_add(
                d2_of_place_22_0,
                d2_of_place_22.mul_add(opening_dot_of_motion_20_0, sums[188]),
            );
        let q_right_ball_dot_dot = q_right_ball_ddot_of_motion
            .mul_add(-S::ratio(1, 12), opening_dot_of_theta_dot_10);
        psi_rate = psi_dot;
        theta_rate = theta_dot;
        q_right_top_rate = q_right_top_dot;
        q_left_ball_rate = q_left_ball_dot;
        q_right_ball_rate = q_right_ball_dot;
        psi_dot_rate = -S::ratio(1, 12) * spin_dot_of_motion_7;
        theta_dot_rate = S::ratio(1, 12) * opening_dot_of_motion_20;
        q_right_top_dot_rate = q_right_top_dot_dot;
        q_left_ball_dot_rate = q_left_ball_dot_dot;
        q_right_ball_dot_rate = q_right_ball_dot_dot;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * theta,
                count * theta,
                psi_dot, psi_dot,
                count * q_right_top,
                count * q_right_top,
                psi_dot, psi_dot,
                count * q_left_ball,
                count * q_left_ball,
                sin_q_left_ball, cos_q_left_ball,
                count * q_right_ball,
                count * q_right_ball,
                sin_q_right_ball, cos_q_right_ball, sin_q_right_ball, cos_q_right_ball,
                sin_q_left_ball, cos_q_left_ball, theta_dot, theta_dot, q_right_top_dot,
                q_right_top_dot, q_left_ball_dot, psi_dot_cos_theta, sin_q_left_ball,
                q_left_ball_dot, psi_dot_sin_theta, cos_q_left_ball, q_right_ball_dot,
                psi_dot_cos_q_right_top, sin_q_right_ball, q_right_ball_dot,
                psi_dot_sin_q_right_top, cos_q_right_ball,
                p_w_right_arm_frame_in_right_link_frame_1_of_place, sin_q_right_ball,
                p_w_right_arm_frame_in_right_link_frame_1_of_place, cos_q_right_ball,
                p_w_left_arm_frame_in_left_link_frame_1_of_place, sin_q_left_ball,
                p_w_left_arm_frame_in_left_link_frame_1_of_place, cos_q_left_ball, theta_dot,
                theta_dot, theta_dot, theta_dot,
                count * theta_plus_q_left_ball,
                count * theta_plus_q_left_ball,
                theta_dot, cos_theta, w_left_link_frame_2_of_motion, cos_theta_plus_q_left_ball,
                q_right_top_dot, q_right_top_dot, q_right_top_dot, q_right_top_dot, cos_theta,
                sin_theta, cos_q_right_top, sin_q_right_top, sin_q_right_ball, cos_q_right_ball,
                sin_q_left_ball, cos_q_left_ball, cos_q_right_top, sin_q_right_top, cos_theta,
                sin_theta,
                count * d2_of_place,
                count * d2_of_place,
                sin_theta, cos_q_right_top, sin_q_right_top, cos_theta,
                v_sleeve_centre_3_2_of_place, sin_q_left_ball, cos_q_left_ball,
                v_sleeve_centre_3_2_of_place, sin_q_right_ball, cos_q_right_ball,
                cos_theta_plus_q_left_ball, d2_of_place_13, cos_theta_plus_q_left_ball,
                d2_of_place_17, cos_angle, d2_of_place_16, d2_of_place_6, d2_of_place_21,
                sin_q_left_ball, cos_q_left_ball, cos_angle, sin_q_right_ball, d2_of_place_32,
                d2_of_place_8, d2_of_place_14, cos_theta_plus_q_left_ball, d2_of_place_31,
                d2_of_place_22, sin_q_right_top, d2_of_q_right_ball, sin_q_right_ball,
                cos_q_right_top, cos_angle, cos_q_right_ball, cos_q_right_top, cos_angle,
                sin_q_right_ball, sin_q_right_top, sin_q_left_ball, cos_theta_plus_q_left_ball,
                cos_theta, cos_angle, sin_q_left_ball, cos_angle, cos_theta_plus_q_left_ball,
                cos_q_left_ball, cos_theta_plus_q_left_ball, opening_dot_of_place_18,
                sin_q_right_ball, sin_q_left_ball, d2_of_q_right_ball, sin_q_left_ball,
                cos_q_right_top, sin_q_left_ball, sin_q_right_top, opening_dot_of_place_5,
                sin_q_right_ball, sin_q_left_ball, cos_theta, opening_dot_of_place_44,
                cos_theta_plus_q_left_ball, cos_q_left_ball, sin_theta, cos_theta, sin_q_right_top,
                cos_q_right_top, sin_theta, cos_theta, sin_q_left_ball, cos_q_left_ball,
                q_left_ball_dot, v_sleeve_centre_3_2_of_place, sin_q_left_ball, cos_q_left_ball,
                psi_dot, sin_q_right_top, cos_q_right_top, sin_q_right_ball, cos_q_right_ball,
                q_right_ball_dot, sin_q_right_ball, cos_q_right_ball, psi_dot, theta_dot,
                sin_theta_plus_q_left_ball, psi_dot_sin_theta, sin_q_left_ball, psi_dot_cos_theta,
                cos_q_left_ball, q_right_top_dot, psi_dot_sin_q_right_top, sin_q_right_ball,
                q_right_top_dot, psi_dot_cos_q_right_top, cos_q_right_ball,
                opening_dot_of_motion_15, opening_dot_of_theta_dot_3, opening_dot_of_motion_17,
                d2_of_place_17, theta_dot_sq, d2_of_place_32, cos_theta_plus_q_left_ball,
                opening_dot_of_place_29, opening_dot_of_theta_dot_8, opening_dot_of_place_50,
                opening_dot_of_theta_dot_10, d2_of_place_39, cos_q_right_top, sin_q_right_top,
                cos_theta, sin_theta, theta_dot, q_right_top_dot, d1_of_place_5,
                opening_dot_of_motion_20, opening_dot_of_motion_20, opening_dot_of_motion_20,
            ]),
            padded([
                cos_theta, sin_theta, sin_theta, cos_theta, cos_q_right_top, sin_q_right_top,
                sin_q_right_top, cos_q_right_top, cos_q_left_ball, sin_q_left_ball,
                psi_dot_cos_theta, psi_dot_sin_theta, cos_q_right_ball, sin_q_right_ball,
                psi_dot_cos_q_right_top, psi_dot_sin_q_right_top,
                p_w_right_arm_frame_in_right_link_frame_1_of_place,
                p_w_right_arm_frame_in_right_link_frame_1_of_place,
                p_w_left_arm_frame_in_left_link_frame_1_of_place,
                p_w_left_arm_frame_in_left_link_frame_1_of_place, psi_dot_cos_theta,
                psi_dot_sin_theta, psi_dot_cos_q_right_top, psi_dot_sin_q_right_top,
                cos_q_left_ball, w_left_arm_frame_in_left_link_frame_1_2_of_motion,
                w_spindle_frame_in_left_arm_frame_3_2_of_motion, sin_q_left_ball,
                w_left_arm_frame_in_left_link_frame_1_2_of_motion_4,
                w_spindle_frame_in_left_arm_frame_1_2_of_motion, cos_q_right_ball,
                w_right_arm_frame_in_right_link_frame_1_2_of_motion,
                w_spindle_frame_in_right_arm_frame_3_2_of_motion, sin_q_right_ball,
                w_right_arm_frame_in_right_link_frame_1_2_of_motion_4,
                w_spindle_frame_in_right_arm_frame_1_2_of_motion,
                w_right_arm_frame_in_right_link_frame_1_2_of_motion,
                p_w_right_arm_frame_in_right_link_frame_1_2_of_place,
                w_right_arm_frame_in_right_link_frame_1_2_of_motion_4,
                p_w_right_arm_frame_in_right_link_frame_1_2_of_place,
                w_left_arm_frame_in_left_link_frame_1_2_of_motion,
                p_w_left_arm_frame_in_left_link_frame_1_2_of_place,
                w_left_arm_frame_in_left_link_frame_1_2_of_motion_4,
                p_w_left_arm_frame_in_left_link_frame_1_2_of_place, cos_q_left_ball,
                sin_q_left_ball, w_left_arm_frame_in_left_link_frame_1_2_of_motion_4,
                w_left_arm_frame_in_left_link_frame_1_2_of_motion, cos_theta_plus_q_left_ball,
                sin_theta_plus_q_left_ball, theta_dot, theta_dot_sq, w_left_link_frame_2_of_motion,
                v_sleeve_centre_3_of_motion, cos_q_right_ball, sin_q_right_ball,
                w_right_arm_frame_in_right_link_frame_1_2_of_motion_4,
                w_right_arm_frame_in_right_link_frame_1_2_of_motion, sin_q_left_ball,
                cos_q_left_ball, sin_q_right_ball, cos_q_right_ball,
                p_w_right_arm_frame_in_right_link_frame_1_3_of_place,
                p_w_right_arm_frame_in_right_link_frame_1_3_of_place,
                p_w_left_arm_frame_in_left_link_frame_1_3_of_place,
                p_w_left_arm_frame_in_left_link_frame_1_3_of_place,
                p_w_spindle_frame_in_right_arm_frame_3_3_of_place,
                p_w_spindle_frame_in_right_arm_frame_1_3_of_place_2,
                p_w_spindle_frame_in_left_arm_frame_3_3_of_place,
                p_w_spindle_frame_in_left_arm_frame_1_3_of_place_2, cos_angle, sin_angle,
                sin_q_left_ball, d2_of_q_right_ball, sin_q_right_ball, cos_q_left_ball,
                v_sleeve_centre_3_2_of_place, sin_q_left_ball, v_left_link_centre_1_2_of_place,
                sin_theta_plus_q_left_ball, sin_q_right_ball, v_right_link_centre_1_2_of_place,
                d2_of_place_14, d2_of_place_14, sin_q_right_ball, d2_of_place_18, d2_of_place_18,
                d2_of_place_19, d2_of_place_18, d2_of_place_22, d2_of_place_24, d2_of_place_7,
                cos_q_right_ball, d2_of_place_30, d2_of_place_19, d2_of_place_34, d2_of_place_34,
                d2_of_place_36, d2_of_place_36, d2_of_place_37, d2_of_q_right_ball, d2_of_place_7,
                opening_dot_of_q_right_ball, opening_dot_of_q_right_ball,
                opening_dot_of_q_right_ball, opening_dot_of_place_6, opening_dot_of_place_8,
                opening_dot_of_place_10, opening_dot_of_place_13, sin_angle,
                opening_dot_of_place_15, opening_dot_of_place_17, opening_dot_of_place_17,
                opening_dot_of_place_18, opening_dot_of_place_20, d2_of_place_7,
                opening_dot_of_place_24, cos_angle, opening_dot_of_place_27,
                opening_dot_of_place_27, opening_dot_of_place_31, opening_dot_of_place_32,
                opening_dot_of_place_18, opening_dot_of_place_35, opening_dot_of_place_37,
                sin_q_left_ball, sin_q_left_ball_sq_2, opening_dot_of_place_39,
                opening_dot_of_place_42, opening_dot_of_place_17, sin_q_right_top,
                opening_dot_of_place_45, opening_dot_of_place_48, opening_dot_of_place_4,
                p_w_spindle_frame_in_left_arm_frame_3_of_place,
                p_w_spindle_frame_in_left_arm_frame_1_of_place_2,
                p_w_spindle_frame_in_right_arm_frame_3_of_place,
                p_w_spindle_frame_in_right_arm_frame_1_of_place_2, x_N_3_of_place, sin_q_left_ball,
                v_left_link_centre_1_of_place, v_left_arm_frame_in_left_link_frame_3_of_theta_dot,
                opening_dot_of_place_60, v_sleeve_centre_3_of_motion_3,
                v_left_arm_frame_in_left_link_frame_3_2_of_motion,
                v_left_arm_frame_in_left_link_frame_1_2_of_motion, opening_dot_of_place_53,
                x_N_3_2_of_place, sin_q_right_ball, v_right_link_centre_1_of_place,
                v_right_arm_frame_in_right_link_frame_3_of_motion, opening_dot_of_place_64,
                v_right_arm_frame_in_right_link_frame_3_2_of_motion,
                v_right_arm_frame_in_right_link_frame_1_2_of_motion, opening_dot_of_place_56,
                opening_dot_of_place_60, opening_dot_of_place_65,
                p_w_left_arm_frame_in_left_link_frame_1_of_place, opening_dot_of_place_67,
                p_w_left_arm_frame_in_left_link_frame_1_of_place, opening_dot_of_place_69,
                v_right_link_centre_1_of_place, p_w_right_arm_frame_in_right_link_frame_1_of_place,
                opening_dot_of_motion_10, v_right_arm_frame_in_right_link_frame_3_of_motion,
                p_w_right_arm_frame_in_right_link_frame_1_of_place, opening_dot_of_motion_13,
                d2_of_place_19, d2_of_place_14, d2_of_place_22, opening_dot_of_place_71,
                opening_dot_of_place_71, opening_dot_of_theta_dot_5, opening_dot_of_theta_dot_7,
                opening_dot_of_theta_dot_7, d2_of_place_34, opening_dot_of_theta_dot_7,
                d2_of_place_37, opening_dot_of_motion_20,
                p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_2,
                p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_2,
                p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_2,
                p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2, opening_dot_of_place_53,
                opening_dot_of_place_56, spin_dot_of_motion_7, d2_of_place_19, d2_of_place_14,
                d2_of_place_22,
            ]),
        ];
        count_last = count;
        theta_last = theta;
        q_right_top_last = q_right_top;
        q_left_ball_last = q_left_ball;
        q_right_ball_last = q_right_ball;
        psi_dot_last = psi_dot;
        theta_dot_last = theta_dot;
        q_right_top_dot_last = q_right_top_dot;
        q_left_ball_dot_last = q_left_ball_dot;
        q_right_ball_dot_last = q_right_ball_dot;
        sin_theta_last = sin_theta;
        cos_theta_last = cos_theta;
        psi_dot_sin_theta_last = psi_dot_sin_theta;
        psi_dot_cos_theta_last = psi_dot_cos_theta;
        sin_q_right_top_last = sin_q_right_top;
        cos_q_right_top_last = cos_q_right_top;
        psi_dot_sin_q_right_top_last = psi_dot_sin_q_right_top;
        psi_dot_cos_q_right_top_last = psi_dot_cos_q_right_top;
        sin_q_left_ball_last = sin_q_left_ball;
        cos_q_left_ball_last = cos_q_left_ball;
        sin_q_right_ball_last = sin_q_right_ball;
        cos_q_right_ball_last = cos_q_right_ball;
        p_w_right_arm_frame_in_right_link_frame_1_of_place_last = p_w_right_arm_frame_in_right_link_frame_1_of_place;
        p_w_left_arm_frame_in_left_link_frame_1_of_place_last = p_w_left_arm_frame_in_left_link_frame_1_of_place;
        p_w_spindle_frame_in_right_arm_frame_3_of_place_last = p_w_spindle_frame_in_right_arm_frame_3_of_place;
        p_w_spindle_frame_in_right_arm_frame_1_of_place_2_last = p_w_spindle_frame_in_right_arm_frame_1_of_place_2;
        p_w_spindle_frame_in_left_arm_frame_3_of_place_last = p_w_spindle_frame_in_left_arm_frame_3_of_place;
        p_w_spindle_frame_in_left_arm_frame_1_of_place_2_last = p_w_spindle_frame_in_left_arm_frame_1_of_place_2;
        w_spindle_frame_in_left_arm_frame_1_2_of_motion_last = w_spindle_frame_in_left_arm_frame_1_2_of_motion;
        w_spindle_frame_in_left_arm_frame_3_2_of_motion_last = w_spindle_frame_in_left_arm_frame_3_2_of_motion;
        w_spindle_frame_in_right_arm_frame_1_2_of_motion_last = w_spindle_frame_in_right_arm_frame_1_2_of_motion;
        w_spindle_frame_in_right_arm_frame_3_2_of_motion_last = w_spindle_frame_in_right_arm_frame_3_2_of_motion;
        w_left_arm_frame_in_left_link_frame_1_2_of_motion_last = w_left_arm_frame_in_left_link_frame_1_2_of_motion;
        w_left_arm_frame_in_left_link_frame_1_2_of_motion_4_last = w_left_arm_frame_in_left_link_frame_1_2_of_motion_4;
        w_right_arm_frame_in_right_link_frame_1_2_of_motion_last = w_right_arm_frame_in_right_link_frame_1_2_of_motion;
        w_right_arm_frame_in_right_link_frame_1_2_of_motion_4_last = w_right_arm_frame_in_right_link_frame_1_2_of_motion_4;
        p_w_right_arm_frame_in_right_link_frame_1_2_of_place_last = p_w_right_arm_frame_in_right_link_frame_1_2_of_place;
        p_w_left_arm_frame_in_left_link_frame_1_2_of_place_last = p_w_left_arm_frame_in_left_link_frame_1_2_of_place;
        p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_2_last = p_w_spindle_frame_in_right_arm_frame_3_2_of_motion_2;
        p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_2_last = p_w_spindle_frame_in_right_arm_frame_1_2_of_motion_2;
        p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_2_last = p_w_spindle_frame_in_left_arm_frame_3_2_of_motion_2;
        p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2_last = p_w_spindle_frame_in_left_arm_frame_1_2_of_motion_2;
        w_left_link_frame_2_of_motion_last = w_left_link_frame_2_of_motion;
        x_N_3_of_place_last = x_N_3_of_place;
        v_left_arm_frame_in_left_link_frame_3_of_theta_dot_last = v_left_arm_frame_in_left_link_frame_3_of_theta_dot;
        v_left_link_centre_1_of_place_last = v_left_link_centre_1_of_place;
        v_left_arm_frame_in_left_link_frame_1_2_of_motion_last = v_left_arm_frame_in_left_link_frame_1_2_of_motion;
        v_left_arm_frame_in_left_link_frame_3_2_of_motion_last = v_left_arm_frame_in_left_link_frame_3_2_of_motion;
        theta_plus_q_left_ball_last = theta_plus_q_left_ball;
        sin_theta_plus_q_left_ball_last = sin_theta_plus_q_left_ball;
        cos_theta_plus_q_left_ball_last = cos_theta_plus_q_left_ball;
        theta_dot_sq_last = theta_dot_sq;
        v_sleeve_centre_3_of_motion_last = v_sleeve_centre_3_of_motion;
        v_sleeve_centre_3_of_motion_3_last = v_sleeve_centre_3_of_motion_3;
        x_N_3_2_of_place_last = x_N_3_2_of_place;
        v_right_arm_frame_in_right_link_frame_3_of_motion_last = v_right_arm_frame_in_right_link_frame_3_of_motion;
        v_right_link_centre_1_of_place_last = v_right_link_centre_1_of_place;
        v_right_arm_frame_in_right_link_frame_1_2_of_motion_last = v_right_arm_frame_in_right_link_frame_1_2_of_motion;
        v_right_arm_frame_in_right_link_frame_3_2_of_motion_last = v_right_arm_frame_in_right_link_frame_3_2_of_motion;
        p_w_right_arm_frame_in_right_link_frame_1_3_of_place_last = p_w_right_arm_frame_in_right_link_frame_1_3_of_place;
        p_w_left_arm_frame_in_left_link_frame_1_3_of_place_last = p_w_left_arm_frame_in_left_link_frame_1_3_of_place;
        p_w_spindle_frame_in_right_arm_frame_3_3_of_place_last = p_w_spindle_frame_in_right_arm_frame_3_3_of_place;
        p_w_spindle_frame_in_right_arm_frame_1_3_of_place_2_last = p_w_spindle_frame_in_right_arm_frame_1_3_of_place_2;
        p_w_spindle_frame_in_left_arm_frame_3_3_of_place_last = p_w_spindle_frame_in_left_arm_frame_3_3_of_place;
        p_w_spindle_frame_in_left_arm_frame_1_3_of_place_2_last = p_w_spindle_frame_in_left_arm_frame_1_3_of_place_2;
        v_left_link_centre_1_2_of_place_last = v_left_link_centre_1_2_of_place;
        v_sleeve_centre_3_2_of_place_last = v_sleeve_centre_3_2_of_place;
        v_right_link_centre_1_2_of_place_last = v_right_link_centre_1_2_of_place;
        d1_of_place_5_last = d1_of_place_5;
        d2_of_place_last = d2_of_place;
        sin_angle_last = sin_angle;
        cos_angle_last = cos_angle;
        d2_of_q_right_ball_last = d2_of_q_right_ball;
        d2_of_place_6_last = d2_of_place_6;
        d2_of_place_7_last = d2_of_place_7;
        d2_of_place_8_last = d2_of_place_8;
        d2_of_place_13_last = d2_of_place_13;
        d2_of_place_14_last = d2_of_place_14;
        d2_of_place_16_last = d2_of_place_16;
        d2_of_place_17_last = d2_of_place_17;
        d2_of_place_18_last = d2_of_place_18;
        d2_of_place_19_last = d2_of_place_19;
        d2_of_place_21_last = d2_of_place_21;
        d2_of_place_22_last = d2_of_place_22;
        d2_of_place_24_last = d2_of_place_24;
        d2_of_place_30_last = d2_of_place_30;
        d2_of_place_31_last = d2_of_place_31;
        d2_of_place_32_last = d2_of_place_32;
        d2_of_place_34_last = d2_of_place_34;
        d2_of_place_36_last = d2_of_place_36;
        d2_of_place_37_last = d2_of_place_37;
        d2_of_place_39_last = d2_of_place_39;
        opening_dot_of_q_right_ball_last = opening_dot_of_q_right_ball;
        opening_dot_of_place_4_last = opening_dot_of_place_4;
        opening_dot_of_place_5_last = opening_dot_of_place_5;
        opening_dot_of_place_6_last = opening_dot_of_place_6;
        opening_dot_of_place_8_last = opening_dot_of_place_8;
        opening_dot_of_place_10_last = opening_dot_of_place_10;
        opening_dot_of_place_13_last = opening_dot_of_place_13;
        opening_dot_of_place_15_last = opening_dot_of_place_15;
        opening_dot_of_place_17_last = opening_dot_of_place_17;
        opening_dot_of_place_18_last = opening_dot_of_place_18;
        opening_dot_of_place_20_last = opening_dot_of_place_20;
        opening_dot_of_place_24_last = opening_dot_of_place_24;
        opening_dot_of_place_27_last = opening_dot_of_place_27;
        opening_dot_of_place_29_last = opening_dot_of_place_29;
        opening_dot_of_place_31_last = opening_dot_of_place_31;
        opening_dot_of_place_32_last = opening_dot_of_place_32;
        opening_dot_of_place_35_last = opening_dot_of_place_35;
        opening_dot_of_place_37_last = opening_dot_of_place_37;
        sin_q_left_ball_sq_2_last = sin_q_left_ball_sq_2;
        opening_dot_of_place_39_last = opening_dot_of_place_39;
        opening_dot_of_place_42_last = opening_dot_of_place_42;
        opening_dot_of_place_44_last = opening_dot_of_place_44;
        opening_dot_of_place_45_last = opening_dot_of_place_45;
        opening_dot_of_place_48_last = opening_dot_of_place_48;
        opening_dot_of_place_50_last = opening_dot_of_place_50;
        opening_dot_of_place_53_last = opening_dot_of_place_53;
        opening_dot_of_place_56_last = opening_dot_of_place_56;
        opening_dot_of_place_60_last = opening_dot_of_place_60;
        opening_dot_of_place_64_last = opening_dot_of_place_64;
        opening_dot_of_place_65_last = opening_dot_of_place_65;
        opening_dot_of_place_67_last = opening_dot_of_place_67;
        opening_dot_of_place_69_last = opening_dot_of_place_69;
        opening_dot_of_motion_10_last = opening_dot_of_motion_10;
        opening_dot_of_motion_13_last = opening_dot_of_motion_13;
        opening_dot_of_motion_15_last = opening_dot_of_motion_15;
        opening_dot_of_theta_dot_3_last = opening_dot_of_theta_dot_3;
        opening_dot_of_motion_17_last = opening_dot_of_motion_17;
        opening_dot_of_place_71_last = opening_dot_of_place_71;
        opening_dot_of_theta_dot_5_last = opening_dot_of_theta_dot_5;
        opening_dot_of_theta_dot_7_last = opening_dot_of_theta_dot_7;
        opening_dot_of_theta_dot_8_last = opening_dot_of_theta_dot_8;
        opening_dot_of_theta_dot_10_last = opening_dot_of_theta_dot_10;
        opening_dot_of_motion_20_last = opening_dot_of_motion_20;
        spin_dot_of_motion_7_last = spin_dot_of_motion_7;
    }
}

/// Lagrange's equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Lagrange;

impl<S: Scalar> System<S> for Lagrange {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 7,
            coordinates: 5,
            variables: 5,
            speeds: 2,
            reactions: 3,
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
        7
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
                q_dot
                    .copy_from_slice(
                        &coordinate_rates(&Parameters::from_slice(p), array(q), array(v)),
                    );
                v_dot
                    .copy_from_slice(
                        &accelerations(&Parameters::from_slice(p), array(q), array(v)),
                    );
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
        384 * order + SLACK
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
    fn divisor_count(&self) -> usize {
        2
    }
    fn divisor_name(&self, at: usize) -> &str {
        ["sin(q_right_ball)", "cos(theta + q_left_ball)"][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn constraint_count(&self) -> usize {
        6
    }
    fn constraint_name(&self, at: usize) -> &str {
        [
            "left_end_1", "right_end_1", "right_end_3", "left_end_1'", "right_end_1'",
            "right_end_3'",
        ][at]
    }
    fn constraints(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &constraints(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn constraint_slopes(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &constraint_slopes(&Parameters::from_slice(p), array(q), array(v)),
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
