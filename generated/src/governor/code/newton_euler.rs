//! Flyball governor: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/governor/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{constraint_slopes, constraints, coordinate_rates};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows spindle force spindle_frame1, spindle force spindle_frame2, spindle force spindle_frame3, spindle moment spindle_frame1, spindle moment spindle_frame2, spindle moment spindle_frame3, left_arm force left_arm_frame1, left_arm force left_arm_frame2, left_arm force left_arm_frame3, left_arm moment left_arm_frame1, left_arm moment left_arm_frame2, left_arm moment left_arm_frame3, right_arm force right_arm_frame1, right_arm force right_arm_frame2, right_arm force right_arm_frame3, right_arm moment right_arm_frame1, right_arm moment right_arm_frame2, right_arm moment right_arm_frame3, left_link force left_link_frame1, left_link force left_link_frame2, left_link force left_link_frame3, left_link moment left_link_frame1, left_link moment left_link_frame2, left_link moment left_link_frame3, right_link force right_link_frame1, right_link force right_link_frame2, right_link force right_link_frame3, right_link moment right_link_frame1, right_link moment right_link_frame2, right_link moment right_link_frame3, sleeve force sleeve_frame1, sleeve force sleeve_frame3, sleeve moment sleeve_frame2, sleeve moment sleeve_frame3, left force n1, left force n2, left force n3, right force n1, right force n2, right force n3.
///
/// 241 operations, 7 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 2],
) -> [[S; 40]; 40] {
    let Parameters { l, m, mb, ms, J, Js, .. } = *p;
    let [psi, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Step by step, each after the terms that it needs.
    let theta_plus_q_left_ball = theta + q_left_ball;
    let (sin_theta_plus_q_left_ball, cos_theta_plus_q_left_ball) = theta_plus_q_left_ball
        .sin_cos();
    let x_spindle_frame_3_of_place = cos_theta + cos_theta_plus_q_left_ball;
    let x_spindle_frame_3 = l * x_spindle_frame_3_of_place;
    let x_left_arm_frame_1_3 = l * m;
    let x_left_arm_frame_in_spindle_frame_1_2 = l * sin_theta;
    let x_left_arm_frame_2_3 = m * x_left_arm_frame_in_spindle_frame_1_2;
    let x_left_arm_frame_2_4 = l * x_left_arm_frame_1_3;
    let x_left_arm_frame_1_4 = x_left_arm_frame_2_4 * sin_theta;
    let x_left_arm_frame_in_spindle_frame_3_2 = l * cos_theta;
    let x_spindle_frame_in_left_arm_frame_1 = x_left_arm_frame_in_spindle_frame_3_2
        .mul_add(cos_theta, x_left_arm_frame_in_spindle_frame_1_2 * sin_theta);
    let x_spindle_frame_in_left_arm_frame_3 = (-x_left_arm_frame_in_spindle_frame_3_2)
        .mul_add(sin_theta, x_left_arm_frame_in_spindle_frame_1_2 * cos_theta);
    let alpha_right_arm_frame_2_2_of_place = S::int(1) / cos_theta_plus_q_left_ball;
    let alpha_right_arm_frame_2_2_of_place_2 = alpha_right_arm_frame_2_2_of_place
        * sin_q_left_ball / sin_q_right_ball;
    let (_, cos_angle) = (q_right_top + q_right_ball).sin_cos();
    let alpha_right_arm_frame_2_2 = alpha_right_arm_frame_2_2_of_place_2 * cos_angle;
    let a_right_arm_centre_1_2 = l * alpha_right_arm_frame_2_2;
    let x_right_arm_frame_1_3 = m * a_right_arm_centre_1_2;
    let x_right_arm_frame_in_spindle_frame_1_2 = l * sin_q_right_top;
    let x_right_arm_frame_2_3 = m * x_right_arm_frame_in_spindle_frame_1_2;
    let x_right_arm_frame_1_4 = x_left_arm_frame_2_4 * sin_q_right_top;
    let x_right_arm_frame_in_spindle_frame_3_2 = l * cos_q_right_top;
    let x_spindle_frame_in_right_arm_frame_1 = x_right_arm_frame_in_spindle_frame_3_2
        .mul_add(
            cos_q_right_top,
            x_right_arm_frame_in_spindle_frame_1_2 * sin_q_right_top,
        );
    let x_right_arm_frame_2_4 = x_left_arm_frame_2_4 * alpha_right_arm_frame_2_2;
    let x_spindle_frame_in_right_arm_frame_3 = (-x_right_arm_frame_in_spindle_frame_3_2)
        .mul_add(
            sin_q_right_top,
            x_right_arm_frame_in_spindle_frame_1_2 * cos_q_right_top,
        );
    let w_left_link_frame_2_2_of_place = (-x_spindle_frame_3_of_place)
        .mul_add(alpha_right_arm_frame_2_2_of_place, S::int(1));
    let w_left_link_frame_2_2 = -w_left_link_frame_2_2_of_place;
    let x_left_link_frame_in_left_arm_frame_3 = l * cos_q_left_ball;
    let a_left_link_centre_1_3 = (-l)
        .mul_add(
            w_left_link_frame_2_2,
            S::int(2) * x_left_link_frame_in_left_arm_frame_3,
        );
    let x_left_link_frame_1_3 = m * a_left_link_centre_1_3;
    let x_left_arm_frame_in_left_link_frame_1 = (-cos_theta)
        .mul_add(cos_q_left_ball, sin_theta * sin_q_left_ball);
    let x_left_arm_frame_in_left_link_frame_1_2 = sin_theta
        .mul_add(cos_q_left_ball, cos_theta * sin_q_left_ball);
    let a_left_link_centre_2_2 = l
        .mul_add(
            x_left_arm_frame_in_left_link_frame_1_2,
            S::int(2) * x_left_arm_frame_in_spindle_frame_1_2,
        );
    let x_left_link_frame_2_3 = m * a_left_link_centre_2_2;
    let x_left_link_frame_in_left_arm_frame_1 = l * sin_q_left_ball;
    let x_left_link_frame_3_3 = m * x_left_link_frame_in_left_arm_frame_1;
    let x_left_link_frame_1_4 = x_left_arm_frame_2_4 * x_left_arm_frame_in_left_link_frame_1_2;
    let x_left_arm_frame_in_left_link_frame_1_3 = x_left_link_frame_in_left_arm_frame_1
        .mul_add(
            sin_q_left_ball,
            x_left_link_frame_in_left_arm_frame_3 * cos_q_left_ball,
        );
    let x_left_link_frame_2_4 = x_left_arm_frame_2_4 * w_left_link_frame_2_2;
    let x_left_arm_frame_in_spindle_frame_3_3_of_place = x_left_link_frame_in_left_arm_frame_1
        * sin_theta;
    let x_left_arm_frame_in_spindle_frame_3_3 = x_left_link_frame_in_left_arm_frame_3
        .mul_add(cos_theta, -x_left_arm_frame_in_spindle_frame_3_3_of_place);
    let x_left_arm_frame_in_spindle_frame_1_3_of_place = x_left_link_frame_in_left_arm_frame_1
        * cos_theta;
    let x_left_arm_frame_in_spindle_frame_1_3 = x_left_link_frame_in_left_arm_frame_3
        .mul_add(sin_theta, x_left_arm_frame_in_spindle_frame_1_3_of_place);
    let x_left_arm_frame_in_left_link_frame_3 = (-x_left_link_frame_in_left_arm_frame_3)
        .mul_add(
            sin_q_left_ball,
            x_left_link_frame_in_left_arm_frame_1 * cos_q_left_ball,
        );
    let alpha_right_link_frame_2_2_of_place = sin_q_right_top * sin_q_right_ball;
    let alpha_right_link_frame_2_2 = alpha_right_arm_frame_2_2_of_place_2
        * (cos_q_right_top * (S::int(1) + cos_q_right_ball)
            - alpha_right_link_frame_2_2_of_place) - alpha_right_arm_frame_2_2;
    let a_right_arm_frame_in_right_link_frame_1_2 = a_right_arm_centre_1_2 * cos_q_right_ball;
    let a_right_link_centre_1_3 = (-a_right_arm_frame_in_right_link_frame_1_2)
        .mul_add(S::int(2), l * alpha_right_link_frame_2_2);
    let x_right_link_frame_1_3 = m * a_right_link_centre_1_3;
    let x_right_arm_frame_in_right_link_frame_1 = (-cos_q_right_top)
        .mul_add(cos_q_right_ball, alpha_right_link_frame_2_2_of_place);
    let x_right_arm_frame_in_right_link_frame_1_2 = sin_q_right_top
        .mul_add(cos_q_right_ball, cos_q_right_top * sin_q_right_ball);
    let a_right_link_centre_2_2 = l
        .mul_add(
            x_right_arm_frame_in_right_link_frame_1_2,
            S::int(2) * x_right_arm_frame_in_spindle_frame_1_2,
        );
    let x_right_link_frame_2_3 = m * a_right_link_centre_2_2;
    let a_right_arm_frame_in_right_link_frame_3_2 = a_right_arm_centre_1_2 * sin_q_right_ball;
    let x_right_link_frame_3_3 = m * a_right_arm_frame_in_right_link_frame_3_2;
    let x_right_link_frame_1_4 = x_left_arm_frame_2_4 * x_right_arm_frame_in_right_link_frame_1_2;
    let x_right_link_frame_in_right_arm_frame_1 = l * sin_q_right_ball;
    let x_right_link_frame_in_right_arm_frame_3 = l * cos_q_right_ball;
    let x_right_arm_frame_in_right_link_frame_1_3 = x_right_link_frame_in_right_arm_frame_3
        .mul_add(
            cos_q_right_ball,
            x_right_link_frame_in_right_arm_frame_1 * sin_q_right_ball,
        );
    let x_right_link_frame_2_4 = x_left_arm_frame_2_4 * alpha_right_link_frame_2_2;
    let x_right_arm_frame_in_spindle_frame_3_3_of_place = x_right_link_frame_in_right_arm_frame_1
        * sin_q_right_top;
    let x_right_arm_frame_in_spindle_frame_3_3 = x_right_link_frame_in_right_arm_frame_3
        .mul_add(cos_q_right_top, -x_right_arm_frame_in_spindle_frame_3_3_of_place);
    let x_right_arm_frame_in_spindle_frame_1_3_of_place = x_right_link_frame_in_right_arm_frame_1
        * cos_q_right_top;
    let x_right_arm_frame_in_spindle_frame_1_3 = x_right_link_frame_in_right_arm_frame_3
        .mul_add(sin_q_right_top, x_right_arm_frame_in_spindle_frame_1_3_of_place);
    let x_right_arm_frame_in_right_link_frame_3 = (-x_right_link_frame_in_right_arm_frame_3)
        .mul_add(
            sin_q_right_ball,
            x_right_link_frame_in_right_arm_frame_1 * cos_q_right_ball,
        );
    let a_sleeve_centre_3_2 = l
        * w_left_link_frame_2_2_of_place.mul_add(sin_theta_plus_q_left_ball, sin_theta);
    let x_spindle_frame_in_sleeve_frame_3_2 = ms * a_sleeve_centre_3_2;
    let x_sleeve_frame_3 = l + x_left_link_frame_in_left_arm_frame_3;
    let x_left_arm_frame_in_spindle_frame_3_4 = (-x_sleeve_frame_3)
        .mul_add(cos_theta, x_left_arm_frame_in_spindle_frame_3_3_of_place);
    let x_sleeve_frame_3_2 = x_spindle_frame_3 + x_left_arm_frame_in_spindle_frame_3_4;
    let x_left_arm_frame_in_spindle_frame_1_4 = x_sleeve_frame_3
        .mul_add(sin_theta, x_left_arm_frame_in_spindle_frame_1_3_of_place);
    let x_sleeve_frame_3_3 = l + x_right_link_frame_in_right_arm_frame_3;
    let x_right_arm_frame_in_spindle_frame_3_4 = (-x_sleeve_frame_3_3)
        .mul_add(cos_q_right_top, x_right_arm_frame_in_spindle_frame_3_3_of_place);
    let x_sleeve_frame_3_4 = x_spindle_frame_3 + x_right_arm_frame_in_spindle_frame_3_4;
    let x_right_arm_frame_in_spindle_frame_1_4 = x_sleeve_frame_3_3
        .mul_add(sin_q_right_top, x_right_arm_frame_in_spindle_frame_1_3_of_place);
    let x_left_arm_frame_in_spindle_frame_2_2 = mb * x_left_arm_frame_in_spindle_frame_1_2;
    let x_spindle_frame_in_N_1_3 = x_left_arm_frame_in_spindle_frame_2_2 * sin_psi;
    let x_left_arm_frame_in_spindle_frame_1_5 = mb * x_left_arm_frame_in_spindle_frame_3_2;
    let x_spindle_frame_in_N_1_4 = x_left_arm_frame_in_spindle_frame_1_5 * cos_psi;
    let x_spindle_frame_in_N_1_5 = cos_psi * cos_theta;
    let x_spindle_frame_in_N_1_6 = cos_psi * sin_theta;
    let x_spindle_frame_in_N_2_3 = x_left_arm_frame_in_spindle_frame_2_2 * cos_psi;
    let x_spindle_frame_in_N_2_4 = x_left_arm_frame_in_spindle_frame_1_5 * sin_psi;
    let x_spindle_frame_in_N_2_5 = sin_psi * cos_theta;
    let x_spindle_frame_in_N_2_6 = sin_psi * sin_theta;
    let x_left_arm_frame_in_spindle_frame_3_5 = x_left_arm_frame_in_spindle_frame_2_2;
    let x_right_arm_frame_in_spindle_frame_2_2 = mb * x_right_arm_frame_in_spindle_frame_1_2;
    let x_spindle_frame_in_N_1_7 = x_right_arm_frame_in_spindle_frame_2_2 * sin_psi;
    let x_right_arm_frame_in_spindle_frame_1_5_of_place = mb * a_right_arm_centre_1_2;
    let x_right_arm_frame_in_spindle_frame_1_5 = x_right_arm_frame_in_spindle_frame_1_5_of_place
        * cos_q_right_top;
    let x_spindle_frame_in_N_1_8 = x_right_arm_frame_in_spindle_frame_1_5 * cos_psi;
    let x_spindle_frame_in_N_1_9 = cos_psi * cos_q_right_top;
    let x_spindle_frame_in_N_1_10 = cos_psi * sin_q_right_top;
    let x_spindle_frame_in_N_2_7 = x_right_arm_frame_in_spindle_frame_2_2 * cos_psi;
    let x_spindle_frame_in_N_2_8 = x_right_arm_frame_in_spindle_frame_1_5 * sin_psi;
    let x_spindle_frame_in_N_2_9 = sin_psi * cos_q_right_top;
    let x_spindle_frame_in_N_2_10 = sin_psi * sin_q_right_top;
    let x_right_arm_frame_in_spindle_frame_3_5 = x_right_arm_frame_in_spindle_frame_1_5_of_place
        * sin_q_right_top;
    let l_halved = S::ratio(1, 2) * l;
    let minus_sin_theta = -sin_theta;
    let minus_sin_q_right_top = -sin_q_right_top;
    let minus_sin_q_left_ball = -sin_q_left_ball;
    let minus_sin_q_right_ball = -sin_q_right_ball;
    let minus_sin_psi = -sin_psi;
    let minus_cos_psi = -cos_psi;
    let minus_cos_theta = -cos_theta;
    let minus_cos_q_right_top = -cos_q_right_top;
    let minus_cos_q_left_ball = -cos_q_left_ball;
    let minus_cos_q_right_ball = -cos_q_right_ball;
    let minus_l_halved = -l_halved;
    // Entries that are not zero.
    let m_1_23 = S::int(1);
    let m_1_26 = S::int(1);
    let m_1_31 = S::int(1);
    let m_1_36 = minus_cos_psi;
    let m_1_37 = minus_sin_psi;
    let m_2_27 = S::int(1);
    let m_2_32 = S::int(1);
    let m_2_36 = sin_psi;
    let m_2_37 = minus_cos_psi;
    let m_3_28 = S::int(1);
    let m_3_33 = S::int(1);
    let m_3_38 = -S::int(1);
    let m_4_29 = S::int(1);
    let m_4_34 = S::int(1);
    let m_4_39 = minus_cos_psi;
    let m_4_40 = minus_sin_psi;
    let m_5_23 = -x_spindle_frame_3;
    let m_5_24 = S::int(1);
    let m_5_39 = sin_psi;
    let m_5_40 = minus_cos_psi;
    let m_6_1 = J;
    let m_6_25 = S::int(1);
    let m_6_30 = S::int(1);
    let m_6_35 = S::int(1);
    let m_7_2 = -S::ratio(1, 2) * x_left_arm_frame_1_3;
    let m_7_12 = S::int(1);
    let m_7_20 = S::int(1);
    let m_7_31 = minus_cos_theta;
    let m_7_33 = sin_theta;
    let m_8_1 = -S::ratio(1, 2) * x_left_arm_frame_2_3;
    let m_8_13 = S::int(1);
    let m_8_21 = S::int(1);
    let m_8_32 = -S::int(1);
    let m_9_14 = S::int(1);
    let m_9_22 = S::int(1);
    let m_9_31 = minus_sin_theta;
    let m_9_33 = minus_cos_theta;
    let m_10_1 = -S::ratio(1, 12) * x_left_arm_frame_1_4;
    let m_10_13 = l_halved;
    let m_10_15 = S::int(1);
    let m_10_21 = l_halved;
    let m_10_32 = S::ratio(1, 2) * x_spindle_frame_in_left_arm_frame_1;
    let m_10_34 = minus_cos_theta;
    let m_10_35 = sin_theta;
    let m_11_2 = S::ratio(1, 12) * x_left_arm_frame_2_4;
    let m_11_12 = minus_l_halved;
    let m_11_20 = minus_l_halved;
    let m_11_31 = -S::ratio(1, 2) * x_left_arm_frame_in_spindle_frame_3_2;
    let m_11_33 = S::ratio(1, 2) * x_left_arm_frame_in_spindle_frame_1_2;
    let m_12_16 = S::int(1);
    let m_12_32 = -S::ratio(1, 2) * x_spindle_frame_in_left_arm_frame_3;
    let m_12_34 = minus_sin_theta;
    let m_12_35 = minus_cos_theta;
    let m_13_2 = -S::ratio(1, 2) * x_right_arm_frame_1_3;
    let m_13_7 = S::int(1);
    let m_13_17 = S::int(1);
    let m_13_26 = minus_cos_q_right_top;
    let m_13_28 = sin_q_right_top;
    let m_14_1 = -S::ratio(1, 2) * x_right_arm_frame_2_3;
    let m_14_8 = S::int(1);
    let m_14_18 = S::int(1);
    let m_14_27 = -S::int(1);
    let m_15_9 = S::int(1);
    let m_15_19 = S::int(1);
    let m_15_26 = minus_sin_q_right_top;
    let m_15_28 = minus_cos_q_right_top;
    let m_16_1 = -S::ratio(1, 12) * x_right_arm_frame_1_4;
    let m_16_8 = l_halved;
    let m_16_10 = S::int(1);
    let m_16_18 = l_halved;
    let m_16_27 = S::ratio(1, 2) * x_spindle_frame_in_right_arm_frame_1;
    let m_16_29 = minus_cos_q_right_top;
    let m_16_30 = sin_q_right_top;
    let m_17_2 = S::ratio(1, 12) * x_right_arm_frame_2_4;
    let m_17_7 = minus_l_halved;
    let m_17_17 = minus_l_halved;
    let m_17_26 = -S::ratio(1, 2) * x_right_arm_frame_in_spindle_frame_3_2;
    let m_17_28 = S::ratio(1, 2) * x_right_arm_frame_in_spindle_frame_1_2;
    let m_18_11 = S::int(1);
    let m_18_27 = -S::ratio(1, 2) * x_spindle_frame_in_right_arm_frame_3;
    let m_18_29 = minus_sin_q_right_top;
    let m_18_30 = minus_cos_q_right_top;
    let m_19_2 = -S::ratio(1, 2) * x_left_link_frame_1_3;
    let m_19_12 = minus_cos_q_left_ball;
    let m_19_14 = sin_q_left_ball;
    let m_20_1 = -S::ratio(1, 2) * x_left_link_frame_2_3;
    let m_20_13 = -S::int(1);
    let m_21_2 = -x_left_link_frame_3_3;
    let m_21_3 = -x_left_arm_frame_in_left_link_frame_1_2;
    let m_21_12 = minus_sin_q_left_ball;
    let m_21_14 = minus_cos_q_left_ball;
    let m_22_1 = -S::ratio(1, 12) * x_left_link_frame_1_4;
    let m_22_13 = S::ratio(1, 2) * x_left_arm_frame_in_left_link_frame_1_3;
    let m_22_15 = minus_cos_q_left_ball;
    let m_22_16 = sin_q_left_ball;
    let m_23_2 = -S::ratio(1, 12) * x_left_link_frame_2_4;
    let m_23_3 = S::ratio(1, 2) * x_left_arm_frame_in_spindle_frame_3_3;
    let m_23_4 = -S::ratio(1, 2) * x_left_arm_frame_in_spindle_frame_1_3;
    let m_23_12 = -S::ratio(1, 2) * x_left_link_frame_in_left_arm_frame_3;
    let m_23_14 = S::ratio(1, 2) * x_left_link_frame_in_left_arm_frame_1;
    let m_24_13 = -S::ratio(1, 2) * x_left_arm_frame_in_left_link_frame_3;
    let m_24_15 = minus_sin_q_left_ball;
    let m_24_16 = minus_cos_q_left_ball;
    let m_25_2 = S::ratio(1, 2) * x_right_link_frame_1_3;
    let m_25_7 = minus_cos_q_right_ball;
    let m_25_9 = sin_q_right_ball;
    let m_26_1 = -S::ratio(1, 2) * x_right_link_frame_2_3;
    let m_26_8 = -S::int(1);
    let m_27_2 = -x_right_link_frame_3_3;
    let m_27_5 = -x_right_arm_frame_in_right_link_frame_1_2;
    let m_27_7 = minus_sin_q_right_ball;
    let m_27_9 = minus_cos_q_right_ball;
    let m_28_1 = -S::ratio(1, 12) * x_right_link_frame_1_4;
    let m_28_8 = S::ratio(1, 2) * x_right_arm_frame_in_right_link_frame_1_3;
    let m_28_10 = minus_cos_q_right_ball;
    let m_28_11 = sin_q_right_ball;
    let m_29_2 = -S::ratio(1, 12) * x_right_link_frame_2_4;
    let m_29_5 = S::ratio(1, 2) * x_right_arm_frame_in_spindle_frame_3_3;
    let m_29_6 = -S::ratio(1, 2) * x_right_arm_frame_in_spindle_frame_1_3;
    let m_29_7 = -S::ratio(1, 2) * x_right_link_frame_in_right_arm_frame_3;
    let m_29_9 = S::ratio(1, 2) * x_right_link_frame_in_right_arm_frame_1;
    let m_30_8 = -S::ratio(1, 2) * x_right_arm_frame_in_right_link_frame_3;
    let m_30_10 = minus_sin_q_right_ball;
    let m_30_11 = minus_cos_q_right_ball;
    let m_31_3 = S::int(1);
    let m_31_5 = S::int(1);
    let m_31_23 = -S::int(1);
    let m_32_4 = S::int(1);
    let m_32_6 = S::int(1);
    let m_33_24 = -S::int(1);
    let m_34_1 = Js;
    let m_34_25 = -S::int(1);
    let m_35_2 = -x_spindle_frame_in_N_1_4;
    let m_35_20 = -x_spindle_frame_in_N_1_5;
    let m_35_21 = sin_psi;
    let m_35_22 = -x_spindle_frame_in_N_1_6;
    let m_36_1 = -x_spindle_frame_in_N_2_3;
    let m_36_2 = -x_spindle_frame_in_N_2_4;
    let m_36_20 = -x_spindle_frame_in_N_2_5;
    let m_36_21 = minus_cos_psi;
    let m_36_22 = -x_spindle_frame_in_N_2_6;
    let m_37_20 = sin_theta;
    let m_37_22 = minus_cos_theta;
    let m_38_2 = -x_spindle_frame_in_N_1_8;
    let m_38_17 = -x_spindle_frame_in_N_1_9;
    let m_38_18 = sin_psi;
    let m_38_19 = -x_spindle_frame_in_N_1_10;
    let m_39_1 = -x_spindle_frame_in_N_2_7;
    let m_39_2 = -x_spindle_frame_in_N_2_8;
    let m_39_17 = -x_spindle_frame_in_N_2_9;
    let m_39_18 = minus_cos_psi;
    let m_39_19 = -x_spindle_frame_in_N_2_10;
    let m_40_17 = sin_q_right_top;
    let m_40_19 = minus_cos_q_right_top;
    let zero = S::int(0);
    [
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, m_1_23, zero, zero, m_1_26, zero, zero,
            zero, zero, m_1_31, zero, zero, zero, zero, m_1_36, m_1_37, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_2_27, zero,
            zero, zero, zero, m_2_32, zero, zero, zero, m_2_36, m_2_37, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_3_28,
            zero, zero, zero, zero, m_3_33, zero, zero, zero, zero, m_3_38, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            m_4_29, zero, zero, zero, zero, m_4_34, zero, zero, zero, zero, m_4_39, m_4_40,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, m_5_23, m_5_24, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_5_39, m_5_40,
        ],
        [
            m_6_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_6_25, zero, zero, zero,
            zero, m_6_30, zero, zero, zero, zero, m_6_35, zero, zero, zero, zero, zero,
        ],
        [
            zero, m_7_2, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_7_12, zero, zero,
            zero, zero, zero, zero, zero, m_7_20, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, m_7_31, zero, m_7_33, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_8_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_8_13, zero,
            zero, zero, zero, zero, zero, zero, m_8_21, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, m_8_32, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_9_14,
            zero, zero, zero, zero, zero, zero, zero, m_9_22, zero, zero, zero, zero, zero, zero,
            zero, zero, m_9_31, zero, m_9_33, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_10_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_10_13, zero,
            m_10_15, zero, zero, zero, zero, zero, m_10_21, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, m_10_32, zero, m_10_34, m_10_35, zero, zero, zero, zero, zero,
        ],
        [
            zero, m_11_2, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_11_12, zero, zero,
            zero, zero, zero, zero, zero, m_11_20, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, m_11_31, zero, m_11_33, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, m_12_16, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, m_12_32, zero, m_12_34, m_12_35, zero, zero, zero, zero, zero,
        ],
        [
            zero, m_13_2, zero, zero, zero, zero, m_13_7, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, m_13_17, zero, zero, zero, zero, zero, zero, zero, zero, m_13_26, zero,
            m_13_28, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_14_1, zero, zero, zero, zero, zero, zero, m_14_8, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, m_14_18, zero, zero, zero, zero, zero, zero, zero, zero, m_14_27,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, m_15_9, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, m_15_19, zero, zero, zero, zero, zero, zero, m_15_26, zero,
            m_15_28, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_16_1, zero, zero, zero, zero, zero, zero, m_16_8, zero, m_16_10, zero, zero, zero,
            zero, zero, zero, zero, m_16_18, zero, zero, zero, zero, zero, zero, zero, zero,
            m_16_27, zero, m_16_29, m_16_30, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero,
        ],
        [
            zero, m_17_2, zero, zero, zero, zero, m_17_7, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, m_17_17, zero, zero, zero, zero, zero, zero, zero, zero, m_17_26, zero,
            m_17_28, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_18_11, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_18_27, zero,
            m_18_29, m_18_30, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, m_19_2, x_left_arm_frame_in_left_link_frame_1,
            x_left_arm_frame_in_left_link_frame_1_2, zero, zero, zero, zero, zero, zero, zero,
            m_19_12, zero, m_19_14, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero,
        ],
        [
            m_20_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_20_13, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, m_21_2, m_21_3, x_left_arm_frame_in_left_link_frame_1, zero, zero, zero, zero,
            zero, zero, zero, m_21_12, zero, m_21_14, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero,
        ],
        [
            m_22_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_22_13, zero,
            m_22_15, m_22_16, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, m_23_2, m_23_3, m_23_4, zero, zero, zero, zero, zero, zero, zero, m_23_12, zero,
            m_23_14, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_24_13, zero,
            m_24_15, m_24_16, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, m_25_2, zero, zero, x_right_arm_frame_in_right_link_frame_1,
            x_right_arm_frame_in_right_link_frame_1_2, m_25_7, zero, m_25_9, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_26_1, zero, zero, zero, zero, zero, zero, m_26_8, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, m_27_2, zero, zero, m_27_5, x_right_arm_frame_in_right_link_frame_1, m_27_7, zero,
            m_27_9, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero,
        ],
        [
            m_28_1, zero, zero, zero, zero, zero, zero, m_28_8, zero, m_28_10, m_28_11, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, m_29_2, zero, zero, m_29_5, m_29_6, m_29_7, zero, m_29_9, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, m_30_8, zero, m_30_10, m_30_11, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, zero, m_31_3, zero, m_31_5, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, m_31_23, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, x_spindle_frame_in_sleeve_frame_3_2, zero, m_32_4, zero, m_32_6, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero,
        ],
        [
            zero, zero, x_sleeve_frame_3_2, x_left_arm_frame_in_spindle_frame_1_4,
            x_sleeve_frame_3_4, x_right_arm_frame_in_spindle_frame_1_4, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_33_24,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero,
        ],
        [
            m_34_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_34_25, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            x_spindle_frame_in_N_1_3, m_35_2, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, m_35_20, m_35_21, m_35_22, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero,
        ],
        [
            m_36_1, m_36_2, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, m_36_20, m_36_21, m_36_22, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, x_left_arm_frame_in_spindle_frame_3_5, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_37_20, zero, m_37_22,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero,
        ],
        [
            x_spindle_frame_in_N_1_7, m_38_2, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, m_38_17, m_38_18, m_38_19, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero,
        ],
        [
            m_39_1, m_39_2, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, m_39_17, m_39_18, m_39_19, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, x_right_arm_frame_in_spindle_frame_3_5, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, m_40_17, zero, m_40_19, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero,
        ],
    ]
}

