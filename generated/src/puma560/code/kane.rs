//! PUMA 560: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/puma560/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1, u2, u3, u4, u5, u6.
///
/// 256 operations, 4 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    _u: &[S; 6],
) -> [[S; 6]; 6] {
    let Parameters {
        a2, a3, d3, d4, m2, m3, m4, m5, m6, x2, y2, z2, x3, y3, z3, y4, z6, I1, Ixx2, Iyy2, Izz2,
        Ixx3, Iyy3, Izz3, Ixx4, Iyy4, Ixx5, Iyy5, Ixx6, Izz6,
        ..
    } = *p;
    let [_, q2, q3, q4, q5, _] = *q;
    // Sines and cosines.
    let (s5_2, c5) = q5.sin_cos();
    let (s4_2, c4) = q4.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    let (s2_2, c2) = q2.sin_cos();
    // Step by step, each after the terms that it needs.
    let mr_L6_3 = m6 * z6;
    let rw_L6_3 = z6 * mr_L6_3;
    let J_L6_11 = Ixx6 + rw_L6_3;
    let m_L5 = m5 + m6;
    let J_L5_11 = Ixx5 + J_L6_11;
    let J_L5_22 = Iyy5 + J_L6_11;
    let J_L5_33 = Ixx5 + Izz6;
    let J_L5_in_J5_23 = J_L5_22 - J_L5_33;
    let J_L5_in_J5_22 = J_L5_22 - J_L5_in_J5_23;
    let J_L5_in_J5_33 = J_L5_33 + J_L5_in_J5_23;
    let s_J5_in_L4_1 = mr_L6_3 * s5_2;
    let s_J5_in_L4_2 = mr_L6_3 * c5;
    let J_J5_in_L4_12 = J_L5_11 - J_L5_in_J5_22;
    let J_J5_in_L4 = J_J5_in_L4_12 * s5_2;
    let J_J5_in_L4_2 = J_J5_in_L4 * s5_2;
    let J_J5_in_L4_11 = J_L5_11 - J_J5_in_L4_2;
    let J_J5_in_L4_12_2 = J_J5_in_L4 * c5;
    let J_J5_in_L4_22 = J_L5_in_J5_22 + J_J5_in_L4_2;
    let mr_L4_2 = m4 * y4;
    let rw_L4_2 = y4 * mr_L4_2;
    let m_L4 = m4 + m_L5;
    let s_L4_2 = s_J5_in_L4_2 + mr_L4_2;
    let ixx4_plus_rw_l4_2 = Ixx4 + rw_L4_2;
    let J_L4_11 = J_J5_in_L4_11 + ixx4_plus_rw_l4_2;
    let J_L4_22 = Iyy4 + J_J5_in_L4_22;
    let J_L4_33 = J_L5_in_J5_33 + ixx4_plus_rw_l4_2;
    let J_L4_in_J4_23 = J_L4_22 - J_L4_33;
    let J_L4_in_J4_22 = J_L4_22 - J_L4_in_J4_23;
    let J_L4_in_J4_33 = J_L4_33 + J_L4_in_J4_23;
    let s_J4_in_L3_1 = s_J5_in_L4_1 * c4;
    let s_J4_in_L3_2 = s_J5_in_L4_1 * s4_2;
    let J_J4_in_L3_1 = J_J5_in_L4_12_2 * c4;
    let J_J4_in_L3_12 = J_L4_11 - J_L4_in_J4_22;
    let J_J4_in_L3 = J_J4_in_L3_12 * s4_2;
    let J_J4_in_L3_2 = J_J4_in_L3 * s4_2;
    let J_J4_in_L3_11 = J_L4_11 - J_J4_in_L3_2;
    let J_J4_in_L3_22 = J_L4_in_J4_22 + J_J4_in_L3_2;
    let mr_L3_3 = d4 * m_L4;
    let s_L3_3 = s_L4_2 + mr_L3_3;
    let w_L3_3 = s_L4_2 + s_L3_3;
    let rw_L3_3 = d4 * w_L3_3;
    let mr_L3_1 = m3 * x3;
    let mr_L3_2 = m3 * y3;
    let mr_L3_3_2 = m3 * z3;
    let rw_L3_1 = x3 * mr_L3_1;
    let rw_L3_2 = y3 * mr_L3_2;
    let rw_L3_3_2 = z3 * mr_L3_3_2;
    let m_L3 = m3 + m_L4;
    let s_L3_1 = s_J4_in_L3_1 - mr_L3_1;
    let s_L3_2 = s_J4_in_L3_2 - mr_L3_2;
    let s_L3_3_2 = s_L3_3 + mr_L3_3_2;
    let rw_l3_3_plus_rw_l3_3_2 = rw_L3_3 + rw_L3_3_2;
    let J_L3_11 = Ixx3 + J_J4_in_L3_11 + rw_L3_2 + rw_l3_3_plus_rw_l3_3_2;
    let h_J4_L3_1 = d4.mul_add(s_J4_in_L3_1, J_J4_in_L3_1);
    let J_L3_13 = (-z3).mul_add(mr_L3_1, S::int(2) * h_J4_L3_1) - x3 * mr_L3_3_2;
    let J_L3_22 = Iyy3 + J_J4_in_L3_22 + rw_L3_1 + rw_l3_3_plus_rw_l3_3_2;
    let J_L3_33 = Izz3 + J_L4_in_J4_33 + rw_L3_1 + rw_L3_2;
    let J_L3_in_J3_23 = J_L3_22 - J_L3_33;
    let J_L3_in_J3_22 = J_L3_22 - J_L3_in_J3_23;
    let J_L3_in_J3_33 = J_L3_33 + J_L3_in_J3_23;
    let mr_J3_1 = a3 * m_L3;
    let mr_J3_3 = d3 * m_L3;
    let s_J3_1 = s_L3_1 - mr_J3_1;
    let s_J3_3 = s_L3_2 + mr_J3_3;
    let w_J3_1 = s_L3_1 + s_J3_1;
    let w_J3_3_2 = s_L3_2 + s_J3_3;
    let rw_J3_1 = a3 * w_J3_1;
    let rw_J3_3 = d3 * w_J3_3_2;
    let J_J3_11 = J_L3_11 + rw_J3_3;
    let s_l3_3_2_doubled = S::int(2) * s_L3_3_2;
    let J_J3_12 = (-a3).mul_add(s_l3_3_2_doubled, J_L3_13);
    let J_J3_22 = J_L3_in_J3_22 - rw_J3_1 + rw_J3_3;
    let J_J3_33 = J_L3_in_J3_33 - rw_J3_1;
    let s_J3_in_L2_1 = s_J3_1.mul_add(c3, s_L3_3_2 * s3_2);
    let s_J3_in_L2_2 = (-s_L3_3_2).mul_add(c3, s_J3_1 * s3_2);
    let J_J3_in_L2_12 = J_J3_11 - J_J3_22;
    let J_J3_in_L2 = J_J3_in_L2_12.mul_add(s3_2, J_J3_12 * c3);
    let J_J3_in_L2_2 = J_J3_in_L2 * s3_2;
    let J_J3_in_L2_11 = J_J3_11 - J_J3_in_L2_2;
    let J_J3_in_L2_12_2 = (-(J_J3_in_L2 * c3)).mul_add(S::int(2), J_J3_12);
    let J_J3_in_L2_22 = J_J3_22 + J_J3_in_L2_2;
    let mr_L2_1 = m2 * x2;
    let mr_L2_2 = m2 * y2;
    let mr_L2_3 = m2 * z2;
    let rw_L2_1 = x2 * mr_L2_1;
    let rw_L2_2 = y2 * mr_L2_2;
    let rw_L2_3 = z2 * mr_L2_3;
    let m_L2 = m2 + m_L3;
    let s_L2_1 = s_J3_in_L2_1 - mr_L2_1;
    let s_L2_2 = s_J3_in_L2_2 - mr_L2_2;
    let J_L2_11 = Ixx2 + J_J3_in_L2_11 + rw_L2_2 + rw_L2_3;
    let J_L2_12 = y2.mul_add(mr_L2_1, J_J3_in_L2_12_2) + x2 * mr_L2_2;
    let J_L2_22 = Iyy2 + J_J3_in_L2_22 + rw_L2_1 + rw_L2_3;
    let J_L2_33 = Izz2 + J_J3_33 + rw_L2_1 + rw_L2_2;
    let mr_L2_1_2 = a2 * m_L2;
    let s_L2_1_2 = s_L2_1 - mr_L2_1_2;
    let w_L2_1 = s_L2_1 + s_L2_1_2;
    let rw_L2_1_2 = a2 * w_L2_1;
    let a2_doubled = S::int(2) * a2;
    let J_L2_12_2 = (-s_L2_2).mul_add(a2_doubled, J_L2_12);
    let J_L2_22_2 = J_L2_22 - rw_L2_1_2;
    let J_L2_33_2 = J_L2_33 - rw_L2_1_2;
    let J_L2_in_L1_12 = J_L2_11 - J_L2_22_2;
    let J_L2_in_L1 = (-J_L2_12_2).mul_add(c2, J_L2_in_L1_12 * s2_2);
    let J_L2_in_L1_2 = J_L2_in_L1 * s2_2;
    let J_L2_in_L1_22 = J_L2_22_2 + J_L2_in_L1_2;
    let J_L1_in_J1_23 = J_L2_33_2 - J_L2_in_L1_22;
    let J_L1_in_J1_33 = J_L2_33_2 - J_L1_in_J1_23;
    let J_J1_33 = I1 + J_L1_in_J1_33;
    let J_J4_in_L3_2_ = J_J5_in_L4_12_2 * s4_2;
    let J_J4_in_L3_12_2 = J_J4_in_L3 * c4;
    let J_L3_12 = (-y3).mul_add(mr_L3_1, S::int(2) * J_J4_in_L3_12_2) - x3 * mr_L3_2;
    let h_J4_L3_2 = d4.mul_add(s_J4_in_L3_2, J_J4_in_L3_2_);
    let J_L3_23 = (-z3).mul_add(mr_L3_2, S::int(2) * h_J4_L3_2) - y3 * mr_L3_3_2;
    let J_J3_13 = (-d3).mul_add(w_J3_1, a3 * w_J3_3_2) + J_L3_12;
    let J_J3_23 = d3.mul_add(s_l3_3_2_doubled, J_L3_23);
    let J_J3_in_L2_1 = (-J_J3_23).mul_add(s3_2, J_J3_13 * c3);
    let J_J3_in_L2_2_ = J_J3_23.mul_add(c3, J_J3_13 * s3_2);
    let s_L2_3 = s_J3_3 + mr_L2_3;
    let J_L2_13 = x2.mul_add(mr_L2_3, z2 * mr_L2_1) + J_J3_in_L2_1;
    let J_L2_23 = y2.mul_add(mr_L2_3, z2 * mr_L2_2) + J_J3_in_L2_2_;
    let J_L2_13_2 = s_L2_3.mul_add(a2_doubled, J_L2_13);
    let J_L2_in_L1_2_ = J_L2_13_2.mul_add(s2_2, J_L2_23 * c2);
    let h_J3_in_L2_2 = J_J3_in_L2_2_.mul_add(c2, J_J3_in_L2_1 * s2_2);
    let h_J4_J3_2 = (-a3).mul_add(s_J4_in_L3_1, J_L4_in_J4_33) + d3 * s_J4_in_L3_2;
    let h_J4_in_J3_1 = (-h_J4_J3_2).mul_add(s3_2, h_J4_L3_1 * c3);
    let h_J4_in_J3_2 = h_J4_J3_2.mul_add(c3, h_J4_L3_1 * s3_2);
    let h_J4_L2_2 = (-a2).mul_add(s_J4_in_L3_1, h_J4_in_J3_2);
    let h_J4_in_L2_2 = h_J4_L2_2.mul_add(c2, h_J4_in_J3_1 * s2_2);
    let p_J5_in_J4_1 = s_J5_in_L4_2 * c4;
    let p_J5_in_J4_2 = s_J5_in_L4_2 * s4_2;
    let h_J5_in_J4_1 = J_L5_in_J5_33 * s4_2;
    let h_J5_L3_1 = d4.mul_add(p_J5_in_J4_2, h_J5_in_J4_1);
    let h_J5_J3_1 = d3.mul_add(s_J5_in_L4_1, h_J5_L3_1);
    let h_J5_J3_2 = a3.mul_add(p_J5_in_J4_2, d3 * p_J5_in_J4_1);
    let h_J5_in_J3_1 = h_J5_J3_2.mul_add(s3_2, h_J5_J3_1 * c3);
    let h_J5_in_J3_2 = (-h_J5_J3_2).mul_add(c3, h_J5_J3_1 * s3_2);
    let h_J5_L2_2 = (-a2).mul_add(p_J5_in_J4_2, h_J5_in_J3_2);
    let h_J5_in_L2_2 = h_J5_L2_2.mul_add(c2, h_J5_in_J3_1 * s2_2);
    let h_L6_in_J5_1 = Izz6 * s5_2;
    let h_L6_in_J5_2 = Izz6 * c5;
    let h_L6_in_J4_1 = h_L6_in_J5_1 * c4;
    let h_L6_in_J3_1 = h_L6_in_J4_1.mul_add(c3, h_L6_in_J5_2 * s3_2);
    let h_L6_in_J3_2 = (-h_L6_in_J5_2).mul_add(c3, h_L6_in_J4_1 * s3_2);
    let h_L6_in_L2_2 = h_L6_in_J3_2.mul_add(c2, h_L6_in_J3_1 * s2_2);
    let h_J3_L2_3 = (-a2).mul_add(s_J3_in_L2_1, J_J3_33);
    let p_J4_in_J3_2 = s_J4_in_L3_2 * s3_2;
    let h_J4_L2_3 = (-a2).mul_add(p_J4_in_J3_2, h_J4_L3_2);
    let h_J5_in_J4_2 = J_L5_in_J5_33 * c4;
    let h_J5_L3_2 = d4.mul_add(p_J5_in_J4_1, h_J5_in_J4_2);
    let h_J5_J3_3 = (-a3).mul_add(s_J5_in_L4_1, h_J5_L3_2);
    let p_J5_in_J3_2 = p_J5_in_J4_1.mul_add(s3_2, s_J5_in_L4_1 * c3);
    let h_J5_L2_3 = (-a2).mul_add(p_J5_in_J3_2, h_J5_J3_3);
    let h_L6_in_J4_2 = h_L6_in_J5_1 * s4_2;
    // Entries that are not zero; upper triangle.
    let m12 = -S::ratio(1, 2) * J_L2_in_L1_2_;
    let m13 = -S::ratio(1, 2) * h_J3_in_L2_2;
    let m16 = -h_L6_in_L2_2;
    let m24 = -h_J4_L2_3;
    let m34 = -h_J4_L3_2;
    let m66 = Izz6;
    let zero = S::int(0);
    [
        [J_J1_33, m12, m13, h_J4_in_L2_2, h_J5_in_L2_2, m16],
        [m12, J_L2_33_2, h_J3_L2_3, m24, h_J5_L2_3, h_L6_in_J4_2],
        [m13, h_J3_L2_3, J_J3_33, m34, h_J5_J3_3, h_L6_in_J4_2],
        [h_J4_in_L2_2, m24, m34, J_L4_in_J4_33, zero, h_L6_in_J5_2],
        [h_J5_in_L2_2, h_J5_L2_3, h_J5_J3_3, zero, J_L5_in_J5_33, zero],
        [m16, h_L6_in_J4_2, h_L6_in_J4_2, h_L6_in_J5_2, zero, m66],
    ]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5', u6').
