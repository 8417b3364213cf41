//! Flyball governor: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/governor/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::series::{Factors, SLACK, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

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

/// Jacobian of the derivative by the state; columns psi, theta, q_right_top, q_left_ball, q_right_ball, spin, opening.
///
/// 1943 operations, 6 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 2]) -> [[S; 7]; 7] {
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
    let alpha_left_arm_frame_in_left_link_frame_1_by_opening = (-w_spindle_frame_in_left_arm_frame_3)
        .mul_add(cos_q_left_ball, w_spindle_frame_in_left_arm_frame_1 * sin_q_left_ball);
    let w_left_arm_frame_in_left_link_frame_3_of_place = -alpha_left_arm_frame_in_left_link_frame_1_by_opening;
    let w_left_arm_frame_in_left_link_frame_3 = w_left_arm_frame_in_left_link_frame_3_of_place;
    let w_left_link_frame_2_of_place = cos_theta + cos_theta_plus_q_left_ball;
    let w_left_link_frame_2_of_opening = w_right_arm_frame_2_of_opening
        * w_left_link_frame_2_of_place;
    let w_left_link_frame_2 = opening - w_left_link_frame_2_of_opening;
    let w_right_arm_frame_in_right_link_frame_1 = w_spindle_frame_in_right_arm_frame_3
        .mul_add(
            sin_q_right_ball,
            w_spindle_frame_in_right_arm_frame_1 * cos_q_right_ball,
        );
    let w_right_arm_frame_in_right_link_frame_3_of_place = w_spindle_frame_in_right_arm_frame_3
        * cos_q_right_ball;
    let w_right_arm_frame_in_right_link_frame_3_of_place_2 = w_spindle_frame_in_right_arm_frame_1
        .mul_add(sin_q_right_ball, -w_right_arm_frame_in_right_link_frame_3_of_place);
    let w_right_arm_frame_in_right_link_frame_3_of_place_3 = -w_right_arm_frame_in_right_link_frame_3_of_place_2;
    let w_right_arm_frame_in_right_link_frame_3 = w_right_arm_frame_in_right_link_frame_3_of_place_3;
    let w_right_link_frame_2_of_q_right_ball = S::int(1) + cos_q_right_ball;
    let w_right_link_frame_2_of_place = w_right_link_frame_2_of_q_right_ball * cos_q_right_top;
    let w_right_link_frame_2_of_place_2 = sin_q_right_top * sin_q_right_ball;
    let w_right_link_frame_2_of_place_3 = w_right_link_frame_2_of_place
        - w_right_link_frame_2_of_place_2;
    let w_right_link_frame_2_of_opening = w_right_arm_frame_2_of_opening_2
        * w_right_link_frame_2_of_place_3;
    let w_right_link_frame_2_of_opening_2 = w_right_arm_frame_2 - w_right_link_frame_2_of_opening;
    let w_right_link_frame_2 = -w_right_link_frame_2_of_opening_2;
    let alpha_left_arm_frame_1 = opening * w_spindle_frame_in_left_arm_frame_3;
    let w_right_arm_frame_23 = w_spindle_frame_in_right_arm_frame_3 * w_right_arm_frame_2;
    let alpha_right_arm_frame_1 = w_right_arm_frame_23;
    let turn_right_arm_frame_23 = alpha_right_arm_frame_1 + w_right_arm_frame_23;
    let alpha_left_arm_frame_in_left_link_frame_1 = opening
        * alpha_left_arm_frame_in_left_link_frame_1_by_opening;
    let alpha_left_link_frame_1 = w_left_arm_frame_in_left_link_frame_3
        .mul_add(
            w_left_link_frame_2_of_opening, alpha_left_arm_frame_in_left_link_frame_1,
        );
    let w_left_link_frame_23 = w_left_arm_frame_in_left_link_frame_3 * w_left_link_frame_2;
    let turn_left_link_frame_23 = alpha_left_link_frame_1 - w_left_link_frame_23;
    let alpha_right_arm_frame_in_right_link_frame_1_of_opening = w_right_arm_frame_2_of_opening
        * sin_q_left_ball;
    let alpha_right_arm_frame_in_right_link_frame_1_of_opening_2 = alpha_right_arm_frame_in_right_link_frame_1_of_opening
        * cos_angle;
    let alpha_right_arm_frame_in_right_link_frame_1 = (-w_right_arm_frame_2)
        .mul_add(
            w_right_arm_frame_in_right_link_frame_3_of_place,
            w_spindle_frame_in_right_arm_frame_1
                * alpha_right_arm_frame_in_right_link_frame_1_of_opening_2,
        );
    let alpha_right_link_frame_1 = w_right_arm_frame_in_right_link_frame_3
        .mul_add(
            w_right_link_frame_2_of_opening, alpha_right_arm_frame_in_right_link_frame_1,
        );
    let w_right_link_frame_23 = w_right_arm_frame_in_right_link_frame_3 * w_right_link_frame_2;
    let turn_right_link_frame_23 = alpha_right_link_frame_1 + w_right_link_frame_23;
    let a_left_arm_centre_2 = l * alpha_left_arm_frame_1;
    let mr_right_link_frame_3 = l * m;
    let rw_right_link_frame_3 = l * mr_right_link_frame_3;
    let H_left_arm_1 = w_spindle_frame_in_left_arm_frame_1 * rw_right_link_frame_3;
    let H_left_arm_2 = opening * rw_right_link_frame_3;
    let a_right_arm_centre_2 = l * turn_right_arm_frame_23;
    let H_right_arm_1 = w_spindle_frame_in_right_arm_frame_1 * rw_right_link_frame_3;
    let H_right_arm_2 = w_right_arm_frame_2 * rw_right_link_frame_3;
    let a_left_link_centre_2 = (-a_left_arm_centre_2)
        .mul_add(S::int(4), l * turn_left_link_frame_23);
    let H_left_link_1 = w_left_arm_frame_in_left_link_frame_1 * rw_right_link_frame_3;
    let H_left_link_2 = w_left_link_frame_2 * rw_right_link_frame_3;
    let a_right_link_centre_2 = (-a_right_arm_centre_2)
        .mul_add(S::int(2), l * turn_right_link_frame_23);
    let H_right_link_1 = w_right_arm_frame_in_right_link_frame_1 * rw_right_link_frame_3;
    let H_right_link_2 = w_right_link_frame_2 * rw_right_link_frame_3;
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
            rw_right_link_frame_3,
            w_right_arm_frame_in_right_link_frame_3 * H_right_link_2,
        ) + F_v_right_link_centre_2 * l_times_3;
    let F_w_left_arm_frame_in_left_link_frame_3 = (-w_left_link_frame_2)
        .mul_add(H_left_link_1, w_left_arm_frame_in_left_link_frame_1 * H_left_link_2);
    let F_w_left_arm_frame_in_left_link_frame_1 = (-alpha_left_link_frame_1)
        .mul_add(
            rw_right_link_frame_3,
            w_left_arm_frame_in_left_link_frame_3 * H_left_link_2,
        ) - F_v_left_link_centre_2 * l_times_3;
    let F_w_spindle_frame_in_right_arm_frame_3_of_place = w_spindle_frame_in_right_arm_frame_1
        * H_right_arm_2;
    let F_w_spindle_frame_in_right_arm_frame_3 = (-w_right_arm_frame_2)
        .mul_add(
            H_right_arm_1,
            F_w_right_arm_frame_in_right_link_frame_1 * sin_q_right_ball,
        ) - F_w_right_arm_frame_in_right_link_frame_3 * cos_q_right_ball
        + F_w_spindle_frame_in_right_arm_frame_3_of_place;
    let F_w_spindle_frame_in_right_arm_frame_1_of_place = w_spindle_frame_in_right_arm_frame_3
        * H_right_arm_2;
    let F_w_spindle_frame_in_right_arm_frame_1 = (-F_w_right_arm_frame_in_right_link_frame_3)
        .mul_add(sin_q_right_ball, alpha_right_arm_frame_1 * rw_right_link_frame_3)
        - F_w_right_arm_frame_in_right_link_frame_1 * cos_q_right_ball
        + F_v_right_arm_centre_2 * l_times_3 + F_w_spindle_frame_in_right_arm_frame_1_of_place;
    let F_w_spindle_frame_in_left_arm_frame_3_of_place = w_spindle_frame_in_left_arm_frame_1
        * H_left_arm_2;
    let F_w_spindle_frame_in_left_arm_frame_3 = (-opening)
        .mul_add(H_left_arm_1, F_w_left_arm_frame_in_left_link_frame_3 * cos_q_left_ball)
        - F_w_left_arm_frame_in_left_link_frame_1 * sin_q_left_ball
        + F_w_spindle_frame_in_left_arm_frame_3_of_place;
    let l_times_6 = S::int(6) * l;
    let F_w_spindle_frame_in_left_arm_frame_1_of_place = w_spindle_frame_in_left_arm_frame_3
        * H_left_arm_2;
    let F_w_spindle_frame_in_left_arm_frame_1 = F_w_left_arm_frame_in_left_link_frame_1
        .mul_add(
            cos_q_left_ball,
            F_w_left_arm_frame_in_left_link_frame_3 * sin_q_left_ball,
        ) + alpha_left_arm_frame_1 * rw_right_link_frame_3 + F_v_left_arm_centre_2 * l_times_6
        + F_w_spindle_frame_in_left_arm_frame_1_of_place;
    let w_left_arm_frame_11 = w_spindle_frame_in_left_arm_frame_1
        * w_spindle_frame_in_left_arm_frame_1;
    let w_left_arm_frame_13 = w_spindle_frame_in_left_arm_frame_1
        * w_spindle_frame_in_left_arm_frame_3;
    let w_left_arm_frame_22 = opening * opening;
    let turn_left_arm_frame_33 = w_left_arm_frame_11 + w_left_arm_frame_22;
    let alpha_right_arm_frame_2_of_place = w_right_arm_frame_2_of_place
        * sin_theta_plus_q_left_ball;
    let alpha_right_arm_frame_2_of_place_2 = w_left_link_frame_2 * alpha_right_arm_frame_2_of_place;
    let alpha_right_arm_frame_2_of_opening = (sin_q_right_ball_inv
        * w_right_link_frame_2_of_opening)
        .mul_add(cos_q_right_ball, alpha_right_arm_frame_2_of_place_2);
    let alpha_right_arm_frame_2_of_opening_2 = w_right_arm_frame_2_of_opening_2 * sin_angle;
    let alpha_right_arm_frame_2_of_place_3 = cos_q_left_ball * cos_angle;
    let alpha_right_arm_frame_2_of_opening_3 = w_right_arm_frame_2_of_opening
        * sin_q_right_ball_inv;
    let alpha_right_arm_frame_2_of_opening_4 = w_left_link_frame_2_of_opening
        * alpha_right_arm_frame_2_of_opening_3;
    let alpha_right_arm_frame_2 = (-w_right_link_frame_2_of_opening_2)
        .mul_add(
            alpha_right_arm_frame_2_of_opening_2,
            w_right_arm_frame_2 * alpha_right_arm_frame_2_of_opening,
        ) - alpha_right_arm_frame_2_of_place_3 * alpha_right_arm_frame_2_of_opening_4;
    let w_right_arm_frame_11 = w_spindle_frame_in_right_arm_frame_1
        * w_spindle_frame_in_right_arm_frame_1;
    let w_right_arm_frame_13 = w_spindle_frame_in_right_arm_frame_1
        * w_spindle_frame_in_right_arm_frame_3;
    let w_right_arm_frame_22 = w_right_arm_frame_2 * w_right_arm_frame_2;
    let turn_right_arm_frame_13 = alpha_right_arm_frame_2 - w_right_arm_frame_13;
    let turn_right_arm_frame_33 = w_right_arm_frame_11 + w_right_arm_frame_22;
    let alpha_left_link_frame_2 = -w_right_arm_frame_2_of_opening
        * w_left_link_frame_2.mul_add(sin_theta_plus_q_left_ball, opening * sin_theta)
        + w_left_link_frame_2_of_opening * alpha_right_arm_frame_2_of_place_2;
    let w_left_link_frame_11 = w_left_arm_frame_in_left_link_frame_1
        * w_left_arm_frame_in_left_link_frame_1;
    let w_left_link_frame_13 = w_left_arm_frame_in_left_link_frame_1
        * w_left_arm_frame_in_left_link_frame_3;
    let w_left_link_frame_22 = w_left_link_frame_2 * w_left_link_frame_2;
    let turn_left_link_frame_13 = alpha_left_link_frame_2 + w_left_link_frame_13;
    let turn_left_link_frame_33 = w_left_link_frame_11 + w_left_link_frame_22;
    let alpha_right_link_frame_2_of_place = w_right_link_frame_2_of_q_right_ball * sin_q_right_top;
    let alpha_right_link_frame_2_of_place_2 = sin_q_right_top * cos_q_right_ball;
    let alpha_right_link_frame_2_of_place_3 = w_right_link_frame_2_of_place_3 * cos_q_left_ball;
    let alpha_right_link_frame_2 = -alpha_right_arm_frame_2
        + w_right_link_frame_2_of_opening * alpha_right_arm_frame_2_of_opening
        + w_right_arm_frame_2_of_opening_2
            * (-cos_q_right_top
                * (-w_right_link_frame_2_of_place_3)
                    .mul_add(
                        alpha_right_arm_frame_in_right_link_frame_1_of_opening,
                        alpha_right_arm_frame_in_right_link_frame_1_of_opening_2,
                    ) + w_right_link_frame_2_of_opening * alpha_right_link_frame_2_of_place_2
                - w_right_arm_frame_2 * alpha_right_link_frame_2_of_place)
        - alpha_right_arm_frame_2_of_opening_4 * alpha_right_link_frame_2_of_place_3;
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
    let a_right_arm_frame_in_right_link_frame_3_of_place = (-a_right_link_centre_3)
        .mul_add(cos_q_right_ball, a_right_link_centre_1 * sin_q_right_ball);
    let a_right_arm_frame_in_right_link_frame_3 = -a_right_arm_frame_in_right_link_frame_3_of_place;
    let a_right_link_centre_1_2 = (-a_right_arm_frame_in_right_link_frame_1)
        .mul_add(S::int(2), l * turn_right_link_frame_13);
    let a_right_link_centre_3_2 = a_right_arm_frame_in_right_link_frame_3
        .mul_add(S::int(2), l * turn_right_link_frame_33);
    let opening_cos_theta = opening * cos_theta;
    let a_sleeve_centre_3 = g
        + l
            * ((-alpha_left_link_frame_2)
                .mul_add(
                    sin_theta_plus_q_left_ball,
                    w_left_link_frame_2 * w_left_link_frame_2 * cos_theta_plus_q_left_ball,
                ) + opening * opening_cos_theta);
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
            rw_right_link_frame_3,
            w_right_arm_frame_in_right_link_frame_3 * H_right_link_1,
        ) + F_v_right_link_centre_1 * l_times_3;
    let F_w_left_link_frame_2 = alpha_left_link_frame_2
        .mul_add(
            rw_right_link_frame_3,
            w_left_arm_frame_in_left_link_frame_3 * H_left_link_1,
        ) + F_v_left_link_centre_1 * l_times_3;
    let F_w_right_arm_frame_2 = F_w_right_link_frame_2
        + w_spindle_frame_in_right_arm_frame_3 * H_right_arm_1
        - alpha_right_arm_frame_2 * rw_right_link_frame_3 - F_v_right_arm_centre_1 * l_times_3
        + l_times_6
            * F_v_right_arm_frame_in_right_link_frame_3
                .mul_add(sin_q_right_ball, F_v_right_link_centre_1 * cos_q_right_ball);
    let J_right_link_frame_11 = rw_right_link_frame_3;
    let J_right_link_frame_11_2 = rw_right_link_frame_3
        .mul_add(S::int(3), J_right_link_frame_11);
    let s_right_link_frame_in_right_arm_frame_1 = mr_right_link_frame_3 * sin_q_right_ball;
    let s_right_link_frame_in_right_arm_frame_3 = mr_right_link_frame_3 * cos_q_right_ball;
    let J_right_link_frame_in_right_arm_frame = J_right_link_frame_11_2 * sin_q_right_ball;
    let J_right_link_frame_in_right_arm_frame_2 = J_right_link_frame_in_right_arm_frame
        * sin_q_right_ball;
    let J_right_link_frame_in_right_arm_frame_11 = J_right_link_frame_11_2
        - J_right_link_frame_in_right_arm_frame_2;
    let J_right_link_frame_in_right_arm_frame_13_of_place = J_right_link_frame_in_right_arm_frame
        * cos_q_right_ball;
    let J_right_link_frame_in_right_arm_frame_13 = J_right_link_frame_in_right_arm_frame_13_of_place;
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
    let J_left_link_frame_in_left_arm_frame_13_of_place = J_left_link_frame_in_left_arm_frame
        * cos_q_left_ball;
    let J_left_link_frame_in_left_arm_frame_13 = J_left_link_frame_in_left_arm_frame_13_of_place;
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
    let cos_q_right_top_doubled = S::int(2) * cos_q_right_top;
    let J_right_arm_frame_in_spindle_frame = (-J_right_arm_frame_13)
        .mul_add(
            cos_q_right_top_doubled,
            J_right_arm_frame_in_spindle_frame_31 * sin_q_right_top,
        );
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
    let cos_theta_doubled = S::int(2) * cos_theta;
    let J_left_arm_frame_in_spindle_frame = (-J_left_arm_frame_13)
        .mul_add(cos_theta_doubled, J_left_arm_frame_in_spindle_frame_31 * sin_theta);
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
    let d2_of_place = sin_q_right_ball_inv * alpha_right_link_frame_2_of_place_2;
    let cos_theta_sq = cos_theta * cos_theta;
    let d2_of_place_2 = cos_theta * cos_q_left_ball;
    let sin_theta_d2_of_place_2 = d2_of_place_2 * sin_theta;
    let m_doubled = S::int(2) * m;
    let d2_of_place_3 = sin_theta.mul_add(sin_q_left_ball, -d2_of_place_2);
    let d2_of_place_3_inv = S::int(1) / d2_of_place_3;
    let l_d2_of_place_3_inv = l * d2_of_place_3_inv;
    let d2_of_place_4 = S::ratio(1, 3) * l_d2_of_place_3_inv * l_d2_of_place_3_inv;
    let d2 = d2_of_place_4
        * (sin_q_left_ball
            * (sin_q_left_ball
                * (cos_q_right_top
                    * (cos_q_right_top
                        * (m * sin_q_right_ball_inv_sq.mul_add(S::int(2), -S::int(5))
                            + mb_times_3 * (sin_q_right_ball_inv_sq - S::int(2)))
                        - d2_of_m_mb * d2_of_place) + S::int(3) * ms
                    + m * (-cos_theta_sq).mul_add(S::int(5), S::int(8))
                    + mb_times_6 * (S::int(1) - cos_theta_sq))
                - d2_of_m_mb * sin_theta_d2_of_place_2) + cos_theta_sq * (mb_times_3 + m_doubled));
    let w_right_arm_frame_2_by_theta = w_right_arm_frame_2 * alpha_right_arm_frame_2_of_place;
    let w_left_arm_frame_in_left_link_frame_1_by_theta = -spin * d2_of_place_3;
    let w_left_arm_frame_in_left_link_frame_3_by_theta_of_place = sin_theta * cos_q_left_ball;
    let w_left_arm_frame_in_left_link_frame_3_by_theta_of_place_2 = cos_theta * sin_q_left_ball;
    let w_left_arm_frame_in_left_link_frame_3_by_theta_of_place_3 = w_left_arm_frame_in_left_link_frame_3_by_theta_of_place
        + w_left_arm_frame_in_left_link_frame_3_by_theta_of_place_2;
    let w_left_arm_frame_in_left_link_frame_3_by_theta_of_spin = spin
        * w_left_arm_frame_in_left_link_frame_3_by_theta_of_place_3;
    let w_left_arm_frame_in_left_link_frame_3_by_theta = -w_left_arm_frame_in_left_link_frame_3_by_theta_of_spin;
    let opening_sin_q_left_ball = opening * sin_q_left_ball;
    let w_left_link_frame_2_by_theta_of_opening = d2_of_place_3_inv * d2_of_place_3_inv
        * opening_sin_q_left_ball;
    let w_left_link_frame_2_by_theta_of_opening_2 = -w_left_link_frame_2_by_theta_of_opening;
    let w_left_link_frame_2_by_theta = w_left_link_frame_2_by_theta_of_opening_2;
    let w_right_link_frame_2_by_theta_of_opening = w_right_link_frame_2_of_opening
        * alpha_right_arm_frame_2_of_place;
    let w_right_link_frame_2_by_theta = w_right_link_frame_2_by_theta_of_opening
        - w_right_arm_frame_2_by_theta;
    let alpha_right_arm_frame_1_by_theta = w_right_arm_frame_23 * alpha_right_arm_frame_2_of_place;
    let alpha_left_arm_frame_in_left_link_frame_1_by_theta = opening
        * w_left_arm_frame_in_left_link_frame_3_by_theta_of_spin;
    let alpha_left_link_frame_1_by_theta_of_place = w_left_arm_frame_in_left_link_frame_3
        * alpha_right_arm_frame_2_of_place;
    let alpha_left_link_frame_1_by_theta = alpha_left_arm_frame_in_left_link_frame_1_by_theta
        + opening
            * (w_left_arm_frame_in_left_link_frame_3_by_theta
                + w_right_arm_frame_2_of_place
                    * (cos_theta
                        * (w_left_arm_frame_in_left_link_frame_3_by_theta
                            + alpha_left_link_frame_1_by_theta_of_place)
                        - w_left_arm_frame_in_left_link_frame_3 * sin_theta));
    let alpha_right_arm_frame_in_right_link_frame_1_by_theta_of_place = (-sin_q_right_ball_inv)
        .mul_add(
            w_right_arm_frame_in_right_link_frame_3_of_place, w_spindle_frame_in_right_arm_frame_1,
        );
    let alpha_right_arm_frame_in_right_link_frame_1_by_theta = alpha_right_arm_frame_in_right_link_frame_1_of_opening_2
        * alpha_right_arm_frame_2_of_place
        * alpha_right_arm_frame_in_right_link_frame_1_by_theta_of_place;
    let alpha_right_link_frame_1_by_theta = w_right_arm_frame_in_right_link_frame_3
        .mul_add(
            w_right_link_frame_2_by_theta_of_opening,
            alpha_right_arm_frame_in_right_link_frame_1_by_theta,
        );
    let l_opening = l * opening;
    let a_left_arm_centre_2_by_theta_of_opening = w_spindle_frame_in_left_arm_frame_1 * l_opening;
    let a_left_arm_centre_2_by_theta = -a_left_arm_centre_2_by_theta_of_opening;
    let H_left_arm_1_by_theta = w_spindle_frame_in_left_arm_frame_3 * rw_right_link_frame_3;
    let a_left_link_centre_2_by_theta_of_place = w_left_arm_frame_in_left_link_frame_3
        .mul_add(w_left_link_frame_2_by_theta, -alpha_left_link_frame_1_by_theta);
    let a_left_link_centre_2_by_theta = -l
        * w_left_link_frame_2
            .mul_add(
                w_left_arm_frame_in_left_link_frame_3_by_theta,
                a_left_link_centre_2_by_theta_of_place,
            ) - S::int(4) * a_left_arm_centre_2_by_theta;
    let a_right_link_centre_2_by_theta_of_place = w_spindle_frame_in_right_arm_frame_3
        .mul_add(w_right_arm_frame_2_by_theta, alpha_right_arm_frame_1_by_theta);
    let l_doubled = S::int(2) * l;
    let a_right_link_centre_2_by_theta_of_place_2 = l
        * w_right_arm_frame_in_right_link_frame_3
            .mul_add(w_right_link_frame_2_by_theta, alpha_right_link_frame_1_by_theta);
    let a_right_link_centre_2_by_theta = (-a_right_link_centre_2_by_theta_of_place)
        .mul_add(l_doubled, a_right_link_centre_2_by_theta_of_place_2);
    let F_v_right_arm_centre_2_by_theta = (-a_right_link_centre_2_by_theta)
        .mul_add(
            m_doubled,
            l * m_plus_mb_times_4 * a_right_link_centre_2_by_theta_of_place,
        );
    let F_w_right_arm_frame_in_right_link_frame_1_by_theta = mr_right_link_frame_3
        * a_right_link_centre_2_by_theta
            .mul_add(S::int(3), a_right_link_centre_2_by_theta_of_place_2);
    let F_w_left_arm_frame_in_left_link_frame_3_by_theta = H_left_link_2
        * w_left_arm_frame_in_left_link_frame_1_by_theta
        - H_left_link_1 * w_left_link_frame_2_by_theta
        + rw_right_link_frame_3
            * (-w_left_link_frame_2)
                .mul_add(
                    w_left_arm_frame_in_left_link_frame_1_by_theta,
                    w_left_arm_frame_in_left_link_frame_1 * w_left_link_frame_2_by_theta,
                );
    let F_w_left_arm_frame_in_left_link_frame_1_by_theta = mr_right_link_frame_3
        * (-a_left_link_centre_2_by_theta)
            .mul_add(S::int(3), l * a_left_link_centre_2_by_theta_of_place)
        + H_left_link_2 * w_left_arm_frame_in_left_link_frame_3_by_theta;
    let F_w_spindle_frame_in_right_arm_frame_3_by_theta_of_place = w_right_arm_frame_in_right_link_frame_1
        * cos_q_right_ball;
    let F_w_spindle_frame_in_right_arm_frame_3_by_theta_of_place_2 = H_right_link_1
        * cos_q_right_ball;
    let F_w_spindle_frame_in_right_arm_frame_3_by_theta = F_w_right_arm_frame_in_right_link_frame_1_by_theta
        * sin_q_right_ball - H_right_arm_1 * w_right_arm_frame_2_by_theta
        + rw_right_link_frame_3
            * (-w_right_link_frame_2_by_theta)
                .mul_add(
                    F_w_spindle_frame_in_right_arm_frame_3_by_theta_of_place,
                    w_spindle_frame_in_right_arm_frame_1 * w_right_arm_frame_2_by_theta,
                )
        + w_right_link_frame_2_by_theta
            * F_w_spindle_frame_in_right_arm_frame_3_by_theta_of_place_2;
    let F_w_spindle_frame_in_right_arm_frame_1_by_theta_of_place = w_right_arm_frame_in_right_link_frame_1
        * sin_q_right_ball;
    let F_w_spindle_frame_in_right_arm_frame_1_by_theta_of_place_2 = H_right_link_1
        * sin_q_right_ball;
    let F_w_spindle_frame_in_right_arm_frame_1_by_theta = l
        * (mr_right_link_frame_3
            * (-w_right_link_frame_2_by_theta)
                .mul_add(
                    F_w_spindle_frame_in_right_arm_frame_1_by_theta_of_place,
                    a_right_link_centre_2_by_theta_of_place,
                ) + S::int(3) * F_v_right_arm_centre_2_by_theta)
        - F_w_right_arm_frame_in_right_link_frame_1_by_theta * cos_q_right_ball
        + w_right_link_frame_2_by_theta
            * F_w_spindle_frame_in_right_arm_frame_1_by_theta_of_place_2;
    let F_w_spindle_frame_in_left_arm_frame_3_by_theta = (-opening)
        .mul_add(
            H_left_arm_1_by_theta,
            F_w_left_arm_frame_in_left_link_frame_3_by_theta * cos_q_left_ball,
        ) - F_w_left_arm_frame_in_left_link_frame_1_by_theta * sin_q_left_ball
        + F_w_spindle_frame_in_left_arm_frame_1_of_place;
    let F_w_spindle_frame_in_left_arm_frame_1_by_theta_of_place = a_left_arm_centre_2_by_theta
        - a_left_link_centre_2_by_theta;
    let F_w_spindle_frame_in_left_arm_frame_1_by_theta = F_w_left_arm_frame_in_left_link_frame_3_by_theta
        * sin_q_left_ball + F_w_left_arm_frame_in_left_link_frame_1_by_theta * cos_q_left_ball
        - F_w_spindle_frame_in_left_arm_frame_3_of_place
        + l
            * (m
                * F_w_spindle_frame_in_left_arm_frame_1_by_theta_of_place
                    .mul_add(S::int(6), -a_left_arm_centre_2_by_theta_of_opening)
                + S::int(24) * mb * a_left_arm_centre_2_by_theta);
    let w_left_arm_frame_11_by_theta = S::int(2) * w_left_arm_frame_13;
    let w_left_arm_frame_13_by_theta_of_place = w_spindle_frame_in_left_arm_frame_1 * sin_theta;
    let w_left_arm_frame_13_by_theta = spin
        * w_spindle_frame_in_left_arm_frame_3
            .mul_add(cos_theta, -w_left_arm_frame_13_by_theta_of_place);
    let alpha_right_arm_frame_2_by_theta_of_place = alpha_right_arm_frame_2_of_place * cos_theta;
    let alpha_right_arm_frame_2_by_theta_of_place_2 = S::int(3)
        * alpha_right_arm_frame_2_by_theta_of_place;
    let alpha_right_arm_frame_2_by_theta_of_place_3 = sin_theta
        - alpha_right_arm_frame_2_by_theta_of_place_2;
    let alpha_right_arm_frame_2_by_theta_of_place_4 = sin_q_right_ball_inv * cos_angle;
    let alpha_right_arm_frame_2_by_theta_of_place_5 = w_right_link_frame_2_of_q_right_ball
        * alpha_right_arm_frame_2_by_theta_of_place_4;
    let alpha_right_arm_frame_2_by_theta_of_place_6 = cos_q_right_top
        * (sin_angle
            + cos_q_right_ball * (sin_angle + alpha_right_arm_frame_2_by_theta_of_place_5));
    let alpha_right_arm_frame_2_by_theta_of_place_7 = cos_angle
        * (sin_angle + alpha_right_link_frame_2_of_place_2);
    let alpha_right_arm_frame_2_by_theta_of_place_8 = sin_q_right_top * sin_angle;
    let alpha_right_arm_frame_2_by_theta_of_place_9 = sin_q_right_ball_inv
        * (alpha_right_arm_frame_2_by_theta_of_place_6
            - alpha_right_arm_frame_2_by_theta_of_place_7)
        - alpha_right_arm_frame_2_by_theta_of_place_8;
    let sin_q_left_ball_doubled = S::int(2) * sin_q_left_ball;
    let d2_of_place_2_doubled = S::int(2) * d2_of_place_2;
    let alpha_right_arm_frame_2_by_theta_of_place_10 = w_left_arm_frame_in_left_link_frame_3_by_theta_of_place
        - w_left_arm_frame_in_left_link_frame_3_by_theta_of_place_2;
    let alpha_right_arm_frame_2_by_theta_of_place_11 = -alpha_right_arm_frame_2_by_theta_of_place_10;
    let alpha_right_arm_frame_2_by_theta = -w_right_arm_frame_2_of_opening
        * alpha_right_arm_frame_2_of_opening_3
        * (sin_theta_plus_q_left_ball
            * (alpha_right_arm_frame_2_of_place_3
                + w_right_arm_frame_2_of_place
                    * (-sin_q_left_ball
                        * alpha_right_arm_frame_2_by_theta_of_place_9
                            .mul_add(
                                sin_q_left_ball_doubled,
                                alpha_right_arm_frame_2_by_theta_of_place_3 * cos_angle,
                            ) + d2_of_place_2_doubled * cos_angle))
            + alpha_right_arm_frame_2_by_theta_of_place_11 * cos_angle);
    let alpha_left_link_frame_2_by_theta_of_place = S::int(1)
        + S::int(3) * alpha_right_arm_frame_2_of_place * alpha_right_arm_frame_2_of_place;
    let sin_theta_doubled = S::int(2) * sin_theta;
    let alpha_left_link_frame_2_by_theta_of_place_2 = alpha_right_arm_frame_2_of_place * sin_theta;
    let alpha_left_link_frame_2_by_theta_of_opening = opening * w_right_arm_frame_2_of_opening;
    let alpha_left_link_frame_2_by_theta = -alpha_left_link_frame_2_by_theta_of_opening
        * (cos_theta
            * (S::int(1)
                + w_right_arm_frame_2_of_place
                    * (-alpha_right_arm_frame_2_of_place)
                        .mul_add(
                            sin_theta_doubled,
                            alpha_left_link_frame_2_by_theta_of_place * cos_theta,
                        )) + alpha_left_link_frame_2_by_theta_of_place_2);
    let alpha_right_link_frame_2_by_theta_of_place = sin_q_right_ball_inv
        * w_right_link_frame_2_of_place;
    let alpha_right_link_frame_2_by_theta_of_place_2 = cos_q_right_top + cos_angle;
    let alpha_right_link_frame_2_by_theta_of_place_3 = sin_q_right_ball_inv
        * (-alpha_right_link_frame_2_by_theta_of_place)
            .mul_add(S::int(2), alpha_right_link_frame_2_of_place)
        + alpha_right_link_frame_2_by_theta_of_place_2;
    let alpha_right_link_frame_2_by_theta_of_place_4 = sin_q_left_ball_doubled
        .mul_add(
            alpha_right_link_frame_2_by_theta_of_place_3,
            w_right_link_frame_2_of_q_right_ball * alpha_right_arm_frame_2_by_theta_of_place_2,
        );
    let alpha_right_link_frame_2_by_theta_of_place_5 = w_right_arm_frame_2_of_place_2 * cos_angle;
    let alpha_right_link_frame_2_by_theta_of_place_6 = alpha_right_link_frame_2_of_place
        * alpha_right_link_frame_2_by_theta_of_place_5;
    let alpha_right_link_frame_2_by_theta_of_place_7 = sin_q_right_top
        - alpha_right_link_frame_2_by_theta_of_place;
    let alpha_right_link_frame_2_by_theta_of_place_8 = alpha_right_link_frame_2_by_theta_of_place_7
        * cos_q_left_ball;
    let alpha_right_link_frame_2_by_theta_of_place_9 = sin_q_right_ball_inv * cos_q_right_top;
    let alpha_right_link_frame_2_by_theta_of_opening = w_right_arm_frame_2_of_opening
        * w_right_arm_frame_2_of_opening;
    let alpha_right_link_frame_2_by_theta = alpha_right_link_frame_2_by_theta_of_opening
        * (sin_theta_plus_q_left_ball
            * (w_right_arm_frame_2_of_place
                * (-sin_q_left_ball
                    * (sin_q_right_ball_inv
                        * (cos_q_right_top
                            * (-w_right_link_frame_2_of_q_right_ball)
                                .mul_add(
                                    sin_theta, alpha_right_link_frame_2_by_theta_of_place_4,
                                ) + S::int(2) * alpha_right_link_frame_2_by_theta_of_place_6)
                        + alpha_right_arm_frame_2_by_theta_of_place_3 * sin_q_right_top)
                    + d2_of_place_2_doubled * alpha_right_link_frame_2_by_theta_of_place_7)
                + alpha_right_link_frame_2_by_theta_of_place_8)
            + alpha_right_arm_frame_2_by_theta_of_place_11 * sin_q_right_top
            + w_right_link_frame_2_of_q_right_ball * alpha_right_arm_frame_2_by_theta_of_place_10
                * alpha_right_link_frame_2_by_theta_of_place_9) - alpha_right_arm_frame_2_by_theta;
    let a_left_arm_centre_1_by_theta_of_place = l * w_left_arm_frame_13_by_theta;
    let a_left_arm_centre_1_by_theta = (-a_spindle_frame_in_left_arm_frame_3)
        .mul_add(S::int(2), a_left_arm_centre_1_by_theta_of_place);
    let a_left_link_centre_1_by_theta = a_left_arm_centre_1_by_theta_of_place
        - a_spindle_frame_in_left_arm_frame_3;
    let a_left_link_centre_3_by_theta = l
        .mul_add(w_left_arm_frame_11_by_theta, -a_spindle_frame_in_left_arm_frame_1);
    let a_left_arm_frame_in_left_link_frame_1_by_theta = (-a_left_link_centre_1_by_theta)
        .mul_add(cos_q_left_ball, a_left_link_centre_3_by_theta * sin_q_left_ball);
    let a_left_arm_frame_in_left_link_frame_3_by_theta = a_left_link_centre_3_by_theta
        .mul_add(cos_q_left_ball, a_left_link_centre_1_by_theta * sin_q_left_ball);
    let a_left_link_centre_1_2_by_theta_of_place = w_left_arm_frame_in_left_link_frame_3
        .mul_add(
            w_left_arm_frame_in_left_link_frame_1_by_theta, alpha_left_link_frame_2_by_theta,
        );
    let a_left_link_centre_1_2_by_theta = l
        * w_left_arm_frame_in_left_link_frame_1
            .mul_add(
                w_left_arm_frame_in_left_link_frame_3_by_theta,
                a_left_link_centre_1_2_by_theta_of_place,
            ) - S::int(2) * a_left_arm_frame_in_left_link_frame_1_by_theta;
    let a_left_link_centre_3_2_by_theta = l_doubled
        * w_left_link_frame_2
            .mul_add(
                w_left_link_frame_2_by_theta,
                w_left_arm_frame_in_left_link_frame_1
                    * w_left_arm_frame_in_left_link_frame_1_by_theta,
            ) + S::int(2) * a_left_arm_frame_in_left_link_frame_3_by_theta;
    let a_right_arm_frame_in_right_link_frame_1_by_theta_of_place = S::int(2) * w_right_arm_frame_2;
    let a_right_arm_frame_in_right_link_frame_1_by_theta_of_place_2 = a_right_arm_frame_in_right_link_frame_1_by_theta_of_place
        * sin_q_right_ball;
    let a_right_arm_frame_in_right_link_frame_1_by_theta = l
        * w_right_arm_frame_2_by_theta
            .mul_add(
                a_right_arm_frame_in_right_link_frame_1_by_theta_of_place_2,
                alpha_right_arm_frame_2_by_theta * cos_q_right_ball,
            );
    let a_right_arm_frame_in_right_link_frame_3_by_theta_of_place = a_right_arm_frame_in_right_link_frame_1_by_theta_of_place
        * cos_q_right_ball;
    let a_right_arm_frame_in_right_link_frame_3_by_theta = l
        * (-alpha_right_arm_frame_2_by_theta)
            .mul_add(
                sin_q_right_ball,
                w_right_arm_frame_2_by_theta
                    * a_right_arm_frame_in_right_link_frame_3_by_theta_of_place,
            );
    let a_sleeve_centre_3_by_theta_of_place = w_right_arm_frame_2_of_place * cos_theta;
    let a_sleeve_centre_3_by_theta_of_place_2 = S::int(3) * a_sleeve_centre_3_by_theta_of_place;
    let a_sleeve_centre_3_by_theta_of_place_3 = w_right_arm_frame_2_of_place
        * w_right_arm_frame_2_of_place;
    let a_sleeve_centre_3_by_theta = opening * l_opening
        * (w_right_arm_frame_2_of_place
            * (cos_theta
                * (sin_theta_plus_q_left_ball
                    * a_sleeve_centre_3_by_theta_of_place_2
                        .mul_add(a_sleeve_centre_3_by_theta_of_place_3, S::int(1))
                    - sin_theta_doubled * a_sleeve_centre_3_by_theta_of_place_3)
                + w_right_arm_frame_2_of_place * sin_theta) - sin_theta);
    let F_w_right_link_frame_2_by_theta_of_place = S::int(2) * mr_right_link_frame_3;
    let F_w_right_link_frame_2_by_theta = F_w_right_link_frame_2_by_theta_of_place
        * (-a_right_arm_frame_in_right_link_frame_1_by_theta)
            .mul_add(S::int(3), alpha_right_link_frame_2_by_theta * l_doubled);
    let F_w_left_link_frame_2_by_theta = mr_right_link_frame_3
        * l
            .mul_add(
                a_left_link_centre_1_2_by_theta_of_place,
                S::int(3) * a_left_link_centre_1_2_by_theta,
            ) + H_left_link_1 * w_left_arm_frame_in_left_link_frame_3_by_theta;
    let cos_q_right_ball_times_3 = S::int(3) * cos_q_right_ball;
    let sin_q_right_ball_times_6 = S::int(6) * sin_q_right_ball;
    let F_w_right_arm_frame_2_by_theta_of_place = w_right_link_frame_2 * sin_q_right_ball_times_6;
    let cos_q_right_ball_times_6 = S::int(6) * cos_q_right_ball;
    let mb_l_times_6 = mb * l_times_6;
    let F_w_right_arm_frame_2_by_theta = F_w_right_link_frame_2_by_theta
        - l_doubled
            * (m
                * (l
                    * ((-alpha_right_link_frame_2_by_theta)
                        .mul_add(
                            cos_q_right_ball_times_3,
                            S::int(2) * alpha_right_arm_frame_2_by_theta,
                        )
                        - w_right_link_frame_2_by_theta * F_w_right_arm_frame_2_by_theta_of_place)
                    - a_right_arm_frame_in_right_link_frame_3_by_theta * sin_q_right_ball_times_6
                    + a_right_arm_frame_in_right_link_frame_1_by_theta * cos_q_right_ball_times_6)
                + alpha_right_arm_frame_2_by_theta * mb_l_times_6);
    let J_left_arm_frame_in_spindle_frame_by_theta = J_left_arm_frame_13
        .mul_add(sin_theta_doubled, J_left_arm_frame_in_spindle_frame_31 * cos_theta);
    let J_left_arm_frame_in_spindle_frame_2_by_theta = J_left_arm_frame_in_spindle_frame_by_theta
        .mul_add(sin_theta, J_left_arm_frame_in_spindle_frame * cos_theta);
    let sin_q_right_top_sq = sin_q_right_top * sin_q_right_top;
    let d2_by_theta_of_q_right_top = sin_q_right_top_sq.mul_add(S::int(10), S::int(1));
    let sin_q_right_top_doubled = S::int(2) * sin_q_right_top;
    let d2_by_theta_of_place = mb_times_6
        * sin_q_right_top_doubled.mul_add(sin_q_right_top, -S::int(1)) + S::int(6) * ms;
    let d2_by_theta_of_place_2 = alpha_right_link_frame_2_of_place_2 * cos_q_right_top_doubled;
    let d2_by_theta_of_q_right_top_2 = sin_q_right_top_sq - S::int(1);
    let m_times_4 = S::int(4) * m;
    let d2_by_theta_of_m_mb = mb_times_6 + m_times_4;
    let m_sin_q_right_ball_sq = m * sin_q_right_ball * sin_q_right_ball;
    let d2_by_theta_of_place_3 = sin_q_right_ball_inv * d2_of_place_3_inv;
    let d2_by_theta_of_place_4 = w_right_arm_frame_2_of_place_2 * d2_of_place_4;
    let d2_by_theta = d2_by_theta_of_place_3 * d2_by_theta_of_place_4
        * (-sin_q_left_ball
            * (sin_q_right_ball
                * (w_left_arm_frame_in_left_link_frame_3_by_theta_of_place_3 * sin_q_right_ball
                    * m.mul_add(d2_by_theta_of_q_right_top, d2_by_theta_of_place)
                    - d2_of_m_mb * w_left_arm_frame_in_left_link_frame_3_by_theta_of_place_3
                        * d2_by_theta_of_place_2)
                - w_left_arm_frame_in_left_link_frame_3_by_theta_of_place_3
                    * d2_by_theta_of_q_right_top_2 * d2_by_theta_of_m_mb)
            + m_sin_q_right_ball_sq * cos_theta);
    let l_times_12 = S::int(12) * l;
    let opening_dot_by_theta_of_place = l_times_12 * sin_theta_plus_q_left_ball;
    let opening_dot_by_theta_of_place_2 = (-F_v_sleeve_centre_3)
        .mul_add(opening_dot_by_theta_of_place, F_w_left_link_frame_2);
    let d2_inv = S::int(1) / d2;
    let d2_by_theta_d2_inv = d2_by_theta * d2_inv;
    let opening_dot_by_theta_of_place_3 = alpha_right_arm_frame_2_of_place - d2_by_theta_d2_inv;
    let opening_dot_by_theta_of_place_4 = ms * a_sleeve_centre_3_by_theta;
    let cos_q_left_ball_doubled = S::int(2) * cos_q_left_ball;
    let opening_dot_by_theta_of_place_5 = S::int(4) * F_v_sleeve_centre_3;
    let opening_dot_by_theta_of_place_6 = F_v_left_link_centre_1
        .mul_add(cos_q_left_ball_doubled, F_v_left_arm_centre_1);
    let opening_dot_by_theta_of_place_7 = F_v_left_arm_frame_in_left_link_frame_3
        .mul_add(sin_q_left_ball_doubled, opening_dot_by_theta_of_place_6);
    let opening_dot_by_theta_of_place_8 = (-opening_dot_by_theta_of_place_5)
        .mul_add(sin_theta, opening_dot_by_theta_of_place_7);
    let d2_inv_by_12 = S::ratio(1, 12) * d2_inv;
    let opening_dot_by_theta = d2_inv_by_12
        * (w_right_arm_frame_2_of_place
            * (sin_q_left_ball
                * (sin_q_right_top
                    * F_w_right_link_frame_2
                        .mul_add(
                            opening_dot_by_theta_of_place_3, F_w_right_link_frame_2_by_theta,
                        )
                    - sin_q_right_ball_inv
                        * (cos_q_right_top
                            * (F_w_right_link_frame_2 * w_right_link_frame_2_of_q_right_ball)
                                .mul_add(
                                    opening_dot_by_theta_of_place_3,
                                    F_w_right_link_frame_2_by_theta
                                        * w_right_link_frame_2_of_q_right_ball,
                                )
                            - cos_angle
                                * F_w_right_arm_frame_2
                                    .mul_add(
                                        opening_dot_by_theta_of_place_3,
                                        F_w_right_arm_frame_2_by_theta,
                                    ))) + opening_dot_by_theta_of_place_2 * sin_theta
                + cos_theta
                    * (-F_w_left_link_frame_2_by_theta + F_w_left_link_frame_2 * d2_by_theta_d2_inv
                        - sin_theta_plus_q_left_ball
                            * (-l_times_12
                                * F_v_sleeve_centre_3
                                    .mul_add(
                                        opening_dot_by_theta_of_place_3,
                                        opening_dot_by_theta_of_place_4,
                                    ) + F_w_left_link_frame_2 * w_right_arm_frame_2_of_place)))
            - w_spindle_frame_in_left_arm_frame_1 * H_left_arm_1
            - w_spindle_frame_in_left_arm_frame_3
                * H_left_arm_1.mul_add(d2_by_theta_d2_inv, -H_left_arm_1_by_theta)
            - l_times_3
                * (S::int(4) * opening_dot_by_theta_of_place_4 * sin_theta
                    - a_left_link_centre_1_by_theta * mb_times_4
                    - m
                        * (a_left_link_centre_3_2_by_theta
                            .mul_add(
                                sin_q_left_ball_doubled, a_left_arm_centre_1_by_theta,
                            ) + a_left_link_centre_1_2_by_theta * cos_q_left_ball_doubled)
                    + d2_by_theta_d2_inv * opening_dot_by_theta_of_place_8));
    let d1_inv = S::int(1) / d1;
    let d1_inv_by_12 = S::ratio(1, 12) * d1_inv;
    let spin_dot_by_theta_of_place = d1_inv
        * ((-F_w_spindle_frame_in_right_arm_frame_1)
            .mul_add(
                sin_q_right_top,
                F_w_spindle_frame_in_right_arm_frame_3 * cos_q_right_top,
            ) + F_w_spindle_frame_in_left_arm_frame_3 * cos_theta
            - F_w_spindle_frame_in_left_arm_frame_1 * sin_theta);
    let d1_inv_by_144 = S::ratio(1, 144) * d1_inv;
    let spin_dot_by_theta = d1_inv_by_12
        * (F_w_spindle_frame_in_right_arm_frame_3_by_theta * cos_q_right_top
            - F_w_spindle_frame_in_right_arm_frame_1_by_theta * sin_q_right_top
            + cos_theta
                * (F_w_spindle_frame_in_left_arm_frame_3_by_theta
                    - F_w_spindle_frame_in_left_arm_frame_1)
            - sin_theta
                * (F_w_spindle_frame_in_left_arm_frame_3
                    + F_w_spindle_frame_in_left_arm_frame_1_by_theta))
        + J_left_arm_frame_in_spindle_frame_2_by_theta * spin_dot_by_theta_of_place * d1_inv_by_144;
    let w_right_arm_frame_2_by_q_right_top_of_opening = -alpha_right_arm_frame_2_of_opening_2;
    let w_right_arm_frame_2_by_q_right_top = w_right_arm_frame_2_by_q_right_top_of_opening;
    let w_right_arm_frame_in_right_link_frame_3_by_spin_of_place = cos_q_right_top
        * cos_q_right_ball;
    let w_right_arm_frame_in_right_link_frame_3_by_spin = w_right_arm_frame_in_right_link_frame_3_by_spin_of_place
        - w_right_link_frame_2_of_place_2;
    let w_right_arm_frame_in_right_link_frame_1_by_q_right_top = spin
        * w_right_arm_frame_in_right_link_frame_3_by_spin;
    let w_right_arm_frame_in_right_link_frame_3_by_q_right_top_of_place = cos_q_right_top
        * sin_q_right_ball;
    let w_right_arm_frame_in_right_link_frame_3_by_q_right_top_of_place_2 = alpha_right_link_frame_2_of_place_2
        + w_right_arm_frame_in_right_link_frame_3_by_q_right_top_of_place;
    let w_right_arm_frame_in_right_link_frame_3_by_q_right_top = -spin
        * w_right_arm_frame_in_right_link_frame_3_by_q_right_top_of_place_2;
    let w_right_link_frame_2_by_q_right_top_of_opening = w_right_arm_frame_2_of_opening_2
        * (alpha_right_link_frame_2_of_place
            + w_right_arm_frame_in_right_link_frame_3_by_q_right_top_of_place);
    let w_right_link_frame_2_by_q_right_top = -w_right_arm_frame_2_by_q_right_top
        - w_right_link_frame_2_by_q_right_top_of_opening;
    let alpha_right_arm_frame_1_by_q_right_top = -w_right_arm_frame_2_of_opening_2
        * w_spindle_frame_in_right_arm_frame_3
            .mul_add(sin_angle, w_spindle_frame_in_right_arm_frame_1 * cos_angle);
    let w_right_arm_frame_23_by_q_right_top_of_place = w_spindle_frame_in_right_arm_frame_3
        * w_right_arm_frame_2_by_q_right_top;
    let w_right_arm_frame_23_by_q_right_top = (-w_spindle_frame_in_right_arm_frame_1)
        .mul_add(w_right_arm_frame_2, w_right_arm_frame_23_by_q_right_top_of_place);
    let alpha_right_arm_frame_in_right_link_frame_1_by_q_right_top_of_place = alpha_right_arm_frame_in_right_link_frame_1_by_theta_of_place
        * sin_angle;
    let alpha_right_arm_frame_in_right_link_frame_1_by_q_right_top = alpha_right_arm_frame_in_right_link_frame_1_of_opening
        * (spin * cos_angle * (cos_q_right_top + d2_of_place)
            - alpha_right_arm_frame_in_right_link_frame_1_by_q_right_top_of_place);
    let alpha_right_link_frame_1_by_q_right_top = alpha_right_arm_frame_in_right_link_frame_1_by_q_right_top
        - alpha_right_arm_frame_in_right_link_frame_1_of_opening
            * (w_right_arm_frame_in_right_link_frame_3 * cos_q_right_top
                + w_right_arm_frame_in_right_link_frame_3_by_q_right_top * sin_q_right_top
                + sin_q_right_ball_inv
                    * (-w_right_arm_frame_in_right_link_frame_3_by_q_right_top)
                        .mul_add(
                            w_right_link_frame_2_of_place,
                            w_right_arm_frame_in_right_link_frame_3
                                * alpha_right_link_frame_2_of_place,
                        ));
    let H_right_arm_1_by_q_right_top = w_spindle_frame_in_right_arm_frame_3 * rw_right_link_frame_3;
    let a_right_link_centre_2_by_q_right_top_of_place = w_right_arm_frame_in_right_link_frame_3
        .mul_add(
            w_right_link_frame_2_by_q_right_top, alpha_right_link_frame_1_by_q_right_top,
        );
    let a_right_link_centre_2_by_q_right_top_of_place_2 = alpha_right_arm_frame_1_by_q_right_top
        + w_right_arm_frame_23_by_q_right_top;
    let a_right_link_centre_2_by_q_right_top = l
        * w_right_link_frame_2
            .mul_add(
                w_right_arm_frame_in_right_link_frame_3_by_q_right_top,
                a_right_link_centre_2_by_q_right_top_of_place,
            ) - l_doubled * a_right_link_centre_2_by_q_right_top_of_place_2;
    let l_m_plus_mb_times_4 = l * m_plus_mb_times_4;
    let F_v_right_arm_centre_2_by_q_right_top = (-a_right_link_centre_2_by_q_right_top)
        .mul_add(
            m_doubled,
            a_right_link_centre_2_by_q_right_top_of_place_2 * l_m_plus_mb_times_4,
        );
    let F_w_right_arm_frame_in_right_link_frame_3_by_q_right_top = H_right_link_2
        * w_right_arm_frame_in_right_link_frame_1_by_q_right_top
        - H_right_link_1 * w_right_link_frame_2_by_q_right_top
        + rw_right_link_frame_3
            * (-w_right_link_frame_2)
                .mul_add(
                    w_right_arm_frame_in_right_link_frame_1_by_q_right_top,
                    w_right_arm_frame_in_right_link_frame_1 * w_right_link_frame_2_by_q_right_top,
                );
    let F_w_right_arm_frame_in_right_link_frame_1_by_q_right_top = mr_right_link_frame_3
        * l
            .mul_add(
                a_right_link_centre_2_by_q_right_top_of_place,
                S::int(3) * a_right_link_centre_2_by_q_right_top,
            ) + H_right_link_2 * w_right_arm_frame_in_right_link_frame_3_by_q_right_top;
    let F_w_spindle_frame_in_right_arm_frame_3_by_q_right_top = (-w_right_arm_frame_2)
        .mul_add(
            H_right_arm_1_by_q_right_top,
            F_w_right_arm_frame_in_right_link_frame_1_by_q_right_top * sin_q_right_ball,
        ) - F_w_right_arm_frame_in_right_link_frame_3_by_q_right_top * cos_q_right_ball
        + F_w_spindle_frame_in_right_arm_frame_1_of_place;
    let F_w_spindle_frame_in_right_arm_frame_1_by_q_right_top = l
        * (mr_right_link_frame_3
            * (alpha_right_arm_frame_1_by_q_right_top
                + w_right_arm_frame_23_by_q_right_top_of_place)
            + S::int(3) * F_v_right_arm_centre_2_by_q_right_top)
        - F_w_right_arm_frame_in_right_link_frame_3_by_q_right_top * sin_q_right_ball
        - F_w_right_arm_frame_in_right_link_frame_1_by_q_right_top * cos_q_right_ball
        - F_w_spindle_frame_in_right_arm_frame_3_of_place;
    let alpha_right_arm_frame_2_by_q_right_top_of_place = sin_q_right_ball_inv
        * alpha_right_link_frame_2_of_place;
    let alpha_right_arm_frame_2_by_q_right_top_of_opening = opening
        * alpha_right_arm_frame_2_of_opening_3;
    let alpha_right_arm_frame_2_by_q_right_top = alpha_right_arm_frame_2_by_q_right_top_of_opening
        * (w_right_arm_frame_2_of_place
            * (-sin_q_left_ball
                * (w_right_arm_frame_2_of_place_2
                    * (sin_angle
                        * (sin_q_right_top - sin_angle + alpha_right_link_frame_2_by_theta_of_place)
                        + cos_angle
                            * (cos_angle - cos_q_right_top
                                + alpha_right_arm_frame_2_by_q_right_top_of_place))
                    - alpha_right_arm_frame_2_by_theta_of_place * sin_angle)
                + d2_of_place_2 * sin_angle) + cos_q_left_ball * sin_angle);
    let w_right_arm_frame_11_by_q_right_top = spin * w_spindle_frame_in_right_arm_frame_1
        * cos_q_right_top_doubled;
    let w_right_arm_frame_13_by_q_right_top_of_place = w_spindle_frame_in_right_arm_frame_1
        * sin_q_right_top;
    let w_right_arm_frame_13_by_q_right_top = spin
        * w_spindle_frame_in_right_arm_frame_3
            .mul_add(cos_q_right_top, -w_right_arm_frame_13_by_q_right_top_of_place);
    let alpha_right_link_frame_2_by_q_right_top_of_place = cos_q_right_top
        + alpha_right_arm_frame_2_by_q_right_top_of_place;
    let alpha_right_link_frame_2_by_q_right_top_of_place_2 = cos_q_right_top * cos_angle;
    let alpha_right_link_frame_2_by_q_right_top_of_place_3 = cos_q_right_top * sin_angle;
    let alpha_right_link_frame_2_by_q_right_top = alpha_left_link_frame_2_by_theta_of_opening
        * (w_right_arm_frame_2_of_place
            * (-sin_q_left_ball
                * (sin_q_left_ball
                    * (-sin_q_right_top_sq + cos_q_right_top * cos_q_right_top
                        - sin_q_right_ball_inv
                            * (sin_q_right_top
                                * (-w_right_link_frame_2_of_place)
                                    .mul_add(S::int(2), cos_angle)
                                + sin_q_right_ball_inv
                                    * (cos_q_right_ball
                                        * (sin_q_right_top
                                            * (sin_angle + alpha_right_link_frame_2_of_place
                                                - sin_q_right_ball_inv * cos_q_right_top_doubled
                                                    * (S::int(1)
                                                        + cos_q_right_ball * (S::int(2) + cos_q_right_ball)))
                                            - cos_q_right_top
                                                * (cos_angle + w_right_link_frame_2_of_place))
                                        + alpha_right_arm_frame_2_by_theta_of_place_8
                                        - alpha_right_link_frame_2_by_q_right_top_of_place_2)
                                + alpha_right_link_frame_2_by_q_right_top_of_place_3))
                    - alpha_right_arm_frame_2_by_theta_of_place
                        * alpha_right_link_frame_2_by_q_right_top_of_place)
                + d2_of_place_2 * alpha_right_link_frame_2_by_q_right_top_of_place)
            + alpha_right_link_frame_2_by_q_right_top_of_place * cos_q_left_ball)
        - alpha_right_arm_frame_2_by_q_right_top;
    let a_right_arm_centre_1_by_q_right_top_of_place = l
        * (alpha_right_arm_frame_2_by_q_right_top - w_right_arm_frame_13_by_q_right_top);
    let a_right_arm_centre_1_by_q_right_top = g
        .mul_add(cos_q_right_top_doubled, a_right_arm_centre_1_by_q_right_top_of_place);
    let a_right_link_centre_1_by_q_right_top = a_spindle_frame_in_right_arm_frame_3
        + a_right_arm_centre_1_by_q_right_top_of_place;
    let a_right_link_centre_3_by_q_right_top = l
        * w_right_arm_frame_2_by_q_right_top
            .mul_add(
                a_right_arm_frame_in_right_link_frame_1_by_theta_of_place,
                w_right_arm_frame_11_by_q_right_top,
            ) - a_spindle_frame_in_right_arm_frame_1;
    let a_right_arm_frame_in_right_link_frame_1_by_q_right_top = a_right_link_centre_3_by_q_right_top
        .mul_add(
            sin_q_right_ball,
            a_right_link_centre_1_by_q_right_top * cos_q_right_ball,
        );
    let a_right_arm_frame_in_right_link_frame_3_by_q_right_top = (-a_right_link_centre_1_by_q_right_top)
        .mul_add(
            sin_q_right_ball,
            a_right_link_centre_3_by_q_right_top * cos_q_right_ball,
        );
    let a_right_link_centre_1_2_by_q_right_top_of_place = w_right_arm_frame_in_right_link_frame_3
        .mul_add(
            w_right_arm_frame_in_right_link_frame_1_by_q_right_top,
            alpha_right_link_frame_2_by_q_right_top,
        );
    let a_right_link_centre_1_2_by_q_right_top = l
        * w_right_arm_frame_in_right_link_frame_1
            .mul_add(
                w_right_arm_frame_in_right_link_frame_3_by_q_right_top,
                a_right_link_centre_1_2_by_q_right_top_of_place,
            ) - S::int(2) * a_right_arm_frame_in_right_link_frame_1_by_q_right_top;
    let a_right_link_centre_3_2_by_q_right_top = l_doubled
        * w_right_link_frame_2
            .mul_add(
                w_right_link_frame_2_by_q_right_top,
                w_right_arm_frame_in_right_link_frame_1
                    * w_right_arm_frame_in_right_link_frame_1_by_q_right_top,
            ) + S::int(2) * a_right_arm_frame_in_right_link_frame_3_by_q_right_top;
    let F_w_right_link_frame_2_by_q_right_top = mr_right_link_frame_3
        * l
            .mul_add(
                a_right_link_centre_1_2_by_q_right_top_of_place,
                S::int(3) * a_right_link_centre_1_2_by_q_right_top,
            ) + H_right_link_1 * w_right_arm_frame_in_right_link_frame_3_by_q_right_top;
    let F_w_right_arm_frame_2_by_q_right_top = w_spindle_frame_in_right_arm_frame_3
        * H_right_arm_1_by_q_right_top - w_spindle_frame_in_right_arm_frame_1 * H_right_arm_1
        + F_w_right_link_frame_2_by_q_right_top
        - l
            * (m
                * (a_right_arm_centre_1_by_q_right_top
                    .mul_add(S::int(3), l * alpha_right_arm_frame_2_by_q_right_top)
                    - a_right_link_centre_3_2_by_q_right_top * sin_q_right_ball_times_6
                    - a_right_link_centre_1_2_by_q_right_top * cos_q_right_ball_times_6)
                + S::int(12) * mb * a_right_link_centre_1_by_q_right_top);
    let J_right_arm_frame_in_spindle_frame_by_q_right_top = J_right_arm_frame_13
        .mul_add(
            sin_q_right_top_doubled,
            J_right_arm_frame_in_spindle_frame_31 * cos_q_right_top,
        );
    let J_right_arm_frame_in_spindle_frame_2_by_q_right_top = J_right_arm_frame_in_spindle_frame_by_q_right_top
        .mul_add(sin_q_right_top, J_right_arm_frame_in_spindle_frame * cos_q_right_top);
    let cos_q_right_ball_sq = cos_q_right_ball * cos_q_right_ball;
    let d2_by_q_right_top_of_place = d2_of_m_mb * sin_q_right_ball;
    let d2_by_q_right_top = w_right_arm_frame_2_of_place_2 * d2_by_theta_of_place_4
        * (-cos_q_right_top_doubled
            * (sin_q_right_top
                * (m * cos_q_right_ball_sq.mul_add(S::int(5), -S::int(3))
                    + mb_times_3 * cos_q_right_ball_sq.mul_add(S::int(2), -S::int(1)))
                + w_right_arm_frame_in_right_link_frame_3_by_spin_of_place
                    * d2_by_q_right_top_of_place) + d2_by_q_right_top_of_place * cos_q_right_ball);
    let opening_dot_by_q_right_top_of_place = F_w_right_link_frame_2 - F_w_right_arm_frame_2;
    let opening_dot_by_q_right_top_of_place_2 = w_spindle_frame_in_left_arm_frame_3 * H_left_arm_1;
    let opening_dot_by_q_right_top_of_place_3 = (-opening_dot_by_q_right_top_of_place)
        .mul_add(sin_q_right_top, opening_dot_by_q_right_top_of_place_2 * sin_theta);
    let opening_dot_by_q_right_top_of_place_4 = F_w_right_link_frame_2_by_q_right_top
        - F_w_right_arm_frame_2_by_q_right_top;
    let opening_dot_by_q_right_top_of_place_5 = opening_dot_by_q_right_top_of_place
        .mul_add(cos_q_right_ball, F_w_right_link_frame_2);
    let opening_dot_by_q_right_top_of_place_6 = F_v_left_arm_frame_in_left_link_frame_3
        * cos_q_left_ball;
    let opening_dot_by_q_right_top_of_place_7 = cos_theta
        * (-opening_dot_by_q_right_top_of_place_2)
            .mul_add(cos_q_left_ball, F_w_left_link_frame_2);
    let d2_inv_d2_inv_by_12 = d2_inv * d2_inv_by_12;
    let opening_dot_by_q_right_top = -d2_by_theta_of_place_3 * d2_inv_d2_inv_by_12
        * (sin_q_left_ball
            * (sin_q_right_ball
                * (d2_by_q_right_top
                    * (l_times_3
                        * ((-F_v_left_arm_frame_in_left_link_frame_3)
                            .mul_add(
                                d2_of_place_2_doubled,
                                opening_dot_by_theta_of_place_6 * sin_theta,
                            ) - opening_dot_by_theta_of_place_5)
                        + opening_dot_by_q_right_top_of_place_3)
                    + d2
                        * opening_dot_by_q_right_top_of_place_4
                            .mul_add(
                                sin_q_right_top,
                                opening_dot_by_q_right_top_of_place * cos_q_right_top,
                            ))
                + cos_q_right_top
                    * (F_w_right_link_frame_2 * d2_by_q_right_top
                        - d2 * F_w_right_link_frame_2_by_q_right_top
                        + cos_q_right_ball
                            * (-d2)
                                .mul_add(
                                    opening_dot_by_q_right_top_of_place_4,
                                    d2_by_q_right_top * opening_dot_by_q_right_top_of_place,
                                )) + d2 * opening_dot_by_q_right_top_of_place_5 * sin_q_right_top)
            + d2_by_q_right_top * sin_q_right_ball
                * (l_times_3
                    * (-cos_q_left_ball
                        * sin_theta_doubled
                            .mul_add(
                                opening_dot_by_q_right_top_of_place_6,
                                opening_dot_by_theta_of_place_6 * cos_theta,
                            ) + F_v_left_arm_frame_in_left_link_frame_3 * sin_theta_doubled)
                    + opening_dot_by_q_right_top_of_place_7));
    let spin_dot_by_q_right_top_of_place = cos_q_right_top
        * (F_w_spindle_frame_in_right_arm_frame_1
            - F_w_spindle_frame_in_right_arm_frame_3_by_q_right_top)
        + sin_q_right_top
            * (F_w_spindle_frame_in_right_arm_frame_3
                + F_w_spindle_frame_in_right_arm_frame_1_by_q_right_top);
    let spin_dot_by_q_right_top = d1_inv_by_144
        * (-spin_dot_by_q_right_top_of_place)
            .mul_add(
                S::int(12),
                J_right_arm_frame_in_spindle_frame_2_by_q_right_top * spin_dot_by_theta_of_place,
            );
    let w_right_arm_frame_2_by_q_left_ball_of_place = alpha_right_arm_frame_2_of_place
        .mul_add(sin_q_left_ball, cos_q_left_ball);
    let w_right_arm_frame_2_by_q_left_ball = alpha_right_arm_frame_2_of_opening_3
        * w_right_arm_frame_2_by_q_left_ball_of_place * cos_angle;
    let w_left_arm_frame_in_left_link_frame_1_by_q_left_ball = w_left_arm_frame_in_left_link_frame_3_of_place;
    let w_left_arm_frame_in_left_link_frame_3_by_q_left_ball = -w_left_arm_frame_in_left_link_frame_1;
    let w_left_link_frame_2_by_q_left_ball_of_opening = w_right_arm_frame_2_of_opening
        * alpha_right_arm_frame_2_by_theta_of_place;
    let w_left_link_frame_2_by_q_left_ball_of_opening_2 = -w_left_link_frame_2_by_q_left_ball_of_opening;
    let w_left_link_frame_2_by_q_left_ball = w_left_link_frame_2_by_q_left_ball_of_opening_2;
    let w_right_link_frame_2_by_q_left_ball_of_opening = alpha_right_arm_frame_2_of_opening_3
        .mul_add(
            alpha_right_link_frame_2_of_place_3, w_right_link_frame_2_by_theta_of_opening,
        );
    let w_right_link_frame_2_by_q_left_ball = w_right_link_frame_2_by_q_left_ball_of_opening
        - w_right_arm_frame_2_by_q_left_ball;
    let alpha_right_arm_frame_1_by_q_left_ball = w_spindle_frame_in_right_arm_frame_3
        * w_right_arm_frame_2_by_q_left_ball;
    let alpha_left_arm_frame_in_left_link_frame_1_by_q_left_ball = opening
        * w_left_arm_frame_in_left_link_frame_1;
    let alpha_left_link_frame_1_by_q_left_ball = alpha_left_arm_frame_in_left_link_frame_1_by_q_left_ball
        + opening
            * (w_left_arm_frame_in_left_link_frame_3_by_q_left_ball
                + a_sleeve_centre_3_by_theta_of_place
                    * (w_left_arm_frame_in_left_link_frame_3_by_q_left_ball
                        + alpha_left_link_frame_1_by_theta_of_place));
    let alpha_right_arm_frame_in_right_link_frame_1_by_q_left_ball = w_right_arm_frame_2_of_opening
        * alpha_right_arm_frame_in_right_link_frame_1_by_theta_of_place
        * w_right_arm_frame_2_by_q_left_ball_of_place * cos_angle;
    let alpha_right_link_frame_1_by_q_left_ball = w_right_arm_frame_in_right_link_frame_3
        .mul_add(
            w_right_link_frame_2_by_q_left_ball_of_opening,
            alpha_right_arm_frame_in_right_link_frame_1_by_q_left_ball,
        );
    let a_right_link_centre_2_by_q_left_ball_of_place = S::int(2)
        * alpha_right_arm_frame_1_by_q_left_ball;
    let a_right_link_centre_2_by_q_left_ball_of_place_2 = l
        * w_right_arm_frame_in_right_link_frame_3
            .mul_add(
                w_right_link_frame_2_by_q_left_ball, alpha_right_link_frame_1_by_q_left_ball,
            );
    let a_right_link_centre_2_by_q_left_ball = (-l_doubled)
        .mul_add(
            a_right_link_centre_2_by_q_left_ball_of_place,
            a_right_link_centre_2_by_q_left_ball_of_place_2,
        );
    let F_v_right_arm_centre_2_by_q_left_ball = (-a_right_link_centre_2_by_q_left_ball)
        .mul_add(
            m_doubled,
            l * m_plus_mb_times_4 * a_right_link_centre_2_by_q_left_ball_of_place,
        );
    let F_w_right_arm_frame_in_right_link_frame_1_by_q_left_ball = mr_right_link_frame_3
        * a_right_link_centre_2_by_q_left_ball
            .mul_add(S::int(3), a_right_link_centre_2_by_q_left_ball_of_place_2);
    let F_w_left_arm_frame_in_left_link_frame_3_by_q_left_ball = H_left_link_2
        * w_left_arm_frame_in_left_link_frame_1_by_q_left_ball
        - H_left_link_1 * w_left_link_frame_2_by_q_left_ball
        + rw_right_link_frame_3
            * (-w_left_link_frame_2)
                .mul_add(
                    w_left_arm_frame_in_left_link_frame_1_by_q_left_ball,
                    w_left_arm_frame_in_left_link_frame_1 * w_left_link_frame_2_by_q_left_ball,
                );
    let F_w_left_arm_frame_in_left_link_frame_1_by_q_left_ball_of_place = w_left_arm_frame_in_left_link_frame_3
        .mul_add(
            w_left_link_frame_2_by_q_left_ball, -alpha_left_link_frame_1_by_q_left_ball,
        );
    let F_w_left_arm_frame_in_left_link_frame_1_by_q_left_ball_of_place_2 = w_left_link_frame_2
        * w_left_arm_frame_in_left_link_frame_3_by_q_left_ball;
    let F_w_left_arm_frame_in_left_link_frame_1_by_q_left_ball = rw_right_link_frame_3
        * F_w_left_arm_frame_in_left_link_frame_1_by_q_left_ball_of_place_2
            .mul_add(
                S::int(3),
                S::int(4) * F_w_left_arm_frame_in_left_link_frame_1_by_q_left_ball_of_place,
            ) + H_left_link_2 * w_left_arm_frame_in_left_link_frame_3_by_q_left_ball;
    let F_w_spindle_frame_in_right_arm_frame_3_by_q_left_ball = F_w_right_arm_frame_in_right_link_frame_1_by_q_left_ball
        * sin_q_right_ball - H_right_arm_1 * w_right_arm_frame_2_by_q_left_ball
        + rw_right_link_frame_3
            * (-w_right_link_frame_2_by_q_left_ball)
                .mul_add(
                    F_w_spindle_frame_in_right_arm_frame_3_by_theta_of_place,
                    w_spindle_frame_in_right_arm_frame_1 * w_right_arm_frame_2_by_q_left_ball,
                )
        + w_right_link_frame_2_by_q_left_ball
            * F_w_spindle_frame_in_right_arm_frame_3_by_theta_of_place_2;
    let F_w_spindle_frame_in_right_arm_frame_1_by_q_left_ball = w_right_link_frame_2_by_q_left_ball
        * F_w_spindle_frame_in_right_arm_frame_1_by_theta_of_place_2
        - F_w_right_arm_frame_in_right_link_frame_1_by_q_left_ball * cos_q_right_ball
        + l
            * (mr_right_link_frame_3
                * (-w_right_link_frame_2_by_q_left_ball)
                    .mul_add(
                        F_w_spindle_frame_in_right_arm_frame_1_by_theta_of_place,
                        a_right_link_centre_2_by_q_left_ball_of_place,
                    ) + S::int(3) * F_v_right_arm_centre_2_by_q_left_ball);
    let F_w_spindle_frame_in_left_arm_frame_3_by_q_left_ball_of_place = F_w_left_arm_frame_in_left_link_frame_3
        + F_w_left_arm_frame_in_left_link_frame_1_by_q_left_ball;
    let F_w_spindle_frame_in_left_arm_frame_3_by_q_left_ball_of_place_2 = F_w_left_arm_frame_in_left_link_frame_1
        - F_w_left_arm_frame_in_left_link_frame_3_by_q_left_ball;
    let F_w_spindle_frame_in_left_arm_frame_3_by_q_left_ball = (-F_w_spindle_frame_in_left_arm_frame_3_by_q_left_ball_of_place_2)
        .mul_add(
            cos_q_left_ball,
            -F_w_spindle_frame_in_left_arm_frame_3_by_q_left_ball_of_place * sin_q_left_ball,
        );
    let F_w_spindle_frame_in_left_arm_frame_1_by_q_left_ball_of_place = S::int(6)
        * rw_right_link_frame_3;
    let F_w_spindle_frame_in_left_arm_frame_1_by_q_left_ball = F_w_spindle_frame_in_left_arm_frame_3_by_q_left_ball_of_place
        * cos_q_left_ball
        - F_w_spindle_frame_in_left_arm_frame_3_by_q_left_ball_of_place_2 * sin_q_left_ball
        + F_w_spindle_frame_in_left_arm_frame_1_by_q_left_ball_of_place
            * (F_w_left_arm_frame_in_left_link_frame_1_by_q_left_ball_of_place
                + F_w_left_arm_frame_in_left_link_frame_1_by_q_left_ball_of_place_2);
    let alpha_right_arm_frame_2_by_q_left_ball_of_place = w_right_link_frame_2_of_q_right_ball
        * w_right_arm_frame_2_by_q_left_ball_of_place;
    let alpha_right_arm_frame_2_by_q_left_ball_of_place_2 = w_right_arm_frame_2_by_q_left_ball_of_place
        * sin_angle;
    let alpha_right_arm_frame_2_by_q_left_ball_of_place_3 = S::int(1)
        + a_sleeve_centre_3_by_theta_of_place_2;
    let alpha_right_arm_frame_2_by_q_left_ball_of_place_4 = sin_q_left_ball * cos_angle;
    let alpha_right_arm_frame_2_by_q_left_ball = alpha_right_arm_frame_2_by_q_right_top_of_opening
        * (w_right_arm_frame_2_of_place
            * (sin_q_left_ball
                * (S::int(2) * sin_q_right_ball_inv
                    * (cos_q_right_top
                        * (alpha_right_arm_frame_2_by_q_left_ball_of_place_2
                            + cos_q_right_ball
                                * alpha_right_arm_frame_2_by_theta_of_place_4
                                    .mul_add(
                                        alpha_right_arm_frame_2_by_q_left_ball_of_place,
                                        alpha_right_arm_frame_2_by_q_left_ball_of_place_2,
                                    ))
                        - cos_angle
                            * alpha_right_link_frame_2_of_place_2
                                .mul_add(
                                    w_right_arm_frame_2_by_q_left_ball_of_place,
                                    alpha_right_arm_frame_2_by_q_left_ball_of_place_2,
                                ))
                    - alpha_right_arm_frame_2_of_place
                        * alpha_right_arm_frame_2_by_theta_of_place_2 * cos_angle
                    - sin_q_right_top_doubled * alpha_right_arm_frame_2_by_q_left_ball_of_place_2)
                - alpha_right_arm_frame_2_of_place_3
                    * alpha_right_arm_frame_2_by_q_left_ball_of_place_3
                    * sin_theta_plus_q_left_ball)
            + alpha_right_arm_frame_2_by_q_left_ball_of_place_4);
    let alpha_left_link_frame_2_by_q_left_ball = -alpha_right_link_frame_2_by_theta_of_opening
        * cos_theta_sq
            .mul_add(
                alpha_left_link_frame_2_by_theta_of_place,
                sin_theta * sin_theta_plus_q_left_ball,
            );
    let alpha_right_link_frame_2_by_q_left_ball = -alpha_right_arm_frame_2_by_q_left_ball
        - alpha_left_link_frame_2_by_theta_of_opening
            * (w_right_arm_frame_2_of_place
                * (sin_q_right_ball_inv
                    * (cos_q_right_top
                        * (sin_q_left_ball
                            * alpha_right_link_frame_2_by_theta_of_place_3
                                .mul_add(
                                    cos_q_left_ball_doubled,
                                    alpha_right_arm_frame_2_of_place
                                        * alpha_right_link_frame_2_by_theta_of_place_4,
                                )
                            + w_right_link_frame_2_of_q_right_ball
                                * alpha_right_arm_frame_2_by_q_left_ball_of_place_3
                                * sin_theta_plus_q_left_ball * cos_q_left_ball)
                        + alpha_right_link_frame_2_by_theta_of_place_5 * sin_q_right_top_doubled
                            * alpha_right_arm_frame_2_by_q_left_ball_of_place)
                    - sin_q_right_top * sin_theta_plus_q_left_ball
                        * a_sleeve_centre_3_by_theta_of_place_2
                            .mul_add(
                                w_right_arm_frame_2_by_q_left_ball_of_place, cos_q_left_ball,
                            )) + alpha_right_link_frame_2_by_theta_of_place_7 * sin_q_left_ball);
    let a_left_arm_frame_in_left_link_frame_1_by_q_left_ball = a_left_arm_frame_in_left_link_frame_3;
    let a_left_arm_frame_in_left_link_frame_3_by_q_left_ball = -a_left_arm_frame_in_left_link_frame_1;
    let a_left_link_centre_1_2_by_q_left_ball_of_place = w_left_arm_frame_in_left_link_frame_3
        .mul_add(
            w_left_arm_frame_in_left_link_frame_1_by_q_left_ball,
            alpha_left_link_frame_2_by_q_left_ball,
        );
    let a_left_link_centre_1_2_by_q_left_ball = l
        * w_left_arm_frame_in_left_link_frame_1
            .mul_add(
                w_left_arm_frame_in_left_link_frame_3_by_q_left_ball,
                a_left_link_centre_1_2_by_q_left_ball_of_place,
            ) - S::int(2) * a_left_arm_frame_in_left_link_frame_1_by_q_left_ball;
    let a_left_link_centre_3_2_by_q_left_ball = l_doubled
        * w_left_link_frame_2
            .mul_add(
                w_left_link_frame_2_by_q_left_ball,
                w_left_arm_frame_in_left_link_frame_1
                    * w_left_arm_frame_in_left_link_frame_1_by_q_left_ball,
            ) + S::int(2) * a_left_arm_frame_in_left_link_frame_3_by_q_left_ball;
    let a_right_arm_frame_in_right_link_frame_1_by_q_left_ball = l
        * w_right_arm_frame_2_by_q_left_ball
            .mul_add(
                a_right_arm_frame_in_right_link_frame_1_by_theta_of_place_2,
                alpha_right_arm_frame_2_by_q_left_ball * cos_q_right_ball,
            );
    let a_right_arm_frame_in_right_link_frame_3_by_q_left_ball = l
        * (-alpha_right_arm_frame_2_by_q_left_ball)
            .mul_add(
                sin_q_right_ball,
                w_right_arm_frame_2_by_q_left_ball
                    * a_right_arm_frame_in_right_link_frame_3_by_theta_of_place,
            );
    let a_sleeve_centre_3_by_q_left_ball = l * alpha_right_link_frame_2_by_theta_of_opening
        * alpha_right_arm_frame_2_by_theta_of_place_2
            .mul_add(a_sleeve_centre_3_by_theta_of_place, sin_theta);
    let F_w_right_link_frame_2_by_q_left_ball = F_w_right_link_frame_2_by_theta_of_place
        * (-a_right_arm_frame_in_right_link_frame_1_by_q_left_ball)
            .mul_add(S::int(3), alpha_right_link_frame_2_by_q_left_ball * l_doubled);
    let F_w_left_link_frame_2_by_q_left_ball = mr_right_link_frame_3
        * l
            .mul_add(
                a_left_link_centre_1_2_by_q_left_ball_of_place,
                S::int(3) * a_left_link_centre_1_2_by_q_left_ball,
            ) + H_left_link_1 * w_left_arm_frame_in_left_link_frame_3_by_q_left_ball;
    let F_w_right_arm_frame_2_by_q_left_ball = F_w_right_link_frame_2_by_q_left_ball
        - l_doubled
            * (m
                * (l
                    * ((-alpha_right_link_frame_2_by_q_left_ball)
                        .mul_add(
                            cos_q_right_ball_times_3,
                            S::int(2) * alpha_right_arm_frame_2_by_q_left_ball,
                        )
                        - w_right_link_frame_2_by_q_left_ball
                            * F_w_right_arm_frame_2_by_theta_of_place)
                    - a_right_arm_frame_in_right_link_frame_3_by_q_left_ball
                        * sin_q_right_ball_times_6
                    + a_right_arm_frame_in_right_link_frame_1_by_q_left_ball
                        * cos_q_right_ball_times_6)
                + alpha_right_arm_frame_2_by_q_left_ball * mb_l_times_6);
    let J_left_link_frame_in_left_arm_frame_2_by_q_left_ball = S::int(2)
        * J_left_link_frame_in_left_arm_frame_13_of_place;
    let J_left_link_frame_in_left_arm_frame_13_by_q_left_ball = J_right_link_frame_11_2
        * cos_q_left_ball * cos_q_left_ball - J_left_link_frame_in_left_arm_frame_2;
    let rw_left_arm_frame_3_by_q_left_ball = -rw_right_link_frame_3 * sin_q_left_ball_doubled;
    let J_left_arm_frame_13_by_q_left_ball = F_w_spindle_frame_in_left_arm_frame_1_by_q_left_ball_of_place
        .mul_add(cos_q_left_ball, J_left_link_frame_in_left_arm_frame_13_by_q_left_ball);
    let J_left_arm_frame_in_spindle_frame_by_q_left_ball = sin_theta_doubled
        * (-rw_left_arm_frame_3_by_q_left_ball)
            .mul_add(S::int(3), J_left_link_frame_in_left_arm_frame_2_by_q_left_ball)
        - J_left_arm_frame_13_by_q_left_ball * cos_theta_doubled;
    let d1_by_q_left_ball_of_place = J_left_arm_frame_in_spindle_frame_by_q_left_ball
        .mul_add(sin_theta, -J_left_link_frame_in_left_arm_frame_2_by_q_left_ball);
    let d1_by_q_left_ball = -S::ratio(1, 12) * d1_by_q_left_ball_of_place;
    let d2_by_q_left_ball_of_place = sin_q_right_ball_inv * d2_by_theta_of_place_3;
    let d2_by_q_left_ball = d2_of_place_4 * d2_by_q_left_ball_of_place * cos_theta
        * (-sin_q_left_ball
            * (sin_q_right_ball
                * (sin_q_right_ball
                    * (m * (d2_by_theta_of_q_right_top - cos_theta_sq)
                        + d2_by_theta_of_place) - d2_of_m_mb * d2_by_theta_of_place_2)
                - d2_by_theta_of_q_right_top_2 * d2_by_theta_of_m_mb)
            + sin_theta_d2_of_place_2 * m_sin_q_right_ball_sq);
    let opening_dot_by_q_left_ball_of_place = sin_q_right_ball_inv
        * (-F_w_right_arm_frame_2)
            .mul_add(cos_angle, F_w_right_link_frame_2 * w_right_link_frame_2_of_place)
        - F_w_right_link_frame_2 * sin_q_right_top;
    let opening_dot_by_q_left_ball_of_place_2 = ms * a_sleeve_centre_3_by_q_left_ball;
    let opening_dot_by_q_left_ball_of_place_3 = F_v_left_link_centre_1
        .mul_add(sin_q_left_ball, -opening_dot_by_q_right_top_of_place_6);
    let m_cos_q_left_ball = m * cos_q_left_ball;
    let opening_dot_by_q_left_ball_of_place_4 = w_right_arm_frame_2_of_place
        * opening_dot_by_q_left_ball_of_place
            .mul_add(sin_q_left_ball, opening_dot_by_theta_of_place_2 * cos_theta);
    let opening_dot_by_q_left_ball = d2_by_q_left_ball * d2_inv_d2_inv_by_12
        * ((-l_times_3)
            .mul_add(
                opening_dot_by_theta_of_place_8, opening_dot_by_q_left_ball_of_place_4,
            ) - opening_dot_by_q_right_top_of_place_2)
        - d2_inv_by_12
            * (w_right_arm_frame_2_of_place
                * (-sin_q_left_ball
                    * (sin_q_right_ball_inv
                        * (-F_w_right_link_frame_2_by_q_left_ball)
                            .mul_add(
                                w_right_link_frame_2_of_place,
                                F_w_right_arm_frame_2_by_q_left_ball * cos_angle,
                            ) + F_w_right_link_frame_2_by_q_left_ball * sin_q_right_top)
                    + opening_dot_by_q_left_ball_of_place * cos_q_left_ball
                    + cos_theta
                        * ((-(F_v_sleeve_centre_3 * l_times_12))
                            .mul_add(
                                cos_theta_plus_q_left_ball, F_w_left_link_frame_2_by_q_left_ball,
                            )
                            - opening_dot_by_theta_of_place
                                * opening_dot_by_q_left_ball_of_place_2))
                + l_times_6
                    * ((-(m * a_left_link_centre_3_2_by_q_left_ball))
                        .mul_add(
                            sin_q_left_ball,
                            sin_theta_doubled * opening_dot_by_q_left_ball_of_place_2,
                        ) + opening_dot_by_q_left_ball_of_place_3
                        - a_left_link_centre_1_2_by_q_left_ball * m_cos_q_left_ball)
                + alpha_right_arm_frame_2_of_place * opening_dot_by_q_left_ball_of_place_4);
    let spin_dot_by_q_left_ball = d1_inv_by_12
        * ((-F_w_spindle_frame_in_right_arm_frame_1_by_q_left_ball)
            .mul_add(
                sin_q_right_top,
                F_w_spindle_frame_in_right_arm_frame_3_by_q_left_ball * cos_q_right_top,
            ) + F_w_spindle_frame_in_left_arm_frame_3_by_q_left_ball * cos_theta
            - F_w_spindle_frame_in_left_arm_frame_1_by_q_left_ball * sin_theta
            - d1_by_q_left_ball * spin_dot_by_theta_of_place);
    let w_right_arm_frame_2_by_q_right_ball_of_place = w_right_arm_frame_2_of_place_2
        * cos_q_right_top;
    let w_right_arm_frame_2_by_q_right_ball = opening * d2_by_theta_of_place_3
        * w_right_arm_frame_2_by_q_right_ball_of_place;
    let w_right_arm_frame_in_right_link_frame_1_by_q_right_ball = w_right_arm_frame_in_right_link_frame_3_of_place_3;
    let w_right_arm_frame_in_right_link_frame_3_by_q_right_ball = -w_right_arm_frame_in_right_link_frame_1;
    let w_right_link_frame_2_by_q_right_ball_of_opening = w_right_arm_frame_2_of_opening_2
        * alpha_right_link_frame_2_by_theta_of_place;
    let w_right_link_frame_2_by_q_right_ball = -w_right_arm_frame_2_by_q_right_ball
        - w_right_link_frame_2_by_q_right_ball_of_opening;
    let alpha_right_arm_frame_1_by_q_right_ball = w_spindle_frame_in_right_arm_frame_3
        * w_right_arm_frame_2_by_q_right_ball;
    let alpha_right_arm_frame_in_right_link_frame_1_by_q_right_ball = alpha_right_arm_frame_in_right_link_frame_1_of_opening
        * (w_spindle_frame_in_right_arm_frame_3 * sin_q_right_ball_inv)
            .mul_add(
                alpha_right_arm_frame_2_by_theta_of_place_4,
                -alpha_right_arm_frame_in_right_link_frame_1_by_q_right_top_of_place,
            );
    let alpha_right_link_frame_1_by_q_right_ball = alpha_right_arm_frame_in_right_link_frame_1_by_q_right_ball
        - alpha_right_arm_frame_in_right_link_frame_1_of_opening
            * (w_right_link_frame_2_of_q_right_ball * alpha_right_link_frame_2_by_theta_of_place_9
                * w_right_arm_frame_in_right_link_frame_3
                    .mul_add(
                        sin_q_right_ball_inv,
                        -w_right_arm_frame_in_right_link_frame_3_by_q_right_ball,
                    )
                + w_right_arm_frame_in_right_link_frame_3_by_q_right_ball * sin_q_right_top);
    let a_right_link_centre_2_by_q_right_ball_of_place = w_right_arm_frame_in_right_link_frame_3
        .mul_add(
            w_right_link_frame_2_by_q_right_ball, alpha_right_link_frame_1_by_q_right_ball,
        );
    let a_right_link_centre_2_by_q_right_ball_of_place_2 = S::int(2)
        * alpha_right_arm_frame_1_by_q_right_ball;
    let a_right_link_centre_2_by_q_right_ball = l
        * w_right_link_frame_2
            .mul_add(
                w_right_arm_frame_in_right_link_frame_3_by_q_right_ball,
                a_right_link_centre_2_by_q_right_ball_of_place,
            ) - l_doubled * a_right_link_centre_2_by_q_right_ball_of_place_2;
    let F_v_right_arm_centre_2_by_q_right_ball = (-a_right_link_centre_2_by_q_right_ball)
        .mul_add(
            m_doubled,
            l * m_plus_mb_times_4 * a_right_link_centre_2_by_q_right_ball_of_place_2,
        );
    let F_w_right_arm_frame_in_right_link_frame_3_by_q_right_ball = H_right_link_2
        * w_right_arm_frame_in_right_link_frame_1_by_q_right_ball
        - H_right_link_1 * w_right_link_frame_2_by_q_right_ball
        + rw_right_link_frame_3
            * (-w_right_link_frame_2)
                .mul_add(
                    w_right_arm_frame_in_right_link_frame_1_by_q_right_ball,
                    w_right_arm_frame_in_right_link_frame_1 * w_right_link_frame_2_by_q_right_ball,
                );
    let F_w_right_arm_frame_in_right_link_frame_1_by_q_right_ball = mr_right_link_frame_3
        * l
            .mul_add(
                a_right_link_centre_2_by_q_right_ball_of_place,
                S::int(3) * a_right_link_centre_2_by_q_right_ball,
            ) + H_right_link_2 * w_right_arm_frame_in_right_link_frame_3_by_q_right_ball;
    let F_w_spindle_frame_in_right_arm_frame_3_by_q_right_ball_of_place = F_w_right_arm_frame_in_right_link_frame_3
        + F_w_right_arm_frame_in_right_link_frame_1_by_q_right_ball;
    let F_w_spindle_frame_in_right_arm_frame_3_by_q_right_ball_of_place_2 = F_w_right_arm_frame_in_right_link_frame_1
        - F_w_right_arm_frame_in_right_link_frame_3_by_q_right_ball;
    let F_w_spindle_frame_in_right_arm_frame_3_by_q_right_ball = F_w_spindle_frame_in_right_arm_frame_3_by_q_right_ball_of_place_2
        .mul_add(
            cos_q_right_ball,
            F_w_spindle_frame_in_right_arm_frame_3_by_q_right_ball_of_place * sin_q_right_ball,
        );
    let F_w_spindle_frame_in_right_arm_frame_1_by_q_right_ball = l
        * mr_right_link_frame_3
            .mul_add(
                a_right_link_centre_2_by_q_right_ball_of_place_2,
                S::int(3) * F_v_right_arm_centre_2_by_q_right_ball,
            )
        - F_w_spindle_frame_in_right_arm_frame_3_by_q_right_ball_of_place * cos_q_right_ball
        + F_w_spindle_frame_in_right_arm_frame_3_by_q_right_ball_of_place_2 * sin_q_right_ball;
    let alpha_right_arm_frame_2_by_q_right_ball_of_place = alpha_right_arm_frame_2_by_theta_of_place_4
        .mul_add(cos_q_right_ball, sin_angle);
    let alpha_right_arm_frame_2_by_q_right_ball = alpha_right_arm_frame_2_by_q_right_top_of_opening
        * (-w_right_arm_frame_2_of_place
            * (sin_q_left_ball
                * (sin_q_left_ball
                    * (sin_q_right_ball_inv
                        * (cos_angle * cos_angle - sin_angle * sin_angle
                            - cos_q_right_ball
                                * (-sin_q_right_ball_inv
                                    * (-alpha_right_arm_frame_2_by_theta_of_place_7)
                                        .mul_add(
                                            S::int(2),
                                            S::int(3) * alpha_right_arm_frame_2_by_theta_of_place_6,
                                        ) + sin_q_right_top_doubled * sin_angle
                                    - alpha_right_link_frame_2_by_q_right_top_of_place_2))
                        + alpha_right_link_frame_2_by_q_right_top_of_place_3)
                    - alpha_right_arm_frame_2_by_theta_of_place
                        * alpha_right_arm_frame_2_by_q_right_ball_of_place)
                - d2_of_place_2 * alpha_right_arm_frame_2_by_q_right_ball_of_place)
            + alpha_right_arm_frame_2_by_q_right_ball_of_place * cos_q_left_ball);
    let alpha_right_link_frame_2_by_q_right_ball = alpha_right_arm_frame_2_by_q_right_top_of_opening
        * (w_right_arm_frame_2_of_place
            * (sin_q_left_ball
                * (sin_q_left_ball
                    * (sin_q_right_ball_inv
                        * (sin_q_right_top
                            * alpha_right_arm_frame_2_by_theta_of_place_5
                                .mul_add(
                                    S::int(2),
                                    w_right_link_frame_2_of_q_right_ball * sin_angle,
                                )
                            + cos_q_right_top
                                * (cos_q_right_top
                                    * (-(w_right_link_frame_2_of_q_right_ball
                                        * sin_q_right_ball_inv_sq))
                                        .mul_add(S::int(6), S::int(4) + cos_q_right_ball)
                                    + cos_angle * cos_q_right_ball
                                    + S::int(2) * alpha_right_arm_frame_2_by_q_right_top_of_place))
                        - alpha_right_link_frame_2_by_theta_of_place_2 * sin_q_right_top
                        + alpha_right_link_frame_2_by_q_right_top_of_place_3)
                    + alpha_right_arm_frame_2_by_theta_of_place
                        * alpha_right_link_frame_2_by_theta_of_place)
                + d2_of_place_2 * alpha_right_link_frame_2_by_theta_of_place)
            + alpha_right_link_frame_2_by_theta_of_place * cos_q_left_ball)
        - alpha_right_arm_frame_2_by_q_right_ball;
    let a_right_arm_frame_in_right_link_frame_1_by_q_right_ball = l
        * w_right_arm_frame_2_by_q_right_ball
            .mul_add(
                a_right_arm_frame_in_right_link_frame_1_by_theta_of_place_2,
                alpha_right_arm_frame_2_by_q_right_ball * cos_q_right_ball,
            ) - a_right_arm_frame_in_right_link_frame_3_of_place;
    let a_right_arm_frame_in_right_link_frame_3_by_q_right_ball = l
        * (-alpha_right_arm_frame_2_by_q_right_ball)
            .mul_add(
                sin_q_right_ball,
                w_right_arm_frame_2_by_q_right_ball
                    * a_right_arm_frame_in_right_link_frame_3_by_theta_of_place,
            ) - a_right_arm_frame_in_right_link_frame_1;
    let a_right_link_centre_1_2_by_q_right_ball_of_place = w_right_arm_frame_in_right_link_frame_3
        .mul_add(
            w_right_arm_frame_in_right_link_frame_1_by_q_right_ball,
            alpha_right_link_frame_2_by_q_right_ball,
        );
    let a_right_link_centre_1_2_by_q_right_ball = l
        * w_right_arm_frame_in_right_link_frame_1
            .mul_add(
                w_right_arm_frame_in_right_link_frame_3_by_q_right_ball,
                a_right_link_centre_1_2_by_q_right_ball_of_place,
            ) - S::int(2) * a_right_arm_frame_in_right_link_frame_1_by_q_right_ball;
    let a_right_link_centre_3_2_by_q_right_ball = l_doubled
        * w_right_link_frame_2
            .mul_add(
                w_right_link_frame_2_by_q_right_ball,
                w_right_arm_frame_in_right_link_frame_1
                    * w_right_arm_frame_in_right_link_frame_1_by_q_right_ball,
            ) + S::int(2) * a_right_arm_frame_in_right_link_frame_3_by_q_right_ball;
    let F_w_right_link_frame_2_by_q_right_ball = mr_right_link_frame_3
        * l
            .mul_add(
                a_right_link_centre_1_2_by_q_right_ball_of_place,
                S::int(3) * a_right_link_centre_1_2_by_q_right_ball,
            ) + H_right_link_1 * w_right_arm_frame_in_right_link_frame_3_by_q_right_ball;
    let sin_q_right_ball_times_3 = S::int(3) * sin_q_right_ball;
    let F_w_right_arm_frame_2_by_q_right_ball = F_w_right_link_frame_2_by_q_right_ball
        + l_doubled
            * (F_v_right_arm_frame_in_right_link_frame_3 * cos_q_right_ball_times_3
                - alpha_right_arm_frame_2_by_q_right_ball * mb_l_times_6
                - F_v_right_link_centre_1 * sin_q_right_ball_times_3
                - m
                    * ((-a_right_link_centre_1_2_by_q_right_ball)
                        .mul_add(
                            cos_q_right_ball_times_3,
                            alpha_right_arm_frame_2_by_q_right_ball * l_doubled,
                        )
                        - a_right_link_centre_3_2_by_q_right_ball * sin_q_right_ball_times_3));
    let J_right_link_frame_in_right_arm_frame_2_by_q_right_ball = S::int(2)
        * J_right_link_frame_in_right_arm_frame_13_of_place;
    let J_right_link_frame_in_right_arm_frame_13_by_q_right_ball = J_right_link_frame_11_2
        .mul_add(cos_q_right_ball_sq, -J_right_link_frame_in_right_arm_frame_2);
    let rw_right_arm_frame_3_by_q_right_ball = -S::int(2) * rw_right_link_frame_3
        * sin_q_right_ball;
    let J_right_arm_frame_13_by_q_right_ball = rw_right_link_frame_3
        .mul_add(
            cos_q_right_ball_times_6, J_right_link_frame_in_right_arm_frame_13_by_q_right_ball,
        );
    let J_right_arm_frame_in_spindle_frame_by_q_right_ball = sin_q_right_top_doubled
        * (-rw_right_arm_frame_3_by_q_right_ball)
            .mul_add(S::int(3), J_right_link_frame_in_right_arm_frame_2_by_q_right_ball)
        - J_right_arm_frame_13_by_q_right_ball * cos_q_right_top_doubled;
    let d1_by_q_right_ball_of_place = J_right_arm_frame_in_spindle_frame_by_q_right_ball
        .mul_add(
            sin_q_right_top, -J_right_link_frame_in_right_arm_frame_2_by_q_right_ball,
        );
    let d1_by_q_right_ball = -S::ratio(1, 12) * d1_by_q_right_ball_of_place;
    let d2_by_q_right_ball_of_place = sin_q_right_ball_inv
        * w_right_arm_frame_in_right_link_frame_3_by_spin_of_place;
    let d2_by_q_right_ball_of_place_2 = sin_q_right_top - d2_by_q_right_ball_of_place;
    let d2_by_q_right_ball = d2_by_theta_of_place_4 * w_right_arm_frame_2_by_q_right_ball_of_place
        * (m
            * (-d2_by_q_right_ball_of_place)
                .mul_add(S::int(4), S::int(5) * sin_q_right_top)
            + mb_times_6 * d2_by_q_right_ball_of_place_2);
    let opening_dot_by_q_right_ball_of_place = cos_q_right_top * sin_q_left_ball;
    let opening_dot_by_q_right_ball_of_place_2 = F_w_right_link_frame_2_by_q_right_ball
        - F_w_right_arm_frame_2_by_q_right_ball;
    let opening_dot_by_q_right_ball = -d2_inv_d2_inv_by_12 * d2_by_q_left_ball_of_place
        * (d2 * opening_dot_by_q_right_ball_of_place
            * F_w_right_link_frame_2
                .mul_add(w_right_link_frame_2_of_q_right_ball, -F_w_right_arm_frame_2)
            + sin_q_right_ball
                * (d2_by_q_right_ball
                    * (sin_q_right_ball
                        * (opening_dot_by_q_right_top_of_place_7
                            + opening_dot_by_q_right_top_of_place_3 * sin_q_left_ball
                            + l_times_3
                                * (sin_theta
                                    * F_v_left_arm_centre_1
                                        .mul_add(
                                            sin_q_left_ball,
                                            S::int(2) * F_v_left_arm_frame_in_left_link_frame_3,
                                        ) - opening_dot_by_theta_of_place_5 * sin_q_left_ball
                                    + cos_q_left_ball
                                        * (-opening_dot_by_theta_of_place_7)
                                            .mul_add(
                                                cos_theta,
                                                sin_theta_doubled * opening_dot_by_q_left_ball_of_place_3,
                                            )))
                        + opening_dot_by_q_right_top_of_place_5
                            * opening_dot_by_q_right_ball_of_place)
                    + d2 * sin_q_left_ball
                        * (-cos_q_right_top
                            * opening_dot_by_q_right_ball_of_place_2
                                .mul_add(
                                    cos_q_right_ball, F_w_right_link_frame_2_by_q_right_ball,
                                )
                            + w_right_link_frame_2_of_place_2
                                * opening_dot_by_q_right_ball_of_place_2)));
    let spin_dot_by_q_right_ball = d1_inv_by_12
        * ((-F_w_spindle_frame_in_right_arm_frame_1_by_q_right_ball)
            .mul_add(
                sin_q_right_top,
                F_w_spindle_frame_in_right_arm_frame_3_by_q_right_ball * cos_q_right_top,
            ) - d1_by_q_right_ball * spin_dot_by_theta_of_place);
    let w_left_arm_frame_in_left_link_frame_1_by_spin = w_left_arm_frame_in_left_link_frame_3_by_theta_of_place_3;
    let w_left_arm_frame_in_left_link_frame_3_by_spin = -d2_of_place_3;
    let w_right_arm_frame_in_right_link_frame_1_by_spin = w_right_arm_frame_in_right_link_frame_3_by_q_right_top_of_place_2;
    let alpha_right_arm_frame_1_by_spin = w_right_arm_frame_2 * cos_q_right_top;
    let alpha_left_arm_frame_in_left_link_frame_1_by_spin = opening * d2_of_place_3;
    let alpha_left_link_frame_1_by_spin = w_left_arm_frame_in_left_link_frame_3_by_spin
        .mul_add(
            w_left_link_frame_2_of_opening, alpha_left_arm_frame_in_left_link_frame_1_by_spin,
        );
    let alpha_right_arm_frame_in_right_link_frame_1_by_spin = alpha_right_arm_frame_in_right_link_frame_1_of_opening_2
        * d2_by_q_right_ball_of_place_2;
    let alpha_right_link_frame_1_by_spin = w_right_arm_frame_in_right_link_frame_3_by_spin
        .mul_add(
            w_right_link_frame_2_of_opening, alpha_right_arm_frame_in_right_link_frame_1_by_spin,
        );
    let H_left_arm_1_by_spin = rw_right_link_frame_3 * sin_theta;
    let a_right_arm_centre_2_by_spin = S::int(2) * l * alpha_right_arm_frame_1_by_spin;
    let H_right_arm_1_by_spin = rw_right_link_frame_3 * sin_q_right_top;
    let a_left_link_centre_2_by_spin = l
        * ((-w_left_link_frame_2)
            .mul_add(
                w_left_arm_frame_in_left_link_frame_3_by_spin, alpha_left_link_frame_1_by_spin,
            ) - S::int(4) * opening_cos_theta);
    let F_v_right_arm_centre_2_by_spin_of_place = w_right_link_frame_2
        * w_right_arm_frame_in_right_link_frame_3_by_spin;
    let F_v_right_arm_centre_2_by_spin = m
        * (-l_doubled
            * (alpha_right_link_frame_1_by_spin + F_v_right_arm_centre_2_by_spin_of_place)
            + S::int(5) * a_right_arm_centre_2_by_spin) + a_right_arm_centre_2_by_spin * mb_times_4;
    let F_v_left_arm_centre_2_by_spin = (-m)
        .mul_add(a_left_link_centre_2_by_spin, opening_cos_theta * l_m_plus_mb_times_4);
    let F_w_right_arm_frame_in_right_link_frame_1_by_spin = mr_right_link_frame_3
        * (l
            * F_v_right_arm_centre_2_by_spin_of_place
                .mul_add(S::int(3), S::int(4) * alpha_right_link_frame_1_by_spin)
            - S::int(6) * a_right_arm_centre_2_by_spin)
        + H_right_link_2 * w_right_arm_frame_in_right_link_frame_3_by_spin;
    let F_w_left_arm_frame_in_left_link_frame_1_by_spin = -mr_right_link_frame_3
        * a_left_link_centre_2_by_spin
            .mul_add(S::int(3), l * alpha_left_link_frame_1_by_spin)
        + H_left_link_2 * w_left_arm_frame_in_left_link_frame_3_by_spin;
    let F_w_spindle_frame_in_right_arm_frame_3_by_spin = (-w_right_arm_frame_2)
        .mul_add(H_right_arm_1_by_spin, H_right_arm_2 * sin_q_right_top)
        + F_w_right_arm_frame_in_right_link_frame_1_by_spin * sin_q_right_ball;
    let F_w_spindle_frame_in_right_arm_frame_1_by_spin_of_place = w_right_arm_frame_in_right_link_frame_1_by_spin
        * sin_q_right_ball;
    let F_w_spindle_frame_in_right_arm_frame_1_by_spin = H_right_arm_2 * cos_q_right_top
        - F_w_right_arm_frame_in_right_link_frame_1_by_spin * cos_q_right_ball
        - H_right_link_2 * F_w_spindle_frame_in_right_arm_frame_1_by_spin_of_place
        + l
            * (mr_right_link_frame_3
                * w_right_link_frame_2
                    .mul_add(
                        F_w_spindle_frame_in_right_arm_frame_1_by_spin_of_place,
                        alpha_right_arm_frame_1_by_spin,
                    ) + S::int(3) * F_v_right_arm_centre_2_by_spin);
    let F_w_spindle_frame_in_left_arm_frame_3_by_spin = (-opening)
        .mul_add(H_left_arm_1_by_spin, H_left_arm_2 * sin_theta)
        - F_w_left_arm_frame_in_left_link_frame_1_by_spin * sin_q_left_ball;
    let F_w_spindle_frame_in_left_arm_frame_1_by_spin_of_place = w_left_arm_frame_in_left_link_frame_1_by_spin
        * sin_q_left_ball;
    let F_w_spindle_frame_in_left_arm_frame_1_by_spin = H_left_arm_2 * cos_theta
        + F_w_left_arm_frame_in_left_link_frame_1_by_spin * cos_q_left_ball
        + H_left_link_2 * F_w_spindle_frame_in_left_arm_frame_1_by_spin_of_place
        + l
            * (mr_right_link_frame_3
                * (-w_left_link_frame_2)
                    .mul_add(
                        F_w_spindle_frame_in_left_arm_frame_1_by_spin_of_place, opening_cos_theta,
                    ) + S::int(6) * F_v_left_arm_centre_2_by_spin);
    let w_left_arm_frame_13_by_spin = w_spindle_frame_in_left_arm_frame_3
        .mul_add(sin_theta, w_spindle_frame_in_left_arm_frame_1 * cos_theta);
    let w_right_arm_frame_13_by_spin = w_spindle_frame_in_right_arm_frame_3
        .mul_add(
            sin_q_right_top,
            w_spindle_frame_in_right_arm_frame_1 * cos_q_right_top,
        );
    let a_left_link_centre_3_by_spin = l_doubled * w_left_arm_frame_13_by_theta_of_place;
    let a_left_arm_frame_in_left_link_frame_1_by_spin_of_place = l * w_left_arm_frame_13_by_spin;
    let a_left_arm_frame_in_left_link_frame_1_by_spin = (-a_left_arm_frame_in_left_link_frame_1_by_spin_of_place)
        .mul_add(cos_q_left_ball, a_left_link_centre_3_by_spin * sin_q_left_ball);
    let a_left_arm_frame_in_left_link_frame_3_by_spin = a_left_arm_frame_in_left_link_frame_1_by_spin_of_place
        .mul_add(sin_q_left_ball, a_left_link_centre_3_by_spin * cos_q_left_ball);
    let a_right_link_centre_3_by_spin = l_doubled * w_right_arm_frame_13_by_q_right_top_of_place;
    let a_right_arm_frame_in_right_link_frame_1_by_spin_of_place = l * w_right_arm_frame_13_by_spin;
    let a_right_arm_frame_in_right_link_frame_1_by_spin = (-a_right_arm_frame_in_right_link_frame_1_by_spin_of_place)
        .mul_add(cos_q_right_ball, a_right_link_centre_3_by_spin * sin_q_right_ball);
    let a_right_arm_frame_in_right_link_frame_3_by_spin = a_right_arm_frame_in_right_link_frame_1_by_spin_of_place
        .mul_add(sin_q_right_ball, a_right_link_centre_3_by_spin * cos_q_right_ball);
    let F_v_right_link_centre_1_by_spin_of_place = w_right_arm_frame_in_right_link_frame_3
        * w_right_arm_frame_in_right_link_frame_1_by_spin;
    let F_v_right_link_centre_1_by_spin = m
        * (l
            * w_right_arm_frame_in_right_link_frame_1
                .mul_add(
                    w_right_arm_frame_in_right_link_frame_3_by_spin,
                    F_v_right_link_centre_1_by_spin_of_place,
                ) - S::int(2) * a_right_arm_frame_in_right_link_frame_1_by_spin);
    let F_v_left_link_centre_1_by_spin_of_place = w_left_arm_frame_in_left_link_frame_3
        * w_left_arm_frame_in_left_link_frame_1_by_spin;
    let F_v_left_link_centre_1_by_spin = m
        * (l
            * w_left_arm_frame_in_left_link_frame_1
                .mul_add(
                    w_left_arm_frame_in_left_link_frame_3_by_spin,
                    F_v_left_link_centre_1_by_spin_of_place,
                ) - S::int(2) * a_left_arm_frame_in_left_link_frame_1_by_spin);
    let F_w_right_link_frame_2_by_spin = l
        * mr_right_link_frame_3
            .mul_add(
                F_v_right_link_centre_1_by_spin_of_place,
                S::int(3) * F_v_right_link_centre_1_by_spin,
            ) + H_right_link_1 * w_right_arm_frame_in_right_link_frame_3_by_spin;
    let F_w_left_link_frame_2_by_spin = l
        * mr_right_link_frame_3
            .mul_add(
                F_v_left_link_centre_1_by_spin_of_place,
                S::int(3) * F_v_left_link_centre_1_by_spin,
            ) + H_left_link_1 * w_left_arm_frame_in_left_link_frame_3_by_spin;
    let F_w_right_arm_frame_2_by_spin = H_right_arm_1 * cos_q_right_top
        + w_spindle_frame_in_right_arm_frame_3 * H_right_arm_1_by_spin
        + S::int(12) * s_right_link_frame_in_right_arm_frame_1
            * (l * w_right_arm_frame_in_right_link_frame_1)
                .mul_add(
                    w_right_arm_frame_in_right_link_frame_1_by_spin,
                    a_right_arm_frame_in_right_link_frame_3_by_spin,
                ) + F_w_right_link_frame_2_by_spin
        + F_v_right_link_centre_1_by_spin * l_times_6 * cos_q_right_ball
        + w_right_arm_frame_13_by_spin * l_times_3 * l_m_plus_mb_times_4;
    let opening_dot_by_spin = d2_inv_by_12
        * (H_left_arm_1 * cos_theta + w_spindle_frame_in_left_arm_frame_3 * H_left_arm_1_by_spin
            + w_right_arm_frame_2_of_place
                * (sin_q_left_ball
                    * (sin_q_right_ball_inv
                        * (-F_w_right_link_frame_2_by_spin)
                            .mul_add(
                                w_right_link_frame_2_of_place,
                                F_w_right_arm_frame_2_by_spin * cos_angle,
                            ) + F_w_right_link_frame_2_by_spin * sin_q_right_top)
                    - F_w_left_link_frame_2_by_spin * cos_theta)
            + l_times_3
                * (m_times_4 * sin_q_left_ball
                    * (l * w_left_arm_frame_in_left_link_frame_1)
                        .mul_add(
                            w_left_arm_frame_in_left_link_frame_1_by_spin,
                            a_left_arm_frame_in_left_link_frame_3_by_spin,
                        ) + F_v_left_link_centre_1_by_spin * cos_q_left_ball_doubled
                    + w_left_arm_frame_13_by_spin * l_m_plus_mb_times_4));
    let spin_dot_by_spin = d1_inv_by_12
        * ((-F_w_spindle_frame_in_right_arm_frame_1_by_spin)
            .mul_add(
                sin_q_right_top,
                F_w_spindle_frame_in_right_arm_frame_3_by_spin * cos_q_right_top,
            ) + F_w_spindle_frame_in_left_arm_frame_3_by_spin * cos_theta
            - F_w_spindle_frame_in_left_arm_frame_1_by_spin * sin_theta);
    let w_right_arm_frame_2_by_opening = w_right_arm_frame_2_of_place
        * alpha_right_link_frame_2_by_theta_of_place_5;
    let w_left_link_frame_2_by_opening = -a_sleeve_centre_3_by_theta_of_place;
    let w_right_link_frame_2_by_opening_of_place = w_right_arm_frame_2_of_place
        * w_right_arm_frame_2_of_place_2 * w_right_link_frame_2_of_place_3;
    let w_right_link_frame_2_by_opening = w_right_link_frame_2_by_opening_of_place
        - w_right_arm_frame_2_by_opening;
    let alpha_right_arm_frame_1_by_opening = w_spindle_frame_in_right_arm_frame_3
        * w_right_arm_frame_2_by_opening;
    let alpha_left_link_frame_1_by_opening_of_place = w_right_arm_frame_2_of_place
        * w_left_link_frame_2_of_place;
    let alpha_left_link_frame_1_by_opening = w_left_arm_frame_in_left_link_frame_3
        .mul_add(
            alpha_left_link_frame_1_by_opening_of_place,
            alpha_left_arm_frame_in_left_link_frame_1_by_opening,
        );
    let alpha_right_arm_frame_in_right_link_frame_1_by_opening = w_right_arm_frame_2_of_place
        * alpha_right_arm_frame_in_right_link_frame_1_by_theta_of_place
        * alpha_right_arm_frame_2_by_q_left_ball_of_place_4;
    let alpha_right_link_frame_1_by_opening = w_right_arm_frame_in_right_link_frame_3
        .mul_add(
            w_right_link_frame_2_by_opening_of_place,
            alpha_right_arm_frame_in_right_link_frame_1_by_opening,
        );
    let a_right_link_centre_2_by_opening_of_place = S::int(2) * alpha_right_arm_frame_1_by_opening;
    let a_right_link_centre_2_by_opening_of_place_2 = l
        * w_right_arm_frame_in_right_link_frame_3
            .mul_add(
                w_right_link_frame_2_by_opening, alpha_right_link_frame_1_by_opening,
            );
    let a_right_link_centre_2_by_opening = (-l_doubled)
        .mul_add(
            a_right_link_centre_2_by_opening_of_place, a_right_link_centre_2_by_opening_of_place_2,
        );
    let F_v_right_arm_centre_2_by_opening = (-a_right_link_centre_2_by_opening)
        .mul_add(
            m_doubled,
            l * m_plus_mb_times_4 * a_right_link_centre_2_by_opening_of_place,
        );
    let F_v_left_arm_centre_2_by_opening_of_place = w_left_arm_frame_in_left_link_frame_3
        .mul_add(w_left_link_frame_2_by_opening, -alpha_left_link_frame_1_by_opening);
    let F_v_left_arm_centre_2_by_opening = l
        * (m
            * w_spindle_frame_in_left_arm_frame_3
                .mul_add(S::int(5), F_v_left_arm_centre_2_by_opening_of_place)
            + w_spindle_frame_in_left_arm_frame_3 * mb_times_4);
    let F_w_right_arm_frame_in_right_link_frame_1_by_opening = mr_right_link_frame_3
        * a_right_link_centre_2_by_opening
            .mul_add(S::int(3), a_right_link_centre_2_by_opening_of_place_2);
    let F_w_left_arm_frame_in_left_link_frame_1_by_opening = S::int(4) * rw_right_link_frame_3
        * w_spindle_frame_in_left_arm_frame_3
            .mul_add(S::int(3), F_v_left_arm_centre_2_by_opening_of_place);
    let F_w_spindle_frame_in_right_arm_frame_3_by_opening = F_w_right_arm_frame_in_right_link_frame_1_by_opening
        * sin_q_right_ball - H_right_arm_1 * w_right_arm_frame_2_by_opening
        + rw_right_link_frame_3
            * (-w_right_link_frame_2_by_opening)
                .mul_add(
                    F_w_spindle_frame_in_right_arm_frame_3_by_theta_of_place,
                    w_spindle_frame_in_right_arm_frame_1 * w_right_arm_frame_2_by_opening,
                )
        + w_right_link_frame_2_by_opening
            * F_w_spindle_frame_in_right_arm_frame_3_by_theta_of_place_2;
    let F_w_spindle_frame_in_right_arm_frame_1_by_opening = w_right_link_frame_2_by_opening
        * F_w_spindle_frame_in_right_arm_frame_1_by_theta_of_place_2
        - F_w_right_arm_frame_in_right_link_frame_1_by_opening * cos_q_right_ball
        + l
            * (mr_right_link_frame_3
                * (-w_right_link_frame_2_by_opening)
                    .mul_add(
                        F_w_spindle_frame_in_right_arm_frame_1_by_theta_of_place,
                        a_right_link_centre_2_by_opening_of_place,
                    ) + S::int(3) * F_v_right_arm_centre_2_by_opening);
    let F_w_spindle_frame_in_left_arm_frame_3_by_opening_of_place = w_left_link_frame_2_by_opening
        * cos_q_left_ball;
    let F_w_spindle_frame_in_left_arm_frame_3_by_opening = rw_right_link_frame_3
        * w_left_arm_frame_in_left_link_frame_1
            .mul_add(
                F_w_spindle_frame_in_left_arm_frame_3_by_opening_of_place,
                w_spindle_frame_in_left_arm_frame_1,
            ) - H_left_arm_1 - F_w_left_arm_frame_in_left_link_frame_1_by_opening * sin_q_left_ball
        - H_left_link_1 * F_w_spindle_frame_in_left_arm_frame_3_by_opening_of_place;
    let F_w_spindle_frame_in_left_arm_frame_1_by_opening_of_place = w_left_link_frame_2_by_opening
        * sin_q_left_ball;
    let F_w_spindle_frame_in_left_arm_frame_1_by_opening = F_w_left_arm_frame_in_left_link_frame_1_by_opening
        * cos_q_left_ball
        - H_left_link_1 * F_w_spindle_frame_in_left_arm_frame_1_by_opening_of_place
        + l
            * (mr_right_link_frame_3
                * w_left_arm_frame_in_left_link_frame_1
                    .mul_add(
                        F_w_spindle_frame_in_left_arm_frame_1_by_opening_of_place,
                        S::int(2) * w_spindle_frame_in_left_arm_frame_3,
                    ) + S::int(6) * F_v_left_arm_centre_2_by_opening);
    let alpha_right_arm_frame_2_by_opening = -S::int(2) * alpha_right_arm_frame_2_of_opening_3
        * (alpha_right_arm_frame_2_of_place_3
            + w_right_arm_frame_2_of_place
                * (-sin_q_left_ball
                    * (-alpha_right_arm_frame_2_by_theta_of_place)
                        .mul_add(
                            cos_angle,
                            alpha_right_arm_frame_2_by_theta_of_place_9 * sin_q_left_ball,
                        ) + d2_of_place_2 * cos_angle));
    let alpha_left_link_frame_2_by_opening_of_opening = S::int(2) * w_right_arm_frame_2_of_opening;
    let alpha_left_link_frame_2_by_opening = -alpha_left_link_frame_2_by_opening_of_opening
        * alpha_right_arm_frame_2_by_theta_of_place
            .mul_add(a_sleeve_centre_3_by_theta_of_place, sin_theta);
    let alpha_right_link_frame_2_by_opening = alpha_left_link_frame_2_by_opening_of_opening
        * (alpha_right_link_frame_2_by_theta_of_place_8
            + w_right_arm_frame_2_of_place
                * (-sin_q_right_ball_inv
                    * (cos_q_right_top
                        * (sin_q_left_ball
                            * alpha_right_link_frame_2_by_theta_of_place_3
                                .mul_add(
                                    sin_q_left_ball,
                                    w_right_link_frame_2_of_q_right_ball
                                        * alpha_right_arm_frame_2_by_theta_of_place,
                                ) + w_right_link_frame_2_of_q_right_ball * d2_of_place_2)
                        + alpha_right_link_frame_2_by_theta_of_place_6 * sin_q_left_ball)
                    + w_right_arm_frame_2_by_q_left_ball_of_place * cos_theta
                        * sin_q_right_top)) - alpha_right_arm_frame_2_by_opening;
    let a_left_arm_frame_in_left_link_frame_1_by_opening = opening_sin_q_left_ball * l_doubled;
    let opening_l_doubled = opening * l_doubled;
    let a_left_arm_frame_in_left_link_frame_3_by_opening = opening_l_doubled * cos_q_left_ball;
    let a_right_arm_frame_in_right_link_frame_1_by_opening = l
        * w_right_arm_frame_2_by_opening
            .mul_add(
                a_right_arm_frame_in_right_link_frame_1_by_theta_of_place_2,
                alpha_right_arm_frame_2_by_opening * cos_q_right_ball,
            );
    let a_right_arm_frame_in_right_link_frame_3_by_opening = l
        * (-alpha_right_arm_frame_2_by_opening)
            .mul_add(
                sin_q_right_ball,
                w_right_arm_frame_2_by_opening
                    * a_right_arm_frame_in_right_link_frame_3_by_theta_of_place,
            );
    let a_sleeve_centre_3_by_opening = opening_l_doubled
        * (alpha_left_link_frame_2_by_theta_of_place_2
            + cos_theta
                * a_sleeve_centre_3_by_theta_of_place
                    .mul_add(a_sleeve_centre_3_by_theta_of_place_3, S::int(1)));
    let F_w_right_link_frame_2_by_opening = F_w_right_link_frame_2_by_theta_of_place
        * (-a_right_arm_frame_in_right_link_frame_1_by_opening)
            .mul_add(S::int(3), alpha_right_link_frame_2_by_opening * l_doubled);
    let F_w_left_link_frame_2_by_opening = F_w_right_link_frame_2_by_theta_of_place
        * (-a_left_arm_frame_in_left_link_frame_1_by_opening)
            .mul_add(S::int(3), alpha_left_link_frame_2_by_opening * l_doubled);
    let F_w_right_arm_frame_2_by_opening = F_w_right_link_frame_2_by_opening
        - l_doubled
            * (m
                * (l
                    * ((-alpha_right_link_frame_2_by_opening)
                        .mul_add(
                            cos_q_right_ball_times_3,
                            S::int(2) * alpha_right_arm_frame_2_by_opening,
                        )
                        - w_right_link_frame_2_by_opening * F_w_right_arm_frame_2_by_theta_of_place)
                    - a_right_arm_frame_in_right_link_frame_3_by_opening * sin_q_right_ball_times_6
                    + a_right_arm_frame_in_right_link_frame_1_by_opening * cos_q_right_ball_times_6)
                + alpha_right_arm_frame_2_by_opening * mb_l_times_6);
    let opening_dot_by_opening_of_place = ms * a_sleeve_centre_3_by_opening;
    let opening_dot_by_opening = d2_inv_by_12
        * (w_right_arm_frame_2_of_place
            * (sin_q_left_ball
                * (sin_q_right_ball_inv
                    * (-F_w_right_link_frame_2_by_opening)
                        .mul_add(
                            w_right_link_frame_2_of_place,
                            F_w_right_arm_frame_2_by_opening * cos_angle,
                        ) + F_w_right_link_frame_2_by_opening * sin_q_right_top)
                + cos_theta
                    * opening_dot_by_theta_of_place
                        .mul_add(
                            opening_dot_by_opening_of_place, -F_w_left_link_frame_2_by_opening,
                        ))
            + l_times_6
                * (m * sin_q_left_ball_doubled
                    * (l * w_left_link_frame_2)
                        .mul_add(
                            w_left_link_frame_2_by_opening,
                            a_left_arm_frame_in_left_link_frame_3_by_opening,
                        )
                    + m_cos_q_left_ball
                        * (-a_left_arm_frame_in_left_link_frame_1_by_opening)
                            .mul_add(S::int(2), l * alpha_left_link_frame_2_by_opening)
                    - sin_theta_doubled * opening_dot_by_opening_of_place));
    let spin_dot_by_opening = d1_inv_by_12
        * ((-F_w_spindle_frame_in_right_arm_frame_1_by_opening)
            .mul_add(
                sin_q_right_top,
                F_w_spindle_frame_in_right_arm_frame_3_by_opening * cos_q_right_top,
            ) + F_w_spindle_frame_in_left_arm_frame_3_by_opening * cos_theta
            - F_w_spindle_frame_in_left_arm_frame_1_by_opening * sin_theta);
    // Entries that are not zero.
    let psi_dot_by_spin_value = S::int(1);
    let theta_dot_by_opening_value = S::int(1);
    let q_right_top_dot_by_theta_value = w_right_arm_frame_2_by_theta;
    let q_right_top_dot_by_q_right_top_value = w_right_arm_frame_2_by_q_right_top_of_opening;
    let q_right_top_dot_by_q_left_ball_value = w_right_arm_frame_2_by_q_left_ball;
    let q_right_top_dot_by_q_right_ball_value = w_right_arm_frame_2_by_q_right_ball;
    let q_right_top_dot_by_opening_value = w_right_arm_frame_2_by_opening;
    let q_left_ball_dot_by_theta_value = w_left_link_frame_2_by_theta_of_opening_2;
    let q_left_ball_dot_by_q_left_ball_value = w_left_link_frame_2_by_q_left_ball_of_opening_2;
    let q_left_ball_dot_by_opening_value = -alpha_left_link_frame_1_by_opening_of_place;
    let q_right_ball_dot_by_theta_value = -w_right_link_frame_2_by_theta_of_opening;
    let q_right_ball_dot_by_q_right_top_value = w_right_link_frame_2_by_q_right_top_of_opening;
    let q_right_ball_dot_by_q_left_ball_value = -w_right_link_frame_2_of_place_3
        * opening_cos_theta * d2_of_place_3_inv * d2_by_theta_of_place_3;
    let q_right_ball_dot_by_q_right_ball_value = w_right_link_frame_2_by_q_right_ball_of_opening;
    let q_right_ball_dot_by_opening_value = -w_right_link_frame_2_by_opening_of_place;
    let zero = S::int(0);
    [
        [zero, zero, zero, zero, zero, psi_dot_by_spin_value, zero],
        [zero, zero, zero, zero, zero, zero, theta_dot_by_opening_value],
        [
            zero, q_right_top_dot_by_theta_value, q_right_top_dot_by_q_right_top_value,
            q_right_top_dot_by_q_left_ball_value, q_right_top_dot_by_q_right_ball_value, zero,
            q_right_top_dot_by_opening_value,
        ],
        [
            zero, q_left_ball_dot_by_theta_value, zero, q_left_ball_dot_by_q_left_ball_value, zero,
            zero, q_left_ball_dot_by_opening_value,
        ],
        [
            zero, q_right_ball_dot_by_theta_value, q_right_ball_dot_by_q_right_top_value,
            q_right_ball_dot_by_q_left_ball_value, q_right_ball_dot_by_q_right_ball_value, zero,
            q_right_ball_dot_by_opening_value,
        ],
        [
            zero, spin_dot_by_theta, spin_dot_by_q_right_top, spin_dot_by_q_left_ball,
            spin_dot_by_q_right_ball, spin_dot_by_spin, spin_dot_by_opening,
        ],
        [
            zero, opening_dot_by_theta, opening_dot_by_q_right_top, opening_dot_by_q_left_ball,
            opening_dot_by_q_right_ball, opening_dot_by_spin, opening_dot_by_opening,
        ],
    ]
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

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 160 convolutions and 348 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 7]],
    history: &mut [Factors<S, 160>],
) {
    let Parameters { l, m, mb, ms, J, Js, g } = *p;
    let [_, theta_0, q_right_top_0, q_left_ball_0, q_right_ball_0, spin_0, opening_0] = series[0];
    // Step by step, each after the terms that it needs.
    let l_sq_m = l * l * m;
    let l_m = l * m;
    let l_mb = l * mb;
    let weight_2_of_l_m_mb = l * l_mb.mul_add(S::int(4), l_m);
    // Constant in time.
    // minus_4_l = -4*l
    let minus_4_l = -S::int(4) * l;
    // minus_l = -l
    let minus_l = -l;
    // minus_2_l = -2*l
    let minus_2_l = -S::int(2) * l;
    // l_2_m = l^2*m
    let l_2_m = l_sq_m;
    // minus_l_2_m = -l^2*m
    let minus_l_2_m = -l_sq_m;
    // weight = 3*l*m
    let weight = S::int(3) * l_m;
    // minus_3_l_m = -3*l*m
    let minus_3_l_m = -S::int(3) * l_m;
    // minus_6_l_m = -6*l*m
    let minus_6_l_m = -S::int(6) * l_m;
    // weight_2 = 3*l*(l*m + 4*l*mb)
    let weight_2 = S::int(3) * weight_2_of_l_m_mb;
    // weight_3 = l^2*m + 6*l*(l*m + 4*l*mb)
    let weight_3 = weight_2_of_l_m_mb.mul_add(S::int(6), l_sq_m);
    // minus_g = -g
    let minus_g = -g;
    // weight_4 = 6*l*m
    let weight_4 = S::int(6) * l_m;
    // minus_6_l_m_g = -6*l*m*g
    let minus_6_l_m_g = -S::int(6) * l * m * g;
    // minus_3_l_2_m = -3*l^2*m
    let minus_3_l_2_m = -S::int(3) * l_sq_m;
    // minus_12_l_mb = -12*l*mb
    let minus_12_l_mb = -S::int(12) * l_mb;
    // weight_5 = 4*l^2*m
    let weight_5 = S::int(4) * l_sq_m;
    // weight_6 = 6*l^2*m
    let weight_6 = S::int(6) * l_sq_m;
    // weight_7 = -8*l^2*m - 12*l^2*(m + mb)
    let weight_7 = -S::int(12) * l * l * (m + mb) - S::int(8) * l_sq_m;
    // weight_8 = 8*l^2*m
    let weight_8 = S::int(8) * l_sq_m;
    // minus_12_l_2_m = -12*l^2*m
    let minus_12_l_2_m = -S::int(12) * l_sq_m;
    // weight_9 = 12*J + 12*Js
    let weight_9 = Js.mul_add(S::int(12), S::int(12) * J);
    // minus_5_m_minus_6_mb = -5*m - 6*mb
    let minus_5_m_minus_6_mb = (-mb).mul_add(S::int(6), -S::int(5) * m);
    // weight_10 = 2*m + 3*mb
    let weight_10 = mb.mul_add(S::int(3), S::int(2) * m);
    // weight_11 = 8*m + 6*mb + 3*ms
    let weight_11 = mb.mul_add(S::int(6), S::int(8) * m) + S::int(3) * ms;
    // minus_12_l_ms = -12*l*ms
    let minus_12_l_ms = -S::int(12) * l * ms;
    // weight_12 = 3*l^2*m
    let weight_12 = S::int(3) * l_sq_m;
    // weight_13 = 12*l*mb
    let weight_13 = S::int(12) * l_mb;
    // weight_14 = 1/(4*l^2)
    let weight_14 = S::ratio(1, 4) / (l * l);
    // Order 0.
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    let spin_sin_theta_0 = spin_0 * sin_theta_0;
    let spin_cos_theta_0 = spin_0 * cos_theta_0;
    let (sin_q_right_top_0, cos_q_right_top_0) = q_right_top_0.sin_cos();
    let spin_sin_q_right_top_0 = spin_0 * sin_q_right_top_0;
    let spin_cos_q_right_top_0 = spin_0 * cos_q_right_top_0;
    let theta_plus_q_left_ball_0 = theta_0 + q_left_ball_0;
    let (sin_theta_plus_q_left_ball_0, cos_theta_plus_q_left_ball_0) = theta_plus_q_left_ball_0
        .sin_cos();
    let over_cos_theta_plus_q_left_ball = S::int(1) / cos_theta_plus_q_left_ball_0;
    let (sin_q_left_ball_0, cos_q_left_ball_0) = q_left_ball_0.sin_cos();
    let w_right_arm_frame_2_of_place_0 = q_right_top_0 + q_right_ball_0;
    let (sin_angle_0, cos_angle_0) = w_right_arm_frame_2_of_place_0.sin_cos();
    let (sin_q_right_ball_0, cos_q_right_ball_0) = q_right_ball_0.sin_cos();
    let over_sin_q_right_ball = S::int(1) / sin_q_right_ball_0;
    let w_right_arm_frame_2_of_opening_0 = opening_0 * over_cos_theta_plus_q_left_ball;
    let w_right_arm_frame_2_of_opening_2_0 = sin_q_left_ball_0 * w_right_arm_frame_2_of_opening_0;
    let w_right_arm_frame_2_of_opening_3_0 = w_right_arm_frame_2_of_opening_2_0
        * over_sin_q_right_ball;
    let q_right_top_dot_2_0 = cos_angle_0 * w_right_arm_frame_2_of_opening_3_0;
    let w_left_arm_frame_in_left_link_frame_1_of_spin_0 = sin_q_left_ball_0 * spin_cos_theta_0;
    let w_left_arm_frame_in_left_link_frame_1_of_spin_2_0 = cos_q_left_ball_0 * spin_sin_theta_0;
    let w_left_arm_frame_in_left_link_frame_1_of_place_0 = w_left_arm_frame_in_left_link_frame_1_of_spin_0
        + w_left_arm_frame_in_left_link_frame_1_of_spin_2_0;
    let w_left_arm_frame_in_left_link_frame_3_of_spin_0 = cos_q_left_ball_0 * spin_cos_theta_0;
    let w_left_arm_frame_in_left_link_frame_3_of_spin_2_0 = sin_q_left_ball_0 * spin_sin_theta_0;
    let w_left_arm_frame_in_left_link_frame_3_of_place_0 = w_left_arm_frame_in_left_link_frame_3_of_spin_0
        - w_left_arm_frame_in_left_link_frame_3_of_spin_2_0;
    let w_left_link_frame_2_of_place_0 = cos_theta_0 + cos_theta_plus_q_left_ball_0;
    let w_left_link_frame_2_of_opening_0 = w_left_link_frame_2_of_place_0
        * w_right_arm_frame_2_of_opening_0;
    let w_left_link_frame_2_of_opening_2_0 = opening_0 - w_left_link_frame_2_of_opening_0;
    let w_right_arm_frame_in_right_link_frame_1_of_spin_0 = sin_q_right_ball_0
        * spin_cos_q_right_top_0;
    let w_right_arm_frame_in_right_link_frame_1_of_spin_2_0 = cos_q_right_ball_0
        * spin_sin_q_right_top_0;
    let w_right_arm_frame_in_right_link_frame_1_of_place_0 = w_right_arm_frame_in_right_link_frame_1_of_spin_0
        + w_right_arm_frame_in_right_link_frame_1_of_spin_2_0;
    let w_right_arm_frame_in_right_link_frame_3_of_spin_0 = cos_q_right_ball_0
        * spin_cos_q_right_top_0;
    let w_right_arm_frame_in_right_link_frame_3_of_spin_2_0 = sin_q_right_ball_0
        * spin_sin_q_right_top_0;
    let w_right_arm_frame_in_right_link_frame_3_of_place_0 = w_right_arm_frame_in_right_link_frame_3_of_spin_0
        - w_right_arm_frame_in_right_link_frame_3_of_spin_2_0;
    let w_right_link_frame_2_of_q_right_ball_0 = S::int(1) + cos_q_right_ball_0;
    let w_right_link_frame_2_of_place_0 = cos_q_right_top_0
        * w_right_link_frame_2_of_q_right_ball_0;
    let w_right_link_frame_2_of_place_2_0 = sin_q_right_top_0 * sin_q_right_ball_0;
    let w_right_link_frame_2_of_place_3_0 = -w_right_link_frame_2_of_place_2_0
        + w_right_link_frame_2_of_place_0;
    let w_right_link_frame_2_of_opening_0 = w_right_link_frame_2_of_place_3_0
        * w_right_arm_frame_2_of_opening_3_0;
    let w_right_link_frame_2_of_opening_2_0 = w_right_link_frame_2_of_opening_0
        - q_right_top_dot_2_0;
    let spin_opening_cos_theta_0 = opening_0 * spin_cos_theta_0;
    let alpha_right_arm_frame_1_of_spin_opening_0 = spin_cos_q_right_top_0 * q_right_top_dot_2_0;
    let w_right_arm_frame_23_of_spin_opening_0 = spin_cos_q_right_top_0 * q_right_top_dot_2_0;
    let turn_right_arm_frame_23_of_place_0 = alpha_right_arm_frame_1_of_spin_opening_0
        + w_right_arm_frame_23_of_spin_opening_0;
    let alpha_left_arm_frame_in_left_link_frame_1_of_spin_opening_0 = opening_0
        * w_left_arm_frame_in_left_link_frame_3_of_spin_2_0;
    let alpha_left_arm_frame_in_left_link_frame_1_of_spin_opening_2_0 = opening_0
        * w_left_arm_frame_in_left_link_frame_3_of_spin_0;
    let alpha_left_link_frame_1_of_opening_0 = w_left_arm_frame_in_left_link_frame_3_of_place_0
        * w_left_link_frame_2_of_opening_0;
    let alpha_left_link_frame_1_of_opening_2_0 = alpha_left_arm_frame_in_left_link_frame_1_of_spin_opening_0
        - alpha_left_arm_frame_in_left_link_frame_1_of_spin_opening_2_0
        + alpha_left_link_frame_1_of_opening_0;
    let w_left_link_frame_23_of_opening_0 = w_left_arm_frame_in_left_link_frame_3_of_place_0
        * w_left_link_frame_2_of_opening_2_0;
    let alpha_right_arm_frame_in_right_link_frame_1_of_spin_0 = cos_angle_0
        * spin_sin_q_right_top_0;
    let alpha_right_arm_frame_in_right_link_frame_1_of_spin_opening_0 = w_right_arm_frame_2_of_opening_2_0
        * alpha_right_arm_frame_in_right_link_frame_1_of_spin_0;
    let alpha_right_arm_frame_in_right_link_frame_1_of_spin_opening_2_0 = q_right_top_dot_2_0
        * w_right_arm_frame_in_right_link_frame_3_of_spin_0;
    let alpha_right_link_frame_1_of_opening_0 = w_right_arm_frame_in_right_link_frame_3_of_place_0
        * w_right_link_frame_2_of_opening_0;
    let alpha_right_link_frame_1_of_opening_2_0 = alpha_right_arm_frame_in_right_link_frame_1_of_spin_opening_0
        + alpha_right_link_frame_1_of_opening_0
        - alpha_right_arm_frame_in_right_link_frame_1_of_spin_opening_2_0;
    let w_right_link_frame_23_of_opening_0 = w_right_arm_frame_in_right_link_frame_3_of_place_0
        * w_right_link_frame_2_of_opening_2_0;
    let a_left_link_centre_2_of_place_0 = w_left_link_frame_23_of_opening_0
        .mul_add(
            minus_l,
            alpha_left_link_frame_1_of_opening_2_0
                .mul_add(l, minus_4_l * spin_opening_cos_theta_0),
        );
    let a_right_link_centre_2_of_place_0 = w_right_link_frame_23_of_opening_0
        .mul_add(
            l,
            alpha_right_link_frame_1_of_opening_2_0
                .mul_add(l, minus_2_l * turn_right_arm_frame_23_of_place_0),
        );
    let F_w_right_arm_frame_in_right_link_frame_3_of_opening_0 = w_right_arm_frame_in_right_link_frame_1_of_place_0
        * w_right_link_frame_2_of_opening_2_0;
    let F_w_right_arm_frame_in_right_link_frame_3_of_opening_2_0 = w_right_link_frame_2_of_opening_2_0
        * w_right_arm_frame_in_right_link_frame_1_of_place_0;
    let F_w_right_arm_frame_in_right_link_frame_3_of_place_0 = F_w_right_arm_frame_in_right_link_frame_3_of_opening_2_0
        .mul_add(
            minus_l_2_m,
            l_2_m * F_w_right_arm_frame_in_right_link_frame_3_of_opening_0,
        );
    let F_w_right_arm_frame_in_right_link_frame_1_of_opening_0 = w_right_arm_frame_in_right_link_frame_3_of_place_0
        * w_right_link_frame_2_of_opening_2_0;
    let F_w_right_arm_frame_in_right_link_frame_1_of_place_0 = a_right_link_centre_2_of_place_0
        .mul_add(
            weight,
            alpha_right_link_frame_1_of_opening_2_0
                .mul_add(
                    l_2_m,
                    l_2_m * F_w_right_arm_frame_in_right_link_frame_1_of_opening_0,
                ),
        );
    let F_w_left_arm_frame_in_left_link_frame_3_of_opening_0 = w_left_arm_frame_in_left_link_frame_1_of_place_0
        * w_left_link_frame_2_of_opening_2_0;
    let F_w_left_arm_frame_in_left_link_frame_3_of_opening_2_0 = w_left_link_frame_2_of_opening_2_0
        * w_left_arm_frame_in_left_link_frame_1_of_place_0;
    let F_w_left_arm_frame_in_left_link_frame_3_of_place_0 = F_w_left_arm_frame_in_left_link_frame_3_of_opening_2_0
        .mul_add(
            minus_l_2_m,
            l_2_m * F_w_left_arm_frame_in_left_link_frame_3_of_opening_0,
        );
    let F_w_left_arm_frame_in_left_link_frame_1_of_opening_0 = w_left_arm_frame_in_left_link_frame_3_of_place_0
        * w_left_link_frame_2_of_opening_2_0;
    let F_w_left_arm_frame_in_left_link_frame_1_of_place_0 = a_left_link_centre_2_of_place_0
        .mul_add(
            minus_3_l_m,
            alpha_left_link_frame_1_of_opening_2_0
                .mul_add(
                    minus_l_2_m,
                    l_2_m * F_w_left_arm_frame_in_left_link_frame_1_of_opening_0,
                ),
        );
    let F_w_spindle_frame_in_right_arm_frame_3_of_spin_opening_0 = spin_sin_q_right_top_0
        * q_right_top_dot_2_0;
    let F_w_spindle_frame_in_right_arm_frame_3_of_spin_opening_2_0 = q_right_top_dot_2_0
        * spin_sin_q_right_top_0;
    let F_w_spindle_frame_in_right_arm_frame_3_of_place_0 = cos_q_right_ball_0
        * F_w_right_arm_frame_in_right_link_frame_3_of_place_0;
    let F_w_spindle_frame_in_right_arm_frame_3_of_place_2_0 = sin_q_right_ball_0
        * F_w_right_arm_frame_in_right_link_frame_1_of_place_0;
    let F_w_spindle_frame_in_right_arm_frame_3_of_place_3_0 = F_w_spindle_frame_in_right_arm_frame_3_of_spin_opening_2_0
        .mul_add(
            minus_l_2_m,
            l_2_m * F_w_spindle_frame_in_right_arm_frame_3_of_spin_opening_0,
        ) - F_w_spindle_frame_in_right_arm_frame_3_of_place_0
        + F_w_spindle_frame_in_right_arm_frame_3_of_place_2_0;
    let F_w_spindle_frame_in_right_arm_frame_1_of_spin_opening_0 = spin_cos_q_right_top_0
        * q_right_top_dot_2_0;
    let F_w_spindle_frame_in_right_arm_frame_1_of_place_0 = sin_q_right_ball_0
        * F_w_right_arm_frame_in_right_link_frame_3_of_place_0;
    let F_w_spindle_frame_in_right_arm_frame_1_of_place_2_0 = cos_q_right_ball_0
        * F_w_right_arm_frame_in_right_link_frame_1_of_place_0;
    let F_w_spindle_frame_in_right_arm_frame_1_of_place_3_0 = a_right_link_centre_2_of_place_0
        .mul_add(
            minus_6_l_m,
            turn_right_arm_frame_23_of_place_0
                .mul_add(
                    weight_2,
                    alpha_right_arm_frame_1_of_spin_opening_0
                        .mul_add(
                            l_2_m,
                            l_2_m * F_w_spindle_frame_in_right_arm_frame_1_of_spin_opening_0,
                        ),
                ),
        ) - F_w_spindle_frame_in_right_arm_frame_1_of_place_0
        - F_w_spindle_frame_in_right_arm_frame_1_of_place_2_0;
    let spin_opening_sin_theta_0 = spin_sin_theta_0 * opening_0;
    let spin_opening_sin_theta_2_0 = opening_0 * spin_sin_theta_0;
    let F_w_spindle_frame_in_left_arm_frame_3_of_place_0 = cos_q_left_ball_0
        * F_w_left_arm_frame_in_left_link_frame_3_of_place_0;
    let F_w_spindle_frame_in_left_arm_frame_3_of_place_2_0 = sin_q_left_ball_0
        * F_w_left_arm_frame_in_left_link_frame_1_of_place_0;
    let F_w_spindle_frame_in_left_arm_frame_3_of_opening_0 = spin_opening_sin_theta_2_0
        .mul_add(minus_l_2_m, l_2_m * spin_opening_sin_theta_0)
        + F_w_spindle_frame_in_left_arm_frame_3_of_place_0
        - F_w_spindle_frame_in_left_arm_frame_3_of_place_2_0;
    let spin_opening_cos_theta_2_0 = spin_cos_theta_0 * opening_0;
    let F_w_spindle_frame_in_left_arm_frame_1_of_place_0 = sin_q_left_ball_0
        * F_w_left_arm_frame_in_left_link_frame_3_of_place_0;
    let F_w_spindle_frame_in_left_arm_frame_1_of_place_2_0 = cos_q_left_ball_0
        * F_w_left_arm_frame_in_left_link_frame_1_of_place_0;
    let F_w_spindle_frame_in_left_arm_frame_1_of_place_3_0 = a_left_link_centre_2_of_place_0
        .mul_add(
            minus_6_l_m,
            spin_opening_cos_theta_0
                .mul_add(weight_3, l_2_m * spin_opening_cos_theta_2_0),
        ) + F_w_spindle_frame_in_left_arm_frame_1_of_place_0
        + F_w_spindle_frame_in_left_arm_frame_1_of_place_2_0;
    let spin_sq_sin_theta_sq_0 = spin_sin_theta_0 * spin_sin_theta_0;
    let w_left_arm_frame_13_of_spin_0 = spin_sin_theta_0 * spin_cos_theta_0;
    let opening_sq_0 = opening_0 * opening_0;
    let alpha_right_arm_frame_2_of_opening_0 = w_right_link_frame_2_of_opening_0
        - q_right_top_dot_2_0;
    let alpha_right_arm_frame_2_of_opening_2_0 = sin_theta_plus_q_left_ball_0
        * w_left_link_frame_2_of_opening_2_0;
    let alpha_right_arm_frame_2_of_opening_3_0 = alpha_right_arm_frame_2_of_opening_2_0
        * over_cos_theta_plus_q_left_ball;
    let alpha_right_arm_frame_2_of_opening_4_0 = q_right_top_dot_2_0
        * alpha_right_arm_frame_2_of_opening_3_0;
    let alpha_right_arm_frame_2_of_place_0 = cos_q_left_ball_0 * over_sin_q_right_ball;
    let alpha_right_arm_frame_2_of_opening_5_0 = w_right_arm_frame_2_of_opening_0
        * w_left_link_frame_2_of_opening_0;
    let alpha_right_arm_frame_2_of_opening_6_0 = alpha_right_arm_frame_2_of_place_0
        * alpha_right_arm_frame_2_of_opening_5_0;
    let alpha_right_arm_frame_2_of_opening_7_0 = cos_angle_0
        * alpha_right_arm_frame_2_of_opening_6_0;
    let alpha_right_arm_frame_2_of_opening_8_0 = sin_angle_0 * w_right_arm_frame_2_of_opening_3_0;
    let alpha_right_arm_frame_2_of_opening_9_0 = alpha_right_arm_frame_2_of_opening_0
        * alpha_right_arm_frame_2_of_opening_8_0;
    let alpha_right_arm_frame_2_of_q_right_ball_0 = cos_q_right_ball_0 * over_sin_q_right_ball;
    let alpha_right_arm_frame_2_of_opening_10_0 = w_right_link_frame_2_of_opening_0
        * alpha_right_arm_frame_2_of_q_right_ball_0;
    let alpha_right_arm_frame_2_of_opening_11_0 = q_right_top_dot_2_0
        * alpha_right_arm_frame_2_of_opening_10_0;
    let alpha_right_arm_frame_2_of_opening_12_0 = -alpha_right_arm_frame_2_of_opening_7_0
        + alpha_right_arm_frame_2_of_opening_4_0 + alpha_right_arm_frame_2_of_opening_9_0
        + alpha_right_arm_frame_2_of_opening_11_0;
    let w_right_arm_frame_11_of_spin_0 = spin_sin_q_right_top_0 * spin_sin_q_right_top_0;
    let w_right_arm_frame_13_of_spin_0 = spin_sin_q_right_top_0 * spin_cos_q_right_top_0;
    let w_right_arm_frame_22_of_opening_0 = q_right_top_dot_2_0 * q_right_top_dot_2_0;
    let turn_right_arm_frame_13_of_place_0 = -w_right_arm_frame_13_of_spin_0
        + alpha_right_arm_frame_2_of_opening_12_0;
    let opening_sin_theta_0 = opening_0 * sin_theta_0;
    let alpha_left_link_frame_2_of_opening_0 = opening_sin_theta_0
        + alpha_right_arm_frame_2_of_opening_2_0;
    let alpha_left_link_frame_2_of_opening_2_0 = w_left_link_frame_2_of_opening_0
        * alpha_right_arm_frame_2_of_opening_3_0;
    let alpha_left_link_frame_2_of_opening_3_0 = alpha_left_link_frame_2_of_opening_0
        * w_right_arm_frame_2_of_opening_0;
    let alpha_left_link_frame_2_of_opening_4_0 = -alpha_left_link_frame_2_of_opening_3_0
        + alpha_left_link_frame_2_of_opening_2_0;
    let w_left_link_frame_11_of_place_0 = w_left_arm_frame_in_left_link_frame_1_of_place_0
        * w_left_arm_frame_in_left_link_frame_1_of_place_0;
    let w_left_link_frame_13_of_place_0 = w_left_arm_frame_in_left_link_frame_1_of_place_0
        * w_left_arm_frame_in_left_link_frame_3_of_place_0;
    let w_left_link_frame_22_of_opening_0 = w_left_link_frame_2_of_opening_2_0
        * w_left_link_frame_2_of_opening_2_0;
    let alpha_right_link_frame_2_of_place_0 = sin_q_right_top_0
        * w_right_link_frame_2_of_q_right_ball_0;
    let alpha_right_link_frame_2_of_opening_0 = q_right_top_dot_2_0
        * alpha_right_link_frame_2_of_place_0;
    let alpha_right_link_frame_2_of_opening_2_0 = cos_q_right_top_0
        * w_right_arm_frame_2_of_opening_2_0;
    let alpha_right_link_frame_2_of_opening_3_0 = w_right_link_frame_2_of_place_3_0
        * alpha_right_link_frame_2_of_opening_2_0;
    let alpha_right_link_frame_2_of_opening_4_0 = cos_angle_0
        * alpha_right_link_frame_2_of_opening_2_0;
    let alpha_right_link_frame_2_of_place_2_0 = sin_q_right_top_0 * cos_q_right_ball_0;
    let alpha_right_link_frame_2_of_opening_5_0 = w_right_link_frame_2_of_opening_0
        * alpha_right_link_frame_2_of_place_2_0;
    let alpha_right_link_frame_2_of_opening_6_0 = w_right_link_frame_2_of_opening_0
        * alpha_right_arm_frame_2_of_opening_3_0;
    let alpha_right_link_frame_2_of_opening_7_0 = w_right_link_frame_2_of_place_3_0
        * alpha_right_arm_frame_2_of_opening_6_0;
    let alpha_right_link_frame_2_of_opening_8_0 = w_right_link_frame_2_of_opening_0
        * alpha_right_arm_frame_2_of_opening_10_0;
    let alpha_right_link_frame_2_of_opening_9_0 = alpha_right_link_frame_2_of_opening_4_0
        - alpha_right_link_frame_2_of_opening_3_0 + alpha_right_link_frame_2_of_opening_0
        - alpha_right_link_frame_2_of_opening_5_0;
    let alpha_right_link_frame_2_of_opening_10_0 = alpha_right_link_frame_2_of_opening_9_0
        * w_right_arm_frame_2_of_opening_3_0;
    let alpha_right_link_frame_2_of_opening_11_0 = -alpha_right_link_frame_2_of_opening_7_0
        + alpha_right_link_frame_2_of_opening_6_0 + alpha_right_link_frame_2_of_opening_8_0
        - alpha_right_link_frame_2_of_opening_10_0 - alpha_right_arm_frame_2_of_opening_12_0;
    let w_right_link_frame_11_of_place_0 = w_right_arm_frame_in_right_link_frame_1_of_place_0
        * w_right_arm_frame_in_right_link_frame_1_of_place_0;
    let w_right_link_frame_13_of_place_0 = w_right_arm_frame_in_right_link_frame_1_of_place_0
        * w_right_arm_frame_in_right_link_frame_3_of_place_0;
    let w_right_link_frame_22_of_opening_0 = w_right_link_frame_2_of_opening_2_0
        * w_right_link_frame_2_of_opening_2_0;
    let a_left_link_centre_1_of_place_0 = w_left_arm_frame_13_of_spin_0
        .mul_add(l, minus_g * sin_theta_0);
    let a_left_link_centre_3_of_place_0 = spin_sq_sin_theta_sq_0
        .mul_add(l, opening_sq_0.mul_add(l, g * cos_theta_0));
    let a_left_arm_frame_in_left_link_frame_1_of_place_0 = sin_q_left_ball_0
        * a_left_link_centre_3_of_place_0;
    let a_left_arm_frame_in_left_link_frame_1_of_place_2_0 = cos_q_left_ball_0
        * a_left_link_centre_1_of_place_0;
    let a_left_arm_frame_in_left_link_frame_3_of_place_0 = cos_q_left_ball_0
        * a_left_link_centre_3_of_place_0;
    let a_left_arm_frame_in_left_link_frame_3_of_place_2_0 = sin_q_left_ball_0
        * a_left_link_centre_1_of_place_0;
    let a_left_link_centre_1_2_of_place_0 = alpha_left_link_frame_2_of_opening_4_0
        .mul_add(
            l,
            w_left_link_frame_13_of_place_0
                .mul_add(
                    l,
                    a_left_arm_frame_in_left_link_frame_1_of_place_2_0
                        .mul_add(
                            S::int(2),
                            -S::int(2) * a_left_arm_frame_in_left_link_frame_1_of_place_0,
                        ),
                ),
        );
    let a_left_link_centre_3_2_of_place_0 = w_left_link_frame_22_of_opening_0
        .mul_add(
            l,
            w_left_link_frame_11_of_place_0
                .mul_add(
                    l,
                    a_left_arm_frame_in_left_link_frame_3_of_place_2_0
                        .mul_add(
                            S::int(2),
                            S::int(2) * a_left_arm_frame_in_left_link_frame_3_of_place_0,
                        ),
                ),
        );
    let a_right_link_centre_1_of_place_0 = turn_right_arm_frame_13_of_place_0
        .mul_add(l, g * sin_q_right_top_0);
    let a_right_link_centre_3_of_place_0 = w_right_arm_frame_22_of_opening_0
        .mul_add(l, w_right_arm_frame_11_of_spin_0.mul_add(l, g * cos_q_right_top_0));
    let a_right_arm_frame_in_right_link_frame_1_of_place_0 = sin_q_right_ball_0
        * a_right_link_centre_3_of_place_0;
    let a_right_arm_frame_in_right_link_frame_1_of_place_2_0 = cos_q_right_ball_0
        * a_right_link_centre_1_of_place_0;
    let a_right_arm_frame_in_right_link_frame_3_of_place_0 = cos_q_right_ball_0
        * a_right_link_centre_3_of_place_0;
    let a_right_arm_frame_in_right_link_frame_3_of_place_2_0 = sin_q_right_ball_0
        * a_right_link_centre_1_of_place_0;
    let a_right_link_centre_1_2_of_place_0 = a_right_arm_frame_in_right_link_frame_1_of_place_2_0
        .mul_add(
            -S::int(2),
            alpha_right_link_frame_2_of_opening_11_0
                .mul_add(
                    l,
                    a_right_arm_frame_in_right_link_frame_1_of_place_0
                        .mul_add(-S::int(2), l * w_right_link_frame_13_of_place_0),
                ),
        );
    let a_right_link_centre_3_2_of_place_0 = a_right_arm_frame_in_right_link_frame_3_of_place_2_0
        .mul_add(
            -S::int(2),
            a_right_arm_frame_in_right_link_frame_3_of_place_0
                .mul_add(
                    S::int(2),
                    w_right_link_frame_22_of_opening_0
                        .mul_add(l, l * w_right_link_frame_11_of_place_0),
                ),
        );
    let opening_sq_cos_theta_0 = cos_theta_0 * opening_sq_0;
    let a_sleeve_centre_3_of_opening_0 = cos_theta_plus_q_left_ball_0
        * w_left_link_frame_2_of_opening_2_0;
    let a_sleeve_centre_3_of_opening_2_0 = w_left_link_frame_2_of_opening_2_0
        * a_sleeve_centre_3_of_opening_0;
    let a_sleeve_centre_3_of_opening_3_0 = sin_theta_plus_q_left_ball_0
        * alpha_left_link_frame_2_of_opening_4_0;
    let a_sleeve_centre_3_of_opening_4_0 = a_sleeve_centre_3_of_opening_3_0
        .mul_add(
            minus_l,
            a_sleeve_centre_3_of_opening_2_0
                .mul_add(l, opening_sq_cos_theta_0.mul_add(l, g)),
        );
    let F_w_right_link_frame_2_of_place_0 = w_right_arm_frame_in_right_link_frame_3_of_place_0
        * w_right_arm_frame_in_right_link_frame_1_of_place_0;
    let F_w_right_link_frame_2_of_place_2_0 = a_right_link_centre_1_2_of_place_0
        .mul_add(
            weight,
            alpha_right_link_frame_2_of_opening_11_0
                .mul_add(l_2_m, l_2_m * F_w_right_link_frame_2_of_place_0),
        );
    let F_w_left_link_frame_2_of_place_0 = w_left_arm_frame_in_left_link_frame_3_of_place_0
        * w_left_arm_frame_in_left_link_frame_1_of_place_0;
    let F_w_right_arm_frame_2_of_spin_0 = spin_cos_q_right_top_0 * spin_sin_q_right_top_0;
    let F_w_right_arm_frame_2_of_place_0 = sin_q_right_ball_0 * a_right_link_centre_3_2_of_place_0;
    let F_w_right_arm_frame_2_of_place_2_0 = cos_q_right_ball_0
        * a_right_link_centre_1_2_of_place_0;
    let F_w_right_arm_frame_2_of_place_3_0 = F_w_right_arm_frame_2_of_place_2_0
        .mul_add(
            weight_4,
            F_w_right_arm_frame_2_of_place_0
                .mul_add(
                    weight_4,
                    a_right_link_centre_1_of_place_0
                        .mul_add(
                            minus_12_l_mb,
                            turn_right_arm_frame_13_of_place_0
                                .mul_add(
                                    minus_3_l_2_m,
                                    alpha_right_arm_frame_2_of_opening_12_0
                                        .mul_add(
                                            minus_l_2_m,
                                            F_w_right_arm_frame_2_of_spin_0
                                                .mul_add(l_2_m, minus_6_l_m_g * sin_q_right_top_0),
                                        ),
                                ),
                        ) + F_w_right_link_frame_2_of_place_2_0,
                ),
        );
    let sin_q_right_ball_sq_0 = sin_q_right_ball_0 * sin_q_right_ball_0;
    let J_right_link_frame_in_right_arm_frame_13_of_q_right_ball_0 = cos_q_right_ball_0
        * sin_q_right_ball_0;
    let sin_q_left_ball_sq_0 = sin_q_left_ball_0 * sin_q_left_ball_0;
    let J_left_link_frame_in_left_arm_frame_13_of_q_left_ball_0 = cos_q_left_ball_0
        * sin_q_left_ball_0;
    let J_right_arm_frame_13_of_place_0 = J_right_link_frame_in_right_arm_frame_13_of_q_right_ball_0
        .mul_add(weight_5, weight_6 * sin_q_right_ball_0);
    let J_right_arm_frame_in_spindle_frame_31_of_place_0 = sin_q_right_ball_sq_0
        .mul_add(weight_8, cos_q_right_ball_0.mul_add(minus_12_l_2_m, weight_7));
    let J_right_arm_frame_in_spindle_frame_of_place_0 = sin_q_right_top_0
        * J_right_arm_frame_in_spindle_frame_31_of_place_0;
    let J_right_arm_frame_in_spindle_frame_of_place_2_0 = cos_q_right_top_0
        * J_right_arm_frame_13_of_place_0;
    let J_right_arm_frame_in_spindle_frame_of_place_3_0 = J_right_arm_frame_in_spindle_frame_of_place_2_0
        .mul_add(-S::int(2), J_right_arm_frame_in_spindle_frame_of_place_0);
    let J_right_arm_frame_in_spindle_frame_2_of_place_0 = sin_q_right_top_0
        * J_right_arm_frame_in_spindle_frame_of_place_3_0;
    let J_left_arm_frame_13_of_place_0 = J_left_link_frame_in_left_arm_frame_13_of_q_left_ball_0
        .mul_add(weight_5, weight_6 * sin_q_left_ball_0);
    let J_left_arm_frame_in_spindle_frame_31_of_place_0 = sin_q_left_ball_sq_0
        .mul_add(weight_8, cos_q_left_ball_0.mul_add(minus_12_l_2_m, weight_7));
    let J_left_arm_frame_in_spindle_frame_of_place_0 = sin_theta_0
        * J_left_arm_frame_in_spindle_frame_31_of_place_0;
    let J_left_arm_frame_in_spindle_frame_of_place_2_0 = cos_theta_0
        * J_left_arm_frame_13_of_place_0;
    let J_left_arm_frame_in_spindle_frame_of_place_3_0 = J_left_arm_frame_in_spindle_frame_of_place_2_0
        .mul_add(-S::int(2), J_left_arm_frame_in_spindle_frame_of_place_0);
    let J_left_arm_frame_in_spindle_frame_2_of_place_0 = sin_theta_0
        * J_left_arm_frame_in_spindle_frame_of_place_3_0;
    let J_spindle_frame_33_2_of_place_0 = sin_q_left_ball_sq_0
        .mul_add(weight_5, sin_q_right_ball_sq_0.mul_add(weight_5, weight_9))
        - J_right_arm_frame_in_spindle_frame_2_of_place_0
        - J_left_arm_frame_in_spindle_frame_2_of_place_0;
    let over_J_spindle_frame_33_2_of_place = S::int(1) / J_spindle_frame_33_2_of_place_0;
    let d2_of_place_0 = sin_theta_0 * sin_q_left_ball_0;
    let d2_of_place_2_0 = cos_theta_0 * cos_q_left_ball_0;
    let d2_of_place_3_0 = d2_of_place_0 - d2_of_place_2_0;
    let cos_theta_sq_0 = cos_theta_0 * cos_theta_0;
    let sin_q_right_ball_sq_2_0 = sin_q_right_ball_0 * sin_q_right_ball_0;
    let over_sin_q_right_ball_sq_2 = S::int(1) / sin_q_right_ball_sq_2_0;
    let sin_q_right_ball_inv2_0 = over_sin_q_right_ball_sq_2;
    let d2_of_place_4_0 = sin_q_right_ball_inv2_0
        .mul_add(weight_10, minus_5_m_minus_6_mb);
    let d2_of_place_5_0 = cos_q_right_top_0 * d2_of_place_4_0;
    let d2_of_place_6_0 = sin_q_right_top_0 * alpha_right_arm_frame_2_of_q_right_ball_0;
    let d2_of_place_7_0 = minus_5_m_minus_6_mb * d2_of_place_6_0 + d2_of_place_5_0;
    let d2_of_place_8_0 = cos_q_right_top_0 * d2_of_place_7_0;
    let d2_of_place_9_0 = cos_theta_sq_0.mul_add(minus_5_m_minus_6_mb, weight_11) + d2_of_place_8_0;
    let d2_of_place_10_0 = sin_q_left_ball_0 * d2_of_place_9_0;
    let d2_of_place_11_0 = sin_theta_0 * d2_of_place_2_0;
    let d2_of_place_12_0 = minus_5_m_minus_6_mb * d2_of_place_11_0 + d2_of_place_10_0;
    let d2_of_place_13_0 = sin_q_left_ball_0 * d2_of_place_12_0;
    let d2_of_place_14_0 = weight_10 * cos_theta_sq_0 + d2_of_place_13_0;
    let d2_of_place_15_0 = d2_of_place_3_0 * d2_of_place_3_0;
    let over_d2_of_place_15 = S::int(1) / d2_of_place_15_0;
    let d2_of_place_16_0 = d2_of_place_14_0 * over_d2_of_place_15;
    let over_d2_of_place_16 = S::int(1) / d2_of_place_16_0;
    let opening_dot_of_spin_0 = spin_cos_theta_0 * spin_sin_theta_0;
    let opening_dot_of_place_0 = F_w_right_link_frame_2_of_place_2_0
        * w_right_link_frame_2_of_place_0;
    let opening_dot_of_place_2_0 = cos_angle_0 * F_w_right_arm_frame_2_of_place_3_0;
    let opening_dot_of_place_3_0 = opening_dot_of_place_0 - opening_dot_of_place_2_0;
    let opening_dot_of_place_4_0 = opening_dot_of_place_3_0 * over_sin_q_right_ball;
    let opening_dot_of_place_5_0 = sin_q_right_top_0 * F_w_right_link_frame_2_of_place_2_0;
    let opening_dot_of_place_6_0 = -opening_dot_of_place_5_0 + opening_dot_of_place_4_0;
    let opening_dot_of_place_7_0 = sin_q_left_ball_0 * opening_dot_of_place_6_0;
    let opening_dot_of_opening_0 = sin_theta_plus_q_left_ball_0 * a_sleeve_centre_3_of_opening_4_0;
    let opening_dot_of_place_8_0 = opening_dot_of_opening_0
        .mul_add(
            minus_12_l_ms,
            a_left_link_centre_1_2_of_place_0
                .mul_add(
                    weight,
                    alpha_left_link_frame_2_of_opening_4_0
                        .mul_add(l_2_m, l_2_m * F_w_left_link_frame_2_of_place_0),
                ),
        );
    let opening_dot_of_place_9_0 = cos_theta_0 * opening_dot_of_place_8_0;
    let opening_dot_of_place_10_0 = opening_dot_of_place_9_0 + opening_dot_of_place_7_0;
    let opening_dot_of_place_11_0 = opening_dot_of_place_10_0 * over_cos_theta_plus_q_left_ball;
    let opening_dot_of_opening_2_0 = sin_theta_0 * a_sleeve_centre_3_of_opening_4_0;
    let opening_dot_of_place_12_0 = sin_q_left_ball_0 * a_left_link_centre_3_2_of_place_0;
    let opening_dot_of_place_13_0 = cos_q_left_ball_0 * a_left_link_centre_1_2_of_place_0;
    let opening_dot_of_place_14_0 = opening_dot_of_opening_2_0
        .mul_add(
            minus_12_l_ms,
            opening_dot_of_place_13_0
                .mul_add(
                    weight_4,
                    opening_dot_of_place_12_0
                        .mul_add(
                            weight_4,
                            a_left_link_centre_1_of_place_0
                                .mul_add(
                                    weight_13,
                                    w_left_arm_frame_13_of_spin_0
                                        .mul_add(
                                            weight_12,
                                            opening_dot_of_spin_0
                                                .mul_add(l_2_m, minus_6_l_m_g * sin_theta_0),
                                        ),
                                ),
                        ),
                ),
        ) - opening_dot_of_place_11_0;
    let opening_dot_of_place_15_0 = opening_dot_of_place_14_0 * over_d2_of_place_16;
    let spin_dot_of_place_0 = cos_q_right_top_0
        * F_w_spindle_frame_in_right_arm_frame_3_of_place_3_0;
    let spin_dot_of_place_2_0 = sin_q_right_top_0
        * F_w_spindle_frame_in_right_arm_frame_1_of_place_3_0;
    let spin_dot_of_opening_0 = cos_theta_0 * F_w_spindle_frame_in_left_arm_frame_3_of_opening_0;
    let spin_dot_of_place_3_0 = sin_theta_0 * F_w_spindle_frame_in_left_arm_frame_1_of_place_3_0;
    let spin_dot_of_place_4_0 = spin_dot_of_opening_0 - spin_dot_of_place_3_0
        + spin_dot_of_place_0 - spin_dot_of_place_2_0;
    let spin_dot_2_0 = spin_dot_of_place_4_0 * over_J_spindle_frame_33_2_of_place;
    // Order 1: the rates, and what follows from them.
    let psi_1 = spin_0;
    let theta_1 = opening_0;
    let q_right_top_1 = q_right_top_dot_2_0;
    let q_left_ball_1 = -w_left_link_frame_2_of_opening_0;
    let q_right_ball_1 = -w_right_link_frame_2_of_opening_0;
    let spin_1 = spin_dot_2_0;
    let opening_1 = weight_14 * opening_dot_of_place_15_0;
    if series.len() > 1 {
        series[1] = [
            psi_1, theta_1, q_right_top_1, q_left_ball_1, q_right_ball_1, spin_1, opening_1,
        ];
    }
    let sin_theta_1 = theta_1 * cos_theta_0;
    let cos_theta_1 = -theta_1 * sin_theta_0;
    let spin_sin_theta_1 = sin_theta_1.mul_add(spin_0, spin_1 * sin_theta_0);
    let spin_cos_theta_1 = cos_theta_1.mul_add(spin_0, spin_1 * cos_theta_0);
    let sin_q_right_top_1 = q_right_top_1 * cos_q_right_top_0;
    let cos_q_right_top_1 = -q_right_top_1 * sin_q_right_top_0;
    let spin_sin_q_right_top_1 = sin_q_right_top_1
        .mul_add(spin_0, spin_1 * sin_q_right_top_0);
    let spin_cos_q_right_top_1 = cos_q_right_top_1
        .mul_add(spin_0, spin_1 * cos_q_right_top_0);
    let theta_plus_q_left_ball_1 = theta_1 + q_left_ball_1;
    let sin_theta_plus_q_left_ball_1 = theta_plus_q_left_ball_1 * cos_theta_plus_q_left_ball_0;
    let cos_theta_plus_q_left_ball_1 = -theta_plus_q_left_ball_1 * sin_theta_plus_q_left_ball_0;
    let sin_q_left_ball_1 = q_left_ball_1 * cos_q_left_ball_0;
    let cos_q_left_ball_1 = -q_left_ball_1 * sin_q_left_ball_0;
    let w_right_arm_frame_2_of_place_1 = q_right_top_1 + q_right_ball_1;
    let sin_angle_1 = w_right_arm_frame_2_of_place_1 * cos_angle_0;
    let cos_angle_1 = -w_right_arm_frame_2_of_place_1 * sin_angle_0;
    let sin_q_right_ball_1 = q_right_ball_1 * cos_q_right_ball_0;
    let cos_q_right_ball_1 = -q_right_ball_1 * sin_q_right_ball_0;
    let w_right_arm_frame_2_of_opening_1 = cos_theta_plus_q_left_ball_1
        .mul_add(
            -(w_right_arm_frame_2_of_opening_0 * over_cos_theta_plus_q_left_ball),
            opening_1 * over_cos_theta_plus_q_left_ball,
        );
    let w_right_arm_frame_2_of_opening_2_1 = w_right_arm_frame_2_of_opening_1
        .mul_add(
            sin_q_left_ball_0,
            sin_q_left_ball_1 * w_right_arm_frame_2_of_opening_0,
        );
    let w_right_arm_frame_2_of_opening_3_1 = sin_q_right_ball_1
        .mul_add(
            -(w_right_arm_frame_2_of_opening_3_0 * over_sin_q_right_ball),
            w_right_arm_frame_2_of_opening_2_1 * over_sin_q_right_ball,
        );
    let q_right_top_dot_2_1 = w_right_arm_frame_2_of_opening_3_1
        .mul_add(cos_angle_0, cos_angle_1 * w_right_arm_frame_2_of_opening_3_0);
    let w_left_arm_frame_in_left_link_frame_1_of_spin_1 = spin_cos_theta_1
        .mul_add(sin_q_left_ball_0, sin_q_left_ball_1 * spin_cos_theta_0);
    let w_left_arm_frame_in_left_link_frame_1_of_spin_2_1 = spin_sin_theta_1
        .mul_add(cos_q_left_ball_0, cos_q_left_ball_1 * spin_sin_theta_0);
    let w_left_arm_frame_in_left_link_frame_1_of_place_1 = w_left_arm_frame_in_left_link_frame_1_of_spin_1
        + w_left_arm_frame_in_left_link_frame_1_of_spin_2_1;
    let w_left_arm_frame_in_left_link_frame_3_of_spin_1 = spin_cos_theta_1
        .mul_add(cos_q_left_ball_0, cos_q_left_ball_1 * spin_cos_theta_0);
    let w_left_arm_frame_in_left_link_frame_3_of_spin_2_1 = spin_sin_theta_1
        .mul_add(sin_q_left_ball_0, sin_q_left_ball_1 * spin_sin_theta_0);
    let w_left_arm_frame_in_left_link_frame_3_of_place_1 = w_left_arm_frame_in_left_link_frame_3_of_spin_1
        - w_left_arm_frame_in_left_link_frame_3_of_spin_2_1;
    let w_left_link_frame_2_of_place_1 = cos_theta_1 + cos_theta_plus_q_left_ball_1;
    let w_left_link_frame_2_of_opening_1 = w_right_arm_frame_2_of_opening_1
        .mul_add(
            w_left_link_frame_2_of_place_0,
            w_left_link_frame_2_of_place_1 * w_right_arm_frame_2_of_opening_0,
        );
    let w_left_link_frame_2_of_opening_2_1 = opening_1 - w_left_link_frame_2_of_opening_1;
    let w_right_arm_frame_in_right_link_frame_1_of_spin_1 = spin_cos_q_right_top_1
        .mul_add(sin_q_right_ball_0, sin_q_right_ball_1 * spin_cos_q_right_top_0);
    let w_right_arm_frame_in_right_link_frame_1_of_spin_2_1 = spin_sin_q_right_top_1
        .mul_add(cos_q_right_ball_0, cos_q_right_ball_1 * spin_sin_q_right_top_0);
    let w_right_arm_frame_in_right_link_frame_1_of_place_1 = w_right_arm_frame_in_right_link_frame_1_of_spin_1
        + w_right_arm_frame_in_right_link_frame_1_of_spin_2_1;
    let w_right_arm_frame_in_right_link_frame_3_of_spin_1 = spin_cos_q_right_top_1
        .mul_add(cos_q_right_ball_0, cos_q_right_ball_1 * spin_cos_q_right_top_0);
    let w_right_arm_frame_in_right_link_frame_3_of_spin_2_1 = spin_sin_q_right_top_1
        .mul_add(sin_q_right_ball_0, sin_q_right_ball_1 * spin_sin_q_right_top_0);
    let w_right_arm_frame_in_right_link_frame_3_of_place_1 = w_right_arm_frame_in_right_link_frame_3_of_spin_1
        - w_right_arm_frame_in_right_link_frame_3_of_spin_2_1;
    let w_right_link_frame_2_of_q_right_ball_1 = cos_q_right_ball_1;
    let w_right_link_frame_2_of_place_1 = w_right_link_frame_2_of_q_right_ball_1
        .mul_add(
            cos_q_right_top_0,
            cos_q_right_top_1 * w_right_link_frame_2_of_q_right_ball_0,
        );
    let w_right_link_frame_2_of_place_2_1 = sin_q_right_ball_1
        .mul_add(sin_q_right_top_0, sin_q_right_top_1 * sin_q_right_ball_0);
    let w_right_link_frame_2_of_place_3_1 = -w_right_link_frame_2_of_place_2_1
        + w_right_link_frame_2_of_place_1;
    let w_right_link_frame_2_of_opening_1 = w_right_arm_frame_2_of_opening_3_1
        .mul_add(
            w_right_link_frame_2_of_place_3_0,
            w_right_link_frame_2_of_place_3_1 * w_right_arm_frame_2_of_opening_3_0,
        );
    let w_right_link_frame_2_of_opening_2_1 = w_right_link_frame_2_of_opening_1
        - q_right_top_dot_2_1;
    let spin_opening_cos_theta_1 = spin_cos_theta_1
        .mul_add(opening_0, opening_1 * spin_cos_theta_0);
    let alpha_right_arm_frame_1_of_spin_opening_1 = q_right_top_dot_2_1
        .mul_add(spin_cos_q_right_top_0, spin_cos_q_right_top_1 * q_right_top_dot_2_0);
    let w_right_arm_frame_23_of_spin_opening_1 = q_right_top_dot_2_1
        .mul_add(spin_cos_q_right_top_0, spin_cos_q_right_top_1 * q_right_top_dot_2_0);
    let turn_right_arm_frame_23_of_place_1 = alpha_right_arm_frame_1_of_spin_opening_1
        + w_right_arm_frame_23_of_spin_opening_1;
    let alpha_left_arm_frame_in_left_link_frame_1_of_spin_opening_1 = w_left_arm_frame_in_left_link_frame_3_of_spin_2_1
        .mul_add(
            opening_0,
            opening_1 * w_left_arm_frame_in_left_link_frame_3_of_spin_2_0,
        );
    let alpha_left_arm_frame_in_left_link_frame_1_of_spin_opening_2_1 = w_left_arm_frame_in_left_link_frame_3_of_spin_1
        .mul_add(opening_0, opening_1 * w_left_arm_frame_in_left_link_frame_3_of_spin_0);
    let alpha_left_link_frame_1_of_opening_1 = w_left_link_frame_2_of_opening_1
        .mul_add(
            w_left_arm_frame_in_left_link_frame_3_of_place_0,
            w_left_arm_frame_in_left_link_frame_3_of_place_1 * w_left_link_frame_2_of_opening_0,
        );
    let alpha_left_link_frame_1_of_opening_2_1 = alpha_left_arm_frame_in_left_link_frame_1_of_spin_opening_1
        - alpha_left_arm_frame_in_left_link_frame_1_of_spin_opening_2_1
        + alpha_left_link_frame_1_of_opening_1;
    let w_left_link_frame_23_of_opening_1 = w_left_link_frame_2_of_opening_2_1
        .mul_add(
            w_left_arm_frame_in_left_link_frame_3_of_place_0,
            w_left_arm_frame_in_left_link_frame_3_of_place_1 * w_left_link_frame_2_of_opening_2_0,
        );
    let alpha_right_arm_frame_in_right_link_frame_1_of_spin_1 = spin_sin_q_right_top_1
        .mul_add(cos_angle_0, cos_angle_1 * spin_sin_q_right_top_0);
    let alpha_right_arm_frame_in_right_link_frame_1_of_spin_opening_1 = w_right_arm_frame_2_of_opening_2_1
        .mul_add(
            alpha_right_arm_frame_in_right_link_frame_1_of_spin_0,
            alpha_right_arm_frame_in_right_link_frame_1_of_spin_1
                * w_right_arm_frame_2_of_opening_2_0,
        );
    let alpha_right_arm_frame_in_right_link_frame_1_of_spin_opening_2_1 = q_right_top_dot_2_1
        .mul_add(
            w_right_arm_frame_in_right_link_frame_3_of_spin_0,
            w_right_arm_frame_in_right_link_frame_3_of_spin_1 * q_right_top_dot_2_0,
        );
    let alpha_right_link_frame_1_of_opening_1 = w_right_link_frame_2_of_opening_1
        .mul_add(
            w_right_arm_frame_in_right_link_frame_3_of_place_0,
            w_right_arm_frame_in_right_link_frame_3_of_place_1 * w_right_link_frame_2_of_opening_0,
        );
    let alpha_right_link_frame_1_of_opening_2_1 = alpha_right_arm_frame_in_right_link_frame_1_of_spin_opening_1
        + alpha_right_link_frame_1_of_opening_1
        - alpha_right_arm_frame_in_right_link_frame_1_of_spin_opening_2_1;
    let w_right_link_frame_23_of_opening_1 = w_right_link_frame_2_of_opening_2_1
        .mul_add(
            w_right_arm_frame_in_right_link_frame_3_of_place_0,
            w_right_arm_frame_in_right_link_frame_3_of_place_1
                * w_right_link_frame_2_of_opening_2_0,
        );
    let a_left_link_centre_2_of_place_1 = w_left_link_frame_23_of_opening_1
        .mul_add(
            minus_l,
            alpha_left_link_frame_1_of_opening_2_1
                .mul_add(l, minus_4_l * spin_opening_cos_theta_1),
        );
    let a_right_link_centre_2_of_place_1 = w_right_link_frame_23_of_opening_1
        .mul_add(
            l,
            alpha_right_link_frame_1_of_opening_2_1
                .mul_add(l, minus_2_l * turn_right_arm_frame_23_of_place_1),
        );
    let F_w_right_arm_frame_in_right_link_frame_3_of_opening_1 = w_right_link_frame_2_of_opening_2_1
        .mul_add(
            w_right_arm_frame_in_right_link_frame_1_of_place_0,
            w_right_arm_frame_in_right_link_frame_1_of_place_1
                * w_right_link_frame_2_of_opening_2_0,
        );
    let F_w_right_arm_frame_in_right_link_frame_3_of_opening_2_1 = w_right_link_frame_2_of_opening_2_1
        .mul_add(
            w_right_arm_frame_in_right_link_frame_1_of_place_0,
            w_right_arm_frame_in_right_link_frame_1_of_place_1
                * w_right_link_frame_2_of_opening_2_0,
        );
    let F_w_right_arm_frame_in_right_link_frame_3_of_place_1 = F_w_right_arm_frame_in_right_link_frame_3_of_opening_2_1
        .mul_add(
            minus_l_2_m,
            l_2_m * F_w_right_arm_frame_in_right_link_frame_3_of_opening_1,
        );
    let F_w_right_arm_frame_in_right_link_frame_1_of_opening_1 = w_right_link_frame_2_of_opening_2_1
        .mul_add(
            w_right_arm_frame_in_right_link_frame_3_of_place_0,
            w_right_arm_frame_in_right_link_frame_3_of_place_1
                * w_right_link_frame_2_of_opening_2_0,
        );
    let F_w_right_arm_frame_in_right_link_frame_1_of_place_1 = a_right_link_centre_2_of_place_1
        .mul_add(
            weight,
            alpha_right_link_frame_1_of_opening_2_1
                .mul_add(
                    l_2_m,
                    l_2_m * F_w_right_arm_frame_in_right_link_frame_1_of_opening_1,
                ),
        );
    let F_w_left_arm_frame_in_left_link_frame_3_of_opening_1 = w_left_link_frame_2_of_opening_2_1
        .mul_add(
            w_left_arm_frame_in_left_link_frame_1_of_place_0,
            w_left_arm_frame_in_left_link_frame_1_of_place_1 * w_left_link_frame_2_of_opening_2_0,
        );
    let F_w_left_arm_frame_in_left_link_frame_3_of_opening_2_1 = w_left_link_frame_2_of_opening_2_1
        .mul_add(
            w_left_arm_frame_in_left_link_frame_1_of_place_0,
            w_left_arm_frame_in_left_link_frame_1_of_place_1 * w_left_link_frame_2_of_opening_2_0,
        );
    let F_w_left_arm_frame_in_left_link_frame_3_of_place_1 = F_w_left_arm_frame_in_left_link_frame_3_of_opening_2_1
        .mul_add(
            minus_l_2_m,
            l_2_m * F_w_left_arm_frame_in_left_link_frame_3_of_opening_1,
        );
    let F_w_left_arm_frame_in_left_link_frame_1_of_opening_1 = w_left_link_frame_2_of_opening_2_1
        .mul_add(
            w_left_arm_frame_in_left_link_frame_3_of_place_0,
            w_left_arm_frame_in_left_link_frame_3_of_place_1 * w_left_link_frame_2_of_opening_2_0,
        );
    let F_w_left_arm_frame_in_left_link_frame_1_of_place_1 = a_left_link_centre_2_of_place_1
        .mul_add(
            minus_3_l_m,
            alpha_left_link_frame_1_of_opening_2_1
                .mul_add(
                    minus_l_2_m,
                    l_2_m * F_w_left_arm_frame_in_left_link_frame_1_of_opening_1,
                ),
        );
    let F_w_spindle_frame_in_right_arm_frame_3_of_spin_opening_1 = q_right_top_dot_2_1
        .mul_add(spin_sin_q_right_top_0, spin_sin_q_right_top_1 * q_right_top_dot_2_0);
    let F_w_spindle_frame_in_right_arm_frame_3_of_spin_opening_2_1 = q_right_top_dot_2_1
        .mul_add(spin_sin_q_right_top_0, spin_sin_q_right_top_1 * q_right_top_dot_2_0);
    let F_w_spindle_frame_in_right_arm_frame_3_of_place_1 = F_w_right_arm_frame_in_right_link_frame_3_of_place_1
        .mul_add(
            cos_q_right_ball_0,
            cos_q_right_ball_1 * F_w_right_arm_frame_in_right_link_frame_3_of_place_0,
        );
    let F_w_spindle_frame_in_right_arm_frame_3_of_place_2_1 = F_w_right_arm_frame_in_right_link_frame_1_of_place_1
        .mul_add(
            sin_q_right_ball_0,
            sin_q_right_ball_1 * F_w_right_arm_frame_in_right_link_frame_1_of_place_0,
        );
    let F_w_spindle_frame_in_right_arm_frame_3_of_place_3_1 = F_w_spindle_frame_in_right_arm_frame_3_of_spin_opening_2_1
        .mul_add(
            minus_l_2_m,
            l_2_m * F_w_spindle_frame_in_right_arm_frame_3_of_spin_opening_1,
        ) - F_w_spindle_frame_in_right_arm_frame_3_of_place_1
        + F_w_spindle_frame_in_right_arm_frame_3_of_place_2_1;
    let F_w_spindle_frame_in_right_arm_frame_1_of_spin_opening_1 = q_right_top_dot_2_1
        .mul_add(spin_cos_q_right_top_0, spin_cos_q_right_top_1 * q_right_top_dot_2_0);
    let F_w_spindle_frame_in_right_arm_frame_1_of_place_1 = F_w_right_arm_frame_in_right_link_frame_3_of_place_1
        .mul_add(
            sin_q_right_ball_0,
            sin_q_right_ball_1 * F_w_right_arm_frame_in_right_link_frame_3_of_place_0,
        );
    let F_w_spindle_frame_in_right_arm_frame_1_of_place_2_1 = F_w_right_arm_frame_in_right_link_frame_1_of_place_1
        .mul_add(
            cos_q_right_ball_0,
            cos_q_right_ball_1 * F_w_right_arm_frame_in_right_link_frame_1_of_place_0,
        );
    let F_w_spindle_frame_in_right_arm_frame_1_of_place_3_1 = a_right_link_centre_2_of_place_1
        .mul_add(
            minus_6_l_m,
            turn_right_arm_frame_23_of_place_1
                .mul_add(
                    weight_2,
                    alpha_right_arm_frame_1_of_spin_opening_1
                        .mul_add(
                            l_2_m,
                            l_2_m * F_w_spindle_frame_in_right_arm_frame_1_of_spin_opening_1,
                        ),
                ),
        ) - F_w_spindle_frame_in_right_arm_frame_1_of_place_1
        - F_w_spindle_frame_in_right_arm_frame_1_of_place_2_1;
    let spin_opening_sin_theta_1 = spin_sin_theta_1
        .mul_add(opening_0, opening_1 * spin_sin_theta_0);
    let spin_opening_sin_theta_2_1 = spin_sin_theta_1
        .mul_add(opening_0, opening_1 * spin_sin_theta_0);
    let F_w_spindle_frame_in_left_arm_frame_3_of_place_1 = F_w_left_arm_frame_in_left_link_frame_3_of_place_1
        .mul_add(
            cos_q_left_ball_0,
            cos_q_left_ball_1 * F_w_left_arm_frame_in_left_link_frame_3_of_place_0,
        );
    let F_w_spindle_frame_in_left_arm_frame_3_of_place_2_1 = F_w_left_arm_frame_in_left_link_frame_1_of_place_1
        .mul_add(
            sin_q_left_ball_0,
            sin_q_left_ball_1 * F_w_left_arm_frame_in_left_link_frame_1_of_place_0,
        );
    let F_w_spindle_frame_in_left_arm_frame_3_of_opening_1 = spin_opening_sin_theta_2_1
        .mul_add(minus_l_2_m, l_2_m * spin_opening_sin_theta_1)
        + F_w_spindle_frame_in_left_arm_frame_3_of_place_1
        - F_w_spindle_frame_in_left_arm_frame_3_of_place_2_1;
    let spin_opening_cos_theta_2_1 = spin_cos_theta_1
        .mul_add(opening_0, opening_1 * spin_cos_theta_0);
    let F_w_spindle_frame_in_left_arm_frame_1_of_place_1 = F_w_left_arm_frame_in_left_link_frame_3_of_place_1
        .mul_add(
            sin_q_left_ball_0,
            sin_q_left_ball_1 * F_w_left_arm_frame_in_left_link_frame_3_of_place_0,
        );
    let F_w_spindle_frame_in_left_arm_frame_1_of_place_2_1 = F_w_left_arm_frame_in_left_link_frame_1_of_place_1
        .mul_add(
            cos_q_left_ball_0,
            cos_q_left_ball_1 * F_w_left_arm_frame_in_left_link_frame_1_of_place_0,
        );
    let F_w_spindle_frame_in_left_arm_frame_1_of_place_3_1 = a_left_link_centre_2_of_place_1
        .mul_add(
            minus_6_l_m,
            spin_opening_cos_theta_1
                .mul_add(weight_3, l_2_m * spin_opening_cos_theta_2_1),
        ) + F_w_spindle_frame_in_left_arm_frame_1_of_place_1
        + F_w_spindle_frame_in_left_arm_frame_1_of_place_2_1;
    let spin_sq_sin_theta_sq_1 = spin_sin_theta_1 * (spin_sin_theta_0 + spin_sin_theta_0);
    let w_left_arm_frame_13_of_spin_1 = spin_cos_theta_1
        .mul_add(spin_sin_theta_0, spin_sin_theta_1 * spin_cos_theta_0);
    let opening_sq_1 = opening_1 * (opening_0 + opening_0);
    let alpha_right_arm_frame_2_of_opening_1 = w_right_link_frame_2_of_opening_1
        - q_right_top_dot_2_1;
    let alpha_right_arm_frame_2_of_opening_2_1 = w_left_link_frame_2_of_opening_2_1
        .mul_add(
            sin_theta_plus_q_left_ball_0,
            sin_theta_plus_q_left_ball_1 * w_left_link_frame_2_of_opening_2_0,
        );
    let alpha_right_arm_frame_2_of_opening_3_1 = cos_theta_plus_q_left_ball_1
        .mul_add(
            -(alpha_right_arm_frame_2_of_opening_3_0 * over_cos_theta_plus_q_left_ball),
            alpha_right_arm_frame_2_of_opening_2_1 * over_cos_theta_plus_q_left_ball,
        );
    let alpha_right_arm_frame_2_of_opening_4_1 = alpha_right_arm_frame_2_of_opening_3_1
        .mul_add(
            q_right_top_dot_2_0,
            q_right_top_dot_2_1 * alpha_right_arm_frame_2_of_opening_3_0,
        );
    let alpha_right_arm_frame_2_of_place_1 = sin_q_right_ball_1
        .mul_add(
            -(alpha_right_arm_frame_2_of_place_0 * over_sin_q_right_ball),
            cos_q_left_ball_1 * over_sin_q_right_ball,
        );
    let alpha_right_arm_frame_2_of_opening_5_1 = w_left_link_frame_2_of_opening_1
        .mul_add(
            w_right_arm_frame_2_of_opening_0,
            w_right_arm_frame_2_of_opening_1 * w_left_link_frame_2_of_opening_0,
        );
    let alpha_right_arm_frame_2_of_opening_6_1 = alpha_right_arm_frame_2_of_opening_5_1
        .mul_add(
            alpha_right_arm_frame_2_of_place_0,
            alpha_right_arm_frame_2_of_place_1 * alpha_right_arm_frame_2_of_opening_5_0,
        );
    let alpha_right_arm_frame_2_of_opening_7_1 = alpha_right_arm_frame_2_of_opening_6_1
        .mul_add(cos_angle_0, cos_angle_1 * alpha_right_arm_frame_2_of_opening_6_0);
    let alpha_right_arm_frame_2_of_opening_8_1 = w_right_arm_frame_2_of_opening_3_1
        .mul_add(sin_angle_0, sin_angle_1 * w_right_arm_frame_2_of_opening_3_0);
    let alpha_right_arm_frame_2_of_opening_9_1 = alpha_right_arm_frame_2_of_opening_1
        .mul_add(
            alpha_right_arm_frame_2_of_opening_8_0,
            alpha_right_arm_frame_2_of_opening_8_1 * alpha_right_arm_frame_2_of_opening_0,
        );
    let alpha_right_arm_frame_2_of_q_right_ball_1 = sin_q_right_ball_1
        .mul_add(
            -(alpha_right_arm_frame_2_of_q_right_ball_0 * over_sin_q_right_ball),
            cos_q_right_ball_1 * over_sin_q_right_ball,
        );
    let alpha_right_arm_frame_2_of_opening_10_1 = w_right_link_frame_2_of_opening_1
        .mul_add(
            alpha_right_arm_frame_2_of_q_right_ball_0,
            alpha_right_arm_frame_2_of_q_right_ball_1 * w_right_link_frame_2_of_opening_0,
        );
    let alpha_right_arm_frame_2_of_opening_11_1 = alpha_right_arm_frame_2_of_opening_10_1
        .mul_add(
            q_right_top_dot_2_0,
            q_right_top_dot_2_1 * alpha_right_arm_frame_2_of_opening_10_0,
        );
    let alpha_right_arm_frame_2_of_opening_12_1 = -alpha_right_arm_frame_2_of_opening_7_1
        + alpha_right_arm_frame_2_of_opening_4_1 + alpha_right_arm_frame_2_of_opening_9_1
        + alpha_right_arm_frame_2_of_opening_11_1;
    let w_right_arm_frame_11_of_spin_1 = spin_sin_q_right_top_1
        * (spin_sin_q_right_top_0 + spin_sin_q_right_top_0);
    let w_right_arm_frame_13_of_spin_1 = spin_cos_q_right_top_1
        .mul_add(
            spin_sin_q_right_top_0,
            spin_sin_q_right_top_1 * spin_cos_q_right_top_0,
        );
    let w_right_arm_frame_22_of_opening_1 = q_right_top_dot_2_1
        * (q_right_top_dot_2_0 + q_right_top_dot_2_0);
    let turn_right_arm_frame_13_of_place_1 = -w_right_arm_frame_13_of_spin_1
        + alpha_right_arm_frame_2_of_opening_12_1;
    let opening_sin_theta_1 = sin_theta_1.mul_add(opening_0, opening_1 * sin_theta_0);
    let alpha_left_link_frame_2_of_opening_1 = opening_sin_theta_1
        + alpha_right_arm_frame_2_of_opening_2_1;
    let alpha_left_link_frame_2_of_opening_2_1 = alpha_right_arm_frame_2_of_opening_3_1
        .mul_add(
            w_left_link_frame_2_of_opening_0,
            w_left_link_frame_2_of_opening_1 * alpha_right_arm_frame_2_of_opening_3_0,
        );
    let alpha_left_link_frame_2_of_opening_3_1 = alpha_left_link_frame_2_of_opening_1
        .mul_add(
            w_right_arm_frame_2_of_opening_0,
            w_right_arm_frame_2_of_opening_1 * alpha_left_link_frame_2_of_opening_0,
        );
    let alpha_left_link_frame_2_of_opening_4_1 = -alpha_left_link_frame_2_of_opening_3_1
        + alpha_left_link_frame_2_of_opening_2_1;
    let w_left_link_frame_11_of_place_1 = w_left_arm_frame_in_left_link_frame_1_of_place_1
        * (w_left_arm_frame_in_left_link_frame_1_of_place_0
            + w_left_arm_frame_in_left_link_frame_1_of_place_0);
    let w_left_link_frame_13_of_place_1 = w_left_arm_frame_in_left_link_frame_3_of_place_1
        .mul_add(
            w_left_arm_frame_in_left_link_frame_1_of_place_0,
            w_left_arm_frame_in_left_link_frame_1_of_place_1
                * w_left_arm_frame_in_left_link_frame_3_of_place_0,
        );
    let w_left_link_frame_22_of_opening_1 = w_left_link_frame_2_of_opening_2_1
        * (w_left_link_frame_2_of_opening_2_0 + w_left_link_frame_2_of_opening_2_0);
    let alpha_right_link_frame_2_of_place_1 = w_right_link_frame_2_of_q_right_ball_1
        .mul_add(
            sin_q_right_top_0,
            sin_q_right_top_1 * w_right_link_frame_2_of_q_right_ball_0,
        );
    let alpha_right_link_frame_2_of_opening_1 = q_right_top_dot_2_1
        .mul_add(
            alpha_right_link_frame_2_of_place_0,
            alpha_right_link_frame_2_of_place_1 * q_right_top_dot_2_0,
        );
    let alpha_right_link_frame_2_of_opening_2_1 = w_right_arm_frame_2_of_opening_2_1
        .mul_add(
            cos_q_right_top_0,
            cos_q_right_top_1 * w_right_arm_frame_2_of_opening_2_0,
        );
    let alpha_right_link_frame_2_of_opening_3_1 = alpha_right_link_frame_2_of_opening_2_1
        .mul_add(
            w_right_link_frame_2_of_place_3_0,
            w_right_link_frame_2_of_place_3_1 * alpha_right_link_frame_2_of_opening_2_0,
        );
    let alpha_right_link_frame_2_of_opening_4_1 = alpha_right_link_frame_2_of_opening_2_1
        .mul_add(cos_angle_0, cos_angle_1 * alpha_right_link_frame_2_of_opening_2_0);
    let alpha_right_link_frame_2_of_place_2_1 = cos_q_right_ball_1
        .mul_add(sin_q_right_top_0, sin_q_right_top_1 * cos_q_right_ball_0);
    let alpha_right_link_frame_2_of_opening_5_1 = w_right_link_frame_2_of_opening_1
        .mul_add(
            alpha_right_link_frame_2_of_place_2_0,
            alpha_right_link_frame_2_of_place_2_1 * w_right_link_frame_2_of_opening_0,
        );
    let alpha_right_link_frame_2_of_opening_6_1 = alpha_right_arm_frame_2_of_opening_3_1
        .mul_add(
            w_right_link_frame_2_of_opening_0,
            w_right_link_frame_2_of_opening_1 * alpha_right_arm_frame_2_of_opening_3_0,
        );
    let alpha_right_link_frame_2_of_opening_7_1 = alpha_right_arm_frame_2_of_opening_6_1
        .mul_add(
            w_right_link_frame_2_of_place_3_0,
            w_right_link_frame_2_of_place_3_1 * alpha_right_arm_frame_2_of_opening_6_0,
        );
    let alpha_right_link_frame_2_of_opening_8_1 = alpha_right_arm_frame_2_of_opening_10_1
        .mul_add(
            w_right_link_frame_2_of_opening_0,
            w_right_link_frame_2_of_opening_1 * alpha_right_arm_frame_2_of_opening_10_0,
        );
    let alpha_right_link_frame_2_of_opening_9_1 = alpha_right_link_frame_2_of_opening_4_1
        - alpha_right_link_frame_2_of_opening_3_1 + alpha_right_link_frame_2_of_opening_1
        - alpha_right_link_frame_2_of_opening_5_1;
    let alpha_right_link_frame_2_of_opening_10_1 = alpha_right_link_frame_2_of_opening_9_1
        .mul_add(
            w_right_arm_frame_2_of_opening_3_0,
            w_right_arm_frame_2_of_opening_3_1 * alpha_right_link_frame_2_of_opening_9_0,
        );
    let alpha_right_link_frame_2_of_opening_11_1 = -alpha_right_link_frame_2_of_opening_7_1
        + alpha_right_link_frame_2_of_opening_6_1 + alpha_right_link_frame_2_of_opening_8_1
        - alpha_right_link_frame_2_of_opening_10_1 - alpha_right_arm_frame_2_of_opening_12_1;
    let w_right_link_frame_11_of_place_1 = w_right_arm_frame_in_right_link_frame_1_of_place_1
        * (w_right_arm_frame_in_right_link_frame_1_of_place_0
            + w_right_arm_frame_in_right_link_frame_1_of_place_0);
    let w_right_link_frame_13_of_place_1 = w_right_arm_frame_in_right_link_frame_3_of_place_1
        .mul_add(
            w_right_arm_frame_in_right_link_frame_1_of_place_0,
            w_right_arm_frame_in_right_link_frame_1_of_place_1
                * w_right_arm_frame_in_right_link_frame_3_of_place_0,
        );
    let w_right_link_frame_22_of_opening_1 = w_right_link_frame_2_of_opening_2_1
        * (w_right_link_frame_2_of_opening_2_0 + w_right_link_frame_2_of_opening_2_0);
    let a_left_link_centre_1_of_place_1 = w_left_arm_frame_13_of_spin_1
        .mul_add(l, minus_g * sin_theta_1);
    let a_left_link_centre_3_of_place_1 = spin_sq_sin_theta_sq_1
        .mul_add(l, opening_sq_1.mul_add(l, g * cos_theta_1));
    let a_left_arm_frame_in_left_link_frame_1_of_place_1 = a_left_link_centre_3_of_place_1
        .mul_add(sin_q_left_ball_0, sin_q_left_ball_1 * a_left_link_centre_3_of_place_0);
    let a_left_arm_frame_in_left_link_frame_1_of_place_2_1 = a_left_link_centre_1_of_place_1
        .mul_add(cos_q_left_ball_0, cos_q_left_ball_1 * a_left_link_centre_1_of_place_0);
    let a_left_arm_frame_in_left_link_frame_3_of_place_1 = a_left_link_centre_3_of_place_1
        .mul_add(cos_q_left_ball_0, cos_q_left_ball_1 * a_left_link_centre_3_of_place_0);
    let a_left_arm_frame_in_left_link_frame_3_of_place_2_1 = a_left_link_centre_1_of_place_1
        .mul_add(sin_q_left_ball_0, sin_q_left_ball_1 * a_left_link_centre_1_of_place_0);
    let a_left_link_centre_1_2_of_place_1 = alpha_left_link_frame_2_of_opening_4_1
        .mul_add(
            l,
            w_left_link_frame_13_of_place_1
                .mul_add(
                    l,
                    a_left_arm_frame_in_left_link_frame_1_of_place_2_1
                        .mul_add(
                            S::int(2),
                            -S::int(2) * a_left_arm_frame_in_left_link_frame_1_of_place_1,
                        ),
                ),
        );
    let a_left_link_centre_3_2_of_place_1 = w_left_link_frame_22_of_opening_1
        .mul_add(
            l,
            w_left_link_frame_11_of_place_1
                .mul_add(
                    l,
                    a_left_arm_frame_in_left_link_frame_3_of_place_2_1
                        .mul_add(
                            S::int(2),
                            S::int(2) * a_left_arm_frame_in_left_link_frame_3_of_place_1,
                        ),
                ),
        );
    let a_right_link_centre_1_of_place_1 = turn_right_arm_frame_13_of_place_1
        .mul_add(l, g * sin_q_right_top_1);
    let a_right_link_centre_3_of_place_1 = w_right_arm_frame_22_of_opening_1
        .mul_add(l, w_right_arm_frame_11_of_spin_1.mul_add(l, g * cos_q_right_top_1));
    let a_right_arm_frame_in_right_link_frame_1_of_place_1 = a_right_link_centre_3_of_place_1
        .mul_add(
            sin_q_right_ball_0,
            sin_q_right_ball_1 * a_right_link_centre_3_of_place_0,
        );
    let a_right_arm_frame_in_right_link_frame_1_of_place_2_1 = a_right_link_centre_1_of_place_1
        .mul_add(
            cos_q_right_ball_0,
            cos_q_right_ball_1 * a_right_link_centre_1_of_place_0,
        );
    let a_right_arm_frame_in_right_link_frame_3_of_place_1 = a_right_link_centre_3_of_place_1
        .mul_add(
            cos_q_right_ball_0,
            cos_q_right_ball_1 * a_right_link_centre_3_of_place_0,
        );
    let a_right_arm_frame_in_right_link_frame_3_of_place_2_1 = a_right_link_centre_1_of_place_1
        .mul_add(
            sin_q_right_ball_0,
            sin_q_right_ball_1 * a_right_link_centre_1_of_place_0,
        );
    let a_right_link_centre_1_2_of_place_1 = a_right_arm_frame_in_right_link_frame_1_of_place_2_1
        .mul_add(
            -S::int(2),
            alpha_right_link_frame_2_of_opening_11_1
                .mul_add(
                    l,
                    a_right_arm_frame_in_right_link_frame_1_of_place_1
                        .mul_add(-S::int(2), l * w_right_link_frame_13_of_place_1),
                ),
        );
    let a_right_link_centre_3_2_of_place_1 = a_right_arm_frame_in_right_link_frame_3_of_place_2_1
        .mul_add(
            -S::int(2),
            a_right_arm_frame_in_right_link_frame_3_of_place_1
                .mul_add(
                    S::int(2),
                    w_right_link_frame_22_of_opening_1
                        .mul_add(l, l * w_right_link_frame_11_of_place_1),
                ),
        );
    let opening_sq_cos_theta_1 = opening_sq_1
        .mul_add(cos_theta_0, cos_theta_1 * opening_sq_0);
    let a_sleeve_centre_3_of_opening_1 = w_left_link_frame_2_of_opening_2_1
        .mul_add(
            cos_theta_plus_q_left_ball_0,
            cos_theta_plus_q_left_ball_1 * w_left_link_frame_2_of_opening_2_0,
        );
    let a_sleeve_centre_3_of_opening_2_1 = a_sleeve_centre_3_of_opening_1
        .mul_add(
            w_left_link_frame_2_of_opening_2_0,
            w_left_link_frame_2_of_opening_2_1 * a_sleeve_centre_3_of_opening_0,
        );
    let a_sleeve_centre_3_of_opening_3_1 = alpha_left_link_frame_2_of_opening_4_1
        .mul_add(
            sin_theta_plus_q_left_ball_0,
            sin_theta_plus_q_left_ball_1 * alpha_left_link_frame_2_of_opening_4_0,
        );
    let a_sleeve_centre_3_of_opening_4_1 = a_sleeve_centre_3_of_opening_3_1
        .mul_add(
            minus_l,
            a_sleeve_centre_3_of_opening_2_1.mul_add(l, l * opening_sq_cos_theta_1),
        );
    let F_w_right_link_frame_2_of_place_1 = w_right_arm_frame_in_right_link_frame_1_of_place_1
        .mul_add(
            w_right_arm_frame_in_right_link_frame_3_of_place_0,
            w_right_arm_frame_in_right_link_frame_3_of_place_1
                * w_right_arm_frame_in_right_link_frame_1_of_place_0,
        );
    let F_w_right_link_frame_2_of_place_2_1 = a_right_link_centre_1_2_of_place_1
        .mul_add(
            weight,
            alpha_right_link_frame_2_of_opening_11_1
                .mul_add(l_2_m, l_2_m * F_w_right_link_frame_2_of_place_1),
        );
    let F_w_left_link_frame_2_of_place_1 = w_left_arm_frame_in_left_link_frame_1_of_place_1
        .mul_add(
            w_left_arm_frame_in_left_link_frame_3_of_place_0,
            w_left_arm_frame_in_left_link_frame_3_of_place_1
                * w_left_arm_frame_in_left_link_frame_1_of_place_0,
        );
    let F_w_right_arm_frame_2_of_spin_1 = spin_sin_q_right_top_1
        .mul_add(
            spin_cos_q_right_top_0,
            spin_cos_q_right_top_1 * spin_sin_q_right_top_0,
        );
    let F_w_right_arm_frame_2_of_place_1 = a_right_link_centre_3_2_of_place_1
        .mul_add(
            sin_q_right_ball_0,
            sin_q_right_ball_1 * a_right_link_centre_3_2_of_place_0,
        );
    let F_w_right_arm_frame_2_of_place_2_1 = a_right_link_centre_1_2_of_place_1
        .mul_add(
            cos_q_right_ball_0,
            cos_q_right_ball_1 * a_right_link_centre_1_2_of_place_0,
        );
    let F_w_right_arm_frame_2_of_place_3_1 = F_w_right_arm_frame_2_of_place_2_1
        .mul_add(
            weight_4,
            F_w_right_arm_frame_2_of_place_1
                .mul_add(
                    weight_4,
                    a_right_link_centre_1_of_place_1
                        .mul_add(
                            minus_12_l_mb,
                            turn_right_arm_frame_13_of_place_1
                                .mul_add(
                                    minus_3_l_2_m,
                                    alpha_right_arm_frame_2_of_opening_12_1
                                        .mul_add(
                                            minus_l_2_m,
                                            F_w_right_arm_frame_2_of_spin_1
                                                .mul_add(l_2_m, minus_6_l_m_g * sin_q_right_top_1),
                                        ),
                                ),
                        ) + F_w_right_link_frame_2_of_place_2_1,
                ),
        );
    let sin_q_right_ball_sq_1 = sin_q_right_ball_1 * (sin_q_right_ball_0 + sin_q_right_ball_0);
    let J_right_link_frame_in_right_arm_frame_13_of_q_right_ball_1 = sin_q_right_ball_1
        .mul_add(cos_q_right_ball_0, cos_q_right_ball_1 * sin_q_right_ball_0);
    let sin_q_left_ball_sq_1 = sin_q_left_ball_1 * (sin_q_left_ball_0 + sin_q_left_ball_0);
    let J_left_link_frame_in_left_arm_frame_13_of_q_left_ball_1 = sin_q_left_ball_1
        .mul_add(cos_q_left_ball_0, cos_q_left_ball_1 * sin_q_left_ball_0);
    let J_right_arm_frame_13_of_place_1 = J_right_link_frame_in_right_arm_frame_13_of_q_right_ball_1
        .mul_add(weight_5, weight_6 * sin_q_right_ball_1);
    let J_right_arm_frame_in_spindle_frame_31_of_place_1 = sin_q_right_ball_sq_1
        .mul_add(weight_8, minus_12_l_2_m * cos_q_right_ball_1);
    let J_right_arm_frame_in_spindle_frame_of_place_1 = J_right_arm_frame_in_spindle_frame_31_of_place_1
        .mul_add(
            sin_q_right_top_0,
            sin_q_right_top_1 * J_right_arm_frame_in_spindle_frame_31_of_place_0,
        );
    let J_right_arm_frame_in_spindle_frame_of_place_2_1 = J_right_arm_frame_13_of_place_1
        .mul_add(cos_q_right_top_0, cos_q_right_top_1 * J_right_arm_frame_13_of_place_0);
    let J_right_arm_frame_in_spindle_frame_of_place_3_1 = J_right_arm_frame_in_spindle_frame_of_place_2_1
        .mul_add(-S::int(2), J_right_arm_frame_in_spindle_frame_of_place_1);
    let J_right_arm_frame_in_spindle_frame_2_of_place_1 = J_right_arm_frame_in_spindle_frame_of_place_3_1
        .mul_add(
            sin_q_right_top_0,
            sin_q_right_top_1 * J_right_arm_frame_in_spindle_frame_of_place_3_0,
        );
    let J_left_arm_frame_13_of_place_1 = J_left_link_frame_in_left_arm_frame_13_of_q_left_ball_1
        .mul_add(weight_5, weight_6 * sin_q_left_ball_1);
    let J_left_arm_frame_in_spindle_frame_31_of_place_1 = sin_q_left_ball_sq_1
        .mul_add(weight_8, minus_12_l_2_m * cos_q_left_ball_1);
    let J_left_arm_frame_in_spindle_frame_of_place_1 = J_left_arm_frame_in_spindle_frame_31_of_place_1
        .mul_add(
            sin_theta_0,
            sin_theta_1 * J_left_arm_frame_in_spindle_frame_31_of_place_0,
        );
    let J_left_arm_frame_in_spindle_frame_of_place_2_1 = J_left_arm_frame_13_of_place_1
        .mul_add(cos_theta_0, cos_theta_1 * J_left_arm_frame_13_of_place_0);
    let J_left_arm_frame_in_spindle_frame_of_place_3_1 = J_left_arm_frame_in_spindle_frame_of_place_2_1
        .mul_add(-S::int(2), J_left_arm_frame_in_spindle_frame_of_place_1);
    let J_left_arm_frame_in_spindle_frame_2_of_place_1 = J_left_arm_frame_in_spindle_frame_of_place_3_1
        .mul_add(
            sin_theta_0,
            sin_theta_1 * J_left_arm_frame_in_spindle_frame_of_place_3_0,
        );
    let J_spindle_frame_33_2_of_place_1 = sin_q_left_ball_sq_1
        .mul_add(weight_5, weight_5 * sin_q_right_ball_sq_1)
        - J_right_arm_frame_in_spindle_frame_2_of_place_1
        - J_left_arm_frame_in_spindle_frame_2_of_place_1;
    let d2_of_place_1 = sin_q_left_ball_1
        .mul_add(sin_theta_0, sin_theta_1 * sin_q_left_ball_0);
    let d2_of_place_2_1 = cos_q_left_ball_1
        .mul_add(cos_theta_0, cos_theta_1 * cos_q_left_ball_0);
    let d2_of_place_3_1 = d2_of_place_1 - d2_of_place_2_1;
    let cos_theta_sq_1 = cos_theta_1 * (cos_theta_0 + cos_theta_0);
    let sin_q_right_ball_sq_2_1 = sin_q_right_ball_1 * (sin_q_right_ball_0 + sin_q_right_ball_0);
    let sin_q_right_ball_inv2_1 = -sin_q_right_ball_sq_2_1
        * (sin_q_right_ball_inv2_0 * over_sin_q_right_ball_sq_2);
    let d2_of_place_4_1 = weight_10 * sin_q_right_ball_inv2_1;
    let d2_of_place_5_1 = d2_of_place_4_1
        .mul_add(cos_q_right_top_0, cos_q_right_top_1 * d2_of_place_4_0);
    let d2_of_place_6_1 = alpha_right_arm_frame_2_of_q_right_ball_1
        .mul_add(
            sin_q_right_top_0,
            sin_q_right_top_1 * alpha_right_arm_frame_2_of_q_right_ball_0,
        );
    let d2_of_place_7_1 = minus_5_m_minus_6_mb * d2_of_place_6_1 + d2_of_place_5_1;
    let d2_of_place_8_1 = d2_of_place_7_1
        .mul_add(cos_q_right_top_0, cos_q_right_top_1 * d2_of_place_7_0);
    let d2_of_place_9_1 = minus_5_m_minus_6_mb * cos_theta_sq_1 + d2_of_place_8_1;
    let d2_of_place_10_1 = d2_of_place_9_1
        .mul_add(sin_q_left_ball_0, sin_q_left_ball_1 * d2_of_place_9_0);
    let d2_of_place_11_1 = d2_of_place_2_1
        .mul_add(sin_theta_0, sin_theta_1 * d2_of_place_2_0);
    let d2_of_place_12_1 = minus_5_m_minus_6_mb * d2_of_place_11_1 + d2_of_place_10_1;
    let d2_of_place_13_1 = d2_of_place_12_1
        .mul_add(sin_q_left_ball_0, sin_q_left_ball_1 * d2_of_place_12_0);
    let d2_of_place_14_1 = weight_10 * cos_theta_sq_1 + d2_of_place_13_1;
    let d2_of_place_15_1 = d2_of_place_3_1 * (d2_of_place_3_0 + d2_of_place_3_0);
    let d2_of_place_16_1 = d2_of_place_15_1
        .mul_add(
            -(d2_of_place_16_0 * over_d2_of_place_15),
            d2_of_place_14_1 * over_d2_of_place_15,
        );
    let opening_dot_of_spin_1 = spin_sin_theta_1
        .mul_add(spin_cos_theta_0, spin_cos_theta_1 * spin_sin_theta_0);
    let opening_dot_of_place_1 = F_w_right_link_frame_2_of_place_2_1
        .mul_add(
            w_right_link_frame_2_of_place_0,
            w_right_link_frame_2_of_place_1 * F_w_right_link_frame_2_of_place_2_0,
        );
    let opening_dot_of_place_2_1 = F_w_right_arm_frame_2_of_place_3_1
        .mul_add(cos_angle_0, cos_angle_1 * F_w_right_arm_frame_2_of_place_3_0);
    let opening_dot_of_place_3_1 = opening_dot_of_place_1 - opening_dot_of_place_2_1;
    let opening_dot_of_place_4_1 = sin_q_right_ball_1
        .mul_add(
            -(opening_dot_of_place_4_0 * over_sin_q_right_ball),
            opening_dot_of_place_3_1 * over_sin_q_right_ball,
        );
    let opening_dot_of_place_5_1 = F_w_right_link_frame_2_of_place_2_1
        .mul_add(
            sin_q_right_top_0,
            sin_q_right_top_1 * F_w_right_link_frame_2_of_place_2_0,
        );
    let opening_dot_of_place_6_1 = -opening_dot_of_place_5_1 + opening_dot_of_place_4_1;
    let opening_dot_of_place_7_1 = opening_dot_of_place_6_1
        .mul_add(sin_q_left_ball_0, sin_q_left_ball_1 * opening_dot_of_place_6_0);
    let opening_dot_of_opening_1 = a_sleeve_centre_3_of_opening_4_1
        .mul_add(
            sin_theta_plus_q_left_ball_0,
            sin_theta_plus_q_left_ball_1 * a_sleeve_centre_3_of_opening_4_0,
        );
    let opening_dot_of_place_8_1 = opening_dot_of_opening_1
        .mul_add(
            minus_12_l_ms,
            a_left_link_centre_1_2_of_place_1
                .mul_add(
                    weight,
                    alpha_left_link_frame_2_of_opening_4_1
                        .mul_add(l_2_m, l_2_m * F_w_left_link_frame_2_of_place_1),
                ),
        );
    let opening_dot_of_place_9_1 = opening_dot_of_place_8_1
        .mul_add(cos_theta_0, cos_theta_1 * opening_dot_of_place_8_0);
    let opening_dot_of_place_10_1 = opening_dot_of_place_9_1 + opening_dot_of_place_7_1;
    let opening_dot_of_place_11_1 = cos_theta_plus_q_left_ball_1
        .mul_add(
            -(opening_dot_of_place_11_0 * over_cos_theta_plus_q_left_ball),
            opening_dot_of_place_10_1 * over_cos_theta_plus_q_left_ball,
        );
    let opening_dot_of_opening_2_1 = a_sleeve_centre_3_of_opening_4_1
        .mul_add(sin_theta_0, sin_theta_1 * a_sleeve_centre_3_of_opening_4_0);
    let opening_dot_of_place_12_1 = a_left_link_centre_3_2_of_place_1
        .mul_add(
            sin_q_left_ball_0,
            sin_q_left_ball_1 * a_left_link_centre_3_2_of_place_0,
        );
    let opening_dot_of_place_13_1 = a_left_link_centre_1_2_of_place_1
        .mul_add(
            cos_q_left_ball_0,
            cos_q_left_ball_1 * a_left_link_centre_1_2_of_place_0,
        );
    let opening_dot_of_place_14_1 = opening_dot_of_opening_2_1
        .mul_add(
            minus_12_l_ms,
            opening_dot_of_place_13_1
                .mul_add(
                    weight_4,
                    opening_dot_of_place_12_1
                        .mul_add(
                            weight_4,
                            a_left_link_centre_1_of_place_1
                                .mul_add(
                                    weight_13,
                                    w_left_arm_frame_13_of_spin_1
                                        .mul_add(
                                            weight_12,
                                            opening_dot_of_spin_1
                                                .mul_add(l_2_m, minus_6_l_m_g * sin_theta_1),
                                        ),
                                ),
                        ),
                ),
        ) - opening_dot_of_place_11_1;
    let opening_dot_of_place_15_1 = d2_of_place_16_1
        .mul_add(
            -(opening_dot_of_place_15_0 * over_d2_of_place_16),
            opening_dot_of_place_14_1 * over_d2_of_place_16,
        );
    let spin_dot_of_place_1 = F_w_spindle_frame_in_right_arm_frame_3_of_place_3_1
        .mul_add(
            cos_q_right_top_0,
            cos_q_right_top_1 * F_w_spindle_frame_in_right_arm_frame_3_of_place_3_0,
        );
    let spin_dot_of_place_2_1 = F_w_spindle_frame_in_right_arm_frame_1_of_place_3_1
        .mul_add(
            sin_q_right_top_0,
            sin_q_right_top_1 * F_w_spindle_frame_in_right_arm_frame_1_of_place_3_0,
        );
    let spin_dot_of_opening_1 = F_w_spindle_frame_in_left_arm_frame_3_of_opening_1
        .mul_add(
            cos_theta_0,
            cos_theta_1 * F_w_spindle_frame_in_left_arm_frame_3_of_opening_0,
        );
    let spin_dot_of_place_3_1 = F_w_spindle_frame_in_left_arm_frame_1_of_place_3_1
        .mul_add(
            sin_theta_0,
            sin_theta_1 * F_w_spindle_frame_in_left_arm_frame_1_of_place_3_0,
        );
    let spin_dot_of_place_4_1 = spin_dot_of_opening_1 - spin_dot_of_place_3_1
        + spin_dot_of_place_1 - spin_dot_of_place_2_1;
    let spin_dot_2_1 = J_spindle_frame_33_2_of_place_1
        .mul_add(
            -(spin_dot_2_0 * over_J_spindle_frame_33_2_of_place),
            spin_dot_of_place_4_1 * over_J_spindle_frame_33_2_of_place,
        );
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            [
                theta_1, theta_1, spin_1, spin_1, q_right_top_1, q_right_top_1, spin_1, spin_1,
                theta_plus_q_left_ball_1, theta_plus_q_left_ball_1, q_left_ball_1, q_left_ball_1,
                w_right_arm_frame_2_of_place_1, w_right_arm_frame_2_of_place_1, q_right_ball_1,
                q_right_ball_1, cos_theta_plus_q_left_ball_1, sin_q_left_ball_1, sin_q_right_ball_1,
                cos_angle_1, sin_q_left_ball_1, cos_q_left_ball_1, cos_q_left_ball_1,
                sin_q_left_ball_1, w_left_link_frame_2_of_place_1, sin_q_right_ball_1,
                cos_q_right_ball_1, cos_q_right_ball_1, sin_q_right_ball_1, cos_q_right_top_1,
                sin_q_right_top_1, w_right_link_frame_2_of_place_3_1, opening_1,
                spin_cos_q_right_top_1, spin_cos_q_right_top_1, opening_1, opening_1,
                w_left_arm_frame_in_left_link_frame_3_of_place_1,
                w_left_arm_frame_in_left_link_frame_3_of_place_1, cos_angle_1,
                w_right_arm_frame_2_of_opening_2_1, q_right_top_dot_2_1,
                w_right_arm_frame_in_right_link_frame_3_of_place_1,
                w_right_arm_frame_in_right_link_frame_3_of_place_1,
                w_right_arm_frame_in_right_link_frame_1_of_place_1,
                w_right_link_frame_2_of_opening_2_1,
                w_right_arm_frame_in_right_link_frame_3_of_place_1,
                w_left_arm_frame_in_left_link_frame_1_of_place_1,
                w_left_link_frame_2_of_opening_2_1,
                w_left_arm_frame_in_left_link_frame_3_of_place_1, spin_sin_q_right_top_1,
                q_right_top_dot_2_1, cos_q_right_ball_1, sin_q_right_ball_1, spin_cos_q_right_top_1,
                sin_q_right_ball_1, cos_q_right_ball_1, spin_sin_theta_1, opening_1,
                cos_q_left_ball_1, sin_q_left_ball_1, spin_cos_theta_1, sin_q_left_ball_1,
                cos_q_left_ball_1, spin_sin_theta_1, spin_sin_theta_1, opening_1,
                sin_theta_plus_q_left_ball_1, cos_theta_plus_q_left_ball_1, q_right_top_dot_2_1,
                sin_q_right_ball_1, w_right_arm_frame_2_of_opening_1,
                alpha_right_arm_frame_2_of_place_1, cos_angle_1, sin_angle_1,
                alpha_right_arm_frame_2_of_opening_1, sin_q_right_ball_1,
                w_right_link_frame_2_of_opening_1, q_right_top_dot_2_1, spin_sin_q_right_top_1,
                spin_sin_q_right_top_1, q_right_top_dot_2_1, opening_1,
                w_left_link_frame_2_of_opening_1, alpha_left_link_frame_2_of_opening_1,
                w_left_arm_frame_in_left_link_frame_1_of_place_1,
                w_left_arm_frame_in_left_link_frame_1_of_place_1,
                w_left_link_frame_2_of_opening_2_1, sin_q_right_top_1, q_right_top_dot_2_1,
                cos_q_right_top_1, w_right_link_frame_2_of_place_3_1, cos_angle_1,
                sin_q_right_top_1, w_right_link_frame_2_of_opening_1,
                w_right_link_frame_2_of_opening_1, w_right_link_frame_2_of_place_3_1,
                w_right_link_frame_2_of_opening_1, alpha_right_link_frame_2_of_opening_9_1,
                w_right_arm_frame_in_right_link_frame_1_of_place_1,
                w_right_arm_frame_in_right_link_frame_1_of_place_1,
                w_right_link_frame_2_of_opening_2_1, sin_q_left_ball_1, cos_q_left_ball_1,
                cos_q_left_ball_1, sin_q_left_ball_1, sin_q_right_ball_1, cos_q_right_ball_1,
                cos_q_right_ball_1, sin_q_right_ball_1, cos_theta_1, cos_theta_plus_q_left_ball_1,
                w_left_link_frame_2_of_opening_2_1, sin_theta_plus_q_left_ball_1,
                w_right_arm_frame_in_right_link_frame_3_of_place_1,
                w_left_arm_frame_in_left_link_frame_3_of_place_1, spin_cos_q_right_top_1,
                sin_q_right_ball_1, cos_q_right_ball_1, sin_q_right_ball_1, cos_q_right_ball_1,
                sin_q_left_ball_1, cos_q_left_ball_1, sin_q_right_top_1, cos_q_right_top_1,
                sin_q_right_top_1, sin_theta_1, cos_theta_1, sin_theta_1, sin_theta_1, cos_theta_1,
                cos_theta_1, sin_q_right_ball_1, sin_q_right_ball_sq_2_1, cos_q_right_top_1,
                sin_q_right_top_1, cos_q_right_top_1, sin_q_left_ball_1, sin_theta_1,
                sin_q_left_ball_1, d2_of_place_3_1, d2_of_place_15_1, spin_cos_theta_1,
                F_w_right_link_frame_2_of_place_2_1, cos_angle_1, sin_q_right_ball_1,
                sin_q_right_top_1, sin_q_left_ball_1, sin_theta_plus_q_left_ball_1, cos_theta_1,
                cos_theta_plus_q_left_ball_1, sin_theta_1, sin_q_left_ball_1, cos_q_left_ball_1,
                d2_of_place_16_1, cos_q_right_top_1, sin_q_right_top_1, cos_theta_1, sin_theta_1,
                J_spindle_frame_33_2_of_place_1,
            ],
            [
                cos_theta_1, sin_theta_1, sin_theta_1, cos_theta_1, cos_q_right_top_1,
                sin_q_right_top_1, sin_q_right_top_1, cos_q_right_top_1,
                cos_theta_plus_q_left_ball_1, sin_theta_plus_q_left_ball_1, cos_q_left_ball_1,
                sin_q_left_ball_1, cos_angle_1, sin_angle_1, cos_q_right_ball_1, sin_q_right_ball_1,
                w_right_arm_frame_2_of_opening_1, w_right_arm_frame_2_of_opening_1,
                w_right_arm_frame_2_of_opening_3_1, w_right_arm_frame_2_of_opening_3_1,
                spin_cos_theta_1, spin_sin_theta_1, spin_cos_theta_1, spin_sin_theta_1,
                w_right_arm_frame_2_of_opening_1, spin_cos_q_right_top_1, spin_sin_q_right_top_1,
                spin_cos_q_right_top_1, spin_sin_q_right_top_1,
                w_right_link_frame_2_of_q_right_ball_1, sin_q_right_ball_1,
                w_right_arm_frame_2_of_opening_3_1, spin_cos_theta_1, q_right_top_dot_2_1,
                q_right_top_dot_2_1, w_left_arm_frame_in_left_link_frame_3_of_spin_2_1,
                w_left_arm_frame_in_left_link_frame_3_of_spin_1, w_left_link_frame_2_of_opening_1,
                w_left_link_frame_2_of_opening_2_1, spin_sin_q_right_top_1,
                alpha_right_arm_frame_in_right_link_frame_1_of_spin_1,
                w_right_arm_frame_in_right_link_frame_3_of_spin_1,
                w_right_link_frame_2_of_opening_1, w_right_link_frame_2_of_opening_2_1,
                w_right_link_frame_2_of_opening_2_1,
                w_right_arm_frame_in_right_link_frame_1_of_place_1,
                w_right_link_frame_2_of_opening_2_1, w_left_link_frame_2_of_opening_2_1,
                w_left_arm_frame_in_left_link_frame_1_of_place_1,
                w_left_link_frame_2_of_opening_2_1, q_right_top_dot_2_1, spin_sin_q_right_top_1,
                F_w_right_arm_frame_in_right_link_frame_3_of_place_1,
                F_w_right_arm_frame_in_right_link_frame_1_of_place_1, q_right_top_dot_2_1,
                F_w_right_arm_frame_in_right_link_frame_3_of_place_1,
                F_w_right_arm_frame_in_right_link_frame_1_of_place_1, opening_1, spin_sin_theta_1,
                F_w_left_arm_frame_in_left_link_frame_3_of_place_1,
                F_w_left_arm_frame_in_left_link_frame_1_of_place_1, opening_1,
                F_w_left_arm_frame_in_left_link_frame_3_of_place_1,
                F_w_left_arm_frame_in_left_link_frame_1_of_place_1, spin_sin_theta_1,
                spin_cos_theta_1, opening_1, w_left_link_frame_2_of_opening_2_1,
                alpha_right_arm_frame_2_of_opening_3_1, alpha_right_arm_frame_2_of_opening_3_1,
                alpha_right_arm_frame_2_of_place_1, w_left_link_frame_2_of_opening_1,
                alpha_right_arm_frame_2_of_opening_5_1, alpha_right_arm_frame_2_of_opening_6_1,
                w_right_arm_frame_2_of_opening_3_1, alpha_right_arm_frame_2_of_opening_8_1,
                alpha_right_arm_frame_2_of_q_right_ball_1,
                alpha_right_arm_frame_2_of_q_right_ball_1, alpha_right_arm_frame_2_of_opening_10_1,
                spin_sin_q_right_top_1, spin_cos_q_right_top_1, q_right_top_dot_2_1, sin_theta_1,
                alpha_right_arm_frame_2_of_opening_3_1, w_right_arm_frame_2_of_opening_1,
                w_left_arm_frame_in_left_link_frame_1_of_place_1,
                w_left_arm_frame_in_left_link_frame_3_of_place_1,
                w_left_link_frame_2_of_opening_2_1, w_right_link_frame_2_of_q_right_ball_1,
                alpha_right_link_frame_2_of_place_1, w_right_arm_frame_2_of_opening_2_1,
                alpha_right_link_frame_2_of_opening_2_1, alpha_right_link_frame_2_of_opening_2_1,
                cos_q_right_ball_1, alpha_right_link_frame_2_of_place_2_1,
                alpha_right_arm_frame_2_of_opening_3_1, alpha_right_arm_frame_2_of_opening_6_1,
                alpha_right_arm_frame_2_of_opening_10_1, w_right_arm_frame_2_of_opening_3_1,
                w_right_arm_frame_in_right_link_frame_1_of_place_1,
                w_right_arm_frame_in_right_link_frame_3_of_place_1,
                w_right_link_frame_2_of_opening_2_1, a_left_link_centre_3_of_place_1,
                a_left_link_centre_1_of_place_1, a_left_link_centre_3_of_place_1,
                a_left_link_centre_1_of_place_1, a_right_link_centre_3_of_place_1,
                a_right_link_centre_1_of_place_1, a_right_link_centre_3_of_place_1,
                a_right_link_centre_1_of_place_1, opening_sq_1, w_left_link_frame_2_of_opening_2_1,
                a_sleeve_centre_3_of_opening_1, alpha_left_link_frame_2_of_opening_4_1,
                w_right_arm_frame_in_right_link_frame_1_of_place_1,
                w_left_arm_frame_in_left_link_frame_1_of_place_1, spin_sin_q_right_top_1,
                a_right_link_centre_3_2_of_place_1, a_right_link_centre_1_2_of_place_1,
                sin_q_right_ball_1, sin_q_right_ball_1, sin_q_left_ball_1, sin_q_left_ball_1,
                J_right_arm_frame_in_spindle_frame_31_of_place_1, J_right_arm_frame_13_of_place_1,
                J_right_arm_frame_in_spindle_frame_of_place_3_1,
                J_left_arm_frame_in_spindle_frame_31_of_place_1, J_left_arm_frame_13_of_place_1,
                J_left_arm_frame_in_spindle_frame_of_place_3_1, sin_q_left_ball_1,
                cos_q_left_ball_1, cos_theta_1, sin_q_right_ball_1, sin_q_right_ball_inv2_1,
                d2_of_place_4_1, alpha_right_arm_frame_2_of_q_right_ball_1, d2_of_place_7_1,
                d2_of_place_9_1, d2_of_place_2_1, d2_of_place_12_1, d2_of_place_3_1,
                d2_of_place_16_1, spin_sin_theta_1, w_right_link_frame_2_of_place_1,
                F_w_right_arm_frame_2_of_place_3_1, opening_dot_of_place_4_1,
                F_w_right_link_frame_2_of_place_2_1, opening_dot_of_place_6_1,
                a_sleeve_centre_3_of_opening_4_1, opening_dot_of_place_8_1,
                opening_dot_of_place_11_1, a_sleeve_centre_3_of_opening_4_1,
                a_left_link_centre_3_2_of_place_1, a_left_link_centre_1_2_of_place_1,
                opening_dot_of_place_15_1, F_w_spindle_frame_in_right_arm_frame_3_of_place_3_1,
                F_w_spindle_frame_in_right_arm_frame_1_of_place_3_1,
                F_w_spindle_frame_in_left_arm_frame_3_of_opening_1,
                F_w_spindle_frame_in_left_arm_frame_1_of_place_3_1, spin_dot_2_1,
            ],
        ];
    }
    let mut count_last = S::int(1);
    let mut theta_last = theta_1;
    let mut q_right_top_last = q_right_top_1;
    let mut q_left_ball_last = q_left_ball_1;
    let mut q_right_ball_last = q_right_ball_1;
    let mut spin_last = spin_1;
    let mut opening_last = opening_1;
    let mut sin_theta_last = sin_theta_1;
    let mut cos_theta_last = cos_theta_1;
    let mut spin_sin_theta_last = spin_sin_theta_1;
    let mut spin_cos_theta_last = spin_cos_theta_1;
    let mut sin_q_right_top_last = sin_q_right_top_1;
    let mut cos_q_right_top_last = cos_q_right_top_1;
    let mut spin_sin_q_right_top_last = spin_sin_q_right_top_1;
    let mut spin_cos_q_right_top_last = spin_cos_q_right_top_1;
    let mut theta_plus_q_left_ball_last = theta_plus_q_left_ball_1;
    let mut sin_theta_plus_q_left_ball_last = sin_theta_plus_q_left_ball_1;
    let mut cos_theta_plus_q_left_ball_last = cos_theta_plus_q_left_ball_1;
    let mut sin_q_left_ball_last = sin_q_left_ball_1;
    let mut cos_q_left_ball_last = cos_q_left_ball_1;
    let mut w_right_arm_frame_2_of_place_last = w_right_arm_frame_2_of_place_1;
    let mut sin_angle_last = sin_angle_1;
    let mut cos_angle_last = cos_angle_1;
    let mut sin_q_right_ball_last = sin_q_right_ball_1;
    let mut cos_q_right_ball_last = cos_q_right_ball_1;
    let mut w_right_arm_frame_2_of_opening_last = w_right_arm_frame_2_of_opening_1;
    let mut w_right_arm_frame_2_of_opening_2_last = w_right_arm_frame_2_of_opening_2_1;
    let mut w_right_arm_frame_2_of_opening_3_last = w_right_arm_frame_2_of_opening_3_1;
    let mut q_right_top_dot_2_last = q_right_top_dot_2_1;
    let mut w_left_arm_frame_in_left_link_frame_1_of_place_last = w_left_arm_frame_in_left_link_frame_1_of_place_1;
    let mut w_left_arm_frame_in_left_link_frame_3_of_spin_last = w_left_arm_frame_in_left_link_frame_3_of_spin_1;
    let mut w_left_arm_frame_in_left_link_frame_3_of_spin_2_last = w_left_arm_frame_in_left_link_frame_3_of_spin_2_1;
    let mut w_left_arm_frame_in_left_link_frame_3_of_place_last = w_left_arm_frame_in_left_link_frame_3_of_place_1;
    let mut w_left_link_frame_2_of_place_last = w_left_link_frame_2_of_place_1;
    let mut w_left_link_frame_2_of_opening_last = w_left_link_frame_2_of_opening_1;
    let mut w_left_link_frame_2_of_opening_2_last = w_left_link_frame_2_of_opening_2_1;
    let mut w_right_arm_frame_in_right_link_frame_1_of_place_last = w_right_arm_frame_in_right_link_frame_1_of_place_1;
    let mut w_right_arm_frame_in_right_link_frame_3_of_spin_last = w_right_arm_frame_in_right_link_frame_3_of_spin_1;
    let mut w_right_arm_frame_in_right_link_frame_3_of_place_last = w_right_arm_frame_in_right_link_frame_3_of_place_1;
    let mut w_right_link_frame_2_of_q_right_ball_last = w_right_link_frame_2_of_q_right_ball_1;
    let mut w_right_link_frame_2_of_place_last = w_right_link_frame_2_of_place_1;
    let mut w_right_link_frame_2_of_place_3_last = w_right_link_frame_2_of_place_3_1;
    let mut w_right_link_frame_2_of_opening_last = w_right_link_frame_2_of_opening_1;
    let mut w_right_link_frame_2_of_opening_2_last = w_right_link_frame_2_of_opening_2_1;
    let mut alpha_right_arm_frame_in_right_link_frame_1_of_spin_last = alpha_right_arm_frame_in_right_link_frame_1_of_spin_1;
    let mut F_w_right_arm_frame_in_right_link_frame_3_of_place_last = F_w_right_arm_frame_in_right_link_frame_3_of_place_1;
    let mut F_w_right_arm_frame_in_right_link_frame_1_of_place_last = F_w_right_arm_frame_in_right_link_frame_1_of_place_1;
    let mut F_w_left_arm_frame_in_left_link_frame_3_of_place_last = F_w_left_arm_frame_in_left_link_frame_3_of_place_1;
    let mut F_w_left_arm_frame_in_left_link_frame_1_of_place_last = F_w_left_arm_frame_in_left_link_frame_1_of_place_1;
    let mut F_w_spindle_frame_in_right_arm_frame_3_of_place_3_last = F_w_spindle_frame_in_right_arm_frame_3_of_place_3_1;
    let mut F_w_spindle_frame_in_right_arm_frame_1_of_place_3_last = F_w_spindle_frame_in_right_arm_frame_1_of_place_3_1;
    let mut F_w_spindle_frame_in_left_arm_frame_3_of_opening_last = F_w_spindle_frame_in_left_arm_frame_3_of_opening_1;
    let mut F_w_spindle_frame_in_left_arm_frame_1_of_place_3_last = F_w_spindle_frame_in_left_arm_frame_1_of_place_3_1;
    let mut opening_sq_last = opening_sq_1;
    let mut alpha_right_arm_frame_2_of_opening_last = alpha_right_arm_frame_2_of_opening_1;
    let mut alpha_right_arm_frame_2_of_opening_3_last = alpha_right_arm_frame_2_of_opening_3_1;
    let mut alpha_right_arm_frame_2_of_place_last = alpha_right_arm_frame_2_of_place_1;
    let mut alpha_right_arm_frame_2_of_opening_5_last = alpha_right_arm_frame_2_of_opening_5_1;
    let mut alpha_right_arm_frame_2_of_opening_6_last = alpha_right_arm_frame_2_of_opening_6_1;
    let mut alpha_right_arm_frame_2_of_opening_8_last = alpha_right_arm_frame_2_of_opening_8_1;
    let mut alpha_right_arm_frame_2_of_q_right_ball_last = alpha_right_arm_frame_2_of_q_right_ball_1;
    let mut alpha_right_arm_frame_2_of_opening_10_last = alpha_right_arm_frame_2_of_opening_10_1;
    let mut alpha_left_link_frame_2_of_opening_last = alpha_left_link_frame_2_of_opening_1;
    let mut alpha_left_link_frame_2_of_opening_4_last = alpha_left_link_frame_2_of_opening_4_1;
    let mut alpha_right_link_frame_2_of_place_last = alpha_right_link_frame_2_of_place_1;
    let mut alpha_right_link_frame_2_of_opening_2_last = alpha_right_link_frame_2_of_opening_2_1;
    let mut alpha_right_link_frame_2_of_place_2_last = alpha_right_link_frame_2_of_place_2_1;
    let mut alpha_right_link_frame_2_of_opening_9_last = alpha_right_link_frame_2_of_opening_9_1;
    let mut a_left_link_centre_1_of_place_last = a_left_link_centre_1_of_place_1;
    let mut a_left_link_centre_3_of_place_last = a_left_link_centre_3_of_place_1;
    let mut a_left_link_centre_1_2_of_place_last = a_left_link_centre_1_2_of_place_1;
    let mut a_left_link_centre_3_2_of_place_last = a_left_link_centre_3_2_of_place_1;
    let mut a_right_link_centre_1_of_place_last = a_right_link_centre_1_of_place_1;
    let mut a_right_link_centre_3_of_place_last = a_right_link_centre_3_of_place_1;
    let mut a_right_link_centre_1_2_of_place_last = a_right_link_centre_1_2_of_place_1;
    let mut a_right_link_centre_3_2_of_place_last = a_right_link_centre_3_2_of_place_1;
    let mut a_sleeve_centre_3_of_opening_last = a_sleeve_centre_3_of_opening_1;
    let mut a_sleeve_centre_3_of_opening_4_last = a_sleeve_centre_3_of_opening_4_1;
    let mut F_w_right_link_frame_2_of_place_2_last = F_w_right_link_frame_2_of_place_2_1;
    let mut F_w_right_arm_frame_2_of_place_3_last = F_w_right_arm_frame_2_of_place_3_1;
    let mut J_right_arm_frame_13_of_place_last = J_right_arm_frame_13_of_place_1;
    let mut J_right_arm_frame_in_spindle_frame_31_of_place_last = J_right_arm_frame_in_spindle_frame_31_of_place_1;
    let mut J_right_arm_frame_in_spindle_frame_of_place_3_last = J_right_arm_frame_in_spindle_frame_of_place_3_1;
    let mut J_left_arm_frame_13_of_place_last = J_left_arm_frame_13_of_place_1;
    let mut J_left_arm_frame_in_spindle_frame_31_of_place_last = J_left_arm_frame_in_spindle_frame_31_of_place_1;
    let mut J_left_arm_frame_in_spindle_frame_of_place_3_last = J_left_arm_frame_in_spindle_frame_of_place_3_1;
    let mut J_spindle_frame_33_2_of_place_last = J_spindle_frame_33_2_of_place_1;
    let mut d2_of_place_2_last = d2_of_place_2_1;
    let mut d2_of_place_3_last = d2_of_place_3_1;
    let mut sin_q_right_ball_sq_2_last = sin_q_right_ball_sq_2_1;
    let mut sin_q_right_ball_inv2_last = sin_q_right_ball_inv2_1;
    let mut d2_of_place_4_last = d2_of_place_4_1;
    let mut d2_of_place_7_last = d2_of_place_7_1;
    let mut d2_of_place_9_last = d2_of_place_9_1;
    let mut d2_of_place_12_last = d2_of_place_12_1;
    let mut d2_of_place_15_last = d2_of_place_15_1;
    let mut d2_of_place_16_last = d2_of_place_16_1;
    let mut opening_dot_of_place_4_last = opening_dot_of_place_4_1;
    let mut opening_dot_of_place_6_last = opening_dot_of_place_6_1;
    let mut opening_dot_of_place_8_last = opening_dot_of_place_8_1;
    let mut opening_dot_of_place_11_last = opening_dot_of_place_11_1;
    let mut opening_dot_of_place_15_last = opening_dot_of_place_15_1;
    let mut spin_dot_2_last = spin_dot_2_1;
    let mut next = [S::int(0); 160];
    // Rates at order k - 1.
    let mut psi_rate = spin_1;
    let mut theta_rate = opening_1;
    let mut q_right_top_rate = q_right_top_dot_2_1;
    let mut q_left_ball_rate = -w_left_link_frame_2_of_opening_1;
    let mut q_right_ball_rate = -w_right_link_frame_2_of_opening_1;
    let mut spin_rate = spin_dot_2_1;
    let mut opening_rate = weight_14 * opening_dot_of_place_15_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let psi = psi_rate * over_k;
        let theta = theta_rate * over_k;
        let q_right_top = q_right_top_rate * over_k;
        let q_left_ball = q_left_ball_rate * over_k;
        let q_right_ball = q_right_ball_rate * over_k;
        let spin = spin_rate * over_k;
        let opening = opening_rate * over_k;
        series[order] = [
            psi, theta, q_right_top, q_left_ball, q_right_ball, spin, opening,
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
            [
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
                spin_1.mul_add(sin_theta_last, spin_last.mul_add(sin_theta_1, next[2])),
                spin_1.mul_add(cos_theta_last, spin_last.mul_add(cos_theta_1, next[3])),
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
                spin_1
                    .mul_add(
                        sin_q_right_top_last,
                        spin_last.mul_add(sin_q_right_top_1, next[6]),
                    ),
                spin_1
                    .mul_add(
                        cos_q_right_top_last,
                        spin_last.mul_add(cos_q_right_top_1, next[7]),
                    ),
                theta_plus_q_left_ball_1
                    .mul_add(
                        cos_theta_plus_q_left_ball_last,
                        (count_last * theta_plus_q_left_ball_last)
                            .mul_add(cos_theta_plus_q_left_ball_1, next[8]),
                    ),
                theta_plus_q_left_ball_1
                    .mul_add(
                        sin_theta_plus_q_left_ball_last,
                        (count_last * theta_plus_q_left_ball_last)
                            .mul_add(sin_theta_plus_q_left_ball_1, next[9]),
                    ),
                q_left_ball_1
                    .mul_add(
                        cos_q_left_ball_last,
                        (count_last * q_left_ball_last)
                            .mul_add(cos_q_left_ball_1, next[10]),
                    ),
                q_left_ball_1
                    .mul_add(
                        sin_q_left_ball_last,
                        (count_last * q_left_ball_last)
                            .mul_add(sin_q_left_ball_1, next[11]),
                    ),
                w_right_arm_frame_2_of_place_1
                    .mul_add(
                        cos_angle_last,
                        (count_last * w_right_arm_frame_2_of_place_last)
                            .mul_add(cos_angle_1, next[12]),
                    ),
                w_right_arm_frame_2_of_place_1
                    .mul_add(
                        sin_angle_last,
                        (count_last * w_right_arm_frame_2_of_place_last)
                            .mul_add(sin_angle_1, next[13]),
                    ),
                q_right_ball_1
                    .mul_add(
                        cos_q_right_ball_last,
                        (count_last * q_right_ball_last)
                            .mul_add(cos_q_right_ball_1, next[14]),
                    ),
                q_right_ball_1
                    .mul_add(
                        sin_q_right_ball_last,
                        (count_last * q_right_ball_last)
                            .mul_add(sin_q_right_ball_1, next[15]),
                    ),
                cos_theta_plus_q_left_ball_1
                    .mul_add(
                        w_right_arm_frame_2_of_opening_last,
                        cos_theta_plus_q_left_ball_last
                            .mul_add(w_right_arm_frame_2_of_opening_1, next[16]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        w_right_arm_frame_2_of_opening_last,
                        sin_q_left_ball_last
                            .mul_add(w_right_arm_frame_2_of_opening_1, next[17]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        w_right_arm_frame_2_of_opening_3_last,
                        sin_q_right_ball_last
                            .mul_add(w_right_arm_frame_2_of_opening_3_1, next[18]),
                    ),
                cos_angle_1
                    .mul_add(
                        w_right_arm_frame_2_of_opening_3_last,
                        cos_angle_last
                            .mul_add(w_right_arm_frame_2_of_opening_3_1, next[19]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        spin_cos_theta_last,
                        sin_q_left_ball_last.mul_add(spin_cos_theta_1, next[20]),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        spin_sin_theta_last,
                        cos_q_left_ball_last.mul_add(spin_sin_theta_1, next[21]),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        spin_cos_theta_last,
                        cos_q_left_ball_last.mul_add(spin_cos_theta_1, next[22]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        spin_sin_theta_last,
                        sin_q_left_ball_last.mul_add(spin_sin_theta_1, next[23]),
                    ),
                w_left_link_frame_2_of_place_1
                    .mul_add(
                        w_right_arm_frame_2_of_opening_last,
                        w_left_link_frame_2_of_place_last
                            .mul_add(w_right_arm_frame_2_of_opening_1, next[24]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        spin_cos_q_right_top_last,
                        sin_q_right_ball_last.mul_add(spin_cos_q_right_top_1, next[25]),
                    ),
                cos_q_right_ball_1
                    .mul_add(
                        spin_sin_q_right_top_last,
                        cos_q_right_ball_last.mul_add(spin_sin_q_right_top_1, next[26]),
                    ),
                cos_q_right_ball_1
                    .mul_add(
                        spin_cos_q_right_top_last,
                        cos_q_right_ball_last.mul_add(spin_cos_q_right_top_1, next[27]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        spin_sin_q_right_top_last,
                        sin_q_right_ball_last.mul_add(spin_sin_q_right_top_1, next[28]),
                    ),
                cos_q_right_top_1
                    .mul_add(
                        w_right_link_frame_2_of_q_right_ball_last,
                        cos_q_right_top_last
                            .mul_add(w_right_link_frame_2_of_q_right_ball_1, next[29]),
                    ),
                sin_q_right_top_1
                    .mul_add(
                        sin_q_right_ball_last,
                        sin_q_right_top_last.mul_add(sin_q_right_ball_1, next[30]),
                    ),
                w_right_link_frame_2_of_place_3_1
                    .mul_add(
                        w_right_arm_frame_2_of_opening_3_last,
                        w_right_link_frame_2_of_place_3_last
                            .mul_add(w_right_arm_frame_2_of_opening_3_1, next[31]),
                    ),
                opening_1
                    .mul_add(
                        spin_cos_theta_last,
                        opening_last.mul_add(spin_cos_theta_1, next[32]),
                    ),
                spin_cos_q_right_top_1
                    .mul_add(
                        q_right_top_dot_2_last,
                        spin_cos_q_right_top_last.mul_add(q_right_top_dot_2_1, next[33]),
                    ),
                spin_cos_q_right_top_1
                    .mul_add(
                        q_right_top_dot_2_last,
                        spin_cos_q_right_top_last.mul_add(q_right_top_dot_2_1, next[34]),
                    ),
                opening_1
                    .mul_add(
                        w_left_arm_frame_in_left_link_frame_3_of_spin_2_last,
                        opening_last
                            .mul_add(
                                w_left_arm_frame_in_left_link_frame_3_of_spin_2_1, next[35],
                            ),
                    ),
                opening_1
                    .mul_add(
                        w_left_arm_frame_in_left_link_frame_3_of_spin_last,
                        opening_last
                            .mul_add(
                                w_left_arm_frame_in_left_link_frame_3_of_spin_1, next[36],
                            ),
                    ),
                w_left_arm_frame_in_left_link_frame_3_of_place_1
                    .mul_add(
                        w_left_link_frame_2_of_opening_last,
                        w_left_arm_frame_in_left_link_frame_3_of_place_last
                            .mul_add(w_left_link_frame_2_of_opening_1, next[37]),
                    ),
                w_left_arm_frame_in_left_link_frame_3_of_place_1
                    .mul_add(
                        w_left_link_frame_2_of_opening_2_last,
                        w_left_arm_frame_in_left_link_frame_3_of_place_last
                            .mul_add(w_left_link_frame_2_of_opening_2_1, next[38]),
                    ),
                cos_angle_1
                    .mul_add(
                        spin_sin_q_right_top_last,
                        cos_angle_last.mul_add(spin_sin_q_right_top_1, next[39]),
                    ),
                w_right_arm_frame_2_of_opening_2_1
                    .mul_add(
                        alpha_right_arm_frame_in_right_link_frame_1_of_spin_last,
                        w_right_arm_frame_2_of_opening_2_last
                            .mul_add(
                                alpha_right_arm_frame_in_right_link_frame_1_of_spin_1, next[40],
                            ),
                    ),
                q_right_top_dot_2_1
                    .mul_add(
                        w_right_arm_frame_in_right_link_frame_3_of_spin_last,
                        q_right_top_dot_2_last
                            .mul_add(
                                w_right_arm_frame_in_right_link_frame_3_of_spin_1, next[41],
                            ),
                    ),
                w_right_arm_frame_in_right_link_frame_3_of_place_1
                    .mul_add(
                        w_right_link_frame_2_of_opening_last,
                        w_right_arm_frame_in_right_link_frame_3_of_place_last
                            .mul_add(w_right_link_frame_2_of_opening_1, next[42]),
                    ),
                w_right_arm_frame_in_right_link_frame_3_of_place_1
                    .mul_add(
                        w_right_link_frame_2_of_opening_2_last,
                        w_right_arm_frame_in_right_link_frame_3_of_place_last
                            .mul_add(w_right_link_frame_2_of_opening_2_1, next[43]),
                    ),
                w_right_arm_frame_in_right_link_frame_1_of_place_1
                    .mul_add(
                        w_right_link_frame_2_of_opening_2_last,
                        w_right_arm_frame_in_right_link_frame_1_of_place_last
                            .mul_add(w_right_link_frame_2_of_opening_2_1, next[44]),
                    ),
                w_right_link_frame_2_of_opening_2_1
                    .mul_add(
                        w_right_arm_frame_in_right_link_frame_1_of_place_last,
                        w_right_link_frame_2_of_opening_2_last
                            .mul_add(
                                w_right_arm_frame_in_right_link_frame_1_of_place_1, next[45],
                            ),
                    ),
                w_right_arm_frame_in_right_link_frame_3_of_place_1
                    .mul_add(
                        w_right_link_frame_2_of_opening_2_last,
                        w_right_arm_frame_in_right_link_frame_3_of_place_last
                            .mul_add(w_right_link_frame_2_of_opening_2_1, next[46]),
                    ),
                w_left_arm_frame_in_left_link_frame_1_of_place_1
                    .mul_add(
                        w_left_link_frame_2_of_opening_2_last,
                        w_left_arm_frame_in_left_link_frame_1_of_place_last
                            .mul_add(w_left_link_frame_2_of_opening_2_1, next[47]),
                    ),
                w_left_link_frame_2_of_opening_2_1
                    .mul_add(
                        w_left_arm_frame_in_left_link_frame_1_of_place_last,
                        w_left_link_frame_2_of_opening_2_last
                            .mul_add(
                                w_left_arm_frame_in_left_link_frame_1_of_place_1, next[48],
                            ),
                    ),
                w_left_arm_frame_in_left_link_frame_3_of_place_1
                    .mul_add(
                        w_left_link_frame_2_of_opening_2_last,
                        w_left_arm_frame_in_left_link_frame_3_of_place_last
                            .mul_add(w_left_link_frame_2_of_opening_2_1, next[49]),
                    ),
                spin_sin_q_right_top_1
                    .mul_add(
                        q_right_top_dot_2_last,
                        spin_sin_q_right_top_last.mul_add(q_right_top_dot_2_1, next[50]),
                    ),
                q_right_top_dot_2_1
                    .mul_add(
                        spin_sin_q_right_top_last,
                        q_right_top_dot_2_last.mul_add(spin_sin_q_right_top_1, next[51]),
                    ),
                cos_q_right_ball_1
                    .mul_add(
                        F_w_right_arm_frame_in_right_link_frame_3_of_place_last,
                        cos_q_right_ball_last
                            .mul_add(
                                F_w_right_arm_frame_in_right_link_frame_3_of_place_1, next[52],
                            ),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        F_w_right_arm_frame_in_right_link_frame_1_of_place_last,
                        sin_q_right_ball_last
                            .mul_add(
                                F_w_right_arm_frame_in_right_link_frame_1_of_place_1, next[53],
                            ),
                    ),
                spin_cos_q_right_top_1
                    .mul_add(
                        q_right_top_dot_2_last,
                        spin_cos_q_right_top_last.mul_add(q_right_top_dot_2_1, next[54]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        F_w_right_arm_frame_in_right_link_frame_3_of_place_last,
                        sin_q_right_ball_last
                            .mul_add(
                                F_w_right_arm_frame_in_right_link_frame_3_of_place_1, next[55],
                            ),
                    ),
                cos_q_right_ball_1
                    .mul_add(
                        F_w_right_arm_frame_in_right_link_frame_1_of_place_last,
                        cos_q_right_ball_last
                            .mul_add(
                                F_w_right_arm_frame_in_right_link_frame_1_of_place_1, next[56],
                            ),
                    ),
                spin_sin_theta_1
                    .mul_add(
                        opening_last,
                        spin_sin_theta_last.mul_add(opening_1, next[57]),
                    ),
                opening_1
                    .mul_add(
                        spin_sin_theta_last,
                        opening_last.mul_add(spin_sin_theta_1, next[58]),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        F_w_left_arm_frame_in_left_link_frame_3_of_place_last,
                        cos_q_left_ball_last
                            .mul_add(
                                F_w_left_arm_frame_in_left_link_frame_3_of_place_1, next[59],
                            ),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        F_w_left_arm_frame_in_left_link_frame_1_of_place_last,
                        sin_q_left_ball_last
                            .mul_add(
                                F_w_left_arm_frame_in_left_link_frame_1_of_place_1, next[60],
                            ),
                    ),
                spin_cos_theta_1
                    .mul_add(
                        opening_last,
                        spin_cos_theta_last.mul_add(opening_1, next[61]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        F_w_left_arm_frame_in_left_link_frame_3_of_place_last,
                        sin_q_left_ball_last
                            .mul_add(
                                F_w_left_arm_frame_in_left_link_frame_3_of_place_1, next[62],
                            ),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        F_w_left_arm_frame_in_left_link_frame_1_of_place_last,
                        cos_q_left_ball_last
                            .mul_add(
                                F_w_left_arm_frame_in_left_link_frame_1_of_place_1, next[63],
                            ),
                    ),
                (spin_sin_theta_1 + spin_sin_theta_1)
                    .mul_add(spin_sin_theta_last, next[64]),
                spin_sin_theta_1
                    .mul_add(
                        spin_cos_theta_last,
                        spin_sin_theta_last.mul_add(spin_cos_theta_1, next[65]),
                    ),
                (opening_1 + opening_1).mul_add(opening_last, next[66]),
                sin_theta_plus_q_left_ball_1
                    .mul_add(
                        w_left_link_frame_2_of_opening_2_last,
                        sin_theta_plus_q_left_ball_last
                            .mul_add(w_left_link_frame_2_of_opening_2_1, next[67]),
                    ),
                cos_theta_plus_q_left_ball_1
                    .mul_add(
                        alpha_right_arm_frame_2_of_opening_3_last,
                        cos_theta_plus_q_left_ball_last
                            .mul_add(alpha_right_arm_frame_2_of_opening_3_1, next[68]),
                    ),
                q_right_top_dot_2_1
                    .mul_add(
                        alpha_right_arm_frame_2_of_opening_3_last,
                        q_right_top_dot_2_last
                            .mul_add(alpha_right_arm_frame_2_of_opening_3_1, next[69]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        alpha_right_arm_frame_2_of_place_last,
                        sin_q_right_ball_last
                            .mul_add(alpha_right_arm_frame_2_of_place_1, next[70]),
                    ),
                w_right_arm_frame_2_of_opening_1
                    .mul_add(
                        w_left_link_frame_2_of_opening_last,
                        w_right_arm_frame_2_of_opening_last
                            .mul_add(w_left_link_frame_2_of_opening_1, next[71]),
                    ),
                alpha_right_arm_frame_2_of_place_1
                    .mul_add(
                        alpha_right_arm_frame_2_of_opening_5_last,
                        alpha_right_arm_frame_2_of_place_last
                            .mul_add(alpha_right_arm_frame_2_of_opening_5_1, next[72]),
                    ),
                cos_angle_1
                    .mul_add(
                        alpha_right_arm_frame_2_of_opening_6_last,
                        cos_angle_last
                            .mul_add(alpha_right_arm_frame_2_of_opening_6_1, next[73]),
                    ),
                sin_angle_1
                    .mul_add(
                        w_right_arm_frame_2_of_opening_3_last,
                        sin_angle_last
                            .mul_add(w_right_arm_frame_2_of_opening_3_1, next[74]),
                    ),
                alpha_right_arm_frame_2_of_opening_1
                    .mul_add(
                        alpha_right_arm_frame_2_of_opening_8_last,
                        alpha_right_arm_frame_2_of_opening_last
                            .mul_add(alpha_right_arm_frame_2_of_opening_8_1, next[75]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        alpha_right_arm_frame_2_of_q_right_ball_last,
                        sin_q_right_ball_last
                            .mul_add(alpha_right_arm_frame_2_of_q_right_ball_1, next[76]),
                    ),
                w_right_link_frame_2_of_opening_1
                    .mul_add(
                        alpha_right_arm_frame_2_of_q_right_ball_last,
                        w_right_link_frame_2_of_opening_last
                            .mul_add(alpha_right_arm_frame_2_of_q_right_ball_1, next[77]),
                    ),
                q_right_top_dot_2_1
                    .mul_add(
                        alpha_right_arm_frame_2_of_opening_10_last,
                        q_right_top_dot_2_last
                            .mul_add(alpha_right_arm_frame_2_of_opening_10_1, next[78]),
                    ),
                (spin_sin_q_right_top_1 + spin_sin_q_right_top_1)
                    .mul_add(spin_sin_q_right_top_last, next[79]),
                spin_sin_q_right_top_1
                    .mul_add(
                        spin_cos_q_right_top_last,
                        spin_sin_q_right_top_last
                            .mul_add(spin_cos_q_right_top_1, next[80]),
                    ),
                (q_right_top_dot_2_1 + q_right_top_dot_2_1)
                    .mul_add(q_right_top_dot_2_last, next[81]),
                opening_1
                    .mul_add(
                        sin_theta_last,
                        opening_last.mul_add(sin_theta_1, next[82]),
                    ),
                w_left_link_frame_2_of_opening_1
                    .mul_add(
                        alpha_right_arm_frame_2_of_opening_3_last,
                        w_left_link_frame_2_of_opening_last
                            .mul_add(alpha_right_arm_frame_2_of_opening_3_1, next[83]),
                    ),
                alpha_left_link_frame_2_of_opening_1
                    .mul_add(
                        w_right_arm_frame_2_of_opening_last,
                        alpha_left_link_frame_2_of_opening_last
                            .mul_add(w_right_arm_frame_2_of_opening_1, next[84]),
                    ),
                (w_left_arm_frame_in_left_link_frame_1_of_place_1
                    + w_left_arm_frame_in_left_link_frame_1_of_place_1)
                    .mul_add(
                        w_left_arm_frame_in_left_link_frame_1_of_place_last, next[85],
                    ),
                w_left_arm_frame_in_left_link_frame_1_of_place_1
                    .mul_add(
                        w_left_arm_frame_in_left_link_frame_3_of_place_last,
                        w_left_arm_frame_in_left_link_frame_1_of_place_last
                            .mul_add(
                                w_left_arm_frame_in_left_link_frame_3_of_place_1, next[86],
                            ),
                    ),
                (w_left_link_frame_2_of_opening_2_1 + w_left_link_frame_2_of_opening_2_1)
                    .mul_add(w_left_link_frame_2_of_opening_2_last, next[87]),
                sin_q_right_top_1
                    .mul_add(
                        w_right_link_frame_2_of_q_right_ball_last,
                        sin_q_right_top_last
                            .mul_add(w_right_link_frame_2_of_q_right_ball_1, next[88]),
                    ),
                q_right_top_dot_2_1
                    .mul_add(
                        alpha_right_link_frame_2_of_place_last,
                        q_right_top_dot_2_last
                            .mul_add(alpha_right_link_frame_2_of_place_1, next[89]),
                    ),
                cos_q_right_top_1
                    .mul_add(
                        w_right_arm_frame_2_of_opening_2_last,
                        cos_q_right_top_last
                            .mul_add(w_right_arm_frame_2_of_opening_2_1, next[90]),
                    ),
                w_right_link_frame_2_of_place_3_1
                    .mul_add(
                        alpha_right_link_frame_2_of_opening_2_last,
                        w_right_link_frame_2_of_place_3_last
                            .mul_add(alpha_right_link_frame_2_of_opening_2_1, next[91]),
                    ),
                cos_angle_1
                    .mul_add(
                        alpha_right_link_frame_2_of_opening_2_last,
                        cos_angle_last
                            .mul_add(alpha_right_link_frame_2_of_opening_2_1, next[92]),
                    ),
                sin_q_right_top_1
                    .mul_add(
                        cos_q_right_ball_last,
                        sin_q_right_top_last.mul_add(cos_q_right_ball_1, next[93]),
                    ),
                w_right_link_frame_2_of_opening_1
                    .mul_add(
                        alpha_right_link_frame_2_of_place_2_last,
                        w_right_link_frame_2_of_opening_last
                            .mul_add(alpha_right_link_frame_2_of_place_2_1, next[94]),
                    ),
                w_right_link_frame_2_of_opening_1
                    .mul_add(
                        alpha_right_arm_frame_2_of_opening_3_last,
                        w_right_link_frame_2_of_opening_last
                            .mul_add(alpha_right_arm_frame_2_of_opening_3_1, next[95]),
                    ),
                w_right_link_frame_2_of_place_3_1
                    .mul_add(
                        alpha_right_arm_frame_2_of_opening_6_last,
                        w_right_link_frame_2_of_place_3_last
                            .mul_add(alpha_right_arm_frame_2_of_opening_6_1, next[96]),
                    ),
                w_right_link_frame_2_of_opening_1
                    .mul_add(
                        alpha_right_arm_frame_2_of_opening_10_last,
                        w_right_link_frame_2_of_opening_last
                            .mul_add(alpha_right_arm_frame_2_of_opening_10_1, next[97]),
                    ),
                alpha_right_link_frame_2_of_opening_9_1
                    .mul_add(
                        w_right_arm_frame_2_of_opening_3_last,
                        alpha_right_link_frame_2_of_opening_9_last
                            .mul_add(w_right_arm_frame_2_of_opening_3_1, next[98]),
                    ),
                (w_right_arm_frame_in_right_link_frame_1_of_place_1
                    + w_right_arm_frame_in_right_link_frame_1_of_place_1)
                    .mul_add(
                        w_right_arm_frame_in_right_link_frame_1_of_place_last, next[99],
                    ),
                w_right_arm_frame_in_right_link_frame_1_of_place_1
                    .mul_add(
                        w_right_arm_frame_in_right_link_frame_3_of_place_last,
                        w_right_arm_frame_in_right_link_frame_1_of_place_last
                            .mul_add(
                                w_right_arm_frame_in_right_link_frame_3_of_place_1, next[100],
                            ),
                    ),
                (w_right_link_frame_2_of_opening_2_1 + w_right_link_frame_2_of_opening_2_1)
                    .mul_add(w_right_link_frame_2_of_opening_2_last, next[101]),
                sin_q_left_ball_1
                    .mul_add(
                        a_left_link_centre_3_of_place_last,
                        sin_q_left_ball_last
                            .mul_add(a_left_link_centre_3_of_place_1, next[102]),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        a_left_link_centre_1_of_place_last,
                        cos_q_left_ball_last
                            .mul_add(a_left_link_centre_1_of_place_1, next[103]),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        a_left_link_centre_3_of_place_last,
                        cos_q_left_ball_last
                            .mul_add(a_left_link_centre_3_of_place_1, next[104]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        a_left_link_centre_1_of_place_last,
                        sin_q_left_ball_last
                            .mul_add(a_left_link_centre_1_of_place_1, next[105]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        a_right_link_centre_3_of_place_last,
                        sin_q_right_ball_last
                            .mul_add(a_right_link_centre_3_of_place_1, next[106]),
                    ),
                cos_q_right_ball_1
                    .mul_add(
                        a_right_link_centre_1_of_place_last,
                        cos_q_right_ball_last
                            .mul_add(a_right_link_centre_1_of_place_1, next[107]),
                    ),
                cos_q_right_ball_1
                    .mul_add(
                        a_right_link_centre_3_of_place_last,
                        cos_q_right_ball_last
                            .mul_add(a_right_link_centre_3_of_place_1, next[108]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        a_right_link_centre_1_of_place_last,
                        sin_q_right_ball_last
                            .mul_add(a_right_link_centre_1_of_place_1, next[109]),
                    ),
                cos_theta_1
                    .mul_add(
                        opening_sq_last,
                        cos_theta_last.mul_add(opening_sq_1, next[110]),
                    ),
                cos_theta_plus_q_left_ball_1
                    .mul_add(
                        w_left_link_frame_2_of_opening_2_last,
                        cos_theta_plus_q_left_ball_last
                            .mul_add(w_left_link_frame_2_of_opening_2_1, next[111]),
                    ),
                w_left_link_frame_2_of_opening_2_1
                    .mul_add(
                        a_sleeve_centre_3_of_opening_last,
                        w_left_link_frame_2_of_opening_2_last
                            .mul_add(a_sleeve_centre_3_of_opening_1, next[112]),
                    ),
                sin_theta_plus_q_left_ball_1
                    .mul_add(
                        alpha_left_link_frame_2_of_opening_4_last,
                        sin_theta_plus_q_left_ball_last
                            .mul_add(alpha_left_link_frame_2_of_opening_4_1, next[113]),
                    ),
                w_right_arm_frame_in_right_link_frame_3_of_place_1
                    .mul_add(
                        w_right_arm_frame_in_right_link_frame_1_of_place_last,
                        w_right_arm_frame_in_right_link_frame_3_of_place_last
                            .mul_add(
                                w_right_arm_frame_in_right_link_frame_1_of_place_1, next[114],
                            ),
                    ),
                w_left_arm_frame_in_left_link_frame_3_of_place_1
                    .mul_add(
                        w_left_arm_frame_in_left_link_frame_1_of_place_last,
                        w_left_arm_frame_in_left_link_frame_3_of_place_last
                            .mul_add(
                                w_left_arm_frame_in_left_link_frame_1_of_place_1, next[115],
                            ),
                    ),
                spin_cos_q_right_top_1
                    .mul_add(
                        spin_sin_q_right_top_last,
                        spin_cos_q_right_top_last
                            .mul_add(spin_sin_q_right_top_1, next[116]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        a_right_link_centre_3_2_of_place_last,
                        sin_q_right_ball_last
                            .mul_add(a_right_link_centre_3_2_of_place_1, next[117]),
                    ),
                cos_q_right_ball_1
                    .mul_add(
                        a_right_link_centre_1_2_of_place_last,
                        cos_q_right_ball_last
                            .mul_add(a_right_link_centre_1_2_of_place_1, next[118]),
                    ),
                (sin_q_right_ball_1 + sin_q_right_ball_1)
                    .mul_add(sin_q_right_ball_last, next[119]),
                cos_q_right_ball_1
                    .mul_add(
                        sin_q_right_ball_last,
                        cos_q_right_ball_last.mul_add(sin_q_right_ball_1, next[120]),
                    ),
                (sin_q_left_ball_1 + sin_q_left_ball_1)
                    .mul_add(sin_q_left_ball_last, next[121]),
                cos_q_left_ball_1
                    .mul_add(
                        sin_q_left_ball_last,
                        cos_q_left_ball_last.mul_add(sin_q_left_ball_1, next[122]),
                    ),
                sin_q_right_top_1
                    .mul_add(
                        J_right_arm_frame_in_spindle_frame_31_of_place_last,
                        sin_q_right_top_last
                            .mul_add(
                                J_right_arm_frame_in_spindle_frame_31_of_place_1, next[123],
                            ),
                    ),
                cos_q_right_top_1
                    .mul_add(
                        J_right_arm_frame_13_of_place_last,
                        cos_q_right_top_last
                            .mul_add(J_right_arm_frame_13_of_place_1, next[124]),
                    ),
                sin_q_right_top_1
                    .mul_add(
                        J_right_arm_frame_in_spindle_frame_of_place_3_last,
                        sin_q_right_top_last
                            .mul_add(
                                J_right_arm_frame_in_spindle_frame_of_place_3_1, next[125],
                            ),
                    ),
                sin_theta_1
                    .mul_add(
                        J_left_arm_frame_in_spindle_frame_31_of_place_last,
                        sin_theta_last
                            .mul_add(
                                J_left_arm_frame_in_spindle_frame_31_of_place_1, next[126],
                            ),
                    ),
                cos_theta_1
                    .mul_add(
                        J_left_arm_frame_13_of_place_last,
                        cos_theta_last.mul_add(J_left_arm_frame_13_of_place_1, next[127]),
                    ),
                sin_theta_1
                    .mul_add(
                        J_left_arm_frame_in_spindle_frame_of_place_3_last,
                        sin_theta_last
                            .mul_add(
                                J_left_arm_frame_in_spindle_frame_of_place_3_1, next[128],
                            ),
                    ),
                sin_theta_1
                    .mul_add(
                        sin_q_left_ball_last,
                        sin_theta_last.mul_add(sin_q_left_ball_1, next[129]),
                    ),
                cos_theta_1
                    .mul_add(
                        cos_q_left_ball_last,
                        cos_theta_last.mul_add(cos_q_left_ball_1, next[130]),
                    ),
                (cos_theta_1 + cos_theta_1).mul_add(cos_theta_last, next[131]),
                (sin_q_right_ball_1 + sin_q_right_ball_1)
                    .mul_add(sin_q_right_ball_last, next[132]),
                sin_q_right_ball_sq_2_1
                    .mul_add(
                        sin_q_right_ball_inv2_last,
                        sin_q_right_ball_sq_2_last
                            .mul_add(sin_q_right_ball_inv2_1, next[133]),
                    ),
                cos_q_right_top_1
                    .mul_add(
                        d2_of_place_4_last,
                        cos_q_right_top_last.mul_add(d2_of_place_4_1, next[134]),
                    ),
                sin_q_right_top_1
                    .mul_add(
                        alpha_right_arm_frame_2_of_q_right_ball_last,
                        sin_q_right_top_last
                            .mul_add(
                                alpha_right_arm_frame_2_of_q_right_ball_1, next[135],
                            ),
                    ),
                cos_q_right_top_1
                    .mul_add(
                        d2_of_place_7_last,
                        cos_q_right_top_last.mul_add(d2_of_place_7_1, next[136]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        d2_of_place_9_last,
                        sin_q_left_ball_last.mul_add(d2_of_place_9_1, next[137]),
                    ),
                sin_theta_1
                    .mul_add(
                        d2_of_place_2_last,
                        sin_theta_last.mul_add(d2_of_place_2_1, next[138]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        d2_of_place_12_last,
                        sin_q_left_ball_last.mul_add(d2_of_place_12_1, next[139]),
                    ),
                (d2_of_place_3_1 + d2_of_place_3_1)
                    .mul_add(d2_of_place_3_last, next[140]),
                d2_of_place_15_1
                    .mul_add(
                        d2_of_place_16_last,
                        d2_of_place_15_last.mul_add(d2_of_place_16_1, next[141]),
                    ),
                spin_cos_theta_1
                    .mul_add(
                        spin_sin_theta_last,
                        spin_cos_theta_last.mul_add(spin_sin_theta_1, next[142]),
                    ),
                F_w_right_link_frame_2_of_place_2_1
                    .mul_add(
                        w_right_link_frame_2_of_place_last,
                        F_w_right_link_frame_2_of_place_2_last
                            .mul_add(w_right_link_frame_2_of_place_1, next[143]),
                    ),
                cos_angle_1
                    .mul_add(
                        F_w_right_arm_frame_2_of_place_3_last,
                        cos_angle_last
                            .mul_add(F_w_right_arm_frame_2_of_place_3_1, next[144]),
                    ),
                sin_q_right_ball_1
                    .mul_add(
                        opening_dot_of_place_4_last,
                        sin_q_right_ball_last
                            .mul_add(opening_dot_of_place_4_1, next[145]),
                    ),
                sin_q_right_top_1
                    .mul_add(
                        F_w_right_link_frame_2_of_place_2_last,
                        sin_q_right_top_last
                            .mul_add(F_w_right_link_frame_2_of_place_2_1, next[146]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        opening_dot_of_place_6_last,
                        sin_q_left_ball_last.mul_add(opening_dot_of_place_6_1, next[147]),
                    ),
                sin_theta_plus_q_left_ball_1
                    .mul_add(
                        a_sleeve_centre_3_of_opening_4_last,
                        sin_theta_plus_q_left_ball_last
                            .mul_add(a_sleeve_centre_3_of_opening_4_1, next[148]),
                    ),
                cos_theta_1
                    .mul_add(
                        opening_dot_of_place_8_last,
                        cos_theta_last.mul_add(opening_dot_of_place_8_1, next[149]),
                    ),
                cos_theta_plus_q_left_ball_1
                    .mul_add(
                        opening_dot_of_place_11_last,
                        cos_theta_plus_q_left_ball_last
                            .mul_add(opening_dot_of_place_11_1, next[150]),
                    ),
                sin_theta_1
                    .mul_add(
                        a_sleeve_centre_3_of_opening_4_last,
                        sin_theta_last
                            .mul_add(a_sleeve_centre_3_of_opening_4_1, next[151]),
                    ),
                sin_q_left_ball_1
                    .mul_add(
                        a_left_link_centre_3_2_of_place_last,
                        sin_q_left_ball_last
                            .mul_add(a_left_link_centre_3_2_of_place_1, next[152]),
                    ),
                cos_q_left_ball_1
                    .mul_add(
                        a_left_link_centre_1_2_of_place_last,
                        cos_q_left_ball_last
                            .mul_add(a_left_link_centre_1_2_of_place_1, next[153]),
                    ),
                d2_of_place_16_1
                    .mul_add(
                        opening_dot_of_place_15_last,
                        d2_of_place_16_last.mul_add(opening_dot_of_place_15_1, next[154]),
                    ),
                cos_q_right_top_1
                    .mul_add(
                        F_w_spindle_frame_in_right_arm_frame_3_of_place_3_last,
                        cos_q_right_top_last
                            .mul_add(
                                F_w_spindle_frame_in_right_arm_frame_3_of_place_3_1, next[155],
                            ),
                    ),
                sin_q_right_top_1
                    .mul_add(
                        F_w_spindle_frame_in_right_arm_frame_1_of_place_3_last,
                        sin_q_right_top_last
                            .mul_add(
                                F_w_spindle_frame_in_right_arm_frame_1_of_place_3_1, next[156],
                            ),
                    ),
                cos_theta_1
                    .mul_add(
                        F_w_spindle_frame_in_left_arm_frame_3_of_opening_last,
                        cos_theta_last
                            .mul_add(
                                F_w_spindle_frame_in_left_arm_frame_3_of_opening_1, next[157],
                            ),
                    ),
                sin_theta_1
                    .mul_add(
                        F_w_spindle_frame_in_left_arm_frame_1_of_place_3_last,
                        sin_theta_last
                            .mul_add(
                                F_w_spindle_frame_in_left_arm_frame_1_of_place_3_1, next[158],
                            ),
                    ),
                J_spindle_frame_33_2_of_place_1
                    .mul_add(
                        spin_dot_2_last,
                        J_spindle_frame_33_2_of_place_last
                            .mul_add(spin_dot_2_1, next[159]),
                    ),
            ]
        };
        let sin_theta = theta.mul_add(cos_theta_0, sums[0] * over_k);
        let cos_theta = -theta.mul_add(sin_theta_0, sums[1] * over_k);
        let spin_sin_theta = sin_theta
            .mul_add(spin_0, spin.mul_add(sin_theta_0, sums[2]));
        let spin_cos_theta = cos_theta
            .mul_add(spin_0, spin.mul_add(cos_theta_0, sums[3]));
        let sin_q_right_top = q_right_top.mul_add(cos_q_right_top_0, sums[4] * over_k);
        let cos_q_right_top = -q_right_top.mul_add(sin_q_right_top_0, sums[5] * over_k);
        let spin_sin_q_right_top = sin_q_right_top
            .mul_add(spin_0, spin.mul_add(sin_q_right_top_0, sums[6]));
        let spin_cos_q_right_top = cos_q_right_top
            .mul_add(spin_0, spin.mul_add(cos_q_right_top_0, sums[7]));
        let theta_plus_q_left_ball = theta + q_left_ball;
        let sin_theta_plus_q_left_ball = theta_plus_q_left_ball
            .mul_add(cos_theta_plus_q_left_ball_0, sums[8] * over_k);
        let cos_theta_plus_q_left_ball = -theta_plus_q_left_ball
            .mul_add(sin_theta_plus_q_left_ball_0, sums[9] * over_k);
        let sin_q_left_ball = q_left_ball.mul_add(cos_q_left_ball_0, sums[10] * over_k);
        let cos_q_left_ball = -q_left_ball.mul_add(sin_q_left_ball_0, sums[11] * over_k);
        let w_right_arm_frame_2_of_place = q_right_top + q_right_ball;
        let sin_angle = w_right_arm_frame_2_of_place
            .mul_add(cos_angle_0, sums[12] * over_k);
        let cos_angle = -w_right_arm_frame_2_of_place
            .mul_add(sin_angle_0, sums[13] * over_k);
        let sin_q_right_ball = q_right_ball
            .mul_add(cos_q_right_ball_0, sums[14] * over_k);
        let cos_q_right_ball = -q_right_ball
            .mul_add(sin_q_right_ball_0, sums[15] * over_k);
        let w_right_arm_frame_2_of_opening = cos_theta_plus_q_left_ball
            .mul_add(
                -(w_right_arm_frame_2_of_opening_0 * over_cos_theta_plus_q_left_ball),
                (opening - sums[16]) * over_cos_theta_plus_q_left_ball,
            );
        let w_right_arm_frame_2_of_opening_2 = w_right_arm_frame_2_of_opening
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(w_right_arm_frame_2_of_opening_0, sums[17]),
            );
        let w_right_arm_frame_2_of_opening_3 = w_right_arm_frame_2_of_opening_2
            .mul_add(
                over_sin_q_right_ball,
                -(sin_q_right_ball.mul_add(w_right_arm_frame_2_of_opening_3_0, sums[18])
                    * over_sin_q_right_ball),
            );
        let q_right_top_dot_2 = w_right_arm_frame_2_of_opening_3
            .mul_add(
                cos_angle_0,
                cos_angle.mul_add(w_right_arm_frame_2_of_opening_3_0, sums[19]),
            );
        let w_left_arm_frame_in_left_link_frame_1_of_spin = spin_cos_theta
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(spin_cos_theta_0, sums[20]),
            );
        let w_left_arm_frame_in_left_link_frame_1_of_spin_2 = spin_sin_theta
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball.mul_add(spin_sin_theta_0, sums[21]),
            );
        let w_left_arm_frame_in_left_link_frame_1_of_place = w_left_arm_frame_in_left_link_frame_1_of_spin
            + w_left_arm_frame_in_left_link_frame_1_of_spin_2;
        let w_left_arm_frame_in_left_link_frame_3_of_spin = spin_cos_theta
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball.mul_add(spin_cos_theta_0, sums[22]),
            );
        let w_left_arm_frame_in_left_link_frame_3_of_spin_2 = spin_sin_theta
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(spin_sin_theta_0, sums[23]),
            );
        let w_left_arm_frame_in_left_link_frame_3_of_place = w_left_arm_frame_in_left_link_frame_3_of_spin
            - w_left_arm_frame_in_left_link_frame_3_of_spin_2;
        let w_left_link_frame_2_of_place = cos_theta + cos_theta_plus_q_left_ball;
        let w_left_link_frame_2_of_opening = w_right_arm_frame_2_of_opening
            .mul_add(
                w_left_link_frame_2_of_place_0,
                w_left_link_frame_2_of_place
                    .mul_add(w_right_arm_frame_2_of_opening_0, sums[24]),
            );
        let w_left_link_frame_2_of_opening_2 = opening - w_left_link_frame_2_of_opening;
        let w_right_arm_frame_in_right_link_frame_1_of_spin = spin_cos_q_right_top
            .mul_add(
                sin_q_right_ball_0,
                sin_q_right_ball.mul_add(spin_cos_q_right_top_0, sums[25]),
            );
        let w_right_arm_frame_in_right_link_frame_1_of_spin_2 = spin_sin_q_right_top
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball.mul_add(spin_sin_q_right_top_0, sums[26]),
            );
        let w_right_arm_frame_in_right_link_frame_1_of_place = w_right_arm_frame_in_right_link_frame_1_of_spin
            + w_right_arm_frame_in_right_link_frame_1_of_spin_2;
        let w_right_arm_frame_in_right_link_frame_3_of_spin = spin_cos_q_right_top
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball.mul_add(spin_cos_q_right_top_0, sums[27]),
            );
        let w_right_arm_frame_in_right_link_frame_3_of_spin_2 = spin_sin_q_right_top
            .mul_add(
                sin_q_right_ball_0,
                sin_q_right_ball.mul_add(spin_sin_q_right_top_0, sums[28]),
            );
        let w_right_arm_frame_in_right_link_frame_3_of_place = w_right_arm_frame_in_right_link_frame_3_of_spin
            - w_right_arm_frame_in_right_link_frame_3_of_spin_2;
        let w_right_link_frame_2_of_q_right_ball = cos_q_right_ball;
        let w_right_link_frame_2_of_place = w_right_link_frame_2_of_q_right_ball
            .mul_add(
                cos_q_right_top_0,
                cos_q_right_top.mul_add(w_right_link_frame_2_of_q_right_ball_0, sums[29]),
            );
        let w_right_link_frame_2_of_place_2 = sin_q_right_ball
            .mul_add(
                sin_q_right_top_0,
                sin_q_right_top.mul_add(sin_q_right_ball_0, sums[30]),
            );
        let w_right_link_frame_2_of_place_3 = -w_right_link_frame_2_of_place_2
            + w_right_link_frame_2_of_place;
        let w_right_link_frame_2_of_opening = w_right_arm_frame_2_of_opening_3
            .mul_add(
                w_right_link_frame_2_of_place_3_0,
                w_right_link_frame_2_of_place_3
                    .mul_add(w_right_arm_frame_2_of_opening_3_0, sums[31]),
            );
        let w_right_link_frame_2_of_opening_2 = w_right_link_frame_2_of_opening - q_right_top_dot_2;
        let spin_opening_cos_theta = spin_cos_theta
            .mul_add(opening_0, opening.mul_add(spin_cos_theta_0, sums[32]));
        let alpha_right_arm_frame_1_of_spin_opening = q_right_top_dot_2
            .mul_add(
                spin_cos_q_right_top_0,
                spin_cos_q_right_top.mul_add(q_right_top_dot_2_0, sums[33]),
            );
        let w_right_arm_frame_23_of_spin_opening = q_right_top_dot_2
            .mul_add(
                spin_cos_q_right_top_0,
                spin_cos_q_right_top.mul_add(q_right_top_dot_2_0, sums[34]),
            );
        let turn_right_arm_frame_23_of_place = alpha_right_arm_frame_1_of_spin_opening
            + w_right_arm_frame_23_of_spin_opening;
        let alpha_left_arm_frame_in_left_link_frame_1_of_spin_opening = w_left_arm_frame_in_left_link_frame_3_of_spin_2
            .mul_add(
                opening_0,
                opening
                    .mul_add(w_left_arm_frame_in_left_link_frame_3_of_spin_2_0, sums[35]),
            );
        let alpha_left_arm_frame_in_left_link_frame_1_of_spin_opening_2 = w_left_arm_frame_in_left_link_frame_3_of_spin
            .mul_add(
                opening_0,
                opening
                    .mul_add(w_left_arm_frame_in_left_link_frame_3_of_spin_0, sums[36]),
            );
        let alpha_left_link_frame_1_of_opening = w_left_link_frame_2_of_opening
            .mul_add(
                w_left_arm_frame_in_left_link_frame_3_of_place_0,
                w_left_arm_frame_in_left_link_frame_3_of_place
                    .mul_add(w_left_link_frame_2_of_opening_0, sums[37]),
            );
        let alpha_left_link_frame_1_of_opening_2 = alpha_left_arm_frame_in_left_link_frame_1_of_spin_opening
            - alpha_left_arm_frame_in_left_link_frame_1_of_spin_opening_2
            + alpha_left_link_frame_1_of_opening;
        let w_left_link_frame_23_of_opening = w_left_link_frame_2_of_opening_2
            .mul_add(
                w_left_arm_frame_in_left_link_frame_3_of_place_0,
                w_left_arm_frame_in_left_link_frame_3_of_place
                    .mul_add(w_left_link_frame_2_of_opening_2_0, sums[38]),
            );
        let alpha_right_arm_frame_in_right_link_frame_1_of_spin = spin_sin_q_right_top
            .mul_add(cos_angle_0, cos_angle.mul_add(spin_sin_q_right_top_0, sums[39]));
        let alpha_right_arm_frame_in_right_link_frame_1_of_spin_opening = w_right_arm_frame_2_of_opening_2
            .mul_add(
                alpha_right_arm_frame_in_right_link_frame_1_of_spin_0,
                alpha_right_arm_frame_in_right_link_frame_1_of_spin
                    .mul_add(w_right_arm_frame_2_of_opening_2_0, sums[40]),
            );
        let alpha_right_arm_frame_in_right_link_frame_1_of_spin_opening_2 = q_right_top_dot_2
            .mul_add(
                w_right_arm_frame_in_right_link_frame_3_of_spin_0,
                w_right_arm_frame_in_right_link_frame_3_of_spin
                    .mul_add(q_right_top_dot_2_0, sums[41]),
            );
        let alpha_right_link_frame_1_of_opening = w_right_link_frame_2_of_opening
            .mul_add(
                w_right_arm_frame_in_right_link_frame_3_of_place_0,
                w_right_arm_frame_in_right_link_frame_3_of_place
                    .mul_add(w_right_link_frame_2_of_opening_0, sums[42]),
            );
        let alpha_right_link_frame_1_of_opening_2 = alpha_right_arm_frame_in_right_link_frame_1_of_spin_opening
            + alpha_right_link_frame_1_of_opening
            - alpha_right_arm_frame_in_right_link_frame_1_of_spin_opening_2;
        let w_right_link_frame_23_of_opening = w_right_link_frame_2_of_opening_2
            .mul_add(
                w_right_arm_frame_in_right_link_frame_3_of_place_0,
                w_right_arm_frame_in_right_link_frame_3_of_place
                    .mul_add(w_right_link_frame_2_of_opening_2_0, sums[43]),
            );
        let a_left_link_centre_2_of_place = w_left_link_frame_23_of_opening
            .mul_add(
                minus_l,
                alpha_left_link_frame_1_of_opening_2
                    .mul_add(l, minus_4_l * spin_opening_cos_theta),
            );
        let a_right_link_centre_2_of_place = w_right_link_frame_23_of_opening
            .mul_add(
                l,
                alpha_right_link_frame_1_of_opening_2
                    .mul_add(l, minus_2_l * turn_right_arm_frame_23_of_place),
            );
        let F_w_right_arm_frame_in_right_link_frame_3_of_opening = w_right_link_frame_2_of_opening_2
            .mul_add(
                w_right_arm_frame_in_right_link_frame_1_of_place_0,
                w_right_arm_frame_in_right_link_frame_1_of_place
                    .mul_add(w_right_link_frame_2_of_opening_2_0, sums[44]),
            );
        let F_w_right_arm_frame_in_right_link_frame_3_of_opening_2 = w_right_link_frame_2_of_opening_2
            .mul_add(
                w_right_arm_frame_in_right_link_frame_1_of_place_0,
                w_right_arm_frame_in_right_link_frame_1_of_place
                    .mul_add(w_right_link_frame_2_of_opening_2_0, sums[45]),
            );
        let F_w_right_arm_frame_in_right_link_frame_3_of_place = F_w_right_arm_frame_in_right_link_frame_3_of_opening_2
            .mul_add(
                minus_l_2_m,
                l_2_m * F_w_right_arm_frame_in_right_link_frame_3_of_opening,
            );
        let F_w_right_arm_frame_in_right_link_frame_1_of_opening = w_right_link_frame_2_of_opening_2
            .mul_add(
                w_right_arm_frame_in_right_link_frame_3_of_place_0,
                w_right_arm_frame_in_right_link_frame_3_of_place
                    .mul_add(w_right_link_frame_2_of_opening_2_0, sums[46]),
            );
        let F_w_right_arm_frame_in_right_link_frame_1_of_place = a_right_link_centre_2_of_place
            .mul_add(
                weight,
                alpha_right_link_frame_1_of_opening_2
                    .mul_add(
                        l_2_m,
                        l_2_m * F_w_right_arm_frame_in_right_link_frame_1_of_opening,
                    ),
            );
        let F_w_left_arm_frame_in_left_link_frame_3_of_opening = w_left_link_frame_2_of_opening_2
            .mul_add(
                w_left_arm_frame_in_left_link_frame_1_of_place_0,
                w_left_arm_frame_in_left_link_frame_1_of_place
                    .mul_add(w_left_link_frame_2_of_opening_2_0, sums[47]),
            );
        let F_w_left_arm_frame_in_left_link_frame_3_of_opening_2 = w_left_link_frame_2_of_opening_2
            .mul_add(
                w_left_arm_frame_in_left_link_frame_1_of_place_0,
                w_left_arm_frame_in_left_link_frame_1_of_place
                    .mul_add(w_left_link_frame_2_of_opening_2_0, sums[48]),
            );
        let F_w_left_arm_frame_in_left_link_frame_3_of_place = F_w_left_arm_frame_in_left_link_frame_3_of_opening_2
            .mul_add(
                minus_l_2_m,
                l_2_m * F_w_left_arm_frame_in_left_link_frame_3_of_opening,
            );
        let F_w_left_arm_frame_in_left_link_frame_1_of_opening = w_left_link_frame_2_of_opening_2
            .mul_add(
                w_left_arm_frame_in_left_link_frame_3_of_place_0,
                w_left_arm_frame_in_left_link_frame_3_of_place
                    .mul_add(w_left_link_frame_2_of_opening_2_0, sums[49]),
            );
        let F_w_left_arm_frame_in_left_link_frame_1_of_place = a_left_link_centre_2_of_place
            .mul_add(
                minus_3_l_m,
                alpha_left_link_frame_1_of_opening_2
                    .mul_add(
                        minus_l_2_m,
                        l_2_m * F_w_left_arm_frame_in_left_link_frame_1_of_opening,
                    ),
            );
        let F_w_spindle_frame_in_right_arm_frame_3_of_spin_opening = q_right_top_dot_2
            .mul_add(
                spin_sin_q_right_top_0,
                spin_sin_q_right_top.mul_add(q_right_top_dot_2_0, sums[50]),
            );
        let F_w_spindle_frame_in_right_arm_frame_3_of_spin_opening_2 = q_right_top_dot_2
            .mul_add(
                spin_sin_q_right_top_0,
                spin_sin_q_right_top.mul_add(q_right_top_dot_2_0, sums[51]),
            );
        let F_w_spindle_frame_in_right_arm_frame_3_of_place = F_w_right_arm_frame_in_right_link_frame_3_of_place
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball
                    .mul_add(
                        F_w_right_arm_frame_in_right_link_frame_3_of_place_0, sums[52],
                    ),
            );
        let F_w_spindle_frame_in_right_arm_frame_3_of_place_2 = F_w_right_arm_frame_in_right_link_frame_1_of_place
            .mul_add(
                sin_q_right_ball_0,
                sin_q_right_ball
                    .mul_add(
                        F_w_right_arm_frame_in_right_link_frame_1_of_place_0, sums[53],
                    ),
            );
        let F_w_spindle_frame_in_right_arm_frame_3_of_place_3 = F_w_spindle_frame_in_right_arm_frame_3_of_spin_opening_2
            .mul_add(
                minus_l_2_m,
                l_2_m * F_w_spindle_frame_in_right_arm_frame_3_of_spin_opening,
            ) - F_w_spindle_frame_in_right_arm_frame_3_of_place
            + F_w_spindle_frame_in_right_arm_frame_3_of_place_2;
        let F_w_spindle_frame_in_right_arm_frame_1_of_spin_opening = q_right_top_dot_2
            .mul_add(
                spin_cos_q_right_top_0,
                spin_cos_q_right_top.mul_add(q_right_top_dot_2_0, sums[54]),
            );
        let F_w_spindle_frame_in_right_arm_frame_1_of_place = F_w_right_arm_frame_in_right_link_frame_3_of_place
            .mul_add(
                sin_q_right_ball_0,
                sin_q_right_ball
                    .mul_add(
                        F_w_right_arm_frame_in_right_link_frame_3_of_place_0, sums[55],
                    ),
            );
        let F_w_spindle_frame_in_right_arm_frame_1_of_place_2 = F_w_right_arm_frame_in_right_link_frame_1_of_place
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball
                    .mul_add(
                        F_w_right_arm_frame_in_right_link_frame_1_of_place_0, sums[56],
                    ),
            );
        let F_w_spindle_frame_in_right_arm_frame_1_of_place_3 = a_right_link_centre_2_of_place
            .mul_add(
                minus_6_l_m,
                turn_right_arm_frame_23_of_place
                    .mul_add(
                        weight_2,
                        alpha_right_arm_frame_1_of_spin_opening
                            .mul_add(
                                l_2_m,
                                l_2_m * F_w_spindle_frame_in_right_arm_frame_1_of_spin_opening,
                            ),
                    ),
            ) - F_w_spindle_frame_in_right_arm_frame_1_of_place
            - F_w_spindle_frame_in_right_arm_frame_1_of_place_2;
        let spin_opening_sin_theta = spin_sin_theta
            .mul_add(opening_0, opening.mul_add(spin_sin_theta_0, sums[57]));
        let spin_opening_sin_theta_2 = spin_sin_theta
            .mul_add(opening_0, opening.mul_add(spin_sin_theta_0, sums[58]));
        let F_w_spindle_frame_in_left_arm_frame_3_of_place = F_w_left_arm_frame_in_left_link_frame_3_of_place
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball
                    .mul_add(
                        F_w_left_arm_frame_in_left_link_frame_3_of_place_0, sums[59],
                    ),
            );
        let F_w_spindle_frame_in_left_arm_frame_3_of_place_2 = F_w_left_arm_frame_in_left_link_frame_1_of_place
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball
                    .mul_add(
                        F_w_left_arm_frame_in_left_link_frame_1_of_place_0, sums[60],
                    ),
            );
        let F_w_spindle_frame_in_left_arm_frame_3_of_opening = spin_opening_sin_theta_2
            .mul_add(minus_l_2_m, l_2_m * spin_opening_sin_theta)
            + F_w_spindle_frame_in_left_arm_frame_3_of_place
            - F_w_spindle_frame_in_left_arm_frame_3_of_place_2;
        let spin_opening_cos_theta_2 = spin_cos_theta
            .mul_add(opening_0, opening.mul_add(spin_cos_theta_0, sums[61]));
        let F_w_spindle_frame_in_left_arm_frame_1_of_place = F_w_left_arm_frame_in_left_link_frame_3_of_place
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball
                    .mul_add(
                        F_w_left_arm_frame_in_left_link_frame_3_of_place_0, sums[62],
                    ),
            );
        let F_w_spindle_frame_in_left_arm_frame_1_of_place_2 = F_w_left_arm_frame_in_left_link_frame_1_of_place
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball
                    .mul_add(
                        F_w_left_arm_frame_in_left_link_frame_1_of_place_0, sums[63],
                    ),
            );
        let F_w_spindle_frame_in_left_arm_frame_1_of_place_3 = a_left_link_centre_2_of_place
            .mul_add(
                minus_6_l_m,
                spin_opening_cos_theta
                    .mul_add(weight_3, l_2_m * spin_opening_cos_theta_2),
            ) + F_w_spindle_frame_in_left_arm_frame_1_of_place
            + F_w_spindle_frame_in_left_arm_frame_1_of_place_2;
        let spin_sq_sin_theta_sq = spin_sin_theta
            .mul_add(spin_sin_theta_0 + spin_sin_theta_0, sums[64]);
        let w_left_arm_frame_13_of_spin = spin_cos_theta
            .mul_add(
                spin_sin_theta_0,
                spin_sin_theta.mul_add(spin_cos_theta_0, sums[65]),
            );
        let opening_sq = opening.mul_add(opening_0 + opening_0, sums[66]);
        let alpha_right_arm_frame_2_of_opening = w_right_link_frame_2_of_opening
            - q_right_top_dot_2;
        let alpha_right_arm_frame_2_of_opening_2 = w_left_link_frame_2_of_opening_2
            .mul_add(
                sin_theta_plus_q_left_ball_0,
                sin_theta_plus_q_left_ball
                    .mul_add(w_left_link_frame_2_of_opening_2_0, sums[67]),
            );
        let alpha_right_arm_frame_2_of_opening_3 = alpha_right_arm_frame_2_of_opening_2
            .mul_add(
                over_cos_theta_plus_q_left_ball,
                -(cos_theta_plus_q_left_ball
                    .mul_add(alpha_right_arm_frame_2_of_opening_3_0, sums[68])
                    * over_cos_theta_plus_q_left_ball),
            );
        let alpha_right_arm_frame_2_of_opening_4 = alpha_right_arm_frame_2_of_opening_3
            .mul_add(
                q_right_top_dot_2_0,
                q_right_top_dot_2
                    .mul_add(alpha_right_arm_frame_2_of_opening_3_0, sums[69]),
            );
        let alpha_right_arm_frame_2_of_place = sin_q_right_ball
            .mul_add(
                -(alpha_right_arm_frame_2_of_place_0 * over_sin_q_right_ball),
                (cos_q_left_ball - sums[70]) * over_sin_q_right_ball,
            );
        let alpha_right_arm_frame_2_of_opening_5 = w_left_link_frame_2_of_opening
            .mul_add(
                w_right_arm_frame_2_of_opening_0,
                w_right_arm_frame_2_of_opening
                    .mul_add(w_left_link_frame_2_of_opening_0, sums[71]),
            );
        let alpha_right_arm_frame_2_of_opening_6 = alpha_right_arm_frame_2_of_opening_5
            .mul_add(
                alpha_right_arm_frame_2_of_place_0,
                alpha_right_arm_frame_2_of_place
                    .mul_add(alpha_right_arm_frame_2_of_opening_5_0, sums[72]),
            );
        let alpha_right_arm_frame_2_of_opening_7 = alpha_right_arm_frame_2_of_opening_6
            .mul_add(
                cos_angle_0,
                cos_angle.mul_add(alpha_right_arm_frame_2_of_opening_6_0, sums[73]),
            );
        let alpha_right_arm_frame_2_of_opening_8 = w_right_arm_frame_2_of_opening_3
            .mul_add(
                sin_angle_0,
                sin_angle.mul_add(w_right_arm_frame_2_of_opening_3_0, sums[74]),
            );
        let alpha_right_arm_frame_2_of_opening_9 = alpha_right_arm_frame_2_of_opening
            .mul_add(
                alpha_right_arm_frame_2_of_opening_8_0,
                alpha_right_arm_frame_2_of_opening_8
                    .mul_add(alpha_right_arm_frame_2_of_opening_0, sums[75]),
            );
        let alpha_right_arm_frame_2_of_q_right_ball = sin_q_right_ball
            .mul_add(
                -(alpha_right_arm_frame_2_of_q_right_ball_0 * over_sin_q_right_ball),
                (cos_q_right_ball - sums[76]) * over_sin_q_right_ball,
            );
        let alpha_right_arm_frame_2_of_opening_10 = w_right_link_frame_2_of_opening
            .mul_add(
                alpha_right_arm_frame_2_of_q_right_ball_0,
                alpha_right_arm_frame_2_of_q_right_ball
                    .mul_add(w_right_link_frame_2_of_opening_0, sums[77]),
            );
        let alpha_right_arm_frame_2_of_opening_11 = alpha_right_arm_frame_2_of_opening_10
            .mul_add(
                q_right_top_dot_2_0,
                q_right_top_dot_2
                    .mul_add(alpha_right_arm_frame_2_of_opening_10_0, sums[78]),
            );
        let alpha_right_arm_frame_2_of_opening_12 = -alpha_right_arm_frame_2_of_opening_7
            + alpha_right_arm_frame_2_of_opening_4 + alpha_right_arm_frame_2_of_opening_9
            + alpha_right_arm_frame_2_of_opening_11;
        let w_right_arm_frame_11_of_spin = spin_sin_q_right_top
            .mul_add(spin_sin_q_right_top_0 + spin_sin_q_right_top_0, sums[79]);
        let w_right_arm_frame_13_of_spin = spin_cos_q_right_top
            .mul_add(
                spin_sin_q_right_top_0,
                spin_sin_q_right_top.mul_add(spin_cos_q_right_top_0, sums[80]),
            );
        let w_right_arm_frame_22_of_opening = q_right_top_dot_2
            .mul_add(q_right_top_dot_2_0 + q_right_top_dot_2_0, sums[81]);
        let turn_right_arm_frame_13_of_place = -w_right_arm_frame_13_of_spin
            + alpha_right_arm_frame_2_of_opening_12;
        let opening_sin_theta = sin_theta
            .mul_add(opening_0, opening.mul_add(sin_theta_0, sums[82]));
        let alpha_left_link_frame_2_of_opening = opening_sin_theta
            + alpha_right_arm_frame_2_of_opening_2;
        let alpha_left_link_frame_2_of_opening_2 = alpha_right_arm_frame_2_of_opening_3
            .mul_add(
                w_left_link_frame_2_of_opening_0,
                w_left_link_frame_2_of_opening
                    .mul_add(alpha_right_arm_frame_2_of_opening_3_0, sums[83]),
            );
        let alpha_left_link_frame_2_of_opening_3 = alpha_left_link_frame_2_of_opening
            .mul_add(
                w_right_arm_frame_2_of_opening_0,
                w_right_arm_frame_2_of_opening
                    .mul_add(alpha_left_link_frame_2_of_opening_0, sums[84]),
            );
        let alpha_left_link_frame_2_of_opening_4 = -alpha_left_link_frame_2_of_opening_3
            + alpha_left_link_frame_2_of_opening_2;
        let w_left_link_frame_11_of_place = w_left_arm_frame_in_left_link_frame_1_of_place
            .mul_add(
                w_left_arm_frame_in_left_link_frame_1_of_place_0
                    + w_left_arm_frame_in_left_link_frame_1_of_place_0,
                sums[85],
            );
        let w_left_link_frame_13_of_place = w_left_arm_frame_in_left_link_frame_3_of_place
            .mul_add(
                w_left_arm_frame_in_left_link_frame_1_of_place_0,
                w_left_arm_frame_in_left_link_frame_1_of_place
                    .mul_add(w_left_arm_frame_in_left_link_frame_3_of_place_0, sums[86]),
            );
        let w_left_link_frame_22_of_opening = w_left_link_frame_2_of_opening_2
            .mul_add(
                w_left_link_frame_2_of_opening_2_0 + w_left_link_frame_2_of_opening_2_0,
                sums[87],
            );
        let alpha_right_link_frame_2_of_place = w_right_link_frame_2_of_q_right_ball
            .mul_add(
                sin_q_right_top_0,
                sin_q_right_top.mul_add(w_right_link_frame_2_of_q_right_ball_0, sums[88]),
            );
        let alpha_right_link_frame_2_of_opening = q_right_top_dot_2
            .mul_add(
                alpha_right_link_frame_2_of_place_0,
                alpha_right_link_frame_2_of_place.mul_add(q_right_top_dot_2_0, sums[89]),
            );
        let alpha_right_link_frame_2_of_opening_2 = w_right_arm_frame_2_of_opening_2
            .mul_add(
                cos_q_right_top_0,
                cos_q_right_top.mul_add(w_right_arm_frame_2_of_opening_2_0, sums[90]),
            );
        let alpha_right_link_frame_2_of_opening_3 = alpha_right_link_frame_2_of_opening_2
            .mul_add(
                w_right_link_frame_2_of_place_3_0,
                w_right_link_frame_2_of_place_3
                    .mul_add(alpha_right_link_frame_2_of_opening_2_0, sums[91]),
            );
        let alpha_right_link_frame_2_of_opening_4 = alpha_right_link_frame_2_of_opening_2
            .mul_add(
                cos_angle_0,
                cos_angle.mul_add(alpha_right_link_frame_2_of_opening_2_0, sums[92]),
            );
        let alpha_right_link_frame_2_of_place_2 = cos_q_right_ball
            .mul_add(
                sin_q_right_top_0,
                sin_q_right_top.mul_add(cos_q_right_ball_0, sums[93]),
            );
        let alpha_right_link_frame_2_of_opening_5 = w_right_link_frame_2_of_opening
            .mul_add(
                alpha_right_link_frame_2_of_place_2_0,
                alpha_right_link_frame_2_of_place_2
                    .mul_add(w_right_link_frame_2_of_opening_0, sums[94]),
            );
        let alpha_right_link_frame_2_of_opening_6 = alpha_right_arm_frame_2_of_opening_3
            .mul_add(
                w_right_link_frame_2_of_opening_0,
                w_right_link_frame_2_of_opening
                    .mul_add(alpha_right_arm_frame_2_of_opening_3_0, sums[95]),
            );
        let alpha_right_link_frame_2_of_opening_7 = alpha_right_arm_frame_2_of_opening_6
            .mul_add(
                w_right_link_frame_2_of_place_3_0,
                w_right_link_frame_2_of_place_3
                    .mul_add(alpha_right_arm_frame_2_of_opening_6_0, sums[96]),
            );
        let alpha_right_link_frame_2_of_opening_8 = alpha_right_arm_frame_2_of_opening_10
            .mul_add(
                w_right_link_frame_2_of_opening_0,
                w_right_link_frame_2_of_opening
                    .mul_add(alpha_right_arm_frame_2_of_opening_10_0, sums[97]),
            );
        let alpha_right_link_frame_2_of_opening_9 = alpha_right_link_frame_2_of_opening_4
            - alpha_right_link_frame_2_of_opening_3 + alpha_right_link_frame_2_of_opening
            - alpha_right_link_frame_2_of_opening_5;
        let alpha_right_link_frame_2_of_opening_10 = alpha_right_link_frame_2_of_opening_9
            .mul_add(
                w_right_arm_frame_2_of_opening_3_0,
                w_right_arm_frame_2_of_opening_3
                    .mul_add(alpha_right_link_frame_2_of_opening_9_0, sums[98]),
            );
        let alpha_right_link_frame_2_of_opening_11 = -alpha_right_link_frame_2_of_opening_7
            + alpha_right_link_frame_2_of_opening_6 + alpha_right_link_frame_2_of_opening_8
            - alpha_right_link_frame_2_of_opening_10 - alpha_right_arm_frame_2_of_opening_12;
        let w_right_link_frame_11_of_place = w_right_arm_frame_in_right_link_frame_1_of_place
            .mul_add(
                w_right_arm_frame_in_right_link_frame_1_of_place_0
                    + w_right_arm_frame_in_right_link_frame_1_of_place_0,
                sums[99],
            );
        let w_right_link_frame_13_of_place = w_right_arm_frame_in_right_link_frame_3_of_place
            .mul_add(
                w_right_arm_frame_in_right_link_frame_1_of_place_0,
                w_right_arm_frame_in_right_link_frame_1_of_place
                    .mul_add(
                        w_right_arm_frame_in_right_link_frame_3_of_place_0, sums[100],
                    ),
            );
        let w_right_link_frame_22_of_opening = w_right_link_frame_2_of_opening_2
            .mul_add(
                w_right_link_frame_2_of_opening_2_0 + w_right_link_frame_2_of_opening_2_0,
                sums[101],
            );
        let a_left_link_centre_1_of_place = w_left_arm_frame_13_of_spin
            .mul_add(l, minus_g * sin_theta);
        let a_left_link_centre_3_of_place = spin_sq_sin_theta_sq
            .mul_add(l, opening_sq.mul_add(l, g * cos_theta));
        let a_left_arm_frame_in_left_link_frame_1_of_place = a_left_link_centre_3_of_place
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(a_left_link_centre_3_of_place_0, sums[102]),
            );
        let a_left_arm_frame_in_left_link_frame_1_of_place_2 = a_left_link_centre_1_of_place
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball.mul_add(a_left_link_centre_1_of_place_0, sums[103]),
            );
        let a_left_arm_frame_in_left_link_frame_3_of_place = a_left_link_centre_3_of_place
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball.mul_add(a_left_link_centre_3_of_place_0, sums[104]),
            );
        let a_left_arm_frame_in_left_link_frame_3_of_place_2 = a_left_link_centre_1_of_place
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(a_left_link_centre_1_of_place_0, sums[105]),
            );
        let a_left_link_centre_1_2_of_place = alpha_left_link_frame_2_of_opening_4
            .mul_add(
                l,
                w_left_link_frame_13_of_place
                    .mul_add(
                        l,
                        a_left_arm_frame_in_left_link_frame_1_of_place_2
                            .mul_add(
                                S::int(2),
                                -S::int(2) * a_left_arm_frame_in_left_link_frame_1_of_place,
                            ),
                    ),
            );
        let a_left_link_centre_3_2_of_place = w_left_link_frame_22_of_opening
            .mul_add(
                l,
                w_left_link_frame_11_of_place
                    .mul_add(
                        l,
                        a_left_arm_frame_in_left_link_frame_3_of_place_2
                            .mul_add(
                                S::int(2),
                                S::int(2) * a_left_arm_frame_in_left_link_frame_3_of_place,
                            ),
                    ),
            );
        let a_right_link_centre_1_of_place = turn_right_arm_frame_13_of_place
            .mul_add(l, g * sin_q_right_top);
        let a_right_link_centre_3_of_place = w_right_arm_frame_22_of_opening
            .mul_add(l, w_right_arm_frame_11_of_spin.mul_add(l, g * cos_q_right_top));
        let a_right_arm_frame_in_right_link_frame_1_of_place = a_right_link_centre_3_of_place
            .mul_add(
                sin_q_right_ball_0,
                sin_q_right_ball.mul_add(a_right_link_centre_3_of_place_0, sums[106]),
            );
        let a_right_arm_frame_in_right_link_frame_1_of_place_2 = a_right_link_centre_1_of_place
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball.mul_add(a_right_link_centre_1_of_place_0, sums[107]),
            );
        let a_right_arm_frame_in_right_link_frame_3_of_place = a_right_link_centre_3_of_place
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball.mul_add(a_right_link_centre_3_of_place_0, sums[108]),
            );
        let a_right_arm_frame_in_right_link_frame_3_of_place_2 = a_right_link_centre_1_of_place
            .mul_add(
                sin_q_right_ball_0,
                sin_q_right_ball.mul_add(a_right_link_centre_1_of_place_0, sums[109]),
            );
        let a_right_link_centre_1_2_of_place = a_right_arm_frame_in_right_link_frame_1_of_place_2
            .mul_add(
                -S::int(2),
                alpha_right_link_frame_2_of_opening_11
                    .mul_add(
                        l,
                        a_right_arm_frame_in_right_link_frame_1_of_place
                            .mul_add(-S::int(2), l * w_right_link_frame_13_of_place),
                    ),
            );
        let a_right_link_centre_3_2_of_place = a_right_arm_frame_in_right_link_frame_3_of_place_2
            .mul_add(
                -S::int(2),
                a_right_arm_frame_in_right_link_frame_3_of_place
                    .mul_add(
                        S::int(2),
                        w_right_link_frame_22_of_opening
                            .mul_add(l, l * w_right_link_frame_11_of_place),
                    ),
            );
        let opening_sq_cos_theta = opening_sq
            .mul_add(cos_theta_0, cos_theta.mul_add(opening_sq_0, sums[110]));
        let a_sleeve_centre_3_of_opening = w_left_link_frame_2_of_opening_2
            .mul_add(
                cos_theta_plus_q_left_ball_0,
                cos_theta_plus_q_left_ball
                    .mul_add(w_left_link_frame_2_of_opening_2_0, sums[111]),
            );
        let a_sleeve_centre_3_of_opening_2 = a_sleeve_centre_3_of_opening
            .mul_add(
                w_left_link_frame_2_of_opening_2_0,
                w_left_link_frame_2_of_opening_2
                    .mul_add(a_sleeve_centre_3_of_opening_0, sums[112]),
            );
        let a_sleeve_centre_3_of_opening_3 = alpha_left_link_frame_2_of_opening_4
            .mul_add(
                sin_theta_plus_q_left_ball_0,
                sin_theta_plus_q_left_ball
                    .mul_add(alpha_left_link_frame_2_of_opening_4_0, sums[113]),
            );
        let a_sleeve_centre_3_of_opening_4 = a_sleeve_centre_3_of_opening_3
            .mul_add(
                minus_l,
                a_sleeve_centre_3_of_opening_2.mul_add(l, l * opening_sq_cos_theta),
            );
        let F_w_right_link_frame_2_of_place = w_right_arm_frame_in_right_link_frame_1_of_place
            .mul_add(
                w_right_arm_frame_in_right_link_frame_3_of_place_0,
                w_right_arm_frame_in_right_link_frame_3_of_place
                    .mul_add(
                        w_right_arm_frame_in_right_link_frame_1_of_place_0, sums[114],
                    ),
            );
        let F_w_right_link_frame_2_of_place_2 = a_right_link_centre_1_2_of_place
            .mul_add(
                weight,
                alpha_right_link_frame_2_of_opening_11
                    .mul_add(l_2_m, l_2_m * F_w_right_link_frame_2_of_place),
            );
        let F_w_left_link_frame_2_of_place = w_left_arm_frame_in_left_link_frame_1_of_place
            .mul_add(
                w_left_arm_frame_in_left_link_frame_3_of_place_0,
                w_left_arm_frame_in_left_link_frame_3_of_place
                    .mul_add(w_left_arm_frame_in_left_link_frame_1_of_place_0, sums[115]),
            );
        let F_w_right_arm_frame_2_of_spin = spin_sin_q_right_top
            .mul_add(
                spin_cos_q_right_top_0,
                spin_cos_q_right_top.mul_add(spin_sin_q_right_top_0, sums[116]),
            );
        let F_w_right_arm_frame_2_of_place = a_right_link_centre_3_2_of_place
            .mul_add(
                sin_q_right_ball_0,
                sin_q_right_ball.mul_add(a_right_link_centre_3_2_of_place_0, sums[117]),
            );
        let F_w_right_arm_frame_2_of_place_2 = a_right_link_centre_1_2_of_place
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball.mul_add(a_right_link_centre_1_2_of_place_0, sums[118]),
            );
        let F_w_right_arm_frame_2_of_place_3 = F_w_right_arm_frame_2_of_place_2
            .mul_add(
                weight_4,
                F_w_right_arm_frame_2_of_place
                    .mul_add(
                        weight_4,
                        a_right_link_centre_1_of_place
                            .mul_add(
                                minus_12_l_mb,
                                turn_right_arm_frame_13_of_place
                                    .mul_add(
                                        minus_3_l_2_m,
                                        alpha_right_arm_frame_2_of_opening_12
                                            .mul_add(
                                                minus_l_2_m,
                                                F_w_right_arm_frame_2_of_spin
                                                    .mul_add(l_2_m, minus_6_l_m_g * sin_q_right_top),
                                            ),
                                    ),
                            ) + F_w_right_link_frame_2_of_place_2,
                    ),
            );
        let sin_q_right_ball_sq = sin_q_right_ball
            .mul_add(sin_q_right_ball_0 + sin_q_right_ball_0, sums[119]);
        let J_right_link_frame_in_right_arm_frame_13_of_q_right_ball = sin_q_right_ball
            .mul_add(
                cos_q_right_ball_0,
                cos_q_right_ball.mul_add(sin_q_right_ball_0, sums[120]),
            );
        let sin_q_left_ball_sq = sin_q_left_ball
            .mul_add(sin_q_left_ball_0 + sin_q_left_ball_0, sums[121]);
        let J_left_link_frame_in_left_arm_frame_13_of_q_left_ball = sin_q_left_ball
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball.mul_add(sin_q_left_ball_0, sums[122]),
            );
        let J_right_arm_frame_13_of_place = J_right_link_frame_in_right_arm_frame_13_of_q_right_ball
            .mul_add(weight_5, weight_6 * sin_q_right_ball);
        let J_right_arm_frame_in_spindle_frame_31_of_place = sin_q_right_ball_sq
            .mul_add(weight_8, minus_12_l_2_m * cos_q_right_ball);
        let J_right_arm_frame_in_spindle_frame_of_place = J_right_arm_frame_in_spindle_frame_31_of_place
            .mul_add(
                sin_q_right_top_0,
                sin_q_right_top
                    .mul_add(J_right_arm_frame_in_spindle_frame_31_of_place_0, sums[123]),
            );
        let J_right_arm_frame_in_spindle_frame_of_place_2 = J_right_arm_frame_13_of_place
            .mul_add(
                cos_q_right_top_0,
                cos_q_right_top.mul_add(J_right_arm_frame_13_of_place_0, sums[124]),
            );
        let J_right_arm_frame_in_spindle_frame_of_place_3 = J_right_arm_frame_in_spindle_frame_of_place_2
            .mul_add(-S::int(2), J_right_arm_frame_in_spindle_frame_of_place);
        let J_right_arm_frame_in_spindle_frame_2_of_place = J_right_arm_frame_in_spindle_frame_of_place_3
            .mul_add(
                sin_q_right_top_0,
                sin_q_right_top
                    .mul_add(J_right_arm_frame_in_spindle_frame_of_place_3_0, sums[125]),
            );
        let J_left_arm_frame_13_of_place = J_left_link_frame_in_left_arm_frame_13_of_q_left_ball
            .mul_add(weight_5, weight_6 * sin_q_left_ball);
        let J_left_arm_frame_in_spindle_frame_31_of_place = sin_q_left_ball_sq
            .mul_add(weight_8, minus_12_l_2_m * cos_q_left_ball);
        let J_left_arm_frame_in_spindle_frame_of_place = J_left_arm_frame_in_spindle_frame_31_of_place
            .mul_add(
                sin_theta_0,
                sin_theta
                    .mul_add(J_left_arm_frame_in_spindle_frame_31_of_place_0, sums[126]),
            );
        let J_left_arm_frame_in_spindle_frame_of_place_2 = J_left_arm_frame_13_of_place
            .mul_add(
                cos_theta_0,
                cos_theta.mul_add(J_left_arm_frame_13_of_place_0, sums[127]),
            );
        let J_left_arm_frame_in_spindle_frame_of_place_3 = J_left_arm_frame_in_spindle_frame_of_place_2
            .mul_add(-S::int(2), J_left_arm_frame_in_spindle_frame_of_place);
        let J_left_arm_frame_in_spindle_frame_2_of_place = J_left_arm_frame_in_spindle_frame_of_place_3
            .mul_add(
                sin_theta_0,
                sin_theta
                    .mul_add(J_left_arm_frame_in_spindle_frame_of_place_3_0, sums[128]),
            );
        let J_spindle_frame_33_2_of_place = sin_q_left_ball_sq
            .mul_add(weight_5, weight_5 * sin_q_right_ball_sq)
            - J_right_arm_frame_in_spindle_frame_2_of_place
            - J_left_arm_frame_in_spindle_frame_2_of_place;
        let d2_of_place = sin_q_left_ball
            .mul_add(sin_theta_0, sin_theta.mul_add(sin_q_left_ball_0, sums[129]));
        let d2_of_place_2 = cos_q_left_ball
            .mul_add(cos_theta_0, cos_theta.mul_add(cos_q_left_ball_0, sums[130]));
        let d2_of_place_3 = d2_of_place - d2_of_place_2;
        let cos_theta_sq = cos_theta.mul_add(cos_theta_0 + cos_theta_0, sums[131]);
        let sin_q_right_ball_sq_2 = sin_q_right_ball
            .mul_add(sin_q_right_ball_0 + sin_q_right_ball_0, sums[132]);
        let sin_q_right_ball_inv2 = sin_q_right_ball_sq_2
            .mul_add(
                -(sin_q_right_ball_inv2_0 * over_sin_q_right_ball_sq_2),
                -(sums[133] * over_sin_q_right_ball_sq_2),
            );
        let d2_of_place_4 = weight_10 * sin_q_right_ball_inv2;
        let d2_of_place_5 = d2_of_place_4
            .mul_add(
                cos_q_right_top_0,
                cos_q_right_top.mul_add(d2_of_place_4_0, sums[134]),
            );
        let d2_of_place_6 = alpha_right_arm_frame_2_of_q_right_ball
            .mul_add(
                sin_q_right_top_0,
                sin_q_right_top
                    .mul_add(alpha_right_arm_frame_2_of_q_right_ball_0, sums[135]),
            );
        let d2_of_place_7 = minus_5_m_minus_6_mb * d2_of_place_6 + d2_of_place_5;
        let d2_of_place_8 = d2_of_place_7
            .mul_add(
                cos_q_right_top_0,
                cos_q_right_top.mul_add(d2_of_place_7_0, sums[136]),
            );
        let d2_of_place_9 = minus_5_m_minus_6_mb * cos_theta_sq + d2_of_place_8;
        let d2_of_place_10 = d2_of_place_9
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(d2_of_place_9_0, sums[137]),
            );
        let d2_of_place_11 = d2_of_place_2
            .mul_add(sin_theta_0, sin_theta.mul_add(d2_of_place_2_0, sums[138]));
        let d2_of_place_12 = minus_5_m_minus_6_mb * d2_of_place_11 + d2_of_place_10;
        let d2_of_place_13 = d2_of_place_12
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(d2_of_place_12_0, sums[139]),
            );
        let d2_of_place_14 = weight_10 * cos_theta_sq + d2_of_place_13;
        let d2_of_place_15 = d2_of_place_3
            .mul_add(d2_of_place_3_0 + d2_of_place_3_0, sums[140]);
        let d2_of_place_16 = d2_of_place_14
            .mul_add(
                over_d2_of_place_15,
                -(d2_of_place_15.mul_add(d2_of_place_16_0, sums[141]) * over_d2_of_place_15),
            );
        let opening_dot_of_spin = spin_sin_theta
            .mul_add(
                spin_cos_theta_0,
                spin_cos_theta.mul_add(spin_sin_theta_0, sums[142]),
            );
        let opening_dot_of_place = F_w_right_link_frame_2_of_place_2
            .mul_add(
                w_right_link_frame_2_of_place_0,
                w_right_link_frame_2_of_place
                    .mul_add(F_w_right_link_frame_2_of_place_2_0, sums[143]),
            );
        let opening_dot_of_place_2 = F_w_right_arm_frame_2_of_place_3
            .mul_add(
                cos_angle_0,
                cos_angle.mul_add(F_w_right_arm_frame_2_of_place_3_0, sums[144]),
            );
        let opening_dot_of_place_3 = opening_dot_of_place - opening_dot_of_place_2;
        let opening_dot_of_place_4 = opening_dot_of_place_3
            .mul_add(
                over_sin_q_right_ball,
                -(sin_q_right_ball.mul_add(opening_dot_of_place_4_0, sums[145])
                    * over_sin_q_right_ball),
            );
        let opening_dot_of_place_5 = F_w_right_link_frame_2_of_place_2
            .mul_add(
                sin_q_right_top_0,
                sin_q_right_top.mul_add(F_w_right_link_frame_2_of_place_2_0, sums[146]),
            );
        let opening_dot_of_place_6 = -opening_dot_of_place_5 + opening_dot_of_place_4;
        let opening_dot_of_place_7 = opening_dot_of_place_6
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(opening_dot_of_place_6_0, sums[147]),
            );
        let opening_dot_of_opening = a_sleeve_centre_3_of_opening_4
            .mul_add(
                sin_theta_plus_q_left_ball_0,
                sin_theta_plus_q_left_ball
                    .mul_add(a_sleeve_centre_3_of_opening_4_0, sums[148]),
            );
        let opening_dot_of_place_8 = opening_dot_of_opening
            .mul_add(
                minus_12_l_ms,
                a_left_link_centre_1_2_of_place
                    .mul_add(
                        weight,
                        alpha_left_link_frame_2_of_opening_4
                            .mul_add(l_2_m, l_2_m * F_w_left_link_frame_2_of_place),
                    ),
            );
        let opening_dot_of_place_9 = opening_dot_of_place_8
            .mul_add(
                cos_theta_0,
                cos_theta.mul_add(opening_dot_of_place_8_0, sums[149]),
            );
        let opening_dot_of_place_10 = opening_dot_of_place_9 + opening_dot_of_place_7;
        let opening_dot_of_place_11 = opening_dot_of_place_10
            .mul_add(
                over_cos_theta_plus_q_left_ball,
                -(cos_theta_plus_q_left_ball
                    .mul_add(opening_dot_of_place_11_0, sums[150])
                    * over_cos_theta_plus_q_left_ball),
            );
        let opening_dot_of_opening_2 = a_sleeve_centre_3_of_opening_4
            .mul_add(
                sin_theta_0,
                sin_theta.mul_add(a_sleeve_centre_3_of_opening_4_0, sums[151]),
            );
        let opening_dot_of_place_12 = a_left_link_centre_3_2_of_place
            .mul_add(
                sin_q_left_ball_0,
                sin_q_left_ball.mul_add(a_left_link_centre_3_2_of_place_0, sums[152]),
            );
        let opening_dot_of_place_13 = a_left_link_centre_1_2_of_place
            .mul_add(
                cos_q_left_ball_0,
                cos_q_left_ball.mul_add(a_left_link_centre_1_2_of_place_0, sums[153]),
            );
        let opening_dot_of_place_14 = opening_dot_of_opening_2
            .mul_add(
                minus_12_l_ms,
                opening_dot_of_place_13
                    .mul_add(
                        weight_4,
                        opening_dot_of_place_12
                            .mul_add(
                                weight_4,
                                a_left_link_centre_1_of_place
                                    .mul_add(
                                        weight_13,
                                        w_left_arm_frame_13_of_spin
                                            .mul_add(
                                                weight_12,
                                                opening_dot_of_spin
                                                    .mul_add(l_2_m, minus_6_l_m_g * sin_theta),
                                            ),
                                    ),
                            ),
                    ),
            ) - opening_dot_of_place_11;
        let opening_dot_of_place_15 = opening_dot_of_place_14
            .mul_add(
                over_d2_of_place_16,
                -(d2_of_place_16.mul_add(opening_dot_of_place_15_0, sums[154])
                    * over_d2_of_place_16),
            );
        let spin_dot_of_place = F_w_spindle_frame_in_right_arm_frame_3_of_place_3
            .mul_add(
                cos_q_right_top_0,
                cos_q_right_top
                    .mul_add(
                        F_w_spindle_frame_in_right_arm_frame_3_of_place_3_0, sums[155],
                    ),
            );
        let spin_dot_of_place_2 = F_w_spindle_frame_in_right_arm_frame_1_of_place_3
            .mul_add(
                sin_q_right_top_0,
                sin_q_right_top
                    .mul_add(
                        F_w_spindle_frame_in_right_arm_frame_1_of_place_3_0, sums[156],
                    ),
            );
        let spin_dot_of_opening = F_w_spindle_frame_in_left_arm_frame_3_of_opening
            .mul_add(
                cos_theta_0,
                cos_theta
                    .mul_add(
                        F_w_spindle_frame_in_left_arm_frame_3_of_opening_0, sums[157],
                    ),
            );
        let spin_dot_of_place_3 = F_w_spindle_frame_in_left_arm_frame_1_of_place_3
            .mul_add(
                sin_theta_0,
                sin_theta
                    .mul_add(
                        F_w_spindle_frame_in_left_arm_frame_1_of_place_3_0, sums[158],
                    ),
            );
        let spin_dot_of_place_4 = spin_dot_of_opening - spin_dot_of_place_3
            + spin_dot_of_place - spin_dot_of_place_2;
        let spin_dot_2 = spin_dot_of_place_4
            .mul_add(
                over_J_spindle_frame_33_2_of_place,
                -(J_spindle_frame_33_2_of_place.mul_add(spin_dot_2_0, sums[159])
                    * over_J_spindle_frame_33_2_of_place),
            );
        psi_rate = spin;
        theta_rate = opening;
        q_right_top_rate = q_right_top_dot_2;
        q_left_ball_rate = -w_left_link_frame_2_of_opening;
        q_right_ball_rate = -w_right_link_frame_2_of_opening;
        spin_rate = spin_dot_2;
        opening_rate = weight_14 * opening_dot_of_place_15;
        // Factors of the convolutions: left, right.
        history[order] = [
            [
                count * theta,
                count * theta,
                spin, spin,
                count * q_right_top,
                count * q_right_top,
                spin, spin,
                count * theta_plus_q_left_ball,
                count * theta_plus_q_left_ball,
                count * q_left_ball,
                count * q_left_ball,
                count * w_right_arm_frame_2_of_place,
                count * w_right_arm_frame_2_of_place,
                count * q_right_ball,
                count * q_right_ball,
                cos_theta_plus_q_left_ball, sin_q_left_ball, sin_q_right_ball, cos_angle,
                sin_q_left_ball, cos_q_left_ball, cos_q_left_ball, sin_q_left_ball,
                w_left_link_frame_2_of_place, sin_q_right_ball, cos_q_right_ball, cos_q_right_ball,
                sin_q_right_ball, cos_q_right_top, sin_q_right_top, w_right_link_frame_2_of_place_3,
                opening, spin_cos_q_right_top, spin_cos_q_right_top, opening, opening,
                w_left_arm_frame_in_left_link_frame_3_of_place,
                w_left_arm_frame_in_left_link_frame_3_of_place, cos_angle,
                w_right_arm_frame_2_of_opening_2, q_right_top_dot_2,
                w_right_arm_frame_in_right_link_frame_3_of_place,
                w_right_arm_frame_in_right_link_frame_3_of_place,
                w_right_arm_frame_in_right_link_frame_1_of_place, w_right_link_frame_2_of_opening_2,
                w_right_arm_frame_in_right_link_frame_3_of_place,
                w_left_arm_frame_in_left_link_frame_1_of_place, w_left_link_frame_2_of_opening_2,
                w_left_arm_frame_in_left_link_frame_3_of_place, spin_sin_q_right_top,
                q_right_top_dot_2, cos_q_right_ball, sin_q_right_ball, spin_cos_q_right_top,
                sin_q_right_ball, cos_q_right_ball, spin_sin_theta, opening, cos_q_left_ball,
                sin_q_left_ball, spin_cos_theta, sin_q_left_ball, cos_q_left_ball, spin_sin_theta,
                spin_sin_theta, opening, sin_theta_plus_q_left_ball, cos_theta_plus_q_left_ball,
                q_right_top_dot_2, sin_q_right_ball, w_right_arm_frame_2_of_opening,
                alpha_right_arm_frame_2_of_place, cos_angle, sin_angle,
                alpha_right_arm_frame_2_of_opening, sin_q_right_ball,
                w_right_link_frame_2_of_opening, q_right_top_dot_2, spin_sin_q_right_top,
                spin_sin_q_right_top, q_right_top_dot_2, opening, w_left_link_frame_2_of_opening,
                alpha_left_link_frame_2_of_opening, w_left_arm_frame_in_left_link_frame_1_of_place,
                w_left_arm_frame_in_left_link_frame_1_of_place, w_left_link_frame_2_of_opening_2,
                sin_q_right_top, q_right_top_dot_2, cos_q_right_top,
                w_right_link_frame_2_of_place_3, cos_angle, sin_q_right_top,
                w_right_link_frame_2_of_opening, w_right_link_frame_2_of_opening,
                w_right_link_frame_2_of_place_3, w_right_link_frame_2_of_opening,
                alpha_right_link_frame_2_of_opening_9,
                w_right_arm_frame_in_right_link_frame_1_of_place,
                w_right_arm_frame_in_right_link_frame_1_of_place, w_right_link_frame_2_of_opening_2,
                sin_q_left_ball, cos_q_left_ball, cos_q_left_ball, sin_q_left_ball,
                sin_q_right_ball, cos_q_right_ball, cos_q_right_ball, sin_q_right_ball, cos_theta,
                cos_theta_plus_q_left_ball, w_left_link_frame_2_of_opening_2,
                sin_theta_plus_q_left_ball, w_right_arm_frame_in_right_link_frame_3_of_place,
                w_left_arm_frame_in_left_link_frame_3_of_place, spin_cos_q_right_top,
                sin_q_right_ball, cos_q_right_ball, sin_q_right_ball, cos_q_right_ball,
                sin_q_left_ball, cos_q_left_ball, sin_q_right_top, cos_q_right_top, sin_q_right_top,
                sin_theta, cos_theta, sin_theta, sin_theta, cos_theta, cos_theta, sin_q_right_ball,
                sin_q_right_ball_sq_2, cos_q_right_top, sin_q_right_top, cos_q_right_top,
                sin_q_left_ball, sin_theta, sin_q_left_ball, d2_of_place_3, d2_of_place_15,
                spin_cos_theta, F_w_right_link_frame_2_of_place_2, cos_angle, sin_q_right_ball,
                sin_q_right_top, sin_q_left_ball, sin_theta_plus_q_left_ball, cos_theta,
                cos_theta_plus_q_left_ball, sin_theta, sin_q_left_ball, cos_q_left_ball,
                d2_of_place_16, cos_q_right_top, sin_q_right_top, cos_theta, sin_theta,
                J_spindle_frame_33_2_of_place,
            ],
            [
                cos_theta, sin_theta, sin_theta, cos_theta, cos_q_right_top, sin_q_right_top,
                sin_q_right_top, cos_q_right_top, cos_theta_plus_q_left_ball,
                sin_theta_plus_q_left_ball, cos_q_left_ball, sin_q_left_ball, cos_angle, sin_angle,
                cos_q_right_ball, sin_q_right_ball, w_right_arm_frame_2_of_opening,
                w_right_arm_frame_2_of_opening, w_right_arm_frame_2_of_opening_3,
                w_right_arm_frame_2_of_opening_3, spin_cos_theta, spin_sin_theta, spin_cos_theta,
                spin_sin_theta, w_right_arm_frame_2_of_opening, spin_cos_q_right_top,
                spin_sin_q_right_top, spin_cos_q_right_top, spin_sin_q_right_top,
                w_right_link_frame_2_of_q_right_ball, sin_q_right_ball,
                w_right_arm_frame_2_of_opening_3, spin_cos_theta, q_right_top_dot_2,
                q_right_top_dot_2, w_left_arm_frame_in_left_link_frame_3_of_spin_2,
                w_left_arm_frame_in_left_link_frame_3_of_spin, w_left_link_frame_2_of_opening,
                w_left_link_frame_2_of_opening_2, spin_sin_q_right_top,
                alpha_right_arm_frame_in_right_link_frame_1_of_spin,
                w_right_arm_frame_in_right_link_frame_3_of_spin, w_right_link_frame_2_of_opening,
                w_right_link_frame_2_of_opening_2, w_right_link_frame_2_of_opening_2,
                w_right_arm_frame_in_right_link_frame_1_of_place, w_right_link_frame_2_of_opening_2,
                w_left_link_frame_2_of_opening_2, w_left_arm_frame_in_left_link_frame_1_of_place,
                w_left_link_frame_2_of_opening_2, q_right_top_dot_2, spin_sin_q_right_top,
                F_w_right_arm_frame_in_right_link_frame_3_of_place,
                F_w_right_arm_frame_in_right_link_frame_1_of_place, q_right_top_dot_2,
                F_w_right_arm_frame_in_right_link_frame_3_of_place,
                F_w_right_arm_frame_in_right_link_frame_1_of_place, opening, spin_sin_theta,
                F_w_left_arm_frame_in_left_link_frame_3_of_place,
                F_w_left_arm_frame_in_left_link_frame_1_of_place, opening,
                F_w_left_arm_frame_in_left_link_frame_3_of_place,
                F_w_left_arm_frame_in_left_link_frame_1_of_place, spin_sin_theta, spin_cos_theta,
                opening, w_left_link_frame_2_of_opening_2, alpha_right_arm_frame_2_of_opening_3,
                alpha_right_arm_frame_2_of_opening_3, alpha_right_arm_frame_2_of_place,
                w_left_link_frame_2_of_opening, alpha_right_arm_frame_2_of_opening_5,
                alpha_right_arm_frame_2_of_opening_6, w_right_arm_frame_2_of_opening_3,
                alpha_right_arm_frame_2_of_opening_8, alpha_right_arm_frame_2_of_q_right_ball,
                alpha_right_arm_frame_2_of_q_right_ball, alpha_right_arm_frame_2_of_opening_10,
                spin_sin_q_right_top, spin_cos_q_right_top, q_right_top_dot_2, sin_theta,
                alpha_right_arm_frame_2_of_opening_3, w_right_arm_frame_2_of_opening,
                w_left_arm_frame_in_left_link_frame_1_of_place,
                w_left_arm_frame_in_left_link_frame_3_of_place, w_left_link_frame_2_of_opening_2,
                w_right_link_frame_2_of_q_right_ball, alpha_right_link_frame_2_of_place,
                w_right_arm_frame_2_of_opening_2, alpha_right_link_frame_2_of_opening_2,
                alpha_right_link_frame_2_of_opening_2, cos_q_right_ball,
                alpha_right_link_frame_2_of_place_2, alpha_right_arm_frame_2_of_opening_3,
                alpha_right_arm_frame_2_of_opening_6, alpha_right_arm_frame_2_of_opening_10,
                w_right_arm_frame_2_of_opening_3, w_right_arm_frame_in_right_link_frame_1_of_place,
                w_right_arm_frame_in_right_link_frame_3_of_place, w_right_link_frame_2_of_opening_2,
                a_left_link_centre_3_of_place, a_left_link_centre_1_of_place,
                a_left_link_centre_3_of_place, a_left_link_centre_1_of_place,
                a_right_link_centre_3_of_place, a_right_link_centre_1_of_place,
                a_right_link_centre_3_of_place, a_right_link_centre_1_of_place, opening_sq,
                w_left_link_frame_2_of_opening_2, a_sleeve_centre_3_of_opening,
                alpha_left_link_frame_2_of_opening_4,
                w_right_arm_frame_in_right_link_frame_1_of_place,
                w_left_arm_frame_in_left_link_frame_1_of_place, spin_sin_q_right_top,
                a_right_link_centre_3_2_of_place, a_right_link_centre_1_2_of_place,
                sin_q_right_ball, sin_q_right_ball, sin_q_left_ball, sin_q_left_ball,
                J_right_arm_frame_in_spindle_frame_31_of_place, J_right_arm_frame_13_of_place,
                J_right_arm_frame_in_spindle_frame_of_place_3,
                J_left_arm_frame_in_spindle_frame_31_of_place, J_left_arm_frame_13_of_place,
                J_left_arm_frame_in_spindle_frame_of_place_3, sin_q_left_ball, cos_q_left_ball,
                cos_theta, sin_q_right_ball, sin_q_right_ball_inv2, d2_of_place_4,
                alpha_right_arm_frame_2_of_q_right_ball, d2_of_place_7, d2_of_place_9,
                d2_of_place_2, d2_of_place_12, d2_of_place_3, d2_of_place_16, spin_sin_theta,
                w_right_link_frame_2_of_place, F_w_right_arm_frame_2_of_place_3,
                opening_dot_of_place_4, F_w_right_link_frame_2_of_place_2, opening_dot_of_place_6,
                a_sleeve_centre_3_of_opening_4, opening_dot_of_place_8, opening_dot_of_place_11,
                a_sleeve_centre_3_of_opening_4, a_left_link_centre_3_2_of_place,
                a_left_link_centre_1_2_of_place, opening_dot_of_place_15,
                F_w_spindle_frame_in_right_arm_frame_3_of_place_3,
                F_w_spindle_frame_in_right_arm_frame_1_of_place_3,
                F_w_spindle_frame_in_left_arm_frame_3_of_opening,
                F_w_spindle_frame_in_left_arm_frame_1_of_place_3, spin_dot_2,
            ],
        ];
        count_last = count;
        theta_last = theta;
        q_right_top_last = q_right_top;
        q_left_ball_last = q_left_ball;
        q_right_ball_last = q_right_ball;
        spin_last = spin;
        opening_last = opening;
        sin_theta_last = sin_theta;
        cos_theta_last = cos_theta;
        spin_sin_theta_last = spin_sin_theta;
        spin_cos_theta_last = spin_cos_theta;
        sin_q_right_top_last = sin_q_right_top;
        cos_q_right_top_last = cos_q_right_top;
        spin_sin_q_right_top_last = spin_sin_q_right_top;
        spin_cos_q_right_top_last = spin_cos_q_right_top;
        theta_plus_q_left_ball_last = theta_plus_q_left_ball;
        sin_theta_plus_q_left_ball_last = sin_theta_plus_q_left_ball;
        cos_theta_plus_q_left_ball_last = cos_theta_plus_q_left_ball;
        sin_q_left_ball_last = sin_q_left_ball;
        cos_q_left_ball_last = cos_q_left_ball;
        w_right_arm_frame_2_of_place_last = w_right_arm_frame_2_of_place;
        sin_angle_last = sin_angle;
        cos_angle_last = cos_angle;
        sin_q_right_ball_last = sin_q_right_ball;
        cos_q_right_ball_last = cos_q_right_ball;
        w_right_arm_frame_2_of_opening_last = w_right_arm_frame_2_of_opening;
        w_right_arm_frame_2_of_opening_2_last = w_right_arm_frame_2_of_opening_2;
        w_right_arm_frame_2_of_opening_3_last = w_right_arm_frame_2_of_opening_3;
        q_right_top_dot_2_last = q_right_top_dot_2;
        w_left_arm_frame_in_left_link_frame_1_of_place_last = w_left_arm_frame_in_left_link_frame_1_of_place;
        w_left_arm_frame_in_left_link_frame_3_of_spin_last = w_left_arm_frame_in_left_link_frame_3_of_spin;
        w_left_arm_frame_in_left_link_frame_3_of_spin_2_last = w_left_arm_frame_in_left_link_frame_3_of_spin_2;
        w_left_arm_frame_in_left_link_frame_3_of_place_last = w_left_arm_frame_in_left_link_frame_3_of_place;
        w_left_link_frame_2_of_place_last = w_left_link_frame_2_of_place;
        w_left_link_frame_2_of_opening_last = w_left_link_frame_2_of_opening;
        w_left_link_frame_2_of_opening_2_last = w_left_link_frame_2_of_opening_2;
        w_right_arm_frame_in_right_link_frame_1_of_place_last = w_right_arm_frame_in_right_link_frame_1_of_place;
        w_right_arm_frame_in_right_link_frame_3_of_spin_last = w_right_arm_frame_in_right_link_frame_3_of_spin;
        w_right_arm_frame_in_right_link_frame_3_of_place_last = w_right_arm_frame_in_right_link_frame_3_of_place;
        w_right_link_frame_2_of_q_right_ball_last = w_right_link_frame_2_of_q_right_ball;
        w_right_link_frame_2_of_place_last = w_right_link_frame_2_of_place;
        w_right_link_frame_2_of_place_3_last = w_right_link_frame_2_of_place_3;
        w_right_link_frame_2_of_opening_last = w_right_link_frame_2_of_opening;
        w_right_link_frame_2_of_opening_2_last = w_right_link_frame_2_of_opening_2;
        alpha_right_arm_frame_in_right_link_frame_1_of_spin_last = alpha_right_arm_frame_in_right_link_frame_1_of_spin;
        F_w_right_arm_frame_in_right_link_frame_3_of_place_last = F_w_right_arm_frame_in_right_link_frame_3_of_place;
        F_w_right_arm_frame_in_right_link_frame_1_of_place_last = F_w_right_arm_frame_in_right_link_frame_1_of_place;
        F_w_left_arm_frame_in_left_link_frame_3_of_place_last = F_w_left_arm_frame_in_left_link_frame_3_of_place;
        F_w_left_arm_frame_in_left_link_frame_1_of_place_last = F_w_left_arm_frame_in_left_link_frame_1_of_place;
        F_w_spindle_frame_in_right_arm_frame_3_of_place_3_last = F_w_spindle_frame_in_right_arm_frame_3_of_place_3;
        F_w_spindle_frame_in_right_arm_frame_1_of_place_3_last = F_w_spindle_frame_in_right_arm_frame_1_of_place_3;
        F_w_spindle_frame_in_left_arm_frame_3_of_opening_last = F_w_spindle_frame_in_left_arm_frame_3_of_opening;
        F_w_spindle_frame_in_left_arm_frame_1_of_place_3_last = F_w_spindle_frame_in_left_arm_frame_1_of_place_3;
        opening_sq_last = opening_sq;
        alpha_right_arm_frame_2_of_opening_last = alpha_right_arm_frame_2_of_opening;
        alpha_right_arm_frame_2_of_opening_3_last = alpha_right_arm_frame_2_of_opening_3;
        alpha_right_arm_frame_2_of_place_last = alpha_right_arm_frame_2_of_place;
        alpha_right_arm_frame_2_of_opening_5_last = alpha_right_arm_frame_2_of_opening_5;
        alpha_right_arm_frame_2_of_opening_6_last = alpha_right_arm_frame_2_of_opening_6;
        alpha_right_arm_frame_2_of_opening_8_last = alpha_right_arm_frame_2_of_opening_8;
        alpha_right_arm_frame_2_of_q_right_ball_last = alpha_right_arm_frame_2_of_q_right_ball;
        alpha_right_arm_frame_2_of_opening_10_last = alpha_right_arm_frame_2_of_opening_10;
        alpha_left_link_frame_2_of_opening_last = alpha_left_link_frame_2_of_opening;
        alpha_left_link_frame_2_of_opening_4_last = alpha_left_link_frame_2_of_opening_4;
        alpha_right_link_frame_2_of_place_last = alpha_right_link_frame_2_of_place;
        alpha_right_link_frame_2_of_opening_2_last = alpha_right_link_frame_2_of_opening_2;
        alpha_right_link_frame_2_of_place_2_last = alpha_right_link_frame_2_of_place_2;
        alpha_right_link_frame_2_of_opening_9_last = alpha_right_link_frame_2_of_opening_9;
        a_left_link_centre_1_of_place_last = a_left_link_centre_1_of_place;
        a_left_link_centre_3_of_place_last = a_left_link_centre_3_of_place;
        a_left_link_centre_1_2_of_place_last = a_left_link_centre_1_2_of_place;
        a_left_link_centre_3_2_of_place_last = a_left_link_centre_3_2_of_place;
        a_right_link_centre_1_of_place_last = a_right_link_centre_1_of_place;
        a_right_link_centre_3_of_place_last = a_right_link_centre_3_of_place;
        a_right_link_centre_1_2_of_place_last = a_right_link_centre_1_2_of_place;
        a_right_link_centre_3_2_of_place_last = a_right_link_centre_3_2_of_place;
        a_sleeve_centre_3_of_opening_last = a_sleeve_centre_3_of_opening;
        a_sleeve_centre_3_of_opening_4_last = a_sleeve_centre_3_of_opening_4;
        F_w_right_link_frame_2_of_place_2_last = F_w_right_link_frame_2_of_place_2;
        F_w_right_arm_frame_2_of_place_3_last = F_w_right_arm_frame_2_of_place_3;
        J_right_arm_frame_13_of_place_last = J_right_arm_frame_13_of_place;
        J_right_arm_frame_in_spindle_frame_31_of_place_last = J_right_arm_frame_in_spindle_frame_31_of_place;
        J_right_arm_frame_in_spindle_frame_of_place_3_last = J_right_arm_frame_in_spindle_frame_of_place_3;
        J_left_arm_frame_13_of_place_last = J_left_arm_frame_13_of_place;
        J_left_arm_frame_in_spindle_frame_31_of_place_last = J_left_arm_frame_in_spindle_frame_31_of_place;
        J_left_arm_frame_in_spindle_frame_of_place_3_last = J_left_arm_frame_in_spindle_frame_of_place_3;
        J_spindle_frame_33_2_of_place_last = J_spindle_frame_33_2_of_place;
        d2_of_place_2_last = d2_of_place_2;
        d2_of_place_3_last = d2_of_place_3;
        sin_q_right_ball_sq_2_last = sin_q_right_ball_sq_2;
        sin_q_right_ball_inv2_last = sin_q_right_ball_inv2;
        d2_of_place_4_last = d2_of_place_4;
        d2_of_place_7_last = d2_of_place_7;
        d2_of_place_9_last = d2_of_place_9;
        d2_of_place_12_last = d2_of_place_12;
        d2_of_place_15_last = d2_of_place_15;
        d2_of_place_16_last = d2_of_place_16;
        opening_dot_of_place_4_last = opening_dot_of_place_4;
        opening_dot_of_place_6_last = opening_dot_of_place_6;
        opening_dot_of_place_8_last = opening_dot_of_place_8;
        opening_dot_of_place_11_last = opening_dot_of_place_11;
        opening_dot_of_place_15_last = opening_dot_of_place_15;
        spin_dot_2_last = spin_dot_2;
    }
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
        out.copy_from_slice(
            jacobian(&Parameters::from_slice(p), array(q), array(v)).as_flattened(),
        );
    }
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, order: usize) -> usize {
        320 * order + SLACK
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
    slice.try_into().expect("a slice of the length that System states")
}
