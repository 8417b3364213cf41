//! PUMA 560: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/puma560/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows q1, q2, q3, q4, q5, q6.
///
/// 620 operations, 5 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    _q_dot: &[S; 6],
) -> [[S; 6]; 6] {
    let Parameters {
        a2, a3, d3, d4, m2, m3, m4, m5, m6, x2, y2, z2, x3, y3, z3, y4, z6, I1, Ixx2, Iyy2, Izz2,
        Ixx3, Iyy3, Izz3, Ixx4, Iyy4, Ixx5, Iyy5, Ixx6, Izz6,
        ..
    } = *p;
    let [_, q2, q3, q4, q5, q6] = *q;
    // Sines and cosines.
    let (s2_2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    let (s4_2, c4) = q4.sin_cos();
    let (s5_2, c5) = q5.sin_cos();
    let (s6, c6) = q6.sin_cos();
    // Step by step, each after the terms that it needs.
    let mp_L2_2 = m2 * y2;
    let w_L2_in_J3_1_4 = s2_2.mul_add(c3, c2 * s3_2);
    let w_L2_in_J3_2_4 = (-c2).mul_add(c3, s2_2 * s3_2);
    let w_L3_in_J4_1_4 = w_L2_in_J3_1_4 * c4;
    let w_L3_in_J4_2_4 = w_L2_in_J3_1_4 * s4_2;
    let w_L4_in_J5_1_4 = (-w_L2_in_J3_2_4).mul_add(s5_2, w_L3_in_J4_1_4 * c5);
    let w_L4_in_J5_2_4 = w_L3_in_J4_1_4.mul_add(s5_2, w_L2_in_J3_2_4 * c5);
    let w_L5_in_L6_1_4 = (-w_L3_in_J4_2_4).mul_add(s6, w_L4_in_J5_1_4 * c6);
    let w_L5_in_L6_2_4 = w_L4_in_J5_1_4.mul_add(s6, w_L3_in_J4_2_4 * c6);
    let v_C2_1_4 = z2 * c2;
    let v_C2_2_4 = z2 * s2_2;
    let a2_plus_x2 = a2 + x2;
    let v_C2_3_4 = (-y2).mul_add(s2_2, a2_plus_x2 * c2);
    let H_upper_arm_1_4 = Ixx2 * s2_2;
    let H_upper_arm_2_4 = Iyy2 * c2;
    let v_L2_in_J3_3_4 = a2 * c2;
    let v_C3_1_7 = d3 * w_L2_in_J3_2_4;
    let v_C3_2_7 = d3 * w_L2_in_J3_1_4;
    let v_C3_3_7 = a3.mul_add(w_L2_in_J3_2_4, -v_L2_in_J3_3_4);
    let v_C3_1_8 = y3.mul_add(w_L2_in_J3_2_4, -v_C3_1_7);
    let v_C3_2_8 = x3.mul_add(w_L2_in_J3_2_4, z3 * w_L2_in_J3_1_4) + v_C3_3_7;
    let v_C3_3_8 = y3.mul_add(w_L2_in_J3_1_4, -v_C3_2_7);
    let H_forearm_1_4 = Ixx3 * w_L2_in_J3_1_4;
    let H_forearm_3_4 = Izz3 * w_L2_in_J3_2_4;
    let v_C4_2_4 = d4.mul_add(w_L2_in_J3_1_4, v_C3_3_7);
    let v_L3_in_J4_1_4 = v_C4_2_4.mul_add(s4_2, v_C3_1_7 * c4);
    let v_L3_in_J4_2_4 = (-v_C4_2_4).mul_add(c4, v_C3_1_7 * s4_2);
    let v_C4_1_6 = y4.mul_add(w_L3_in_J4_2_4, v_L3_in_J4_1_4);
    let v_C4_3_4 = y4.mul_add(w_L3_in_J4_1_4, -v_L3_in_J4_2_4);
    let H_wrist1_1_4 = Ixx4 * w_L3_in_J4_1_4;
    let H_wrist1_2_4 = Iyy4 * w_L2_in_J3_2_4;
    let H_wrist1_3_4 = Ixx4 * w_L3_in_J4_2_4;
    let H_wrist2_1_4 = Ixx5 * w_L4_in_J5_1_4;
    let H_wrist2_2_4 = Iyy5 * w_L3_in_J4_2_4;
    let H_wrist2_3_4 = Ixx5 * w_L4_in_J5_2_4;
    let v_L4_in_J5_1_4 = v_L3_in_J4_1_4.mul_add(c5, v_C3_2_7 * s5_2);
    let v_L4_in_J5_2_4 = (-v_C3_2_7).mul_add(c5, v_L3_in_J4_1_4 * s5_2);
    let v_L5_in_L6_1_4 = (-v_L3_in_J4_2_4).mul_add(s6, v_L4_in_J5_1_4 * c6);
    let v_L5_in_L6_2_4 = v_L4_in_J5_1_4.mul_add(s6, v_L3_in_J4_2_4 * c6);
    let v_C6_1_4 = z6.mul_add(w_L5_in_L6_2_4, v_L5_in_L6_1_4);
    let v_C6_2_4 = z6.mul_add(w_L5_in_L6_1_4, -v_L5_in_L6_2_4);
    let H_flange_1_4 = Ixx6 * w_L5_in_L6_1_4;
    let H_flange_2_4 = Ixx6 * w_L5_in_L6_2_4;
    let H_flange_3_4 = Izz6 * w_L4_in_J5_2_4;
    let p_v_C6_2_4 = m6 * v_C6_2_4;
    let p_v_C6_1_4 = m6 * v_C6_1_4;
    let p_v_L4_in_J5_2_4 = m6 * v_L4_in_J5_2_4;
    let p_v_L4_in_J5_1_4 = (-p_v_C6_1_4).mul_add(c6, p_v_C6_2_4 * s6);
    let p_v_C4_3_4 = m4 * v_C4_3_4;
    let p_v_C4_1_7 = m4 * v_C4_1_6;
    let p_v_L3_in_J4_2_4 = p_v_C6_1_4.mul_add(s6, p_v_C6_2_4 * c6) + p_v_C4_3_4;
    let p_v_L3_in_J4_1_4 = (-p_v_L4_in_J5_1_4).mul_add(c5, p_v_L4_in_J5_2_4 * s5_2) + p_v_C4_1_7;
    let p_v_C4_2_4 = p_v_L3_in_J4_2_4.mul_add(c4, m5 * v_C4_2_4) + p_v_L3_in_J4_1_4 * s4_2;
    let p_v_C4_1_8 = (-p_v_L3_in_J4_2_4).mul_add(s4_2, m5 * v_C3_1_7) + p_v_L3_in_J4_1_4 * c4;
    let p_v_C3_3_7 = m3 * v_C3_3_8;
    let p_v_C3_2_7 = m3 * v_C3_2_8;
    let p_v_C3_1_7 = m3 * v_C3_1_8;
    let p_v_C3_3_8 = p_v_C4_2_4 + p_v_C3_2_7;
    let m4_plus_m5 = m4 + m5;
    let p_v_C3_2_8 = (-p_v_L4_in_J5_2_4).mul_add(c5, v_C3_2_7 * m4_plus_m5)
        - p_v_L4_in_J5_1_4 * s5_2 - p_v_C3_3_7;
    let p_v_C3_1_8 = p_v_C4_1_8 - p_v_C3_1_7;
    let p_v_C2_3_4 = m2 * v_C2_3_4;
    let p_v_C2_2_4 = m2 * v_C2_2_4;
    let p_v_C2_1_4 = m2 * v_C2_1_4;
    let p_w_L5_in_L6_2_4 = z6.mul_add(p_v_C6_1_4, H_flange_2_4);
    let p_w_L5_in_L6_1_4 = z6.mul_add(p_v_C6_2_4, H_flange_1_4);
    let p_w_J5_3_4 = p_w_L5_in_L6_2_4.mul_add(c6, H_wrist2_2_4) - p_w_L5_in_L6_1_4 * s6;
    let p_w_L4_in_J5_2_4 = H_wrist2_3_4 + H_flange_3_4;
    let p_w_L4_in_J5_1_4 = p_w_L5_in_L6_2_4.mul_add(s6, H_wrist2_1_4) + p_w_L5_in_L6_1_4 * c6;
    let p_w_J4_3_4 = p_w_L4_in_J5_2_4.mul_add(c5, H_wrist1_2_4) - p_w_L4_in_J5_1_4 * s5_2;
    let p_w_L3_in_J4_2_4 = y4.mul_add(p_v_C4_1_7, H_wrist1_3_4) + p_w_J5_3_4;
    let p_w_L3_in_J4_1_4 = y4.mul_add(p_v_C4_3_4, H_wrist1_1_4) + p_w_L4_in_J5_2_4 * s5_2
        + p_w_L4_in_J5_1_4 * c5;
    let p_w_L2_in_J3_2_4 = x3.mul_add(p_v_C3_2_7, H_forearm_3_4) + y3 * p_v_C3_1_7
        + a3 * p_v_C3_3_8 + d3 * p_v_C3_1_8 + p_w_J4_3_4;
    let p_w_L2_in_J3_1_4 = d4.mul_add(p_v_C4_2_4, H_forearm_1_4) + y3 * p_v_C3_3_7
        + z3 * p_v_C3_2_7 + d3 * p_v_C3_2_8 + p_w_L3_in_J4_2_4 * s4_2 + p_w_L3_in_J4_1_4 * c4;
    let p_w_L1_in_L2_2_4 = (-a2).mul_add(p_v_C3_3_8, H_upper_arm_2_4) + z2 * p_v_C2_1_4
        - p_w_L2_in_J3_2_4 * c3 + p_w_L2_in_J3_1_4 * s3_2 + p_v_C2_3_4 * a2_plus_x2;
    let p_w_L1_in_L2_1_4 = (-y2).mul_add(p_v_C2_3_4, H_upper_arm_1_4) + z2 * p_v_C2_2_4
        + p_w_L2_in_J3_2_4 * s3_2 + p_w_L2_in_J3_1_4 * c3;
    let w_L4_in_J5_1_5 = s4_2 * c5;
    let w_L4_in_J5_2_5 = s4_2 * s5_2;
    let w_L5_in_L6_1_5 = w_L4_in_J5_1_5.mul_add(c6, c4 * s6);
    let w_L5_in_L6_2_5 = (-c4).mul_add(c6, w_L4_in_J5_1_5 * s6);
    let v_C2_2_5 = a2_plus_x2;
    let v_L2_in_J3_1_4 = a2 * s3_2;
    let v_L2_in_J3_2_4 = a2 * c3;
    let v_C3_2_9 = a3 + v_L2_in_J3_2_4;
    let v_C3_1_9 = z3 - v_L2_in_J3_1_4;
    let v_C3_3_9 = x3 + v_C3_2_9;
    let v_C4_1_7 = d4 - v_L2_in_J3_1_4;
    let v_L3_in_J4_1_5 = v_C4_1_7 * c4;
    let v_L3_in_J4_2_5 = v_C4_1_7 * s4_2;
    let y4_c4 = y4 * c4;
    let v_C4_1_8 = v_L3_in_J4_1_5 + y4_c4;
    let y4_s4_2 = y4 * s4_2;
    let v_C4_3_5 = v_L3_in_J4_2_5 + y4_s4_2;
    let H_wrist1_1_5 = Ixx4 * s4_2;
    let H_wrist1_3_5 = Ixx4 * c4;
    let H_wrist2_1_5 = Ixx5 * w_L4_in_J5_1_5;
    let H_wrist2_2_5 = Iyy5 * c4;
    let H_wrist2_3_5 = Ixx5 * w_L4_in_J5_2_5;
    let v_L4_in_J5_1_5 = (-v_C3_2_9).mul_add(s5_2, v_L3_in_J4_1_5 * c5);
    let v_L4_in_J5_2_5 = v_L3_in_J4_1_5.mul_add(s5_2, v_C3_2_9 * c5);
    let v_L5_in_L6_1_5 = (-v_L3_in_J4_2_5).mul_add(s6, v_L4_in_J5_1_5 * c6);
    let v_L5_in_L6_2_5 = v_L4_in_J5_1_5.mul_add(s6, v_L3_in_J4_2_5 * c6);
    let z6_w_l5_in_l6_2_5 = z6 * w_L5_in_L6_2_5;
    let v_C6_1_5 = z6_w_l5_in_l6_2_5 - v_L5_in_L6_1_5;
    let z6_w_l5_in_l6_1_5 = z6 * w_L5_in_L6_1_5;
    let v_C6_2_5 = v_L5_in_L6_2_5 + z6_w_l5_in_l6_1_5;
    let H_flange_1_5 = Ixx6 * w_L5_in_L6_1_5;
    let H_flange_2_5 = Ixx6 * w_L5_in_L6_2_5;
    let H_flange_3_5 = Izz6 * w_L4_in_J5_2_5;
    let p_v_C6_2_5 = m6 * v_C6_2_5;
    let p_v_C6_1_5 = m6 * v_C6_1_5;
    let p_v_L4_in_J5_2_5 = m6 * v_L4_in_J5_2_5;
    let p_v_L4_in_J5_1_5 = (-p_v_C6_1_5).mul_add(c6, p_v_C6_2_5 * s6);
    let p_v_C4_3_5 = m4 * v_C4_3_5;
    let p_v_C4_1_9 = m4 * v_C4_1_8;
    let p_v_L3_in_J4_2_5 = p_v_C6_1_5.mul_add(s6, p_v_C6_2_5 * c6) + p_v_C4_3_5;
    let p_v_L3_in_J4_1_5 = p_v_L4_in_J5_1_5.mul_add(c5, p_v_L4_in_J5_2_5 * s5_2) + p_v_C4_1_9;
    let p_v_C4_2_5 = (-p_v_L3_in_J4_1_5).mul_add(s4_2, p_v_L3_in_J4_2_5 * c4);
    let p_v_C4_1_10 = p_v_L3_in_J4_2_5.mul_add(s4_2, m5 * v_C4_1_7) + p_v_L3_in_J4_1_5 * c4;
    let p_v_C3_3_9 = m3 * v_C3_3_9;
    let p_v_C3_1_9 = m3 * v_C3_1_9;
    let p_v_C3_2_9 = (-p_v_L4_in_J5_1_5).mul_add(s5_2, p_v_L4_in_J5_2_5 * c5)
        + p_v_C3_3_9 + v_C3_2_9 * m4_plus_m5;
    let p_v_C3_1_10 = p_v_C4_1_10 + p_v_C3_1_9;
    let p_v_C2_2_5 = m2 * v_C2_2_5;
    let p_w_L5_in_L6_2_5 = z6.mul_add(p_v_C6_1_5, H_flange_2_5);
    let p_w_L5_in_L6_1_5 = z6.mul_add(p_v_C6_2_5, H_flange_1_5);
    let p_w_J5_3_5 = (-p_w_L5_in_L6_2_5).mul_add(c6, H_wrist2_2_5) + p_w_L5_in_L6_1_5 * s6;
    let p_w_L4_in_J5_2_5 = H_wrist2_3_5 + H_flange_3_5;
    let p_w_L4_in_J5_1_5 = p_w_L5_in_L6_2_5.mul_add(s6, H_wrist2_1_5) + p_w_L5_in_L6_1_5 * c6;
    let c5_p_w_l4_in_j5_2_5 = p_w_L4_in_J5_2_5 * c5;
    let p_w_J4_3_5 = (-p_w_L4_in_J5_1_5).mul_add(s5_2, c5_p_w_l4_in_j5_2_5);
    let p_w_L3_in_J4_2_5 = y4.mul_add(p_v_C4_1_9, H_wrist1_3_5) + p_w_J5_3_5;
    let p_w_L3_in_J4_1_5_of_place = p_w_L4_in_J5_2_5.mul_add(s5_2, H_wrist1_1_5);
    let p_w_L3_in_J4_1_5 = p_w_L4_in_J5_1_5.mul_add(c5, y4 * p_v_C4_3_5)
        + p_w_L3_in_J4_1_5_of_place;
    let p_w_L2_in_J3_2_5 = y3.mul_add(p_v_C3_1_9, a3 * p_v_C4_2_5) - d3 * p_v_C3_1_10 + p_w_J4_3_5;
    let p_w_L2_in_J3_1_5 = (-y3).mul_add(p_v_C3_3_9, d4 * p_v_C4_2_5) + d3 * p_v_C3_2_9
        - p_w_L3_in_J4_2_5 * s4_2 + p_w_L3_in_J4_1_5 * c4;
    let p_w_L1_in_L2_2_5 = (-z2).mul_add(mp_L2_2, a2 * p_v_C4_2_5)
        + p_w_L2_in_J3_2_5 * c3 - p_w_L2_in_J3_1_5 * s3_2;
    let p_w_L1_in_L2_1_5 = p_w_L2_in_J3_2_5.mul_add(s3_2, z2 * p_v_C2_2_5) + p_w_L2_in_J3_1_5 * c3;
    let v_C3_3_10 = a3 + x3;
    let v_L3_in_J4_1_6 = d4 * c4;
    let v_L3_in_J4_2_6 = d4 * s4_2;
    let v_C4_1_9 = v_L3_in_J4_1_6 + y4_c4;
    let v_C4_3_6 = v_L3_in_J4_2_6 + y4_s4_2;
    let v_L4_in_J5_1_6 = (-a3).mul_add(s5_2, v_L3_in_J4_1_6 * c5);
    let v_L4_in_J5_2_6 = v_L3_in_J4_1_6.mul_add(s5_2, a3 * c5);
    let v_L5_in_L6_1_6 = (-v_L3_in_J4_2_6).mul_add(s6, v_L4_in_J5_1_6 * c6);
    let v_L5_in_L6_2_6 = v_L4_in_J5_1_6.mul_add(s6, v_L3_in_J4_2_6 * c6);
    let v_C6_1_6 = z6_w_l5_in_l6_2_5 - v_L5_in_L6_1_6;
    let v_C6_2_6 = v_L5_in_L6_2_6 + z6_w_l5_in_l6_1_5;
    let p_v_C6_2_6 = m6 * v_C6_2_6;
    let p_v_C6_1_6 = m6 * v_C6_1_6;
    let p_v_L4_in_J5_2_6 = m6 * v_L4_in_J5_2_6;
    let p_v_L4_in_J5_1_6 = (-p_v_C6_1_6).mul_add(c6, p_v_C6_2_6 * s6);
    let p_v_C4_3_6 = m4 * v_C4_3_6;
    let p_v_C4_1_11 = m4 * v_C4_1_9;
    let p_v_L3_in_J4_2_6 = p_v_C6_1_6.mul_add(s6, p_v_C6_2_6 * c6) + p_v_C4_3_6;
    let p_v_L3_in_J4_1_6 = p_v_L4_in_J5_1_6.mul_add(c5, p_v_L4_in_J5_2_6 * s5_2) + p_v_C4_1_11;
    let p_v_C4_2_6 = (-p_v_L3_in_J4_1_6).mul_add(s4_2, p_v_L3_in_J4_2_6 * c4);
    let p_v_C4_1_12 = p_v_L3_in_J4_2_6.mul_add(s4_2, d4 * m5) + p_v_L3_in_J4_1_6 * c4;
    let p_v_C3_3_10 = m3 * v_C3_3_10;
    let p_v_C3_1_11 = m3 * z3;
    let p_v_C3_2_10 = (-p_v_L4_in_J5_1_6).mul_add(s5_2, p_v_L4_in_J5_2_6 * c5)
        + p_v_C3_3_10 + a3 * m4_plus_m5;
    let p_v_C3_1_12 = p_v_C4_1_12 + p_v_C3_1_11;
    let p_w_L5_in_L6_2_6 = z6.mul_add(p_v_C6_1_6, H_flange_2_5);
    let p_w_L5_in_L6_1_6 = z6.mul_add(p_v_C6_2_6, H_flange_1_5);
    let p_w_J5_3_6 = (-p_w_L5_in_L6_2_6).mul_add(c6, H_wrist2_2_5) + p_w_L5_in_L6_1_6 * s6;
    let p_w_L4_in_J5_1_6 = p_w_L5_in_L6_2_6.mul_add(s6, H_wrist2_1_5) + p_w_L5_in_L6_1_6 * c6;
    let p_w_J4_3_6 = (-p_w_L4_in_J5_1_6).mul_add(s5_2, c5_p_w_l4_in_j5_2_5);
    let p_w_L3_in_J4_2_6 = y4.mul_add(p_v_C4_1_11, H_wrist1_3_5) + p_w_J5_3_6;
    let p_w_L3_in_J4_1_6 = p_w_L4_in_J5_1_6.mul_add(c5, y4 * p_v_C4_3_6)
        + p_w_L3_in_J4_1_5_of_place;
    let p_w_L2_in_J3_2_6 = y3.mul_add(p_v_C3_1_11, a3 * p_v_C4_2_6) - d3 * p_v_C3_1_12 + p_w_J4_3_6;
    let p_w_L2_in_J3_1_6 = (-y3).mul_add(p_v_C3_3_10, d4 * p_v_C4_2_6) + d3 * p_v_C3_2_10
        - p_w_L3_in_J4_2_6 * s4_2 + p_w_L3_in_J4_1_6 * c4;
    let p_w_L1_in_L2_2_6 = p_w_L2_in_J3_2_6.mul_add(c3, a2 * p_v_C4_2_6) - p_w_L2_in_J3_1_6 * s3_2;
    let p_w_L1_in_L2_1_6 = p_w_L2_in_J3_1_6.mul_add(c3, p_w_L2_in_J3_2_6 * s3_2);
    let w_L5_in_L6_1_6 = s5_2 * c6;
    let w_L5_in_L6_2_6 = s5_2 * s6;
    let H_wrist2_1_6 = Ixx5 * s5_2;
    let H_wrist2_3_6 = Ixx5 * c5;
    let v_C6_1_7 = z6 * w_L5_in_L6_2_6;
    let v_C6_2_7 = z6 * w_L5_in_L6_1_6;
    let H_flange_1_6 = Ixx6 * w_L5_in_L6_1_6;
    let H_flange_2_6 = Ixx6 * w_L5_in_L6_2_6;
    let H_flange_3_6 = Izz6 * c5;
    let p_v_C6_2_7 = m6 * v_C6_2_7;
    let p_v_C6_1_7 = m6 * v_C6_1_7;
    let p_v_L4_in_J5_1_7 = (-p_v_C6_1_7).mul_add(c6, p_v_C6_2_7 * s6);
    let p_v_L3_in_J4_2_7 = p_v_C6_1_7.mul_add(s6, p_v_C6_2_7 * c6);
    let p_v_L3_in_J4_1_7 = p_v_L4_in_J5_1_7 * c5;
    let p_v_C4_2_7 = (-p_v_L3_in_J4_1_7).mul_add(s4_2, p_v_L3_in_J4_2_7 * c4);
    let p_v_C4_1_13 = p_v_L3_in_J4_1_7.mul_add(c4, p_v_L3_in_J4_2_7 * s4_2);
    let p_v_C3_2_11 = p_v_L4_in_J5_1_7 * s5_2;
    let p_w_L5_in_L6_2_7 = z6.mul_add(p_v_C6_1_7, H_flange_2_6);
    let p_w_L5_in_L6_1_7 = z6.mul_add(p_v_C6_2_7, H_flange_1_6);
    let p_w_J5_3_7 = (-p_w_L5_in_L6_1_7).mul_add(s6, p_w_L5_in_L6_2_7 * c6);
    let p_w_L4_in_J5_2_6 = H_wrist2_3_6 + H_flange_3_6;
    let p_w_L4_in_J5_1_7 = p_w_L5_in_L6_2_7.mul_add(s6, H_wrist2_1_6) + p_w_L5_in_L6_1_7 * c6;
    let p_w_J4_3_7 = p_w_L4_in_J5_2_6.mul_add(c5, Iyy4) + p_w_L4_in_J5_1_7 * s5_2;
    let p_w_L3_in_J4_1_7 = (-p_w_L4_in_J5_1_7).mul_add(c5, p_w_L4_in_J5_2_6 * s5_2);
    let p_w_L2_in_J3_2_7 = (-d3).mul_add(p_v_C4_1_13, a3 * p_v_C4_2_7) - p_w_J4_3_7;
    let p_w_L2_in_J3_1_7 = (-d3).mul_add(p_v_C3_2_11, d4 * p_v_C4_2_7)
        + p_w_J5_3_7 * s4_2 - p_w_L3_in_J4_1_7 * c4;
    let p_w_L1_in_L2_2_7 = p_w_L2_in_J3_2_7.mul_add(c3, a2 * p_v_C4_2_7) - p_w_L2_in_J3_1_7 * s3_2;
    let p_w_L1_in_L2_1_7 = p_w_L2_in_J3_1_7.mul_add(c3, p_w_L2_in_J3_2_7 * s3_2);
    let v_C6_1_8 = z6 * c6;
    let v_C6_2_8 = z6 * s6;
    let H_flange_1_7 = Ixx6 * s6;
    let H_flange_2_7 = Ixx6 * c6;
    let p_v_C6_2_8 = m6 * v_C6_2_8;
    let p_v_C6_1_8 = m6 * v_C6_1_8;
    let p_v_L4_in_J5_1_8 = p_v_C6_1_8.mul_add(c6, p_v_C6_2_8 * s6);
    let p_v_L3_in_J4_2_8 = (-p_v_C6_1_8).mul_add(s6, p_v_C6_2_8 * c6);
    let p_v_L3_in_J4_1_8 = p_v_L4_in_J5_1_8 * c5;
    let p_v_C4_2_8 = (-p_v_L3_in_J4_1_8).mul_add(s4_2, p_v_L3_in_J4_2_8 * c4);
    let p_v_C4_1_14 = p_v_L3_in_J4_1_8.mul_add(c4, p_v_L3_in_J4_2_8 * s4_2);
    let p_v_C3_2_12 = p_v_L4_in_J5_1_8 * s5_2;
    let p_w_L5_in_L6_2_8 = z6.mul_add(p_v_C6_1_8, H_flange_2_7);
    let p_w_L5_in_L6_1_8 = z6.mul_add(p_v_C6_2_8, H_flange_1_7);
    let p_w_J5_3_8 = p_w_L5_in_L6_2_8.mul_add(c6, Iyy5) + p_w_L5_in_L6_1_8 * s6;
    let p_w_L4_in_J5_1_8 = (-p_w_L5_in_L6_1_8).mul_add(c6, p_w_L5_in_L6_2_8 * s6);
    let p_w_J4_3_8 = p_w_L4_in_J5_1_8 * s5_2;
    let p_w_L3_in_J4_1_8 = p_w_L4_in_J5_1_8 * c5;
    let p_w_L2_in_J3_2_8 = (-d3).mul_add(p_v_C4_1_14, a3 * p_v_C4_2_8) + p_w_J4_3_8;
    let p_w_L2_in_J3_1_8 = (-d3).mul_add(p_v_C3_2_12, d4 * p_v_C4_2_8)
        - p_w_J5_3_8 * s4_2 - p_w_L3_in_J4_1_8 * c4;
    let p_w_L1_in_L2_2_8 = p_w_L2_in_J3_2_8.mul_add(c3, a2 * p_v_C4_2_8) - p_w_L2_in_J3_1_8 * s3_2;
    let p_w_L1_in_L2_1_8 = p_w_L2_in_J3_1_8.mul_add(c3, p_w_L2_in_J3_2_8 * s3_2);
    let p_w_L3_in_J4_1_9 = Izz6 * s5_2;
    let p_w_L2_in_J3_1_9 = p_w_L3_in_J4_1_9 * c4;
    let p_w_L1_in_L2_2_9 = (-p_w_L2_in_J3_1_9).mul_add(s3_2, H_flange_3_6 * c3);
    let p_w_L1_in_L2_1_9 = p_w_L2_in_J3_1_9.mul_add(c3, H_flange_3_6 * s3_2);
    let p_w_J3_3_3 = d4.mul_add(p_v_C4_1_10, Iyy3) + x3 * p_v_C3_3_9 + z3 * p_v_C3_1_9
        + a3 * p_v_C3_2_9 + p_w_L3_in_J4_2_5 * c4 + p_w_L3_in_J4_1_5 * s4_2;
    let p_w_J3_3_4 = d4.mul_add(p_v_C4_1_12, Iyy3) + x3 * p_v_C3_3_10 + z3 * p_v_C3_1_11
        + a3 * p_v_C3_2_10 + p_w_L3_in_J4_2_6 * c4 + p_w_L3_in_J4_1_6 * s4_2;
    let p_w_J3_3_5 = (-a3).mul_add(p_v_C3_2_11, d4 * p_v_C4_1_13) - p_w_J5_3_7 * c4
        - p_w_L3_in_J4_1_7 * s4_2;
    let p_w_J3_3_6 = (-a3).mul_add(p_v_C3_2_12, d4 * p_v_C4_1_14) + p_w_J5_3_8 * c4
        - p_w_L3_in_J4_1_8 * s4_2;
    let p_w_J3_3_7 = p_w_L3_in_J4_1_9 * s4_2;
    // Entries that are not zero; upper triangle.
    let m11 = p_w_L1_in_L2_2_4.mul_add(c2, I1) + p_w_L1_in_L2_1_4 * s2_2;
    let m12 = (-p_w_L1_in_L2_1_5).mul_add(s2_2, p_w_L1_in_L2_2_5 * c2);
    let m13 = (-p_w_L1_in_L2_1_6).mul_add(s2_2, p_w_L1_in_L2_2_6 * c2);
    let m14 = (-p_w_L1_in_L2_2_7).mul_add(c2, p_w_L1_in_L2_1_7 * s2_2);
    let m15 = (-p_w_L1_in_L2_1_8).mul_add(s2_2, p_w_L1_in_L2_2_8 * c2);
    let m16 = (-p_w_L1_in_L2_1_9).mul_add(s2_2, p_w_L1_in_L2_2_9 * c2);
    let m22 = Izz2 + y2 * mp_L2_2 + a2 * (-p_v_C3_1_10).mul_add(s3_2, p_v_C3_2_9 * c3)
        + p_w_J3_3_3 + p_v_C2_2_5 * a2_plus_x2;
    let m23 = a2 * (-p_v_C3_1_12).mul_add(s3_2, p_v_C3_2_10 * c3) + p_w_J3_3_4;
    let m24 = a2 * p_v_C3_2_11.mul_add(c3, p_v_C4_1_13 * s3_2) - p_w_J3_3_5;
    let m25 = p_w_J3_3_6 - a2 * p_v_C3_2_12.mul_add(c3, p_v_C4_1_14 * s3_2);
    let m34 = -p_w_J3_3_5;
    let m66 = Izz6;
    let zero = S::int(0);
    [
        [m11, m12, m13, m14, m15, m16],
        [m12, m22, m23, m24, m25, p_w_J3_3_7],
        [m13, m23, p_w_J3_3_4, m34, p_w_J3_3_6, p_w_J3_3_7],
        [m14, m24, m34, p_w_J4_3_7, p_w_J4_3_8, H_flange_3_6],
        [m15, m25, p_w_J3_3_6, p_w_J4_3_8, p_w_J5_3_8, zero],
        [m16, p_w_J3_3_7, p_w_J3_3_7, H_flange_3_6, zero, m66],
    ]
}

/// Right-hand side of the linear system; unknowns (q1'', q2'', q3'', q4'', q5'', q6'').
///
/// 676 operations, 5 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 6], q_dot: &[S; 6]) -> [S; 6] {
    let Parameters {
        g, a2, a3, d3, d4, m2, m3, m4, m5, m6, x2, y2, z2, x3, y3, z3, y4, z6, Ixx2, Iyy2, Ixx3,
        Izz3, Ixx4, Iyy4, Ixx5, Iyy5, Ixx6, Izz6, tau1, tau2, tau3, tau4, tau5, tau6,
        ..
    } = *p;
    let [_, q2, q3, q4, q5, q6] = *q;
    let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot, q6_dot] = *q_dot;
    // Sines and cosines.
    let (s2_2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    let (s4_2, c4) = q4.sin_cos();
    let (s5_2, c5) = q5.sin_cos();
    let (s6, c6) = q6.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_L1_in_L2_1 = q1_dot * s2_2;
    let w_L1_in_L2_2 = q1_dot * c2;
    let w_L2_in_J3_1 = w_L1_in_L2_2.mul_add(s3_2, w_L1_in_L2_1 * c3);
    let w_L2_in_J3_2 = (-w_L1_in_L2_2).mul_add(c3, w_L1_in_L2_1 * s3_2);
    let w_J3_3 = q2_dot + q3_dot;
    let w_L3_in_J4_1 = (-w_J3_3).mul_add(s4_2, w_L2_in_J3_1 * c4);
    let w_L3_in_J4_2 = w_J3_3.mul_add(c4, w_L2_in_J3_1 * s4_2);
    let w_J4_3 = q4_dot - w_L2_in_J3_2;
    let w_L4_in_J5_1 = w_J4_3.mul_add(s5_2, w_L3_in_J4_1 * c5);
    let w_L4_in_J5_2 = (-w_J4_3).mul_add(c5, w_L3_in_J4_1 * s5_2);
    let w_J5_3 = q5_dot + w_L3_in_J4_2;
    let w_L5_in_L6_1 = (-w_J5_3).mul_add(s6, w_L4_in_J5_1 * c6);
    let w_L5_in_L6_2 = w_J5_3.mul_add(c6, w_L4_in_J5_1 * s6);
    let w_L6_3 = q6_dot - w_L4_in_J5_2;
    let v_C2_1 = (-y2).mul_add(q2_dot, z2 * w_L1_in_L2_2);
    let a2_q2_dot = a2 * q2_dot;
    let v_C2_2 = (-z2).mul_add(w_L1_in_L2_1, x2 * q2_dot) + a2_q2_dot;
    let a2_plus_x2 = a2 + x2;
    let v_C2_3 = (-y2).mul_add(w_L1_in_L2_1, w_L1_in_L2_2 * a2_plus_x2);
    let H_upper_arm_1 = Ixx2 * w_L1_in_L2_1;
    let H_upper_arm_2 = Iyy2 * w_L1_in_L2_2;
    let v_L2_in_J3_1 = a2_q2_dot * s3_2;
    let v_L2_in_J3_2 = a2_q2_dot * c3;
    let v_L2_in_J3_3 = a2 * w_L1_in_L2_2;
    let v_C3_1 = d3.mul_add(w_L2_in_J3_2, -v_L2_in_J3_1);
    let v_C3_2 = (-d3).mul_add(w_L2_in_J3_1, a3 * w_J3_3) + v_L2_in_J3_2;
    let v_C3_3 = a3.mul_add(w_L2_in_J3_2, -v_L2_in_J3_3);
    let v_C3_1_2 = (-y3).mul_add(w_L2_in_J3_2, z3 * w_J3_3) + v_C3_1;
    let v_C3_2_2 = x3.mul_add(w_L2_in_J3_2, z3 * w_L2_in_J3_1) + v_C3_3;
    let v_C3_3_2 = x3.mul_add(w_J3_3, y3 * w_L2_in_J3_1) + v_C3_2;
    let H_forearm_1 = Ixx3 * w_L2_in_J3_1;
    let H_forearm_3 = Izz3 * w_L2_in_J3_2;
    let v_C4_1 = d4.mul_add(w_J3_3, v_C3_1);
    let v_C4_2 = d4.mul_add(w_L2_in_J3_1, v_C3_3);
    let v_L3_in_J4_1 = v_C4_2.mul_add(s4_2, v_C4_1 * c4);
    let v_L3_in_J4_2_of_place = (-v_C4_1).mul_add(s4_2, v_C4_2 * c4);
    let v_L3_in_J4_2 = -v_L3_in_J4_2_of_place;
    let v_C4_1_2 = y4.mul_add(w_L3_in_J4_2, v_L3_in_J4_1);
    let v_C4_3 = y4.mul_add(w_L3_in_J4_1, -v_L3_in_J4_2);
    let H_wrist1_1 = Ixx4 * w_L3_in_J4_1;
    let H_wrist1_2 = Iyy4 * w_J4_3;
    let H_wrist1_3 = Ixx4 * w_L3_in_J4_2;
    let H_wrist2_1 = Ixx5 * w_L4_in_J5_1;
    let H_wrist2_2 = Iyy5 * w_J5_3;
    let H_wrist2_3 = Ixx5 * w_L4_in_J5_2;
    let v_L4_in_J5_1 = (-v_C3_2).mul_add(s5_2, v_L3_in_J4_1 * c5);
    let v_L4_in_J5_2 = v_L3_in_J4_1.mul_add(s5_2, v_C3_2 * c5);
    let v_L5_in_L6_1 = (-v_L3_in_J4_2).mul_add(s6, v_L4_in_J5_1 * c6);
    let v_L5_in_L6_2 = v_L4_in_J5_1.mul_add(s6, v_L3_in_J4_2 * c6);
    let v_C6_1 = z6.mul_add(w_L5_in_L6_2, v_L5_in_L6_1);
    let v_C6_2 = z6.mul_add(w_L5_in_L6_1, -v_L5_in_L6_2);
    let H_flange_1 = Ixx6 * w_L5_in_L6_1;
    let H_flange_2 = Ixx6 * w_L5_in_L6_2;
    let H_flange_3 = Izz6 * w_L6_3;
    let p_v_C6_2 = m6 * v_C6_2;
    let p_v_C6_1 = m6 * v_C6_1;
    let p_v_L4_in_J5_2 = m6 * v_L4_in_J5_2;
    let p_v_L4_in_J5_1_of_place = (-p_v_C6_2).mul_add(s6, p_v_C6_1 * c6);
    let p_v_L4_in_J5_1 = -p_v_L4_in_J5_1_of_place;
    let p_v_C4_3 = m4 * v_C4_3;
    let p_v_C4_1 = m4 * v_C4_1_2;
    let p_v_L3_in_J4_2_of_place = p_v_C6_1.mul_add(s6, p_v_C6_2 * c6);
    let p_v_L3_in_J4_2 = p_v_C4_3 + p_v_L3_in_J4_2_of_place;
    let p_v_L3_in_J4_1_of_place = (-p_v_L4_in_J5_2).mul_add(s5_2, p_v_L4_in_J5_1 * c5);
    let p_v_L3_in_J4_1 = p_v_C4_1 - p_v_L3_in_J4_1_of_place;
    let p_v_C4_2_of_place = p_v_L3_in_J4_1.mul_add(s4_2, p_v_L3_in_J4_2 * c4);
    let p_v_C4_2 = m5.mul_add(v_C4_2, p_v_C4_2_of_place);
    let p_v_C4_1_2_of_place = (-p_v_L3_in_J4_2).mul_add(s4_2, p_v_L3_in_J4_1 * c4);
    let p_v_C4_1_2 = m5.mul_add(v_C4_1, p_v_C4_1_2_of_place);
    let p_v_C3_3 = m3 * v_C3_3_2;
    let p_v_C3_2 = m3 * v_C3_2_2;
    let p_v_C3_1 = m3 * v_C3_1_2;
    let p_v_C3_3_2 = p_v_C4_2 + p_v_C3_2;
    let m4_plus_m5 = m4 + m5;
    let p_v_C3_2_2_of_place = p_v_L4_in_J5_1.mul_add(s5_2, p_v_L4_in_J5_2 * c5);
    let p_v_C3_2_2 = v_C3_2.mul_add(m4_plus_m5, p_v_C3_3) + p_v_C3_2_2_of_place;
    let p_v_C3_1_2 = p_v_C4_1_2 + p_v_C3_1;
    let p_v_C2_3 = m2 * v_C2_3;
    let p_v_C2_2 = m2 * v_C2_2;
    let p_v_C2_1 = m2 * v_C2_1;
    let p_w_L5_in_L6_2 = z6.mul_add(p_v_C6_1, H_flange_2);
    let p_w_L5_in_L6_1 = z6.mul_add(p_v_C6_2, H_flange_1);
    let p_w_J5_3_of_place = (-p_w_L5_in_L6_1).mul_add(s6, p_w_L5_in_L6_2 * c6);
    let p_w_J5_3 = H_wrist2_2 + p_w_J5_3_of_place;
    let p_w_L4_in_J5_2 = H_wrist2_3 - H_flange_3;
    let p_w_L4_in_J5_1_of_place = p_w_L5_in_L6_1.mul_add(c6, p_w_L5_in_L6_2 * s6);
    let p_w_L4_in_J5_1 = H_wrist2_1 + p_w_L4_in_J5_1_of_place;
    let p_w_J4_3_of_place = (-p_w_L4_in_J5_1).mul_add(s5_2, p_w_L4_in_J5_2 * c5);
    let p_w_J4_3 = H_wrist1_2 - p_w_J4_3_of_place;
    let p_w_L3_in_J4_2 = y4.mul_add(p_v_C4_1, H_wrist1_3) + p_w_J5_3;
    let p_w_L3_in_J4_1_of_place = p_w_L4_in_J5_1.mul_add(c5, p_w_L4_in_J5_2 * s5_2);
    let p_w_L3_in_J4_1 = y4.mul_add(p_v_C4_3, H_wrist1_1) + p_w_L3_in_J4_1_of_place;
    let p_w_L2_in_J3_2 = x3.mul_add(p_v_C3_2, H_forearm_3) - y3 * p_v_C3_1
        + a3 * p_v_C3_3_2 + d3 * p_v_C3_1_2 - p_w_J4_3;
    let p_w_L2_in_J3_1_of_place = p_w_L3_in_J4_1.mul_add(c4, p_w_L3_in_J4_2 * s4_2);
    let p_w_L2_in_J3_1 = d4.mul_add(p_v_C4_2, H_forearm_1) + y3 * p_v_C3_3
        + z3 * p_v_C3_2 - d3 * p_v_C3_2_2 + p_w_L2_in_J3_1_of_place;
    let p_w_L1_in_L2_2_of_place = (-p_w_L2_in_J3_1).mul_add(s3_2, p_w_L2_in_J3_2 * c3);
    let p_w_L1_in_L2_2 = (-a2).mul_add(p_v_C3_3_2, H_upper_arm_2) + z2 * p_v_C2_1
        + p_v_C2_3 * a2_plus_x2 - p_w_L1_in_L2_2_of_place;
    let p_w_L1_in_L2_1_of_place = p_w_L2_in_J3_1.mul_add(c3, p_w_L2_in_J3_2 * s3_2);
    let p_w_L1_in_L2_1 = (-y2).mul_add(p_v_C2_3, H_upper_arm_1) - z2 * p_v_C2_2
        + p_w_L1_in_L2_1_of_place;
    let w_L1_in_L2_1_2 = q2_dot * w_L1_in_L2_2;
    let w_L1_in_L2_2_2 = q2_dot * w_L1_in_L2_1;
    let w_L2_in_J3_1_2 = (-q3_dot).mul_add(w_L2_in_J3_2, w_L1_in_L2_1_2 * c3)
        - w_L1_in_L2_2_2 * s3_2;
    let w_L2_in_J3_2_2 = w_L1_in_L2_1_2.mul_add(s3_2, q3_dot * w_L2_in_J3_1) + w_L1_in_L2_2_2 * c3;
    let w_L3_in_J4_1_2 = (-q4_dot).mul_add(w_L3_in_J4_2, w_L2_in_J3_1_2 * c4);
    let w_L3_in_J4_2_2 = w_L2_in_J3_1_2.mul_add(s4_2, q4_dot * w_L3_in_J4_1);
    let w_L4_in_J5_1_2 = (-q5_dot).mul_add(w_L4_in_J5_2, w_L3_in_J4_1_2 * c5)
        - w_L2_in_J3_2_2 * s5_2;
    let w_L4_in_J5_2_2 = w_L2_in_J3_2_2.mul_add(c5, q5_dot * w_L4_in_J5_1) + w_L3_in_J4_1_2 * s5_2;
    let w_L5_in_L6_1_2 = (-q6_dot).mul_add(w_L5_in_L6_2, w_L4_in_J5_1_2 * c6) - w_L3_in_J4_2_2 * s6;
    let w_L5_in_L6_2_2 = w_L3_in_J4_2_2.mul_add(c6, q6_dot * w_L5_in_L6_1) + w_L4_in_J5_1_2 * s6;
    let v_C2_1_2 = z2 * w_L1_in_L2_2_2;
    let v_C2_2_2 = z2 * w_L1_in_L2_1_2;
    let v_C2_3_2 = w_L1_in_L2_2_2.mul_add(a2_plus_x2, y2 * w_L1_in_L2_1_2);
    let H_upper_arm_1_2 = Ixx2 * w_L1_in_L2_1_2;
    let H_upper_arm_2_2 = Iyy2 * w_L1_in_L2_2_2;
    let v_L2_in_J3_1_2 = q3_dot * v_L2_in_J3_2;
    let v_L2_in_J3_2_2 = q3_dot * v_L2_in_J3_1;
    let v_L2_in_J3_3_2 = a2 * w_L1_in_L2_2_2;
    let v_C3_1_3 = d3.mul_add(w_L2_in_J3_2_2, -v_L2_in_J3_1_2);
    let v_C3_2_3 = d3.mul_add(w_L2_in_J3_1_2, v_L2_in_J3_2_2);
    let v_C3_3_3 = a3.mul_add(w_L2_in_J3_2_2, v_L2_in_J3_3_2);
    let v_C3_1_4 = y3.mul_add(w_L2_in_J3_2_2, -v_C3_1_3);
    let v_C3_2_4 = x3.mul_add(w_L2_in_J3_2_2, z3 * w_L2_in_J3_1_2) + v_C3_3_3;
    let v_C3_3_4 = y3.mul_add(w_L2_in_J3_1_2, -v_C3_2_3);
    let H_forearm_1_2 = Ixx3 * w_L2_in_J3_1_2;
    let H_forearm_3_2 = Izz3 * w_L2_in_J3_2_2;
    let v_C4_2_2 = d4.mul_add(w_L2_in_J3_1_2, v_C3_3_3);
    let v_L3_in_J4_1_2 = (-v_C4_2_2).mul_add(s4_2, -v_C3_1_3 * c4) - q4_dot * v_L3_in_J4_2_of_place;
    let v_L3_in_J4_2_2 = v_C3_1_3.mul_add(s4_2, q4_dot * v_L3_in_J4_1) - v_C4_2_2 * c4;
    let v_C4_1_3 = y4.mul_add(w_L3_in_J4_2_2, -v_L3_in_J4_1_2);
    let v_C4_3_2 = y4.mul_add(w_L3_in_J4_1_2, -v_L3_in_J4_2_2);
    let H_wrist1_1_2 = Ixx4 * w_L3_in_J4_1_2;
    let H_wrist1_2_2 = Iyy4 * w_L2_in_J3_2_2;
    let H_wrist1_3_2 = Ixx4 * w_L3_in_J4_2_2;
    let H_wrist2_1_2 = Ixx5 * w_L4_in_J5_1_2;
    let H_wrist2_2_2 = Iyy5 * w_L3_in_J4_2_2;
    let H_wrist2_3_2 = Ixx5 * w_L4_in_J5_2_2;
    let v_L4_in_J5_1_2 = (-v_C3_2_3).mul_add(s5_2, q5_dot * v_L4_in_J5_2) + v_L3_in_J4_1_2 * c5;
    let v_L4_in_J5_2_2 = (-v_C3_2_3).mul_add(c5, q5_dot * v_L4_in_J5_1) - v_L3_in_J4_1_2 * s5_2;
    let v_L5_in_L6_1_2 = v_L3_in_J4_2_2.mul_add(s6, q6_dot * v_L5_in_L6_2) + v_L4_in_J5_1_2 * c6;
    let v_L5_in_L6_2_2 = v_L3_in_J4_2_2.mul_add(c6, q6_dot * v_L5_in_L6_1) - v_L4_in_J5_1_2 * s6;
    let v_C6_1_2 = z6.mul_add(w_L5_in_L6_2_2, -v_L5_in_L6_1_2);
    let v_C6_2_2 = z6.mul_add(w_L5_in_L6_1_2, -v_L5_in_L6_2_2);
    let H_flange_1_2 = Ixx6 * w_L5_in_L6_1_2;
    let H_flange_2_2 = Ixx6 * w_L5_in_L6_2_2;
    let H_flange_3_2 = Izz6 * w_L4_in_J5_2_2;
    let p_v_C6_2_2 = m6 * v_C6_2_2;
    let p_v_C6_1_2 = m6 * v_C6_1_2;
    let p_v_L4_in_J5_2_2 = m6 * v_L4_in_J5_2_2;
    let p_v_L4_in_J5_1_2 = (-p_v_C6_1_2).mul_add(c6, p_v_C6_2_2 * s6)
        + q6_dot * p_v_L3_in_J4_2_of_place;
    let p_v_C4_3_2 = m4 * v_C4_3_2;
    let p_v_C4_1_3 = m4 * v_C4_1_3;
    let p_v_L3_in_J4_2_2 = (-p_v_C6_1_2).mul_add(s6, -p_v_C6_2_2 * c6) - p_v_C4_3_2
        - q6_dot * p_v_L4_in_J5_1_of_place;
    let p_v_L3_in_J4_1_2 = (-p_v_L4_in_J5_1_2).mul_add(c5, p_v_L4_in_J5_2_2 * s5_2)
        + p_v_C4_1_3 + q5_dot * p_v_C3_2_2_of_place;
    let p_v_C4_2_2 = (-p_v_L3_in_J4_2_2).mul_add(c4, m5 * v_C4_2_2)
        + p_v_L3_in_J4_1_2 * s4_2 + q4_dot * p_v_C4_1_2_of_place;
    let p_v_C4_1_4 = p_v_L3_in_J4_2_2.mul_add(s4_2, m5 * v_C3_1_3)
        + p_v_L3_in_J4_1_2 * c4 - q4_dot * p_v_C4_2_of_place;
    let p_v_C3_3_3 = m3 * v_C3_3_4;
    let p_v_C3_2_3 = m3 * v_C3_2_4;
    let p_v_C3_1_3 = m3 * v_C3_1_4;
    let p_v_C3_3_4 = p_v_C4_2_2 + p_v_C3_2_3;
    let p_v_C3_2_4 = (-p_v_L4_in_J5_2_2).mul_add(c5, v_C3_2_3 * m4_plus_m5)
        - p_v_L4_in_J5_1_2 * s5_2 - p_v_C3_3_3 - q5_dot * p_v_L3_in_J4_1_of_place;
    let p_v_C3_1_4 = p_v_C4_1_4 - p_v_C3_1_3;
    let p_v_C2_3_2 = m2 * v_C2_3_2;
    let p_v_C2_2_2 = m2 * v_C2_2_2;
    let p_v_C2_1_2 = m2 * v_C2_1_2;
    let p_w_L5_in_L6_2_2 = z6.mul_add(p_v_C6_1_2, H_flange_2_2);
    let p_w_L5_in_L6_1_2 = z6.mul_add(p_v_C6_2_2, H_flange_1_2);
    let p_w_J5_3_2 = p_w_L5_in_L6_2_2.mul_add(c6, H_wrist2_2_2) - p_w_L5_in_L6_1_2 * s6
        - q6_dot * p_w_L4_in_J5_1_of_place;
    let p_w_L4_in_J5_2_2 = H_wrist2_3_2 + H_flange_3_2;
    let p_w_L4_in_J5_1_2 = p_w_L5_in_L6_2_2.mul_add(s6, H_wrist2_1_2)
        + p_w_L5_in_L6_1_2 * c6 + q6_dot * p_w_J5_3_of_place;
    let p_w_J4_3_2 = p_w_L4_in_J5_2_2.mul_add(c5, H_wrist1_2_2) - p_w_L4_in_J5_1_2 * s5_2
        - q5_dot * p_w_L3_in_J4_1_of_place;
    let p_w_L3_in_J4_2_2 = y4.mul_add(p_v_C4_1_3, H_wrist1_3_2) + p_w_J5_3_2;
    let p_w_L3_in_J4_1_2 = y4.mul_add(p_v_C4_3_2, H_wrist1_1_2) + p_w_L4_in_J5_2_2 * s5_2
        + p_w_L4_in_J5_1_2 * c5 + q5_dot * p_w_J4_3_of_place;
    let p_w_L2_in_J3_2_2 = x3.mul_add(p_v_C3_2_3, H_forearm_3_2) + y3 * p_v_C3_1_3
        + a3 * p_v_C3_3_4 + d3 * p_v_C3_1_4 + p_w_J4_3_2;
    let p_w_L2_in_J3_1_2 = q4_dot * (-p_w_L3_in_J4_1).mul_add(s4_2, p_w_L3_in_J4_2 * c4)
        + H_forearm_1_2 + d4 * p_v_C4_2_2 + y3 * p_v_C3_3_3 + z3 * p_v_C3_2_3
        + d3 * p_v_C3_2_4 + p_w_L3_in_J4_2_2 * s4_2 + p_w_L3_in_J4_1_2 * c4;
    let p_w_L1_in_L2_2_2 = a2.mul_add(p_v_C3_3_4, H_upper_arm_2_2) + z2 * p_v_C2_1_2
        + p_w_L2_in_J3_2_2 * c3 - p_w_L2_in_J3_1_2 * s3_2 + p_v_C2_3_2 * a2_plus_x2
        - q3_dot * p_w_L1_in_L2_1_of_place;
    let p_w_L1_in_L2_1_2 = y2.mul_add(p_v_C2_3_2, H_upper_arm_1_2) + z2 * p_v_C2_2_2
        + p_w_L2_in_J3_2_2 * s3_2 + p_w_L2_in_J3_1_2 * c3 + q3_dot * p_w_L1_in_L2_2_of_place;
    let m6_plus_m4_plus_m5 = m6 + m4_plus_m5;
    let mp_L2_1_of_m3_m4_m5_m6 = m3 + m6_plus_m4_plus_m5;
    let mp_L2_1 = a2.mul_add(mp_L2_1_of_m3_m4_m5_m6, m2 * a2_plus_x2);
    let mp_L2_2 = m2 * y2;
    let mp_L2_3 = m2 * z2;
    let mp_J3_1 = a3 * mp_L2_1_of_m3_m4_m5_m6;
    let mp_J3_3 = d3 * mp_L2_1_of_m3_m4_m5_m6;
    let mp_L3_1 = m3 * x3;
    let mp_L3_2 = m3 * y3;
    let mp_L3_3 = d4.mul_add(m6_plus_m4_plus_m5, m3 * z3);
    let mp_L4_2 = m4 * y4;
    let mp_L6_3 = m6 * z6;
    let x_L2_in_J3_1 = mp_L2_2.mul_add(s3_2, mp_L2_1 * c3);
    let x_L2_in_J3_2_of_place = (-mp_L2_1).mul_add(s3_2, mp_L2_2 * c3);
    let x_L2_in_J3_2 = -x_L2_in_J3_2_of_place;
    let x_L6_1 = mp_J3_1 + x_L2_in_J3_1;
    let x_L6_3 = mp_L2_3 + mp_J3_3;
    let x_L6_1_2 = mp_L3_1 + x_L6_1;
    let x_L6_2 = mp_L3_2 - x_L6_3;
    let x_L6_3_2 = mp_L3_3 - x_L2_in_J3_2;
    let x_L3_in_J4_1 = x_L6_2.mul_add(s4_2, x_L6_1_2 * c4);
    let x_L3_in_J4_2_of_place = (-x_L6_1_2).mul_add(s4_2, x_L6_2 * c4);
    let x_L3_in_J4_2 = -x_L3_in_J4_2_of_place;
    let x_L6_2_2 = mp_L4_2 + x_L6_3_2;
    let x_L4_in_J5_1 = x_L6_2_2.mul_add(s5_2, x_L3_in_J4_1 * c5);
    let x_L4_in_J5_2_of_place = (-x_L3_in_J4_1).mul_add(s5_2, x_L6_2_2 * c5);
    let x_L4_in_J5_2 = -x_L4_in_J5_2_of_place;
    let x_L5_in_L6_1 = (-x_L3_in_J4_2).mul_add(s6, x_L4_in_J5_1 * c6);
    let x_L5_in_L6_2 = x_L4_in_J5_1.mul_add(s6, x_L3_in_J4_2 * c6);
    let x_L6_3_3 = mp_L6_3 - x_L4_in_J5_2;
    let F_x_L4_in_J5_1 = x_L5_in_L6_2.mul_add(s6, x_L5_in_L6_1 * c6);
    let F_x_L3_in_J4_2 = (-x_L5_in_L6_1).mul_add(s6, x_L5_in_L6_2 * c6);
    let F_x_L3_in_J4_1 = (-F_x_L4_in_J5_1).mul_add(c5, x_L6_3_3 * s5_2);
    let F_x_L2_in_J3_2 = F_x_L4_in_J5_1.mul_add(s5_2, x_L6_3_3 * c5);
    let F_x_L2_in_J3_1 = (-F_x_L3_in_J4_1).mul_add(c4, F_x_L3_in_J4_2 * s4_2);
    let F_x_L1_in_L2_2 = F_x_L2_in_J3_1.mul_add(s3_2, F_x_L2_in_J3_2 * c3);
    let F_x_L1_in_L2_1 = (-F_x_L2_in_J3_1).mul_add(c3, F_x_L2_in_J3_2 * s3_2);
    let p_w_J3_3 = x3.mul_add(p_v_C3_3_3, d4 * p_v_C4_1_4) - z3 * p_v_C3_1_3
        - a3 * p_v_C3_2_4 + p_w_L3_in_J4_2_2 * c4 - p_w_L3_in_J4_1_2 * s4_2
        - q4_dot * p_w_L2_in_J3_1_of_place;
    let x_L1_in_L2_1 = g * s2_2;
    let x_L1_in_L2_2 = g * c2;
    let x_L2_in_J3_1_2 = x_L1_in_L2_2.mul_add(s3_2, x_L1_in_L2_1 * c3);
    let x_L2_in_J3_2_2_of_place = (-x_L1_in_L2_1).mul_add(s3_2, x_L1_in_L2_2 * c3);
    let x_L2_in_J3_2_2 = -x_L2_in_J3_2_2_of_place;
    let x_L3_in_J4_1_2 = x_L2_in_J3_1_2 * c4;
    let x_L3_in_J4_2_2 = x_L2_in_J3_1_2 * s4_2;
    let x_L4_in_J5_1_2 = (-x_L2_in_J3_2_2).mul_add(s5_2, x_L3_in_J4_1_2 * c5);
    let x_L4_in_J5_2_2 = x_L3_in_J4_1_2.mul_add(s5_2, x_L2_in_J3_2_2 * c5);
    let x_L5_in_L6_1_2 = (-x_L3_in_J4_2_2).mul_add(s6, x_L4_in_J5_1_2 * c6);
    let x_L5_in_L6_2_2 = x_L4_in_J5_1_2.mul_add(s6, x_L3_in_J4_2_2 * c6);
    let F_x_L4_in_J5_1_2 = x_L5_in_L6_2_2.mul_add(s6, x_L5_in_L6_1_2 * c6);
    let F_x_L6_2 = (-F_x_L4_in_J5_1_2).mul_add(s5_2, x_L4_in_J5_2_2 * c5);
    let F_x_L3_in_J4_2_2 = (-x_L5_in_L6_1_2).mul_add(s6, x_L5_in_L6_2_2 * c6);
    let F_x_L3_in_J4_1_2 = F_x_L4_in_J5_1_2.mul_add(c5, x_L4_in_J5_2_2 * s5_2);
    let F_x_L6_1 = F_x_L3_in_J4_1_2.mul_add(c4, F_x_L3_in_J4_2_2 * s4_2);
    let f1_of_place = (-p_w_L1_in_L2_1).mul_add(c2, p_w_L1_in_L2_2 * s2_2);
    let f2_of_place = p_v_C3_1_2.mul_add(c3, p_v_C3_2_2 * s3_2);
    // Values.
    let f1 = p_w_L1_in_L2_2_2.mul_add(c2, tau1) - p_w_L1_in_L2_1_2 * s2_2 + q2_dot * f1_of_place;
    let f2 = tau2 - y2 * p_v_C2_1_2
        + g * F_x_L1_in_L2_1.mul_add(c2, F_x_L1_in_L2_2 * s2_2) - p_w_J3_3
        + p_v_C2_2_2 * a2_plus_x2 - q1_dot * f1_of_place
        + a2 * (p_v_C3_1_4.mul_add(s3_2, p_v_C3_2_4 * c3) + q3_dot * f2_of_place);
    let f3 = w_L2_in_J3_1.mul_add(p_w_L2_in_J3_2, tau3) - w_L2_in_J3_2 * p_w_L2_in_J3_1
        - p_w_J3_3 + F_x_L2_in_J3_2 * x_L2_in_J3_1_2 - x_L2_in_J3_1 * F_x_L6_2
        - F_x_L6_1 * x_L2_in_J3_2_of_place - F_x_L2_in_J3_1 * x_L2_in_J3_2_2_of_place
        - a2_q2_dot * f2_of_place;
    let f4 = (-v_L3_in_J4_1).mul_add(p_v_L3_in_J4_2, tau4)
        + w_L3_in_J4_1 * p_w_L3_in_J4_2 - w_L3_in_J4_2 * p_w_L3_in_J4_1 + p_w_J4_3_2
        - F_x_L3_in_J4_2 * x_L3_in_J4_1_2 - F_x_L3_in_J4_1 * x_L3_in_J4_2_2
        - x_L3_in_J4_1 * F_x_L3_in_J4_2_2 + p_v_L3_in_J4_1 * v_L3_in_J4_2_of_place
        - F_x_L3_in_J4_1_2 * x_L3_in_J4_2_of_place;
    let f5 = v_L4_in_J5_1.mul_add(p_v_L4_in_J5_2, tau5) + v_L4_in_J5_2 * p_v_L4_in_J5_1
        + w_L4_in_J5_1 * p_w_L4_in_J5_2 - w_L4_in_J5_2 * p_w_L4_in_J5_1 - p_w_J5_3_2
        + x_L6_3_3 * x_L4_in_J5_1_2 - x_L4_in_J5_1 * x_L4_in_J5_2_2
        + F_x_L4_in_J5_1 * x_L4_in_J5_2_2 - F_x_L4_in_J5_1_2 * x_L4_in_J5_2_of_place;
    let f6 = (-v_L5_in_L6_1).mul_add(p_v_C6_2, tau6) - v_L5_in_L6_2 * p_v_C6_1
        + w_L5_in_L6_1 * p_w_L5_in_L6_2 - w_L5_in_L6_2 * p_w_L5_in_L6_1 + H_flange_3_2;
    [f1, f2, f3, f4, f5, f6]
}