///
/// 422 operations, 5 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 6], u: &[S; 6]) -> [S; 6] {
    let Parameters {
        g, a2, a3, d3, d4, m2, m3, m4, m5, m6, x2, y2, z2, x3, y3, z3, y4, z6, Ixx2, Iyy2, Izz2,
        Ixx3, Iyy3, Izz3, Ixx4, Iyy4, Ixx5, Iyy5, Ixx6, Izz6, tau1, tau2, tau3, tau4, tau5, tau6,
        ..
    } = *p;
    let [_, q2, q3, q4, q5, q6] = *q;
    let [u1, u2, u3, u4, u5, u6] = *u;
    // Sines and cosines.
    let (s2_2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    let (s4_2, c4) = q4.sin_cos();
    let (s5_2, c5) = q5.sin_cos();
    let (s6, c6) = q6.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_L1_in_L2_1 = u1 * s2_2;
    let w_L1_in_L2_2 = u1 * c2;
    let w_L2_in_J3_1 = w_L1_in_L2_2.mul_add(s3_2, w_L1_in_L2_1 * c3);
    let w_L2_in_J3_2 = (-w_L1_in_L2_2).mul_add(c3, w_L1_in_L2_1 * s3_2);
    let w_J3_3 = u2 + u3;
    let w_L3_in_J4_1 = (-w_J3_3).mul_add(s4_2, w_L2_in_J3_1 * c4);
    let w_L3_in_J4_2 = w_J3_3.mul_add(c4, w_L2_in_J3_1 * s4_2);
    let w_J4_3 = u4 - w_L2_in_J3_2;
    let w_L4_in_J5_1 = w_J4_3.mul_add(s5_2, w_L3_in_J4_1 * c5);
    let w_L4_in_J5_2 = (-w_J4_3).mul_add(c5, w_L3_in_J4_1 * s5_2);
    let w_J5_3 = u5 + w_L3_in_J4_2;
    let w_L5_in_L6_1 = (-w_J5_3).mul_add(s6, w_L4_in_J5_1 * c6);
    let w_L5_in_L6_2 = w_J5_3.mul_add(c6, w_L4_in_J5_1 * s6);
    let w_L6_3 = u6 - w_L4_in_J5_2;
    let alpha_L2_1 = u2 * w_L1_in_L2_2;
    let alpha_L2_2 = u2 * w_L1_in_L2_1;
    let w_L2_11 = w_L1_in_L2_1 * w_L1_in_L2_1;
    let w_L2_12 = w_L1_in_L2_1 * w_L1_in_L2_2;
    let w_L2_22 = w_L1_in_L2_2 * w_L1_in_L2_2;
    let w_L2_33 = u2 * u2;
    let turn_L2_11 = w_L2_22 + w_L2_33;
    let turn_L2_22 = w_L2_11 + w_L2_33;
    let turn_L2_33 = w_L2_11 + w_L2_22;
    let alpha_L2_in_J3_1 = -u2 * w_L2_in_J3_2;
    let alpha_L2_in_J3_2 = u2 * w_L2_in_J3_1;
    let alpha_J3_1 = u3.mul_add(w_L2_in_J3_2, -alpha_L2_in_J3_1);
    let alpha_J3_2 = u3.mul_add(w_L2_in_J3_1, alpha_L2_in_J3_2);
    let w_J3_11 = w_L2_in_J3_1 * w_L2_in_J3_1;
    let w_J3_12 = w_L2_in_J3_1 * w_L2_in_J3_2;
    let w_J3_13 = w_L2_in_J3_1 * w_J3_3;
    let w_J3_22 = w_L2_in_J3_2 * w_L2_in_J3_2;
    let w_J3_23 = w_L2_in_J3_2 * w_J3_3;
    let w_J3_33 = w_J3_3 * w_J3_3;
    let turn_J3_11 = w_J3_22 + w_J3_33;
    let turn_J3_13 = alpha_J3_2 - w_J3_13;
    let turn_J3_22 = w_J3_11 + w_J3_33;
    let turn_J3_23 = alpha_J3_1 - w_J3_23;
    let turn_J3_31 = alpha_J3_2 + w_J3_13;
    let turn_J3_32 = alpha_J3_1 + w_J3_23;
    let turn_J3_33 = w_J3_11 + w_J3_22;
    let alpha_L3_in_J4_1 = alpha_J3_1 * c4;
    let alpha_L3_in_J4_2 = alpha_J3_1 * s4_2;
    let alpha_L4_1 = u4.mul_add(w_L3_in_J4_2, alpha_L3_in_J4_1);
    let alpha_L4_2 = u4.mul_add(w_L3_in_J4_1, -alpha_L3_in_J4_2);
    let w_L4_11 = w_L3_in_J4_1 * w_L3_in_J4_1;
    let w_L4_12 = w_L3_in_J4_1 * w_J4_3;
    let w_L4_23 = w_L3_in_J4_2 * w_J4_3;
    let w_L4_33 = w_L3_in_J4_2 * w_L3_in_J4_2;
    let turn_L4_12 = alpha_L4_2 - w_L4_12;
    let turn_L4_22 = w_L4_11 + w_L4_33;
    let turn_L4_32 = alpha_L4_1 - w_L4_23;
    let alpha_L4_in_J5_1 = alpha_L4_1.mul_add(c5, alpha_J3_2 * s5_2);
    let alpha_L4_in_J5_2 = (-alpha_J3_2).mul_add(c5, alpha_L4_1 * s5_2);
    let alpha_L6_1 = u5.mul_add(w_L4_in_J5_2, alpha_L4_in_J5_1);
    let alpha_L6_2 = u5.mul_add(w_L4_in_J5_1, -alpha_L4_in_J5_2);
    let alpha_L5_in_L6_1 = alpha_L6_1.mul_add(c6, alpha_L4_2 * s6);
    let alpha_L5_in_L6_2 = (-alpha_L4_2).mul_add(c6, alpha_L6_1 * s6);
    let alpha_L6_1_2 = u6.mul_add(w_L5_in_L6_2, alpha_L5_in_L6_1);
    let alpha_L6_2_2 = u6.mul_add(w_L5_in_L6_1, -alpha_L5_in_L6_2);
    let w_L6_11 = w_L5_in_L6_1 * w_L5_in_L6_1;
    let w_L6_13 = w_L5_in_L6_1 * w_L6_3;
    let w_L6_22 = w_L5_in_L6_2 * w_L5_in_L6_2;
    let w_L6_23 = w_L5_in_L6_2 * w_L6_3;
    let turn_L6_13 = alpha_L6_2_2 - w_L6_13;
    let turn_L6_23 = alpha_L6_1_2 - w_L6_23;
    let turn_L6_33 = w_L6_11 + w_L6_22;
    let a_L1_in_L2_1 = g * s2_2;
    let a_L1_in_L2_2 = g * c2;
    let a2_plus_x2 = a2 + x2;
    let a_C2_1 = (-y2).mul_add(w_L2_12, turn_L2_11 * a2_plus_x2) - a_L1_in_L2_1;
    let a_C2_2 = (-y2).mul_add(turn_L2_22, a_L1_in_L2_2) + w_L2_12 * a2_plus_x2;
    let a_C2_3_of_place = alpha_L2_2.mul_add(a2_plus_x2, y2 * alpha_L2_1);
    let a_C2_3 = (-z2).mul_add(turn_L2_33, S::int(2) * a_C2_3_of_place);
    let H_upper_arm_1 = Ixx2 * w_L1_in_L2_1;
    let H_upper_arm_2 = Iyy2 * w_L1_in_L2_2;
    let H_upper_arm_3 = Izz2 * u2;
    let a_C3_1 = a2.mul_add(turn_L2_11, -a_L1_in_L2_1);
    let a_C3_2 = a2.mul_add(w_L2_12, a_L1_in_L2_2);
    let a_C3_3 = a2 * alpha_L2_2;
    let a_L2_in_J3_1 = (-a_C3_2).mul_add(s3_2, a_C3_1 * c3);
    let a_L2_in_J3_2 = a_C3_2.mul_add(c3, a_C3_1 * s3_2);
    let a_C3_1_2 = d3.mul_add(turn_J3_13, a3 * turn_J3_11) + a_L2_in_J3_1;
    let a_C3_2_2 = (-d3).mul_add(turn_J3_23, a3 * w_J3_12) - a_L2_in_J3_2;
    let a_C3_3_2 = (-d3).mul_add(turn_J3_33, a3 * turn_J3_31) + S::int(2) * a_C3_3;
    let a_C3_1_3 = x3.mul_add(turn_J3_11, z3 * w_J3_12) - y3 * turn_J3_13 + a_C3_1_2;
    let a_C3_2_3 = (-z3).mul_add(turn_J3_32, x3 * turn_J3_31) + y3 * turn_J3_33 + a_C3_3_2;
    let a_C3_3_3 = z3.mul_add(turn_J3_22, x3 * w_J3_12) + y3 * turn_J3_23 + a_C3_2_2;
    let H_forearm_1 = Ixx3 * w_L2_in_J3_1;
    let H_forearm_2 = Iyy3 * w_J3_3;
    let H_forearm_3 = Izz3 * w_L2_in_J3_2;
    let a_C4_1 = d4.mul_add(w_J3_12, a_C3_1_2);
    let a_C4_2 = d4.mul_add(turn_J3_32, -a_C3_3_2);
    let a_C4_3 = d4.mul_add(turn_J3_22, a_C3_2_2);
    let a_L3_in_J4_1 = (-a_C4_2).mul_add(s4_2, a_C4_1 * c4);
    let a_L3_in_J4_2 = a_C4_2.mul_add(c4, a_C4_1 * s4_2);
    let a_C4_1_2 = y4.mul_add(turn_L4_12, a_L3_in_J4_1);
    let a_C4_2_2 = y4.mul_add(turn_L4_22, a_C4_3);
    let a_C4_3_2 = y4.mul_add(turn_L4_32, a_L3_in_J4_2);
    let H_wrist1_1 = Ixx4 * w_L3_in_J4_1;
    let H_wrist1_2 = Iyy4 * w_J4_3;
    let H_wrist1_3 = Ixx4 * w_L3_in_J4_2;
    let H_wrist2_1 = Ixx5 * w_L4_in_J5_1;
    let H_wrist2_2 = Iyy5 * w_J5_3;
    let H_wrist2_3 = Ixx5 * w_L4_in_J5_2;
    let a_L4_in_J5_1 = a_L3_in_J4_1.mul_add(c5, a_C4_3 * s5_2);
    let a_L4_in_J5_2 = (-a_C4_3).mul_add(c5, a_L3_in_J4_1 * s5_2);
    let a_L5_in_L6_1 = (-a_L3_in_J4_2).mul_add(s6, a_L4_in_J5_1 * c6);
    let a_L5_in_L6_2 = a_L4_in_J5_1.mul_add(s6, a_L3_in_J4_2 * c6);
    let a_C6_1 = z6.mul_add(turn_L6_13, a_L5_in_L6_1);
    let a_C6_2 = z6.mul_add(turn_L6_23, a_L5_in_L6_2);
    let a_C6_3 = z6.mul_add(turn_L6_33, -a_L4_in_J5_2);
    let H_flange_1 = Ixx6 * w_L5_in_L6_1;
    let H_flange_2 = Ixx6 * w_L5_in_L6_2;
    let H_flange_3 = Izz6 * w_L6_3;
    let F_v_C6_2 = m6 * a_C6_2;
    let F_v_C6_1 = m6 * a_C6_1;
    let F_v_L4_in_J5_2 = m6 * a_C6_3;
    let F_v_L4_in_J5_1 = F_v_C6_1.mul_add(c6, F_v_C6_2 * s6);
    let F_v_C4_3 = m4 * a_C4_3_2;
    let F_v_C4_1 = m4 * a_C4_1_2;
    let F_v_L3_in_J4_2 = (-F_v_C6_1).mul_add(s6, F_v_C6_2 * c6) + F_v_C4_3;
    let F_v_L3_in_J4_1 = (-F_v_L4_in_J5_1).mul_add(c5, F_v_L4_in_J5_2 * s5_2) - F_v_C4_1;
    let F_v_C4_2 = F_v_L3_in_J4_2.mul_add(c4, m5 * a_C4_2) + F_v_L3_in_J4_1 * s4_2;
    let F_v_C4_1_2 = F_v_L3_in_J4_2.mul_add(s4_2, m5 * a_C4_1) - F_v_L3_in_J4_1 * c4;
    let F_v_C3_3 = m3 * a_C3_3_3;
    let F_v_C3_2 = m3 * a_C3_2_3;
    let F_v_C3_1 = m3 * a_C3_1_3;
    let F_v_C3_3_2 = F_v_C4_2 - F_v_C3_2;
    let F_v_C3_2_2 = m4.mul_add(a_C4_2_2, m5 * a_C4_3) + F_v_L4_in_J5_2 * c5
        + F_v_L4_in_J5_1 * s5_2 + F_v_C3_3;
    let F_v_C3_1_2 = F_v_C4_1_2 + F_v_C3_1;
    let F_v_C2_3 = m2 * a_C2_3;
    let F_v_C2_2 = m2 * a_C2_2;
    let F_v_C2_1 = m2 * a_C2_1;
    let F_w_L6_3 = Izz6.mul_add(alpha_L6_2, tau6) - w_L5_in_L6_2 * H_flange_1
        + w_L5_in_L6_1 * H_flange_2;
    let F_w_L5_in_L6_2 = (-Ixx6).mul_add(alpha_L6_2_2, w_L6_3 * H_flange_1)
        - w_L5_in_L6_1 * H_flange_3 - z6 * F_v_C6_1;
    let F_w_L5_in_L6_1 = (-w_L6_3).mul_add(H_flange_2, Ixx6 * alpha_L6_1_2)
        + w_L5_in_L6_2 * H_flange_3 + z6 * F_v_C6_2;
    let F_w_J5_3 = (-Iyy5).mul_add(alpha_L4_2, tau5) - w_L4_in_J5_2 * H_wrist2_1
        + w_L4_in_J5_1 * H_wrist2_3 + F_w_L5_in_L6_2 * c6 - F_w_L5_in_L6_1 * s6;
    let F_w_L4_in_J5_2 = (-Ixx5).mul_add(alpha_L6_2, tau6) + w_J5_3 * H_wrist2_1
        - w_L4_in_J5_1 * H_wrist2_2 - F_w_L6_3;
    let F_w_L4_in_J5_1 = (-Ixx5).mul_add(alpha_L6_1, w_J5_3 * H_wrist2_3)
        - w_L4_in_J5_2 * H_wrist2_2 - F_w_L5_in_L6_2 * s6 - F_w_L5_in_L6_1 * c6;
    let F_w_J4_3 = Iyy4.mul_add(alpha_J3_2, tau4) - w_L3_in_J4_2 * H_wrist1_1
        + w_L3_in_J4_1 * H_wrist1_3 - F_w_L4_in_J5_2 * c5 - F_w_L4_in_J5_1 * s5_2;
    let F_w_L3_in_J4_2 = Ixx4.mul_add(alpha_L4_2, tau5) - w_J4_3 * H_wrist1_1
        + w_L3_in_J4_1 * H_wrist1_2 + y4 * F_v_C4_1 - F_w_J5_3;
    let F_w_L3_in_J4_1 = (-Ixx4).mul_add(alpha_L4_1, w_J4_3 * H_wrist1_3)
        - w_L3_in_J4_2 * H_wrist1_2 - y4 * F_v_C4_3 - F_w_L4_in_J5_2 * s5_2 + F_w_L4_in_J5_1 * c5;
    let F_w_L2_in_J3_2 = (-Izz3).mul_add(alpha_J3_2, tau4) + w_J3_3 * H_forearm_1
        - w_L2_in_J3_1 * H_forearm_2 - x3 * F_v_C3_2 + y3 * F_v_C3_1 + a3 * F_v_C3_3_2
        - d3 * F_v_C3_1_2 - F_w_J4_3;
    let F_w_L2_in_J3_1 = (-Ixx3).mul_add(alpha_J3_1, w_J3_3 * H_forearm_3)
        - w_L2_in_J3_2 * H_forearm_2 - d4 * F_v_C4_2 - y3 * F_v_C3_3 + z3 * F_v_C3_2
        + d3 * F_v_C3_2_2 + F_w_L3_in_J4_2 * s4_2 + F_w_L3_in_J4_1 * c4;
    let F_w_L1_in_L2_2 = (-Iyy2).mul_add(alpha_L2_2, u2 * H_upper_arm_1)
        - w_L1_in_L2_1 * H_upper_arm_3 + a2 * F_v_C3_3_2 - z2 * F_v_C2_1
        + F_w_L2_in_J3_2 * c3 + F_w_L2_in_J3_1 * s3_2 - F_v_C2_3 * a2_plus_x2;
    let F_w_L1_in_L2_1 = (-u2).mul_add(H_upper_arm_2, Ixx2 * alpha_L2_1)
        + w_L1_in_L2_2 * H_upper_arm_3 + y2 * F_v_C2_3 - z2 * F_v_C2_2
        - F_w_L2_in_J3_2 * s3_2 + F_w_L2_in_J3_1 * c3;
    let F_w_J3_3 = (-w_L2_in_J3_2).mul_add(H_forearm_1, tau3)
        + w_L2_in_J3_1 * H_forearm_3 - d4 * F_v_C4_1_2 + x3 * F_v_C3_3 - z3 * F_v_C3_1
        + a3 * F_v_C3_2_2 - F_w_L3_in_J4_2 * c4 + F_w_L3_in_J4_1 * s4_2;
    // Values.
    let f1 = (-F_w_L1_in_L2_2).mul_add(c2, tau1) - F_w_L1_in_L2_1 * s2_2;
    let f2 = tau2 - tau3 + w_L1_in_L2_2 * H_upper_arm_1 - w_L1_in_L2_1 * H_upper_arm_2
        + a2 * F_v_C3_1_2.mul_add(s3_2, F_v_C3_2_2 * c3) - y2 * F_v_C2_1 + F_w_J3_3
        - F_v_C2_2 * a2_plus_x2;
    [f1, f2, F_w_J3_3, F_w_J4_3, F_w_J5_3, F_w_L6_3]
}

