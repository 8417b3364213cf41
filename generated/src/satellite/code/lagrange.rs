//! Satellite with a reaction wheel: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/satellite/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

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
/// 470 operations, 1 other function.
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
    let e0_e3_dot = e0 * e3_dot;
    let e3_e0_dot = e3 * e0_dot;
    // e0_e3_dot - e3_e0_dot
    let w_S_3_of_motion = e0_e3_dot - e3_e0_dot;
    let e1_e2_dot = e1 * e2_dot;
    let e2_e1_dot = e2 * e1_dot;
    // e2_e1_dot - e1_e2_dot
    let w_S_3_of_motion_2 = e2_e1_dot - e1_e2_dot;
    // w_S_3_of_motion + w_S_3_of_motion_2
    let w_S_3_of_motion_3 = w_S_3_of_motion + w_S_3_of_motion_2;
    // w_S_3 = (e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_3 = w_S_1_of_e0_e1_e2_e3 * w_S_3_of_motion_3;
    let w_S_in_axle_base_1_of_ = (S::int(3)).sqrt();
    // 1/(3 + sqrt(3))
    let w_S_in_axle_base_1_of__2 = S::int(1) / (S::int(3) + w_S_in_axle_base_1_of_);
    // w_S_in_axle_base_1_of__2 - 1
    let w_S_in_axle_base_1_of__3 = w_S_in_axle_base_1_of__2 - S::int(1);
    let w_S_in_axle_base_1_of_motion = w_S_3_of_motion_3 * w_S_in_axle_base_1_of_;
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
    let e2_e2_dot = e2 * e2_dot;
    let e3_e3_dot = e3 * e3_dot;
    // e2_e2_dot + e3_e3_dot
    let e2_e2_dot_plus_e3_e3_dot = e2_e2_dot + e3_e3_dot;
    let e0_e0_dot = e0 * e0_dot;
    let e1_e1_dot = e1 * e1_dot;
    // w_S_1_of_e0_e1_e2_e3^2*(e2_e2_dot_plus_e3_e3_dot + e0_e0_dot + e1_e1_dot)
    let w_S_1_2_of_motion = w_S_1_of_e0_e1_e2_e3 * w_S_1_of_e0_e1_e2_e3
        * (e2_e2_dot_plus_e3_e3_dot + e0_e0_dot + e1_e1_dot);
    // w_S_1_2 = (e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2
    let w_S_1_2 = w_S_1_of_motion * w_S_1_2_of_motion;
    // w_S_2_2 = (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2
    let w_S_2_2 = w_S_2_of_motion * w_S_1_2_of_motion;
    // w_S_3_2 = (e2*e1' - e3*e0' - e1*e2' + e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2
    let w_S_3_2 = w_S_3_of_motion_3 * w_S_1_2_of_motion;
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
    // e1' + e2'
    let e1_dot_plus_e2_dot = e1_dot + e2_dot;
    // e1' - e2'
    let e1_dot_minus_e2_dot = e1_dot - e2_dot;
    let e3_e1_dot_minus_e2_dot = e3 * e1_dot_minus_e2_dot;
    // H_wheel_1 + H_wheel_2
    let h_wheel_1_plus_h_wheel_2 = H_wheel_1 + H_wheel_2;
    let f1_of_place = S::int(2) * h_wheel_1_plus_h_wheel_2;
    // 3*H_bus_2 - H_wheel_2
    let f1_of_place_2 = H_bus_2.mul_add(S::int(3), -H_wheel_2);
    // 3*H_bus_1 - H_wheel_1
    let f1_of_place_3 = H_bus_1.mul_add(S::int(3), -H_wheel_1);
    // e1 - e2
    let e1_minus_e2 = e1 - e2;
    let e0_e1_dot_plus_e2_dot = e0 * e1_dot_plus_e2_dot;
    // e0_e1_dot_plus_e2_dot - e3_e1_dot_minus_e2_dot
    let f1_of_motion = e0_e1_dot_plus_e2_dot - e3_e1_dot_minus_e2_dot;
    let f1_of_ = S::int(6) * w_S_in_axle_base_1_of__2;
    // e2'*f1_of_place_2 + e1'*f1_of_place_3
    let f1_of_motion_2 = e1_dot.mul_add(f1_of_place_3, e2_dot * f1_of_place_2);
    let h_bus_3_times_3 = S::int(3) * H_bus_3;
    let e0_times_6 = S::int(6) * e0;
    // e1'*f1_of_place_2 - e2'*f1_of_place_3
    let f1_of_motion_3 = (-e2_dot).mul_add(f1_of_place_3, e1_dot * f1_of_place_2);
    let e3_times_6 = S::int(6) * e3;
    let h_bus_3_times_18 = S::int(18) * H_bus_3;
    // -w_S_3_of_motion_2*h_bus_3_times_18
    let f1_of_motion_4 = -w_S_3_of_motion_2 * h_bus_3_times_18;
    // H_wheel_3*sqrt(3) + h_wheel_1_plus_h_wheel_2*f1_of_
    let f1_of_place_4 = h_wheel_1_plus_h_wheel_2
        .mul_add(f1_of_, H_wheel_3 * w_S_in_axle_base_1_of_);
    // 6*f1_of_place_3 + f1_of_place_4
    let f1_of_place_5 = f1_of_place_3.mul_add(S::int(6), f1_of_place_4);
    // 6*f1_of_place_2 + f1_of_place_4
    let f1_of_place_6 = f1_of_place_2.mul_add(S::int(6), f1_of_place_4);
    // H_wheel_3 + f1_of_place
    let f1_of_place_7 = H_wheel_3 + f1_of_place;
    // h_bus_3_times_18 + f1_of_place_7*sqrt(3)
    let f1_of_place_8 = f1_of_place_7.mul_add(w_S_in_axle_base_1_of_, h_bus_3_times_18);
    let e3_f1_of_place_8 = e3 * f1_of_place_8;
    let f1_of_motion_5 = e2_e2_dot_plus_e3_e3_dot * f1_of_place_5;
    let e2_dot_f1_of_place_8 = e2_dot * f1_of_place_8;
    let e2_e2_dot_f1_of_place_6 = e2_e2_dot * f1_of_place_6;
    // H_wheel_1_2 + H_wheel_2_2
    let f1_of_place_9 = H_wheel_1_2 + H_wheel_2_2;
    // H_wheel_3_2 + f1_of_place_9
    let f1_of_place_10 = H_wheel_3_2 + f1_of_place_9;
    let f1_of_place_10_doubled = S::int(2) * f1_of_place_10;
    // e1 + e2
    let e1_plus_e2 = e1 + e2;
    let h_wheel_3_2_doubled = S::int(2) * H_wheel_3_2;
    // 3*H_bus_1_2 - H_wheel_1_2
    let f1_of_place_11 = H_bus_1_2.mul_add(S::int(3), -H_wheel_1_2);
    let e1_times_6 = S::int(6) * e1;
    // 3*H_bus_2_2 - H_wheel_2_2
    let f1_of_place_12 = H_bus_2_2.mul_add(S::int(3), -H_wheel_2_2);
    let e2_times_6 = S::int(6) * e2;
    let h_bus_3_2_times_18 = S::int(18) * H_bus_3_2;
    let f1_of_e0_e1_e2_e3 = S::ratio(4, 9) * w_S_1_of_e0_e1_e2_e3;
    // e0' - e3'
    let e0_dot_minus_e3_dot = e0_dot - e3_dot;
    // e0' + e3'
    let e0_dot_plus_e3_dot = e0_dot + e3_dot;
    let e2_e0_dot_plus_e3_dot = e2 * e0_dot_plus_e3_dot;
    // e0 + e3
    let e0_plus_e3 = e0 + e3;
    let e1_e0_dot_minus_e3_dot = e1 * e0_dot_minus_e3_dot;
    // e2_e0_dot_plus_e3_dot + e1_e0_dot_minus_e3_dot
    let f2_of_motion = e2_e0_dot_plus_e3_dot + e1_e0_dot_minus_e3_dot;
    // e0'*f1_of_place_3 - e3'*f1_of_place_2
    let f2_of_motion_2 = (-e3_dot).mul_add(f1_of_place_2, e0_dot * f1_of_place_3);
    // e0'*f1_of_place_2 + e3'*f1_of_place_3
    let f2_of_motion_3 = e3_dot.mul_add(f1_of_place_3, e0_dot * f1_of_place_2);
    let f2_of_motion_4 = w_S_3_of_motion * h_bus_3_times_18;
    let e2_f1_of_place_8 = e2 * f1_of_place_8;
    let e3_dot_f1_of_place_8 = e3_dot * f1_of_place_8;
    let e3_e3_dot_f1_of_place_6 = e3_e3_dot * f1_of_place_6;
    // e0 - e3
    let e0_minus_e3 = e0 - e3;
    let e1_f1_of_place_8 = e1 * f1_of_place_8;
    let e0_f1_of_place_8 = e0 * f1_of_place_8;
    // e0'^2 + e1'^2
    let e0_dot_sq_plus_e1_dot_sq = e1_dot.mul_add(e1_dot, e0_dot * e0_dot);
    // e2'^2 + e3'^2
    let e2_dot_sq_plus_e3_dot_sq = e3_dot.mul_add(e3_dot, e2_dot * e2_dot);
    // e0_dot_sq_plus_e1_dot_sq + e2_dot_sq_plus_e3_dot_sq
    let f6_of_motion = e0_dot_sq_plus_e1_dot_sq + e2_dot_sq_plus_e3_dot_sq;
    // Values.
    // f1 = 4*(18*e3'*H_bus_3 + 6*e1'*(3*H_bus_1 - H_wheel_1) + 6*e2'*(3*H_bus_2 - H_wheel_2) -
    //   (e0*(18*H_bus_3*(e2*e1' - e1*e2') - 6*(H_wheel_1*(e3*(e1' - e2') - e0*(e1' + e2') + e3'*(e2 - e1)) +
    //   H_wheel_2*(e3*(e1' - e2') - e0*(e1' + e2') + e3'*(e2 - e1)))/(3 + sqrt(3)) + 6*e0*(3*e3'*H_bus_3 +
    //   e1'*(3*H_bus_1 - H_wheel_1) + e2'*(3*H_bus_2 - H_wheel_2)) - 6*e3*(e2'*(H_wheel_1 - 3*H_bus_1) +
    //   e1'*(3*H_bus_2 - H_wheel_2)) + 6*e3'*(e2*(H_wheel_1 - 3*H_bus_1) + e1*(3*H_bus_2 - H_wheel_2)) +
    //   sqrt(3)*(2*H_wheel_1*(e2*e1' - e1*e2' + e0*e3') + 2*H_wheel_2*(e2*e1' - e1*e2' + e0*e3') +
    //   H_wheel_3*(e3*(e2' - e1') + e0*(e1' + e2' + e3') + e1*(e3' - e2') + e2*(e1' - e3')))) +
    //   e3^2*e3'*(18*H_bus_3 + sqrt(3)*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3)) + e1*(e2*e2'*(18*H_bus_1 -
    //   6*H_wheel_1 + 6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3)) + e3*e3'*(18*H_bus_1 -
    //   6*H_wheel_1 + 6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3)) + e1'*(e1*(18*H_bus_1 -
    //   6*H_wheel_1 + 6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3)) + e2*(18*H_bus_2 -
    //   6*H_wheel_2 + 6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3)) + e3*(18*H_bus_3 +
    //   sqrt(3)*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3)))) + e2*(e2*e2'*(18*H_bus_2 - 6*H_wheel_2 +
    //   6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3)) + e3*(e3'*(18*H_bus_2 - 6*H_wheel_2 +
    //   6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3)) + e2'*(18*H_bus_3 +
    //   sqrt(3)*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3)))))/(e0^2 + e1^2 + e2^2 + e3^2) - 18*e3*H_bus_3_2 +
    //   6*e1*(H_wheel_1_2 - 3*H_bus_1_2) + 6*(e1'*(H_wheel_1 + H_wheel_2) - e1*(H_wheel_1_2 + H_wheel_2_2) +
    //   e2'*(H_wheel_1 + H_wheel_2) - e2*(H_wheel_1_2 + H_wheel_2_2))/(3 + sqrt(3)) + 6*e2*(H_wheel_2_2 -
    //   3*H_bus_2_2) + sqrt(3)*(H_wheel_3*(e1' + e2') - 2*H_wheel_3_2*(e1 + e2) + e3'*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) - 2*e3*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)))/(9*(e0^2 + e1^2 + e2^2 +
    //   e3^2))
    let f1 = f1_of_e0_e1_e2_e3
        * (S::int(6) * f1_of_motion_2 + e3_dot * h_bus_3_times_18
            + w_S_1_of_e0_e1_e2_e3
                * (e0
                    * (w_S_in_axle_base_1_of_
                        * (H_wheel_3
                            * (e1 * (e2_dot - e3_dot) + e2 * (e3_dot - e1_dot)
                                - e0 * (e3_dot + e1_dot_plus_e2_dot) + e3_e1_dot_minus_e2_dot)
                            - f1_of_place * (e0_e3_dot + w_S_3_of_motion_2))
                        + S::int(6) * e3_dot * (-e1).mul_add(f1_of_place_2, e2 * f1_of_place_3)
                        - h_wheel_1_plus_h_wheel_2 * f1_of_
                            * e3_dot.mul_add(e1_minus_e2, f1_of_motion)
                        - e0_times_6 * e3_dot.mul_add(h_bus_3_times_3, f1_of_motion_2)
                        + f1_of_motion_3 * e3_times_6 + f1_of_motion_4)
                    - e3_e3_dot * e3_f1_of_place_8
                    - e1
                        * (e1_dot
                            * (e2.mul_add(f1_of_place_6, e1 * f1_of_place_5)
                                + e3_f1_of_place_8) + f1_of_motion_5)
                    - e2
                        * (e3 * e3_dot.mul_add(f1_of_place_6, e2_dot_f1_of_place_8)
                            + e2_e2_dot_f1_of_place_6))
            + f1_of_
                * (-f1_of_place_9)
                    .mul_add(e1_plus_e2, e1_dot_plus_e2_dot * h_wheel_1_plus_h_wheel_2)
            + w_S_in_axle_base_1_of_
                * (e3_dot.mul_add(f1_of_place_7, H_wheel_3 * e1_dot_plus_e2_dot)
                    - e3 * f1_of_place_10_doubled - e1_plus_e2 * h_wheel_3_2_doubled)
            - f1_of_place_11 * e1_times_6 - f1_of_place_12 * e2_times_6 - e3 * h_bus_3_2_times_18);
    // f2 = 4*(18*e2*H_bus_3_2 - 18*e2'*H_bus_3 - 6*e0'*(3*H_bus_1 - H_wheel_1) - 6*e3'*(H_wheel_2 -
    //   3*H_bus_2) - (e3*(e3*e3'*(18*H_bus_2 - 6*H_wheel_2 + 6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) +
    //   H_wheel_3*sqrt(3)) + e2*(e2'*(18*H_bus_2 - 6*H_wheel_2 + 6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) +
    //   H_wheel_3*sqrt(3)) - e3'*(18*H_bus_3 + sqrt(3)*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3)))) -
    //   e2^2*e2'*(18*H_bus_3 + sqrt(3)*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3)) - e1*(18*H_bus_3*(e3*e0' -
    //   e0*e3') + 6*(H_wheel_1*(e2*(e0' + e3') - e2'*(e0 + e3) + e1*(e0' - e3')) + H_wheel_2*(e2*(e0' + e3')
    //   - e2'*(e0 + e3) + e1*(e0' - e3')))/(3 + sqrt(3)) + 6*e1*(3*e2'*H_bus_3 + e0'*(3*H_bus_1 - H_wheel_1)
    //   + e3'*(H_wheel_2 - 3*H_bus_2)) + 6*e2*(e3'*(3*H_bus_1 - H_wheel_1) + e0'*(3*H_bus_2 - H_wheel_2)) -
    //   6*e2'*(e3*(3*H_bus_1 - H_wheel_1) + e0*(3*H_bus_2 - H_wheel_2)) + sqrt(3)*(2*H_wheel_1*(e3*e0' -
    //   e0*e3' + e1*e2') + 2*H_wheel_2*(e3*e0' - e0*e3' + e1*e2') + H_wheel_3*(e3*(e0' - e2') + e1*(e0' +
    //   e2' - e3') - e0*(e2' + e3') + e2*(e0' + e3')))) - e0*(e2*e2'*(18*H_bus_1 - 6*H_wheel_1 +
    //   6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3)) + e3*e3'*(18*H_bus_1 - 6*H_wheel_1 +
    //   6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3)) + e0'*(e0*(18*H_bus_1 - 6*H_wheel_1 +
    //   6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3)) + e3*(6*H_wheel_2 - 18*H_bus_2 -
    //   6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) - H_wheel_3*sqrt(3)) + e2*(18*H_bus_3 + sqrt(3)*(2*H_wheel_1
    //   + 2*H_wheel_2 + H_wheel_3)))))/(e0^2 + e1^2 + e2^2 + e3^2) - 6*e0*(H_wheel_1_2 - 3*H_bus_1_2) -
    //   6*e3*(3*H_bus_2_2 - H_wheel_2_2) - 6*(e0'*(H_wheel_1 + H_wheel_2) - e3'*(H_wheel_1 + H_wheel_2) -
    //   e0*(H_wheel_1_2 + H_wheel_2_2) + e3*(H_wheel_1_2 + H_wheel_2_2))/(3 + sqrt(3)) -
    //   sqrt(3)*(e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) - H_wheel_3*(e3' - e0') - 2*H_wheel_3_2*(e0 -
    //   e3) - 2*e2*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)))/(9*(e0^2 + e1^2 + e2^2 + e3^2))
    let f2 = f1_of_e0_e1_e2_e3
        * (e0_times_6 * f1_of_place_11 - e2_dot * h_bus_3_times_18
            - e3_times_6 * f1_of_place_12 + e2 * h_bus_3_2_times_18 - S::int(6) * f2_of_motion_2
            - w_S_1_of_e0_e1_e2_e3
                * (e1
                    * (S::int(6) * e2_dot * e3.mul_add(f1_of_place_3, e0 * f1_of_place_2)
                        + w_S_in_axle_base_1_of_
                            * (f1_of_place * (w_S_3_of_motion - e1_e2_dot)
                                + H_wheel_3
                                    * (e3 * (e2_dot - e0_dot) + e0 * (e2_dot + e3_dot)
                                        - e1 * (e2_dot + e0_dot_minus_e3_dot)
                                        - e2_e0_dot_plus_e3_dot))
                        + h_wheel_1_plus_h_wheel_2 * f1_of_
                            * e2_dot.mul_add(e0_plus_e3, -f2_of_motion)
                        - e1_times_6 * e2_dot.mul_add(h_bus_3_times_3, f2_of_motion_2)
                        - e2_times_6 * f2_of_motion_3 + f2_of_motion_4)
                    - e2_e2_dot * e2_f1_of_place_8
                    - e0
                        * (f1_of_motion_5
                            + e0_dot
                                * ((-e3).mul_add(f1_of_place_6, e0 * f1_of_place_5)
                                    + e2_f1_of_place_8))
                    + e3
                        * (e2 * e2_dot.mul_add(f1_of_place_6, -e3_dot_f1_of_place_8)
                            + e3_e3_dot_f1_of_place_6))
            - w_S_in_axle_base_1_of_
                * ((-e2).mul_add(f1_of_place_10_doubled, e2_dot * f1_of_place_7)
                    + H_wheel_3 * e0_dot_minus_e3_dot - h_wheel_3_2_doubled * e0_minus_e3)
            - f1_of_
                * (-f1_of_place_9)
                    .mul_add(
                        e0_minus_e3,
                        h_wheel_1_plus_h_wheel_2 * e0_dot_minus_e3_dot,
                    ));
    // f3 = 4*(18*e1'*H_bus_3 - 6*e3'*(3*H_bus_1 - H_wheel_1) - 6*e0'*(3*H_bus_2 - H_wheel_2) -
    //   (e1^2*e1'*(18*H_bus_3 + sqrt(3)*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3)) + e2*(18*H_bus_3*(e0*e3' -
    //   e3*e0') - 6*(H_wheel_1*(e1'*(e3 - e0) + e2*(e0' + e3') + e1*(e0' - e3')) + H_wheel_2*(e1'*(e3 - e0)
    //   + e2*(e0' + e3') + e1*(e0' - e3')))/(3 + sqrt(3)) + 6*e2*(3*e1'*H_bus_3 - e3'*(3*H_bus_1 -
    //   H_wheel_1) - e0'*(3*H_bus_2 - H_wheel_2)) - 6*e1*(e0'*(3*H_bus_1 - H_wheel_1) + e3'*(H_wheel_2 -
    //   3*H_bus_2)) + 6*e1'*(e0*(3*H_bus_1 - H_wheel_1) + e3*(H_wheel_2 - 3*H_bus_2)) -
    //   sqrt(3)*(2*H_wheel_1*(e3*e0' - e2*e1' - e0*e3') + 2*H_wheel_2*(e3*e0' - e2*e1' - e0*e3') +
    //   H_wheel_3*(e3*(e0' + e1') + e1*(e0' - e3') + e2*(e0' - e1' + e3') - e0*(e1' + e3')))) -
    //   e0*(e1*e1'*(18*H_bus_2 - 6*H_wheel_2 + 6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3))
    //   + e3*e3'*(18*H_bus_2 - 6*H_wheel_2 + 6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3)) +
    //   e0'*(e3*(18*H_bus_1 - 6*H_wheel_1 + 6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3)) +
    //   e0*(18*H_bus_2 - 6*H_wheel_2 + 6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3)) -
    //   e1*(18*H_bus_3 + sqrt(3)*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3)))) + e3*(e1*(e1'*(6*H_wheel_1 -
    //   18*H_bus_1 - 6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) - H_wheel_3*sqrt(3)) + e3'*(18*H_bus_3 +
    //   sqrt(3)*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3))) - e3*e3'*(18*H_bus_1 - 6*H_wheel_1 + 6*(H_wheel_1
    //   + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3))))/(e0^2 + e1^2 + e2^2 + e3^2) - 18*e1*H_bus_3_2 -
    //   6*e3*(H_wheel_1_2 - 3*H_bus_1_2) - 6*e0*(H_wheel_2_2 - 3*H_bus_2_2) - 6*(e0'*(H_wheel_1 + H_wheel_2)
    //   - e0*(H_wheel_1_2 + H_wheel_2_2) + e3'*(H_wheel_1 + H_wheel_2) - e3*(H_wheel_1_2 + H_wheel_2_2))/(3
    //   + sqrt(3)) - sqrt(3)*(H_wheel_3*(e0' + e3') - e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) -
    //   2*H_wheel_3_2*(e0 + e3) + 2*e1*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)))/(9*(e0^2 + e1^2 + e2^2 +
    //   e3^2))
    let f3 = f1_of_e0_e1_e2_e3
        * (e1_dot * h_bus_3_times_18 - e1 * h_bus_3_2_times_18
            + e3_times_6 * f1_of_place_11 + e0_times_6 * f1_of_place_12
            - w_S_in_axle_base_1_of_
                * ((-e1_dot).mul_add(f1_of_place_7, e1 * f1_of_place_10_doubled)
                    + H_wheel_3 * e0_dot_plus_e3_dot - h_wheel_3_2_doubled * e0_plus_e3)
            - f1_of_
                * (-f1_of_place_9)
                    .mul_add(e0_plus_e3, h_wheel_1_plus_h_wheel_2 * e0_dot_plus_e3_dot)
            - S::int(6) * f2_of_motion_3
            - w_S_1_of_e0_e1_e2_e3
                * (e3
                    * (e1 * (-e1_dot).mul_add(f1_of_place_5, e3_dot_f1_of_place_8)
                        - e3_e3_dot * f1_of_place_5)
                    + e2
                        * (S::int(6) * e1_dot * (-e3).mul_add(f1_of_place_2, e0 * f1_of_place_3)
                            + w_S_in_axle_base_1_of_
                                * (f1_of_place * (w_S_3_of_motion + e2_e1_dot)
                                    + H_wheel_3
                                        * (e0 * (e1_dot + e3_dot) - e3 * (e0_dot + e1_dot)
                                            + e2 * (e1_dot - e0_dot_plus_e3_dot)
                                            - e1_e0_dot_minus_e3_dot)) - e1_times_6 * f2_of_motion_2
                            + e2_times_6 * e1_dot.mul_add(h_bus_3_times_3, -f2_of_motion_3)
                            + f2_of_motion_4
                            + h_wheel_1_plus_h_wheel_2 * f1_of_
                                * e1_dot.mul_add(e0_minus_e3, -f2_of_motion))
                    + e1_e1_dot * e1_f1_of_place_8
                    - e0
                        * (e3_e3_dot_f1_of_place_6 + e1_e1_dot * f1_of_place_6
                            + e0_dot
                                * (e3.mul_add(f1_of_place_5, -e1_f1_of_place_8)
                                    + e0 * f1_of_place_6))));
    // f4 = 4*((e0^2*e0'*(18*H_bus_3 + sqrt(3)*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3)) +
    //   e3*(18*H_bus_3*(e1*e2' - e2*e1') + 6*(H_wheel_1*(e0'*(e1 + e2) + e3*(e1' - e2') - e0*(e1' + e2')) +
    //   H_wheel_2*(e0'*(e1 + e2) + e3*(e1' - e2') - e0*(e1' + e2')))/(3 + sqrt(3)) + 6*e3*(3*e0'*H_bus_3 +
    //   e2'*(H_wheel_1 - 3*H_bus_1) + e1'*(3*H_bus_2 - H_wheel_2)) - 6*e0*(e1'*(3*H_bus_1 - H_wheel_1) +
    //   e2'*(3*H_bus_2 - H_wheel_2)) + 6*e0'*(e1*(3*H_bus_1 - H_wheel_1) + e2*(3*H_bus_2 - H_wheel_2)) -
    //   sqrt(3)*(2*H_wheel_1*(e2*e1' - e3*e0' - e1*e2') + 2*H_wheel_2*(e2*e1' - e3*e0' - e1*e2') +
    //   H_wheel_3*(e2*(e1' - e0') + e0*(e1' + e2') + e3*(e2' - e0' - e1') - e1*(e0' + e2')))) +
    //   e1*(e0*e0'*(18*H_bus_2 - 6*H_wheel_2 + 6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3))
    //   + e2*e2'*(18*H_bus_2 - 6*H_wheel_2 + 6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3)) +
    //   e1'*(e2*(6*H_wheel_1 - 18*H_bus_1 - 6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) - H_wheel_3*sqrt(3)) +
    //   e1*(18*H_bus_2 - 6*H_wheel_2 + 6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3)) +
    //   e0*(18*H_bus_3 + sqrt(3)*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3)))) + e2*(e0*(e0'*(6*H_wheel_1 -
    //   18*H_bus_1 - 6*(H_wheel_1 + H_wheel_2)/(3 + sqrt(3)) - H_wheel_3*sqrt(3)) + e2'*(18*H_bus_3 +
    //   sqrt(3)*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3))) - e2*e2'*(18*H_bus_1 - 6*H_wheel_1 + 6*(H_wheel_1
    //   + H_wheel_2)/(3 + sqrt(3)) + H_wheel_3*sqrt(3))))/(e0^2 + e1^2 + e2^2 + e3^2) - 18*e0'*H_bus_3 -
    //   6*e2'*(H_wheel_1 - 3*H_bus_1) - 6*e1'*(3*H_bus_2 - H_wheel_2) + 18*e0*H_bus_3_2 - 6*e2*(3*H_bus_1_2
    //   - H_wheel_1_2) - 6*e1*(H_wheel_2_2 - 3*H_bus_2_2) - 6*(e1'*(H_wheel_1 + H_wheel_2) - e2'*(H_wheel_1
    //   + H_wheel_2) - e1*(H_wheel_1_2 + H_wheel_2_2) + e2*(H_wheel_1_2 + H_wheel_2_2))/(3 + sqrt(3)) -
    //   sqrt(3)*(e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) - H_wheel_3*(e2' - e1') - 2*H_wheel_3_2*(e1 -
    //   e2) - 2*e0*(H_wheel_1_2 + H_wheel_2_2 + H_wheel_3_2)))/(9*(e0^2 + e1^2 + e2^2 + e3^2))
    let f4 = f1_of_e0_e1_e2_e3
        * (e1_times_6 * f1_of_place_12 - S::int(6) * f1_of_motion_3 - e0_dot * h_bus_3_times_18
            - f1_of_
                * (-e1_minus_e2)
                    .mul_add(
                        f1_of_place_9,
                        e1_dot_minus_e2_dot * h_wheel_1_plus_h_wheel_2,
                    )
            - w_S_in_axle_base_1_of_
                * (e0_dot.mul_add(f1_of_place_7, H_wheel_3 * e1_dot_minus_e2_dot)
                    - e0 * f1_of_place_10_doubled - e1_minus_e2 * h_wheel_3_2_doubled)
            - f1_of_place_11 * e2_times_6 + e0 * h_bus_3_2_times_18
            + w_S_1_of_e0_e1_e2_e3
                * (e2
                    * (e0 * (-e0_dot).mul_add(f1_of_place_5, e2_dot_f1_of_place_8)
                        - e2_e2_dot * f1_of_place_5)
                    + e3
                        * (S::int(6) * e0_dot * e1.mul_add(f1_of_place_3, e2 * f1_of_place_2)
                            + w_S_in_axle_base_1_of_
                                * (f1_of_place * (e3_e0_dot - w_S_3_of_motion_2)
                                    + H_wheel_3
                                        * (e2 * (e0_dot - e1_dot) + e1 * (e0_dot + e2_dot)
                                            + e3 * (e0_dot + e1_dot_minus_e2_dot)
                                            - e0_e1_dot_plus_e2_dot)) - f1_of_motion_2 * e0_times_6
                            + e3_times_6 * e0_dot.mul_add(h_bus_3_times_3, f1_of_motion_3)
                            + f1_of_motion_4
                            + h_wheel_1_plus_h_wheel_2 * f1_of_
                                * e0_dot.mul_add(e1_plus_e2, -f1_of_motion))
                    + e0_e0_dot * e0_f1_of_place_8
                    + e1
                        * (e2_e2_dot_f1_of_place_6 + e0_e0_dot * f1_of_place_6
                            + e1_dot
                                * ((-e2).mul_add(f1_of_place_5, e1 * f1_of_place_6)
                                    + e0_f1_of_place_8))));
    // f5 = T + 4*H_wheel_3_2/3
    let f5 = T + S::ratio(4, 3) * H_wheel_3_2;
    // f6 = -2*e0'^2 - 2*e1'^2 - 2*e2'^2 - 2*e3'^2
    let f6 = -S::int(2) * f6_of_motion;
    [f1, f2, f3, f4, f5, f6]
}

/// The accelerations (e0'', e1'', e2'', e3'', phi''), solved for when this code was generated.
///
/// 338 operations, 1 other function.
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
    let t_times_3 = S::int(3) * T;
    // t_times_3 - 4*r1_of_place
    let r1_of_place_2 = (-r1_of_place).mul_add(S::int(4), t_times_3);
    // e1' - e2'
    let e1_dot_minus_e2_dot = e1_dot - e2_dot;
    // H_wheel_1 + H_wheel_2
    let h_wheel_1_plus_h_wheel_2 = H_wheel_1 + H_wheel_2;
    // h_wheel_1_plus_h_wheel_2 - H_wheel_3
    let r1_of_place_3 = h_wheel_1_plus_h_wheel_2 - H_wheel_3;
    let r1_of_place_3_doubled = S::int(2) * r1_of_place_3;
    // e0' + e3'
    let e0_dot_plus_e3_dot = e0_dot + e3_dot;
    // e0' - e3'
    let e0_dot_minus_e3_dot = e0_dot - e3_dot;
    // e1' + e2'
    let e1_dot_plus_e2_dot = e1_dot + e2_dot;
    // 2*r1_of_place + t_times_3
    let r1_of_place_4 = r1_of_place.mul_add(S::int(2), t_times_3);
    // H_wheel_3 + 2*h_wheel_1_plus_h_wheel_2
    let r1_of_place_5 = h_wheel_1_plus_h_wheel_2.mul_add(S::int(2), H_wheel_3);
    let r1_of_place_5_doubled = S::int(2) * r1_of_place_5;
    // 1/(3*A + 2*K)
    let r1_of_a_k = S::int(1) / K.mul_add(S::int(2), S::int(3) * A);
    let k_r1_of_a_k = K * r1_of_a_k;
    let w_s_2_of_motion_times_36 = S::int(36) * w_S_2_of_motion;
    let w_s_1_of_motion_times_36 = S::int(36) * w_S_1_of_motion;
    // H_wheel_1 - H_wheel_2
    let r1_of_place_6 = H_wheel_1 - H_wheel_2;
    // H_wheel_1_2 - H_wheel_2_2
    let r1_of_place_7 = H_wheel_1_2 - H_wheel_2_2;
    // 6*H_bus_1_2 - r1_of_place_7
    let r1_of_place_8 = H_bus_1_2.mul_add(S::int(6), -r1_of_place_7);
    // 6*H_bus_2 + r1_of_place_6
    let r1_of_place_9 = H_bus_2.mul_add(S::int(6), r1_of_place_6);
    let h_bus_3_times_6 = S::int(6) * H_bus_3;
    // r1_of_place_6*(e3*e1_dot_minus_e2_dot + e2*e0_dot_plus_e3_dot + e1*e0_dot_minus_e3_dot -
    //   e0*e1_dot_plus_e2_dot) + k_r1_of_a_k*(e2*(e2*r1_of_place_8 + e1'*r1_of_place_9 +
    //   e0'*h_bus_3_times_6) + e3*(e3*r1_of_place_8 - e0'*r1_of_place_9 + e1'*h_bus_3_times_6) +
    //   e0*(e0*r1_of_place_8 + e3'*r1_of_place_9 - e2'*h_bus_3_times_6) + e1*(e1*r1_of_place_8 -
    //   e2'*r1_of_place_9 - e3'*h_bus_3_times_6))
    let r1_of_motion = r1_of_place_6
        * (e2.mul_add(e0_dot_plus_e3_dot, e3 * e1_dot_minus_e2_dot)
            + e1 * e0_dot_minus_e3_dot - e0 * e1_dot_plus_e2_dot)
        + k_r1_of_a_k
            * (e2
                * (e1_dot.mul_add(r1_of_place_9, e2 * r1_of_place_8) + e0_dot * h_bus_3_times_6)
                + e3
                    * ((-e0_dot).mul_add(r1_of_place_9, e3 * r1_of_place_8)
                        + e1_dot * h_bus_3_times_6)
                + e0
                    * (e3_dot.mul_add(r1_of_place_9, e0 * r1_of_place_8) - e2_dot * h_bus_3_times_6)
                + e1
                    * ((-e2_dot).mul_add(r1_of_place_9, e1 * r1_of_place_8)
                        - e3_dot * h_bus_3_times_6));
    // r1 = (36*H_bus_1*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 36*H_bus_2*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3') + 6*H_wheel_1*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' + e3') + e1*(e0' - e3')) +
    //   6*H_wheel_2*(e0*(e1' + e2') - e3*(e1' - e2') - e2*(e0' + e3') - e1*(e0' - e3')) + 36*H_bus_3_2*(e0^2
    //   + e1^2 + e2^2 + e3^2) + 6*K*(e2*(6*e0'*H_bus_3 + e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) +
    //   e2*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) - e0*(6*e2'*H_bus_3 + e3'*(H_wheel_2 - 6*H_bus_2 -
    //   H_wheel_1) + e0*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2)) - e1*(6*e3'*H_bus_3 + e2'*(6*H_bus_2 +
    //   H_wheel_1 - H_wheel_2) + e1*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2)) + e3*(6*e1'*H_bus_3 +
    //   e0'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) + e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)))/(3*A + 2*K)
    //   + sqrt(3)*(e3*(2*e1'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + e3*(4*H_wheel_1_2 - 3*T + 4*H_wheel_2_2)) - K*(e0*(2*e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   2*e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e0*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)) +
    //   e1*(2*e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*e2'*(H_wheel_3 - H_wheel_1 - H_wheel_2) +
    //   e1*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)) + e2*(e2*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) -
    //   2*e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) - 2*e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2)) +
    //   e3*(e3*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) - 2*e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) -
    //   2*e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3)))/(3*A + 2*K) - e0*(2*e1'*(H_wheel_3 - H_wheel_1 -
    //   H_wheel_2) + 2*e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e0*(3*T - 4*H_wheel_1_2 - 4*H_wheel_2_2)) -
    //   e1*(2*e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e1*(3*T
    //   - 4*H_wheel_1_2 - 4*H_wheel_2_2)) - e2*(2*e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + 2*e3'*(H_wheel_1
    //   + H_wheel_2 - H_wheel_3) + e2*(3*T - 4*H_wheel_1_2 - 4*H_wheel_2_2))))/(9*(e0^2 + e1^2 + e2^2 +
    //   e3^2))
    let r1 = S::ratio(1, 9) * w_s_1_of_e0_e1_e2_e3_inv
        * (-w_S_in_axle_base_1_of_
            * (e0
                * (-e1_dot_minus_e2_dot)
                    .mul_add(r1_of_place_3_doubled, e0 * r1_of_place_2)
                + e1
                    * r1_of_place_3_doubled
                        .mul_add(e0_dot_plus_e3_dot, e1 * r1_of_place_2)
                + e2
                    * (-r1_of_place_3_doubled)
                        .mul_add(e0_dot_minus_e3_dot, e2 * r1_of_place_2)
                + e3
                    * (-r1_of_place_3_doubled)
                        .mul_add(e1_dot_plus_e2_dot, e3 * r1_of_place_2)
                + k_r1_of_a_k
                    * (e0
                        * (e0.mul_add(r1_of_place_4, e3_dot * r1_of_place_3_doubled)
                            + e2_dot * r1_of_place_5_doubled)
                        + e1
                            * ((-e2_dot)
                                .mul_add(r1_of_place_3_doubled, e1 * r1_of_place_4)
                                + e3_dot * r1_of_place_5_doubled)
                        + e2
                            * (e2.mul_add(r1_of_place_4, e1_dot * r1_of_place_3_doubled)
                                - e0_dot * r1_of_place_5_doubled)
                        + e3
                            * ((-e0_dot)
                                .mul_add(r1_of_place_3_doubled, e3 * r1_of_place_4)
                                - e1_dot * r1_of_place_5_doubled)))
            + S::int(36) * H_bus_3_2 * w_S_1_of_e0_e1_e2_e3
            + H_bus_1 * w_s_2_of_motion_times_36 - H_bus_2 * w_s_1_of_motion_times_36
            + S::int(6) * r1_of_motion);
    let w3_dot_of_place = w_S_1_of_e0_e1_e2_e3 * r1_of_place_4;
    let w3_dot_of_motion = w_S_3_of_motion * r1_of_place_3_doubled;
    let w3_dot_of_e0_e1_e2_e3 = S::int(6) * w_S_1_of_e0_e1_e2_e3;
    let w_s_3_of_motion_times_6 = S::int(6) * w_S_3_of_motion;
    // H_bus_3*w_s_2_of_motion_times_36 + sqrt(3)*(w_S_2_of_motion*r1_of_place_5_doubled + w3_dot_of_place
    //   + w3_dot_of_motion) - r1_of_place_8*w3_dot_of_e0_e1_e2_e3 - r1_of_place_9*w_s_3_of_motion_times_6
    let w3_dot_of_motion_2 = w_S_in_axle_base_1_of_
        * (w_S_2_of_motion.mul_add(r1_of_place_5_doubled, w3_dot_of_place)
            + w3_dot_of_motion) + H_bus_3 * w_s_2_of_motion_times_36
        - r1_of_place_8 * w3_dot_of_e0_e1_e2_e3 - r1_of_place_9 * w_s_3_of_motion_times_6;
    // w_s_1_of_e0_e1_e2_e3_inv*(sqrt(3)*(w3_dot_of_place - w_S_1_of_motion*r1_of_place_5_doubled -
    //   w3_dot_of_motion) - H_bus_3*w_s_1_of_motion_times_36 - w3_dot_of_e0_e1_e2_e3*(6*H_bus_2_2 +
    //   r1_of_place_7) + w_s_3_of_motion_times_6*(6*H_bus_1 - r1_of_place_6) +
    //   k_r1_of_a_k*w3_dot_of_motion_2)
    let w3_dot_of_motion_3 = w_s_1_of_e0_e1_e2_e3_inv
        * (w_S_in_axle_base_1_of_
            * ((-w_S_1_of_motion).mul_add(r1_of_place_5_doubled, w3_dot_of_place)
                - w3_dot_of_motion) - H_bus_3 * w_s_1_of_motion_times_36
            - w3_dot_of_e0_e1_e2_e3 * H_bus_2_2.mul_add(S::int(6), r1_of_place_7)
            + w_s_3_of_motion_times_6 * H_bus_1.mul_add(S::int(6), -r1_of_place_6)
            + k_r1_of_a_k * w3_dot_of_motion_2);
    // K*(k_r1_of_a_k - 2)
    let w3_dot_of_a_k = K * (k_r1_of_a_k - S::int(2));
    // 1/(3*B - w3_dot_of_a_k)
    let w3_dot_of_a_b_k = S::int(1) / B.mul_add(S::int(3), -w3_dot_of_a_k);
    // k_r1_of_a_k*(A + K)
    let w3_dot_of_a_k_2 = k_r1_of_a_k * (A + K);
    let w3_dot_of_a_b_k_2 = w3_dot_of_a_b_k * w3_dot_of_a_k_2;
    let w3_dot_of_a_k_2_times_9 = S::int(9) * w3_dot_of_a_k_2;
    // w3' = (3*r1 - K*(A + K)*(36*H_bus_3*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 6*(e2*e1' - e3*e0' -
    //   e1*e2' + e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_2_2 -
    //   6*H_bus_2_2 - H_wheel_1_2) + K*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' - e2*e1'
    //   + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2
    //   - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(3*A + 2*K) +
    //   sqrt(3)*(2*(e1*e0' - e0*e1' - e3*e2' + e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*(e3*e0' -
    //   e2*e1' + e1*e2' - e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T +
    //   2*H_wheel_1_2 + 2*H_wheel_2_2)))/((3*A + 2*K)*(3*B + K*(2 - K/(3*A + 2*K)))*(e0^2 + e1^2 + e2^2 +
    //   e3^2)))/(3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A + K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A +
    //   2*K)))))
    let w3_dot = (-w3_dot_of_motion_3).mul_add(w3_dot_of_a_b_k_2, S::int(3) * r1)
        / (C.mul_add(S::int(3), -w3_dot_of_a_k) - w3_dot_of_a_b_k_2 * w3_dot_of_a_k_2_times_9);
    // w2' = (9*K*w3'*(A + K)/(3*A + 2*K) - (36*H_bus_3*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 6*(e2*e1' -
    //   e3*e0' - e1*e2' + e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 +
    //   e3^2)*(H_wheel_2_2 - 6*H_bus_2_2 - H_wheel_1_2) + K*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')
    //   + 6*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2
    //   + e3^2)*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 +
    //   H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(3*A +
    //   2*K) + sqrt(3)*(2*(e1*e0' - e0*e1' - e3*e2' + e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   2*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 +
    //   e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 + e3^2))/(3*(3*B + K*(2 - K/(3*A +
    //   2*K))))
    let w2_dot = S::ratio(1, 3) * w3_dot_of_a_b_k
        * w3_dot.mul_add(w3_dot_of_a_k_2_times_9, -w3_dot_of_motion_3);
    // w2' + w3'
    let w2_dot_plus_w3_dot = w2_dot + w3_dot;
    // w1' = (3*K*(w2' + w3') - (36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' - e2*e1' +
    //   e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 -
    //   6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 +
    //   e3^2))/(3*(3*A + 2*K))
    let w1_dot = S::ratio(1, 3) * r1_of_a_k
        * (-w_s_1_of_e0_e1_e2_e3_inv)
            .mul_add(w3_dot_of_motion_2, S::int(3) * K * w2_dot_plus_w3_dot);
    // sqrt(3)*(w1' + w2_dot_plus_w3_dot) - (4*H_wheel_3_2 + t_times_3)/J
    let s_dot_of_motion = w_S_in_axle_base_1_of_ * (w1_dot + w2_dot_plus_w3_dot)
        - H_wheel_3_2.mul_add(S::int(4), t_times_3) / J;
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
/// 338 operations, 1 other function.
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
    let t_times_3 = S::int(3) * T;
    // t_times_3 - 4*r1_of_place
    let r1_of_place_2 = (-r1_of_place).mul_add(S::int(4), t_times_3);
    // e1' - e2'
    let e1_dot_minus_e2_dot = e1_dot - e2_dot;
    // H_wheel_1 + H_wheel_2
    let h_wheel_1_plus_h_wheel_2 = H_wheel_1 + H_wheel_2;
    // h_wheel_1_plus_h_wheel_2 - H_wheel_3
    let r1_of_place_3 = h_wheel_1_plus_h_wheel_2 - H_wheel_3;
    let r1_of_place_3_doubled = S::int(2) * r1_of_place_3;
    // e0' + e3'
    let e0_dot_plus_e3_dot = e0_dot + e3_dot;
    // e0' - e3'
    let e0_dot_minus_e3_dot = e0_dot - e3_dot;
    // e1' + e2'
    let e1_dot_plus_e2_dot = e1_dot + e2_dot;
    // 2*r1_of_place + t_times_3
    let r1_of_place_4 = r1_of_place.mul_add(S::int(2), t_times_3);
    // H_wheel_3 + 2*h_wheel_1_plus_h_wheel_2
    let r1_of_place_5 = h_wheel_1_plus_h_wheel_2.mul_add(S::int(2), H_wheel_3);
    let r1_of_place_5_doubled = S::int(2) * r1_of_place_5;
    // 1/(3*A + 2*K)
    let r1_of_a_k = S::int(1) / K.mul_add(S::int(2), S::int(3) * A);
    let k_r1_of_a_k = K * r1_of_a_k;
    let w_s_2_of_motion_times_36 = S::int(36) * w_S_2_of_motion;
    let w_s_1_of_motion_times_36 = S::int(36) * w_S_1_of_motion;
    // H_wheel_1 - H_wheel_2
    let r1_of_place_6 = H_wheel_1 - H_wheel_2;
    // H_wheel_1_2 - H_wheel_2_2
    let r1_of_place_7 = H_wheel_1_2 - H_wheel_2_2;
    // 6*H_bus_1_2 - r1_of_place_7
    let r1_of_place_8 = H_bus_1_2.mul_add(S::int(6), -r1_of_place_7);
    // 6*H_bus_2 + r1_of_place_6
    let r1_of_place_9 = H_bus_2.mul_add(S::int(6), r1_of_place_6);
    let h_bus_3_times_6 = S::int(6) * H_bus_3;
    // r1_of_place_6*(e3*e1_dot_minus_e2_dot + e2*e0_dot_plus_e3_dot + e1*e0_dot_minus_e3_dot -
    //   e0*e1_dot_plus_e2_dot) + k_r1_of_a_k*(e2*(e2*r1_of_place_8 + e1'*r1_of_place_9 +
    //   e0'*h_bus_3_times_6) + e3*(e3*r1_of_place_8 - e0'*r1_of_place_9 + e1'*h_bus_3_times_6) +
    //   e0*(e0*r1_of_place_8 + e3'*r1_of_place_9 - e2'*h_bus_3_times_6) + e1*(e1*r1_of_place_8 -
    //   e2'*r1_of_place_9 - e3'*h_bus_3_times_6))
    let r1_of_motion = r1_of_place_6
        * (e2.mul_add(e0_dot_plus_e3_dot, e3 * e1_dot_minus_e2_dot)
            + e1 * e0_dot_minus_e3_dot - e0 * e1_dot_plus_e2_dot)
        + k_r1_of_a_k
            * (e2
                * (e1_dot.mul_add(r1_of_place_9, e2 * r1_of_place_8) + e0_dot * h_bus_3_times_6)
                + e3
                    * ((-e0_dot).mul_add(r1_of_place_9, e3 * r1_of_place_8)
                        + e1_dot * h_bus_3_times_6)
                + e0
                    * (e3_dot.mul_add(r1_of_place_9, e0 * r1_of_place_8) - e2_dot * h_bus_3_times_6)
                + e1
                    * ((-e2_dot).mul_add(r1_of_place_9, e1 * r1_of_place_8)
                        - e3_dot * h_bus_3_times_6));
    // r1 = (36*H_bus_1*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 36*H_bus_2*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3') + 6*H_wheel_1*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' + e3') + e1*(e0' - e3')) +
    //   6*H_wheel_2*(e0*(e1' + e2') - e3*(e1' - e2') - e2*(e0' + e3') - e1*(e0' - e3')) + 36*H_bus_3_2*(e0^2
    //   + e1^2 + e2^2 + e3^2) + 6*K*(e2*(6*e0'*H_bus_3 + e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) +
    //   e2*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) - e0*(6*e2'*H_bus_3 + e3'*(H_wheel_2 - 6*H_bus_2 -
    //   H_wheel_1) + e0*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2)) - e1*(6*e3'*H_bus_3 + e2'*(6*H_bus_2 +
    //   H_wheel_1 - H_wheel_2) + e1*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2)) + e3*(6*e1'*H_bus_3 +
    //   e0'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) + e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)))/(3*A + 2*K)
    //   + sqrt(3)*(e3*(2*e1'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + e3*(4*H_wheel_1_2 - 3*T + 4*H_wheel_2_2)) - K*(e0*(2*e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   2*e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e0*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)) +
    //   e1*(2*e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*e2'*(H_wheel_3 - H_wheel_1 - H_wheel_2) +
    //   e1*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)) + e2*(e2*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) -
    //   2*e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) - 2*e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2)) +
    //   e3*(e3*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) - 2*e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) -
    //   2*e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3)))/(3*A + 2*K) - e0*(2*e1'*(H_wheel_3 - H_wheel_1 -
    //   H_wheel_2) + 2*e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e0*(3*T - 4*H_wheel_1_2 - 4*H_wheel_2_2)) -
    //   e1*(2*e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e1*(3*T
    //   - 4*H_wheel_1_2 - 4*H_wheel_2_2)) - e2*(2*e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + 2*e3'*(H_wheel_1
    //   + H_wheel_2 - H_wheel_3) + e2*(3*T - 4*H_wheel_1_2 - 4*H_wheel_2_2))))/(9*(e0^2 + e1^2 + e2^2 +
    //   e3^2))
    let r1 = S::ratio(1, 9) * w_s_1_of_e0_e1_e2_e3_inv
        * (-w_S_in_axle_base_1_of_
            * (e0
                * (-e1_dot_minus_e2_dot)
                    .mul_add(r1_of_place_3_doubled, e0 * r1_of_place_2)
                + e1
                    * r1_of_place_3_doubled
                        .mul_add(e0_dot_plus_e3_dot, e1 * r1_of_place_2)
                + e2
                    * (-r1_of_place_3_doubled)
                        .mul_add(e0_dot_minus_e3_dot, e2 * r1_of_place_2)
                + e3
                    * (-r1_of_place_3_doubled)
                        .mul_add(e1_dot_plus_e2_dot, e3 * r1_of_place_2)
                + k_r1_of_a_k
                    * (e0
                        * (e0.mul_add(r1_of_place_4, e3_dot * r1_of_place_3_doubled)
                            + e2_dot * r1_of_place_5_doubled)
                        + e1
                            * ((-e2_dot)
                                .mul_add(r1_of_place_3_doubled, e1 * r1_of_place_4)
                                + e3_dot * r1_of_place_5_doubled)
                        + e2
                            * (e2.mul_add(r1_of_place_4, e1_dot * r1_of_place_3_doubled)
                                - e0_dot * r1_of_place_5_doubled)
                        + e3
                            * ((-e0_dot)
                                .mul_add(r1_of_place_3_doubled, e3 * r1_of_place_4)
                                - e1_dot * r1_of_place_5_doubled)))
            + S::int(36) * H_bus_3_2 * w_S_1_of_e0_e1_e2_e3
            + H_bus_1 * w_s_2_of_motion_times_36 - H_bus_2 * w_s_1_of_motion_times_36
            + S::int(6) * r1_of_motion);
    let w3_dot_of_place = w_S_1_of_e0_e1_e2_e3 * r1_of_place_4;
    let w3_dot_of_motion = w_S_3_of_motion * r1_of_place_3_doubled;
    let w3_dot_of_e0_e1_e2_e3 = S::int(6) * w_S_1_of_e0_e1_e2_e3;
    let w_s_3_of_motion_times_6 = S::int(6) * w_S_3_of_motion;
    // H_bus_3*w_s_2_of_motion_times_36 + sqrt(3)*(w_S_2_of_motion*r1_of_place_5_doubled + w3_dot_of_place
    //   + w3_dot_of_motion) - r1_of_place_8*w3_dot_of_e0_e1_e2_e3 - r1_of_place_9*w_s_3_of_motion_times_6
    let w3_dot_of_motion_2 = w_S_in_axle_base_1_of_
        * (w_S_2_of_motion.mul_add(r1_of_place_5_doubled, w3_dot_of_place)
            + w3_dot_of_motion) + H_bus_3 * w_s_2_of_motion_times_36
        - r1_of_place_8 * w3_dot_of_e0_e1_e2_e3 - r1_of_place_9 * w_s_3_of_motion_times_6;
    // w_s_1_of_e0_e1_e2_e3_inv*(sqrt(3)*(w3_dot_of_place - w_S_1_of_motion*r1_of_place_5_doubled -
    //   w3_dot_of_motion) - H_bus_3*w_s_1_of_motion_times_36 - w3_dot_of_e0_e1_e2_e3*(6*H_bus_2_2 +
    //   r1_of_place_7) + w_s_3_of_motion_times_6*(6*H_bus_1 - r1_of_place_6) +
    //   k_r1_of_a_k*w3_dot_of_motion_2)
    let w3_dot_of_motion_3 = w_s_1_of_e0_e1_e2_e3_inv
        * (w_S_in_axle_base_1_of_
            * ((-w_S_1_of_motion).mul_add(r1_of_place_5_doubled, w3_dot_of_place)
                - w3_dot_of_motion) - H_bus_3 * w_s_1_of_motion_times_36
            - w3_dot_of_e0_e1_e2_e3 * H_bus_2_2.mul_add(S::int(6), r1_of_place_7)
            + w_s_3_of_motion_times_6 * H_bus_1.mul_add(S::int(6), -r1_of_place_6)
            + k_r1_of_a_k * w3_dot_of_motion_2);
    // K*(k_r1_of_a_k - 2)
    let w3_dot_of_a_k = K * (k_r1_of_a_k - S::int(2));
    // 1/(3*B - w3_dot_of_a_k)
    let w3_dot_of_a_b_k = S::int(1) / B.mul_add(S::int(3), -w3_dot_of_a_k);
    // k_r1_of_a_k*(A + K)
    let w3_dot_of_a_k_2 = k_r1_of_a_k * (A + K);
    let w3_dot_of_a_b_k_2 = w3_dot_of_a_b_k * w3_dot_of_a_k_2;
    let w3_dot_of_a_k_2_times_9 = S::int(9) * w3_dot_of_a_k_2;
    // w3' = (3*r1 - K*(A + K)*(36*H_bus_3*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 6*(e2*e1' - e3*e0' -
    //   e1*e2' + e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_2_2 -
    //   6*H_bus_2_2 - H_wheel_1_2) + K*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' - e2*e1'
    //   + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2
    //   - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(3*A + 2*K) +
    //   sqrt(3)*(2*(e1*e0' - e0*e1' - e3*e2' + e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*(e3*e0' -
    //   e2*e1' + e1*e2' - e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T +
    //   2*H_wheel_1_2 + 2*H_wheel_2_2)))/((3*A + 2*K)*(3*B + K*(2 - K/(3*A + 2*K)))*(e0^2 + e1^2 + e2^2 +
    //   e3^2)))/(3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A + K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A +
    //   2*K)))))
    let w3_dot = (-w3_dot_of_motion_3).mul_add(w3_dot_of_a_b_k_2, S::int(3) * r1)
        / (C.mul_add(S::int(3), -w3_dot_of_a_k) - w3_dot_of_a_b_k_2 * w3_dot_of_a_k_2_times_9);
    // w2' = (9*K*w3'*(A + K)/(3*A + 2*K) - (36*H_bus_3*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 6*(e2*e1' -
    //   e3*e0' - e1*e2' + e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 +
    //   e3^2)*(H_wheel_2_2 - 6*H_bus_2_2 - H_wheel_1_2) + K*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')
    //   + 6*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2
    //   + e3^2)*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 +
    //   H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(3*A +
    //   2*K) + sqrt(3)*(2*(e1*e0' - e0*e1' - e3*e2' + e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   2*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 +
    //   e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 + e3^2))/(3*(3*B + K*(2 - K/(3*A +
    //   2*K))))
    let w2_dot = S::ratio(1, 3) * w3_dot_of_a_b_k
        * w3_dot.mul_add(w3_dot_of_a_k_2_times_9, -w3_dot_of_motion_3);
    // w2' + w3'
    let w2_dot_plus_w3_dot = w2_dot + w3_dot;
    // w1' = (3*K*(w2' + w3') - (36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' - e2*e1' +
    //   e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 -
    //   6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 +
    //   e3^2))/(3*(3*A + 2*K))
    let w1_dot = S::ratio(1, 3) * r1_of_a_k
        * (-w_s_1_of_e0_e1_e2_e3_inv)
            .mul_add(w3_dot_of_motion_2, S::int(3) * K * w2_dot_plus_w3_dot);
    // sqrt(3)*(w1' + w2_dot_plus_w3_dot) - (4*H_wheel_3_2 + t_times_3)/J
    let s_dot_of_motion = w_S_in_axle_base_1_of_ * (w1_dot + w2_dot_plus_w3_dot)
        - H_wheel_3_2.mul_add(S::int(4), t_times_3) / J;
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

/// Jacobian of the derivative by the state; columns e0, e1, e2, e3, phi, e0', e1', e2', e3', phi'.
///
/// 2760 operations, 1 other function.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [[S; 10]; 10] {
    let Parameters { A, B, C, J, K, T, .. } = *p;
    let [e0, e1, e2, e3, _] = *q;
    let [e0_dot, e1_dot, e2_dot, e3_dot, phi_dot] = *q_dot;
    // Elimination, step by step, each after the terms that it shares.
    let e0_e1_dot = e0 * e1_dot;
    let e1_e0_dot = e1 * e0_dot;
    // e0_e1_dot - e1_e0_dot
    let w_S_1_of_motion = e0_e1_dot - e1_e0_dot;
    let e2_e3_dot = e2 * e3_dot;
    let e3_e2_dot = e3 * e2_dot;
    // e2_e3_dot - e3_e2_dot
    let w_S_1_of_motion_2 = e2_e3_dot - e3_e2_dot;
    // w_S_1_of_motion - w_S_1_of_motion_2
    let w_S_1_of_motion_3 = w_S_1_of_motion - w_S_1_of_motion_2;
    let e0_sq = e0 * e0;
    let e1_sq = e1 * e1;
    // e0_sq + e1_sq
    let e0_sq_plus_e1_sq = e0_sq + e1_sq;
    let e3_sq = e3 * e3;
    let e2_sq = e2 * e2;
    // e3_sq + e2_sq
    let e3_sq_plus_e2_sq = e3_sq + e2_sq;
    // e0_sq_plus_e1_sq + e3_sq_plus_e2_sq
    let w_S_1_of_e0_e1_e2_e3 = e0_sq_plus_e1_sq + e3_sq_plus_e2_sq;
    let w_s_1_of_e0_e1_e2_e3_inv = S::int(1) / w_S_1_of_e0_e1_e2_e3;
    // w_S_1 = (e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_1 = w_S_1_of_motion_3 * w_s_1_of_e0_e1_e2_e3_inv;
    let e0_e2_dot = e0 * e2_dot;
    let e2_e0_dot = e2 * e0_dot;
    // e0_e2_dot - e2_e0_dot
    let w_S_2_of_motion = e0_e2_dot - e2_e0_dot;
    let e3_e1_dot = e3 * e1_dot;
    let e1_e3_dot = e1 * e3_dot;
    // e3_e1_dot - e1_e3_dot
    let w_S_2_of_motion_2 = e3_e1_dot - e1_e3_dot;
    // w_S_2_of_motion - w_S_2_of_motion_2
    let w_S_2_of_motion_3 = w_S_2_of_motion - w_S_2_of_motion_2;
    // w_S_2 = (e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_2 = w_s_1_of_e0_e1_e2_e3_inv * w_S_2_of_motion_3;
    let e0_e3_dot = e0 * e3_dot;
    let e3_e0_dot = e3 * e0_dot;
    // e0_e3_dot - e3_e0_dot
    let w_S_3_of_motion = e0_e3_dot - e3_e0_dot;
    let e1_e2_dot = e1 * e2_dot;
    let e2_e1_dot = e2 * e1_dot;
    // e2_e1_dot - e1_e2_dot
    let w_S_3_of_motion_2 = e2_e1_dot - e1_e2_dot;
    // w_S_3_of_motion + w_S_3_of_motion_2
    let w_S_3_of_motion_3 = w_S_3_of_motion + w_S_3_of_motion_2;
    // w_S_3 = (e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_3 = w_s_1_of_e0_e1_e2_e3_inv * w_S_3_of_motion_3;
    let w_S_in_axle_base_1_of_ = (S::int(3)).sqrt();
    // 1/(3 + sqrt(3))
    let w_S_in_axle_base_1_of__2 = S::int(1) / (S::int(3) + w_S_in_axle_base_1_of_);
    // w_S_in_axle_base_1_of__2 - 1
    let w_S_in_axle_base_1_of__3 = w_S_in_axle_base_1_of__2 - S::int(1);
    let w_S_in_axle_base_1_of_motion = w_S_3_of_motion_3 * w_S_in_axle_base_1_of_;
    // w_S_2_of_motion_3*w_S_in_axle_base_1_of__2 + w_S_1_of_motion_3*w_S_in_axle_base_1_of__3
    let w_S_in_axle_base_1_of_motion_2 = w_S_1_of_motion_3
        .mul_add(w_S_in_axle_base_1_of__3, w_S_2_of_motion_3 * w_S_in_axle_base_1_of__2);
    // w_S_in_axle_base_1_of_motion + 3*w_S_in_axle_base_1_of_motion_2
    let w_S_in_axle_base_1_of_motion_3 = w_S_in_axle_base_1_of_motion_2
        .mul_add(S::int(3), w_S_in_axle_base_1_of_motion);
    // w_S_in_axle_base_1 = 3*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2
    //   + e3^2) + 3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)) +
    //   sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_1 = w_s_1_of_e0_e1_e2_e3_inv * w_S_in_axle_base_1_of_motion_3;
    // w_S_1_of_motion_3*w_S_in_axle_base_1_of__2 + w_S_2_of_motion_3*w_S_in_axle_base_1_of__3
    let w_S_in_axle_base_2_of_motion = w_S_2_of_motion_3
        .mul_add(w_S_in_axle_base_1_of__3, w_S_1_of_motion_3 * w_S_in_axle_base_1_of__2);
    // w_S_in_axle_base_1_of_motion + 3*w_S_in_axle_base_2_of_motion
    let w_S_in_axle_base_2_of_motion_2 = w_S_in_axle_base_2_of_motion
        .mul_add(S::int(3), w_S_in_axle_base_1_of_motion);
    // w_S_in_axle_base_2 = 3*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 +
    //   e3^2)) + 3*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2) +
    //   sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_2 = w_s_1_of_e0_e1_e2_e3_inv * w_S_in_axle_base_2_of_motion_2;
    let w_S_in_axle_base_3_of_e0_e1_e2_e3 = w_s_1_of_e0_e1_e2_e3_inv * w_S_in_axle_base_1_of_;
    // w_S_1_of_motion_3 + w_S_3_of_motion_3
    let w_S_in_axle_base_3_of_motion = w_S_1_of_motion_3 + w_S_3_of_motion_3;
    // w_S_in_axle_base_3 = sqrt(3)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2) +
    //   sqrt(3)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2) + sqrt(3)*(e2*e1' - e3*e0' -
    //   e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_3 = w_S_in_axle_base_3_of_e0_e1_e2_e3
        * (w_S_2_of_motion_3 + w_S_in_axle_base_3_of_motion);
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
    let e1_e1_dot = e1 * e1_dot;
    let e0_e0_dot = e0 * e0_dot;
    // e1_e1_dot + e0_e0_dot
    let e1_e1_dot_plus_e0_e0_dot = e1_e1_dot + e0_e0_dot;
    let e3_e3_dot = e3 * e3_dot;
    let e2_e2_dot = e2 * e2_dot;
    // e3_e3_dot + e2_e2_dot
    let e3_e3_dot_plus_e2_e2_dot = e3_e3_dot + e2_e2_dot;
    let w_S_1_2_of_e0_e1_e2_e3 = w_s_1_of_e0_e1_e2_e3_inv * w_s_1_of_e0_e1_e2_e3_inv;
    // w_S_1_2_of_e0_e1_e2_e3*(e1_e1_dot_plus_e0_e0_dot + e3_e3_dot_plus_e2_e2_dot)
    let w_S_1_2_of_motion = w_S_1_2_of_e0_e1_e2_e3
        * (e1_e1_dot_plus_e0_e0_dot + e3_e3_dot_plus_e2_e2_dot);
    // w_S_1_2 = (e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2
    let w_S_1_2 = w_S_1_of_motion_3 * w_S_1_2_of_motion;
    // w_S_2_2 = (e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2
    let w_S_2_2 = w_S_2_of_motion_3 * w_S_1_2_of_motion;
    // w_S_3_2 = (e2*e1' - e3*e0' - e1*e2' + e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2
    let w_S_3_2 = w_S_3_of_motion_3 * w_S_1_2_of_motion;
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
    // H_wheel_1_2 + H_wheel_2_2
    let r1_of_place = H_wheel_1_2 + H_wheel_2_2;
    let t_times_3 = S::int(3) * T;
    // t_times_3 - 4*r1_of_place
    let r1_of_place_2 = (-r1_of_place).mul_add(S::int(4), t_times_3);
    // e1' - e2'
    let e1_dot_minus_e2_dot = e1_dot - e2_dot;
    // H_wheel_1 + H_wheel_2
    let h_wheel_1_plus_h_wheel_2 = H_wheel_1 + H_wheel_2;
    // H_wheel_3 - h_wheel_1_plus_h_wheel_2
    let r1_of_place_3 = H_wheel_3 - h_wheel_1_plus_h_wheel_2;
    // -r1_of_place_3
    let minus_r1_of_place_3 = -r1_of_place_3;
    let r1_of_place_4 = S::int(2) * minus_r1_of_place_3;
    // e0*r1_of_place_2 - e1_dot_minus_e2_dot*r1_of_place_4
    let r1_of_motion = (-e1_dot_minus_e2_dot).mul_add(r1_of_place_4, e0 * r1_of_place_2);
    // e0' + e3'
    let e0_dot_plus_e3_dot = e0_dot + e3_dot;
    // e1*r1_of_place_2 + r1_of_place_4*e0_dot_plus_e3_dot
    let r1_of_motion_2 = r1_of_place_4.mul_add(e0_dot_plus_e3_dot, e1 * r1_of_place_2);
    // e0' - e3'
    let e0_dot_minus_e3_dot = e0_dot - e3_dot;
    // e2*r1_of_place_2 - r1_of_place_4*e0_dot_minus_e3_dot
    let r1_of_motion_3 = (-r1_of_place_4)
        .mul_add(e0_dot_minus_e3_dot, e2 * r1_of_place_2);
    // e1' + e2'
    let e1_dot_plus_e2_dot = e1_dot + e2_dot;
    // e3*r1_of_place_2 - r1_of_place_4*e1_dot_plus_e2_dot
    let r1_of_motion_4 = (-r1_of_place_4)
        .mul_add(e1_dot_plus_e2_dot, e3 * r1_of_place_2);
    // 2*r1_of_place + t_times_3
    let r1_of_place_5 = r1_of_place.mul_add(S::int(2), t_times_3);
    let e0_r1_of_place_5 = e0 * r1_of_place_5;
    // H_wheel_3 + 2*h_wheel_1_plus_h_wheel_2
    let r1_of_place_6 = h_wheel_1_plus_h_wheel_2.mul_add(S::int(2), H_wheel_3);
    let e2_dot_doubled = S::int(2) * e2_dot;
    let e3_dot_doubled = S::int(2) * e3_dot;
    // r1_of_place_6*e2_dot_doubled + minus_r1_of_place_3*e3_dot_doubled
    let r1_of_motion_5 = minus_r1_of_place_3
        .mul_add(e3_dot_doubled, r1_of_place_6 * e2_dot_doubled);
    // e0_r1_of_place_5 + r1_of_motion_5
    let r1_of_motion_6 = e0_r1_of_place_5 + r1_of_motion_5;
    let e1_r1_of_place_5 = e1 * r1_of_place_5;
    // r1_of_place_6*e3_dot_doubled - minus_r1_of_place_3*e2_dot_doubled
    let r1_of_motion_7 = (-minus_r1_of_place_3)
        .mul_add(e2_dot_doubled, r1_of_place_6 * e3_dot_doubled);
    // e1_r1_of_place_5 + r1_of_motion_7
    let r1_of_motion_8 = e1_r1_of_place_5 + r1_of_motion_7;
    let e2_r1_of_place_5 = e2 * r1_of_place_5;
    let e0_dot_doubled = S::int(2) * e0_dot;
    let e1_dot_doubled = S::int(2) * e1_dot;
    // r1_of_place_6*e0_dot_doubled - minus_r1_of_place_3*e1_dot_doubled
    let r1_of_motion_9 = (-minus_r1_of_place_3)
        .mul_add(e1_dot_doubled, r1_of_place_6 * e0_dot_doubled);
    // e2_r1_of_place_5 - r1_of_motion_9
    let r1_of_motion_10 = e2_r1_of_place_5 - r1_of_motion_9;
    let e3_r1_of_place_5 = e3 * r1_of_place_5;
    // minus_r1_of_place_3*e0_dot_doubled + r1_of_place_6*e1_dot_doubled
    let r1_of_motion_11 = r1_of_place_6
        .mul_add(e1_dot_doubled, minus_r1_of_place_3 * e0_dot_doubled);
    // e3_r1_of_place_5 - r1_of_motion_11
    let r1_of_motion_12 = e3_r1_of_place_5 - r1_of_motion_11;
    // 1/(3*A + 2*K)
    let r1_of_a_k = S::int(1) / K.mul_add(S::int(2), S::int(3) * A);
    let k_r1_of_a_k = K * r1_of_a_k;
    // H_wheel_1 - H_wheel_2
    let r1_of_place_7 = H_wheel_1 - H_wheel_2;
    // e3*e1_dot_minus_e2_dot + e2*e0_dot_plus_e3_dot + e1*e0_dot_minus_e3_dot - e0*e1_dot_plus_e2_dot
    let r1_of_motion_13 = e2.mul_add(e0_dot_plus_e3_dot, e3 * e1_dot_minus_e2_dot)
        + e1 * e0_dot_minus_e3_dot - e0 * e1_dot_plus_e2_dot;
    let r1_of_motion_13_times_6 = S::int(6) * r1_of_motion_13;
    let h_bus_1_times_36 = S::int(36) * H_bus_1;
    let h_bus_2_times_36 = S::int(36) * H_bus_2;
    let r1_of_e0_e1_e2_e3 = S::int(36) * w_S_1_of_e0_e1_e2_e3;
    let h_bus_3_times_6 = S::int(6) * H_bus_3;
    // 6*H_bus_1_2 - H_wheel_1_2
    let r1_of_place_8 = H_bus_1_2.mul_add(S::int(6), -H_wheel_1_2);
    // H_wheel_2_2 + r1_of_place_8
    let r1_of_place_9 = H_wheel_2_2 + r1_of_place_8;
    // 6*H_bus_2 + r1_of_place_7
    let r1_of_place_10 = H_bus_2.mul_add(S::int(6), r1_of_place_7);
    // e0*r1_of_place_9 + e3'*r1_of_place_10
    let r1_of_e3_dot = e3_dot.mul_add(r1_of_place_10, e0 * r1_of_place_9);
    // e2'*h_bus_3_times_6 - r1_of_e3_dot
    let r1_of_motion_14 = e2_dot.mul_add(h_bus_3_times_6, -r1_of_e3_dot);
    // e1*r1_of_place_9 - e2'*r1_of_place_10
    let r1_of_e2_dot = (-e2_dot).mul_add(r1_of_place_10, e1 * r1_of_place_9);
    // e3'*h_bus_3_times_6 - r1_of_e2_dot
    let r1_of_motion_15 = e3_dot.mul_add(h_bus_3_times_6, -r1_of_e2_dot);
    // e2*r1_of_place_9 + e1'*r1_of_place_10
    let r1_of_e1_dot = e1_dot.mul_add(r1_of_place_10, e2 * r1_of_place_9);
    // e0'*h_bus_3_times_6 + r1_of_e1_dot
    let r1_of_motion_16 = e0_dot.mul_add(h_bus_3_times_6, r1_of_e1_dot);
    // e0'*r1_of_place_10 - e3*r1_of_place_9
    let r1_of_e0_dot = (-e3).mul_add(r1_of_place_9, e0_dot * r1_of_place_10);
    // e1'*h_bus_3_times_6 - r1_of_e0_dot
    let r1_of_motion_17 = e1_dot.mul_add(h_bus_3_times_6, -r1_of_e0_dot);
    let k_r1_of_a_k_times_6 = S::int(6) * k_r1_of_a_k;
    // r1_of_place_7*r1_of_motion_13_times_6 - sqrt(3)*(e0*r1_of_motion + e1*r1_of_motion_2 +
    //   e2*r1_of_motion_3 + e3*r1_of_motion_4 + k_r1_of_a_k*(e0*r1_of_motion_6 + e1*r1_of_motion_8 +
    //   e2*r1_of_motion_10 + e3*r1_of_motion_12)) + w_S_2_of_motion_3*h_bus_1_times_36 -
    //   w_S_1_of_motion_3*h_bus_2_times_36 + H_bus_3_2*r1_of_e0_e1_e2_e3 +
    //   k_r1_of_a_k_times_6*(e2*r1_of_motion_16 - e0*r1_of_motion_14 - e1*r1_of_motion_15 +
    //   e3*r1_of_motion_17)
    let r1_of_motion_18 = -w_S_in_axle_base_1_of_
        * (e0 * r1_of_motion + e1 * r1_of_motion_2 + e2 * r1_of_motion_3 + e3 * r1_of_motion_4
            + k_r1_of_a_k
                * (e1.mul_add(r1_of_motion_8, e0 * r1_of_motion_6) + e2 * r1_of_motion_10
                    + e3 * r1_of_motion_12)) + r1_of_place_7 * r1_of_motion_13_times_6
        + w_S_2_of_motion_3 * h_bus_1_times_36 - w_S_1_of_motion_3 * h_bus_2_times_36
        + H_bus_3_2 * r1_of_e0_e1_e2_e3
        + k_r1_of_a_k_times_6
            * ((-e0).mul_add(r1_of_motion_14, e2 * r1_of_motion_16)
                - e1 * r1_of_motion_15 + e3 * r1_of_motion_17);
    let r1_of_e0_e1_e2_e3_2 = S::ratio(1, 9) * w_s_1_of_e0_e1_e2_e3_inv;
    // r1 = (36*H_bus_1*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 36*H_bus_2*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3') + 6*H_wheel_1*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' + e3') + e1*(e0' - e3')) +
    //   6*H_wheel_2*(e0*(e1' + e2') - e3*(e1' - e2') - e2*(e0' + e3') - e1*(e0' - e3')) + 36*H_bus_3_2*(e0^2
    //   + e1^2 + e2^2 + e3^2) + 6*K*(e2*(6*e0'*H_bus_3 + e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) +
    //   e2*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) - e0*(6*e2'*H_bus_3 + e3'*(H_wheel_2 - 6*H_bus_2 -
    //   H_wheel_1) + e0*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2)) - e1*(6*e3'*H_bus_3 + e2'*(6*H_bus_2 +
    //   H_wheel_1 - H_wheel_2) + e1*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2)) + e3*(6*e1'*H_bus_3 +
    //   e0'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) + e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)))/(3*A + 2*K)
    //   + sqrt(3)*(e3*(2*e1'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + e3*(4*H_wheel_1_2 - 3*T + 4*H_wheel_2_2)) - K*(e0*(2*e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   2*e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e0*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)) +
    //   e1*(2*e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*e2'*(H_wheel_3 - H_wheel_1 - H_wheel_2) +
    //   e1*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)) + e2*(e2*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) -
    //   2*e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) - 2*e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2)) +
    //   e3*(e3*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) - 2*e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) -
    //   2*e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3)))/(3*A + 2*K) - e0*(2*e1'*(H_wheel_3 - H_wheel_1 -
    //   H_wheel_2) + 2*e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e0*(3*T - 4*H_wheel_1_2 - 4*H_wheel_2_2)) -
    //   e1*(2*e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e1*(3*T
    //   - 4*H_wheel_1_2 - 4*H_wheel_2_2)) - e2*(2*e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + 2*e3'*(H_wheel_1
    //   + H_wheel_2 - H_wheel_3) + e2*(3*T - 4*H_wheel_1_2 - 4*H_wheel_2_2))))/(9*(e0^2 + e1^2 + e2^2 +
    //   e3^2))
    let r1 = r1_of_motion_18 * r1_of_e0_e1_e2_e3_2;
    let w3_dot_of_motion = S::int(2) * w_S_1_of_motion_3;
    let w3_dot_of_place = w_S_1_of_e0_e1_e2_e3 * r1_of_place_5;
    let w3_dot_of_motion_2 = w_S_3_of_motion_3 * r1_of_place_4;
    let w3_dot_of_motion_3 = S::int(2) * w_S_2_of_motion_3;
    let r1_of_place_9_times_6 = S::int(6) * r1_of_place_9;
    let h_bus_3_times_36 = S::int(36) * H_bus_3;
    let w3_dot_of_motion_4 = S::int(6) * w_S_3_of_motion_3;
    // sqrt(3)*(w3_dot_of_place + w3_dot_of_motion_2 + r1_of_place_6*w3_dot_of_motion_3) -
    //   w_S_1_of_e0_e1_e2_e3*r1_of_place_9_times_6 + w_S_2_of_motion_3*h_bus_3_times_36 -
    //   r1_of_place_10*w3_dot_of_motion_4
    let w3_dot_of_motion_5 = w_S_in_axle_base_1_of_
        * r1_of_place_6.mul_add(w3_dot_of_motion_3, w3_dot_of_place + w3_dot_of_motion_2)
        - w_S_1_of_e0_e1_e2_e3 * r1_of_place_9_times_6
        + w_S_2_of_motion_3 * h_bus_3_times_36 - r1_of_place_10 * w3_dot_of_motion_4;
    // 6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2
    let w3_dot_of_place_2 = H_bus_2_2.mul_add(S::int(6), H_wheel_1_2) - H_wheel_2_2;
    let w3_dot_of_place_3 = S::int(6) * w3_dot_of_place_2;
    // 6*H_bus_1 - r1_of_place_7
    let w3_dot_of_place_4 = H_bus_1.mul_add(S::int(6), -r1_of_place_7);
    // sqrt(3)*(w3_dot_of_place - r1_of_place_6*w3_dot_of_motion - w3_dot_of_motion_2) -
    //   w_S_1_of_motion_3*h_bus_3_times_36 + k_r1_of_a_k*w3_dot_of_motion_5 -
    //   w_S_1_of_e0_e1_e2_e3*w3_dot_of_place_3 + w3_dot_of_motion_4*w3_dot_of_place_4
    let w3_dot_of_motion_6 = w_S_in_axle_base_1_of_
        * ((-r1_of_place_6).mul_add(w3_dot_of_motion, w3_dot_of_place)
            - w3_dot_of_motion_2) - w_S_1_of_motion_3 * h_bus_3_times_36
        + k_r1_of_a_k * w3_dot_of_motion_5 - w_S_1_of_e0_e1_e2_e3 * w3_dot_of_place_3
        + w3_dot_of_motion_4 * w3_dot_of_place_4;
    // K*(k_r1_of_a_k - 2)
    let w3_dot_of_a_k = K * (k_r1_of_a_k - S::int(2));
    // 1/(3*B - w3_dot_of_a_k)
    let w3_dot_of_a_b_k = S::int(1) / B.mul_add(S::int(3), -w3_dot_of_a_k);
    // A + K
    let a_plus_k = A + K;
    let k_r1_of_a_k_a_plus_k = k_r1_of_a_k * a_plus_k;
    let w3_dot_of_a_b_k_2 = w3_dot_of_a_b_k * k_r1_of_a_k_a_plus_k;
    let w3_dot_of_motion_7 = w3_dot_of_motion_6 * w3_dot_of_a_b_k_2;
    let w3_dot_of_a_k_2 = S::int(9) * k_r1_of_a_k_a_plus_k;
    let c_times_3 = S::int(3) * C;
    // 1/(c_times_3 - w3_dot_of_a_k - w3_dot_of_a_b_k_2*w3_dot_of_a_k_2)
    let w3_dot_of_a_b_c_k = S::int(1)
        / (-w3_dot_of_a_b_k_2).mul_add(w3_dot_of_a_k_2, c_times_3 - w3_dot_of_a_k);
    // w3' = (3*r1 - K*(A + K)*(36*H_bus_3*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 6*(e2*e1' - e3*e0' -
    //   e1*e2' + e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_2_2 -
    //   6*H_bus_2_2 - H_wheel_1_2) + K*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' - e2*e1'
    //   + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2
    //   - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(3*A + 2*K) +
    //   sqrt(3)*(2*(e1*e0' - e0*e1' - e3*e2' + e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*(e3*e0' -
    //   e2*e1' + e1*e2' - e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T +
    //   2*H_wheel_1_2 + 2*H_wheel_2_2)))/((3*A + 2*K)*(3*B + K*(2 - K/(3*A + 2*K)))*(e0^2 + e1^2 + e2^2 +
    //   e3^2)))/(3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A + K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A +
    //   2*K)))))
    let w3_dot = w3_dot_of_a_b_c_k
        * (-w_s_1_of_e0_e1_e2_e3_inv).mul_add(w3_dot_of_motion_7, S::int(3) * r1);
    let w3_dot_of_a_b_k_by_3 = S::ratio(1, 3) * w3_dot_of_a_b_k;
    // w2' = (9*K*w3'*(A + K)/(3*A + 2*K) - (36*H_bus_3*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 6*(e2*e1' -
    //   e3*e0' - e1*e2' + e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 +
    //   e3^2)*(H_wheel_2_2 - 6*H_bus_2_2 - H_wheel_1_2) + K*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')
    //   + 6*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2
    //   + e3^2)*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 +
    //   H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(3*A +
    //   2*K) + sqrt(3)*(2*(e1*e0' - e0*e1' - e3*e2' + e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   2*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 +
    //   e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 + e3^2))/(3*(3*B + K*(2 - K/(3*A +
    //   2*K))))
    let w2_dot = w3_dot_of_a_b_k_by_3
        * (-w_s_1_of_e0_e1_e2_e3_inv)
            .mul_add(w3_dot_of_motion_6, w3_dot * w3_dot_of_a_k_2);
    let k_times_3 = S::int(3) * K;
    let r1_of_a_k_by_3 = S::ratio(1, 3) * r1_of_a_k;
    // w1' = (3*K*(w2' + w3') - (36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' - e2*e1' +
    //   e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 -
    //   6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 +
    //   e3^2))/(3*(3*A + 2*K))
    let w1_dot = r1_of_a_k_by_3
        * (k_times_3 * (w2_dot + w3_dot) - w_s_1_of_e0_e1_e2_e3_inv * w3_dot_of_motion_5);
    let w_S_1_by_e0_of_e0_e1_e2_e3 = S::int(2) * w_s_1_of_e0_e1_e2_e3_inv;
    let w_S_1_by_e0_of_e0_e1_e2_e3_2 = e0 * w_S_1_by_e0_of_e0_e1_e2_e3;
    // w_S_1_by_e0 = (e1' + 2*e0*(e1*e0' - e0*e1' - e3*e2' + e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2))/(e0^2 +
    //   e1^2 + e2^2 + e3^2)
    let w_S_1_by_e0 = w_s_1_of_e0_e1_e2_e3_inv
        * (-w_S_1_of_motion_3).mul_add(w_S_1_by_e0_of_e0_e1_e2_e3_2, e1_dot);
    // w_S_2_by_e0 = (e2' + 2*e0*(e2*e0' - e0*e2' + e3*e1' - e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2))/(e0^2 +
    //   e1^2 + e2^2 + e3^2)
    let w_S_2_by_e0 = w_s_1_of_e0_e1_e2_e3_inv
        * (-w_S_2_of_motion_3).mul_add(w_S_1_by_e0_of_e0_e1_e2_e3_2, e2_dot);
    // w_S_3_by_e0 = (e3' + 2*e0*(e3*e0' - e2*e1' + e1*e2' - e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2))/(e0^2 +
    //   e1^2 + e2^2 + e3^2)
    let w_S_3_by_e0 = w_s_1_of_e0_e1_e2_e3_inv
        * (-w_S_3_of_motion_3).mul_add(w_S_1_by_e0_of_e0_e1_e2_e3_2, e3_dot);
    let w_S_in_axle_base_1_by_e0_of_ = S::int(3) * w_S_in_axle_base_1_of__2;
    // r1_of_motion_13*w_S_in_axle_base_1_by_e0_of_ - w_S_in_axle_base_1_of_motion
    let w_S_in_axle_base_1_by_e0_of_motion = r1_of_motion_13
        .mul_add(w_S_in_axle_base_1_by_e0_of_, -w_S_in_axle_base_1_of_motion);
    // 3*w_S_1_of_motion_3 + w_S_in_axle_base_1_by_e0_of_motion
    let w_S_in_axle_base_1_by_e0_of_motion_2 = w_S_1_of_motion_3
        .mul_add(S::int(3), w_S_in_axle_base_1_by_e0_of_motion);
    let w_S_in_axle_base_1_by_e0_of_e3_dot = e3_dot * w_S_in_axle_base_1_of_;
    let w_S_in_axle_base_1_by_e0_of_e2_dot = e2_dot * w_S_in_axle_base_1_by_e0_of_;
    let w_S_in_axle_base_1_by_e0_of__2 = S::int(3) * w_S_in_axle_base_1_of__3;
    let w_S_in_axle_base_1_by_e0_of_e1_dot = e1_dot * w_S_in_axle_base_1_by_e0_of__2;
    // w_S_in_axle_base_1_by_e0 = (3*e1'*(1/(3 + sqrt(3)) - 1) + 3*e2'/(3 + sqrt(3)) + e3'*sqrt(3) +
    //   2*e0*(3*e0*e1' - 3*e1*e0' + 3*e3*e2' - 3*e2*e3' + sqrt(3)*(e3*e0' - e2*e1' + e1*e2' - e0*e3') +
    //   3*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' + e3') + e1*(e0' - e3'))/(3 + sqrt(3)))/(e0^2 + e1^2 +
    //   e2^2 + e3^2))/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_1_by_e0 = w_s_1_of_e0_e1_e2_e3_inv
        * (w_S_1_by_e0_of_e0_e1_e2_e3_2
            .mul_add(
                w_S_in_axle_base_1_by_e0_of_motion_2, w_S_in_axle_base_1_by_e0_of_e3_dot,
            ) + w_S_in_axle_base_1_by_e0_of_e2_dot + w_S_in_axle_base_1_by_e0_of_e1_dot);
    // 3*w_S_2_of_motion_3 + w_S_in_axle_base_1_by_e0_of_motion
    let w_S_in_axle_base_2_by_e0_of_motion = w_S_2_of_motion_3
        .mul_add(S::int(3), w_S_in_axle_base_1_by_e0_of_motion);
    let w_S_in_axle_base_2_by_e0_of_e1_dot = e1_dot * w_S_in_axle_base_1_by_e0_of_;
    let w_S_in_axle_base_2_by_e0_of_e2_dot = e2_dot * w_S_in_axle_base_1_by_e0_of__2;
    // w_S_in_axle_base_2_by_e0 = (3*e1'/(3 + sqrt(3)) + 3*e2'*(1/(3 + sqrt(3)) - 1) + e3'*sqrt(3) +
    //   2*e0*(3*e0*e2' - 3*e2*e0' - 3*e3*e1' + 3*e1*e3' + sqrt(3)*(e3*e0' - e2*e1' + e1*e2' - e0*e3') +
    //   3*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' + e3') + e1*(e0' - e3'))/(3 + sqrt(3)))/(e0^2 + e1^2 +
    //   e2^2 + e3^2))/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_2_by_e0 = w_s_1_of_e0_e1_e2_e3_inv
        * (w_S_1_by_e0_of_e0_e1_e2_e3_2
            .mul_add(
                w_S_in_axle_base_2_by_e0_of_motion, w_S_in_axle_base_1_by_e0_of_e3_dot,
            ) + w_S_in_axle_base_2_by_e0_of_e1_dot + w_S_in_axle_base_2_by_e0_of_e2_dot);
    // e3' + e1_dot_plus_e2_dot
    let w_S_in_axle_base_3_by_e0_of_motion = e3_dot + e1_dot_plus_e2_dot;
    let w_S_in_axle_base_3_by_e0_of_motion_2 = e0 * w_S_in_axle_base_3_by_e0_of_motion;
    // e2' + e0_dot_minus_e3_dot
    let w_S_in_axle_base_3_by_e0_of_motion_3 = e2_dot + e0_dot_minus_e3_dot;
    let w_S_in_axle_base_3_by_e0_of_motion_4 = e1 * w_S_in_axle_base_3_by_e0_of_motion_3;
    // w_S_in_axle_base_3_by_e0_of_motion_2 - w_S_in_axle_base_3_by_e0_of_motion_4
    let w_S_in_axle_base_3_by_e0_of_motion_5 = w_S_in_axle_base_3_by_e0_of_motion_2
        - w_S_in_axle_base_3_by_e0_of_motion_4;
    // e0' + e1_dot_minus_e2_dot
    let w_S_in_axle_base_3_by_e0_of_motion_6 = e0_dot + e1_dot_minus_e2_dot;
    let w_S_in_axle_base_3_by_e0_of_motion_7 = e3 * w_S_in_axle_base_3_by_e0_of_motion_6;
    // e1' - e0_dot_plus_e3_dot
    let w_S_in_axle_base_3_by_e0_of_motion_8 = e1_dot - e0_dot_plus_e3_dot;
    // -w_S_in_axle_base_3_by_e0_of_motion_8
    let w_S_in_axle_base_3_by_e0_of_motion_9 = -w_S_in_axle_base_3_by_e0_of_motion_8;
    let w_S_in_axle_base_3_by_e0_of_motion_10 = e2 * w_S_in_axle_base_3_by_e0_of_motion_9;
    // w_S_in_axle_base_3_by_e0_of_motion_7 + w_S_in_axle_base_3_by_e0_of_motion_10
    let w_S_in_axle_base_3_by_e0_of_motion_11 = w_S_in_axle_base_3_by_e0_of_motion_7
        + w_S_in_axle_base_3_by_e0_of_motion_10;
    // w_S_in_axle_base_3_by_e0_of_motion_5 - w_S_in_axle_base_3_by_e0_of_motion_11
    let w_S_in_axle_base_3_by_e0_of_motion_12 = w_S_in_axle_base_3_by_e0_of_motion_5
        - w_S_in_axle_base_3_by_e0_of_motion_11;
    // w_S_in_axle_base_3_by_e0 = sqrt(3)*(e1' + e2' + e3' - 2*e0*(e3*(e2' - e0' - e1') + e0*(e1' + e2' +
    //   e3') + e1*(e3' - e0' - e2') + e2*(e1' - e0' - e3'))/(e0^2 + e1^2 + e2^2 + e3^2))/(e0^2 + e1^2 + e2^2
    //   + e3^2)
    let w_S_in_axle_base_3_by_e0 = w_S_in_axle_base_3_of_e0_e1_e2_e3
        * (-w_S_1_by_e0_of_e0_e1_e2_e3_2)
            .mul_add(
                w_S_in_axle_base_3_by_e0_of_motion_12, w_S_in_axle_base_3_by_e0_of_motion,
            );
    let w_S_1_2_by_e0_of_e0_e1_e2_e3 = S::int(4) * w_s_1_of_e0_e1_e2_e3_inv;
    let w_S_1_2_by_e0_of_motion = w_S_1_2_of_motion * w_S_1_2_by_e0_of_e0_e1_e2_e3;
    // e0*w_S_1_2_by_e0_of_motion - e0'*w_S_1_2_of_e0_e1_e2_e3
    let w_S_1_2_by_e0_of_motion_2 = (-e0_dot)
        .mul_add(w_S_1_2_of_e0_e1_e2_e3, e0 * w_S_1_2_by_e0_of_motion);
    let e1_dot_w_s_1_2_of_motion = e1_dot * w_S_1_2_of_motion;
    // w_S_1_2_by_e0 = e0'*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + e1'*(e0*e0'
    //   + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 4*e0*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_1_2_by_e0 = (-w_S_1_of_motion_3)
        .mul_add(w_S_1_2_by_e0_of_motion_2, e1_dot_w_s_1_2_of_motion);
    let e2_dot_w_s_1_2_of_motion = e2_dot * w_S_1_2_of_motion;
    // w_S_2_2_by_e0 = e0'*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + e2'*(e0*e0'
    //   + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 4*e0*(e2*e0' - e0*e2' + e3*e1' -
    //   e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_2_2_by_e0 = (-w_S_2_of_motion_3)
        .mul_add(w_S_1_2_by_e0_of_motion_2, e2_dot_w_s_1_2_of_motion);
    let e3_dot_w_s_1_2_of_motion = e3_dot * w_S_1_2_of_motion;
    // w_S_3_2_by_e0 = e0'*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + e3'*(e0*e0'
    //   + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 4*e0*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_3_2_by_e0 = (-w_S_3_of_motion_3)
        .mul_add(w_S_1_2_by_e0_of_motion_2, e3_dot_w_s_1_2_of_motion);
    let w_S_in_axle_base_1_2_by_e0_of_motion = w_S_1_2_of_motion * w_S_in_axle_base_1_of_;
    let w_S_in_axle_base_1_2_by_e0_of_motion_2 = e3_dot * w_S_in_axle_base_1_2_by_e0_of_motion;
    let w_S_in_axle_base_1_2_by_e0_of_motion_3 = S::int(3) * w_S_1_2_of_motion;
    let w_S_in_axle_base_1_2_by_e0_of_motion_4 = w_S_in_axle_base_1_of__3
        * w_S_in_axle_base_1_2_by_e0_of_motion_3;
    let w_S_in_axle_base_1_2_by_e0_of_motion_5 = e1_dot * w_S_in_axle_base_1_2_by_e0_of_motion_4;
    let w_S_in_axle_base_1_2_by_e0_of_motion_6 = w_S_in_axle_base_1_of__2
        * w_S_in_axle_base_1_2_by_e0_of_motion_3;
    let w_S_in_axle_base_1_2_by_e0_of_motion_7 = e2_dot * w_S_in_axle_base_1_2_by_e0_of_motion_6;
    // w_S_in_axle_base_1_2_by_e0 = 3*e0'*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2 + 3*e0'*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2
    //   + e3^2)^2) + e0'*sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 +
    //   3*e1'*(1/(3 + sqrt(3)) - 1)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 +
    //   3*e2'*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) +
    //   e3'*sqrt(3)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 12*e0*(1 - 1/(3 +
    //   sqrt(3)))*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^3 + 12*e0*(e2*e0' - e0*e2' + e3*e1' - e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 +
    //   sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^3) + 4*e0*sqrt(3)*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(e0*e0' +
    //   e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_in_axle_base_1_2_by_e0 = (-w_S_in_axle_base_1_of_motion_3)
        .mul_add(w_S_1_2_by_e0_of_motion_2, w_S_in_axle_base_1_2_by_e0_of_motion_2)
        + w_S_in_axle_base_1_2_by_e0_of_motion_5 + w_S_in_axle_base_1_2_by_e0_of_motion_7;
    let w_S_in_axle_base_2_2_by_e0_of_motion = e2_dot * w_S_in_axle_base_1_2_by_e0_of_motion_4;
    let w_S_in_axle_base_2_2_by_e0_of_motion_2 = e1_dot * w_S_in_axle_base_1_2_by_e0_of_motion_6;
    // w_S_in_axle_base_2_2_by_e0 = 3*e0'*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/((3 + sqrt(3))*(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2) + 3*e0'*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 + e0'*sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 +
    //   3*e1'*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) +
    //   3*e2'*(1/(3 + sqrt(3)) - 1)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 +
    //   e3'*sqrt(3)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 12*e0*(e1*e0' -
    //   e0*e1' - e3*e2' + e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 +
    //   e3^2)^3) + 12*e0*(1 - 1/(3 + sqrt(3)))*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1' + e2*e2'
    //   + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3 + 4*e0*sqrt(3)*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(e0*e0' +
    //   e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_in_axle_base_2_2_by_e0 = (-w_S_in_axle_base_2_of_motion_2)
        .mul_add(w_S_1_2_by_e0_of_motion_2, w_S_in_axle_base_1_2_by_e0_of_motion_2)
        + w_S_in_axle_base_2_2_by_e0_of_motion + w_S_in_axle_base_2_2_by_e0_of_motion_2;
    // w_S_in_axle_base_3_by_e0_of_motion_4 + w_S_in_axle_base_3_by_e0_of_motion_11
    let w_S_in_axle_base_3_2_by_e0_of_motion = w_S_in_axle_base_3_by_e0_of_motion_4
        + w_S_in_axle_base_3_by_e0_of_motion_11;
    // e2' + e3'
    let e2_dot_plus_e3_dot = e2_dot + e3_dot;
    let e3_dot_e3_e3_dot = e3_dot * e3_e3_dot;
    // e1'*(e3_e3_dot_plus_e2_e2_dot + e1*w_S_in_axle_base_3_by_e0_of_motion) + e2'*(e3_e3_dot +
    //   e2*e2_dot_plus_e3_dot)
    let w_S_in_axle_base_3_2_by_e0_of_motion_2 = e1_dot
        * e1.mul_add(w_S_in_axle_base_3_by_e0_of_motion, e3_e3_dot_plus_e2_e2_dot)
        + e2_dot * e2.mul_add(e2_dot_plus_e3_dot, e3_e3_dot);
    // e3_dot_e3_e3_dot + w_S_in_axle_base_3_2_by_e0_of_motion_2
    let w_S_in_axle_base_3_2_by_e0_of_motion_3 = e3_dot_e3_e3_dot
        + w_S_in_axle_base_3_2_by_e0_of_motion_2;
    // w_S_1_by_e0_of_e0_e1_e2_e3*(e0*(e0'*w_S_in_axle_base_3_by_e0_of_motion_12 +
    //   w_S_in_axle_base_3_2_by_e0_of_motion_3) - e3_e3_dot*w_S_in_axle_base_3_by_e0_of_motion_7 -
    //   e2*(e2_e2_dot*w_S_in_axle_base_3_by_e0_of_motion_9 + e3*(e2'*w_S_in_axle_base_3_by_e0_of_motion_6 +
    //   e3'*w_S_in_axle_base_3_by_e0_of_motion_9)) - e1*(e3_e3_dot*e0_dot_minus_e3_dot + e2'*(e3_e3_dot +
    //   e2*w_S_in_axle_base_3_by_e0_of_motion_3) + e1'*w_S_in_axle_base_3_2_by_e0_of_motion))
    let w_S_in_axle_base_3_2_by_e0_of_motion_4 = w_S_1_by_e0_of_e0_e1_e2_e3
        * (e0
            * e0_dot
                .mul_add(
                    w_S_in_axle_base_3_by_e0_of_motion_12, w_S_in_axle_base_3_2_by_e0_of_motion_3,
                ) - e3_e3_dot * w_S_in_axle_base_3_by_e0_of_motion_7
            - e2
                * (e3
                    * e3_dot
                        .mul_add(
                            w_S_in_axle_base_3_by_e0_of_motion_9,
                            e2_dot * w_S_in_axle_base_3_by_e0_of_motion_6,
                        ) + e2_e2_dot * w_S_in_axle_base_3_by_e0_of_motion_9)
            - e1
                * (e2_dot * e2.mul_add(w_S_in_axle_base_3_by_e0_of_motion_3, e3_e3_dot)
                    + e3_e3_dot * e0_dot_minus_e3_dot
                    + e1_dot * w_S_in_axle_base_3_2_by_e0_of_motion));
    let e0_doubled = S::int(2) * e0;
    let w_S_in_axle_base_3_2_by_e0_of_e0_e1_e2_e3 = w_S_1_2_of_e0_e1_e2_e3 * w_S_in_axle_base_1_of_;
    // w_S_in_axle_base_3_2_by_e0 = sqrt(3)*(e3*e3'^2 - e0'*(e3*(e0' + e1' - e2') + e1*(e0' + e2' - e3') +
    //   e2*(e0' - e1' + e3')) + e1'*(e2*e2' + e3*e3' + e1*(e1' + e2' + e3')) + e2'*(e3*e3' + e2*(e2' + e3'))
    //   + 2*e0*(e0'*(e1' + e2' + e3') - 2*(e3^2*e3'*(e2' - e0' - e1') + e0*(e3*e3'^2 + e0'*(e3*(e2' - e0' -
    //   e1') + e0*(e1' + e2' + e3') + e1*(e3' - e0' - e2') + e2*(e1' - e0' - e3')) + e1'*(e2*e2' + e3*e3' +
    //   e1*(e1' + e2' + e3')) + e2'*(e3*e3' + e2*(e2' + e3'))) - e1*(e3*e3'*(e0' - e3') + e1'*(e3*(e0' + e1'
    //   - e2') + e1*(e0' + e2' - e3') + e2*(e0' - e1' + e3')) + e2'*(e3*e3' + e2*(e0' + e2' - e3'))) -
    //   e2*(e2*e2'*(e0' - e1' + e3') + e3*(e2'*(e0' + e1' - e2') + e3'*(e0' - e1' + e3'))))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_3_2_by_e0 = w_S_in_axle_base_3_2_by_e0_of_e0_e1_e2_e3
        * (w_S_in_axle_base_3_2_by_e0_of_motion_3 - e0_dot * w_S_in_axle_base_3_2_by_e0_of_motion
            + e0_doubled
                * e0_dot
                    .mul_add(
                        w_S_in_axle_base_3_by_e0_of_motion, -w_S_in_axle_base_3_2_by_e0_of_motion_4,
                    ));
    // K*(w_S_in_axle_base_1_2_by_e0 + w_S_in_axle_base_2_2_by_e0)
    let r1_by_e0_of_place = K * (w_S_in_axle_base_1_2_by_e0 + w_S_in_axle_base_2_2_by_e0);
    let j_doubled = S::int(2) * J;
    // K*(w_S_in_axle_base_1_by_e0 + w_S_in_axle_base_2_by_e0)
    let r1_by_e0_of_place_2 = K * (w_S_in_axle_base_1_by_e0 + w_S_in_axle_base_2_by_e0);
    // r1_by_e0_of_place_2 - w_S_in_axle_base_3_by_e0*j_doubled
    let r1_by_e0_of_place_3 = (-w_S_in_axle_base_3_by_e0)
        .mul_add(j_doubled, r1_by_e0_of_place_2);
    // J*w_S_in_axle_base_3_by_e0 + r1_by_e0_of_place_2
    let r1_by_e0_of_place_4 = J.mul_add(w_S_in_axle_base_3_by_e0, r1_by_e0_of_place_2);
    let e1_doubled = S::int(2) * e1;
    let e2_doubled = S::int(2) * e2;
    let e3_doubled = S::int(2) * e3;
    let r1_by_e0_of_motion = K * r1_of_motion_13_times_6;
    // w_S_in_axle_base_1_by_e0 - w_S_in_axle_base_2_by_e0
    let r1_by_e0_of_place_5 = w_S_in_axle_base_1_by_e0 - w_S_in_axle_base_2_by_e0;
    let a_times_6 = S::int(6) * A;
    // K*(w_S_in_axle_base_1_2_by_e0 - w_S_in_axle_base_2_2_by_e0)
    let r1_by_e0_of_place_6 = K * (w_S_in_axle_base_1_2_by_e0 - w_S_in_axle_base_2_2_by_e0);
    // w_S_1_2_by_e0*a_times_6 - r1_by_e0_of_place_6
    let r1_by_e0_of_place_7 = w_S_1_2_by_e0.mul_add(a_times_6, -r1_by_e0_of_place_6);
    let b_times_6 = S::int(6) * B;
    let k_r1_by_e0_of_place_5 = K * r1_by_e0_of_place_5;
    // w_S_2_by_e0*b_times_6 + k_r1_by_e0_of_place_5
    let r1_by_e0_of_place_8 = w_S_2_by_e0.mul_add(b_times_6, k_r1_by_e0_of_place_5);
    let c_times_6 = S::int(6) * C;
    let e2_dot_c_times_6 = e2_dot * c_times_6;
    let e3_dot_c_times_6 = e3_dot * c_times_6;
    let e0_dot_c_times_6 = e0_dot * c_times_6;
    let e1_dot_c_times_6 = e1_dot * c_times_6;
    let h_bus_3_2_times_72 = S::int(72) * H_bus_3_2;
    let r1_of_place_7_times_6 = S::int(6) * r1_of_place_7;
    let a_w_s_2_of_motion_3 = A * w_S_2_of_motion_3;
    let r1_by_e0_of_motion_2 = S::int(36) * a_w_s_2_of_motion_3;
    let b_w_s_1_of_motion_3 = B * w_S_1_of_motion_3;
    let r1_by_e0_of_motion_3 = S::int(36) * b_w_s_1_of_motion_3;
    let c_r1_of_e0_e1_e2_e3 = C * r1_of_e0_e1_e2_e3;
    let r1_by_e0_of_motion_4 = S::ratio(2, 9) * w_S_1_2_of_e0_e1_e2_e3 * r1_of_motion_18;
    // r1_by_e0 = (36*e2'*H_bus_1 - 36*e1'*H_bus_2 - 6*H_wheel_1*(e1' + e2') + 6*H_wheel_2*(e1' + e2') +
    //   72*e0*H_bus_3_2 + 36*A*w_S_1_by_e0*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 36*B*w_S_2_by_e0*(e1*e0' -
    //   e0*e1' - e3*e2' + e2*e3') + 6*K*w_S_in_axle_base_1_by_e0*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0'
    //   + e3') + e1*(e0' - e3')) + 6*K*w_S_in_axle_base_2_by_e0*(e0*(e1' + e2') - e3*(e1' - e2') - e2*(e0' +
    //   e3') - e1*(e0' - e3')) + 36*C*w_S_3_2_by_e0*(e0^2 + e1^2 + e2^2 + e3^2) +
    //   6*K*(e2*(6*C*e0'*w_S_3_by_e0 + e1'*(6*B*w_S_2_by_e0 + K*w_S_in_axle_base_1_by_e0 -
    //   K*w_S_in_axle_base_2_by_e0) + e2*(6*A*w_S_1_2_by_e0 - K*w_S_in_axle_base_1_2_by_e0 +
    //   K*w_S_in_axle_base_2_2_by_e0)) - 6*e2'*H_bus_3 - e3'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) -
    //   e0*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) - e0*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2 +
    //   6*C*e2'*w_S_3_by_e0 - e3'*(6*B*w_S_2_by_e0 + K*w_S_in_axle_base_1_by_e0 -
    //   K*w_S_in_axle_base_2_by_e0) - e0*(6*A*w_S_1_2_by_e0 - K*w_S_in_axle_base_1_2_by_e0 +
    //   K*w_S_in_axle_base_2_2_by_e0)) - e1*(6*C*e3'*w_S_3_by_e0 + e2'*(6*B*w_S_2_by_e0 +
    //   K*w_S_in_axle_base_1_by_e0 - K*w_S_in_axle_base_2_by_e0) + e1*(K*w_S_in_axle_base_1_2_by_e0 -
    //   6*A*w_S_1_2_by_e0 - K*w_S_in_axle_base_2_2_by_e0)) + e3*(6*C*e1'*w_S_3_by_e0 +
    //   e0'*(K*w_S_in_axle_base_2_by_e0 - 6*B*w_S_2_by_e0 - K*w_S_in_axle_base_1_by_e0) +
    //   e3*(6*A*w_S_1_2_by_e0 - K*w_S_in_axle_base_1_2_by_e0 + K*w_S_in_axle_base_2_2_by_e0)))/(3*A + 2*K) +
    //   sqrt(3)*(2*e3*(e1'*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 -
    //   2*J*w_S_in_axle_base_3_by_e0) + e2'*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 -
    //   2*J*w_S_in_axle_base_3_by_e0) + 2*e3*(K*w_S_in_axle_base_1_2_by_e0 + K*w_S_in_axle_base_2_2_by_e0))
    //   - 2*e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) - 2*e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - e0*(3*T -
    //   4*H_wheel_1_2 - 4*H_wheel_2_2) - K*(2*e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*e3'*(H_wheel_1
    //   + H_wheel_2 - H_wheel_3) + e0*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + e0*(3*T + 2*H_wheel_1_2 +
    //   2*H_wheel_2_2 + 4*e2'*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 +
    //   J*w_S_in_axle_base_3_by_e0) + 2*e3'*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 -
    //   2*J*w_S_in_axle_base_3_by_e0) + 2*e0*(K*w_S_in_axle_base_1_2_by_e0 + K*w_S_in_axle_base_2_2_by_e0))
    //   + 2*e1*(2*e3'*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 + J*w_S_in_axle_base_3_by_e0)
    //   + e2'*(2*J*w_S_in_axle_base_3_by_e0 - K*w_S_in_axle_base_1_by_e0 - K*w_S_in_axle_base_2_by_e0) +
    //   e1*(K*w_S_in_axle_base_1_2_by_e0 + K*w_S_in_axle_base_2_2_by_e0)) +
    //   2*e2*(e2*(K*w_S_in_axle_base_1_2_by_e0 + K*w_S_in_axle_base_2_2_by_e0) -
    //   2*e0'*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 + J*w_S_in_axle_base_3_by_e0) -
    //   e1'*(2*J*w_S_in_axle_base_3_by_e0 - K*w_S_in_axle_base_1_by_e0 - K*w_S_in_axle_base_2_by_e0)) +
    //   2*e3*(e3*(K*w_S_in_axle_base_1_2_by_e0 + K*w_S_in_axle_base_2_2_by_e0) -
    //   2*e1'*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 + J*w_S_in_axle_base_3_by_e0) -
    //   e0'*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 - 2*J*w_S_in_axle_base_3_by_e0)))/(3*A
    //   + 2*K) - e0*(3*T - 4*H_wheel_1_2 - 4*H_wheel_2_2 + 2*e1'*(2*J*w_S_in_axle_base_3_by_e0 -
    //   K*w_S_in_axle_base_1_by_e0 - K*w_S_in_axle_base_2_by_e0) + 2*e2'*(K*w_S_in_axle_base_1_by_e0 +
    //   K*w_S_in_axle_base_2_by_e0 - 2*J*w_S_in_axle_base_3_by_e0) - 4*e0*(K*w_S_in_axle_base_1_2_by_e0 +
    //   K*w_S_in_axle_base_2_2_by_e0)) - 2*e1*(e0'*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0
    //   - 2*J*w_S_in_axle_base_3_by_e0) + e3'*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 -
    //   2*J*w_S_in_axle_base_3_by_e0) - 2*e1*(K*w_S_in_axle_base_1_2_by_e0 + K*w_S_in_axle_base_2_2_by_e0))
    //   - 2*e2*(e0'*(2*J*w_S_in_axle_base_3_by_e0 - K*w_S_in_axle_base_1_by_e0 - K*w_S_in_axle_base_2_by_e0)
    //   + e3'*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 - 2*J*w_S_in_axle_base_3_by_e0) -
    //   2*e2*(K*w_S_in_axle_base_1_2_by_e0 + K*w_S_in_axle_base_2_2_by_e0))))/(9*(e0^2 + e1^2 + e2^2 +
    //   e3^2)) - 2*e0*(36*H_bus_1*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 36*H_bus_2*(e1*e0' - e0*e1' - e3*e2'
    //   + e2*e3') + 6*H_wheel_1*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' + e3') + e1*(e0' - e3')) +
    //   6*H_wheel_2*(e0*(e1' + e2') - e3*(e1' - e2') - e2*(e0' + e3') - e1*(e0' - e3')) + 36*H_bus_3_2*(e0^2
    //   + e1^2 + e2^2 + e3^2) + 6*K*(e2*(6*e0'*H_bus_3 + e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) +
    //   e2*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) - e0*(6*e2'*H_bus_3 + e3'*(H_wheel_2 - 6*H_bus_2 -
    //   H_wheel_1) + e0*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2)) - e1*(6*e3'*H_bus_3 + e2'*(6*H_bus_2 +
    //   H_wheel_1 - H_wheel_2) + e1*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2)) + e3*(6*e1'*H_bus_3 +
    //   e0'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) + e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)))/(3*A + 2*K)
    //   + sqrt(3)*(e3*(2*e1'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + e3*(4*H_wheel_1_2 - 3*T + 4*H_wheel_2_2)) - K*(e0*(2*e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   2*e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e0*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)) +
    //   e1*(2*e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*e2'*(H_wheel_3 - H_wheel_1 - H_wheel_2) +
    //   e1*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)) + e2*(e2*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) -
    //   2*e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) - 2*e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2)) +
    //   e3*(e3*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) - 2*e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) -
    //   2*e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3)))/(3*A + 2*K) - e0*(2*e1'*(H_wheel_3 - H_wheel_1 -
    //   H_wheel_2) + 2*e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e0*(3*T - 4*H_wheel_1_2 - 4*H_wheel_2_2)) -
    //   e1*(2*e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e1*(3*T
    //   - 4*H_wheel_1_2 - 4*H_wheel_2_2)) - e2*(2*e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + 2*e3'*(H_wheel_1
    //   + H_wheel_2 - H_wheel_3) + e2*(3*T - 4*H_wheel_1_2 - 4*H_wheel_2_2))))/(9*(e0^2 + e1^2 + e2^2 +
    //   e3^2)^2)
    let r1_by_e0 = r1_of_e0_e1_e2_e3_2
        * (e2_dot * h_bus_1_times_36 - e1_dot * h_bus_2_times_36
            - w_S_in_axle_base_1_of_
                * (r1_of_motion
                    + e0
                        * ((-(e0 * r1_by_e0_of_place)).mul_add(S::int(4), r1_of_place_2)
                            - S::int(2) * e1_dot_minus_e2_dot * r1_by_e0_of_place_3)
                    + e1_doubled
                        * (-r1_by_e0_of_place)
                            .mul_add(
                                e1_doubled,
                                e0_dot_plus_e3_dot * r1_by_e0_of_place_3,
                            )
                    - e2_doubled
                        * r1_by_e0_of_place
                            .mul_add(
                                e2_doubled,
                                e0_dot_minus_e3_dot * r1_by_e0_of_place_3,
                            )
                    + k_r1_of_a_k
                        * (r1_of_motion_6
                            + e0
                                * (e0_doubled.mul_add(r1_by_e0_of_place, r1_of_place_5)
                                    + e3_dot_doubled * r1_by_e0_of_place_3
                                    + S::int(4) * e2_dot * r1_by_e0_of_place_4)
                            + e1_doubled
                                * ((-e2_dot)
                                    .mul_add(r1_by_e0_of_place_3, e1 * r1_by_e0_of_place)
                                    + e3_dot_doubled * r1_by_e0_of_place_4)
                            + e2_doubled
                                * (e1_dot
                                    .mul_add(r1_by_e0_of_place_3, e2 * r1_by_e0_of_place)
                                    - e0_dot_doubled * r1_by_e0_of_place_4)
                            + e3_doubled
                                * ((-e0_dot)
                                    .mul_add(r1_by_e0_of_place_3, e3 * r1_by_e0_of_place)
                                    - e1_dot_doubled * r1_by_e0_of_place_4))
                    - e3_doubled
                        * r1_by_e0_of_place
                            .mul_add(
                                e3_doubled,
                                e1_dot_plus_e2_dot * r1_by_e0_of_place_3,
                            )) + r1_by_e0_of_motion * r1_by_e0_of_place_5
            - k_r1_of_a_k_times_6
                * (r1_of_motion_14
                    + e0
                        * (w_S_3_by_e0.mul_add(e2_dot_c_times_6, -r1_of_place_9)
                            - e0 * r1_by_e0_of_place_7 - e3_dot * r1_by_e0_of_place_8)
                    + e1
                        * ((-e1)
                            .mul_add(r1_by_e0_of_place_7, e2_dot * r1_by_e0_of_place_8)
                            + w_S_3_by_e0 * e3_dot_c_times_6)
                    - e2
                        * (e1_dot.mul_add(r1_by_e0_of_place_8, e2 * r1_by_e0_of_place_7)
                            + w_S_3_by_e0 * e0_dot_c_times_6)
                    + e3
                        * ((-e3)
                            .mul_add(r1_by_e0_of_place_7, e0_dot * r1_by_e0_of_place_8)
                            - w_S_3_by_e0 * e1_dot_c_times_6)) + e0 * h_bus_3_2_times_72
            - e1_dot_plus_e2_dot * r1_of_place_7_times_6
            + w_S_1_by_e0 * r1_by_e0_of_motion_2 - w_S_2_by_e0 * r1_by_e0_of_motion_3
            + w_S_3_2_by_e0 * c_r1_of_e0_e1_e2_e3) - e0 * r1_by_e0_of_motion_4;
    // e3'*minus_r1_of_place_3 + w_S_3_of_motion_3*r1_by_e0_of_place_3
    let w3_dot_by_e0_of_motion = w_S_3_of_motion_3
        .mul_add(r1_by_e0_of_place_3, e3_dot * minus_r1_of_place_3);
    // e0_r1_of_place_5 + w_S_1_of_e0_e1_e2_e3*r1_by_e0_of_place
    let w3_dot_by_e0_of_place = w_S_1_of_e0_e1_e2_e3
        .mul_add(r1_by_e0_of_place, e0_r1_of_place_5);
    let e1_dot_r1_of_place_6 = e1_dot * r1_of_place_6;
    let e2_dot_r1_of_place_6 = e2_dot * r1_of_place_6;
    let w3_dot_by_e0_of_e0_e1_e2_e3 = S::int(3) * w_S_1_of_e0_e1_e2_e3;
    let w3_dot_by_e0_of_motion_2 = S::int(3) * w_S_3_of_motion_3;
    let r1_of_place_10_times_3 = S::int(3) * r1_of_place_10;
    let c_times_18 = S::int(18) * C;
    let w3_dot_by_e0_of_motion_3 = w_S_2_of_motion_3 * c_times_18;
    let h_bus_3_times_18 = S::int(18) * H_bus_3;
    let e2_dot_h_bus_3_times_18 = e2_dot * h_bus_3_times_18;
    // sqrt(3)*(w3_dot_of_motion_3*r1_by_e0_of_place_4 + w3_dot_by_e0_of_motion + w3_dot_by_e0_of_place +
    //   e2_dot_r1_of_place_6) - e0*r1_of_place_9_times_6 - r1_by_e0_of_place_7*w3_dot_by_e0_of_e0_e1_e2_e3 -
    //   r1_by_e0_of_place_8*w3_dot_by_e0_of_motion_2 - e3'*r1_of_place_10_times_3 +
    //   w_S_3_by_e0*w3_dot_by_e0_of_motion_3 + e2_dot_h_bus_3_times_18
    let w3_dot_by_e0_of_motion_4 = w_S_in_axle_base_1_of_
        * (w3_dot_of_motion_3.mul_add(r1_by_e0_of_place_4, w3_dot_by_e0_of_motion)
            + w3_dot_by_e0_of_place + e2_dot_r1_of_place_6) - e0 * r1_of_place_9_times_6
        - r1_by_e0_of_place_7 * w3_dot_by_e0_of_e0_e1_e2_e3
        - r1_by_e0_of_place_8 * w3_dot_by_e0_of_motion_2
        - e3_dot * r1_of_place_10_times_3 + w_S_3_by_e0 * w3_dot_by_e0_of_motion_3
        + e2_dot_h_bus_3_times_18;
    let w3_dot_by_e0_of_place_2 = S::int(3) * w3_dot_of_place_4;
    let w3_dot_by_e0_of_motion_5 = w_S_1_of_motion_3 * c_times_18;
    let e1_dot_h_bus_3_times_18 = e1_dot * h_bus_3_times_18;
    // e0*w3_dot_of_place_3 + sqrt(3)*(w3_dot_of_motion*r1_by_e0_of_place_4 + w3_dot_by_e0_of_motion -
    //   w3_dot_by_e0_of_place + e1_dot_r1_of_place_6) + w3_dot_by_e0_of_e0_e1_e2_e3*(r1_by_e0_of_place_6 +
    //   w_S_2_2_by_e0*b_times_6) + w3_dot_by_e0_of_motion_2*(k_r1_by_e0_of_place_5 - w_S_1_by_e0*a_times_6)
    //   - k_r1_of_a_k*w3_dot_by_e0_of_motion_4 - e3'*w3_dot_by_e0_of_place_2 +
    //   w_S_3_by_e0*w3_dot_by_e0_of_motion_5 + e1_dot_h_bus_3_times_18
    let w3_dot_by_e0_of_motion_6 = w_S_in_axle_base_1_of_
        * (w3_dot_of_motion.mul_add(r1_by_e0_of_place_4, w3_dot_by_e0_of_motion)
            - w3_dot_by_e0_of_place + e1_dot_r1_of_place_6) + e0 * w3_dot_of_place_3
        + w3_dot_by_e0_of_e0_e1_e2_e3 * w_S_2_2_by_e0.mul_add(b_times_6, r1_by_e0_of_place_6)
        + w3_dot_by_e0_of_motion_2 * (-w_S_1_by_e0).mul_add(a_times_6, k_r1_by_e0_of_place_5)
        - k_r1_of_a_k * w3_dot_by_e0_of_motion_4 - e3_dot * w3_dot_by_e0_of_place_2
        + w_S_3_by_e0 * w3_dot_by_e0_of_motion_5 + e1_dot_h_bus_3_times_18;
    let w3_dot_by_e0_of_place_3 = w3_dot_of_a_b_k_2 * w_S_1_by_e0_of_e0_e1_e2_e3;
    let w3_dot_by_e0_of_e0_e1_e2_e3_2 = S::int(2) * w_S_1_2_of_e0_e1_e2_e3;
    let w3_dot_by_e0_of_e0_e1_e2_e3_3 = e0 * w3_dot_by_e0_of_e0_e1_e2_e3_2;
    // w3_dot_by_e0 = (2*K*e0*(A + K)*(36*H_bus_3*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 6*(e2*e1' - e3*e0'
    //   - e1*e2' + e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_2_2
    //   - 6*H_bus_2_2 - H_wheel_1_2) + K*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' -
    //   e2*e1' + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 +
    //   e3^2)*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 +
    //   H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(3*A +
    //   2*K) + sqrt(3)*(2*(e1*e0' - e0*e1' - e3*e2' + e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   2*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 +
    //   e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/((3*A + 2*K)*(3*B + K*(2 - K/(3*A + 2*K)))*(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2) + 2*K*(A + K)*(18*e1'*H_bus_3 + 3*e3'*(H_wheel_1 - 6*H_bus_1 - H_wheel_2) +
    //   6*e0*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2) + 18*C*w_S_3_by_e0*(e0*e1' - e1*e0' + e3*e2' -
    //   e2*e3') + 3*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*A*w_S_1_by_e0 - K*w_S_in_axle_base_1_by_e0 +
    //   K*w_S_in_axle_base_2_by_e0) + 3*(e0^2 + e1^2 + e2^2 + e3^2)*(6*B*w_S_2_2_by_e0 +
    //   K*w_S_in_axle_base_1_2_by_e0 - K*w_S_in_axle_base_2_2_by_e0) - K*(18*e2'*H_bus_3 + 3*e3'*(H_wheel_2
    //   - 6*H_bus_2 - H_wheel_1) + 6*e0*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + 18*C*w_S_3_by_e0*(e0*e2'
    //   - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*B*w_S_2_by_e0 +
    //   K*w_S_in_axle_base_1_by_e0 - K*w_S_in_axle_base_2_by_e0) + 3*(e0^2 + e1^2 + e2^2 +
    //   e3^2)*(K*w_S_in_axle_base_1_2_by_e0 - 6*A*w_S_1_2_by_e0 - K*w_S_in_axle_base_2_2_by_e0) +
    //   sqrt(3)*(e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) +
    //   e0*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 + J*w_S_in_axle_base_3_by_e0) +
    //   (e2*e1' - e3*e0' - e1*e2' + e0*e3')*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 -
    //   2*J*w_S_in_axle_base_3_by_e0) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e0 +
    //   K*w_S_in_axle_base_2_2_by_e0)))/(3*A + 2*K) + sqrt(3)*(e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - e0*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e0*e1' -
    //   e1*e0' + e3*e2' - e2*e3')*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 +
    //   J*w_S_in_axle_base_3_by_e0) + (e2*e1' - e3*e0' - e1*e2' + e0*e3')*(K*w_S_in_axle_base_1_by_e0 +
    //   K*w_S_in_axle_base_2_by_e0 - 2*J*w_S_in_axle_base_3_by_e0) - (e0^2 + e1^2 + e2^2 +
    //   e3^2)*(K*w_S_in_axle_base_1_2_by_e0 + K*w_S_in_axle_base_2_2_by_e0)))/((3*A + 2*K)*(3*B + K*(2 -
    //   K/(3*A + 2*K)))*(e0^2 + e1^2 + e2^2 + e3^2)) + 3*r1_by_e0)/(3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A +
    //   K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A + 2*K)))))
    let w3_dot_by_e0 = w3_dot_of_a_b_c_k
        * (w3_dot_by_e0_of_motion_6
            .mul_add(w3_dot_by_e0_of_place_3, S::int(3) * r1_by_e0)
            + w3_dot_of_motion_7 * w3_dot_by_e0_of_e0_e1_e2_e3_3);
    // w2_dot_by_e0 = (2*e0*(36*H_bus_3*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 6*(e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_2_2 -
    //   6*H_bus_2_2 - H_wheel_1_2) + K*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' - e2*e1'
    //   + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2
    //   - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(3*A + 2*K) +
    //   sqrt(3)*(2*(e1*e0' - e0*e1' - e3*e2' + e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*(e3*e0' -
    //   e2*e1' + e1*e2' - e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T +
    //   2*H_wheel_1_2 + 2*H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 2*(18*e1'*H_bus_3 +
    //   3*e3'*(H_wheel_1 - 6*H_bus_1 - H_wheel_2) + 6*e0*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2) +
    //   18*C*w_S_3_by_e0*(e0*e1' - e1*e0' + e3*e2' - e2*e3') + 3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*A*w_S_1_by_e0 - K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0) + 3*(e0^2 + e1^2
    //   + e2^2 + e3^2)*(6*B*w_S_2_2_by_e0 + K*w_S_in_axle_base_1_2_by_e0 - K*w_S_in_axle_base_2_2_by_e0) -
    //   K*(18*e2'*H_bus_3 + 3*e3'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) + 6*e0*(H_wheel_1_2 - 6*H_bus_1_2 -
    //   H_wheel_2_2) + 18*C*w_S_3_by_e0*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*B*w_S_2_by_e0 + K*w_S_in_axle_base_1_by_e0 - K*w_S_in_axle_base_2_by_e0) + 3*(e0^2 + e1^2
    //   + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e0 - 6*A*w_S_1_2_by_e0 - K*w_S_in_axle_base_2_2_by_e0) +
    //   sqrt(3)*(e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) +
    //   e0*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 + J*w_S_in_axle_base_3_by_e0) +
    //   (e2*e1' - e3*e0' - e1*e2' + e0*e3')*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 -
    //   2*J*w_S_in_axle_base_3_by_e0) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e0 +
    //   K*w_S_in_axle_base_2_2_by_e0)))/(3*A + 2*K) + sqrt(3)*(e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - e0*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e0*e1' -
    //   e1*e0' + e3*e2' - e2*e3')*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 +
    //   J*w_S_in_axle_base_3_by_e0) + (e2*e1' - e3*e0' - e1*e2' + e0*e3')*(K*w_S_in_axle_base_1_by_e0 +
    //   K*w_S_in_axle_base_2_by_e0 - 2*J*w_S_in_axle_base_3_by_e0) - (e0^2 + e1^2 + e2^2 +
    //   e3^2)*(K*w_S_in_axle_base_1_2_by_e0 + K*w_S_in_axle_base_2_2_by_e0)))/(e0^2 + e1^2 + e2^2 + e3^2) +
    //   9*K*w3_dot_by_e0*(A + K)/(3*A + 2*K))/(3*(3*B + K*(2 - K/(3*A + 2*K))))
    let w2_dot_by_e0 = w3_dot_of_a_b_k_by_3
        * (w_S_1_by_e0_of_e0_e1_e2_e3
            .mul_add(w3_dot_by_e0_of_motion_6, w3_dot_by_e0 * w3_dot_of_a_k_2)
            + w3_dot_of_motion_6 * w3_dot_by_e0_of_e0_e1_e2_e3_3);
    // w3_dot_by_e0 + w2_dot_by_e0
    let w1_dot_by_e0_of_place = w3_dot_by_e0 + w2_dot_by_e0;
    // w1_dot_by_e0 = (2*e0*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 -
    //   6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2
    //   - 2*(18*e2'*H_bus_3 + 3*e3'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) + 6*e0*(H_wheel_1_2 - 6*H_bus_1_2 -
    //   H_wheel_2_2) + 18*C*w_S_3_by_e0*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*B*w_S_2_by_e0 + K*w_S_in_axle_base_1_by_e0 - K*w_S_in_axle_base_2_by_e0) + 3*(e0^2 + e1^2
    //   + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e0 - 6*A*w_S_1_2_by_e0 - K*w_S_in_axle_base_2_2_by_e0) +
    //   sqrt(3)*(e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) +
    //   e0*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 + J*w_S_in_axle_base_3_by_e0) +
    //   (e2*e1' - e3*e0' - e1*e2' + e0*e3')*(K*w_S_in_axle_base_1_by_e0 + K*w_S_in_axle_base_2_by_e0 -
    //   2*J*w_S_in_axle_base_3_by_e0) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e0 +
    //   K*w_S_in_axle_base_2_2_by_e0)))/(e0^2 + e1^2 + e2^2 + e3^2) + 3*K*(w3_dot_by_e0 +
    //   w2_dot_by_e0))/(3*(3*A + 2*K))
    let w1_dot_by_e0 = r1_of_a_k_by_3
        * ((-w_S_1_by_e0_of_e0_e1_e2_e3)
            .mul_add(
                w3_dot_by_e0_of_motion_4,
                w3_dot_of_motion_5 * w3_dot_by_e0_of_e0_e1_e2_e3_3,
            ) + k_times_3 * w1_dot_by_e0_of_place);
    let s_dot_by_e0_of_ = S::ratio(1, 3) * w_S_in_axle_base_1_of_;
    // s_dot_by_e0 = 4*w_S_in_axle_base_3_2_by_e0/3 - sqrt(3)*(w3_dot_by_e0 + w2_dot_by_e0 +
    //   w1_dot_by_e0)/3
    let s_dot_by_e0 = S::ratio(4, 3) * w_S_in_axle_base_3_2_by_e0
        - s_dot_by_e0_of_ * (w1_dot_by_e0 + w1_dot_by_e0_of_place);
    let e1_halved = S::ratio(1, 2) * e1;
    let e2_halved = S::ratio(1, 2) * e2;
    let e3_halved = S::ratio(1, 2) * e3;
    let e1_dot_sq = e1_dot * e1_dot;
    let e2_dot_sq = e2_dot * e2_dot;
    // e1_dot_sq + e2_dot_sq
    let e1_dot_sq_plus_e2_dot_sq = e1_dot_sq + e2_dot_sq;
    let e3_dot_sq = e3_dot * e3_dot;
    // e1_dot_sq_plus_e2_dot_sq + e3_dot_sq
    let e0_ddot_by_e0_of_motion = e1_dot_sq_plus_e2_dot_sq + e3_dot_sq;
    let e0_ddot_by_e0_of_motion_2 = e0 * e0_ddot_by_e0_of_motion;
    // e1_e1_dot + e3_e3_dot_plus_e2_e2_dot
    let e0_ddot_by_e0_of_motion_3 = e1_e1_dot + e3_e3_dot_plus_e2_e2_dot;
    let e0_ddot_by_e0_of_motion_4 = e0_dot * e0_ddot_by_e0_of_motion_3;
    let e0_dot_sq = e0_dot * e0_dot;
    // e3_dot_sq + e0_dot_sq
    let e3_dot_sq_plus_e0_dot_sq = e3_dot_sq + e0_dot_sq;
    // e1*(e2_dot_sq + e3_dot_sq_plus_e0_dot_sq)
    let e0_ddot_by_e0_of_motion_5 = e1 * (e2_dot_sq + e3_dot_sq_plus_e0_dot_sq);
    // e1_dot_sq + e3_dot_sq_plus_e0_dot_sq
    let e0_ddot_by_e0_of_motion_6 = e1_dot_sq + e3_dot_sq_plus_e0_dot_sq;
    let e0_ddot_by_e0_of_motion_7 = e2 * e0_ddot_by_e0_of_motion_6;
    // e1_dot_sq_plus_e2_dot_sq + e0_dot_sq
    let e0_ddot_by_e0_of_motion_8 = e1_dot_sq_plus_e2_dot_sq + e0_dot_sq;
    // e0*(e0_ddot_by_e0_of_motion_2 - e0_dot_doubled*e0_ddot_by_e0_of_motion_3) +
    //   e1*(e0_ddot_by_e0_of_motion_5 - e3_e3_dot_plus_e2_e2_dot*e1_dot_doubled) +
    //   e2*(e0_ddot_by_e0_of_motion_7 - e3_e3_dot*e2_dot_doubled) + e3_sq*e0_ddot_by_e0_of_motion_8
    let e0_ddot_by_e0_of_motion_9 = e0
        * (-e0_dot_doubled).mul_add(e0_ddot_by_e0_of_motion_3, e0_ddot_by_e0_of_motion_2)
        + e1
            * (-e3_e3_dot_plus_e2_e2_dot)
                .mul_add(e1_dot_doubled, e0_ddot_by_e0_of_motion_5)
        + e2 * (-e3_e3_dot).mul_add(e2_dot_doubled, e0_ddot_by_e0_of_motion_7)
        + e3_sq * e0_ddot_by_e0_of_motion_8;
    let e0_ddot_by_e0_of_motion_10 = w_S_1_2_of_e0_e1_e2_e3 * e0_ddot_by_e0_of_motion_9;
    let e0_ddot_by_e0_of_motion_11 = w_S_1_2_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e0_of_motion_10;
    // e0_ddot_by_e0 = 4*e0^2*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) -
    //   2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) +
    //   e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^3 - (e3^2*(e0'^2 + e1'^2
    //   + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 +
    //   e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2 + 2*e0*(e0'*(e1*e1' + e2*e2' + e3*e3') - e0*(e1'^2 + e2'^2 + e3'^2))/(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2 - e3*w3_dot_by_e0/2 - e2*w2_dot_by_e0/2 - e1*w1_dot_by_e0/2
    let e0_ddot_by_e0 = w3_dot_by_e0_of_e0_e1_e2_e3_3
        * (e0_ddot_by_e0_of_motion_4 - e0_ddot_by_e0_of_motion_2)
        - w1_dot_by_e0 * e1_halved - w2_dot_by_e0 * e2_halved - w3_dot_by_e0 * e3_halved
        - e0_ddot_by_e0_of_motion_10 + e0_sq * e0_ddot_by_e0_of_motion_11;
    let e0_halved = S::ratio(1, 2) * e0;
    let e1_ddot_by_e0_of_motion = w_S_1_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e0_of_motion_9;
    // e0_ddot_by_e0_of_motion_4 + e0*(e1_ddot_by_e0_of_motion - e0_ddot_by_e0_of_motion)
    let e1_ddot_by_e0_of_motion_2 = e0_ddot_by_e0_of_motion_4
        + e0 * (e1_ddot_by_e0_of_motion - e0_ddot_by_e0_of_motion);
    let e1_ddot_by_e0_of_e0_e1_e2_e3 = e1 * w3_dot_by_e0_of_e0_e1_e2_e3_2;
    let w1_dot_halved = S::ratio(1, 2) * w1_dot;
    // e1_ddot_by_e0 = 2*e1*(e0'*(e1*e1' + e2*e2' + e3*e3') + e0*(2*(e3^2*(e0'^2 + e1'^2 + e2'^2) +
    //   e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2)
    //   - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 +
    //   e3^2) - e1'^2 - e2'^2 - e3'^2))/(e0^2 + e1^2 + e2^2 + e3^2)^2 + w1'/2 + e2*w3_dot_by_e0/2 -
    //   e3*w2_dot_by_e0/2 + e0*w1_dot_by_e0/2
    let e1_ddot_by_e0 = (-w2_dot_by_e0).mul_add(e3_halved, w3_dot_by_e0 * e2_halved)
        + w1_dot_by_e0 * e0_halved
        + e1_ddot_by_e0_of_motion_2 * e1_ddot_by_e0_of_e0_e1_e2_e3 + w1_dot_halved;
    let e2_ddot_by_e0_of_e0_e1_e2_e3 = e2 * w3_dot_by_e0_of_e0_e1_e2_e3_2;
    let w2_dot_halved = S::ratio(1, 2) * w2_dot;
    // e2_ddot_by_e0 = 2*e2*(e0'*(e1*e1' + e2*e2' + e3*e3') + e0*(2*(e3^2*(e0'^2 + e1'^2 + e2'^2) +
    //   e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2)
    //   - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 +
    //   e3^2) - e1'^2 - e2'^2 - e3'^2))/(e0^2 + e1^2 + e2^2 + e3^2)^2 + w2'/2 - e1*w3_dot_by_e0/2 +
    //   e0*w2_dot_by_e0/2 + e3*w1_dot_by_e0/2
    let e2_ddot_by_e0 = (-w3_dot_by_e0).mul_add(e1_halved, w1_dot_by_e0 * e3_halved)
        + w2_dot_by_e0 * e0_halved
        + e1_ddot_by_e0_of_motion_2 * e2_ddot_by_e0_of_e0_e1_e2_e3 + w2_dot_halved;
    let e3_ddot_by_e0_of_e0_e1_e2_e3 = e3 * w3_dot_by_e0_of_e0_e1_e2_e3_2;
    let w3_dot_halved = S::ratio(1, 2) * w3_dot;
    // e3_ddot_by_e0 = 2*e3*(e0'*(e1*e1' + e2*e2' + e3*e3') + e0*(2*(e3^2*(e0'^2 + e1'^2 + e2'^2) +
    //   e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2)
    //   - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 +
    //   e3^2) - e1'^2 - e2'^2 - e3'^2))/(e0^2 + e1^2 + e2^2 + e3^2)^2 + w3'/2 + e0*w3_dot_by_e0/2 +
    //   e1*w2_dot_by_e0/2 - e2*w1_dot_by_e0/2
    let e3_ddot_by_e0 = (-w1_dot_by_e0).mul_add(e2_halved, w2_dot_by_e0 * e1_halved)
        + w3_dot_by_e0 * e0_halved
        + e1_ddot_by_e0_of_motion_2 * e3_ddot_by_e0_of_e0_e1_e2_e3 + w3_dot_halved;
    let w_S_1_by_e1_of_e0_e1_e2_e3 = e1 * w_S_1_by_e0_of_e0_e1_e2_e3;
    // w_S_1_by_e1 = -(e0' + 2*e1*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2))/(e0^2 +
    //   e1^2 + e2^2 + e3^2)
    let w_S_1_by_e1 = -w_s_1_of_e0_e1_e2_e3_inv
        * w_S_1_of_motion_3.mul_add(w_S_1_by_e1_of_e0_e1_e2_e3, e0_dot);
    // w_S_2_by_e1 = (e3' + 2*e1*(e2*e0' - e0*e2' + e3*e1' - e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2))/(e0^2 +
    //   e1^2 + e2^2 + e3^2)
    let w_S_2_by_e1 = w_s_1_of_e0_e1_e2_e3_inv
        * (-w_S_2_of_motion_3).mul_add(w_S_1_by_e1_of_e0_e1_e2_e3, e3_dot);
    // w_S_3_by_e1 = -(e2' + 2*e1*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2))/(e0^2 +
    //   e1^2 + e2^2 + e3^2)
    let w_S_3_by_e1 = -w_s_1_of_e0_e1_e2_e3_inv
        * w_S_3_of_motion_3.mul_add(w_S_1_by_e1_of_e0_e1_e2_e3, e2_dot);
    let w_S_in_axle_base_1_by_e1_of_e2_dot = e2_dot * w_S_in_axle_base_1_of_;
    let w_S_in_axle_base_1_by_e1_of_e3_dot = e3_dot * w_S_in_axle_base_1_by_e0_of_;
    let w_S_in_axle_base_1_by_e1_of_e0_dot = e0_dot * w_S_in_axle_base_1_by_e0_of__2;
    // w_S_in_axle_base_1_by_e1 = (3*e0'*(1 - 1/(3 + sqrt(3))) - e2'*sqrt(3) + 3*e3'/(3 + sqrt(3)) +
    //   2*e1*(3*e0*e1' - 3*e1*e0' + 3*e3*e2' - 3*e2*e3' + sqrt(3)*(e3*e0' - e2*e1' + e1*e2' - e0*e3') +
    //   3*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' + e3') + e1*(e0' - e3'))/(3 + sqrt(3)))/(e0^2 + e1^2 +
    //   e2^2 + e3^2))/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_1_by_e1 = w_s_1_of_e0_e1_e2_e3_inv
        * (w_S_in_axle_base_1_by_e0_of_motion_2
            .mul_add(w_S_1_by_e1_of_e0_e1_e2_e3, -w_S_in_axle_base_1_by_e1_of_e2_dot)
            + w_S_in_axle_base_1_by_e1_of_e3_dot - w_S_in_axle_base_1_by_e1_of_e0_dot);
    let w_S_in_axle_base_2_by_e1_of_e0_dot = e0_dot * w_S_in_axle_base_1_by_e0_of_;
    let w_S_in_axle_base_2_by_e1_of_e3_dot = e3_dot * w_S_in_axle_base_1_by_e0_of__2;
    // w_S_in_axle_base_2_by_e1 = -(3*e0'/(3 + sqrt(3)) + e2'*sqrt(3) + 3*e3'*(1 - 1/(3 + sqrt(3))) +
    //   2*e1*(3*e2*e0' - 3*e0*e2' + 3*e3*e1' - 3*e1*e3' - sqrt(3)*(e3*e0' - e2*e1' + e1*e2' - e0*e3') -
    //   3*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' + e3') + e1*(e0' - e3'))/(3 + sqrt(3)))/(e0^2 + e1^2 +
    //   e2^2 + e3^2))/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_2_by_e1 = w_s_1_of_e0_e1_e2_e3_inv
        * (w_S_in_axle_base_2_by_e0_of_motion
            .mul_add(w_S_1_by_e1_of_e0_e1_e2_e3, -w_S_in_axle_base_1_by_e1_of_e2_dot)
            - w_S_in_axle_base_2_by_e1_of_e0_dot + w_S_in_axle_base_2_by_e1_of_e3_dot);
    // w_S_in_axle_base_3_by_e1 = sqrt(3)*(e3' - e0' - e2' - 2*e1*(e3*(e2' - e0' - e1') + e0*(e1' + e2' +
    //   e3') + e1*(e3' - e0' - e2') + e2*(e1' - e0' - e3'))/(e0^2 + e1^2 + e2^2 + e3^2))/(e0^2 + e1^2 + e2^2
    //   + e3^2)
    let w_S_in_axle_base_3_by_e1 = -w_S_in_axle_base_3_of_e0_e1_e2_e3
        * w_S_in_axle_base_3_by_e0_of_motion_12
            .mul_add(w_S_1_by_e1_of_e0_e1_e2_e3, w_S_in_axle_base_3_by_e0_of_motion_3);
    // e1'*w_S_1_2_of_e0_e1_e2_e3 - e1*w_S_1_2_by_e0_of_motion
    let w_S_1_2_by_e1_of_motion = (-e1)
        .mul_add(w_S_1_2_by_e0_of_motion, e1_dot * w_S_1_2_of_e0_e1_e2_e3);
    let e0_dot_w_s_1_2_of_motion = e0_dot * w_S_1_2_of_motion;
    // w_S_1_2_by_e1 = e1'*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 - e0'*(e0*e0'
    //   + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 4*e1*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_1_2_by_e1 = w_S_1_of_motion_3
        .mul_add(w_S_1_2_by_e1_of_motion, -e0_dot_w_s_1_2_of_motion);
    // w_S_2_2_by_e1 = e1'*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + e3'*(e0*e0'
    //   + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 4*e1*(e2*e0' - e0*e2' + e3*e1' -
    //   e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_2_2_by_e1 = w_S_2_of_motion_3
        .mul_add(w_S_1_2_by_e1_of_motion, e3_dot_w_s_1_2_of_motion);
    // w_S_3_2_by_e1 = e1'*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 - e2'*(e0*e0'
    //   + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 4*e1*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_3_2_by_e1 = w_S_3_of_motion_3
        .mul_add(w_S_1_2_by_e1_of_motion, -e2_dot_w_s_1_2_of_motion);
    let w_S_in_axle_base_1_2_by_e1_of_motion = e2_dot * w_S_in_axle_base_1_2_by_e0_of_motion;
    let w_S_in_axle_base_1_2_by_e1_of_motion_2 = e0_dot * w_S_in_axle_base_1_2_by_e0_of_motion_4;
    let w_S_in_axle_base_1_2_by_e1_of_motion_3 = e3_dot * w_S_in_axle_base_1_2_by_e0_of_motion_6;
    // w_S_in_axle_base_1_2_by_e1 = 3*e1'*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2 + 3*e1'*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2
    //   + e3^2)^2) + e1'*sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 +
    //   3*e0'*(1 - 1/(3 + sqrt(3)))*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 -
    //   e2'*sqrt(3)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 3*e3'*(e0*e0' +
    //   e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + 12*e1*(1 - 1/(3 +
    //   sqrt(3)))*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^3 + 12*e1*(e2*e0' - e0*e2' + e3*e1' - e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 +
    //   sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^3) + 4*e1*sqrt(3)*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(e0*e0' +
    //   e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_in_axle_base_1_2_by_e1 = w_S_in_axle_base_1_of_motion_3
        .mul_add(w_S_1_2_by_e1_of_motion, -w_S_in_axle_base_1_2_by_e1_of_motion)
        - w_S_in_axle_base_1_2_by_e1_of_motion_2 + w_S_in_axle_base_1_2_by_e1_of_motion_3;
    let w_S_in_axle_base_2_2_by_e1_of_motion = e3_dot * w_S_in_axle_base_1_2_by_e0_of_motion_4;
    let w_S_in_axle_base_2_2_by_e1_of_motion_2 = e0_dot * w_S_in_axle_base_1_2_by_e0_of_motion_6;
    // w_S_in_axle_base_2_2_by_e1 = 3*e1'*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/((3 + sqrt(3))*(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2) + 3*e1'*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 + e1'*sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 -
    //   3*e0'*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) -
    //   e2'*sqrt(3)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 3*e3'*(1/(3 +
    //   sqrt(3)) - 1)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 12*e1*(e1*e0' -
    //   e0*e1' - e3*e2' + e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 +
    //   e3^2)^3) + 12*e1*(1 - 1/(3 + sqrt(3)))*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1' + e2*e2'
    //   + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3 + 4*e1*sqrt(3)*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(e0*e0' +
    //   e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_in_axle_base_2_2_by_e1 = w_S_in_axle_base_2_of_motion_2
        .mul_add(w_S_1_2_by_e1_of_motion, -w_S_in_axle_base_1_2_by_e1_of_motion)
        + w_S_in_axle_base_2_2_by_e1_of_motion - w_S_in_axle_base_2_2_by_e1_of_motion_2;
    // e3' - e2'
    let minus_e2_dot_plus_e3_dot = e3_dot - e2_dot;
    // -minus_e2_dot_plus_e3_dot
    let w_S_in_axle_base_3_2_by_e1_of_motion = -minus_e2_dot_plus_e3_dot;
    // w_S_in_axle_base_3_2_by_e1 = sqrt(3)*(e3*e3'^2 + e1'*(e3*(e2' - e0' - e1') + e0*(e1' + e2' + e3') +
    //   e2*(e1' - e0' - e3')) - e0'*(e2*e2' + e3*e3' + e0*(e0' + e2' - e3')) - e2'*(e3*e3' + e2*(e2' - e3'))
    //   - 2*e1*(e1'*(e0' + e2' - e3') + 2*(e3^2*e3'*(e2' - e0' - e1') + e0*(e3*e3'^2 + e0'*(e3*(e2' - e0' -
    //   e1') + e0*(e1' + e2' + e3') + e1*(e3' - e0' - e2') + e2*(e1' - e0' - e3')) + e1'*(e2*e2' + e3*e3' +
    //   e1*(e1' + e2' + e3')) + e2'*(e3*e3' + e2*(e2' + e3'))) - e1*(e3*e3'*(e0' - e3') + e1'*(e3*(e0' + e1'
    //   - e2') + e1*(e0' + e2' - e3') + e2*(e0' - e1' + e3')) + e2'*(e3*e3' + e2*(e0' + e2' - e3'))) -
    //   e2*(e2*e2'*(e0' - e1' + e3') + e3*(e2'*(e0' + e1' - e2') + e3'*(e0' - e1' + e3'))))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_3_2_by_e1 = w_S_in_axle_base_3_2_by_e0_of_e0_e1_e2_e3
        * (e1_dot
            * (w_S_in_axle_base_3_by_e0_of_motion_2 - w_S_in_axle_base_3_by_e0_of_motion_11)
            - e0_dot
                * e0
                    .mul_add(
                        w_S_in_axle_base_3_by_e0_of_motion_3, e3_e3_dot_plus_e2_e2_dot,
                    ) + e3_dot_e3_e3_dot
            - e1_doubled
                * e1_dot
                    .mul_add(
                        w_S_in_axle_base_3_by_e0_of_motion_3,
                        w_S_in_axle_base_3_2_by_e0_of_motion_4,
                    ) - e2_dot * e2.mul_add(w_S_in_axle_base_3_2_by_e1_of_motion, e3_e3_dot));
    // K*(w_S_in_axle_base_1_2_by_e1 + w_S_in_axle_base_2_2_by_e1)
    let r1_by_e1_of_place = K * (w_S_in_axle_base_1_2_by_e1 + w_S_in_axle_base_2_2_by_e1);
    // K*(w_S_in_axle_base_1_by_e1 + w_S_in_axle_base_2_by_e1)
    let r1_by_e1_of_place_2 = K * (w_S_in_axle_base_1_by_e1 + w_S_in_axle_base_2_by_e1);
    // r1_by_e1_of_place_2 - w_S_in_axle_base_3_by_e1*j_doubled
    let r1_by_e1_of_place_3 = (-w_S_in_axle_base_3_by_e1)
        .mul_add(j_doubled, r1_by_e1_of_place_2);
    // J*w_S_in_axle_base_3_by_e1 + r1_by_e1_of_place_2
    let r1_by_e1_of_place_4 = J.mul_add(w_S_in_axle_base_3_by_e1, r1_by_e1_of_place_2);
    // w_S_in_axle_base_1_by_e1 - w_S_in_axle_base_2_by_e1
    let r1_by_e1_of_place_5 = w_S_in_axle_base_1_by_e1 - w_S_in_axle_base_2_by_e1;
    // K*(w_S_in_axle_base_1_2_by_e1 - w_S_in_axle_base_2_2_by_e1)
    let r1_by_e1_of_place_6 = K * (w_S_in_axle_base_1_2_by_e1 - w_S_in_axle_base_2_2_by_e1);
    // w_S_1_2_by_e1*a_times_6 - r1_by_e1_of_place_6
    let r1_by_e1_of_place_7 = w_S_1_2_by_e1.mul_add(a_times_6, -r1_by_e1_of_place_6);
    let k_r1_by_e1_of_place_5 = K * r1_by_e1_of_place_5;
    // w_S_2_by_e1*b_times_6 + k_r1_by_e1_of_place_5
    let r1_by_e1_of_place_8 = w_S_2_by_e1.mul_add(b_times_6, k_r1_by_e1_of_place_5);
    // r1_by_e1 = (36*e3'*H_bus_1 + 36*e0'*H_bus_2 + 6*H_wheel_1*(e0' - e3') + 6*H_wheel_2*(e3' - e0') +
    //   72*e1*H_bus_3_2 + 36*A*w_S_1_by_e1*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 36*B*w_S_2_by_e1*(e1*e0' -
    //   e0*e1' - e3*e2' + e2*e3') + 6*K*w_S_in_axle_base_1_by_e1*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0'
    //   + e3') + e1*(e0' - e3')) + 6*K*w_S_in_axle_base_2_by_e1*(e0*(e1' + e2') - e3*(e1' - e2') - e2*(e0' +
    //   e3') - e1*(e0' - e3')) + 36*C*w_S_3_2_by_e1*(e0^2 + e1^2 + e2^2 + e3^2) +
    //   6*K*(e2*(6*C*e0'*w_S_3_by_e1 + e1'*(6*B*w_S_2_by_e1 + K*w_S_in_axle_base_1_by_e1 -
    //   K*w_S_in_axle_base_2_by_e1) + e2*(6*A*w_S_1_2_by_e1 - K*w_S_in_axle_base_1_2_by_e1 +
    //   K*w_S_in_axle_base_2_2_by_e1)) - 6*e3'*H_bus_3 - e2'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) -
    //   e1*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) - e0*(6*C*e2'*w_S_3_by_e1 +
    //   e3'*(K*w_S_in_axle_base_2_by_e1 - 6*B*w_S_2_by_e1 - K*w_S_in_axle_base_1_by_e1) +
    //   e0*(K*w_S_in_axle_base_1_2_by_e1 - 6*A*w_S_1_2_by_e1 - K*w_S_in_axle_base_2_2_by_e1)) -
    //   e1*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2 + 6*C*e3'*w_S_3_by_e1 - e2'*(K*w_S_in_axle_base_2_by_e1
    //   - 6*B*w_S_2_by_e1 - K*w_S_in_axle_base_1_by_e1) - e1*(6*A*w_S_1_2_by_e1 -
    //   K*w_S_in_axle_base_1_2_by_e1 + K*w_S_in_axle_base_2_2_by_e1)) + e3*(6*C*e1'*w_S_3_by_e1 +
    //   e0'*(K*w_S_in_axle_base_2_by_e1 - 6*B*w_S_2_by_e1 - K*w_S_in_axle_base_1_by_e1) +
    //   e3*(6*A*w_S_1_2_by_e1 - K*w_S_in_axle_base_1_2_by_e1 + K*w_S_in_axle_base_2_2_by_e1)))/(3*A + 2*K) +
    //   sqrt(3)*(2*e0*(e1'*(K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1 -
    //   2*J*w_S_in_axle_base_3_by_e1) + e2'*(2*J*w_S_in_axle_base_3_by_e1 - K*w_S_in_axle_base_1_by_e1 -
    //   K*w_S_in_axle_base_2_by_e1) + 2*e0*(K*w_S_in_axle_base_1_2_by_e1 + K*w_S_in_axle_base_2_2_by_e1)) -
    //   2*e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - e1*(3*T -
    //   4*H_wheel_1_2 - 4*H_wheel_2_2) - K*(2*e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*e2'*(H_wheel_3
    //   - H_wheel_1 - H_wheel_2) + e1*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) +
    //   2*e0*(2*e2'*(K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1 + J*w_S_in_axle_base_3_by_e1) +
    //   e3'*(K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1 - 2*J*w_S_in_axle_base_3_by_e1) +
    //   e0*(K*w_S_in_axle_base_1_2_by_e1 + K*w_S_in_axle_base_2_2_by_e1)) + e1*(3*T + 2*H_wheel_1_2 +
    //   2*H_wheel_2_2 + 4*e3'*(K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1 +
    //   J*w_S_in_axle_base_3_by_e1) + 2*e2'*(2*J*w_S_in_axle_base_3_by_e1 - K*w_S_in_axle_base_1_by_e1 -
    //   K*w_S_in_axle_base_2_by_e1) + 2*e1*(K*w_S_in_axle_base_1_2_by_e1 + K*w_S_in_axle_base_2_2_by_e1)) +
    //   2*e2*(e2*(K*w_S_in_axle_base_1_2_by_e1 + K*w_S_in_axle_base_2_2_by_e1) -
    //   2*e0'*(K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1 + J*w_S_in_axle_base_3_by_e1) -
    //   e1'*(2*J*w_S_in_axle_base_3_by_e1 - K*w_S_in_axle_base_1_by_e1 - K*w_S_in_axle_base_2_by_e1)) +
    //   2*e3*(e3*(K*w_S_in_axle_base_1_2_by_e1 + K*w_S_in_axle_base_2_2_by_e1) -
    //   2*e1'*(K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1 + J*w_S_in_axle_base_3_by_e1) -
    //   e0'*(K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1 - 2*J*w_S_in_axle_base_3_by_e1)))/(3*A
    //   + 2*K) - e1*(3*T - 4*H_wheel_1_2 - 4*H_wheel_2_2 + 2*e0'*(K*w_S_in_axle_base_1_by_e1 +
    //   K*w_S_in_axle_base_2_by_e1 - 2*J*w_S_in_axle_base_3_by_e1) + 2*e3'*(K*w_S_in_axle_base_1_by_e1 +
    //   K*w_S_in_axle_base_2_by_e1 - 2*J*w_S_in_axle_base_3_by_e1) - 4*e1*(K*w_S_in_axle_base_1_2_by_e1 +
    //   K*w_S_in_axle_base_2_2_by_e1)) - 2*e2*(e0'*(2*J*w_S_in_axle_base_3_by_e1 -
    //   K*w_S_in_axle_base_1_by_e1 - K*w_S_in_axle_base_2_by_e1) + e3'*(K*w_S_in_axle_base_1_by_e1 +
    //   K*w_S_in_axle_base_2_by_e1 - 2*J*w_S_in_axle_base_3_by_e1) - 2*e2*(K*w_S_in_axle_base_1_2_by_e1 +
    //   K*w_S_in_axle_base_2_2_by_e1)) + 2*e3*(e1'*(K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1
    //   - 2*J*w_S_in_axle_base_3_by_e1) + e2'*(K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1 -
    //   2*J*w_S_in_axle_base_3_by_e1) + 2*e3*(K*w_S_in_axle_base_1_2_by_e1 +
    //   K*w_S_in_axle_base_2_2_by_e1))))/(9*(e0^2 + e1^2 + e2^2 + e3^2)) - 2*e1*(36*H_bus_1*(e0*e2' - e2*e0'
    //   - e3*e1' + e1*e3') + 36*H_bus_2*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 6*H_wheel_1*(e3*(e1' - e2') -
    //   e0*(e1' + e2') + e2*(e0' + e3') + e1*(e0' - e3')) + 6*H_wheel_2*(e0*(e1' + e2') - e3*(e1' - e2') -
    //   e2*(e0' + e3') - e1*(e0' - e3')) + 36*H_bus_3_2*(e0^2 + e1^2 + e2^2 + e3^2) + 6*K*(e2*(6*e0'*H_bus_3
    //   + e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e2*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) -
    //   e0*(6*e2'*H_bus_3 + e3'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) + e0*(H_wheel_1_2 - 6*H_bus_1_2 -
    //   H_wheel_2_2)) - e1*(6*e3'*H_bus_3 + e2'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e1*(H_wheel_1_2 -
    //   6*H_bus_1_2 - H_wheel_2_2)) + e3*(6*e1'*H_bus_3 + e0'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) +
    //   e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)))/(3*A + 2*K) + sqrt(3)*(e3*(2*e1'*(H_wheel_1 +
    //   H_wheel_2 - H_wheel_3) + 2*e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e3*(4*H_wheel_1_2 - 3*T +
    //   4*H_wheel_2_2)) - K*(e0*(2*e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*e3'*(H_wheel_1 +
    //   H_wheel_2 - H_wheel_3) + e0*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)) + e1*(2*e3'*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + 2*e2'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e1*(3*T + 2*H_wheel_1_2 +
    //   2*H_wheel_2_2)) + e2*(e2*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) - 2*e0'*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) - 2*e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2)) + e3*(e3*(3*T + 2*H_wheel_1_2 +
    //   2*H_wheel_2_2) - 2*e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) - 2*e0'*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3)))/(3*A + 2*K) - e0*(2*e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + 2*e2'*(H_wheel_1 +
    //   H_wheel_2 - H_wheel_3) + e0*(3*T - 4*H_wheel_1_2 - 4*H_wheel_2_2)) - e1*(2*e0'*(H_wheel_1 +
    //   H_wheel_2 - H_wheel_3) + 2*e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e1*(3*T - 4*H_wheel_1_2 -
    //   4*H_wheel_2_2)) - e2*(2*e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + 2*e3'*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) + e2*(3*T - 4*H_wheel_1_2 - 4*H_wheel_2_2))))/(9*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let r1_by_e1 = r1_of_e0_e1_e2_e3_2
        * (e3_dot * h_bus_1_times_36 - w_S_2_by_e1 * r1_by_e0_of_motion_3
            + e0_dot * h_bus_2_times_36 + e1 * h_bus_3_2_times_72
            + e0_dot_minus_e3_dot * r1_of_place_7_times_6
            + w_S_1_by_e1 * r1_by_e0_of_motion_2 + w_S_3_2_by_e1 * c_r1_of_e0_e1_e2_e3
            - w_S_in_axle_base_1_of_
                * (r1_of_motion_2
                    + e1
                        * ((-(e1 * r1_by_e1_of_place)).mul_add(S::int(4), r1_of_place_2)
                            + S::int(2) * e0_dot_plus_e3_dot * r1_by_e1_of_place_3)
                    - e0_doubled
                        * e1_dot_minus_e2_dot
                            .mul_add(r1_by_e1_of_place_3, e0_doubled * r1_by_e1_of_place)
                    - e3_doubled
                        * e1_dot_plus_e2_dot
                            .mul_add(r1_by_e1_of_place_3, e3_doubled * r1_by_e1_of_place)
                    - e2_doubled
                        * e0_dot_minus_e3_dot
                            .mul_add(r1_by_e1_of_place_3, e2_doubled * r1_by_e1_of_place)
                    + k_r1_of_a_k
                        * (r1_of_motion_8
                            + e1
                                * (e1_doubled.mul_add(r1_by_e1_of_place, r1_of_place_5)
                                    - e2_dot_doubled * r1_by_e1_of_place_3
                                    + S::int(4) * e3_dot * r1_by_e1_of_place_4)
                            + e0_doubled
                                * (e3_dot
                                    .mul_add(r1_by_e1_of_place_3, e0 * r1_by_e1_of_place)
                                    + e2_dot_doubled * r1_by_e1_of_place_4)
                            + e2_doubled
                                * (e1_dot
                                    .mul_add(r1_by_e1_of_place_3, e2 * r1_by_e1_of_place)
                                    - e0_dot_doubled * r1_by_e1_of_place_4)
                            + e3_doubled
                                * ((-e0_dot)
                                    .mul_add(r1_by_e1_of_place_3, e3 * r1_by_e1_of_place)
                                    - e1_dot_doubled * r1_by_e1_of_place_4)))
            + r1_by_e0_of_motion * r1_by_e1_of_place_5
            - k_r1_of_a_k_times_6
                * (r1_of_motion_15
                    + e1
                        * (w_S_3_by_e1.mul_add(e3_dot_c_times_6, -r1_of_place_9)
                            - e1 * r1_by_e1_of_place_7 + e2_dot * r1_by_e1_of_place_8)
                    - e2
                        * (e2
                            .mul_add(r1_by_e1_of_place_7, w_S_3_by_e1 * e0_dot_c_times_6)
                            + e1_dot * r1_by_e1_of_place_8)
                    + e3
                        * ((-w_S_3_by_e1)
                            .mul_add(e1_dot_c_times_6, e0_dot * r1_by_e1_of_place_8)
                            - e3 * r1_by_e1_of_place_7)
                    + e0
                        * ((-e0)
                            .mul_add(r1_by_e1_of_place_7, w_S_3_by_e1 * e2_dot_c_times_6)
                            - e3_dot * r1_by_e1_of_place_8))) - e1 * r1_by_e0_of_motion_4;
    // e2'*minus_r1_of_place_3 - w_S_3_of_motion_3*r1_by_e1_of_place_3
    let w3_dot_by_e1_of_motion = (-w_S_3_of_motion_3)
        .mul_add(r1_by_e1_of_place_3, e2_dot * minus_r1_of_place_3);
    // e1_r1_of_place_5 + w_S_1_of_e0_e1_e2_e3*r1_by_e1_of_place
    let w3_dot_by_e1_of_place = w_S_1_of_e0_e1_e2_e3
        .mul_add(r1_by_e1_of_place, e1_r1_of_place_5);
    let e0_dot_r1_of_place_6 = e0_dot * r1_of_place_6;
    let e3_dot_r1_of_place_6 = e3_dot * r1_of_place_6;
    let e3_dot_h_bus_3_times_18 = e3_dot * h_bus_3_times_18;
    // e2'*r1_of_place_10_times_3 - e1*r1_of_place_9_times_6 + w_S_3_by_e1*w3_dot_by_e0_of_motion_3 -
    //   w3_dot_by_e0_of_e0_e1_e2_e3*r1_by_e1_of_place_7 - w3_dot_by_e0_of_motion_2*r1_by_e1_of_place_8 +
    //   sqrt(3)*(w3_dot_of_motion_3*r1_by_e1_of_place_4 - w3_dot_by_e1_of_motion + w3_dot_by_e1_of_place +
    //   e3_dot_r1_of_place_6) + e3_dot_h_bus_3_times_18
    let w3_dot_by_e1_of_motion_2 = e2_dot * r1_of_place_10_times_3
        - e1 * r1_of_place_9_times_6 + w_S_3_by_e1 * w3_dot_by_e0_of_motion_3
        - w3_dot_by_e0_of_e0_e1_e2_e3 * r1_by_e1_of_place_7
        - w3_dot_by_e0_of_motion_2 * r1_by_e1_of_place_8
        + w_S_in_axle_base_1_of_
            * (w3_dot_of_motion_3.mul_add(r1_by_e1_of_place_4, -w3_dot_by_e1_of_motion)
                + w3_dot_by_e1_of_place + e3_dot_r1_of_place_6) + e3_dot_h_bus_3_times_18;
    let e0_dot_h_bus_3_times_18 = e0_dot * h_bus_3_times_18;
    // w3_dot_by_e0_of_motion_2*(w_S_1_by_e1*a_times_6 - k_r1_by_e1_of_place_5) - e1*w3_dot_of_place_3 -
    //   e2'*w3_dot_by_e0_of_place_2 - w_S_3_by_e1*w3_dot_by_e0_of_motion_5 -
    //   w3_dot_by_e0_of_e0_e1_e2_e3*(w_S_2_2_by_e1*b_times_6 + r1_by_e1_of_place_6) +
    //   sqrt(3)*(w3_dot_by_e1_of_motion - w3_dot_of_motion*r1_by_e1_of_place_4 + w3_dot_by_e1_of_place +
    //   e0_dot_r1_of_place_6) + k_r1_of_a_k*w3_dot_by_e1_of_motion_2 + e0_dot_h_bus_3_times_18
    let w3_dot_by_e1_of_motion_3 = w3_dot_by_e0_of_motion_2
        * w_S_1_by_e1.mul_add(a_times_6, -k_r1_by_e1_of_place_5) - e1 * w3_dot_of_place_3
        - e2_dot * w3_dot_by_e0_of_place_2 - w_S_3_by_e1 * w3_dot_by_e0_of_motion_5
        - w3_dot_by_e0_of_e0_e1_e2_e3 * w_S_2_2_by_e1.mul_add(b_times_6, r1_by_e1_of_place_6)
        + w_S_in_axle_base_1_of_
            * ((-w3_dot_of_motion).mul_add(r1_by_e1_of_place_4, w3_dot_by_e1_of_motion)
                + w3_dot_by_e1_of_place + e0_dot_r1_of_place_6)
        + k_r1_of_a_k * w3_dot_by_e1_of_motion_2 + e0_dot_h_bus_3_times_18;
    // w3_dot_by_e1 = (2*K*e1*(A + K)*(36*H_bus_3*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 6*(e2*e1' - e3*e0'
    //   - e1*e2' + e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_2_2
    //   - 6*H_bus_2_2 - H_wheel_1_2) + K*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' -
    //   e2*e1' + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 +
    //   e3^2)*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 +
    //   H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(3*A +
    //   2*K) + sqrt(3)*(2*(e1*e0' - e0*e1' - e3*e2' + e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   2*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 +
    //   e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/((3*A + 2*K)*(3*B + K*(2 - K/(3*A + 2*K)))*(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2) - 2*K*(A + K)*(18*e0'*H_bus_3 + 3*e2'*(H_wheel_1 - 6*H_bus_1 - H_wheel_2) +
    //   6*e1*(H_wheel_2_2 - 6*H_bus_2_2 - H_wheel_1_2) + 18*C*w_S_3_by_e1*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3') + 3*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(6*A*w_S_1_by_e1 - K*w_S_in_axle_base_1_by_e1 +
    //   K*w_S_in_axle_base_2_by_e1) + 3*(e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_2_2_by_e1 -
    //   6*B*w_S_2_2_by_e1 - K*w_S_in_axle_base_1_2_by_e1) + K*(18*e3'*H_bus_3 + 3*e2'*(6*H_bus_2 + H_wheel_1
    //   - H_wheel_2) + 6*e1*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + 18*C*w_S_3_by_e1*(e0*e2' - e2*e0' -
    //   e3*e1' + e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*B*w_S_2_by_e1 +
    //   K*w_S_in_axle_base_1_by_e1 - K*w_S_in_axle_base_2_by_e1) + 3*(e0^2 + e1^2 + e2^2 +
    //   e3^2)*(K*w_S_in_axle_base_1_2_by_e1 - 6*A*w_S_1_2_by_e1 - K*w_S_in_axle_base_2_2_by_e1) +
    //   sqrt(3)*(e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e2'*(H_wheel_3 - H_wheel_1 - H_wheel_2) +
    //   e1*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1 + J*w_S_in_axle_base_3_by_e1) +
    //   (e2*e1' - e3*e0' - e1*e2' + e0*e3')*(K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1 -
    //   2*J*w_S_in_axle_base_3_by_e1) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e1 +
    //   K*w_S_in_axle_base_2_2_by_e1)))/(3*A + 2*K) + sqrt(3)*(e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e1*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e1*e0' -
    //   e0*e1' - e3*e2' + e2*e3')*(K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1 +
    //   J*w_S_in_axle_base_3_by_e1) + (e3*e0' - e2*e1' + e1*e2' - e0*e3')*(K*w_S_in_axle_base_1_by_e1 +
    //   K*w_S_in_axle_base_2_by_e1 - 2*J*w_S_in_axle_base_3_by_e1) + (e0^2 + e1^2 + e2^2 +
    //   e3^2)*(K*w_S_in_axle_base_1_2_by_e1 + K*w_S_in_axle_base_2_2_by_e1)))/((3*A + 2*K)*(3*B + K*(2 -
    //   K/(3*A + 2*K)))*(e0^2 + e1^2 + e2^2 + e3^2)) + 3*r1_by_e1)/(3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A +
    //   K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A + 2*K)))))
    let w3_dot_by_e1 = w3_dot_of_a_b_c_k
        * (w3_dot_of_motion_7.mul_add(e1_ddot_by_e0_of_e0_e1_e2_e3, S::int(3) * r1_by_e1)
            - w3_dot_by_e0_of_place_3 * w3_dot_by_e1_of_motion_3);
    // w2_dot_by_e1 = (2*e1*(36*H_bus_3*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 6*(e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_2_2 -
    //   6*H_bus_2_2 - H_wheel_1_2) + K*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' - e2*e1'
    //   + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2
    //   - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(3*A + 2*K) +
    //   sqrt(3)*(2*(e1*e0' - e0*e1' - e3*e2' + e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*(e3*e0' -
    //   e2*e1' + e1*e2' - e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T +
    //   2*H_wheel_1_2 + 2*H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2 - 2*(18*e0'*H_bus_3 +
    //   3*e2'*(H_wheel_1 - 6*H_bus_1 - H_wheel_2) + 6*e1*(H_wheel_2_2 - 6*H_bus_2_2 - H_wheel_1_2) +
    //   18*C*w_S_3_by_e1*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 3*(e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(6*A*w_S_1_by_e1 - K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1) + 3*(e0^2 + e1^2
    //   + e2^2 + e3^2)*(K*w_S_in_axle_base_2_2_by_e1 - 6*B*w_S_2_2_by_e1 - K*w_S_in_axle_base_1_2_by_e1) +
    //   K*(18*e3'*H_bus_3 + 3*e2'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*e1*(H_wheel_1_2 - 6*H_bus_1_2 -
    //   H_wheel_2_2) + 18*C*w_S_3_by_e1*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*B*w_S_2_by_e1 + K*w_S_in_axle_base_1_by_e1 - K*w_S_in_axle_base_2_by_e1) + 3*(e0^2 + e1^2
    //   + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e1 - 6*A*w_S_1_2_by_e1 - K*w_S_in_axle_base_2_2_by_e1) +
    //   sqrt(3)*(e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e2'*(H_wheel_3 - H_wheel_1 - H_wheel_2) +
    //   e1*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1 + J*w_S_in_axle_base_3_by_e1) +
    //   (e2*e1' - e3*e0' - e1*e2' + e0*e3')*(K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1 -
    //   2*J*w_S_in_axle_base_3_by_e1) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e1 +
    //   K*w_S_in_axle_base_2_2_by_e1)))/(3*A + 2*K) + sqrt(3)*(e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e1*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e1*e0' -
    //   e0*e1' - e3*e2' + e2*e3')*(K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1 +
    //   J*w_S_in_axle_base_3_by_e1) + (e3*e0' - e2*e1' + e1*e2' - e0*e3')*(K*w_S_in_axle_base_1_by_e1 +
    //   K*w_S_in_axle_base_2_by_e1 - 2*J*w_S_in_axle_base_3_by_e1) + (e0^2 + e1^2 + e2^2 +
    //   e3^2)*(K*w_S_in_axle_base_1_2_by_e1 + K*w_S_in_axle_base_2_2_by_e1)))/(e0^2 + e1^2 + e2^2 + e3^2) +
    //   9*K*w3_dot_by_e1*(A + K)/(3*A + 2*K))/(3*(3*B + K*(2 - K/(3*A + 2*K))))
    let w2_dot_by_e1 = w3_dot_of_a_b_k_by_3
        * ((-w_S_1_by_e0_of_e0_e1_e2_e3)
            .mul_add(w3_dot_by_e1_of_motion_3, w3_dot_by_e1 * w3_dot_of_a_k_2)
            + w3_dot_of_motion_6 * e1_ddot_by_e0_of_e0_e1_e2_e3);
    // w3_dot_by_e1 + w2_dot_by_e1
    let w1_dot_by_e1_of_place = w3_dot_by_e1 + w2_dot_by_e1;
    // w1_dot_by_e1 = (2*e1*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 -
    //   6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2
    //   - 2*(18*e3'*H_bus_3 + 3*e2'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*e1*(H_wheel_1_2 - 6*H_bus_1_2 -
    //   H_wheel_2_2) + 18*C*w_S_3_by_e1*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*B*w_S_2_by_e1 + K*w_S_in_axle_base_1_by_e1 - K*w_S_in_axle_base_2_by_e1) + 3*(e0^2 + e1^2
    //   + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e1 - 6*A*w_S_1_2_by_e1 - K*w_S_in_axle_base_2_2_by_e1) +
    //   sqrt(3)*(e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e2'*(H_wheel_3 - H_wheel_1 - H_wheel_2) +
    //   e1*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1 + J*w_S_in_axle_base_3_by_e1) +
    //   (e2*e1' - e3*e0' - e1*e2' + e0*e3')*(K*w_S_in_axle_base_1_by_e1 + K*w_S_in_axle_base_2_by_e1 -
    //   2*J*w_S_in_axle_base_3_by_e1) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e1 +
    //   K*w_S_in_axle_base_2_2_by_e1)))/(e0^2 + e1^2 + e2^2 + e3^2) + 3*K*(w3_dot_by_e1 +
    //   w2_dot_by_e1))/(3*(3*A + 2*K))
    let w1_dot_by_e1 = r1_of_a_k_by_3
        * ((-w_S_1_by_e0_of_e0_e1_e2_e3)
            .mul_add(
                w3_dot_by_e1_of_motion_2,
                w3_dot_of_motion_5 * e1_ddot_by_e0_of_e0_e1_e2_e3,
            ) + k_times_3 * w1_dot_by_e1_of_place);
    // s_dot_by_e1 = 4*w_S_in_axle_base_3_2_by_e1/3 - sqrt(3)*(w3_dot_by_e1 + w2_dot_by_e1 +
    //   w1_dot_by_e1)/3
    let s_dot_by_e1 = S::ratio(4, 3) * w_S_in_axle_base_3_2_by_e1
        - s_dot_by_e0_of_ * (w1_dot_by_e1 + w1_dot_by_e1_of_place);
    // e0_e0_dot + e3_e3_dot_plus_e2_e2_dot
    let e0_ddot_by_e1_of_motion = e0_e0_dot + e3_e3_dot_plus_e2_e2_dot;
    // e1*e0_ddot_by_e0_of_motion_11 + w3_dot_by_e0_of_e0_e1_e2_e3_2*(e1'*e0_ddot_by_e1_of_motion -
    //   e0_ddot_by_e0_of_motion_5)
    let e0_ddot_by_e1_of_motion_2 = w3_dot_by_e0_of_e0_e1_e2_e3_2
        * e1_dot.mul_add(e0_ddot_by_e1_of_motion, -e0_ddot_by_e0_of_motion_5)
        + e1 * e0_ddot_by_e0_of_motion_11;
    // e0_ddot_by_e1 = 4*e0*e1*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) -
    //   2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) +
    //   e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^3 + 2*e0*(e0*e0'*e1' -
    //   e1*(e0'^2 + e2'^2 + e3'^2) + e1'*(e2*e2' + e3*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2 - w1'/2 -
    //   e3*w3_dot_by_e1/2 - e2*w2_dot_by_e1/2 - e1*w1_dot_by_e1/2
    let e0_ddot_by_e1 = (-w1_dot_by_e1)
        .mul_add(e1_halved, e0 * e0_ddot_by_e1_of_motion_2) - w2_dot_by_e1 * e2_halved
        - w3_dot_by_e1 * e3_halved - w1_dot_halved;
    // e1_ddot_by_e1 = 4*e1^2*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) -
    //   2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) +
    //   e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^3 - (e3^2*(e0'^2 + e1'^2
    //   + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 +
    //   e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2 + 2*e1*(e0*e0'*e1' - e1*(e0'^2 + e2'^2 + e3'^2) + e1'*(e2*e2' + e3*e3'))/(e0^2
    //   + e1^2 + e2^2 + e3^2)^2 + e2*w3_dot_by_e1/2 - e3*w2_dot_by_e1/2 + e0*w1_dot_by_e1/2
    let e1_ddot_by_e1 = (-w2_dot_by_e1).mul_add(e3_halved, w3_dot_by_e1 * e2_halved)
        - e0_ddot_by_e0_of_motion_10 + w1_dot_by_e1 * e0_halved + e1 * e0_ddot_by_e1_of_motion_2;
    // e2_ddot_by_e1 = 4*e1*e2*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) -
    //   2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) +
    //   e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^3 + 2*e2*(e0*e0'*e1' -
    //   e1*(e0'^2 + e2'^2 + e3'^2) + e1'*(e2*e2' + e3*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2 - w3'/2 -
    //   e1*w3_dot_by_e1/2 + e0*w2_dot_by_e1/2 + e3*w1_dot_by_e1/2
    let e2_ddot_by_e1 = (-w3_dot_by_e1).mul_add(e1_halved, w1_dot_by_e1 * e3_halved)
        + w2_dot_by_e1 * e0_halved - w3_dot_halved + e2 * e0_ddot_by_e1_of_motion_2;
    // e3_ddot_by_e1 = 4*e1*e3*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) -
    //   2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) +
    //   e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^3 + 2*e3*(e0*e0'*e1' -
    //   e1*(e0'^2 + e2'^2 + e3'^2) + e1'*(e2*e2' + e3*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2 + w2'/2 +
    //   e0*w3_dot_by_e1/2 + e1*w2_dot_by_e1/2 - e2*w1_dot_by_e1/2
    let e3_ddot_by_e1 = (-w1_dot_by_e1).mul_add(e2_halved, w2_dot_by_e1 * e1_halved)
        + w3_dot_by_e1 * e0_halved + w2_dot_halved + e3 * e0_ddot_by_e1_of_motion_2;
    let w_S_1_by_e2_of_e0_e1_e2_e3 = e2 * w_S_1_by_e0_of_e0_e1_e2_e3;
    // w_S_1_by_e2 = -(e3' + 2*e2*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2))/(e0^2 +
    //   e1^2 + e2^2 + e3^2)
    let w_S_1_by_e2 = -w_s_1_of_e0_e1_e2_e3_inv
        * w_S_1_of_motion_3.mul_add(w_S_1_by_e2_of_e0_e1_e2_e3, e3_dot);
    // w_S_2_by_e2 = -(e0' + 2*e2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2))/(e0^2 +
    //   e1^2 + e2^2 + e3^2)
    let w_S_2_by_e2 = -w_s_1_of_e0_e1_e2_e3_inv
        * w_S_2_of_motion_3.mul_add(w_S_1_by_e2_of_e0_e1_e2_e3, e0_dot);
    // w_S_3_by_e2 = (e1' + 2*e2*(e3*e0' - e2*e1' + e1*e2' - e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2))/(e0^2 +
    //   e1^2 + e2^2 + e3^2)
    let w_S_3_by_e2 = w_s_1_of_e0_e1_e2_e3_inv
        * (-w_S_3_of_motion_3).mul_add(w_S_1_by_e2_of_e0_e1_e2_e3, e1_dot);
    let w_S_in_axle_base_1_by_e2_of_e1_dot = e1_dot * w_S_in_axle_base_1_of_;
    // w_S_in_axle_base_1_by_e2 = (e1'*sqrt(3) - 3*e0'/(3 + sqrt(3)) - 3*e3'*(1/(3 + sqrt(3)) - 1) -
    //   2*e2*(3*e1*e0' - 3*e0*e1' - 3*e3*e2' + 3*e2*e3' - sqrt(3)*(e3*e0' - e2*e1' + e1*e2' - e0*e3') -
    //   3*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' + e3') + e1*(e0' - e3'))/(3 + sqrt(3)))/(e0^2 + e1^2 +
    //   e2^2 + e3^2))/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_1_by_e2 = w_s_1_of_e0_e1_e2_e3_inv
        * (w_S_in_axle_base_1_by_e0_of_motion_2
            .mul_add(w_S_1_by_e2_of_e0_e1_e2_e3, -w_S_in_axle_base_2_by_e1_of_e0_dot)
            - w_S_in_axle_base_2_by_e1_of_e3_dot + w_S_in_axle_base_1_by_e2_of_e1_dot);
    // w_S_in_axle_base_2_by_e2 = (e1'*sqrt(3) - 3*e0'*(1/(3 + sqrt(3)) - 1) - 3*e3'/(3 + sqrt(3)) -
    //   2*e2*(3*e2*e0' - 3*e0*e2' + 3*e3*e1' - 3*e1*e3' - sqrt(3)*(e3*e0' - e2*e1' + e1*e2' - e0*e3') -
    //   3*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' + e3') + e1*(e0' - e3'))/(3 + sqrt(3)))/(e0^2 + e1^2 +
    //   e2^2 + e3^2))/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_2_by_e2 = w_s_1_of_e0_e1_e2_e3_inv
        * (w_S_in_axle_base_2_by_e0_of_motion
            .mul_add(w_S_1_by_e2_of_e0_e1_e2_e3, -w_S_in_axle_base_1_by_e1_of_e3_dot)
            - w_S_in_axle_base_1_by_e1_of_e0_dot + w_S_in_axle_base_1_by_e2_of_e1_dot);
    // w_S_in_axle_base_3_by_e2 = sqrt(3)*(e1' - e0' - e3' - 2*e2*(e3*(e2' - e0' - e1') + e0*(e1' + e2' +
    //   e3') + e1*(e3' - e0' - e2') + e2*(e1' - e0' - e3'))/(e0^2 + e1^2 + e2^2 + e3^2))/(e0^2 + e1^2 + e2^2
    //   + e3^2)
    let w_S_in_axle_base_3_by_e2 = w_S_in_axle_base_3_of_e0_e1_e2_e3
        * (-w_S_in_axle_base_3_by_e0_of_motion_12)
            .mul_add(w_S_1_by_e2_of_e0_e1_e2_e3, w_S_in_axle_base_3_by_e0_of_motion_8);
    // e2*w_S_1_2_by_e0_of_motion - e2'*w_S_1_2_of_e0_e1_e2_e3
    let w_S_1_2_by_e2_of_motion = (-e2_dot)
        .mul_add(w_S_1_2_of_e0_e1_e2_e3, e2 * w_S_1_2_by_e0_of_motion);
    // w_S_1_2_by_e2 = e2'*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 - e3'*(e0*e0'
    //   + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 4*e2*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_1_2_by_e2 = (-w_S_1_of_motion_3)
        .mul_add(w_S_1_2_by_e2_of_motion, -e3_dot_w_s_1_2_of_motion);
    // w_S_2_2_by_e2 = e2'*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 - e0'*(e0*e0'
    //   + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 4*e2*(e2*e0' - e0*e2' + e3*e1' -
    //   e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_2_2_by_e2 = (-w_S_2_of_motion_3)
        .mul_add(w_S_1_2_by_e2_of_motion, -e0_dot_w_s_1_2_of_motion);
    // w_S_3_2_by_e2 = e2'*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + e1'*(e0*e0'
    //   + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 4*e2*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_3_2_by_e2 = (-w_S_3_of_motion_3)
        .mul_add(w_S_1_2_by_e2_of_motion, e1_dot_w_s_1_2_of_motion);
    let w_S_in_axle_base_1_2_by_e2_of_motion = e1_dot * w_S_in_axle_base_1_2_by_e0_of_motion;
    // w_S_in_axle_base_1_2_by_e2 = 3*e2'*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2 + 3*e2'*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2
    //   + e3^2)^2) + e2'*sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 -
    //   3*e0'*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) +
    //   e1'*sqrt(3)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 3*e3'*(1 - 1/(3 +
    //   sqrt(3)))*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 12*e2*(1 - 1/(3 +
    //   sqrt(3)))*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^3 + 12*e2*(e2*e0' - e0*e2' + e3*e1' - e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 +
    //   sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^3) + 4*e2*sqrt(3)*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(e0*e0' +
    //   e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_in_axle_base_1_2_by_e2 = (-w_S_in_axle_base_1_of_motion_3)
        .mul_add(
            w_S_1_2_by_e2_of_motion,
            w_S_in_axle_base_1_2_by_e2_of_motion - w_S_in_axle_base_2_2_by_e1_of_motion
                - w_S_in_axle_base_2_2_by_e1_of_motion_2,
        );
    // w_S_in_axle_base_2_2_by_e2 = 3*e2'*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/((3 + sqrt(3))*(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2) + 3*e2'*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 + e2'*sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 +
    //   3*e0'*(1 - 1/(3 + sqrt(3)))*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 +
    //   e1'*sqrt(3)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 - 3*e3'*(e0*e0' +
    //   e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + 12*e2*(e1*e0' - e0*e1' -
    //   e3*e2' + e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^3) +
    //   12*e2*(1 - 1/(3 + sqrt(3)))*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1' + e2*e2' +
    //   e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3 + 4*e2*sqrt(3)*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(e0*e0' +
    //   e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_in_axle_base_2_2_by_e2 = (-w_S_in_axle_base_2_of_motion_2)
        .mul_add(
            w_S_1_2_by_e2_of_motion,
            w_S_in_axle_base_1_2_by_e2_of_motion - w_S_in_axle_base_1_2_by_e1_of_motion_2
                - w_S_in_axle_base_1_2_by_e1_of_motion_3,
        );
    // e1_e1_dot + e3_e3_dot
    let e1_e1_dot_plus_e3_e3_dot = e1_e1_dot + e3_e3_dot;
    // e1' - e3'
    let e1_dot_minus_e3_dot = e1_dot - e3_dot;
    // w_S_in_axle_base_3_2_by_e2 = sqrt(3)*(e2'*(e3*(e2' - e0' - e1') + e0*(e1' + e2' + e3') + e1*(e3' -
    //   e0' - e2')) - e3*e3'^2 - e0'*(e1*e1' + e3*e3' + e0*(e0' - e1' + e3')) + e1'*(e3*e3' + e1*(e1' -
    //   e3')) - 2*e2*(e2'*(e0' - e1' + e3') + 2*(e3^2*e3'*(e2' - e0' - e1') + e0*(e3*e3'^2 + e0'*(e3*(e2' -
    //   e0' - e1') + e0*(e1' + e2' + e3') + e1*(e3' - e0' - e2') + e2*(e1' - e0' - e3')) + e1'*(e2*e2' +
    //   e3*e3' + e1*(e1' + e2' + e3')) + e2'*(e3*e3' + e2*(e2' + e3'))) - e1*(e3*e3'*(e0' - e3') +
    //   e1'*(e3*(e0' + e1' - e2') + e1*(e0' + e2' - e3') + e2*(e0' - e1' + e3')) + e2'*(e3*e3' + e2*(e0' +
    //   e2' - e3'))) - e2*(e2*e2'*(e0' - e1' + e3') + e3*(e2'*(e0' + e1' - e2') + e3'*(e0' - e1' +
    //   e3'))))/(e0^2 + e1^2 + e2^2 + e3^2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_3_2_by_e2 = w_S_in_axle_base_3_2_by_e0_of_e0_e1_e2_e3
        * (e1_dot * e1.mul_add(e1_dot_minus_e3_dot, e3_e3_dot)
            - e2_dot
                * (w_S_in_axle_base_3_by_e0_of_motion_7
                    - w_S_in_axle_base_3_by_e0_of_motion_5) - e3_dot_e3_e3_dot
            - e2_doubled
                * e2_dot
                    .mul_add(
                        w_S_in_axle_base_3_by_e0_of_motion_9,
                        w_S_in_axle_base_3_2_by_e0_of_motion_4,
                    )
            - e0_dot
                * e0
                    .mul_add(
                        w_S_in_axle_base_3_by_e0_of_motion_9, e1_e1_dot_plus_e3_e3_dot,
                    ));
    // K*(w_S_in_axle_base_1_2_by_e2 + w_S_in_axle_base_2_2_by_e2)
    let r1_by_e2_of_place = K * (w_S_in_axle_base_1_2_by_e2 + w_S_in_axle_base_2_2_by_e2);
    // K*(w_S_in_axle_base_1_by_e2 + w_S_in_axle_base_2_by_e2)
    let r1_by_e2_of_place_2 = K * (w_S_in_axle_base_1_by_e2 + w_S_in_axle_base_2_by_e2);
    // r1_by_e2_of_place_2 - w_S_in_axle_base_3_by_e2*j_doubled
    let r1_by_e2_of_place_3 = (-w_S_in_axle_base_3_by_e2)
        .mul_add(j_doubled, r1_by_e2_of_place_2);
    // J*w_S_in_axle_base_3_by_e2 + r1_by_e2_of_place_2
    let r1_by_e2_of_place_4 = J.mul_add(w_S_in_axle_base_3_by_e2, r1_by_e2_of_place_2);
    // w_S_in_axle_base_1_by_e2 - w_S_in_axle_base_2_by_e2
    let r1_by_e2_of_place_5 = w_S_in_axle_base_1_by_e2 - w_S_in_axle_base_2_by_e2;
    // K*(w_S_in_axle_base_1_2_by_e2 - w_S_in_axle_base_2_2_by_e2)
    let r1_by_e2_of_place_6 = K * (w_S_in_axle_base_1_2_by_e2 - w_S_in_axle_base_2_2_by_e2);
    // w_S_1_2_by_e2*a_times_6 - r1_by_e2_of_place_6
    let r1_by_e2_of_place_7 = w_S_1_2_by_e2.mul_add(a_times_6, -r1_by_e2_of_place_6);
    let k_r1_by_e2_of_place_5 = K * r1_by_e2_of_place_5;
    // w_S_2_by_e2*b_times_6 + k_r1_by_e2_of_place_5
    let r1_by_e2_of_place_8 = w_S_2_by_e2.mul_add(b_times_6, k_r1_by_e2_of_place_5);
    // r1_by_e2 = (36*e3'*H_bus_2 - 36*e0'*H_bus_1 + 6*H_wheel_1*(e0' + e3') - 6*H_wheel_2*(e0' + e3') +
    //   72*e2*H_bus_3_2 + 36*A*w_S_1_by_e2*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 36*B*w_S_2_by_e2*(e1*e0' -
    //   e0*e1' - e3*e2' + e2*e3') + 6*K*w_S_in_axle_base_1_by_e2*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0'
    //   + e3') + e1*(e0' - e3')) + 6*K*w_S_in_axle_base_2_by_e2*(e0*(e1' + e2') - e3*(e1' - e2') - e2*(e0' +
    //   e3') - e1*(e0' - e3')) + 36*C*w_S_3_2_by_e2*(e0^2 + e1^2 + e2^2 + e3^2) +
    //   sqrt(3)*(2*e0*(e1'*(K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2 -
    //   2*J*w_S_in_axle_base_3_by_e2) + e2'*(2*J*w_S_in_axle_base_3_by_e2 - K*w_S_in_axle_base_1_by_e2 -
    //   K*w_S_in_axle_base_2_by_e2) + 2*e0*(K*w_S_in_axle_base_1_2_by_e2 + K*w_S_in_axle_base_2_2_by_e2)) -
    //   2*e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) - 2*e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) - e2*(3*T -
    //   4*H_wheel_1_2 - 4*H_wheel_2_2) - 2*e1*(e0'*(K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2
    //   - 2*J*w_S_in_axle_base_3_by_e2) + e3'*(K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2 -
    //   2*J*w_S_in_axle_base_3_by_e2) - 2*e1*(K*w_S_in_axle_base_1_2_by_e2 + K*w_S_in_axle_base_2_2_by_e2))
    //   - e2*(3*T - 4*H_wheel_1_2 - 4*H_wheel_2_2 + 2*e0'*(2*J*w_S_in_axle_base_3_by_e2 -
    //   K*w_S_in_axle_base_1_by_e2 - K*w_S_in_axle_base_2_by_e2) + 2*e3'*(K*w_S_in_axle_base_1_by_e2 +
    //   K*w_S_in_axle_base_2_by_e2 - 2*J*w_S_in_axle_base_3_by_e2) - 4*e2*(K*w_S_in_axle_base_1_2_by_e2 +
    //   K*w_S_in_axle_base_2_2_by_e2)) + 2*e3*(e1'*(K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2
    //   - 2*J*w_S_in_axle_base_3_by_e2) + e2'*(K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2 -
    //   2*J*w_S_in_axle_base_3_by_e2) + 2*e3*(K*w_S_in_axle_base_1_2_by_e2 + K*w_S_in_axle_base_2_2_by_e2))
    //   - K*(e2*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) - 2*e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) -
    //   2*e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + 2*e0*(2*e2'*(K*w_S_in_axle_base_1_by_e2 +
    //   K*w_S_in_axle_base_2_by_e2 + J*w_S_in_axle_base_3_by_e2) + e3'*(K*w_S_in_axle_base_1_by_e2 +
    //   K*w_S_in_axle_base_2_by_e2 - 2*J*w_S_in_axle_base_3_by_e2) + e0*(K*w_S_in_axle_base_1_2_by_e2 +
    //   K*w_S_in_axle_base_2_2_by_e2)) + 2*e1*(2*e3'*(K*w_S_in_axle_base_1_by_e2 +
    //   K*w_S_in_axle_base_2_by_e2 + J*w_S_in_axle_base_3_by_e2) + e2'*(2*J*w_S_in_axle_base_3_by_e2 -
    //   K*w_S_in_axle_base_1_by_e2 - K*w_S_in_axle_base_2_by_e2) + e1*(K*w_S_in_axle_base_1_2_by_e2 +
    //   K*w_S_in_axle_base_2_2_by_e2)) - e2*(4*e0'*(K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2
    //   + J*w_S_in_axle_base_3_by_e2) - 3*T - 2*H_wheel_1_2 - 2*H_wheel_2_2 -
    //   2*e1'*(K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2 - 2*J*w_S_in_axle_base_3_by_e2) -
    //   2*e2*(K*w_S_in_axle_base_1_2_by_e2 + K*w_S_in_axle_base_2_2_by_e2)) -
    //   2*e3*(2*e1'*(K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2 + J*w_S_in_axle_base_3_by_e2) +
    //   e0'*(K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2 - 2*J*w_S_in_axle_base_3_by_e2) -
    //   e3*(K*w_S_in_axle_base_1_2_by_e2 + K*w_S_in_axle_base_2_2_by_e2)))/(3*A + 2*K)) + 6*K*(6*e0'*H_bus_3
    //   + e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + e2*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2) -
    //   e0*(6*C*e2'*w_S_3_by_e2 + e3'*(K*w_S_in_axle_base_2_by_e2 - 6*B*w_S_2_by_e2 -
    //   K*w_S_in_axle_base_1_by_e2) + e0*(K*w_S_in_axle_base_1_2_by_e2 - 6*A*w_S_1_2_by_e2 -
    //   K*w_S_in_axle_base_2_2_by_e2)) - e1*(6*C*e3'*w_S_3_by_e2 + e2'*(6*B*w_S_2_by_e2 +
    //   K*w_S_in_axle_base_1_by_e2 - K*w_S_in_axle_base_2_by_e2) + e1*(K*w_S_in_axle_base_1_2_by_e2 -
    //   6*A*w_S_1_2_by_e2 - K*w_S_in_axle_base_2_2_by_e2)) + e2*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2 +
    //   6*C*e0'*w_S_3_by_e2 + e1'*(6*B*w_S_2_by_e2 + K*w_S_in_axle_base_1_by_e2 -
    //   K*w_S_in_axle_base_2_by_e2) + e2*(6*A*w_S_1_2_by_e2 - K*w_S_in_axle_base_1_2_by_e2 +
    //   K*w_S_in_axle_base_2_2_by_e2)) + e3*(6*C*e1'*w_S_3_by_e2 + e0'*(K*w_S_in_axle_base_2_by_e2 -
    //   6*B*w_S_2_by_e2 - K*w_S_in_axle_base_1_by_e2) + e3*(6*A*w_S_1_2_by_e2 - K*w_S_in_axle_base_1_2_by_e2
    //   + K*w_S_in_axle_base_2_2_by_e2)))/(3*A + 2*K))/(9*(e0^2 + e1^2 + e2^2 + e3^2)) -
    //   2*e2*(36*H_bus_1*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 36*H_bus_2*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3') + 6*H_wheel_1*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' + e3') + e1*(e0' - e3')) +
    //   6*H_wheel_2*(e0*(e1' + e2') - e3*(e1' - e2') - e2*(e0' + e3') - e1*(e0' - e3')) + 36*H_bus_3_2*(e0^2
    //   + e1^2 + e2^2 + e3^2) + 6*K*(e2*(6*e0'*H_bus_3 + e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) +
    //   e2*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) - e0*(6*e2'*H_bus_3 + e3'*(H_wheel_2 - 6*H_bus_2 -
    //   H_wheel_1) + e0*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2)) - e1*(6*e3'*H_bus_3 + e2'*(6*H_bus_2 +
    //   H_wheel_1 - H_wheel_2) + e1*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2)) + e3*(6*e1'*H_bus_3 +
    //   e0'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) + e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)))/(3*A + 2*K)
    //   + sqrt(3)*(e3*(2*e1'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + e3*(4*H_wheel_1_2 - 3*T + 4*H_wheel_2_2)) - K*(e0*(2*e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   2*e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e0*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)) +
    //   e1*(2*e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*e2'*(H_wheel_3 - H_wheel_1 - H_wheel_2) +
    //   e1*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)) + e2*(e2*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) -
    //   2*e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) - 2*e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2)) +
    //   e3*(e3*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) - 2*e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) -
    //   2*e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3)))/(3*A + 2*K) - e0*(2*e1'*(H_wheel_3 - H_wheel_1 -
    //   H_wheel_2) + 2*e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e0*(3*T - 4*H_wheel_1_2 - 4*H_wheel_2_2)) -
    //   e1*(2*e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e1*(3*T
    //   - 4*H_wheel_1_2 - 4*H_wheel_2_2)) - e2*(2*e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + 2*e3'*(H_wheel_1
    //   + H_wheel_2 - H_wheel_3) + e2*(3*T - 4*H_wheel_1_2 - 4*H_wheel_2_2))))/(9*(e0^2 + e1^2 + e2^2 +
    //   e3^2)^2)
    let r1_by_e2 = r1_of_e0_e1_e2_e3_2
        * (e3_dot * h_bus_2_times_36 - e0_dot * h_bus_1_times_36
            + e2 * h_bus_3_2_times_72 + e0_dot_plus_e3_dot * r1_of_place_7_times_6
            + w_S_1_by_e2 * r1_by_e0_of_motion_2 - w_S_2_by_e2 * r1_by_e0_of_motion_3
            + w_S_3_2_by_e2 * c_r1_of_e0_e1_e2_e3
            - w_S_in_axle_base_1_of_
                * (r1_of_motion_3
                    + e2
                        * ((-(e2 * r1_by_e2_of_place)).mul_add(S::int(4), r1_of_place_2)
                            - S::int(2) * e0_dot_minus_e3_dot * r1_by_e2_of_place_3)
                    - e0_doubled
                        * e1_dot_minus_e2_dot
                            .mul_add(r1_by_e2_of_place_3, e0_doubled * r1_by_e2_of_place)
                    + e1_doubled
                        * (-e1_doubled)
                            .mul_add(
                                r1_by_e2_of_place,
                                e0_dot_plus_e3_dot * r1_by_e2_of_place_3,
                            )
                    - e3_doubled
                        * e1_dot_plus_e2_dot
                            .mul_add(r1_by_e2_of_place_3, e3_doubled * r1_by_e2_of_place)
                    + k_r1_of_a_k
                        * (r1_of_motion_10
                            + e2
                                * (e2_doubled.mul_add(r1_by_e2_of_place, r1_of_place_5)
                                    + e1_dot_doubled * r1_by_e2_of_place_3
                                    - S::int(4) * e0_dot * r1_by_e2_of_place_4)
                            + e0_doubled
                                * (e3_dot
                                    .mul_add(r1_by_e2_of_place_3, e0 * r1_by_e2_of_place)
                                    + e2_dot_doubled * r1_by_e2_of_place_4)
                            + e1_doubled
                                * ((-e2_dot)
                                    .mul_add(r1_by_e2_of_place_3, e1 * r1_by_e2_of_place)
                                    + e3_dot_doubled * r1_by_e2_of_place_4)
                            + e3_doubled
                                * ((-e0_dot)
                                    .mul_add(r1_by_e2_of_place_3, e3 * r1_by_e2_of_place)
                                    - e1_dot_doubled * r1_by_e2_of_place_4)))
            + r1_by_e0_of_motion * r1_by_e2_of_place_5
            + k_r1_of_a_k_times_6
                * (r1_of_motion_16
                    + e2
                        * (w_S_3_by_e2.mul_add(e0_dot_c_times_6, r1_of_place_9)
                            + e2 * r1_by_e2_of_place_7 + e1_dot * r1_by_e2_of_place_8)
                    + e3
                        * (e3
                            .mul_add(r1_by_e2_of_place_7, w_S_3_by_e2 * e1_dot_c_times_6)
                            - e0_dot * r1_by_e2_of_place_8)
                    + e0
                        * ((-w_S_3_by_e2)
                            .mul_add(e2_dot_c_times_6, e0 * r1_by_e2_of_place_7)
                            + e3_dot * r1_by_e2_of_place_8)
                    + e1
                        * ((-w_S_3_by_e2)
                            .mul_add(e3_dot_c_times_6, e1 * r1_by_e2_of_place_7)
                            - e2_dot * r1_by_e2_of_place_8))) - e2 * r1_by_e0_of_motion_4;
    // e1'*minus_r1_of_place_3 + w_S_3_of_motion_3*r1_by_e2_of_place_3
    let w3_dot_by_e2_of_motion = w_S_3_of_motion_3
        .mul_add(r1_by_e2_of_place_3, e1_dot * minus_r1_of_place_3);
    // e2_r1_of_place_5 + w_S_1_of_e0_e1_e2_e3*r1_by_e2_of_place
    let w3_dot_by_e2_of_place = w_S_1_of_e0_e1_e2_e3
        .mul_add(r1_by_e2_of_place, e2_r1_of_place_5);
    // e2*r1_of_place_9_times_6 + e1'*r1_of_place_10_times_3 - w_S_3_by_e2*w3_dot_by_e0_of_motion_3 +
    //   e0_dot_h_bus_3_times_18 + w3_dot_by_e0_of_e0_e1_e2_e3*r1_by_e2_of_place_7 +
    //   w3_dot_by_e0_of_motion_2*r1_by_e2_of_place_8 + sqrt(3)*(e0_dot_r1_of_place_6 -
    //   w3_dot_of_motion_3*r1_by_e2_of_place_4 - w3_dot_by_e2_of_motion - w3_dot_by_e2_of_place)
    let w3_dot_by_e2_of_motion_2 = e2 * r1_of_place_9_times_6
        + e1_dot * r1_of_place_10_times_3 - w_S_3_by_e2 * w3_dot_by_e0_of_motion_3
        + e0_dot_h_bus_3_times_18 + w3_dot_by_e0_of_e0_e1_e2_e3 * r1_by_e2_of_place_7
        + w3_dot_by_e0_of_motion_2 * r1_by_e2_of_place_8
        + w_S_in_axle_base_1_of_
            * ((-w3_dot_of_motion_3).mul_add(r1_by_e2_of_place_4, e0_dot_r1_of_place_6)
                - w3_dot_by_e2_of_motion - w3_dot_by_e2_of_place);
    // e1'*w3_dot_by_e0_of_place_2 - e2*w3_dot_of_place_3 - w_S_3_by_e2*w3_dot_by_e0_of_motion_5 +
    //   e3_dot_h_bus_3_times_18 - w3_dot_by_e0_of_e0_e1_e2_e3*(w_S_2_2_by_e2*b_times_6 +
    //   r1_by_e2_of_place_6) + w3_dot_by_e0_of_motion_2*(w_S_1_by_e2*a_times_6 - k_r1_by_e2_of_place_5) +
    //   sqrt(3)*(e3_dot_r1_of_place_6 - w3_dot_of_motion*r1_by_e2_of_place_4 - w3_dot_by_e2_of_motion +
    //   w3_dot_by_e2_of_place) - k_r1_of_a_k*w3_dot_by_e2_of_motion_2
    let w3_dot_by_e2_of_motion_3 = e1_dot * w3_dot_by_e0_of_place_2
        - e2 * w3_dot_of_place_3 - w_S_3_by_e2 * w3_dot_by_e0_of_motion_5 + e3_dot_h_bus_3_times_18
        - w3_dot_by_e0_of_e0_e1_e2_e3 * w_S_2_2_by_e2.mul_add(b_times_6, r1_by_e2_of_place_6)
        + w3_dot_by_e0_of_motion_2 * w_S_1_by_e2.mul_add(a_times_6, -k_r1_by_e2_of_place_5)
        + w_S_in_axle_base_1_of_
            * ((-w3_dot_of_motion).mul_add(r1_by_e2_of_place_4, e3_dot_r1_of_place_6)
                - w3_dot_by_e2_of_motion + w3_dot_by_e2_of_place)
        - k_r1_of_a_k * w3_dot_by_e2_of_motion_2;
    // w3_dot_by_e2 = (2*K*e2*(A + K)*(36*H_bus_3*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 6*(e2*e1' - e3*e0'
    //   - e1*e2' + e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_2_2
    //   - 6*H_bus_2_2 - H_wheel_1_2) + K*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' -
    //   e2*e1' + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 +
    //   e3^2)*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 +
    //   H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(3*A +
    //   2*K) + sqrt(3)*(2*(e1*e0' - e0*e1' - e3*e2' + e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   2*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 +
    //   e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/((3*A + 2*K)*(3*B + K*(2 - K/(3*A + 2*K)))*(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2) + 2*K*(A + K)*(K*(18*e0'*H_bus_3 + 3*e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2)
    //   + 6*e2*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2) + 18*C*w_S_3_by_e2*(e2*e0' - e0*e2' + e3*e1' -
    //   e1*e3') + 3*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(6*B*w_S_2_by_e2 + K*w_S_in_axle_base_1_by_e2 -
    //   K*w_S_in_axle_base_2_by_e2) + 3*(e0^2 + e1^2 + e2^2 + e3^2)*(6*A*w_S_1_2_by_e2 -
    //   K*w_S_in_axle_base_1_2_by_e2 + K*w_S_in_axle_base_2_2_by_e2) + sqrt(3)*(e0'*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) - e2*(3*T + 2*H_wheel_1_2 +
    //   2*H_wheel_2_2) + 2*(e2*e0' - e0*e2' + e3*e1' - e1*e3')*(K*w_S_in_axle_base_1_by_e2 +
    //   K*w_S_in_axle_base_2_by_e2 + J*w_S_in_axle_base_3_by_e2) + (e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2 - 2*J*w_S_in_axle_base_3_by_e2) -
    //   (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e2 + K*w_S_in_axle_base_2_2_by_e2)))/(3*A +
    //   2*K) - 18*e3'*H_bus_3 - 3*e1'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) - 6*e2*(H_wheel_2_2 - 6*H_bus_2_2
    //   - H_wheel_1_2) - 18*C*w_S_3_by_e2*(e1*e0' - e0*e1' - e3*e2' + e2*e3') - 3*(e2*e1' - e3*e0' - e1*e2'
    //   + e0*e3')*(6*A*w_S_1_by_e2 - K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2) - 3*(e0^2 +
    //   e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_2_2_by_e2 - 6*B*w_S_2_2_by_e2 -
    //   K*w_S_in_axle_base_1_2_by_e2) - sqrt(3)*(e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + e2*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e1*e0' -
    //   e0*e1' - e3*e2' + e2*e3')*(K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2 +
    //   J*w_S_in_axle_base_3_by_e2) + (e3*e0' - e2*e1' + e1*e2' - e0*e3')*(K*w_S_in_axle_base_1_by_e2 +
    //   K*w_S_in_axle_base_2_by_e2 - 2*J*w_S_in_axle_base_3_by_e2) + (e0^2 + e1^2 + e2^2 +
    //   e3^2)*(K*w_S_in_axle_base_1_2_by_e2 + K*w_S_in_axle_base_2_2_by_e2)))/((3*A + 2*K)*(3*B + K*(2 -
    //   K/(3*A + 2*K)))*(e0^2 + e1^2 + e2^2 + e3^2)) + 3*r1_by_e2)/(3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A +
    //   K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A + 2*K)))))
    let w3_dot_by_e2 = w3_dot_of_a_b_c_k
        * (w3_dot_of_motion_7.mul_add(e2_ddot_by_e0_of_e0_e1_e2_e3, S::int(3) * r1_by_e2)
            - w3_dot_by_e0_of_place_3 * w3_dot_by_e2_of_motion_3);
    // w2_dot_by_e2 = (2*e2*(36*H_bus_3*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 6*(e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_2_2 -
    //   6*H_bus_2_2 - H_wheel_1_2) + K*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' - e2*e1'
    //   + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2
    //   - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(3*A + 2*K) +
    //   sqrt(3)*(2*(e1*e0' - e0*e1' - e3*e2' + e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*(e3*e0' -
    //   e2*e1' + e1*e2' - e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T +
    //   2*H_wheel_1_2 + 2*H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 2*(K*(18*e0'*H_bus_3 +
    //   3*e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*e2*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2) +
    //   18*C*w_S_3_by_e2*(e2*e0' - e0*e2' + e3*e1' - e1*e3') + 3*(e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(6*B*w_S_2_by_e2 + K*w_S_in_axle_base_1_by_e2 - K*w_S_in_axle_base_2_by_e2) + 3*(e0^2 + e1^2
    //   + e2^2 + e3^2)*(6*A*w_S_1_2_by_e2 - K*w_S_in_axle_base_1_2_by_e2 + K*w_S_in_axle_base_2_2_by_e2) +
    //   sqrt(3)*(e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) -
    //   e2*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e2*e0' - e0*e2' + e3*e1' -
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2 + J*w_S_in_axle_base_3_by_e2) +
    //   (e3*e0' - e2*e1' + e1*e2' - e0*e3')*(K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2 -
    //   2*J*w_S_in_axle_base_3_by_e2) - (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e2 +
    //   K*w_S_in_axle_base_2_2_by_e2)))/(3*A + 2*K) - 18*e3'*H_bus_3 - 3*e1'*(6*H_bus_1 - H_wheel_1 +
    //   H_wheel_2) - 6*e2*(H_wheel_2_2 - 6*H_bus_2_2 - H_wheel_1_2) - 18*C*w_S_3_by_e2*(e1*e0' - e0*e1' -
    //   e3*e2' + e2*e3') - 3*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(6*A*w_S_1_by_e2 -
    //   K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2) - 3*(e0^2 + e1^2 + e2^2 +
    //   e3^2)*(K*w_S_in_axle_base_2_2_by_e2 - 6*B*w_S_2_2_by_e2 - K*w_S_in_axle_base_1_2_by_e2) -
    //   sqrt(3)*(e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) +
    //   e2*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3')*(K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2 + J*w_S_in_axle_base_3_by_e2) +
    //   (e3*e0' - e2*e1' + e1*e2' - e0*e3')*(K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2 -
    //   2*J*w_S_in_axle_base_3_by_e2) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e2 +
    //   K*w_S_in_axle_base_2_2_by_e2)))/(e0^2 + e1^2 + e2^2 + e3^2) + 9*K*w3_dot_by_e2*(A + K)/(3*A +
    //   2*K))/(3*(3*B + K*(2 - K/(3*A + 2*K))))
    let w2_dot_by_e2 = w3_dot_of_a_b_k_by_3
        * ((-w_S_1_by_e0_of_e0_e1_e2_e3)
            .mul_add(w3_dot_by_e2_of_motion_3, w3_dot_by_e2 * w3_dot_of_a_k_2)
            + w3_dot_of_motion_6 * e2_ddot_by_e0_of_e0_e1_e2_e3);
    // w3_dot_by_e2 + w2_dot_by_e2
    let w1_dot_by_e2_of_place = w3_dot_by_e2 + w2_dot_by_e2;
    // w1_dot_by_e2 = (2*e2*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 -
    //   6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2
    //   + 2*(18*e0'*H_bus_3 + 3*e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*e2*(6*H_bus_1_2 - H_wheel_1_2 +
    //   H_wheel_2_2) + 18*C*w_S_3_by_e2*(e2*e0' - e0*e2' + e3*e1' - e1*e3') + 3*(e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(6*B*w_S_2_by_e2 + K*w_S_in_axle_base_1_by_e2 - K*w_S_in_axle_base_2_by_e2) + 3*(e0^2 + e1^2
    //   + e2^2 + e3^2)*(6*A*w_S_1_2_by_e2 - K*w_S_in_axle_base_1_2_by_e2 + K*w_S_in_axle_base_2_2_by_e2) +
    //   sqrt(3)*(e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2) -
    //   e2*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e2*e0' - e0*e2' + e3*e1' -
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2 + J*w_S_in_axle_base_3_by_e2) +
    //   (e3*e0' - e2*e1' + e1*e2' - e0*e3')*(K*w_S_in_axle_base_1_by_e2 + K*w_S_in_axle_base_2_by_e2 -
    //   2*J*w_S_in_axle_base_3_by_e2) - (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e2 +
    //   K*w_S_in_axle_base_2_2_by_e2)))/(e0^2 + e1^2 + e2^2 + e3^2) + 3*K*(w3_dot_by_e2 +
    //   w2_dot_by_e2))/(3*(3*A + 2*K))
    let w1_dot_by_e2 = r1_of_a_k_by_3
        * (w_S_1_by_e0_of_e0_e1_e2_e3
            .mul_add(
                w3_dot_by_e2_of_motion_2,
                w3_dot_of_motion_5 * e2_ddot_by_e0_of_e0_e1_e2_e3,
            ) + k_times_3 * w1_dot_by_e2_of_place);
    // s_dot_by_e2 = 4*w_S_in_axle_base_3_2_by_e2/3 - sqrt(3)*(w3_dot_by_e2 + w2_dot_by_e2 +
    //   w1_dot_by_e2)/3
    let s_dot_by_e2 = S::ratio(4, 3) * w_S_in_axle_base_3_2_by_e2
        - s_dot_by_e0_of_ * (w1_dot_by_e2 + w1_dot_by_e2_of_place);
    // e1_e1_dot_plus_e0_e0_dot + e3_e3_dot
    let e0_ddot_by_e2_of_motion = e1_e1_dot_plus_e0_e0_dot + e3_e3_dot;
    let e0_ddot_by_e2_of_motion_2 = e2_dot * e0_ddot_by_e2_of_motion;
    // e2*(e0_ddot_by_e0_of_motion_6 - e1_ddot_by_e0_of_motion) - e0_ddot_by_e2_of_motion_2
    let e0_ddot_by_e2_of_motion_3 = e2 * (e0_ddot_by_e0_of_motion_6 - e1_ddot_by_e0_of_motion)
        - e0_ddot_by_e2_of_motion_2;
    // e0_ddot_by_e2 = 2*e0*(e2'*(e0*e0' + e1*e1' + e3*e3') - e2*(e0'^2 + e1'^2 + e3'^2 - 2*(e3^2*(e0'^2 +
    //   e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2
    //   + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2
    //   + e1^2 + e2^2 + e3^2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2 - w2'/2 - e3*w3_dot_by_e2/2 -
    //   e2*w2_dot_by_e2/2 - e1*w1_dot_by_e2/2
    let e0_ddot_by_e2 = (-w2_dot_by_e2).mul_add(e2_halved, -w1_dot_by_e2 * e1_halved)
        - w3_dot_by_e2 * e3_halved - w2_dot_halved
        - w3_dot_by_e0_of_e0_e1_e2_e3_3 * e0_ddot_by_e2_of_motion_3;
    // e1_ddot_by_e2 = 2*e1*(e2'*(e0*e0' + e1*e1' + e3*e3') - e2*(e0'^2 + e1'^2 + e3'^2 - 2*(e3^2*(e0'^2 +
    //   e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2
    //   + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2
    //   + e1^2 + e2^2 + e3^2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2 + w3'/2 + e2*w3_dot_by_e2/2 -
    //   e3*w2_dot_by_e2/2 + e0*w1_dot_by_e2/2
    let e1_ddot_by_e2 = (-w2_dot_by_e2).mul_add(e3_halved, w3_dot_by_e2 * e2_halved)
        + w1_dot_by_e2 * e0_halved + w3_dot_halved
        - e1_ddot_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e2_of_motion_3;
    // e2_ddot_by_e2 = 4*e2^2*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) -
    //   2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) +
    //   e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^3 - (e3^2*(e0'^2 + e1'^2
    //   + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 +
    //   e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2 + 2*e2*(e0*e0'*e2' - e2*(e0'^2 + e1'^2 + e3'^2) + e1*e1'*e2' +
    //   e3*e2'*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 - e1*w3_dot_by_e2/2 + e0*w2_dot_by_e2/2 +
    //   e3*w1_dot_by_e2/2
    let e2_ddot_by_e2 = w1_dot_by_e2 * e3_halved - w3_dot_by_e2 * e1_halved
        - e0_ddot_by_e0_of_motion_10 + e2_sq * e0_ddot_by_e0_of_motion_11 + w2_dot_by_e2 * e0_halved
        + e2_ddot_by_e0_of_e0_e1_e2_e3 * (e0_ddot_by_e2_of_motion_2 - e0_ddot_by_e0_of_motion_7);
    // e3_ddot_by_e2 = 2*e3*(e2'*(e0*e0' + e1*e1' + e3*e3') - e2*(e0'^2 + e1'^2 + e3'^2 - 2*(e3^2*(e0'^2 +
    //   e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2
    //   + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2
    //   + e1^2 + e2^2 + e3^2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2 - w1'/2 + e0*w3_dot_by_e2/2 +
    //   e1*w2_dot_by_e2/2 - e2*w1_dot_by_e2/2
    let e3_ddot_by_e2 = (-w1_dot_by_e2).mul_add(e2_halved, w2_dot_by_e2 * e1_halved)
        + w3_dot_by_e2 * e0_halved - w1_dot_halved
        - e3_ddot_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e2_of_motion_3;
    let w_S_1_by_e3_of_e0_e1_e2_e3 = e3 * w_S_1_by_e0_of_e0_e1_e2_e3;
    // w_S_1_by_e3 = (e2' + 2*e3*(e1*e0' - e0*e1' - e3*e2' + e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2))/(e0^2 +
    //   e1^2 + e2^2 + e3^2)
    let w_S_1_by_e3 = w_s_1_of_e0_e1_e2_e3_inv
        * (-w_S_1_of_motion_3).mul_add(w_S_1_by_e3_of_e0_e1_e2_e3, e2_dot);
    // w_S_2_by_e3 = -(e1' + 2*e3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2))/(e0^2 +
    //   e1^2 + e2^2 + e3^2)
    let w_S_2_by_e3 = -w_s_1_of_e0_e1_e2_e3_inv
        * w_S_2_of_motion_3.mul_add(w_S_1_by_e3_of_e0_e1_e2_e3, e1_dot);
    // w_S_3_by_e3 = -(e0' + 2*e3*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2))/(e0^2 +
    //   e1^2 + e2^2 + e3^2)
    let w_S_3_by_e3 = -w_s_1_of_e0_e1_e2_e3_inv
        * w_S_3_of_motion_3.mul_add(w_S_1_by_e3_of_e0_e1_e2_e3, e0_dot);
    let w_S_in_axle_base_1_by_e3_of_e0_dot = e0_dot * w_S_in_axle_base_1_of_;
    // w_S_in_axle_base_1_by_e3 = -(e0'*sqrt(3) + 3*e1'/(3 + sqrt(3)) + 3*e2'*(1 - 1/(3 + sqrt(3))) +
    //   2*e3*(3*e1*e0' - 3*e0*e1' - 3*e3*e2' + 3*e2*e3' - sqrt(3)*(e3*e0' - e2*e1' + e1*e2' - e0*e3') -
    //   3*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' + e3') + e1*(e0' - e3'))/(3 + sqrt(3)))/(e0^2 + e1^2 +
    //   e2^2 + e3^2))/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_1_by_e3 = w_s_1_of_e0_e1_e2_e3_inv
        * (w_S_in_axle_base_1_by_e0_of_motion_2
            .mul_add(
                w_S_1_by_e3_of_e0_e1_e2_e3,
                w_S_in_axle_base_2_by_e0_of_e2_dot - w_S_in_axle_base_2_by_e0_of_e1_dot,
            ) - w_S_in_axle_base_1_by_e3_of_e0_dot);
    // w_S_in_axle_base_2_by_e3 = (3*e2'/(3 + sqrt(3)) - e0'*sqrt(3) - 3*e1'*(1/(3 + sqrt(3)) - 1) -
    //   2*e3*(3*e2*e0' - 3*e0*e2' + 3*e3*e1' - 3*e1*e3' - sqrt(3)*(e3*e0' - e2*e1' + e1*e2' - e0*e3') -
    //   3*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' + e3') + e1*(e0' - e3'))/(3 + sqrt(3)))/(e0^2 + e1^2 +
    //   e2^2 + e3^2))/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_2_by_e3 = w_s_1_of_e0_e1_e2_e3_inv
        * (w_S_in_axle_base_2_by_e0_of_motion
            .mul_add(
                w_S_1_by_e3_of_e0_e1_e2_e3,
                w_S_in_axle_base_1_by_e0_of_e2_dot - w_S_in_axle_base_1_by_e0_of_e1_dot,
            ) - w_S_in_axle_base_1_by_e3_of_e0_dot);
    // w_S_in_axle_base_3_by_e3 = sqrt(3)*(e2' - e0' - e1' - 2*e3*(e3*(e2' - e0' - e1') + e0*(e1' + e2' +
    //   e3') + e1*(e3' - e0' - e2') + e2*(e1' - e0' - e3'))/(e0^2 + e1^2 + e2^2 + e3^2))/(e0^2 + e1^2 + e2^2
    //   + e3^2)
    let w_S_in_axle_base_3_by_e3 = -w_S_in_axle_base_3_of_e0_e1_e2_e3
        * w_S_in_axle_base_3_by_e0_of_motion_12
            .mul_add(w_S_1_by_e3_of_e0_e1_e2_e3, w_S_in_axle_base_3_by_e0_of_motion_6);
    // e3'*w_S_1_2_of_e0_e1_e2_e3 - e3*w_S_1_2_by_e0_of_motion
    let w_S_1_2_by_e3_of_motion = (-e3)
        .mul_add(w_S_1_2_by_e0_of_motion, e3_dot * w_S_1_2_of_e0_e1_e2_e3);
    // w_S_1_2_by_e3 = e3'*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + e2'*(e0*e0'
    //   + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 4*e3*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_1_2_by_e3 = w_S_1_of_motion_3
        .mul_add(w_S_1_2_by_e3_of_motion, e2_dot_w_s_1_2_of_motion);
    // w_S_2_2_by_e3 = e3'*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 - e1'*(e0*e0'
    //   + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 4*e3*(e2*e0' - e0*e2' + e3*e1' -
    //   e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_2_2_by_e3 = w_S_2_of_motion_3
        .mul_add(w_S_1_2_by_e3_of_motion, -e1_dot_w_s_1_2_of_motion);
    // w_S_3_2_by_e3 = e3'*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 - e0'*(e0*e0'
    //   + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 4*e3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_3_2_by_e3 = w_S_3_of_motion_3
        .mul_add(w_S_1_2_by_e3_of_motion, -e0_dot_w_s_1_2_of_motion);
    let w_S_in_axle_base_1_2_by_e3_of_motion = e0_dot * w_S_in_axle_base_1_2_by_e0_of_motion;
    // w_S_in_axle_base_1_2_by_e3 = 3*e3'*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2 + 3*e3'*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2
    //   + e3^2)^2) + e3'*sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 -
    //   e0'*sqrt(3)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 - 3*e1'*(e0*e0' +
    //   e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + 3*e2'*(1/(3 + sqrt(3)) -
    //   1)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 12*e3*(1 - 1/(3 +
    //   sqrt(3)))*(e0*e1' - e1*e0' + e3*e2' - e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^3 + 12*e3*(e2*e0' - e0*e2' + e3*e1' - e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 +
    //   sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^3) + 4*e3*sqrt(3)*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(e0*e0' +
    //   e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_in_axle_base_1_2_by_e3 = w_S_in_axle_base_1_of_motion_3
        .mul_add(
            w_S_1_2_by_e3_of_motion,
            w_S_in_axle_base_2_2_by_e0_of_motion - w_S_in_axle_base_2_2_by_e0_of_motion_2,
        ) - w_S_in_axle_base_1_2_by_e3_of_motion;
    // w_S_in_axle_base_2_2_by_e3 = 3*e3'*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/((3 + sqrt(3))*(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2) + 3*e3'*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 + e3'*sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 -
    //   e0'*sqrt(3)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 3*e1'*(1 - 1/(3 +
    //   sqrt(3)))*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 3*e2'*(e0*e0' + e1*e1'
    //   + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + 12*e3*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^3) + 12*e3*(1
    //   - 1/(3 + sqrt(3)))*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 +
    //   e1^2 + e2^2 + e3^2)^3 + 4*e3*sqrt(3)*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(e0*e0' + e1*e1' + e2*e2' +
    //   e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^3
    let w_S_in_axle_base_2_2_by_e3 = w_S_in_axle_base_2_of_motion_2
        .mul_add(
            w_S_1_2_by_e3_of_motion,
            w_S_in_axle_base_1_2_by_e0_of_motion_7 - w_S_in_axle_base_1_2_by_e0_of_motion_5,
        ) - w_S_in_axle_base_1_2_by_e3_of_motion;
    // e1_e1_dot + e2_e2_dot
    let e1_e1_dot_plus_e2_e2_dot = e1_e1_dot + e2_e2_dot;
    // w_S_in_axle_base_3_2_by_e3 = sqrt(3)*(e2*e2'^2 - e1'*(e2*e2' + e1*(e1' - e2')) - e0'*(e1*e1' +
    //   e2*e2' + e0*(e0' + e1' - e2')) + e3'*(e0*(e1' + e2' + e3') + e1*(e3' - e0' - e2') + e2*(e1' - e0' -
    //   e3')) - 2*e3*(e3'*(e0' + e1' - e2') + 2*(e3^2*e3'*(e2' - e0' - e1') + e0*(e3*e3'^2 + e0'*(e3*(e2' -
    //   e0' - e1') + e0*(e1' + e2' + e3') + e1*(e3' - e0' - e2') + e2*(e1' - e0' - e3')) + e1'*(e2*e2' +
    //   e3*e3' + e1*(e1' + e2' + e3')) + e2'*(e3*e3' + e2*(e2' + e3'))) - e1*(e3*e3'*(e0' - e3') +
    //   e1'*(e3*(e0' + e1' - e2') + e1*(e0' + e2' - e3') + e2*(e0' - e1' + e3')) + e2'*(e3*e3' + e2*(e0' +
    //   e2' - e3'))) - e2*(e2*e2'*(e0' - e1' + e3') + e3*(e2'*(e0' + e1' - e2') + e3'*(e0' - e1' +
    //   e3'))))/(e0^2 + e1^2 + e2^2 + e3^2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_3_2_by_e3 = w_S_in_axle_base_3_2_by_e0_of_e0_e1_e2_e3
        * (-e1_dot * e1.mul_add(e1_dot_minus_e2_dot, e2_e2_dot) + e2_dot * e2_e2_dot
            - e3_dot
                * (w_S_in_axle_base_3_by_e0_of_motion_10 - w_S_in_axle_base_3_by_e0_of_motion_5)
            - e3_doubled
                * e3_dot
                    .mul_add(
                        w_S_in_axle_base_3_by_e0_of_motion_6,
                        w_S_in_axle_base_3_2_by_e0_of_motion_4,
                    )
            - e0_dot
                * e0
                    .mul_add(
                        w_S_in_axle_base_3_by_e0_of_motion_6, e1_e1_dot_plus_e2_e2_dot,
                    ));
    // K*(w_S_in_axle_base_1_2_by_e3 + w_S_in_axle_base_2_2_by_e3)
    let r1_by_e3_of_place = K * (w_S_in_axle_base_1_2_by_e3 + w_S_in_axle_base_2_2_by_e3);
    // K*(w_S_in_axle_base_1_by_e3 + w_S_in_axle_base_2_by_e3)
    let r1_by_e3_of_place_2 = K * (w_S_in_axle_base_1_by_e3 + w_S_in_axle_base_2_by_e3);
    // r1_by_e3_of_place_2 - w_S_in_axle_base_3_by_e3*j_doubled
    let r1_by_e3_of_place_3 = (-w_S_in_axle_base_3_by_e3)
        .mul_add(j_doubled, r1_by_e3_of_place_2);
    // J*w_S_in_axle_base_3_by_e3 + r1_by_e3_of_place_2
    let r1_by_e3_of_place_4 = J.mul_add(w_S_in_axle_base_3_by_e3, r1_by_e3_of_place_2);
    // w_S_in_axle_base_1_by_e3 - w_S_in_axle_base_2_by_e3
    let r1_by_e3_of_place_5 = w_S_in_axle_base_1_by_e3 - w_S_in_axle_base_2_by_e3;
    // K*(w_S_in_axle_base_1_2_by_e3 - w_S_in_axle_base_2_2_by_e3)
    let r1_by_e3_of_place_6 = K * (w_S_in_axle_base_1_2_by_e3 - w_S_in_axle_base_2_2_by_e3);
    // w_S_1_2_by_e3*a_times_6 - r1_by_e3_of_place_6
    let r1_by_e3_of_place_7 = w_S_1_2_by_e3.mul_add(a_times_6, -r1_by_e3_of_place_6);
    let k_r1_by_e3_of_place_5 = K * r1_by_e3_of_place_5;
    // w_S_2_by_e3*b_times_6 + k_r1_by_e3_of_place_5
    let r1_by_e3_of_place_8 = w_S_2_by_e3.mul_add(b_times_6, k_r1_by_e3_of_place_5);
    // r1_by_e3 = (6*H_wheel_1*(e1' - e2') - 36*e1'*H_bus_1 - 36*e2'*H_bus_2 + 6*H_wheel_2*(e2' - e1') +
    //   72*e3*H_bus_3_2 + 36*A*w_S_1_by_e3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 36*B*w_S_2_by_e3*(e1*e0' -
    //   e0*e1' - e3*e2' + e2*e3') + 6*K*w_S_in_axle_base_1_by_e3*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0'
    //   + e3') + e1*(e0' - e3')) + 6*K*w_S_in_axle_base_2_by_e3*(e0*(e1' + e2') - e3*(e1' - e2') - e2*(e0' +
    //   e3') - e1*(e0' - e3')) + 36*C*w_S_3_2_by_e3*(e0^2 + e1^2 + e2^2 + e3^2) + sqrt(3)*(2*e1'*(H_wheel_1
    //   + H_wheel_2 - H_wheel_3) + 2*e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e3*(4*H_wheel_1_2 - 3*T +
    //   4*H_wheel_2_2) + 2*e0*(e1'*(K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3 -
    //   2*J*w_S_in_axle_base_3_by_e3) + e2'*(2*J*w_S_in_axle_base_3_by_e3 - K*w_S_in_axle_base_1_by_e3 -
    //   K*w_S_in_axle_base_2_by_e3) + 2*e0*(K*w_S_in_axle_base_1_2_by_e3 + K*w_S_in_axle_base_2_2_by_e3)) +
    //   2*e1*(2*e1*(K*w_S_in_axle_base_1_2_by_e3 + K*w_S_in_axle_base_2_2_by_e3) -
    //   e0'*(K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3 - 2*J*w_S_in_axle_base_3_by_e3) -
    //   e3'*(K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3 - 2*J*w_S_in_axle_base_3_by_e3)) +
    //   2*e2*(2*e2*(K*w_S_in_axle_base_1_2_by_e3 + K*w_S_in_axle_base_2_2_by_e3) -
    //   e0'*(2*J*w_S_in_axle_base_3_by_e3 - K*w_S_in_axle_base_1_by_e3 - K*w_S_in_axle_base_2_by_e3) -
    //   e3'*(K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3 - 2*J*w_S_in_axle_base_3_by_e3)) +
    //   e3*(4*H_wheel_1_2 - 3*T + 4*H_wheel_2_2 - 2*e1'*(2*J*w_S_in_axle_base_3_by_e3 -
    //   K*w_S_in_axle_base_1_by_e3 - K*w_S_in_axle_base_2_by_e3) - 2*e2'*(2*J*w_S_in_axle_base_3_by_e3 -
    //   K*w_S_in_axle_base_1_by_e3 - K*w_S_in_axle_base_2_by_e3) + 4*e3*(K*w_S_in_axle_base_1_2_by_e3 +
    //   K*w_S_in_axle_base_2_2_by_e3)) + K*(2*e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*e0'*(H_wheel_1
    //   + H_wheel_2 - H_wheel_3) - e3*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) -
    //   2*e0*(2*e2'*(K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3 + J*w_S_in_axle_base_3_by_e3) +
    //   e3'*(K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3 - 2*J*w_S_in_axle_base_3_by_e3) +
    //   e0*(K*w_S_in_axle_base_1_2_by_e3 + K*w_S_in_axle_base_2_2_by_e3)) -
    //   2*e1*(2*e3'*(K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3 + J*w_S_in_axle_base_3_by_e3) +
    //   e2'*(2*J*w_S_in_axle_base_3_by_e3 - K*w_S_in_axle_base_1_by_e3 - K*w_S_in_axle_base_2_by_e3) +
    //   e1*(K*w_S_in_axle_base_1_2_by_e3 + K*w_S_in_axle_base_2_2_by_e3)) +
    //   2*e2*(2*e0'*(K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3 + J*w_S_in_axle_base_3_by_e3) +
    //   e1'*(2*J*w_S_in_axle_base_3_by_e3 - K*w_S_in_axle_base_1_by_e3 - K*w_S_in_axle_base_2_by_e3) -
    //   e2*(K*w_S_in_axle_base_1_2_by_e3 + K*w_S_in_axle_base_2_2_by_e3)) +
    //   e3*(4*e1'*(K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3 + J*w_S_in_axle_base_3_by_e3) -
    //   3*T - 2*H_wheel_1_2 - 2*H_wheel_2_2 - 2*e0'*(2*J*w_S_in_axle_base_3_by_e3 -
    //   K*w_S_in_axle_base_1_by_e3 - K*w_S_in_axle_base_2_by_e3) - 2*e3*(K*w_S_in_axle_base_1_2_by_e3 +
    //   K*w_S_in_axle_base_2_2_by_e3)))/(3*A + 2*K)) + 6*K*(6*e1'*H_bus_3 + e0'*(H_wheel_2 - 6*H_bus_2 -
    //   H_wheel_1) + e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2) - e0*(6*C*e2'*w_S_3_by_e3 +
    //   e3'*(K*w_S_in_axle_base_2_by_e3 - 6*B*w_S_2_by_e3 - K*w_S_in_axle_base_1_by_e3) +
    //   e0*(K*w_S_in_axle_base_1_2_by_e3 - 6*A*w_S_1_2_by_e3 - K*w_S_in_axle_base_2_2_by_e3)) -
    //   e1*(6*C*e3'*w_S_3_by_e3 + e2'*(6*B*w_S_2_by_e3 + K*w_S_in_axle_base_1_by_e3 -
    //   K*w_S_in_axle_base_2_by_e3) + e1*(K*w_S_in_axle_base_1_2_by_e3 - 6*A*w_S_1_2_by_e3 -
    //   K*w_S_in_axle_base_2_2_by_e3)) + e2*(6*C*e0'*w_S_3_by_e3 + e1'*(6*B*w_S_2_by_e3 +
    //   K*w_S_in_axle_base_1_by_e3 - K*w_S_in_axle_base_2_by_e3) + e2*(6*A*w_S_1_2_by_e3 -
    //   K*w_S_in_axle_base_1_2_by_e3 + K*w_S_in_axle_base_2_2_by_e3)) + e3*(6*H_bus_1_2 - H_wheel_1_2 +
    //   H_wheel_2_2 + 6*C*e1'*w_S_3_by_e3 + e0'*(K*w_S_in_axle_base_2_by_e3 - 6*B*w_S_2_by_e3 -
    //   K*w_S_in_axle_base_1_by_e3) + e3*(6*A*w_S_1_2_by_e3 - K*w_S_in_axle_base_1_2_by_e3 +
    //   K*w_S_in_axle_base_2_2_by_e3)))/(3*A + 2*K))/(9*(e0^2 + e1^2 + e2^2 + e3^2)) -
    //   2*e3*(36*H_bus_1*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 36*H_bus_2*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3') + 6*H_wheel_1*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' + e3') + e1*(e0' - e3')) +
    //   6*H_wheel_2*(e0*(e1' + e2') - e3*(e1' - e2') - e2*(e0' + e3') - e1*(e0' - e3')) + 36*H_bus_3_2*(e0^2
    //   + e1^2 + e2^2 + e3^2) + 6*K*(e2*(6*e0'*H_bus_3 + e1'*(6*H_bus_2 + H_wheel_1 - H_wheel_2) +
    //   e2*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)) - e0*(6*e2'*H_bus_3 + e3'*(H_wheel_2 - 6*H_bus_2 -
    //   H_wheel_1) + e0*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2)) - e1*(6*e3'*H_bus_3 + e2'*(6*H_bus_2 +
    //   H_wheel_1 - H_wheel_2) + e1*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2)) + e3*(6*e1'*H_bus_3 +
    //   e0'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) + e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2)))/(3*A + 2*K)
    //   + sqrt(3)*(e3*(2*e1'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + e3*(4*H_wheel_1_2 - 3*T + 4*H_wheel_2_2)) - K*(e0*(2*e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   2*e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e0*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)) +
    //   e1*(2*e3'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*e2'*(H_wheel_3 - H_wheel_1 - H_wheel_2) +
    //   e1*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)) + e2*(e2*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) -
    //   2*e0'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) - 2*e1'*(H_wheel_3 - H_wheel_1 - H_wheel_2)) +
    //   e3*(e3*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) - 2*e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) -
    //   2*e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3)))/(3*A + 2*K) - e0*(2*e1'*(H_wheel_3 - H_wheel_1 -
    //   H_wheel_2) + 2*e2'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e0*(3*T - 4*H_wheel_1_2 - 4*H_wheel_2_2)) -
    //   e1*(2*e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*e3'*(H_wheel_1 + H_wheel_2 - H_wheel_3) + e1*(3*T
    //   - 4*H_wheel_1_2 - 4*H_wheel_2_2)) - e2*(2*e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) + 2*e3'*(H_wheel_1
    //   + H_wheel_2 - H_wheel_3) + e2*(3*T - 4*H_wheel_1_2 - 4*H_wheel_2_2))))/(9*(e0^2 + e1^2 + e2^2 +
    //   e3^2)^2)
    let r1_by_e3 = r1_of_e0_e1_e2_e3_2
        * (e3 * h_bus_3_2_times_72 - e1_dot * h_bus_1_times_36
            - e2_dot * h_bus_2_times_36 + e1_dot_minus_e2_dot * r1_of_place_7_times_6
            + w_S_1_by_e3 * r1_by_e0_of_motion_2 - w_S_2_by_e3 * r1_by_e0_of_motion_3
            + w_S_3_2_by_e3 * c_r1_of_e0_e1_e2_e3
            - w_S_in_axle_base_1_of_
                * (r1_of_motion_4
                    + e3
                        * ((-(e3 * r1_by_e3_of_place)).mul_add(S::int(4), r1_of_place_2)
                            - S::int(2) * e1_dot_plus_e2_dot * r1_by_e3_of_place_3)
                    - e0_doubled
                        * e1_dot_minus_e2_dot
                            .mul_add(r1_by_e3_of_place_3, e0_doubled * r1_by_e3_of_place)
                    + e1_doubled
                        * (-e1_doubled)
                            .mul_add(
                                r1_by_e3_of_place,
                                e0_dot_plus_e3_dot * r1_by_e3_of_place_3,
                            )
                    - e2_doubled
                        * e0_dot_minus_e3_dot
                            .mul_add(r1_by_e3_of_place_3, e2_doubled * r1_by_e3_of_place)
                    + k_r1_of_a_k
                        * (r1_of_motion_12
                            + e3
                                * (e3_doubled.mul_add(r1_by_e3_of_place, r1_of_place_5)
                                    - e0_dot_doubled * r1_by_e3_of_place_3
                                    - S::int(4) * e1_dot * r1_by_e3_of_place_4)
                            + e0_doubled
                                * (e3_dot
                                    .mul_add(r1_by_e3_of_place_3, e0 * r1_by_e3_of_place)
                                    + e2_dot_doubled * r1_by_e3_of_place_4)
                            + e1_doubled
                                * ((-e2_dot)
                                    .mul_add(r1_by_e3_of_place_3, e1 * r1_by_e3_of_place)
                                    + e3_dot_doubled * r1_by_e3_of_place_4)
                            + e2_doubled
                                * (e1_dot
                                    .mul_add(r1_by_e3_of_place_3, e2 * r1_by_e3_of_place)
                                    - e0_dot_doubled * r1_by_e3_of_place_4)))
            + r1_by_e0_of_motion * r1_by_e3_of_place_5
            + k_r1_of_a_k_times_6
                * (r1_of_motion_17
                    + e2
                        * (e2
                            .mul_add(r1_by_e3_of_place_7, w_S_3_by_e3 * e0_dot_c_times_6)
                            + e1_dot * r1_by_e3_of_place_8)
                    + e3
                        * (w_S_3_by_e3.mul_add(e1_dot_c_times_6, r1_of_place_9)
                            + e3 * r1_by_e3_of_place_7 - e0_dot * r1_by_e3_of_place_8)
                    + e0
                        * ((-w_S_3_by_e3)
                            .mul_add(e2_dot_c_times_6, e0 * r1_by_e3_of_place_7)
                            + e3_dot * r1_by_e3_of_place_8)
                    + e1
                        * ((-w_S_3_by_e3)
                            .mul_add(e3_dot_c_times_6, e1 * r1_by_e3_of_place_7)
                            - e2_dot * r1_by_e3_of_place_8))) - e3 * r1_by_e0_of_motion_4;
    // e0'*minus_r1_of_place_3 - w_S_3_of_motion_3*r1_by_e3_of_place_3
    let w3_dot_by_e3_of_motion = (-w_S_3_of_motion_3)
        .mul_add(r1_by_e3_of_place_3, e0_dot * minus_r1_of_place_3);
    // e3_r1_of_place_5 + w_S_1_of_e0_e1_e2_e3*r1_by_e3_of_place
    let w3_dot_by_e3_of_place = w_S_1_of_e0_e1_e2_e3
        .mul_add(r1_by_e3_of_place, e3_r1_of_place_5);
    // e3*r1_of_place_9_times_6 - e0'*r1_of_place_10_times_3 - w_S_3_by_e3*w3_dot_by_e0_of_motion_3 +
    //   e1_dot_h_bus_3_times_18 + w3_dot_by_e0_of_e0_e1_e2_e3*r1_by_e3_of_place_7 +
    //   w3_dot_by_e0_of_motion_2*r1_by_e3_of_place_8 + sqrt(3)*(e1_dot_r1_of_place_6 -
    //   w3_dot_of_motion_3*r1_by_e3_of_place_4 + w3_dot_by_e3_of_motion - w3_dot_by_e3_of_place)
    let w3_dot_by_e3_of_motion_2 = e3 * r1_of_place_9_times_6
        - e0_dot * r1_of_place_10_times_3 - w_S_3_by_e3 * w3_dot_by_e0_of_motion_3
        + e1_dot_h_bus_3_times_18 + w3_dot_by_e0_of_e0_e1_e2_e3 * r1_by_e3_of_place_7
        + w3_dot_by_e0_of_motion_2 * r1_by_e3_of_place_8
        + w_S_in_axle_base_1_of_
            * ((-w3_dot_of_motion_3).mul_add(r1_by_e3_of_place_4, e1_dot_r1_of_place_6)
                + w3_dot_by_e3_of_motion - w3_dot_by_e3_of_place);
    // e3*w3_dot_of_place_3 + e2_dot_h_bus_3_times_18 + e0'*w3_dot_by_e0_of_place_2 +
    //   w_S_3_by_e3*w3_dot_by_e0_of_motion_5 + w3_dot_by_e0_of_e0_e1_e2_e3*(w_S_2_2_by_e3*b_times_6 +
    //   r1_by_e3_of_place_6) + w3_dot_by_e0_of_motion_2*(k_r1_by_e3_of_place_5 - w_S_1_by_e3*a_times_6) +
    //   sqrt(3)*(e2_dot_r1_of_place_6 + w3_dot_of_motion*r1_by_e3_of_place_4 - w3_dot_by_e3_of_motion -
    //   w3_dot_by_e3_of_place) + k_r1_of_a_k*w3_dot_by_e3_of_motion_2
    let w3_dot_by_e3_of_motion_3 = e2_dot_h_bus_3_times_18 + e3 * w3_dot_of_place_3
        + e0_dot * w3_dot_by_e0_of_place_2 + w_S_3_by_e3 * w3_dot_by_e0_of_motion_5
        + w3_dot_by_e0_of_e0_e1_e2_e3 * w_S_2_2_by_e3.mul_add(b_times_6, r1_by_e3_of_place_6)
        + w3_dot_by_e0_of_motion_2 * (-w_S_1_by_e3).mul_add(a_times_6, k_r1_by_e3_of_place_5)
        + w_S_in_axle_base_1_of_
            * (w3_dot_of_motion.mul_add(r1_by_e3_of_place_4, e2_dot_r1_of_place_6)
                - w3_dot_by_e3_of_motion - w3_dot_by_e3_of_place)
        + k_r1_of_a_k * w3_dot_by_e3_of_motion_2;
    // w3_dot_by_e3 = (2*K*e3*(A + K)*(36*H_bus_3*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 6*(e2*e1' - e3*e0'
    //   - e1*e2' + e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_2_2
    //   - 6*H_bus_2_2 - H_wheel_1_2) + K*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' -
    //   e2*e1' + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 +
    //   e3^2)*(H_wheel_1_2 - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 +
    //   H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(3*A +
    //   2*K) + sqrt(3)*(2*(e1*e0' - e0*e1' - e3*e2' + e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   2*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 +
    //   e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/((3*A + 2*K)*(3*B + K*(2 - K/(3*A + 2*K)))*(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2) + 2*K*(A + K)*(18*e2'*H_bus_3 + 3*e0'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) +
    //   6*e3*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2) + 18*C*w_S_3_by_e3*(e0*e1' - e1*e0' + e3*e2' -
    //   e2*e3') + 3*(e3*e0' - e2*e1' + e1*e2' - e0*e3')*(6*A*w_S_1_by_e3 - K*w_S_in_axle_base_1_by_e3 +
    //   K*w_S_in_axle_base_2_by_e3) + 3*(e0^2 + e1^2 + e2^2 + e3^2)*(6*B*w_S_2_2_by_e3 +
    //   K*w_S_in_axle_base_1_2_by_e3 - K*w_S_in_axle_base_2_2_by_e3) + K*(18*e1'*H_bus_3 + 3*e0'*(H_wheel_2
    //   - 6*H_bus_2 - H_wheel_1) + 6*e3*(6*H_bus_1_2 - H_wheel_1_2 + H_wheel_2_2) + 18*C*w_S_3_by_e3*(e2*e0'
    //   - e0*e2' + e3*e1' - e1*e3') + 3*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(6*B*w_S_2_by_e3 +
    //   K*w_S_in_axle_base_1_by_e3 - K*w_S_in_axle_base_2_by_e3) + 3*(e0^2 + e1^2 + e2^2 +
    //   e3^2)*(6*A*w_S_1_2_by_e3 - K*w_S_in_axle_base_1_2_by_e3 + K*w_S_in_axle_base_2_2_by_e3) +
    //   sqrt(3)*(e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3) -
    //   e3*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e2*e0' - e0*e2' + e3*e1' -
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3 + J*w_S_in_axle_base_3_by_e3) +
    //   (e3*e0' - e2*e1' + e1*e2' - e0*e3')*(K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3 -
    //   2*J*w_S_in_axle_base_3_by_e3) - (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e3 +
    //   K*w_S_in_axle_base_2_2_by_e3)))/(3*A + 2*K) + sqrt(3)*(e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) - e3*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e0*e1' -
    //   e1*e0' + e3*e2' - e2*e3')*(K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3 +
    //   J*w_S_in_axle_base_3_by_e3) + (e2*e1' - e3*e0' - e1*e2' + e0*e3')*(K*w_S_in_axle_base_1_by_e3 +
    //   K*w_S_in_axle_base_2_by_e3 - 2*J*w_S_in_axle_base_3_by_e3) - (e0^2 + e1^2 + e2^2 +
    //   e3^2)*(K*w_S_in_axle_base_1_2_by_e3 + K*w_S_in_axle_base_2_2_by_e3)))/((3*A + 2*K)*(3*B + K*(2 -
    //   K/(3*A + 2*K)))*(e0^2 + e1^2 + e2^2 + e3^2)) + 3*r1_by_e3)/(3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A +
    //   K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A + 2*K)))))
    let w3_dot_by_e3 = w3_dot_of_a_b_c_k
        * (w3_dot_of_motion_7.mul_add(e3_ddot_by_e0_of_e0_e1_e2_e3, S::int(3) * r1_by_e3)
            + w3_dot_by_e0_of_place_3 * w3_dot_by_e3_of_motion_3);
    // w2_dot_by_e3 = (2*e3*(36*H_bus_3*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 6*(e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_2_2 -
    //   6*H_bus_2_2 - H_wheel_1_2) + K*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' - e2*e1'
    //   + e1*e2' - e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2
    //   - 6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(3*A + 2*K) +
    //   sqrt(3)*(2*(e1*e0' - e0*e1' - e3*e2' + e2*e3')*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*(e3*e0' -
    //   e2*e1' + e1*e2' - e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3) + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T +
    //   2*H_wheel_1_2 + 2*H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 2*(18*e2'*H_bus_3 +
    //   3*e0'*(6*H_bus_1 - H_wheel_1 + H_wheel_2) + 6*e3*(6*H_bus_2_2 + H_wheel_1_2 - H_wheel_2_2) +
    //   18*C*w_S_3_by_e3*(e0*e1' - e1*e0' + e3*e2' - e2*e3') + 3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*A*w_S_1_by_e3 - K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3) + 3*(e0^2 + e1^2
    //   + e2^2 + e3^2)*(6*B*w_S_2_2_by_e3 + K*w_S_in_axle_base_1_2_by_e3 - K*w_S_in_axle_base_2_2_by_e3) +
    //   K*(18*e1'*H_bus_3 + 3*e0'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) + 6*e3*(6*H_bus_1_2 - H_wheel_1_2 +
    //   H_wheel_2_2) + 18*C*w_S_3_by_e3*(e2*e0' - e0*e2' + e3*e1' - e1*e3') + 3*(e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(6*B*w_S_2_by_e3 + K*w_S_in_axle_base_1_by_e3 - K*w_S_in_axle_base_2_by_e3) + 3*(e0^2 + e1^2
    //   + e2^2 + e3^2)*(6*A*w_S_1_2_by_e3 - K*w_S_in_axle_base_1_2_by_e3 + K*w_S_in_axle_base_2_2_by_e3) +
    //   sqrt(3)*(e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3) -
    //   e3*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e2*e0' - e0*e2' + e3*e1' -
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3 + J*w_S_in_axle_base_3_by_e3) +
    //   (e3*e0' - e2*e1' + e1*e2' - e0*e3')*(K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3 -
    //   2*J*w_S_in_axle_base_3_by_e3) - (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e3 +
    //   K*w_S_in_axle_base_2_2_by_e3)))/(3*A + 2*K) + sqrt(3)*(e2'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   e0'*(H_wheel_3 - H_wheel_1 - H_wheel_2) - e3*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e0*e1' -
    //   e1*e0' + e3*e2' - e2*e3')*(K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3 +
    //   J*w_S_in_axle_base_3_by_e3) + (e2*e1' - e3*e0' - e1*e2' + e0*e3')*(K*w_S_in_axle_base_1_by_e3 +
    //   K*w_S_in_axle_base_2_by_e3 - 2*J*w_S_in_axle_base_3_by_e3) - (e0^2 + e1^2 + e2^2 +
    //   e3^2)*(K*w_S_in_axle_base_1_2_by_e3 + K*w_S_in_axle_base_2_2_by_e3)))/(e0^2 + e1^2 + e2^2 + e3^2) +
    //   9*K*w3_dot_by_e3*(A + K)/(3*A + 2*K))/(3*(3*B + K*(2 - K/(3*A + 2*K))))
    let w2_dot_by_e3 = w3_dot_of_a_b_k_by_3
        * (w3_dot_of_motion_6
            .mul_add(e3_ddot_by_e0_of_e0_e1_e2_e3, w3_dot_by_e3 * w3_dot_of_a_k_2)
            + w_S_1_by_e0_of_e0_e1_e2_e3 * w3_dot_by_e3_of_motion_3);
    // w3_dot_by_e3 + w2_dot_by_e3
    let w1_dot_by_e3_of_place = w3_dot_by_e3 + w2_dot_by_e3;
    // w1_dot_by_e3 = (2*e3*(36*H_bus_3*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 6*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*H_bus_2 + H_wheel_1 - H_wheel_2) + 6*(e0^2 + e1^2 + e2^2 + e3^2)*(H_wheel_1_2 -
    //   6*H_bus_1_2 - H_wheel_2_2) + sqrt(3)*(2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) + 2*(e2*e1' - e3*e0' - e1*e2' + e0*e3')*(H_wheel_1 + H_wheel_2 - H_wheel_3)
    //   + (e0^2 + e1^2 + e2^2 + e3^2)*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2
    //   + 2*(18*e1'*H_bus_3 + 3*e0'*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) + 6*e3*(6*H_bus_1_2 - H_wheel_1_2 +
    //   H_wheel_2_2) + 18*C*w_S_3_by_e3*(e2*e0' - e0*e2' + e3*e1' - e1*e3') + 3*(e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(6*B*w_S_2_by_e3 + K*w_S_in_axle_base_1_by_e3 - K*w_S_in_axle_base_2_by_e3) + 3*(e0^2 + e1^2
    //   + e2^2 + e3^2)*(6*A*w_S_1_2_by_e3 - K*w_S_in_axle_base_1_2_by_e3 + K*w_S_in_axle_base_2_2_by_e3) +
    //   sqrt(3)*(e1'*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + e0'*(H_wheel_1 + H_wheel_2 - H_wheel_3) -
    //   e3*(3*T + 2*H_wheel_1_2 + 2*H_wheel_2_2) + 2*(e2*e0' - e0*e2' + e3*e1' -
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3 + J*w_S_in_axle_base_3_by_e3) +
    //   (e3*e0' - e2*e1' + e1*e2' - e0*e3')*(K*w_S_in_axle_base_1_by_e3 + K*w_S_in_axle_base_2_by_e3 -
    //   2*J*w_S_in_axle_base_3_by_e3) - (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e3 +
    //   K*w_S_in_axle_base_2_2_by_e3)))/(e0^2 + e1^2 + e2^2 + e3^2) + 3*K*(w3_dot_by_e3 +
    //   w2_dot_by_e3))/(3*(3*A + 2*K))
    let w1_dot_by_e3 = r1_of_a_k_by_3
        * (w_S_1_by_e0_of_e0_e1_e2_e3
            .mul_add(
                w3_dot_by_e3_of_motion_2,
                w3_dot_of_motion_5 * e3_ddot_by_e0_of_e0_e1_e2_e3,
            ) + k_times_3 * w1_dot_by_e3_of_place);
    // s_dot_by_e3 = 4*w_S_in_axle_base_3_2_by_e3/3 - sqrt(3)*(w3_dot_by_e3 + w2_dot_by_e3 +
    //   w1_dot_by_e3)/3
    let s_dot_by_e3 = S::ratio(4, 3) * w_S_in_axle_base_3_2_by_e3
        - s_dot_by_e0_of_ * (w1_dot_by_e3 + w1_dot_by_e3_of_place);
    // e1_e1_dot_plus_e0_e0_dot + e2_e2_dot
    let e0_ddot_by_e3_of_motion = e1_e1_dot_plus_e0_e0_dot + e2_e2_dot;
    let e0_ddot_by_e3_of_motion_2 = e3_dot * e0_ddot_by_e3_of_motion;
    // e3*(e0_ddot_by_e0_of_motion_8 - e1_ddot_by_e0_of_motion) - e0_ddot_by_e3_of_motion_2
    let e0_ddot_by_e3_of_motion_3 = e3 * (e0_ddot_by_e0_of_motion_8 - e1_ddot_by_e0_of_motion)
        - e0_ddot_by_e3_of_motion_2;
    // e0_ddot_by_e3 = 2*e0*(e3'*(e0*e0' + e1*e1' + e2*e2') - e3*(e0'^2 + e1'^2 + e2'^2 - 2*(e3^2*(e0'^2 +
    //   e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2
    //   + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2
    //   + e1^2 + e2^2 + e3^2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2 - w3'/2 - e3*w3_dot_by_e3/2 -
    //   e2*w2_dot_by_e3/2 - e1*w1_dot_by_e3/2
    let e0_ddot_by_e3 = (-w2_dot_by_e3).mul_add(e2_halved, -w1_dot_by_e3 * e1_halved)
        - w3_dot_by_e3 * e3_halved - w3_dot_halved
        - w3_dot_by_e0_of_e0_e1_e2_e3_3 * e0_ddot_by_e3_of_motion_3;
    // e1_ddot_by_e3 = 2*e1*(e3'*(e0*e0' + e1*e1' + e2*e2') - e3*(e0'^2 + e1'^2 + e2'^2 - 2*(e3^2*(e0'^2 +
    //   e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2
    //   + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2
    //   + e1^2 + e2^2 + e3^2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2 - w2'/2 + e2*w3_dot_by_e3/2 -
    //   e3*w2_dot_by_e3/2 + e0*w1_dot_by_e3/2
    let e1_ddot_by_e3 = (-w2_dot_by_e3).mul_add(e3_halved, w3_dot_by_e3 * e2_halved)
        + w1_dot_by_e3 * e0_halved - w2_dot_halved
        - e1_ddot_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e3_of_motion_3;
    // e2_ddot_by_e3 = 2*e2*(e3'*(e0*e0' + e1*e1' + e2*e2') - e3*(e0'^2 + e1'^2 + e2'^2 - 2*(e3^2*(e0'^2 +
    //   e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2
    //   + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2
    //   + e1^2 + e2^2 + e3^2)))/(e0^2 + e1^2 + e2^2 + e3^2)^2 + w1'/2 - e1*w3_dot_by_e3/2 +
    //   e0*w2_dot_by_e3/2 + e3*w1_dot_by_e3/2
    let e2_ddot_by_e3 = (-w3_dot_by_e3).mul_add(e1_halved, w1_dot_by_e3 * e3_halved)
        + w2_dot_by_e3 * e0_halved + w1_dot_halved
        - e2_ddot_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e3_of_motion_3;
    // e3_ddot_by_e3 = 4*e3^2*(e3^2*(e0'^2 + e1'^2 + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) -
    //   2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 + e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) +
    //   e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^3 - (e3^2*(e0'^2 + e1'^2
    //   + e2'^2) + e0*(e0*(e1'^2 + e2'^2 + e3'^2) - 2*e0'*(e1*e1' + e2*e2' + e3*e3')) + e1*(e1*(e0'^2 +
    //   e2'^2 + e3'^2) - 2*e1'*(e2*e2' + e3*e3')) + e2*(e2*(e0'^2 + e1'^2 + e3'^2) - 2*e3*e2'*e3'))/(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2 + 2*e3*(e0*e0'*e3' - e3*(e0'^2 + e1'^2 + e2'^2) + e1*e1'*e3' +
    //   e2*e2'*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + e0*w3_dot_by_e3/2 + e1*w2_dot_by_e3/2 -
    //   e2*w1_dot_by_e3/2
    let e3_ddot_by_e3 = w2_dot_by_e3 * e1_halved - w1_dot_by_e3 * e2_halved
        - e0_ddot_by_e0_of_motion_10 + e3_sq * e0_ddot_by_e0_of_motion_11 + w3_dot_by_e3 * e0_halved
        + e3_ddot_by_e0_of_e0_e1_e2_e3
            * (-e3).mul_add(e0_ddot_by_e0_of_motion_8, e0_ddot_by_e3_of_motion_2);
    // w_S_2_by_e3_dot = e1/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_2_by_e3_dot = e1 * w_s_1_of_e0_e1_e2_e3_inv;
    // -w_S_2_by_e3_dot
    let minus_w_s_2_by_e3_dot = -w_S_2_by_e3_dot;
    // w_S_1_by_e0_dot = -e1/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_1_by_e0_dot = minus_w_s_2_by_e3_dot;
    // w_S_3_by_e1_dot = e2/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_3_by_e1_dot = e2 * w_s_1_of_e0_e1_e2_e3_inv;
    // -w_S_3_by_e1_dot
    let minus_w_s_3_by_e1_dot = -w_S_3_by_e1_dot;
    // w_S_2_by_e0_dot = -e2/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_2_by_e0_dot = minus_w_s_3_by_e1_dot;
    // w_S_1_by_e2_dot = e3/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_1_by_e2_dot = e3 * w_s_1_of_e0_e1_e2_e3_inv;
    // -w_S_1_by_e2_dot
    let minus_w_s_1_by_e2_dot = -w_S_1_by_e2_dot;
    // w_S_3_by_e0_dot = -e3/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_3_by_e0_dot = minus_w_s_1_by_e2_dot;
    // e1 + e2
    let e1_plus_e2 = e1 + e2;
    // sqrt(3)*(e1_plus_e2 - e3_doubled)
    let w_S_in_axle_base_1_by_e0_dot_of_e1_e2_e3 = w_S_in_axle_base_1_of_
        * (e1_plus_e2 - e3_doubled);
    // e1 - e2
    let e1_minus_e2 = e1 - e2;
    let e1_minus_e2_times_3 = S::int(3) * e1_minus_e2;
    let w_S_in_axle_base_1_by_e0_dot_of_e0_e1_e2_e3 = S::ratio(1, 2) * w_s_1_of_e0_e1_e2_e3_inv;
    // w_S_in_axle_base_1_by_e0_dot = (3*e1 - 3*e2 + sqrt(3)*(e1 + e2 - 2*e3))/(2*(e0^2 + e1^2 + e2^2 +
    //   e3^2))
    let w_S_in_axle_base_1_by_e0_dot = w_S_in_axle_base_1_by_e0_dot_of_e0_e1_e2_e3
        * (w_S_in_axle_base_1_by_e0_dot_of_e1_e2_e3 + e1_minus_e2_times_3);
    // w_S_in_axle_base_2_by_e0_dot = (3*e2 - 3*e1 - sqrt(3)*(2*e3 - e1 - e2))/(2*(e0^2 + e1^2 + e2^2 +
    //   e3^2))
    let w_S_in_axle_base_2_by_e0_dot = w_S_in_axle_base_1_by_e0_dot_of_e0_e1_e2_e3
        * (w_S_in_axle_base_1_by_e0_dot_of_e1_e2_e3 - e1_minus_e2_times_3);
    // e3 + e1_plus_e2
    let e3_plus_e1_plus_e2 = e3 + e1_plus_e2;
    // w_S_in_axle_base_3_by_e0_dot = -sqrt(3)*(e1 + e2 + e3)/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_3_by_e0_dot = -w_S_in_axle_base_3_of_e0_e1_e2_e3 * e3_plus_e1_plus_e2;
    // w_S_1_2_by_e0_dot = -(e1*(e1*e1' + e2*e2' + e3*e3') + e0*(2*e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_1_2_by_e0_dot = -w_S_1_2_of_e0_e1_e2_e3
        * (e0 * e1.mul_add(e0_dot_doubled, w_S_1_of_motion_2 - e0_e1_dot)
            + e1 * e0_ddot_by_e0_of_motion_3);
    // w_S_2_2_by_e0_dot = (e0*(e0*e2' - 2*e2*e0' - e3*e1' + e1*e3') - e2*(e1*e1' + e2*e2' + e3*e3'))/(e0^2
    //   + e1^2 + e2^2 + e3^2)^2
    let w_S_2_2_by_e0_dot = w_S_1_2_of_e0_e1_e2_e3
        * (e0 * (-e2).mul_add(e0_dot_doubled, e0_e2_dot - w_S_2_of_motion_2)
            - e2 * e0_ddot_by_e0_of_motion_3);
    // w_S_3_2_by_e0_dot = (e0*(e2*e1' - 2*e3*e0' - e1*e2' + e0*e3') - e3*(e1*e1' + e2*e2' + e3*e3'))/(e0^2
    //   + e1^2 + e2^2 + e3^2)^2
    let w_S_3_2_by_e0_dot = w_S_1_2_of_e0_e1_e2_e3
        * (e0 * (-e3).mul_add(e0_dot_doubled, e0_e3_dot + w_S_3_of_motion_2)
            - e3 * e0_ddot_by_e0_of_motion_3);
    let w_S_in_axle_base_1_2_by_e0_dot_of_motion = w_S_in_axle_base_1_of_motion_3
        * w_S_1_2_of_e0_e1_e2_e3;
    let w_S_in_axle_base_1_2_by_e0_dot_of_motion_2 = e3 * w_S_in_axle_base_1_2_by_e0_of_motion;
    let w_S_in_axle_base_1_2_by_e0_dot_of_motion_3 = e1 * w_S_in_axle_base_1_2_by_e0_of_motion_4;
    let w_S_in_axle_base_1_2_by_e0_dot_of_motion_4 = e2 * w_S_in_axle_base_1_2_by_e0_of_motion_6;
    // w_S_in_axle_base_1_2_by_e0_dot = 3*e0*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' -
    //   e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 3*e0*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/((3 +
    //   sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + e0*sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2 + 3*e1*(1 - 1/(3 + sqrt(3)))*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2
    //   + e2^2 + e3^2)^2 - 3*e2*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 +
    //   e3^2)^2) - e3*sqrt(3)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_1_2_by_e0_dot = e0
        .mul_add(
            w_S_in_axle_base_1_2_by_e0_dot_of_motion, -w_S_in_axle_base_1_2_by_e0_dot_of_motion_2,
        ) - w_S_in_axle_base_1_2_by_e0_dot_of_motion_3 - w_S_in_axle_base_1_2_by_e0_dot_of_motion_4;
    let w_S_in_axle_base_2_2_by_e0_dot_of_motion = w_S_in_axle_base_2_of_motion_2
        * w_S_1_2_of_e0_e1_e2_e3;
    let w_S_in_axle_base_2_2_by_e0_dot_of_motion_2 = e2 * w_S_in_axle_base_1_2_by_e0_of_motion_4;
    let w_S_in_axle_base_2_2_by_e0_dot_of_motion_3 = e1 * w_S_in_axle_base_1_2_by_e0_of_motion_6;
    // w_S_in_axle_base_2_2_by_e0_dot = 3*e0*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/((3 + sqrt(3))*(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2) + 3*e0*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2
    //   + e2^2 + e3^2)^2 + e0*sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 -
    //   3*e1*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + 3*e2*(1 -
    //   1/(3 + sqrt(3)))*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 -
    //   e3*sqrt(3)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_2_2_by_e0_dot = e0
        .mul_add(
            w_S_in_axle_base_2_2_by_e0_dot_of_motion, -w_S_in_axle_base_1_2_by_e0_dot_of_motion_2,
        ) - w_S_in_axle_base_2_2_by_e0_dot_of_motion_2 - w_S_in_axle_base_2_2_by_e0_dot_of_motion_3;
    let e3_e3_e3_dot = e3 * e3_e3_dot;
    // w_S_in_axle_base_3_2_by_e0_dot = sqrt(3)*(e0*(e3*(e2' - 2*e0' - e1') + e0*(e1' + e2' + e3') +
    //   e1*(e3' - 2*e0' - e2') + e2*(e1' - 2*e0' - e3')) - e3^2*e3' - e1*(e1'*(e1 + e2 + e3) + e2*e2' +
    //   e3*e3') - e2*(e2*e2' + e3*(e2' + e3')))/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_3_2_by_e0_dot = -w_S_in_axle_base_3_2_by_e0_of_e0_e1_e2_e3
        * (e2 * e3.mul_add(e2_dot_plus_e3_dot, e2_e2_dot)
            + e0
                * (e3 * (e1_dot_minus_e2_dot + e0_dot_doubled)
                    - w_S_in_axle_base_3_by_e0_of_motion_2
                    - e1 * (minus_e2_dot_plus_e3_dot - e0_dot_doubled)
                    - e2 * (e1_dot_minus_e3_dot - e0_dot_doubled))
            + e1 * e1_dot.mul_add(e3_plus_e1_plus_e2, e3_e3_dot_plus_e2_e2_dot) + e3_e3_e3_dot);
    // K*(w_S_in_axle_base_1_by_e0_dot + w_S_in_axle_base_2_by_e0_dot)
    let r1_by_e0_dot_of_place = K * (w_S_in_axle_base_1_by_e0_dot + w_S_in_axle_base_2_by_e0_dot);
    // r1_by_e0_dot_of_place - w_S_in_axle_base_3_by_e0_dot*j_doubled
    let r1_by_e0_dot_of_place_2 = (-w_S_in_axle_base_3_by_e0_dot)
        .mul_add(j_doubled, r1_by_e0_dot_of_place);
    // K*(w_S_in_axle_base_1_2_by_e0_dot + w_S_in_axle_base_2_2_by_e0_dot)
    let r1_by_e0_dot_of_place_3 = K
        * (w_S_in_axle_base_1_2_by_e0_dot + w_S_in_axle_base_2_2_by_e0_dot);
    // J*w_S_in_axle_base_3_by_e0_dot + r1_by_e0_dot_of_place
    let r1_by_e0_dot_of_place_4 = J
        .mul_add(w_S_in_axle_base_3_by_e0_dot, r1_by_e0_dot_of_place);
    let r1_by_e0_dot_of_motion = r1_of_motion_13 * k_times_3;
    // w_S_in_axle_base_1_by_e0_dot - w_S_in_axle_base_2_by_e0_dot
    let r1_by_e0_dot_of_place_5 = w_S_in_axle_base_1_by_e0_dot - w_S_in_axle_base_2_by_e0_dot;
    let h_bus_1_times_18 = S::int(18) * H_bus_1;
    let h_bus_2_times_18 = S::int(18) * H_bus_2;
    // K*(w_S_in_axle_base_1_2_by_e0_dot - w_S_in_axle_base_2_2_by_e0_dot)
    let r1_by_e0_dot_of_place_6 = K
        * (w_S_in_axle_base_1_2_by_e0_dot - w_S_in_axle_base_2_2_by_e0_dot);
    // w_S_1_2_by_e0_dot*a_times_6 - r1_by_e0_dot_of_place_6
    let r1_by_e0_dot_of_place_7 = w_S_1_2_by_e0_dot
        .mul_add(a_times_6, -r1_by_e0_dot_of_place_6);
    let r1_by_e0_dot_of_place_8 = K * r1_by_e0_dot_of_place_5;
    // w_S_2_by_e0_dot*b_times_6 + r1_by_e0_dot_of_place_8
    let r1_by_e0_dot_of_place_9 = w_S_2_by_e0_dot
        .mul_add(b_times_6, r1_by_e0_dot_of_place_8);
    let k_r1_of_a_k_times_3 = S::int(3) * k_r1_of_a_k;
    let r1_of_place_7_times_3 = S::int(3) * r1_of_place_7;
    let r1_by_e0_dot_of_place_10 = w_S_1_of_e0_e1_e2_e3 * c_times_18;
    let r1_by_e0_dot_of_motion_2 = S::int(18) * a_w_s_2_of_motion_3;
    let r1_by_e0_dot_of_motion_3 = S::int(18) * b_w_s_1_of_motion_3;
    let r1_by_e0_dot_of_e0_e1_e2_e3 = S::ratio(2, 9) * w_s_1_of_e0_e1_e2_e3_inv;
    // r1_by_e0_dot = 2*(18*e1*H_bus_2 - 18*e2*H_bus_1 + 3*H_wheel_1*(e1 + e2) - 3*H_wheel_2*(e1 + e2) +
    //   18*A*w_S_1_by_e0_dot*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 18*B*w_S_2_by_e0_dot*(e1*e0' - e0*e1' -
    //   e3*e2' + e2*e3') + 3*K*w_S_in_axle_base_1_by_e0_dot*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' +
    //   e3') + e1*(e0' - e3')) + 3*K*w_S_in_axle_base_2_by_e0_dot*(e0*(e1' + e2') - e3*(e1' - e2') - e2*(e0'
    //   + e3') - e1*(e0' - e3')) + 18*C*w_S_3_2_by_e0_dot*(e0^2 + e1^2 + e2^2 + e3^2) + 3*K*(e2*(6*H_bus_3 +
    //   6*C*e0'*w_S_3_by_e0_dot + e1'*(6*B*w_S_2_by_e0_dot + K*w_S_in_axle_base_1_by_e0_dot -
    //   K*w_S_in_axle_base_2_by_e0_dot) + e2*(6*A*w_S_1_2_by_e0_dot - K*w_S_in_axle_base_1_2_by_e0_dot +
    //   K*w_S_in_axle_base_2_2_by_e0_dot)) - e0*(6*C*e2'*w_S_3_by_e0_dot +
    //   e3'*(K*w_S_in_axle_base_2_by_e0_dot - 6*B*w_S_2_by_e0_dot - K*w_S_in_axle_base_1_by_e0_dot) +
    //   e0*(K*w_S_in_axle_base_1_2_by_e0_dot - 6*A*w_S_1_2_by_e0_dot - K*w_S_in_axle_base_2_2_by_e0_dot)) -
    //   e1*(6*C*e3'*w_S_3_by_e0_dot + e2'*(6*B*w_S_2_by_e0_dot + K*w_S_in_axle_base_1_by_e0_dot -
    //   K*w_S_in_axle_base_2_by_e0_dot) + e1*(K*w_S_in_axle_base_1_2_by_e0_dot - 6*A*w_S_1_2_by_e0_dot -
    //   K*w_S_in_axle_base_2_2_by_e0_dot)) - e3*(6*H_bus_2 + H_wheel_1 - H_wheel_2 - 6*C*e1'*w_S_3_by_e0_dot
    //   + e0'*(6*B*w_S_2_by_e0_dot + K*w_S_in_axle_base_1_by_e0_dot - K*w_S_in_axle_base_2_by_e0_dot) +
    //   e3*(K*w_S_in_axle_base_1_2_by_e0_dot - 6*A*w_S_1_2_by_e0_dot -
    //   K*w_S_in_axle_base_2_2_by_e0_dot)))/(3*A + 2*K) + sqrt(3)*(e0*(e1'*(K*w_S_in_axle_base_1_by_e0_dot +
    //   K*w_S_in_axle_base_2_by_e0_dot - 2*J*w_S_in_axle_base_3_by_e0_dot) +
    //   e2'*(2*J*w_S_in_axle_base_3_by_e0_dot - K*w_S_in_axle_base_1_by_e0_dot -
    //   K*w_S_in_axle_base_2_by_e0_dot) + 2*e0*(K*w_S_in_axle_base_1_2_by_e0_dot +
    //   K*w_S_in_axle_base_2_2_by_e0_dot)) + e1*(H_wheel_3 - H_wheel_1 - H_wheel_2 -
    //   e0'*(K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot -
    //   2*J*w_S_in_axle_base_3_by_e0_dot) - e3'*(K*w_S_in_axle_base_1_by_e0_dot +
    //   K*w_S_in_axle_base_2_by_e0_dot - 2*J*w_S_in_axle_base_3_by_e0_dot) +
    //   2*e1*(K*w_S_in_axle_base_1_2_by_e0_dot + K*w_S_in_axle_base_2_2_by_e0_dot)) + e2*(H_wheel_1 +
    //   H_wheel_2 - H_wheel_3 + e0'*(K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot -
    //   2*J*w_S_in_axle_base_3_by_e0_dot) + e3'*(2*J*w_S_in_axle_base_3_by_e0_dot -
    //   K*w_S_in_axle_base_1_by_e0_dot - K*w_S_in_axle_base_2_by_e0_dot) +
    //   2*e2*(K*w_S_in_axle_base_1_2_by_e0_dot + K*w_S_in_axle_base_2_2_by_e0_dot)) +
    //   e3*(e1'*(K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot -
    //   2*J*w_S_in_axle_base_3_by_e0_dot) + e2'*(K*w_S_in_axle_base_1_by_e0_dot +
    //   K*w_S_in_axle_base_2_by_e0_dot - 2*J*w_S_in_axle_base_3_by_e0_dot) +
    //   2*e3*(K*w_S_in_axle_base_1_2_by_e0_dot + K*w_S_in_axle_base_2_2_by_e0_dot)) -
    //   K*(e0*(2*e2'*(K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot +
    //   J*w_S_in_axle_base_3_by_e0_dot) + e3'*(K*w_S_in_axle_base_1_by_e0_dot +
    //   K*w_S_in_axle_base_2_by_e0_dot - 2*J*w_S_in_axle_base_3_by_e0_dot) +
    //   e0*(K*w_S_in_axle_base_1_2_by_e0_dot + K*w_S_in_axle_base_2_2_by_e0_dot)) +
    //   e1*(2*e3'*(K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot +
    //   J*w_S_in_axle_base_3_by_e0_dot) + e2'*(2*J*w_S_in_axle_base_3_by_e0_dot -
    //   K*w_S_in_axle_base_1_by_e0_dot - K*w_S_in_axle_base_2_by_e0_dot) +
    //   e1*(K*w_S_in_axle_base_1_2_by_e0_dot + K*w_S_in_axle_base_2_2_by_e0_dot)) +
    //   e2*(e2*(K*w_S_in_axle_base_1_2_by_e0_dot + K*w_S_in_axle_base_2_2_by_e0_dot) - 2*H_wheel_1 -
    //   2*H_wheel_2 - H_wheel_3 - 2*e0'*(K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot +
    //   J*w_S_in_axle_base_3_by_e0_dot) - e1'*(2*J*w_S_in_axle_base_3_by_e0_dot -
    //   K*w_S_in_axle_base_1_by_e0_dot - K*w_S_in_axle_base_2_by_e0_dot)) + e3*(H_wheel_3 - H_wheel_1 -
    //   H_wheel_2 - 2*e1'*(K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot +
    //   J*w_S_in_axle_base_3_by_e0_dot) - e0'*(K*w_S_in_axle_base_1_by_e0_dot +
    //   K*w_S_in_axle_base_2_by_e0_dot - 2*J*w_S_in_axle_base_3_by_e0_dot) +
    //   e3*(K*w_S_in_axle_base_1_2_by_e0_dot + K*w_S_in_axle_base_2_2_by_e0_dot)))/(3*A + 2*K)))/(9*(e0^2 +
    //   e1^2 + e2^2 + e3^2))
    let r1_by_e0_dot = r1_by_e0_dot_of_e0_e1_e2_e3
        * (w_S_in_axle_base_1_of_
            * (e0
                * e0_doubled
                    .mul_add(
                        r1_by_e0_dot_of_place_3,
                        e1_dot_minus_e2_dot * r1_by_e0_dot_of_place_2,
                    )
                + e3
                    * e3_doubled
                        .mul_add(
                            r1_by_e0_dot_of_place_3,
                            e1_dot_plus_e2_dot * r1_by_e0_dot_of_place_2,
                        )
                + e1
                    * ((-e0_dot_plus_e3_dot)
                        .mul_add(r1_by_e0_dot_of_place_2, r1_of_place_3)
                        + e1_doubled * r1_by_e0_dot_of_place_3)
                + e2
                    * (e0_dot_minus_e3_dot
                        .mul_add(r1_by_e0_dot_of_place_2, -r1_of_place_3)
                        + e2_doubled * r1_by_e0_dot_of_place_3)
                - k_r1_of_a_k
                    * (e0
                        * (e0
                            .mul_add(
                                r1_by_e0_dot_of_place_3,
                                e3_dot * r1_by_e0_dot_of_place_2,
                            ) + e2_dot_doubled * r1_by_e0_dot_of_place_4)
                        + e1
                            * ((-e2_dot)
                                .mul_add(
                                    r1_by_e0_dot_of_place_2,
                                    e1 * r1_by_e0_dot_of_place_3,
                                ) + e3_dot_doubled * r1_by_e0_dot_of_place_4)
                        + e2
                            * (e1_dot.mul_add(r1_by_e0_dot_of_place_2, -r1_of_place_6)
                                + e2 * r1_by_e0_dot_of_place_3
                                - e0_dot_doubled * r1_by_e0_dot_of_place_4)
                        + e3
                            * ((-e0_dot).mul_add(r1_by_e0_dot_of_place_2, r1_of_place_3)
                                + e3 * r1_by_e0_dot_of_place_3
                                - e1_dot_doubled * r1_by_e0_dot_of_place_4)))
            + r1_by_e0_dot_of_motion * r1_by_e0_dot_of_place_5 - e2 * h_bus_1_times_18
            + e1 * h_bus_2_times_18
            + k_r1_of_a_k_times_3
                * (e2
                    * (w_S_3_by_e0_dot.mul_add(e0_dot_c_times_6, h_bus_3_times_6)
                        + e2 * r1_by_e0_dot_of_place_7 + e1_dot * r1_by_e0_dot_of_place_9)
                    + e3
                        * (w_S_3_by_e0_dot.mul_add(e1_dot_c_times_6, -r1_of_place_10)
                            + e3 * r1_by_e0_dot_of_place_7 - e0_dot * r1_by_e0_dot_of_place_9)
                    + e0
                        * ((-w_S_3_by_e0_dot)
                            .mul_add(e2_dot_c_times_6, e0 * r1_by_e0_dot_of_place_7)
                            + e3_dot * r1_by_e0_dot_of_place_9)
                    + e1
                        * ((-w_S_3_by_e0_dot)
                            .mul_add(e3_dot_c_times_6, e1 * r1_by_e0_dot_of_place_7)
                            - e2_dot * r1_by_e0_dot_of_place_9))
            + e1_plus_e2 * r1_of_place_7_times_3 + w_S_3_2_by_e0_dot * r1_by_e0_dot_of_place_10
            + w_S_1_by_e0_dot * r1_by_e0_dot_of_motion_2
            - w_S_2_by_e0_dot * r1_by_e0_dot_of_motion_3);
    // e3*minus_r1_of_place_3 - w_S_3_of_motion_3*r1_by_e0_dot_of_place_2
    let w3_dot_by_e0_dot_of_motion = (-w_S_3_of_motion_3)
        .mul_add(r1_by_e0_dot_of_place_2, e3 * minus_r1_of_place_3);
    let w3_dot_by_e0_dot_of_place = w_S_1_of_e0_e1_e2_e3 * r1_by_e0_dot_of_place_3;
    let e1_r1_of_place_6 = e1 * r1_of_place_6;
    let e2_r1_of_place_6 = e2 * r1_of_place_6;
    let e2_h_bus_3_times_18 = e2 * h_bus_3_times_18;
    // w3_dot_by_e0_of_e0_e1_e2_e3*r1_by_e0_dot_of_place_7 - e3*r1_of_place_10_times_3 -
    //   w_S_3_by_e0_dot*w3_dot_by_e0_of_motion_3 + w3_dot_by_e0_of_motion_2*r1_by_e0_dot_of_place_9 +
    //   sqrt(3)*(w3_dot_by_e0_dot_of_motion - w3_dot_of_motion_3*r1_by_e0_dot_of_place_4 -
    //   w3_dot_by_e0_dot_of_place + e2_r1_of_place_6) + e2_h_bus_3_times_18
    let w3_dot_by_e0_dot_of_motion_2 = w3_dot_by_e0_of_e0_e1_e2_e3
        * r1_by_e0_dot_of_place_7 - e3 * r1_of_place_10_times_3
        - w_S_3_by_e0_dot * w3_dot_by_e0_of_motion_3
        + w3_dot_by_e0_of_motion_2 * r1_by_e0_dot_of_place_9
        + w_S_in_axle_base_1_of_
            * ((-w3_dot_of_motion_3)
                .mul_add(r1_by_e0_dot_of_place_4, w3_dot_by_e0_dot_of_motion)
                - w3_dot_by_e0_dot_of_place + e2_r1_of_place_6) + e2_h_bus_3_times_18;
    let e1_h_bus_3_times_18 = e1 * h_bus_3_times_18;
    // e3*w3_dot_by_e0_of_place_2 + w_S_3_by_e0_dot*w3_dot_by_e0_of_motion_5 +
    //   w3_dot_by_e0_of_e0_e1_e2_e3*(w_S_2_2_by_e0_dot*b_times_6 + r1_by_e0_dot_of_place_6) +
    //   w3_dot_by_e0_of_motion_2*(r1_by_e0_dot_of_place_8 - w_S_1_by_e0_dot*a_times_6) +
    //   sqrt(3)*(w3_dot_of_motion*r1_by_e0_dot_of_place_4 - w3_dot_by_e0_dot_of_motion -
    //   w3_dot_by_e0_dot_of_place - e1_r1_of_place_6) + k_r1_of_a_k*w3_dot_by_e0_dot_of_motion_2 -
    //   e1_h_bus_3_times_18
    let w3_dot_by_e0_dot_of_motion_3 = e3 * w3_dot_by_e0_of_place_2
        + w_S_3_by_e0_dot * w3_dot_by_e0_of_motion_5
        + w3_dot_by_e0_of_e0_e1_e2_e3
            * w_S_2_2_by_e0_dot.mul_add(b_times_6, r1_by_e0_dot_of_place_6)
        + w3_dot_by_e0_of_motion_2 * (-w_S_1_by_e0_dot).mul_add(a_times_6, r1_by_e0_dot_of_place_8)
        + w_S_in_axle_base_1_of_
            * (w3_dot_of_motion
                .mul_add(r1_by_e0_dot_of_place_4, -w3_dot_by_e0_dot_of_motion)
                - w3_dot_by_e0_dot_of_place - e1_r1_of_place_6)
        + k_r1_of_a_k * w3_dot_by_e0_dot_of_motion_2 - e1_h_bus_3_times_18;
    // w3_dot_by_e0_dot = (2*K*(A + K)*(3*e3*(6*H_bus_1 - H_wheel_1 + H_wheel_2) - 18*e1*H_bus_3 +
    //   18*C*w_S_3_by_e0_dot*(e0*e1' - e1*e0' + e3*e2' - e2*e3') + 3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*A*w_S_1_by_e0_dot - K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot) +
    //   3*(e0^2 + e1^2 + e2^2 + e3^2)*(6*B*w_S_2_2_by_e0_dot + K*w_S_in_axle_base_1_2_by_e0_dot -
    //   K*w_S_in_axle_base_2_2_by_e0_dot) + K*(18*e2*H_bus_3 + 3*e3*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) +
    //   18*C*w_S_3_by_e0_dot*(e2*e0' - e0*e2' + e3*e1' - e1*e3') + 3*(e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(6*B*w_S_2_by_e0_dot + K*w_S_in_axle_base_1_by_e0_dot - K*w_S_in_axle_base_2_by_e0_dot) +
    //   3*(e0^2 + e1^2 + e2^2 + e3^2)*(6*A*w_S_1_2_by_e0_dot - K*w_S_in_axle_base_1_2_by_e0_dot +
    //   K*w_S_in_axle_base_2_2_by_e0_dot) + sqrt(3)*(e2*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   e3*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*(e2*e0' - e0*e2' + e3*e1' -
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot +
    //   J*w_S_in_axle_base_3_by_e0_dot) + (e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot -
    //   2*J*w_S_in_axle_base_3_by_e0_dot) - (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e0_dot +
    //   K*w_S_in_axle_base_2_2_by_e0_dot)))/(3*A + 2*K) - sqrt(3)*(e1*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) + e3*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3')*(K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot +
    //   J*w_S_in_axle_base_3_by_e0_dot) + (e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot -
    //   2*J*w_S_in_axle_base_3_by_e0_dot) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e0_dot +
    //   K*w_S_in_axle_base_2_2_by_e0_dot)))/((3*A + 2*K)*(3*B + K*(2 - K/(3*A + 2*K)))*(e0^2 + e1^2 + e2^2 +
    //   e3^2)) + 3*r1_by_e0_dot)/(3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A + K)^2/((3*A + 2*K)^2*(3*B + K*(2 -
    //   K/(3*A + 2*K)))))
    let w3_dot_by_e0_dot = w3_dot_of_a_b_c_k
        * w3_dot_by_e0_of_place_3
            .mul_add(w3_dot_by_e0_dot_of_motion_3, S::int(3) * r1_by_e0_dot);
    // w2_dot_by_e0_dot = (2*(3*e3*(6*H_bus_1 - H_wheel_1 + H_wheel_2) - 18*e1*H_bus_3 +
    //   18*C*w_S_3_by_e0_dot*(e0*e1' - e1*e0' + e3*e2' - e2*e3') + 3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*A*w_S_1_by_e0_dot - K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot) +
    //   3*(e0^2 + e1^2 + e2^2 + e3^2)*(6*B*w_S_2_2_by_e0_dot + K*w_S_in_axle_base_1_2_by_e0_dot -
    //   K*w_S_in_axle_base_2_2_by_e0_dot) + K*(18*e2*H_bus_3 + 3*e3*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) +
    //   18*C*w_S_3_by_e0_dot*(e2*e0' - e0*e2' + e3*e1' - e1*e3') + 3*(e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(6*B*w_S_2_by_e0_dot + K*w_S_in_axle_base_1_by_e0_dot - K*w_S_in_axle_base_2_by_e0_dot) +
    //   3*(e0^2 + e1^2 + e2^2 + e3^2)*(6*A*w_S_1_2_by_e0_dot - K*w_S_in_axle_base_1_2_by_e0_dot +
    //   K*w_S_in_axle_base_2_2_by_e0_dot) + sqrt(3)*(e2*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   e3*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*(e2*e0' - e0*e2' + e3*e1' -
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot +
    //   J*w_S_in_axle_base_3_by_e0_dot) + (e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot -
    //   2*J*w_S_in_axle_base_3_by_e0_dot) - (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e0_dot +
    //   K*w_S_in_axle_base_2_2_by_e0_dot)))/(3*A + 2*K) - sqrt(3)*(e1*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) + e3*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3')*(K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot +
    //   J*w_S_in_axle_base_3_by_e0_dot) + (e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot -
    //   2*J*w_S_in_axle_base_3_by_e0_dot) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e0_dot +
    //   K*w_S_in_axle_base_2_2_by_e0_dot)))/(e0^2 + e1^2 + e2^2 + e3^2) + 9*K*w3_dot_by_e0_dot*(A + K)/(3*A
    //   + 2*K))/(3*(3*B + K*(2 - K/(3*A + 2*K))))
    let w2_dot_by_e0_dot = w3_dot_of_a_b_k_by_3
        * w_S_1_by_e0_of_e0_e1_e2_e3
            .mul_add(w3_dot_by_e0_dot_of_motion_3, w3_dot_by_e0_dot * w3_dot_of_a_k_2);
    // w3_dot_by_e0_dot + w2_dot_by_e0_dot
    let w1_dot_by_e0_dot_of_place = w3_dot_by_e0_dot + w2_dot_by_e0_dot;
    // w1_dot_by_e0_dot = (2*(18*e2*H_bus_3 + 3*e3*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) +
    //   18*C*w_S_3_by_e0_dot*(e2*e0' - e0*e2' + e3*e1' - e1*e3') + 3*(e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(6*B*w_S_2_by_e0_dot + K*w_S_in_axle_base_1_by_e0_dot - K*w_S_in_axle_base_2_by_e0_dot) +
    //   3*(e0^2 + e1^2 + e2^2 + e3^2)*(6*A*w_S_1_2_by_e0_dot - K*w_S_in_axle_base_1_2_by_e0_dot +
    //   K*w_S_in_axle_base_2_2_by_e0_dot) + sqrt(3)*(e2*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   e3*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*(e2*e0' - e0*e2' + e3*e1' -
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot +
    //   J*w_S_in_axle_base_3_by_e0_dot) + (e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e0_dot + K*w_S_in_axle_base_2_by_e0_dot -
    //   2*J*w_S_in_axle_base_3_by_e0_dot) - (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e0_dot +
    //   K*w_S_in_axle_base_2_2_by_e0_dot)))/(e0^2 + e1^2 + e2^2 + e3^2) + 3*K*(w3_dot_by_e0_dot +
    //   w2_dot_by_e0_dot))/(3*(3*A + 2*K))
    let w1_dot_by_e0_dot = r1_of_a_k_by_3
        * k_times_3
            .mul_add(
                w1_dot_by_e0_dot_of_place,
                w_S_1_by_e0_of_e0_e1_e2_e3 * w3_dot_by_e0_dot_of_motion_2,
            );
    // s_dot_by_e0_dot = 4*w_S_in_axle_base_3_2_by_e0_dot/3 - sqrt(3)*(w3_dot_by_e0_dot + w2_dot_by_e0_dot
    //   + w1_dot_by_e0_dot)/3
    let s_dot_by_e0_dot = S::ratio(4, 3) * w_S_in_axle_base_3_2_by_e0_dot
        - s_dot_by_e0_of_ * (w1_dot_by_e0_dot + w1_dot_by_e0_dot_of_place);
    // e0'*(e1_sq + e3_sq_plus_e2_sq) - e0*e0_ddot_by_e0_of_motion_3
    let e0_ddot_by_e0_dot_of_motion = e0_dot * (e1_sq + e3_sq_plus_e2_sq)
        - e0 * e0_ddot_by_e0_of_motion_3;
    // e0_ddot_by_e0_dot = 2*e0*(e0*(e1*e1' + e2*e2' + e3*e3') - e0'*(e1^2 + e2^2 + e3^2))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 - e3*w3_dot_by_e0_dot/2 - e2*w2_dot_by_e0_dot/2 - e1*w1_dot_by_e0_dot/2
    let e0_ddot_by_e0_dot = (-w2_dot_by_e0_dot)
        .mul_add(e2_halved, -w1_dot_by_e0_dot * e1_halved) - w3_dot_by_e0_dot * e3_halved
        - w3_dot_by_e0_of_e0_e1_e2_e3_3 * e0_ddot_by_e0_dot_of_motion;
    // e1_ddot_by_e0_dot = 2*e1*(e0*(e1*e1' + e2*e2' + e3*e3') - e0'*(e1^2 + e2^2 + e3^2))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 + e2*w3_dot_by_e0_dot/2 - e3*w2_dot_by_e0_dot/2 + e0*w1_dot_by_e0_dot/2
    let e1_ddot_by_e0_dot = (-w2_dot_by_e0_dot)
        .mul_add(e3_halved, w3_dot_by_e0_dot * e2_halved) + w1_dot_by_e0_dot * e0_halved
        - e1_ddot_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e0_dot_of_motion;
    // e2_ddot_by_e0_dot = 2*e2*(e0*(e1*e1' + e2*e2' + e3*e3') - e0'*(e1^2 + e2^2 + e3^2))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 - e1*w3_dot_by_e0_dot/2 + e0*w2_dot_by_e0_dot/2 + e3*w1_dot_by_e0_dot/2
    let e2_ddot_by_e0_dot = (-w3_dot_by_e0_dot)
        .mul_add(e1_halved, w1_dot_by_e0_dot * e3_halved) + w2_dot_by_e0_dot * e0_halved
        - e2_ddot_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e0_dot_of_motion;
    // e3_ddot_by_e0_dot = 2*e3*(e0*(e1*e1' + e2*e2' + e3*e3') - e0'*(e1^2 + e2^2 + e3^2))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 + e0*w3_dot_by_e0_dot/2 + e1*w2_dot_by_e0_dot/2 - e2*w1_dot_by_e0_dot/2
    let e3_ddot_by_e0_dot = (-w1_dot_by_e0_dot)
        .mul_add(e2_halved, w2_dot_by_e0_dot * e1_halved) + w3_dot_by_e0_dot * e0_halved
        - e3_ddot_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e0_dot_of_motion;
    // w_S_1_by_e1_dot = e0/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_1_by_e1_dot = e0 * w_s_1_of_e0_e1_e2_e3_inv;
    // w_S_2_by_e1_dot = -e3/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_2_by_e1_dot = minus_w_s_1_by_e2_dot;
    // e0 - e3
    let e0_minus_e3 = e0 - e3;
    // sqrt(3)*(e0_minus_e3 - e2_doubled)
    let w_S_in_axle_base_1_by_e1_dot_of_e0_e2_e3 = w_S_in_axle_base_1_of_
        * (e0_minus_e3 - e2_doubled);
    // e0 + e3
    let e0_plus_e3 = e0 + e3;
    let e0_plus_e3_times_3 = S::int(3) * e0_plus_e3;
    // w_S_in_axle_base_1_by_e1_dot = -(3*e0 + 3*e3 + sqrt(3)*(e0 - 2*e2 - e3))/(2*(e0^2 + e1^2 + e2^2 +
    //   e3^2))
    let w_S_in_axle_base_1_by_e1_dot = -w_S_in_axle_base_1_by_e0_dot_of_e0_e1_e2_e3
        * (w_S_in_axle_base_1_by_e1_dot_of_e0_e2_e3 + e0_plus_e3_times_3);
    // w_S_in_axle_base_2_by_e1_dot = (3*e0 + 3*e3 + sqrt(3)*(2*e2 - e0 + e3))/(2*(e0^2 + e1^2 + e2^2 +
    //   e3^2))
    let w_S_in_axle_base_2_by_e1_dot = w_S_in_axle_base_1_by_e0_dot_of_e0_e1_e2_e3
        * (e0_plus_e3_times_3 - w_S_in_axle_base_1_by_e1_dot_of_e0_e2_e3);
    // e2 + e0_minus_e3
    let e2_plus_e0_minus_e3 = e2 + e0_minus_e3;
    // w_S_in_axle_base_3_by_e1_dot = sqrt(3)*(e0 + e2 - e3)/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_3_by_e1_dot = w_S_in_axle_base_3_of_e0_e1_e2_e3 * e2_plus_e0_minus_e3;
    // w_S_1_2_by_e1_dot = (e1*(e3*e2' - e1*e0' - e2*e3') + e0*(e0*e0' + 2*e1*e1' + e2*e2' + e3*e3'))/(e0^2
    //   + e1^2 + e2^2 + e3^2)^2
    let w_S_1_2_by_e1_dot = w_S_1_2_of_e0_e1_e2_e3
        * (e0 * e1.mul_add(e1_dot_doubled, e0_ddot_by_e1_of_motion)
            - e1 * (e1_e0_dot + w_S_1_of_motion_2));
    // w_S_2_2_by_e1_dot = (e1*(e0*e2' - e2*e0' - 2*e3*e1' + e1*e3') - e3*(e0*e0' + e2*e2' + e3*e3'))/(e0^2
    //   + e1^2 + e2^2 + e3^2)^2
    let w_S_2_2_by_e1_dot = w_S_1_2_of_e0_e1_e2_e3
        * (e1 * (-e3).mul_add(e1_dot_doubled, w_S_2_of_motion + e1_e3_dot)
            - e3 * e0_ddot_by_e1_of_motion);
    // w_S_3_2_by_e1_dot = (e2*(e0*e0' + e2*e2' + e3*e3') + e1*(2*e2*e1' - e3*e0' - e1*e2' + e0*e3'))/(e0^2
    //   + e1^2 + e2^2 + e3^2)^2
    let w_S_3_2_by_e1_dot = w_S_1_2_of_e0_e1_e2_e3
        * (e1 * e2.mul_add(e1_dot_doubled, w_S_3_of_motion - e1_e2_dot)
            + e2 * e0_ddot_by_e1_of_motion);
    let w_S_in_axle_base_1_2_by_e1_dot_of_motion = e2 * w_S_in_axle_base_1_2_by_e0_of_motion;
    let w_S_in_axle_base_1_2_by_e1_dot_of_motion_2 = e0 * w_S_in_axle_base_1_2_by_e0_of_motion_4;
    let w_S_in_axle_base_1_2_by_e1_dot_of_motion_3 = e3 * w_S_in_axle_base_1_2_by_e0_of_motion_6;
    // w_S_in_axle_base_1_2_by_e1_dot = 3*e1*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' -
    //   e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 3*e1*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/((3 +
    //   sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + e1*sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2 + 3*e0*(1/(3 + sqrt(3)) - 1)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2
    //   + e2^2 + e3^2)^2 + e2*sqrt(3)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 -
    //   3*e3*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let w_S_in_axle_base_1_2_by_e1_dot = e1
        .mul_add(
            w_S_in_axle_base_1_2_by_e0_dot_of_motion, w_S_in_axle_base_1_2_by_e1_dot_of_motion,
        ) + w_S_in_axle_base_1_2_by_e1_dot_of_motion_2 - w_S_in_axle_base_1_2_by_e1_dot_of_motion_3;
    let w_S_in_axle_base_2_2_by_e1_dot_of_motion = e3 * w_S_in_axle_base_1_2_by_e0_of_motion_4;
    let w_S_in_axle_base_2_2_by_e1_dot_of_motion_2 = e0 * w_S_in_axle_base_1_2_by_e0_of_motion_6;
    // w_S_in_axle_base_2_2_by_e1_dot = 3*e1*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/((3 + sqrt(3))*(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2) + 3*e1*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2
    //   + e2^2 + e3^2)^2 + e1*sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 +
    //   3*e0*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) +
    //   e2*sqrt(3)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 3*e3*(1 - 1/(3 +
    //   sqrt(3)))*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_2_2_by_e1_dot = e1
        .mul_add(
            w_S_in_axle_base_2_2_by_e0_dot_of_motion, w_S_in_axle_base_1_2_by_e1_dot_of_motion,
        ) - w_S_in_axle_base_2_2_by_e1_dot_of_motion + w_S_in_axle_base_2_2_by_e1_dot_of_motion_2;
    // e0' - e2'
    let e0_dot_minus_e2_dot = e0_dot - e2_dot;
    // w_S_in_axle_base_3_2_by_e1_dot = sqrt(3)*(e0*(e0'*(e0 + e2 - e3) + e2*e2' + e3*e3') - e3^2*e3' -
    //   e1*(e3*(e0' + 2*e1' - e2') + e1*(e0' + e2' - e3') - e0*(2*e1' + e2' + e3') + e2*(e0' - 2*e1' + e3'))
    //   + e2*(e2*e2' + e3*(e3' - e2')))/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_3_2_by_e1_dot = w_S_in_axle_base_3_2_by_e0_of_e0_e1_e2_e3
        * (e0 * e0_dot.mul_add(e2_plus_e0_minus_e3, e3_e3_dot_plus_e2_e2_dot)
            - e2 * e3.mul_add(w_S_in_axle_base_3_2_by_e1_of_motion, -e2_e2_dot) - e3_e3_e3_dot
            - e1
                * (e2 * (e0_dot_plus_e3_dot - e1_dot_doubled) + w_S_in_axle_base_3_by_e0_of_motion_4
                    - e0 * (e1_dot_doubled + e2_dot_plus_e3_dot)
                    + e3 * (e1_dot_doubled + e0_dot_minus_e2_dot)));
    // K*(w_S_in_axle_base_1_by_e1_dot + w_S_in_axle_base_2_by_e1_dot)
    let r1_by_e1_dot_of_place = K * (w_S_in_axle_base_1_by_e1_dot + w_S_in_axle_base_2_by_e1_dot);
    // r1_by_e1_dot_of_place - w_S_in_axle_base_3_by_e1_dot*j_doubled
    let r1_by_e1_dot_of_place_2 = (-w_S_in_axle_base_3_by_e1_dot)
        .mul_add(j_doubled, r1_by_e1_dot_of_place);
    // K*(w_S_in_axle_base_1_2_by_e1_dot + w_S_in_axle_base_2_2_by_e1_dot)
    let r1_by_e1_dot_of_place_3 = K
        * (w_S_in_axle_base_1_2_by_e1_dot + w_S_in_axle_base_2_2_by_e1_dot);
    // J*w_S_in_axle_base_3_by_e1_dot + r1_by_e1_dot_of_place
    let r1_by_e1_dot_of_place_4 = J
        .mul_add(w_S_in_axle_base_3_by_e1_dot, r1_by_e1_dot_of_place);
    // w_S_in_axle_base_1_by_e1_dot - w_S_in_axle_base_2_by_e1_dot
    let r1_by_e1_dot_of_place_5 = w_S_in_axle_base_1_by_e1_dot - w_S_in_axle_base_2_by_e1_dot;
    // K*(w_S_in_axle_base_1_2_by_e1_dot - w_S_in_axle_base_2_2_by_e1_dot)
    let r1_by_e1_dot_of_place_6 = K
        * (w_S_in_axle_base_1_2_by_e1_dot - w_S_in_axle_base_2_2_by_e1_dot);
    // w_S_1_2_by_e1_dot*a_times_6 - r1_by_e1_dot_of_place_6
    let r1_by_e1_dot_of_place_7 = w_S_1_2_by_e1_dot
        .mul_add(a_times_6, -r1_by_e1_dot_of_place_6);
    let r1_by_e1_dot_of_place_8 = K * r1_by_e1_dot_of_place_5;
    // w_S_2_by_e1_dot*b_times_6 + r1_by_e1_dot_of_place_8
    let r1_by_e1_dot_of_place_9 = w_S_2_by_e1_dot
        .mul_add(b_times_6, r1_by_e1_dot_of_place_8);
    // r1_by_e1_dot = 2*(3*H_wheel_1*(e3 - e0) - 18*e3*H_bus_1 - 18*e0*H_bus_2 + 3*H_wheel_2*(e0 - e3) +
    //   18*A*w_S_1_by_e1_dot*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 18*B*w_S_2_by_e1_dot*(e1*e0' - e0*e1' -
    //   e3*e2' + e2*e3') + 3*K*w_S_in_axle_base_1_by_e1_dot*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' +
    //   e3') + e1*(e0' - e3')) + 3*K*w_S_in_axle_base_2_by_e1_dot*(e0*(e1' + e2') - e3*(e1' - e2') - e2*(e0'
    //   + e3') - e1*(e0' - e3')) + 18*C*w_S_3_2_by_e1_dot*(e0^2 + e1^2 + e2^2 + e3^2) + 3*K*(e3*(6*H_bus_3 +
    //   6*C*e1'*w_S_3_by_e1_dot + e0'*(K*w_S_in_axle_base_2_by_e1_dot - 6*B*w_S_2_by_e1_dot -
    //   K*w_S_in_axle_base_1_by_e1_dot) + e3*(6*A*w_S_1_2_by_e1_dot - K*w_S_in_axle_base_1_2_by_e1_dot +
    //   K*w_S_in_axle_base_2_2_by_e1_dot)) - e0*(6*C*e2'*w_S_3_by_e1_dot +
    //   e3'*(K*w_S_in_axle_base_2_by_e1_dot - 6*B*w_S_2_by_e1_dot - K*w_S_in_axle_base_1_by_e1_dot) +
    //   e0*(K*w_S_in_axle_base_1_2_by_e1_dot - 6*A*w_S_1_2_by_e1_dot - K*w_S_in_axle_base_2_2_by_e1_dot)) -
    //   e1*(6*C*e3'*w_S_3_by_e1_dot + e2'*(6*B*w_S_2_by_e1_dot + K*w_S_in_axle_base_1_by_e1_dot -
    //   K*w_S_in_axle_base_2_by_e1_dot) + e1*(K*w_S_in_axle_base_1_2_by_e1_dot - 6*A*w_S_1_2_by_e1_dot -
    //   K*w_S_in_axle_base_2_2_by_e1_dot)) - e2*(H_wheel_2 - 6*H_bus_2 - H_wheel_1 - 6*C*e0'*w_S_3_by_e1_dot
    //   - e1'*(6*B*w_S_2_by_e1_dot + K*w_S_in_axle_base_1_by_e1_dot - K*w_S_in_axle_base_2_by_e1_dot) -
    //   e2*(6*A*w_S_1_2_by_e1_dot - K*w_S_in_axle_base_1_2_by_e1_dot +
    //   K*w_S_in_axle_base_2_2_by_e1_dot)))/(3*A + 2*K) + sqrt(3)*(e0*(H_wheel_1 + H_wheel_2 - H_wheel_3 +
    //   e1'*(K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot -
    //   2*J*w_S_in_axle_base_3_by_e1_dot) + e2'*(2*J*w_S_in_axle_base_3_by_e1_dot -
    //   K*w_S_in_axle_base_1_by_e1_dot - K*w_S_in_axle_base_2_by_e1_dot) +
    //   2*e0*(K*w_S_in_axle_base_1_2_by_e1_dot + K*w_S_in_axle_base_2_2_by_e1_dot)) +
    //   e1*(2*e1*(K*w_S_in_axle_base_1_2_by_e1_dot + K*w_S_in_axle_base_2_2_by_e1_dot) -
    //   e0'*(K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot -
    //   2*J*w_S_in_axle_base_3_by_e1_dot) - e3'*(K*w_S_in_axle_base_1_by_e1_dot +
    //   K*w_S_in_axle_base_2_by_e1_dot - 2*J*w_S_in_axle_base_3_by_e1_dot)) +
    //   e2*(2*e2*(K*w_S_in_axle_base_1_2_by_e1_dot + K*w_S_in_axle_base_2_2_by_e1_dot) -
    //   e0'*(2*J*w_S_in_axle_base_3_by_e1_dot - K*w_S_in_axle_base_1_by_e1_dot -
    //   K*w_S_in_axle_base_2_by_e1_dot) - e3'*(K*w_S_in_axle_base_1_by_e1_dot +
    //   K*w_S_in_axle_base_2_by_e1_dot - 2*J*w_S_in_axle_base_3_by_e1_dot)) + e3*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3 + e1'*(K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot -
    //   2*J*w_S_in_axle_base_3_by_e1_dot) + e2'*(K*w_S_in_axle_base_1_by_e1_dot +
    //   K*w_S_in_axle_base_2_by_e1_dot - 2*J*w_S_in_axle_base_3_by_e1_dot) +
    //   2*e3*(K*w_S_in_axle_base_1_2_by_e1_dot + K*w_S_in_axle_base_2_2_by_e1_dot)) -
    //   K*(e0*(2*e2'*(K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot +
    //   J*w_S_in_axle_base_3_by_e1_dot) + e3'*(K*w_S_in_axle_base_1_by_e1_dot +
    //   K*w_S_in_axle_base_2_by_e1_dot - 2*J*w_S_in_axle_base_3_by_e1_dot) +
    //   e0*(K*w_S_in_axle_base_1_2_by_e1_dot + K*w_S_in_axle_base_2_2_by_e1_dot)) +
    //   e1*(2*e3'*(K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot +
    //   J*w_S_in_axle_base_3_by_e1_dot) + e2'*(2*J*w_S_in_axle_base_3_by_e1_dot -
    //   K*w_S_in_axle_base_1_by_e1_dot - K*w_S_in_axle_base_2_by_e1_dot) +
    //   e1*(K*w_S_in_axle_base_1_2_by_e1_dot + K*w_S_in_axle_base_2_2_by_e1_dot)) + e2*(H_wheel_1 +
    //   H_wheel_2 - H_wheel_3 - 2*e0'*(K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot +
    //   J*w_S_in_axle_base_3_by_e1_dot) + e1'*(K*w_S_in_axle_base_1_by_e1_dot +
    //   K*w_S_in_axle_base_2_by_e1_dot - 2*J*w_S_in_axle_base_3_by_e1_dot) +
    //   e2*(K*w_S_in_axle_base_1_2_by_e1_dot + K*w_S_in_axle_base_2_2_by_e1_dot)) +
    //   e3*(e3*(K*w_S_in_axle_base_1_2_by_e1_dot + K*w_S_in_axle_base_2_2_by_e1_dot) - 2*H_wheel_1 -
    //   2*H_wheel_2 - H_wheel_3 - 2*e1'*(K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot +
    //   J*w_S_in_axle_base_3_by_e1_dot) - e0'*(K*w_S_in_axle_base_1_by_e1_dot +
    //   K*w_S_in_axle_base_2_by_e1_dot - 2*J*w_S_in_axle_base_3_by_e1_dot)))/(3*A + 2*K)))/(9*(e0^2 + e1^2 +
    //   e2^2 + e3^2))
    let r1_by_e1_dot = r1_by_e0_dot_of_e0_e1_e2_e3
        * (w_S_3_2_by_e1_dot * r1_by_e0_dot_of_place_10 - e3 * h_bus_1_times_18
            - e0 * h_bus_2_times_18 + w_S_1_by_e1_dot * r1_by_e0_dot_of_motion_2
            - w_S_2_by_e1_dot * r1_by_e0_dot_of_motion_3 - r1_of_place_7_times_3 * e0_minus_e3
            - w_S_in_axle_base_1_of_
                * (e1
                    * (-e1_doubled)
                        .mul_add(
                            r1_by_e1_dot_of_place_3,
                            e0_dot_plus_e3_dot * r1_by_e1_dot_of_place_2,
                        )
                    + e0
                        * ((-e1_dot_minus_e2_dot)
                            .mul_add(r1_by_e1_dot_of_place_2, r1_of_place_3)
                            - e0_doubled * r1_by_e1_dot_of_place_3)
                    - e2
                        * e2_doubled
                            .mul_add(
                                r1_by_e1_dot_of_place_3,
                                e0_dot_minus_e3_dot * r1_by_e1_dot_of_place_2,
                            )
                    + e3
                        * ((-e1_dot_plus_e2_dot)
                            .mul_add(r1_by_e1_dot_of_place_2, r1_of_place_3)
                            - e3_doubled * r1_by_e1_dot_of_place_3)
                    + k_r1_of_a_k
                        * (e0
                            * (e0
                                .mul_add(
                                    r1_by_e1_dot_of_place_3,
                                    e3_dot * r1_by_e1_dot_of_place_2,
                                ) + e2_dot_doubled * r1_by_e1_dot_of_place_4)
                            + e1
                                * ((-e2_dot)
                                    .mul_add(
                                        r1_by_e1_dot_of_place_2,
                                        e1 * r1_by_e1_dot_of_place_3,
                                    ) + e3_dot_doubled * r1_by_e1_dot_of_place_4)
                            + e3
                                * (e3.mul_add(r1_by_e1_dot_of_place_3, -r1_of_place_6)
                                    - e0_dot * r1_by_e1_dot_of_place_2
                                    - e1_dot_doubled * r1_by_e1_dot_of_place_4)
                            + e2
                                * (e1_dot.mul_add(r1_by_e1_dot_of_place_2, -r1_of_place_3)
                                    + e2 * r1_by_e1_dot_of_place_3
                                    - e0_dot_doubled * r1_by_e1_dot_of_place_4)))
            + r1_by_e0_dot_of_motion * r1_by_e1_dot_of_place_5
            + k_r1_of_a_k_times_3
                * (e2
                    * (w_S_3_by_e1_dot.mul_add(e0_dot_c_times_6, r1_of_place_10)
                        + e2 * r1_by_e1_dot_of_place_7 + e1_dot * r1_by_e1_dot_of_place_9)
                    + e3
                        * (w_S_3_by_e1_dot.mul_add(e1_dot_c_times_6, h_bus_3_times_6)
                            + e3 * r1_by_e1_dot_of_place_7 - e0_dot * r1_by_e1_dot_of_place_9)
                    + e0
                        * ((-w_S_3_by_e1_dot)
                            .mul_add(e2_dot_c_times_6, e0 * r1_by_e1_dot_of_place_7)
                            + e3_dot * r1_by_e1_dot_of_place_9)
                    + e1
                        * ((-w_S_3_by_e1_dot)
                            .mul_add(e3_dot_c_times_6, e1 * r1_by_e1_dot_of_place_7)
                            - e2_dot * r1_by_e1_dot_of_place_9)));
    // e2*minus_r1_of_place_3 + w_S_3_of_motion_3*r1_by_e1_dot_of_place_2
    let w3_dot_by_e1_dot_of_motion = w_S_3_of_motion_3
        .mul_add(r1_by_e1_dot_of_place_2, e2 * minus_r1_of_place_3);
    let w3_dot_by_e1_dot_of_place = w_S_1_of_e0_e1_e2_e3 * r1_by_e1_dot_of_place_3;
    let e0_r1_of_place_6 = e0 * r1_of_place_6;
    let e3_r1_of_place_6 = e3 * r1_of_place_6;
    let e3_h_bus_3_times_18 = e3 * h_bus_3_times_18;
    // w_S_3_by_e1_dot*w3_dot_by_e0_of_motion_3 - e2*r1_of_place_10_times_3 -
    //   w3_dot_by_e0_of_e0_e1_e2_e3*r1_by_e1_dot_of_place_7 -
    //   w3_dot_by_e0_of_motion_2*r1_by_e1_dot_of_place_9 +
    //   sqrt(3)*(w3_dot_of_motion_3*r1_by_e1_dot_of_place_4 + w3_dot_by_e1_dot_of_motion +
    //   w3_dot_by_e1_dot_of_place - e3_r1_of_place_6) - e3_h_bus_3_times_18
    let w3_dot_by_e1_dot_of_motion_2 = w_S_3_by_e1_dot * w3_dot_by_e0_of_motion_3
        - e2 * r1_of_place_10_times_3 - w3_dot_by_e0_of_e0_e1_e2_e3 * r1_by_e1_dot_of_place_7
        - w3_dot_by_e0_of_motion_2 * r1_by_e1_dot_of_place_9
        + w_S_in_axle_base_1_of_
            * (w3_dot_of_motion_3
                .mul_add(r1_by_e1_dot_of_place_4, w3_dot_by_e1_dot_of_motion)
                + w3_dot_by_e1_dot_of_place - e3_r1_of_place_6) - e3_h_bus_3_times_18;
    let e0_h_bus_3_times_18 = e0 * h_bus_3_times_18;
    // e2*w3_dot_by_e0_of_place_2 - w_S_3_by_e1_dot*w3_dot_by_e0_of_motion_5 -
    //   w3_dot_by_e0_of_e0_e1_e2_e3*(w_S_2_2_by_e1_dot*b_times_6 + r1_by_e1_dot_of_place_6) +
    //   w3_dot_by_e0_of_motion_2*(w_S_1_by_e1_dot*a_times_6 - r1_by_e1_dot_of_place_8) +
    //   sqrt(3)*(w3_dot_by_e1_dot_of_place - w3_dot_of_motion*r1_by_e1_dot_of_place_4 -
    //   w3_dot_by_e1_dot_of_motion - e0_r1_of_place_6) + k_r1_of_a_k*w3_dot_by_e1_dot_of_motion_2 -
    //   e0_h_bus_3_times_18
    let w3_dot_by_e1_dot_of_motion_3 = e2 * w3_dot_by_e0_of_place_2
        - w_S_3_by_e1_dot * w3_dot_by_e0_of_motion_5
        - w3_dot_by_e0_of_e0_e1_e2_e3
            * w_S_2_2_by_e1_dot.mul_add(b_times_6, r1_by_e1_dot_of_place_6)
        + w3_dot_by_e0_of_motion_2 * w_S_1_by_e1_dot.mul_add(a_times_6, -r1_by_e1_dot_of_place_8)
        + w_S_in_axle_base_1_of_
            * ((-w3_dot_of_motion)
                .mul_add(r1_by_e1_dot_of_place_4, w3_dot_by_e1_dot_of_place)
                - w3_dot_by_e1_dot_of_motion - e0_r1_of_place_6)
        + k_r1_of_a_k * w3_dot_by_e1_dot_of_motion_2 - e0_h_bus_3_times_18;
    // w3_dot_by_e1_dot = (2*K*(A + K)*(18*e0*H_bus_3 - 3*e2*(6*H_bus_1 - H_wheel_1 + H_wheel_2) -
    //   18*C*w_S_3_by_e1_dot*(e1*e0' - e0*e1' - e3*e2' + e2*e3') - 3*(e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(6*A*w_S_1_by_e1_dot - K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot) -
    //   3*(e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_2_2_by_e1_dot - 6*B*w_S_2_2_by_e1_dot -
    //   K*w_S_in_axle_base_1_2_by_e1_dot) - K*(3*e2*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) - 18*e3*H_bus_3 +
    //   18*C*w_S_3_by_e1_dot*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*B*w_S_2_by_e1_dot + K*w_S_in_axle_base_1_by_e1_dot - K*w_S_in_axle_base_2_by_e1_dot) +
    //   3*(e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e1_dot - 6*A*w_S_1_2_by_e1_dot -
    //   K*w_S_in_axle_base_2_2_by_e1_dot) + sqrt(3)*(e2*(H_wheel_1 + H_wheel_2 - H_wheel_3) -
    //   e3*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot +
    //   J*w_S_in_axle_base_3_by_e1_dot) + (e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot -
    //   2*J*w_S_in_axle_base_3_by_e1_dot) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e1_dot +
    //   K*w_S_in_axle_base_2_2_by_e1_dot)))/(3*A + 2*K) - sqrt(3)*((e0^2 + e1^2 + e2^2 +
    //   e3^2)*(K*w_S_in_axle_base_1_2_by_e1_dot + K*w_S_in_axle_base_2_2_by_e1_dot) - e0*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) - e2*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*(e0*e1' - e1*e0' + e3*e2' -
    //   e2*e3')*(K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot +
    //   J*w_S_in_axle_base_3_by_e1_dot) - (e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot -
    //   2*J*w_S_in_axle_base_3_by_e1_dot)))/((3*A + 2*K)*(3*B + K*(2 - K/(3*A + 2*K)))*(e0^2 + e1^2 + e2^2 +
    //   e3^2)) + 3*r1_by_e1_dot)/(3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A + K)^2/((3*A + 2*K)^2*(3*B + K*(2 -
    //   K/(3*A + 2*K)))))
    let w3_dot_by_e1_dot = w3_dot_of_a_b_c_k
        * (-w3_dot_by_e0_of_place_3)
            .mul_add(w3_dot_by_e1_dot_of_motion_3, S::int(3) * r1_by_e1_dot);
    // w2_dot_by_e1_dot = (9*K*w3_dot_by_e1_dot*(A + K)/(3*A + 2*K) - 2*(3*e2*(6*H_bus_1 - H_wheel_1 +
    //   H_wheel_2) - 18*e0*H_bus_3 + 18*C*w_S_3_by_e1_dot*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 3*(e2*e1' -
    //   e3*e0' - e1*e2' + e0*e3')*(6*A*w_S_1_by_e1_dot - K*w_S_in_axle_base_1_by_e1_dot +
    //   K*w_S_in_axle_base_2_by_e1_dot) + 3*(e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_2_2_by_e1_dot -
    //   6*B*w_S_2_2_by_e1_dot - K*w_S_in_axle_base_1_2_by_e1_dot) + K*(3*e2*(H_wheel_2 - 6*H_bus_2 -
    //   H_wheel_1) - 18*e3*H_bus_3 + 18*C*w_S_3_by_e1_dot*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' -
    //   e2*e1' + e1*e2' - e0*e3')*(6*B*w_S_2_by_e1_dot + K*w_S_in_axle_base_1_by_e1_dot -
    //   K*w_S_in_axle_base_2_by_e1_dot) + 3*(e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e1_dot -
    //   6*A*w_S_1_2_by_e1_dot - K*w_S_in_axle_base_2_2_by_e1_dot) + sqrt(3)*(e2*(H_wheel_1 + H_wheel_2 -
    //   H_wheel_3) - e3*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot +
    //   J*w_S_in_axle_base_3_by_e1_dot) + (e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot -
    //   2*J*w_S_in_axle_base_3_by_e1_dot) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e1_dot +
    //   K*w_S_in_axle_base_2_2_by_e1_dot)))/(3*A + 2*K) + sqrt(3)*((e0^2 + e1^2 + e2^2 +
    //   e3^2)*(K*w_S_in_axle_base_1_2_by_e1_dot + K*w_S_in_axle_base_2_2_by_e1_dot) - e0*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3) - e2*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*(e0*e1' - e1*e0' + e3*e2' -
    //   e2*e3')*(K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot +
    //   J*w_S_in_axle_base_3_by_e1_dot) - (e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot -
    //   2*J*w_S_in_axle_base_3_by_e1_dot)))/(e0^2 + e1^2 + e2^2 + e3^2))/(3*(3*B + K*(2 - K/(3*A + 2*K))))
    let w2_dot_by_e1_dot = w3_dot_of_a_b_k_by_3
        * (-w_S_1_by_e0_of_e0_e1_e2_e3)
            .mul_add(w3_dot_by_e1_dot_of_motion_3, w3_dot_by_e1_dot * w3_dot_of_a_k_2);
    // w3_dot_by_e1_dot + w2_dot_by_e1_dot
    let w1_dot_by_e1_dot_of_place = w3_dot_by_e1_dot + w2_dot_by_e1_dot;
    // w1_dot_by_e1_dot = (2*(18*e3*H_bus_3 - 3*e2*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) -
    //   18*C*w_S_3_by_e1_dot*(e0*e2' - e2*e0' - e3*e1' + e1*e3') - 3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*B*w_S_2_by_e1_dot + K*w_S_in_axle_base_1_by_e1_dot - K*w_S_in_axle_base_2_by_e1_dot) -
    //   3*(e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e1_dot - 6*A*w_S_1_2_by_e1_dot -
    //   K*w_S_in_axle_base_2_2_by_e1_dot) - sqrt(3)*(e2*(H_wheel_1 + H_wheel_2 - H_wheel_3) -
    //   e3*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) + 2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot +
    //   J*w_S_in_axle_base_3_by_e1_dot) + (e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e1_dot + K*w_S_in_axle_base_2_by_e1_dot -
    //   2*J*w_S_in_axle_base_3_by_e1_dot) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e1_dot +
    //   K*w_S_in_axle_base_2_2_by_e1_dot)))/(e0^2 + e1^2 + e2^2 + e3^2) + 3*K*(w3_dot_by_e1_dot +
    //   w2_dot_by_e1_dot))/(3*(3*A + 2*K))
    let w1_dot_by_e1_dot = r1_of_a_k_by_3
        * (-w_S_1_by_e0_of_e0_e1_e2_e3)
            .mul_add(
                w3_dot_by_e1_dot_of_motion_2,
                k_times_3 * w1_dot_by_e1_dot_of_place,
            );
    // s_dot_by_e1_dot = 4*w_S_in_axle_base_3_2_by_e1_dot/3 - sqrt(3)*(w3_dot_by_e1_dot + w2_dot_by_e1_dot
    //   + w1_dot_by_e1_dot)/3
    let s_dot_by_e1_dot = S::ratio(4, 3) * w_S_in_axle_base_3_2_by_e1_dot
        - s_dot_by_e0_of_ * (w1_dot_by_e1_dot + w1_dot_by_e1_dot_of_place);
    // e1*e0_ddot_by_e1_of_motion - e1'*(e0_sq + e3_sq_plus_e2_sq)
    let e0_ddot_by_e1_dot_of_motion = -e1_dot * (e0_sq + e3_sq_plus_e2_sq)
        + e1 * e0_ddot_by_e1_of_motion;
    // e0_ddot_by_e1_dot = 2*e0*(e1*(e0*e0' + e2*e2' + e3*e3') - e1'*(e0^2 + e2^2 + e3^2))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 - e3*w3_dot_by_e1_dot/2 - e2*w2_dot_by_e1_dot/2 - e1*w1_dot_by_e1_dot/2
    let e0_ddot_by_e1_dot = (-w1_dot_by_e1_dot)
        .mul_add(e1_halved, w3_dot_by_e0_of_e0_e1_e2_e3_3 * e0_ddot_by_e1_dot_of_motion)
        - w2_dot_by_e1_dot * e2_halved - w3_dot_by_e1_dot * e3_halved;
    // e1_ddot_by_e1_dot = 2*e1*(e1*(e0*e0' + e2*e2' + e3*e3') - e1'*(e0^2 + e2^2 + e3^2))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 + e2*w3_dot_by_e1_dot/2 - e3*w2_dot_by_e1_dot/2 + e0*w1_dot_by_e1_dot/2
    let e1_ddot_by_e1_dot = (-w2_dot_by_e1_dot)
        .mul_add(e3_halved, w3_dot_by_e1_dot * e2_halved) + w1_dot_by_e1_dot * e0_halved
        + e1_ddot_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e1_dot_of_motion;
    // e2_ddot_by_e1_dot = 2*e2*(e1*(e0*e0' + e2*e2' + e3*e3') - e1'*(e0^2 + e2^2 + e3^2))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 - e1*w3_dot_by_e1_dot/2 + e0*w2_dot_by_e1_dot/2 + e3*w1_dot_by_e1_dot/2
    let e2_ddot_by_e1_dot = (-w3_dot_by_e1_dot)
        .mul_add(e1_halved, w1_dot_by_e1_dot * e3_halved) + w2_dot_by_e1_dot * e0_halved
        + e2_ddot_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e1_dot_of_motion;
    // e3_ddot_by_e1_dot = 2*e3*(e1*(e0*e0' + e2*e2' + e3*e3') - e1'*(e0^2 + e2^2 + e3^2))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 + e0*w3_dot_by_e1_dot/2 + e1*w2_dot_by_e1_dot/2 - e2*w1_dot_by_e1_dot/2
    let e3_ddot_by_e1_dot = (-w1_dot_by_e1_dot)
        .mul_add(e2_halved, w2_dot_by_e1_dot * e1_halved) + w3_dot_by_e1_dot * e0_halved
        + e3_ddot_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e1_dot_of_motion;
    // w_S_2_by_e2_dot = e0/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_2_by_e2_dot = w_S_1_by_e1_dot;
    // w_S_3_by_e2_dot = -e1/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_3_by_e2_dot = minus_w_s_2_by_e3_dot;
    let e0_minus_e3_times_3 = S::int(3) * e0_minus_e3;
    // sqrt(3)*(e1_doubled + e0_plus_e3)
    let w_S_in_axle_base_1_by_e2_dot_of_e0_e1_e3 = w_S_in_axle_base_1_of_
        * (e1_doubled + e0_plus_e3);
    // w_S_in_axle_base_1_by_e2_dot = (3*e0 - 3*e3 - sqrt(3)*(e0 + 2*e1 + e3))/(2*(e0^2 + e1^2 + e2^2 +
    //   e3^2))
    let w_S_in_axle_base_1_by_e2_dot = w_S_in_axle_base_1_by_e0_dot_of_e0_e1_e2_e3
        * (e0_minus_e3_times_3 - w_S_in_axle_base_1_by_e2_dot_of_e0_e1_e3);
    // w_S_in_axle_base_2_by_e2_dot = (3*e3 - 3*e0 - sqrt(3)*(e0 + 2*e1 + e3))/(2*(e0^2 + e1^2 + e2^2 +
    //   e3^2))
    let w_S_in_axle_base_2_by_e2_dot = -w_S_in_axle_base_1_by_e0_dot_of_e0_e1_e2_e3
        * (e0_minus_e3_times_3 + w_S_in_axle_base_1_by_e2_dot_of_e0_e1_e3);
    // e0_plus_e3 - e1
    let minus_e1_plus_e0_plus_e3 = e0_plus_e3 - e1;
    // w_S_in_axle_base_3_by_e2_dot = sqrt(3)*(e0 - e1 + e3)/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_3_by_e2_dot = w_S_in_axle_base_3_of_e0_e1_e2_e3 * minus_e1_plus_e0_plus_e3;
    // w_S_1_2_by_e2_dot = (e3*(e0*e0' + e1*e1' + e3*e3') + e2*(e0*e1' - e1*e0' + 2*e3*e2' - e2*e3'))/(e0^2
    //   + e1^2 + e2^2 + e3^2)^2
    let w_S_1_2_by_e2_dot = w_S_1_2_of_e0_e1_e2_e3
        * (e2 * e3.mul_add(e2_dot_doubled, w_S_1_of_motion - e2_e3_dot)
            + e3 * e0_ddot_by_e2_of_motion);
    // 2*e2_e2_dot + e0_ddot_by_e2_of_motion
    let w_S_2_2_by_e2_dot_of_motion = e2_e2_dot
        .mul_add(S::int(2), e0_ddot_by_e2_of_motion);
    // w_S_2_2_by_e2_dot = (e2*(e1*e3' - e2*e0' - e3*e1') + e0*(e0*e0' + e1*e1' + 2*e2*e2' + e3*e3'))/(e0^2
    //   + e1^2 + e2^2 + e3^2)^2
    let w_S_2_2_by_e2_dot = w_S_1_2_of_e0_e1_e2_e3
        * (-e2 * (e2_e0_dot + w_S_2_of_motion_2) + e0 * w_S_2_2_by_e2_dot_of_motion);
    // w_S_3_2_by_e2_dot = -(e2*(e3*e0' - e2*e1' - e0*e3') + e1*(e0*e0' + e1*e1' + 2*e2*e2' +
    //   e3*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_3_2_by_e2_dot = w_S_1_2_of_e0_e1_e2_e3
        * (e2 * (w_S_3_of_motion + e2_e1_dot) - e1 * w_S_2_2_by_e2_dot_of_motion);
    let w_S_in_axle_base_1_2_by_e2_dot_of_motion = e1 * w_S_in_axle_base_1_2_by_e0_of_motion;
    // w_S_in_axle_base_1_2_by_e2_dot = 3*e2*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' -
    //   e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 3*e2*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/((3 +
    //   sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + e2*sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2 + 3*e0*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2
    //   + e3^2)^2) - e1*sqrt(3)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 +
    //   3*e3*(1/(3 + sqrt(3)) - 1)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_1_2_by_e2_dot = e2
        .mul_add(
            w_S_in_axle_base_1_2_by_e0_dot_of_motion, w_S_in_axle_base_2_2_by_e1_dot_of_motion,
        ) + w_S_in_axle_base_2_2_by_e1_dot_of_motion_2 - w_S_in_axle_base_1_2_by_e2_dot_of_motion;
    // w_S_in_axle_base_2_2_by_e2_dot = 3*e2*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/((3 + sqrt(3))*(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2) + 3*e2*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2
    //   + e2^2 + e3^2)^2 + e2*sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 +
    //   3*e0*(1/(3 + sqrt(3)) - 1)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 -
    //   e1*sqrt(3)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 3*e3*(e0*e0' + e1*e1'
    //   + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let w_S_in_axle_base_2_2_by_e2_dot = e2
        .mul_add(
            w_S_in_axle_base_2_2_by_e0_dot_of_motion, w_S_in_axle_base_1_2_by_e1_dot_of_motion_2,
        ) + w_S_in_axle_base_1_2_by_e1_dot_of_motion_3 - w_S_in_axle_base_1_2_by_e2_dot_of_motion;
    // e1' + e3'
    let e1_dot_plus_e3_dot = e1_dot + e3_dot;
    // e0' + e1'
    let e0_dot_plus_e1_dot = e0_dot + e1_dot;
    // w_S_in_axle_base_3_2_by_e2_dot = sqrt(3)*(e3^2*e3' + e2*(e0*(e1' + 2*e2' + e3') - e3*(e0' + e1' -
    //   2*e2') - e2*(e0' - e1' + e3') - e1*(e0' + 2*e2' - e3')) + e0*(e0'*(e0 - e1 + e3) + e1*e1' + e3*e3')
    //   - e1*(e1*e1' + e3*(e3' - e1')))/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_3_2_by_e2_dot = w_S_in_axle_base_3_2_by_e0_of_e0_e1_e2_e3
        * (e1 * e3.mul_add(e1_dot_minus_e3_dot, -e1_e1_dot) + e3_e3_e3_dot
            + e0 * e0_dot.mul_add(minus_e1_plus_e0_plus_e3, e1_e1_dot_plus_e3_e3_dot)
            + e2
                * (e0 * (e2_dot_doubled + e1_dot_plus_e3_dot)
                    - e1 * (e0_dot_minus_e3_dot + e2_dot_doubled)
                    - w_S_in_axle_base_3_by_e0_of_motion_10
                    - e3 * (e0_dot_plus_e1_dot - e2_dot_doubled)));
    // K*(w_S_in_axle_base_1_by_e2_dot + w_S_in_axle_base_2_by_e2_dot)
    let r1_by_e2_dot_of_place = K * (w_S_in_axle_base_1_by_e2_dot + w_S_in_axle_base_2_by_e2_dot);
    // r1_by_e2_dot_of_place - w_S_in_axle_base_3_by_e2_dot*j_doubled
    let r1_by_e2_dot_of_place_2 = (-w_S_in_axle_base_3_by_e2_dot)
        .mul_add(j_doubled, r1_by_e2_dot_of_place);
    // K*(w_S_in_axle_base_1_2_by_e2_dot + w_S_in_axle_base_2_2_by_e2_dot)
    let r1_by_e2_dot_of_place_3 = K
        * (w_S_in_axle_base_1_2_by_e2_dot + w_S_in_axle_base_2_2_by_e2_dot);
    // J*w_S_in_axle_base_3_by_e2_dot + r1_by_e2_dot_of_place
    let r1_by_e2_dot_of_place_4 = J
        .mul_add(w_S_in_axle_base_3_by_e2_dot, r1_by_e2_dot_of_place);
    // w_S_in_axle_base_1_by_e2_dot - w_S_in_axle_base_2_by_e2_dot
    let r1_by_e2_dot_of_place_5 = w_S_in_axle_base_1_by_e2_dot - w_S_in_axle_base_2_by_e2_dot;
    // K*(w_S_in_axle_base_1_2_by_e2_dot - w_S_in_axle_base_2_2_by_e2_dot)
    let r1_by_e2_dot_of_place_6 = K
        * (w_S_in_axle_base_1_2_by_e2_dot - w_S_in_axle_base_2_2_by_e2_dot);
    // w_S_1_2_by_e2_dot*a_times_6 - r1_by_e2_dot_of_place_6
    let r1_by_e2_dot_of_place_7 = w_S_1_2_by_e2_dot
        .mul_add(a_times_6, -r1_by_e2_dot_of_place_6);
    let r1_by_e2_dot_of_place_8 = K * r1_by_e2_dot_of_place_5;
    // w_S_2_by_e2_dot*b_times_6 + r1_by_e2_dot_of_place_8
    let r1_by_e2_dot_of_place_9 = w_S_2_by_e2_dot
        .mul_add(b_times_6, r1_by_e2_dot_of_place_8);
    // r1_by_e2_dot = 2*(18*e0*H_bus_1 - 18*e3*H_bus_2 - 3*H_wheel_1*(e0 + e3) + 3*H_wheel_2*(e0 + e3) +
    //   18*A*w_S_1_by_e2_dot*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 18*B*w_S_2_by_e2_dot*(e1*e0' - e0*e1' -
    //   e3*e2' + e2*e3') + 3*K*w_S_in_axle_base_1_by_e2_dot*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' +
    //   e3') + e1*(e0' - e3')) + 3*K*w_S_in_axle_base_2_by_e2_dot*(e0*(e1' + e2') - e3*(e1' - e2') - e2*(e0'
    //   + e3') - e1*(e0' - e3')) + 18*C*w_S_3_2_by_e2_dot*(e0^2 + e1^2 + e2^2 + e3^2) +
    //   3*K*(e2*(6*C*e0'*w_S_3_by_e2_dot + e1'*(6*B*w_S_2_by_e2_dot + K*w_S_in_axle_base_1_by_e2_dot -
    //   K*w_S_in_axle_base_2_by_e2_dot) + e2*(6*A*w_S_1_2_by_e2_dot - K*w_S_in_axle_base_1_2_by_e2_dot +
    //   K*w_S_in_axle_base_2_2_by_e2_dot)) - e0*(6*H_bus_3 + 6*C*e2'*w_S_3_by_e2_dot +
    //   e3'*(K*w_S_in_axle_base_2_by_e2_dot - 6*B*w_S_2_by_e2_dot - K*w_S_in_axle_base_1_by_e2_dot) +
    //   e0*(K*w_S_in_axle_base_1_2_by_e2_dot - 6*A*w_S_1_2_by_e2_dot - K*w_S_in_axle_base_2_2_by_e2_dot)) -
    //   e1*(6*H_bus_2 + H_wheel_1 - H_wheel_2 + 6*C*e3'*w_S_3_by_e2_dot + e2'*(6*B*w_S_2_by_e2_dot +
    //   K*w_S_in_axle_base_1_by_e2_dot - K*w_S_in_axle_base_2_by_e2_dot) +
    //   e1*(K*w_S_in_axle_base_1_2_by_e2_dot - 6*A*w_S_1_2_by_e2_dot - K*w_S_in_axle_base_2_2_by_e2_dot)) +
    //   e3*(6*C*e1'*w_S_3_by_e2_dot + e0'*(K*w_S_in_axle_base_2_by_e2_dot - 6*B*w_S_2_by_e2_dot -
    //   K*w_S_in_axle_base_1_by_e2_dot) + e3*(6*A*w_S_1_2_by_e2_dot - K*w_S_in_axle_base_1_2_by_e2_dot +
    //   K*w_S_in_axle_base_2_2_by_e2_dot)))/(3*A + 2*K) - sqrt(3)*(e0*(H_wheel_1 + H_wheel_2 - H_wheel_3 +
    //   e1'*(2*J*w_S_in_axle_base_3_by_e2_dot - K*w_S_in_axle_base_1_by_e2_dot -
    //   K*w_S_in_axle_base_2_by_e2_dot) + e2'*(K*w_S_in_axle_base_1_by_e2_dot +
    //   K*w_S_in_axle_base_2_by_e2_dot - 2*J*w_S_in_axle_base_3_by_e2_dot) -
    //   2*e0*(K*w_S_in_axle_base_1_2_by_e2_dot + K*w_S_in_axle_base_2_2_by_e2_dot)) +
    //   e1*(e0'*(K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot -
    //   2*J*w_S_in_axle_base_3_by_e2_dot) + e3'*(K*w_S_in_axle_base_1_by_e2_dot +
    //   K*w_S_in_axle_base_2_by_e2_dot - 2*J*w_S_in_axle_base_3_by_e2_dot) -
    //   2*e1*(K*w_S_in_axle_base_1_2_by_e2_dot + K*w_S_in_axle_base_2_2_by_e2_dot)) +
    //   e2*(e0'*(2*J*w_S_in_axle_base_3_by_e2_dot - K*w_S_in_axle_base_1_by_e2_dot -
    //   K*w_S_in_axle_base_2_by_e2_dot) + e3'*(K*w_S_in_axle_base_1_by_e2_dot +
    //   K*w_S_in_axle_base_2_by_e2_dot - 2*J*w_S_in_axle_base_3_by_e2_dot) -
    //   2*e2*(K*w_S_in_axle_base_1_2_by_e2_dot + K*w_S_in_axle_base_2_2_by_e2_dot)) + e3*(H_wheel_3 -
    //   H_wheel_1 - H_wheel_2 - e1'*(K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot -
    //   2*J*w_S_in_axle_base_3_by_e2_dot) - e2'*(K*w_S_in_axle_base_1_by_e2_dot +
    //   K*w_S_in_axle_base_2_by_e2_dot - 2*J*w_S_in_axle_base_3_by_e2_dot) -
    //   2*e3*(K*w_S_in_axle_base_1_2_by_e2_dot + K*w_S_in_axle_base_2_2_by_e2_dot)) + K*(e0*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3 + 2*e2'*(K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot +
    //   J*w_S_in_axle_base_3_by_e2_dot) + e3'*(K*w_S_in_axle_base_1_by_e2_dot +
    //   K*w_S_in_axle_base_2_by_e2_dot - 2*J*w_S_in_axle_base_3_by_e2_dot) +
    //   e0*(K*w_S_in_axle_base_1_2_by_e2_dot + K*w_S_in_axle_base_2_2_by_e2_dot)) + e1*(H_wheel_3 -
    //   H_wheel_1 - H_wheel_2 + 2*e3'*(K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot +
    //   J*w_S_in_axle_base_3_by_e2_dot) - e2'*(K*w_S_in_axle_base_1_by_e2_dot +
    //   K*w_S_in_axle_base_2_by_e2_dot - 2*J*w_S_in_axle_base_3_by_e2_dot) +
    //   e1*(K*w_S_in_axle_base_1_2_by_e2_dot + K*w_S_in_axle_base_2_2_by_e2_dot)) +
    //   e2*(e2*(K*w_S_in_axle_base_1_2_by_e2_dot + K*w_S_in_axle_base_2_2_by_e2_dot) -
    //   2*e0'*(K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot +
    //   J*w_S_in_axle_base_3_by_e2_dot) - e1'*(2*J*w_S_in_axle_base_3_by_e2_dot -
    //   K*w_S_in_axle_base_1_by_e2_dot - K*w_S_in_axle_base_2_by_e2_dot)) +
    //   e3*(e3*(K*w_S_in_axle_base_1_2_by_e2_dot + K*w_S_in_axle_base_2_2_by_e2_dot) -
    //   2*e1'*(K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot +
    //   J*w_S_in_axle_base_3_by_e2_dot) - e0'*(K*w_S_in_axle_base_1_by_e2_dot +
    //   K*w_S_in_axle_base_2_by_e2_dot - 2*J*w_S_in_axle_base_3_by_e2_dot)))/(3*A + 2*K)))/(9*(e0^2 + e1^2 +
    //   e2^2 + e3^2))
    let r1_by_e2_dot = r1_by_e0_dot_of_e0_e1_e2_e3
        * (e0 * h_bus_1_times_18 - e3 * h_bus_2_times_18
            + w_S_3_2_by_e2_dot * r1_by_e0_dot_of_place_10
            + w_S_1_by_e2_dot * r1_by_e0_dot_of_motion_2
            - w_S_2_by_e2_dot * r1_by_e0_dot_of_motion_3 - r1_of_place_7_times_3 * e0_plus_e3
            + w_S_in_axle_base_1_of_
                * (e1
                    * (-e0_dot_plus_e3_dot)
                        .mul_add(
                            r1_by_e2_dot_of_place_2,
                            e1_doubled * r1_by_e2_dot_of_place_3,
                        )
                    + e0
                        * (e1_dot_minus_e2_dot
                            .mul_add(r1_by_e2_dot_of_place_2, r1_of_place_3)
                            + e0_doubled * r1_by_e2_dot_of_place_3)
                    + e2
                        * e2_doubled
                            .mul_add(
                                r1_by_e2_dot_of_place_3,
                                e0_dot_minus_e3_dot * r1_by_e2_dot_of_place_2,
                            )
                    + e3
                        * (e1_dot_plus_e2_dot
                            .mul_add(r1_by_e2_dot_of_place_2, -r1_of_place_3)
                            + e3_doubled * r1_by_e2_dot_of_place_3)
                    - k_r1_of_a_k
                        * (e0
                            * (e3_dot.mul_add(r1_by_e2_dot_of_place_2, r1_of_place_6)
                                + e0 * r1_by_e2_dot_of_place_3
                                + e2_dot_doubled * r1_by_e2_dot_of_place_4)
                            + e1
                                * ((-e2_dot).mul_add(r1_by_e2_dot_of_place_2, r1_of_place_3)
                                    + e1 * r1_by_e2_dot_of_place_3
                                    + e3_dot_doubled * r1_by_e2_dot_of_place_4)
                            + e2
                                * (e2
                                    .mul_add(
                                        r1_by_e2_dot_of_place_3,
                                        e1_dot * r1_by_e2_dot_of_place_2,
                                    ) - e0_dot_doubled * r1_by_e2_dot_of_place_4)
                            + e3
                                * ((-e0_dot)
                                    .mul_add(
                                        r1_by_e2_dot_of_place_2,
                                        e3 * r1_by_e2_dot_of_place_3,
                                    ) - e1_dot_doubled * r1_by_e2_dot_of_place_4)))
            + r1_by_e0_dot_of_motion * r1_by_e2_dot_of_place_5
            + k_r1_of_a_k_times_3
                * (e2
                    * (e2
                        .mul_add(
                            r1_by_e2_dot_of_place_7,
                            w_S_3_by_e2_dot * e0_dot_c_times_6,
                        ) + e1_dot * r1_by_e2_dot_of_place_9)
                    - e0
                        * (w_S_3_by_e2_dot.mul_add(e2_dot_c_times_6, h_bus_3_times_6)
                            - e0 * r1_by_e2_dot_of_place_7 - e3_dot * r1_by_e2_dot_of_place_9)
                    - e1
                        * (w_S_3_by_e2_dot.mul_add(e3_dot_c_times_6, r1_of_place_10)
                            - e1 * r1_by_e2_dot_of_place_7 + e2_dot * r1_by_e2_dot_of_place_9)
                    - e3
                        * ((-w_S_3_by_e2_dot)
                            .mul_add(e1_dot_c_times_6, e0_dot * r1_by_e2_dot_of_place_9)
                            - e3 * r1_by_e2_dot_of_place_7)));
    // e1*minus_r1_of_place_3 - w_S_3_of_motion_3*r1_by_e2_dot_of_place_2
    let w3_dot_by_e2_dot_of_motion = (-w_S_3_of_motion_3)
        .mul_add(r1_by_e2_dot_of_place_2, e1 * minus_r1_of_place_3);
    let w3_dot_by_e2_dot_of_place = w_S_1_of_e0_e1_e2_e3 * r1_by_e2_dot_of_place_3;
    // e1*r1_of_place_10_times_3 + w_S_3_by_e2_dot*w3_dot_by_e0_of_motion_3 + e0_h_bus_3_times_18 -
    //   w3_dot_by_e0_of_e0_e1_e2_e3*r1_by_e2_dot_of_place_7 -
    //   w3_dot_by_e0_of_motion_2*r1_by_e2_dot_of_place_9 + sqrt(3)*(e0_r1_of_place_6 +
    //   w3_dot_of_motion_3*r1_by_e2_dot_of_place_4 - w3_dot_by_e2_dot_of_motion + w3_dot_by_e2_dot_of_place)
    let w3_dot_by_e2_dot_of_motion_2 = e1 * r1_of_place_10_times_3
        + w_S_3_by_e2_dot * w3_dot_by_e0_of_motion_3 + e0_h_bus_3_times_18
        - w3_dot_by_e0_of_e0_e1_e2_e3 * r1_by_e2_dot_of_place_7
        - w3_dot_by_e0_of_motion_2 * r1_by_e2_dot_of_place_9
        + w_S_in_axle_base_1_of_
            * (w3_dot_of_motion_3.mul_add(r1_by_e2_dot_of_place_4, e0_r1_of_place_6)
                - w3_dot_by_e2_dot_of_motion + w3_dot_by_e2_dot_of_place);
    // e1*w3_dot_by_e0_of_place_2 + w_S_3_by_e2_dot*w3_dot_by_e0_of_motion_5 + e3_h_bus_3_times_18 +
    //   w3_dot_by_e0_of_e0_e1_e2_e3*(w_S_2_2_by_e2_dot*b_times_6 + r1_by_e2_dot_of_place_6) +
    //   w3_dot_by_e0_of_motion_2*(r1_by_e2_dot_of_place_8 - w_S_1_by_e2_dot*a_times_6) +
    //   sqrt(3)*(e3_r1_of_place_6 + w3_dot_of_motion*r1_by_e2_dot_of_place_4 - w3_dot_by_e2_dot_of_motion -
    //   w3_dot_by_e2_dot_of_place) - k_r1_of_a_k*w3_dot_by_e2_dot_of_motion_2
    let w3_dot_by_e2_dot_of_motion_3 = e1 * w3_dot_by_e0_of_place_2
        + w_S_3_by_e2_dot * w3_dot_by_e0_of_motion_5 + e3_h_bus_3_times_18
        + w3_dot_by_e0_of_e0_e1_e2_e3
            * w_S_2_2_by_e2_dot.mul_add(b_times_6, r1_by_e2_dot_of_place_6)
        + w3_dot_by_e0_of_motion_2 * (-w_S_1_by_e2_dot).mul_add(a_times_6, r1_by_e2_dot_of_place_8)
        + w_S_in_axle_base_1_of_
            * (w3_dot_of_motion.mul_add(r1_by_e2_dot_of_place_4, e3_r1_of_place_6)
                - w3_dot_by_e2_dot_of_motion - w3_dot_by_e2_dot_of_place)
        - k_r1_of_a_k * w3_dot_by_e2_dot_of_motion_2;
    // w3_dot_by_e2_dot = (2*K*(A + K)*(18*e3*H_bus_3 + 3*e1*(6*H_bus_1 - H_wheel_1 + H_wheel_2) +
    //   18*C*w_S_3_by_e2_dot*(e0*e1' - e1*e0' + e3*e2' - e2*e3') + 3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*A*w_S_1_by_e2_dot - K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot) +
    //   3*(e0^2 + e1^2 + e2^2 + e3^2)*(6*B*w_S_2_2_by_e2_dot + K*w_S_in_axle_base_1_2_by_e2_dot -
    //   K*w_S_in_axle_base_2_2_by_e2_dot) - K*(18*e0*H_bus_3 + 3*e1*(6*H_bus_2 + H_wheel_1 - H_wheel_2) +
    //   18*C*w_S_3_by_e2_dot*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*B*w_S_2_by_e2_dot + K*w_S_in_axle_base_1_by_e2_dot - K*w_S_in_axle_base_2_by_e2_dot) +
    //   3*(e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e2_dot - 6*A*w_S_1_2_by_e2_dot -
    //   K*w_S_in_axle_base_2_2_by_e2_dot) + sqrt(3)*(e0*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) -
    //   e1*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*(e2*e0' - e0*e2' + e3*e1' -
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot +
    //   J*w_S_in_axle_base_3_by_e2_dot) - (e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot -
    //   2*J*w_S_in_axle_base_3_by_e2_dot) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e2_dot +
    //   K*w_S_in_axle_base_2_2_by_e2_dot)))/(3*A + 2*K) + sqrt(3)*(e3*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) - e1*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3')*(K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot +
    //   J*w_S_in_axle_base_3_by_e2_dot) - (e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot -
    //   2*J*w_S_in_axle_base_3_by_e2_dot) - (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e2_dot +
    //   K*w_S_in_axle_base_2_2_by_e2_dot)))/((3*A + 2*K)*(3*B + K*(2 - K/(3*A + 2*K)))*(e0^2 + e1^2 + e2^2 +
    //   e3^2)) + 3*r1_by_e2_dot)/(3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A + K)^2/((3*A + 2*K)^2*(3*B + K*(2 -
    //   K/(3*A + 2*K)))))
    let w3_dot_by_e2_dot = w3_dot_of_a_b_c_k
        * w3_dot_by_e0_of_place_3
            .mul_add(w3_dot_by_e2_dot_of_motion_3, S::int(3) * r1_by_e2_dot);
    // w2_dot_by_e2_dot = (2*(18*e3*H_bus_3 + 3*e1*(6*H_bus_1 - H_wheel_1 + H_wheel_2) +
    //   18*C*w_S_3_by_e2_dot*(e0*e1' - e1*e0' + e3*e2' - e2*e3') + 3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*A*w_S_1_by_e2_dot - K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot) +
    //   3*(e0^2 + e1^2 + e2^2 + e3^2)*(6*B*w_S_2_2_by_e2_dot + K*w_S_in_axle_base_1_2_by_e2_dot -
    //   K*w_S_in_axle_base_2_2_by_e2_dot) - K*(18*e0*H_bus_3 + 3*e1*(6*H_bus_2 + H_wheel_1 - H_wheel_2) +
    //   18*C*w_S_3_by_e2_dot*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*B*w_S_2_by_e2_dot + K*w_S_in_axle_base_1_by_e2_dot - K*w_S_in_axle_base_2_by_e2_dot) +
    //   3*(e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e2_dot - 6*A*w_S_1_2_by_e2_dot -
    //   K*w_S_in_axle_base_2_2_by_e2_dot) + sqrt(3)*(e0*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) -
    //   e1*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*(e2*e0' - e0*e2' + e3*e1' -
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot +
    //   J*w_S_in_axle_base_3_by_e2_dot) - (e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot -
    //   2*J*w_S_in_axle_base_3_by_e2_dot) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e2_dot +
    //   K*w_S_in_axle_base_2_2_by_e2_dot)))/(3*A + 2*K) + sqrt(3)*(e3*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) - e1*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3')*(K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot +
    //   J*w_S_in_axle_base_3_by_e2_dot) - (e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot -
    //   2*J*w_S_in_axle_base_3_by_e2_dot) - (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e2_dot +
    //   K*w_S_in_axle_base_2_2_by_e2_dot)))/(e0^2 + e1^2 + e2^2 + e3^2) + 9*K*w3_dot_by_e2_dot*(A + K)/(3*A
    //   + 2*K))/(3*(3*B + K*(2 - K/(3*A + 2*K))))
    let w2_dot_by_e2_dot = w3_dot_of_a_b_k_by_3
        * w_S_1_by_e0_of_e0_e1_e2_e3
            .mul_add(w3_dot_by_e2_dot_of_motion_3, w3_dot_by_e2_dot * w3_dot_of_a_k_2);
    // w3_dot_by_e2_dot + w2_dot_by_e2_dot
    let w1_dot_by_e2_dot_of_place = w3_dot_by_e2_dot + w2_dot_by_e2_dot;
    // w1_dot_by_e2_dot = (3*K*(w3_dot_by_e2_dot + w2_dot_by_e2_dot) - 2*(18*e0*H_bus_3 + 3*e1*(6*H_bus_2 +
    //   H_wheel_1 - H_wheel_2) + 18*C*w_S_3_by_e2_dot*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' -
    //   e2*e1' + e1*e2' - e0*e3')*(6*B*w_S_2_by_e2_dot + K*w_S_in_axle_base_1_by_e2_dot -
    //   K*w_S_in_axle_base_2_by_e2_dot) + 3*(e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e2_dot -
    //   6*A*w_S_1_2_by_e2_dot - K*w_S_in_axle_base_2_2_by_e2_dot) + sqrt(3)*(e0*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) - e1*(H_wheel_1 + H_wheel_2 - H_wheel_3) - 2*(e2*e0' - e0*e2' + e3*e1' -
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot +
    //   J*w_S_in_axle_base_3_by_e2_dot) - (e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e2_dot + K*w_S_in_axle_base_2_by_e2_dot -
    //   2*J*w_S_in_axle_base_3_by_e2_dot) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e2_dot +
    //   K*w_S_in_axle_base_2_2_by_e2_dot)))/(e0^2 + e1^2 + e2^2 + e3^2))/(3*(3*A + 2*K))
    let w1_dot_by_e2_dot = r1_of_a_k_by_3
        * (-w_S_1_by_e0_of_e0_e1_e2_e3)
            .mul_add(
                w3_dot_by_e2_dot_of_motion_2,
                k_times_3 * w1_dot_by_e2_dot_of_place,
            );
    // s_dot_by_e2_dot = 4*w_S_in_axle_base_3_2_by_e2_dot/3 - sqrt(3)*(w3_dot_by_e2_dot + w2_dot_by_e2_dot
    //   + w1_dot_by_e2_dot)/3
    let s_dot_by_e2_dot = S::ratio(4, 3) * w_S_in_axle_base_3_2_by_e2_dot
        - s_dot_by_e0_of_ * (w1_dot_by_e2_dot + w1_dot_by_e2_dot_of_place);
    // e2*e0_ddot_by_e2_of_motion - e2'*(e0_sq_plus_e1_sq + e3_sq)
    let e0_ddot_by_e2_dot_of_motion = -e2_dot * (e0_sq_plus_e1_sq + e3_sq)
        + e2 * e0_ddot_by_e2_of_motion;
    // e0_ddot_by_e2_dot = 2*e0*(e2*(e0*e0' + e1*e1' + e3*e3') - e2'*(e0^2 + e1^2 + e3^2))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 - e3*w3_dot_by_e2_dot/2 - e2*w2_dot_by_e2_dot/2 - e1*w1_dot_by_e2_dot/2
    let e0_ddot_by_e2_dot = (-w1_dot_by_e2_dot)
        .mul_add(e1_halved, w3_dot_by_e0_of_e0_e1_e2_e3_3 * e0_ddot_by_e2_dot_of_motion)
        - w2_dot_by_e2_dot * e2_halved - w3_dot_by_e2_dot * e3_halved;
    // e1_ddot_by_e2_dot = 2*e1*(e2*(e0*e0' + e1*e1' + e3*e3') - e2'*(e0^2 + e1^2 + e3^2))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 + e2*w3_dot_by_e2_dot/2 - e3*w2_dot_by_e2_dot/2 + e0*w1_dot_by_e2_dot/2
    let e1_ddot_by_e2_dot = (-w2_dot_by_e2_dot)
        .mul_add(e3_halved, w3_dot_by_e2_dot * e2_halved) + w1_dot_by_e2_dot * e0_halved
        + e1_ddot_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e2_dot_of_motion;
    // e2_ddot_by_e2_dot = 2*e2*(e2*(e0*e0' + e1*e1' + e3*e3') - e2'*(e0^2 + e1^2 + e3^2))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 - e1*w3_dot_by_e2_dot/2 + e0*w2_dot_by_e2_dot/2 + e3*w1_dot_by_e2_dot/2
    let e2_ddot_by_e2_dot = (-w3_dot_by_e2_dot)
        .mul_add(e1_halved, w1_dot_by_e2_dot * e3_halved) + w2_dot_by_e2_dot * e0_halved
        + e2_ddot_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e2_dot_of_motion;
    // e3_ddot_by_e2_dot = 2*e3*(e2*(e0*e0' + e1*e1' + e3*e3') - e2'*(e0^2 + e1^2 + e3^2))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 + e0*w3_dot_by_e2_dot/2 + e1*w2_dot_by_e2_dot/2 - e2*w1_dot_by_e2_dot/2
    let e3_ddot_by_e2_dot = (-w1_dot_by_e2_dot)
        .mul_add(e2_halved, w2_dot_by_e2_dot * e1_halved) + w3_dot_by_e2_dot * e0_halved
        + e3_ddot_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e2_dot_of_motion;
    // w_S_1_by_e3_dot = -e2/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_1_by_e3_dot = minus_w_s_3_by_e1_dot;
    // w_S_3_by_e3_dot = e0/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_3_by_e3_dot = w_S_1_by_e1_dot;
    let e1_plus_e2_times_3 = S::int(3) * e1_plus_e2;
    // sqrt(3)*(e0_doubled - e1_minus_e2)
    let w_S_in_axle_base_1_by_e3_dot_of_e0_e1_e2 = w_S_in_axle_base_1_of_
        * (e0_doubled - e1_minus_e2);
    // w_S_in_axle_base_1_by_e3_dot = (3*e1 + 3*e2 + sqrt(3)*(2*e0 - e1 + e2))/(2*(e0^2 + e1^2 + e2^2 +
    //   e3^2))
    let w_S_in_axle_base_1_by_e3_dot = w_S_in_axle_base_1_by_e0_dot_of_e0_e1_e2_e3
        * (e1_plus_e2_times_3 + w_S_in_axle_base_1_by_e3_dot_of_e0_e1_e2);
    // w_S_in_axle_base_2_by_e3_dot = -(3*e1 + 3*e2 + sqrt(3)*(e1 - 2*e0 - e2))/(2*(e0^2 + e1^2 + e2^2 +
    //   e3^2))
    let w_S_in_axle_base_2_by_e3_dot = w_S_in_axle_base_1_by_e0_dot_of_e0_e1_e2_e3
        * (w_S_in_axle_base_1_by_e3_dot_of_e0_e1_e2 - e1_plus_e2_times_3);
    // e0 + e1_minus_e2
    let e0_plus_e1_minus_e2 = e0 + e1_minus_e2;
    // w_S_in_axle_base_3_by_e3_dot = sqrt(3)*(e0 + e1 - e2)/(e0^2 + e1^2 + e2^2 + e3^2)
    let w_S_in_axle_base_3_by_e3_dot = w_S_in_axle_base_3_of_e0_e1_e2_e3 * e0_plus_e1_minus_e2;
    // 2*e3_e3_dot + e0_ddot_by_e3_of_motion
    let w_S_1_2_by_e3_dot_of_motion = e3_e3_dot
        .mul_add(S::int(2), e0_ddot_by_e3_of_motion);
    // w_S_1_2_by_e3_dot = -(e3*(e1*e0' - e0*e1' - e3*e2') + e2*(e0*e0' + e1*e1' + e2*e2' +
    //   2*e3*e3'))/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_1_2_by_e3_dot = w_S_1_2_of_e0_e1_e2_e3
        * (e3 * (w_S_1_of_motion + e3_e2_dot) - e2 * w_S_1_2_by_e3_dot_of_motion);
    // w_S_2_2_by_e3_dot = (e3*(e0*e2' - e2*e0' - e3*e1') + e1*(e0*e0' + e1*e1' + e2*e2' + 2*e3*e3'))/(e0^2
    //   + e1^2 + e2^2 + e3^2)^2
    let w_S_2_2_by_e3_dot = w_S_1_2_of_e0_e1_e2_e3
        * (e3 * (w_S_2_of_motion - e3_e1_dot) + e1 * w_S_1_2_by_e3_dot_of_motion);
    // w_S_3_2_by_e3_dot = (e3*(e2*e1' - e3*e0' - e1*e2') + e0*(e0*e0' + e1*e1' + e2*e2' + 2*e3*e3'))/(e0^2
    //   + e1^2 + e2^2 + e3^2)^2
    let w_S_3_2_by_e3_dot = w_S_1_2_of_e0_e1_e2_e3
        * (e3 * (w_S_3_of_motion_2 - e3_e0_dot) + e0 * w_S_1_2_by_e3_dot_of_motion);
    let w_S_in_axle_base_1_2_by_e3_dot_of_motion = e0 * w_S_in_axle_base_1_2_by_e0_of_motion;
    // w_S_in_axle_base_1_2_by_e3_dot = 3*e3*(1/(3 + sqrt(3)) - 1)*(e0*e1' - e1*e0' + e3*e2' -
    //   e2*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 3*e3*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/((3 +
    //   sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + e3*sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2 + e0*sqrt(3)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
    //   + 3*e1*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2) + 3*e2*(1 -
    //   1/(3 + sqrt(3)))*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_1_2_by_e3_dot = e3
        .mul_add(
            w_S_in_axle_base_1_2_by_e0_dot_of_motion, -w_S_in_axle_base_2_2_by_e0_dot_of_motion_2,
        ) + w_S_in_axle_base_2_2_by_e0_dot_of_motion_3 + w_S_in_axle_base_1_2_by_e3_dot_of_motion;
    // w_S_in_axle_base_2_2_by_e3_dot = 3*e3*(e0*e1' - e1*e0' + e3*e2' - e2*e3')/((3 + sqrt(3))*(e0^2 +
    //   e1^2 + e2^2 + e3^2)^2) + 3*e3*(1/(3 + sqrt(3)) - 1)*(e0*e2' - e2*e0' - e3*e1' + e1*e3')/(e0^2 + e1^2
    //   + e2^2 + e3^2)^2 + e3*sqrt(3)*(e2*e1' - e3*e0' - e1*e2' + e0*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 +
    //   e0*sqrt(3)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 + 3*e1*(1/(3 + sqrt(3))
    //   - 1)*(e0*e0' + e1*e1' + e2*e2' + e3*e3')/(e0^2 + e1^2 + e2^2 + e3^2)^2 - 3*e2*(e0*e0' + e1*e1' +
    //   e2*e2' + e3*e3')/((3 + sqrt(3))*(e0^2 + e1^2 + e2^2 + e3^2)^2)
    let w_S_in_axle_base_2_2_by_e3_dot = e3
        .mul_add(
            w_S_in_axle_base_2_2_by_e0_dot_of_motion,
            w_S_in_axle_base_1_2_by_e0_dot_of_motion_3 - w_S_in_axle_base_1_2_by_e0_dot_of_motion_4,
        ) + w_S_in_axle_base_1_2_by_e3_dot_of_motion;
    // e0' + e2'
    let e0_dot_plus_e2_dot = e0_dot + e2_dot;
    // e1' - e0'
    let minus_e0_dot_plus_e1_dot = e1_dot - e0_dot;
    // w_S_in_axle_base_3_2_by_e3_dot = sqrt(3)*(e1*(e1*e1' + e2*(e2' - e1')) - e2^2*e2' + e0*(e0'*(e0 + e1
    //   - e2) + e1*e1' + e2*e2') - e3*(e3*(e0' + e1' - e2') - e0*(e1' + e2' + 2*e3') + e1*(e0' + e2' -
    //   2*e3') + e2*(e0' - e1' + 2*e3')))/(e0^2 + e1^2 + e2^2 + e3^2)^2
    let w_S_in_axle_base_3_2_by_e3_dot = w_S_in_axle_base_3_2_by_e0_of_e0_e1_e2_e3
        * (e1 * (-e2).mul_add(e1_dot_minus_e2_dot, e1_e1_dot) - e2 * e2_e2_dot
            + e0 * e0_dot.mul_add(e0_plus_e1_minus_e2, e1_e1_dot_plus_e2_e2_dot)
            + e3
                * (e0 * (e1_dot_plus_e2_dot + e3_dot_doubled) - w_S_in_axle_base_3_by_e0_of_motion_7
                    - e1 * (e0_dot_plus_e2_dot - e3_dot_doubled)
                    - e2 * (e3_dot_doubled - minus_e0_dot_plus_e1_dot)));
    // K*(w_S_in_axle_base_1_by_e3_dot + w_S_in_axle_base_2_by_e3_dot)
    let r1_by_e3_dot_of_place = K * (w_S_in_axle_base_1_by_e3_dot + w_S_in_axle_base_2_by_e3_dot);
    // r1_by_e3_dot_of_place - w_S_in_axle_base_3_by_e3_dot*j_doubled
    let r1_by_e3_dot_of_place_2 = (-w_S_in_axle_base_3_by_e3_dot)
        .mul_add(j_doubled, r1_by_e3_dot_of_place);
    // K*(w_S_in_axle_base_1_2_by_e3_dot + w_S_in_axle_base_2_2_by_e3_dot)
    let r1_by_e3_dot_of_place_3 = K
        * (w_S_in_axle_base_1_2_by_e3_dot + w_S_in_axle_base_2_2_by_e3_dot);
    // J*w_S_in_axle_base_3_by_e3_dot + r1_by_e3_dot_of_place
    let r1_by_e3_dot_of_place_4 = J
        .mul_add(w_S_in_axle_base_3_by_e3_dot, r1_by_e3_dot_of_place);
    // w_S_in_axle_base_1_by_e3_dot - w_S_in_axle_base_2_by_e3_dot
    let r1_by_e3_dot_of_place_5 = w_S_in_axle_base_1_by_e3_dot - w_S_in_axle_base_2_by_e3_dot;
    // K*(w_S_in_axle_base_1_2_by_e3_dot - w_S_in_axle_base_2_2_by_e3_dot)
    let r1_by_e3_dot_of_place_6 = K
        * (w_S_in_axle_base_1_2_by_e3_dot - w_S_in_axle_base_2_2_by_e3_dot);
    // w_S_1_2_by_e3_dot*a_times_6 - r1_by_e3_dot_of_place_6
    let r1_by_e3_dot_of_place_7 = w_S_1_2_by_e3_dot
        .mul_add(a_times_6, -r1_by_e3_dot_of_place_6);
    let r1_by_e3_dot_of_place_8 = K * r1_by_e3_dot_of_place_5;
    // w_S_2_by_e3_dot*b_times_6 + r1_by_e3_dot_of_place_8
    let r1_by_e3_dot_of_place_9 = w_S_2_by_e3_dot
        .mul_add(b_times_6, r1_by_e3_dot_of_place_8);
    // r1_by_e3_dot = 2*(18*e1*H_bus_1 + 18*e2*H_bus_2 + 3*H_wheel_1*(e2 - e1) + 3*H_wheel_2*(e1 - e2) +
    //   18*A*w_S_1_by_e3_dot*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 18*B*w_S_2_by_e3_dot*(e1*e0' - e0*e1' -
    //   e3*e2' + e2*e3') + 3*K*w_S_in_axle_base_1_by_e3_dot*(e3*(e1' - e2') - e0*(e1' + e2') + e2*(e0' +
    //   e3') + e1*(e0' - e3')) + 3*K*w_S_in_axle_base_2_by_e3_dot*(e0*(e1' + e2') - e3*(e1' - e2') - e2*(e0'
    //   + e3') - e1*(e0' - e3')) + 18*C*w_S_3_2_by_e3_dot*(e0^2 + e1^2 + e2^2 + e3^2) +
    //   sqrt(3)*(e0*(e1'*(K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot -
    //   2*J*w_S_in_axle_base_3_by_e3_dot) + e2'*(2*J*w_S_in_axle_base_3_by_e3_dot -
    //   K*w_S_in_axle_base_1_by_e3_dot - K*w_S_in_axle_base_2_by_e3_dot) +
    //   2*e0*(K*w_S_in_axle_base_1_2_by_e3_dot + K*w_S_in_axle_base_2_2_by_e3_dot)) + e1*(H_wheel_3 -
    //   H_wheel_1 - H_wheel_2 - e0'*(K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot -
    //   2*J*w_S_in_axle_base_3_by_e3_dot) - e3'*(K*w_S_in_axle_base_1_by_e3_dot +
    //   K*w_S_in_axle_base_2_by_e3_dot - 2*J*w_S_in_axle_base_3_by_e3_dot) +
    //   2*e1*(K*w_S_in_axle_base_1_2_by_e3_dot + K*w_S_in_axle_base_2_2_by_e3_dot)) + e2*(H_wheel_3 -
    //   H_wheel_1 - H_wheel_2 - e0'*(2*J*w_S_in_axle_base_3_by_e3_dot - K*w_S_in_axle_base_1_by_e3_dot -
    //   K*w_S_in_axle_base_2_by_e3_dot) - e3'*(K*w_S_in_axle_base_1_by_e3_dot +
    //   K*w_S_in_axle_base_2_by_e3_dot - 2*J*w_S_in_axle_base_3_by_e3_dot) +
    //   2*e2*(K*w_S_in_axle_base_1_2_by_e3_dot + K*w_S_in_axle_base_2_2_by_e3_dot)) +
    //   e3*(e1'*(K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot -
    //   2*J*w_S_in_axle_base_3_by_e3_dot) + e2'*(K*w_S_in_axle_base_1_by_e3_dot +
    //   K*w_S_in_axle_base_2_by_e3_dot - 2*J*w_S_in_axle_base_3_by_e3_dot) +
    //   2*e3*(K*w_S_in_axle_base_1_2_by_e3_dot + K*w_S_in_axle_base_2_2_by_e3_dot)) - K*(e0*(H_wheel_1 +
    //   H_wheel_2 - H_wheel_3 + 2*e2'*(K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot +
    //   J*w_S_in_axle_base_3_by_e3_dot) + e3'*(K*w_S_in_axle_base_1_by_e3_dot +
    //   K*w_S_in_axle_base_2_by_e3_dot - 2*J*w_S_in_axle_base_3_by_e3_dot) +
    //   e0*(K*w_S_in_axle_base_1_2_by_e3_dot + K*w_S_in_axle_base_2_2_by_e3_dot)) + e1*(2*H_wheel_1 +
    //   2*H_wheel_2 + H_wheel_3 + 2*e3'*(K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot +
    //   J*w_S_in_axle_base_3_by_e3_dot) + e2'*(2*J*w_S_in_axle_base_3_by_e3_dot -
    //   K*w_S_in_axle_base_1_by_e3_dot - K*w_S_in_axle_base_2_by_e3_dot) +
    //   e1*(K*w_S_in_axle_base_1_2_by_e3_dot + K*w_S_in_axle_base_2_2_by_e3_dot)) +
    //   e2*(e2*(K*w_S_in_axle_base_1_2_by_e3_dot + K*w_S_in_axle_base_2_2_by_e3_dot) -
    //   2*e0'*(K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot +
    //   J*w_S_in_axle_base_3_by_e3_dot) - e1'*(2*J*w_S_in_axle_base_3_by_e3_dot -
    //   K*w_S_in_axle_base_1_by_e3_dot - K*w_S_in_axle_base_2_by_e3_dot)) +
    //   e3*(e3*(K*w_S_in_axle_base_1_2_by_e3_dot + K*w_S_in_axle_base_2_2_by_e3_dot) -
    //   2*e1'*(K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot +
    //   J*w_S_in_axle_base_3_by_e3_dot) - e0'*(K*w_S_in_axle_base_1_by_e3_dot +
    //   K*w_S_in_axle_base_2_by_e3_dot - 2*J*w_S_in_axle_base_3_by_e3_dot)))/(3*A + 2*K)) +
    //   3*K*(e0*(6*H_bus_2 + H_wheel_1 - H_wheel_2 - 6*C*e2'*w_S_3_by_e3_dot + e3'*(6*B*w_S_2_by_e3_dot +
    //   K*w_S_in_axle_base_1_by_e3_dot - K*w_S_in_axle_base_2_by_e3_dot) + e0*(6*A*w_S_1_2_by_e3_dot -
    //   K*w_S_in_axle_base_1_2_by_e3_dot + K*w_S_in_axle_base_2_2_by_e3_dot)) - e1*(6*H_bus_3 +
    //   6*C*e3'*w_S_3_by_e3_dot + e2'*(6*B*w_S_2_by_e3_dot + K*w_S_in_axle_base_1_by_e3_dot -
    //   K*w_S_in_axle_base_2_by_e3_dot) + e1*(K*w_S_in_axle_base_1_2_by_e3_dot - 6*A*w_S_1_2_by_e3_dot -
    //   K*w_S_in_axle_base_2_2_by_e3_dot)) + e2*(6*C*e0'*w_S_3_by_e3_dot + e1'*(6*B*w_S_2_by_e3_dot +
    //   K*w_S_in_axle_base_1_by_e3_dot - K*w_S_in_axle_base_2_by_e3_dot) + e2*(6*A*w_S_1_2_by_e3_dot -
    //   K*w_S_in_axle_base_1_2_by_e3_dot + K*w_S_in_axle_base_2_2_by_e3_dot)) + e3*(6*C*e1'*w_S_3_by_e3_dot
    //   + e0'*(K*w_S_in_axle_base_2_by_e3_dot - 6*B*w_S_2_by_e3_dot - K*w_S_in_axle_base_1_by_e3_dot) +
    //   e3*(6*A*w_S_1_2_by_e3_dot - K*w_S_in_axle_base_1_2_by_e3_dot +
    //   K*w_S_in_axle_base_2_2_by_e3_dot)))/(3*A + 2*K))/(9*(e0^2 + e1^2 + e2^2 + e3^2))
    let r1_by_e3_dot = r1_by_e0_dot_of_e0_e1_e2_e3
        * (e1 * h_bus_1_times_18 + e2 * h_bus_2_times_18 - e1_minus_e2 * r1_of_place_7_times_3
            + w_S_3_2_by_e3_dot * r1_by_e0_dot_of_place_10
            + w_S_1_by_e3_dot * r1_by_e0_dot_of_motion_2
            - w_S_2_by_e3_dot * r1_by_e0_dot_of_motion_3
            + w_S_in_axle_base_1_of_
                * (e0
                    * e0_doubled
                        .mul_add(
                            r1_by_e3_dot_of_place_3,
                            e1_dot_minus_e2_dot * r1_by_e3_dot_of_place_2,
                        )
                    + e3
                        * e3_doubled
                            .mul_add(
                                r1_by_e3_dot_of_place_3,
                                e1_dot_plus_e2_dot * r1_by_e3_dot_of_place_2,
                            )
                    + e1
                        * ((-e0_dot_plus_e3_dot)
                            .mul_add(r1_by_e3_dot_of_place_2, r1_of_place_3)
                            + e1_doubled * r1_by_e3_dot_of_place_3)
                    + e2
                        * (e0_dot_minus_e3_dot
                            .mul_add(r1_by_e3_dot_of_place_2, r1_of_place_3)
                            + e2_doubled * r1_by_e3_dot_of_place_3)
                    + k_r1_of_a_k
                        * (e1
                            * (e2_dot.mul_add(r1_by_e3_dot_of_place_2, -r1_of_place_6)
                                - e1 * r1_by_e3_dot_of_place_3
                                - e3_dot_doubled * r1_by_e3_dot_of_place_4)
                            + e0
                                * ((-e3_dot).mul_add(r1_by_e3_dot_of_place_2, r1_of_place_3)
                                    - e0 * r1_by_e3_dot_of_place_3
                                    - e2_dot_doubled * r1_by_e3_dot_of_place_4)
                            + e2
                                * ((-e1_dot)
                                    .mul_add(
                                        r1_by_e3_dot_of_place_2,
                                        e0_dot_doubled * r1_by_e3_dot_of_place_4,
                                    ) - e2 * r1_by_e3_dot_of_place_3)
                            + e3
                                * ((-e3)
                                    .mul_add(
                                        r1_by_e3_dot_of_place_3,
                                        e0_dot * r1_by_e3_dot_of_place_2,
                                    ) + e1_dot_doubled * r1_by_e3_dot_of_place_4)))
            + r1_by_e0_dot_of_motion * r1_by_e3_dot_of_place_5
            + k_r1_of_a_k_times_3
                * (e0
                    * ((-w_S_3_by_e3_dot).mul_add(e2_dot_c_times_6, r1_of_place_10)
                        + e0 * r1_by_e3_dot_of_place_7 + e3_dot * r1_by_e3_dot_of_place_9)
                    + e1
                        * (e1.mul_add(r1_by_e3_dot_of_place_7, -h_bus_3_times_6)
                            - w_S_3_by_e3_dot * e3_dot_c_times_6 - e2_dot * r1_by_e3_dot_of_place_9)
                    + e2
                        * (e2
                            .mul_add(
                                r1_by_e3_dot_of_place_7,
                                w_S_3_by_e3_dot * e0_dot_c_times_6,
                            ) + e1_dot * r1_by_e3_dot_of_place_9)
                    + e3
                        * (e3
                            .mul_add(
                                r1_by_e3_dot_of_place_7,
                                w_S_3_by_e3_dot * e1_dot_c_times_6,
                            ) - e0_dot * r1_by_e3_dot_of_place_9)));
    // e0*minus_r1_of_place_3 + w_S_3_of_motion_3*r1_by_e3_dot_of_place_2
    let w3_dot_by_e3_dot_of_motion = w_S_3_of_motion_3
        .mul_add(r1_by_e3_dot_of_place_2, e0 * minus_r1_of_place_3);
    let w3_dot_by_e3_dot_of_place = w_S_1_of_e0_e1_e2_e3 * r1_by_e3_dot_of_place_3;
    // w_S_3_by_e3_dot*w3_dot_by_e0_of_motion_3 - e0*r1_of_place_10_times_3 + e1_h_bus_3_times_18 -
    //   w3_dot_by_e0_of_e0_e1_e2_e3*r1_by_e3_dot_of_place_7 -
    //   w3_dot_by_e0_of_motion_2*r1_by_e3_dot_of_place_9 + sqrt(3)*(e1_r1_of_place_6 +
    //   w3_dot_of_motion_3*r1_by_e3_dot_of_place_4 + w3_dot_by_e3_dot_of_motion + w3_dot_by_e3_dot_of_place)
    let w3_dot_by_e3_dot_of_motion_2 = w_S_3_by_e3_dot * w3_dot_by_e0_of_motion_3
        - e0 * r1_of_place_10_times_3 + e1_h_bus_3_times_18
        - w3_dot_by_e0_of_e0_e1_e2_e3 * r1_by_e3_dot_of_place_7
        - w3_dot_by_e0_of_motion_2 * r1_by_e3_dot_of_place_9
        + w_S_in_axle_base_1_of_
            * (w3_dot_of_motion_3.mul_add(r1_by_e3_dot_of_place_4, e1_r1_of_place_6)
                + w3_dot_by_e3_dot_of_motion + w3_dot_by_e3_dot_of_place);
    // e0*w3_dot_by_e0_of_place_2 - w_S_3_by_e3_dot*w3_dot_by_e0_of_motion_5 + e2_h_bus_3_times_18 -
    //   w3_dot_by_e0_of_e0_e1_e2_e3*(w_S_2_2_by_e3_dot*b_times_6 + r1_by_e3_dot_of_place_6) +
    //   w3_dot_by_e0_of_motion_2*(w_S_1_by_e3_dot*a_times_6 - r1_by_e3_dot_of_place_8) +
    //   sqrt(3)*(e2_r1_of_place_6 - w3_dot_of_motion*r1_by_e3_dot_of_place_4 - w3_dot_by_e3_dot_of_motion +
    //   w3_dot_by_e3_dot_of_place) + k_r1_of_a_k*w3_dot_by_e3_dot_of_motion_2
    let w3_dot_by_e3_dot_of_motion_3 = e0 * w3_dot_by_e0_of_place_2
        - w_S_3_by_e3_dot * w3_dot_by_e0_of_motion_5 + e2_h_bus_3_times_18
        - w3_dot_by_e0_of_e0_e1_e2_e3
            * w_S_2_2_by_e3_dot.mul_add(b_times_6, r1_by_e3_dot_of_place_6)
        + w3_dot_by_e0_of_motion_2 * w_S_1_by_e3_dot.mul_add(a_times_6, -r1_by_e3_dot_of_place_8)
        + w_S_in_axle_base_1_of_
            * ((-w3_dot_of_motion).mul_add(r1_by_e3_dot_of_place_4, e2_r1_of_place_6)
                - w3_dot_by_e3_dot_of_motion + w3_dot_by_e3_dot_of_place)
        + k_r1_of_a_k * w3_dot_by_e3_dot_of_motion_2;
    // w3_dot_by_e3_dot = (3*r1_by_e3_dot - 2*K*(A + K)*(18*e2*H_bus_3 + 3*e0*(6*H_bus_1 - H_wheel_1 +
    //   H_wheel_2) + 18*C*w_S_3_by_e3_dot*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 3*(e2*e1' - e3*e0' - e1*e2'
    //   + e0*e3')*(6*A*w_S_1_by_e3_dot - K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot) +
    //   3*(e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_2_2_by_e3_dot - 6*B*w_S_2_2_by_e3_dot -
    //   K*w_S_in_axle_base_1_2_by_e3_dot) + K*(18*e1*H_bus_3 + 3*e0*(H_wheel_2 - 6*H_bus_2 - H_wheel_1) +
    //   18*C*w_S_3_by_e3_dot*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(6*B*w_S_2_by_e3_dot + K*w_S_in_axle_base_1_by_e3_dot - K*w_S_in_axle_base_2_by_e3_dot) +
    //   3*(e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e3_dot - 6*A*w_S_1_2_by_e3_dot -
    //   K*w_S_in_axle_base_2_2_by_e3_dot) + sqrt(3)*(e1*(2*H_wheel_1 + 2*H_wheel_2 + H_wheel_3) +
    //   e0*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot +
    //   J*w_S_in_axle_base_3_by_e3_dot) + (e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot -
    //   2*J*w_S_in_axle_base_3_by_e3_dot) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e3_dot +
    //   K*w_S_in_axle_base_2_2_by_e3_dot)))/(3*A + 2*K) + sqrt(3)*(e2*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) + e0*(H_wheel_3 - H_wheel_1 - H_wheel_2) + 2*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3')*(K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot +
    //   J*w_S_in_axle_base_3_by_e3_dot) + (e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot -
    //   2*J*w_S_in_axle_base_3_by_e3_dot) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e3_dot +
    //   K*w_S_in_axle_base_2_2_by_e3_dot)))/((3*A + 2*K)*(3*B + K*(2 - K/(3*A + 2*K)))*(e0^2 + e1^2 + e2^2 +
    //   e3^2)))/(3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A + K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A +
    //   2*K)))))
    let w3_dot_by_e3_dot = w3_dot_of_a_b_c_k
        * (-w3_dot_by_e0_of_place_3)
            .mul_add(w3_dot_by_e3_dot_of_motion_3, S::int(3) * r1_by_e3_dot);
    // w2_dot_by_e3_dot = (9*K*w3_dot_by_e3_dot*(A + K)/(3*A + 2*K) - 2*(18*e2*H_bus_3 + 3*e0*(6*H_bus_1 -
    //   H_wheel_1 + H_wheel_2) + 18*C*w_S_3_by_e3_dot*(e1*e0' - e0*e1' - e3*e2' + e2*e3') + 3*(e2*e1' -
    //   e3*e0' - e1*e2' + e0*e3')*(6*A*w_S_1_by_e3_dot - K*w_S_in_axle_base_1_by_e3_dot +
    //   K*w_S_in_axle_base_2_by_e3_dot) + 3*(e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_2_2_by_e3_dot -
    //   6*B*w_S_2_2_by_e3_dot - K*w_S_in_axle_base_1_2_by_e3_dot) + K*(18*e1*H_bus_3 + 3*e0*(H_wheel_2 -
    //   6*H_bus_2 - H_wheel_1) + 18*C*w_S_3_by_e3_dot*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' -
    //   e2*e1' + e1*e2' - e0*e3')*(6*B*w_S_2_by_e3_dot + K*w_S_in_axle_base_1_by_e3_dot -
    //   K*w_S_in_axle_base_2_by_e3_dot) + 3*(e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e3_dot -
    //   6*A*w_S_1_2_by_e3_dot - K*w_S_in_axle_base_2_2_by_e3_dot) + sqrt(3)*(e1*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) + e0*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot +
    //   J*w_S_in_axle_base_3_by_e3_dot) + (e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot -
    //   2*J*w_S_in_axle_base_3_by_e3_dot) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e3_dot +
    //   K*w_S_in_axle_base_2_2_by_e3_dot)))/(3*A + 2*K) + sqrt(3)*(e2*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) + e0*(H_wheel_3 - H_wheel_1 - H_wheel_2) + 2*(e1*e0' - e0*e1' - e3*e2' +
    //   e2*e3')*(K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot +
    //   J*w_S_in_axle_base_3_by_e3_dot) + (e3*e0' - e2*e1' + e1*e2' -
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot -
    //   2*J*w_S_in_axle_base_3_by_e3_dot) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e3_dot +
    //   K*w_S_in_axle_base_2_2_by_e3_dot)))/(e0^2 + e1^2 + e2^2 + e3^2))/(3*(3*B + K*(2 - K/(3*A + 2*K))))
    let w2_dot_by_e3_dot = w3_dot_of_a_b_k_by_3
        * (-w_S_1_by_e0_of_e0_e1_e2_e3)
            .mul_add(w3_dot_by_e3_dot_of_motion_3, w3_dot_by_e3_dot * w3_dot_of_a_k_2);
    // w3_dot_by_e3_dot + w2_dot_by_e3_dot
    let w1_dot_by_e3_dot_of_place = w3_dot_by_e3_dot + w2_dot_by_e3_dot;
    // w1_dot_by_e3_dot = (3*K*(w3_dot_by_e3_dot + w2_dot_by_e3_dot) - 2*(18*e1*H_bus_3 + 3*e0*(H_wheel_2 -
    //   6*H_bus_2 - H_wheel_1) + 18*C*w_S_3_by_e3_dot*(e0*e2' - e2*e0' - e3*e1' + e1*e3') + 3*(e3*e0' -
    //   e2*e1' + e1*e2' - e0*e3')*(6*B*w_S_2_by_e3_dot + K*w_S_in_axle_base_1_by_e3_dot -
    //   K*w_S_in_axle_base_2_by_e3_dot) + 3*(e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e3_dot -
    //   6*A*w_S_1_2_by_e3_dot - K*w_S_in_axle_base_2_2_by_e3_dot) + sqrt(3)*(e1*(2*H_wheel_1 + 2*H_wheel_2 +
    //   H_wheel_3) + e0*(H_wheel_1 + H_wheel_2 - H_wheel_3) + 2*(e0*e2' - e2*e0' - e3*e1' +
    //   e1*e3')*(K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot +
    //   J*w_S_in_axle_base_3_by_e3_dot) + (e2*e1' - e3*e0' - e1*e2' +
    //   e0*e3')*(K*w_S_in_axle_base_1_by_e3_dot + K*w_S_in_axle_base_2_by_e3_dot -
    //   2*J*w_S_in_axle_base_3_by_e3_dot) + (e0^2 + e1^2 + e2^2 + e3^2)*(K*w_S_in_axle_base_1_2_by_e3_dot +
    //   K*w_S_in_axle_base_2_2_by_e3_dot)))/(e0^2 + e1^2 + e2^2 + e3^2))/(3*(3*A + 2*K))
    let w1_dot_by_e3_dot = r1_of_a_k_by_3
        * (-w_S_1_by_e0_of_e0_e1_e2_e3)
            .mul_add(
                w3_dot_by_e3_dot_of_motion_2,
                k_times_3 * w1_dot_by_e3_dot_of_place,
            );
    // s_dot_by_e3_dot = 4*w_S_in_axle_base_3_2_by_e3_dot/3 - sqrt(3)*(w3_dot_by_e3_dot + w2_dot_by_e3_dot
    //   + w1_dot_by_e3_dot)/3
    let s_dot_by_e3_dot = S::ratio(4, 3) * w_S_in_axle_base_3_2_by_e3_dot
        - s_dot_by_e0_of_ * (w1_dot_by_e3_dot + w1_dot_by_e3_dot_of_place);
    // e3*e0_ddot_by_e3_of_motion - e3'*(e0_sq_plus_e1_sq + e2_sq)
    let e0_ddot_by_e3_dot_of_motion = -e3_dot * (e0_sq_plus_e1_sq + e2_sq)
        + e3 * e0_ddot_by_e3_of_motion;
    // e0_ddot_by_e3_dot = 2*e0*(e3*(e0*e0' + e1*e1' + e2*e2') - e3'*(e0^2 + e1^2 + e2^2))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 - e3*w3_dot_by_e3_dot/2 - e2*w2_dot_by_e3_dot/2 - e1*w1_dot_by_e3_dot/2
    let e0_ddot_by_e3_dot = (-w1_dot_by_e3_dot)
        .mul_add(e1_halved, w3_dot_by_e0_of_e0_e1_e2_e3_3 * e0_ddot_by_e3_dot_of_motion)
        - w2_dot_by_e3_dot * e2_halved - w3_dot_by_e3_dot * e3_halved;
    // e1_ddot_by_e3_dot = 2*e1*(e3*(e0*e0' + e1*e1' + e2*e2') - e3'*(e0^2 + e1^2 + e2^2))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 + e2*w3_dot_by_e3_dot/2 - e3*w2_dot_by_e3_dot/2 + e0*w1_dot_by_e3_dot/2
    let e1_ddot_by_e3_dot = (-w2_dot_by_e3_dot)
        .mul_add(e3_halved, w3_dot_by_e3_dot * e2_halved) + w1_dot_by_e3_dot * e0_halved
        + e1_ddot_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e3_dot_of_motion;
    // e2_ddot_by_e3_dot = 2*e2*(e3*(e0*e0' + e1*e1' + e2*e2') - e3'*(e0^2 + e1^2 + e2^2))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 - e1*w3_dot_by_e3_dot/2 + e0*w2_dot_by_e3_dot/2 + e3*w1_dot_by_e3_dot/2
    let e2_ddot_by_e3_dot = (-w3_dot_by_e3_dot)
        .mul_add(e1_halved, w1_dot_by_e3_dot * e3_halved) + w2_dot_by_e3_dot * e0_halved
        + e2_ddot_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e3_dot_of_motion;
    // e3_ddot_by_e3_dot = 2*e3*(e3*(e0*e0' + e1*e1' + e2*e2') - e3'*(e0^2 + e1^2 + e2^2))/(e0^2 + e1^2 +
    //   e2^2 + e3^2)^2 + e0*w3_dot_by_e3_dot/2 + e1*w2_dot_by_e3_dot/2 - e2*w1_dot_by_e3_dot/2
    let e3_ddot_by_e3_dot = (-w1_dot_by_e3_dot)
        .mul_add(e2_halved, w2_dot_by_e3_dot * e1_halved) + w3_dot_by_e3_dot * e0_halved
        + e3_ddot_by_e0_of_e0_e1_e2_e3 * e0_ddot_by_e3_dot_of_motion;
    // e1*e2_dot_plus_e3_dot + e0*w_S_in_axle_base_3_2_by_e1_of_motion - e2*e0_dot_plus_e1_dot -
    //   e3*minus_e0_dot_plus_e1_dot
    let r1_by_phi_dot_of_motion = e0
        .mul_add(w_S_in_axle_base_3_2_by_e1_of_motion, e1 * e2_dot_plus_e3_dot)
        - e2 * e0_dot_plus_e1_dot - e3 * minus_e0_dot_plus_e1_dot;
    let r1_by_phi_dot_of_motion_2 = k_r1_of_a_k * r1_by_phi_dot_of_motion;
    // r1_by_phi_dot = 2*J*sqrt(3)*(e1*(e0' + e3') - e0*(e1' - e2') - e3*(e1' + e2') - e2*(e0' - e3') -
    //   K*(e3*(e0' - e1') - e2*(e0' + e1') + e0*(e2' - e3') + e1*(e2' + e3'))/(3*A + 2*K))/(3*(e0^2 + e1^2 +
    //   e2^2 + e3^2))
    let r1_by_phi_dot = S::ratio(2, 3) * J * w_S_in_axle_base_3_of_e0_e1_e2_e3
        * ((-e0).mul_add(e1_dot_minus_e2_dot, e1 * e0_dot_plus_e3_dot)
            - e2 * e0_dot_minus_e3_dot - e3 * e1_dot_plus_e2_dot - r1_by_phi_dot_of_motion_2);
    let w3_dot_by_phi_dot_of_j = J * w_S_in_axle_base_1_of_;
    // w3_dot_by_phi_dot_of_j*(e1*e0_dot_minus_e2_dot - e0*e1_dot_minus_e3_dot + e2*e1_dot_plus_e3_dot -
    //   e3*e0_dot_plus_e2_dot + r1_by_phi_dot_of_motion_2)
    let w3_dot_by_phi_dot_of_motion = w3_dot_by_phi_dot_of_j
        * ((-e0).mul_add(e1_dot_minus_e3_dot, e1 * e0_dot_minus_e2_dot)
            + e2 * e1_dot_plus_e3_dot - e3 * e0_dot_plus_e2_dot + r1_by_phi_dot_of_motion_2);
    // w3_dot_by_phi_dot = 3*(2*J*K*sqrt(3)*(A + K)*(e3*(e0' + e2') - e1*(e0' - e2') - e0*(e3' - e1') -
    //   e2*(e1' + e3') - K*(e3*(e0' - e1') - e2*(e0' + e1') + e0*(e2' - e3') + e1*(e2' + e3'))/(3*A +
    //   2*K))/((3*A + 2*K)*(3*B + K*(2 - K/(3*A + 2*K)))*(e0^2 + e1^2 + e2^2 + e3^2)) + r1_by_phi_dot)/(3*C
    //   + K*(2 - K*(1 + 9*(A + K)^2/((3*A + 2*K)*(3*B + K*(2 - K/(3*A + 2*K)))))/(3*A + 2*K)))
    let w3_dot_by_phi_dot = S::int(3)
        * (-w3_dot_by_e0_of_place_3).mul_add(w3_dot_by_phi_dot_of_motion, r1_by_phi_dot)
        / (K
            * (S::int(2)
                - k_r1_of_a_k
                    * (S::int(1) + S::int(9) * r1_of_a_k * w3_dot_of_a_b_k * a_plus_k * a_plus_k))
            + c_times_3);
    // w2_dot_by_phi_dot = (2*J*sqrt(3)*(e3*(e0' + e2') - e1*(e0' - e2') - e0*(e3' - e1') - e2*(e1' + e3')
    //   - K*(e3*(e0' - e1') - e2*(e0' + e1') + e0*(e2' - e3') + e1*(e2' + e3'))/(3*A + 2*K))/(e0^2 + e1^2 +
    //   e2^2 + e3^2) + 3*K*w3_dot_by_phi_dot*(A + K)/(3*A + 2*K))/(3*B + K*(2 - K/(3*A + 2*K)))
    let w2_dot_by_phi_dot = w3_dot_of_a_b_k
        * (-w_S_1_by_e0_of_e0_e1_e2_e3)
            .mul_add(
                w3_dot_by_phi_dot_of_motion,
                S::int(3) * w3_dot_by_phi_dot * k_r1_of_a_k_a_plus_k,
            );
    // w3_dot_by_phi_dot + w2_dot_by_phi_dot
    let w1_dot_by_phi_dot_of_place = w3_dot_by_phi_dot + w2_dot_by_phi_dot;
    // w1_dot_by_phi_dot = (2*J*sqrt(3)*(e2*(e0' + e1') - e3*(e0' - e1') - e0*(e2' - e3') - e1*(e2' +
    //   e3'))/(e0^2 + e1^2 + e2^2 + e3^2) + K*(w3_dot_by_phi_dot + w2_dot_by_phi_dot))/(3*A + 2*K)
    let w1_dot_by_phi_dot = r1_of_a_k
        * (-(w_S_1_by_e0_of_e0_e1_e2_e3 * r1_by_phi_dot_of_motion))
            .mul_add(w3_dot_by_phi_dot_of_j, K * w1_dot_by_phi_dot_of_place);
    // s_dot_by_phi_dot = -sqrt(3)*(w3_dot_by_phi_dot + w2_dot_by_phi_dot + w1_dot_by_phi_dot)/3
    let s_dot_by_phi_dot = -s_dot_by_e0_of_ * (w1_dot_by_phi_dot + w1_dot_by_phi_dot_of_place);
    // e0_ddot_by_phi_dot = -e3*w3_dot_by_phi_dot/2 - e2*w2_dot_by_phi_dot/2 - e1*w1_dot_by_phi_dot/2
    let e0_ddot_by_phi_dot = (-w2_dot_by_phi_dot)
        .mul_add(e2_halved, -w1_dot_by_phi_dot * e1_halved) - w3_dot_by_phi_dot * e3_halved;
    // e1_ddot_by_phi_dot = e2*w3_dot_by_phi_dot/2 - e3*w2_dot_by_phi_dot/2 + e0*w1_dot_by_phi_dot/2
    let e1_ddot_by_phi_dot = (-w2_dot_by_phi_dot)
        .mul_add(e3_halved, w3_dot_by_phi_dot * e2_halved) + w1_dot_by_phi_dot * e0_halved;
    // e2_ddot_by_phi_dot = e0*w2_dot_by_phi_dot/2 - e1*w3_dot_by_phi_dot/2 + e3*w1_dot_by_phi_dot/2
    let e2_ddot_by_phi_dot = (-w3_dot_by_phi_dot)
        .mul_add(e1_halved, w1_dot_by_phi_dot * e3_halved) + w2_dot_by_phi_dot * e0_halved;
    // e3_ddot_by_phi_dot = e0*w3_dot_by_phi_dot/2 + e1*w2_dot_by_phi_dot/2 - e2*w1_dot_by_phi_dot/2
    let e3_ddot_by_phi_dot = (-w1_dot_by_phi_dot)
        .mul_add(e2_halved, w2_dot_by_phi_dot * e1_halved) + w3_dot_by_phi_dot * e0_halved;
    // Entries that are not zero.
    // d(e0')/d(e0') = 1
    let e0_dot_by_e0_dot_value = S::int(1);
    // d(e1')/d(e1') = 1
    let e1_dot_by_e1_dot_value = S::int(1);
    // d(e2')/d(e2') = 1
    let e2_dot_by_e2_dot_value = S::int(1);
    // d(e3')/d(e3') = 1
    let e3_dot_by_e3_dot_value = S::int(1);
    // d(phi')/d(phi') = 1
    let phi_dot_by_phi_dot_value = S::int(1);
    let zero = S::int(0);
    [
        [zero, zero, zero, zero, zero, e0_dot_by_e0_dot_value, zero, zero, zero, zero],
        [zero, zero, zero, zero, zero, zero, e1_dot_by_e1_dot_value, zero, zero, zero],
        [zero, zero, zero, zero, zero, zero, zero, e2_dot_by_e2_dot_value, zero, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, e3_dot_by_e3_dot_value, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, phi_dot_by_phi_dot_value],
        [
            e0_ddot_by_e0, e0_ddot_by_e1, e0_ddot_by_e2, e0_ddot_by_e3, zero, e0_ddot_by_e0_dot,
            e0_ddot_by_e1_dot, e0_ddot_by_e2_dot, e0_ddot_by_e3_dot, e0_ddot_by_phi_dot,
        ],
        [
            e1_ddot_by_e0, e1_ddot_by_e1, e1_ddot_by_e2, e1_ddot_by_e3, zero, e1_ddot_by_e0_dot,
            e1_ddot_by_e1_dot, e1_ddot_by_e2_dot, e1_ddot_by_e3_dot, e1_ddot_by_phi_dot,
        ],
        [
            e2_ddot_by_e0, e2_ddot_by_e1, e2_ddot_by_e2, e2_ddot_by_e3, zero, e2_ddot_by_e0_dot,
            e2_ddot_by_e1_dot, e2_ddot_by_e2_dot, e2_ddot_by_e3_dot, e2_ddot_by_phi_dot,
        ],
        [
            e3_ddot_by_e0, e3_ddot_by_e1, e3_ddot_by_e2, e3_ddot_by_e3, zero, e3_ddot_by_e0_dot,
            e3_ddot_by_e1_dot, e3_ddot_by_e2_dot, e3_ddot_by_e3_dot, e3_ddot_by_phi_dot,
        ],
        [
            s_dot_by_e0, s_dot_by_e1, s_dot_by_e2, s_dot_by_e3, zero, s_dot_by_e0_dot,
            s_dot_by_e1_dot, s_dot_by_e2_dot, s_dot_by_e3_dot, s_dot_by_phi_dot,
        ],
    ]
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

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 88 convolutions and 316 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 10]],
    history: &mut [Factors<S, 88>],
) {
    let Parameters { A, B, C, J, K, T, .. } = *p;
    let [e0_0, e1_0, e2_0, e3_0, _, e0_dot_0, e1_dot_0, e2_dot_0, e3_dot_0, phi_dot_0] = series[0];
    // Shared terms.
    let weight_of_ = (S::int(3)).sqrt();
    // 3 + sqrt(3)
    let weight_of__2 = S::int(3) + weight_of_;
    let weight_of__3 = S::int(1) / weight_of__2;
    // 3*A + 2*K
    let a_times_3_plus_k_doubled = K.mul_add(S::int(2), S::int(3) * A);
    let weight_6_of_a_k = K / a_times_3_plus_k_doubled;
    let weight_29_of_a_k = S::int(1) / a_times_3_plus_k_doubled;
    // K*(K/(3*A + 2*K) - 2)
    let weight_21_of_a_k = K * (weight_6_of_a_k - S::int(2));
    // 3*B + K*(2 - K/(3*A + 2*K))
    let weight_21_of_a_b_k = B.mul_add(S::int(3), -weight_21_of_a_k);
    // A + K
    let a_plus_k = A + K;
    let weight_30_of_a_b_k = S::int(1) / weight_21_of_a_b_k;
    // 3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A + K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A + 2*K))))
    let weight_22_of_a_b_c_k = C.mul_add(S::int(3), -weight_21_of_a_k)
        - S::int(9) * K * K * a_plus_k * a_plus_k
            / (a_times_3_plus_k_doubled * a_times_3_plus_k_doubled * weight_21_of_a_b_k);
    let weight_31_of_a_b_c_k = S::int(1) / weight_22_of_a_b_c_k;
    let weight_6_of_a_k_2 = K * weight_of_ / a_times_3_plus_k_doubled;
    // Constant in time.
    // weight = 3/(3 + sqrt(3)) - 3
    let weight = weight_of__3.mul_add(S::int(3), -S::int(3));
    // weight_2 = 3/(3 + sqrt(3))
    let weight_2 = S::int(3) * weight_of__3;
    // sqrt_3 = sqrt(3)
    let sqrt_3 = weight_of_;
    // weight_3 = 2*sqrt(3)
    let weight_3 = S::int(2) * weight_of_;
    // weight_4 = -3*T*sqrt(3) - 3*K*T*sqrt(3)/(3*A + 2*K)
    let weight_4 = (-(T * weight_of_))
        .mul_add(S::int(3), -S::int(3) * K * T * weight_of_ / a_times_3_plus_k_doubled);
    // weight_5 = 36*C
    let weight_5 = S::int(36) * C;
    // weight_6 = 2*K*(2*sqrt(3) - 3*K/(3*A + 2*K) - K*sqrt(3)/(3*A + 2*K))
    let weight_6 = S::int(2) * K
        * ((-weight_6_of_a_k).mul_add(S::int(3), S::int(2) * weight_of_) - weight_6_of_a_k_2);
    // weight_7 = 2*K*(2*sqrt(3) + 3*K/(3*A + 2*K) - K*sqrt(3)/(3*A + 2*K))
    let weight_7 = S::int(2) * K
        * (weight_6_of_a_k.mul_add(S::int(3), S::int(2) * weight_of_) - weight_6_of_a_k_2);
    // weight_8 = 36*A*K/(3*A + 2*K)
    let weight_8 = S::int(36) * A * K / a_times_3_plus_k_doubled;
    // weight_9 = 18*A
    let weight_9 = S::int(18) * A;
    // weight_10 = -K*(3 + sqrt(3) + 2*K*sqrt(3)/(3*A + 2*K))
    let weight_10 = -K * weight_6_of_a_k_2.mul_add(S::int(2), S::int(3) + weight_of_);
    // weight_11 = K*(3 - sqrt(3) - 2*K*sqrt(3)/(3*A + 2*K))
    let weight_11 = K * (-weight_6_of_a_k_2).mul_add(S::int(2), S::int(3) - weight_of_);
    // weight_12 = J*sqrt(3)*(1 - K/(3*A + 2*K))
    let weight_12 = J * weight_of_ * (S::int(1) - weight_6_of_a_k);
    // weight_13 = -18*C*K/(3*A + 2*K)
    let weight_13 = -S::int(18) * C * K / a_times_3_plus_k_doubled;
    // weight_14 = 18*B
    let weight_14 = S::int(18) * B;
    // j_sqrt_3 = J*sqrt(3)
    let j_sqrt_3 = J * weight_of_;
    // k_3_minus_sqrt_3 = K*(3 - sqrt(3))
    let k_3_minus_sqrt_3 = K * (S::int(3) - weight_of_);
    // minus_k_3_plus_sqrt_3 = -K*(3 + sqrt(3))
    let minus_k_3_plus_sqrt_3 = -K * weight_of__2;
    // weight_15 = 2*K/(3*A + 2*K)
    let weight_15 = S::int(2) * weight_6_of_a_k;
    // weight_16 = -2*K/(3*A + 2*K)
    let weight_16 = -S::int(2) * weight_6_of_a_k;
    // weight_17 = 2*K
    let weight_17 = S::int(2) * K;
    // weight_18 = 3*T
    let weight_18 = S::int(3) * T;
    // minus_j = -J
    let minus_j = -J;
    // weight_19 = 6*A
    let weight_19 = S::int(6) * A;
    // minus_k = -K
    let minus_k = -K;
    // weight_20 = 6*B
    let weight_20 = S::int(6) * B;
    // k_by_3_a_plus_2_k = K/(3*A + 2*K)
    let k_by_3_a_plus_2_k = weight_6_of_a_k;
    // minus_2_sqrt_3 = -2*sqrt(3)
    let minus_2_sqrt_3 = -S::int(2) * weight_of_;
    // minus_36_c = -36*C
    let minus_36_c = -S::int(36) * C;
    // weight_21 = -K*(A + K)/((3*A + 2*K)*(3*B + K*(2 - K/(3*A + 2*K))))
    let weight_21 = -K * a_plus_k / (a_times_3_plus_k_doubled * weight_21_of_a_b_k);
    // weight_22 = 9*K*(A + K)/((3*A + 2*K)*(9*K^2*(A + K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A + 2*K))))
    //   - 3*C - K*(2 - K/(3*A + 2*K))))
    let weight_22 = -S::int(9) * K * a_plus_k / (a_times_3_plus_k_doubled * weight_22_of_a_b_c_k);
    // weight_23 = -K/(3*B + K*(2 - K/(3*A + 2*K)))
    let weight_23 = -K / weight_21_of_a_b_k;
    // weight_24 = 3*K/(3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A + K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A +
    //   2*K)))))
    let weight_24 = S::int(3) * K / weight_22_of_a_b_c_k;
    // t_by_j = T/J
    let t_by_j = T / J;
    // weight_25 = -sqrt(3)/(9*(3*A + 2*K))
    let weight_25 = -S::ratio(1, 9) * weight_of_ / a_times_3_plus_k_doubled;
    // weight_26 = sqrt(3)/(9*(3*B + K*(2 - K/(3*A + 2*K))))
    let weight_26 = S::ratio(1, 9) * weight_of_ / weight_21_of_a_b_k;
    // weight_27 = sqrt(3)/(3*(9*K^2*(A + K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A + 2*K)))) - 3*C - K*(2 -
    //   K/(3*A + 2*K))))
    let weight_27 = -S::ratio(1, 3) * weight_of_ / weight_22_of_a_b_c_k;
    // weight_28 = 4*sqrt(3)/3
    let weight_28 = S::ratio(4, 3) * weight_of_;
    // weight_29 = -1/(6*(3*A + 2*K))
    let weight_29 = -S::ratio(1, 6) * weight_29_of_a_k;
    // weight_30 = 1/(6*(3*B + K*(2 - K/(3*A + 2*K))))
    let weight_30 = S::ratio(1, 6) * weight_30_of_a_b_k;
    // weight_31 = 1/(2*(9*K^2*(A + K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A + 2*K)))) - 3*C - K*(2 -
    //   K/(3*A + 2*K))))
    let weight_31 = -S::ratio(1, 2) * weight_31_of_a_b_c_k;
    // weight_32 = 1/(6*(3*A + 2*K))
    let weight_32 = S::ratio(1, 6) * weight_29_of_a_k;
    // weight_33 = 1/(2*(3*C + K*(2 - K/(3*A + 2*K)) - 9*K^2*(A + K)^2/((3*A + 2*K)^2*(3*B + K*(2 - K/(3*A
    //   + 2*K))))))
    let weight_33 = S::ratio(1, 2) * weight_31_of_a_b_c_k;
    // weight_34 = -1/(6*(3*B + K*(2 - K/(3*A + 2*K))))
    let weight_34 = -S::ratio(1, 6) * weight_30_of_a_b_k;
    // Order 0.
    let e0_e1_dot_0 = e0_0 * e1_dot_0;
    let e1_e0_dot_0 = e1_0 * e0_dot_0;
    let e2_e3_dot_0 = e2_0 * e3_dot_0;
    let e3_e2_dot_0 = e3_0 * e2_dot_0;
    let w_S_1_of_motion_0 = e0_e1_dot_0 + e3_e2_dot_0 - e1_e0_dot_0 - e2_e3_dot_0;
    let e0_sq_0 = e0_0 * e0_0;
    let e1_sq_0 = e1_0 * e1_0;
    let e2_sq_0 = e2_0 * e2_0;
    let e3_sq_0 = e3_0 * e3_0;
    let w_S_1_of_e0_e1_e2_e3_0 = e0_sq_0 + e1_sq_0 + e2_sq_0 + e3_sq_0;
    let over_w_S_1_of_e0_e1_e2_e3 = S::int(1) / w_S_1_of_e0_e1_e2_e3_0;
    let w_S_1_of_motion_2_0 = w_S_1_of_motion_0 * over_w_S_1_of_e0_e1_e2_e3;
    let e0_e2_dot_0 = e0_0 * e2_dot_0;
    let e2_e0_dot_0 = e2_0 * e0_dot_0;
    let e3_e1_dot_0 = e3_0 * e1_dot_0;
    let e1_e3_dot_0 = e1_0 * e3_dot_0;
    let w_S_2_of_motion_0 = e0_e2_dot_0 + e1_e3_dot_0 - e2_e0_dot_0 - e3_e1_dot_0;
    let w_S_2_of_motion_2_0 = w_S_2_of_motion_0 * over_w_S_1_of_e0_e1_e2_e3;
    let e0_e3_dot_0 = e0_0 * e3_dot_0;
    let e3_e0_dot_0 = e3_0 * e0_dot_0;
    let e1_e2_dot_0 = e1_0 * e2_dot_0;
    let e2_e1_dot_0 = e2_0 * e1_dot_0;
    let w_S_3_of_motion_0 = e0_e3_dot_0 + e2_e1_dot_0 - e3_e0_dot_0 - e1_e2_dot_0;
    let w_S_3_of_motion_2_0 = w_S_3_of_motion_0 * over_w_S_1_of_e0_e1_e2_e3;
    let w_S_in_axle_base_1_of_motion_0 = w_S_3_of_motion_2_0
        .mul_add(
            sqrt_3,
            w_S_2_of_motion_2_0.mul_add(weight_2, weight * w_S_1_of_motion_2_0),
        );
    let w_S_in_axle_base_2_of_motion_0 = w_S_2_of_motion_2_0
        .mul_add(
            weight,
            w_S_1_of_motion_2_0.mul_add(weight_2, sqrt_3 * w_S_3_of_motion_2_0),
        );
    let w_W_turn1_3_of_phi_dot_0 = w_S_2_of_motion_2_0
        .mul_add(
            weight_3,
            w_S_1_of_motion_2_0
                .mul_add(
                    weight_3,
                    w_S_3_of_motion_2_0.mul_add(weight_3, S::int(3) * phi_dot_0),
                ),
        );
    let e0_e0_dot_0 = e0_0 * e0_dot_0;
    let e1_e1_dot_0 = e1_0 * e1_dot_0;
    let e2_e2_dot_0 = e2_0 * e2_dot_0;
    let e3_e3_dot_0 = e3_0 * e3_dot_0;
    let w_S_1_2_of_motion_0 = e0_e0_dot_0 + e1_e1_dot_0 + e2_e2_dot_0 + e3_e3_dot_0;
    let w_S_1_2_of_e0_e1_e2_e3_0 = w_S_1_of_e0_e1_e2_e3_0 * w_S_1_of_e0_e1_e2_e3_0;
    let over_w_S_1_2_of_e0_e1_e2_e3 = S::int(1) / w_S_1_2_of_e0_e1_e2_e3_0;
    let w_S_1_2_of_motion_2_0 = w_S_1_2_of_motion_0 * over_w_S_1_2_of_e0_e1_e2_e3;
    let w_S_1_2_of_motion_3_0 = w_S_1_of_motion_0 * w_S_1_2_of_motion_2_0;
    let w_S_2_2_of_motion_0 = w_S_2_of_motion_0 * w_S_1_2_of_motion_2_0;
    let w_S_3_2_of_motion_0 = w_S_3_of_motion_0 * w_S_1_2_of_motion_2_0;
    let w_S_in_axle_base_1_2_of_motion_0 = w_S_3_2_of_motion_0
        .mul_add(
            sqrt_3,
            w_S_2_2_of_motion_0.mul_add(weight_2, weight * w_S_1_2_of_motion_3_0),
        );
    let w_S_in_axle_base_2_2_of_motion_0 = w_S_2_2_of_motion_0
        .mul_add(
            weight,
            w_S_1_2_of_motion_3_0.mul_add(weight_2, sqrt_3 * w_S_3_2_of_motion_0),
        );
    let r1_of_place_0 = w_S_in_axle_base_2_2_of_motion_0
        .mul_add(
            weight_7,
            w_S_in_axle_base_1_2_of_motion_0
                .mul_add(
                    weight_6,
                    w_S_1_2_of_motion_3_0
                        .mul_add(
                            weight_8,
                            w_S_3_2_of_motion_0.mul_add(weight_5, weight_4),
                        ),
                ),
        );
    let r1_of_place_2_0 = e0_0 * r1_of_place_0;
    let r1_of_place_3_0 = w_W_turn1_3_of_phi_dot_0
        .mul_add(
            weight_12,
            w_S_in_axle_base_2_of_motion_0
                .mul_add(
                    weight_11,
                    w_S_in_axle_base_1_of_motion_0
                        .mul_add(
                            weight_10,
                            w_S_3_of_motion_2_0
                                .mul_add(weight_13, weight_9 * w_S_1_of_motion_2_0),
                        ),
                ),
        );
    let r1_of_e2_dot_0 = e2_dot_0 * r1_of_place_3_0;
    let r1_of_place_4_0 = w_S_in_axle_base_2_of_motion_0
        .mul_add(
            minus_k_3_plus_sqrt_3,
            w_S_in_axle_base_1_of_motion_0
                .mul_add(
                    k_3_minus_sqrt_3,
                    w_W_turn1_3_of_phi_dot_0
                        .mul_add(j_sqrt_3, weight_14 * w_S_2_of_motion_2_0),
                ),
        );
    let r1_of_e1_dot_0 = e1_dot_0 * r1_of_place_4_0;
    let r1_of_e3_dot_0 = e3_dot_0 * r1_of_place_4_0;
    let r1_of_motion_0 = r1_of_e3_dot_0
        .mul_add(
            weight_15,
            r1_of_e1_dot_0.mul_add(-S::int(2), S::int(2) * r1_of_e2_dot_0),
        ) + r1_of_place_2_0;
    let r1_of_motion_2_0 = e0_0 * r1_of_motion_0;
    let r1_of_place_5_0 = e1_0 * r1_of_place_0;
    let r1_of_e3_dot_2_0 = e3_dot_0 * r1_of_place_3_0;
    let r1_of_e0_dot_0 = e0_dot_0 * r1_of_place_4_0;
    let r1_of_e2_dot_2_0 = e2_dot_0 * r1_of_place_4_0;
    let r1_of_motion_3_0 = r1_of_e2_dot_2_0
        .mul_add(
            weight_16,
            r1_of_e0_dot_0.mul_add(S::int(2), S::int(2) * r1_of_e3_dot_2_0),
        ) + r1_of_place_5_0;
    let r1_of_motion_4_0 = e1_0 * r1_of_motion_3_0;
    let r1_of_place_6_0 = e2_0 * r1_of_place_0;
    let r1_of_e0_dot_2_0 = e0_dot_0 * r1_of_place_3_0;
    let r1_of_motion_5_0 = r1_of_e3_dot_0
        .mul_add(
            S::int(2),
            r1_of_e1_dot_0.mul_add(weight_15, -S::int(2) * r1_of_e0_dot_2_0),
        ) + r1_of_place_6_0;
    let r1_of_motion_6_0 = e2_0 * r1_of_motion_5_0;
    let r1_of_place_7_0 = e3_0 * r1_of_place_0;
    let r1_of_e1_dot_2_0 = e1_dot_0 * r1_of_place_3_0;
    let r1_of_motion_7_0 = r1_of_e2_dot_2_0
        .mul_add(
            -S::int(2),
            r1_of_e0_dot_0.mul_add(weight_16, -S::int(2) * r1_of_e1_dot_2_0),
        ) + r1_of_place_7_0;
    let r1_of_motion_8_0 = e3_0 * r1_of_motion_7_0;
    let r1_of_motion_9_0 = r1_of_motion_2_0 + r1_of_motion_4_0 + r1_of_motion_6_0
        + r1_of_motion_8_0;
    let r1_of_motion_10_0 = r1_of_motion_9_0 * over_w_S_1_of_e0_e1_e2_e3;
    let w3_dot_of_place_0 = w_W_turn1_3_of_phi_dot_0
        .mul_add(
            J,
            w_S_in_axle_base_2_of_motion_0
                .mul_add(weight_17, weight_17 * w_S_in_axle_base_1_of_motion_0),
        );
    let w3_dot_of_place_2_0 = w_S_in_axle_base_2_2_of_motion_0
        .mul_add(
            weight_17,
            w_S_in_axle_base_1_2_of_motion_0.mul_add(weight_17, weight_18),
        );
    let w3_dot_of_place_3_0 = w_W_turn1_3_of_phi_dot_0
        .mul_add(
            minus_j,
            w_S_in_axle_base_2_of_motion_0.mul_add(K, K * w_S_in_axle_base_1_of_motion_0),
        );
    let w3_dot_of_place_4_0 = w_S_in_axle_base_2_2_of_motion_0
        .mul_add(
            K,
            w_S_in_axle_base_1_2_of_motion_0
                .mul_add(minus_k, weight_19 * w_S_1_2_of_motion_3_0),
        );
    let w3_dot_of_place_5_0 = w_S_in_axle_base_2_of_motion_0
        .mul_add(
            minus_k,
            w_S_in_axle_base_1_of_motion_0.mul_add(K, weight_20 * w_S_2_of_motion_2_0),
        );
    let w3_dot_of_place_6_0 = w_S_in_axle_base_2_2_of_motion_0
        .mul_add(
            minus_k,
            w_S_in_axle_base_1_2_of_motion_0.mul_add(K, weight_20 * w_S_2_2_of_motion_0),
        );
    let w3_dot_of_place_7_0 = w_S_in_axle_base_2_of_motion_0
        .mul_add(
            K,
            w_S_in_axle_base_1_of_motion_0
                .mul_add(minus_k, weight_19 * w_S_1_of_motion_2_0),
        );
    let w3_dot_of_motion_0 = w_S_2_of_motion_0 * w3_dot_of_place_0;
    let w3_dot_of_place_8_0 = w_S_1_of_e0_e1_e2_e3_0 * w3_dot_of_place_2_0;
    let w3_dot_of_motion_2_0 = w_S_3_of_motion_0 * w3_dot_of_place_3_0;
    let w3_dot_of_motion_3_0 = w_S_2_of_motion_0 * w_S_3_of_motion_2_0;
    let w3_dot_of_place_9_0 = w_S_1_of_e0_e1_e2_e3_0 * w3_dot_of_place_4_0;
    let w3_dot_of_motion_4_0 = w_S_3_of_motion_0 * w3_dot_of_place_5_0;
    let w3_dot_of_motion_5_0 = w3_dot_of_place_9_0
        .mul_add(
            -S::int(6),
            w3_dot_of_place_8_0
                .mul_add(
                    sqrt_3,
                    w3_dot_of_motion_4_0
                        .mul_add(
                            -S::int(6),
                            w3_dot_of_motion_2_0
                                .mul_add(
                                    weight_3,
                                    w3_dot_of_motion_0
                                        .mul_add(weight_3, weight_5 * w3_dot_of_motion_3_0),
                                ),
                        ),
                ),
        );
    let w3_dot_of_motion_6_0 = w_S_1_of_motion_0 * w3_dot_of_place_0;
    let w3_dot_of_motion_7_0 = w_S_1_of_motion_0 * w_S_3_of_motion_2_0;
    let w3_dot_of_place_10_0 = w_S_1_of_e0_e1_e2_e3_0 * w3_dot_of_place_6_0;
    let w3_dot_of_motion_8_0 = w_S_3_of_motion_0 * w3_dot_of_place_7_0;
    let w3_dot_of_motion_9_0 = w3_dot_of_motion_5_0
        .mul_add(
            k_by_3_a_plus_2_k,
            w3_dot_of_place_10_0
                .mul_add(
                    -S::int(6),
                    w3_dot_of_place_8_0
                        .mul_add(
                            sqrt_3,
                            w3_dot_of_motion_8_0
                                .mul_add(
                                    S::int(6),
                                    w3_dot_of_motion_6_0
                                        .mul_add(
                                            minus_2_sqrt_3,
                                            w3_dot_of_motion_2_0
                                                .mul_add(minus_2_sqrt_3, minus_36_c * w3_dot_of_motion_7_0),
                                        ),
                                ),
                        ),
                ),
        );
    let w3_dot_of_motion_10_0 = w3_dot_of_motion_9_0 * over_w_S_1_of_e0_e1_e2_e3;
    let w3_dot_of_motion_11_0 = r1_of_motion_10_0
        .mul_add(S::ratio(1, 3), weight_21 * w3_dot_of_motion_10_0);
    let w2_dot_of_motion_0 = w3_dot_of_motion_11_0
        .mul_add(weight_22, w3_dot_of_motion_10_0);
    let w1_dot_of_motion_0 = w3_dot_of_motion_5_0 * over_w_S_1_of_e0_e1_e2_e3;
    let w1_dot_of_motion_2_0 = w2_dot_of_motion_0
        .mul_add(
            weight_23,
            w3_dot_of_motion_11_0.mul_add(weight_24, -w1_dot_of_motion_0),
        );
    let phi_dot_dot_0 = w1_dot_of_motion_2_0
        .mul_add(
            weight_25,
            w2_dot_of_motion_0
                .mul_add(
                    weight_26,
                    w3_dot_of_motion_11_0
                        .mul_add(
                            weight_27,
                            w_S_2_2_of_motion_0
                                .mul_add(
                                    weight_28,
                                    w_S_1_2_of_motion_3_0
                                        .mul_add(
                                            weight_28,
                                            w_S_3_2_of_motion_0.mul_add(weight_28, t_by_j),
                                        ),
                                ),
                        ),
                ),
        );
    let e0_dot_sq_0 = e0_dot_0 * e0_dot_0;
    let e1_dot_sq_0 = e1_dot_0 * e1_dot_0;
    let e2_dot_sq_0 = e2_dot_0 * e2_dot_0;
    let e3_dot_sq_0 = e3_dot_0 * e3_dot_0;
    let e0_ddot_of_motion_0 = e1_dot_sq_0 + e2_dot_sq_0 + e3_dot_sq_0;
    let e0_ddot_of_motion_2_0 = e0_0 * e0_ddot_of_motion_0;
    let e0_ddot_of_motion_3_0 = e1_e1_dot_0 + e2_e2_dot_0 + e3_e3_dot_0;
    let e0_ddot_of_motion_4_0 = e0_dot_0 * e0_ddot_of_motion_3_0;
    let e0_ddot_of_motion_5_0 = e0_ddot_of_motion_4_0
        .mul_add(-S::int(2), e0_ddot_of_motion_2_0);
    let e0_ddot_of_motion_6_0 = e0_0 * e0_ddot_of_motion_5_0;
    let e0_ddot_of_motion_7_0 = e0_dot_sq_0 + e2_dot_sq_0 + e3_dot_sq_0;
    let e0_ddot_of_motion_8_0 = e1_0 * e0_ddot_of_motion_7_0;
    let e2_e2_dot_plus_e3_e3_dot_0 = e2_e2_dot_0 + e3_e3_dot_0;
    let e0_ddot_of_motion_9_0 = e1_dot_0 * e2_e2_dot_plus_e3_e3_dot_0;
    let e0_ddot_of_motion_10_0 = e0_ddot_of_motion_9_0
        .mul_add(-S::int(2), e0_ddot_of_motion_8_0);
    let e0_ddot_of_motion_11_0 = e1_0 * e0_ddot_of_motion_10_0;
    let e0_ddot_of_motion_12_0 = e0_dot_sq_0 + e1_dot_sq_0 + e3_dot_sq_0;
    let e0_ddot_of_motion_13_0 = e2_0 * e0_ddot_of_motion_12_0;
    let e3_e2_dot_e3_dot_0 = e3_dot_0 * e3_e2_dot_0;
    let e0_ddot_of_motion_14_0 = -S::int(2) * e3_e2_dot_e3_dot_0 + e0_ddot_of_motion_13_0;
    let e0_ddot_of_motion_15_0 = e2_0 * e0_ddot_of_motion_14_0;
    let e0_ddot_of_motion_16_0 = e0_dot_sq_0 + e1_dot_sq_0 + e2_dot_sq_0;
    let e0_ddot_of_motion_17_0 = e0_ddot_of_motion_16_0 * e3_sq_0;
    let e0_ddot_of_motion_18_0 = e0_ddot_of_motion_17_0 + e0_ddot_of_motion_6_0
        + e0_ddot_of_motion_11_0 + e0_ddot_of_motion_15_0;
    let e0_ddot_of_motion_19_0 = e0_ddot_of_motion_18_0 * over_w_S_1_2_of_e0_e1_e2_e3;
    let e0_ddot_of_motion_20_0 = e0_0 * e0_ddot_of_motion_19_0;
    let e0_ddot_of_motion_21_0 = e1_0 * w1_dot_of_motion_2_0;
    let e0_ddot_of_motion_22_0 = e2_0 * w2_dot_of_motion_0;
    let e0_ddot_of_motion_23_0 = e3_0 * w3_dot_of_motion_11_0;
    let e0_dot_dot_0 = e0_ddot_of_motion_21_0
        .mul_add(
            weight_29,
            e0_ddot_of_motion_22_0
                .mul_add(
                    weight_30,
                    e0_ddot_of_motion_23_0.mul_add(weight_31, -e0_ddot_of_motion_20_0),
                ),
        );
    let e1_ddot_of_motion_0 = e1_0 * e0_ddot_of_motion_19_0;
    let e1_ddot_of_motion_2_0 = e0_0 * w1_dot_of_motion_2_0;
    let e1_ddot_of_motion_3_0 = e3_0 * w2_dot_of_motion_0;
    let e1_ddot_of_motion_4_0 = e2_0 * w3_dot_of_motion_11_0;
    let e1_dot_dot_0 = e1_ddot_of_motion_2_0
        .mul_add(
            weight_32,
            e1_ddot_of_motion_3_0
                .mul_add(
                    weight_30,
                    e1_ddot_of_motion_4_0.mul_add(weight_33, -e1_ddot_of_motion_0),
                ),
        );
    let e2_ddot_of_motion_0 = e2_0 * e0_ddot_of_motion_19_0;
    let e2_ddot_of_motion_2_0 = e3_0 * w1_dot_of_motion_2_0;
    let e2_ddot_of_motion_3_0 = e0_0 * w2_dot_of_motion_0;
    let e2_ddot_of_motion_4_0 = e1_0 * w3_dot_of_motion_11_0;
    let e2_dot_dot_0 = e2_ddot_of_motion_2_0
        .mul_add(
            weight_32,
            e2_ddot_of_motion_3_0
                .mul_add(
                    weight_34,
                    e2_ddot_of_motion_4_0.mul_add(weight_31, -e2_ddot_of_motion_0),
                ),
        );
    let e3_ddot_of_motion_0 = e3_0 * e0_ddot_of_motion_19_0;
    let e3_ddot_of_motion_2_0 = e2_0 * w1_dot_of_motion_2_0;
    let e3_ddot_of_motion_3_0 = e1_0 * w2_dot_of_motion_0;
    let e3_ddot_of_motion_4_0 = e0_0 * w3_dot_of_motion_11_0;
    let e3_dot_dot_0 = e3_ddot_of_motion_2_0
        .mul_add(
            weight_29,
            e3_ddot_of_motion_3_0
                .mul_add(
                    weight_34,
                    e3_ddot_of_motion_4_0.mul_add(weight_33, -e3_ddot_of_motion_0),
                ),
        );
    // Order 1: the rates, and what follows from them.
    let e0_1 = e0_dot_0;
    let e1_1 = e1_dot_0;
    let e2_1 = e2_dot_0;
    let e3_1 = e3_dot_0;
    let phi_1 = phi_dot_0;
    let e0_dot_1 = e0_dot_dot_0;
    let e1_dot_1 = e1_dot_dot_0;
    let e2_dot_1 = e2_dot_dot_0;
    let e3_dot_1 = e3_dot_dot_0;
    let phi_dot_1 = phi_dot_dot_0;
    if series.len() > 1 {
        series[1] = [
            e0_1, e1_1, e2_1, e3_1, phi_1, e0_dot_1, e1_dot_1, e2_dot_1, e3_dot_1, phi_dot_1,
        ];
    }
    let e0_e1_dot_1 = e1_dot_1.mul_add(e0_0, e0_1 * e1_dot_0);
    let e1_e0_dot_1 = e0_dot_1.mul_add(e1_0, e1_1 * e0_dot_0);
    let e2_e3_dot_1 = e3_dot_1.mul_add(e2_0, e2_1 * e3_dot_0);
    let e3_e2_dot_1 = e2_dot_1.mul_add(e3_0, e3_1 * e2_dot_0);
    let w_S_1_of_motion_1 = e0_e1_dot_1 + e3_e2_dot_1 - e1_e0_dot_1 - e2_e3_dot_1;
    let e0_sq_1 = e0_1 * (e0_0 + e0_0);
    let e1_sq_1 = e1_1 * (e1_0 + e1_0);
    let e2_sq_1 = e2_1 * (e2_0 + e2_0);
    let e3_sq_1 = e3_1 * (e3_0 + e3_0);
    let w_S_1_of_e0_e1_e2_e3_1 = e0_sq_1 + e1_sq_1 + e2_sq_1 + e3_sq_1;
    let w_S_1_of_motion_2_1 = w_S_1_of_e0_e1_e2_e3_1
        .mul_add(
            -(w_S_1_of_motion_2_0 * over_w_S_1_of_e0_e1_e2_e3),
            w_S_1_of_motion_1 * over_w_S_1_of_e0_e1_e2_e3,
        );
    let e0_e2_dot_1 = e2_dot_1.mul_add(e0_0, e0_1 * e2_dot_0);
    let e2_e0_dot_1 = e0_dot_1.mul_add(e2_0, e2_1 * e0_dot_0);
    let e3_e1_dot_1 = e1_dot_1.mul_add(e3_0, e3_1 * e1_dot_0);
    let e1_e3_dot_1 = e3_dot_1.mul_add(e1_0, e1_1 * e3_dot_0);
    let w_S_2_of_motion_1 = e0_e2_dot_1 + e1_e3_dot_1 - e2_e0_dot_1 - e3_e1_dot_1;
    let w_S_2_of_motion_2_1 = w_S_1_of_e0_e1_e2_e3_1
        .mul_add(
            -(w_S_2_of_motion_2_0 * over_w_S_1_of_e0_e1_e2_e3),
            w_S_2_of_motion_1 * over_w_S_1_of_e0_e1_e2_e3,
        );
    let e0_e3_dot_1 = e3_dot_1.mul_add(e0_0, e0_1 * e3_dot_0);
    let e3_e0_dot_1 = e0_dot_1.mul_add(e3_0, e3_1 * e0_dot_0);
    let e1_e2_dot_1 = e2_dot_1.mul_add(e1_0, e1_1 * e2_dot_0);
    let e2_e1_dot_1 = e1_dot_1.mul_add(e2_0, e2_1 * e1_dot_0);
    let w_S_3_of_motion_1 = e0_e3_dot_1 + e2_e1_dot_1 - e3_e0_dot_1 - e1_e2_dot_1;
    let w_S_3_of_motion_2_1 = w_S_1_of_e0_e1_e2_e3_1
        .mul_add(
            -(w_S_3_of_motion_2_0 * over_w_S_1_of_e0_e1_e2_e3),
            w_S_3_of_motion_1 * over_w_S_1_of_e0_e1_e2_e3,
        );
    let w_S_in_axle_base_1_of_motion_1 = w_S_3_of_motion_2_1
        .mul_add(
            sqrt_3,
            w_S_2_of_motion_2_1.mul_add(weight_2, weight * w_S_1_of_motion_2_1),
        );
    let w_S_in_axle_base_2_of_motion_1 = w_S_2_of_motion_2_1
        .mul_add(
            weight,
            w_S_1_of_motion_2_1.mul_add(weight_2, sqrt_3 * w_S_3_of_motion_2_1),
        );
    let w_W_turn1_3_of_phi_dot_1 = w_S_2_of_motion_2_1
        .mul_add(
            weight_3,
            w_S_1_of_motion_2_1
                .mul_add(
                    weight_3,
                    w_S_3_of_motion_2_1.mul_add(weight_3, S::int(3) * phi_dot_1),
                ),
        );
    let e0_e0_dot_1 = e0_dot_1.mul_add(e0_0, e0_1 * e0_dot_0);
    let e1_e1_dot_1 = e1_dot_1.mul_add(e1_0, e1_1 * e1_dot_0);
    let e2_e2_dot_1 = e2_dot_1.mul_add(e2_0, e2_1 * e2_dot_0);
    let e3_e3_dot_1 = e3_dot_1.mul_add(e3_0, e3_1 * e3_dot_0);
    let w_S_1_2_of_motion_1 = e0_e0_dot_1 + e1_e1_dot_1 + e2_e2_dot_1 + e3_e3_dot_1;
    let w_S_1_2_of_e0_e1_e2_e3_1 = w_S_1_of_e0_e1_e2_e3_1
        * (w_S_1_of_e0_e1_e2_e3_0 + w_S_1_of_e0_e1_e2_e3_0);
    let w_S_1_2_of_motion_2_1 = w_S_1_2_of_e0_e1_e2_e3_1
        .mul_add(
            -(w_S_1_2_of_motion_2_0 * over_w_S_1_2_of_e0_e1_e2_e3),
            w_S_1_2_of_motion_1 * over_w_S_1_2_of_e0_e1_e2_e3,
        );
    let w_S_1_2_of_motion_3_1 = w_S_1_2_of_motion_2_1
        .mul_add(w_S_1_of_motion_0, w_S_1_of_motion_1 * w_S_1_2_of_motion_2_0);
    let w_S_2_2_of_motion_1 = w_S_1_2_of_motion_2_1
        .mul_add(w_S_2_of_motion_0, w_S_2_of_motion_1 * w_S_1_2_of_motion_2_0);
    let w_S_3_2_of_motion_1 = w_S_1_2_of_motion_2_1
        .mul_add(w_S_3_of_motion_0, w_S_3_of_motion_1 * w_S_1_2_of_motion_2_0);
    let w_S_in_axle_base_1_2_of_motion_1 = w_S_3_2_of_motion_1
        .mul_add(
            sqrt_3,
            w_S_2_2_of_motion_1.mul_add(weight_2, weight * w_S_1_2_of_motion_3_1),
        );
    let w_S_in_axle_base_2_2_of_motion_1 = w_S_2_2_of_motion_1
        .mul_add(
            weight,
            w_S_1_2_of_motion_3_1.mul_add(weight_2, sqrt_3 * w_S_3_2_of_motion_1),
        );
    let r1_of_place_1 = w_S_in_axle_base_2_2_of_motion_1
        .mul_add(
            weight_7,
            w_S_in_axle_base_1_2_of_motion_1
                .mul_add(
                    weight_6,
                    w_S_1_2_of_motion_3_1
                        .mul_add(weight_8, weight_5 * w_S_3_2_of_motion_1),
                ),
        );
    let r1_of_place_2_1 = r1_of_place_1.mul_add(e0_0, e0_1 * r1_of_place_0);
    let r1_of_place_3_1 = w_W_turn1_3_of_phi_dot_1
        .mul_add(
            weight_12,
            w_S_in_axle_base_2_of_motion_1
                .mul_add(
                    weight_11,
                    w_S_in_axle_base_1_of_motion_1
                        .mul_add(
                            weight_10,
                            w_S_3_of_motion_2_1
                                .mul_add(weight_13, weight_9 * w_S_1_of_motion_2_1),
                        ),
                ),
        );
    let r1_of_e2_dot_1 = r1_of_place_3_1.mul_add(e2_dot_0, e2_dot_1 * r1_of_place_3_0);
    let r1_of_place_4_1 = w_S_in_axle_base_2_of_motion_1
        .mul_add(
            minus_k_3_plus_sqrt_3,
            w_S_in_axle_base_1_of_motion_1
                .mul_add(
                    k_3_minus_sqrt_3,
                    w_W_turn1_3_of_phi_dot_1
                        .mul_add(j_sqrt_3, weight_14 * w_S_2_of_motion_2_1),
                ),
        );
    let r1_of_e1_dot_1 = r1_of_place_4_1.mul_add(e1_dot_0, e1_dot_1 * r1_of_place_4_0);
    let r1_of_e3_dot_1 = r1_of_place_4_1.mul_add(e3_dot_0, e3_dot_1 * r1_of_place_4_0);
    let r1_of_motion_1 = r1_of_e3_dot_1
        .mul_add(
            weight_15,
            r1_of_e1_dot_1.mul_add(-S::int(2), S::int(2) * r1_of_e2_dot_1),
        ) + r1_of_place_2_1;
    let r1_of_motion_2_1 = r1_of_motion_1.mul_add(e0_0, e0_1 * r1_of_motion_0);
    let r1_of_place_5_1 = r1_of_place_1.mul_add(e1_0, e1_1 * r1_of_place_0);
    let r1_of_e3_dot_2_1 = r1_of_place_3_1.mul_add(e3_dot_0, e3_dot_1 * r1_of_place_3_0);
    let r1_of_e0_dot_1 = r1_of_place_4_1.mul_add(e0_dot_0, e0_dot_1 * r1_of_place_4_0);
    let r1_of_e2_dot_2_1 = r1_of_place_4_1.mul_add(e2_dot_0, e2_dot_1 * r1_of_place_4_0);
    let r1_of_motion_3_1 = r1_of_e2_dot_2_1
        .mul_add(
            weight_16,
            r1_of_e0_dot_1.mul_add(S::int(2), S::int(2) * r1_of_e3_dot_2_1),
        ) + r1_of_place_5_1;
    let r1_of_motion_4_1 = r1_of_motion_3_1.mul_add(e1_0, e1_1 * r1_of_motion_3_0);
    let r1_of_place_6_1 = r1_of_place_1.mul_add(e2_0, e2_1 * r1_of_place_0);
    let r1_of_e0_dot_2_1 = r1_of_place_3_1.mul_add(e0_dot_0, e0_dot_1 * r1_of_place_3_0);
    let r1_of_motion_5_1 = r1_of_e3_dot_1
        .mul_add(
            S::int(2),
            r1_of_e1_dot_1.mul_add(weight_15, -S::int(2) * r1_of_e0_dot_2_1),
        ) + r1_of_place_6_1;
    let r1_of_motion_6_1 = r1_of_motion_5_1.mul_add(e2_0, e2_1 * r1_of_motion_5_0);
    let r1_of_place_7_1 = r1_of_place_1.mul_add(e3_0, e3_1 * r1_of_place_0);
    let r1_of_e1_dot_2_1 = r1_of_place_3_1.mul_add(e1_dot_0, e1_dot_1 * r1_of_place_3_0);
    let r1_of_motion_7_1 = r1_of_e2_dot_2_1
        .mul_add(
            -S::int(2),
            r1_of_e0_dot_1.mul_add(weight_16, -S::int(2) * r1_of_e1_dot_2_1),
        ) + r1_of_place_7_1;
    let r1_of_motion_8_1 = r1_of_motion_7_1.mul_add(e3_0, e3_1 * r1_of_motion_7_0);
    let r1_of_motion_9_1 = r1_of_motion_2_1 + r1_of_motion_4_1 + r1_of_motion_6_1
        + r1_of_motion_8_1;
    let r1_of_motion_10_1 = w_S_1_of_e0_e1_e2_e3_1
        .mul_add(
            -(r1_of_motion_10_0 * over_w_S_1_of_e0_e1_e2_e3),
            r1_of_motion_9_1 * over_w_S_1_of_e0_e1_e2_e3,
        );
    let w3_dot_of_place_1 = w_W_turn1_3_of_phi_dot_1
        .mul_add(
            J,
            w_S_in_axle_base_2_of_motion_1
                .mul_add(weight_17, weight_17 * w_S_in_axle_base_1_of_motion_1),
        );
    let w3_dot_of_place_2_1 = w_S_in_axle_base_2_2_of_motion_1
        .mul_add(weight_17, weight_17 * w_S_in_axle_base_1_2_of_motion_1);
    let w3_dot_of_place_3_1 = w_W_turn1_3_of_phi_dot_1
        .mul_add(
            minus_j,
            w_S_in_axle_base_2_of_motion_1.mul_add(K, K * w_S_in_axle_base_1_of_motion_1),
        );
    let w3_dot_of_place_4_1 = w_S_in_axle_base_2_2_of_motion_1
        .mul_add(
            K,
            w_S_in_axle_base_1_2_of_motion_1
                .mul_add(minus_k, weight_19 * w_S_1_2_of_motion_3_1),
        );
    let w3_dot_of_place_5_1 = w_S_in_axle_base_2_of_motion_1
        .mul_add(
            minus_k,
            w_S_in_axle_base_1_of_motion_1.mul_add(K, weight_20 * w_S_2_of_motion_2_1),
        );
    let w3_dot_of_place_6_1 = w_S_in_axle_base_2_2_of_motion_1
        .mul_add(
            minus_k,
            w_S_in_axle_base_1_2_of_motion_1.mul_add(K, weight_20 * w_S_2_2_of_motion_1),
        );
    let w3_dot_of_place_7_1 = w_S_in_axle_base_2_of_motion_1
        .mul_add(
            K,
            w_S_in_axle_base_1_of_motion_1
                .mul_add(minus_k, weight_19 * w_S_1_of_motion_2_1),
        );
    let w3_dot_of_motion_1 = w3_dot_of_place_1
        .mul_add(w_S_2_of_motion_0, w_S_2_of_motion_1 * w3_dot_of_place_0);
    let w3_dot_of_place_8_1 = w3_dot_of_place_2_1
        .mul_add(w_S_1_of_e0_e1_e2_e3_0, w_S_1_of_e0_e1_e2_e3_1 * w3_dot_of_place_2_0);
    let w3_dot_of_motion_2_1 = w3_dot_of_place_3_1
        .mul_add(w_S_3_of_motion_0, w_S_3_of_motion_1 * w3_dot_of_place_3_0);
    let w3_dot_of_motion_3_1 = w_S_3_of_motion_2_1
        .mul_add(w_S_2_of_motion_0, w_S_2_of_motion_1 * w_S_3_of_motion_2_0);
    let w3_dot_of_place_9_1 = w3_dot_of_place_4_1
        .mul_add(w_S_1_of_e0_e1_e2_e3_0, w_S_1_of_e0_e1_e2_e3_1 * w3_dot_of_place_4_0);
    let w3_dot_of_motion_4_1 = w3_dot_of_place_5_1
        .mul_add(w_S_3_of_motion_0, w_S_3_of_motion_1 * w3_dot_of_place_5_0);
    let w3_dot_of_motion_5_1 = w3_dot_of_place_9_1
        .mul_add(
            -S::int(6),
            w3_dot_of_place_8_1
                .mul_add(
                    sqrt_3,
                    w3_dot_of_motion_4_1
                        .mul_add(
                            -S::int(6),
                            w3_dot_of_motion_2_1
                                .mul_add(
                                    weight_3,
                                    w3_dot_of_motion_1
                                        .mul_add(weight_3, weight_5 * w3_dot_of_motion_3_1),
                                ),
                        ),
                ),
        );
    let w3_dot_of_motion_6_1 = w3_dot_of_place_1
        .mul_add(w_S_1_of_motion_0, w_S_1_of_motion_1 * w3_dot_of_place_0);
    let w3_dot_of_motion_7_1 = w_S_3_of_motion_2_1
        .mul_add(w_S_1_of_motion_0, w_S_1_of_motion_1 * w_S_3_of_motion_2_0);
    let w3_dot_of_place_10_1 = w3_dot_of_place_6_1
        .mul_add(w_S_1_of_e0_e1_e2_e3_0, w_S_1_of_e0_e1_e2_e3_1 * w3_dot_of_place_6_0);
    let w3_dot_of_motion_8_1 = w3_dot_of_place_7_1
        .mul_add(w_S_3_of_motion_0, w_S_3_of_motion_1 * w3_dot_of_place_7_0);
    let w3_dot_of_motion_9_1 = w3_dot_of_motion_5_1
        .mul_add(
            k_by_3_a_plus_2_k,
            w3_dot_of_place_10_1
                .mul_add(
                    -S::int(6),
                    w3_dot_of_place_8_1
                        .mul_add(
                            sqrt_3,
                            w3_dot_of_motion_8_1
                                .mul_add(
                                    S::int(6),
                                    w3_dot_of_motion_6_1
                                        .mul_add(
                                            minus_2_sqrt_3,
                                            w3_dot_of_motion_2_1
                                                .mul_add(minus_2_sqrt_3, minus_36_c * w3_dot_of_motion_7_1),
                                        ),
                                ),
                        ),
                ),
        );
    let w3_dot_of_motion_10_1 = w_S_1_of_e0_e1_e2_e3_1
        .mul_add(
            -(w3_dot_of_motion_10_0 * over_w_S_1_of_e0_e1_e2_e3),
            w3_dot_of_motion_9_1 * over_w_S_1_of_e0_e1_e2_e3,
        );
    let w3_dot_of_motion_11_1 = r1_of_motion_10_1
        .mul_add(S::ratio(1, 3), weight_21 * w3_dot_of_motion_10_1);
    let w2_dot_of_motion_1 = w3_dot_of_motion_11_1
        .mul_add(weight_22, w3_dot_of_motion_10_1);
    let w1_dot_of_motion_1 = w_S_1_of_e0_e1_e2_e3_1
        .mul_add(
            -(w1_dot_of_motion_0 * over_w_S_1_of_e0_e1_e2_e3),
            w3_dot_of_motion_5_1 * over_w_S_1_of_e0_e1_e2_e3,
        );
    let w1_dot_of_motion_2_1 = w2_dot_of_motion_1
        .mul_add(
            weight_23,
            w3_dot_of_motion_11_1.mul_add(weight_24, -w1_dot_of_motion_1),
        );
    let phi_dot_dot_1 = w1_dot_of_motion_2_1
        .mul_add(
            weight_25,
            w2_dot_of_motion_1
                .mul_add(
                    weight_26,
                    w3_dot_of_motion_11_1
                        .mul_add(
                            weight_27,
                            w_S_2_2_of_motion_1
                                .mul_add(
                                    weight_28,
                                    w_S_1_2_of_motion_3_1
                                        .mul_add(weight_28, weight_28 * w_S_3_2_of_motion_1),
                                ),
                        ),
                ),
        );
    let e0_dot_sq_1 = e0_dot_1 * (e0_dot_0 + e0_dot_0);
    let e1_dot_sq_1 = e1_dot_1 * (e1_dot_0 + e1_dot_0);
    let e2_dot_sq_1 = e2_dot_1 * (e2_dot_0 + e2_dot_0);
    let e3_dot_sq_1 = e3_dot_1 * (e3_dot_0 + e3_dot_0);
    let e0_ddot_of_motion_1 = e1_dot_sq_1 + e2_dot_sq_1 + e3_dot_sq_1;
    let e0_ddot_of_motion_2_1 = e0_ddot_of_motion_1
        .mul_add(e0_0, e0_1 * e0_ddot_of_motion_0);
    let e0_ddot_of_motion_3_1 = e1_e1_dot_1 + e2_e2_dot_1 + e3_e3_dot_1;
    let e0_ddot_of_motion_4_1 = e0_ddot_of_motion_3_1
        .mul_add(e0_dot_0, e0_dot_1 * e0_ddot_of_motion_3_0);
    let e0_ddot_of_motion_5_1 = e0_ddot_of_motion_4_1
        .mul_add(-S::int(2), e0_ddot_of_motion_2_1);
    let e0_ddot_of_motion_6_1 = e0_ddot_of_motion_5_1
        .mul_add(e0_0, e0_1 * e0_ddot_of_motion_5_0);
    let e0_ddot_of_motion_7_1 = e0_dot_sq_1 + e2_dot_sq_1 + e3_dot_sq_1;
    let e0_ddot_of_motion_8_1 = e0_ddot_of_motion_7_1
        .mul_add(e1_0, e1_1 * e0_ddot_of_motion_7_0);
    let e2_e2_dot_plus_e3_e3_dot_1 = e2_e2_dot_1 + e3_e3_dot_1;
    let e0_ddot_of_motion_9_1 = e2_e2_dot_plus_e3_e3_dot_1
        .mul_add(e1_dot_0, e1_dot_1 * e2_e2_dot_plus_e3_e3_dot_0);
    let e0_ddot_of_motion_10_1 = e0_ddot_of_motion_9_1
        .mul_add(-S::int(2), e0_ddot_of_motion_8_1);
    let e0_ddot_of_motion_11_1 = e0_ddot_of_motion_10_1
        .mul_add(e1_0, e1_1 * e0_ddot_of_motion_10_0);
    let e0_ddot_of_motion_12_1 = e0_dot_sq_1 + e1_dot_sq_1 + e3_dot_sq_1;
    let e0_ddot_of_motion_13_1 = e0_ddot_of_motion_12_1
        .mul_add(e2_0, e2_1 * e0_ddot_of_motion_12_0);
    let e3_e2_dot_e3_dot_1 = e3_e2_dot_1.mul_add(e3_dot_0, e3_dot_1 * e3_e2_dot_0);
    let e0_ddot_of_motion_14_1 = -S::int(2) * e3_e2_dot_e3_dot_1 + e0_ddot_of_motion_13_1;
    let e0_ddot_of_motion_15_1 = e0_ddot_of_motion_14_1
        .mul_add(e2_0, e2_1 * e0_ddot_of_motion_14_0);
    let e0_ddot_of_motion_16_1 = e0_dot_sq_1 + e1_dot_sq_1 + e2_dot_sq_1;
    let e0_ddot_of_motion_17_1 = e0_ddot_of_motion_16_1
        .mul_add(e3_sq_0, e3_sq_1 * e0_ddot_of_motion_16_0);
    let e0_ddot_of_motion_18_1 = e0_ddot_of_motion_17_1 + e0_ddot_of_motion_6_1
        + e0_ddot_of_motion_11_1 + e0_ddot_of_motion_15_1;
    let e0_ddot_of_motion_19_1 = w_S_1_2_of_e0_e1_e2_e3_1
        .mul_add(
            -(e0_ddot_of_motion_19_0 * over_w_S_1_2_of_e0_e1_e2_e3),
            e0_ddot_of_motion_18_1 * over_w_S_1_2_of_e0_e1_e2_e3,
        );
    let e0_ddot_of_motion_20_1 = e0_ddot_of_motion_19_1
        .mul_add(e0_0, e0_1 * e0_ddot_of_motion_19_0);
    let e0_ddot_of_motion_21_1 = w1_dot_of_motion_2_1
        .mul_add(e1_0, e1_1 * w1_dot_of_motion_2_0);
    let e0_ddot_of_motion_22_1 = w2_dot_of_motion_1
        .mul_add(e2_0, e2_1 * w2_dot_of_motion_0);
    let e0_ddot_of_motion_23_1 = w3_dot_of_motion_11_1
        .mul_add(e3_0, e3_1 * w3_dot_of_motion_11_0);
    let e0_dot_dot_1 = e0_ddot_of_motion_21_1
        .mul_add(
            weight_29,
            e0_ddot_of_motion_22_1
                .mul_add(
                    weight_30,
                    e0_ddot_of_motion_23_1.mul_add(weight_31, -e0_ddot_of_motion_20_1),
                ),
        );
    let e1_ddot_of_motion_1 = e0_ddot_of_motion_19_1
        .mul_add(e1_0, e1_1 * e0_ddot_of_motion_19_0);
    let e1_ddot_of_motion_2_1 = w1_dot_of_motion_2_1
        .mul_add(e0_0, e0_1 * w1_dot_of_motion_2_0);
    let e1_ddot_of_motion_3_1 = w2_dot_of_motion_1
        .mul_add(e3_0, e3_1 * w2_dot_of_motion_0);
    let e1_ddot_of_motion_4_1 = w3_dot_of_motion_11_1
        .mul_add(e2_0, e2_1 * w3_dot_of_motion_11_0);
    let e1_dot_dot_1 = e1_ddot_of_motion_2_1
        .mul_add(
            weight_32,
            e1_ddot_of_motion_3_1
                .mul_add(
                    weight_30,
                    e1_ddot_of_motion_4_1.mul_add(weight_33, -e1_ddot_of_motion_1),
                ),
        );
    let e2_ddot_of_motion_1 = e0_ddot_of_motion_19_1
        .mul_add(e2_0, e2_1 * e0_ddot_of_motion_19_0);
    let e2_ddot_of_motion_2_1 = w1_dot_of_motion_2_1
        .mul_add(e3_0, e3_1 * w1_dot_of_motion_2_0);
    let e2_ddot_of_motion_3_1 = w2_dot_of_motion_1
        .mul_add(e0_0, e0_1 * w2_dot_of_motion_0);
    let e2_ddot_of_motion_4_1 = w3_dot_of_motion_11_1
        .mul_add(e1_0, e1_1 * w3_dot_of_motion_11_0);
    let e2_dot_dot_1 = e2_ddot_of_motion_2_1
        .mul_add(
            weight_32,
            e2_ddot_of_motion_3_1
                .mul_add(
                    weight_34,
                    e2_ddot_of_motion_4_1.mul_add(weight_31, -e2_ddot_of_motion_1),
                ),
        );
    let e3_ddot_of_motion_1 = e0_ddot_of_motion_19_1
        .mul_add(e3_0, e3_1 * e0_ddot_of_motion_19_0);
    let e3_ddot_of_motion_2_1 = w1_dot_of_motion_2_1
        .mul_add(e2_0, e2_1 * w1_dot_of_motion_2_0);
    let e3_ddot_of_motion_3_1 = w2_dot_of_motion_1
        .mul_add(e1_0, e1_1 * w2_dot_of_motion_0);
    let e3_ddot_of_motion_4_1 = w3_dot_of_motion_11_1
        .mul_add(e0_0, e0_1 * w3_dot_of_motion_11_0);
    let e3_dot_dot_1 = e3_ddot_of_motion_2_1
        .mul_add(
            weight_29,
            e3_ddot_of_motion_3_1
                .mul_add(
                    weight_34,
                    e3_ddot_of_motion_4_1.mul_add(weight_33, -e3_ddot_of_motion_1),
                ),
        );
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            [
                e0_1, e1_1, e2_1, e3_1, e0_1, e1_1, e2_1, e3_1, w_S_1_of_e0_e1_e2_e3_1, e0_1, e2_1,
                e3_1, e1_1, w_S_1_of_e0_e1_e2_e3_1, e0_1, e3_1, e1_1, e2_1, w_S_1_of_e0_e1_e2_e3_1,
                e0_1, e1_1, e2_1, e3_1, w_S_1_of_e0_e1_e2_e3_1, w_S_1_2_of_e0_e1_e2_e3_1,
                w_S_1_of_motion_1, w_S_2_of_motion_1, w_S_3_of_motion_1, e0_1, e2_dot_1, e1_dot_1,
                e3_dot_1, e0_1, e1_1, e3_dot_1, e0_dot_1, e2_dot_1, e1_1, e2_1, e0_dot_1, e2_1,
                e3_1, e1_dot_1, e3_1, w_S_1_of_e0_e1_e2_e3_1, w_S_2_of_motion_1,
                w_S_1_of_e0_e1_e2_e3_1, w_S_3_of_motion_1, w_S_2_of_motion_1,
                w_S_1_of_e0_e1_e2_e3_1, w_S_3_of_motion_1, w_S_1_of_motion_1, w_S_1_of_motion_1,
                w_S_1_of_e0_e1_e2_e3_1, w_S_3_of_motion_1, w_S_1_of_e0_e1_e2_e3_1,
                w_S_1_of_e0_e1_e2_e3_1, e0_dot_1, e1_dot_1, e2_dot_1, e3_dot_1, e0_1, e0_dot_1,
                e0_1, e1_1, e1_dot_1, e1_1, e2_1, e3_dot_1, e2_1, e0_ddot_of_motion_16_1,
                w_S_1_2_of_e0_e1_e2_e3_1, e0_1, e1_1, e2_1, e3_1, e1_1, e0_1, e3_1, e2_1, e2_1,
                e3_1, e0_1, e1_1, e3_1, e2_1, e1_1, e0_1,
            ],
            [
                e1_dot_1, e0_dot_1, e3_dot_1, e2_dot_1, e0_1, e1_1, e2_1, e3_1, w_S_1_of_motion_2_1,
                e2_dot_1, e0_dot_1, e1_dot_1, e3_dot_1, w_S_2_of_motion_2_1, e3_dot_1, e0_dot_1,
                e2_dot_1, e1_dot_1, w_S_3_of_motion_2_1, e0_dot_1, e1_dot_1, e2_dot_1, e3_dot_1,
                w_S_1_of_e0_e1_e2_e3_1, w_S_1_2_of_motion_2_1, w_S_1_2_of_motion_2_1,
                w_S_1_2_of_motion_2_1, w_S_1_2_of_motion_2_1, r1_of_place_1, r1_of_place_3_1,
                r1_of_place_4_1, r1_of_place_4_1, r1_of_motion_1, r1_of_place_1, r1_of_place_3_1,
                r1_of_place_4_1, r1_of_place_4_1, r1_of_motion_3_1, r1_of_place_1, r1_of_place_3_1,
                r1_of_motion_5_1, r1_of_place_1, r1_of_place_3_1, r1_of_motion_7_1,
                r1_of_motion_10_1, w3_dot_of_place_1, w3_dot_of_place_2_1, w3_dot_of_place_3_1,
                w_S_3_of_motion_2_1, w3_dot_of_place_4_1, w3_dot_of_place_5_1, w3_dot_of_place_1,
                w_S_3_of_motion_2_1, w3_dot_of_place_6_1, w3_dot_of_place_7_1,
                w3_dot_of_motion_10_1, w1_dot_of_motion_1, e0_dot_1, e1_dot_1, e2_dot_1, e3_dot_1,
                e0_ddot_of_motion_1, e0_ddot_of_motion_3_1, e0_ddot_of_motion_5_1,
                e0_ddot_of_motion_7_1, e2_e2_dot_plus_e3_e3_dot_1, e0_ddot_of_motion_10_1,
                e0_ddot_of_motion_12_1, e3_e2_dot_1, e0_ddot_of_motion_14_1, e3_sq_1,
                e0_ddot_of_motion_19_1, e0_ddot_of_motion_19_1, w1_dot_of_motion_2_1,
                w2_dot_of_motion_1, w3_dot_of_motion_11_1, e0_ddot_of_motion_19_1,
                w1_dot_of_motion_2_1, w2_dot_of_motion_1, w3_dot_of_motion_11_1,
                e0_ddot_of_motion_19_1, w1_dot_of_motion_2_1, w2_dot_of_motion_1,
                w3_dot_of_motion_11_1, e0_ddot_of_motion_19_1, w1_dot_of_motion_2_1,
                w2_dot_of_motion_1, w3_dot_of_motion_11_1,
            ],
        ];
    }
    let mut e0_last = e0_1;
    let mut e1_last = e1_1;
    let mut e2_last = e2_1;
    let mut e3_last = e3_1;
    let mut e0_dot_last = e0_dot_1;
    let mut e1_dot_last = e1_dot_1;
    let mut e2_dot_last = e2_dot_1;
    let mut e3_dot_last = e3_dot_1;
    let mut e3_e2_dot_last = e3_e2_dot_1;
    let mut w_S_1_of_motion_last = w_S_1_of_motion_1;
    let mut e3_sq_last = e3_sq_1;
    let mut w_S_1_of_e0_e1_e2_e3_last = w_S_1_of_e0_e1_e2_e3_1;
    let mut w_S_1_of_motion_2_last = w_S_1_of_motion_2_1;
    let mut w_S_2_of_motion_last = w_S_2_of_motion_1;
    let mut w_S_2_of_motion_2_last = w_S_2_of_motion_2_1;
    let mut w_S_3_of_motion_last = w_S_3_of_motion_1;
    let mut w_S_3_of_motion_2_last = w_S_3_of_motion_2_1;
    let mut w_S_1_2_of_e0_e1_e2_e3_last = w_S_1_2_of_e0_e1_e2_e3_1;
    let mut w_S_1_2_of_motion_2_last = w_S_1_2_of_motion_2_1;
    let mut r1_of_place_last = r1_of_place_1;
    let mut r1_of_place_3_last = r1_of_place_3_1;
    let mut r1_of_place_4_last = r1_of_place_4_1;
    let mut r1_of_motion_last = r1_of_motion_1;
    let mut r1_of_motion_3_last = r1_of_motion_3_1;
    let mut r1_of_motion_5_last = r1_of_motion_5_1;
    let mut r1_of_motion_7_last = r1_of_motion_7_1;
    let mut r1_of_motion_10_last = r1_of_motion_10_1;
    let mut w3_dot_of_place_last = w3_dot_of_place_1;
    let mut w3_dot_of_place_2_last = w3_dot_of_place_2_1;
    let mut w3_dot_of_place_3_last = w3_dot_of_place_3_1;
    let mut w3_dot_of_place_4_last = w3_dot_of_place_4_1;
    let mut w3_dot_of_place_5_last = w3_dot_of_place_5_1;
    let mut w3_dot_of_place_6_last = w3_dot_of_place_6_1;
    let mut w3_dot_of_place_7_last = w3_dot_of_place_7_1;
    let mut w3_dot_of_motion_10_last = w3_dot_of_motion_10_1;
    let mut w3_dot_of_motion_11_last = w3_dot_of_motion_11_1;
    let mut w2_dot_of_motion_last = w2_dot_of_motion_1;
    let mut w1_dot_of_motion_last = w1_dot_of_motion_1;
    let mut w1_dot_of_motion_2_last = w1_dot_of_motion_2_1;
    let mut e0_ddot_of_motion_last = e0_ddot_of_motion_1;
    let mut e0_ddot_of_motion_3_last = e0_ddot_of_motion_3_1;
    let mut e0_ddot_of_motion_5_last = e0_ddot_of_motion_5_1;
    let mut e0_ddot_of_motion_7_last = e0_ddot_of_motion_7_1;
    let mut e2_e2_dot_plus_e3_e3_dot_last = e2_e2_dot_plus_e3_e3_dot_1;
    let mut e0_ddot_of_motion_10_last = e0_ddot_of_motion_10_1;
    let mut e0_ddot_of_motion_12_last = e0_ddot_of_motion_12_1;
    let mut e0_ddot_of_motion_14_last = e0_ddot_of_motion_14_1;
    let mut e0_ddot_of_motion_16_last = e0_ddot_of_motion_16_1;
    let mut e0_ddot_of_motion_19_last = e0_ddot_of_motion_19_1;
    let mut next = [S::int(0); 88];
    // Rates at order k - 1.
    let mut e0_rate = e0_dot_1;
    let mut e1_rate = e1_dot_1;
    let mut e2_rate = e2_dot_1;
    let mut e3_rate = e3_dot_1;
    let mut phi_rate = phi_dot_1;
    let mut e0_dot_rate = e0_dot_dot_1;
    let mut e1_dot_rate = e1_dot_dot_1;
    let mut e2_dot_rate = e2_dot_dot_1;
    let mut e3_dot_rate = e3_dot_dot_1;
    let mut phi_dot_rate = phi_dot_dot_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let e0 = e0_rate * over_k;
        let e1 = e1_rate * over_k;
        let e2 = e2_rate * over_k;
        let e3 = e3_rate * over_k;
        let phi = phi_rate * over_k;
        let e0_dot = e0_dot_rate * over_k;
        let e1_dot = e1_dot_rate * over_k;
        let e2_dot = e2_dot_rate * over_k;
        let e3_dot = e3_dot_rate * over_k;
        let phi_dot = phi_dot_rate * over_k;
        series[order] = [e0, e1, e2, e3, phi, e0_dot, e1_dot, e2_dot, e3_dot, phi_dot];
        if order + 1 == series.len() {
            break;
        }
        let sums = if order % 2 == 0 {
            // All convolutions of order k, and of order k + 1 but for the terms with coefficients of order
            //   k.
            let pair = pair_sums(&history[..order]);
            next = pair[1];
            pair[0]
        } else {
            // Those terms, which also have coefficients of order 1.
            [
                e0_1.mul_add(e1_dot_last, e0_last.mul_add(e1_dot_1, next[0])),
                e1_1.mul_add(e0_dot_last, e1_last.mul_add(e0_dot_1, next[1])),
                e2_1.mul_add(e3_dot_last, e2_last.mul_add(e3_dot_1, next[2])),
                e3_1.mul_add(e2_dot_last, e3_last.mul_add(e2_dot_1, next[3])),
                (e0_1 + e0_1).mul_add(e0_last, next[4]),
                (e1_1 + e1_1).mul_add(e1_last, next[5]),
                (e2_1 + e2_1).mul_add(e2_last, next[6]),
                (e3_1 + e3_1).mul_add(e3_last, next[7]),
                w_S_1_of_e0_e1_e2_e3_1
                    .mul_add(
                        w_S_1_of_motion_2_last,
                        w_S_1_of_e0_e1_e2_e3_last.mul_add(w_S_1_of_motion_2_1, next[8]),
                    ),
                e0_1.mul_add(e2_dot_last, e0_last.mul_add(e2_dot_1, next[9])),
                e2_1.mul_add(e0_dot_last, e2_last.mul_add(e0_dot_1, next[10])),
                e3_1.mul_add(e1_dot_last, e3_last.mul_add(e1_dot_1, next[11])),
                e1_1.mul_add(e3_dot_last, e1_last.mul_add(e3_dot_1, next[12])),
                w_S_1_of_e0_e1_e2_e3_1
                    .mul_add(
                        w_S_2_of_motion_2_last,
                        w_S_1_of_e0_e1_e2_e3_last.mul_add(w_S_2_of_motion_2_1, next[13]),
                    ),
                e0_1.mul_add(e3_dot_last, e0_last.mul_add(e3_dot_1, next[14])),
                e3_1.mul_add(e0_dot_last, e3_last.mul_add(e0_dot_1, next[15])),
                e1_1.mul_add(e2_dot_last, e1_last.mul_add(e2_dot_1, next[16])),
                e2_1.mul_add(e1_dot_last, e2_last.mul_add(e1_dot_1, next[17])),
                w_S_1_of_e0_e1_e2_e3_1
                    .mul_add(
                        w_S_3_of_motion_2_last,
                        w_S_1_of_e0_e1_e2_e3_last.mul_add(w_S_3_of_motion_2_1, next[18]),
                    ),
                e0_1.mul_add(e0_dot_last, e0_last.mul_add(e0_dot_1, next[19])),
                e1_1.mul_add(e1_dot_last, e1_last.mul_add(e1_dot_1, next[20])),
                e2_1.mul_add(e2_dot_last, e2_last.mul_add(e2_dot_1, next[21])),
                e3_1.mul_add(e3_dot_last, e3_last.mul_add(e3_dot_1, next[22])),
                (w_S_1_of_e0_e1_e2_e3_1 + w_S_1_of_e0_e1_e2_e3_1)
                    .mul_add(w_S_1_of_e0_e1_e2_e3_last, next[23]),
                w_S_1_2_of_e0_e1_e2_e3_1
                    .mul_add(
                        w_S_1_2_of_motion_2_last,
                        w_S_1_2_of_e0_e1_e2_e3_last
                            .mul_add(w_S_1_2_of_motion_2_1, next[24]),
                    ),
                w_S_1_of_motion_1
                    .mul_add(
                        w_S_1_2_of_motion_2_last,
                        w_S_1_of_motion_last.mul_add(w_S_1_2_of_motion_2_1, next[25]),
                    ),
                w_S_2_of_motion_1
                    .mul_add(
                        w_S_1_2_of_motion_2_last,
                        w_S_2_of_motion_last.mul_add(w_S_1_2_of_motion_2_1, next[26]),
                    ),
                w_S_3_of_motion_1
                    .mul_add(
                        w_S_1_2_of_motion_2_last,
                        w_S_3_of_motion_last.mul_add(w_S_1_2_of_motion_2_1, next[27]),
                    ),
                e0_1.mul_add(r1_of_place_last, e0_last.mul_add(r1_of_place_1, next[28])),
                e2_dot_1
                    .mul_add(
                        r1_of_place_3_last,
                        e2_dot_last.mul_add(r1_of_place_3_1, next[29]),
                    ),
                e1_dot_1
                    .mul_add(
                        r1_of_place_4_last,
                        e1_dot_last.mul_add(r1_of_place_4_1, next[30]),
                    ),
                e3_dot_1
                    .mul_add(
                        r1_of_place_4_last,
                        e3_dot_last.mul_add(r1_of_place_4_1, next[31]),
                    ),
                e0_1
                    .mul_add(
                        r1_of_motion_last,
                        e0_last.mul_add(r1_of_motion_1, next[32]),
                    ),
                e1_1.mul_add(r1_of_place_last, e1_last.mul_add(r1_of_place_1, next[33])),
                e3_dot_1
                    .mul_add(
                        r1_of_place_3_last,
                        e3_dot_last.mul_add(r1_of_place_3_1, next[34]),
                    ),
                e0_dot_1
                    .mul_add(
                        r1_of_place_4_last,
                        e0_dot_last.mul_add(r1_of_place_4_1, next[35]),
                    ),
                e2_dot_1
                    .mul_add(
                        r1_of_place_4_last,
                        e2_dot_last.mul_add(r1_of_place_4_1, next[36]),
                    ),
                e1_1
                    .mul_add(
                        r1_of_motion_3_last,
                        e1_last.mul_add(r1_of_motion_3_1, next[37]),
                    ),
                e2_1.mul_add(r1_of_place_last, e2_last.mul_add(r1_of_place_1, next[38])),
                e0_dot_1
                    .mul_add(
                        r1_of_place_3_last,
                        e0_dot_last.mul_add(r1_of_place_3_1, next[39]),
                    ),
                e2_1
                    .mul_add(
                        r1_of_motion_5_last,
                        e2_last.mul_add(r1_of_motion_5_1, next[40]),
                    ),
                e3_1.mul_add(r1_of_place_last, e3_last.mul_add(r1_of_place_1, next[41])),
                e1_dot_1
                    .mul_add(
                        r1_of_place_3_last,
                        e1_dot_last.mul_add(r1_of_place_3_1, next[42]),
                    ),
                e3_1
                    .mul_add(
                        r1_of_motion_7_last,
                        e3_last.mul_add(r1_of_motion_7_1, next[43]),
                    ),
                w_S_1_of_e0_e1_e2_e3_1
                    .mul_add(
                        r1_of_motion_10_last,
                        w_S_1_of_e0_e1_e2_e3_last.mul_add(r1_of_motion_10_1, next[44]),
                    ),
                w_S_2_of_motion_1
                    .mul_add(
                        w3_dot_of_place_last,
                        w_S_2_of_motion_last.mul_add(w3_dot_of_place_1, next[45]),
                    ),
                w_S_1_of_e0_e1_e2_e3_1
                    .mul_add(
                        w3_dot_of_place_2_last,
                        w_S_1_of_e0_e1_e2_e3_last.mul_add(w3_dot_of_place_2_1, next[46]),
                    ),
                w_S_3_of_motion_1
                    .mul_add(
                        w3_dot_of_place_3_last,
                        w_S_3_of_motion_last.mul_add(w3_dot_of_place_3_1, next[47]),
                    ),
                w_S_2_of_motion_1
                    .mul_add(
                        w_S_3_of_motion_2_last,
                        w_S_2_of_motion_last.mul_add(w_S_3_of_motion_2_1, next[48]),
                    ),
                w_S_1_of_e0_e1_e2_e3_1
                    .mul_add(
                        w3_dot_of_place_4_last,
                        w_S_1_of_e0_e1_e2_e3_last.mul_add(w3_dot_of_place_4_1, next[49]),
                    ),
                w_S_3_of_motion_1
                    .mul_add(
                        w3_dot_of_place_5_last,
                        w_S_3_of_motion_last.mul_add(w3_dot_of_place_5_1, next[50]),
                    ),
                w_S_1_of_motion_1
                    .mul_add(
                        w3_dot_of_place_last,
                        w_S_1_of_motion_last.mul_add(w3_dot_of_place_1, next[51]),
                    ),
                w_S_1_of_motion_1
                    .mul_add(
                        w_S_3_of_motion_2_last,
                        w_S_1_of_motion_last.mul_add(w_S_3_of_motion_2_1, next[52]),
                    ),
                w_S_1_of_e0_e1_e2_e3_1
                    .mul_add(
                        w3_dot_of_place_6_last,
                        w_S_1_of_e0_e1_e2_e3_last.mul_add(w3_dot_of_place_6_1, next[53]),
                    ),
                w_S_3_of_motion_1
                    .mul_add(
                        w3_dot_of_place_7_last,
                        w_S_3_of_motion_last.mul_add(w3_dot_of_place_7_1, next[54]),
                    ),
                w_S_1_of_e0_e1_e2_e3_1
                    .mul_add(
                        w3_dot_of_motion_10_last,
                        w_S_1_of_e0_e1_e2_e3_last
                            .mul_add(w3_dot_of_motion_10_1, next[55]),
                    ),
                w_S_1_of_e0_e1_e2_e3_1
                    .mul_add(
                        w1_dot_of_motion_last,
                        w_S_1_of_e0_e1_e2_e3_last.mul_add(w1_dot_of_motion_1, next[56]),
                    ),
                (e0_dot_1 + e0_dot_1).mul_add(e0_dot_last, next[57]),
                (e1_dot_1 + e1_dot_1).mul_add(e1_dot_last, next[58]),
                (e2_dot_1 + e2_dot_1).mul_add(e2_dot_last, next[59]),
                (e3_dot_1 + e3_dot_1).mul_add(e3_dot_last, next[60]),
                e0_1
                    .mul_add(
                        e0_ddot_of_motion_last,
                        e0_last.mul_add(e0_ddot_of_motion_1, next[61]),
                    ),
                e0_dot_1
                    .mul_add(
                        e0_ddot_of_motion_3_last,
                        e0_dot_last.mul_add(e0_ddot_of_motion_3_1, next[62]),
                    ),
                e0_1
                    .mul_add(
                        e0_ddot_of_motion_5_last,
                        e0_last.mul_add(e0_ddot_of_motion_5_1, next[63]),
                    ),
                e1_1
                    .mul_add(
                        e0_ddot_of_motion_7_last,
                        e1_last.mul_add(e0_ddot_of_motion_7_1, next[64]),
                    ),
                e1_dot_1
                    .mul_add(
                        e2_e2_dot_plus_e3_e3_dot_last,
                        e1_dot_last.mul_add(e2_e2_dot_plus_e3_e3_dot_1, next[65]),
                    ),
                e1_1
                    .mul_add(
                        e0_ddot_of_motion_10_last,
                        e1_last.mul_add(e0_ddot_of_motion_10_1, next[66]),
                    ),
                e2_1
                    .mul_add(
                        e0_ddot_of_motion_12_last,
                        e2_last.mul_add(e0_ddot_of_motion_12_1, next[67]),
                    ),
                e3_dot_1
                    .mul_add(e3_e2_dot_last, e3_dot_last.mul_add(e3_e2_dot_1, next[68])),
                e2_1
                    .mul_add(
                        e0_ddot_of_motion_14_last,
                        e2_last.mul_add(e0_ddot_of_motion_14_1, next[69]),
                    ),
                e0_ddot_of_motion_16_1
                    .mul_add(
                        e3_sq_last,
                        e0_ddot_of_motion_16_last.mul_add(e3_sq_1, next[70]),
                    ),
                w_S_1_2_of_e0_e1_e2_e3_1
                    .mul_add(
                        e0_ddot_of_motion_19_last,
                        w_S_1_2_of_e0_e1_e2_e3_last
                            .mul_add(e0_ddot_of_motion_19_1, next[71]),
                    ),
                e0_1
                    .mul_add(
                        e0_ddot_of_motion_19_last,
                        e0_last.mul_add(e0_ddot_of_motion_19_1, next[72]),
                    ),
                e1_1
                    .mul_add(
                        w1_dot_of_motion_2_last,
                        e1_last.mul_add(w1_dot_of_motion_2_1, next[73]),
                    ),
                e2_1
                    .mul_add(
                        w2_dot_of_motion_last,
                        e2_last.mul_add(w2_dot_of_motion_1, next[74]),
                    ),
                e3_1
                    .mul_add(
                        w3_dot_of_motion_11_last,
                        e3_last.mul_add(w3_dot_of_motion_11_1, next[75]),
                    ),
                e1_1
                    .mul_add(
                        e0_ddot_of_motion_19_last,
                        e1_last.mul_add(e0_ddot_of_motion_19_1, next[76]),
                    ),
                e0_1
                    .mul_add(
                        w1_dot_of_motion_2_last,
                        e0_last.mul_add(w1_dot_of_motion_2_1, next[77]),
                    ),
                e3_1
                    .mul_add(
                        w2_dot_of_motion_last,
                        e3_last.mul_add(w2_dot_of_motion_1, next[78]),
                    ),
                e2_1
                    .mul_add(
                        w3_dot_of_motion_11_last,
                        e2_last.mul_add(w3_dot_of_motion_11_1, next[79]),
                    ),
                e2_1
                    .mul_add(
                        e0_ddot_of_motion_19_last,
                        e2_last.mul_add(e0_ddot_of_motion_19_1, next[80]),
                    ),
                e3_1
                    .mul_add(
                        w1_dot_of_motion_2_last,
                        e3_last.mul_add(w1_dot_of_motion_2_1, next[81]),
                    ),
                e0_1
                    .mul_add(
                        w2_dot_of_motion_last,
                        e0_last.mul_add(w2_dot_of_motion_1, next[82]),
                    ),
                e1_1
                    .mul_add(
                        w3_dot_of_motion_11_last,
                        e1_last.mul_add(w3_dot_of_motion_11_1, next[83]),
                    ),
                e3_1
                    .mul_add(
                        e0_ddot_of_motion_19_last,
                        e3_last.mul_add(e0_ddot_of_motion_19_1, next[84]),
                    ),
                e2_1
                    .mul_add(
                        w1_dot_of_motion_2_last,
                        e2_last.mul_add(w1_dot_of_motion_2_1, next[85]),
                    ),
                e1_1
                    .mul_add(
                        w2_dot_of_motion_last,
                        e1_last.mul_add(w2_dot_of_motion_1, next[86]),
                    ),
                e0_1
                    .mul_add(
                        w3_dot_of_motion_11_last,
                        e0_last.mul_add(w3_dot_of_motion_11_1, next[87]),
                    ),
            ]
        };
        // e0_e1_dot = e0*e1_dot
        let e0_e1_dot = e1_dot.mul_add(e0_0, e0.mul_add(e1_dot_0, sums[0]));
        // e1_e0_dot = e1*e0_dot
        let e1_e0_dot = e0_dot.mul_add(e1_0, e1.mul_add(e0_dot_0, sums[1]));
        // e2_e3_dot = e2*e3_dot
        let e2_e3_dot = e3_dot.mul_add(e2_0, e2.mul_add(e3_dot_0, sums[2]));
        // e3_e2_dot = e3*e2_dot
        let e3_e2_dot = e2_dot.mul_add(e3_0, e3.mul_add(e2_dot_0, sums[3]));
        // w_S_1_of_motion = e0_e1_dot - e1_e0_dot - e2_e3_dot + e3_e2_dot
        let w_S_1_of_motion = e0_e1_dot + e3_e2_dot - e1_e0_dot - e2_e3_dot;
        // e0_sq = e0*e0
        let e0_sq = e0.mul_add(e0_0 + e0_0, sums[4]);
        // e1_sq = e1*e1
        let e1_sq = e1.mul_add(e1_0 + e1_0, sums[5]);
        // e2_sq = e2*e2
        let e2_sq = e2.mul_add(e2_0 + e2_0, sums[6]);
        // e3_sq = e3*e3
        let e3_sq = e3.mul_add(e3_0 + e3_0, sums[7]);
        // w_S_1_of_e0_e1_e2_e3 = e0_sq + e1_sq + e2_sq + e3_sq
        let w_S_1_of_e0_e1_e2_e3 = e0_sq + e1_sq + e2_sq + e3_sq;
        // w_S_1_of_motion_2 = w_S_1_of_motion/w_S_1_of_e0_e1_e2_e3
        let w_S_1_of_motion_2 = w_S_1_of_e0_e1_e2_e3
            .mul_add(
                -(w_S_1_of_motion_2_0 * over_w_S_1_of_e0_e1_e2_e3),
                (w_S_1_of_motion - sums[8]) * over_w_S_1_of_e0_e1_e2_e3,
            );
        // e0_e2_dot = e0*e2_dot
        let e0_e2_dot = e2_dot.mul_add(e0_0, e0.mul_add(e2_dot_0, sums[9]));
        // e2_e0_dot = e2*e0_dot
        let e2_e0_dot = e0_dot.mul_add(e2_0, e2.mul_add(e0_dot_0, sums[10]));
        // e3_e1_dot = e3*e1_dot
        let e3_e1_dot = e1_dot.mul_add(e3_0, e3.mul_add(e1_dot_0, sums[11]));
        // e1_e3_dot = e1*e3_dot
        let e1_e3_dot = e3_dot.mul_add(e1_0, e1.mul_add(e3_dot_0, sums[12]));
        // w_S_2_of_motion = e0_e2_dot - e2_e0_dot - e3_e1_dot + e1_e3_dot
        let w_S_2_of_motion = e0_e2_dot + e1_e3_dot - e2_e0_dot - e3_e1_dot;
        // w_S_2_of_motion_2 = w_S_2_of_motion/w_S_1_of_e0_e1_e2_e3
        let w_S_2_of_motion_2 = w_S_1_of_e0_e1_e2_e3
            .mul_add(
                -(w_S_2_of_motion_2_0 * over_w_S_1_of_e0_e1_e2_e3),
                (w_S_2_of_motion - sums[13]) * over_w_S_1_of_e0_e1_e2_e3,
            );
        // e0_e3_dot = e0*e3_dot
        let e0_e3_dot = e3_dot.mul_add(e0_0, e0.mul_add(e3_dot_0, sums[14]));
        // e3_e0_dot = e3*e0_dot
        let e3_e0_dot = e0_dot.mul_add(e3_0, e3.mul_add(e0_dot_0, sums[15]));
        // e1_e2_dot = e1*e2_dot
        let e1_e2_dot = e2_dot.mul_add(e1_0, e1.mul_add(e2_dot_0, sums[16]));
        // e2_e1_dot = e2*e1_dot
        let e2_e1_dot = e1_dot.mul_add(e2_0, e2.mul_add(e1_dot_0, sums[17]));
        // w_S_3_of_motion = e0_e3_dot - e3_e0_dot - e1_e2_dot + e2_e1_dot
        let w_S_3_of_motion = e0_e3_dot + e2_e1_dot - e3_e0_dot - e1_e2_dot;
        // w_S_3_of_motion_2 = w_S_3_of_motion/w_S_1_of_e0_e1_e2_e3
        let w_S_3_of_motion_2 = w_S_1_of_e0_e1_e2_e3
            .mul_add(
                -(w_S_3_of_motion_2_0 * over_w_S_1_of_e0_e1_e2_e3),
                (w_S_3_of_motion - sums[18]) * over_w_S_1_of_e0_e1_e2_e3,
            );
        // w_S_in_axle_base_1_of_motion = weight*w_S_1_of_motion_2 + weight_2*w_S_2_of_motion_2 +
        //   sqrt_3*w_S_3_of_motion_2
        let w_S_in_axle_base_1_of_motion = w_S_3_of_motion_2
            .mul_add(
                sqrt_3,
                w_S_2_of_motion_2.mul_add(weight_2, weight * w_S_1_of_motion_2),
            );
        // w_S_in_axle_base_2_of_motion = sqrt_3*w_S_3_of_motion_2 + weight_2*w_S_1_of_motion_2 +
        //   weight*w_S_2_of_motion_2
        let w_S_in_axle_base_2_of_motion = w_S_2_of_motion_2
            .mul_add(
                weight,
                w_S_1_of_motion_2.mul_add(weight_2, sqrt_3 * w_S_3_of_motion_2),
            );
        // w_W_turn1_3_of_phi_dot = 3*phi_dot + weight_3*w_S_3_of_motion_2 + weight_3*w_S_1_of_motion_2 +
        //   weight_3*w_S_2_of_motion_2
        let w_W_turn1_3_of_phi_dot = w_S_2_of_motion_2
            .mul_add(
                weight_3,
                w_S_1_of_motion_2
                    .mul_add(
                        weight_3,
                        w_S_3_of_motion_2.mul_add(weight_3, S::int(3) * phi_dot),
                    ),
            );
        // e0_e0_dot = e0*e0_dot
        let e0_e0_dot = e0_dot.mul_add(e0_0, e0.mul_add(e0_dot_0, sums[19]));
        // e1_e1_dot = e1*e1_dot
        let e1_e1_dot = e1_dot.mul_add(e1_0, e1.mul_add(e1_dot_0, sums[20]));
        // e2_e2_dot = e2*e2_dot
        let e2_e2_dot = e2_dot.mul_add(e2_0, e2.mul_add(e2_dot_0, sums[21]));
        // e3_e3_dot = e3*e3_dot
        let e3_e3_dot = e3_dot.mul_add(e3_0, e3.mul_add(e3_dot_0, sums[22]));
        // w_S_1_2_of_motion = e0_e0_dot + e1_e1_dot + e2_e2_dot + e3_e3_dot
        let w_S_1_2_of_motion = e0_e0_dot + e1_e1_dot + e2_e2_dot + e3_e3_dot;
        // w_S_1_2_of_e0_e1_e2_e3 = w_S_1_of_e0_e1_e2_e3*w_S_1_of_e0_e1_e2_e3
        let w_S_1_2_of_e0_e1_e2_e3 = w_S_1_of_e0_e1_e2_e3
            .mul_add(w_S_1_of_e0_e1_e2_e3_0 + w_S_1_of_e0_e1_e2_e3_0, sums[23]);
        // w_S_1_2_of_motion_2 = w_S_1_2_of_motion/w_S_1_2_of_e0_e1_e2_e3
        let w_S_1_2_of_motion_2 = w_S_1_2_of_e0_e1_e2_e3
            .mul_add(
                -(w_S_1_2_of_motion_2_0 * over_w_S_1_2_of_e0_e1_e2_e3),
                (w_S_1_2_of_motion - sums[24]) * over_w_S_1_2_of_e0_e1_e2_e3,
            );
        // w_S_1_2_of_motion_3 = w_S_1_of_motion*w_S_1_2_of_motion_2
        let w_S_1_2_of_motion_3 = w_S_1_2_of_motion_2
            .mul_add(
                w_S_1_of_motion_0,
                w_S_1_of_motion.mul_add(w_S_1_2_of_motion_2_0, sums[25]),
            );
        // w_S_2_2_of_motion = w_S_2_of_motion*w_S_1_2_of_motion_2
        let w_S_2_2_of_motion = w_S_1_2_of_motion_2
            .mul_add(
                w_S_2_of_motion_0,
                w_S_2_of_motion.mul_add(w_S_1_2_of_motion_2_0, sums[26]),
            );
        // w_S_3_2_of_motion = w_S_3_of_motion*w_S_1_2_of_motion_2
        let w_S_3_2_of_motion = w_S_1_2_of_motion_2
            .mul_add(
                w_S_3_of_motion_0,
                w_S_3_of_motion.mul_add(w_S_1_2_of_motion_2_0, sums[27]),
            );
        // w_S_in_axle_base_1_2_of_motion = weight*w_S_1_2_of_motion_3 + weight_2*w_S_2_2_of_motion +
        //   sqrt_3*w_S_3_2_of_motion
        let w_S_in_axle_base_1_2_of_motion = w_S_3_2_of_motion
            .mul_add(
                sqrt_3,
                w_S_2_2_of_motion.mul_add(weight_2, weight * w_S_1_2_of_motion_3),
            );
        // w_S_in_axle_base_2_2_of_motion = sqrt_3*w_S_3_2_of_motion + weight_2*w_S_1_2_of_motion_3 +
        //   weight*w_S_2_2_of_motion
        let w_S_in_axle_base_2_2_of_motion = w_S_2_2_of_motion
            .mul_add(
                weight,
                w_S_1_2_of_motion_3.mul_add(weight_2, sqrt_3 * w_S_3_2_of_motion),
            );
        // r1_of_place = weight_4 + weight_5*w_S_3_2_of_motion + weight_6*w_S_in_axle_base_1_2_of_motion +
        //   weight_7*w_S_in_axle_base_2_2_of_motion + weight_8*w_S_1_2_of_motion_3
        let r1_of_place = w_S_in_axle_base_2_2_of_motion
            .mul_add(
                weight_7,
                w_S_in_axle_base_1_2_of_motion
                    .mul_add(
                        weight_6,
                        w_S_1_2_of_motion_3
                            .mul_add(weight_8, weight_5 * w_S_3_2_of_motion),
                    ),
            );
        // r1_of_place_2 = e0*r1_of_place
        let r1_of_place_2 = r1_of_place
            .mul_add(e0_0, e0.mul_add(r1_of_place_0, sums[28]));
        // r1_of_place_3 = weight_9*w_S_1_of_motion_2 + weight_10*w_S_in_axle_base_1_of_motion +
        //   weight_11*w_S_in_axle_base_2_of_motion + weight_12*w_W_turn1_3_of_phi_dot +
        //   weight_13*w_S_3_of_motion_2
        let r1_of_place_3 = w_W_turn1_3_of_phi_dot
            .mul_add(
                weight_12,
                w_S_in_axle_base_2_of_motion
                    .mul_add(
                        weight_11,
                        w_S_in_axle_base_1_of_motion
                            .mul_add(
                                weight_10,
                                w_S_3_of_motion_2
                                    .mul_add(weight_13, weight_9 * w_S_1_of_motion_2),
                            ),
                    ),
            );
        // r1_of_e2_dot = e2_dot*r1_of_place_3
        let r1_of_e2_dot = r1_of_place_3
            .mul_add(e2_dot_0, e2_dot.mul_add(r1_of_place_3_0, sums[29]));
        // r1_of_place_4 = weight_14*w_S_2_of_motion_2 + j_sqrt_3*w_W_turn1_3_of_phi_dot +
        //   k_3_minus_sqrt_3*w_S_in_axle_base_1_of_motion +
        //   minus_k_3_plus_sqrt_3*w_S_in_axle_base_2_of_motion
        let r1_of_place_4 = w_S_in_axle_base_2_of_motion
            .mul_add(
                minus_k_3_plus_sqrt_3,
                w_S_in_axle_base_1_of_motion
                    .mul_add(
                        k_3_minus_sqrt_3,
                        w_W_turn1_3_of_phi_dot
                            .mul_add(j_sqrt_3, weight_14 * w_S_2_of_motion_2),
                    ),
            );
        // r1_of_e1_dot = e1_dot*r1_of_place_4
        let r1_of_e1_dot = r1_of_place_4
            .mul_add(e1_dot_0, e1_dot.mul_add(r1_of_place_4_0, sums[30]));
        // r1_of_e3_dot = e3_dot*r1_of_place_4
        let r1_of_e3_dot = r1_of_place_4
            .mul_add(e3_dot_0, e3_dot.mul_add(r1_of_place_4_0, sums[31]));
        // r1_of_motion = r1_of_place_2 + 2*r1_of_e2_dot - 2*r1_of_e1_dot + weight_15*r1_of_e3_dot
        let r1_of_motion = r1_of_e3_dot
            .mul_add(
                weight_15,
                r1_of_e1_dot.mul_add(-S::int(2), S::int(2) * r1_of_e2_dot),
            ) + r1_of_place_2;
        // r1_of_motion_2 = e0*r1_of_motion
        let r1_of_motion_2 = r1_of_motion
            .mul_add(e0_0, e0.mul_add(r1_of_motion_0, sums[32]));
        // r1_of_place_5 = e1*r1_of_place
        let r1_of_place_5 = r1_of_place
            .mul_add(e1_0, e1.mul_add(r1_of_place_0, sums[33]));
        // r1_of_e3_dot_2 = e3_dot*r1_of_place_3
        let r1_of_e3_dot_2 = r1_of_place_3
            .mul_add(e3_dot_0, e3_dot.mul_add(r1_of_place_3_0, sums[34]));
        // r1_of_e0_dot = e0_dot*r1_of_place_4
        let r1_of_e0_dot = r1_of_place_4
            .mul_add(e0_dot_0, e0_dot.mul_add(r1_of_place_4_0, sums[35]));
        // r1_of_e2_dot_2 = e2_dot*r1_of_place_4
        let r1_of_e2_dot_2 = r1_of_place_4
            .mul_add(e2_dot_0, e2_dot.mul_add(r1_of_place_4_0, sums[36]));
        // r1_of_motion_3 = r1_of_place_5 + 2*r1_of_e3_dot_2 + 2*r1_of_e0_dot + weight_16*r1_of_e2_dot_2
        let r1_of_motion_3 = r1_of_e2_dot_2
            .mul_add(
                weight_16,
                r1_of_e0_dot.mul_add(S::int(2), S::int(2) * r1_of_e3_dot_2),
            ) + r1_of_place_5;
        // r1_of_motion_4 = e1*r1_of_motion_3
        let r1_of_motion_4 = r1_of_motion_3
            .mul_add(e1_0, e1.mul_add(r1_of_motion_3_0, sums[37]));
        // r1_of_place_6 = e2*r1_of_place
        let r1_of_place_6 = r1_of_place
            .mul_add(e2_0, e2.mul_add(r1_of_place_0, sums[38]));
        // r1_of_e0_dot_2 = e0_dot*r1_of_place_3
        let r1_of_e0_dot_2 = r1_of_place_3
            .mul_add(e0_dot_0, e0_dot.mul_add(r1_of_place_3_0, sums[39]));
        // r1_of_motion_5 = r1_of_place_6 - 2*r1_of_e0_dot_2 + weight_15*r1_of_e1_dot + 2*r1_of_e3_dot
        let r1_of_motion_5 = r1_of_e3_dot
            .mul_add(
                S::int(2),
                r1_of_e1_dot.mul_add(weight_15, -S::int(2) * r1_of_e0_dot_2),
            ) + r1_of_place_6;
        // r1_of_motion_6 = e2*r1_of_motion_5
        let r1_of_motion_6 = r1_of_motion_5
            .mul_add(e2_0, e2.mul_add(r1_of_motion_5_0, sums[40]));
        // r1_of_place_7 = e3*r1_of_place
        let r1_of_place_7 = r1_of_place
            .mul_add(e3_0, e3.mul_add(r1_of_place_0, sums[41]));
        // r1_of_e1_dot_2 = e1_dot*r1_of_place_3
        let r1_of_e1_dot_2 = r1_of_place_3
            .mul_add(e1_dot_0, e1_dot.mul_add(r1_of_place_3_0, sums[42]));
        // r1_of_motion_7 = r1_of_place_7 - 2*r1_of_e1_dot_2 + weight_16*r1_of_e0_dot - 2*r1_of_e2_dot_2
        let r1_of_motion_7 = r1_of_e2_dot_2
            .mul_add(
                -S::int(2),
                r1_of_e0_dot.mul_add(weight_16, -S::int(2) * r1_of_e1_dot_2),
            ) + r1_of_place_7;
        // r1_of_motion_8 = e3*r1_of_motion_7
        let r1_of_motion_8 = r1_of_motion_7
            .mul_add(e3_0, e3.mul_add(r1_of_motion_7_0, sums[43]));
        // r1_of_motion_9 = r1_of_motion_2 + r1_of_motion_4 + r1_of_motion_6 + r1_of_motion_8
        let r1_of_motion_9 = r1_of_motion_2 + r1_of_motion_4 + r1_of_motion_6 + r1_of_motion_8;
        // r1_of_motion_10 = r1_of_motion_9/w_S_1_of_e0_e1_e2_e3
        let r1_of_motion_10 = r1_of_motion_9
            .mul_add(
                over_w_S_1_of_e0_e1_e2_e3,
                -(w_S_1_of_e0_e1_e2_e3.mul_add(r1_of_motion_10_0, sums[44])
                    * over_w_S_1_of_e0_e1_e2_e3),
            );
        // w3_dot_of_place = weight_17*w_S_in_axle_base_1_of_motion +
        //   weight_17*w_S_in_axle_base_2_of_motion + J*w_W_turn1_3_of_phi_dot
        let w3_dot_of_place = w_W_turn1_3_of_phi_dot
            .mul_add(
                J,
                w_S_in_axle_base_2_of_motion
                    .mul_add(weight_17, weight_17 * w_S_in_axle_base_1_of_motion),
            );
        // w3_dot_of_place_2 = weight_18 + weight_17*w_S_in_axle_base_1_2_of_motion +
        //   weight_17*w_S_in_axle_base_2_2_of_motion
        let w3_dot_of_place_2 = w_S_in_axle_base_2_2_of_motion
            .mul_add(weight_17, weight_17 * w_S_in_axle_base_1_2_of_motion);
        // w3_dot_of_place_3 = K*w_S_in_axle_base_1_of_motion + K*w_S_in_axle_base_2_of_motion +
        //   minus_j*w_W_turn1_3_of_phi_dot
        let w3_dot_of_place_3 = w_W_turn1_3_of_phi_dot
            .mul_add(
                minus_j,
                w_S_in_axle_base_2_of_motion.mul_add(K, K * w_S_in_axle_base_1_of_motion),
            );
        // w3_dot_of_place_4 = weight_19*w_S_1_2_of_motion_3 + minus_k*w_S_in_axle_base_1_2_of_motion +
        //   K*w_S_in_axle_base_2_2_of_motion
        let w3_dot_of_place_4 = w_S_in_axle_base_2_2_of_motion
            .mul_add(
                K,
                w_S_in_axle_base_1_2_of_motion
                    .mul_add(minus_k, weight_19 * w_S_1_2_of_motion_3),
            );
        // w3_dot_of_place_5 = weight_20*w_S_2_of_motion_2 + K*w_S_in_axle_base_1_of_motion +
        //   minus_k*w_S_in_axle_base_2_of_motion
        let w3_dot_of_place_5 = w_S_in_axle_base_2_of_motion
            .mul_add(
                minus_k,
                w_S_in_axle_base_1_of_motion.mul_add(K, weight_20 * w_S_2_of_motion_2),
            );
        // w3_dot_of_place_6 = weight_20*w_S_2_2_of_motion + K*w_S_in_axle_base_1_2_of_motion +
        //   minus_k*w_S_in_axle_base_2_2_of_motion
        let w3_dot_of_place_6 = w_S_in_axle_base_2_2_of_motion
            .mul_add(
                minus_k,
                w_S_in_axle_base_1_2_of_motion.mul_add(K, weight_20 * w_S_2_2_of_motion),
            );
        // w3_dot_of_place_7 = weight_19*w_S_1_of_motion_2 + minus_k*w_S_in_axle_base_1_of_motion +
        //   K*w_S_in_axle_base_2_of_motion
        let w3_dot_of_place_7 = w_S_in_axle_base_2_of_motion
            .mul_add(
                K,
                w_S_in_axle_base_1_of_motion
                    .mul_add(minus_k, weight_19 * w_S_1_of_motion_2),
            );
        // w3_dot_of_motion = w_S_2_of_motion*w3_dot_of_place
        let w3_dot_of_motion = w3_dot_of_place
            .mul_add(
                w_S_2_of_motion_0,
                w_S_2_of_motion.mul_add(w3_dot_of_place_0, sums[45]),
            );
        // w3_dot_of_place_8 = w_S_1_of_e0_e1_e2_e3*w3_dot_of_place_2
        let w3_dot_of_place_8 = w3_dot_of_place_2
            .mul_add(
                w_S_1_of_e0_e1_e2_e3_0,
                w_S_1_of_e0_e1_e2_e3.mul_add(w3_dot_of_place_2_0, sums[46]),
            );
        // w3_dot_of_motion_2 = w_S_3_of_motion*w3_dot_of_place_3
        let w3_dot_of_motion_2 = w3_dot_of_place_3
            .mul_add(
                w_S_3_of_motion_0,
                w_S_3_of_motion.mul_add(w3_dot_of_place_3_0, sums[47]),
            );
        // w3_dot_of_motion_3 = w_S_2_of_motion*w_S_3_of_motion_2
        let w3_dot_of_motion_3 = w_S_3_of_motion_2
            .mul_add(
                w_S_2_of_motion_0,
                w_S_2_of_motion.mul_add(w_S_3_of_motion_2_0, sums[48]),
            );
        // w3_dot_of_place_9 = w_S_1_of_e0_e1_e2_e3*w3_dot_of_place_4
        let w3_dot_of_place_9 = w3_dot_of_place_4
            .mul_add(
                w_S_1_of_e0_e1_e2_e3_0,
                w_S_1_of_e0_e1_e2_e3.mul_add(w3_dot_of_place_4_0, sums[49]),
            );
        // w3_dot_of_motion_4 = w_S_3_of_motion*w3_dot_of_place_5
        let w3_dot_of_motion_4 = w3_dot_of_place_5
            .mul_add(
                w_S_3_of_motion_0,
                w_S_3_of_motion.mul_add(w3_dot_of_place_5_0, sums[50]),
            );
        // w3_dot_of_motion_5 = weight_3*w3_dot_of_motion + sqrt_3*w3_dot_of_place_8 +
        //   weight_3*w3_dot_of_motion_2 + weight_5*w3_dot_of_motion_3 - 6*w3_dot_of_place_9 -
        //   6*w3_dot_of_motion_4
        let w3_dot_of_motion_5 = w3_dot_of_place_9
            .mul_add(
                -S::int(6),
                w3_dot_of_place_8
                    .mul_add(
                        sqrt_3,
                        w3_dot_of_motion_4
                            .mul_add(
                                -S::int(6),
                                w3_dot_of_motion_2
                                    .mul_add(
                                        weight_3,
                                        w3_dot_of_motion
                                            .mul_add(weight_3, weight_5 * w3_dot_of_motion_3),
                                    ),
                            ),
                    ),
            );
        // w3_dot_of_motion_6 = w_S_1_of_motion*w3_dot_of_place
        let w3_dot_of_motion_6 = w3_dot_of_place
            .mul_add(
                w_S_1_of_motion_0,
                w_S_1_of_motion.mul_add(w3_dot_of_place_0, sums[51]),
            );
        // w3_dot_of_motion_7 = w_S_1_of_motion*w_S_3_of_motion_2
        let w3_dot_of_motion_7 = w_S_3_of_motion_2
            .mul_add(
                w_S_1_of_motion_0,
                w_S_1_of_motion.mul_add(w_S_3_of_motion_2_0, sums[52]),
            );
        // w3_dot_of_place_10 = w_S_1_of_e0_e1_e2_e3*w3_dot_of_place_6
        let w3_dot_of_place_10 = w3_dot_of_place_6
            .mul_add(
                w_S_1_of_e0_e1_e2_e3_0,
                w_S_1_of_e0_e1_e2_e3.mul_add(w3_dot_of_place_6_0, sums[53]),
            );
        // w3_dot_of_motion_8 = w_S_3_of_motion*w3_dot_of_place_7
        let w3_dot_of_motion_8 = w3_dot_of_place_7
            .mul_add(
                w_S_3_of_motion_0,
                w_S_3_of_motion.mul_add(w3_dot_of_place_7_0, sums[54]),
            );
        // w3_dot_of_motion_9 = k_by_3_a_plus_2_k*w3_dot_of_motion_5 + sqrt_3*w3_dot_of_place_8 +
        //   minus_2_sqrt_3*w3_dot_of_motion_2 + minus_2_sqrt_3*w3_dot_of_motion_6 +
        //   minus_36_c*w3_dot_of_motion_7 - 6*w3_dot_of_place_10 + 6*w3_dot_of_motion_8
        let w3_dot_of_motion_9 = w3_dot_of_motion_5
            .mul_add(
                k_by_3_a_plus_2_k,
                w3_dot_of_place_10
                    .mul_add(
                        -S::int(6),
                        w3_dot_of_place_8
                            .mul_add(
                                sqrt_3,
                                w3_dot_of_motion_8
                                    .mul_add(
                                        S::int(6),
                                        w3_dot_of_motion_6
                                            .mul_add(
                                                minus_2_sqrt_3,
                                                w3_dot_of_motion_2
                                                    .mul_add(minus_2_sqrt_3, minus_36_c * w3_dot_of_motion_7),
                                            ),
                                    ),
                            ),
                    ),
            );
        // w3_dot_of_motion_10 = w3_dot_of_motion_9/w_S_1_of_e0_e1_e2_e3
        let w3_dot_of_motion_10 = w3_dot_of_motion_9
            .mul_add(
                over_w_S_1_of_e0_e1_e2_e3,
                -(w_S_1_of_e0_e1_e2_e3.mul_add(w3_dot_of_motion_10_0, sums[55])
                    * over_w_S_1_of_e0_e1_e2_e3),
            );
        // w3_dot_of_motion_11 = 1/3*r1_of_motion_10 + weight_21*w3_dot_of_motion_10
        let w3_dot_of_motion_11 = r1_of_motion_10
            .mul_add(S::ratio(1, 3), weight_21 * w3_dot_of_motion_10);
        // w2_dot_of_motion = w3_dot_of_motion_10 + weight_22*w3_dot_of_motion_11
        let w2_dot_of_motion = w3_dot_of_motion_11
            .mul_add(weight_22, w3_dot_of_motion_10);
        // w1_dot_of_motion = w3_dot_of_motion_5/w_S_1_of_e0_e1_e2_e3
        let w1_dot_of_motion = w3_dot_of_motion_5
            .mul_add(
                over_w_S_1_of_e0_e1_e2_e3,
                -(w_S_1_of_e0_e1_e2_e3.mul_add(w1_dot_of_motion_0, sums[56])
                    * over_w_S_1_of_e0_e1_e2_e3),
            );
        // w1_dot_of_motion_2 = weight_23*w2_dot_of_motion + weight_24*w3_dot_of_motion_11 -
        //   w1_dot_of_motion
        let w1_dot_of_motion_2 = w2_dot_of_motion
            .mul_add(
                weight_23,
                w3_dot_of_motion_11.mul_add(weight_24, -w1_dot_of_motion),
            );
        // phi_dot_dot = t_by_j + weight_25*w1_dot_of_motion_2 + weight_26*w2_dot_of_motion +
        //   weight_27*w3_dot_of_motion_11 + weight_28*w_S_3_2_of_motion + weight_28*w_S_1_2_of_motion_3 +
        //   weight_28*w_S_2_2_of_motion
        let phi_dot_dot = w1_dot_of_motion_2
            .mul_add(
                weight_25,
                w2_dot_of_motion
                    .mul_add(
                        weight_26,
                        w3_dot_of_motion_11
                            .mul_add(
                                weight_27,
                                w_S_2_2_of_motion
                                    .mul_add(
                                        weight_28,
                                        w_S_1_2_of_motion_3
                                            .mul_add(weight_28, weight_28 * w_S_3_2_of_motion),
                                    ),
                            ),
                    ),
            );
        // e0_dot_sq = e0_dot*e0_dot
        let e0_dot_sq = e0_dot.mul_add(e0_dot_0 + e0_dot_0, sums[57]);
        // e1_dot_sq = e1_dot*e1_dot
        let e1_dot_sq = e1_dot.mul_add(e1_dot_0 + e1_dot_0, sums[58]);
        // e2_dot_sq = e2_dot*e2_dot
        let e2_dot_sq = e2_dot.mul_add(e2_dot_0 + e2_dot_0, sums[59]);
        // e3_dot_sq = e3_dot*e3_dot
        let e3_dot_sq = e3_dot.mul_add(e3_dot_0 + e3_dot_0, sums[60]);
        // e0_ddot_of_motion = e1_dot_sq + e2_dot_sq + e3_dot_sq
        let e0_ddot_of_motion = e1_dot_sq + e2_dot_sq + e3_dot_sq;
        // e0_ddot_of_motion_2 = e0*e0_ddot_of_motion
        let e0_ddot_of_motion_2 = e0_ddot_of_motion
            .mul_add(e0_0, e0.mul_add(e0_ddot_of_motion_0, sums[61]));
        // e0_ddot_of_motion_3 = e1_e1_dot + e2_e2_dot + e3_e3_dot
        let e0_ddot_of_motion_3 = e1_e1_dot + e2_e2_dot + e3_e3_dot;
        // e0_ddot_of_motion_4 = e0_dot*e0_ddot_of_motion_3
        let e0_ddot_of_motion_4 = e0_ddot_of_motion_3
            .mul_add(e0_dot_0, e0_dot.mul_add(e0_ddot_of_motion_3_0, sums[62]));
        // e0_ddot_of_motion_5 = e0_ddot_of_motion_2 - 2*e0_ddot_of_motion_4
        let e0_ddot_of_motion_5 = e0_ddot_of_motion_4
            .mul_add(-S::int(2), e0_ddot_of_motion_2);
        // e0_ddot_of_motion_6 = e0*e0_ddot_of_motion_5
        let e0_ddot_of_motion_6 = e0_ddot_of_motion_5
            .mul_add(e0_0, e0.mul_add(e0_ddot_of_motion_5_0, sums[63]));
        // e0_ddot_of_motion_7 = e0_dot_sq + e2_dot_sq + e3_dot_sq
        let e0_ddot_of_motion_7 = e0_dot_sq + e2_dot_sq + e3_dot_sq;
        // e0_ddot_of_motion_8 = e1*e0_ddot_of_motion_7
        let e0_ddot_of_motion_8 = e0_ddot_of_motion_7
            .mul_add(e1_0, e1.mul_add(e0_ddot_of_motion_7_0, sums[64]));
        // e2_e2_dot_plus_e3_e3_dot = e2_e2_dot + e3_e3_dot
        let e2_e2_dot_plus_e3_e3_dot = e2_e2_dot + e3_e3_dot;
        // e0_ddot_of_motion_9 = e1_dot*e2_e2_dot_plus_e3_e3_dot
        let e0_ddot_of_motion_9 = e2_e2_dot_plus_e3_e3_dot
            .mul_add(e1_dot_0, e1_dot.mul_add(e2_e2_dot_plus_e3_e3_dot_0, sums[65]));
        // e0_ddot_of_motion_10 = e0_ddot_of_motion_8 - 2*e0_ddot_of_motion_9
        let e0_ddot_of_motion_10 = e0_ddot_of_motion_9
            .mul_add(-S::int(2), e0_ddot_of_motion_8);
        // e0_ddot_of_motion_11 = e1*e0_ddot_of_motion_10
        let e0_ddot_of_motion_11 = e0_ddot_of_motion_10
            .mul_add(e1_0, e1.mul_add(e0_ddot_of_motion_10_0, sums[66]));
        // e0_ddot_of_motion_12 = e0_dot_sq + e1_dot_sq + e3_dot_sq
        let e0_ddot_of_motion_12 = e0_dot_sq + e1_dot_sq + e3_dot_sq;
        // e0_ddot_of_motion_13 = e2*e0_ddot_of_motion_12
        let e0_ddot_of_motion_13 = e0_ddot_of_motion_12
            .mul_add(e2_0, e2.mul_add(e0_ddot_of_motion_12_0, sums[67]));
        // e3_e2_dot_e3_dot = e3_dot*e3_e2_dot
        let e3_e2_dot_e3_dot = e3_e2_dot
            .mul_add(e3_dot_0, e3_dot.mul_add(e3_e2_dot_0, sums[68]));
        // e0_ddot_of_motion_14 = e0_ddot_of_motion_13 - 2*e3_e2_dot_e3_dot
        let e0_ddot_of_motion_14 = -S::int(2) * e3_e2_dot_e3_dot + e0_ddot_of_motion_13;
        // e0_ddot_of_motion_15 = e2*e0_ddot_of_motion_14
        let e0_ddot_of_motion_15 = e0_ddot_of_motion_14
            .mul_add(e2_0, e2.mul_add(e0_ddot_of_motion_14_0, sums[69]));
        // e0_ddot_of_motion_16 = e0_dot_sq + e1_dot_sq + e2_dot_sq
        let e0_ddot_of_motion_16 = e0_dot_sq + e1_dot_sq + e2_dot_sq;
        // e0_ddot_of_motion_17 = e0_ddot_of_motion_16*e3_sq
        let e0_ddot_of_motion_17 = e0_ddot_of_motion_16
            .mul_add(e3_sq_0, e3_sq.mul_add(e0_ddot_of_motion_16_0, sums[70]));
        // e0_ddot_of_motion_18 = e0_ddot_of_motion_6 + e0_ddot_of_motion_11 + e0_ddot_of_motion_15 +
        //   e0_ddot_of_motion_17
        let e0_ddot_of_motion_18 = e0_ddot_of_motion_17 + e0_ddot_of_motion_6
            + e0_ddot_of_motion_11 + e0_ddot_of_motion_15;
        // e0_ddot_of_motion_19 = e0_ddot_of_motion_18/w_S_1_2_of_e0_e1_e2_e3
        let e0_ddot_of_motion_19 = e0_ddot_of_motion_18
            .mul_add(
                over_w_S_1_2_of_e0_e1_e2_e3,
                -(w_S_1_2_of_e0_e1_e2_e3.mul_add(e0_ddot_of_motion_19_0, sums[71])
                    * over_w_S_1_2_of_e0_e1_e2_e3),
            );
        // e0_ddot_of_motion_20 = e0*e0_ddot_of_motion_19
        let e0_ddot_of_motion_20 = e0_ddot_of_motion_19
            .mul_add(e0_0, e0.mul_add(e0_ddot_of_motion_19_0, sums[72]));
        // e0_ddot_of_motion_21 = e1*w1_dot_of_motion_2
        let e0_ddot_of_motion_21 = w1_dot_of_motion_2
            .mul_add(e1_0, e1.mul_add(w1_dot_of_motion_2_0, sums[73]));
        // e0_ddot_of_motion_22 = e2*w2_dot_of_motion
        let e0_ddot_of_motion_22 = w2_dot_of_motion
            .mul_add(e2_0, e2.mul_add(w2_dot_of_motion_0, sums[74]));
        // e0_ddot_of_motion_23 = e3*w3_dot_of_motion_11
        let e0_ddot_of_motion_23 = w3_dot_of_motion_11
            .mul_add(e3_0, e3.mul_add(w3_dot_of_motion_11_0, sums[75]));
        // e0_dot_dot = -e0_ddot_of_motion_20 + weight_29*e0_ddot_of_motion_21 +
        //   weight_30*e0_ddot_of_motion_22 + weight_31*e0_ddot_of_motion_23
        let e0_dot_dot = e0_ddot_of_motion_21
            .mul_add(
                weight_29,
                e0_ddot_of_motion_22
                    .mul_add(
                        weight_30,
                        e0_ddot_of_motion_23.mul_add(weight_31, -e0_ddot_of_motion_20),
                    ),
            );
        // e1_ddot_of_motion = e1*e0_ddot_of_motion_19
        let e1_ddot_of_motion = e0_ddot_of_motion_19
            .mul_add(e1_0, e1.mul_add(e0_ddot_of_motion_19_0, sums[76]));
        // e1_ddot_of_motion_2 = e0*w1_dot_of_motion_2
        let e1_ddot_of_motion_2 = w1_dot_of_motion_2
            .mul_add(e0_0, e0.mul_add(w1_dot_of_motion_2_0, sums[77]));
        // e1_ddot_of_motion_3 = e3*w2_dot_of_motion
        let e1_ddot_of_motion_3 = w2_dot_of_motion
            .mul_add(e3_0, e3.mul_add(w2_dot_of_motion_0, sums[78]));
        // e1_ddot_of_motion_4 = e2*w3_dot_of_motion_11
        let e1_ddot_of_motion_4 = w3_dot_of_motion_11
            .mul_add(e2_0, e2.mul_add(w3_dot_of_motion_11_0, sums[79]));
        // e1_dot_dot = -e1_ddot_of_motion + weight_32*e1_ddot_of_motion_2 + weight_30*e1_ddot_of_motion_3
        //   + weight_33*e1_ddot_of_motion_4
        let e1_dot_dot = e1_ddot_of_motion_2
            .mul_add(
                weight_32,
                e1_ddot_of_motion_3
                    .mul_add(
                        weight_30,
                        e1_ddot_of_motion_4.mul_add(weight_33, -e1_ddot_of_motion),
                    ),
            );
        // e2_ddot_of_motion = e2*e0_ddot_of_motion_19
        let e2_ddot_of_motion = e0_ddot_of_motion_19
            .mul_add(e2_0, e2.mul_add(e0_ddot_of_motion_19_0, sums[80]));
        // e2_ddot_of_motion_2 = e3*w1_dot_of_motion_2
        let e2_ddot_of_motion_2 = w1_dot_of_motion_2
            .mul_add(e3_0, e3.mul_add(w1_dot_of_motion_2_0, sums[81]));
        // e2_ddot_of_motion_3 = e0*w2_dot_of_motion
        let e2_ddot_of_motion_3 = w2_dot_of_motion
            .mul_add(e0_0, e0.mul_add(w2_dot_of_motion_0, sums[82]));
        // e2_ddot_of_motion_4 = e1*w3_dot_of_motion_11
        let e2_ddot_of_motion_4 = w3_dot_of_motion_11
            .mul_add(e1_0, e1.mul_add(w3_dot_of_motion_11_0, sums[83]));
        // e2_dot_dot = -e2_ddot_of_motion + weight_32*e2_ddot_of_motion_2 + weight_34*e2_ddot_of_motion_3
        //   + weight_31*e2_ddot_of_motion_4
        let e2_dot_dot = e2_ddot_of_motion_2
            .mul_add(
                weight_32,
                e2_ddot_of_motion_3
                    .mul_add(
                        weight_34,
                        e2_ddot_of_motion_4.mul_add(weight_31, -e2_ddot_of_motion),
                    ),
            );
        // e3_ddot_of_motion = e3*e0_ddot_of_motion_19
        let e3_ddot_of_motion = e0_ddot_of_motion_19
            .mul_add(e3_0, e3.mul_add(e0_ddot_of_motion_19_0, sums[84]));
        // e3_ddot_of_motion_2 = e2*w1_dot_of_motion_2
        let e3_ddot_of_motion_2 = w1_dot_of_motion_2
            .mul_add(e2_0, e2.mul_add(w1_dot_of_motion_2_0, sums[85]));
        // e3_ddot_of_motion_3 = e1*w2_dot_of_motion
        let e3_ddot_of_motion_3 = w2_dot_of_motion
            .mul_add(e1_0, e1.mul_add(w2_dot_of_motion_0, sums[86]));
        // e3_ddot_of_motion_4 = e0*w3_dot_of_motion_11
        let e3_ddot_of_motion_4 = w3_dot_of_motion_11
            .mul_add(e0_0, e0.mul_add(w3_dot_of_motion_11_0, sums[87]));
        // e3_dot_dot = -e3_ddot_of_motion + weight_29*e3_ddot_of_motion_2 + weight_34*e3_ddot_of_motion_3
        //   + weight_33*e3_ddot_of_motion_4
        let e3_dot_dot = e3_ddot_of_motion_2
            .mul_add(
                weight_29,
                e3_ddot_of_motion_3
                    .mul_add(
                        weight_34,
                        e3_ddot_of_motion_4.mul_add(weight_33, -e3_ddot_of_motion),
                    ),
            );
        e0_rate = e0_dot;
        e1_rate = e1_dot;
        e2_rate = e2_dot;
        e3_rate = e3_dot;
        phi_rate = phi_dot;
        e0_dot_rate = e0_dot_dot;
        e1_dot_rate = e1_dot_dot;
        e2_dot_rate = e2_dot_dot;
        e3_dot_rate = e3_dot_dot;
        phi_dot_rate = phi_dot_dot;
        // Factors of the convolutions: left, right.
        history[order] = [
            [
                e0, e1, e2, e3, e0, e1, e2, e3, w_S_1_of_e0_e1_e2_e3, e0, e2, e3, e1,
                w_S_1_of_e0_e1_e2_e3, e0, e3, e1, e2, w_S_1_of_e0_e1_e2_e3, e0, e1, e2, e3,
                w_S_1_of_e0_e1_e2_e3, w_S_1_2_of_e0_e1_e2_e3, w_S_1_of_motion, w_S_2_of_motion,
                w_S_3_of_motion, e0, e2_dot, e1_dot, e3_dot, e0, e1, e3_dot, e0_dot, e2_dot, e1, e2,
                e0_dot, e2, e3, e1_dot, e3, w_S_1_of_e0_e1_e2_e3, w_S_2_of_motion,
                w_S_1_of_e0_e1_e2_e3, w_S_3_of_motion, w_S_2_of_motion, w_S_1_of_e0_e1_e2_e3,
                w_S_3_of_motion, w_S_1_of_motion, w_S_1_of_motion, w_S_1_of_e0_e1_e2_e3,
                w_S_3_of_motion, w_S_1_of_e0_e1_e2_e3, w_S_1_of_e0_e1_e2_e3, e0_dot, e1_dot, e2_dot,
                e3_dot, e0, e0_dot, e0, e1, e1_dot, e1, e2, e3_dot, e2, e0_ddot_of_motion_16,
                w_S_1_2_of_e0_e1_e2_e3, e0, e1, e2, e3, e1, e0, e3, e2, e2, e3, e0, e1, e3, e2, e1,
                e0,
            ],
            [
                e1_dot, e0_dot, e3_dot, e2_dot, e0, e1, e2, e3, w_S_1_of_motion_2, e2_dot, e0_dot,
                e1_dot, e3_dot, w_S_2_of_motion_2, e3_dot, e0_dot, e2_dot, e1_dot,
                w_S_3_of_motion_2, e0_dot, e1_dot, e2_dot, e3_dot, w_S_1_of_e0_e1_e2_e3,
                w_S_1_2_of_motion_2, w_S_1_2_of_motion_2, w_S_1_2_of_motion_2, w_S_1_2_of_motion_2,
                r1_of_place, r1_of_place_3, r1_of_place_4, r1_of_place_4, r1_of_motion, r1_of_place,
                r1_of_place_3, r1_of_place_4, r1_of_place_4, r1_of_motion_3, r1_of_place,
                r1_of_place_3, r1_of_motion_5, r1_of_place, r1_of_place_3, r1_of_motion_7,
                r1_of_motion_10, w3_dot_of_place, w3_dot_of_place_2, w3_dot_of_place_3,
                w_S_3_of_motion_2, w3_dot_of_place_4, w3_dot_of_place_5, w3_dot_of_place,
                w_S_3_of_motion_2, w3_dot_of_place_6, w3_dot_of_place_7, w3_dot_of_motion_10,
                w1_dot_of_motion, e0_dot, e1_dot, e2_dot, e3_dot, e0_ddot_of_motion,
                e0_ddot_of_motion_3, e0_ddot_of_motion_5, e0_ddot_of_motion_7,
                e2_e2_dot_plus_e3_e3_dot, e0_ddot_of_motion_10, e0_ddot_of_motion_12, e3_e2_dot,
                e0_ddot_of_motion_14, e3_sq, e0_ddot_of_motion_19, e0_ddot_of_motion_19,
                w1_dot_of_motion_2, w2_dot_of_motion, w3_dot_of_motion_11, e0_ddot_of_motion_19,
                w1_dot_of_motion_2, w2_dot_of_motion, w3_dot_of_motion_11, e0_ddot_of_motion_19,
                w1_dot_of_motion_2, w2_dot_of_motion, w3_dot_of_motion_11, e0_ddot_of_motion_19,
                w1_dot_of_motion_2, w2_dot_of_motion, w3_dot_of_motion_11,
            ],
        ];
        e0_last = e0;
        e1_last = e1;
        e2_last = e2;
        e3_last = e3;
        e0_dot_last = e0_dot;
        e1_dot_last = e1_dot;
        e2_dot_last = e2_dot;
        e3_dot_last = e3_dot;
        e3_e2_dot_last = e3_e2_dot;
        w_S_1_of_motion_last = w_S_1_of_motion;
        e3_sq_last = e3_sq;
        w_S_1_of_e0_e1_e2_e3_last = w_S_1_of_e0_e1_e2_e3;
        w_S_1_of_motion_2_last = w_S_1_of_motion_2;
        w_S_2_of_motion_last = w_S_2_of_motion;
        w_S_2_of_motion_2_last = w_S_2_of_motion_2;
        w_S_3_of_motion_last = w_S_3_of_motion;
        w_S_3_of_motion_2_last = w_S_3_of_motion_2;
        w_S_1_2_of_e0_e1_e2_e3_last = w_S_1_2_of_e0_e1_e2_e3;
        w_S_1_2_of_motion_2_last = w_S_1_2_of_motion_2;
        r1_of_place_last = r1_of_place;
        r1_of_place_3_last = r1_of_place_3;
        r1_of_place_4_last = r1_of_place_4;
        r1_of_motion_last = r1_of_motion;
        r1_of_motion_3_last = r1_of_motion_3;
        r1_of_motion_5_last = r1_of_motion_5;
        r1_of_motion_7_last = r1_of_motion_7;
        r1_of_motion_10_last = r1_of_motion_10;
        w3_dot_of_place_last = w3_dot_of_place;
        w3_dot_of_place_2_last = w3_dot_of_place_2;
        w3_dot_of_place_3_last = w3_dot_of_place_3;
        w3_dot_of_place_4_last = w3_dot_of_place_4;
        w3_dot_of_place_5_last = w3_dot_of_place_5;
        w3_dot_of_place_6_last = w3_dot_of_place_6;
        w3_dot_of_place_7_last = w3_dot_of_place_7;
        w3_dot_of_motion_10_last = w3_dot_of_motion_10;
        w3_dot_of_motion_11_last = w3_dot_of_motion_11;
        w2_dot_of_motion_last = w2_dot_of_motion;
        w1_dot_of_motion_last = w1_dot_of_motion;
        w1_dot_of_motion_2_last = w1_dot_of_motion_2;
        e0_ddot_of_motion_last = e0_ddot_of_motion;
        e0_ddot_of_motion_3_last = e0_ddot_of_motion_3;
        e0_ddot_of_motion_5_last = e0_ddot_of_motion_5;
        e0_ddot_of_motion_7_last = e0_ddot_of_motion_7;
        e2_e2_dot_plus_e3_e3_dot_last = e2_e2_dot_plus_e3_e3_dot;
        e0_ddot_of_motion_10_last = e0_ddot_of_motion_10;
        e0_ddot_of_motion_12_last = e0_ddot_of_motion_12;
        e0_ddot_of_motion_14_last = e0_ddot_of_motion_14;
        e0_ddot_of_motion_16_last = e0_ddot_of_motion_16;
        e0_ddot_of_motion_19_last = e0_ddot_of_motion_19;
    }
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
        out.copy_from_slice(
            jacobian(&Parameters::from_slice(p), array(q), array(v)).as_flattened(),
        );
    }
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, order: usize) -> usize {
        176 * order + SLACK
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
    slice.try_into().expect("a slice of the length that System states")
}
