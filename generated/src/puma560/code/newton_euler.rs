//! PUMA 560: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/puma560/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{coordinate_rates, power};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows column force j11, column force j12, column force j13, column moment j11, column moment j12, column moment j13, upper_arm force l21, upper_arm force l22, upper_arm force l23, upper_arm moment l21, upper_arm moment l22, upper_arm moment l23, forearm force l31, forearm force l32, forearm force l33, forearm moment l31, forearm moment l32, forearm moment l33, wrist1 force l41, wrist1 force l42, wrist1 force l43, wrist1 moment l41, wrist1 moment l42, wrist1 moment l43, wrist2 force l51, wrist2 force l52, wrist2 force l53, wrist2 moment l51, wrist2 moment l52, wrist2 moment l53, flange force l61, flange force l62, flange force l63, flange moment l61, flange moment l62, flange moment l63.
///
/// 307 operations, 6 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    _u: &[S; 6],
) -> [[S; 36]; 36] {
    let Parameters {
        a2, a3, d3, d4, m2, m3, m4, m5, m6, x2, y2, z2, x3, y3, z3, y4, z6, I1, Ixx2, Iyy2, Izz2,
        Ixx3, Iyy3, Izz3, Ixx4, Iyy4, Ixx5, Iyy5, Ixx6, Izz6,
        ..
    } = *p;
    let [q1, q2, q3, q4, q5, q6] = *q;
    // Sines and cosines.
    let (s2_2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    let (s4_2, c4) = q4.sin_cos();
    let (s5, c5) = q5.sin_cos();
    let (s6_2, c6) = q6.sin_cos();
    let (s1_2, c1) = q1.sin_cos();
    // Step by step, each after the terms that it needs.
    let a_C2_1_2 = z2 * c2;
    let x_L2_1_3 = m2 * a_C2_1_2;
    let x_L2_1_4 = m2 * y2;
    let a_C2_2_2 = z2 * s2_2;
    let x_L2_2_3 = m2 * a_C2_2_2;
    let a_C2_2_3 = a2 + x2;
    let x_L2_2_4 = m2 * a_C2_2_3;
    let y2_s2_2 = y2 * s2_2;
    let a_C2_3_2_of_place = a_C2_2_3.mul_add(c2, -y2_s2_2);
    let a_C2_3_2 = a_C2_3_2_of_place;
    let x_L2_3_3 = m2 * a_C2_3_2;
    let x_L2_1_5 = Ixx2 * s2_2;
    let x_L2_in_L1_1 = a_C2_3_2_of_place;
    let x_L2_in_L1_2 = a_C2_2_3.mul_add(s2_2, y2 * c2);
    let x_L1_in_L2_1 = (-x_L2_in_L1_1).mul_add(s2_2, x_L2_in_L1_2 * c2);
    let x_L2_2_5 = Iyy2 * c2;
    let x_L1_in_L2_2 = x_L2_in_L1_2.mul_add(s2_2, x_L2_in_L1_1 * c2);
    let alpha_L2_in_J3_2_2 = (-c2).mul_add(c3, s2_2 * s3_2);
    let a_C3_1_4 = d3 * alpha_L2_in_J3_2_2;
    let a_C3_1_5 = y3.mul_add(alpha_L2_in_J3_2_2, -a_C3_1_4);
    let x_L3_1_3 = m3 * a_C3_1_5;
    let a_L2_in_J3_1_2 = a2 * s3_2;
    let a_C3_1_6 = z3 - a_L2_in_J3_1_2;
    let x_L3_1_4 = m3 * a_C3_1_6;
    let x_L3_1_5 = m3 * z3;
    let w_L2_in_J3_1_2 = s2_2.mul_add(c3, c2 * s3_2);
    let a_C3_3_4 = a2 * c2;
    let a_C3_3_5 = a3.mul_add(alpha_L2_in_J3_2_2, -a_C3_3_4);
    let a_C3_2_4 = z3.mul_add(w_L2_in_J3_1_2, x3 * alpha_L2_in_J3_2_2) + a_C3_3_5;
    let x_L3_2_3 = m3 * a_C3_2_4;
    let a_C3_2_5 = d3 * w_L2_in_J3_1_2;
    let a_C3_3_6 = y3.mul_add(w_L2_in_J3_1_2, -a_C3_2_5);
    let x_L3_3_3 = m3 * a_C3_3_6;
    let a_L2_in_J3_2_2 = a2 * c3;
    let a_C3_2_6 = a3 + a_L2_in_J3_2_2;
    let a_C3_3_7 = x3 + a_C3_2_6;
    let x_L3_3_4 = m3 * a_C3_3_7;
    let x_L2_1_6 = a3 + x3;
    let x_L3_3_5 = m3 * x_L2_1_6;
    let x_L3_1_6 = Ixx3 * w_L2_in_J3_1_2;
    let x_L3_3_6 = d4 - z3 + y4;
    let x_L2_3_4 = d3 - y3;
    let x_L2_in_J3_1 = x_L2_3_4 * s3_2;
    let x_L2_in_J3_1_2 = x_L2_3_4 * c3;
    let x_J3_in_L2_1 = (-z3).mul_add(s3_2, x_L2_1_6 * c3);
    let x_J3_in_L2_2 = x_L2_1_6.mul_add(s3_2, z3 * c3);
    let x_L2_in_J3_1_3 = (-x_J3_in_L2_1).mul_add(s3_2, x_J3_in_L2_2 * c3);
    let x_L3_3_7 = Izz3 * alpha_L2_in_J3_2_2;
    let x_L2_in_J3_2 = x_J3_in_L2_2.mul_add(s3_2, x_J3_in_L2_1 * c3);
    let alpha_L3_in_J4_2_2 = w_L2_in_J3_1_2 * s4_2;
    let a_C4_2_3 = d4.mul_add(w_L2_in_J3_1_2, a_C3_3_5);
    let a_L3_in_J4_1_2 = a_C4_2_3.mul_add(s4_2, a_C3_1_4 * c4);
    let a_C4_1_3 = y4.mul_add(alpha_L3_in_J4_2_2, a_L3_in_J4_1_2);
    let x_L4_1_3 = m4 * a_C4_1_3;
    let a_C4_1_4 = d4 - a_L2_in_J3_1_2;
    let a_L3_in_J4_1_3 = a_C4_1_4 * c4;
    let y4_c4 = y4 * c4;
    let a_C4_1_5 = a_L3_in_J4_1_3 + y4_c4;
    let x_L4_1_4 = m4 * a_C4_1_5;
    let a_L3_in_J4_1_4 = d4 * c4;
    let a_C4_1_6 = a_L3_in_J4_1_4 + y4_c4;
    let x_L4_1_5 = m4 * a_C4_1_6;
    let x_L4_2_3 = m4 * a_C3_2_5;
    let x_L4_2_4 = m4 * a_C3_2_6;
    let x_L4_2_5 = a3 * m4;
    let alpha_L3_in_J4_1_2 = w_L2_in_J3_1_2 * c4;
    let a_L3_in_J4_2_2 = (-a_C4_2_3).mul_add(c4, a_C3_1_4 * s4_2);
    let a_C4_3_3 = y4.mul_add(alpha_L3_in_J4_1_2, -a_L3_in_J4_2_2);
    let x_L4_3_3 = m4 * a_C4_3_3;
    let a_L3_in_J4_2_3 = a_C4_1_4 * s4_2;
    let y4_s4_2 = y4 * s4_2;
    let a_C4_3_4 = a_L3_in_J4_2_3 + y4_s4_2;
    let x_L4_3_4 = m4 * a_C4_3_4;
    let a_L3_in_J4_2_4 = d4 * s4_2;
    let a_C4_3_5 = a_L3_in_J4_2_4 + y4_s4_2;
    let x_L4_3_5 = m4 * a_C4_3_5;
    let x_L4_1_6 = Ixx4 * alpha_L3_in_J4_1_2;
    let x_L4_1_7 = Ixx4 * s4_2;
    let x_L4_2_6 = Iyy4 * alpha_L2_in_J3_2_2;
    let x_L4_3_6 = Ixx4 * alpha_L3_in_J4_2_2;
    let x_L4_3_7 = Ixx4 * c4;
    let x_L3_in_J4_1_2 = m5 * a_L3_in_J4_1_2;
    let x_L3_in_J4_3_2 = m5 * a_C3_2_5;
    let x_L4_in_J5_1_2 = x_L3_in_J4_3_2.mul_add(s5, x_L3_in_J4_1_2 * c5);
    let x_L3_in_J4_1_3 = m5 * a_L3_in_J4_1_3;
    let x_L3_in_J4_3_3 = m5 * a_C3_2_6;
    let x_L4_in_J5_1_3 = (-x_L3_in_J4_3_3).mul_add(s5, x_L3_in_J4_1_3 * c5);
    let x_L3_in_J4_1_4 = m5 * a_L3_in_J4_1_4;
    let x_L3_in_J4_3_4 = a3 * m5;
    let x_L4_in_J5_1_4 = (-x_L3_in_J4_3_4).mul_add(s5, x_L3_in_J4_1_4 * c5);
    let x_L3_in_J4_2_2 = m5 * a_L3_in_J4_2_2;
    let x_L3_in_J4_2_3 = m5 * a_L3_in_J4_2_3;
    let x_L3_in_J4_2_4 = m5 * a_L3_in_J4_2_4;
    let x_L4_in_J5_2_2 = (-x_L3_in_J4_3_2).mul_add(c5, x_L3_in_J4_1_2 * s5);
    let x_L4_in_J5_2_3 = x_L3_in_J4_3_3.mul_add(c5, x_L3_in_J4_1_3 * s5);
    let x_L4_in_J5_2_4 = x_L3_in_J4_3_4.mul_add(c5, x_L3_in_J4_1_4 * s5);
    let alpha_L4_in_J5_1_2 = (-alpha_L2_in_J3_2_2).mul_add(s5, alpha_L3_in_J4_1_2 * c5);
    let x_L5_1_2 = Ixx5 * alpha_L4_in_J5_1_2;
    let alpha_L4_in_J5_1_3 = s4_2 * c5;
    let x_L5_1_3 = Ixx5 * alpha_L4_in_J5_1_3;
    let x_L5_1_4 = Ixx5 * s5;
    let x_L5_2_2 = Iyy5 * alpha_L3_in_J4_2_2;
    let x_L5_2_3 = Iyy5 * c4;
    let alpha_L4_in_J5_2_2 = alpha_L3_in_J4_1_2.mul_add(s5, alpha_L2_in_J3_2_2 * c5);
    let x_L5_3_2 = Ixx5 * alpha_L4_in_J5_2_2;
    let alpha_L4_in_J5_2_3 = s4_2 * s5;
    let x_L5_3_3 = Ixx5 * alpha_L4_in_J5_2_3;
    let x_L5_3_4 = Ixx5 * c5;
    let alpha_L5_in_L6_2_2 = alpha_L4_in_J5_1_2.mul_add(s6_2, alpha_L3_in_J4_2_2 * c6);
    let a_L4_in_J5_1_2 = a_L3_in_J4_1_2.mul_add(c5, a_C3_2_5 * s5);
    let a_L5_in_L6_1_2 = (-a_L3_in_J4_2_2).mul_add(s6_2, a_L4_in_J5_1_2 * c6);
    let a_C6_1_2 = z6.mul_add(alpha_L5_in_L6_2_2, a_L5_in_L6_1_2);
    let x_L6_1_3 = m6 * a_C6_1_2;
    let alpha_L5_in_L6_2_3 = (-c4).mul_add(c6, alpha_L4_in_J5_1_3 * s6_2);
    let a_L4_in_J5_1_3 = (-a_C3_2_6).mul_add(s5, a_L3_in_J4_1_3 * c5);
    let a_L5_in_L6_1_3 = (-a_L3_in_J4_2_3).mul_add(s6_2, a_L4_in_J5_1_3 * c6);
    let z6_alpha_l5_in_l6_2_3 = z6 * alpha_L5_in_L6_2_3;
    let a_C6_1_3 = z6_alpha_l5_in_l6_2_3 - a_L5_in_L6_1_3;
    let x_L6_1_4 = m6 * a_C6_1_3;
    let a_L4_in_J5_1_4 = (-a3).mul_add(s5, a_L3_in_J4_1_4 * c5);
    let a_L5_in_L6_1_4 = (-a_L3_in_J4_2_4).mul_add(s6_2, a_L4_in_J5_1_4 * c6);
    let a_C6_1_4 = z6_alpha_l5_in_l6_2_3 - a_L5_in_L6_1_4;
    let x_L6_1_5 = m6 * a_C6_1_4;
    let alpha_L5_in_L6_2_4 = s5 * s6_2;
    let a_C6_1_5 = z6 * alpha_L5_in_L6_2_4;
    let x_L6_1_6 = m6 * a_C6_1_5;
    let a_C6_1_6 = z6 * c6;
    let x_L6_1_7 = m6 * a_C6_1_6;
    let alpha_L5_in_L6_1_2 = (-alpha_L3_in_J4_2_2)
        .mul_add(s6_2, alpha_L4_in_J5_1_2 * c6);
    let a_L5_in_L6_2_2 = a_L4_in_J5_1_2.mul_add(s6_2, a_L3_in_J4_2_2 * c6);
    let a_C6_2_2 = z6.mul_add(alpha_L5_in_L6_1_2, -a_L5_in_L6_2_2);
    let x_L6_2_3 = m6 * a_C6_2_2;
    let alpha_L5_in_L6_1_3 = alpha_L4_in_J5_1_3.mul_add(c6, c4 * s6_2);
    let a_L5_in_L6_2_3 = a_L4_in_J5_1_3.mul_add(s6_2, a_L3_in_J4_2_3 * c6);
    let z6_alpha_l5_in_l6_1_3 = z6 * alpha_L5_in_L6_1_3;
    let a_C6_2_3 = a_L5_in_L6_2_3 + z6_alpha_l5_in_l6_1_3;
    let x_L6_2_4 = m6 * a_C6_2_3;
    let a_L5_in_L6_2_4 = a_L4_in_J5_1_4.mul_add(s6_2, a_L3_in_J4_2_4 * c6);
    let a_C6_2_4 = a_L5_in_L6_2_4 + z6_alpha_l5_in_l6_1_3;
    let x_L6_2_5 = m6 * a_C6_2_4;
    let alpha_L5_in_L6_1_4 = s5 * c6;
    let a_C6_2_5 = z6 * alpha_L5_in_L6_1_4;
    let x_L6_2_6 = m6 * a_C6_2_5;
    let a_C6_2_6 = z6 * s6_2;
    let x_L6_2_7 = m6 * a_C6_2_6;
    let a_L4_in_J5_2_2 = (-a_C3_2_5).mul_add(c5, a_L3_in_J4_1_2 * s5);
    let x_L6_3_3 = m6 * a_L4_in_J5_2_2;
    let a_L4_in_J5_2_3 = a_L3_in_J4_1_3.mul_add(s5, a_C3_2_6 * c5);
    let x_L6_3_4 = m6 * a_L4_in_J5_2_3;
    let a_L4_in_J5_2_4 = a_L3_in_J4_1_4.mul_add(s5, a3 * c5);
    let x_L6_3_5 = m6 * a_L4_in_J5_2_4;
    let x_L6_1_8 = Ixx6 * alpha_L5_in_L6_1_2;
    let x_L6_1_9 = Ixx6 * alpha_L5_in_L6_1_3;
    let x_L6_1_10 = Ixx6 * alpha_L5_in_L6_1_4;
    let x_L6_1_11 = Ixx6 * s6_2;
    let x_L6_2_8 = Ixx6 * alpha_L5_in_L6_2_2;
    let x_L6_2_9 = Ixx6 * alpha_L5_in_L6_2_3;
    let x_L6_2_10 = Ixx6 * alpha_L5_in_L6_2_4;
    let x_L6_2_11 = Ixx6 * c6;
    let x_L6_3_6 = Izz6 * alpha_L4_in_J5_2_2;
    let x_L6_3_7 = Izz6 * alpha_L4_in_J5_2_3;
    let x_L6_3_8 = Izz6 * c5;
    let minus_s6_2 = -s6_2;
    let minus_s5 = -s5;
    let minus_s4_2 = -s4_2;
    let minus_s3_2 = -s3_2;
    let minus_s2_2 = -s2_2;
    let minus_s1_2 = -s1_2;
    let minus_c1 = -c1;
    let minus_c2 = -c2;
    let minus_c3 = -c3;
    let minus_iyy3 = -Iyy3;
    let minus_c4 = -c4;
    let minus_c5 = -c5;
    let minus_c6 = -c6;
    let minus_x_l4_1_7 = -x_L4_1_7;
    let minus_x_l5_1_3 = -x_L5_1_3;
    let minus_x_l5_2_3 = -x_L5_2_3;
    let minus_x_l6_1_9 = -x_L6_1_9;
    // Entries that are not zero.
    let m_1_27 = S::int(1);
    let m_1_32 = minus_c1;
    let m_1_33 = minus_s1_2;
    let m_2_28 = S::int(1);
    let m_2_32 = s1_2;
    let m_2_33 = minus_c1;
    let m_3_29 = S::int(1);
    let m_3_34 = -S::int(1);
    let m_4_30 = S::int(1);
    let m_4_35 = minus_c1;
    let m_4_36 = minus_s1_2;
    let m_5_35 = s1_2;
    let m_5_36 = minus_c1;
    let m_6_1 = I1;
    let m_6_31 = S::int(1);
    let m_7_2 = -x_L2_1_4;
    let m_7_22 = S::int(1);
    let m_7_27 = minus_c2;
    let m_7_29 = minus_s2_2;
    let m_8_1 = -x_L2_2_3;
    let m_8_23 = S::int(1);
    let m_8_27 = s2_2;
    let m_8_29 = minus_c2;
    let m_9_1 = -x_L2_3_3;
    let m_9_24 = S::int(1);
    let m_9_28 = S::int(1);
    let m_10_23 = z2;
    let m_10_24 = -y2;
    let m_10_25 = S::int(1);
    let m_10_28 = -x_L1_in_L2_1;
    let m_10_29 = -a_C2_1_2;
    let m_10_30 = minus_c2;
    let m_10_31 = minus_s2_2;
    let m_11_22 = -z2;
    let m_11_24 = x2;
    let m_11_26 = S::int(1);
    let m_11_30 = s2_2;
    let m_11_31 = minus_c2;
    let m_12_2 = Izz2;
    let m_12_22 = y2;
    let m_12_23 = -x2;
    let m_12_27 = -x_L2_in_L1_2;
    let m_13_2 = -x_L3_1_4;
    let m_13_3 = -x_L3_1_5;
    let m_13_17 = S::int(1);
    let m_13_22 = minus_c3;
    let m_13_23 = minus_s3_2;
    let m_14_1 = -x_L3_2_3;
    let m_14_18 = S::int(1);
    let m_14_24 = S::int(1);
    let m_15_19 = S::int(1);
    let m_15_22 = s3_2;
    let m_15_23 = minus_c3;
    let m_16_18 = -x_L3_3_6;
    let m_16_19 = -y3;
    let m_16_20 = S::int(1);
    let m_16_23 = -x_L2_in_J3_1_2;
    let m_16_25 = minus_c3;
    let m_16_26 = minus_s3_2;
    let m_17_2 = minus_iyy3;
    let m_17_3 = minus_iyy3;
    let m_17_19 = x3;
    let m_17_21 = S::int(1);
    let m_17_23 = -x_J3_in_L2_1;
    let m_18_1 = -x_L3_3_7;
    let m_18_17 = y3;
    let m_18_18 = -x3;
    let m_18_24 = -x_L2_in_J3_2;
    let m_18_25 = s3_2;
    let m_18_26 = minus_c3;
    let m_19_1 = -x_L4_1_3;
    let m_19_2 = -x_L4_1_4;
    let m_19_3 = -x_L4_1_5;
    let m_19_12 = S::int(1);
    let m_19_17 = minus_c4;
    let m_19_18 = minus_s4_2;
    let m_20_1 = -x_L4_2_3;
    let m_20_13 = S::int(1);
    let m_20_19 = -S::int(1);
    let m_21_2 = -x_L4_3_4;
    let m_21_3 = -x_L4_3_5;
    let m_21_14 = S::int(1);
    let m_21_17 = minus_s4_2;
    let m_21_18 = c4;
    let m_22_2 = minus_x_l4_1_7;
    let m_22_3 = minus_x_l4_1_7;
    let m_22_14 = -y4;
    let m_22_15 = S::int(1);
    let m_22_20 = minus_c4;
    let m_22_21 = minus_s4_2;
    let m_23_1 = -x_L4_2_6;
    let m_23_4 = Iyy4;
    let m_23_16 = S::int(1);
    let m_24_12 = y4;
    let m_24_20 = minus_s4_2;
    let m_24_21 = c4;
    let m_25_1 = -x_L4_in_J5_1_2;
    let m_25_2 = -x_L4_in_J5_1_3;
    let m_25_3 = -x_L4_in_J5_1_4;
    let m_25_7 = S::int(1);
    let m_25_12 = minus_c5;
    let m_25_13 = minus_s5;
    let m_26_8 = S::int(1);
    let m_26_14 = S::int(1);
    let m_27_9 = S::int(1);
    let m_27_12 = s5;
    let m_27_13 = minus_c5;
    let m_28_2 = minus_x_l5_1_3;
    let m_28_3 = minus_x_l5_1_3;
    let m_28_8 = -z6;
    let m_28_10 = S::int(1);
    let m_28_15 = minus_c5;
    let m_28_16 = minus_s5;
    let m_29_1 = -x_L5_2_2;
    let m_29_2 = minus_x_l5_2_3;
    let m_29_3 = minus_x_l5_2_3;
    let m_29_5 = -Iyy5;
    let m_29_7 = z6;
    let m_29_11 = S::int(1);
    let m_30_1 = -x_L5_3_2;
    let m_30_15 = s5;
    let m_30_16 = minus_c5;
    let m_31_1 = -x_L6_1_3;
    let m_31_4 = -x_L6_1_6;
    let m_31_5 = -x_L6_1_7;
    let m_31_7 = minus_c6;
    let m_31_8 = minus_s6_2;
    let m_32_1 = -x_L6_2_3;
    let m_32_4 = -x_L6_2_6;
    let m_32_7 = s6_2;
    let m_32_8 = minus_c6;
    let m_33_9 = -S::int(1);
    let m_34_2 = minus_x_l6_1_9;
    let m_34_3 = minus_x_l6_1_9;
    let m_34_5 = -x_L6_1_11;
    let m_34_10 = minus_c6;
    let m_34_11 = minus_s6_2;
    let m_35_1 = -x_L6_2_8;
    let m_35_4 = -x_L6_2_10;
    let m_35_5 = -x_L6_2_11;
    let m_35_10 = s6_2;
    let m_35_11 = minus_c6;
    let m_36_1 = -x_L6_3_6;
    let m_36_6 = Izz6;
    let zero = S::int(0);
    [
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_1_27, zero,
            zero, zero, zero, m_1_32, m_1_33, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_2_28,
            zero, zero, zero, m_2_32, m_2_33, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            m_3_29, zero, zero, zero, zero, m_3_34, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, m_4_30, zero, zero, zero, zero, m_4_35, m_4_36,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, m_5_35, m_5_36,
        ],
        [
            m_6_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, m_6_31, zero, zero, zero, zero, zero,
        ],
        [
            x_L2_1_3, m_7_2, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, m_7_22, zero, zero, zero, zero, m_7_27, zero,
            m_7_29, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_8_1, x_L2_2_4, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, m_8_23, zero, zero, zero, m_8_27, zero,
            m_8_29, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_9_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, m_9_24, zero, zero, zero, m_9_28,
            zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            x_L2_1_5, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, m_10_23, m_10_24, m_10_25, zero,
            a_C2_2_2, m_10_28, m_10_29, m_10_30, m_10_31, zero, zero, zero, zero, zero,
        ],
        [
            x_L2_2_5, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, m_11_22, zero, m_11_24, zero, m_11_26,
            a_C2_1_2, x_L1_in_L2_2, a_C2_2_2, m_11_30, m_11_31, zero, zero, zero, zero, zero,
        ],
        [
            zero, m_12_2, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, m_12_22, m_12_23, zero, zero, zero, m_12_27,
            zero, x_L2_in_L1_1, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            x_L3_1_3, m_13_2, m_13_3, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, m_13_17, zero, zero, zero, zero, m_13_22, m_13_23, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_14_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, m_14_18, zero, zero, zero, zero, zero, m_14_24, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            x_L3_3_3, x_L3_3_4, x_L3_3_5, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, m_15_19, zero, zero, m_15_22, m_15_23, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            x_L3_1_6, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, m_16_18, m_16_19, m_16_20, zero, x_L2_in_J3_1, m_16_23,
            x_L2_in_J3_1_3, m_16_25, m_16_26, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero,
        ],
        [
            zero, m_17_2, m_17_3, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, x_L3_3_6, zero, m_17_19, zero, m_17_21, x_J3_in_L2_2, m_17_23, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_18_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, m_18_17, m_18_18, zero, zero, zero, x_L2_in_J3_1_2, x_L2_in_J3_1, m_18_24,
            m_18_25, m_18_26, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_19_1, m_19_2, m_19_3, zero, zero, zero, zero, zero, zero, zero, zero, m_19_12, zero,
            zero, zero, zero, m_19_17, m_19_18, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_20_1, x_L4_2_4, x_L4_2_5, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            m_20_13, zero, zero, zero, zero, zero, m_20_19, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            x_L4_3_3, m_21_2, m_21_3, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            m_21_14, zero, zero, m_21_17, m_21_18, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            x_L4_1_6, m_22_2, m_22_3, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            m_22_14, m_22_15, zero, zero, zero, zero, m_22_20, m_22_21, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_23_1, zero, zero, m_23_4, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, m_23_16, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            x_L4_3_6, x_L4_3_7, x_L4_3_7, zero, zero, zero, zero, zero, zero, zero, zero, m_24_12,
            zero, zero, zero, zero, zero, zero, zero, m_24_20, m_24_21, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_25_1, m_25_2, m_25_3, zero, zero, zero, m_25_7, zero, zero, zero, zero, m_25_12,
            m_25_13, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            x_L3_in_J4_2_2, x_L3_in_J4_2_3, x_L3_in_J4_2_4, zero, zero, zero, zero, m_26_8, zero,
            zero, zero, zero, zero, m_26_14, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            x_L4_in_J5_2_2, x_L4_in_J5_2_3, x_L4_in_J5_2_4, zero, zero, zero, zero, zero, m_27_9,
            zero, zero, m_27_12, m_27_13, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            x_L5_1_2, m_28_2, m_28_3, x_L5_1_4, zero, zero, zero, m_28_8, zero, m_28_10, zero, zero,
            zero, zero, m_28_15, m_28_16, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_29_1, m_29_2, m_29_3, zero, m_29_5, zero, m_29_7, zero, zero, zero, m_29_11, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_30_1, x_L5_3_3, x_L5_3_3, x_L5_3_4, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, m_30_15, m_30_16, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_31_1, x_L6_1_4, x_L6_1_5, m_31_4, m_31_5, zero, m_31_7, m_31_8, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_32_1, x_L6_2_4, x_L6_2_5, m_32_4, x_L6_2_7, zero, m_32_7, m_32_8, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            x_L6_3_3, x_L6_3_4, x_L6_3_5, zero, zero, zero, zero, zero, m_33_9, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            x_L6_1_8, m_34_2, m_34_3, x_L6_1_10, m_34_5, zero, zero, zero, zero, m_34_10, m_34_11,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_35_1, x_L6_2_9, x_L6_2_9, m_35_4, m_35_5, zero, zero, zero, zero, m_35_10, m_35_11,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
        [
            m_36_1, x_L6_3_7, x_L6_3_7, x_L6_3_8, zero, m_36_6, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
        ],
    ]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5', u6', flange_force_l51, flange_force_l52, flange_force_l53, flange_torque_l51, flange_torque_l52, wrist2_force_l41, wrist2_force_l42, wrist2_force_l43, wrist2_torque_l41, wrist2_torque_l42, wrist1_force_l31, wrist1_force_l32, wrist1_force_l33, wrist1_torque_l31, wrist1_torque_l32, forearm_force_l21, forearm_force_l22, forearm_force_l23, forearm_torque_l21, forearm_torque_l22, upper_arm_force_j11, upper_arm_force_j12, upper_arm_force_j13, upper_arm_torque_j11, upper_arm_torque_j13, column_force_n1, column_force_n2, column_force_n3, column_torque_n1, column_torque_n2).
///
/// 331 operations, 5 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 6], u: &[S; 6]) -> [S; 36] {
    let Parameters {
        g, a2, a3, d3, d4, m1, m2, m3, m4, m5, m6, x2, y2, z2, x3, y3, z3, y4, z6, Ixx2, Iyy2, Izz2,
        Ixx3, Iyy3, Izz3, Ixx4, Iyy4, Ixx5, Iyy5, Ixx6, Izz6, tau1, tau2, tau3, tau4, tau5, tau6,
        ..
    } = *p;
    let [_, q2, q3, q4, q5, q6] = *q;
    let [u1, u2, u3, u4, u5, u6] = *u;
    // Sines and cosines.
    let (s2_2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    let (s4_2, c4) = q4.sin_cos();
    let (s5, c5) = q5.sin_cos();
    let (s6_2, c6) = q6.sin_cos();
    // Step by step, each after the terms that it needs.
    let x_N_in_J1_3 = g * m1;
    let w_L1_in_L2_1 = u1 * s2_2;
    let w_L1_in_L2_2 = u1 * c2;
    let w_L2_12 = w_L1_in_L2_1 * w_L1_in_L2_2;
    let w_L2_22 = w_L1_in_L2_2 * w_L1_in_L2_2;
    let w_L2_33 = u2 * u2;
    let turn_L2_11 = w_L2_22 + w_L2_33;
    let a_L1_in_L2_1 = g * s2_2;
    let a2_plus_x2 = a2 + x2;
    let a_C2_1 = (-y2).mul_add(w_L2_12, turn_L2_11 * a2_plus_x2) - a_L1_in_L2_1;
    let x_L2_1 = m2 * a_C2_1;
    let w_L2_11 = w_L1_in_L2_1 * w_L1_in_L2_1;
    let turn_L2_22 = w_L2_33 + w_L2_11;
    let a_L1_in_L2_2 = g * c2;
    let a_C2_2 = y2.mul_add(turn_L2_22, -a_L1_in_L2_2) - w_L2_12 * a2_plus_x2;
    let x_L2_2 = m2 * a_C2_2;
    let w_L2_13 = u2 * w_L1_in_L2_1;
    let w_L2_23 = u2 * w_L1_in_L2_2;
    let turn_L2_33 = w_L2_22 + w_L2_11;
    let a_C2_3_of_place = w_L2_13.mul_add(a2_plus_x2, y2 * w_L2_23);
    let a_C2_3 = (-a_C2_3_of_place).mul_add(S::int(2), z2 * turn_L2_33);
    let x_L2_3 = m2 * a_C2_3;
    let H_upper_arm_2 = Iyy2 * w_L1_in_L2_2;
    let H_upper_arm_3 = Izz2 * u2;
    let x_L2_1_2 = (-u2).mul_add(H_upper_arm_2, Ixx2 * w_L2_23) + w_L1_in_L2_2 * H_upper_arm_3;
    let H_upper_arm_1 = Ixx2 * w_L1_in_L2_1;
    let x_L2_2_2 = (-Iyy2).mul_add(w_L2_13, u2 * H_upper_arm_1) - w_L1_in_L2_1 * H_upper_arm_3;
    let x_L2_3_2 = (-w_L1_in_L2_1).mul_add(H_upper_arm_2, tau2 - tau3)
        + w_L1_in_L2_2 * H_upper_arm_1;
    let w_L2_in_J3_1 = w_L1_in_L2_2.mul_add(s3_2, w_L1_in_L2_1 * c3);
    let w_L2_in_J3_2 = (-w_L1_in_L2_2).mul_add(c3, w_L1_in_L2_1 * s3_2);
    let w_J3_3 = u2 + u3;
    let w_J3_12 = w_L2_in_J3_1 * w_L2_in_J3_2;
    let w_J3_13 = w_L2_in_J3_1 * w_J3_3;
    let w_J3_22 = w_L2_in_J3_2 * w_L2_in_J3_2;
    let w_J3_33 = w_J3_3 * w_J3_3;
    let turn_J3_11 = w_J3_22 + w_J3_33;
    let a_C3_1 = a2.mul_add(turn_L2_11, -a_L1_in_L2_1);
    let alpha_L2_in_J3_2 = w_L2_23.mul_add(s3_2, w_L2_13 * c3);
    let alpha_J3_2 = u3.mul_add(w_L2_in_J3_1, alpha_L2_in_J3_2);
    let turn_J3_13 = w_J3_13 - alpha_J3_2;
    let a_C3_2 = a2.mul_add(w_L2_12, a_L1_in_L2_2);
    let a_L2_in_J3_1 = (-a_C3_2).mul_add(s3_2, a_C3_1 * c3);
    let a_C3_1_2 = (-d3).mul_add(turn_J3_13, a3 * turn_J3_11) + a_L2_in_J3_1;
    let a_C3_1_3 = x3.mul_add(turn_J3_11, z3 * w_J3_12) + y3 * turn_J3_13 + a_C3_1_2;
    let x_L3_1 = m3 * a_C3_1_3;
    let w_J3_11 = w_L2_in_J3_1 * w_L2_in_J3_1;
    let w_J3_23 = w_L2_in_J3_2 * w_J3_3;
    let turn_J3_33 = w_J3_22 + w_J3_11;
    let alpha_L2_in_J3_1 = (-w_L2_13).mul_add(s3_2, w_L2_23 * c3);
    let alpha_J3_1 = u3.mul_add(w_L2_in_J3_2, -alpha_L2_in_J3_1);
    let turn_J3_31 = w_J3_13 + alpha_J3_2;
    let turn_J3_32 = w_J3_23 + alpha_J3_1;
    let a_C3_3 = a2 * w_L2_13;
    let a_C3_3_2 = (-a3).mul_add(turn_J3_31, d3 * turn_J3_33) - S::int(2) * a_C3_3;
    let a_C3_2_2 = x3.mul_add(turn_J3_31, y3 * turn_J3_33) - z3 * turn_J3_32 - a_C3_3_2;
    let x_L3_2 = m3 * a_C3_2_2;
    let turn_J3_22 = w_J3_33 + w_J3_11;
    let turn_J3_23 = w_J3_23 - alpha_J3_1;
    let a_L2_in_J3_2 = a_C3_2.mul_add(c3, a_C3_1 * s3_2);
    let a_C3_2_3 = d3.mul_add(turn_J3_23, a3 * w_J3_12) - a_L2_in_J3_2;
    let a_C3_3_3 = z3.mul_add(turn_J3_22, x3 * w_J3_12) - y3 * turn_J3_23 + a_C3_2_3;
    let x_L3_3 = m3 * a_C3_3_3;
    let H_forearm_2 = Iyy3 * w_J3_3;
    let H_forearm_3 = Izz3 * w_L2_in_J3_2;
    let x_L3_1_2 = (-Ixx3).mul_add(alpha_J3_1, w_J3_3 * H_forearm_3) - w_L2_in_J3_2 * H_forearm_2;
    let H_forearm_1 = Ixx3 * w_L2_in_J3_1;
    let x_L3_2_2 = w_L2_in_J3_1.mul_add(H_forearm_3, tau3) - w_L2_in_J3_2 * H_forearm_1;
    let x_L3_3_2 = (-Izz3).mul_add(alpha_J3_2, tau4) - w_L2_in_J3_1 * H_forearm_2
        + w_J3_3 * H_forearm_1;
    let w_L3_in_J4_1 = (-w_J3_3).mul_add(s4_2, w_L2_in_J3_1 * c4);
    let w_J4_3 = u4 - w_L2_in_J3_2;
    let w_L4_12 = w_L3_in_J4_1 * w_J4_3;
    let alpha_L3_in_J4_2 = alpha_J3_1 * s4_2;
    let alpha_L4_2 = u4.mul_add(w_L3_in_J4_1, -alpha_L3_in_J4_2);
    let turn_L4_12 = w_L4_12 - alpha_L4_2;
    let a_C4_1 = d4.mul_add(w_J3_12, a_C3_1_2);
    let a_C4_2 = d4.mul_add(turn_J3_32, a_C3_3_2);
    let a_L3_in_J4_1 = (-a_C4_2).mul_add(s4_2, a_C4_1 * c4);
    let a_C4_1_2 = y4.mul_add(turn_L4_12, -a_L3_in_J4_1);
    let x_L4_1 = m4 * a_C4_1_2;
    let w_L3_in_J4_2 = w_J3_3.mul_add(c4, w_L2_in_J3_1 * s4_2);
    let w_L4_11 = w_L3_in_J4_1 * w_L3_in_J4_1;
    let w_L4_33 = w_L3_in_J4_2 * w_L3_in_J4_2;
    let turn_L4_22 = w_L4_11 + w_L4_33;
    let a_C4_3 = d4.mul_add(turn_J3_22, a_C3_2_3);
    let a_C4_2_2 = y4.mul_add(turn_L4_22, a_C4_3);
    let x_L4_2 = m4 * a_C4_2_2;
    let w_L4_23 = w_J4_3 * w_L3_in_J4_2;
    let alpha_L3_in_J4_1 = alpha_J3_1 * c4;
    let alpha_L4_1 = u4.mul_add(w_L3_in_J4_2, alpha_L3_in_J4_1);
    let turn_L4_32 = w_L4_23 - alpha_L4_1;
    let a_L3_in_J4_2 = a_C4_2.mul_add(c4, a_C4_1 * s4_2);
    let a_C4_3_2 = y4.mul_add(turn_L4_32, -a_L3_in_J4_2);
    let x_L4_3 = m4 * a_C4_3_2;
    let H_wrist1_2 = Iyy4 * w_J4_3;
    let H_wrist1_3 = Ixx4 * w_L3_in_J4_2;
    let x_L4_1_2 = (-Ixx4).mul_add(alpha_L4_1, w_J4_3 * H_wrist1_3) - w_L3_in_J4_2 * H_wrist1_2;
    let H_wrist1_1 = Ixx4 * w_L3_in_J4_1;
    let x_L4_2_2 = Iyy4.mul_add(alpha_J3_2, tau4) + w_L3_in_J4_1 * H_wrist1_3
        - w_L3_in_J4_2 * H_wrist1_1;
    let x_L4_3_2 = Ixx4.mul_add(alpha_L4_2, tau5) + w_L3_in_J4_1 * H_wrist1_2 - w_J4_3 * H_wrist1_1;
    let x_L3_in_J4_1 = m5 * a_L3_in_J4_1;
    let x_L3_in_J4_3 = m5 * a_C4_3;
    let x_L4_in_J5_1 = x_L3_in_J4_3.mul_add(s5, x_L3_in_J4_1 * c5);
    let x_L3_in_J4_2 = m5 * a_L3_in_J4_2;
    let x_L4_in_J5_2 = (-x_L3_in_J4_3).mul_add(c5, x_L3_in_J4_1 * s5);
    let w_L4_in_J5_2 = (-w_J4_3).mul_add(c5, w_L3_in_J4_1 * s5);
    let w_J5_3 = u5 + w_L3_in_J4_2;
    let H_wrist2_2 = Iyy5 * w_J5_3;
    let H_wrist2_3 = Ixx5 * w_L4_in_J5_2;
    let alpha_L4_in_J5_1 = alpha_L4_1.mul_add(c5, alpha_J3_2 * s5);
    let alpha_L6_1 = u5.mul_add(w_L4_in_J5_2, alpha_L4_in_J5_1);
    let x_L5_1 = (-w_L4_in_J5_2).mul_add(H_wrist2_2, w_J5_3 * H_wrist2_3) - Ixx5 * alpha_L6_1;
    let w_L4_in_J5_1 = w_J4_3.mul_add(s5, w_L3_in_J4_1 * c5);
    let H_wrist2_1 = Ixx5 * w_L4_in_J5_1;
    let x_L5_2 = (-Iyy5).mul_add(alpha_L4_2, tau5) + H_wrist2_3 * w_L4_in_J5_1
        - w_L4_in_J5_2 * H_wrist2_1;
    let alpha_L4_in_J5_2 = (-alpha_J3_2).mul_add(c5, alpha_L4_1 * s5);
    let alpha_L6_2 = u5.mul_add(w_L4_in_J5_1, -alpha_L4_in_J5_2);
    let x_L5_3 = (-H_wrist2_2).mul_add(w_L4_in_J5_1, tau6) + w_J5_3 * H_wrist2_1
        - Ixx5 * alpha_L6_2;
    let w_L5_in_L6_1 = (-w_J5_3).mul_add(s6_2, w_L4_in_J5_1 * c6);
    let w_L6_3 = u6 - w_L4_in_J5_2;
    let w_L6_13 = w_L5_in_L6_1 * w_L6_3;
    let alpha_L5_in_L6_2 = (-alpha_L4_2).mul_add(c6, alpha_L6_1 * s6_2);
    let alpha_L6_2_2 = u6.mul_add(w_L5_in_L6_1, -alpha_L5_in_L6_2);
    let turn_L6_13 = w_L6_13 - alpha_L6_2_2;
    let a_L4_in_J5_1 = a_C4_3.mul_add(s5, a_L3_in_J4_1 * c5);
    let a_L5_in_L6_1 = (-a_L3_in_J4_2).mul_add(s6_2, a_L4_in_J5_1 * c6);
    let a_C6_1 = z6.mul_add(turn_L6_13, -a_L5_in_L6_1);
    let x_L6_1 = m6 * a_C6_1;
    let w_L5_in_L6_2 = w_L4_in_J5_1.mul_add(s6_2, w_J5_3 * c6);
    let w_L6_23 = w_L6_3 * w_L5_in_L6_2;
    let alpha_L5_in_L6_1 = alpha_L6_1.mul_add(c6, alpha_L4_2 * s6_2);
    let alpha_L6_1_2 = u6.mul_add(w_L5_in_L6_2, alpha_L5_in_L6_1);
    let turn_L6_23 = w_L6_23 - alpha_L6_1_2;
    let a_L5_in_L6_2 = a_L4_in_J5_1.mul_add(s6_2, a_L3_in_J4_2 * c6);
    let a_C6_2 = z6.mul_add(turn_L6_23, -a_L5_in_L6_2);
    let x_L6_2 = m6 * a_C6_2;
    let w_L6_11 = w_L5_in_L6_1 * w_L5_in_L6_1;
    let w_L6_22 = w_L5_in_L6_2 * w_L5_in_L6_2;
    let turn_L6_33 = w_L6_11 + w_L6_22;
    let a_L4_in_J5_2 = (-a_C4_3).mul_add(c5, a_L3_in_J4_1 * s5);
    let a_C6_3 = z6.mul_add(turn_L6_33, -a_L4_in_J5_2);
    let x_L6_3 = m6 * a_C6_3;
    let H_flange_2 = Ixx6 * w_L5_in_L6_2;
    let H_flange_3 = Izz6 * w_L6_3;
    let x_L6_1_2 = (-w_L6_3).mul_add(H_flange_2, Ixx6 * alpha_L6_1_2) + w_L5_in_L6_2 * H_flange_3;
    let H_flange_1 = Ixx6 * w_L5_in_L6_1;
    let x_L6_2_2 = (-Ixx6).mul_add(alpha_L6_2_2, w_L6_3 * H_flange_1) - w_L5_in_L6_1 * H_flange_3;
    let x_L6_3_2 = Izz6.mul_add(alpha_L6_2, tau6) + w_L5_in_L6_1 * H_flange_2
        - w_L5_in_L6_2 * H_flange_1;
    // Values.
    let f_3 = -x_N_in_J1_3;
    let f_5 = tau2;
    let f_6 = tau1;
    let f_10 = -x_L2_1_2;
    let f_11 = -x_L2_2_2;
    let f_16 = -x_L3_1_2;
    let f_17 = -x_L3_2_2;
    let f_18 = -x_L3_3_2;
    let f_19 = -x_L4_1;
    let f_21 = -x_L4_3;
    let f_22 = -x_L4_1_2;
    let f_24 = -x_L4_3_2;
    let f_26 = -x_L3_in_J4_2;
    let f_27 = -x_L4_in_J5_2;
    let f_28 = -x_L5_1;
    let f_29 = -x_L5_2;
    let f_30 = -x_L5_3;
    let f_31 = -x_L6_1;
    let f_35 = -x_L6_2_2;
    let zero = S::int(0);
    [
        zero, zero, f_3, zero, f_5, f_6, x_L2_1, x_L2_2, x_L2_3, f_10, f_11, x_L2_3_2, x_L3_1,
        x_L3_2, x_L3_3, f_16, f_17, f_18, f_19, x_L4_2, f_21, f_22, x_L4_2_2, f_24, x_L4_in_J5_1,
        f_26, f_27, f_28, f_29, f_30, f_31, x_L6_2, x_L6_3, x_L6_1_2, f_35, x_L6_3_2,
    ]
}

/// The accelerations (u1', u2', u3', u4', u5', u6'), solved for when this code was generated.
///
/// 1050 operations, 5 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 6], u: &[S; 6]) -> [S; 6] {
    let Parameters {
        g, a2, a3, d3, d4, m2, m3, m4, m5, m6, x2, y2, z2, x3, y3, z3, y4, z6, I1, Ixx2, Iyy2, Izz2,
        Ixx3, Iyy3, Izz3, Ixx4, Iyy4, Ixx5, Iyy5, Ixx6, Izz6, tau1, tau2, tau3, tau4, tau5, tau6,
        ..
    } = *p;
    let [_, q2, q3, q4, q5, q6] = *q;
    let [u1, u2, u3, u4, u5, u6] = *u;
    // Sines and cosines.
    let (s2_2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    let (s4_2, c4) = q4.sin_cos();
    let (s5, c5) = q5.sin_cos();
    let (s6_2, c6) = q6.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_L1_in_L2_1 = u1 * s2_2;
    let w_L1_in_L2_2 = u1 * c2;
    let w_L2_12 = w_L1_in_L2_1 * w_L1_in_L2_2;
    let w_L2_22 = w_L1_in_L2_2 * w_L1_in_L2_2;
    let w_L2_33 = u2 * u2;
    let turn_L2_11 = w_L2_22 + w_L2_33;
    let a_L1_in_L2_1 = g * s2_2;
    let a_C2_2_3 = a2 + x2;
    let a_C2_1 = (-y2).mul_add(w_L2_12, turn_L2_11 * a_C2_2_3) - a_L1_in_L2_1;
    let x_L2_1 = m2 * a_C2_1;
    let w_L2_11 = w_L1_in_L2_1 * w_L1_in_L2_1;
    let turn_L2_22 = w_L2_33 + w_L2_11;
    let a_L1_in_L2_2 = g * c2;
    let a_C2_2 = y2.mul_add(turn_L2_22, -a_L1_in_L2_2) - w_L2_12 * a_C2_2_3;
    let x_L2_2 = m2 * a_C2_2;
    let w_L2_13 = u2 * w_L1_in_L2_1;
    let w_L2_23 = u2 * w_L1_in_L2_2;
    let turn_L2_33 = w_L2_22 + w_L2_11;
    let a_C2_3_of_place = w_L2_13.mul_add(a_C2_2_3, y2 * w_L2_23);
    let a_C2_3 = (-a_C2_3_of_place).mul_add(S::int(2), z2 * turn_L2_33);
    let x_L2_3 = m2 * a_C2_3;
    let H_upper_arm_2 = Iyy2 * w_L1_in_L2_2;
    let H_upper_arm_3 = Izz2 * u2;
    let x_L2_1_2 = (-u2).mul_add(H_upper_arm_2, Ixx2 * w_L2_23) + w_L1_in_L2_2 * H_upper_arm_3;
    let H_upper_arm_1 = Ixx2 * w_L1_in_L2_1;
    let x_L2_2_2 = (-Iyy2).mul_add(w_L2_13, u2 * H_upper_arm_1) - w_L1_in_L2_1 * H_upper_arm_3;
    let x_L2_3_2 = (-w_L1_in_L2_1).mul_add(H_upper_arm_2, tau2 - tau3)
        + w_L1_in_L2_2 * H_upper_arm_1;
    let w_L2_in_J3_1 = w_L1_in_L2_2.mul_add(s3_2, w_L1_in_L2_1 * c3);
    let w_L2_in_J3_2 = (-w_L1_in_L2_2).mul_add(c3, w_L1_in_L2_1 * s3_2);
    let w_J3_3 = u2 + u3;
    let w_J3_12 = w_L2_in_J3_1 * w_L2_in_J3_2;
    let w_J3_13 = w_L2_in_J3_1 * w_J3_3;
    let w_J3_22 = w_L2_in_J3_2 * w_L2_in_J3_2;
    let w_J3_33 = w_J3_3 * w_J3_3;
    let turn_J3_11 = w_J3_22 + w_J3_33;
    let a_C3_1 = a2.mul_add(turn_L2_11, -a_L1_in_L2_1);
    let alpha_L2_in_J3_2 = w_L2_23.mul_add(s3_2, w_L2_13 * c3);
    let alpha_J3_2 = u3.mul_add(w_L2_in_J3_1, alpha_L2_in_J3_2);
    let turn_J3_13 = w_J3_13 - alpha_J3_2;
    let a_C3_2 = a2.mul_add(w_L2_12, a_L1_in_L2_2);
    let a_L2_in_J3_1 = (-a_C3_2).mul_add(s3_2, a_C3_1 * c3);
    let a_C3_1_2 = (-d3).mul_add(turn_J3_13, a3 * turn_J3_11) + a_L2_in_J3_1;
    let a_C3_1_3 = x3.mul_add(turn_J3_11, z3 * w_J3_12) + y3 * turn_J3_13 + a_C3_1_2;
    let x_L3_1 = m3 * a_C3_1_3;
    let w_J3_11 = w_L2_in_J3_1 * w_L2_in_J3_1;
    let w_J3_23 = w_L2_in_J3_2 * w_J3_3;
    let turn_J3_33 = w_J3_22 + w_J3_11;
    let alpha_L2_in_J3_1 = (-w_L2_13).mul_add(s3_2, w_L2_23 * c3);
    let alpha_J3_1 = u3.mul_add(w_L2_in_J3_2, -alpha_L2_in_J3_1);
    let turn_J3_31 = w_J3_13 + alpha_J3_2;
    let turn_J3_32 = w_J3_23 + alpha_J3_1;
    let a_C3_3 = a2 * w_L2_13;
    let a_C3_3_2 = (-a3).mul_add(turn_J3_31, d3 * turn_J3_33) - S::int(2) * a_C3_3;
    let a_C3_2_2 = x3.mul_add(turn_J3_31, y3 * turn_J3_33) - z3 * turn_J3_32 - a_C3_3_2;
    let x_L3_2 = m3 * a_C3_2_2;
    let turn_J3_22 = w_J3_33 + w_J3_11;
    let turn_J3_23 = w_J3_23 - alpha_J3_1;
    let a_L2_in_J3_2 = a_C3_2.mul_add(c3, a_C3_1 * s3_2);
    let a_C3_2_3 = d3.mul_add(turn_J3_23, a3 * w_J3_12) - a_L2_in_J3_2;
    let a_C3_3_3 = z3.mul_add(turn_J3_22, x3 * w_J3_12) - y3 * turn_J3_23 + a_C3_2_3;
    let x_L3_3 = m3 * a_C3_3_3;
    let H_forearm_2 = Iyy3 * w_J3_3;
    let H_forearm_3 = Izz3 * w_L2_in_J3_2;
    let x_L3_1_2 = (-Ixx3).mul_add(alpha_J3_1, w_J3_3 * H_forearm_3) - w_L2_in_J3_2 * H_forearm_2;
    let H_forearm_1 = Ixx3 * w_L2_in_J3_1;
    let x_L3_2_2 = w_L2_in_J3_1.mul_add(H_forearm_3, tau3) - w_L2_in_J3_2 * H_forearm_1;
    let x_L3_3_2 = (-Izz3).mul_add(alpha_J3_2, tau4) - w_L2_in_J3_1 * H_forearm_2
        + w_J3_3 * H_forearm_1;
    let w_L3_in_J4_1 = (-w_J3_3).mul_add(s4_2, w_L2_in_J3_1 * c4);
    let w_J4_3 = u4 - w_L2_in_J3_2;
    let w_L4_12 = w_L3_in_J4_1 * w_J4_3;
    let alpha_L3_in_J4_2 = alpha_J3_1 * s4_2;
    let alpha_L4_2 = u4.mul_add(w_L3_in_J4_1, -alpha_L3_in_J4_2);
    let turn_L4_12 = w_L4_12 - alpha_L4_2;
    let a_C4_1 = d4.mul_add(w_J3_12, a_C3_1_2);
    let a_C4_2 = d4.mul_add(turn_J3_32, a_C3_3_2);
    let a_L3_in_J4_1 = (-a_C4_2).mul_add(s4_2, a_C4_1 * c4);
    let a_C4_1_2 = y4.mul_add(turn_L4_12, -a_L3_in_J4_1);
    let x_L4_1 = m4 * a_C4_1_2;
    let w_L3_in_J4_2 = w_J3_3.mul_add(c4, w_L2_in_J3_1 * s4_2);
    let w_L4_11 = w_L3_in_J4_1 * w_L3_in_J4_1;
    let w_L4_33 = w_L3_in_J4_2 * w_L3_in_J4_2;
    let turn_L4_22 = w_L4_11 + w_L4_33;
    let a_C4_3 = d4.mul_add(turn_J3_22, a_C3_2_3);
    let a_C4_2_2 = y4.mul_add(turn_L4_22, a_C4_3);
    let x_L4_2 = m4 * a_C4_2_2;
    let w_L4_23 = w_J4_3 * w_L3_in_J4_2;
    let alpha_L3_in_J4_1 = alpha_J3_1 * c4;
    let alpha_L4_1 = u4.mul_add(w_L3_in_J4_2, alpha_L3_in_J4_1);
    let turn_L4_32 = w_L4_23 - alpha_L4_1;
    let a_L3_in_J4_2 = a_C4_2.mul_add(c4, a_C4_1 * s4_2);
    let a_C4_3_2 = y4.mul_add(turn_L4_32, -a_L3_in_J4_2);
    let x_L4_3 = m4 * a_C4_3_2;
    let H_wrist1_2 = Iyy4 * w_J4_3;
    let H_wrist1_3 = Ixx4 * w_L3_in_J4_2;
    let x_L4_1_2 = (-Ixx4).mul_add(alpha_L4_1, w_J4_3 * H_wrist1_3) - w_L3_in_J4_2 * H_wrist1_2;
    let H_wrist1_1 = Ixx4 * w_L3_in_J4_1;
    let x_L4_2_2 = Iyy4.mul_add(alpha_J3_2, tau4) + w_L3_in_J4_1 * H_wrist1_3
        - w_L3_in_J4_2 * H_wrist1_1;
    let x_L4_3_2 = Ixx4.mul_add(alpha_L4_2, tau5) + w_L3_in_J4_1 * H_wrist1_2 - w_J4_3 * H_wrist1_1;
    let m5_c4 = m5 * c4;
    let m5_s4_2 = m5 * s4_2;
    let x_L3_in_J4_1 = (-a_C4_2).mul_add(m5_s4_2, a_C4_1 * m5_c4);
    let x_L3_in_J4_3 = m5 * a_C4_3;
    let x_L4_in_J5_1 = x_L3_in_J4_3.mul_add(s5, x_L3_in_J4_1 * c5);
    let x_L3_in_J4_2 = a_C4_1.mul_add(m5_s4_2, a_C4_2 * m5_c4);
    let x_L4_in_J5_2 = (-x_L3_in_J4_3).mul_add(c5, x_L3_in_J4_1 * s5);
    let w_L4_in_J5_2 = (-w_J4_3).mul_add(c5, w_L3_in_J4_1 * s5);
    let w_J5_3 = u5 + w_L3_in_J4_2;
    let H_wrist2_2 = Iyy5 * w_J5_3;
    let H_wrist2_3 = Ixx5 * w_L4_in_J5_2;
    let alpha_L4_in_J5_1 = alpha_L4_1.mul_add(c5, alpha_J3_2 * s5);
    let alpha_L6_1 = u5.mul_add(w_L4_in_J5_2, alpha_L4_in_J5_1);
    let x_L5_1 = (-w_L4_in_J5_2).mul_add(H_wrist2_2, w_J5_3 * H_wrist2_3) - Ixx5 * alpha_L6_1;
    let w_L4_in_J5_1 = w_J4_3.mul_add(s5, w_L3_in_J4_1 * c5);
    let H_wrist2_1 = Ixx5 * w_L4_in_J5_1;
    let x_L5_2 = (-Iyy5).mul_add(alpha_L4_2, tau5) + H_wrist2_3 * w_L4_in_J5_1
        - w_L4_in_J5_2 * H_wrist2_1;
    let alpha_L4_in_J5_2 = (-alpha_J3_2).mul_add(c5, alpha_L4_1 * s5);
    let alpha_L6_2 = u5.mul_add(w_L4_in_J5_1, -alpha_L4_in_J5_2);
    let x_L5_3 = (-H_wrist2_2).mul_add(w_L4_in_J5_1, tau6) + w_J5_3 * H_wrist2_1
        - Ixx5 * alpha_L6_2;
    let w_L5_in_L6_1 = (-w_J5_3).mul_add(s6_2, w_L4_in_J5_1 * c6);
    let w_L6_3 = u6 - w_L4_in_J5_2;
    let w_L6_13 = w_L5_in_L6_1 * w_L6_3;
    let alpha_L5_in_L6_2 = (-alpha_L4_2).mul_add(c6, alpha_L6_1 * s6_2);
    let alpha_L6_2_2 = u6.mul_add(w_L5_in_L6_1, -alpha_L5_in_L6_2);
    let turn_L6_13 = w_L6_13 - alpha_L6_2_2;
    let a_L4_in_J5_1 = a_C4_3.mul_add(s5, a_L3_in_J4_1 * c5);
    let a_L5_in_L6_1 = (-a_L3_in_J4_2).mul_add(s6_2, a_L4_in_J5_1 * c6);
    let a_C6_1 = z6.mul_add(turn_L6_13, -a_L5_in_L6_1);
    let x_L6_1 = m6 * a_C6_1;
    let w_L5_in_L6_2 = w_L4_in_J5_1.mul_add(s6_2, w_J5_3 * c6);
    let w_L6_23 = w_L6_3 * w_L5_in_L6_2;
    let alpha_L5_in_L6_1 = alpha_L6_1.mul_add(c6, alpha_L4_2 * s6_2);
    let alpha_L6_1_2 = u6.mul_add(w_L5_in_L6_2, alpha_L5_in_L6_1);
    let turn_L6_23 = w_L6_23 - alpha_L6_1_2;
    let a_L5_in_L6_2 = a_L4_in_J5_1.mul_add(s6_2, a_L3_in_J4_2 * c6);
    let a_C6_2 = z6.mul_add(turn_L6_23, -a_L5_in_L6_2);
    let x_L6_2 = m6 * a_C6_2;
    let w_L6_11 = w_L5_in_L6_1 * w_L5_in_L6_1;
    let w_L6_22 = w_L5_in_L6_2 * w_L5_in_L6_2;
    let turn_L6_33 = w_L6_11 + w_L6_22;
    let a_L4_in_J5_2 = (-a_C4_3).mul_add(c5, a_L3_in_J4_1 * s5);
    let a_C6_3 = z6.mul_add(turn_L6_33, -a_L4_in_J5_2);
    let x_L6_3 = m6 * a_C6_3;
    let H_flange_2 = Ixx6 * w_L5_in_L6_2;
    let H_flange_3 = Izz6 * w_L6_3;
    let x_L6_1_2 = (-w_L6_3).mul_add(H_flange_2, Ixx6 * alpha_L6_1_2) + w_L5_in_L6_2 * H_flange_3;
    let H_flange_1 = Ixx6 * w_L5_in_L6_1;
    let x_L6_2_2 = (-Ixx6).mul_add(alpha_L6_2_2, w_L6_3 * H_flange_1) - w_L5_in_L6_1 * H_flange_3;
    let x_L6_3_2 = Izz6.mul_add(alpha_L6_2, tau6) + w_L5_in_L6_1 * H_flange_2
        - w_L5_in_L6_2 * H_flange_1;
    let a_C2_1_2 = z2 * c2;
    let x_L2_1_3 = m2 * a_C2_1_2;
    let x_L2_1_4 = m2 * y2;
    let a_C2_2_2 = z2 * s2_2;
    let x_L2_2_3 = m2 * a_C2_2_2;
    let x_L2_2_4 = m2 * a_C2_2_3;
    let a_C2_3_2 = (-y2).mul_add(s2_2, a_C2_2_3 * c2);
    let x_L2_3_3 = m2 * a_C2_3_2;
    let x_L2_1_5 = Ixx2 * s2_2;
    let x_L2_2_5 = Iyy2 * c2;
    let alpha_L2_in_J3_2_2 = (-c2).mul_add(c3, s2_2 * s3_2);
    let a_C3_1_4 = d3 * alpha_L2_in_J3_2_2;
    let a_C3_1_5 = y3.mul_add(alpha_L2_in_J3_2_2, -a_C3_1_4);
    let x_L3_1_3 = m3 * a_C3_1_5;
    let a_L2_in_J3_1_2 = a2 * s3_2;
    let a_C3_1_6 = z3 - a_L2_in_J3_1_2;
    let x_L3_1_4 = m3 * a_C3_1_6;
    let x_L3_1_5 = m3 * z3;
    let w_L2_in_J3_1_2 = s2_2.mul_add(c3, c2 * s3_2);
    let a_C3_3_4 = a2 * c2;
    let a_C3_3_5 = a3.mul_add(alpha_L2_in_J3_2_2, -a_C3_3_4);
    let a_C3_2_4 = z3.mul_add(w_L2_in_J3_1_2, x3 * alpha_L2_in_J3_2_2) + a_C3_3_5;
    let x_L3_2_3 = m3 * a_C3_2_4;
    let a_C3_2_5 = d3 * w_L2_in_J3_1_2;
    let a_C3_3_6 = y3.mul_add(w_L2_in_J3_1_2, -a_C3_2_5);
    let x_L3_3_3 = m3 * a_C3_3_6;
    let a_L2_in_J3_2_2 = a2 * c3;
    let a_C3_2_6 = a3 + a_L2_in_J3_2_2;
    let a_C3_3_7 = x3 + a_C3_2_6;
    let x_L3_3_4 = m3 * a_C3_3_7;
    let x_L2_1_6 = a3 + x3;
    let x_L3_3_5 = m3 * x_L2_1_6;
    let x_L3_1_6 = Ixx3 * w_L2_in_J3_1_2;
    let x_L3_3_7 = Izz3 * alpha_L2_in_J3_2_2;
    let alpha_L3_in_J4_2_2 = w_L2_in_J3_1_2 * s4_2;
    let a_C4_2_3 = d4.mul_add(w_L2_in_J3_1_2, a_C3_3_5);
    let a_L3_in_J4_1_2 = a_C4_2_3.mul_add(s4_2, a_C3_1_4 * c4);
    let a_C4_1_3 = y4.mul_add(alpha_L3_in_J4_2_2, a_L3_in_J4_1_2);
    let x_L4_1_3 = m4 * a_C4_1_3;
    let a_C4_1_4 = d4 - a_L2_in_J3_1_2;
    let a_L3_in_J4_1_3 = a_C4_1_4 * c4;
    let y4_c4 = y4 * c4;
    let a_C4_1_5 = a_L3_in_J4_1_3 + y4_c4;
    let x_L4_1_4 = m4 * a_C4_1_5;
    let a_L3_in_J4_1_4 = d4 * c4;
    let a_C4_1_6 = a_L3_in_J4_1_4 + y4_c4;
    let x_L4_1_5 = m4 * a_C4_1_6;
    let x_L4_2_3 = m4 * a_C3_2_5;
    let x_L4_2_4 = m4 * a_C3_2_6;
    let x_L4_2_5 = a3 * m4;
    let alpha_L3_in_J4_1_2 = w_L2_in_J3_1_2 * c4;
    let a_L3_in_J4_2_2 = (-a_C4_2_3).mul_add(c4, a_C3_1_4 * s4_2);
    let a_C4_3_3 = y4.mul_add(alpha_L3_in_J4_1_2, -a_L3_in_J4_2_2);
    let x_L4_3_3 = m4 * a_C4_3_3;
    let a_L3_in_J4_2_3 = a_C4_1_4 * s4_2;
    let y4_s4_2 = y4 * s4_2;
    let a_C4_3_4 = a_L3_in_J4_2_3 + y4_s4_2;
    let x_L4_3_4 = m4 * a_C4_3_4;
    let a_L3_in_J4_2_4 = d4 * s4_2;
    let a_C4_3_5 = a_L3_in_J4_2_4 + y4_s4_2;
    let x_L4_3_5 = m4 * a_C4_3_5;
    let x_L4_1_6 = Ixx4 * alpha_L3_in_J4_1_2;
    let x_L4_1_7 = Ixx4 * s4_2;
    let x_L4_2_6 = Iyy4 * alpha_L2_in_J3_2_2;
    let x_L4_3_6 = Ixx4 * alpha_L3_in_J4_2_2;
    let x_L4_3_7 = Ixx4 * c4;
    let x_L3_in_J4_1_2 = a_C4_2_3.mul_add(m5_s4_2, a_C3_1_4 * m5_c4);
    let x_L3_in_J4_3_2 = m5 * a_C3_2_5;
    let x_L4_in_J5_1_2 = x_L3_in_J4_3_2.mul_add(s5, x_L3_in_J4_1_2 * c5);
    let x_L3_in_J4_1_3 = a_C4_1_4 * m5_c4;
    let x_L3_in_J4_3_3 = m5 * a_C3_2_6;
    let x_L4_in_J5_1_3 = (-x_L3_in_J4_3_3).mul_add(s5, x_L3_in_J4_1_3 * c5);
    let x_L3_in_J4_1_4 = d4 * m5_c4;
    let x_L3_in_J4_3_4 = a3 * m5;
    let x_L4_in_J5_1_4 = (-x_L3_in_J4_3_4).mul_add(s5, x_L3_in_J4_1_4 * c5);
    let x_L3_in_J4_2_2 = (-a_C4_2_3).mul_add(m5_c4, a_C3_1_4 * m5_s4_2);
    let x_L3_in_J4_2_3 = a_C4_1_4 * m5_s4_2;
    let x_L3_in_J4_2_4 = d4 * m5_s4_2;
    let x_L4_in_J5_2_2 = (-x_L3_in_J4_3_2).mul_add(c5, x_L3_in_J4_1_2 * s5);
    let x_L4_in_J5_2_3 = x_L3_in_J4_3_3.mul_add(c5, x_L3_in_J4_1_3 * s5);
    let x_L4_in_J5_2_4 = x_L3_in_J4_3_4.mul_add(c5, x_L3_in_J4_1_4 * s5);
    let alpha_L4_in_J5_1_2 = (-alpha_L2_in_J3_2_2).mul_add(s5, alpha_L3_in_J4_1_2 * c5);
    let x_L5_1_2 = Ixx5 * alpha_L4_in_J5_1_2;
    let alpha_L4_in_J5_1_3 = s4_2 * c5;
    let x_L5_1_3 = Ixx5 * alpha_L4_in_J5_1_3;
    let x_L5_1_4 = Ixx5 * s5;
    let x_L5_2_2 = Iyy5 * alpha_L3_in_J4_2_2;
    let x_L5_2_3 = Iyy5 * c4;
    let alpha_L4_in_J5_2_2 = alpha_L3_in_J4_1_2.mul_add(s5, alpha_L2_in_J3_2_2 * c5);
    let x_L5_3_2 = Ixx5 * alpha_L4_in_J5_2_2;
    let alpha_L4_in_J5_2_3 = s4_2 * s5;
    let x_L5_3_3 = Ixx5 * alpha_L4_in_J5_2_3;
    let x_L5_3_4 = Ixx5 * c5;
    let alpha_L5_in_L6_2_2 = alpha_L4_in_J5_1_2.mul_add(s6_2, alpha_L3_in_J4_2_2 * c6);
    let a_L4_in_J5_1_2 = a_L3_in_J4_1_2.mul_add(c5, a_C3_2_5 * s5);
    let a_L5_in_L6_1_2 = (-a_L3_in_J4_2_2).mul_add(s6_2, a_L4_in_J5_1_2 * c6);
    let a_C6_1_2 = z6.mul_add(alpha_L5_in_L6_2_2, a_L5_in_L6_1_2);
    let x_L6_1_3 = m6 * a_C6_1_2;
    let alpha_L5_in_L6_2_3 = (-c4).mul_add(c6, alpha_L4_in_J5_1_3 * s6_2);
    let a_L4_in_J5_1_3 = (-a_C3_2_6).mul_add(s5, a_L3_in_J4_1_3 * c5);
    let a_L5_in_L6_1_3 = (-a_L3_in_J4_2_3).mul_add(s6_2, a_L4_in_J5_1_3 * c6);
    let z6_alpha_l5_in_l6_2_3 = z6 * alpha_L5_in_L6_2_3;
    let a_C6_1_3 = z6_alpha_l5_in_l6_2_3 - a_L5_in_L6_1_3;
    let x_L6_1_4 = m6 * a_C6_1_3;
    let a_L4_in_J5_1_4 = (-a3).mul_add(s5, a_L3_in_J4_1_4 * c5);
    let a_L5_in_L6_1_4 = (-a_L3_in_J4_2_4).mul_add(s6_2, a_L4_in_J5_1_4 * c6);
    let a_C6_1_4 = z6_alpha_l5_in_l6_2_3 - a_L5_in_L6_1_4;
    let x_L6_1_5 = m6 * a_C6_1_4;
    let alpha_L5_in_L6_2_4 = s5 * s6_2;
    let a_C6_1_5 = z6 * alpha_L5_in_L6_2_4;
    let x_L6_1_6 = m6 * a_C6_1_5;
    let a_C6_1_6 = z6 * c6;
    let x_L6_1_7 = m6 * a_C6_1_6;
    let alpha_L5_in_L6_1_2 = (-alpha_L3_in_J4_2_2)
        .mul_add(s6_2, alpha_L4_in_J5_1_2 * c6);
    let a_L5_in_L6_2_2 = a_L4_in_J5_1_2.mul_add(s6_2, a_L3_in_J4_2_2 * c6);
    let a_C6_2_2 = z6.mul_add(alpha_L5_in_L6_1_2, -a_L5_in_L6_2_2);
    let x_L6_2_3 = m6 * a_C6_2_2;
    let alpha_L5_in_L6_1_3 = alpha_L4_in_J5_1_3.mul_add(c6, c4 * s6_2);
    let a_L5_in_L6_2_3 = a_L4_in_J5_1_3.mul_add(s6_2, a_L3_in_J4_2_3 * c6);
    let z6_alpha_l5_in_l6_1_3 = z6 * alpha_L5_in_L6_1_3;
    let a_C6_2_3 = a_L5_in_L6_2_3 + z6_alpha_l5_in_l6_1_3;
    let x_L6_2_4 = m6 * a_C6_2_3;
    let a_L5_in_L6_2_4 = a_L4_in_J5_1_4.mul_add(s6_2, a_L3_in_J4_2_4 * c6);
    let a_C6_2_4 = a_L5_in_L6_2_4 + z6_alpha_l5_in_l6_1_3;
    let x_L6_2_5 = m6 * a_C6_2_4;
    let alpha_L5_in_L6_1_4 = s5 * c6;
    let a_C6_2_5 = z6 * alpha_L5_in_L6_1_4;
    let x_L6_2_6 = m6 * a_C6_2_5;
    let a_C6_2_6 = z6 * s6_2;
    let x_L6_2_7 = m6 * a_C6_2_6;
    let a_L4_in_J5_2_2 = (-a_C3_2_5).mul_add(c5, a_L3_in_J4_1_2 * s5);
    let x_L6_3_3 = m6 * a_L4_in_J5_2_2;
    let a_L4_in_J5_2_3 = a_L3_in_J4_1_3.mul_add(s5, a_C3_2_6 * c5);
    let x_L6_3_4 = m6 * a_L4_in_J5_2_3;
    let a_L4_in_J5_2_4 = a_L3_in_J4_1_4.mul_add(s5, a3 * c5);
    let x_L6_3_5 = m6 * a_L4_in_J5_2_4;
    let x_L6_1_8 = Ixx6 * alpha_L5_in_L6_1_2;
    let x_L6_1_9 = Ixx6 * alpha_L5_in_L6_1_3;
    let x_L6_1_10 = Ixx6 * alpha_L5_in_L6_1_4;
    let x_L6_1_11 = Ixx6 * s6_2;
    let x_L6_2_8 = Ixx6 * alpha_L5_in_L6_2_2;
    let x_L6_2_9 = Ixx6 * alpha_L5_in_L6_2_3;
    let x_L6_2_10 = Ixx6 * alpha_L5_in_L6_2_4;
    let x_L6_2_11 = Ixx6 * c6;
    let x_L6_3_6 = Izz6 * alpha_L4_in_J5_2_2;
    let x_L6_3_7 = Izz6 * alpha_L4_in_J5_2_3;
    let x_L6_3_8 = Izz6 * c5;
    let s1 = I1 + a_C2_1_2 * x_L2_1_3 + a_C2_2_2 * x_L2_2_3 + a_C2_3_2 * x_L2_3_3
        + x_L2_1_5 * s2_2 + x_L2_2_5 * c2 + a_C3_1_5 * x_L3_1_3 + a_C3_2_4 * x_L3_2_3
        + a_C3_3_6 * x_L3_3_3 + w_L2_in_J3_1_2 * x_L3_1_6 + a_C4_1_3 * x_L4_1_3
        + a_C3_2_5 * x_L4_2_3 + a_C4_3_3 * x_L4_3_3 + alpha_L3_in_J4_1_2 * x_L4_1_6
        + alpha_L2_in_J3_2_2 * (x_L3_3_7 + x_L4_2_6) + a_L3_in_J4_2_2 * x_L3_in_J4_2_2
        + alpha_L4_in_J5_1_2 * x_L5_1_2 + alpha_L3_in_J4_2_2 * (x_L4_3_6 + x_L5_2_2)
        + alpha_L4_in_J5_2_2 * x_L5_3_2 + x_L4_in_J5_1_2 * a_L4_in_J5_1_2
        + a_C6_1_2 * x_L6_1_3 + a_C6_2_2 * x_L6_2_3
        + a_L4_in_J5_2_2 * (x_L4_in_J5_2_2 + x_L6_3_3) + alpha_L5_in_L6_1_2 * x_L6_1_8
        + alpha_L5_in_L6_2_2 * x_L6_2_8;
    let s2_of_place = x_L4_in_J5_2_3 + x_L6_3_4;
    let x_l4_3_7_plus_x_l5_2_3 = x_L4_3_7 + x_L5_2_3;
    let s2_of_place_2 = alpha_L4_in_J5_1_2
        .mul_add(x_L5_1_3, alpha_L3_in_J4_1_2 * x_L4_1_7);
    let s2_of_place_3 = alpha_L5_in_L6_1_2
        .mul_add(x_L6_1_9, alpha_L4_in_J5_2_2 * x_L5_3_3);
    let s2_of_place_4 = (-alpha_L5_in_L6_2_2)
        .mul_add(x_L6_2_9, alpha_L3_in_J4_2_2 * x_l4_3_7_plus_x_l5_2_3);
    let s2_of_place_5 = s2_of_place_2 + s2_of_place_3;
    let s2_of_place_6 = s2_of_place_4 - s2_of_place_5;
    let s2 = (-a_C2_1_2).mul_add(x_L2_1_4, a_C3_3_6 * x_L3_3_4) - a_C2_2_2 * x_L2_2_4
        - a_C3_1_5 * x_L3_1_4 + a_C4_1_3 * x_L4_1_4 - a_C3_2_5 * x_L4_2_4
        - a_C4_3_3 * x_L4_3_4 + a_L3_in_J4_2_2 * x_L3_in_J4_2_3
        + x_L4_in_J5_1_3 * a_L4_in_J5_1_2 - a_C6_1_2 * x_L6_1_4 - a_C6_2_2 * x_L6_2_4
        + a_L4_in_J5_2_2 * s2_of_place + s2_of_place_6;
    let s3_of_place = x_L4_in_J5_2_4 + x_L6_3_5;
    let s3 = (-a_C3_1_5).mul_add(x_L3_1_5, a_C3_3_6 * x_L3_3_5) + a_C4_1_3 * x_L4_1_5
        - a_C3_2_5 * x_L4_2_5 - a_C4_3_3 * x_L4_3_5 + a_L3_in_J4_2_2 * x_L3_in_J4_2_4
        + x_L4_in_J5_1_4 * a_L4_in_J5_1_2 - a_C6_1_2 * x_L6_1_5 - a_C6_2_2 * x_L6_2_5
        + s2_of_place_6 + a_L4_in_J5_2_2 * s3_of_place;
    let s4 = alpha_L4_in_J5_1_2.mul_add(x_L5_1_4, -x_L4_2_6)
        - alpha_L4_in_J5_2_2 * x_L5_3_4 + a_C6_1_2 * x_L6_1_6 + a_C6_2_2 * x_L6_2_6
        + alpha_L5_in_L6_1_2 * x_L6_1_10 + alpha_L5_in_L6_2_2 * x_L6_2_10;
    let x_l4_3_2_minus_x_l5_2 = x_L4_3_2 - x_L5_2;
    let r5_of_place = x_L4_in_J5_2 - x_L6_3;
    let r5 = tau1 - x_L2_1_2 * s2_2 - x_L2_2_2 * c2 + x_L2_1 * a_C2_1_2
        - x_L2_2 * a_C2_2_2 - x_L2_3 * a_C2_3_2
        + alpha_L2_in_J3_2_2 * (x_L3_3_2 - x_L4_2_2) + x_L3_1 * a_C3_1_5
        - x_L3_1_2 * w_L2_in_J3_1_2 - x_L3_2 * a_C3_2_4 - x_L4_2 * a_C3_2_5
        + x_L3_3 * a_C3_3_6 + x_L4_1 * a_C4_1_3 - x_L4_1_2 * alpha_L3_in_J4_1_2
        - x_L3_in_J4_2 * a_L3_in_J4_2_2 - x_L4_3 * a_C4_3_3 - x_L5_1 * alpha_L4_in_J5_1_2
        + x_L5_3 * alpha_L4_in_J5_2_2 + x_L6_2_2 * alpha_L5_in_L6_2_2
        - x_L4_in_J5_1 * a_L4_in_J5_1_2 + x_L6_1 * a_C6_1_2
        + x_L6_1_2 * alpha_L5_in_L6_1_2 - x_L6_2 * a_C6_2_2
        - alpha_L3_in_J4_2_2 * x_l4_3_2_minus_x_l5_2 - a_L4_in_J5_2_2 * r5_of_place;
    let s6_of_place = alpha_L4_in_J5_1_3.mul_add(x_L5_1_3, x_L4_1_7 * s4_2);
    let s6_of_place_2 = alpha_L5_in_L6_1_3
        .mul_add(x_L6_1_9, alpha_L4_in_J5_2_3 * x_L5_3_3);
    let s6_of_place_3 = x_l4_3_7_plus_x_l5_2_3
        .mul_add(c4, alpha_L5_in_L6_2_3 * x_L6_2_9);
    let iyy3_plus_s6_of_place = Iyy3 + s6_of_place;
    let s6_of_place_4 = s6_of_place_2 + s6_of_place_3;
    let s6_of_place_5 = iyy3_plus_s6_of_place + s6_of_place_4;
    let s6 = y2.mul_add(x_L2_1_4, Izz2) + a_C2_2_3 * x_L2_2_4 + a_C3_1_6 * x_L3_1_4
        + a_C3_3_7 * x_L3_3_4 + a_C4_1_5 * x_L4_1_4 + a_C3_2_6 * x_L4_2_4
        + a_C4_3_4 * x_L4_3_4 + a_L3_in_J4_2_3 * x_L3_in_J4_2_3
        + x_L4_in_J5_1_3 * a_L4_in_J5_1_3 + a_C6_1_3 * x_L6_1_4 + a_C6_2_3 * x_L6_2_4
        + a_L4_in_J5_2_3 * s2_of_place + s6_of_place_5;
    let s7 = a_C3_3_7.mul_add(x_L3_3_5, a_C3_1_6 * x_L3_1_5) + a_C4_1_5 * x_L4_1_5
        + a_C3_2_6 * x_L4_2_5 + a_C4_3_4 * x_L4_3_5 + a_L3_in_J4_2_3 * x_L3_in_J4_2_4
        + x_L4_in_J5_1_4 * a_L4_in_J5_1_3 + a_C6_1_3 * x_L6_1_5 + a_C6_2_3 * x_L6_2_5
        + a_L4_in_J5_2_3 * s3_of_place + s6_of_place_5;
    let s8_of_place = (-alpha_L4_in_J5_2_3)
        .mul_add(x_L5_3_4, alpha_L4_in_J5_1_3 * x_L5_1_4);
    let s8_of_place_2 = alpha_L5_in_L6_2_3
        .mul_add(x_L6_2_10, alpha_L5_in_L6_1_3 * x_L6_1_10);
    let s8_of_place_3 = s8_of_place + s8_of_place_2;
    let s8 = (-a_C6_2_3).mul_add(x_L6_2_6, -a_C6_1_3 * x_L6_1_6) - s8_of_place_3;
    let r9_of_place = x_L5_1.mul_add(alpha_L4_in_J5_1_3, x_L4_1_2 * s4_2);
    let r9_of_place_2 = x_L6_1_2
        .mul_add(alpha_L5_in_L6_1_3, x_L5_3 * alpha_L4_in_J5_2_3);
    let r9_of_place_3 = x_l4_3_2_minus_x_l5_2.mul_add(c4, x_L6_2_2 * alpha_L5_in_L6_2_3);
    let r9_of_place_4 = x_L3_2_2 + r9_of_place;
    let r9_of_place_5 = r9_of_place_2 + r9_of_place_3;
    let r9_of_place_6 = r9_of_place_4 - r9_of_place_5;
    let r9 = (-y2).mul_add(x_L2_1, x_L2_3_2) + x_L2_2 * a_C2_2_3 - x_L3_1 * a_C3_1_6
        + x_L4_2 * a_C3_2_6 + x_L3_3 * a_C3_3_7 + x_L4_1 * a_C4_1_5
        - x_L3_in_J4_2 * a_L3_in_J4_2_3 + x_L4_3 * a_C4_3_4
        - x_L4_in_J5_1 * a_L4_in_J5_1_3 - x_L6_1 * a_C6_1_3 + x_L6_2 * a_C6_2_3
        - a_L4_in_J5_2_3 * r5_of_place + r9_of_place_6;
    let s10 = x_L2_1_6.mul_add(x_L3_3_5, z3 * x_L3_1_5) + a_C4_1_6 * x_L4_1_5
        + a3 * x_L4_2_5 + a_C4_3_5 * x_L4_3_5 + a_L3_in_J4_2_4 * x_L3_in_J4_2_4
        + x_L4_in_J5_1_4 * a_L4_in_J5_1_4 + a_C6_1_4 * x_L6_1_5 + a_C6_2_4 * x_L6_2_5
        + a_L4_in_J5_2_4 * s3_of_place + s6_of_place_5;
    let s11 = (-a_C6_2_4).mul_add(x_L6_2_6, -a_C6_1_4 * x_L6_1_6) - s8_of_place_3;
    let r12 = (-z3).mul_add(x_L3_1, a3 * x_L4_2) + x_L3_3 * x_L2_1_6 + x_L4_1 * a_C4_1_6
        - x_L3_in_J4_2 * a_L3_in_J4_2_4 + x_L4_3 * a_C4_3_5
        - x_L4_in_J5_1 * a_L4_in_J5_1_4 - x_L6_1 * a_C6_1_4 + x_L6_2 * a_C6_2_4
        - a_L4_in_J5_2_4 * r5_of_place + r9_of_place_6;
    let l13 = c5;
    let s14 = Iyy4 + x_L5_1_4 * s5 + a_C6_1_5 * x_L6_1_6 + a_C6_2_5 * x_L6_2_6
        + alpha_L5_in_L6_1_4 * x_L6_1_10 + alpha_L5_in_L6_2_4 * x_L6_2_10
        + c5 * (x_L5_3_4 + x_L6_3_8) - x_L6_3_8 * l13;
    let r15 = x_L4_2_2 - x_L5_1 * s5 + c5 * (x_L6_3_2 - x_L5_3)
        + x_L6_2_2 * alpha_L5_in_L6_2_4 + x_L6_1 * a_C6_1_5
        + x_L6_1_2 * alpha_L5_in_L6_1_4 - x_L6_2 * a_C6_2_5 - x_L6_3_2 * l13;
    let s1_inv = S::int(1) / s1;
    let l16 = s2 * s1_inv;
    let s17 = (-s2).mul_add(l16, s6);
    let s18 = (-s3).mul_add(l16, s7);
    let s19 = (-s4).mul_add(l16, s8);
    let s20_of_place = a_C6_1_2.mul_add(x_L6_1_7, x_L5_2_2) - a_C6_2_2 * x_L6_2_7
        - alpha_L5_in_L6_1_2 * x_L6_1_11 + alpha_L5_in_L6_2_2 * x_L6_2_11;
    let s20_of_place_2 = alpha_L5_in_L6_1_3.mul_add(x_L6_1_11, x_L5_2_3);
    let s20_of_place_3 = alpha_L5_in_L6_2_3.mul_add(x_L6_2_11, -s20_of_place_2);
    let s20 = (-a_C6_1_3).mul_add(x_L6_1_7, a_C6_2_3 * x_L6_2_7) - l16 * s20_of_place
        - s20_of_place_3;
    let r21 = (-r5).mul_add(l16, r9);
    let l22 = s3 * s1_inv;
    let s23 = (-s3).mul_add(l22, s10);
    let s24 = (-s4).mul_add(l22, s11);
    let s25 = (-a_C6_1_4).mul_add(x_L6_1_7, a_C6_2_4 * x_L6_2_7) - l22 * s20_of_place
        - s20_of_place_3;
    let r26 = (-r5).mul_add(l22, r12);
    let l27 = s4 * s1_inv;
    let s28 = (-s4).mul_add(l27, s14);
    let s29 = (-a_C6_2_5).mul_add(x_L6_2_7, a_C6_1_5 * x_L6_1_7)
        - alpha_L5_in_L6_1_4 * x_L6_1_11 + alpha_L5_in_L6_2_4 * x_L6_2_11 - l27 * s20_of_place;
    let r30 = (-r5).mul_add(l27, r15);
    let l31 = s1_inv
        * (x_L6_1_3.mul_add(a_C6_1_6, x_L5_2_2) - x_L6_2_3 * a_C6_2_6 - x_L6_1_8 * s6_2
            + x_L6_2_8 * c6);
    let s32 = a_C6_1_6.mul_add(x_L6_1_7, Iyy5) + a_C6_2_6 * x_L6_2_7 + x_L6_1_11 * s6_2
        + x_L6_2_11 * c6 - l31 * s20_of_place;
    let r33 = (-x_L6_1_2).mul_add(s6_2, x_L5_2) + x_L6_2_2 * c6 + x_L6_1 * a_C6_1_6
        + x_L6_2 * a_C6_2_6 - r5 * l31;
    let s17_inv = S::int(1) / s17;
    let l34 = s18 * s17_inv;
    let s35 = (-s18).mul_add(l34, s23);
    let s36 = (-s19).mul_add(l34, s24);
    let s37 = (-s20).mul_add(l34, s25);
    let r38 = (-r21).mul_add(l34, r26);
    let l39 = s19 * s17_inv;
    let s40 = (-s19).mul_add(l39, s28);
    let s41 = (-s20).mul_add(l39, s29);
    let r42 = (-r21).mul_add(l39, r30);
    let l43 = s20 * s17_inv;
    let s44 = (-s20).mul_add(l43, s32);
    let r45 = (-r21).mul_add(l43, r33);
    let s35_inv = S::int(1) / s35;
    let l46 = s36 * s35_inv;
    let s47 = (-s36).mul_add(l46, s40);
    let s48 = (-s37).mul_add(l46, s41);
    let r49 = (-r38).mul_add(l46, r42);
    let l50 = s37 * s35_inv;
    let s51 = (-s37).mul_add(l50, s44);
    let r52 = (-r38).mul_add(l50, r45);
    let s47_inv = S::int(1) / s47;
    let l53 = s48 * s47_inv;
    let s54 = (-s48).mul_add(l53, s51);
    let r55 = (-r49).mul_add(l53, r52);
    let u5_dot = r55 / s54;
    let u4_dot = s47_inv * (-u5_dot).mul_add(s48, r49);
    let u3_dot = s35_inv * ((-u4_dot).mul_add(s36, r38) - u5_dot * s37);
    let u2_dot = s17_inv * ((-u3_dot).mul_add(s18, r21) - u4_dot * s19 - u5_dot * s20);
    let u1_dot = s1_inv
        * ((-u2_dot).mul_add(s2, r5) - u3_dot * s3 - u4_dot * s4 - u5_dot * s20_of_place);
    let u6_dot = (x_L6_3_2 + u1_dot * x_L6_3_6 - x_L6_3_7 * (u2_dot + u3_dot)
        - u4_dot * x_L6_3_8) / Izz6;
    [u1_dot, u2_dot, u3_dot, u4_dot, u5_dot, u6_dot]
}

/// Kinetic energy T.
///
/// 180 operations, 5 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 6], u: &[S; 6]) -> S {
    let Parameters {
        a2, a3, d3, d4, m2, m3, m4, m5, m6, x2, y2, z2, x3, y3, z3, y4, z6, I1, Ixx2, Iyy2, Izz2,
        Ixx3, Iyy3, Izz3, Ixx4, Iyy4, Ixx5, Iyy5, Ixx6, Izz6,
        ..
    } = *p;
    let [_, q2, q3, q4, q5, q6] = *q;
    let [u1, u2, u3, u4, u5, u6] = *u;
    // Sines and cosines.
    let (s2_2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    let (s4_2, c4) = q4.sin_cos();
    let (s5, c5) = q5.sin_cos();
    let (s6_2, c6) = q6.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_L1_in_L2_1 = u1 * s2_2;
    let w_L1_in_L2_2 = u1 * c2;
    let H_upper_arm_2 = Iyy2 * w_L1_in_L2_2;
    let H_upper_arm_3 = Izz2 * u2;
    let H_upper_arm_1 = Ixx2 * w_L1_in_L2_1;
    let w_L2_in_J3_1 = w_L1_in_L2_2.mul_add(s3_2, w_L1_in_L2_1 * c3);
    let w_L2_in_J3_2 = (-w_L1_in_L2_2).mul_add(c3, w_L1_in_L2_1 * s3_2);
    let w_J3_3 = u2 + u3;
    let H_forearm_2 = Iyy3 * w_J3_3;
    let H_forearm_3 = Izz3 * w_L2_in_J3_2;
    let H_forearm_1 = Ixx3 * w_L2_in_J3_1;
    let w_L3_in_J4_1 = (-w_J3_3).mul_add(s4_2, w_L2_in_J3_1 * c4);
    let w_J4_3 = u4 - w_L2_in_J3_2;
    let w_L3_in_J4_2 = w_J3_3.mul_add(c4, w_L2_in_J3_1 * s4_2);
    let H_wrist1_2 = Iyy4 * w_J4_3;
    let H_wrist1_3 = Ixx4 * w_L3_in_J4_2;
    let H_wrist1_1 = Ixx4 * w_L3_in_J4_1;
    let w_L4_in_J5_2 = (-w_J4_3).mul_add(c5, w_L3_in_J4_1 * s5);
    let w_J5_3 = u5 + w_L3_in_J4_2;
    let H_wrist2_2 = Iyy5 * w_J5_3;
    let H_wrist2_3 = Ixx5 * w_L4_in_J5_2;
    let w_L4_in_J5_1 = w_J4_3.mul_add(s5, w_L3_in_J4_1 * c5);
    let H_wrist2_1 = Ixx5 * w_L4_in_J5_1;
    let w_L5_in_L6_1 = (-w_J5_3).mul_add(s6_2, w_L4_in_J5_1 * c6);
    let w_L6_3 = u6 - w_L4_in_J5_2;
    let w_L5_in_L6_2 = w_L4_in_J5_1.mul_add(s6_2, w_J5_3 * c6);
    let H_flange_2 = Ixx6 * w_L5_in_L6_2;
    let H_flange_3 = Izz6 * w_L6_3;
    let H_flange_1 = Ixx6 * w_L5_in_L6_1;
    let H_column_3 = I1 * u1;
    let x_L2_1_7 = (-y2).mul_add(u2, z2 * w_L1_in_L2_2);
    let a2_plus_x2 = a2 + x2;
    let x_L2_2_6 = (-z2).mul_add(w_L1_in_L2_1, u2 * a2_plus_x2);
    let x_L2_3_5 = (-y2).mul_add(w_L1_in_L2_1, w_L1_in_L2_2 * a2_plus_x2);
    let a2_u2 = a2 * u2;
    let x_L2_in_J3_1_4 = a2_u2 * s3_2;
    let x_L2_in_J3_2_2 = a2_u2 * c3;
    let x_L2_in_J3_3 = a2 * w_L1_in_L2_2;
    let x_L3_1_7 = d3.mul_add(w_L2_in_J3_2, -x_L2_in_J3_1_4);
    let x_L3_2_4 = (-d3).mul_add(w_L2_in_J3_1, a3 * w_J3_3) + x_L2_in_J3_2_2;
    let x_L3_3_8 = a3.mul_add(w_L2_in_J3_2, -x_L2_in_J3_3);
    let x_L3_1_8 = (-y3).mul_add(w_L2_in_J3_2, z3 * w_J3_3) + x_L3_1_7;
    let x_L3_2_5 = x3.mul_add(w_L2_in_J3_2, z3 * w_L2_in_J3_1) + x_L3_3_8;
    let x_L3_3_9 = x3.mul_add(w_J3_3, y3 * w_L2_in_J3_1) + x_L3_2_4;
    let x_L4_1_8 = d4.mul_add(w_J3_3, x_L3_1_7);
    let x_L4_2_7 = d4.mul_add(w_L2_in_J3_1, x_L3_3_8);
    let x_L3_in_J4_1_5 = x_L4_2_7.mul_add(s4_2, x_L4_1_8 * c4);
    let x_L3_in_J4_2_5 = (-x_L4_2_7).mul_add(c4, x_L4_1_8 * s4_2);
    let x_L4_1_9 = y4.mul_add(w_L3_in_J4_2, x_L3_in_J4_1_5);
    let x_L4_3_8 = y4.mul_add(w_L3_in_J4_1, -x_L3_in_J4_2_5);
    let x_L4_in_J5_1_5 = (-x_L3_2_4).mul_add(s5, x_L3_in_J4_1_5 * c5);
    let x_L4_in_J5_2_5 = x_L3_in_J4_1_5.mul_add(s5, x_L3_2_4 * c5);
    let x_L5_in_L6_1 = (-x_L3_in_J4_2_5).mul_add(s6_2, x_L4_in_J5_1_5 * c6);
    let x_L5_in_L6_2 = x_L4_in_J5_1_5.mul_add(s6_2, x_L3_in_J4_2_5 * c6);
    let x_L6_1_12 = z6.mul_add(w_L5_in_L6_2, x_L5_in_L6_1);
    let x_L6_2_12 = z6.mul_add(w_L5_in_L6_1, -x_L5_in_L6_2);
    let energy_of_place = x_L2_2_6.mul_add(x_L2_2_6, x_L2_1_7 * x_L2_1_7);
    let energy_of_place_2 = x_L3_2_5.mul_add(x_L3_2_5, x_L3_1_8 * x_L3_1_8);
    let energy_of_place_3 = x_L6_2_12.mul_add(x_L6_2_12, x_L6_1_12 * x_L6_1_12);
    let energy_of_place_4 = w_L3_in_J4_1.mul_add(H_wrist1_1, w_L2_in_J3_2 * H_forearm_3);
    let energy_of_place_5 = w_L3_in_J4_2.mul_add(H_wrist1_3, w_J4_3 * H_wrist1_2);
    let energy_of_place_6 = w_L4_in_J5_1.mul_add(H_wrist2_1, w_J5_3 * H_wrist2_2);
    let energy_of_place_7 = w_L5_in_L6_1.mul_add(H_flange_1, w_L4_in_J5_2 * H_wrist2_3);
    let energy_of_place_8 = energy_of_place_4 + energy_of_place_5;
    let energy_of_place_9 = energy_of_place_6 + energy_of_place_7;
    let energy_of_place_10 = w_L6_3.mul_add(H_flange_3, w_L5_in_L6_2 * H_flange_2);
    let energy_of_place_11 = x_L3_2_4 * x_L3_2_4 * (m4 + m5)
        + m4 * x_L4_3_8.mul_add(x_L4_3_8, x_L4_1_9 * x_L4_1_9);
    let energy_of_u1 = u1.mul_add(H_column_3, w_L1_in_L2_1 * H_upper_arm_1);
    let energy_of_u2 = u2.mul_add(H_upper_arm_3, w_L1_in_L2_2 * H_upper_arm_2);
    let energy_of_place_12 = w_L2_in_J3_1.mul_add(H_forearm_1, w_J3_3 * H_forearm_2);
    let energy_of_u1_2 = m5 * x_L4_2_7.mul_add(x_L4_2_7, x_L4_1_8 * x_L4_1_8) + energy_of_u1;
    let energy_of_u2_2 = energy_of_u2 + energy_of_place_12;
    let energy_of_place_13 = energy_of_place_10 + energy_of_place_11;
    let energy_of_u1_u2 = energy_of_u1_2 + energy_of_u2_2;
    let energy_of_place_14 = energy_of_place_8 + energy_of_place_9;
    let energy_of_u1_u2_2 = energy_of_place_13 + energy_of_u1_u2;
    let energy_of_u1_u2_3 = energy_of_place_14 + energy_of_u1_u2_2;
    // Values.
    let energy = S::ratio(1, 2) * m2 * x_L2_3_5.mul_add(x_L2_3_5, energy_of_place)
        + S::ratio(1, 2) * m3 * x_L3_3_9.mul_add(x_L3_3_9, energy_of_place_2)
        + S::ratio(1, 2) * m6 * x_L4_in_J5_2_5.mul_add(x_L4_in_J5_2_5, energy_of_place_3)
        + S::ratio(1, 2) * energy_of_u1_u2_3;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 76 operations, 5 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 6]) -> S {
    let Parameters {
        g, a2, a3, d3, d4, m2, m3, m4, m5, m6, x2, y2, z2, x3, y3, z3, y4, z6,
        ..
    } = *p;
    let [_, q2, q3, q4, q5, q6] = *q;
    // Sines and cosines.
    let (s2_2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    let (s4_2, c4) = q4.sin_cos();
    let (s5, c5) = q5.sin_cos();
    let (s6_2, c6) = q6.sin_cos();
    // Step by step, each after the terms that it needs.
    let a_L1_in_L2_1 = g * s2_2;
    let a_L1_in_L2_2 = g * c2;
    let x_L2_1_4 = m2 * y2;
    let m4_plus_m5 = m4 + m5;
    let m6_plus_m4_plus_m5 = m6 + m4_plus_m5;
    let mp_L2_1_of_m3_m4_m5_m6 = m3 + m6_plus_m4_plus_m5;
    let mp_L2_1 = m2 * (a2 + x2) + a2 * mp_L2_1_of_m3_m4_m5_m6;
    let mp_L2_3 = m2 * z2;
    let mp_J3_1 = a3 * mp_L2_1_of_m3_m4_m5_m6;
    let mp_J3_3 = d3 * mp_L2_1_of_m3_m4_m5_m6;
    let mp_L3_1 = m3 * x3;
    let mp_L3_2 = m3 * y3;
    let mp_L3_3 = d4.mul_add(m6_plus_m4_plus_m5, m3 * z3);
    let mp_L4_2 = m4 * y4;
    let mp_L6_3 = m6 * z6;
    let x_L2_in_J3_1_5 = a_L1_in_L2_2.mul_add(s3_2, a_L1_in_L2_1 * c3);
    let x_L2_in_J3_2_3 = (-a_L1_in_L2_2).mul_add(c3, a_L1_in_L2_1 * s3_2);
    let x_L3_in_J4_1_6 = x_L2_in_J3_1_5 * c4;
    let x_L3_in_J4_2_6 = x_L2_in_J3_1_5 * s4_2;
    let x_L4_in_J5_1_6 = (-x_L2_in_J3_2_3).mul_add(s5, x_L3_in_J4_1_6 * c5);
    let x_L4_in_J5_2_6 = x_L3_in_J4_1_6.mul_add(s5, x_L2_in_J3_2_3 * c5);
    let x_L5_in_L6_1_2 = (-x_L3_in_J4_2_6).mul_add(s6_2, x_L4_in_J5_1_6 * c6);
    let x_L5_in_L6_2_2 = x_L4_in_J5_1_6.mul_add(s6_2, x_L3_in_J4_2_6 * c6);
    let x_L2_in_J3_1_6 = mp_L2_1.mul_add(c3, x_L2_1_4 * s3_2);
    let x_L2_in_J3_2_4 = (-x_L2_1_4).mul_add(c3, mp_L2_1 * s3_2);
    let x_L6_1_13 = mp_J3_1 + x_L2_in_J3_1_6;
    let x_L6_3_9 = mp_L2_3 + mp_J3_3;
    let x_L6_1_14 = mp_L3_1 + x_L6_1_13;
    let x_L6_2_13 = mp_L3_2 - x_L6_3_9;
    let x_L6_3_10 = mp_L3_3 - x_L2_in_J3_2_4;
    let x_L3_in_J4_1_7 = x_L6_2_13.mul_add(s4_2, x_L6_1_14 * c4);
    let x_L3_in_J4_2_7 = (-x_L6_2_13).mul_add(c4, x_L6_1_14 * s4_2);
    let x_L6_2_14 = mp_L4_2 + x_L6_3_10;
    let x_L4_in_J5_1_7 = x_L6_2_14.mul_add(s5, x_L3_in_J4_1_7 * c5);
    let x_L4_in_J5_2_7 = (-x_L6_2_14).mul_add(c5, x_L3_in_J4_1_7 * s5);
    let x_L5_in_L6_1_3 = (-x_L3_in_J4_2_7).mul_add(s6_2, x_L4_in_J5_1_7 * c6);
    let x_L5_in_L6_2_3 = x_L4_in_J5_1_7.mul_add(s6_2, x_L3_in_J4_2_7 * c6);
    let x_L6_3_11 = mp_L6_3 - x_L4_in_J5_2_7;
    // Values.
    let energy = x_L5_in_L6_2_2.mul_add(x_L5_in_L6_2_3, x_L5_in_L6_1_2 * x_L5_in_L6_1_3)
        - x_L4_in_J5_2_6 * x_L6_3_11;
    energy
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    u: &[S; 6],
    direction: &[S; 12],
) -> [S; 12] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[6 + i],
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
            parameters: 38,
            coordinates: 6,
            variables: 6,
            speeds: 6,
            reactions: 30,
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
        12
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
    fn has_power(&self) -> bool {
        true
    }
    fn power(&self, p: &[S], q: &[S], v: &[S]) -> S {
        power(&Parameters::from_slice(p), array(q), array(v))
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