/// The accelerations (u1', u2', u3', u4', u5', u6'), solved for when this code was generated.
///
/// 802 operations, 5 sines and cosines.
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
    let (s5_2, c5) = q5.sin_cos();
    let (s6, c6) = q6.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_L1_in_L2_1 = u1 * s2_2;
    let w_L1_in_L2_2 = u1 * c2;
    let w_L2_in_J3_1 = w_L1_in_L2_2.mul_add(s3_2, w_L1_in_L2_1 * c3);
    let w_L2_in_J3_2 = (-w_L1_in_L2_2).mul_add(c3, w_L1_in_L2_1 * s3_2);
    let w_J3_3 = u2 + u3;
    let w_L3_in_J4_1 = (-w_J3_3).mul_add(s4_2, w_L2_in_J3_1 * c4);
    let w_L3_in_J4_2 = w_J3_3.mul_add(c4, w_L2_in_J3_1 * s4_2);
    let w_J4_3 = u4 - w_L2_in_J3_2;
    let w_L4_in_J5_1 = w_J4_3.mul_add(s5_2, w_L3_in_J4_1 * c5);
    let w_L4_in_J5_2 = (-w_J4_3).mul_add(c5, w_L3_in_J4_1 * s5_2);
    let w_J5_3 = u5 + w_L3_in_J4_2;
    let w_L5_in_L6_1 = (-w_J5_3).mul_add(s6, w_L4_in_J5_1 * c6);
    let w_L5_in_L6_2 = w_J5_3.mul_add(c6, w_L4_in_J5_1 * s6);
    let w_L6_3 = u6 - w_L4_in_J5_2;
    let alpha_L2_1 = u2 * w_L1_in_L2_2;
    let alpha_L2_2 = u2 * w_L1_in_L2_1;
    let w_L2_11 = w_L1_in_L2_1 * w_L1_in_L2_1;
    let w_L2_12 = w_L1_in_L2_1 * w_L1_in_L2_2;
    let w_L2_22 = w_L1_in_L2_2 * w_L1_in_L2_2;
    let w_L2_33 = u2 * u2;
    let turn_L2_11 = w_L2_22 + w_L2_33;
    let turn_L2_22 = w_L2_11 + w_L2_33;
    let turn_L2_33 = w_L2_11 + w_L2_22;
    let alpha_L2_in_J3_1 = -u2 * w_L2_in_J3_2;
    let alpha_L2_in_J3_2 = u2 * w_L2_in_J3_1;
    let alpha_J3_1 = u3.mul_add(w_L2_in_J3_2, -alpha_L2_in_J3_1);
    let alpha_J3_2 = u3.mul_add(w_L2_in_J3_1, alpha_L2_in_J3_2);
    let w_J3_11 = w_L2_in_J3_1 * w_L2_in_J3_1;
    let w_J3_12 = w_L2_in_J3_1 * w_L2_in_J3_2;
    let w_J3_13 = w_L2_in_J3_1 * w_J3_3;
    let w_J3_22 = w_L2_in_J3_2 * w_L2_in_J3_2;
    let w_J3_23 = w_L2_in_J3_2 * w_J3_3;
    let w_J3_33 = w_J3_3 * w_J3_3;
    let turn_J3_11 = w_J3_22 + w_J3_33;
    let turn_J3_13 = alpha_J3_2 - w_J3_13;
    let turn_J3_22 = w_J3_11 + w_J3_33;
    let turn_J3_23 = alpha_J3_1 - w_J3_23;
    let turn_J3_31 = alpha_J3_2 + w_J3_13;
    let turn_J3_32 = alpha_J3_1 + w_J3_23;
    let turn_J3_33 = w_J3_11 + w_J3_22;
    let alpha_L3_in_J4_1 = alpha_J3_1 * c4;
    let alpha_L3_in_J4_2 = alpha_J3_1 * s4_2;
    let alpha_L4_1 = u4.mul_add(w_L3_in_J4_2, alpha_L3_in_J4_1);
    let alpha_L4_2 = u4.mul_add(w_L3_in_J4_1, -alpha_L3_in_J4_2);
    let w_L4_11 = w_L3_in_J4_1 * w_L3_in_J4_1;
    let w_L4_12 = w_L3_in_J4_1 * w_J4_3;
    let w_L4_23 = w_L3_in_J4_2 * w_J4_3;
    let w_L4_33 = w_L3_in_J4_2 * w_L3_in_J4_2;
    let turn_L4_12 = alpha_L4_2 - w_L4_12;
    let turn_L4_22 = w_L4_11 + w_L4_33;
    let turn_L4_32 = alpha_L4_1 - w_L4_23;
    let alpha_L4_in_J5_1 = alpha_L4_1.mul_add(c5, alpha_J3_2 * s5_2);
    let alpha_L4_in_J5_2 = (-alpha_J3_2).mul_add(c5, alpha_L4_1 * s5_2);
    let alpha_L6_1 = u5.mul_add(w_L4_in_J5_2, alpha_L4_in_J5_1);
    let alpha_L6_2 = u5.mul_add(w_L4_in_J5_1, -alpha_L4_in_J5_2);
    let alpha_L5_in_L6_1 = alpha_L6_1.mul_add(c6, alpha_L4_2 * s6);
    let alpha_L5_in_L6_2 = (-alpha_L4_2).mul_add(c6, alpha_L6_1 * s6);
    let alpha_L6_1_2 = u6.mul_add(w_L5_in_L6_2, alpha_L5_in_L6_1);
    let alpha_L6_2_2 = u6.mul_add(w_L5_in_L6_1, -alpha_L5_in_L6_2);
    let w_L6_11 = w_L5_in_L6_1 * w_L5_in_L6_1;
    let w_L6_13 = w_L5_in_L6_1 * w_L6_3;
    let w_L6_22 = w_L5_in_L6_2 * w_L5_in_L6_2;
    let w_L6_23 = w_L5_in_L6_2 * w_L6_3;
    let turn_L6_13 = alpha_L6_2_2 - w_L6_13;
    let turn_L6_23 = alpha_L6_1_2 - w_L6_23;
    let turn_L6_33 = w_L6_11 + w_L6_22;
    let a_L1_in_L2_1 = g * s2_2;
    let a_L1_in_L2_2 = g * c2;
    let a2_plus_x2 = a2 + x2;
    let a_C2_1 = (-y2).mul_add(w_L2_12, turn_L2_11 * a2_plus_x2) - a_L1_in_L2_1;
    let a_C2_2 = (-y2).mul_add(turn_L2_22, a_L1_in_L2_2) + w_L2_12 * a2_plus_x2;
    let a_C2_3_of_place = alpha_L2_2.mul_add(a2_plus_x2, y2 * alpha_L2_1);
    let a_C2_3 = (-z2).mul_add(turn_L2_33, S::int(2) * a_C2_3_of_place);
    let H_upper_arm_1 = Ixx2 * w_L1_in_L2_1;
    let H_upper_arm_2 = Iyy2 * w_L1_in_L2_2;
    let H_upper_arm_3 = Izz2 * u2;
    let a_C3_1 = a2.mul_add(turn_L2_11, -a_L1_in_L2_1);
    let a_C3_2 = a2.mul_add(w_L2_12, a_L1_in_L2_2);
    let a_C3_3 = a2 * alpha_L2_2;
    let a_L2_in_J3_1 = (-a_C3_2).mul_add(s3_2, a_C3_1 * c3);
    let a_L2_in_J3_2 = a_C3_2.mul_add(c3, a_C3_1 * s3_2);
    let a_C3_1_2 = d3.mul_add(turn_J3_13, a3 * turn_J3_11) + a_L2_in_J3_1;
    let a_C3_2_2 = (-d3).mul_add(turn_J3_23, a3 * w_J3_12) - a_L2_in_J3_2;
    let a_C3_3_2 = (-d3).mul_add(turn_J3_33, a3 * turn_J3_31) + S::int(2) * a_C3_3;
    let a_C3_1_3 = x3.mul_add(turn_J3_11, z3 * w_J3_12) - y3 * turn_J3_13 + a_C3_1_2;
    let a_C3_2_3 = (-z3).mul_add(turn_J3_32, x3 * turn_J3_31) + y3 * turn_J3_33 + a_C3_3_2;
    let a_C3_3_3 = z3.mul_add(turn_J3_22, x3 * w_J3_12) + y3 * turn_J3_23 + a_C3_2_2;
    let H_forearm_1 = Ixx3 * w_L2_in_J3_1;
    let H_forearm_2 = Iyy3 * w_J3_3;
    let H_forearm_3 = Izz3 * w_L2_in_J3_2;
    let a_C4_1 = d4.mul_add(w_J3_12, a_C3_1_2);
    let a_C4_2 = d4.mul_add(turn_J3_32, -a_C3_3_2);
    let a_C4_3 = d4.mul_add(turn_J3_22, a_C3_2_2);
    let a_L3_in_J4_1 = (-a_C4_2).mul_add(s4_2, a_C4_1 * c4);
    let a_L3_in_J4_2 = a_C4_2.mul_add(c4, a_C4_1 * s4_2);
    let a_C4_1_2 = y4.mul_add(turn_L4_12, a_L3_in_J4_1);
    let a_C4_2_2 = y4.mul_add(turn_L4_22, a_C4_3);
    let a_C4_3_2 = y4.mul_add(turn_L4_32, a_L3_in_J4_2);
    let H_wrist1_1 = Ixx4 * w_L3_in_J4_1;
    let H_wrist1_2 = Iyy4 * w_J4_3;
    let H_wrist1_3 = Ixx4 * w_L3_in_J4_2;
    let H_wrist2_1 = Ixx5 * w_L4_in_J5_1;
    let H_wrist2_2 = Iyy5 * w_J5_3;
    let H_wrist2_3 = Ixx5 * w_L4_in_J5_2;
    let a_L4_in_J5_1 = a_L3_in_J4_1.mul_add(c5, a_C4_3 * s5_2);
    let a_L4_in_J5_2 = (-a_C4_3).mul_add(c5, a_L3_in_J4_1 * s5_2);
    let a_L5_in_L6_1 = (-a_L3_in_J4_2).mul_add(s6, a_L4_in_J5_1 * c6);
    let a_L5_in_L6_2 = a_L4_in_J5_1.mul_add(s6, a_L3_in_J4_2 * c6);
    let a_C6_1 = z6.mul_add(turn_L6_13, a_L5_in_L6_1);
    let a_C6_2 = z6.mul_add(turn_L6_23, a_L5_in_L6_2);
    let a_C6_3 = z6.mul_add(turn_L6_33, -a_L4_in_J5_2);
    let H_flange_1 = Ixx6 * w_L5_in_L6_1;
    let H_flange_2 = Ixx6 * w_L5_in_L6_2;
    let H_flange_3 = Izz6 * w_L6_3;
    let F_v_C6_2 = m6 * a_C6_2;
    let F_v_C6_1 = m6 * a_C6_1;
    let F_v_L4_in_J5_2 = m6 * a_C6_3;
    let F_v_L4_in_J5_1 = F_v_C6_1.mul_add(c6, F_v_C6_2 * s6);
    let F_v_C4_3 = m4 * a_C4_3_2;
    let F_v_C4_1 = m4 * a_C4_1_2;
    let F_v_L3_in_J4_2 = (-F_v_C6_1).mul_add(s6, F_v_C6_2 * c6) + F_v_C4_3;
    let F_v_L3_in_J4_1 = (-F_v_L4_in_J5_1).mul_add(c5, F_v_L4_in_J5_2 * s5_2) - F_v_C4_1;
    let F_v_C4_2 = F_v_L3_in_J4_2.mul_add(c4, m5 * a_C4_2) + F_v_L3_in_J4_1 * s4_2;
    let F_v_C4_1_2 = F_v_L3_in_J4_2.mul_add(s4_2, m5 * a_C4_1) - F_v_L3_in_J4_1 * c4;
    let F_v_C3_3 = m3 * a_C3_3_3;
    let F_v_C3_2 = m3 * a_C3_2_3;
    let F_v_C3_1 = m3 * a_C3_1_3;
    let F_v_C3_3_2 = F_v_C4_2 - F_v_C3_2;
    let F_v_C3_2_2 = m4.mul_add(a_C4_2_2, m5 * a_C4_3) + F_v_L4_in_J5_2 * c5
        + F_v_L4_in_J5_1 * s5_2 + F_v_C3_3;
    let F_v_C3_1_2 = F_v_C4_1_2 + F_v_C3_1;
    let F_v_C2_3 = m2 * a_C2_3;
    let F_v_C2_2 = m2 * a_C2_2;
    let F_v_C2_1 = m2 * a_C2_1;
    let F_w_L6_3 = Izz6.mul_add(alpha_L6_2, tau6) - w_L5_in_L6_2 * H_flange_1
        + w_L5_in_L6_1 * H_flange_2;
    let F_w_L5_in_L6_2 = (-Ixx6).mul_add(alpha_L6_2_2, w_L6_3 * H_flange_1)
        - w_L5_in_L6_1 * H_flange_3 - z6 * F_v_C6_1;
    let F_w_L5_in_L6_1 = (-w_L6_3).mul_add(H_flange_2, Ixx6 * alpha_L6_1_2)
        + w_L5_in_L6_2 * H_flange_3 + z6 * F_v_C6_2;
    let F_w_J5_3 = (-Iyy5).mul_add(alpha_L4_2, tau5) - w_L4_in_J5_2 * H_wrist2_1
        + w_L4_in_J5_1 * H_wrist2_3 + F_w_L5_in_L6_2 * c6 - F_w_L5_in_L6_1 * s6;
    let F_w_L4_in_J5_2 = (-Ixx5).mul_add(alpha_L6_2, tau6) + w_J5_3 * H_wrist2_1
        - w_L4_in_J5_1 * H_wrist2_2 - F_w_L6_3;
    let F_w_L4_in_J5_1 = (-Ixx5).mul_add(alpha_L6_1, w_J5_3 * H_wrist2_3)
        - w_L4_in_J5_2 * H_wrist2_2 - F_w_L5_in_L6_2 * s6 - F_w_L5_in_L6_1 * c6;
    let F_w_J4_3 = Iyy4.mul_add(alpha_J3_2, tau4) - w_L3_in_J4_2 * H_wrist1_1
        + w_L3_in_J4_1 * H_wrist1_3 - F_w_L4_in_J5_2 * c5 - F_w_L4_in_J5_1 * s5_2;
    let F_w_L3_in_J4_2 = Ixx4.mul_add(alpha_L4_2, tau5) - w_J4_3 * H_wrist1_1
        + w_L3_in_J4_1 * H_wrist1_2 + y4 * F_v_C4_1 - F_w_J5_3;
    let F_w_L3_in_J4_1 = (-Ixx4).mul_add(alpha_L4_1, w_J4_3 * H_wrist1_3)
        - w_L3_in_J4_2 * H_wrist1_2 - y4 * F_v_C4_3 - F_w_L4_in_J5_2 * s5_2 + F_w_L4_in_J5_1 * c5;
    let F_w_L2_in_J3_2 = (-Izz3).mul_add(alpha_J3_2, tau4) + w_J3_3 * H_forearm_1
        - w_L2_in_J3_1 * H_forearm_2 - x3 * F_v_C3_2 + y3 * F_v_C3_1 + a3 * F_v_C3_3_2
        - d3 * F_v_C3_1_2 - F_w_J4_3;
    let F_w_L2_in_J3_1 = (-Ixx3).mul_add(alpha_J3_1, w_J3_3 * H_forearm_3)
        - w_L2_in_J3_2 * H_forearm_2 - d4 * F_v_C4_2 - y3 * F_v_C3_3 + z3 * F_v_C3_2
        + d3 * F_v_C3_2_2 + F_w_L3_in_J4_2 * s4_2 + F_w_L3_in_J4_1 * c4;
    let F_w_L1_in_L2_2 = (-Iyy2).mul_add(alpha_L2_2, u2 * H_upper_arm_1)
        - w_L1_in_L2_1 * H_upper_arm_3 + a2 * F_v_C3_3_2 - z2 * F_v_C2_1
        + F_w_L2_in_J3_2 * c3 + F_w_L2_in_J3_1 * s3_2 - F_v_C2_3 * a2_plus_x2;
    let F_w_L1_in_L2_1 = (-u2).mul_add(H_upper_arm_2, Ixx2 * alpha_L2_1)
        + w_L1_in_L2_2 * H_upper_arm_3 + y2 * F_v_C2_3 - z2 * F_v_C2_2
        - F_w_L2_in_J3_2 * s3_2 + F_w_L2_in_J3_1 * c3;
    let F_w_J3_3 = (-w_L2_in_J3_2).mul_add(H_forearm_1, tau3)
        + w_L2_in_J3_1 * H_forearm_3 - d4 * F_v_C4_1_2 + x3 * F_v_C3_3 - z3 * F_v_C3_1
        + a3 * F_v_C3_2_2 - F_w_L3_in_J4_2 * c4 + F_w_L3_in_J4_1 * s4_2;
    let mr_L6_3 = m6 * z6;
    let rw_L6_3 = z6 * mr_L6_3;
    let J_L6_11 = Ixx6 + rw_L6_3;
    let m_L5 = m5 + m6;
    let J_L5_11 = Ixx5 + J_L6_11;
    let J_L5_22 = Iyy5 + J_L6_11;
    let J_L5_33 = Ixx5 + Izz6;
    let J_L5_in_J5_23 = J_L5_22 - J_L5_33;
    let J_L5_in_J5_22 = J_L5_22 - J_L5_in_J5_23;
    let J_L5_in_J5_33 = J_L5_33 + J_L5_in_J5_23;
    let s_J5_in_L4_1 = mr_L6_3 * s5_2;
    let s_J5_in_L4_2 = mr_L6_3 * c5;
    let J_J5_in_L4_12 = J_L5_11 - J_L5_in_J5_22;
    let J_J5_in_L4 = J_J5_in_L4_12 * s5_2;
    let J_J5_in_L4_2 = J_J5_in_L4 * s5_2;
    let J_J5_in_L4_11 = J_L5_11 - J_J5_in_L4_2;
    let J_J5_in_L4_12_2 = J_J5_in_L4 * c5;
    let J_J5_in_L4_22 = J_L5_in_J5_22 + J_J5_in_L4_2;
    let mr_L4_2 = m4 * y4;
    let rw_L4_2 = y4 * mr_L4_2;
    let m_L4 = m4 + m_L5;
    let s_L4_2 = s_J5_in_L4_2 + mr_L4_2;
    let ixx4_plus_rw_l4_2 = Ixx4 + rw_L4_2;
    let J_L4_11 = J_J5_in_L4_11 + ixx4_plus_rw_l4_2;
    let J_L4_22 = Iyy4 + J_J5_in_L4_22;
    let J_L4_33 = J_L5_in_J5_33 + ixx4_plus_rw_l4_2;
    let J_L4_in_J4_23 = J_L4_22 - J_L4_33;
    let J_L4_in_J4_22 = J_L4_22 - J_L4_in_J4_23;
    let J_L4_in_J4_33 = J_L4_33 + J_L4_in_J4_23;
    let s_J4_in_L3_1 = s_J5_in_L4_1 * c4;
    let s_J4_in_L3_2 = s_J5_in_L4_1 * s4_2;
    let J_J4_in_L3_1 = J_J5_in_L4_12_2 * c4;
    let J_J4_in_L3_12 = J_L4_11 - J_L4_in_J4_22;
    let J_J4_in_L3 = J_J4_in_L3_12 * s4_2;
    let J_J4_in_L3_2 = J_J4_in_L3 * s4_2;
    let J_J4_in_L3_11 = J_L4_11 - J_J4_in_L3_2;
    let J_J4_in_L3_22 = J_L4_in_J4_22 + J_J4_in_L3_2;
    let mr_L3_3 = d4 * m_L4;
    let s_L3_3 = s_L4_2 + mr_L3_3;
    let w_L3_3 = s_L4_2 + s_L3_3;
    let rw_L3_3 = d4 * w_L3_3;
    let mr_L3_1 = m3 * x3;
    let mr_L3_2 = m3 * y3;
    let mr_L3_3_2 = m3 * z3;
    let rw_L3_1 = x3 * mr_L3_1;
    let rw_L3_2 = y3 * mr_L3_2;
    let rw_L3_3_2 = z3 * mr_L3_3_2;
    let m_L3 = m3 + m_L4;
    let s_L3_1 = s_J4_in_L3_1 - mr_L3_1;
    let s_L3_2 = s_J4_in_L3_2 - mr_L3_2;
    let s_L3_3_2 = s_L3_3 + mr_L3_3_2;
    let rw_l3_3_plus_rw_l3_3_2 = rw_L3_3 + rw_L3_3_2;
    let J_L3_11 = Ixx3 + J_J4_in_L3_11 + rw_L3_2 + rw_l3_3_plus_rw_l3_3_2;
    let h_J4_L3_1 = d4.mul_add(s_J4_in_L3_1, J_J4_in_L3_1);
    let J_L3_13 = (-z3).mul_add(mr_L3_1, S::int(2) * h_J4_L3_1) - x3 * mr_L3_3_2;
    let J_L3_22 = Iyy3 + J_J4_in_L3_22 + rw_L3_1 + rw_l3_3_plus_rw_l3_3_2;
    let J_L3_33 = Izz3 + J_L4_in_J4_33 + rw_L3_1 + rw_L3_2;
    let J_L3_in_J3_23 = J_L3_22 - J_L3_33;
    let J_L3_in_J3_22 = J_L3_22 - J_L3_in_J3_23;
    let J_L3_in_J3_33 = J_L3_33 + J_L3_in_J3_23;
    let mr_J3_1 = a3 * m_L3;
    let mr_J3_3 = d3 * m_L3;
    let s_J3_1 = s_L3_1 - mr_J3_1;
    let s_J3_3 = s_L3_2 + mr_J3_3;
    let w_J3_1 = s_L3_1 + s_J3_1;
    let w_J3_3_2 = s_L3_2 + s_J3_3;
    let rw_J3_1 = a3 * w_J3_1;
    let rw_J3_3 = d3 * w_J3_3_2;
    let J_J3_11 = J_L3_11 + rw_J3_3;
    let s_l3_3_2_doubled = S::int(2) * s_L3_3_2;
    let J_J3_12 = (-a3).mul_add(s_l3_3_2_doubled, J_L3_13);
    let J_J3_22 = J_L3_in_J3_22 - rw_J3_1 + rw_J3_3;
    let J_J3_33 = J_L3_in_J3_33 - rw_J3_1;
    let s_J3_in_L2_1 = s_J3_1.mul_add(c3, s_L3_3_2 * s3_2);
    let s_J3_in_L2_2 = (-s_L3_3_2).mul_add(c3, s_J3_1 * s3_2);
    let J_J3_in_L2_12 = J_J3_11 - J_J3_22;
    let J_J3_in_L2 = J_J3_in_L2_12.mul_add(s3_2, J_J3_12 * c3);
    let J_J3_in_L2_2 = J_J3_in_L2 * s3_2;
    let J_J3_in_L2_11 = J_J3_11 - J_J3_in_L2_2;
    let J_J3_in_L2_12_2 = (-(J_J3_in_L2 * c3)).mul_add(S::int(2), J_J3_12);
    let J_J3_in_L2_22 = J_J3_22 + J_J3_in_L2_2;
    let mr_L2_1 = m2 * x2;
    let mr_L2_2 = m2 * y2;
    let mr_L2_3 = m2 * z2;
    let rw_L2_1 = x2 * mr_L2_1;
    let rw_L2_2 = y2 * mr_L2_2;
    let rw_L2_3 = z2 * mr_L2_3;
    let m_L2 = m2 + m_L3;
    let s_L2_1 = s_J3_in_L2_1 - mr_L2_1;
    let s_L2_2 = s_J3_in_L2_2 - mr_L2_2;
    let J_L2_11 = Ixx2 + J_J3_in_L2_11 + rw_L2_2 + rw_L2_3;
    let J_L2_12 = y2.mul_add(mr_L2_1, J_J3_in_L2_12_2) + x2 * mr_L2_2;
    let J_L2_22 = Iyy2 + J_J3_in_L2_22 + rw_L2_1 + rw_L2_3;
    let J_L2_33 = Izz2 + J_J3_33 + rw_L2_1 + rw_L2_2;
    let mr_L2_1_2 = a2 * m_L2;
    let s_L2_1_2 = s_L2_1 - mr_L2_1_2;
    let w_L2_1 = s_L2_1 + s_L2_1_2;
    let rw_L2_1_2 = a2 * w_L2_1;
    let a2_doubled = S::int(2) * a2;
    let J_L2_12_2 = (-s_L2_2).mul_add(a2_doubled, J_L2_12);
    let J_L2_22_2 = J_L2_22 - rw_L2_1_2;
    let J_L2_33_2 = J_L2_33 - rw_L2_1_2;
    let J_L2_in_L1_12 = J_L2_11 - J_L2_22_2;
    let J_L2_in_L1 = (-J_L2_12_2).mul_add(c2, J_L2_in_L1_12 * s2_2);
    let J_L2_in_L1_2 = J_L2_in_L1 * s2_2;
    let J_L2_in_L1_22 = J_L2_22_2 + J_L2_in_L1_2;
    let J_L1_in_J1_23 = J_L2_33_2 - J_L2_in_L1_22;
    let J_L1_in_J1_33 = J_L2_33_2 - J_L1_in_J1_23;
    let J_J1_33 = I1 + J_L1_in_J1_33;
    let J_J4_in_L3_2_ = J_J5_in_L4_12_2 * s4_2;
    let J_J4_in_L3_12_2 = J_J4_in_L3 * c4;
    let J_L3_12 = (-y3).mul_add(mr_L3_1, S::int(2) * J_J4_in_L3_12_2) - x3 * mr_L3_2;
    let h_J4_L3_2 = d4.mul_add(s_J4_in_L3_2, J_J4_in_L3_2_);
    let J_L3_23 = (-z3).mul_add(mr_L3_2, S::int(2) * h_J4_L3_2) - y3 * mr_L3_3_2;
    let J_J3_13 = (-d3).mul_add(w_J3_1, a3 * w_J3_3_2) + J_L3_12;
    let J_J3_23 = d3.mul_add(s_l3_3_2_doubled, J_L3_23);
    let J_J3_in_L2_1 = (-J_J3_23).mul_add(s3_2, J_J3_13 * c3);
    let J_J3_in_L2_2_ = J_J3_23.mul_add(c3, J_J3_13 * s3_2);
    let s_L2_3 = s_J3_3 + mr_L2_3;
    let J_L2_13 = x2.mul_add(mr_L2_3, z2 * mr_L2_1) + J_J3_in_L2_1;
    let J_L2_23 = y2.mul_add(mr_L2_3, z2 * mr_L2_2) + J_J3_in_L2_2_;
    let J_L2_13_2 = s_L2_3.mul_add(a2_doubled, J_L2_13);
    let J_L2_in_L1_2_ = J_L2_13_2.mul_add(s2_2, J_L2_23 * c2);
    let h_J3_in_L2_2 = J_J3_in_L2_2_.mul_add(c2, J_J3_in_L2_1 * s2_2);
    let h_J4_J3_2 = (-a3).mul_add(s_J4_in_L3_1, J_L4_in_J4_33) + d3 * s_J4_in_L3_2;
    let h_J4_in_J3_1 = (-h_J4_J3_2).mul_add(s3_2, h_J4_L3_1 * c3);
    let h_J4_in_J3_2 = h_J4_J3_2.mul_add(c3, h_J4_L3_1 * s3_2);
    let h_J4_L2_2 = (-a2).mul_add(s_J4_in_L3_1, h_J4_in_J3_2);
    let h_J4_in_L2_2 = h_J4_L2_2.mul_add(c2, h_J4_in_J3_1 * s2_2);
    let p_J5_in_J4_1 = s_J5_in_L4_2 * c4;
    let p_J5_in_J4_2 = s_J5_in_L4_2 * s4_2;
    let h_J5_in_J4_1 = J_L5_in_J5_33 * s4_2;
    let h_J5_L3_1 = d4.mul_add(p_J5_in_J4_2, h_J5_in_J4_1);
    let h_J5_J3_1 = d3.mul_add(s_J5_in_L4_1, h_J5_L3_1);
    let h_J5_J3_2 = a3.mul_add(p_J5_in_J4_2, d3 * p_J5_in_J4_1);
    let h_J5_in_J3_1 = h_J5_J3_2.mul_add(s3_2, h_J5_J3_1 * c3);
    let h_J5_in_J3_2 = (-h_J5_J3_2).mul_add(c3, h_J5_J3_1 * s3_2);
    let h_J5_L2_2 = (-a2).mul_add(p_J5_in_J4_2, h_J5_in_J3_2);
    let h_J5_in_L2_2 = h_J5_L2_2.mul_add(c2, h_J5_in_J3_1 * s2_2);
    let h_L6_in_J5_1 = Izz6 * s5_2;
    let h_L6_in_J5_2 = Izz6 * c5;
    let h_L6_in_J4_1 = h_L6_in_J5_1 * c4;
    let h_L6_in_J3_1 = h_L6_in_J4_1.mul_add(c3, h_L6_in_J5_2 * s3_2);
    let h_L6_in_J3_2 = (-h_L6_in_J5_2).mul_add(c3, h_L6_in_J4_1 * s3_2);
    let h_L6_in_L2_2 = h_L6_in_J3_2.mul_add(c2, h_L6_in_J3_1 * s2_2);
    let h_J3_L2_3 = (-a2).mul_add(s_J3_in_L2_1, J_J3_33);
    let p_J4_in_J3_2 = s_J4_in_L3_2 * s3_2;
    let h_J4_L2_3 = (-a2).mul_add(p_J4_in_J3_2, h_J4_L3_2);
    let h_J5_in_J4_2 = J_L5_in_J5_33 * c4;
    let h_J5_L3_2 = d4.mul_add(p_J5_in_J4_1, h_J5_in_J4_2);
    let h_J5_J3_3 = (-a3).mul_add(s_J5_in_L4_1, h_J5_L3_2);
    let p_J5_in_J3_2 = p_J5_in_J4_1.mul_add(s3_2, s_J5_in_L4_1 * c3);
    let h_J5_L2_3 = (-a2).mul_add(p_J5_in_J3_2, h_J5_J3_3);
    let h_L6_in_J4_2 = h_L6_in_J5_1 * s4_2;
    let izz6_inv = S::int(1) / Izz6;
    let l1 = -h_L6_in_L2_2 * izz6_inv;
    let s2 = h_L6_in_L2_2.mul_add(l1, J_J1_33);
    let h_l6_in_j4_2_l1 = h_L6_in_J4_2 * l1;
    let s3 = -S::ratio(1, 2) * J_L2_in_L1_2_ - h_l6_in_j4_2_l1;
    let s4 = -S::ratio(1, 2) * h_J3_in_L2_2 - h_l6_in_j4_2_l1;
    let s5 = (-h_L6_in_J5_2).mul_add(l1, h_J4_in_L2_2);
    let r6 = (-F_w_L1_in_L2_2).mul_add(c2, tau1) - F_w_L1_in_L2_1 * s2_2 - F_w_L6_3 * l1;
    let l7 = h_L6_in_J4_2 * izz6_inv;
    let h_l6_in_j4_2_l7 = h_L6_in_J4_2 * l7;
    let s8 = J_L2_33_2 - h_l6_in_j4_2_l7;
    let s9 = h_J3_L2_3 - h_l6_in_j4_2_l7;
    let s10 = (-h_L6_in_J5_2).mul_add(l7, -h_J4_L2_3);
    let r11 = tau2 - tau3 + w_L1_in_L2_2 * H_upper_arm_1 - w_L1_in_L2_1 * H_upper_arm_2
        + a2 * F_v_C3_1_2.mul_add(s3_2, F_v_C3_2_2 * c3) - y2 * F_v_C2_1 + F_w_J3_3
        - F_w_L6_3 * l7 - F_v_C2_2 * a2_plus_x2;
    let l12 = l7;
    let s13 = (-h_L6_in_J4_2).mul_add(l12, J_J3_33);
    let s14 = (-h_L6_in_J5_2).mul_add(l12, -h_J4_L3_2);
    let r15 = (-F_w_L6_3).mul_add(l12, F_w_J3_3);
    let l16 = h_L6_in_J5_2 * izz6_inv;
    let s17 = (-h_L6_in_J5_2).mul_add(l16, J_L4_in_J4_33);
    let r18 = (-F_w_L6_3).mul_add(l16, F_w_J4_3);
    let s17_inv = S::int(1) / s17;
    let l19 = s5 * s17_inv;
    let s20 = (-s5).mul_add(l19, s2);
    let s21 = (-s10).mul_add(l19, s3);
    let s22 = (-s14).mul_add(l19, s4);
    let r23 = (-r18).mul_add(l19, r6);
    let l24 = s10 * s17_inv;
    let s25 = (-s10).mul_add(l24, s8);
    let s26 = (-s14).mul_add(l24, s9);
    let r27 = (-r18).mul_add(l24, r11);
    let l28 = s14 * s17_inv;
    let s29 = (-s14).mul_add(l28, s13);
    let r30 = (-r18).mul_add(l28, r15);
    let s20_inv = S::int(1) / s20;
    let l31 = s21 * s20_inv;
    let s32 = (-s21).mul_add(l31, s25);
    let s33 = (-s22).mul_add(l31, s26);
    let s34 = (-h_J5_in_L2_2).mul_add(l31, h_J5_L2_3);
    let r35 = (-r23).mul_add(l31, r27);
    let l36 = s22 * s20_inv;
    let s37 = (-s22).mul_add(l36, s29);
    let s38 = (-h_J5_in_L2_2).mul_add(l36, h_J5_J3_3);
    let r39 = (-r23).mul_add(l36, r30);
    let l40 = h_J5_in_L2_2 * s20_inv;
    let s41 = (-h_J5_in_L2_2).mul_add(l40, J_L5_in_J5_33);
    let r42 = (-r23).mul_add(l40, F_w_J5_3);
    let s32_inv = S::int(1) / s32;
    let l43 = s33 * s32_inv;
    let s44 = (-s33).mul_add(l43, s37);
    let s45 = (-s34).mul_add(l43, s38);
    let r46 = (-r35).mul_add(l43, r39);
    let l47 = s34 * s32_inv;
    let s48 = (-s34).mul_add(l47, s41);
    let r49 = (-r35).mul_add(l47, r42);
    let s44_inv = S::int(1) / s44;
    let l50 = s45 * s44_inv;
    let s51 = (-s45).mul_add(l50, s48);
    let r52 = (-r46).mul_add(l50, r49);
    let u5_dot = r52 / s51;
    let u3_dot = s44_inv * (-u5_dot).mul_add(s45, r46);
    let u2_dot = s32_inv * ((-u3_dot).mul_add(s33, r35) - u5_dot * s34);
    let u1_dot = s20_inv * ((-u5_dot).mul_add(h_J5_in_L2_2, r23) - u2_dot * s21 - u3_dot * s22);
    let u4_dot = s17_inv * ((-u1_dot).mul_add(s5, r18) - u2_dot * s10 - u3_dot * s14);
    let u6_dot = izz6_inv
        * (F_w_L6_3 - u4_dot * h_L6_in_J5_2 + u1_dot * h_L6_in_L2_2
            - h_L6_in_J4_2 * (u2_dot + u3_dot));
    [u1_dot, u2_dot, u3_dot, u4_dot, u5_dot, u6_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
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
    let (s5_2, c5) = q5.sin_cos();
    let (s6, c6) = q6.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_L1_in_L2_1 = u1 * s2_2;
    let w_L1_in_L2_2 = u1 * c2;
    let w_L2_in_J3_1 = w_L1_in_L2_2.mul_add(s3_2, w_L1_in_L2_1 * c3);
    let w_L2_in_J3_2 = (-w_L1_in_L2_2).mul_add(c3, w_L1_in_L2_1 * s3_2);
    let w_J3_3 = u2 + u3;
    let w_L3_in_J4_1 = (-w_J3_3).mul_add(s4_2, w_L2_in_J3_1 * c4);
    let w_L3_in_J4_2 = w_J3_3.mul_add(c4, w_L2_in_J3_1 * s4_2);
    let w_J4_3 = u4 - w_L2_in_J3_2;
    let w_L4_in_J5_1 = w_J4_3.mul_add(s5_2, w_L3_in_J4_1 * c5);
    let w_L4_in_J5_2 = (-w_J4_3).mul_add(c5, w_L3_in_J4_1 * s5_2);
    let w_J5_3 = u5 + w_L3_in_J4_2;
    let w_L5_in_L6_1 = (-w_J5_3).mul_add(s6, w_L4_in_J5_1 * c6);
    let w_L5_in_L6_2 = w_J5_3.mul_add(c6, w_L4_in_J5_1 * s6);
    let w_L6_3 = u6 - w_L4_in_J5_2;
    let H_upper_arm_1 = Ixx2 * w_L1_in_L2_1;
    let H_upper_arm_2 = Iyy2 * w_L1_in_L2_2;
    let H_upper_arm_3 = Izz2 * u2;
    let H_forearm_1 = Ixx3 * w_L2_in_J3_1;
    let H_forearm_2 = Iyy3 * w_J3_3;
    let H_forearm_3 = Izz3 * w_L2_in_J3_2;
    let H_wrist1_1 = Ixx4 * w_L3_in_J4_1;
    let H_wrist1_2 = Iyy4 * w_J4_3;
    let H_wrist1_3 = Ixx4 * w_L3_in_J4_2;
    let H_wrist2_1 = Ixx5 * w_L4_in_J5_1;
    let H_wrist2_2 = Iyy5 * w_J5_3;
    let H_wrist2_3 = Ixx5 * w_L4_in_J5_2;
    let H_flange_1 = Ixx6 * w_L5_in_L6_1;
    let H_flange_2 = Ixx6 * w_L5_in_L6_2;
    let H_flange_3 = Izz6 * w_L6_3;
    let H_column_3 = I1 * u1;
    let v_C2_1 = (-y2).mul_add(u2, z2 * w_L1_in_L2_2);
    let a2_plus_x2 = a2 + x2;
    let v_C2_2 = (-z2).mul_add(w_L1_in_L2_1, u2 * a2_plus_x2);
    let v_C2_3 = (-y2).mul_add(w_L1_in_L2_1, w_L1_in_L2_2 * a2_plus_x2);
    let a2_u2 = a2 * u2;
    let v_L2_in_J3_1 = a2_u2 * s3_2;
    let v_L2_in_J3_2 = a2_u2 * c3;
    let v_L2_in_J3_3 = a2 * w_L1_in_L2_2;
    let v_C3_1 = d3.mul_add(w_L2_in_J3_2, -v_L2_in_J3_1);
    let v_C3_2 = (-d3).mul_add(w_L2_in_J3_1, a3 * w_J3_3) + v_L2_in_J3_2;
    let v_C3_3 = a3.mul_add(w_L2_in_J3_2, -v_L2_in_J3_3);
    let v_C3_1_2 = (-y3).mul_add(w_L2_in_J3_2, z3 * w_J3_3) + v_C3_1;
    let v_C3_2_2 = x3.mul_add(w_L2_in_J3_2, z3 * w_L2_in_J3_1) + v_C3_3;
    let v_C3_3_2 = x3.mul_add(w_J3_3, y3 * w_L2_in_J3_1) + v_C3_2;
    let v_C4_1 = d4.mul_add(w_J3_3, v_C3_1);
    let v_C4_2 = d4.mul_add(w_L2_in_J3_1, v_C3_3);
    let v_L3_in_J4_1 = v_C4_2.mul_add(s4_2, v_C4_1 * c4);
    let v_L3_in_J4_2 = (-v_C4_2).mul_add(c4, v_C4_1 * s4_2);
    let v_C4_1_2 = y4.mul_add(w_L3_in_J4_2, v_L3_in_J4_1);
    let v_C4_3 = y4.mul_add(w_L3_in_J4_1, -v_L3_in_J4_2);
    let v_L4_in_J5_1 = (-v_C3_2).mul_add(s5_2, v_L3_in_J4_1 * c5);
    let v_L4_in_J5_2 = v_L3_in_J4_1.mul_add(s5_2, v_C3_2 * c5);
    let v_L5_in_L6_1 = (-v_L3_in_J4_2).mul_add(s6, v_L4_in_J5_1 * c6);
    let v_L5_in_L6_2 = v_L4_in_J5_1.mul_add(s6, v_L3_in_J4_2 * c6);
    let v_C6_1 = z6.mul_add(w_L5_in_L6_2, v_L5_in_L6_1);
    let v_C6_2 = z6.mul_add(w_L5_in_L6_1, -v_L5_in_L6_2);
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
    let energy_of_u1 = u1.mul_add(H_column_3, w_L1_in_L2_1 * H_upper_arm_1);
    let energy_of_u2 = u2.mul_add(H_upper_arm_3, w_L1_in_L2_2 * H_upper_arm_2);
    let energy_of_place_10 = w_J3_3.mul_add(H_forearm_2, w_L2_in_J3_1 * H_forearm_1);
    let energy_of_u1_2 = m5 * v_C4_2.mul_add(v_C4_2, v_C4_1 * v_C4_1) + energy_of_u1;
    let energy_of_u2_2 = energy_of_u2 + energy_of_place_10;
    let energy_of_place_11 = energy_of_place_8 + energy_of_place_9;
    let energy_of_u1_u2 = energy_of_u1_2 + energy_of_u2_2;
    let energy_of_place_12 = energy_of_place_6 + energy_of_place_7;
    let energy_of_u1_u2_2 = energy_of_place_11 + energy_of_u1_u2;
    let energy_of_u1_u2_3 = energy_of_place_12 + energy_of_u1_u2_2;
    // Values.
    let energy = S::ratio(1, 2) * m2 * v_C2_3.mul_add(v_C2_3, v_c2_1_sq_plus_v_c2_2_sq)
        + S::ratio(1, 2) * m3 * v_C3_3_2.mul_add(v_C3_3_2, energy_of_place)
        + S::ratio(1, 2) * m6 * v_L4_in_J5_2.mul_add(v_L4_in_J5_2, v_c6_1_sq_plus_v_c6_2_sq)
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
    let (s5_2, c5) = q5.sin_cos();
    let (s6, c6) = q6.sin_cos();
    // Step by step, each after the terms that it needs.
    let a_L1_in_L2_1 = g * s2_2;
    let a_L1_in_L2_2 = g * c2;
    let mr_L6_3 = m6 * z6;
    let mr_L4_2 = m4 * y4;
    let mr_L3_1 = m3 * x3;
    let mr_L3_2 = m3 * y3;
    let mr_L2_2 = m2 * y2;
    let mr_L2_3 = m2 * z2;
    let m4_plus_m5 = m4 + m5;
    let m6_plus_m4_plus_m5 = m6 + m4_plus_m5;
    let mp_L2_1_of_m3_m4_m5_m6 = m3 + m6_plus_m4_plus_m5;
    let mp_L2_1 = m2 * (a2 + x2) + a2 * mp_L2_1_of_m3_m4_m5_m6;
    let mp_J3_1 = a3 * mp_L2_1_of_m3_m4_m5_m6;
    let mp_J3_3 = d3 * mp_L2_1_of_m3_m4_m5_m6;
    let mp_L3_3 = d4.mul_add(m6_plus_m4_plus_m5, m3 * z3);
    let x_L2_in_J3_1 = a_L1_in_L2_2.mul_add(s3_2, a_L1_in_L2_1 * c3);
    let x_L2_in_J3_2 = (-a_L1_in_L2_2).mul_add(c3, a_L1_in_L2_1 * s3_2);
    let x_L3_in_J4_1 = x_L2_in_J3_1 * c4;
    let x_L3_in_J4_2 = x_L2_in_J3_1 * s4_2;
    let x_L4_in_J5_1 = (-x_L2_in_J3_2).mul_add(s5_2, x_L3_in_J4_1 * c5);
    let x_L4_in_J5_2 = x_L3_in_J4_1.mul_add(s5_2, x_L2_in_J3_2 * c5);
    let x_L5_in_L6_1 = (-x_L3_in_J4_2).mul_add(s6, x_L4_in_J5_1 * c6);
    let x_L5_in_L6_2 = x_L4_in_J5_1.mul_add(s6, x_L3_in_J4_2 * c6);
    let x_L2_in_J3_1_2 = mp_L2_1.mul_add(c3, mr_L2_2 * s3_2);
    let x_L2_in_J3_2_2 = (-mr_L2_2).mul_add(c3, mp_L2_1 * s3_2);
    let x_L6_1 = mp_J3_1 + x_L2_in_J3_1_2;
    let x_L6_3 = mr_L2_3 + mp_J3_3;
    let x_L6_1_2 = mr_L3_1 + x_L6_1;
    let x_L6_2 = mr_L3_2 - x_L6_3;
    let x_L6_3_2 = mp_L3_3 - x_L2_in_J3_2_2;
    let x_L3_in_J4_1_2 = x_L6_2.mul_add(s4_2, x_L6_1_2 * c4);
    let x_L3_in_J4_2_2 = (-x_L6_2).mul_add(c4, x_L6_1_2 * s4_2);
    let x_L6_2_2 = mr_L4_2 + x_L6_3_2;
    let x_L4_in_J5_1_2 = x_L6_2_2.mul_add(s5_2, x_L3_in_J4_1_2 * c5);
    let x_L4_in_J5_2_2 = (-x_L6_2_2).mul_add(c5, x_L3_in_J4_1_2 * s5_2);
    let x_L5_in_L6_1_2 = (-x_L3_in_J4_2_2).mul_add(s6, x_L4_in_J5_1_2 * c6);
    let x_L5_in_L6_2_2 = x_L4_in_J5_1_2.mul_add(s6, x_L3_in_J4_2_2 * c6);
    let x_L6_3_3 = mr_L6_3 - x_L4_in_J5_2_2;
    // Values.
    let energy = x_L5_in_L6_2.mul_add(x_L5_in_L6_2_2, x_L5_in_L6_1 * x_L5_in_L6_1_2)
        - x_L4_in_J5_2 * x_L6_3_3;
    energy
}