/// The accelerations (q1'', q2'', q3'', q4'', q5'', q6''), solved for when this code was generated.
///
/// 1547 operations, 5 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    q_dot: &[S; 6],
) -> [S; 6] {
    let Parameters {
        g, a2, a3, d3, d4, m2, m3, m4, m5, m6, x2, y2, z2, x3, y3, z3, y4, z6, I1, Ixx2, Iyy2, Izz2,
        Ixx3, Iyy3, Izz3, Ixx4, Iyy4, Ixx5, Iyy5, Ixx6, Izz6, tau1, tau2, tau3, tau4, tau5, tau6,
        ..
    } = *p;
    let [_, q2, q3, q4, q5, q6] = *q;
    let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot, q6_dot] = *q_dot;
    // Sines and cosines.
    let (s2_2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    let (s4_2, c4) = q4.sin_cos();
    let (s5_2, c5) = q5.sin_cos();
    let (s6, c6) = q6.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_L1_in_L2_1 = q1_dot * s2_2;
    let w_L1_in_L2_2 = q1_dot * c2;
    let w_L2_in_J3_1 = w_L1_in_L2_2.mul_add(s3_2, w_L1_in_L2_1 * c3);
    let w_L2_in_J3_2 = (-w_L1_in_L2_2).mul_add(c3, w_L1_in_L2_1 * s3_2);
    let w_J3_3 = q2_dot + q3_dot;
    let w_L3_in_J4_1 = (-w_J3_3).mul_add(s4_2, w_L2_in_J3_1 * c4);
    let w_L3_in_J4_2 = w_J3_3.mul_add(c4, w_L2_in_J3_1 * s4_2);
    let w_J4_3 = q4_dot - w_L2_in_J3_2;
    let w_L4_in_J5_1 = w_J4_3.mul_add(s5_2, w_L3_in_J4_1 * c5);
    let w_L4_in_J5_2 = (-w_J4_3).mul_add(c5, w_L3_in_J4_1 * s5_2);
    let w_J5_3 = q5_dot + w_L3_in_J4_2;
    let w_L5_in_L6_1 = (-w_J5_3).mul_add(s6, w_L4_in_J5_1 * c6);
    let w_L5_in_L6_2 = w_J5_3.mul_add(c6, w_L4_in_J5_1 * s6);
    let w_L6_3 = q6_dot - w_L4_in_J5_2;
    let v_C2_1 = (-y2).mul_add(q2_dot, z2 * w_L1_in_L2_2);
    let a2_plus_x2 = a2 + x2;
    let v_C2_2 = (-z2).mul_add(w_L1_in_L2_1, q2_dot * a2_plus_x2);
    let v_C2_3 = (-y2).mul_add(w_L1_in_L2_1, w_L1_in_L2_2 * a2_plus_x2);
    let H_upper_arm_1 = Ixx2 * w_L1_in_L2_1;
    let H_upper_arm_2 = Iyy2 * w_L1_in_L2_2;
    let a2_q2_dot = a2 * q2_dot;
    let v_L2_in_J3_1 = a2_q2_dot * s3_2;
    let v_L2_in_J3_2 = a2_q2_dot * c3;
    let v_L2_in_J3_3 = a2 * w_L1_in_L2_2;
    let v_C3_1 = d3.mul_add(w_L2_in_J3_2, -v_L2_in_J3_1);
    let v_C3_2 = (-d3).mul_add(w_L2_in_J3_1, a3 * w_J3_3) + v_L2_in_J3_2;
    let v_C3_3 = a3.mul_add(w_L2_in_J3_2, -v_L2_in_J3_3);
    let v_C3_1_2 = (-y3).mul_add(w_L2_in_J3_2, z3 * w_J3_3) + v_C3_1;
    let v_C3_2_2 = x3.mul_add(w_L2_in_J3_2, z3 * w_L2_in_J3_1) + v_C3_3;
    let v_C3_3_2 = x3.mul_add(w_J3_3, y3 * w_L2_in_J3_1) + v_C3_2;
    let H_forearm_1 = Ixx3 * w_L2_in_J3_1;
    let H_forearm_3 = Izz3 * w_L2_in_J3_2;
    let v_C4_1 = d4.mul_add(w_J3_3, v_C3_1);
    let v_C4_2 = d4.mul_add(w_L2_in_J3_1, v_C3_3);
    let v_L3_in_J4_1 = v_C4_2.mul_add(s4_2, v_C4_1 * c4);
    let v_L3_in_J4_2 = (-v_C4_2).mul_add(c4, v_C4_1 * s4_2);
    let v_C4_1_2 = y4.mul_add(w_L3_in_J4_2, v_L3_in_J4_1);
    let v_C4_3 = y4.mul_add(w_L3_in_J4_1, -v_L3_in_J4_2);
    let H_wrist1_1 = Ixx4 * w_L3_in_J4_1;
    let H_wrist1_2 = Iyy4 * w_J4_3;
    let H_wrist1_3 = Ixx4 * w_L3_in_J4_2;
    let H_wrist2_1 = Ixx5 * w_L4_in_J5_1;
    let H_wrist2_2 = Iyy5 * w_J5_3;
    let H_wrist2_3 = Ixx5 * w_L4_in_J5_2;
    let v_L4_in_J5_1 = (-v_C3_2).mul_add(s5_2, v_L3_in_J4_1 * c5);
    let v_L4_in_J5_2 = v_L3_in_J4_1.mul_add(s5_2, v_C3_2 * c5);
    let v_L5_in_L6_1 = (-v_L3_in_J4_2).mul_add(s6, v_L4_in_J5_1 * c6);
    let v_L5_in_L6_2 = v_L4_in_J5_1.mul_add(s6, v_L3_in_J4_2 * c6);
    let v_C6_1 = z6.mul_add(w_L5_in_L6_2, v_L5_in_L6_1);
    let v_C6_2 = z6.mul_add(w_L5_in_L6_1, -v_L5_in_L6_2);
    let H_flange_1 = Ixx6 * w_L5_in_L6_1;
    let H_flange_2 = Ixx6 * w_L5_in_L6_2;
    let H_flange_3 = Izz6 * w_L6_3;
    let p_v_C6_2 = m6 * v_C6_2;
    let p_v_C6_1 = m6 * v_C6_1;
    let p_v_L4_in_J5_2 = m6 * v_L4_in_J5_2;
    let p_v_L4_in_J5_1 = (-p_v_C6_1).mul_add(c6, p_v_C6_2 * s6);
    let p_v_C4_3 = m4 * v_C4_3;
    let p_v_C4_1 = m4 * v_C4_1_2;
    let p_v_L3_in_J4_2 = p_v_C6_1.mul_add(s6, p_v_C6_2 * c6) + p_v_C4_3;
    let p_v_L3_in_J4_1 = (-p_v_L4_in_J5_1).mul_add(c5, p_v_L4_in_J5_2 * s5_2) + p_v_C4_1;
    let p_v_C4_2 = p_v_L3_in_J4_2.mul_add(c4, m5 * v_C4_2) + p_v_L3_in_J4_1 * s4_2;
    let p_v_C4_1_2 = (-p_v_L3_in_J4_2).mul_add(s4_2, m5 * v_C4_1) + p_v_L3_in_J4_1 * c4;
    let p_v_C3_3 = m3 * v_C3_3_2;
    let p_v_C3_2 = m3 * v_C3_2_2;
    let p_v_C3_1 = m3 * v_C3_1_2;
    let p_v_C3_3_2 = p_v_C4_2 + p_v_C3_2;
    let m4_plus_m5 = m4 + m5;
    let p_v_C3_2_2 = p_v_L4_in_J5_1.mul_add(s5_2, p_v_L4_in_J5_2 * c5) + p_v_C3_3
        + v_C3_2 * m4_plus_m5;
    let p_v_C3_1_2 = p_v_C4_1_2 + p_v_C3_1;
    let p_v_C2_3 = m2 * v_C2_3;
    let p_v_C2_2 = m2 * v_C2_2;
    let p_v_C2_1 = m2 * v_C2_1;
    let p_w_L5_in_L6_2 = z6.mul_add(p_v_C6_1, H_flange_2);
    let p_w_L5_in_L6_1 = z6.mul_add(p_v_C6_2, H_flange_1);
    let p_w_J5_3 = p_w_L5_in_L6_2.mul_add(c6, H_wrist2_2) - p_w_L5_in_L6_1 * s6;
    let p_w_L4_in_J5_2 = H_wrist2_3 - H_flange_3;
    let p_w_L4_in_J5_1 = p_w_L5_in_L6_2.mul_add(s6, H_wrist2_1) + p_w_L5_in_L6_1 * c6;
    let p_w_J4_3 = (-p_w_L4_in_J5_2).mul_add(c5, H_wrist1_2) + p_w_L4_in_J5_1 * s5_2;
    let p_w_L3_in_J4_2 = y4.mul_add(p_v_C4_1, H_wrist1_3) + p_w_J5_3;
    let p_w_L3_in_J4_1 = y4.mul_add(p_v_C4_3, H_wrist1_1) + p_w_L4_in_J5_2 * s5_2
        + p_w_L4_in_J5_1 * c5;
    let p_w_L2_in_J3_2 = x3.mul_add(p_v_C3_2, H_forearm_3) - y3 * p_v_C3_1
        + a3 * p_v_C3_3_2 + d3 * p_v_C3_1_2 - p_w_J4_3;
    let p_w_L2_in_J3_1 = d4.mul_add(p_v_C4_2, H_forearm_1) + y3 * p_v_C3_3
        + z3 * p_v_C3_2 - d3 * p_v_C3_2_2 + p_w_L3_in_J4_2 * s4_2 + p_w_L3_in_J4_1 * c4;
    let p_w_L1_in_L2_2_of_place = (-p_w_L2_in_J3_1).mul_add(s3_2, p_w_L2_in_J3_2 * c3);
    let p_w_L1_in_L2_2 = (-a2).mul_add(p_v_C3_3_2, H_upper_arm_2) + z2 * p_v_C2_1
        + p_v_C2_3 * a2_plus_x2 - p_w_L1_in_L2_2_of_place;
    let p_w_L1_in_L2_1_of_place = p_w_L2_in_J3_1.mul_add(c3, p_w_L2_in_J3_2 * s3_2);
    let p_w_L1_in_L2_1 = (-y2).mul_add(p_v_C2_3, H_upper_arm_1) - z2 * p_v_C2_2
        + p_w_L1_in_L2_1_of_place;
    let w_L1_in_L2_1_2 = q2_dot * w_L1_in_L2_2;
    let w_L1_in_L2_2_2 = q2_dot * w_L1_in_L2_1;
    let w_L2_in_J3_1_2 = (-q3_dot).mul_add(w_L2_in_J3_2, w_L1_in_L2_1_2 * c3)
        - w_L1_in_L2_2_2 * s3_2;
    let w_L2_in_J3_2_2 = w_L1_in_L2_1_2.mul_add(s3_2, q3_dot * w_L2_in_J3_1) + w_L1_in_L2_2_2 * c3;
    let q4_dot_s4_2 = q4_dot * s4_2;
    let q4_dot_c4 = q4_dot * c4;
    let w_L3_in_J4_1_2 = (-w_L2_in_J3_1).mul_add(q4_dot_s4_2, w_L2_in_J3_1_2 * c4)
        - w_J3_3 * q4_dot_c4;
    let w_L3_in_J4_2_2 = (-w_J3_3).mul_add(q4_dot_s4_2, w_L2_in_J3_1_2 * s4_2)
        + w_L2_in_J3_1 * q4_dot_c4;
    let q5_dot_s5_2 = q5_dot * s5_2;
    let q5_dot_c5 = q5_dot * c5;
    let w_L4_in_J5_1_2 = (-w_L2_in_J3_2_2).mul_add(s5_2, w_L3_in_J4_1_2 * c5)
        - w_L3_in_J4_1 * q5_dot_s5_2 + w_J4_3 * q5_dot_c5;
    let w_L4_in_J5_2_2 = w_L3_in_J4_1_2.mul_add(s5_2, w_L2_in_J3_2_2 * c5)
        + w_J4_3 * q5_dot_s5_2 + w_L3_in_J4_1 * q5_dot_c5;
    let q6_dot_s6 = q6_dot * s6;
    let q6_dot_c6 = q6_dot * c6;
    let w_L5_in_L6_1_2 = (-w_L3_in_J4_2_2).mul_add(s6, w_L4_in_J5_1_2 * c6)
        - w_L4_in_J5_1 * q6_dot_s6 - w_J5_3 * q6_dot_c6;
    let w_L5_in_L6_2_2 = w_L4_in_J5_1_2.mul_add(s6, w_L3_in_J4_2_2 * c6)
        - w_J5_3 * q6_dot_s6 + w_L4_in_J5_1 * q6_dot_c6;
    let v_C2_1_2 = z2 * w_L1_in_L2_2_2;
    let v_C2_2_2 = z2 * w_L1_in_L2_1_2;
    let v_C2_3_2 = w_L1_in_L2_2_2.mul_add(a2_plus_x2, y2 * w_L1_in_L2_1_2);
    let H_upper_arm_1_2 = Ixx2 * w_L1_in_L2_1_2;
    let H_upper_arm_2_2 = Iyy2 * w_L1_in_L2_2_2;
    let v_L2_in_J3_1_2 = q3_dot * v_L2_in_J3_2;
    let v_L2_in_J3_2_2 = q3_dot * v_L2_in_J3_1;
    let v_L2_in_J3_3_2 = a2 * w_L1_in_L2_2_2;
    let v_C3_1_3 = d3.mul_add(w_L2_in_J3_2_2, -v_L2_in_J3_1_2);
    let v_C3_2_3 = d3.mul_add(w_L2_in_J3_1_2, v_L2_in_J3_2_2);
    let v_C3_3_3 = a3.mul_add(w_L2_in_J3_2_2, v_L2_in_J3_3_2);
    let v_C3_1_4 = y3.mul_add(w_L2_in_J3_2_2, -v_C3_1_3);
    let v_C3_2_4 = x3.mul_add(w_L2_in_J3_2_2, z3 * w_L2_in_J3_1_2) + v_C3_3_3;
    let v_C3_3_4 = y3.mul_add(w_L2_in_J3_1_2, -v_C3_2_3);
    let H_forearm_1_2 = Ixx3 * w_L2_in_J3_1_2;
    let H_forearm_3_2 = Izz3 * w_L2_in_J3_2_2;
    let v_C4_2_2 = d4.mul_add(w_L2_in_J3_1_2, v_C3_3_3);
    let v_L3_in_J4_1_2 = (-v_C3_1_3).mul_add(c4, v_C4_1 * q4_dot_s4_2) - v_C4_2_2 * s4_2
        - v_C4_2 * q4_dot_c4;
    let v_L3_in_J4_2_2 = (-v_C4_2_2).mul_add(c4, v_C3_1_3 * s4_2) + v_C4_2 * q4_dot_s4_2
        + v_C4_1 * q4_dot_c4;
    let v_C4_1_3 = y4.mul_add(w_L3_in_J4_2_2, -v_L3_in_J4_1_2);
    let v_C4_3_2 = y4.mul_add(w_L3_in_J4_1_2, -v_L3_in_J4_2_2);
    let H_wrist1_1_2 = Ixx4 * w_L3_in_J4_1_2;
    let H_wrist1_2_2 = Iyy4 * w_L2_in_J3_2_2;
    let H_wrist1_3_2 = Ixx4 * w_L3_in_J4_2_2;
    let H_wrist2_1_2 = Ixx5 * w_L4_in_J5_1_2;
    let H_wrist2_2_2 = Iyy5 * w_L3_in_J4_2_2;
    let H_wrist2_3_2 = Ixx5 * w_L4_in_J5_2_2;
    let v_L4_in_J5_1_2 = (-v_C3_2_3).mul_add(s5_2, v_L3_in_J4_1_2 * c5)
        + v_L3_in_J4_1 * q5_dot_s5_2 + v_C3_2 * q5_dot_c5;
    let v_L4_in_J5_2_2 = (-v_C3_2_3).mul_add(c5, v_L3_in_J4_1 * q5_dot_c5)
        - v_L3_in_J4_1_2 * s5_2 - v_C3_2 * q5_dot_s5_2;
    let v_L5_in_L6_1_2 = v_L4_in_J5_1_2.mul_add(c6, v_L3_in_J4_2_2 * s6)
        + v_L4_in_J5_1 * q6_dot_s6 + v_L3_in_J4_2 * q6_dot_c6;
    let v_L5_in_L6_2_2 = (-v_L4_in_J5_1_2).mul_add(s6, v_L3_in_J4_2_2 * c6)
        - v_L3_in_J4_2 * q6_dot_s6 + v_L4_in_J5_1 * q6_dot_c6;
    let v_C6_1_2 = z6.mul_add(w_L5_in_L6_2_2, -v_L5_in_L6_1_2);
    let v_C6_2_2 = z6.mul_add(w_L5_in_L6_1_2, -v_L5_in_L6_2_2);
    let H_flange_1_2 = Ixx6 * w_L5_in_L6_1_2;
    let H_flange_2_2 = Ixx6 * w_L5_in_L6_2_2;
    let H_flange_3_2 = Izz6 * w_L4_in_J5_2_2;
    let p_v_C6_2_2 = m6 * v_C6_2_2;
    let p_v_C6_1_2 = m6 * v_C6_1_2;
    let p_v_L4_in_J5_2_2 = m6 * v_L4_in_J5_2_2;
    let p_v_L4_in_J5_1_2 = (-p_v_C6_1_2).mul_add(c6, p_v_C6_2_2 * s6)
        + p_v_C6_1 * q6_dot_s6 + p_v_C6_2 * q6_dot_c6;
    let p_v_C4_3_2 = m4 * v_C4_3_2;
    let p_v_C4_1_3 = m4 * v_C4_1_3;
    let p_v_L3_in_J4_2_2 = (-p_v_C6_2_2).mul_add(c6, p_v_C6_2 * q6_dot_s6)
        - p_v_C6_1_2 * s6 - p_v_C4_3_2 - p_v_C6_1 * q6_dot_c6;
    let p_v_L3_in_J4_1_2 = (-p_v_L4_in_J5_1_2).mul_add(c5, p_v_L4_in_J5_2_2 * s5_2)
        + p_v_C4_1_3 + p_v_L4_in_J5_1 * q5_dot_s5_2 + p_v_L4_in_J5_2 * q5_dot_c5;
    let p_v_C4_2_2 = (-p_v_L3_in_J4_2_2).mul_add(c4, m5 * v_C4_2_2)
        + p_v_L3_in_J4_1_2 * s4_2 - p_v_L3_in_J4_2 * q4_dot_s4_2 + p_v_L3_in_J4_1 * q4_dot_c4;
    let p_v_C4_1_4 = p_v_L3_in_J4_2_2.mul_add(s4_2, m5 * v_C3_1_3)
        + p_v_L3_in_J4_1_2 * c4 - p_v_L3_in_J4_1 * q4_dot_s4_2 - p_v_L3_in_J4_2 * q4_dot_c4;
    let p_v_C3_3_3 = m3 * v_C3_3_4;
    let p_v_C3_2_3 = m3 * v_C3_2_4;
    let p_v_C3_1_3 = m3 * v_C3_1_4;
    let p_v_C3_3_4 = p_v_C4_2_2 + p_v_C3_2_3;
    let p_v_C3_2_4 = (-p_v_L4_in_J5_2_2).mul_add(c5, v_C3_2_3 * m4_plus_m5)
        - p_v_L4_in_J5_1_2 * s5_2 - p_v_C3_3_3 + p_v_L4_in_J5_2 * q5_dot_s5_2
        - p_v_L4_in_J5_1 * q5_dot_c5;
    let p_v_C3_1_4 = p_v_C4_1_4 - p_v_C3_1_3;
    let p_v_C2_3_2 = m2 * v_C2_3_2;
    let p_v_C2_2_2 = m2 * v_C2_2_2;
    let p_v_C2_1_2 = m2 * v_C2_1_2;
    let p_w_L5_in_L6_2_2 = z6.mul_add(p_v_C6_1_2, H_flange_2_2);
    let p_w_L5_in_L6_1_2 = z6.mul_add(p_v_C6_2_2, H_flange_1_2);
    let p_w_J5_3_2 = p_w_L5_in_L6_2_2.mul_add(c6, H_wrist2_2_2) - p_w_L5_in_L6_1_2 * s6
        - p_w_L5_in_L6_2 * q6_dot_s6 - p_w_L5_in_L6_1 * q6_dot_c6;
    let p_w_L4_in_J5_2_2 = H_wrist2_3_2 + H_flange_3_2;
    let p_w_L4_in_J5_1_2 = p_w_L5_in_L6_2_2.mul_add(s6, H_wrist2_1_2)
        + p_w_L5_in_L6_1_2 * c6 - p_w_L5_in_L6_1 * q6_dot_s6 + p_w_L5_in_L6_2 * q6_dot_c6;
    let p_w_J4_3_2 = p_w_L4_in_J5_2_2.mul_add(c5, H_wrist1_2_2) - p_w_L4_in_J5_1_2 * s5_2
        - p_w_L4_in_J5_2 * q5_dot_s5_2 - p_w_L4_in_J5_1 * q5_dot_c5;
    let p_w_L3_in_J4_2_2 = y4.mul_add(p_v_C4_1_3, H_wrist1_3_2) + p_w_J5_3_2;
    let p_w_L3_in_J4_1_2 = y4.mul_add(p_v_C4_3_2, H_wrist1_1_2) + p_w_L4_in_J5_2_2 * s5_2
        + p_w_L4_in_J5_1_2 * c5 - p_w_L4_in_J5_1 * q5_dot_s5_2 + p_w_L4_in_J5_2 * q5_dot_c5;
    let p_w_L2_in_J3_2_2 = x3.mul_add(p_v_C3_2_3, H_forearm_3_2) + y3 * p_v_C3_1_3
        + a3 * p_v_C3_3_4 + d3 * p_v_C3_1_4 + p_w_J4_3_2;
    let p_w_L2_in_J3_1_2 = d4.mul_add(p_v_C4_2_2, H_forearm_1_2) + y3 * p_v_C3_3_3
        + z3 * p_v_C3_2_3 + d3 * p_v_C3_2_4 + p_w_L3_in_J4_2_2 * s4_2
        + p_w_L3_in_J4_1_2 * c4 - p_w_L3_in_J4_1 * q4_dot_s4_2 + p_w_L3_in_J4_2 * q4_dot_c4;
    let p_w_L1_in_L2_2_2 = a2.mul_add(p_v_C3_3_4, H_upper_arm_2_2) + z2 * p_v_C2_1_2
        + p_w_L2_in_J3_2_2 * c3 - p_w_L2_in_J3_1_2 * s3_2 + p_v_C2_3_2 * a2_plus_x2
        - q3_dot * p_w_L1_in_L2_1_of_place;
    let p_w_L1_in_L2_1_2 = y2.mul_add(p_v_C2_3_2, H_upper_arm_1_2) + z2 * p_v_C2_2_2
        + p_w_L2_in_J3_2_2 * s3_2 + p_w_L2_in_J3_1_2 * c3 + q3_dot * p_w_L1_in_L2_2_of_place;
    let m6_plus_m4_plus_m5 = m6 + m4_plus_m5;
    let mp_L2_1_of_m3_m4_m5_m6 = m3 + m6_plus_m4_plus_m5;
    let mp_L2_1 = a2.mul_add(mp_L2_1_of_m3_m4_m5_m6, m2 * a2_plus_x2);
    let mp_L2_2 = m2 * y2;
    let mp_L2_3 = m2 * z2;
    let mp_J3_1 = a3 * mp_L2_1_of_m3_m4_m5_m6;
    let mp_J3_3 = d3 * mp_L2_1_of_m3_m4_m5_m6;
    let mp_L3_1 = m3 * x3;
    let mp_L3_2 = m3 * y3;
    let p_v_C3_1_11 = m3 * z3;
    let mp_L3_3 = d4.mul_add(m6_plus_m4_plus_m5, p_v_C3_1_11);
    let mp_L4_2 = m4 * y4;
    let mp_L6_3 = m6 * z6;
    let x_L2_in_J3_1 = mp_L2_2.mul_add(s3_2, mp_L2_1 * c3);
    let x_L2_in_J3_2 = (-mp_L2_2).mul_add(c3, mp_L2_1 * s3_2);
    let x_L6_1 = mp_J3_1 + x_L2_in_J3_1;
    let x_L6_3 = mp_L2_3 + mp_J3_3;
    let x_L6_1_2 = mp_L3_1 + x_L6_1;
    let x_L6_2 = mp_L3_2 - x_L6_3;
    let x_L6_3_2 = mp_L3_3 - x_L2_in_J3_2;
    let x_L3_in_J4_1 = x_L6_2.mul_add(s4_2, x_L6_1_2 * c4);
    let x_L3_in_J4_2 = (-x_L6_2).mul_add(c4, x_L6_1_2 * s4_2);
    let x_L6_2_2 = mp_L4_2 + x_L6_3_2;
    let x_L4_in_J5_1 = x_L6_2_2.mul_add(s5_2, x_L3_in_J4_1 * c5);
    let x_L4_in_J5_2 = (-x_L6_2_2).mul_add(c5, x_L3_in_J4_1 * s5_2);
    let x_L5_in_L6_1 = (-x_L3_in_J4_2).mul_add(s6, x_L4_in_J5_1 * c6);
    let x_L5_in_L6_2 = x_L4_in_J5_1.mul_add(s6, x_L3_in_J4_2 * c6);
    let x_L6_3_3 = mp_L6_3 - x_L4_in_J5_2;
    let F_x_L4_in_J5_1 = x_L5_in_L6_2.mul_add(s6, x_L5_in_L6_1 * c6);
    let F_x_L3_in_J4_2 = (-x_L5_in_L6_1).mul_add(s6, x_L5_in_L6_2 * c6);
    let F_x_L3_in_J4_1 = (-F_x_L4_in_J5_1).mul_add(c5, x_L6_3_3 * s5_2);
    let F_x_L2_in_J3_2 = F_x_L4_in_J5_1.mul_add(s5_2, x_L6_3_3 * c5);
    let F_x_L2_in_J3_1 = (-F_x_L3_in_J4_1).mul_add(c4, F_x_L3_in_J4_2 * s4_2);
    let F_x_L1_in_L2_2 = F_x_L2_in_J3_1.mul_add(s3_2, F_x_L2_in_J3_2 * c3);
    let F_x_L1_in_L2_1 = (-F_x_L2_in_J3_1).mul_add(c3, F_x_L2_in_J3_2 * s3_2);
    let p_w_J3_3 = x3.mul_add(p_v_C3_3_3, d4 * p_v_C4_1_4) - z3 * p_v_C3_1_3
        - a3 * p_v_C3_2_4 + p_w_L3_in_J4_2_2 * c4 - p_w_L3_in_J4_1_2 * s4_2
        - p_w_L3_in_J4_2 * q4_dot_s4_2 - p_w_L3_in_J4_1 * q4_dot_c4;
    let x_L1_in_L2_1 = g * s2_2;
    let x_L1_in_L2_2 = g * c2;
    let x_L2_in_J3_1_2 = x_L1_in_L2_2.mul_add(s3_2, x_L1_in_L2_1 * c3);
    let x_L2_in_J3_2_2 = (-x_L1_in_L2_2).mul_add(c3, x_L1_in_L2_1 * s3_2);
    let x_L3_in_J4_1_2 = x_L2_in_J3_1_2 * c4;
    let x_L3_in_J4_2_2 = x_L2_in_J3_1_2 * s4_2;
    let x_L4_in_J5_1_2 = (-x_L2_in_J3_2_2).mul_add(s5_2, x_L3_in_J4_1_2 * c5);
    let x_L4_in_J5_2_2 = x_L3_in_J4_1_2.mul_add(s5_2, x_L2_in_J3_2_2 * c5);
    let x_L5_in_L6_1_2 = (-x_L3_in_J4_2_2).mul_add(s6, x_L4_in_J5_1_2 * c6);
    let x_L5_in_L6_2_2 = x_L4_in_J5_1_2.mul_add(s6, x_L3_in_J4_2_2 * c6);
    let F_x_L4_in_J5_1_2 = x_L5_in_L6_2_2.mul_add(s6, x_L5_in_L6_1_2 * c6);
    let F_x_L6_2 = (-F_x_L4_in_J5_1_2).mul_add(s5_2, x_L4_in_J5_2_2 * c5);
    let F_x_L3_in_J4_2_2 = (-x_L5_in_L6_1_2).mul_add(s6, x_L5_in_L6_2_2 * c6);
    let F_x_L3_in_J4_1_2 = F_x_L4_in_J5_1_2.mul_add(c5, x_L4_in_J5_2_2 * s5_2);
    let F_x_L6_1 = F_x_L3_in_J4_1_2.mul_add(c4, F_x_L3_in_J4_2_2 * s4_2);
    let w_L2_in_J3_1_4 = s2_2.mul_add(c3, c2 * s3_2);
    let w_L2_in_J3_2_4 = (-c2).mul_add(c3, s2_2 * s3_2);
    let w_L3_in_J4_1_4 = w_L2_in_J3_1_4 * c4;
    let w_L3_in_J4_2_4 = w_L2_in_J3_1_4 * s4_2;
    let w_L4_in_J5_1_4 = (-w_L2_in_J3_2_4).mul_add(s5_2, w_L3_in_J4_1_4 * c5);
    let w_L4_in_J5_2_4 = w_L3_in_J4_1_4.mul_add(s5_2, w_L2_in_J3_2_4 * c5);
    let w_L5_in_L6_1_4 = (-w_L3_in_J4_2_4).mul_add(s6, w_L4_in_J5_1_4 * c6);
    let w_L5_in_L6_2_4 = w_L4_in_J5_1_4.mul_add(s6, w_L3_in_J4_2_4 * c6);
    let v_C2_1_4 = z2 * c2;
    let v_C2_2_4 = z2 * s2_2;
    let v_C2_3_4 = (-y2).mul_add(s2_2, a2_plus_x2 * c2);
    let H_upper_arm_1_4 = Ixx2 * s2_2;
    let H_upper_arm_2_4 = Iyy2 * c2;
    let v_L2_in_J3_3_4 = a2 * c2;
    let v_C3_1_7 = d3 * w_L2_in_J3_2_4;
    let v_C3_2_7 = d3 * w_L2_in_J3_1_4;
    let v_C3_3_7 = a3.mul_add(w_L2_in_J3_2_4, -v_L2_in_J3_3_4);
    let v_C3_1_8 = y3.mul_add(w_L2_in_J3_2_4, -v_C3_1_7);
    let v_C3_2_8 = x3.mul_add(w_L2_in_J3_2_4, z3 * w_L2_in_J3_1_4) + v_C3_3_7;
    let v_C3_3_8 = y3.mul_add(w_L2_in_J3_1_4, -v_C3_2_7);
    let H_forearm_1_4 = Ixx3 * w_L2_in_J3_1_4;
    let H_forearm_3_4 = Izz3 * w_L2_in_J3_2_4;
    let v_C4_2_4 = d4.mul_add(w_L2_in_J3_1_4, v_C3_3_7);
    let v_L3_in_J4_1_4 = v_C4_2_4.mul_add(s4_2, v_C3_1_7 * c4);
    let v_L3_in_J4_2_4 = (-v_C4_2_4).mul_add(c4, v_C3_1_7 * s4_2);
    let v_C4_1_6 = y4.mul_add(w_L3_in_J4_2_4, v_L3_in_J4_1_4);
    let v_C4_3_4 = y4.mul_add(w_L3_in_J4_1_4, -v_L3_in_J4_2_4);
    let H_wrist1_1_4 = Ixx4 * w_L3_in_J4_1_4;
    let H_wrist1_2_4 = Iyy4 * w_L2_in_J3_2_4;
    let H_wrist1_3_4 = Ixx4 * w_L3_in_J4_2_4;
    let H_wrist2_1_4 = Ixx5 * w_L4_in_J5_1_4;
    let H_wrist2_2_4 = Iyy5 * w_L3_in_J4_2_4;
    let H_wrist2_3_4 = Ixx5 * w_L4_in_J5_2_4;
    let v_L4_in_J5_1_4 = v_L3_in_J4_1_4.mul_add(c5, v_C3_2_7 * s5_2);
    let v_L4_in_J5_2_4 = (-v_C3_2_7).mul_add(c5, v_L3_in_J4_1_4 * s5_2);
    let v_L5_in_L6_1_4 = (-v_L3_in_J4_2_4).mul_add(s6, v_L4_in_J5_1_4 * c6);
    let v_L5_in_L6_2_4 = v_L4_in_J5_1_4.mul_add(s6, v_L3_in_J4_2_4 * c6);
    let v_C6_1_4 = z6.mul_add(w_L5_in_L6_2_4, v_L5_in_L6_1_4);
    let v_C6_2_4 = z6.mul_add(w_L5_in_L6_1_4, -v_L5_in_L6_2_4);
    let H_flange_1_4 = Ixx6 * w_L5_in_L6_1_4;
    let H_flange_2_4 = Ixx6 * w_L5_in_L6_2_4;
    let H_flange_3_4 = Izz6 * w_L4_in_J5_2_4;
    let p_v_C6_2_4 = m6 * v_C6_2_4;
    let p_v_C6_1_4 = m6 * v_C6_1_4;
    let p_v_L4_in_J5_2_4 = m6 * v_L4_in_J5_2_4;
    let p_v_L4_in_J5_1_4 = (-p_v_C6_1_4).mul_add(c6, p_v_C6_2_4 * s6);
    let p_v_C4_3_4 = m4 * v_C4_3_4;
    let p_v_C4_1_7 = m4 * v_C4_1_6;
    let p_v_L3_in_J4_2_4 = p_v_C6_1_4.mul_add(s6, p_v_C6_2_4 * c6) + p_v_C4_3_4;
    let p_v_L3_in_J4_1_4 = (-p_v_L4_in_J5_1_4).mul_add(c5, p_v_L4_in_J5_2_4 * s5_2) + p_v_C4_1_7;
    let p_v_C4_2_4 = p_v_L3_in_J4_2_4.mul_add(c4, m5 * v_C4_2_4) + p_v_L3_in_J4_1_4 * s4_2;
    let p_v_C4_1_8 = (-p_v_L3_in_J4_2_4).mul_add(s4_2, m5 * v_C3_1_7) + p_v_L3_in_J4_1_4 * c4;
    let p_v_C3_3_7 = m3 * v_C3_3_8;
    let p_v_C3_2_7 = m3 * v_C3_2_8;
    let p_v_C3_1_7 = m3 * v_C3_1_8;
    let p_v_C3_3_8 = p_v_C4_2_4 + p_v_C3_2_7;
    let p_v_C3_2_8 = (-p_v_L4_in_J5_2_4).mul_add(c5, v_C3_2_7 * m4_plus_m5)
        - p_v_L4_in_J5_1_4 * s5_2 - p_v_C3_3_7;
    let p_v_C3_1_8 = p_v_C4_1_8 - p_v_C3_1_7;
    let p_v_C2_3_4 = m2 * v_C2_3_4;
    let p_v_C2_2_4 = m2 * v_C2_2_4;
    let p_v_C2_1_4 = m2 * v_C2_1_4;
    let p_w_L5_in_L6_2_4 = z6.mul_add(p_v_C6_1_4, H_flange_2_4);
    let p_w_L5_in_L6_1_4 = z6.mul_add(p_v_C6_2_4, H_flange_1_4);
    let p_w_J5_3_4 = p_w_L5_in_L6_2_4.mul_add(c6, H_wrist2_2_4) - p_w_L5_in_L6_1_4 * s6;
    let p_w_L4_in_J5_2_4 = H_wrist2_3_4 + H_flange_3_4;
    let p_w_L4_in_J5_1_4 = p_w_L5_in_L6_2_4.mul_add(s6, H_wrist2_1_4) + p_w_L5_in_L6_1_4 * c6;
    let p_w_J4_3_4 = p_w_L4_in_J5_2_4.mul_add(c5, H_wrist1_2_4) - p_w_L4_in_J5_1_4 * s5_2;
    let p_w_L3_in_J4_2_4 = y4.mul_add(p_v_C4_1_7, H_wrist1_3_4) + p_w_J5_3_4;
    let p_w_L3_in_J4_1_4 = y4.mul_add(p_v_C4_3_4, H_wrist1_1_4) + p_w_L4_in_J5_2_4 * s5_2
        + p_w_L4_in_J5_1_4 * c5;
    let p_w_L2_in_J3_2_4 = x3.mul_add(p_v_C3_2_7, H_forearm_3_4) + y3 * p_v_C3_1_7
        + a3 * p_v_C3_3_8 + d3 * p_v_C3_1_8 + p_w_J4_3_4;
    let p_w_L2_in_J3_1_4 = d4.mul_add(p_v_C4_2_4, H_forearm_1_4) + y3 * p_v_C3_3_7
        + z3 * p_v_C3_2_7 + d3 * p_v_C3_2_8 + p_w_L3_in_J4_2_4 * s4_2 + p_w_L3_in_J4_1_4 * c4;
    let p_w_L1_in_L2_2_4 = (-a2).mul_add(p_v_C3_3_8, H_upper_arm_2_4) + z2 * p_v_C2_1_4
        - p_w_L2_in_J3_2_4 * c3 + p_w_L2_in_J3_1_4 * s3_2 + p_v_C2_3_4 * a2_plus_x2;
    let p_w_L1_in_L2_1_4 = (-y2).mul_add(p_v_C2_3_4, H_upper_arm_1_4) + z2 * p_v_C2_2_4
        + p_w_L2_in_J3_2_4 * s3_2 + p_w_L2_in_J3_1_4 * c3;
    let w_L4_in_J5_1_5 = s4_2 * c5;
    let w_L4_in_J5_2_5 = s4_2 * s5_2;
    let w_L5_in_L6_1_5 = w_L4_in_J5_1_5.mul_add(c6, c4 * s6);
    let w_L5_in_L6_2_5 = (-c4).mul_add(c6, w_L4_in_J5_1_5 * s6);
    let v_C2_2_5 = a2_plus_x2;
    let v_L2_in_J3_1_4 = a2 * s3_2;
    let v_L2_in_J3_2_4 = a2 * c3;
    let v_C3_2_9 = a3 + v_L2_in_J3_2_4;
    let v_C3_1_9 = z3 - v_L2_in_J3_1_4;
    let v_C3_3_9 = x3 + v_C3_2_9;
    let v_C4_1_7 = d4 - v_L2_in_J3_1_4;
    let v_L3_in_J4_1_5 = v_C4_1_7 * c4;
    let v_L3_in_J4_2_5 = v_C4_1_7 * s4_2;
    let y4_c4 = y4 * c4;
    let v_C4_1_8 = v_L3_in_J4_1_5 + y4_c4;
    let y4_s4_2 = y4 * s4_2;
    let v_C4_3_5 = v_L3_in_J4_2_5 + y4_s4_2;
    let H_wrist1_1_5 = Ixx4 * s4_2;
    let H_wrist1_3_5 = Ixx4 * c4;
    let H_wrist2_1_5 = Ixx5 * w_L4_in_J5_1_5;
    let H_wrist2_2_5 = Iyy5 * c4;
    let H_wrist2_3_5 = Ixx5 * w_L4_in_J5_2_5;
    let v_L4_in_J5_1_5 = (-v_C3_2_9).mul_add(s5_2, v_L3_in_J4_1_5 * c5);
    let v_L4_in_J5_2_5 = v_L3_in_J4_1_5.mul_add(s5_2, v_C3_2_9 * c5);
    let v_L5_in_L6_1_5 = (-v_L3_in_J4_2_5).mul_add(s6, v_L4_in_J5_1_5 * c6);
    let v_L5_in_L6_2_5 = v_L4_in_J5_1_5.mul_add(s6, v_L3_in_J4_2_5 * c6);
    let z6_w_l5_in_l6_2_5 = z6 * w_L5_in_L6_2_5;
    let v_C6_1_5 = z6_w_l5_in_l6_2_5 - v_L5_in_L6_1_5;
    let z6_w_l5_in_l6_1_5 = z6 * w_L5_in_L6_1_5;
    let v_C6_2_5 = v_L5_in_L6_2_5 + z6_w_l5_in_l6_1_5;
    let H_flange_1_5 = Ixx6 * w_L5_in_L6_1_5;
    let H_flange_2_5 = Ixx6 * w_L5_in_L6_2_5;
    let H_flange_3_5 = Izz6 * w_L4_in_J5_2_5;
    let p_v_C6_2_5 = m6 * v_C6_2_5;
    let p_v_C6_1_5 = m6 * v_C6_1_5;
    let p_v_L4_in_J5_2_5 = m6 * v_L4_in_J5_2_5;
    let p_v_L4_in_J5_1_5 = (-p_v_C6_1_5).mul_add(c6, p_v_C6_2_5 * s6);
    let p_v_C4_3_5 = m4 * v_C4_3_5;
    let p_v_C4_1_9 = m4 * v_C4_1_8;
    let p_v_L3_in_J4_2_5 = p_v_C6_1_5.mul_add(s6, p_v_C6_2_5 * c6) + p_v_C4_3_5;
    let p_v_L3_in_J4_1_5 = p_v_L4_in_J5_1_5.mul_add(c5, p_v_L4_in_J5_2_5 * s5_2) + p_v_C4_1_9;
    let p_v_C4_2_5 = (-p_v_L3_in_J4_1_5).mul_add(s4_2, p_v_L3_in_J4_2_5 * c4);
    let p_v_C4_1_10 = p_v_L3_in_J4_2_5.mul_add(s4_2, m5 * v_C4_1_7) + p_v_L3_in_J4_1_5 * c4;
    let p_v_C3_3_9 = m3 * v_C3_3_9;
    let p_v_C3_1_9 = m3 * v_C3_1_9;
    let p_v_C3_2_9 = (-p_v_L4_in_J5_1_5).mul_add(s5_2, p_v_L4_in_J5_2_5 * c5)
        + p_v_C3_3_9 + v_C3_2_9 * m4_plus_m5;
    let p_v_C3_1_10 = p_v_C4_1_10 + p_v_C3_1_9;
    let p_v_C2_2_5 = m2 * v_C2_2_5;
    let p_w_L5_in_L6_2_5 = z6.mul_add(p_v_C6_1_5, H_flange_2_5);
    let p_w_L5_in_L6_1_5 = z6.mul_add(p_v_C6_2_5, H_flange_1_5);
    let p_w_J5_3_5 = (-p_w_L5_in_L6_2_5).mul_add(c6, H_wrist2_2_5) + p_w_L5_in_L6_1_5 * s6;
    let p_w_L4_in_J5_2_5 = H_wrist2_3_5 + H_flange_3_5;
    let p_w_L4_in_J5_1_5 = p_w_L5_in_L6_2_5.mul_add(s6, H_wrist2_1_5) + p_w_L5_in_L6_1_5 * c6;
    let c5_p_w_l4_in_j5_2_5 = p_w_L4_in_J5_2_5 * c5;
    let p_w_J4_3_5 = (-p_w_L4_in_J5_1_5).mul_add(s5_2, c5_p_w_l4_in_j5_2_5);
    let p_w_L3_in_J4_2_5 = y4.mul_add(p_v_C4_1_9, H_wrist1_3_5) + p_w_J5_3_5;
    let p_w_L3_in_J4_1_5_of_place = p_w_L4_in_J5_2_5.mul_add(s5_2, H_wrist1_1_5);
    let p_w_L3_in_J4_1_5 = p_w_L4_in_J5_1_5.mul_add(c5, y4 * p_v_C4_3_5)
        + p_w_L3_in_J4_1_5_of_place;
    let p_w_L2_in_J3_2_5 = y3.mul_add(p_v_C3_1_9, a3 * p_v_C4_2_5) - d3 * p_v_C3_1_10 + p_w_J4_3_5;
    let p_w_L2_in_J3_1_5 = (-y3).mul_add(p_v_C3_3_9, d4 * p_v_C4_2_5) + d3 * p_v_C3_2_9
        - p_w_L3_in_J4_2_5 * s4_2 + p_w_L3_in_J4_1_5 * c4;
    let p_w_L1_in_L2_2_5 = (-z2).mul_add(mp_L2_2, a2 * p_v_C4_2_5)
        + p_w_L2_in_J3_2_5 * c3 - p_w_L2_in_J3_1_5 * s3_2;
    let p_w_L1_in_L2_1_5 = p_w_L2_in_J3_2_5.mul_add(s3_2, z2 * p_v_C2_2_5) + p_w_L2_in_J3_1_5 * c3;
    let v_C3_3_10 = a3 + x3;
    let v_L3_in_J4_1_6 = d4 * c4;
    let v_L3_in_J4_2_6 = d4 * s4_2;
    let v_C4_1_9 = v_L3_in_J4_1_6 + y4_c4;
    let v_C4_3_6 = v_L3_in_J4_2_6 + y4_s4_2;
    let v_L4_in_J5_1_6 = (-a3).mul_add(s5_2, v_L3_in_J4_1_6 * c5);
    let v_L4_in_J5_2_6 = v_L3_in_J4_1_6.mul_add(s5_2, a3 * c5);
    let v_L5_in_L6_1_6 = (-v_L3_in_J4_2_6).mul_add(s6, v_L4_in_J5_1_6 * c6);
    let v_L5_in_L6_2_6 = v_L4_in_J5_1_6.mul_add(s6, v_L3_in_J4_2_6 * c6);
    let v_C6_1_6 = z6_w_l5_in_l6_2_5 - v_L5_in_L6_1_6;
    let v_C6_2_6 = v_L5_in_L6_2_6 + z6_w_l5_in_l6_1_5;
    let p_v_C6_2_6 = m6 * v_C6_2_6;
    let p_v_C6_1_6 = m6 * v_C6_1_6;
    let p_v_L4_in_J5_2_6 = m6 * v_L4_in_J5_2_6;
    let p_v_L4_in_J5_1_6 = (-p_v_C6_1_6).mul_add(c6, p_v_C6_2_6 * s6);
    let p_v_C4_3_6 = m4 * v_C4_3_6;
    let p_v_C4_1_11 = m4 * v_C4_1_9;
    let p_v_L3_in_J4_2_6 = p_v_C6_1_6.mul_add(s6, p_v_C6_2_6 * c6) + p_v_C4_3_6;
    let p_v_L3_in_J4_1_6 = p_v_L4_in_J5_1_6.mul_add(c5, p_v_L4_in_J5_2_6 * s5_2) + p_v_C4_1_11;
    let p_v_C4_2_6 = (-p_v_L3_in_J4_1_6).mul_add(s4_2, p_v_L3_in_J4_2_6 * c4);
    let p_v_C4_1_12 = p_v_L3_in_J4_2_6.mul_add(s4_2, d4 * m5) + p_v_L3_in_J4_1_6 * c4;
    let p_v_C3_3_10 = m3 * v_C3_3_10;
    let p_v_C3_2_10 = (-p_v_L4_in_J5_1_6).mul_add(s5_2, p_v_L4_in_J5_2_6 * c5)
        + p_v_C3_3_10 + a3 * m4_plus_m5;
    let p_v_C3_1_12 = p_v_C4_1_12 + p_v_C3_1_11;
    let p_w_L5_in_L6_2_6 = z6.mul_add(p_v_C6_1_6, H_flange_2_5);
    let p_w_L5_in_L6_1_6 = z6.mul_add(p_v_C6_2_6, H_flange_1_5);
    let p_w_J5_3_6 = (-p_w_L5_in_L6_2_6).mul_add(c6, H_wrist2_2_5) + p_w_L5_in_L6_1_6 * s6;
    let p_w_L4_in_J5_1_6 = p_w_L5_in_L6_2_6.mul_add(s6, H_wrist2_1_5) + p_w_L5_in_L6_1_6 * c6;
    let p_w_J4_3_6 = (-p_w_L4_in_J5_1_6).mul_add(s5_2, c5_p_w_l4_in_j5_2_5);
    let p_w_L3_in_J4_2_6 = y4.mul_add(p_v_C4_1_11, H_wrist1_3_5) + p_w_J5_3_6;
    let p_w_L3_in_J4_1_6 = p_w_L4_in_J5_1_6.mul_add(c5, y4 * p_v_C4_3_6)
        + p_w_L3_in_J4_1_5_of_place;
    let p_w_L2_in_J3_2_6 = y3.mul_add(p_v_C3_1_11, a3 * p_v_C4_2_6) - d3 * p_v_C3_1_12 + p_w_J4_3_6;
    let p_w_L2_in_J3_1_6 = (-y3).mul_add(p_v_C3_3_10, d4 * p_v_C4_2_6) + d3 * p_v_C3_2_10
        - p_w_L3_in_J4_2_6 * s4_2 + p_w_L3_in_J4_1_6 * c4;
    let p_w_L1_in_L2_2_6 = p_w_L2_in_J3_2_6.mul_add(c3, a2 * p_v_C4_2_6) - p_w_L2_in_J3_1_6 * s3_2;
    let p_w_L1_in_L2_1_6 = p_w_L2_in_J3_1_6.mul_add(c3, p_w_L2_in_J3_2_6 * s3_2);
    let w_L5_in_L6_1_6 = s5_2 * c6;
    let w_L5_in_L6_2_6 = s5_2 * s6;
    let H_wrist2_1_6 = Ixx5 * s5_2;
    let H_wrist2_3_6 = Ixx5 * c5;
    let v_C6_1_7 = z6 * w_L5_in_L6_2_6;
    let v_C6_2_7 = z6 * w_L5_in_L6_1_6;
    let H_flange_1_6 = Ixx6 * w_L5_in_L6_1_6;
    let H_flange_2_6 = Ixx6 * w_L5_in_L6_2_6;
    let H_flange_3_6 = Izz6 * c5;
    let p_v_C6_2_7 = m6 * v_C6_2_7;
    let p_v_C6_1_7 = m6 * v_C6_1_7;
    let p_v_L4_in_J5_1_7 = (-p_v_C6_1_7).mul_add(c6, p_v_C6_2_7 * s6);
    let p_v_L3_in_J4_2_7 = p_v_C6_1_7.mul_add(s6, p_v_C6_2_7 * c6);
    let p_v_L3_in_J4_1_7 = p_v_L4_in_J5_1_7 * c5;
    let p_v_C4_2_7 = (-p_v_L3_in_J4_1_7).mul_add(s4_2, p_v_L3_in_J4_2_7 * c4);
    let p_v_C4_1_13 = p_v_L3_in_J4_1_7.mul_add(c4, p_v_L3_in_J4_2_7 * s4_2);
    let p_v_C3_2_11 = p_v_L4_in_J5_1_7 * s5_2;
    let p_w_L5_in_L6_2_7 = z6.mul_add(p_v_C6_1_7, H_flange_2_6);
    let p_w_L5_in_L6_1_7 = z6.mul_add(p_v_C6_2_7, H_flange_1_6);
    let p_w_J5_3_7 = (-p_w_L5_in_L6_1_7).mul_add(s6, p_w_L5_in_L6_2_7 * c6);
    let p_w_L4_in_J5_2_6 = H_wrist2_3_6 + H_flange_3_6;
    let p_w_L4_in_J5_1_7 = p_w_L5_in_L6_2_7.mul_add(s6, H_wrist2_1_6) + p_w_L5_in_L6_1_7 * c6;
    let p_w_J4_3_7 = p_w_L4_in_J5_2_6.mul_add(c5, Iyy4) + p_w_L4_in_J5_1_7 * s5_2;
    let p_w_L3_in_J4_1_7 = (-p_w_L4_in_J5_1_7).mul_add(c5, p_w_L4_in_J5_2_6 * s5_2);
    let p_w_L2_in_J3_2_7 = (-d3).mul_add(p_v_C4_1_13, a3 * p_v_C4_2_7) - p_w_J4_3_7;
    let p_w_L2_in_J3_1_7 = (-d3).mul_add(p_v_C3_2_11, d4 * p_v_C4_2_7)
        + p_w_J5_3_7 * s4_2 - p_w_L3_in_J4_1_7 * c4;
    let p_w_L1_in_L2_2_7 = p_w_L2_in_J3_2_7.mul_add(c3, a2 * p_v_C4_2_7) - p_w_L2_in_J3_1_7 * s3_2;
    let p_w_L1_in_L2_1_7 = p_w_L2_in_J3_1_7.mul_add(c3, p_w_L2_in_J3_2_7 * s3_2);
    let v_C6_1_8 = z6 * c6;
    let v_C6_2_8 = z6 * s6;
    let H_flange_1_7 = Ixx6 * s6;
    let H_flange_2_7 = Ixx6 * c6;
    let p_v_C6_2_8 = m6 * v_C6_2_8;
    let p_v_C6_1_8 = m6 * v_C6_1_8;
    let p_v_L4_in_J5_1_8 = p_v_C6_1_8.mul_add(c6, p_v_C6_2_8 * s6);
    let p_v_L3_in_J4_2_8 = (-p_v_C6_1_8).mul_add(s6, p_v_C6_2_8 * c6);
    let p_v_L3_in_J4_1_8 = p_v_L4_in_J5_1_8 * c5;
    let p_v_C4_2_8 = (-p_v_L3_in_J4_1_8).mul_add(s4_2, p_v_L3_in_J4_2_8 * c4);
    let p_v_C4_1_14 = p_v_L3_in_J4_1_8.mul_add(c4, p_v_L3_in_J4_2_8 * s4_2);
    let p_v_C3_2_12 = p_v_L4_in_J5_1_8 * s5_2;
    let p_w_L5_in_L6_2_8 = z6.mul_add(p_v_C6_1_8, H_flange_2_7);
    let p_w_L5_in_L6_1_8 = z6.mul_add(p_v_C6_2_8, H_flange_1_7);
    let p_w_J5_3_8 = p_w_L5_in_L6_2_8.mul_add(c6, Iyy5) + p_w_L5_in_L6_1_8 * s6;
    let p_w_L4_in_J5_1_8 = (-p_w_L5_in_L6_1_8).mul_add(c6, p_w_L5_in_L6_2_8 * s6);
    let p_w_J4_3_8 = p_w_L4_in_J5_1_8 * s5_2;
    let p_w_L3_in_J4_1_8 = p_w_L4_in_J5_1_8 * c5;
    let p_w_L2_in_J3_2_8 = (-d3).mul_add(p_v_C4_1_14, a3 * p_v_C4_2_8) + p_w_J4_3_8;
    let p_w_L2_in_J3_1_8 = (-d3).mul_add(p_v_C3_2_12, d4 * p_v_C4_2_8)
        - p_w_J5_3_8 * s4_2 - p_w_L3_in_J4_1_8 * c4;
    let p_w_L1_in_L2_2_8 = p_w_L2_in_J3_2_8.mul_add(c3, a2 * p_v_C4_2_8) - p_w_L2_in_J3_1_8 * s3_2;
    let p_w_L1_in_L2_1_8 = p_w_L2_in_J3_1_8.mul_add(c3, p_w_L2_in_J3_2_8 * s3_2);
    let p_w_L3_in_J4_1_9 = Izz6 * s5_2;
    let p_w_L2_in_J3_1_9 = p_w_L3_in_J4_1_9 * c4;
    let p_w_L1_in_L2_2_9 = (-p_w_L2_in_J3_1_9).mul_add(s3_2, H_flange_3_6 * c3);
    let p_w_L1_in_L2_1_9 = p_w_L2_in_J3_1_9.mul_add(c3, H_flange_3_6 * s3_2);
    let p_w_J3_3_3 = d4.mul_add(p_v_C4_1_10, Iyy3) + x3 * p_v_C3_3_9 + z3 * p_v_C3_1_9
        + a3 * p_v_C3_2_9 + p_w_L3_in_J4_2_5 * c4 + p_w_L3_in_J4_1_5 * s4_2;
    let p_w_J3_3_4 = d4.mul_add(p_v_C4_1_12, Iyy3) + x3 * p_v_C3_3_10 + z3 * p_v_C3_1_11
        + a3 * p_v_C3_2_10 + p_w_L3_in_J4_2_6 * c4 + p_w_L3_in_J4_1_6 * s4_2;
    let p_w_J3_3_5 = (-a3).mul_add(p_v_C3_2_11, d4 * p_v_C4_1_13) - p_w_J5_3_7 * c4
        - p_w_L3_in_J4_1_7 * s4_2;
    let p_w_J3_3_6 = (-a3).mul_add(p_v_C3_2_12, d4 * p_v_C4_1_14) + p_w_J5_3_8 * c4
        - p_w_L3_in_J4_1_8 * s4_2;
    let p_w_J3_3_7 = p_w_L3_in_J4_1_9 * s4_2;
    let l1_of_place = (-p_w_L1_in_L2_1_9).mul_add(s2_2, p_w_L1_in_L2_2_9 * c2);
    let izz6_inv = S::int(1) / Izz6;
    let l1 = l1_of_place * izz6_inv;
    let s2 = I1 + s2_2 * p_w_L1_in_L2_1_9.mul_add(l1, p_w_L1_in_L2_1_4)
        + c2 * (-p_w_L1_in_L2_2_9).mul_add(l1, p_w_L1_in_L2_2_4);
    let p_w_j3_3_7_l1 = p_w_J3_3_7 * l1;
    let s3 = (-p_w_L1_in_L2_1_5).mul_add(s2_2, p_w_L1_in_L2_2_5 * c2) - p_w_j3_3_7_l1;
    let s4 = (-p_w_L1_in_L2_1_6).mul_add(s2_2, p_w_L1_in_L2_2_6 * c2) - p_w_j3_3_7_l1;
    let s5 = (-p_w_L1_in_L2_2_7).mul_add(c2, p_w_L1_in_L2_1_7 * s2_2) - H_flange_3_6 * l1;
    let r6_of_place = (-p_w_L1_in_L2_1).mul_add(c2, p_w_L1_in_L2_2 * s2_2);
    let r6_of_place_2 = s6
        * ((-v_L4_in_J5_1).mul_add(p_v_C6_1, v_L3_in_J4_2 * p_v_C6_2)
            - w_J5_3 * p_w_L5_in_L6_2 - w_L4_in_J5_1 * p_w_L5_in_L6_1
            + x_L5_in_L6_2 * x_L3_in_J4_2_2 + x_L5_in_L6_1 * x_L4_in_J5_1_2
            + x_L4_in_J5_1 * x_L5_in_L6_1_2 + x_L3_in_J4_2 * x_L5_in_L6_2_2)
        + c6
            * ((-v_L4_in_J5_1).mul_add(p_v_C6_2, w_L4_in_J5_1 * p_w_L5_in_L6_2)
                - v_L3_in_J4_2 * p_v_C6_1 - w_J5_3 * p_w_L5_in_L6_1
                + x_L5_in_L6_1 * x_L3_in_J4_2_2 - x_L5_in_L6_2 * x_L4_in_J5_1_2
                + x_L3_in_J4_2 * x_L5_in_L6_1_2 - x_L4_in_J5_1 * x_L5_in_L6_2_2);
    let tau6_plus_h_flange_3_2 = tau6 + H_flange_3_2;
    let r6_of_place_3 = r6_of_place_2 + tau6_plus_h_flange_3_2;
    let r6 = p_w_L1_in_L2_2_2.mul_add(c2, tau1) - p_w_L1_in_L2_1_2 * s2_2
        + q2_dot * r6_of_place - l1 * r6_of_place_3;
    let l7 = p_w_J3_3_7 * izz6_inv;
    let p_w_j3_3_7_l7 = p_w_J3_3_7 * l7;
    let s8 = Izz2 + y2 * mp_L2_2 + a2 * (-p_v_C3_1_10).mul_add(s3_2, p_v_C3_2_9 * c3)
        + p_w_J3_3_3 + p_v_C2_2_5 * a2_plus_x2 - p_w_j3_3_7_l7;
    let s9 = a2 * (-p_v_C3_1_12).mul_add(s3_2, p_v_C3_2_10 * c3) + p_w_J3_3_4 - p_w_j3_3_7_l7;
    let s10 = a2 * p_v_C3_2_11.mul_add(c3, p_v_C4_1_13 * s3_2) - p_w_J3_3_5 - H_flange_3_6 * l7;
    let r11 = tau2
        + a2
            * (q3_dot * p_v_C3_1_2.mul_add(c3, p_v_C3_2_2 * s3_2) + p_v_C3_2_4 * c3
                + p_v_C3_1_4 * s3_2) - y2 * p_v_C2_1_2
        + g * F_x_L1_in_L2_1.mul_add(c2, F_x_L1_in_L2_2 * s2_2) - p_w_J3_3
        + p_v_C2_2_2 * a2_plus_x2 - q1_dot * r6_of_place - l7 * r6_of_place_3;
    let l12 = l7;
    let s13 = (-p_w_J3_3_7).mul_add(l12, p_w_J3_3_4);
    let s14 = (-H_flange_3_6).mul_add(l12, -p_w_J3_3_5);
    let r15 = tau3 - p_w_J3_3
        + s3_2
            * ((-w_L1_in_L2_1).mul_add(p_w_L2_in_J3_1, w_L1_in_L2_2 * p_w_L2_in_J3_2)
                + F_x_L2_in_J3_1 * x_L1_in_L2_1 + F_x_L2_in_J3_2 * x_L1_in_L2_2
                - mp_L2_2 * F_x_L6_2 + mp_L2_1 * F_x_L6_1 - p_v_C3_2_2 * a2_q2_dot)
        + c3
            * (w_L1_in_L2_2.mul_add(p_w_L2_in_J3_1, w_L1_in_L2_1 * p_w_L2_in_J3_2)
                + F_x_L2_in_J3_2 * x_L1_in_L2_1 - F_x_L2_in_J3_1 * x_L1_in_L2_2
                - mp_L2_1 * F_x_L6_2 - mp_L2_2 * F_x_L6_1 - p_v_C3_1_2 * a2_q2_dot)
        - l12 * r6_of_place_3;
    let l16 = H_flange_3_6 * izz6_inv;
    let s17 = (-H_flange_3_6).mul_add(l16, p_w_J4_3_7);
    let r18 = tau4 + p_w_J4_3_2
        + s4_2
            * ((-v_C4_2).mul_add(p_v_L3_in_J4_2, x_L6_1_2 * F_x_L3_in_J4_1_2)
                - v_C4_1 * p_v_L3_in_J4_1 - w_J3_3 * p_w_L3_in_J4_2
                - w_L2_in_J3_1 * p_w_L3_in_J4_1 - F_x_L3_in_J4_1 * x_L2_in_J3_1_2
                - x_L6_2 * F_x_L3_in_J4_2_2)
        + c4
            * ((-v_C4_1).mul_add(p_v_L3_in_J4_2, v_C4_2 * p_v_L3_in_J4_1)
                + w_L2_in_J3_1 * p_w_L3_in_J4_2 - w_J3_3 * p_w_L3_in_J4_1
                - F_x_L3_in_J4_2 * x_L2_in_J3_1_2 - x_L6_1_2 * F_x_L3_in_J4_2_2
                - x_L6_2 * F_x_L3_in_J4_1_2) - l16 * r6_of_place_3;
    let s2_inv = S::int(1) / s2;
    let l19 = s3 * s2_inv;
    let s20 = (-s3).mul_add(l19, s8);
    let s21 = (-s4).mul_add(l19, s9);
    let s22 = (-s5).mul_add(l19, s10);
    let s23_of_place = (-p_w_L1_in_L2_1_8).mul_add(s2_2, p_w_L1_in_L2_2_8 * c2);
    let s23 = p_w_J3_3_6 - a2 * p_v_C3_2_12.mul_add(c3, p_v_C4_1_14 * s3_2) - l19 * s23_of_place;
    let r24 = (-r6).mul_add(l19, r11);
    let l25 = s4 * s2_inv;
    let s26 = (-s4).mul_add(l25, s13);
    let s27 = (-s5).mul_add(l25, s14);
    let s28 = (-l25).mul_add(s23_of_place, p_w_J3_3_6);
    let r29 = (-r6).mul_add(l25, r15);
    let l30 = s5 * s2_inv;
    let s31 = (-s5).mul_add(l30, s17);
    let s32 = (-l30).mul_add(s23_of_place, p_w_J4_3_8);
    let r33 = (-r6).mul_add(l30, r18);
    let l34 = s2_inv * s23_of_place;
    let s35 = (-l34).mul_add(s23_of_place, p_w_J5_3_8);
    let r36 = tau5 - p_w_J5_3_2
        + s5_2
            * ((-v_C3_2).mul_add(p_v_L4_in_J5_2, v_L3_in_J4_1 * p_v_L4_in_J5_1)
                + w_J4_3 * p_w_L4_in_J5_2 - w_L3_in_J4_1 * p_w_L4_in_J5_1
                - x_L6_3_3 * x_L2_in_J3_2_2 + F_x_L4_in_J5_1 * x_L3_in_J4_1_2
                - x_L6_2_2 * x_L4_in_J5_2_2 + x_L3_in_J4_1 * F_x_L4_in_J5_1_2)
        + c5
            * (v_C3_2.mul_add(p_v_L4_in_J5_1, v_L3_in_J4_1 * p_v_L4_in_J5_2)
                + w_L3_in_J4_1 * p_w_L4_in_J5_2 + w_J4_3 * p_w_L4_in_J5_1
                + F_x_L4_in_J5_1 * x_L2_in_J3_2_2 + x_L6_3_3 * x_L3_in_J4_1_2
                - x_L3_in_J4_1 * x_L4_in_J5_2_2 - x_L6_2_2 * F_x_L4_in_J5_1_2) - r6 * l34;
    let s20_inv = S::int(1) / s20;
    let l37 = s21 * s20_inv;
    let s38 = (-s21).mul_add(l37, s26);
    let s39 = (-s22).mul_add(l37, s27);
    let s40 = (-s23).mul_add(l37, s28);
    let r41 = (-r24).mul_add(l37, r29);
    let l42 = s22 * s20_inv;
    let s43 = (-s22).mul_add(l42, s31);
    let s44 = (-s23).mul_add(l42, s32);
    let r45 = (-r24).mul_add(l42, r33);
    let l46 = s23 * s20_inv;
    let s47 = (-s23).mul_add(l46, s35);
    let r48 = (-r24).mul_add(l46, r36);
    let s38_inv = S::int(1) / s38;
    let l49 = s39 * s38_inv;
    let s50 = (-s39).mul_add(l49, s43);
    let s51 = (-s40).mul_add(l49, s44);
    let r52 = (-r41).mul_add(l49, r45);
    let l53 = s40 * s38_inv;
    let s54 = (-s40).mul_add(l53, s47);
    let r55 = (-r41).mul_add(l53, r48);
    let s50_inv = S::int(1) / s50;
    let l56 = s51 * s50_inv;
    let s57 = (-s51).mul_add(l56, s54);
    let r58 = (-r52).mul_add(l56, r55);
    let q5_ddot = r58 / s57;
    let q4_ddot = s50_inv * (-q5_ddot).mul_add(s51, r52);
    let q3_ddot = s38_inv * ((-q4_ddot).mul_add(s39, r41) - q5_ddot * s40);
    let q2_ddot = s20_inv * ((-q3_ddot).mul_add(s21, r24) - q4_ddot * s22 - q5_ddot * s23);
    let q1_ddot = s2_inv
        * ((-q2_ddot).mul_add(s3, r6) - q3_ddot * s4 - q4_ddot * s5 - q5_ddot * s23_of_place);
    let q6_ddot = izz6_inv
        * (r6_of_place_3 - q4_ddot * H_flange_3_6 - p_w_J3_3_7 * (q2_ddot + q3_ddot)
            - q1_ddot * l1_of_place);
    [q1_ddot, q2_ddot, q3_ddot, q4_ddot, q5_ddot, q6_ddot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 6],
    q_dot: &[S; 6],
) -> [S; 6] {
    let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot, q6_dot] = *q_dot;
    // Values.
    // q1'
    let q1_dot_value = q1_dot;
    // q2'
    let q2_dot_value = q2_dot;
    // q3'
    let q3_dot_value = q3_dot;
    // q4'
    let q4_dot_value = q4_dot;
    // q5'
    let q5_dot_value = q5_dot;
    // q6'
    let q6_dot_value = q6_dot;
    [q1_dot_value, q2_dot_value, q3_dot_value, q4_dot_value, q5_dot_value, q6_dot_value]
}

