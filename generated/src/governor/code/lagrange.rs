//! Flyball governor: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/governor/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows psi, theta, q_right_top, q_left_ball, q_right_ball, constraint left_end_1, constraint right_end_1, constraint right_end_3.
///
/// 129 operations, 6 sines and cosines.
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
    let w_left_arm_frame_in_left_link_frame_1_3_of_place = cos_theta * sin_q_left_ball;
    let w_left_arm_frame_in_left_link_frame_1_3 = sin_theta
        .mul_add(cos_q_left_ball, w_left_arm_frame_in_left_link_frame_1_3_of_place);
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
    let theta_plus_q_left_ball = theta + q_left_ball;
    let (sin_theta_plus_q_left_ball, cos_theta_plus_q_left_ball) = theta_plus_q_left_ball
        .sin_cos();
    let v_sleeve_centre_3_2 = l * sin_theta_plus_q_left_ball;
    let p_v_sleeve_centre_3_2 = ms * v_sleeve_centre_3_2;
    let p_w_left_link_frame_2_2 = S::int(4) * H_left_arm_2;
    let p_v_left_arm_centre_1 = l * m_plus_mb_times_4;
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
    let m22_of_place = mb
        + ms
            * (S::int(1) - cos_q_left_ball * cos_q_left_ball
                + S::int(2) * sin_theta
                    * (w_left_arm_frame_in_left_link_frame_1_3_of_place
                        + cos_q_left_ball
                            * (sin_theta * (S::int(1) + cos_q_left_ball)
                                + w_left_arm_frame_in_left_link_frame_1_3_of_place)));
    let m24_of_place = S::ratio(1, 12) * p_w_left_link_frame_2_2;
    let h_left_arm_2_halved = S::ratio(1, 2) * H_left_arm_2;
    let m24_of_place_2 = l * (sin_theta + sin_theta_plus_q_left_ball);
    let m24_of_place_3 = p_v_sleeve_centre_3_2
        .mul_add(m24_of_place_2, h_left_arm_2_halved * cos_q_left_ball);
    let m24_of_place_4 = m24_of_place + m24_of_place_3;
    let m26_of_place = l * (cos_theta + cos_theta_plus_q_left_ball);
    let m33_of_place = H_left_arm_2 + p_w_right_link_frame_2_2;
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
    let m22 = S::ratio(1, 3) * l * l
        * (m * cos_q_left_ball.mul_add(S::int(3), S::int(5)) + S::int(3) * m22_of_place);
    let m24 = m24_of_place_4;
    let m26 = m26_of_place;
    let m28 = m24_of_place_2;
    let m33 = S::ratio(1, 4) * l
        * ((p_v_right_link_centre_1_3 * cos_q_right_ball)
            .mul_add(S::int(2), p_v_left_arm_centre_1)
            + S::int(4) * p_v_right_arm_frame_in_right_link_frame_3_3 * sin_q_right_ball)
        + S::ratio(1, 12) * m33_of_place;
    let m35 = m35_of_place;
    let m37 = m37_of_place_2;
    let m38 = -m38_of_place;
    let m42 = m24_of_place_4;
    let m44 = v_sleeve_centre_3_2.mul_add(p_v_sleeve_centre_3_2, m24_of_place);
    let m46 = m46_of_place;
    let m48 = v_sleeve_centre_3_2;
    let m53 = m35_of_place;
    let m55 = m24_of_place;
    let m57 = l_cos_angle;
    let m58 = -l_sin_angle;
    let m62 = -m26_of_place;
    let m64 = -m46_of_place;
    let m73 = -m37_of_place_2;
    let m75 = -l_cos_angle;
    let m82 = -m24_of_place_2;
    let m83 = m38_of_place;
    let m84 = -v_sleeve_centre_3_2;
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
/// 337 operations, 6 sines and cosines.
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
    let w_right_link_frame_2 = q_right_top_dot + q_right_ball_dot;
    let mb_doubled = S::int(2) * mb;
    let mp_left_arm_frame_3 = l.mul_add(mb_doubled, S::int(3) * mp_left_link_frame_3);
    let x_right_link_frame_in_right_arm_frame_1 = mp_left_link_frame_3 * sin_q_right_ball;
    let x_right_link_frame_in_right_arm_frame_3 = mp_left_link_frame_3 * cos_q_right_ball;
    let x_N_3 = mp_left_arm_frame_3 + x_right_link_frame_in_right_arm_frame_3;
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
    let w_left_link_frame_2 = theta_dot + q_left_ball_dot;
    let l_theta_dot = l * theta_dot;
    let v_left_arm_frame_in_left_link_frame_1 = l_theta_dot * cos_q_left_ball;
    let v_left_arm_frame_in_left_link_frame_3 = l_theta_dot * sin_q_left_ball;
    let v_left_link_centre_1 = v_left_arm_frame_in_left_link_frame_1
        .mul_add(S::int(2), l * w_left_link_frame_2);
    let p_v_left_link_centre_1 = m * v_left_link_centre_1;
    let p_v_left_arm_frame_in_left_link_frame_3 = m * v_left_arm_frame_in_left_link_frame_3;
    let F_x_N_3 = g * cos_theta;
    let F_x_left_link_frame_in_left_arm_frame_1 = g * sin_theta;
    let v_left_arm_frame_in_left_link_frame_1_2 = w_left_arm_frame_in_left_link_frame_1_2_of_motion_2
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
    let p_w_left_link_frame_2 = l * p_v_left_link_centre_1_2;
    let F_x_N_3_2 = g * cos_q_right_top;
    let F_x_right_link_frame_in_right_arm_frame_1 = g * sin_q_right_top;
    let f1_of_place = (-p_w_spindle_frame_in_right_arm_frame_1)
        .mul_add(
            cos_q_right_top,
            p_w_spindle_frame_in_right_arm_frame_3 * sin_q_right_top,
        );
    let f1_of_place_by_12 = S::ratio(1, 12) * f1_of_place;
    let f1_of_place_2 = p_w_spindle_frame_in_right_arm_frame_1_2
        .mul_add(
            sin_q_right_top,
            p_w_spindle_frame_in_right_arm_frame_3_2 * cos_q_right_top,
        );
    let f1_of_place_3 = p_w_spindle_frame_in_left_arm_frame_1_2
        .mul_add(sin_theta, p_w_spindle_frame_in_left_arm_frame_3_2 * cos_theta);
    let f1_of_theta_dot = theta_dot
        * (-p_w_spindle_frame_in_left_arm_frame_1)
            .mul_add(cos_theta, p_w_spindle_frame_in_left_arm_frame_3 * sin_theta) - f1_of_place_2;
    let f1_of_theta_dot_2 = f1_of_place_3 - f1_of_theta_dot;
    let cos_q_left_ball_doubled = S::int(2) * cos_q_left_ball;
    let f2_of_motion = theta_dot.mul_add(S::int(2), q_left_ball_dot);
    let f2_of_motion_2 = f2_of_motion * (S::int(1) + cos_q_left_ball_doubled);
    let f2_of_place = sin_theta * sin_q_left_ball;
    let f2_of_q_left_ball = S::int(1) + cos_q_left_ball;
    let theta_dot_sq = theta_dot * theta_dot;
    let f2_of_q_left_ball_2 = S::int(3) + cos_q_left_ball_doubled;
    let psi_dot_sq = psi_dot * psi_dot;
    let ms_doubled = S::int(2) * ms;
    let f3_of_place = S::ratio(1, 2) * p_w_right_link_frame_2;
    let cos_q_right_ball_doubled = S::int(2) * cos_q_right_ball;
    let l_halved = S::ratio(1, 2) * l;
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
    let f1 = q_right_top_dot
        .mul_add(f1_of_place_by_12, -S::ratio(1, 12) * f1_of_theta_dot_2);
    let f2 = S::ratio(1, 6) * l
        * (l
            * (S::int(2) * sin_theta
                * (S::int(3) * ms
                    * (q_left_ball_dot
                        * (cos_theta * (-f2_of_motion_2).mul_add(cos_q_left_ball, f2_of_motion)
                            + f2_of_motion_2 * f2_of_place)
                        + S::int(2) * theta_dot_sq
                            * (f2_of_place
                                + cos_q_left_ball
                                    * (-f2_of_q_left_ball).mul_add(cos_theta, f2_of_place)))
                    + psi_dot_sq
                        * (m
                            * (cos_theta * f2_of_q_left_ball_2.mul_add(cos_q_left_ball, S::int(3))
                                - f2_of_place * f2_of_q_left_ball_2) + S::int(3) * mb * cos_theta))
                + sin_q_left_ball
                    * (m
                        * f2_of_q_left_ball_2
                            .mul_add(
                                psi_dot_sq,
                                S::int(3) * q_left_ball_dot * f2_of_motion,
                            )
                        - S::int(6) * ms
                            * (theta_dot
                                * theta_dot
                                    .mul_add(
                                        f2_of_q_left_ball,
                                        S::int(2)
                                            * w_left_arm_frame_in_left_link_frame_1_2_of_motion,
                                    )
                                + q_left_ball_dot
                                    * w_left_arm_frame_in_left_link_frame_1_2_of_motion)))
            - S::int(3) * g
                * (sin_theta
                    * (m * (S::int(3) + cos_q_left_ball) + mb_doubled
                        + f2_of_q_left_ball * ms_doubled)
                    + cos_theta * sin_q_left_ball * (m + ms_doubled)));
    let f3 = f3_of_place
        - S::ratio(1, 2) * g
            * x_N_3
                .mul_add(
                    sin_q_right_top,
                    x_right_link_frame_in_right_arm_frame_1 * cos_q_right_top,
                ) - psi_dot * f1_of_place_by_12
        + l_halved
            * (p_v_right_link_centre_1_2 * cos_q_right_ball_doubled
                - S::int(2) * p_v_right_arm_frame_in_right_link_frame_3_2 * sin_q_right_ball
                - q_right_ball_dot
                    * (-p_v_right_link_centre_1)
                        .mul_add(
                            sin_q_right_ball,
                            p_v_right_arm_frame_in_right_link_frame_3 * cos_q_right_ball_doubled,
                        ));
    let f4 = S::ratio(1, 2) * p_w_left_link_frame_2
        - l_halved
            * (S::int(2) * sin_theta_plus_q_left_ball * ms.mul_add(g, p_v_sleeve_centre_3)
                + theta_dot
                    * (-p_v_left_arm_frame_in_left_link_frame_3)
                        .mul_add(
                            cos_q_left_ball_doubled,
                            p_v_left_link_centre_1 * sin_q_left_ball,
                        )) - S::ratio(1, 12) * f4_of_place_2;
    let f5 = f3_of_place - S::ratio(1, 12) * f5_of_motion;
    let f6 = -l
        * theta_dot_sq
            .mul_add(
                sin_theta,
                w_left_link_frame_2 * w_left_link_frame_2 * sin_theta_plus_q_left_ball,
            );
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
/// 529 operations, 6 sines and cosines.
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
    let l_sq = l * l;
    let H_left_arm_2 = m * l_sq;
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
    let w_right_link_frame_2 = q_right_top_dot + q_right_ball_dot;
    let l_doubled = S::int(2) * l;
    let mp_left_arm_frame_3 = mb.mul_add(l_doubled, m * l_times_3);
    let mp_left_link_frame_3 = l * m;
    let x_right_link_frame_in_right_arm_frame_1 = mp_left_link_frame_3 * sin_q_right_ball;
    let x_right_link_frame_in_right_arm_frame_3 = mp_left_link_frame_3 * cos_q_right_ball;
    let x_N_3 = mp_left_arm_frame_3 + x_right_link_frame_in_right_arm_frame_3;
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
    let w_left_link_frame_2 = theta_dot + q_left_ball_dot;
    let l_theta_dot = l * theta_dot;
    let v_left_arm_frame_in_left_link_frame_1 = l_theta_dot * cos_q_left_ball;
    let v_left_arm_frame_in_left_link_frame_3 = l_theta_dot * sin_q_left_ball;
    let v_left_link_centre_1 = v_left_arm_frame_in_left_link_frame_1
        .mul_add(S::int(2), l * w_left_link_frame_2);
    let p_v_left_link_centre_1 = m * v_left_link_centre_1;
    let p_v_left_arm_frame_in_left_link_frame_3 = m * v_left_arm_frame_in_left_link_frame_3;
    let F_x_N_3 = g * cos_theta;
    let F_x_left_link_frame_in_left_arm_frame_1 = g * sin_theta;
    let v_left_arm_frame_in_left_link_frame_1_2 = w_left_arm_frame_in_left_link_frame_1_2_of_motion_2
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
    let p_w_left_link_frame_2 = l * p_v_left_link_centre_1_2;
    let F_x_N_3_2 = g * cos_q_right_top;
    let F_x_right_link_frame_in_right_arm_frame_1 = g * sin_q_right_top;
    let w_left_arm_frame_in_left_link_frame_1_3_of_place = cos_theta * sin_q_left_ball;
    let w_left_arm_frame_in_left_link_frame_1_3 = sin_theta
        .mul_add(cos_q_left_ball, w_left_arm_frame_in_left_link_frame_1_3_of_place);
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
    let v_sleeve_centre_3_2 = l * sin_theta_plus_q_left_ball;
    let p_v_sleeve_centre_3_2 = ms * v_sleeve_centre_3_2;
    let p_w_left_link_frame_2_2 = mp_left_link_frame_3.mul_add(l_times_3, H_left_arm_2);
    let p_v_left_arm_centre_1 = l * m_plus_mb_times_4;
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
    let mb_times_3 = S::int(3) * mb;
    let d2_of_q_left_ball = S::int(1) + cos_q_left_ball;
    let sin_theta_doubled = S::int(2) * sin_theta;
    let ms_times_3 = S::int(3) * ms;
    let d2_of_q_right_ball = S::int(1) + cos_q_right_ball;
    let d2_of_place = d2_of_q_right_ball * cos_q_right_top;
    let sin_q_right_ball_inv = S::int(1) / sin_q_right_ball;
    let d2_of_place_2 = S::int(1) / cos_theta_plus_q_left_ball;
    let d2_of_place_3 = d2_of_place_2 * sin_q_left_ball;
    let d2_of_place_4 = sin_q_right_ball_inv * d2_of_place_3;
    let d2_of_place_5 = d2_of_place_4 * (-sin_q_right_top).mul_add(sin_q_right_ball, d2_of_place);
    let l_times_6 = S::int(6) * l;
    let d2_of_place_6 = x_right_link_frame_in_right_arm_frame_3 * l_times_6;
    let d2_of_place_7 = q_right_top + q_right_ball;
    let (sin_angle, cos_angle) = d2_of_place_7.sin_cos();
    let d2_of_place_8 = d2_of_place_3
        * (sin_q_right_ball_inv
            * (p_w_left_link_frame_2_2 * (cos_angle - d2_of_place) + d2_of_place_6 * cos_angle)
            + p_w_left_link_frame_2_2 * sin_q_right_top);
    let cos_q_right_ball_doubled = S::int(2) * cos_q_right_ball;
    let cos_angle_d2_of_place_4 = d2_of_place_4 * cos_angle;
    let d2_of_place_9 = cos_angle_d2_of_place_4
        * (H_left_arm_2 + p_w_right_link_frame_2_2
            + l_times_3
                * ((p_v_right_arm_frame_in_right_link_frame_3_3 * sin_q_right_ball)
                    .mul_add(S::int(4), p_v_left_arm_centre_1)
                    + p_v_right_link_centre_1_3 * cos_q_right_ball_doubled))
        - d2_of_place_5 * (p_w_left_link_frame_2_2 + d2_of_place_6);
    let d2_of_place_10 = d2_of_place_2 * (cos_theta + cos_theta_plus_q_left_ball);
    let d2_of_place_11 = mp_left_link_frame_3 * cos_q_left_ball;
    let d2_of_place_12 = cos_theta * cos_q_left_ball;
    let d2_of_place_13 = sin_theta * sin_q_left_ball;
    let d2_of_place_14 = (l_times_6
        * (sin_q_left_ball * d2_of_place_11.mul_add(sin_theta, S::int(2) * p_v_sleeve_centre_3_2)
            - d2_of_place_11 * d2_of_place_12) + p_w_left_link_frame_2_2 * cos_theta)
        / (d2_of_place_13 - d2_of_place_12);
    let d2_of_place_15 = S::int(12) * l * p_v_sleeve_centre_3_2
        * (sin_theta + sin_theta_plus_q_left_ball) + p_w_left_link_frame_2_2
        + l_times_6 * d2_of_place_11;
    let d2_of_place_16 = -d2_of_place_10 * (d2_of_place_14 + d2_of_place_15)
        + cos_angle_d2_of_place_4 * d2_of_place_9;
    let d2_of_place_17 = d2_of_place_5.mul_add(d2_of_place_8, -d2_of_place_16);
    let d2 = S::ratio(1, 3) * l_sq
        * (m * cos_q_left_ball.mul_add(S::int(3), S::int(5)) + mb_times_3
            + ms_times_3
                * (S::int(1) - cos_q_left_ball * cos_q_left_ball
                    + sin_theta_doubled
                        * (w_left_arm_frame_in_left_link_frame_1_3_of_place
                            + cos_q_left_ball
                                * d2_of_q_left_ball
                                    .mul_add(
                                        sin_theta, w_left_arm_frame_in_left_link_frame_1_3_of_place,
                                    )))) - S::ratio(1, 12) * d2_of_place_17;
    let opening_dot_of_place = S::int(6) * mp_left_link_frame_3;
    let cos_q_left_ball_doubled = S::int(2) * cos_q_left_ball;
    let opening_dot_of_place_2 = (-p_w_spindle_frame_in_right_arm_frame_1)
        .mul_add(
            cos_q_right_top,
            p_w_spindle_frame_in_right_arm_frame_3 * sin_q_right_top,
        );
    let opening_dot_of_place_3 = S::int(6) * p_w_right_link_frame_2;
    let opening_dot_of_motion = theta_dot.mul_add(S::int(2), q_left_ball_dot);
    let opening_dot_of_q_left_ball = S::int(3) + cos_q_left_ball_doubled;
    let psi_dot_sq = psi_dot * psi_dot;
    let opening_dot_of_motion_2 = opening_dot_of_motion * (S::int(1) + cos_q_left_ball_doubled);
    let ms_doubled = S::int(2) * ms;
    let cos_theta_d2_of_place_2 = d2_of_place_2 * cos_theta;
    let opening_dot_of_place_4 = cos_theta_d2_of_place_2 * sin_theta_plus_q_left_ball;
    let opening_dot_of_theta_dot = theta_dot_sq * d2_of_place_2;
    let opening_dot_of_theta_dot_2 = opening_dot_of_theta_dot
        * cos_theta_d2_of_place_2.mul_add(opening_dot_of_place_4, sin_theta);
    let opening_dot_of_place_5 = d2_of_q_right_ball * sin_q_right_top;
    let opening_dot_of_place_6 = d2_of_place * sin_q_right_ball_inv;
    let opening_dot_of_place_7 = sin_q_right_ball_inv * cos_angle;
    let opening_dot_of_theta_dot_3 = opening_dot_of_theta_dot
        * (cos_q_left_ball * (opening_dot_of_place_6 - sin_q_right_top)
            + d2_of_place_2
                * (sin_q_right_ball_inv
                    * (cos_q_right_top
                        * (sin_q_left_ball
                            * (sin_q_left_ball
                                * (cos_q_right_top + cos_angle
                                    + sin_q_right_ball_inv
                                        * (-opening_dot_of_place_6)
                                            .mul_add(S::int(2), opening_dot_of_place_5))
                                + d2_of_q_right_ball * opening_dot_of_place_4)
                            + d2_of_q_right_ball * d2_of_place_12)
                        + opening_dot_of_place_5 * opening_dot_of_place_7
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
                                            .mul_add(opening_dot_of_place_7, sin_angle)))
                        + sin_q_right_top * sin_angle)
                    + opening_dot_of_place_4 * cos_angle) + d2_of_place_12 * cos_angle)
            + cos_q_left_ball * cos_angle);
    let opening_dot = -S::ratio(1, 12)
        * (d2_of_place_10
            * (-sin_q_left_ball
                * F_x_N_3
                    .mul_add(
                        opening_dot_of_place,
                        w_spindle_frame_in_left_arm_frame_1
                            * p_w_left_arm_frame_in_left_link_frame_1,
                    ) + S::int(6) * p_w_left_link_frame_2
                + cos_q_left_ball
                    * (-F_x_left_link_frame_in_left_arm_frame_1)
                        .mul_add(
                            opening_dot_of_place,
                            w_spindle_frame_in_left_arm_frame_3
                                * p_w_left_arm_frame_in_left_link_frame_1,
                        )
                - l_times_6
                    * (S::int(2) * sin_theta_plus_q_left_ball * ms.mul_add(g, p_v_sleeve_centre_3)
                        + theta_dot
                            * (-p_v_left_arm_frame_in_left_link_frame_3)
                                .mul_add(
                                    cos_q_left_ball_doubled,
                                    p_v_left_link_centre_1 * sin_q_left_ball,
                                )))
            + d2_of_place_5
                * (cos_q_right_ball
                    * ((p_v_right_arm_frame_in_right_link_frame_3 * l_q_right_top_dot)
                        .mul_add(
                            S::int(12),
                            w_spindle_frame_in_right_arm_frame_3
                                * p_w_right_arm_frame_in_right_link_frame_1,
                        )
                        - F_x_right_link_frame_in_right_arm_frame_1 * opening_dot_of_place)
                    - sin_q_right_ball
                        * ((q_right_top_dot * p_v_right_link_centre_1)
                            .mul_add(
                                l_times_6,
                                w_spindle_frame_in_right_arm_frame_1
                                    * p_w_right_arm_frame_in_right_link_frame_1,
                            ) + F_x_N_3_2 * opening_dot_of_place) + opening_dot_of_place_3)
            + cos_angle_d2_of_place_4
                * (S::int(6) * g
                    * x_N_3
                        .mul_add(
                            sin_q_right_top,
                            x_right_link_frame_in_right_arm_frame_1 * cos_q_right_top,
                        )
                    + l_times_6
                        * (S::int(2) * p_v_right_arm_frame_in_right_link_frame_3_2
                            * sin_q_right_ball
                            - p_v_right_link_centre_1_2 * cos_q_right_ball_doubled
                            + q_right_ball_dot
                                * (-p_v_right_link_centre_1)
                                    .mul_add(
                                        sin_q_right_ball,
                                        p_v_right_arm_frame_in_right_link_frame_3
                                            * cos_q_right_ball_doubled,
                                    )) + psi_dot * opening_dot_of_place_2 - opening_dot_of_place_3)
            + l_doubled
                * (S::int(3) * g
                    * (sin_theta
                        * (m * (S::int(3) + cos_q_left_ball) + S::int(2) * mb
                            + d2_of_q_left_ball * ms_doubled)
                        + w_left_arm_frame_in_left_link_frame_1_3_of_place * (m + ms_doubled))
                    - l
                        * (sin_q_left_ball
                            * (m
                                * opening_dot_of_q_left_ball
                                    .mul_add(
                                        psi_dot_sq,
                                        S::int(3) * q_left_ball_dot * opening_dot_of_motion,
                                    )
                                - S::int(6) * ms
                                    * (theta_dot
                                        * theta_dot
                                            .mul_add(
                                                d2_of_q_left_ball,
                                                S::int(2)
                                                    * w_left_arm_frame_in_left_link_frame_1_2_of_motion,
                                            )
                                        + q_left_ball_dot
                                            * w_left_arm_frame_in_left_link_frame_1_2_of_motion))
                            + sin_theta_doubled
                                * (psi_dot_sq
                                    * (m
                                        * (cos_theta
                                            * opening_dot_of_q_left_ball
                                                .mul_add(cos_q_left_ball, S::int(3))
                                            - d2_of_place_13 * opening_dot_of_q_left_ball)
                                        + mb_times_3 * cos_theta)
                                    + ms_times_3
                                        * (S::int(2) * theta_dot_sq
                                            * (d2_of_place_13
                                                + cos_q_left_ball
                                                    * (-d2_of_q_left_ball).mul_add(cos_theta, d2_of_place_13))
                                            + q_left_ball_dot
                                                * (cos_theta
                                                    * (-opening_dot_of_motion_2)
                                                        .mul_add(cos_q_left_ball, opening_dot_of_motion)
                                                    + d2_of_place_13 * opening_dot_of_motion_2)))))
            + d2_of_place_14 * opening_dot_of_theta_dot_2
            + d2_of_place_8 * opening_dot_of_theta_dot_3
            + d2_of_place_9 * opening_dot_of_theta_dot_4) / d2;
    let spin_dot = S::ratio(1, 12)
        * (-theta_dot
            * (-p_w_spindle_frame_in_left_arm_frame_3)
                .mul_add(sin_theta, p_w_spindle_frame_in_left_arm_frame_1 * cos_theta)
            + q_right_top_dot * opening_dot_of_place_2
            - p_w_spindle_frame_in_right_arm_frame_3_2 * cos_q_right_top
            - p_w_spindle_frame_in_right_arm_frame_1_2 * sin_q_right_top
            - p_w_spindle_frame_in_left_arm_frame_3_2 * cos_theta
            - p_w_spindle_frame_in_left_arm_frame_1_2 * sin_theta) / d1;
    let psi_ddot = spin_dot;
    let theta_ddot = opening_dot;
    let q_right_top_ddot = opening_dot
        .mul_add(cos_angle_d2_of_place_4, opening_dot_of_theta_dot_4);
    let q_left_ball_ddot = (-opening_dot)
        .mul_add(d2_of_place_10, opening_dot_of_theta_dot_2);
    let q_right_ball_ddot = (-opening_dot)
        .mul_add(d2_of_place_5, opening_dot_of_theta_dot_3);
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
    let w_right_link_frame_2 = q_right_top_dot + q_right_ball_dot;
    let v_right_arm_centre_1 = l * q_right_top_dot;
    let v_right_arm_frame_in_right_link_frame_1 = v_right_arm_centre_1 * cos_q_right_ball;
    let v_right_arm_frame_in_right_link_frame_3 = v_right_arm_centre_1 * sin_q_right_ball;
    let v_right_link_centre_1 = v_right_arm_frame_in_right_link_frame_1
        .mul_add(S::int(2), l * w_right_link_frame_2);
    let w_left_link_frame_2 = theta_dot + q_left_ball_dot;
    let v_left_arm_centre_1 = l * theta_dot;
    let v_left_arm_frame_in_left_link_frame_1 = v_left_arm_centre_1 * cos_q_left_ball;
    let v_left_arm_frame_in_left_link_frame_3 = v_left_arm_centre_1 * sin_q_left_ball;
    let v_left_link_centre_1 = v_left_arm_frame_in_left_link_frame_1
        .mul_add(S::int(2), l * w_left_link_frame_2);
    let H_spindle_3 = J * psi_dot;
    let H_left_arm_2_2 = theta_dot * l_sq_m;
    let H_right_arm_2 = q_right_top_dot * l_sq_m;
    let H_left_link_2 = w_left_link_frame_2 * l_sq_m;
    let H_right_link_2 = w_right_link_frame_2 * l_sq_m;
    let (sin_theta_plus_q_left_ball, _) = (theta + q_left_ball).sin_cos();
    let v_sleeve_centre_3_3 = l
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
        * v_left_arm_frame_in_left_link_frame_3
            .mul_add(
                v_left_arm_frame_in_left_link_frame_3,
                v_right_arm_frame_in_right_link_frame_3 * v_right_arm_frame_in_right_link_frame_3,
            ) + ms * v_sleeve_centre_3_3 * v_sleeve_centre_3_3;
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
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let l_m = l * m;
    // mp_left_arm_frame_3 = 3*l*m + 2*l*mb
    let mp_left_arm_frame_3 = (l * mb).mul_add(S::int(2), S::int(3) * l_m);
    // mp_left_link_frame_3 = l*m
    let mp_left_link_frame_3 = l_m;
    // x_right_link_frame_in_right_arm_frame_1 = mp_left_link_frame_3*sin(q_right_ball)
    let x_right_link_frame_in_right_arm_frame_1 = mp_left_link_frame_3 * sin_q_right_ball;
    // x_right_link_frame_in_right_arm_frame_3 = mp_left_link_frame_3*cos(q_right_ball)
    let x_right_link_frame_in_right_arm_frame_3 = mp_left_link_frame_3 * cos_q_right_ball;
    // x_N_3 = mp_left_arm_frame_3 + x_right_link_frame_in_right_arm_frame_3
    let x_N_3 = mp_left_arm_frame_3 + x_right_link_frame_in_right_arm_frame_3;
    let (_, cos_theta_plus_q_left_ball) = (theta + q_left_ball).sin_cos();
    // mp_spindle_frame_3 = l*ms*(cos(theta) + cos(theta + q_left_ball))
    let mp_spindle_frame_3 = l * ms * (cos_theta + cos_theta_plus_q_left_ball);
    // x_left_link_frame_in_left_arm_frame_1 = mp_left_link_frame_3*sin(q_left_ball)
    let x_left_link_frame_in_left_arm_frame_1 = mp_left_link_frame_3 * sin_q_left_ball;
    // x_left_link_frame_in_left_arm_frame_3 = mp_left_link_frame_3*cos(q_left_ball)
    let x_left_link_frame_in_left_arm_frame_3 = mp_left_link_frame_3 * cos_q_left_ball;
    // x_N_3_2 = mp_left_arm_frame_3 + x_left_link_frame_in_left_arm_frame_3
    let x_N_3_2 = mp_left_arm_frame_3 + x_left_link_frame_in_left_arm_frame_3;
    // x_left_arm_frame_in_spindle_frame_3 = x_N_3_2*cos(theta) -
    //   x_left_link_frame_in_left_arm_frame_1*sin(theta)
    let x_left_arm_frame_in_spindle_frame_3 = (-x_left_link_frame_in_left_arm_frame_1)
        .mul_add(sin_theta, x_N_3_2 * cos_theta);
    // x_N_3_3 = 2*mp_spindle_frame_3 + x_left_arm_frame_in_spindle_frame_3
    let x_N_3_3 = mp_spindle_frame_3
        .mul_add(S::int(2), x_left_arm_frame_in_spindle_frame_3);
    // x_right_arm_frame_in_spindle_frame_3 = x_N_3*cos(q_right_top) -
    //   x_right_link_frame_in_right_arm_frame_1*sin(q_right_top)
    let x_right_arm_frame_in_spindle_frame_3 = (-x_right_link_frame_in_right_arm_frame_1)
        .mul_add(sin_q_right_top, x_N_3 * cos_q_right_top);
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

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
    direction: &[S; 10],
) -> [S; 10] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: q_dot[i],
        slope: direction[5 + i],
    });
    let (of_q, of_v) = (coordinate_rates(&p, &q, &v), accelerations(&p, &q, &v));
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
    slice.try_into().expect("a slice of the length that `System` requires")
}