/// Right-hand side of the linear system; unknowns (spin', opening', left_end_force1, left_end_force3, right_end_force1, right_end_force3, right_link_force_right_arm_frame1, right_link_force_right_arm_frame2, right_link_force_right_arm_frame3, right_link_torque_right_arm_frame1, right_link_torque_right_arm_frame3, left_link_force_left_arm_frame1, left_link_force_left_arm_frame2, left_link_force_left_arm_frame3, left_link_torque_left_arm_frame1, left_link_torque_left_arm_frame3, right_force_right_arm_frame1, right_force_right_arm_frame2, right_force_right_arm_frame3, left_force_left_arm_frame1, left_force_left_arm_frame2, left_force_left_arm_frame3, sleeve_force_spindle_frame1, sleeve_torque_spindle_frame2, sleeve_torque_spindle_frame3, right_arm_force_spindle_frame1, right_arm_force_spindle_frame2, right_arm_force_spindle_frame3, right_arm_torque_spindle_frame1, right_arm_torque_spindle_frame3, left_arm_force_spindle_frame1, left_arm_force_spindle_frame2, left_arm_force_spindle_frame3, left_arm_torque_spindle_frame1, left_arm_torque_spindle_frame3, spindle_force_n1, spindle_force_n2, spindle_force_n3, spindle_torque_n1, spindle_torque_n2).
///
/// 290 operations, 7 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 2]) -> [S; 40] {
    let Parameters { l, m, mb, ms, g, .. } = *p;
    let [psi, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    let [spin, opening] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Step by step, each after the terms that it needs.
    let x_N_in_spindle_frame_3 = ms * g;
    let w_spindle_frame_in_left_arm_frame_1 = spin * sin_theta;
    let w_spindle_frame_in_left_arm_frame_3 = spin * cos_theta;
    let w_left_arm_frame_13 = w_spindle_frame_in_left_arm_frame_1
        * w_spindle_frame_in_left_arm_frame_3;
    let a_spindle_frame_in_left_arm_frame_1 = g * sin_theta;
    let l_w_left_arm_frame_13 = l * w_left_arm_frame_13;
    let a_left_arm_centre_1 = a_spindle_frame_in_left_arm_frame_1
        .mul_add(S::int(2), -l_w_left_arm_frame_13);
    let x_left_arm_frame_1 = m * a_left_arm_centre_1;
    let w_left_arm_frame_23 = opening * w_spindle_frame_in_left_arm_frame_3;
    let a_left_arm_centre_2 = l * w_left_arm_frame_23;
    let x_left_arm_frame_2 = m * a_left_arm_centre_2;
    let w_left_arm_frame_11 = w_spindle_frame_in_left_arm_frame_1
        * w_spindle_frame_in_left_arm_frame_1;
    let w_left_arm_frame_22 = opening * opening;
    let turn_left_arm_frame_33 = w_left_arm_frame_11 + w_left_arm_frame_22;
    let a_spindle_frame_in_left_arm_frame_3 = g * cos_theta;
    let l_turn_left_arm_frame_33 = l * turn_left_arm_frame_33;
    let a_left_arm_centre_3 = a_spindle_frame_in_left_arm_frame_3
        .mul_add(S::int(2), l_turn_left_arm_frame_33);
    let x_left_arm_frame_3 = m * a_left_arm_centre_3;
    let l_sq_m = l * l * m;
    let H_left_arm_2 = opening * l_sq_m;
    let x_left_arm_frame_1_2 = w_left_arm_frame_23
        .mul_add(l_sq_m, w_spindle_frame_in_left_arm_frame_3 * H_left_arm_2);
    let H_left_arm_1 = w_spindle_frame_in_left_arm_frame_1 * l_sq_m;
    let x_left_arm_frame_2_2 = w_spindle_frame_in_left_arm_frame_3 * H_left_arm_1;
    let x_left_arm_frame_3_2 = (-opening)
        .mul_add(H_left_arm_1, w_spindle_frame_in_left_arm_frame_1 * H_left_arm_2);
    let w_spindle_frame_in_right_arm_frame_1 = spin * sin_q_right_top;
    let w_spindle_frame_in_right_arm_frame_3 = spin * cos_q_right_top;
    let w_right_arm_frame_13 = w_spindle_frame_in_right_arm_frame_1
        * w_spindle_frame_in_right_arm_frame_3;
    let a_spindle_frame_in_right_arm_frame_1 = g * sin_q_right_top;
    let sin_q_right_ball_inv = S::int(1) / sin_q_right_ball;
    let theta_plus_q_left_ball = theta + q_left_ball;
    let (sin_theta_plus_q_left_ball, cos_theta_plus_q_left_ball) = theta_plus_q_left_ball
        .sin_cos();
    let alpha_right_arm_frame_2_of_place = S::int(1) / cos_theta_plus_q_left_ball;
    let alpha_right_arm_frame_2_of_opening = opening * alpha_right_arm_frame_2_of_place;
    let alpha_right_arm_frame_2_of_opening_2 = alpha_right_arm_frame_2_of_opening * sin_q_left_ball;
    let alpha_right_arm_frame_2_of_opening_3 = sin_q_right_ball_inv
        * alpha_right_arm_frame_2_of_opening_2;
    let alpha_right_arm_frame_2_of_q_right_ball = S::int(1) + cos_q_right_ball;
    let alpha_right_arm_frame_2_of_place_2 = (-sin_q_right_top)
        .mul_add(
            sin_q_right_ball,
            alpha_right_arm_frame_2_of_q_right_ball * cos_q_right_top,
        );
    let alpha_right_arm_frame_2_of_place_3 = q_right_top + q_right_ball;
    let (sin_angle, cos_angle) = alpha_right_arm_frame_2_of_place_3.sin_cos();
    let alpha_right_arm_frame_2_of_place_4 = alpha_right_arm_frame_2_of_place_2 - cos_angle;
    let alpha_right_arm_frame_2_of_place_5 = cos_theta + cos_theta_plus_q_left_ball;
    let alpha_right_arm_frame_2_of_opening_4 = alpha_right_arm_frame_2_of_opening
        * alpha_right_arm_frame_2_of_place_5;
    let alpha_right_arm_frame_2_of_opening_5 = alpha_right_arm_frame_2_of_opening_3
        * alpha_right_arm_frame_2_of_place_2;
    let alpha_right_arm_frame_2_of_opening_6 = alpha_right_arm_frame_2_of_opening_5
        * cos_q_right_ball;
    let alpha_right_arm_frame_2_of_opening_7 = opening - alpha_right_arm_frame_2_of_opening_4;
    let alpha_right_arm_frame_2_of_opening_8 = alpha_right_arm_frame_2_of_opening_7
        * sin_theta_plus_q_left_ball;
    let alpha_right_arm_frame_2_of_opening_9 = alpha_right_arm_frame_2_of_place
        * alpha_right_arm_frame_2_of_opening_8;
    let alpha_right_arm_frame_2_of_opening_10 = sin_q_right_ball_inv
        * (-(alpha_right_arm_frame_2_of_opening * alpha_right_arm_frame_2_of_opening_4))
            .mul_add(
                cos_q_left_ball,
                alpha_right_arm_frame_2_of_opening_3 * alpha_right_arm_frame_2_of_opening_6,
            ) + alpha_right_arm_frame_2_of_opening_3 * alpha_right_arm_frame_2_of_opening_9;
    let alpha_right_arm_frame_2 = alpha_right_arm_frame_2_of_opening_10
        .mul_add(
            cos_angle,
            alpha_right_arm_frame_2_of_opening_3 * alpha_right_arm_frame_2_of_opening_3
                * alpha_right_arm_frame_2_of_place_4 * sin_angle,
        );
    let turn_right_arm_frame_13 = w_right_arm_frame_13 - alpha_right_arm_frame_2;
    let a_right_arm_centre_1_of_place = l * turn_right_arm_frame_13;
    let a_right_arm_centre_1 = a_spindle_frame_in_right_arm_frame_1
        .mul_add(S::int(2), -a_right_arm_centre_1_of_place);
    let x_right_arm_frame_1 = m * a_right_arm_centre_1;
    let w_right_arm_frame_2 = alpha_right_arm_frame_2_of_opening_3 * cos_angle;
    let w_right_arm_frame_23 = w_spindle_frame_in_right_arm_frame_3 * w_right_arm_frame_2;
    let alpha_right_arm_frame_1 = w_right_arm_frame_23;
    let turn_right_arm_frame_23 = w_right_arm_frame_23 + alpha_right_arm_frame_1;
    let a_right_arm_centre_2 = l * turn_right_arm_frame_23;
    let x_right_arm_frame_2 = m * a_right_arm_centre_2;
    let w_right_arm_frame_11 = w_spindle_frame_in_right_arm_frame_1
        * w_spindle_frame_in_right_arm_frame_1;
    let w_right_arm_frame_22 = w_right_arm_frame_2 * w_right_arm_frame_2;
    let turn_right_arm_frame_33 = w_right_arm_frame_11 + w_right_arm_frame_22;
    let a_spindle_frame_in_right_arm_frame_3 = g * cos_q_right_top;
    let a_right_arm_centre_3_of_place = l * turn_right_arm_frame_33;
    let a_right_arm_centre_3 = a_spindle_frame_in_right_arm_frame_3
        .mul_add(S::int(2), a_right_arm_centre_3_of_place);
    let x_right_arm_frame_3 = m * a_right_arm_centre_3;
    let H_right_arm_2 = w_right_arm_frame_2 * l_sq_m;
    let x_right_arm_frame_1_2 = alpha_right_arm_frame_1
        .mul_add(l_sq_m, w_spindle_frame_in_right_arm_frame_3 * H_right_arm_2);
    let H_right_arm_1 = w_spindle_frame_in_right_arm_frame_1 * l_sq_m;
    let x_right_arm_frame_2_2 = (-alpha_right_arm_frame_2)
        .mul_add(l_sq_m, w_spindle_frame_in_right_arm_frame_3 * H_right_arm_1);
    let x_right_arm_frame_3_2 = (-w_right_arm_frame_2)
        .mul_add(H_right_arm_1, w_spindle_frame_in_right_arm_frame_1 * H_right_arm_2);
    let w_left_arm_frame_in_left_link_frame_1 = w_spindle_frame_in_left_arm_frame_3
        .mul_add(sin_q_left_ball, w_spindle_frame_in_left_arm_frame_1 * cos_q_left_ball);
    let w_left_arm_frame_in_left_link_frame_3 = (-w_spindle_frame_in_left_arm_frame_1)
        .mul_add(sin_q_left_ball, w_spindle_frame_in_left_arm_frame_3 * cos_q_left_ball);
    let w_left_link_frame_13 = w_left_arm_frame_in_left_link_frame_1
        * w_left_arm_frame_in_left_link_frame_3;
    let a_left_link_centre_3 = a_spindle_frame_in_left_arm_frame_3 + l_turn_left_arm_frame_33;
    let alpha_left_link_frame_2_of_opening = opening
        .mul_add(sin_theta, alpha_right_arm_frame_2_of_opening_8);
    let alpha_left_link_frame_2 = alpha_right_arm_frame_2_of_opening
        * alpha_right_arm_frame_2_of_place_5
            .mul_add(
                alpha_right_arm_frame_2_of_opening_9, -alpha_left_link_frame_2_of_opening,
            );
    let turn_left_link_frame_13 = w_left_link_frame_13 + alpha_left_link_frame_2;
    let a_left_link_centre_1 = a_spindle_frame_in_left_arm_frame_1 - l_w_left_arm_frame_13;
    let a_left_arm_frame_in_left_link_frame_1 = a_left_link_centre_1
        .mul_add(cos_q_left_ball, a_left_link_centre_3 * sin_q_left_ball);
    let a_left_link_centre_1_2 = (-a_left_arm_frame_in_left_link_frame_1)
        .mul_add(S::int(2), l * turn_left_link_frame_13);
    let x_left_link_frame_1 = m * a_left_link_centre_1_2;
    let w_left_link_frame_2 = alpha_right_arm_frame_2_of_opening_7;
    let w_left_arm_frame_12 = opening * w_spindle_frame_in_left_arm_frame_1;
    let w_left_link_frame_23 = w_left_arm_frame_in_left_link_frame_3 * w_left_link_frame_2;
    let alpha_left_arm_frame_in_left_link_frame_1 = (-w_left_arm_frame_23)
        .mul_add(cos_q_left_ball, w_left_arm_frame_12 * sin_q_left_ball);
    let alpha_left_link_frame_1 = w_left_arm_frame_in_left_link_frame_3
        .mul_add(
            alpha_right_arm_frame_2_of_opening_4, alpha_left_arm_frame_in_left_link_frame_1,
        );
    let turn_left_link_frame_23 = w_left_link_frame_23 - alpha_left_link_frame_1;
    let a_left_link_centre_2 = l
        .mul_add(turn_left_link_frame_23, S::int(4) * a_left_arm_centre_2);
    let x_left_link_frame_2 = m * a_left_link_centre_2;
    let w_left_link_frame_11 = w_left_arm_frame_in_left_link_frame_1
        * w_left_arm_frame_in_left_link_frame_1;
    let w_left_link_frame_22 = w_left_link_frame_2 * w_left_link_frame_2;
    let turn_left_link_frame_33 = w_left_link_frame_11 + w_left_link_frame_22;
    let a_left_arm_frame_in_left_link_frame_3 = (-a_left_link_centre_1)
        .mul_add(sin_q_left_ball, a_left_link_centre_3 * cos_q_left_ball);
    let a_left_link_centre_3_2 = a_left_arm_frame_in_left_link_frame_3
        .mul_add(S::int(2), l * turn_left_link_frame_33);
    let x_left_link_frame_3 = m * a_left_link_centre_3_2;
    let H_left_link_2 = w_left_link_frame_2 * l_sq_m;
    let x_left_link_frame_1_2 = (-alpha_left_link_frame_1)
        .mul_add(l_sq_m, w_left_arm_frame_in_left_link_frame_3 * H_left_link_2);
    let H_left_link_1 = w_left_arm_frame_in_left_link_frame_1 * l_sq_m;
    let x_left_link_frame_2_2 = alpha_left_link_frame_2
        .mul_add(l_sq_m, w_left_arm_frame_in_left_link_frame_3 * H_left_link_1);
    let x_left_link_frame_3_2 = (-w_left_link_frame_2)
        .mul_add(H_left_link_1, w_left_arm_frame_in_left_link_frame_1 * H_left_link_2);
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
    let w_right_link_frame_13 = w_right_arm_frame_in_right_link_frame_1
        * w_right_arm_frame_in_right_link_frame_3;
    let a_right_link_centre_3 = a_spindle_frame_in_right_arm_frame_3
        + a_right_arm_centre_3_of_place;
    let alpha_right_link_frame_2 = alpha_right_arm_frame_2_of_opening_3
        * (sin_q_right_top
            * (-w_right_arm_frame_2)
                .mul_add(
                    alpha_right_arm_frame_2_of_q_right_ball, alpha_right_arm_frame_2_of_opening_6,
                )
            + alpha_right_arm_frame_2_of_opening_2 * alpha_right_arm_frame_2_of_place_4
                * cos_q_right_top) - alpha_right_arm_frame_2
        + alpha_right_arm_frame_2_of_place_2 * alpha_right_arm_frame_2_of_opening_10;
    let turn_right_link_frame_13 = w_right_link_frame_13 + alpha_right_link_frame_2;
    let a_right_link_centre_1 = a_spindle_frame_in_right_arm_frame_1
        - a_right_arm_centre_1_of_place;
    let a_right_arm_frame_in_right_link_frame_1 = a_right_link_centre_1
        .mul_add(cos_q_right_ball, a_right_link_centre_3 * sin_q_right_ball);
    let a_right_link_centre_1_2 = (-a_right_arm_frame_in_right_link_frame_1)
        .mul_add(S::int(2), l * turn_right_link_frame_13);
    let x_right_link_frame_1 = m * a_right_link_centre_1_2;
    let w_right_link_frame_2 = alpha_right_arm_frame_2_of_opening_5 - w_right_arm_frame_2;
    let w_right_link_frame_23 = w_right_arm_frame_in_right_link_frame_3 * w_right_link_frame_2;
    let alpha_right_arm_frame_3 = w_spindle_frame_in_right_arm_frame_1 * w_right_arm_frame_2;
    let alpha_right_arm_frame_in_right_link_frame_1 = (-alpha_right_arm_frame_1)
        .mul_add(cos_q_right_ball, alpha_right_arm_frame_3 * sin_q_right_ball);
    let alpha_right_link_frame_1 = w_right_arm_frame_in_right_link_frame_3
        .mul_add(
            alpha_right_arm_frame_2_of_opening_5, alpha_right_arm_frame_in_right_link_frame_1,
        );
    let turn_right_link_frame_23 = w_right_link_frame_23 + alpha_right_link_frame_1;
    let a_right_link_centre_2 = (-l)
        .mul_add(turn_right_link_frame_23, S::int(2) * a_right_arm_centre_2);
    let x_right_link_frame_2 = m * a_right_link_centre_2;
    let w_right_link_frame_11 = w_right_arm_frame_in_right_link_frame_1
        * w_right_arm_frame_in_right_link_frame_1;
    let w_right_link_frame_22 = w_right_link_frame_2 * w_right_link_frame_2;
    let turn_right_link_frame_33 = w_right_link_frame_11 + w_right_link_frame_22;
    let a_right_arm_frame_in_right_link_frame_3 = (-a_right_link_centre_1)
        .mul_add(sin_q_right_ball, a_right_link_centre_3 * cos_q_right_ball);
    let a_right_link_centre_3_2 = a_right_arm_frame_in_right_link_frame_3
        .mul_add(S::int(2), l * turn_right_link_frame_33);
    let x_right_link_frame_3 = m * a_right_link_centre_3_2;
    let H_right_link_2 = w_right_link_frame_2 * l_sq_m;
    let x_right_link_frame_1_2 = alpha_right_link_frame_1
        .mul_add(l_sq_m, w_right_arm_frame_in_right_link_frame_3 * H_right_link_2);
    let H_right_link_1 = w_right_arm_frame_in_right_link_frame_1 * l_sq_m;
    let x_right_link_frame_2_2 = alpha_right_link_frame_2
        .mul_add(l_sq_m, w_right_arm_frame_in_right_link_frame_3 * H_right_link_1);
    let x_right_link_frame_3_2 = (-w_right_link_frame_2)
        .mul_add(
            H_right_link_1,
            w_right_arm_frame_in_right_link_frame_1 * H_right_link_2,
        );
    let a_sleeve_centre_3 = g
        + l
            * ((-alpha_left_link_frame_2)
                .mul_add(sin_theta_plus_q_left_ball, w_left_arm_frame_22 * cos_theta)
                + alpha_right_arm_frame_2_of_opening_7
                    * alpha_right_arm_frame_2_of_opening_7 * cos_theta_plus_q_left_ball);
    let x_spindle_frame_in_sleeve_frame_3 = ms * a_sleeve_centre_3;
    let mb_sin_theta = mb * sin_theta;
    let mb_cos_theta = mb * cos_theta;
    let x_left_arm_frame_in_spindle_frame_1 = (-a_left_link_centre_1)
        .mul_add(mb_cos_theta, a_left_link_centre_3 * mb_sin_theta);
    let x_left_arm_frame_in_spindle_frame_2 = mb * a_left_arm_centre_2;
    let x_spindle_frame_in_N_1_of_place = S::int(2) * x_left_arm_frame_in_spindle_frame_2;
    let x_spindle_frame_in_N_1 = x_spindle_frame_in_N_1_of_place
        .mul_add(sin_psi, x_left_arm_frame_in_spindle_frame_1 * cos_psi);
    let x_spindle_frame_in_N_2 = (-x_spindle_frame_in_N_1_of_place)
        .mul_add(cos_psi, x_left_arm_frame_in_spindle_frame_1 * sin_psi);
    let x_left_arm_frame_in_spindle_frame_3 = a_left_link_centre_3
        .mul_add(mb_cos_theta, a_left_link_centre_1 * mb_sin_theta);
    let mb_sin_q_right_top = mb * sin_q_right_top;
    let mb_cos_q_right_top = mb * cos_q_right_top;
    let x_right_arm_frame_in_spindle_frame_1 = (-a_right_link_centre_1)
        .mul_add(mb_cos_q_right_top, a_right_link_centre_3 * mb_sin_q_right_top);
    let x_right_arm_frame_in_spindle_frame_2 = mb * a_right_arm_centre_2;
    let x_spindle_frame_in_N_1_2 = x_right_arm_frame_in_spindle_frame_2
        .mul_add(sin_psi, x_right_arm_frame_in_spindle_frame_1 * cos_psi);
    let x_spindle_frame_in_N_2_2 = (-x_right_arm_frame_in_spindle_frame_2)
        .mul_add(cos_psi, x_right_arm_frame_in_spindle_frame_1 * sin_psi);
    let x_right_arm_frame_in_spindle_frame_3 = a_right_link_centre_3
        .mul_add(mb_cos_q_right_top, a_right_link_centre_1 * mb_sin_q_right_top);
    // Values.
    let f_3 = -x_N_in_spindle_frame_3;
    let f_7 = S::ratio(1, 2) * x_left_arm_frame_1;
    let f_9 = -S::ratio(1, 2) * x_left_arm_frame_3;
    let f_10 = S::ratio(1, 12) * x_left_arm_frame_1_2;
    let f_11 = S::ratio(1, 12) * x_left_arm_frame_2_2;
    let f_12 = S::ratio(1, 12) * x_left_arm_frame_3_2;
    let f_13 = S::ratio(1, 2) * x_right_arm_frame_1;
    let f_14 = S::ratio(1, 2) * x_right_arm_frame_2;
    let f_15 = -S::ratio(1, 2) * x_right_arm_frame_3;
    let f_16 = S::ratio(1, 12) * x_right_arm_frame_1_2;
    let f_17 = S::ratio(1, 12) * x_right_arm_frame_2_2;
    let f_18 = S::ratio(1, 12) * x_right_arm_frame_3_2;
    let f_19 = -S::ratio(1, 2) * x_left_link_frame_1;
    let f_20 = S::ratio(1, 2) * x_left_link_frame_2;
    let f_21 = -S::ratio(1, 2) * x_left_link_frame_3;
    let f_22 = S::ratio(1, 12) * x_left_link_frame_1_2;
    let f_23 = S::ratio(1, 12) * x_left_link_frame_2_2;
    let f_24 = S::ratio(1, 12) * x_left_link_frame_3_2;
    let f_25 = -S::ratio(1, 2) * x_right_link_frame_1;
    let f_26 = S::ratio(1, 2) * x_right_link_frame_2;
    let f_27 = -S::ratio(1, 2) * x_right_link_frame_3;
    let f_28 = -S::ratio(1, 12) * x_right_link_frame_1_2;
    let f_29 = S::ratio(1, 12) * x_right_link_frame_2_2;
    let f_30 = -S::ratio(1, 12) * x_right_link_frame_3_2;
    let f_32 = -x_spindle_frame_in_sleeve_frame_3;
    let f_35 = -x_spindle_frame_in_N_1;
    let f_36 = -x_spindle_frame_in_N_2;
    let f_37 = -x_left_arm_frame_in_spindle_frame_3;
    let f_38 = -x_spindle_frame_in_N_1_2;
    let f_39 = -x_spindle_frame_in_N_2_2;
    let f_40 = -x_right_arm_frame_in_spindle_frame_3;
    let zero = S::int(0);
    [
        zero, zero, f_3, zero, zero, zero, f_7, x_left_arm_frame_2, f_9, f_10, f_11, f_12, f_13,
        f_14, f_15, f_16, f_17, f_18, f_19, f_20, f_21, f_22, f_23, f_24, f_25, f_26, f_27, f_28,
        f_29, f_30, zero, f_32, zero, zero, f_35, f_36, f_37, f_38, f_39, f_40,
    ]
}

