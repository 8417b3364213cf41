//! Bricard's mechanism: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/bricard/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{constraint_slopes, constraints, coordinate_rates, divisors};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows rod1 force rod1_frame1, rod1 force rod1_frame2, rod1 force rod1_frame3, rod1 moment rod1_frame1, rod1 moment rod1_frame2, rod1 moment rod1_frame3, rod2 force rod2_frame1, rod2 force rod2_frame2, rod2 force rod2_frame3, rod2 moment rod2_frame1, rod2 moment rod2_frame2, rod2 moment rod2_frame3, rod3 force rod3_frame1, rod3 force rod3_frame2, rod3 force rod3_frame3, rod3 moment rod3_frame1, rod3 moment rod3_frame2, rod3 moment rod3_frame3, rod4 force rod4_frame1, rod4 force rod4_frame2, rod4 force rod4_frame3, rod4 moment rod4_frame1, rod4 moment rod4_frame2, rod4 moment rod4_frame3, rod5 force rod5_frame1, rod5 force rod5_frame2, rod5 force rod5_frame3, rod5 moment rod5_frame1, rod5 moment rod5_frame2, rod5 moment rod5_frame3.
///
/// 765 operations, 5 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 1],
) -> [[S; 30]; 30] {
    let Parameters { l, m, .. } = *p;
    let [q_P1, q_P2, q_P3, q_P4, q_P5] = *q;
    // Sines and cosines.
    let (sin_q_P5, cos_q_P5) = q_P5.sin_cos();
    let (sin_q_P4, cos_q_P4) = q_P4.sin_cos();
    let (sin_q_P3, cos_q_P3) = q_P3.sin_cos();
    let (sin_q_P2, cos_q_P2) = q_P2.sin_cos();
    let (sin_q_P1, cos_q_P1) = q_P1.sin_cos();
    // Step by step, each after the terms that it needs.
    let ratio_q_P2_u_P1_of_q_p5 = S::int(1) - sin_q_P5;
    let cos_q_p5_sq = cos_q_P5 * cos_q_P5;
    let ratio_q_P2_u_P1_of_q_p5_2 = ratio_q_P2_u_P1_of_q_p5
        .mul_add(S::int(2), -cos_q_p5_sq);
    let ratio_q_P2_u_P1_of_q_p5_3 = -ratio_q_P2_u_P1_of_q_p5_2;
    let cos_q_p4_sq = cos_q_P4 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5 = ratio_q_P2_u_P1_of_q_p5_3 * cos_q_p4_sq;
    let ratio_q_P2_u_P1_of_q_p5_4 = ratio_q_P2_u_P1_of_q_p5 - cos_q_p5_sq;
    let ratio_q_P2_u_P1_of_q_p5_5 = -ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_2 = ratio_q_P2_u_P1_of_q_p5_5 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_3 = ratio_q_P2_u_P1_of_q_p4_q_p5_2 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_4 = -sin_q_P4
        * (ratio_q_P2_u_P1_of_q_p4_q_p5 + ratio_q_P2_u_P1_of_q_p5_4)
        - ratio_q_P2_u_P1_of_q_p4_q_p5_3;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_5 = ratio_q_P2_u_P1_of_q_p4_q_p5_4 - ratio_q_P2_u_P1_of_q_p5_4;
    let ratio_q_P2_u_P1_of_q_p4 = S::int(1) + sin_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_6 = ratio_q_P2_u_P1_of_q_p5
        * (-cos_q_p4_sq).mul_add(S::int(2), ratio_q_P2_u_P1_of_q_p4);
    let sin_q_p3_cos_q_p5 = sin_q_P3 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place = cos_q_P3
        * ratio_q_P2_u_P1_of_q_p4_q_p5_6
            .mul_add(sin_q_p3_cos_q_p5, ratio_q_P2_u_P1_of_q_p4_q_p5_5 * cos_q_P3);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_7 = ratio_q_P2_u_P1_of_q_p5_5 * sin_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_8 = ratio_q_P2_u_P1_of_q_p4_q_p5_7
        - ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_9 = (-ratio_q_P2_u_P1_of_q_p5)
        .mul_add(S::int(3), cos_q_p5_sq) + S::int(2) * ratio_q_P2_u_P1_of_q_p4_q_p5_8;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_10 = ratio_q_P2_u_P1_of_q_p4_q_p5_7
        .mul_add(S::int(2), -ratio_q_P2_u_P1_of_q_p5);
    let cos_q_p3_cos_q_p5 = cos_q_P3 * cos_q_P5;
    let sin_q_p2_cos_q_p4 = sin_q_P2 * cos_q_P4;
    let cos_q_p2_cos_q_p4 = cos_q_P2 * cos_q_P4;
    let ratio_q_P2_u_P1_of_place_2 = sin_q_P2
        * (-ratio_q_P2_u_P1_of_q_p4_q_p5_6)
            .mul_add(cos_q_p3_cos_q_p5, ratio_q_P2_u_P1_of_q_p4_q_p5_5 * sin_q_P3);
    let x_rod2_frame_in_rod3_frame_3_4 = cos_q_P2 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_3 = ratio_q_P2_u_P1_of_q_p4_q_p5_2 * sin_q_P2;
    let ratio_q_P2_u_P1_of_place_4 = cos_q_P1
        * (sin_q_P1
            * (ratio_q_P2_u_P1_of_q_p4_q_p5_5 - S::int(2) * ratio_q_P2_u_P1_of_place
                + cos_q_P2
                    * (cos_q_P2
                        * (ratio_q_P2_u_P1_of_q_p5
                            + sin_q_P4
                                * ratio_q_P2_u_P1_of_q_p4_q_p5
                                    .mul_add(S::int(2), ratio_q_P2_u_P1_of_q_p5)
                            + S::int(2) * ratio_q_P2_u_P1_of_q_p4_q_p5_3 + ratio_q_P2_u_P1_of_place)
                        - sin_q_p2_cos_q_p4
                            * ratio_q_P2_u_P1_of_q_p4_q_p5_10
                                .mul_add(
                                    cos_q_p3_cos_q_p5,
                                    ratio_q_P2_u_P1_of_q_p4_q_p5_9 * sin_q_P3,
                                )))
            - cos_q_P1
                * (cos_q_P5
                    * (ratio_q_P2_u_P1_of_q_p4_q_p5_10 * cos_q_p2_cos_q_p4)
                        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_q_p4_q_p5_6 * sin_q_P2)
                    + cos_q_P3
                        * (-ratio_q_P2_u_P1_of_q_p4_q_p5_9)
                            .mul_add(
                                cos_q_p2_cos_q_p4,
                                S::int(2) * ratio_q_P2_u_P1_of_place_2,
                            )))
        + cos_q_P3
            * (cos_q_p2_cos_q_p4 * (ratio_q_P2_u_P1_of_q_p5_2 - ratio_q_P2_u_P1_of_q_p4_q_p5_8)
                + ratio_q_P2_u_P1_of_place_2)
        + cos_q_P4 * cos_q_P5
            * x_rod2_frame_in_rod3_frame_3_4
                .mul_add(ratio_q_P2_u_P1_of_q_p4_q_p5_7, ratio_q_P2_u_P1_of_place_3);
    let ratio_q_P2_u_P1_of_q_p3_q_p5 = S::int(1) - cos_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_11 = ratio_q_P2_u_P1_of_q_p4_q_p5_7 - S::int(1);
    let ratio_q_P2_u_P1_of_place_5 = ratio_q_P2_u_P1_of_q_p4_q_p5_11 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_6 = -ratio_q_P2_u_P1_of_q_p3_q_p5 - ratio_q_P2_u_P1_of_place_5;
    let ratio_q_P2_u_P1_of_place_7 = ratio_q_P2_u_P1_of_place_6
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5_2 * cos_q_P2);
    let ratio_q_P2_u_P1_of_place_8 = S::int(1) + ratio_q_P2_u_P1_of_place_7;
    let ratio_q_P2_u_P1_of_place_9 = ratio_q_P2_u_P1_of_q_p4_q_p5_11
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p5);
    let ratio_q_P2_u_P1_of_place_10 = ratio_q_P2_u_P1_of_place_9
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_8 * sin_q_P1);
    let l_sq = l * l;
    let ratio_q_P2_u_P1_of_place_11 = ratio_q_P2_u_P1_of_place_3
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_q_p4_q_p5_7 * cos_q_P2);
    let cos_q_p3_cos_q_p1 = cos_q_P1 * cos_q_P3;
    let x_rod1_frame_in_rod2_frame_2_3 = sin_q_P1 * sin_q_P2;
    let sin_q_p3_cos_q_p1 = cos_q_P1 * sin_q_P3;
    let x_rod2_frame_in_rod3_frame_2_5 = x_rod1_frame_in_rod2_frame_2_3
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p1);
    let sin_q_p2_sin_q_p4 = sin_q_P2 * sin_q_P4;
    let ratio_q_P2_u_P1_of_place_12 = sin_q_p2_sin_q_p4
        .mul_add(sin_q_P3, -cos_q_p2_cos_q_p4);
    let ratio_q_P2_u_P1_of_place_13 = x_rod2_frame_in_rod3_frame_2_5 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_14 = l
        * (ratio_q_P2_u_P1_of_place_13
            + sin_q_P5
                * (-ratio_q_P2_u_P1_of_place_12)
                    .mul_add(sin_q_P1, cos_q_p3_cos_q_p1 * sin_q_P4));
    let ratio_q_P2_u_P1_of_place_15 = (-sin_q_P3)
        .mul_add(sin_q_P5, cos_q_p3_cos_q_p5 * sin_q_P4);
    let x_N_in_rod1_frame_3_3_of_place = sin_q_p3_cos_q_p5
        .mul_add(sin_q_P4, cos_q_P3 * sin_q_P5);
    let ratio_q_P2_u_P1_of_place_16 = (-x_N_in_rod1_frame_3_3_of_place)
        .mul_add(sin_q_P2, cos_q_p2_cos_q_p4 * cos_q_P5);
    let ratio_q_P2_u_P1_of_place_17 = ratio_q_P2_u_P1_of_place_16
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_15 * cos_q_P1);
    let cos_q_p2_sin_q_p4 = cos_q_P2 * sin_q_P4;
    let ratio_q_P2_u_P1_of_place_18 = cos_q_p3_cos_q_p1 * cos_q_P4;
    let ratio_q_P2_u_P1_of_place_19 = cos_q_P5
        * (ratio_q_P2_u_P1_of_place_18
            - sin_q_P1 * sin_q_p2_cos_q_p4.mul_add(sin_q_P3, cos_q_p2_sin_q_p4));
    let ratio_q_P2_u_P1_of_place_20 = l * ratio_q_P2_u_P1_of_place_19;
    let ratio_q_P2_u_P1_of_place_21 = l * ratio_q_P2_u_P1_of_place_7;
    let x_N_in_rod1_frame_3_3_of_place_2 = x_N_in_rod1_frame_3_3_of_place
        .mul_add(cos_q_P2, sin_q_p2_cos_q_p4 * cos_q_P5);
    let ratio_q_P2_u_P1_of_place_22 = l * x_N_in_rod1_frame_3_3_of_place_2;
    let ratio_q_P2_u_P1_of_place_23 = ratio_q_P2_u_P1_of_place_6
        .mul_add(cos_q_P2, -ratio_q_P2_u_P1_of_place_3);
    let ratio_q_P2_u_P1_of_place_24 = sin_q_P1
        * (-ratio_q_P2_u_P1_of_place_17)
            .mul_add(
                ratio_q_P2_u_P1_of_place_22,
                ratio_q_P2_u_P1_of_place_14 * ratio_q_P2_u_P1_of_place_23,
            );
    let ratio_q_P2_u_P1_of_place_25 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_7)
        .mul_add(
            sin_q_P2,
            x_rod2_frame_in_rod3_frame_3_4 * ratio_q_P2_u_P1_of_q_p4_q_p5_2,
        );
    let ratio_q_P2_u_P1_of_place_26 = l * ratio_q_P2_u_P1_of_place_25;
    let x_rod1_frame_in_rod2_frame_1_3 = sin_q_P1 * cos_q_P2;
    let ratio_q_P2_u_P1_of_q_p3 = sin_q_P3 - S::int(1);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_2 = ratio_q_P2_u_P1_of_q_p5_5 * cos_q_P3;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_3 = (-ratio_q_P2_u_P1_of_q_p3)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_q_p3_q_p5_2);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_4 = ratio_q_P2_u_P1_of_q_p5_5 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_27 = x_rod1_frame_in_rod2_frame_1_3
        * ratio_q_P2_u_P1_of_q_p4_q_p5_7;
    let ratio_q_P2_u_P1_of_place_28 = x_rod1_frame_in_rod2_frame_1_3 * l_sq
        * (sin_q_P1 * cos_q_P5
            * (cos_q_p2_sin_q_p4
                - sin_q_P3
                    * sin_q_p2_cos_q_p4
                        .mul_add(ratio_q_P2_u_P1_of_q_p3, cos_q_p2_sin_q_p4))
            + cos_q_P3
                * (cos_q_P4
                    * (-ratio_q_P2_u_P1_of_q_p3_q_p5_3)
                        .mul_add(
                            cos_q_P1,
                            x_rod1_frame_in_rod2_frame_2_3 * ratio_q_P2_u_P1_of_q_p3_q_p5_4,
                        ) + ratio_q_P2_u_P1_of_place_27));
    let ratio_q_P2_u_P1_of_place_29 = ratio_q_P2_u_P1_of_place_21
        * (ratio_q_P2_u_P1_of_place_14
            * (-ratio_q_P2_u_P1_of_q_p4_q_p5_2)
                .mul_add(cos_q_p3_cos_q_p1, ratio_q_P2_u_P1_of_place_11 * sin_q_P1)
            - ratio_q_P2_u_P1_of_place_17 * ratio_q_P2_u_P1_of_place_20)
        + ratio_q_P2_u_P1_of_place_24 * ratio_q_P2_u_P1_of_place_26
        + x_N_in_rod1_frame_3_3_of_place_2 * ratio_q_P2_u_P1_of_place_28;
    let x_rod1_frame_in_rod2_frame_2_2 = cos_q_P1 * sin_q_P2;
    let ratio_q_P2_u_P1_of_place_30 = l
        * (sin_q_P1 * (cos_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_place_5)
            + x_rod1_frame_in_rod2_frame_2_2 * ratio_q_P2_u_P1_of_place_9);
    let ratio_q_P2_u_P1_of_place_31 = ratio_q_P2_u_P1_of_place_9 * cos_q_P2;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_12 = cos_q_p4_sq
        + sin_q_P5 * (ratio_q_P2_u_P1_of_q_p4 - cos_q_p4_sq);
    let ratio_q_P2_u_P1_of_place_32 = ratio_q_P2_u_P1_of_q_p4_q_p5_12 * sin_q_P3;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_13 = sin_q_P5 + ratio_q_P2_u_P1_of_q_p4_q_p5_7;
    let ratio_q_P2_u_P1_of_place_33 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p4_q_p5_13;
    let ratio_q_P2_u_P1_of_place_34 = ratio_q_P2_u_P1_of_q_p4_q_p5_12 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_35 = ratio_q_P2_u_P1_of_q_p4 * sin_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_36 = ratio_q_P2_u_P1_of_place_7 * l_sq;
    let x_N_in_rod1_frame_3_3 = x_N_in_rod1_frame_3_3_of_place_2 * sin_q_P1;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_5 = cos_q_p3_cos_q_p5 + ratio_q_P2_u_P1_of_q_p3_q_p5_4;
    let ratio_q_P2_u_P1_of_place_37 = cos_q_P1
        * (sin_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_2);
    let x_rod1_frame_in_rod2_frame_1_2 = cos_q_P1 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_38 = l_sq
        * (sin_q_P2
            * (sin_q_P1
                * (cos_q_P2
                    * (sin_q_P4 * (ratio_q_P2_u_P1_of_q_p5 - cos_q_p3_cos_q_p5)
                        + ratio_q_P2_u_P1_of_q_p3 * sin_q_P5)
                    - sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p3_q_p5_5)
                - ratio_q_P2_u_P1_of_place_37 * cos_q_P4)
            - x_rod1_frame_in_rod2_frame_1_2 * x_N_in_rod1_frame_3_3_of_place);
    let ratio_q_P2_u_P1_of_place_39 = -ratio_q_P2_u_P1_of_place_36
        * (sin_q_p3_cos_q_p1 * cos_q_P1
            * (ratio_q_P2_u_P1_of_place_34 + ratio_q_P2_u_P1_of_place_35)
            + sin_q_P1
                * (sin_q_P2
                    * (cos_q_P3
                        * (sin_q_P1
                            * (sin_q_P2
                                * ratio_q_P2_u_P1_of_q_p4
                                    .mul_add(cos_q_p3_cos_q_p5, -ratio_q_P2_u_P1_of_place_32)
                                + ratio_q_P2_u_P1_of_place_33)
                            + cos_q_P1
                                * ratio_q_P2_u_P1_of_place_35
                                    .mul_add(S::int(2), ratio_q_P2_u_P1_of_place_34))
                        - sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_of_place_32)
                    + sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_of_place_33))
        + l * ratio_q_P2_u_P1_of_place_24 * ratio_q_P2_u_P1_of_place_31
        - x_N_in_rod1_frame_3_3 * ratio_q_P2_u_P1_of_place_38;
    let cos_q_p3_sin_q_p1 = sin_q_P1 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_40 = l
        * ratio_q_P2_u_P1_of_q_p4_q_p5_2
            .mul_add(cos_q_p3_sin_q_p1, ratio_q_P2_u_P1_of_place_11 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_41 = x_rod1_frame_in_rod2_frame_1_3 * sin_q_P4;
    let ratio_q_P2_u_P1_of_place_42 = ratio_q_P2_u_P1_of_place_25 * sin_q_P1;
    let ratio_q_P2_u_P1_of_place_43 = ratio_q_P2_u_P1_of_place_36
        * (sin_q_P1
            * (sin_q_P2
                * (sin_q_P3
                    * (ratio_q_P2_u_P1_of_place_27
                        + cos_q_P4
                            * (cos_q_P1
                                * (-ratio_q_P2_u_P1_of_q_p3_q_p5_2)
                                    .mul_add(S::int(2), sin_q_p3_cos_q_p5)
                                + x_rod1_frame_in_rod2_frame_2_3 * ratio_q_P2_u_P1_of_q_p3_q_p5_5))
                    + cos_q_p3_cos_q_p5
                        * (ratio_q_P2_u_P1_of_place_41 - ratio_q_P2_u_P1_of_place_18))
                + cos_q_p2_sin_q_p4 * ratio_q_P2_u_P1_of_place_37)
            - ratio_q_P2_u_P1_of_place_18 * ratio_q_P2_u_P1_of_place_37)
        + ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_of_place_31
        + ratio_q_P2_u_P1_of_place_38 * ratio_q_P2_u_P1_of_place_42;
    let ratio_q_P2_u_P1_of_place_44 = (-ratio_q_P2_u_P1_of_place_16)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_15 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_45 = l * ratio_q_P2_u_P1_of_place_44;
    let x_rod1_frame_in_N_1 = l * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_46 = x_rod1_frame_in_N_1 * ratio_q_P2_u_P1_of_place_23;
    let ratio_q_P2_u_P1_of_place_47 = l
        / ((-ratio_q_P2_u_P1_of_place_29)
            .mul_add(
                ratio_q_P2_u_P1_of_place_30,
                ratio_q_P2_u_P1_of_place_39 * ratio_q_P2_u_P1_of_place_40,
            ) + ratio_q_P2_u_P1_of_place_43 * ratio_q_P2_u_P1_of_place_45
            + ratio_q_P2_u_P1_of_place_4 * l_sq * ratio_q_P2_u_P1_of_place_46);
    let ratio_q_P2_u_P1_of_place_48 = l_sq * ratio_q_P2_u_P1_of_place_47;
    let ratio_q_P2_u_P1_of_place_49 = ratio_q_P2_u_P1_of_place_14
        .mul_add(
            ratio_q_P2_u_P1_of_place_25,
            ratio_q_P2_u_P1_of_place_19 * ratio_q_P2_u_P1_of_place_22,
        );
    let ratio_q_P2_u_P1_of_place_50 = x_N_in_rod1_frame_3_3_of_place
        .mul_add(cos_q_P1, x_rod1_frame_in_rod2_frame_2_3 * ratio_q_P2_u_P1_of_place_15);
    let ratio_q_P2_u_P1_of_place_51 = (-ratio_q_P2_u_P1_of_place_22)
        .mul_add(
            ratio_q_P2_u_P1_of_place_50,
            ratio_q_P2_u_P1_of_place_14 * ratio_q_P2_u_P1_of_place_31,
        );
    let ratio_q_P2_u_P1_of_place_52 = ratio_q_P2_u_P1_of_place_26
        .mul_add(
            ratio_q_P2_u_P1_of_place_50,
            ratio_q_P2_u_P1_of_place_20 * ratio_q_P2_u_P1_of_place_31,
        );
    let ratio_q_P2_u_P1_of_place_53 = ratio_q_P2_u_P1_of_place_47
        * (-ratio_q_P2_u_P1_of_place_9)
            .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_8 * cos_q_P1);
    let sin_q_p3_sin_q_p1 = sin_q_P1 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_54 = ratio_q_P2_u_P1_of_place_48
        * (sin_q_P5 * (-cos_q_p3_cos_q_p1).mul_add(sin_q_P2, sin_q_p3_sin_q_p1)
            - cos_q_P5
                * cos_q_p3_sin_q_p1
                    .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_place_12 * cos_q_P1));
    let ratio_q_P2_u_P1_of_place_55 = ratio_q_P2_u_P1_of_place_54 * cos_q_P5;
    let ratio_q_P2_u_P1 = ratio_q_P2_u_P1_of_place_53
        * ((-ratio_q_P2_u_P1_of_place_40)
            .mul_add(
                ratio_q_P2_u_P1_of_place_51,
                ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_of_place_49,
            ) - ratio_q_P2_u_P1_of_place_45 * ratio_q_P2_u_P1_of_place_52)
        + ratio_q_P2_u_P1_of_place_4 * ratio_q_P2_u_P1_of_place_10 * ratio_q_P2_u_P1_of_place_48
        + ratio_q_P2_u_P1_of_place_55 * (ratio_q_P2_u_P1_of_q_p4_q_p5_7 - ratio_q_P2_u_P1_of_q_p5);
    let ratio_q_P3_u_P1_of_place = (-x_N_in_rod1_frame_3_3)
        .mul_add(
            ratio_q_P2_u_P1_of_place_22,
            ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_14,
        );
    let ratio_q_P3_u_P1_of_place_2 = ratio_q_P2_u_P1_of_place_22
        .mul_add(
            ratio_q_P2_u_P1_of_place_42,
            ratio_q_P2_u_P1_of_place_19 * ratio_q_P2_u_P1_of_place_21,
        );
    let ratio_q_P3_u_P1_of_place_3 = ratio_q_P2_u_P1_of_place_10 * ratio_q_P2_u_P1_of_place_47;
    let ratio_q_P3_u_P1_of_place_4 = ratio_q_P2_u_P1_of_place_54 * cos_q_P4;
    let ratio_q_P3_u_P1 = ratio_q_P2_u_P1_of_place_53
        * (ratio_q_P2_u_P1_of_place_40
            .mul_add(
                ratio_q_P3_u_P1_of_place,
                ratio_q_P2_u_P1_of_place_46 * ratio_q_P2_u_P1_of_place_49,
            ) + ratio_q_P2_u_P1_of_place_45 * ratio_q_P3_u_P1_of_place_2)
        + ratio_q_P2_u_P1_of_place_29 * ratio_q_P3_u_P1_of_place_3
        + ratio_q_P3_u_P1_of_place_4
            * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_3)
                .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_q_p5) + ratio_q_P2_u_P1_of_q_p3_q_p5_4);
    let ratio_q_P4_u_P1_of_place = (-(x_rod1_frame_in_rod2_frame_1_3 * ratio_q_P2_u_P1_of_place_9))
        .mul_add(
            ratio_q_P2_u_P1_of_place_22,
            ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_of_place_50,
        );
    let ratio_q_P4_u_P1 = ratio_q_P2_u_P1_of_place_55
        * (sin_q_P5 - sin_q_P3 - cos_q_p3_cos_q_p5
            - sin_q_P4
                * (ratio_q_P2_u_P1_of_q_p4_q_p5_7 - ratio_q_P2_u_P1_of_q_p3_q_p5
                    + sin_q_P3 * (S::int(2) - ratio_q_P2_u_P1_of_q_p4_q_p5_13)))
        + ratio_q_P2_u_P1_of_place_39 * ratio_q_P3_u_P1_of_place_3
        + ratio_q_P2_u_P1_of_place_53
            * (ratio_q_P2_u_P1_of_place_30
                .mul_add(
                    ratio_q_P3_u_P1_of_place,
                    ratio_q_P2_u_P1_of_place_46 * ratio_q_P2_u_P1_of_place_51,
                ) - ratio_q_P2_u_P1_of_place_45 * ratio_q_P4_u_P1_of_place);
    let ratio_q_P5_u_P1 = ratio_q_P3_u_P1_of_place_4
        * (sin_q_P4 * ratio_q_P2_u_P1_of_q_p5_3.mul_add(sin_q_P3, ratio_q_P2_u_P1_of_q_p5_2)
            + ratio_q_P2_u_P1_of_q_p5 * (ratio_q_P2_u_P1_of_q_p3_q_p5 - sin_q_P3))
        + ratio_q_P2_u_P1_of_place_43 * ratio_q_P3_u_P1_of_place_3
        + ratio_q_P2_u_P1_of_place_53
            * (ratio_q_P2_u_P1_of_place_30
                .mul_add(
                    ratio_q_P3_u_P1_of_place_2,
                    ratio_q_P2_u_P1_of_place_46 * ratio_q_P2_u_P1_of_place_52,
                ) + ratio_q_P2_u_P1_of_place_40 * ratio_q_P4_u_P1_of_place);
    let x_rod1_frame_3 = l * m;
    let x_rod1_frame_in_N_3 = l * sin_q_P1;
    let x_N_in_rod1_frame_1 = (-x_rod1_frame_in_N_3)
        .mul_add(cos_q_P1, x_rod1_frame_in_N_1 * sin_q_P1);
    let x_rod1_frame_2_2 = m * l_sq;
    let x_N_in_rod1_frame_3 = x_rod1_frame_in_N_3
        .mul_add(sin_q_P1, x_rod1_frame_in_N_1 * cos_q_P1);
    let x_rod5_frame_1_3 = l * ratio_q_P2_u_P1;
    let x_rod2_frame_1_3 = m * x_rod5_frame_1_3;
    let x_rod2_frame_in_rod1_frame_1 = l * sin_q_P2;
    let a_rod2_centre_3_2 = l.mul_add(S::int(2), -x_rod2_frame_in_rod1_frame_1);
    let x_rod2_frame_3_3 = m * a_rod2_centre_3_2;
    let x_rod2_frame_1_4 = x_rod1_frame_2_2 * sin_q_P2;
    let x_rod2_frame_in_rod1_frame_2 = l * cos_q_P2;
    let x_rod1_frame_in_rod2_frame_1 = x_rod2_frame_in_rod1_frame_2
        .mul_add(cos_q_P2, x_rod2_frame_in_rod1_frame_1 * sin_q_P2);
    let x_rod1_frame_in_rod2_frame_2 = (-x_rod2_frame_in_rod1_frame_1)
        .mul_add(cos_q_P2, x_rod2_frame_in_rod1_frame_2 * sin_q_P2);
    let x_rod2_frame_3_4 = ratio_q_P2_u_P1 * x_rod1_frame_2_2;
    let x_rod2_frame_in_rod3_frame_2_4 = cos_q_P2 * cos_q_P3;
    let w_rod2_frame_in_rod3_frame_2_2 = ratio_q_P2_u_P1
        .mul_add(sin_q_P3, x_rod2_frame_in_rod3_frame_2_4);
    let a_rod3_centre_1_3_of_place = l * w_rod2_frame_in_rod3_frame_2_2;
    let a_rod3_centre_1_3 = (-x_rod5_frame_1_3)
        .mul_add(S::int(2), a_rod3_centre_1_3_of_place);
    let x_rod3_frame_1_3 = m * a_rod3_centre_1_3;
    let w_rod3_frame_1_2 = sin_q_P2 + ratio_q_P3_u_P1;
    let x_rod5_frame_3_3 = l - x_rod2_frame_in_rod1_frame_1;
    let x_rod2_frame_in_rod3_frame_2 = x_rod5_frame_3_3 * sin_q_P3;
    let l_w_rod3_frame_1_2 = l * w_rod3_frame_1_2;
    let a_rod3_centre_2_3 = x_rod2_frame_in_rod3_frame_2
        .mul_add(S::int(2), l_w_rod3_frame_1_2);
    let x_rod3_frame_2_3 = m * a_rod3_centre_2_3;
    let x_rod2_frame_in_rod3_frame_3 = x_rod5_frame_3_3 * cos_q_P3;
    let x_rod3_frame_3_3 = m * x_rod2_frame_in_rod3_frame_3;
    let x_rod3_frame_1_4 = x_rod1_frame_2_2 * w_rod3_frame_1_2;
    let x_rod3_frame_in_rod2_frame_3 = l * cos_q_P3;
    let x_rod3_frame_in_rod2_frame_2 = l * sin_q_P3;
    let x_rod3_frame_2_4 = x_rod1_frame_2_2 * w_rod2_frame_in_rod3_frame_2_2;
    let x_rod2_frame_in_rod3_frame_2_2 = x_rod3_frame_in_rod2_frame_2
        .mul_add(sin_q_P3, x_rod3_frame_in_rod2_frame_3 * cos_q_P3);
    let x_rod2_frame_in_rod3_frame_3_2 = (-x_rod3_frame_in_rod2_frame_2)
        .mul_add(cos_q_P3, x_rod3_frame_in_rod2_frame_3 * sin_q_P3);
    let x_rod5_frame_1_4 = a_rod3_centre_1_3_of_place - x_rod5_frame_1_3;
    let x_rod3_frame_in_rod4_frame_1 = x_rod5_frame_1_4
        .mul_add(cos_q_P4, x_rod2_frame_in_rod3_frame_3 * sin_q_P4);
    let x_rod4_frame_1_3 = m * x_rod3_frame_in_rod4_frame_1;
    let w_rod2_frame_in_rod3_frame_3_2 = (-ratio_q_P2_u_P1)
        .mul_add(cos_q_P3, x_rod2_frame_in_rod3_frame_3_4);
    let w_rod3_frame_in_rod4_frame_3_2 = (-w_rod3_frame_1_2)
        .mul_add(sin_q_P4, w_rod2_frame_in_rod3_frame_3_2 * cos_q_P4);
    let x_rod5_frame_2_3 = x_rod2_frame_in_rod3_frame_2 + l_w_rod3_frame_1_2;
    let a_rod4_centre_2_3_of_place = l * w_rod3_frame_in_rod4_frame_3_2;
    let a_rod4_centre_2_3 = (-x_rod5_frame_2_3)
        .mul_add(S::int(2), a_rod4_centre_2_3_of_place);
    let x_rod4_frame_2_3 = m * a_rod4_centre_2_3;
    let w_rod4_frame_2_2 = ratio_q_P4_u_P1 - w_rod2_frame_in_rod3_frame_2_2;
    let x_rod3_frame_in_rod4_frame_3 = (-x_rod5_frame_1_4)
        .mul_add(sin_q_P4, x_rod2_frame_in_rod3_frame_3 * cos_q_P4);
    let l_w_rod4_frame_2_2 = l * w_rod4_frame_2_2;
    let a_rod4_centre_3_3 = x_rod3_frame_in_rod4_frame_3
        .mul_add(S::int(2), l_w_rod4_frame_2_2);
    let x_rod4_frame_3_3 = m * a_rod4_centre_3_3;
    let x_rod4_frame_in_rod3_frame_1 = l * cos_q_P4;
    let x_rod4_frame_in_rod3_frame_3 = l * sin_q_P4;
    let x_rod3_frame_in_rod4_frame_1_2 = (-x_rod4_frame_in_rod3_frame_3)
        .mul_add(cos_q_P4, x_rod4_frame_in_rod3_frame_1 * sin_q_P4);
    let x_rod4_frame_2_4 = x_rod1_frame_2_2 * w_rod4_frame_2_2;
    let x_rod4_frame_3_4 = x_rod1_frame_2_2 * w_rod3_frame_in_rod4_frame_3_2;
    let x_rod3_frame_in_rod4_frame_3_2 = x_rod4_frame_in_rod3_frame_3
        .mul_add(sin_q_P4, x_rod4_frame_in_rod3_frame_1 * cos_q_P4);
    let w_rod5_frame_3_2 = ratio_q_P5_u_P1 + w_rod3_frame_in_rod4_frame_3_2;
    let x_rod5_frame_2_4 = a_rod4_centre_2_3_of_place - x_rod5_frame_2_3;
    let x_rod4_frame_in_rod5_frame_1 = x_rod5_frame_2_4
        .mul_add(sin_q_P5, x_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let a_rod5_centre_1_3 = (-x_rod4_frame_in_rod5_frame_1)
        .mul_add(S::int(2), l * w_rod5_frame_3_2);
    let x_rod5_frame_1_5 = m * a_rod5_centre_1_3;
    let x_rod2_frame_in_rod3_frame_2_3 = (-x_rod1_frame_in_rod2_frame_2_2)
        .mul_add(cos_q_P3, sin_q_p3_sin_q_p1);
    let x_rod2_frame_in_rod3_frame_3_3 = x_rod1_frame_in_rod2_frame_2_2
        .mul_add(sin_q_P3, cos_q_p3_sin_q_p1);
    let x_rod3_frame_in_rod4_frame_1_3 = (-x_rod1_frame_in_rod2_frame_1_2)
        .mul_add(cos_q_P4, x_rod2_frame_in_rod3_frame_3_3 * sin_q_P4);
    let x_rod4_frame_in_rod5_frame_1_2 = (-x_rod2_frame_in_rod3_frame_2_3)
        .mul_add(sin_q_P5, x_rod3_frame_in_rod4_frame_1_3 * cos_q_P5);
    let x_rod3_frame_in_rod4_frame_1_4 = x_rod2_frame_in_rod3_frame_3_4
        .mul_add(sin_q_P4, sin_q_p2_cos_q_p4);
    let x_rod4_frame_in_rod5_frame_1_3 = x_rod3_frame_in_rod4_frame_1_4
        .mul_add(cos_q_P5, x_rod2_frame_in_rod3_frame_2_4 * sin_q_P5);
    let x_rod2_frame_in_rod3_frame_3_5 = (-x_rod1_frame_in_rod2_frame_2_3)
        .mul_add(sin_q_P3, cos_q_p3_cos_q_p1);
    let x_rod3_frame_in_rod4_frame_1_5 = x_rod2_frame_in_rod3_frame_3_5
        .mul_add(sin_q_P4, x_rod1_frame_in_rod2_frame_1_3 * cos_q_P4);
    let x_rod4_frame_in_rod5_frame_1_4 = (-x_rod2_frame_in_rod3_frame_2_5)
        .mul_add(sin_q_P5, x_rod3_frame_in_rod4_frame_1_5 * cos_q_P5);
    let x_rod4_frame_in_rod5_frame_2 = (-x_rod5_frame_2_4)
        .mul_add(cos_q_P5, x_rod3_frame_in_rod4_frame_1 * sin_q_P5);
    let x_rod5_frame_2_5 = m * x_rod4_frame_in_rod5_frame_2;
    let x_rod4_frame_in_rod5_frame_2_2 = x_rod3_frame_in_rod4_frame_1_3
        .mul_add(sin_q_P5, x_rod2_frame_in_rod3_frame_2_3 * cos_q_P5);
    let x_rod4_frame_in_rod5_frame_2_3 = (-x_rod2_frame_in_rod3_frame_2_4)
        .mul_add(cos_q_P5, x_rod3_frame_in_rod4_frame_1_4 * sin_q_P5);
    let x_rod4_frame_in_rod5_frame_2_4 = x_rod3_frame_in_rod4_frame_1_5
        .mul_add(sin_q_P5, ratio_q_P2_u_P1_of_place_13);
    let w_rod3_frame_in_rod4_frame_1_2 = w_rod2_frame_in_rod3_frame_3_2
        .mul_add(sin_q_P4, w_rod3_frame_1_2 * cos_q_P4);
    let w_rod4_frame_in_rod5_frame_1_2 = (-w_rod4_frame_2_2)
        .mul_add(sin_q_P5, w_rod3_frame_in_rod4_frame_1_2 * cos_q_P5);
    let x_rod5_frame_3_4 = x_rod3_frame_in_rod4_frame_3 + l_w_rod4_frame_2_2;
    let a_rod5_centre_3_3 = x_rod5_frame_3_4
        .mul_add(S::int(2), l * w_rod4_frame_in_rod5_frame_1_2);
    let x_rod5_frame_3_5 = m * a_rod5_centre_3_3;
    let x_rod3_frame_in_rod4_frame_3_3 = x_rod2_frame_in_rod3_frame_3_3
        .mul_add(cos_q_P4, x_rod1_frame_in_rod2_frame_1_2 * sin_q_P4);
    let x_rod3_frame_in_rod4_frame_3_4 = (-x_rod2_frame_in_rod3_frame_3_4)
        .mul_add(cos_q_P4, sin_q_p2_sin_q_p4);
    let x_rod3_frame_in_rod4_frame_3_5 = x_rod2_frame_in_rod3_frame_3_5
        .mul_add(cos_q_P4, -ratio_q_P2_u_P1_of_place_41);
    let x_rod5_frame_1_6 = x_rod1_frame_2_2 * w_rod4_frame_in_rod5_frame_1_2;
    let x_rod5_frame_in_rod4_frame_1 = l * sin_q_P5;
    let x_rod5_frame_in_rod4_frame_2 = l * cos_q_P5;
    let x_rod4_frame_in_rod3_frame_1_2 = x_rod5_frame_in_rod4_frame_1 * cos_q_P4;
    let x_rod4_frame_in_rod3_frame_3_2 = x_rod5_frame_in_rod4_frame_1 * sin_q_P4;
    let x_rod3_frame_in_rod2_frame_2_2 = (-x_rod4_frame_in_rod3_frame_3_2)
        .mul_add(sin_q_P3, x_rod5_frame_in_rod4_frame_2 * cos_q_P3);
    let x_rod3_frame_in_rod2_frame_3_2 = x_rod4_frame_in_rod3_frame_3_2
        .mul_add(cos_q_P3, x_rod5_frame_in_rod4_frame_2 * sin_q_P3);
    let x_rod2_frame_in_rod1_frame_1_2 = x_rod3_frame_in_rod2_frame_2_2
        .mul_add(sin_q_P2, x_rod4_frame_in_rod3_frame_1_2 * cos_q_P2);
    let x_rod2_frame_in_rod1_frame_2_2 = (-x_rod3_frame_in_rod2_frame_2_2)
        .mul_add(cos_q_P2, x_rod4_frame_in_rod3_frame_1_2 * sin_q_P2);
    let x_rod1_frame_in_N_3_2 = x_rod2_frame_in_rod1_frame_1_2
        .mul_add(sin_q_P1, x_rod3_frame_in_rod2_frame_3_2 * cos_q_P1);
    let x_N_in_rod1_frame_1_2 = x_rod2_frame_in_rod1_frame_2_2 * sin_q_P1;
    let x_N_in_rod1_frame_1_3 = x_rod2_frame_in_rod1_frame_2_2 * cos_q_P1;
    let x_rod1_frame_in_rod2_frame_1_4 = (-x_rod1_frame_in_N_3_2)
        .mul_add(sin_q_P2, x_N_in_rod1_frame_1_2 * cos_q_P2);
    let x_rod1_frame_in_rod2_frame_2_4 = x_N_in_rod1_frame_1_2
        .mul_add(sin_q_P2, x_rod1_frame_in_N_3_2 * cos_q_P2);
    let x_rod2_frame_in_rod3_frame_2_6 = x_rod1_frame_in_rod2_frame_2_4
        .mul_add(cos_q_P3, x_N_in_rod1_frame_1_3 * sin_q_P3);
    let x_rod2_frame_in_rod3_frame_3_6 = (-x_N_in_rod1_frame_1_3)
        .mul_add(cos_q_P3, x_rod1_frame_in_rod2_frame_2_4 * sin_q_P3);
    let x_rod3_frame_in_rod4_frame_1_6 = (-x_rod1_frame_in_rod2_frame_1_4)
        .mul_add(cos_q_P4, x_rod2_frame_in_rod3_frame_3_6 * sin_q_P4);
    let x_rod4_frame_in_rod5_frame_1_5 = x_rod3_frame_in_rod4_frame_1_6
        .mul_add(cos_q_P5, x_rod2_frame_in_rod3_frame_2_6 * sin_q_P5);
    let x_rod1_frame_in_N_1_2 = (-x_rod2_frame_in_rod1_frame_1_2)
        .mul_add(cos_q_P1, x_rod3_frame_in_rod2_frame_3_2 * sin_q_P1);
    let x_N_in_rod1_frame_1_4 = x_rod1_frame_in_N_1_2
        .mul_add(sin_q_P1, x_rod1_frame_in_N_3_2 * cos_q_P1);
    let x_N_in_rod1_frame_3_2 = (-x_rod1_frame_in_N_3_2)
        .mul_add(sin_q_P1, x_rod1_frame_in_N_1_2 * cos_q_P1);
    let x_rod1_frame_in_rod2_frame_1_5 = x_N_in_rod1_frame_1_4 * cos_q_P2;
    let x_rod1_frame_in_rod2_frame_2_5 = x_N_in_rod1_frame_1_4 * sin_q_P2;
    let x_rod2_frame_in_rod3_frame_2_7 = x_rod1_frame_in_rod2_frame_2_5
        .mul_add(cos_q_P3, x_N_in_rod1_frame_3_2 * sin_q_P3);
    let x_rod2_frame_in_rod3_frame_3_7 = (-x_N_in_rod1_frame_3_2)
        .mul_add(cos_q_P3, x_rod1_frame_in_rod2_frame_2_5 * sin_q_P3);
    let x_rod3_frame_in_rod4_frame_1_7 = (-x_rod1_frame_in_rod2_frame_1_5)
        .mul_add(cos_q_P4, x_rod2_frame_in_rod3_frame_3_7 * sin_q_P4);
    let x_rod4_frame_in_rod5_frame_1_6 = x_rod3_frame_in_rod4_frame_1_7
        .mul_add(cos_q_P5, x_rod2_frame_in_rod3_frame_2_7 * sin_q_P5);
    let x_rod1_frame_in_rod2_frame_1_6 = x_rod1_frame_in_N_1_2
        .mul_add(sin_q_P2, x_N_in_rod1_frame_1_3 * cos_q_P2);
    let x_rod1_frame_in_rod2_frame_2_6 = (-x_rod1_frame_in_N_1_2)
        .mul_add(cos_q_P2, x_N_in_rod1_frame_1_3 * sin_q_P2);
    let x_rod2_frame_in_rod3_frame_2_8 = (-x_N_in_rod1_frame_1_2)
        .mul_add(sin_q_P3, x_rod1_frame_in_rod2_frame_2_6 * cos_q_P3);
    let x_rod2_frame_in_rod3_frame_3_8 = x_rod1_frame_in_rod2_frame_2_6
        .mul_add(sin_q_P3, x_N_in_rod1_frame_1_2 * cos_q_P3);
    let x_rod3_frame_in_rod4_frame_1_8 = (-x_rod1_frame_in_rod2_frame_1_6)
        .mul_add(cos_q_P4, x_rod2_frame_in_rod3_frame_3_8 * sin_q_P4);
    let x_rod4_frame_in_rod5_frame_1_7 = x_rod3_frame_in_rod4_frame_1_8
        .mul_add(cos_q_P5, x_rod2_frame_in_rod3_frame_2_8 * sin_q_P5);
    let x_N_2 = ratio_q_P2_u_P1_of_place_44;
    let x_N_in_rod1_frame_1_5 = x_N_in_rod1_frame_3_3_of_place_2 * cos_q_P1;
    let x_rod1_frame_in_rod2_frame_1_7 = x_N_in_rod1_frame_1_5
        .mul_add(cos_q_P2, x_N_2 * sin_q_P2);
    let x_rod1_frame_in_rod2_frame_2_7 = (-x_N_2)
        .mul_add(cos_q_P2, x_N_in_rod1_frame_1_5 * sin_q_P2);
    let x_rod2_frame_in_rod3_frame_2_9 = (-x_N_in_rod1_frame_3_3)
        .mul_add(sin_q_P3, x_rod1_frame_in_rod2_frame_2_7 * cos_q_P3);
    let x_rod2_frame_in_rod3_frame_3_9 = x_rod1_frame_in_rod2_frame_2_7
        .mul_add(sin_q_P3, x_N_in_rod1_frame_3_3 * cos_q_P3);
    let x_rod3_frame_in_rod4_frame_1_9 = (-x_rod1_frame_in_rod2_frame_1_7)
        .mul_add(cos_q_P4, x_rod2_frame_in_rod3_frame_3_9 * sin_q_P4);
    let x_rod4_frame_in_rod5_frame_1_8 = x_rod3_frame_in_rod4_frame_1_9
        .mul_add(cos_q_P5, x_rod2_frame_in_rod3_frame_2_9 * sin_q_P5);
    let x_rod4_frame_in_rod5_frame_1_9 = x_rod5_frame_in_rod4_frame_2
        .mul_add(cos_q_P5, x_rod5_frame_in_rod4_frame_1 * sin_q_P5);
    let x_rod4_frame_in_rod5_frame_2_5 = (-x_rod2_frame_in_rod3_frame_2_6)
        .mul_add(cos_q_P5, x_rod3_frame_in_rod4_frame_1_6 * sin_q_P5);
    let x_rod4_frame_in_rod5_frame_2_6 = (-x_rod2_frame_in_rod3_frame_2_7)
        .mul_add(cos_q_P5, x_rod3_frame_in_rod4_frame_1_7 * sin_q_P5);
    let x_rod4_frame_in_rod5_frame_2_7 = (-x_rod2_frame_in_rod3_frame_2_8)
        .mul_add(cos_q_P5, x_rod3_frame_in_rod4_frame_1_8 * sin_q_P5);
    let x_rod4_frame_in_rod5_frame_2_8 = (-x_rod2_frame_in_rod3_frame_2_9)
        .mul_add(cos_q_P5, x_rod3_frame_in_rod4_frame_1_9 * sin_q_P5);
    let x_rod4_frame_in_rod5_frame_2_9 = (-x_rod5_frame_in_rod4_frame_1)
        .mul_add(cos_q_P5, x_rod5_frame_in_rod4_frame_2 * sin_q_P5);
    let x_rod5_frame_3_6 = x_rod1_frame_2_2 * w_rod5_frame_3_2;
    let x_rod3_frame_in_rod4_frame_3_6 = x_rod2_frame_in_rod3_frame_3_6
        .mul_add(cos_q_P4, x_rod1_frame_in_rod2_frame_1_4 * sin_q_P4);
    let x_rod3_frame_in_rod4_frame_3_7 = x_rod2_frame_in_rod3_frame_3_7
        .mul_add(cos_q_P4, x_rod1_frame_in_rod2_frame_1_5 * sin_q_P4);
    let x_rod3_frame_in_rod4_frame_3_8 = x_rod2_frame_in_rod3_frame_3_8
        .mul_add(cos_q_P4, x_rod1_frame_in_rod2_frame_1_6 * sin_q_P4);
    let x_rod3_frame_in_rod4_frame_3_9 = x_rod2_frame_in_rod3_frame_3_9
        .mul_add(cos_q_P4, x_rod1_frame_in_rod2_frame_1_7 * sin_q_P4);
    let l_halved = S::ratio(1, 2) * l;
    let minus_sin_q_p2 = -sin_q_P2;
    let minus_sin_q_p3 = -sin_q_P3;
    let minus_sin_q_p4 = -sin_q_P4;
    let minus_sin_q_p5 = -sin_q_P5;
    let minus_sin_q_p1 = -sin_q_P1;
    let minus_cos_q_p3 = -cos_q_P3;
    let minus_cos_q_p5 = -cos_q_P5;
    let minus_cos_q_p1 = -cos_q_P1;
    let minus_cos_q_p2 = -cos_q_P2;
    let minus_cos_q_p4 = -cos_q_P4;
    let minus_l_halved = -l_halved;
    // Entries that are not zero.
    let m_1_21 = S::int(1);
    let m_1_26 = minus_cos_q_p1;
    let m_1_28 = sin_q_P1;
    let m_2_22 = S::int(1);
    let m_2_27 = -S::int(1);
    let m_3_1 = -S::ratio(1, 2) * x_rod1_frame_3;
    let m_3_23 = S::int(1);
    let m_3_26 = minus_sin_q_p1;
    let m_3_28 = minus_cos_q_p1;
    let m_4_24 = S::int(1);
    let m_4_27 = -S::ratio(1, 2) * x_N_in_rod1_frame_1;
    let m_4_29 = minus_cos_q_p1;
    let m_4_30 = sin_q_P1;
    let m_5_1 = S::ratio(1, 12) * x_rod1_frame_2_2;
    let m_5_23 = minus_l_halved;
    let m_5_25 = S::int(1);
    let m_5_26 = -S::ratio(1, 2) * x_rod1_frame_in_N_3;
    let m_5_28 = -S::ratio(1, 2) * x_rod1_frame_in_N_1;
    let m_6_22 = l_halved;
    let m_6_27 = S::ratio(1, 2) * x_N_in_rod1_frame_3;
    let m_6_29 = minus_sin_q_p1;
    let m_6_30 = minus_cos_q_p1;
    let m_7_1 = -S::ratio(1, 2) * x_rod2_frame_1_3;
    let m_7_16 = S::int(1);
    let m_7_21 = minus_cos_q_p2;
    let m_7_22 = minus_sin_q_p2;
    let m_8_17 = S::int(1);
    let m_8_21 = sin_q_P2;
    let m_8_22 = minus_cos_q_p2;
    let m_9_1 = -S::ratio(1, 2) * x_rod2_frame_3_3;
    let m_9_18 = S::int(1);
    let m_9_23 = -S::int(1);
    let m_10_1 = S::ratio(1, 12) * x_rod2_frame_1_4;
    let m_10_18 = l_halved;
    let m_10_23 = S::ratio(1, 2) * x_rod1_frame_in_rod2_frame_1;
    let m_10_24 = minus_cos_q_p2;
    let m_10_25 = minus_sin_q_p2;
    let m_11_19 = S::int(1);
    let m_11_23 = -S::ratio(1, 2) * x_rod1_frame_in_rod2_frame_2;
    let m_11_24 = sin_q_P2;
    let m_11_25 = minus_cos_q_p2;
    let m_12_1 = S::ratio(1, 12) * x_rod2_frame_3_4;
    let m_12_16 = minus_l_halved;
    let m_12_20 = S::int(1);
    let m_12_21 = -S::ratio(1, 2) * x_rod2_frame_in_rod1_frame_2;
    let m_12_22 = -S::ratio(1, 2) * x_rod2_frame_in_rod1_frame_1;
    let m_13_1 = S::ratio(1, 2) * x_rod3_frame_1_3;
    let m_13_11 = S::int(1);
    let m_13_16 = -S::int(1);
    let m_14_1 = -S::ratio(1, 2) * x_rod3_frame_2_3;
    let m_14_12 = S::int(1);
    let m_14_17 = minus_cos_q_p3;
    let m_14_18 = minus_sin_q_p3;
    let m_15_1 = -x_rod3_frame_3_3;
    let m_15_13 = S::int(1);
    let m_15_17 = sin_q_P3;
    let m_15_18 = minus_cos_q_p3;
    let m_16_1 = S::ratio(1, 12) * x_rod3_frame_1_4;
    let m_16_12 = minus_l_halved;
    let m_16_14 = S::int(1);
    let m_16_17 = -S::ratio(1, 2) * x_rod3_frame_in_rod2_frame_3;
    let m_16_18 = -S::ratio(1, 2) * x_rod3_frame_in_rod2_frame_2;
    let m_17_1 = S::ratio(1, 12) * x_rod3_frame_2_4;
    let m_17_11 = l_halved;
    let m_17_16 = S::ratio(1, 2) * x_rod2_frame_in_rod3_frame_2_2;
    let m_17_19 = minus_cos_q_p3;
    let m_17_20 = minus_sin_q_p3;
    let m_18_15 = S::int(1);
    let m_18_16 = -S::ratio(1, 2) * x_rod2_frame_in_rod3_frame_3_2;
    let m_18_19 = sin_q_P3;
    let m_18_20 = minus_cos_q_p3;
    let m_19_6 = S::int(1);
    let m_19_11 = minus_cos_q_p4;
    let m_19_13 = sin_q_P4;
    let m_20_1 = S::ratio(1, 2) * x_rod4_frame_2_3;
    let m_20_7 = S::int(1);
    let m_20_12 = -S::int(1);
    let m_21_1 = -S::ratio(1, 2) * x_rod4_frame_3_3;
    let m_21_8 = S::int(1);
    let m_21_11 = minus_sin_q_p4;
    let m_21_13 = minus_cos_q_p4;
    let m_22_9 = S::int(1);
    let m_22_12 = S::ratio(1, 2) * x_rod3_frame_in_rod4_frame_1_2;
    let m_22_14 = minus_cos_q_p4;
    let m_22_15 = sin_q_P4;
    let m_23_1 = -S::ratio(1, 12) * x_rod4_frame_2_4;
    let m_23_8 = l_halved;
    let m_23_10 = S::int(1);
    let m_23_11 = S::ratio(1, 2) * x_rod4_frame_in_rod3_frame_3;
    let m_23_13 = S::ratio(1, 2) * x_rod4_frame_in_rod3_frame_1;
    let m_24_1 = -S::ratio(1, 12) * x_rod4_frame_3_4;
    let m_24_7 = minus_l_halved;
    let m_24_12 = -S::ratio(1, 2) * x_rod3_frame_in_rod4_frame_3_2;
    let m_24_14 = minus_sin_q_p4;
    let m_24_15 = minus_cos_q_p4;
    let m_25_1 = -S::ratio(1, 2) * x_rod5_frame_1_5;
    let m_25_3 = -x_rod4_frame_in_rod5_frame_1_3;
    let m_25_6 = minus_cos_q_p5;
    let m_25_7 = minus_sin_q_p5;
    let m_26_1 = -x_rod5_frame_2_5;
    let m_26_2 = -x_rod4_frame_in_rod5_frame_2_2;
    let m_26_4 = -x_rod4_frame_in_rod5_frame_2_4;
    let m_26_6 = sin_q_P5;
    let m_26_7 = minus_cos_q_p5;
    let m_27_1 = -S::ratio(1, 2) * x_rod5_frame_3_5;
    let m_27_2 = -x_rod3_frame_in_rod4_frame_3_3;
    let m_27_3 = -x_rod3_frame_in_rod4_frame_3_4;
    let m_27_4 = -x_rod3_frame_in_rod4_frame_3_5;
    let m_27_8 = -S::int(1);
    let m_28_1 = S::ratio(1, 12) * x_rod5_frame_1_6;
    let m_28_2 = S::ratio(1, 2) * x_rod4_frame_in_rod5_frame_1_5;
    let m_28_3 = S::ratio(1, 2) * x_rod4_frame_in_rod5_frame_1_6;
    let m_28_4 = S::ratio(1, 2) * x_rod4_frame_in_rod5_frame_1_7;
    let m_28_8 = -S::ratio(1, 2) * x_rod4_frame_in_rod5_frame_1_9;
    let m_28_9 = minus_cos_q_p5;
    let m_28_10 = minus_sin_q_p5;
    let m_29_2 = -S::ratio(1, 2) * x_rod4_frame_in_rod5_frame_2_5;
    let m_29_3 = -S::ratio(1, 2) * x_rod4_frame_in_rod5_frame_2_6;
    let m_29_4 = -S::ratio(1, 2) * x_rod4_frame_in_rod5_frame_2_7;
    let m_29_5 = -x_rod4_frame_in_rod5_frame_2_8;
    let m_29_8 = S::ratio(1, 2) * x_rod4_frame_in_rod5_frame_2_9;
    let m_29_9 = sin_q_P5;
    let m_29_10 = minus_cos_q_p5;
    let m_30_1 = -S::ratio(1, 12) * x_rod5_frame_3_6;
    let m_30_2 = -S::ratio(1, 2) * x_rod3_frame_in_rod4_frame_3_6;
    let m_30_3 = -S::ratio(1, 2) * x_rod3_frame_in_rod4_frame_3_7;
    let m_30_4 = -S::ratio(1, 2) * x_rod3_frame_in_rod4_frame_3_8;
    let m_30_5 = -x_rod3_frame_in_rod4_frame_3_9;
    let m_30_6 = S::ratio(1, 2) * x_rod5_frame_in_rod4_frame_2;
    let m_30_7 = S::ratio(1, 2) * x_rod5_frame_in_rod4_frame_1;
    let zero = S::int(0);
    [
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, m_1_21, zero, zero, zero, zero, m_1_26, zero,
            m_1_28, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, m_2_22, zero, zero, zero, zero, m_2_27, zero,
            zero, zero,
        ],
        [
            m_3_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, m_3_23, zero, zero, m_3_26, zero,
            m_3_28, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, m_4_24, zero, zero, m_4_27, zero,
            m_4_29, m_4_30,
        ],
        [
            m_5_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, m_5_23, zero, m_5_25, m_5_26, zero,
            m_5_28, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, m_6_22, zero, zero, zero, zero, m_6_27, zero,
            m_6_29, m_6_30,
        ],
        [
            m_7_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, m_7_16, zero, zero, zero, zero, m_7_21, m_7_22, zero, zero, zero, zero, zero,
            zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, m_8_17, zero, zero, zero, m_8_21, m_8_22, zero, zero, zero, zero, zero,
            zero, zero, zero,
        ],
        [
            m_9_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, m_9_18, zero, zero, zero, zero, m_9_23, zero, zero, zero, zero, zero,
            zero, zero,
        ],
        [
            m_10_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, m_10_18, zero, zero, zero, zero, m_10_23, m_10_24, m_10_25, zero,
            zero, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, m_11_19, zero, zero, zero, m_11_23, m_11_24, m_11_25, zero,
            zero, zero, zero, zero,
        ],
        [
            m_12_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, m_12_16, zero, zero, zero, m_12_20, m_12_21, m_12_22, zero, zero, zero, zero,
            zero, zero, zero, zero,
        ],
        [
            m_13_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_13_11, zero, zero, zero,
            zero, m_13_16, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero,
        ],
        [
            m_14_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_14_12, zero, zero,
            zero, zero, m_14_17, m_14_18, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero,
        ],
        [
            m_15_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_15_13, zero,
            zero, zero, m_15_17, m_15_18, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero,
        ],
        [
            m_16_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_16_12, zero,
            m_16_14, zero, zero, m_16_17, m_16_18, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero,
        ],
        [
            m_17_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_17_11, zero, zero, zero,
            zero, m_17_16, zero, zero, m_17_19, m_17_20, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            m_18_15, m_18_16, zero, zero, m_18_19, m_18_20, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero,
        ],
        [
            x_rod4_frame_1_3, zero, zero, zero, zero, m_19_6, zero, zero, zero, zero, m_19_11, zero,
            m_19_13, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero,
        ],
        [
            m_20_1, zero, zero, zero, zero, zero, m_20_7, zero, zero, zero, zero, m_20_12, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero,
        ],
        [
            m_21_1, zero, zero, zero, zero, zero, zero, m_21_8, zero, zero, m_21_11, zero, m_21_13,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, m_22_9, zero, zero, m_22_12, zero,
            m_22_14, m_22_15, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero,
        ],
        [
            m_23_1, zero, zero, zero, zero, zero, zero, m_23_8, zero, m_23_10, m_23_11, zero,
            m_23_13, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero,
        ],
        [
            m_24_1, zero, zero, zero, zero, zero, m_24_7, zero, zero, zero, zero, m_24_12, zero,
            m_24_14, m_24_15, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero,
        ],
        [
            m_25_1, x_rod4_frame_in_rod5_frame_1_2, m_25_3, x_rod4_frame_in_rod5_frame_1_4, zero,
            m_25_6, m_25_7, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_26_1, m_26_2, x_rod4_frame_in_rod5_frame_2_3, m_26_4, zero, m_26_6, m_26_7, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_27_1, m_27_2, m_27_3, m_27_4, zero, zero, zero, m_27_8, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero,
        ],
        [
            m_28_1, m_28_2, m_28_3, m_28_4, x_rod4_frame_in_rod5_frame_1_8, zero, zero, m_28_8,
            m_28_9, m_28_10, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            zero, m_29_2, m_29_3, m_29_4, m_29_5, zero, zero, m_29_8, m_29_9, m_29_10, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero,
        ],
        [
            m_30_1, m_30_2, m_30_3, m_30_4, m_30_5, m_30_6, m_30_7, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero,
        ],
    ]
}

/// Right-hand side of the linear system; unknowns (u_P1', P6_force1, P6_force2, P6_force3, P6_torque13, rod5_force_rod4_frame1, rod5_force_rod4_frame2, rod5_force_rod4_frame3, rod5_torque_rod4_frame1, rod5_torque_rod4_frame2, rod4_force_rod3_frame1, rod4_force_rod3_frame2, rod4_force_rod3_frame3, rod4_torque_rod3_frame1, rod4_torque_rod3_frame3, rod3_force_rod2_frame1, rod3_force_rod2_frame2, rod3_force_rod2_frame3, rod3_torque_rod2_frame2, rod3_torque_rod2_frame3, rod2_force_rod1_frame1, rod2_force_rod1_frame2, rod2_force_rod1_frame3, rod2_torque_rod1_frame1, rod2_torque_rod1_frame2, rod1_force_n1, rod1_force_n2, rod1_force_n3, rod1_torque_n1, rod1_torque_n3).
///
/// 1481 operations, 5 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 1]) -> [S; 30] {
    let Parameters { l, m, g } = *p;
    let [q_P1, q_P2, q_P3, q_P4, q_P5] = *q;
    let [u_P1] = *u;
    // Sines and cosines.
    let (sin_q_P5, cos_q_P5) = q_P5.sin_cos();
    let (sin_q_P4, cos_q_P4) = q_P4.sin_cos();
    let (sin_q_P2, cos_q_P2) = q_P2.sin_cos();
    let (sin_q_P3, cos_q_P3) = q_P3.sin_cos();
    let (sin_q_P1, cos_q_P1) = q_P1.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_rod1_frame_22 = u_P1 * u_P1;
    let a_rod1_centre_1 = l * w_rod1_frame_22;
    let x_rod1_frame_1 = m * a_rod1_centre_1;
    let x_rod1_frame_2 = m * g;
    let ratio_q_P2_u_P1_of_q_p5 = S::int(1) - sin_q_P5;
    let ratio_q_P2_u_P1_of_q_p5_2 = -ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5 = ratio_q_P2_u_P1_of_q_p5_2 * sin_q_P4;
    let cos_q_p2_cos_q_p4 = cos_q_P2 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p3_q_p5 = ratio_q_P2_u_P1_of_q_p5_2 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place = (-ratio_q_P2_u_P1_of_q_p4_q_p5)
        .mul_add(sin_q_P2, cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p3_q_p5);
    let sin_q_p3_cos_q_p1 = cos_q_P1 * sin_q_P3;
    let sin_q_p2_sin_q_p1 = sin_q_P1 * sin_q_P2;
    let ratio_q_P2_u_P1_of_place_2 = sin_q_p2_sin_q_p1
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p1);
    let sin_q_p2_sin_q_p3 = sin_q_P2 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_3 = sin_q_p2_sin_q_p3
        .mul_add(sin_q_P4, -cos_q_p2_cos_q_p4);
    let cos_q_p3_cos_q_p1 = cos_q_P1 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_4 = (-ratio_q_P2_u_P1_of_place_3)
        .mul_add(sin_q_P1, cos_q_p3_cos_q_p1 * sin_q_P4);
    let ratio_q_P2_u_P1_of_place_5 = l
        * ratio_q_P2_u_P1_of_place_4
            .mul_add(sin_q_P5, ratio_q_P2_u_P1_of_place_2 * cos_q_P5);
    let sin_q_p3_cos_q_p5 = sin_q_P3 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_6 = sin_q_p3_cos_q_p5
        .mul_add(sin_q_P4, cos_q_P3 * sin_q_P5);
    let sin_q_p2_cos_q_p4 = sin_q_P2 * cos_q_P4;
    let ratio_q_P2_u_P1_of_place_7 = sin_q_p2_cos_q_p4
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_6 * cos_q_P2);
    let ratio_q_P2_u_P1_of_place_8 = l * ratio_q_P2_u_P1_of_place_7;
    let cos_q_p2_sin_q_p4 = cos_q_P2 * sin_q_P4;
    let ratio_q_P2_u_P1_of_place_9 = sin_q_p2_cos_q_p4
        .mul_add(sin_q_P3, cos_q_p2_sin_q_p4);
    let ratio_q_P2_u_P1_of_place_10 = cos_q_p3_cos_q_p1 * cos_q_P4;
    let ratio_q_P2_u_P1_of_place_11 = (-ratio_q_P2_u_P1_of_place_9)
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_10);
    let ratio_q_P2_u_P1_of_place_12 = ratio_q_P2_u_P1_of_place_11 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_13 = ratio_q_P2_u_P1_of_place_8
        .mul_add(
            ratio_q_P2_u_P1_of_place_12,
            ratio_q_P2_u_P1_of_place * ratio_q_P2_u_P1_of_place_5,
        );
    let cos_q_p3_cos_q_p5 = cos_q_P3 * cos_q_P5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_2 = ratio_q_P2_u_P1_of_q_p4_q_p5 - S::int(1);
    let ratio_q_P2_u_P1_of_place_14 = ratio_q_P2_u_P1_of_q_p4_q_p5_2 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_15 = cos_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_place_14;
    let ratio_q_P2_u_P1_of_place_16 = ratio_q_P2_u_P1_of_q_p4_q_p5_2
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p5);
    let ratio_q_P2_u_P1_of_place_17 = ratio_q_P2_u_P1_of_place_16 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_18 = l
        * ratio_q_P2_u_P1_of_place_17
            .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_place_15 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_19 = (-sin_q_P3)
        .mul_add(sin_q_P5, cos_q_p3_cos_q_p5 * sin_q_P4);
    let ratio_q_P2_u_P1_of_place_20 = sin_q_p2_sin_q_p1
        .mul_add(ratio_q_P2_u_P1_of_place_19, ratio_q_P2_u_P1_of_place_6 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_21 = ratio_q_P2_u_P1_of_place_16 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_22 = (-ratio_q_P2_u_P1_of_place_8)
        .mul_add(
            ratio_q_P2_u_P1_of_place_20,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_21,
        );
    let ratio_q_P2_u_P1_of_place_23 = ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_24 = ratio_q_P2_u_P1_of_q_p3_q_p5
        .mul_add(sin_q_p2_cos_q_p4, ratio_q_P2_u_P1_of_place_23);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_2 = ratio_q_P2_u_P1_of_q_p5_2 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_25 = l
        * (ratio_q_P2_u_P1_of_q_p3_q_p5_2 * sin_q_P1)
            .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_24 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_26 = l * ratio_q_P2_u_P1_of_place_12;
    let ratio_q_P2_u_P1_of_place_27 = l * ratio_q_P2_u_P1_of_place;
    let ratio_q_P2_u_P1_of_place_28 = ratio_q_P2_u_P1_of_place_20
        .mul_add(
            ratio_q_P2_u_P1_of_place_27,
            ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_of_place_26,
        );
    let ratio_q_P2_u_P1_of_place_29 = (-ratio_q_P2_u_P1_of_place_6)
        .mul_add(sin_q_P2, cos_q_p2_cos_q_p4 * cos_q_P5);
    let ratio_q_P2_u_P1_of_place_30 = l
        * (-ratio_q_P2_u_P1_of_place_29)
            .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_19 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_31 = (-ratio_q_P2_u_P1_of_place_22)
        .mul_add(
            ratio_q_P2_u_P1_of_place_25,
            ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_of_place_18,
        ) - ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_of_place_30;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_3 = S::int(1) - cos_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_32 = -ratio_q_P2_u_P1_of_place_14 - ratio_q_P2_u_P1_of_q_p3_q_p5_3;
    let ratio_q_P2_u_P1_of_place_33 = ratio_q_P2_u_P1_of_place_32
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p2_cos_q_p4);
    let ratio_q_P2_u_P1_of_place_34 = S::int(1) + ratio_q_P2_u_P1_of_place_33;
    let ratio_q_P2_u_P1_of_place_35 = (-ratio_q_P2_u_P1_of_place_16)
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_34 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_36 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_of_place_10, ratio_q_P2_u_P1_of_place_24 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_37 = ratio_q_P2_u_P1_of_place_29
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_19 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_38 = (-ratio_q_P2_u_P1_of_place_26)
        .mul_add(
            ratio_q_P2_u_P1_of_place_37,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_36,
        );
    let ratio_q_P2_u_P1_of_place_39 = l * ratio_q_P2_u_P1_of_place_33;
    let ratio_q_P2_u_P1_of_place_40 = ratio_q_P2_u_P1_of_q_p5_2 * sin_q_p2_cos_q_p4;
    let ratio_q_P2_u_P1_of_place_41 = ratio_q_P2_u_P1_of_place_32
        .mul_add(cos_q_P2, -ratio_q_P2_u_P1_of_place_40);
    let ratio_q_P2_u_P1_of_place_42 = ratio_q_P2_u_P1_of_place_8 * sin_q_P1;
    let ratio_q_P2_u_P1_of_place_43 = (-ratio_q_P2_u_P1_of_place_37)
        .mul_add(
            ratio_q_P2_u_P1_of_place_42,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_41 * sin_q_P1,
        );
    let cos_q_p2_sin_q_p1 = sin_q_P1 * cos_q_P2;
    let ratio_q_P2_u_P1_of_q_p3 = sin_q_P3 - S::int(1);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_4 = (-ratio_q_P2_u_P1_of_q_p3)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_q_p3_q_p5_2);
    let ratio_q_P2_u_P1_of_place_44 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_q_p3_q_p5 * sin_q_p2_sin_q_p1);
    let ratio_q_P2_u_P1_of_place_45 = ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_p2_sin_q_p1;
    let ratio_q_P2_u_P1_of_place_46 = ratio_q_P2_u_P1_of_place_44
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_45);
    let ratio_q_P2_u_P1_of_place_47 = sin_q_p2_cos_q_p4
        .mul_add(ratio_q_P2_u_P1_of_q_p3, cos_q_p2_sin_q_p4);
    let ratio_q_P2_u_P1_of_place_48 = (-ratio_q_P2_u_P1_of_place_47)
        .mul_add(sin_q_P3, cos_q_p2_sin_q_p4);
    let cos_q_p5_sin_q_p1 = sin_q_P1 * cos_q_P5;
    let l_sq = l * l;
    let ratio_q_P2_u_P1_of_place_49 = l_sq
        * ratio_q_P2_u_P1_of_place_48
            .mul_add(cos_q_p5_sin_q_p1, ratio_q_P2_u_P1_of_place_46 * cos_q_P3);
    let ratio_q_P2_u_P1_of_place_50 = cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_of_place_49;
    let ratio_q_P2_u_P1_of_place_51 = ratio_q_P2_u_P1_of_place_27
        .mul_add(
            ratio_q_P2_u_P1_of_place_43,
            ratio_q_P2_u_P1_of_place_38 * ratio_q_P2_u_P1_of_place_39,
        ) + ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_50;
    let ratio_q_P2_u_P1_of_q_p4 = S::int(1) + sin_q_P4;
    let cos_q_p4_sq = cos_q_P4 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_2 = ratio_q_P2_u_P1_of_q_p4 - cos_q_p4_sq;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_3 = ratio_q_P2_u_P1_of_q_p4_2
        .mul_add(sin_q_P5, cos_q_p4_sq);
    let ratio_q_P2_u_P1_of_place_52 = ratio_q_P2_u_P1_of_q_p4_q_p5_3 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_53 = (-cos_q_p3_cos_q_p5)
        .mul_add(ratio_q_P2_u_P1_of_q_p4, ratio_q_P2_u_P1_of_place_52);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_4 = sin_q_P5 + ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_place_54 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p4_q_p5_4;
    let ratio_q_P2_u_P1_of_place_55 = ratio_q_P2_u_P1_of_place_53
        .mul_add(sin_q_P2, -ratio_q_P2_u_P1_of_place_54);
    let ratio_q_P2_u_P1_of_place_56 = ratio_q_P2_u_P1_of_q_p4_q_p5_3 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_57 = sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_of_q_p4;
    let ratio_q_P2_u_P1_of_place_58 = ratio_q_P2_u_P1_of_place_57
        .mul_add(S::int(2), ratio_q_P2_u_P1_of_place_56);
    let ratio_q_P2_u_P1_of_place_59 = (-ratio_q_P2_u_P1_of_place_58)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_55 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_60 = ratio_q_P2_u_P1_of_place_59
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_of_place_52);
    let ratio_q_P2_u_P1_of_place_61 = (-sin_q_p3_cos_q_p1)
        .mul_add(ratio_q_P2_u_P1_of_place_54, ratio_q_P2_u_P1_of_place_60 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_62 = ratio_q_P2_u_P1_of_place_56 + ratio_q_P2_u_P1_of_place_57;
    let ratio_q_P2_u_P1_of_place_63 = ratio_q_P2_u_P1_of_place_62 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_64 = (-sin_q_p3_cos_q_p1)
        .mul_add(ratio_q_P2_u_P1_of_place_63, ratio_q_P2_u_P1_of_place_61 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_65 = ratio_q_P2_u_P1_of_place_33 * l_sq;
    let ratio_q_P2_u_P1_of_place_66 = l * ratio_q_P2_u_P1_of_place_21;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_5 = cos_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_place_67 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_5)
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_q_p3 * sin_q_P5);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_6 = ratio_q_P2_u_P1_of_q_p3_q_p5 + cos_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_68 = (-sin_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_of_q_p3_q_p5_6, ratio_q_P2_u_P1_of_place_67 * cos_q_P2);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_7 = sin_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_2;
    let ratio_q_P2_u_P1_of_place_69 = ratio_q_P2_u_P1_of_q_p3_q_p5_7 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_70 = (-ratio_q_P2_u_P1_of_place_69)
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_68 * sin_q_P1);
    let cos_q_p2_cos_q_p1 = cos_q_P1 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_71 = (-ratio_q_P2_u_P1_of_place_6)
        .mul_add(cos_q_p2_cos_q_p1, ratio_q_P2_u_P1_of_place_70 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_72 = l_sq * ratio_q_P2_u_P1_of_place_71 * sin_q_P1;
    let ratio_q_P2_u_P1_of_place_73 = ratio_q_P2_u_P1_of_place_43
        .mul_add(
            ratio_q_P2_u_P1_of_place_66,
            ratio_q_P2_u_P1_of_place_64 * ratio_q_P2_u_P1_of_place_65,
        ) - ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_72;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_8 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_2)
        .mul_add(S::int(2), sin_q_p3_cos_q_p5);
    let ratio_q_P2_u_P1_of_place_74 = ratio_q_P2_u_P1_of_q_p3_q_p5_8
        .mul_add(cos_q_P1, sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_of_q_p3_q_p5_6);
    let ratio_q_P2_u_P1_of_place_75 = ratio_q_P2_u_P1_of_place_74
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_45);
    let ratio_q_P2_u_P1_of_place_76 = (-cos_q_p2_sin_q_p1)
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_place_10);
    let ratio_q_P2_u_P1_of_place_77 = (-cos_q_p3_cos_q_p5)
        .mul_add(ratio_q_P2_u_P1_of_place_76, ratio_q_P2_u_P1_of_place_75 * sin_q_P3);
    let ratio_q_P2_u_P1_of_place_78 = ratio_q_P2_u_P1_of_place_77
        .mul_add(sin_q_P2, cos_q_p2_sin_q_p4 * ratio_q_P2_u_P1_of_place_69);
    let ratio_q_P2_u_P1_of_place_79 = (-ratio_q_P2_u_P1_of_place_10)
        .mul_add(ratio_q_P2_u_P1_of_place_69, ratio_q_P2_u_P1_of_place_78 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_80 = ratio_q_P2_u_P1_of_place
        .mul_add(
            ratio_q_P2_u_P1_of_place_72,
            ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_of_place_50,
        ) + ratio_q_P2_u_P1_of_place_65 * ratio_q_P2_u_P1_of_place_79;
    let ratio_q_P2_u_P1_of_place_81 = l * ratio_q_P2_u_P1_of_place_41;
    let ratio_q_P2_u_P1_of_place_82 = ratio_q_P2_u_P1_of_place_81 * cos_q_P1;
    let cos_q_p5_sq = cos_q_P5 * cos_q_P5;
    let ratio_q_P2_u_P1_of_q_p5_3 = ratio_q_P2_u_P1_of_q_p5
        .mul_add(S::int(2), -cos_q_p5_sq);
    let ratio_q_P2_u_P1_of_q_p5_4 = -ratio_q_P2_u_P1_of_q_p5_3;
    let cos_q_p4_sq_doubled = S::int(2) * cos_q_p4_sq;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_5 = ratio_q_P2_u_P1_of_q_p5_4 * cos_q_p4_sq_doubled;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_6 = -ratio_q_P2_u_P1_of_q_p5 - ratio_q_P2_u_P1_of_q_p4_q_p5_5;
    let ratio_q_P2_u_P1_of_q_p5_5 = ratio_q_P2_u_P1_of_q_p5 - cos_q_p5_sq;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_7 = cos_q_p4_sq * ratio_q_P2_u_P1_of_q_p5_4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_8 = -ratio_q_P2_u_P1_of_q_p5_5
        - ratio_q_P2_u_P1_of_q_p4_q_p5_7;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_9 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(cos_q_p4_sq, ratio_q_P2_u_P1_of_q_p4_q_p5_8 * sin_q_P4);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_10 = ratio_q_P2_u_P1_of_q_p4_q_p5_9
        - ratio_q_P2_u_P1_of_q_p5_5;
    let ratio_q_P2_u_P1_of_q_p4_3 = ratio_q_P2_u_P1_of_q_p4 - cos_q_p4_sq_doubled;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_11 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_of_q_p4_3;
    let ratio_q_P2_u_P1_of_place_83 = sin_q_p3_cos_q_p5
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_11,
            ratio_q_P2_u_P1_of_q_p4_q_p5_10 * cos_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_84 = ratio_q_P2_u_P1_of_place_83 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_85 = ratio_q_P2_u_P1_of_q_p4_q_p5_6
        .mul_add(sin_q_P4, -ratio_q_P2_u_P1_of_q_p5)
        - ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p4_sq_doubled - ratio_q_P2_u_P1_of_place_84;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_12 = S::int(2) * ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_13 = (-ratio_q_P2_u_P1_of_q_p5)
        .mul_add(S::int(3), cos_q_p5_sq) - ratio_q_P2_u_P1_of_q_p4_q_p5_5
        + ratio_q_P2_u_P1_of_q_p4_q_p5_12;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_14 = ratio_q_P2_u_P1_of_q_p4_q_p5_12 - ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_place_86 = cos_q_p3_cos_q_p5
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_14,
            ratio_q_P2_u_P1_of_q_p4_q_p5_13 * sin_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_87 = sin_q_p2_cos_q_p4
        .mul_add(ratio_q_P2_u_P1_of_place_86, ratio_q_P2_u_P1_of_place_85 * cos_q_P2);
    let ratio_q_P2_u_P1_of_place_88 = (-ratio_q_P2_u_P1_of_place_84)
        .mul_add(S::int(2), ratio_q_P2_u_P1_of_q_p4_q_p5_10)
        - ratio_q_P2_u_P1_of_place_87 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_89 = (-cos_q_p3_cos_q_p5)
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_11,
            ratio_q_P2_u_P1_of_q_p4_q_p5_10 * sin_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_90 = ratio_q_P2_u_P1_of_place_89 * sin_q_P2;
    let ratio_q_P2_u_P1_of_place_91 = (-cos_q_p2_cos_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_13,
            S::int(2) * ratio_q_P2_u_P1_of_place_90,
        );
    let ratio_q_P2_u_P1_of_place_92 = cos_q_p2_cos_q_p4 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_93 = ratio_q_P2_u_P1_of_q_p4_q_p5_14
        .mul_add(
            ratio_q_P2_u_P1_of_place_92,
            ratio_q_P2_u_P1_of_q_p4_q_p5_11 * sin_q_P2,
        );
    let ratio_q_P2_u_P1_of_place_94 = ratio_q_P2_u_P1_of_place_93
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_91 * cos_q_P3);
    let ratio_q_P2_u_P1_of_place_95 = (-ratio_q_P2_u_P1_of_place_94)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_88 * sin_q_P1);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_15 = ratio_q_P2_u_P1_of_q_p4_q_p5
        - ratio_q_P2_u_P1_of_q_p5_3 - ratio_q_P2_u_P1_of_q_p4_q_p5_7;
    let ratio_q_P2_u_P1_of_place_96 = (-cos_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_of_q_p4_q_p5_15, ratio_q_P2_u_P1_of_place_90);
    let ratio_q_P2_u_P1_of_place_97 = ratio_q_P2_u_P1_of_place_23
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_place_40);
    let cos_q_p4_cos_q_p5 = cos_q_P4 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_98 = ratio_q_P2_u_P1_of_place_96
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_of_place_95 * cos_q_P1)
        + ratio_q_P2_u_P1_of_place_97 * cos_q_p4_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_99 = l_sq * ratio_q_P2_u_P1_of_place_98;
    let ratio_q_P2_u_P1_of_place_100 = S::int(1)
        / ((-ratio_q_P2_u_P1_of_place_18)
            .mul_add(
                ratio_q_P2_u_P1_of_place_51,
                ratio_q_P2_u_P1_of_place_25 * ratio_q_P2_u_P1_of_place_73,
            ) + ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_of_place_80
            + ratio_q_P2_u_P1_of_place_82 * ratio_q_P2_u_P1_of_place_99);
    let ratio_q_P2_u_P1_of_place_101 = l * ratio_q_P2_u_P1_of_place_100;
    let ratio_q_P2_u_P1_of_place_102 = ratio_q_P2_u_P1_of_place_35 * ratio_q_P2_u_P1_of_place_101;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_16 = ratio_q_P2_u_P1_of_q_p4_q_p5 - ratio_q_P2_u_P1_of_q_p5;
    let sin_q_p3_sin_q_p1 = sin_q_P1 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_103 = (-cos_q_p3_cos_q_p1)
        .mul_add(sin_q_P2, sin_q_p3_sin_q_p1);
    let cos_q_p3_sin_q_p4 = cos_q_P3 * sin_q_P4;
    let ratio_q_P2_u_P1_of_place_104 = cos_q_p3_sin_q_p4
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_3 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_105 = (-ratio_q_P2_u_P1_of_place_104)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_103 * sin_q_P5);
    let ratio_q_P2_u_P1_of_place_106 = l_sq * ratio_q_P2_u_P1_of_place_101;
    let ratio_q_P2_u_P1_of_place_107 = ratio_q_P2_u_P1_of_place_105 * ratio_q_P2_u_P1_of_place_106;
    let ratio_q_P2_u_P1_of_place_108 = ratio_q_P2_u_P1_of_place_107 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_109 = ratio_q_P2_u_P1_of_place_34
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_17);
    let ratio_q_P2_u_P1_of_place_110 = ratio_q_P2_u_P1_of_place_98 * ratio_q_P2_u_P1_of_place_106;
    let ratio_q_P2_u_P1 = ratio_q_P2_u_P1_of_q_p4_q_p5_16
        .mul_add(
            ratio_q_P2_u_P1_of_place_108,
            ratio_q_P2_u_P1_of_place_31 * ratio_q_P2_u_P1_of_place_102,
        ) + ratio_q_P2_u_P1_of_place_109 * ratio_q_P2_u_P1_of_place_110;
    let ratio_q_P3_u_P1_of_place = (-ratio_q_P2_u_P1_of_place_7)
        .mul_add(
            ratio_q_P2_u_P1_of_place_42,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_33,
        );
    let ratio_q_P3_u_P1_of_place_2 = ratio_q_P2_u_P1_of_place
        .mul_add(
            ratio_q_P2_u_P1_of_place_42,
            ratio_q_P2_u_P1_of_place_12 * ratio_q_P2_u_P1_of_place_39,
        );
    let ratio_q_P3_u_P1_of_place_3 = ratio_q_P2_u_P1_of_place_25
        .mul_add(
            ratio_q_P3_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_of_place_82,
        ) + ratio_q_P2_u_P1_of_place_30 * ratio_q_P3_u_P1_of_place_2;
    let ratio_q_P3_u_P1_of_place_4 = ratio_q_P2_u_P1_of_place_101 * ratio_q_P2_u_P1_of_place_109;
    let ratio_q_P3_u_P1_of_q_p3_q_p5 = ratio_q_P2_u_P1_of_q_p3_q_p5_4
        .mul_add(cos_q_P5, -ratio_q_P2_u_P1_of_q_p5) - ratio_q_P2_u_P1_of_q_p3_q_p5;
    let ratio_q_P3_u_P1_of_place_5 = ratio_q_P2_u_P1_of_place_107 * cos_q_P4;
    let ratio_q_P3_u_P1 = ratio_q_P2_u_P1_of_place_51
        .mul_add(
            ratio_q_P3_u_P1_of_place_4,
            ratio_q_P2_u_P1_of_place_102 * ratio_q_P3_u_P1_of_place_3,
        ) - ratio_q_P3_u_P1_of_q_p3_q_p5 * ratio_q_P3_u_P1_of_place_5;
    let ratio_q_P4_u_P1_of_place = ratio_q_P2_u_P1_of_place_16 * cos_q_p2_sin_q_p1;
    let ratio_q_P4_u_P1_of_place_2 = (-ratio_q_P2_u_P1_of_place_8)
        .mul_add(
            ratio_q_P4_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_20 * ratio_q_P2_u_P1_of_place_39,
        );
    let ratio_q_P4_u_P1_of_place_3 = ratio_q_P2_u_P1_of_place_18
        .mul_add(
            ratio_q_P3_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_of_place_82,
        ) - ratio_q_P2_u_P1_of_place_30 * ratio_q_P4_u_P1_of_place_2;
    let ratio_q_P4_u_P1_of_q_p4_q_p5 = ratio_q_P2_u_P1_of_q_p4_q_p5_4 - S::int(2);
    let ratio_q_P4_u_P1_of_place_4 = (-ratio_q_P4_u_P1_of_q_p4_q_p5)
        .mul_add(
            sin_q_P3,
            ratio_q_P2_u_P1_of_q_p4_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_3,
        );
    let ratio_q_P4_u_P1_of_place_5 = ratio_q_P4_u_P1_of_place_4
        .mul_add(sin_q_P4, sin_q_P3 - sin_q_P5 + cos_q_p3_cos_q_p5);
    let ratio_q_P4_u_P1 = ratio_q_P2_u_P1_of_place_102
        .mul_add(
            ratio_q_P4_u_P1_of_place_3,
            ratio_q_P2_u_P1_of_place_73 * ratio_q_P3_u_P1_of_place_4,
        ) - ratio_q_P2_u_P1_of_place_108 * ratio_q_P4_u_P1_of_place_5;
    let ratio_q_P5_u_P1_of_place = ratio_q_P2_u_P1_of_place_18
        .mul_add(
            ratio_q_P3_u_P1_of_place_2,
            ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_of_place_82,
        ) + ratio_q_P2_u_P1_of_place_25 * ratio_q_P4_u_P1_of_place_2;
    let ratio_q_P5_u_P1_of_q_p3_q_p5 = (-ratio_q_P2_u_P1_of_q_p5_4)
        .mul_add(sin_q_P3, -ratio_q_P2_u_P1_of_q_p5_3);
    let ratio_q_P5_u_P1_of_q_p3_q_p5_2 = sin_q_P3 - ratio_q_P2_u_P1_of_q_p3_q_p5_3;
    let ratio_q_P5_u_P1_of_place_2 = ratio_q_P2_u_P1_of_q_p5
        .mul_add(
            ratio_q_P5_u_P1_of_q_p3_q_p5_2,
            ratio_q_P5_u_P1_of_q_p3_q_p5 * sin_q_P4,
        );
    let ratio_q_P5_u_P1 = ratio_q_P2_u_P1_of_place_102
        .mul_add(
            ratio_q_P5_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_80 * ratio_q_P3_u_P1_of_place_4,
        ) - ratio_q_P3_u_P1_of_place_5 * ratio_q_P5_u_P1_of_place_2;
    let w_rod1_frame_in_rod2_frame_1 = u_P1 * sin_q_P2;
    let w_rod1_frame_in_rod2_frame_2 = u_P1 * cos_q_P2;
    let u_p1_ratio_q_p5_u_p1 = u_P1 * ratio_q_P5_u_P1;
    let ratio_q_P2_u_P1_2_of_u_p1 = u_p1_ratio_q_p5_u_p1 * cos_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_2 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_2_of_u_p1;
    let u_p1_cos_q_p4 = u_P1 * cos_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_3 = ratio_q_P4_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_4 = ratio_q_P2_u_P1_2_of_u_p1_3 * sin_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_5 = (-cos_q_p4_sq)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_2,
            ratio_q_P2_u_P1_of_q_p5_4 * ratio_q_P2_u_P1_2_of_u_p1_4,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_6 = ratio_q_P5_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_7 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_12)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_3,
            cos_q_p4_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_6,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_8 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_9 = ratio_q_P2_u_P1_2_of_u_p1_8 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_10 = ratio_q_P2_u_P1_2_of_u_p1_9 - ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_11 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_5;
    let ratio_q_P2_u_P1_2_of_u_p1_12 = sin_q_P4
        * (ratio_q_P2_u_P1_2_of_u_p1_11 - ratio_q_P2_u_P1_2_of_u_p1_10)
        + ratio_q_P2_u_P1_of_q_p4_q_p5_8 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_13 = ratio_q_P2_u_P1_2_of_u_p1_7 + ratio_q_P2_u_P1_2_of_u_p1_10;
    let ratio_q_P2_u_P1_2_of_u_p1_14 = ratio_q_P2_u_P1_2_of_u_p1_12 - ratio_q_P2_u_P1_2_of_u_p1_13;
    let ratio_q_P2_u_P1_2_of_u_p1_15 = u_p1_ratio_q_p5_u_p1 * sin_q_P5;
    let u_p1_ratio_q_p3_u_p1 = u_P1 * ratio_q_P3_u_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_16 = u_p1_ratio_q_p3_u_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_17 = ratio_q_P2_u_P1_2_of_u_p1_16 * cos_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_18 = ratio_q_P2_u_P1_2_of_u_p1_15
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_17);
    let ratio_q_P2_u_P1_2_of_u_p1_19 = u_p1_ratio_q_p3_u_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_20 = ratio_q_P2_u_P1_of_q_p5
        * ratio_q_P2_u_P1_2_of_u_p1_4.mul_add(S::int(4), ratio_q_P2_u_P1_2_of_u_p1_3)
        - ratio_q_P2_u_P1_of_q_p4_3 * ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_21 = cos_q_P3
        * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_11)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_18,
                ratio_q_P2_u_P1_2_of_u_p1_14 * cos_q_P3,
            ) + ratio_q_P2_u_P1_of_q_p4_q_p5_10 * ratio_q_P2_u_P1_2_of_u_p1_19
            + sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_20)
        + ratio_q_P2_u_P1_of_place_83 * ratio_q_P2_u_P1_2_of_u_p1_19;
    let u_p1_ratio_q_p4_u_p1 = u_P1 * ratio_q_P4_u_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_22 = u_p1_ratio_q_p4_u_p1 * sin_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_23 = ratio_q_P2_u_P1_2_of_u_p1_22
        .mul_add(sin_q_P2, ratio_q_P2_u_P1 * u_p1_cos_q_p4 * cos_q_P2);
    let w_rod2_frame_3 = u_P1 * ratio_q_P2_u_P1;
    let sin_q_p2_w_rod2_frame_3 = w_rod2_frame_3 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_24 = ratio_q_P2_u_P1_of_q_p5_2
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_3, ratio_q_P2_u_P1_2_of_u_p1 * sin_q_P4);
    let ratio_q_P2_u_P1_2_of_u_p1_25 = ratio_q_P2_u_P1_2_of_u_p1_11 + ratio_q_P2_u_P1_2_of_u_p1_24;
    let ratio_q_P2_u_P1_2_of_u_p1_26 = ratio_q_P2_u_P1_2_of_u_p1
        .mul_add(S::int(3), -ratio_q_P2_u_P1_2_of_u_p1_9)
        + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_25;
    let ratio_q_P2_u_P1_2_of_u_p1_27 = (-ratio_q_P2_u_P1_2_of_u_p1_15)
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_19 * cos_q_P5);
    let ratio_q_P2_u_P1_2_of_u_p1_28 = ratio_q_P2_u_P1_2_of_u_p1_24
        .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1);
    let sin_q_p2_ratio_q_p2_u_p1 = ratio_q_P2_u_P1 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_29 = (-u_p1_cos_q_p4)
        .mul_add(sin_q_p2_ratio_q_p2_u_p1, cos_q_p2_sin_q_p4 * u_p1_ratio_q_p4_u_p1);
    let cos_q_p2_w_rod2_frame_3 = w_rod2_frame_3 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_30 = sin_q_P2
        * ((-ratio_q_P2_u_P1_2_of_u_p1_14)
            .mul_add(
                sin_q_P3,
                ratio_q_P2_u_P1_of_q_p4_q_p5_10 * ratio_q_P2_u_P1_2_of_u_p1_16,
            ) + cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_20
            + ratio_q_P2_u_P1_of_q_p4_q_p5_11 * ratio_q_P2_u_P1_2_of_u_p1_27)
        + ratio_q_P2_u_P1_of_place_89 * cos_q_p2_w_rod2_frame_3;
    let ratio_q_P2_u_P1_2_of_u_p1_31 = ratio_q_P3_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_32 = (ratio_q_P2_u_P1_2_of_u_p1_31 * cos_q_P2)
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_29 * sin_q_P3);
    let u_p1_cos_q_p1 = u_P1 * cos_q_P1;
    let u_p1_sin_q_p1 = u_P1 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_33 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_8;
    let ratio_q_P2_u_P1_2_of_u_p1_34 = ratio_q_P2_u_P1_2_of_u_p1_6 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_35 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_23, ratio_q_P2_u_P1_2_of_u_p1_34 * cos_q_P5);
    let ratio_q_P2_u_P1_2_of_u_p1_36 = ratio_q_P2_u_P1_2_of_u_p1_24
        .mul_add(cos_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5 * sin_q_p2_w_rod2_frame_3);
    let ratio_q_P2_u_P1_2_of_u_p1_37 = -ratio_q_P2_u_P1_of_place_97
        * ratio_q_P2_u_P1_2_of_u_p1_22
            .mul_add(cos_q_P5, ratio_q_P2_u_P1_2_of_u_p1_6 * sin_q_P5)
        + ratio_q_P2_u_P1_of_place_96 * ratio_q_P2_u_P1_2_of_u_p1_19
        + ratio_q_P2_u_P1_of_place_95 * u_p1_sin_q_p1
        + cos_q_P1
            * (sin_q_P1
                * (ratio_q_P2_u_P1_2_of_u_p1_14 - S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_21
                    - ratio_q_P2_u_P1_of_place_87 * sin_q_p2_w_rod2_frame_3
                    + cos_q_P2
                        * (-cos_q_P2
                            * (ratio_q_P2_u_P1_2_of_u_p1
                                + ratio_q_P2_u_P1_of_q_p4_q_p5_6 * ratio_q_P2_u_P1_2_of_u_p1_3
                                + sin_q_P4
                                    * ratio_q_P2_u_P1_2_of_u_p1_5
                                        .mul_add(S::int(4), ratio_q_P2_u_P1_2_of_u_p1)
                                - S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_7
                                - ratio_q_P2_u_P1_2_of_u_p1_21)
                            + ratio_q_P2_u_P1_of_place_86 * ratio_q_P2_u_P1_2_of_u_p1_23
                            - ratio_q_P2_u_P1_of_place_85 * sin_q_p2_w_rod2_frame_3
                            - sin_q_p2_cos_q_p4
                                * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_13)
                                    .mul_add(
                                        ratio_q_P2_u_P1_2_of_u_p1_16,
                                        ratio_q_P2_u_P1_2_of_u_p1_26 * sin_q_P3,
                                    )
                                    + ratio_q_P2_u_P1_of_q_p4_q_p5_14 * ratio_q_P2_u_P1_2_of_u_p1_27
                                    + cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_28)))
                + cos_q_P1
                    * (ratio_q_P2_u_P1_of_place_93 * ratio_q_P2_u_P1_2_of_u_p1_15
                        - ratio_q_P2_u_P1_of_place_91 * ratio_q_P2_u_P1_2_of_u_p1_19
                        + cos_q_P3
                            * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_13)
                                .mul_add(
                                    ratio_q_P2_u_P1_2_of_u_p1_29,
                                    cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_26,
                                ) + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_30)
                        + cos_q_P5
                            * ((-ratio_q_P2_u_P1_2_of_u_p1_20)
                                .mul_add(
                                    sin_q_P2,
                                    ratio_q_P2_u_P1_of_q_p4_q_p5_11 * cos_q_p2_w_rod2_frame_3,
                                ) - ratio_q_P2_u_P1_of_place_92 * ratio_q_P2_u_P1_2_of_u_p1_28
                                + ratio_q_P2_u_P1_of_q_p4_q_p5_14 * ratio_q_P2_u_P1_2_of_u_p1_32))
                - ratio_q_P2_u_P1_of_place_88 * u_p1_cos_q_p1
                - ratio_q_P2_u_P1_of_place_94 * u_p1_sin_q_p1)
        + cos_q_P3
            * (-ratio_q_P2_u_P1_2_of_u_p1_30
                + ratio_q_P2_u_P1_of_q_p4_q_p5_15 * ratio_q_P2_u_P1_2_of_u_p1_29
                - cos_q_p2_cos_q_p4 * (ratio_q_P2_u_P1_2_of_u_p1_25 + ratio_q_P2_u_P1_2_of_u_p1_33))
        + cos_q_p4_cos_q_p5
            * ((-ratio_q_P2_u_P1_of_place_23)
                .mul_add(ratio_q_P2_u_P1_2_of_u_p1_16, ratio_q_P2_u_P1_2_of_u_p1_35)
                + ratio_q_P2_u_P1_2_of_u_p1_36 * sin_q_P3);
    let ratio_q_P2_u_P1_2_of_u_p1_38 = ratio_q_P2_u_P1_2_of_u_p1_3 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_39 = sin_q_p2_w_rod2_frame_3
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_2_of_u_p1_38);
    let ratio_q_P2_u_P1_2_of_u_p1_40 = ratio_q_P2_u_P1_2_of_u_p1_31 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_41 = ratio_q_P2_u_P1_2_of_u_p1_40
        .mul_add(cos_q_P3, -ratio_q_P2_u_P1_2_of_u_p1_39);
    let ratio_q_P2_u_P1_2_of_u_p1_42 = ratio_q_P4_u_P1 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_43 = (-cos_q_p3_sin_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_42,
            sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_31,
        );
    let sin_q_p1_u_p1_cos_q_p4 = u_p1_cos_q_p4 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_44 = sin_q_p1_u_p1_cos_q_p4
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_43);
    let ratio_q_P2_u_P1_2_of_u_p1_45 = cos_q_P5
        * (sin_q_P1
            * ratio_q_P2_u_P1_2_of_u_p1_23
                .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_41)
            + ratio_q_P2_u_P1_of_place_9 * u_p1_cos_q_p1 + ratio_q_P2_u_P1_2_of_u_p1_44)
        - ratio_q_P2_u_P1_of_place_11 * ratio_q_P2_u_P1_2_of_u_p1_15;
    let ratio_q_P2_u_P1_2_of_u_p1_46 = ratio_q_P2_u_P1_2_of_u_p1_6 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_47 = (-ratio_q_P2_u_P1_2_of_u_p1_24)
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_p2_w_rod2_frame_3)
        - ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_32
        + sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_46;
    let ratio_q_P2_u_P1_2_of_u_p1_48 = ratio_q_P2_u_P1_2_of_u_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_49 = sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_50 = (-ratio_q_P2_u_P1_2_of_u_p1_19)
        .mul_add(sin_q_P5, ratio_q_P2_u_P1_2_of_u_p1_18 * sin_q_P4)
        - ratio_q_P2_u_P1_2_of_u_p1_48 - ratio_q_P2_u_P1_2_of_u_p1_49;
    let ratio_q_P2_u_P1_2_of_u_p1_51 = (-ratio_q_P2_u_P1_of_place_6)
        .mul_add(sin_q_p2_w_rod2_frame_3, ratio_q_P2_u_P1_2_of_u_p1_23 * cos_q_P5)
        + ratio_q_P2_u_P1_2_of_u_p1_34 * sin_q_P5 + ratio_q_P2_u_P1_2_of_u_p1_50 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_52 = u_p1_cos_q_p1
        .mul_add(sin_q_P2, w_rod2_frame_3 * cos_q_p2_sin_q_p1);
    let sin_q_p3_u_p1_sin_q_p1 = u_p1_sin_q_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_53 = ratio_q_P2_u_P1_2_of_u_p1_16 * cos_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_54 = sin_q_P4
        * cos_q_p2_w_rod2_frame_3
            .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_16 * sin_q_P2)
        - sin_q_p2_sin_q_p3 * ratio_q_P2_u_P1_2_of_u_p1_3 - ratio_q_P2_u_P1_2_of_u_p1_29;
    let cos_q_p3_u_p1_sin_q_p1 = u_p1_sin_q_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_55 = ratio_q_P2_u_P1_2_of_u_p1_19
        .mul_add(cos_q_P1, cos_q_p3_u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_56 = ratio_q_P2_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_15
        - ratio_q_P2_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1
        + cos_q_P5
            * ((-sin_q_p2_sin_q_p1)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_19,
                    ratio_q_P2_u_P1_2_of_u_p1_52 * cos_q_P3,
                ) - sin_q_p3_u_p1_sin_q_p1 + ratio_q_P2_u_P1_2_of_u_p1_53)
        - sin_q_P5
            * (ratio_q_P2_u_P1_of_place_3
                .mul_add(u_p1_cos_q_p1, cos_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_3)
                + ratio_q_P2_u_P1_2_of_u_p1_54 * sin_q_P1
                + ratio_q_P2_u_P1_2_of_u_p1_55 * sin_q_P4);
    let ratio_q_P2_u_P1_2_of_u_p1_57 = ratio_q_P2_u_P1_of_place_5
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_47,
            ratio_q_P2_u_P1_of_place_8 * ratio_q_P2_u_P1_2_of_u_p1_45,
        ) - ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_u_p1_51
        - ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_2_of_u_p1_56;
    let ratio_q_P2_u_P1_2_of_u_p1_58 = ratio_q_P2_u_P1_2_of_u_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_59 = ratio_q_P2_u_P1_2_of_u_p1_16 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_60 = cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_61 = ratio_q_P2_u_P1_2_of_u_p1_27
        .mul_add(sin_q_P4, -ratio_q_P2_u_P1_2_of_u_p1_58) + ratio_q_P2_u_P1_2_of_u_p1_59
        + ratio_q_P2_u_P1_2_of_u_p1_60;
    let ratio_q_P2_u_P1_2_of_u_p1_62 = (-ratio_q_P2_u_P1_2_of_u_p1_50)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_6 * u_p1_sin_q_p1)
        - ratio_q_P2_u_P1_of_place_19 * ratio_q_P2_u_P1_2_of_u_p1_52
        + sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_61;
    let ratio_q_P2_u_P1_2_of_u_p1_63 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_19, ratio_q_P2_u_P1_2_of_u_p1_18)
        - ratio_q_P2_u_P1_2_of_u_p1_24 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_64 = ratio_q_P2_u_P1_2_of_u_p1_63 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_place = ratio_q_P2_u_P1_of_place_16 * sin_q_p2_w_rod2_frame_3;
    let ratio_q_P2_u_P1_2_of_u_p1_65 = ratio_q_P2_u_P1_2_of_place - ratio_q_P2_u_P1_2_of_u_p1_64;
    let ratio_q_P2_u_P1_2_of_place_2 = l * ratio_q_P2_u_P1_of_place_20;
    let ratio_q_P2_u_P1_2_of_u_p1_66 = (-ratio_q_P2_u_P1_of_place_66)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_56,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_65,
        ) - ratio_q_P2_u_P1_of_place_8 * ratio_q_P2_u_P1_2_of_u_p1_62
        + ratio_q_P2_u_P1_2_of_u_p1_51 * ratio_q_P2_u_P1_2_of_place_2;
    let ratio_q_P2_u_P1_2_of_u_p1_67 = ratio_q_P2_u_P1_of_place_27
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_62,
            ratio_q_P2_u_P1_of_place_66 * ratio_q_P2_u_P1_2_of_u_p1_45,
        ) + ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_u_p1_65
        + ratio_q_P2_u_P1_2_of_u_p1_47 * ratio_q_P2_u_P1_2_of_place_2;
    let ratio_q_P2_u_P1_2_of_u_p1_68 = (-ratio_q_P2_u_P1_2_of_u_p1_24)
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_q_p4_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_16)
        + ratio_q_P2_u_P1_2_of_u_p1_27;
    let ratio_q_P2_u_P1_2_of_u_p1_69 = (-ratio_q_P2_u_P1_2_of_u_p1_63)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_16 * u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_70 = l
        * (-u_p1_cos_q_p1
            * ratio_q_P2_u_P1
                .mul_add(ratio_q_P2_u_P1_of_place_21, ratio_q_P2_u_P1_of_place_15)
            + ratio_q_P2_u_P1_2_of_u_p1_68 * sin_q_P1 + ratio_q_P2_u_P1_2_of_u_p1_69 * sin_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_71 = (-sin_q_p3_cos_q_p5)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_34,
            ratio_q_P2_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_23,
        ) - ratio_q_P2_u_P1_2_of_u_p1_36
        + ratio_q_P2_u_P1_of_q_p3_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_40;
    let ratio_q_P2_u_P1_2_of_u_p1_72 = cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_6;
    let ratio_q_P2_u_P1_2_of_u_p1_73 = l
        * (ratio_q_P2_u_P1_of_place_24 * u_p1_sin_q_p1
            - ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p3_cos_q_p1 * u_p1_cos_q_p4
            - ratio_q_P4_u_P1 * ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_p3_u_p1_sin_q_p1
            - ratio_q_P2_u_P1_2_of_u_p1_71 * cos_q_P1
            + sin_q_P1
                * ratio_q_P2_u_P1_of_q_p3_q_p5
                    .mul_add(
                        ratio_q_P2_u_P1_2_of_u_p1_31, ratio_q_P2_u_P1_2_of_u_p1_72,
                    ));
    let ratio_q_P2_u_P1_2_of_u_p1_74 = (-ratio_q_P2_u_P1_2_of_u_p1_29)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_6 * cos_q_p2_w_rod2_frame_3)
        - ratio_q_P2_u_P1_2_of_u_p1_46 * sin_q_P5 + ratio_q_P2_u_P1_2_of_u_p1_50 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_75 = l
        * ((-ratio_q_P2_u_P1_2_of_u_p1_61)
            .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_19 * u_p1_cos_q_p1)
            + ratio_q_P2_u_P1_of_place_29 * u_p1_sin_q_p1
            + ratio_q_P2_u_P1_2_of_u_p1_74 * cos_q_P1);
    let cos_q_p2_u_p1_cos_q_p1 = u_p1_cos_q_p1 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_76 = ratio_q_P2_u_P1_of_place_32
        .mul_add(
            cos_q_p2_w_rod2_frame_3,
            ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_29,
        ) - ratio_q_P2_u_P1_2_of_u_p1_46 * cos_q_P5 - ratio_q_P2_u_P1_2_of_u_p1_68 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_77 = (-ratio_q_P2_u_P1_of_place_29)
        .mul_add(u_p1_cos_q_p1, ratio_q_P2_u_P1_of_place_19 * u_p1_sin_q_p1)
        + ratio_q_P2_u_P1_2_of_u_p1_61 * cos_q_P1 + ratio_q_P2_u_P1_2_of_u_p1_74 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_78 = sin_q_p2_w_rod2_frame_3
        .mul_add(sin_q_P1, -cos_q_p2_u_p1_cos_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_79 = l * ratio_q_P2_u_P1_2_of_u_p1_51;
    let ratio_q_P2_u_P1_2_of_u_p1_80 = ratio_q_P2_u_P1_of_place_8 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_81 = ratio_q_P2_u_P1_2_of_u_p1_79
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_2_of_u_p1_80);
    let ratio_q_P2_u_P1_2_of_u_p1_82 = ratio_q_P2_u_P1_of_place_32
        .mul_add(sin_q_p2_w_rod2_frame_3, -ratio_q_P2_u_P1_2_of_u_p1_35)
        + ratio_q_P2_u_P1_2_of_u_p1_68 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_83 = ratio_q_P2_u_P1_of_place_81
        * ratio_q_P2_u_P1_2_of_u_p1_56 * sin_q_P1
        + ratio_q_P2_u_P1_of_place_42 * ratio_q_P2_u_P1_2_of_u_p1_77
        - ratio_q_P2_u_P1_of_place_37 * ratio_q_P2_u_P1_2_of_u_p1_81
        + ratio_q_P2_u_P1_of_place_5
            * (-ratio_q_P2_u_P1_2_of_u_p1_82)
                .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_41 * u_p1_cos_q_p1);
    let ratio_q_P2_u_P1_2_of_place_3 = l * ratio_q_P2_u_P1_of_place_43;
    let ratio_q_P2_u_P1_2_of_place_4 = ratio_q_P2_u_P1_of_place_7 * l_sq;
    let ratio_q_P2_u_P1_2_of_u_p1_84 = ratio_q_P2_u_P1_of_q_p5_2
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_19, ratio_q_P2_u_P1_2_of_u_p1_48);
    let ratio_q_P2_u_P1_2_of_u_p1_85 = ratio_q_P2_u_P1_of_q_p3
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_15, ratio_q_P2_u_P1_2_of_u_p1_17)
        + ratio_q_P2_u_P1_2_of_u_p1_84;
    let ratio_q_P2_u_P1_2_of_u_p1_86 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_16, ratio_q_P2_u_P1_2_of_u_p1_58);
    let ratio_q_P2_u_P1_2_of_u_p1_87 = ratio_q_P2_u_P1_of_q_p4_q_p5
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_78,
            cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_24,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_88 = cos_q_p2_sin_q_p1
        * (ratio_q_P2_u_P1_of_place_48
            * u_p1_cos_q_p1.mul_add(cos_q_P5, ratio_q_P2_u_P1_2_of_u_p1_15 * sin_q_P1)
            - ratio_q_P2_u_P1_of_place_46 * ratio_q_P2_u_P1_2_of_u_p1_19
            - cos_q_p5_sin_q_p1
                * (ratio_q_P2_u_P1_2_of_u_p1_39
                    + ratio_q_P2_u_P1_of_place_47 * ratio_q_P2_u_P1_2_of_u_p1_16
                    + sin_q_P3
                        * ratio_q_P2_u_P1_of_q_p3
                            .mul_add(
                                ratio_q_P2_u_P1_2_of_u_p1_23, ratio_q_P2_u_P1_2_of_u_p1_41,
                            ))
            - cos_q_P3
                * (cos_q_P4
                    * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
                        .mul_add(
                            u_p1_sin_q_p1,
                            sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_86,
                        ) - ratio_q_P2_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_52
                        - ratio_q_P2_u_P1_2_of_u_p1_85 * cos_q_P1)
                    - ratio_q_P2_u_P1_of_place_44 * ratio_q_P2_u_P1_2_of_u_p1_22
                    + ratio_q_P2_u_P1_2_of_u_p1_87));
    let ratio_q_P2_u_P1_2_of_u_p1_89 = ratio_q_P2_u_P1_of_place_50 * ratio_q_P2_u_P1_2_of_u_p1_51
        + l * ratio_q_P2_u_P1_of_place_38 * ratio_q_P2_u_P1_2_of_u_p1_76
        + ratio_q_P2_u_P1_of_place_39
            * (l
                * ratio_q_P2_u_P1_of_place_36
                    .mul_add(
                        ratio_q_P2_u_P1_2_of_u_p1_56,
                        ratio_q_P2_u_P1_of_place_37 * ratio_q_P2_u_P1_2_of_u_p1_45,
                    )
                + ratio_q_P2_u_P1_of_place_5
                    * (ratio_q_P2_u_P1_of_q_p5_2
                        .mul_add(
                            ratio_q_P2_u_P1_2_of_u_p1_44,
                            ratio_q_P2_u_P1_of_place_24 * u_p1_cos_q_p1,
                        ) + ratio_q_P2_u_P1_2_of_u_p1_71 * sin_q_P1
                        + ratio_q_P2_u_P1_2_of_u_p1_72 * cos_q_P1)
                + ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_u_p1_77)
        - ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_49 * ratio_q_P2_u_P1_2_of_u_p1_78
        + ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_2_of_u_p1_83
        - ratio_q_P2_u_P1_2_of_u_p1_47 * ratio_q_P2_u_P1_2_of_place_3
        + ratio_q_P2_u_P1_2_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_88;
    let ratio_q_P2_u_P1_2_of_u_p1_90 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_4;
    let ratio_q_P2_u_P1_2_of_u_p1_91 = ratio_q_P2_u_P1_2_of_u_p1_90
        - ratio_q_P2_u_P1_of_q_p4_2 * ratio_q_P2_u_P1_2_of_u_p1
        - sin_q_P5 * (ratio_q_P2_u_P1_2_of_u_p1_3 + ratio_q_P2_u_P1_2_of_u_p1_90);
    let ratio_q_P2_u_P1_2_of_u_p1_92 = ratio_q_P2_u_P1_2_of_u_p1_91 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_93 = ratio_q_P2_u_P1_of_q_p4_q_p5_3
        * ratio_q_P2_u_P1_2_of_u_p1_16;
    let ratio_q_P2_u_P1_2_of_u_p1_94 = ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P2_u_P1_2_of_u_p1_24;
    let ratio_q_P2_u_P1_2_of_u_p1_95 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_94;
    let ratio_q_P2_u_P1_2_of_u_p1_96 = ratio_q_P2_u_P1_of_q_p4
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_18, -ratio_q_P2_u_P1_2_of_u_p1_49);
    let ratio_q_P2_u_P1_2_of_u_p1_97 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_3)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_19, ratio_q_P2_u_P1_2_of_u_p1_91 * cos_q_P3);
    let ratio_q_P2_u_P1_2_of_u_p1_98 = ratio_q_P2_u_P1_2_of_u_p1_27 + ratio_q_P2_u_P1_2_of_u_p1_86;
    let ratio_q_P2_u_P1_2_of_u_p1_99 = cos_q_P1
        * (ratio_q_P2_u_P1_2_of_u_p1_18 + ratio_q_P2_u_P1_2_of_u_p1_84);
    let ratio_q_P2_u_P1_2_of_place_5 = ratio_q_P2_u_P1_of_q_p3_q_p5_7 * sin_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_100 = ratio_q_P2_u_P1_of_q_p3_q_p5_7 * sin_q_p1_u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_101 = u_p1_sin_q_p1
        .mul_add(cos_q_P2, sin_q_p2_ratio_q_p2_u_p1 * u_p1_cos_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_102 = sin_q_P1
        * (ratio_q_P2_u_P1_of_place_70 * cos_q_p2_w_rod2_frame_3
            - cos_q_p2_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_50
            + sin_q_P2
                * (sin_q_P1
                    * (cos_q_P2
                        * (ratio_q_P2_u_P1_of_q_p3_q_p5_5 * ratio_q_P2_u_P1_2_of_u_p1_3
                            - ratio_q_P2_u_P1_of_q_p3 * ratio_q_P2_u_P1_2_of_u_p1
                            + sin_q_P4 * (ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P2_u_P1_2_of_u_p1_27)
                            + ratio_q_P2_u_P1_2_of_u_p1_59)
                        - ratio_q_P2_u_P1_of_q_p3_q_p5_6 * ratio_q_P2_u_P1_2_of_u_p1_23
                        - ratio_q_P2_u_P1_of_place_67 * sin_q_p2_w_rod2_frame_3
                        + sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_98)
                    + ratio_q_P2_u_P1_of_place_68 * u_p1_cos_q_p1
                    - ratio_q_P2_u_P1_2_of_u_p1_99 * cos_q_P4
                    - ratio_q_P2_u_P1_2_of_u_p1_42 * ratio_q_P2_u_P1_2_of_place_5
                    + ratio_q_P2_u_P1_2_of_u_p1_100)
            + ratio_q_P2_u_P1_of_place_6 * ratio_q_P2_u_P1_2_of_u_p1_101)
        + ratio_q_P2_u_P1_of_place_71 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_103 = l_sq * ratio_q_P2_u_P1_2_of_u_p1_76;
    let ratio_q_P2_u_P1_2_of_u_p1_104 = ratio_q_P2_u_P1_of_place_72 * ratio_q_P2_u_P1_2_of_u_p1_51
        - ratio_q_P2_u_P1_of_place_66 * ratio_q_P2_u_P1_2_of_u_p1_83
        + ratio_q_P2_u_P1_2_of_u_p1_65 * ratio_q_P2_u_P1_2_of_place_3
        + ratio_q_P2_u_P1_of_place_65
            * (-u_p1_cos_q_p1
                * (ratio_q_P2_u_P1_of_place_62 * sin_q_p3_sin_q_p1)
                    .mul_add(S::int(2), ratio_q_P2_u_P1_of_place_61)
                + ratio_q_P2_u_P1_of_place_63 * ratio_q_P2_u_P1_2_of_u_p1_53
                - sin_q_P1
                    * (ratio_q_P2_u_P1_of_q_p4_q_p5_4
                        * (-ratio_q_P2_u_P1_2_of_u_p1_32)
                            .mul_add(
                                cos_q_P1,
                                cos_q_p2_sin_q_p1 * u_p1_cos_q_p4 * sin_q_P3,
                            ) + ratio_q_P2_u_P1_of_place_60 * cos_q_p2_w_rod2_frame_3
                        + sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_95
                        + sin_q_P2
                            * (sin_q_p3_cos_q_p1
                                * ratio_q_P2_u_P1_2_of_u_p1_93
                                    .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_92)
                                - ratio_q_P2_u_P1_of_place_59 * ratio_q_P2_u_P1_2_of_u_p1_19
                                - ratio_q_P2_u_P1_of_place_52 * sin_q_p3_u_p1_sin_q_p1
                                + cos_q_P3
                                    * (ratio_q_P2_u_P1_of_place_55 * u_p1_cos_q_p1
                                        + ratio_q_P2_u_P1_of_place_58 * u_p1_sin_q_p1
                                        + sin_q_P1
                                            * (ratio_q_P2_u_P1_of_place_53 * cos_q_p2_w_rod2_frame_3
                                                - ratio_q_P2_u_P1_of_q_p4_q_p5_4
                                                    * ratio_q_P2_u_P1_2_of_u_p1_29
                                                + sin_q_P2
                                                    * (ratio_q_P2_u_P1_of_q_p4
                                                        .mul_add(
                                                            ratio_q_P2_u_P1_2_of_u_p1_27,
                                                            ratio_q_P2_u_P1_2_of_u_p1_60,
                                                        ) + ratio_q_P2_u_P1_2_of_u_p1_92
                                                        + ratio_q_P2_u_P1_2_of_u_p1_93)
                                                + ratio_q_P2_u_P1_2_of_u_p1_95)
                                        - cos_q_P1
                                            * ratio_q_P2_u_P1_2_of_u_p1_96
                                                .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_97))))
                + sin_q_p3_cos_q_p1 * cos_q_P1
                    * (ratio_q_P2_u_P1_2_of_u_p1_96 + ratio_q_P2_u_P1_2_of_u_p1_97))
        + ratio_q_P2_u_P1_2_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_102
        - ratio_q_P2_u_P1_of_place_64 * ratio_q_P2_u_P1_2_of_u_p1_103;
    let ratio_q_P2_u_P1_2_of_u_p1_105 = ratio_q_P2_u_P1_of_place_50
        * (-ratio_q_P2_u_P1_2_of_place).mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_64)
        - ratio_q_P2_u_P1_of_place_72 * ratio_q_P2_u_P1_2_of_u_p1_47
        + ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_of_place_49 * cos_q_p2_u_p1_cos_q_p1
        + ratio_q_P2_u_P1_of_place_65
            * (ratio_q_P2_u_P1_of_place_78 * u_p1_cos_q_p1
                - ratio_q_P2_u_P1_of_place_10 * ratio_q_P2_u_P1_2_of_u_p1_99
                + ratio_q_P2_u_P1_of_place_69 * ratio_q_P2_u_P1_2_of_u_p1_43
                + S::int(2) * cos_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_100
                - sin_q_P1
                    * (ratio_q_P2_u_P1_of_place_69 * ratio_q_P2_u_P1_2_of_u_p1_38
                        - ratio_q_P2_u_P1_of_place_77 * cos_q_p2_w_rod2_frame_3
                        + sin_q_P2
                            * (cos_q_p3_cos_q_p5
                                * (cos_q_p2_sin_q_p1
                                    .mul_add(
                                        ratio_q_P2_u_P1_2_of_u_p1_3, -ratio_q_P2_u_P1_2_of_u_p1_44,
                                    ) + ratio_q_P2_u_P1_2_of_u_p1_78 * sin_q_P4)
                                - ratio_q_P2_u_P1_of_place_75 * ratio_q_P2_u_P1_2_of_u_p1_16
                                - ratio_q_P2_u_P1_of_place_76 * ratio_q_P2_u_P1_2_of_u_p1_27
                                + sin_q_P3
                                    * (ratio_q_P2_u_P1_2_of_u_p1_87
                                        - ratio_q_P2_u_P1_of_place_74 * ratio_q_P2_u_P1_2_of_u_p1_22
                                        + cos_q_P4
                                            * (ratio_q_P2_u_P1_of_q_p3_q_p5_8 * u_p1_sin_q_p1
                                                - ratio_q_P2_u_P1_of_q_p3_q_p5_6
                                                    * ratio_q_P2_u_P1_2_of_u_p1_52
                                                - cos_q_P1
                                                    * ratio_q_P2_u_P1_2_of_u_p1_84
                                                        .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_18)
                                                + sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_98)))
                        - cos_q_p2_sin_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_99
                        + ratio_q_P2_u_P1_2_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_101))
        + l_sq
            * ratio_q_P2_u_P1_of_place
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_102,
                    ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_2_of_u_p1_88,
                ) + ratio_q_P2_u_P1_of_place_79 * ratio_q_P2_u_P1_2_of_u_p1_103;
    let ratio_q_P2_u_P1_2_of_u_p1_106 = l
        * ratio_q_P2_u_P1_2_of_u_p1_82
            .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_41 * u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_107 = ratio_q_P2_u_P1_of_place_100
        * ((-ratio_q_P2_u_P1_of_place_51)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_70,
                l_sq * ratio_q_P2_u_P1_of_place_82 * ratio_q_P2_u_P1_2_of_u_p1_37,
            ) + ratio_q_P2_u_P1_of_place_73 * ratio_q_P2_u_P1_2_of_u_p1_73
            - ratio_q_P2_u_P1_of_place_80 * ratio_q_P2_u_P1_2_of_u_p1_75
            + ratio_q_P2_u_P1_of_place_18 * ratio_q_P2_u_P1_2_of_u_p1_89
            + ratio_q_P2_u_P1_of_place_25 * ratio_q_P2_u_P1_2_of_u_p1_104
            - ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_2_of_u_p1_105
            + ratio_q_P2_u_P1_of_place_99 * ratio_q_P2_u_P1_2_of_u_p1_106);
    let ratio_q_P2_u_P1_2_of_u_p1_108 = ratio_q_P2_u_P1_of_place_103 * ratio_q_P2_u_P1_2_of_u_p1
        + ratio_q_P2_u_P1_of_place_104 * ratio_q_P2_u_P1_2_of_u_p1_15
        + cos_q_P5
            * (-sin_q_P1
                * ratio_q_P2_u_P1_2_of_u_p1_19
                    .mul_add(sin_q_P4, ratio_q_P2_u_P1_2_of_u_p1_3 * cos_q_P3)
                + cos_q_p3_sin_q_p4 * u_p1_cos_q_p1 - ratio_q_P2_u_P1_of_place_3 * u_p1_sin_q_p1
                + ratio_q_P2_u_P1_2_of_u_p1_54 * cos_q_P1)
        + sin_q_P5
            * ((-ratio_q_P2_u_P1_2_of_u_p1_16)
                .mul_add(sin_q_P1, ratio_q_P2_u_P1 * cos_q_p2_u_p1_cos_q_p1 * cos_q_P3)
                - u_p1_cos_q_p1 * sin_q_P3 - ratio_q_P2_u_P1_2_of_u_p1_55 * sin_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_109 = ratio_q_P2_u_P1_of_place_106
        * ratio_q_P2_u_P1_of_place_105
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_107, -ratio_q_P2_u_P1_2_of_u_p1_108);
    let ratio_q_P2_u_P1_2_of_u_p1_110 = ratio_q_P2_u_P1_2_of_u_p1_109
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_107 * ratio_q_P2_u_P1_2_of_u_p1_15);
    let ratio_q_P2_u_P1_2_of_u_p1_111 = ratio_q_P2_u_P1_of_place_34
        .mul_add(u_p1_sin_q_p1, ratio_q_P2_u_P1_of_place_16 * u_p1_cos_q_p1)
        + ratio_q_P2_u_P1_2_of_u_p1_63 * sin_q_P1 - ratio_q_P2_u_P1_2_of_u_p1_76 * cos_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_112 = ratio_q_P2_u_P1_of_place_101
        * ratio_q_P2_u_P1_of_place_35
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_107, -ratio_q_P2_u_P1_2_of_u_p1_111);
    let ratio_q_P2_u_P1_2_of_u_p1_113 = ratio_q_P2_u_P1_of_place_34
        .mul_add(u_p1_cos_q_p1, -ratio_q_P2_u_P1_2_of_u_p1_69)
        + ratio_q_P2_u_P1_2_of_u_p1_76 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_114 = ratio_q_P2_u_P1_of_place_109
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_107, ratio_q_P2_u_P1_2_of_u_p1_113);
    let ratio_q_P2_u_P1_2 = ratio_q_P2_u_P1_of_place_102
        * ((-ratio_q_P2_u_P1_of_place_18)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_57,
                ratio_q_P2_u_P1_of_place_25 * ratio_q_P2_u_P1_2_of_u_p1_66,
            ) + ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_2_of_u_p1_67
            - ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_2_of_u_p1_70
            + ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_2_of_u_p1_73
            - ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_75)
        - ratio_q_P2_u_P1_of_place_106 * ratio_q_P2_u_P1_of_place_109 * ratio_q_P2_u_P1_2_of_u_p1_37
        - ratio_q_P2_u_P1_of_place_108 * ratio_q_P2_u_P1_2_of_u_p1_94
        + ratio_q_P2_u_P1_of_q_p4_q_p5_16 * ratio_q_P2_u_P1_2_of_u_p1_110
        + ratio_q_P2_u_P1_of_place_31 * ratio_q_P2_u_P1_2_of_u_p1_112
        + ratio_q_P2_u_P1_of_place_110 * ratio_q_P2_u_P1_2_of_u_p1_114;
    let w_rod2_frame_12 = w_rod1_frame_in_rod2_frame_1 * w_rod1_frame_in_rod2_frame_2;
    let a_rod1_frame_in_rod2_frame_1 = (-g)
        .mul_add(sin_q_P2, a_rod1_centre_1 * cos_q_P2);
    let alpha_rod2_frame_3 = u_P1 * ratio_q_P2_u_P1_2;
    let turn_rod2_frame_12 = w_rod2_frame_12 - alpha_rod2_frame_3;
    let l_turn_rod2_frame_12 = l * turn_rod2_frame_12;
    let a_rod2_centre_1 = a_rod1_frame_in_rod2_frame_1
        .mul_add(S::int(2), -l_turn_rod2_frame_12);
    let x_rod2_frame_1 = m * a_rod2_centre_1;
    let w_rod2_frame_11 = w_rod1_frame_in_rod2_frame_1 * w_rod1_frame_in_rod2_frame_1;
    let w_rod2_frame_33 = w_rod2_frame_3 * w_rod2_frame_3;
    let turn_rod2_frame_22 = w_rod2_frame_11 + w_rod2_frame_33;
    let a_rod1_frame_in_rod2_frame_2 = a_rod1_centre_1.mul_add(sin_q_P2, g * cos_q_P2);
    let l_turn_rod2_frame_22 = l * turn_rod2_frame_22;
    let a_rod2_centre_2 = (-a_rod1_frame_in_rod2_frame_2)
        .mul_add(S::int(2), l_turn_rod2_frame_22);
    let x_rod2_frame_2 = m * a_rod2_centre_2;
    let w_rod2_frame_23 = w_rod1_frame_in_rod2_frame_2 * w_rod2_frame_3;
    let alpha_rod2_frame_1 = w_rod2_frame_23;
    let turn_rod2_frame_32 = w_rod2_frame_23 + alpha_rod2_frame_1;
    let a_rod2_centre_3 = l * turn_rod2_frame_32;
    let x_rod2_frame_3 = m * a_rod2_centre_3;
    let m_l_sq = m * l_sq;
    let H_rod2_3 = w_rod2_frame_3 * m_l_sq;
    let x_rod2_frame_1_2 = alpha_rod2_frame_1
        .mul_add(m_l_sq, w_rod1_frame_in_rod2_frame_2 * H_rod2_3);
    let H_rod2_1 = w_rod1_frame_in_rod2_frame_1 * m_l_sq;
    let x_rod2_frame_2_2 = (-w_rod1_frame_in_rod2_frame_1)
        .mul_add(H_rod2_3, w_rod2_frame_3 * H_rod2_1);
    let x_rod2_frame_3_2 = (-alpha_rod2_frame_3)
        .mul_add(m_l_sq, w_rod1_frame_in_rod2_frame_2 * H_rod2_1);
    let w_rod3_frame_1 = w_rod1_frame_in_rod2_frame_1 + u_p1_ratio_q_p3_u_p1;
    let w_rod2_frame_in_rod3_frame_3 = (-w_rod2_frame_3)
        .mul_add(cos_q_P3, w_rod1_frame_in_rod2_frame_2 * sin_q_P3);
    let w_rod3_frame_13 = w_rod3_frame_1 * w_rod2_frame_in_rod3_frame_3;
    let alpha_rod2_frame_2 = w_rod1_frame_in_rod2_frame_1 * w_rod2_frame_3;
    let alpha_rod2_frame_in_rod3_frame_2 = (-alpha_rod2_frame_3)
        .mul_add(sin_q_P3, alpha_rod2_frame_2 * cos_q_P3);
    let alpha_rod3_frame_2 = w_rod2_frame_in_rod3_frame_3
        .mul_add(u_p1_ratio_q_p3_u_p1, alpha_rod2_frame_in_rod3_frame_2);
    let turn_rod3_frame_13 = w_rod3_frame_13 + alpha_rod3_frame_2;
    let a_rod3_centre_1 = a_rod1_frame_in_rod2_frame_1 - l_turn_rod2_frame_12;
    let l_turn_rod3_frame_13 = l * turn_rod3_frame_13;
    let a_rod3_centre_1_2 = a_rod3_centre_1.mul_add(S::int(2), l_turn_rod3_frame_13);
    let x_rod3_frame_1 = m * a_rod3_centre_1_2;
    let w_rod2_frame_in_rod3_frame_2 = w_rod2_frame_3
        .mul_add(sin_q_P3, w_rod1_frame_in_rod2_frame_2 * cos_q_P3);
    let ratio_q_P3_u_P1_2_of_u_p1 = (-ratio_q_P2_u_P1_of_place_39)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_56,
            S::int(2) * ratio_q_P2_u_P1_of_place_42 * ratio_q_P2_u_P1_2_of_u_p1_51,
        ) - ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_76
        + ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_2_of_u_p1_80;
    let ratio_q_P3_u_P1_2_of_u_p1_2 = (-ratio_q_P2_u_P1_of_place_39)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_45,
            ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_u_p1_76,
        ) - ratio_q_P2_u_P1_of_place_42 * ratio_q_P2_u_P1_2_of_u_p1_47
        + ratio_q_P2_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_81;
    let ratio_q_P3_u_P1_2_of_u_p1_3 = ratio_q_P2_u_P1_2_of_u_p1_109
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_107 * ratio_q_P2_u_P1_2_of_u_p1_22);
    let ratio_q_P3_u_P1_2_of_u_p1_4 = ratio_q_P2_u_P1_of_place_101 * ratio_q_P2_u_P1_2_of_u_p1_114;
    let ratio_q_P3_u_P1_2 = ratio_q_P3_u_P1_of_place_5
        * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_15, ratio_q_P2_u_P1_2_of_u_p1)
            + ratio_q_P2_u_P1_2_of_u_p1_85 * cos_q_P5 - ratio_q_P2_u_P1_2_of_u_p1_86)
        + ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_89
        + ratio_q_P3_u_P1_of_place_3 * ratio_q_P2_u_P1_2_of_u_p1_112
        + ratio_q_P2_u_P1_of_place_102
            * ((-ratio_q_P2_u_P1_of_place_82)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_57,
                    ratio_q_P3_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_75,
                ) - ratio_q_P3_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_73
                - ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_2_of_u_p1_106
                - ratio_q_P2_u_P1_of_place_25 * ratio_q_P3_u_P1_2_of_u_p1
                + ratio_q_P2_u_P1_of_place_30 * ratio_q_P3_u_P1_2_of_u_p1_2)
        - ratio_q_P3_u_P1_of_q_p3_q_p5 * ratio_q_P3_u_P1_2_of_u_p1_3
        + ratio_q_P2_u_P1_of_place_51 * ratio_q_P3_u_P1_2_of_u_p1_4;
    let w_rod3_frame_23 = w_rod2_frame_in_rod3_frame_3 * w_rod2_frame_in_rod3_frame_2;
    let a_rod3_centre_2 = l_turn_rod2_frame_22 - a_rod1_frame_in_rod2_frame_2;
    let alpha_rod3_frame_1 = u_P1.mul_add(ratio_q_P3_u_P1_2, alpha_rod2_frame_1);
    let turn_rod3_frame_23 = w_rod3_frame_23 + alpha_rod3_frame_1;
    let a_rod2_frame_in_rod3_frame_2 = (-a_rod2_centre_3)
        .mul_add(sin_q_P3, a_rod3_centre_2 * cos_q_P3);
    let l_turn_rod3_frame_23 = l * turn_rod3_frame_23;
    let a_rod3_centre_2_2 = a_rod2_frame_in_rod3_frame_2
        .mul_add(S::int(2), l_turn_rod3_frame_23);
    let x_rod3_frame_2 = m * a_rod3_centre_2_2;
    let w_rod3_frame_11 = w_rod3_frame_1 * w_rod3_frame_1;
    let w_rod3_frame_22 = w_rod2_frame_in_rod3_frame_2 * w_rod2_frame_in_rod3_frame_2;
    let turn_rod3_frame_33 = w_rod3_frame_11 + w_rod3_frame_22;
    let a_rod2_frame_in_rod3_frame_3 = a_rod3_centre_2
        .mul_add(sin_q_P3, a_rod2_centre_3 * cos_q_P3);
    let l_turn_rod3_frame_33 = l * turn_rod3_frame_33;
    let a_rod3_centre_3 = (-a_rod2_frame_in_rod3_frame_3)
        .mul_add(S::int(2), l_turn_rod3_frame_33);
    let x_rod3_frame_3 = m * a_rod3_centre_3;
    let H_rod3_2 = w_rod2_frame_in_rod3_frame_2 * m_l_sq;
    let x_rod3_frame_1_2 = alpha_rod3_frame_1
        .mul_add(m_l_sq, w_rod2_frame_in_rod3_frame_3 * H_rod3_2);
    let H_rod3_1 = w_rod3_frame_1 * m_l_sq;
    let x_rod3_frame_2_2 = alpha_rod3_frame_2
        .mul_add(m_l_sq, w_rod2_frame_in_rod3_frame_3 * H_rod3_1);
    let x_rod3_frame_3_2 = (-w_rod2_frame_in_rod3_frame_2)
        .mul_add(H_rod3_1, w_rod3_frame_1 * H_rod3_2);
    let w_rod3_frame_in_rod4_frame_3 = (-w_rod2_frame_in_rod3_frame_3)
        .mul_add(cos_q_P4, w_rod3_frame_1 * sin_q_P4);
    let w_rod4_frame_2 = u_p1_ratio_q_p4_u_p1 - w_rod2_frame_in_rod3_frame_2;
    let w_rod4_frame_22 = w_rod4_frame_2 * w_rod4_frame_2;
    let w_rod4_frame_33 = w_rod3_frame_in_rod4_frame_3 * w_rod3_frame_in_rod4_frame_3;
    let turn_rod4_frame_11 = w_rod4_frame_22 + w_rod4_frame_33;
    let a_rod4_centre_1 = a_rod3_centre_1 + l_turn_rod3_frame_13;
    let a_rod4_centre_3 = l_turn_rod3_frame_33 - a_rod2_frame_in_rod3_frame_3;
    let a_rod3_frame_in_rod4_frame_1 = (-a_rod4_centre_1)
        .mul_add(cos_q_P4, a_rod4_centre_3 * sin_q_P4);
    let l_turn_rod4_frame_11 = l * turn_rod4_frame_11;
    let a_rod4_centre_1_2 = a_rod3_frame_in_rod4_frame_1
        .mul_add(S::int(2), l_turn_rod4_frame_11);
    let x_rod4_frame_1 = m * a_rod4_centre_1_2;
    let w_rod3_frame_in_rod4_frame_1 = w_rod2_frame_in_rod3_frame_3
        .mul_add(sin_q_P4, w_rod3_frame_1 * cos_q_P4);
    let w_rod4_frame_12 = w_rod4_frame_2 * w_rod3_frame_in_rod4_frame_1;
    let alpha_rod2_frame_in_rod3_frame_3 = alpha_rod2_frame_2
        .mul_add(sin_q_P3, alpha_rod2_frame_3 * cos_q_P3);
    let alpha_rod3_frame_3 = w_rod2_frame_in_rod3_frame_2
        .mul_add(u_p1_ratio_q_p3_u_p1, -alpha_rod2_frame_in_rod3_frame_3);
    let alpha_rod3_frame_in_rod4_frame_3 = (-alpha_rod3_frame_1)
        .mul_add(sin_q_P4, alpha_rod3_frame_3 * cos_q_P4);
    let alpha_rod4_frame_3 = w_rod3_frame_in_rod4_frame_1
        .mul_add(u_p1_ratio_q_p4_u_p1, alpha_rod3_frame_in_rod4_frame_3);
    let turn_rod4_frame_21 = w_rod4_frame_12 + alpha_rod4_frame_3;
    let a_rod4_centre_2 = a_rod2_frame_in_rod3_frame_2 + l_turn_rod3_frame_23;
    let l_turn_rod4_frame_21 = l * turn_rod4_frame_21;
    let a_rod4_centre_2_2 = (-a_rod4_centre_2).mul_add(S::int(2), l_turn_rod4_frame_21);
    let x_rod4_frame_2 = m * a_rod4_centre_2_2;
    let ratio_q_P4_u_P1_2_of_u_p1 = ratio_q_P2_u_P1_of_place_39 * ratio_q_P2_u_P1_2_of_u_p1_62
        - ratio_q_P2_u_P1_2_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_76
        + ratio_q_P2_u_P1_of_place_8
            * (-ratio_q_P2_u_P1_of_place_16)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_78,
                    cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_63,
                ) + ratio_q_P4_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_79;
    let ratio_q_P4_u_P1_2_of_u_p1_2 = ratio_q_P2_u_P1_2_of_u_p1_27 - ratio_q_P2_u_P1_2_of_u_p1_16;
    let ratio_q_P4_u_P1_2 = ratio_q_P4_u_P1_of_place_3 * ratio_q_P2_u_P1_2_of_u_p1_112
        - ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_104
        - ratio_q_P4_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_110
        + ratio_q_P2_u_P1_of_place_73 * ratio_q_P3_u_P1_2_of_u_p1_4
        + ratio_q_P2_u_P1_of_place_102
            * ((-ratio_q_P2_u_P1_of_place_82)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_66,
                    ratio_q_P2_u_P1_of_place_30 * ratio_q_P4_u_P1_2_of_u_p1,
                ) - ratio_q_P3_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_70
                - ratio_q_P4_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_75
                - ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_2_of_u_p1_106
                - ratio_q_P2_u_P1_of_place_18 * ratio_q_P3_u_P1_2_of_u_p1)
        + ratio_q_P2_u_P1_of_place_108
            * (-ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P4_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_3
                - sin_q_P4
                    * ((-ratio_q_P4_u_P1_of_q_p4_q_p5)
                        .mul_add(
                            ratio_q_P2_u_P1_2_of_u_p1_16,
                            ratio_q_P2_u_P1_2_of_u_p1_94 * sin_q_P3,
                        ) - ratio_q_P2_u_P1_2_of_u_p1_24 - ratio_q_P2_u_P1_2_of_u_p1_27)
                + ratio_q_P4_u_P1_2_of_u_p1_2);
    let w_rod4_frame_13 = w_rod3_frame_in_rod4_frame_3 * w_rod3_frame_in_rod4_frame_1;
    let alpha_rod4_frame_2 = u_P1.mul_add(ratio_q_P4_u_P1_2, alpha_rod3_frame_2);
    let turn_rod4_frame_31 = w_rod4_frame_13 + alpha_rod4_frame_2;
    let a_rod3_frame_in_rod4_frame_3 = a_rod4_centre_3
        .mul_add(cos_q_P4, a_rod4_centre_1 * sin_q_P4);
    let l_turn_rod4_frame_31 = l * turn_rod4_frame_31;
    let a_rod4_centre_3_2 = a_rod3_frame_in_rod4_frame_3
        .mul_add(S::int(2), l_turn_rod4_frame_31);
    let x_rod4_frame_3 = m * a_rod4_centre_3_2;
    let H_rod4_2 = w_rod4_frame_2 * m_l_sq;
    let H_rod4_3 = w_rod3_frame_in_rod4_frame_3 * m_l_sq;
    let x_rod4_frame_1_2 = (-w_rod3_frame_in_rod4_frame_3)
        .mul_add(H_rod4_2, w_rod4_frame_2 * H_rod4_3);
    let x_rod4_frame_2_2 = alpha_rod4_frame_2
        .mul_add(m_l_sq, w_rod3_frame_in_rod4_frame_1 * H_rod4_3);
    let x_rod4_frame_3_2 = alpha_rod4_frame_3
        .mul_add(m_l_sq, w_rod3_frame_in_rod4_frame_1 * H_rod4_2);
    let w_rod4_frame_in_rod5_frame_1 = (-w_rod4_frame_2)
        .mul_add(sin_q_P5, w_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let w_rod4_frame_in_rod5_frame_2 = w_rod3_frame_in_rod4_frame_1
        .mul_add(sin_q_P5, w_rod4_frame_2 * cos_q_P5);
    let ratio_q_P5_u_P1_2 = ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_105
        + ratio_q_P5_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_112
        - ratio_q_P5_u_P1_of_place_2 * ratio_q_P3_u_P1_2_of_u_p1_3
        + ratio_q_P2_u_P1_of_place_80 * ratio_q_P3_u_P1_2_of_u_p1_4
        + ratio_q_P2_u_P1_of_place_102
            * ((-ratio_q_P2_u_P1_of_place_82)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_67,
                    ratio_q_P2_u_P1_of_place_18 * ratio_q_P3_u_P1_2_of_u_p1_2,
                ) - ratio_q_P3_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_70
                - ratio_q_P4_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_73
                - ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_106
                - ratio_q_P2_u_P1_of_place_25 * ratio_q_P4_u_P1_2_of_u_p1)
        + ratio_q_P3_u_P1_of_place_5
            * (ratio_q_P5_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3
                - ratio_q_P5_u_P1_of_q_p3_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1
                + sin_q_P4
                    * ((-(ratio_q_P2_u_P1_2_of_u_p1_2 * sin_q_P3))
                        .mul_add(
                            S::int(2),
                            ratio_q_P2_u_P1_of_q_p5_4 * ratio_q_P2_u_P1_2_of_u_p1_16,
                        ) + ratio_q_P2_u_P1_2_of_u_p1_33)
                + ratio_q_P2_u_P1_of_q_p5 * ratio_q_P4_u_P1_2_of_u_p1_2);
    let w_rod5_frame_12 = w_rod4_frame_in_rod5_frame_1 * w_rod4_frame_in_rod5_frame_2;
    let alpha_rod5_frame_3 = u_P1.mul_add(ratio_q_P5_u_P1_2, alpha_rod4_frame_3);
    let turn_rod5_frame_12 = w_rod5_frame_12 - alpha_rod5_frame_3;
    let a_rod5_centre_1 = a_rod3_frame_in_rod4_frame_1 + l_turn_rod4_frame_11;
    let a_rod5_centre_2 = l_turn_rod4_frame_21 - a_rod4_centre_2;
    let a_rod4_frame_in_rod5_frame_1 = a_rod5_centre_2
        .mul_add(sin_q_P5, a_rod5_centre_1 * cos_q_P5);
    let a_rod5_centre_1_2 = a_rod4_frame_in_rod5_frame_1
        .mul_add(S::int(2), l * turn_rod5_frame_12);
    let x_rod5_frame_1 = m * a_rod5_centre_1_2;
    let w_rod5_frame_3 = u_p1_ratio_q_p5_u_p1 - w_rod3_frame_in_rod4_frame_3;
    let w_rod5_frame_11 = w_rod4_frame_in_rod5_frame_1 * w_rod4_frame_in_rod5_frame_1;
    let w_rod5_frame_33 = w_rod5_frame_3 * w_rod5_frame_3;
    let turn_rod5_frame_22 = w_rod5_frame_11 + w_rod5_frame_33;
    let a_rod4_frame_in_rod5_frame_2 = (-a_rod5_centre_2)
        .mul_add(cos_q_P5, a_rod5_centre_1 * sin_q_P5);
    let a_rod5_centre_2_2 = (-a_rod4_frame_in_rod5_frame_2)
        .mul_add(S::int(2), l * turn_rod5_frame_22);
    let x_rod5_frame_2 = m * a_rod5_centre_2_2;
    let w_rod5_frame_23 = w_rod4_frame_in_rod5_frame_2 * w_rod5_frame_3;
    let alpha_rod3_frame_in_rod4_frame_1 = alpha_rod3_frame_3
        .mul_add(sin_q_P4, alpha_rod3_frame_1 * cos_q_P4);
    let alpha_rod4_frame_1 = w_rod3_frame_in_rod4_frame_3
        .mul_add(u_p1_ratio_q_p4_u_p1, alpha_rod3_frame_in_rod4_frame_1);
    let alpha_rod4_frame_in_rod5_frame_1 = (-alpha_rod4_frame_2)
        .mul_add(sin_q_P5, alpha_rod4_frame_1 * cos_q_P5);
    let alpha_rod5_frame_1 = w_rod4_frame_in_rod5_frame_2
        .mul_add(u_p1_ratio_q_p5_u_p1, alpha_rod4_frame_in_rod5_frame_1);
    let turn_rod5_frame_32 = w_rod5_frame_23 + alpha_rod5_frame_1;
    let a_rod5_centre_3 = a_rod3_frame_in_rod4_frame_3 + l_turn_rod4_frame_31;
    let a_rod5_centre_3_2 = a_rod5_centre_3.mul_add(S::int(2), l * turn_rod5_frame_32);
    let x_rod5_frame_3 = m * a_rod5_centre_3_2;
    let H_rod5_3 = w_rod5_frame_3 * m_l_sq;
    let x_rod5_frame_1_2 = alpha_rod5_frame_1
        .mul_add(m_l_sq, w_rod4_frame_in_rod5_frame_2 * H_rod5_3);
    let H_rod5_1 = w_rod4_frame_in_rod5_frame_1 * m_l_sq;
    let x_rod5_frame_2_2 = (-w_rod4_frame_in_rod5_frame_1)
        .mul_add(H_rod5_3, w_rod5_frame_3 * H_rod5_1);
    let x_rod5_frame_3_2 = (-alpha_rod5_frame_3)
        .mul_add(m_l_sq, w_rod4_frame_in_rod5_frame_2 * H_rod5_1);
    // Values.
    let f_1 = S::ratio(1, 2) * x_rod1_frame_1;
    let f_2 = -x_rod1_frame_2;
    let f_7 = S::ratio(1, 2) * x_rod2_frame_1;
    let f_8 = S::ratio(1, 2) * x_rod2_frame_2;
    let f_9 = -S::ratio(1, 2) * x_rod2_frame_3;
    let f_10 = -S::ratio(1, 12) * x_rod2_frame_1_2;
    let f_11 = -S::ratio(1, 12) * x_rod2_frame_2_2;
    let f_12 = S::ratio(1, 12) * x_rod2_frame_3_2;
    let f_13 = S::ratio(1, 2) * x_rod3_frame_1;
    let f_14 = S::ratio(1, 2) * x_rod3_frame_2;
    let f_15 = S::ratio(1, 2) * x_rod3_frame_3;
    let f_16 = -S::ratio(1, 12) * x_rod3_frame_1_2;
    let f_17 = S::ratio(1, 12) * x_rod3_frame_2_2;
    let f_18 = -S::ratio(1, 12) * x_rod3_frame_3_2;
    let f_19 = -S::ratio(1, 2) * x_rod4_frame_1;
    let f_20 = -S::ratio(1, 2) * x_rod4_frame_2;
    let f_21 = S::ratio(1, 2) * x_rod4_frame_3;
    let f_22 = S::ratio(1, 12) * x_rod4_frame_1_2;
    let f_23 = S::ratio(1, 12) * x_rod4_frame_2_2;
    let f_24 = S::ratio(1, 12) * x_rod4_frame_3_2;
    let f_25 = -S::ratio(1, 2) * x_rod5_frame_1;
    let f_26 = -S::ratio(1, 2) * x_rod5_frame_2;
    let f_27 = S::ratio(1, 2) * x_rod5_frame_3;
    let f_28 = -S::ratio(1, 12) * x_rod5_frame_1_2;
    let f_29 = S::ratio(1, 12) * x_rod5_frame_2_2;
    let f_30 = -S::ratio(1, 12) * x_rod5_frame_3_2;
    let zero = S::int(0);
    [
        f_1, f_2, zero, zero, zero, zero, f_7, f_8, f_9, f_10, f_11, f_12, f_13, f_14, f_15, f_16,
        f_17, f_18, f_19, f_20, f_21, f_22, f_23, f_24, f_25, f_26, f_27, f_28, f_29, f_30,
    ]
}

/// The accelerations (u_P1'), solved for when this code was generated.
///
/// 1610 operations, 5 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 1]) -> [S; 1] {
    let Parameters { l, m, g } = *p;
    let [q_P1, q_P2, q_P3, q_P4, q_P5] = *q;
    let [u_P1] = *u;
    // Sines and cosines.
    let (sin_q_P5, cos_q_P5) = q_P5.sin_cos();
    let (sin_q_P4, cos_q_P4) = q_P4.sin_cos();
    let (sin_q_P2, cos_q_P2) = q_P2.sin_cos();
    let (sin_q_P3, cos_q_P3) = q_P3.sin_cos();
    let (sin_q_P1, cos_q_P1) = q_P1.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_rod1_frame_22 = u_P1 * u_P1;
    let a_rod1_centre_1 = l * w_rod1_frame_22;
    let ratio_q_P2_u_P1_of_q_p5 = S::int(1) - sin_q_P5;
    let ratio_q_P2_u_P1_of_q_p5_2 = -ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5 = ratio_q_P2_u_P1_of_q_p5_2 * sin_q_P4;
    let cos_q_p2_cos_q_p4 = cos_q_P2 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p3_q_p5 = ratio_q_P2_u_P1_of_q_p5_2 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place = (-ratio_q_P2_u_P1_of_q_p4_q_p5)
        .mul_add(sin_q_P2, cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p3_q_p5);
    let sin_q_p3_cos_q_p1 = cos_q_P1 * sin_q_P3;
    let sin_q_p2_sin_q_p1 = sin_q_P1 * sin_q_P2;
    let ratio_q_P2_u_P1_of_place_2 = sin_q_p2_sin_q_p1
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p1);
    let sin_q_p2_sin_q_p3 = sin_q_P2 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_3 = sin_q_p2_sin_q_p3
        .mul_add(sin_q_P4, -cos_q_p2_cos_q_p4);
    let cos_q_p3_cos_q_p1 = cos_q_P1 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_4 = (-ratio_q_P2_u_P1_of_place_3)
        .mul_add(sin_q_P1, cos_q_p3_cos_q_p1 * sin_q_P4);
    let ratio_q_P2_u_P1_of_place_5 = l
        * ratio_q_P2_u_P1_of_place_4
            .mul_add(sin_q_P5, ratio_q_P2_u_P1_of_place_2 * cos_q_P5);
    let sin_q_p3_cos_q_p5 = sin_q_P3 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_6 = sin_q_p3_cos_q_p5
        .mul_add(sin_q_P4, cos_q_P3 * sin_q_P5);
    let sin_q_p2_cos_q_p4 = sin_q_P2 * cos_q_P4;
    let ratio_q_P2_u_P1_of_place_7 = sin_q_p2_cos_q_p4
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_6 * cos_q_P2);
    let ratio_q_P2_u_P1_of_place_8 = l * ratio_q_P2_u_P1_of_place_7;
    let cos_q_p2_sin_q_p4 = cos_q_P2 * sin_q_P4;
    let ratio_q_P2_u_P1_of_place_9 = sin_q_p2_cos_q_p4
        .mul_add(sin_q_P3, cos_q_p2_sin_q_p4);
    let ratio_q_P2_u_P1_of_place_10 = cos_q_p3_cos_q_p1 * cos_q_P4;
    let ratio_q_P2_u_P1_of_place_11 = (-ratio_q_P2_u_P1_of_place_9)
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_10);
    let ratio_q_P2_u_P1_of_place_12 = ratio_q_P2_u_P1_of_place_11 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_13 = ratio_q_P2_u_P1_of_place_8
        .mul_add(
            ratio_q_P2_u_P1_of_place_12,
            ratio_q_P2_u_P1_of_place * ratio_q_P2_u_P1_of_place_5,
        );
    let cos_q_p3_cos_q_p5 = cos_q_P3 * cos_q_P5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_2 = ratio_q_P2_u_P1_of_q_p4_q_p5 - S::int(1);
    let ratio_q_P2_u_P1_of_place_14 = ratio_q_P2_u_P1_of_q_p4_q_p5_2 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_15 = cos_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_place_14;
    let ratio_q_P2_u_P1_of_place_16 = ratio_q_P2_u_P1_of_q_p4_q_p5_2
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p5);
    let ratio_q_P2_u_P1_of_place_17 = ratio_q_P2_u_P1_of_place_16 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_18 = l
        * ratio_q_P2_u_P1_of_place_17
            .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_place_15 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_19 = (-sin_q_P3)
        .mul_add(sin_q_P5, cos_q_p3_cos_q_p5 * sin_q_P4);
    let ratio_q_P2_u_P1_of_place_20 = sin_q_p2_sin_q_p1
        .mul_add(ratio_q_P2_u_P1_of_place_19, ratio_q_P2_u_P1_of_place_6 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_21 = ratio_q_P2_u_P1_of_place_16 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_22 = (-ratio_q_P2_u_P1_of_place_8)
        .mul_add(
            ratio_q_P2_u_P1_of_place_20,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_21,
        );
    let ratio_q_P2_u_P1_of_place_23 = ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_24 = ratio_q_P2_u_P1_of_q_p3_q_p5
        .mul_add(sin_q_p2_cos_q_p4, ratio_q_P2_u_P1_of_place_23);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_2 = ratio_q_P2_u_P1_of_q_p5_2 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_25 = l
        * (ratio_q_P2_u_P1_of_q_p3_q_p5_2 * sin_q_P1)
            .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_24 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_26 = l * ratio_q_P2_u_P1_of_place_12;
    let ratio_q_P2_u_P1_of_place_27 = l * ratio_q_P2_u_P1_of_place;
    let ratio_q_P2_u_P1_of_place_28 = ratio_q_P2_u_P1_of_place_20
        .mul_add(
            ratio_q_P2_u_P1_of_place_27,
            ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_of_place_26,
        );
    let ratio_q_P2_u_P1_of_place_29 = (-ratio_q_P2_u_P1_of_place_6)
        .mul_add(sin_q_P2, cos_q_p2_cos_q_p4 * cos_q_P5);
    let ratio_q_P2_u_P1_of_place_30 = l
        * (-ratio_q_P2_u_P1_of_place_29)
            .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_19 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_31 = (-ratio_q_P2_u_P1_of_place_22)
        .mul_add(
            ratio_q_P2_u_P1_of_place_25,
            ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_of_place_18,
        ) - ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_of_place_30;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_3 = S::int(1) - cos_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_32 = -ratio_q_P2_u_P1_of_place_14 - ratio_q_P2_u_P1_of_q_p3_q_p5_3;
    let ratio_q_P2_u_P1_of_place_33 = ratio_q_P2_u_P1_of_place_32
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p2_cos_q_p4);
    let ratio_q_P2_u_P1_of_place_34 = S::int(1) + ratio_q_P2_u_P1_of_place_33;
    let ratio_q_P2_u_P1_of_place_35 = (-ratio_q_P2_u_P1_of_place_16)
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_34 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_36 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_of_place_10, ratio_q_P2_u_P1_of_place_24 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_37 = ratio_q_P2_u_P1_of_place_29
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_19 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_38 = (-ratio_q_P2_u_P1_of_place_26)
        .mul_add(
            ratio_q_P2_u_P1_of_place_37,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_36,
        );
    let ratio_q_P2_u_P1_of_place_39 = l * ratio_q_P2_u_P1_of_place_33;
    let ratio_q_P2_u_P1_of_place_40 = ratio_q_P2_u_P1_of_q_p5_2 * sin_q_p2_cos_q_p4;
    let ratio_q_P2_u_P1_of_place_41 = ratio_q_P2_u_P1_of_place_32
        .mul_add(cos_q_P2, -ratio_q_P2_u_P1_of_place_40);
    let ratio_q_P2_u_P1_of_place_42 = ratio_q_P2_u_P1_of_place_8 * sin_q_P1;
    let ratio_q_P2_u_P1_of_place_43 = (-ratio_q_P2_u_P1_of_place_37)
        .mul_add(
            ratio_q_P2_u_P1_of_place_42,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_41 * sin_q_P1,
        );
    let cos_q_p2_sin_q_p1 = sin_q_P1 * cos_q_P2;
    let ratio_q_P2_u_P1_of_q_p3 = sin_q_P3 - S::int(1);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_4 = (-ratio_q_P2_u_P1_of_q_p3)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_q_p3_q_p5_2);
    let ratio_q_P2_u_P1_of_place_44 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_q_p3_q_p5 * sin_q_p2_sin_q_p1);
    let ratio_q_P2_u_P1_of_place_45 = ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_p2_sin_q_p1;
    let ratio_q_P2_u_P1_of_place_46 = ratio_q_P2_u_P1_of_place_44
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_45);
    let ratio_q_P2_u_P1_of_place_47 = sin_q_p2_cos_q_p4
        .mul_add(ratio_q_P2_u_P1_of_q_p3, cos_q_p2_sin_q_p4);
    let ratio_q_P2_u_P1_of_place_48 = (-ratio_q_P2_u_P1_of_place_47)
        .mul_add(sin_q_P3, cos_q_p2_sin_q_p4);
    let cos_q_p5_sin_q_p1 = sin_q_P1 * cos_q_P5;
    let l_sq = l * l;
    let ratio_q_P2_u_P1_of_place_49 = l_sq
        * ratio_q_P2_u_P1_of_place_48
            .mul_add(cos_q_p5_sin_q_p1, ratio_q_P2_u_P1_of_place_46 * cos_q_P3);
    let ratio_q_P2_u_P1_of_place_50 = cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_of_place_49;
    let ratio_q_P2_u_P1_of_place_51 = ratio_q_P2_u_P1_of_place_27
        .mul_add(
            ratio_q_P2_u_P1_of_place_43,
            ratio_q_P2_u_P1_of_place_38 * ratio_q_P2_u_P1_of_place_39,
        ) + ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_50;
    let ratio_q_P2_u_P1_of_q_p4 = S::int(1) + sin_q_P4;
    let cos_q_p4_sq = cos_q_P4 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_2 = ratio_q_P2_u_P1_of_q_p4 - cos_q_p4_sq;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_3 = ratio_q_P2_u_P1_of_q_p4_2
        .mul_add(sin_q_P5, cos_q_p4_sq);
    let ratio_q_P2_u_P1_of_place_52 = ratio_q_P2_u_P1_of_q_p4_q_p5_3 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_53 = (-cos_q_p3_cos_q_p5)
        .mul_add(ratio_q_P2_u_P1_of_q_p4, ratio_q_P2_u_P1_of_place_52);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_4 = sin_q_P5 + ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_place_54 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p4_q_p5_4;
    let ratio_q_P2_u_P1_of_place_55 = ratio_q_P2_u_P1_of_place_53
        .mul_add(sin_q_P2, -ratio_q_P2_u_P1_of_place_54);
    let ratio_q_P2_u_P1_of_place_56 = ratio_q_P2_u_P1_of_q_p4_q_p5_3 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_57 = sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_of_q_p4;
    let ratio_q_P2_u_P1_of_place_58 = ratio_q_P2_u_P1_of_place_57
        .mul_add(S::int(2), ratio_q_P2_u_P1_of_place_56);
    let ratio_q_P2_u_P1_of_place_59 = (-ratio_q_P2_u_P1_of_place_58)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_55 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_60 = ratio_q_P2_u_P1_of_place_59
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_of_place_52);
    let ratio_q_P2_u_P1_of_place_61 = (-sin_q_p3_cos_q_p1)
        .mul_add(ratio_q_P2_u_P1_of_place_54, ratio_q_P2_u_P1_of_place_60 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_62 = ratio_q_P2_u_P1_of_place_56 + ratio_q_P2_u_P1_of_place_57;
    let ratio_q_P2_u_P1_of_place_63 = ratio_q_P2_u_P1_of_place_62 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_64 = (-sin_q_p3_cos_q_p1)
        .mul_add(ratio_q_P2_u_P1_of_place_63, ratio_q_P2_u_P1_of_place_61 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_65 = ratio_q_P2_u_P1_of_place_33 * l_sq;
    let ratio_q_P2_u_P1_of_place_66 = l * ratio_q_P2_u_P1_of_place_21;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_5 = cos_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_place_67 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_5)
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_q_p3 * sin_q_P5);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_6 = ratio_q_P2_u_P1_of_q_p3_q_p5 + cos_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_68 = (-sin_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_of_q_p3_q_p5_6, ratio_q_P2_u_P1_of_place_67 * cos_q_P2);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_7 = sin_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_2;
    let ratio_q_P2_u_P1_of_place_69 = ratio_q_P2_u_P1_of_q_p3_q_p5_7 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_70 = (-ratio_q_P2_u_P1_of_place_69)
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_68 * sin_q_P1);
    let cos_q_p2_cos_q_p1 = cos_q_P1 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_71 = (-ratio_q_P2_u_P1_of_place_6)
        .mul_add(cos_q_p2_cos_q_p1, ratio_q_P2_u_P1_of_place_70 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_72 = l_sq * ratio_q_P2_u_P1_of_place_71 * sin_q_P1;
    let ratio_q_P2_u_P1_of_place_73 = ratio_q_P2_u_P1_of_place_43
        .mul_add(
            ratio_q_P2_u_P1_of_place_66,
            ratio_q_P2_u_P1_of_place_64 * ratio_q_P2_u_P1_of_place_65,
        ) - ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_72;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_8 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_2)
        .mul_add(S::int(2), sin_q_p3_cos_q_p5);
    let ratio_q_P2_u_P1_of_place_74 = ratio_q_P2_u_P1_of_q_p3_q_p5_8
        .mul_add(cos_q_P1, sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_of_q_p3_q_p5_6);
    let ratio_q_P2_u_P1_of_place_75 = ratio_q_P2_u_P1_of_place_74
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_45);
    let ratio_q_P2_u_P1_of_place_76 = (-cos_q_p2_sin_q_p1)
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_place_10);
    let ratio_q_P2_u_P1_of_place_77 = (-cos_q_p3_cos_q_p5)
        .mul_add(ratio_q_P2_u_P1_of_place_76, ratio_q_P2_u_P1_of_place_75 * sin_q_P3);
    let ratio_q_P2_u_P1_of_place_78 = ratio_q_P2_u_P1_of_place_77
        .mul_add(sin_q_P2, cos_q_p2_sin_q_p4 * ratio_q_P2_u_P1_of_place_69);
    let ratio_q_P2_u_P1_of_place_79 = (-ratio_q_P2_u_P1_of_place_10)
        .mul_add(ratio_q_P2_u_P1_of_place_69, ratio_q_P2_u_P1_of_place_78 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_80 = ratio_q_P2_u_P1_of_place
        .mul_add(
            ratio_q_P2_u_P1_of_place_72,
            ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_of_place_50,
        ) + ratio_q_P2_u_P1_of_place_65 * ratio_q_P2_u_P1_of_place_79;
    let ratio_q_P2_u_P1_of_place_81 = l * ratio_q_P2_u_P1_of_place_41;
    let ratio_q_P2_u_P1_of_place_82 = ratio_q_P2_u_P1_of_place_81 * cos_q_P1;
    let cos_q_p5_sq = cos_q_P5 * cos_q_P5;
    let ratio_q_P2_u_P1_of_q_p5_3 = ratio_q_P2_u_P1_of_q_p5
        .mul_add(S::int(2), -cos_q_p5_sq);
    let ratio_q_P2_u_P1_of_q_p5_4 = -ratio_q_P2_u_P1_of_q_p5_3;
    let cos_q_p4_sq_doubled = S::int(2) * cos_q_p4_sq;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_5 = ratio_q_P2_u_P1_of_q_p5_4 * cos_q_p4_sq_doubled;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_6 = -ratio_q_P2_u_P1_of_q_p5 - ratio_q_P2_u_P1_of_q_p4_q_p5_5;
    let ratio_q_P2_u_P1_of_q_p5_5 = ratio_q_P2_u_P1_of_q_p5 - cos_q_p5_sq;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_7 = cos_q_p4_sq * ratio_q_P2_u_P1_of_q_p5_4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_8 = -ratio_q_P2_u_P1_of_q_p5_5
        - ratio_q_P2_u_P1_of_q_p4_q_p5_7;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_9 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(cos_q_p4_sq, ratio_q_P2_u_P1_of_q_p4_q_p5_8 * sin_q_P4);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_10 = ratio_q_P2_u_P1_of_q_p4_q_p5_9
        - ratio_q_P2_u_P1_of_q_p5_5;
    let ratio_q_P2_u_P1_of_q_p4_3 = ratio_q_P2_u_P1_of_q_p4 - cos_q_p4_sq_doubled;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_11 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_of_q_p4_3;
    let ratio_q_P2_u_P1_of_place_83 = sin_q_p3_cos_q_p5
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_11,
            ratio_q_P2_u_P1_of_q_p4_q_p5_10 * cos_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_84 = ratio_q_P2_u_P1_of_place_83 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_85 = ratio_q_P2_u_P1_of_q_p4_q_p5_6
        .mul_add(sin_q_P4, -ratio_q_P2_u_P1_of_q_p5)
        - ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p4_sq_doubled - ratio_q_P2_u_P1_of_place_84;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_12 = S::int(2) * ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_13 = (-ratio_q_P2_u_P1_of_q_p5)
        .mul_add(S::int(3), cos_q_p5_sq) - ratio_q_P2_u_P1_of_q_p4_q_p5_5
        + ratio_q_P2_u_P1_of_q_p4_q_p5_12;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_14 = ratio_q_P2_u_P1_of_q_p4_q_p5_12 - ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_place_86 = cos_q_p3_cos_q_p5
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_14,
            ratio_q_P2_u_P1_of_q_p4_q_p5_13 * sin_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_87 = sin_q_p2_cos_q_p4
        .mul_add(ratio_q_P2_u_P1_of_place_86, ratio_q_P2_u_P1_of_place_85 * cos_q_P2);
    let ratio_q_P2_u_P1_of_place_88 = (-ratio_q_P2_u_P1_of_place_84)
        .mul_add(S::int(2), ratio_q_P2_u_P1_of_q_p4_q_p5_10)
        - ratio_q_P2_u_P1_of_place_87 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_89 = (-cos_q_p3_cos_q_p5)
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_11,
            ratio_q_P2_u_P1_of_q_p4_q_p5_10 * sin_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_90 = ratio_q_P2_u_P1_of_place_89 * sin_q_P2;
    let ratio_q_P2_u_P1_of_place_91 = (-cos_q_p2_cos_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_13,
            S::int(2) * ratio_q_P2_u_P1_of_place_90,
        );
    let ratio_q_P2_u_P1_of_place_92 = cos_q_p2_cos_q_p4 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_93 = ratio_q_P2_u_P1_of_q_p4_q_p5_14
        .mul_add(
            ratio_q_P2_u_P1_of_place_92,
            ratio_q_P2_u_P1_of_q_p4_q_p5_11 * sin_q_P2,
        );
    let ratio_q_P2_u_P1_of_place_94 = ratio_q_P2_u_P1_of_place_93
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_91 * cos_q_P3);
    let ratio_q_P2_u_P1_of_place_95 = (-ratio_q_P2_u_P1_of_place_94)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_88 * sin_q_P1);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_15 = ratio_q_P2_u_P1_of_q_p4_q_p5
        - ratio_q_P2_u_P1_of_q_p5_3 - ratio_q_P2_u_P1_of_q_p4_q_p5_7;
    let ratio_q_P2_u_P1_of_place_96 = (-cos_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_of_q_p4_q_p5_15, ratio_q_P2_u_P1_of_place_90);
    let ratio_q_P2_u_P1_of_place_97 = ratio_q_P2_u_P1_of_place_23
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_place_40);
    let cos_q_p4_cos_q_p5 = cos_q_P4 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_98 = ratio_q_P2_u_P1_of_place_96
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_of_place_95 * cos_q_P1)
        + ratio_q_P2_u_P1_of_place_97 * cos_q_p4_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_99 = l_sq * ratio_q_P2_u_P1_of_place_98;
    let ratio_q_P2_u_P1_of_place_100 = S::int(1)
        / ((-ratio_q_P2_u_P1_of_place_18)
            .mul_add(
                ratio_q_P2_u_P1_of_place_51,
                ratio_q_P2_u_P1_of_place_25 * ratio_q_P2_u_P1_of_place_73,
            ) + ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_of_place_80
            + ratio_q_P2_u_P1_of_place_82 * ratio_q_P2_u_P1_of_place_99);
    let ratio_q_P2_u_P1_of_place_101 = l * ratio_q_P2_u_P1_of_place_100;
    let ratio_q_P2_u_P1_of_place_102 = ratio_q_P2_u_P1_of_place_35 * ratio_q_P2_u_P1_of_place_101;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_16 = ratio_q_P2_u_P1_of_q_p4_q_p5 - ratio_q_P2_u_P1_of_q_p5;
    let sin_q_p3_sin_q_p1 = sin_q_P1 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_103 = (-cos_q_p3_cos_q_p1)
        .mul_add(sin_q_P2, sin_q_p3_sin_q_p1);
    let cos_q_p3_sin_q_p4 = cos_q_P3 * sin_q_P4;
    let ratio_q_P2_u_P1_of_place_104 = cos_q_p3_sin_q_p4
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_3 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_105 = (-ratio_q_P2_u_P1_of_place_104)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_103 * sin_q_P5);
    let ratio_q_P2_u_P1_of_place_106 = l_sq * ratio_q_P2_u_P1_of_place_101;
    let ratio_q_P2_u_P1_of_place_107 = ratio_q_P2_u_P1_of_place_105 * ratio_q_P2_u_P1_of_place_106;
    let ratio_q_P2_u_P1_of_place_108 = ratio_q_P2_u_P1_of_place_107 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_109 = ratio_q_P2_u_P1_of_place_34
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_17);
    let ratio_q_P2_u_P1_of_place_110 = ratio_q_P2_u_P1_of_place_98 * ratio_q_P2_u_P1_of_place_106;
    let ratio_q_P2_u_P1 = ratio_q_P2_u_P1_of_q_p4_q_p5_16
        .mul_add(
            ratio_q_P2_u_P1_of_place_108,
            ratio_q_P2_u_P1_of_place_31 * ratio_q_P2_u_P1_of_place_102,
        ) + ratio_q_P2_u_P1_of_place_109 * ratio_q_P2_u_P1_of_place_110;
    let ratio_q_P3_u_P1_of_place = (-ratio_q_P2_u_P1_of_place_7)
        .mul_add(
            ratio_q_P2_u_P1_of_place_42,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_33,
        );
    let ratio_q_P3_u_P1_of_place_2 = ratio_q_P2_u_P1_of_place
        .mul_add(
            ratio_q_P2_u_P1_of_place_42,
            ratio_q_P2_u_P1_of_place_12 * ratio_q_P2_u_P1_of_place_39,
        );
    let ratio_q_P3_u_P1_of_place_3 = ratio_q_P2_u_P1_of_place_25
        .mul_add(
            ratio_q_P3_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_of_place_82,
        ) + ratio_q_P2_u_P1_of_place_30 * ratio_q_P3_u_P1_of_place_2;
    let ratio_q_P3_u_P1_of_place_4 = ratio_q_P2_u_P1_of_place_101 * ratio_q_P2_u_P1_of_place_109;
    let ratio_q_P3_u_P1_of_q_p3_q_p5 = ratio_q_P2_u_P1_of_q_p3_q_p5_4
        .mul_add(cos_q_P5, -ratio_q_P2_u_P1_of_q_p5) - ratio_q_P2_u_P1_of_q_p3_q_p5;
    let ratio_q_P3_u_P1_of_place_5 = ratio_q_P2_u_P1_of_place_107 * cos_q_P4;
    let ratio_q_P3_u_P1 = ratio_q_P2_u_P1_of_place_51
        .mul_add(
            ratio_q_P3_u_P1_of_place_4,
            ratio_q_P2_u_P1_of_place_102 * ratio_q_P3_u_P1_of_place_3,
        ) - ratio_q_P3_u_P1_of_q_p3_q_p5 * ratio_q_P3_u_P1_of_place_5;
    let ratio_q_P4_u_P1_of_place = ratio_q_P2_u_P1_of_place_16 * cos_q_p2_sin_q_p1;
    let ratio_q_P4_u_P1_of_place_2 = (-ratio_q_P2_u_P1_of_place_8)
        .mul_add(
            ratio_q_P4_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_20 * ratio_q_P2_u_P1_of_place_39,
        );
    let ratio_q_P4_u_P1_of_place_3 = ratio_q_P2_u_P1_of_place_18
        .mul_add(
            ratio_q_P3_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_of_place_82,
        ) - ratio_q_P2_u_P1_of_place_30 * ratio_q_P4_u_P1_of_place_2;
    let ratio_q_P4_u_P1_of_q_p4_q_p5 = ratio_q_P2_u_P1_of_q_p4_q_p5_4 - S::int(2);
    let ratio_q_P4_u_P1_of_place_4 = (-ratio_q_P4_u_P1_of_q_p4_q_p5)
        .mul_add(
            sin_q_P3,
            ratio_q_P2_u_P1_of_q_p4_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_3,
        );
    let ratio_q_P4_u_P1_of_place_5 = ratio_q_P4_u_P1_of_place_4
        .mul_add(sin_q_P4, sin_q_P3 - sin_q_P5 + cos_q_p3_cos_q_p5);
    let ratio_q_P4_u_P1 = ratio_q_P2_u_P1_of_place_102
        .mul_add(
            ratio_q_P4_u_P1_of_place_3,
            ratio_q_P2_u_P1_of_place_73 * ratio_q_P3_u_P1_of_place_4,
        ) - ratio_q_P2_u_P1_of_place_108 * ratio_q_P4_u_P1_of_place_5;
    let ratio_q_P5_u_P1_of_place = ratio_q_P2_u_P1_of_place_18
        .mul_add(
            ratio_q_P3_u_P1_of_place_2,
            ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_of_place_82,
        ) + ratio_q_P2_u_P1_of_place_25 * ratio_q_P4_u_P1_of_place_2;
    let ratio_q_P5_u_P1_of_q_p3_q_p5 = (-ratio_q_P2_u_P1_of_q_p5_4)
        .mul_add(sin_q_P3, -ratio_q_P2_u_P1_of_q_p5_3);
    let ratio_q_P5_u_P1_of_q_p3_q_p5_2 = sin_q_P3 - ratio_q_P2_u_P1_of_q_p3_q_p5_3;
    let ratio_q_P5_u_P1_of_place_2 = ratio_q_P2_u_P1_of_q_p5
        .mul_add(
            ratio_q_P5_u_P1_of_q_p3_q_p5_2,
            ratio_q_P5_u_P1_of_q_p3_q_p5 * sin_q_P4,
        );
    let ratio_q_P5_u_P1 = ratio_q_P2_u_P1_of_place_102
        .mul_add(
            ratio_q_P5_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_80 * ratio_q_P3_u_P1_of_place_4,
        ) - ratio_q_P3_u_P1_of_place_5 * ratio_q_P5_u_P1_of_place_2;
    let w_rod1_frame_in_rod2_frame_1 = u_P1 * sin_q_P2;
    let w_rod1_frame_in_rod2_frame_2 = u_P1 * cos_q_P2;
    let u_p1_ratio_q_p5_u_p1 = u_P1 * ratio_q_P5_u_P1;
    let ratio_q_P2_u_P1_2_of_u_p1 = u_p1_ratio_q_p5_u_p1 * cos_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_2 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_2_of_u_p1;
    let u_p1_cos_q_p4 = u_P1 * cos_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_3 = ratio_q_P4_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_4 = ratio_q_P2_u_P1_2_of_u_p1_3 * sin_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_5 = (-cos_q_p4_sq)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_2,
            ratio_q_P2_u_P1_of_q_p5_4 * ratio_q_P2_u_P1_2_of_u_p1_4,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_6 = ratio_q_P5_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_7 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_12)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_3,
            cos_q_p4_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_6,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_8 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_9 = ratio_q_P2_u_P1_2_of_u_p1_8 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_10 = ratio_q_P2_u_P1_2_of_u_p1_9 - ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_11 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_5;
    let ratio_q_P2_u_P1_2_of_u_p1_12 = sin_q_P4
        * (ratio_q_P2_u_P1_2_of_u_p1_11 - ratio_q_P2_u_P1_2_of_u_p1_10)
        + ratio_q_P2_u_P1_of_q_p4_q_p5_8 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_13 = ratio_q_P2_u_P1_2_of_u_p1_7 + ratio_q_P2_u_P1_2_of_u_p1_10;
    let ratio_q_P2_u_P1_2_of_u_p1_14 = ratio_q_P2_u_P1_2_of_u_p1_12 - ratio_q_P2_u_P1_2_of_u_p1_13;
    let ratio_q_P2_u_P1_2_of_u_p1_15 = u_p1_ratio_q_p5_u_p1 * sin_q_P5;
    let u_p1_ratio_q_p3_u_p1 = u_P1 * ratio_q_P3_u_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_16 = u_p1_ratio_q_p3_u_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_17 = ratio_q_P2_u_P1_2_of_u_p1_16 * cos_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_18 = ratio_q_P2_u_P1_2_of_u_p1_15
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_17);
    let ratio_q_P2_u_P1_2_of_u_p1_19 = u_p1_ratio_q_p3_u_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_20 = ratio_q_P2_u_P1_of_q_p5
        * ratio_q_P2_u_P1_2_of_u_p1_4.mul_add(S::int(4), ratio_q_P2_u_P1_2_of_u_p1_3)
        - ratio_q_P2_u_P1_of_q_p4_3 * ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_21 = cos_q_P3
        * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_11)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_18,
                ratio_q_P2_u_P1_2_of_u_p1_14 * cos_q_P3,
            ) + ratio_q_P2_u_P1_of_q_p4_q_p5_10 * ratio_q_P2_u_P1_2_of_u_p1_19
            + sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_20)
        + ratio_q_P2_u_P1_of_place_83 * ratio_q_P2_u_P1_2_of_u_p1_19;
    let u_p1_ratio_q_p4_u_p1 = u_P1 * ratio_q_P4_u_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_22 = u_p1_ratio_q_p4_u_p1 * sin_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_23 = ratio_q_P2_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_24 = ratio_q_P2_u_P1_2_of_u_p1_23
        .mul_add(cos_q_P2, ratio_q_P2_u_P1_2_of_u_p1_22 * sin_q_P2);
    let w_rod2_frame_3 = u_P1 * ratio_q_P2_u_P1;
    let sin_q_p2_w_rod2_frame_3 = w_rod2_frame_3 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_25 = ratio_q_P2_u_P1_of_q_p5_2
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_3, ratio_q_P2_u_P1_2_of_u_p1 * sin_q_P4);
    let ratio_q_P2_u_P1_2_of_u_p1_26 = ratio_q_P2_u_P1_2_of_u_p1_11 + ratio_q_P2_u_P1_2_of_u_p1_25;
    let ratio_q_P2_u_P1_2_of_u_p1_27 = ratio_q_P2_u_P1_2_of_u_p1
        .mul_add(S::int(3), -ratio_q_P2_u_P1_2_of_u_p1_9)
        + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_26;
    let ratio_q_P2_u_P1_2_of_u_p1_28 = (-ratio_q_P2_u_P1_2_of_u_p1_15)
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_19 * cos_q_P5);
    let ratio_q_P2_u_P1_2_of_u_p1_29 = ratio_q_P2_u_P1_2_of_u_p1_25
        .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_30 = (-ratio_q_P2_u_P1_2_of_u_p1_23)
        .mul_add(sin_q_P2, cos_q_p2_sin_q_p4 * u_p1_ratio_q_p4_u_p1);
    let cos_q_p2_w_rod2_frame_3 = w_rod2_frame_3 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_31 = sin_q_P2
        * ((-ratio_q_P2_u_P1_2_of_u_p1_14)
            .mul_add(
                sin_q_P3,
                ratio_q_P2_u_P1_of_q_p4_q_p5_10 * ratio_q_P2_u_P1_2_of_u_p1_16,
            ) + cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_20
            + ratio_q_P2_u_P1_of_q_p4_q_p5_11 * ratio_q_P2_u_P1_2_of_u_p1_28)
        + ratio_q_P2_u_P1_of_place_89 * cos_q_p2_w_rod2_frame_3;
    let ratio_q_P2_u_P1_2_of_u_p1_32 = ratio_q_P3_u_P1 * u_p1_cos_q_p4;
    let cos_q_p2_cos_q_p3 = cos_q_P2 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_33 = ratio_q_P2_u_P1_2_of_u_p1_32
        .mul_add(cos_q_p2_cos_q_p3, ratio_q_P2_u_P1_2_of_u_p1_30 * sin_q_P3);
    let u_p1_cos_q_p1 = u_P1 * cos_q_P1;
    let u_p1_sin_q_p1 = u_P1 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_34 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_8;
    let ratio_q_P2_u_P1_2_of_u_p1_35 = ratio_q_P2_u_P1_2_of_u_p1_6 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_36 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_24, ratio_q_P2_u_P1_2_of_u_p1_35 * cos_q_P5);
    let ratio_q_P2_u_P1_2_of_u_p1_37 = ratio_q_P2_u_P1_2_of_u_p1_25
        .mul_add(cos_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5 * sin_q_p2_w_rod2_frame_3);
    let ratio_q_P2_u_P1_2_of_u_p1_38 = -ratio_q_P2_u_P1_of_place_97
        * ratio_q_P2_u_P1_2_of_u_p1_22
            .mul_add(cos_q_P5, ratio_q_P2_u_P1_2_of_u_p1_6 * sin_q_P5)
        + ratio_q_P2_u_P1_of_place_96 * ratio_q_P2_u_P1_2_of_u_p1_19
        + ratio_q_P2_u_P1_of_place_95 * u_p1_sin_q_p1
        + cos_q_P1
            * (sin_q_P1
                * (ratio_q_P2_u_P1_2_of_u_p1_14 - S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_21
                    - ratio_q_P2_u_P1_of_place_87 * sin_q_p2_w_rod2_frame_3
                    + cos_q_P2
                        * (-cos_q_P2
                            * (ratio_q_P2_u_P1_2_of_u_p1
                                + ratio_q_P2_u_P1_of_q_p4_q_p5_6 * ratio_q_P2_u_P1_2_of_u_p1_3
                                + sin_q_P4
                                    * ratio_q_P2_u_P1_2_of_u_p1_5
                                        .mul_add(S::int(4), ratio_q_P2_u_P1_2_of_u_p1)
                                - S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_7
                                - ratio_q_P2_u_P1_2_of_u_p1_21)
                            + ratio_q_P2_u_P1_of_place_86 * ratio_q_P2_u_P1_2_of_u_p1_24
                            - ratio_q_P2_u_P1_of_place_85 * sin_q_p2_w_rod2_frame_3
                            - sin_q_p2_cos_q_p4
                                * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_13)
                                    .mul_add(
                                        ratio_q_P2_u_P1_2_of_u_p1_16,
                                        ratio_q_P2_u_P1_2_of_u_p1_27 * sin_q_P3,
                                    )
                                    + ratio_q_P2_u_P1_of_q_p4_q_p5_14 * ratio_q_P2_u_P1_2_of_u_p1_28
                                    + cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_29)))
                + cos_q_P1
                    * (ratio_q_P2_u_P1_of_place_93 * ratio_q_P2_u_P1_2_of_u_p1_15
                        - ratio_q_P2_u_P1_of_place_91 * ratio_q_P2_u_P1_2_of_u_p1_19
                        + cos_q_P3
                            * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_13)
                                .mul_add(
                                    ratio_q_P2_u_P1_2_of_u_p1_30,
                                    cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_27,
                                ) + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_31)
                        + cos_q_P5
                            * ((-ratio_q_P2_u_P1_2_of_u_p1_20)
                                .mul_add(
                                    sin_q_P2,
                                    ratio_q_P2_u_P1_of_q_p4_q_p5_11 * cos_q_p2_w_rod2_frame_3,
                                ) - ratio_q_P2_u_P1_of_place_92 * ratio_q_P2_u_P1_2_of_u_p1_29
                                + ratio_q_P2_u_P1_of_q_p4_q_p5_14 * ratio_q_P2_u_P1_2_of_u_p1_33))
                - ratio_q_P2_u_P1_of_place_88 * u_p1_cos_q_p1
                - ratio_q_P2_u_P1_of_place_94 * u_p1_sin_q_p1)
        + cos_q_P3
            * (-ratio_q_P2_u_P1_2_of_u_p1_31
                + ratio_q_P2_u_P1_of_q_p4_q_p5_15 * ratio_q_P2_u_P1_2_of_u_p1_30
                - cos_q_p2_cos_q_p4 * (ratio_q_P2_u_P1_2_of_u_p1_26 + ratio_q_P2_u_P1_2_of_u_p1_34))
        + cos_q_p4_cos_q_p5
            * ((-ratio_q_P2_u_P1_of_place_23)
                .mul_add(ratio_q_P2_u_P1_2_of_u_p1_16, ratio_q_P2_u_P1_2_of_u_p1_36)
                + ratio_q_P2_u_P1_2_of_u_p1_37 * sin_q_P3);
    let ratio_q_P2_u_P1_2_of_u_p1_39 = ratio_q_P2_u_P1_2_of_u_p1_3 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_40 = sin_q_p2_w_rod2_frame_3
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_2_of_u_p1_39);
    let ratio_q_P2_u_P1_2_of_u_p1_41 = ratio_q_P2_u_P1_2_of_u_p1_32 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_42 = ratio_q_P2_u_P1_2_of_u_p1_41
        .mul_add(cos_q_P3, -ratio_q_P2_u_P1_2_of_u_p1_40);
    let ratio_q_P2_u_P1_2_of_u_p1_43 = ratio_q_P4_u_P1 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_44 = (-cos_q_p3_sin_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_43,
            sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_32,
        );
    let sin_q_p1_u_p1_cos_q_p4 = u_p1_cos_q_p4 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_45 = sin_q_p1_u_p1_cos_q_p4
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_44);
    let ratio_q_P2_u_P1_2_of_u_p1_46 = cos_q_P5
        * (sin_q_P1
            * ratio_q_P2_u_P1_2_of_u_p1_24
                .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_42)
            + ratio_q_P2_u_P1_of_place_9 * u_p1_cos_q_p1 + ratio_q_P2_u_P1_2_of_u_p1_45)
        - ratio_q_P2_u_P1_of_place_11 * ratio_q_P2_u_P1_2_of_u_p1_15;
    let ratio_q_P2_u_P1_2_of_u_p1_47 = ratio_q_P2_u_P1_2_of_u_p1_6 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_48 = (-ratio_q_P2_u_P1_2_of_u_p1_25)
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_p2_w_rod2_frame_3)
        - ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_33
        + sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_47;
    let ratio_q_P2_u_P1_2_of_u_p1_49 = ratio_q_P2_u_P1_2_of_u_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_50 = sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_51 = (-ratio_q_P2_u_P1_2_of_u_p1_19)
        .mul_add(sin_q_P5, ratio_q_P2_u_P1_2_of_u_p1_18 * sin_q_P4)
        - ratio_q_P2_u_P1_2_of_u_p1_49 - ratio_q_P2_u_P1_2_of_u_p1_50;
    let ratio_q_P2_u_P1_2_of_u_p1_52 = (-ratio_q_P2_u_P1_of_place_6)
        .mul_add(sin_q_p2_w_rod2_frame_3, ratio_q_P2_u_P1_2_of_u_p1_24 * cos_q_P5)
        + ratio_q_P2_u_P1_2_of_u_p1_35 * sin_q_P5 + ratio_q_P2_u_P1_2_of_u_p1_51 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_53 = u_p1_cos_q_p1
        .mul_add(sin_q_P2, w_rod2_frame_3 * cos_q_p2_sin_q_p1);
    let sin_q_p3_u_p1_sin_q_p1 = u_p1_sin_q_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_54 = ratio_q_P2_u_P1_2_of_u_p1_16 * cos_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_55 = sin_q_P4
        * cos_q_p2_w_rod2_frame_3
            .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_16 * sin_q_P2)
        - sin_q_p2_sin_q_p3 * ratio_q_P2_u_P1_2_of_u_p1_3 - ratio_q_P2_u_P1_2_of_u_p1_30;
    let cos_q_p3_u_p1_sin_q_p1 = u_p1_sin_q_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_56 = ratio_q_P2_u_P1_2_of_u_p1_19
        .mul_add(cos_q_P1, cos_q_p3_u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_57 = ratio_q_P2_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_15
        - ratio_q_P2_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1
        + cos_q_P5
            * ((-sin_q_p2_sin_q_p1)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_19,
                    ratio_q_P2_u_P1_2_of_u_p1_53 * cos_q_P3,
                ) - sin_q_p3_u_p1_sin_q_p1 + ratio_q_P2_u_P1_2_of_u_p1_54)
        - sin_q_P5
            * (ratio_q_P2_u_P1_of_place_3
                .mul_add(u_p1_cos_q_p1, cos_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_3)
                + ratio_q_P2_u_P1_2_of_u_p1_55 * sin_q_P1
                + ratio_q_P2_u_P1_2_of_u_p1_56 * sin_q_P4);
    let ratio_q_P2_u_P1_2_of_u_p1_58 = ratio_q_P2_u_P1_of_place_5
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_48,
            ratio_q_P2_u_P1_of_place_8 * ratio_q_P2_u_P1_2_of_u_p1_46,
        ) - ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_u_p1_52
        - ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_2_of_u_p1_57;
    let ratio_q_P2_u_P1_2_of_u_p1_59 = ratio_q_P2_u_P1_2_of_u_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_60 = ratio_q_P2_u_P1_2_of_u_p1_16 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_61 = cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_62 = ratio_q_P2_u_P1_2_of_u_p1_28
        .mul_add(sin_q_P4, -ratio_q_P2_u_P1_2_of_u_p1_59) + ratio_q_P2_u_P1_2_of_u_p1_60
        + ratio_q_P2_u_P1_2_of_u_p1_61;
    let ratio_q_P2_u_P1_2_of_u_p1_63 = (-ratio_q_P2_u_P1_2_of_u_p1_51)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_6 * u_p1_sin_q_p1)
        - ratio_q_P2_u_P1_of_place_19 * ratio_q_P2_u_P1_2_of_u_p1_53
        + sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_62;
    let ratio_q_P2_u_P1_2_of_u_p1_64 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_19, ratio_q_P2_u_P1_2_of_u_p1_18)
        - ratio_q_P2_u_P1_2_of_u_p1_25 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_65 = ratio_q_P2_u_P1_2_of_u_p1_64 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_place = ratio_q_P2_u_P1_of_place_16 * sin_q_p2_w_rod2_frame_3;
    let ratio_q_P2_u_P1_2_of_u_p1_66 = ratio_q_P2_u_P1_2_of_place - ratio_q_P2_u_P1_2_of_u_p1_65;
    let ratio_q_P2_u_P1_2_of_place_2 = l * ratio_q_P2_u_P1_of_place_20;
    let ratio_q_P2_u_P1_2_of_u_p1_67 = (-ratio_q_P2_u_P1_of_place_66)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_57,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_66,
        ) - ratio_q_P2_u_P1_of_place_8 * ratio_q_P2_u_P1_2_of_u_p1_63
        + ratio_q_P2_u_P1_2_of_u_p1_52 * ratio_q_P2_u_P1_2_of_place_2;
    let ratio_q_P2_u_P1_2_of_u_p1_68 = ratio_q_P2_u_P1_of_place_27
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_63,
            ratio_q_P2_u_P1_of_place_66 * ratio_q_P2_u_P1_2_of_u_p1_46,
        ) + ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_u_p1_66
        + ratio_q_P2_u_P1_2_of_u_p1_48 * ratio_q_P2_u_P1_2_of_place_2;
    let ratio_q_P2_u_P1_2_of_u_p1_69 = (-ratio_q_P2_u_P1_2_of_u_p1_25)
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_q_p4_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_16)
        + ratio_q_P2_u_P1_2_of_u_p1_28;
    let ratio_q_P2_u_P1_2_of_u_p1_70 = (-ratio_q_P2_u_P1_2_of_u_p1_64)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_16 * u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_71 = ratio_q_P2_u_P1 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_72 = l
        * ((-ratio_q_P2_u_P1_of_place_15)
            .mul_add(u_p1_cos_q_p1, ratio_q_P2_u_P1_2_of_u_p1_69 * sin_q_P1)
            + ratio_q_P2_u_P1_2_of_u_p1_70 * sin_q_P2
            - ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_2_of_u_p1_71);
    let ratio_q_P2_u_P1_2_of_u_p1_73 = (-sin_q_p3_cos_q_p5)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_35,
            ratio_q_P2_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_24,
        ) - ratio_q_P2_u_P1_2_of_u_p1_37
        + ratio_q_P2_u_P1_of_q_p3_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_41;
    let ratio_q_P2_u_P1_2_of_u_p1_74 = cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_6;
    let ratio_q_P2_u_P1_2_of_u_p1_75 = l
        * (ratio_q_P2_u_P1_of_place_24 * u_p1_sin_q_p1
            - ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p3_cos_q_p1 * u_p1_cos_q_p4
            - ratio_q_P4_u_P1 * ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_p3_u_p1_sin_q_p1
            - ratio_q_P2_u_P1_2_of_u_p1_73 * cos_q_P1
            + sin_q_P1
                * ratio_q_P2_u_P1_of_q_p3_q_p5
                    .mul_add(
                        ratio_q_P2_u_P1_2_of_u_p1_32, ratio_q_P2_u_P1_2_of_u_p1_74,
                    ));
    let ratio_q_P2_u_P1_2_of_u_p1_76 = (-ratio_q_P2_u_P1_2_of_u_p1_30)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_6 * cos_q_p2_w_rod2_frame_3)
        - ratio_q_P2_u_P1_2_of_u_p1_47 * sin_q_P5 + ratio_q_P2_u_P1_2_of_u_p1_51 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_77 = l
        * ((-ratio_q_P2_u_P1_2_of_u_p1_62)
            .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_19 * u_p1_cos_q_p1)
            + ratio_q_P2_u_P1_of_place_29 * u_p1_sin_q_p1
            + ratio_q_P2_u_P1_2_of_u_p1_76 * cos_q_P1);
    let ratio_q_P2_u_P1_2_of_u_p1_78 = ratio_q_P2_u_P1_of_place_32
        .mul_add(
            cos_q_p2_w_rod2_frame_3,
            ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_30,
        ) - ratio_q_P2_u_P1_2_of_u_p1_47 * cos_q_P5 - ratio_q_P2_u_P1_2_of_u_p1_69 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_79 = (-ratio_q_P2_u_P1_of_place_29)
        .mul_add(u_p1_cos_q_p1, ratio_q_P2_u_P1_of_place_19 * u_p1_sin_q_p1)
        + ratio_q_P2_u_P1_2_of_u_p1_62 * cos_q_P1 + ratio_q_P2_u_P1_2_of_u_p1_76 * sin_q_P1;
    let cos_q_p2_u_p1_cos_q_p1 = u_p1_cos_q_p1 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_80 = sin_q_p2_w_rod2_frame_3
        .mul_add(sin_q_P1, -cos_q_p2_u_p1_cos_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_81 = l * ratio_q_P2_u_P1_2_of_u_p1_52;
    let ratio_q_P2_u_P1_2_of_u_p1_82 = ratio_q_P2_u_P1_of_place_8 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_83 = ratio_q_P2_u_P1_2_of_u_p1_81
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_2_of_u_p1_82);
    let ratio_q_P2_u_P1_2_of_u_p1_84 = ratio_q_P2_u_P1_of_place_32
        .mul_add(sin_q_p2_w_rod2_frame_3, -ratio_q_P2_u_P1_2_of_u_p1_36)
        + ratio_q_P2_u_P1_2_of_u_p1_69 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_85 = ratio_q_P2_u_P1_of_place_81
        * ratio_q_P2_u_P1_2_of_u_p1_57 * sin_q_P1
        + ratio_q_P2_u_P1_of_place_42 * ratio_q_P2_u_P1_2_of_u_p1_79
        - ratio_q_P2_u_P1_of_place_37 * ratio_q_P2_u_P1_2_of_u_p1_83
        + ratio_q_P2_u_P1_of_place_5
            * (-ratio_q_P2_u_P1_2_of_u_p1_84)
                .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_41 * u_p1_cos_q_p1);
    let ratio_q_P2_u_P1_2_of_place_3 = l * ratio_q_P2_u_P1_of_place_43;
    let ratio_q_P2_u_P1_2_of_place_4 = ratio_q_P2_u_P1_of_place_7 * l_sq;
    let ratio_q_P2_u_P1_2_of_u_p1_86 = ratio_q_P2_u_P1_of_q_p5_2
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_19, ratio_q_P2_u_P1_2_of_u_p1_49);
    let ratio_q_P2_u_P1_2_of_u_p1_87 = ratio_q_P2_u_P1_of_q_p3
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_15, ratio_q_P2_u_P1_2_of_u_p1_17)
        + ratio_q_P2_u_P1_2_of_u_p1_86;
    let ratio_q_P2_u_P1_2_of_u_p1_88 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_16, ratio_q_P2_u_P1_2_of_u_p1_59);
    let ratio_q_P2_u_P1_2_of_u_p1_89 = ratio_q_P2_u_P1_of_q_p4_q_p5
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_80,
            cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_25,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_90 = cos_q_p2_sin_q_p1
        * (ratio_q_P2_u_P1_of_place_48
            * u_p1_cos_q_p1.mul_add(cos_q_P5, ratio_q_P2_u_P1_2_of_u_p1_15 * sin_q_P1)
            - ratio_q_P2_u_P1_of_place_46 * ratio_q_P2_u_P1_2_of_u_p1_19
            - cos_q_p5_sin_q_p1
                * (ratio_q_P2_u_P1_2_of_u_p1_40
                    + ratio_q_P2_u_P1_of_place_47 * ratio_q_P2_u_P1_2_of_u_p1_16
                    + sin_q_P3
                        * ratio_q_P2_u_P1_of_q_p3
                            .mul_add(
                                ratio_q_P2_u_P1_2_of_u_p1_24, ratio_q_P2_u_P1_2_of_u_p1_42,
                            ))
            - cos_q_P3
                * (cos_q_P4
                    * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
                        .mul_add(
                            u_p1_sin_q_p1,
                            sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_88,
                        ) - ratio_q_P2_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_53
                        - ratio_q_P2_u_P1_2_of_u_p1_87 * cos_q_P1)
                    - ratio_q_P2_u_P1_of_place_44 * ratio_q_P2_u_P1_2_of_u_p1_22
                    + ratio_q_P2_u_P1_2_of_u_p1_89));
    let ratio_q_P2_u_P1_2_of_u_p1_91 = ratio_q_P2_u_P1_of_place_50 * ratio_q_P2_u_P1_2_of_u_p1_52
        + l * ratio_q_P2_u_P1_of_place_38 * ratio_q_P2_u_P1_2_of_u_p1_78
        + ratio_q_P2_u_P1_of_place_39
            * (l
                * ratio_q_P2_u_P1_of_place_36
                    .mul_add(
                        ratio_q_P2_u_P1_2_of_u_p1_57,
                        ratio_q_P2_u_P1_of_place_37 * ratio_q_P2_u_P1_2_of_u_p1_46,
                    )
                + ratio_q_P2_u_P1_of_place_5
                    * (ratio_q_P2_u_P1_of_q_p5_2
                        .mul_add(
                            ratio_q_P2_u_P1_2_of_u_p1_45,
                            ratio_q_P2_u_P1_of_place_24 * u_p1_cos_q_p1,
                        ) + ratio_q_P2_u_P1_2_of_u_p1_73 * sin_q_P1
                        + ratio_q_P2_u_P1_2_of_u_p1_74 * cos_q_P1)
                + ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_u_p1_79)
        - ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_49 * ratio_q_P2_u_P1_2_of_u_p1_80
        + ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_2_of_u_p1_85
        - ratio_q_P2_u_P1_2_of_u_p1_48 * ratio_q_P2_u_P1_2_of_place_3
        + ratio_q_P2_u_P1_2_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_90;
    let ratio_q_P2_u_P1_2_of_u_p1_92 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_4;
    let ratio_q_P2_u_P1_2_of_u_p1_93 = ratio_q_P2_u_P1_2_of_u_p1_92
        - ratio_q_P2_u_P1_of_q_p4_2 * ratio_q_P2_u_P1_2_of_u_p1
        - sin_q_P5 * (ratio_q_P2_u_P1_2_of_u_p1_3 + ratio_q_P2_u_P1_2_of_u_p1_92);
    let ratio_q_P2_u_P1_2_of_u_p1_94 = ratio_q_P2_u_P1_2_of_u_p1_93 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_95 = ratio_q_P2_u_P1_of_q_p4_q_p5_3
        * ratio_q_P2_u_P1_2_of_u_p1_16;
    let ratio_q_P2_u_P1_2_of_u_p1_96 = ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P2_u_P1_2_of_u_p1_25;
    let ratio_q_P2_u_P1_2_of_u_p1_97 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_96;
    let ratio_q_P2_u_P1_2_of_u_p1_98 = ratio_q_P2_u_P1_of_q_p4
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_18, -ratio_q_P2_u_P1_2_of_u_p1_50);
    let ratio_q_P2_u_P1_2_of_u_p1_99 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_3)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_19, ratio_q_P2_u_P1_2_of_u_p1_93 * cos_q_P3);
    let ratio_q_P2_u_P1_2_of_u_p1_100 = ratio_q_P2_u_P1_2_of_u_p1_28 + ratio_q_P2_u_P1_2_of_u_p1_88;
    let ratio_q_P2_u_P1_2_of_u_p1_101 = cos_q_P1
        * (ratio_q_P2_u_P1_2_of_u_p1_18 + ratio_q_P2_u_P1_2_of_u_p1_86);
    let ratio_q_P2_u_P1_2_of_place_5 = ratio_q_P2_u_P1_of_q_p3_q_p5_7 * sin_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_102 = ratio_q_P2_u_P1_of_q_p3_q_p5_7 * sin_q_p1_u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_103 = ratio_q_P2_u_P1_2_of_u_p1_71
        .mul_add(sin_q_P2, u_p1_sin_q_p1 * cos_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_104 = sin_q_P1
        * (ratio_q_P2_u_P1_of_place_70 * cos_q_p2_w_rod2_frame_3
            - cos_q_p2_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_51
            + sin_q_P2
                * (sin_q_P1
                    * (cos_q_P2
                        * (ratio_q_P2_u_P1_of_q_p3_q_p5_5 * ratio_q_P2_u_P1_2_of_u_p1_3
                            - ratio_q_P2_u_P1_of_q_p3 * ratio_q_P2_u_P1_2_of_u_p1
                            + sin_q_P4 * (ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P2_u_P1_2_of_u_p1_28)
                            + ratio_q_P2_u_P1_2_of_u_p1_60)
                        - ratio_q_P2_u_P1_of_q_p3_q_p5_6 * ratio_q_P2_u_P1_2_of_u_p1_24
                        - ratio_q_P2_u_P1_of_place_67 * sin_q_p2_w_rod2_frame_3
                        + sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_100)
                    + ratio_q_P2_u_P1_of_place_68 * u_p1_cos_q_p1
                    - ratio_q_P2_u_P1_2_of_u_p1_101 * cos_q_P4
                    - ratio_q_P2_u_P1_2_of_u_p1_43 * ratio_q_P2_u_P1_2_of_place_5
                    + ratio_q_P2_u_P1_2_of_u_p1_102)
            + ratio_q_P2_u_P1_of_place_6 * ratio_q_P2_u_P1_2_of_u_p1_103)
        + ratio_q_P2_u_P1_of_place_71 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_105 = l_sq * ratio_q_P2_u_P1_2_of_u_p1_78;
    let ratio_q_P2_u_P1_2_of_u_p1_106 = ratio_q_P2_u_P1_of_place_72 * ratio_q_P2_u_P1_2_of_u_p1_52
        - ratio_q_P2_u_P1_of_place_66 * ratio_q_P2_u_P1_2_of_u_p1_85
        + ratio_q_P2_u_P1_2_of_u_p1_66 * ratio_q_P2_u_P1_2_of_place_3
        + ratio_q_P2_u_P1_of_place_65
            * (-u_p1_cos_q_p1
                * (ratio_q_P2_u_P1_of_place_62 * sin_q_p3_sin_q_p1)
                    .mul_add(S::int(2), ratio_q_P2_u_P1_of_place_61)
                + ratio_q_P2_u_P1_of_place_63 * ratio_q_P2_u_P1_2_of_u_p1_54
                - sin_q_P1
                    * (ratio_q_P2_u_P1_of_q_p4_q_p5_4
                        * (-ratio_q_P2_u_P1_2_of_u_p1_33)
                            .mul_add(
                                cos_q_P1,
                                cos_q_p2_sin_q_p1 * u_p1_cos_q_p4 * sin_q_P3,
                            ) + ratio_q_P2_u_P1_of_place_60 * cos_q_p2_w_rod2_frame_3
                        + sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_97
                        + sin_q_P2
                            * (sin_q_p3_cos_q_p1
                                * ratio_q_P2_u_P1_2_of_u_p1_95
                                    .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_94)
                                - ratio_q_P2_u_P1_of_place_59 * ratio_q_P2_u_P1_2_of_u_p1_19
                                - ratio_q_P2_u_P1_of_place_52 * sin_q_p3_u_p1_sin_q_p1
                                + cos_q_P3
                                    * (ratio_q_P2_u_P1_of_place_55 * u_p1_cos_q_p1
                                        + ratio_q_P2_u_P1_of_place_58 * u_p1_sin_q_p1
                                        + sin_q_P1
                                            * (ratio_q_P2_u_P1_of_place_53 * cos_q_p2_w_rod2_frame_3
                                                - ratio_q_P2_u_P1_of_q_p4_q_p5_4
                                                    * ratio_q_P2_u_P1_2_of_u_p1_30
                                                + sin_q_P2
                                                    * (ratio_q_P2_u_P1_of_q_p4
                                                        .mul_add(
                                                            ratio_q_P2_u_P1_2_of_u_p1_28,
                                                            ratio_q_P2_u_P1_2_of_u_p1_61,
                                                        ) + ratio_q_P2_u_P1_2_of_u_p1_94
                                                        + ratio_q_P2_u_P1_2_of_u_p1_95)
                                                + ratio_q_P2_u_P1_2_of_u_p1_97)
                                        - cos_q_P1
                                            * ratio_q_P2_u_P1_2_of_u_p1_98
                                                .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_99))))
                + sin_q_p3_cos_q_p1 * cos_q_P1
                    * (ratio_q_P2_u_P1_2_of_u_p1_98 + ratio_q_P2_u_P1_2_of_u_p1_99))
        + ratio_q_P2_u_P1_2_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_104
        - ratio_q_P2_u_P1_of_place_64 * ratio_q_P2_u_P1_2_of_u_p1_105;
    let ratio_q_P2_u_P1_2_of_u_p1_107 = ratio_q_P2_u_P1_of_place_50
        * (-ratio_q_P2_u_P1_2_of_place).mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_65)
        - ratio_q_P2_u_P1_of_place_72 * ratio_q_P2_u_P1_2_of_u_p1_48
        + ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_of_place_49 * cos_q_p2_u_p1_cos_q_p1
        + ratio_q_P2_u_P1_of_place_65
            * (ratio_q_P2_u_P1_of_place_78 * u_p1_cos_q_p1
                - ratio_q_P2_u_P1_of_place_10 * ratio_q_P2_u_P1_2_of_u_p1_101
                + ratio_q_P2_u_P1_of_place_69 * ratio_q_P2_u_P1_2_of_u_p1_44
                + S::int(2) * cos_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_102
                - sin_q_P1
                    * (ratio_q_P2_u_P1_of_place_69 * ratio_q_P2_u_P1_2_of_u_p1_39
                        - ratio_q_P2_u_P1_of_place_77 * cos_q_p2_w_rod2_frame_3
                        + sin_q_P2
                            * (cos_q_p3_cos_q_p5
                                * (cos_q_p2_sin_q_p1
                                    .mul_add(
                                        ratio_q_P2_u_P1_2_of_u_p1_3, -ratio_q_P2_u_P1_2_of_u_p1_45,
                                    ) + ratio_q_P2_u_P1_2_of_u_p1_80 * sin_q_P4)
                                - ratio_q_P2_u_P1_of_place_75 * ratio_q_P2_u_P1_2_of_u_p1_16
                                - ratio_q_P2_u_P1_of_place_76 * ratio_q_P2_u_P1_2_of_u_p1_28
                                + sin_q_P3
                                    * (ratio_q_P2_u_P1_2_of_u_p1_89
                                        - ratio_q_P2_u_P1_of_place_74 * ratio_q_P2_u_P1_2_of_u_p1_22
                                        + cos_q_P4
                                            * (ratio_q_P2_u_P1_of_q_p3_q_p5_8 * u_p1_sin_q_p1
                                                - ratio_q_P2_u_P1_of_q_p3_q_p5_6
                                                    * ratio_q_P2_u_P1_2_of_u_p1_53
                                                - cos_q_P1
                                                    * ratio_q_P2_u_P1_2_of_u_p1_86
                                                        .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_18)
                                                + sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_100)))
                        - cos_q_p2_sin_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_101
                        + ratio_q_P2_u_P1_2_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_103))
        + l_sq
            * ratio_q_P2_u_P1_of_place
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_104,
                    ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_2_of_u_p1_90,
                ) + ratio_q_P2_u_P1_of_place_79 * ratio_q_P2_u_P1_2_of_u_p1_105;
    let ratio_q_P2_u_P1_2_of_u_p1_108 = l
        * ratio_q_P2_u_P1_2_of_u_p1_84
            .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_41 * u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_109 = ratio_q_P2_u_P1_of_place_100
        * ((-ratio_q_P2_u_P1_of_place_51)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_72,
                l_sq * ratio_q_P2_u_P1_of_place_82 * ratio_q_P2_u_P1_2_of_u_p1_38,
            ) + ratio_q_P2_u_P1_of_place_73 * ratio_q_P2_u_P1_2_of_u_p1_75
            - ratio_q_P2_u_P1_of_place_80 * ratio_q_P2_u_P1_2_of_u_p1_77
            + ratio_q_P2_u_P1_of_place_18 * ratio_q_P2_u_P1_2_of_u_p1_91
            + ratio_q_P2_u_P1_of_place_25 * ratio_q_P2_u_P1_2_of_u_p1_106
            - ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_2_of_u_p1_107
            + ratio_q_P2_u_P1_of_place_99 * ratio_q_P2_u_P1_2_of_u_p1_108);
    let ratio_q_P2_u_P1_2_of_u_p1_110 = ratio_q_P2_u_P1_of_place_103 * ratio_q_P2_u_P1_2_of_u_p1
        + ratio_q_P2_u_P1_of_place_104 * ratio_q_P2_u_P1_2_of_u_p1_15
        + cos_q_P5
            * (-sin_q_P1
                * ratio_q_P2_u_P1_2_of_u_p1_19
                    .mul_add(sin_q_P4, ratio_q_P2_u_P1_2_of_u_p1_3 * cos_q_P3)
                + cos_q_p3_sin_q_p4 * u_p1_cos_q_p1 - ratio_q_P2_u_P1_of_place_3 * u_p1_sin_q_p1
                + ratio_q_P2_u_P1_2_of_u_p1_55 * cos_q_P1)
        + sin_q_P5
            * ((-ratio_q_P2_u_P1_2_of_u_p1_16)
                .mul_add(sin_q_P1, cos_q_p2_cos_q_p3 * ratio_q_P2_u_P1_2_of_u_p1_71)
                - u_p1_cos_q_p1 * sin_q_P3 - ratio_q_P2_u_P1_2_of_u_p1_56 * sin_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_111 = ratio_q_P2_u_P1_of_place_106
        * ratio_q_P2_u_P1_of_place_105
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_109, -ratio_q_P2_u_P1_2_of_u_p1_110);
    let ratio_q_P2_u_P1_2_of_u_p1_112 = ratio_q_P2_u_P1_2_of_u_p1_111
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_107 * ratio_q_P2_u_P1_2_of_u_p1_15);
    let ratio_q_P2_u_P1_2_of_u_p1_113 = ratio_q_P2_u_P1_of_place_34
        .mul_add(u_p1_sin_q_p1, ratio_q_P2_u_P1_of_place_16 * u_p1_cos_q_p1)
        + ratio_q_P2_u_P1_2_of_u_p1_64 * sin_q_P1 - ratio_q_P2_u_P1_2_of_u_p1_78 * cos_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_114 = ratio_q_P2_u_P1_of_place_101
        * ratio_q_P2_u_P1_of_place_35
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_109, -ratio_q_P2_u_P1_2_of_u_p1_113);
    let ratio_q_P2_u_P1_2_of_u_p1_115 = ratio_q_P2_u_P1_of_place_34
        .mul_add(u_p1_cos_q_p1, -ratio_q_P2_u_P1_2_of_u_p1_70)
        + ratio_q_P2_u_P1_2_of_u_p1_78 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_116 = ratio_q_P2_u_P1_of_place_109
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_109, ratio_q_P2_u_P1_2_of_u_p1_115);
    let ratio_q_P2_u_P1_2 = ratio_q_P2_u_P1_of_place_102
        * ((-ratio_q_P2_u_P1_of_place_18)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_58,
                ratio_q_P2_u_P1_of_place_25 * ratio_q_P2_u_P1_2_of_u_p1_67,
            ) + ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_2_of_u_p1_68
            - ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_2_of_u_p1_72
            + ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_2_of_u_p1_75
            - ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_77)
        - ratio_q_P2_u_P1_of_place_106 * ratio_q_P2_u_P1_of_place_109 * ratio_q_P2_u_P1_2_of_u_p1_38
        - ratio_q_P2_u_P1_of_place_108 * ratio_q_P2_u_P1_2_of_u_p1_96
        + ratio_q_P2_u_P1_of_q_p4_q_p5_16 * ratio_q_P2_u_P1_2_of_u_p1_112
        + ratio_q_P2_u_P1_of_place_31 * ratio_q_P2_u_P1_2_of_u_p1_114
        + ratio_q_P2_u_P1_of_place_110 * ratio_q_P2_u_P1_2_of_u_p1_116;
    let w_rod2_frame_12 = w_rod1_frame_in_rod2_frame_1 * w_rod1_frame_in_rod2_frame_2;
    let a_rod1_frame_in_rod2_frame_1 = (-g)
        .mul_add(sin_q_P2, a_rod1_centre_1 * cos_q_P2);
    let alpha_rod2_frame_3 = u_P1 * ratio_q_P2_u_P1_2;
    let turn_rod2_frame_12 = w_rod2_frame_12 - alpha_rod2_frame_3;
    let l_turn_rod2_frame_12 = l * turn_rod2_frame_12;
    let a_rod2_centre_1 = a_rod1_frame_in_rod2_frame_1
        .mul_add(S::int(2), -l_turn_rod2_frame_12);
    let x_rod2_frame_1 = m * a_rod2_centre_1;
    let w_rod2_frame_11 = w_rod1_frame_in_rod2_frame_1 * w_rod1_frame_in_rod2_frame_1;
    let w_rod2_frame_33 = w_rod2_frame_3 * w_rod2_frame_3;
    let turn_rod2_frame_22 = w_rod2_frame_11 + w_rod2_frame_33;
    let a_rod1_frame_in_rod2_frame_2 = a_rod1_centre_1.mul_add(sin_q_P2, g * cos_q_P2);
    let w_rod2_frame_23 = w_rod1_frame_in_rod2_frame_2 * w_rod2_frame_3;
    let alpha_rod2_frame_1 = w_rod2_frame_23;
    let turn_rod2_frame_32 = w_rod2_frame_23 + alpha_rod2_frame_1;
    let a_rod2_centre_3 = l * turn_rod2_frame_32;
    let x_rod2_frame_3 = m * a_rod2_centre_3;
    let x_rod1_frame_2_2 = m * l_sq;
    let H_rod2_3 = w_rod2_frame_3 * x_rod1_frame_2_2;
    let x_rod2_frame_1_2 = alpha_rod2_frame_1
        .mul_add(x_rod1_frame_2_2, w_rod1_frame_in_rod2_frame_2 * H_rod2_3);
    let H_rod2_1 = w_rod1_frame_in_rod2_frame_1 * x_rod1_frame_2_2;
    let x_rod2_frame_2_2 = (-w_rod1_frame_in_rod2_frame_1)
        .mul_add(H_rod2_3, w_rod2_frame_3 * H_rod2_1);
    let x_rod2_frame_3_2 = (-alpha_rod2_frame_3)
        .mul_add(x_rod1_frame_2_2, w_rod1_frame_in_rod2_frame_2 * H_rod2_1);
    let w_rod3_frame_1 = w_rod1_frame_in_rod2_frame_1 + u_p1_ratio_q_p3_u_p1;
    let w_rod2_frame_in_rod3_frame_3 = (-w_rod2_frame_3)
        .mul_add(cos_q_P3, w_rod1_frame_in_rod2_frame_2 * sin_q_P3);
    let w_rod3_frame_13 = w_rod3_frame_1 * w_rod2_frame_in_rod3_frame_3;
    let alpha_rod2_frame_2 = w_rod1_frame_in_rod2_frame_1 * w_rod2_frame_3;
    let alpha_rod2_frame_in_rod3_frame_2 = (-alpha_rod2_frame_3)
        .mul_add(sin_q_P3, alpha_rod2_frame_2 * cos_q_P3);
    let alpha_rod3_frame_2 = w_rod2_frame_in_rod3_frame_3
        .mul_add(u_p1_ratio_q_p3_u_p1, alpha_rod2_frame_in_rod3_frame_2);
    let turn_rod3_frame_13 = w_rod3_frame_13 + alpha_rod3_frame_2;
    let a_rod3_centre_1 = a_rod1_frame_in_rod2_frame_1 - l_turn_rod2_frame_12;
    let l_turn_rod3_frame_13 = l * turn_rod3_frame_13;
    let a_rod3_centre_1_2 = a_rod3_centre_1.mul_add(S::int(2), l_turn_rod3_frame_13);
    let x_rod3_frame_1 = m * a_rod3_centre_1_2;
    let w_rod2_frame_in_rod3_frame_2 = w_rod2_frame_3
        .mul_add(sin_q_P3, w_rod1_frame_in_rod2_frame_2 * cos_q_P3);
    let ratio_q_P3_u_P1_2_of_u_p1 = (-ratio_q_P2_u_P1_of_place_39)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_57,
            S::int(2) * ratio_q_P2_u_P1_of_place_42 * ratio_q_P2_u_P1_2_of_u_p1_52,
        ) - ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_78
        + ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_2_of_u_p1_82;
    let ratio_q_P3_u_P1_2_of_u_p1_2 = (-ratio_q_P2_u_P1_of_place_39)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_46,
            ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_u_p1_78,
        ) - ratio_q_P2_u_P1_of_place_42 * ratio_q_P2_u_P1_2_of_u_p1_48
        + ratio_q_P2_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_83;
    let ratio_q_P3_u_P1_2_of_u_p1_3 = ratio_q_P2_u_P1_2_of_u_p1_111
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_107 * ratio_q_P2_u_P1_2_of_u_p1_22);
    let ratio_q_P3_u_P1_2_of_u_p1_4 = ratio_q_P2_u_P1_of_place_101 * ratio_q_P2_u_P1_2_of_u_p1_116;
    let ratio_q_P3_u_P1_2 = ratio_q_P3_u_P1_of_place_5
        * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_15, ratio_q_P2_u_P1_2_of_u_p1)
            + ratio_q_P2_u_P1_2_of_u_p1_87 * cos_q_P5 - ratio_q_P2_u_P1_2_of_u_p1_88)
        + ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_91
        + ratio_q_P3_u_P1_of_place_3 * ratio_q_P2_u_P1_2_of_u_p1_114
        + ratio_q_P2_u_P1_of_place_102
            * ((-ratio_q_P2_u_P1_of_place_82)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_58,
                    ratio_q_P3_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_77,
                ) - ratio_q_P3_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_75
                - ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_2_of_u_p1_108
                - ratio_q_P2_u_P1_of_place_25 * ratio_q_P3_u_P1_2_of_u_p1
                + ratio_q_P2_u_P1_of_place_30 * ratio_q_P3_u_P1_2_of_u_p1_2)
        - ratio_q_P3_u_P1_of_q_p3_q_p5 * ratio_q_P3_u_P1_2_of_u_p1_3
        + ratio_q_P2_u_P1_of_place_51 * ratio_q_P3_u_P1_2_of_u_p1_4;
    let w_rod3_frame_23 = w_rod2_frame_in_rod3_frame_3 * w_rod2_frame_in_rod3_frame_2;
    let a_rod3_centre_2 = l.mul_add(turn_rod2_frame_22, -a_rod1_frame_in_rod2_frame_2);
    let alpha_rod3_frame_1 = u_P1.mul_add(ratio_q_P3_u_P1_2, alpha_rod2_frame_1);
    let turn_rod3_frame_23 = w_rod3_frame_23 + alpha_rod3_frame_1;
    let a_rod2_frame_in_rod3_frame_2 = (-a_rod2_centre_3)
        .mul_add(sin_q_P3, a_rod3_centre_2 * cos_q_P3);
    let l_turn_rod3_frame_23 = l * turn_rod3_frame_23;
    let a_rod3_centre_2_2 = a_rod2_frame_in_rod3_frame_2
        .mul_add(S::int(2), l_turn_rod3_frame_23);
    let x_rod3_frame_2 = m * a_rod3_centre_2_2;
    let w_rod3_frame_11 = w_rod3_frame_1 * w_rod3_frame_1;
    let w_rod3_frame_22 = w_rod2_frame_in_rod3_frame_2 * w_rod2_frame_in_rod3_frame_2;
    let turn_rod3_frame_33 = w_rod3_frame_11 + w_rod3_frame_22;
    let a_rod2_frame_in_rod3_frame_3 = a_rod3_centre_2
        .mul_add(sin_q_P3, a_rod2_centre_3 * cos_q_P3);
    let l_turn_rod3_frame_33 = l * turn_rod3_frame_33;
    let a_rod3_centre_3 = (-a_rod2_frame_in_rod3_frame_3)
        .mul_add(S::int(2), l_turn_rod3_frame_33);
    let x_rod3_frame_3 = m * a_rod3_centre_3;
    let H_rod3_2 = w_rod2_frame_in_rod3_frame_2 * x_rod1_frame_2_2;
    let x_rod3_frame_1_2 = alpha_rod3_frame_1
        .mul_add(x_rod1_frame_2_2, w_rod2_frame_in_rod3_frame_3 * H_rod3_2);
    let H_rod3_1 = w_rod3_frame_1 * x_rod1_frame_2_2;
    let x_rod3_frame_2_2 = alpha_rod3_frame_2
        .mul_add(x_rod1_frame_2_2, w_rod2_frame_in_rod3_frame_3 * H_rod3_1);
    let x_rod3_frame_3_2 = (-w_rod2_frame_in_rod3_frame_2)
        .mul_add(H_rod3_1, w_rod3_frame_1 * H_rod3_2);
    let w_rod3_frame_in_rod4_frame_3 = (-w_rod2_frame_in_rod3_frame_3)
        .mul_add(cos_q_P4, w_rod3_frame_1 * sin_q_P4);
    let w_rod4_frame_2 = u_p1_ratio_q_p4_u_p1 - w_rod2_frame_in_rod3_frame_2;
    let w_rod4_frame_22 = w_rod4_frame_2 * w_rod4_frame_2;
    let w_rod4_frame_33 = w_rod3_frame_in_rod4_frame_3 * w_rod3_frame_in_rod4_frame_3;
    let turn_rod4_frame_11 = w_rod4_frame_22 + w_rod4_frame_33;
    let a_rod4_centre_1 = a_rod3_centre_1 + l_turn_rod3_frame_13;
    let a_rod4_centre_3 = l_turn_rod3_frame_33 - a_rod2_frame_in_rod3_frame_3;
    let a_rod3_frame_in_rod4_frame_1 = (-a_rod4_centre_1)
        .mul_add(cos_q_P4, a_rod4_centre_3 * sin_q_P4);
    let l_turn_rod4_frame_11 = l * turn_rod4_frame_11;
    let a_rod4_centre_1_2 = a_rod3_frame_in_rod4_frame_1
        .mul_add(S::int(2), l_turn_rod4_frame_11);
    let x_rod4_frame_1 = m * a_rod4_centre_1_2;
    let w_rod3_frame_in_rod4_frame_1 = w_rod2_frame_in_rod3_frame_3
        .mul_add(sin_q_P4, w_rod3_frame_1 * cos_q_P4);
    let w_rod4_frame_12 = w_rod4_frame_2 * w_rod3_frame_in_rod4_frame_1;
    let alpha_rod2_frame_in_rod3_frame_3 = alpha_rod2_frame_2
        .mul_add(sin_q_P3, alpha_rod2_frame_3 * cos_q_P3);
    let alpha_rod3_frame_3 = w_rod2_frame_in_rod3_frame_2
        .mul_add(u_p1_ratio_q_p3_u_p1, -alpha_rod2_frame_in_rod3_frame_3);
    let alpha_rod3_frame_in_rod4_frame_3 = (-alpha_rod3_frame_1)
        .mul_add(sin_q_P4, alpha_rod3_frame_3 * cos_q_P4);
    let alpha_rod4_frame_3 = w_rod3_frame_in_rod4_frame_1
        .mul_add(u_p1_ratio_q_p4_u_p1, alpha_rod3_frame_in_rod4_frame_3);
    let turn_rod4_frame_21 = w_rod4_frame_12 + alpha_rod4_frame_3;
    let a_rod4_centre_2 = a_rod2_frame_in_rod3_frame_2 + l_turn_rod3_frame_23;
    let l_turn_rod4_frame_21 = l * turn_rod4_frame_21;
    let a_rod4_centre_2_2 = (-a_rod4_centre_2).mul_add(S::int(2), l_turn_rod4_frame_21);
    let x_rod4_frame_2 = m * a_rod4_centre_2_2;
    let ratio_q_P4_u_P1_2_of_u_p1 = ratio_q_P2_u_P1_of_place_39 * ratio_q_P2_u_P1_2_of_u_p1_63
        - ratio_q_P2_u_P1_2_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_78
        + ratio_q_P2_u_P1_of_place_8
            * (-ratio_q_P2_u_P1_of_place_16)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_80,
                    cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_64,
                ) + ratio_q_P4_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_81;
    let ratio_q_P4_u_P1_2_of_u_p1_2 = ratio_q_P2_u_P1_2_of_u_p1_28 - ratio_q_P2_u_P1_2_of_u_p1_16;
    let ratio_q_P4_u_P1_2 = ratio_q_P4_u_P1_of_place_3 * ratio_q_P2_u_P1_2_of_u_p1_114
        - ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_106
        - ratio_q_P4_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_112
        + ratio_q_P2_u_P1_of_place_73 * ratio_q_P3_u_P1_2_of_u_p1_4
        + ratio_q_P2_u_P1_of_place_102
            * ((-ratio_q_P2_u_P1_of_place_82)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_67,
                    ratio_q_P2_u_P1_of_place_30 * ratio_q_P4_u_P1_2_of_u_p1,
                ) - ratio_q_P3_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_72
                - ratio_q_P4_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_77
                - ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_2_of_u_p1_108
                - ratio_q_P2_u_P1_of_place_18 * ratio_q_P3_u_P1_2_of_u_p1)
        + ratio_q_P2_u_P1_of_place_108
            * (-ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P4_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_3
                - sin_q_P4
                    * ((-ratio_q_P4_u_P1_of_q_p4_q_p5)
                        .mul_add(
                            ratio_q_P2_u_P1_2_of_u_p1_16,
                            ratio_q_P2_u_P1_2_of_u_p1_96 * sin_q_P3,
                        ) - ratio_q_P2_u_P1_2_of_u_p1_25 - ratio_q_P2_u_P1_2_of_u_p1_28)
                + ratio_q_P4_u_P1_2_of_u_p1_2);
    let w_rod4_frame_13 = w_rod3_frame_in_rod4_frame_3 * w_rod3_frame_in_rod4_frame_1;
    let alpha_rod4_frame_2 = u_P1.mul_add(ratio_q_P4_u_P1_2, alpha_rod3_frame_2);
    let turn_rod4_frame_31 = w_rod4_frame_13 + alpha_rod4_frame_2;
    let a_rod3_frame_in_rod4_frame_3 = a_rod4_centre_3
        .mul_add(cos_q_P4, a_rod4_centre_1 * sin_q_P4);
    let l_turn_rod4_frame_31 = l * turn_rod4_frame_31;
    let a_rod4_centre_3_2 = a_rod3_frame_in_rod4_frame_3
        .mul_add(S::int(2), l_turn_rod4_frame_31);
    let x_rod4_frame_3 = m * a_rod4_centre_3_2;
    let H_rod4_2 = w_rod4_frame_2 * x_rod1_frame_2_2;
    let H_rod4_3 = w_rod3_frame_in_rod4_frame_3 * x_rod1_frame_2_2;
    let x_rod4_frame_1_2 = (-w_rod3_frame_in_rod4_frame_3)
        .mul_add(H_rod4_2, w_rod4_frame_2 * H_rod4_3);
    let x_rod4_frame_2_2 = alpha_rod4_frame_2
        .mul_add(x_rod1_frame_2_2, w_rod3_frame_in_rod4_frame_1 * H_rod4_3);
    let x_rod4_frame_3_2 = alpha_rod4_frame_3
        .mul_add(x_rod1_frame_2_2, w_rod3_frame_in_rod4_frame_1 * H_rod4_2);
    let w_rod4_frame_in_rod5_frame_1 = (-w_rod4_frame_2)
        .mul_add(sin_q_P5, w_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let w_rod4_frame_in_rod5_frame_2 = w_rod3_frame_in_rod4_frame_1
        .mul_add(sin_q_P5, w_rod4_frame_2 * cos_q_P5);
    let ratio_q_P5_u_P1_2 = ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_107
        + ratio_q_P5_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_114
        - ratio_q_P5_u_P1_of_place_2 * ratio_q_P3_u_P1_2_of_u_p1_3
        + ratio_q_P2_u_P1_of_place_80 * ratio_q_P3_u_P1_2_of_u_p1_4
        + ratio_q_P2_u_P1_of_place_102
            * ((-ratio_q_P2_u_P1_of_place_82)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_68,
                    ratio_q_P2_u_P1_of_place_18 * ratio_q_P3_u_P1_2_of_u_p1_2,
                ) - ratio_q_P3_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_72
                - ratio_q_P4_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_75
                - ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_108
                - ratio_q_P2_u_P1_of_place_25 * ratio_q_P4_u_P1_2_of_u_p1)
        + ratio_q_P3_u_P1_of_place_5
            * (ratio_q_P5_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3
                - ratio_q_P5_u_P1_of_q_p3_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1
                + sin_q_P4
                    * ((-(ratio_q_P2_u_P1_2_of_u_p1_2 * sin_q_P3))
                        .mul_add(
                            S::int(2),
                            ratio_q_P2_u_P1_of_q_p5_4 * ratio_q_P2_u_P1_2_of_u_p1_16,
                        ) + ratio_q_P2_u_P1_2_of_u_p1_34)
                + ratio_q_P2_u_P1_of_q_p5 * ratio_q_P4_u_P1_2_of_u_p1_2);
    let w_rod5_frame_12 = w_rod4_frame_in_rod5_frame_1 * w_rod4_frame_in_rod5_frame_2;
    let alpha_rod5_frame_3 = u_P1.mul_add(ratio_q_P5_u_P1_2, alpha_rod4_frame_3);
    let turn_rod5_frame_12 = w_rod5_frame_12 - alpha_rod5_frame_3;
    let a_rod5_centre_1 = a_rod3_frame_in_rod4_frame_1 + l_turn_rod4_frame_11;
    let a_rod5_centre_2 = l_turn_rod4_frame_21 - a_rod4_centre_2;
    let a_rod4_frame_in_rod5_frame_1 = a_rod5_centre_2
        .mul_add(sin_q_P5, a_rod5_centre_1 * cos_q_P5);
    let a_rod5_centre_1_2 = a_rod4_frame_in_rod5_frame_1
        .mul_add(S::int(2), l * turn_rod5_frame_12);
    let x_rod5_frame_1 = m * a_rod5_centre_1_2;
    let w_rod5_frame_3 = u_p1_ratio_q_p5_u_p1 - w_rod3_frame_in_rod4_frame_3;
    let w_rod5_frame_11 = w_rod4_frame_in_rod5_frame_1 * w_rod4_frame_in_rod5_frame_1;
    let w_rod5_frame_33 = w_rod5_frame_3 * w_rod5_frame_3;
    let turn_rod5_frame_22 = w_rod5_frame_11 + w_rod5_frame_33;
    let a_rod4_frame_in_rod5_frame_2 = (-a_rod5_centre_2)
        .mul_add(cos_q_P5, a_rod5_centre_1 * sin_q_P5);
    let a_rod5_centre_2_2 = (-a_rod4_frame_in_rod5_frame_2)
        .mul_add(S::int(2), l * turn_rod5_frame_22);
    let x_rod5_frame_2 = m * a_rod5_centre_2_2;
    let w_rod5_frame_23 = w_rod4_frame_in_rod5_frame_2 * w_rod5_frame_3;
    let alpha_rod3_frame_in_rod4_frame_1 = alpha_rod3_frame_3
        .mul_add(sin_q_P4, alpha_rod3_frame_1 * cos_q_P4);
    let alpha_rod4_frame_1 = w_rod3_frame_in_rod4_frame_3
        .mul_add(u_p1_ratio_q_p4_u_p1, alpha_rod3_frame_in_rod4_frame_1);
    let alpha_rod4_frame_in_rod5_frame_1 = (-alpha_rod4_frame_2)
        .mul_add(sin_q_P5, alpha_rod4_frame_1 * cos_q_P5);
    let alpha_rod5_frame_1 = w_rod4_frame_in_rod5_frame_2
        .mul_add(u_p1_ratio_q_p5_u_p1, alpha_rod4_frame_in_rod5_frame_1);
    let turn_rod5_frame_32 = w_rod5_frame_23 + alpha_rod5_frame_1;
    let a_rod5_centre_3 = a_rod3_frame_in_rod4_frame_3 + l_turn_rod4_frame_31;
    let a_rod5_centre_3_2 = a_rod5_centre_3.mul_add(S::int(2), l * turn_rod5_frame_32);
    let x_rod5_frame_3 = m * a_rod5_centre_3_2;
    let H_rod5_3 = w_rod5_frame_3 * x_rod1_frame_2_2;
    let x_rod5_frame_1_2 = alpha_rod5_frame_1
        .mul_add(x_rod1_frame_2_2, w_rod4_frame_in_rod5_frame_2 * H_rod5_3);
    let H_rod5_1 = w_rod4_frame_in_rod5_frame_1 * x_rod1_frame_2_2;
    let x_rod5_frame_2_2 = (-w_rod4_frame_in_rod5_frame_1)
        .mul_add(H_rod5_3, w_rod5_frame_3 * H_rod5_1);
    let x_rod5_frame_3_2 = (-alpha_rod5_frame_3)
        .mul_add(x_rod1_frame_2_2, w_rod4_frame_in_rod5_frame_2 * H_rod5_1);
    let x_rod1_frame_3 = l * m;
    let x_rod5_frame_1_3 = l * ratio_q_P2_u_P1;
    let x_rod2_frame_1_3 = m * x_rod5_frame_1_3;
    let l_sin_q_p2 = l * sin_q_P2;
    let a_rod2_centre_3_2 = l.mul_add(S::int(2), -l_sin_q_p2);
    let x_rod2_frame_3_3 = m * a_rod2_centre_3_2;
    let x_rod2_frame_1_4 = x_rod1_frame_2_2 * sin_q_P2;
    let x_rod2_frame_3_4 = ratio_q_P2_u_P1 * x_rod1_frame_2_2;
    let w_rod2_frame_in_rod3_frame_2_2 = ratio_q_P2_u_P1
        .mul_add(sin_q_P3, cos_q_p2_cos_q_p3);
    let a_rod3_centre_1_3_of_place = l * w_rod2_frame_in_rod3_frame_2_2;
    let a_rod3_centre_1_3 = (-x_rod5_frame_1_3)
        .mul_add(S::int(2), a_rod3_centre_1_3_of_place);
    let x_rod3_frame_1_3 = m * a_rod3_centre_1_3;
    let w_rod3_frame_1_2 = sin_q_P2 + ratio_q_P3_u_P1;
    let x_rod5_frame_3_3 = l - l_sin_q_p2;
    let x_rod2_frame_in_rod3_frame_2 = x_rod5_frame_3_3 * sin_q_P3;
    let l_w_rod3_frame_1_2 = l * w_rod3_frame_1_2;
    let a_rod3_centre_2_3 = x_rod2_frame_in_rod3_frame_2
        .mul_add(S::int(2), l_w_rod3_frame_1_2);
    let x_rod3_frame_2_3 = m * a_rod3_centre_2_3;
    let x_rod2_frame_in_rod3_frame_3 = x_rod5_frame_3_3 * cos_q_P3;
    let x_rod3_frame_3_3 = m * x_rod2_frame_in_rod3_frame_3;
    let x_rod3_frame_1_4 = x_rod1_frame_2_2 * w_rod3_frame_1_2;
    let x_rod3_frame_2_4 = x_rod1_frame_2_2 * w_rod2_frame_in_rod3_frame_2_2;
    let x_rod5_frame_1_4 = a_rod3_centre_1_3_of_place - x_rod5_frame_1_3;
    let x_rod3_frame_in_rod4_frame_1 = x_rod5_frame_1_4
        .mul_add(cos_q_P4, x_rod2_frame_in_rod3_frame_3 * sin_q_P4);
    let x_rod4_frame_1_3 = m * x_rod3_frame_in_rod4_frame_1;
    let w_rod2_frame_in_rod3_frame_3_2 = (-ratio_q_P2_u_P1)
        .mul_add(cos_q_P3, cos_q_P2 * sin_q_P3);
    let w_rod3_frame_in_rod4_frame_3_2 = (-w_rod3_frame_1_2)
        .mul_add(sin_q_P4, w_rod2_frame_in_rod3_frame_3_2 * cos_q_P4);
    let x_rod5_frame_2_3 = x_rod2_frame_in_rod3_frame_2 + l_w_rod3_frame_1_2;
    let a_rod4_centre_2_3_of_place = l * w_rod3_frame_in_rod4_frame_3_2;
    let a_rod4_centre_2_3 = (-x_rod5_frame_2_3)
        .mul_add(S::int(2), a_rod4_centre_2_3_of_place);
    let x_rod4_frame_2_3 = m * a_rod4_centre_2_3;
    let w_rod4_frame_2_2 = ratio_q_P4_u_P1 - w_rod2_frame_in_rod3_frame_2_2;
    let x_rod3_frame_in_rod4_frame_3 = (-x_rod5_frame_1_4)
        .mul_add(sin_q_P4, x_rod2_frame_in_rod3_frame_3 * cos_q_P4);
    let l_w_rod4_frame_2_2 = l * w_rod4_frame_2_2;
    let a_rod4_centre_3_3 = x_rod3_frame_in_rod4_frame_3
        .mul_add(S::int(2), l_w_rod4_frame_2_2);
    let x_rod4_frame_3_3 = m * a_rod4_centre_3_3;
    let x_rod4_frame_2_4 = x_rod1_frame_2_2 * w_rod4_frame_2_2;
    let x_rod4_frame_3_4 = x_rod1_frame_2_2 * w_rod3_frame_in_rod4_frame_3_2;
    let w_rod5_frame_3_2 = ratio_q_P5_u_P1 + w_rod3_frame_in_rod4_frame_3_2;
    let x_rod5_frame_2_4 = a_rod4_centre_2_3_of_place - x_rod5_frame_2_3;
    let x_rod4_frame_in_rod5_frame_1 = x_rod5_frame_2_4
        .mul_add(sin_q_P5, x_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let a_rod5_centre_1_3 = (-x_rod4_frame_in_rod5_frame_1)
        .mul_add(S::int(2), l * w_rod5_frame_3_2);
    let x_rod5_frame_1_5 = m * a_rod5_centre_1_3;
    let x_rod4_frame_in_rod5_frame_2 = (-x_rod5_frame_2_4)
        .mul_add(cos_q_P5, x_rod3_frame_in_rod4_frame_1 * sin_q_P5);
    let x_rod5_frame_2_5 = m * x_rod4_frame_in_rod5_frame_2;
    let w_rod3_frame_in_rod4_frame_1_2 = w_rod2_frame_in_rod3_frame_3_2
        .mul_add(sin_q_P4, w_rod3_frame_1_2 * cos_q_P4);
    let w_rod4_frame_in_rod5_frame_1_2 = (-w_rod4_frame_2_2)
        .mul_add(sin_q_P5, w_rod3_frame_in_rod4_frame_1_2 * cos_q_P5);
    let x_rod5_frame_3_4 = x_rod3_frame_in_rod4_frame_3 + l_w_rod4_frame_2_2;
    let a_rod5_centre_3_3 = x_rod5_frame_3_4
        .mul_add(S::int(2), l * w_rod4_frame_in_rod5_frame_1_2);
    let x_rod5_frame_3_5 = m * a_rod5_centre_3_3;
    let x_rod5_frame_1_6 = x_rod1_frame_2_2 * w_rod4_frame_in_rod5_frame_1_2;
    let x_rod5_frame_3_6 = x_rod1_frame_2_2 * w_rod5_frame_3_2;
    let w_rod4_frame_in_rod5_frame_2_2 = w_rod3_frame_in_rod4_frame_1_2
        .mul_add(sin_q_P5, w_rod4_frame_2_2 * cos_q_P5);
    let d1_of_place = a_rod3_centre_1_3
        .mul_add(x_rod3_frame_1_3, a_rod2_centre_3_2 * x_rod2_frame_3_3);
    let d1_of_place_2 = a_rod4_centre_2_3
        .mul_add(x_rod4_frame_2_3, a_rod3_centre_2_3 * x_rod3_frame_2_3);
    let d1_of_place_3 = x_rod5_frame_1_3.mul_add(x_rod2_frame_1_3, l * x_rod1_frame_3);
    let d1_of_place_4 = a_rod5_centre_1_3
        .mul_add(x_rod5_frame_1_5, a_rod4_centre_3_3 * x_rod4_frame_3_3);
    let d1_of_place_5 = a_rod5_centre_3_3.mul_add(x_rod5_frame_3_5, d1_of_place_3);
    let d1_of_place_6 = d1_of_place + d1_of_place_2;
    let d1_of_place_7 = d1_of_place_4 + d1_of_place_5;
    let d1_of_place_8 = w_rod3_frame_1_2
        .mul_add(x_rod3_frame_1_4, ratio_q_P2_u_P1 * x_rod2_frame_3_4);
    let d1_of_place_9 = w_rod4_frame_2_2
        .mul_add(x_rod4_frame_2_4, w_rod2_frame_in_rod3_frame_2_2 * x_rod3_frame_2_4);
    let d1_of_place_10 = x_rod2_frame_1_4.mul_add(sin_q_P2, x_rod1_frame_2_2);
    let d1_of_place_11 = w_rod4_frame_in_rod5_frame_1_2
        .mul_add(x_rod5_frame_1_6, w_rod3_frame_in_rod4_frame_3_2 * x_rod4_frame_3_4);
    let d1_of_place_12 = w_rod5_frame_3_2.mul_add(x_rod5_frame_3_6, d1_of_place_10);
    let d1_of_place_13 = d1_of_place_8 + d1_of_place_9;
    let d1_of_place_14 = d1_of_place_11 + d1_of_place_12;
    let d1_of_place_15 = d1_of_place_6 + d1_of_place_7;
    let d1_of_place_16 = d1_of_place_13 + d1_of_place_14;
    let d1 = x_rod3_frame_in_rod4_frame_1
        .mul_add(x_rod4_frame_1_3, x_rod2_frame_in_rod3_frame_3 * x_rod3_frame_3_3)
        + x_rod4_frame_in_rod5_frame_2 * x_rod5_frame_2_5
        + S::ratio(1, 4) * d1_of_place_15 + S::ratio(1, 12) * d1_of_place_16;
    let u_P1_dot_of_place = x_rod4_frame_1
        .mul_add(
            x_rod3_frame_in_rod4_frame_1,
            x_rod3_frame_3 * x_rod2_frame_in_rod3_frame_3,
        );
    let u_P1_dot_of_place_2 = (-x_rod2_frame_3)
        .mul_add(a_rod2_centre_3_2, x_rod2_frame_1 * x_rod5_frame_1_3);
    let u_P1_dot_of_place_3 = (-x_rod3_frame_2)
        .mul_add(a_rod3_centre_2_3, x_rod3_frame_1 * a_rod3_centre_1_3);
    let u_P1_dot_of_place_4 = x_rod4_frame_3
        .mul_add(a_rod4_centre_3_3, x_rod4_frame_2 * a_rod4_centre_2_3);
    let u_P1_dot_of_place_5 = (-x_rod5_frame_3)
        .mul_add(a_rod5_centre_3_3, x_rod5_frame_1 * a_rod5_centre_1_3);
    let u_P1_dot_of_place_6 = u_P1_dot_of_place_2 - u_P1_dot_of_place_3;
    let u_P1_dot_of_place_7 = u_P1_dot_of_place_4 - u_P1_dot_of_place_5;
    let u_P1_dot_of_place_8 = x_rod5_frame_2
        .mul_add(x_rod4_frame_in_rod5_frame_2, -u_P1_dot_of_place);
    let u_P1_dot_of_place_9 = u_P1_dot_of_place_6 + u_P1_dot_of_place_7;
    let u_P1_dot = S::ratio(1, 12)
        * ((-x_rod2_frame_1_2).mul_add(sin_q_P2, ratio_q_P2_u_P1 * x_rod2_frame_3_2)
            - x_rod2_frame_2_2 * cos_q_P2 + x_rod3_frame_2_2 * w_rod2_frame_in_rod3_frame_2_2
            - x_rod3_frame_1_2 * w_rod3_frame_1_2
            + x_rod3_frame_3_2 * w_rod2_frame_in_rod3_frame_3_2
            - x_rod4_frame_3_2 * w_rod3_frame_in_rod4_frame_3_2
            - x_rod4_frame_2_2 * w_rod4_frame_2_2 + x_rod5_frame_3_2 * w_rod5_frame_3_2
            + x_rod4_frame_1_2 * w_rod3_frame_in_rod4_frame_1_2
            - x_rod5_frame_1_2 * w_rod4_frame_in_rod5_frame_1_2
            - x_rod5_frame_2_2 * w_rod4_frame_in_rod5_frame_2_2
            + S::int(6) * u_P1_dot_of_place_8 - S::int(3) * u_P1_dot_of_place_9) / d1;
    [u_P1_dot]
}

/// Kinetic energy T.
///
/// 508 operations, 5 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 1]) -> S {
    let Parameters { l, m, .. } = *p;
    let [q_P1, q_P2, q_P3, q_P4, q_P5] = *q;
    let [u_P1] = *u;
    // Sines and cosines.
    let (sin_q_P5, cos_q_P5) = q_P5.sin_cos();
    let (sin_q_P4, cos_q_P4) = q_P4.sin_cos();
    let (sin_q_P3, cos_q_P3) = q_P3.sin_cos();
    let (sin_q_P2, cos_q_P2) = q_P2.sin_cos();
    let (sin_q_P1, cos_q_P1) = q_P1.sin_cos();
    // Step by step, each after the terms that it needs.
    let ratio_q_P2_u_P1_of_q_p5 = S::int(1) - sin_q_P5;
    let cos_q_p5_sq = cos_q_P5 * cos_q_P5;
    let ratio_q_P2_u_P1_of_q_p5_2 = ratio_q_P2_u_P1_of_q_p5
        .mul_add(S::int(2), -cos_q_p5_sq);
    let ratio_q_P2_u_P1_of_q_p5_3 = -ratio_q_P2_u_P1_of_q_p5_2;
    let cos_q_p4_sq = cos_q_P4 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5 = ratio_q_P2_u_P1_of_q_p5_3 * cos_q_p4_sq;
    let ratio_q_P2_u_P1_of_q_p5_4 = ratio_q_P2_u_P1_of_q_p5 - cos_q_p5_sq;
    let ratio_q_P2_u_P1_of_q_p5_5 = -ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_2 = ratio_q_P2_u_P1_of_q_p5_5 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_3 = ratio_q_P2_u_P1_of_q_p4_q_p5_2 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_4 = -sin_q_P4
        * (ratio_q_P2_u_P1_of_q_p4_q_p5 + ratio_q_P2_u_P1_of_q_p5_4)
        - ratio_q_P2_u_P1_of_q_p4_q_p5_3;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_5 = ratio_q_P2_u_P1_of_q_p4_q_p5_4 - ratio_q_P2_u_P1_of_q_p5_4;
    let ratio_q_P2_u_P1_of_q_p4 = S::int(1) + sin_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_6 = ratio_q_P2_u_P1_of_q_p5
        * (-cos_q_p4_sq).mul_add(S::int(2), ratio_q_P2_u_P1_of_q_p4);
    let sin_q_p3_cos_q_p5 = sin_q_P3 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place = cos_q_P3
        * ratio_q_P2_u_P1_of_q_p4_q_p5_6
            .mul_add(sin_q_p3_cos_q_p5, ratio_q_P2_u_P1_of_q_p4_q_p5_5 * cos_q_P3);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_7 = ratio_q_P2_u_P1_of_q_p5_5 * sin_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_8 = ratio_q_P2_u_P1_of_q_p4_q_p5_7
        - ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_9 = (-ratio_q_P2_u_P1_of_q_p5)
        .mul_add(S::int(3), cos_q_p5_sq) + S::int(2) * ratio_q_P2_u_P1_of_q_p4_q_p5_8;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_10 = ratio_q_P2_u_P1_of_q_p4_q_p5_7
        .mul_add(S::int(2), -ratio_q_P2_u_P1_of_q_p5);
    let cos_q_p3_cos_q_p5 = cos_q_P3 * cos_q_P5;
    let sin_q_p2_cos_q_p4 = sin_q_P2 * cos_q_P4;
    let cos_q_p2_cos_q_p4 = cos_q_P2 * cos_q_P4;
    let ratio_q_P2_u_P1_of_place_2 = sin_q_P2
        * (-ratio_q_P2_u_P1_of_q_p4_q_p5_6)
            .mul_add(cos_q_p3_cos_q_p5, ratio_q_P2_u_P1_of_q_p4_q_p5_5 * sin_q_P3);
    let ratio_q_P2_u_P1_of_place_3 = ratio_q_P2_u_P1_of_q_p4_q_p5_2 * sin_q_P2;
    let cos_q_p2_sin_q_p3 = cos_q_P2 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_4 = cos_q_P1
        * (sin_q_P1
            * (ratio_q_P2_u_P1_of_q_p4_q_p5_5 - S::int(2) * ratio_q_P2_u_P1_of_place
                + cos_q_P2
                    * (cos_q_P2
                        * (ratio_q_P2_u_P1_of_q_p5
                            + sin_q_P4
                                * ratio_q_P2_u_P1_of_q_p4_q_p5
                                    .mul_add(S::int(2), ratio_q_P2_u_P1_of_q_p5)
                            + S::int(2) * ratio_q_P2_u_P1_of_q_p4_q_p5_3 + ratio_q_P2_u_P1_of_place)
                        - sin_q_p2_cos_q_p4
                            * ratio_q_P2_u_P1_of_q_p4_q_p5_10
                                .mul_add(
                                    cos_q_p3_cos_q_p5,
                                    ratio_q_P2_u_P1_of_q_p4_q_p5_9 * sin_q_P3,
                                )))
            - cos_q_P1
                * (cos_q_P5
                    * (ratio_q_P2_u_P1_of_q_p4_q_p5_10 * cos_q_p2_cos_q_p4)
                        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_q_p4_q_p5_6 * sin_q_P2)
                    + cos_q_P3
                        * (-ratio_q_P2_u_P1_of_q_p4_q_p5_9)
                            .mul_add(
                                cos_q_p2_cos_q_p4,
                                S::int(2) * ratio_q_P2_u_P1_of_place_2,
                            )))
        + cos_q_P3
            * (cos_q_p2_cos_q_p4 * (ratio_q_P2_u_P1_of_q_p5_2 - ratio_q_P2_u_P1_of_q_p4_q_p5_8)
                + ratio_q_P2_u_P1_of_place_2)
        + cos_q_P4 * cos_q_P5
            * ratio_q_P2_u_P1_of_q_p4_q_p5_7
                .mul_add(cos_q_p2_sin_q_p3, ratio_q_P2_u_P1_of_place_3);
    let ratio_q_P2_u_P1_of_q_p3_q_p5 = S::int(1) - cos_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_11 = ratio_q_P2_u_P1_of_q_p4_q_p5_7 - S::int(1);
    let ratio_q_P2_u_P1_of_place_5 = ratio_q_P2_u_P1_of_q_p4_q_p5_11 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_6 = -ratio_q_P2_u_P1_of_q_p3_q_p5 - ratio_q_P2_u_P1_of_place_5;
    let ratio_q_P2_u_P1_of_place_7 = ratio_q_P2_u_P1_of_place_6
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5_2 * cos_q_P2);
    let ratio_q_P2_u_P1_of_place_8 = S::int(1) + ratio_q_P2_u_P1_of_place_7;
    let ratio_q_P2_u_P1_of_place_9 = ratio_q_P2_u_P1_of_q_p4_q_p5_11
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p5);
    let ratio_q_P2_u_P1_of_place_10 = ratio_q_P2_u_P1_of_place_9 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_11 = ratio_q_P2_u_P1_of_place_8
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_10);
    let l_sq = l * l;
    let ratio_q_P2_u_P1_of_place_12 = ratio_q_P2_u_P1_of_place_3
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_q_p4_q_p5_7 * cos_q_P2);
    let cos_q_p3_cos_q_p1 = cos_q_P1 * cos_q_P3;
    let sin_q_p3_cos_q_p1 = cos_q_P1 * sin_q_P3;
    let sin_q_p2_sin_q_p1 = sin_q_P1 * sin_q_P2;
    let ratio_q_P2_u_P1_of_place_13 = (sin_q_P2 * sin_q_P3)
        .mul_add(sin_q_P4, -cos_q_p2_cos_q_p4);
    let ratio_q_P2_u_P1_of_place_14 = l
        * (cos_q_P5 * sin_q_p2_sin_q_p1.mul_add(cos_q_P3, sin_q_p3_cos_q_p1)
            + sin_q_P5
                * (-ratio_q_P2_u_P1_of_place_13)
                    .mul_add(sin_q_P1, cos_q_p3_cos_q_p1 * sin_q_P4));
    let ratio_q_P2_u_P1_of_place_15 = (-sin_q_P3)
        .mul_add(sin_q_P5, cos_q_p3_cos_q_p5 * sin_q_P4);
    let ratio_q_P2_u_P1_of_place_16 = sin_q_p3_cos_q_p5
        .mul_add(sin_q_P4, cos_q_P3 * sin_q_P5);
    let ratio_q_P2_u_P1_of_place_17 = (-ratio_q_P2_u_P1_of_place_16)
        .mul_add(sin_q_P2, cos_q_p2_cos_q_p4 * cos_q_P5);
    let ratio_q_P2_u_P1_of_place_18 = ratio_q_P2_u_P1_of_place_17
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_15 * cos_q_P1);
    let cos_q_p2_sin_q_p4 = cos_q_P2 * sin_q_P4;
    let ratio_q_P2_u_P1_of_place_19 = cos_q_p3_cos_q_p1 * cos_q_P4;
    let ratio_q_P2_u_P1_of_place_20 = cos_q_P5
        * (ratio_q_P2_u_P1_of_place_19
            - sin_q_P1 * sin_q_p2_cos_q_p4.mul_add(sin_q_P3, cos_q_p2_sin_q_p4));
    let ratio_q_P2_u_P1_of_place_21 = l * ratio_q_P2_u_P1_of_place_20;
    let ratio_q_P2_u_P1_of_place_22 = l * ratio_q_P2_u_P1_of_place_7;
    let ratio_q_P2_u_P1_of_place_23 = ratio_q_P2_u_P1_of_place_6
        .mul_add(cos_q_P2, -ratio_q_P2_u_P1_of_place_3);
    let ratio_q_P2_u_P1_of_place_24 = ratio_q_P2_u_P1_of_place_16 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_25 = sin_q_p2_cos_q_p4
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_24);
    let ratio_q_P2_u_P1_of_place_26 = l * ratio_q_P2_u_P1_of_place_25;
    let ratio_q_P2_u_P1_of_place_27 = ratio_q_P2_u_P1_of_place_26 * sin_q_P1;
    let ratio_q_P2_u_P1_of_place_28 = (-ratio_q_P2_u_P1_of_place_18)
        .mul_add(
            ratio_q_P2_u_P1_of_place_27,
            ratio_q_P2_u_P1_of_place_14 * ratio_q_P2_u_P1_of_place_23 * sin_q_P1,
        );
    let ratio_q_P2_u_P1_of_place_29 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_7)
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5_2 * cos_q_p2_sin_q_p3);
    let ratio_q_P2_u_P1_of_place_30 = l * ratio_q_P2_u_P1_of_place_29;
    let ratio_q_P2_u_P1_of_place_31 = l_sq * ratio_q_P2_u_P1_of_place_25;
    let ratio_q_P2_u_P1_of_q_p3 = sin_q_P3 - S::int(1);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_2 = ratio_q_P2_u_P1_of_q_p5_5 * cos_q_P3;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_3 = (-ratio_q_P2_u_P1_of_q_p3)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_q_p3_q_p5_2);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_4 = ratio_q_P2_u_P1_of_q_p5_5 * sin_q_P3;
    let cos_q_p2_sin_q_p1 = sin_q_P1 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_32 = ratio_q_P2_u_P1_of_q_p4_q_p5_7 * cos_q_p2_sin_q_p1;
    let ratio_q_P2_u_P1_of_place_33 = cos_q_p2_sin_q_p1
        * (sin_q_P1 * cos_q_P5
            * (cos_q_p2_sin_q_p4
                - sin_q_P3
                    * sin_q_p2_cos_q_p4
                        .mul_add(ratio_q_P2_u_P1_of_q_p3, cos_q_p2_sin_q_p4))
            + cos_q_P3
                * (cos_q_P4
                    * (-ratio_q_P2_u_P1_of_q_p3_q_p5_3)
                        .mul_add(
                            cos_q_P1,
                            sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_of_q_p3_q_p5_4,
                        ) + ratio_q_P2_u_P1_of_place_32));
    let ratio_q_P2_u_P1_of_place_34 = ratio_q_P2_u_P1_of_place_22
        * (ratio_q_P2_u_P1_of_place_14
            * (-ratio_q_P2_u_P1_of_q_p4_q_p5_2)
                .mul_add(cos_q_p3_cos_q_p1, ratio_q_P2_u_P1_of_place_12 * sin_q_P1)
            - ratio_q_P2_u_P1_of_place_18 * ratio_q_P2_u_P1_of_place_21)
        + ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_of_place_30
        + ratio_q_P2_u_P1_of_place_31 * ratio_q_P2_u_P1_of_place_33;
    let ratio_q_P2_u_P1_of_place_35 = l
        * (sin_q_P1 * (cos_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_place_5)
            + ratio_q_P2_u_P1_of_place_10 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_36 = ratio_q_P2_u_P1_of_place_9 * cos_q_P2;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_5 = cos_q_p3_cos_q_p5 + ratio_q_P2_u_P1_of_q_p3_q_p5_4;
    let ratio_q_P2_u_P1_of_place_37 = cos_q_P1
        * (sin_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_2);
    let ratio_q_P2_u_P1_of_place_38 = sin_q_P1
        * (sin_q_P2
            * (sin_q_P1
                * (cos_q_P2
                    * (sin_q_P4 * (ratio_q_P2_u_P1_of_q_p5 - cos_q_p3_cos_q_p5)
                        + ratio_q_P2_u_P1_of_q_p3 * sin_q_P5)
                    - sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p3_q_p5_5)
                - ratio_q_P2_u_P1_of_place_37 * cos_q_P4) - ratio_q_P2_u_P1_of_place_24 * cos_q_P1);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_12 = cos_q_p4_sq
        + sin_q_P5 * (ratio_q_P2_u_P1_of_q_p4 - cos_q_p4_sq);
    let ratio_q_P2_u_P1_of_place_39 = ratio_q_P2_u_P1_of_q_p4_q_p5_12 * sin_q_P3;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_13 = sin_q_P5 + ratio_q_P2_u_P1_of_q_p4_q_p5_7;
    let ratio_q_P2_u_P1_of_place_40 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p4_q_p5_13;
    let ratio_q_P2_u_P1_of_place_41 = ratio_q_P2_u_P1_of_q_p4_q_p5_12 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_42 = ratio_q_P2_u_P1_of_q_p4 * sin_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_43 = ratio_q_P2_u_P1_of_place_7 * l_sq;
    let ratio_q_P2_u_P1_of_place_44 = l * ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_of_place_36
        - ratio_q_P2_u_P1_of_place_31 * ratio_q_P2_u_P1_of_place_38
        - ratio_q_P2_u_P1_of_place_43
            * (sin_q_p3_cos_q_p1 * cos_q_P1
                * (ratio_q_P2_u_P1_of_place_41 + ratio_q_P2_u_P1_of_place_42)
                + sin_q_P1
                    * (sin_q_P2
                        * (cos_q_P3
                            * (sin_q_P1
                                * (sin_q_P2
                                    * ratio_q_P2_u_P1_of_q_p4
                                        .mul_add(cos_q_p3_cos_q_p5, -ratio_q_P2_u_P1_of_place_39)
                                    + ratio_q_P2_u_P1_of_place_40)
                                + cos_q_P1
                                    * ratio_q_P2_u_P1_of_place_42
                                        .mul_add(S::int(2), ratio_q_P2_u_P1_of_place_41))
                            - sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_of_place_39)
                        + sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_of_place_40));
    let cos_q_p3_sin_q_p1 = sin_q_P1 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_45 = l
        * ratio_q_P2_u_P1_of_q_p4_q_p5_2
            .mul_add(cos_q_p3_sin_q_p1, ratio_q_P2_u_P1_of_place_12 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_46 = l_sq
        * ratio_q_P2_u_P1_of_place_29
            .mul_add(
                ratio_q_P2_u_P1_of_place_38,
                ratio_q_P2_u_P1_of_place_33 * ratio_q_P2_u_P1_of_place_36,
            )
        + ratio_q_P2_u_P1_of_place_43
            * (sin_q_P1
                * (sin_q_P2
                    * (cos_q_p3_cos_q_p5
                        * cos_q_p2_sin_q_p1
                            .mul_add(sin_q_P4, -ratio_q_P2_u_P1_of_place_19)
                        + sin_q_P3
                            * (ratio_q_P2_u_P1_of_place_32
                                + cos_q_P4
                                    * (cos_q_P1
                                        * (-ratio_q_P2_u_P1_of_q_p3_q_p5_2)
                                            .mul_add(S::int(2), sin_q_p3_cos_q_p5)
                                        + sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_of_q_p3_q_p5_5)))
                    + cos_q_p2_sin_q_p4 * ratio_q_P2_u_P1_of_place_37)
                - ratio_q_P2_u_P1_of_place_19 * ratio_q_P2_u_P1_of_place_37);
    let ratio_q_P2_u_P1_of_place_47 = l
        * (-ratio_q_P2_u_P1_of_place_17)
            .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_15 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_48 = l * ratio_q_P2_u_P1_of_place_23 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_49 = l
        / ((-ratio_q_P2_u_P1_of_place_34)
            .mul_add(
                ratio_q_P2_u_P1_of_place_35,
                ratio_q_P2_u_P1_of_place_44 * ratio_q_P2_u_P1_of_place_45,
            ) + ratio_q_P2_u_P1_of_place_46 * ratio_q_P2_u_P1_of_place_47
            + ratio_q_P2_u_P1_of_place_4 * l_sq * ratio_q_P2_u_P1_of_place_48);
    let ratio_q_P2_u_P1_of_place_50 = l_sq * ratio_q_P2_u_P1_of_place_49;
    let ratio_q_P2_u_P1_of_place_51 = ratio_q_P2_u_P1_of_place_14
        .mul_add(
            ratio_q_P2_u_P1_of_place_29,
            ratio_q_P2_u_P1_of_place_20 * ratio_q_P2_u_P1_of_place_26,
        );
    let ratio_q_P2_u_P1_of_place_52 = ratio_q_P2_u_P1_of_place_16
        .mul_add(cos_q_P1, sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_of_place_15);
    let ratio_q_P2_u_P1_of_place_53 = (-ratio_q_P2_u_P1_of_place_26)
        .mul_add(
            ratio_q_P2_u_P1_of_place_52,
            ratio_q_P2_u_P1_of_place_14 * ratio_q_P2_u_P1_of_place_36,
        );
    let ratio_q_P2_u_P1_of_place_54 = ratio_q_P2_u_P1_of_place_30
        .mul_add(
            ratio_q_P2_u_P1_of_place_52,
            ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_of_place_36,
        );
    let ratio_q_P2_u_P1_of_place_55 = ratio_q_P2_u_P1_of_place_49
        * (-ratio_q_P2_u_P1_of_place_9)
            .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_8 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_56 = ratio_q_P2_u_P1_of_place_50
        * (sin_q_P5 * (-cos_q_p3_cos_q_p1).mul_add(sin_q_P2, sin_q_P1 * sin_q_P3)
            - cos_q_P5
                * cos_q_p3_sin_q_p1
                    .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_place_13 * cos_q_P1));
    let ratio_q_P2_u_P1_of_place_57 = ratio_q_P2_u_P1_of_place_56 * cos_q_P5;
    let ratio_q_P2_u_P1 = ratio_q_P2_u_P1_of_place_55
        * ((-ratio_q_P2_u_P1_of_place_45)
            .mul_add(
                ratio_q_P2_u_P1_of_place_53,
                ratio_q_P2_u_P1_of_place_35 * ratio_q_P2_u_P1_of_place_51,
            ) - ratio_q_P2_u_P1_of_place_47 * ratio_q_P2_u_P1_of_place_54)
        + ratio_q_P2_u_P1_of_place_4 * ratio_q_P2_u_P1_of_place_11 * ratio_q_P2_u_P1_of_place_50
        + ratio_q_P2_u_P1_of_place_57 * (ratio_q_P2_u_P1_of_q_p4_q_p5_7 - ratio_q_P2_u_P1_of_q_p5);
    let ratio_q_P3_u_P1_of_place = (-ratio_q_P2_u_P1_of_place_25)
        .mul_add(
            ratio_q_P2_u_P1_of_place_27,
            ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_14,
        );
    let ratio_q_P3_u_P1_of_place_2 = ratio_q_P2_u_P1_of_place_27
        .mul_add(
            ratio_q_P2_u_P1_of_place_29,
            ratio_q_P2_u_P1_of_place_20 * ratio_q_P2_u_P1_of_place_22,
        );
    let ratio_q_P3_u_P1_of_place_3 = ratio_q_P2_u_P1_of_place_11 * ratio_q_P2_u_P1_of_place_49;
    let ratio_q_P3_u_P1_of_place_4 = ratio_q_P2_u_P1_of_place_56 * cos_q_P4;
    let ratio_q_P3_u_P1 = ratio_q_P2_u_P1_of_place_55
        * (ratio_q_P2_u_P1_of_place_45
            .mul_add(
                ratio_q_P3_u_P1_of_place,
                ratio_q_P2_u_P1_of_place_48 * ratio_q_P2_u_P1_of_place_51,
            ) + ratio_q_P2_u_P1_of_place_47 * ratio_q_P3_u_P1_of_place_2)
        + ratio_q_P2_u_P1_of_place_34 * ratio_q_P3_u_P1_of_place_3
        + ratio_q_P3_u_P1_of_place_4
            * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_3)
                .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_q_p5) + ratio_q_P2_u_P1_of_q_p3_q_p5_4);
    let ratio_q_P4_u_P1_of_place = (-(ratio_q_P2_u_P1_of_place_9 * ratio_q_P2_u_P1_of_place_26))
        .mul_add(
            cos_q_p2_sin_q_p1,
            ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_of_place_52,
        );
    let ratio_q_P4_u_P1 = ratio_q_P2_u_P1_of_place_57
        * (sin_q_P5 - sin_q_P3 - cos_q_p3_cos_q_p5
            - sin_q_P4
                * (ratio_q_P2_u_P1_of_q_p4_q_p5_7 - ratio_q_P2_u_P1_of_q_p3_q_p5
                    + sin_q_P3 * (S::int(2) - ratio_q_P2_u_P1_of_q_p4_q_p5_13)))
        + ratio_q_P2_u_P1_of_place_44 * ratio_q_P3_u_P1_of_place_3
        + ratio_q_P2_u_P1_of_place_55
            * (ratio_q_P2_u_P1_of_place_35
                .mul_add(
                    ratio_q_P3_u_P1_of_place,
                    ratio_q_P2_u_P1_of_place_48 * ratio_q_P2_u_P1_of_place_53,
                ) - ratio_q_P2_u_P1_of_place_47 * ratio_q_P4_u_P1_of_place);
    let ratio_q_P5_u_P1 = ratio_q_P3_u_P1_of_place_4
        * (sin_q_P4 * ratio_q_P2_u_P1_of_q_p5_3.mul_add(sin_q_P3, ratio_q_P2_u_P1_of_q_p5_2)
            + ratio_q_P2_u_P1_of_q_p5 * (ratio_q_P2_u_P1_of_q_p3_q_p5 - sin_q_P3))
        + ratio_q_P2_u_P1_of_place_46 * ratio_q_P3_u_P1_of_place_3
        + ratio_q_P2_u_P1_of_place_55
            * (ratio_q_P2_u_P1_of_place_35
                .mul_add(
                    ratio_q_P3_u_P1_of_place_2,
                    ratio_q_P2_u_P1_of_place_48 * ratio_q_P2_u_P1_of_place_54,
                ) + ratio_q_P2_u_P1_of_place_45 * ratio_q_P4_u_P1_of_place);
    let w_rod1_frame_in_rod2_frame_1 = u_P1 * sin_q_P2;
    let w_rod1_frame_in_rod2_frame_2 = u_P1 * cos_q_P2;
    let w_rod2_frame_3 = u_P1 * ratio_q_P2_u_P1;
    let m_l_sq = m * l_sq;
    let H_rod2_3 = w_rod2_frame_3 * m_l_sq;
    let H_rod2_1 = w_rod1_frame_in_rod2_frame_1 * m_l_sq;
    let w_rod3_frame_1 = u_P1.mul_add(ratio_q_P3_u_P1, w_rod1_frame_in_rod2_frame_1);
    let w_rod2_frame_in_rod3_frame_3 = (-w_rod2_frame_3)
        .mul_add(cos_q_P3, w_rod1_frame_in_rod2_frame_2 * sin_q_P3);
    let w_rod2_frame_in_rod3_frame_2 = w_rod2_frame_3
        .mul_add(sin_q_P3, w_rod1_frame_in_rod2_frame_2 * cos_q_P3);
    let H_rod3_2 = w_rod2_frame_in_rod3_frame_2 * m_l_sq;
    let H_rod3_1 = w_rod3_frame_1 * m_l_sq;
    let w_rod3_frame_in_rod4_frame_3 = (-w_rod2_frame_in_rod3_frame_3)
        .mul_add(cos_q_P4, w_rod3_frame_1 * sin_q_P4);
    let w_rod4_frame_2 = u_P1.mul_add(ratio_q_P4_u_P1, -w_rod2_frame_in_rod3_frame_2);
    let w_rod3_frame_in_rod4_frame_1 = w_rod2_frame_in_rod3_frame_3
        .mul_add(sin_q_P4, w_rod3_frame_1 * cos_q_P4);
    let H_rod4_2 = w_rod4_frame_2 * m_l_sq;
    let H_rod4_3 = w_rod3_frame_in_rod4_frame_3 * m_l_sq;
    let w_rod4_frame_in_rod5_frame_1 = (-w_rod4_frame_2)
        .mul_add(sin_q_P5, w_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let w_rod5_frame_3 = u_P1.mul_add(ratio_q_P5_u_P1, -w_rod3_frame_in_rod4_frame_3);
    let H_rod5_3 = w_rod5_frame_3 * m_l_sq;
    let H_rod5_1 = w_rod4_frame_in_rod5_frame_1 * m_l_sq;
    let x_rod1_frame_in_rod2_frame_3 = l * u_P1;
    let x_rod5_frame_3_7_of_place = l * w_rod1_frame_in_rod2_frame_1;
    let x_rod5_frame_3_7 = x_rod5_frame_3_7_of_place - x_rod1_frame_in_rod2_frame_3;
    let x_rod2_frame_in_rod3_frame_2_10 = x_rod5_frame_3_7 * sin_q_P3;
    let x_rod2_frame_in_rod3_frame_3_10 = x_rod5_frame_3_7 * cos_q_P3;
    let l_w_rod3_frame_1 = l * w_rod3_frame_1;
    let x_rod5_frame_2_6 = l_w_rod3_frame_1 - x_rod2_frame_in_rod3_frame_2_10;
    let H_rod1_2 = u_P1 * m_l_sq;
    let x_rod2_frame_1_5 = l * w_rod2_frame_3;
    let x_rod2_frame_3_5 = (-x_rod1_frame_in_rod2_frame_3)
        .mul_add(S::int(2), x_rod5_frame_3_7_of_place);
    let x_rod3_frame_1_5_of_place = l * w_rod2_frame_in_rod3_frame_2;
    let x_rod3_frame_1_5 = (-x_rod2_frame_1_5)
        .mul_add(S::int(2), x_rod3_frame_1_5_of_place);
    let x_rod3_frame_2_5 = (-x_rod2_frame_in_rod3_frame_2_10)
        .mul_add(S::int(2), l_w_rod3_frame_1);
    let x_rod4_frame_1_4 = x_rod3_frame_1_5_of_place - x_rod2_frame_1_5;
    let x_rod3_frame_in_rod4_frame_1_10 = (-x_rod4_frame_1_4)
        .mul_add(cos_q_P4, x_rod2_frame_in_rod3_frame_3_10 * sin_q_P4);
    let x_rod3_frame_in_rod4_frame_3_10 = x_rod4_frame_1_4
        .mul_add(sin_q_P4, x_rod2_frame_in_rod3_frame_3_10 * cos_q_P4);
    let x_rod4_frame_2_5_of_place = l * w_rod3_frame_in_rod4_frame_3;
    let x_rod4_frame_2_5 = x_rod5_frame_2_6
        .mul_add(S::int(2), x_rod4_frame_2_5_of_place);
    let l_w_rod4_frame_2 = l * w_rod4_frame_2;
    let x_rod4_frame_3_5 = (-x_rod3_frame_in_rod4_frame_3_10)
        .mul_add(S::int(2), l_w_rod4_frame_2);
    let x_rod5_frame_2_7 = x_rod5_frame_2_6 + x_rod4_frame_2_5_of_place;
    let x_rod5_frame_3_8 = l_w_rod4_frame_2 - x_rod3_frame_in_rod4_frame_3_10;
    let x_rod4_frame_in_rod5_frame_1_10 = x_rod5_frame_2_7
        .mul_add(sin_q_P5, x_rod3_frame_in_rod4_frame_1_10 * cos_q_P5);
    let x_rod4_frame_in_rod5_frame_2_10 = (-x_rod5_frame_2_7)
        .mul_add(cos_q_P5, x_rod3_frame_in_rod4_frame_1_10 * sin_q_P5);
    let x_rod5_frame_1_7 = x_rod4_frame_in_rod5_frame_1_10
        .mul_add(S::int(2), l * w_rod5_frame_3);
    let x_rod5_frame_3_9 = x_rod5_frame_3_8
        .mul_add(S::int(2), l * w_rod4_frame_in_rod5_frame_1);
    let energy_of_place = x_rod3_frame_in_rod4_frame_1_10
        .mul_add(
            x_rod3_frame_in_rod4_frame_1_10,
            x_rod2_frame_in_rod3_frame_3_10 * x_rod2_frame_in_rod3_frame_3_10,
        );
    let energy_of_place_2 = x_rod3_frame_1_5
        .mul_add(x_rod3_frame_1_5, x_rod2_frame_3_5 * x_rod2_frame_3_5);
    let energy_of_place_3 = x_rod4_frame_2_5
        .mul_add(x_rod4_frame_2_5, x_rod3_frame_2_5 * x_rod3_frame_2_5);
    let energy_of_place_4 = x_rod2_frame_1_5
        .mul_add(
            x_rod2_frame_1_5,
            x_rod1_frame_in_rod2_frame_3 * x_rod1_frame_in_rod2_frame_3,
        );
    let energy_of_place_5 = x_rod5_frame_1_7
        .mul_add(x_rod5_frame_1_7, x_rod4_frame_3_5 * x_rod4_frame_3_5);
    let energy_of_place_6 = x_rod5_frame_3_9
        .mul_add(x_rod5_frame_3_9, energy_of_place_4);
    let energy_of_place_7 = energy_of_place_2 + energy_of_place_3;
    let energy_of_place_8 = energy_of_place_5 + energy_of_place_6;
    let energy_of_place_9 = w_rod3_frame_1.mul_add(H_rod3_1, w_rod2_frame_3 * H_rod2_3);
    let energy_of_place_10 = w_rod4_frame_2
        .mul_add(H_rod4_2, w_rod2_frame_in_rod3_frame_2 * H_rod3_2);
    let energy_of_u_p1 = u_P1.mul_add(H_rod1_2, w_rod1_frame_in_rod2_frame_1 * H_rod2_1);
    let energy_of_place_11 = w_rod4_frame_in_rod5_frame_1
        .mul_add(H_rod5_1, w_rod3_frame_in_rod4_frame_3 * H_rod4_3);
    let energy_of_u_p1_2 = w_rod5_frame_3.mul_add(H_rod5_3, energy_of_u_p1);
    let energy_of_place_12 = energy_of_place_9 + energy_of_place_10;
    let energy_of_u_p1_3 = energy_of_place_11 + energy_of_u_p1_2;
    let energy_of_u_p1_4 = energy_of_place_12 + energy_of_u_p1_3;
    // Values.
    let energy = S::ratio(1, 2) * m
        * x_rod4_frame_in_rod5_frame_2_10
            .mul_add(x_rod4_frame_in_rod5_frame_2_10, energy_of_place)
        + S::ratio(1, 8) * m * (energy_of_place_7 + energy_of_place_8)
        + S::ratio(1, 24) * energy_of_u_p1_4;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 49 operations, 4 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5]) -> S {
    let Parameters { l, m, g } = *p;
    let [_, q_P2, q_P3, q_P4, q_P5] = *q;
    // Sines and cosines.
    let (sin_q_P2, cos_q_P2) = q_P2.sin_cos();
    let (sin_q_P3, cos_q_P3) = q_P3.sin_cos();
    let (sin_q_P4, cos_q_P4) = q_P4.sin_cos();
    let (sin_q_P5, cos_q_P5) = q_P5.sin_cos();
    // Step by step, each after the terms that it needs.
    let x_rod1_frame_3 = l * m;
    let x_rod1_frame_in_rod2_frame_1_8 = g * sin_q_P2;
    let x_rod1_frame_in_rod2_frame_2_8 = g * cos_q_P2;
    let x_rod2_frame_in_rod3_frame_2_11 = x_rod1_frame_in_rod2_frame_2_8 * cos_q_P3;
    let x_rod2_frame_in_rod3_frame_3_11 = x_rod1_frame_in_rod2_frame_2_8 * sin_q_P3;
    let x_rod3_frame_in_rod4_frame_1_11 = x_rod2_frame_in_rod3_frame_3_11
        .mul_add(sin_q_P4, x_rod1_frame_in_rod2_frame_1_8 * cos_q_P4);
    let x_rod3_frame_in_rod4_frame_3_11 = (-x_rod1_frame_in_rod2_frame_1_8)
        .mul_add(sin_q_P4, x_rod2_frame_in_rod3_frame_3_11 * cos_q_P4);
    let x_rod4_frame_in_rod5_frame_1_11 = x_rod3_frame_in_rod4_frame_1_11
        .mul_add(cos_q_P5, x_rod2_frame_in_rod3_frame_2_11 * sin_q_P5);
    let x_rod4_frame_in_rod5_frame_2_11 = (-x_rod2_frame_in_rod3_frame_2_11)
        .mul_add(cos_q_P5, x_rod3_frame_in_rod4_frame_1_11 * sin_q_P5);
    let x_rod1_frame_in_rod2_frame_1_9 = x_rod1_frame_3 * cos_q_P2;
    let x_rod1_frame_in_rod2_frame_2_9 = x_rod1_frame_3 * sin_q_P2;
    let x_rod5_frame_2_8 = (-x_rod1_frame_in_rod2_frame_2_9)
        .mul_add(S::int(9), S::int(7) * x_rod1_frame_3);
    let x_rod2_frame_in_rod3_frame_2_12 = x_rod5_frame_2_8 * cos_q_P3;
    let x_rod2_frame_in_rod3_frame_3_12 = x_rod5_frame_2_8 * sin_q_P3;
    let x_rod5_frame_3_10 = x_rod1_frame_3
        .mul_add(S::int(5), -x_rod2_frame_in_rod3_frame_3_12);
    let x_rod3_frame_in_rod4_frame_1_12_of_place = S::int(9) * x_rod1_frame_in_rod2_frame_1_9;
    let x_rod3_frame_in_rod4_frame_1_12 = (-x_rod3_frame_in_rod4_frame_1_12_of_place)
        .mul_add(cos_q_P4, x_rod5_frame_3_10 * sin_q_P4);
    let x_rod3_frame_in_rod4_frame_3_12 = x_rod3_frame_in_rod4_frame_1_12_of_place
        .mul_add(sin_q_P4, x_rod5_frame_3_10 * cos_q_P4);
    let x_rod5_frame_1_8 = x_rod1_frame_3
        .mul_add(S::int(3), x_rod3_frame_in_rod4_frame_1_12);
    let x_rod4_frame_in_rod5_frame_1_12 = (-x_rod2_frame_in_rod3_frame_2_12)
        .mul_add(sin_q_P5, x_rod5_frame_1_8 * cos_q_P5);
    let x_rod4_frame_in_rod5_frame_2_12 = x_rod5_frame_1_8
        .mul_add(sin_q_P5, x_rod2_frame_in_rod3_frame_2_12 * cos_q_P5);
    let x_rod5_frame_2_9 = x_rod1_frame_3 - x_rod4_frame_in_rod5_frame_2_12;
    let energy_of_place = (-x_rod4_frame_in_rod5_frame_2_11)
        .mul_add(
            x_rod5_frame_2_9,
            x_rod4_frame_in_rod5_frame_1_11 * x_rod4_frame_in_rod5_frame_1_12,
        );
    let energy_of_place_2 = x_rod3_frame_in_rod4_frame_3_11
        .mul_add(x_rod3_frame_in_rod4_frame_3_12, energy_of_place);
    // Values.
    let energy = -S::ratio(1, 2) * energy_of_place_2;
    energy
}

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u) row by row, and its right-hand side, which share terms.
///
/// 1860 operations, 5 sines and cosines.
#[must_use]
pub fn linear_system<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 1],
) -> ([S; 900], [S; 30]) {
    let Parameters { l, m, g } = *p;
    let [q_P1, q_P2, q_P3, q_P4, q_P5] = *q;
    let [u_P1] = *u;
    // Sines and cosines.
    let (sin_q_P2, cos_q_P2) = q_P2.sin_cos();
    let (sin_q_P4, cos_q_P4) = q_P4.sin_cos();
    let (sin_q_P3, cos_q_P3) = q_P3.sin_cos();
    let (sin_q_P1, cos_q_P1) = q_P1.sin_cos();
    let (sin_q_P5, cos_q_P5) = q_P5.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_rod1_frame_22 = u_P1 * u_P1;
    let a_rod1_centre_1 = l * w_rod1_frame_22;
    let x_rod1_frame_1 = m * a_rod1_centre_1;
    let x_rod1_frame_2 = m * g;
    let sin_q_p2_cos_q_p4 = sin_q_P2 * cos_q_P4;
    let cos_q_p2_sin_q_p4 = cos_q_P2 * sin_q_P4;
    let ratio_q_P2_u_P1_of_place = sin_q_p2_cos_q_p4
        .mul_add(sin_q_P3, cos_q_p2_sin_q_p4);
    let cos_q_p3_cos_q_p1 = cos_q_P1 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_2 = cos_q_p3_cos_q_p1 * cos_q_P4;
    let ratio_q_P2_u_P1_of_place_3 = (-ratio_q_P2_u_P1_of_place)
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_2);
    let sin_q_p3_cos_q_p5 = sin_q_P3 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_4 = sin_q_p3_cos_q_p5
        .mul_add(sin_q_P4, cos_q_P3 * sin_q_P5);
    let ratio_q_P2_u_P1_of_place_5 = ratio_q_P2_u_P1_of_place_4
        .mul_add(cos_q_P2, sin_q_p2_cos_q_p4 * cos_q_P5);
    let ratio_q_P2_u_P1_of_place_6 = l * ratio_q_P2_u_P1_of_place_5;
    let ratio_q_P2_u_P1_of_q_p5 = S::int(1) - sin_q_P5;
    let ratio_q_P2_u_P1_of_q_p5_2 = -ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5 = ratio_q_P2_u_P1_of_q_p5_2 * sin_q_P4;
    let cos_q_p2_cos_q_p4 = cos_q_P2 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p3_q_p5 = ratio_q_P2_u_P1_of_q_p5_2 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_7 = (-ratio_q_P2_u_P1_of_q_p4_q_p5)
        .mul_add(sin_q_P2, cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p3_q_p5);
    let x_rod1_frame_in_rod2_frame_2_3 = sin_q_P1 * sin_q_P2;
    let sin_q_p3_cos_q_p1 = cos_q_P1 * sin_q_P3;
    let x_rod2_frame_in_rod3_frame_2_5 = x_rod1_frame_in_rod2_frame_2_3
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p1);
    let sin_q_p2_sin_q_p4 = sin_q_P2 * sin_q_P4;
    let ratio_q_P2_u_P1_of_place_8 = sin_q_p2_sin_q_p4
        .mul_add(sin_q_P3, -cos_q_p2_cos_q_p4);
    let ratio_q_P2_u_P1_of_place_9 = (-ratio_q_P2_u_P1_of_place_8)
        .mul_add(sin_q_P1, cos_q_p3_cos_q_p1 * sin_q_P4);
    let ratio_q_P2_u_P1_of_place_10 = x_rod2_frame_in_rod3_frame_2_5 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_11 = l
        * ratio_q_P2_u_P1_of_place_9.mul_add(sin_q_P5, ratio_q_P2_u_P1_of_place_10);
    let ratio_q_P2_u_P1_of_place_12 = ratio_q_P2_u_P1_of_place_7
        .mul_add(
            ratio_q_P2_u_P1_of_place_11,
            ratio_q_P2_u_P1_of_place_3 * ratio_q_P2_u_P1_of_place_6 * cos_q_P5,
        );
    let cos_q_p3_cos_q_p5 = cos_q_P3 * cos_q_P5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_2 = ratio_q_P2_u_P1_of_q_p4_q_p5 - S::int(1);
    let ratio_q_P2_u_P1_of_place_13 = ratio_q_P2_u_P1_of_q_p4_q_p5_2 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_14 = cos_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_place_13;
    let ratio_q_P2_u_P1_of_place_15 = ratio_q_P2_u_P1_of_q_p4_q_p5_2
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p5);
    let x_rod1_frame_in_rod2_frame_2_2 = cos_q_P1 * sin_q_P2;
    let ratio_q_P2_u_P1_of_place_16 = l
        * x_rod1_frame_in_rod2_frame_2_2
            .mul_add(
                ratio_q_P2_u_P1_of_place_15,
                ratio_q_P2_u_P1_of_place_14 * sin_q_P1,
            );
    let ratio_q_P2_u_P1_of_place_17 = (-sin_q_P3)
        .mul_add(sin_q_P5, cos_q_p3_cos_q_p5 * sin_q_P4);
    let ratio_q_P2_u_P1_of_place_18 = x_rod1_frame_in_rod2_frame_2_3
        .mul_add(ratio_q_P2_u_P1_of_place_17, ratio_q_P2_u_P1_of_place_4 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_19 = ratio_q_P2_u_P1_of_place_15 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_20 = (-ratio_q_P2_u_P1_of_place_6)
        .mul_add(
            ratio_q_P2_u_P1_of_place_18,
            ratio_q_P2_u_P1_of_place_11 * ratio_q_P2_u_P1_of_place_19,
        );
    let ratio_q_P2_u_P1_of_place_21 = ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_22 = sin_q_p2_cos_q_p4
        .mul_add(ratio_q_P2_u_P1_of_q_p3_q_p5, ratio_q_P2_u_P1_of_place_21);
    let cos_q_p3_sin_q_p1 = sin_q_P1 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_23 = l
        * (ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p3_sin_q_p1)
            .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_22 * cos_q_P1);
    let x_rod5_frame_in_rod4_frame_2 = l * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_24 = x_rod5_frame_in_rod4_frame_2 * ratio_q_P2_u_P1_of_place_3;
    let ratio_q_P2_u_P1_of_place_25 = l * ratio_q_P2_u_P1_of_place_7;
    let ratio_q_P2_u_P1_of_place_26 = ratio_q_P2_u_P1_of_place_18
        .mul_add(
            ratio_q_P2_u_P1_of_place_25,
            ratio_q_P2_u_P1_of_place_19 * ratio_q_P2_u_P1_of_place_24,
        );
    let ratio_q_P2_u_P1_of_place_27 = (-ratio_q_P2_u_P1_of_place_4)
        .mul_add(sin_q_P2, cos_q_p2_cos_q_p4 * cos_q_P5);
    let ratio_q_P2_u_P1_of_place_28 = (-ratio_q_P2_u_P1_of_place_27)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_17 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_29 = l * ratio_q_P2_u_P1_of_place_28;
    let ratio_q_P2_u_P1_of_place_30 = (-ratio_q_P2_u_P1_of_place_20)
        .mul_add(
            ratio_q_P2_u_P1_of_place_23,
            ratio_q_P2_u_P1_of_place_12 * ratio_q_P2_u_P1_of_place_16,
        ) - ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_of_place_29;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_2 = S::int(1) - cos_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_31 = -ratio_q_P2_u_P1_of_place_13 - ratio_q_P2_u_P1_of_q_p3_q_p5_2;
    let ratio_q_P2_u_P1_of_place_32 = ratio_q_P2_u_P1_of_place_31
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p2_cos_q_p4);
    let ratio_q_P2_u_P1_of_place_33 = S::int(1) + ratio_q_P2_u_P1_of_place_32;
    let ratio_q_P2_u_P1_of_place_34 = (-ratio_q_P2_u_P1_of_place_15)
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_33 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_35 = (-ratio_q_P2_u_P1_of_place_2)
        .mul_add(ratio_q_P2_u_P1_of_q_p5_2, ratio_q_P2_u_P1_of_place_22 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_36 = ratio_q_P2_u_P1_of_place_27
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_17 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_37 = (-ratio_q_P2_u_P1_of_place_24)
        .mul_add(
            ratio_q_P2_u_P1_of_place_36,
            ratio_q_P2_u_P1_of_place_11 * ratio_q_P2_u_P1_of_place_35,
        );
    let ratio_q_P2_u_P1_of_place_38 = l * ratio_q_P2_u_P1_of_place_32;
    let ratio_q_P2_u_P1_of_place_39 = sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p5_2;
    let ratio_q_P2_u_P1_of_place_40 = ratio_q_P2_u_P1_of_place_31
        .mul_add(cos_q_P2, -ratio_q_P2_u_P1_of_place_39);
    let ratio_q_P2_u_P1_of_place_41 = ratio_q_P2_u_P1_of_place_6 * sin_q_P1;
    let ratio_q_P2_u_P1_of_place_42 = (-ratio_q_P2_u_P1_of_place_36)
        .mul_add(
            ratio_q_P2_u_P1_of_place_41,
            ratio_q_P2_u_P1_of_place_11 * ratio_q_P2_u_P1_of_place_40 * sin_q_P1,
        );
    let x_rod1_frame_in_rod2_frame_1_3 = sin_q_P1 * cos_q_P2;
    let ratio_q_P2_u_P1_of_q_p3 = sin_q_P3 - S::int(1);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_3 = ratio_q_P2_u_P1_of_q_p5_2 * cos_q_P3;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_4 = (-ratio_q_P2_u_P1_of_q_p3)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_q_p3_q_p5_3);
    let ratio_q_P2_u_P1_of_place_43 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
        .mul_add(
            cos_q_P1,
            x_rod1_frame_in_rod2_frame_2_3 * ratio_q_P2_u_P1_of_q_p3_q_p5,
        );
    let ratio_q_P2_u_P1_of_place_44 = x_rod1_frame_in_rod2_frame_1_3 * ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_place_45 = ratio_q_P2_u_P1_of_place_43
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_44);
    let ratio_q_P2_u_P1_of_place_46 = sin_q_p2_cos_q_p4
        .mul_add(ratio_q_P2_u_P1_of_q_p3, cos_q_p2_sin_q_p4);
    let ratio_q_P2_u_P1_of_place_47 = (-ratio_q_P2_u_P1_of_place_46)
        .mul_add(sin_q_P3, cos_q_p2_sin_q_p4);
    let cos_q_p5_sin_q_p1 = sin_q_P1 * cos_q_P5;
    let l_sq = l * l;
    let ratio_q_P2_u_P1_of_place_48 = l_sq
        * ratio_q_P2_u_P1_of_place_47
            .mul_add(cos_q_p5_sin_q_p1, ratio_q_P2_u_P1_of_place_45 * cos_q_P3);
    let ratio_q_P2_u_P1_of_place_49 = x_rod1_frame_in_rod2_frame_1_3 * ratio_q_P2_u_P1_of_place_48;
    let ratio_q_P2_u_P1_of_place_50 = ratio_q_P2_u_P1_of_place_25
        .mul_add(
            ratio_q_P2_u_P1_of_place_42,
            ratio_q_P2_u_P1_of_place_37 * ratio_q_P2_u_P1_of_place_38,
        ) + ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_49;
    let ratio_q_P2_u_P1_of_q_p4 = S::int(1) + sin_q_P4;
    let cos_q_p4_sq = cos_q_P4 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_2 = ratio_q_P2_u_P1_of_q_p4 - cos_q_p4_sq;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_3 = ratio_q_P2_u_P1_of_q_p4_2
        .mul_add(sin_q_P5, cos_q_p4_sq);
    let ratio_q_P2_u_P1_of_place_51 = ratio_q_P2_u_P1_of_q_p4_q_p5_3 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_52 = (-cos_q_p3_cos_q_p5)
        .mul_add(ratio_q_P2_u_P1_of_q_p4, ratio_q_P2_u_P1_of_place_51);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_4 = sin_q_P5 + ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_place_53 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p4_q_p5_4;
    let ratio_q_P2_u_P1_of_place_54 = ratio_q_P2_u_P1_of_place_52
        .mul_add(sin_q_P2, -ratio_q_P2_u_P1_of_place_53);
    let ratio_q_P2_u_P1_of_place_55 = ratio_q_P2_u_P1_of_q_p4_q_p5_3 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_56 = sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_of_q_p4;
    let ratio_q_P2_u_P1_of_place_57 = ratio_q_P2_u_P1_of_place_56
        .mul_add(S::int(2), ratio_q_P2_u_P1_of_place_55);
    let ratio_q_P2_u_P1_of_place_58 = (-ratio_q_P2_u_P1_of_place_57)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_54 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_59 = ratio_q_P2_u_P1_of_place_58
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_of_place_51);
    let ratio_q_P2_u_P1_of_place_60 = (-sin_q_p3_cos_q_p1)
        .mul_add(ratio_q_P2_u_P1_of_place_53, ratio_q_P2_u_P1_of_place_59 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_61 = ratio_q_P2_u_P1_of_place_55 + ratio_q_P2_u_P1_of_place_56;
    let ratio_q_P2_u_P1_of_place_62 = ratio_q_P2_u_P1_of_place_61 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_63 = (-sin_q_p3_cos_q_p1)
        .mul_add(ratio_q_P2_u_P1_of_place_62, ratio_q_P2_u_P1_of_place_60 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_64 = ratio_q_P2_u_P1_of_place_32 * l_sq;
    let ratio_q_P2_u_P1_of_place_65 = l * ratio_q_P2_u_P1_of_place_19;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_5 = cos_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_place_66 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_5)
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_q_p3 * sin_q_P5);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_6 = ratio_q_P2_u_P1_of_q_p3_q_p5 + cos_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_67 = (-sin_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_of_q_p3_q_p5_6, ratio_q_P2_u_P1_of_place_66 * cos_q_P2);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_7 = sin_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_3;
    let ratio_q_P2_u_P1_of_place_68 = ratio_q_P2_u_P1_of_q_p3_q_p5_7 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_69 = (-ratio_q_P2_u_P1_of_place_68)
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_67 * sin_q_P1);
    let x_rod1_frame_in_rod2_frame_1_2 = cos_q_P1 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_70 = (-x_rod1_frame_in_rod2_frame_1_2)
        .mul_add(ratio_q_P2_u_P1_of_place_4, ratio_q_P2_u_P1_of_place_69 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_71 = l_sq * ratio_q_P2_u_P1_of_place_70 * sin_q_P1;
    let ratio_q_P2_u_P1_of_place_72 = ratio_q_P2_u_P1_of_place_42
        .mul_add(
            ratio_q_P2_u_P1_of_place_65,
            ratio_q_P2_u_P1_of_place_63 * ratio_q_P2_u_P1_of_place_64,
        ) - ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_71;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_8 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_3)
        .mul_add(S::int(2), sin_q_p3_cos_q_p5);
    let ratio_q_P2_u_P1_of_place_73 = ratio_q_P2_u_P1_of_q_p3_q_p5_8
        .mul_add(
            cos_q_P1,
            x_rod1_frame_in_rod2_frame_2_3 * ratio_q_P2_u_P1_of_q_p3_q_p5_6,
        );
    let ratio_q_P2_u_P1_of_place_74 = ratio_q_P2_u_P1_of_place_73
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_44);
    let ratio_q_P2_u_P1_of_place_75 = x_rod1_frame_in_rod2_frame_1_3 * sin_q_P4;
    let ratio_q_P2_u_P1_of_place_76 = ratio_q_P2_u_P1_of_place_2 - ratio_q_P2_u_P1_of_place_75;
    let ratio_q_P2_u_P1_of_place_77 = (-cos_q_p3_cos_q_p5)
        .mul_add(ratio_q_P2_u_P1_of_place_76, ratio_q_P2_u_P1_of_place_74 * sin_q_P3);
    let ratio_q_P2_u_P1_of_place_78 = ratio_q_P2_u_P1_of_place_77
        .mul_add(sin_q_P2, cos_q_p2_sin_q_p4 * ratio_q_P2_u_P1_of_place_68);
    let ratio_q_P2_u_P1_of_place_79 = (-ratio_q_P2_u_P1_of_place_2)
        .mul_add(ratio_q_P2_u_P1_of_place_68, ratio_q_P2_u_P1_of_place_78 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_80 = ratio_q_P2_u_P1_of_place_7
        .mul_add(
            ratio_q_P2_u_P1_of_place_71,
            ratio_q_P2_u_P1_of_place_19 * ratio_q_P2_u_P1_of_place_49,
        ) + ratio_q_P2_u_P1_of_place_64 * ratio_q_P2_u_P1_of_place_79;
    let ratio_q_P2_u_P1_of_place_81 = l * ratio_q_P2_u_P1_of_place_40;
    let ratio_q_P2_u_P1_of_place_82 = ratio_q_P2_u_P1_of_place_81 * cos_q_P1;
    let cos_q_p5_sq = cos_q_P5 * cos_q_P5;
    let ratio_q_P2_u_P1_of_q_p5_3 = ratio_q_P2_u_P1_of_q_p5
        .mul_add(S::int(2), -cos_q_p5_sq);
    let ratio_q_P2_u_P1_of_q_p5_4 = -ratio_q_P2_u_P1_of_q_p5_3;
    let cos_q_p4_sq_doubled = S::int(2) * cos_q_p4_sq;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_5 = ratio_q_P2_u_P1_of_q_p5_4 * cos_q_p4_sq_doubled;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_6 = -ratio_q_P2_u_P1_of_q_p5 - ratio_q_P2_u_P1_of_q_p4_q_p5_5;
    let ratio_q_P2_u_P1_of_q_p5_5 = ratio_q_P2_u_P1_of_q_p5 - cos_q_p5_sq;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_7 = cos_q_p4_sq * ratio_q_P2_u_P1_of_q_p5_4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_8 = -ratio_q_P2_u_P1_of_q_p5_5
        - ratio_q_P2_u_P1_of_q_p4_q_p5_7;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_9 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(cos_q_p4_sq, ratio_q_P2_u_P1_of_q_p4_q_p5_8 * sin_q_P4);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_10 = ratio_q_P2_u_P1_of_q_p4_q_p5_9
        - ratio_q_P2_u_P1_of_q_p5_5;
    let ratio_q_P2_u_P1_of_q_p4_3 = ratio_q_P2_u_P1_of_q_p4 - cos_q_p4_sq_doubled;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_11 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_of_q_p4_3;
    let ratio_q_P2_u_P1_of_place_83 = sin_q_p3_cos_q_p5
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_11,
            ratio_q_P2_u_P1_of_q_p4_q_p5_10 * cos_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_84 = ratio_q_P2_u_P1_of_place_83 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_85 = ratio_q_P2_u_P1_of_q_p4_q_p5_6
        .mul_add(sin_q_P4, -ratio_q_P2_u_P1_of_q_p5)
        - ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p4_sq_doubled - ratio_q_P2_u_P1_of_place_84;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_12 = S::int(2) * ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_13 = (-ratio_q_P2_u_P1_of_q_p5)
        .mul_add(S::int(3), cos_q_p5_sq) - ratio_q_P2_u_P1_of_q_p4_q_p5_5
        + ratio_q_P2_u_P1_of_q_p4_q_p5_12;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_14 = ratio_q_P2_u_P1_of_q_p4_q_p5_12 - ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_place_86 = cos_q_p3_cos_q_p5
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_14,
            ratio_q_P2_u_P1_of_q_p4_q_p5_13 * sin_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_87 = sin_q_p2_cos_q_p4
        .mul_add(ratio_q_P2_u_P1_of_place_86, ratio_q_P2_u_P1_of_place_85 * cos_q_P2);
    let ratio_q_P2_u_P1_of_place_88 = (-ratio_q_P2_u_P1_of_place_84)
        .mul_add(S::int(2), ratio_q_P2_u_P1_of_q_p4_q_p5_10)
        - ratio_q_P2_u_P1_of_place_87 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_89 = (-cos_q_p3_cos_q_p5)
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_11,
            ratio_q_P2_u_P1_of_q_p4_q_p5_10 * sin_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_90 = ratio_q_P2_u_P1_of_place_89 * sin_q_P2;
    let ratio_q_P2_u_P1_of_place_91 = (-cos_q_p2_cos_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_13,
            S::int(2) * ratio_q_P2_u_P1_of_place_90,
        );
    let ratio_q_P2_u_P1_of_place_92 = cos_q_p2_cos_q_p4 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_93 = ratio_q_P2_u_P1_of_q_p4_q_p5_14
        .mul_add(
            ratio_q_P2_u_P1_of_place_92,
            ratio_q_P2_u_P1_of_q_p4_q_p5_11 * sin_q_P2,
        );
    let ratio_q_P2_u_P1_of_place_94 = ratio_q_P2_u_P1_of_place_93
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_91 * cos_q_P3);
    let ratio_q_P2_u_P1_of_place_95 = (-ratio_q_P2_u_P1_of_place_94)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_88 * sin_q_P1);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_15 = ratio_q_P2_u_P1_of_q_p4_q_p5
        - ratio_q_P2_u_P1_of_q_p5_3 - ratio_q_P2_u_P1_of_q_p4_q_p5_7;
    let ratio_q_P2_u_P1_of_place_96 = (-cos_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_of_q_p4_q_p5_15, ratio_q_P2_u_P1_of_place_90);
    let x_rod2_frame_in_rod3_frame_3_4 = cos_q_P2 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_97 = x_rod2_frame_in_rod3_frame_3_4
        .mul_add(ratio_q_P2_u_P1_of_q_p4_q_p5, ratio_q_P2_u_P1_of_place_39);
    let cos_q_p4_cos_q_p5 = cos_q_P4 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_98 = ratio_q_P2_u_P1_of_place_96
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_of_place_95 * cos_q_P1)
        + ratio_q_P2_u_P1_of_place_97 * cos_q_p4_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_99 = l_sq * ratio_q_P2_u_P1_of_place_98;
    let ratio_q_P2_u_P1_of_place_100 = S::int(1)
        / ((-ratio_q_P2_u_P1_of_place_16)
            .mul_add(
                ratio_q_P2_u_P1_of_place_50,
                ratio_q_P2_u_P1_of_place_23 * ratio_q_P2_u_P1_of_place_72,
            ) + ratio_q_P2_u_P1_of_place_29 * ratio_q_P2_u_P1_of_place_80
            + ratio_q_P2_u_P1_of_place_82 * ratio_q_P2_u_P1_of_place_99);
    let ratio_q_P2_u_P1_of_place_101 = l * ratio_q_P2_u_P1_of_place_100;
    let ratio_q_P2_u_P1_of_place_102 = ratio_q_P2_u_P1_of_place_34 * ratio_q_P2_u_P1_of_place_101;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_16 = ratio_q_P2_u_P1_of_q_p4_q_p5 - ratio_q_P2_u_P1_of_q_p5;
    let sin_q_p3_sin_q_p1 = sin_q_P1 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_103 = (-cos_q_p3_cos_q_p1)
        .mul_add(sin_q_P2, sin_q_p3_sin_q_p1);
    let ratio_q_P2_u_P1_of_place_104 = cos_q_p3_sin_q_p1
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_place_8 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_105 = (-ratio_q_P2_u_P1_of_place_104)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_103 * sin_q_P5);
    let ratio_q_P2_u_P1_of_place_106 = l_sq * ratio_q_P2_u_P1_of_place_101;
    let ratio_q_P2_u_P1_of_place_107 = ratio_q_P2_u_P1_of_place_105 * ratio_q_P2_u_P1_of_place_106;
    let ratio_q_P2_u_P1_of_place_108 = ratio_q_P2_u_P1_of_place_107 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_109 = ratio_q_P2_u_P1_of_place_33
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_15 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_110 = ratio_q_P2_u_P1_of_place_98 * ratio_q_P2_u_P1_of_place_106;
    let ratio_q_P2_u_P1 = ratio_q_P2_u_P1_of_q_p4_q_p5_16
        .mul_add(
            ratio_q_P2_u_P1_of_place_108,
            ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_of_place_102,
        ) + ratio_q_P2_u_P1_of_place_109 * ratio_q_P2_u_P1_of_place_110;
    let ratio_q_P3_u_P1_of_place = (-ratio_q_P2_u_P1_of_place_5)
        .mul_add(
            ratio_q_P2_u_P1_of_place_41,
            ratio_q_P2_u_P1_of_place_11 * ratio_q_P2_u_P1_of_place_32,
        );
    let ratio_q_P3_u_P1_of_place_2 = ratio_q_P2_u_P1_of_place_7
        .mul_add(
            ratio_q_P2_u_P1_of_place_41,
            ratio_q_P2_u_P1_of_place_24 * ratio_q_P2_u_P1_of_place_32,
        );
    let ratio_q_P3_u_P1_of_place_3 = ratio_q_P2_u_P1_of_place_23
        .mul_add(
            ratio_q_P3_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_12 * ratio_q_P2_u_P1_of_place_82,
        ) + ratio_q_P2_u_P1_of_place_29 * ratio_q_P3_u_P1_of_place_2;
    let ratio_q_P3_u_P1_of_place_4 = ratio_q_P2_u_P1_of_place_101 * ratio_q_P2_u_P1_of_place_109;
    let ratio_q_P3_u_P1_of_q_p3_q_p5 = ratio_q_P2_u_P1_of_q_p3_q_p5_4
        .mul_add(cos_q_P5, -ratio_q_P2_u_P1_of_q_p5) - ratio_q_P2_u_P1_of_q_p3_q_p5;
    let ratio_q_P3_u_P1_of_place_5 = ratio_q_P2_u_P1_of_place_107 * cos_q_P4;
    let ratio_q_P3_u_P1 = ratio_q_P2_u_P1_of_place_50
        .mul_add(
            ratio_q_P3_u_P1_of_place_4,
            ratio_q_P2_u_P1_of_place_102 * ratio_q_P3_u_P1_of_place_3,
        ) - ratio_q_P3_u_P1_of_q_p3_q_p5 * ratio_q_P3_u_P1_of_place_5;
    let ratio_q_P4_u_P1_of_place = x_rod1_frame_in_rod2_frame_1_3 * ratio_q_P2_u_P1_of_place_15;
    let ratio_q_P4_u_P1_of_place_2 = (-ratio_q_P2_u_P1_of_place_6)
        .mul_add(
            ratio_q_P4_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_18 * ratio_q_P2_u_P1_of_place_38,
        );
    let ratio_q_P4_u_P1_of_place_3 = ratio_q_P2_u_P1_of_place_16
        .mul_add(
            ratio_q_P3_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_20 * ratio_q_P2_u_P1_of_place_82,
        ) - ratio_q_P2_u_P1_of_place_29 * ratio_q_P4_u_P1_of_place_2;
    let ratio_q_P4_u_P1_of_q_p4_q_p5 = ratio_q_P2_u_P1_of_q_p4_q_p5_4 - S::int(2);
    let ratio_q_P4_u_P1_of_place_4 = (-ratio_q_P4_u_P1_of_q_p4_q_p5)
        .mul_add(
            sin_q_P3,
            ratio_q_P2_u_P1_of_q_p4_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_2,
        );
    let ratio_q_P4_u_P1_of_place_5 = ratio_q_P4_u_P1_of_place_4
        .mul_add(sin_q_P4, sin_q_P3 - sin_q_P5 + cos_q_p3_cos_q_p5);
    let ratio_q_P4_u_P1 = ratio_q_P2_u_P1_of_place_102
        .mul_add(
            ratio_q_P4_u_P1_of_place_3,
            ratio_q_P2_u_P1_of_place_72 * ratio_q_P3_u_P1_of_place_4,
        ) - ratio_q_P2_u_P1_of_place_108 * ratio_q_P4_u_P1_of_place_5;
    let ratio_q_P5_u_P1_of_place = ratio_q_P2_u_P1_of_place_16
        .mul_add(
            ratio_q_P3_u_P1_of_place_2,
            ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_of_place_82,
        ) + ratio_q_P2_u_P1_of_place_23 * ratio_q_P4_u_P1_of_place_2;
    let ratio_q_P5_u_P1_of_q_p3_q_p5 = (-ratio_q_P2_u_P1_of_q_p5_4)
        .mul_add(sin_q_P3, -ratio_q_P2_u_P1_of_q_p5_3);
    let ratio_q_P5_u_P1_of_q_p3_q_p5_2 = sin_q_P3 - ratio_q_P2_u_P1_of_q_p3_q_p5_2;
    let ratio_q_P5_u_P1_of_place_2 = ratio_q_P2_u_P1_of_q_p5
        .mul_add(
            ratio_q_P5_u_P1_of_q_p3_q_p5_2,
            ratio_q_P5_u_P1_of_q_p3_q_p5 * sin_q_P4,
        );
    let ratio_q_P5_u_P1 = ratio_q_P2_u_P1_of_place_102
        .mul_add(
            ratio_q_P5_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_80 * ratio_q_P3_u_P1_of_place_4,
        ) - ratio_q_P3_u_P1_of_place_5 * ratio_q_P5_u_P1_of_place_2;
    let w_rod1_frame_in_rod2_frame_1 = u_P1 * sin_q_P2;
    let w_rod1_frame_in_rod2_frame_2 = u_P1 * cos_q_P2;
    let u_p1_ratio_q_p5_u_p1 = u_P1 * ratio_q_P5_u_P1;
    let ratio_q_P2_u_P1_2_of_u_p1 = u_p1_ratio_q_p5_u_p1 * cos_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_2 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_2_of_u_p1;
    let u_p1_cos_q_p4 = u_P1 * cos_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_3 = ratio_q_P4_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_4 = ratio_q_P2_u_P1_2_of_u_p1_3 * sin_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_5 = (-cos_q_p4_sq)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_2,
            ratio_q_P2_u_P1_of_q_p5_4 * ratio_q_P2_u_P1_2_of_u_p1_4,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_6 = ratio_q_P5_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_7 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_12)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_3,
            cos_q_p4_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_6,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_8 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_9 = ratio_q_P2_u_P1_2_of_u_p1_8 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_10 = ratio_q_P2_u_P1_2_of_u_p1_9 - ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_11 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_5;
    let ratio_q_P2_u_P1_2_of_u_p1_12 = sin_q_P4
        * (ratio_q_P2_u_P1_2_of_u_p1_11 - ratio_q_P2_u_P1_2_of_u_p1_10)
        + ratio_q_P2_u_P1_of_q_p4_q_p5_8 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_13 = ratio_q_P2_u_P1_2_of_u_p1_7 + ratio_q_P2_u_P1_2_of_u_p1_10;
    let ratio_q_P2_u_P1_2_of_u_p1_14 = ratio_q_P2_u_P1_2_of_u_p1_12 - ratio_q_P2_u_P1_2_of_u_p1_13;
    let ratio_q_P2_u_P1_2_of_u_p1_15 = u_p1_ratio_q_p5_u_p1 * sin_q_P5;
    let u_p1_ratio_q_p3_u_p1 = u_P1 * ratio_q_P3_u_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_16 = u_p1_ratio_q_p3_u_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_17 = ratio_q_P2_u_P1_2_of_u_p1_16 * cos_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_18 = ratio_q_P2_u_P1_2_of_u_p1_15
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_17);
    let ratio_q_P2_u_P1_2_of_u_p1_19 = u_p1_ratio_q_p3_u_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_20 = ratio_q_P2_u_P1_of_q_p5
        * ratio_q_P2_u_P1_2_of_u_p1_4.mul_add(S::int(4), ratio_q_P2_u_P1_2_of_u_p1_3)
        - ratio_q_P2_u_P1_of_q_p4_3 * ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_21 = cos_q_P3
        * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_11)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_18,
                ratio_q_P2_u_P1_2_of_u_p1_14 * cos_q_P3,
            ) + ratio_q_P2_u_P1_of_q_p4_q_p5_10 * ratio_q_P2_u_P1_2_of_u_p1_19
            + sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_20)
        + ratio_q_P2_u_P1_of_place_83 * ratio_q_P2_u_P1_2_of_u_p1_19;
    let u_p1_ratio_q_p4_u_p1 = u_P1 * ratio_q_P4_u_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_22 = u_p1_ratio_q_p4_u_p1 * sin_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_23 = ratio_q_P2_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_24 = ratio_q_P2_u_P1_2_of_u_p1_23
        .mul_add(cos_q_P2, ratio_q_P2_u_P1_2_of_u_p1_22 * sin_q_P2);
    let w_rod2_frame_3 = u_P1 * ratio_q_P2_u_P1;
    let sin_q_p2_w_rod2_frame_3 = w_rod2_frame_3 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_25 = ratio_q_P2_u_P1_of_q_p5_2
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_3, ratio_q_P2_u_P1_2_of_u_p1 * sin_q_P4);
    let ratio_q_P2_u_P1_2_of_u_p1_26 = ratio_q_P2_u_P1_2_of_u_p1_11 + ratio_q_P2_u_P1_2_of_u_p1_25;
    let ratio_q_P2_u_P1_2_of_u_p1_27 = ratio_q_P2_u_P1_2_of_u_p1
        .mul_add(S::int(3), -ratio_q_P2_u_P1_2_of_u_p1_9)
        + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_26;
    let ratio_q_P2_u_P1_2_of_u_p1_28 = (-ratio_q_P2_u_P1_2_of_u_p1_15)
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_19 * cos_q_P5);
    let ratio_q_P2_u_P1_2_of_u_p1_29 = ratio_q_P2_u_P1_2_of_u_p1_25
        .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_30 = (-ratio_q_P2_u_P1_2_of_u_p1_23)
        .mul_add(sin_q_P2, cos_q_p2_sin_q_p4 * u_p1_ratio_q_p4_u_p1);
    let cos_q_p2_w_rod2_frame_3 = w_rod2_frame_3 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_31 = sin_q_P2
        * ((-ratio_q_P2_u_P1_2_of_u_p1_14)
            .mul_add(
                sin_q_P3,
                ratio_q_P2_u_P1_of_q_p4_q_p5_10 * ratio_q_P2_u_P1_2_of_u_p1_16,
            ) + cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_20
            + ratio_q_P2_u_P1_of_q_p4_q_p5_11 * ratio_q_P2_u_P1_2_of_u_p1_28)
        + ratio_q_P2_u_P1_of_place_89 * cos_q_p2_w_rod2_frame_3;
    let x_rod2_frame_in_rod3_frame_2_4 = cos_q_P2 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_32 = ratio_q_P3_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_33 = x_rod2_frame_in_rod3_frame_2_4
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_32, ratio_q_P2_u_P1_2_of_u_p1_30 * sin_q_P3);
    let u_p1_cos_q_p1 = u_P1 * cos_q_P1;
    let u_p1_sin_q_p1 = u_P1 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_34 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_8;
    let ratio_q_P2_u_P1_2_of_u_p1_35 = ratio_q_P2_u_P1_2_of_u_p1_6 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_36 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_24, ratio_q_P2_u_P1_2_of_u_p1_35 * cos_q_P5);
    let ratio_q_P2_u_P1_2_of_u_p1_37 = ratio_q_P2_u_P1_2_of_u_p1_25
        .mul_add(cos_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5 * sin_q_p2_w_rod2_frame_3);
    let ratio_q_P2_u_P1_2_of_u_p1_38 = -ratio_q_P2_u_P1_of_place_97
        * ratio_q_P2_u_P1_2_of_u_p1_22
            .mul_add(cos_q_P5, ratio_q_P2_u_P1_2_of_u_p1_6 * sin_q_P5)
        + ratio_q_P2_u_P1_of_place_96 * ratio_q_P2_u_P1_2_of_u_p1_19
        + ratio_q_P2_u_P1_of_place_95 * u_p1_sin_q_p1
        + cos_q_P1
            * (sin_q_P1
                * (ratio_q_P2_u_P1_2_of_u_p1_14 - S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_21
                    - ratio_q_P2_u_P1_of_place_87 * sin_q_p2_w_rod2_frame_3
                    + cos_q_P2
                        * (-cos_q_P2
                            * (ratio_q_P2_u_P1_2_of_u_p1
                                + ratio_q_P2_u_P1_of_q_p4_q_p5_6 * ratio_q_P2_u_P1_2_of_u_p1_3
                                + sin_q_P4
                                    * ratio_q_P2_u_P1_2_of_u_p1_5
                                        .mul_add(S::int(4), ratio_q_P2_u_P1_2_of_u_p1)
                                - S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_7
                                - ratio_q_P2_u_P1_2_of_u_p1_21)
                            + ratio_q_P2_u_P1_of_place_86 * ratio_q_P2_u_P1_2_of_u_p1_24
                            - ratio_q_P2_u_P1_of_place_85 * sin_q_p2_w_rod2_frame_3
                            - sin_q_p2_cos_q_p4
                                * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_13)
                                    .mul_add(
                                        ratio_q_P2_u_P1_2_of_u_p1_16,
                                        ratio_q_P2_u_P1_2_of_u_p1_27 * sin_q_P3,
                                    )
                                    + ratio_q_P2_u_P1_of_q_p4_q_p5_14 * ratio_q_P2_u_P1_2_of_u_p1_28
                                    + cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_29)))
                + cos_q_P1
                    * (ratio_q_P2_u_P1_of_place_93 * ratio_q_P2_u_P1_2_of_u_p1_15
                        - ratio_q_P2_u_P1_of_place_91 * ratio_q_P2_u_P1_2_of_u_p1_19
                        + cos_q_P3
                            * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_13)
                                .mul_add(
                                    ratio_q_P2_u_P1_2_of_u_p1_30,
                                    cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_27,
                                ) + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_31)
                        + cos_q_P5
                            * ((-ratio_q_P2_u_P1_2_of_u_p1_20)
                                .mul_add(
                                    sin_q_P2,
                                    ratio_q_P2_u_P1_of_q_p4_q_p5_11 * cos_q_p2_w_rod2_frame_3,
                                ) - ratio_q_P2_u_P1_of_place_92 * ratio_q_P2_u_P1_2_of_u_p1_29
                                + ratio_q_P2_u_P1_of_q_p4_q_p5_14 * ratio_q_P2_u_P1_2_of_u_p1_33))
                - ratio_q_P2_u_P1_of_place_88 * u_p1_cos_q_p1
                - ratio_q_P2_u_P1_of_place_94 * u_p1_sin_q_p1)
        + cos_q_P3
            * (-ratio_q_P2_u_P1_2_of_u_p1_31
                + ratio_q_P2_u_P1_of_q_p4_q_p5_15 * ratio_q_P2_u_P1_2_of_u_p1_30
                - cos_q_p2_cos_q_p4 * (ratio_q_P2_u_P1_2_of_u_p1_26 + ratio_q_P2_u_P1_2_of_u_p1_34))
        + cos_q_p4_cos_q_p5
            * ((-ratio_q_P2_u_P1_of_place_21)
                .mul_add(ratio_q_P2_u_P1_2_of_u_p1_16, ratio_q_P2_u_P1_2_of_u_p1_36)
                + ratio_q_P2_u_P1_2_of_u_p1_37 * sin_q_P3);
    let ratio_q_P2_u_P1_2_of_u_p1_39 = ratio_q_P2_u_P1_2_of_u_p1_3 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_40 = sin_q_p2_w_rod2_frame_3
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_2_of_u_p1_39);
    let ratio_q_P2_u_P1_2_of_u_p1_41 = ratio_q_P2_u_P1_2_of_u_p1_32 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_42 = ratio_q_P2_u_P1_2_of_u_p1_41
        .mul_add(cos_q_P3, -ratio_q_P2_u_P1_2_of_u_p1_40);
    let sin_q_p4_u_p1_cos_q_p1 = u_p1_cos_q_p1 * sin_q_P4;
    let cos_q_p3_ratio_q_p4_u_p1 = ratio_q_P4_u_P1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_43 = (-sin_q_p4_u_p1_cos_q_p1)
        .mul_add(
            cos_q_p3_ratio_q_p4_u_p1,
            sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_32,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_44 = cos_q_p3_sin_q_p1
        .mul_add(u_p1_cos_q_p4, ratio_q_P2_u_P1_2_of_u_p1_43);
    let ratio_q_P2_u_P1_2_of_u_p1_45 = cos_q_P5
        * (sin_q_P1
            * ratio_q_P2_u_P1_2_of_u_p1_24
                .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_42)
            + ratio_q_P2_u_P1_of_place * u_p1_cos_q_p1 + ratio_q_P2_u_P1_2_of_u_p1_44)
        - ratio_q_P2_u_P1_of_place_3 * ratio_q_P2_u_P1_2_of_u_p1_15;
    let ratio_q_P2_u_P1_2_of_u_p1_46 = ratio_q_P2_u_P1_2_of_u_p1_6 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_47 = (-ratio_q_P2_u_P1_2_of_u_p1_25)
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_p2_w_rod2_frame_3)
        - ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_33
        + sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_46;
    let ratio_q_P2_u_P1_2_of_u_p1_48 = ratio_q_P2_u_P1_2_of_u_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_49 = sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_50 = (-ratio_q_P2_u_P1_2_of_u_p1_19)
        .mul_add(sin_q_P5, ratio_q_P2_u_P1_2_of_u_p1_18 * sin_q_P4)
        - ratio_q_P2_u_P1_2_of_u_p1_48 - ratio_q_P2_u_P1_2_of_u_p1_49;
    let ratio_q_P2_u_P1_2_of_u_p1_51 = (-ratio_q_P2_u_P1_of_place_4)
        .mul_add(sin_q_p2_w_rod2_frame_3, ratio_q_P2_u_P1_2_of_u_p1_24 * cos_q_P5)
        + ratio_q_P2_u_P1_2_of_u_p1_35 * sin_q_P5 + ratio_q_P2_u_P1_2_of_u_p1_50 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_52 = u_p1_cos_q_p1
        .mul_add(sin_q_P2, w_rod2_frame_3 * x_rod1_frame_in_rod2_frame_1_3);
    let ratio_q_P2_u_P1_2_of_u_p1_53 = ratio_q_P2_u_P1_2_of_u_p1_16 * cos_q_P1;
    let sin_q_p3_u_p1_sin_q_p1 = u_p1_sin_q_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_54 = -ratio_q_P2_u_P1_2_of_u_p1_30
        + sin_q_p2_sin_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_16
        + sin_q_P3
            * (-ratio_q_P2_u_P1_2_of_u_p1_3)
                .mul_add(sin_q_P2, cos_q_p2_w_rod2_frame_3 * sin_q_P4);
    let ratio_q_P2_u_P1_2_of_u_p1_55 = u_p1_sin_q_p1
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_19 * cos_q_P1);
    let ratio_q_P2_u_P1_2_of_u_p1_56 = x_rod2_frame_in_rod3_frame_2_5 * ratio_q_P2_u_P1_2_of_u_p1_15
        - ratio_q_P2_u_P1_of_place_9 * ratio_q_P2_u_P1_2_of_u_p1
        + cos_q_P5
            * ((-x_rod1_frame_in_rod2_frame_2_3)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_19,
                    ratio_q_P2_u_P1_2_of_u_p1_52 * cos_q_P3,
                ) + ratio_q_P2_u_P1_2_of_u_p1_53 - sin_q_p3_u_p1_sin_q_p1)
        - sin_q_P5
            * (ratio_q_P2_u_P1_of_place_8
                .mul_add(u_p1_cos_q_p1, cos_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_3)
                + ratio_q_P2_u_P1_2_of_u_p1_54 * sin_q_P1
                + ratio_q_P2_u_P1_2_of_u_p1_55 * sin_q_P4);
    let ratio_q_P2_u_P1_2_of_u_p1_57 = ratio_q_P2_u_P1_of_place_11
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_47,
            ratio_q_P2_u_P1_of_place_6 * ratio_q_P2_u_P1_2_of_u_p1_45,
        ) - ratio_q_P2_u_P1_of_place_24 * ratio_q_P2_u_P1_2_of_u_p1_51
        - ratio_q_P2_u_P1_of_place_25 * ratio_q_P2_u_P1_2_of_u_p1_56;
    let ratio_q_P2_u_P1_2_of_u_p1_58 = ratio_q_P2_u_P1_2_of_u_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_59 = ratio_q_P2_u_P1_2_of_u_p1_16 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_60 = cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_61 = ratio_q_P2_u_P1_2_of_u_p1_28
        .mul_add(sin_q_P4, -ratio_q_P2_u_P1_2_of_u_p1_58) + ratio_q_P2_u_P1_2_of_u_p1_59
        + ratio_q_P2_u_P1_2_of_u_p1_60;
    let ratio_q_P2_u_P1_2_of_u_p1_62 = (-ratio_q_P2_u_P1_2_of_u_p1_50)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_4 * u_p1_sin_q_p1)
        - ratio_q_P2_u_P1_of_place_17 * ratio_q_P2_u_P1_2_of_u_p1_52
        + x_rod1_frame_in_rod2_frame_2_3 * ratio_q_P2_u_P1_2_of_u_p1_61;
    let ratio_q_P2_u_P1_2_of_u_p1_63 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_19, ratio_q_P2_u_P1_2_of_u_p1_18)
        - ratio_q_P2_u_P1_2_of_u_p1_25 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_64 = ratio_q_P2_u_P1_2_of_u_p1_63 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_place = ratio_q_P2_u_P1_of_place_15 * sin_q_p2_w_rod2_frame_3;
    let ratio_q_P2_u_P1_2_of_u_p1_65 = ratio_q_P2_u_P1_2_of_place - ratio_q_P2_u_P1_2_of_u_p1_64;
    let ratio_q_P2_u_P1_2_of_place_2 = l * ratio_q_P2_u_P1_of_place_18;
    let ratio_q_P2_u_P1_2_of_u_p1_66 = (-ratio_q_P2_u_P1_of_place_65)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_56,
            ratio_q_P2_u_P1_of_place_11 * ratio_q_P2_u_P1_2_of_u_p1_65,
        ) - ratio_q_P2_u_P1_of_place_6 * ratio_q_P2_u_P1_2_of_u_p1_62
        + ratio_q_P2_u_P1_2_of_u_p1_51 * ratio_q_P2_u_P1_2_of_place_2;
    let ratio_q_P2_u_P1_2_of_u_p1_67 = ratio_q_P2_u_P1_of_place_25
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_62,
            ratio_q_P2_u_P1_of_place_65 * ratio_q_P2_u_P1_2_of_u_p1_45,
        ) + ratio_q_P2_u_P1_of_place_24 * ratio_q_P2_u_P1_2_of_u_p1_65
        + ratio_q_P2_u_P1_2_of_u_p1_47 * ratio_q_P2_u_P1_2_of_place_2;
    let ratio_q_P2_u_P1_2_of_u_p1_68 = (-ratio_q_P2_u_P1_2_of_u_p1_25)
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_q_p4_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_16)
        + ratio_q_P2_u_P1_2_of_u_p1_28;
    let ratio_q_P2_u_P1_2_of_u_p1_69 = (-ratio_q_P2_u_P1_2_of_u_p1_63)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_15 * u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_70 = ratio_q_P2_u_P1 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_71 = l
        * ((-ratio_q_P2_u_P1_of_place_14)
            .mul_add(u_p1_cos_q_p1, ratio_q_P2_u_P1_2_of_u_p1_68 * sin_q_P1)
            + ratio_q_P2_u_P1_2_of_u_p1_69 * sin_q_P2
            - ratio_q_P2_u_P1_of_place_19 * ratio_q_P2_u_P1_2_of_u_p1_70);
    let ratio_q_P2_u_P1_2_of_u_p1_72 = (-sin_q_p3_cos_q_p5)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_35,
            ratio_q_P2_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_24,
        ) - ratio_q_P2_u_P1_2_of_u_p1_37
        + ratio_q_P2_u_P1_of_q_p3_q_p5_3 * ratio_q_P2_u_P1_2_of_u_p1_41;
    let ratio_q_P2_u_P1_2_of_u_p1_73 = cos_q_p3_cos_q_p1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_74 = cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_6;
    let ratio_q_P2_u_P1_2_of_u_p1_75 = l
        * (sin_q_P1
            * ratio_q_P2_u_P1_of_q_p3_q_p5
                .mul_add(ratio_q_P2_u_P1_2_of_u_p1_32, ratio_q_P2_u_P1_2_of_u_p1_74)
            - u_p1_sin_q_p1
                * ratio_q_P2_u_P1_of_q_p4_q_p5
                    .mul_add(cos_q_p3_ratio_q_p4_u_p1, -ratio_q_P2_u_P1_of_place_22)
            - ratio_q_P2_u_P1_2_of_u_p1_72 * cos_q_P1
            - ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_73);
    let ratio_q_P2_u_P1_2_of_u_p1_76 = (-ratio_q_P2_u_P1_2_of_u_p1_30)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_4 * cos_q_p2_w_rod2_frame_3)
        - ratio_q_P2_u_P1_2_of_u_p1_46 * sin_q_P5 + ratio_q_P2_u_P1_2_of_u_p1_50 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_77 = l
        * ((-ratio_q_P2_u_P1_2_of_u_p1_61)
            .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_17 * u_p1_cos_q_p1)
            + ratio_q_P2_u_P1_of_place_27 * u_p1_sin_q_p1
            + ratio_q_P2_u_P1_2_of_u_p1_76 * cos_q_P1);
    let ratio_q_P2_u_P1_2_of_u_p1_78 = ratio_q_P2_u_P1_of_place_31
        .mul_add(
            cos_q_p2_w_rod2_frame_3,
            ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_30,
        ) - ratio_q_P2_u_P1_2_of_u_p1_46 * cos_q_P5 - ratio_q_P2_u_P1_2_of_u_p1_68 * sin_q_P2;
    let cos_q_p2_u_p1_cos_q_p1 = u_p1_cos_q_p1 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_79 = sin_q_p2_w_rod2_frame_3
        .mul_add(sin_q_P1, -cos_q_p2_u_p1_cos_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_80 = (-ratio_q_P2_u_P1_of_place_27)
        .mul_add(u_p1_cos_q_p1, ratio_q_P2_u_P1_of_place_17 * u_p1_sin_q_p1)
        + ratio_q_P2_u_P1_2_of_u_p1_61 * cos_q_P1 + ratio_q_P2_u_P1_2_of_u_p1_76 * sin_q_P1;
    let x_rod1_frame_in_N_3 = l * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_81 = ratio_q_P2_u_P1_of_place_6 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_82 = x_rod1_frame_in_N_3
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_51, ratio_q_P2_u_P1_2_of_u_p1_81);
    let ratio_q_P2_u_P1_2_of_u_p1_83 = ratio_q_P2_u_P1_of_place_31
        .mul_add(sin_q_p2_w_rod2_frame_3, -ratio_q_P2_u_P1_2_of_u_p1_36)
        + ratio_q_P2_u_P1_2_of_u_p1_68 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_84 = ratio_q_P2_u_P1_of_place_81
        * ratio_q_P2_u_P1_2_of_u_p1_56 * sin_q_P1
        + ratio_q_P2_u_P1_of_place_41 * ratio_q_P2_u_P1_2_of_u_p1_80
        - ratio_q_P2_u_P1_of_place_36 * ratio_q_P2_u_P1_2_of_u_p1_82
        + ratio_q_P2_u_P1_of_place_11
            * (-ratio_q_P2_u_P1_2_of_u_p1_83)
                .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_40 * u_p1_cos_q_p1);
    let ratio_q_P2_u_P1_2_of_place_3 = l * ratio_q_P2_u_P1_of_place_42;
    let ratio_q_P2_u_P1_2_of_place_4 = ratio_q_P2_u_P1_of_place_5 * l_sq;
    let ratio_q_P2_u_P1_2_of_u_p1_85 = ratio_q_P2_u_P1_of_q_p5_2
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_19, ratio_q_P2_u_P1_2_of_u_p1_48);
    let ratio_q_P2_u_P1_2_of_u_p1_86 = ratio_q_P2_u_P1_of_q_p3
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_15, ratio_q_P2_u_P1_2_of_u_p1_17)
        + ratio_q_P2_u_P1_2_of_u_p1_85;
    let ratio_q_P2_u_P1_2_of_u_p1_87 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_16, ratio_q_P2_u_P1_2_of_u_p1_58);
    let ratio_q_P2_u_P1_2_of_u_p1_88 = ratio_q_P2_u_P1_of_q_p4_q_p5
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_79,
            x_rod1_frame_in_rod2_frame_1_3 * ratio_q_P2_u_P1_2_of_u_p1_25,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_89 = x_rod1_frame_in_rod2_frame_1_3
        * (ratio_q_P2_u_P1_of_place_47
            * u_p1_cos_q_p1.mul_add(cos_q_P5, ratio_q_P2_u_P1_2_of_u_p1_15 * sin_q_P1)
            - ratio_q_P2_u_P1_of_place_45 * ratio_q_P2_u_P1_2_of_u_p1_19
            - cos_q_p5_sin_q_p1
                * (ratio_q_P2_u_P1_2_of_u_p1_40
                    + ratio_q_P2_u_P1_of_place_46 * ratio_q_P2_u_P1_2_of_u_p1_16
                    + sin_q_P3
                        * ratio_q_P2_u_P1_of_q_p3
                            .mul_add(
                                ratio_q_P2_u_P1_2_of_u_p1_24, ratio_q_P2_u_P1_2_of_u_p1_42,
                            ))
            - cos_q_P3
                * (cos_q_P4
                    * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
                        .mul_add(
                            u_p1_sin_q_p1,
                            x_rod1_frame_in_rod2_frame_2_3 * ratio_q_P2_u_P1_2_of_u_p1_87,
                        ) - ratio_q_P2_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_52
                        - ratio_q_P2_u_P1_2_of_u_p1_86 * cos_q_P1)
                    - ratio_q_P2_u_P1_of_place_43 * ratio_q_P2_u_P1_2_of_u_p1_22
                    + ratio_q_P2_u_P1_2_of_u_p1_88));
    let ratio_q_P2_u_P1_2_of_u_p1_90 = ratio_q_P2_u_P1_of_place_49 * ratio_q_P2_u_P1_2_of_u_p1_51
        + l * ratio_q_P2_u_P1_of_place_37 * ratio_q_P2_u_P1_2_of_u_p1_78
        - ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_48 * ratio_q_P2_u_P1_2_of_u_p1_79
        + ratio_q_P2_u_P1_of_place_38
            * (l
                * ratio_q_P2_u_P1_of_place_35
                    .mul_add(
                        ratio_q_P2_u_P1_2_of_u_p1_56,
                        ratio_q_P2_u_P1_of_place_36 * ratio_q_P2_u_P1_2_of_u_p1_45,
                    )
                + ratio_q_P2_u_P1_of_place_11
                    * (ratio_q_P2_u_P1_of_q_p5_2
                        .mul_add(
                            ratio_q_P2_u_P1_2_of_u_p1_44,
                            ratio_q_P2_u_P1_of_place_22 * u_p1_cos_q_p1,
                        ) + ratio_q_P2_u_P1_2_of_u_p1_72 * sin_q_P1
                        + ratio_q_P2_u_P1_2_of_u_p1_74 * cos_q_P1)
                + ratio_q_P2_u_P1_of_place_24 * ratio_q_P2_u_P1_2_of_u_p1_80)
        + ratio_q_P2_u_P1_of_place_25 * ratio_q_P2_u_P1_2_of_u_p1_84
        - ratio_q_P2_u_P1_2_of_u_p1_47 * ratio_q_P2_u_P1_2_of_place_3
        + ratio_q_P2_u_P1_2_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_89;
    let ratio_q_P2_u_P1_2_of_u_p1_91 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_4;
    let ratio_q_P2_u_P1_2_of_u_p1_92 = ratio_q_P2_u_P1_2_of_u_p1_91
        - ratio_q_P2_u_P1_of_q_p4_2 * ratio_q_P2_u_P1_2_of_u_p1
        - sin_q_P5 * (ratio_q_P2_u_P1_2_of_u_p1_3 + ratio_q_P2_u_P1_2_of_u_p1_91);
    let ratio_q_P2_u_P1_2_of_u_p1_93 = ratio_q_P2_u_P1_2_of_u_p1_92 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_94 = ratio_q_P2_u_P1_of_q_p4_q_p5_3
        * ratio_q_P2_u_P1_2_of_u_p1_16;
    let ratio_q_P2_u_P1_2_of_u_p1_95 = ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P2_u_P1_2_of_u_p1_25;
    let ratio_q_P2_u_P1_2_of_u_p1_96 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_95;
    let ratio_q_P2_u_P1_2_of_u_p1_97 = ratio_q_P2_u_P1_of_q_p4
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_18, -ratio_q_P2_u_P1_2_of_u_p1_49);
    let ratio_q_P2_u_P1_2_of_u_p1_98 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_3)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_19, ratio_q_P2_u_P1_2_of_u_p1_92 * cos_q_P3);
    let ratio_q_P2_u_P1_2_of_u_p1_99 = ratio_q_P2_u_P1_2_of_u_p1_28 + ratio_q_P2_u_P1_2_of_u_p1_87;
    let ratio_q_P2_u_P1_2_of_u_p1_100 = cos_q_P1
        * (ratio_q_P2_u_P1_2_of_u_p1_18 + ratio_q_P2_u_P1_2_of_u_p1_85);
    let ratio_q_P2_u_P1_2_of_place_5 = ratio_q_P2_u_P1_of_q_p3_q_p5_7 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_101 = ratio_q_P2_u_P1_2_of_u_p1_70
        .mul_add(sin_q_P2, u_P1 * x_rod1_frame_in_rod2_frame_1_3);
    let ratio_q_P2_u_P1_2_of_u_p1_102 = sin_q_P1
        * (ratio_q_P2_u_P1_of_place_69 * cos_q_p2_w_rod2_frame_3
            - x_rod1_frame_in_rod2_frame_1_2 * ratio_q_P2_u_P1_2_of_u_p1_50
            + sin_q_P2
                * (ratio_q_P2_u_P1_of_place_67 * u_p1_cos_q_p1
                    - ratio_q_P4_u_P1 * ratio_q_P2_u_P1_of_q_p3_q_p5_7 * sin_q_p4_u_p1_cos_q_p1
                    + sin_q_P1
                        * (cos_q_P2
                            * (ratio_q_P2_u_P1_of_q_p3_q_p5_5 * ratio_q_P2_u_P1_2_of_u_p1_3
                                - ratio_q_P2_u_P1_of_q_p3 * ratio_q_P2_u_P1_2_of_u_p1
                                + sin_q_P4
                                    * (ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P2_u_P1_2_of_u_p1_28)
                                + ratio_q_P2_u_P1_2_of_u_p1_59)
                            - ratio_q_P2_u_P1_of_q_p3_q_p5_6 * ratio_q_P2_u_P1_2_of_u_p1_24
                            - ratio_q_P2_u_P1_of_place_66 * sin_q_p2_w_rod2_frame_3
                            + sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_99)
                    - ratio_q_P2_u_P1_2_of_u_p1_100 * cos_q_P4
                    + u_p1_cos_q_p4 * ratio_q_P2_u_P1_2_of_place_5)
            + ratio_q_P2_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_101)
        + ratio_q_P2_u_P1_of_place_70 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_103 = l_sq * ratio_q_P2_u_P1_2_of_u_p1_78;
    let ratio_q_P2_u_P1_2_of_u_p1_104 = ratio_q_P2_u_P1_of_place_71 * ratio_q_P2_u_P1_2_of_u_p1_51
        - ratio_q_P2_u_P1_of_place_65 * ratio_q_P2_u_P1_2_of_u_p1_84
        + ratio_q_P2_u_P1_2_of_u_p1_65 * ratio_q_P2_u_P1_2_of_place_3
        + ratio_q_P2_u_P1_of_place_64
            * (-u_p1_cos_q_p1
                * (ratio_q_P2_u_P1_of_place_61 * sin_q_p3_sin_q_p1)
                    .mul_add(S::int(2), ratio_q_P2_u_P1_of_place_60)
                + ratio_q_P2_u_P1_of_place_62 * ratio_q_P2_u_P1_2_of_u_p1_53
                - sin_q_P1
                    * (ratio_q_P2_u_P1_of_q_p4_q_p5_4
                        * (-ratio_q_P2_u_P1_2_of_u_p1_33)
                            .mul_add(
                                cos_q_P1,
                                x_rod1_frame_in_rod2_frame_1_3 * u_p1_cos_q_p4 * sin_q_P3,
                            ) + ratio_q_P2_u_P1_of_place_59 * cos_q_p2_w_rod2_frame_3
                        + sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_96
                        + sin_q_P2
                            * (sin_q_p3_cos_q_p1
                                * ratio_q_P2_u_P1_2_of_u_p1_94
                                    .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_93)
                                - ratio_q_P2_u_P1_of_place_58 * ratio_q_P2_u_P1_2_of_u_p1_19
                                - ratio_q_P2_u_P1_of_place_51 * sin_q_p3_u_p1_sin_q_p1
                                + cos_q_P3
                                    * (ratio_q_P2_u_P1_of_place_54 * u_p1_cos_q_p1
                                        + ratio_q_P2_u_P1_of_place_57 * u_p1_sin_q_p1
                                        + sin_q_P1
                                            * (ratio_q_P2_u_P1_of_place_52 * cos_q_p2_w_rod2_frame_3
                                                - ratio_q_P2_u_P1_of_q_p4_q_p5_4
                                                    * ratio_q_P2_u_P1_2_of_u_p1_30
                                                + sin_q_P2
                                                    * (ratio_q_P2_u_P1_of_q_p4
                                                        .mul_add(
                                                            ratio_q_P2_u_P1_2_of_u_p1_28,
                                                            ratio_q_P2_u_P1_2_of_u_p1_60,
                                                        ) + ratio_q_P2_u_P1_2_of_u_p1_93
                                                        + ratio_q_P2_u_P1_2_of_u_p1_94)
                                                + ratio_q_P2_u_P1_2_of_u_p1_96)
                                        - cos_q_P1
                                            * ratio_q_P2_u_P1_2_of_u_p1_97
                                                .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_98))))
                + sin_q_p3_cos_q_p1 * cos_q_P1
                    * (ratio_q_P2_u_P1_2_of_u_p1_97 + ratio_q_P2_u_P1_2_of_u_p1_98))
        + ratio_q_P2_u_P1_2_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_102
        - ratio_q_P2_u_P1_of_place_63 * ratio_q_P2_u_P1_2_of_u_p1_103;
    let ratio_q_P2_u_P1_2_of_u_p1_105 = ratio_q_P2_u_P1_of_place_49
        * (-ratio_q_P2_u_P1_2_of_place).mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_64)
        - ratio_q_P2_u_P1_of_place_71 * ratio_q_P2_u_P1_2_of_u_p1_47
        + ratio_q_P2_u_P1_of_place_19 * ratio_q_P2_u_P1_of_place_48 * cos_q_p2_u_p1_cos_q_p1
        + ratio_q_P2_u_P1_of_place_64
            * (ratio_q_P2_u_P1_of_place_78 * u_p1_cos_q_p1
                - ratio_q_P2_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_100
                + ratio_q_P2_u_P1_of_place_68 * ratio_q_P2_u_P1_2_of_u_p1_43
                + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_73 * ratio_q_P2_u_P1_2_of_place_5
                - sin_q_P1
                    * (ratio_q_P2_u_P1_of_place_68 * ratio_q_P2_u_P1_2_of_u_p1_39
                        - ratio_q_P2_u_P1_of_place_77 * cos_q_p2_w_rod2_frame_3
                        + sin_q_P2
                            * (cos_q_p3_cos_q_p5
                                * (x_rod1_frame_in_rod2_frame_1_3
                                    .mul_add(
                                        ratio_q_P2_u_P1_2_of_u_p1_3, -ratio_q_P2_u_P1_2_of_u_p1_44,
                                    ) + ratio_q_P2_u_P1_2_of_u_p1_79 * sin_q_P4)
                                - ratio_q_P2_u_P1_of_place_74 * ratio_q_P2_u_P1_2_of_u_p1_16
                                - ratio_q_P2_u_P1_of_place_76 * ratio_q_P2_u_P1_2_of_u_p1_28
                                + sin_q_P3
                                    * (ratio_q_P2_u_P1_2_of_u_p1_88
                                        - ratio_q_P2_u_P1_of_place_73 * ratio_q_P2_u_P1_2_of_u_p1_22
                                        + cos_q_P4
                                            * (ratio_q_P2_u_P1_of_q_p3_q_p5_8 * u_p1_sin_q_p1
                                                - ratio_q_P2_u_P1_of_q_p3_q_p5_6
                                                    * ratio_q_P2_u_P1_2_of_u_p1_52
                                                - cos_q_P1
                                                    * ratio_q_P2_u_P1_2_of_u_p1_85
                                                        .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_18)
                                                + x_rod1_frame_in_rod2_frame_2_3
                                                    * ratio_q_P2_u_P1_2_of_u_p1_99)))
                        - cos_q_p2_sin_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_100
                        + ratio_q_P2_u_P1_of_q_p3_q_p5_7 * ratio_q_P2_u_P1_2_of_u_p1_101
                            * sin_q_P4))
        + l_sq
            * ratio_q_P2_u_P1_of_place_7
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_102,
                    ratio_q_P2_u_P1_of_place_19 * ratio_q_P2_u_P1_2_of_u_p1_89,
                ) + ratio_q_P2_u_P1_of_place_79 * ratio_q_P2_u_P1_2_of_u_p1_103;
    let ratio_q_P2_u_P1_2_of_u_p1_106 = l
        * ratio_q_P2_u_P1_2_of_u_p1_83
            .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_40 * u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_107 = ratio_q_P2_u_P1_of_place_100
        * ((-ratio_q_P2_u_P1_of_place_50)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_71,
                l_sq * ratio_q_P2_u_P1_of_place_82 * ratio_q_P2_u_P1_2_of_u_p1_38,
            ) + ratio_q_P2_u_P1_of_place_72 * ratio_q_P2_u_P1_2_of_u_p1_75
            - ratio_q_P2_u_P1_of_place_80 * ratio_q_P2_u_P1_2_of_u_p1_77
            + ratio_q_P2_u_P1_of_place_16 * ratio_q_P2_u_P1_2_of_u_p1_90
            + ratio_q_P2_u_P1_of_place_23 * ratio_q_P2_u_P1_2_of_u_p1_104
            - ratio_q_P2_u_P1_of_place_29 * ratio_q_P2_u_P1_2_of_u_p1_105
            + ratio_q_P2_u_P1_of_place_99 * ratio_q_P2_u_P1_2_of_u_p1_106);
    let ratio_q_P2_u_P1_2_of_u_p1_108 = ratio_q_P2_u_P1_of_place_103 * ratio_q_P2_u_P1_2_of_u_p1
        + ratio_q_P2_u_P1_of_place_104 * ratio_q_P2_u_P1_2_of_u_p1_15
        + cos_q_P5
            * ((-cos_q_p3_sin_q_p1)
                .mul_add(ratio_q_P2_u_P1_2_of_u_p1_3, sin_q_p4_u_p1_cos_q_p1 * cos_q_P3)
                - ratio_q_P2_u_P1_2_of_u_p1_19 * sin_q_P1 * sin_q_P4
                - ratio_q_P2_u_P1_of_place_8 * u_p1_sin_q_p1
                + ratio_q_P2_u_P1_2_of_u_p1_54 * cos_q_P1)
        + sin_q_P5
            * ((-ratio_q_P2_u_P1_2_of_u_p1_16)
                .mul_add(
                    sin_q_P1,
                    x_rod2_frame_in_rod3_frame_2_4 * ratio_q_P2_u_P1_2_of_u_p1_70,
                ) - u_p1_cos_q_p1 * sin_q_P3 - ratio_q_P2_u_P1_2_of_u_p1_55 * sin_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_109 = ratio_q_P2_u_P1_of_place_106
        * ratio_q_P2_u_P1_of_place_105
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_107, -ratio_q_P2_u_P1_2_of_u_p1_108);
    let ratio_q_P2_u_P1_2_of_u_p1_110 = ratio_q_P2_u_P1_2_of_u_p1_109
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_107 * ratio_q_P2_u_P1_2_of_u_p1_15);
    let ratio_q_P2_u_P1_2_of_u_p1_111 = ratio_q_P2_u_P1_of_place_33
        .mul_add(u_p1_sin_q_p1, ratio_q_P2_u_P1_of_place_15 * u_p1_cos_q_p1)
        + ratio_q_P2_u_P1_2_of_u_p1_63 * sin_q_P1 - ratio_q_P2_u_P1_2_of_u_p1_78 * cos_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_112 = ratio_q_P2_u_P1_of_place_101
        * ratio_q_P2_u_P1_of_place_34
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_107, -ratio_q_P2_u_P1_2_of_u_p1_111);
    let ratio_q_P2_u_P1_2_of_u_p1_113 = ratio_q_P2_u_P1_of_place_33
        .mul_add(u_p1_cos_q_p1, -ratio_q_P2_u_P1_2_of_u_p1_69)
        + ratio_q_P2_u_P1_2_of_u_p1_78 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_114 = ratio_q_P2_u_P1_of_place_109
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_107, ratio_q_P2_u_P1_2_of_u_p1_113);
    let ratio_q_P2_u_P1_2 = ratio_q_P2_u_P1_of_place_102
        * ((-ratio_q_P2_u_P1_of_place_16)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_57,
                ratio_q_P2_u_P1_of_place_23 * ratio_q_P2_u_P1_2_of_u_p1_66,
            ) + ratio_q_P2_u_P1_of_place_29 * ratio_q_P2_u_P1_2_of_u_p1_67
            - ratio_q_P2_u_P1_of_place_12 * ratio_q_P2_u_P1_2_of_u_p1_71
            + ratio_q_P2_u_P1_of_place_20 * ratio_q_P2_u_P1_2_of_u_p1_75
            - ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_u_p1_77)
        - ratio_q_P2_u_P1_of_place_106 * ratio_q_P2_u_P1_of_place_109 * ratio_q_P2_u_P1_2_of_u_p1_38
        - ratio_q_P2_u_P1_of_place_108 * ratio_q_P2_u_P1_2_of_u_p1_95
        + ratio_q_P2_u_P1_of_q_p4_q_p5_16 * ratio_q_P2_u_P1_2_of_u_p1_110
        + ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_2_of_u_p1_112
        + ratio_q_P2_u_P1_of_place_110 * ratio_q_P2_u_P1_2_of_u_p1_114;
    let w_rod2_frame_12 = w_rod1_frame_in_rod2_frame_1 * w_rod1_frame_in_rod2_frame_2;
    let a_rod1_frame_in_rod2_frame_1 = (-g)
        .mul_add(sin_q_P2, a_rod1_centre_1 * cos_q_P2);
    let alpha_rod2_frame_3 = u_P1 * ratio_q_P2_u_P1_2;
    let turn_rod2_frame_12 = w_rod2_frame_12 - alpha_rod2_frame_3;
    let l_turn_rod2_frame_12 = l * turn_rod2_frame_12;
    let a_rod2_centre_1 = a_rod1_frame_in_rod2_frame_1
        .mul_add(S::int(2), -l_turn_rod2_frame_12);
    let x_rod2_frame_1 = m * a_rod2_centre_1;
    let w_rod2_frame_11 = w_rod1_frame_in_rod2_frame_1 * w_rod1_frame_in_rod2_frame_1;
    let w_rod2_frame_33 = w_rod2_frame_3 * w_rod2_frame_3;
    let turn_rod2_frame_22 = w_rod2_frame_11 + w_rod2_frame_33;
    let a_rod1_frame_in_rod2_frame_2 = a_rod1_centre_1.mul_add(sin_q_P2, g * cos_q_P2);
    let l_turn_rod2_frame_22 = l * turn_rod2_frame_22;
    let a_rod2_centre_2 = (-a_rod1_frame_in_rod2_frame_2)
        .mul_add(S::int(2), l_turn_rod2_frame_22);
    let x_rod2_frame_2 = m * a_rod2_centre_2;
    let w_rod2_frame_23 = w_rod1_frame_in_rod2_frame_2 * w_rod2_frame_3;
    let alpha_rod2_frame_1 = w_rod2_frame_23;
    let turn_rod2_frame_32 = w_rod2_frame_23 + alpha_rod2_frame_1;
    let a_rod2_centre_3 = l * turn_rod2_frame_32;
    let x_rod2_frame_3 = m * a_rod2_centre_3;
    let x_rod1_frame_2_2 = m * l_sq;
    let H_rod2_3 = w_rod2_frame_3 * x_rod1_frame_2_2;
    let x_rod2_frame_1_2 = alpha_rod2_frame_1
        .mul_add(x_rod1_frame_2_2, w_rod1_frame_in_rod2_frame_2 * H_rod2_3);
    let H_rod2_1 = w_rod1_frame_in_rod2_frame_1 * x_rod1_frame_2_2;
    let x_rod2_frame_2_2 = (-w_rod1_frame_in_rod2_frame_1)
        .mul_add(H_rod2_3, w_rod2_frame_3 * H_rod2_1);
    let x_rod2_frame_3_2 = (-alpha_rod2_frame_3)
        .mul_add(x_rod1_frame_2_2, w_rod1_frame_in_rod2_frame_2 * H_rod2_1);
    let w_rod3_frame_1 = w_rod1_frame_in_rod2_frame_1 + u_p1_ratio_q_p3_u_p1;
    let w_rod2_frame_in_rod3_frame_3 = (-w_rod2_frame_3)
        .mul_add(cos_q_P3, w_rod1_frame_in_rod2_frame_2 * sin_q_P3);
    let w_rod3_frame_13 = w_rod3_frame_1 * w_rod2_frame_in_rod3_frame_3;
    let alpha_rod2_frame_2 = w_rod1_frame_in_rod2_frame_1 * w_rod2_frame_3;
    let alpha_rod2_frame_in_rod3_frame_2 = (-alpha_rod2_frame_3)
        .mul_add(sin_q_P3, alpha_rod2_frame_2 * cos_q_P3);
    let alpha_rod3_frame_2 = w_rod2_frame_in_rod3_frame_3
        .mul_add(u_p1_ratio_q_p3_u_p1, alpha_rod2_frame_in_rod3_frame_2);
    let turn_rod3_frame_13 = w_rod3_frame_13 + alpha_rod3_frame_2;
    let a_rod3_centre_1 = a_rod1_frame_in_rod2_frame_1 - l_turn_rod2_frame_12;
    let l_turn_rod3_frame_13 = l * turn_rod3_frame_13;
    let a_rod3_centre_1_2 = a_rod3_centre_1.mul_add(S::int(2), l_turn_rod3_frame_13);
    let x_rod3_frame_1 = m * a_rod3_centre_1_2;
    let w_rod2_frame_in_rod3_frame_2 = w_rod2_frame_3
        .mul_add(sin_q_P3, w_rod1_frame_in_rod2_frame_2 * cos_q_P3);
    let ratio_q_P3_u_P1_2_of_u_p1 = (-ratio_q_P2_u_P1_of_place_38)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_56,
            S::int(2) * ratio_q_P2_u_P1_of_place_41 * ratio_q_P2_u_P1_2_of_u_p1_51,
        ) - ratio_q_P2_u_P1_of_place_11 * ratio_q_P2_u_P1_2_of_u_p1_78
        + ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_81;
    let ratio_q_P3_u_P1_2_of_u_p1_2 = (-ratio_q_P2_u_P1_of_place_38)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_45,
            ratio_q_P2_u_P1_of_place_24 * ratio_q_P2_u_P1_2_of_u_p1_78,
        ) - ratio_q_P2_u_P1_of_place_41 * ratio_q_P2_u_P1_2_of_u_p1_47
        + ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_2_of_u_p1_82;
    let ratio_q_P3_u_P1_2_of_u_p1_3 = ratio_q_P2_u_P1_2_of_u_p1_109
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_107 * ratio_q_P2_u_P1_2_of_u_p1_22);
    let ratio_q_P3_u_P1_2_of_u_p1_4 = ratio_q_P2_u_P1_of_place_101 * ratio_q_P2_u_P1_2_of_u_p1_114;
    let ratio_q_P3_u_P1_2 = ratio_q_P3_u_P1_of_place_5
        * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_15, ratio_q_P2_u_P1_2_of_u_p1)
            + ratio_q_P2_u_P1_2_of_u_p1_86 * cos_q_P5 - ratio_q_P2_u_P1_2_of_u_p1_87)
        + ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_90
        + ratio_q_P3_u_P1_of_place_3 * ratio_q_P2_u_P1_2_of_u_p1_112
        + ratio_q_P2_u_P1_of_place_102
            * ((-ratio_q_P2_u_P1_of_place_82)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_57,
                    ratio_q_P3_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_77,
                ) - ratio_q_P3_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_75
                - ratio_q_P2_u_P1_of_place_12 * ratio_q_P2_u_P1_2_of_u_p1_106
                - ratio_q_P2_u_P1_of_place_23 * ratio_q_P3_u_P1_2_of_u_p1
                + ratio_q_P2_u_P1_of_place_29 * ratio_q_P3_u_P1_2_of_u_p1_2)
        - ratio_q_P3_u_P1_of_q_p3_q_p5 * ratio_q_P3_u_P1_2_of_u_p1_3
        + ratio_q_P2_u_P1_of_place_50 * ratio_q_P3_u_P1_2_of_u_p1_4;
    let w_rod3_frame_23 = w_rod2_frame_in_rod3_frame_3 * w_rod2_frame_in_rod3_frame_2;
    let a_rod3_centre_2 = l_turn_rod2_frame_22 - a_rod1_frame_in_rod2_frame_2;
    let alpha_rod3_frame_1 = u_P1.mul_add(ratio_q_P3_u_P1_2, alpha_rod2_frame_1);
    let turn_rod3_frame_23 = w_rod3_frame_23 + alpha_rod3_frame_1;
    let a_rod2_frame_in_rod3_frame_2 = (-a_rod2_centre_3)
        .mul_add(sin_q_P3, a_rod3_centre_2 * cos_q_P3);
    let l_turn_rod3_frame_23 = l * turn_rod3_frame_23;
    let a_rod3_centre_2_2 = a_rod2_frame_in_rod3_frame_2
        .mul_add(S::int(2), l_turn_rod3_frame_23);
    let x_rod3_frame_2 = m * a_rod3_centre_2_2;
    let w_rod3_frame_11 = w_rod3_frame_1 * w_rod3_frame_1;
    let w_rod3_frame_22 = w_rod2_frame_in_rod3_frame_2 * w_rod2_frame_in_rod3_frame_2;
    let turn_rod3_frame_33 = w_rod3_frame_11 + w_rod3_frame_22;
    let a_rod2_frame_in_rod3_frame_3 = a_rod3_centre_2
        .mul_add(sin_q_P3, a_rod2_centre_3 * cos_q_P3);
    let l_turn_rod3_frame_33 = l * turn_rod3_frame_33;
    let a_rod3_centre_3 = (-a_rod2_frame_in_rod3_frame_3)
        .mul_add(S::int(2), l_turn_rod3_frame_33);
    let x_rod3_frame_3 = m * a_rod3_centre_3;
    let H_rod3_2 = w_rod2_frame_in_rod3_frame_2 * x_rod1_frame_2_2;
    let x_rod3_frame_1_2 = alpha_rod3_frame_1
        .mul_add(x_rod1_frame_2_2, w_rod2_frame_in_rod3_frame_3 * H_rod3_2);
    let H_rod3_1 = w_rod3_frame_1 * x_rod1_frame_2_2;
    let x_rod3_frame_2_2 = alpha_rod3_frame_2
        .mul_add(x_rod1_frame_2_2, w_rod2_frame_in_rod3_frame_3 * H_rod3_1);
    let x_rod3_frame_3_2 = (-w_rod2_frame_in_rod3_frame_2)
        .mul_add(H_rod3_1, w_rod3_frame_1 * H_rod3_2);
    let w_rod3_frame_in_rod4_frame_3 = (-w_rod2_frame_in_rod3_frame_3)
        .mul_add(cos_q_P4, w_rod3_frame_1 * sin_q_P4);
    let w_rod4_frame_2 = u_p1_ratio_q_p4_u_p1 - w_rod2_frame_in_rod3_frame_2;
    let w_rod4_frame_22 = w_rod4_frame_2 * w_rod4_frame_2;
    let w_rod4_frame_33 = w_rod3_frame_in_rod4_frame_3 * w_rod3_frame_in_rod4_frame_3;
    let turn_rod4_frame_11 = w_rod4_frame_22 + w_rod4_frame_33;
    let a_rod4_centre_1 = a_rod3_centre_1 + l_turn_rod3_frame_13;
    let a_rod4_centre_3 = l_turn_rod3_frame_33 - a_rod2_frame_in_rod3_frame_3;
    let a_rod3_frame_in_rod4_frame_1 = (-a_rod4_centre_1)
        .mul_add(cos_q_P4, a_rod4_centre_3 * sin_q_P4);
    let l_turn_rod4_frame_11 = l * turn_rod4_frame_11;
    let a_rod4_centre_1_2 = a_rod3_frame_in_rod4_frame_1
        .mul_add(S::int(2), l_turn_rod4_frame_11);
    let x_rod4_frame_1 = m * a_rod4_centre_1_2;
    let w_rod3_frame_in_rod4_frame_1 = w_rod2_frame_in_rod3_frame_3
        .mul_add(sin_q_P4, w_rod3_frame_1 * cos_q_P4);
    let w_rod4_frame_12 = w_rod4_frame_2 * w_rod3_frame_in_rod4_frame_1;
    let alpha_rod2_frame_in_rod3_frame_3 = alpha_rod2_frame_2
        .mul_add(sin_q_P3, alpha_rod2_frame_3 * cos_q_P3);
    let alpha_rod3_frame_3 = w_rod2_frame_in_rod3_frame_2
        .mul_add(u_p1_ratio_q_p3_u_p1, -alpha_rod2_frame_in_rod3_frame_3);
    let alpha_rod3_frame_in_rod4_frame_3 = (-alpha_rod3_frame_1)
        .mul_add(sin_q_P4, alpha_rod3_frame_3 * cos_q_P4);
    let alpha_rod4_frame_3 = w_rod3_frame_in_rod4_frame_1
        .mul_add(u_p1_ratio_q_p4_u_p1, alpha_rod3_frame_in_rod4_frame_3);
    let turn_rod4_frame_21 = w_rod4_frame_12 + alpha_rod4_frame_3;
    let a_rod4_centre_2 = a_rod2_frame_in_rod3_frame_2 + l_turn_rod3_frame_23;
    let l_turn_rod4_frame_21 = l * turn_rod4_frame_21;
    let a_rod4_centre_2_2 = (-a_rod4_centre_2).mul_add(S::int(2), l_turn_rod4_frame_21);
    let x_rod4_frame_2 = m * a_rod4_centre_2_2;
    let ratio_q_P4_u_P1_2_of_u_p1 = l * ratio_q_P4_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_51
        + ratio_q_P2_u_P1_of_place_38 * ratio_q_P2_u_P1_2_of_u_p1_62
        - ratio_q_P2_u_P1_2_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_78
        + ratio_q_P2_u_P1_of_place_6
            * (-ratio_q_P2_u_P1_of_place_15)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_79,
                    x_rod1_frame_in_rod2_frame_1_3 * ratio_q_P2_u_P1_2_of_u_p1_63,
                );
    let ratio_q_P4_u_P1_2_of_u_p1_2 = ratio_q_P2_u_P1_2_of_u_p1_28 - ratio_q_P2_u_P1_2_of_u_p1_16;
    let ratio_q_P4_u_P1_2 = ratio_q_P4_u_P1_of_place_3 * ratio_q_P2_u_P1_2_of_u_p1_112
        - ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_104
        - ratio_q_P4_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_110
        + ratio_q_P2_u_P1_of_place_72 * ratio_q_P3_u_P1_2_of_u_p1_4
        + ratio_q_P2_u_P1_of_place_102
            * ((-ratio_q_P2_u_P1_of_place_82)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_66,
                    ratio_q_P2_u_P1_of_place_29 * ratio_q_P4_u_P1_2_of_u_p1,
                ) - ratio_q_P3_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_71
                - ratio_q_P4_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_77
                - ratio_q_P2_u_P1_of_place_20 * ratio_q_P2_u_P1_2_of_u_p1_106
                - ratio_q_P2_u_P1_of_place_16 * ratio_q_P3_u_P1_2_of_u_p1)
        + ratio_q_P2_u_P1_of_place_108
            * (-ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P4_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_3
                - sin_q_P4
                    * ((-ratio_q_P4_u_P1_of_q_p4_q_p5)
                        .mul_add(
                            ratio_q_P2_u_P1_2_of_u_p1_16,
                            ratio_q_P2_u_P1_2_of_u_p1_95 * sin_q_P3,
                        ) - ratio_q_P2_u_P1_2_of_u_p1_25 - ratio_q_P2_u_P1_2_of_u_p1_28)
                + ratio_q_P4_u_P1_2_of_u_p1_2);
    let w_rod4_frame_13 = w_rod3_frame_in_rod4_frame_3 * w_rod3_frame_in_rod4_frame_1;
    let alpha_rod4_frame_2 = u_P1.mul_add(ratio_q_P4_u_P1_2, alpha_rod3_frame_2);
    let turn_rod4_frame_31 = w_rod4_frame_13 + alpha_rod4_frame_2;
    let a_rod3_frame_in_rod4_frame_3 = a_rod4_centre_3
        .mul_add(cos_q_P4, a_rod4_centre_1 * sin_q_P4);
    let l_turn_rod4_frame_31 = l * turn_rod4_frame_31;
    let a_rod4_centre_3_2 = a_rod3_frame_in_rod4_frame_3
        .mul_add(S::int(2), l_turn_rod4_frame_31);
    let x_rod4_frame_3 = m * a_rod4_centre_3_2;
    let H_rod4_2 = w_rod4_frame_2 * x_rod1_frame_2_2;
    let H_rod4_3 = w_rod3_frame_in_rod4_frame_3 * x_rod1_frame_2_2;
    let x_rod4_frame_1_2 = (-w_rod3_frame_in_rod4_frame_3)
        .mul_add(H_rod4_2, w_rod4_frame_2 * H_rod4_3);
    let x_rod4_frame_2_2 = alpha_rod4_frame_2
        .mul_add(x_rod1_frame_2_2, w_rod3_frame_in_rod4_frame_1 * H_rod4_3);
    let x_rod4_frame_3_2 = alpha_rod4_frame_3
        .mul_add(x_rod1_frame_2_2, w_rod3_frame_in_rod4_frame_1 * H_rod4_2);
    let w_rod4_frame_in_rod5_frame_1 = (-w_rod4_frame_2)
        .mul_add(sin_q_P5, w_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let w_rod4_frame_in_rod5_frame_2 = w_rod3_frame_in_rod4_frame_1
        .mul_add(sin_q_P5, w_rod4_frame_2 * cos_q_P5);
    let ratio_q_P5_u_P1_2 = ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_105
        + ratio_q_P5_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_112
        - ratio_q_P5_u_P1_of_place_2 * ratio_q_P3_u_P1_2_of_u_p1_3
        + ratio_q_P2_u_P1_of_place_80 * ratio_q_P3_u_P1_2_of_u_p1_4
        + ratio_q_P2_u_P1_of_place_102
            * ((-ratio_q_P2_u_P1_of_place_82)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_67,
                    ratio_q_P2_u_P1_of_place_16 * ratio_q_P3_u_P1_2_of_u_p1_2,
                ) - ratio_q_P3_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_71
                - ratio_q_P4_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_75
                - ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_u_p1_106
                - ratio_q_P2_u_P1_of_place_23 * ratio_q_P4_u_P1_2_of_u_p1)
        + ratio_q_P3_u_P1_of_place_5
            * (ratio_q_P5_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3
                - ratio_q_P5_u_P1_of_q_p3_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1
                + sin_q_P4
                    * ((-(ratio_q_P2_u_P1_2_of_u_p1_2 * sin_q_P3))
                        .mul_add(
                            S::int(2),
                            ratio_q_P2_u_P1_of_q_p5_4 * ratio_q_P2_u_P1_2_of_u_p1_16,
                        ) + ratio_q_P2_u_P1_2_of_u_p1_34)
                + ratio_q_P2_u_P1_of_q_p5 * ratio_q_P4_u_P1_2_of_u_p1_2);
    let w_rod5_frame_12 = w_rod4_frame_in_rod5_frame_1 * w_rod4_frame_in_rod5_frame_2;
    let alpha_rod5_frame_3 = u_P1.mul_add(ratio_q_P5_u_P1_2, alpha_rod4_frame_3);
    let turn_rod5_frame_12 = w_rod5_frame_12 - alpha_rod5_frame_3;
    let a_rod5_centre_1 = a_rod3_frame_in_rod4_frame_1 + l_turn_rod4_frame_11;
    let a_rod5_centre_2 = l_turn_rod4_frame_21 - a_rod4_centre_2;
    let a_rod4_frame_in_rod5_frame_1 = a_rod5_centre_2
        .mul_add(sin_q_P5, a_rod5_centre_1 * cos_q_P5);
    let a_rod5_centre_1_2 = a_rod4_frame_in_rod5_frame_1
        .mul_add(S::int(2), l * turn_rod5_frame_12);
    let x_rod5_frame_1 = m * a_rod5_centre_1_2;
    let w_rod5_frame_3 = u_p1_ratio_q_p5_u_p1 - w_rod3_frame_in_rod4_frame_3;
    let w_rod5_frame_11 = w_rod4_frame_in_rod5_frame_1 * w_rod4_frame_in_rod5_frame_1;
    let w_rod5_frame_33 = w_rod5_frame_3 * w_rod5_frame_3;
    let turn_rod5_frame_22 = w_rod5_frame_11 + w_rod5_frame_33;
    let a_rod4_frame_in_rod5_frame_2 = (-a_rod5_centre_2)
        .mul_add(cos_q_P5, a_rod5_centre_1 * sin_q_P5);
    let a_rod5_centre_2_2 = (-a_rod4_frame_in_rod5_frame_2)
        .mul_add(S::int(2), l * turn_rod5_frame_22);
    let x_rod5_frame_2 = m * a_rod5_centre_2_2;
    let w_rod5_frame_23 = w_rod4_frame_in_rod5_frame_2 * w_rod5_frame_3;
    let alpha_rod3_frame_in_rod4_frame_1 = alpha_rod3_frame_3
        .mul_add(sin_q_P4, alpha_rod3_frame_1 * cos_q_P4);
    let alpha_rod4_frame_1 = w_rod3_frame_in_rod4_frame_3
        .mul_add(u_p1_ratio_q_p4_u_p1, alpha_rod3_frame_in_rod4_frame_1);
    let alpha_rod4_frame_in_rod5_frame_1 = (-alpha_rod4_frame_2)
        .mul_add(sin_q_P5, alpha_rod4_frame_1 * cos_q_P5);
    let alpha_rod5_frame_1 = w_rod4_frame_in_rod5_frame_2
        .mul_add(u_p1_ratio_q_p5_u_p1, alpha_rod4_frame_in_rod5_frame_1);
    let turn_rod5_frame_32 = w_rod5_frame_23 + alpha_rod5_frame_1;
    let a_rod5_centre_3 = a_rod3_frame_in_rod4_frame_3 + l_turn_rod4_frame_31;
    let a_rod5_centre_3_2 = a_rod5_centre_3.mul_add(S::int(2), l * turn_rod5_frame_32);
    let x_rod5_frame_3 = m * a_rod5_centre_3_2;
    let H_rod5_3 = w_rod5_frame_3 * x_rod1_frame_2_2;
    let x_rod5_frame_1_2 = alpha_rod5_frame_1
        .mul_add(x_rod1_frame_2_2, w_rod4_frame_in_rod5_frame_2 * H_rod5_3);
    let H_rod5_1 = w_rod4_frame_in_rod5_frame_1 * x_rod1_frame_2_2;
    let x_rod5_frame_2_2 = (-w_rod4_frame_in_rod5_frame_1)
        .mul_add(H_rod5_3, w_rod5_frame_3 * H_rod5_1);
    let x_rod5_frame_3_2 = (-alpha_rod5_frame_3)
        .mul_add(x_rod1_frame_2_2, w_rod4_frame_in_rod5_frame_2 * H_rod5_1);
    let x_rod1_frame_3 = l * m;
    let x_rod1_frame_in_N_1 = l * cos_q_P1;
    let x_N_in_rod1_frame_1 = (-x_rod1_frame_in_N_3)
        .mul_add(cos_q_P1, x_rod1_frame_in_N_1 * sin_q_P1);
    let x_N_in_rod1_frame_3 = x_rod1_frame_in_N_3
        .mul_add(sin_q_P1, x_rod1_frame_in_N_1 * cos_q_P1);
    let x_rod5_frame_1_3 = l * ratio_q_P2_u_P1;
    let x_rod2_frame_1_3 = m * x_rod5_frame_1_3;
    let x_rod2_frame_in_rod1_frame_1 = l * sin_q_P2;
    let a_rod2_centre_3_2 = l.mul_add(S::int(2), -x_rod2_frame_in_rod1_frame_1);
    let x_rod2_frame_3_3 = m * a_rod2_centre_3_2;
    let x_rod2_frame_1_4 = x_rod1_frame_2_2 * sin_q_P2;
    let x_rod2_frame_in_rod1_frame_2 = l * cos_q_P2;
    let x_rod1_frame_in_rod2_frame_1 = x_rod2_frame_in_rod1_frame_2
        .mul_add(cos_q_P2, x_rod2_frame_in_rod1_frame_1 * sin_q_P2);
    let x_rod1_frame_in_rod2_frame_2 = (-x_rod2_frame_in_rod1_frame_1)
        .mul_add(cos_q_P2, x_rod2_frame_in_rod1_frame_2 * sin_q_P2);
    let x_rod2_frame_3_4 = ratio_q_P2_u_P1 * x_rod1_frame_2_2;
    let w_rod2_frame_in_rod3_frame_2_2 = ratio_q_P2_u_P1
        .mul_add(sin_q_P3, x_rod2_frame_in_rod3_frame_2_4);
    let a_rod3_centre_1_3_of_place = l * w_rod2_frame_in_rod3_frame_2_2;
    let a_rod3_centre_1_3 = (-x_rod5_frame_1_3)
        .mul_add(S::int(2), a_rod3_centre_1_3_of_place);
    let x_rod3_frame_1_3 = m * a_rod3_centre_1_3;
    let w_rod3_frame_1_2 = sin_q_P2 + ratio_q_P3_u_P1;
    let x_rod5_frame_3_3 = l - x_rod2_frame_in_rod1_frame_1;
    let x_rod2_frame_in_rod3_frame_2 = x_rod5_frame_3_3 * sin_q_P3;
    let l_w_rod3_frame_1_2 = l * w_rod3_frame_1_2;
    let a_rod3_centre_2_3 = x_rod2_frame_in_rod3_frame_2
        .mul_add(S::int(2), l_w_rod3_frame_1_2);
    let x_rod3_frame_2_3 = m * a_rod3_centre_2_3;
    let x_rod2_frame_in_rod3_frame_3 = x_rod5_frame_3_3 * cos_q_P3;
    let x_rod3_frame_3_3 = m * x_rod2_frame_in_rod3_frame_3;
    let x_rod3_frame_1_4 = x_rod1_frame_2_2 * w_rod3_frame_1_2;
    let x_rod3_frame_in_rod2_frame_3 = l * cos_q_P3;
    let x_rod3_frame_in_rod2_frame_2 = l * sin_q_P3;
    let x_rod3_frame_2_4 = x_rod1_frame_2_2 * w_rod2_frame_in_rod3_frame_2_2;
    let x_rod2_frame_in_rod3_frame_2_2 = x_rod3_frame_in_rod2_frame_2
        .mul_add(sin_q_P3, x_rod3_frame_in_rod2_frame_3 * cos_q_P3);
    let x_rod2_frame_in_rod3_frame_3_2 = (-x_rod3_frame_in_rod2_frame_2)
        .mul_add(cos_q_P3, x_rod3_frame_in_rod2_frame_3 * sin_q_P3);
    let x_rod5_frame_1_4 = a_rod3_centre_1_3_of_place - x_rod5_frame_1_3;
    let x_rod3_frame_in_rod4_frame_1 = x_rod5_frame_1_4
        .mul_add(cos_q_P4, x_rod2_frame_in_rod3_frame_3 * sin_q_P4);
    let x_rod4_frame_1_3 = m * x_rod3_frame_in_rod4_frame_1;
    let w_rod2_frame_in_rod3_frame_3_2 = (-ratio_q_P2_u_P1)
        .mul_add(cos_q_P3, x_rod2_frame_in_rod3_frame_3_4);
    let w_rod3_frame_in_rod4_frame_3_2 = (-w_rod3_frame_1_2)
        .mul_add(sin_q_P4, w_rod2_frame_in_rod3_frame_3_2 * cos_q_P4);
    let x_rod5_frame_2_3 = x_rod2_frame_in_rod3_frame_2 + l_w_rod3_frame_1_2;
    let a_rod4_centre_2_3_of_place = l * w_rod3_frame_in_rod4_frame_3_2;
    let a_rod4_centre_2_3 = (-x_rod5_frame_2_3)
        .mul_add(S::int(2), a_rod4_centre_2_3_of_place);
    let x_rod4_frame_2_3 = m * a_rod4_centre_2_3;
    let w_rod4_frame_2_2 = ratio_q_P4_u_P1 - w_rod2_frame_in_rod3_frame_2_2;
    let x_rod3_frame_in_rod4_frame_3 = (-x_rod5_frame_1_4)
        .mul_add(sin_q_P4, x_rod2_frame_in_rod3_frame_3 * cos_q_P4);
    let l_w_rod4_frame_2_2 = l * w_rod4_frame_2_2;
    let a_rod4_centre_3_3 = x_rod3_frame_in_rod4_frame_3
        .mul_add(S::int(2), l_w_rod4_frame_2_2);
    let x_rod4_frame_3_3 = m * a_rod4_centre_3_3;
    let x_rod4_frame_in_rod3_frame_1 = l * cos_q_P4;
    let x_rod4_frame_in_rod3_frame_3 = l * sin_q_P4;
    let x_rod3_frame_in_rod4_frame_1_2 = (-x_rod4_frame_in_rod3_frame_3)
        .mul_add(cos_q_P4, x_rod4_frame_in_rod3_frame_1 * sin_q_P4);
    let x_rod4_frame_2_4 = x_rod1_frame_2_2 * w_rod4_frame_2_2;
    let x_rod4_frame_3_4 = x_rod1_frame_2_2 * w_rod3_frame_in_rod4_frame_3_2;
    let x_rod3_frame_in_rod4_frame_3_2 = x_rod4_frame_in_rod3_frame_3
        .mul_add(sin_q_P4, x_rod4_frame_in_rod3_frame_1 * cos_q_P4);
    let w_rod5_frame_3_2 = ratio_q_P5_u_P1 + w_rod3_frame_in_rod4_frame_3_2;
    let x_rod5_frame_2_4 = a_rod4_centre_2_3_of_place - x_rod5_frame_2_3;
    let x_rod4_frame_in_rod5_frame_1 = x_rod5_frame_2_4
        .mul_add(sin_q_P5, x_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let a_rod5_centre_1_3 = (-x_rod4_frame_in_rod5_frame_1)
        .mul_add(S::int(2), l * w_rod5_frame_3_2);
    let x_rod5_frame_1_5 = m * a_rod5_centre_1_3;
    let x_rod2_frame_in_rod3_frame_2_3 = (-x_rod1_frame_in_rod2_frame_2_2)
        .mul_add(cos_q_P3, sin_q_p3_sin_q_p1);
    let x_rod2_frame_in_rod3_frame_3_3 = x_rod1_frame_in_rod2_frame_2_2
        .mul_add(sin_q_P3, cos_q_p3_sin_q_p1);
    let x_rod3_frame_in_rod4_frame_1_3 = (-x_rod1_frame_in_rod2_frame_1_2)
        .mul_add(cos_q_P4, x_rod2_frame_in_rod3_frame_3_3 * sin_q_P4);
    let x_rod4_frame_in_rod5_frame_1_2 = (-x_rod2_frame_in_rod3_frame_2_3)
        .mul_add(sin_q_P5, x_rod3_frame_in_rod4_frame_1_3 * cos_q_P5);
    let x_rod3_frame_in_rod4_frame_1_4 = x_rod2_frame_in_rod3_frame_3_4
        .mul_add(sin_q_P4, sin_q_p2_cos_q_p4);
    let x_rod4_frame_in_rod5_frame_1_3 = x_rod3_frame_in_rod4_frame_1_4
        .mul_add(cos_q_P5, x_rod2_frame_in_rod3_frame_2_4 * sin_q_P5);
    let x_rod2_frame_in_rod3_frame_3_5 = (-x_rod1_frame_in_rod2_frame_2_3)
        .mul_add(sin_q_P3, cos_q_p3_cos_q_p1);
    let x_rod3_frame_in_rod4_frame_1_5 = x_rod2_frame_in_rod3_frame_3_5
        .mul_add(sin_q_P4, x_rod1_frame_in_rod2_frame_1_3 * cos_q_P4);
    let x_rod4_frame_in_rod5_frame_1_4 = (-x_rod2_frame_in_rod3_frame_2_5)
        .mul_add(sin_q_P5, x_rod3_frame_in_rod4_frame_1_5 * cos_q_P5);
    let x_rod4_frame_in_rod5_frame_2 = (-x_rod5_frame_2_4)
        .mul_add(cos_q_P5, x_rod3_frame_in_rod4_frame_1 * sin_q_P5);
    let x_rod5_frame_2_5 = m * x_rod4_frame_in_rod5_frame_2;
    let x_rod4_frame_in_rod5_frame_2_2 = x_rod3_frame_in_rod4_frame_1_3
        .mul_add(sin_q_P5, x_rod2_frame_in_rod3_frame_2_3 * cos_q_P5);
    let x_rod4_frame_in_rod5_frame_2_3 = (-x_rod2_frame_in_rod3_frame_2_4)
        .mul_add(cos_q_P5, x_rod3_frame_in_rod4_frame_1_4 * sin_q_P5);
    let x_rod4_frame_in_rod5_frame_2_4 = x_rod3_frame_in_rod4_frame_1_5
        .mul_add(sin_q_P5, ratio_q_P2_u_P1_of_place_10);
    let w_rod3_frame_in_rod4_frame_1_2 = w_rod2_frame_in_rod3_frame_3_2
        .mul_add(sin_q_P4, w_rod3_frame_1_2 * cos_q_P4);
    let w_rod4_frame_in_rod5_frame_1_2 = (-w_rod4_frame_2_2)
        .mul_add(sin_q_P5, w_rod3_frame_in_rod4_frame_1_2 * cos_q_P5);
    let x_rod5_frame_3_4 = x_rod3_frame_in_rod4_frame_3 + l_w_rod4_frame_2_2;
    let a_rod5_centre_3_3 = x_rod5_frame_3_4
        .mul_add(S::int(2), l * w_rod4_frame_in_rod5_frame_1_2);
    let x_rod5_frame_3_5 = m * a_rod5_centre_3_3;
    let x_rod3_frame_in_rod4_frame_3_3 = x_rod2_frame_in_rod3_frame_3_3
        .mul_add(cos_q_P4, x_rod1_frame_in_rod2_frame_1_2 * sin_q_P4);
    let x_rod3_frame_in_rod4_frame_3_4 = (-x_rod2_frame_in_rod3_frame_3_4)
        .mul_add(cos_q_P4, sin_q_p2_sin_q_p4);
    let x_rod3_frame_in_rod4_frame_3_5 = x_rod2_frame_in_rod3_frame_3_5
        .mul_add(cos_q_P4, -ratio_q_P2_u_P1_of_place_75);
    let x_rod5_frame_1_6 = x_rod1_frame_2_2 * w_rod4_frame_in_rod5_frame_1_2;
    let x_rod5_frame_in_rod4_frame_1 = l * sin_q_P5;
    let x_rod4_frame_in_rod3_frame_1_2 = x_rod5_frame_in_rod4_frame_1 * cos_q_P4;
    let x_rod4_frame_in_rod3_frame_3_2 = x_rod5_frame_in_rod4_frame_1 * sin_q_P4;
    let x_rod3_frame_in_rod2_frame_2_2 = (-x_rod4_frame_in_rod3_frame_3_2)
        .mul_add(sin_q_P3, x_rod5_frame_in_rod4_frame_2 * cos_q_P3);
    let x_rod3_frame_in_rod2_frame_3_2 = x_rod4_frame_in_rod3_frame_3_2
        .mul_add(cos_q_P3, x_rod5_frame_in_rod4_frame_2 * sin_q_P3);
    let x_rod2_frame_in_rod1_frame_1_2 = x_rod3_frame_in_rod2_frame_2_2
        .mul_add(sin_q_P2, x_rod4_frame_in_rod3_frame_1_2 * cos_q_P2);
    let x_rod2_frame_in_rod1_frame_2_2 = (-x_rod3_frame_in_rod2_frame_2_2)
        .mul_add(cos_q_P2, x_rod4_frame_in_rod3_frame_1_2 * sin_q_P2);
    let x_rod1_frame_in_N_3_2 = x_rod2_frame_in_rod1_frame_1_2
        .mul_add(sin_q_P1, x_rod3_frame_in_rod2_frame_3_2 * cos_q_P1);
    let x_N_in_rod1_frame_1_2 = x_rod2_frame_in_rod1_frame_2_2 * sin_q_P1;
    let x_N_in_rod1_frame_1_3 = x_rod2_frame_in_rod1_frame_2_2 * cos_q_P1;
    let x_rod1_frame_in_rod2_frame_1_4 = (-x_rod1_frame_in_N_3_2)
        .mul_add(sin_q_P2, x_N_in_rod1_frame_1_2 * cos_q_P2);
    let x_rod1_frame_in_rod2_frame_2_4 = x_N_in_rod1_frame_1_2
        .mul_add(sin_q_P2, x_rod1_frame_in_N_3_2 * cos_q_P2);
    let x_rod2_frame_in_rod3_frame_2_6 = x_rod1_frame_in_rod2_frame_2_4
        .mul_add(cos_q_P3, x_N_in_rod1_frame_1_3 * sin_q_P3);
    let x_rod2_frame_in_rod3_frame_3_6 = (-x_N_in_rod1_frame_1_3)
        .mul_add(cos_q_P3, x_rod1_frame_in_rod2_frame_2_4 * sin_q_P3);
    let x_rod3_frame_in_rod4_frame_1_6 = (-x_rod1_frame_in_rod2_frame_1_4)
        .mul_add(cos_q_P4, x_rod2_frame_in_rod3_frame_3_6 * sin_q_P4);
    let x_rod4_frame_in_rod5_frame_1_5 = x_rod3_frame_in_rod4_frame_1_6
        .mul_add(cos_q_P5, x_rod2_frame_in_rod3_frame_2_6 * sin_q_P5);
    let x_rod1_frame_in_N_1_2 = (-x_rod2_frame_in_rod1_frame_1_2)
        .mul_add(cos_q_P1, x_rod3_frame_in_rod2_frame_3_2 * sin_q_P1);
    let x_N_in_rod1_frame_1_4 = x_rod1_frame_in_N_1_2
        .mul_add(sin_q_P1, x_rod1_frame_in_N_3_2 * cos_q_P1);
    let x_N_in_rod1_frame_3_2 = (-x_rod1_frame_in_N_3_2)
        .mul_add(sin_q_P1, x_rod1_frame_in_N_1_2 * cos_q_P1);
    let x_rod1_frame_in_rod2_frame_1_5 = x_N_in_rod1_frame_1_4 * cos_q_P2;
    let x_rod1_frame_in_rod2_frame_2_5 = x_N_in_rod1_frame_1_4 * sin_q_P2;
    let x_rod2_frame_in_rod3_frame_2_7 = x_rod1_frame_in_rod2_frame_2_5
        .mul_add(cos_q_P3, x_N_in_rod1_frame_3_2 * sin_q_P3);
    let x_rod2_frame_in_rod3_frame_3_7 = (-x_N_in_rod1_frame_3_2)
        .mul_add(cos_q_P3, x_rod1_frame_in_rod2_frame_2_5 * sin_q_P3);
    let x_rod3_frame_in_rod4_frame_1_7 = (-x_rod1_frame_in_rod2_frame_1_5)
        .mul_add(cos_q_P4, x_rod2_frame_in_rod3_frame_3_7 * sin_q_P4);
    let x_rod4_frame_in_rod5_frame_1_6 = x_rod3_frame_in_rod4_frame_1_7
        .mul_add(cos_q_P5, x_rod2_frame_in_rod3_frame_2_7 * sin_q_P5);
    let x_rod1_frame_in_rod2_frame_1_6 = x_rod1_frame_in_N_1_2
        .mul_add(sin_q_P2, x_N_in_rod1_frame_1_3 * cos_q_P2);
    let x_rod1_frame_in_rod2_frame_2_6 = (-x_rod1_frame_in_N_1_2)
        .mul_add(cos_q_P2, x_N_in_rod1_frame_1_3 * sin_q_P2);
    let x_rod2_frame_in_rod3_frame_2_8 = (-x_N_in_rod1_frame_1_2)
        .mul_add(sin_q_P3, x_rod1_frame_in_rod2_frame_2_6 * cos_q_P3);
    let x_rod2_frame_in_rod3_frame_3_8 = x_rod1_frame_in_rod2_frame_2_6
        .mul_add(sin_q_P3, x_N_in_rod1_frame_1_2 * cos_q_P3);
    let x_rod3_frame_in_rod4_frame_1_8 = (-x_rod1_frame_in_rod2_frame_1_6)
        .mul_add(cos_q_P4, x_rod2_frame_in_rod3_frame_3_8 * sin_q_P4);
    let x_rod4_frame_in_rod5_frame_1_7 = x_rod3_frame_in_rod4_frame_1_8
        .mul_add(cos_q_P5, x_rod2_frame_in_rod3_frame_2_8 * sin_q_P5);
    let x_N_2 = ratio_q_P2_u_P1_of_place_28;
    let x_N_in_rod1_frame_1_5 = ratio_q_P2_u_P1_of_place_5 * cos_q_P1;
    let x_N_in_rod1_frame_3_3 = ratio_q_P2_u_P1_of_place_5 * sin_q_P1;
    let x_rod1_frame_in_rod2_frame_1_7 = x_N_in_rod1_frame_1_5
        .mul_add(cos_q_P2, x_N_2 * sin_q_P2);
    let x_rod1_frame_in_rod2_frame_2_7 = (-x_N_2)
        .mul_add(cos_q_P2, x_N_in_rod1_frame_1_5 * sin_q_P2);
    let x_rod2_frame_in_rod3_frame_2_9 = (-x_N_in_rod1_frame_3_3)
        .mul_add(sin_q_P3, x_rod1_frame_in_rod2_frame_2_7 * cos_q_P3);
    let x_rod2_frame_in_rod3_frame_3_9 = x_rod1_frame_in_rod2_frame_2_7
        .mul_add(sin_q_P3, x_N_in_rod1_frame_3_3 * cos_q_P3);
    let x_rod3_frame_in_rod4_frame_1_9 = (-x_rod1_frame_in_rod2_frame_1_7)
        .mul_add(cos_q_P4, x_rod2_frame_in_rod3_frame_3_9 * sin_q_P4);
    let x_rod4_frame_in_rod5_frame_1_8 = x_rod3_frame_in_rod4_frame_1_9
        .mul_add(cos_q_P5, x_rod2_frame_in_rod3_frame_2_9 * sin_q_P5);
    let x_rod4_frame_in_rod5_frame_1_9 = x_rod5_frame_in_rod4_frame_2
        .mul_add(cos_q_P5, x_rod5_frame_in_rod4_frame_1 * sin_q_P5);
    let x_rod4_frame_in_rod5_frame_2_5 = (-x_rod2_frame_in_rod3_frame_2_6)
        .mul_add(cos_q_P5, x_rod3_frame_in_rod4_frame_1_6 * sin_q_P5);
    let x_rod4_frame_in_rod5_frame_2_6 = (-x_rod2_frame_in_rod3_frame_2_7)
        .mul_add(cos_q_P5, x_rod3_frame_in_rod4_frame_1_7 * sin_q_P5);
    let x_rod4_frame_in_rod5_frame_2_7 = (-x_rod2_frame_in_rod3_frame_2_8)
        .mul_add(cos_q_P5, x_rod3_frame_in_rod4_frame_1_8 * sin_q_P5);
    let x_rod4_frame_in_rod5_frame_2_8 = (-x_rod2_frame_in_rod3_frame_2_9)
        .mul_add(cos_q_P5, x_rod3_frame_in_rod4_frame_1_9 * sin_q_P5);
    let x_rod4_frame_in_rod5_frame_2_9 = (-x_rod5_frame_in_rod4_frame_1)
        .mul_add(cos_q_P5, x_rod5_frame_in_rod4_frame_2 * sin_q_P5);
    let x_rod5_frame_3_6 = x_rod1_frame_2_2 * w_rod5_frame_3_2;
    let x_rod3_frame_in_rod4_frame_3_6 = x_rod2_frame_in_rod3_frame_3_6
        .mul_add(cos_q_P4, x_rod1_frame_in_rod2_frame_1_4 * sin_q_P4);
    let x_rod3_frame_in_rod4_frame_3_7 = x_rod2_frame_in_rod3_frame_3_7
        .mul_add(cos_q_P4, x_rod1_frame_in_rod2_frame_1_5 * sin_q_P4);
    let x_rod3_frame_in_rod4_frame_3_8 = x_rod2_frame_in_rod3_frame_3_8
        .mul_add(cos_q_P4, x_rod1_frame_in_rod2_frame_1_6 * sin_q_P4);
    let x_rod3_frame_in_rod4_frame_3_9 = x_rod2_frame_in_rod3_frame_3_9
        .mul_add(cos_q_P4, x_rod1_frame_in_rod2_frame_1_7 * sin_q_P4);
    let l_halved = S::ratio(1, 2) * l;
    let minus_sin_q_p2 = -sin_q_P2;
    let minus_sin_q_p3 = -sin_q_P3;
    let minus_sin_q_p4 = -sin_q_P4;
    let minus_sin_q_p5 = -sin_q_P5;
    let minus_sin_q_p1 = -sin_q_P1;
    let minus_cos_q_p3 = -cos_q_P3;
    let minus_cos_q_p5 = -cos_q_P5;
    let minus_cos_q_p1 = -cos_q_P1;
    let minus_cos_q_p2 = -cos_q_P2;
    let minus_cos_q_p4 = -cos_q_P4;
    let minus_l_halved = -l_halved;
    // Values.
    let m_1_21 = S::int(1);
    let m_1_26 = minus_cos_q_p1;
    let m_1_28 = sin_q_P1;
    let m_2_22 = S::int(1);
    let m_2_27 = -S::int(1);
    let m_3_1 = -S::ratio(1, 2) * x_rod1_frame_3;
    let m_3_23 = S::int(1);
    let m_3_26 = minus_sin_q_p1;
    let m_3_28 = minus_cos_q_p1;
    let m_4_24 = S::int(1);
    let m_4_27 = -S::ratio(1, 2) * x_N_in_rod1_frame_1;
    let m_4_29 = minus_cos_q_p1;
    let m_4_30 = sin_q_P1;
    let m_5_1 = S::ratio(1, 12) * x_rod1_frame_2_2;
    let m_5_23 = minus_l_halved;
    let m_5_25 = S::int(1);
    let m_5_26 = -S::ratio(1, 2) * x_rod1_frame_in_N_3;
    let m_5_28 = -S::ratio(1, 2) * x_rod1_frame_in_N_1;
    let m_6_22 = l_halved;
    let m_6_27 = S::ratio(1, 2) * x_N_in_rod1_frame_3;
    let m_6_29 = minus_sin_q_p1;
    let m_6_30 = minus_cos_q_p1;
    let m_7_1 = -S::ratio(1, 2) * x_rod2_frame_1_3;
    let m_7_16 = S::int(1);
    let m_7_21 = minus_cos_q_p2;
    let m_7_22 = minus_sin_q_p2;
    let m_8_17 = S::int(1);
    let m_8_21 = sin_q_P2;
    let m_8_22 = minus_cos_q_p2;
    let m_9_1 = -S::ratio(1, 2) * x_rod2_frame_3_3;
    let m_9_18 = S::int(1);
    let m_9_23 = -S::int(1);
    let m_10_1 = S::ratio(1, 12) * x_rod2_frame_1_4;
    let m_10_18 = l_halved;
    let m_10_23 = S::ratio(1, 2) * x_rod1_frame_in_rod2_frame_1;
    let m_10_24 = minus_cos_q_p2;
    let m_10_25 = minus_sin_q_p2;
    let m_11_19 = S::int(1);
    let m_11_23 = -S::ratio(1, 2) * x_rod1_frame_in_rod2_frame_2;
    let m_11_24 = sin_q_P2;
    let m_11_25 = minus_cos_q_p2;
    let m_12_1 = S::ratio(1, 12) * x_rod2_frame_3_4;
    let m_12_16 = minus_l_halved;
    let m_12_20 = S::int(1);
    let m_12_21 = -S::ratio(1, 2) * x_rod2_frame_in_rod1_frame_2;
    let m_12_22 = -S::ratio(1, 2) * x_rod2_frame_in_rod1_frame_1;
    let m_13_1 = S::ratio(1, 2) * x_rod3_frame_1_3;
    let m_13_11 = S::int(1);
    let m_13_16 = -S::int(1);
    let m_14_1 = -S::ratio(1, 2) * x_rod3_frame_2_3;
    let m_14_12 = S::int(1);
    let m_14_17 = minus_cos_q_p3;
    let m_14_18 = minus_sin_q_p3;
    let m_15_1 = -x_rod3_frame_3_3;
    let m_15_13 = S::int(1);
    let m_15_17 = sin_q_P3;
    let m_15_18 = minus_cos_q_p3;
    let m_16_1 = S::ratio(1, 12) * x_rod3_frame_1_4;
    let m_16_12 = minus_l_halved;
    let m_16_14 = S::int(1);
    let m_16_17 = -S::ratio(1, 2) * x_rod3_frame_in_rod2_frame_3;
    let m_16_18 = -S::ratio(1, 2) * x_rod3_frame_in_rod2_frame_2;
    let m_17_1 = S::ratio(1, 12) * x_rod3_frame_2_4;
    let m_17_11 = l_halved;
    let m_17_16 = S::ratio(1, 2) * x_rod2_frame_in_rod3_frame_2_2;
    let m_17_19 = minus_cos_q_p3;
    let m_17_20 = minus_sin_q_p3;
    let m_18_15 = S::int(1);
    let m_18_16 = -S::ratio(1, 2) * x_rod2_frame_in_rod3_frame_3_2;
    let m_18_19 = sin_q_P3;
    let m_18_20 = minus_cos_q_p3;
    let m_19_6 = S::int(1);
    let m_19_11 = minus_cos_q_p4;
    let m_19_13 = sin_q_P4;
    let m_20_1 = S::ratio(1, 2) * x_rod4_frame_2_3;
    let m_20_7 = S::int(1);
    let m_20_12 = -S::int(1);
    let m_21_1 = -S::ratio(1, 2) * x_rod4_frame_3_3;
    let m_21_8 = S::int(1);
    let m_21_11 = minus_sin_q_p4;
    let m_21_13 = minus_cos_q_p4;
    let m_22_9 = S::int(1);
    let m_22_12 = S::ratio(1, 2) * x_rod3_frame_in_rod4_frame_1_2;
    let m_22_14 = minus_cos_q_p4;
    let m_22_15 = sin_q_P4;
    let m_23_1 = -S::ratio(1, 12) * x_rod4_frame_2_4;
    let m_23_8 = l_halved;
    let m_23_10 = S::int(1);
    let m_23_11 = S::ratio(1, 2) * x_rod4_frame_in_rod3_frame_3;
    let m_23_13 = S::ratio(1, 2) * x_rod4_frame_in_rod3_frame_1;
    let m_24_1 = -S::ratio(1, 12) * x_rod4_frame_3_4;
    let m_24_7 = minus_l_halved;
    let m_24_12 = -S::ratio(1, 2) * x_rod3_frame_in_rod4_frame_3_2;
    let m_24_14 = minus_sin_q_p4;
    let m_24_15 = minus_cos_q_p4;
    let m_25_1 = -S::ratio(1, 2) * x_rod5_frame_1_5;
    let m_25_3 = -x_rod4_frame_in_rod5_frame_1_3;
    let m_25_6 = minus_cos_q_p5;
    let m_25_7 = minus_sin_q_p5;
    let m_26_1 = -x_rod5_frame_2_5;
    let m_26_2 = -x_rod4_frame_in_rod5_frame_2_2;
    let m_26_4 = -x_rod4_frame_in_rod5_frame_2_4;
    let m_26_6 = sin_q_P5;
    let m_26_7 = minus_cos_q_p5;
    let m_27_1 = -S::ratio(1, 2) * x_rod5_frame_3_5;
    let m_27_2 = -x_rod3_frame_in_rod4_frame_3_3;
    let m_27_3 = -x_rod3_frame_in_rod4_frame_3_4;
    let m_27_4 = -x_rod3_frame_in_rod4_frame_3_5;
    let m_27_8 = -S::int(1);
    let m_28_1 = S::ratio(1, 12) * x_rod5_frame_1_6;
    let m_28_2 = S::ratio(1, 2) * x_rod4_frame_in_rod5_frame_1_5;
    let m_28_3 = S::ratio(1, 2) * x_rod4_frame_in_rod5_frame_1_6;
    let m_28_4 = S::ratio(1, 2) * x_rod4_frame_in_rod5_frame_1_7;
    let m_28_8 = -S::ratio(1, 2) * x_rod4_frame_in_rod5_frame_1_9;
    let m_28_9 = minus_cos_q_p5;
    let m_28_10 = minus_sin_q_p5;
    let m_29_2 = -S::ratio(1, 2) * x_rod4_frame_in_rod5_frame_2_5;
    let m_29_3 = -S::ratio(1, 2) * x_rod4_frame_in_rod5_frame_2_6;
    let m_29_4 = -S::ratio(1, 2) * x_rod4_frame_in_rod5_frame_2_7;
    let m_29_5 = -x_rod4_frame_in_rod5_frame_2_8;
    let m_29_8 = S::ratio(1, 2) * x_rod4_frame_in_rod5_frame_2_9;
    let m_29_9 = sin_q_P5;
    let m_29_10 = minus_cos_q_p5;
    let m_30_1 = -S::ratio(1, 12) * x_rod5_frame_3_6;
    let m_30_2 = -S::ratio(1, 2) * x_rod3_frame_in_rod4_frame_3_6;
    let m_30_3 = -S::ratio(1, 2) * x_rod3_frame_in_rod4_frame_3_7;
    let m_30_4 = -S::ratio(1, 2) * x_rod3_frame_in_rod4_frame_3_8;
    let m_30_5 = -x_rod3_frame_in_rod4_frame_3_9;
    let m_30_6 = S::ratio(1, 2) * x_rod5_frame_in_rod4_frame_2;
    let m_30_7 = S::ratio(1, 2) * x_rod5_frame_in_rod4_frame_1;
    let f_1 = S::ratio(1, 2) * x_rod1_frame_1;
    let f_2 = -x_rod1_frame_2;
    let f_7 = S::ratio(1, 2) * x_rod2_frame_1;
    let f_8 = S::ratio(1, 2) * x_rod2_frame_2;
    let f_9 = -S::ratio(1, 2) * x_rod2_frame_3;
    let f_10 = -S::ratio(1, 12) * x_rod2_frame_1_2;
    let f_11 = -S::ratio(1, 12) * x_rod2_frame_2_2;
    let f_12 = S::ratio(1, 12) * x_rod2_frame_3_2;
    let f_13 = S::ratio(1, 2) * x_rod3_frame_1;
    let f_14 = S::ratio(1, 2) * x_rod3_frame_2;
    let f_15 = S::ratio(1, 2) * x_rod3_frame_3;
    let f_16 = -S::ratio(1, 12) * x_rod3_frame_1_2;
    let f_17 = S::ratio(1, 12) * x_rod3_frame_2_2;
    let f_18 = -S::ratio(1, 12) * x_rod3_frame_3_2;
    let f_19 = -S::ratio(1, 2) * x_rod4_frame_1;
    let f_20 = -S::ratio(1, 2) * x_rod4_frame_2;
    let f_21 = S::ratio(1, 2) * x_rod4_frame_3;
    let f_22 = S::ratio(1, 12) * x_rod4_frame_1_2;
    let f_23 = S::ratio(1, 12) * x_rod4_frame_2_2;
    let f_24 = S::ratio(1, 12) * x_rod4_frame_3_2;
    let f_25 = -S::ratio(1, 2) * x_rod5_frame_1;
    let f_26 = -S::ratio(1, 2) * x_rod5_frame_2;
    let f_27 = S::ratio(1, 2) * x_rod5_frame_3;
    let f_28 = -S::ratio(1, 12) * x_rod5_frame_1_2;
    let f_29 = S::ratio(1, 12) * x_rod5_frame_2_2;
    let f_30 = -S::ratio(1, 12) * x_rod5_frame_3_2;
    let zero = S::int(0);
    (
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, m_1_21, zero, zero, zero, zero, m_1_26, zero,
            m_1_28, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_2_22, zero, zero, zero,
            zero, m_2_27, zero, zero, zero, m_3_1, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_3_23,
            zero, zero, m_3_26, zero, m_3_28, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, m_4_24, zero, zero, m_4_27, zero, m_4_29, m_4_30, m_5_1, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, m_5_23, zero, m_5_25, m_5_26, zero, m_5_28, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, m_6_22, zero, zero, zero, zero, m_6_27, zero,
            m_6_29, m_6_30, m_7_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, m_7_16, zero, zero, zero, zero, m_7_21, m_7_22, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, m_8_17, zero, zero, zero, m_8_21, m_8_22,
            zero, zero, zero, zero, zero, zero, zero, zero, m_9_1, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_9_18, zero, zero,
            zero, zero, m_9_23, zero, zero, zero, zero, zero, zero, zero, m_10_1, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_10_18,
            zero, zero, zero, zero, m_10_23, m_10_24, m_10_25, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, m_11_19, zero, zero, zero, m_11_23, m_11_24, m_11_25, zero, zero,
            zero, zero, zero, m_12_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, m_12_16, zero, zero, zero, m_12_20, m_12_21, m_12_22, zero,
            zero, zero, zero, zero, zero, zero, zero, m_13_1, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, m_13_11, zero, zero, zero, zero, m_13_16, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_14_1, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, m_14_12, zero, zero, zero, zero, m_14_17,
            m_14_18, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_15_1,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_15_13, zero, zero,
            zero, m_15_17, m_15_18, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, m_16_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_16_12,
            zero, m_16_14, zero, zero, m_16_17, m_16_18, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, m_17_1, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, m_17_11, zero, zero, zero, zero, m_17_16, zero, zero, m_17_19, m_17_20, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, m_18_15, m_18_16, zero, zero,
            m_18_19, m_18_20, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            x_rod4_frame_1_3, zero, zero, zero, zero, m_19_6, zero, zero, zero, zero, m_19_11, zero,
            m_19_13, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, m_20_1, zero, zero, zero, zero, zero, m_20_7, zero, zero, zero,
            zero, m_20_12, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, m_21_1, zero, zero, zero, zero, zero, zero, m_21_8,
            zero, zero, m_21_11, zero, m_21_13, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, m_22_9, zero, zero, m_22_12, zero, m_22_14, m_22_15, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_23_1, zero,
            zero, zero, zero, zero, zero, m_23_8, zero, m_23_10, m_23_11, zero, m_23_13, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, m_24_1, zero, zero, zero, zero, zero, m_24_7, zero, zero, zero, zero, m_24_12,
            zero, m_24_14, m_24_15, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, m_25_1, x_rod4_frame_in_rod5_frame_1_2, m_25_3,
            x_rod4_frame_in_rod5_frame_1_4, zero, m_25_6, m_25_7, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, m_26_1, m_26_2, x_rod4_frame_in_rod5_frame_2_3, m_26_4, zero,
            m_26_6, m_26_7, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_27_1, m_27_2,
            m_27_3, m_27_4, zero, zero, zero, m_27_8, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, m_28_1, m_28_2, m_28_3, m_28_4, x_rod4_frame_in_rod5_frame_1_8, zero, zero,
            m_28_8, m_28_9, m_28_10, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_29_2, m_29_3,
            m_29_4, m_29_5, zero, zero, m_29_8, m_29_9, m_29_10, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            m_30_1, m_30_2, m_30_3, m_30_4, m_30_5, m_30_6, m_30_7, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero,
        ],
        [
            f_1, f_2, zero, zero, zero, zero, f_7, f_8, f_9, f_10, f_11, f_12, f_13, f_14, f_15,
            f_16, f_17, f_18, f_19, f_20, f_21, f_22, f_23, f_24, f_25, f_26, f_27, f_28, f_29,
            f_30,
        ],
    )
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 1],
    direction: &[S; 6],
) -> [S; 6] {
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
            parameters: 3,
            coordinates: 5,
            variables: 1,
            speeds: 1,
            reactions: 29,
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
    fn linear_system(
        &self,
        p: &[S],
        q: &[S],
        v: &[S],
        matrix: &mut [S],
        forcing: &mut [S],
    ) {
        let (of_matrix, of_forcing) = linear_system(
            &Parameters::from_slice(p),
            array(q),
            array(v),
        );
        matrix.copy_from_slice(&of_matrix);
        forcing.copy_from_slice(&of_forcing);
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
        1
    }
    fn divisor_name(&self, at: usize) -> &str {
        ["divisor 1 of the accelerations"][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn constraint_count(&self) -> usize {
        4
    }
    fn constraint_name(&self, at: usize) -> &str {
        ["P6_1", "P6_2", "P6_3", "P6_turn13"][at]
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
