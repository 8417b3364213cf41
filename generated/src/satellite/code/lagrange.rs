//! Satellite with a reaction wheel: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/satellite/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows e0, e1, e2, e3, phi, constraint S_norm.
///
/// 172 operations, 1 other function.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _q_dot: &[S; 5],
) -> [[S; 6]; 6] {
    let Parameters { A, B, C, J, K, .. } = *p;
    let [e0, e1, e2, e3, _] = *q;
    // Shared terms.
    // e2 + e3
    let e2_plus_e3 = e2 + e3;
    let e3_sq = e3 * e3;
    let e0_sq = e0 * e0;
    let e1_sq = e1 * e1;
    let e2_sq = e2 * e2;
    // 1/(e3_sq + e0_sq + e1_sq + e2_sq)
    let m11_of_e0_e1_e2_e3 = S::int(1) / (e3_sq + e0_sq + e1_sq + e2_sq);
    let m11_of_e0_e1_e2_e3_sq = m11_of_e0_e1_e2_e3 * m11_of_e0_e1_e2_e3;
    // J - K
    let j_minus_k = J - K;
    let m11_of_place = S::ratio(8, 3) * m11_of_e0_e1_e2_e3_sq * j_minus_k;
    let m11_of_e0_e1_e2_e3_2 = S::int(4) * m11_of_e0_e1_e2_e3_sq;
    let m11_of_e0_e1_e2_e3_3 = S::ratio(4, 3) * m11_of_e0_e1_e2_e3_sq;
    // m11_of_e0_e1_e2_e3_3*(J + 2*K)
    let m11_of_place_2 = m11_of_e0_e1_e2_e3_3 * K.mul_add(S::int(2), J);
    // C*m11_of_e0_e1_e2_e3_2 + m11_of_place_2
    let m11_of_place_3 = C.mul_add(m11_of_e0_e1_e2_e3_2, m11_of_place_2);
    // A*m11_of_e0_e1_e2_e3_2 + m11_of_place_2
    let m11_of_place_4 = A.mul_add(m11_of_e0_e1_e2_e3_2, m11_of_place_2);
    // B*m11_of_e0_e1_e2_e3_2 + m11_of_place_2
    let m11_of_place_5 = B.mul_add(m11_of_e0_e1_e2_e3_2, m11_of_place_2);
    let e2_e3 = e2 * e3;
    let m11_of_place_e2_e3 = m11_of_place * e2_e3;
    let m12_of_place = j_minus_k * m11_of_e0_e1_e2_e3_3;
    // B - C
    let b_minus_c = B - C;
    let e0_m12_of_place = e0 * m12_of_place;
    // e2 - e3
    let e2_minus_e3 = e2 - e3;
    let e1_m12_of_place = e1 * m12_of_place;
    let e0_e1 = e0 * e1;
    // e2_minus_e3*e1_m12_of_place + m11_of_place_4*e0_e1
    let m12_of_place_2 = m11_of_place_4.mul_add(e0_e1, e2_minus_e3 * e1_m12_of_place);
    // e2*(e2*m12_of_place - e3*m11_of_e0_e1_e2_e3_2*b_minus_c) + e2_plus_e3*e0_m12_of_place
    let m12_of_place_3 = e2 * (-(e3 * m11_of_e0_e1_e2_e3_2)).mul_add(b_minus_c, e2 * m12_of_place)
        + e2_plus_e3 * e0_m12_of_place;
    // e3_sq*m12_of_place - m12_of_place_2
    let m12_of_place_4 = e3_sq.mul_add(m12_of_place, -m12_of_place_2);
    // m12_of_place_3 - m12_of_place_4
    let m12_of_place_5 = m12_of_place_3 - m12_of_place_4;
    let e1_m11_of_e0_e1_e2_e3_2 = e1 * m11_of_e0_e1_e2_e3_2;
    // e2_plus_e3*m12_of_place + A*e1_m11_of_e0_e1_e2_e3_2
    let m13_of_place = A.mul_add(e1_m11_of_e0_e1_e2_e3_2, e2_plus_e3 * m12_of_place);
    // e0 - e1
    let e0_minus_e1 = e0 - e1;
    // e2*e1_m12_of_place - e3*e0_m12_of_place
    let m13_of_place_2 = (-e3).mul_add(e0_m12_of_place, e2 * e1_m12_of_place);
    // e0*e2*m11_of_place_5 - C*e3*e1_m11_of_e0_e1_e2_e3_2
    let m13_of_place_3 = (-(C * e3))
        .mul_add(e1_m11_of_e0_e1_e2_e3_2, e0 * e2 * m11_of_place_5);
    // e3*m13_of_place + e1_m12_of_place*e0_minus_e1
    let m13_of_place_4 = e1_m12_of_place.mul_add(e0_minus_e1, e3 * m13_of_place);
    // m13_of_place_2 - m13_of_place_3
    let m13_of_place_5 = m13_of_place_2 - m13_of_place_3;
    // m13_of_place_4 - m13_of_place_5
    let m13_of_place_6 = m13_of_place_4 - m13_of_place_5;
    // e0 + e1
    let e0_plus_e1 = e0 + e1;
    // e2*e0_m12_of_place + e3*e1_m12_of_place
    let m14_of_place = e3.mul_add(e1_m12_of_place, e2 * e0_m12_of_place);
    // e0*e3*m11_of_place_3 + B*e2*e1_m11_of_e0_e1_e2_e3_2
    let m14_of_place_2 = (B * e2)
        .mul_add(e1_m11_of_e0_e1_e2_e3_2, e0 * e3 * m11_of_place_3);
    // e2*m13_of_place - e1_m12_of_place*e0_plus_e1
    let m14_of_place_3 = (-e1_m12_of_place).mul_add(e0_plus_e1, e2 * m13_of_place);
    // m14_of_place + m14_of_place_2
    let m14_of_place_4 = m14_of_place + m14_of_place_2;
    // m14_of_place_3 - m14_of_place_4
    let m14_of_place_5 = m14_of_place_3 - m14_of_place_4;
    let m15_of_place = S::ratio(2, 3) * J * m11_of_e0_e1_e2_e3 * (S::int(3)).sqrt();
    // m15_of_place*(e1 + e2_plus_e3)
    let m15_of_place_2 = m15_of_place * (e1 + e2_plus_e3);
    let e0_doubled = S::int(2) * e0;
    let e0_m11_of_e0_e1_e2_e3_2 = e0 * m11_of_e0_e1_e2_e3_2;
    // m12_of_place*e2_minus_e3 + A*e0_m11_of_e0_e1_e2_e3_2
    let m23_of_place = A.mul_add(e0_m11_of_e0_e1_e2_e3_2, m12_of_place * e2_minus_e3);
    // e1*e2*m11_of_place_3 + B*e3*e0_m11_of_e0_e1_e2_e3_2
    let m23_of_place_2 = (B * e3)
        .mul_add(e0_m11_of_e0_e1_e2_e3_2, e1 * e2 * m11_of_place_3);
    // e0_m12_of_place*e0_minus_e1 + e3*m23_of_place
    let m23_of_place_3 = e3.mul_add(m23_of_place, e0_m12_of_place * e0_minus_e1);
    // m14_of_place - m23_of_place_2
    let m23_of_place_4 = m14_of_place - m23_of_place_2;
    // m23_of_place_3 + m23_of_place_4
    let m23_of_place_5 = m23_of_place_3 + m23_of_place_4;
    // C*e2*e0_m11_of_e0_e1_e2_e3_2 - e1*e3*m11_of_place_5
    let m24_of_place = (-(e1 * e3))
        .mul_add(m11_of_place_5, C * e2 * e0_m11_of_e0_e1_e2_e3_2);
    // e2*m23_of_place - e0_m12_of_place*e0_plus_e1
    let m24_of_place_2 = (-e0_m12_of_place).mul_add(e0_plus_e1, e2 * m23_of_place);
    // m13_of_place_2 + m24_of_place
    let m24_of_place_3 = m13_of_place_2 + m24_of_place;
    // m24_of_place_2 - m24_of_place_3
    let m24_of_place_4 = m24_of_place_2 - m24_of_place_3;
    // m15_of_place*(e0 + e2_minus_e3)
    let m25_of_place = m15_of_place * (e0 + e2_minus_e3);
    let e1_doubled = S::int(2) * e1;
    let m11_of_place_e0_e1 = m11_of_place * e0_e1;
    // e0*b_minus_c*e1_m11_of_e0_e1_e2_e3_2 - m11_of_place_4*e2_e3
    let m34_of_place = (-m11_of_place_4)
        .mul_add(e2_e3, e0 * b_minus_c * e1_m11_of_e0_e1_e2_e3_2);
    // e0_m12_of_place*(e2_minus_e3 - e0) + e1_m12_of_place*(e1 - e2_plus_e3)
    let m34_of_place_2 = e0_m12_of_place * (e2_minus_e3 - e0) + e1_m12_of_place * (e1 - e2_plus_e3);
    // m34_of_place - m34_of_place_2
    let m34_of_place_3 = m34_of_place - m34_of_place_2;
    // m15_of_place*(e3 + e0_minus_e1)
    let m35_of_place = m15_of_place * (e3 + e0_minus_e1);
    let e2_doubled = S::int(2) * e2;
    // m15_of_place*(e2 - e0_plus_e1)
    let m45_of_place = m15_of_place * (e2 - e0_plus_e1);
    let e3_doubled = S::int(2) * e3;
    // -m12_of_place_5
    let minus_m12_of_place_5 = -m12_of_place_5;
    // -m13_of_place_6
    let minus_m13_of_place_6 = -m13_of_place_6;
    // -m15_of_place_2
    let minus_m15_of_place_2 = -m15_of_place_2;
    // -m24_of_place_4
    let minus_m24_of_place_4 = -m24_of_place_4;
    // -m45_of_place
    let minus_m45_of_place = -m45_of_place;
    // Entries that are not zero.
    // M11 = 4*(e3^2*(3*C + J + 2*K) + e1*(3*A*e1 + J*(e1 + 2*e2 + 2*e3) + 2*K*(e1 - e2 - e3)) +
    //   e2*(e2*(3*B + J + 2*K) + 2*e3*(J - K)))/(3*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let m11 = e3_sq.mul_add(m11_of_place_3, e1 * e2_plus_e3 * m11_of_place)
        + e1_sq * m11_of_place_4 + e2_sq * m11_of_place_5 + m11_of_place_e2_e3;
    // M12 = -4*(e0*e1*(3*A + J + 2*K) + e2*(J*(e0 + e1 + e2) - K*(e0 + e1 + e2) + 3*e3*(C - B)) +
    //   e3*(J*(e0 - e1 - e3) + K*(e1 - e0 + e3)))/(3*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let m12 = minus_m12_of_place_5;
    // M13 = -4*(e0*e2*(3*B + J + 2*K) + e1*(J*(e0 - e1 - e2) + K*(e1 - e0 + e2) + 3*e3*(A - C)) +
    //   e3*(J*(e0 + e2 + e3) - K*(e0 + e2 + e3)))/(3*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let m13 = minus_m13_of_place_6;
    // M14 = -4*(e0*e3*(3*C + J + 2*K) + e1*(3*e2*(B - A) + J*(e0 + e1 + e3) - K*(e0 + e1 + e3)) +
    //   e2*(J*(e0 - e2 - e3) + K*(e2 - e0 + e3)))/(3*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let m14 = m14_of_place_5;
    // M15 = -2*J*sqrt(3)*(e1 + e2 + e3)/(3*(e0^2 + e1^2 + e2^2 + e3^2))
    let m15 = minus_m15_of_place_2;
    // M16 = -2*e0
    let m16 = -e0_doubled;
    // M21 = -4*(e0*e1*(3*A + J + 2*K) + e2*(J*(e0 + e1 + e2) - K*(e0 + e1 + e2) + 3*e3*(C - B)) +
    //   e3*(J*(e0 - e1 - e3) + K*(e1 - e0 + e3)))/(3*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let m21 = minus_m12_of_place_5;
    // M22 = 4*(e3^2*(3*B + J + 2*K) + e0*(3*A*e0 + J*(e0 + 2*e2 - 2*e3) + 2*K*(e0 - e2 + e3)) +
    //   e2*(e2*(3*C + J + 2*K) - 2*e3*(J - K)))/(3*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let m22 = e0_sq.mul_add(m11_of_place_4, e2_sq * m11_of_place_3)
        + e3_sq * m11_of_place_5 - m11_of_place_e2_e3 + e0 * m11_of_place * e2_minus_e3;
    // M23 = 4*(e0*(J*(e0 - e1 + e2) + K*(e1 - e0 - e2) + 3*e3*(A - B)) - e1*e2*(3*C + J + 2*K) + e3*(J*(e1
    //   + e2 - e3) + K*(e3 - e1 - e2)))/(3*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let m23 = m23_of_place_5;
    // M24 = 4*(e0*(3*e2*(C - A) + J*(e0 + e1 - e3) + K*(e3 - e0 - e1)) - e1*e3*(3*B + J + 2*K) + e2*(J*(e1
    //   - e2 + e3) + K*(e2 - e1 - e3)))/(3*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let m24 = minus_m24_of_place_4;
    // M25 = 2*J*sqrt(3)*(e0 + e2 - e3)/(3*(e0^2 + e1^2 + e2^2 + e3^2))
    let m25 = m25_of_place;
    // M26 = -2*e1
    let m26 = -e1_doubled;
    // M31 = -4*(e0*e2*(3*B + J + 2*K) + e1*(J*(e0 - e1 - e2) + K*(e1 - e0 + e2) + 3*e3*(A - C)) +
    //   e3*(J*(e0 + e2 + e3) - K*(e0 + e2 + e3)))/(3*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let m31 = minus_m13_of_place_6;
    // M32 = 4*(e0*(J*(e0 - e1 + e2) + K*(e1 - e0 - e2) + 3*e3*(A - B)) - e1*e2*(3*C + J + 2*K) + e3*(J*(e1
    //   + e2 - e3) + K*(e3 - e1 - e2)))/(3*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let m32 = m23_of_place_5;
    // M33 = 4*(e3^2*(3*A + J + 2*K) + e0*(3*B*e0 + 2*K*(e0 + e1 - e3) + J*(e0 - 2*e1 + 2*e3)) +
    //   e1*(e1*(3*C + J + 2*K) - 2*e3*(J - K)))/(3*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let m33 = e3_sq.mul_add(m11_of_place_4, e1_sq * m11_of_place_3)
        + e0_sq * m11_of_place_5 + e3 * m11_of_place * e0_minus_e1 - m11_of_place_e0_e1;
    // M34 = 4*(e1*(J*(e2 - e1 + e3) + K*(e1 - e2 - e3)) - e2*e3*(3*A + J + 2*K) - e0*(3*e1*(C - B) + J*(e2
    //   - e0 - e3) + K*(e0 - e2 + e3)))/(3*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let m34 = m34_of_place_3;
    // M35 = 2*J*sqrt(3)*(e0 - e1 + e3)/(3*(e0^2 + e1^2 + e2^2 + e3^2))
    let m35 = m35_of_place;
    // M36 = -2*e2
    let m36 = -e2_doubled;
    // M41 = -4*(e0*e3*(3*C + J + 2*K) + e1*(3*e2*(B - A) + J*(e0 + e1 + e3) - K*(e0 + e1 + e3)) +
    //   e2*(J*(e0 - e2 - e3) + K*(e2 - e0 + e3)))/(3*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let m41 = m14_of_place_5;
    // M42 = 4*(e0*(3*e2*(C - A) + J*(e0 + e1 - e3) + K*(e3 - e0 - e1)) - e1*e3*(3*B + J + 2*K) + e2*(J*(e1
    //   - e2 + e3) + K*(e2 - e1 - e3)))/(3*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let m42 = minus_m24_of_place_4;
    // M43 = 4*(e1*(J*(e2 - e1 + e3) + K*(e1 - e2 - e3)) - e2*e3*(3*A + J + 2*K) - e0*(3*e1*(C - B) + J*(e2
    //   - e0 - e3) + K*(e0 - e2 + e3)))/(3*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let m43 = m34_of_place_3;
    // M44 = 4*(e2^2*(3*A + J + 2*K) + e0*(3*C*e0 + 2*K*(e0 - e1 + e2) + J*(e0 + 2*e1 - 2*e2)) +
    //   e1*(e1*(3*B + J + 2*K) + 2*e2*(K - J)))/(3*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let m44 = e2_sq.mul_add(m11_of_place_4, e0_sq * m11_of_place_3)
        + e1_sq * m11_of_place_5 - e2 * m11_of_place * e0_plus_e1 + m11_of_place_e0_e1;
    // M45 = 2*J*sqrt(3)*(e0 + e1 - e2)/(3*(e0^2 + e1^2 + e2^2 + e3^2))
    let m45 = minus_m45_of_place;
    // M46 = -2*e3
    let m46 = -e3_doubled;
    // M51 = -2*J*sqrt(3)*(e1 + e2 + e3)/(3*(e0^2 + e1^2 + e2^2 + e3^2))
    let m51 = minus_m15_of_place_2;
    // M52 = 2*J*sqrt(3)*(e0 + e2 - e3)/(3*(e0^2 + e1^2 + e2^2 + e3^2))
    let m52 = m25_of_place;
    // M53 = 2*J*sqrt(3)*(e0 - e1 + e3)/(3*(e0^2 + e1^2 + e2^2 + e3^2))
    let m53 = m35_of_place;
    // M54 = 2*J*sqrt(3)*(e0 + e1 - e2)/(3*(e0^2 + e1^2 + e2^2 + e3^2))
    let m54 = minus_m45_of_place;
    // M55 = J
    let m55 = J;
    // M61 = 2*e0
    let m61 = e0_doubled;
    // M62 = 2*e1
    let m62 = e1_doubled;
    // M63 = 2*e2
    let m63 = e2_doubled;
    // M64 = 2*e3
    let m64 = e3_doubled;
    let zero = S::int(0);
    [
        [m11, m12, m13, m14, m15, m16],
        [m21, m22, m23, m24, m25, m26],
        [m31, m32, m33, m34, m35, m36],
        [m41, m42, m43, m44, m45, m46],
        [m51, m52, m53, m54, m55, zero],
        [m61, m62, m63, m64, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (e0'', e1'', e2'', e3'', phi'', lambda_S_norm).
///
/// 424 operations, 1 other function.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> [S; 6] {
    let Parameters { A, B, C, J, K, T, .. } = *p;
    let [e0, e1, e2, e3, _] = *q;
    let [e0_dot, e1_dot, e2_dot, e3_dot, phi_dot] = *q_dot;
    // Elimination, step by step, each after the terms that it shares.
    // e0*e1' - e1*e0' + e3*e2' - e2*e3'
    let w_S_1_of_motion = (-e1).mul_add(e0_dot, e0 * e1_dot) + e3 * e2_dot - e2 * e3_dot;
    // 1/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_1_of_e0_e1_e2_e3 = S::int(1) / (e1.mul_add(e1, e0 * e0) + e2 * e2 + e3 * e3);
    // w_S_1 = (e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_1 = w_S_1_of_motion * w_S_1_of_e0_e1_e2_e3;
    // e0*e2' - e2*e0' - e3*e1' + e1*e3'
    let w_S_2_of_motion = (-e2).mul_add(e0_dot, e0 * e2_dot) - e3 * e1_dot + e1 * e3_dot;
    // w_S_2 = (e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_2 = w_S_1_of_e0_e1_e2_e3 * w_S_2_of_motion;
    // e2*e1' - e3*e0' - e1*e2' + e0*e3'
    let w_S_3_of_motion = (-e3).mul_add(e0_dot, e2 * e1_dot) - e1 * e2_dot + e0 * e3_dot;
    // w_S_3 = (e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_3 = w_S_1_of_e0_e1_e2_e3 * w_S_3_of_motion;
    let w_S_in_axle_base_1_of_ = (S::int(3)).sqrt();
    // 1/(3 + sqrt(3))
    let w_S_in_axle_base_1_of__2 = S::int(1) / (S::int(3) + w_S_in_axle_base_1_of_);
    // w_S_in_axle_base_1_of__2 - 1
    let w_S_in_axle_base_1_of__3 = w_S_in_axle_base_1_of__2 - S::int(1);
    let w_S_in_axle_base_1_of_motion = w_S_3_of_motion * w_S_in_axle_base_1_of_;
    // w_S_2_of_motion*w_S_in_axle_base_1_of__2 + w_S_1_of_motion*w_S_in_axle_base_1_of__3
    let w_S_in_axle_base_1_of_motion_2 = w_S_1_of_motion
        .mul_add(w_S_in_axle_base_1_of__3, w_S_2_of_motion * w_S_in_axle_base_1_of__2);
    // w_S_in_axle_base_1_of_motion + 3*w_S_in_axle_base_1_of_motion_2
    let w_S_in_axle_base_1_of_motion_3 = w_S_in_axle_base_1_of_motion_2
        .mul_add(S::int(3), w_S_in_axle_base_1_of_motion);
    // w_S_in_axle_base_1 = 3*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2
    //   + e3^2) + 3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)) +
    //   sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_1 = w_S_1_of_e0_e1_e2_e3 * w_S_in_axle_base_1_of_motion_3;
    // w_S_1_of_motion*w_S_in_axle_base_1_of__2 + w_S_2_of_motion*w_S_in_axle_base_1_of__3
    let w_S_in_axle_base_2_of_motion = w_S_2_of_motion
        .mul_add(w_S_in_axle_base_1_of__3, w_S_1_of_motion * w_S_in_axle_base_1_of__2);
    // w_S_in_axle_base_1_of_motion + 3*w_S_in_axle_base_2_of_motion
    let w_S_in_axle_base_2_of_motion_2 = w_S_in_axle_base_2_of_motion
        .mul_add(S::int(3), w_S_in_axle_base_1_of_motion);
    // w_S_in_axle_base_2 = 3*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 +
    //   e3^2)) + 3*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2) +
    //   sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_2 = w_S_1_of_e0_e1_e2_e3 * w_S_in_axle_base_2_of_motion_2;
    // sqrt(3)*(w_S_1_of_motion + w_S_2_of_motion) + w_S_in_axle_base_1_of_motion
    let w_S_in_axle_base_3_of_motion = w_S_in_axle_base_1_of_
        * (w_S_1_of_motion + w_S_2_of_motion) + w_S_in_axle_base_1_of_motion;
    // w_S_in_axle_base_3 = sqrt(3)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2) +
    //   sqrt(3)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2) + sqrt(3)*(e2*e1' - e3*e0' -
    //   e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_3 = w_S_1_of_e0_e1_e2_e3 * w_S_in_axle_base_3_of_motion;
    // w_W_turn1_3 = 3*phi' + 2*w_S_in_axle_base_3
    let w_W_turn1_3 = w_S_in_axle_base_3.mul_add(S::int(2), S::int(3) * phi_dot);
    // H_bus_1 = A*w_S_1
    let H_bus_1 = A * w_S_1;
    // H_bus_2 = B*w_S_2
    let H_bus_2 = B * w_S_2;
    // H_bus_3 = C*w_S_3
    let H_bus_3 = C * w_S_3;
    // H_wheel_1 = K*w_S_in_axle_base_1
    let H_wheel_1 = K * w_S_in_axle_base_1;
    // H_wheel_2 = K*w_S_in_axle_base_2
    let H_wheel_2 = K * w_S_in_axle_base_2;
    // H_wheel_3 = J*w_W_turn1_3
    let H_wheel_3 = J * w_W_turn1_3;
    let w_s_1_of_e0_e1_e2_e3_sq = w_S_1_of_e0_e1_e2_e3 * w_S_1_of_e0_e1_e2_e3;
    // w_s_1_of_e0_e1_e2_e3_sq*(e0*e0' + e1*e1' + e2*e2' + e3*e3')
    let w_S_1_2_of_motion = w_s_1_of_e0_e1_e2_e3_sq
        * (e1.mul_add(e1_dot, e0 * e0_dot) + e2 * e2_dot + e3 * e3_dot);
    // w_S_1_2 = (e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2
    let w_S_1_2 = w_S_1_of_motion * w_S_1_2_of_motion;
    // w_S_2_2 = (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2
    let w_S_2_2 = w_S_2_of_motion * w_S_1_2_of_motion;
    // w_S_3_2 = (e2*e1' - e3*e0' - e1*e2' + e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2
    let w_S_3_2 = w_S_3_of_motion * w_S_1_2_of_motion;
    // w_S_in_axle_base_1_2 = 3*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1'
    //   + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' +
    //   e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + sqrt(3)*(e2*e1' - e3*e0' -
    //   e1*e2' + e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_1_2 = w_S_in_axle_base_1_of_motion_3 * w_S_1_2_of_motion;
    // w_S_in_axle_base_2_2 = 3*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3
    //   + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + 3*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + sqrt(3)*(e2*e1' - e3*e0'
    //   - e1*e2' + e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_2_2 = w_S_in_axle_base_2_of_motion_2 * w_S_1_2_of_motion;
    // w_S_in_axle_base_3_2 = sqrt(3)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' +
    //   e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + sqrt(3)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1'
    //   + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_3_2 = w_S_in_axle_base_3_of_motion * w_S_1_2_of_motion;
    // H_bus_1_2 = A*w_S_1_2
    let H_bus_1_2 = A * w_S_1_2;
    // H_bus_2_2 = B*w_S_2_2
    let H_bus_2_2 = B * w_S_2_2;
    // H_bus_3_2 = C*w_S_3_2
    let H_bus_3_2 = C * w_S_3_2;
    // H_wheel_1_2 = K*w_S_in_axle_base_1_2
    let H_wheel_1_2 = K * w_S_in_axle_base_1_2;
    // H_wheel_2_2 = K*w_S_in_axle_base_2_2
    let H_wheel_2_2 = K * w_S_in_axle_base_2_2;
    // H_wheel_3_2 = J*w_S_in_axle_base_3_2
    let H_wheel_3_2 = J * w_S_in_axle_base_3_2;
    // H_wheel_1_2 + H_wheel_2_2
    let f1_of_place = H_wheel_1_2 + H_wheel_2_2;
    // f1_of_place - 2*H_wheel_3_2
    let f1_of_place_2 = (-H_wheel_3_2).mul_add(S::int(2), f1_of_place);
    let e1_f1_of_place_2 = e1 * f1_of_place_2;
    let e2_f1_of_place_2 = e2 * f1_of_place_2;
    // H_wheel_1 + H_wheel_2
    let h_wheel_1_plus_h_wheel_2 = H_wheel_1 + H_wheel_2;
    // H_wheel_3 + 2*h_wheel_1_plus_h_wheel_2
    let f1_of_place_3 = h_wheel_1_plus_h_wheel_2.mul_add(S::int(2), H_wheel_3);
    let e3_dot_f1_of_place_3 = e3_dot * f1_of_place_3;
    // e2_f1_of_place_2 + e3_dot_f1_of_place_3
    let f1_of_e3_dot = e2_f1_of_place_2 + e3_dot_f1_of_place_3;
    // h_wheel_1_plus_h_wheel_2 - H_wheel_3
    let f1_of_place_4 = h_wheel_1_plus_h_wheel_2 - H_wheel_3;
    let e2_dot_f1_of_place_4 = e2_dot * f1_of_place_4;
    // H_wheel_3_2 + f1_of_place
    let f1_of_place_5 = H_wheel_3_2 + f1_of_place;
    let f1_of_place_5_doubled = S::int(2) * f1_of_place_5;
    let e3_f1_of_place_5_doubled = e3 * f1_of_place_5_doubled;
    // e2_dot_f1_of_place_4 + e3_f1_of_place_5_doubled
    let f1_of_e2_dot = e2_dot_f1_of_place_4 + e3_f1_of_place_5_doubled;
    let e3_dot_f1_of_place_4 = e3_dot * f1_of_place_4;
    let e2_dot_f1_of_place_3 = e2_dot * f1_of_place_3;
    let e0_f1_of_place_2 = e0 * f1_of_place_2;
    // e2_dot_f1_of_place_3 + e0_f1_of_place_2
    let f1_of_e2_dot_2 = e2_dot_f1_of_place_3 + e0_f1_of_place_2;
    let e1_dot_f1_of_place_4 = e1_dot * f1_of_place_4;
    // e2_f1_of_place_2 + e2_dot_f1_of_place_4
    let f1_of_e2_dot_3 = e2_f1_of_place_2 + e2_dot_f1_of_place_4;
    let e1_dot_f1_of_place_3 = e1_dot * f1_of_place_3;
    let e3_f1_of_place_2 = e3 * f1_of_place_2;
    // e3_dot_f1_of_place_4 + e3_f1_of_place_2
    let f1_of_e3_dot_2 = e3_dot_f1_of_place_4 + e3_f1_of_place_2;
    // e3_f1_of_place_5_doubled + e1_dot_f1_of_place_4
    let f1_of_e1_dot = e3_f1_of_place_5_doubled + e1_dot_f1_of_place_4;
    // e1_dot_f1_of_place_3 - e0_f1_of_place_2
    let f1_of_e1_dot_2 = e1_dot_f1_of_place_3 - e0_f1_of_place_2;
    // e0*f1_of_place_5_doubled - e2_dot_f1_of_place_4
    let f1_of_e2_dot_4 = e0.mul_add(f1_of_place_5_doubled, -e2_dot_f1_of_place_4);
    // e3*(f1_of_e2_dot + e1_dot_f1_of_place_4)
    let f1_of_motion = e3 * (f1_of_e2_dot + e1_dot_f1_of_place_4);
    // H_wheel_1 - H_wheel_2
    let f1_of_place_6 = H_wheel_1 - H_wheel_2;
    // 6*H_bus_2 + f1_of_place_6
    let f1_of_place_7 = H_bus_2.mul_add(S::int(6), f1_of_place_6);
    let e1_dot_f1_of_place_7 = e1_dot * f1_of_place_7;
    // H_wheel_1_2 - H_wheel_2_2
    let f1_of_place_8 = H_wheel_1_2 - H_wheel_2_2;
    // 6*H_bus_1_2 - f1_of_place_8
    let f1_of_place_9 = H_bus_1_2.mul_add(S::int(6), -f1_of_place_8);
    let e2_f1_of_place_9 = e2 * f1_of_place_9;
    // e1_dot_f1_of_place_7 + e2_f1_of_place_9
    let f1_of_e1_dot_3 = e1_dot_f1_of_place_7 + e2_f1_of_place_9;
    // 6*H_bus_1 - f1_of_place_6
    let f1_of_place_10 = H_bus_1.mul_add(S::int(6), -f1_of_place_6);
    let e2_dot_f1_of_place_10 = e2_dot * f1_of_place_10;
    // 6*H_bus_2_2 + f1_of_place_8
    let f1_of_place_11 = H_bus_2_2.mul_add(S::int(6), f1_of_place_8);
    let e1_f1_of_place_11 = e1 * f1_of_place_11;
    // e2_dot_f1_of_place_10 + e1_f1_of_place_11
    let f1_of_e2_dot_5 = e2_dot_f1_of_place_10 + e1_f1_of_place_11;
    let h_bus_3_2_times_6 = S::int(6) * H_bus_3_2;
    let e3_h_bus_3_2_times_6 = e3 * h_bus_3_2_times_6;
    let e2_dot_f1_of_place_7 = e2_dot * f1_of_place_7;
    // e1*f1_of_place_9 - e2_dot_f1_of_place_7
    let f1_of_e2_dot_6 = e1.mul_add(f1_of_place_9, -e2_dot_f1_of_place_7);
    let h_bus_3_times_6 = S::int(6) * H_bus_3;
    let e3_dot_h_bus_3_times_6 = e3_dot * h_bus_3_times_6;
    // f1_of_e2_dot_6 - e3_dot_h_bus_3_times_6
    let f1_of_motion_2 = f1_of_e2_dot_6 - e3_dot_h_bus_3_times_6;
    let e3_dot_f1_of_place_7 = e3_dot * f1_of_place_7;
    // e0*f1_of_place_9 + e3_dot_f1_of_place_7
    let f1_of_e3_dot_3 = e0.mul_add(f1_of_place_9, e3_dot_f1_of_place_7);
    let e2_dot_h_bus_3_times_6 = e2_dot * h_bus_3_times_6;
    // f1_of_e3_dot_3 - e2_dot_h_bus_3_times_6
    let f1_of_motion_3 = f1_of_e3_dot_3 - e2_dot_h_bus_3_times_6;
    let e1_dot_h_bus_3_times_6 = e1_dot * h_bus_3_times_6;
    let e3_dot_f1_of_place_10 = e3_dot * f1_of_place_10;
    let e3_f1_of_place_9 = e3 * f1_of_place_9;
    let e1_times_3 = S::int(3) * e1;
    let e1_dot_f1_of_place_10 = e1_dot * f1_of_place_10;
    // e1_dot_f1_of_place_10 - e2*f1_of_place_11
    let f1_of_e1_dot_4 = (-e2).mul_add(f1_of_place_11, e1_dot_f1_of_place_10);
    // e3_dot_h_bus_3_times_6 + f1_of_e1_dot_4
    let f1_of_motion_4 = e3_dot_h_bus_3_times_6 + f1_of_e1_dot_4;
    let e0_f1_of_place_11 = e0 * f1_of_place_11;
    // e0_f1_of_place_11 - e3_dot_f1_of_place_10
    let f1_of_e3_dot_4 = e0_f1_of_place_11 - e3_dot_f1_of_place_10;
    // e1_dot_h_bus_3_times_6 + f1_of_e3_dot_4
    let f1_of_motion_5 = e1_dot_h_bus_3_times_6 + f1_of_e3_dot_4;
    let e3_f1_of_place_11 = e3 * f1_of_place_11;
    let e2_times_3 = S::int(3) * e2;
    // e2_dot_f1_of_place_10 + e0*h_bus_3_2_times_6
    let f1_of_e2_dot_7 = e0.mul_add(h_bus_3_2_times_6, e2_dot_f1_of_place_10);
    // e3*(e2_dot_f1_of_place_7 - e3_h_bus_3_2_times_6 + e1_dot_f1_of_place_10)
    let f1_of_motion_6 = e3 * (e2_dot_f1_of_place_7 - e3_h_bus_3_2_times_6 + e1_dot_f1_of_place_10);
    let e3_times_3 = S::int(3) * e3;
    let f1_of_e0_e1_e2_e3 = S::ratio(4, 9) * w_s_1_of_e0_e1_e2_e3_sq;
    let e2_f1_of_place_5_doubled = e2 * f1_of_place_5_doubled;
    // e2_f1_of_place_5_doubled - e3_dot_f1_of_place_4
    let f2_of_e3_dot = e2_f1_of_place_5_doubled - e3_dot_f1_of_place_4;
    let e0_dot_f1_of_place_3 = e0_dot * f1_of_place_3;
    let e0_dot_f1_of_place_4 = e0_dot * f1_of_place_4;
    // e3_f1_of_place_2 + e0_dot_f1_of_place_4
    let f2_of_e0_dot = e3_f1_of_place_2 + e0_dot_f1_of_place_4;
    let e1_f1_of_place_5_doubled = e1 * f1_of_place_5_doubled;
    // e1_f1_of_place_5_doubled - e3_dot_f1_of_place_4
    let f2_of_e3_dot_2 = e1_f1_of_place_5_doubled - e3_dot_f1_of_place_4;
    // e1_f1_of_place_2 + e0_dot_f1_of_place_3
    let f2_of_e0_dot_2 = e1_f1_of_place_2 + e0_dot_f1_of_place_3;
    // e2_dot_f1_of_place_4 + f2_of_e0_dot_2
    let f2_of_motion = e2_dot_f1_of_place_4 + f2_of_e0_dot_2;
    // e3*(e2_dot_f1_of_place_3 - f2_of_e0_dot)
    let f2_of_motion_2 = e3 * (e2_dot_f1_of_place_3 - f2_of_e0_dot);
    let e0_dot_f1_of_place_10 = e0_dot * f1_of_place_10;
    // e3_f1_of_place_11 + e0_dot_f1_of_place_10
    let f2_of_e0_dot_3 = e3_f1_of_place_11 + e0_dot_f1_of_place_10;
    let e2_h_bus_3_2_times_6 = e2 * h_bus_3_2_times_6;
    // e3_dot_f1_of_place_7 + e2_h_bus_3_2_times_6
    let f2_of_e3_dot_3 = e3_dot_f1_of_place_7 + e2_h_bus_3_2_times_6;
    let e0_dot_f1_of_place_7 = e0_dot * f1_of_place_7;
    let e1_h_bus_3_2_times_6 = e1 * h_bus_3_2_times_6;
    // e3_dot_f1_of_place_10 + e1_h_bus_3_2_times_6
    let f2_of_e3_dot_4 = e3_dot_f1_of_place_10 + e1_h_bus_3_2_times_6;
    // e3_h_bus_3_2_times_6 + e3_dot_h_bus_3_times_6
    let f2_of_e3_dot_5 = e3_h_bus_3_2_times_6 + e3_dot_h_bus_3_times_6;
    let e0_dot_h_bus_3_times_6 = e0_dot * h_bus_3_times_6;
    // e3*(e2_dot_h_bus_3_times_6 + f2_of_e0_dot_3) + e1*(f1_of_e2_dot_5 - e0_dot_h_bus_3_times_6)
    let f2_of_motion_3 = e3 * (e2_dot_h_bus_3_times_6 + f2_of_e0_dot_3)
        + e1 * (f1_of_e2_dot_5 - e0_dot_h_bus_3_times_6);
    // e0_dot_f1_of_place_7 - e3_f1_of_place_9
    let f2_of_e0_dot_4 = e0_dot_f1_of_place_7 - e3_f1_of_place_9;
    let e0_times_3 = S::int(3) * e0;
    // e3_f1_of_place_2 - e0_dot_f1_of_place_4
    let f3_of_e0_dot = e3_f1_of_place_2 - e0_dot_f1_of_place_4;
    // e2_f1_of_place_2 + e1_dot_f1_of_place_4
    let f3_of_e1_dot = e2_f1_of_place_2 + e1_dot_f1_of_place_4;
    // e3*(f3_of_e0_dot - e1_dot_f1_of_place_3) + e2*(f3_of_e1_dot - e0_dot_f1_of_place_3)
    let f3_of_motion = e3 * (f3_of_e0_dot - e1_dot_f1_of_place_3)
        + e2 * (f3_of_e1_dot - e0_dot_f1_of_place_3);
    // e2*(f1_of_e1_dot_3 + e0_dot_h_bus_3_times_6) + e3*(e1_dot_h_bus_3_times_6 - f2_of_e0_dot_4)
    let f3_of_motion_2 = e2 * (f1_of_e1_dot_3 + e0_dot_h_bus_3_times_6)
        + e3 * (e1_dot_h_bus_3_times_6 - f2_of_e0_dot_4);
    // e0'^2 + e1'^2
    let e0_dot_sq_plus_e1_dot_sq = e1_dot.mul_add(e1_dot, e0_dot * e0_dot);
    // e2'^2 + e3'^2
    let e2_dot_sq_plus_e3_dot_sq = e3_dot.mul_add(e3_dot, e2_dot * e2_dot);
    // e0_dot_sq_plus_e1_dot_sq + e2_dot_sq_plus_e3_dot_sq
    let f6_of_motion = e0_dot_sq_plus_e1_dot_sq + e2_dot_sq_plus_e3_dot_sq;
    // Values.
    // f1 = 4*(3*e3*(e0*(e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e2'*(H_wheel_1 - 6*H_bus_1 - H_wheel_2)
    //   - 6*e0*H_bus_3_2) + e3*(e2'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e1'*(6*H_bus_1 - H_wheel_1 +
    //   H_wheel_2) - 6*e3*H_bus_3_2)) - 3*e1*(e2*(e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e2'*(6*H_bus_1 -
    //   H_wheel_1 + H_wheel_2) + e1*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2) + e2*(6*H_bus_1_2 -
    //   H_wheel_1_2 + H_wheel_2_2)) + e1*(e2'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) - 6*e3'*H_bus_3 +
    //   6*e3*H_bus_3_2 + e1*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) + e0*(e3'*(6*H_bus_2 + H_wheel_1 -
    //   H_wheel_2) - 6*e2'*H_bus_3 + e0*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) + e3*(6*e1'*H_bus_3 +
    //   e3'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2))) -
    //   3*e2*(e2*(e1'*(H_wheel_1 - 6*H_bus_1 - H_wheel_2) - 6*e3'*H_bus_3 + 6*e3*H_bus_3_2 + e2*(6*H_bus_2_2
    //   + H_wheel_1_2 - H_wheel_2_2)) + e0*(6*e1'*H_bus_3 - e3'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) -
    //   e0*(H_wheel_2_2 - 6*H_bus_2_2 - H_wheel_1_2)) + e3*(6*e2'*H_bus_3 + e3'*(6*H_bus_2 + H_wheel_1 -
    //   H_wheel_2) + e3*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2))) + sqrt(3)*(e1*(e1*(e2'*(H_wheel_3 -
    //   H_wheel_1 - H_wheel_2) + e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e1*(H_wheel_1_2 + H_wheel_2_2
    //   - 2*H_wheel_3_2) + e2*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2) - 2*e3*(H_wheel_1_2 + H_wheel_2_2
    //   + H_wheel_3_2)) + e0*(e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e2'*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) + e0*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)) + e2*(e1'*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) + e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e2*(H_wheel_1_2 + H_wheel_2_2 -
    //   2*H_wheel_3_2)) + e3*(e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - e1'*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) + e3*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2))) + e2*(e2*(e1'*(H_wheel_3 - H_wheel_1 -
    //   H_wheel_2) + e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e2*(H_wheel_1_2 + H_wheel_2_2 -
    //   2*H_wheel_3_2) - 2*e3*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) + e0*(e3'*(H_wheel_3 - H_wheel_1 -
    //   H_wheel_2) - e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e0*(H_wheel_1_2 + H_wheel_2_2 -
    //   2*H_wheel_3_2)) - e3*(e3'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e2'*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) + e3*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2))) + e3*(e0*(e1'*(H_wheel_3 - H_wheel_1 -
    //   H_wheel_2) + e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*e0*(H_wheel_1_2 + H_wheel_2_2 +
    //   H_wheel_3_2)) - e3*(e1'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e2'*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) + 2*e3*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)))))/(9*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let f1 = f1_of_e0_e1_e2_e3
        * (w_S_in_axle_base_1_of_
            * (e1
                * (e1 * (e1_f1_of_place_2 + f1_of_e3_dot - f1_of_e2_dot)
                    + e0 * (e3_dot_f1_of_place_4 + f1_of_e2_dot_2)
                    + e2 * (e1_dot_f1_of_place_4 + f1_of_e2_dot_3)
                    + e3 * (f1_of_e3_dot_2 - e1_dot_f1_of_place_3))
                + e2
                    * (e3 * (f1_of_e3_dot_2 - e2_dot_f1_of_place_3)
                        + e2 * (f1_of_e3_dot - f1_of_e1_dot)
                        - e0 * (e3_dot_f1_of_place_4 + f1_of_e1_dot_2))
                - e3 * (e0 * (e1_dot_f1_of_place_4 + f1_of_e2_dot_4) + f1_of_motion))
            - e1_times_3
                * (e2 * (f1_of_e1_dot_3 + f1_of_e2_dot_5)
                    + e1 * (e3_h_bus_3_2_times_6 + f1_of_motion_2) + e0 * f1_of_motion_3
                    + e3
                        * (e1_dot_h_bus_3_times_6 + e3_dot_f1_of_place_10 + e3_f1_of_place_9))
            - e2_times_3
                * (e2 * (e3_h_bus_3_2_times_6 - f1_of_motion_4) + e0 * f1_of_motion_5
                    + e3
                        * (e3_dot_f1_of_place_7 + e2_dot_h_bus_3_times_6 + e3_f1_of_place_11))
            + e3_times_3 * (e0 * (e1_dot_f1_of_place_7 - f1_of_e2_dot_7) + f1_of_motion_6));
    // f2 = 4*(3*e0*(e3*(e0'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) + e3'*(6*H_bus_1 - H_wheel_1 + H_wheel_2)
    //   + e0*(H_wheel_2_2 - 6*H_bus_2_2 - H_wheel_1_2) + e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) +
    //   e0*(e3'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) - 6*e2'*H_bus_3 + 6*e2*H_bus_3_2 + e0*(6*H_bus_1_2 -
    //   H_wheel_1_2 + H_wheel_2_2)) + e1*(e2'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) - 6*e3'*H_bus_3 +
    //   e1*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) + e2*(6*e0'*H_bus_3 + e2'*(6*H_bus_1 - H_wheel_1 +
    //   H_wheel_2) + e2*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2))) - 3*e3*(e1*(e2'*(6*H_bus_1 - H_wheel_1 +
    //   H_wheel_2) - 6*e0'*H_bus_3 + e1*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2)) + e3*(6*e2'*H_bus_3 +
    //   e0'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + e3*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2))) +
    //   3*e2*(e1*(e0'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e3'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) +
    //   6*e1*H_bus_3_2) + e3*(6*e3'*H_bus_3 - e2'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*e3*H_bus_3_2) +
    //   e2*(e3'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e0'*(H_wheel_1 - 6*H_bus_1 - H_wheel_2) +
    //   6*e2*H_bus_3_2 + e3*(H_wheel_2_2 - 6*H_bus_2_2 - H_wheel_1_2))) - sqrt(3)*(e0*(e0*(e3'*(H_wheel_1 +
    //   H_wheel_2 - H_wheel_3) + e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e0*(H_wheel_1_2 + H_wheel_2_2
    //   - 2*H_wheel_3_2) + e3*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2) - 2*e2*(H_wheel_1_2 + H_wheel_2_2
    //   + H_wheel_3_2)) + e1*(e2'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e3'*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) + e1*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)) + e2*(e2'*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) - e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e2*(H_wheel_1_2 + H_wheel_2_2 -
    //   2*H_wheel_3_2)) + e3*(e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e3'*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) + e3*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2))) + e2*(e2*(e0'*(H_wheel_3 - H_wheel_1 -
    //   H_wheel_2) + e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e3*(2*H_wheel_3_2 - H_wheel_1_2 -
    //   H_wheel_2_2) - 2*e2*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) + e1*(e0'*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) + e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*e1*(H_wheel_1_2 + H_wheel_2_2 +
    //   H_wheel_3_2)) - e3*(e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e3'*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) + 2*e3*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2))) + e3*(e3*(e0'*(H_wheel_3 - H_wheel_1 -
    //   H_wheel_2) + e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e3*(2*H_wheel_3_2 - H_wheel_1_2 -
    //   H_wheel_2_2)) - e1*(e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e0'*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) + e1*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)))))/(9*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let f2 = -f1_of_e0_e1_e2_e3
        * (w_S_in_axle_base_1_of_
            * (e0
                * (e1 * (e1_f1_of_place_2 + e3_dot_f1_of_place_3 - e2_dot_f1_of_place_4)
                    + e0 * (f1_of_e2_dot_2 - e3_f1_of_place_2 - f2_of_e3_dot)
                    + e2 * (f1_of_e2_dot_3 - e0_dot_f1_of_place_3)
                    + e3 * (f1_of_e3_dot_2 - e0_dot_f1_of_place_4))
                - e2
                    * (e3 * (e3_dot_f1_of_place_3 + f1_of_e2_dot)
                        + e2 * (f2_of_e3_dot + f2_of_e0_dot)
                        + e1 * (f2_of_e3_dot_2 - e0_dot_f1_of_place_4))
                + e3 * (-e1).mul_add(f2_of_motion, f2_of_motion_2))
            + e2_times_3
                * (e2 * (f2_of_e0_dot_3 - f2_of_e3_dot_3)
                    - e1 * (e0_dot_f1_of_place_7 + f2_of_e3_dot_4)
                    + e3 * (e2_dot_f1_of_place_7 - f2_of_e3_dot_5)) + e3_times_3 * f2_of_motion_3
            + e0_times_3
                * (e3 * (f1_of_e3_dot_4 + f2_of_e0_dot_4) - e1 * f1_of_motion_2
                    - e0 * (f1_of_motion_3 + e2_h_bus_3_2_times_6)
                    - e2
                        * (e2_f1_of_place_9 + e2_dot_f1_of_place_10 + e0_dot_h_bus_3_times_6)));
    // f3 = 4*(3*e3*(e2*(6*e0'*H_bus_3 + e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e2*(6*H_bus_1_2 -
    //   H_wheel_1_2 + H_wheel_2_2)) + e3*(6*e1'*H_bus_3 + e0'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) +
    //   e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2))) - 3*e0*(e2*(6*e3'*H_bus_3 + e1'*(6*H_bus_1 -
    //   H_wheel_1 + H_wheel_2) + e2*(H_wheel_2_2 - 6*H_bus_2_2 - H_wheel_1_2)) - e3*(e3'*(6*H_bus_2 +
    //   H_wheel_1 - H_wheel_2) + e0'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + e3*(6*H_bus_2_2 + H_wheel_1_2 -
    //   H_wheel_2_2) + e0*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) - e0*(6*e1'*H_bus_3 - e3'*(6*H_bus_1 -
    //   H_wheel_1 + H_wheel_2) - 6*e1*H_bus_3_2 - e0*(H_wheel_2_2 - 6*H_bus_2_2 - H_wheel_1_2)) -
    //   e1*(e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) - 6*e0'*H_bus_3 + e1*(6*H_bus_2_2 + H_wheel_1_2 -
    //   H_wheel_2_2))) - 3*e1*(e2*(e3'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e0'*(H_wheel_1 - 6*H_bus_1 -
    //   H_wheel_2) + 6*e2*H_bus_3_2) - e1*(e0'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) + e3'*(H_wheel_1 -
    //   6*H_bus_1 - H_wheel_2) - 6*e1*H_bus_3_2 + e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) +
    //   e3*(6*e3'*H_bus_3 + e1'*(H_wheel_1 - 6*H_bus_1 - H_wheel_2) + 6*e3*H_bus_3_2)) -
    //   sqrt(3)*(e0*(e0*(e3'*(H_wheel_3 - H_wheel_1 - H_wheel_2) - e1'*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) + e0*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2) + e3*(H_wheel_1_2 + H_wheel_2_2 -
    //   2*H_wheel_3_2) + 2*e1*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) + e1*(e1'*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) + e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e1*(H_wheel_1_2 + H_wheel_2_2 -
    //   2*H_wheel_3_2)) + e2*(e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e3'*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) + e2*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)) + e3*(e0'*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) + e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e3*(H_wheel_1_2 + H_wheel_2_2 -
    //   2*H_wheel_3_2))) + e1*(e3*(e1'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e3'*(2*H_wheel_1 + 2*H_wheel_2
    //   + H_wheel_3) + 2*e3*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) - e1*(e0'*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) + e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e3*(2*H_wheel_3_2 - H_wheel_1_2 -
    //   H_wheel_2_2) - 2*e1*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) - e2*(e0'*(H_wheel_3 - H_wheel_1 -
    //   H_wheel_2) + e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*e2*(H_wheel_1_2 + H_wheel_2_2 +
    //   H_wheel_3_2))) + e3*(e2*(e1'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - e0'*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) + e2*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)) + e3*(e0'*(H_wheel_3 - H_wheel_1 -
    //   H_wheel_2) - e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e3*(H_wheel_1_2 + H_wheel_2_2 -
    //   2*H_wheel_3_2)))))/(9*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let f3 = f1_of_e0_e1_e2_e3
        * (-e1_times_3
            * (e2 * (f2_of_e3_dot_3 - e0_dot_f1_of_place_10)
                + e3 * (f2_of_e3_dot_5 - e1_dot_f1_of_place_10)
                + e1 * (f2_of_e3_dot_4 + f2_of_e0_dot_4)) + e3_times_3 * f3_of_motion_2
            - e0_times_3
                * (-e3 * (f1_of_e3_dot_3 + f2_of_e0_dot_3) + e2 * f1_of_motion_4
                    - e0 * (f1_of_motion_5 - e1_h_bus_3_2_times_6)
                    - e1
                        * (e1_dot_f1_of_place_7 + e1_f1_of_place_11 - e0_dot_h_bus_3_times_6))
            - w_S_in_axle_base_1_of_
                * (e0
                    * (e2 * (f1_of_e3_dot - e1_dot_f1_of_place_4)
                        + e3 * (f1_of_e3_dot_2 + e0_dot_f1_of_place_4)
                        + e0 * (e3_f1_of_place_2 - f1_of_e1_dot_2 + f2_of_e3_dot_2)
                        + e1 * (e1_dot_f1_of_place_4 + f2_of_e0_dot_2))
                    + e1
                        * (e3 * (e3_dot_f1_of_place_3 + f1_of_e1_dot)
                            + e2 * (f2_of_e3_dot + e0_dot_f1_of_place_4)
                            + e1 * (f2_of_e3_dot_2 + f3_of_e0_dot)) + e3 * f3_of_motion));
    // f4 = 4*(3*e1*(e1*(e2'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) - 6*e0'*H_bus_3 + e1*(6*H_bus_2_2 +
    //   H_wheel_1_2 - H_wheel_2_2)) + e3*(6*e2'*H_bus_3 + e0'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) +
    //   e3*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2)) - e2*(e2'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) +
    //   e1'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + e2*(H_wheel_2_2 - 6*H_bus_2_2 - H_wheel_1_2) +
    //   e1*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) + e0*(6*e1'*H_bus_3 + e0'*(6*H_bus_2 + H_wheel_1 -
    //   H_wheel_2) + 6*e1*H_bus_3_2 + e0*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2))) -
    //   3*e2*(e2*(6*e0'*H_bus_3 + e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e2*(6*H_bus_1_2 - H_wheel_1_2 +
    //   H_wheel_2_2)) + e3*(6*e1'*H_bus_3 + e0'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) + e3*(6*H_bus_1_2 -
    //   H_wheel_1_2 + H_wheel_2_2))) + 3*e0*(e2*(6*e2'*H_bus_3 + e0'*(H_wheel_1 - 6*H_bus_1 - H_wheel_2) +
    //   6*e2*H_bus_3_2) - e3*(e2'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e1'*(6*H_bus_1 - H_wheel_1 +
    //   H_wheel_2) - 6*e3*H_bus_3_2) - e0*(e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e2'*(H_wheel_1 -
    //   6*H_bus_1 - H_wheel_2) - 6*e0*H_bus_3_2 + e2*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2))) +
    //   sqrt(3)*(e2*(e2*(e1'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - e0'*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) + e2*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)) + e3*(e0'*(H_wheel_3 - H_wheel_1 -
    //   H_wheel_2) - e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e3*(H_wheel_1_2 + H_wheel_2_2 -
    //   2*H_wheel_3_2))) + e0*(e3*(e1'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e2'*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) + 2*e3*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) + e0*(2*e0*(H_wheel_1_2 + H_wheel_2_2 +
    //   H_wheel_3_2) - e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) - e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) -
    //   e1*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2) - e2*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2)) +
    //   e1*(e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   2*e1*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) + e2*(e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3) +
    //   e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*e2*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2))) +
    //   e1*(e3*(e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   e3*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2)) - e1*(e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) +
    //   e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e1*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2) +
    //   e2*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2)) - e2*(e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) +
    //   e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e2*(H_wheel_1_2 + H_wheel_2_2 -
    //   2*H_wheel_3_2)))))/(9*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let f4 = f1_of_e0_e1_e2_e3
        * (e1_times_3
            * (e0
                * (e1_dot_h_bus_3_times_6 + e0_f1_of_place_11 + e0_dot_f1_of_place_7
                    + e1_h_bus_3_2_times_6) - e2 * (f1_of_e2_dot_6 + f1_of_e1_dot_4)
                + f2_of_motion_3)
            - e0_times_3
                * (e0 * (f1_of_e1_dot_3 - f1_of_e2_dot_7) + f1_of_motion_6
                    + e2
                        * (e0_dot_f1_of_place_10 - e2_dot_h_bus_3_times_6 - e2_h_bus_3_2_times_6))
            + w_S_in_axle_base_1_of_
                * (e1
                    * (e2 * (e1_dot_f1_of_place_4 - f1_of_e2_dot_3)
                        + e1 * (e2_f1_of_place_2 - f2_of_motion) + f2_of_motion_2)
                    + e0
                        * (f1_of_motion
                            + e2
                                * (e2_dot_f1_of_place_3 + e2_f1_of_place_5_doubled
                                    + e0_dot_f1_of_place_4)
                            + e1
                                * (e1_dot_f1_of_place_3 - e0_dot_f1_of_place_4
                                    + e1_f1_of_place_5_doubled)
                            + e0 * (f1_of_e2_dot_4 - e1_f1_of_place_2 + f3_of_e1_dot))
                    + e2 * f3_of_motion) - e2_times_3 * f3_of_motion_2);
    // f5 = T + 4*H_wheel_3_2/3
    let f5 = T + S::ratio(4, 3) * H_wheel_3_2;
    // f6 = -2*e0'^2 - 2*e1'^2 - 2*e2'^2 - 2*e3'^2
    let f6 = -S::int(2) * f6_of_motion;
    [f1, f2, f3, f4, f5, f6]
}

/// The accelerations (e0'', e1'', e2'', e3'', phi''), solved for when this code was generated.
///
/// 292 operations, 1 other function.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 5] {
    let Parameters { A, B, C, J, K, T, .. } = *p;
    let [e0, e1, e2, e3, _] = *q;
    let [e0_dot, e1_dot, e2_dot, e3_dot, phi_dot] = *q_dot;
    // Elimination, step by step, each after the terms that it shares.
    let e3_e2_dot = e3 * e2_dot;
    // e0*e1' - e1*e0' - e2*e3' + e3_e2_dot
    let w_S_1_of_motion = (-e1).mul_add(e0_dot, e0 * e1_dot) - e2 * e3_dot + e3_e2_dot;
    let e3_sq = e3 * e3;
    // e0^2 + e1^2 + e2^2 + e3_sq
    let w_S_1_of_e0_e1_e2_e3 = e1.mul_add(e1, e0 * e0) + e2 * e2 + e3_sq;
    let w_s_1_of_e0_e1_e2_e3_inv = S::int(1) / w_S_1_of_e0_e1_e2_e3;
    // w_S_1 = (e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_1 = w_S_1_of_motion * w_s_1_of_e0_e1_e2_e3_inv;
    // e0*e2' - e2*e0' - e3*e1' + e1*e3'
    let w_S_2_of_motion = (-e2).mul_add(e0_dot, e0 * e2_dot) - e3 * e1_dot + e1 * e3_dot;
    // w_S_2 = (e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_2 = w_s_1_of_e0_e1_e2_e3_inv * w_S_2_of_motion;
    // e2*e1' - e3*e0' - e1*e2' + e0*e3'
    let w_S_3_of_motion = (-e3).mul_add(e0_dot, e2 * e1_dot) - e1 * e2_dot + e0 * e3_dot;
    // w_S_3 = (e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_3 = w_s_1_of_e0_e1_e2_e3_inv * w_S_3_of_motion;
    let w_S_in_axle_base_1_of_ = (S::int(3)).sqrt();
    // 1/(3 + sqrt(3))
    let w_S_in_axle_base_1_of__2 = S::int(1) / (S::int(3) + w_S_in_axle_base_1_of_);
    // w_S_in_axle_base_1_of__2 - 1
    let w_S_in_axle_base_1_of__3 = w_S_in_axle_base_1_of__2 - S::int(1);
    let w_S_in_axle_base_1_of_motion = w_S_3_of_motion * w_S_in_axle_base_1_of_;
    // w_S_2_of_motion*w_S_in_axle_base_1_of__2 + w_S_1_of_motion*w_S_in_axle_base_1_of__3
    let w_S_in_axle_base_1_of_motion_2 = w_S_1_of_motion
        .mul_add(w_S_in_axle_base_1_of__3, w_S_2_of_motion * w_S_in_axle_base_1_of__2);
    // w_S_in_axle_base_1_of_motion + 3*w_S_in_axle_base_1_of_motion_2
    let w_S_in_axle_base_1_of_motion_3 = w_S_in_axle_base_1_of_motion_2
        .mul_add(S::int(3), w_S_in_axle_base_1_of_motion);
    // w_S_in_axle_base_1 = 3*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2
    //   + e3^2) + 3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)) +
    //   sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_1 = w_s_1_of_e0_e1_e2_e3_inv * w_S_in_axle_base_1_of_motion_3;
    // w_S_1_of_motion*w_S_in_axle_base_1_of__2 + w_S_2_of_motion*w_S_in_axle_base_1_of__3
    let w_S_in_axle_base_2_of_motion = w_S_2_of_motion
        .mul_add(w_S_in_axle_base_1_of__3, w_S_1_of_motion * w_S_in_axle_base_1_of__2);
    // w_S_in_axle_base_1_of_motion + 3*w_S_in_axle_base_2_of_motion
    let w_S_in_axle_base_2_of_motion_2 = w_S_in_axle_base_2_of_motion
        .mul_add(S::int(3), w_S_in_axle_base_1_of_motion);
    // w_S_in_axle_base_2 = 3*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 +
    //   e3^2)) + 3*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2) +
    //   sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_2 = w_s_1_of_e0_e1_e2_e3_inv * w_S_in_axle_base_2_of_motion_2;
    // sqrt(3)*(w_S_1_of_motion + w_S_2_of_motion) + w_S_in_axle_base_1_of_motion
    let w_S_in_axle_base_3_of_motion = w_S_in_axle_base_1_of_
        * (w_S_1_of_motion + w_S_2_of_motion) + w_S_in_axle_base_1_of_motion;
    // w_S_in_axle_base_3 = sqrt(3)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2) +
    //   sqrt(3)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2) + sqrt(3)*(e2*e1' - e3*e0' -
    //   e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_3 = w_s_1_of_e0_e1_e2_e3_inv * w_S_in_axle_base_3_of_motion;
    // w_W_turn1_3 = 3*phi' + 2*w_S_in_axle_base_3
    let w_W_turn1_3 = w_S_in_axle_base_3.mul_add(S::int(2), S::int(3) * phi_dot);
    // H_bus_1 = A*w_S_1
    let H_bus_1 = A * w_S_1;
    // H_bus_2 = B*w_S_2
    let H_bus_2 = B * w_S_2;
    // H_bus_3 = C*w_S_3
    let H_bus_3 = C * w_S_3;
    // H_wheel_1 = K*w_S_in_axle_base_1
    let H_wheel_1 = K * w_S_in_axle_base_1;
    // H_wheel_2 = K*w_S_in_axle_base_2
    let H_wheel_2 = K * w_S_in_axle_base_2;
    // H_wheel_3 = J*w_W_turn1_3
    let H_wheel_3 = J * w_W_turn1_3;
    // e2*e2' + e3*e3'
    let e2_e2_dot_plus_e3_e3_dot = e3.mul_add(e3_dot, e2 * e2_dot);
    // e1*e1' + e2_e2_dot_plus_e3_e3_dot
    let w_S_1_2_of_motion = e1.mul_add(e1_dot, e2_e2_dot_plus_e3_e3_dot);
    let w_S_1_2_of_e0_e1_e2_e3 = w_s_1_of_e0_e1_e2_e3_inv * w_s_1_of_e0_e1_e2_e3_inv;
    // w_S_1_2_of_e0_e1_e2_e3*(e0*e0' + w_S_1_2_of_motion)
    let w_S_1_2_of_motion_2 = w_S_1_2_of_e0_e1_e2_e3 * e0.mul_add(e0_dot, w_S_1_2_of_motion);
    // w_S_1_2 = (e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2
    let w_S_1_2 = w_S_1_of_motion * w_S_1_2_of_motion_2;
    // w_S_2_2 = (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2
    let w_S_2_2 = w_S_2_of_motion * w_S_1_2_of_motion_2;
    // w_S_3_2 = (e2*e1' - e3*e0' - e1*e2' + e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2
    let w_S_3_2 = w_S_3_of_motion * w_S_1_2_of_motion_2;
    // w_S_in_axle_base_1_2 = 3*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1'
    //   + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' +
    //   e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + sqrt(3)*(e2*e1' - e3*e0' -
    //   e1*e2' + e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_1_2 = w_S_in_axle_base_1_of_motion_3 * w_S_1_2_of_motion_2;
    // w_S_in_axle_base_2_2 = 3*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3
    //   + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + 3*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + sqrt(3)*(e2*e1' - e3*e0'
    //   - e1*e2' + e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_2_2 = w_S_in_axle_base_2_of_motion_2 * w_S_1_2_of_motion_2;
    // w_S_in_axle_base_3_2 = sqrt(3)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' +
    //   e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + sqrt(3)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1'
    //   + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_3_2 = w_S_in_axle_base_3_of_motion * w_S_1_2_of_motion_2;
    // H_bus_1_2 = A*w_S_1_2
    let H_bus_1_2 = A * w_S_1_2;
    // H_bus_2_2 = B*w_S_2_2
    let H_bus_2_2 = B * w_S_2_2;
    // H_bus_3_2 = C*w_S_3_2
    let H_bus_3_2 = C * w_S_3_2;
    // H_wheel_1_2 = K*w_S_in_axle_base_1_2
    let H_wheel_1_2 = K * w_S_in_axle_base_1_2;
    // H_wheel_2_2 = K*w_S_in_axle_base_2_2
    let H_wheel_2_2 = K * w_S_in_axle_base_2_2;
    // H_wheel_3_2 = J*w_S_in_axle_base_3_2
    let H_wheel_3_2 = J * w_S_in_axle_base_3_2;
    // H_wheel_1_2 + H_wheel_2_2
    let r1_of_place = H_wheel_1_2 + H_wheel_2_2;
    // H_wheel_3_2 + r1_of_place
    let r1_of_place_2 = H_wheel_3_2 + r1_of_place;
    let r1_of_place_2_doubled = S::int(2) * r1_of_place_2;
    // e1' - e2'
    let e1_dot_minus_e2_dot = e1_dot - e2_dot;
    // H_wheel_1 + H_wheel_2
    let h_wheel_1_plus_h_wheel_2 = H_wheel_1 + H_wheel_2;
    // h_wheel_1_plus_h_wheel_2 - H_wheel_3
    let r1_of_place_3 = h_wheel_1_plus_h_wheel_2 - H_wheel_3;
    // e1' + e2'
    let e1_dot_plus_e2_dot = e1_dot + e2_dot;
    // e0' + e3'
    let e0_dot_plus_e3_dot = e0_dot + e3_dot;
    // e0' - e3'
    let e0_dot_minus_e3_dot = e0_dot - e3_dot;
    // H_wheel_1 - H_wheel_2
    let r1_of_place_4 = H_wheel_1 - H_wheel_2;
    let w_s_2_of_motion_times_18 = S::int(18) * w_S_2_of_motion;
    let w_s_1_of_motion_times_18 = S::int(18) * w_S_1_of_motion;
    // 1/(3*A + 2*K)
    let r1_of_a_k = S::int(1) / K.mul_add(S::int(2), S::int(3) * A);
    let k_r1_of_a_k = K * r1_of_a_k;
    // 3*T + 4*H_wheel_3_2
    let r1_of_place_5 = H_wheel_3_2.mul_add(S::int(4), S::int(3) * T);
    let r1_of_place_6 = r1_of_place_5 * w_S_in_axle_base_1_of_;
    // H_wheel_3 + 2*h_wheel_1_plus_h_wheel_2
    let r1_of_place_7 = h_wheel_1_plus_h_wheel_2.mul_add(S::int(2), H_wheel_3);
    let r1_of_motion = w_S_3_of_motion * r1_of_place_3;
    // w_S_1_of_e0_e1_e2_e3*(r1_of_place - 2*H_wheel_3_2)
    let r1_of_place_8 = w_S_1_of_e0_e1_e2_e3 * (-H_wheel_3_2).mul_add(S::int(2), r1_of_place);
    let w_s_3_of_motion_times_3 = S::int(3) * w_S_3_of_motion;
    // H_wheel_1_2 - H_wheel_2_2
    let r1_of_place_9 = H_wheel_1_2 - H_wheel_2_2;
    let r1_of_e0_e1_e2_e3 = S::int(3) * w_S_1_of_e0_e1_e2_e3;
    // H_bus_3*w_s_2_of_motion_times_18 + sqrt(3)*(w_S_2_of_motion*r1_of_place_7 + r1_of_motion +
    //   r1_of_place_8) - w_s_3_of_motion_times_3*(6*H_bus_2 + r1_of_place_4) +
    //   r1_of_e0_e1_e2_e3*(r1_of_place_9 - 6*H_bus_1_2)
    let r1_of_motion_2 = w_S_in_axle_base_1_of_
        * (w_S_2_of_motion.mul_add(r1_of_place_7, r1_of_motion) + r1_of_place_8)
        + H_bus_3 * w_s_2_of_motion_times_18
        - w_s_3_of_motion_times_3 * H_bus_2.mul_add(S::int(6), r1_of_place_4)
        + r1_of_e0_e1_e2_e3 * (-H_bus_1_2).mul_add(S::int(6), r1_of_place_9);
    let r1_of_e0_e1_e2_e3_2 = S::int(2) * w_s_1_of_e0_e1_e2_e3_inv;
    // r1_of_e0_e1_e2_e3_2*(H_bus_3*w_s_1_of_motion_times_18 + sqrt(3)*(w_S_1_of_motion*r1_of_place_7 +
    //   r1_of_motion - r1_of_place_8) + w_s_3_of_motion_times_3*(r1_of_place_4 - 6*H_bus_1) +
    //   r1_of_e0_e1_e2_e3*(6*H_bus_2_2 + r1_of_place_9) - k_r1_of_a_k*r1_of_motion_2)
    let r1_of_motion_3 = r1_of_e0_e1_e2_e3_2
        * (w_S_in_axle_base_1_of_
            * (w_S_1_of_motion.mul_add(r1_of_place_7, r1_of_motion) - r1_of_place_8)
            + H_bus_3 * w_s_1_of_motion_times_18
            + w_s_3_of_motion_times_3 * (-H_bus_1).mul_add(S::int(6), r1_of_place_4)
            + r1_of_e0_e1_e2_e3 * H_bus_2_2.mul_add(S::int(6), r1_of_place_9)
            - k_r1_of_a_k * r1_of_motion_2);
    // A + K
    let a_plus_k = A + K;
    let k_r1_of_a_k_a_plus_k = k_r1_of_a_k * a_plus_k;
    // K*(k_r1_of_a_k - 2)
    let r1_of_a_k_2 = K * (k_r1_of_a_k - S::int(2));
    // 1/(3*B - r1_of_a_k_2)
    let r1_of_a_b_k = S::int(1) / B.mul_add(S::int(3), -r1_of_a_k_2);
    let r1_of_a_b_k_by_3 = S::ratio(1, 3) * r1_of_a_b_k;
    // r1_of_place_6 + r1_of_motion_2*r1_of_e0_e1_e2_e3_2
    let r1_of_motion_4 = r1_of_motion_2.mul_add(r1_of_e0_e1_e2_e3_2, r1_of_place_6);
    // r1_of_place_6 + k_r1_of_a_k*r1_of_motion_4
    let r1_of_motion_5 = k_r1_of_a_k.mul_add(r1_of_motion_4, r1_of_place_6);
    // r1 = 2*(18*H_bus_3_2*(e0^2 + e1^2 + e2^2 + e3^2) - 18*H_bus_1*(e2*e0' - e0*e2' + e3*e1' - e1*e3') -
    //   18*H_bus_2*(e0*e1' - e1*e0' + e3*e2' - e2*e3') - 3*H_wheel_1*(e0*(e1' + e2') - e3*(e1' - e2') -
    //   e2*(e0' + e3') - e1*(e0' - e3')) - 3*H_wheel_2*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' + e3') +
    //   e1*(e0' - e3')) - sqrt(3)*(e0*(e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e2'*(H_wheel_1 + H_wheel_2
    //   - H_wheel_3) - 2*e0*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) - e3*(e1'*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) + e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*e3*(H_wheel_1_2 + H_wheel_2_2 +
    //   H_wheel_3_2)) + e1*(e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e3'*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) - 2*e1*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) + e2*(e0'*(H_wheel_3 - H_wheel_1 -
    //   H_wheel_2) + e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*e2*(H_wheel_1_2 + H_wheel_2_2 +
    //   H_wheel_3_2))))/(9*(e0^2 + e1^2 + e2^2 + e3^2)) - sqrt(3)*(3*T + 4*H_wheel_3_2)/9 - K*(sqrt(3)*(3*T
    //   + 4*H_wheel_3_2) + 2*(18*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 3*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 -
    //   6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*((e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) + (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + (e0^2 +
    //   e1^2 + e2^2 + e3^2)*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)))/(e0^2 + e1^2 + e2^2 +
    //   e3^2))/(9*(3*A + 2*K)) + K*(A + K)*(2*(18*H_bus_3*(e0*e1' - e1*e0' + e3*e2' - e2*e3') + 3*(e3*e0' -
    //   e2*e1' + e1*e2' - e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 3*(e0^2 + e1^2 + e2^2 +
    //   e3^2)*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2) - K*(18*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')
    //   + 3*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 3*(e0^2 + e1^2 + e2^2
    //   + e3^2)*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*((e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 + H_wheel_2_2 -
    //   2*H_wheel_3_2)))/(3*A + 2*K) + sqrt(3)*((e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) + (e0*e1' - e1*e0' + e3*e2' - e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + (e0^2 +
    //   e1^2 + e2^2 + e3^2)*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 + e3^2) -
    //   sqrt(3)*(1 + K/(3*A + 2*K))*(3*T + 4*H_wheel_3_2))/(3*(3*A + 2*K)*(3*B + K*(2 - K/(3*A + 2*K))))
    let r1 = S::ratio(2, 9) * w_s_1_of_e0_e1_e2_e3_inv
        * (w_S_in_axle_base_1_of_
            * (e0 * e1_dot_minus_e2_dot.mul_add(r1_of_place_3, e0 * r1_of_place_2_doubled)
                + e3
                    * r1_of_place_3
                        .mul_add(e1_dot_plus_e2_dot, e3 * r1_of_place_2_doubled)
                + e1
                    * (-r1_of_place_3)
                        .mul_add(e0_dot_plus_e3_dot, e1 * r1_of_place_2_doubled)
                + e2
                    * r1_of_place_3
                        .mul_add(e0_dot_minus_e3_dot, e2 * r1_of_place_2_doubled))
            + S::int(18) * H_bus_3_2 * w_S_1_of_e0_e1_e2_e3
            + S::int(3) * r1_of_place_4
                * ((-e0).mul_add(e1_dot_plus_e2_dot, e3 * e1_dot_minus_e2_dot)
                    + e2 * e0_dot_plus_e3_dot + e1 * e0_dot_minus_e3_dot)
            + H_bus_1 * w_s_2_of_motion_times_18 - H_bus_2 * w_s_1_of_motion_times_18)
        + k_r1_of_a_k_a_plus_k * r1_of_a_b_k_by_3
            * (r1_of_motion_3 - r1_of_place_6 * (S::int(1) + k_r1_of_a_k))
        - S::ratio(1, 9) * r1_of_motion_5;
    // w3' = 3*r1/(3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A + K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A +
    //   2*K)))))
    let w3_dot = S::int(3) * r1
        / (C.mul_add(S::int(3), -r1_of_a_k_2)
            - S::int(9) * k_r1_of_a_k_a_plus_k * k_r1_of_a_k_a_plus_k * r1_of_a_b_k);
    // w2' = -(sqrt(3)*(3*T + 4*H_wheel_3_2) + 2*(K*(18*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') +
    //   3*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 3*(e0^2 + e1^2 + e2^2 +
    //   e3^2)*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*((e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 + H_wheel_2_2 -
    //   2*H_wheel_3_2)))/(3*A + 2*K) - 18*H_bus_3*(e0*e1' - e1*e0' + e3*e2' - e2*e3') - 3*(e3*e0' - e2*e1' +
    //   e1*e2' - e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) - 3*(e0^2 + e1^2 + e2^2 + e3^2)*(6*H_bus_2_2 +
    //   H_wheel_1_2 - H_wheel_2_2) - sqrt(3)*((e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) + (e0*e1' - e1*e0' + e3*e2' - e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + (e0^2 +
    //   e1^2 + e2^2 + e3^2)*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 + e3^2) +
    //   K*(sqrt(3)*(3*T + 4*H_wheel_3_2) - 9*w3'*(A + K))/(3*A + 2*K))/(3*(3*B + K*(2 - K/(3*A + 2*K))))
    let w2_dot = r1_of_a_b_k_by_3
        * (r1_of_motion_3 - r1_of_place_6
            - k_r1_of_a_k * (-(w3_dot * a_plus_k)).mul_add(S::int(9), r1_of_place_6));
    // w2' + w3'
    let w2_dot_plus_w3_dot = w2_dot + w3_dot;
    // w1' = (3*K*(w2' + w3') - sqrt(3)*(3*T + 4*H_wheel_3_2) - 2*(18*H_bus_3*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 3*(e0^2 + e1^2
    //   + e2^2 + e3^2)*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*((e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 + H_wheel_2_2 -
    //   2*H_wheel_3_2)))/(e0^2 + e1^2 + e2^2 + e3^2))/(3*(3*A + 2*K))
    let w1_dot = S::ratio(1, 3) * r1_of_a_k
        * (K * w2_dot_plus_w3_dot).mul_add(S::int(3), -r1_of_motion_4);
    // sqrt(3)*(w1' + w2_dot_plus_w3_dot) - r1_of_place_5/J
    let s_dot_of_motion = w_S_in_axle_base_1_of_ * (w1_dot + w2_dot_plus_w3_dot)
        - r1_of_place_5 / J;
    // s' = (3*T + 4*H_wheel_3_2)/(3*J) - sqrt(3)*(w1' + w2' + w3')/3
    let s_dot = -S::ratio(1, 3) * s_dot_of_motion;
    let w1_dot_halved = S::ratio(1, 2) * w1_dot;
    let w2_dot_halved = S::ratio(1, 2) * w2_dot;
    let w3_dot_halved = S::ratio(1, 2) * w3_dot;
    let e1_dot_sq = e1_dot * e1_dot;
    let e2_dot_sq = e2_dot * e2_dot;
    // e1_dot_sq + e2_dot_sq
    let e1_dot_sq_plus_e2_dot_sq = e1_dot_sq + e2_dot_sq;
    let e3_dot_sq = e3_dot * e3_dot;
    let e0_dot_sq = e0_dot * e0_dot;
    // e3_dot_sq + e0_dot_sq
    let e3_dot_sq_plus_e0_dot_sq = e3_dot_sq + e0_dot_sq;
    // w_S_1_2_of_e0_e1_e2_e3*(e0*(e0*(e1_dot_sq_plus_e2_dot_sq + e3_dot_sq) - 2*e0'*w_S_1_2_of_motion) +
    //   e3_sq*(e1_dot_sq_plus_e2_dot_sq + e0_dot_sq) + e1*(e1*(e2_dot_sq + e3_dot_sq_plus_e0_dot_sq) -
    //   2*e1'*e2_e2_dot_plus_e3_e3_dot) + e2*(e2*(e1_dot_sq + e3_dot_sq_plus_e0_dot_sq) - 2*e3'*e3_e2_dot))
    let e0_ddot_of_motion = w_S_1_2_of_e0_e1_e2_e3
        * (e0
            * (e0 * (e1_dot_sq_plus_e2_dot_sq + e3_dot_sq) - S::int(2) * e0_dot * w_S_1_2_of_motion)
            + e3_sq * (e1_dot_sq_plus_e2_dot_sq + e0_dot_sq)
            + e1
                * (e1 * (e2_dot_sq + e3_dot_sq_plus_e0_dot_sq)
                    - S::int(2) * e1_dot * e2_e2_dot_plus_e3_e3_dot)
            + e2
                * (e2 * (e1_dot_sq + e3_dot_sq_plus_e0_dot_sq) - S::int(2) * e3_dot * e3_e2_dot));
    // e0'' = -e0*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' +
    //   e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 +
    //   e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2 - e1*w1'/2 - e2*w2'/2 - e3*w3'/2
    let e0_ddot = (-e2).mul_add(w2_dot_halved, -e1 * w1_dot_halved) - e3 * w3_dot_halved
        - e0 * e0_ddot_of_motion;
    // e1'' = e0*w1'/2 - e1*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1'
    //   + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 +
    //   e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2 - e3*w2'/2 + e2*w3'/2
    let e1_ddot = (-e3).mul_add(w2_dot_halved, e0 * w1_dot_halved) + e2 * w3_dot_halved
        - e1 * e0_ddot_of_motion;
    // e2'' = e3*w1'/2 - e2*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1'
    //   + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 +
    //   e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2 + e0*w2'/2 - e1*w3'/2
    let e2_ddot = e0.mul_add(w2_dot_halved, e3 * w1_dot_halved) - e1 * w3_dot_halved
        - e2 * e0_ddot_of_motion;
    // e3'' = e1*w2'/2 - e3*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1'
    //   + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 +
    //   e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2 - e2*w1'/2 + e0*w3'/2
    let e3_ddot = (-e2).mul_add(w1_dot_halved, e1 * w2_dot_halved) + e0 * w3_dot_halved
        - e3 * e0_ddot_of_motion;
    // phi'' = s'
    let phi_ddot = s_dot;
    [e0_ddot, e1_ddot, e2_ddot, e3_ddot, phi_ddot]
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
    let [e0_dot, e1_dot, e2_dot, e3_dot, phi_dot] = *q_dot;
    // Values.
    // e0'
    let e0_dot_value = e0_dot;
    // e1'
    let e1_dot_value = e1_dot;
    // e2'
    let e2_dot_value = e2_dot;
    // e3'
    let e3_dot_value = e3_dot;
    // phi'
    let phi_dot_value = phi_dot;
    [e0_dot_value, e1_dot_value, e2_dot_value, e3_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 74 operations, 1 other function.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> S {
    let Parameters { A, B, C, J, K, .. } = *p;
    let [e0, e1, e2, e3, _] = *q;
    let [e0_dot, e1_dot, e2_dot, e3_dot, phi_dot] = *q_dot;
    // Elimination, step by step, each after the terms that it shares.
    // e0*e1' - e1*e0' + e3*e2' - e2*e3'
    let w_S_1_of_motion = (-e1).mul_add(e0_dot, e0 * e1_dot) + e3 * e2_dot - e2 * e3_dot;
    // 1/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_1_of_e0_e1_e2_e3 = S::int(1) / (e1.mul_add(e1, e0 * e0) + e2 * e2 + e3 * e3);
    // w_S_1 = (e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_1 = w_S_1_of_motion * w_S_1_of_e0_e1_e2_e3;
    // e0*e2' - e2*e0' - e3*e1' + e1*e3'
    let w_S_2_of_motion = (-e2).mul_add(e0_dot, e0 * e2_dot) - e3 * e1_dot + e1 * e3_dot;
    // w_S_2 = (e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_2 = w_S_1_of_e0_e1_e2_e3 * w_S_2_of_motion;
    // e2*e1' - e3*e0' - e1*e2' + e0*e3'
    let w_S_3_of_motion = (-e3).mul_add(e0_dot, e2 * e1_dot) - e1 * e2_dot + e0 * e3_dot;
    // w_S_3 = (e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_3 = w_S_1_of_e0_e1_e2_e3 * w_S_3_of_motion;
    let w_S_in_axle_base_1_of_ = (S::int(3)).sqrt();
    let w_S_in_axle_base_1_of_e0_e1_e2_e3 = w_S_1_of_e0_e1_e2_e3 * w_S_in_axle_base_1_of_;
    let w_S_in_axle_base_1_of_motion = w_S_3_of_motion * w_S_in_axle_base_1_of_e0_e1_e2_e3;
    let w_S_in_axle_base_1_of_e0_e1_e2_e3_2 = S::int(3) * w_S_1_of_e0_e1_e2_e3;
    // 1/(3 + sqrt(3))
    let w_S_in_axle_base_1_of__2 = S::int(1) / (S::int(3) + w_S_in_axle_base_1_of_);
    // w_S_in_axle_base_1_of__2 - 1
    let w_S_in_axle_base_1_of__3 = w_S_in_axle_base_1_of__2 - S::int(1);
    // w_S_in_axle_base_1 = 3*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2
    //   + e3^2) + 3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)) +
    //   sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_1 = w_S_in_axle_base_1_of_motion
        + w_S_in_axle_base_1_of_e0_e1_e2_e3_2
            * w_S_1_of_motion
                .mul_add(
                    w_S_in_axle_base_1_of__3,
                    w_S_2_of_motion * w_S_in_axle_base_1_of__2,
                );
    // w_S_in_axle_base_2 = 3*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 +
    //   e3^2)) + 3*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2) +
    //   sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_2 = w_S_in_axle_base_1_of_motion
        + w_S_in_axle_base_1_of_e0_e1_e2_e3_2
            * w_S_2_of_motion
                .mul_add(
                    w_S_in_axle_base_1_of__3,
                    w_S_1_of_motion * w_S_in_axle_base_1_of__2,
                );
    // w_S_in_axle_base_3 = sqrt(3)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2) +
    //   sqrt(3)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2) + sqrt(3)*(e2*e1' - e3*e0' -
    //   e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_3 = w_S_in_axle_base_1_of_e0_e1_e2_e3
        * (w_S_1_of_motion + w_S_2_of_motion) + w_S_in_axle_base_1_of_motion;
    // w_W_turn1_3 = 3*phi' + 2*w_S_in_axle_base_3
    let w_W_turn1_3 = w_S_in_axle_base_3.mul_add(S::int(2), S::int(3) * phi_dot);
    // H_bus_1 = A*w_S_1
    let H_bus_1 = A * w_S_1;
    // H_bus_2 = B*w_S_2
    let H_bus_2 = B * w_S_2;
    // H_bus_3 = C*w_S_3
    let H_bus_3 = C * w_S_3;
    // H_wheel_1 = K*w_S_in_axle_base_1
    let H_wheel_1 = K * w_S_in_axle_base_1;
    // H_wheel_2 = K*w_S_in_axle_base_2
    let H_wheel_2 = K * w_S_in_axle_base_2;
    // H_wheel_3 = J*w_W_turn1_3
    let H_wheel_3 = J * w_W_turn1_3;
    // w_S_1*H_bus_1 + w_S_2*H_bus_2
    let energy_of_place = w_S_2.mul_add(H_bus_2, w_S_1 * H_bus_1);
    // w_S_in_axle_base_1*H_wheel_1 + w_S_in_axle_base_2*H_wheel_2
    let energy_of_place_2 = w_S_in_axle_base_2
        .mul_add(H_wheel_2, w_S_in_axle_base_1 * H_wheel_1);
    // w_S_3*H_bus_3 + energy_of_place
    let energy_of_place_3 = w_S_3.mul_add(H_bus_3, energy_of_place);
    // Values.
    // T = 2*w_S_1*H_bus_1 + 2*w_S_2*H_bus_2 + 2*w_S_3*H_bus_3 + 2*w_S_in_axle_base_1*H_wheel_1/9 +
    //   2*w_S_in_axle_base_2*H_wheel_2/9 + w_W_turn1_3*H_wheel_3/18
    let energy = energy_of_place_3
        .mul_add(
            S::int(2),
            S::ratio(1, 18) * w_W_turn1_3 * H_wheel_3 + S::ratio(2, 9) * energy_of_place_2,
        );
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 32 operations.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 4] {
    let [e0, e1, e2, e3, _] = *q;
    let [e0_dot, e1_dot, e2_dot, e3_dot, phi_dot] = *q_dot;
    // Shared terms.
    // 2/(e0^2 + e1^2 + e2^2 + e3^2)
    let w1_value_of_e0_e1_e2_e3 = S::int(2) / (e1.mul_add(e1, e0 * e0) + e2 * e2 + e3 * e3);
    // Values.
    // w1 = 2*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w1_value = w1_value_of_e0_e1_e2_e3
        * ((-e1).mul_add(e0_dot, e0 * e1_dot) + e3 * e2_dot - e2 * e3_dot);
    // w2 = 2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w2_value = w1_value_of_e0_e1_e2_e3
        * ((-e2).mul_add(e0_dot, e0 * e2_dot) - e3 * e1_dot + e1 * e3_dot);
    // w3 = 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w3_value = w1_value_of_e0_e1_e2_e3
        * ((-e3).mul_add(e0_dot, e2 * e1_dot) - e1 * e2_dot + e0 * e3_dot);
    // s = phi'
    let s_value = phi_dot;
    [w1_value, w2_value, w3_value, s_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 53 operations.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
    v_dot: &[S; 5],
) -> [S; 4] {
    let [e0, e1, e2, e3, _] = *q;
    let [e0_dot, e1_dot, e2_dot, e3_dot, _] = *q_dot;
    let [e0_ddot, e1_ddot, e2_ddot, e3_ddot, phi_ddot] = *v_dot;
    // Shared terms.
    // 1/(e0^2 + e1^2 + e2^2 + e3^2)
    let w1_dot_value_of_e0_e1_e2_e3 = S::int(1) / (e1.mul_add(e1, e0 * e0) + e2 * e2 + e3 * e3);
    // e2*e2' + e3*e3'
    let e2_e2_dot_plus_e3_e3_dot = e3.mul_add(e3_dot, e2 * e2_dot);
    // e0*e0' + e1*e1'
    let e0_e0_dot_plus_e1_e1_dot = e1.mul_add(e1_dot, e0 * e0_dot);
    // e2_e2_dot_plus_e3_e3_dot + e0_e0_dot_plus_e1_e1_dot
    let w1_dot_value_of_motion = e2_e2_dot_plus_e3_e3_dot + e0_e0_dot_plus_e1_e1_dot;
    let w1_dot_value_of_e0_e1_e2_e3_2 = S::int(2) * w1_dot_value_of_e0_e1_e2_e3;
    // 4*e3'*w1_dot_value_of_e0_e1_e2_e3^2*w1_dot_value_of_motion - e3''*w1_dot_value_of_e0_e1_e2_e3_2
    let w1_dot_value_of_motion_2 = (-e3_ddot)
        .mul_add(
            w1_dot_value_of_e0_e1_e2_e3_2,
            S::int(4) * e3_dot * w1_dot_value_of_e0_e1_e2_e3
                * w1_dot_value_of_e0_e1_e2_e3 * w1_dot_value_of_motion,
        );
    let w1_dot_value_of_motion_3 = w1_dot_value_of_motion * w1_dot_value_of_e0_e1_e2_e3_2;
    // w1_dot_value_of_e0_e1_e2_e3_2*(e0'*w1_dot_value_of_motion_3 - e0'')
    let w1_dot_value_of_motion_4 = w1_dot_value_of_e0_e1_e2_e3_2
        * e0_dot.mul_add(w1_dot_value_of_motion_3, -e0_ddot);
    // w1_dot_value_of_e0_e1_e2_e3_2*(e1'*w1_dot_value_of_motion_3 - e1'')
    let w1_dot_value_of_motion_5 = w1_dot_value_of_e0_e1_e2_e3_2
        * e1_dot.mul_add(w1_dot_value_of_motion_3, -e1_ddot);
    // w1_dot_value_of_e0_e1_e2_e3_2*(e2'*w1_dot_value_of_motion_3 - e2'')
    let w1_dot_value_of_motion_6 = w1_dot_value_of_e0_e1_e2_e3_2
        * e2_dot.mul_add(w1_dot_value_of_motion_3, -e2_ddot);
    // Values.
    // w1' = 4*(e1*e0' - e0*e1' - e3*e2' + e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2
    //   + e3^2)^2 + 2*(e0*e1'' - e1*e0'' + e3*e2'' - e2*e3'')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w1_dot_value = e1
        .mul_add(w1_dot_value_of_motion_4, e2 * w1_dot_value_of_motion_2)
        - e0 * w1_dot_value_of_motion_5 - e3 * w1_dot_value_of_motion_6;
    // w2' = 4*(e2*e0' - e0*e2' + e3*e1' - e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2
    //   + e3^2)^2 + 2*(e0*e2'' - e2*e0'' - e3*e1'' + e1*e3'')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w2_dot_value = (-e1)
        .mul_add(w1_dot_value_of_motion_2, e2 * w1_dot_value_of_motion_4)
        + e3 * w1_dot_value_of_motion_5 - e0 * w1_dot_value_of_motion_6;
    // w3' = 4*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2
    //   + e3^2)^2 + 2*(e2*e1'' - e3*e0'' - e1*e2'' + e0*e3'')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w3_dot_value = (-e0)
        .mul_add(w1_dot_value_of_motion_2, e3 * w1_dot_value_of_motion_4)
        - e2 * w1_dot_value_of_motion_5 + e1 * w1_dot_value_of_motion_6;
    // s' = phi''
    let s_dot_value = phi_ddot;
    [w1_dot_value, w2_dot_value, w3_dot_value, s_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 24 operations.
#[must_use]
pub fn motion_variables<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 4],
) -> [S; 5] {
    let [e0, e1, e2, e3, _] = *q;
    let [w1, w2, w3, s] = *u;
    // Shared terms.
    let w1_halved = S::ratio(1, 2) * w1;
    let w2_halved = S::ratio(1, 2) * w2;
    let w3_halved = S::ratio(1, 2) * w3;
    // Values.
    // e0' = -e1*w1/2 - e2*w2/2 - e3*w3/2
    let e0_dot_value = (-e2).mul_add(w2_halved, -e1 * w1_halved) - e3 * w3_halved;
    // e1' = e0*w1/2 - e3*w2/2 + e2*w3/2
    let e1_dot_value = (-e3).mul_add(w2_halved, e0 * w1_halved) + e2 * w3_halved;
    // e2' = e3*w1/2 + e0*w2/2 - e1*w3/2
    let e2_dot_value = e0.mul_add(w2_halved, e3 * w1_halved) - e1 * w3_halved;
    // e3' = e1*w2/2 - e2*w1/2 + e0*w3/2
    let e3_dot_value = (-e2).mul_add(w1_halved, e1 * w2_halved) + e0 * w3_halved;
    // phi' = s
    let phi_dot_value = s;
    [e0_dot_value, e1_dot_value, e2_dot_value, e3_dot_value, phi_dot_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 292 operations, 1 other function.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> ([S; 5], [S; 5]) {
    let Parameters { A, B, C, J, K, T, .. } = *p;
    let [e0, e1, e2, e3, _] = *q;
    let [e0_dot, e1_dot, e2_dot, e3_dot, phi_dot] = *q_dot;
    // Elimination, step by step, each after the terms that it shares.
    let e3_e2_dot = e3 * e2_dot;
    // e0*e1' - e1*e0' - e2*e3' + e3_e2_dot
    let w_S_1_of_motion = (-e1).mul_add(e0_dot, e0 * e1_dot) - e2 * e3_dot + e3_e2_dot;
    let e3_sq = e3 * e3;
    // e0^2 + e1^2 + e2^2 + e3_sq
    let w_S_1_of_e0_e1_e2_e3 = e1.mul_add(e1, e0 * e0) + e2 * e2 + e3_sq;
    let w_s_1_of_e0_e1_e2_e3_inv = S::int(1) / w_S_1_of_e0_e1_e2_e3;
    // w_S_1 = (e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_1 = w_S_1_of_motion * w_s_1_of_e0_e1_e2_e3_inv;
    // e0*e2' - e2*e0' - e3*e1' + e1*e3'
    let w_S_2_of_motion = (-e2).mul_add(e0_dot, e0 * e2_dot) - e3 * e1_dot + e1 * e3_dot;
    // w_S_2 = (e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_2 = w_s_1_of_e0_e1_e2_e3_inv * w_S_2_of_motion;
    // e2*e1' - e3*e0' - e1*e2' + e0*e3'
    let w_S_3_of_motion = (-e3).mul_add(e0_dot, e2 * e1_dot) - e1 * e2_dot + e0 * e3_dot;
    // w_S_3 = (e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_3 = w_s_1_of_e0_e1_e2_e3_inv * w_S_3_of_motion;
    let w_S_in_axle_base_1_of_ = (S::int(3)).sqrt();
    // 1/(3 + sqrt(3))
    let w_S_in_axle_base_1_of__2 = S::int(1) / (S::int(3) + w_S_in_axle_base_1_of_);
    // w_S_in_axle_base_1_of__2 - 1
    let w_S_in_axle_base_1_of__3 = w_S_in_axle_base_1_of__2 - S::int(1);
    let w_S_in_axle_base_1_of_motion = w_S_3_of_motion * w_S_in_axle_base_1_of_;
    // w_S_2_of_motion*w_S_in_axle_base_1_of__2 + w_S_1_of_motion*w_S_in_axle_base_1_of__3
    let w_S_in_axle_base_1_of_motion_2 = w_S_1_of_motion
        .mul_add(w_S_in_axle_base_1_of__3, w_S_2_of_motion * w_S_in_axle_base_1_of__2);
    // w_S_in_axle_base_1_of_motion + 3*w_S_in_axle_base_1_of_motion_2
    let w_S_in_axle_base_1_of_motion_3 = w_S_in_axle_base_1_of_motion_2
        .mul_add(S::int(3), w_S_in_axle_base_1_of_motion);
    // w_S_in_axle_base_1 = 3*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2
    //   + e3^2) + 3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)) +
    //   sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_1 = w_s_1_of_e0_e1_e2_e3_inv * w_S_in_axle_base_1_of_motion_3;
    // w_S_1_of_motion*w_S_in_axle_base_1_of__2 + w_S_2_of_motion*w_S_in_axle_base_1_of__3
    let w_S_in_axle_base_2_of_motion = w_S_2_of_motion
        .mul_add(w_S_in_axle_base_1_of__3, w_S_1_of_motion * w_S_in_axle_base_1_of__2);
    // w_S_in_axle_base_1_of_motion + 3*w_S_in_axle_base_2_of_motion
    let w_S_in_axle_base_2_of_motion_2 = w_S_in_axle_base_2_of_motion
        .mul_add(S::int(3), w_S_in_axle_base_1_of_motion);
    // w_S_in_axle_base_2 = 3*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 +
    //   e3^2)) + 3*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2) +
    //   sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_2 = w_s_1_of_e0_e1_e2_e3_inv * w_S_in_axle_base_2_of_motion_2;
    // sqrt(3)*(w_S_1_of_motion + w_S_2_of_motion) + w_S_in_axle_base_1_of_motion
    let w_S_in_axle_base_3_of_motion = w_S_in_axle_base_1_of_
        * (w_S_1_of_motion + w_S_2_of_motion) + w_S_in_axle_base_1_of_motion;
    // w_S_in_axle_base_3 = sqrt(3)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2) +
    //   sqrt(3)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2) + sqrt(3)*(e2*e1' - e3*e0' -
    //   e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_3 = w_s_1_of_e0_e1_e2_e3_inv * w_S_in_axle_base_3_of_motion;
    // w_W_turn1_3 = 3*phi' + 2*w_S_in_axle_base_3
    let w_W_turn1_3 = w_S_in_axle_base_3.mul_add(S::int(2), S::int(3) * phi_dot);
    // H_bus_1 = A*w_S_1
    let H_bus_1 = A * w_S_1;
    // H_bus_2 = B*w_S_2
    let H_bus_2 = B * w_S_2;
    // H_bus_3 = C*w_S_3
    let H_bus_3 = C * w_S_3;
    // H_wheel_1 = K*w_S_in_axle_base_1
    let H_wheel_1 = K * w_S_in_axle_base_1;
    // H_wheel_2 = K*w_S_in_axle_base_2
    let H_wheel_2 = K * w_S_in_axle_base_2;
    // H_wheel_3 = J*w_W_turn1_3
    let H_wheel_3 = J * w_W_turn1_3;
    // e2*e2' + e3*e3'
    let e2_e2_dot_plus_e3_e3_dot = e3.mul_add(e3_dot, e2 * e2_dot);
    // e1*e1' + e2_e2_dot_plus_e3_e3_dot
    let w_S_1_2_of_motion = e1.mul_add(e1_dot, e2_e2_dot_plus_e3_e3_dot);
    let w_S_1_2_of_e0_e1_e2_e3 = w_s_1_of_e0_e1_e2_e3_inv * w_s_1_of_e0_e1_e2_e3_inv;
    // w_S_1_2_of_e0_e1_e2_e3*(e0*e0' + w_S_1_2_of_motion)
    let w_S_1_2_of_motion_2 = w_S_1_2_of_e0_e1_e2_e3 * e0.mul_add(e0_dot, w_S_1_2_of_motion);
    // w_S_1_2 = (e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2
    let w_S_1_2 = w_S_1_of_motion * w_S_1_2_of_motion_2;
    // w_S_2_2 = (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2
    let w_S_2_2 = w_S_2_of_motion * w_S_1_2_of_motion_2;
    // w_S_3_2 = (e2*e1' - e3*e0' - e1*e2' + e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2
    let w_S_3_2 = w_S_3_of_motion * w_S_1_2_of_motion_2;
    // w_S_in_axle_base_1_2 = 3*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1'
    //   + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' +
    //   e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + sqrt(3)*(e2*e1' - e3*e0' -
    //   e1*e2' + e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_1_2 = w_S_in_axle_base_1_of_motion_3 * w_S_1_2_of_motion_2;
    // w_S_in_axle_base_2_2 = 3*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3
    //   + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + 3*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + sqrt(3)*(e2*e1' - e3*e0'
    //   - e1*e2' + e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_2_2 = w_S_in_axle_base_2_of_motion_2 * w_S_1_2_of_motion_2;
    // w_S_in_axle_base_3_2 = sqrt(3)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' +
    //   e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + sqrt(3)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1'
    //   + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + sqrt(3)*(e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_3_2 = w_S_in_axle_base_3_of_motion * w_S_1_2_of_motion_2;
    // H_bus_1_2 = A*w_S_1_2
    let H_bus_1_2 = A * w_S_1_2;
    // H_bus_2_2 = B*w_S_2_2
    let H_bus_2_2 = B * w_S_2_2;
    // H_bus_3_2 = C*w_S_3_2
    let H_bus_3_2 = C * w_S_3_2;
    // H_wheel_1_2 = K*w_S_in_axle_base_1_2
    let H_wheel_1_2 = K * w_S_in_axle_base_1_2;
    // H_wheel_2_2 = K*w_S_in_axle_base_2_2
    let H_wheel_2_2 = K * w_S_in_axle_base_2_2;
    // H_wheel_3_2 = J*w_S_in_axle_base_3_2
    let H_wheel_3_2 = J * w_S_in_axle_base_3_2;
    // H_wheel_1_2 + H_wheel_2_2
    let r1_of_place = H_wheel_1_2 + H_wheel_2_2;
    // H_wheel_3_2 + r1_of_place
    let r1_of_place_2 = H_wheel_3_2 + r1_of_place;
    let r1_of_place_2_doubled = S::int(2) * r1_of_place_2;
    // e1' - e2'
    let e1_dot_minus_e2_dot = e1_dot - e2_dot;
    // H_wheel_1 + H_wheel_2
    let h_wheel_1_plus_h_wheel_2 = H_wheel_1 + H_wheel_2;
    // h_wheel_1_plus_h_wheel_2 - H_wheel_3
    let r1_of_place_3 = h_wheel_1_plus_h_wheel_2 - H_wheel_3;
    // e1' + e2'
    let e1_dot_plus_e2_dot = e1_dot + e2_dot;
    // e0' + e3'
    let e0_dot_plus_e3_dot = e0_dot + e3_dot;
    // e0' - e3'
    let e0_dot_minus_e3_dot = e0_dot - e3_dot;
    // H_wheel_1 - H_wheel_2
    let r1_of_place_4 = H_wheel_1 - H_wheel_2;
    let w_s_2_of_motion_times_18 = S::int(18) * w_S_2_of_motion;
    let w_s_1_of_motion_times_18 = S::int(18) * w_S_1_of_motion;
    // 1/(3*A + 2*K)
    let r1_of_a_k = S::int(1) / K.mul_add(S::int(2), S::int(3) * A);
    let k_r1_of_a_k = K * r1_of_a_k;
    // 3*T + 4*H_wheel_3_2
    let r1_of_place_5 = H_wheel_3_2.mul_add(S::int(4), S::int(3) * T);
    let r1_of_place_6 = r1_of_place_5 * w_S_in_axle_base_1_of_;
    // H_wheel_3 + 2*h_wheel_1_plus_h_wheel_2
    let r1_of_place_7 = h_wheel_1_plus_h_wheel_2.mul_add(S::int(2), H_wheel_3);
    let r1_of_motion = w_S_3_of_motion * r1_of_place_3;
    // w_S_1_of_e0_e1_e2_e3*(r1_of_place - 2*H_wheel_3_2)
    let r1_of_place_8 = w_S_1_of_e0_e1_e2_e3 * (-H_wheel_3_2).mul_add(S::int(2), r1_of_place);
    let w_s_3_of_motion_times_3 = S::int(3) * w_S_3_of_motion;
    // H_wheel_1_2 - H_wheel_2_2
    let r1_of_place_9 = H_wheel_1_2 - H_wheel_2_2;
    let r1_of_e0_e1_e2_e3 = S::int(3) * w_S_1_of_e0_e1_e2_e3;
    // H_bus_3*w_s_2_of_motion_times_18 + sqrt(3)*(w_S_2_of_motion*r1_of_place_7 + r1_of_motion +
    //   r1_of_place_8) - w_s_3_of_motion_times_3*(6*H_bus_2 + r1_of_place_4) +
    //   r1_of_e0_e1_e2_e3*(r1_of_place_9 - 6*H_bus_1_2)
    let r1_of_motion_2 = w_S_in_axle_base_1_of_
        * (w_S_2_of_motion.mul_add(r1_of_place_7, r1_of_motion) + r1_of_place_8)
        + H_bus_3 * w_s_2_of_motion_times_18
        - w_s_3_of_motion_times_3 * H_bus_2.mul_add(S::int(6), r1_of_place_4)
        + r1_of_e0_e1_e2_e3 * (-H_bus_1_2).mul_add(S::int(6), r1_of_place_9);
    let r1_of_e0_e1_e2_e3_2 = S::int(2) * w_s_1_of_e0_e1_e2_e3_inv;
    // r1_of_e0_e1_e2_e3_2*(H_bus_3*w_s_1_of_motion_times_18 + sqrt(3)*(w_S_1_of_motion*r1_of_place_7 +
    //   r1_of_motion - r1_of_place_8) + w_s_3_of_motion_times_3*(r1_of_place_4 - 6*H_bus_1) +
    //   r1_of_e0_e1_e2_e3*(6*H_bus_2_2 + r1_of_place_9) - k_r1_of_a_k*r1_of_motion_2)
    let r1_of_motion_3 = r1_of_e0_e1_e2_e3_2
        * (w_S_in_axle_base_1_of_
            * (w_S_1_of_motion.mul_add(r1_of_place_7, r1_of_motion) - r1_of_place_8)
            + H_bus_3 * w_s_1_of_motion_times_18
            + w_s_3_of_motion_times_3 * (-H_bus_1).mul_add(S::int(6), r1_of_place_4)
            + r1_of_e0_e1_e2_e3 * H_bus_2_2.mul_add(S::int(6), r1_of_place_9)
            - k_r1_of_a_k * r1_of_motion_2);
    // A + K
    let a_plus_k = A + K;
    let k_r1_of_a_k_a_plus_k = k_r1_of_a_k * a_plus_k;
    // K*(k_r1_of_a_k - 2)
    let r1_of_a_k_2 = K * (k_r1_of_a_k - S::int(2));
    // 1/(3*B - r1_of_a_k_2)
    let r1_of_a_b_k = S::int(1) / B.mul_add(S::int(3), -r1_of_a_k_2);
    let r1_of_a_b_k_by_3 = S::ratio(1, 3) * r1_of_a_b_k;
    // r1_of_place_6 + r1_of_motion_2*r1_of_e0_e1_e2_e3_2
    let r1_of_motion_4 = r1_of_motion_2.mul_add(r1_of_e0_e1_e2_e3_2, r1_of_place_6);
    // r1_of_place_6 + k_r1_of_a_k*r1_of_motion_4
    let r1_of_motion_5 = k_r1_of_a_k.mul_add(r1_of_motion_4, r1_of_place_6);
    // r1 = 2*(18*H_bus_3_2*(e0^2 + e1^2 + e2^2 + e3^2) - 18*H_bus_1*(e2*e0' - e0*e2' + e3*e1' - e1*e3') -
    //   18*H_bus_2*(e0*e1' - e1*e0' + e3*e2' - e2*e3') - 3*H_wheel_1*(e0*(e1' + e2') - e3*(e1' - e2') -
    //   e2*(e0' + e3') - e1*(e0' - e3')) - 3*H_wheel_2*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' + e3') +
    //   e1*(e0' - e3')) - sqrt(3)*(e0*(e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e2'*(H_wheel_1 + H_wheel_2
    //   - H_wheel_3) - 2*e0*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) - e3*(e1'*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) + e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*e3*(H_wheel_1_2 + H_wheel_2_2 +
    //   H_wheel_3_2)) + e1*(e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e3'*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) - 2*e1*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)) + e2*(e0'*(H_wheel_3 - H_wheel_1 -
    //   H_wheel_2) + e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*e2*(H_wheel_1_2 + H_wheel_2_2 +
    //   H_wheel_3_2))))/(9*(e0^2 + e1^2 + e2^2 + e3^2)) - sqrt(3)*(3*T + 4*H_wheel_3_2)/9 - K*(sqrt(3)*(3*T
    //   + 4*H_wheel_3_2) + 2*(18*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 3*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 -
    //   6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*((e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) + (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + (e0^2 +
    //   e1^2 + e2^2 + e3^2)*(H_wheel_1_2 + H_wheel_2_2 - 2*H_wheel_3_2)))/(e0^2 + e1^2 + e2^2 +
    //   e3^2))/(9*(3*A + 2*K)) + K*(A + K)*(2*(18*H_bus_3*(e0*e1' - e1*e0' + e3*e2' - e2*e3') + 3*(e3*e0' -
    //   e2*e1' + e1*e2' - e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 3*(e0^2 + e1^2 + e2^2 +
    //   e3^2)*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2) - K*(18*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')
    //   + 3*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 3*(e0^2 + e1^2 + e2^2
    //   + e3^2)*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*((e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 + H_wheel_2_2 -
    //   2*H_wheel_3_2)))/(3*A + 2*K) + sqrt(3)*((e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) + (e0*e1' - e1*e0' + e3*e2' - e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + (e0^2 +
    //   e1^2 + e2^2 + e3^2)*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 + e3^2) -
    //   sqrt(3)*(1 + K/(3*A + 2*K))*(3*T + 4*H_wheel_3_2))/(3*(3*A + 2*K)*(3*B + K*(2 - K/(3*A + 2*K))))
    let r1 = S::ratio(2, 9) * w_s_1_of_e0_e1_e2_e3_inv
        * (w_S_in_axle_base_1_of_
            * (e0 * e1_dot_minus_e2_dot.mul_add(r1_of_place_3, e0 * r1_of_place_2_doubled)
                + e3
                    * r1_of_place_3
                        .mul_add(e1_dot_plus_e2_dot, e3 * r1_of_place_2_doubled)
                + e1
                    * (-r1_of_place_3)
                        .mul_add(e0_dot_plus_e3_dot, e1 * r1_of_place_2_doubled)
                + e2
                    * r1_of_place_3
                        .mul_add(e0_dot_minus_e3_dot, e2 * r1_of_place_2_doubled))
            + S::int(18) * H_bus_3_2 * w_S_1_of_e0_e1_e2_e3
            + S::int(3) * r1_of_place_4
                * ((-e0).mul_add(e1_dot_plus_e2_dot, e3 * e1_dot_minus_e2_dot)
                    + e2 * e0_dot_plus_e3_dot + e1 * e0_dot_minus_e3_dot)
            + H_bus_1 * w_s_2_of_motion_times_18 - H_bus_2 * w_s_1_of_motion_times_18)
        + k_r1_of_a_k_a_plus_k * r1_of_a_b_k_by_3
            * (r1_of_motion_3 - r1_of_place_6 * (S::int(1) + k_r1_of_a_k))
        - S::ratio(1, 9) * r1_of_motion_5;
    // w3' = 3*r1/(3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A + K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A +
    //   2*K)))))
    let w3_dot = S::int(3) * r1
        / (C.mul_add(S::int(3), -r1_of_a_k_2)
            - S::int(9) * k_r1_of_a_k_a_plus_k * k_r1_of_a_k_a_plus_k * r1_of_a_b_k);
    // w2' = -(sqrt(3)*(3*T + 4*H_wheel_3_2) + 2*(K*(18*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') +
    //   3*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 3*(e0^2 + e1^2 + e2^2 +
    //   e3^2)*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*((e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 + H_wheel_2_2 -
    //   2*H_wheel_3_2)))/(3*A + 2*K) - 18*H_bus_3*(e0*e1' - e1*e0' + e3*e2' - e2*e3') - 3*(e3*e0' - e2*e1' +
    //   e1*e2' - e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) - 3*(e0^2 + e1^2 + e2^2 + e3^2)*(6*H_bus_2_2 +
    //   H_wheel_1_2 - H_wheel_2_2) - sqrt(3)*((e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) + (e0*e1' - e1*e0' + e3*e2' - e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + (e0^2 +
    //   e1^2 + e2^2 + e3^2)*(2*H_wheel_3_2 - H_wheel_1_2 - H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 + e3^2) +
    //   K*(sqrt(3)*(3*T + 4*H_wheel_3_2) - 9*w3'*(A + K))/(3*A + 2*K))/(3*(3*B + K*(2 - K/(3*A + 2*K))))
    let w2_dot = r1_of_a_b_k_by_3
        * (r1_of_motion_3 - r1_of_place_6
            - k_r1_of_a_k * (-(w3_dot * a_plus_k)).mul_add(S::int(9), r1_of_place_6));
    // w2' + w3'
    let w2_dot_plus_w3_dot = w2_dot + w3_dot;
    // w1' = (3*K*(w2' + w3') - sqrt(3)*(3*T + 4*H_wheel_3_2) - 2*(18*H_bus_3*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 3*(e0^2 + e1^2
    //   + e2^2 + e3^2)*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*((e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 + H_wheel_2_2 -
    //   2*H_wheel_3_2)))/(e0^2 + e1^2 + e2^2 + e3^2))/(3*(3*A + 2*K))
    let w1_dot = S::ratio(1, 3) * r1_of_a_k
        * (K * w2_dot_plus_w3_dot).mul_add(S::int(3), -r1_of_motion_4);
    // sqrt(3)*(w1' + w2_dot_plus_w3_dot) - r1_of_place_5/J
    let s_dot_of_motion = w_S_in_axle_base_1_of_ * (w1_dot + w2_dot_plus_w3_dot)
        - r1_of_place_5 / J;
    // s' = (3*T + 4*H_wheel_3_2)/(3*J) - sqrt(3)*(w1' + w2' + w3')/3
    let s_dot = -S::ratio(1, 3) * s_dot_of_motion;
    let w1_dot_halved = S::ratio(1, 2) * w1_dot;
    let w2_dot_halved = S::ratio(1, 2) * w2_dot;
    let w3_dot_halved = S::ratio(1, 2) * w3_dot;
    let e1_dot_sq = e1_dot * e1_dot;
    let e2_dot_sq = e2_dot * e2_dot;
    // e1_dot_sq + e2_dot_sq
    let e1_dot_sq_plus_e2_dot_sq = e1_dot_sq + e2_dot_sq;
    let e3_dot_sq = e3_dot * e3_dot;
    let e0_dot_sq = e0_dot * e0_dot;
    // e3_dot_sq + e0_dot_sq
    let e3_dot_sq_plus_e0_dot_sq = e3_dot_sq + e0_dot_sq;
    // w_S_1_2_of_e0_e1_e2_e3*(e0*(e0*(e1_dot_sq_plus_e2_dot_sq + e3_dot_sq) - 2*e0'*w_S_1_2_of_motion) +
    //   e3_sq*(e1_dot_sq_plus_e2_dot_sq + e0_dot_sq) + e1*(e1*(e2_dot_sq + e3_dot_sq_plus_e0_dot_sq) -
    //   2*e1'*e2_e2_dot_plus_e3_e3_dot) + e2*(e2*(e1_dot_sq + e3_dot_sq_plus_e0_dot_sq) - 2*e3'*e3_e2_dot))
    let e0_ddot_of_motion = w_S_1_2_of_e0_e1_e2_e3
        * (e0
            * (e0 * (e1_dot_sq_plus_e2_dot_sq + e3_dot_sq) - S::int(2) * e0_dot * w_S_1_2_of_motion)
            + e3_sq * (e1_dot_sq_plus_e2_dot_sq + e0_dot_sq)
            + e1
                * (e1 * (e2_dot_sq + e3_dot_sq_plus_e0_dot_sq)
                    - S::int(2) * e1_dot * e2_e2_dot_plus_e3_e3_dot)
            + e2
                * (e2 * (e1_dot_sq + e3_dot_sq_plus_e0_dot_sq) - S::int(2) * e3_dot * e3_e2_dot));
    // e0'' = -e0*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' +
    //   e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 +
    //   e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2 - e1*w1'/2 - e2*w2'/2 - e3*w3'/2
    let e0_ddot = (-e2).mul_add(w2_dot_halved, -e1 * w1_dot_halved) - e3 * w3_dot_halved
        - e0 * e0_ddot_of_motion;
    // e1'' = e0*w1'/2 - e1*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1'
    //   + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 +
    //   e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2 - e3*w2'/2 + e2*w3'/2
    let e1_ddot = (-e3).mul_add(w2_dot_halved, e0 * w1_dot_halved) + e2 * w3_dot_halved
        - e1 * e0_ddot_of_motion;
    // e2'' = e3*w1'/2 - e2*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1'
    //   + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 +
    //   e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2 + e0*w2'/2 - e1*w3'/2
    let e2_ddot = e0.mul_add(w2_dot_halved, e3 * w1_dot_halved) - e1 * w3_dot_halved
        - e2 * e0_ddot_of_motion;
    // e3'' = e1*w2'/2 - e3*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1'
    //   + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 +
    //   e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2 - e2*w1'/2 + e0*w3'/2
    let e3_ddot = (-e2).mul_add(w1_dot_halved, e1 * w2_dot_halved) + e0 * w3_dot_halved
        - e3 * e0_ddot_of_motion;
    // phi'' = s'
    let phi_ddot = s_dot;
    // Values.
    // e0'
    let e0_dot_value = e0_dot;
    // e1'
    let e1_dot_value = e1_dot;
    // e2'
    let e2_dot_value = e2_dot;
    // e3'
    let e3_dot_value = e3_dot;
    // phi'
    let phi_dot_value = phi_dot;
    (
        [e0_dot_value, e1_dot_value, e2_dot_value, e3_dot_value, phi_dot_value],
        [e0_ddot, e1_ddot, e2_ddot, e3_ddot, phi_ddot],
    )
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 7 operations.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 5], _q_dot: &[S; 5]) -> [S; 1] {
    let [e0, e1, e2, e3, _] = *q;
    // Values.
    // divisor1 = e0^2 + e1^2 + e2^2 + e3^2
    let divisor1 = e1.mul_add(e1, e0 * e0) + e2 * e2 + e3 * e3;
    [divisor1]
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 16 operations.
#[must_use]
pub fn constraints<S: Scalar>(_p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> [S; 2] {
    let [e0, e1, e2, e3, _] = *q;
    let [e0_dot, e1_dot, e2_dot, e3_dot, _] = *q_dot;
    // Shared terms.
    // e0*e0' + e1*e1'
    let e0_e0_dot_plus_e1_e1_dot = e1.mul_add(e1_dot, e0 * e0_dot);
    // e2*e2' + e3*e3'
    let e2_e2_dot_plus_e3_e3_dot = e3.mul_add(e3_dot, e2 * e2_dot);
    // e0_e0_dot_plus_e1_e1_dot + e2_e2_dot_plus_e3_e3_dot
    let residual2_of_motion = e0_e0_dot_plus_e1_e1_dot + e2_e2_dot_plus_e3_e3_dot;
    // Values.
    // S_norm = e0^2 - 1 + e1^2 + e2^2 + e3^2
    let residual1 = e0.mul_add(e0, -S::int(1)) + e1 * e1 + e2 * e2 + e3 * e3;
    // S_norm' = 2*e0*e0' + 2*e1*e1' + 2*e2*e2' + 2*e3*e3'
    let residual2 = S::int(2) * residual2_of_motion;
    [residual1, residual2]
}

/// Slopes of the constraints, one after the other, along e0, e1, e2, e3, phi, e0', e1', e2', e3', phi'.
///
/// 8 operations.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 20] {
    let [e0, e1, e2, e3, _] = *q;
    let [e0_dot, e1_dot, e2_dot, e3_dot, _] = *q_dot;
    // Shared terms.
    let e0_doubled = S::int(2) * e0;
    let e2_doubled = S::int(2) * e2;
    let e3_doubled = S::int(2) * e3;
    let e1_doubled = S::int(2) * e1;
    // Values.
    // d(S_norm)/d(e0) = 2*e0
    let residual1_by_e0 = e0_doubled;
    // d(S_norm)/d(e1) = 2*e1
    let residual1_by_e1 = e1_doubled;
    // d(S_norm)/d(e2) = 2*e2
    let residual1_by_e2 = e2_doubled;
    // d(S_norm)/d(e3) = 2*e3
    let residual1_by_e3 = e3_doubled;
    // d(S_norm')/d(e0) = 2*e0'
    let residual2_by_e0 = S::int(2) * e0_dot;
    // d(S_norm')/d(e1) = 2*e1'
    let residual2_by_e1 = S::int(2) * e1_dot;
    // d(S_norm')/d(e2) = 2*e2'
    let residual2_by_e2 = S::int(2) * e2_dot;
    // d(S_norm')/d(e3) = 2*e3'
    let residual2_by_e3 = S::int(2) * e3_dot;
    // d(S_norm')/d(e0') = 2*e0
    let residual2_by_e0_dot = e0_doubled;
    // d(S_norm')/d(e1') = 2*e1
    let residual2_by_e1_dot = e1_doubled;
    // d(S_norm')/d(e2') = 2*e2
    let residual2_by_e2_dot = e2_doubled;
    // d(S_norm')/d(e3') = 2*e3
    let residual2_by_e3_dot = e3_doubled;
    let zero = S::int(0);
    [
        residual1_by_e0, residual1_by_e1, residual1_by_e2, residual1_by_e3, zero, zero, zero, zero,
        zero, zero, residual2_by_e0, residual2_by_e1, residual2_by_e2, residual2_by_e3, zero,
        residual2_by_e0_dot, residual2_by_e1_dot, residual2_by_e2_dot, residual2_by_e3_dot, zero,
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
    let (of_q, of_v) = derivative(&p, &q, &v);
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
            parameters: 8,
            coordinates: 5,
            variables: 5,
            speeds: 4,
            reactions: 1,
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
        9
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
                let (of_q, of_v) = derivative(
                    &Parameters::from_slice(p),
                    array(q),
                    array(v),
                );
                q_dot.copy_from_slice(&of_q);
                v_dot.copy_from_slice(&of_v);
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
        ["e0^2 + e1^2 + e2^2 + e3^2"][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn constraint_count(&self) -> usize {
        2
    }
    fn constraint_name(&self, at: usize) -> &str {
        ["S_norm", "S_norm'"][at]
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