/// Kinetic energy T.
///
/// 180 operations, 5 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 6], q_dot: &[S; 6]) -> S {
    let Parameters {
        a2, a3, d3, d4, m2, m3, m4, m5, m6, x2, y2, z2, x3, y3, z3, y4, z6, I1, Ixx2, Iyy2, Izz2,
        Ixx3, Iyy3, Izz3, Ixx4, Iyy4, Ixx5, Iyy5, Ixx6, Izz6,
        ..
    } = *p;
    let [_, q2, q3, q4, q5, q6] = *q;
    let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot, q6_dot] = *q_dot;
    // Sines and cosines.
    let (s2_2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    let (s4_2, c4) = q4.sin_cos();
    let (s5_2, c5) = q5.sin_cos();
    let (s6, c6) = q6.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_L1_in_L2_1 = q1_dot * s2_2;
    let w_L1_in_L2_2 = q1_dot * c2;
    let w_L2_in_J3_1 = w_L1_in_L2_2.mul_add(s3_2, w_L1_in_L2_1 * c3);
    let w_L2_in_J3_2 = (-w_L1_in_L2_2).mul_add(c3, w_L1_in_L2_1 * s3_2);
    let w_J3_3 = q2_dot + q3_dot;
    let w_L3_in_J4_1 = (-w_J3_3).mul_add(s4_2, w_L2_in_J3_1 * c4);
    let w_L3_in_J4_2 = w_J3_3.mul_add(c4, w_L2_in_J3_1 * s4_2);
    let w_J4_3 = q4_dot - w_L2_in_J3_2;
    let w_L4_in_J5_1 = w_J4_3.mul_add(s5_2, w_L3_in_J4_1 * c5);
    let w_L4_in_J5_2 = (-w_J4_3).mul_add(c5, w_L3_in_J4_1 * s5_2);
    let w_J5_3 = q5_dot + w_L3_in_J4_2;
    let w_L5_in_L6_1 = (-w_J5_3).mul_add(s6, w_L4_in_J5_1 * c6);
    let w_L5_in_L6_2 = w_J5_3.mul_add(c6, w_L4_in_J5_1 * s6);
    let w_L6_3 = q6_dot - w_L4_in_J5_2;
    let v_C2_1 = (-y2).mul_add(q2_dot, z2 * w_L1_in_L2_2);
    let a2_plus_x2 = a2 + x2;
    let v_C2_2 = (-z2).mul_add(w_L1_in_L2_1, q2_dot * a2_plus_x2);
    let v_C2_3 = (-y2).mul_add(w_L1_in_L2_1, w_L1_in_L2_2 * a2_plus_x2);
    let H_upper_arm_1 = Ixx2 * w_L1_in_L2_1;
    let H_upper_arm_2 = Iyy2 * w_L1_in_L2_2;
    let a2_q2_dot = a2 * q2_dot;
    let v_L2_in_J3_1 = a2_q2_dot * s3_2;
    let v_L2_in_J3_2 = a2_q2_dot * c3;
    let v_L2_in_J3_3 = a2 * w_L1_in_L2_2;
    let v_C3_1 = d3.mul_add(w_L2_in_J3_2, -v_L2_in_J3_1);
    let v_C3_2 = (-d3).mul_add(w_L2_in_J3_1, a3 * w_J3_3) + v_L2_in_J3_2;
    let v_C3_3 = a3.mul_add(w_L2_in_J3_2, -v_L2_in_J3_3);
    let v_C3_1_2 = (-y3).mul_add(w_L2_in_J3_2, z3 * w_J3_3) + v_C3_1;
    let v_C3_2_2 = x3.mul_add(w_L2_in_J3_2, z3 * w_L2_in_J3_1) + v_C3_3;
    let v_C3_3_2 = x3.mul_add(w_J3_3, y3 * w_L2_in_J3_1) + v_C3_2;
    let H_forearm_1 = Ixx3 * w_L2_in_J3_1;
    let H_forearm_3 = Izz3 * w_L2_in_J3_2;
    let v_C4_1 = d4.mul_add(w_J3_3, v_C3_1);
    let v_C4_2 = d4.mul_add(w_L2_in_J3_1, v_C3_3);
    let v_L3_in_J4_1 = v_C4_2.mul_add(s4_2, v_C4_1 * c4);
    let v_L3_in_J4_2 = (-v_C4_2).mul_add(c4, v_C4_1 * s4_2);
    let v_C4_1_2 = y4.mul_add(w_L3_in_J4_2, v_L3_in_J4_1);
    let v_C4_3 = y4.mul_add(w_L3_in_J4_1, -v_L3_in_J4_2);
    let H_wrist1_1 = Ixx4 * w_L3_in_J4_1;
    let H_wrist1_2 = Iyy4 * w_J4_3;
    let H_wrist1_3 = Ixx4 * w_L3_in_J4_2;
    let H_wrist2_1 = Ixx5 * w_L4_in_J5_1;
    let H_wrist2_2 = Iyy5 * w_J5_3;
    let H_wrist2_3 = Ixx5 * w_L4_in_J5_2;
    let v_L4_in_J5_1 = (-v_C3_2).mul_add(s5_2, v_L3_in_J4_1 * c5);
    let v_L4_in_J5_2 = v_L3_in_J4_1.mul_add(s5_2, v_C3_2 * c5);
    let v_L5_in_L6_1 = (-v_L3_in_J4_2).mul_add(s6, v_L4_in_J5_1 * c6);
    let v_L5_in_L6_2 = v_L4_in_J5_1.mul_add(s6, v_L3_in_J4_2 * c6);
    let v_C6_1 = z6.mul_add(w_L5_in_L6_2, v_L5_in_L6_1);
    let v_C6_2 = z6.mul_add(w_L5_in_L6_1, -v_L5_in_L6_2);
    let H_flange_1 = Ixx6 * w_L5_in_L6_1;
    let H_flange_2 = Ixx6 * w_L5_in_L6_2;
    let H_flange_3 = Izz6 * w_L6_3;
    let H_column_3_2 = I1 * q1_dot;
    let H_upper_arm_3_2 = Izz2 * q2_dot;
    let H_forearm_2_2 = Iyy3 * w_J3_3;
    let v_c2_1_sq_plus_v_c2_2_sq = v_C2_2.mul_add(v_C2_2, v_C2_1 * v_C2_1);
    let energy_of_place = v_C3_2_2.mul_add(v_C3_2_2, v_C3_1_2 * v_C3_1_2);
    let v_c6_1_sq_plus_v_c6_2_sq = v_C6_2.mul_add(v_C6_2, v_C6_1 * v_C6_1);
    let energy_of_place_2 = w_L3_in_J4_1.mul_add(H_wrist1_1, w_L2_in_J3_2 * H_forearm_3);
    let energy_of_place_3 = w_L3_in_J4_2.mul_add(H_wrist1_3, w_J4_3 * H_wrist1_2);
    let energy_of_place_4 = w_J5_3.mul_add(H_wrist2_2, w_L4_in_J5_1 * H_wrist2_1);
    let energy_of_place_5 = w_L5_in_L6_1.mul_add(H_flange_1, w_L4_in_J5_2 * H_wrist2_3);
    let energy_of_place_6 = energy_of_place_2 + energy_of_place_3;
    let energy_of_place_7 = energy_of_place_4 + energy_of_place_5;
    let energy_of_place_8 = w_L6_3.mul_add(H_flange_3, w_L5_in_L6_2 * H_flange_2);
    let energy_of_place_9 = v_C3_2 * v_C3_2 * (m4 + m5)
        + m4 * v_C4_3.mul_add(v_C4_3, v_C4_1_2 * v_C4_1_2);
    let energy_of_q1_dot = q1_dot.mul_add(H_column_3_2, w_L1_in_L2_1 * H_upper_arm_1);
    let energy_of_q2_dot = q2_dot.mul_add(H_upper_arm_3_2, w_L1_in_L2_2 * H_upper_arm_2);
    let energy_of_place_10 = w_J3_3.mul_add(H_forearm_2_2, w_L2_in_J3_1 * H_forearm_1);
    let energy_of_q1_dot_2 = m5 * v_C4_2.mul_add(v_C4_2, v_C4_1 * v_C4_1) + energy_of_q1_dot;
    let energy_of_q2_dot_2 = energy_of_q2_dot + energy_of_place_10;
    let energy_of_place_11 = energy_of_place_8 + energy_of_place_9;
    let energy_of_motion = energy_of_q1_dot_2 + energy_of_q2_dot_2;
    let energy_of_place_12 = energy_of_place_6 + energy_of_place_7;
    let energy_of_motion_2 = energy_of_place_11 + energy_of_motion;
    let energy_of_motion_3 = energy_of_place_12 + energy_of_motion_2;
    // Values.
    let energy = S::ratio(1, 2) * m2 * v_C2_3.mul_add(v_C2_3, v_c2_1_sq_plus_v_c2_2_sq)
        + S::ratio(1, 2) * m3 * v_C3_3_2.mul_add(v_C3_3_2, energy_of_place)
        + S::ratio(1, 2) * m6 * v_L4_in_J5_2.mul_add(v_L4_in_J5_2, v_c6_1_sq_plus_v_c6_2_sq)
        + S::ratio(1, 2) * energy_of_motion_3;
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
    let (s3_2, c3) = q3.sin_cos();
    let (s4_2, c4) = q4.sin_cos();
    let (s5_2, c5) = q5.sin_cos();
    let (s6, c6) = q6.sin_cos();
    let (s2_2, c2) = q2.sin_cos();
    // Step by step, each after the terms that it needs.
    let m4_plus_m5 = m4 + m5;
    let m6_plus_m4_plus_m5 = m6 + m4_plus_m5;
    let mp_L2_1_of_m3_m4_m5_m6 = m3 + m6_plus_m4_plus_m5;
    let mp_L2_1 = m2 * (a2 + x2) + a2 * mp_L2_1_of_m3_m4_m5_m6;
    let mp_L2_2 = m2 * y2;
    let mp_L2_3 = m2 * z2;
    let mp_J3_1 = a3 * mp_L2_1_of_m3_m4_m5_m6;
    let mp_J3_3 = d3 * mp_L2_1_of_m3_m4_m5_m6;
    let mp_L3_1 = m3 * x3;
    let mp_L3_2 = m3 * y3;
    let mp_L3_3 = d4.mul_add(m6_plus_m4_plus_m5, m3 * z3);
    let mp_L4_2 = m4 * y4;
    let mp_L6_3 = m6 * z6;
    let x_L2_in_J3_1 = mp_L2_2.mul_add(s3_2, mp_L2_1 * c3);
    let x_L2_in_J3_2 = (-mp_L2_2).mul_add(c3, mp_L2_1 * s3_2);
    let x_L6_1 = mp_J3_1 + x_L2_in_J3_1;
    let x_L6_3 = mp_L2_3 + mp_J3_3;
    let x_L6_1_2 = mp_L3_1 + x_L6_1;
    let x_L6_2 = mp_L3_2 - x_L6_3;
    let x_L6_3_2 = mp_L3_3 - x_L2_in_J3_2;
    let x_L3_in_J4_1 = x_L6_2.mul_add(s4_2, x_L6_1_2 * c4);
    let x_L3_in_J4_2 = (-x_L6_2).mul_add(c4, x_L6_1_2 * s4_2);
    let x_L6_2_2 = mp_L4_2 + x_L6_3_2;
    let x_L4_in_J5_1 = x_L6_2_2.mul_add(s5_2, x_L3_in_J4_1 * c5);
    let x_L4_in_J5_2 = (-x_L6_2_2).mul_add(c5, x_L3_in_J4_1 * s5_2);
    let x_L5_in_L6_1 = (-x_L3_in_J4_2).mul_add(s6, x_L4_in_J5_1 * c6);
    let x_L5_in_L6_2 = x_L4_in_J5_1.mul_add(s6, x_L3_in_J4_2 * c6);
    let x_L6_3_3 = mp_L6_3 - x_L4_in_J5_2;
    let x_L1_in_L2_1 = g * s2_2;
    let x_L1_in_L2_2 = g * c2;
    let x_L2_in_J3_1_2 = x_L1_in_L2_2.mul_add(s3_2, x_L1_in_L2_1 * c3);
    let x_L2_in_J3_2_2 = (-x_L1_in_L2_2).mul_add(c3, x_L1_in_L2_1 * s3_2);
    let x_L3_in_J4_1_2 = x_L2_in_J3_1_2 * c4;
    let x_L3_in_J4_2_2 = x_L2_in_J3_1_2 * s4_2;
    let x_L4_in_J5_1_2 = (-x_L2_in_J3_2_2).mul_add(s5_2, x_L3_in_J4_1_2 * c5);
    let x_L4_in_J5_2_2 = x_L3_in_J4_1_2.mul_add(s5_2, x_L2_in_J3_2_2 * c5);
    let x_L5_in_L6_1_2 = (-x_L3_in_J4_2_2).mul_add(s6, x_L4_in_J5_1_2 * c6);
    let x_L5_in_L6_2_2 = x_L4_in_J5_1_2.mul_add(s6, x_L3_in_J4_2_2 * c6);
    // Values.
    let energy = (-x_L6_3_3).mul_add(x_L4_in_J5_2_2, x_L5_in_L6_1 * x_L5_in_L6_1_2)
        + x_L5_in_L6_2 * x_L5_in_L6_2_2;
    energy
}

