//! Flyball governor: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/governor/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows spin, opening.
///
/// 104 operations, 4 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 2],
) -> [[S; 2]; 2] {
    let Parameters { l, m, mb, ms, J, Js, .. } = *p;
    let [_, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    // Sines and cosines.
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Step by step, each after the terms that it needs.
    let l_sq = l * l;
    let J_right_link_frame_11 = m * l_sq;
    let mr_right_link_frame_3 = l * m;
    let rw_right_link_frame_3 = l * mr_right_link_frame_3;
    let J_right_link_frame_11_2 = rw_right_link_frame_3
        .mul_add(S::int(3), J_right_link_frame_11);
    let s_right_link_frame_in_right_arm_frame_1 = mr_right_link_frame_3 * sin_q_right_ball;
    let s_right_link_frame_in_right_arm_frame_3 = mr_right_link_frame_3 * cos_q_right_ball;
    let J_right_link_frame_in_right_arm_frame = J_right_link_frame_11_2 * sin_q_right_ball;
    let J_right_link_frame_in_right_arm_frame_2 = J_right_link_frame_in_right_arm_frame
        * sin_q_right_ball;
    let J_right_link_frame_in_right_arm_frame_11 = J_right_link_frame_11_2
        - J_right_link_frame_in_right_arm_frame_2;
    let J_right_link_frame_in_right_arm_frame_13 = J_right_link_frame_in_right_arm_frame
        * cos_q_right_ball;
    let m_right_arm_frame = m + mb;
    let mr_right_arm_frame_3 = l * m_right_arm_frame;
    let s_right_arm_frame_3_of_place = S::int(2) * mr_right_arm_frame_3;
    let s_right_arm_frame_3 = s_right_link_frame_in_right_arm_frame_3
        + s_right_arm_frame_3_of_place;
    let w_right_arm_frame_3 = s_right_link_frame_in_right_arm_frame_3 + s_right_arm_frame_3;
    let rw_right_arm_frame_3 = l * w_right_arm_frame_3;
    let s_left_link_frame_in_left_arm_frame_1 = mr_right_link_frame_3 * sin_q_left_ball;
    let s_left_link_frame_in_left_arm_frame_3 = mr_right_link_frame_3 * cos_q_left_ball;
    let J_left_link_frame_in_left_arm_frame = J_right_link_frame_11_2 * sin_q_left_ball;
    let J_left_link_frame_in_left_arm_frame_2 = J_left_link_frame_in_left_arm_frame
        * sin_q_left_ball;
    let J_left_link_frame_in_left_arm_frame_11 = J_right_link_frame_11_2
        - J_left_link_frame_in_left_arm_frame_2;
    let J_left_link_frame_in_left_arm_frame_13 = J_left_link_frame_in_left_arm_frame
        * cos_q_left_ball;
    let s_left_arm_frame_3 = s_left_link_frame_in_left_arm_frame_3 + s_right_arm_frame_3_of_place;
    let w_left_arm_frame_3 = s_left_link_frame_in_left_arm_frame_3 + s_left_arm_frame_3;
    let rw_left_arm_frame_3 = l * w_left_arm_frame_3;
    let J_right_arm_frame_11 = rw_right_arm_frame_3
        .mul_add(
            S::int(6),
            J_right_link_frame_11_2 + J_right_link_frame_in_right_arm_frame_11,
        );
    let l_times_6 = S::int(6) * l;
    let J_right_arm_frame_13 = s_right_link_frame_in_right_arm_frame_1
        .mul_add(l_times_6, J_right_link_frame_in_right_arm_frame_13);
    let J_right_arm_frame_in_spindle_frame_31 = J_right_link_frame_in_right_arm_frame_2
        - J_right_arm_frame_11;
    let J_right_arm_frame_in_spindle_frame = (-(J_right_arm_frame_13 * cos_q_right_top))
        .mul_add(S::int(2), J_right_arm_frame_in_spindle_frame_31 * sin_q_right_top);
    let J_right_arm_frame_in_spindle_frame_2 = J_right_arm_frame_in_spindle_frame * sin_q_right_top;
    let J_right_arm_frame_in_spindle_frame_33 = J_right_link_frame_in_right_arm_frame_2
        - J_right_arm_frame_in_spindle_frame_2;
    let J_left_arm_frame_11 = rw_left_arm_frame_3
        .mul_add(
            S::int(6),
            J_right_link_frame_11_2 + J_left_link_frame_in_left_arm_frame_11,
        );
    let J_left_arm_frame_13 = s_left_link_frame_in_left_arm_frame_1
        .mul_add(l_times_6, J_left_link_frame_in_left_arm_frame_13);
    let J_left_arm_frame_in_spindle_frame_31 = J_left_link_frame_in_left_arm_frame_2
        - J_left_arm_frame_11;
    let J_left_arm_frame_in_spindle_frame = (-(J_left_arm_frame_13 * cos_theta))
        .mul_add(S::int(2), J_left_arm_frame_in_spindle_frame_31 * sin_theta);
    let J_left_arm_frame_in_spindle_frame_2 = J_left_arm_frame_in_spindle_frame * sin_theta;
    let J_left_arm_frame_in_spindle_frame_33 = J_left_link_frame_in_left_arm_frame_2
        - J_left_arm_frame_in_spindle_frame_2;
    let J_spindle_frame_33 = J.mul_add(S::int(12), J_right_arm_frame_in_spindle_frame_33)
        + J_left_arm_frame_in_spindle_frame_33;
    let J_spindle_frame_33_2 = Js.mul_add(S::int(12), J_spindle_frame_33);
    let sin_theta_sq = sin_theta * sin_theta;
    let sin_q_right_top_sq = sin_q_right_top * sin_q_right_top;
    let m22_of_place = sin_theta_sq + sin_q_right_top_sq;
    let mb_times_6 = S::int(6) * mb;
    let m22_of_m_mb = m.mul_add(S::int(5), mb_times_6);
    let m22_of_m_mb_2 = mb.mul_add(S::int(3), S::int(2) * m);
    let sin_q_right_ball_sq = sin_q_right_ball * sin_q_right_ball;
    let m22_of_place_2 = cos_theta * cos_q_left_ball;
    let m22_of_place_3 = S::int(1)
        / (sin_q_right_ball * sin_theta.mul_add(sin_q_left_ball, -m22_of_place_2));
    // Entries that are not zero; upper triangle.
    let m11 = S::ratio(1, 12) * J_spindle_frame_33_2;
    let m22 = S::ratio(1, 3) * l_sq * m22_of_place_3 * m22_of_place_3
        * (m22_of_m_mb_2 * sin_q_right_ball_sq * (S::int(1) - sin_theta_sq)
            + sin_q_left_ball
                * (sin_q_left_ball
                    * (sin_q_right_ball
                        * (sin_q_right_ball
                            * (m * m22_of_place.mul_add(S::int(5), -S::int(2))
                                + S::int(3) * ms + mb_times_6 * (m22_of_place - S::int(1)))
                            - m22_of_m_mb * sin_q_right_top * cos_q_right_top * cos_q_right_ball)
                        + m22_of_m_mb_2 * (S::int(1) - sin_q_right_top_sq))
                    - m22_of_m_mb * sin_q_right_ball_sq * m22_of_place_2 * sin_theta));
    let zero = S::int(0);
    [[m11, zero], [zero, m22]]
}

/// Right-hand side of the linear system; unknowns (spin', opening').
///
/// 294 operations, 6 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 2]) -> [S; 2] {
    let Parameters { l, m, mb, ms, g, .. } = *p;
    let [_, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    let [spin, opening] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_spindle_frame_in_left_arm_frame_1 = spin * sin_theta;
    let w_spindle_frame_in_left_arm_frame_3 = spin * cos_theta;
    let w_spindle_frame_in_right_arm_frame_1 = spin * sin_q_right_top;
    let w_spindle_frame_in_right_arm_frame_3 = spin * cos_q_right_top;
    let sin_q_right_ball_inv = S::int(1) / sin_q_right_ball;
    let theta_plus_q_left_ball = theta + q_left_ball;
    let (sin_theta_plus_q_left_ball, cos_theta_plus_q_left_ball) = theta_plus_q_left_ball
        .sin_cos();
    let w_right_arm_frame_2_of_place = S::int(1) / cos_theta_plus_q_left_ball;
    let w_right_arm_frame_2_of_opening = opening * w_right_arm_frame_2_of_place;
    let w_right_arm_frame_2_of_opening_2 = w_right_arm_frame_2_of_opening * sin_q_left_ball;
    let w_right_arm_frame_2_of_opening_3 = sin_q_right_ball_inv * w_right_arm_frame_2_of_opening_2;
    let w_right_arm_frame_2_of_place_2 = q_right_top + q_right_ball;
    let (sin_angle, cos_angle) = w_right_arm_frame_2_of_place_2.sin_cos();
    let w_right_arm_frame_2 = w_right_arm_frame_2_of_opening_3 * cos_angle;
    let w_left_arm_frame_in_left_link_frame_1 = w_spindle_frame_in_left_arm_frame_3
        .mul_add(sin_q_left_ball, w_spindle_frame_in_left_arm_frame_1 * cos_q_left_ball);
    let w_left_arm_frame_in_left_link_frame_3_of_place = (-w_spindle_frame_in_left_arm_frame_3)
        .mul_add(cos_q_left_ball, w_spindle_frame_in_left_arm_frame_1 * sin_q_left_ball);
    let w_left_arm_frame_in_left_link_frame_3 = -w_left_arm_frame_in_left_link_frame_3_of_place;
    let w_left_link_frame_2_of_place = cos_theta + cos_theta_plus_q_left_ball;
    let w_left_link_frame_2_of_opening = w_right_arm_frame_2_of_opening
        * w_left_link_frame_2_of_place;
    let w_left_link_frame_2 = opening - w_left_link_frame_2_of_opening;
    let w_right_arm_frame_in_right_link_frame_1 = w_spindle_frame_in_right_arm_frame_3
        .mul_add(
            sin_q_right_ball,
            w_spindle_frame_in_right_arm_frame_1 * cos_q_right_ball,
        );
    let w_right_arm_frame_in_right_link_frame_3 = (-w_spindle_frame_in_right_arm_frame_1)
        .mul_add(
            sin_q_right_ball,
            w_spindle_frame_in_right_arm_frame_3 * cos_q_right_ball,
        );
    let w_right_link_frame_2_of_q_right_ball = S::int(1) + cos_q_right_ball;
    let w_right_link_frame_2_of_place = w_right_link_frame_2_of_q_right_ball * cos_q_right_top;
    let w_right_link_frame_2_of_place_2 = (-sin_q_right_top)
        .mul_add(sin_q_right_ball, w_right_link_frame_2_of_place);
    let w_right_link_frame_2_of_opening = w_right_arm_frame_2_of_opening_3
        * w_right_link_frame_2_of_place_2;
    let w_right_link_frame_2 = w_right_link_frame_2_of_opening - w_right_arm_frame_2;
    let alpha_left_arm_frame_1 = opening * w_spindle_frame_in_left_arm_frame_3;
    let w_right_arm_frame_23 = w_spindle_frame_in_right_arm_frame_3 * w_right_arm_frame_2;
    let alpha_right_arm_frame_1 = w_right_arm_frame_23;
    let turn_right_arm_frame_23 = alpha_right_arm_frame_1 + w_right_arm_frame_23;
    let alpha_left_arm_frame_in_left_link_frame_1 = opening
        * w_left_arm_frame_in_left_link_frame_3_of_place;
    let alpha_left_link_frame_1 = w_left_arm_frame_in_left_link_frame_3
        .mul_add(
            w_left_link_frame_2_of_opening, alpha_left_arm_frame_in_left_link_frame_1,
        );
    let w_left_link_frame_23 = w_left_arm_frame_in_left_link_frame_3 * w_left_link_frame_2;
    let turn_left_link_frame_23 = alpha_left_link_frame_1 - w_left_link_frame_23;
    let alpha_right_arm_frame_in_right_link_frame_1 = (-w_right_arm_frame_23)
        .mul_add(
            cos_q_right_ball,
            w_spindle_frame_in_right_arm_frame_1 * w_right_arm_frame_2_of_opening_2 * cos_angle,
        );
    let alpha_right_link_frame_1 = w_right_arm_frame_in_right_link_frame_3
        .mul_add(
            w_right_link_frame_2_of_opening, alpha_right_arm_frame_in_right_link_frame_1,
        );
    let w_right_link_frame_23 = w_right_arm_frame_in_right_link_frame_3 * w_right_link_frame_2;
    let turn_right_link_frame_23 = alpha_right_link_frame_1 + w_right_link_frame_23;
    let a_left_arm_centre_2 = l * alpha_left_arm_frame_1;
    let l_sq_m = l * l * m;
    let H_left_arm_1 = w_spindle_frame_in_left_arm_frame_1 * l_sq_m;
    let H_left_arm_2 = opening * l_sq_m;
    let a_right_arm_centre_2 = l * turn_right_arm_frame_23;
    let H_right_arm_1 = w_spindle_frame_in_right_arm_frame_1 * l_sq_m;
    let H_right_arm_2 = w_right_arm_frame_2 * l_sq_m;
    let a_left_link_centre_2 = (-a_left_arm_centre_2)
        .mul_add(S::int(4), l * turn_left_link_frame_23);
    let H_left_link_1 = w_left_arm_frame_in_left_link_frame_1 * l_sq_m;
    let H_left_link_2 = w_left_link_frame_2 * l_sq_m;
    let a_right_link_centre_2 = (-a_right_arm_centre_2)
        .mul_add(S::int(2), l * turn_right_link_frame_23);
    let H_right_link_1 = w_right_arm_frame_in_right_link_frame_1 * l_sq_m;
    let H_right_link_2 = w_right_link_frame_2 * l_sq_m;
    let F_v_right_link_centre_2 = m * a_right_link_centre_2;
    let F_v_left_link_centre_2 = m * a_left_link_centre_2;
    let mb_times_4 = S::int(4) * mb;
    let m_plus_mb_times_4 = m + mb_times_4;
    let F_v_right_arm_centre_2 = (-F_v_right_link_centre_2)
        .mul_add(S::int(2), a_right_arm_centre_2 * m_plus_mb_times_4);
    let F_v_left_arm_centre_2 = a_left_arm_centre_2
        .mul_add(m_plus_mb_times_4, -F_v_left_link_centre_2);
    let F_w_right_arm_frame_in_right_link_frame_3 = (-w_right_link_frame_2)
        .mul_add(
            H_right_link_1,
            w_right_arm_frame_in_right_link_frame_1 * H_right_link_2,
        );
    let l_times_3 = S::int(3) * l;
    let F_w_right_arm_frame_in_right_link_frame_1 = alpha_right_link_frame_1
        .mul_add(l_sq_m, w_right_arm_frame_in_right_link_frame_3 * H_right_link_2)
        + F_v_right_link_centre_2 * l_times_3;
    let F_w_left_arm_frame_in_left_link_frame_3 = (-w_left_link_frame_2)
        .mul_add(H_left_link_1, w_left_arm_frame_in_left_link_frame_1 * H_left_link_2);
    let F_w_left_arm_frame_in_left_link_frame_1 = (-alpha_left_link_frame_1)
        .mul_add(l_sq_m, w_left_arm_frame_in_left_link_frame_3 * H_left_link_2)
        - F_v_left_link_centre_2 * l_times_3;
    let F_w_spindle_frame_in_right_arm_frame_3 = (-w_right_arm_frame_2)
        .mul_add(H_right_arm_1, w_spindle_frame_in_right_arm_frame_1 * H_right_arm_2)
        - F_w_right_arm_frame_in_right_link_frame_3 * cos_q_right_ball
        + F_w_right_arm_frame_in_right_link_frame_1 * sin_q_right_ball;
    let F_w_spindle_frame_in_right_arm_frame_1 = (-F_w_right_arm_frame_in_right_link_frame_3)
        .mul_add(sin_q_right_ball, w_spindle_frame_in_right_arm_frame_3 * H_right_arm_2)
        - F_w_right_arm_frame_in_right_link_frame_1 * cos_q_right_ball
        + alpha_right_arm_frame_1 * l_sq_m + F_v_right_arm_centre_2 * l_times_3;
    let F_w_spindle_frame_in_left_arm_frame_3 = (-opening)
        .mul_add(H_left_arm_1, w_spindle_frame_in_left_arm_frame_1 * H_left_arm_2)
        + F_w_left_arm_frame_in_left_link_frame_3 * cos_q_left_ball
        - F_w_left_arm_frame_in_left_link_frame_1 * sin_q_left_ball;
    let l_times_6 = S::int(6) * l;
    let F_w_spindle_frame_in_left_arm_frame_1 = F_w_left_arm_frame_in_left_link_frame_3
        .mul_add(sin_q_left_ball, w_spindle_frame_in_left_arm_frame_3 * H_left_arm_2)
        + F_w_left_arm_frame_in_left_link_frame_1 * cos_q_left_ball
        + alpha_left_arm_frame_1 * l_sq_m + F_v_left_arm_centre_2 * l_times_6;
    let w_left_arm_frame_11 = w_spindle_frame_in_left_arm_frame_1
        * w_spindle_frame_in_left_arm_frame_1;
    let w_left_arm_frame_13 = w_spindle_frame_in_left_arm_frame_1
        * w_spindle_frame_in_left_arm_frame_3;
    let w_left_arm_frame_22 = opening * opening;
    let turn_left_arm_frame_33 = w_left_arm_frame_11 + w_left_arm_frame_22;
    let alpha_right_arm_frame_2_of_place = cos_angle - w_right_link_frame_2_of_place_2;
    let alpha_right_arm_frame_2_of_opening = w_right_link_frame_2_of_opening * cos_q_right_ball;
    let alpha_right_arm_frame_2_of_place_2 = w_left_link_frame_2 * sin_theta_plus_q_left_ball;
    let alpha_right_arm_frame_2_of_place_3 = w_right_arm_frame_2_of_place
        * alpha_right_arm_frame_2_of_place_2;
    let alpha_right_arm_frame_2_of_opening_2 = sin_q_right_ball_inv
        * (-(w_right_arm_frame_2_of_opening * w_left_link_frame_2_of_opening))
            .mul_add(
                cos_q_left_ball,
                w_right_arm_frame_2_of_opening_3 * alpha_right_arm_frame_2_of_opening,
            ) + w_right_arm_frame_2_of_opening_3 * alpha_right_arm_frame_2_of_place_3;
    let alpha_right_arm_frame_2 = alpha_right_arm_frame_2_of_opening_2
        .mul_add(
            cos_angle,
            -w_right_arm_frame_2_of_opening_3 * w_right_arm_frame_2_of_opening_3
                * alpha_right_arm_frame_2_of_place * sin_angle,
        );
    let w_right_arm_frame_11 = w_spindle_frame_in_right_arm_frame_1
        * w_spindle_frame_in_right_arm_frame_1;
    let w_right_arm_frame_13 = w_spindle_frame_in_right_arm_frame_1
        * w_spindle_frame_in_right_arm_frame_3;
    let w_right_arm_frame_22 = w_right_arm_frame_2 * w_right_arm_frame_2;
    let turn_right_arm_frame_13 = alpha_right_arm_frame_2 - w_right_arm_frame_13;
    let turn_right_arm_frame_33 = w_right_arm_frame_11 + w_right_arm_frame_22;
    let alpha_left_link_frame_2_of_opening = opening
        .mul_add(sin_theta, alpha_right_arm_frame_2_of_place_2);
    let alpha_left_link_frame_2 = w_right_arm_frame_2_of_opening
        * w_left_link_frame_2_of_place
            .mul_add(
                alpha_right_arm_frame_2_of_place_3, -alpha_left_link_frame_2_of_opening,
            );
    let w_left_link_frame_11 = w_left_arm_frame_in_left_link_frame_1
        * w_left_arm_frame_in_left_link_frame_1;
    let w_left_link_frame_13 = w_left_arm_frame_in_left_link_frame_1
        * w_left_arm_frame_in_left_link_frame_3;
    let w_left_link_frame_22 = w_left_link_frame_2 * w_left_link_frame_2;
    let turn_left_link_frame_13 = alpha_left_link_frame_2 + w_left_link_frame_13;
    let turn_left_link_frame_33 = w_left_link_frame_11 + w_left_link_frame_22;
    let alpha_right_link_frame_2 = -alpha_right_arm_frame_2
        + w_right_link_frame_2_of_place_2 * alpha_right_arm_frame_2_of_opening_2
        - w_right_arm_frame_2_of_opening_3
            * (sin_q_right_top
                * w_right_arm_frame_2
                    .mul_add(
                        w_right_link_frame_2_of_q_right_ball, -alpha_right_arm_frame_2_of_opening,
                    )
                + w_right_arm_frame_2_of_opening_2 * alpha_right_arm_frame_2_of_place
                    * cos_q_right_top);
    let w_right_link_frame_11 = w_right_arm_frame_in_right_link_frame_1
        * w_right_arm_frame_in_right_link_frame_1;
    let w_right_link_frame_13 = w_right_arm_frame_in_right_link_frame_1
        * w_right_arm_frame_in_right_link_frame_3;
    let w_right_link_frame_22 = w_right_link_frame_2 * w_right_link_frame_2;
    let turn_right_link_frame_13 = alpha_right_link_frame_2 + w_right_link_frame_13;
    let turn_right_link_frame_33 = w_right_link_frame_11 + w_right_link_frame_22;
    let a_spindle_frame_in_left_arm_frame_1 = g * sin_theta;
    let a_spindle_frame_in_left_arm_frame_3 = g * cos_theta;
    let l_w_left_arm_frame_13 = l * w_left_arm_frame_13;
    let a_left_arm_centre_1 = (-a_spindle_frame_in_left_arm_frame_1)
        .mul_add(S::int(2), l_w_left_arm_frame_13);
    let a_spindle_frame_in_right_arm_frame_1 = g * sin_q_right_top;
    let a_spindle_frame_in_right_arm_frame_3 = g * cos_q_right_top;
    let a_right_arm_centre_1_of_place = l * turn_right_arm_frame_13;
    let a_right_arm_centre_1 = a_spindle_frame_in_right_arm_frame_1
        .mul_add(S::int(2), a_right_arm_centre_1_of_place);
    let a_left_link_centre_1 = l_w_left_arm_frame_13 - a_spindle_frame_in_left_arm_frame_1;
    let a_left_link_centre_3 = l
        .mul_add(turn_left_arm_frame_33, a_spindle_frame_in_left_arm_frame_3);
    let a_left_arm_frame_in_left_link_frame_1 = (-a_left_link_centre_1)
        .mul_add(cos_q_left_ball, a_left_link_centre_3 * sin_q_left_ball);
    let a_left_arm_frame_in_left_link_frame_3 = a_left_link_centre_3
        .mul_add(cos_q_left_ball, a_left_link_centre_1 * sin_q_left_ball);
    let a_left_link_centre_1_2 = (-a_left_arm_frame_in_left_link_frame_1)
        .mul_add(S::int(2), l * turn_left_link_frame_13);
    let a_left_link_centre_3_2 = a_left_arm_frame_in_left_link_frame_3
        .mul_add(S::int(2), l * turn_left_link_frame_33);
    let a_right_link_centre_1 = a_spindle_frame_in_right_arm_frame_1
        + a_right_arm_centre_1_of_place;
    let a_right_link_centre_3 = l
        .mul_add(turn_right_arm_frame_33, a_spindle_frame_in_right_arm_frame_3);
    let a_right_arm_frame_in_right_link_frame_1 = a_right_link_centre_3
        .mul_add(sin_q_right_ball, a_right_link_centre_1 * cos_q_right_ball);
    let a_right_arm_frame_in_right_link_frame_3 = (-a_right_link_centre_1)
        .mul_add(sin_q_right_ball, a_right_link_centre_3 * cos_q_right_ball);
    let a_right_link_centre_1_2 = (-a_right_arm_frame_in_right_link_frame_1)
        .mul_add(S::int(2), l * turn_right_link_frame_13);
    let a_right_link_centre_3_2 = a_right_arm_frame_in_right_link_frame_3
        .mul_add(S::int(2), l * turn_right_link_frame_33);
    let a_sleeve_centre_3 = g
        + l
            * (w_left_arm_frame_22
                .mul_add(
                    cos_theta,
                    w_left_link_frame_2 * w_left_link_frame_2 * cos_theta_plus_q_left_ball,
                ) - alpha_left_link_frame_2 * sin_theta_plus_q_left_ball);
    let F_v_sleeve_centre_3 = ms * a_sleeve_centre_3;
    let F_v_right_link_centre_1 = m * a_right_link_centre_1_2;
    let F_v_right_arm_frame_in_right_link_frame_3 = m * a_right_link_centre_3_2;
    let F_v_left_link_centre_1 = m * a_left_link_centre_1_2;
    let F_v_left_arm_frame_in_left_link_frame_3 = m * a_left_link_centre_3_2;
    let F_v_right_arm_centre_1 = a_right_link_centre_1
        .mul_add(mb_times_4, m * a_right_arm_centre_1);
    let F_v_left_arm_centre_1 = a_left_link_centre_1
        .mul_add(mb_times_4, m * a_left_arm_centre_1);
    let F_w_right_link_frame_2 = alpha_right_link_frame_2
        .mul_add(l_sq_m, w_right_arm_frame_in_right_link_frame_3 * H_right_link_1)
        + F_v_right_link_centre_1 * l_times_3;
    let F_w_left_link_frame_2 = alpha_left_link_frame_2
        .mul_add(l_sq_m, w_left_arm_frame_in_left_link_frame_3 * H_left_link_1)
        + F_v_left_link_centre_1 * l_times_3;
    let F_w_right_arm_frame_2 = F_w_right_link_frame_2
        + w_spindle_frame_in_right_arm_frame_3 * H_right_arm_1
        - alpha_right_arm_frame_2 * l_sq_m - F_v_right_arm_centre_1 * l_times_3
        + l_times_6
            * F_v_right_arm_frame_in_right_link_frame_3
                .mul_add(sin_q_right_ball, F_v_right_link_centre_1 * cos_q_right_ball);
    let f1_of_place = (-F_w_spindle_frame_in_right_arm_frame_3)
        .mul_add(
            cos_q_right_top,
            F_w_spindle_frame_in_right_arm_frame_1 * sin_q_right_top,
        );
    let f1_of_place_2 = (-F_w_spindle_frame_in_left_arm_frame_3)
        .mul_add(cos_theta, F_w_spindle_frame_in_left_arm_frame_1 * sin_theta);
    let f1_of_place_3 = f1_of_place + f1_of_place_2;
    let f2_of_place = F_v_left_arm_frame_in_left_link_frame_3
        .mul_add(sin_q_left_ball, F_v_left_link_centre_1 * cos_q_left_ball);
    let f2_of_place_2 = w_right_arm_frame_2_of_place
        * (sin_q_left_ball
            * (sin_q_right_ball_inv
                * (-F_w_right_link_frame_2)
                    .mul_add(
                        w_right_link_frame_2_of_place,
                        F_w_right_arm_frame_2 * cos_angle,
                    ) + F_w_right_link_frame_2 * sin_q_right_top)
            - cos_theta
                * (-(l * F_v_sleeve_centre_3 * sin_theta_plus_q_left_ball))
                    .mul_add(S::int(12), F_w_left_link_frame_2))
        + w_spindle_frame_in_left_arm_frame_3 * H_left_arm_1;
    // Values.
    let f1 = -S::ratio(1, 12) * f1_of_place_3;
    let f2 = S::ratio(1, 4) * l
        * ((-(F_v_sleeve_centre_3 * sin_theta)).mul_add(S::int(4), F_v_left_arm_centre_1)
            + S::int(2) * f2_of_place) + S::ratio(1, 12) * f2_of_place_2;
    [f1, f2]
}

/// The accelerations (spin', opening'), solved for when this code was generated.
///
/// 394 operations, 6 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 2]) -> [S; 2] {
    let Parameters { l, m, mb, ms, J, Js, g } = *p;
    let [_, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    let [spin, opening] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_spindle_frame_in_left_arm_frame_1 = spin * sin_theta;
    let w_spindle_frame_in_left_arm_frame_3 = spin * cos_theta;
    let w_spindle_frame_in_right_arm_frame_1 = spin * sin_q_right_top;
    let w_spindle_frame_in_right_arm_frame_3 = spin * cos_q_right_top;
    let sin_q_right_ball_inv = S::int(1) / sin_q_right_ball;
    let theta_plus_q_left_ball = theta + q_left_ball;
    let (sin_theta_plus_q_left_ball, cos_theta_plus_q_left_ball) = theta_plus_q_left_ball
        .sin_cos();
    let w_right_arm_frame_2_of_place = S::int(1) / cos_theta_plus_q_left_ball;
    let w_right_arm_frame_2_of_opening = opening * w_right_arm_frame_2_of_place;
    let w_right_arm_frame_2_of_opening_2 = w_right_arm_frame_2_of_opening * sin_q_left_ball;
    let w_right_arm_frame_2_of_opening_3 = sin_q_right_ball_inv * w_right_arm_frame_2_of_opening_2;
    let w_right_arm_frame_2_of_place_2 = q_right_top + q_right_ball;
    let (sin_angle, cos_angle) = w_right_arm_frame_2_of_place_2.sin_cos();
    let w_right_arm_frame_2 = w_right_arm_frame_2_of_opening_3 * cos_angle;
    let w_left_arm_frame_in_left_link_frame_1 = w_spindle_frame_in_left_arm_frame_3
        .mul_add(sin_q_left_ball, w_spindle_frame_in_left_arm_frame_1 * cos_q_left_ball);
    let w_left_arm_frame_in_left_link_frame_3_of_place = (-w_spindle_frame_in_left_arm_frame_3)
        .mul_add(cos_q_left_ball, w_spindle_frame_in_left_arm_frame_1 * sin_q_left_ball);
    let w_left_arm_frame_in_left_link_frame_3 = -w_left_arm_frame_in_left_link_frame_3_of_place;
    let w_left_link_frame_2_of_place = cos_theta + cos_theta_plus_q_left_ball;
    let w_left_link_frame_2_of_opening = w_right_arm_frame_2_of_opening
        * w_left_link_frame_2_of_place;
    let w_left_link_frame_2 = opening - w_left_link_frame_2_of_opening;
    let w_right_arm_frame_in_right_link_frame_1 = w_spindle_frame_in_right_arm_frame_3
        .mul_add(
            sin_q_right_ball,
            w_spindle_frame_in_right_arm_frame_1 * cos_q_right_ball,
        );
    let w_right_arm_frame_in_right_link_frame_3 = (-w_spindle_frame_in_right_arm_frame_1)
        .mul_add(
            sin_q_right_ball,
            w_spindle_frame_in_right_arm_frame_3 * cos_q_right_ball,
        );
    let w_right_link_frame_2_of_q_right_ball = S::int(1) + cos_q_right_ball;
    let w_right_link_frame_2_of_place = w_right_link_frame_2_of_q_right_ball * cos_q_right_top;
    let w_right_link_frame_2_of_place_2 = (-sin_q_right_top)
        .mul_add(sin_q_right_ball, w_right_link_frame_2_of_place);
    let w_right_link_frame_2_of_opening = w_right_arm_frame_2_of_opening_3
        * w_right_link_frame_2_of_place_2;
    let w_right_link_frame_2 = w_right_link_frame_2_of_opening - w_right_arm_frame_2;
    let alpha_left_arm_frame_1 = opening * w_spindle_frame_in_left_arm_frame_3;
    let w_right_arm_frame_23 = w_spindle_frame_in_right_arm_frame_3 * w_right_arm_frame_2;
    let alpha_right_arm_frame_1 = w_right_arm_frame_23;
    let turn_right_arm_frame_23 = alpha_right_arm_frame_1 + w_right_arm_frame_23;
    let alpha_left_arm_frame_in_left_link_frame_1 = opening
        * w_left_arm_frame_in_left_link_frame_3_of_place;
    let alpha_left_link_frame_1 = w_left_arm_frame_in_left_link_frame_3
        .mul_add(
            w_left_link_frame_2_of_opening, alpha_left_arm_frame_in_left_link_frame_1,
        );
    let w_left_link_frame_23 = w_left_arm_frame_in_left_link_frame_3 * w_left_link_frame_2;
    let turn_left_link_frame_23 = alpha_left_link_frame_1 - w_left_link_frame_23;
    let alpha_right_arm_frame_in_right_link_frame_1 = (-w_right_arm_frame_23)
        .mul_add(
            cos_q_right_ball,
            w_spindle_frame_in_right_arm_frame_1 * w_right_arm_frame_2_of_opening_2 * cos_angle,
        );
    let alpha_right_link_frame_1 = w_right_arm_frame_in_right_link_frame_3
        .mul_add(
            w_right_link_frame_2_of_opening, alpha_right_arm_frame_in_right_link_frame_1,
        );
    let w_right_link_frame_23 = w_right_arm_frame_in_right_link_frame_3 * w_right_link_frame_2;
    let turn_right_link_frame_23 = alpha_right_link_frame_1 + w_right_link_frame_23;
    let a_left_arm_centre_2 = l * alpha_left_arm_frame_1;
    let l_sq = l * l;
    let J_right_link_frame_11 = m * l_sq;
    let H_left_arm_1 = w_spindle_frame_in_left_arm_frame_1 * J_right_link_frame_11;
    let H_left_arm_2 = opening * J_right_link_frame_11;
    let a_right_arm_centre_2 = l * turn_right_arm_frame_23;
    let H_right_arm_1 = w_spindle_frame_in_right_arm_frame_1 * J_right_link_frame_11;
    let H_right_arm_2 = w_right_arm_frame_2 * J_right_link_frame_11;
    let a_left_link_centre_2 = (-a_left_arm_centre_2)
        .mul_add(S::int(4), l * turn_left_link_frame_23);
    let H_left_link_1 = w_left_arm_frame_in_left_link_frame_1 * J_right_link_frame_11;
    let H_left_link_2 = w_left_link_frame_2 * J_right_link_frame_11;
    let a_right_link_centre_2 = (-a_right_arm_centre_2)
        .mul_add(S::int(2), l * turn_right_link_frame_23);
    let H_right_link_1 = w_right_arm_frame_in_right_link_frame_1 * J_right_link_frame_11;
    let H_right_link_2 = w_right_link_frame_2 * J_right_link_frame_11;
    let F_v_right_link_centre_2 = m * a_right_link_centre_2;
    let F_v_left_link_centre_2 = m * a_left_link_centre_2;
    let mb_times_4 = S::int(4) * mb;
    let m_plus_mb_times_4 = m + mb_times_4;
    let F_v_right_arm_centre_2 = (-F_v_right_link_centre_2)
        .mul_add(S::int(2), a_right_arm_centre_2 * m_plus_mb_times_4);
    let F_v_left_arm_centre_2 = a_left_arm_centre_2
        .mul_add(m_plus_mb_times_4, -F_v_left_link_centre_2);
    let F_w_right_arm_frame_in_right_link_frame_3 = (-w_right_link_frame_2)
        .mul_add(
            H_right_link_1,
            w_right_arm_frame_in_right_link_frame_1 * H_right_link_2,
        );
    let l_times_3 = S::int(3) * l;
    let F_w_right_arm_frame_in_right_link_frame_1 = alpha_right_link_frame_1
        .mul_add(
            J_right_link_frame_11,
            w_right_arm_frame_in_right_link_frame_3 * H_right_link_2,
        ) + F_v_right_link_centre_2 * l_times_3;
    let F_w_left_arm_frame_in_left_link_frame_3 = (-w_left_link_frame_2)
        .mul_add(H_left_link_1, w_left_arm_frame_in_left_link_frame_1 * H_left_link_2);
    let F_w_left_arm_frame_in_left_link_frame_1 = (-alpha_left_link_frame_1)
        .mul_add(
            J_right_link_frame_11,
            w_left_arm_frame_in_left_link_frame_3 * H_left_link_2,
        ) - F_v_left_link_centre_2 * l_times_3;
    let F_w_spindle_frame_in_right_arm_frame_3 = (-w_right_arm_frame_2)
        .mul_add(H_right_arm_1, w_spindle_frame_in_right_arm_frame_1 * H_right_arm_2)
        - F_w_right_arm_frame_in_right_link_frame_3 * cos_q_right_ball
        + F_w_right_arm_frame_in_right_link_frame_1 * sin_q_right_ball;
    let F_w_spindle_frame_in_right_arm_frame_1 = (-F_w_right_arm_frame_in_right_link_frame_3)
        .mul_add(sin_q_right_ball, w_spindle_frame_in_right_arm_frame_3 * H_right_arm_2)
        - F_w_right_arm_frame_in_right_link_frame_1 * cos_q_right_ball
        + alpha_right_arm_frame_1 * J_right_link_frame_11 + F_v_right_arm_centre_2 * l_times_3;
    let F_w_spindle_frame_in_left_arm_frame_3 = (-opening)
        .mul_add(H_left_arm_1, w_spindle_frame_in_left_arm_frame_1 * H_left_arm_2)
        + F_w_left_arm_frame_in_left_link_frame_3 * cos_q_left_ball
        - F_w_left_arm_frame_in_left_link_frame_1 * sin_q_left_ball;
    let l_times_6 = S::int(6) * l;
    let F_w_spindle_frame_in_left_arm_frame_1 = F_w_left_arm_frame_in_left_link_frame_3
        .mul_add(sin_q_left_ball, w_spindle_frame_in_left_arm_frame_3 * H_left_arm_2)
        + F_w_left_arm_frame_in_left_link_frame_1 * cos_q_left_ball
        + alpha_left_arm_frame_1 * J_right_link_frame_11 + F_v_left_arm_centre_2 * l_times_6;
    let w_left_arm_frame_11 = w_spindle_frame_in_left_arm_frame_1
        * w_spindle_frame_in_left_arm_frame_1;
    let w_left_arm_frame_13 = w_spindle_frame_in_left_arm_frame_1
        * w_spindle_frame_in_left_arm_frame_3;
    let w_left_arm_frame_22 = opening * opening;
    let turn_left_arm_frame_33 = w_left_arm_frame_11 + w_left_arm_frame_22;
    let alpha_right_arm_frame_2_of_place = cos_angle - w_right_link_frame_2_of_place_2;
    let alpha_right_arm_frame_2_of_place_2 = w_left_link_frame_2 * sin_theta_plus_q_left_ball;
    let alpha_right_arm_frame_2_of_place_3 = w_right_arm_frame_2_of_place
        * alpha_right_arm_frame_2_of_place_2;
    let alpha_right_arm_frame_2_of_opening = sin_q_right_ball_inv
        * (-(w_right_arm_frame_2_of_opening * w_left_link_frame_2_of_opening))
            .mul_add(
                cos_q_left_ball,
                w_right_arm_frame_2_of_opening_3 * w_right_link_frame_2_of_opening
                    * cos_q_right_ball,
            ) + w_right_arm_frame_2_of_opening_3 * alpha_right_arm_frame_2_of_place_3;
    let alpha_right_arm_frame_2 = alpha_right_arm_frame_2_of_opening
        .mul_add(
            cos_angle,
            -w_right_arm_frame_2_of_opening_3 * w_right_arm_frame_2_of_opening_3
                * alpha_right_arm_frame_2_of_place * sin_angle,
        );
    let w_right_arm_frame_11 = w_spindle_frame_in_right_arm_frame_1
        * w_spindle_frame_in_right_arm_frame_1;
    let w_right_arm_frame_13 = w_spindle_frame_in_right_arm_frame_1
        * w_spindle_frame_in_right_arm_frame_3;
    let w_right_arm_frame_22 = w_right_arm_frame_2 * w_right_arm_frame_2;
    let turn_right_arm_frame_13 = alpha_right_arm_frame_2 - w_right_arm_frame_13;
    let turn_right_arm_frame_33 = w_right_arm_frame_11 + w_right_arm_frame_22;
    let alpha_left_link_frame_2_of_opening = opening
        .mul_add(sin_theta, alpha_right_arm_frame_2_of_place_2);
    let alpha_left_link_frame_2 = w_right_arm_frame_2_of_opening
        * w_left_link_frame_2_of_place
            .mul_add(
                alpha_right_arm_frame_2_of_place_3, -alpha_left_link_frame_2_of_opening,
            );
    let w_left_link_frame_11 = w_left_arm_frame_in_left_link_frame_1
        * w_left_arm_frame_in_left_link_frame_1;
    let w_left_link_frame_13 = w_left_arm_frame_in_left_link_frame_1
        * w_left_arm_frame_in_left_link_frame_3;
    let w_left_link_frame_22 = w_left_link_frame_2 * w_left_link_frame_2;
    let turn_left_link_frame_13 = alpha_left_link_frame_2 + w_left_link_frame_13;
    let turn_left_link_frame_33 = w_left_link_frame_11 + w_left_link_frame_22;
    let alpha_right_link_frame_2_of_place = sin_q_right_top * cos_q_right_ball;
    let alpha_right_link_frame_2 = -alpha_right_arm_frame_2
        + w_right_link_frame_2_of_place_2 * alpha_right_arm_frame_2_of_opening
        + w_right_arm_frame_2_of_opening_3
            * ((-(w_right_arm_frame_2 * w_right_link_frame_2_of_q_right_ball))
                .mul_add(
                    sin_q_right_top,
                    w_right_link_frame_2_of_opening * alpha_right_link_frame_2_of_place,
                )
                - w_right_arm_frame_2_of_opening_2 * alpha_right_arm_frame_2_of_place
                    * cos_q_right_top);
    let w_right_link_frame_11 = w_right_arm_frame_in_right_link_frame_1
        * w_right_arm_frame_in_right_link_frame_1;
    let w_right_link_frame_13 = w_right_arm_frame_in_right_link_frame_1
        * w_right_arm_frame_in_right_link_frame_3;
    let w_right_link_frame_22 = w_right_link_frame_2 * w_right_link_frame_2;
    let turn_right_link_frame_13 = alpha_right_link_frame_2 + w_right_link_frame_13;
    let turn_right_link_frame_33 = w_right_link_frame_11 + w_right_link_frame_22;
    let a_spindle_frame_in_left_arm_frame_1 = g * sin_theta;
    let a_spindle_frame_in_left_arm_frame_3 = g * cos_theta;
    let l_w_left_arm_frame_13 = l * w_left_arm_frame_13;
    let a_left_arm_centre_1 = (-a_spindle_frame_in_left_arm_frame_1)
        .mul_add(S::int(2), l_w_left_arm_frame_13);
    let a_spindle_frame_in_right_arm_frame_1 = g * sin_q_right_top;
    let a_spindle_frame_in_right_arm_frame_3 = g * cos_q_right_top;
    let a_right_arm_centre_1_of_place = l * turn_right_arm_frame_13;
    let a_right_arm_centre_1 = a_spindle_frame_in_right_arm_frame_1
        .mul_add(S::int(2), a_right_arm_centre_1_of_place);
    let a_left_link_centre_1 = l_w_left_arm_frame_13 - a_spindle_frame_in_left_arm_frame_1;
    let a_left_link_centre_3 = l
        .mul_add(turn_left_arm_frame_33, a_spindle_frame_in_left_arm_frame_3);
    let a_left_arm_frame_in_left_link_frame_1 = (-a_left_link_centre_1)
        .mul_add(cos_q_left_ball, a_left_link_centre_3 * sin_q_left_ball);
    let a_left_arm_frame_in_left_link_frame_3 = a_left_link_centre_3
        .mul_add(cos_q_left_ball, a_left_link_centre_1 * sin_q_left_ball);
    let a_left_link_centre_1_2 = (-a_left_arm_frame_in_left_link_frame_1)
        .mul_add(S::int(2), l * turn_left_link_frame_13);
    let a_left_link_centre_3_2 = a_left_arm_frame_in_left_link_frame_3
        .mul_add(S::int(2), l * turn_left_link_frame_33);
    let a_right_link_centre_1 = a_spindle_frame_in_right_arm_frame_1
        + a_right_arm_centre_1_of_place;
    let a_right_link_centre_3 = l
        .mul_add(turn_right_arm_frame_33, a_spindle_frame_in_right_arm_frame_3);
    let a_right_arm_frame_in_right_link_frame_1 = a_right_link_centre_3
        .mul_add(sin_q_right_ball, a_right_link_centre_1 * cos_q_right_ball);
    let a_right_arm_frame_in_right_link_frame_3 = (-a_right_link_centre_1)
        .mul_add(sin_q_right_ball, a_right_link_centre_3 * cos_q_right_ball);
    let a_right_link_centre_1_2 = (-a_right_arm_frame_in_right_link_frame_1)
        .mul_add(S::int(2), l * turn_right_link_frame_13);
    let a_right_link_centre_3_2 = a_right_arm_frame_in_right_link_frame_3
        .mul_add(S::int(2), l * turn_right_link_frame_33);
    let a_sleeve_centre_3 = g
        + l
            * (w_left_arm_frame_22
                .mul_add(
                    cos_theta,
                    w_left_link_frame_2 * w_left_link_frame_2 * cos_theta_plus_q_left_ball,
                ) - alpha_left_link_frame_2 * sin_theta_plus_q_left_ball);
    let F_v_sleeve_centre_3 = ms * a_sleeve_centre_3;
    let F_v_right_link_centre_1 = m * a_right_link_centre_1_2;
    let F_v_right_arm_frame_in_right_link_frame_3 = m * a_right_link_centre_3_2;
    let F_v_left_link_centre_1 = m * a_left_link_centre_1_2;
    let F_v_left_arm_frame_in_left_link_frame_3 = m * a_left_link_centre_3_2;
    let F_v_right_arm_centre_1 = a_right_link_centre_1
        .mul_add(mb_times_4, m * a_right_arm_centre_1);
    let F_v_left_arm_centre_1 = a_left_link_centre_1
        .mul_add(mb_times_4, m * a_left_arm_centre_1);
    let F_w_right_link_frame_2 = alpha_right_link_frame_2
        .mul_add(
            J_right_link_frame_11,
            w_right_arm_frame_in_right_link_frame_3 * H_right_link_1,
        ) + F_v_right_link_centre_1 * l_times_3;
    let F_w_left_link_frame_2 = alpha_left_link_frame_2
        .mul_add(
            J_right_link_frame_11,
            w_left_arm_frame_in_left_link_frame_3 * H_left_link_1,
        ) + F_v_left_link_centre_1 * l_times_3;
    let F_w_right_arm_frame_2 = F_w_right_link_frame_2
        + w_spindle_frame_in_right_arm_frame_3 * H_right_arm_1
        - alpha_right_arm_frame_2 * J_right_link_frame_11 - F_v_right_arm_centre_1 * l_times_3
        + l_times_6
            * F_v_right_arm_frame_in_right_link_frame_3
                .mul_add(sin_q_right_ball, F_v_right_link_centre_1 * cos_q_right_ball);
    let mr_right_link_frame_3 = l * m;
    let rw_right_link_frame_3 = l * mr_right_link_frame_3;
    let J_right_link_frame_11_2 = rw_right_link_frame_3
        .mul_add(S::int(3), J_right_link_frame_11);
    let s_right_link_frame_in_right_arm_frame_1 = mr_right_link_frame_3 * sin_q_right_ball;
    let s_right_link_frame_in_right_arm_frame_3 = mr_right_link_frame_3 * cos_q_right_ball;
    let J_right_link_frame_in_right_arm_frame = J_right_link_frame_11_2 * sin_q_right_ball;
    let J_right_link_frame_in_right_arm_frame_2 = J_right_link_frame_in_right_arm_frame
        * sin_q_right_ball;
    let J_right_link_frame_in_right_arm_frame_11 = J_right_link_frame_11_2
        - J_right_link_frame_in_right_arm_frame_2;
    let J_right_link_frame_in_right_arm_frame_13 = J_right_link_frame_in_right_arm_frame
        * cos_q_right_ball;
    let m_right_arm_frame = m + mb;
    let mr_right_arm_frame_3 = l * m_right_arm_frame;
    let s_right_arm_frame_3_of_place = S::int(2) * mr_right_arm_frame_3;
    let s_right_arm_frame_3 = s_right_link_frame_in_right_arm_frame_3
        + s_right_arm_frame_3_of_place;
    let w_right_arm_frame_3 = s_right_link_frame_in_right_arm_frame_3 + s_right_arm_frame_3;
    let rw_right_arm_frame_3 = l * w_right_arm_frame_3;
    let s_left_link_frame_in_left_arm_frame_1 = mr_right_link_frame_3 * sin_q_left_ball;
    let s_left_link_frame_in_left_arm_frame_3 = mr_right_link_frame_3 * cos_q_left_ball;
    let J_left_link_frame_in_left_arm_frame = J_right_link_frame_11_2 * sin_q_left_ball;
    let J_left_link_frame_in_left_arm_frame_2 = J_left_link_frame_in_left_arm_frame
        * sin_q_left_ball;
    let J_left_link_frame_in_left_arm_frame_11 = J_right_link_frame_11_2
        - J_left_link_frame_in_left_arm_frame_2;
    let J_left_link_frame_in_left_arm_frame_13 = J_left_link_frame_in_left_arm_frame
        * cos_q_left_ball;
    let s_left_arm_frame_3 = s_left_link_frame_in_left_arm_frame_3 + s_right_arm_frame_3_of_place;
    let w_left_arm_frame_3 = s_left_link_frame_in_left_arm_frame_3 + s_left_arm_frame_3;
    let rw_left_arm_frame_3 = l * w_left_arm_frame_3;
    let J_right_arm_frame_11 = rw_right_arm_frame_3
        .mul_add(
            S::int(6),
            J_right_link_frame_11_2 + J_right_link_frame_in_right_arm_frame_11,
        );
    let J_right_arm_frame_13 = s_right_link_frame_in_right_arm_frame_1
        .mul_add(l_times_6, J_right_link_frame_in_right_arm_frame_13);
    let J_right_arm_frame_in_spindle_frame_31 = J_right_link_frame_in_right_arm_frame_2
        - J_right_arm_frame_11;
    let J_right_arm_frame_in_spindle_frame = (-(J_right_arm_frame_13 * cos_q_right_top))
        .mul_add(S::int(2), J_right_arm_frame_in_spindle_frame_31 * sin_q_right_top);
    let J_right_arm_frame_in_spindle_frame_2 = J_right_arm_frame_in_spindle_frame * sin_q_right_top;
    let J_right_arm_frame_in_spindle_frame_33 = J_right_link_frame_in_right_arm_frame_2
        - J_right_arm_frame_in_spindle_frame_2;
    let J_left_arm_frame_11 = rw_left_arm_frame_3
        .mul_add(
            S::int(6),
            J_right_link_frame_11_2 + J_left_link_frame_in_left_arm_frame_11,
        );
    let J_left_arm_frame_13 = s_left_link_frame_in_left_arm_frame_1
        .mul_add(l_times_6, J_left_link_frame_in_left_arm_frame_13);
    let J_left_arm_frame_in_spindle_frame_31 = J_left_link_frame_in_left_arm_frame_2
        - J_left_arm_frame_11;
    let J_left_arm_frame_in_spindle_frame = (-(J_left_arm_frame_13 * cos_theta))
        .mul_add(S::int(2), J_left_arm_frame_in_spindle_frame_31 * sin_theta);
    let J_left_arm_frame_in_spindle_frame_2 = J_left_arm_frame_in_spindle_frame * sin_theta;
    let J_left_arm_frame_in_spindle_frame_33 = J_left_link_frame_in_left_arm_frame_2
        - J_left_arm_frame_in_spindle_frame_2;
    let J_spindle_frame_33 = J.mul_add(S::int(12), J_right_arm_frame_in_spindle_frame_33)
        + J_left_arm_frame_in_spindle_frame_33;
    let J_spindle_frame_33_2 = Js.mul_add(S::int(12), J_spindle_frame_33);
    let d1 = S::ratio(1, 12) * J_spindle_frame_33_2;
    let sin_q_right_ball_inv_sq = sin_q_right_ball_inv * sin_q_right_ball_inv;
    let mb_times_3 = S::int(3) * mb;
    let mb_times_6 = S::int(6) * mb;
    let d2_of_m_mb = m.mul_add(S::int(5), mb_times_6);
    let cos_theta_sq = cos_theta * cos_theta;
    let d2_of_place = cos_theta * cos_q_left_ball;
    let d2_of_place_2 = S::int(1) / sin_theta.mul_add(sin_q_left_ball, -d2_of_place);
    let d2 = S::ratio(1, 3) * l_sq * d2_of_place_2 * d2_of_place_2
        * (cos_theta_sq * m.mul_add(S::int(2), mb_times_3)
            + sin_q_left_ball
                * (sin_q_left_ball
                    * (cos_q_right_top
                        * (cos_q_right_top
                            * (m * sin_q_right_ball_inv_sq.mul_add(S::int(2), -S::int(5))
                                + mb_times_3 * (sin_q_right_ball_inv_sq - S::int(2)))
                            - sin_q_right_ball_inv * alpha_right_link_frame_2_of_place
                                * d2_of_m_mb) + S::int(3) * ms
                        + m * (-cos_theta_sq).mul_add(S::int(5), S::int(8))
                        + mb_times_6 * (S::int(1) - cos_theta_sq))
                    - d2_of_m_mb * d2_of_place * sin_theta));
    let opening_dot_of_place = F_v_left_arm_frame_in_left_link_frame_3
        .mul_add(sin_q_left_ball, F_v_left_link_centre_1 * cos_q_left_ball);
    let opening_dot = S::ratio(1, 12)
        * (w_right_arm_frame_2_of_place
            * (sin_q_left_ball
                * (sin_q_right_ball_inv
                    * (-F_w_right_link_frame_2)
                        .mul_add(
                            w_right_link_frame_2_of_place,
                            F_w_right_arm_frame_2 * cos_angle,
                        ) + F_w_right_link_frame_2 * sin_q_right_top)
                - cos_theta
                    * (-(l * F_v_sleeve_centre_3 * sin_theta_plus_q_left_ball))
                        .mul_add(S::int(12), F_w_left_link_frame_2))
            + w_spindle_frame_in_left_arm_frame_3 * H_left_arm_1
            + l_times_3
                * ((-(F_v_sleeve_centre_3 * sin_theta))
                    .mul_add(S::int(4), F_v_left_arm_centre_1)
                    + S::int(2) * opening_dot_of_place)) / d2;
    let spin_dot = S::ratio(1, 12)
        * ((-F_w_spindle_frame_in_right_arm_frame_1)
            .mul_add(
                sin_q_right_top,
                F_w_spindle_frame_in_right_arm_frame_3 * cos_q_right_top,
            ) + F_w_spindle_frame_in_left_arm_frame_3 * cos_theta
            - F_w_spindle_frame_in_left_arm_frame_1 * sin_theta) / d1;
    [spin_dot, opening_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 14 operations, 6 sines and cosines.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
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
    let q_right_top_dot_value_of_opening = opening / cos_theta_plus_q_left_ball;
    let q_right_top_dot_value_of_opening_2 = q_right_top_dot_value_of_opening
        * sin_q_left_ball / sin_q_right_ball;
    let (_, cos_angle) = (q_right_top + q_right_ball).sin_cos();
    // Values.
    // psi' = spin
    let psi_dot_value = spin;
    // theta' = opening
    let theta_dot_value = opening;
    // q_right_top' = opening*sin(q_left_ball)*cos(q_right_top + q_right_ball)/(cos(theta +
    //   q_left_ball)*sin(q_right_ball))
    let q_right_top_dot_value = q_right_top_dot_value_of_opening_2 * cos_angle;
    // q_left_ball' = -opening*(cos(theta) + cos(theta + q_left_ball))/cos(theta + q_left_ball)
    let q_left_ball_dot_value = -q_right_top_dot_value_of_opening
        * (cos_theta + cos_theta_plus_q_left_ball);
    // q_right_ball' = opening*sin(q_left_ball)*(sin(q_right_top)*sin(q_right_ball) - cos(q_right_top)*(1 +
    //   cos(q_right_ball)))/(cos(theta + q_left_ball)*sin(q_right_ball))
    let q_right_ball_dot_value = q_right_top_dot_value_of_opening_2
        * (-cos_q_right_top * (S::int(1) + cos_q_right_ball) + sin_q_right_top * sin_q_right_ball);
    [
        psi_dot_value, theta_dot_value, q_right_top_dot_value, q_left_ball_dot_value,
        q_right_ball_dot_value,
    ]
}

/// Kinetic energy T.
///
/// 111 operations, 6 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 2]) -> S {
    let Parameters { l, m, mb, ms, J, Js, .. } = *p;
    let [_, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    let [spin, opening] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_spindle_frame_in_left_arm_frame_1 = spin * sin_theta;
    let w_spindle_frame_in_left_arm_frame_3 = spin * cos_theta;
    let w_spindle_frame_in_right_arm_frame_1 = spin * sin_q_right_top;
    let w_spindle_frame_in_right_arm_frame_3 = spin * cos_q_right_top;
    let theta_plus_q_left_ball = theta + q_left_ball;
    let (sin_theta_plus_q_left_ball, cos_theta_plus_q_left_ball) = theta_plus_q_left_ball
        .sin_cos();
    let w_right_arm_frame_2_of_opening = opening / cos_theta_plus_q_left_ball;
    let w_right_arm_frame_2_of_opening_2 = w_right_arm_frame_2_of_opening
        * sin_q_left_ball / sin_q_right_ball;
    let (_, cos_angle) = (q_right_top + q_right_ball).sin_cos();
    let w_right_arm_frame_2 = w_right_arm_frame_2_of_opening_2 * cos_angle;
    let w_left_arm_frame_in_left_link_frame_1 = w_spindle_frame_in_left_arm_frame_3
        .mul_add(sin_q_left_ball, w_spindle_frame_in_left_arm_frame_1 * cos_q_left_ball);
    let w_left_link_frame_2 = opening
        - w_right_arm_frame_2_of_opening * (cos_theta + cos_theta_plus_q_left_ball);
    let w_right_arm_frame_in_right_link_frame_1 = w_spindle_frame_in_right_arm_frame_3
        .mul_add(
            sin_q_right_ball,
            w_spindle_frame_in_right_arm_frame_1 * cos_q_right_ball,
        );
    let w_right_link_frame_2 = w_right_arm_frame_2_of_opening_2
        * (cos_q_right_top * (S::int(1) + cos_q_right_ball)
            - sin_q_right_top * sin_q_right_ball) - w_right_arm_frame_2;
    let l_sq_m = l * l * m;
    let H_left_arm_1 = w_spindle_frame_in_left_arm_frame_1 * l_sq_m;
    let H_left_arm_2 = opening * l_sq_m;
    let H_right_arm_1 = w_spindle_frame_in_right_arm_frame_1 * l_sq_m;
    let H_right_arm_2 = w_right_arm_frame_2 * l_sq_m;
    let H_left_link_1 = w_left_arm_frame_in_left_link_frame_1 * l_sq_m;
    let H_left_link_2 = w_left_link_frame_2 * l_sq_m;
    let H_right_link_1 = w_right_arm_frame_in_right_link_frame_1 * l_sq_m;
    let H_right_link_2 = w_right_link_frame_2 * l_sq_m;
    let H_spindle_3 = J * spin;
    let v_left_arm_centre_1 = l * opening;
    let v_left_arm_centre_2 = l * w_spindle_frame_in_left_arm_frame_1;
    let v_right_arm_centre_1 = l * w_right_arm_frame_2;
    let v_right_arm_centre_2 = l * w_spindle_frame_in_right_arm_frame_1;
    let v_left_arm_frame_in_left_link_frame_1 = v_left_arm_centre_1 * cos_q_left_ball;
    let v_left_arm_frame_in_left_link_frame_3 = v_left_arm_centre_1 * sin_q_left_ball;
    let v_left_link_centre_1 = v_left_arm_frame_in_left_link_frame_1
        .mul_add(S::int(2), l * w_left_link_frame_2);
    let v_left_link_centre_2 = v_left_arm_centre_2
        .mul_add(S::int(2), l * w_left_arm_frame_in_left_link_frame_1);
    let v_right_arm_frame_in_right_link_frame_1 = v_right_arm_centre_1 * cos_q_right_ball;
    let v_right_arm_frame_in_right_link_frame_3 = v_right_arm_centre_1 * sin_q_right_ball;
    let v_right_link_centre_1 = (-v_right_arm_frame_in_right_link_frame_1)
        .mul_add(S::int(2), l * w_right_link_frame_2);
    let v_right_link_centre_2 = v_right_arm_centre_2
        .mul_add(S::int(2), l * w_right_arm_frame_in_right_link_frame_1);
    let v_sleeve_centre_3 = l
        * w_left_link_frame_2.mul_add(sin_theta_plus_q_left_ball, opening * sin_theta);
    let H_sleeve_3 = Js * spin;
    let m_plus_mb_times_4 = mb.mul_add(S::int(4), m);
    let energy_of_place = v_left_arm_centre_2
        .mul_add(v_left_arm_centre_2, v_left_arm_centre_1 * v_left_arm_centre_1);
    let energy_of_place_2 = v_right_arm_centre_2
        .mul_add(v_right_arm_centre_2, v_right_arm_centre_1 * v_right_arm_centre_1);
    let energy_of_place_3 = v_left_link_centre_2
        .mul_add(v_left_link_centre_2, v_left_link_centre_1 * v_left_link_centre_1);
    let energy_of_place_4 = v_right_link_centre_2
        .mul_add(v_right_link_centre_2, v_right_link_centre_1 * v_right_link_centre_1);
    let energy_of_place_5 = m
        * v_right_arm_frame_in_right_link_frame_3
            .mul_add(
                v_right_arm_frame_in_right_link_frame_3,
                v_left_arm_frame_in_left_link_frame_3 * v_left_arm_frame_in_left_link_frame_3,
            ) + ms * v_sleeve_centre_3 * v_sleeve_centre_3;
    let energy_of_opening = opening
        .mul_add(H_left_arm_2, w_spindle_frame_in_left_arm_frame_1 * H_left_arm_1);
    let energy_of_place_6 = w_right_arm_frame_2
        .mul_add(H_right_arm_2, w_spindle_frame_in_right_arm_frame_1 * H_right_arm_1);
    let energy_of_place_7 = w_left_link_frame_2
        .mul_add(H_left_link_2, w_left_arm_frame_in_left_link_frame_1 * H_left_link_1);
    let energy_of_place_8 = w_right_link_frame_2
        .mul_add(
            H_right_link_2,
            w_right_arm_frame_in_right_link_frame_1 * H_right_link_1,
        );
    let energy_of_opening_2 = energy_of_opening + energy_of_place_6;
    let energy_of_place_9 = energy_of_place_7 + energy_of_place_8;
    let energy_of_spin = spin * (H_spindle_3 + H_sleeve_3) + energy_of_place_5;
    let energy_of_opening_3 = energy_of_opening_2 + energy_of_place_9;
    // Values.
    let energy = S::ratio(1, 8) * m_plus_mb_times_4 * (energy_of_place + energy_of_place_2)
        + S::ratio(1, 8) * m * (energy_of_place_3 + energy_of_place_4)
        + S::ratio(1, 2) * energy_of_spin + S::ratio(1, 24) * energy_of_opening_3;
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
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let l_m = l * m;
    // mr_right_link_frame_3 = l*m
    let mr_right_link_frame_3 = l_m;
    // s_right_link_frame_in_right_arm_frame_1 = mr_right_link_frame_3*sin(q_right_ball)
    let s_right_link_frame_in_right_arm_frame_1 = mr_right_link_frame_3 * sin_q_right_ball;
    // s_right_link_frame_in_right_arm_frame_3 = mr_right_link_frame_3*cos(q_right_ball)
    let s_right_link_frame_in_right_arm_frame_3 = mr_right_link_frame_3 * cos_q_right_ball;
    // s_left_link_frame_in_left_arm_frame_1 = mr_right_link_frame_3*sin(q_left_ball)
    let s_left_link_frame_in_left_arm_frame_1 = mr_right_link_frame_3 * sin_q_left_ball;
    // s_left_link_frame_in_left_arm_frame_3 = mr_right_link_frame_3*cos(q_left_ball)
    let s_left_link_frame_in_left_arm_frame_3 = mr_right_link_frame_3 * cos_q_left_ball;
    let (_, cos_theta_plus_q_left_ball) = (theta + q_left_ball).sin_cos();
    // mr_spindle_frame_3 = l*ms*(cos(theta) + cos(theta + q_left_ball))
    let mr_spindle_frame_3 = l * ms * (cos_theta + cos_theta_plus_q_left_ball);
    // mp_left_arm_frame_3 = 3*l*m + 2*l*mb
    let mp_left_arm_frame_3 = (l * mb).mul_add(S::int(2), S::int(3) * l_m);
    // x_N_3 = s_left_link_frame_in_left_arm_frame_3 + mp_left_arm_frame_3
    let x_N_3 = s_left_link_frame_in_left_arm_frame_3 + mp_left_arm_frame_3;
    // x_N_3_2 = s_right_link_frame_in_right_arm_frame_3 + mp_left_arm_frame_3
    let x_N_3_2 = s_right_link_frame_in_right_arm_frame_3 + mp_left_arm_frame_3;
    // x_left_arm_frame_in_spindle_frame_3 = s_left_link_frame_in_left_arm_frame_1*sin(theta) -
    //   x_N_3*cos(theta)
    let x_left_arm_frame_in_spindle_frame_3 = (-x_N_3)
        .mul_add(cos_theta, s_left_link_frame_in_left_arm_frame_1 * sin_theta);
    // x_N_3_3 = 2*mr_spindle_frame_3 - x_left_arm_frame_in_spindle_frame_3
    let x_N_3_3 = mr_spindle_frame_3
        .mul_add(S::int(2), -x_left_arm_frame_in_spindle_frame_3);
    // x_right_arm_frame_in_spindle_frame_3 = s_right_link_frame_in_right_arm_frame_1*sin(q_right_top) -
    //   x_N_3_2*cos(q_right_top)
    let x_right_arm_frame_in_spindle_frame_3 = (-x_N_3_2)
        .mul_add(
            cos_q_right_top,
            s_right_link_frame_in_right_arm_frame_1 * sin_q_right_top,
        );
    // x_N_3_4 = x_N_3_3 - x_right_arm_frame_in_spindle_frame_3
    let x_N_3_4 = x_N_3_3 - x_right_arm_frame_in_spindle_frame_3;
    // Values.
    // V = -g*x_N_3_4/2
    let energy = -S::ratio(1, 2) * g * x_N_3_4;
    energy
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 104 operations, 5 sines and cosines.
#[must_use]
pub fn divisors<S: Scalar>(p: &Parameters<S>, q: &[S; 5], _u: &[S; 2]) -> [S; 5] {
    let Parameters { l, m, mb, ms, J, Js, .. } = *p;
    let [_, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    // Sines and cosines.
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Step by step, each after the terms that it needs.
    let l_sq = l * l;
    let J_right_link_frame_11 = m * l_sq;
    let mr_right_link_frame_3 = l * m;
    let rw_right_link_frame_3 = l * mr_right_link_frame_3;
    let J_right_link_frame_11_2 = rw_right_link_frame_3
        .mul_add(S::int(3), J_right_link_frame_11);
    let s_right_link_frame_in_right_arm_frame_1 = mr_right_link_frame_3 * sin_q_right_ball;
    let s_right_link_frame_in_right_arm_frame_3 = mr_right_link_frame_3 * cos_q_right_ball;
    let J_right_link_frame_in_right_arm_frame = J_right_link_frame_11_2 * sin_q_right_ball;
    let J_right_link_frame_in_right_arm_frame_2 = J_right_link_frame_in_right_arm_frame
        * sin_q_right_ball;
    let J_right_link_frame_in_right_arm_frame_11 = J_right_link_frame_11_2
        - J_right_link_frame_in_right_arm_frame_2;
    let J_right_link_frame_in_right_arm_frame_13 = J_right_link_frame_in_right_arm_frame
        * cos_q_right_ball;
    let m_right_arm_frame = m + mb;
    let mr_right_arm_frame_3 = l * m_right_arm_frame;
    let s_right_arm_frame_3_of_place = S::int(2) * mr_right_arm_frame_3;
    let s_right_arm_frame_3 = s_right_link_frame_in_right_arm_frame_3
        + s_right_arm_frame_3_of_place;
    let w_right_arm_frame_3 = s_right_link_frame_in_right_arm_frame_3 + s_right_arm_frame_3;
    let rw_right_arm_frame_3 = l * w_right_arm_frame_3;
    let s_left_link_frame_in_left_arm_frame_1 = mr_right_link_frame_3 * sin_q_left_ball;
    let s_left_link_frame_in_left_arm_frame_3 = mr_right_link_frame_3 * cos_q_left_ball;
    let J_left_link_frame_in_left_arm_frame = J_right_link_frame_11_2 * sin_q_left_ball;
    let J_left_link_frame_in_left_arm_frame_2 = J_left_link_frame_in_left_arm_frame
        * sin_q_left_ball;
    let J_left_link_frame_in_left_arm_frame_11 = J_right_link_frame_11_2
        - J_left_link_frame_in_left_arm_frame_2;
    let J_left_link_frame_in_left_arm_frame_13 = J_left_link_frame_in_left_arm_frame
        * cos_q_left_ball;
    let s_left_arm_frame_3 = s_left_link_frame_in_left_arm_frame_3 + s_right_arm_frame_3_of_place;
    let w_left_arm_frame_3 = s_left_link_frame_in_left_arm_frame_3 + s_left_arm_frame_3;
    let rw_left_arm_frame_3 = l * w_left_arm_frame_3;
    let J_right_arm_frame_11 = rw_right_arm_frame_3
        .mul_add(
            S::int(6),
            J_right_link_frame_11_2 + J_right_link_frame_in_right_arm_frame_11,
        );
    let l_times_6 = S::int(6) * l;
    let J_right_arm_frame_13 = s_right_link_frame_in_right_arm_frame_1
        .mul_add(l_times_6, J_right_link_frame_in_right_arm_frame_13);
    let J_right_arm_frame_in_spindle_frame_31 = J_right_link_frame_in_right_arm_frame_2
        - J_right_arm_frame_11;
    let J_right_arm_frame_in_spindle_frame = (-(J_right_arm_frame_13 * cos_q_right_top))
        .mul_add(S::int(2), J_right_arm_frame_in_spindle_frame_31 * sin_q_right_top);
    let J_right_arm_frame_in_spindle_frame_2 = J_right_arm_frame_in_spindle_frame * sin_q_right_top;
    let J_right_arm_frame_in_spindle_frame_33 = J_right_link_frame_in_right_arm_frame_2
        - J_right_arm_frame_in_spindle_frame_2;
    let J_left_arm_frame_11 = rw_left_arm_frame_3
        .mul_add(
            S::int(6),
            J_right_link_frame_11_2 + J_left_link_frame_in_left_arm_frame_11,
        );
    let J_left_arm_frame_13 = s_left_link_frame_in_left_arm_frame_1
        .mul_add(l_times_6, J_left_link_frame_in_left_arm_frame_13);
    let J_left_arm_frame_in_spindle_frame_31 = J_left_link_frame_in_left_arm_frame_2
        - J_left_arm_frame_11;
    let J_left_arm_frame_in_spindle_frame = (-(J_left_arm_frame_13 * cos_theta))
        .mul_add(S::int(2), J_left_arm_frame_in_spindle_frame_31 * sin_theta);
    let J_left_arm_frame_in_spindle_frame_2 = J_left_arm_frame_in_spindle_frame * sin_theta;
    let J_left_arm_frame_in_spindle_frame_33 = J_left_link_frame_in_left_arm_frame_2
        - J_left_arm_frame_in_spindle_frame_2;
    let J_spindle_frame_33 = J.mul_add(S::int(12), J_right_arm_frame_in_spindle_frame_33)
        + J_left_arm_frame_in_spindle_frame_33;
    let J_spindle_frame_33_2 = Js.mul_add(S::int(12), J_spindle_frame_33);
    let d1 = S::ratio(1, 12) * J_spindle_frame_33_2;
    let sin_q_right_ball_inv = S::int(1) / sin_q_right_ball;
    let sin_q_right_ball_inv_sq = sin_q_right_ball_inv * sin_q_right_ball_inv;
    let mb_times_3 = S::int(3) * mb;
    let mb_times_6 = S::int(6) * mb;
    let d2_of_m_mb = m.mul_add(S::int(5), mb_times_6);
    let cos_theta_sq = cos_theta * cos_theta;
    let d2_of_place = cos_theta * cos_q_left_ball;
    let d2_of_place_2 = sin_theta.mul_add(sin_q_left_ball, -d2_of_place);
    let d2_of_place_2_inv = S::int(1) / d2_of_place_2;
    let d2 = S::ratio(1, 3) * l_sq * d2_of_place_2_inv * d2_of_place_2_inv
        * (cos_theta_sq * m.mul_add(S::int(2), mb_times_3)
            + sin_q_left_ball
                * (sin_q_left_ball
                    * (cos_q_right_top
                        * (cos_q_right_top
                            * (m * sin_q_right_ball_inv_sq.mul_add(S::int(2), -S::int(5))
                                + mb_times_3 * (sin_q_right_ball_inv_sq - S::int(2)))
                            - sin_q_right_ball_inv * d2_of_m_mb * sin_q_right_top
                                * cos_q_right_ball) + S::int(3) * ms
                        + m * (-cos_theta_sq).mul_add(S::int(5), S::int(8))
                        + mb_times_6 * (S::int(1) - cos_theta_sq))
                    - d2_of_m_mb * d2_of_place * sin_theta));
    let (_, cos_theta_plus_q_left_ball) = (theta + q_left_ball).sin_cos();
    // Values.
    let divisor1 = cos_theta_plus_q_left_ball;
    let divisor2 = sin_q_right_ball;
    let divisor3 = d2_of_place_2;
    [divisor1, divisor2, divisor3, d2, d1]
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 12 operations, 4 sines and cosines.
#[must_use]
pub fn constraints<S: Scalar>(p: &Parameters<S>, q: &[S; 5], _u: &[S; 2]) -> [S; 3] {
    let Parameters { l, .. } = *p;
    let [_, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    // Shared terms.
    // theta + q_left_ball
    let theta_plus_q_left_ball = theta + q_left_ball;
    let (sin_theta_plus_q_left_ball, cos_theta_plus_q_left_ball) = theta_plus_q_left_ball
        .sin_cos();
    // cos(theta) + cos(theta + q_left_ball)
    let residual3_of_place = cos_theta + cos_theta_plus_q_left_ball;
    // q_right_top + q_right_ball
    let residual2_of_place = q_right_top + q_right_ball;
    let (sin_angle, cos_angle) = residual2_of_place.sin_cos();
    // cos(q_right_top) + cos(q_right_top + q_right_ball)
    let residual3_of_place_2 = cos_q_right_top + cos_angle;
    // Values.
    // left_end_1 = -l*(sin(theta) + sin(theta + q_left_ball))
    let residual1 = -l * (sin_theta + sin_theta_plus_q_left_ball);
    // right_end_1 = -l*(sin(q_right_top) + sin(q_right_top + q_right_ball))
    let residual2 = -l * (sin_q_right_top + sin_angle);
    // right_end_3 = l*(cos(theta) + cos(theta + q_left_ball)) - l*(cos(q_right_top) + cos(q_right_top +
    //   q_right_ball))
    let residual3 = l * (residual3_of_place - residual3_of_place_2);
    [residual1, residual2, residual3]
}

/// Slopes of the constraints, one after the other, along psi, theta, q_right_top, q_left_ball, q_right_ball, spin, opening.
///
/// 20 operations, 4 sines and cosines.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 2],
) -> [S; 21] {
    let Parameters { l, .. } = *p;
    let [_, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    // Shared terms.
    // theta + q_left_ball
    let theta_plus_q_left_ball = theta + q_left_ball;
    let (sin_theta_plus_q_left_ball, cos_theta_plus_q_left_ball) = theta_plus_q_left_ball
        .sin_cos();
    // q_right_top + q_right_ball
    let residual2_by_q_right_top_of_place = q_right_top + q_right_ball;
    let (sin_angle, cos_angle) = residual2_by_q_right_top_of_place.sin_cos();
    // Values.
    // d(left_end_1)/d(theta) = -l*(cos(theta) + cos(theta + q_left_ball))
    let residual1_by_theta = -l * (cos_theta + cos_theta_plus_q_left_ball);
    // d(left_end_1)/d(q_left_ball) = -l*cos(theta + q_left_ball)
    let residual1_by_q_left_ball = -l * cos_theta_plus_q_left_ball;
    // d(right_end_1)/d(q_right_top) = -l*(cos(q_right_top) + cos(q_right_top + q_right_ball))
    let residual2_by_q_right_top = -l * (cos_q_right_top + cos_angle);
    // d(right_end_1)/d(q_right_ball) = -l*cos(q_right_top + q_right_ball)
    let residual2_by_q_right_ball = -l * cos_angle;
    // d(right_end_3)/d(theta) = -l*(sin(theta) + sin(theta + q_left_ball))
    let residual3_by_theta = -l * (sin_theta + sin_theta_plus_q_left_ball);
    // d(right_end_3)/d(q_right_top) = l*(sin(q_right_top) + sin(q_right_top + q_right_ball))
    let residual3_by_q_right_top = l * (sin_q_right_top + sin_angle);
    // d(right_end_3)/d(q_left_ball) = -l*sin(theta + q_left_ball)
    let residual3_by_q_left_ball = -l * sin_theta_plus_q_left_ball;
    // d(right_end_3)/d(q_right_ball) = l*sin(q_right_top + q_right_ball)
    let residual3_by_q_right_ball = l * sin_angle;
    let zero = S::int(0);
    [
        zero, residual1_by_theta, zero, residual1_by_q_left_ball, zero, zero, zero, zero, zero,
        residual2_by_q_right_top, zero, residual2_by_q_right_ball, zero, zero, zero,
        residual3_by_theta, residual3_by_q_right_top, residual3_by_q_left_ball,
        residual3_by_q_right_ball, zero, zero,
    ]
}

/// Inverse dynamics: the generalized forces along (spin, opening) that must act beside the loads of the model for the accelerations to be (spin', opening').
///
/// 313 operations, 6 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { l, m, mb, ms, J, Js, g } = *p;
    let [_, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    let [spin, opening] = *u;
    let [spin_dot, opening_dot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_spindle_frame_in_left_arm_frame_1 = spin * sin_theta;
    let w_spindle_frame_in_left_arm_frame_3 = spin * cos_theta;
    let w_spindle_frame_in_right_arm_frame_1 = spin * sin_q_right_top;
    let w_spindle_frame_in_right_arm_frame_3 = spin * cos_q_right_top;
    let theta_plus_q_left_ball = theta + q_left_ball;
    let (sin_theta_plus_q_left_ball, cos_theta_plus_q_left_ball) = theta_plus_q_left_ball
        .sin_cos();
    let w_right_arm_frame_2_of_place = S::int(1) / cos_theta_plus_q_left_ball;
    let w_right_arm_frame_2_of_opening = opening * w_right_arm_frame_2_of_place;
    let sin_q_right_ball_inv = S::int(1) / sin_q_right_ball;
    let w_right_arm_frame_2_of_place_2 = sin_q_right_ball_inv * sin_q_left_ball;
    let w_right_arm_frame_2_of_opening_2 = w_right_arm_frame_2_of_opening
        * w_right_arm_frame_2_of_place_2;
    let w_right_arm_frame_2_of_place_3 = q_right_top + q_right_ball;
    let (sin_angle, cos_angle) = w_right_arm_frame_2_of_place_3.sin_cos();
    let w_right_arm_frame_2 = w_right_arm_frame_2_of_opening_2 * cos_angle;
    let w_left_arm_frame_in_left_link_frame_1 = w_spindle_frame_in_left_arm_frame_3
        .mul_add(sin_q_left_ball, w_spindle_frame_in_left_arm_frame_1 * cos_q_left_ball);
    let w_left_arm_frame_in_left_link_frame_3 = (-w_spindle_frame_in_left_arm_frame_1)
        .mul_add(sin_q_left_ball, w_spindle_frame_in_left_arm_frame_3 * cos_q_left_ball);
    let w_left_link_frame_2_of_place = cos_theta + cos_theta_plus_q_left_ball;
    let w_left_link_frame_2_of_opening = w_right_arm_frame_2_of_opening
        * w_left_link_frame_2_of_place;
    let w_left_link_frame_2 = opening - w_left_link_frame_2_of_opening;
    let w_right_arm_frame_in_right_link_frame_1 = w_spindle_frame_in_right_arm_frame_3
        .mul_add(
            sin_q_right_ball,
            w_spindle_frame_in_right_arm_frame_1 * cos_q_right_ball,
        );
    let w_right_arm_frame_in_right_link_frame_3 = (-w_spindle_frame_in_right_arm_frame_1)
        .mul_add(
            sin_q_right_ball,
            w_spindle_frame_in_right_arm_frame_3 * cos_q_right_ball,
        );
    let w_right_link_frame_2_of_q_right_ball = S::int(1) + cos_q_right_ball;
    let w_right_link_frame_2_of_place = (-sin_q_right_top)
        .mul_add(
            sin_q_right_ball,
            w_right_link_frame_2_of_q_right_ball * cos_q_right_top,
        );
    let w_right_link_frame_2_of_opening = w_right_arm_frame_2_of_opening_2
        * w_right_link_frame_2_of_place;
    let w_right_link_frame_2 = w_right_link_frame_2_of_opening - w_right_arm_frame_2;
    let alpha_left_arm_frame_1 = opening * w_spindle_frame_in_left_arm_frame_3;
    let w_right_arm_frame_23 = w_spindle_frame_in_right_arm_frame_3 * w_right_arm_frame_2;
    let w_left_link_frame_23 = w_left_arm_frame_in_left_link_frame_3 * w_left_link_frame_2;
    let w_right_link_frame_23 = w_right_arm_frame_in_right_link_frame_3 * w_right_link_frame_2;
    let l_sq_m = l * l * m;
    let H_left_arm_1 = w_spindle_frame_in_left_arm_frame_1 * l_sq_m;
    let H_left_arm_2 = opening * l_sq_m;
    let H_right_arm_1 = w_spindle_frame_in_right_arm_frame_1 * l_sq_m;
    let H_right_arm_2 = w_right_arm_frame_2 * l_sq_m;
    let H_left_link_1 = w_left_arm_frame_in_left_link_frame_1 * l_sq_m;
    let H_left_link_2 = w_left_link_frame_2 * l_sq_m;
    let H_right_link_1 = w_right_arm_frame_in_right_link_frame_1 * l_sq_m;
    let H_right_link_2 = w_right_link_frame_2 * l_sq_m;
    let F_w_right_arm_frame_in_right_link_frame_3 = (-w_right_link_frame_2)
        .mul_add(
            H_right_link_1,
            w_right_arm_frame_in_right_link_frame_1 * H_right_link_2,
        );
    let F_w_left_arm_frame_in_left_link_frame_3 = (-w_left_link_frame_2)
        .mul_add(H_left_link_1, w_left_arm_frame_in_left_link_frame_1 * H_left_link_2);
    let w_left_arm_frame_11 = w_spindle_frame_in_left_arm_frame_1
        * w_spindle_frame_in_left_arm_frame_1;
    let w_left_arm_frame_13 = w_spindle_frame_in_left_arm_frame_1
        * w_spindle_frame_in_left_arm_frame_3;
    let w_left_arm_frame_22 = opening * opening;
    let turn_left_arm_frame_33 = w_left_arm_frame_11 + w_left_arm_frame_22;
    let w_right_arm_frame_11 = w_spindle_frame_in_right_arm_frame_1
        * w_spindle_frame_in_right_arm_frame_1;
    let w_right_arm_frame_13 = w_spindle_frame_in_right_arm_frame_1
        * w_spindle_frame_in_right_arm_frame_3;
    let w_right_arm_frame_22 = w_right_arm_frame_2 * w_right_arm_frame_2;
    let turn_right_arm_frame_33 = w_right_arm_frame_11 + w_right_arm_frame_22;
    let w_left_link_frame_11 = w_left_arm_frame_in_left_link_frame_1
        * w_left_arm_frame_in_left_link_frame_1;
    let w_left_link_frame_13 = w_left_arm_frame_in_left_link_frame_1
        * w_left_arm_frame_in_left_link_frame_3;
    let w_left_link_frame_22 = w_left_link_frame_2 * w_left_link_frame_2;
    let turn_left_link_frame_33 = w_left_link_frame_11 + w_left_link_frame_22;
    let w_right_link_frame_11 = w_right_arm_frame_in_right_link_frame_1
        * w_right_arm_frame_in_right_link_frame_1;
    let w_right_link_frame_13 = w_right_arm_frame_in_right_link_frame_1
        * w_right_arm_frame_in_right_link_frame_3;
    let w_right_link_frame_22 = w_right_link_frame_2 * w_right_link_frame_2;
    let turn_right_link_frame_33 = w_right_link_frame_11 + w_right_link_frame_22;
    let a_spindle_frame_in_left_arm_frame_1 = g * sin_theta;
    let a_spindle_frame_in_left_arm_frame_3 = g * cos_theta;
    let a_spindle_frame_in_right_arm_frame_1 = g * sin_q_right_top;
    let a_spindle_frame_in_right_arm_frame_3 = g * cos_q_right_top;
    let a_left_link_centre_3 = l
        .mul_add(turn_left_arm_frame_33, a_spindle_frame_in_left_arm_frame_3);
    let a_right_link_centre_3 = l
        .mul_add(turn_right_arm_frame_33, a_spindle_frame_in_right_arm_frame_3);
    let alpha_spindle_frame_in_left_arm_frame_1 = spin_dot * sin_theta;
    let alpha_spindle_frame_in_left_arm_frame_3 = spin_dot * cos_theta;
    let alpha_left_arm_frame_1_2 = alpha_left_arm_frame_1 + alpha_spindle_frame_in_left_arm_frame_1;
    let alpha_left_arm_frame_3 = opening
        .mul_add(
            w_spindle_frame_in_left_arm_frame_1, -alpha_spindle_frame_in_left_arm_frame_3,
        );
    let turn_left_arm_frame_23 = alpha_left_arm_frame_1 + alpha_left_arm_frame_1_2;
    let alpha_spindle_frame_in_right_arm_frame_1 = spin_dot * sin_q_right_top;
    let alpha_spindle_frame_in_right_arm_frame_3 = spin_dot * cos_q_right_top;
    let alpha_right_arm_frame_1_2 = w_right_arm_frame_23 + alpha_spindle_frame_in_right_arm_frame_1;
    let alpha_right_arm_frame_3 = w_spindle_frame_in_right_arm_frame_1
        .mul_add(w_right_arm_frame_2, -alpha_spindle_frame_in_right_arm_frame_3);
    let turn_right_arm_frame_23_2 = w_right_arm_frame_23 + alpha_right_arm_frame_1_2;
    let alpha_left_arm_frame_in_left_link_frame_1_2 = (-alpha_left_arm_frame_1_2)
        .mul_add(cos_q_left_ball, alpha_left_arm_frame_3 * sin_q_left_ball);
    let alpha_left_link_frame_1_2 = w_left_arm_frame_in_left_link_frame_3
        .mul_add(
            w_left_link_frame_2_of_opening, alpha_left_arm_frame_in_left_link_frame_1_2,
        );
    let turn_left_link_frame_23_2 = w_left_link_frame_23 - alpha_left_link_frame_1_2;
    let alpha_right_arm_frame_in_right_link_frame_1_2 = (-alpha_right_arm_frame_1_2)
        .mul_add(cos_q_right_ball, alpha_right_arm_frame_3 * sin_q_right_ball);
    let alpha_right_link_frame_1_2 = w_right_arm_frame_in_right_link_frame_3
        .mul_add(
            w_right_link_frame_2_of_opening, alpha_right_arm_frame_in_right_link_frame_1_2,
        );
    let turn_right_link_frame_23_2 = w_right_link_frame_23 + alpha_right_link_frame_1_2;
    let a_left_arm_centre_2_2 = l * turn_left_arm_frame_23;
    let a_right_arm_centre_2_2 = l * turn_right_arm_frame_23_2;
    let a_left_link_centre_2_2 = a_left_arm_centre_2_2
        .mul_add(S::int(2), l * turn_left_link_frame_23_2);
    let a_right_link_centre_2_2 = (-a_right_arm_centre_2_2)
        .mul_add(S::int(2), l * turn_right_link_frame_23_2);
    let F_v_right_link_centre_2_2 = m * a_right_link_centre_2_2;
    let F_v_left_link_centre_2_2 = m * a_left_link_centre_2_2;
    let mb_times_4 = S::int(4) * mb;
    let m_plus_mb_times_4 = m + mb_times_4;
    let F_v_right_arm_centre_2_2 = (-F_v_right_link_centre_2_2)
        .mul_add(S::int(2), a_right_arm_centre_2_2 * m_plus_mb_times_4);
    let F_v_left_arm_centre_2_2 = a_left_arm_centre_2_2
        .mul_add(m_plus_mb_times_4, S::int(2) * F_v_left_link_centre_2_2);
    let l_times_3 = S::int(3) * l;
    let F_w_right_arm_frame_in_right_link_frame_1_2 = alpha_right_link_frame_1_2
        .mul_add(l_sq_m, w_right_arm_frame_in_right_link_frame_3 * H_right_link_2)
        + F_v_right_link_centre_2_2 * l_times_3;
    let F_w_left_arm_frame_in_left_link_frame_1_2 = (-alpha_left_link_frame_1_2)
        .mul_add(l_sq_m, w_left_arm_frame_in_left_link_frame_3 * H_left_link_2)
        + F_v_left_link_centre_2_2 * l_times_3;
    let F_w_spindle_frame_in_right_arm_frame_3_2 = (-w_right_arm_frame_2)
        .mul_add(H_right_arm_1, w_spindle_frame_in_right_arm_frame_1 * H_right_arm_2)
        - F_w_right_arm_frame_in_right_link_frame_3 * cos_q_right_ball
        + F_w_right_arm_frame_in_right_link_frame_1_2 * sin_q_right_ball;
    let F_w_spindle_frame_in_right_arm_frame_1_2 = (-F_w_right_arm_frame_in_right_link_frame_3)
        .mul_add(sin_q_right_ball, w_spindle_frame_in_right_arm_frame_3 * H_right_arm_2)
        - F_w_right_arm_frame_in_right_link_frame_1_2 * cos_q_right_ball
        + alpha_right_arm_frame_1_2 * l_sq_m + F_v_right_arm_centre_2_2 * l_times_3;
    let F_w_spindle_frame_in_left_arm_frame_3_2 = (-opening)
        .mul_add(H_left_arm_1, w_spindle_frame_in_left_arm_frame_1 * H_left_arm_2)
        + F_w_left_arm_frame_in_left_link_frame_3 * cos_q_left_ball
        - F_w_left_arm_frame_in_left_link_frame_1_2 * sin_q_left_ball;
    let F_w_spindle_frame_in_left_arm_frame_1_2 = F_w_left_arm_frame_in_left_link_frame_3
        .mul_add(sin_q_left_ball, w_spindle_frame_in_left_arm_frame_3 * H_left_arm_2)
        + F_w_left_arm_frame_in_left_link_frame_1_2 * cos_q_left_ball
        + alpha_left_arm_frame_1_2 * l_sq_m + F_v_left_arm_centre_2_2 * l_times_3;
    let turn_left_arm_frame_13 = opening_dot - w_left_arm_frame_13;
    let alpha_right_arm_frame_2_2_of_place = cos_angle - w_right_link_frame_2_of_place;
    let alpha_right_arm_frame_2_2_of_opening = w_right_link_frame_2_of_opening * cos_q_right_ball;
    let alpha_right_arm_frame_2_2_of_place_2 = w_left_link_frame_2 * sin_theta_plus_q_left_ball;
    let alpha_right_arm_frame_2_2_of_motion = w_right_arm_frame_2_of_opening
        .mul_add(alpha_right_arm_frame_2_2_of_place_2, opening_dot);
    let alpha_right_arm_frame_2_2_of_place_3 = w_right_arm_frame_2_of_place
        * w_right_arm_frame_2_of_place_2;
    let alpha_right_arm_frame_2_2_of_motion_2 = sin_q_right_ball_inv
        * (-(w_right_arm_frame_2_of_opening * w_left_link_frame_2_of_opening))
            .mul_add(
                cos_q_left_ball,
                w_right_arm_frame_2_of_opening_2 * alpha_right_arm_frame_2_2_of_opening,
            ) + alpha_right_arm_frame_2_2_of_motion * alpha_right_arm_frame_2_2_of_place_3;
    let alpha_right_arm_frame_2_2 = alpha_right_arm_frame_2_2_of_motion_2
        .mul_add(
            cos_angle,
            -w_right_arm_frame_2_of_opening_2 * w_right_arm_frame_2_of_opening_2
                * alpha_right_arm_frame_2_2_of_place * sin_angle,
        );
    let turn_right_arm_frame_13_2 = w_right_arm_frame_13 - alpha_right_arm_frame_2_2;
    let alpha_left_link_frame_2_2_of_place = w_right_arm_frame_2_of_place
        * w_left_link_frame_2_of_place;
    let alpha_left_link_frame_2_2_of_motion = -w_right_arm_frame_2_of_opening
        * opening.mul_add(sin_theta, alpha_right_arm_frame_2_2_of_place_2)
        + alpha_right_arm_frame_2_2_of_motion * alpha_left_link_frame_2_2_of_place;
    let alpha_left_link_frame_2_2 = opening_dot - alpha_left_link_frame_2_2_of_motion;
    let turn_left_link_frame_13_2 = w_left_link_frame_13 - alpha_left_link_frame_2_2;
    let alpha_right_link_frame_2_2 = -alpha_right_arm_frame_2_2
        + w_right_link_frame_2_of_place * alpha_right_arm_frame_2_2_of_motion_2
        - w_right_arm_frame_2_of_opening_2
            * (sin_q_right_top
                * w_right_arm_frame_2
                    .mul_add(
                        w_right_link_frame_2_of_q_right_ball, -alpha_right_arm_frame_2_2_of_opening,
                    )
                + w_right_arm_frame_2_of_opening * alpha_right_arm_frame_2_2_of_place
                    * cos_q_right_top * sin_q_left_ball);
    let turn_right_link_frame_13_2 = w_right_link_frame_13 + alpha_right_link_frame_2_2;
    let l_turn_left_arm_frame_13 = l * turn_left_arm_frame_13;
    let a_left_arm_centre_1_2 = a_spindle_frame_in_left_arm_frame_1
        .mul_add(S::int(2), l_turn_left_arm_frame_13);
    let a_right_arm_centre_1_2_of_place = l * turn_right_arm_frame_13_2;
    let a_right_arm_centre_1_2 = a_spindle_frame_in_right_arm_frame_1
        .mul_add(S::int(2), -a_right_arm_centre_1_2_of_place);
    let a_left_link_centre_1_3 = a_spindle_frame_in_left_arm_frame_1 + l_turn_left_arm_frame_13;
    let a_left_arm_frame_in_left_link_frame_1_2 = a_left_link_centre_1_3
        .mul_add(cos_q_left_ball, a_left_link_centre_3 * sin_q_left_ball);
    let a_left_arm_frame_in_left_link_frame_3_2 = (-a_left_link_centre_1_3)
        .mul_add(sin_q_left_ball, a_left_link_centre_3 * cos_q_left_ball);
    let a_left_link_centre_1_4 = (-a_left_arm_frame_in_left_link_frame_1_2)
        .mul_add(S::int(2), l * turn_left_link_frame_13_2);
    let a_left_link_centre_3_3 = a_left_arm_frame_in_left_link_frame_3_2
        .mul_add(S::int(2), l * turn_left_link_frame_33);
    let a_right_link_centre_1_3 = a_spindle_frame_in_right_arm_frame_1
        - a_right_arm_centre_1_2_of_place;
    let a_right_arm_frame_in_right_link_frame_1_2 = a_right_link_centre_1_3
        .mul_add(cos_q_right_ball, a_right_link_centre_3 * sin_q_right_ball);
    let a_right_arm_frame_in_right_link_frame_3_2 = (-a_right_link_centre_1_3)
        .mul_add(sin_q_right_ball, a_right_link_centre_3 * cos_q_right_ball);
    let a_right_link_centre_1_4 = (-a_right_arm_frame_in_right_link_frame_1_2)
        .mul_add(S::int(2), l * turn_right_link_frame_13_2);
    let a_right_link_centre_3_3 = a_right_arm_frame_in_right_link_frame_3_2
        .mul_add(S::int(2), l * turn_right_link_frame_33);
    let a_sleeve_centre_3_2 = g
        + l
            * (opening_dot
                .mul_add(
                    sin_theta,
                    w_left_link_frame_2 * w_left_link_frame_2 * cos_theta_plus_q_left_ball,
                ) + w_left_arm_frame_22 * cos_theta
                + alpha_left_link_frame_2_2 * sin_theta_plus_q_left_ball);
    let F_v_sleeve_centre_3_2 = ms * a_sleeve_centre_3_2;
    let F_v_right_link_centre_1_2 = m * a_right_link_centre_1_4;
    let F_v_right_arm_frame_in_right_link_frame_3_2 = m * a_right_link_centre_3_3;
    let F_v_left_link_centre_1_2 = m * a_left_link_centre_1_4;
    let F_v_left_arm_frame_in_left_link_frame_3_2 = m * a_left_link_centre_3_3;
    let F_v_right_arm_centre_1_2 = a_right_link_centre_1_3
        .mul_add(mb_times_4, m * a_right_arm_centre_1_2);
    let F_v_left_arm_centre_1_2 = a_left_link_centre_1_3
        .mul_add(mb_times_4, m * a_left_arm_centre_1_2);
    let F_w_right_link_frame_2_2 = alpha_right_link_frame_2_2
        .mul_add(l_sq_m, w_right_arm_frame_in_right_link_frame_3 * H_right_link_1)
        + F_v_right_link_centre_1_2 * l_times_3;
    let F_w_left_link_frame_2_2 = (-alpha_left_link_frame_2_2)
        .mul_add(l_sq_m, w_left_arm_frame_in_left_link_frame_3 * H_left_link_1)
        + F_v_left_link_centre_1_2 * l_times_3;
    let F_w_right_arm_frame_2_2 = S::int(6) * l
        * F_v_right_arm_frame_in_right_link_frame_3_2
            .mul_add(sin_q_right_ball, F_v_right_link_centre_1_2 * cos_q_right_ball)
        + w_spindle_frame_in_right_arm_frame_3 * H_right_arm_1 + F_w_right_link_frame_2_2
        - alpha_right_arm_frame_2_2 * l_sq_m - F_v_right_arm_centre_1_2 * l_times_3;
    let tau1_of_place = (-F_w_spindle_frame_in_right_arm_frame_3_2)
        .mul_add(
            cos_q_right_top,
            F_w_spindle_frame_in_right_arm_frame_1_2 * sin_q_right_top,
        );
    let tau1_of_place_2 = (-F_w_spindle_frame_in_left_arm_frame_3_2)
        .mul_add(cos_theta, F_w_spindle_frame_in_left_arm_frame_1_2 * sin_theta);
    let tau1_of_place_3 = tau1_of_place + tau1_of_place_2;
    let tau2_of_place = alpha_left_link_frame_2_2_of_place - S::int(1);
    let tau2_of_place_2 = F_v_left_arm_frame_in_left_link_frame_3_2
        .mul_add(sin_q_left_ball, F_v_left_link_centre_1_2 * cos_q_left_ball);
    let tau2_of_place_3 = (-F_w_left_link_frame_2_2)
        .mul_add(tau2_of_place, w_spindle_frame_in_left_arm_frame_3 * H_left_arm_1);
    let tau2_of_opening_dot = opening_dot.mul_add(l_sq_m, -tau2_of_place_3);
    let tau2_of_opening_dot_2 = alpha_right_arm_frame_2_2_of_place_3
        * (-F_w_right_link_frame_2_2)
            .mul_add(w_right_link_frame_2_of_place, F_w_right_arm_frame_2_2 * cos_angle)
        - tau2_of_opening_dot;
    // Values.
    let tau1 = spin_dot * (J + Js) + S::ratio(1, 12) * tau1_of_place_3;
    let tau2 = l * F_v_sleeve_centre_3_2
        * (-tau2_of_place).mul_add(sin_theta_plus_q_left_ball, sin_theta)
        + S::ratio(1, 4) * l * (-tau2_of_place_2).mul_add(S::int(2), F_v_left_arm_centre_1_2)
        - S::ratio(1, 12) * tau2_of_opening_dot_2;
    [tau1, tau2]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 2],
    direction: &[S; 7],
) -> [S; 7] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[5 + i],
    });
    let (of_q, of_v) = (coordinate_rates(&p, &q, &v), accelerations(&p, &q, &v));
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
            parameters: 7,
            coordinates: 5,
            variables: 2,
            speeds: 2,
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
        5
    }
    fn divisor_name(&self, at: usize) -> &str {
        [
            "cos(theta + q_left_ball)",
            "sin(q_right_ball)",
            "sin(theta)*sin(q_left_ball) - cos(theta)*cos(q_left_ball)",
            "d2", "d1",
        ][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn constraint_count(&self) -> usize {
        3
    }
    fn constraint_name(&self, at: usize) -> &str {
        ["left_end_1", "right_end_1", "right_end_3"][at]
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
