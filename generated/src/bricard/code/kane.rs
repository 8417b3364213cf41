//! Bricard's mechanism: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/bricard/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u_P1.
///
/// 566 operations, 5 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 1],
) -> [[S; 1]; 1] {
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
    let ratio_q_P2_u_P1_of_place = ratio_q_P2_u_P1_of_q_p4_q_p5_6
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
    let cos_q_p3_doubled = S::int(2) * cos_q_P3;
    let cos_q_p2_cos_q_p4 = cos_q_P2 * cos_q_P4;
    let ratio_q_P2_u_P1_of_place_2 = sin_q_P2
        * (-ratio_q_P2_u_P1_of_q_p4_q_p5_6)
            .mul_add(cos_q_p3_cos_q_p5, ratio_q_P2_u_P1_of_q_p4_q_p5_5 * sin_q_P3);
    let ratio_q_P2_u_P1_of_place_3 = ratio_q_P2_u_P1_of_q_p4_q_p5_2 * sin_q_P2;
    let cos_q_p2_sin_q_p3 = cos_q_P2 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_4 = cos_q_P1
        * (sin_q_P1
            * (ratio_q_P2_u_P1_of_q_p4_q_p5_5
                + cos_q_P2
                    * (cos_q_P2
                        * (ratio_q_P2_u_P1_of_q_p5
                            + sin_q_P4
                                * ratio_q_P2_u_P1_of_q_p4_q_p5
                                    .mul_add(S::int(2), ratio_q_P2_u_P1_of_q_p5)
                            + S::int(2) * ratio_q_P2_u_P1_of_q_p4_q_p5_3
                            + ratio_q_P2_u_P1_of_place * cos_q_P3)
                        - sin_q_p2_cos_q_p4
                            * ratio_q_P2_u_P1_of_q_p4_q_p5_10
                                .mul_add(
                                    cos_q_p3_cos_q_p5,
                                    ratio_q_P2_u_P1_of_q_p4_q_p5_9 * sin_q_P3,
                                )) - ratio_q_P2_u_P1_of_place * cos_q_p3_doubled)
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
    let J_rod5_frame_11 = m * l_sq;
    let mr_rod5_frame_2 = l * m;
    let rw_rod5_frame_2 = l * mr_rod5_frame_2;
    let J_rod5_frame_11_2 = rw_rod5_frame_2.mul_add(S::int(3), J_rod5_frame_11);
    let s_rod5_frame_in_rod4_frame_1 = mr_rod5_frame_2 * sin_q_P5;
    let s_rod5_frame_in_rod4_frame_2 = mr_rod5_frame_2 * cos_q_P5;
    let J_rod5_frame_in_rod4_frame = J_rod5_frame_11_2 * sin_q_P5;
    let J_rod5_frame_in_rod4_frame_2 = J_rod5_frame_in_rod4_frame * sin_q_P5;
    let J_rod5_frame_in_rod4_frame_11 = J_rod5_frame_11_2 - J_rod5_frame_in_rod4_frame_2;
    let J_rod5_frame_in_rod4_frame_12 = J_rod5_frame_in_rod4_frame * cos_q_P5;
    let s_rod4_frame_1 = mr_rod5_frame_2
        .mul_add(S::int(2), -s_rod5_frame_in_rod4_frame_1);
    let w_rod4_frame_1 = s_rod5_frame_in_rod4_frame_1 - s_rod4_frame_1;
    let rw_rod4_frame_1 = l * w_rod4_frame_1;
    let s_rod4_frame_1_2 = mr_rod5_frame_2 + s_rod4_frame_1;
    let l_times_6 = S::int(6) * l;
    let J_rod4_frame_12_of_place = s_rod5_frame_in_rod4_frame_2 * l_times_6;
    let J_rod4_frame_12 = J_rod5_frame_in_rod4_frame_12 - J_rod4_frame_12_of_place;
    let J_rod4_frame_22_of_place = (-rw_rod4_frame_1)
        .mul_add(S::int(6), J_rod5_frame_11_2);
    let J_rod4_frame_22 = J_rod5_frame_in_rod4_frame_2 + J_rod4_frame_22_of_place;
    let J_rod4_frame_33 = J_rod5_frame_11_2 + J_rod4_frame_22_of_place;
    let s_rod4_frame_in_rod3_frame_1 = s_rod4_frame_1_2 * cos_q_P4;
    let s_rod4_frame_in_rod3_frame_3 = s_rod4_frame_1_2 * sin_q_P4;
    let J_rod4_frame_in_rod3_frame_1 = J_rod4_frame_12 * cos_q_P4;
    let J_rod4_frame_in_rod3_frame_3 = J_rod4_frame_12 * sin_q_P4;
    let J_rod4_frame_in_rod3_frame_31 = J_rod5_frame_in_rod4_frame_11 - J_rod4_frame_33;
    let J_rod4_frame_in_rod3_frame = J_rod4_frame_in_rod3_frame_31 * sin_q_P4;
    let J_rod4_frame_in_rod3_frame_2 = J_rod4_frame_in_rod3_frame * sin_q_P4;
    let J_rod4_frame_in_rod3_frame_11 = J_rod5_frame_in_rod4_frame_11
        - J_rod4_frame_in_rod3_frame_2;
    let J_rod4_frame_in_rod3_frame_13 = J_rod4_frame_in_rod3_frame * cos_q_P4;
    let J_rod4_frame_in_rod3_frame_33 = J_rod4_frame_33 + J_rod4_frame_in_rod3_frame_2;
    let s_rod3_frame_3 = mr_rod5_frame_2
        .mul_add(S::int(4), s_rod4_frame_in_rod3_frame_3);
    let w_rod3_frame_3 = s_rod4_frame_in_rod3_frame_3 + s_rod3_frame_3;
    let rw_rod3_frame_3 = l * w_rod3_frame_3;
    let s_rod3_frame_3_2 = mr_rod5_frame_2 + s_rod3_frame_3;
    let J_rod3_frame_11_of_place = rw_rod3_frame_3.mul_add(S::int(6), J_rod5_frame_11_2);
    let J_rod3_frame_11 = J_rod4_frame_in_rod3_frame_11 + J_rod3_frame_11_of_place;
    let J_rod3_frame_13_of_place = s_rod4_frame_in_rod3_frame_1 * l_times_6;
    let J_rod3_frame_13 = J_rod4_frame_in_rod3_frame_13 - J_rod3_frame_13_of_place;
    let J_rod3_frame_22 = J_rod4_frame_22 + J_rod3_frame_11_of_place;
    let J_rod3_frame_23 = J_rod4_frame_12_of_place - J_rod4_frame_in_rod3_frame_3;
    let s_rod3_frame_in_rod2_frame_2 = s_rod3_frame_3_2
        .mul_add(sin_q_P3, s_rod5_frame_in_rod4_frame_2 * cos_q_P3);
    let s_rod3_frame_in_rod2_frame_3 = (-s_rod3_frame_3_2)
        .mul_add(cos_q_P3, s_rod5_frame_in_rod4_frame_2 * sin_q_P3);
    let J_rod3_frame_in_rod2_frame_2 = J_rod3_frame_13
        .mul_add(sin_q_P3, J_rod4_frame_in_rod3_frame_1 * cos_q_P3);
    let J_rod3_frame_in_rod2_frame_3 = (-J_rod3_frame_13)
        .mul_add(cos_q_P3, J_rod4_frame_in_rod3_frame_1 * sin_q_P3);
    let J_rod3_frame_in_rod2_frame_23 = J_rod4_frame_in_rod3_frame_33 - J_rod3_frame_22;
    let J_rod3_frame_in_rod2_frame = (-J_rod3_frame_23)
        .mul_add(cos_q_p3_doubled, J_rod3_frame_in_rod2_frame_23 * sin_q_P3);
    let J_rod3_frame_in_rod2_frame_2_ = J_rod3_frame_in_rod2_frame * sin_q_P3;
    let J_rod3_frame_in_rod2_frame_22 = J_rod3_frame_22 + J_rod3_frame_in_rod2_frame_2_;
    let J_rod3_frame_in_rod2_frame_23_2 = J_rod3_frame_in_rod2_frame
        .mul_add(cos_q_P3, J_rod3_frame_23);
    let J_rod3_frame_in_rod2_frame_33 = J_rod4_frame_in_rod3_frame_33
        - J_rod3_frame_in_rod2_frame_2_;
    let s_rod2_frame_2 = mr_rod5_frame_2
        .mul_add(S::int(6), -s_rod3_frame_in_rod2_frame_2);
    let w_rod2_frame_2 = s_rod3_frame_in_rod2_frame_2 - s_rod2_frame_2;
    let rw_rod2_frame_2 = l * w_rod2_frame_2;
    let s_rod2_frame_2_2 = mr_rod5_frame_2 + s_rod2_frame_2;
    let J_rod2_frame_11_of_place = (-rw_rod2_frame_2)
        .mul_add(S::int(6), J_rod5_frame_11_2);
    let J_rod2_frame_11 = J_rod3_frame_11 + J_rod2_frame_11_of_place;
    let J_rod2_frame_12 = J_rod3_frame_in_rod2_frame_2 + J_rod3_frame_13_of_place;
    let J_rod2_frame_23 = (-s_rod3_frame_in_rod2_frame_3)
        .mul_add(l_times_6, J_rod3_frame_in_rod2_frame_23_2);
    let J_rod2_frame_33 = J_rod3_frame_in_rod2_frame_33 + J_rod2_frame_11_of_place;
    let s_rod2_frame_in_rod1_frame_1 = s_rod2_frame_2_2
        .mul_add(sin_q_P2, s_rod4_frame_in_rod3_frame_1 * cos_q_P2);
    let J_rod2_frame_in_rod1_frame_2 = (-J_rod2_frame_23)
        .mul_add(cos_q_P2, J_rod3_frame_in_rod2_frame_3 * sin_q_P2);
    let J_rod2_frame_in_rod1_frame_12 = J_rod3_frame_in_rod2_frame_22 - J_rod2_frame_11;
    let J_rod2_frame_in_rod1_frame = (-(J_rod2_frame_12 * cos_q_P2))
        .mul_add(S::int(2), J_rod2_frame_in_rod1_frame_12 * sin_q_P2);
    let J_rod2_frame_in_rod1_frame_2_ = J_rod2_frame_in_rod1_frame * sin_q_P2;
    let J_rod2_frame_in_rod1_frame_22 = J_rod3_frame_in_rod2_frame_22
        - J_rod2_frame_in_rod1_frame_2_;
    let s_rod1_frame_1 = mr_rod5_frame_2
        .mul_add(S::int(8), -s_rod2_frame_in_rod1_frame_1);
    let w_rod1_frame_1 = s_rod2_frame_in_rod1_frame_1 - s_rod1_frame_1;
    let rw_rod1_frame_1 = l * w_rod1_frame_1;
    let J_rod1_frame_22 = (-rw_rod1_frame_1)
        .mul_add(S::int(6), J_rod5_frame_11_2 + J_rod2_frame_in_rod1_frame_22);
    let h_rod3_frame_rod2_frame_1_of_place = s_rod3_frame_in_rod2_frame_2 * l_times_6;
    let h_rod3_frame_rod2_frame_1 = J_rod3_frame_11 - h_rod3_frame_rod2_frame_1_of_place;
    let h_rod3_frame_in_rod2_frame_2 = h_rod3_frame_rod2_frame_1
        .mul_add(sin_q_P2, J_rod3_frame_in_rod2_frame_2 * cos_q_P2);
    let h_rod3_frame_rod1_frame_2 = h_rod3_frame_in_rod2_frame_2
        + h_rod3_frame_rod2_frame_1_of_place;
    let h_rod4_frame_rod3_frame_2_of_place = s_rod4_frame_in_rod3_frame_3 * l_times_6;
    let h_rod4_frame_rod3_frame_2 = J_rod4_frame_22 + h_rod4_frame_rod3_frame_2_of_place;
    let p_rod4_frame_in_rod3_frame_3 = s_rod4_frame_in_rod3_frame_1 * cos_q_P3;
    let h_rod4_frame_in_rod3_frame_2 = h_rod4_frame_rod3_frame_2
        .mul_add(cos_q_P3, J_rod4_frame_in_rod3_frame_3 * sin_q_P3);
    let h_rod4_frame_in_rod3_frame_3 = (-J_rod4_frame_in_rod3_frame_3)
        .mul_add(cos_q_P3, h_rod4_frame_rod3_frame_2 * sin_q_P3);
    let h_rod4_frame_rod2_frame_1_of_place = p_rod4_frame_in_rod3_frame_3 * l_times_6;
    let h_rod4_frame_rod2_frame_1 = J_rod4_frame_in_rod3_frame_1
        + h_rod4_frame_rod2_frame_1_of_place;
    let h_rod4_frame_rod2_frame_3 = h_rod4_frame_rod3_frame_2_of_place
        - h_rod4_frame_in_rod3_frame_3;
    let h_rod4_frame_in_rod2_frame_2 = h_rod4_frame_rod2_frame_1
        .mul_add(sin_q_P2, h_rod4_frame_in_rod3_frame_2 * cos_q_P2);
    let h_rod4_frame_rod1_frame_2 = h_rod4_frame_rod2_frame_1_of_place
        - h_rod4_frame_in_rod2_frame_2;
    let h_rod5_frame_rod4_frame_3_of_place = s_rod5_frame_in_rod4_frame_1 * l_times_6;
    let h_rod5_frame_rod4_frame_3 = J_rod5_frame_11_2 - h_rod5_frame_rod4_frame_3_of_place;
    let p_rod5_frame_in_rod4_frame_1 = s_rod5_frame_in_rod4_frame_2 * cos_q_P4;
    let p_rod5_frame_in_rod4_frame_3 = s_rod5_frame_in_rod4_frame_2 * sin_q_P4;
    let h_rod5_frame_in_rod4_frame_1 = h_rod5_frame_rod4_frame_3 * sin_q_P4;
    let h_rod5_frame_in_rod4_frame_3 = h_rod5_frame_rod4_frame_3 * cos_q_P4;
    let h_rod5_frame_rod3_frame_1 = h_rod5_frame_rod4_frame_3_of_place
        - h_rod5_frame_in_rod4_frame_1;
    let h_rod5_frame_rod3_frame_2 = l * p_rod5_frame_in_rod4_frame_1;
    let p_rod5_frame_in_rod3_frame_3 = (-p_rod5_frame_in_rod4_frame_3)
        .mul_add(cos_q_P3, s_rod5_frame_in_rod4_frame_1 * sin_q_P3);
    let h_rod5_frame_in_rod3_frame_2_of_place = S::int(6) * h_rod5_frame_rod3_frame_2;
    let h_rod5_frame_in_rod3_frame_2 = (-h_rod5_frame_in_rod4_frame_3)
        .mul_add(sin_q_P3, h_rod5_frame_in_rod3_frame_2_of_place * cos_q_P3);
    let h_rod5_frame_in_rod3_frame_3 = h_rod5_frame_in_rod3_frame_2_of_place
        .mul_add(sin_q_P3, h_rod5_frame_in_rod4_frame_3 * cos_q_P3);
    let h_rod5_frame_rod2_frame_1_of_place = p_rod5_frame_in_rod3_frame_3 * l_times_6;
    let h_rod5_frame_rod2_frame_1 = h_rod5_frame_rod3_frame_1 - h_rod5_frame_rod2_frame_1_of_place;
    let h_rod5_frame_rod2_frame_3 = p_rod5_frame_in_rod4_frame_1
        .mul_add(l_times_6, -h_rod5_frame_in_rod3_frame_3);
    let h_rod5_frame_in_rod2_frame_2 = (-h_rod5_frame_in_rod3_frame_2)
        .mul_add(cos_q_P2, h_rod5_frame_rod2_frame_1 * sin_q_P2);
    let h_rod5_frame_rod1_frame_2 = h_rod5_frame_in_rod2_frame_2
        + h_rod5_frame_rod2_frame_1_of_place;
    let ratio_q_p4_u_p1_doubled = S::int(2) * ratio_q_P4_u_P1;
    let ratio_q_p5_u_p1_doubled = S::int(2) * ratio_q_P5_u_P1;
    let m11_of_place = ratio_q_P3_u_P1
        .mul_add(J_rod3_frame_in_rod2_frame_3, J_rod2_frame_in_rod1_frame_2);
    let m11_of_place_2 = J_rod1_frame_22
        + ratio_q_P2_u_P1
            * (h_rod4_frame_rod2_frame_3
                .mul_add(ratio_q_p4_u_p1_doubled, ratio_q_P2_u_P1 * J_rod2_frame_33)
                + h_rod5_frame_rod2_frame_3 * ratio_q_p5_u_p1_doubled + S::int(2) * m11_of_place);
    let m11_of_place_3 = ratio_q_P4_u_P1
        * h_rod4_frame_rod1_frame_2.mul_add(S::int(2), ratio_q_P4_u_P1 * J_rod4_frame_22)
        + ratio_q_P3_u_P1
            * (h_rod3_frame_rod1_frame_2
                .mul_add(S::int(2), ratio_q_P3_u_P1 * J_rod3_frame_11)
                - J_rod4_frame_in_rod3_frame_1 * ratio_q_p4_u_p1_doubled
                + h_rod5_frame_rod3_frame_1 * ratio_q_p5_u_p1_doubled);
    let m11_of_place_4 = ratio_q_P5_u_P1
        * h_rod5_frame_rod1_frame_2
            .mul_add(S::int(2), ratio_q_P5_u_P1 * J_rod5_frame_11_2) + m11_of_place_2;
    let m11_of_place_5 = m11_of_place_3 + m11_of_place_4;
    // Entries that are not zero; upper triangle.
    let m11 = S::ratio(1, 12) * m11_of_place_5;
    [[m11]]
}

/// Right-hand side of the linear system; unknowns (u_P1').
///
/// 1524 operations, 5 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 1]) -> [S; 1] {
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
    let ratio_q_P2_u_P1_of_place_20 = ratio_q_P2_u_P1_of_place_6 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_21 = sin_q_p2_sin_q_p1
        .mul_add(ratio_q_P2_u_P1_of_place_19, ratio_q_P2_u_P1_of_place_20);
    let ratio_q_P2_u_P1_of_place_22 = ratio_q_P2_u_P1_of_place_16 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_23 = (-ratio_q_P2_u_P1_of_place_8)
        .mul_add(
            ratio_q_P2_u_P1_of_place_21,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_22,
        );
    let ratio_q_P2_u_P1_of_place_24 = ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_25 = ratio_q_P2_u_P1_of_q_p3_q_p5
        .mul_add(sin_q_p2_cos_q_p4, ratio_q_P2_u_P1_of_place_24);
    let cos_q_p3_sin_q_p1 = sin_q_P1 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_26 = cos_q_p3_sin_q_p1 * cos_q_P4;
    let ratio_q_P2_u_P1_of_place_27 = l
        * ratio_q_P2_u_P1_of_q_p5_2
            .mul_add(
                ratio_q_P2_u_P1_of_place_26,
                ratio_q_P2_u_P1_of_place_25 * cos_q_P1,
            );
    let ratio_q_P2_u_P1_of_place_28 = l * ratio_q_P2_u_P1_of_place_12;
    let ratio_q_P2_u_P1_of_place_29 = l * ratio_q_P2_u_P1_of_place;
    let ratio_q_P2_u_P1_of_place_30 = ratio_q_P2_u_P1_of_place_21
        .mul_add(
            ratio_q_P2_u_P1_of_place_29,
            ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_of_place_28,
        );
    let ratio_q_P2_u_P1_of_place_31 = (-ratio_q_P2_u_P1_of_place_6)
        .mul_add(sin_q_P2, cos_q_p2_cos_q_p4 * cos_q_P5);
    let ratio_q_P2_u_P1_of_place_32 = l
        * (-ratio_q_P2_u_P1_of_place_31)
            .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_19 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_33 = (-ratio_q_P2_u_P1_of_place_23)
        .mul_add(
            ratio_q_P2_u_P1_of_place_27,
            ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_of_place_18,
        ) - ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_of_place_32;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_2 = S::int(1) - cos_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_34 = -ratio_q_P2_u_P1_of_place_14 - ratio_q_P2_u_P1_of_q_p3_q_p5_2;
    let ratio_q_P2_u_P1_of_place_35 = ratio_q_P2_u_P1_of_place_34
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p2_cos_q_p4);
    let ratio_q_P2_u_P1_of_place_36 = S::int(1) + ratio_q_P2_u_P1_of_place_35;
    let ratio_q_P2_u_P1_of_place_37 = (-ratio_q_P2_u_P1_of_place_16)
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_36 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_38 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_of_place_10, ratio_q_P2_u_P1_of_place_25 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_39 = ratio_q_P2_u_P1_of_place_31
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_19 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_40 = (-ratio_q_P2_u_P1_of_place_28)
        .mul_add(
            ratio_q_P2_u_P1_of_place_39,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_38,
        );
    let ratio_q_P2_u_P1_of_place_41 = l * ratio_q_P2_u_P1_of_place_35;
    let ratio_q_P2_u_P1_of_place_42 = ratio_q_P2_u_P1_of_q_p5_2 * sin_q_p2_cos_q_p4;
    let ratio_q_P2_u_P1_of_place_43 = ratio_q_P2_u_P1_of_place_34
        .mul_add(cos_q_P2, -ratio_q_P2_u_P1_of_place_42);
    let ratio_q_P2_u_P1_of_place_44 = ratio_q_P2_u_P1_of_place_8 * sin_q_P1;
    let ratio_q_P2_u_P1_of_place_45 = (-ratio_q_P2_u_P1_of_place_39)
        .mul_add(
            ratio_q_P2_u_P1_of_place_44,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_43 * sin_q_P1,
        );
    let cos_q_p2_sin_q_p1 = sin_q_P1 * cos_q_P2;
    let ratio_q_P2_u_P1_of_q_p3 = sin_q_P3 - S::int(1);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_3 = ratio_q_P2_u_P1_of_q_p5_2 * cos_q_P3;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_4 = (-ratio_q_P2_u_P1_of_q_p3)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_q_p3_q_p5_3);
    let ratio_q_P2_u_P1_of_place_46 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_q_p3_q_p5 * sin_q_p2_sin_q_p1);
    let ratio_q_P2_u_P1_of_place_47 = ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_p2_sin_q_p1;
    let ratio_q_P2_u_P1_of_place_48 = ratio_q_P2_u_P1_of_place_46
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_47);
    let ratio_q_P2_u_P1_of_place_49 = sin_q_p2_cos_q_p4
        .mul_add(ratio_q_P2_u_P1_of_q_p3, cos_q_p2_sin_q_p4);
    let ratio_q_P2_u_P1_of_place_50 = (-ratio_q_P2_u_P1_of_place_49)
        .mul_add(sin_q_P3, cos_q_p2_sin_q_p4);
    let cos_q_p5_sin_q_p1 = sin_q_P1 * cos_q_P5;
    let l_sq = l * l;
    let ratio_q_P2_u_P1_of_place_51 = l_sq
        * ratio_q_P2_u_P1_of_place_50
            .mul_add(cos_q_p5_sin_q_p1, ratio_q_P2_u_P1_of_place_48 * cos_q_P3);
    let ratio_q_P2_u_P1_of_place_52 = cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_of_place_51;
    let ratio_q_P2_u_P1_of_place_53 = ratio_q_P2_u_P1_of_place_29
        .mul_add(
            ratio_q_P2_u_P1_of_place_45,
            ratio_q_P2_u_P1_of_place_40 * ratio_q_P2_u_P1_of_place_41,
        ) + ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_52;
    let ratio_q_P2_u_P1_of_q_p4 = S::int(1) + sin_q_P4;
    let cos_q_p4_sq = cos_q_P4 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_2 = ratio_q_P2_u_P1_of_q_p4 - cos_q_p4_sq;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_3 = ratio_q_P2_u_P1_of_q_p4_2
        .mul_add(sin_q_P5, cos_q_p4_sq);
    let ratio_q_P2_u_P1_of_place_54 = ratio_q_P2_u_P1_of_q_p4_q_p5_3 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_55 = (-cos_q_p3_cos_q_p5)
        .mul_add(ratio_q_P2_u_P1_of_q_p4, ratio_q_P2_u_P1_of_place_54);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_4 = sin_q_P5 + ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_place_56 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p4_q_p5_4;
    let ratio_q_P2_u_P1_of_place_57 = ratio_q_P2_u_P1_of_place_55
        .mul_add(sin_q_P2, -ratio_q_P2_u_P1_of_place_56);
    let ratio_q_P2_u_P1_of_place_58 = ratio_q_P2_u_P1_of_q_p4_q_p5_3 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_59 = sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_of_q_p4;
    let ratio_q_P2_u_P1_of_place_60 = ratio_q_P2_u_P1_of_place_59
        .mul_add(S::int(2), ratio_q_P2_u_P1_of_place_58);
    let ratio_q_P2_u_P1_of_place_61 = (-ratio_q_P2_u_P1_of_place_60)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_57 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_62 = ratio_q_P2_u_P1_of_place_61
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_of_place_54);
    let ratio_q_P2_u_P1_of_place_63 = (-sin_q_p3_cos_q_p1)
        .mul_add(ratio_q_P2_u_P1_of_place_56, ratio_q_P2_u_P1_of_place_62 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_64 = ratio_q_P2_u_P1_of_place_58 + ratio_q_P2_u_P1_of_place_59;
    let ratio_q_P2_u_P1_of_place_65 = ratio_q_P2_u_P1_of_place_64 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_66 = (-sin_q_p3_cos_q_p1)
        .mul_add(ratio_q_P2_u_P1_of_place_65, ratio_q_P2_u_P1_of_place_63 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_67 = ratio_q_P2_u_P1_of_place_35 * l_sq;
    let ratio_q_P2_u_P1_of_place_68 = l * ratio_q_P2_u_P1_of_place_22;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_5 = cos_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_place_69 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_5)
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_q_p3 * sin_q_P5);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_6 = ratio_q_P2_u_P1_of_q_p3_q_p5 + cos_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_70 = (-sin_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_of_q_p3_q_p5_6, ratio_q_P2_u_P1_of_place_69 * cos_q_P2);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_7 = sin_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_3;
    let ratio_q_P2_u_P1_of_place_71 = ratio_q_P2_u_P1_of_q_p3_q_p5_7 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_72 = (-ratio_q_P2_u_P1_of_place_71)
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_70 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_73 = (-ratio_q_P2_u_P1_of_place_20)
        .mul_add(cos_q_P2, ratio_q_P2_u_P1_of_place_72 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_74 = l_sq * ratio_q_P2_u_P1_of_place_73 * sin_q_P1;
    let ratio_q_P2_u_P1_of_place_75 = ratio_q_P2_u_P1_of_place_45
        .mul_add(
            ratio_q_P2_u_P1_of_place_68,
            ratio_q_P2_u_P1_of_place_66 * ratio_q_P2_u_P1_of_place_67,
        ) - ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_74;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_8 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_3)
        .mul_add(S::int(2), sin_q_p3_cos_q_p5);
    let ratio_q_P2_u_P1_of_place_76 = ratio_q_P2_u_P1_of_q_p3_q_p5_8
        .mul_add(cos_q_P1, sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_of_q_p3_q_p5_6);
    let ratio_q_P2_u_P1_of_place_77 = ratio_q_P2_u_P1_of_place_76
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_47);
    let ratio_q_P2_u_P1_of_place_78 = (-cos_q_p2_sin_q_p1)
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_place_10);
    let ratio_q_P2_u_P1_of_place_79 = (-cos_q_p3_cos_q_p5)
        .mul_add(ratio_q_P2_u_P1_of_place_78, ratio_q_P2_u_P1_of_place_77 * sin_q_P3);
    let ratio_q_P2_u_P1_of_place_80 = ratio_q_P2_u_P1_of_place_79
        .mul_add(sin_q_P2, cos_q_p2_sin_q_p4 * ratio_q_P2_u_P1_of_place_71);
    let ratio_q_P2_u_P1_of_place_81 = (-ratio_q_P2_u_P1_of_place_10)
        .mul_add(ratio_q_P2_u_P1_of_place_71, ratio_q_P2_u_P1_of_place_80 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_82 = ratio_q_P2_u_P1_of_place
        .mul_add(
            ratio_q_P2_u_P1_of_place_74,
            ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_of_place_52,
        ) + ratio_q_P2_u_P1_of_place_67 * ratio_q_P2_u_P1_of_place_81;
    let ratio_q_P2_u_P1_of_place_83 = l * ratio_q_P2_u_P1_of_place_43;
    let ratio_q_P2_u_P1_of_place_84 = ratio_q_P2_u_P1_of_place_83 * cos_q_P1;
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
    let ratio_q_P2_u_P1_of_place_85 = sin_q_p3_cos_q_p5
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_11,
            ratio_q_P2_u_P1_of_q_p4_q_p5_10 * cos_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_86 = ratio_q_P2_u_P1_of_place_85 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_87 = ratio_q_P2_u_P1_of_q_p4_q_p5_6
        .mul_add(sin_q_P4, -ratio_q_P2_u_P1_of_q_p5)
        - ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p4_sq_doubled - ratio_q_P2_u_P1_of_place_86;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_12 = S::int(2) * ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_13 = (-ratio_q_P2_u_P1_of_q_p5)
        .mul_add(S::int(3), cos_q_p5_sq) - ratio_q_P2_u_P1_of_q_p4_q_p5_5
        + ratio_q_P2_u_P1_of_q_p4_q_p5_12;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_14 = ratio_q_P2_u_P1_of_q_p4_q_p5_12 - ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_place_88 = cos_q_p3_cos_q_p5
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_14,
            ratio_q_P2_u_P1_of_q_p4_q_p5_13 * sin_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_89 = sin_q_p2_cos_q_p4
        .mul_add(ratio_q_P2_u_P1_of_place_88, ratio_q_P2_u_P1_of_place_87 * cos_q_P2);
    let ratio_q_P2_u_P1_of_place_90 = (-ratio_q_P2_u_P1_of_place_86)
        .mul_add(S::int(2), ratio_q_P2_u_P1_of_q_p4_q_p5_10)
        - ratio_q_P2_u_P1_of_place_89 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_91 = (-cos_q_p3_cos_q_p5)
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_11,
            ratio_q_P2_u_P1_of_q_p4_q_p5_10 * sin_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_92 = ratio_q_P2_u_P1_of_place_91 * sin_q_P2;
    let ratio_q_P2_u_P1_of_place_93 = (-cos_q_p2_cos_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_13,
            S::int(2) * ratio_q_P2_u_P1_of_place_92,
        );
    let ratio_q_P2_u_P1_of_place_94 = cos_q_p2_cos_q_p4 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_95 = ratio_q_P2_u_P1_of_q_p4_q_p5_14
        .mul_add(
            ratio_q_P2_u_P1_of_place_94,
            ratio_q_P2_u_P1_of_q_p4_q_p5_11 * sin_q_P2,
        );
    let ratio_q_P2_u_P1_of_place_96 = ratio_q_P2_u_P1_of_place_95
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_93 * cos_q_P3);
    let ratio_q_P2_u_P1_of_place_97 = (-ratio_q_P2_u_P1_of_place_96)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_90 * sin_q_P1);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_15 = ratio_q_P2_u_P1_of_q_p4_q_p5
        - ratio_q_P2_u_P1_of_q_p5_3 - ratio_q_P2_u_P1_of_q_p4_q_p5_7;
    let ratio_q_P2_u_P1_of_place_98 = (-cos_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_of_q_p4_q_p5_15, ratio_q_P2_u_P1_of_place_92);
    let ratio_q_P2_u_P1_of_place_99 = ratio_q_P2_u_P1_of_place_24
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_place_42);
    let cos_q_p4_cos_q_p5 = cos_q_P4 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_100 = ratio_q_P2_u_P1_of_place_98
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_of_place_97 * cos_q_P1)
        + ratio_q_P2_u_P1_of_place_99 * cos_q_p4_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_101 = l_sq * ratio_q_P2_u_P1_of_place_100;
    let ratio_q_P2_u_P1_of_place_102 = S::int(1)
        / ((-ratio_q_P2_u_P1_of_place_18)
            .mul_add(
                ratio_q_P2_u_P1_of_place_53,
                ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_of_place_75,
            ) + ratio_q_P2_u_P1_of_place_32 * ratio_q_P2_u_P1_of_place_82
            + ratio_q_P2_u_P1_of_place_84 * ratio_q_P2_u_P1_of_place_101);
    let ratio_q_P2_u_P1_of_place_103 = l * ratio_q_P2_u_P1_of_place_102;
    let ratio_q_P2_u_P1_of_place_104 = ratio_q_P2_u_P1_of_place_37 * ratio_q_P2_u_P1_of_place_103;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_16 = ratio_q_P2_u_P1_of_q_p4_q_p5 - ratio_q_P2_u_P1_of_q_p5;
    let sin_q_p3_sin_q_p1 = sin_q_P1 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_105 = (-cos_q_p3_cos_q_p1)
        .mul_add(sin_q_P2, sin_q_p3_sin_q_p1);
    let ratio_q_P2_u_P1_of_place_106 = cos_q_p3_sin_q_p1
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_place_3 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_107 = (-ratio_q_P2_u_P1_of_place_106)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_105 * sin_q_P5);
    let ratio_q_P2_u_P1_of_place_108 = l_sq * ratio_q_P2_u_P1_of_place_103;
    let ratio_q_P2_u_P1_of_place_109 = ratio_q_P2_u_P1_of_place_107 * ratio_q_P2_u_P1_of_place_108;
    let ratio_q_P2_u_P1_of_place_110 = ratio_q_P2_u_P1_of_place_109 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_111 = ratio_q_P2_u_P1_of_place_36
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_17);
    let ratio_q_P2_u_P1_of_place_112 = ratio_q_P2_u_P1_of_place_100 * ratio_q_P2_u_P1_of_place_108;
    let ratio_q_P2_u_P1 = ratio_q_P2_u_P1_of_q_p4_q_p5_16
        .mul_add(
            ratio_q_P2_u_P1_of_place_110,
            ratio_q_P2_u_P1_of_place_33 * ratio_q_P2_u_P1_of_place_104,
        ) + ratio_q_P2_u_P1_of_place_111 * ratio_q_P2_u_P1_of_place_112;
    let ratio_q_P3_u_P1_of_place = (-ratio_q_P2_u_P1_of_place_7)
        .mul_add(
            ratio_q_P2_u_P1_of_place_44,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_35,
        );
    let ratio_q_P3_u_P1_of_place_2 = ratio_q_P2_u_P1_of_place
        .mul_add(
            ratio_q_P2_u_P1_of_place_44,
            ratio_q_P2_u_P1_of_place_12 * ratio_q_P2_u_P1_of_place_41,
        );
    let ratio_q_P3_u_P1_of_place_3 = ratio_q_P2_u_P1_of_place_27
        .mul_add(
            ratio_q_P3_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_of_place_84,
        ) + ratio_q_P2_u_P1_of_place_32 * ratio_q_P3_u_P1_of_place_2;
    let ratio_q_P3_u_P1_of_place_4 = ratio_q_P2_u_P1_of_place_103 * ratio_q_P2_u_P1_of_place_111;
    let ratio_q_P3_u_P1_of_q_p3_q_p5 = ratio_q_P2_u_P1_of_q_p3_q_p5_4
        .mul_add(cos_q_P5, -ratio_q_P2_u_P1_of_q_p5) - ratio_q_P2_u_P1_of_q_p3_q_p5;
    let ratio_q_P3_u_P1_of_place_5 = ratio_q_P2_u_P1_of_place_109 * cos_q_P4;
    let ratio_q_P3_u_P1 = ratio_q_P2_u_P1_of_place_53
        .mul_add(
            ratio_q_P3_u_P1_of_place_4,
            ratio_q_P2_u_P1_of_place_104 * ratio_q_P3_u_P1_of_place_3,
        ) - ratio_q_P3_u_P1_of_q_p3_q_p5 * ratio_q_P3_u_P1_of_place_5;
    let ratio_q_P4_u_P1_of_place = ratio_q_P2_u_P1_of_place_16 * cos_q_p2_sin_q_p1;
    let ratio_q_P4_u_P1_of_place_2 = (-ratio_q_P2_u_P1_of_place_8)
        .mul_add(
            ratio_q_P4_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_of_place_41,
        );
    let ratio_q_P4_u_P1_of_place_3 = ratio_q_P2_u_P1_of_place_18
        .mul_add(
            ratio_q_P3_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_23 * ratio_q_P2_u_P1_of_place_84,
        ) - ratio_q_P2_u_P1_of_place_32 * ratio_q_P4_u_P1_of_place_2;
    let ratio_q_P4_u_P1_of_q_p4_q_p5 = ratio_q_P2_u_P1_of_q_p4_q_p5_4 - S::int(2);
    let ratio_q_P4_u_P1_of_place_4 = (-ratio_q_P4_u_P1_of_q_p4_q_p5)
        .mul_add(
            sin_q_P3,
            ratio_q_P2_u_P1_of_q_p4_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_2,
        );
    let ratio_q_P4_u_P1_of_place_5 = ratio_q_P4_u_P1_of_place_4
        .mul_add(sin_q_P4, sin_q_P3 - sin_q_P5 + cos_q_p3_cos_q_p5);
    let ratio_q_P4_u_P1 = ratio_q_P2_u_P1_of_place_104
        .mul_add(
            ratio_q_P4_u_P1_of_place_3,
            ratio_q_P2_u_P1_of_place_75 * ratio_q_P3_u_P1_of_place_4,
        ) - ratio_q_P2_u_P1_of_place_110 * ratio_q_P4_u_P1_of_place_5;
    let ratio_q_P5_u_P1_of_place = ratio_q_P2_u_P1_of_place_18
        .mul_add(
            ratio_q_P3_u_P1_of_place_2,
            ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_of_place_84,
        ) + ratio_q_P2_u_P1_of_place_27 * ratio_q_P4_u_P1_of_place_2;
    let ratio_q_P5_u_P1_of_q_p3_q_p5 = (-ratio_q_P2_u_P1_of_q_p5_4)
        .mul_add(sin_q_P3, -ratio_q_P2_u_P1_of_q_p5_3);
    let ratio_q_P5_u_P1_of_q_p3_q_p5_2 = sin_q_P3 - ratio_q_P2_u_P1_of_q_p3_q_p5_2;
    let ratio_q_P5_u_P1_of_place_2 = ratio_q_P2_u_P1_of_q_p5
        .mul_add(
            ratio_q_P5_u_P1_of_q_p3_q_p5_2,
            ratio_q_P5_u_P1_of_q_p3_q_p5 * sin_q_P4,
        );
    let ratio_q_P5_u_P1 = ratio_q_P2_u_P1_of_place_104
        .mul_add(
            ratio_q_P5_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_82 * ratio_q_P3_u_P1_of_place_4,
        ) - ratio_q_P3_u_P1_of_place_5 * ratio_q_P5_u_P1_of_place_2;
    let w_rod1_frame_in_rod2_frame_1 = u_P1 * sin_q_P2;
    let w_rod1_frame_in_rod2_frame_2 = u_P1 * cos_q_P2;
    let w_rod2_frame_3 = u_P1 * ratio_q_P2_u_P1;
    let sin_q_p3_w_rod2_frame_3 = w_rod2_frame_3 * sin_q_P3;
    let w_rod2_frame_in_rod3_frame_2 = w_rod1_frame_in_rod2_frame_2
        .mul_add(cos_q_P3, sin_q_p3_w_rod2_frame_3);
    let cos_q_p3_w_rod2_frame_3 = w_rod2_frame_3 * cos_q_P3;
    let w_rod2_frame_in_rod3_frame_3 = w_rod1_frame_in_rod2_frame_2
        .mul_add(sin_q_P3, -cos_q_p3_w_rod2_frame_3);
    let u_p1_ratio_q_p3_u_p1 = u_P1 * ratio_q_P3_u_P1;
    let w_rod3_frame_1 = w_rod1_frame_in_rod2_frame_1 + u_p1_ratio_q_p3_u_p1;
    let w_rod3_frame_in_rod4_frame_1 = w_rod3_frame_1
        .mul_add(cos_q_P4, w_rod2_frame_in_rod3_frame_3 * sin_q_P4);
    let w_rod3_frame_in_rod4_frame_3 = (-w_rod3_frame_1)
        .mul_add(sin_q_P4, w_rod2_frame_in_rod3_frame_3 * cos_q_P4);
    let u_p1_ratio_q_p4_u_p1 = u_P1 * ratio_q_P4_u_P1;
    let w_rod4_frame_2 = u_p1_ratio_q_p4_u_p1 - w_rod2_frame_in_rod3_frame_2;
    let w_rod4_frame_in_rod5_frame_1 = (-w_rod4_frame_2)
        .mul_add(sin_q_P5, w_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let w_rod4_frame_in_rod5_frame_2 = w_rod4_frame_2
        .mul_add(cos_q_P5, w_rod3_frame_in_rod4_frame_1 * sin_q_P5);
    let u_p1_ratio_q_p5_u_p1 = u_P1 * ratio_q_P5_u_P1;
    let w_rod5_frame_3 = w_rod3_frame_in_rod4_frame_3 + u_p1_ratio_q_p5_u_p1;
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
    let ratio_q_P2_u_P1_2_of_u_p1_6 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_12)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_3, cos_q_p4_sq * ratio_q_P2_u_P1_2_of_u_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_7 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_8 = ratio_q_P2_u_P1_2_of_u_p1_7 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_9 = ratio_q_P2_u_P1_2_of_u_p1_8 - ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_10 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_5;
    let ratio_q_P2_u_P1_2_of_u_p1_11 = sin_q_P4
        * (ratio_q_P2_u_P1_2_of_u_p1_10 - ratio_q_P2_u_P1_2_of_u_p1_9)
        + ratio_q_P2_u_P1_of_q_p4_q_p5_8 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_12 = ratio_q_P2_u_P1_2_of_u_p1_6 + ratio_q_P2_u_P1_2_of_u_p1_9;
    let ratio_q_P2_u_P1_2_of_u_p1_13 = ratio_q_P2_u_P1_2_of_u_p1_11 - ratio_q_P2_u_P1_2_of_u_p1_12;
    let ratio_q_P2_u_P1_2_of_u_p1_14 = u_p1_ratio_q_p5_u_p1 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_15 = u_p1_ratio_q_p3_u_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_16 = ratio_q_P2_u_P1_2_of_u_p1_15 * cos_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_17 = ratio_q_P2_u_P1_2_of_u_p1_14
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_16);
    let ratio_q_P2_u_P1_2_of_u_p1_18 = u_p1_ratio_q_p3_u_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_19 = ratio_q_P2_u_P1_of_q_p5
        * ratio_q_P2_u_P1_2_of_u_p1_4.mul_add(S::int(4), ratio_q_P2_u_P1_2_of_u_p1_3)
        - ratio_q_P2_u_P1_of_q_p4_3 * ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_20 = cos_q_P3
        * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_11)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_17,
                ratio_q_P2_u_P1_2_of_u_p1_13 * cos_q_P3,
            ) + ratio_q_P2_u_P1_of_q_p4_q_p5_10 * ratio_q_P2_u_P1_2_of_u_p1_18
            + sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_19)
        + ratio_q_P2_u_P1_of_place_85 * ratio_q_P2_u_P1_2_of_u_p1_18;
    let ratio_q_P2_u_P1_2_of_u_p1_21 = u_p1_ratio_q_p4_u_p1 * sin_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_22 = ratio_q_P2_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_23 = ratio_q_P2_u_P1_2_of_u_p1_22
        .mul_add(cos_q_P2, ratio_q_P2_u_P1_2_of_u_p1_21 * sin_q_P2);
    let sin_q_p2_w_rod2_frame_3 = w_rod2_frame_3 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_24 = ratio_q_P2_u_P1_of_q_p5_2
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_3, ratio_q_P2_u_P1_2_of_u_p1 * sin_q_P4);
    let ratio_q_P2_u_P1_2_of_u_p1_25 = ratio_q_P2_u_P1_2_of_u_p1_10 + ratio_q_P2_u_P1_2_of_u_p1_24;
    let ratio_q_P2_u_P1_2_of_u_p1_26 = ratio_q_P2_u_P1_2_of_u_p1
        .mul_add(S::int(3), -ratio_q_P2_u_P1_2_of_u_p1_8)
        + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_25;
    let ratio_q_P2_u_P1_2_of_u_p1_27 = (-ratio_q_P2_u_P1_2_of_u_p1_14)
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_18 * cos_q_P5);
    let ratio_q_P2_u_P1_2_of_u_p1_28 = ratio_q_P2_u_P1_2_of_u_p1_24
        .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_29 = (-cos_q_p2_sin_q_p4)
        .mul_add(u_p1_ratio_q_p4_u_p1, ratio_q_P2_u_P1_2_of_u_p1_22 * sin_q_P2);
    let cos_q_p2_w_rod2_frame_3 = w_rod2_frame_3 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_30 = sin_q_P2
        * ((-ratio_q_P2_u_P1_2_of_u_p1_13)
            .mul_add(
                sin_q_P3,
                ratio_q_P2_u_P1_of_q_p4_q_p5_10 * ratio_q_P2_u_P1_2_of_u_p1_15,
            ) + cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_19
            + ratio_q_P2_u_P1_of_q_p4_q_p5_11 * ratio_q_P2_u_P1_2_of_u_p1_27)
        + ratio_q_P2_u_P1_of_place_91 * cos_q_p2_w_rod2_frame_3;
    let ratio_q_P2_u_P1_2_of_u_p1_31 = ratio_q_P3_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_32 = (-(ratio_q_P2_u_P1_2_of_u_p1_31 * cos_q_P2))
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_29 * sin_q_P3);
    let u_p1_cos_q_p1 = u_P1 * cos_q_P1;
    let u_p1_sin_q_p1 = u_P1 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_33 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_7;
    let ratio_q_P2_u_P1_2_of_u_p1_34 = ratio_q_P2_u_P1_2_of_u_p1_24
        .mul_add(cos_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5 * sin_q_p2_w_rod2_frame_3);
    let ratio_q_P2_u_P1_2_of_u_p1_35 = (-sin_q_p2_cos_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1,
            ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_23,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_36 = -ratio_q_P2_u_P1_of_place_99
        * ratio_q_P2_u_P1_2_of_u_p1_21
            .mul_add(cos_q_P5, ratio_q_P2_u_P1_2_of_u_p1_14 * cos_q_P4)
        + ratio_q_P2_u_P1_of_place_98 * ratio_q_P2_u_P1_2_of_u_p1_18
        + ratio_q_P2_u_P1_of_place_97 * u_p1_sin_q_p1
        + cos_q_P1
            * (sin_q_P1
                * (ratio_q_P2_u_P1_2_of_u_p1_13 - S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_20
                    - ratio_q_P2_u_P1_of_place_89 * sin_q_p2_w_rod2_frame_3
                    + cos_q_P2
                        * (-cos_q_P2
                            * (ratio_q_P2_u_P1_2_of_u_p1
                                + ratio_q_P2_u_P1_of_q_p4_q_p5_6 * ratio_q_P2_u_P1_2_of_u_p1_3
                                + sin_q_P4
                                    * ratio_q_P2_u_P1_2_of_u_p1_5
                                        .mul_add(S::int(4), ratio_q_P2_u_P1_2_of_u_p1)
                                - S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_6
                                - ratio_q_P2_u_P1_2_of_u_p1_20)
                            + ratio_q_P2_u_P1_of_place_88 * ratio_q_P2_u_P1_2_of_u_p1_23
                            - ratio_q_P2_u_P1_of_place_87 * sin_q_p2_w_rod2_frame_3
                            - sin_q_p2_cos_q_p4
                                * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_13)
                                    .mul_add(
                                        ratio_q_P2_u_P1_2_of_u_p1_15,
                                        ratio_q_P2_u_P1_2_of_u_p1_26 * sin_q_P3,
                                    )
                                    + ratio_q_P2_u_P1_of_q_p4_q_p5_14 * ratio_q_P2_u_P1_2_of_u_p1_27
                                    + cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_28)))
                + cos_q_P1
                    * (ratio_q_P2_u_P1_of_place_95 * ratio_q_P2_u_P1_2_of_u_p1_14
                        - ratio_q_P2_u_P1_of_place_93 * ratio_q_P2_u_P1_2_of_u_p1_18
                        + cos_q_P3
                            * (ratio_q_P2_u_P1_of_q_p4_q_p5_13
                                .mul_add(
                                    ratio_q_P2_u_P1_2_of_u_p1_29,
                                    cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_26,
                                ) + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_30)
                        + cos_q_P5
                            * ((-ratio_q_P2_u_P1_2_of_u_p1_19)
                                .mul_add(
                                    sin_q_P2,
                                    ratio_q_P2_u_P1_of_q_p4_q_p5_11 * cos_q_p2_w_rod2_frame_3,
                                ) - ratio_q_P2_u_P1_of_place_94 * ratio_q_P2_u_P1_2_of_u_p1_28
                                - ratio_q_P2_u_P1_of_q_p4_q_p5_14 * ratio_q_P2_u_P1_2_of_u_p1_32))
                - ratio_q_P2_u_P1_of_place_90 * u_p1_cos_q_p1
                - ratio_q_P2_u_P1_of_place_96 * u_p1_sin_q_p1)
        - cos_q_P3
            * (ratio_q_P2_u_P1_2_of_u_p1_30
                + ratio_q_P2_u_P1_of_q_p4_q_p5_15 * ratio_q_P2_u_P1_2_of_u_p1_29
                + cos_q_p2_cos_q_p4 * (ratio_q_P2_u_P1_2_of_u_p1_25 + ratio_q_P2_u_P1_2_of_u_p1_33))
        + cos_q_p4_cos_q_p5
            * ((-ratio_q_P2_u_P1_of_place_24)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_15,
                    ratio_q_P2_u_P1_2_of_u_p1_34 * sin_q_P3,
                ) - ratio_q_P2_u_P1_2_of_u_p1_35);
    let ratio_q_P2_u_P1_2_of_u_p1_37 = sin_q_p2_w_rod2_frame_3
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_2_of_u_p1_3 * cos_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_38 = ratio_q_P2_u_P1_2_of_u_p1_31 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_39 = ratio_q_P2_u_P1_2_of_u_p1_38
        .mul_add(cos_q_P3, -ratio_q_P2_u_P1_2_of_u_p1_37);
    let sin_q_p4_u_p1_cos_q_p1 = u_p1_cos_q_p1 * sin_q_P4;
    let cos_q_p3_ratio_q_p4_u_p1 = ratio_q_P4_u_P1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_40 = (-sin_q_p4_u_p1_cos_q_p1)
        .mul_add(
            cos_q_p3_ratio_q_p4_u_p1,
            sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_31,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_41 = cos_q_p3_sin_q_p1
        .mul_add(u_p1_cos_q_p4, ratio_q_P2_u_P1_2_of_u_p1_40);
    let ratio_q_P2_u_P1_2_of_u_p1_42 = cos_q_P5
        * (sin_q_P1
            * ratio_q_P2_u_P1_2_of_u_p1_23
                .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_39)
            + ratio_q_P2_u_P1_of_place_9 * u_p1_cos_q_p1 + ratio_q_P2_u_P1_2_of_u_p1_41)
        - ratio_q_P2_u_P1_of_place_11 * ratio_q_P2_u_P1_2_of_u_p1_14;
    let ratio_q_P2_u_P1_2_of_u_p1_43 = ratio_q_P2_u_P1_2_of_u_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_44 = (-ratio_q_P2_u_P1_2_of_u_p1_24)
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_p2_w_rod2_frame_3)
        + ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_32
        + cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_43;
    let ratio_q_P2_u_P1_2_of_u_p1_45 = ratio_q_P2_u_P1_2_of_u_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_46 = sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_47 = (-ratio_q_P2_u_P1_2_of_u_p1_18)
        .mul_add(sin_q_P5, ratio_q_P2_u_P1_2_of_u_p1_17 * sin_q_P4)
        - ratio_q_P2_u_P1_2_of_u_p1_45 - ratio_q_P2_u_P1_2_of_u_p1_46;
    let ratio_q_P2_u_P1_2_of_u_p1_48 = ratio_q_P2_u_P1_2_of_u_p1_23
        .mul_add(cos_q_P5, sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_14)
        - ratio_q_P2_u_P1_of_place_6 * sin_q_p2_w_rod2_frame_3
        + ratio_q_P2_u_P1_2_of_u_p1_47 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_49 = u_p1_cos_q_p1
        .mul_add(sin_q_P2, w_rod2_frame_3 * cos_q_p2_sin_q_p1);
    let sin_q_p3_u_p1_sin_q_p1 = u_p1_sin_q_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_50 = ratio_q_P2_u_P1_2_of_u_p1_15 * cos_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_51 = ratio_q_P2_u_P1_2_of_u_p1_29
        - sin_q_p2_sin_q_p3 * ratio_q_P2_u_P1_2_of_u_p1_3
        + sin_q_P4
            * cos_q_p2_w_rod2_frame_3
                .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_15 * sin_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_52 = u_p1_sin_q_p1
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_18 * cos_q_P1);
    let ratio_q_P2_u_P1_2_of_u_p1_53 = ratio_q_P2_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_14
        - ratio_q_P2_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1
        + cos_q_P5
            * ((-sin_q_p2_sin_q_p1)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_18,
                    ratio_q_P2_u_P1_2_of_u_p1_49 * cos_q_P3,
                ) - sin_q_p3_u_p1_sin_q_p1 + ratio_q_P2_u_P1_2_of_u_p1_50)
        - sin_q_P5
            * (ratio_q_P2_u_P1_of_place_3
                .mul_add(u_p1_cos_q_p1, cos_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_3)
                + ratio_q_P2_u_P1_2_of_u_p1_51 * sin_q_P1
                + ratio_q_P2_u_P1_2_of_u_p1_52 * sin_q_P4);
    let ratio_q_P2_u_P1_2_of_u_p1_54 = ratio_q_P2_u_P1_of_place_5
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_44,
            ratio_q_P2_u_P1_of_place_8 * ratio_q_P2_u_P1_2_of_u_p1_42,
        ) - ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_48
        - ratio_q_P2_u_P1_of_place_29 * ratio_q_P2_u_P1_2_of_u_p1_53;
    let ratio_q_P2_u_P1_2_of_u_p1_55 = ratio_q_P2_u_P1_2_of_u_p1_15 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_56 = cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_57 = ratio_q_P2_u_P1_2_of_u_p1_27
        .mul_add(sin_q_P4, -ratio_q_P2_u_P1_2_of_u_p1_43) + ratio_q_P2_u_P1_2_of_u_p1_55
        + ratio_q_P2_u_P1_2_of_u_p1_56;
    let ratio_q_P2_u_P1_2_of_u_p1_58 = (-ratio_q_P2_u_P1_2_of_u_p1_47)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_6 * u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_59 = (-ratio_q_P2_u_P1_of_place_19)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_49,
            sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_57,
        ) + ratio_q_P2_u_P1_2_of_u_p1_58;
    let ratio_q_P2_u_P1_2_of_u_p1_60 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_18, ratio_q_P2_u_P1_2_of_u_p1_17)
        - ratio_q_P2_u_P1_2_of_u_p1_24 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_61 = ratio_q_P2_u_P1_2_of_u_p1_60 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_place = ratio_q_P2_u_P1_of_place_16 * sin_q_p2_w_rod2_frame_3;
    let ratio_q_P2_u_P1_2_of_u_p1_62 = ratio_q_P2_u_P1_2_of_u_p1_61 - ratio_q_P2_u_P1_2_of_place;
    let ratio_q_P2_u_P1_2_of_place_2 = l * ratio_q_P2_u_P1_of_place_21;
    let ratio_q_P2_u_P1_2_of_u_p1_63 = (-ratio_q_P2_u_P1_of_place_68)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_53,
            ratio_q_P2_u_P1_2_of_u_p1_48 * ratio_q_P2_u_P1_2_of_place_2,
        ) - ratio_q_P2_u_P1_of_place_8 * ratio_q_P2_u_P1_2_of_u_p1_59
        - ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_62;
    let ratio_q_P2_u_P1_2_of_u_p1_64 = ratio_q_P2_u_P1_of_place_29
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_59,
            ratio_q_P2_u_P1_of_place_68 * ratio_q_P2_u_P1_2_of_u_p1_42,
        ) - ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_62
        + ratio_q_P2_u_P1_2_of_u_p1_44 * ratio_q_P2_u_P1_2_of_place_2;
    let ratio_q_P2_u_P1_2_of_u_p1_65 = (-ratio_q_P2_u_P1_2_of_u_p1_24)
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_q_p4_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_15)
        + ratio_q_P2_u_P1_2_of_u_p1_27;
    let ratio_q_P2_u_P1_2_of_u_p1_66 = (-ratio_q_P2_u_P1_2_of_u_p1_60)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_16 * u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_67 = l
        * ((-ratio_q_P2_u_P1_of_place_17)
            .mul_add(cos_q_p2_w_rod2_frame_3, ratio_q_P2_u_P1_2_of_u_p1_65 * sin_q_P1)
            - ratio_q_P2_u_P1_of_place_15 * u_p1_cos_q_p1
            + ratio_q_P2_u_P1_2_of_u_p1_66 * sin_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_68 = ratio_q_P2_u_P1_of_q_p3_q_p5
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_23, -ratio_q_P2_u_P1_2_of_u_p1_34)
        + ratio_q_P2_u_P1_of_q_p3_q_p5_3 * ratio_q_P2_u_P1_2_of_u_p1_38
        - sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_43;
    let ratio_q_P2_u_P1_2_of_u_p1_69 = cos_q_p3_cos_q_p1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_70 = l
        * (-u_p1_sin_q_p1
            * ratio_q_P2_u_P1_of_q_p4_q_p5
                .mul_add(cos_q_p3_ratio_q_p4_u_p1, -ratio_q_P2_u_P1_of_place_25)
            + ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_u_p1
            + ratio_q_P2_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_31 * sin_q_P1
            - ratio_q_P2_u_P1_2_of_u_p1_68 * cos_q_P1
            - ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_69);
    let ratio_q_P2_u_P1_2_of_u_p1_71 = (-cos_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_14, ratio_q_P2_u_P1_2_of_u_p1_29 * cos_q_P5)
        + ratio_q_P2_u_P1_of_place_6 * cos_q_p2_w_rod2_frame_3
        + ratio_q_P2_u_P1_2_of_u_p1_47 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_72 = l
        * ((-ratio_q_P2_u_P1_2_of_u_p1_57)
            .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_19 * u_p1_cos_q_p1)
            + ratio_q_P2_u_P1_of_place_31 * u_p1_sin_q_p1
            + ratio_q_P2_u_P1_2_of_u_p1_71 * cos_q_P1);
    let ratio_q_P2_u_P1_2_of_u_p1_73 = (-cos_q_p2_cos_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1,
            ratio_q_P2_u_P1_of_place_34 * cos_q_p2_w_rod2_frame_3,
        ) - ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_29
        - ratio_q_P2_u_P1_2_of_u_p1_65 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_74 = (-ratio_q_P2_u_P1_of_place_31)
        .mul_add(u_p1_cos_q_p1, ratio_q_P2_u_P1_of_place_19 * u_p1_sin_q_p1)
        + ratio_q_P2_u_P1_2_of_u_p1_57 * cos_q_P1 + ratio_q_P2_u_P1_2_of_u_p1_71 * sin_q_P1;
    let cos_q_p2_u_p1_cos_q_p1 = u_p1_cos_q_p1 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_75 = sin_q_p2_w_rod2_frame_3
        .mul_add(sin_q_P1, -cos_q_p2_u_p1_cos_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_76 = l * ratio_q_P2_u_P1_2_of_u_p1_48;
    let ratio_q_P2_u_P1_2_of_u_p1_77 = ratio_q_P2_u_P1_of_place_8 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_78 = ratio_q_P2_u_P1_2_of_u_p1_76
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_2_of_u_p1_77);
    let ratio_q_P2_u_P1_2_of_u_p1_79 = ratio_q_P2_u_P1_of_place_34
        .mul_add(sin_q_p2_w_rod2_frame_3, ratio_q_P2_u_P1_2_of_u_p1_35)
        + ratio_q_P2_u_P1_2_of_u_p1_65 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_80 = ratio_q_P2_u_P1_of_place_83
        * ratio_q_P2_u_P1_2_of_u_p1_53 * sin_q_P1
        + ratio_q_P2_u_P1_of_place_44 * ratio_q_P2_u_P1_2_of_u_p1_74
        - ratio_q_P2_u_P1_of_place_39 * ratio_q_P2_u_P1_2_of_u_p1_78
        + ratio_q_P2_u_P1_of_place_5
            * (-ratio_q_P2_u_P1_2_of_u_p1_79)
                .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_43 * u_p1_cos_q_p1);
    let ratio_q_P2_u_P1_2_of_place_3 = l * ratio_q_P2_u_P1_of_place_45;
    let ratio_q_P2_u_P1_2_of_place_4 = ratio_q_P2_u_P1_of_place_7 * l_sq;
    let ratio_q_P2_u_P1_2_of_u_p1_81 = ratio_q_P2_u_P1_of_q_p5_2
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_18, ratio_q_P2_u_P1_2_of_u_p1_45);
    let ratio_q_P2_u_P1_2_of_u_p1_82 = ratio_q_P2_u_P1_of_q_p3
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_14, ratio_q_P2_u_P1_2_of_u_p1_16)
        + ratio_q_P2_u_P1_2_of_u_p1_81;
    let ratio_q_P2_u_P1_2_of_u_p1_83 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_15, ratio_q_P2_u_P1_2_of_u_p1_43);
    let ratio_q_P2_u_P1_2_of_u_p1_84 = ratio_q_P2_u_P1_of_q_p4_q_p5
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_75,
            cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_24,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_85 = cos_q_p2_sin_q_p1
        * (ratio_q_P2_u_P1_of_place_50
            * u_p1_cos_q_p1.mul_add(cos_q_P5, ratio_q_P2_u_P1_2_of_u_p1_14 * sin_q_P1)
            - ratio_q_P2_u_P1_of_place_48 * ratio_q_P2_u_P1_2_of_u_p1_18
            - cos_q_p5_sin_q_p1
                * (ratio_q_P2_u_P1_2_of_u_p1_37
                    + ratio_q_P2_u_P1_of_place_49 * ratio_q_P2_u_P1_2_of_u_p1_15
                    + sin_q_P3
                        * ratio_q_P2_u_P1_of_q_p3
                            .mul_add(
                                ratio_q_P2_u_P1_2_of_u_p1_23, ratio_q_P2_u_P1_2_of_u_p1_39,
                            ))
            - cos_q_P3
                * (cos_q_P4
                    * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
                        .mul_add(
                            u_p1_sin_q_p1,
                            sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_83,
                        ) - ratio_q_P2_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_49
                        - ratio_q_P2_u_P1_2_of_u_p1_82 * cos_q_P1)
                    - ratio_q_P2_u_P1_of_place_46 * ratio_q_P2_u_P1_2_of_u_p1_21
                    + ratio_q_P2_u_P1_2_of_u_p1_84));
    let ratio_q_P2_u_P1_2_of_u_p1_86 = ratio_q_P2_u_P1_of_place_52 * ratio_q_P2_u_P1_2_of_u_p1_48
        + l * ratio_q_P2_u_P1_of_place_40 * ratio_q_P2_u_P1_2_of_u_p1_73
        + ratio_q_P2_u_P1_of_place_41
            * (l
                * ratio_q_P2_u_P1_of_place_38
                    .mul_add(
                        ratio_q_P2_u_P1_2_of_u_p1_53,
                        ratio_q_P2_u_P1_of_place_39 * ratio_q_P2_u_P1_2_of_u_p1_42,
                    )
                + ratio_q_P2_u_P1_of_place_5
                    * (ratio_q_P2_u_P1_of_place_25
                        .mul_add(
                            u_p1_cos_q_p1,
                            ratio_q_P2_u_P1_of_place_10 * ratio_q_P2_u_P1_2_of_u_p1,
                        ) + ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_41
                        + ratio_q_P2_u_P1_2_of_u_p1_68 * sin_q_P1)
                + ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_74)
        - ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_51 * ratio_q_P2_u_P1_2_of_u_p1_75
        + ratio_q_P2_u_P1_of_place_29 * ratio_q_P2_u_P1_2_of_u_p1_80
        - ratio_q_P2_u_P1_2_of_u_p1_44 * ratio_q_P2_u_P1_2_of_place_3
        + ratio_q_P2_u_P1_2_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_85;
    let ratio_q_P2_u_P1_2_of_u_p1_87 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_4;
    let ratio_q_P2_u_P1_2_of_u_p1_88 = ratio_q_P2_u_P1_2_of_u_p1_87
        - ratio_q_P2_u_P1_of_q_p4_2 * ratio_q_P2_u_P1_2_of_u_p1
        - sin_q_P5 * (ratio_q_P2_u_P1_2_of_u_p1_3 + ratio_q_P2_u_P1_2_of_u_p1_87);
    let ratio_q_P2_u_P1_2_of_u_p1_89 = ratio_q_P2_u_P1_2_of_u_p1_88 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_90 = ratio_q_P2_u_P1_of_q_p4_q_p5_3
        * ratio_q_P2_u_P1_2_of_u_p1_15;
    let ratio_q_P2_u_P1_2_of_u_p1_91 = ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P2_u_P1_2_of_u_p1_24;
    let ratio_q_P2_u_P1_2_of_u_p1_92 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_91;
    let ratio_q_P2_u_P1_2_of_u_p1_93 = ratio_q_P2_u_P1_of_q_p4
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_17, -ratio_q_P2_u_P1_2_of_u_p1_46);
    let ratio_q_P2_u_P1_2_of_u_p1_94 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_3)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_18, ratio_q_P2_u_P1_2_of_u_p1_88 * cos_q_P3);
    let ratio_q_P2_u_P1_2_of_u_p1_95 = ratio_q_P2_u_P1_2_of_u_p1_27 + ratio_q_P2_u_P1_2_of_u_p1_83;
    let ratio_q_P2_u_P1_2_of_u_p1_96 = cos_q_P1
        * (ratio_q_P2_u_P1_2_of_u_p1_17 + ratio_q_P2_u_P1_2_of_u_p1_81);
    let ratio_q_P2_u_P1_2_of_place_5 = ratio_q_P2_u_P1_of_q_p3_q_p5_7 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_97 = sin_q_P1
        * (ratio_q_P2_u_P1_of_place_20 * sin_q_p2_w_rod2_frame_3
            + ratio_q_P2_u_P1_of_place_72 * cos_q_p2_w_rod2_frame_3
            + ratio_q_P2_u_P1_2_of_u_p1_58 * cos_q_P2
            + sin_q_P2
                * (ratio_q_P2_u_P1_of_place_70 * u_p1_cos_q_p1
                    - ratio_q_P4_u_P1 * ratio_q_P2_u_P1_of_q_p3_q_p5_7 * sin_q_p4_u_p1_cos_q_p1
                    + sin_q_P1
                        * (cos_q_P2
                            * (ratio_q_P2_u_P1_of_q_p3_q_p5_5 * ratio_q_P2_u_P1_2_of_u_p1_3
                                - ratio_q_P2_u_P1_of_q_p3 * ratio_q_P2_u_P1_2_of_u_p1
                                + sin_q_P4
                                    * (ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P2_u_P1_2_of_u_p1_27)
                                + ratio_q_P2_u_P1_2_of_u_p1_55)
                            - ratio_q_P2_u_P1_of_q_p3_q_p5_6 * ratio_q_P2_u_P1_2_of_u_p1_23
                            - ratio_q_P2_u_P1_of_place_69 * sin_q_p2_w_rod2_frame_3
                            + sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_95)
                    - ratio_q_P2_u_P1_2_of_u_p1_96 * cos_q_P4
                    + u_p1_cos_q_p4 * ratio_q_P2_u_P1_2_of_place_5))
        + ratio_q_P2_u_P1_of_place_73 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_98 = l_sq * ratio_q_P2_u_P1_2_of_u_p1_73;
    let ratio_q_P2_u_P1_2_of_u_p1_99 = ratio_q_P2_u_P1_of_place_74 * ratio_q_P2_u_P1_2_of_u_p1_48
        - ratio_q_P2_u_P1_of_place_68 * ratio_q_P2_u_P1_2_of_u_p1_80
        - ratio_q_P2_u_P1_2_of_u_p1_62 * ratio_q_P2_u_P1_2_of_place_3
        + ratio_q_P2_u_P1_of_place_67
            * (-u_p1_cos_q_p1
                * (ratio_q_P2_u_P1_of_place_64 * sin_q_p3_sin_q_p1)
                    .mul_add(S::int(2), ratio_q_P2_u_P1_of_place_63)
                + ratio_q_P2_u_P1_of_place_65 * ratio_q_P2_u_P1_2_of_u_p1_50
                - sin_q_P1
                    * (ratio_q_P2_u_P1_of_q_p4_q_p5_4
                        * ratio_q_P2_u_P1_2_of_u_p1_32
                            .mul_add(
                                cos_q_P1,
                                cos_q_p2_sin_q_p1 * u_p1_cos_q_p4 * sin_q_P3,
                            ) + ratio_q_P2_u_P1_of_place_62 * cos_q_p2_w_rod2_frame_3
                        + sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_92
                        + sin_q_P2
                            * (sin_q_p3_cos_q_p1
                                * ratio_q_P2_u_P1_2_of_u_p1_90
                                    .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_89)
                                - ratio_q_P2_u_P1_of_place_61 * ratio_q_P2_u_P1_2_of_u_p1_18
                                - ratio_q_P2_u_P1_of_place_54 * sin_q_p3_u_p1_sin_q_p1
                                + cos_q_P3
                                    * (ratio_q_P2_u_P1_of_place_57 * u_p1_cos_q_p1
                                        + ratio_q_P2_u_P1_of_place_60 * u_p1_sin_q_p1
                                        + sin_q_P1
                                            * (ratio_q_P2_u_P1_of_q_p4_q_p5_4
                                                * ratio_q_P2_u_P1_2_of_u_p1_29
                                                + ratio_q_P2_u_P1_of_place_55 * cos_q_p2_w_rod2_frame_3
                                                + sin_q_P2
                                                    * (ratio_q_P2_u_P1_of_q_p4
                                                        .mul_add(
                                                            ratio_q_P2_u_P1_2_of_u_p1_27,
                                                            ratio_q_P2_u_P1_2_of_u_p1_56,
                                                        ) + ratio_q_P2_u_P1_2_of_u_p1_89
                                                        + ratio_q_P2_u_P1_2_of_u_p1_90)
                                                + ratio_q_P2_u_P1_2_of_u_p1_92)
                                        - cos_q_P1
                                            * ratio_q_P2_u_P1_2_of_u_p1_93
                                                .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_94))))
                + sin_q_p3_cos_q_p1 * cos_q_P1
                    * (ratio_q_P2_u_P1_2_of_u_p1_93 + ratio_q_P2_u_P1_2_of_u_p1_94))
        + ratio_q_P2_u_P1_2_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_97
        - ratio_q_P2_u_P1_of_place_66 * ratio_q_P2_u_P1_2_of_u_p1_98;
    let ratio_q_P2_u_P1_2_of_u_p1_100 = ratio_q_P2_u_P1_of_place_52
        * (-ratio_q_P2_u_P1_2_of_place).mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_61)
        - ratio_q_P2_u_P1_of_place_74 * ratio_q_P2_u_P1_2_of_u_p1_44
        + ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_of_place_51 * cos_q_p2_u_p1_cos_q_p1
        + ratio_q_P2_u_P1_of_place_67
            * (ratio_q_P2_u_P1_of_place_80 * u_p1_cos_q_p1
                - ratio_q_P2_u_P1_of_place_10 * ratio_q_P2_u_P1_2_of_u_p1_96
                + ratio_q_P2_u_P1_of_place_71 * ratio_q_P2_u_P1_2_of_u_p1_40
                - sin_q_P1
                    * (ratio_q_P2_u_P1_of_place_71 * ratio_q_P2_u_P1_2_of_u_p1_37
                        - ratio_q_P2_u_P1_of_place_79 * cos_q_p2_w_rod2_frame_3
                        + sin_q_P2
                            * (cos_q_p3_cos_q_p5
                                * (cos_q_p2_sin_q_p1
                                    .mul_add(
                                        ratio_q_P2_u_P1_2_of_u_p1_3, -ratio_q_P2_u_P1_2_of_u_p1_41,
                                    ) + ratio_q_P2_u_P1_2_of_u_p1_75 * sin_q_P4)
                                - ratio_q_P2_u_P1_of_place_77 * ratio_q_P2_u_P1_2_of_u_p1_15
                                - ratio_q_P2_u_P1_of_place_78 * ratio_q_P2_u_P1_2_of_u_p1_27
                                + sin_q_P3
                                    * (ratio_q_P2_u_P1_2_of_u_p1_84
                                        - ratio_q_P2_u_P1_of_place_76 * ratio_q_P2_u_P1_2_of_u_p1_21
                                        + cos_q_P4
                                            * (ratio_q_P2_u_P1_of_q_p3_q_p5_8 * u_p1_sin_q_p1
                                                - ratio_q_P2_u_P1_of_q_p3_q_p5_6
                                                    * ratio_q_P2_u_P1_2_of_u_p1_49
                                                - cos_q_P1
                                                    * ratio_q_P2_u_P1_2_of_u_p1_81
                                                        .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_17)
                                                + sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_95)))
                        + cos_q_p2_sin_q_p4
                            * ratio_q_P2_u_P1_of_q_p3_q_p5_7
                                .mul_add(u_p1_sin_q_p1, -ratio_q_P2_u_P1_2_of_u_p1_96))
                + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_69 * ratio_q_P2_u_P1_2_of_place_5)
        + l_sq
            * ratio_q_P2_u_P1_of_place
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_97,
                    ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_2_of_u_p1_85,
                ) + ratio_q_P2_u_P1_of_place_81 * ratio_q_P2_u_P1_2_of_u_p1_98;
    let ratio_q_P2_u_P1_2_of_u_p1_101 = l
        * ratio_q_P2_u_P1_2_of_u_p1_79
            .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_43 * u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_102 = ratio_q_P2_u_P1_of_place_102
        * ((-ratio_q_P2_u_P1_of_place_53)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_67,
                l_sq * ratio_q_P2_u_P1_of_place_84 * ratio_q_P2_u_P1_2_of_u_p1_36,
            ) + ratio_q_P2_u_P1_of_place_75 * ratio_q_P2_u_P1_2_of_u_p1_70
            - ratio_q_P2_u_P1_of_place_82 * ratio_q_P2_u_P1_2_of_u_p1_72
            + ratio_q_P2_u_P1_of_place_18 * ratio_q_P2_u_P1_2_of_u_p1_86
            + ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_2_of_u_p1_99
            - ratio_q_P2_u_P1_of_place_32 * ratio_q_P2_u_P1_2_of_u_p1_100
            + ratio_q_P2_u_P1_of_place_101 * ratio_q_P2_u_P1_2_of_u_p1_101);
    let ratio_q_P2_u_P1_2_of_u_p1_103 = ratio_q_P2_u_P1_of_place_105 * ratio_q_P2_u_P1_2_of_u_p1
        + ratio_q_P2_u_P1_of_place_106 * ratio_q_P2_u_P1_2_of_u_p1_14
        + cos_q_P5
            * ((-cos_q_p3_sin_q_p1)
                .mul_add(ratio_q_P2_u_P1_2_of_u_p1_3, sin_q_p4_u_p1_cos_q_p1 * cos_q_P3)
                - ratio_q_P2_u_P1_2_of_u_p1_18 * sin_q_P1 * sin_q_P4
                - ratio_q_P2_u_P1_of_place_3 * u_p1_sin_q_p1
                + ratio_q_P2_u_P1_2_of_u_p1_51 * cos_q_P1)
        + sin_q_P5
            * ((-ratio_q_P2_u_P1_2_of_u_p1_15)
                .mul_add(sin_q_P1, cos_q_p3_cos_q_p1 * cos_q_p2_w_rod2_frame_3)
                - u_p1_cos_q_p1 * sin_q_P3 - ratio_q_P2_u_P1_2_of_u_p1_52 * sin_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_104 = ratio_q_P2_u_P1_of_place_108
        * ratio_q_P2_u_P1_of_place_107
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_102, -ratio_q_P2_u_P1_2_of_u_p1_103);
    let ratio_q_P2_u_P1_2_of_u_p1_105 = ratio_q_P2_u_P1_2_of_u_p1_104
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_109 * ratio_q_P2_u_P1_2_of_u_p1_14);
    let ratio_q_P2_u_P1_2_of_u_p1_106 = ratio_q_P2_u_P1_of_place_36
        .mul_add(u_p1_sin_q_p1, ratio_q_P2_u_P1_of_place_16 * u_p1_cos_q_p1)
        + ratio_q_P2_u_P1_2_of_u_p1_60 * sin_q_P1 - ratio_q_P2_u_P1_2_of_u_p1_73 * cos_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_107 = ratio_q_P2_u_P1_of_place_103
        * ratio_q_P2_u_P1_of_place_37
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_102, -ratio_q_P2_u_P1_2_of_u_p1_106);
    let ratio_q_P2_u_P1_2_of_u_p1_108 = ratio_q_P2_u_P1_of_place_36
        .mul_add(u_p1_cos_q_p1, -ratio_q_P2_u_P1_2_of_u_p1_66)
        + ratio_q_P2_u_P1_2_of_u_p1_73 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_109 = ratio_q_P2_u_P1_of_place_111
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_102, ratio_q_P2_u_P1_2_of_u_p1_108);
    let ratio_q_P2_u_P1_2 = ratio_q_P2_u_P1_of_place_104
        * ((-ratio_q_P2_u_P1_of_place_18)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_54,
                ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_2_of_u_p1_63,
            ) + ratio_q_P2_u_P1_of_place_32 * ratio_q_P2_u_P1_2_of_u_p1_64
            - ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_2_of_u_p1_67
            + ratio_q_P2_u_P1_of_place_23 * ratio_q_P2_u_P1_2_of_u_p1_70
            - ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_2_of_u_p1_72)
        - ratio_q_P2_u_P1_of_place_108 * ratio_q_P2_u_P1_of_place_111 * ratio_q_P2_u_P1_2_of_u_p1_36
        - ratio_q_P2_u_P1_of_place_110 * ratio_q_P2_u_P1_2_of_u_p1_91
        + ratio_q_P2_u_P1_of_q_p4_q_p5_16 * ratio_q_P2_u_P1_2_of_u_p1_105
        + ratio_q_P2_u_P1_of_place_33 * ratio_q_P2_u_P1_2_of_u_p1_107
        + ratio_q_P2_u_P1_of_place_112 * ratio_q_P2_u_P1_2_of_u_p1_109;
    let ratio_q_P3_u_P1_2_of_u_p1 = (-ratio_q_P2_u_P1_of_place_41)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_53,
            S::int(2) * ratio_q_P2_u_P1_of_place_44 * ratio_q_P2_u_P1_2_of_u_p1_48,
        ) - ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_73
        + ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_2_of_u_p1_77;
    let ratio_q_P3_u_P1_2_of_u_p1_2 = (-ratio_q_P2_u_P1_of_place_41)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_42,
            ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_73,
        ) - ratio_q_P2_u_P1_of_place_44 * ratio_q_P2_u_P1_2_of_u_p1_44
        + ratio_q_P2_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_78;
    let ratio_q_P3_u_P1_2_of_u_p1_3 = ratio_q_P2_u_P1_2_of_u_p1_104
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_109 * ratio_q_P2_u_P1_2_of_u_p1_21);
    let ratio_q_P3_u_P1_2_of_u_p1_4 = ratio_q_P2_u_P1_of_place_103 * ratio_q_P2_u_P1_2_of_u_p1_109;
    let ratio_q_P3_u_P1_2 = ratio_q_P3_u_P1_of_place_5
        * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_14, ratio_q_P2_u_P1_2_of_u_p1)
            + ratio_q_P2_u_P1_2_of_u_p1_82 * cos_q_P5 - ratio_q_P2_u_P1_2_of_u_p1_83)
        + ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_86
        + ratio_q_P3_u_P1_of_place_3 * ratio_q_P2_u_P1_2_of_u_p1_107
        + ratio_q_P2_u_P1_of_place_104
            * ((-ratio_q_P2_u_P1_of_place_84)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_54,
                    ratio_q_P3_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_72,
                ) - ratio_q_P3_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_70
                - ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_2_of_u_p1_101
                - ratio_q_P2_u_P1_of_place_27 * ratio_q_P3_u_P1_2_of_u_p1
                + ratio_q_P2_u_P1_of_place_32 * ratio_q_P3_u_P1_2_of_u_p1_2)
        - ratio_q_P3_u_P1_of_q_p3_q_p5 * ratio_q_P3_u_P1_2_of_u_p1_3
        + ratio_q_P2_u_P1_of_place_53 * ratio_q_P3_u_P1_2_of_u_p1_4;
    let ratio_q_P4_u_P1_2_of_u_p1 = ratio_q_P2_u_P1_of_place_41 * ratio_q_P2_u_P1_2_of_u_p1_59
        - ratio_q_P2_u_P1_2_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_73
        + ratio_q_P2_u_P1_of_place_8
            * (-ratio_q_P2_u_P1_of_place_16)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_75,
                    cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_60,
                ) + ratio_q_P4_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_76;
    let ratio_q_P4_u_P1_2_of_u_p1_2 = ratio_q_P2_u_P1_2_of_u_p1_27 - ratio_q_P2_u_P1_2_of_u_p1_15;
    let ratio_q_P4_u_P1_2 = ratio_q_P4_u_P1_of_place_3 * ratio_q_P2_u_P1_2_of_u_p1_107
        - ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_99
        - ratio_q_P4_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_105
        + ratio_q_P2_u_P1_of_place_75 * ratio_q_P3_u_P1_2_of_u_p1_4
        + ratio_q_P2_u_P1_of_place_104
            * ((-ratio_q_P2_u_P1_of_place_84)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_63,
                    ratio_q_P2_u_P1_of_place_32 * ratio_q_P4_u_P1_2_of_u_p1,
                ) - ratio_q_P3_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_67
                - ratio_q_P4_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_72
                - ratio_q_P2_u_P1_of_place_23 * ratio_q_P2_u_P1_2_of_u_p1_101
                - ratio_q_P2_u_P1_of_place_18 * ratio_q_P3_u_P1_2_of_u_p1)
        + ratio_q_P2_u_P1_of_place_110
            * (-ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P4_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_3
                - sin_q_P4
                    * ((-ratio_q_P4_u_P1_of_q_p4_q_p5)
                        .mul_add(
                            ratio_q_P2_u_P1_2_of_u_p1_15,
                            ratio_q_P2_u_P1_2_of_u_p1_91 * sin_q_P3,
                        ) - ratio_q_P2_u_P1_2_of_u_p1_24 - ratio_q_P2_u_P1_2_of_u_p1_27)
                + ratio_q_P4_u_P1_2_of_u_p1_2);
    let ratio_q_P5_u_P1_2 = ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_100
        + ratio_q_P5_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_107
        - ratio_q_P5_u_P1_of_place_2 * ratio_q_P3_u_P1_2_of_u_p1_3
        + ratio_q_P2_u_P1_of_place_82 * ratio_q_P3_u_P1_2_of_u_p1_4
        + ratio_q_P2_u_P1_of_place_104
            * ((-ratio_q_P2_u_P1_of_place_84)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_64,
                    ratio_q_P2_u_P1_of_place_18 * ratio_q_P3_u_P1_2_of_u_p1_2,
                ) - ratio_q_P3_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_67
                - ratio_q_P4_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_70
                - ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_2_of_u_p1_101
                - ratio_q_P2_u_P1_of_place_27 * ratio_q_P4_u_P1_2_of_u_p1)
        + ratio_q_P3_u_P1_of_place_5
            * (ratio_q_P5_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3
                - ratio_q_P5_u_P1_of_q_p3_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1
                + sin_q_P4
                    * ((-(ratio_q_P2_u_P1_2_of_u_p1_2 * sin_q_P3))
                        .mul_add(
                            S::int(2),
                            ratio_q_P2_u_P1_of_q_p5_4 * ratio_q_P2_u_P1_2_of_u_p1_15,
                        ) + ratio_q_P2_u_P1_2_of_u_p1_33)
                + ratio_q_P2_u_P1_of_q_p5 * ratio_q_P4_u_P1_2_of_u_p1_2);
    let w_rod1_frame_22 = u_P1 * u_P1;
    let w_rod2_frame_23 = w_rod1_frame_in_rod2_frame_2 * w_rod2_frame_3;
    let alpha_rod2_frame_1 = w_rod2_frame_23;
    let alpha_rod2_frame_3 = u_P1 * ratio_q_P2_u_P1_2;
    let w_rod2_frame_11 = w_rod1_frame_in_rod2_frame_1 * w_rod1_frame_in_rod2_frame_1;
    let w_rod2_frame_12 = w_rod1_frame_in_rod2_frame_1 * w_rod1_frame_in_rod2_frame_2;
    let w_rod2_frame_33 = w_rod2_frame_3 * w_rod2_frame_3;
    let turn_rod2_frame_12 = alpha_rod2_frame_3 - w_rod2_frame_12;
    let turn_rod2_frame_22 = w_rod2_frame_11 + w_rod2_frame_33;
    let turn_rod2_frame_32 = alpha_rod2_frame_1 + w_rod2_frame_23;
    let alpha_rod2_frame_in_rod3_frame_2 = (-alpha_rod2_frame_3)
        .mul_add(sin_q_P3, w_rod1_frame_in_rod2_frame_1 * cos_q_p3_w_rod2_frame_3);
    let alpha_rod2_frame_in_rod3_frame_3 = w_rod1_frame_in_rod2_frame_1
        .mul_add(sin_q_p3_w_rod2_frame_3, alpha_rod2_frame_3 * cos_q_P3);
    let alpha_rod3_frame_1 = u_P1.mul_add(ratio_q_P3_u_P1_2, alpha_rod2_frame_1);
    let alpha_rod3_frame_2 = w_rod2_frame_in_rod3_frame_3
        .mul_add(u_p1_ratio_q_p3_u_p1, alpha_rod2_frame_in_rod3_frame_2);
    let alpha_rod3_frame_3 = w_rod2_frame_in_rod3_frame_2
        .mul_add(u_p1_ratio_q_p3_u_p1, -alpha_rod2_frame_in_rod3_frame_3);
    let w_rod3_frame_11 = w_rod3_frame_1 * w_rod3_frame_1;
    let w_rod3_frame_13 = w_rod2_frame_in_rod3_frame_3 * w_rod3_frame_1;
    let w_rod3_frame_22 = w_rod2_frame_in_rod3_frame_2 * w_rod2_frame_in_rod3_frame_2;
    let w_rod3_frame_23 = w_rod2_frame_in_rod3_frame_2 * w_rod2_frame_in_rod3_frame_3;
    let turn_rod3_frame_13 = alpha_rod3_frame_2 + w_rod3_frame_13;
    let turn_rod3_frame_23 = alpha_rod3_frame_1 + w_rod3_frame_23;
    let turn_rod3_frame_33 = w_rod3_frame_11 + w_rod3_frame_22;
    let alpha_rod3_frame_in_rod4_frame_1 = alpha_rod3_frame_3
        .mul_add(sin_q_P4, alpha_rod3_frame_1 * cos_q_P4);
    let alpha_rod3_frame_in_rod4_frame_3 = (-alpha_rod3_frame_1)
        .mul_add(sin_q_P4, alpha_rod3_frame_3 * cos_q_P4);
    let alpha_rod4_frame_1 = w_rod3_frame_in_rod4_frame_3
        .mul_add(u_p1_ratio_q_p4_u_p1, -alpha_rod3_frame_in_rod4_frame_1);
    let alpha_rod4_frame_2 = u_P1.mul_add(ratio_q_P4_u_P1_2, alpha_rod3_frame_2);
    let alpha_rod4_frame_3 = w_rod3_frame_in_rod4_frame_1
        .mul_add(u_p1_ratio_q_p4_u_p1, alpha_rod3_frame_in_rod4_frame_3);
    let w_rod4_frame_12 = w_rod3_frame_in_rod4_frame_1 * w_rod4_frame_2;
    let w_rod4_frame_13 = w_rod3_frame_in_rod4_frame_1 * w_rod3_frame_in_rod4_frame_3;
    let w_rod4_frame_22 = w_rod4_frame_2 * w_rod4_frame_2;
    let w_rod4_frame_33 = w_rod3_frame_in_rod4_frame_3 * w_rod3_frame_in_rod4_frame_3;
    let turn_rod4_frame_11 = w_rod4_frame_22 + w_rod4_frame_33;
    let turn_rod4_frame_21 = alpha_rod4_frame_3 + w_rod4_frame_12;
    let turn_rod4_frame_31 = alpha_rod4_frame_2 - w_rod4_frame_13;
    let alpha_rod4_frame_in_rod5_frame_1 = alpha_rod4_frame_2
        .mul_add(sin_q_P5, alpha_rod4_frame_1 * cos_q_P5);
    let alpha_rod5_frame_1 = w_rod4_frame_in_rod5_frame_2
        .mul_add(u_p1_ratio_q_p5_u_p1, -alpha_rod4_frame_in_rod5_frame_1);
    let alpha_rod5_frame_3 = u_P1.mul_add(ratio_q_P5_u_P1_2, alpha_rod4_frame_3);
    let w_rod5_frame_11 = w_rod4_frame_in_rod5_frame_1 * w_rod4_frame_in_rod5_frame_1;
    let w_rod5_frame_12 = w_rod4_frame_in_rod5_frame_1 * w_rod4_frame_in_rod5_frame_2;
    let w_rod5_frame_23 = w_rod4_frame_in_rod5_frame_2 * w_rod5_frame_3;
    let w_rod5_frame_33 = w_rod5_frame_3 * w_rod5_frame_3;
    let turn_rod5_frame_12 = alpha_rod5_frame_3 - w_rod5_frame_12;
    let turn_rod5_frame_22 = w_rod5_frame_11 + w_rod5_frame_33;
    let turn_rod5_frame_32 = alpha_rod5_frame_1 + w_rod5_frame_23;
    let a_rod1_centre_1 = l * w_rod1_frame_22;
    let a_rod1_frame_in_rod2_frame_1 = (-g)
        .mul_add(sin_q_P2, a_rod1_centre_1 * cos_q_P2);
    let a_rod1_frame_in_rod2_frame_2 = a_rod1_centre_1.mul_add(sin_q_P2, g * cos_q_P2);
    let l_turn_rod2_frame_12 = l * turn_rod2_frame_12;
    let a_rod2_centre_1 = a_rod1_frame_in_rod2_frame_1
        .mul_add(S::int(2), l_turn_rod2_frame_12);
    let a_rod2_centre_3 = l * turn_rod2_frame_32;
    let m_l_sq = m * l_sq;
    let H_rod2_1 = w_rod1_frame_in_rod2_frame_1 * m_l_sq;
    let H_rod2_3 = w_rod2_frame_3 * m_l_sq;
    let a_rod3_centre_1 = a_rod1_frame_in_rod2_frame_1 + l_turn_rod2_frame_12;
    let a_rod3_centre_2 = l.mul_add(turn_rod2_frame_22, -a_rod1_frame_in_rod2_frame_2);
    let a_rod2_frame_in_rod3_frame_2 = (-a_rod2_centre_3)
        .mul_add(sin_q_P3, a_rod3_centre_2 * cos_q_P3);
    let a_rod2_frame_in_rod3_frame_3 = a_rod3_centre_2
        .mul_add(sin_q_P3, a_rod2_centre_3 * cos_q_P3);
    let l_turn_rod3_frame_13 = l * turn_rod3_frame_13;
    let a_rod3_centre_1_2 = a_rod3_centre_1.mul_add(S::int(2), l_turn_rod3_frame_13);
    let l_turn_rod3_frame_23 = l * turn_rod3_frame_23;
    let a_rod3_centre_2_2 = a_rod2_frame_in_rod3_frame_2
        .mul_add(S::int(2), l_turn_rod3_frame_23);
    let l_turn_rod3_frame_33 = l * turn_rod3_frame_33;
    let a_rod3_centre_3 = (-a_rod2_frame_in_rod3_frame_3)
        .mul_add(S::int(2), l_turn_rod3_frame_33);
    let H_rod3_1 = w_rod3_frame_1 * m_l_sq;
    let H_rod3_2 = w_rod2_frame_in_rod3_frame_2 * m_l_sq;
    let a_rod4_centre_1 = a_rod3_centre_1 + l_turn_rod3_frame_13;
    let a_rod4_centre_2 = a_rod2_frame_in_rod3_frame_2 + l_turn_rod3_frame_23;
    let a_rod4_centre_3 = l_turn_rod3_frame_33 - a_rod2_frame_in_rod3_frame_3;
    let a_rod3_frame_in_rod4_frame_1 = (-a_rod4_centre_1)
        .mul_add(cos_q_P4, a_rod4_centre_3 * sin_q_P4);
    let a_rod3_frame_in_rod4_frame_3 = a_rod4_centre_3
        .mul_add(cos_q_P4, a_rod4_centre_1 * sin_q_P4);
    let l_turn_rod4_frame_11 = l * turn_rod4_frame_11;
    let a_rod4_centre_1_2 = a_rod3_frame_in_rod4_frame_1
        .mul_add(S::int(2), l_turn_rod4_frame_11);
    let l_turn_rod4_frame_21 = l * turn_rod4_frame_21;
    let a_rod4_centre_2_2 = (-a_rod4_centre_2).mul_add(S::int(2), l_turn_rod4_frame_21);
    let l_turn_rod4_frame_31 = l * turn_rod4_frame_31;
    let a_rod4_centre_3_2 = a_rod3_frame_in_rod4_frame_3
        .mul_add(S::int(2), l_turn_rod4_frame_31);
    let H_rod4_2 = w_rod4_frame_2 * m_l_sq;
    let H_rod4_3 = w_rod3_frame_in_rod4_frame_3 * m_l_sq;
    let a_rod5_centre_1 = a_rod3_frame_in_rod4_frame_1 + l_turn_rod4_frame_11;
    let a_rod5_centre_2 = l_turn_rod4_frame_21 - a_rod4_centre_2;
    let a_rod5_centre_3 = a_rod3_frame_in_rod4_frame_3 + l_turn_rod4_frame_31;
    let a_rod4_frame_in_rod5_frame_1 = a_rod5_centre_2
        .mul_add(sin_q_P5, a_rod5_centre_1 * cos_q_P5);
    let a_rod4_frame_in_rod5_frame_2 = (-a_rod5_centre_2)
        .mul_add(cos_q_P5, a_rod5_centre_1 * sin_q_P5);
    let a_rod5_centre_1_2 = (-a_rod4_frame_in_rod5_frame_1)
        .mul_add(S::int(2), l * turn_rod5_frame_12);
    let a_rod5_centre_2_2 = (-a_rod4_frame_in_rod5_frame_2)
        .mul_add(S::int(2), l * turn_rod5_frame_22);
    let a_rod5_centre_3_2 = a_rod5_centre_3.mul_add(S::int(2), l * turn_rod5_frame_32);
    let H_rod5_1 = w_rod4_frame_in_rod5_frame_1 * m_l_sq;
    let H_rod5_3 = w_rod5_frame_3 * m_l_sq;
    let F_v_rod5_centre_3 = m * a_rod5_centre_3_2;
    let F_v_rod5_centre_1 = m * a_rod5_centre_1_2;
    let F_v_rod4_frame_in_rod5_frame_2 = m * a_rod5_centre_2_2;
    let F_v_rod5_centre_2 = (-F_v_rod5_centre_1)
        .mul_add(sin_q_P5, F_v_rod4_frame_in_rod5_frame_2 * cos_q_P5);
    let F_v_rod4_centre_3 = m * a_rod4_centre_3_2;
    let F_v_rod4_centre_2 = m * a_rod4_centre_2_2;
    let F_v_rod3_frame_in_rod4_frame_3 = F_v_rod5_centre_3 + F_v_rod4_centre_3;
    let F_v_rod3_frame_in_rod4_frame_1 = (-F_v_rod5_centre_1)
        .mul_add(cos_q_P5, m * a_rod4_centre_1_2) - F_v_rod4_frame_in_rod5_frame_2 * sin_q_P5;
    let F_v_rod4_centre_2_2 = F_v_rod5_centre_2 + F_v_rod4_centre_2;
    let F_v_rod4_centre_1 = (-F_v_rod3_frame_in_rod4_frame_1)
        .mul_add(cos_q_P4, F_v_rod3_frame_in_rod4_frame_3 * sin_q_P4);
    let F_v_rod3_centre_2 = m * a_rod3_centre_2_2;
    let F_v_rod3_centre_1 = m * a_rod3_centre_1_2;
    let F_v_rod2_frame_in_rod3_frame_3 = F_v_rod3_frame_in_rod4_frame_3
        .mul_add(cos_q_P4, m * a_rod3_centre_3) + F_v_rod3_frame_in_rod4_frame_1 * sin_q_P4;
    let F_v_rod2_frame_in_rod3_frame_2 = F_v_rod4_centre_2_2 - F_v_rod3_centre_2;
    let F_v_rod3_centre_3 = (-F_v_rod2_frame_in_rod3_frame_2)
        .mul_add(sin_q_P3, F_v_rod2_frame_in_rod3_frame_3 * cos_q_P3);
    let F_v_rod2_centre_3 = m * a_rod2_centre_3;
    let F_v_rod2_centre_1_of_place = F_v_rod4_centre_1 + F_v_rod3_centre_1;
    let F_v_rod2_centre_1 = F_v_rod2_centre_1_of_place
        .mul_add(S::int(2), m * a_rod2_centre_1);
    let F_v_rod1_centre_3 = F_v_rod3_centre_3 - F_v_rod2_centre_3;
    let l_times_3 = S::int(3) * l;
    let F_w_rod5_frame_3 = (-alpha_rod5_frame_3)
        .mul_add(m_l_sq, w_rod4_frame_in_rod5_frame_2 * H_rod5_1) - F_v_rod5_centre_1 * l_times_3;
    let F_w_rod4_frame_in_rod5_frame_2 = (-w_rod4_frame_in_rod5_frame_1)
        .mul_add(H_rod5_3, w_rod5_frame_3 * H_rod5_1);
    let F_w_rod4_frame_in_rod5_frame_1 = alpha_rod5_frame_1
        .mul_add(m_l_sq, w_rod4_frame_in_rod5_frame_2 * H_rod5_3) + F_v_rod5_centre_3 * l_times_3;
    let l_times_6 = S::int(6) * l;
    let F_w_rod4_frame_2 = (-F_w_rod4_frame_in_rod5_frame_2)
        .mul_add(cos_q_P5, w_rod3_frame_in_rod4_frame_1 * H_rod4_3)
        + F_w_rod4_frame_in_rod5_frame_1 * sin_q_P5 - alpha_rod4_frame_2 * m_l_sq
        - F_v_rod4_centre_3 * l_times_3 - F_v_rod5_centre_3 * l_times_6;
    let F_w_rod3_frame_in_rod4_frame_3 = w_rod3_frame_in_rod4_frame_1
        .mul_add(H_rod4_2, -F_w_rod5_frame_3) + alpha_rod4_frame_3 * m_l_sq
        + F_v_rod4_centre_2 * l_times_3 + F_v_rod5_centre_2 * l_times_6;
    let F_w_rod3_frame_in_rod4_frame_1 = (-w_rod3_frame_in_rod4_frame_3)
        .mul_add(H_rod4_2, w_rod4_frame_2 * H_rod4_3) + F_w_rod4_frame_in_rod5_frame_2 * sin_q_P5
        + F_w_rod4_frame_in_rod5_frame_1 * cos_q_P5;
    let F_w_rod3_frame_1 = (-F_w_rod3_frame_in_rod4_frame_3)
        .mul_add(sin_q_P4, w_rod2_frame_in_rod3_frame_3 * H_rod3_2)
        + F_w_rod3_frame_in_rod4_frame_1 * cos_q_P4 + alpha_rod3_frame_1 * m_l_sq
        + F_v_rod3_centre_2 * l_times_3 - F_v_rod4_centre_2_2 * l_times_6;
    let F_w_rod2_frame_in_rod3_frame_3 = (-w_rod2_frame_in_rod3_frame_2)
        .mul_add(H_rod3_1, w_rod3_frame_1 * H_rod3_2) - F_w_rod3_frame_in_rod4_frame_3 * cos_q_P4
        - F_w_rod3_frame_in_rod4_frame_1 * sin_q_P4;
    let F_w_rod2_frame_in_rod3_frame_2 = w_rod2_frame_in_rod3_frame_3
        .mul_add(H_rod3_1, -F_w_rod4_frame_2) + alpha_rod3_frame_2 * m_l_sq
        + F_v_rod3_centre_1 * l_times_3 + F_v_rod4_centre_1 * l_times_6;
    let F_w_rod2_frame_3 = (-F_w_rod2_frame_in_rod3_frame_3)
        .mul_add(cos_q_P3, w_rod1_frame_in_rod2_frame_2 * H_rod2_1)
        + F_w_rod2_frame_in_rod3_frame_2 * sin_q_P3 - alpha_rod2_frame_3 * m_l_sq
        - F_v_rod2_centre_1 * l_times_3;
    let F_w_rod1_frame_in_rod2_frame_2 = (-w_rod1_frame_in_rod2_frame_1)
        .mul_add(H_rod2_3, w_rod2_frame_3 * H_rod2_1) - F_w_rod2_frame_in_rod3_frame_3 * sin_q_P3
        - F_w_rod2_frame_in_rod3_frame_2 * cos_q_P3;
    let F_w_rod1_frame_in_rod2_frame_1 = w_rod1_frame_in_rod2_frame_2
        .mul_add(H_rod2_3, F_w_rod3_frame_1) + alpha_rod2_frame_1 * m_l_sq
        + F_v_rod2_centre_3 * l_times_3 - F_v_rod3_centre_3 * l_times_6;
    let f1_of_place = ratio_q_P4_u_P1
        .mul_add(F_w_rod4_frame_2, ratio_q_P5_u_P1 * F_w_rod5_frame_3);
    let f1_of_place_2 = (-ratio_q_P3_u_P1)
        .mul_add(F_w_rod3_frame_1, ratio_q_P2_u_P1 * F_w_rod2_frame_3);
    let f1_of_place_3 = F_w_rod1_frame_in_rod2_frame_1
        .mul_add(sin_q_P2, F_w_rod1_frame_in_rod2_frame_2 * cos_q_P2);
    let f1_of_place_4 = f1_of_place + f1_of_place_2;
    let f1_of_place_5 = f1_of_place_3 - f1_of_place_4;
    // Values.
    let f1 = -S::ratio(1, 2) * l * F_v_rod1_centre_3 - S::ratio(1, 12) * f1_of_place_5;
    [f1]
}

/// The accelerations (u_P1'), solved for when this code was generated.
///
/// 1701 operations, 5 sines and cosines.
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
    let ratio_q_P2_u_P1_of_place_20 = ratio_q_P2_u_P1_of_place_6 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_21 = sin_q_p2_sin_q_p1
        .mul_add(ratio_q_P2_u_P1_of_place_19, ratio_q_P2_u_P1_of_place_20);
    let ratio_q_P2_u_P1_of_place_22 = ratio_q_P2_u_P1_of_place_16 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_23 = (-ratio_q_P2_u_P1_of_place_8)
        .mul_add(
            ratio_q_P2_u_P1_of_place_21,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_22,
        );
    let ratio_q_P2_u_P1_of_place_24 = ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_25 = ratio_q_P2_u_P1_of_q_p3_q_p5
        .mul_add(sin_q_p2_cos_q_p4, ratio_q_P2_u_P1_of_place_24);
    let cos_q_p3_sin_q_p1 = sin_q_P1 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_26 = cos_q_p3_sin_q_p1 * cos_q_P4;
    let ratio_q_P2_u_P1_of_place_27 = l
        * ratio_q_P2_u_P1_of_q_p5_2
            .mul_add(
                ratio_q_P2_u_P1_of_place_26,
                ratio_q_P2_u_P1_of_place_25 * cos_q_P1,
            );
    let ratio_q_P2_u_P1_of_place_28 = l * ratio_q_P2_u_P1_of_place_12;
    let ratio_q_P2_u_P1_of_place_29 = l * ratio_q_P2_u_P1_of_place;
    let ratio_q_P2_u_P1_of_place_30 = ratio_q_P2_u_P1_of_place_21
        .mul_add(
            ratio_q_P2_u_P1_of_place_29,
            ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_of_place_28,
        );
    let ratio_q_P2_u_P1_of_place_31 = (-ratio_q_P2_u_P1_of_place_6)
        .mul_add(sin_q_P2, cos_q_p2_cos_q_p4 * cos_q_P5);
    let ratio_q_P2_u_P1_of_place_32 = l
        * (-ratio_q_P2_u_P1_of_place_31)
            .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_19 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_33 = (-ratio_q_P2_u_P1_of_place_23)
        .mul_add(
            ratio_q_P2_u_P1_of_place_27,
            ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_of_place_18,
        ) - ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_of_place_32;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_2 = S::int(1) - cos_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_34 = -ratio_q_P2_u_P1_of_place_14 - ratio_q_P2_u_P1_of_q_p3_q_p5_2;
    let ratio_q_P2_u_P1_of_place_35 = ratio_q_P2_u_P1_of_place_34
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p2_cos_q_p4);
    let ratio_q_P2_u_P1_of_place_36 = S::int(1) + ratio_q_P2_u_P1_of_place_35;
    let ratio_q_P2_u_P1_of_place_37 = (-ratio_q_P2_u_P1_of_place_16)
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_36 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_38 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_of_place_10, ratio_q_P2_u_P1_of_place_25 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_39 = ratio_q_P2_u_P1_of_place_31
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_19 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_40 = (-ratio_q_P2_u_P1_of_place_28)
        .mul_add(
            ratio_q_P2_u_P1_of_place_39,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_38,
        );
    let ratio_q_P2_u_P1_of_place_41 = l * ratio_q_P2_u_P1_of_place_35;
    let ratio_q_P2_u_P1_of_place_42 = ratio_q_P2_u_P1_of_q_p5_2 * sin_q_p2_cos_q_p4;
    let ratio_q_P2_u_P1_of_place_43 = ratio_q_P2_u_P1_of_place_34
        .mul_add(cos_q_P2, -ratio_q_P2_u_P1_of_place_42);
    let ratio_q_P2_u_P1_of_place_44 = ratio_q_P2_u_P1_of_place_8 * sin_q_P1;
    let ratio_q_P2_u_P1_of_place_45 = (-ratio_q_P2_u_P1_of_place_39)
        .mul_add(
            ratio_q_P2_u_P1_of_place_44,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_43 * sin_q_P1,
        );
    let cos_q_p2_sin_q_p1 = sin_q_P1 * cos_q_P2;
    let ratio_q_P2_u_P1_of_q_p3 = sin_q_P3 - S::int(1);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_3 = ratio_q_P2_u_P1_of_q_p5_2 * cos_q_P3;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_4 = (-ratio_q_P2_u_P1_of_q_p3)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_q_p3_q_p5_3);
    let ratio_q_P2_u_P1_of_place_46 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_q_p3_q_p5 * sin_q_p2_sin_q_p1);
    let ratio_q_P2_u_P1_of_place_47 = ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_p2_sin_q_p1;
    let ratio_q_P2_u_P1_of_place_48 = ratio_q_P2_u_P1_of_place_46
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_47);
    let ratio_q_P2_u_P1_of_place_49 = sin_q_p2_cos_q_p4
        .mul_add(ratio_q_P2_u_P1_of_q_p3, cos_q_p2_sin_q_p4);
    let ratio_q_P2_u_P1_of_place_50 = (-ratio_q_P2_u_P1_of_place_49)
        .mul_add(sin_q_P3, cos_q_p2_sin_q_p4);
    let cos_q_p5_sin_q_p1 = sin_q_P1 * cos_q_P5;
    let l_sq = l * l;
    let ratio_q_P2_u_P1_of_place_51 = l_sq
        * ratio_q_P2_u_P1_of_place_50
            .mul_add(cos_q_p5_sin_q_p1, ratio_q_P2_u_P1_of_place_48 * cos_q_P3);
    let ratio_q_P2_u_P1_of_place_52 = cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_of_place_51;
    let ratio_q_P2_u_P1_of_place_53 = ratio_q_P2_u_P1_of_place_29
        .mul_add(
            ratio_q_P2_u_P1_of_place_45,
            ratio_q_P2_u_P1_of_place_40 * ratio_q_P2_u_P1_of_place_41,
        ) + ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_52;
    let ratio_q_P2_u_P1_of_q_p4 = S::int(1) + sin_q_P4;
    let cos_q_p4_sq = cos_q_P4 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_2 = ratio_q_P2_u_P1_of_q_p4 - cos_q_p4_sq;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_3 = ratio_q_P2_u_P1_of_q_p4_2
        .mul_add(sin_q_P5, cos_q_p4_sq);
    let ratio_q_P2_u_P1_of_place_54 = ratio_q_P2_u_P1_of_q_p4_q_p5_3 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_55 = (-cos_q_p3_cos_q_p5)
        .mul_add(ratio_q_P2_u_P1_of_q_p4, ratio_q_P2_u_P1_of_place_54);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_4 = sin_q_P5 + ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_place_56 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p4_q_p5_4;
    let ratio_q_P2_u_P1_of_place_57 = ratio_q_P2_u_P1_of_place_55
        .mul_add(sin_q_P2, -ratio_q_P2_u_P1_of_place_56);
    let ratio_q_P2_u_P1_of_place_58 = ratio_q_P2_u_P1_of_q_p4_q_p5_3 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_59 = sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_of_q_p4;
    let ratio_q_P2_u_P1_of_place_60 = ratio_q_P2_u_P1_of_place_59
        .mul_add(S::int(2), ratio_q_P2_u_P1_of_place_58);
    let ratio_q_P2_u_P1_of_place_61 = (-ratio_q_P2_u_P1_of_place_60)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_57 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_62 = ratio_q_P2_u_P1_of_place_61
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_of_place_54);
    let ratio_q_P2_u_P1_of_place_63 = (-sin_q_p3_cos_q_p1)
        .mul_add(ratio_q_P2_u_P1_of_place_56, ratio_q_P2_u_P1_of_place_62 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_64 = ratio_q_P2_u_P1_of_place_58 + ratio_q_P2_u_P1_of_place_59;
    let ratio_q_P2_u_P1_of_place_65 = ratio_q_P2_u_P1_of_place_64 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_66 = (-sin_q_p3_cos_q_p1)
        .mul_add(ratio_q_P2_u_P1_of_place_65, ratio_q_P2_u_P1_of_place_63 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_67 = ratio_q_P2_u_P1_of_place_35 * l_sq;
    let ratio_q_P2_u_P1_of_place_68 = l * ratio_q_P2_u_P1_of_place_22;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_5 = cos_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_place_69 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_5)
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_q_p3 * sin_q_P5);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_6 = ratio_q_P2_u_P1_of_q_p3_q_p5 + cos_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_70 = (-sin_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_of_q_p3_q_p5_6, ratio_q_P2_u_P1_of_place_69 * cos_q_P2);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_7 = sin_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_3;
    let ratio_q_P2_u_P1_of_place_71 = ratio_q_P2_u_P1_of_q_p3_q_p5_7 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_72 = (-ratio_q_P2_u_P1_of_place_71)
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_70 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_73 = (-ratio_q_P2_u_P1_of_place_20)
        .mul_add(cos_q_P2, ratio_q_P2_u_P1_of_place_72 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_74 = l_sq * ratio_q_P2_u_P1_of_place_73 * sin_q_P1;
    let ratio_q_P2_u_P1_of_place_75 = ratio_q_P2_u_P1_of_place_45
        .mul_add(
            ratio_q_P2_u_P1_of_place_68,
            ratio_q_P2_u_P1_of_place_66 * ratio_q_P2_u_P1_of_place_67,
        ) - ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_74;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_8 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_3)
        .mul_add(S::int(2), sin_q_p3_cos_q_p5);
    let ratio_q_P2_u_P1_of_place_76 = ratio_q_P2_u_P1_of_q_p3_q_p5_8
        .mul_add(cos_q_P1, sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_of_q_p3_q_p5_6);
    let ratio_q_P2_u_P1_of_place_77 = ratio_q_P2_u_P1_of_place_76
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_47);
    let ratio_q_P2_u_P1_of_place_78 = (-cos_q_p2_sin_q_p1)
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_place_10);
    let ratio_q_P2_u_P1_of_place_79 = (-cos_q_p3_cos_q_p5)
        .mul_add(ratio_q_P2_u_P1_of_place_78, ratio_q_P2_u_P1_of_place_77 * sin_q_P3);
    let ratio_q_P2_u_P1_of_place_80 = ratio_q_P2_u_P1_of_place_79
        .mul_add(sin_q_P2, cos_q_p2_sin_q_p4 * ratio_q_P2_u_P1_of_place_71);
    let ratio_q_P2_u_P1_of_place_81 = (-ratio_q_P2_u_P1_of_place_10)
        .mul_add(ratio_q_P2_u_P1_of_place_71, ratio_q_P2_u_P1_of_place_80 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_82 = ratio_q_P2_u_P1_of_place
        .mul_add(
            ratio_q_P2_u_P1_of_place_74,
            ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_of_place_52,
        ) + ratio_q_P2_u_P1_of_place_67 * ratio_q_P2_u_P1_of_place_81;
    let ratio_q_P2_u_P1_of_place_83 = l * ratio_q_P2_u_P1_of_place_43;
    let ratio_q_P2_u_P1_of_place_84 = ratio_q_P2_u_P1_of_place_83 * cos_q_P1;
    let cos_q_p5_sq = cos_q_P5 * cos_q_P5;
    let ratio_q_P2_u_P1_of_q_p5_3 = ratio_q_P2_u_P1_of_q_p5 - cos_q_p5_sq;
    let ratio_q_P2_u_P1_of_q_p5_4 = ratio_q_P2_u_P1_of_q_p5
        .mul_add(S::int(2), -cos_q_p5_sq);
    let ratio_q_P2_u_P1_of_q_p5_5 = -ratio_q_P2_u_P1_of_q_p5_4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_5 = cos_q_p4_sq * ratio_q_P2_u_P1_of_q_p5_5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_6 = -ratio_q_P2_u_P1_of_q_p5_3
        - ratio_q_P2_u_P1_of_q_p4_q_p5_5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_7 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(cos_q_p4_sq, ratio_q_P2_u_P1_of_q_p4_q_p5_6 * sin_q_P4);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_8 = ratio_q_P2_u_P1_of_q_p4_q_p5_7 - ratio_q_P2_u_P1_of_q_p5_3;
    let cos_q_p4_sq_doubled = S::int(2) * cos_q_p4_sq;
    let ratio_q_P2_u_P1_of_q_p4_3 = ratio_q_P2_u_P1_of_q_p4 - cos_q_p4_sq_doubled;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_9 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_of_q_p4_3;
    let ratio_q_P2_u_P1_of_place_85 = sin_q_p3_cos_q_p5
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_9,
            ratio_q_P2_u_P1_of_q_p4_q_p5_8 * cos_q_P3,
        );
    let ratio_q_P2_u_P1_of_q_p4_q_p5_10 = ratio_q_P2_u_P1_of_q_p5_5 * cos_q_p4_sq_doubled;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_11 = -ratio_q_P2_u_P1_of_q_p5
        - ratio_q_P2_u_P1_of_q_p4_q_p5_10;
    let ratio_q_P2_u_P1_of_place_86 = ratio_q_P2_u_P1_of_q_p4_q_p5_11
        .mul_add(sin_q_P4, -ratio_q_P2_u_P1_of_q_p5)
        - ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p4_sq_doubled - ratio_q_P2_u_P1_of_place_85 * cos_q_P3;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_12 = S::int(2) * ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_13 = (-ratio_q_P2_u_P1_of_q_p5)
        .mul_add(S::int(3), cos_q_p5_sq) - ratio_q_P2_u_P1_of_q_p4_q_p5_10
        + ratio_q_P2_u_P1_of_q_p4_q_p5_12;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_14 = ratio_q_P2_u_P1_of_q_p4_q_p5_12 - ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_place_87 = cos_q_p3_cos_q_p5
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_14,
            ratio_q_P2_u_P1_of_q_p4_q_p5_13 * sin_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_88 = sin_q_p2_cos_q_p4
        .mul_add(ratio_q_P2_u_P1_of_place_87, ratio_q_P2_u_P1_of_place_86 * cos_q_P2);
    let cos_q_p3_doubled = S::int(2) * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_89 = (-ratio_q_P2_u_P1_of_place_88)
        .mul_add(cos_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5_8)
        - ratio_q_P2_u_P1_of_place_85 * cos_q_p3_doubled;
    let ratio_q_P2_u_P1_of_place_90 = (-cos_q_p3_cos_q_p5)
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_9,
            ratio_q_P2_u_P1_of_q_p4_q_p5_8 * sin_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_91 = ratio_q_P2_u_P1_of_place_90 * sin_q_P2;
    let ratio_q_P2_u_P1_of_place_92 = (-cos_q_p2_cos_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_13,
            S::int(2) * ratio_q_P2_u_P1_of_place_91,
        );
    let ratio_q_P2_u_P1_of_place_93 = cos_q_p2_cos_q_p4 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_94 = ratio_q_P2_u_P1_of_q_p4_q_p5_14
        .mul_add(ratio_q_P2_u_P1_of_place_93, ratio_q_P2_u_P1_of_q_p4_q_p5_9 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_95 = ratio_q_P2_u_P1_of_place_94
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_92 * cos_q_P3);
    let ratio_q_P2_u_P1_of_place_96 = (-ratio_q_P2_u_P1_of_place_95)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_89 * sin_q_P1);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_15 = ratio_q_P2_u_P1_of_q_p4_q_p5
        - ratio_q_P2_u_P1_of_q_p5_4 - ratio_q_P2_u_P1_of_q_p4_q_p5_5;
    let ratio_q_P2_u_P1_of_place_97 = (-cos_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_of_q_p4_q_p5_15, ratio_q_P2_u_P1_of_place_91);
    let ratio_q_P2_u_P1_of_place_98 = ratio_q_P2_u_P1_of_place_24
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_place_42);
    let cos_q_p4_cos_q_p5 = cos_q_P4 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_99 = ratio_q_P2_u_P1_of_place_97
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_of_place_96 * cos_q_P1)
        + ratio_q_P2_u_P1_of_place_98 * cos_q_p4_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_100 = l_sq * ratio_q_P2_u_P1_of_place_99;
    let ratio_q_P2_u_P1_of_place_101 = S::int(1)
        / ((-ratio_q_P2_u_P1_of_place_18)
            .mul_add(
                ratio_q_P2_u_P1_of_place_53,
                ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_of_place_75,
            ) + ratio_q_P2_u_P1_of_place_32 * ratio_q_P2_u_P1_of_place_82
            + ratio_q_P2_u_P1_of_place_84 * ratio_q_P2_u_P1_of_place_100);
    let ratio_q_P2_u_P1_of_place_102 = l * ratio_q_P2_u_P1_of_place_101;
    let ratio_q_P2_u_P1_of_place_103 = ratio_q_P2_u_P1_of_place_37 * ratio_q_P2_u_P1_of_place_102;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_16 = ratio_q_P2_u_P1_of_q_p4_q_p5 - ratio_q_P2_u_P1_of_q_p5;
    let sin_q_p3_sin_q_p1 = sin_q_P1 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_104 = (-cos_q_p3_cos_q_p1)
        .mul_add(sin_q_P2, sin_q_p3_sin_q_p1);
    let ratio_q_P2_u_P1_of_place_105 = cos_q_p3_sin_q_p1
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_place_3 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_106 = (-ratio_q_P2_u_P1_of_place_105)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_104 * sin_q_P5);
    let ratio_q_P2_u_P1_of_place_107 = l_sq * ratio_q_P2_u_P1_of_place_102;
    let ratio_q_P2_u_P1_of_place_108 = ratio_q_P2_u_P1_of_place_106 * ratio_q_P2_u_P1_of_place_107;
    let ratio_q_P2_u_P1_of_place_109 = ratio_q_P2_u_P1_of_place_108 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_110 = ratio_q_P2_u_P1_of_place_36
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_17);
    let ratio_q_P2_u_P1_of_place_111 = ratio_q_P2_u_P1_of_place_99 * ratio_q_P2_u_P1_of_place_107;
    let ratio_q_P2_u_P1 = ratio_q_P2_u_P1_of_q_p4_q_p5_16
        .mul_add(
            ratio_q_P2_u_P1_of_place_109,
            ratio_q_P2_u_P1_of_place_33 * ratio_q_P2_u_P1_of_place_103,
        ) + ratio_q_P2_u_P1_of_place_110 * ratio_q_P2_u_P1_of_place_111;
    let ratio_q_P3_u_P1_of_place = (-ratio_q_P2_u_P1_of_place_7)
        .mul_add(
            ratio_q_P2_u_P1_of_place_44,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_35,
        );
    let ratio_q_P3_u_P1_of_place_2 = ratio_q_P2_u_P1_of_place
        .mul_add(
            ratio_q_P2_u_P1_of_place_44,
            ratio_q_P2_u_P1_of_place_12 * ratio_q_P2_u_P1_of_place_41,
        );
    let ratio_q_P3_u_P1_of_place_3 = ratio_q_P2_u_P1_of_place_27
        .mul_add(
            ratio_q_P3_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_of_place_84,
        ) + ratio_q_P2_u_P1_of_place_32 * ratio_q_P3_u_P1_of_place_2;
    let ratio_q_P3_u_P1_of_place_4 = ratio_q_P2_u_P1_of_place_102 * ratio_q_P2_u_P1_of_place_110;
    let ratio_q_P3_u_P1_of_q_p3_q_p5 = ratio_q_P2_u_P1_of_q_p3_q_p5_4
        .mul_add(cos_q_P5, -ratio_q_P2_u_P1_of_q_p5) - ratio_q_P2_u_P1_of_q_p3_q_p5;
    let ratio_q_P3_u_P1_of_place_5 = ratio_q_P2_u_P1_of_place_108 * cos_q_P4;
    let ratio_q_P3_u_P1 = ratio_q_P2_u_P1_of_place_53
        .mul_add(
            ratio_q_P3_u_P1_of_place_4,
            ratio_q_P2_u_P1_of_place_103 * ratio_q_P3_u_P1_of_place_3,
        ) - ratio_q_P3_u_P1_of_q_p3_q_p5 * ratio_q_P3_u_P1_of_place_5;
    let ratio_q_P4_u_P1_of_place = ratio_q_P2_u_P1_of_place_16 * cos_q_p2_sin_q_p1;
    let ratio_q_P4_u_P1_of_place_2 = (-ratio_q_P2_u_P1_of_place_8)
        .mul_add(
            ratio_q_P4_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_of_place_41,
        );
    let ratio_q_P4_u_P1_of_place_3 = ratio_q_P2_u_P1_of_place_18
        .mul_add(
            ratio_q_P3_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_23 * ratio_q_P2_u_P1_of_place_84,
        ) - ratio_q_P2_u_P1_of_place_32 * ratio_q_P4_u_P1_of_place_2;
    let ratio_q_P4_u_P1_of_q_p4_q_p5 = ratio_q_P2_u_P1_of_q_p4_q_p5_4 - S::int(2);
    let ratio_q_P4_u_P1_of_place_4 = (-ratio_q_P4_u_P1_of_q_p4_q_p5)
        .mul_add(
            sin_q_P3,
            ratio_q_P2_u_P1_of_q_p4_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_2,
        );
    let ratio_q_P4_u_P1_of_place_5 = ratio_q_P4_u_P1_of_place_4
        .mul_add(sin_q_P4, sin_q_P3 - sin_q_P5 + cos_q_p3_cos_q_p5);
    let ratio_q_P4_u_P1 = ratio_q_P2_u_P1_of_place_103
        .mul_add(
            ratio_q_P4_u_P1_of_place_3,
            ratio_q_P2_u_P1_of_place_75 * ratio_q_P3_u_P1_of_place_4,
        ) - ratio_q_P2_u_P1_of_place_109 * ratio_q_P4_u_P1_of_place_5;
    let ratio_q_P5_u_P1_of_place = ratio_q_P2_u_P1_of_place_18
        .mul_add(
            ratio_q_P3_u_P1_of_place_2,
            ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_of_place_84,
        ) + ratio_q_P2_u_P1_of_place_27 * ratio_q_P4_u_P1_of_place_2;
    let ratio_q_P5_u_P1_of_q_p3_q_p5 = (-ratio_q_P2_u_P1_of_q_p5_5)
        .mul_add(sin_q_P3, -ratio_q_P2_u_P1_of_q_p5_4);
    let ratio_q_P5_u_P1_of_q_p3_q_p5_2 = sin_q_P3 - ratio_q_P2_u_P1_of_q_p3_q_p5_2;
    let ratio_q_P5_u_P1_of_place_2 = ratio_q_P2_u_P1_of_q_p5
        .mul_add(
            ratio_q_P5_u_P1_of_q_p3_q_p5_2,
            ratio_q_P5_u_P1_of_q_p3_q_p5 * sin_q_P4,
        );
    let ratio_q_P5_u_P1 = ratio_q_P2_u_P1_of_place_103
        .mul_add(
            ratio_q_P5_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_82 * ratio_q_P3_u_P1_of_place_4,
        ) - ratio_q_P3_u_P1_of_place_5 * ratio_q_P5_u_P1_of_place_2;
    let w_rod1_frame_in_rod2_frame_1 = u_P1 * sin_q_P2;
    let w_rod1_frame_in_rod2_frame_2 = u_P1 * cos_q_P2;
    let w_rod2_frame_3 = u_P1 * ratio_q_P2_u_P1;
    let sin_q_p3_w_rod2_frame_3 = w_rod2_frame_3 * sin_q_P3;
    let w_rod2_frame_in_rod3_frame_2 = w_rod1_frame_in_rod2_frame_2
        .mul_add(cos_q_P3, sin_q_p3_w_rod2_frame_3);
    let cos_q_p3_w_rod2_frame_3 = w_rod2_frame_3 * cos_q_P3;
    let w_rod2_frame_in_rod3_frame_3 = w_rod1_frame_in_rod2_frame_2
        .mul_add(sin_q_P3, -cos_q_p3_w_rod2_frame_3);
    let u_p1_ratio_q_p3_u_p1 = u_P1 * ratio_q_P3_u_P1;
    let w_rod3_frame_1 = w_rod1_frame_in_rod2_frame_1 + u_p1_ratio_q_p3_u_p1;
    let w_rod3_frame_in_rod4_frame_1 = w_rod3_frame_1
        .mul_add(cos_q_P4, w_rod2_frame_in_rod3_frame_3 * sin_q_P4);
    let w_rod3_frame_in_rod4_frame_3 = (-w_rod3_frame_1)
        .mul_add(sin_q_P4, w_rod2_frame_in_rod3_frame_3 * cos_q_P4);
    let u_p1_ratio_q_p4_u_p1 = u_P1 * ratio_q_P4_u_P1;
    let w_rod4_frame_2 = u_p1_ratio_q_p4_u_p1 - w_rod2_frame_in_rod3_frame_2;
    let w_rod4_frame_in_rod5_frame_1 = (-w_rod4_frame_2)
        .mul_add(sin_q_P5, w_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let w_rod4_frame_in_rod5_frame_2 = w_rod4_frame_2
        .mul_add(cos_q_P5, w_rod3_frame_in_rod4_frame_1 * sin_q_P5);
    let u_p1_ratio_q_p5_u_p1 = u_P1 * ratio_q_P5_u_P1;
    let w_rod5_frame_3 = w_rod3_frame_in_rod4_frame_3 + u_p1_ratio_q_p5_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1 = u_p1_ratio_q_p5_u_p1 * cos_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_2 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_2_of_u_p1;
    let u_p1_cos_q_p4 = u_P1 * cos_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_3 = ratio_q_P4_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_4 = ratio_q_P2_u_P1_2_of_u_p1_3 * sin_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_5 = (-cos_q_p4_sq)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_2,
            ratio_q_P2_u_P1_of_q_p5_5 * ratio_q_P2_u_P1_2_of_u_p1_4,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_6 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_12)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_3, cos_q_p4_sq * ratio_q_P2_u_P1_2_of_u_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_7 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_8 = ratio_q_P2_u_P1_2_of_u_p1_7 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_9 = ratio_q_P2_u_P1_2_of_u_p1_8 - ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_10 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_5;
    let ratio_q_P2_u_P1_2_of_u_p1_11 = sin_q_P4
        * (ratio_q_P2_u_P1_2_of_u_p1_10 - ratio_q_P2_u_P1_2_of_u_p1_9)
        + ratio_q_P2_u_P1_of_q_p4_q_p5_6 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_12 = ratio_q_P2_u_P1_2_of_u_p1_6 + ratio_q_P2_u_P1_2_of_u_p1_9;
    let ratio_q_P2_u_P1_2_of_u_p1_13 = ratio_q_P2_u_P1_2_of_u_p1_11 - ratio_q_P2_u_P1_2_of_u_p1_12;
    let ratio_q_P2_u_P1_2_of_u_p1_14 = u_p1_ratio_q_p5_u_p1 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_15 = u_p1_ratio_q_p3_u_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_16 = ratio_q_P2_u_P1_2_of_u_p1_15 * cos_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_17 = ratio_q_P2_u_P1_2_of_u_p1_14
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_16);
    let ratio_q_P2_u_P1_2_of_u_p1_18 = u_p1_ratio_q_p3_u_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_19 = ratio_q_P2_u_P1_of_q_p5
        * ratio_q_P2_u_P1_2_of_u_p1_4.mul_add(S::int(4), ratio_q_P2_u_P1_2_of_u_p1_3)
        - ratio_q_P2_u_P1_of_q_p4_3 * ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_20 = cos_q_P3
        * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_9)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_17,
                ratio_q_P2_u_P1_2_of_u_p1_13 * cos_q_P3,
            ) + ratio_q_P2_u_P1_of_q_p4_q_p5_8 * ratio_q_P2_u_P1_2_of_u_p1_18
            + sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_19)
        + ratio_q_P2_u_P1_of_place_85 * ratio_q_P2_u_P1_2_of_u_p1_18;
    let ratio_q_P2_u_P1_2_of_u_p1_21 = u_p1_ratio_q_p4_u_p1 * sin_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_22 = ratio_q_P2_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_23 = ratio_q_P2_u_P1_2_of_u_p1_22
        .mul_add(cos_q_P2, ratio_q_P2_u_P1_2_of_u_p1_21 * sin_q_P2);
    let sin_q_p2_w_rod2_frame_3 = w_rod2_frame_3 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_24 = ratio_q_P2_u_P1_of_q_p5_2
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_3, ratio_q_P2_u_P1_2_of_u_p1 * sin_q_P4);
    let ratio_q_P2_u_P1_2_of_u_p1_25 = ratio_q_P2_u_P1_2_of_u_p1_10 + ratio_q_P2_u_P1_2_of_u_p1_24;
    let ratio_q_P2_u_P1_2_of_u_p1_26 = ratio_q_P2_u_P1_2_of_u_p1
        .mul_add(S::int(3), -ratio_q_P2_u_P1_2_of_u_p1_8)
        + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_25;
    let ratio_q_P2_u_P1_2_of_u_p1_27 = (-ratio_q_P2_u_P1_2_of_u_p1_14)
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_18 * cos_q_P5);
    let ratio_q_P2_u_P1_2_of_u_p1_28 = ratio_q_P2_u_P1_2_of_u_p1_24
        .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_29 = (-cos_q_p2_sin_q_p4)
        .mul_add(u_p1_ratio_q_p4_u_p1, ratio_q_P2_u_P1_2_of_u_p1_22 * sin_q_P2);
    let cos_q_p2_w_rod2_frame_3 = w_rod2_frame_3 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_30 = sin_q_P2
        * ((-ratio_q_P2_u_P1_2_of_u_p1_13)
            .mul_add(
                sin_q_P3,
                ratio_q_P2_u_P1_of_q_p4_q_p5_8 * ratio_q_P2_u_P1_2_of_u_p1_15,
            ) + cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_19
            + ratio_q_P2_u_P1_of_q_p4_q_p5_9 * ratio_q_P2_u_P1_2_of_u_p1_27)
        + ratio_q_P2_u_P1_of_place_90 * cos_q_p2_w_rod2_frame_3;
    let ratio_q_P2_u_P1_2_of_u_p1_31 = ratio_q_P3_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_32 = (-(ratio_q_P2_u_P1_2_of_u_p1_31 * cos_q_P2))
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_29 * sin_q_P3);
    let u_p1_cos_q_p1 = u_P1 * cos_q_P1;
    let u_p1_sin_q_p1 = u_P1 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_33 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_7;
    let ratio_q_P2_u_P1_2_of_u_p1_34 = ratio_q_P2_u_P1_2_of_u_p1_24
        .mul_add(cos_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5 * sin_q_p2_w_rod2_frame_3);
    let ratio_q_P2_u_P1_2_of_u_p1_35 = (-sin_q_p2_cos_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1,
            ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_23,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_36 = -ratio_q_P2_u_P1_of_place_98
        * ratio_q_P2_u_P1_2_of_u_p1_21
            .mul_add(cos_q_P5, ratio_q_P2_u_P1_2_of_u_p1_14 * cos_q_P4)
        + ratio_q_P2_u_P1_of_place_97 * ratio_q_P2_u_P1_2_of_u_p1_18
        + ratio_q_P2_u_P1_of_place_96 * u_p1_sin_q_p1
        + cos_q_P1
            * (sin_q_P1
                * (ratio_q_P2_u_P1_2_of_u_p1_13 - S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_20
                    - ratio_q_P2_u_P1_of_place_88 * sin_q_p2_w_rod2_frame_3
                    + cos_q_P2
                        * (-cos_q_P2
                            * (ratio_q_P2_u_P1_2_of_u_p1
                                + ratio_q_P2_u_P1_of_q_p4_q_p5_11 * ratio_q_P2_u_P1_2_of_u_p1_3
                                + sin_q_P4
                                    * ratio_q_P2_u_P1_2_of_u_p1_5
                                        .mul_add(S::int(4), ratio_q_P2_u_P1_2_of_u_p1)
                                - S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_6
                                - ratio_q_P2_u_P1_2_of_u_p1_20)
                            + ratio_q_P2_u_P1_of_place_87 * ratio_q_P2_u_P1_2_of_u_p1_23
                            - ratio_q_P2_u_P1_of_place_86 * sin_q_p2_w_rod2_frame_3
                            - sin_q_p2_cos_q_p4
                                * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_13)
                                    .mul_add(
                                        ratio_q_P2_u_P1_2_of_u_p1_15,
                                        ratio_q_P2_u_P1_2_of_u_p1_26 * sin_q_P3,
                                    )
                                    + ratio_q_P2_u_P1_of_q_p4_q_p5_14 * ratio_q_P2_u_P1_2_of_u_p1_27
                                    + cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_28)))
                + cos_q_P1
                    * (ratio_q_P2_u_P1_of_place_94 * ratio_q_P2_u_P1_2_of_u_p1_14
                        - ratio_q_P2_u_P1_of_place_92 * ratio_q_P2_u_P1_2_of_u_p1_18
                        + cos_q_P3
                            * (ratio_q_P2_u_P1_of_q_p4_q_p5_13
                                .mul_add(
                                    ratio_q_P2_u_P1_2_of_u_p1_29,
                                    cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_26,
                                ) + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_30)
                        + cos_q_P5
                            * ((-ratio_q_P2_u_P1_2_of_u_p1_19)
                                .mul_add(
                                    sin_q_P2,
                                    ratio_q_P2_u_P1_of_q_p4_q_p5_9 * cos_q_p2_w_rod2_frame_3,
                                ) - ratio_q_P2_u_P1_of_place_93 * ratio_q_P2_u_P1_2_of_u_p1_28
                                - ratio_q_P2_u_P1_of_q_p4_q_p5_14 * ratio_q_P2_u_P1_2_of_u_p1_32))
                - ratio_q_P2_u_P1_of_place_89 * u_p1_cos_q_p1
                - ratio_q_P2_u_P1_of_place_95 * u_p1_sin_q_p1)
        - cos_q_P3
            * (ratio_q_P2_u_P1_2_of_u_p1_30
                + ratio_q_P2_u_P1_of_q_p4_q_p5_15 * ratio_q_P2_u_P1_2_of_u_p1_29
                + cos_q_p2_cos_q_p4 * (ratio_q_P2_u_P1_2_of_u_p1_25 + ratio_q_P2_u_P1_2_of_u_p1_33))
        + cos_q_p4_cos_q_p5
            * ((-ratio_q_P2_u_P1_of_place_24)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_15,
                    ratio_q_P2_u_P1_2_of_u_p1_34 * sin_q_P3,
                ) - ratio_q_P2_u_P1_2_of_u_p1_35);
    let ratio_q_P2_u_P1_2_of_u_p1_37 = sin_q_p2_w_rod2_frame_3
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_2_of_u_p1_3 * cos_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_38 = ratio_q_P2_u_P1_2_of_u_p1_31 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_39 = ratio_q_P2_u_P1_2_of_u_p1_38
        .mul_add(cos_q_P3, -ratio_q_P2_u_P1_2_of_u_p1_37);
    let sin_q_p4_u_p1_cos_q_p1 = u_p1_cos_q_p1 * sin_q_P4;
    let cos_q_p3_ratio_q_p4_u_p1 = ratio_q_P4_u_P1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_40 = (-sin_q_p4_u_p1_cos_q_p1)
        .mul_add(
            cos_q_p3_ratio_q_p4_u_p1,
            sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_31,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_41 = cos_q_p3_sin_q_p1
        .mul_add(u_p1_cos_q_p4, ratio_q_P2_u_P1_2_of_u_p1_40);
    let ratio_q_P2_u_P1_2_of_u_p1_42 = cos_q_P5
        * (sin_q_P1
            * ratio_q_P2_u_P1_2_of_u_p1_23
                .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_39)
            + ratio_q_P2_u_P1_of_place_9 * u_p1_cos_q_p1 + ratio_q_P2_u_P1_2_of_u_p1_41)
        - ratio_q_P2_u_P1_of_place_11 * ratio_q_P2_u_P1_2_of_u_p1_14;
    let ratio_q_P2_u_P1_2_of_u_p1_43 = ratio_q_P2_u_P1_2_of_u_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_44 = (-ratio_q_P2_u_P1_2_of_u_p1_24)
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_p2_w_rod2_frame_3)
        + ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_32
        + cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_43;
    let ratio_q_P2_u_P1_2_of_u_p1_45 = ratio_q_P2_u_P1_2_of_u_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_46 = sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_47 = (-ratio_q_P2_u_P1_2_of_u_p1_18)
        .mul_add(sin_q_P5, ratio_q_P2_u_P1_2_of_u_p1_17 * sin_q_P4)
        - ratio_q_P2_u_P1_2_of_u_p1_45 - ratio_q_P2_u_P1_2_of_u_p1_46;
    let ratio_q_P2_u_P1_2_of_u_p1_48 = ratio_q_P2_u_P1_2_of_u_p1_23
        .mul_add(cos_q_P5, sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_14)
        - ratio_q_P2_u_P1_of_place_6 * sin_q_p2_w_rod2_frame_3
        + ratio_q_P2_u_P1_2_of_u_p1_47 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_49 = u_p1_cos_q_p1
        .mul_add(sin_q_P2, w_rod2_frame_3 * cos_q_p2_sin_q_p1);
    let sin_q_p3_u_p1_sin_q_p1 = u_p1_sin_q_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_50 = ratio_q_P2_u_P1_2_of_u_p1_15 * cos_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_51 = ratio_q_P2_u_P1_2_of_u_p1_29
        - sin_q_p2_sin_q_p3 * ratio_q_P2_u_P1_2_of_u_p1_3
        + sin_q_P4
            * cos_q_p2_w_rod2_frame_3
                .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_15 * sin_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_52 = u_p1_sin_q_p1
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_18 * cos_q_P1);
    let ratio_q_P2_u_P1_2_of_u_p1_53 = ratio_q_P2_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_14
        - ratio_q_P2_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1
        + cos_q_P5
            * ((-sin_q_p2_sin_q_p1)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_18,
                    ratio_q_P2_u_P1_2_of_u_p1_49 * cos_q_P3,
                ) - sin_q_p3_u_p1_sin_q_p1 + ratio_q_P2_u_P1_2_of_u_p1_50)
        - sin_q_P5
            * (ratio_q_P2_u_P1_of_place_3
                .mul_add(u_p1_cos_q_p1, cos_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_3)
                + ratio_q_P2_u_P1_2_of_u_p1_51 * sin_q_P1
                + ratio_q_P2_u_P1_2_of_u_p1_52 * sin_q_P4);
    let ratio_q_P2_u_P1_2_of_u_p1_54 = ratio_q_P2_u_P1_of_place_5
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_44,
            ratio_q_P2_u_P1_of_place_8 * ratio_q_P2_u_P1_2_of_u_p1_42,
        ) - ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_48
        - ratio_q_P2_u_P1_of_place_29 * ratio_q_P2_u_P1_2_of_u_p1_53;
    let ratio_q_P2_u_P1_2_of_u_p1_55 = ratio_q_P2_u_P1_2_of_u_p1_15 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_56 = cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_57 = ratio_q_P2_u_P1_2_of_u_p1_27
        .mul_add(sin_q_P4, -ratio_q_P2_u_P1_2_of_u_p1_43) + ratio_q_P2_u_P1_2_of_u_p1_55
        + ratio_q_P2_u_P1_2_of_u_p1_56;
    let ratio_q_P2_u_P1_2_of_u_p1_58 = (-ratio_q_P2_u_P1_2_of_u_p1_47)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_6 * u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_59 = (-ratio_q_P2_u_P1_of_place_19)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_49,
            sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_57,
        ) + ratio_q_P2_u_P1_2_of_u_p1_58;
    let ratio_q_P2_u_P1_2_of_u_p1_60 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_18, ratio_q_P2_u_P1_2_of_u_p1_17)
        - ratio_q_P2_u_P1_2_of_u_p1_24 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_61 = ratio_q_P2_u_P1_2_of_u_p1_60 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_place = ratio_q_P2_u_P1_of_place_16 * sin_q_p2_w_rod2_frame_3;
    let ratio_q_P2_u_P1_2_of_u_p1_62 = ratio_q_P2_u_P1_2_of_u_p1_61 - ratio_q_P2_u_P1_2_of_place;
    let ratio_q_P2_u_P1_2_of_place_2 = l * ratio_q_P2_u_P1_of_place_21;
    let ratio_q_P2_u_P1_2_of_u_p1_63 = (-ratio_q_P2_u_P1_of_place_68)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_53,
            ratio_q_P2_u_P1_2_of_u_p1_48 * ratio_q_P2_u_P1_2_of_place_2,
        ) - ratio_q_P2_u_P1_of_place_8 * ratio_q_P2_u_P1_2_of_u_p1_59
        - ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_62;
    let ratio_q_P2_u_P1_2_of_u_p1_64 = ratio_q_P2_u_P1_of_place_29
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_59,
            ratio_q_P2_u_P1_of_place_68 * ratio_q_P2_u_P1_2_of_u_p1_42,
        ) - ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_62
        + ratio_q_P2_u_P1_2_of_u_p1_44 * ratio_q_P2_u_P1_2_of_place_2;
    let ratio_q_P2_u_P1_2_of_u_p1_65 = (-ratio_q_P2_u_P1_2_of_u_p1_24)
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_q_p4_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_15)
        + ratio_q_P2_u_P1_2_of_u_p1_27;
    let ratio_q_P2_u_P1_2_of_u_p1_66 = (-ratio_q_P2_u_P1_2_of_u_p1_60)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_16 * u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_67 = l
        * ((-ratio_q_P2_u_P1_of_place_17)
            .mul_add(cos_q_p2_w_rod2_frame_3, ratio_q_P2_u_P1_2_of_u_p1_65 * sin_q_P1)
            - ratio_q_P2_u_P1_of_place_15 * u_p1_cos_q_p1
            + ratio_q_P2_u_P1_2_of_u_p1_66 * sin_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_68 = ratio_q_P2_u_P1_of_q_p3_q_p5
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_23, -ratio_q_P2_u_P1_2_of_u_p1_34)
        + ratio_q_P2_u_P1_of_q_p3_q_p5_3 * ratio_q_P2_u_P1_2_of_u_p1_38
        - sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_43;
    let ratio_q_P2_u_P1_2_of_u_p1_69 = cos_q_p3_cos_q_p1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_70 = l
        * (-u_p1_sin_q_p1
            * ratio_q_P2_u_P1_of_q_p4_q_p5
                .mul_add(cos_q_p3_ratio_q_p4_u_p1, -ratio_q_P2_u_P1_of_place_25)
            + ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_u_p1
            + ratio_q_P2_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_31 * sin_q_P1
            - ratio_q_P2_u_P1_2_of_u_p1_68 * cos_q_P1
            - ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_69);
    let ratio_q_P2_u_P1_2_of_u_p1_71 = (-cos_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_14, ratio_q_P2_u_P1_2_of_u_p1_29 * cos_q_P5)
        + ratio_q_P2_u_P1_of_place_6 * cos_q_p2_w_rod2_frame_3
        + ratio_q_P2_u_P1_2_of_u_p1_47 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_72 = l
        * ((-ratio_q_P2_u_P1_2_of_u_p1_57)
            .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_19 * u_p1_cos_q_p1)
            + ratio_q_P2_u_P1_of_place_31 * u_p1_sin_q_p1
            + ratio_q_P2_u_P1_2_of_u_p1_71 * cos_q_P1);
    let ratio_q_P2_u_P1_2_of_u_p1_73 = (-cos_q_p2_cos_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1,
            ratio_q_P2_u_P1_of_place_34 * cos_q_p2_w_rod2_frame_3,
        ) - ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_29
        - ratio_q_P2_u_P1_2_of_u_p1_65 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_74 = (-ratio_q_P2_u_P1_of_place_31)
        .mul_add(u_p1_cos_q_p1, ratio_q_P2_u_P1_of_place_19 * u_p1_sin_q_p1)
        + ratio_q_P2_u_P1_2_of_u_p1_57 * cos_q_P1 + ratio_q_P2_u_P1_2_of_u_p1_71 * sin_q_P1;
    let cos_q_p2_u_p1_cos_q_p1 = u_p1_cos_q_p1 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_75 = sin_q_p2_w_rod2_frame_3
        .mul_add(sin_q_P1, -cos_q_p2_u_p1_cos_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_76 = l * ratio_q_P2_u_P1_2_of_u_p1_48;
    let ratio_q_P2_u_P1_2_of_u_p1_77 = ratio_q_P2_u_P1_of_place_8 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_78 = ratio_q_P2_u_P1_2_of_u_p1_76
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_2_of_u_p1_77);
    let ratio_q_P2_u_P1_2_of_u_p1_79 = ratio_q_P2_u_P1_of_place_34
        .mul_add(sin_q_p2_w_rod2_frame_3, ratio_q_P2_u_P1_2_of_u_p1_35)
        + ratio_q_P2_u_P1_2_of_u_p1_65 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_80 = ratio_q_P2_u_P1_of_place_83
        * ratio_q_P2_u_P1_2_of_u_p1_53 * sin_q_P1
        + ratio_q_P2_u_P1_of_place_44 * ratio_q_P2_u_P1_2_of_u_p1_74
        - ratio_q_P2_u_P1_of_place_39 * ratio_q_P2_u_P1_2_of_u_p1_78
        + ratio_q_P2_u_P1_of_place_5
            * (-ratio_q_P2_u_P1_2_of_u_p1_79)
                .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_43 * u_p1_cos_q_p1);
    let ratio_q_P2_u_P1_2_of_place_3 = l * ratio_q_P2_u_P1_of_place_45;
    let ratio_q_P2_u_P1_2_of_place_4 = ratio_q_P2_u_P1_of_place_7 * l_sq;
    let ratio_q_P2_u_P1_2_of_u_p1_81 = ratio_q_P2_u_P1_of_q_p5_2
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_18, ratio_q_P2_u_P1_2_of_u_p1_45);
    let ratio_q_P2_u_P1_2_of_u_p1_82 = ratio_q_P2_u_P1_of_q_p3
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_14, ratio_q_P2_u_P1_2_of_u_p1_16)
        + ratio_q_P2_u_P1_2_of_u_p1_81;
    let ratio_q_P2_u_P1_2_of_u_p1_83 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_15, ratio_q_P2_u_P1_2_of_u_p1_43);
    let ratio_q_P2_u_P1_2_of_u_p1_84 = ratio_q_P2_u_P1_of_q_p4_q_p5
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_75,
            cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_24,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_85 = cos_q_p2_sin_q_p1
        * (ratio_q_P2_u_P1_of_place_50
            * u_p1_cos_q_p1.mul_add(cos_q_P5, ratio_q_P2_u_P1_2_of_u_p1_14 * sin_q_P1)
            - ratio_q_P2_u_P1_of_place_48 * ratio_q_P2_u_P1_2_of_u_p1_18
            - cos_q_p5_sin_q_p1
                * (ratio_q_P2_u_P1_2_of_u_p1_37
                    + ratio_q_P2_u_P1_of_place_49 * ratio_q_P2_u_P1_2_of_u_p1_15
                    + sin_q_P3
                        * ratio_q_P2_u_P1_of_q_p3
                            .mul_add(
                                ratio_q_P2_u_P1_2_of_u_p1_23, ratio_q_P2_u_P1_2_of_u_p1_39,
                            ))
            - cos_q_P3
                * (cos_q_P4
                    * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
                        .mul_add(
                            u_p1_sin_q_p1,
                            sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_83,
                        ) - ratio_q_P2_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_49
                        - ratio_q_P2_u_P1_2_of_u_p1_82 * cos_q_P1)
                    - ratio_q_P2_u_P1_of_place_46 * ratio_q_P2_u_P1_2_of_u_p1_21
                    + ratio_q_P2_u_P1_2_of_u_p1_84));
    let ratio_q_P2_u_P1_2_of_u_p1_86 = ratio_q_P2_u_P1_of_place_52 * ratio_q_P2_u_P1_2_of_u_p1_48
        + l * ratio_q_P2_u_P1_of_place_40 * ratio_q_P2_u_P1_2_of_u_p1_73
        + ratio_q_P2_u_P1_of_place_41
            * (l
                * ratio_q_P2_u_P1_of_place_38
                    .mul_add(
                        ratio_q_P2_u_P1_2_of_u_p1_53,
                        ratio_q_P2_u_P1_of_place_39 * ratio_q_P2_u_P1_2_of_u_p1_42,
                    )
                + ratio_q_P2_u_P1_of_place_5
                    * (ratio_q_P2_u_P1_of_place_25
                        .mul_add(
                            u_p1_cos_q_p1,
                            ratio_q_P2_u_P1_of_place_10 * ratio_q_P2_u_P1_2_of_u_p1,
                        ) + ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_41
                        + ratio_q_P2_u_P1_2_of_u_p1_68 * sin_q_P1)
                + ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_74)
        - ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_51 * ratio_q_P2_u_P1_2_of_u_p1_75
        + ratio_q_P2_u_P1_of_place_29 * ratio_q_P2_u_P1_2_of_u_p1_80
        - ratio_q_P2_u_P1_2_of_u_p1_44 * ratio_q_P2_u_P1_2_of_place_3
        + ratio_q_P2_u_P1_2_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_85;
    let ratio_q_P2_u_P1_2_of_u_p1_87 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_4;
    let ratio_q_P2_u_P1_2_of_u_p1_88 = ratio_q_P2_u_P1_2_of_u_p1_87
        - ratio_q_P2_u_P1_of_q_p4_2 * ratio_q_P2_u_P1_2_of_u_p1
        - sin_q_P5 * (ratio_q_P2_u_P1_2_of_u_p1_3 + ratio_q_P2_u_P1_2_of_u_p1_87);
    let ratio_q_P2_u_P1_2_of_u_p1_89 = ratio_q_P2_u_P1_2_of_u_p1_88 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_90 = ratio_q_P2_u_P1_of_q_p4_q_p5_3
        * ratio_q_P2_u_P1_2_of_u_p1_15;
    let ratio_q_P2_u_P1_2_of_u_p1_91 = ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P2_u_P1_2_of_u_p1_24;
    let ratio_q_P2_u_P1_2_of_u_p1_92 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_91;
    let ratio_q_P2_u_P1_2_of_u_p1_93 = ratio_q_P2_u_P1_of_q_p4
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_17, -ratio_q_P2_u_P1_2_of_u_p1_46);
    let ratio_q_P2_u_P1_2_of_u_p1_94 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_3)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_18, ratio_q_P2_u_P1_2_of_u_p1_88 * cos_q_P3);
    let ratio_q_P2_u_P1_2_of_u_p1_95 = ratio_q_P2_u_P1_2_of_u_p1_27 + ratio_q_P2_u_P1_2_of_u_p1_83;
    let ratio_q_P2_u_P1_2_of_u_p1_96 = cos_q_P1
        * (ratio_q_P2_u_P1_2_of_u_p1_17 + ratio_q_P2_u_P1_2_of_u_p1_81);
    let ratio_q_P2_u_P1_2_of_place_5 = ratio_q_P2_u_P1_of_q_p3_q_p5_7 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_97 = sin_q_P1
        * (ratio_q_P2_u_P1_of_place_20 * sin_q_p2_w_rod2_frame_3
            + ratio_q_P2_u_P1_of_place_72 * cos_q_p2_w_rod2_frame_3
            + ratio_q_P2_u_P1_2_of_u_p1_58 * cos_q_P2
            + sin_q_P2
                * (ratio_q_P2_u_P1_of_place_70 * u_p1_cos_q_p1
                    - ratio_q_P4_u_P1 * ratio_q_P2_u_P1_of_q_p3_q_p5_7 * sin_q_p4_u_p1_cos_q_p1
                    + sin_q_P1
                        * (cos_q_P2
                            * (ratio_q_P2_u_P1_of_q_p3_q_p5_5 * ratio_q_P2_u_P1_2_of_u_p1_3
                                - ratio_q_P2_u_P1_of_q_p3 * ratio_q_P2_u_P1_2_of_u_p1
                                + sin_q_P4
                                    * (ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P2_u_P1_2_of_u_p1_27)
                                + ratio_q_P2_u_P1_2_of_u_p1_55)
                            - ratio_q_P2_u_P1_of_q_p3_q_p5_6 * ratio_q_P2_u_P1_2_of_u_p1_23
                            - ratio_q_P2_u_P1_of_place_69 * sin_q_p2_w_rod2_frame_3
                            + sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_95)
                    - ratio_q_P2_u_P1_2_of_u_p1_96 * cos_q_P4
                    + u_p1_cos_q_p4 * ratio_q_P2_u_P1_2_of_place_5))
        + ratio_q_P2_u_P1_of_place_73 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_98 = l_sq * ratio_q_P2_u_P1_2_of_u_p1_73;
    let ratio_q_P2_u_P1_2_of_u_p1_99 = ratio_q_P2_u_P1_of_place_74 * ratio_q_P2_u_P1_2_of_u_p1_48
        - ratio_q_P2_u_P1_of_place_68 * ratio_q_P2_u_P1_2_of_u_p1_80
        - ratio_q_P2_u_P1_2_of_u_p1_62 * ratio_q_P2_u_P1_2_of_place_3
        + ratio_q_P2_u_P1_of_place_67
            * (-u_p1_cos_q_p1
                * (ratio_q_P2_u_P1_of_place_64 * sin_q_p3_sin_q_p1)
                    .mul_add(S::int(2), ratio_q_P2_u_P1_of_place_63)
                + ratio_q_P2_u_P1_of_place_65 * ratio_q_P2_u_P1_2_of_u_p1_50
                - sin_q_P1
                    * (ratio_q_P2_u_P1_of_q_p4_q_p5_4
                        * ratio_q_P2_u_P1_2_of_u_p1_32
                            .mul_add(
                                cos_q_P1,
                                cos_q_p2_sin_q_p1 * u_p1_cos_q_p4 * sin_q_P3,
                            ) + ratio_q_P2_u_P1_of_place_62 * cos_q_p2_w_rod2_frame_3
                        + sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_92
                        + sin_q_P2
                            * (sin_q_p3_cos_q_p1
                                * ratio_q_P2_u_P1_2_of_u_p1_90
                                    .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_89)
                                - ratio_q_P2_u_P1_of_place_61 * ratio_q_P2_u_P1_2_of_u_p1_18
                                - ratio_q_P2_u_P1_of_place_54 * sin_q_p3_u_p1_sin_q_p1
                                + cos_q_P3
                                    * (ratio_q_P2_u_P1_of_place_57 * u_p1_cos_q_p1
                                        + ratio_q_P2_u_P1_of_place_60 * u_p1_sin_q_p1
                                        + sin_q_P1
                                            * (ratio_q_P2_u_P1_of_q_p4_q_p5_4
                                                * ratio_q_P2_u_P1_2_of_u_p1_29
                                                + ratio_q_P2_u_P1_of_place_55 * cos_q_p2_w_rod2_frame_3
                                                + sin_q_P2
                                                    * (ratio_q_P2_u_P1_of_q_p4
                                                        .mul_add(
                                                            ratio_q_P2_u_P1_2_of_u_p1_27,
                                                            ratio_q_P2_u_P1_2_of_u_p1_56,
                                                        ) + ratio_q_P2_u_P1_2_of_u_p1_89
                                                        + ratio_q_P2_u_P1_2_of_u_p1_90)
                                                + ratio_q_P2_u_P1_2_of_u_p1_92)
                                        - cos_q_P1
                                            * ratio_q_P2_u_P1_2_of_u_p1_93
                                                .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_94))))
                + sin_q_p3_cos_q_p1 * cos_q_P1
                    * (ratio_q_P2_u_P1_2_of_u_p1_93 + ratio_q_P2_u_P1_2_of_u_p1_94))
        + ratio_q_P2_u_P1_2_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_97
        - ratio_q_P2_u_P1_of_place_66 * ratio_q_P2_u_P1_2_of_u_p1_98;
    let ratio_q_P2_u_P1_2_of_u_p1_100 = ratio_q_P2_u_P1_of_place_52
        * (-ratio_q_P2_u_P1_2_of_place).mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_61)
        - ratio_q_P2_u_P1_of_place_74 * ratio_q_P2_u_P1_2_of_u_p1_44
        + ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_of_place_51 * cos_q_p2_u_p1_cos_q_p1
        + ratio_q_P2_u_P1_of_place_67
            * (ratio_q_P2_u_P1_of_place_80 * u_p1_cos_q_p1
                - ratio_q_P2_u_P1_of_place_10 * ratio_q_P2_u_P1_2_of_u_p1_96
                + ratio_q_P2_u_P1_of_place_71 * ratio_q_P2_u_P1_2_of_u_p1_40
                - sin_q_P1
                    * (ratio_q_P2_u_P1_of_place_71 * ratio_q_P2_u_P1_2_of_u_p1_37
                        - ratio_q_P2_u_P1_of_place_79 * cos_q_p2_w_rod2_frame_3
                        + sin_q_P2
                            * (cos_q_p3_cos_q_p5
                                * (cos_q_p2_sin_q_p1
                                    .mul_add(
                                        ratio_q_P2_u_P1_2_of_u_p1_3, -ratio_q_P2_u_P1_2_of_u_p1_41,
                                    ) + ratio_q_P2_u_P1_2_of_u_p1_75 * sin_q_P4)
                                - ratio_q_P2_u_P1_of_place_77 * ratio_q_P2_u_P1_2_of_u_p1_15
                                - ratio_q_P2_u_P1_of_place_78 * ratio_q_P2_u_P1_2_of_u_p1_27
                                + sin_q_P3
                                    * (ratio_q_P2_u_P1_2_of_u_p1_84
                                        - ratio_q_P2_u_P1_of_place_76 * ratio_q_P2_u_P1_2_of_u_p1_21
                                        + cos_q_P4
                                            * (ratio_q_P2_u_P1_of_q_p3_q_p5_8 * u_p1_sin_q_p1
                                                - ratio_q_P2_u_P1_of_q_p3_q_p5_6
                                                    * ratio_q_P2_u_P1_2_of_u_p1_49
                                                - cos_q_P1
                                                    * ratio_q_P2_u_P1_2_of_u_p1_81
                                                        .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_17)
                                                + sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_95)))
                        + cos_q_p2_sin_q_p4
                            * ratio_q_P2_u_P1_of_q_p3_q_p5_7
                                .mul_add(u_p1_sin_q_p1, -ratio_q_P2_u_P1_2_of_u_p1_96))
                + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_69 * ratio_q_P2_u_P1_2_of_place_5)
        + l_sq
            * ratio_q_P2_u_P1_of_place
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_97,
                    ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_2_of_u_p1_85,
                ) + ratio_q_P2_u_P1_of_place_81 * ratio_q_P2_u_P1_2_of_u_p1_98;
    let ratio_q_P2_u_P1_2_of_u_p1_101 = l
        * ratio_q_P2_u_P1_2_of_u_p1_79
            .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_43 * u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_102 = ratio_q_P2_u_P1_of_place_101
        * ((-ratio_q_P2_u_P1_of_place_53)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_67,
                l_sq * ratio_q_P2_u_P1_of_place_84 * ratio_q_P2_u_P1_2_of_u_p1_36,
            ) + ratio_q_P2_u_P1_of_place_75 * ratio_q_P2_u_P1_2_of_u_p1_70
            - ratio_q_P2_u_P1_of_place_82 * ratio_q_P2_u_P1_2_of_u_p1_72
            + ratio_q_P2_u_P1_of_place_18 * ratio_q_P2_u_P1_2_of_u_p1_86
            + ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_2_of_u_p1_99
            - ratio_q_P2_u_P1_of_place_32 * ratio_q_P2_u_P1_2_of_u_p1_100
            + ratio_q_P2_u_P1_of_place_100 * ratio_q_P2_u_P1_2_of_u_p1_101);
    let ratio_q_P2_u_P1_2_of_u_p1_103 = ratio_q_P2_u_P1_of_place_104 * ratio_q_P2_u_P1_2_of_u_p1
        + ratio_q_P2_u_P1_of_place_105 * ratio_q_P2_u_P1_2_of_u_p1_14
        + cos_q_P5
            * ((-cos_q_p3_sin_q_p1)
                .mul_add(ratio_q_P2_u_P1_2_of_u_p1_3, sin_q_p4_u_p1_cos_q_p1 * cos_q_P3)
                - ratio_q_P2_u_P1_2_of_u_p1_18 * sin_q_P1 * sin_q_P4
                - ratio_q_P2_u_P1_of_place_3 * u_p1_sin_q_p1
                + ratio_q_P2_u_P1_2_of_u_p1_51 * cos_q_P1)
        + sin_q_P5
            * ((-ratio_q_P2_u_P1_2_of_u_p1_15)
                .mul_add(sin_q_P1, cos_q_p3_cos_q_p1 * cos_q_p2_w_rod2_frame_3)
                - u_p1_cos_q_p1 * sin_q_P3 - ratio_q_P2_u_P1_2_of_u_p1_52 * sin_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_104 = ratio_q_P2_u_P1_of_place_107
        * ratio_q_P2_u_P1_of_place_106
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_102, -ratio_q_P2_u_P1_2_of_u_p1_103);
    let ratio_q_P2_u_P1_2_of_u_p1_105 = ratio_q_P2_u_P1_2_of_u_p1_104
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_108 * ratio_q_P2_u_P1_2_of_u_p1_14);
    let ratio_q_P2_u_P1_2_of_u_p1_106 = ratio_q_P2_u_P1_of_place_36
        .mul_add(u_p1_sin_q_p1, ratio_q_P2_u_P1_of_place_16 * u_p1_cos_q_p1)
        + ratio_q_P2_u_P1_2_of_u_p1_60 * sin_q_P1 - ratio_q_P2_u_P1_2_of_u_p1_73 * cos_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_107 = ratio_q_P2_u_P1_of_place_102
        * ratio_q_P2_u_P1_of_place_37
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_102, -ratio_q_P2_u_P1_2_of_u_p1_106);
    let ratio_q_P2_u_P1_2_of_u_p1_108 = ratio_q_P2_u_P1_of_place_36
        .mul_add(u_p1_cos_q_p1, -ratio_q_P2_u_P1_2_of_u_p1_66)
        + ratio_q_P2_u_P1_2_of_u_p1_73 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_109 = ratio_q_P2_u_P1_of_place_110
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_102, ratio_q_P2_u_P1_2_of_u_p1_108);
    let ratio_q_P2_u_P1_2 = ratio_q_P2_u_P1_of_place_103
        * ((-ratio_q_P2_u_P1_of_place_18)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_54,
                ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_2_of_u_p1_63,
            ) + ratio_q_P2_u_P1_of_place_32 * ratio_q_P2_u_P1_2_of_u_p1_64
            - ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_2_of_u_p1_67
            + ratio_q_P2_u_P1_of_place_23 * ratio_q_P2_u_P1_2_of_u_p1_70
            - ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_2_of_u_p1_72)
        - ratio_q_P2_u_P1_of_place_107 * ratio_q_P2_u_P1_of_place_110 * ratio_q_P2_u_P1_2_of_u_p1_36
        - ratio_q_P2_u_P1_of_place_109 * ratio_q_P2_u_P1_2_of_u_p1_91
        + ratio_q_P2_u_P1_of_q_p4_q_p5_16 * ratio_q_P2_u_P1_2_of_u_p1_105
        + ratio_q_P2_u_P1_of_place_33 * ratio_q_P2_u_P1_2_of_u_p1_107
        + ratio_q_P2_u_P1_of_place_111 * ratio_q_P2_u_P1_2_of_u_p1_109;
    let ratio_q_P3_u_P1_2_of_u_p1 = (-ratio_q_P2_u_P1_of_place_41)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_53,
            S::int(2) * ratio_q_P2_u_P1_of_place_44 * ratio_q_P2_u_P1_2_of_u_p1_48,
        ) - ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_73
        + ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_2_of_u_p1_77;
    let ratio_q_P3_u_P1_2_of_u_p1_2 = (-ratio_q_P2_u_P1_of_place_41)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_42,
            ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_73,
        ) - ratio_q_P2_u_P1_of_place_44 * ratio_q_P2_u_P1_2_of_u_p1_44
        + ratio_q_P2_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_78;
    let ratio_q_P3_u_P1_2_of_u_p1_3 = ratio_q_P2_u_P1_2_of_u_p1_104
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_108 * ratio_q_P2_u_P1_2_of_u_p1_21);
    let ratio_q_P3_u_P1_2_of_u_p1_4 = ratio_q_P2_u_P1_of_place_102 * ratio_q_P2_u_P1_2_of_u_p1_109;
    let ratio_q_P3_u_P1_2 = ratio_q_P3_u_P1_of_place_5
        * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_14, ratio_q_P2_u_P1_2_of_u_p1)
            + ratio_q_P2_u_P1_2_of_u_p1_82 * cos_q_P5 - ratio_q_P2_u_P1_2_of_u_p1_83)
        + ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_86
        + ratio_q_P3_u_P1_of_place_3 * ratio_q_P2_u_P1_2_of_u_p1_107
        + ratio_q_P2_u_P1_of_place_103
            * ((-ratio_q_P2_u_P1_of_place_84)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_54,
                    ratio_q_P3_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_72,
                ) - ratio_q_P3_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_70
                - ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_2_of_u_p1_101
                - ratio_q_P2_u_P1_of_place_27 * ratio_q_P3_u_P1_2_of_u_p1
                + ratio_q_P2_u_P1_of_place_32 * ratio_q_P3_u_P1_2_of_u_p1_2)
        - ratio_q_P3_u_P1_of_q_p3_q_p5 * ratio_q_P3_u_P1_2_of_u_p1_3
        + ratio_q_P2_u_P1_of_place_53 * ratio_q_P3_u_P1_2_of_u_p1_4;
    let ratio_q_P4_u_P1_2_of_u_p1 = ratio_q_P2_u_P1_of_place_41 * ratio_q_P2_u_P1_2_of_u_p1_59
        - ratio_q_P2_u_P1_2_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_73
        + ratio_q_P2_u_P1_of_place_8
            * (-ratio_q_P2_u_P1_of_place_16)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_75,
                    cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_60,
                ) + ratio_q_P4_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_76;
    let ratio_q_P4_u_P1_2_of_u_p1_2 = ratio_q_P2_u_P1_2_of_u_p1_27 - ratio_q_P2_u_P1_2_of_u_p1_15;
    let ratio_q_P4_u_P1_2 = ratio_q_P4_u_P1_of_place_3 * ratio_q_P2_u_P1_2_of_u_p1_107
        - ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_99
        - ratio_q_P4_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_105
        + ratio_q_P2_u_P1_of_place_75 * ratio_q_P3_u_P1_2_of_u_p1_4
        + ratio_q_P2_u_P1_of_place_103
            * ((-ratio_q_P2_u_P1_of_place_84)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_63,
                    ratio_q_P2_u_P1_of_place_32 * ratio_q_P4_u_P1_2_of_u_p1,
                ) - ratio_q_P3_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_67
                - ratio_q_P4_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_72
                - ratio_q_P2_u_P1_of_place_23 * ratio_q_P2_u_P1_2_of_u_p1_101
                - ratio_q_P2_u_P1_of_place_18 * ratio_q_P3_u_P1_2_of_u_p1)
        + ratio_q_P2_u_P1_of_place_109
            * (-ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P4_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_3
                - sin_q_P4
                    * ((-ratio_q_P4_u_P1_of_q_p4_q_p5)
                        .mul_add(
                            ratio_q_P2_u_P1_2_of_u_p1_15,
                            ratio_q_P2_u_P1_2_of_u_p1_91 * sin_q_P3,
                        ) - ratio_q_P2_u_P1_2_of_u_p1_24 - ratio_q_P2_u_P1_2_of_u_p1_27)
                + ratio_q_P4_u_P1_2_of_u_p1_2);
    let ratio_q_P5_u_P1_2 = ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_100
        + ratio_q_P5_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_107
        - ratio_q_P5_u_P1_of_place_2 * ratio_q_P3_u_P1_2_of_u_p1_3
        + ratio_q_P2_u_P1_of_place_82 * ratio_q_P3_u_P1_2_of_u_p1_4
        + ratio_q_P2_u_P1_of_place_103
            * ((-ratio_q_P2_u_P1_of_place_84)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_64,
                    ratio_q_P2_u_P1_of_place_18 * ratio_q_P3_u_P1_2_of_u_p1_2,
                ) - ratio_q_P3_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_67
                - ratio_q_P4_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_70
                - ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_2_of_u_p1_101
                - ratio_q_P2_u_P1_of_place_27 * ratio_q_P4_u_P1_2_of_u_p1)
        + ratio_q_P3_u_P1_of_place_5
            * (ratio_q_P5_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3
                - ratio_q_P5_u_P1_of_q_p3_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1
                + sin_q_P4
                    * ((-(ratio_q_P2_u_P1_2_of_u_p1_2 * sin_q_P3))
                        .mul_add(
                            S::int(2),
                            ratio_q_P2_u_P1_of_q_p5_5 * ratio_q_P2_u_P1_2_of_u_p1_15,
                        ) + ratio_q_P2_u_P1_2_of_u_p1_33)
                + ratio_q_P2_u_P1_of_q_p5 * ratio_q_P4_u_P1_2_of_u_p1_2);
    let w_rod1_frame_22 = u_P1 * u_P1;
    let w_rod2_frame_23 = w_rod1_frame_in_rod2_frame_2 * w_rod2_frame_3;
    let alpha_rod2_frame_1 = w_rod2_frame_23;
    let alpha_rod2_frame_3 = u_P1 * ratio_q_P2_u_P1_2;
    let w_rod2_frame_11 = w_rod1_frame_in_rod2_frame_1 * w_rod1_frame_in_rod2_frame_1;
    let w_rod2_frame_12 = w_rod1_frame_in_rod2_frame_1 * w_rod1_frame_in_rod2_frame_2;
    let w_rod2_frame_33 = w_rod2_frame_3 * w_rod2_frame_3;
    let turn_rod2_frame_12 = alpha_rod2_frame_3 - w_rod2_frame_12;
    let turn_rod2_frame_22 = w_rod2_frame_11 + w_rod2_frame_33;
    let turn_rod2_frame_32 = alpha_rod2_frame_1 + w_rod2_frame_23;
    let alpha_rod2_frame_in_rod3_frame_2 = (-alpha_rod2_frame_3)
        .mul_add(sin_q_P3, w_rod1_frame_in_rod2_frame_1 * cos_q_p3_w_rod2_frame_3);
    let alpha_rod2_frame_in_rod3_frame_3 = w_rod1_frame_in_rod2_frame_1
        .mul_add(sin_q_p3_w_rod2_frame_3, alpha_rod2_frame_3 * cos_q_P3);
    let alpha_rod3_frame_1 = u_P1.mul_add(ratio_q_P3_u_P1_2, alpha_rod2_frame_1);
    let alpha_rod3_frame_2 = w_rod2_frame_in_rod3_frame_3
        .mul_add(u_p1_ratio_q_p3_u_p1, alpha_rod2_frame_in_rod3_frame_2);
    let alpha_rod3_frame_3 = w_rod2_frame_in_rod3_frame_2
        .mul_add(u_p1_ratio_q_p3_u_p1, -alpha_rod2_frame_in_rod3_frame_3);
    let w_rod3_frame_11 = w_rod3_frame_1 * w_rod3_frame_1;
    let w_rod3_frame_13 = w_rod2_frame_in_rod3_frame_3 * w_rod3_frame_1;
    let w_rod3_frame_22 = w_rod2_frame_in_rod3_frame_2 * w_rod2_frame_in_rod3_frame_2;
    let w_rod3_frame_23 = w_rod2_frame_in_rod3_frame_2 * w_rod2_frame_in_rod3_frame_3;
    let turn_rod3_frame_13 = alpha_rod3_frame_2 + w_rod3_frame_13;
    let turn_rod3_frame_23 = alpha_rod3_frame_1 + w_rod3_frame_23;
    let turn_rod3_frame_33 = w_rod3_frame_11 + w_rod3_frame_22;
    let alpha_rod3_frame_in_rod4_frame_1 = alpha_rod3_frame_3
        .mul_add(sin_q_P4, alpha_rod3_frame_1 * cos_q_P4);
    let alpha_rod3_frame_in_rod4_frame_3 = (-alpha_rod3_frame_1)
        .mul_add(sin_q_P4, alpha_rod3_frame_3 * cos_q_P4);
    let alpha_rod4_frame_1 = w_rod3_frame_in_rod4_frame_3
        .mul_add(u_p1_ratio_q_p4_u_p1, -alpha_rod3_frame_in_rod4_frame_1);
    let alpha_rod4_frame_2 = u_P1.mul_add(ratio_q_P4_u_P1_2, alpha_rod3_frame_2);
    let alpha_rod4_frame_3 = w_rod3_frame_in_rod4_frame_1
        .mul_add(u_p1_ratio_q_p4_u_p1, alpha_rod3_frame_in_rod4_frame_3);
    let w_rod4_frame_12 = w_rod3_frame_in_rod4_frame_1 * w_rod4_frame_2;
    let w_rod4_frame_13 = w_rod3_frame_in_rod4_frame_1 * w_rod3_frame_in_rod4_frame_3;
    let w_rod4_frame_22 = w_rod4_frame_2 * w_rod4_frame_2;
    let w_rod4_frame_33 = w_rod3_frame_in_rod4_frame_3 * w_rod3_frame_in_rod4_frame_3;
    let turn_rod4_frame_11 = w_rod4_frame_22 + w_rod4_frame_33;
    let turn_rod4_frame_21 = alpha_rod4_frame_3 + w_rod4_frame_12;
    let turn_rod4_frame_31 = alpha_rod4_frame_2 - w_rod4_frame_13;
    let alpha_rod4_frame_in_rod5_frame_1 = alpha_rod4_frame_2
        .mul_add(sin_q_P5, alpha_rod4_frame_1 * cos_q_P5);
    let alpha_rod5_frame_1 = w_rod4_frame_in_rod5_frame_2
        .mul_add(u_p1_ratio_q_p5_u_p1, -alpha_rod4_frame_in_rod5_frame_1);
    let alpha_rod5_frame_3 = u_P1.mul_add(ratio_q_P5_u_P1_2, alpha_rod4_frame_3);
    let w_rod5_frame_11 = w_rod4_frame_in_rod5_frame_1 * w_rod4_frame_in_rod5_frame_1;
    let w_rod5_frame_12 = w_rod4_frame_in_rod5_frame_1 * w_rod4_frame_in_rod5_frame_2;
    let w_rod5_frame_23 = w_rod4_frame_in_rod5_frame_2 * w_rod5_frame_3;
    let w_rod5_frame_33 = w_rod5_frame_3 * w_rod5_frame_3;
    let turn_rod5_frame_12 = alpha_rod5_frame_3 - w_rod5_frame_12;
    let turn_rod5_frame_22 = w_rod5_frame_11 + w_rod5_frame_33;
    let turn_rod5_frame_32 = alpha_rod5_frame_1 + w_rod5_frame_23;
    let a_rod1_centre_1 = l * w_rod1_frame_22;
    let a_rod1_frame_in_rod2_frame_1 = (-g)
        .mul_add(sin_q_P2, a_rod1_centre_1 * cos_q_P2);
    let a_rod1_frame_in_rod2_frame_2 = a_rod1_centre_1.mul_add(sin_q_P2, g * cos_q_P2);
    let l_turn_rod2_frame_12 = l * turn_rod2_frame_12;
    let a_rod2_centre_1 = a_rod1_frame_in_rod2_frame_1
        .mul_add(S::int(2), l_turn_rod2_frame_12);
    let a_rod2_centre_3 = l * turn_rod2_frame_32;
    let J_rod5_frame_11 = m * l_sq;
    let H_rod2_1 = w_rod1_frame_in_rod2_frame_1 * J_rod5_frame_11;
    let H_rod2_3 = w_rod2_frame_3 * J_rod5_frame_11;
    let a_rod3_centre_1 = a_rod1_frame_in_rod2_frame_1 + l_turn_rod2_frame_12;
    let a_rod3_centre_2 = l.mul_add(turn_rod2_frame_22, -a_rod1_frame_in_rod2_frame_2);
    let a_rod2_frame_in_rod3_frame_2 = (-a_rod2_centre_3)
        .mul_add(sin_q_P3, a_rod3_centre_2 * cos_q_P3);
    let a_rod2_frame_in_rod3_frame_3 = a_rod3_centre_2
        .mul_add(sin_q_P3, a_rod2_centre_3 * cos_q_P3);
    let l_turn_rod3_frame_13 = l * turn_rod3_frame_13;
    let a_rod3_centre_1_2 = a_rod3_centre_1.mul_add(S::int(2), l_turn_rod3_frame_13);
    let l_turn_rod3_frame_23 = l * turn_rod3_frame_23;
    let a_rod3_centre_2_2 = a_rod2_frame_in_rod3_frame_2
        .mul_add(S::int(2), l_turn_rod3_frame_23);
    let l_turn_rod3_frame_33 = l * turn_rod3_frame_33;
    let a_rod3_centre_3 = (-a_rod2_frame_in_rod3_frame_3)
        .mul_add(S::int(2), l_turn_rod3_frame_33);
    let H_rod3_1 = w_rod3_frame_1 * J_rod5_frame_11;
    let H_rod3_2 = w_rod2_frame_in_rod3_frame_2 * J_rod5_frame_11;
    let a_rod4_centre_1 = a_rod3_centre_1 + l_turn_rod3_frame_13;
    let a_rod4_centre_2 = a_rod2_frame_in_rod3_frame_2 + l_turn_rod3_frame_23;
    let a_rod4_centre_3 = l_turn_rod3_frame_33 - a_rod2_frame_in_rod3_frame_3;
    let a_rod3_frame_in_rod4_frame_1 = (-a_rod4_centre_1)
        .mul_add(cos_q_P4, a_rod4_centre_3 * sin_q_P4);
    let a_rod3_frame_in_rod4_frame_3 = a_rod4_centre_3
        .mul_add(cos_q_P4, a_rod4_centre_1 * sin_q_P4);
    let l_turn_rod4_frame_11 = l * turn_rod4_frame_11;
    let a_rod4_centre_1_2 = a_rod3_frame_in_rod4_frame_1
        .mul_add(S::int(2), l_turn_rod4_frame_11);
    let l_turn_rod4_frame_21 = l * turn_rod4_frame_21;
    let a_rod4_centre_2_2 = (-a_rod4_centre_2).mul_add(S::int(2), l_turn_rod4_frame_21);
    let l_turn_rod4_frame_31 = l * turn_rod4_frame_31;
    let a_rod4_centre_3_2 = a_rod3_frame_in_rod4_frame_3
        .mul_add(S::int(2), l_turn_rod4_frame_31);
    let H_rod4_2 = w_rod4_frame_2 * J_rod5_frame_11;
    let H_rod4_3 = w_rod3_frame_in_rod4_frame_3 * J_rod5_frame_11;
    let a_rod5_centre_1 = a_rod3_frame_in_rod4_frame_1 + l_turn_rod4_frame_11;
    let a_rod5_centre_2 = l_turn_rod4_frame_21 - a_rod4_centre_2;
    let a_rod5_centre_3 = a_rod3_frame_in_rod4_frame_3 + l_turn_rod4_frame_31;
    let a_rod4_frame_in_rod5_frame_1 = a_rod5_centre_2
        .mul_add(sin_q_P5, a_rod5_centre_1 * cos_q_P5);
    let a_rod4_frame_in_rod5_frame_2 = (-a_rod5_centre_2)
        .mul_add(cos_q_P5, a_rod5_centre_1 * sin_q_P5);
    let a_rod5_centre_1_2 = (-a_rod4_frame_in_rod5_frame_1)
        .mul_add(S::int(2), l * turn_rod5_frame_12);
    let a_rod5_centre_2_2 = (-a_rod4_frame_in_rod5_frame_2)
        .mul_add(S::int(2), l * turn_rod5_frame_22);
    let a_rod5_centre_3_2 = a_rod5_centre_3.mul_add(S::int(2), l * turn_rod5_frame_32);
    let H_rod5_1 = w_rod4_frame_in_rod5_frame_1 * J_rod5_frame_11;
    let H_rod5_3 = w_rod5_frame_3 * J_rod5_frame_11;
    let F_v_rod5_centre_3 = m * a_rod5_centre_3_2;
    let F_v_rod5_centre_1 = m * a_rod5_centre_1_2;
    let F_v_rod4_frame_in_rod5_frame_2 = m * a_rod5_centre_2_2;
    let F_v_rod5_centre_2 = (-F_v_rod5_centre_1)
        .mul_add(sin_q_P5, F_v_rod4_frame_in_rod5_frame_2 * cos_q_P5);
    let F_v_rod4_centre_3 = m * a_rod4_centre_3_2;
    let F_v_rod4_centre_2 = m * a_rod4_centre_2_2;
    let F_v_rod3_frame_in_rod4_frame_3 = F_v_rod5_centre_3 + F_v_rod4_centre_3;
    let F_v_rod3_frame_in_rod4_frame_1 = (-F_v_rod5_centre_1)
        .mul_add(cos_q_P5, m * a_rod4_centre_1_2) - F_v_rod4_frame_in_rod5_frame_2 * sin_q_P5;
    let F_v_rod4_centre_2_2 = F_v_rod5_centre_2 + F_v_rod4_centre_2;
    let F_v_rod4_centre_1 = (-F_v_rod3_frame_in_rod4_frame_1)
        .mul_add(cos_q_P4, F_v_rod3_frame_in_rod4_frame_3 * sin_q_P4);
    let F_v_rod3_centre_2 = m * a_rod3_centre_2_2;
    let F_v_rod3_centre_1 = m * a_rod3_centre_1_2;
    let F_v_rod2_frame_in_rod3_frame_3 = F_v_rod3_frame_in_rod4_frame_3
        .mul_add(cos_q_P4, m * a_rod3_centre_3) + F_v_rod3_frame_in_rod4_frame_1 * sin_q_P4;
    let F_v_rod2_frame_in_rod3_frame_2 = F_v_rod4_centre_2_2 - F_v_rod3_centre_2;
    let F_v_rod3_centre_3 = (-F_v_rod2_frame_in_rod3_frame_2)
        .mul_add(sin_q_P3, F_v_rod2_frame_in_rod3_frame_3 * cos_q_P3);
    let F_v_rod2_centre_3 = m * a_rod2_centre_3;
    let F_v_rod2_centre_1_of_place = F_v_rod4_centre_1 + F_v_rod3_centre_1;
    let F_v_rod2_centre_1 = F_v_rod2_centre_1_of_place
        .mul_add(S::int(2), m * a_rod2_centre_1);
    let F_v_rod1_centre_3 = F_v_rod3_centre_3 - F_v_rod2_centre_3;
    let l_times_3 = S::int(3) * l;
    let F_w_rod5_frame_3 = (-alpha_rod5_frame_3)
        .mul_add(J_rod5_frame_11, w_rod4_frame_in_rod5_frame_2 * H_rod5_1)
        - F_v_rod5_centre_1 * l_times_3;
    let F_w_rod4_frame_in_rod5_frame_2 = (-w_rod4_frame_in_rod5_frame_1)
        .mul_add(H_rod5_3, w_rod5_frame_3 * H_rod5_1);
    let F_w_rod4_frame_in_rod5_frame_1 = alpha_rod5_frame_1
        .mul_add(J_rod5_frame_11, w_rod4_frame_in_rod5_frame_2 * H_rod5_3)
        + F_v_rod5_centre_3 * l_times_3;
    let l_times_6 = S::int(6) * l;
    let F_w_rod4_frame_2 = (-F_w_rod4_frame_in_rod5_frame_2)
        .mul_add(cos_q_P5, w_rod3_frame_in_rod4_frame_1 * H_rod4_3)
        + F_w_rod4_frame_in_rod5_frame_1 * sin_q_P5
        - alpha_rod4_frame_2 * J_rod5_frame_11 - F_v_rod4_centre_3 * l_times_3
        - F_v_rod5_centre_3 * l_times_6;
    let F_w_rod3_frame_in_rod4_frame_3 = w_rod3_frame_in_rod4_frame_1
        .mul_add(H_rod4_2, -F_w_rod5_frame_3) + alpha_rod4_frame_3 * J_rod5_frame_11
        + F_v_rod4_centre_2 * l_times_3 + F_v_rod5_centre_2 * l_times_6;
    let F_w_rod3_frame_in_rod4_frame_1 = (-w_rod3_frame_in_rod4_frame_3)
        .mul_add(H_rod4_2, w_rod4_frame_2 * H_rod4_3) + F_w_rod4_frame_in_rod5_frame_2 * sin_q_P5
        + F_w_rod4_frame_in_rod5_frame_1 * cos_q_P5;
    let F_w_rod3_frame_1 = (-F_w_rod3_frame_in_rod4_frame_3)
        .mul_add(sin_q_P4, w_rod2_frame_in_rod3_frame_3 * H_rod3_2)
        + F_w_rod3_frame_in_rod4_frame_1 * cos_q_P4
        + alpha_rod3_frame_1 * J_rod5_frame_11 + F_v_rod3_centre_2 * l_times_3
        - F_v_rod4_centre_2_2 * l_times_6;
    let F_w_rod2_frame_in_rod3_frame_3 = (-w_rod2_frame_in_rod3_frame_2)
        .mul_add(H_rod3_1, w_rod3_frame_1 * H_rod3_2) - F_w_rod3_frame_in_rod4_frame_3 * cos_q_P4
        - F_w_rod3_frame_in_rod4_frame_1 * sin_q_P4;
    let F_w_rod2_frame_in_rod3_frame_2 = w_rod2_frame_in_rod3_frame_3
        .mul_add(H_rod3_1, -F_w_rod4_frame_2) + alpha_rod3_frame_2 * J_rod5_frame_11
        + F_v_rod3_centre_1 * l_times_3 + F_v_rod4_centre_1 * l_times_6;
    let F_w_rod2_frame_3 = (-F_w_rod2_frame_in_rod3_frame_3)
        .mul_add(cos_q_P3, w_rod1_frame_in_rod2_frame_2 * H_rod2_1)
        + F_w_rod2_frame_in_rod3_frame_2 * sin_q_P3
        - alpha_rod2_frame_3 * J_rod5_frame_11 - F_v_rod2_centre_1 * l_times_3;
    let F_w_rod1_frame_in_rod2_frame_2 = (-w_rod1_frame_in_rod2_frame_1)
        .mul_add(H_rod2_3, w_rod2_frame_3 * H_rod2_1) - F_w_rod2_frame_in_rod3_frame_3 * sin_q_P3
        - F_w_rod2_frame_in_rod3_frame_2 * cos_q_P3;
    let F_w_rod1_frame_in_rod2_frame_1 = w_rod1_frame_in_rod2_frame_2
        .mul_add(H_rod2_3, F_w_rod3_frame_1) + alpha_rod2_frame_1 * J_rod5_frame_11
        + F_v_rod2_centre_3 * l_times_3 - F_v_rod3_centre_3 * l_times_6;
    let mr_rod5_frame_2 = l * m;
    let rw_rod5_frame_2 = l * mr_rod5_frame_2;
    let J_rod5_frame_11_2 = rw_rod5_frame_2.mul_add(S::int(3), J_rod5_frame_11);
    let s_rod5_frame_in_rod4_frame_1 = mr_rod5_frame_2 * sin_q_P5;
    let s_rod5_frame_in_rod4_frame_2 = mr_rod5_frame_2 * cos_q_P5;
    let J_rod5_frame_in_rod4_frame = J_rod5_frame_11_2 * sin_q_P5;
    let J_rod5_frame_in_rod4_frame_2 = J_rod5_frame_in_rod4_frame * sin_q_P5;
    let J_rod5_frame_in_rod4_frame_11 = J_rod5_frame_11_2 - J_rod5_frame_in_rod4_frame_2;
    let J_rod5_frame_in_rod4_frame_12 = J_rod5_frame_in_rod4_frame * cos_q_P5;
    let s_rod4_frame_1 = mr_rod5_frame_2
        .mul_add(S::int(2), -s_rod5_frame_in_rod4_frame_1);
    let w_rod4_frame_1 = s_rod5_frame_in_rod4_frame_1 - s_rod4_frame_1;
    let rw_rod4_frame_1 = l * w_rod4_frame_1;
    let s_rod4_frame_1_2 = mr_rod5_frame_2 + s_rod4_frame_1;
    let J_rod4_frame_12_of_place = s_rod5_frame_in_rod4_frame_2 * l_times_6;
    let J_rod4_frame_12 = J_rod5_frame_in_rod4_frame_12 - J_rod4_frame_12_of_place;
    let J_rod4_frame_22_of_place = (-rw_rod4_frame_1)
        .mul_add(S::int(6), J_rod5_frame_11_2);
    let J_rod4_frame_22 = J_rod5_frame_in_rod4_frame_2 + J_rod4_frame_22_of_place;
    let J_rod4_frame_33 = J_rod5_frame_11_2 + J_rod4_frame_22_of_place;
    let s_rod4_frame_in_rod3_frame_1 = s_rod4_frame_1_2 * cos_q_P4;
    let s_rod4_frame_in_rod3_frame_3 = s_rod4_frame_1_2 * sin_q_P4;
    let J_rod4_frame_in_rod3_frame_1 = J_rod4_frame_12 * cos_q_P4;
    let J_rod4_frame_in_rod3_frame_3 = J_rod4_frame_12 * sin_q_P4;
    let J_rod4_frame_in_rod3_frame_31 = J_rod5_frame_in_rod4_frame_11 - J_rod4_frame_33;
    let J_rod4_frame_in_rod3_frame = J_rod4_frame_in_rod3_frame_31 * sin_q_P4;
    let J_rod4_frame_in_rod3_frame_2 = J_rod4_frame_in_rod3_frame * sin_q_P4;
    let J_rod4_frame_in_rod3_frame_11 = J_rod5_frame_in_rod4_frame_11
        - J_rod4_frame_in_rod3_frame_2;
    let J_rod4_frame_in_rod3_frame_13 = J_rod4_frame_in_rod3_frame * cos_q_P4;
    let J_rod4_frame_in_rod3_frame_33 = J_rod4_frame_33 + J_rod4_frame_in_rod3_frame_2;
    let s_rod3_frame_3 = mr_rod5_frame_2
        .mul_add(S::int(4), s_rod4_frame_in_rod3_frame_3);
    let w_rod3_frame_3 = s_rod4_frame_in_rod3_frame_3 + s_rod3_frame_3;
    let rw_rod3_frame_3 = l * w_rod3_frame_3;
    let s_rod3_frame_3_2 = mr_rod5_frame_2 + s_rod3_frame_3;
    let J_rod3_frame_11_of_place = rw_rod3_frame_3.mul_add(S::int(6), J_rod5_frame_11_2);
    let J_rod3_frame_11 = J_rod4_frame_in_rod3_frame_11 + J_rod3_frame_11_of_place;
    let J_rod3_frame_13_of_place = s_rod4_frame_in_rod3_frame_1 * l_times_6;
    let J_rod3_frame_13 = J_rod4_frame_in_rod3_frame_13 - J_rod3_frame_13_of_place;
    let J_rod3_frame_22 = J_rod4_frame_22 + J_rod3_frame_11_of_place;
    let J_rod3_frame_23 = J_rod4_frame_12_of_place - J_rod4_frame_in_rod3_frame_3;
    let s_rod3_frame_in_rod2_frame_2 = s_rod3_frame_3_2
        .mul_add(sin_q_P3, s_rod5_frame_in_rod4_frame_2 * cos_q_P3);
    let s_rod3_frame_in_rod2_frame_3 = (-s_rod3_frame_3_2)
        .mul_add(cos_q_P3, s_rod5_frame_in_rod4_frame_2 * sin_q_P3);
    let J_rod3_frame_in_rod2_frame_2 = J_rod3_frame_13
        .mul_add(sin_q_P3, J_rod4_frame_in_rod3_frame_1 * cos_q_P3);
    let J_rod3_frame_in_rod2_frame_3 = (-J_rod3_frame_13)
        .mul_add(cos_q_P3, J_rod4_frame_in_rod3_frame_1 * sin_q_P3);
    let J_rod3_frame_in_rod2_frame_23 = J_rod4_frame_in_rod3_frame_33 - J_rod3_frame_22;
    let J_rod3_frame_in_rod2_frame = (-J_rod3_frame_23)
        .mul_add(cos_q_p3_doubled, J_rod3_frame_in_rod2_frame_23 * sin_q_P3);
    let J_rod3_frame_in_rod2_frame_2_ = J_rod3_frame_in_rod2_frame * sin_q_P3;
    let J_rod3_frame_in_rod2_frame_22 = J_rod3_frame_22 + J_rod3_frame_in_rod2_frame_2_;
    let J_rod3_frame_in_rod2_frame_23_2 = J_rod3_frame_in_rod2_frame
        .mul_add(cos_q_P3, J_rod3_frame_23);
    let J_rod3_frame_in_rod2_frame_33 = J_rod4_frame_in_rod3_frame_33
        - J_rod3_frame_in_rod2_frame_2_;
    let s_rod2_frame_2 = mr_rod5_frame_2
        .mul_add(S::int(6), -s_rod3_frame_in_rod2_frame_2);
    let w_rod2_frame_2 = s_rod3_frame_in_rod2_frame_2 - s_rod2_frame_2;
    let rw_rod2_frame_2 = l * w_rod2_frame_2;
    let s_rod2_frame_2_2 = mr_rod5_frame_2 + s_rod2_frame_2;
    let J_rod2_frame_11_of_place = (-rw_rod2_frame_2)
        .mul_add(S::int(6), J_rod5_frame_11_2);
    let J_rod2_frame_11 = J_rod3_frame_11 + J_rod2_frame_11_of_place;
    let J_rod2_frame_12 = J_rod3_frame_in_rod2_frame_2 + J_rod3_frame_13_of_place;
    let J_rod2_frame_23 = (-s_rod3_frame_in_rod2_frame_3)
        .mul_add(l_times_6, J_rod3_frame_in_rod2_frame_23_2);
    let J_rod2_frame_33 = J_rod3_frame_in_rod2_frame_33 + J_rod2_frame_11_of_place;
    let s_rod2_frame_in_rod1_frame_1 = s_rod2_frame_2_2
        .mul_add(sin_q_P2, s_rod4_frame_in_rod3_frame_1 * cos_q_P2);
    let J_rod2_frame_in_rod1_frame_2 = (-J_rod2_frame_23)
        .mul_add(cos_q_P2, J_rod3_frame_in_rod2_frame_3 * sin_q_P2);
    let J_rod2_frame_in_rod1_frame_12 = J_rod3_frame_in_rod2_frame_22 - J_rod2_frame_11;
    let J_rod2_frame_in_rod1_frame = (-(J_rod2_frame_12 * cos_q_P2))
        .mul_add(S::int(2), J_rod2_frame_in_rod1_frame_12 * sin_q_P2);
    let J_rod2_frame_in_rod1_frame_2_ = J_rod2_frame_in_rod1_frame * sin_q_P2;
    let J_rod2_frame_in_rod1_frame_22 = J_rod3_frame_in_rod2_frame_22
        - J_rod2_frame_in_rod1_frame_2_;
    let s_rod1_frame_1 = mr_rod5_frame_2
        .mul_add(S::int(8), -s_rod2_frame_in_rod1_frame_1);
    let w_rod1_frame_1 = s_rod2_frame_in_rod1_frame_1 - s_rod1_frame_1;
    let rw_rod1_frame_1 = l * w_rod1_frame_1;
    let J_rod1_frame_22 = (-rw_rod1_frame_1)
        .mul_add(S::int(6), J_rod5_frame_11_2 + J_rod2_frame_in_rod1_frame_22);
    let h_rod3_frame_rod2_frame_1_of_place = s_rod3_frame_in_rod2_frame_2 * l_times_6;
    let h_rod3_frame_rod2_frame_1 = J_rod3_frame_11 - h_rod3_frame_rod2_frame_1_of_place;
    let h_rod3_frame_in_rod2_frame_2 = h_rod3_frame_rod2_frame_1
        .mul_add(sin_q_P2, J_rod3_frame_in_rod2_frame_2 * cos_q_P2);
    let h_rod3_frame_rod1_frame_2 = h_rod3_frame_in_rod2_frame_2
        + h_rod3_frame_rod2_frame_1_of_place;
    let h_rod4_frame_rod3_frame_2_of_place = s_rod4_frame_in_rod3_frame_3 * l_times_6;
    let h_rod4_frame_rod3_frame_2 = J_rod4_frame_22 + h_rod4_frame_rod3_frame_2_of_place;
    let p_rod4_frame_in_rod3_frame_3 = s_rod4_frame_in_rod3_frame_1 * cos_q_P3;
    let h_rod4_frame_in_rod3_frame_2 = h_rod4_frame_rod3_frame_2
        .mul_add(cos_q_P3, J_rod4_frame_in_rod3_frame_3 * sin_q_P3);
    let h_rod4_frame_in_rod3_frame_3 = (-J_rod4_frame_in_rod3_frame_3)
        .mul_add(cos_q_P3, h_rod4_frame_rod3_frame_2 * sin_q_P3);
    let h_rod4_frame_rod2_frame_1_of_place = p_rod4_frame_in_rod3_frame_3 * l_times_6;
    let h_rod4_frame_rod2_frame_1 = J_rod4_frame_in_rod3_frame_1
        + h_rod4_frame_rod2_frame_1_of_place;
    let h_rod4_frame_rod2_frame_3 = h_rod4_frame_rod3_frame_2_of_place
        - h_rod4_frame_in_rod3_frame_3;
    let h_rod4_frame_in_rod2_frame_2 = h_rod4_frame_rod2_frame_1
        .mul_add(sin_q_P2, h_rod4_frame_in_rod3_frame_2 * cos_q_P2);
    let h_rod4_frame_rod1_frame_2 = h_rod4_frame_rod2_frame_1_of_place
        - h_rod4_frame_in_rod2_frame_2;
    let h_rod5_frame_rod4_frame_3_of_place = s_rod5_frame_in_rod4_frame_1 * l_times_6;
    let h_rod5_frame_rod4_frame_3 = J_rod5_frame_11_2 - h_rod5_frame_rod4_frame_3_of_place;
    let p_rod5_frame_in_rod4_frame_1 = s_rod5_frame_in_rod4_frame_2 * cos_q_P4;
    let p_rod5_frame_in_rod4_frame_3 = s_rod5_frame_in_rod4_frame_2 * sin_q_P4;
    let h_rod5_frame_in_rod4_frame_1 = h_rod5_frame_rod4_frame_3 * sin_q_P4;
    let h_rod5_frame_in_rod4_frame_3 = h_rod5_frame_rod4_frame_3 * cos_q_P4;
    let h_rod5_frame_rod3_frame_1 = h_rod5_frame_rod4_frame_3_of_place
        - h_rod5_frame_in_rod4_frame_1;
    let h_rod5_frame_rod3_frame_2 = l * p_rod5_frame_in_rod4_frame_1;
    let p_rod5_frame_in_rod3_frame_3 = (-p_rod5_frame_in_rod4_frame_3)
        .mul_add(cos_q_P3, s_rod5_frame_in_rod4_frame_1 * sin_q_P3);
    let h_rod5_frame_in_rod3_frame_2_of_place = S::int(6) * h_rod5_frame_rod3_frame_2;
    let h_rod5_frame_in_rod3_frame_2 = (-h_rod5_frame_in_rod4_frame_3)
        .mul_add(sin_q_P3, h_rod5_frame_in_rod3_frame_2_of_place * cos_q_P3);
    let h_rod5_frame_in_rod3_frame_3 = h_rod5_frame_in_rod3_frame_2_of_place
        .mul_add(sin_q_P3, h_rod5_frame_in_rod4_frame_3 * cos_q_P3);
    let h_rod5_frame_rod2_frame_1_of_place = p_rod5_frame_in_rod3_frame_3 * l_times_6;
    let h_rod5_frame_rod2_frame_1 = h_rod5_frame_rod3_frame_1 - h_rod5_frame_rod2_frame_1_of_place;
    let h_rod5_frame_rod2_frame_3 = p_rod5_frame_in_rod4_frame_1
        .mul_add(l_times_6, -h_rod5_frame_in_rod3_frame_3);
    let h_rod5_frame_in_rod2_frame_2 = (-h_rod5_frame_in_rod3_frame_2)
        .mul_add(cos_q_P2, h_rod5_frame_rod2_frame_1 * sin_q_P2);
    let h_rod5_frame_rod1_frame_2 = h_rod5_frame_in_rod2_frame_2
        + h_rod5_frame_rod2_frame_1_of_place;
    let ratio_q_p4_u_p1_doubled = S::int(2) * ratio_q_P4_u_P1;
    let ratio_q_p5_u_p1_doubled = S::int(2) * ratio_q_P5_u_P1;
    let d1_of_place = ratio_q_P3_u_P1
        .mul_add(J_rod3_frame_in_rod2_frame_3, J_rod2_frame_in_rod1_frame_2);
    let d1_of_place_2 = J_rod1_frame_22
        + ratio_q_P2_u_P1
            * (h_rod4_frame_rod2_frame_3
                .mul_add(ratio_q_p4_u_p1_doubled, ratio_q_P2_u_P1 * J_rod2_frame_33)
                + h_rod5_frame_rod2_frame_3 * ratio_q_p5_u_p1_doubled + S::int(2) * d1_of_place);
    let d1_of_place_3 = ratio_q_P4_u_P1
        * h_rod4_frame_rod1_frame_2.mul_add(S::int(2), ratio_q_P4_u_P1 * J_rod4_frame_22)
        + ratio_q_P3_u_P1
            * (h_rod3_frame_rod1_frame_2
                .mul_add(S::int(2), ratio_q_P3_u_P1 * J_rod3_frame_11)
                - J_rod4_frame_in_rod3_frame_1 * ratio_q_p4_u_p1_doubled
                + h_rod5_frame_rod3_frame_1 * ratio_q_p5_u_p1_doubled);
    let d1_of_place_4 = ratio_q_P5_u_P1
        * h_rod5_frame_rod1_frame_2
            .mul_add(S::int(2), ratio_q_P5_u_P1 * J_rod5_frame_11_2) + d1_of_place_2;
    let d1_of_place_5 = d1_of_place_3 + d1_of_place_4;
    let d1 = S::ratio(1, 12) * d1_of_place_5;
    let u_P1_dot = S::ratio(1, 12)
        * (ratio_q_P4_u_P1.mul_add(F_w_rod4_frame_2, ratio_q_P5_u_P1 * F_w_rod5_frame_3)
            - ratio_q_P3_u_P1 * F_w_rod3_frame_1 + ratio_q_P2_u_P1 * F_w_rod2_frame_3
            - F_w_rod1_frame_in_rod2_frame_2 * cos_q_P2
            - F_w_rod1_frame_in_rod2_frame_1 * sin_q_P2 - F_v_rod1_centre_3 * l_times_6) / d1;
    [u_P1_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 392 operations, 5 sines and cosines.
#[must_use]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 1]) -> [S; 5] {
    let Parameters { l, .. } = *p;
    let [q_P1, q_P2, q_P3, q_P4, q_P5] = *q;
    let [u_P1] = *u;
    // Sines and cosines.
    let (sin_q_P5, cos_q_P5) = q_P5.sin_cos();
    let (sin_q_P4, cos_q_P4) = q_P4.sin_cos();
    let (sin_q_P3, cos_q_P3) = q_P3.sin_cos();
    let (sin_q_P2, cos_q_P2) = q_P2.sin_cos();
    let (sin_q_P1, cos_q_P1) = q_P1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // 1 - sin(q_P5)
    let ratio_q_P2_u_P1_of_q_p5 = S::int(1) - sin_q_P5;
    let cos_q_p5_sq = cos_q_P5 * cos_q_P5;
    // 2*ratio_q_P2_u_P1_of_q_p5 - cos_q_p5_sq
    let ratio_q_P2_u_P1_of_q_p5_2 = ratio_q_P2_u_P1_of_q_p5
        .mul_add(S::int(2), -cos_q_p5_sq);
    // -ratio_q_P2_u_P1_of_q_p5_2
    let ratio_q_P2_u_P1_of_q_p5_3 = -ratio_q_P2_u_P1_of_q_p5_2;
    let cos_q_p4_sq = cos_q_P4 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5 = ratio_q_P2_u_P1_of_q_p5_3 * cos_q_p4_sq;
    // ratio_q_P2_u_P1_of_q_p5 - cos_q_p5_sq
    let ratio_q_P2_u_P1_of_q_p5_4 = ratio_q_P2_u_P1_of_q_p5 - cos_q_p5_sq;
    // -ratio_q_P2_u_P1_of_q_p5
    let ratio_q_P2_u_P1_of_q_p5_5 = -ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_2 = ratio_q_P2_u_P1_of_q_p5_5 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_3 = ratio_q_P2_u_P1_of_q_p4_q_p5_2 * cos_q_P4;
    // -sin(q_P4)*(ratio_q_P2_u_P1_of_q_p4_q_p5 + ratio_q_P2_u_P1_of_q_p5_4) -
    //   ratio_q_P2_u_P1_of_q_p4_q_p5_3
    let ratio_q_P2_u_P1_of_q_p4_q_p5_4 = -sin_q_P4
        * (ratio_q_P2_u_P1_of_q_p4_q_p5 + ratio_q_P2_u_P1_of_q_p5_4)
        - ratio_q_P2_u_P1_of_q_p4_q_p5_3;
    // ratio_q_P2_u_P1_of_q_p4_q_p5_4 - ratio_q_P2_u_P1_of_q_p5_4
    let ratio_q_P2_u_P1_of_q_p4_q_p5_5 = ratio_q_P2_u_P1_of_q_p4_q_p5_4 - ratio_q_P2_u_P1_of_q_p5_4;
    // 1 + sin(q_P4)
    let ratio_q_P2_u_P1_of_q_p4 = S::int(1) + sin_q_P4;
    // ratio_q_P2_u_P1_of_q_p5*(ratio_q_P2_u_P1_of_q_p4 - 2*cos_q_p4_sq)
    let ratio_q_P2_u_P1_of_q_p4_q_p5_6 = ratio_q_P2_u_P1_of_q_p5
        * (-cos_q_p4_sq).mul_add(S::int(2), ratio_q_P2_u_P1_of_q_p4);
    let sin_q_p3_cos_q_p5 = sin_q_P3 * cos_q_P5;
    // cos(q_P3)*(ratio_q_P2_u_P1_of_q_p4_q_p5_5*cos(q_P3) +
    //   ratio_q_P2_u_P1_of_q_p4_q_p5_6*sin_q_p3_cos_q_p5)
    let ratio_q_P2_u_P1_of_place = cos_q_P3
        * ratio_q_P2_u_P1_of_q_p4_q_p5_6
            .mul_add(sin_q_p3_cos_q_p5, ratio_q_P2_u_P1_of_q_p4_q_p5_5 * cos_q_P3);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_7 = ratio_q_P2_u_P1_of_q_p5_5 * sin_q_P4;
    // ratio_q_P2_u_P1_of_q_p4_q_p5_7 - ratio_q_P2_u_P1_of_q_p4_q_p5
    let ratio_q_P2_u_P1_of_q_p4_q_p5_8 = ratio_q_P2_u_P1_of_q_p4_q_p5_7
        - ratio_q_P2_u_P1_of_q_p4_q_p5;
    // cos_q_p5_sq - 3*ratio_q_P2_u_P1_of_q_p5 + 2*ratio_q_P2_u_P1_of_q_p4_q_p5_8
    let ratio_q_P2_u_P1_of_q_p4_q_p5_9 = (-ratio_q_P2_u_P1_of_q_p5)
        .mul_add(S::int(3), cos_q_p5_sq) + S::int(2) * ratio_q_P2_u_P1_of_q_p4_q_p5_8;
    // 2*ratio_q_P2_u_P1_of_q_p4_q_p5_7 - ratio_q_P2_u_P1_of_q_p5
    let ratio_q_P2_u_P1_of_q_p4_q_p5_10 = ratio_q_P2_u_P1_of_q_p4_q_p5_7
        .mul_add(S::int(2), -ratio_q_P2_u_P1_of_q_p5);
    let cos_q_p3_cos_q_p5 = cos_q_P3 * cos_q_P5;
    let sin_q_p2_cos_q_p4 = sin_q_P2 * cos_q_P4;
    let cos_q_p2_cos_q_p4 = cos_q_P2 * cos_q_P4;
    // sin(q_P2)*(ratio_q_P2_u_P1_of_q_p4_q_p5_5*sin(q_P3) -
    //   ratio_q_P2_u_P1_of_q_p4_q_p5_6*cos_q_p3_cos_q_p5)
    let ratio_q_P2_u_P1_of_place_2 = sin_q_P2
        * (-ratio_q_P2_u_P1_of_q_p4_q_p5_6)
            .mul_add(cos_q_p3_cos_q_p5, ratio_q_P2_u_P1_of_q_p4_q_p5_5 * sin_q_P3);
    let ratio_q_P2_u_P1_of_place_3 = ratio_q_P2_u_P1_of_q_p4_q_p5_2 * sin_q_P2;
    let cos_q_p2_sin_q_p3 = cos_q_P2 * sin_q_P3;
    // cos(q_P1)*(sin(q_P1)*(ratio_q_P2_u_P1_of_q_p4_q_p5_5 - 2*ratio_q_P2_u_P1_of_place +
    //   cos(q_P2)*(cos(q_P2)*(ratio_q_P2_u_P1_of_q_p5 + sin(q_P4)*(ratio_q_P2_u_P1_of_q_p5 +
    //   2*ratio_q_P2_u_P1_of_q_p4_q_p5) + 2*ratio_q_P2_u_P1_of_q_p4_q_p5_3 + ratio_q_P2_u_P1_of_place) -
    //   sin_q_p2_cos_q_p4*(ratio_q_P2_u_P1_of_q_p4_q_p5_9*sin(q_P3) +
    //   ratio_q_P2_u_P1_of_q_p4_q_p5_10*cos_q_p3_cos_q_p5))) -
    //   cos(q_P1)*(cos(q_P5)*(ratio_q_P2_u_P1_of_q_p4_q_p5_6*sin(q_P2) +
    //   ratio_q_P2_u_P1_of_q_p4_q_p5_10*cos_q_p2_cos_q_p4*sin(q_P3)) +
    //   cos(q_P3)*(2*ratio_q_P2_u_P1_of_place_2 - ratio_q_P2_u_P1_of_q_p4_q_p5_9*cos_q_p2_cos_q_p4))) +
    //   cos(q_P3)*(cos_q_p2_cos_q_p4*(ratio_q_P2_u_P1_of_q_p5_2 - ratio_q_P2_u_P1_of_q_p4_q_p5_8) +
    //   ratio_q_P2_u_P1_of_place_2) + cos(q_P4)*cos(q_P5)*(ratio_q_P2_u_P1_of_place_3 +
    //   ratio_q_P2_u_P1_of_q_p4_q_p5_7*cos_q_p2_sin_q_p3)
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
    // 1 - cos_q_p3_cos_q_p5
    let ratio_q_P2_u_P1_of_q_p3_q_p5 = S::int(1) - cos_q_p3_cos_q_p5;
    // ratio_q_P2_u_P1_of_q_p4_q_p5_7 - 1
    let ratio_q_P2_u_P1_of_q_p4_q_p5_11 = ratio_q_P2_u_P1_of_q_p4_q_p5_7 - S::int(1);
    let ratio_q_P2_u_P1_of_place_5 = ratio_q_P2_u_P1_of_q_p4_q_p5_11 * sin_q_P3;
    // -ratio_q_P2_u_P1_of_q_p3_q_p5 - ratio_q_P2_u_P1_of_place_5
    let ratio_q_P2_u_P1_of_place_6 = -ratio_q_P2_u_P1_of_q_p3_q_p5 - ratio_q_P2_u_P1_of_place_5;
    // ratio_q_P2_u_P1_of_q_p4_q_p5_2*cos(q_P2) + ratio_q_P2_u_P1_of_place_6*sin(q_P2)
    let ratio_q_P2_u_P1_of_place_7 = ratio_q_P2_u_P1_of_place_6
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5_2 * cos_q_P2);
    // 1 + ratio_q_P2_u_P1_of_place_7
    let ratio_q_P2_u_P1_of_place_8 = S::int(1) + ratio_q_P2_u_P1_of_place_7;
    // sin_q_p3_cos_q_p5 + ratio_q_P2_u_P1_of_q_p4_q_p5_11*cos(q_P3)
    let ratio_q_P2_u_P1_of_place_9 = ratio_q_P2_u_P1_of_q_p4_q_p5_11
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p5);
    let ratio_q_P2_u_P1_of_place_10 = ratio_q_P2_u_P1_of_place_9 * cos_q_P1;
    // ratio_q_P2_u_P1_of_place_8*sin(q_P1) + ratio_q_P2_u_P1_of_place_10
    let ratio_q_P2_u_P1_of_place_11 = ratio_q_P2_u_P1_of_place_8
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_10);
    let l_sq = l * l;
    // ratio_q_P2_u_P1_of_q_p4_q_p5_7*cos(q_P2) + ratio_q_P2_u_P1_of_place_3*sin(q_P3)
    let ratio_q_P2_u_P1_of_place_12 = ratio_q_P2_u_P1_of_place_3
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_q_p4_q_p5_7 * cos_q_P2);
    let cos_q_p3_cos_q_p1 = cos_q_P1 * cos_q_P3;
    let sin_q_p3_cos_q_p1 = cos_q_P1 * sin_q_P3;
    let sin_q_p2_sin_q_p1 = sin_q_P1 * sin_q_P2;
    // sin(q_P2)*sin(q_P3)*sin(q_P4) - cos_q_p2_cos_q_p4
    let ratio_q_P2_u_P1_of_place_13 = (sin_q_P2 * sin_q_P3)
        .mul_add(sin_q_P4, -cos_q_p2_cos_q_p4);
    // l*(cos(q_P5)*(sin_q_p3_cos_q_p1 + sin_q_p2_sin_q_p1*cos(q_P3)) +
    //   sin(q_P5)*(cos_q_p3_cos_q_p1*sin(q_P4) - ratio_q_P2_u_P1_of_place_13*sin(q_P1)))
    let ratio_q_P2_u_P1_of_place_14 = l
        * (cos_q_P5 * sin_q_p2_sin_q_p1.mul_add(cos_q_P3, sin_q_p3_cos_q_p1)
            + sin_q_P5
                * (-ratio_q_P2_u_P1_of_place_13)
                    .mul_add(sin_q_P1, cos_q_p3_cos_q_p1 * sin_q_P4));
    // cos_q_p3_cos_q_p5*sin(q_P4) - sin(q_P3)*sin(q_P5)
    let ratio_q_P2_u_P1_of_place_15 = (-sin_q_P3)
        .mul_add(sin_q_P5, cos_q_p3_cos_q_p5 * sin_q_P4);
    // cos(q_P3)*sin(q_P5) + sin_q_p3_cos_q_p5*sin(q_P4)
    let ratio_q_P2_u_P1_of_place_16 = sin_q_p3_cos_q_p5
        .mul_add(sin_q_P4, cos_q_P3 * sin_q_P5);
    // cos_q_p2_cos_q_p4*cos(q_P5) - ratio_q_P2_u_P1_of_place_16*sin(q_P2)
    let ratio_q_P2_u_P1_of_place_17 = (-ratio_q_P2_u_P1_of_place_16)
        .mul_add(sin_q_P2, cos_q_p2_cos_q_p4 * cos_q_P5);
    // ratio_q_P2_u_P1_of_place_15*cos(q_P1) + ratio_q_P2_u_P1_of_place_17*sin(q_P1)
    let ratio_q_P2_u_P1_of_place_18 = ratio_q_P2_u_P1_of_place_17
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_15 * cos_q_P1);
    let cos_q_p2_sin_q_p4 = cos_q_P2 * sin_q_P4;
    let ratio_q_P2_u_P1_of_place_19 = cos_q_p3_cos_q_p1 * cos_q_P4;
    // cos(q_P5)*(ratio_q_P2_u_P1_of_place_19 - sin(q_P1)*(sin_q_p2_cos_q_p4*sin(q_P3) +
    //   cos_q_p2_sin_q_p4))
    let ratio_q_P2_u_P1_of_place_20 = cos_q_P5
        * (ratio_q_P2_u_P1_of_place_19
            - sin_q_P1 * sin_q_p2_cos_q_p4.mul_add(sin_q_P3, cos_q_p2_sin_q_p4));
    let ratio_q_P2_u_P1_of_place_21 = l * ratio_q_P2_u_P1_of_place_20;
    let ratio_q_P2_u_P1_of_place_22 = l * ratio_q_P2_u_P1_of_place_7;
    // ratio_q_P2_u_P1_of_place_6*cos(q_P2) - ratio_q_P2_u_P1_of_place_3
    let ratio_q_P2_u_P1_of_place_23 = ratio_q_P2_u_P1_of_place_6
        .mul_add(cos_q_P2, -ratio_q_P2_u_P1_of_place_3);
    let ratio_q_P2_u_P1_of_place_24 = ratio_q_P2_u_P1_of_place_16 * cos_q_P2;
    // sin_q_p2_cos_q_p4*cos(q_P5) + ratio_q_P2_u_P1_of_place_24
    let ratio_q_P2_u_P1_of_place_25 = sin_q_p2_cos_q_p4
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_24);
    let ratio_q_P2_u_P1_of_place_26 = l * ratio_q_P2_u_P1_of_place_25;
    let ratio_q_P2_u_P1_of_place_27 = ratio_q_P2_u_P1_of_place_26 * sin_q_P1;
    // ratio_q_P2_u_P1_of_place_14*ratio_q_P2_u_P1_of_place_23*sin(q_P1) -
    //   ratio_q_P2_u_P1_of_place_18*ratio_q_P2_u_P1_of_place_27
    let ratio_q_P2_u_P1_of_place_28 = (-ratio_q_P2_u_P1_of_place_18)
        .mul_add(
            ratio_q_P2_u_P1_of_place_27,
            ratio_q_P2_u_P1_of_place_14 * ratio_q_P2_u_P1_of_place_23 * sin_q_P1,
        );
    // ratio_q_P2_u_P1_of_q_p4_q_p5_2*cos_q_p2_sin_q_p3 - ratio_q_P2_u_P1_of_q_p4_q_p5_7*sin(q_P2)
    let ratio_q_P2_u_P1_of_place_29 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_7)
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5_2 * cos_q_p2_sin_q_p3);
    let ratio_q_P2_u_P1_of_place_30 = l * ratio_q_P2_u_P1_of_place_29;
    let ratio_q_P2_u_P1_of_place_31 = l_sq * ratio_q_P2_u_P1_of_place_25;
    // sin(q_P3) - 1
    let ratio_q_P2_u_P1_of_q_p3 = sin_q_P3 - S::int(1);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_2 = ratio_q_P2_u_P1_of_q_p5_5 * cos_q_P3;
    // ratio_q_P2_u_P1_of_q_p3_q_p5_2 - ratio_q_P2_u_P1_of_q_p3*cos(q_P5)
    let ratio_q_P2_u_P1_of_q_p3_q_p5_3 = (-ratio_q_P2_u_P1_of_q_p3)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_q_p3_q_p5_2);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_4 = ratio_q_P2_u_P1_of_q_p5_5 * sin_q_P3;
    let cos_q_p2_sin_q_p1 = sin_q_P1 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_32 = ratio_q_P2_u_P1_of_q_p4_q_p5_7 * cos_q_p2_sin_q_p1;
    // cos_q_p2_sin_q_p1*(sin(q_P1)*cos(q_P5)*(cos_q_p2_sin_q_p4 - sin(q_P3)*(cos_q_p2_sin_q_p4 +
    //   sin_q_p2_cos_q_p4*ratio_q_P2_u_P1_of_q_p3)) +
    //   cos(q_P3)*(cos(q_P4)*(sin_q_p2_sin_q_p1*ratio_q_P2_u_P1_of_q_p3_q_p5_4 -
    //   ratio_q_P2_u_P1_of_q_p3_q_p5_3*cos(q_P1)) + ratio_q_P2_u_P1_of_place_32))
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
    // ratio_q_P2_u_P1_of_place_22*(ratio_q_P2_u_P1_of_place_14*(ratio_q_P2_u_P1_of_place_12*sin(q_P1) -
    //   ratio_q_P2_u_P1_of_q_p4_q_p5_2*cos_q_p3_cos_q_p1) -
    //   ratio_q_P2_u_P1_of_place_18*ratio_q_P2_u_P1_of_place_21) +
    //   ratio_q_P2_u_P1_of_place_28*ratio_q_P2_u_P1_of_place_30 +
    //   ratio_q_P2_u_P1_of_place_31*ratio_q_P2_u_P1_of_place_33
    let ratio_q_P2_u_P1_of_place_34 = ratio_q_P2_u_P1_of_place_22
        * (ratio_q_P2_u_P1_of_place_14
            * (-ratio_q_P2_u_P1_of_q_p4_q_p5_2)
                .mul_add(cos_q_p3_cos_q_p1, ratio_q_P2_u_P1_of_place_12 * sin_q_P1)
            - ratio_q_P2_u_P1_of_place_18 * ratio_q_P2_u_P1_of_place_21)
        + ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_of_place_30
        + ratio_q_P2_u_P1_of_place_31 * ratio_q_P2_u_P1_of_place_33;
    // l*(sin(q_P1)*(cos_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_place_5) +
    //   ratio_q_P2_u_P1_of_place_10*sin(q_P2))
    let ratio_q_P2_u_P1_of_place_35 = l
        * (sin_q_P1 * (cos_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_place_5)
            + ratio_q_P2_u_P1_of_place_10 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_36 = ratio_q_P2_u_P1_of_place_9 * cos_q_P2;
    // cos_q_p3_cos_q_p5 + ratio_q_P2_u_P1_of_q_p3_q_p5_4
    let ratio_q_P2_u_P1_of_q_p3_q_p5_5 = cos_q_p3_cos_q_p5 + ratio_q_P2_u_P1_of_q_p3_q_p5_4;
    // cos(q_P1)*(sin_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_2)
    let ratio_q_P2_u_P1_of_place_37 = cos_q_P1
        * (sin_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_2);
    // sin(q_P1)*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P4)*(ratio_q_P2_u_P1_of_q_p5 - cos_q_p3_cos_q_p5)
    //   + ratio_q_P2_u_P1_of_q_p3*sin(q_P5)) - sin_q_p2_cos_q_p4*ratio_q_P2_u_P1_of_q_p3_q_p5_5) -
    //   ratio_q_P2_u_P1_of_place_37*cos(q_P4)) - ratio_q_P2_u_P1_of_place_24*cos(q_P1))
    let ratio_q_P2_u_P1_of_place_38 = sin_q_P1
        * (sin_q_P2
            * (sin_q_P1
                * (cos_q_P2
                    * (sin_q_P4 * (ratio_q_P2_u_P1_of_q_p5 - cos_q_p3_cos_q_p5)
                        + ratio_q_P2_u_P1_of_q_p3 * sin_q_P5)
                    - sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p3_q_p5_5)
                - ratio_q_P2_u_P1_of_place_37 * cos_q_P4) - ratio_q_P2_u_P1_of_place_24 * cos_q_P1);
    // cos_q_p4_sq + sin(q_P5)*(ratio_q_P2_u_P1_of_q_p4 - cos_q_p4_sq)
    let ratio_q_P2_u_P1_of_q_p4_q_p5_12 = cos_q_p4_sq
        + sin_q_P5 * (ratio_q_P2_u_P1_of_q_p4 - cos_q_p4_sq);
    let ratio_q_P2_u_P1_of_place_39 = ratio_q_P2_u_P1_of_q_p4_q_p5_12 * sin_q_P3;
    // sin(q_P5) + ratio_q_P2_u_P1_of_q_p4_q_p5_7
    let ratio_q_P2_u_P1_of_q_p4_q_p5_13 = sin_q_P5 + ratio_q_P2_u_P1_of_q_p4_q_p5_7;
    let ratio_q_P2_u_P1_of_place_40 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p4_q_p5_13;
    let ratio_q_P2_u_P1_of_place_41 = ratio_q_P2_u_P1_of_q_p4_q_p5_12 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_42 = ratio_q_P2_u_P1_of_q_p4 * sin_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_43 = ratio_q_P2_u_P1_of_place_7 * l_sq;
    // l*ratio_q_P2_u_P1_of_place_28*ratio_q_P2_u_P1_of_place_36 -
    //   ratio_q_P2_u_P1_of_place_31*ratio_q_P2_u_P1_of_place_38 -
    //   ratio_q_P2_u_P1_of_place_43*(sin_q_p3_cos_q_p1*cos(q_P1)*(ratio_q_P2_u_P1_of_place_41 +
    //   ratio_q_P2_u_P1_of_place_42) + sin(q_P1)*(sin_q_p3_cos_q_p1*ratio_q_P2_u_P1_of_place_40 +
    //   sin(q_P2)*(cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(ratio_q_P2_u_P1_of_q_p4*cos_q_p3_cos_q_p5 -
    //   ratio_q_P2_u_P1_of_place_39) + ratio_q_P2_u_P1_of_place_40) + cos(q_P1)*(ratio_q_P2_u_P1_of_place_41
    //   + 2*ratio_q_P2_u_P1_of_place_42)) - sin_q_p3_cos_q_p1*ratio_q_P2_u_P1_of_place_39)))
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
    // l*(ratio_q_P2_u_P1_of_place_12*cos(q_P1) + ratio_q_P2_u_P1_of_q_p4_q_p5_2*cos_q_p3_sin_q_p1)
    let ratio_q_P2_u_P1_of_place_45 = l
        * ratio_q_P2_u_P1_of_q_p4_q_p5_2
            .mul_add(cos_q_p3_sin_q_p1, ratio_q_P2_u_P1_of_place_12 * cos_q_P1);
    // l_sq*(ratio_q_P2_u_P1_of_place_33*ratio_q_P2_u_P1_of_place_36 +
    //   ratio_q_P2_u_P1_of_place_29*ratio_q_P2_u_P1_of_place_38) +
    //   ratio_q_P2_u_P1_of_place_43*(sin(q_P1)*(sin(q_P2)*(cos_q_p3_cos_q_p5*(cos_q_p2_sin_q_p1*sin(q_P4) -
    //   ratio_q_P2_u_P1_of_place_19) + sin(q_P3)*(ratio_q_P2_u_P1_of_place_32 +
    //   cos(q_P4)*(cos(q_P1)*(sin_q_p3_cos_q_p5 - 2*ratio_q_P2_u_P1_of_q_p3_q_p5_2) +
    //   sin_q_p2_sin_q_p1*ratio_q_P2_u_P1_of_q_p3_q_p5_5))) + cos_q_p2_sin_q_p4*ratio_q_P2_u_P1_of_place_37)
    //   - ratio_q_P2_u_P1_of_place_19*ratio_q_P2_u_P1_of_place_37)
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
    // l*(ratio_q_P2_u_P1_of_place_15*sin(q_P1) - ratio_q_P2_u_P1_of_place_17*cos(q_P1))
    let ratio_q_P2_u_P1_of_place_47 = l
        * (-ratio_q_P2_u_P1_of_place_17)
            .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_15 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_48 = l * ratio_q_P2_u_P1_of_place_23 * cos_q_P1;
    // l/(ratio_q_P2_u_P1_of_place_44*ratio_q_P2_u_P1_of_place_45 -
    //   ratio_q_P2_u_P1_of_place_34*ratio_q_P2_u_P1_of_place_35 +
    //   ratio_q_P2_u_P1_of_place_46*ratio_q_P2_u_P1_of_place_47 +
    //   ratio_q_P2_u_P1_of_place_4*l_sq*ratio_q_P2_u_P1_of_place_48)
    let ratio_q_P2_u_P1_of_place_49 = l
        / ((-ratio_q_P2_u_P1_of_place_34)
            .mul_add(
                ratio_q_P2_u_P1_of_place_35,
                ratio_q_P2_u_P1_of_place_44 * ratio_q_P2_u_P1_of_place_45,
            ) + ratio_q_P2_u_P1_of_place_46 * ratio_q_P2_u_P1_of_place_47
            + ratio_q_P2_u_P1_of_place_4 * l_sq * ratio_q_P2_u_P1_of_place_48);
    let ratio_q_P2_u_P1_of_place_50 = l_sq * ratio_q_P2_u_P1_of_place_49;
    // ratio_q_P2_u_P1_of_place_20*ratio_q_P2_u_P1_of_place_26 +
    //   ratio_q_P2_u_P1_of_place_14*ratio_q_P2_u_P1_of_place_29
    let ratio_q_P2_u_P1_of_place_51 = ratio_q_P2_u_P1_of_place_14
        .mul_add(
            ratio_q_P2_u_P1_of_place_29,
            ratio_q_P2_u_P1_of_place_20 * ratio_q_P2_u_P1_of_place_26,
        );
    // sin_q_p2_sin_q_p1*ratio_q_P2_u_P1_of_place_15 + ratio_q_P2_u_P1_of_place_16*cos(q_P1)
    let ratio_q_P2_u_P1_of_place_52 = ratio_q_P2_u_P1_of_place_16
        .mul_add(cos_q_P1, sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_of_place_15);
    // ratio_q_P2_u_P1_of_place_14*ratio_q_P2_u_P1_of_place_36 -
    //   ratio_q_P2_u_P1_of_place_26*ratio_q_P2_u_P1_of_place_52
    let ratio_q_P2_u_P1_of_place_53 = (-ratio_q_P2_u_P1_of_place_26)
        .mul_add(
            ratio_q_P2_u_P1_of_place_52,
            ratio_q_P2_u_P1_of_place_14 * ratio_q_P2_u_P1_of_place_36,
        );
    // ratio_q_P2_u_P1_of_place_21*ratio_q_P2_u_P1_of_place_36 +
    //   ratio_q_P2_u_P1_of_place_30*ratio_q_P2_u_P1_of_place_52
    let ratio_q_P2_u_P1_of_place_54 = ratio_q_P2_u_P1_of_place_30
        .mul_add(
            ratio_q_P2_u_P1_of_place_52,
            ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_of_place_36,
        );
    // ratio_q_P2_u_P1_of_place_49*(ratio_q_P2_u_P1_of_place_8*cos(q_P1) -
    //   ratio_q_P2_u_P1_of_place_9*sin(q_P1))
    let ratio_q_P2_u_P1_of_place_55 = ratio_q_P2_u_P1_of_place_49
        * (-ratio_q_P2_u_P1_of_place_9)
            .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_8 * cos_q_P1);
    // ratio_q_P2_u_P1_of_place_50*(sin(q_P5)*(sin(q_P1)*sin(q_P3) - cos_q_p3_cos_q_p1*sin(q_P2)) -
    //   cos(q_P5)*(ratio_q_P2_u_P1_of_place_13*cos(q_P1) + cos_q_p3_sin_q_p1*sin(q_P4)))
    let ratio_q_P2_u_P1_of_place_56 = ratio_q_P2_u_P1_of_place_50
        * (sin_q_P5 * (-cos_q_p3_cos_q_p1).mul_add(sin_q_P2, sin_q_P1 * sin_q_P3)
            - cos_q_P5
                * cos_q_p3_sin_q_p1
                    .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_place_13 * cos_q_P1));
    let ratio_q_P2_u_P1_of_place_57 = ratio_q_P2_u_P1_of_place_56 * cos_q_P5;
    // ratio_q_P2_u_P1 = l^3*(sin(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1)))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 +
    //   cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5)
    //   - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
    //   + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
    //   cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) -
    //   cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) +
    //   2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 +
    //   2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) -
    //   cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
    //   2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) +
    //   cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
    //   cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 -
    //   2*sin(q_P5) - cos(q_P5)^2))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 +
    //   cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5)
    //   - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
    //   + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
    //   cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) -
    //   cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) +
    //   2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 +
    //   2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) -
    //   cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
    //   2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) +
    //   cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
    //   cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 -
    //   2*sin(q_P5) - cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
    //   sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))))
    //   + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) -
    //   sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
    //   cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) + cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 +
    //   sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2))))) -
    //   cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) -
    //   cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
    //   sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) -
    //   1) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)) - sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) +
    //   sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
    //   sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 -
    //   sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4)) + sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) +
    //   cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) +
    //   l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) -
    //   cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) -
    //   cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) +
    //   l^3*cos(q_P5)*(sin(q_P5)*(sin(q_P1)*sin(q_P3) - cos(q_P1)*sin(q_P2)*cos(q_P3)) -
    //   cos(q_P5)*(sin(q_P1)*cos(q_P3)*sin(q_P4) + cos(q_P1)*(sin(q_P2)*sin(q_P3)*sin(q_P4) -
    //   cos(q_P2)*cos(q_P4))))*(sin(q_P5) - 1 + sin(q_P4)*(sin(q_P5) -
    //   1))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 +
    //   cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5)
    //   - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
    //   + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
    //   cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) -
    //   cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) +
    //   2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 +
    //   2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) -
    //   cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
    //   2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) +
    //   cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
    //   cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 -
    //   2*sin(q_P5) - cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
    //   sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))))
    //   + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) -
    //   sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
    //   cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) + cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 +
    //   sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2))))) -
    //   cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) -
    //   cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
    //   sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) -
    //   1) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)) - sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) +
    //   sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
    //   sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 -
    //   sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4)) + sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) +
    //   cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) +
    //   l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) -
    //   cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) -
    //   cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l*(cos(q_P1)*(1 +
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1)))) - sin(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1)
    //   - 1)))*(l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) +
    //   sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(l*cos(q_P5)*(cos(q_P1)*cos(q_P3)*cos(q_P4) - sin(q_P1)*(cos(q_P2)*sin(q_P4) +
    //   sin(q_P2)*sin(q_P3)*cos(q_P4)))*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))) + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3)))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(l*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) +
    //   sin(q_P1)*sin(q_P2)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5))) -
    //   l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
    //   sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))))
    //   - l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l*cos(q_P2)*cos(q_P5)*(cos(q_P1)*cos(q_P3)*cos(q_P4) -
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)))*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(cos(q_P1)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)) + sin(q_P1)*sin(q_P2)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
    //   sin(q_P3)*sin(q_P5)))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 +
    //   cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5)
    //   - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
    //   + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
    //   cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) -
    //   cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) +
    //   2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 +
    //   2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) -
    //   cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
    //   2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) +
    //   cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
    //   cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 -
    //   2*sin(q_P5) - cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
    //   sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))))
    //   + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) -
    //   sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
    //   cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) + cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 +
    //   sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2))))) -
    //   cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) -
    //   cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
    //   sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) -
    //   1) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)) - sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) +
    //   sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
    //   sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 -
    //   sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4)) + sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) +
    //   cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) +
    //   l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) -
    //   cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) -
    //   cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))))
    let ratio_q_P2_u_P1 = ratio_q_P2_u_P1_of_place_55
        * ((-ratio_q_P2_u_P1_of_place_45)
            .mul_add(
                ratio_q_P2_u_P1_of_place_53,
                ratio_q_P2_u_P1_of_place_35 * ratio_q_P2_u_P1_of_place_51,
            ) - ratio_q_P2_u_P1_of_place_47 * ratio_q_P2_u_P1_of_place_54)
        + ratio_q_P2_u_P1_of_place_4 * ratio_q_P2_u_P1_of_place_11 * ratio_q_P2_u_P1_of_place_50
        + ratio_q_P2_u_P1_of_place_57 * (ratio_q_P2_u_P1_of_q_p4_q_p5_7 - ratio_q_P2_u_P1_of_q_p5);
    // ratio_q_P2_u_P1_of_place_7*ratio_q_P2_u_P1_of_place_14 -
    //   ratio_q_P2_u_P1_of_place_25*ratio_q_P2_u_P1_of_place_27
    let ratio_q_P3_u_P1_of_place = (-ratio_q_P2_u_P1_of_place_25)
        .mul_add(
            ratio_q_P2_u_P1_of_place_27,
            ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_14,
        );
    // ratio_q_P2_u_P1_of_place_20*ratio_q_P2_u_P1_of_place_22 +
    //   ratio_q_P2_u_P1_of_place_27*ratio_q_P2_u_P1_of_place_29
    let ratio_q_P3_u_P1_of_place_2 = ratio_q_P2_u_P1_of_place_27
        .mul_add(
            ratio_q_P2_u_P1_of_place_29,
            ratio_q_P2_u_P1_of_place_20 * ratio_q_P2_u_P1_of_place_22,
        );
    let ratio_q_P3_u_P1_of_place_3 = ratio_q_P2_u_P1_of_place_11 * ratio_q_P2_u_P1_of_place_49;
    let ratio_q_P3_u_P1_of_place_4 = ratio_q_P2_u_P1_of_place_56 * cos_q_P4;
    // ratio_q_P3_u_P1 = l*(sin(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1)))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) +
    //   sin(q_P2)*sin(q_P3)*cos(q_P4)) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
    //   sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))))
    //   + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) -
    //   sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
    //   cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1))))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 +
    //   cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5)
    //   - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
    //   + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
    //   cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) -
    //   cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) +
    //   2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 +
    //   2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) -
    //   cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
    //   2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) +
    //   cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
    //   cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 -
    //   2*sin(q_P5) - cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
    //   sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))))
    //   + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) -
    //   sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
    //   cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) + cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 +
    //   sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2))))) -
    //   cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) -
    //   cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
    //   sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) -
    //   1) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)) - sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) +
    //   sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
    //   sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 -
    //   sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4)) + sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) +
    //   cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) +
    //   l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) -
    //   cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) -
    //   cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l*(cos(q_P1)*(1 +
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1)))) - sin(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1)
    //   - 1)))*(l*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*cos(q_P5)*(cos(q_P1)*cos(q_P3)*cos(q_P4) -
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)))*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))) + l*(sin(q_P2)*sin(q_P4)*(1 -
    //   sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
    //   sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))))
    //   + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) + cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1)
    //   + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
    //   sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))) -
    //   l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))^2) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
    //   sin(q_P3)*sin(q_P5)) + cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l*cos(q_P5)*(cos(q_P1)*cos(q_P3)*cos(q_P4) -
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)))*(cos(q_P2)*cos(q_P4)*(sin(q_P5) -
    //   1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))) +
    //   l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5))
    //   + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 +
    //   cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5)
    //   - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
    //   + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
    //   cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) -
    //   cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) +
    //   2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 +
    //   2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) -
    //   cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
    //   2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) +
    //   cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
    //   cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 -
    //   2*sin(q_P5) - cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
    //   sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))))
    //   + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) -
    //   sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
    //   cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) + cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 +
    //   sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2))))) -
    //   cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) -
    //   cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
    //   sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) -
    //   1) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)) - sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) +
    //   sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
    //   sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 -
    //   sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4)) + sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) +
    //   cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) +
    //   l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) -
    //   cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) -
    //   cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) +
    //   l^3*cos(q_P4)*(cos(q_P5)*(sin(q_P1)*cos(q_P3)*sin(q_P4) + cos(q_P1)*(sin(q_P2)*sin(q_P3)*sin(q_P4) -
    //   cos(q_P2)*cos(q_P4))) - sin(q_P5)*(sin(q_P1)*sin(q_P3) - cos(q_P1)*sin(q_P2)*cos(q_P3)))*(sin(q_P5)
    //   - 1 + sin(q_P3)*(1 - sin(q_P5)) + cos(q_P5)*(cos(q_P5)*(1 - sin(q_P3)) + cos(q_P3)*(sin(q_P5) -
    //   1)))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 +
    //   cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5)
    //   - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
    //   + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
    //   cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) -
    //   cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) +
    //   2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 +
    //   2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) -
    //   cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
    //   2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) +
    //   cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
    //   cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 -
    //   2*sin(q_P5) - cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
    //   sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))))
    //   + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) -
    //   sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
    //   cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) + cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 +
    //   sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2))))) -
    //   cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) -
    //   cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
    //   sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) -
    //   1) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)) - sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) +
    //   sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
    //   sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 -
    //   sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4)) + sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) +
    //   cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) +
    //   l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) -
    //   cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) -
    //   cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))))
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
    // ratio_q_P2_u_P1_of_place_22*ratio_q_P2_u_P1_of_place_52 -
    //   ratio_q_P2_u_P1_of_place_9*ratio_q_P2_u_P1_of_place_26*cos_q_p2_sin_q_p1
    let ratio_q_P4_u_P1_of_place = (-(ratio_q_P2_u_P1_of_place_9 * ratio_q_P2_u_P1_of_place_26))
        .mul_add(
            cos_q_p2_sin_q_p1,
            ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_of_place_52,
        );
    // ratio_q_P4_u_P1 = l*(sin(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) + cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 +
    //   sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2))))) -
    //   cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) -
    //   cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
    //   sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) -
    //   1) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)) - sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) +
    //   sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
    //   sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 -
    //   sin(q_P5))))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5)
    //   - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 +
    //   cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5)
    //   - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
    //   + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
    //   cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) -
    //   cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) +
    //   2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 +
    //   2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) -
    //   cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
    //   2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) +
    //   cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
    //   cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 -
    //   2*sin(q_P5) - cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
    //   sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))))
    //   + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) -
    //   sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
    //   cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) + cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 +
    //   sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2))))) -
    //   cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) -
    //   cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
    //   sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) -
    //   1) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)) - sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) +
    //   sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
    //   sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 -
    //   sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4)) + sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) +
    //   cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) +
    //   l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) -
    //   cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) -
    //   cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l*(cos(q_P1)*(1 +
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1)))) - sin(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1)
    //   - 1)))*(l*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*cos(q_P2)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5)
    //   + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) +
    //   sin(q_P1)*sin(q_P2)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)))) +
    //   l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) +
    //   sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))^2) +
    //   l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) - l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(cos(q_P1)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) +
    //   sin(q_P1)*sin(q_P2)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
    //   sin(q_P3)*sin(q_P5)))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 +
    //   cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5)
    //   - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
    //   + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
    //   cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) -
    //   cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) +
    //   2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 +
    //   2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) -
    //   cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
    //   2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) +
    //   cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
    //   cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 -
    //   2*sin(q_P5) - cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
    //   sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))))
    //   + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) -
    //   sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
    //   cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) + cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 +
    //   sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2))))) -
    //   cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) -
    //   cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
    //   sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) -
    //   1) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)) - sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) +
    //   sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
    //   sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 -
    //   sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4)) + sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) +
    //   cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) +
    //   l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) -
    //   cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) -
    //   cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) +
    //   l^3*cos(q_P5)*(cos(q_P5)*(sin(q_P1)*cos(q_P3)*sin(q_P4) + cos(q_P1)*(sin(q_P2)*sin(q_P3)*sin(q_P4) -
    //   cos(q_P2)*cos(q_P4))) - sin(q_P5)*(sin(q_P1)*sin(q_P3) - cos(q_P1)*sin(q_P2)*cos(q_P3)))*(sin(q_P3)
    //   - sin(q_P5) + cos(q_P3)*cos(q_P5) + sin(q_P4)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P3)*(2 - sin(q_P5) - sin(q_P4)*(sin(q_P5) - 1))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 -
    //   sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 +
    //   cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5)
    //   - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
    //   + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
    //   cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) -
    //   cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) +
    //   2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 +
    //   2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) -
    //   cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
    //   2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) +
    //   cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
    //   cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 -
    //   2*sin(q_P5) - cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
    //   sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))))
    //   + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) -
    //   sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
    //   cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) + cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 +
    //   sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2))))) -
    //   cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) -
    //   cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
    //   sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) -
    //   1) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)) - sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) +
    //   sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
    //   sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 -
    //   sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4)) + sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) +
    //   cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) +
    //   l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) -
    //   cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) -
    //   cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))))
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
    // ratio_q_P5_u_P1 = l*(sin(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) -
    //   1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4)) + sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) +
    //   cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) +
    //   l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) -
    //   cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) -
    //   cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 +
    //   cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5)
    //   - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
    //   + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
    //   cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) -
    //   cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) +
    //   2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 +
    //   2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) -
    //   cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
    //   2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) +
    //   cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
    //   cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 -
    //   2*sin(q_P5) - cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
    //   sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))))
    //   + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) -
    //   sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
    //   cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) + cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 +
    //   sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2))))) -
    //   cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) -
    //   cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
    //   sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) -
    //   1) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)) - sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) +
    //   sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
    //   sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 -
    //   sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4)) + sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) +
    //   cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) +
    //   l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) -
    //   cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) -
    //   cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l*(cos(q_P1)*(1 +
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1)))) - sin(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1)
    //   - 1)))*(l*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(l*cos(q_P2)*cos(q_P5)*(cos(q_P1)*cos(q_P3)*cos(q_P4) -
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)))*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))*(cos(q_P1)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)) + sin(q_P1)*sin(q_P2)*(cos(q_P3)*sin(q_P4)*cos(q_P5) -
    //   sin(q_P3)*sin(q_P5)))) + l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(l*cos(q_P5)*(cos(q_P1)*cos(q_P3)*cos(q_P4) -
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)))*(cos(q_P2)*cos(q_P4)*(sin(q_P5) -
    //   1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))) +
    //   l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(cos(q_P1)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) +
    //   sin(q_P1)*sin(q_P2)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5))) -
    //   l*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1))))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 +
    //   cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5)
    //   - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
    //   + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
    //   cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) -
    //   cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) +
    //   2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 +
    //   2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) -
    //   cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
    //   2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) +
    //   cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
    //   cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 -
    //   2*sin(q_P5) - cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
    //   sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))))
    //   + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) -
    //   sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
    //   cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) + cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 +
    //   sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2))))) -
    //   cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) -
    //   cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
    //   sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) -
    //   1) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)) - sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) +
    //   sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
    //   sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 -
    //   sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4)) + sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) +
    //   cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) +
    //   l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) -
    //   cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) -
    //   cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))) +
    //   l^3*cos(q_P4)*(cos(q_P5)*(sin(q_P1)*cos(q_P3)*sin(q_P4) + cos(q_P1)*(sin(q_P2)*sin(q_P3)*sin(q_P4) -
    //   cos(q_P2)*cos(q_P4))) - sin(q_P5)*(sin(q_P1)*sin(q_P3) - cos(q_P1)*sin(q_P2)*cos(q_P3)))*(sin(q_P3)
    //   - 1 + cos(q_P3)*cos(q_P5) + sin(q_P5)*(1 - sin(q_P3) - cos(q_P3)*cos(q_P5)) + sin(q_P4)*(2*sin(q_P5)
    //   - 2 + cos(q_P5)^2 + sin(q_P3)*(2 - 2*sin(q_P5) -
    //   cos(q_P5)^2)))/(l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5)
    //   - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 +
    //   cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5)
    //   - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
    //   + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
    //   cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) -
    //   cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) +
    //   2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 +
    //   2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) -
    //   cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
    //   2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) +
    //   cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
    //   cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 -
    //   2*sin(q_P5) - cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
    //   sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))))
    //   + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) -
    //   sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
    //   cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) + cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 +
    //   sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2))))) -
    //   cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) -
    //   cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
    //   sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) -
    //   1) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)) - sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) +
    //   sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
    //   sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 -
    //   sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4)) + sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) +
    //   cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) +
    //   l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) -
    //   cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) -
    //   cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)))))
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
    // Values.
    // q_P1' = u_P1
    let q_P1_dot_value = u_P1;
    // q_P2' = u_P1*ratio_q_P2_u_P1
    let q_P2_dot_value = u_P1 * ratio_q_P2_u_P1;
    // q_P3' = u_P1*ratio_q_P3_u_P1
    let q_P3_dot_value = u_P1 * ratio_q_P3_u_P1;
    // q_P4' = -u_P1*ratio_q_P4_u_P1
    let q_P4_dot_value = -u_P1 * ratio_q_P4_u_P1;
    // q_P5' = -u_P1*ratio_q_P5_u_P1
    let q_P5_dot_value = -u_P1 * ratio_q_P5_u_P1;
    [q_P1_dot_value, q_P2_dot_value, q_P3_dot_value, q_P4_dot_value, q_P5_dot_value]
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
    let w_rod2_frame_in_rod3_frame_2 = w_rod2_frame_3
        .mul_add(sin_q_P3, w_rod1_frame_in_rod2_frame_2 * cos_q_P3);
    let w_rod2_frame_in_rod3_frame_3 = (-w_rod2_frame_3)
        .mul_add(cos_q_P3, w_rod1_frame_in_rod2_frame_2 * sin_q_P3);
    let w_rod3_frame_1 = u_P1.mul_add(ratio_q_P3_u_P1, w_rod1_frame_in_rod2_frame_1);
    let w_rod3_frame_in_rod4_frame_1 = w_rod3_frame_1
        .mul_add(cos_q_P4, w_rod2_frame_in_rod3_frame_3 * sin_q_P4);
    let w_rod3_frame_in_rod4_frame_3 = (-w_rod3_frame_1)
        .mul_add(sin_q_P4, w_rod2_frame_in_rod3_frame_3 * cos_q_P4);
    let w_rod4_frame_2 = u_P1.mul_add(ratio_q_P4_u_P1, -w_rod2_frame_in_rod3_frame_2);
    let w_rod4_frame_in_rod5_frame_1 = (-w_rod4_frame_2)
        .mul_add(sin_q_P5, w_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let w_rod5_frame_3 = u_P1.mul_add(ratio_q_P5_u_P1, w_rod3_frame_in_rod4_frame_3);
    let m_l_sq = m * l_sq;
    let H_rod2_1 = w_rod1_frame_in_rod2_frame_1 * m_l_sq;
    let H_rod2_3 = w_rod2_frame_3 * m_l_sq;
    let H_rod3_1 = w_rod3_frame_1 * m_l_sq;
    let H_rod3_2 = w_rod2_frame_in_rod3_frame_2 * m_l_sq;
    let H_rod4_2 = w_rod4_frame_2 * m_l_sq;
    let H_rod4_3 = w_rod3_frame_in_rod4_frame_3 * m_l_sq;
    let H_rod5_1 = w_rod4_frame_in_rod5_frame_1 * m_l_sq;
    let H_rod5_3 = w_rod5_frame_3 * m_l_sq;
    let v_rod1_centre_3 = l * u_P1;
    let H_rod1_2 = u_P1 * m_l_sq;
    let v_rod2_centre_1 = l * w_rod2_frame_3;
    let v_rod2_centre_3_of_place = l * w_rod1_frame_in_rod2_frame_1;
    let v_rod2_centre_3 = (-v_rod1_centre_3)
        .mul_add(S::int(2), v_rod2_centre_3_of_place);
    let v_rod3_centre_3 = v_rod2_centre_3_of_place - v_rod1_centre_3;
    let v_rod2_frame_in_rod3_frame_2 = v_rod3_centre_3 * sin_q_P3;
    let v_rod2_frame_in_rod3_frame_3 = v_rod3_centre_3 * cos_q_P3;
    let v_rod3_centre_1_of_place = l * w_rod2_frame_in_rod3_frame_2;
    let v_rod3_centre_1 = (-v_rod2_centre_1)
        .mul_add(S::int(2), v_rod3_centre_1_of_place);
    let l_w_rod3_frame_1 = l * w_rod3_frame_1;
    let v_rod3_centre_2 = (-v_rod2_frame_in_rod3_frame_2)
        .mul_add(S::int(2), l_w_rod3_frame_1);
    let v_rod4_centre_1 = v_rod3_centre_1_of_place - v_rod2_centre_1;
    let v_rod4_centre_2 = l_w_rod3_frame_1 - v_rod2_frame_in_rod3_frame_2;
    let v_rod3_frame_in_rod4_frame_1 = (-v_rod4_centre_1)
        .mul_add(cos_q_P4, v_rod2_frame_in_rod3_frame_3 * sin_q_P4);
    let v_rod3_frame_in_rod4_frame_3 = v_rod4_centre_1
        .mul_add(sin_q_P4, v_rod2_frame_in_rod3_frame_3 * cos_q_P4);
    let v_rod4_centre_2_2_of_place = l * w_rod3_frame_in_rod4_frame_3;
    let v_rod4_centre_2_2 = (-v_rod4_centre_2)
        .mul_add(S::int(2), v_rod4_centre_2_2_of_place);
    let l_w_rod4_frame_2 = l * w_rod4_frame_2;
    let v_rod4_centre_3 = (-v_rod3_frame_in_rod4_frame_3)
        .mul_add(S::int(2), l_w_rod4_frame_2);
    let v_rod5_centre_2 = v_rod4_centre_2_2_of_place - v_rod4_centre_2;
    let v_rod5_centre_3 = l_w_rod4_frame_2 - v_rod3_frame_in_rod4_frame_3;
    let v_rod4_frame_in_rod5_frame_1 = (-v_rod5_centre_2)
        .mul_add(sin_q_P5, v_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let v_rod4_frame_in_rod5_frame_2 = v_rod5_centre_2
        .mul_add(cos_q_P5, v_rod3_frame_in_rod4_frame_1 * sin_q_P5);
    let v_rod5_centre_1 = v_rod4_frame_in_rod5_frame_1
        .mul_add(S::int(2), l * w_rod5_frame_3);
    let v_rod5_centre_3_2 = v_rod5_centre_3
        .mul_add(S::int(2), l * w_rod4_frame_in_rod5_frame_1);
    let energy_of_place = v_rod3_frame_in_rod4_frame_1
        .mul_add(
            v_rod3_frame_in_rod4_frame_1,
            v_rod2_frame_in_rod3_frame_3 * v_rod2_frame_in_rod3_frame_3,
        );
    let energy_of_place_2 = v_rod3_centre_1
        .mul_add(v_rod3_centre_1, v_rod2_centre_3 * v_rod2_centre_3);
    let energy_of_place_3 = v_rod4_centre_2_2
        .mul_add(v_rod4_centre_2_2, v_rod3_centre_2 * v_rod3_centre_2);
    let energy_of_place_4 = v_rod2_centre_1
        .mul_add(v_rod2_centre_1, v_rod1_centre_3 * v_rod1_centre_3);
    let energy_of_place_5 = v_rod5_centre_1
        .mul_add(v_rod5_centre_1, v_rod4_centre_3 * v_rod4_centre_3);
    let energy_of_place_6 = v_rod5_centre_3_2
        .mul_add(v_rod5_centre_3_2, energy_of_place_4);
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
        * v_rod4_frame_in_rod5_frame_2
            .mul_add(v_rod4_frame_in_rod5_frame_2, energy_of_place)
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
    let mr_rod5_frame_2 = l * m;
    let x_rod1_frame_in_rod2_frame_1 = g * sin_q_P2;
    let x_rod1_frame_in_rod2_frame_2 = g * cos_q_P2;
    let x_rod2_frame_in_rod3_frame_2 = x_rod1_frame_in_rod2_frame_2 * cos_q_P3;
    let x_rod2_frame_in_rod3_frame_3 = x_rod1_frame_in_rod2_frame_2 * sin_q_P3;
    let x_rod3_frame_in_rod4_frame_1 = x_rod2_frame_in_rod3_frame_3
        .mul_add(sin_q_P4, x_rod1_frame_in_rod2_frame_1 * cos_q_P4);
    let x_rod3_frame_in_rod4_frame_3 = (-x_rod1_frame_in_rod2_frame_1)
        .mul_add(sin_q_P4, x_rod2_frame_in_rod3_frame_3 * cos_q_P4);
    let x_rod4_frame_in_rod5_frame_1 = x_rod3_frame_in_rod4_frame_1
        .mul_add(cos_q_P5, x_rod2_frame_in_rod3_frame_2 * sin_q_P5);
    let x_rod4_frame_in_rod5_frame_2 = (-x_rod2_frame_in_rod3_frame_2)
        .mul_add(cos_q_P5, x_rod3_frame_in_rod4_frame_1 * sin_q_P5);
    let x_rod1_frame_in_rod2_frame_1_2 = mr_rod5_frame_2 * cos_q_P2;
    let x_rod1_frame_in_rod2_frame_2_2 = mr_rod5_frame_2 * sin_q_P2;
    let x_rod5_frame_2 = (-x_rod1_frame_in_rod2_frame_2_2)
        .mul_add(S::int(9), S::int(7) * mr_rod5_frame_2);
    let x_rod2_frame_in_rod3_frame_2_2 = x_rod5_frame_2 * cos_q_P3;
    let x_rod2_frame_in_rod3_frame_3_2 = x_rod5_frame_2 * sin_q_P3;
    let x_rod5_frame_3 = mr_rod5_frame_2
        .mul_add(S::int(5), -x_rod2_frame_in_rod3_frame_3_2);
    let x_rod3_frame_in_rod4_frame_1_2_of_place = S::int(9) * x_rod1_frame_in_rod2_frame_1_2;
    let x_rod3_frame_in_rod4_frame_1_2 = (-x_rod3_frame_in_rod4_frame_1_2_of_place)
        .mul_add(cos_q_P4, x_rod5_frame_3 * sin_q_P4);
    let x_rod3_frame_in_rod4_frame_3_2 = x_rod3_frame_in_rod4_frame_1_2_of_place
        .mul_add(sin_q_P4, x_rod5_frame_3 * cos_q_P4);
    let x_rod5_frame_1 = mr_rod5_frame_2
        .mul_add(S::int(3), x_rod3_frame_in_rod4_frame_1_2);
    let x_rod4_frame_in_rod5_frame_1_2 = (-x_rod2_frame_in_rod3_frame_2_2)
        .mul_add(sin_q_P5, x_rod5_frame_1 * cos_q_P5);
    let x_rod4_frame_in_rod5_frame_2_2 = x_rod5_frame_1
        .mul_add(sin_q_P5, x_rod2_frame_in_rod3_frame_2_2 * cos_q_P5);
    let x_rod5_frame_2_2 = mr_rod5_frame_2 - x_rod4_frame_in_rod5_frame_2_2;
    let energy_of_place = (-x_rod4_frame_in_rod5_frame_2)
        .mul_add(
            x_rod5_frame_2_2,
            x_rod4_frame_in_rod5_frame_1 * x_rod4_frame_in_rod5_frame_1_2,
        );
    let energy_of_place_2 = x_rod3_frame_in_rod4_frame_3
        .mul_add(x_rod3_frame_in_rod4_frame_3_2, energy_of_place);
    // Values.
    let energy = -S::ratio(1, 2) * energy_of_place_2;
    energy
}

/// Matrix of the linear system M(q) u' = f(q, u) row by row, and its right-hand side, which share terms.
///
/// 1705 operations, 5 sines and cosines.
#[must_use]
pub fn linear_system<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 1],
) -> ([S; 1], [S; 1]) {
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
    let ratio_q_P2_u_P1_of_place_20 = ratio_q_P2_u_P1_of_place_6 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_21 = sin_q_p2_sin_q_p1
        .mul_add(ratio_q_P2_u_P1_of_place_19, ratio_q_P2_u_P1_of_place_20);
    let ratio_q_P2_u_P1_of_place_22 = ratio_q_P2_u_P1_of_place_16 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_23 = (-ratio_q_P2_u_P1_of_place_8)
        .mul_add(
            ratio_q_P2_u_P1_of_place_21,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_22,
        );
    let ratio_q_P2_u_P1_of_place_24 = ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_25 = ratio_q_P2_u_P1_of_q_p3_q_p5
        .mul_add(sin_q_p2_cos_q_p4, ratio_q_P2_u_P1_of_place_24);
    let cos_q_p3_sin_q_p1 = sin_q_P1 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_26 = cos_q_p3_sin_q_p1 * cos_q_P4;
    let ratio_q_P2_u_P1_of_place_27 = l
        * ratio_q_P2_u_P1_of_q_p5_2
            .mul_add(
                ratio_q_P2_u_P1_of_place_26,
                ratio_q_P2_u_P1_of_place_25 * cos_q_P1,
            );
    let ratio_q_P2_u_P1_of_place_28 = l * ratio_q_P2_u_P1_of_place_12;
    let ratio_q_P2_u_P1_of_place_29 = l * ratio_q_P2_u_P1_of_place;
    let ratio_q_P2_u_P1_of_place_30 = ratio_q_P2_u_P1_of_place_21
        .mul_add(
            ratio_q_P2_u_P1_of_place_29,
            ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_of_place_28,
        );
    let ratio_q_P2_u_P1_of_place_31 = (-ratio_q_P2_u_P1_of_place_6)
        .mul_add(sin_q_P2, cos_q_p2_cos_q_p4 * cos_q_P5);
    let ratio_q_P2_u_P1_of_place_32 = l
        * (-ratio_q_P2_u_P1_of_place_31)
            .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_19 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_33 = (-ratio_q_P2_u_P1_of_place_23)
        .mul_add(
            ratio_q_P2_u_P1_of_place_27,
            ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_of_place_18,
        ) - ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_of_place_32;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_2 = S::int(1) - cos_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_34 = -ratio_q_P2_u_P1_of_place_14 - ratio_q_P2_u_P1_of_q_p3_q_p5_2;
    let ratio_q_P2_u_P1_of_place_35 = ratio_q_P2_u_P1_of_place_34
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p2_cos_q_p4);
    let ratio_q_P2_u_P1_of_place_36 = S::int(1) + ratio_q_P2_u_P1_of_place_35;
    let ratio_q_P2_u_P1_of_place_37 = (-ratio_q_P2_u_P1_of_place_16)
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_36 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_38 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_of_place_10, ratio_q_P2_u_P1_of_place_25 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_39 = ratio_q_P2_u_P1_of_place_31
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_19 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_40 = (-ratio_q_P2_u_P1_of_place_28)
        .mul_add(
            ratio_q_P2_u_P1_of_place_39,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_38,
        );
    let ratio_q_P2_u_P1_of_place_41 = l * ratio_q_P2_u_P1_of_place_35;
    let ratio_q_P2_u_P1_of_place_42 = ratio_q_P2_u_P1_of_q_p5_2 * sin_q_p2_cos_q_p4;
    let ratio_q_P2_u_P1_of_place_43 = ratio_q_P2_u_P1_of_place_34
        .mul_add(cos_q_P2, -ratio_q_P2_u_P1_of_place_42);
    let ratio_q_P2_u_P1_of_place_44 = ratio_q_P2_u_P1_of_place_8 * sin_q_P1;
    let ratio_q_P2_u_P1_of_place_45 = (-ratio_q_P2_u_P1_of_place_39)
        .mul_add(
            ratio_q_P2_u_P1_of_place_44,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_43 * sin_q_P1,
        );
    let cos_q_p2_sin_q_p1 = sin_q_P1 * cos_q_P2;
    let ratio_q_P2_u_P1_of_q_p3 = sin_q_P3 - S::int(1);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_3 = ratio_q_P2_u_P1_of_q_p5_2 * cos_q_P3;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_4 = (-ratio_q_P2_u_P1_of_q_p3)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_q_p3_q_p5_3);
    let ratio_q_P2_u_P1_of_place_46 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_q_p3_q_p5 * sin_q_p2_sin_q_p1);
    let ratio_q_P2_u_P1_of_place_47 = ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_p2_sin_q_p1;
    let ratio_q_P2_u_P1_of_place_48 = ratio_q_P2_u_P1_of_place_46
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_47);
    let ratio_q_P2_u_P1_of_place_49 = sin_q_p2_cos_q_p4
        .mul_add(ratio_q_P2_u_P1_of_q_p3, cos_q_p2_sin_q_p4);
    let ratio_q_P2_u_P1_of_place_50 = (-ratio_q_P2_u_P1_of_place_49)
        .mul_add(sin_q_P3, cos_q_p2_sin_q_p4);
    let cos_q_p5_sin_q_p1 = sin_q_P1 * cos_q_P5;
    let l_sq = l * l;
    let ratio_q_P2_u_P1_of_place_51 = l_sq
        * ratio_q_P2_u_P1_of_place_50
            .mul_add(cos_q_p5_sin_q_p1, ratio_q_P2_u_P1_of_place_48 * cos_q_P3);
    let ratio_q_P2_u_P1_of_place_52 = cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_of_place_51;
    let ratio_q_P2_u_P1_of_place_53 = ratio_q_P2_u_P1_of_place_29
        .mul_add(
            ratio_q_P2_u_P1_of_place_45,
            ratio_q_P2_u_P1_of_place_40 * ratio_q_P2_u_P1_of_place_41,
        ) + ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_52;
    let ratio_q_P2_u_P1_of_q_p4 = S::int(1) + sin_q_P4;
    let cos_q_p4_sq = cos_q_P4 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_2 = ratio_q_P2_u_P1_of_q_p4 - cos_q_p4_sq;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_3 = ratio_q_P2_u_P1_of_q_p4_2
        .mul_add(sin_q_P5, cos_q_p4_sq);
    let ratio_q_P2_u_P1_of_place_54 = ratio_q_P2_u_P1_of_q_p4_q_p5_3 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_55 = (-cos_q_p3_cos_q_p5)
        .mul_add(ratio_q_P2_u_P1_of_q_p4, ratio_q_P2_u_P1_of_place_54);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_4 = sin_q_P5 + ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_place_56 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p4_q_p5_4;
    let ratio_q_P2_u_P1_of_place_57 = ratio_q_P2_u_P1_of_place_55
        .mul_add(sin_q_P2, -ratio_q_P2_u_P1_of_place_56);
    let ratio_q_P2_u_P1_of_place_58 = ratio_q_P2_u_P1_of_q_p4_q_p5_3 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_59 = sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_of_q_p4;
    let ratio_q_P2_u_P1_of_place_60 = ratio_q_P2_u_P1_of_place_59
        .mul_add(S::int(2), ratio_q_P2_u_P1_of_place_58);
    let ratio_q_P2_u_P1_of_place_61 = (-ratio_q_P2_u_P1_of_place_60)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_57 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_62 = ratio_q_P2_u_P1_of_place_61
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_of_place_54);
    let ratio_q_P2_u_P1_of_place_63 = (-sin_q_p3_cos_q_p1)
        .mul_add(ratio_q_P2_u_P1_of_place_56, ratio_q_P2_u_P1_of_place_62 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_64 = ratio_q_P2_u_P1_of_place_58 + ratio_q_P2_u_P1_of_place_59;
    let ratio_q_P2_u_P1_of_place_65 = ratio_q_P2_u_P1_of_place_64 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_66 = (-sin_q_p3_cos_q_p1)
        .mul_add(ratio_q_P2_u_P1_of_place_65, ratio_q_P2_u_P1_of_place_63 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_67 = ratio_q_P2_u_P1_of_place_35 * l_sq;
    let ratio_q_P2_u_P1_of_place_68 = l * ratio_q_P2_u_P1_of_place_22;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_5 = cos_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_place_69 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_5)
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_q_p3 * sin_q_P5);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_6 = ratio_q_P2_u_P1_of_q_p3_q_p5 + cos_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_70 = (-sin_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_of_q_p3_q_p5_6, ratio_q_P2_u_P1_of_place_69 * cos_q_P2);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_7 = sin_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_3;
    let ratio_q_P2_u_P1_of_place_71 = ratio_q_P2_u_P1_of_q_p3_q_p5_7 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_72 = (-ratio_q_P2_u_P1_of_place_71)
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_70 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_73 = (-ratio_q_P2_u_P1_of_place_20)
        .mul_add(cos_q_P2, ratio_q_P2_u_P1_of_place_72 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_74 = l_sq * ratio_q_P2_u_P1_of_place_73 * sin_q_P1;
    let ratio_q_P2_u_P1_of_place_75 = ratio_q_P2_u_P1_of_place_45
        .mul_add(
            ratio_q_P2_u_P1_of_place_68,
            ratio_q_P2_u_P1_of_place_66 * ratio_q_P2_u_P1_of_place_67,
        ) - ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_74;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_8 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_3)
        .mul_add(S::int(2), sin_q_p3_cos_q_p5);
    let ratio_q_P2_u_P1_of_place_76 = ratio_q_P2_u_P1_of_q_p3_q_p5_8
        .mul_add(cos_q_P1, sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_of_q_p3_q_p5_6);
    let ratio_q_P2_u_P1_of_place_77 = ratio_q_P2_u_P1_of_place_76
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_47);
    let ratio_q_P2_u_P1_of_place_78 = (-cos_q_p2_sin_q_p1)
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_place_10);
    let ratio_q_P2_u_P1_of_place_79 = (-cos_q_p3_cos_q_p5)
        .mul_add(ratio_q_P2_u_P1_of_place_78, ratio_q_P2_u_P1_of_place_77 * sin_q_P3);
    let ratio_q_P2_u_P1_of_place_80 = ratio_q_P2_u_P1_of_place_79
        .mul_add(sin_q_P2, cos_q_p2_sin_q_p4 * ratio_q_P2_u_P1_of_place_71);
    let ratio_q_P2_u_P1_of_place_81 = (-ratio_q_P2_u_P1_of_place_10)
        .mul_add(ratio_q_P2_u_P1_of_place_71, ratio_q_P2_u_P1_of_place_80 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_82 = ratio_q_P2_u_P1_of_place
        .mul_add(
            ratio_q_P2_u_P1_of_place_74,
            ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_of_place_52,
        ) + ratio_q_P2_u_P1_of_place_67 * ratio_q_P2_u_P1_of_place_81;
    let ratio_q_P2_u_P1_of_place_83 = l * ratio_q_P2_u_P1_of_place_43;
    let ratio_q_P2_u_P1_of_place_84 = ratio_q_P2_u_P1_of_place_83 * cos_q_P1;
    let cos_q_p5_sq = cos_q_P5 * cos_q_P5;
    let ratio_q_P2_u_P1_of_q_p5_3 = ratio_q_P2_u_P1_of_q_p5 - cos_q_p5_sq;
    let ratio_q_P2_u_P1_of_q_p5_4 = ratio_q_P2_u_P1_of_q_p5
        .mul_add(S::int(2), -cos_q_p5_sq);
    let ratio_q_P2_u_P1_of_q_p5_5 = -ratio_q_P2_u_P1_of_q_p5_4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_5 = cos_q_p4_sq * ratio_q_P2_u_P1_of_q_p5_5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_6 = -ratio_q_P2_u_P1_of_q_p5_3
        - ratio_q_P2_u_P1_of_q_p4_q_p5_5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_7 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(cos_q_p4_sq, ratio_q_P2_u_P1_of_q_p4_q_p5_6 * sin_q_P4);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_8 = ratio_q_P2_u_P1_of_q_p4_q_p5_7 - ratio_q_P2_u_P1_of_q_p5_3;
    let cos_q_p4_sq_doubled = S::int(2) * cos_q_p4_sq;
    let ratio_q_P2_u_P1_of_q_p4_3 = ratio_q_P2_u_P1_of_q_p4 - cos_q_p4_sq_doubled;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_9 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_of_q_p4_3;
    let ratio_q_P2_u_P1_of_place_85 = sin_q_p3_cos_q_p5
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_9,
            ratio_q_P2_u_P1_of_q_p4_q_p5_8 * cos_q_P3,
        );
    let ratio_q_P2_u_P1_of_q_p4_q_p5_10 = ratio_q_P2_u_P1_of_q_p5_5 * cos_q_p4_sq_doubled;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_11 = -ratio_q_P2_u_P1_of_q_p5
        - ratio_q_P2_u_P1_of_q_p4_q_p5_10;
    let ratio_q_P2_u_P1_of_place_86 = ratio_q_P2_u_P1_of_q_p4_q_p5_11
        .mul_add(sin_q_P4, -ratio_q_P2_u_P1_of_q_p5)
        - ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p4_sq_doubled - ratio_q_P2_u_P1_of_place_85 * cos_q_P3;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_12 = S::int(2) * ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_13 = (-ratio_q_P2_u_P1_of_q_p5)
        .mul_add(S::int(3), cos_q_p5_sq) - ratio_q_P2_u_P1_of_q_p4_q_p5_10
        + ratio_q_P2_u_P1_of_q_p4_q_p5_12;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_14 = ratio_q_P2_u_P1_of_q_p4_q_p5_12 - ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_place_87 = cos_q_p3_cos_q_p5
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_14,
            ratio_q_P2_u_P1_of_q_p4_q_p5_13 * sin_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_88 = sin_q_p2_cos_q_p4
        .mul_add(ratio_q_P2_u_P1_of_place_87, ratio_q_P2_u_P1_of_place_86 * cos_q_P2);
    let cos_q_p3_doubled = S::int(2) * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_89 = (-ratio_q_P2_u_P1_of_place_88)
        .mul_add(cos_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5_8)
        - ratio_q_P2_u_P1_of_place_85 * cos_q_p3_doubled;
    let ratio_q_P2_u_P1_of_place_90 = (-cos_q_p3_cos_q_p5)
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_9,
            ratio_q_P2_u_P1_of_q_p4_q_p5_8 * sin_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_91 = ratio_q_P2_u_P1_of_place_90 * sin_q_P2;
    let ratio_q_P2_u_P1_of_place_92 = (-cos_q_p2_cos_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_13,
            S::int(2) * ratio_q_P2_u_P1_of_place_91,
        );
    let ratio_q_P2_u_P1_of_place_93 = cos_q_p2_cos_q_p4 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_94 = ratio_q_P2_u_P1_of_q_p4_q_p5_14
        .mul_add(ratio_q_P2_u_P1_of_place_93, ratio_q_P2_u_P1_of_q_p4_q_p5_9 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_95 = ratio_q_P2_u_P1_of_place_94
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_92 * cos_q_P3);
    let ratio_q_P2_u_P1_of_place_96 = (-ratio_q_P2_u_P1_of_place_95)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_89 * sin_q_P1);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_15 = ratio_q_P2_u_P1_of_q_p4_q_p5
        - ratio_q_P2_u_P1_of_q_p5_4 - ratio_q_P2_u_P1_of_q_p4_q_p5_5;
    let ratio_q_P2_u_P1_of_place_97 = (-cos_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_of_q_p4_q_p5_15, ratio_q_P2_u_P1_of_place_91);
    let ratio_q_P2_u_P1_of_place_98 = ratio_q_P2_u_P1_of_place_24
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_place_42);
    let cos_q_p4_cos_q_p5 = cos_q_P4 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_99 = ratio_q_P2_u_P1_of_place_97
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_of_place_96 * cos_q_P1)
        + ratio_q_P2_u_P1_of_place_98 * cos_q_p4_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_100 = l_sq * ratio_q_P2_u_P1_of_place_99;
    let ratio_q_P2_u_P1_of_place_101 = S::int(1)
        / ((-ratio_q_P2_u_P1_of_place_18)
            .mul_add(
                ratio_q_P2_u_P1_of_place_53,
                ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_of_place_75,
            ) + ratio_q_P2_u_P1_of_place_32 * ratio_q_P2_u_P1_of_place_82
            + ratio_q_P2_u_P1_of_place_84 * ratio_q_P2_u_P1_of_place_100);
    let ratio_q_P2_u_P1_of_place_102 = l * ratio_q_P2_u_P1_of_place_101;
    let ratio_q_P2_u_P1_of_place_103 = ratio_q_P2_u_P1_of_place_37 * ratio_q_P2_u_P1_of_place_102;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_16 = ratio_q_P2_u_P1_of_q_p4_q_p5 - ratio_q_P2_u_P1_of_q_p5;
    let sin_q_p3_sin_q_p1 = sin_q_P1 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_104 = (-cos_q_p3_cos_q_p1)
        .mul_add(sin_q_P2, sin_q_p3_sin_q_p1);
    let ratio_q_P2_u_P1_of_place_105 = cos_q_p3_sin_q_p1
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_place_3 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_106 = (-ratio_q_P2_u_P1_of_place_105)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_104 * sin_q_P5);
    let ratio_q_P2_u_P1_of_place_107 = l_sq * ratio_q_P2_u_P1_of_place_102;
    let ratio_q_P2_u_P1_of_place_108 = ratio_q_P2_u_P1_of_place_106 * ratio_q_P2_u_P1_of_place_107;
    let ratio_q_P2_u_P1_of_place_109 = ratio_q_P2_u_P1_of_place_108 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_110 = ratio_q_P2_u_P1_of_place_36
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_17);
    let ratio_q_P2_u_P1_of_place_111 = ratio_q_P2_u_P1_of_place_99 * ratio_q_P2_u_P1_of_place_107;
    let ratio_q_P2_u_P1 = ratio_q_P2_u_P1_of_q_p4_q_p5_16
        .mul_add(
            ratio_q_P2_u_P1_of_place_109,
            ratio_q_P2_u_P1_of_place_33 * ratio_q_P2_u_P1_of_place_103,
        ) + ratio_q_P2_u_P1_of_place_110 * ratio_q_P2_u_P1_of_place_111;
    let ratio_q_P3_u_P1_of_place = (-ratio_q_P2_u_P1_of_place_7)
        .mul_add(
            ratio_q_P2_u_P1_of_place_44,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_35,
        );
    let ratio_q_P3_u_P1_of_place_2 = ratio_q_P2_u_P1_of_place
        .mul_add(
            ratio_q_P2_u_P1_of_place_44,
            ratio_q_P2_u_P1_of_place_12 * ratio_q_P2_u_P1_of_place_41,
        );
    let ratio_q_P3_u_P1_of_place_3 = ratio_q_P2_u_P1_of_place_27
        .mul_add(
            ratio_q_P3_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_of_place_84,
        ) + ratio_q_P2_u_P1_of_place_32 * ratio_q_P3_u_P1_of_place_2;
    let ratio_q_P3_u_P1_of_place_4 = ratio_q_P2_u_P1_of_place_102 * ratio_q_P2_u_P1_of_place_110;
    let ratio_q_P3_u_P1_of_q_p3_q_p5 = ratio_q_P2_u_P1_of_q_p3_q_p5_4
        .mul_add(cos_q_P5, -ratio_q_P2_u_P1_of_q_p5) - ratio_q_P2_u_P1_of_q_p3_q_p5;
    let ratio_q_P3_u_P1_of_place_5 = ratio_q_P2_u_P1_of_place_108 * cos_q_P4;
    let ratio_q_P3_u_P1 = ratio_q_P2_u_P1_of_place_53
        .mul_add(
            ratio_q_P3_u_P1_of_place_4,
            ratio_q_P2_u_P1_of_place_103 * ratio_q_P3_u_P1_of_place_3,
        ) - ratio_q_P3_u_P1_of_q_p3_q_p5 * ratio_q_P3_u_P1_of_place_5;
    let ratio_q_P4_u_P1_of_place = ratio_q_P2_u_P1_of_place_16 * cos_q_p2_sin_q_p1;
    let ratio_q_P4_u_P1_of_place_2 = (-ratio_q_P2_u_P1_of_place_8)
        .mul_add(
            ratio_q_P4_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_of_place_41,
        );
    let ratio_q_P4_u_P1_of_place_3 = ratio_q_P2_u_P1_of_place_18
        .mul_add(
            ratio_q_P3_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_23 * ratio_q_P2_u_P1_of_place_84,
        ) - ratio_q_P2_u_P1_of_place_32 * ratio_q_P4_u_P1_of_place_2;
    let ratio_q_P4_u_P1_of_q_p4_q_p5 = ratio_q_P2_u_P1_of_q_p4_q_p5_4 - S::int(2);
    let ratio_q_P4_u_P1_of_place_4 = (-ratio_q_P4_u_P1_of_q_p4_q_p5)
        .mul_add(
            sin_q_P3,
            ratio_q_P2_u_P1_of_q_p4_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_2,
        );
    let ratio_q_P4_u_P1_of_place_5 = ratio_q_P4_u_P1_of_place_4
        .mul_add(sin_q_P4, sin_q_P3 - sin_q_P5 + cos_q_p3_cos_q_p5);
    let ratio_q_P4_u_P1 = ratio_q_P2_u_P1_of_place_103
        .mul_add(
            ratio_q_P4_u_P1_of_place_3,
            ratio_q_P2_u_P1_of_place_75 * ratio_q_P3_u_P1_of_place_4,
        ) - ratio_q_P2_u_P1_of_place_109 * ratio_q_P4_u_P1_of_place_5;
    let ratio_q_P5_u_P1_of_place = ratio_q_P2_u_P1_of_place_18
        .mul_add(
            ratio_q_P3_u_P1_of_place_2,
            ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_of_place_84,
        ) + ratio_q_P2_u_P1_of_place_27 * ratio_q_P4_u_P1_of_place_2;
    let ratio_q_P5_u_P1_of_q_p3_q_p5 = (-ratio_q_P2_u_P1_of_q_p5_5)
        .mul_add(sin_q_P3, -ratio_q_P2_u_P1_of_q_p5_4);
    let ratio_q_P5_u_P1_of_q_p3_q_p5_2 = sin_q_P3 - ratio_q_P2_u_P1_of_q_p3_q_p5_2;
    let ratio_q_P5_u_P1_of_place_2 = ratio_q_P2_u_P1_of_q_p5
        .mul_add(
            ratio_q_P5_u_P1_of_q_p3_q_p5_2,
            ratio_q_P5_u_P1_of_q_p3_q_p5 * sin_q_P4,
        );
    let ratio_q_P5_u_P1 = ratio_q_P2_u_P1_of_place_103
        .mul_add(
            ratio_q_P5_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_82 * ratio_q_P3_u_P1_of_place_4,
        ) - ratio_q_P3_u_P1_of_place_5 * ratio_q_P5_u_P1_of_place_2;
    let w_rod1_frame_in_rod2_frame_1 = u_P1 * sin_q_P2;
    let w_rod1_frame_in_rod2_frame_2 = u_P1 * cos_q_P2;
    let w_rod2_frame_3 = u_P1 * ratio_q_P2_u_P1;
    let sin_q_p3_w_rod2_frame_3 = w_rod2_frame_3 * sin_q_P3;
    let w_rod2_frame_in_rod3_frame_2 = w_rod1_frame_in_rod2_frame_2
        .mul_add(cos_q_P3, sin_q_p3_w_rod2_frame_3);
    let cos_q_p3_w_rod2_frame_3 = w_rod2_frame_3 * cos_q_P3;
    let w_rod2_frame_in_rod3_frame_3 = w_rod1_frame_in_rod2_frame_2
        .mul_add(sin_q_P3, -cos_q_p3_w_rod2_frame_3);
    let u_p1_ratio_q_p3_u_p1 = u_P1 * ratio_q_P3_u_P1;
    let w_rod3_frame_1 = w_rod1_frame_in_rod2_frame_1 + u_p1_ratio_q_p3_u_p1;
    let w_rod3_frame_in_rod4_frame_1 = w_rod3_frame_1
        .mul_add(cos_q_P4, w_rod2_frame_in_rod3_frame_3 * sin_q_P4);
    let w_rod3_frame_in_rod4_frame_3 = (-w_rod3_frame_1)
        .mul_add(sin_q_P4, w_rod2_frame_in_rod3_frame_3 * cos_q_P4);
    let u_p1_ratio_q_p4_u_p1 = u_P1 * ratio_q_P4_u_P1;
    let w_rod4_frame_2 = u_p1_ratio_q_p4_u_p1 - w_rod2_frame_in_rod3_frame_2;
    let w_rod4_frame_in_rod5_frame_1 = (-w_rod4_frame_2)
        .mul_add(sin_q_P5, w_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let w_rod4_frame_in_rod5_frame_2 = w_rod4_frame_2
        .mul_add(cos_q_P5, w_rod3_frame_in_rod4_frame_1 * sin_q_P5);
    let u_p1_ratio_q_p5_u_p1 = u_P1 * ratio_q_P5_u_P1;
    let w_rod5_frame_3 = w_rod3_frame_in_rod4_frame_3 + u_p1_ratio_q_p5_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1 = u_p1_ratio_q_p5_u_p1 * cos_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_2 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_2_of_u_p1;
    let u_p1_cos_q_p4 = u_P1 * cos_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_3 = ratio_q_P4_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_4 = ratio_q_P2_u_P1_2_of_u_p1_3 * sin_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_5 = (-cos_q_p4_sq)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_2,
            ratio_q_P2_u_P1_of_q_p5_5 * ratio_q_P2_u_P1_2_of_u_p1_4,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_6 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_12)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_3, cos_q_p4_sq * ratio_q_P2_u_P1_2_of_u_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_7 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_8 = ratio_q_P2_u_P1_2_of_u_p1_7 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_9 = ratio_q_P2_u_P1_2_of_u_p1_8 - ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_10 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_5;
    let ratio_q_P2_u_P1_2_of_u_p1_11 = sin_q_P4
        * (ratio_q_P2_u_P1_2_of_u_p1_10 - ratio_q_P2_u_P1_2_of_u_p1_9)
        + ratio_q_P2_u_P1_of_q_p4_q_p5_6 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_12 = ratio_q_P2_u_P1_2_of_u_p1_6 + ratio_q_P2_u_P1_2_of_u_p1_9;
    let ratio_q_P2_u_P1_2_of_u_p1_13 = ratio_q_P2_u_P1_2_of_u_p1_11 - ratio_q_P2_u_P1_2_of_u_p1_12;
    let ratio_q_P2_u_P1_2_of_u_p1_14 = u_p1_ratio_q_p5_u_p1 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_15 = u_p1_ratio_q_p3_u_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_16 = ratio_q_P2_u_P1_2_of_u_p1_15 * cos_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_17 = ratio_q_P2_u_P1_2_of_u_p1_14
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_16);
    let ratio_q_P2_u_P1_2_of_u_p1_18 = u_p1_ratio_q_p3_u_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_19 = ratio_q_P2_u_P1_of_q_p5
        * ratio_q_P2_u_P1_2_of_u_p1_4.mul_add(S::int(4), ratio_q_P2_u_P1_2_of_u_p1_3)
        - ratio_q_P2_u_P1_of_q_p4_3 * ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_20 = cos_q_P3
        * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_9)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_17,
                ratio_q_P2_u_P1_2_of_u_p1_13 * cos_q_P3,
            ) + ratio_q_P2_u_P1_of_q_p4_q_p5_8 * ratio_q_P2_u_P1_2_of_u_p1_18
            + sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_19)
        + ratio_q_P2_u_P1_of_place_85 * ratio_q_P2_u_P1_2_of_u_p1_18;
    let ratio_q_P2_u_P1_2_of_u_p1_21 = u_p1_ratio_q_p4_u_p1 * sin_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_22 = ratio_q_P2_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_23 = ratio_q_P2_u_P1_2_of_u_p1_22
        .mul_add(cos_q_P2, ratio_q_P2_u_P1_2_of_u_p1_21 * sin_q_P2);
    let sin_q_p2_w_rod2_frame_3 = w_rod2_frame_3 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_24 = ratio_q_P2_u_P1_of_q_p5_2
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_3, ratio_q_P2_u_P1_2_of_u_p1 * sin_q_P4);
    let ratio_q_P2_u_P1_2_of_u_p1_25 = ratio_q_P2_u_P1_2_of_u_p1_10 + ratio_q_P2_u_P1_2_of_u_p1_24;
    let ratio_q_P2_u_P1_2_of_u_p1_26 = ratio_q_P2_u_P1_2_of_u_p1
        .mul_add(S::int(3), -ratio_q_P2_u_P1_2_of_u_p1_8)
        + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_25;
    let ratio_q_P2_u_P1_2_of_u_p1_27 = (-ratio_q_P2_u_P1_2_of_u_p1_14)
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_18 * cos_q_P5);
    let ratio_q_P2_u_P1_2_of_u_p1_28 = ratio_q_P2_u_P1_2_of_u_p1_24
        .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_29 = (-cos_q_p2_sin_q_p4)
        .mul_add(u_p1_ratio_q_p4_u_p1, ratio_q_P2_u_P1_2_of_u_p1_22 * sin_q_P2);
    let cos_q_p2_w_rod2_frame_3 = w_rod2_frame_3 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_30 = sin_q_P2
        * ((-ratio_q_P2_u_P1_2_of_u_p1_13)
            .mul_add(
                sin_q_P3,
                ratio_q_P2_u_P1_of_q_p4_q_p5_8 * ratio_q_P2_u_P1_2_of_u_p1_15,
            ) + cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_19
            + ratio_q_P2_u_P1_of_q_p4_q_p5_9 * ratio_q_P2_u_P1_2_of_u_p1_27)
        + ratio_q_P2_u_P1_of_place_90 * cos_q_p2_w_rod2_frame_3;
    let ratio_q_P2_u_P1_2_of_u_p1_31 = ratio_q_P3_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_32 = (-(ratio_q_P2_u_P1_2_of_u_p1_31 * cos_q_P2))
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_29 * sin_q_P3);
    let u_p1_cos_q_p1 = u_P1 * cos_q_P1;
    let u_p1_sin_q_p1 = u_P1 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_33 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_7;
    let ratio_q_P2_u_P1_2_of_u_p1_34 = ratio_q_P2_u_P1_2_of_u_p1_24
        .mul_add(cos_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5 * sin_q_p2_w_rod2_frame_3);
    let ratio_q_P2_u_P1_2_of_u_p1_35 = (-sin_q_p2_cos_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1,
            ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_23,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_36 = -ratio_q_P2_u_P1_of_place_98
        * ratio_q_P2_u_P1_2_of_u_p1_21
            .mul_add(cos_q_P5, ratio_q_P2_u_P1_2_of_u_p1_14 * cos_q_P4)
        + ratio_q_P2_u_P1_of_place_97 * ratio_q_P2_u_P1_2_of_u_p1_18
        + ratio_q_P2_u_P1_of_place_96 * u_p1_sin_q_p1
        + cos_q_P1
            * (sin_q_P1
                * (ratio_q_P2_u_P1_2_of_u_p1_13 - S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_20
                    - ratio_q_P2_u_P1_of_place_88 * sin_q_p2_w_rod2_frame_3
                    + cos_q_P2
                        * (-cos_q_P2
                            * (ratio_q_P2_u_P1_2_of_u_p1
                                + ratio_q_P2_u_P1_of_q_p4_q_p5_11 * ratio_q_P2_u_P1_2_of_u_p1_3
                                + sin_q_P4
                                    * ratio_q_P2_u_P1_2_of_u_p1_5
                                        .mul_add(S::int(4), ratio_q_P2_u_P1_2_of_u_p1)
                                - S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_6
                                - ratio_q_P2_u_P1_2_of_u_p1_20)
                            + ratio_q_P2_u_P1_of_place_87 * ratio_q_P2_u_P1_2_of_u_p1_23
                            - ratio_q_P2_u_P1_of_place_86 * sin_q_p2_w_rod2_frame_3
                            - sin_q_p2_cos_q_p4
                                * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_13)
                                    .mul_add(
                                        ratio_q_P2_u_P1_2_of_u_p1_15,
                                        ratio_q_P2_u_P1_2_of_u_p1_26 * sin_q_P3,
                                    )
                                    + ratio_q_P2_u_P1_of_q_p4_q_p5_14 * ratio_q_P2_u_P1_2_of_u_p1_27
                                    + cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_28)))
                + cos_q_P1
                    * (ratio_q_P2_u_P1_of_place_94 * ratio_q_P2_u_P1_2_of_u_p1_14
                        - ratio_q_P2_u_P1_of_place_92 * ratio_q_P2_u_P1_2_of_u_p1_18
                        + cos_q_P3
                            * (ratio_q_P2_u_P1_of_q_p4_q_p5_13
                                .mul_add(
                                    ratio_q_P2_u_P1_2_of_u_p1_29,
                                    cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_26,
                                ) + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_30)
                        + cos_q_P5
                            * ((-ratio_q_P2_u_P1_2_of_u_p1_19)
                                .mul_add(
                                    sin_q_P2,
                                    ratio_q_P2_u_P1_of_q_p4_q_p5_9 * cos_q_p2_w_rod2_frame_3,
                                ) - ratio_q_P2_u_P1_of_place_93 * ratio_q_P2_u_P1_2_of_u_p1_28
                                - ratio_q_P2_u_P1_of_q_p4_q_p5_14 * ratio_q_P2_u_P1_2_of_u_p1_32))
                - ratio_q_P2_u_P1_of_place_89 * u_p1_cos_q_p1
                - ratio_q_P2_u_P1_of_place_95 * u_p1_sin_q_p1)
        - cos_q_P3
            * (ratio_q_P2_u_P1_2_of_u_p1_30
                + ratio_q_P2_u_P1_of_q_p4_q_p5_15 * ratio_q_P2_u_P1_2_of_u_p1_29
                + cos_q_p2_cos_q_p4 * (ratio_q_P2_u_P1_2_of_u_p1_25 + ratio_q_P2_u_P1_2_of_u_p1_33))
        + cos_q_p4_cos_q_p5
            * ((-ratio_q_P2_u_P1_of_place_24)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_15,
                    ratio_q_P2_u_P1_2_of_u_p1_34 * sin_q_P3,
                ) - ratio_q_P2_u_P1_2_of_u_p1_35);
    let ratio_q_P2_u_P1_2_of_u_p1_37 = sin_q_p2_w_rod2_frame_3
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_2_of_u_p1_3 * cos_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_38 = ratio_q_P2_u_P1_2_of_u_p1_31 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_39 = ratio_q_P2_u_P1_2_of_u_p1_38
        .mul_add(cos_q_P3, -ratio_q_P2_u_P1_2_of_u_p1_37);
    let sin_q_p4_u_p1_cos_q_p1 = u_p1_cos_q_p1 * sin_q_P4;
    let cos_q_p3_ratio_q_p4_u_p1 = ratio_q_P4_u_P1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_40 = (-sin_q_p4_u_p1_cos_q_p1)
        .mul_add(
            cos_q_p3_ratio_q_p4_u_p1,
            sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_31,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_41 = cos_q_p3_sin_q_p1
        .mul_add(u_p1_cos_q_p4, ratio_q_P2_u_P1_2_of_u_p1_40);
    let ratio_q_P2_u_P1_2_of_u_p1_42 = cos_q_P5
        * (sin_q_P1
            * ratio_q_P2_u_P1_2_of_u_p1_23
                .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_39)
            + ratio_q_P2_u_P1_of_place_9 * u_p1_cos_q_p1 + ratio_q_P2_u_P1_2_of_u_p1_41)
        - ratio_q_P2_u_P1_of_place_11 * ratio_q_P2_u_P1_2_of_u_p1_14;
    let ratio_q_P2_u_P1_2_of_u_p1_43 = ratio_q_P2_u_P1_2_of_u_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_44 = (-ratio_q_P2_u_P1_2_of_u_p1_24)
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_p2_w_rod2_frame_3)
        + ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_32
        + cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_43;
    let ratio_q_P2_u_P1_2_of_u_p1_45 = ratio_q_P2_u_P1_2_of_u_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_46 = sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_47 = (-ratio_q_P2_u_P1_2_of_u_p1_18)
        .mul_add(sin_q_P5, ratio_q_P2_u_P1_2_of_u_p1_17 * sin_q_P4)
        - ratio_q_P2_u_P1_2_of_u_p1_45 - ratio_q_P2_u_P1_2_of_u_p1_46;
    let ratio_q_P2_u_P1_2_of_u_p1_48 = ratio_q_P2_u_P1_2_of_u_p1_23
        .mul_add(cos_q_P5, sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_14)
        - ratio_q_P2_u_P1_of_place_6 * sin_q_p2_w_rod2_frame_3
        + ratio_q_P2_u_P1_2_of_u_p1_47 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_49 = u_p1_cos_q_p1
        .mul_add(sin_q_P2, w_rod2_frame_3 * cos_q_p2_sin_q_p1);
    let sin_q_p3_u_p1_sin_q_p1 = u_p1_sin_q_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_50 = ratio_q_P2_u_P1_2_of_u_p1_15 * cos_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_51 = ratio_q_P2_u_P1_2_of_u_p1_29
        - sin_q_p2_sin_q_p3 * ratio_q_P2_u_P1_2_of_u_p1_3
        + sin_q_P4
            * cos_q_p2_w_rod2_frame_3
                .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_15 * sin_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_52 = u_p1_sin_q_p1
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_18 * cos_q_P1);
    let ratio_q_P2_u_P1_2_of_u_p1_53 = ratio_q_P2_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_14
        - ratio_q_P2_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1
        + cos_q_P5
            * ((-sin_q_p2_sin_q_p1)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_18,
                    ratio_q_P2_u_P1_2_of_u_p1_49 * cos_q_P3,
                ) - sin_q_p3_u_p1_sin_q_p1 + ratio_q_P2_u_P1_2_of_u_p1_50)
        - sin_q_P5
            * (ratio_q_P2_u_P1_of_place_3
                .mul_add(u_p1_cos_q_p1, cos_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_3)
                + ratio_q_P2_u_P1_2_of_u_p1_51 * sin_q_P1
                + ratio_q_P2_u_P1_2_of_u_p1_52 * sin_q_P4);
    let ratio_q_P2_u_P1_2_of_u_p1_54 = ratio_q_P2_u_P1_of_place_5
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_44,
            ratio_q_P2_u_P1_of_place_8 * ratio_q_P2_u_P1_2_of_u_p1_42,
        ) - ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_48
        - ratio_q_P2_u_P1_of_place_29 * ratio_q_P2_u_P1_2_of_u_p1_53;
    let ratio_q_P2_u_P1_2_of_u_p1_55 = ratio_q_P2_u_P1_2_of_u_p1_15 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_56 = cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_57 = ratio_q_P2_u_P1_2_of_u_p1_27
        .mul_add(sin_q_P4, -ratio_q_P2_u_P1_2_of_u_p1_43) + ratio_q_P2_u_P1_2_of_u_p1_55
        + ratio_q_P2_u_P1_2_of_u_p1_56;
    let ratio_q_P2_u_P1_2_of_u_p1_58 = (-ratio_q_P2_u_P1_2_of_u_p1_47)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_6 * u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_59 = (-ratio_q_P2_u_P1_of_place_19)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_49,
            sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_57,
        ) + ratio_q_P2_u_P1_2_of_u_p1_58;
    let ratio_q_P2_u_P1_2_of_u_p1_60 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_18, ratio_q_P2_u_P1_2_of_u_p1_17)
        - ratio_q_P2_u_P1_2_of_u_p1_24 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_61 = ratio_q_P2_u_P1_2_of_u_p1_60 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_place = ratio_q_P2_u_P1_of_place_16 * sin_q_p2_w_rod2_frame_3;
    let ratio_q_P2_u_P1_2_of_u_p1_62 = ratio_q_P2_u_P1_2_of_u_p1_61 - ratio_q_P2_u_P1_2_of_place;
    let ratio_q_P2_u_P1_2_of_place_2 = l * ratio_q_P2_u_P1_of_place_21;
    let ratio_q_P2_u_P1_2_of_u_p1_63 = (-ratio_q_P2_u_P1_of_place_68)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_53,
            ratio_q_P2_u_P1_2_of_u_p1_48 * ratio_q_P2_u_P1_2_of_place_2,
        ) - ratio_q_P2_u_P1_of_place_8 * ratio_q_P2_u_P1_2_of_u_p1_59
        - ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_62;
    let ratio_q_P2_u_P1_2_of_u_p1_64 = ratio_q_P2_u_P1_of_place_29
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_59,
            ratio_q_P2_u_P1_of_place_68 * ratio_q_P2_u_P1_2_of_u_p1_42,
        ) - ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_62
        + ratio_q_P2_u_P1_2_of_u_p1_44 * ratio_q_P2_u_P1_2_of_place_2;
    let ratio_q_P2_u_P1_2_of_u_p1_65 = (-ratio_q_P2_u_P1_2_of_u_p1_24)
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_q_p4_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_15)
        + ratio_q_P2_u_P1_2_of_u_p1_27;
    let ratio_q_P2_u_P1_2_of_u_p1_66 = (-ratio_q_P2_u_P1_2_of_u_p1_60)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_16 * u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_67 = l
        * ((-ratio_q_P2_u_P1_of_place_17)
            .mul_add(cos_q_p2_w_rod2_frame_3, ratio_q_P2_u_P1_2_of_u_p1_65 * sin_q_P1)
            - ratio_q_P2_u_P1_of_place_15 * u_p1_cos_q_p1
            + ratio_q_P2_u_P1_2_of_u_p1_66 * sin_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_68 = ratio_q_P2_u_P1_of_q_p3_q_p5
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_23, -ratio_q_P2_u_P1_2_of_u_p1_34)
        + ratio_q_P2_u_P1_of_q_p3_q_p5_3 * ratio_q_P2_u_P1_2_of_u_p1_38
        - sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_43;
    let ratio_q_P2_u_P1_2_of_u_p1_69 = cos_q_p3_cos_q_p1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_70 = l
        * (-u_p1_sin_q_p1
            * ratio_q_P2_u_P1_of_q_p4_q_p5
                .mul_add(cos_q_p3_ratio_q_p4_u_p1, -ratio_q_P2_u_P1_of_place_25)
            + ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_u_p1
            + ratio_q_P2_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_31 * sin_q_P1
            - ratio_q_P2_u_P1_2_of_u_p1_68 * cos_q_P1
            - ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_69);
    let ratio_q_P2_u_P1_2_of_u_p1_71 = (-cos_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_14, ratio_q_P2_u_P1_2_of_u_p1_29 * cos_q_P5)
        + ratio_q_P2_u_P1_of_place_6 * cos_q_p2_w_rod2_frame_3
        + ratio_q_P2_u_P1_2_of_u_p1_47 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_72 = l
        * ((-ratio_q_P2_u_P1_2_of_u_p1_57)
            .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_19 * u_p1_cos_q_p1)
            + ratio_q_P2_u_P1_of_place_31 * u_p1_sin_q_p1
            + ratio_q_P2_u_P1_2_of_u_p1_71 * cos_q_P1);
    let ratio_q_P2_u_P1_2_of_u_p1_73 = (-cos_q_p2_cos_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1,
            ratio_q_P2_u_P1_of_place_34 * cos_q_p2_w_rod2_frame_3,
        ) - ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_29
        - ratio_q_P2_u_P1_2_of_u_p1_65 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_74 = (-ratio_q_P2_u_P1_of_place_31)
        .mul_add(u_p1_cos_q_p1, ratio_q_P2_u_P1_of_place_19 * u_p1_sin_q_p1)
        + ratio_q_P2_u_P1_2_of_u_p1_57 * cos_q_P1 + ratio_q_P2_u_P1_2_of_u_p1_71 * sin_q_P1;
    let cos_q_p2_u_p1_cos_q_p1 = u_p1_cos_q_p1 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_75 = sin_q_p2_w_rod2_frame_3
        .mul_add(sin_q_P1, -cos_q_p2_u_p1_cos_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_76 = l * ratio_q_P2_u_P1_2_of_u_p1_48;
    let ratio_q_P2_u_P1_2_of_u_p1_77 = ratio_q_P2_u_P1_of_place_8 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_78 = ratio_q_P2_u_P1_2_of_u_p1_76
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_2_of_u_p1_77);
    let ratio_q_P2_u_P1_2_of_u_p1_79 = ratio_q_P2_u_P1_of_place_34
        .mul_add(sin_q_p2_w_rod2_frame_3, ratio_q_P2_u_P1_2_of_u_p1_35)
        + ratio_q_P2_u_P1_2_of_u_p1_65 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_80 = ratio_q_P2_u_P1_of_place_83
        * ratio_q_P2_u_P1_2_of_u_p1_53 * sin_q_P1
        + ratio_q_P2_u_P1_of_place_44 * ratio_q_P2_u_P1_2_of_u_p1_74
        - ratio_q_P2_u_P1_of_place_39 * ratio_q_P2_u_P1_2_of_u_p1_78
        + ratio_q_P2_u_P1_of_place_5
            * (-ratio_q_P2_u_P1_2_of_u_p1_79)
                .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_43 * u_p1_cos_q_p1);
    let ratio_q_P2_u_P1_2_of_place_3 = l * ratio_q_P2_u_P1_of_place_45;
    let ratio_q_P2_u_P1_2_of_place_4 = ratio_q_P2_u_P1_of_place_7 * l_sq;
    let ratio_q_P2_u_P1_2_of_u_p1_81 = ratio_q_P2_u_P1_of_q_p5_2
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_18, ratio_q_P2_u_P1_2_of_u_p1_45);
    let ratio_q_P2_u_P1_2_of_u_p1_82 = ratio_q_P2_u_P1_of_q_p3
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_14, ratio_q_P2_u_P1_2_of_u_p1_16)
        + ratio_q_P2_u_P1_2_of_u_p1_81;
    let ratio_q_P2_u_P1_2_of_u_p1_83 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_15, ratio_q_P2_u_P1_2_of_u_p1_43);
    let ratio_q_P2_u_P1_2_of_u_p1_84 = ratio_q_P2_u_P1_of_q_p4_q_p5
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_75,
            cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_24,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_85 = cos_q_p2_sin_q_p1
        * (ratio_q_P2_u_P1_of_place_50
            * u_p1_cos_q_p1.mul_add(cos_q_P5, ratio_q_P2_u_P1_2_of_u_p1_14 * sin_q_P1)
            - ratio_q_P2_u_P1_of_place_48 * ratio_q_P2_u_P1_2_of_u_p1_18
            - cos_q_p5_sin_q_p1
                * (ratio_q_P2_u_P1_2_of_u_p1_37
                    + ratio_q_P2_u_P1_of_place_49 * ratio_q_P2_u_P1_2_of_u_p1_15
                    + sin_q_P3
                        * ratio_q_P2_u_P1_of_q_p3
                            .mul_add(
                                ratio_q_P2_u_P1_2_of_u_p1_23, ratio_q_P2_u_P1_2_of_u_p1_39,
                            ))
            - cos_q_P3
                * (cos_q_P4
                    * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
                        .mul_add(
                            u_p1_sin_q_p1,
                            sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_83,
                        ) - ratio_q_P2_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_49
                        - ratio_q_P2_u_P1_2_of_u_p1_82 * cos_q_P1)
                    - ratio_q_P2_u_P1_of_place_46 * ratio_q_P2_u_P1_2_of_u_p1_21
                    + ratio_q_P2_u_P1_2_of_u_p1_84));
    let ratio_q_P2_u_P1_2_of_u_p1_86 = ratio_q_P2_u_P1_of_place_52 * ratio_q_P2_u_P1_2_of_u_p1_48
        + l * ratio_q_P2_u_P1_of_place_40 * ratio_q_P2_u_P1_2_of_u_p1_73
        + ratio_q_P2_u_P1_of_place_41
            * (l
                * ratio_q_P2_u_P1_of_place_38
                    .mul_add(
                        ratio_q_P2_u_P1_2_of_u_p1_53,
                        ratio_q_P2_u_P1_of_place_39 * ratio_q_P2_u_P1_2_of_u_p1_42,
                    )
                + ratio_q_P2_u_P1_of_place_5
                    * (ratio_q_P2_u_P1_of_place_25
                        .mul_add(
                            u_p1_cos_q_p1,
                            ratio_q_P2_u_P1_of_place_10 * ratio_q_P2_u_P1_2_of_u_p1,
                        ) + ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_41
                        + ratio_q_P2_u_P1_2_of_u_p1_68 * sin_q_P1)
                + ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_74)
        - ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_51 * ratio_q_P2_u_P1_2_of_u_p1_75
        + ratio_q_P2_u_P1_of_place_29 * ratio_q_P2_u_P1_2_of_u_p1_80
        - ratio_q_P2_u_P1_2_of_u_p1_44 * ratio_q_P2_u_P1_2_of_place_3
        + ratio_q_P2_u_P1_2_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_85;
    let ratio_q_P2_u_P1_2_of_u_p1_87 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_4;
    let ratio_q_P2_u_P1_2_of_u_p1_88 = ratio_q_P2_u_P1_2_of_u_p1_87
        - ratio_q_P2_u_P1_of_q_p4_2 * ratio_q_P2_u_P1_2_of_u_p1
        - sin_q_P5 * (ratio_q_P2_u_P1_2_of_u_p1_3 + ratio_q_P2_u_P1_2_of_u_p1_87);
    let ratio_q_P2_u_P1_2_of_u_p1_89 = ratio_q_P2_u_P1_2_of_u_p1_88 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_90 = ratio_q_P2_u_P1_of_q_p4_q_p5_3
        * ratio_q_P2_u_P1_2_of_u_p1_15;
    let ratio_q_P2_u_P1_2_of_u_p1_91 = ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P2_u_P1_2_of_u_p1_24;
    let ratio_q_P2_u_P1_2_of_u_p1_92 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_91;
    let ratio_q_P2_u_P1_2_of_u_p1_93 = ratio_q_P2_u_P1_of_q_p4
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_17, -ratio_q_P2_u_P1_2_of_u_p1_46);
    let ratio_q_P2_u_P1_2_of_u_p1_94 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_3)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_18, ratio_q_P2_u_P1_2_of_u_p1_88 * cos_q_P3);
    let ratio_q_P2_u_P1_2_of_u_p1_95 = ratio_q_P2_u_P1_2_of_u_p1_27 + ratio_q_P2_u_P1_2_of_u_p1_83;
    let ratio_q_P2_u_P1_2_of_u_p1_96 = cos_q_P1
        * (ratio_q_P2_u_P1_2_of_u_p1_17 + ratio_q_P2_u_P1_2_of_u_p1_81);
    let ratio_q_P2_u_P1_2_of_place_5 = ratio_q_P2_u_P1_of_q_p3_q_p5_7 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_97 = sin_q_P1
        * (ratio_q_P2_u_P1_of_place_20 * sin_q_p2_w_rod2_frame_3
            + ratio_q_P2_u_P1_of_place_72 * cos_q_p2_w_rod2_frame_3
            + ratio_q_P2_u_P1_2_of_u_p1_58 * cos_q_P2
            + sin_q_P2
                * (ratio_q_P2_u_P1_of_place_70 * u_p1_cos_q_p1
                    - ratio_q_P4_u_P1 * ratio_q_P2_u_P1_of_q_p3_q_p5_7 * sin_q_p4_u_p1_cos_q_p1
                    + sin_q_P1
                        * (cos_q_P2
                            * (ratio_q_P2_u_P1_of_q_p3_q_p5_5 * ratio_q_P2_u_P1_2_of_u_p1_3
                                - ratio_q_P2_u_P1_of_q_p3 * ratio_q_P2_u_P1_2_of_u_p1
                                + sin_q_P4
                                    * (ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P2_u_P1_2_of_u_p1_27)
                                + ratio_q_P2_u_P1_2_of_u_p1_55)
                            - ratio_q_P2_u_P1_of_q_p3_q_p5_6 * ratio_q_P2_u_P1_2_of_u_p1_23
                            - ratio_q_P2_u_P1_of_place_69 * sin_q_p2_w_rod2_frame_3
                            + sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_95)
                    - ratio_q_P2_u_P1_2_of_u_p1_96 * cos_q_P4
                    + u_p1_cos_q_p4 * ratio_q_P2_u_P1_2_of_place_5))
        + ratio_q_P2_u_P1_of_place_73 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_98 = l_sq * ratio_q_P2_u_P1_2_of_u_p1_73;
    let ratio_q_P2_u_P1_2_of_u_p1_99 = ratio_q_P2_u_P1_of_place_74 * ratio_q_P2_u_P1_2_of_u_p1_48
        - ratio_q_P2_u_P1_of_place_68 * ratio_q_P2_u_P1_2_of_u_p1_80
        - ratio_q_P2_u_P1_2_of_u_p1_62 * ratio_q_P2_u_P1_2_of_place_3
        + ratio_q_P2_u_P1_of_place_67
            * (-u_p1_cos_q_p1
                * (ratio_q_P2_u_P1_of_place_64 * sin_q_p3_sin_q_p1)
                    .mul_add(S::int(2), ratio_q_P2_u_P1_of_place_63)
                + ratio_q_P2_u_P1_of_place_65 * ratio_q_P2_u_P1_2_of_u_p1_50
                - sin_q_P1
                    * (ratio_q_P2_u_P1_of_q_p4_q_p5_4
                        * ratio_q_P2_u_P1_2_of_u_p1_32
                            .mul_add(
                                cos_q_P1,
                                cos_q_p2_sin_q_p1 * u_p1_cos_q_p4 * sin_q_P3,
                            ) + ratio_q_P2_u_P1_of_place_62 * cos_q_p2_w_rod2_frame_3
                        + sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_92
                        + sin_q_P2
                            * (sin_q_p3_cos_q_p1
                                * ratio_q_P2_u_P1_2_of_u_p1_90
                                    .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_89)
                                - ratio_q_P2_u_P1_of_place_61 * ratio_q_P2_u_P1_2_of_u_p1_18
                                - ratio_q_P2_u_P1_of_place_54 * sin_q_p3_u_p1_sin_q_p1
                                + cos_q_P3
                                    * (ratio_q_P2_u_P1_of_place_57 * u_p1_cos_q_p1
                                        + ratio_q_P2_u_P1_of_place_60 * u_p1_sin_q_p1
                                        + sin_q_P1
                                            * (ratio_q_P2_u_P1_of_q_p4_q_p5_4
                                                * ratio_q_P2_u_P1_2_of_u_p1_29
                                                + ratio_q_P2_u_P1_of_place_55 * cos_q_p2_w_rod2_frame_3
                                                + sin_q_P2
                                                    * (ratio_q_P2_u_P1_of_q_p4
                                                        .mul_add(
                                                            ratio_q_P2_u_P1_2_of_u_p1_27,
                                                            ratio_q_P2_u_P1_2_of_u_p1_56,
                                                        ) + ratio_q_P2_u_P1_2_of_u_p1_89
                                                        + ratio_q_P2_u_P1_2_of_u_p1_90)
                                                + ratio_q_P2_u_P1_2_of_u_p1_92)
                                        - cos_q_P1
                                            * ratio_q_P2_u_P1_2_of_u_p1_93
                                                .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_94))))
                + sin_q_p3_cos_q_p1 * cos_q_P1
                    * (ratio_q_P2_u_P1_2_of_u_p1_93 + ratio_q_P2_u_P1_2_of_u_p1_94))
        + ratio_q_P2_u_P1_2_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_97
        - ratio_q_P2_u_P1_of_place_66 * ratio_q_P2_u_P1_2_of_u_p1_98;
    let ratio_q_P2_u_P1_2_of_u_p1_100 = ratio_q_P2_u_P1_of_place_52
        * (-ratio_q_P2_u_P1_2_of_place).mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_61)
        - ratio_q_P2_u_P1_of_place_74 * ratio_q_P2_u_P1_2_of_u_p1_44
        + ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_of_place_51 * cos_q_p2_u_p1_cos_q_p1
        + ratio_q_P2_u_P1_of_place_67
            * (ratio_q_P2_u_P1_of_place_80 * u_p1_cos_q_p1
                - ratio_q_P2_u_P1_of_place_10 * ratio_q_P2_u_P1_2_of_u_p1_96
                + ratio_q_P2_u_P1_of_place_71 * ratio_q_P2_u_P1_2_of_u_p1_40
                - sin_q_P1
                    * (ratio_q_P2_u_P1_of_place_71 * ratio_q_P2_u_P1_2_of_u_p1_37
                        - ratio_q_P2_u_P1_of_place_79 * cos_q_p2_w_rod2_frame_3
                        + sin_q_P2
                            * (cos_q_p3_cos_q_p5
                                * (cos_q_p2_sin_q_p1
                                    .mul_add(
                                        ratio_q_P2_u_P1_2_of_u_p1_3, -ratio_q_P2_u_P1_2_of_u_p1_41,
                                    ) + ratio_q_P2_u_P1_2_of_u_p1_75 * sin_q_P4)
                                - ratio_q_P2_u_P1_of_place_77 * ratio_q_P2_u_P1_2_of_u_p1_15
                                - ratio_q_P2_u_P1_of_place_78 * ratio_q_P2_u_P1_2_of_u_p1_27
                                + sin_q_P3
                                    * (ratio_q_P2_u_P1_2_of_u_p1_84
                                        - ratio_q_P2_u_P1_of_place_76 * ratio_q_P2_u_P1_2_of_u_p1_21
                                        + cos_q_P4
                                            * (ratio_q_P2_u_P1_of_q_p3_q_p5_8 * u_p1_sin_q_p1
                                                - ratio_q_P2_u_P1_of_q_p3_q_p5_6
                                                    * ratio_q_P2_u_P1_2_of_u_p1_49
                                                - cos_q_P1
                                                    * ratio_q_P2_u_P1_2_of_u_p1_81
                                                        .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_17)
                                                + sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_95)))
                        + cos_q_p2_sin_q_p4
                            * ratio_q_P2_u_P1_of_q_p3_q_p5_7
                                .mul_add(u_p1_sin_q_p1, -ratio_q_P2_u_P1_2_of_u_p1_96))
                + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_69 * ratio_q_P2_u_P1_2_of_place_5)
        + l_sq
            * ratio_q_P2_u_P1_of_place
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_97,
                    ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_2_of_u_p1_85,
                ) + ratio_q_P2_u_P1_of_place_81 * ratio_q_P2_u_P1_2_of_u_p1_98;
    let ratio_q_P2_u_P1_2_of_u_p1_101 = l
        * ratio_q_P2_u_P1_2_of_u_p1_79
            .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_43 * u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_102 = ratio_q_P2_u_P1_of_place_101
        * ((-ratio_q_P2_u_P1_of_place_53)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_67,
                l_sq * ratio_q_P2_u_P1_of_place_84 * ratio_q_P2_u_P1_2_of_u_p1_36,
            ) + ratio_q_P2_u_P1_of_place_75 * ratio_q_P2_u_P1_2_of_u_p1_70
            - ratio_q_P2_u_P1_of_place_82 * ratio_q_P2_u_P1_2_of_u_p1_72
            + ratio_q_P2_u_P1_of_place_18 * ratio_q_P2_u_P1_2_of_u_p1_86
            + ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_2_of_u_p1_99
            - ratio_q_P2_u_P1_of_place_32 * ratio_q_P2_u_P1_2_of_u_p1_100
            + ratio_q_P2_u_P1_of_place_100 * ratio_q_P2_u_P1_2_of_u_p1_101);
    let ratio_q_P2_u_P1_2_of_u_p1_103 = ratio_q_P2_u_P1_of_place_104 * ratio_q_P2_u_P1_2_of_u_p1
        + ratio_q_P2_u_P1_of_place_105 * ratio_q_P2_u_P1_2_of_u_p1_14
        + cos_q_P5
            * ((-cos_q_p3_sin_q_p1)
                .mul_add(ratio_q_P2_u_P1_2_of_u_p1_3, sin_q_p4_u_p1_cos_q_p1 * cos_q_P3)
                - ratio_q_P2_u_P1_2_of_u_p1_18 * sin_q_P1 * sin_q_P4
                - ratio_q_P2_u_P1_of_place_3 * u_p1_sin_q_p1
                + ratio_q_P2_u_P1_2_of_u_p1_51 * cos_q_P1)
        + sin_q_P5
            * ((-ratio_q_P2_u_P1_2_of_u_p1_15)
                .mul_add(sin_q_P1, cos_q_p3_cos_q_p1 * cos_q_p2_w_rod2_frame_3)
                - u_p1_cos_q_p1 * sin_q_P3 - ratio_q_P2_u_P1_2_of_u_p1_52 * sin_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_104 = ratio_q_P2_u_P1_of_place_107
        * ratio_q_P2_u_P1_of_place_106
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_102, -ratio_q_P2_u_P1_2_of_u_p1_103);
    let ratio_q_P2_u_P1_2_of_u_p1_105 = ratio_q_P2_u_P1_2_of_u_p1_104
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_108 * ratio_q_P2_u_P1_2_of_u_p1_14);
    let ratio_q_P2_u_P1_2_of_u_p1_106 = ratio_q_P2_u_P1_of_place_36
        .mul_add(u_p1_sin_q_p1, ratio_q_P2_u_P1_of_place_16 * u_p1_cos_q_p1)
        + ratio_q_P2_u_P1_2_of_u_p1_60 * sin_q_P1 - ratio_q_P2_u_P1_2_of_u_p1_73 * cos_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_107 = ratio_q_P2_u_P1_of_place_102
        * ratio_q_P2_u_P1_of_place_37
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_102, -ratio_q_P2_u_P1_2_of_u_p1_106);
    let ratio_q_P2_u_P1_2_of_u_p1_108 = ratio_q_P2_u_P1_of_place_36
        .mul_add(u_p1_cos_q_p1, -ratio_q_P2_u_P1_2_of_u_p1_66)
        + ratio_q_P2_u_P1_2_of_u_p1_73 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_109 = ratio_q_P2_u_P1_of_place_110
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_102, ratio_q_P2_u_P1_2_of_u_p1_108);
    let ratio_q_P2_u_P1_2 = ratio_q_P2_u_P1_of_place_103
        * ((-ratio_q_P2_u_P1_of_place_18)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_54,
                ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_2_of_u_p1_63,
            ) + ratio_q_P2_u_P1_of_place_32 * ratio_q_P2_u_P1_2_of_u_p1_64
            - ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_2_of_u_p1_67
            + ratio_q_P2_u_P1_of_place_23 * ratio_q_P2_u_P1_2_of_u_p1_70
            - ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_2_of_u_p1_72)
        - ratio_q_P2_u_P1_of_place_107 * ratio_q_P2_u_P1_of_place_110 * ratio_q_P2_u_P1_2_of_u_p1_36
        - ratio_q_P2_u_P1_of_place_109 * ratio_q_P2_u_P1_2_of_u_p1_91
        + ratio_q_P2_u_P1_of_q_p4_q_p5_16 * ratio_q_P2_u_P1_2_of_u_p1_105
        + ratio_q_P2_u_P1_of_place_33 * ratio_q_P2_u_P1_2_of_u_p1_107
        + ratio_q_P2_u_P1_of_place_111 * ratio_q_P2_u_P1_2_of_u_p1_109;
    let ratio_q_P3_u_P1_2_of_u_p1 = (-ratio_q_P2_u_P1_of_place_41)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_53,
            S::int(2) * ratio_q_P2_u_P1_of_place_44 * ratio_q_P2_u_P1_2_of_u_p1_48,
        ) - ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_73
        + ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_2_of_u_p1_77;
    let ratio_q_P3_u_P1_2_of_u_p1_2 = (-ratio_q_P2_u_P1_of_place_41)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_42,
            ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_73,
        ) - ratio_q_P2_u_P1_of_place_44 * ratio_q_P2_u_P1_2_of_u_p1_44
        + ratio_q_P2_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_78;
    let ratio_q_P3_u_P1_2_of_u_p1_3 = ratio_q_P2_u_P1_2_of_u_p1_104
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_108 * ratio_q_P2_u_P1_2_of_u_p1_21);
    let ratio_q_P3_u_P1_2_of_u_p1_4 = ratio_q_P2_u_P1_of_place_102 * ratio_q_P2_u_P1_2_of_u_p1_109;
    let ratio_q_P3_u_P1_2 = ratio_q_P3_u_P1_of_place_5
        * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_14, ratio_q_P2_u_P1_2_of_u_p1)
            + ratio_q_P2_u_P1_2_of_u_p1_82 * cos_q_P5 - ratio_q_P2_u_P1_2_of_u_p1_83)
        + ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_86
        + ratio_q_P3_u_P1_of_place_3 * ratio_q_P2_u_P1_2_of_u_p1_107
        + ratio_q_P2_u_P1_of_place_103
            * ((-ratio_q_P2_u_P1_of_place_84)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_54,
                    ratio_q_P3_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_72,
                ) - ratio_q_P3_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_70
                - ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_2_of_u_p1_101
                - ratio_q_P2_u_P1_of_place_27 * ratio_q_P3_u_P1_2_of_u_p1
                + ratio_q_P2_u_P1_of_place_32 * ratio_q_P3_u_P1_2_of_u_p1_2)
        - ratio_q_P3_u_P1_of_q_p3_q_p5 * ratio_q_P3_u_P1_2_of_u_p1_3
        + ratio_q_P2_u_P1_of_place_53 * ratio_q_P3_u_P1_2_of_u_p1_4;
    let ratio_q_P4_u_P1_2_of_u_p1 = ratio_q_P2_u_P1_of_place_41 * ratio_q_P2_u_P1_2_of_u_p1_59
        - ratio_q_P2_u_P1_2_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_73
        + ratio_q_P2_u_P1_of_place_8
            * (-ratio_q_P2_u_P1_of_place_16)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_75,
                    cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_60,
                ) + ratio_q_P4_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_76;
    let ratio_q_P4_u_P1_2_of_u_p1_2 = ratio_q_P2_u_P1_2_of_u_p1_27 - ratio_q_P2_u_P1_2_of_u_p1_15;
    let ratio_q_P4_u_P1_2 = ratio_q_P4_u_P1_of_place_3 * ratio_q_P2_u_P1_2_of_u_p1_107
        - ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_99
        - ratio_q_P4_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_105
        + ratio_q_P2_u_P1_of_place_75 * ratio_q_P3_u_P1_2_of_u_p1_4
        + ratio_q_P2_u_P1_of_place_103
            * ((-ratio_q_P2_u_P1_of_place_84)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_63,
                    ratio_q_P2_u_P1_of_place_32 * ratio_q_P4_u_P1_2_of_u_p1,
                ) - ratio_q_P3_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_67
                - ratio_q_P4_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_72
                - ratio_q_P2_u_P1_of_place_23 * ratio_q_P2_u_P1_2_of_u_p1_101
                - ratio_q_P2_u_P1_of_place_18 * ratio_q_P3_u_P1_2_of_u_p1)
        + ratio_q_P2_u_P1_of_place_109
            * (-ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P4_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_3
                - sin_q_P4
                    * ((-ratio_q_P4_u_P1_of_q_p4_q_p5)
                        .mul_add(
                            ratio_q_P2_u_P1_2_of_u_p1_15,
                            ratio_q_P2_u_P1_2_of_u_p1_91 * sin_q_P3,
                        ) - ratio_q_P2_u_P1_2_of_u_p1_24 - ratio_q_P2_u_P1_2_of_u_p1_27)
                + ratio_q_P4_u_P1_2_of_u_p1_2);
    let ratio_q_P5_u_P1_2 = ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_100
        + ratio_q_P5_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_107
        - ratio_q_P5_u_P1_of_place_2 * ratio_q_P3_u_P1_2_of_u_p1_3
        + ratio_q_P2_u_P1_of_place_82 * ratio_q_P3_u_P1_2_of_u_p1_4
        + ratio_q_P2_u_P1_of_place_103
            * ((-ratio_q_P2_u_P1_of_place_84)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_64,
                    ratio_q_P2_u_P1_of_place_18 * ratio_q_P3_u_P1_2_of_u_p1_2,
                ) - ratio_q_P3_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_67
                - ratio_q_P4_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_70
                - ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_2_of_u_p1_101
                - ratio_q_P2_u_P1_of_place_27 * ratio_q_P4_u_P1_2_of_u_p1)
        + ratio_q_P3_u_P1_of_place_5
            * (ratio_q_P5_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3
                - ratio_q_P5_u_P1_of_q_p3_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1
                + sin_q_P4
                    * ((-(ratio_q_P2_u_P1_2_of_u_p1_2 * sin_q_P3))
                        .mul_add(
                            S::int(2),
                            ratio_q_P2_u_P1_of_q_p5_5 * ratio_q_P2_u_P1_2_of_u_p1_15,
                        ) + ratio_q_P2_u_P1_2_of_u_p1_33)
                + ratio_q_P2_u_P1_of_q_p5 * ratio_q_P4_u_P1_2_of_u_p1_2);
    let w_rod1_frame_22 = u_P1 * u_P1;
    let w_rod2_frame_23 = w_rod1_frame_in_rod2_frame_2 * w_rod2_frame_3;
    let alpha_rod2_frame_1 = w_rod2_frame_23;
    let alpha_rod2_frame_3 = u_P1 * ratio_q_P2_u_P1_2;
    let w_rod2_frame_11 = w_rod1_frame_in_rod2_frame_1 * w_rod1_frame_in_rod2_frame_1;
    let w_rod2_frame_12 = w_rod1_frame_in_rod2_frame_1 * w_rod1_frame_in_rod2_frame_2;
    let w_rod2_frame_33 = w_rod2_frame_3 * w_rod2_frame_3;
    let turn_rod2_frame_12 = alpha_rod2_frame_3 - w_rod2_frame_12;
    let turn_rod2_frame_22 = w_rod2_frame_11 + w_rod2_frame_33;
    let turn_rod2_frame_32 = alpha_rod2_frame_1 + w_rod2_frame_23;
    let alpha_rod2_frame_in_rod3_frame_2 = (-alpha_rod2_frame_3)
        .mul_add(sin_q_P3, w_rod1_frame_in_rod2_frame_1 * cos_q_p3_w_rod2_frame_3);
    let alpha_rod2_frame_in_rod3_frame_3 = w_rod1_frame_in_rod2_frame_1
        .mul_add(sin_q_p3_w_rod2_frame_3, alpha_rod2_frame_3 * cos_q_P3);
    let alpha_rod3_frame_1 = u_P1.mul_add(ratio_q_P3_u_P1_2, alpha_rod2_frame_1);
    let alpha_rod3_frame_2 = w_rod2_frame_in_rod3_frame_3
        .mul_add(u_p1_ratio_q_p3_u_p1, alpha_rod2_frame_in_rod3_frame_2);
    let alpha_rod3_frame_3 = w_rod2_frame_in_rod3_frame_2
        .mul_add(u_p1_ratio_q_p3_u_p1, -alpha_rod2_frame_in_rod3_frame_3);
    let w_rod3_frame_11 = w_rod3_frame_1 * w_rod3_frame_1;
    let w_rod3_frame_13 = w_rod2_frame_in_rod3_frame_3 * w_rod3_frame_1;
    let w_rod3_frame_22 = w_rod2_frame_in_rod3_frame_2 * w_rod2_frame_in_rod3_frame_2;
    let w_rod3_frame_23 = w_rod2_frame_in_rod3_frame_2 * w_rod2_frame_in_rod3_frame_3;
    let turn_rod3_frame_13 = alpha_rod3_frame_2 + w_rod3_frame_13;
    let turn_rod3_frame_23 = alpha_rod3_frame_1 + w_rod3_frame_23;
    let turn_rod3_frame_33 = w_rod3_frame_11 + w_rod3_frame_22;
    let alpha_rod3_frame_in_rod4_frame_1 = alpha_rod3_frame_3
        .mul_add(sin_q_P4, alpha_rod3_frame_1 * cos_q_P4);
    let alpha_rod3_frame_in_rod4_frame_3 = (-alpha_rod3_frame_1)
        .mul_add(sin_q_P4, alpha_rod3_frame_3 * cos_q_P4);
    let alpha_rod4_frame_1 = w_rod3_frame_in_rod4_frame_3
        .mul_add(u_p1_ratio_q_p4_u_p1, -alpha_rod3_frame_in_rod4_frame_1);
    let alpha_rod4_frame_2 = u_P1.mul_add(ratio_q_P4_u_P1_2, alpha_rod3_frame_2);
    let alpha_rod4_frame_3 = w_rod3_frame_in_rod4_frame_1
        .mul_add(u_p1_ratio_q_p4_u_p1, alpha_rod3_frame_in_rod4_frame_3);
    let w_rod4_frame_12 = w_rod3_frame_in_rod4_frame_1 * w_rod4_frame_2;
    let w_rod4_frame_13 = w_rod3_frame_in_rod4_frame_1 * w_rod3_frame_in_rod4_frame_3;
    let w_rod4_frame_22 = w_rod4_frame_2 * w_rod4_frame_2;
    let w_rod4_frame_33 = w_rod3_frame_in_rod4_frame_3 * w_rod3_frame_in_rod4_frame_3;
    let turn_rod4_frame_11 = w_rod4_frame_22 + w_rod4_frame_33;
    let turn_rod4_frame_21 = alpha_rod4_frame_3 + w_rod4_frame_12;
    let turn_rod4_frame_31 = alpha_rod4_frame_2 - w_rod4_frame_13;
    let alpha_rod4_frame_in_rod5_frame_1 = alpha_rod4_frame_2
        .mul_add(sin_q_P5, alpha_rod4_frame_1 * cos_q_P5);
    let alpha_rod5_frame_1 = w_rod4_frame_in_rod5_frame_2
        .mul_add(u_p1_ratio_q_p5_u_p1, -alpha_rod4_frame_in_rod5_frame_1);
    let alpha_rod5_frame_3 = u_P1.mul_add(ratio_q_P5_u_P1_2, alpha_rod4_frame_3);
    let w_rod5_frame_11 = w_rod4_frame_in_rod5_frame_1 * w_rod4_frame_in_rod5_frame_1;
    let w_rod5_frame_12 = w_rod4_frame_in_rod5_frame_1 * w_rod4_frame_in_rod5_frame_2;
    let w_rod5_frame_23 = w_rod4_frame_in_rod5_frame_2 * w_rod5_frame_3;
    let w_rod5_frame_33 = w_rod5_frame_3 * w_rod5_frame_3;
    let turn_rod5_frame_12 = alpha_rod5_frame_3 - w_rod5_frame_12;
    let turn_rod5_frame_22 = w_rod5_frame_11 + w_rod5_frame_33;
    let turn_rod5_frame_32 = alpha_rod5_frame_1 + w_rod5_frame_23;
    let a_rod1_centre_1 = l * w_rod1_frame_22;
    let a_rod1_frame_in_rod2_frame_1 = (-g)
        .mul_add(sin_q_P2, a_rod1_centre_1 * cos_q_P2);
    let a_rod1_frame_in_rod2_frame_2 = a_rod1_centre_1.mul_add(sin_q_P2, g * cos_q_P2);
    let l_turn_rod2_frame_12 = l * turn_rod2_frame_12;
    let a_rod2_centre_1 = a_rod1_frame_in_rod2_frame_1
        .mul_add(S::int(2), l_turn_rod2_frame_12);
    let a_rod2_centre_3 = l * turn_rod2_frame_32;
    let J_rod5_frame_11 = m * l_sq;
    let H_rod2_1 = w_rod1_frame_in_rod2_frame_1 * J_rod5_frame_11;
    let H_rod2_3 = w_rod2_frame_3 * J_rod5_frame_11;
    let a_rod3_centre_1 = a_rod1_frame_in_rod2_frame_1 + l_turn_rod2_frame_12;
    let a_rod3_centre_2 = l.mul_add(turn_rod2_frame_22, -a_rod1_frame_in_rod2_frame_2);
    let a_rod2_frame_in_rod3_frame_2 = (-a_rod2_centre_3)
        .mul_add(sin_q_P3, a_rod3_centre_2 * cos_q_P3);
    let a_rod2_frame_in_rod3_frame_3 = a_rod3_centre_2
        .mul_add(sin_q_P3, a_rod2_centre_3 * cos_q_P3);
    let l_turn_rod3_frame_13 = l * turn_rod3_frame_13;
    let a_rod3_centre_1_2 = a_rod3_centre_1.mul_add(S::int(2), l_turn_rod3_frame_13);
    let l_turn_rod3_frame_23 = l * turn_rod3_frame_23;
    let a_rod3_centre_2_2 = a_rod2_frame_in_rod3_frame_2
        .mul_add(S::int(2), l_turn_rod3_frame_23);
    let l_turn_rod3_frame_33 = l * turn_rod3_frame_33;
    let a_rod3_centre_3 = (-a_rod2_frame_in_rod3_frame_3)
        .mul_add(S::int(2), l_turn_rod3_frame_33);
    let H_rod3_1 = w_rod3_frame_1 * J_rod5_frame_11;
    let H_rod3_2 = w_rod2_frame_in_rod3_frame_2 * J_rod5_frame_11;
    let a_rod4_centre_1 = a_rod3_centre_1 + l_turn_rod3_frame_13;
    let a_rod4_centre_2 = a_rod2_frame_in_rod3_frame_2 + l_turn_rod3_frame_23;
    let a_rod4_centre_3 = l_turn_rod3_frame_33 - a_rod2_frame_in_rod3_frame_3;
    let a_rod3_frame_in_rod4_frame_1 = (-a_rod4_centre_1)
        .mul_add(cos_q_P4, a_rod4_centre_3 * sin_q_P4);
    let a_rod3_frame_in_rod4_frame_3 = a_rod4_centre_3
        .mul_add(cos_q_P4, a_rod4_centre_1 * sin_q_P4);
    let l_turn_rod4_frame_11 = l * turn_rod4_frame_11;
    let a_rod4_centre_1_2 = a_rod3_frame_in_rod4_frame_1
        .mul_add(S::int(2), l_turn_rod4_frame_11);
    let l_turn_rod4_frame_21 = l * turn_rod4_frame_21;
    let a_rod4_centre_2_2 = (-a_rod4_centre_2).mul_add(S::int(2), l_turn_rod4_frame_21);
    let l_turn_rod4_frame_31 = l * turn_rod4_frame_31;
    let a_rod4_centre_3_2 = a_rod3_frame_in_rod4_frame_3
        .mul_add(S::int(2), l_turn_rod4_frame_31);
    let H_rod4_2 = w_rod4_frame_2 * J_rod5_frame_11;
    let H_rod4_3 = w_rod3_frame_in_rod4_frame_3 * J_rod5_frame_11;
    let a_rod5_centre_1 = a_rod3_frame_in_rod4_frame_1 + l_turn_rod4_frame_11;
    let a_rod5_centre_2 = l_turn_rod4_frame_21 - a_rod4_centre_2;
    let a_rod5_centre_3 = a_rod3_frame_in_rod4_frame_3 + l_turn_rod4_frame_31;
    let a_rod4_frame_in_rod5_frame_1 = a_rod5_centre_2
        .mul_add(sin_q_P5, a_rod5_centre_1 * cos_q_P5);
    let a_rod4_frame_in_rod5_frame_2 = (-a_rod5_centre_2)
        .mul_add(cos_q_P5, a_rod5_centre_1 * sin_q_P5);
    let a_rod5_centre_1_2 = (-a_rod4_frame_in_rod5_frame_1)
        .mul_add(S::int(2), l * turn_rod5_frame_12);
    let a_rod5_centre_2_2 = (-a_rod4_frame_in_rod5_frame_2)
        .mul_add(S::int(2), l * turn_rod5_frame_22);
    let a_rod5_centre_3_2 = a_rod5_centre_3.mul_add(S::int(2), l * turn_rod5_frame_32);
    let H_rod5_1 = w_rod4_frame_in_rod5_frame_1 * J_rod5_frame_11;
    let H_rod5_3 = w_rod5_frame_3 * J_rod5_frame_11;
    let F_v_rod5_centre_3 = m * a_rod5_centre_3_2;
    let F_v_rod5_centre_1 = m * a_rod5_centre_1_2;
    let F_v_rod4_frame_in_rod5_frame_2 = m * a_rod5_centre_2_2;
    let F_v_rod5_centre_2 = (-F_v_rod5_centre_1)
        .mul_add(sin_q_P5, F_v_rod4_frame_in_rod5_frame_2 * cos_q_P5);
    let F_v_rod4_centre_3 = m * a_rod4_centre_3_2;
    let F_v_rod4_centre_2 = m * a_rod4_centre_2_2;
    let F_v_rod3_frame_in_rod4_frame_3 = F_v_rod5_centre_3 + F_v_rod4_centre_3;
    let F_v_rod3_frame_in_rod4_frame_1 = (-F_v_rod5_centre_1)
        .mul_add(cos_q_P5, m * a_rod4_centre_1_2) - F_v_rod4_frame_in_rod5_frame_2 * sin_q_P5;
    let F_v_rod4_centre_2_2 = F_v_rod5_centre_2 + F_v_rod4_centre_2;
    let F_v_rod4_centre_1 = (-F_v_rod3_frame_in_rod4_frame_1)
        .mul_add(cos_q_P4, F_v_rod3_frame_in_rod4_frame_3 * sin_q_P4);
    let F_v_rod3_centre_2 = m * a_rod3_centre_2_2;
    let F_v_rod3_centre_1 = m * a_rod3_centre_1_2;
    let F_v_rod2_frame_in_rod3_frame_3 = F_v_rod3_frame_in_rod4_frame_3
        .mul_add(cos_q_P4, m * a_rod3_centre_3) + F_v_rod3_frame_in_rod4_frame_1 * sin_q_P4;
    let F_v_rod2_frame_in_rod3_frame_2 = F_v_rod4_centre_2_2 - F_v_rod3_centre_2;
    let F_v_rod3_centre_3 = (-F_v_rod2_frame_in_rod3_frame_2)
        .mul_add(sin_q_P3, F_v_rod2_frame_in_rod3_frame_3 * cos_q_P3);
    let F_v_rod2_centre_3 = m * a_rod2_centre_3;
    let F_v_rod2_centre_1_of_place = F_v_rod4_centre_1 + F_v_rod3_centre_1;
    let F_v_rod2_centre_1 = F_v_rod2_centre_1_of_place
        .mul_add(S::int(2), m * a_rod2_centre_1);
    let F_v_rod1_centre_3 = F_v_rod3_centre_3 - F_v_rod2_centre_3;
    let l_times_3 = S::int(3) * l;
    let F_w_rod5_frame_3 = (-alpha_rod5_frame_3)
        .mul_add(J_rod5_frame_11, w_rod4_frame_in_rod5_frame_2 * H_rod5_1)
        - F_v_rod5_centre_1 * l_times_3;
    let F_w_rod4_frame_in_rod5_frame_2 = (-w_rod4_frame_in_rod5_frame_1)
        .mul_add(H_rod5_3, w_rod5_frame_3 * H_rod5_1);
    let F_w_rod4_frame_in_rod5_frame_1 = alpha_rod5_frame_1
        .mul_add(J_rod5_frame_11, w_rod4_frame_in_rod5_frame_2 * H_rod5_3)
        + F_v_rod5_centre_3 * l_times_3;
    let l_times_6 = S::int(6) * l;
    let F_w_rod4_frame_2 = (-F_w_rod4_frame_in_rod5_frame_2)
        .mul_add(cos_q_P5, w_rod3_frame_in_rod4_frame_1 * H_rod4_3)
        + F_w_rod4_frame_in_rod5_frame_1 * sin_q_P5
        - alpha_rod4_frame_2 * J_rod5_frame_11 - F_v_rod4_centre_3 * l_times_3
        - F_v_rod5_centre_3 * l_times_6;
    let F_w_rod3_frame_in_rod4_frame_3 = w_rod3_frame_in_rod4_frame_1
        .mul_add(H_rod4_2, -F_w_rod5_frame_3) + alpha_rod4_frame_3 * J_rod5_frame_11
        + F_v_rod4_centre_2 * l_times_3 + F_v_rod5_centre_2 * l_times_6;
    let F_w_rod3_frame_in_rod4_frame_1 = (-w_rod3_frame_in_rod4_frame_3)
        .mul_add(H_rod4_2, w_rod4_frame_2 * H_rod4_3) + F_w_rod4_frame_in_rod5_frame_2 * sin_q_P5
        + F_w_rod4_frame_in_rod5_frame_1 * cos_q_P5;
    let F_w_rod3_frame_1 = (-F_w_rod3_frame_in_rod4_frame_3)
        .mul_add(sin_q_P4, w_rod2_frame_in_rod3_frame_3 * H_rod3_2)
        + F_w_rod3_frame_in_rod4_frame_1 * cos_q_P4
        + alpha_rod3_frame_1 * J_rod5_frame_11 + F_v_rod3_centre_2 * l_times_3
        - F_v_rod4_centre_2_2 * l_times_6;
    let F_w_rod2_frame_in_rod3_frame_3 = (-w_rod2_frame_in_rod3_frame_2)
        .mul_add(H_rod3_1, w_rod3_frame_1 * H_rod3_2) - F_w_rod3_frame_in_rod4_frame_3 * cos_q_P4
        - F_w_rod3_frame_in_rod4_frame_1 * sin_q_P4;
    let F_w_rod2_frame_in_rod3_frame_2 = w_rod2_frame_in_rod3_frame_3
        .mul_add(H_rod3_1, -F_w_rod4_frame_2) + alpha_rod3_frame_2 * J_rod5_frame_11
        + F_v_rod3_centre_1 * l_times_3 + F_v_rod4_centre_1 * l_times_6;
    let F_w_rod2_frame_3 = (-F_w_rod2_frame_in_rod3_frame_3)
        .mul_add(cos_q_P3, w_rod1_frame_in_rod2_frame_2 * H_rod2_1)
        + F_w_rod2_frame_in_rod3_frame_2 * sin_q_P3
        - alpha_rod2_frame_3 * J_rod5_frame_11 - F_v_rod2_centre_1 * l_times_3;
    let F_w_rod1_frame_in_rod2_frame_2 = (-w_rod1_frame_in_rod2_frame_1)
        .mul_add(H_rod2_3, w_rod2_frame_3 * H_rod2_1) - F_w_rod2_frame_in_rod3_frame_3 * sin_q_P3
        - F_w_rod2_frame_in_rod3_frame_2 * cos_q_P3;
    let F_w_rod1_frame_in_rod2_frame_1 = w_rod1_frame_in_rod2_frame_2
        .mul_add(H_rod2_3, F_w_rod3_frame_1) + alpha_rod2_frame_1 * J_rod5_frame_11
        + F_v_rod2_centre_3 * l_times_3 - F_v_rod3_centre_3 * l_times_6;
    let mr_rod5_frame_2 = l * m;
    let rw_rod5_frame_2 = l * mr_rod5_frame_2;
    let J_rod5_frame_11_2 = rw_rod5_frame_2.mul_add(S::int(3), J_rod5_frame_11);
    let s_rod5_frame_in_rod4_frame_1 = mr_rod5_frame_2 * sin_q_P5;
    let s_rod5_frame_in_rod4_frame_2 = mr_rod5_frame_2 * cos_q_P5;
    let J_rod5_frame_in_rod4_frame = J_rod5_frame_11_2 * sin_q_P5;
    let J_rod5_frame_in_rod4_frame_2 = J_rod5_frame_in_rod4_frame * sin_q_P5;
    let J_rod5_frame_in_rod4_frame_11 = J_rod5_frame_11_2 - J_rod5_frame_in_rod4_frame_2;
    let J_rod5_frame_in_rod4_frame_12 = J_rod5_frame_in_rod4_frame * cos_q_P5;
    let s_rod4_frame_1 = mr_rod5_frame_2
        .mul_add(S::int(2), -s_rod5_frame_in_rod4_frame_1);
    let w_rod4_frame_1 = s_rod5_frame_in_rod4_frame_1 - s_rod4_frame_1;
    let rw_rod4_frame_1 = l * w_rod4_frame_1;
    let s_rod4_frame_1_2 = mr_rod5_frame_2 + s_rod4_frame_1;
    let J_rod4_frame_12_of_place = s_rod5_frame_in_rod4_frame_2 * l_times_6;
    let J_rod4_frame_12 = J_rod5_frame_in_rod4_frame_12 - J_rod4_frame_12_of_place;
    let J_rod4_frame_22_of_place = (-rw_rod4_frame_1)
        .mul_add(S::int(6), J_rod5_frame_11_2);
    let J_rod4_frame_22 = J_rod5_frame_in_rod4_frame_2 + J_rod4_frame_22_of_place;
    let J_rod4_frame_33 = J_rod5_frame_11_2 + J_rod4_frame_22_of_place;
    let s_rod4_frame_in_rod3_frame_1 = s_rod4_frame_1_2 * cos_q_P4;
    let s_rod4_frame_in_rod3_frame_3 = s_rod4_frame_1_2 * sin_q_P4;
    let J_rod4_frame_in_rod3_frame_1 = J_rod4_frame_12 * cos_q_P4;
    let J_rod4_frame_in_rod3_frame_3 = J_rod4_frame_12 * sin_q_P4;
    let J_rod4_frame_in_rod3_frame_31 = J_rod5_frame_in_rod4_frame_11 - J_rod4_frame_33;
    let J_rod4_frame_in_rod3_frame = J_rod4_frame_in_rod3_frame_31 * sin_q_P4;
    let J_rod4_frame_in_rod3_frame_2 = J_rod4_frame_in_rod3_frame * sin_q_P4;
    let J_rod4_frame_in_rod3_frame_11 = J_rod5_frame_in_rod4_frame_11
        - J_rod4_frame_in_rod3_frame_2;
    let J_rod4_frame_in_rod3_frame_13 = J_rod4_frame_in_rod3_frame * cos_q_P4;
    let J_rod4_frame_in_rod3_frame_33 = J_rod4_frame_33 + J_rod4_frame_in_rod3_frame_2;
    let s_rod3_frame_3 = mr_rod5_frame_2
        .mul_add(S::int(4), s_rod4_frame_in_rod3_frame_3);
    let w_rod3_frame_3 = s_rod4_frame_in_rod3_frame_3 + s_rod3_frame_3;
    let rw_rod3_frame_3 = l * w_rod3_frame_3;
    let s_rod3_frame_3_2 = mr_rod5_frame_2 + s_rod3_frame_3;
    let J_rod3_frame_11_of_place = rw_rod3_frame_3.mul_add(S::int(6), J_rod5_frame_11_2);
    let J_rod3_frame_11 = J_rod4_frame_in_rod3_frame_11 + J_rod3_frame_11_of_place;
    let J_rod3_frame_13_of_place = s_rod4_frame_in_rod3_frame_1 * l_times_6;
    let J_rod3_frame_13 = J_rod4_frame_in_rod3_frame_13 - J_rod3_frame_13_of_place;
    let J_rod3_frame_22 = J_rod4_frame_22 + J_rod3_frame_11_of_place;
    let J_rod3_frame_23 = J_rod4_frame_12_of_place - J_rod4_frame_in_rod3_frame_3;
    let s_rod3_frame_in_rod2_frame_2 = s_rod3_frame_3_2
        .mul_add(sin_q_P3, s_rod5_frame_in_rod4_frame_2 * cos_q_P3);
    let s_rod3_frame_in_rod2_frame_3 = (-s_rod3_frame_3_2)
        .mul_add(cos_q_P3, s_rod5_frame_in_rod4_frame_2 * sin_q_P3);
    let J_rod3_frame_in_rod2_frame_2 = J_rod3_frame_13
        .mul_add(sin_q_P3, J_rod4_frame_in_rod3_frame_1 * cos_q_P3);
    let J_rod3_frame_in_rod2_frame_3 = (-J_rod3_frame_13)
        .mul_add(cos_q_P3, J_rod4_frame_in_rod3_frame_1 * sin_q_P3);
    let J_rod3_frame_in_rod2_frame_23 = J_rod4_frame_in_rod3_frame_33 - J_rod3_frame_22;
    let J_rod3_frame_in_rod2_frame = (-J_rod3_frame_23)
        .mul_add(cos_q_p3_doubled, J_rod3_frame_in_rod2_frame_23 * sin_q_P3);
    let J_rod3_frame_in_rod2_frame_2_ = J_rod3_frame_in_rod2_frame * sin_q_P3;
    let J_rod3_frame_in_rod2_frame_22 = J_rod3_frame_22 + J_rod3_frame_in_rod2_frame_2_;
    let J_rod3_frame_in_rod2_frame_23_2 = J_rod3_frame_in_rod2_frame
        .mul_add(cos_q_P3, J_rod3_frame_23);
    let J_rod3_frame_in_rod2_frame_33 = J_rod4_frame_in_rod3_frame_33
        - J_rod3_frame_in_rod2_frame_2_;
    let s_rod2_frame_2 = mr_rod5_frame_2
        .mul_add(S::int(6), -s_rod3_frame_in_rod2_frame_2);
    let w_rod2_frame_2 = s_rod3_frame_in_rod2_frame_2 - s_rod2_frame_2;
    let rw_rod2_frame_2 = l * w_rod2_frame_2;
    let s_rod2_frame_2_2 = mr_rod5_frame_2 + s_rod2_frame_2;
    let J_rod2_frame_11_of_place = (-rw_rod2_frame_2)
        .mul_add(S::int(6), J_rod5_frame_11_2);
    let J_rod2_frame_11 = J_rod3_frame_11 + J_rod2_frame_11_of_place;
    let J_rod2_frame_12 = J_rod3_frame_in_rod2_frame_2 + J_rod3_frame_13_of_place;
    let J_rod2_frame_23 = (-s_rod3_frame_in_rod2_frame_3)
        .mul_add(l_times_6, J_rod3_frame_in_rod2_frame_23_2);
    let J_rod2_frame_33 = J_rod3_frame_in_rod2_frame_33 + J_rod2_frame_11_of_place;
    let s_rod2_frame_in_rod1_frame_1 = s_rod2_frame_2_2
        .mul_add(sin_q_P2, s_rod4_frame_in_rod3_frame_1 * cos_q_P2);
    let J_rod2_frame_in_rod1_frame_2 = (-J_rod2_frame_23)
        .mul_add(cos_q_P2, J_rod3_frame_in_rod2_frame_3 * sin_q_P2);
    let J_rod2_frame_in_rod1_frame_12 = J_rod3_frame_in_rod2_frame_22 - J_rod2_frame_11;
    let J_rod2_frame_in_rod1_frame = (-(J_rod2_frame_12 * cos_q_P2))
        .mul_add(S::int(2), J_rod2_frame_in_rod1_frame_12 * sin_q_P2);
    let J_rod2_frame_in_rod1_frame_2_ = J_rod2_frame_in_rod1_frame * sin_q_P2;
    let J_rod2_frame_in_rod1_frame_22 = J_rod3_frame_in_rod2_frame_22
        - J_rod2_frame_in_rod1_frame_2_;
    let s_rod1_frame_1 = mr_rod5_frame_2
        .mul_add(S::int(8), -s_rod2_frame_in_rod1_frame_1);
    let w_rod1_frame_1 = s_rod2_frame_in_rod1_frame_1 - s_rod1_frame_1;
    let rw_rod1_frame_1 = l * w_rod1_frame_1;
    let J_rod1_frame_22 = (-rw_rod1_frame_1)
        .mul_add(S::int(6), J_rod5_frame_11_2 + J_rod2_frame_in_rod1_frame_22);
    let h_rod3_frame_rod2_frame_1_of_place = s_rod3_frame_in_rod2_frame_2 * l_times_6;
    let h_rod3_frame_rod2_frame_1 = J_rod3_frame_11 - h_rod3_frame_rod2_frame_1_of_place;
    let h_rod3_frame_in_rod2_frame_2 = h_rod3_frame_rod2_frame_1
        .mul_add(sin_q_P2, J_rod3_frame_in_rod2_frame_2 * cos_q_P2);
    let h_rod3_frame_rod1_frame_2 = h_rod3_frame_in_rod2_frame_2
        + h_rod3_frame_rod2_frame_1_of_place;
    let h_rod4_frame_rod3_frame_2_of_place = s_rod4_frame_in_rod3_frame_3 * l_times_6;
    let h_rod4_frame_rod3_frame_2 = J_rod4_frame_22 + h_rod4_frame_rod3_frame_2_of_place;
    let p_rod4_frame_in_rod3_frame_3 = s_rod4_frame_in_rod3_frame_1 * cos_q_P3;
    let h_rod4_frame_in_rod3_frame_2 = h_rod4_frame_rod3_frame_2
        .mul_add(cos_q_P3, J_rod4_frame_in_rod3_frame_3 * sin_q_P3);
    let h_rod4_frame_in_rod3_frame_3 = (-J_rod4_frame_in_rod3_frame_3)
        .mul_add(cos_q_P3, h_rod4_frame_rod3_frame_2 * sin_q_P3);
    let h_rod4_frame_rod2_frame_1_of_place = p_rod4_frame_in_rod3_frame_3 * l_times_6;
    let h_rod4_frame_rod2_frame_1 = J_rod4_frame_in_rod3_frame_1
        + h_rod4_frame_rod2_frame_1_of_place;
    let h_rod4_frame_rod2_frame_3 = h_rod4_frame_rod3_frame_2_of_place
        - h_rod4_frame_in_rod3_frame_3;
    let h_rod4_frame_in_rod2_frame_2 = h_rod4_frame_rod2_frame_1
        .mul_add(sin_q_P2, h_rod4_frame_in_rod3_frame_2 * cos_q_P2);
    let h_rod4_frame_rod1_frame_2 = h_rod4_frame_rod2_frame_1_of_place
        - h_rod4_frame_in_rod2_frame_2;
    let h_rod5_frame_rod4_frame_3_of_place = s_rod5_frame_in_rod4_frame_1 * l_times_6;
    let h_rod5_frame_rod4_frame_3 = J_rod5_frame_11_2 - h_rod5_frame_rod4_frame_3_of_place;
    let p_rod5_frame_in_rod4_frame_1 = s_rod5_frame_in_rod4_frame_2 * cos_q_P4;
    let p_rod5_frame_in_rod4_frame_3 = s_rod5_frame_in_rod4_frame_2 * sin_q_P4;
    let h_rod5_frame_in_rod4_frame_1 = h_rod5_frame_rod4_frame_3 * sin_q_P4;
    let h_rod5_frame_in_rod4_frame_3 = h_rod5_frame_rod4_frame_3 * cos_q_P4;
    let h_rod5_frame_rod3_frame_1 = h_rod5_frame_rod4_frame_3_of_place
        - h_rod5_frame_in_rod4_frame_1;
    let h_rod5_frame_rod3_frame_2 = l * p_rod5_frame_in_rod4_frame_1;
    let p_rod5_frame_in_rod3_frame_3 = (-p_rod5_frame_in_rod4_frame_3)
        .mul_add(cos_q_P3, s_rod5_frame_in_rod4_frame_1 * sin_q_P3);
    let h_rod5_frame_in_rod3_frame_2_of_place = S::int(6) * h_rod5_frame_rod3_frame_2;
    let h_rod5_frame_in_rod3_frame_2 = (-h_rod5_frame_in_rod4_frame_3)
        .mul_add(sin_q_P3, h_rod5_frame_in_rod3_frame_2_of_place * cos_q_P3);
    let h_rod5_frame_in_rod3_frame_3 = h_rod5_frame_in_rod3_frame_2_of_place
        .mul_add(sin_q_P3, h_rod5_frame_in_rod4_frame_3 * cos_q_P3);
    let h_rod5_frame_rod2_frame_1_of_place = p_rod5_frame_in_rod3_frame_3 * l_times_6;
    let h_rod5_frame_rod2_frame_1 = h_rod5_frame_rod3_frame_1 - h_rod5_frame_rod2_frame_1_of_place;
    let h_rod5_frame_rod2_frame_3 = p_rod5_frame_in_rod4_frame_1
        .mul_add(l_times_6, -h_rod5_frame_in_rod3_frame_3);
    let h_rod5_frame_in_rod2_frame_2 = (-h_rod5_frame_in_rod3_frame_2)
        .mul_add(cos_q_P2, h_rod5_frame_rod2_frame_1 * sin_q_P2);
    let h_rod5_frame_rod1_frame_2 = h_rod5_frame_in_rod2_frame_2
        + h_rod5_frame_rod2_frame_1_of_place;
    let ratio_q_p4_u_p1_doubled = S::int(2) * ratio_q_P4_u_P1;
    let ratio_q_p5_u_p1_doubled = S::int(2) * ratio_q_P5_u_P1;
    let m11_of_place = ratio_q_P3_u_P1
        .mul_add(J_rod3_frame_in_rod2_frame_3, J_rod2_frame_in_rod1_frame_2);
    let ratio_q_p2_u_p1_by_12 = S::ratio(1, 12) * ratio_q_P2_u_P1;
    let ratio_q_p3_u_p1_by_12 = S::ratio(1, 12) * ratio_q_P3_u_P1;
    let ratio_q_p4_u_p1_by_12 = S::ratio(1, 12) * ratio_q_P4_u_P1;
    let ratio_q_p5_u_p1_by_12 = S::ratio(1, 12) * ratio_q_P5_u_P1;
    let f1_of_place = F_w_rod1_frame_in_rod2_frame_1
        .mul_add(sin_q_P2, F_w_rod1_frame_in_rod2_frame_2 * cos_q_P2);
    // Values.
    let m11 = S::ratio(1, 12) * J_rod1_frame_22
        + ratio_q_p2_u_p1_by_12
            * (h_rod4_frame_rod2_frame_3
                .mul_add(ratio_q_p4_u_p1_doubled, ratio_q_P2_u_P1 * J_rod2_frame_33)
                + h_rod5_frame_rod2_frame_3 * ratio_q_p5_u_p1_doubled + S::int(2) * m11_of_place)
        + ratio_q_p3_u_p1_by_12
            * (h_rod3_frame_rod1_frame_2
                .mul_add(S::int(2), ratio_q_P3_u_P1 * J_rod3_frame_11)
                - J_rod4_frame_in_rod3_frame_1 * ratio_q_p4_u_p1_doubled
                + h_rod5_frame_rod3_frame_1 * ratio_q_p5_u_p1_doubled)
        + ratio_q_p4_u_p1_by_12
            * h_rod4_frame_rod1_frame_2
                .mul_add(S::int(2), ratio_q_P4_u_P1 * J_rod4_frame_22)
        + ratio_q_p5_u_p1_by_12
            * h_rod5_frame_rod1_frame_2
                .mul_add(S::int(2), ratio_q_P5_u_P1 * J_rod5_frame_11_2);
    let f1 = F_w_rod2_frame_3
        .mul_add(ratio_q_p2_u_p1_by_12, -S::ratio(1, 2) * l * F_v_rod1_centre_3)
        - F_w_rod3_frame_1 * ratio_q_p3_u_p1_by_12 + F_w_rod4_frame_2 * ratio_q_p4_u_p1_by_12
        + F_w_rod5_frame_3 * ratio_q_p5_u_p1_by_12 - S::ratio(1, 12) * f1_of_place;
    ([m11], [f1])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 274 operations, 5 sines and cosines.
#[must_use]
pub fn divisors<S: Scalar>(p: &Parameters<S>, q: &[S; 5], _u: &[S; 1]) -> [S; 1] {
    let Parameters { l, .. } = *p;
    let [q_P1, q_P2, q_P3, q_P4, q_P5] = *q;
    // Sines and cosines.
    let (sin_q_P5, cos_q_P5) = q_P5.sin_cos();
    let (sin_q_P4, cos_q_P4) = q_P4.sin_cos();
    let (sin_q_P3, cos_q_P3) = q_P3.sin_cos();
    let (sin_q_P2, cos_q_P2) = q_P2.sin_cos();
    let (sin_q_P1, cos_q_P1) = q_P1.sin_cos();
    // Shared terms.
    // 1 - sin(q_P5)
    let divisor1_of_q_p5 = S::int(1) - sin_q_P5;
    // -divisor1_of_q_p5
    let minus_divisor1_of_q_p5 = -divisor1_of_q_p5;
    let divisor1_of_q_p4_q_p5 = minus_divisor1_of_q_p5 * sin_q_P4;
    // divisor1_of_q_p4_q_p5 - 1
    let divisor1_of_q_p4_q_p5_2 = divisor1_of_q_p4_q_p5 - S::int(1);
    let sin_q_p3_cos_q_p5 = sin_q_P3 * cos_q_P5;
    // divisor1_of_q_p4_q_p5_2*cos(q_P3) + sin_q_p3_cos_q_p5
    let divisor1_of_place = divisor1_of_q_p4_q_p5_2.mul_add(cos_q_P3, sin_q_p3_cos_q_p5);
    let cos_q_p3_cos_q_p5 = cos_q_P3 * cos_q_P5;
    // divisor1_of_q_p4_q_p5_2*sin(q_P3) - cos_q_p3_cos_q_p5
    let divisor1_of_place_2 = divisor1_of_q_p4_q_p5_2
        .mul_add(sin_q_P3, -cos_q_p3_cos_q_p5);
    // -1 - divisor1_of_place_2
    let divisor1_of_place_3 = -S::int(1) - divisor1_of_place_2;
    let cos_q_p2_cos_q_p4 = cos_q_P2 * cos_q_P4;
    // divisor1_of_place_3*sin(q_P2) + minus_divisor1_of_q_p5*cos_q_p2_cos_q_p4
    let divisor1_of_place_4 = minus_divisor1_of_q_p5
        .mul_add(cos_q_p2_cos_q_p4, divisor1_of_place_3 * sin_q_P2);
    let sin_q_p2_cos_q_p4 = sin_q_P2 * cos_q_P4;
    let cos_q_p2_sin_q_p4 = cos_q_P2 * sin_q_P4;
    let cos_q_p3_cos_q_p1 = cos_q_P1 * cos_q_P3;
    let divisor1_of_place_5 = cos_q_p3_cos_q_p1 * cos_q_P4;
    // cos_q_p3_cos_q_p5*sin(q_P4) - sin(q_P3)*sin(q_P5)
    let divisor1_of_place_6 = (-sin_q_P3)
        .mul_add(sin_q_P5, cos_q_p3_cos_q_p5 * sin_q_P4);
    // cos(q_P3)*sin(q_P5) + sin_q_p3_cos_q_p5*sin(q_P4)
    let divisor1_of_place_7 = sin_q_p3_cos_q_p5.mul_add(sin_q_P4, cos_q_P3 * sin_q_P5);
    // cos_q_p2_cos_q_p4*cos(q_P5) - divisor1_of_place_7*sin(q_P2)
    let divisor1_of_place_8 = (-divisor1_of_place_7)
        .mul_add(sin_q_P2, cos_q_p2_cos_q_p4 * cos_q_P5);
    // divisor1_of_place_6*cos(q_P1) + divisor1_of_place_8*sin(q_P1)
    let divisor1_of_place_9 = divisor1_of_place_8
        .mul_add(sin_q_P1, divisor1_of_place_6 * cos_q_P1);
    let divisor1_of_q_p3_q_p5 = minus_divisor1_of_q_p5 * sin_q_P3;
    let divisor1_of_place_10 = divisor1_of_q_p4_q_p5 * cos_q_P2;
    // sin_q_p2_cos_q_p4*divisor1_of_q_p3_q_p5 + divisor1_of_place_10
    let divisor1_of_place_11 = sin_q_p2_cos_q_p4
        .mul_add(divisor1_of_q_p3_q_p5, divisor1_of_place_10);
    let sin_q_p3_cos_q_p1 = cos_q_P1 * sin_q_P3;
    let sin_q_p2_sin_q_p1 = sin_q_P1 * sin_q_P2;
    // sin(q_P5)*(cos_q_p3_cos_q_p1*sin(q_P4) - sin(q_P1)*(sin(q_P2)*sin(q_P3)*sin(q_P4) -
    //   cos_q_p2_cos_q_p4)) + cos(q_P5)*(sin_q_p3_cos_q_p1 + sin_q_p2_sin_q_p1*cos(q_P3))
    let divisor1_of_place_12 = sin_q_P5
        * (-sin_q_P1 * (sin_q_P2 * sin_q_P3).mul_add(sin_q_P4, -cos_q_p2_cos_q_p4)
            + cos_q_p3_cos_q_p1 * sin_q_P4)
        + cos_q_P5 * sin_q_p2_sin_q_p1.mul_add(cos_q_P3, sin_q_p3_cos_q_p1);
    // cos_q_p2_cos_q_p4*divisor1_of_q_p3_q_p5 - divisor1_of_q_p4_q_p5*sin(q_P2)
    let divisor1_of_place_13 = (-divisor1_of_q_p4_q_p5)
        .mul_add(sin_q_P2, cos_q_p2_cos_q_p4 * divisor1_of_q_p3_q_p5);
    let divisor1_of_place_14 = minus_divisor1_of_q_p5 * sin_q_p2_cos_q_p4;
    // divisor1_of_place_3*cos(q_P2) - divisor1_of_place_14
    let divisor1_of_place_15 = divisor1_of_place_3
        .mul_add(cos_q_P2, -divisor1_of_place_14);
    let divisor1_of_place_16 = divisor1_of_place_7 * cos_q_P2;
    // sin_q_p2_cos_q_p4*cos(q_P5) + divisor1_of_place_16
    let divisor1_of_place_17 = sin_q_p2_cos_q_p4.mul_add(cos_q_P5, divisor1_of_place_16);
    // l^2*sin(q_P1)*(divisor1_of_place_12*divisor1_of_place_15 - divisor1_of_place_9*divisor1_of_place_17)
    let divisor1_of_place_18 = l * l * sin_q_P1
        * (-divisor1_of_place_9)
            .mul_add(divisor1_of_place_17, divisor1_of_place_12 * divisor1_of_place_15);
    let l_sq = l * l;
    let divisor1_of_place_19 = divisor1_of_place_17 * l_sq;
    // sin(q_P3) - 1
    let divisor1_of_q_p3 = sin_q_P3 - S::int(1);
    let divisor1_of_q_p3_q_p5_2 = minus_divisor1_of_q_p5 * cos_q_P3;
    let cos_q_p2_sin_q_p1 = sin_q_P1 * cos_q_P2;
    let divisor1_of_place_20 = divisor1_of_q_p4_q_p5 * cos_q_p2_sin_q_p1;
    // cos_q_p2_sin_q_p1*(sin(q_P1)*cos(q_P5)*(cos_q_p2_sin_q_p4 - sin(q_P3)*(cos_q_p2_sin_q_p4 +
    //   sin_q_p2_cos_q_p4*divisor1_of_q_p3)) + cos(q_P3)*(cos(q_P4)*(divisor1_of_q_p3_q_p5*sin_q_p2_sin_q_p1
    //   - cos(q_P1)*(divisor1_of_q_p3_q_p5_2 - divisor1_of_q_p3*cos(q_P5))) + divisor1_of_place_20))
    let divisor1_of_place_21 = cos_q_p2_sin_q_p1
        * (sin_q_P1 * cos_q_P5
            * (cos_q_p2_sin_q_p4
                - sin_q_P3 * sin_q_p2_cos_q_p4.mul_add(divisor1_of_q_p3, cos_q_p2_sin_q_p4))
            + cos_q_P3
                * (cos_q_P4
                    * (-cos_q_P1 * (-divisor1_of_q_p3).mul_add(cos_q_P5, divisor1_of_q_p3_q_p5_2)
                        + divisor1_of_q_p3_q_p5 * sin_q_p2_sin_q_p1) + divisor1_of_place_20));
    let divisor1_of_place_22 = divisor1_of_place * cos_q_P2;
    // cos_q_p3_cos_q_p5 + divisor1_of_q_p3_q_p5
    let divisor1_of_q_p3_q_p5_3 = cos_q_p3_cos_q_p5 + divisor1_of_q_p3_q_p5;
    // cos(q_P1)*(sin_q_p3_cos_q_p5 - divisor1_of_q_p3_q_p5_2)
    let divisor1_of_place_23 = cos_q_P1 * (sin_q_p3_cos_q_p5 - divisor1_of_q_p3_q_p5_2);
    // sin(q_P1)*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P4)*(divisor1_of_q_p5 - cos_q_p3_cos_q_p5) +
    //   divisor1_of_q_p3*sin(q_P5)) - sin_q_p2_cos_q_p4*divisor1_of_q_p3_q_p5_3) -
    //   divisor1_of_place_23*cos(q_P4)) - divisor1_of_place_16*cos(q_P1))
    let divisor1_of_place_24 = sin_q_P1
        * (sin_q_P2
            * (sin_q_P1
                * (cos_q_P2
                    * (sin_q_P4 * (divisor1_of_q_p5 - cos_q_p3_cos_q_p5)
                        + divisor1_of_q_p3 * sin_q_P5)
                    - sin_q_p2_cos_q_p4 * divisor1_of_q_p3_q_p5_3)
                - divisor1_of_place_23 * cos_q_P4) - divisor1_of_place_16 * cos_q_P1);
    // 1 + sin(q_P4)
    let divisor1_of_q_p4 = S::int(1) + sin_q_P4;
    let cos_q_p4_sq = cos_q_P4 * cos_q_P4;
    // cos_q_p4_sq + sin(q_P5)*(divisor1_of_q_p4 - cos_q_p4_sq)
    let divisor1_of_q_p4_q_p5_3 = cos_q_p4_sq + sin_q_P5 * (divisor1_of_q_p4 - cos_q_p4_sq);
    let divisor1_of_place_25 = divisor1_of_q_p4_q_p5_3 * sin_q_P3;
    // cos_q_p2_cos_q_p4*(sin(q_P5) + divisor1_of_q_p4_q_p5)
    let divisor1_of_place_26 = cos_q_p2_cos_q_p4 * (sin_q_P5 + divisor1_of_q_p4_q_p5);
    let divisor1_of_place_27 = divisor1_of_q_p4_q_p5_3 * cos_q_P3;
    let divisor1_of_place_28 = sin_q_p3_cos_q_p5 * divisor1_of_q_p4;
    let divisor1_of_place_4_l_sq = divisor1_of_place_4 * l_sq;
    let cos_q_p5_sq = cos_q_P5 * cos_q_P5;
    // 2*divisor1_of_q_p5 - cos_q_p5_sq
    let divisor1_of_q_p5_2 = divisor1_of_q_p5.mul_add(S::int(2), -cos_q_p5_sq);
    // -divisor1_of_q_p5_2
    let minus_divisor1_of_q_p5_2 = -divisor1_of_q_p5_2;
    let cos_q_p4_sq_doubled = S::int(2) * cos_q_p4_sq;
    let divisor1_of_q_p4_q_p5_4 = minus_divisor1_of_q_p5_2 * cos_q_p4_sq_doubled;
    // divisor1_of_q_p5 - cos_q_p5_sq
    let divisor1_of_q_p5_3 = divisor1_of_q_p5 - cos_q_p5_sq;
    let divisor1_of_q_p4_q_p5_5 = cos_q_p4_sq * minus_divisor1_of_q_p5_2;
    // -minus_divisor1_of_q_p5*cos_q_p4_sq - sin(q_P4)*(divisor1_of_q_p5_3 + divisor1_of_q_p4_q_p5_5)
    let divisor1_of_q_p4_q_p5_6 = -sin_q_P4 * (divisor1_of_q_p5_3 + divisor1_of_q_p4_q_p5_5)
        - minus_divisor1_of_q_p5 * cos_q_p4_sq;
    // divisor1_of_q_p4_q_p5_6 - divisor1_of_q_p5_3
    let divisor1_of_q_p4_q_p5_7 = divisor1_of_q_p4_q_p5_6 - divisor1_of_q_p5_3;
    // divisor1_of_q_p5*(divisor1_of_q_p4 - cos_q_p4_sq_doubled)
    let divisor1_of_q_p4_q_p5_8 = divisor1_of_q_p5 * (divisor1_of_q_p4 - cos_q_p4_sq_doubled);
    // cos(q_P3)*(divisor1_of_q_p4_q_p5_7*cos(q_P3) + sin_q_p3_cos_q_p5*divisor1_of_q_p4_q_p5_8)
    let divisor1_of_place_29 = cos_q_P3
        * sin_q_p3_cos_q_p5
            .mul_add(divisor1_of_q_p4_q_p5_8, divisor1_of_q_p4_q_p5_7 * cos_q_P3);
    let divisor1_of_q_p4_q_p5_9 = S::int(2) * divisor1_of_q_p4_q_p5;
    // cos_q_p5_sq - 3*divisor1_of_q_p5 - divisor1_of_q_p4_q_p5_4 + divisor1_of_q_p4_q_p5_9
    let divisor1_of_q_p4_q_p5_10 = (-divisor1_of_q_p5).mul_add(S::int(3), cos_q_p5_sq)
        - divisor1_of_q_p4_q_p5_4 + divisor1_of_q_p4_q_p5_9;
    // divisor1_of_q_p4_q_p5_9 - divisor1_of_q_p5
    let divisor1_of_q_p4_q_p5_11 = divisor1_of_q_p4_q_p5_9 - divisor1_of_q_p5;
    // sin(q_P2)*(divisor1_of_q_p4_q_p5_7*sin(q_P3) - cos_q_p3_cos_q_p5*divisor1_of_q_p4_q_p5_8)
    let divisor1_of_place_30 = sin_q_P2
        * (-cos_q_p3_cos_q_p5)
            .mul_add(divisor1_of_q_p4_q_p5_8, divisor1_of_q_p4_q_p5_7 * sin_q_P3);
    // (divisor1_of_place_2*sin(q_P1) -
    //   divisor1_of_place*cos(q_P1)*sin(q_P2))*(l^2*divisor1_of_place_4*(divisor1_of_place_9*cos(q_P5)*(divisor1_of_place_5
    //   - sin(q_P1)*(sin_q_p2_cos_q_p4*sin(q_P3) + cos_q_p2_sin_q_p4)) +
    //   divisor1_of_place_12*(minus_divisor1_of_q_p5*divisor1_of_place_5 - divisor1_of_place_11*sin(q_P1)))
    //   - divisor1_of_place_13*divisor1_of_place_18 - divisor1_of_place_19*divisor1_of_place_21) +
    //   (divisor1_of_place_11*cos(q_P1) +
    //   divisor1_of_q_p3_q_p5_2*sin(q_P1)*cos(q_P4))*(divisor1_of_place_19*divisor1_of_place_24 -
    //   divisor1_of_place_18*divisor1_of_place_22 +
    //   divisor1_of_place_4_l_sq*(sin_q_p3_cos_q_p1*cos(q_P1)*(divisor1_of_place_27 + divisor1_of_place_28)
    //   + sin(q_P1)*(sin_q_p3_cos_q_p1*divisor1_of_place_26 +
    //   sin(q_P2)*(cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(cos_q_p3_cos_q_p5*divisor1_of_q_p4 -
    //   divisor1_of_place_25) + divisor1_of_place_26) + cos(q_P1)*(divisor1_of_place_27 +
    //   2*divisor1_of_place_28)) - sin_q_p3_cos_q_p1*divisor1_of_place_25))))
    let divisor1_of_place_31 = (-(divisor1_of_place * cos_q_P1))
        .mul_add(sin_q_P2, divisor1_of_place_2 * sin_q_P1)
        * (l * l * divisor1_of_place_4
            * (divisor1_of_place_9 * cos_q_P5
                * (divisor1_of_place_5
                    - sin_q_P1 * sin_q_p2_cos_q_p4.mul_add(sin_q_P3, cos_q_p2_sin_q_p4))
                + divisor1_of_place_12
                    * (-divisor1_of_place_11)
                        .mul_add(sin_q_P1, minus_divisor1_of_q_p5 * divisor1_of_place_5))
            - divisor1_of_place_13 * divisor1_of_place_18
            - divisor1_of_place_19 * divisor1_of_place_21)
        + (divisor1_of_q_p3_q_p5_2 * sin_q_P1)
            .mul_add(cos_q_P4, divisor1_of_place_11 * cos_q_P1)
            * (divisor1_of_place_19 * divisor1_of_place_24
                - divisor1_of_place_18 * divisor1_of_place_22
                + divisor1_of_place_4_l_sq
                    * (sin_q_p3_cos_q_p1 * cos_q_P1 * (divisor1_of_place_27 + divisor1_of_place_28)
                        + sin_q_P1
                            * (sin_q_P2
                                * (cos_q_P3
                                    * (sin_q_P1
                                        * (sin_q_P2
                                            * cos_q_p3_cos_q_p5
                                                .mul_add(divisor1_of_q_p4, -divisor1_of_place_25)
                                            + divisor1_of_place_26)
                                        + cos_q_P1
                                            * divisor1_of_place_28
                                                .mul_add(S::int(2), divisor1_of_place_27))
                                    - sin_q_p3_cos_q_p1 * divisor1_of_place_25)
                                + sin_q_p3_cos_q_p1 * divisor1_of_place_26)));
    // (divisor1_of_place_6*sin(q_P1) -
    //   divisor1_of_place_8*cos(q_P1))*(l_sq*(divisor1_of_place_21*divisor1_of_place_22 +
    //   divisor1_of_place_13*divisor1_of_place_24) +
    //   divisor1_of_place_4_l_sq*(sin(q_P1)*(sin(q_P2)*(cos_q_p3_cos_q_p5*(cos_q_p2_sin_q_p4*sin(q_P1) -
    //   divisor1_of_place_5) + sin(q_P3)*(divisor1_of_place_20 + cos(q_P4)*(cos(q_P1)*(sin_q_p3_cos_q_p5 -
    //   2*divisor1_of_q_p3_q_p5_2) + sin_q_p2_sin_q_p1*divisor1_of_q_p3_q_p5_3))) +
    //   cos_q_p2_sin_q_p4*divisor1_of_place_23) - divisor1_of_place_5*divisor1_of_place_23)) +
    //   divisor1_of_place_15*l_sq*cos(q_P1)*(cos(q_P4)*cos(q_P5)*(divisor1_of_place_10*sin(q_P3) +
    //   divisor1_of_place_14) + cos(q_P1)*(sin(q_P1)*(divisor1_of_q_p4_q_p5_7 - 2*divisor1_of_place_29 +
    //   cos(q_P2)*(cos(q_P2)*(divisor1_of_q_p5 + minus_divisor1_of_q_p5*cos_q_p4_sq_doubled +
    //   sin(q_P4)*(divisor1_of_q_p5 + divisor1_of_q_p4_q_p5_4) + divisor1_of_place_29) -
    //   sin_q_p2_cos_q_p4*(divisor1_of_q_p4_q_p5_10*sin(q_P3) +
    //   cos_q_p3_cos_q_p5*divisor1_of_q_p4_q_p5_11))) -
    //   cos(q_P1)*(cos(q_P5)*(divisor1_of_q_p4_q_p5_8*sin(q_P2) +
    //   cos_q_p2_cos_q_p4*divisor1_of_q_p4_q_p5_11*sin(q_P3)) + cos(q_P3)*(2*divisor1_of_place_30 -
    //   cos_q_p2_cos_q_p4*divisor1_of_q_p4_q_p5_10))) + cos(q_P3)*(cos_q_p2_cos_q_p4*(divisor1_of_q_p5_2 -
    //   divisor1_of_q_p4_q_p5 + divisor1_of_q_p4_q_p5_5) + divisor1_of_place_30))
    let divisor1_of_place_32 = (-divisor1_of_place_8)
        .mul_add(cos_q_P1, divisor1_of_place_6 * sin_q_P1)
        * (l_sq
            * divisor1_of_place_13
                .mul_add(
                    divisor1_of_place_24,
                    divisor1_of_place_21 * divisor1_of_place_22,
                )
            + divisor1_of_place_4_l_sq
                * (sin_q_P1
                    * (sin_q_P2
                        * (cos_q_p3_cos_q_p5
                            * cos_q_p2_sin_q_p4.mul_add(sin_q_P1, -divisor1_of_place_5)
                            + sin_q_P3
                                * (divisor1_of_place_20
                                    + cos_q_P4
                                        * (cos_q_P1
                                            * (-divisor1_of_q_p3_q_p5_2)
                                                .mul_add(S::int(2), sin_q_p3_cos_q_p5)
                                            + sin_q_p2_sin_q_p1 * divisor1_of_q_p3_q_p5_3)))
                        + cos_q_p2_sin_q_p4 * divisor1_of_place_23)
                    - divisor1_of_place_5 * divisor1_of_place_23))
        + divisor1_of_place_15 * l_sq * cos_q_P1
            * (cos_q_P4 * cos_q_P5 * divisor1_of_place_10.mul_add(sin_q_P3, divisor1_of_place_14)
                + cos_q_P1
                    * (sin_q_P1
                        * (divisor1_of_q_p4_q_p5_7 - S::int(2) * divisor1_of_place_29
                            + cos_q_P2
                                * (cos_q_P2
                                    * (divisor1_of_q_p5
                                        + minus_divisor1_of_q_p5 * cos_q_p4_sq_doubled
                                        + sin_q_P4 * (divisor1_of_q_p5 + divisor1_of_q_p4_q_p5_4)
                                        + divisor1_of_place_29)
                                    - sin_q_p2_cos_q_p4
                                        * cos_q_p3_cos_q_p5
                                            .mul_add(
                                                divisor1_of_q_p4_q_p5_11,
                                                divisor1_of_q_p4_q_p5_10 * sin_q_P3,
                                            )))
                        - cos_q_P1
                            * (cos_q_P5
                                * (cos_q_p2_cos_q_p4 * divisor1_of_q_p4_q_p5_11)
                                    .mul_add(sin_q_P3, divisor1_of_q_p4_q_p5_8 * sin_q_P2)
                                + cos_q_P3
                                    * (-cos_q_p2_cos_q_p4)
                                        .mul_add(
                                            divisor1_of_q_p4_q_p5_10,
                                            S::int(2) * divisor1_of_place_30,
                                        )))
                + cos_q_P3
                    * (cos_q_p2_cos_q_p4
                        * (divisor1_of_q_p5_2 - divisor1_of_q_p4_q_p5
                            + divisor1_of_q_p4_q_p5_5) + divisor1_of_place_30));
    // Values.
    // divisor1 = l^3*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(cos(q_P4)*cos(q_P5)*(cos(q_P2)*sin(q_P3)*sin(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P5) - 1)) + cos(q_P1)*(sin(q_P1)*(sin(q_P5) - 1 + cos(q_P5)^2 +
    //   cos(q_P4)^2*(1 - sin(q_P5)) + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5)
    //   - cos(q_P5)^2)) - 2*cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5))
    //   + sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) -
    //   cos(q_P2)*(cos(q_P2)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(1 - sin(q_P5)) -
    //   cos(q_P3)*(cos(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P3)*cos(q_P5)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   sin(q_P4)*(sin(q_P5) - 1 + 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3)*(3*sin(q_P5) - 3 + cos(q_P5)^2 + 2*sin(q_P4)*(sin(q_P5) - 1) +
    //   2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) + cos(q_P3)*cos(q_P5)*(sin(q_P5) - 1 +
    //   2*sin(q_P4)*(sin(q_P5) - 1))))) - cos(q_P1)*(cos(q_P3)*(cos(q_P2)*cos(q_P4)*(3 - 3*sin(q_P5) -
    //   cos(q_P5)^2 - 2*sin(q_P4)*(sin(q_P5) - 1) - 2*cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2)) +
    //   2*sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))))) +
    //   cos(q_P5)*(sin(q_P2)*(1 + sin(q_P4) - 2*cos(q_P4)^2 + sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4))) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1 + 2*sin(q_P4)*(sin(q_P5) - 1))))) +
    //   cos(q_P3)*(sin(q_P2)*(sin(q_P3)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(1 - sin(q_P5)) +
    //   sin(q_P4)*(sin(q_P5) - 1 + cos(q_P5)^2 + cos(q_P4)^2*(2 - 2*sin(q_P5) - cos(q_P5)^2))) +
    //   cos(q_P3)*cos(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4) - sin(q_P5)*(2*cos(q_P4)^2 - 1 - sin(q_P4)))) +
    //   cos(q_P2)*cos(q_P4)*(2 - 2*sin(q_P5) - cos(q_P5)^2 - sin(q_P4)*(sin(q_P5) - 1) - cos(q_P4)^2*(2 -
    //   2*sin(q_P5) - cos(q_P5)^2)))) - l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(l*cos(q_P5)*(sin(q_P1)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*sin(q_P3)*cos(q_P4)) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))) + l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) + sin(q_P1)*(cos(q_P2)*cos(q_P4) -
    //   sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) + sin(q_P1)*sin(q_P2)*cos(q_P3))))
    //   + l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*cos(q_P2)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) -
    //   sin(q_P3)*(cos(q_P2)*sin(q_P4) + sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) +
    //   cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1)))))) + l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P1)*sin(q_P3)^2*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) + cos(q_P3)*(sin(q_P1)*(sin(q_P2)*(sin(q_P3)*(cos(q_P4)^2 +
    //   sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2)) - cos(q_P3)*cos(q_P5)*(1 + sin(q_P4))) -
    //   cos(q_P2)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) - cos(q_P1)*(2*sin(q_P3)*cos(q_P5)*(1 +
    //   sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 + sin(q_P4) - cos(q_P4)^2))))) -
    //   cos(q_P1)*cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) + sin(q_P4)*(sin(q_P5) - 1))) -
    //   cos(q_P1)^2*sin(q_P3)*(sin(q_P3)*cos(q_P5)*(1 + sin(q_P4)) + cos(q_P3)*(cos(q_P4)^2 + sin(q_P5)*(1 +
    //   sin(q_P4) - cos(q_P4)^2)))) + l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) -
    //   1) - 1))*(l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))*(sin(q_P5)*(cos(q_P1)*cos(q_P3)*sin(q_P4) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4) - sin(q_P2)*sin(q_P3)*sin(q_P4))) + cos(q_P5)*(cos(q_P1)*sin(q_P3) +
    //   sin(q_P1)*sin(q_P2)*cos(q_P3))) - l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))) + l^2*sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) +
    //   cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))*(cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)) - sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) +
    //   sin(q_P4)*(1 - sin(q_P5) - cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) +
    //   sin(q_P3)*(sin(q_P5) - 1))) - cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 -
    //   sin(q_P5)))))) + l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5)))*(l^2*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) -
    //   1))))*(sin(q_P1)*(sin(q_P2)*(cos(q_P3)*cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) -
    //   cos(q_P1)*cos(q_P3)*cos(q_P4)) + sin(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1)) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + 2*cos(q_P3)*(1 - sin(q_P5)))))) +
    //   cos(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)^2*cos(q_P3)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) +
    //   l^2*sin(q_P1)*cos(q_P2)^2*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) -
    //   1))*(sin(q_P1)*cos(q_P5)*(cos(q_P2)*sin(q_P4) - sin(q_P3)*(cos(q_P2)*sin(q_P4) +
    //   sin(q_P2)*cos(q_P4)*(sin(q_P3) - 1))) + cos(q_P3)*(sin(q_P1)*cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P4)*(sin(q_P1)*sin(q_P2)*sin(q_P3)*(sin(q_P5) - 1) - cos(q_P1)*(cos(q_P5)*(1 - sin(q_P3)) +
    //   cos(q_P3)*(sin(q_P5) - 1))))) + l^2*sin(q_P1)*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) +
    //   cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) -
    //   1))*(sin(q_P2)*(sin(q_P1)*(cos(q_P2)*(sin(q_P5)*(sin(q_P3) - 1) + sin(q_P4)*(1 - sin(q_P5) -
    //   cos(q_P3)*cos(q_P5))) - sin(q_P2)*cos(q_P4)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(sin(q_P5) - 1))) -
    //   cos(q_P1)*cos(q_P4)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(1 - sin(q_P5)))) -
    //   cos(q_P1)*cos(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5))))
    let divisor1 = l * (divisor1_of_place_32 - divisor1_of_place_31);
    [divisor1]
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 42 operations, 5 sines and cosines.
#[must_use]
pub fn constraints<S: Scalar>(p: &Parameters<S>, q: &[S; 5], _u: &[S; 1]) -> [S; 4] {
    let Parameters { l, .. } = *p;
    let [q_P1, q_P2, q_P3, q_P4, q_P5] = *q;
    // Sines and cosines.
    let (sin_q_P5, cos_q_P5) = q_P5.sin_cos();
    let (sin_q_P4, cos_q_P4) = q_P4.sin_cos();
    let (sin_q_P3, cos_q_P3) = q_P3.sin_cos();
    let (sin_q_P2, cos_q_P2) = q_P2.sin_cos();
    let (sin_q_P1, cos_q_P1) = q_P1.sin_cos();
    // Shared terms.
    // sin(q_P5) - 1
    let residual1_of_q_p5 = sin_q_P5 - S::int(1);
    // residual1_of_q_p5*sin(q_P4) - 1
    let residual1_of_q_p4_q_p5 = residual1_of_q_p5.mul_add(sin_q_P4, -S::int(1));
    let cos_q_p3_cos_q_p5 = cos_q_P3 * cos_q_P5;
    // cos_q_p3_cos_q_p5 - 1 - residual1_of_q_p4_q_p5*sin(q_P3)
    let residual1_of_place = (-residual1_of_q_p4_q_p5)
        .mul_add(sin_q_P3, cos_q_p3_cos_q_p5 - S::int(1));
    let residual1_of_q_p4_q_p5_2 = residual1_of_q_p5 * cos_q_P4;
    // 1 + residual1_of_place*sin(q_P2) + residual1_of_q_p4_q_p5_2*cos(q_P2)
    let residual1_of_place_2 = residual1_of_place.mul_add(sin_q_P2, S::int(1))
        + residual1_of_q_p4_q_p5_2 * cos_q_P2;
    let sin_q_p3_cos_q_p5 = sin_q_P3 * cos_q_P5;
    // residual1_of_q_p4_q_p5*cos(q_P3) + sin_q_p3_cos_q_p5
    let residual1_of_place_3 = residual1_of_q_p4_q_p5
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p5);
    // Values.
    // P6_1 = l*(cos(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))) - sin(q_P1)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)))
    let residual1 = l * (-residual1_of_place_3).mul_add(sin_q_P1, residual1_of_place_2 * cos_q_P1);
    // P6_2 = -l*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))
    let residual2 = l
        * (-residual1_of_place).mul_add(cos_q_P2, residual1_of_q_p4_q_p5_2 * sin_q_P2);
    // P6_3 = -l*(1 + sin(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) -
    //   1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))) + cos(q_P1)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)))
    let residual3 = -l
        * (residual1_of_place_2.mul_add(sin_q_P1, S::int(1)) + residual1_of_place_3 * cos_q_P1);
    // P6_turn13 = cos(q_P1)*(sin(q_P3)*sin(q_P5) - cos(q_P3)*sin(q_P4)*cos(q_P5)) +
    //   sin(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5))
    let residual4 = cos_q_P1 * (-cos_q_p3_cos_q_p5).mul_add(sin_q_P4, sin_q_P3 * sin_q_P5)
        + sin_q_P1
            * (sin_q_P2 * sin_q_p3_cos_q_p5.mul_add(sin_q_P4, cos_q_P3 * sin_q_P5)
                - cos_q_P2 * cos_q_P4 * cos_q_P5);
    [residual1, residual2, residual3, residual4]
}

/// Slopes of the constraints, one after the other, along q_P1, q_P2, q_P3, q_P4, q_P5, u_P1.
///
/// 110 operations, 5 sines and cosines.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 1],
) -> [S; 24] {
    let Parameters { l, .. } = *p;
    let [q_P1, q_P2, q_P3, q_P4, q_P5] = *q;
    // Sines and cosines.
    let (sin_q_P5, cos_q_P5) = q_P5.sin_cos();
    let (sin_q_P4, cos_q_P4) = q_P4.sin_cos();
    let (sin_q_P3, cos_q_P3) = q_P3.sin_cos();
    let (sin_q_P2, cos_q_P2) = q_P2.sin_cos();
    let (sin_q_P1, cos_q_P1) = q_P1.sin_cos();
    // Shared terms.
    // sin(q_P5) - 1
    let residual1_by_q_P1_of_q_p5 = sin_q_P5 - S::int(1);
    let residual1_by_q_P1_of_q_p4_q_p5 = residual1_by_q_P1_of_q_p5 * sin_q_P4;
    // residual1_by_q_P1_of_q_p4_q_p5 - 1
    let residual1_by_q_P1_of_q_p4_q_p5_2 = residual1_by_q_P1_of_q_p4_q_p5 - S::int(1);
    let cos_q_p3_cos_q_p5 = cos_q_P3 * cos_q_P5;
    // residual1_by_q_P1_of_q_p4_q_p5_2*sin(q_P3) - cos_q_p3_cos_q_p5
    let residual1_by_q_P1_of_place = residual1_by_q_P1_of_q_p4_q_p5_2
        .mul_add(sin_q_P3, -cos_q_p3_cos_q_p5);
    // -1 - residual1_by_q_P1_of_place
    let residual1_by_q_P1_of_place_2 = -S::int(1) - residual1_by_q_P1_of_place;
    let residual1_by_q_P1_of_q_p4_q_p5_3 = residual1_by_q_P1_of_q_p5 * cos_q_P4;
    let residual1_by_q_P1_of_place_3 = residual1_by_q_P1_of_q_p4_q_p5_3 * cos_q_P2;
    // residual1_by_q_P1_of_place_2*sin(q_P2) + residual1_by_q_P1_of_place_3
    let residual1_by_q_P1_of_place_4 = residual1_by_q_P1_of_place_2
        .mul_add(sin_q_P2, residual1_by_q_P1_of_place_3);
    // 1 + residual1_by_q_P1_of_place_4
    let residual1_by_q_P1_of_place_5 = S::int(1) + residual1_by_q_P1_of_place_4;
    let sin_q_p3_cos_q_p5 = sin_q_P3 * cos_q_P5;
    // residual1_by_q_P1_of_q_p4_q_p5_2*cos(q_P3) + sin_q_p3_cos_q_p5
    let residual1_by_q_P1_of_place_6 = residual1_by_q_P1_of_q_p4_q_p5_2
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p5);
    let residual1_by_q_P1_of_place_7 = residual1_by_q_P1_of_place_6 * cos_q_P1;
    let residual1_by_q_P2_of_place = residual1_by_q_P1_of_q_p4_q_p5_3 * sin_q_P2;
    // l*(residual1_by_q_P1_of_place_2*cos(q_P2) - residual1_by_q_P2_of_place)
    let residual1_by_q_P2_of_place_2 = l
        * residual1_by_q_P1_of_place_2.mul_add(cos_q_P2, -residual1_by_q_P2_of_place);
    // -residual1_by_q_P1_of_place
    let residual1_by_q_P3_of_place = -residual1_by_q_P1_of_place;
    // residual1_by_q_P1_of_q_p4_q_p5*cos(q_P2) + residual1_by_q_P2_of_place*sin(q_P3)
    let residual1_by_q_P4_of_place = residual1_by_q_P2_of_place
        .mul_add(sin_q_P3, residual1_by_q_P1_of_q_p4_q_p5 * cos_q_P2);
    let sin_q_p3_sin_q_p5 = sin_q_P3 * sin_q_P5;
    // cos_q_p3_cos_q_p5*sin(q_P4) - sin_q_p3_sin_q_p5
    let residual1_by_q_P5_of_place = cos_q_p3_cos_q_p5
        .mul_add(sin_q_P4, -sin_q_p3_sin_q_p5);
    let cos_q_p3_sin_q_p5 = cos_q_P3 * sin_q_P5;
    // sin_q_p3_cos_q_p5*sin(q_P4) + cos_q_p3_sin_q_p5
    let residual1_by_q_P5_of_place_2 = sin_q_p3_cos_q_p5
        .mul_add(sin_q_P4, cos_q_p3_sin_q_p5);
    let cos_q_p2_cos_q_p4 = cos_q_P2 * cos_q_P4;
    // cos_q_p2_cos_q_p4*cos(q_P5) - residual1_by_q_P5_of_place_2*sin(q_P2)
    let residual1_by_q_P5_of_place_3 = (-residual1_by_q_P5_of_place_2)
        .mul_add(sin_q_P2, cos_q_p2_cos_q_p4 * cos_q_P5);
    // residual1_by_q_P5_of_place*sin(q_P1) - residual1_by_q_P5_of_place_3*cos(q_P1)
    let residual1_by_q_P5_of_place_4 = (-residual1_by_q_P5_of_place_3)
        .mul_add(cos_q_P1, residual1_by_q_P5_of_place * sin_q_P1);
    // sin(q_P2)*cos(q_P4)*cos(q_P5) + residual1_by_q_P5_of_place_2*cos(q_P2)
    let residual2_by_q_P5_of_place = residual1_by_q_P5_of_place_2
        .mul_add(cos_q_P2, sin_q_P2 * cos_q_P4 * cos_q_P5);
    let sin_q_p2_sin_q_p1 = sin_q_P1 * sin_q_P2;
    let cos_q_p3_cos_q_p1 = cos_q_P1 * cos_q_P3;
    // Values.
    // d(P6_1)/d(q_P1) = -l*(sin(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))) +
    //   cos(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)))
    let residual1_by_q_P1 = -l
        * residual1_by_q_P1_of_place_5.mul_add(sin_q_P1, residual1_by_q_P1_of_place_7);
    // d(P6_1)/d(q_P2) = l*cos(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5)
    //   - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))
    let residual1_by_q_P2 = residual1_by_q_P2_of_place_2 * cos_q_P1;
    // d(P6_1)/d(q_P3) = -l*(cos(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) -
    //   1) - 1)) + sin(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))
    let residual1_by_q_P3 = -l
        * residual1_by_q_P3_of_place
            .mul_add(sin_q_P1, residual1_by_q_P1_of_place_7 * sin_q_P2);
    // d(P6_1)/d(q_P4) = -l*(sin(q_P1)*cos(q_P3)*cos(q_P4)*(sin(q_P5) - 1) +
    //   cos(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))
    let residual1_by_q_P4 = -l
        * residual1_by_q_P4_of_place
            .mul_add(cos_q_P1, residual1_by_q_P1_of_q_p4_q_p5_3 * sin_q_P1 * cos_q_P3);
    // d(P6_1)/d(q_P5) = -l*(sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5)))
    let residual1_by_q_P5 = -l * residual1_by_q_P5_of_place_4;
    // d(P6_2)/d(q_P2) = l*(cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))
    let residual2_by_q_P2 = l * residual1_by_q_P1_of_place_4;
    // d(P6_2)/d(q_P3) = l*cos(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1))
    let residual2_by_q_P3 = l * residual1_by_q_P1_of_place_6 * cos_q_P2;
    // d(P6_2)/d(q_P4) = l*(sin(q_P2)*sin(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5)
    //   - 1))
    let residual2_by_q_P4 = l
        * (-residual1_by_q_P1_of_q_p4_q_p5)
            .mul_add(sin_q_P2, residual1_by_q_P1_of_place_3 * sin_q_P3);
    // d(P6_2)/d(q_P5) = l*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))
    let residual2_by_q_P5 = l * residual2_by_q_P5_of_place;
    // d(P6_3)/d(q_P1) = l*(sin(q_P1)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) -
    //   cos(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))))
    let residual3_by_q_P1 = l
        * (-residual1_by_q_P1_of_place_5)
            .mul_add(cos_q_P1, residual1_by_q_P1_of_place_6 * sin_q_P1);
    // d(P6_3)/d(q_P2) = -l*sin(q_P1)*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5)
    //   - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))
    let residual3_by_q_P2 = -residual1_by_q_P2_of_place_2 * sin_q_P1;
    // d(P6_3)/d(q_P3) = l*(sin(q_P1)*sin(q_P2)*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1)
    //   - 1)) - cos(q_P1)*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))))
    let residual3_by_q_P3 = l
        * (-residual1_by_q_P3_of_place)
            .mul_add(cos_q_P1, residual1_by_q_P1_of_place_6 * sin_q_p2_sin_q_p1);
    // d(P6_3)/d(q_P4) = l*(cos(q_P1)*cos(q_P3)*cos(q_P4)*(1 - sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*sin(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*sin(q_P3)*cos(q_P4)*(sin(q_P5) - 1)))
    let residual3_by_q_P4 = l
        * (-residual1_by_q_P1_of_q_p4_q_p5_3)
            .mul_add(cos_q_p3_cos_q_p1, residual1_by_q_P4_of_place * sin_q_P1);
    // d(P6_3)/d(q_P5) = -l*(cos(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*cos(q_P5) - sin(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))))
    let residual3_by_q_P5 = -l
        * residual1_by_q_P5_of_place_3
            .mul_add(sin_q_P1, residual1_by_q_P5_of_place * cos_q_P1);
    // d(P6_turn13)/d(q_P1) = sin(q_P1)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5)) +
    //   cos(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5))
    let residual4_by_q_P1 = residual1_by_q_P5_of_place_4;
    // d(P6_turn13)/d(q_P2) = sin(q_P1)*(sin(q_P2)*cos(q_P4)*cos(q_P5) + cos(q_P2)*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5)))
    let residual4_by_q_P2 = residual2_by_q_P5_of_place * sin_q_P1;
    // d(P6_turn13)/d(q_P3) = cos(q_P1)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) +
    //   sin(q_P1)*sin(q_P2)*(cos(q_P3)*sin(q_P4)*cos(q_P5) - sin(q_P3)*sin(q_P5))
    let residual4_by_q_P3 = residual1_by_q_P5_of_place
        .mul_add(sin_q_p2_sin_q_p1, residual1_by_q_P5_of_place_2 * cos_q_P1);
    // d(P6_turn13)/d(q_P4) = cos(q_P5)*(sin(q_P1)*cos(q_P2)*sin(q_P4) - cos(q_P4)*(cos(q_P1)*cos(q_P3) -
    //   sin(q_P1)*sin(q_P2)*sin(q_P3)))
    let residual4_by_q_P4 = cos_q_P5
        * (cos_q_P4 * sin_q_p2_sin_q_p1.mul_add(sin_q_P3, -cos_q_p3_cos_q_p1)
            + sin_q_P1 * cos_q_P2 * sin_q_P4);
    // d(P6_turn13)/d(q_P5) = cos(q_P1)*(cos(q_P3)*sin(q_P4)*sin(q_P5) + sin(q_P3)*cos(q_P5)) +
    //   sin(q_P1)*(cos(q_P2)*cos(q_P4)*sin(q_P5) + sin(q_P2)*(cos(q_P3)*cos(q_P5) -
    //   sin(q_P3)*sin(q_P4)*sin(q_P5)))
    let residual4_by_q_P5 = cos_q_P1 * cos_q_p3_sin_q_p5.mul_add(sin_q_P4, sin_q_p3_cos_q_p5)
        + sin_q_P1
            * (sin_q_P2 * (-sin_q_p3_sin_q_p5).mul_add(sin_q_P4, cos_q_p3_cos_q_p5)
                + cos_q_p2_cos_q_p4 * sin_q_P5);
    let zero = S::int(0);
    [
        residual1_by_q_P1, residual1_by_q_P2, residual1_by_q_P3, residual1_by_q_P4,
        residual1_by_q_P5, zero, zero, residual2_by_q_P2, residual2_by_q_P3, residual2_by_q_P4,
        residual2_by_q_P5, zero, residual3_by_q_P1, residual3_by_q_P2, residual3_by_q_P3,
        residual3_by_q_P4, residual3_by_q_P5, zero, residual4_by_q_P1, residual4_by_q_P2,
        residual4_by_q_P3, residual4_by_q_P4, residual4_by_q_P5, zero,
    ]
}

/// Inverse dynamics: the generalized forces along (u_P1) that must act beside the loads of the model for the accelerations to be (u_P1').
///
/// 1552 operations, 5 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 1],
    v_dot: &[S; 1],
) -> [S; 1] {
    let Parameters { l, m, g } = *p;
    let [q_P1, q_P2, q_P3, q_P4, q_P5] = *q;
    let [u_P1] = *u;
    let [u_P1_dot] = *v_dot;
    // Sines and cosines.
    let (sin_q_P5, cos_q_P5) = q_P5.sin_cos();
    let (sin_q_P4, cos_q_P4) = q_P4.sin_cos();
    let (sin_q_P2, cos_q_P2) = q_P2.sin_cos();
    let (sin_q_P3, cos_q_P3) = q_P3.sin_cos();
    let (sin_q_P1, cos_q_P1) = q_P1.sin_cos();
    // Step by step, each after the terms that it needs.
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
    let cos_q_p3_sin_q_p1 = sin_q_P1 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_25 = cos_q_p3_sin_q_p1 * cos_q_P4;
    let ratio_q_P2_u_P1_of_place_26 = l
        * ratio_q_P2_u_P1_of_q_p5_2
            .mul_add(
                ratio_q_P2_u_P1_of_place_25,
                ratio_q_P2_u_P1_of_place_24 * cos_q_P1,
            );
    let ratio_q_P2_u_P1_of_place_27 = l * ratio_q_P2_u_P1_of_place_12;
    let ratio_q_P2_u_P1_of_place_28 = l * ratio_q_P2_u_P1_of_place;
    let ratio_q_P2_u_P1_of_place_29 = ratio_q_P2_u_P1_of_place_20
        .mul_add(
            ratio_q_P2_u_P1_of_place_28,
            ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_of_place_27,
        );
    let ratio_q_P2_u_P1_of_place_30 = (-ratio_q_P2_u_P1_of_place_6)
        .mul_add(sin_q_P2, cos_q_p2_cos_q_p4 * cos_q_P5);
    let ratio_q_P2_u_P1_of_place_31 = l
        * (-ratio_q_P2_u_P1_of_place_30)
            .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_19 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_32 = (-ratio_q_P2_u_P1_of_place_22)
        .mul_add(
            ratio_q_P2_u_P1_of_place_26,
            ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_of_place_18,
        ) - ratio_q_P2_u_P1_of_place_29 * ratio_q_P2_u_P1_of_place_31;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_2 = S::int(1) - cos_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_33 = -ratio_q_P2_u_P1_of_place_14 - ratio_q_P2_u_P1_of_q_p3_q_p5_2;
    let ratio_q_P2_u_P1_of_place_34 = ratio_q_P2_u_P1_of_place_33
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p2_cos_q_p4);
    let ratio_q_P2_u_P1_of_place_35 = S::int(1) + ratio_q_P2_u_P1_of_place_34;
    let ratio_q_P2_u_P1_of_place_36 = (-ratio_q_P2_u_P1_of_place_16)
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_35 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_37 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_of_place_10, ratio_q_P2_u_P1_of_place_24 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_38 = ratio_q_P2_u_P1_of_place_30
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_19 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_39 = (-ratio_q_P2_u_P1_of_place_27)
        .mul_add(
            ratio_q_P2_u_P1_of_place_38,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_37,
        );
    let ratio_q_P2_u_P1_of_place_40 = l * ratio_q_P2_u_P1_of_place_34;
    let ratio_q_P2_u_P1_of_place_41 = ratio_q_P2_u_P1_of_q_p5_2 * sin_q_p2_cos_q_p4;
    let ratio_q_P2_u_P1_of_place_42 = ratio_q_P2_u_P1_of_place_33
        .mul_add(cos_q_P2, -ratio_q_P2_u_P1_of_place_41);
    let ratio_q_P2_u_P1_of_place_43 = ratio_q_P2_u_P1_of_place_8 * sin_q_P1;
    let ratio_q_P2_u_P1_of_place_44 = (-ratio_q_P2_u_P1_of_place_38)
        .mul_add(
            ratio_q_P2_u_P1_of_place_43,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_42 * sin_q_P1,
        );
    let cos_q_p2_sin_q_p1 = sin_q_P1 * cos_q_P2;
    let ratio_q_P2_u_P1_of_q_p3 = sin_q_P3 - S::int(1);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_3 = ratio_q_P2_u_P1_of_q_p5_2 * cos_q_P3;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_4 = (-ratio_q_P2_u_P1_of_q_p3)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_q_p3_q_p5_3);
    let ratio_q_P2_u_P1_of_place_45 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_q_p3_q_p5 * sin_q_p2_sin_q_p1);
    let ratio_q_P2_u_P1_of_place_46 = ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_p2_sin_q_p1;
    let ratio_q_P2_u_P1_of_place_47 = ratio_q_P2_u_P1_of_place_45
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_46);
    let ratio_q_P2_u_P1_of_place_48 = sin_q_p2_cos_q_p4
        .mul_add(ratio_q_P2_u_P1_of_q_p3, cos_q_p2_sin_q_p4);
    let ratio_q_P2_u_P1_of_place_49 = (-ratio_q_P2_u_P1_of_place_48)
        .mul_add(sin_q_P3, cos_q_p2_sin_q_p4);
    let cos_q_p5_sin_q_p1 = sin_q_P1 * cos_q_P5;
    let l_sq = l * l;
    let ratio_q_P2_u_P1_of_place_50 = l_sq
        * ratio_q_P2_u_P1_of_place_49
            .mul_add(cos_q_p5_sin_q_p1, ratio_q_P2_u_P1_of_place_47 * cos_q_P3);
    let ratio_q_P2_u_P1_of_place_51 = cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_of_place_50;
    let ratio_q_P2_u_P1_of_place_52 = ratio_q_P2_u_P1_of_place_28
        .mul_add(
            ratio_q_P2_u_P1_of_place_44,
            ratio_q_P2_u_P1_of_place_39 * ratio_q_P2_u_P1_of_place_40,
        ) + ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_51;
    let ratio_q_P2_u_P1_of_q_p4 = S::int(1) + sin_q_P4;
    let cos_q_p4_sq = cos_q_P4 * cos_q_P4;
    let ratio_q_P2_u_P1_of_q_p4_2 = ratio_q_P2_u_P1_of_q_p4 - cos_q_p4_sq;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_3 = ratio_q_P2_u_P1_of_q_p4_2
        .mul_add(sin_q_P5, cos_q_p4_sq);
    let ratio_q_P2_u_P1_of_place_53 = ratio_q_P2_u_P1_of_q_p4_q_p5_3 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_54 = (-cos_q_p3_cos_q_p5)
        .mul_add(ratio_q_P2_u_P1_of_q_p4, ratio_q_P2_u_P1_of_place_53);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_4 = sin_q_P5 + ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_place_55 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p4_q_p5_4;
    let ratio_q_P2_u_P1_of_place_56 = ratio_q_P2_u_P1_of_place_54
        .mul_add(sin_q_P2, -ratio_q_P2_u_P1_of_place_55);
    let ratio_q_P2_u_P1_of_place_57 = ratio_q_P2_u_P1_of_q_p4_q_p5_3 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_58 = sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_of_q_p4;
    let ratio_q_P2_u_P1_of_place_59 = ratio_q_P2_u_P1_of_place_58
        .mul_add(S::int(2), ratio_q_P2_u_P1_of_place_57);
    let ratio_q_P2_u_P1_of_place_60 = (-ratio_q_P2_u_P1_of_place_59)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_56 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_61 = ratio_q_P2_u_P1_of_place_60
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_of_place_53);
    let ratio_q_P2_u_P1_of_place_62 = (-sin_q_p3_cos_q_p1)
        .mul_add(ratio_q_P2_u_P1_of_place_55, ratio_q_P2_u_P1_of_place_61 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_63 = ratio_q_P2_u_P1_of_place_57 + ratio_q_P2_u_P1_of_place_58;
    let ratio_q_P2_u_P1_of_place_64 = ratio_q_P2_u_P1_of_place_63 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_65 = (-sin_q_p3_cos_q_p1)
        .mul_add(ratio_q_P2_u_P1_of_place_64, ratio_q_P2_u_P1_of_place_62 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_66 = ratio_q_P2_u_P1_of_place_34 * l_sq;
    let ratio_q_P2_u_P1_of_place_67 = l * ratio_q_P2_u_P1_of_place_21;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_5 = cos_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_place_68 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_5)
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_q_p3 * sin_q_P5);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_6 = ratio_q_P2_u_P1_of_q_p3_q_p5 + cos_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_69 = (-sin_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_of_q_p3_q_p5_6, ratio_q_P2_u_P1_of_place_68 * cos_q_P2);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_7 = sin_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_3;
    let ratio_q_P2_u_P1_of_place_70 = ratio_q_P2_u_P1_of_q_p3_q_p5_7 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_71 = (-ratio_q_P2_u_P1_of_place_70)
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_69 * sin_q_P1);
    let cos_q_p2_cos_q_p1 = cos_q_P1 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_72 = (-ratio_q_P2_u_P1_of_place_6)
        .mul_add(cos_q_p2_cos_q_p1, ratio_q_P2_u_P1_of_place_71 * sin_q_P2);
    let ratio_q_P2_u_P1_of_place_73 = l_sq * ratio_q_P2_u_P1_of_place_72 * sin_q_P1;
    let ratio_q_P2_u_P1_of_place_74 = ratio_q_P2_u_P1_of_place_44
        .mul_add(
            ratio_q_P2_u_P1_of_place_67,
            ratio_q_P2_u_P1_of_place_65 * ratio_q_P2_u_P1_of_place_66,
        ) - ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_73;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_8 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_3)
        .mul_add(S::int(2), sin_q_p3_cos_q_p5);
    let ratio_q_P2_u_P1_of_place_75 = ratio_q_P2_u_P1_of_q_p3_q_p5_8
        .mul_add(cos_q_P1, sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_of_q_p3_q_p5_6);
    let ratio_q_P2_u_P1_of_place_76 = ratio_q_P2_u_P1_of_place_75
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_46);
    let ratio_q_P2_u_P1_of_place_77 = (-cos_q_p2_sin_q_p1)
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_place_10);
    let ratio_q_P2_u_P1_of_place_78 = (-cos_q_p3_cos_q_p5)
        .mul_add(ratio_q_P2_u_P1_of_place_77, ratio_q_P2_u_P1_of_place_76 * sin_q_P3);
    let ratio_q_P2_u_P1_of_place_79 = ratio_q_P2_u_P1_of_place_78
        .mul_add(sin_q_P2, cos_q_p2_sin_q_p4 * ratio_q_P2_u_P1_of_place_70);
    let ratio_q_P2_u_P1_of_place_80 = (-ratio_q_P2_u_P1_of_place_10)
        .mul_add(ratio_q_P2_u_P1_of_place_70, ratio_q_P2_u_P1_of_place_79 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_81 = ratio_q_P2_u_P1_of_place
        .mul_add(
            ratio_q_P2_u_P1_of_place_73,
            ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_of_place_51,
        ) + ratio_q_P2_u_P1_of_place_66 * ratio_q_P2_u_P1_of_place_80;
    let ratio_q_P2_u_P1_of_place_82 = l * ratio_q_P2_u_P1_of_place_42;
    let ratio_q_P2_u_P1_of_place_83 = ratio_q_P2_u_P1_of_place_82 * cos_q_P1;
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
    let ratio_q_P2_u_P1_of_place_84 = sin_q_p3_cos_q_p5
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_11,
            ratio_q_P2_u_P1_of_q_p4_q_p5_10 * cos_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_85 = ratio_q_P2_u_P1_of_place_84 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_86 = ratio_q_P2_u_P1_of_q_p4_q_p5_6
        .mul_add(sin_q_P4, -ratio_q_P2_u_P1_of_q_p5)
        - ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p4_sq_doubled - ratio_q_P2_u_P1_of_place_85;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_12 = S::int(2) * ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_13 = (-ratio_q_P2_u_P1_of_q_p5)
        .mul_add(S::int(3), cos_q_p5_sq) - ratio_q_P2_u_P1_of_q_p4_q_p5_5
        + ratio_q_P2_u_P1_of_q_p4_q_p5_12;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_14 = ratio_q_P2_u_P1_of_q_p4_q_p5_12 - ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_place_87 = cos_q_p3_cos_q_p5
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_14,
            ratio_q_P2_u_P1_of_q_p4_q_p5_13 * sin_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_88 = sin_q_p2_cos_q_p4
        .mul_add(ratio_q_P2_u_P1_of_place_87, ratio_q_P2_u_P1_of_place_86 * cos_q_P2);
    let ratio_q_P2_u_P1_of_place_89 = (-ratio_q_P2_u_P1_of_place_85)
        .mul_add(S::int(2), ratio_q_P2_u_P1_of_q_p4_q_p5_10)
        - ratio_q_P2_u_P1_of_place_88 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_90 = (-cos_q_p3_cos_q_p5)
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_11,
            ratio_q_P2_u_P1_of_q_p4_q_p5_10 * sin_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_91 = ratio_q_P2_u_P1_of_place_90 * sin_q_P2;
    let ratio_q_P2_u_P1_of_place_92 = (-cos_q_p2_cos_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_13,
            S::int(2) * ratio_q_P2_u_P1_of_place_91,
        );
    let ratio_q_P2_u_P1_of_place_93 = cos_q_p2_cos_q_p4 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_94 = ratio_q_P2_u_P1_of_q_p4_q_p5_14
        .mul_add(
            ratio_q_P2_u_P1_of_place_93,
            ratio_q_P2_u_P1_of_q_p4_q_p5_11 * sin_q_P2,
        );
    let ratio_q_P2_u_P1_of_place_95 = ratio_q_P2_u_P1_of_place_94
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_92 * cos_q_P3);
    let ratio_q_P2_u_P1_of_place_96 = (-ratio_q_P2_u_P1_of_place_95)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_89 * sin_q_P1);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_15 = ratio_q_P2_u_P1_of_q_p4_q_p5
        - ratio_q_P2_u_P1_of_q_p5_3 - ratio_q_P2_u_P1_of_q_p4_q_p5_7;
    let ratio_q_P2_u_P1_of_place_97 = (-cos_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_of_q_p4_q_p5_15, ratio_q_P2_u_P1_of_place_91);
    let ratio_q_P2_u_P1_of_place_98 = ratio_q_P2_u_P1_of_place_23
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_place_41);
    let cos_q_p4_cos_q_p5 = cos_q_P4 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_99 = ratio_q_P2_u_P1_of_place_97
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_of_place_96 * cos_q_P1)
        + ratio_q_P2_u_P1_of_place_98 * cos_q_p4_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_100 = l_sq * ratio_q_P2_u_P1_of_place_99;
    let ratio_q_P2_u_P1_of_place_101 = S::int(1)
        / ((-ratio_q_P2_u_P1_of_place_18)
            .mul_add(
                ratio_q_P2_u_P1_of_place_52,
                ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_of_place_74,
            ) + ratio_q_P2_u_P1_of_place_31 * ratio_q_P2_u_P1_of_place_81
            + ratio_q_P2_u_P1_of_place_83 * ratio_q_P2_u_P1_of_place_100);
    let ratio_q_P2_u_P1_of_place_102 = l * ratio_q_P2_u_P1_of_place_101;
    let ratio_q_P2_u_P1_of_place_103 = ratio_q_P2_u_P1_of_place_36 * ratio_q_P2_u_P1_of_place_102;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_16 = ratio_q_P2_u_P1_of_q_p4_q_p5 - ratio_q_P2_u_P1_of_q_p5;
    let sin_q_p3_sin_q_p1 = sin_q_P1 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_104 = (-cos_q_p3_cos_q_p1)
        .mul_add(sin_q_P2, sin_q_p3_sin_q_p1);
    let ratio_q_P2_u_P1_of_place_105 = cos_q_p3_sin_q_p1
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_place_3 * cos_q_P1);
    let ratio_q_P2_u_P1_of_place_106 = (-ratio_q_P2_u_P1_of_place_105)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_104 * sin_q_P5);
    let ratio_q_P2_u_P1_of_place_107 = l_sq * ratio_q_P2_u_P1_of_place_102;
    let ratio_q_P2_u_P1_of_place_108 = ratio_q_P2_u_P1_of_place_106 * ratio_q_P2_u_P1_of_place_107;
    let ratio_q_P2_u_P1_of_place_109 = ratio_q_P2_u_P1_of_place_108 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_110 = ratio_q_P2_u_P1_of_place_35
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_17);
    let ratio_q_P2_u_P1_of_place_111 = ratio_q_P2_u_P1_of_place_99 * ratio_q_P2_u_P1_of_place_107;
    let ratio_q_P2_u_P1 = ratio_q_P2_u_P1_of_q_p4_q_p5_16
        .mul_add(
            ratio_q_P2_u_P1_of_place_109,
            ratio_q_P2_u_P1_of_place_32 * ratio_q_P2_u_P1_of_place_103,
        ) + ratio_q_P2_u_P1_of_place_110 * ratio_q_P2_u_P1_of_place_111;
    let ratio_q_P3_u_P1_of_place = (-ratio_q_P2_u_P1_of_place_7)
        .mul_add(
            ratio_q_P2_u_P1_of_place_43,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_of_place_34,
        );
    let ratio_q_P3_u_P1_of_place_2 = ratio_q_P2_u_P1_of_place
        .mul_add(
            ratio_q_P2_u_P1_of_place_43,
            ratio_q_P2_u_P1_of_place_12 * ratio_q_P2_u_P1_of_place_40,
        );
    let ratio_q_P3_u_P1_of_place_3 = ratio_q_P2_u_P1_of_place_26
        .mul_add(
            ratio_q_P3_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_of_place_83,
        ) + ratio_q_P2_u_P1_of_place_31 * ratio_q_P3_u_P1_of_place_2;
    let ratio_q_P3_u_P1_of_place_4 = ratio_q_P2_u_P1_of_place_102 * ratio_q_P2_u_P1_of_place_110;
    let ratio_q_P3_u_P1_of_q_p3_q_p5 = ratio_q_P2_u_P1_of_q_p3_q_p5_4
        .mul_add(cos_q_P5, -ratio_q_P2_u_P1_of_q_p5) - ratio_q_P2_u_P1_of_q_p3_q_p5;
    let ratio_q_P3_u_P1_of_place_5 = ratio_q_P2_u_P1_of_place_108 * cos_q_P4;
    let ratio_q_P3_u_P1 = ratio_q_P2_u_P1_of_place_52
        .mul_add(
            ratio_q_P3_u_P1_of_place_4,
            ratio_q_P2_u_P1_of_place_103 * ratio_q_P3_u_P1_of_place_3,
        ) - ratio_q_P3_u_P1_of_q_p3_q_p5 * ratio_q_P3_u_P1_of_place_5;
    let ratio_q_P4_u_P1_of_place = ratio_q_P2_u_P1_of_place_16 * cos_q_p2_sin_q_p1;
    let ratio_q_P4_u_P1_of_place_2 = (-ratio_q_P2_u_P1_of_place_8)
        .mul_add(
            ratio_q_P4_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_20 * ratio_q_P2_u_P1_of_place_40,
        );
    let ratio_q_P4_u_P1_of_place_3 = ratio_q_P2_u_P1_of_place_18
        .mul_add(
            ratio_q_P3_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_of_place_83,
        ) - ratio_q_P2_u_P1_of_place_31 * ratio_q_P4_u_P1_of_place_2;
    let ratio_q_P4_u_P1_of_q_p4_q_p5 = ratio_q_P2_u_P1_of_q_p4_q_p5_4 - S::int(2);
    let ratio_q_P4_u_P1_of_place_4 = (-ratio_q_P4_u_P1_of_q_p4_q_p5)
        .mul_add(
            sin_q_P3,
            ratio_q_P2_u_P1_of_q_p4_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_2,
        );
    let ratio_q_P4_u_P1_of_place_5 = ratio_q_P4_u_P1_of_place_4
        .mul_add(sin_q_P4, sin_q_P3 - sin_q_P5 + cos_q_p3_cos_q_p5);
    let ratio_q_P4_u_P1 = ratio_q_P2_u_P1_of_place_103
        .mul_add(
            ratio_q_P4_u_P1_of_place_3,
            ratio_q_P2_u_P1_of_place_74 * ratio_q_P3_u_P1_of_place_4,
        ) - ratio_q_P2_u_P1_of_place_109 * ratio_q_P4_u_P1_of_place_5;
    let ratio_q_P5_u_P1_of_place = ratio_q_P2_u_P1_of_place_18
        .mul_add(
            ratio_q_P3_u_P1_of_place_2,
            ratio_q_P2_u_P1_of_place_29 * ratio_q_P2_u_P1_of_place_83,
        ) + ratio_q_P2_u_P1_of_place_26 * ratio_q_P4_u_P1_of_place_2;
    let ratio_q_P5_u_P1_of_q_p3_q_p5 = (-ratio_q_P2_u_P1_of_q_p5_4)
        .mul_add(sin_q_P3, -ratio_q_P2_u_P1_of_q_p5_3);
    let ratio_q_P5_u_P1_of_q_p3_q_p5_2 = sin_q_P3 - ratio_q_P2_u_P1_of_q_p3_q_p5_2;
    let ratio_q_P5_u_P1_of_place_2 = ratio_q_P2_u_P1_of_q_p5
        .mul_add(
            ratio_q_P5_u_P1_of_q_p3_q_p5_2,
            ratio_q_P5_u_P1_of_q_p3_q_p5 * sin_q_P4,
        );
    let ratio_q_P5_u_P1 = ratio_q_P2_u_P1_of_place_103
        .mul_add(
            ratio_q_P5_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_81 * ratio_q_P3_u_P1_of_place_4,
        ) - ratio_q_P3_u_P1_of_place_5 * ratio_q_P5_u_P1_of_place_2;
    let w_rod1_frame_in_rod2_frame_1 = u_P1 * sin_q_P2;
    let w_rod1_frame_in_rod2_frame_2 = u_P1 * cos_q_P2;
    let w_rod2_frame_3 = u_P1 * ratio_q_P2_u_P1;
    let w_rod2_frame_in_rod3_frame_2 = w_rod2_frame_3
        .mul_add(sin_q_P3, w_rod1_frame_in_rod2_frame_2 * cos_q_P3);
    let w_rod2_frame_in_rod3_frame_3 = (-w_rod2_frame_3)
        .mul_add(cos_q_P3, w_rod1_frame_in_rod2_frame_2 * sin_q_P3);
    let u_p1_ratio_q_p3_u_p1 = u_P1 * ratio_q_P3_u_P1;
    let w_rod3_frame_1 = w_rod1_frame_in_rod2_frame_1 + u_p1_ratio_q_p3_u_p1;
    let w_rod3_frame_in_rod4_frame_1 = w_rod3_frame_1
        .mul_add(cos_q_P4, w_rod2_frame_in_rod3_frame_3 * sin_q_P4);
    let w_rod3_frame_in_rod4_frame_3 = (-w_rod3_frame_1)
        .mul_add(sin_q_P4, w_rod2_frame_in_rod3_frame_3 * cos_q_P4);
    let u_p1_ratio_q_p4_u_p1 = u_P1 * ratio_q_P4_u_P1;
    let w_rod4_frame_2 = u_p1_ratio_q_p4_u_p1 - w_rod2_frame_in_rod3_frame_2;
    let w_rod4_frame_in_rod5_frame_1 = (-w_rod4_frame_2)
        .mul_add(sin_q_P5, w_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let w_rod4_frame_in_rod5_frame_2 = w_rod4_frame_2
        .mul_add(cos_q_P5, w_rod3_frame_in_rod4_frame_1 * sin_q_P5);
    let u_p1_ratio_q_p5_u_p1 = u_P1 * ratio_q_P5_u_P1;
    let w_rod5_frame_3 = w_rod3_frame_in_rod4_frame_3 + u_p1_ratio_q_p5_u_p1;
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
    let ratio_q_P2_u_P1_2_of_u_p1_6 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_12)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_3, cos_q_p4_sq * ratio_q_P2_u_P1_2_of_u_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_7 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_8 = ratio_q_P2_u_P1_2_of_u_p1_7 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_9 = ratio_q_P2_u_P1_2_of_u_p1_8 - ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_10 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_5;
    let ratio_q_P2_u_P1_2_of_u_p1_11 = sin_q_P4
        * (ratio_q_P2_u_P1_2_of_u_p1_10 - ratio_q_P2_u_P1_2_of_u_p1_9)
        + ratio_q_P2_u_P1_of_q_p4_q_p5_8 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_12 = ratio_q_P2_u_P1_2_of_u_p1_6 + ratio_q_P2_u_P1_2_of_u_p1_9;
    let ratio_q_P2_u_P1_2_of_u_p1_13 = ratio_q_P2_u_P1_2_of_u_p1_11 - ratio_q_P2_u_P1_2_of_u_p1_12;
    let ratio_q_P2_u_P1_2_of_u_p1_14 = u_p1_ratio_q_p5_u_p1 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_15 = u_p1_ratio_q_p3_u_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_16 = ratio_q_P2_u_P1_2_of_u_p1_15 * cos_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_17 = ratio_q_P2_u_P1_2_of_u_p1_14
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_16);
    let ratio_q_P2_u_P1_2_of_u_p1_18 = u_p1_ratio_q_p3_u_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_19 = ratio_q_P2_u_P1_of_q_p5
        * ratio_q_P2_u_P1_2_of_u_p1_4.mul_add(S::int(4), ratio_q_P2_u_P1_2_of_u_p1_3)
        - ratio_q_P2_u_P1_of_q_p4_3 * ratio_q_P2_u_P1_2_of_u_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_20 = cos_q_P3
        * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_11)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_17,
                ratio_q_P2_u_P1_2_of_u_p1_13 * cos_q_P3,
            ) + ratio_q_P2_u_P1_of_q_p4_q_p5_10 * ratio_q_P2_u_P1_2_of_u_p1_18
            + sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_19)
        + ratio_q_P2_u_P1_of_place_84 * ratio_q_P2_u_P1_2_of_u_p1_18;
    let ratio_q_P2_u_P1_2_of_u_p1_21 = u_p1_ratio_q_p4_u_p1 * sin_q_P4;
    let ratio_q_P2_u_P1_2_of_u_p1_22 = ratio_q_P2_u_P1_2_of_u_p1_21
        .mul_add(sin_q_P2, ratio_q_P2_u_P1 * u_p1_cos_q_p4 * cos_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_23 = ratio_q_P2_u_P1_of_q_p5_2
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_3, ratio_q_P2_u_P1_2_of_u_p1 * sin_q_P4);
    let ratio_q_P2_u_P1_2_of_u_p1_24 = ratio_q_P2_u_P1_2_of_u_p1_10 + ratio_q_P2_u_P1_2_of_u_p1_23;
    let ratio_q_P2_u_P1_2_of_u_p1_25 = ratio_q_P2_u_P1_2_of_u_p1
        .mul_add(S::int(3), -ratio_q_P2_u_P1_2_of_u_p1_8)
        + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_24;
    let ratio_q_P2_u_P1_2_of_u_p1_26 = (-ratio_q_P2_u_P1_2_of_u_p1_14)
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_18 * cos_q_P5);
    let ratio_q_P2_u_P1_2_of_u_p1_27 = ratio_q_P2_u_P1_2_of_u_p1_23
        .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1);
    let sin_q_p2_w_rod2_frame_3 = w_rod2_frame_3 * sin_q_P2;
    let sin_q_p2_ratio_q_p2_u_p1 = ratio_q_P2_u_P1 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_28 = (-cos_q_p2_sin_q_p4)
        .mul_add(u_p1_ratio_q_p4_u_p1, u_p1_cos_q_p4 * sin_q_p2_ratio_q_p2_u_p1);
    let cos_q_p2_w_rod2_frame_3 = w_rod2_frame_3 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_29 = sin_q_P2
        * ((-ratio_q_P2_u_P1_2_of_u_p1_13)
            .mul_add(
                sin_q_P3,
                ratio_q_P2_u_P1_of_q_p4_q_p5_10 * ratio_q_P2_u_P1_2_of_u_p1_15,
            ) + cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_19
            + ratio_q_P2_u_P1_of_q_p4_q_p5_11 * ratio_q_P2_u_P1_2_of_u_p1_26)
        + ratio_q_P2_u_P1_of_place_90 * cos_q_p2_w_rod2_frame_3;
    let ratio_q_P2_u_P1_2_of_u_p1_30 = ratio_q_P3_u_P1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_31 = (-(ratio_q_P2_u_P1_2_of_u_p1_30 * cos_q_P2))
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_28 * sin_q_P3);
    let u_p1_cos_q_p1 = u_P1 * cos_q_P1;
    let u_p1_sin_q_p1 = u_P1 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_32 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_7;
    let ratio_q_P2_u_P1_2_of_u_p1_33 = ratio_q_P2_u_P1_of_q_p4_q_p5
        .mul_add(sin_q_p2_w_rod2_frame_3, ratio_q_P2_u_P1_2_of_u_p1_23 * cos_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_34 = (-sin_q_p2_cos_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1,
            ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_22,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_35 = -ratio_q_P2_u_P1_of_place_98
        * ratio_q_P2_u_P1_2_of_u_p1_21
            .mul_add(cos_q_P5, ratio_q_P2_u_P1_2_of_u_p1_14 * cos_q_P4)
        + ratio_q_P2_u_P1_of_place_97 * ratio_q_P2_u_P1_2_of_u_p1_18
        + ratio_q_P2_u_P1_of_place_96 * u_p1_sin_q_p1
        + cos_q_P1
            * (sin_q_P1
                * (ratio_q_P2_u_P1_2_of_u_p1_13 - S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_20
                    - ratio_q_P2_u_P1_of_place_88 * sin_q_p2_w_rod2_frame_3
                    + cos_q_P2
                        * (-cos_q_P2
                            * (ratio_q_P2_u_P1_2_of_u_p1
                                + ratio_q_P2_u_P1_of_q_p4_q_p5_6 * ratio_q_P2_u_P1_2_of_u_p1_3
                                + sin_q_P4
                                    * ratio_q_P2_u_P1_2_of_u_p1_5
                                        .mul_add(S::int(4), ratio_q_P2_u_P1_2_of_u_p1)
                                - S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_6
                                - ratio_q_P2_u_P1_2_of_u_p1_20)
                            + ratio_q_P2_u_P1_of_place_87 * ratio_q_P2_u_P1_2_of_u_p1_22
                            - sin_q_p2_cos_q_p4
                                * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_13)
                                    .mul_add(
                                        ratio_q_P2_u_P1_2_of_u_p1_15,
                                        ratio_q_P2_u_P1_2_of_u_p1_25 * sin_q_P3,
                                    )
                                    + ratio_q_P2_u_P1_of_q_p4_q_p5_14 * ratio_q_P2_u_P1_2_of_u_p1_26
                                    + cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_27)
                            - ratio_q_P2_u_P1_of_place_86 * sin_q_p2_w_rod2_frame_3))
                + cos_q_P1
                    * (ratio_q_P2_u_P1_of_place_94 * ratio_q_P2_u_P1_2_of_u_p1_14
                        - ratio_q_P2_u_P1_of_place_92 * ratio_q_P2_u_P1_2_of_u_p1_18
                        + cos_q_P3
                            * (ratio_q_P2_u_P1_of_q_p4_q_p5_13
                                .mul_add(
                                    ratio_q_P2_u_P1_2_of_u_p1_28,
                                    cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_25,
                                ) + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_29)
                        + cos_q_P5
                            * ((-ratio_q_P2_u_P1_2_of_u_p1_19)
                                .mul_add(
                                    sin_q_P2,
                                    ratio_q_P2_u_P1_of_q_p4_q_p5_11 * cos_q_p2_w_rod2_frame_3,
                                ) - ratio_q_P2_u_P1_of_place_93 * ratio_q_P2_u_P1_2_of_u_p1_27
                                - ratio_q_P2_u_P1_of_q_p4_q_p5_14 * ratio_q_P2_u_P1_2_of_u_p1_31))
                - ratio_q_P2_u_P1_of_place_89 * u_p1_cos_q_p1
                - ratio_q_P2_u_P1_of_place_95 * u_p1_sin_q_p1)
        - cos_q_P3
            * (ratio_q_P2_u_P1_2_of_u_p1_29
                + ratio_q_P2_u_P1_of_q_p4_q_p5_15 * ratio_q_P2_u_P1_2_of_u_p1_28
                + cos_q_p2_cos_q_p4 * (ratio_q_P2_u_P1_2_of_u_p1_24 + ratio_q_P2_u_P1_2_of_u_p1_32))
        + cos_q_p4_cos_q_p5
            * ((-ratio_q_P2_u_P1_of_place_23)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_15,
                    ratio_q_P2_u_P1_2_of_u_p1_33 * sin_q_P3,
                ) - ratio_q_P2_u_P1_2_of_u_p1_34);
    let ratio_q_P2_u_P1_2_of_u_p1_36 = ratio_q_P2_u_P1_2_of_u_p1_3 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_37 = sin_q_p2_w_rod2_frame_3
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_2_of_u_p1_36);
    let ratio_q_P2_u_P1_2_of_u_p1_38 = ratio_q_P2_u_P1_2_of_u_p1_30 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_39 = ratio_q_P2_u_P1_2_of_u_p1_38
        .mul_add(cos_q_P3, -ratio_q_P2_u_P1_2_of_u_p1_37);
    let sin_q_p4_u_p1_cos_q_p1 = u_p1_cos_q_p1 * sin_q_P4;
    let cos_q_p3_ratio_q_p4_u_p1 = ratio_q_P4_u_P1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_40 = (-sin_q_p4_u_p1_cos_q_p1)
        .mul_add(
            cos_q_p3_ratio_q_p4_u_p1,
            sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_30,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_41 = cos_q_p3_sin_q_p1
        .mul_add(u_p1_cos_q_p4, ratio_q_P2_u_P1_2_of_u_p1_40);
    let ratio_q_P2_u_P1_2_of_u_p1_42 = cos_q_P5
        * (sin_q_P1
            * ratio_q_P2_u_P1_2_of_u_p1_22
                .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_39)
            + ratio_q_P2_u_P1_of_place_9 * u_p1_cos_q_p1 + ratio_q_P2_u_P1_2_of_u_p1_41)
        - ratio_q_P2_u_P1_of_place_11 * ratio_q_P2_u_P1_2_of_u_p1_14;
    let ratio_q_P2_u_P1_2_of_u_p1_43 = ratio_q_P2_u_P1_2_of_u_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_44 = (-ratio_q_P2_u_P1_2_of_u_p1_23)
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_p2_w_rod2_frame_3)
        + ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_31
        + cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_43;
    let ratio_q_P2_u_P1_2_of_u_p1_45 = ratio_q_P2_u_P1_2_of_u_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_46 = sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_47 = (-ratio_q_P2_u_P1_2_of_u_p1_18)
        .mul_add(sin_q_P5, ratio_q_P2_u_P1_2_of_u_p1_17 * sin_q_P4)
        - ratio_q_P2_u_P1_2_of_u_p1_45 - ratio_q_P2_u_P1_2_of_u_p1_46;
    let ratio_q_P2_u_P1_2_of_u_p1_48 = ratio_q_P2_u_P1_2_of_u_p1_22
        .mul_add(cos_q_P5, sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_14)
        - ratio_q_P2_u_P1_of_place_6 * sin_q_p2_w_rod2_frame_3
        + ratio_q_P2_u_P1_2_of_u_p1_47 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_49 = u_p1_cos_q_p1
        .mul_add(sin_q_P2, w_rod2_frame_3 * cos_q_p2_sin_q_p1);
    let sin_q_p3_u_p1_sin_q_p1 = u_p1_sin_q_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_50 = ratio_q_P2_u_P1_2_of_u_p1_15 * cos_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_51 = ratio_q_P2_u_P1_2_of_u_p1_28
        - sin_q_p2_sin_q_p3 * ratio_q_P2_u_P1_2_of_u_p1_3
        + sin_q_P4
            * cos_q_p2_w_rod2_frame_3
                .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_u_p1_15 * sin_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_52 = u_p1_sin_q_p1
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_u_p1_18 * cos_q_P1);
    let ratio_q_P2_u_P1_2_of_u_p1_53 = ratio_q_P2_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_14
        - ratio_q_P2_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1
        + cos_q_P5
            * ((-sin_q_p2_sin_q_p1)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_18,
                    ratio_q_P2_u_P1_2_of_u_p1_49 * cos_q_P3,
                ) - sin_q_p3_u_p1_sin_q_p1 + ratio_q_P2_u_P1_2_of_u_p1_50)
        - sin_q_P5
            * (ratio_q_P2_u_P1_of_place_3
                .mul_add(u_p1_cos_q_p1, cos_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_3)
                + ratio_q_P2_u_P1_2_of_u_p1_51 * sin_q_P1
                + ratio_q_P2_u_P1_2_of_u_p1_52 * sin_q_P4);
    let ratio_q_P2_u_P1_2_of_u_p1_54 = ratio_q_P2_u_P1_of_place_5
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_44,
            ratio_q_P2_u_P1_of_place_8 * ratio_q_P2_u_P1_2_of_u_p1_42,
        ) - ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_2_of_u_p1_48
        - ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_53;
    let ratio_q_P2_u_P1_2_of_u_p1_55 = ratio_q_P2_u_P1_2_of_u_p1_15 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_u_p1_56 = cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3;
    let ratio_q_P2_u_P1_2_of_u_p1_57 = ratio_q_P2_u_P1_2_of_u_p1_26
        .mul_add(sin_q_P4, -ratio_q_P2_u_P1_2_of_u_p1_43) + ratio_q_P2_u_P1_2_of_u_p1_55
        + ratio_q_P2_u_P1_2_of_u_p1_56;
    let ratio_q_P2_u_P1_2_of_u_p1_58 = (-ratio_q_P2_u_P1_2_of_u_p1_47)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_6 * u_p1_sin_q_p1)
        - ratio_q_P2_u_P1_of_place_19 * ratio_q_P2_u_P1_2_of_u_p1_49
        + sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_57;
    let ratio_q_P2_u_P1_2_of_u_p1_59 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_18, ratio_q_P2_u_P1_2_of_u_p1_17)
        - ratio_q_P2_u_P1_2_of_u_p1_23 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_60 = ratio_q_P2_u_P1_2_of_u_p1_59 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_place = ratio_q_P2_u_P1_of_place_16 * sin_q_p2_w_rod2_frame_3;
    let ratio_q_P2_u_P1_2_of_u_p1_61 = ratio_q_P2_u_P1_2_of_place - ratio_q_P2_u_P1_2_of_u_p1_60;
    let ratio_q_P2_u_P1_2_of_place_2 = l * ratio_q_P2_u_P1_of_place_20;
    let ratio_q_P2_u_P1_2_of_u_p1_62 = (-ratio_q_P2_u_P1_of_place_67)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_53,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_61,
        ) - ratio_q_P2_u_P1_of_place_8 * ratio_q_P2_u_P1_2_of_u_p1_58
        + ratio_q_P2_u_P1_2_of_u_p1_48 * ratio_q_P2_u_P1_2_of_place_2;
    let ratio_q_P2_u_P1_2_of_u_p1_63 = ratio_q_P2_u_P1_of_place_28
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_58,
            ratio_q_P2_u_P1_of_place_67 * ratio_q_P2_u_P1_2_of_u_p1_42,
        ) + ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_2_of_u_p1_61
        + ratio_q_P2_u_P1_2_of_u_p1_44 * ratio_q_P2_u_P1_2_of_place_2;
    let ratio_q_P2_u_P1_2_of_u_p1_64 = (-ratio_q_P2_u_P1_2_of_u_p1_23)
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_q_p4_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_15)
        + ratio_q_P2_u_P1_2_of_u_p1_26;
    let ratio_q_P2_u_P1_2_of_u_p1_65 = (-ratio_q_P2_u_P1_2_of_u_p1_59)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_16 * u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_66 = l
        * (-u_p1_cos_q_p1
            * ratio_q_P2_u_P1
                .mul_add(ratio_q_P2_u_P1_of_place_21, ratio_q_P2_u_P1_of_place_15)
            + ratio_q_P2_u_P1_2_of_u_p1_64 * sin_q_P1 + ratio_q_P2_u_P1_2_of_u_p1_65 * sin_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_67 = ratio_q_P2_u_P1_of_q_p3_q_p5
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_22, -ratio_q_P2_u_P1_2_of_u_p1_33)
        + ratio_q_P2_u_P1_of_q_p3_q_p5_3 * ratio_q_P2_u_P1_2_of_u_p1_38
        - sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_43;
    let ratio_q_P2_u_P1_2_of_u_p1_68 = cos_q_p3_cos_q_p1 * u_p1_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_u_p1_69 = l
        * (-u_p1_sin_q_p1
            * ratio_q_P2_u_P1_of_q_p4_q_p5
                .mul_add(cos_q_p3_ratio_q_p4_u_p1, -ratio_q_P2_u_P1_of_place_24)
            + ratio_q_P2_u_P1_of_place_25 * ratio_q_P2_u_P1_2_of_u_p1
            + ratio_q_P2_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_30 * sin_q_P1
            - ratio_q_P2_u_P1_2_of_u_p1_67 * cos_q_P1
            - ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_68);
    let ratio_q_P2_u_P1_2_of_u_p1_70 = (-cos_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_14, ratio_q_P2_u_P1_2_of_u_p1_28 * cos_q_P5)
        + ratio_q_P2_u_P1_of_place_6 * cos_q_p2_w_rod2_frame_3
        + ratio_q_P2_u_P1_2_of_u_p1_47 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_71 = l
        * ((-ratio_q_P2_u_P1_2_of_u_p1_57)
            .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_19 * u_p1_cos_q_p1)
            + ratio_q_P2_u_P1_of_place_30 * u_p1_sin_q_p1
            + ratio_q_P2_u_P1_2_of_u_p1_70 * cos_q_P1);
    let cos_q_p2_u_p1_cos_q_p1 = u_p1_cos_q_p1 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_72 = (-cos_q_p2_cos_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1,
            ratio_q_P2_u_P1_of_place_33 * cos_q_p2_w_rod2_frame_3,
        ) - ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_28
        - ratio_q_P2_u_P1_2_of_u_p1_64 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_73 = (-ratio_q_P2_u_P1_of_place_30)
        .mul_add(u_p1_cos_q_p1, ratio_q_P2_u_P1_of_place_19 * u_p1_sin_q_p1)
        + ratio_q_P2_u_P1_2_of_u_p1_57 * cos_q_P1 + ratio_q_P2_u_P1_2_of_u_p1_70 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_74 = sin_q_p2_w_rod2_frame_3
        .mul_add(sin_q_P1, -cos_q_p2_u_p1_cos_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_75 = l * ratio_q_P2_u_P1_2_of_u_p1_48;
    let ratio_q_P2_u_P1_2_of_u_p1_76 = ratio_q_P2_u_P1_of_place_8 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_77 = ratio_q_P2_u_P1_2_of_u_p1_75
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_2_of_u_p1_76);
    let ratio_q_P2_u_P1_2_of_u_p1_78 = ratio_q_P2_u_P1_of_place_33
        .mul_add(sin_q_p2_w_rod2_frame_3, ratio_q_P2_u_P1_2_of_u_p1_34)
        + ratio_q_P2_u_P1_2_of_u_p1_64 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_u_p1_79 = ratio_q_P2_u_P1_of_place_82
        * ratio_q_P2_u_P1_2_of_u_p1_53 * sin_q_P1
        + ratio_q_P2_u_P1_of_place_43 * ratio_q_P2_u_P1_2_of_u_p1_73
        - ratio_q_P2_u_P1_of_place_38 * ratio_q_P2_u_P1_2_of_u_p1_77
        + ratio_q_P2_u_P1_of_place_5
            * (-ratio_q_P2_u_P1_2_of_u_p1_78)
                .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_42 * u_p1_cos_q_p1);
    let ratio_q_P2_u_P1_2_of_place_3 = l * ratio_q_P2_u_P1_of_place_44;
    let ratio_q_P2_u_P1_2_of_place_4 = ratio_q_P2_u_P1_of_place_7 * l_sq;
    let ratio_q_P2_u_P1_2_of_u_p1_80 = ratio_q_P2_u_P1_of_q_p5_2
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_18, ratio_q_P2_u_P1_2_of_u_p1_45);
    let ratio_q_P2_u_P1_2_of_u_p1_81 = ratio_q_P2_u_P1_of_q_p3
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_14, ratio_q_P2_u_P1_2_of_u_p1_16)
        + ratio_q_P2_u_P1_2_of_u_p1_80;
    let ratio_q_P2_u_P1_2_of_u_p1_82 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_15, ratio_q_P2_u_P1_2_of_u_p1_43);
    let ratio_q_P2_u_P1_2_of_u_p1_83 = ratio_q_P2_u_P1_of_q_p4_q_p5
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_74,
            cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_23,
        );
    let ratio_q_P2_u_P1_2_of_u_p1_84 = cos_q_p2_sin_q_p1
        * (ratio_q_P2_u_P1_of_place_49
            * u_p1_cos_q_p1.mul_add(cos_q_P5, ratio_q_P2_u_P1_2_of_u_p1_14 * sin_q_P1)
            - ratio_q_P2_u_P1_of_place_47 * ratio_q_P2_u_P1_2_of_u_p1_18
            - cos_q_p5_sin_q_p1
                * (ratio_q_P2_u_P1_2_of_u_p1_37
                    + ratio_q_P2_u_P1_of_place_48 * ratio_q_P2_u_P1_2_of_u_p1_15
                    + sin_q_P3
                        * ratio_q_P2_u_P1_of_q_p3
                            .mul_add(
                                ratio_q_P2_u_P1_2_of_u_p1_22, ratio_q_P2_u_P1_2_of_u_p1_39,
                            ))
            - cos_q_P3
                * (cos_q_P4
                    * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
                        .mul_add(
                            u_p1_sin_q_p1,
                            sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_82,
                        ) - ratio_q_P2_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_49
                        - ratio_q_P2_u_P1_2_of_u_p1_81 * cos_q_P1)
                    - ratio_q_P2_u_P1_of_place_45 * ratio_q_P2_u_P1_2_of_u_p1_21
                    + ratio_q_P2_u_P1_2_of_u_p1_83));
    let ratio_q_P2_u_P1_2_of_u_p1_85 = ratio_q_P2_u_P1_of_place_51 * ratio_q_P2_u_P1_2_of_u_p1_48
        + l * ratio_q_P2_u_P1_of_place_39 * ratio_q_P2_u_P1_2_of_u_p1_72
        + ratio_q_P2_u_P1_of_place_40
            * (l
                * ratio_q_P2_u_P1_of_place_37
                    .mul_add(
                        ratio_q_P2_u_P1_2_of_u_p1_53,
                        ratio_q_P2_u_P1_of_place_38 * ratio_q_P2_u_P1_2_of_u_p1_42,
                    )
                + ratio_q_P2_u_P1_of_place_5
                    * (ratio_q_P2_u_P1_of_place_24
                        .mul_add(
                            u_p1_cos_q_p1,
                            ratio_q_P2_u_P1_of_place_10 * ratio_q_P2_u_P1_2_of_u_p1,
                        ) + ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1_41
                        + ratio_q_P2_u_P1_2_of_u_p1_67 * sin_q_P1)
                + ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_2_of_u_p1_73)
        - ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_50 * ratio_q_P2_u_P1_2_of_u_p1_74
        + ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_u_p1_79
        - ratio_q_P2_u_P1_2_of_u_p1_44 * ratio_q_P2_u_P1_2_of_place_3
        + ratio_q_P2_u_P1_2_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_84;
    let ratio_q_P2_u_P1_2_of_u_p1_86 = S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_4;
    let ratio_q_P2_u_P1_2_of_u_p1_87 = ratio_q_P2_u_P1_2_of_u_p1_86
        - ratio_q_P2_u_P1_of_q_p4_2 * ratio_q_P2_u_P1_2_of_u_p1
        - sin_q_P5 * (ratio_q_P2_u_P1_2_of_u_p1_3 + ratio_q_P2_u_P1_2_of_u_p1_86);
    let ratio_q_P2_u_P1_2_of_u_p1_88 = ratio_q_P2_u_P1_2_of_u_p1_87 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_u_p1_89 = ratio_q_P2_u_P1_of_q_p4_q_p5_3
        * ratio_q_P2_u_P1_2_of_u_p1_15;
    let ratio_q_P2_u_P1_2_of_u_p1_90 = ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P2_u_P1_2_of_u_p1_23;
    let ratio_q_P2_u_P1_2_of_u_p1_91 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_90;
    let ratio_q_P2_u_P1_2_of_u_p1_92 = ratio_q_P2_u_P1_of_q_p4
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_17, -ratio_q_P2_u_P1_2_of_u_p1_46);
    let ratio_q_P2_u_P1_2_of_u_p1_93 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_3)
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_18, ratio_q_P2_u_P1_2_of_u_p1_87 * cos_q_P3);
    let ratio_q_P2_u_P1_2_of_u_p1_94 = ratio_q_P2_u_P1_2_of_u_p1_26 + ratio_q_P2_u_P1_2_of_u_p1_82;
    let ratio_q_P2_u_P1_2_of_u_p1_95 = cos_q_P1
        * (ratio_q_P2_u_P1_2_of_u_p1_17 + ratio_q_P2_u_P1_2_of_u_p1_80);
    let ratio_q_P2_u_P1_2_of_place_5 = ratio_q_P2_u_P1_of_q_p3_q_p5_7 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_96 = u_p1_sin_q_p1
        .mul_add(cos_q_P2, sin_q_p2_ratio_q_p2_u_p1 * u_p1_cos_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_97 = sin_q_P1
        * (ratio_q_P2_u_P1_of_place_71 * cos_q_p2_w_rod2_frame_3
            - cos_q_p2_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_47
            + sin_q_P2
                * (ratio_q_P2_u_P1_of_place_69 * u_p1_cos_q_p1
                    - ratio_q_P4_u_P1 * ratio_q_P2_u_P1_of_q_p3_q_p5_7 * sin_q_p4_u_p1_cos_q_p1
                    + sin_q_P1
                        * (cos_q_P2
                            * (ratio_q_P2_u_P1_of_q_p3_q_p5_5 * ratio_q_P2_u_P1_2_of_u_p1_3
                                - ratio_q_P2_u_P1_of_q_p3 * ratio_q_P2_u_P1_2_of_u_p1
                                + sin_q_P4
                                    * (ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P2_u_P1_2_of_u_p1_26)
                                + ratio_q_P2_u_P1_2_of_u_p1_55)
                            - ratio_q_P2_u_P1_of_q_p3_q_p5_6 * ratio_q_P2_u_P1_2_of_u_p1_22
                            - ratio_q_P2_u_P1_of_place_68 * sin_q_p2_w_rod2_frame_3
                            + sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_94)
                    - ratio_q_P2_u_P1_2_of_u_p1_95 * cos_q_P4
                    + u_p1_cos_q_p4 * ratio_q_P2_u_P1_2_of_place_5)
            + ratio_q_P2_u_P1_of_place_6 * ratio_q_P2_u_P1_2_of_u_p1_96)
        + ratio_q_P2_u_P1_of_place_72 * u_p1_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_u_p1_98 = l_sq * ratio_q_P2_u_P1_2_of_u_p1_72;
    let ratio_q_P2_u_P1_2_of_u_p1_99 = ratio_q_P2_u_P1_of_place_73 * ratio_q_P2_u_P1_2_of_u_p1_48
        - ratio_q_P2_u_P1_of_place_67 * ratio_q_P2_u_P1_2_of_u_p1_79
        + ratio_q_P2_u_P1_2_of_u_p1_61 * ratio_q_P2_u_P1_2_of_place_3
        + ratio_q_P2_u_P1_of_place_66
            * (-u_p1_cos_q_p1
                * (ratio_q_P2_u_P1_of_place_63 * sin_q_p3_sin_q_p1)
                    .mul_add(S::int(2), ratio_q_P2_u_P1_of_place_62)
                + ratio_q_P2_u_P1_of_place_64 * ratio_q_P2_u_P1_2_of_u_p1_50
                - sin_q_P1
                    * (ratio_q_P2_u_P1_of_q_p4_q_p5_4
                        * ratio_q_P2_u_P1_2_of_u_p1_31
                            .mul_add(
                                cos_q_P1,
                                cos_q_p2_sin_q_p1 * u_p1_cos_q_p4 * sin_q_P3,
                            ) + ratio_q_P2_u_P1_of_place_61 * cos_q_p2_w_rod2_frame_3
                        + sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_91
                        + sin_q_P2
                            * (sin_q_p3_cos_q_p1
                                * ratio_q_P2_u_P1_2_of_u_p1_89
                                    .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_88)
                                - ratio_q_P2_u_P1_of_place_60 * ratio_q_P2_u_P1_2_of_u_p1_18
                                - ratio_q_P2_u_P1_of_place_53 * sin_q_p3_u_p1_sin_q_p1
                                + cos_q_P3
                                    * (ratio_q_P2_u_P1_of_place_56 * u_p1_cos_q_p1
                                        + ratio_q_P2_u_P1_of_place_59 * u_p1_sin_q_p1
                                        + sin_q_P1
                                            * (ratio_q_P2_u_P1_of_q_p4_q_p5_4
                                                * ratio_q_P2_u_P1_2_of_u_p1_28
                                                + ratio_q_P2_u_P1_of_place_54 * cos_q_p2_w_rod2_frame_3
                                                + sin_q_P2
                                                    * (ratio_q_P2_u_P1_of_q_p4
                                                        .mul_add(
                                                            ratio_q_P2_u_P1_2_of_u_p1_26,
                                                            ratio_q_P2_u_P1_2_of_u_p1_56,
                                                        ) + ratio_q_P2_u_P1_2_of_u_p1_88
                                                        + ratio_q_P2_u_P1_2_of_u_p1_89)
                                                + ratio_q_P2_u_P1_2_of_u_p1_91)
                                        - cos_q_P1
                                            * ratio_q_P2_u_P1_2_of_u_p1_92
                                                .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_93))))
                + sin_q_p3_cos_q_p1 * cos_q_P1
                    * (ratio_q_P2_u_P1_2_of_u_p1_92 + ratio_q_P2_u_P1_2_of_u_p1_93))
        + ratio_q_P2_u_P1_2_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_97
        - ratio_q_P2_u_P1_of_place_65 * ratio_q_P2_u_P1_2_of_u_p1_98;
    let ratio_q_P2_u_P1_2_of_u_p1_100 = ratio_q_P2_u_P1_of_place_51
        * (-ratio_q_P2_u_P1_2_of_place).mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_60)
        - ratio_q_P2_u_P1_of_place_73 * ratio_q_P2_u_P1_2_of_u_p1_44
        + ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_of_place_50 * cos_q_p2_u_p1_cos_q_p1
        + ratio_q_P2_u_P1_of_place_66
            * (ratio_q_P2_u_P1_of_place_79 * u_p1_cos_q_p1
                - ratio_q_P2_u_P1_of_place_10 * ratio_q_P2_u_P1_2_of_u_p1_95
                + ratio_q_P2_u_P1_of_place_70 * ratio_q_P2_u_P1_2_of_u_p1_40
                + S::int(2) * ratio_q_P2_u_P1_2_of_u_p1_68 * ratio_q_P2_u_P1_2_of_place_5
                - sin_q_P1
                    * (ratio_q_P2_u_P1_of_place_70 * ratio_q_P2_u_P1_2_of_u_p1_36
                        - ratio_q_P2_u_P1_of_place_78 * cos_q_p2_w_rod2_frame_3
                        + sin_q_P2
                            * (cos_q_p3_cos_q_p5
                                * (cos_q_p2_sin_q_p1
                                    .mul_add(
                                        ratio_q_P2_u_P1_2_of_u_p1_3, -ratio_q_P2_u_P1_2_of_u_p1_41,
                                    ) + ratio_q_P2_u_P1_2_of_u_p1_74 * sin_q_P4)
                                - ratio_q_P2_u_P1_of_place_76 * ratio_q_P2_u_P1_2_of_u_p1_15
                                - ratio_q_P2_u_P1_of_place_77 * ratio_q_P2_u_P1_2_of_u_p1_26
                                + sin_q_P3
                                    * (ratio_q_P2_u_P1_2_of_u_p1_83
                                        - ratio_q_P2_u_P1_of_place_75 * ratio_q_P2_u_P1_2_of_u_p1_21
                                        + cos_q_P4
                                            * (ratio_q_P2_u_P1_of_q_p3_q_p5_8 * u_p1_sin_q_p1
                                                - ratio_q_P2_u_P1_of_q_p3_q_p5_6
                                                    * ratio_q_P2_u_P1_2_of_u_p1_49
                                                - cos_q_P1
                                                    * ratio_q_P2_u_P1_2_of_u_p1_80
                                                        .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_u_p1_17)
                                                + sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_94)))
                        - cos_q_p2_sin_q_p4 * ratio_q_P2_u_P1_2_of_u_p1_95
                        + ratio_q_P2_u_P1_of_q_p3_q_p5_7 * ratio_q_P2_u_P1_2_of_u_p1_96 * sin_q_P4))
        + l_sq
            * ratio_q_P2_u_P1_of_place
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_97,
                    ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_2_of_u_p1_84,
                ) + ratio_q_P2_u_P1_of_place_80 * ratio_q_P2_u_P1_2_of_u_p1_98;
    let ratio_q_P2_u_P1_2_of_u_p1_101 = l
        * ratio_q_P2_u_P1_2_of_u_p1_78
            .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_42 * u_p1_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_u_p1_102 = ratio_q_P2_u_P1_of_place_101
        * ((-ratio_q_P2_u_P1_of_place_52)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_66,
                l_sq * ratio_q_P2_u_P1_of_place_83 * ratio_q_P2_u_P1_2_of_u_p1_35,
            ) + ratio_q_P2_u_P1_of_place_74 * ratio_q_P2_u_P1_2_of_u_p1_69
            - ratio_q_P2_u_P1_of_place_81 * ratio_q_P2_u_P1_2_of_u_p1_71
            + ratio_q_P2_u_P1_of_place_18 * ratio_q_P2_u_P1_2_of_u_p1_85
            + ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_u_p1_99
            - ratio_q_P2_u_P1_of_place_31 * ratio_q_P2_u_P1_2_of_u_p1_100
            + ratio_q_P2_u_P1_of_place_100 * ratio_q_P2_u_P1_2_of_u_p1_101);
    let ratio_q_P2_u_P1_2_of_u_p1_103 = ratio_q_P2_u_P1_of_place_104 * ratio_q_P2_u_P1_2_of_u_p1
        + ratio_q_P2_u_P1_of_place_105 * ratio_q_P2_u_P1_2_of_u_p1_14
        + cos_q_P5
            * ((-cos_q_p3_sin_q_p1)
                .mul_add(ratio_q_P2_u_P1_2_of_u_p1_3, sin_q_p4_u_p1_cos_q_p1 * cos_q_P3)
                - ratio_q_P2_u_P1_2_of_u_p1_18 * sin_q_P1 * sin_q_P4
                - ratio_q_P2_u_P1_of_place_3 * u_p1_sin_q_p1
                + ratio_q_P2_u_P1_2_of_u_p1_51 * cos_q_P1)
        + sin_q_P5
            * ((-ratio_q_P2_u_P1_2_of_u_p1_15)
                .mul_add(sin_q_P1, ratio_q_P2_u_P1 * cos_q_p2_u_p1_cos_q_p1 * cos_q_P3)
                - u_p1_cos_q_p1 * sin_q_P3 - ratio_q_P2_u_P1_2_of_u_p1_52 * sin_q_P2);
    let ratio_q_P2_u_P1_2_of_u_p1_104 = ratio_q_P2_u_P1_of_place_107
        * ratio_q_P2_u_P1_of_place_106
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_102, -ratio_q_P2_u_P1_2_of_u_p1_103);
    let ratio_q_P2_u_P1_2_of_u_p1_105 = ratio_q_P2_u_P1_2_of_u_p1_104
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_108 * ratio_q_P2_u_P1_2_of_u_p1_14);
    let ratio_q_P2_u_P1_2_of_u_p1_106 = ratio_q_P2_u_P1_of_place_35
        .mul_add(u_p1_sin_q_p1, ratio_q_P2_u_P1_of_place_16 * u_p1_cos_q_p1)
        + ratio_q_P2_u_P1_2_of_u_p1_59 * sin_q_P1 - ratio_q_P2_u_P1_2_of_u_p1_72 * cos_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_107 = ratio_q_P2_u_P1_of_place_102
        * ratio_q_P2_u_P1_of_place_36
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_102, -ratio_q_P2_u_P1_2_of_u_p1_106);
    let ratio_q_P2_u_P1_2_of_u_p1_108 = ratio_q_P2_u_P1_of_place_35
        .mul_add(u_p1_cos_q_p1, -ratio_q_P2_u_P1_2_of_u_p1_65)
        + ratio_q_P2_u_P1_2_of_u_p1_72 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_u_p1_109 = ratio_q_P2_u_P1_of_place_110
        .mul_add(ratio_q_P2_u_P1_2_of_u_p1_102, ratio_q_P2_u_P1_2_of_u_p1_108);
    let ratio_q_P2_u_P1_2 = ratio_q_P2_u_P1_of_place_103
        * ((-ratio_q_P2_u_P1_of_place_18)
            .mul_add(
                ratio_q_P2_u_P1_2_of_u_p1_54,
                ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_u_p1_62,
            ) + ratio_q_P2_u_P1_of_place_31 * ratio_q_P2_u_P1_2_of_u_p1_63
            - ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_2_of_u_p1_66
            + ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_2_of_u_p1_69
            - ratio_q_P2_u_P1_of_place_29 * ratio_q_P2_u_P1_2_of_u_p1_71)
        - ratio_q_P2_u_P1_of_place_107 * ratio_q_P2_u_P1_of_place_110 * ratio_q_P2_u_P1_2_of_u_p1_35
        - ratio_q_P2_u_P1_of_place_109 * ratio_q_P2_u_P1_2_of_u_p1_90
        + ratio_q_P2_u_P1_of_q_p4_q_p5_16 * ratio_q_P2_u_P1_2_of_u_p1_105
        + ratio_q_P2_u_P1_of_place_32 * ratio_q_P2_u_P1_2_of_u_p1_107
        + ratio_q_P2_u_P1_of_place_111 * ratio_q_P2_u_P1_2_of_u_p1_109;
    let ratio_q_P3_u_P1_2_of_u_p1 = (-ratio_q_P2_u_P1_of_place_40)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_53,
            S::int(2) * ratio_q_P2_u_P1_of_place_43 * ratio_q_P2_u_P1_2_of_u_p1_48,
        ) - ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_72
        + ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_2_of_u_p1_76;
    let ratio_q_P3_u_P1_2_of_u_p1_2 = (-ratio_q_P2_u_P1_of_place_40)
        .mul_add(
            ratio_q_P2_u_P1_2_of_u_p1_42,
            ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_2_of_u_p1_72,
        ) - ratio_q_P2_u_P1_of_place_43 * ratio_q_P2_u_P1_2_of_u_p1_44
        + ratio_q_P2_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_77;
    let ratio_q_P3_u_P1_2_of_u_p1_3 = ratio_q_P2_u_P1_2_of_u_p1_104
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_108 * ratio_q_P2_u_P1_2_of_u_p1_21);
    let ratio_q_P3_u_P1_2_of_u_p1_4 = ratio_q_P2_u_P1_of_place_102 * ratio_q_P2_u_P1_2_of_u_p1_109;
    let ratio_q_P3_u_P1_2 = ratio_q_P3_u_P1_of_place_5
        * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
            .mul_add(ratio_q_P2_u_P1_2_of_u_p1_14, ratio_q_P2_u_P1_2_of_u_p1)
            + ratio_q_P2_u_P1_2_of_u_p1_81 * cos_q_P5 - ratio_q_P2_u_P1_2_of_u_p1_82)
        + ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_85
        + ratio_q_P3_u_P1_of_place_3 * ratio_q_P2_u_P1_2_of_u_p1_107
        + ratio_q_P2_u_P1_of_place_103
            * ((-ratio_q_P2_u_P1_of_place_83)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_54,
                    ratio_q_P3_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_71,
                ) - ratio_q_P3_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_69
                - ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_2_of_u_p1_101
                - ratio_q_P2_u_P1_of_place_26 * ratio_q_P3_u_P1_2_of_u_p1
                + ratio_q_P2_u_P1_of_place_31 * ratio_q_P3_u_P1_2_of_u_p1_2)
        - ratio_q_P3_u_P1_of_q_p3_q_p5 * ratio_q_P3_u_P1_2_of_u_p1_3
        + ratio_q_P2_u_P1_of_place_52 * ratio_q_P3_u_P1_2_of_u_p1_4;
    let ratio_q_P4_u_P1_2_of_u_p1 = ratio_q_P2_u_P1_of_place_40 * ratio_q_P2_u_P1_2_of_u_p1_58
        - ratio_q_P2_u_P1_2_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_72
        + ratio_q_P2_u_P1_of_place_8
            * (-ratio_q_P2_u_P1_of_place_16)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_74,
                    cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_u_p1_59,
                ) + ratio_q_P4_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_75;
    let ratio_q_P4_u_P1_2_of_u_p1_2 = ratio_q_P2_u_P1_2_of_u_p1_26 - ratio_q_P2_u_P1_2_of_u_p1_15;
    let ratio_q_P4_u_P1_2 = ratio_q_P4_u_P1_of_place_3 * ratio_q_P2_u_P1_2_of_u_p1_107
        - ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_99
        - ratio_q_P4_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_u_p1_105
        + ratio_q_P2_u_P1_of_place_74 * ratio_q_P3_u_P1_2_of_u_p1_4
        + ratio_q_P2_u_P1_of_place_103
            * ((-ratio_q_P2_u_P1_of_place_83)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_62,
                    ratio_q_P2_u_P1_of_place_31 * ratio_q_P4_u_P1_2_of_u_p1,
                ) - ratio_q_P3_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_66
                - ratio_q_P4_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_71
                - ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_2_of_u_p1_101
                - ratio_q_P2_u_P1_of_place_18 * ratio_q_P3_u_P1_2_of_u_p1)
        + ratio_q_P2_u_P1_of_place_109
            * (-ratio_q_P2_u_P1_2_of_u_p1 + ratio_q_P4_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_3
                - sin_q_P4
                    * ((-ratio_q_P4_u_P1_of_q_p4_q_p5)
                        .mul_add(
                            ratio_q_P2_u_P1_2_of_u_p1_15,
                            ratio_q_P2_u_P1_2_of_u_p1_90 * sin_q_P3,
                        ) - ratio_q_P2_u_P1_2_of_u_p1_23 - ratio_q_P2_u_P1_2_of_u_p1_26)
                + ratio_q_P4_u_P1_2_of_u_p1_2);
    let ratio_q_P5_u_P1_2 = ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_u_p1_100
        + ratio_q_P5_u_P1_of_place * ratio_q_P2_u_P1_2_of_u_p1_107
        - ratio_q_P5_u_P1_of_place_2 * ratio_q_P3_u_P1_2_of_u_p1_3
        + ratio_q_P2_u_P1_of_place_81 * ratio_q_P3_u_P1_2_of_u_p1_4
        + ratio_q_P2_u_P1_of_place_103
            * ((-ratio_q_P2_u_P1_of_place_83)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_u_p1_63,
                    ratio_q_P2_u_P1_of_place_18 * ratio_q_P3_u_P1_2_of_u_p1_2,
                ) - ratio_q_P3_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_66
                - ratio_q_P4_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_u_p1_69
                - ratio_q_P2_u_P1_of_place_29 * ratio_q_P2_u_P1_2_of_u_p1_101
                - ratio_q_P2_u_P1_of_place_26 * ratio_q_P4_u_P1_2_of_u_p1)
        + ratio_q_P3_u_P1_of_place_5
            * (ratio_q_P5_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_u_p1_3
                - ratio_q_P5_u_P1_of_q_p3_q_p5_2 * ratio_q_P2_u_P1_2_of_u_p1
                + sin_q_P4
                    * ((-(ratio_q_P2_u_P1_2_of_u_p1_2 * sin_q_P3))
                        .mul_add(
                            S::int(2),
                            ratio_q_P2_u_P1_of_q_p5_4 * ratio_q_P2_u_P1_2_of_u_p1_15,
                        ) + ratio_q_P2_u_P1_2_of_u_p1_32)
                + ratio_q_P2_u_P1_of_q_p5 * ratio_q_P4_u_P1_2_of_u_p1_2);
    let w_rod1_frame_22 = u_P1 * u_P1;
    let w_rod2_frame_11 = w_rod1_frame_in_rod2_frame_1 * w_rod1_frame_in_rod2_frame_1;
    let w_rod2_frame_12 = w_rod1_frame_in_rod2_frame_1 * w_rod1_frame_in_rod2_frame_2;
    let w_rod2_frame_23 = w_rod1_frame_in_rod2_frame_2 * w_rod2_frame_3;
    let w_rod2_frame_33 = w_rod2_frame_3 * w_rod2_frame_3;
    let turn_rod2_frame_22 = w_rod2_frame_11 + w_rod2_frame_33;
    let w_rod3_frame_11 = w_rod3_frame_1 * w_rod3_frame_1;
    let w_rod3_frame_13 = w_rod2_frame_in_rod3_frame_3 * w_rod3_frame_1;
    let w_rod3_frame_22 = w_rod2_frame_in_rod3_frame_2 * w_rod2_frame_in_rod3_frame_2;
    let w_rod3_frame_23 = w_rod2_frame_in_rod3_frame_2 * w_rod2_frame_in_rod3_frame_3;
    let turn_rod3_frame_33 = w_rod3_frame_11 + w_rod3_frame_22;
    let w_rod4_frame_12 = w_rod3_frame_in_rod4_frame_1 * w_rod4_frame_2;
    let w_rod4_frame_13 = w_rod3_frame_in_rod4_frame_1 * w_rod3_frame_in_rod4_frame_3;
    let w_rod4_frame_22 = w_rod4_frame_2 * w_rod4_frame_2;
    let w_rod4_frame_33 = w_rod3_frame_in_rod4_frame_3 * w_rod3_frame_in_rod4_frame_3;
    let turn_rod4_frame_11 = w_rod4_frame_22 + w_rod4_frame_33;
    let w_rod5_frame_11 = w_rod4_frame_in_rod5_frame_1 * w_rod4_frame_in_rod5_frame_1;
    let w_rod5_frame_12 = w_rod4_frame_in_rod5_frame_1 * w_rod4_frame_in_rod5_frame_2;
    let w_rod5_frame_23 = w_rod4_frame_in_rod5_frame_2 * w_rod5_frame_3;
    let w_rod5_frame_33 = w_rod5_frame_3 * w_rod5_frame_3;
    let turn_rod5_frame_22 = w_rod5_frame_11 + w_rod5_frame_33;
    let a_rod1_centre_1 = l * w_rod1_frame_22;
    let a_rod1_frame_in_rod2_frame_1 = (-g)
        .mul_add(sin_q_P2, a_rod1_centre_1 * cos_q_P2);
    let a_rod1_frame_in_rod2_frame_2 = a_rod1_centre_1.mul_add(sin_q_P2, g * cos_q_P2);
    let m_l_sq = m * l_sq;
    let H_rod2_1 = w_rod1_frame_in_rod2_frame_1 * m_l_sq;
    let H_rod2_3 = w_rod2_frame_3 * m_l_sq;
    let a_rod3_centre_2 = l.mul_add(turn_rod2_frame_22, -a_rod1_frame_in_rod2_frame_2);
    let H_rod3_1 = w_rod3_frame_1 * m_l_sq;
    let H_rod3_2 = w_rod2_frame_in_rod3_frame_2 * m_l_sq;
    let H_rod4_2 = w_rod4_frame_2 * m_l_sq;
    let H_rod4_3 = w_rod3_frame_in_rod4_frame_3 * m_l_sq;
    let H_rod5_1 = w_rod4_frame_in_rod5_frame_1 * m_l_sq;
    let H_rod5_3 = w_rod5_frame_3 * m_l_sq;
    let F_w_rod4_frame_in_rod5_frame_2 = (-w_rod4_frame_in_rod5_frame_1)
        .mul_add(H_rod5_3, w_rod5_frame_3 * H_rod5_1);
    let alpha_rod1_frame_in_rod2_frame_1 = u_P1_dot * sin_q_P2;
    let alpha_rod1_frame_in_rod2_frame_2 = u_P1_dot * cos_q_P2;
    let alpha_rod2_frame_1_2 = w_rod2_frame_23 + alpha_rod1_frame_in_rod2_frame_1;
    let alpha_rod2_frame_2 = w_rod1_frame_in_rod2_frame_1
        .mul_add(w_rod2_frame_3, -alpha_rod1_frame_in_rod2_frame_2);
    let alpha_rod2_frame_3_2 = u_P1
        .mul_add(ratio_q_P2_u_P1_2, u_P1_dot * ratio_q_P2_u_P1);
    let turn_rod2_frame_12_2 = w_rod2_frame_12 - alpha_rod2_frame_3_2;
    let turn_rod2_frame_32_2 = w_rod2_frame_23 + alpha_rod2_frame_1_2;
    let alpha_rod2_frame_in_rod3_frame_2_2 = (-alpha_rod2_frame_3_2)
        .mul_add(sin_q_P3, alpha_rod2_frame_2 * cos_q_P3);
    let alpha_rod2_frame_in_rod3_frame_3_2 = alpha_rod2_frame_3_2
        .mul_add(cos_q_P3, alpha_rod2_frame_2 * sin_q_P3);
    let alpha_rod3_frame_1_2 = u_P1
        .mul_add(ratio_q_P3_u_P1_2, u_P1_dot * ratio_q_P3_u_P1) + alpha_rod2_frame_1_2;
    let alpha_rod3_frame_2_2 = w_rod2_frame_in_rod3_frame_3
        .mul_add(u_p1_ratio_q_p3_u_p1, alpha_rod2_frame_in_rod3_frame_2_2);
    let alpha_rod3_frame_3_2 = w_rod2_frame_in_rod3_frame_2
        .mul_add(u_p1_ratio_q_p3_u_p1, -alpha_rod2_frame_in_rod3_frame_3_2);
    let turn_rod3_frame_13_2 = w_rod3_frame_13 + alpha_rod3_frame_2_2;
    let turn_rod3_frame_23_2 = w_rod3_frame_23 + alpha_rod3_frame_1_2;
    let alpha_rod3_frame_in_rod4_frame_1_2 = alpha_rod3_frame_3_2
        .mul_add(sin_q_P4, alpha_rod3_frame_1_2 * cos_q_P4);
    let alpha_rod3_frame_in_rod4_frame_3_2 = (-alpha_rod3_frame_1_2)
        .mul_add(sin_q_P4, alpha_rod3_frame_3_2 * cos_q_P4);
    let alpha_rod4_frame_1_2 = w_rod3_frame_in_rod4_frame_3
        .mul_add(u_p1_ratio_q_p4_u_p1, -alpha_rod3_frame_in_rod4_frame_1_2);
    let alpha_rod4_frame_2_2 = u_P1
        .mul_add(ratio_q_P4_u_P1_2, u_P1_dot * ratio_q_P4_u_P1) + alpha_rod3_frame_2_2;
    let alpha_rod4_frame_3_2 = w_rod3_frame_in_rod4_frame_1
        .mul_add(u_p1_ratio_q_p4_u_p1, alpha_rod3_frame_in_rod4_frame_3_2);
    let turn_rod4_frame_21_2 = w_rod4_frame_12 + alpha_rod4_frame_3_2;
    let turn_rod4_frame_31_2 = w_rod4_frame_13 - alpha_rod4_frame_2_2;
    let alpha_rod4_frame_in_rod5_frame_1_2 = alpha_rod4_frame_2_2
        .mul_add(sin_q_P5, alpha_rod4_frame_1_2 * cos_q_P5);
    let alpha_rod5_frame_1_2 = w_rod4_frame_in_rod5_frame_2
        .mul_add(u_p1_ratio_q_p5_u_p1, -alpha_rod4_frame_in_rod5_frame_1_2);
    let alpha_rod5_frame_3_2 = u_P1
        .mul_add(ratio_q_P5_u_P1_2, u_P1_dot * ratio_q_P5_u_P1) + alpha_rod4_frame_3_2;
    let turn_rod5_frame_12_2 = w_rod5_frame_12 - alpha_rod5_frame_3_2;
    let turn_rod5_frame_32_2 = w_rod5_frame_23 + alpha_rod5_frame_1_2;
    let a_rod1_centre_3 = l * u_P1_dot;
    let l_turn_rod2_frame_12_2 = l * turn_rod2_frame_12_2;
    let a_rod2_centre_1_2 = a_rod1_frame_in_rod2_frame_1
        .mul_add(S::int(2), -l_turn_rod2_frame_12_2);
    let l_turn_rod2_frame_32_2 = l * turn_rod2_frame_32_2;
    let a_rod2_centre_3_2 = (-a_rod1_centre_3)
        .mul_add(S::int(2), l_turn_rod2_frame_32_2);
    let a_rod3_centre_1_3 = a_rod1_frame_in_rod2_frame_1 - l_turn_rod2_frame_12_2;
    let a_rod3_centre_3_2 = l_turn_rod2_frame_32_2 - a_rod1_centre_3;
    let a_rod2_frame_in_rod3_frame_2_2 = (-a_rod3_centre_3_2)
        .mul_add(sin_q_P3, a_rod3_centre_2 * cos_q_P3);
    let a_rod2_frame_in_rod3_frame_3_2 = a_rod3_centre_3_2
        .mul_add(cos_q_P3, a_rod3_centre_2 * sin_q_P3);
    let l_turn_rod3_frame_13_2 = l * turn_rod3_frame_13_2;
    let a_rod3_centre_1_4 = a_rod3_centre_1_3.mul_add(S::int(2), l_turn_rod3_frame_13_2);
    let l_turn_rod3_frame_23_2 = l * turn_rod3_frame_23_2;
    let a_rod3_centre_2_3 = a_rod2_frame_in_rod3_frame_2_2
        .mul_add(S::int(2), l_turn_rod3_frame_23_2);
    let l_turn_rod3_frame_33 = l * turn_rod3_frame_33;
    let a_rod3_centre_3_3 = (-a_rod2_frame_in_rod3_frame_3_2)
        .mul_add(S::int(2), l_turn_rod3_frame_33);
    let a_rod4_centre_1_3 = a_rod3_centre_1_3 + l_turn_rod3_frame_13_2;
    let a_rod4_centre_2_3 = a_rod2_frame_in_rod3_frame_2_2 + l_turn_rod3_frame_23_2;
    let a_rod4_centre_3_3 = l_turn_rod3_frame_33 - a_rod2_frame_in_rod3_frame_3_2;
    let a_rod3_frame_in_rod4_frame_1_2 = (-a_rod4_centre_1_3)
        .mul_add(cos_q_P4, a_rod4_centre_3_3 * sin_q_P4);
    let a_rod3_frame_in_rod4_frame_3_2 = a_rod4_centre_3_3
        .mul_add(cos_q_P4, a_rod4_centre_1_3 * sin_q_P4);
    let l_turn_rod4_frame_11 = l * turn_rod4_frame_11;
    let a_rod4_centre_1_4 = a_rod3_frame_in_rod4_frame_1_2
        .mul_add(S::int(2), l_turn_rod4_frame_11);
    let l_turn_rod4_frame_21_2 = l * turn_rod4_frame_21_2;
    let a_rod4_centre_2_4 = (-a_rod4_centre_2_3)
        .mul_add(S::int(2), l_turn_rod4_frame_21_2);
    let l_turn_rod4_frame_31_2 = l * turn_rod4_frame_31_2;
    let a_rod4_centre_3_4 = (-a_rod3_frame_in_rod4_frame_3_2)
        .mul_add(S::int(2), l_turn_rod4_frame_31_2);
    let a_rod5_centre_1_3 = a_rod3_frame_in_rod4_frame_1_2 + l_turn_rod4_frame_11;
    let a_rod5_centre_2_3 = l_turn_rod4_frame_21_2 - a_rod4_centre_2_3;
    let a_rod5_centre_3_3 = l_turn_rod4_frame_31_2 - a_rod3_frame_in_rod4_frame_3_2;
    let a_rod4_frame_in_rod5_frame_1_2 = a_rod5_centre_2_3
        .mul_add(sin_q_P5, a_rod5_centre_1_3 * cos_q_P5);
    let a_rod4_frame_in_rod5_frame_2_2 = (-a_rod5_centre_2_3)
        .mul_add(cos_q_P5, a_rod5_centre_1_3 * sin_q_P5);
    let a_rod5_centre_1_4 = a_rod4_frame_in_rod5_frame_1_2
        .mul_add(S::int(2), l * turn_rod5_frame_12_2);
    let a_rod5_centre_2_4 = (-a_rod4_frame_in_rod5_frame_2_2)
        .mul_add(S::int(2), l * turn_rod5_frame_22);
    let a_rod5_centre_3_4 = (-a_rod5_centre_3_3)
        .mul_add(S::int(2), l * turn_rod5_frame_32_2);
    let F_v_rod5_centre_3_2 = m * a_rod5_centre_3_4;
    let F_v_rod5_centre_1_2 = m * a_rod5_centre_1_4;
    let F_v_rod4_frame_in_rod5_frame_2_2 = m * a_rod5_centre_2_4;
    let F_v_rod5_centre_2_2 = F_v_rod4_frame_in_rod5_frame_2_2
        .mul_add(cos_q_P5, F_v_rod5_centre_1_2 * sin_q_P5);
    let F_v_rod4_centre_3_2 = m * a_rod4_centre_3_4;
    let F_v_rod4_centre_2_3 = m * a_rod4_centre_2_4;
    let F_v_rod3_frame_in_rod4_frame_3_2 = F_v_rod5_centre_3_2 - F_v_rod4_centre_3_2;
    let F_v_rod3_frame_in_rod4_frame_1_2 = F_v_rod5_centre_1_2
        .mul_add(cos_q_P5, m * a_rod4_centre_1_4) - F_v_rod4_frame_in_rod5_frame_2_2 * sin_q_P5;
    let F_v_rod4_centre_2_4 = F_v_rod5_centre_2_2 + F_v_rod4_centre_2_3;
    let F_v_rod4_centre_1_2 = (-F_v_rod3_frame_in_rod4_frame_1_2)
        .mul_add(cos_q_P4, F_v_rod3_frame_in_rod4_frame_3_2 * sin_q_P4);
    let F_v_rod3_centre_2_2 = m * a_rod3_centre_2_3;
    let F_v_rod3_centre_1_2 = m * a_rod3_centre_1_4;
    let F_v_rod2_frame_in_rod3_frame_3_2 = F_v_rod3_frame_in_rod4_frame_3_2
        .mul_add(cos_q_P4, m * a_rod3_centre_3_3) + F_v_rod3_frame_in_rod4_frame_1_2 * sin_q_P4;
    let F_v_rod2_frame_in_rod3_frame_2_2 = F_v_rod4_centre_2_4 - F_v_rod3_centre_2_2;
    let F_v_rod3_centre_3_2 = (-F_v_rod2_frame_in_rod3_frame_2_2)
        .mul_add(sin_q_P3, F_v_rod2_frame_in_rod3_frame_3_2 * cos_q_P3);
    let F_v_rod2_centre_3_2 = m * a_rod2_centre_3_2;
    let F_v_rod2_centre_1_2_of_place = F_v_rod4_centre_1_2 + F_v_rod3_centre_1_2;
    let F_v_rod2_centre_1_2 = F_v_rod2_centre_1_2_of_place
        .mul_add(S::int(2), m * a_rod2_centre_1_2);
    let F_v_rod1_centre_3_2_of_place = F_v_rod3_centre_3_2 - F_v_rod2_centre_3_2;
    let F_v_rod1_centre_3_2 = F_v_rod1_centre_3_2_of_place
        .mul_add(S::int(2), m * a_rod1_centre_3);
    let l_times_3 = S::int(3) * l;
    let F_w_rod5_frame_3_2 = (-alpha_rod5_frame_3_2)
        .mul_add(m_l_sq, w_rod4_frame_in_rod5_frame_2 * H_rod5_1) + F_v_rod5_centre_1_2 * l_times_3;
    let F_w_rod4_frame_in_rod5_frame_1_2 = alpha_rod5_frame_1_2
        .mul_add(m_l_sq, w_rod4_frame_in_rod5_frame_2 * H_rod5_3) + F_v_rod5_centre_3_2 * l_times_3;
    let l_times_6 = S::int(6) * l;
    let F_w_rod4_frame_2_2 = (-F_w_rod4_frame_in_rod5_frame_2)
        .mul_add(cos_q_P5, w_rod3_frame_in_rod4_frame_1 * H_rod4_3)
        + F_w_rod4_frame_in_rod5_frame_1_2 * sin_q_P5 - alpha_rod4_frame_2_2 * m_l_sq
        + F_v_rod4_centre_3_2 * l_times_3 - F_v_rod5_centre_3_2 * l_times_6;
    let F_w_rod3_frame_in_rod4_frame_3_2 = w_rod3_frame_in_rod4_frame_1
        .mul_add(H_rod4_2, -F_w_rod5_frame_3_2) + alpha_rod4_frame_3_2 * m_l_sq
        + F_v_rod4_centre_2_3 * l_times_3 + F_v_rod5_centre_2_2 * l_times_6;
    let F_w_rod3_frame_in_rod4_frame_1_2 = (-w_rod3_frame_in_rod4_frame_3)
        .mul_add(H_rod4_2, w_rod4_frame_2 * H_rod4_3) + F_w_rod4_frame_in_rod5_frame_2 * sin_q_P5
        + F_w_rod4_frame_in_rod5_frame_1_2 * cos_q_P5;
    let F_w_rod3_frame_1_2 = (-F_w_rod3_frame_in_rod4_frame_3_2)
        .mul_add(sin_q_P4, w_rod2_frame_in_rod3_frame_3 * H_rod3_2)
        + F_w_rod3_frame_in_rod4_frame_1_2 * cos_q_P4 + alpha_rod3_frame_1_2 * m_l_sq
        + F_v_rod3_centre_2_2 * l_times_3 - F_v_rod4_centre_2_4 * l_times_6;
    let F_w_rod2_frame_in_rod3_frame_3_2 = (-w_rod2_frame_in_rod3_frame_2)
        .mul_add(H_rod3_1, w_rod3_frame_1 * H_rod3_2) - F_w_rod3_frame_in_rod4_frame_3_2 * cos_q_P4
        - F_w_rod3_frame_in_rod4_frame_1_2 * sin_q_P4;
    let F_w_rod2_frame_in_rod3_frame_2_2 = w_rod2_frame_in_rod3_frame_3
        .mul_add(H_rod3_1, -F_w_rod4_frame_2_2) + alpha_rod3_frame_2_2 * m_l_sq
        + F_v_rod3_centre_1_2 * l_times_3 + F_v_rod4_centre_1_2 * l_times_6;
    let F_w_rod2_frame_3_2 = (-F_w_rod2_frame_in_rod3_frame_3_2)
        .mul_add(cos_q_P3, w_rod1_frame_in_rod2_frame_2 * H_rod2_1)
        + F_w_rod2_frame_in_rod3_frame_2_2 * sin_q_P3 - alpha_rod2_frame_3_2 * m_l_sq
        - F_v_rod2_centre_1_2 * l_times_3;
    let F_w_rod1_frame_in_rod2_frame_2_2 = (-w_rod1_frame_in_rod2_frame_1)
        .mul_add(H_rod2_3, w_rod2_frame_3 * H_rod2_1) - F_w_rod2_frame_in_rod3_frame_3_2 * sin_q_P3
        - F_w_rod2_frame_in_rod3_frame_2_2 * cos_q_P3;
    let F_w_rod1_frame_in_rod2_frame_1_2 = w_rod1_frame_in_rod2_frame_2
        .mul_add(H_rod2_3, F_w_rod3_frame_1_2) + alpha_rod2_frame_1_2 * m_l_sq
        + F_v_rod2_centre_3_2 * l_times_3 - F_v_rod3_centre_3_2 * l_times_6;
    let tau1_of_place = ratio_q_P4_u_P1
        .mul_add(F_w_rod4_frame_2_2, ratio_q_P5_u_P1 * F_w_rod5_frame_3_2);
    let tau1_of_place_2 = (-ratio_q_P3_u_P1)
        .mul_add(F_w_rod3_frame_1_2, ratio_q_P2_u_P1 * F_w_rod2_frame_3_2);
    let tau1_of_place_3 = F_w_rod1_frame_in_rod2_frame_1_2
        .mul_add(sin_q_P2, F_w_rod1_frame_in_rod2_frame_2_2 * cos_q_P2);
    let tau1_of_u_p1_dot = u_P1_dot.mul_add(m_l_sq, -tau1_of_place);
    let tau1_of_place_4 = tau1_of_place_2 - tau1_of_place_3;
    let tau1_of_u_p1_dot_2 = tau1_of_u_p1_dot - tau1_of_place_4;
    // Values.
    let tau1 = S::ratio(1, 4) * l * F_v_rod1_centre_3_2 + S::ratio(1, 12) * tau1_of_u_p1_dot_2;
    [tau1]
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

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 3,
            coordinates: 5,
            variables: 1,
            speeds: 1,
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