/// The power of the loads that have no potential: the rate of T + V.
///
/// 11 operations.
#[must_use]
pub fn power<S: Scalar>(p: &Parameters<S>, _q: &[S; 6], q_dot: &[S; 6]) -> S {
    let Parameters { tau1, tau2, tau3, tau4, tau5, tau6, .. } = *p;
    let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot, q6_dot] = *q_dot;
    // Values.
    // d(T + V)/dt = q1'*tau1 + q2'*tau2 + q3'*tau3 + q4'*tau4 + q5'*tau5 + q6'*tau6
    let rate = q2_dot.mul_add(tau2, q1_dot * tau1) + q3_dot * tau3 + q4_dot * tau4
        + q5_dot * tau5 + q6_dot * tau6;
    rate
}

/// The generalized speeds u, from q and q'.
///
/// 0 operations.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 6],
    q_dot: &[S; 6],
) -> [S; 6] {
    let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot, q6_dot] = *q_dot;
    // Values.
    // u1 = q1'
    let u1_value = q1_dot;
    // u2 = q2'
    let u2_value = q2_dot;
    // u3 = q3'
    let u3_value = q3_dot;
    // u4 = q4'
    let u4_value = q4_dot;
    // u5 = q5'
    let u5_value = q5_dot;
    // u6 = q6'
    let u6_value = q6_dot;
    [u1_value, u2_value, u3_value, u4_value, u5_value, u6_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 0 operations.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 6],
    _q_dot: &[S; 6],
    v_dot: &[S; 6],
) -> [S; 6] {
    let [q1_ddot, q2_ddot, q3_ddot, q4_ddot, q5_ddot, q6_ddot] = *v_dot;
    // Values.
    // u1' = q1''
    let u1_dot_value = q1_ddot;
    // u2' = q2''
    let u2_dot_value = q2_ddot;
    // u3' = q3''
    let u3_dot_value = q3_ddot;
    // u4' = q4''
    let u4_dot_value = q4_ddot;
    // u5' = q5''
    let u5_dot_value = q5_ddot;
    // u6' = q6''
    let u6_dot_value = q6_ddot;
    [u1_dot_value, u2_dot_value, u3_dot_value, u4_dot_value, u5_dot_value, u6_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 0 operations.
#[must_use]
pub fn motion_variables<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 6],
    u: &[S; 6],
) -> [S; 6] {
    let [u1, u2, u3, u4, u5, u6] = *u;
    // Values.
    // q1' = u1
    let q1_dot_value = u1;
    // q2' = u2
    let q2_dot_value = u2;
    // q3' = u3
    let q3_dot_value = u3;
    // q4' = u4
    let q4_dot_value = u4;
    // q5' = u5
    let q5_dot_value = u5;
    // q6' = u6
    let q6_dot_value = u6;
    [q1_dot_value, q2_dot_value, q3_dot_value, q4_dot_value, q5_dot_value, q6_dot_value]
}