/// The accelerations (spin', opening'), solved for when this code was generated.
///
/// 492 operations, 7 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 2]) -> [S; 2] {
    let Parameters { l, m, mb, ms, J, Js, g } = *p;
    let [psi, theta, q_right_top, q_left_ball, q_right_ball] = *q;
    let [spin, opening] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_spindle_frame_in_left_arm_frame_1 = spin * sin_theta;
    let w_spindle_frame_in_left_arm_frame_3 = spin * cos_theta;
    let w_left_arm_frame_13 = w_spindle_frame_in_left_arm_frame_1
        * w_spindle_frame_in_left_arm_frame_3;
    let a_spindle_frame_in_left_arm_frame_1 = g * sin_theta;
    let l_w_left_arm_frame_13 = l * w_left_arm_frame_13;
    let a_left_arm_centre_1 = a_spindle_frame_in_left_arm_frame_1
        .mul_add(S::int(2), -l_w_left_arm_frame_13);
    let x_left_arm_frame_1 = m * a_left_arm_centre_1;
    let w_left_arm_frame_23 = opening * w_spindle_frame_in_left_arm_frame_3;
    let a_left_arm_centre_2 = l * w_left_arm_frame_23;
    let x_left_arm_frame_2 = m * a_left_arm_centre_2;
    let w_left_arm_frame_11 = w_spindle_frame_in_left_arm_frame_1
        * w_spindle_frame_in_left_arm_frame_1;
    let w_left_arm_frame_22 = opening * opening;
    let turn_left_arm_frame_33 = w_left_arm_frame_11 + w_left_arm_frame_22;
    let a_spindle_frame_in_left_arm_frame_3 = g * cos_theta;
    let x_left_arm_frame_1_3 = l * m;
    let x_left_arm_frame_2_4 = l * x_left_arm_frame_1_3;
    let H_left_arm_2 = opening * x_left_arm_frame_2_4;
    let x_left_arm_frame_1_2 = w_left_arm_frame_23
        .mul_add(
            x_left_arm_frame_2_4,
            w_spindle_frame_in_left_arm_frame_3 * H_left_arm_2,
        );
    let H_left_arm_1 = w_spindle_frame_in_left_arm_frame_1 * x_left_arm_frame_2_4;
    let x_left_arm_frame_2_2 = w_spindle_frame_in_left_arm_frame_3 * H_left_arm_1;
    let x_left_arm_frame_3_2 = (-opening)
        .mul_add(H_left_arm_1, w_spindle_frame_in_left_arm_frame_1 * H_left_arm_2);
    let w_spindle_frame_in_right_arm_frame_1 = spin * sin_q_right_top;
    let w_spindle_frame_in_right_arm_frame_3 = spin * cos_q_right_top;
    let w_right_arm_frame_13 = w_spindle_frame_in_right_arm_frame_1
        * w_spindle_frame_in_right_arm_frame_3;
    let a_spindle_frame_in_right_arm_frame_1 = g * sin_q_right_top;
    let theta_plus_q_left_ball = theta + q_left_ball;
    let (sin_theta_plus_q_left_ball, cos_theta_plus_q_left_ball) = theta_plus_q_left_ball
        .sin_cos();
    let alpha_right_arm_frame_2_of_place = S::int(1) / cos_theta_plus_q_left_ball;
    let alpha_right_arm_frame_2_of_opening = opening * alpha_right_arm_frame_2_of_place;
    let sin_q_right_ball_inv = S::int(1) / sin_q_right_ball;
    let alpha_right_arm_frame_2_of_place_2 = sin_q_right_ball_inv * sin_q_left_ball;
    let alpha_right_arm_frame_2_of_opening_2 = alpha_right_arm_frame_2_of_opening
        * alpha_right_arm_frame_2_of_place_2;
    let alpha_right_arm_frame_2_of_q_right_ball = S::int(1) + cos_q_right_ball;
    let alpha_right_arm_frame_2_of_place_3 = sin_q_right_top * sin_q_right_ball;
    let alpha_right_arm_frame_2_of_place_4 = alpha_right_arm_frame_2_of_q_right_ball
        .mul_add(cos_q_right_top, -alpha_right_arm_frame_2_of_place_3);
    let alpha_right_arm_frame_2_of_place_5 = q_right_top + q_right_ball;
    let (sin_angle, cos_angle) = alpha_right_arm_frame_2_of_place_5.sin_cos();
    let alpha_right_arm_frame_2_of_place_6 = alpha_right_arm_frame_2_of_place_4 - cos_angle;
    let alpha_right_arm_frame_2_of_place_7 = cos_theta + cos_theta_plus_q_left_ball;
    let alpha_right_arm_frame_2_of_opening_3 = alpha_right_arm_frame_2_of_opening
        * alpha_right_arm_frame_2_of_place_7;
    let alpha_right_arm_frame_2_of_opening_4 = alpha_right_arm_frame_2_of_opening_2
        * alpha_right_arm_frame_2_of_place_4;
    let alpha_right_arm_frame_2_of_opening_5 = opening - alpha_right_arm_frame_2_of_opening_3;
    let alpha_right_arm_frame_2_of_opening_6 = alpha_right_arm_frame_2_of_opening_5
        * sin_theta_plus_q_left_ball;
    let alpha_right_arm_frame_2_of_opening_7 = sin_q_right_ball_inv
        * (-(alpha_right_arm_frame_2_of_opening * alpha_right_arm_frame_2_of_opening_3))
            .mul_add(
                cos_q_left_ball,
                alpha_right_arm_frame_2_of_opening_2
                    * alpha_right_arm_frame_2_of_opening_4 * cos_q_right_ball,
            )
        + alpha_right_arm_frame_2_of_place * alpha_right_arm_frame_2_of_opening_2
            * alpha_right_arm_frame_2_of_opening_6;
    let alpha_right_arm_frame_2 = alpha_right_arm_frame_2_of_opening_7
        .mul_add(
            cos_angle,
            alpha_right_arm_frame_2_of_opening_2 * alpha_right_arm_frame_2_of_opening_2
                * alpha_right_arm_frame_2_of_place_6 * sin_angle,
        );
    let turn_right_arm_frame_13 = w_right_arm_frame_13 - alpha_right_arm_frame_2;
    let a_right_arm_centre_1_of_place = l * turn_right_arm_frame_13;
    let a_right_arm_centre_1 = a_spindle_frame_in_right_arm_frame_1
        .mul_add(S::int(2), -a_right_arm_centre_1_of_place);
    let x_right_arm_frame_1 = m * a_right_arm_centre_1;
    let w_right_arm_frame_2 = alpha_right_arm_frame_2_of_opening_2 * cos_angle;
    let w_right_arm_frame_23 = w_spindle_frame_in_right_arm_frame_3 * w_right_arm_frame_2;
    let alpha_right_arm_frame_1 = w_right_arm_frame_23;
    let turn_right_arm_frame_23 = w_right_arm_frame_23 + alpha_right_arm_frame_1;
    let a_right_arm_centre_2 = l * turn_right_arm_frame_23;
    let x_right_arm_frame_2 = m * a_right_arm_centre_2;
    let w_right_arm_frame_11 = w_spindle_frame_in_right_arm_frame_1
        * w_spindle_frame_in_right_arm_frame_1;
    let w_right_arm_frame_22 = w_right_arm_frame_2 * w_right_arm_frame_2;
    let turn_right_arm_frame_33 = w_right_arm_frame_11 + w_right_arm_frame_22;
    let a_spindle_frame_in_right_arm_frame_3 = g * cos_q_right_top;
    let H_right_arm_2 = w_right_arm_frame_2 * x_left_arm_frame_2_4;
    let x_right_arm_frame_1_2 = alpha_right_arm_frame_1
        .mul_add(
            x_left_arm_frame_2_4,
            w_spindle_frame_in_right_arm_frame_3 * H_right_arm_2,
        );
    let H_right_arm_1 = w_spindle_frame_in_right_arm_frame_1 * x_left_arm_frame_2_4;
    let x_right_arm_frame_2_2 = (-alpha_right_arm_frame_2)
        .mul_add(
            x_left_arm_frame_2_4,
            w_spindle_frame_in_right_arm_frame_3 * H_right_arm_1,
        );
    let x_right_arm_frame_3_2 = (-w_right_arm_frame_2)
        .mul_add(H_right_arm_1, w_spindle_frame_in_right_arm_frame_1 * H_right_arm_2);
    let w_left_arm_frame_in_left_link_frame_1 = w_spindle_frame_in_left_arm_frame_3
        .mul_add(sin_q_left_ball, w_spindle_frame_in_left_arm_frame_1 * cos_q_left_ball);
    let w_left_arm_frame_in_left_link_frame_3 = (-w_spindle_frame_in_left_arm_frame_1)
        .mul_add(sin_q_left_ball, w_spindle_frame_in_left_arm_frame_3 * cos_q_left_ball);
    let w_left_link_frame_13 = w_left_arm_frame_in_left_link_frame_1
        * w_left_arm_frame_in_left_link_frame_3;
    let a_left_link_centre_3 = l
        .mul_add(turn_left_arm_frame_33, a_spindle_frame_in_left_arm_frame_3);
    let alpha_left_link_frame_2_of_place = alpha_right_arm_frame_2_of_place
        * alpha_right_arm_frame_2_of_place_7;
    let alpha_left_link_frame_2_of_opening = opening
        .mul_add(sin_theta, alpha_right_arm_frame_2_of_opening_6);
    let alpha_left_link_frame_2 = alpha_right_arm_frame_2_of_opening
        * alpha_right_arm_frame_2_of_opening_6
            .mul_add(
                alpha_left_link_frame_2_of_place, -alpha_left_link_frame_2_of_opening,
            );
    let turn_left_link_frame_13 = w_left_link_frame_13 + alpha_left_link_frame_2;
    let a_left_link_centre_1 = a_spindle_frame_in_left_arm_frame_1 - l_w_left_arm_frame_13;
    let a_left_arm_frame_in_left_link_frame_1 = a_left_link_centre_1
        .mul_add(cos_q_left_ball, a_left_link_centre_3 * sin_q_left_ball);
    let a_left_link_centre_1_2 = (-a_left_arm_frame_in_left_link_frame_1)
        .mul_add(S::int(2), l * turn_left_link_frame_13);
    let x_left_link_frame_1 = m * a_left_link_centre_1_2;
    let w_left_link_frame_2 = alpha_right_arm_frame_2_of_opening_5;
    let w_left_arm_frame_12 = opening * w_spindle_frame_in_left_arm_frame_1;
    let w_left_link_frame_23 = w_left_arm_frame_in_left_link_frame_3 * w_left_link_frame_2;
    let alpha_left_arm_frame_in_left_link_frame_1 = (-w_left_arm_frame_23)
        .mul_add(cos_q_left_ball, w_left_arm_frame_12 * sin_q_left_ball);
    let alpha_left_link_frame_1 = w_left_arm_frame_in_left_link_frame_3
        .mul_add(
            alpha_right_arm_frame_2_of_opening_3, alpha_left_arm_frame_in_left_link_frame_1,
        );
    let turn_left_link_frame_23 = w_left_link_frame_23 - alpha_left_link_frame_1;
    let a_left_link_centre_2 = l
        .mul_add(turn_left_link_frame_23, S::int(4) * a_left_arm_centre_2);
    let x_left_link_frame_2 = m * a_left_link_centre_2;
    let w_left_link_frame_11 = w_left_arm_frame_in_left_link_frame_1
        * w_left_arm_frame_in_left_link_frame_1;
    let w_left_link_frame_22 = w_left_link_frame_2 * w_left_link_frame_2;
    let turn_left_link_frame_33 = w_left_link_frame_11 + w_left_link_frame_22;
    let a_left_arm_frame_in_left_link_frame_3 = (-a_left_link_centre_1)
        .mul_add(sin_q_left_ball, a_left_link_centre_3 * cos_q_left_ball);
    let a_left_link_centre_3_2 = a_left_arm_frame_in_left_link_frame_3
        .mul_add(S::int(2), l * turn_left_link_frame_33);
    let x_left_link_frame_3 = m * a_left_link_centre_3_2;
    let H_left_link_2 = w_left_link_frame_2 * x_left_arm_frame_2_4;
    let x_left_link_frame_1_2 = (-alpha_left_link_frame_1)
        .mul_add(
            x_left_arm_frame_2_4,
            w_left_arm_frame_in_left_link_frame_3 * H_left_link_2,
        );
    let H_left_link_1 = w_left_arm_frame_in_left_link_frame_1 * x_left_arm_frame_2_4;
    let x_left_link_frame_2_2 = alpha_left_link_frame_2
        .mul_add(
            x_left_arm_frame_2_4,
            w_left_arm_frame_in_left_link_frame_3 * H_left_link_1,
        );
    let x_left_link_frame_3_2 = (-w_left_link_frame_2)
        .mul_add(H_left_link_1, w_left_arm_frame_in_left_link_frame_1 * H_left_link_2);
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
    let w_right_link_frame_13 = w_right_arm_frame_in_right_link_frame_1
        * w_right_arm_frame_in_right_link_frame_3;
    let a_right_link_centre_3 = l
        .mul_add(turn_right_arm_frame_33, a_spindle_frame_in_right_arm_frame_3);
    let alpha_right_link_frame_2_of_place = sin_q_right_top * cos_q_right_ball;
    let alpha_right_link_frame_2 = -alpha_right_arm_frame_2
        + alpha_right_arm_frame_2_of_place_4 * alpha_right_arm_frame_2_of_opening_7
        + alpha_right_arm_frame_2_of_opening_2
            * ((-(w_right_arm_frame_2 * alpha_right_arm_frame_2_of_q_right_ball))
                .mul_add(
                    sin_q_right_top,
                    alpha_right_arm_frame_2_of_opening
                        * alpha_right_arm_frame_2_of_place_6 * cos_q_right_top * sin_q_left_ball,
                )
                + alpha_right_arm_frame_2_of_opening_4 * alpha_right_link_frame_2_of_place);
    let turn_right_link_frame_13 = w_right_link_frame_13 + alpha_right_link_frame_2;
    let a_right_link_centre_1 = a_spindle_frame_in_right_arm_frame_1
        - a_right_arm_centre_1_of_place;
    let a_right_arm_frame_in_right_link_frame_1 = a_right_link_centre_1
        .mul_add(cos_q_right_ball, a_right_link_centre_3 * sin_q_right_ball);
    let a_right_link_centre_1_2 = (-a_right_arm_frame_in_right_link_frame_1)
        .mul_add(S::int(2), l * turn_right_link_frame_13);
    let x_right_link_frame_1 = m * a_right_link_centre_1_2;
    let w_right_link_frame_2 = alpha_right_arm_frame_2_of_opening_4 - w_right_arm_frame_2;
    let w_right_link_frame_23 = w_right_arm_frame_in_right_link_frame_3 * w_right_link_frame_2;
    let alpha_right_arm_frame_3 = w_spindle_frame_in_right_arm_frame_1 * w_right_arm_frame_2;
    let alpha_right_arm_frame_in_right_link_frame_1 = (-alpha_right_arm_frame_1)
        .mul_add(cos_q_right_ball, alpha_right_arm_frame_3 * sin_q_right_ball);
    let alpha_right_link_frame_1 = w_right_arm_frame_in_right_link_frame_3
        .mul_add(
            alpha_right_arm_frame_2_of_opening_4, alpha_right_arm_frame_in_right_link_frame_1,
        );
    let turn_right_link_frame_23 = w_right_link_frame_23 + alpha_right_link_frame_1;
    let a_right_link_centre_2 = (-l)
        .mul_add(turn_right_link_frame_23, S::int(2) * a_right_arm_centre_2);
    let x_right_link_frame_2 = m * a_right_link_centre_2;
    let w_right_link_frame_11 = w_right_arm_frame_in_right_link_frame_1
        * w_right_arm_frame_in_right_link_frame_1;
    let w_right_link_frame_22 = w_right_link_frame_2 * w_right_link_frame_2;
    let turn_right_link_frame_33 = w_right_link_frame_11 + w_right_link_frame_22;
    let a_right_arm_frame_in_right_link_frame_3 = (-a_right_link_centre_1)
        .mul_add(sin_q_right_ball, a_right_link_centre_3 * cos_q_right_ball);
    let a_right_link_centre_3_2 = a_right_arm_frame_in_right_link_frame_3
        .mul_add(S::int(2), l * turn_right_link_frame_33);
    let x_right_link_frame_3 = m * a_right_link_centre_3_2;
    let H_right_link_2 = w_right_link_frame_2 * x_left_arm_frame_2_4;
    let x_right_link_frame_1_2 = alpha_right_link_frame_1
        .mul_add(
            x_left_arm_frame_2_4,
            w_right_arm_frame_in_right_link_frame_3 * H_right_link_2,
        );
    let H_right_link_1 = w_right_arm_frame_in_right_link_frame_1 * x_left_arm_frame_2_4;
    let x_right_link_frame_2_2 = alpha_right_link_frame_2
        .mul_add(
            x_left_arm_frame_2_4,
            w_right_arm_frame_in_right_link_frame_3 * H_right_link_1,
        );
    let x_right_link_frame_3_2 = (-w_right_link_frame_2)
        .mul_add(
            H_right_link_1,
            w_right_arm_frame_in_right_link_frame_1 * H_right_link_2,
        );
    let a_sleeve_centre_3 = g
        + l
            * ((-alpha_left_link_frame_2)
                .mul_add(sin_theta_plus_q_left_ball, w_left_arm_frame_22 * cos_theta)
                + alpha_right_arm_frame_2_of_opening_5
                    * alpha_right_arm_frame_2_of_opening_5 * cos_theta_plus_q_left_ball);
    let x_spindle_frame_in_sleeve_frame_3 = ms * a_sleeve_centre_3;
    let mb_sin_theta = mb * sin_theta;
    let mb_cos_theta = mb * cos_theta;
    let x_left_arm_frame_in_spindle_frame_1 = (-a_left_link_centre_1)
        .mul_add(mb_cos_theta, a_left_link_centre_3 * mb_sin_theta);
    let x_left_arm_frame_in_spindle_frame_2 = mb * a_left_arm_centre_2;
    let x_spindle_frame_in_N_1_of_place = S::int(2) * x_left_arm_frame_in_spindle_frame_2;
    let x_spindle_frame_in_N_1 = x_spindle_frame_in_N_1_of_place
        .mul_add(sin_psi, x_left_arm_frame_in_spindle_frame_1 * cos_psi);
    let x_spindle_frame_in_N_2 = (-x_spindle_frame_in_N_1_of_place)
        .mul_add(cos_psi, x_left_arm_frame_in_spindle_frame_1 * sin_psi);
    let x_left_arm_frame_in_spindle_frame_3 = a_left_link_centre_3
        .mul_add(mb_cos_theta, a_left_link_centre_1 * mb_sin_theta);
    let mb_sin_q_right_top = mb * sin_q_right_top;
    let mb_cos_q_right_top = mb * cos_q_right_top;
    let x_right_arm_frame_in_spindle_frame_1 = (-a_right_link_centre_1)
        .mul_add(mb_cos_q_right_top, a_right_link_centre_3 * mb_sin_q_right_top);
    let x_right_arm_frame_in_spindle_frame_2 = mb * a_right_arm_centre_2;
    let x_spindle_frame_in_N_1_2 = x_right_arm_frame_in_spindle_frame_2
        .mul_add(sin_psi, x_right_arm_frame_in_spindle_frame_1 * cos_psi);
    let x_spindle_frame_in_N_2_2 = (-x_right_arm_frame_in_spindle_frame_2)
        .mul_add(cos_psi, x_right_arm_frame_in_spindle_frame_1 * sin_psi);
    let x_right_arm_frame_in_spindle_frame_3 = a_right_link_centre_3
        .mul_add(mb_cos_q_right_top, a_right_link_centre_1 * mb_sin_q_right_top);
    let x_left_arm_frame_in_spindle_frame_1_2 = l * sin_theta;
    let x_left_arm_frame_2_3 = m * x_left_arm_frame_in_spindle_frame_1_2;
    let x_left_arm_frame_1_4 = x_left_arm_frame_2_4 * sin_theta;
    let x_left_arm_frame_in_spindle_frame_3_2 = l * cos_theta;
    let alpha_right_arm_frame_2_2_of_place = alpha_right_arm_frame_2_of_place
        * alpha_right_arm_frame_2_of_place_2;
    let alpha_right_arm_frame_2_2 = alpha_right_arm_frame_2_2_of_place * cos_angle;
    let a_right_arm_centre_1_2 = l * alpha_right_arm_frame_2_2;
    let x_right_arm_frame_1_3 = m * a_right_arm_centre_1_2;
    let x_right_arm_frame_in_spindle_frame_1_2 = l * sin_q_right_top;
    let x_right_arm_frame_2_3 = m * x_right_arm_frame_in_spindle_frame_1_2;
    let x_right_arm_frame_1_4 = x_left_arm_frame_2_4 * sin_q_right_top;
    let x_right_arm_frame_2_4 = x_left_arm_frame_2_4 * alpha_right_arm_frame_2_2;
    let w_left_link_frame_2_2_of_place = S::int(1) - alpha_left_link_frame_2_of_place;
    let w_left_link_frame_2_2 = -w_left_link_frame_2_2_of_place;
    let x_left_link_frame_in_left_arm_frame_3 = l * cos_q_left_ball;
    let a_left_link_centre_1_3 = (-l)
        .mul_add(
            w_left_link_frame_2_2,
            S::int(2) * x_left_link_frame_in_left_arm_frame_3,
        );
    let x_left_link_frame_1_3 = m * a_left_link_centre_1_3;
    let x_left_arm_frame_in_left_link_frame_1 = (-cos_theta)
        .mul_add(cos_q_left_ball, sin_theta * sin_q_left_ball);
    let x_left_arm_frame_in_left_link_frame_1_2 = sin_theta
        .mul_add(cos_q_left_ball, cos_theta * sin_q_left_ball);
    let a_left_link_centre_2_2 = l
        .mul_add(
            x_left_arm_frame_in_left_link_frame_1_2,
            S::int(2) * x_left_arm_frame_in_spindle_frame_1_2,
        );
    let x_left_link_frame_2_3 = m * a_left_link_centre_2_2;
    let x_left_link_frame_in_left_arm_frame_1 = l * sin_q_left_ball;
    let x_left_link_frame_3_3 = m * x_left_link_frame_in_left_arm_frame_1;
    let x_left_link_frame_1_4 = x_left_arm_frame_2_4 * x_left_arm_frame_in_left_link_frame_1_2;
    let x_left_link_frame_2_4 = x_left_arm_frame_2_4 * w_left_link_frame_2_2;
    let alpha_right_link_frame_2_2 = alpha_right_arm_frame_2_of_place_4
        .mul_add(alpha_right_arm_frame_2_2_of_place, -alpha_right_arm_frame_2_2);
    let a_right_arm_frame_in_right_link_frame_1_2 = a_right_arm_centre_1_2 * cos_q_right_ball;
    let a_right_link_centre_1_3_of_place = l * alpha_right_link_frame_2_2;
    let a_right_link_centre_1_3 = (-a_right_arm_frame_in_right_link_frame_1_2)
        .mul_add(S::int(2), a_right_link_centre_1_3_of_place);
    let x_right_link_frame_1_3 = m * a_right_link_centre_1_3;
    let x_right_arm_frame_in_right_link_frame_1 = (-cos_q_right_top)
        .mul_add(cos_q_right_ball, alpha_right_arm_frame_2_of_place_3);
    let x_right_arm_frame_in_right_link_frame_1_2 = cos_q_right_top
        .mul_add(sin_q_right_ball, alpha_right_link_frame_2_of_place);
    let a_right_link_centre_2_2 = l
        .mul_add(
            x_right_arm_frame_in_right_link_frame_1_2,
            S::int(2) * x_right_arm_frame_in_spindle_frame_1_2,
        );
    let x_right_link_frame_2_3 = m * a_right_link_centre_2_2;
    let a_right_arm_frame_in_right_link_frame_3_2 = a_right_arm_centre_1_2 * sin_q_right_ball;
    let x_right_link_frame_3_3 = m * a_right_arm_frame_in_right_link_frame_3_2;
    let x_right_link_frame_1_4 = x_left_arm_frame_2_4 * x_right_arm_frame_in_right_link_frame_1_2;
    let x_right_link_frame_2_4 = x_left_arm_frame_2_4 * alpha_right_link_frame_2_2;
    let a_sleeve_centre_3_2 = l
        * w_left_link_frame_2_2_of_place.mul_add(sin_theta_plus_q_left_ball, sin_theta);
    let x_spindle_frame_in_sleeve_frame_3_2 = ms * a_sleeve_centre_3_2;
    let x_left_arm_frame_in_spindle_frame_2_2 = mb * x_left_arm_frame_in_spindle_frame_1_2;
    let x_spindle_frame_in_N_1_3 = x_left_arm_frame_in_spindle_frame_2_2 * sin_psi;
    let x_left_arm_frame_in_spindle_frame_1_5 = l * mb_cos_theta;
    let x_spindle_frame_in_N_1_4 = x_left_arm_frame_in_spindle_frame_1_5 * cos_psi;
    let x_spindle_frame_in_N_2_3 = x_left_arm_frame_in_spindle_frame_2_2 * cos_psi;
    let x_spindle_frame_in_N_2_4 = x_left_arm_frame_in_spindle_frame_1_5 * sin_psi;
    let x_left_arm_frame_in_spindle_frame_3_5 = l * mb_sin_theta;
    let x_right_arm_frame_in_spindle_frame_2_2 = mb * x_right_arm_frame_in_spindle_frame_1_2;
    let x_spindle_frame_in_N_1_7 = x_right_arm_frame_in_spindle_frame_2_2 * sin_psi;
    let x_right_arm_frame_in_spindle_frame_1_5 = a_right_arm_centre_1_2 * mb_cos_q_right_top;
    let x_spindle_frame_in_N_1_8 = x_right_arm_frame_in_spindle_frame_1_5 * cos_psi;
    let x_spindle_frame_in_N_2_7 = x_right_arm_frame_in_spindle_frame_2_2 * cos_psi;
    let x_spindle_frame_in_N_2_8 = x_right_arm_frame_in_spindle_frame_1_5 * sin_psi;
    let x_right_arm_frame_in_spindle_frame_3_5 = a_right_arm_centre_1_2 * mb_sin_q_right_top;
    let x_spindle_frame_in_N_1_11 = x_left_arm_frame_in_spindle_frame_1_2 * sin_psi;
    let x_spindle_frame_in_N_2_11 = x_left_arm_frame_in_spindle_frame_1_2 * cos_psi;
    let x_spindle_frame_in_N_1_12 = x_right_arm_frame_in_spindle_frame_1_2 * sin_psi;
    let x_spindle_frame_in_N_2_12 = x_right_arm_frame_in_spindle_frame_1_2 * cos_psi;
    let x_right_arm_frame_in_right_link_frame_1_4 = a_right_arm_frame_in_right_link_frame_1_2;
    let x_right_link_frame_1_5 = (-x_right_arm_frame_in_right_link_frame_1_4)
        .mul_add(S::int(2), a_right_link_centre_1_3_of_place);
    let x_right_arm_frame_in_right_link_frame_3_2 = a_right_arm_frame_in_right_link_frame_3_2;
    let x_spindle_frame_in_N_1_13 = x_left_arm_frame_in_spindle_frame_3_2 * cos_psi;
    let x_spindle_frame_in_N_2_13 = x_left_arm_frame_in_spindle_frame_3_2 * sin_psi;
    let x_right_arm_frame_in_spindle_frame_1_6 = a_right_arm_centre_1_2 * cos_q_right_top;
    let x_spindle_frame_in_N_1_14 = x_right_arm_frame_in_spindle_frame_1_6 * cos_psi;
    let x_spindle_frame_in_N_2_14 = x_right_arm_frame_in_spindle_frame_1_6 * sin_psi;
    let x_right_arm_frame_in_spindle_frame_3_6 = a_right_arm_centre_1_2 * sin_q_right_top;
    let d1_of_place = alpha_right_arm_frame_2_2
        .mul_add(x_right_arm_frame_2_4, x_left_arm_frame_2_4);
    let d1_of_place_2 = alpha_right_link_frame_2_2
        .mul_add(x_right_link_frame_2_4, w_left_link_frame_2_2 * x_left_link_frame_2_4);
    let d1_of_place_3 = a_left_link_centre_1_3
        .mul_add(x_left_link_frame_1_3, a_right_arm_centre_1_2 * x_right_arm_frame_1_3);
    let d1_of_place_4 = x_right_link_frame_1_3
        .mul_add(x_right_link_frame_1_5, x_left_arm_frame_2_4);
    let d1_of_place_5 = d1_of_place + d1_of_place_2;
    let d1_of_place_6 = d1_of_place_3 + d1_of_place_4;
    let d1 = a_sleeve_centre_3_2
        .mul_add(
            x_spindle_frame_in_sleeve_frame_3_2,
            x_left_link_frame_in_left_arm_frame_1 * x_left_link_frame_3_3,
        ) + x_left_arm_frame_in_spindle_frame_1_2 * x_left_arm_frame_in_spindle_frame_3_5
        + x_right_link_frame_3_3 * x_right_arm_frame_in_right_link_frame_3_2
        + x_spindle_frame_in_N_1_4 * x_spindle_frame_in_N_1_13
        + x_spindle_frame_in_N_2_4 * x_spindle_frame_in_N_2_13
        + x_spindle_frame_in_N_1_8 * x_spindle_frame_in_N_1_14
        + x_spindle_frame_in_N_2_8 * x_spindle_frame_in_N_2_14
        + x_right_arm_frame_in_spindle_frame_3_5 * x_right_arm_frame_in_spindle_frame_3_6
        + S::ratio(1, 12) * d1_of_place_5 + S::ratio(1, 4) * d1_of_place_6;
    let d1_inv = S::int(1) / d1;
    let l2 = d1_inv
        * ((-x_spindle_frame_in_N_1_4)
            .mul_add(
                x_spindle_frame_in_N_1_11,
                x_spindle_frame_in_N_2_4 * x_spindle_frame_in_N_2_11,
            ) - x_spindle_frame_in_N_1_8 * x_spindle_frame_in_N_1_12
            + x_spindle_frame_in_N_2_8 * x_spindle_frame_in_N_2_12);
    let s3_of_place = (-x_spindle_frame_in_N_2_3)
        .mul_add(
            x_spindle_frame_in_N_2_13,
            x_spindle_frame_in_N_1_3 * x_spindle_frame_in_N_1_13,
        ) + x_spindle_frame_in_N_1_7 * x_spindle_frame_in_N_1_14
        - x_spindle_frame_in_N_2_7 * x_spindle_frame_in_N_2_14;
    let sin_theta_by_12 = S::ratio(1, 12) * sin_theta;
    let s3_of_place_2 = S::ratio(1, 4) * x_right_arm_frame_in_spindle_frame_1_2;
    let sin_q_right_top_by_12 = S::ratio(1, 12) * sin_q_right_top;
    let s3_of_place_3 = S::ratio(1, 4) * a_left_link_centre_2_2;
    let s3_of_place_4 = S::ratio(1, 12) * x_left_arm_frame_in_left_link_frame_1_2;
    let s3_of_place_5 = S::ratio(1, 4) * a_right_link_centre_2_2;
    let s3_of_place_6 = S::ratio(1, 12) * x_right_arm_frame_in_right_link_frame_1_2;
    let s3 = x_spindle_frame_in_N_1_3
        .mul_add(
            x_spindle_frame_in_N_1_11,
            J + Js
                + S::ratio(1, 4) * x_left_arm_frame_in_spindle_frame_1_2 * x_left_arm_frame_2_3,
        ) + x_spindle_frame_in_N_2_3 * x_spindle_frame_in_N_2_11
        + x_spindle_frame_in_N_1_7 * x_spindle_frame_in_N_1_12
        + x_spindle_frame_in_N_2_7 * x_spindle_frame_in_N_2_12 + l2 * s3_of_place
        + x_left_arm_frame_1_4 * sin_theta_by_12 + x_right_arm_frame_2_3 * s3_of_place_2
        + x_right_arm_frame_1_4 * sin_q_right_top_by_12
        + x_left_link_frame_2_3 * s3_of_place_3 + x_left_link_frame_1_4 * s3_of_place_4
        + x_right_link_frame_2_3 * s3_of_place_5 + x_right_link_frame_1_4 * s3_of_place_6;
    let r4_of_place = (-x_spindle_frame_in_N_1)
        .mul_add(
            x_spindle_frame_in_N_1_13,
            x_spindle_frame_in_sleeve_frame_3 * a_sleeve_centre_3_2,
        );
    let r4_of_place_2 = (-x_left_arm_frame_in_spindle_frame_3)
        .mul_add(
            x_left_arm_frame_in_spindle_frame_1_2,
            x_spindle_frame_in_N_2 * x_spindle_frame_in_N_2_13,
        );
    let r4_of_place_3 = x_spindle_frame_in_N_2_2
        .mul_add(
            x_spindle_frame_in_N_2_14,
            x_spindle_frame_in_N_1_2 * x_spindle_frame_in_N_1_14,
        );
    let r4_of_place_4 = r4_of_place - r4_of_place_2;
    let r4_of_place_5 = x_right_link_frame_2_2
        .mul_add(
            alpha_right_link_frame_2_2,
            x_left_link_frame_2_2 * w_left_link_frame_2_2,
        );
    let r4_of_place_6 = r4_of_place_3 - r4_of_place_4;
    let r4_of_place_7 = x_right_link_frame_3
        .mul_add(
            x_right_arm_frame_in_right_link_frame_3_2,
            x_left_link_frame_3 * x_left_link_frame_in_left_arm_frame_1,
        );
    let r4_of_place_8 = x_right_arm_frame_1
        .mul_add(a_right_arm_centre_1_2, l * x_left_arm_frame_1);
    let r4_of_place_9 = (-x_right_link_frame_1)
        .mul_add(x_right_link_frame_1_5, x_left_link_frame_1 * a_left_link_centre_1_3);
    let r4_of_place_10 = (-(x_right_arm_frame_in_spindle_frame_3
        * x_right_arm_frame_in_spindle_frame_3_6))
        .mul_add(S::int(12), x_right_arm_frame_2_2 * alpha_right_arm_frame_2_2);
    let r4_of_place_11 = r4_of_place_8 - r4_of_place_9;
    let r4_of_place_12 = r4_of_place_7.mul_add(S::int(6), x_left_arm_frame_2_2);
    let r4_of_place_13 = (-r4_of_place_11).mul_add(S::int(3), r4_of_place_10);
    let r4_of_place_14 = (-r4_of_place_6).mul_add(S::int(12), r4_of_place_5);
    let r4_of_place_15 = r4_of_place_12 + r4_of_place_13;
    let r4_of_place_16 = r4_of_place_14 - r4_of_place_15;
    let r4_of_place_17 = x_right_arm_frame_3_2
        .mul_add(cos_q_right_top, x_left_arm_frame_3_2 * cos_theta);
    let r4_of_place_18 = (-x_right_link_frame_3_2)
        .mul_add(
            x_right_arm_frame_in_right_link_frame_1,
            x_left_link_frame_3_2 * x_left_arm_frame_in_left_link_frame_1,
        );
    let r4_of_place_19 = (-l2).mul_add(r4_of_place_16, -r4_of_place_17);
    let r4_of_place_20 = r4_of_place_18 + r4_of_place_19;
    let r4 = x_spindle_frame_in_N_2
        .mul_add(
            x_spindle_frame_in_N_2_11,
            -S::ratio(1, 2) * x_left_arm_frame_2 * x_left_arm_frame_in_spindle_frame_1_2,
        ) - x_spindle_frame_in_N_1 * x_spindle_frame_in_N_1_11
        - x_spindle_frame_in_N_1_2 * x_spindle_frame_in_N_1_12
        + x_spindle_frame_in_N_2_2 * x_spindle_frame_in_N_2_12
        - x_left_arm_frame_1_2 * sin_theta_by_12 - x_right_arm_frame_2 * s3_of_place_2
        - x_right_arm_frame_1_2 * sin_q_right_top_by_12
        - x_left_link_frame_2 * s3_of_place_3 - x_left_link_frame_1_2 * s3_of_place_4
        - x_right_link_frame_2 * s3_of_place_5 + x_right_link_frame_1_2 * s3_of_place_6
        - S::ratio(1, 12) * r4_of_place_20;
    let spin_dot = r4 / s3;
    let opening_dot = S::ratio(1, 12) * d1_inv
        * (spin_dot * s3_of_place).mul_add(S::int(12), -r4_of_place_16);
    [spin_dot, opening_dot]
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
    let l_sq_m = l * l * m;
    let H_left_arm_2 = opening * l_sq_m;
    let H_left_arm_1 = w_spindle_frame_in_left_arm_frame_1 * l_sq_m;
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
    let H_right_arm_2 = w_right_arm_frame_2 * l_sq_m;
    let H_right_arm_1 = w_spindle_frame_in_right_arm_frame_1 * l_sq_m;
    let w_left_arm_frame_in_left_link_frame_1 = w_spindle_frame_in_left_arm_frame_3
        .mul_add(sin_q_left_ball, w_spindle_frame_in_left_arm_frame_1 * cos_q_left_ball);
    let w_left_link_frame_2 = opening
        - w_right_arm_frame_2_of_opening * (cos_theta + cos_theta_plus_q_left_ball);
    let H_left_link_2 = w_left_link_frame_2 * l_sq_m;
    let H_left_link_1 = w_left_arm_frame_in_left_link_frame_1 * l_sq_m;
    let w_right_arm_frame_in_right_link_frame_1 = w_spindle_frame_in_right_arm_frame_3
        .mul_add(
            sin_q_right_ball,
            w_spindle_frame_in_right_arm_frame_1 * cos_q_right_ball,
        );
    let w_right_link_frame_2 = w_right_arm_frame_2_of_opening_2
        * (cos_q_right_top * (S::int(1) + cos_q_right_ball)
            - sin_q_right_top * sin_q_right_ball) - w_right_arm_frame_2;
    let H_right_link_2 = w_right_link_frame_2 * l_sq_m;
    let H_right_link_1 = w_right_arm_frame_in_right_link_frame_1 * l_sq_m;
    let H_spindle_3 = J * spin;
    let H_sleeve_3 = Js * spin;
    let x_left_arm_frame_1_5 = l * opening;
    let x_left_arm_frame_2_5 = l * w_spindle_frame_in_left_arm_frame_1;
    let x_right_arm_frame_1_5 = l * w_right_arm_frame_2;
    let x_right_arm_frame_2_5 = l * w_spindle_frame_in_right_arm_frame_1;
    let x_left_arm_frame_in_left_link_frame_1_4 = x_left_arm_frame_1_5 * cos_q_left_ball;
    let x_left_arm_frame_in_left_link_frame_3_2 = x_left_arm_frame_1_5 * sin_q_left_ball;
    let x_left_link_frame_1_5 = x_left_arm_frame_in_left_link_frame_1_4
        .mul_add(S::int(2), l * w_left_link_frame_2);
    let x_left_link_frame_2_5 = x_left_arm_frame_2_5
        .mul_add(S::int(2), l * w_left_arm_frame_in_left_link_frame_1);
    let x_right_arm_frame_in_right_link_frame_1_5 = x_right_arm_frame_1_5 * cos_q_right_ball;
    let x_right_arm_frame_in_right_link_frame_3_3 = x_right_arm_frame_1_5 * sin_q_right_ball;
    let x_right_link_frame_1_6 = (-x_right_arm_frame_in_right_link_frame_1_5)
        .mul_add(S::int(2), l * w_right_link_frame_2);
    let x_right_link_frame_2_5 = x_right_arm_frame_2_5
        .mul_add(S::int(2), l * w_right_arm_frame_in_right_link_frame_1);
    let x_spindle_frame_in_sleeve_frame_3_3 = l
        * w_left_link_frame_2.mul_add(sin_theta_plus_q_left_ball, opening * sin_theta);
    let m_plus_mb_times_4 = mb.mul_add(S::int(4), m);
    let energy_of_place = x_left_arm_frame_2_5
        .mul_add(x_left_arm_frame_2_5, x_left_arm_frame_1_5 * x_left_arm_frame_1_5);
    let energy_of_place_2 = x_right_arm_frame_2_5
        .mul_add(x_right_arm_frame_2_5, x_right_arm_frame_1_5 * x_right_arm_frame_1_5);
    let energy_of_place_3 = x_left_link_frame_2_5
        .mul_add(x_left_link_frame_2_5, x_left_link_frame_1_5 * x_left_link_frame_1_5);
    let energy_of_place_4 = x_right_link_frame_2_5
        .mul_add(
            x_right_link_frame_2_5,
            x_right_link_frame_1_6 * x_right_link_frame_1_6,
        );
    let energy_of_place_5 = m
        * x_right_arm_frame_in_right_link_frame_3_3
            .mul_add(
                x_right_arm_frame_in_right_link_frame_3_3,
                x_left_arm_frame_in_left_link_frame_3_2 * x_left_arm_frame_in_left_link_frame_3_2,
            ) + ms * x_spindle_frame_in_sleeve_frame_3_3 * x_spindle_frame_in_sleeve_frame_3_3;
    let energy_of_opening = w_spindle_frame_in_left_arm_frame_1
        .mul_add(H_left_arm_1, opening * H_left_arm_2);
    let energy_of_place_6 = w_spindle_frame_in_right_arm_frame_1
        .mul_add(H_right_arm_1, w_right_arm_frame_2 * H_right_arm_2);
    let energy_of_place_7 = w_left_arm_frame_in_left_link_frame_1
        .mul_add(H_left_link_1, w_left_link_frame_2 * H_left_link_2);
    let energy_of_place_8 = w_right_arm_frame_in_right_link_frame_1
        .mul_add(H_right_link_1, w_right_link_frame_2 * H_right_link_2);
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
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_q_left_ball, cos_q_left_ball) = q_left_ball.sin_cos();
    let (sin_q_right_ball, cos_q_right_ball) = q_right_ball.sin_cos();
    let (sin_q_right_top, cos_q_right_top) = q_right_top.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let l_m = l * m;
    // x_left_arm_frame_1_3 = l*m
    let x_left_arm_frame_1_3 = l_m;
    let (_, cos_theta_plus_q_left_ball) = (theta + q_left_ball).sin_cos();
    // mp_spindle_frame_3 = l*ms*(cos(theta) + cos(theta + q_left_ball))
    let mp_spindle_frame_3 = l * ms * (cos_theta + cos_theta_plus_q_left_ball);
    // mp_left_arm_frame_3 = 3*l*m + 2*l*mb
    let mp_left_arm_frame_3 = (l * mb).mul_add(S::int(2), S::int(3) * l_m);
    // x_left_link_frame_in_left_arm_frame_1_2 = x_left_arm_frame_1_3*sin(q_left_ball)
    let x_left_link_frame_in_left_arm_frame_1_2 = x_left_arm_frame_1_3 * sin_q_left_ball;
    // x_left_link_frame_in_left_arm_frame_3_2 = x_left_arm_frame_1_3*cos(q_left_ball)
    let x_left_link_frame_in_left_arm_frame_3_2 = x_left_arm_frame_1_3 * cos_q_left_ball;
    // x_N_3 = mp_left_arm_frame_3 + x_left_link_frame_in_left_arm_frame_3_2
    let x_N_3 = mp_left_arm_frame_3 + x_left_link_frame_in_left_arm_frame_3_2;
    // x_right_link_frame_in_right_arm_frame_1_2 = x_left_arm_frame_1_3*sin(q_right_ball)
    let x_right_link_frame_in_right_arm_frame_1_2 = x_left_arm_frame_1_3 * sin_q_right_ball;
    // x_right_link_frame_in_right_arm_frame_3_2 = x_left_arm_frame_1_3*cos(q_right_ball)
    let x_right_link_frame_in_right_arm_frame_3_2 = x_left_arm_frame_1_3 * cos_q_right_ball;
    // x_N_3_2 = mp_left_arm_frame_3 + x_right_link_frame_in_right_arm_frame_3_2
    let x_N_3_2 = mp_left_arm_frame_3 + x_right_link_frame_in_right_arm_frame_3_2;
    // x_left_arm_frame_in_spindle_frame_3_6 = x_N_3*cos(theta) -
    //   x_left_link_frame_in_left_arm_frame_1_2*sin(theta)
    let x_left_arm_frame_in_spindle_frame_3_6 = (-x_left_link_frame_in_left_arm_frame_1_2)
        .mul_add(sin_theta, x_N_3 * cos_theta);
    // x_N_3_3 = 2*mp_spindle_frame_3 + x_left_arm_frame_in_spindle_frame_3_6
    let x_N_3_3 = mp_spindle_frame_3
        .mul_add(S::int(2), x_left_arm_frame_in_spindle_frame_3_6);
    // x_right_arm_frame_in_spindle_frame_3_7 = x_N_3_2*cos(q_right_top) -
    //   x_right_link_frame_in_right_arm_frame_1_2*sin(q_right_top)
    let x_right_arm_frame_in_spindle_frame_3_7 = (-x_right_link_frame_in_right_arm_frame_1_2)
        .mul_add(sin_q_right_top, x_N_3_2 * cos_q_right_top);
    // x_N_3_4 = x_N_3_3 + x_right_arm_frame_in_spindle_frame_3_7
    let x_N_3_4 = x_N_3_3 + x_right_arm_frame_in_spindle_frame_3_7;
    // Values.
    // V = -g*x_N_3_4/2
    let energy = -S::ratio(1, 2) * g * x_N_3_4;
    energy
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 1 operation, 2 sines and cosines.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 5], _u: &[S; 2]) -> [S; 2] {
    let [_, theta, _, q_left_ball, q_right_ball] = *q;
    // Sines and cosines.
    let (sin_q_right_ball, _) = q_right_ball.sin_cos();
    let (_, cos_theta_plus_q_left_ball) = (theta + q_left_ball).sin_cos();
    // Values.
    // divisor1 = cos(theta + q_left_ball)
    let divisor1 = cos_theta_plus_q_left_ball;
    // divisor2 = sin(q_right_ball)
    let divisor2 = sin_q_right_ball;
    [divisor1, divisor2]
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

/// Newton–Euler equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEuler;

impl<S: Scalar> System<S> for NewtonEuler {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 7,
            coordinates: 5,
            variables: 2,
            speeds: 2,
            reactions: 38,
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
        ["cos(theta + q_left_ball)", "sin(q_right_ball)"][at]
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