/// The power of the loads that have no potential: the rate of T + V.
///
/// 11 operations.
#[must_use]
pub fn power<S: Scalar>(p: &Parameters<S>, _q: &[S; 6], u: &[S; 6]) -> S {
    let Parameters { tau1, tau2, tau3, tau4, tau5, tau6, .. } = *p;
    let [u1, u2, u3, u4, u5, u6] = *u;
    // Values.
    // d(T + V)/dt = u1*tau1 + u2*tau2 + u3*tau3 + u4*tau4 + u5*tau5 + u6*tau6
    let rate = u2.mul_add(tau2, u1 * tau1) + u3 * tau3 + u4 * tau4 + u5 * tau5 + u6 * tau6;
    rate
}

/// Inverse dynamics: the generalized forces along (u1, u2, u3, u4, u5, u6) that must act beside the loads of the model for the accelerations to be (u1', u2', u3', u4', u5', u6').
///
/// 457 operations, 5 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    u: &[S; 6],
    v_dot: &[S; 6],
) -> [S; 6] {
    let Parameters {
        g, a2, a3, d3, d4, m2, m3, m4, m5, m6, x2, y2, z2, x3, y3, z3, y4, z6, I1, Ixx2, Iyy2, Izz2,
        Ixx3, Iyy3, Izz3, Ixx4, Iyy4, Ixx5, Iyy5, Ixx6, Izz6, tau1, tau2, tau3, tau4, tau5, tau6,
        ..
    } = *p;
    let [_, q2, q3, q4, q5, q6] = *q;
    let [u1, u2, u3, u4, u5, u6] = *u;
    let [u1_dot, u2_dot, u3_dot, u4_dot, u5_dot, u6_dot] = *v_dot;
    // Sines and cosines.
    let (s2_2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    let (s4_2, c4) = q4.sin_cos();
    let (s5_2, c5) = q5.sin_cos();
    let (s6, c6) = q6.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_L1_in_L2_1 = u1 * s2_2;
    let w_L1_in_L2_2 = u1 * c2;
    let w_L2_in_J3_1 = w_L1_in_L2_2.mul_add(s3_2, w_L1_in_L2_1 * c3);
    let w_L2_in_J3_2 = (-w_L1_in_L2_2).mul_add(c3, w_L1_in_L2_1 * s3_2);
    let w_J3_3 = u2 + u3;
    let w_L3_in_J4_1 = (-w_J3_3).mul_add(s4_2, w_L2_in_J3_1 * c4);
    let w_L3_in_J4_2 = w_J3_3.mul_add(c4, w_L2_in_J3_1 * s4_2);
    let w_J4_3 = u4 - w_L2_in_J3_2;
    let w_L4_in_J5_1 = w_J4_3.mul_add(s5_2, w_L3_in_J4_1 * c5);
    let w_L4_in_J5_2 = (-w_J4_3).mul_add(c5, w_L3_in_J4_1 * s5_2);
    let w_J5_3 = u5 + w_L3_in_J4_2;
    let w_L5_in_L6_1 = (-w_J5_3).mul_add(s6, w_L4_in_J5_1 * c6);
    let w_L5_in_L6_2 = w_J5_3.mul_add(c6, w_L4_in_J5_1 * s6);
    let w_L6_3 = u6 - w_L4_in_J5_2;
    let alpha_L2_1 = u2 * w_L1_in_L2_2;
    let alpha_L2_2 = u2 * w_L1_in_L2_1;
    let w_L2_11 = w_L1_in_L2_1 * w_L1_in_L2_1;
    let w_L2_12 = w_L1_in_L2_1 * w_L1_in_L2_2;
    let w_L2_22 = w_L1_in_L2_2 * w_L1_in_L2_2;
    let w_L2_33 = u2 * u2;
    let turn_L2_11 = w_L2_22 + w_L2_33;
    let turn_L2_22 = w_L2_11 + w_L2_33;
    let turn_L2_33 = w_L2_11 + w_L2_22;
    let w_J3_11 = w_L2_in_J3_1 * w_L2_in_J3_1;
    let w_J3_12 = w_L2_in_J3_1 * w_L2_in_J3_2;
    let w_J3_13 = w_L2_in_J3_1 * w_J3_3;
    let w_J3_22 = w_L2_in_J3_2 * w_L2_in_J3_2;
    let w_J3_23 = w_L2_in_J3_2 * w_J3_3;
    let w_J3_33 = w_J3_3 * w_J3_3;
    let turn_J3_11 = w_J3_22 + w_J3_33;
    let turn_J3_22 = w_J3_11 + w_J3_33;
    let turn_J3_33 = w_J3_11 + w_J3_22;
    let w_L4_11 = w_L3_in_J4_1 * w_L3_in_J4_1;
    let w_L4_12 = w_L3_in_J4_1 * w_J4_3;
    let w_L4_23 = w_L3_in_J4_2 * w_J4_3;
    let w_L4_33 = w_L3_in_J4_2 * w_L3_in_J4_2;
    let turn_L4_22 = w_L4_11 + w_L4_33;
    let w_L6_11 = w_L5_in_L6_1 * w_L5_in_L6_1;
    let w_L6_13 = w_L5_in_L6_1 * w_L6_3;
    let w_L6_22 = w_L5_in_L6_2 * w_L5_in_L6_2;
    let w_L6_23 = w_L5_in_L6_2 * w_L6_3;
    let turn_L6_33 = w_L6_11 + w_L6_22;
    let a_L1_in_L2_1 = g * s2_2;
    let a_L1_in_L2_2 = g * c2;
    let H_upper_arm_1 = Ixx2 * w_L1_in_L2_1;
    let H_upper_arm_2 = Iyy2 * w_L1_in_L2_2;
    let H_upper_arm_3 = Izz2 * u2;
    let a_C3_1 = a2.mul_add(turn_L2_11, -a_L1_in_L2_1);
    let H_forearm_1 = Ixx3 * w_L2_in_J3_1;
    let H_forearm_2 = Iyy3 * w_J3_3;
    let H_forearm_3 = Izz3 * w_L2_in_J3_2;
    let H_wrist1_1 = Ixx4 * w_L3_in_J4_1;
    let H_wrist1_2 = Iyy4 * w_J4_3;
    let H_wrist1_3 = Ixx4 * w_L3_in_J4_2;
    let H_wrist2_1 = Ixx5 * w_L4_in_J5_1;
    let H_wrist2_2 = Iyy5 * w_J5_3;
    let H_wrist2_3 = Ixx5 * w_L4_in_J5_2;
    let H_flange_1 = Ixx6 * w_L5_in_L6_1;
    let H_flange_2 = Ixx6 * w_L5_in_L6_2;
    let H_flange_3 = Izz6 * w_L6_3;
    let alpha_L1_in_L2_1 = u1_dot * s2_2;
    let alpha_L1_in_L2_2 = u1_dot * c2;
    let alpha_L2_1_2 = alpha_L2_1 + alpha_L1_in_L2_1;
    let alpha_L2_2_2 = alpha_L2_2 - alpha_L1_in_L2_2;
    let turn_L2_12 = u2_dot - w_L2_12;
    let turn_L2_13 = alpha_L2_2 - alpha_L2_2_2;
    let turn_L2_21 = u2_dot + w_L2_12;
    let turn_L2_23 = alpha_L2_1 - alpha_L2_1_2;
    let turn_L2_31 = alpha_L2_2 + alpha_L2_2_2;
    let turn_L2_32 = alpha_L2_1 + alpha_L2_1_2;
    let alpha_L2_in_J3_1_2 = (-alpha_L2_2_2).mul_add(s3_2, alpha_L2_1_2 * c3);
    let alpha_L2_in_J3_2_2 = alpha_L2_2_2.mul_add(c3, alpha_L2_1_2 * s3_2);
    let alpha_J3_1_2 = u3.mul_add(w_L2_in_J3_2, -alpha_L2_in_J3_1_2);
    let alpha_J3_2_2 = u3.mul_add(w_L2_in_J3_1, alpha_L2_in_J3_2_2);
    let alpha_J3_3 = u2_dot + u3_dot;
    let turn_J3_12 = w_J3_12 + alpha_J3_3;
    let turn_J3_13_2 = w_J3_13 - alpha_J3_2_2;
    let turn_J3_21 = w_J3_12 - alpha_J3_3;
    let turn_J3_23_2 = w_J3_23 - alpha_J3_1_2;
    let turn_J3_31_2 = w_J3_13 + alpha_J3_2_2;
    let turn_J3_32_2 = w_J3_23 + alpha_J3_1_2;
    let alpha_L3_in_J4_1_2 = alpha_J3_3.mul_add(s4_2, alpha_J3_1_2 * c4);
    let alpha_L3_in_J4_2_2 = (-alpha_J3_3).mul_add(c4, alpha_J3_1_2 * s4_2);
    let alpha_L4_1_2 = u4.mul_add(w_L3_in_J4_2, alpha_L3_in_J4_1_2);
    let alpha_L4_2_2 = u4.mul_add(w_L3_in_J4_1, -alpha_L3_in_J4_2_2);
    let alpha_L4_3 = u4_dot - alpha_J3_2_2;
    let turn_L4_12_2 = w_L4_12 - alpha_L4_2_2;
    let turn_L4_32_2 = w_L4_23 - alpha_L4_1_2;
    let alpha_L4_in_J5_1_2 = (-alpha_L4_3).mul_add(s5_2, alpha_L4_1_2 * c5);
    let alpha_L4_in_J5_2_2 = alpha_L4_3.mul_add(c5, alpha_L4_1_2 * s5_2);
    let alpha_L6_1_3 = u5.mul_add(w_L4_in_J5_2, alpha_L4_in_J5_1_2);
    let alpha_L6_2_3 = u5.mul_add(w_L4_in_J5_1, -alpha_L4_in_J5_2_2);
    let alpha_L6_3 = u5_dot + alpha_L4_2_2;
    let alpha_L5_in_L6_1_2 = alpha_L6_3.mul_add(s6, alpha_L6_1_3 * c6);
    let alpha_L5_in_L6_2_2 = (-alpha_L6_3).mul_add(c6, alpha_L6_1_3 * s6);
    let alpha_L6_1_4 = u6.mul_add(w_L5_in_L6_2, alpha_L5_in_L6_1_2);
    let alpha_L6_2_4 = u6.mul_add(w_L5_in_L6_1, -alpha_L5_in_L6_2_2);
    let alpha_L6_3_2 = u6_dot - alpha_L6_2_3;
    let turn_L6_13_2 = w_L6_13 - alpha_L6_2_4;
    let turn_L6_23_2 = w_L6_23 - alpha_L6_1_4;
    let a2_plus_x2 = a2 + x2;
    let a_C2_1_2 = y2.mul_add(turn_L2_12, -a_L1_in_L2_1) - z2 * turn_L2_13
        + turn_L2_11 * a2_plus_x2;
    let a_C2_2_2 = y2.mul_add(turn_L2_22, -a_L1_in_L2_2) - z2 * turn_L2_23
        - turn_L2_21 * a2_plus_x2;
    let a_C2_3_2 = (-y2).mul_add(turn_L2_32, z2 * turn_L2_33) - turn_L2_31 * a2_plus_x2;
    let a_C3_2_4 = a2.mul_add(turn_L2_21, a_L1_in_L2_2);
    let a_C3_3_4 = a2 * turn_L2_31;
    let a_L2_in_J3_1_2 = (-a_C3_2_4).mul_add(s3_2, a_C3_1 * c3);
    let a_L2_in_J3_2_2 = a_C3_2_4.mul_add(c3, a_C3_1 * s3_2);
    let a_C3_1_4 = (-d3).mul_add(turn_J3_13_2, a3 * turn_J3_11) + a_L2_in_J3_1_2;
    let a_C3_2_5 = d3.mul_add(turn_J3_23_2, a3 * turn_J3_21) - a_L2_in_J3_2_2;
    let a_C3_3_5 = (-a3).mul_add(turn_J3_31_2, d3 * turn_J3_33) - a_C3_3_4;
    let a_C3_1_5 = z3.mul_add(turn_J3_12, x3 * turn_J3_11) + y3 * turn_J3_13_2 + a_C3_1_4;
    let a_C3_2_6 = x3.mul_add(turn_J3_31_2, y3 * turn_J3_33) - z3 * turn_J3_32_2 - a_C3_3_5;
    let a_C3_3_6 = x3.mul_add(turn_J3_21, z3 * turn_J3_22) - y3 * turn_J3_23_2 + a_C3_2_5;
    let a_C4_1_3 = d4.mul_add(turn_J3_12, a_C3_1_4);
    let a_C4_2_3 = d4.mul_add(turn_J3_32_2, a_C3_3_5);
    let a_C4_3_3 = d4.mul_add(turn_J3_22, a_C3_2_5);
    let a_L3_in_J4_1_2 = (-a_C4_2_3).mul_add(s4_2, a_C4_1_3 * c4);
    let a_L3_in_J4_2_2 = a_C4_2_3.mul_add(c4, a_C4_1_3 * s4_2);
    let a_C4_1_4 = y4.mul_add(turn_L4_12_2, -a_L3_in_J4_1_2);
    let a_C4_2_4 = y4.mul_add(turn_L4_22, a_C4_3_3);
    let a_C4_3_4 = y4.mul_add(turn_L4_32_2, -a_L3_in_J4_2_2);
    let a_L4_in_J5_1_2 = a_L3_in_J4_1_2.mul_add(c5, a_C4_3_3 * s5_2);
    let a_L4_in_J5_2_2 = (-a_C4_3_3).mul_add(c5, a_L3_in_J4_1_2 * s5_2);
    let a_L5_in_L6_1_2 = (-a_L3_in_J4_2_2).mul_add(s6, a_L4_in_J5_1_2 * c6);
    let a_L5_in_L6_2_2 = a_L4_in_J5_1_2.mul_add(s6, a_L3_in_J4_2_2 * c6);
    let a_C6_1_2 = z6.mul_add(turn_L6_13_2, -a_L5_in_L6_1_2);
    let a_C6_2_2 = z6.mul_add(turn_L6_23_2, -a_L5_in_L6_2_2);
    let a_C6_3_2 = z6.mul_add(turn_L6_33, -a_L4_in_J5_2_2);
    let F_v_C6_2_2 = m6 * a_C6_2_2;
    let F_v_C6_1_2 = m6 * a_C6_1_2;
    let F_v_L4_in_J5_2_2 = m6 * a_C6_3_2;
    let F_v_L4_in_J5_1_2 = F_v_C6_1_2.mul_add(c6, F_v_C6_2_2 * s6);
    let F_v_C4_3_2 = m4 * a_C4_3_4;
    let F_v_C4_1_3 = m4 * a_C4_1_4;
    let F_v_L3_in_J4_2_2 = (-F_v_C6_1_2).mul_add(s6, F_v_C6_2_2 * c6) + F_v_C4_3_2;
    let F_v_L3_in_J4_1_2 = F_v_L4_in_J5_1_2.mul_add(c5, F_v_L4_in_J5_2_2 * s5_2) + F_v_C4_1_3;
    let F_v_C4_2_2 = (-F_v_L3_in_J4_2_2).mul_add(c4, m5 * a_C4_2_3) + F_v_L3_in_J4_1_2 * s4_2;
    let F_v_C4_1_4 = (-F_v_L3_in_J4_2_2).mul_add(s4_2, m5 * a_C4_1_3) - F_v_L3_in_J4_1_2 * c4;
    let F_v_C3_3_3 = m3 * a_C3_3_6;
    let F_v_C3_2_3 = m3 * a_C3_2_6;
    let F_v_C3_1_3 = m3 * a_C3_1_5;
    let F_v_C3_3_4 = F_v_C4_2_2 - F_v_C3_2_3;
    let F_v_C3_2_4 = m4.mul_add(a_C4_2_4, m5 * a_C4_3_3) + F_v_L4_in_J5_2_2 * c5
        - F_v_L4_in_J5_1_2 * s5_2 + F_v_C3_3_3;
    let F_v_C3_1_4 = F_v_C4_1_4 + F_v_C3_1_3;
    let F_v_C2_3_2 = m2 * a_C2_3_2;
    let F_v_C2_2_2 = m2 * a_C2_2_2;
    let F_v_C2_1_2 = m2 * a_C2_1_2;
    let F_w_L6_3_2 = (-w_L5_in_L6_2).mul_add(H_flange_1, tau6)
        + w_L5_in_L6_1 * H_flange_2 - Izz6 * alpha_L6_3_2;
    let F_w_L5_in_L6_2_2 = (-w_L5_in_L6_1).mul_add(H_flange_3, w_L6_3 * H_flange_1)
        - Ixx6 * alpha_L6_2_4 + z6 * F_v_C6_1_2;
    let F_w_L5_in_L6_1_2 = (-w_L6_3).mul_add(H_flange_2, w_L5_in_L6_2 * H_flange_3)
        + Ixx6 * alpha_L6_1_4 - z6 * F_v_C6_2_2;
    let F_w_J5_3_2 = (-w_L4_in_J5_2).mul_add(H_wrist2_1, tau5)
        + w_L4_in_J5_1 * H_wrist2_3 - Iyy5 * alpha_L6_3 + F_w_L5_in_L6_2_2 * c6
        - F_w_L5_in_L6_1_2 * s6;
    let F_w_L4_in_J5_2_2 = w_J5_3.mul_add(H_wrist2_1, tau6) - w_L4_in_J5_1 * H_wrist2_2
        - Ixx5 * alpha_L6_2_3 - F_w_L6_3_2;
    let F_w_L4_in_J5_1_2 = (-w_L4_in_J5_2).mul_add(H_wrist2_2, w_J5_3 * H_wrist2_3)
        - Ixx5 * alpha_L6_1_3 - F_w_L5_in_L6_2_2 * s6 - F_w_L5_in_L6_1_2 * c6;
    let F_w_J4_3_2 = (-w_L3_in_J4_2).mul_add(H_wrist1_1, tau4)
        + w_L3_in_J4_1 * H_wrist1_3 - Iyy4 * alpha_L4_3 - F_w_L4_in_J5_2_2 * c5
        - F_w_L4_in_J5_1_2 * s5_2;
    let F_w_L3_in_J4_2_2 = (-w_J4_3).mul_add(H_wrist1_1, tau5)
        + w_L3_in_J4_1 * H_wrist1_2 + Ixx4 * alpha_L4_2_2 - y4 * F_v_C4_1_3 - F_w_J5_3_2;
    let F_w_L3_in_J4_1_2 = (-w_L3_in_J4_2).mul_add(H_wrist1_2, w_J4_3 * H_wrist1_3)
        - Ixx4 * alpha_L4_1_2 + y4 * F_v_C4_3_2 - F_w_L4_in_J5_2_2 * s5_2 + F_w_L4_in_J5_1_2 * c5;
    let F_w_L2_in_J3_2_2 = w_J3_3.mul_add(H_forearm_1, tau4) - w_L2_in_J3_1 * H_forearm_2
        - Izz3 * alpha_J3_2_2 - x3 * F_v_C3_2_3 + y3 * F_v_C3_1_3 + a3 * F_v_C3_3_4
        - d3 * F_v_C3_1_4 - F_w_J4_3_2;
    let F_w_L2_in_J3_1_2 = (-w_L2_in_J3_2).mul_add(H_forearm_2, w_J3_3 * H_forearm_3)
        - Ixx3 * alpha_J3_1_2 - d4 * F_v_C4_2_2 - y3 * F_v_C3_3_3 + z3 * F_v_C3_2_3
        + d3 * F_v_C3_2_4 + F_w_L3_in_J4_2_2 * s4_2 + F_w_L3_in_J4_1_2 * c4;
    let F_w_L1_in_L2_2_2 = (-w_L1_in_L2_1).mul_add(H_upper_arm_3, u2 * H_upper_arm_1)
        - Iyy2 * alpha_L2_2_2 + a2 * F_v_C3_3_4 - z2 * F_v_C2_1_2 + F_w_L2_in_J3_2_2 * c3
        + F_w_L2_in_J3_1_2 * s3_2 + F_v_C2_3_2 * a2_plus_x2;
    let F_w_L1_in_L2_1_2 = (-u2).mul_add(H_upper_arm_2, w_L1_in_L2_2 * H_upper_arm_3)
        + Ixx2 * alpha_L2_1_2 - y2 * F_v_C2_3_2 + z2 * F_v_C2_2_2
        - F_w_L2_in_J3_2_2 * s3_2 + F_w_L2_in_J3_1_2 * c3;
    let F_w_J3_3_2 = (-w_L2_in_J3_2).mul_add(H_forearm_1, tau3)
        + w_L2_in_J3_1 * H_forearm_3 - Iyy3 * alpha_J3_3 - d4 * F_v_C4_1_4
        + x3 * F_v_C3_3_3 - z3 * F_v_C3_1_3 + a3 * F_v_C3_2_4 - F_w_L3_in_J4_2_2 * c4
        + F_w_L3_in_J4_1_2 * s4_2;
    // Values.
    let tau1_2 = I1.mul_add(u1_dot, -tau1) + F_w_L1_in_L2_2_2 * c2 + F_w_L1_in_L2_1_2 * s2_2;
    let tau2_2 = tau3 - tau2 + Izz2 * u2_dot - w_L1_in_L2_2 * H_upper_arm_1
        + w_L1_in_L2_1 * H_upper_arm_2 - a2 * F_v_C3_1_4.mul_add(s3_2, F_v_C3_2_4 * c3)
        + y2 * F_v_C2_1_2 - F_w_J3_3_2 - F_v_C2_2_2 * a2_plus_x2;
    let tau3_2 = -F_w_J3_3_2;
    let tau4_2 = -F_w_J4_3_2;
    let tau5_2 = -F_w_J5_3_2;
    let tau6_2 = -F_w_L6_3_2;
    [tau1_2, tau2_2, tau3_2, tau4_2, tau5_2, tau6_2]
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

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
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