/// Inverse dynamics: the generalized forces along (q1', q2', q3', q4', q5', q6') that must act beside the loads of the model for the accelerations to be (q1'', q2'', q3'', q4'', q5'', q6'').
///
/// 708 operations, 5 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    q_dot: &[S; 6],
    v_dot: &[S; 6],
) -> [S; 6] {
    let Parameters {
        g, a2, a3, d3, d4, m2, m3, m4, m5, m6, x2, y2, z2, x3, y3, z3, y4, z6, I1, Ixx2, Iyy2, Izz2,
        Ixx3, Iyy3, Izz3, Ixx4, Iyy4, Ixx5, Iyy5, Ixx6, Izz6, tau1, tau2, tau3, tau4, tau5, tau6,
        ..
    } = *p;
    let [_, q2, q3, q4, q5, q6] = *q;
    let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot, q6_dot] = *q_dot;
    let [q1_ddot, q2_ddot, q3_ddot, q4_ddot, q5_ddot, q6_ddot] = *v_dot;
    // Sines and cosines.
    let (s2_2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    let (s4_2, c4) = q4.sin_cos();
    let (s5_2, c5) = q5.sin_cos();
    let (s6, c6) = q6.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_L1_in_L2_1 = q1_dot * s2_2;
    let w_L1_in_L2_2 = q1_dot * c2;
    let w_L2_in_J3_1 = w_L1_in_L2_2.mul_add(s3_2, w_L1_in_L2_1 * c3);
    let w_L2_in_J3_2 = (-w_L1_in_L2_2).mul_add(c3, w_L1_in_L2_1 * s3_2);
    let w_J3_3 = q2_dot + q3_dot;
    let w_L3_in_J4_1 = (-w_J3_3).mul_add(s4_2, w_L2_in_J3_1 * c4);
    let w_L3_in_J4_2 = w_J3_3.mul_add(c4, w_L2_in_J3_1 * s4_2);
    let w_J4_3 = q4_dot - w_L2_in_J3_2;
    let w_L4_in_J5_1 = w_J4_3.mul_add(s5_2, w_L3_in_J4_1 * c5);
    let w_L4_in_J5_2 = (-w_J4_3).mul_add(c5, w_L3_in_J4_1 * s5_2);
    let w_J5_3 = q5_dot + w_L3_in_J4_2;
    let w_L5_in_L6_1 = (-w_J5_3).mul_add(s6, w_L4_in_J5_1 * c6);
    let w_L5_in_L6_2 = w_J5_3.mul_add(c6, w_L4_in_J5_1 * s6);
    let w_L6_3 = q6_dot - w_L4_in_J5_2;
    let v_C2_1 = (-y2).mul_add(q2_dot, z2 * w_L1_in_L2_2);
    let a2_plus_x2 = a2 + x2;
    let v_C2_2 = (-z2).mul_add(w_L1_in_L2_1, q2_dot * a2_plus_x2);
    let v_C2_3 = (-y2).mul_add(w_L1_in_L2_1, w_L1_in_L2_2 * a2_plus_x2);
    let H_upper_arm_1 = Ixx2 * w_L1_in_L2_1;
    let H_upper_arm_2 = Iyy2 * w_L1_in_L2_2;
    let a2_q2_dot = a2 * q2_dot;
    let v_L2_in_J3_1 = a2_q2_dot * s3_2;
    let v_L2_in_J3_2 = a2_q2_dot * c3;
    let v_L2_in_J3_3 = a2 * w_L1_in_L2_2;
    let v_C3_1 = d3.mul_add(w_L2_in_J3_2, -v_L2_in_J3_1);
    let v_C3_2 = (-d3).mul_add(w_L2_in_J3_1, a3 * w_J3_3) + v_L2_in_J3_2;
    let v_C3_3 = a3.mul_add(w_L2_in_J3_2, -v_L2_in_J3_3);
    let v_C3_1_2 = (-y3).mul_add(w_L2_in_J3_2, z3 * w_J3_3) + v_C3_1;
    let v_C3_2_2 = x3.mul_add(w_L2_in_J3_2, z3 * w_L2_in_J3_1) + v_C3_3;
    let v_C3_3_2 = x3.mul_add(w_J3_3, y3 * w_L2_in_J3_1) + v_C3_2;
    let H_forearm_1 = Ixx3 * w_L2_in_J3_1;
    let H_forearm_3 = Izz3 * w_L2_in_J3_2;
    let v_C4_1 = d4.mul_add(w_J3_3, v_C3_1);
    let v_C4_2 = d4.mul_add(w_L2_in_J3_1, v_C3_3);
    let v_L3_in_J4_1 = v_C4_2.mul_add(s4_2, v_C4_1 * c4);
    let v_L3_in_J4_2_of_place = (-v_C4_1).mul_add(s4_2, v_C4_2 * c4);
    let v_L3_in_J4_2 = -v_L3_in_J4_2_of_place;
    let v_C4_1_2 = y4.mul_add(w_L3_in_J4_2, v_L3_in_J4_1);
    let v_C4_3 = y4.mul_add(w_L3_in_J4_1, -v_L3_in_J4_2);
    let H_wrist1_1 = Ixx4 * w_L3_in_J4_1;
    let H_wrist1_2 = Iyy4 * w_J4_3;
    let H_wrist1_3 = Ixx4 * w_L3_in_J4_2;
    let H_wrist2_1 = Ixx5 * w_L4_in_J5_1;
    let H_wrist2_2 = Iyy5 * w_J5_3;
    let H_wrist2_3 = Ixx5 * w_L4_in_J5_2;
    let v_L4_in_J5_1 = (-v_C3_2).mul_add(s5_2, v_L3_in_J4_1 * c5);
    let v_L4_in_J5_2 = v_L3_in_J4_1.mul_add(s5_2, v_C3_2 * c5);
    let v_L5_in_L6_1 = (-v_L3_in_J4_2).mul_add(s6, v_L4_in_J5_1 * c6);
    let v_L5_in_L6_2 = v_L4_in_J5_1.mul_add(s6, v_L3_in_J4_2 * c6);
    let v_C6_1 = z6.mul_add(w_L5_in_L6_2, v_L5_in_L6_1);
    let v_C6_2 = z6.mul_add(w_L5_in_L6_1, -v_L5_in_L6_2);
    let H_flange_1 = Ixx6 * w_L5_in_L6_1;
    let H_flange_2 = Ixx6 * w_L5_in_L6_2;
    let H_flange_3 = Izz6 * w_L6_3;
    let p_v_C6_2 = m6 * v_C6_2;
    let p_v_C6_1 = m6 * v_C6_1;
    let p_v_L4_in_J5_2 = m6 * v_L4_in_J5_2;
    let p_v_L4_in_J5_1_of_place = (-p_v_C6_2).mul_add(s6, p_v_C6_1 * c6);
    let p_v_L4_in_J5_1 = -p_v_L4_in_J5_1_of_place;
    let p_v_C4_3 = m4 * v_C4_3;
    let p_v_C4_1 = m4 * v_C4_1_2;
    let p_v_L3_in_J4_2_of_place = p_v_C6_1.mul_add(s6, p_v_C6_2 * c6);
    let p_v_L3_in_J4_2 = p_v_C4_3 + p_v_L3_in_J4_2_of_place;
    let p_v_L3_in_J4_1_of_place = (-p_v_L4_in_J5_2).mul_add(s5_2, p_v_L4_in_J5_1 * c5);
    let p_v_L3_in_J4_1 = p_v_C4_1 - p_v_L3_in_J4_1_of_place;
    let p_v_C4_2_of_place = p_v_L3_in_J4_1.mul_add(s4_2, p_v_L3_in_J4_2 * c4);
    let p_v_C4_2 = m5.mul_add(v_C4_2, p_v_C4_2_of_place);
    let p_v_C4_1_2_of_place = (-p_v_L3_in_J4_2).mul_add(s4_2, p_v_L3_in_J4_1 * c4);
    let p_v_C4_1_2 = m5.mul_add(v_C4_1, p_v_C4_1_2_of_place);
    let p_v_C3_3 = m3 * v_C3_3_2;
    let p_v_C3_2 = m3 * v_C3_2_2;
    let p_v_C3_1 = m3 * v_C3_1_2;
    let p_v_C3_3_2 = p_v_C4_2 + p_v_C3_2;
    let m4_plus_m5 = m4 + m5;
    let p_v_C3_2_2_of_place = p_v_L4_in_J5_1.mul_add(s5_2, p_v_L4_in_J5_2 * c5);
    let p_v_C3_2_2 = v_C3_2.mul_add(m4_plus_m5, p_v_C3_3) + p_v_C3_2_2_of_place;
    let p_v_C3_1_2 = p_v_C4_1_2 + p_v_C3_1;
    let p_v_C2_3 = m2 * v_C2_3;
    let p_v_C2_2 = m2 * v_C2_2;
    let p_v_C2_1 = m2 * v_C2_1;
    let p_w_L5_in_L6_2 = z6.mul_add(p_v_C6_1, H_flange_2);
    let p_w_L5_in_L6_1 = z6.mul_add(p_v_C6_2, H_flange_1);
    let p_w_J5_3_of_place = (-p_w_L5_in_L6_1).mul_add(s6, p_w_L5_in_L6_2 * c6);
    let p_w_J5_3 = H_wrist2_2 + p_w_J5_3_of_place;
    let p_w_L4_in_J5_2 = H_wrist2_3 - H_flange_3;
    let p_w_L4_in_J5_1_of_place = p_w_L5_in_L6_1.mul_add(c6, p_w_L5_in_L6_2 * s6);
    let p_w_L4_in_J5_1 = H_wrist2_1 + p_w_L4_in_J5_1_of_place;
    let p_w_J4_3_of_place = (-p_w_L4_in_J5_1).mul_add(s5_2, p_w_L4_in_J5_2 * c5);
    let p_w_J4_3 = H_wrist1_2 - p_w_J4_3_of_place;
    let p_w_L3_in_J4_2 = y4.mul_add(p_v_C4_1, H_wrist1_3) + p_w_J5_3;
    let p_w_L3_in_J4_1_of_place = p_w_L4_in_J5_1.mul_add(c5, p_w_L4_in_J5_2 * s5_2);
    let p_w_L3_in_J4_1 = y4.mul_add(p_v_C4_3, H_wrist1_1) + p_w_L3_in_J4_1_of_place;
    let p_w_L2_in_J3_2 = x3.mul_add(p_v_C3_2, H_forearm_3) - y3 * p_v_C3_1
        + a3 * p_v_C3_3_2 + d3 * p_v_C3_1_2 - p_w_J4_3;
    let p_w_L2_in_J3_1_of_place = p_w_L3_in_J4_1.mul_add(c4, p_w_L3_in_J4_2 * s4_2);
    let p_w_L2_in_J3_1 = d4.mul_add(p_v_C4_2, H_forearm_1) + y3 * p_v_C3_3
        + z3 * p_v_C3_2 - d3 * p_v_C3_2_2 + p_w_L2_in_J3_1_of_place;
    let p_w_L1_in_L2_2_of_place = (-p_w_L2_in_J3_1).mul_add(s3_2, p_w_L2_in_J3_2 * c3);
    let p_w_L1_in_L2_2 = (-a2).mul_add(p_v_C3_3_2, H_upper_arm_2) + z2 * p_v_C2_1
        + p_v_C2_3 * a2_plus_x2 - p_w_L1_in_L2_2_of_place;
    let p_w_L1_in_L2_1_of_place = p_w_L2_in_J3_1.mul_add(c3, p_w_L2_in_J3_2 * s3_2);
    let p_w_L1_in_L2_1 = (-y2).mul_add(p_v_C2_3, H_upper_arm_1) - z2 * p_v_C2_2
        + p_w_L1_in_L2_1_of_place;
    let m6_plus_m4_plus_m5 = m6 + m4_plus_m5;
    let mp_L2_1_of_m3_m4_m5_m6 = m3 + m6_plus_m4_plus_m5;
    let mp_L2_1 = a2.mul_add(mp_L2_1_of_m3_m4_m5_m6, m2 * a2_plus_x2);
    let mp_L2_2 = m2 * y2;
    let mp_L2_3 = m2 * z2;
    let mp_J3_1 = a3 * mp_L2_1_of_m3_m4_m5_m6;
    let mp_J3_3 = d3 * mp_L2_1_of_m3_m4_m5_m6;
    let mp_L3_1 = m3 * x3;
    let mp_L3_2 = m3 * y3;
    let mp_L3_3 = d4.mul_add(m6_plus_m4_plus_m5, m3 * z3);
    let mp_L4_2 = m4 * y4;
    let mp_L6_3 = m6 * z6;
    let x_L2_in_J3_1 = mp_L2_2.mul_add(s3_2, mp_L2_1 * c3);
    let x_L2_in_J3_2_of_place = (-mp_L2_1).mul_add(s3_2, mp_L2_2 * c3);
    let x_L2_in_J3_2 = -x_L2_in_J3_2_of_place;
    let x_L6_1 = mp_J3_1 + x_L2_in_J3_1;
    let x_L6_3 = mp_L2_3 + mp_J3_3;
    let x_L6_1_2 = mp_L3_1 + x_L6_1;
    let x_L6_2 = mp_L3_2 - x_L6_3;
    let x_L6_3_2 = mp_L3_3 - x_L2_in_J3_2;
    let x_L3_in_J4_1 = x_L6_2.mul_add(s4_2, x_L6_1_2 * c4);
    let x_L3_in_J4_2_of_place = (-x_L6_1_2).mul_add(s4_2, x_L6_2 * c4);
    let x_L3_in_J4_2 = -x_L3_in_J4_2_of_place;
    let x_L6_2_2 = mp_L4_2 + x_L6_3_2;
    let x_L4_in_J5_1 = x_L6_2_2.mul_add(s5_2, x_L3_in_J4_1 * c5);
    let x_L4_in_J5_2_of_place = (-x_L3_in_J4_1).mul_add(s5_2, x_L6_2_2 * c5);
    let x_L4_in_J5_2 = -x_L4_in_J5_2_of_place;
    let x_L5_in_L6_1 = (-x_L3_in_J4_2).mul_add(s6, x_L4_in_J5_1 * c6);
    let x_L5_in_L6_2 = x_L4_in_J5_1.mul_add(s6, x_L3_in_J4_2 * c6);
    let x_L6_3_3 = mp_L6_3 - x_L4_in_J5_2;
    let F_x_L4_in_J5_1 = x_L5_in_L6_2.mul_add(s6, x_L5_in_L6_1 * c6);
    let F_x_L3_in_J4_2 = (-x_L5_in_L6_1).mul_add(s6, x_L5_in_L6_2 * c6);
    let F_x_L3_in_J4_1 = (-F_x_L4_in_J5_1).mul_add(c5, x_L6_3_3 * s5_2);
    let F_x_L2_in_J3_2 = F_x_L4_in_J5_1.mul_add(s5_2, x_L6_3_3 * c5);
    let F_x_L2_in_J3_1 = (-F_x_L3_in_J4_1).mul_add(c4, F_x_L3_in_J4_2 * s4_2);
    let F_x_L1_in_L2_2 = F_x_L2_in_J3_1.mul_add(s3_2, F_x_L2_in_J3_2 * c3);
    let F_x_L1_in_L2_1 = (-F_x_L2_in_J3_1).mul_add(c3, F_x_L2_in_J3_2 * s3_2);
    let x_L1_in_L2_1 = g * s2_2;
    let x_L1_in_L2_2 = g * c2;
    let x_L2_in_J3_1_2 = x_L1_in_L2_2.mul_add(s3_2, x_L1_in_L2_1 * c3);
    let x_L2_in_J3_2_2_of_place = (-x_L1_in_L2_1).mul_add(s3_2, x_L1_in_L2_2 * c3);
    let x_L2_in_J3_2_2 = -x_L2_in_J3_2_2_of_place;
    let x_L3_in_J4_1_2 = x_L2_in_J3_1_2 * c4;
    let x_L3_in_J4_2_2 = x_L2_in_J3_1_2 * s4_2;
    let x_L4_in_J5_1_2 = (-x_L2_in_J3_2_2).mul_add(s5_2, x_L3_in_J4_1_2 * c5);
    let x_L4_in_J5_2_2 = x_L3_in_J4_1_2.mul_add(s5_2, x_L2_in_J3_2_2 * c5);
    let x_L5_in_L6_1_2 = (-x_L3_in_J4_2_2).mul_add(s6, x_L4_in_J5_1_2 * c6);
    let x_L5_in_L6_2_2 = x_L4_in_J5_1_2.mul_add(s6, x_L3_in_J4_2_2 * c6);
    let F_x_L4_in_J5_1_2 = x_L5_in_L6_2_2.mul_add(s6, x_L5_in_L6_1_2 * c6);
    let F_x_L6_2 = (-F_x_L4_in_J5_1_2).mul_add(s5_2, x_L4_in_J5_2_2 * c5);
    let F_x_L3_in_J4_2_2 = (-x_L5_in_L6_1_2).mul_add(s6, x_L5_in_L6_2_2 * c6);
    let F_x_L3_in_J4_1_2 = F_x_L4_in_J5_1_2.mul_add(c5, x_L4_in_J5_2_2 * s5_2);
    let F_x_L6_1 = F_x_L3_in_J4_1_2.mul_add(c4, F_x_L3_in_J4_2_2 * s4_2);
    let w_L1_in_L2_1_3 = q2_dot.mul_add(w_L1_in_L2_2, q1_ddot * s2_2);
    let w_L1_in_L2_2_3 = (-q1_ddot).mul_add(c2, q2_dot * w_L1_in_L2_1);
    let w_L2_in_J3_1_3 = (-w_L1_in_L2_1_3).mul_add(c3, q3_dot * w_L2_in_J3_2)
        + w_L1_in_L2_2_3 * s3_2;
    let w_L2_in_J3_2_3 = w_L1_in_L2_1_3.mul_add(s3_2, q3_dot * w_L2_in_J3_1) + w_L1_in_L2_2_3 * c3;
    let w_J3_3_2 = q2_ddot + q3_ddot;
    let w_L3_in_J4_1_3 = w_L2_in_J3_1_3.mul_add(c4, q4_dot * w_L3_in_J4_2) + w_J3_3_2 * s4_2;
    let w_L3_in_J4_2_3 = (-w_L2_in_J3_1_3).mul_add(s4_2, q4_dot * w_L3_in_J4_1) + w_J3_3_2 * c4;
    let w_J4_3_2 = q4_ddot - w_L2_in_J3_2_3;
    let w_L4_in_J5_1_3 = w_L3_in_J4_1_3.mul_add(c5, q5_dot * w_L4_in_J5_2) - w_J4_3_2 * s5_2;
    let w_L4_in_J5_2_3 = (-w_L3_in_J4_1_3).mul_add(s5_2, q5_dot * w_L4_in_J5_1) - w_J4_3_2 * c5;
    let w_J5_3_2 = q5_ddot + w_L3_in_J4_2_3;
    let w_L5_in_L6_1_3 = w_L4_in_J5_1_3.mul_add(c6, q6_dot * w_L5_in_L6_2) + w_J5_3_2 * s6;
    let w_L5_in_L6_2_3 = (-w_L4_in_J5_1_3).mul_add(s6, q6_dot * w_L5_in_L6_1) + w_J5_3_2 * c6;
    let w_L6_3_2 = q6_ddot - w_L4_in_J5_2_3;
    let H_column_3 = I1 * q1_ddot;
    let v_C2_1_3 = z2.mul_add(w_L1_in_L2_2_3, y2 * q2_ddot);
    let v_C2_2_3 = (-z2).mul_add(w_L1_in_L2_1_3, q2_ddot * a2_plus_x2);
    let v_C2_3_3 = w_L1_in_L2_2_3.mul_add(a2_plus_x2, y2 * w_L1_in_L2_1_3);
    let H_upper_arm_1_3 = Ixx2 * w_L1_in_L2_1_3;
    let H_upper_arm_2_3 = Iyy2 * w_L1_in_L2_2_3;
    let a2_s3_2 = a2 * s3_2;
    let v_L2_in_J3_1_3 = q2_ddot.mul_add(a2_s3_2, q3_dot * v_L2_in_J3_2);
    let a2_c3 = a2 * c3;
    let v_L2_in_J3_2_3 = (-q2_ddot).mul_add(a2_c3, q3_dot * v_L2_in_J3_1);
    let v_L2_in_J3_3_3 = a2 * w_L1_in_L2_2_3;
    let v_C3_1_5 = d3.mul_add(w_L2_in_J3_2_3, -v_L2_in_J3_1_3);
    let v_C3_2_5 = a3.mul_add(w_J3_3_2, d3 * w_L2_in_J3_1_3) - v_L2_in_J3_2_3;
    let v_C3_3_5 = a3.mul_add(w_L2_in_J3_2_3, v_L2_in_J3_3_3);
    let v_C3_1_6 = (-y3).mul_add(w_L2_in_J3_2_3, z3 * w_J3_3_2) + v_C3_1_5;
    let v_C3_2_6 = (-z3).mul_add(w_L2_in_J3_1_3, x3 * w_L2_in_J3_2_3) + v_C3_3_5;
    let v_C3_3_6 = (-x3).mul_add(w_J3_3_2, y3 * w_L2_in_J3_1_3) - v_C3_2_5;
    let H_forearm_1_3 = Ixx3 * w_L2_in_J3_1_3;
    let H_forearm_3_3 = Izz3 * w_L2_in_J3_2_3;
    let v_C4_1_4 = d4.mul_add(w_J3_3_2, v_C3_1_5);
    let v_C4_2_3 = d4.mul_add(w_L2_in_J3_1_3, -v_C3_3_5);
    let v_L3_in_J4_1_3 = (-v_C4_1_4).mul_add(c4, v_C4_2_3 * s4_2) - q4_dot * v_L3_in_J4_2_of_place;
    let v_L3_in_J4_2_3 = v_C4_1_4.mul_add(s4_2, q4_dot * v_L3_in_J4_1) + v_C4_2_3 * c4;
    let v_C4_1_5 = y4.mul_add(w_L3_in_J4_2_3, -v_L3_in_J4_1_3);
    let v_C4_3_3 = y4.mul_add(w_L3_in_J4_1_3, v_L3_in_J4_2_3);
    let H_wrist1_1_3 = Ixx4 * w_L3_in_J4_1_3;
    let H_wrist1_2_3 = Iyy4 * w_J4_3_2;
    let H_wrist1_3_3 = Ixx4 * w_L3_in_J4_2_3;
    let H_wrist2_1_3 = Ixx5 * w_L4_in_J5_1_3;
    let H_wrist2_2_3 = Iyy5 * w_J5_3_2;
    let H_wrist2_3_3 = Ixx5 * w_L4_in_J5_2_3;
    let v_L4_in_J5_1_3 = v_C3_2_5.mul_add(s5_2, q5_dot * v_L4_in_J5_2) + v_L3_in_J4_1_3 * c5;
    let v_L4_in_J5_2_3 = v_C3_2_5.mul_add(c5, q5_dot * v_L4_in_J5_1) - v_L3_in_J4_1_3 * s5_2;
    let v_L5_in_L6_1_3 = v_L3_in_J4_2_3.mul_add(s6, q6_dot * v_L5_in_L6_2) + v_L4_in_J5_1_3 * c6;
    let v_L5_in_L6_2_3 = v_L3_in_J4_2_3.mul_add(c6, q6_dot * v_L5_in_L6_1) - v_L4_in_J5_1_3 * s6;
    let v_C6_1_3 = z6.mul_add(w_L5_in_L6_2_3, -v_L5_in_L6_1_3);
    let v_C6_2_3 = z6.mul_add(w_L5_in_L6_1_3, v_L5_in_L6_2_3);
    let H_flange_1_3 = Ixx6 * w_L5_in_L6_1_3;
    let H_flange_2_3 = Ixx6 * w_L5_in_L6_2_3;
    let H_flange_3_3 = Izz6 * w_L6_3_2;
    let p_v_C6_2_3 = m6 * v_C6_2_3;
    let p_v_C6_1_3 = m6 * v_C6_1_3;
    let p_v_L4_in_J5_2_3 = m6 * v_L4_in_J5_2_3;
    let p_v_L4_in_J5_1_3 = (-p_v_C6_2_3).mul_add(s6, q6_dot * p_v_L3_in_J4_2_of_place)
        - p_v_C6_1_3 * c6;
    let p_v_C4_3_3 = m4 * v_C4_3_3;
    let p_v_C4_1_5 = m4 * v_C4_1_5;
    let p_v_L3_in_J4_2_3 = (-p_v_C6_1_3).mul_add(s6, p_v_C6_2_3 * c6) + p_v_C4_3_3
        - q6_dot * p_v_L4_in_J5_1_of_place;
    let p_v_L3_in_J4_1_3 = (-p_v_L4_in_J5_1_3).mul_add(c5, p_v_L4_in_J5_2_3 * s5_2)
        + p_v_C4_1_5 + q5_dot * p_v_C3_2_2_of_place;
    let p_v_C4_2_3 = p_v_L3_in_J4_2_3.mul_add(c4, m5 * v_C4_2_3)
        - p_v_L3_in_J4_1_3 * s4_2 - q4_dot * p_v_C4_1_2_of_place;
    let p_v_C4_1_6 = (-m5).mul_add(v_C4_1_4, q4_dot * p_v_C4_2_of_place)
        - p_v_L3_in_J4_2_3 * s4_2 - p_v_L3_in_J4_1_3 * c4;
    let p_v_C3_3_5 = m3 * v_C3_3_6;
    let p_v_C3_2_5 = m3 * v_C3_2_6;
    let p_v_C3_1_5 = m3 * v_C3_1_6;
    let p_v_C3_3_6 = p_v_C4_2_3 - p_v_C3_2_5;
    let p_v_C3_2_6 = (-p_v_L4_in_J5_2_3).mul_add(c5, p_v_C3_3_5)
        - p_v_L4_in_J5_1_3 * s5_2 - q5_dot * p_v_L3_in_J4_1_of_place - v_C3_2_5 * m4_plus_m5;
    let p_v_C3_1_6 = p_v_C4_1_6 - p_v_C3_1_5;
    let p_v_C2_3_3 = m2 * v_C2_3_3;
    let p_v_C2_2_3 = m2 * v_C2_2_3;
    let p_v_C2_1_3 = m2 * v_C2_1_3;
    let p_w_L5_in_L6_2_3 = z6.mul_add(p_v_C6_1_3, H_flange_2_3);
    let p_w_L5_in_L6_1_3 = z6.mul_add(p_v_C6_2_3, H_flange_1_3);
    let p_w_J5_3_3 = q6_dot.mul_add(p_w_L4_in_J5_1_of_place, -H_wrist2_2_3)
        - p_w_L5_in_L6_2_3 * c6 - p_w_L5_in_L6_1_3 * s6;
    let p_w_L4_in_J5_2_3 = H_wrist2_3_3 - H_flange_3_3;
    let p_w_L4_in_J5_1_3 = p_w_L5_in_L6_2_3.mul_add(s6, -H_wrist2_1_3)
        - p_w_L5_in_L6_1_3 * c6 + q6_dot * p_w_J5_3_of_place;
    let p_w_J4_3_3 = (-p_w_L4_in_J5_2_3).mul_add(c5, H_wrist1_2_3)
        + p_w_L4_in_J5_1_3 * s5_2 + q5_dot * p_w_L3_in_J4_1_of_place;
    let p_w_L3_in_J4_2_3 = y4.mul_add(p_v_C4_1_5, H_wrist1_3_3) - p_w_J5_3_3;
    let p_w_L3_in_J4_1_3 = p_w_L4_in_J5_2_3.mul_add(s5_2, -H_wrist1_1_3)
        - y4 * p_v_C4_3_3 + p_w_L4_in_J5_1_3 * c5 + q5_dot * p_w_J4_3_of_place;
    let p_w_L2_in_J3_2_3 = x3.mul_add(p_v_C3_2_5, H_forearm_3_3) - y3 * p_v_C3_1_5
        - a3 * p_v_C3_3_6 - d3 * p_v_C3_1_6 - p_w_J4_3_3;
    let p_w_L2_in_J3_1_3 = q4_dot * (-p_w_L3_in_J4_1).mul_add(s4_2, p_w_L3_in_J4_2 * c4)
        - H_forearm_1_3 - d4 * p_v_C4_2_3 - y3 * p_v_C3_3_5 + z3 * p_v_C3_2_5
        + d3 * p_v_C3_2_6 + p_w_L3_in_J4_2_3 * s4_2 + p_w_L3_in_J4_1_3 * c4;
    let p_w_L1_in_L2_2_3 = a2.mul_add(p_v_C3_3_6, -H_upper_arm_2_3) - z2 * p_v_C2_1_3
        - p_w_L2_in_J3_2_3 * c3 + p_w_L2_in_J3_1_3 * s3_2 - p_v_C2_3_3 * a2_plus_x2
        + q3_dot * p_w_L1_in_L2_1_of_place;
    let p_w_L1_in_L2_1_3 = y2.mul_add(p_v_C2_3_3, H_upper_arm_1_3) - z2 * p_v_C2_2_3
        + p_w_L2_in_J3_2_3 * s3_2 + p_w_L2_in_J3_1_3 * c3 + q3_dot * p_w_L1_in_L2_2_of_place;
    let H_upper_arm_3 = Izz2 * q2_ddot;
    let H_forearm_2 = Iyy3 * w_J3_3_2;
    let p_w_J3_3_2 = x3.mul_add(p_v_C3_3_5, d4 * p_v_C4_1_6) - z3 * p_v_C3_1_5
        + a3 * p_v_C3_2_6 - p_w_L3_in_J4_2_3 * c4 + p_w_L3_in_J4_1_3 * s4_2 - H_forearm_2
        + q4_dot * p_w_L2_in_J3_1_of_place;
    let tau1_of_place = (-p_w_L1_in_L2_1).mul_add(c2, p_w_L1_in_L2_2 * s2_2);
    let tau2_of_place = p_v_C3_1_2.mul_add(c3, p_v_C3_2_2 * s3_2);
    // Values.
    let tau1_2 = p_w_L1_in_L2_2_3.mul_add(c2, H_column_3 - tau1)
        + p_w_L1_in_L2_1_3 * s2_2 - q2_dot * tau1_of_place;
    let tau2_2 = y2.mul_add(p_v_C2_1_3, -tau2) - F_x_L1_in_L2_2 * x_L1_in_L2_1
        - F_x_L1_in_L2_1 * x_L1_in_L2_2 + H_upper_arm_3 - p_w_J3_3_2
        + p_v_C2_2_3 * a2_plus_x2 + p_v_C3_1_6 * a2_s3_2 - p_v_C3_2_6 * a2_c3
        + q1_dot * tau1_of_place - a2 * q3_dot * tau2_of_place;
    let tau3_2 = w_L2_in_J3_2.mul_add(p_w_L2_in_J3_1, -tau3)
        - w_L2_in_J3_1 * p_w_L2_in_J3_2 - F_x_L2_in_J3_2 * x_L2_in_J3_1_2
        + x_L2_in_J3_1 * F_x_L6_2 - p_w_J3_3_2 + F_x_L6_1 * x_L2_in_J3_2_of_place
        + F_x_L2_in_J3_1 * x_L2_in_J3_2_2_of_place + a2_q2_dot * tau2_of_place;
    let tau4_2 = v_L3_in_J4_1.mul_add(p_v_L3_in_J4_2, -tau4)
        - w_L3_in_J4_1 * p_w_L3_in_J4_2 + w_L3_in_J4_2 * p_w_L3_in_J4_1
        + F_x_L3_in_J4_2 * x_L3_in_J4_1_2 + F_x_L3_in_J4_1 * x_L3_in_J4_2_2
        + x_L3_in_J4_1 * F_x_L3_in_J4_2_2 + p_w_J4_3_3 - p_v_L3_in_J4_1 * v_L3_in_J4_2_of_place
        + F_x_L3_in_J4_1_2 * x_L3_in_J4_2_of_place;
    let tau5_2 = w_L4_in_J5_2.mul_add(p_w_L4_in_J5_1, -tau5)
        - v_L4_in_J5_1 * p_v_L4_in_J5_2 - v_L4_in_J5_2 * p_v_L4_in_J5_1
        - w_L4_in_J5_1 * p_w_L4_in_J5_2 - x_L6_3_3 * x_L4_in_J5_1_2
        + x_L4_in_J5_1 * x_L4_in_J5_2_2 - F_x_L4_in_J5_1 * x_L4_in_J5_2_2 - p_w_J5_3_3
        + F_x_L4_in_J5_1_2 * x_L4_in_J5_2_of_place;
    let tau6_2 = v_L5_in_L6_1.mul_add(p_v_C6_2, -tau6) + v_L5_in_L6_2 * p_v_C6_1
        - w_L5_in_L6_1 * p_w_L5_in_L6_2 + w_L5_in_L6_2 * p_w_L5_in_L6_1 + H_flange_3_3;
    [tau1_2, tau2_2, tau3_2, tau4_2, tau5_2, tau6_2]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    q_dot: &[S; 6],
    direction: &[S; 12],
) -> [S; 12] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: q_dot[i],
        slope: direction[6 + i],
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
            parameters: 38,
            coordinates: 6,
            variables: 6,
            speeds: 6,
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
