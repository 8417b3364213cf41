//! Bricard's mechanism: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/bricard/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows q_P1, q_P2, q_P3, q_P4, q_P5, constraint P6_1, constraint P6_2, constraint P6_3, constraint P6_turn13.
///
/// 519 operations, 5 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _q_dot: &[S; 5],
) -> [[S; 9]; 9] {
    let Parameters { l, m, .. } = *p;
    let [q_P1, q_P2, q_P3, q_P4, q_P5] = *q;
    // Sines and cosines.
    let (sin_q_P2, cos_q_P2) = q_P2.sin_cos();
    let (sin_q_P3, cos_q_P3) = q_P3.sin_cos();
    let (sin_q_P4, cos_q_P4) = q_P4.sin_cos();
    let (sin_q_P5, cos_q_P5) = q_P5.sin_cos();
    let (sin_q_P1, cos_q_P1) = q_P1.sin_cos();
    // Step by step, each after the terms that it needs.
    let mp_rod1_frame_1 = l * m;
    let w_rod2_frame_in_rod3_frame_2_3 = cos_q_P2 * cos_q_P3;
    let w_rod2_frame_in_rod3_frame_3_3 = cos_q_P2 * sin_q_P3;
    let sin_q_p2_cos_q_p4 = sin_q_P2 * cos_q_P4;
    let w_rod3_frame_in_rod4_frame_1_3 = w_rod2_frame_in_rod3_frame_3_3
        .mul_add(sin_q_P4, sin_q_p2_cos_q_p4);
    let sin_q_p2_sin_q_p4 = sin_q_P2 * sin_q_P4;
    let w_rod3_frame_in_rod4_frame_3_3 = (-w_rod2_frame_in_rod3_frame_3_3)
        .mul_add(cos_q_P4, sin_q_p2_sin_q_p4);
    let w_rod4_frame_in_rod5_frame_1_3 = w_rod3_frame_in_rod4_frame_1_3
        .mul_add(cos_q_P5, w_rod2_frame_in_rod3_frame_2_3 * sin_q_P5);
    let H_rod1_2 = l * mp_rod1_frame_1;
    let l_doubled = S::int(2) * l;
    let l_sin_q_p2 = l * sin_q_P2;
    let v_rod2_centre_3_3 = l_doubled - l_sin_q_p2;
    let H_rod2_1_3 = H_rod1_2 * sin_q_P2;
    let v_rod3_centre_3_2 = l - l_sin_q_p2;
    let v_rod2_frame_in_rod3_frame_2_3 = v_rod3_centre_3_2 * sin_q_P3;
    let v_rod2_frame_in_rod3_frame_3_3 = v_rod3_centre_3_2 * cos_q_P3;
    let v_rod3_centre_1_3 = l * w_rod2_frame_in_rod3_frame_2_3;
    let v_rod3_centre_2_3 = v_rod2_frame_in_rod3_frame_2_3
        .mul_add(S::int(2), l_sin_q_p2);
    let H_rod3_2_3 = w_rod2_frame_in_rod3_frame_2_3 * H_rod1_2;
    let v_rod4_centre_2_5 = v_rod2_frame_in_rod3_frame_2_3 + l_sin_q_p2;
    let v_rod3_frame_in_rod4_frame_1_3 = v_rod3_centre_1_3
        .mul_add(cos_q_P4, v_rod2_frame_in_rod3_frame_3_3 * sin_q_P4);
    let v_rod3_frame_in_rod4_frame_3_3 = (-v_rod3_centre_1_3)
        .mul_add(sin_q_P4, v_rod2_frame_in_rod3_frame_3_3 * cos_q_P4);
    let v_rod4_centre_2_6_of_place = l * w_rod3_frame_in_rod4_frame_3_3;
    let v_rod4_centre_2_6 = v_rod4_centre_2_5
        .mul_add(S::int(2), v_rod4_centre_2_6_of_place);
    let v_rod4_centre_3_3 = (-v_rod3_frame_in_rod4_frame_3_3)
        .mul_add(S::int(2), v_rod3_centre_1_3);
    let H_rod4_3_3 = w_rod3_frame_in_rod4_frame_3_3 * H_rod1_2;
    let v_rod5_centre_2_3 = v_rod4_centre_2_5 + v_rod4_centre_2_6_of_place;
    let v_rod5_centre_3_5 = v_rod3_centre_1_3 - v_rod3_frame_in_rod4_frame_3_3;
    let v_rod4_frame_in_rod5_frame_1_3 = (-v_rod5_centre_2_3)
        .mul_add(sin_q_P5, v_rod3_frame_in_rod4_frame_1_3 * cos_q_P5);
    let v_rod4_frame_in_rod5_frame_2_3 = v_rod5_centre_2_3
        .mul_add(cos_q_P5, v_rod3_frame_in_rod4_frame_1_3 * sin_q_P5);
    let v_rod5_centre_1_3 = v_rod4_frame_in_rod5_frame_1_3
        .mul_add(S::int(2), v_rod4_centre_2_6_of_place);
    let v_rod5_centre_3_6 = (-v_rod5_centre_3_5)
        .mul_add(S::int(2), l * w_rod4_frame_in_rod5_frame_1_3);
    let H_rod5_1_3 = w_rod4_frame_in_rod5_frame_1_3 * H_rod1_2;
    let p_v_rod5_centre_3_3 = m * v_rod5_centre_3_6;
    let p_v_rod5_centre_1_3 = m * v_rod5_centre_1_3;
    let p_v_rod4_frame_in_rod5_frame_2_3 = m * v_rod4_frame_in_rod5_frame_2_3;
    let cos_q_p5_doubled = S::int(2) * cos_q_P5;
    let p_v_rod5_centre_2_3 = (-p_v_rod5_centre_1_3)
        .mul_add(sin_q_P5, p_v_rod4_frame_in_rod5_frame_2_3 * cos_q_p5_doubled);
    let p_v_rod4_centre_3_3 = m * v_rod4_centre_3_3;
    let p_v_rod4_centre_2_5 = m * v_rod4_centre_2_6;
    let p_v_rod3_frame_in_rod4_frame_3_3 = p_v_rod5_centre_3_3 - p_v_rod4_centre_3_3;
    let m_doubled = S::int(2) * m;
    let sin_q_p5_doubled = S::int(2) * sin_q_P5;
    let p_v_rod3_frame_in_rod4_frame_1_3 = v_rod3_frame_in_rod4_frame_1_3
        .mul_add(m_doubled, p_v_rod5_centre_1_3 * cos_q_P5)
        + p_v_rod4_frame_in_rod5_frame_2_3 * sin_q_p5_doubled;
    let p_v_rod4_centre_2_6 = p_v_rod5_centre_2_3 + p_v_rod4_centre_2_5;
    let p_v_rod4_centre_1_3 = (-p_v_rod3_frame_in_rod4_frame_1_3)
        .mul_add(cos_q_P4, p_v_rod3_frame_in_rod4_frame_3_3 * sin_q_P4);
    let p_v_rod3_centre_2_3 = m * v_rod3_centre_2_3;
    let p_v_rod3_centre_1_3 = m * v_rod3_centre_1_3;
    let p_v_rod2_frame_in_rod3_frame_3_3 = p_v_rod3_frame_in_rod4_frame_1_3
        .mul_add(sin_q_P4, p_v_rod3_frame_in_rod4_frame_3_3 * cos_q_P4)
        + v_rod2_frame_in_rod3_frame_3_3 * m_doubled;
    let p_v_rod2_frame_in_rod3_frame_2_3 = p_v_rod4_centre_2_6 + p_v_rod3_centre_2_3;
    let p_v_rod3_centre_3_3 = p_v_rod2_frame_in_rod3_frame_2_3
        .mul_add(sin_q_P3, p_v_rod2_frame_in_rod3_frame_3_3 * cos_q_P3);
    let p_v_rod2_centre_3_3 = m * v_rod2_centre_3_3;
    let p_v_rod1_centre_3_2_of_place = p_v_rod3_centre_3_3 + p_v_rod2_centre_3_3;
    let p_v_rod1_centre_3_2 = p_v_rod1_centre_3_2_of_place
        .mul_add(S::int(2), mp_rod1_frame_1);
    let l_times_3 = S::int(3) * l;
    let p_w_rod5_frame_3_3 = p_v_rod5_centre_1_3.mul_add(l_times_3, H_rod4_3_3);
    let p_w_rod4_frame_in_rod5_frame_1_3 = p_v_rod5_centre_3_3
        .mul_add(l_times_3, H_rod5_1_3);
    let l_times_6 = S::int(6) * l;
    let p_w_rod4_frame_2_3 = p_w_rod4_frame_in_rod5_frame_1_3
        .mul_add(sin_q_P5, H_rod3_2_3) + p_v_rod4_centre_3_3 * l_times_3
        - p_v_rod5_centre_3_3 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_3_3 = p_v_rod4_centre_2_5
        .mul_add(l_times_3, H_rod4_3_3 + p_w_rod5_frame_3_3) + p_v_rod5_centre_2_3 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_1_3 = p_w_rod4_frame_in_rod5_frame_1_3 * cos_q_P5;
    let p_w_rod3_frame_1_3 = p_w_rod3_frame_in_rod4_frame_3_3
        .mul_add(sin_q_P4, H_rod2_1_3) + p_w_rod3_frame_in_rod4_frame_1_3 * cos_q_P4
        + p_v_rod3_centre_2_3 * l_times_3 + p_v_rod4_centre_2_6 * l_times_6;
    let p_w_rod2_frame_in_rod3_frame_3_3 = (-p_w_rod3_frame_in_rod4_frame_1_3)
        .mul_add(sin_q_P4, p_w_rod3_frame_in_rod4_frame_3_3 * cos_q_P4);
    let p_w_rod2_frame_in_rod3_frame_2_3 = p_v_rod3_centre_1_3
        .mul_add(l_times_3, H_rod3_2_3 + p_w_rod4_frame_2_3) - p_v_rod4_centre_1_3 * l_times_6;
    let p_w_rod1_frame_in_rod2_frame_2_3 = (-p_w_rod2_frame_in_rod3_frame_2_3)
        .mul_add(cos_q_P3, p_w_rod2_frame_in_rod3_frame_3_3 * sin_q_P3);
    let p_w_rod1_frame_in_rod2_frame_1_3 = (-p_v_rod2_centre_3_3)
        .mul_add(l_times_3, H_rod2_1_3 + p_w_rod3_frame_1_3) - p_v_rod3_centre_3_3 * l_times_6;
    let w_rod3_frame_in_rod4_frame_1_4 = cos_q_P3 * sin_q_P4;
    let w_rod3_frame_in_rod4_frame_3_4 = cos_q_P3 * cos_q_P4;
    let w_rod4_frame_in_rod5_frame_1_4 = (-w_rod3_frame_in_rod4_frame_1_4)
        .mul_add(cos_q_P5, sin_q_P3 * sin_q_P5);
    let l_sin_q_p3 = l * sin_q_P3;
    let v_rod3_centre_1_4 = l_doubled - l_sin_q_p3;
    let H_rod3_2_4 = H_rod1_2 * sin_q_P3;
    let v_rod4_centre_1_2 = l - l_sin_q_p3;
    let v_rod3_frame_in_rod4_frame_1_4 = v_rod4_centre_1_2 * cos_q_P4;
    let v_rod3_frame_in_rod4_frame_3_4 = v_rod4_centre_1_2 * sin_q_P4;
    let v_rod4_centre_2_7 = l * w_rod3_frame_in_rod4_frame_3_4;
    let v_rod4_centre_3_4 = (-v_rod3_frame_in_rod4_frame_3_4)
        .mul_add(S::int(2), l_sin_q_p3);
    let H_rod4_3_4 = H_rod1_2 * w_rod3_frame_in_rod4_frame_3_4;
    let v_rod5_centre_3_7 = l_sin_q_p3 - v_rod3_frame_in_rod4_frame_3_4;
    let v_rod4_frame_in_rod5_frame_1_4 = v_rod4_centre_2_7
        .mul_add(sin_q_P5, v_rod3_frame_in_rod4_frame_1_4 * cos_q_P5);
    let v_rod4_frame_in_rod5_frame_2_4 = (-v_rod4_centre_2_7)
        .mul_add(cos_q_P5, v_rod3_frame_in_rod4_frame_1_4 * sin_q_P5);
    let v_rod5_centre_1_4 = (-v_rod4_frame_in_rod5_frame_1_4)
        .mul_add(S::int(2), v_rod4_centre_2_7);
    let v_rod5_centre_3_8 = (-v_rod5_centre_3_7)
        .mul_add(S::int(2), l * w_rod4_frame_in_rod5_frame_1_4);
    let H_rod5_1_4 = H_rod1_2 * w_rod4_frame_in_rod5_frame_1_4;
    let p_v_rod5_centre_3_4 = m * v_rod5_centre_3_8;
    let p_v_rod5_centre_1_4 = m * v_rod5_centre_1_4;
    let p_v_rod4_frame_in_rod5_frame_2_4 = m * v_rod4_frame_in_rod5_frame_2_4;
    let p_v_rod5_centre_2_4 = p_v_rod4_frame_in_rod5_frame_2_4
        .mul_add(cos_q_p5_doubled, p_v_rod5_centre_1_4 * sin_q_P5);
    let p_v_rod4_centre_3_4 = m * v_rod4_centre_3_4;
    let p_v_rod4_centre_2_7 = m * v_rod4_centre_2_7;
    let p_v_rod3_frame_in_rod4_frame_3_4 = p_v_rod5_centre_3_4 - p_v_rod4_centre_3_4;
    let p_v_rod3_frame_in_rod4_frame_1_4 = (-p_v_rod5_centre_1_4)
        .mul_add(cos_q_P5, v_rod3_frame_in_rod4_frame_1_4 * m_doubled)
        + p_v_rod4_frame_in_rod5_frame_2_4 * sin_q_p5_doubled;
    let p_v_rod4_centre_2_8 = p_v_rod5_centre_2_4 - p_v_rod4_centre_2_7;
    let p_v_rod4_centre_1_4 = p_v_rod3_frame_in_rod4_frame_1_4
        .mul_add(cos_q_P4, p_v_rod3_frame_in_rod4_frame_3_4 * sin_q_P4);
    let p_v_rod3_centre_1_4 = m * v_rod3_centre_1_4;
    let p_v_rod2_frame_in_rod3_frame_3_4 = (-p_v_rod3_frame_in_rod4_frame_1_4)
        .mul_add(sin_q_P4, p_v_rod3_frame_in_rod4_frame_3_4 * cos_q_P4);
    let p_v_rod3_centre_3_4 = (-p_v_rod4_centre_2_8)
        .mul_add(sin_q_P3, p_v_rod2_frame_in_rod3_frame_3_4 * cos_q_P3);
    let p_w_rod5_frame_3_4 = p_v_rod5_centre_1_4.mul_add(l_times_3, H_rod4_3_4);
    let p_w_rod4_frame_in_rod5_frame_1_4 = p_v_rod5_centre_3_4
        .mul_add(l_times_3, H_rod5_1_4);
    let p_w_rod4_frame_2_4 = p_w_rod4_frame_in_rod5_frame_1_4
        .mul_add(sin_q_P5, H_rod3_2_4) + p_v_rod4_centre_3_4 * l_times_3
        - p_v_rod5_centre_3_4 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_3_4 = p_v_rod4_centre_2_7
        .mul_add(l_times_3, H_rod4_3_4 + p_w_rod5_frame_3_4) - p_v_rod5_centre_2_4 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_1_4 = p_w_rod4_frame_in_rod5_frame_1_4 * cos_q_P5;
    let p_w_rod3_frame_1_4 = (-p_w_rod3_frame_in_rod4_frame_3_4)
        .mul_add(sin_q_P4, p_v_rod4_centre_2_8 * l_times_6)
        - p_w_rod3_frame_in_rod4_frame_1_4 * cos_q_P4;
    let p_w_rod2_frame_in_rod3_frame_3_4 = (-p_w_rod3_frame_in_rod4_frame_1_4)
        .mul_add(sin_q_P4, p_w_rod3_frame_in_rod4_frame_3_4 * cos_q_P4);
    let p_w_rod2_frame_in_rod3_frame_2_4 = (-p_v_rod3_centre_1_4)
        .mul_add(l_times_3, H_rod3_2_4 + p_w_rod4_frame_2_4) - p_v_rod4_centre_1_4 * l_times_6;
    let p_w_rod1_frame_in_rod2_frame_2_4 = (-p_w_rod2_frame_in_rod3_frame_2_4)
        .mul_add(cos_q_P3, p_w_rod2_frame_in_rod3_frame_3_4 * sin_q_P3);
    let p_w_rod1_frame_in_rod2_frame_1_4 = p_v_rod3_centre_3_4
        .mul_add(l_times_6, p_w_rod3_frame_1_4);
    let w_rod4_frame_in_rod5_frame_1_5 = cos_q_P4 * cos_q_P5;
    let l_sin_q_p4 = l * sin_q_P4;
    let v_rod4_centre_2_8 = l_doubled + l_sin_q_p4;
    let H_rod4_3_5 = H_rod1_2 * sin_q_P4;
    let v_rod5_centre_2_4 = l + l_sin_q_p4;
    let v_rod4_frame_in_rod5_frame_1_5 = v_rod5_centre_2_4 * sin_q_P5;
    let v_rod4_frame_in_rod5_frame_2_5 = v_rod5_centre_2_4 * cos_q_P5;
    let v_rod5_centre_1_5 = (-v_rod4_frame_in_rod5_frame_1_5)
        .mul_add(S::int(2), l_sin_q_p4);
    let v_rod5_centre_3_9 = l * w_rod4_frame_in_rod5_frame_1_5;
    let H_rod5_1_5 = H_rod1_2 * w_rod4_frame_in_rod5_frame_1_5;
    let p_v_rod5_centre_3_5 = m * v_rod5_centre_3_9;
    let p_v_rod5_centre_1_5 = m * v_rod5_centre_1_5;
    let p_v_rod4_frame_in_rod5_frame_2_5 = m * v_rod4_frame_in_rod5_frame_2_5;
    let p_v_rod5_centre_2_5 = (-p_v_rod5_centre_1_5)
        .mul_add(sin_q_P5, p_v_rod4_frame_in_rod5_frame_2_5 * cos_q_p5_doubled);
    let p_v_rod4_centre_2_9 = m * v_rod4_centre_2_8;
    let p_v_rod3_frame_in_rod4_frame_1_5 = p_v_rod4_frame_in_rod5_frame_2_5
        .mul_add(sin_q_p5_doubled, p_v_rod5_centre_1_5 * cos_q_P5);
    let p_v_rod4_centre_2_10 = p_v_rod5_centre_2_5 + p_v_rod4_centre_2_9;
    let p_v_rod4_centre_1_5 = (-p_v_rod3_frame_in_rod4_frame_1_5)
        .mul_add(cos_q_P4, p_v_rod5_centre_3_5 * sin_q_P4);
    let p_v_rod2_frame_in_rod3_frame_3_5 = p_v_rod3_frame_in_rod4_frame_1_5
        .mul_add(sin_q_P4, p_v_rod5_centre_3_5 * cos_q_P4);
    let p_v_rod2_frame_in_rod3_frame_2_4 = mp_rod1_frame_1 + p_v_rod4_centre_2_10;
    let p_v_rod3_centre_3_5 = p_v_rod2_frame_in_rod3_frame_2_4
        .mul_add(sin_q_P3, p_v_rod2_frame_in_rod3_frame_3_5 * cos_q_P3);
    let p_w_rod5_frame_3_5 = p_v_rod5_centre_1_5.mul_add(l_times_3, H_rod4_3_5);
    let p_w_rod4_frame_in_rod5_frame_1_5 = p_v_rod5_centre_3_5
        .mul_add(l_times_3, H_rod5_1_5);
    let p_w_rod4_frame_2_5 = (-p_w_rod4_frame_in_rod5_frame_1_5)
        .mul_add(sin_q_P5, p_v_rod5_centre_3_5 * l_times_6);
    let p_w_rod3_frame_in_rod4_frame_3_5 = p_v_rod4_centre_2_9
        .mul_add(l_times_3, H_rod4_3_5 + p_w_rod5_frame_3_5) + p_v_rod5_centre_2_5 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_1_5 = p_w_rod4_frame_in_rod5_frame_1_5 * cos_q_P5;
    let p_w_rod5_frame_3_6 = mp_rod1_frame_1.mul_add(l_times_3, H_rod1_2);
    let p_w_rod3_frame_1_5 = p_w_rod3_frame_in_rod4_frame_1_5
        .mul_add(cos_q_P4, p_w_rod3_frame_in_rod4_frame_3_5 * sin_q_P4)
        + p_w_rod5_frame_3_6 + p_v_rod4_centre_2_10 * l_times_6;
    let p_w_rod2_frame_in_rod3_frame_3_5 = (-p_w_rod3_frame_in_rod4_frame_1_5)
        .mul_add(sin_q_P4, p_w_rod3_frame_in_rod4_frame_3_5 * cos_q_P4);
    let p_w_rod2_frame_in_rod3_frame_2_5 = p_v_rod4_centre_1_5
        .mul_add(l_times_6, p_w_rod4_frame_2_5);
    let p_w_rod1_frame_in_rod2_frame_2_5 = p_w_rod2_frame_in_rod3_frame_2_5
        .mul_add(cos_q_P3, p_w_rod2_frame_in_rod3_frame_3_5 * sin_q_P3);
    let p_w_rod1_frame_in_rod2_frame_1_5 = p_v_rod3_centre_3_5
        .mul_add(l_times_6, -p_w_rod3_frame_1_5);
    let v_rod5_centre_3_10 = (-l).mul_add(sin_q_P5, l_doubled);
    let H_rod5_1_6 = H_rod1_2 * sin_q_P5;
    let p_v_rod5_centre_3_6 = m * v_rod5_centre_3_10;
    let p_v_rod3_frame_in_rod4_frame_3_5 = mp_rod1_frame_1 + p_v_rod5_centre_3_6;
    let p_v_rod4_centre_1_6 = p_v_rod3_frame_in_rod4_frame_3_5 * sin_q_P4;
    let p_v_rod2_frame_in_rod3_frame_3_6 = p_v_rod3_frame_in_rod4_frame_3_5 * cos_q_P4;
    let p_v_rod3_centre_3_6 = p_v_rod2_frame_in_rod3_frame_3_6 * cos_q_P3;
    let p_w_rod4_frame_in_rod5_frame_1_6 = (-p_v_rod5_centre_3_6)
        .mul_add(l_times_3, H_rod5_1_6);
    let p_w_rod4_frame_2_6 = p_w_rod4_frame_in_rod5_frame_1_6
        .mul_add(sin_q_P5, p_w_rod5_frame_3_6) + p_v_rod5_centre_3_6 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_1_6 = p_w_rod4_frame_in_rod5_frame_1_6 * cos_q_P5;
    let p_w_rod3_frame_1_6 = p_w_rod3_frame_in_rod4_frame_1_6 * cos_q_P4;
    let p_w_rod2_frame_in_rod3_frame_3_6 = p_w_rod3_frame_in_rod4_frame_1_6 * sin_q_P4;
    let p_w_rod2_frame_in_rod3_frame_2_6 = p_v_rod4_centre_1_6
        .mul_add(l_times_6, p_w_rod4_frame_2_6);
    let p_w_rod1_frame_in_rod2_frame_2_6 = p_w_rod2_frame_in_rod3_frame_2_6
        .mul_add(cos_q_P3, p_w_rod2_frame_in_rod3_frame_3_6 * sin_q_P3);
    let p_w_rod1_frame_in_rod2_frame_1_6 = p_v_rod3_centre_3_6
        .mul_add(l_times_6, p_w_rod3_frame_1_6);
    let p_v_rod5_centre_2_6 = mp_rod1_frame_1 * sin_q_P5;
    let p_v_rod3_frame_in_rod4_frame_1_6 = mp_rod1_frame_1 * cos_q_P5;
    let p_v_rod4_centre_1_7 = p_v_rod3_frame_in_rod4_frame_1_6 * cos_q_P4;
    let p_v_rod2_frame_in_rod3_frame_3_7 = p_v_rod3_frame_in_rod4_frame_1_6 * sin_q_P4;
    let p_v_rod3_centre_3_7 = (-p_v_rod5_centre_2_6)
        .mul_add(sin_q_P3, p_v_rod2_frame_in_rod3_frame_3_7 * cos_q_P3);
    let p_w_rod3_frame_in_rod4_frame_3_6_of_place = p_v_rod5_centre_2_6 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_3_6 = p_w_rod3_frame_in_rod4_frame_3_6_of_place
        - p_w_rod5_frame_3_6;
    let p_w_rod3_frame_1_7 = p_w_rod3_frame_in_rod4_frame_3_6
        .mul_add(sin_q_P4, p_w_rod3_frame_in_rod4_frame_3_6_of_place);
    let p_w_rod2_frame_in_rod3_frame_3_7 = p_w_rod3_frame_in_rod4_frame_3_6 * cos_q_P4;
    let p_w_rod2_frame_in_rod3_frame_2_7 = l * p_v_rod4_centre_1_7;
    let p_w_rod1_frame_in_rod2_frame_2_7 = (p_w_rod2_frame_in_rod3_frame_2_7 * cos_q_P3)
        .mul_add(S::int(6), p_w_rod2_frame_in_rod3_frame_3_7 * sin_q_P3);
    let p_w_rod1_frame_in_rod2_frame_1_7 = p_v_rod3_centre_3_7
        .mul_add(l_times_6, p_w_rod3_frame_1_7);
    let p_v_rod2_centre_1_2_of_place = p_v_rod4_centre_1_4 + p_v_rod3_centre_1_4;
    let p_v_rod2_centre_1_2 = p_v_rod2_centre_1_2_of_place
        .mul_add(S::int(2), mp_rod1_frame_1);
    let cos_q_p2_by_12 = S::ratio(1, 12) * cos_q_P2;
    let sin_q_p2_by_12 = S::ratio(1, 12) * sin_q_P2;
    let h_rod1_2_by_12 = S::ratio(1, 12) * H_rod1_2;
    let l_by_4 = S::ratio(1, 4) * l;
    let l_halved = S::ratio(1, 2) * l;
    let m12_of_place = (-p_w_rod1_frame_in_rod2_frame_2_4)
        .mul_add(cos_q_p2_by_12, p_v_rod3_centre_3_4 * l_halved);
    let m12_of_place_2 = p_w_rod1_frame_in_rod2_frame_1_4
        .mul_add(sin_q_p2_by_12, -m12_of_place);
    let m13_of_place = (-p_w_rod1_frame_in_rod2_frame_2_5)
        .mul_add(cos_q_p2_by_12, p_v_rod3_centre_3_5 * l_halved);
    let m13_of_place_2 = p_w_rod1_frame_in_rod2_frame_1_5
        .mul_add(sin_q_p2_by_12, -m13_of_place);
    let m14_of_place = (-p_w_rod1_frame_in_rod2_frame_2_6)
        .mul_add(cos_q_p2_by_12, p_v_rod3_centre_3_6 * l_halved);
    let m14_of_place_2 = p_w_rod1_frame_in_rod2_frame_1_6
        .mul_add(sin_q_p2_by_12, -m14_of_place);
    let m15_of_place = p_v_rod3_centre_3_7
        .mul_add(l_halved, p_w_rod1_frame_in_rod2_frame_2_7 * cos_q_p2_by_12);
    let m15_of_place_2 = p_w_rod1_frame_in_rod2_frame_1_7
        .mul_add(sin_q_p2_by_12, -m15_of_place);
    let m16_of_q_p5 = sin_q_P5 - S::int(1);
    let sin_q_p4_m16_of_q_p5 = m16_of_q_p5 * sin_q_P4;
    let m16_of_q_p4_q_p5 = sin_q_p4_m16_of_q_p5 - S::int(1);
    let m16_of_place = (-m16_of_q_p4_q_p5).mul_add(sin_q_P3, cos_q_P3 * cos_q_P5);
    let m16_of_place_2 = m16_of_place - S::int(1);
    let cos_q_p4_m16_of_q_p5 = m16_of_q_p5 * cos_q_P4;
    let m16_of_place_3 = cos_q_p4_m16_of_q_p5
        .mul_add(cos_q_P2, m16_of_place_2 * sin_q_P2);
    let m16_of_place_4 = S::int(1) + m16_of_place_3;
    let sin_q_p3_cos_q_p5 = sin_q_P3 * cos_q_P5;
    let m16_of_place_5 = m16_of_q_p4_q_p5.mul_add(cos_q_P3, sin_q_p3_cos_q_p5);
    let cos_q_p1_m16_of_place_5 = m16_of_place_5 * cos_q_P1;
    let m16_of_place_6 = l * m16_of_place_4.mul_add(sin_q_P1, cos_q_p1_m16_of_place_5);
    let m18_of_place = l * (-m16_of_place_5).mul_add(sin_q_P1, m16_of_place_4 * cos_q_P1);
    let cos_q_p3_cos_q_p1 = cos_q_P1 * cos_q_P3;
    let m19_of_place = (-cos_q_P2).mul_add(cos_q_P4, sin_q_p2_sin_q_p4 * sin_q_P3);
    let m19_of_place_2 = sin_q_P5 * (-sin_q_P1).mul_add(sin_q_P3, cos_q_p3_cos_q_p1 * sin_q_P2)
        + cos_q_P5 * m19_of_place.mul_add(cos_q_P1, w_rod3_frame_in_rod4_frame_1_4 * sin_q_P1);
    let cos_q_p3_by_12 = S::ratio(1, 12) * cos_q_P3;
    let sin_q_p3_by_12 = S::ratio(1, 12) * sin_q_P3;
    let m23_of_place = p_w_rod2_frame_in_rod3_frame_3_5
        .mul_add(cos_q_p3_by_12, p_v_rod4_centre_1_5 * l_halved);
    let m23_of_place_2 = p_w_rod2_frame_in_rod3_frame_2_5
        .mul_add(sin_q_p3_by_12, -m23_of_place);
    let m24_of_place = p_w_rod2_frame_in_rod3_frame_3_6
        .mul_add(cos_q_p3_by_12, p_v_rod4_centre_1_6 * l_halved);
    let m24_of_place_2 = p_w_rod2_frame_in_rod3_frame_2_6
        .mul_add(sin_q_p3_by_12, -m24_of_place);
    let m25_of_place = p_w_rod2_frame_in_rod3_frame_3_7
        .mul_add(cos_q_p3_by_12, p_v_rod4_centre_1_7 * l_halved);
    let m25_of_place_2 = S::ratio(1, 2) * p_w_rod2_frame_in_rod3_frame_2_7 * sin_q_P3;
    let m25_of_place_3 = m25_of_place - m25_of_place_2;
    let m26_of_place = cos_q_p4_m16_of_q_p5 * sin_q_P2;
    let m26_of_place_2 = l * m16_of_place_2.mul_add(cos_q_P2, -m26_of_place);
    let cos_q_p1_m26_of_place_2 = m26_of_place_2 * cos_q_P1;
    let l_m16_of_place_3 = l * m16_of_place_3;
    let sin_q_p1_m26_of_place_2 = m26_of_place_2 * sin_q_P1;
    let m29_of_place = sin_q_p3_cos_q_p5.mul_add(sin_q_P4, cos_q_P3 * sin_q_P5);
    let m29_of_place_2 = m29_of_place.mul_add(cos_q_P2, sin_q_p2_cos_q_p4 * cos_q_P5);
    let sin_q_p1_m29_of_place_2 = m29_of_place_2 * sin_q_P1;
    let p_w_rod3_frame_1_6_by_12 = S::ratio(1, 12) * p_w_rod3_frame_1_6;
    let p_w_rod3_frame_1_7_by_12 = S::ratio(1, 12) * p_w_rod3_frame_1_7;
    let m36_of_place = l * cos_q_p1_m16_of_place_5.mul_add(sin_q_P2, m16_of_place * sin_q_P1);
    let m37_of_place = l * m16_of_place_5 * cos_q_P2;
    let sin_q_p2_sin_q_p1 = sin_q_P1 * sin_q_P2;
    let m38_of_place = l * (-m16_of_place).mul_add(cos_q_P1, m16_of_place_5 * sin_q_p2_sin_q_p1);
    let m39_of_place = -w_rod4_frame_in_rod5_frame_1_4;
    let m39_of_place_2 = sin_q_p2_sin_q_p1
        .mul_add(m39_of_place, m29_of_place * cos_q_P1);
    let m46_of_place = m26_of_place.mul_add(sin_q_P3, sin_q_p4_m16_of_q_p5 * cos_q_P2);
    let m46_of_place_2 = l
        * m46_of_place.mul_add(cos_q_P1, cos_q_p4_m16_of_q_p5 * sin_q_P1 * cos_q_P3);
    let m47_of_place = l
        * (-sin_q_p2_sin_q_p4)
            .mul_add(m16_of_q_p5, w_rod2_frame_in_rod3_frame_3_3 * cos_q_p4_m16_of_q_p5);
    let m48_of_place = l
        * (-cos_q_p4_m16_of_q_p5).mul_add(cos_q_p3_cos_q_p1, m46_of_place * sin_q_P1);
    let m49_of_place = cos_q_P5
        * (-sin_q_P1 * sin_q_p2_cos_q_p4.mul_add(sin_q_P3, cos_q_P2 * sin_q_P4)
            + cos_q_p3_cos_q_p1 * cos_q_P4);
    let m56_of_place = (-m29_of_place)
        .mul_add(sin_q_P2, w_rod4_frame_in_rod5_frame_1_5 * cos_q_P2);
    let m56_of_place_2 = l * (-m56_of_place).mul_add(cos_q_P1, m39_of_place * sin_q_P1);
    let l_m29_of_place_2 = l * m29_of_place_2;
    let m58_of_place = l * m56_of_place.mul_add(sin_q_P1, m39_of_place * cos_q_P1);
    let m59_of_place = sin_q_P5
        * (-m19_of_place).mul_add(sin_q_P1, w_rod3_frame_in_rod4_frame_1_4 * cos_q_P1)
        + cos_q_P5 * sin_q_p2_sin_q_p1.mul_add(cos_q_P3, cos_q_P1 * sin_q_P3);
    let minus_m12_of_place_2 = -m12_of_place_2;
    let minus_m13_of_place_2 = -m13_of_place_2;
    let minus_m15_of_place_2 = -m15_of_place_2;
    let minus_m23_of_place_2 = -m23_of_place_2;
    let minus_m25_of_place_3 = -m25_of_place_3;
    let m35_of_place = -p_w_rod3_frame_1_7_by_12;
    // Entries that are not zero.
    let m11 = (-p_w_rod1_frame_in_rod2_frame_2_3)
        .mul_add(cos_q_p2_by_12, p_w_rod1_frame_in_rod2_frame_1_3 * sin_q_p2_by_12)
        + h_rod1_2_by_12 + p_v_rod1_centre_3_2 * l_by_4;
    let m12 = minus_m12_of_place_2;
    let m13 = minus_m13_of_place_2;
    let m14 = m14_of_place_2;
    let m15 = minus_m15_of_place_2;
    let m16 = m16_of_place_6;
    let m18 = m18_of_place;
    let m19 = -m19_of_place_2;
    let m21 = minus_m12_of_place_2;
    let m22 = p_v_rod2_centre_1_2.mul_add(l_by_4, h_rod1_2_by_12)
        + p_w_rod2_frame_in_rod3_frame_3_4 * cos_q_p3_by_12
        + p_w_rod2_frame_in_rod3_frame_2_4 * sin_q_p3_by_12;
    let m23 = minus_m23_of_place_2;
    let m24 = m24_of_place_2;
    let m25 = minus_m25_of_place_3;
    let m26 = -cos_q_p1_m26_of_place_2;
    let m27 = -l_m16_of_place_3;
    let m28 = sin_q_p1_m26_of_place_2;
    let m29 = -sin_q_p1_m29_of_place_2;
    let m31 = minus_m13_of_place_2;
    let m32 = minus_m23_of_place_2;
    let m33 = S::ratio(1, 12) * p_w_rod3_frame_1_5;
    let m34 = p_w_rod3_frame_1_6_by_12;
    let m35 = m35_of_place;
    let m36 = m36_of_place;
    let m37 = -m37_of_place;
    let m38 = -m38_of_place;
    let m39 = -m39_of_place_2;
    let m41 = m14_of_place_2;
    let m42 = m24_of_place_2;
    let m43 = p_w_rod3_frame_1_6_by_12;
    let m44 = S::ratio(1, 12) * p_w_rod4_frame_2_6;
    let m46 = m46_of_place_2;
    let m47 = -m47_of_place;
    let m48 = -m48_of_place;
    let m49 = m49_of_place;
    let m51 = minus_m15_of_place_2;
    let m52 = minus_m25_of_place_3;
    let m53 = m35_of_place;
    let m55 = S::ratio(1, 12) * p_w_rod5_frame_3_6;
    let m56 = m56_of_place_2;
    let m57 = -l_m29_of_place_2;
    let m58 = m58_of_place;
    let m59 = -m59_of_place;
    let m61 = -m16_of_place_6;
    let m62 = cos_q_p1_m26_of_place_2;
    let m63 = -m36_of_place;
    let m64 = -m46_of_place_2;
    let m65 = -m56_of_place_2;
    let m72 = l_m16_of_place_3;
    let m73 = m37_of_place;
    let m74 = m47_of_place;
    let m75 = l_m29_of_place_2;
    let m81 = -m18_of_place;
    let m82 = -sin_q_p1_m26_of_place_2;
    let m83 = m38_of_place;
    let m84 = m48_of_place;
    let m85 = -m58_of_place;
    let m91 = m19_of_place_2;
    let m92 = sin_q_p1_m29_of_place_2;
    let m93 = m39_of_place_2;
    let m94 = -m49_of_place;
    let m95 = m59_of_place;
    let zero = S::int(0);
    [
        [m11, m12, m13, m14, m15, m16, zero, m18, m19],
        [m21, m22, m23, m24, m25, m26, m27, m28, m29],
        [m31, m32, m33, m34, m35, m36, m37, m38, m39],
        [m41, m42, m43, m44, zero, m46, m47, m48, m49],
        [m51, m52, m53, zero, m55, m56, m57, m58, m59],
        [m61, m62, m63, m64, m65, zero, zero, zero, zero],
        [zero, m72, m73, m74, m75, zero, zero, zero, zero],
        [m81, m82, m83, m84, m85, zero, zero, zero, zero],
        [m91, m92, m93, m94, m95, zero, zero, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (q_P1'', q_P2'', q_P3'', q_P4'', q_P5'', lambda_P6_1, lambda_P6_2, lambda_P6_3, lambda_P6_turn13).
///
/// 772 operations, 5 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> [S; 9] {
    let Parameters { l, m, g } = *p;
    let [q_P1, q_P2, q_P3, q_P4, q_P5] = *q;
    let [q_P1_dot, q_P2_dot, q_P3_dot, q_P4_dot, q_P5_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q_P2, cos_q_P2) = q_P2.sin_cos();
    let (sin_q_P3, cos_q_P3) = q_P3.sin_cos();
    let (sin_q_P4, cos_q_P4) = q_P4.sin_cos();
    let (sin_q_P5, cos_q_P5) = q_P5.sin_cos();
    let (sin_q_P1, cos_q_P1) = q_P1.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_rod1_frame_in_rod2_frame_1 = q_P1_dot * sin_q_P2;
    let w_rod1_frame_in_rod2_frame_2 = q_P1_dot * cos_q_P2;
    let q_p2_dot_sin_q_p3 = q_P2_dot * sin_q_P3;
    let w_rod2_frame_in_rod3_frame_2 = w_rod1_frame_in_rod2_frame_2
        .mul_add(cos_q_P3, q_p2_dot_sin_q_p3);
    let q_p2_dot_cos_q_p3 = q_P2_dot * cos_q_P3;
    let w_rod2_frame_in_rod3_frame_3_of_q_p2_dot = w_rod1_frame_in_rod2_frame_2
        .mul_add(sin_q_P3, -q_p2_dot_cos_q_p3);
    let w_rod2_frame_in_rod3_frame_3 = -w_rod2_frame_in_rod3_frame_3_of_q_p2_dot;
    let w_rod3_frame_1 = q_P3_dot + w_rod1_frame_in_rod2_frame_1;
    let w_rod3_frame_in_rod4_frame_1 = (-w_rod3_frame_1)
        .mul_add(cos_q_P4, w_rod2_frame_in_rod3_frame_3 * sin_q_P4);
    let w_rod3_frame_in_rod4_frame_3 = w_rod3_frame_1
        .mul_add(sin_q_P4, w_rod2_frame_in_rod3_frame_3 * cos_q_P4);
    let w_rod4_frame_2 = q_P4_dot + w_rod2_frame_in_rod3_frame_2;
    let w_rod4_frame_in_rod5_frame_1 = (-w_rod4_frame_2)
        .mul_add(sin_q_P5, w_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let w_rod5_frame_3 = q_P5_dot + w_rod3_frame_in_rod4_frame_3;
    let v_rod1_centre_3 = l * q_P1_dot;
    let v_rod2_centre_1 = l * q_P2_dot;
    let v_rod2_centre_3_of_place = l * w_rod1_frame_in_rod2_frame_1;
    let v_rod2_centre_3 = (-v_rod1_centre_3)
        .mul_add(S::int(2), v_rod2_centre_3_of_place);
    let mp_rod1_frame_1 = l * m;
    let l_mp_rod1_frame_1 = l * mp_rod1_frame_1;
    let H_rod2_1 = w_rod1_frame_in_rod2_frame_1 * l_mp_rod1_frame_1;
    let v_rod3_centre_3 = v_rod2_centre_3_of_place - v_rod1_centre_3;
    let v_rod2_frame_in_rod3_frame_2 = v_rod3_centre_3 * sin_q_P3;
    let v_rod2_frame_in_rod3_frame_3 = v_rod3_centre_3 * cos_q_P3;
    let v_rod3_centre_1_of_place = l * w_rod2_frame_in_rod3_frame_2;
    let v_rod3_centre_1 = (-v_rod2_centre_1)
        .mul_add(S::int(2), v_rod3_centre_1_of_place);
    let l_w_rod3_frame_1 = l * w_rod3_frame_1;
    let v_rod3_centre_2 = (-v_rod2_frame_in_rod3_frame_2)
        .mul_add(S::int(2), l_w_rod3_frame_1);
    let H_rod3_1 = w_rod3_frame_1 * l_mp_rod1_frame_1;
    let H_rod3_2 = w_rod2_frame_in_rod3_frame_2 * l_mp_rod1_frame_1;
    let v_rod4_centre_1 = v_rod3_centre_1_of_place - v_rod2_centre_1;
    let v_rod4_centre_2 = l_w_rod3_frame_1 - v_rod2_frame_in_rod3_frame_2;
    let v_rod3_frame_in_rod4_frame_1 = (-v_rod4_centre_1)
        .mul_add(cos_q_P4, v_rod2_frame_in_rod3_frame_3 * sin_q_P4);
    let v_rod3_frame_in_rod4_frame_3 = v_rod4_centre_1
        .mul_add(sin_q_P4, v_rod2_frame_in_rod3_frame_3 * cos_q_P4);
    let v_rod4_centre_2_2_of_place = l * w_rod3_frame_in_rod4_frame_3;
    let v_rod4_centre_2_2 = v_rod4_centre_2
        .mul_add(S::int(2), v_rod4_centre_2_2_of_place);
    let l_w_rod4_frame_2 = l * w_rod4_frame_2;
    let v_rod4_centre_3 = v_rod3_frame_in_rod4_frame_3
        .mul_add(S::int(2), l_w_rod4_frame_2);
    let H_rod4_2 = w_rod4_frame_2 * l_mp_rod1_frame_1;
    let H_rod4_3 = w_rod3_frame_in_rod4_frame_3 * l_mp_rod1_frame_1;
    let v_rod5_centre_2 = v_rod4_centre_2 + v_rod4_centre_2_2_of_place;
    let v_rod5_centre_3 = v_rod3_frame_in_rod4_frame_3 + l_w_rod4_frame_2;
    let v_rod4_frame_in_rod5_frame_1 = v_rod5_centre_2
        .mul_add(sin_q_P5, v_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let v_rod4_frame_in_rod5_frame_2_of_place = (-v_rod3_frame_in_rod4_frame_1)
        .mul_add(sin_q_P5, v_rod5_centre_2 * cos_q_P5);
    let v_rod4_frame_in_rod5_frame_2 = -v_rod4_frame_in_rod5_frame_2_of_place;
    let v_rod5_centre_1 = (-v_rod4_frame_in_rod5_frame_1)
        .mul_add(S::int(2), l * w_rod5_frame_3);
    let v_rod5_centre_3_2 = v_rod5_centre_3
        .mul_add(S::int(2), l * w_rod4_frame_in_rod5_frame_1);
    let H_rod5_1 = w_rod4_frame_in_rod5_frame_1 * l_mp_rod1_frame_1;
    let H_rod5_3 = w_rod5_frame_3 * l_mp_rod1_frame_1;
    let p_v_rod5_centre_3 = m * v_rod5_centre_3_2;
    let p_v_rod5_centre_1 = m * v_rod5_centre_1;
    let p_v_rod4_frame_in_rod5_frame_2 = m * v_rod4_frame_in_rod5_frame_2;
    let cos_q_p5_doubled = S::int(2) * cos_q_P5;
    let p_v_rod5_centre_2 = p_v_rod4_frame_in_rod5_frame_2
        .mul_add(cos_q_p5_doubled, p_v_rod5_centre_1 * sin_q_P5);
    let p_v_rod4_centre_3 = m * v_rod4_centre_3;
    let p_v_rod4_centre_2 = m * v_rod4_centre_2_2;
    let p_v_rod3_frame_in_rod4_frame_3 = p_v_rod5_centre_3 + p_v_rod4_centre_3;
    let m_doubled = S::int(2) * m;
    let sin_q_p5_doubled = S::int(2) * sin_q_P5;
    let p_v_rod3_frame_in_rod4_frame_1 = (-p_v_rod5_centre_1)
        .mul_add(cos_q_P5, v_rod3_frame_in_rod4_frame_1 * m_doubled)
        + p_v_rod4_frame_in_rod5_frame_2 * sin_q_p5_doubled;
    let p_v_rod4_centre_2_2 = p_v_rod5_centre_2 - p_v_rod4_centre_2;
    let p_v_rod4_centre_1 = (-p_v_rod3_frame_in_rod4_frame_1)
        .mul_add(cos_q_P4, p_v_rod3_frame_in_rod4_frame_3 * sin_q_P4);
    let p_v_rod3_centre_2 = m * v_rod3_centre_2;
    let p_v_rod3_centre_1 = m * v_rod3_centre_1;
    let p_v_rod2_frame_in_rod3_frame_3 = p_v_rod3_frame_in_rod4_frame_1
        .mul_add(sin_q_P4, p_v_rod3_frame_in_rod4_frame_3 * cos_q_P4)
        + v_rod2_frame_in_rod3_frame_3 * m_doubled;
    let p_v_rod2_frame_in_rod3_frame_2 = p_v_rod4_centre_2_2 - p_v_rod3_centre_2;
    let p_v_rod3_centre_3 = p_v_rod2_frame_in_rod3_frame_2
        .mul_add(sin_q_P3, p_v_rod2_frame_in_rod3_frame_3 * cos_q_P3);
    let p_v_rod2_centre_3 = m * v_rod2_centre_3;
    let l_times_3 = S::int(3) * l;
    let p_w_rod5_frame_3 = p_v_rod5_centre_1.mul_add(l_times_3, H_rod5_3);
    let p_w_rod4_frame_in_rod5_frame_1 = p_v_rod5_centre_3.mul_add(l_times_3, H_rod5_1);
    let l_times_6 = S::int(6) * l;
    let p_w_rod4_frame_2 = (-p_w_rod4_frame_in_rod5_frame_1).mul_add(sin_q_P5, H_rod4_2)
        + p_v_rod4_centre_3 * l_times_3 + p_v_rod5_centre_3 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_3 = p_v_rod4_centre_2
        .mul_add(l_times_3, H_rod4_3 + p_w_rod5_frame_3) - p_v_rod5_centre_2 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_1 = p_w_rod4_frame_in_rod5_frame_1 * cos_q_P5;
    let p_w_rod3_frame_1 = p_w_rod3_frame_in_rod4_frame_3.mul_add(sin_q_P4, H_rod3_1)
        - p_w_rod3_frame_in_rod4_frame_1 * cos_q_P4 + p_v_rod3_centre_2 * l_times_3
        - p_v_rod4_centre_2_2 * l_times_6;
    let p_w_rod2_frame_in_rod3_frame_3 = p_w_rod3_frame_in_rod4_frame_1
        .mul_add(sin_q_P4, p_w_rod3_frame_in_rod4_frame_3 * cos_q_P4);
    let p_w_rod2_frame_in_rod3_frame_2 = p_v_rod3_centre_1
        .mul_add(l_times_3, H_rod3_2 + p_w_rod4_frame_2) + p_v_rod4_centre_1 * l_times_6;
    let p_w_rod1_frame_in_rod2_frame_2 = (-p_w_rod2_frame_in_rod3_frame_2)
        .mul_add(cos_q_P3, p_w_rod2_frame_in_rod3_frame_3 * sin_q_P3);
    let p_w_rod1_frame_in_rod2_frame_1 = p_v_rod2_centre_3
        .mul_add(l_times_3, H_rod2_1 + p_w_rod3_frame_1) + p_v_rod3_centre_3 * l_times_6;
    let w_rod1_frame_in_rod2_frame_1_2 = q_P2_dot * w_rod1_frame_in_rod2_frame_2;
    let w_rod1_frame_in_rod2_frame_2_2 = q_P2_dot * w_rod1_frame_in_rod2_frame_1;
    let w_rod2_frame_in_rod3_frame_2_2 = (-q_P3_dot)
        .mul_add(
            w_rod2_frame_in_rod3_frame_3_of_q_p2_dot,
            -w_rod1_frame_in_rod2_frame_2_2 * cos_q_P3,
        );
    let w_rod2_frame_in_rod3_frame_3_2 = (-w_rod1_frame_in_rod2_frame_2_2)
        .mul_add(sin_q_P3, q_P3_dot * w_rod2_frame_in_rod3_frame_2);
    let q_p4_dot_cos_q_p4 = q_P4_dot * cos_q_P4;
    let q_p4_dot_sin_q_p4 = q_P4_dot * sin_q_P4;
    let w_rod3_frame_in_rod4_frame_1_2 = (-w_rod1_frame_in_rod2_frame_1_2)
        .mul_add(cos_q_P4, w_rod2_frame_in_rod3_frame_3 * q_p4_dot_cos_q_p4)
        - w_rod2_frame_in_rod3_frame_3_2 * sin_q_P4 + w_rod3_frame_1 * q_p4_dot_sin_q_p4;
    let w_rod3_frame_in_rod4_frame_3_2 = (-w_rod1_frame_in_rod2_frame_1_2)
        .mul_add(sin_q_P4, w_rod2_frame_in_rod3_frame_3_2 * cos_q_P4)
        - w_rod3_frame_1 * q_p4_dot_cos_q_p4 + w_rod2_frame_in_rod3_frame_3 * q_p4_dot_sin_q_p4;
    let q_p5_dot_cos_q_p5 = q_P5_dot * cos_q_P5;
    let q_p5_dot_sin_q_p5 = q_P5_dot * sin_q_P5;
    let w_rod4_frame_in_rod5_frame_1_2 = (-w_rod3_frame_in_rod4_frame_1_2)
        .mul_add(cos_q_P5, w_rod2_frame_in_rod3_frame_2_2 * sin_q_P5)
        + w_rod4_frame_2 * q_p5_dot_cos_q_p5 + w_rod3_frame_in_rod4_frame_1 * q_p5_dot_sin_q_p5;
    let v_rod2_centre_3_2 = l * w_rod1_frame_in_rod2_frame_1_2;
    let H_rod2_1_2 = w_rod1_frame_in_rod2_frame_1_2 * l_mp_rod1_frame_1;
    let q_p3_dot_cos_q_p3 = q_P3_dot * cos_q_P3;
    let v_rod2_frame_in_rod3_frame_2_2 = v_rod3_centre_3
        .mul_add(q_p3_dot_cos_q_p3, v_rod2_centre_3_2 * sin_q_P3);
    let v_rod2_frame_in_rod3_frame_3_2 = (-v_rod2_centre_3_2)
        .mul_add(cos_q_P3, q_P3_dot * v_rod2_frame_in_rod3_frame_2);
    let v_rod3_centre_1_2 = l * w_rod2_frame_in_rod3_frame_2_2;
    let v_rod3_centre_2_2 = (-v_rod2_frame_in_rod3_frame_2_2)
        .mul_add(S::int(2), v_rod2_centre_3_2);
    let H_rod3_2_2 = w_rod2_frame_in_rod3_frame_2_2 * l_mp_rod1_frame_1;
    let v_rod4_centre_2_3 = v_rod2_centre_3_2 - v_rod2_frame_in_rod3_frame_2_2;
    let v_rod3_frame_in_rod4_frame_1_2 = (-v_rod2_frame_in_rod3_frame_3_2)
        .mul_add(sin_q_P4, v_rod2_frame_in_rod3_frame_3 * q_p4_dot_cos_q_p4)
        - v_rod3_centre_1_2 * cos_q_P4 + v_rod4_centre_1 * q_p4_dot_sin_q_p4;
    let v_rod3_frame_in_rod4_frame_3_2 = (-v_rod3_centre_1_2)
        .mul_add(sin_q_P4, v_rod2_frame_in_rod3_frame_3_2 * cos_q_P4)
        - v_rod4_centre_1 * q_p4_dot_cos_q_p4 + v_rod2_frame_in_rod3_frame_3 * q_p4_dot_sin_q_p4;
    let v_rod4_centre_2_4_of_place = l * w_rod3_frame_in_rod4_frame_3_2;
    let v_rod4_centre_2_4 = (-v_rod4_centre_2_3)
        .mul_add(S::int(2), v_rod4_centre_2_4_of_place);
    let v_rod4_centre_3_2 = (-v_rod3_frame_in_rod4_frame_3_2)
        .mul_add(S::int(2), v_rod3_centre_1_2);
    let H_rod4_3_2 = w_rod3_frame_in_rod4_frame_3_2 * l_mp_rod1_frame_1;
    let v_rod5_centre_2_2 = v_rod4_centre_2_4_of_place - v_rod4_centre_2_3;
    let v_rod5_centre_3_3 = v_rod3_centre_1_2 - v_rod3_frame_in_rod4_frame_3_2;
    let v_rod4_frame_in_rod5_frame_1_2 = (-v_rod3_frame_in_rod4_frame_1_2)
        .mul_add(cos_q_P5, v_rod5_centre_2_2 * sin_q_P5) - v_rod5_centre_2 * q_p5_dot_cos_q_p5
        + v_rod3_frame_in_rod4_frame_1 * q_p5_dot_sin_q_p5;
    let v_rod4_frame_in_rod5_frame_2_2 = v_rod5_centre_2_2
        .mul_add(cos_q_P5, v_rod3_frame_in_rod4_frame_1_2 * sin_q_P5)
        + v_rod3_frame_in_rod4_frame_1 * q_p5_dot_cos_q_p5 + v_rod5_centre_2 * q_p5_dot_sin_q_p5;
    let v_rod5_centre_1_2 = (-v_rod4_frame_in_rod5_frame_1_2)
        .mul_add(S::int(2), v_rod4_centre_2_4_of_place);
    let v_rod5_centre_3_4 = (-v_rod5_centre_3_3)
        .mul_add(S::int(2), l * w_rod4_frame_in_rod5_frame_1_2);
    let H_rod5_1_2 = w_rod4_frame_in_rod5_frame_1_2 * l_mp_rod1_frame_1;
    let p_v_rod5_centre_3_2 = m * v_rod5_centre_3_4;
    let p_v_rod5_centre_1_2 = m * v_rod5_centre_1_2;
    let p_v_rod4_frame_in_rod5_frame_2_2 = m * v_rod4_frame_in_rod5_frame_2_2;
    let p_v_rod5_centre_2_2_of_q_p5_dot = S::int(2) * q_p5_dot_sin_q_p5;
    let p_v_rod5_centre_2_2 = (-p_v_rod4_frame_in_rod5_frame_2_2)
        .mul_add(cos_q_p5_doubled, p_v_rod5_centre_1_2 * sin_q_P5)
        - p_v_rod5_centre_1 * q_p5_dot_cos_q_p5
        + p_v_rod4_frame_in_rod5_frame_2 * p_v_rod5_centre_2_2_of_q_p5_dot;
    let p_v_rod4_centre_3_2 = m * v_rod4_centre_3_2;
    let p_v_rod4_centre_2_3 = m * v_rod4_centre_2_4;
    let p_v_rod3_frame_in_rod4_frame_3_2 = p_v_rod5_centre_3_2 - p_v_rod4_centre_3_2;
    let p_v_rod3_frame_in_rod4_frame_1_2_of_q_p5_dot = S::int(2) * q_p5_dot_cos_q_p5;
    let p_v_rod3_frame_in_rod4_frame_1_2 = v_rod3_frame_in_rod4_frame_1_2
        .mul_add(m_doubled, p_v_rod5_centre_1_2 * cos_q_P5)
        + p_v_rod4_frame_in_rod5_frame_2_2 * sin_q_p5_doubled
        + p_v_rod5_centre_1 * q_p5_dot_sin_q_p5
        + p_v_rod4_frame_in_rod5_frame_2 * p_v_rod3_frame_in_rod4_frame_1_2_of_q_p5_dot;
    let p_v_rod4_centre_2_4 = p_v_rod5_centre_2_2 - p_v_rod4_centre_2_3;
    let p_v_rod4_centre_1_2 = (-p_v_rod3_frame_in_rod4_frame_3_2)
        .mul_add(sin_q_P4, p_v_rod3_frame_in_rod4_frame_3 * q_p4_dot_cos_q_p4)
        - p_v_rod3_frame_in_rod4_frame_1_2 * cos_q_P4
        + p_v_rod3_frame_in_rod4_frame_1 * q_p4_dot_sin_q_p4;
    let p_v_rod3_centre_2_2 = m * v_rod3_centre_2_2;
    let p_v_rod3_centre_1_2 = m * v_rod3_centre_1_2;
    let p_v_rod2_frame_in_rod3_frame_3_2 = (-p_v_rod3_frame_in_rod4_frame_1_2)
        .mul_add(sin_q_P4, p_v_rod3_frame_in_rod4_frame_3_2 * cos_q_P4)
        + v_rod2_frame_in_rod3_frame_3_2 * m_doubled
        - p_v_rod3_frame_in_rod4_frame_1 * q_p4_dot_cos_q_p4
        + p_v_rod3_frame_in_rod4_frame_3 * q_p4_dot_sin_q_p4;
    let p_v_rod2_frame_in_rod3_frame_2_2 = p_v_rod4_centre_2_4 + p_v_rod3_centre_2_2;
    let p_v_rod3_centre_3_2_of_place = (-p_v_rod2_frame_in_rod3_frame_2)
        .mul_add(cos_q_P3, p_v_rod2_frame_in_rod3_frame_3 * sin_q_P3);
    let p_v_rod3_centre_3_2 = p_v_rod2_frame_in_rod3_frame_2_2
        .mul_add(sin_q_P3, p_v_rod2_frame_in_rod3_frame_3_2 * cos_q_P3)
        + q_P3_dot * p_v_rod3_centre_3_2_of_place;
    let p_v_rod2_centre_3_2 = m * v_rod2_centre_3_2;
    let p_v_rod1_centre_3 = p_v_rod3_centre_3_2 - p_v_rod2_centre_3_2;
    let p_w_rod5_frame_3_2 = p_v_rod5_centre_1_2.mul_add(l_times_3, H_rod4_3_2);
    let p_w_rod4_frame_in_rod5_frame_1_2 = p_v_rod5_centre_3_2
        .mul_add(l_times_3, H_rod5_1_2);
    let p_w_rod4_frame_2_2 = p_w_rod4_frame_in_rod5_frame_1_2
        .mul_add(sin_q_P5, H_rod3_2_2) + p_v_rod4_centre_3_2 * l_times_3
        - p_v_rod5_centre_3_2 * l_times_6 - p_w_rod4_frame_in_rod5_frame_1 * q_p5_dot_cos_q_p5;
    let p_w_rod3_frame_in_rod4_frame_3_2 = p_v_rod4_centre_2_3
        .mul_add(l_times_3, H_rod4_3_2 + p_w_rod5_frame_3_2) - p_v_rod5_centre_2_2 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_1_2 = p_w_rod4_frame_in_rod5_frame_1
        .mul_add(q_p5_dot_sin_q_p5, p_w_rod4_frame_in_rod5_frame_1_2 * cos_q_P5);
    let p_w_rod3_frame_1_2 = (-p_w_rod3_frame_in_rod4_frame_3_2)
        .mul_add(sin_q_P4, H_rod2_1_2) + p_w_rod3_frame_in_rod4_frame_1_2 * cos_q_P4
        + p_v_rod3_centre_2_2 * l_times_3 + p_v_rod4_centre_2_4 * l_times_6
        + p_w_rod3_frame_in_rod4_frame_3 * q_p4_dot_cos_q_p4
        + p_w_rod3_frame_in_rod4_frame_1 * q_p4_dot_sin_q_p4;
    let p_w_rod2_frame_in_rod3_frame_3_2 = p_w_rod3_frame_in_rod4_frame_1_2
        .mul_add(sin_q_P4, p_w_rod3_frame_in_rod4_frame_3_2 * cos_q_P4)
        - p_w_rod3_frame_in_rod4_frame_1 * q_p4_dot_cos_q_p4
        + p_w_rod3_frame_in_rod4_frame_3 * q_p4_dot_sin_q_p4;
    let p_w_rod2_frame_in_rod3_frame_2_2 = p_v_rod3_centre_1_2
        .mul_add(l_times_3, H_rod3_2_2 + p_w_rod4_frame_2_2) + p_v_rod4_centre_1_2 * l_times_6;
    let p_w_rod1_frame_in_rod2_frame_2_2 = sin_q_P3
        * q_P3_dot
            .mul_add(p_w_rod2_frame_in_rod3_frame_2, -p_w_rod2_frame_in_rod3_frame_3_2)
        - p_w_rod2_frame_in_rod3_frame_2_2 * cos_q_P3
        + p_w_rod2_frame_in_rod3_frame_3 * q_p3_dot_cos_q_p3;
    let p_w_rod1_frame_in_rod2_frame_1_2 = p_v_rod2_centre_3_2
        .mul_add(l_times_3, H_rod2_1_2 + p_w_rod3_frame_1_2) - p_v_rod3_centre_3_2 * l_times_6;
    let x_rod1_frame_in_rod2_frame_1 = g * sin_q_P2;
    let x_rod1_frame_in_rod2_frame_2 = g * cos_q_P2;
    let x_rod2_frame_in_rod3_frame_2 = x_rod1_frame_in_rod2_frame_2 * cos_q_P3;
    let x_rod2_frame_in_rod3_frame_3 = x_rod1_frame_in_rod2_frame_2 * sin_q_P3;
    let x_rod3_frame_in_rod4_frame_1 = x_rod2_frame_in_rod3_frame_3
        .mul_add(sin_q_P4, x_rod1_frame_in_rod2_frame_1 * cos_q_P4);
    let x_rod3_frame_in_rod4_frame_3_of_place = (-x_rod2_frame_in_rod3_frame_3)
        .mul_add(cos_q_P4, x_rod1_frame_in_rod2_frame_1 * sin_q_P4);
    let x_rod3_frame_in_rod4_frame_3 = -x_rod3_frame_in_rod4_frame_3_of_place;
    let x_rod4_frame_in_rod5_frame_1 = x_rod3_frame_in_rod4_frame_1
        .mul_add(cos_q_P5, x_rod2_frame_in_rod3_frame_2 * sin_q_P5);
    let x_rod4_frame_in_rod5_frame_2_of_place = (-x_rod3_frame_in_rod4_frame_1)
        .mul_add(sin_q_P5, x_rod2_frame_in_rod3_frame_2 * cos_q_P5);
    let x_rod4_frame_in_rod5_frame_2 = -x_rod4_frame_in_rod5_frame_2_of_place;
    let x_rod1_frame_in_rod2_frame_1_2 = mp_rod1_frame_1 * cos_q_P2;
    let x_rod1_frame_in_rod2_frame_2_2 = mp_rod1_frame_1 * sin_q_P2;
    let x_rod5_frame_2 = (-x_rod1_frame_in_rod2_frame_2_2)
        .mul_add(S::int(9), S::int(7) * mp_rod1_frame_1);
    let x_rod2_frame_in_rod3_frame_2_2 = x_rod5_frame_2 * cos_q_P3;
    let x_rod2_frame_in_rod3_frame_3_2 = x_rod5_frame_2 * sin_q_P3;
    let x_rod5_frame_3 = mp_rod1_frame_1
        .mul_add(S::int(5), -x_rod2_frame_in_rod3_frame_3_2);
    let x_rod3_frame_in_rod4_frame_1_2_of_place = S::int(9) * x_rod1_frame_in_rod2_frame_1_2;
    let x_rod3_frame_in_rod4_frame_1_2 = (-x_rod3_frame_in_rod4_frame_1_2_of_place)
        .mul_add(cos_q_P4, x_rod5_frame_3 * sin_q_P4);
    let x_rod3_frame_in_rod4_frame_3_2 = x_rod3_frame_in_rod4_frame_1_2_of_place
        .mul_add(sin_q_P4, x_rod5_frame_3 * cos_q_P4);
    let x_rod5_frame_1 = mp_rod1_frame_1
        .mul_add(S::int(3), x_rod3_frame_in_rod4_frame_1_2);
    let x_rod4_frame_in_rod5_frame_1_2 = (-x_rod2_frame_in_rod3_frame_2_2)
        .mul_add(sin_q_P5, x_rod5_frame_1 * cos_q_P5);
    let x_rod4_frame_in_rod5_frame_2_2 = x_rod5_frame_1
        .mul_add(sin_q_P5, x_rod2_frame_in_rod3_frame_2_2 * cos_q_P5);
    let x_rod5_frame_2_2 = mp_rod1_frame_1 - x_rod4_frame_in_rod5_frame_2_2;
    let F_x_rod5_frame_1 = x_rod4_frame_in_rod5_frame_2
        .mul_add(sin_q_P5, x_rod4_frame_in_rod5_frame_1 * cos_q_P5);
    let F_x_rod5_frame_3 = F_x_rod5_frame_1
        .mul_add(sin_q_P4, x_rod3_frame_in_rod4_frame_3 * cos_q_P4);
    let F_x_rod2_frame_in_rod3_frame_2 = (-x_rod4_frame_in_rod5_frame_1)
        .mul_add(sin_q_P5, x_rod4_frame_in_rod5_frame_2 * cos_q_P5);
    let F_x_rod5_frame_2 = (-F_x_rod2_frame_in_rod3_frame_2)
        .mul_add(cos_q_P3, F_x_rod5_frame_3 * sin_q_P3);
    let F_x_rod1_frame_in_rod2_frame_1 = (-F_x_rod5_frame_1)
        .mul_add(cos_q_P4, x_rod3_frame_in_rod4_frame_3 * sin_q_P4);
    let F_x_rod3_frame_in_rod4_frame_1 = (-x_rod4_frame_in_rod5_frame_1_2)
        .mul_add(cos_q_P5, x_rod5_frame_2_2 * sin_q_P5);
    let F_x_rod2_frame_in_rod3_frame_3 = (-F_x_rod3_frame_in_rod4_frame_1)
        .mul_add(sin_q_P4, x_rod3_frame_in_rod4_frame_3_2 * cos_q_P4);
    let F_x_rod2_frame_in_rod3_frame_2_2 = x_rod5_frame_2_2
        .mul_add(cos_q_P5, x_rod4_frame_in_rod5_frame_1_2 * sin_q_P5);
    let F_x_rod1_frame_in_rod2_frame_2 = F_x_rod2_frame_in_rod3_frame_2_2
        .mul_add(cos_q_P3, F_x_rod2_frame_in_rod3_frame_3 * sin_q_P3);
    let F_x_rod1_frame_in_rod2_frame_1_2 = F_x_rod3_frame_in_rod4_frame_1
        .mul_add(cos_q_P4, x_rod3_frame_in_rod4_frame_3_2 * sin_q_P4);
    let p_v_rod2_centre_1 = p_v_rod4_centre_1_2 + p_v_rod3_centre_1_2;
    let l_halved = S::ratio(1, 2) * l;
    let cos_q_p2_by_12 = S::ratio(1, 12) * cos_q_P2;
    let sin_q_p2_by_12 = S::ratio(1, 12) * sin_q_P2;
    let g_times_6 = S::int(6) * g;
    let mp_rod1_frame_1_times_54 = S::int(54) * mp_rod1_frame_1;
    let f2_of_place = (-p_w_rod2_frame_in_rod3_frame_3_2)
        .mul_add(cos_q_P3, p_w_rod2_frame_in_rod3_frame_2_2 * sin_q_P3);
    let f2_of_q_p3_dot = q_P3_dot.mul_add(p_w_rod1_frame_in_rod2_frame_2, -f2_of_place);
    let f3_of_place = w_rod2_frame_in_rod3_frame_2
        .mul_add(p_w_rod2_frame_in_rod3_frame_3, p_w_rod3_frame_1_2);
    let f3_of_place_2 = x_rod5_frame_2
        * F_x_rod2_frame_in_rod3_frame_2.mul_add(sin_q_P3, F_x_rod5_frame_3 * cos_q_P3)
        + v_rod3_centre_3 * p_v_rod3_centre_3_2_of_place;
    let f3_of_q_p2_dot = (-p_w_rod2_frame_in_rod3_frame_2)
        .mul_add(w_rod2_frame_in_rod3_frame_3_of_q_p2_dot, -f3_of_place);
    let f3_of_place_3 = x_rod1_frame_in_rod2_frame_2
        * (-F_x_rod2_frame_in_rod3_frame_3)
            .mul_add(cos_q_P3, F_x_rod2_frame_in_rod3_frame_2_2 * sin_q_P3) + f3_of_place_2;
    let f4_of_place = w_rod3_frame_in_rod4_frame_1
        .mul_add(p_w_rod3_frame_in_rod4_frame_3, p_w_rod4_frame_2_2);
    let f4_of_place_2 = (-v_rod3_frame_in_rod4_frame_3)
        .mul_add(
            p_v_rod3_frame_in_rod4_frame_1,
            v_rod3_frame_in_rod4_frame_1 * p_v_rod3_frame_in_rod4_frame_3,
        );
    let f4_of_place_3 = (-x_rod3_frame_in_rod4_frame_3_2)
        .mul_add(
            F_x_rod5_frame_1,
            x_rod3_frame_in_rod4_frame_3 * x_rod3_frame_in_rod4_frame_1_2,
        );
    let f4_of_place_4 = (-F_x_rod3_frame_in_rod4_frame_1)
        .mul_add(
            x_rod3_frame_in_rod4_frame_3_of_place,
            x_rod3_frame_in_rod4_frame_1 * x_rod3_frame_in_rod4_frame_3_2,
        );
    let f4_of_place_5 = f4_of_place_2 + f4_of_place_3;
    let f4_of_place_6 = w_rod3_frame_in_rod4_frame_3
        .mul_add(p_w_rod3_frame_in_rod4_frame_1, -f4_of_place);
    let f4_of_place_7 = f4_of_place_4 + f4_of_place_5;
    let f5_of_place = (-p_v_rod5_centre_1)
        .mul_add(
            v_rod4_frame_in_rod5_frame_2_of_place,
            x_rod4_frame_in_rod5_frame_2 * x_rod4_frame_in_rod5_frame_1_2,
        );
    let f5_of_place_2 = x_rod4_frame_in_rod5_frame_1
        .mul_add(
            x_rod5_frame_2_2,
            x_rod4_frame_in_rod5_frame_1 * x_rod4_frame_in_rod5_frame_2_2,
        );
    let f5_of_place_3 = (-x_rod4_frame_in_rod5_frame_1_2)
        .mul_add(x_rod4_frame_in_rod5_frame_2_of_place, -f5_of_place);
    let f5_of_place_4 = p_w_rod4_frame_in_rod5_frame_1
        * w_rod4_frame_2.mul_add(cos_q_P5, w_rod3_frame_in_rod4_frame_1 * sin_q_P5)
        - p_w_rod5_frame_3_2;
    let f5_of_place_5 = f5_of_place_2 + f5_of_place_3;
    let q_p4_dot_sq = q_P4_dot * q_P4_dot;
    let f6_of_motion = q_P3_dot.mul_add(q_P3_dot, q_p4_dot_sq);
    let q_p2_dot_sq = q_P2_dot * q_P2_dot;
    let q_p1_dot_sq = q_P1_dot * q_P1_dot;
    let f6_of_motion_2 = q_p2_dot_sq + q_p1_dot_sq;
    let q_p5_dot_sq = q_P5_dot * q_P5_dot;
    let f6_of_motion_3 = f6_of_motion_2 + q_p5_dot_sq;
    let f6_of_motion_4 = f6_of_motion + f6_of_motion_3;
    let f6_of_motion_5 = q_P3_dot * (q_P3_dot - p_v_rod5_centre_2_2_of_q_p5_dot)
        + q_p4_dot_cos_q_p4 * p_v_rod3_frame_in_rod4_frame_1_2_of_q_p5_dot;
    let sin_q_p4_doubled = S::int(2) * sin_q_P4;
    let f6_of_motion_6 = q_P5_dot.mul_add(sin_q_p4_doubled, q_P3_dot);
    let q_p3_dot_doubled = S::int(2) * q_P3_dot;
    let f6_of_q_p5 = sin_q_P5 - S::int(1);
    let f6_of_q_p4_dot = q_p4_dot_cos_q_p4 * f6_of_q_p5;
    let f6_of_q_p4_dot_2 = q_p4_dot_sin_q_p4 * f6_of_q_p5;
    let f6_of_q_p5_dot = p_v_rod3_frame_in_rod4_frame_1_2_of_q_p5_dot * cos_q_P4;
    let f6_of_motion_7 = q_P2_dot
        * (f6_of_q_p4_dot_2.mul_add(S::int(2), q_P2_dot) - f6_of_q_p5_dot);
    let f6_of_motion_8 = q_p4_dot_sq + q_p1_dot_sq;
    let q_p4_dot_sin_q_p3 = q_P4_dot * sin_q_P3;
    let f6_of_q_p4_q_p5 = f6_of_q_p5.mul_add(sin_q_P4, -S::int(1));
    let sin_q_p3_cos_q_p5 = sin_q_P3 * cos_q_P5;
    let f6_of_place = f6_of_q_p4_q_p5.mul_add(cos_q_P3, sin_q_p3_cos_q_p5);
    let f6_of_q_p5_dot_2 = q_P5_dot * sin_q_p3_cos_q_p5.mul_add(sin_q_P4, cos_q_P3 * sin_q_P5);
    let f6_of_motion_9 = q_P2_dot
        * (f6_of_q_p5 * cos_q_P4 * q_p4_dot_sin_q_p3.mul_add(S::int(2), q_P2_dot)
            + q_p3_dot_doubled * f6_of_place + S::int(2) * f6_of_q_p5_dot_2);
    let f6_of_place_2 = (-cos_q_P3).mul_add(cos_q_P5, f6_of_q_p4_q_p5 * sin_q_P3);
    let f6_of_motion_10 = q_p5_dot_cos_q_p5.mul_add(sin_q_P4, f6_of_q_p4_dot);
    let f6_of_motion_10_doubled = S::int(2) * f6_of_motion_10;
    let f6_of_motion_11 = sin_q_P2
        * (q_p1_dot_sq
            - sin_q_P3
                * (f6_of_motion_2
                    + sin_q_P4
                        * (-f6_of_motion_4)
                            .mul_add(sin_q_P5, f6_of_motion + f6_of_motion_2) + f6_of_motion_5)
            - cos_q_P3
                * (cos_q_P5 * q_P3_dot.mul_add(f6_of_motion_6, f6_of_motion_3)
                    + q_p3_dot_doubled * f6_of_q_p4_dot) + f6_of_motion_7)
        - cos_q_P2
            * (cos_q_P4 * (sin_q_P5 * (q_p5_dot_sq + f6_of_motion_8) - f6_of_motion_8)
                + q_p4_dot_sin_q_p4 * p_v_rod3_frame_in_rod4_frame_1_2_of_q_p5_dot + f6_of_motion_9)
        + q_P1_dot
            * (p_v_rod5_centre_2_2_of_q_p5_dot.mul_add(sin_q_P3, -q_P1_dot)
                + q_p3_dot_doubled * f6_of_place_2 - f6_of_motion_10_doubled * cos_q_P3);
    let cos_q_p2_doubled = S::int(2) * cos_q_P2;
    let f6_of_motion_12 = q_P2_dot + q_p4_dot_sin_q_p3;
    let q_p3_dot_f6_of_place = q_P3_dot * f6_of_place;
    let sin_q_p2_doubled = S::int(2) * sin_q_P2;
    let f6_of_q_p5_dot_3 = q_P5_dot * q_p5_dot_sin_q_p5;
    let f6_of_motion_13 = q_P3_dot
        * (f6_of_motion_10_doubled
            .mul_add(sin_q_P3, p_v_rod5_centre_2_2_of_q_p5_dot * cos_q_P3)
            + q_p3_dot_f6_of_place) + q_P5_dot * q_p5_dot_cos_q_p5 * sin_q_P3
        + q_P1_dot
            * (cos_q_p2_doubled
                * (f6_of_q_p4_dot_2 - q_p5_dot_cos_q_p5 * cos_q_P4
                    + q_P2_dot * (S::int(1) + f6_of_place_2)) + q_P1_dot * f6_of_place
                + sin_q_p2_doubled
                    * ((f6_of_q_p5 * f6_of_motion_12).mul_add(cos_q_P4, f6_of_q_p5_dot_2)
                        + q_p3_dot_f6_of_place))
        + cos_q_P3
            * (q_P4_dot * (f6_of_q_p4_dot_2 - f6_of_q_p5_dot) + f6_of_q_p5_dot_3 * sin_q_P4);
    let f7_of_motion = f6_of_motion + q_p5_dot_sq;
    let f9_of_motion = q_P5_dot * q_p3_dot_doubled;
    let f9_of_motion_2 = q_P3_dot.mul_add(sin_q_P4, q_P5_dot);
    let f9_of_motion_2_doubled = S::int(2) * f9_of_motion_2;
    let f9_of_q_p2_dot = q_P2_dot * cos_q_p2_doubled;
    let q_p1_dot_cos_q_p3 = q_P1_dot * cos_q_P3;
    let f9_of_motion_3 = q_P4_dot + q_p2_dot_sin_q_p3;
    let cos_q_p4_doubled = S::int(2) * cos_q_P4;
    let sin_q_p3_cos_q_p1 = cos_q_P1 * sin_q_P3;
    let f9_of_place = sin_q_P1 * sin_q_P2 * cos_q_P3;
    // Values.
    let f1 = -S::ratio(1, 12) * q_P2_dot
        * p_w_rod1_frame_in_rod2_frame_1
            .mul_add(cos_q_P2, p_w_rod1_frame_in_rod2_frame_2 * sin_q_P2)
        + p_w_rod1_frame_in_rod2_frame_2_2 * cos_q_p2_by_12 - p_v_rod1_centre_3 * l_halved
        - p_w_rod1_frame_in_rod2_frame_1_2 * sin_q_p2_by_12;
    let f2 = cos_q_p2_by_12
        * ((-F_x_rod1_frame_in_rod2_frame_1_2)
            .mul_add(g_times_6, q_P1_dot * p_w_rod1_frame_in_rod2_frame_1)
            + F_x_rod5_frame_2 * mp_rod1_frame_1_times_54) + p_v_rod2_centre_1 * l_halved
        + sin_q_p2_by_12
            * ((-F_x_rod1_frame_in_rod2_frame_2)
                .mul_add(g_times_6, q_P1_dot * p_w_rod1_frame_in_rod2_frame_2)
                - F_x_rod1_frame_in_rod2_frame_1 * mp_rod1_frame_1_times_54)
        + S::ratio(1, 12) * f2_of_q_p3_dot;
    let f3 = S::ratio(1, 12) * f3_of_q_p2_dot - S::ratio(1, 2) * f3_of_place_3;
    let f4 = S::ratio(1, 12) * f4_of_place_6 - S::ratio(1, 2) * f4_of_place_7;
    let f5 = v_rod4_frame_in_rod5_frame_1
        .mul_add(p_v_rod4_frame_in_rod5_frame_2, -S::ratio(1, 12) * f5_of_place_4)
        - S::ratio(1, 2) * f5_of_place_5;
    let f6 = -l * f6_of_motion_13.mul_add(sin_q_P1, f6_of_motion_11 * cos_q_P1);
    let f7 = l
        * (sin_q_P2
            * (q_P4_dot
                * p_v_rod3_frame_in_rod4_frame_1_2_of_q_p5_dot
                    .mul_add(sin_q_P4, f6_of_q_p4_dot) + f6_of_motion_9
                + f6_of_q_p5_dot_3 * cos_q_P4)
            + cos_q_P2
                * (f6_of_motion_7
                    - cos_q_P3
                        * (cos_q_P5 * (q_p2_dot_sq + q_p5_dot_sq)
                            + q_P3_dot
                                * f6_of_q_p4_dot
                                    .mul_add(S::int(2), f6_of_motion_6 * cos_q_P5))
                    - sin_q_P3
                        * (q_p2_dot_sq + f6_of_motion_5
                            + sin_q_P4
                                * (f6_of_motion + q_p2_dot_sq
                                    - sin_q_P5 * (q_p2_dot_sq + f7_of_motion)))));
    let f8 = l * (-f6_of_motion_13).mul_add(cos_q_P1, f6_of_motion_11 * sin_q_P1);
    let f9 = cos_q_P5
        * (sin_q_P1
            * (sin_q_P3
                * (sin_q_P2 * f6_of_motion_4.mul_add(sin_q_P4, f9_of_motion)
                    + q_P1_dot * f9_of_motion_2_doubled - q_p4_dot_cos_q_p4 * f9_of_q_p2_dot)
                - cos_q_P2
                    * (cos_q_P4 * (q_p4_dot_sq + f6_of_motion_3)
                        + q_p2_dot_cos_q_p3 * f9_of_motion_2_doubled)
                + S::int(2) * q_P4_dot
                    * (sin_q_P2 * (-q_p3_dot_cos_q_p3).mul_add(cos_q_P4, q_P2_dot * sin_q_P4)
                        - q_p1_dot_cos_q_p3 * cos_q_P4))
            - cos_q_P1
                * (cos_q_P3 * f7_of_motion.mul_add(sin_q_P4, f9_of_motion)
                    + q_p4_dot_cos_q_p4 * q_p3_dot_doubled * sin_q_P3
                    + q_P1_dot
                        * (sin_q_p2_doubled
                            * f9_of_motion_2
                                .mul_add(cos_q_P3, f6_of_motion_12 * cos_q_P4)
                            + sin_q_P4
                                * cos_q_p2_doubled
                                    .mul_add(f9_of_motion_3, q_p1_dot_cos_q_p3))))
        + sin_q_P5
            * (q_P5_dot
                * (sin_q_P1
                    * (sin_q_p4_doubled * f9_of_motion_3.mul_add(cos_q_P2, q_p1_dot_cos_q_p3)
                        + sin_q_P2
                            * (cos_q_P3 * q_p3_dot_doubled.mul_add(sin_q_P4, q_P5_dot)
                                + f6_of_motion_12 * cos_q_p4_doubled))
                    + cos_q_P1
                        * (sin_q_P3 * w_rod3_frame_1.mul_add(sin_q_p4_doubled, q_P5_dot)
                            - cos_q_p4_doubled
                                * q_P4_dot.mul_add(cos_q_P3, w_rod1_frame_in_rod2_frame_2)))
                + q_P1_dot
                    * (cos_q_P3
                        * (sin_q_P1 * (w_rod1_frame_in_rod2_frame_1 + q_p3_dot_doubled)
                            - f9_of_q_p2_dot * cos_q_P1)
                        + sin_q_p3_cos_q_p1 * q_p3_dot_doubled.mul_add(sin_q_P2, q_P1_dot))
                + q_p2_dot_sq * f9_of_place
                + q_P3_dot
                    * (q_P3_dot * (sin_q_p3_cos_q_p1 + f9_of_place)
                        + q_p2_dot_sin_q_p3 * cos_q_p2_doubled * sin_q_P1));
    [f1, f2, f3, f4, f5, f6, f7, f8, f9]
}

/// The accelerations (q_P1'', q_P2'', q_P3'', q_P4'', q_P5''), solved for when this code was generated.
///
/// 2252 operations, 5 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 5] {
    let Parameters { l, m, g } = *p;
    let [q_P1, q_P2, q_P3, q_P4, q_P5] = *q;
    let [q_P1_dot, q_P2_dot, q_P3_dot, q_P4_dot, q_P5_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q_P2, cos_q_P2) = q_P2.sin_cos();
    let (sin_q_P3, cos_q_P3) = q_P3.sin_cos();
    let (sin_q_P4, cos_q_P4) = q_P4.sin_cos();
    let (sin_q_P5, cos_q_P5) = q_P5.sin_cos();
    let (sin_q_P1, cos_q_P1) = q_P1.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_rod1_frame_in_rod2_frame_1 = q_P1_dot * sin_q_P2;
    let w_rod1_frame_in_rod2_frame_2 = q_P1_dot * cos_q_P2;
    let w_rod2_frame_in_rod3_frame_2 = w_rod1_frame_in_rod2_frame_2
        .mul_add(cos_q_P3, q_P2_dot * sin_q_P3);
    let w_rod2_frame_in_rod3_frame_3_of_q_p2_dot = (-q_P2_dot)
        .mul_add(cos_q_P3, w_rod1_frame_in_rod2_frame_2 * sin_q_P3);
    let w_rod2_frame_in_rod3_frame_3 = -w_rod2_frame_in_rod3_frame_3_of_q_p2_dot;
    let w_rod3_frame_1 = q_P3_dot + w_rod1_frame_in_rod2_frame_1;
    let w_rod3_frame_in_rod4_frame_1 = (-w_rod3_frame_1)
        .mul_add(cos_q_P4, w_rod2_frame_in_rod3_frame_3 * sin_q_P4);
    let w_rod3_frame_in_rod4_frame_3 = w_rod3_frame_1
        .mul_add(sin_q_P4, w_rod2_frame_in_rod3_frame_3 * cos_q_P4);
    let w_rod4_frame_2 = q_P4_dot + w_rod2_frame_in_rod3_frame_2;
    let w_rod4_frame_in_rod5_frame_1 = (-w_rod4_frame_2)
        .mul_add(sin_q_P5, w_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let w_rod5_frame_3 = q_P5_dot + w_rod3_frame_in_rod4_frame_3;
    let v_rod1_centre_3 = l * q_P1_dot;
    let v_rod2_centre_1 = l * q_P2_dot;
    let v_rod2_centre_3_of_place = l * w_rod1_frame_in_rod2_frame_1;
    let v_rod2_centre_3 = (-v_rod1_centre_3)
        .mul_add(S::int(2), v_rod2_centre_3_of_place);
    let l_sq = l * l;
    let H_rod1_2 = m * l_sq;
    let H_rod2_1 = w_rod1_frame_in_rod2_frame_1 * H_rod1_2;
    let v_rod3_centre_3 = v_rod2_centre_3_of_place - v_rod1_centre_3;
    let v_rod2_frame_in_rod3_frame_2 = v_rod3_centre_3 * sin_q_P3;
    let v_rod2_frame_in_rod3_frame_3 = v_rod3_centre_3 * cos_q_P3;
    let v_rod3_centre_1_of_place = l * w_rod2_frame_in_rod3_frame_2;
    let v_rod3_centre_1 = (-v_rod2_centre_1)
        .mul_add(S::int(2), v_rod3_centre_1_of_place);
    let l_w_rod3_frame_1 = l * w_rod3_frame_1;
    let v_rod3_centre_2 = (-v_rod2_frame_in_rod3_frame_2)
        .mul_add(S::int(2), l_w_rod3_frame_1);
    let H_rod3_1 = w_rod3_frame_1 * H_rod1_2;
    let H_rod3_2 = w_rod2_frame_in_rod3_frame_2 * H_rod1_2;
    let v_rod4_centre_1 = v_rod3_centre_1_of_place - v_rod2_centre_1;
    let v_rod4_centre_2 = l_w_rod3_frame_1 - v_rod2_frame_in_rod3_frame_2;
    let v_rod3_frame_in_rod4_frame_1 = (-v_rod4_centre_1)
        .mul_add(cos_q_P4, v_rod2_frame_in_rod3_frame_3 * sin_q_P4);
    let v_rod3_frame_in_rod4_frame_3 = v_rod4_centre_1
        .mul_add(sin_q_P4, v_rod2_frame_in_rod3_frame_3 * cos_q_P4);
    let v_rod4_centre_2_2_of_place = l * w_rod3_frame_in_rod4_frame_3;
    let v_rod4_centre_2_2 = v_rod4_centre_2
        .mul_add(S::int(2), v_rod4_centre_2_2_of_place);
    let l_w_rod4_frame_2 = l * w_rod4_frame_2;
    let v_rod4_centre_3 = v_rod3_frame_in_rod4_frame_3
        .mul_add(S::int(2), l_w_rod4_frame_2);
    let H_rod4_2 = w_rod4_frame_2 * H_rod1_2;
    let H_rod4_3 = w_rod3_frame_in_rod4_frame_3 * H_rod1_2;
    let v_rod5_centre_2 = v_rod4_centre_2 + v_rod4_centre_2_2_of_place;
    let v_rod5_centre_3 = v_rod3_frame_in_rod4_frame_3 + l_w_rod4_frame_2;
    let v_rod4_frame_in_rod5_frame_1 = v_rod5_centre_2
        .mul_add(sin_q_P5, v_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let v_rod4_frame_in_rod5_frame_2_of_place = (-v_rod3_frame_in_rod4_frame_1)
        .mul_add(sin_q_P5, v_rod5_centre_2 * cos_q_P5);
    let v_rod4_frame_in_rod5_frame_2 = -v_rod4_frame_in_rod5_frame_2_of_place;
    let v_rod5_centre_1 = (-v_rod4_frame_in_rod5_frame_1)
        .mul_add(S::int(2), l * w_rod5_frame_3);
    let v_rod5_centre_3_2 = v_rod5_centre_3
        .mul_add(S::int(2), l * w_rod4_frame_in_rod5_frame_1);
    let H_rod5_1 = w_rod4_frame_in_rod5_frame_1 * H_rod1_2;
    let H_rod5_3 = w_rod5_frame_3 * H_rod1_2;
    let p_v_rod5_centre_3 = m * v_rod5_centre_3_2;
    let p_v_rod5_centre_1 = m * v_rod5_centre_1;
    let p_v_rod4_frame_in_rod5_frame_2 = m * v_rod4_frame_in_rod5_frame_2;
    let cos_q_p5_doubled = S::int(2) * cos_q_P5;
    let p_v_rod5_centre_2 = p_v_rod4_frame_in_rod5_frame_2
        .mul_add(cos_q_p5_doubled, p_v_rod5_centre_1 * sin_q_P5);
    let p_v_rod4_centre_3 = m * v_rod4_centre_3;
    let p_v_rod4_centre_2 = m * v_rod4_centre_2_2;
    let p_v_rod3_frame_in_rod4_frame_3 = p_v_rod5_centre_3 + p_v_rod4_centre_3;
    let m_doubled = S::int(2) * m;
    let sin_q_p5_doubled = S::int(2) * sin_q_P5;
    let p_v_rod3_frame_in_rod4_frame_1_of_place = (-p_v_rod4_frame_in_rod5_frame_2)
        .mul_add(sin_q_p5_doubled, p_v_rod5_centre_1 * cos_q_P5);
    let p_v_rod3_frame_in_rod4_frame_1 = v_rod3_frame_in_rod4_frame_1
        .mul_add(m_doubled, -p_v_rod3_frame_in_rod4_frame_1_of_place);
    let p_v_rod4_centre_2_2 = p_v_rod5_centre_2 - p_v_rod4_centre_2;
    let p_v_rod4_centre_1 = (-p_v_rod3_frame_in_rod4_frame_1)
        .mul_add(cos_q_P4, p_v_rod3_frame_in_rod4_frame_3 * sin_q_P4);
    let p_v_rod3_centre_2 = m * v_rod3_centre_2;
    let p_v_rod3_centre_1 = m * v_rod3_centre_1;
    let p_v_rod2_frame_in_rod3_frame_3 = p_v_rod3_frame_in_rod4_frame_1
        .mul_add(sin_q_P4, p_v_rod3_frame_in_rod4_frame_3 * cos_q_P4)
        + v_rod2_frame_in_rod3_frame_3 * m_doubled;
    let p_v_rod2_frame_in_rod3_frame_2 = p_v_rod4_centre_2_2 - p_v_rod3_centre_2;
    let p_v_rod3_centre_3 = p_v_rod2_frame_in_rod3_frame_2
        .mul_add(sin_q_P3, p_v_rod2_frame_in_rod3_frame_3 * cos_q_P3);
    let p_v_rod2_centre_3 = m * v_rod2_centre_3;
    let l_times_3 = S::int(3) * l;
    let p_w_rod5_frame_3 = p_v_rod5_centre_1.mul_add(l_times_3, H_rod5_3);
    let p_w_rod4_frame_in_rod5_frame_1 = p_v_rod5_centre_3.mul_add(l_times_3, H_rod5_1);
    let l_times_6 = S::int(6) * l;
    let p_w_rod4_frame_2_of_place = p_w_rod4_frame_in_rod5_frame_1 * sin_q_P5;
    let p_w_rod4_frame_2 = p_v_rod4_centre_3.mul_add(l_times_3, H_rod4_2)
        + p_v_rod5_centre_3 * l_times_6 - p_w_rod4_frame_2_of_place;
    let p_w_rod3_frame_in_rod4_frame_3 = p_v_rod4_centre_2
        .mul_add(l_times_3, H_rod4_3 + p_w_rod5_frame_3) - p_v_rod5_centre_2 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_1 = p_w_rod4_frame_in_rod5_frame_1 * cos_q_P5;
    let p_w_rod3_frame_1 = p_w_rod3_frame_in_rod4_frame_3.mul_add(sin_q_P4, H_rod3_1)
        - p_w_rod3_frame_in_rod4_frame_1 * cos_q_P4 + p_v_rod3_centre_2 * l_times_3
        - p_v_rod4_centre_2_2 * l_times_6;
    let p_w_rod2_frame_in_rod3_frame_3 = p_w_rod3_frame_in_rod4_frame_1
        .mul_add(sin_q_P4, p_w_rod3_frame_in_rod4_frame_3 * cos_q_P4);
    let p_w_rod2_frame_in_rod3_frame_2 = p_v_rod3_centre_1
        .mul_add(l_times_3, H_rod3_2 + p_w_rod4_frame_2) + p_v_rod4_centre_1 * l_times_6;
    let p_w_rod1_frame_in_rod2_frame_2 = (-p_w_rod2_frame_in_rod3_frame_2)
        .mul_add(cos_q_P3, p_w_rod2_frame_in_rod3_frame_3 * sin_q_P3);
    let p_w_rod1_frame_in_rod2_frame_1 = p_v_rod2_centre_3
        .mul_add(l_times_3, H_rod2_1 + p_w_rod3_frame_1) + p_v_rod3_centre_3 * l_times_6;
    let w_rod1_frame_in_rod2_frame_1_2 = q_P2_dot * w_rod1_frame_in_rod2_frame_2;
    let w_rod1_frame_in_rod2_frame_2_2 = q_P2_dot * w_rod1_frame_in_rod2_frame_1;
    let w_rod2_frame_in_rod3_frame_2_2 = (-q_P3_dot)
        .mul_add(
            w_rod2_frame_in_rod3_frame_3_of_q_p2_dot,
            -w_rod1_frame_in_rod2_frame_2_2 * cos_q_P3,
        );
    let w_rod2_frame_in_rod3_frame_3_2 = (-w_rod1_frame_in_rod2_frame_2_2)
        .mul_add(sin_q_P3, q_P3_dot * w_rod2_frame_in_rod3_frame_2);
    let q_p4_dot_cos_q_p4 = q_P4_dot * cos_q_P4;
    let q_p4_dot_sin_q_p4 = q_P4_dot * sin_q_P4;
    let w_rod3_frame_in_rod4_frame_1_2 = (-w_rod1_frame_in_rod2_frame_1_2)
        .mul_add(cos_q_P4, w_rod2_frame_in_rod3_frame_3 * q_p4_dot_cos_q_p4)
        - w_rod2_frame_in_rod3_frame_3_2 * sin_q_P4 + w_rod3_frame_1 * q_p4_dot_sin_q_p4;
    let w_rod3_frame_in_rod4_frame_3_2 = (-w_rod1_frame_in_rod2_frame_1_2)
        .mul_add(sin_q_P4, w_rod2_frame_in_rod3_frame_3_2 * cos_q_P4)
        - w_rod3_frame_1 * q_p4_dot_cos_q_p4 + w_rod2_frame_in_rod3_frame_3 * q_p4_dot_sin_q_p4;
    let w_rod4_frame_in_rod5_frame_1_2 = q_P5_dot
        * w_rod4_frame_2.mul_add(cos_q_P5, w_rod3_frame_in_rod4_frame_1 * sin_q_P5)
        + w_rod2_frame_in_rod3_frame_2_2 * sin_q_P5 - w_rod3_frame_in_rod4_frame_1_2 * cos_q_P5;
    let v_rod2_centre_3_2 = l * w_rod1_frame_in_rod2_frame_1_2;
    let H_rod2_1_2 = w_rod1_frame_in_rod2_frame_1_2 * H_rod1_2;
    let q_p3_dot_cos_q_p3 = q_P3_dot * cos_q_P3;
    let v_rod2_frame_in_rod3_frame_2_2 = v_rod3_centre_3
        .mul_add(q_p3_dot_cos_q_p3, v_rod2_centre_3_2 * sin_q_P3);
    let q_p3_dot_sin_q_p3 = q_P3_dot * sin_q_P3;
    let v_rod2_frame_in_rod3_frame_3_2 = (-v_rod2_centre_3_2)
        .mul_add(cos_q_P3, v_rod3_centre_3 * q_p3_dot_sin_q_p3);
    let v_rod3_centre_1_2 = l * w_rod2_frame_in_rod3_frame_2_2;
    let v_rod3_centre_2_2 = (-v_rod2_frame_in_rod3_frame_2_2)
        .mul_add(S::int(2), v_rod2_centre_3_2);
    let H_rod3_2_2 = w_rod2_frame_in_rod3_frame_2_2 * H_rod1_2;
    let v_rod4_centre_2_3 = v_rod2_centre_3_2 - v_rod2_frame_in_rod3_frame_2_2;
    let v_rod3_frame_in_rod4_frame_1_2 = (-v_rod2_frame_in_rod3_frame_3_2)
        .mul_add(sin_q_P4, v_rod2_frame_in_rod3_frame_3 * q_p4_dot_cos_q_p4)
        - v_rod3_centre_1_2 * cos_q_P4 + v_rod4_centre_1 * q_p4_dot_sin_q_p4;
    let v_rod3_frame_in_rod4_frame_3_2 = (-v_rod3_centre_1_2)
        .mul_add(sin_q_P4, v_rod2_frame_in_rod3_frame_3_2 * cos_q_P4)
        - v_rod4_centre_1 * q_p4_dot_cos_q_p4 + v_rod2_frame_in_rod3_frame_3 * q_p4_dot_sin_q_p4;
    let v_rod4_centre_2_4_of_place = l * w_rod3_frame_in_rod4_frame_3_2;
    let v_rod4_centre_2_4 = (-v_rod4_centre_2_3)
        .mul_add(S::int(2), v_rod4_centre_2_4_of_place);
    let v_rod4_centre_3_2 = (-v_rod3_frame_in_rod4_frame_3_2)
        .mul_add(S::int(2), v_rod3_centre_1_2);
    let H_rod4_3_2 = w_rod3_frame_in_rod4_frame_3_2 * H_rod1_2;
    let v_rod5_centre_2_2 = v_rod4_centre_2_4_of_place - v_rod4_centre_2_3;
    let v_rod5_centre_3_3 = v_rod3_centre_1_2 - v_rod3_frame_in_rod4_frame_3_2;
    let v_rod4_frame_in_rod5_frame_1_2 = (-v_rod3_frame_in_rod4_frame_1_2)
        .mul_add(cos_q_P5, v_rod5_centre_2_2 * sin_q_P5)
        - q_P5_dot * v_rod4_frame_in_rod5_frame_2_of_place;
    let v_rod4_frame_in_rod5_frame_2_2 = v_rod3_frame_in_rod4_frame_1_2
        .mul_add(sin_q_P5, q_P5_dot * v_rod4_frame_in_rod5_frame_1) + v_rod5_centre_2_2 * cos_q_P5;
    let v_rod5_centre_1_2 = (-v_rod4_frame_in_rod5_frame_1_2)
        .mul_add(S::int(2), v_rod4_centre_2_4_of_place);
    let v_rod5_centre_3_4 = (-v_rod5_centre_3_3)
        .mul_add(S::int(2), l * w_rod4_frame_in_rod5_frame_1_2);
    let H_rod5_1_2 = w_rod4_frame_in_rod5_frame_1_2 * H_rod1_2;
    let p_v_rod5_centre_3_2 = m * v_rod5_centre_3_4;
    let p_v_rod5_centre_1_2 = m * v_rod5_centre_1_2;
    let p_v_rod4_frame_in_rod5_frame_2_2 = m * v_rod4_frame_in_rod5_frame_2_2;
    let p_v_rod5_centre_2_2 = (-p_v_rod4_frame_in_rod5_frame_2_2)
        .mul_add(cos_q_p5_doubled, p_v_rod5_centre_1_2 * sin_q_P5)
        - q_P5_dot * p_v_rod3_frame_in_rod4_frame_1_of_place;
    let p_v_rod4_centre_3_2 = m * v_rod4_centre_3_2;
    let p_v_rod4_centre_2_3 = m * v_rod4_centre_2_4;
    let p_v_rod3_frame_in_rod4_frame_3_2 = p_v_rod5_centre_3_2 - p_v_rod4_centre_3_2;
    let p_v_rod3_frame_in_rod4_frame_1_2 = p_v_rod5_centre_1_2
        .mul_add(cos_q_P5, q_P5_dot * p_v_rod5_centre_2)
        + v_rod3_frame_in_rod4_frame_1_2 * m_doubled
        + p_v_rod4_frame_in_rod5_frame_2_2 * sin_q_p5_doubled;
    let p_v_rod4_centre_2_4 = p_v_rod5_centre_2_2 - p_v_rod4_centre_2_3;
    let p_v_rod4_centre_1_2 = (-p_v_rod3_frame_in_rod4_frame_3_2)
        .mul_add(sin_q_P4, p_v_rod3_frame_in_rod4_frame_3 * q_p4_dot_cos_q_p4)
        - p_v_rod3_frame_in_rod4_frame_1_2 * cos_q_P4
        + p_v_rod3_frame_in_rod4_frame_1 * q_p4_dot_sin_q_p4;
    let p_v_rod3_centre_2_2 = m * v_rod3_centre_2_2;
    let p_v_rod3_centre_1_2 = m * v_rod3_centre_1_2;
    let p_v_rod2_frame_in_rod3_frame_3_2 = (-p_v_rod3_frame_in_rod4_frame_1_2)
        .mul_add(sin_q_P4, p_v_rod3_frame_in_rod4_frame_3_2 * cos_q_P4)
        + v_rod2_frame_in_rod3_frame_3_2 * m_doubled
        - p_v_rod3_frame_in_rod4_frame_1 * q_p4_dot_cos_q_p4
        + p_v_rod3_frame_in_rod4_frame_3 * q_p4_dot_sin_q_p4;
    let p_v_rod2_frame_in_rod3_frame_2_2 = p_v_rod4_centre_2_4 + p_v_rod3_centre_2_2;
    let p_v_rod3_centre_3_2 = p_v_rod2_frame_in_rod3_frame_2_2
        .mul_add(sin_q_P3, p_v_rod2_frame_in_rod3_frame_3_2 * cos_q_P3)
        - p_v_rod2_frame_in_rod3_frame_2 * q_p3_dot_cos_q_p3
        + p_v_rod2_frame_in_rod3_frame_3 * q_p3_dot_sin_q_p3;
    let p_v_rod2_centre_3_2 = m * v_rod2_centre_3_2;
    let p_v_rod1_centre_3 = p_v_rod3_centre_3_2 - p_v_rod2_centre_3_2;
    let p_w_rod5_frame_3_2 = p_v_rod5_centre_1_2.mul_add(l_times_3, H_rod4_3_2);
    let p_w_rod4_frame_in_rod5_frame_1_2 = p_v_rod5_centre_3_2
        .mul_add(l_times_3, H_rod5_1_2);
    let p_w_rod4_frame_2_2 = (-q_P5_dot)
        .mul_add(p_w_rod3_frame_in_rod4_frame_1, H_rod3_2_2)
        + p_w_rod4_frame_in_rod5_frame_1_2 * sin_q_P5 + p_v_rod4_centre_3_2 * l_times_3
        - p_v_rod5_centre_3_2 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_3_2 = p_v_rod4_centre_2_3
        .mul_add(l_times_3, H_rod4_3_2 + p_w_rod5_frame_3_2) - p_v_rod5_centre_2_2 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_1_2 = q_P5_dot
        .mul_add(p_w_rod4_frame_2_of_place, p_w_rod4_frame_in_rod5_frame_1_2 * cos_q_P5);
    let p_w_rod3_frame_1_2 = (-p_w_rod3_frame_in_rod4_frame_3_2)
        .mul_add(sin_q_P4, H_rod2_1_2) + p_w_rod3_frame_in_rod4_frame_1_2 * cos_q_P4
        + p_v_rod3_centre_2_2 * l_times_3 + p_v_rod4_centre_2_4 * l_times_6
        + p_w_rod3_frame_in_rod4_frame_3 * q_p4_dot_cos_q_p4
        + p_w_rod3_frame_in_rod4_frame_1 * q_p4_dot_sin_q_p4;
    let p_w_rod2_frame_in_rod3_frame_3_2 = p_w_rod3_frame_in_rod4_frame_1_2
        .mul_add(sin_q_P4, p_w_rod3_frame_in_rod4_frame_3_2 * cos_q_P4)
        - p_w_rod3_frame_in_rod4_frame_1 * q_p4_dot_cos_q_p4
        + p_w_rod3_frame_in_rod4_frame_3 * q_p4_dot_sin_q_p4;
    let p_w_rod2_frame_in_rod3_frame_2_2 = p_v_rod3_centre_1_2
        .mul_add(l_times_3, H_rod3_2_2 + p_w_rod4_frame_2_2) + p_v_rod4_centre_1_2 * l_times_6;
    let p_w_rod1_frame_in_rod2_frame_2_2 = (-p_w_rod2_frame_in_rod3_frame_3_2)
        .mul_add(sin_q_P3, p_w_rod2_frame_in_rod3_frame_3 * q_p3_dot_cos_q_p3)
        - p_w_rod2_frame_in_rod3_frame_2_2 * cos_q_P3
        + p_w_rod2_frame_in_rod3_frame_2 * q_p3_dot_sin_q_p3;
    let p_w_rod1_frame_in_rod2_frame_1_2 = p_v_rod2_centre_3_2
        .mul_add(l_times_3, H_rod2_1_2 + p_w_rod3_frame_1_2) - p_v_rod3_centre_3_2 * l_times_6;
    let mp_rod1_frame_1 = l * m;
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
    let x_rod1_frame_in_rod2_frame_1_2 = mp_rod1_frame_1 * cos_q_P2;
    let x_rod1_frame_in_rod2_frame_2_2 = mp_rod1_frame_1 * sin_q_P2;
    let x_rod5_frame_2 = (-x_rod1_frame_in_rod2_frame_2_2)
        .mul_add(S::int(9), S::int(7) * mp_rod1_frame_1);
    let x_rod2_frame_in_rod3_frame_2_2 = x_rod5_frame_2 * cos_q_P3;
    let x_rod2_frame_in_rod3_frame_3_2 = x_rod5_frame_2 * sin_q_P3;
    let x_rod5_frame_3 = mp_rod1_frame_1
        .mul_add(S::int(5), -x_rod2_frame_in_rod3_frame_3_2);
    let x_rod3_frame_in_rod4_frame_1_2_of_place = S::int(9) * x_rod1_frame_in_rod2_frame_1_2;
    let x_rod3_frame_in_rod4_frame_1_2 = (-x_rod3_frame_in_rod4_frame_1_2_of_place)
        .mul_add(cos_q_P4, x_rod5_frame_3 * sin_q_P4);
    let x_rod3_frame_in_rod4_frame_3_2 = x_rod3_frame_in_rod4_frame_1_2_of_place
        .mul_add(sin_q_P4, x_rod5_frame_3 * cos_q_P4);
    let x_rod5_frame_1 = mp_rod1_frame_1
        .mul_add(S::int(3), x_rod3_frame_in_rod4_frame_1_2);
    let x_rod4_frame_in_rod5_frame_1_2 = (-x_rod2_frame_in_rod3_frame_2_2)
        .mul_add(sin_q_P5, x_rod5_frame_1 * cos_q_P5);
    let x_rod4_frame_in_rod5_frame_2_2 = x_rod5_frame_1
        .mul_add(sin_q_P5, x_rod2_frame_in_rod3_frame_2_2 * cos_q_P5);
    let x_rod5_frame_2_2 = mp_rod1_frame_1 - x_rod4_frame_in_rod5_frame_2_2;
    let F_x_rod5_frame_1 = x_rod4_frame_in_rod5_frame_2
        .mul_add(sin_q_P5, x_rod4_frame_in_rod5_frame_1 * cos_q_P5);
    let F_x_rod5_frame_3 = F_x_rod5_frame_1
        .mul_add(sin_q_P4, x_rod3_frame_in_rod4_frame_3 * cos_q_P4);
    let F_x_rod2_frame_in_rod3_frame_2 = (-x_rod4_frame_in_rod5_frame_1)
        .mul_add(sin_q_P5, x_rod4_frame_in_rod5_frame_2 * cos_q_P5);
    let F_x_rod5_frame_2 = (-F_x_rod2_frame_in_rod3_frame_2)
        .mul_add(cos_q_P3, F_x_rod5_frame_3 * sin_q_P3);
    let F_x_rod1_frame_in_rod2_frame_1 = (-F_x_rod5_frame_1)
        .mul_add(cos_q_P4, x_rod3_frame_in_rod4_frame_3 * sin_q_P4);
    let F_x_rod3_frame_in_rod4_frame_1 = (-x_rod4_frame_in_rod5_frame_1_2)
        .mul_add(cos_q_P5, x_rod5_frame_2_2 * sin_q_P5);
    let F_x_rod2_frame_in_rod3_frame_3 = (-F_x_rod3_frame_in_rod4_frame_1)
        .mul_add(sin_q_P4, x_rod3_frame_in_rod4_frame_3_2 * cos_q_P4);
    let F_x_rod2_frame_in_rod3_frame_2_2 = x_rod5_frame_2_2
        .mul_add(cos_q_P5, x_rod4_frame_in_rod5_frame_1_2 * sin_q_P5);
    let F_x_rod1_frame_in_rod2_frame_2 = F_x_rod2_frame_in_rod3_frame_2_2
        .mul_add(cos_q_P3, F_x_rod2_frame_in_rod3_frame_3 * sin_q_P3);
    let F_x_rod1_frame_in_rod2_frame_1_2 = F_x_rod3_frame_in_rod4_frame_1
        .mul_add(cos_q_P4, x_rod3_frame_in_rod4_frame_3_2 * sin_q_P4);
    let p_v_rod2_centre_1 = p_v_rod4_centre_1_2 + p_v_rod3_centre_1_2;
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
    let sin_q_p2_sin_q_p4 = sin_q_P2 * sin_q_P4;
    let ratio_q_P2_u_P1_of_place_3 = sin_q_p2_sin_q_p4
        .mul_add(sin_q_P3, -cos_q_p2_cos_q_p4);
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
    let ratio_q_P2_u_P1_of_q_p4_q_p5_2 = S::int(1) - ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_3 = -ratio_q_P2_u_P1_of_q_p4_q_p5_2;
    let cos_q_p3_cos_q_p5 = cos_q_P3 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_14 = ratio_q_P2_u_P1_of_q_p4_q_p5_3
        .mul_add(sin_q_P3, -cos_q_p3_cos_q_p5);
    let ratio_q_P2_u_P1_of_place_15 = -ratio_q_P2_u_P1_of_place_14;
    let ratio_q_P2_u_P1_of_place_16 = ratio_q_P2_u_P1_of_q_p4_q_p5_3
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p5);
    let ratio_q_P2_u_P1_of_place_17 = ratio_q_P2_u_P1_of_place_16 * cos_q_P1;
    let ratio_q_P2_u_P1_of_place_18 = l
        * ratio_q_P2_u_P1_of_place_17
            .mul_add(sin_q_P2, ratio_q_P2_u_P1_of_place_15 * sin_q_P1);
    let sin_q_p3_sin_q_p5 = sin_q_P3 * sin_q_P5;
    let ratio_q_P2_u_P1_of_place_19 = cos_q_p3_cos_q_p5
        .mul_add(sin_q_P4, -sin_q_p3_sin_q_p5);
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
    let ratio_q_P2_u_P1_of_place_32 = -S::int(1) - ratio_q_P2_u_P1_of_place_14;
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
    let ratio_q_P2_u_P1_of_q_p3 = S::int(1) - sin_q_P3;
    let ratio_q_P2_u_P1_of_q_p3_2 = -ratio_q_P2_u_P1_of_q_p3;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_3 = (-ratio_q_P2_u_P1_of_q_p3_2)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_q_p3_q_p5_2);
    let ratio_q_P2_u_P1_of_place_44 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_3)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_q_p3_q_p5 * sin_q_p2_sin_q_p1);
    let ratio_q_P2_u_P1_of_place_45 = ratio_q_P2_u_P1_of_q_p4_q_p5 * cos_q_p2_sin_q_p1;
    let ratio_q_P2_u_P1_of_place_46 = ratio_q_P2_u_P1_of_place_44
        .mul_add(cos_q_P4, ratio_q_P2_u_P1_of_place_45);
    let ratio_q_P2_u_P1_of_place_47 = sin_q_p2_cos_q_p4
        .mul_add(ratio_q_P2_u_P1_of_q_p3_2, cos_q_p2_sin_q_p4);
    let ratio_q_P2_u_P1_of_place_48 = (-ratio_q_P2_u_P1_of_place_47)
        .mul_add(sin_q_P3, cos_q_p2_sin_q_p4);
    let cos_q_p5_sin_q_p1 = sin_q_P1 * cos_q_P5;
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
    let ratio_q_P2_u_P1_of_q_p4_q_p5_4 = ratio_q_P2_u_P1_of_q_p4_2
        .mul_add(sin_q_P5, cos_q_p4_sq);
    let ratio_q_P2_u_P1_of_place_52 = ratio_q_P2_u_P1_of_q_p4_q_p5_4 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_53 = (-cos_q_p3_cos_q_p5)
        .mul_add(ratio_q_P2_u_P1_of_q_p4, ratio_q_P2_u_P1_of_place_52);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_5 = sin_q_P5 + ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_place_54 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_of_q_p4_q_p5_5;
    let ratio_q_P2_u_P1_of_place_55 = ratio_q_P2_u_P1_of_place_53
        .mul_add(sin_q_P2, -ratio_q_P2_u_P1_of_place_54);
    let ratio_q_P2_u_P1_of_place_56 = ratio_q_P2_u_P1_of_q_p4_q_p5_4 * cos_q_P3;
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
    let ratio_q_P2_u_P1_of_place_65 = l_sq * ratio_q_P2_u_P1_of_place_33;
    let ratio_q_P2_u_P1_of_place_66 = l * ratio_q_P2_u_P1_of_place_21;
    let ratio_q_P2_u_P1_of_q_p3_q_p5_4 = cos_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_place_67 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_4)
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_of_q_p3_2 * sin_q_P5);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_5 = ratio_q_P2_u_P1_of_q_p3_q_p5 + cos_q_p3_cos_q_p5;
    let ratio_q_P2_u_P1_of_place_68 = (-sin_q_p2_cos_q_p4)
        .mul_add(ratio_q_P2_u_P1_of_q_p3_q_p5_5, ratio_q_P2_u_P1_of_place_67 * cos_q_P2);
    let ratio_q_P2_u_P1_of_q_p3_q_p5_6 = sin_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p3_q_p5_2;
    let ratio_q_P2_u_P1_of_place_69 = ratio_q_P2_u_P1_of_q_p3_q_p5_6 * cos_q_P1;
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
    let ratio_q_P2_u_P1_of_q_p3_q_p5_7 = (-ratio_q_P2_u_P1_of_q_p3_q_p5_2)
        .mul_add(S::int(2), sin_q_p3_cos_q_p5);
    let ratio_q_P2_u_P1_of_place_74 = ratio_q_P2_u_P1_of_q_p3_q_p5_7
        .mul_add(cos_q_P1, sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_of_q_p3_q_p5_5);
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
    let ratio_q_P2_u_P1_of_q_p5_3 = S::int(2) * ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_q_p5_4 = cos_q_p5_sq - ratio_q_P2_u_P1_of_q_p5_3;
    let cos_q_p4_sq_doubled = S::int(2) * cos_q_p4_sq;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_6 = ratio_q_P2_u_P1_of_q_p5_4 * cos_q_p4_sq_doubled;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_7 = -ratio_q_P2_u_P1_of_q_p5 - ratio_q_P2_u_P1_of_q_p4_q_p5_6;
    let ratio_q_P2_u_P1_of_q_p5_5 = ratio_q_P2_u_P1_of_q_p5 - cos_q_p5_sq;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_8 = cos_q_p4_sq * ratio_q_P2_u_P1_of_q_p5_4;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_9 = -ratio_q_P2_u_P1_of_q_p5_5
        - ratio_q_P2_u_P1_of_q_p4_q_p5_8;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_10 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(cos_q_p4_sq, ratio_q_P2_u_P1_of_q_p4_q_p5_9 * sin_q_P4);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_11 = ratio_q_P2_u_P1_of_q_p4_q_p5_10
        - ratio_q_P2_u_P1_of_q_p5_5;
    let ratio_q_P2_u_P1_of_q_p4_3 = ratio_q_P2_u_P1_of_q_p4 - cos_q_p4_sq_doubled;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_12 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_of_q_p4_3;
    let ratio_q_P2_u_P1_of_place_83 = sin_q_p3_cos_q_p5
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_12,
            ratio_q_P2_u_P1_of_q_p4_q_p5_11 * cos_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_84 = ratio_q_P2_u_P1_of_place_83 * cos_q_P3;
    let ratio_q_P2_u_P1_of_place_85 = ratio_q_P2_u_P1_of_q_p4_q_p5_7
        .mul_add(sin_q_P4, -ratio_q_P2_u_P1_of_q_p5)
        - ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p4_sq_doubled - ratio_q_P2_u_P1_of_place_84;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_13 = S::int(2) * ratio_q_P2_u_P1_of_q_p4_q_p5;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_14 = (-ratio_q_P2_u_P1_of_q_p5)
        .mul_add(S::int(3), cos_q_p5_sq) - ratio_q_P2_u_P1_of_q_p4_q_p5_6
        + ratio_q_P2_u_P1_of_q_p4_q_p5_13;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_15 = ratio_q_P2_u_P1_of_q_p4_q_p5_13 - ratio_q_P2_u_P1_of_q_p5;
    let ratio_q_P2_u_P1_of_place_86 = cos_q_p3_cos_q_p5
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_15,
            ratio_q_P2_u_P1_of_q_p4_q_p5_14 * sin_q_P3,
        );
    let ratio_q_P2_u_P1_of_place_87 = sin_q_p2_cos_q_p4
        .mul_add(ratio_q_P2_u_P1_of_place_86, ratio_q_P2_u_P1_of_place_85 * cos_q_P2);
    let ratio_q_P2_u_P1_of_place_88 = (-ratio_q_P2_u_P1_of_place_84)
        .mul_add(S::int(2), ratio_q_P2_u_P1_of_q_p4_q_p5_11)
        - ratio_q_P2_u_P1_of_place_87 * cos_q_P2;
    let ratio_q_P2_u_P1_of_place_89 = (-cos_q_p3_cos_q_p5)
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_12,
            ratio_q_P2_u_P1_of_q_p4_q_p5_11 * sin_q_P3,
        );
    let sin_q_p2_doubled = S::int(2) * sin_q_P2;
    let ratio_q_P2_u_P1_of_place_90 = (-cos_q_p2_cos_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_14,
            ratio_q_P2_u_P1_of_place_89 * sin_q_p2_doubled,
        );
    let ratio_q_P2_u_P1_of_place_91 = cos_q_p2_cos_q_p4 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_92 = ratio_q_P2_u_P1_of_q_p4_q_p5_15
        .mul_add(
            ratio_q_P2_u_P1_of_place_91,
            ratio_q_P2_u_P1_of_q_p4_q_p5_12 * sin_q_P2,
        );
    let ratio_q_P2_u_P1_of_place_93 = ratio_q_P2_u_P1_of_place_92
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_90 * cos_q_P3);
    let ratio_q_P2_u_P1_of_place_94 = (-ratio_q_P2_u_P1_of_place_93)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_88 * sin_q_P1);
    let ratio_q_P2_u_P1_of_q_p4_q_p5_16 = ratio_q_P2_u_P1_of_q_p4_q_p5
        + ratio_q_P2_u_P1_of_q_p5_4 - ratio_q_P2_u_P1_of_q_p4_q_p5_8;
    let ratio_q_P2_u_P1_of_place_95 = (-cos_q_p2_cos_q_p4)
        .mul_add(
            ratio_q_P2_u_P1_of_q_p4_q_p5_16,
            ratio_q_P2_u_P1_of_place_89 * sin_q_P2,
        );
    let ratio_q_P2_u_P1_of_place_96 = ratio_q_P2_u_P1_of_place_23
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_of_place_40);
    let w_rod4_frame_in_rod5_frame_1_5 = cos_q_P4 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_97 = ratio_q_P2_u_P1_of_place_95
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_of_place_94 * cos_q_P1)
        + w_rod4_frame_in_rod5_frame_1_5 * ratio_q_P2_u_P1_of_place_96;
    let ratio_q_P2_u_P1_of_place_98 = l_sq * ratio_q_P2_u_P1_of_place_97;
    let ratio_q_P2_u_P1_of_place_99 = S::int(1)
        / ((-ratio_q_P2_u_P1_of_place_18)
            .mul_add(
                ratio_q_P2_u_P1_of_place_51,
                ratio_q_P2_u_P1_of_place_25 * ratio_q_P2_u_P1_of_place_73,
            ) + ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_of_place_80
            + ratio_q_P2_u_P1_of_place_82 * ratio_q_P2_u_P1_of_place_98);
    let ratio_q_P2_u_P1_of_place_100 = l * ratio_q_P2_u_P1_of_place_99;
    let ratio_q_P2_u_P1_of_place_101 = ratio_q_P2_u_P1_of_place_35 * ratio_q_P2_u_P1_of_place_100;
    let ratio_q_P2_u_P1_of_q_p4_q_p5_17 = ratio_q_P2_u_P1_of_q_p4_q_p5 - ratio_q_P2_u_P1_of_q_p5;
    let sin_q_p3_sin_q_p1 = sin_q_P1 * sin_q_P3;
    let ratio_q_P2_u_P1_of_place_102 = (-cos_q_p3_cos_q_p1)
        .mul_add(sin_q_P2, sin_q_p3_sin_q_p1);
    let w_rod3_frame_in_rod4_frame_1_4 = cos_q_P3 * sin_q_P4;
    let ratio_q_P2_u_P1_of_place_103 = ratio_q_P2_u_P1_of_place_3
        .mul_add(cos_q_P1, w_rod3_frame_in_rod4_frame_1_4 * sin_q_P1);
    let ratio_q_P2_u_P1_of_place_104 = (-ratio_q_P2_u_P1_of_place_103)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_102 * sin_q_P5);
    let ratio_q_P2_u_P1_of_place_105 = l_sq * ratio_q_P2_u_P1_of_place_100;
    let ratio_q_P2_u_P1_of_place_106 = ratio_q_P2_u_P1_of_place_104 * ratio_q_P2_u_P1_of_place_105;
    let ratio_q_P2_u_P1_of_place_107 = ratio_q_P2_u_P1_of_place_106 * cos_q_P5;
    let ratio_q_P2_u_P1_of_place_108 = ratio_q_P2_u_P1_of_place_34
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_17);
    let ratio_q_P2_u_P1_of_place_109 = ratio_q_P2_u_P1_of_place_97 * ratio_q_P2_u_P1_of_place_105;
    let ratio_q_P2_u_P1 = ratio_q_P2_u_P1_of_q_p4_q_p5_17
        .mul_add(
            ratio_q_P2_u_P1_of_place_107,
            ratio_q_P2_u_P1_of_place_31 * ratio_q_P2_u_P1_of_place_101,
        ) + ratio_q_P2_u_P1_of_place_108 * ratio_q_P2_u_P1_of_place_109;
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
    let ratio_q_P3_u_P1_of_place_4 = ratio_q_P2_u_P1_of_place_100 * ratio_q_P2_u_P1_of_place_108;
    let ratio_q_P3_u_P1_of_q_p3_q_p5 = ratio_q_P2_u_P1_of_q_p3_q_p5_3
        .mul_add(cos_q_P5, -ratio_q_P2_u_P1_of_q_p5) - ratio_q_P2_u_P1_of_q_p3_q_p5;
    let ratio_q_P3_u_P1_of_place_5 = ratio_q_P2_u_P1_of_place_106 * cos_q_P4;
    let ratio_q_P3_u_P1 = ratio_q_P2_u_P1_of_place_51
        .mul_add(
            ratio_q_P3_u_P1_of_place_4,
            ratio_q_P2_u_P1_of_place_101 * ratio_q_P3_u_P1_of_place_3,
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
    let ratio_q_P4_u_P1_of_q_p4_q_p5 = ratio_q_P2_u_P1_of_q_p4_q_p5_5 - S::int(2);
    let ratio_q_P4_u_P1_of_place_4 = (-ratio_q_P4_u_P1_of_q_p4_q_p5)
        .mul_add(sin_q_P3, cos_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p4_q_p5_2);
    let ratio_q_P4_u_P1_of_place_5 = ratio_q_P4_u_P1_of_place_4
        .mul_add(sin_q_P4, sin_q_P3 - sin_q_P5 + cos_q_p3_cos_q_p5);
    let ratio_q_P4_u_P1 = ratio_q_P2_u_P1_of_place_101
        .mul_add(
            ratio_q_P4_u_P1_of_place_3,
            ratio_q_P2_u_P1_of_place_73 * ratio_q_P3_u_P1_of_place_4,
        ) - ratio_q_P2_u_P1_of_place_107 * ratio_q_P4_u_P1_of_place_5;
    let ratio_q_P5_u_P1_of_place = ratio_q_P2_u_P1_of_place_18
        .mul_add(
            ratio_q_P3_u_P1_of_place_2,
            ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_of_place_82,
        ) + ratio_q_P2_u_P1_of_place_25 * ratio_q_P4_u_P1_of_place_2;
    let ratio_q_P5_u_P1_of_q_p3_q_p5 = ratio_q_P2_u_P1_of_q_p3 * ratio_q_P2_u_P1_of_q_p5_4;
    let ratio_q_P5_u_P1_of_q_p3_q_p5_2 = cos_q_p3_cos_q_p5 - ratio_q_P2_u_P1_of_q_p3;
    let ratio_q_P5_u_P1_of_place_2 = ratio_q_P2_u_P1_of_q_p5
        .mul_add(
            ratio_q_P5_u_P1_of_q_p3_q_p5_2,
            ratio_q_P5_u_P1_of_q_p3_q_p5 * sin_q_P4,
        );
    let ratio_q_P5_u_P1 = ratio_q_P2_u_P1_of_place_101
        .mul_add(
            ratio_q_P5_u_P1_of_place,
            ratio_q_P2_u_P1_of_place_80 * ratio_q_P3_u_P1_of_place_4,
        ) - ratio_q_P3_u_P1_of_place_5 * ratio_q_P5_u_P1_of_place_2;
    let w_rod2_frame_in_rod3_frame_2_3 = cos_q_P2 * cos_q_P3;
    let w_rod2_frame_in_rod3_frame_3_3 = cos_q_P2 * sin_q_P3;
    let w_rod3_frame_in_rod4_frame_1_3 = w_rod2_frame_in_rod3_frame_3_3
        .mul_add(sin_q_P4, sin_q_p2_cos_q_p4);
    let w_rod3_frame_in_rod4_frame_3_3 = (-w_rod2_frame_in_rod3_frame_3_3)
        .mul_add(cos_q_P4, sin_q_p2_sin_q_p4);
    let w_rod4_frame_in_rod5_frame_1_3 = w_rod3_frame_in_rod4_frame_1_3
        .mul_add(cos_q_P5, w_rod2_frame_in_rod3_frame_2_3 * sin_q_P5);
    let l_doubled = S::int(2) * l;
    let l_sin_q_p2 = l * sin_q_P2;
    let v_rod2_centre_3_3 = l_doubled - l_sin_q_p2;
    let H_rod2_1_3 = H_rod1_2 * sin_q_P2;
    let v_rod3_centre_3_2 = l - l_sin_q_p2;
    let v_rod2_frame_in_rod3_frame_2_3 = v_rod3_centre_3_2 * sin_q_P3;
    let v_rod2_frame_in_rod3_frame_3_3 = v_rod3_centre_3_2 * cos_q_P3;
    let v_rod3_centre_1_3 = l * w_rod2_frame_in_rod3_frame_2_3;
    let v_rod3_centre_2_3 = v_rod2_frame_in_rod3_frame_2_3
        .mul_add(S::int(2), l_sin_q_p2);
    let H_rod3_2_3 = w_rod2_frame_in_rod3_frame_2_3 * H_rod1_2;
    let v_rod4_centre_2_5 = v_rod2_frame_in_rod3_frame_2_3 + l_sin_q_p2;
    let v_rod3_frame_in_rod4_frame_1_3 = v_rod3_centre_1_3
        .mul_add(cos_q_P4, v_rod2_frame_in_rod3_frame_3_3 * sin_q_P4);
    let v_rod3_frame_in_rod4_frame_3_3 = (-v_rod3_centre_1_3)
        .mul_add(sin_q_P4, v_rod2_frame_in_rod3_frame_3_3 * cos_q_P4);
    let v_rod4_centre_2_6_of_place = l * w_rod3_frame_in_rod4_frame_3_3;
    let v_rod4_centre_2_6 = v_rod4_centre_2_5
        .mul_add(S::int(2), v_rod4_centre_2_6_of_place);
    let v_rod4_centre_3_3 = (-v_rod3_frame_in_rod4_frame_3_3)
        .mul_add(S::int(2), v_rod3_centre_1_3);
    let H_rod4_3_3 = w_rod3_frame_in_rod4_frame_3_3 * H_rod1_2;
    let v_rod5_centre_2_3 = v_rod4_centre_2_5 + v_rod4_centre_2_6_of_place;
    let v_rod5_centre_3_5 = v_rod3_centre_1_3 - v_rod3_frame_in_rod4_frame_3_3;
    let v_rod4_frame_in_rod5_frame_1_3 = (-v_rod5_centre_2_3)
        .mul_add(sin_q_P5, v_rod3_frame_in_rod4_frame_1_3 * cos_q_P5);
    let v_rod4_frame_in_rod5_frame_2_3 = v_rod5_centre_2_3
        .mul_add(cos_q_P5, v_rod3_frame_in_rod4_frame_1_3 * sin_q_P5);
    let v_rod5_centre_1_3 = v_rod4_frame_in_rod5_frame_1_3
        .mul_add(S::int(2), v_rod4_centre_2_6_of_place);
    let v_rod5_centre_3_6 = (-v_rod5_centre_3_5)
        .mul_add(S::int(2), l * w_rod4_frame_in_rod5_frame_1_3);
    let H_rod5_1_3 = w_rod4_frame_in_rod5_frame_1_3 * H_rod1_2;
    let p_v_rod5_centre_3_3 = m * v_rod5_centre_3_6;
    let p_v_rod5_centre_1_3 = m * v_rod5_centre_1_3;
    let p_v_rod4_frame_in_rod5_frame_2_3 = m * v_rod4_frame_in_rod5_frame_2_3;
    let p_v_rod5_centre_2_3 = (-p_v_rod5_centre_1_3)
        .mul_add(sin_q_P5, p_v_rod4_frame_in_rod5_frame_2_3 * cos_q_p5_doubled);
    let p_v_rod4_centre_3_3 = m * v_rod4_centre_3_3;
    let p_v_rod4_centre_2_5 = m * v_rod4_centre_2_6;
    let p_v_rod3_frame_in_rod4_frame_3_3 = p_v_rod5_centre_3_3 - p_v_rod4_centre_3_3;
    let p_v_rod3_frame_in_rod4_frame_1_3 = v_rod3_frame_in_rod4_frame_1_3
        .mul_add(m_doubled, p_v_rod5_centre_1_3 * cos_q_P5)
        + p_v_rod4_frame_in_rod5_frame_2_3 * sin_q_p5_doubled;
    let p_v_rod4_centre_2_6 = p_v_rod5_centre_2_3 + p_v_rod4_centre_2_5;
    let p_v_rod4_centre_1_3 = (-p_v_rod3_frame_in_rod4_frame_1_3)
        .mul_add(cos_q_P4, p_v_rod3_frame_in_rod4_frame_3_3 * sin_q_P4);
    let p_v_rod3_centre_2_3 = m * v_rod3_centre_2_3;
    let p_v_rod3_centre_1_3 = m * v_rod3_centre_1_3;
    let p_v_rod2_frame_in_rod3_frame_3_3 = p_v_rod3_frame_in_rod4_frame_1_3
        .mul_add(sin_q_P4, p_v_rod3_frame_in_rod4_frame_3_3 * cos_q_P4)
        + v_rod2_frame_in_rod3_frame_3_3 * m_doubled;
    let p_v_rod2_frame_in_rod3_frame_2_3 = p_v_rod4_centre_2_6 + p_v_rod3_centre_2_3;
    let p_v_rod3_centre_3_3 = p_v_rod2_frame_in_rod3_frame_2_3
        .mul_add(sin_q_P3, p_v_rod2_frame_in_rod3_frame_3_3 * cos_q_P3);
    let p_v_rod2_centre_3_3 = m * v_rod2_centre_3_3;
    let p_v_rod1_centre_3_2_of_place = p_v_rod3_centre_3_3 + p_v_rod2_centre_3_3;
    let p_v_rod1_centre_3_2 = p_v_rod1_centre_3_2_of_place
        .mul_add(S::int(2), mp_rod1_frame_1);
    let p_w_rod5_frame_3_3 = p_v_rod5_centre_1_3.mul_add(l_times_3, H_rod4_3_3);
    let p_w_rod4_frame_in_rod5_frame_1_3 = p_v_rod5_centre_3_3
        .mul_add(l_times_3, H_rod5_1_3);
    let p_w_rod4_frame_2_3 = p_w_rod4_frame_in_rod5_frame_1_3
        .mul_add(sin_q_P5, H_rod3_2_3) + p_v_rod4_centre_3_3 * l_times_3
        - p_v_rod5_centre_3_3 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_3_3 = p_v_rod4_centre_2_5
        .mul_add(l_times_3, H_rod4_3_3 + p_w_rod5_frame_3_3) + p_v_rod5_centre_2_3 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_1_3 = p_w_rod4_frame_in_rod5_frame_1_3 * cos_q_P5;
    let p_w_rod3_frame_1_3 = p_w_rod3_frame_in_rod4_frame_3_3
        .mul_add(sin_q_P4, H_rod2_1_3) + p_w_rod3_frame_in_rod4_frame_1_3 * cos_q_P4
        + p_v_rod3_centre_2_3 * l_times_3 + p_v_rod4_centre_2_6 * l_times_6;
    let p_w_rod2_frame_in_rod3_frame_3_3 = (-p_w_rod3_frame_in_rod4_frame_1_3)
        .mul_add(sin_q_P4, p_w_rod3_frame_in_rod4_frame_3_3 * cos_q_P4);
    let p_w_rod2_frame_in_rod3_frame_2_3 = p_v_rod3_centre_1_3
        .mul_add(l_times_3, H_rod3_2_3 + p_w_rod4_frame_2_3) - p_v_rod4_centre_1_3 * l_times_6;
    let p_w_rod1_frame_in_rod2_frame_2_3 = (-p_w_rod2_frame_in_rod3_frame_2_3)
        .mul_add(cos_q_P3, p_w_rod2_frame_in_rod3_frame_3_3 * sin_q_P3);
    let p_w_rod1_frame_in_rod2_frame_1_3 = (-p_v_rod2_centre_3_3)
        .mul_add(l_times_3, H_rod2_1_3 + p_w_rod3_frame_1_3) - p_v_rod3_centre_3_3 * l_times_6;
    let w_rod3_frame_in_rod4_frame_3_4 = cos_q_P3 * cos_q_P4;
    let w_rod4_frame_in_rod5_frame_1_4 = (-w_rod3_frame_in_rod4_frame_1_4)
        .mul_add(cos_q_P5, sin_q_p3_sin_q_p5);
    let l_sin_q_p3 = l * sin_q_P3;
    let v_rod3_centre_1_4 = l_doubled - l_sin_q_p3;
    let H_rod3_2_4 = H_rod1_2 * sin_q_P3;
    let v_rod4_centre_1_2 = l * ratio_q_P2_u_P1_of_q_p3;
    let v_rod3_frame_in_rod4_frame_1_4 = v_rod4_centre_1_2 * cos_q_P4;
    let v_rod3_frame_in_rod4_frame_3_4 = v_rod4_centre_1_2 * sin_q_P4;
    let v_rod4_centre_2_7 = l * w_rod3_frame_in_rod4_frame_3_4;
    let v_rod4_centre_3_4 = (-v_rod3_frame_in_rod4_frame_3_4)
        .mul_add(S::int(2), l_sin_q_p3);
    let H_rod4_3_4 = H_rod1_2 * w_rod3_frame_in_rod4_frame_3_4;
    let v_rod5_centre_3_7 = l_sin_q_p3 - v_rod3_frame_in_rod4_frame_3_4;
    let v_rod4_frame_in_rod5_frame_1_4 = v_rod4_centre_2_7
        .mul_add(sin_q_P5, v_rod3_frame_in_rod4_frame_1_4 * cos_q_P5);
    let v_rod4_frame_in_rod5_frame_2_4 = (-v_rod4_centre_2_7)
        .mul_add(cos_q_P5, v_rod3_frame_in_rod4_frame_1_4 * sin_q_P5);
    let v_rod5_centre_1_4 = (-v_rod4_frame_in_rod5_frame_1_4)
        .mul_add(S::int(2), v_rod4_centre_2_7);
    let v_rod5_centre_3_8 = (-v_rod5_centre_3_7)
        .mul_add(S::int(2), l * w_rod4_frame_in_rod5_frame_1_4);
    let H_rod5_1_4 = H_rod1_2 * w_rod4_frame_in_rod5_frame_1_4;
    let p_v_rod5_centre_3_4 = m * v_rod5_centre_3_8;
    let p_v_rod5_centre_1_4 = m * v_rod5_centre_1_4;
    let p_v_rod4_frame_in_rod5_frame_2_4 = m * v_rod4_frame_in_rod5_frame_2_4;
    let p_v_rod5_centre_2_4 = p_v_rod4_frame_in_rod5_frame_2_4
        .mul_add(cos_q_p5_doubled, p_v_rod5_centre_1_4 * sin_q_P5);
    let p_v_rod4_centre_3_4 = m * v_rod4_centre_3_4;
    let p_v_rod4_centre_2_7 = m * v_rod4_centre_2_7;
    let p_v_rod3_frame_in_rod4_frame_3_4 = p_v_rod5_centre_3_4 - p_v_rod4_centre_3_4;
    let p_v_rod3_frame_in_rod4_frame_1_4 = (-p_v_rod5_centre_1_4)
        .mul_add(cos_q_P5, v_rod3_frame_in_rod4_frame_1_4 * m_doubled)
        + p_v_rod4_frame_in_rod5_frame_2_4 * sin_q_p5_doubled;
    let p_v_rod4_centre_2_8 = p_v_rod5_centre_2_4 - p_v_rod4_centre_2_7;
    let p_v_rod4_centre_1_4 = p_v_rod3_frame_in_rod4_frame_1_4
        .mul_add(cos_q_P4, p_v_rod3_frame_in_rod4_frame_3_4 * sin_q_P4);
    let p_v_rod3_centre_1_4 = m * v_rod3_centre_1_4;
    let p_v_rod2_frame_in_rod3_frame_3_4 = (-p_v_rod3_frame_in_rod4_frame_1_4)
        .mul_add(sin_q_P4, p_v_rod3_frame_in_rod4_frame_3_4 * cos_q_P4);
    let p_v_rod3_centre_3_4 = (-p_v_rod4_centre_2_8)
        .mul_add(sin_q_P3, p_v_rod2_frame_in_rod3_frame_3_4 * cos_q_P3);
    let p_w_rod5_frame_3_4 = p_v_rod5_centre_1_4.mul_add(l_times_3, H_rod4_3_4);
    let p_w_rod4_frame_in_rod5_frame_1_4 = p_v_rod5_centre_3_4
        .mul_add(l_times_3, H_rod5_1_4);
    let p_w_rod4_frame_2_4 = p_w_rod4_frame_in_rod5_frame_1_4
        .mul_add(sin_q_P5, H_rod3_2_4) + p_v_rod4_centre_3_4 * l_times_3
        - p_v_rod5_centre_3_4 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_3_4 = p_v_rod4_centre_2_7
        .mul_add(l_times_3, H_rod4_3_4 + p_w_rod5_frame_3_4) - p_v_rod5_centre_2_4 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_1_4 = p_w_rod4_frame_in_rod5_frame_1_4 * cos_q_P5;
    let p_w_rod3_frame_1_4 = (-p_w_rod3_frame_in_rod4_frame_3_4)
        .mul_add(sin_q_P4, p_v_rod4_centre_2_8 * l_times_6)
        - p_w_rod3_frame_in_rod4_frame_1_4 * cos_q_P4;
    let p_w_rod2_frame_in_rod3_frame_3_4 = (-p_w_rod3_frame_in_rod4_frame_1_4)
        .mul_add(sin_q_P4, p_w_rod3_frame_in_rod4_frame_3_4 * cos_q_P4);
    let p_w_rod2_frame_in_rod3_frame_2_4 = (-p_v_rod3_centre_1_4)
        .mul_add(l_times_3, H_rod3_2_4 + p_w_rod4_frame_2_4) - p_v_rod4_centre_1_4 * l_times_6;
    let p_w_rod1_frame_in_rod2_frame_2_4 = (-p_w_rod2_frame_in_rod3_frame_2_4)
        .mul_add(cos_q_P3, p_w_rod2_frame_in_rod3_frame_3_4 * sin_q_P3);
    let p_w_rod1_frame_in_rod2_frame_1_4 = p_v_rod3_centre_3_4
        .mul_add(l_times_6, p_w_rod3_frame_1_4);
    let l_sin_q_p4 = l * sin_q_P4;
    let v_rod4_centre_2_8 = l_doubled + l_sin_q_p4;
    let H_rod4_3_5 = H_rod1_2 * sin_q_P4;
    let v_rod5_centre_2_4 = l * ratio_q_P2_u_P1_of_q_p4;
    let v_rod4_frame_in_rod5_frame_1_5 = v_rod5_centre_2_4 * sin_q_P5;
    let v_rod4_frame_in_rod5_frame_2_5 = v_rod5_centre_2_4 * cos_q_P5;
    let v_rod5_centre_1_5 = (-v_rod4_frame_in_rod5_frame_1_5)
        .mul_add(S::int(2), l_sin_q_p4);
    let v_rod5_centre_3_9 = l * w_rod4_frame_in_rod5_frame_1_5;
    let H_rod5_1_5 = H_rod1_2 * w_rod4_frame_in_rod5_frame_1_5;
    let p_v_rod5_centre_3_5 = m * v_rod5_centre_3_9;
    let p_v_rod5_centre_1_5 = m * v_rod5_centre_1_5;
    let p_v_rod4_frame_in_rod5_frame_2_5 = m * v_rod4_frame_in_rod5_frame_2_5;
    let p_v_rod5_centre_2_5 = (-p_v_rod5_centre_1_5)
        .mul_add(sin_q_P5, p_v_rod4_frame_in_rod5_frame_2_5 * cos_q_p5_doubled);
    let p_v_rod4_centre_2_9 = m * v_rod4_centre_2_8;
    let p_v_rod3_frame_in_rod4_frame_1_5 = p_v_rod4_frame_in_rod5_frame_2_5
        .mul_add(sin_q_p5_doubled, p_v_rod5_centre_1_5 * cos_q_P5);
    let p_v_rod4_centre_2_10 = p_v_rod5_centre_2_5 + p_v_rod4_centre_2_9;
    let p_v_rod4_centre_1_5 = (-p_v_rod3_frame_in_rod4_frame_1_5)
        .mul_add(cos_q_P4, p_v_rod5_centre_3_5 * sin_q_P4);
    let p_v_rod2_frame_in_rod3_frame_3_5 = p_v_rod3_frame_in_rod4_frame_1_5
        .mul_add(sin_q_P4, p_v_rod5_centre_3_5 * cos_q_P4);
    let p_v_rod2_frame_in_rod3_frame_2_4 = mp_rod1_frame_1 + p_v_rod4_centre_2_10;
    let p_v_rod3_centre_3_5 = p_v_rod2_frame_in_rod3_frame_2_4
        .mul_add(sin_q_P3, p_v_rod2_frame_in_rod3_frame_3_5 * cos_q_P3);
    let p_w_rod5_frame_3_5 = p_v_rod5_centre_1_5.mul_add(l_times_3, H_rod4_3_5);
    let p_w_rod4_frame_in_rod5_frame_1_5 = p_v_rod5_centre_3_5
        .mul_add(l_times_3, H_rod5_1_5);
    let p_w_rod4_frame_2_5 = (-p_w_rod4_frame_in_rod5_frame_1_5)
        .mul_add(sin_q_P5, p_v_rod5_centre_3_5 * l_times_6);
    let p_w_rod3_frame_in_rod4_frame_3_5 = p_v_rod4_centre_2_9
        .mul_add(l_times_3, H_rod4_3_5 + p_w_rod5_frame_3_5) + p_v_rod5_centre_2_5 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_1_5 = p_w_rod4_frame_in_rod5_frame_1_5 * cos_q_P5;
    let p_w_rod5_frame_3_6 = mp_rod1_frame_1.mul_add(l_times_3, H_rod1_2);
    let p_w_rod3_frame_1_5 = p_w_rod3_frame_in_rod4_frame_1_5
        .mul_add(cos_q_P4, p_w_rod3_frame_in_rod4_frame_3_5 * sin_q_P4)
        + p_w_rod5_frame_3_6 + p_v_rod4_centre_2_10 * l_times_6;
    let p_w_rod2_frame_in_rod3_frame_3_5 = (-p_w_rod3_frame_in_rod4_frame_1_5)
        .mul_add(sin_q_P4, p_w_rod3_frame_in_rod4_frame_3_5 * cos_q_P4);
    let p_w_rod2_frame_in_rod3_frame_2_5 = p_v_rod4_centre_1_5
        .mul_add(l_times_6, p_w_rod4_frame_2_5);
    let p_w_rod1_frame_in_rod2_frame_2_5 = p_w_rod2_frame_in_rod3_frame_2_5
        .mul_add(cos_q_P3, p_w_rod2_frame_in_rod3_frame_3_5 * sin_q_P3);
    let p_w_rod1_frame_in_rod2_frame_1_5_of_place = p_v_rod3_centre_3_5 * l_times_6;
    let p_w_rod1_frame_in_rod2_frame_1_5 = p_w_rod1_frame_in_rod2_frame_1_5_of_place
        - p_w_rod3_frame_1_5;
    let v_rod5_centre_3_10 = (-l).mul_add(sin_q_P5, l_doubled);
    let H_rod5_1_6 = H_rod1_2 * sin_q_P5;
    let p_v_rod5_centre_3_6 = m * v_rod5_centre_3_10;
    let p_v_rod3_frame_in_rod4_frame_3_5 = mp_rod1_frame_1 + p_v_rod5_centre_3_6;
    let p_v_rod4_centre_1_6 = p_v_rod3_frame_in_rod4_frame_3_5 * sin_q_P4;
    let p_v_rod2_frame_in_rod3_frame_3_6 = p_v_rod3_frame_in_rod4_frame_3_5 * cos_q_P4;
    let p_v_rod3_centre_3_6 = p_v_rod2_frame_in_rod3_frame_3_6 * cos_q_P3;
    let p_w_rod4_frame_in_rod5_frame_1_6 = (-p_v_rod5_centre_3_6)
        .mul_add(l_times_3, H_rod5_1_6);
    let p_w_rod4_frame_2_6 = p_w_rod4_frame_in_rod5_frame_1_6
        .mul_add(sin_q_P5, p_w_rod5_frame_3_6) + p_v_rod5_centre_3_6 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_1_6 = p_w_rod4_frame_in_rod5_frame_1_6 * cos_q_P5;
    let p_w_rod3_frame_1_6 = p_w_rod3_frame_in_rod4_frame_1_6 * cos_q_P4;
    let p_w_rod2_frame_in_rod3_frame_3_6 = p_w_rod3_frame_in_rod4_frame_1_6 * sin_q_P4;
    let p_w_rod2_frame_in_rod3_frame_2_6 = p_v_rod4_centre_1_6
        .mul_add(l_times_6, p_w_rod4_frame_2_6);
    let p_w_rod1_frame_in_rod2_frame_2_6 = p_w_rod2_frame_in_rod3_frame_2_6
        .mul_add(cos_q_P3, p_w_rod2_frame_in_rod3_frame_3_6 * sin_q_P3);
    let p_w_rod1_frame_in_rod2_frame_1_6_of_place = p_v_rod3_centre_3_6 * l_times_6;
    let p_w_rod1_frame_in_rod2_frame_1_6 = p_w_rod3_frame_1_6
        + p_w_rod1_frame_in_rod2_frame_1_6_of_place;
    let p_v_rod5_centre_2_6 = mp_rod1_frame_1 * sin_q_P5;
    let p_v_rod3_frame_in_rod4_frame_1_6 = mp_rod1_frame_1 * cos_q_P5;
    let p_v_rod4_centre_1_7 = p_v_rod3_frame_in_rod4_frame_1_6 * cos_q_P4;
    let p_v_rod2_frame_in_rod3_frame_3_7 = p_v_rod3_frame_in_rod4_frame_1_6 * sin_q_P4;
    let p_v_rod3_centre_3_7 = (-p_v_rod5_centre_2_6)
        .mul_add(sin_q_P3, p_v_rod2_frame_in_rod3_frame_3_7 * cos_q_P3);
    let p_w_rod3_frame_in_rod4_frame_3_6_of_place = p_v_rod5_centre_2_6 * l_times_6;
    let p_w_rod3_frame_in_rod4_frame_3_6 = p_w_rod3_frame_in_rod4_frame_3_6_of_place
        - p_w_rod5_frame_3_6;
    let p_w_rod3_frame_1_7 = p_w_rod3_frame_in_rod4_frame_3_6
        .mul_add(sin_q_P4, p_w_rod3_frame_in_rod4_frame_3_6_of_place);
    let p_w_rod2_frame_in_rod3_frame_3_7 = p_w_rod3_frame_in_rod4_frame_3_6 * cos_q_P4;
    let p_w_rod2_frame_in_rod3_frame_2_7 = l * p_v_rod4_centre_1_7;
    let p_w_rod1_frame_in_rod2_frame_2_7_of_place = S::int(6) * p_w_rod2_frame_in_rod3_frame_2_7;
    let p_w_rod1_frame_in_rod2_frame_2_7 = p_w_rod1_frame_in_rod2_frame_2_7_of_place
        .mul_add(cos_q_P3, p_w_rod2_frame_in_rod3_frame_3_7 * sin_q_P3);
    let p_w_rod1_frame_in_rod2_frame_1_7_of_place = p_v_rod3_centre_3_7 * l_times_6;
    let p_w_rod1_frame_in_rod2_frame_1_7 = p_w_rod3_frame_1_7
        + p_w_rod1_frame_in_rod2_frame_1_7_of_place;
    let p_v_rod2_centre_1_2_of_place = p_v_rod4_centre_1_4 + p_v_rod3_centre_1_4;
    let p_v_rod2_centre_1_2 = p_v_rod2_centre_1_2_of_place
        .mul_add(S::int(2), mp_rod1_frame_1);
    let q_p1_dot_ratio_q_p5_u_p1 = q_P1_dot * ratio_q_P5_u_P1;
    let ratio_q_P2_u_P1_2_of_q_p1_dot = q_p1_dot_ratio_q_p5_u_p1 * cos_q_P5;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_2 = ratio_q_P2_u_P1_of_q_p5 * ratio_q_P2_u_P1_2_of_q_p1_dot;
    let q_p1_dot_cos_q_p4 = q_P1_dot * cos_q_P4;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_3 = ratio_q_P4_u_P1 * q_p1_dot_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_4 = ratio_q_P2_u_P1_2_of_q_p1_dot_3 * sin_q_P4;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_5 = (-cos_q_p4_sq)
        .mul_add(
            ratio_q_P2_u_P1_2_of_q_p1_dot_2,
            ratio_q_P2_u_P1_of_q_p5_4 * ratio_q_P2_u_P1_2_of_q_p1_dot_4,
        );
    let ratio_q_P2_u_P1_2_of_q_p1_dot_6 = ratio_q_P5_u_P1 * q_p1_dot_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_7 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_13)
        .mul_add(
            ratio_q_P2_u_P1_2_of_q_p1_dot_3,
            w_rod4_frame_in_rod5_frame_1_5 * ratio_q_P2_u_P1_2_of_q_p1_dot_6,
        );
    let ratio_q_P2_u_P1_2_of_q_p1_dot_8 = sin_q_p5_doubled * ratio_q_P2_u_P1_2_of_q_p1_dot;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_9 = ratio_q_P2_u_P1_2_of_q_p1_dot
        - ratio_q_P2_u_P1_2_of_q_p1_dot_8;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_10 = S::int(2) * ratio_q_P2_u_P1_2_of_q_p1_dot_5;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_11 = sin_q_P4
        * (ratio_q_P2_u_P1_2_of_q_p1_dot_9 + ratio_q_P2_u_P1_2_of_q_p1_dot_10)
        + ratio_q_P2_u_P1_of_q_p4_q_p5_9 * ratio_q_P2_u_P1_2_of_q_p1_dot_3;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_12 = ratio_q_P2_u_P1_2_of_q_p1_dot_7
        - ratio_q_P2_u_P1_2_of_q_p1_dot_11;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_13 = ratio_q_P2_u_P1_2_of_q_p1_dot_9
        - ratio_q_P2_u_P1_2_of_q_p1_dot_12;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_14 = q_p1_dot_ratio_q_p5_u_p1 * sin_q_P5;
    let q_p1_dot_ratio_q_p3_u_p1 = q_P1_dot * ratio_q_P3_u_P1;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_15 = q_p1_dot_ratio_q_p3_u_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_16 = ratio_q_P2_u_P1_2_of_q_p1_dot_15 * cos_q_P5;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_17 = ratio_q_P2_u_P1_2_of_q_p1_dot_14
        .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_q_p1_dot_16);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_18 = q_p1_dot_ratio_q_p3_u_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_19 = ratio_q_P2_u_P1_of_q_p5
        * ratio_q_P2_u_P1_2_of_q_p1_dot_4
            .mul_add(S::int(4), ratio_q_P2_u_P1_2_of_q_p1_dot_3)
        - ratio_q_P2_u_P1_of_q_p4_3 * ratio_q_P2_u_P1_2_of_q_p1_dot;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_20 = cos_q_P3
        * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_12)
            .mul_add(
                ratio_q_P2_u_P1_2_of_q_p1_dot_17,
                ratio_q_P2_u_P1_2_of_q_p1_dot_13 * cos_q_P3,
            ) + ratio_q_P2_u_P1_of_q_p4_q_p5_11 * ratio_q_P2_u_P1_2_of_q_p1_dot_18
            + sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_q_p1_dot_19)
        + ratio_q_P2_u_P1_of_place_83 * ratio_q_P2_u_P1_2_of_q_p1_dot_18;
    let sin_q_p4_ratio_q_p4_u_p1 = ratio_q_P4_u_P1 * sin_q_P4;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_21 = q_P1_dot * sin_q_p4_ratio_q_p4_u_p1;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_22 = ratio_q_P2_u_P1 * q_p1_dot_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_23 = ratio_q_P2_u_P1_2_of_q_p1_dot_22
        .mul_add(cos_q_P2, ratio_q_P2_u_P1_2_of_q_p1_dot_21 * sin_q_P2);
    let q_p1_dot_ratio_q_p2_u_p1 = q_P1_dot * ratio_q_P2_u_P1;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_24 = q_p1_dot_ratio_q_p2_u_p1 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_25 = ratio_q_P2_u_P1_of_q_p5_2
        .mul_add(
            ratio_q_P2_u_P1_2_of_q_p1_dot_3,
            ratio_q_P2_u_P1_2_of_q_p1_dot * sin_q_P4,
        );
    let ratio_q_P2_u_P1_2_of_q_p1_dot_26 = ratio_q_P2_u_P1_2_of_q_p1_dot_10
        + ratio_q_P2_u_P1_2_of_q_p1_dot_25;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_27 = ratio_q_P2_u_P1_2_of_q_p1_dot
        .mul_add(S::int(3), -ratio_q_P2_u_P1_2_of_q_p1_dot_8)
        + S::int(2) * ratio_q_P2_u_P1_2_of_q_p1_dot_26;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_28 = (-ratio_q_P2_u_P1_2_of_q_p1_dot_14)
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_q_p1_dot_18 * cos_q_P5);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_29 = ratio_q_P2_u_P1_2_of_q_p1_dot_25
        .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_q_p1_dot);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_30 = (-ratio_q_P2_u_P1_2_of_q_p1_dot_22)
        .mul_add(sin_q_P2, ratio_q_P2_u_P1_2_of_q_p1_dot_21 * cos_q_P2);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_31 = (-ratio_q_P2_u_P1_2_of_q_p1_dot_13)
        .mul_add(
            sin_q_P3,
            ratio_q_P2_u_P1_of_q_p4_q_p5_11 * ratio_q_P2_u_P1_2_of_q_p1_dot_15,
        ) + cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_q_p1_dot_19
        + ratio_q_P2_u_P1_of_q_p4_q_p5_12 * ratio_q_P2_u_P1_2_of_q_p1_dot_28;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_32 = q_p1_dot_ratio_q_p2_u_p1 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_33 = ratio_q_P2_u_P1_of_place_89
        * ratio_q_P2_u_P1_2_of_q_p1_dot_32;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_34 = ratio_q_P3_u_P1 * q_p1_dot_cos_q_p4;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_35 = w_rod2_frame_in_rod3_frame_2_3
        .mul_add(
            ratio_q_P2_u_P1_2_of_q_p1_dot_34,
            ratio_q_P2_u_P1_2_of_q_p1_dot_30 * sin_q_P3,
        );
    let q_p1_dot_cos_q_p1 = q_P1_dot * cos_q_P1;
    let q_p1_dot_sin_q_p1 = q_P1_dot * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_36 = ratio_q_P2_u_P1_of_q_p5_3
        * ratio_q_P2_u_P1_2_of_q_p1_dot;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_37 = ratio_q_P2_u_P1_2_of_q_p1_dot_6 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_38 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(
            ratio_q_P2_u_P1_2_of_q_p1_dot_23,
            ratio_q_P2_u_P1_2_of_q_p1_dot_37 * cos_q_P5,
        );
    let ratio_q_P2_u_P1_2_of_q_p1_dot_39 = ratio_q_P2_u_P1_2_of_q_p1_dot_25
        .mul_add(
            cos_q_P2,
            ratio_q_P2_u_P1_of_q_p4_q_p5 * ratio_q_P2_u_P1_2_of_q_p1_dot_24,
        );
    let ratio_q_P2_u_P1_2_of_q_p1_dot_40 = -ratio_q_P2_u_P1_of_place_96
        * ratio_q_P2_u_P1_2_of_q_p1_dot_21
            .mul_add(cos_q_P5, ratio_q_P2_u_P1_2_of_q_p1_dot_6 * sin_q_P5)
        + ratio_q_P2_u_P1_of_place_95 * ratio_q_P2_u_P1_2_of_q_p1_dot_18
        + ratio_q_P2_u_P1_of_place_94 * q_p1_dot_sin_q_p1
        + cos_q_P1
            * (sin_q_P1
                * (ratio_q_P2_u_P1_2_of_q_p1_dot_13 - S::int(2) * ratio_q_P2_u_P1_2_of_q_p1_dot_20
                    - ratio_q_P2_u_P1_of_place_87 * ratio_q_P2_u_P1_2_of_q_p1_dot_24
                    + cos_q_P2
                        * (-cos_q_P2
                            * (ratio_q_P2_u_P1_2_of_q_p1_dot
                                + ratio_q_P2_u_P1_of_q_p4_q_p5_7 * ratio_q_P2_u_P1_2_of_q_p1_dot_3
                                + sin_q_P4
                                    * ratio_q_P2_u_P1_2_of_q_p1_dot_5
                                        .mul_add(S::int(4), ratio_q_P2_u_P1_2_of_q_p1_dot)
                                - S::int(2) * ratio_q_P2_u_P1_2_of_q_p1_dot_7
                                - ratio_q_P2_u_P1_2_of_q_p1_dot_20)
                            + ratio_q_P2_u_P1_of_place_86 * ratio_q_P2_u_P1_2_of_q_p1_dot_23
                            - ratio_q_P2_u_P1_of_place_85 * ratio_q_P2_u_P1_2_of_q_p1_dot_24
                            - sin_q_p2_cos_q_p4
                                * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_14)
                                    .mul_add(
                                        ratio_q_P2_u_P1_2_of_q_p1_dot_15,
                                        ratio_q_P2_u_P1_2_of_q_p1_dot_27 * sin_q_P3,
                                    )
                                    + ratio_q_P2_u_P1_of_q_p4_q_p5_15
                                        * ratio_q_P2_u_P1_2_of_q_p1_dot_28
                                    + cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_q_p1_dot_29)))
                + cos_q_P1
                    * (ratio_q_P2_u_P1_of_place_92 * ratio_q_P2_u_P1_2_of_q_p1_dot_14
                        - ratio_q_P2_u_P1_of_place_90 * ratio_q_P2_u_P1_2_of_q_p1_dot_18
                        + cos_q_P3
                            * ((-ratio_q_P2_u_P1_of_q_p4_q_p5_14)
                                .mul_add(
                                    ratio_q_P2_u_P1_2_of_q_p1_dot_30,
                                    cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_q_p1_dot_27,
                                ) + sin_q_p2_doubled * ratio_q_P2_u_P1_2_of_q_p1_dot_31
                                + S::int(2) * ratio_q_P2_u_P1_2_of_q_p1_dot_33)
                        + cos_q_P5
                            * ((-ratio_q_P2_u_P1_2_of_q_p1_dot_19)
                                .mul_add(
                                    sin_q_P2,
                                    ratio_q_P2_u_P1_of_q_p4_q_p5_12
                                        * ratio_q_P2_u_P1_2_of_q_p1_dot_32,
                                )
                                - ratio_q_P2_u_P1_of_place_91 * ratio_q_P2_u_P1_2_of_q_p1_dot_29
                                + ratio_q_P2_u_P1_of_q_p4_q_p5_15
                                    * ratio_q_P2_u_P1_2_of_q_p1_dot_35))
                - ratio_q_P2_u_P1_of_place_88 * q_p1_dot_cos_q_p1
                - ratio_q_P2_u_P1_of_place_93 * q_p1_dot_sin_q_p1)
        + cos_q_P3
            * (ratio_q_P2_u_P1_of_q_p4_q_p5_16 * ratio_q_P2_u_P1_2_of_q_p1_dot_30
                - ratio_q_P2_u_P1_2_of_q_p1_dot_31 * sin_q_P2 - ratio_q_P2_u_P1_2_of_q_p1_dot_33
                - cos_q_p2_cos_q_p4
                    * (ratio_q_P2_u_P1_2_of_q_p1_dot_26 + ratio_q_P2_u_P1_2_of_q_p1_dot_36))
        + w_rod4_frame_in_rod5_frame_1_5
            * ((-ratio_q_P2_u_P1_of_place_23)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_q_p1_dot_15, ratio_q_P2_u_P1_2_of_q_p1_dot_38,
                ) + ratio_q_P2_u_P1_2_of_q_p1_dot_39 * sin_q_P3);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_41 = ratio_q_P2_u_P1_2_of_q_p1_dot_3 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_42 = ratio_q_P2_u_P1_2_of_q_p1_dot_24
        .mul_add(sin_q_P4, ratio_q_P2_u_P1_2_of_q_p1_dot_41);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_43 = ratio_q_P2_u_P1_2_of_q_p1_dot_34 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_44 = ratio_q_P2_u_P1_2_of_q_p1_dot_43
        .mul_add(cos_q_P3, -ratio_q_P2_u_P1_2_of_q_p1_dot_42);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_45 = sin_q_p4_ratio_q_p4_u_p1 * q_p1_dot_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_46 = (-ratio_q_P2_u_P1_2_of_q_p1_dot_45)
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_q_p1_dot_34);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_47 = q_p1_dot_cos_q_p4 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_48 = ratio_q_P2_u_P1_2_of_q_p1_dot_47
        .mul_add(cos_q_P3, ratio_q_P2_u_P1_2_of_q_p1_dot_46);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_49 = cos_q_P5
        * (sin_q_P1
            * ratio_q_P2_u_P1_2_of_q_p1_dot_23
                .mul_add(sin_q_P3, ratio_q_P2_u_P1_2_of_q_p1_dot_44)
            + ratio_q_P2_u_P1_of_place_9 * q_p1_dot_cos_q_p1 + ratio_q_P2_u_P1_2_of_q_p1_dot_48)
        - ratio_q_P2_u_P1_of_place_11 * ratio_q_P2_u_P1_2_of_q_p1_dot_14;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_50 = ratio_q_P2_u_P1_2_of_q_p1_dot_6 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_51 = (-ratio_q_P2_u_P1_2_of_q_p1_dot_25)
        .mul_add(
            sin_q_P2,
            ratio_q_P2_u_P1_of_q_p4_q_p5 * ratio_q_P2_u_P1_2_of_q_p1_dot_32,
        ) - ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_q_p1_dot_35
        + sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_q_p1_dot_50;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_52 = ratio_q_P2_u_P1_2_of_q_p1_dot * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_53 = sin_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_q_p1_dot_3;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_54 = (-ratio_q_P2_u_P1_2_of_q_p1_dot_18)
        .mul_add(sin_q_P5, ratio_q_P2_u_P1_2_of_q_p1_dot_17 * sin_q_P4)
        - ratio_q_P2_u_P1_2_of_q_p1_dot_52 - ratio_q_P2_u_P1_2_of_q_p1_dot_53;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_55 = (-ratio_q_P2_u_P1_of_place_6)
        .mul_add(
            ratio_q_P2_u_P1_2_of_q_p1_dot_24,
            ratio_q_P2_u_P1_2_of_q_p1_dot_23 * cos_q_P5,
        ) + ratio_q_P2_u_P1_2_of_q_p1_dot_37 * sin_q_P5
        + ratio_q_P2_u_P1_2_of_q_p1_dot_54 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_56 = q_p1_dot_cos_q_p1
        .mul_add(sin_q_P2, cos_q_p2_sin_q_p1 * q_p1_dot_ratio_q_p2_u_p1);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_57 = q_p1_dot_sin_q_p1 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_58 = ratio_q_P2_u_P1_2_of_q_p1_dot_15 * cos_q_P1;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_59 = -ratio_q_P2_u_P1_2_of_q_p1_dot_30
        + sin_q_p2_sin_q_p4 * ratio_q_P2_u_P1_2_of_q_p1_dot_15
        + sin_q_P3
            * (-ratio_q_P2_u_P1_2_of_q_p1_dot_3)
                .mul_add(sin_q_P2, ratio_q_P2_u_P1_2_of_q_p1_dot_32 * sin_q_P4);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_60 = q_p1_dot_sin_q_p1 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_61 = ratio_q_P2_u_P1_2_of_q_p1_dot_18
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_2_of_q_p1_dot_60);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_62 = ratio_q_P2_u_P1_of_place_2
        * ratio_q_P2_u_P1_2_of_q_p1_dot_14
        - ratio_q_P2_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_q_p1_dot
        + cos_q_P5
            * ((-sin_q_p2_sin_q_p1)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_q_p1_dot_18,
                    ratio_q_P2_u_P1_2_of_q_p1_dot_56 * cos_q_P3,
                ) - ratio_q_P2_u_P1_2_of_q_p1_dot_57 + ratio_q_P2_u_P1_2_of_q_p1_dot_58)
        - sin_q_P5
            * (ratio_q_P2_u_P1_of_place_3
                .mul_add(
                    q_p1_dot_cos_q_p1,
                    cos_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_q_p1_dot_3,
                ) + ratio_q_P2_u_P1_2_of_q_p1_dot_59 * sin_q_P1
                + ratio_q_P2_u_P1_2_of_q_p1_dot_61 * sin_q_P4);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_63 = ratio_q_P2_u_P1_of_place_5
        .mul_add(
            ratio_q_P2_u_P1_2_of_q_p1_dot_51,
            ratio_q_P2_u_P1_of_place_8 * ratio_q_P2_u_P1_2_of_q_p1_dot_49,
        ) - ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_q_p1_dot_55
        - ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_2_of_q_p1_dot_62;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_64 = ratio_q_P2_u_P1_2_of_q_p1_dot * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_65 = ratio_q_P2_u_P1_2_of_q_p1_dot_15 * sin_q_P5;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_66 = cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_q_p1_dot_3;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_67 = ratio_q_P2_u_P1_2_of_q_p1_dot_28
        .mul_add(sin_q_P4, -ratio_q_P2_u_P1_2_of_q_p1_dot_64)
        + ratio_q_P2_u_P1_2_of_q_p1_dot_65 + ratio_q_P2_u_P1_2_of_q_p1_dot_66;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_68 = (-ratio_q_P2_u_P1_2_of_q_p1_dot_54)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_6 * q_p1_dot_sin_q_p1)
        - ratio_q_P2_u_P1_of_place_19 * ratio_q_P2_u_P1_2_of_q_p1_dot_56
        + sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_q_p1_dot_67;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_69 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_3)
        .mul_add(ratio_q_P2_u_P1_2_of_q_p1_dot_18, ratio_q_P2_u_P1_2_of_q_p1_dot_17)
        - ratio_q_P2_u_P1_2_of_q_p1_dot_25 * cos_q_P3;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_70 = ratio_q_P2_u_P1_2_of_q_p1_dot_69 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_71 = ratio_q_P2_u_P1_of_place_16
        * ratio_q_P2_u_P1_2_of_q_p1_dot_24;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_72 = ratio_q_P2_u_P1_2_of_q_p1_dot_71
        - ratio_q_P2_u_P1_2_of_q_p1_dot_70;
    let ratio_q_P2_u_P1_2_of_place = l * ratio_q_P2_u_P1_of_place_20;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_73 = (-ratio_q_P2_u_P1_of_place_66)
        .mul_add(
            ratio_q_P2_u_P1_2_of_q_p1_dot_62,
            ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_q_p1_dot_72,
        ) - ratio_q_P2_u_P1_of_place_8 * ratio_q_P2_u_P1_2_of_q_p1_dot_68
        + ratio_q_P2_u_P1_2_of_q_p1_dot_55 * ratio_q_P2_u_P1_2_of_place;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_74 = ratio_q_P2_u_P1_of_place_27
        .mul_add(
            ratio_q_P2_u_P1_2_of_q_p1_dot_68,
            ratio_q_P2_u_P1_of_place_66 * ratio_q_P2_u_P1_2_of_q_p1_dot_49,
        ) + ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_q_p1_dot_72
        + ratio_q_P2_u_P1_2_of_q_p1_dot_51 * ratio_q_P2_u_P1_2_of_place;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_75 = (-ratio_q_P2_u_P1_2_of_q_p1_dot_25)
        .mul_add(
            sin_q_P3,
            ratio_q_P2_u_P1_of_q_p4_q_p5_3 * ratio_q_P2_u_P1_2_of_q_p1_dot_15,
        ) + ratio_q_P2_u_P1_2_of_q_p1_dot_28;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_76 = (-ratio_q_P2_u_P1_2_of_q_p1_dot_69)
        .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_16 * q_p1_dot_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_77 = ratio_q_P2_u_P1 * q_p1_dot_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_78 = l
        * ((-ratio_q_P2_u_P1_of_place_15)
            .mul_add(q_p1_dot_cos_q_p1, ratio_q_P2_u_P1_2_of_q_p1_dot_75 * sin_q_P1)
            + ratio_q_P2_u_P1_2_of_q_p1_dot_76 * sin_q_P2
            - ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_2_of_q_p1_dot_77);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_79 = (-sin_q_p3_cos_q_p5)
        .mul_add(
            ratio_q_P2_u_P1_2_of_q_p1_dot_37,
            ratio_q_P2_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_q_p1_dot_23,
        ) - ratio_q_P2_u_P1_2_of_q_p1_dot_39
        + ratio_q_P2_u_P1_of_q_p3_q_p5_2 * ratio_q_P2_u_P1_2_of_q_p1_dot_43;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_80 = cos_q_p3_cos_q_p5 * ratio_q_P2_u_P1_2_of_q_p1_dot_6;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_81 = l
        * (ratio_q_P2_u_P1_of_place_24 * q_p1_dot_sin_q_p1
            - ratio_q_P2_u_P1_of_q_p5_2 * cos_q_p3_cos_q_p1 * q_p1_dot_cos_q_p4
            - ratio_q_P4_u_P1 * ratio_q_P2_u_P1_of_q_p4_q_p5 * ratio_q_P2_u_P1_2_of_q_p1_dot_60
            - ratio_q_P2_u_P1_2_of_q_p1_dot_79 * cos_q_P1
            + sin_q_P1
                * ratio_q_P2_u_P1_of_q_p3_q_p5
                    .mul_add(
                        ratio_q_P2_u_P1_2_of_q_p1_dot_34, ratio_q_P2_u_P1_2_of_q_p1_dot_80,
                    ));
    let ratio_q_P2_u_P1_2_of_q_p1_dot_82 = (-ratio_q_P2_u_P1_2_of_q_p1_dot_30)
        .mul_add(cos_q_P5, ratio_q_P2_u_P1_of_place_6 * ratio_q_P2_u_P1_2_of_q_p1_dot_32)
        - ratio_q_P2_u_P1_2_of_q_p1_dot_50 * sin_q_P5 + ratio_q_P2_u_P1_2_of_q_p1_dot_54 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_83 = l
        * ((-ratio_q_P2_u_P1_2_of_q_p1_dot_67)
            .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_19 * q_p1_dot_cos_q_p1)
            + ratio_q_P2_u_P1_of_place_29 * q_p1_dot_sin_q_p1
            + ratio_q_P2_u_P1_2_of_q_p1_dot_82 * cos_q_P1);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_84 = ratio_q_P2_u_P1_of_place_32
        .mul_add(
            ratio_q_P2_u_P1_2_of_q_p1_dot_32,
            ratio_q_P2_u_P1_of_q_p5_2 * ratio_q_P2_u_P1_2_of_q_p1_dot_30,
        ) - ratio_q_P2_u_P1_2_of_q_p1_dot_50 * cos_q_P5
        - ratio_q_P2_u_P1_2_of_q_p1_dot_75 * sin_q_P2;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_85 = (-ratio_q_P2_u_P1_of_place_29)
        .mul_add(q_p1_dot_cos_q_p1, ratio_q_P2_u_P1_of_place_19 * q_p1_dot_sin_q_p1)
        + ratio_q_P2_u_P1_2_of_q_p1_dot_67 * cos_q_P1 + ratio_q_P2_u_P1_2_of_q_p1_dot_82 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_86 = q_p1_dot_cos_q_p1 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_87 = ratio_q_P2_u_P1_2_of_q_p1_dot_24
        .mul_add(sin_q_P1, -ratio_q_P2_u_P1_2_of_q_p1_dot_86);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_88 = l * ratio_q_P2_u_P1_2_of_q_p1_dot_55;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_89 = ratio_q_P2_u_P1_of_place_8 * q_p1_dot_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_90 = ratio_q_P2_u_P1_2_of_q_p1_dot_88
        .mul_add(sin_q_P1, ratio_q_P2_u_P1_2_of_q_p1_dot_89);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_91 = ratio_q_P2_u_P1_of_place_32
        .mul_add(ratio_q_P2_u_P1_2_of_q_p1_dot_24, -ratio_q_P2_u_P1_2_of_q_p1_dot_38)
        + ratio_q_P2_u_P1_2_of_q_p1_dot_75 * cos_q_P2;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_92 = ratio_q_P2_u_P1_of_place_81
        * ratio_q_P2_u_P1_2_of_q_p1_dot_62 * sin_q_P1
        + ratio_q_P2_u_P1_of_place_42 * ratio_q_P2_u_P1_2_of_q_p1_dot_85
        - ratio_q_P2_u_P1_of_place_37 * ratio_q_P2_u_P1_2_of_q_p1_dot_90
        + ratio_q_P2_u_P1_of_place_5
            * (-ratio_q_P2_u_P1_2_of_q_p1_dot_91)
                .mul_add(sin_q_P1, ratio_q_P2_u_P1_of_place_41 * q_p1_dot_cos_q_p1);
    let ratio_q_P2_u_P1_2_of_place_2 = l * ratio_q_P2_u_P1_of_place_43;
    let ratio_q_P2_u_P1_2_of_place_3 = l_sq * ratio_q_P2_u_P1_of_place_7;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_93 = ratio_q_P2_u_P1_of_q_p5_2
        .mul_add(ratio_q_P2_u_P1_2_of_q_p1_dot_18, ratio_q_P2_u_P1_2_of_q_p1_dot_52);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_94 = ratio_q_P2_u_P1_of_q_p3_2
        .mul_add(ratio_q_P2_u_P1_2_of_q_p1_dot_14, ratio_q_P2_u_P1_2_of_q_p1_dot_16)
        + ratio_q_P2_u_P1_2_of_q_p1_dot_93;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_95 = (-ratio_q_P2_u_P1_of_q_p5_2)
        .mul_add(ratio_q_P2_u_P1_2_of_q_p1_dot_15, ratio_q_P2_u_P1_2_of_q_p1_dot_64);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_96 = ratio_q_P2_u_P1_of_q_p4_q_p5
        .mul_add(
            ratio_q_P2_u_P1_2_of_q_p1_dot_87,
            cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_q_p1_dot_25,
        );
    let ratio_q_P2_u_P1_2_of_q_p1_dot_97 = cos_q_p2_sin_q_p1
        * (ratio_q_P2_u_P1_of_place_48
            * q_p1_dot_cos_q_p1
                .mul_add(cos_q_P5, ratio_q_P2_u_P1_2_of_q_p1_dot_14 * sin_q_P1)
            - ratio_q_P2_u_P1_of_place_46 * ratio_q_P2_u_P1_2_of_q_p1_dot_18
            - cos_q_p5_sin_q_p1
                * (ratio_q_P2_u_P1_2_of_q_p1_dot_42
                    + ratio_q_P2_u_P1_of_place_47 * ratio_q_P2_u_P1_2_of_q_p1_dot_15
                    + sin_q_P3
                        * ratio_q_P2_u_P1_of_q_p3_2
                            .mul_add(
                                ratio_q_P2_u_P1_2_of_q_p1_dot_23, ratio_q_P2_u_P1_2_of_q_p1_dot_44,
                            ))
            - cos_q_P3
                * (cos_q_P4
                    * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_3)
                        .mul_add(
                            q_p1_dot_sin_q_p1,
                            sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_q_p1_dot_95,
                        ) - ratio_q_P2_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_q_p1_dot_56
                        - ratio_q_P2_u_P1_2_of_q_p1_dot_94 * cos_q_P1)
                    - ratio_q_P2_u_P1_of_place_44 * ratio_q_P2_u_P1_2_of_q_p1_dot_21
                    + ratio_q_P2_u_P1_2_of_q_p1_dot_96));
    let ratio_q_P2_u_P1_2_of_q_p1_dot_98 = ratio_q_P2_u_P1_of_place_50
        * ratio_q_P2_u_P1_2_of_q_p1_dot_55
        + l * ratio_q_P2_u_P1_of_place_38 * ratio_q_P2_u_P1_2_of_q_p1_dot_84
        + ratio_q_P2_u_P1_of_place_39
            * (l
                * ratio_q_P2_u_P1_of_place_36
                    .mul_add(
                        ratio_q_P2_u_P1_2_of_q_p1_dot_62,
                        ratio_q_P2_u_P1_of_place_37 * ratio_q_P2_u_P1_2_of_q_p1_dot_49,
                    )
                + ratio_q_P2_u_P1_of_place_5
                    * (ratio_q_P2_u_P1_of_q_p5_2
                        .mul_add(
                            ratio_q_P2_u_P1_2_of_q_p1_dot_48,
                            ratio_q_P2_u_P1_of_place_24 * q_p1_dot_cos_q_p1,
                        ) + ratio_q_P2_u_P1_2_of_q_p1_dot_79 * sin_q_P1
                        + ratio_q_P2_u_P1_2_of_q_p1_dot_80 * cos_q_P1)
                + ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_q_p1_dot_85)
        - ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_of_place_49
            * ratio_q_P2_u_P1_2_of_q_p1_dot_87
        + ratio_q_P2_u_P1_of_place_27 * ratio_q_P2_u_P1_2_of_q_p1_dot_92
        - ratio_q_P2_u_P1_2_of_q_p1_dot_51 * ratio_q_P2_u_P1_2_of_place_2
        + ratio_q_P2_u_P1_2_of_place_3 * ratio_q_P2_u_P1_2_of_q_p1_dot_97;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_99 = S::int(2) * ratio_q_P2_u_P1_2_of_q_p1_dot_4;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_100 = ratio_q_P2_u_P1_2_of_q_p1_dot_99
        - ratio_q_P2_u_P1_of_q_p4_2 * ratio_q_P2_u_P1_2_of_q_p1_dot
        - sin_q_P5 * (ratio_q_P2_u_P1_2_of_q_p1_dot_3 + ratio_q_P2_u_P1_2_of_q_p1_dot_99);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_101 = ratio_q_P2_u_P1_2_of_q_p1_dot_100 * sin_q_P3;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_102 = ratio_q_P2_u_P1_of_q_p4_q_p5_4
        * ratio_q_P2_u_P1_2_of_q_p1_dot_15;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_103 = ratio_q_P2_u_P1_2_of_q_p1_dot
        + ratio_q_P2_u_P1_2_of_q_p1_dot_25;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_104 = cos_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_q_p1_dot_103;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_105 = ratio_q_P2_u_P1_of_q_p4
        .mul_add(ratio_q_P2_u_P1_2_of_q_p1_dot_17, -ratio_q_P2_u_P1_2_of_q_p1_dot_53);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_106 = (-ratio_q_P2_u_P1_of_q_p4_q_p5_4)
        .mul_add(
            ratio_q_P2_u_P1_2_of_q_p1_dot_18,
            ratio_q_P2_u_P1_2_of_q_p1_dot_100 * cos_q_P3,
        );
    let ratio_q_P2_u_P1_2_of_q_p1_dot_107 = ratio_q_P2_u_P1_2_of_q_p1_dot_28
        + ratio_q_P2_u_P1_2_of_q_p1_dot_95;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_108 = cos_q_P1
        * (ratio_q_P2_u_P1_2_of_q_p1_dot_17 + ratio_q_P2_u_P1_2_of_q_p1_dot_93);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_109 = ratio_q_P2_u_P1_of_q_p3_q_p5_6
        * ratio_q_P2_u_P1_2_of_q_p1_dot_47;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_110 = ratio_q_P2_u_P1_2_of_q_p1_dot_77
        .mul_add(sin_q_P2, q_p1_dot_sin_q_p1 * cos_q_P2);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_111 = sin_q_P1
        * (ratio_q_P2_u_P1_of_place_70 * ratio_q_P2_u_P1_2_of_q_p1_dot_32
            - cos_q_p2_cos_q_p1 * ratio_q_P2_u_P1_2_of_q_p1_dot_54
            + sin_q_P2
                * (ratio_q_P2_u_P1_of_place_68 * q_p1_dot_cos_q_p1
                    - ratio_q_P2_u_P1_of_q_p3_q_p5_6 * ratio_q_P2_u_P1_2_of_q_p1_dot_45
                    + sin_q_P1
                        * (cos_q_P2
                            * (ratio_q_P2_u_P1_of_q_p3_q_p5_4 * ratio_q_P2_u_P1_2_of_q_p1_dot_3
                                - ratio_q_P2_u_P1_of_q_p3_2 * ratio_q_P2_u_P1_2_of_q_p1_dot
                                + sin_q_P4
                                    * (ratio_q_P2_u_P1_2_of_q_p1_dot
                                        + ratio_q_P2_u_P1_2_of_q_p1_dot_28)
                                + ratio_q_P2_u_P1_2_of_q_p1_dot_65)
                            - ratio_q_P2_u_P1_of_q_p3_q_p5_5 * ratio_q_P2_u_P1_2_of_q_p1_dot_23
                            - ratio_q_P2_u_P1_of_place_67 * ratio_q_P2_u_P1_2_of_q_p1_dot_24
                            + sin_q_p2_cos_q_p4 * ratio_q_P2_u_P1_2_of_q_p1_dot_107)
                    - ratio_q_P2_u_P1_2_of_q_p1_dot_108 * cos_q_P4
                    + ratio_q_P2_u_P1_2_of_q_p1_dot_109)
            + ratio_q_P2_u_P1_of_place_6 * ratio_q_P2_u_P1_2_of_q_p1_dot_110)
        + ratio_q_P2_u_P1_of_place_71 * q_p1_dot_cos_q_p1;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_112 = l_sq * ratio_q_P2_u_P1_2_of_q_p1_dot_84;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_113 = ratio_q_P2_u_P1_of_place_72
        * ratio_q_P2_u_P1_2_of_q_p1_dot_55
        - ratio_q_P2_u_P1_of_place_66 * ratio_q_P2_u_P1_2_of_q_p1_dot_92
        + ratio_q_P2_u_P1_2_of_q_p1_dot_72 * ratio_q_P2_u_P1_2_of_place_2
        + ratio_q_P2_u_P1_of_place_65
            * (-q_p1_dot_cos_q_p1
                * (ratio_q_P2_u_P1_of_place_62 * sin_q_p3_sin_q_p1)
                    .mul_add(S::int(2), ratio_q_P2_u_P1_of_place_61)
                + ratio_q_P2_u_P1_of_place_63 * ratio_q_P2_u_P1_2_of_q_p1_dot_58
                - sin_q_P1
                    * (ratio_q_P2_u_P1_of_q_p4_q_p5_5
                        * (-ratio_q_P2_u_P1_2_of_q_p1_dot_35)
                            .mul_add(
                                cos_q_P1,
                                cos_q_p2_sin_q_p1 * q_p1_dot_cos_q_p4 * sin_q_P3,
                            ) + ratio_q_P2_u_P1_of_place_60 * ratio_q_P2_u_P1_2_of_q_p1_dot_32
                        + sin_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_q_p1_dot_104
                        + sin_q_P2
                            * (sin_q_p3_cos_q_p1
                                * ratio_q_P2_u_P1_2_of_q_p1_dot_102
                                    .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_q_p1_dot_101)
                                - ratio_q_P2_u_P1_of_place_59 * ratio_q_P2_u_P1_2_of_q_p1_dot_18
                                - ratio_q_P2_u_P1_of_place_52 * ratio_q_P2_u_P1_2_of_q_p1_dot_57
                                + cos_q_P3
                                    * (ratio_q_P2_u_P1_of_place_55 * q_p1_dot_cos_q_p1
                                        + ratio_q_P2_u_P1_of_place_58 * q_p1_dot_sin_q_p1
                                        + sin_q_P1
                                            * (ratio_q_P2_u_P1_of_place_53
                                                * ratio_q_P2_u_P1_2_of_q_p1_dot_32
                                                - ratio_q_P2_u_P1_of_q_p4_q_p5_5
                                                    * ratio_q_P2_u_P1_2_of_q_p1_dot_30
                                                + sin_q_P2
                                                    * (ratio_q_P2_u_P1_of_q_p4
                                                        .mul_add(
                                                            ratio_q_P2_u_P1_2_of_q_p1_dot_28,
                                                            ratio_q_P2_u_P1_2_of_q_p1_dot_66,
                                                        ) + ratio_q_P2_u_P1_2_of_q_p1_dot_101
                                                        + ratio_q_P2_u_P1_2_of_q_p1_dot_102)
                                                + ratio_q_P2_u_P1_2_of_q_p1_dot_104)
                                        - cos_q_P1
                                            * ratio_q_P2_u_P1_2_of_q_p1_dot_105
                                                .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_q_p1_dot_106))))
                + sin_q_p3_cos_q_p1 * cos_q_P1
                    * (ratio_q_P2_u_P1_2_of_q_p1_dot_105 + ratio_q_P2_u_P1_2_of_q_p1_dot_106))
        + ratio_q_P2_u_P1_2_of_place_3 * ratio_q_P2_u_P1_2_of_q_p1_dot_111
        - ratio_q_P2_u_P1_of_place_64 * ratio_q_P2_u_P1_2_of_q_p1_dot_112;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_114 = ratio_q_P2_u_P1_of_place_50
        * (-ratio_q_P2_u_P1_2_of_q_p1_dot_71)
            .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_q_p1_dot_70)
        - ratio_q_P2_u_P1_of_place_72 * ratio_q_P2_u_P1_2_of_q_p1_dot_51
        + ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_of_place_49
            * ratio_q_P2_u_P1_2_of_q_p1_dot_86
        + ratio_q_P2_u_P1_of_place_65
            * (ratio_q_P2_u_P1_of_place_78 * q_p1_dot_cos_q_p1
                - ratio_q_P2_u_P1_of_place_10 * ratio_q_P2_u_P1_2_of_q_p1_dot_108
                + ratio_q_P2_u_P1_of_place_69 * ratio_q_P2_u_P1_2_of_q_p1_dot_46
                + S::int(2) * cos_q_p3_cos_q_p1 * ratio_q_P2_u_P1_2_of_q_p1_dot_109
                - sin_q_P1
                    * (ratio_q_P2_u_P1_of_place_69 * ratio_q_P2_u_P1_2_of_q_p1_dot_41
                        - ratio_q_P2_u_P1_of_place_77 * ratio_q_P2_u_P1_2_of_q_p1_dot_32
                        + sin_q_P2
                            * (cos_q_p3_cos_q_p5
                                * (cos_q_p2_sin_q_p1
                                    .mul_add(
                                        ratio_q_P2_u_P1_2_of_q_p1_dot_3,
                                        -ratio_q_P2_u_P1_2_of_q_p1_dot_48,
                                    ) + ratio_q_P2_u_P1_2_of_q_p1_dot_87 * sin_q_P4)
                                - ratio_q_P2_u_P1_of_place_75 * ratio_q_P2_u_P1_2_of_q_p1_dot_15
                                - ratio_q_P2_u_P1_of_place_76 * ratio_q_P2_u_P1_2_of_q_p1_dot_28
                                + sin_q_P3
                                    * (ratio_q_P2_u_P1_2_of_q_p1_dot_96
                                        - ratio_q_P2_u_P1_of_place_74
                                            * ratio_q_P2_u_P1_2_of_q_p1_dot_21
                                        + cos_q_P4
                                            * (ratio_q_P2_u_P1_of_q_p3_q_p5_7 * q_p1_dot_sin_q_p1
                                                - ratio_q_P2_u_P1_of_q_p3_q_p5_5
                                                    * ratio_q_P2_u_P1_2_of_q_p1_dot_56
                                                - cos_q_P1
                                                    * ratio_q_P2_u_P1_2_of_q_p1_dot_93
                                                        .mul_add(S::int(2), ratio_q_P2_u_P1_2_of_q_p1_dot_17)
                                                + sin_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_q_p1_dot_107)))
                        - cos_q_p2_sin_q_p4 * ratio_q_P2_u_P1_2_of_q_p1_dot_108
                        + ratio_q_P2_u_P1_of_q_p3_q_p5_6
                            * ratio_q_P2_u_P1_2_of_q_p1_dot_110 * sin_q_P4))
        + l_sq
            * ratio_q_P2_u_P1_of_place
                .mul_add(
                    ratio_q_P2_u_P1_2_of_q_p1_dot_111,
                    ratio_q_P2_u_P1_of_place_21 * ratio_q_P2_u_P1_2_of_q_p1_dot_97,
                ) + ratio_q_P2_u_P1_of_place_79 * ratio_q_P2_u_P1_2_of_q_p1_dot_112;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_115 = l
        * ratio_q_P2_u_P1_2_of_q_p1_dot_91
            .mul_add(cos_q_P1, ratio_q_P2_u_P1_of_place_41 * q_p1_dot_sin_q_p1);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_116 = ratio_q_P2_u_P1_of_place_99
        * ((-ratio_q_P2_u_P1_of_place_51)
            .mul_add(
                ratio_q_P2_u_P1_2_of_q_p1_dot_78,
                l_sq * ratio_q_P2_u_P1_of_place_82 * ratio_q_P2_u_P1_2_of_q_p1_dot_40,
            ) + ratio_q_P2_u_P1_of_place_73 * ratio_q_P2_u_P1_2_of_q_p1_dot_81
            - ratio_q_P2_u_P1_of_place_80 * ratio_q_P2_u_P1_2_of_q_p1_dot_83
            + ratio_q_P2_u_P1_of_place_18 * ratio_q_P2_u_P1_2_of_q_p1_dot_98
            + ratio_q_P2_u_P1_of_place_25 * ratio_q_P2_u_P1_2_of_q_p1_dot_113
            - ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_2_of_q_p1_dot_114
            + ratio_q_P2_u_P1_of_place_98 * ratio_q_P2_u_P1_2_of_q_p1_dot_115);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_117 = ratio_q_P2_u_P1_of_place_102
        * ratio_q_P2_u_P1_2_of_q_p1_dot
        + ratio_q_P2_u_P1_of_place_103 * ratio_q_P2_u_P1_2_of_q_p1_dot_14
        + cos_q_P5
            * (-sin_q_P1
                * ratio_q_P2_u_P1_2_of_q_p1_dot_18
                    .mul_add(sin_q_P4, ratio_q_P2_u_P1_2_of_q_p1_dot_3 * cos_q_P3)
                + w_rod3_frame_in_rod4_frame_1_4 * q_p1_dot_cos_q_p1
                - ratio_q_P2_u_P1_of_place_3 * q_p1_dot_sin_q_p1
                + ratio_q_P2_u_P1_2_of_q_p1_dot_59 * cos_q_P1)
        + sin_q_P5
            * ((-ratio_q_P2_u_P1_2_of_q_p1_dot_15)
                .mul_add(
                    sin_q_P1,
                    w_rod2_frame_in_rod3_frame_2_3 * ratio_q_P2_u_P1_2_of_q_p1_dot_77,
                ) - q_p1_dot_cos_q_p1 * sin_q_P3 - ratio_q_P2_u_P1_2_of_q_p1_dot_61 * sin_q_P2);
    let ratio_q_P2_u_P1_2_of_q_p1_dot_118 = ratio_q_P2_u_P1_of_place_105
        * ratio_q_P2_u_P1_of_place_104
            .mul_add(
                ratio_q_P2_u_P1_2_of_q_p1_dot_116, -ratio_q_P2_u_P1_2_of_q_p1_dot_117,
            );
    let ratio_q_P2_u_P1_2_of_q_p1_dot_119 = ratio_q_P2_u_P1_2_of_q_p1_dot_118
        .mul_add(
            cos_q_P5,
            ratio_q_P2_u_P1_of_place_106 * ratio_q_P2_u_P1_2_of_q_p1_dot_14,
        );
    let ratio_q_P2_u_P1_2_of_q_p1_dot_120 = ratio_q_P2_u_P1_of_place_34
        .mul_add(q_p1_dot_sin_q_p1, ratio_q_P2_u_P1_of_place_16 * q_p1_dot_cos_q_p1)
        + ratio_q_P2_u_P1_2_of_q_p1_dot_69 * sin_q_P1 - ratio_q_P2_u_P1_2_of_q_p1_dot_84 * cos_q_P1;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_121 = ratio_q_P2_u_P1_of_place_100
        * ratio_q_P2_u_P1_of_place_35
            .mul_add(
                ratio_q_P2_u_P1_2_of_q_p1_dot_116, -ratio_q_P2_u_P1_2_of_q_p1_dot_120,
            );
    let ratio_q_P2_u_P1_2_of_q_p1_dot_122 = ratio_q_P2_u_P1_of_place_34
        .mul_add(q_p1_dot_cos_q_p1, -ratio_q_P2_u_P1_2_of_q_p1_dot_76)
        + ratio_q_P2_u_P1_2_of_q_p1_dot_84 * sin_q_P1;
    let ratio_q_P2_u_P1_2_of_q_p1_dot_123 = ratio_q_P2_u_P1_of_place_108
        .mul_add(ratio_q_P2_u_P1_2_of_q_p1_dot_116, ratio_q_P2_u_P1_2_of_q_p1_dot_122);
    let ratio_q_P2_u_P1_2 = ratio_q_P2_u_P1_of_place_101
        * ((-ratio_q_P2_u_P1_of_place_18)
            .mul_add(
                ratio_q_P2_u_P1_2_of_q_p1_dot_63,
                ratio_q_P2_u_P1_of_place_25 * ratio_q_P2_u_P1_2_of_q_p1_dot_73,
            ) + ratio_q_P2_u_P1_of_place_30 * ratio_q_P2_u_P1_2_of_q_p1_dot_74
            - ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_2_of_q_p1_dot_78
            + ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_2_of_q_p1_dot_81
            - ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_q_p1_dot_83)
        - ratio_q_P2_u_P1_of_place_105 * ratio_q_P2_u_P1_of_place_108
            * ratio_q_P2_u_P1_2_of_q_p1_dot_40
        - ratio_q_P2_u_P1_of_place_107 * ratio_q_P2_u_P1_2_of_q_p1_dot_103
        + ratio_q_P2_u_P1_of_q_p4_q_p5_17 * ratio_q_P2_u_P1_2_of_q_p1_dot_119
        + ratio_q_P2_u_P1_of_place_31 * ratio_q_P2_u_P1_2_of_q_p1_dot_121
        + ratio_q_P2_u_P1_of_place_109 * ratio_q_P2_u_P1_2_of_q_p1_dot_123;
    let ratio_q_P3_u_P1_2_of_q_p1_dot = (-ratio_q_P2_u_P1_of_place_39)
        .mul_add(
            ratio_q_P2_u_P1_2_of_q_p1_dot_62,
            S::int(2) * ratio_q_P2_u_P1_of_place_42 * ratio_q_P2_u_P1_2_of_q_p1_dot_55,
        ) - ratio_q_P2_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_q_p1_dot_84
        + ratio_q_P2_u_P1_of_place_7 * ratio_q_P2_u_P1_2_of_q_p1_dot_89;
    let ratio_q_P3_u_P1_2_of_q_p1_dot_2 = (-ratio_q_P2_u_P1_of_place_39)
        .mul_add(
            ratio_q_P2_u_P1_2_of_q_p1_dot_49,
            ratio_q_P2_u_P1_of_place_26 * ratio_q_P2_u_P1_2_of_q_p1_dot_84,
        ) - ratio_q_P2_u_P1_of_place_42 * ratio_q_P2_u_P1_2_of_q_p1_dot_51
        + ratio_q_P2_u_P1_of_place * ratio_q_P2_u_P1_2_of_q_p1_dot_90;
    let ratio_q_P3_u_P1_2_of_q_p1_dot_3 = ratio_q_P2_u_P1_2_of_q_p1_dot_118
        .mul_add(
            cos_q_P4,
            ratio_q_P2_u_P1_of_place_106 * ratio_q_P2_u_P1_2_of_q_p1_dot_21,
        );
    let ratio_q_P3_u_P1_2_of_q_p1_dot_4 = ratio_q_P2_u_P1_of_place_100
        * ratio_q_P2_u_P1_2_of_q_p1_dot_123;
    let ratio_q_P3_u_P1_2 = ratio_q_P3_u_P1_of_place_5
        * ((-ratio_q_P2_u_P1_of_q_p3_q_p5_3)
            .mul_add(ratio_q_P2_u_P1_2_of_q_p1_dot_14, ratio_q_P2_u_P1_2_of_q_p1_dot)
            + ratio_q_P2_u_P1_2_of_q_p1_dot_94 * cos_q_P5 - ratio_q_P2_u_P1_2_of_q_p1_dot_95)
        + ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_q_p1_dot_98
        + ratio_q_P3_u_P1_of_place_3 * ratio_q_P2_u_P1_2_of_q_p1_dot_121
        + ratio_q_P2_u_P1_of_place_101
            * ((-ratio_q_P2_u_P1_of_place_82)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_q_p1_dot_63,
                    ratio_q_P3_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_q_p1_dot_83,
                ) - ratio_q_P3_u_P1_of_place * ratio_q_P2_u_P1_2_of_q_p1_dot_81
                - ratio_q_P2_u_P1_of_place_13 * ratio_q_P2_u_P1_2_of_q_p1_dot_115
                - ratio_q_P2_u_P1_of_place_25 * ratio_q_P3_u_P1_2_of_q_p1_dot
                + ratio_q_P2_u_P1_of_place_30 * ratio_q_P3_u_P1_2_of_q_p1_dot_2)
        - ratio_q_P3_u_P1_of_q_p3_q_p5 * ratio_q_P3_u_P1_2_of_q_p1_dot_3
        + ratio_q_P2_u_P1_of_place_51 * ratio_q_P3_u_P1_2_of_q_p1_dot_4;
    let ratio_q_P4_u_P1_2_of_q_p1_dot = ratio_q_P2_u_P1_of_place_39
        * ratio_q_P2_u_P1_2_of_q_p1_dot_68
        - ratio_q_P2_u_P1_2_of_place * ratio_q_P2_u_P1_2_of_q_p1_dot_84
        + ratio_q_P2_u_P1_of_place_8
            * (-ratio_q_P2_u_P1_of_place_16)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_q_p1_dot_87,
                    cos_q_p2_sin_q_p1 * ratio_q_P2_u_P1_2_of_q_p1_dot_69,
                ) + ratio_q_P4_u_P1_of_place * ratio_q_P2_u_P1_2_of_q_p1_dot_88;
    let ratio_q_P4_u_P1_2_of_q_p1_dot_2 = ratio_q_P2_u_P1_2_of_q_p1_dot_28
        - ratio_q_P2_u_P1_2_of_q_p1_dot_15;
    let ratio_q_P4_u_P1_2 = ratio_q_P4_u_P1_of_place_3 * ratio_q_P2_u_P1_2_of_q_p1_dot_121
        - ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_q_p1_dot_113
        - ratio_q_P4_u_P1_of_place_5 * ratio_q_P2_u_P1_2_of_q_p1_dot_119
        + ratio_q_P2_u_P1_of_place_73 * ratio_q_P3_u_P1_2_of_q_p1_dot_4
        + ratio_q_P2_u_P1_of_place_101
            * ((-ratio_q_P2_u_P1_of_place_82)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_q_p1_dot_73,
                    ratio_q_P2_u_P1_of_place_30 * ratio_q_P4_u_P1_2_of_q_p1_dot,
                ) - ratio_q_P3_u_P1_of_place * ratio_q_P2_u_P1_2_of_q_p1_dot_78
                - ratio_q_P4_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_q_p1_dot_83
                - ratio_q_P2_u_P1_of_place_22 * ratio_q_P2_u_P1_2_of_q_p1_dot_115
                - ratio_q_P2_u_P1_of_place_18 * ratio_q_P3_u_P1_2_of_q_p1_dot)
        + ratio_q_P2_u_P1_of_place_107
            * (-ratio_q_P2_u_P1_2_of_q_p1_dot
                + ratio_q_P4_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_q_p1_dot_3
                - sin_q_P4
                    * ((-ratio_q_P4_u_P1_of_q_p4_q_p5)
                        .mul_add(
                            ratio_q_P2_u_P1_2_of_q_p1_dot_15,
                            ratio_q_P2_u_P1_2_of_q_p1_dot_103 * sin_q_P3,
                        ) - ratio_q_P2_u_P1_2_of_q_p1_dot_25 - ratio_q_P2_u_P1_2_of_q_p1_dot_28)
                + ratio_q_P4_u_P1_2_of_q_p1_dot_2);
    let ratio_q_P5_u_P1_2 = ratio_q_P3_u_P1_of_place_4 * ratio_q_P2_u_P1_2_of_q_p1_dot_114
        + ratio_q_P5_u_P1_of_place * ratio_q_P2_u_P1_2_of_q_p1_dot_121
        - ratio_q_P5_u_P1_of_place_2 * ratio_q_P3_u_P1_2_of_q_p1_dot_3
        + ratio_q_P2_u_P1_of_place_80 * ratio_q_P3_u_P1_2_of_q_p1_dot_4
        + ratio_q_P2_u_P1_of_place_101
            * ((-ratio_q_P2_u_P1_of_place_82)
                .mul_add(
                    ratio_q_P2_u_P1_2_of_q_p1_dot_74,
                    ratio_q_P2_u_P1_of_place_18 * ratio_q_P3_u_P1_2_of_q_p1_dot_2,
                ) - ratio_q_P3_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_q_p1_dot_78
                - ratio_q_P4_u_P1_of_place_2 * ratio_q_P2_u_P1_2_of_q_p1_dot_81
                - ratio_q_P2_u_P1_of_place_28 * ratio_q_P2_u_P1_2_of_q_p1_dot_115
                - ratio_q_P2_u_P1_of_place_25 * ratio_q_P4_u_P1_2_of_q_p1_dot)
        + ratio_q_P3_u_P1_of_place_5
            * (ratio_q_P5_u_P1_of_q_p3_q_p5 * ratio_q_P2_u_P1_2_of_q_p1_dot_3
                - ratio_q_P5_u_P1_of_q_p3_q_p5_2 * ratio_q_P2_u_P1_2_of_q_p1_dot
                + sin_q_P4
                    * ((-(ratio_q_P2_u_P1_2_of_q_p1_dot_2 * sin_q_P3))
                        .mul_add(
                            S::int(2),
                            ratio_q_P2_u_P1_of_q_p5_4 * ratio_q_P2_u_P1_2_of_q_p1_dot_15,
                        ) + ratio_q_P2_u_P1_2_of_q_p1_dot_36)
                + ratio_q_P2_u_P1_of_q_p5 * ratio_q_P4_u_P1_2_of_q_p1_dot_2);
    let cos_q_p2_doubled = S::int(2) * cos_q_P2;
    let l_times_12 = S::int(12) * l;
    let d1_of_place = ratio_q_P5_u_P1 * p_w_rod5_frame_3_6;
    let d1_of_place_2 = p_w_rod1_frame_in_rod2_frame_2_3.mul_add(cos_q_P2, -H_rod1_2);
    let d1_of_place_3 = ratio_q_P4_u_P1
        .mul_add(
            p_w_rod2_frame_in_rod3_frame_2_6,
            ratio_q_P3_u_P1 * p_w_rod2_frame_in_rod3_frame_2_5,
        );
    let d1_of_place_4 = ratio_q_P5_u_P1
        .mul_add(p_w_rod1_frame_in_rod2_frame_2_7_of_place, d1_of_place_3);
    let d1_of_place_5 = ratio_q_P2_u_P1 * p_w_rod2_frame_in_rod3_frame_2_4;
    let d1_of_place_6 = ratio_q_P4_u_P1
        .mul_add(
            p_w_rod2_frame_in_rod3_frame_3_6,
            ratio_q_P3_u_P1 * p_w_rod2_frame_in_rod3_frame_3_5,
        );
    let d1_of_place_7 = ratio_q_P5_u_P1
        .mul_add(p_w_rod2_frame_in_rod3_frame_3_7, d1_of_place_6);
    let d1_of_place_8 = ratio_q_P2_u_P1 * p_w_rod2_frame_in_rod3_frame_3_4;
    let d1_of_place_9 = ratio_q_P4_u_P1
        .mul_add(p_v_rod4_centre_1_6, ratio_q_P3_u_P1 * p_v_rod4_centre_1_5);
    let d1_of_place_10 = ratio_q_P5_u_P1
        .mul_add(p_v_rod4_centre_1_7, p_v_rod3_centre_3_4);
    let d1_of_place_11 = d1_of_place_9 + d1_of_place_10;
    let d1_of_place_12 = ratio_q_P2_u_P1 * p_v_rod2_centre_1_2;
    let ratio_q_p2_u_p1_h_rod1_2 = ratio_q_P2_u_P1 * H_rod1_2;
    let d1_of_place_13 = ratio_q_P4_u_P1
        .mul_add(p_w_rod3_frame_1_6, p_w_rod1_frame_in_rod2_frame_2_5 * cos_q_P2);
    let d1_of_place_14 = ratio_q_P5_u_P1.mul_add(p_w_rod3_frame_1_7, -d1_of_place_13);
    let d1_of_place_15 = ratio_q_P3_u_P1 * p_w_rod3_frame_1_5;
    let d1_of_place_16 = ratio_q_P4_u_P1 * p_w_rod4_frame_2_6;
    let d1_of_place_17 = ratio_q_P2_u_P1
        * (sin_q_P3 * (-d1_of_place_4).mul_add(S::int(2), d1_of_place_5)
            - p_w_rod1_frame_in_rod2_frame_1_4 * sin_q_p2_doubled
            - p_w_rod1_frame_in_rod2_frame_2_4 * cos_q_p2_doubled
            + cos_q_P3 * d1_of_place_7.mul_add(S::int(2), d1_of_place_8)
            + l_times_3 * d1_of_place_11.mul_add(S::int(4), d1_of_place_12)
            + ratio_q_p2_u_p1_h_rod1_2) + p_w_rod1_frame_in_rod2_frame_1_3 * sin_q_P2;
    let d1_of_place_18 = ratio_q_P3_u_P1
        * ((-p_w_rod1_frame_in_rod2_frame_1_5)
            .mul_add(sin_q_p2_doubled, p_v_rod3_centre_3_5 * l_times_12)
            + S::int(2) * d1_of_place_14 + d1_of_place_15)
        + ratio_q_P4_u_P1
            * ((-p_w_rod1_frame_in_rod2_frame_1_6)
                .mul_add(sin_q_p2_doubled, p_v_rod3_centre_3_6 * l_times_12)
                - p_w_rod1_frame_in_rod2_frame_2_6 * cos_q_p2_doubled + d1_of_place_16);
    let d1_of_place_19 = ratio_q_P5_u_P1
        * ((-p_w_rod1_frame_in_rod2_frame_1_7)
            .mul_add(
                sin_q_p2_doubled,
                p_w_rod1_frame_in_rod2_frame_2_7 * cos_q_p2_doubled,
            ) + p_v_rod3_centre_3_7 * l_times_12 - d1_of_place) + d1_of_place_2;
    let d1_of_place_20 = d1_of_place_17 + d1_of_place_18;
    let d1_of_place_21 = d1_of_place_19 - d1_of_place_20;
    let d1 = S::ratio(1, 4) * l * p_v_rod1_centre_3_2 - S::ratio(1, 12) * d1_of_place_21;
    let u_P1_dot_of_place = p_w_rod1_frame_in_rod2_frame_1
        .mul_add(cos_q_P2, p_w_rod1_frame_in_rod2_frame_2 * sin_q_P2);
    let u_P1_dot_of_place_2 = S::int(6) * v_rod2_frame_in_rod3_frame_3;
    let v_rod4_centre_1_times_6 = S::int(6) * v_rod4_centre_1;
    let u_P1_dot_of_place_3 = S::int(6) * x_rod1_frame_in_rod2_frame_1;
    let u_P1_dot_of_place_4 = S::int(6) * x_rod2_frame_in_rod3_frame_3;
    let x_rod5_frame_3_times_6 = S::int(6) * x_rod5_frame_3;
    let u_P1_dot_of_place_5 = S::int(54) * x_rod1_frame_in_rod2_frame_1_2;
    let u_P1_dot_of_place_6 = S::int(6) * p_v_rod5_centre_1;
    let u_P1_dot_of_place_7 = S::int(12) * p_v_rod4_frame_in_rod5_frame_2;
    let u_P1_dot_of_place_8 = S::int(6) * x_rod2_frame_in_rod3_frame_2;
    let u_P1_dot_of_place_9 = S::int(6) * x_rod3_frame_in_rod4_frame_1;
    let u_P1_dot_of_place_10 = S::int(6) * x_rod4_frame_in_rod5_frame_1;
    let u_P1_dot_of_place_11 = S::int(6) * x_rod4_frame_in_rod5_frame_2;
    let v_rod3_centre_3_times_6 = S::int(6) * v_rod3_centre_3;
    let u_P1_dot_of_place_12 = S::int(6) * x_rod1_frame_in_rod2_frame_2;
    let x_rod5_frame_2_times_6 = S::int(6) * x_rod5_frame_2;
    let u_P1_dot = S::ratio(1, 12)
        * (p_w_rod1_frame_in_rod2_frame_2_2 * cos_q_P2
            - p_w_rod1_frame_in_rod2_frame_1_2 * sin_q_P2 - p_v_rod1_centre_3 * l_times_6
            + ratio_q_P2_u_P1
                * (q_P3_dot * p_w_rod1_frame_in_rod2_frame_2
                    + p_w_rod2_frame_in_rod3_frame_3_2 * cos_q_P3
                    - p_w_rod2_frame_in_rod3_frame_2_2 * sin_q_P3
                    + S::int(54) * mp_rod1_frame_1
                        * (-F_x_rod1_frame_in_rod2_frame_1)
                            .mul_add(sin_q_P2, F_x_rod5_frame_2 * cos_q_P2)
                    - S::int(6) * g
                        * F_x_rod1_frame_in_rod2_frame_1_2
                            .mul_add(cos_q_P2, F_x_rod1_frame_in_rod2_frame_2 * sin_q_P2)
                    + p_v_rod2_centre_1 * l_times_6) - q_P2_dot * u_P1_dot_of_place
            + q_P1_dot
                * (ratio_q_P5_u_P1_2
                    * ((-ratio_q_P3_u_P1)
                        .mul_add(
                            p_w_rod3_frame_1_7,
                            p_w_rod1_frame_in_rod2_frame_2_7 * cos_q_P2,
                        ) - p_w_rod1_frame_in_rod2_frame_1_7 * sin_q_P2
                        + p_w_rod1_frame_in_rod2_frame_1_7_of_place - d1_of_place)
                    + ratio_q_P2_u_P1_2
                        * (p_w_rod1_frame_in_rod2_frame_2_4 * cos_q_P2
                            + p_w_rod1_frame_in_rod2_frame_1_4 * sin_q_P2
                            + sin_q_P3 * (d1_of_place_4 - d1_of_place_5)
                            - cos_q_P3 * (d1_of_place_7 + d1_of_place_8)
                            - l_times_3 * d1_of_place_11.mul_add(S::int(2), d1_of_place_12)
                            - ratio_q_p2_u_p1_h_rod1_2)
                    + ratio_q_P3_u_P1_2
                        * (p_w_rod1_frame_in_rod2_frame_1_5
                            .mul_add(
                                sin_q_P2, -p_w_rod1_frame_in_rod2_frame_1_5_of_place,
                            ) - d1_of_place_14 - d1_of_place_15)
                    + ratio_q_P4_u_P1_2
                        * (p_w_rod1_frame_in_rod2_frame_2_6
                            .mul_add(cos_q_P2, ratio_q_P3_u_P1 * p_w_rod3_frame_1_6)
                            + p_w_rod1_frame_in_rod2_frame_1_6 * sin_q_P2
                            - p_w_rod1_frame_in_rod2_frame_1_6_of_place - d1_of_place_16)
                    + ratio_q_P2_u_P1
                        * (sin_q_P3
                            * (p_w_rod2_frame_in_rod3_frame_2_6
                                .mul_add(
                                    ratio_q_P4_u_P1_2,
                                    p_w_rod2_frame_in_rod3_frame_2_5 * ratio_q_P3_u_P1_2,
                                )
                                + ratio_q_P5_u_P1_2 * p_w_rod1_frame_in_rod2_frame_2_7_of_place)
                            - cos_q_P3
                                * (p_w_rod2_frame_in_rod3_frame_3_6
                                    .mul_add(
                                        ratio_q_P4_u_P1_2,
                                        p_w_rod2_frame_in_rod3_frame_3_5 * ratio_q_P3_u_P1_2,
                                    ) + p_w_rod2_frame_in_rod3_frame_3_7 * ratio_q_P5_u_P1_2)
                            - l_times_6
                                * (p_v_rod4_centre_1_6
                                    .mul_add(
                                        ratio_q_P4_u_P1_2,
                                        p_v_rod4_centre_1_5 * ratio_q_P3_u_P1_2,
                                    ) + p_v_rod4_centre_1_7 * ratio_q_P5_u_P1_2)
                            + u_P1_dot_of_place))
            + ratio_q_P4_u_P1
                * (p_w_rod4_frame_2_2
                    + sin_q_P4
                        * ((-w_rod3_frame_1)
                            .mul_add(
                                p_w_rod3_frame_in_rod4_frame_1,
                                w_rod2_frame_in_rod3_frame_3 * p_w_rod3_frame_in_rod4_frame_3,
                            ) + p_v_rod3_frame_in_rod4_frame_3 * u_P1_dot_of_place_2
                            - p_v_rod3_frame_in_rod4_frame_1 * v_rod4_centre_1_times_6
                            - F_x_rod3_frame_in_rod4_frame_1 * u_P1_dot_of_place_3
                            + x_rod3_frame_in_rod4_frame_3_2 * u_P1_dot_of_place_4
                            + x_rod3_frame_in_rod4_frame_3 * x_rod5_frame_3_times_6
                            - F_x_rod5_frame_1 * u_P1_dot_of_place_5)
                    + cos_q_P4
                        * ((-w_rod3_frame_1)
                            .mul_add(
                                p_w_rod3_frame_in_rod4_frame_3,
                                x_rod3_frame_in_rod4_frame_3_2 * u_P1_dot_of_place_3,
                            )
                            - w_rod2_frame_in_rod3_frame_3 * p_w_rod3_frame_in_rod4_frame_1
                            - p_v_rod3_frame_in_rod4_frame_1 * u_P1_dot_of_place_2
                            - p_v_rod3_frame_in_rod4_frame_3 * v_rod4_centre_1_times_6
                            + F_x_rod3_frame_in_rod4_frame_1 * u_P1_dot_of_place_4
                            - F_x_rod5_frame_1 * x_rod5_frame_3_times_6
                            - x_rod3_frame_in_rod4_frame_3 * u_P1_dot_of_place_5))
            - ratio_q_P5_u_P1
                * (p_w_rod5_frame_3_2
                    + sin_q_P5
                        * ((-w_rod3_frame_in_rod4_frame_1)
                            .mul_add(
                                p_w_rod4_frame_in_rod5_frame_1,
                                v_rod3_frame_in_rod4_frame_1 * u_P1_dot_of_place_6,
                            ) + v_rod5_centre_2 * u_P1_dot_of_place_7
                            - x_rod5_frame_2_2 * u_P1_dot_of_place_8
                            - x_rod4_frame_in_rod5_frame_1_2 * u_P1_dot_of_place_9
                            - x_rod5_frame_1 * u_P1_dot_of_place_10
                            - x_rod2_frame_in_rod3_frame_2_2 * u_P1_dot_of_place_11)
                    + cos_q_P5
                        * ((-w_rod4_frame_2)
                            .mul_add(
                                p_w_rod4_frame_in_rod5_frame_1,
                                v_rod3_frame_in_rod4_frame_1 * u_P1_dot_of_place_7,
                            ) - v_rod5_centre_2 * u_P1_dot_of_place_6
                            + x_rod4_frame_in_rod5_frame_1_2 * u_P1_dot_of_place_8
                            - x_rod5_frame_2_2 * u_P1_dot_of_place_9
                            - x_rod2_frame_in_rod3_frame_2_2 * u_P1_dot_of_place_10
                            + x_rod5_frame_1 * u_P1_dot_of_place_11))
            - ratio_q_P3_u_P1
                * (p_w_rod3_frame_1_2
                    + sin_q_P3
                        * (w_rod1_frame_in_rod2_frame_2
                            .mul_add(
                                p_w_rod2_frame_in_rod3_frame_2,
                                q_P2_dot * p_w_rod2_frame_in_rod3_frame_3,
                            ) + p_v_rod2_frame_in_rod3_frame_3 * v_rod3_centre_3_times_6
                            + F_x_rod2_frame_in_rod3_frame_2_2 * u_P1_dot_of_place_12
                            + F_x_rod2_frame_in_rod3_frame_2 * x_rod5_frame_2_times_6)
                    + cos_q_P3
                        * ((-q_P2_dot)
                            .mul_add(
                                p_w_rod2_frame_in_rod3_frame_2,
                                w_rod1_frame_in_rod2_frame_2 * p_w_rod2_frame_in_rod3_frame_3,
                            ) - p_v_rod2_frame_in_rod3_frame_2 * v_rod3_centre_3_times_6
                            - F_x_rod2_frame_in_rod3_frame_3 * u_P1_dot_of_place_12
                            + F_x_rod5_frame_3 * x_rod5_frame_2_times_6))) / d1;
    let q_P1_ddot = u_P1_dot;
    let q_P2_ddot = q_P1_dot.mul_add(ratio_q_P2_u_P1_2, u_P1_dot * ratio_q_P2_u_P1);
    let q_P3_ddot = q_P1_dot.mul_add(ratio_q_P3_u_P1_2, u_P1_dot * ratio_q_P3_u_P1);
    let q_P4_ddot = (-q_P1_dot).mul_add(ratio_q_P4_u_P1_2, -u_P1_dot * ratio_q_P4_u_P1);
    let q_P5_ddot = (-q_P1_dot).mul_add(ratio_q_P5_u_P1_2, -u_P1_dot * ratio_q_P5_u_P1);
    [q_P1_ddot, q_P2_ddot, q_P3_ddot, q_P4_ddot, q_P5_ddot]
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
    let [q_P1_dot, q_P2_dot, q_P3_dot, q_P4_dot, q_P5_dot] = *q_dot;
    // Values.
    // q_P1'
    let q_P1_dot_value = q_P1_dot;
    // q_P2'
    let q_P2_dot_value = q_P2_dot;
    // q_P3'
    let q_P3_dot_value = q_P3_dot;
    // q_P4'
    let q_P4_dot_value = q_P4_dot;
    // q_P5'
    let q_P5_dot_value = q_P5_dot;
    [q_P1_dot_value, q_P2_dot_value, q_P3_dot_value, q_P4_dot_value, q_P5_dot_value]
}

/// Kinetic energy T.
///
/// 119 operations, 4 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> S {
    let Parameters { l, m, .. } = *p;
    let [_, q_P2, q_P3, q_P4, q_P5] = *q;
    let [q_P1_dot, q_P2_dot, q_P3_dot, q_P4_dot, q_P5_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q_P2, cos_q_P2) = q_P2.sin_cos();
    let (sin_q_P3, cos_q_P3) = q_P3.sin_cos();
    let (sin_q_P4, cos_q_P4) = q_P4.sin_cos();
    let (sin_q_P5, cos_q_P5) = q_P5.sin_cos();
    // Step by step, each after the terms that it needs.
    let w_rod1_frame_in_rod2_frame_1 = q_P1_dot * sin_q_P2;
    let w_rod1_frame_in_rod2_frame_2 = q_P1_dot * cos_q_P2;
    let w_rod2_frame_in_rod3_frame_2 = w_rod1_frame_in_rod2_frame_2
        .mul_add(cos_q_P3, q_P2_dot * sin_q_P3);
    let w_rod2_frame_in_rod3_frame_3 = (-w_rod1_frame_in_rod2_frame_2)
        .mul_add(sin_q_P3, q_P2_dot * cos_q_P3);
    let w_rod3_frame_1 = q_P3_dot + w_rod1_frame_in_rod2_frame_1;
    let w_rod3_frame_in_rod4_frame_1 = (-w_rod3_frame_1)
        .mul_add(cos_q_P4, w_rod2_frame_in_rod3_frame_3 * sin_q_P4);
    let w_rod3_frame_in_rod4_frame_3 = w_rod3_frame_1
        .mul_add(sin_q_P4, w_rod2_frame_in_rod3_frame_3 * cos_q_P4);
    let w_rod4_frame_2 = q_P4_dot + w_rod2_frame_in_rod3_frame_2;
    let w_rod4_frame_in_rod5_frame_1 = (-w_rod4_frame_2)
        .mul_add(sin_q_P5, w_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let w_rod5_frame_3 = q_P5_dot + w_rod3_frame_in_rod4_frame_3;
    let v_rod1_centre_3 = l * q_P1_dot;
    let v_rod2_centre_1 = l * q_P2_dot;
    let v_rod2_centre_3_of_place = l * w_rod1_frame_in_rod2_frame_1;
    let v_rod2_centre_3 = (-v_rod1_centre_3)
        .mul_add(S::int(2), v_rod2_centre_3_of_place);
    let l_sq_m = l * l * m;
    let H_rod2_1 = w_rod1_frame_in_rod2_frame_1 * l_sq_m;
    let v_rod3_centre_3 = v_rod2_centre_3_of_place - v_rod1_centre_3;
    let v_rod2_frame_in_rod3_frame_2 = v_rod3_centre_3 * sin_q_P3;
    let v_rod2_frame_in_rod3_frame_3 = v_rod3_centre_3 * cos_q_P3;
    let v_rod3_centre_1_of_place = l * w_rod2_frame_in_rod3_frame_2;
    let v_rod3_centre_1 = (-v_rod2_centre_1)
        .mul_add(S::int(2), v_rod3_centre_1_of_place);
    let l_w_rod3_frame_1 = l * w_rod3_frame_1;
    let v_rod3_centre_2 = (-v_rod2_frame_in_rod3_frame_2)
        .mul_add(S::int(2), l_w_rod3_frame_1);
    let H_rod3_1 = w_rod3_frame_1 * l_sq_m;
    let H_rod3_2 = w_rod2_frame_in_rod3_frame_2 * l_sq_m;
    let v_rod4_centre_1 = v_rod3_centre_1_of_place - v_rod2_centre_1;
    let v_rod4_centre_2 = l_w_rod3_frame_1 - v_rod2_frame_in_rod3_frame_2;
    let v_rod3_frame_in_rod4_frame_1 = (-v_rod4_centre_1)
        .mul_add(cos_q_P4, v_rod2_frame_in_rod3_frame_3 * sin_q_P4);
    let v_rod3_frame_in_rod4_frame_3 = v_rod4_centre_1
        .mul_add(sin_q_P4, v_rod2_frame_in_rod3_frame_3 * cos_q_P4);
    let v_rod4_centre_2_2_of_place = l * w_rod3_frame_in_rod4_frame_3;
    let v_rod4_centre_2_2 = v_rod4_centre_2
        .mul_add(S::int(2), v_rod4_centre_2_2_of_place);
    let l_w_rod4_frame_2 = l * w_rod4_frame_2;
    let v_rod4_centre_3 = v_rod3_frame_in_rod4_frame_3
        .mul_add(S::int(2), l_w_rod4_frame_2);
    let H_rod4_2 = w_rod4_frame_2 * l_sq_m;
    let H_rod4_3 = w_rod3_frame_in_rod4_frame_3 * l_sq_m;
    let v_rod5_centre_2 = v_rod4_centre_2 + v_rod4_centre_2_2_of_place;
    let v_rod5_centre_3 = v_rod3_frame_in_rod4_frame_3 + l_w_rod4_frame_2;
    let v_rod4_frame_in_rod5_frame_1 = v_rod5_centre_2
        .mul_add(sin_q_P5, v_rod3_frame_in_rod4_frame_1 * cos_q_P5);
    let v_rod4_frame_in_rod5_frame_2 = (-v_rod5_centre_2)
        .mul_add(cos_q_P5, v_rod3_frame_in_rod4_frame_1 * sin_q_P5);
    let v_rod5_centre_1 = (-v_rod4_frame_in_rod5_frame_1)
        .mul_add(S::int(2), l * w_rod5_frame_3);
    let v_rod5_centre_3_2 = v_rod5_centre_3
        .mul_add(S::int(2), l * w_rod4_frame_in_rod5_frame_1);
    let H_rod5_1 = w_rod4_frame_in_rod5_frame_1 * l_sq_m;
    let H_rod5_3 = w_rod5_frame_3 * l_sq_m;
    let H_rod1_2_2 = q_P1_dot * l_sq_m;
    let H_rod2_3 = q_P2_dot * l_sq_m;
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
    let energy_of_q_p2_dot = q_P2_dot.mul_add(H_rod2_3, w_rod3_frame_1 * H_rod3_1);
    let energy_of_place_9 = w_rod4_frame_2
        .mul_add(H_rod4_2, w_rod2_frame_in_rod3_frame_2 * H_rod3_2);
    let energy_of_q_p1_dot = q_P1_dot
        .mul_add(H_rod1_2_2, w_rod1_frame_in_rod2_frame_1 * H_rod2_1);
    let energy_of_place_10 = w_rod4_frame_in_rod5_frame_1
        .mul_add(H_rod5_1, w_rod3_frame_in_rod4_frame_3 * H_rod4_3);
    let energy_of_q_p1_dot_2 = w_rod5_frame_3.mul_add(H_rod5_3, energy_of_q_p1_dot);
    let energy_of_q_p2_dot_2 = energy_of_q_p2_dot + energy_of_place_9;
    let energy_of_q_p1_dot_3 = energy_of_place_10 + energy_of_q_p1_dot_2;
    let energy_of_motion = energy_of_q_p2_dot_2 + energy_of_q_p1_dot_3;
    // Values.
    let energy = S::ratio(1, 2) * m
        * v_rod4_frame_in_rod5_frame_2
            .mul_add(v_rod4_frame_in_rod5_frame_2, energy_of_place)
        + S::ratio(1, 8) * m * (energy_of_place_7 + energy_of_place_8)
        + S::ratio(1, 24) * energy_of_motion;
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
    let mp_rod1_frame_1 = l * m;
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
    let x_rod1_frame_in_rod2_frame_1_2 = mp_rod1_frame_1 * cos_q_P2;
    let x_rod1_frame_in_rod2_frame_2_2 = mp_rod1_frame_1 * sin_q_P2;
    let x_rod5_frame_2 = (-x_rod1_frame_in_rod2_frame_2_2)
        .mul_add(S::int(9), S::int(7) * mp_rod1_frame_1);
    let x_rod2_frame_in_rod3_frame_2_2 = x_rod5_frame_2 * cos_q_P3;
    let x_rod2_frame_in_rod3_frame_3_2 = x_rod5_frame_2 * sin_q_P3;
    let x_rod5_frame_3 = mp_rod1_frame_1
        .mul_add(S::int(5), -x_rod2_frame_in_rod3_frame_3_2);
    let x_rod3_frame_in_rod4_frame_1_2_of_place = S::int(9) * x_rod1_frame_in_rod2_frame_1_2;
    let x_rod3_frame_in_rod4_frame_1_2 = (-x_rod3_frame_in_rod4_frame_1_2_of_place)
        .mul_add(cos_q_P4, x_rod5_frame_3 * sin_q_P4);
    let x_rod3_frame_in_rod4_frame_3_2 = x_rod3_frame_in_rod4_frame_1_2_of_place
        .mul_add(sin_q_P4, x_rod5_frame_3 * cos_q_P4);
    let x_rod5_frame_1 = mp_rod1_frame_1
        .mul_add(S::int(3), x_rod3_frame_in_rod4_frame_1_2);
    let x_rod4_frame_in_rod5_frame_1_2 = (-x_rod2_frame_in_rod3_frame_2_2)
        .mul_add(sin_q_P5, x_rod5_frame_1 * cos_q_P5);
    let x_rod4_frame_in_rod5_frame_2_2 = x_rod5_frame_1
        .mul_add(sin_q_P5, x_rod2_frame_in_rod3_frame_2_2 * cos_q_P5);
    let x_rod5_frame_2_2 = mp_rod1_frame_1 - x_rod4_frame_in_rod5_frame_2_2;
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

/// The generalized speeds u, from q and q'.
///
/// 0 operations.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 1] {
    let [q_P1_dot, _, _, _, _] = *q_dot;
    // Values.
    // u_P1 = q_P1'
    let u_P1_value = q_P1_dot;
    [u_P1_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 0 operations.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 5],
    _q_dot: &[S; 5],
    v_dot: &[S; 5],
) -> [S; 1] {
    let [q_P1_ddot, _, _, _, _] = *v_dot;
    // Values.
    // u_P1' = q_P1''
    let u_P1_dot_value = q_P1_ddot;
    [u_P1_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 392 operations, 5 sines and cosines.
#[must_use]
pub fn motion_variables<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 1]) -> [S; 5] {
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

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 274 operations, 5 sines and cosines.
#[must_use]
pub fn divisors<S: Scalar>(p: &Parameters<S>, q: &[S; 5], _q_dot: &[S; 5]) -> [S; 1] {
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
/// 128 operations, 5 sines and cosines.
#[must_use]
pub fn constraints<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> [S; 8] {
    let Parameters { l, .. } = *p;
    let [q_P1, q_P2, q_P3, q_P4, q_P5] = *q;
    let [q_P1_dot, q_P2_dot, q_P3_dot, q_P4_dot, q_P5_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q_P5, cos_q_P5) = q_P5.sin_cos();
    let (sin_q_P4, cos_q_P4) = q_P4.sin_cos();
    let (sin_q_P3, cos_q_P3) = q_P3.sin_cos();
    let (sin_q_P2, cos_q_P2) = q_P2.sin_cos();
    let (sin_q_P1, cos_q_P1) = q_P1.sin_cos();
    // Shared terms.
    // sin(q_P5) - 1
    let residual1_of_q_p5 = sin_q_P5 - S::int(1);
    let residual1_of_q_p4_q_p5 = residual1_of_q_p5 * sin_q_P4;
    // residual1_of_q_p4_q_p5 - 1
    let residual1_of_q_p4_q_p5_2 = residual1_of_q_p4_q_p5 - S::int(1);
    // residual1_of_q_p4_q_p5_2*sin(q_P3) - cos(q_P3)*cos(q_P5)
    let residual1_of_place = (-cos_q_P3)
        .mul_add(cos_q_P5, residual1_of_q_p4_q_p5_2 * sin_q_P3);
    // -1 - residual1_of_place
    let residual1_of_place_2 = -S::int(1) - residual1_of_place;
    let residual1_of_q_p4_q_p5_3 = residual1_of_q_p5 * cos_q_P4;
    // 1 + residual1_of_place_2*sin(q_P2) + residual1_of_q_p4_q_p5_3*cos(q_P2)
    let residual1_of_place_3 = residual1_of_place_2.mul_add(sin_q_P2, S::int(1))
        + residual1_of_q_p4_q_p5_3 * cos_q_P2;
    // sin(q_P3)*cos(q_P5) + residual1_of_q_p4_q_p5_2*cos(q_P3)
    let residual1_of_place_4 = residual1_of_q_p4_q_p5_2
        .mul_add(cos_q_P3, sin_q_P3 * cos_q_P5);
    let sin_q_p4_cos_q_p5 = sin_q_P4 * cos_q_P5;
    let sin_q_p3_sin_q_p5 = sin_q_P3 * sin_q_P5;
    // cos(q_P3)*sin(q_P5) + sin_q_p4_cos_q_p5*sin(q_P3)
    let residual4_of_place = sin_q_p4_cos_q_p5.mul_add(sin_q_P3, cos_q_P3 * sin_q_P5);
    let cos_q_p4_cos_q_p5 = cos_q_P4 * cos_q_P5;
    // q_P2' + q_P4'*sin(q_P3)
    let residual5_of_motion = q_P4_dot.mul_add(sin_q_P3, q_P2_dot);
    // q_P3'*residual1_of_place_4 + q_P5'*residual4_of_place +
    //   residual1_of_q_p5*residual5_of_motion*cos(q_P4)
    let residual5_of_motion_2 = q_P5_dot
        .mul_add(residual4_of_place, q_P3_dot * residual1_of_place_4)
        + residual1_of_q_p5 * residual5_of_motion * cos_q_P4;
    // q_P2'*residual1_of_place_2 - q_P4'*residual1_of_q_p4_q_p5 + q_P5'*cos_q_p4_cos_q_p5
    let residual5_of_motion_3 = (-q_P4_dot)
        .mul_add(residual1_of_q_p4_q_p5, q_P2_dot * residual1_of_place_2)
        + q_P5_dot * cos_q_p4_cos_q_p5;
    // q_P1'*residual1_of_place_4 + residual5_of_motion_2*sin(q_P2) - residual5_of_motion_3*cos(q_P2)
    let residual5_of_motion_4 = residual5_of_motion_2
        .mul_add(sin_q_P2, q_P1_dot * residual1_of_place_4) - residual5_of_motion_3 * cos_q_P2;
    // q_P3'*residual1_of_place - q_P1'*residual1_of_place_3 - cos(q_P3)*(q_P4'*residual1_of_q_p4_q_p5_3 +
    //   q_P5'*sin_q_p4_cos_q_p5) + q_P5'*sin_q_p3_sin_q_p5
    let residual5_of_motion_5 = q_P3_dot * residual1_of_place - q_P1_dot * residual1_of_place_3
        - cos_q_P3 * q_P5_dot.mul_add(sin_q_p4_cos_q_p5, q_P4_dot * residual1_of_q_p4_q_p5_3)
        + q_P5_dot * sin_q_p3_sin_q_p5;
    // q_P1'*sin(q_P2) + q_P3'
    let residual8_of_motion = q_P1_dot.mul_add(sin_q_P2, q_P3_dot);
    let q_p5_dot_sin_q_p4 = q_P5_dot * sin_q_P4;
    // Values.
    // P6_1 = l*(cos(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))) - sin(q_P1)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)))
    let residual1 = l * (-residual1_of_place_4).mul_add(sin_q_P1, residual1_of_place_3 * cos_q_P1);
    // P6_2 = -l*(sin(q_P2)*cos(q_P4)*(1 - sin(q_P5)) + cos(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))))
    let residual2 = l
        * (-residual1_of_place_2).mul_add(cos_q_P2, residual1_of_q_p4_q_p5_3 * sin_q_P2);
    // P6_3 = -l*(1 + sin(q_P1)*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) -
    //   1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))) + cos(q_P1)*(sin(q_P3)*cos(q_P5) +
    //   cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)))
    let residual3 = -l
        * (residual1_of_place_3.mul_add(sin_q_P1, S::int(1)) + residual1_of_place_4 * cos_q_P1);
    // P6_turn13 = cos(q_P1)*(sin(q_P3)*sin(q_P5) - cos(q_P3)*sin(q_P4)*cos(q_P5)) +
    //   sin(q_P1)*(sin(q_P2)*(cos(q_P3)*sin(q_P5) + sin(q_P3)*sin(q_P4)*cos(q_P5)) -
    //   cos(q_P2)*cos(q_P4)*cos(q_P5))
    let residual4 = cos_q_P1 * (-sin_q_p4_cos_q_p5).mul_add(cos_q_P3, sin_q_p3_sin_q_p5)
        + sin_q_P1 * (-cos_q_p4_cos_q_p5).mul_add(cos_q_P2, residual4_of_place * sin_q_P2);
    // P6_1' = -l*(cos(q_P1)*(q_P1'*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) +
    //   sin(q_P2)*(q_P3'*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) +
    //   cos(q_P4)*(q_P2'*(sin(q_P5) - 1) + q_P4'*sin(q_P3)*(sin(q_P5) - 1)) + q_P5'*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))) - cos(q_P2)*(q_P2'*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))) + q_P4'*sin(q_P4)*(1 - sin(q_P5)) + q_P5'*cos(q_P4)*cos(q_P5))) +
    //   sin(q_P1)*(q_P1'*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) + sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 +
    //   sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))) - q_P5'*sin(q_P3)*sin(q_P5) + q_P3'*(cos(q_P3)*cos(q_P5)
    //   + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))) + cos(q_P3)*(q_P4'*cos(q_P4)*(sin(q_P5) - 1) +
    //   q_P5'*sin(q_P4)*cos(q_P5))))
    let residual5 = l
        * (-residual5_of_motion_4).mul_add(cos_q_P1, residual5_of_motion_5 * sin_q_P1);
    // P6_2' = l*(cos(q_P2)*(q_P3'*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) +
    //   cos(q_P4)*(q_P2'*(sin(q_P5) - 1) + q_P4'*sin(q_P3)*(sin(q_P5) - 1)) + q_P5'*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))) + sin(q_P2)*(q_P2'*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))) + q_P4'*sin(q_P4)*(1 - sin(q_P5)) + q_P5'*cos(q_P4)*cos(q_P5)))
    let residual6 = l * residual5_of_motion_3.mul_add(sin_q_P2, residual5_of_motion_2 * cos_q_P2);
    // P6_3' = l*(sin(q_P1)*(q_P1'*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) +
    //   sin(q_P2)*(q_P3'*(sin(q_P3)*cos(q_P5) + cos(q_P3)*(sin(q_P4)*(sin(q_P5) - 1) - 1)) +
    //   cos(q_P4)*(q_P2'*(sin(q_P5) - 1) + q_P4'*sin(q_P3)*(sin(q_P5) - 1)) + q_P5'*(cos(q_P3)*sin(q_P5) +
    //   sin(q_P3)*sin(q_P4)*cos(q_P5))) - cos(q_P2)*(q_P2'*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 -
    //   sin(q_P4)*(sin(q_P5) - 1))) + q_P4'*sin(q_P4)*(1 - sin(q_P5)) + q_P5'*cos(q_P4)*cos(q_P5))) +
    //   cos(q_P1)*(q_P5'*sin(q_P3)*sin(q_P5) - q_P1'*(1 + cos(q_P2)*cos(q_P4)*(sin(q_P5) - 1) +
    //   sin(q_P2)*(cos(q_P3)*cos(q_P5) - 1 + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1)))) -
    //   q_P3'*(cos(q_P3)*cos(q_P5) + sin(q_P3)*(1 - sin(q_P4)*(sin(q_P5) - 1))) -
    //   cos(q_P3)*(q_P4'*cos(q_P4)*(sin(q_P5) - 1) + q_P5'*sin(q_P4)*cos(q_P5))))
    let residual7 = l * residual5_of_motion_5.mul_add(cos_q_P1, residual5_of_motion_4 * sin_q_P1);
    // P6_turn13' = cos(q_P5)*(sin(q_P1)*(sin(q_P4)*(q_P1'*cos(q_P3) + cos(q_P2)*(q_P2'*sin(q_P3) + q_P4'))
    //   + sin(q_P2)*(cos(q_P4)*(q_P2' + q_P4'*sin(q_P3)) + cos(q_P3)*(q_P3'*sin(q_P4) + q_P5'))) +
    //   cos(q_P1)*(sin(q_P3)*(sin(q_P4)*(q_P1'*sin(q_P2) + q_P3') + q_P5') - cos(q_P4)*(q_P1'*cos(q_P2) +
    //   q_P4'*cos(q_P3)))) + sin(q_P5)*(cos(q_P1)*cos(q_P3)*(q_P1'*sin(q_P2) + q_P3' + q_P5'*sin(q_P4)) -
    //   sin(q_P1)*(sin(q_P3)*(q_P1' + sin(q_P2)*(q_P3' + q_P5'*sin(q_P4))) - cos(q_P2)*(q_P2'*cos(q_P3) +
    //   q_P5'*cos(q_P4))))
    let residual8 = cos_q_P5
        * (sin_q_P1
            * (sin_q_P4 * (cos_q_P2 * q_P2_dot.mul_add(sin_q_P3, q_P4_dot) + q_P1_dot * cos_q_P3)
                + sin_q_P2
                    * (cos_q_P3 * q_P3_dot.mul_add(sin_q_P4, q_P5_dot)
                        + residual5_of_motion * cos_q_P4))
            + cos_q_P1
                * (sin_q_P3 * residual8_of_motion.mul_add(sin_q_P4, q_P5_dot)
                    - cos_q_P4 * q_P4_dot.mul_add(cos_q_P3, q_P1_dot * cos_q_P2)))
        + sin_q_P5
            * (cos_q_P1 * cos_q_P3 * (residual8_of_motion + q_p5_dot_sin_q_p4)
                + sin_q_P1
                    * (cos_q_P2 * q_P5_dot.mul_add(cos_q_P4, q_P2_dot * cos_q_P3)
                        - sin_q_P3 * (q_P1_dot + sin_q_P2 * (q_P3_dot + q_p5_dot_sin_q_p4))));
    [
        residual1, residual2, residual3, residual4, residual5, residual6, residual7, residual8,
    ]
}

/// Slopes of the constraints, one after the other, along q_P1, q_P2, q_P3, q_P4, q_P5, q_P1', q_P2', q_P3', q_P4', q_P5'.
///
/// 389 operations, 5 sines and cosines.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 80] {
    let Parameters { l, .. } = *p;
    let [q_P1, q_P2, q_P3, q_P4, q_P5] = *q;
    let [q_P1_dot, q_P2_dot, q_P3_dot, q_P4_dot, q_P5_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q_P5, cos_q_P5) = q_P5.sin_cos();
    let (sin_q_P4, cos_q_P4) = q_P4.sin_cos();
    let (sin_q_P3, cos_q_P3) = q_P3.sin_cos();
    let (sin_q_P2, cos_q_P2) = q_P2.sin_cos();
    let (sin_q_P1, cos_q_P1) = q_P1.sin_cos();
    // Step by step, each after the terms that it needs.
    let residual1_by_q_P1_of_q_p5 = sin_q_P5 - S::int(1);
    let residual1_by_q_P1_of_q_p4_q_p5 = residual1_by_q_P1_of_q_p5 * sin_q_P4;
    let residual1_by_q_P1_of_q_p4_q_p5_2 = residual1_by_q_P1_of_q_p4_q_p5 - S::int(1);
    let cos_q_p3_cos_q_p5 = cos_q_P3 * cos_q_P5;
    let residual1_by_q_P1_of_place = residual1_by_q_P1_of_q_p4_q_p5_2
        .mul_add(sin_q_P3, -cos_q_p3_cos_q_p5);
    let residual1_by_q_P1_of_place_2 = -S::int(1) - residual1_by_q_P1_of_place;
    let residual1_by_q_P1_of_q_p4_q_p5_3 = residual1_by_q_P1_of_q_p5 * cos_q_P4;
    let residual1_by_q_P1_of_place_3 = residual1_by_q_P1_of_q_p4_q_p5_3 * cos_q_P2;
    let residual1_by_q_P1_of_place_4 = residual1_by_q_P1_of_place_2
        .mul_add(sin_q_P2, residual1_by_q_P1_of_place_3);
    let residual1_by_q_P1_of_place_5 = S::int(1) + residual1_by_q_P1_of_place_4;
    let sin_q_p3_cos_q_p5 = sin_q_P3 * cos_q_P5;
    let residual1_by_q_P1_of_place_6 = residual1_by_q_P1_of_q_p4_q_p5_2
        .mul_add(cos_q_P3, sin_q_p3_cos_q_p5);
    let residual1_by_q_P1_of_place_7 = residual1_by_q_P1_of_place_6 * cos_q_P1;
    let residual1_by_q_P1_of_place_8 = l
        * residual1_by_q_P1_of_place_5.mul_add(sin_q_P1, residual1_by_q_P1_of_place_7);
    let residual1_by_q_P2_of_place = (-residual1_by_q_P1_of_q_p4_q_p5_3)
        .mul_add(sin_q_P2, residual1_by_q_P1_of_place_2 * cos_q_P2);
    let residual1_by_q_P2_of_place_2 = l * residual1_by_q_P2_of_place;
    let residual1_by_q_P2_of_place_3 = residual1_by_q_P2_of_place_2 * cos_q_P1;
    let residual1_by_q_P3_of_place = -residual1_by_q_P1_of_place;
    let residual1_by_q_P3_of_place_2 = l
        * residual1_by_q_P3_of_place
            .mul_add(sin_q_P1, residual1_by_q_P1_of_place_7 * sin_q_P2);
    let sin_q_p2_sin_q_p3 = sin_q_P2 * sin_q_P3;
    let residual1_by_q_P4_of_place = residual1_by_q_P1_of_q_p4_q_p5_3
        .mul_add(sin_q_p2_sin_q_p3, residual1_by_q_P1_of_q_p4_q_p5 * cos_q_P2);
    let cos_q_p3_sin_q_p1 = sin_q_P1 * cos_q_P3;
    let residual1_by_q_P4_of_place_2 = l
        * residual1_by_q_P1_of_q_p4_q_p5_3
            .mul_add(cos_q_p3_sin_q_p1, residual1_by_q_P4_of_place * cos_q_P1);
    let sin_q_p3_sin_q_p5 = sin_q_P3 * sin_q_P5;
    let residual1_by_q_P5_of_place = cos_q_p3_cos_q_p5
        .mul_add(sin_q_P4, -sin_q_p3_sin_q_p5);
    let cos_q_p3_sin_q_p5 = cos_q_P3 * sin_q_P5;
    let residual1_by_q_P5_of_place_2 = sin_q_p3_cos_q_p5
        .mul_add(sin_q_P4, cos_q_p3_sin_q_p5);
    let cos_q_p2_cos_q_p4 = cos_q_P2 * cos_q_P4;
    let residual1_by_q_P5_of_place_3 = (-residual1_by_q_P5_of_place_2)
        .mul_add(sin_q_P2, cos_q_p2_cos_q_p4 * cos_q_P5);
    let residual1_by_q_P5_of_place_4 = (-residual1_by_q_P5_of_place_3)
        .mul_add(cos_q_P1, residual1_by_q_P5_of_place * sin_q_P1);
    let residual1_by_q_P5_of_place_5 = l * residual1_by_q_P5_of_place_4;
    let residual2_by_q_P2_of_place = l * residual1_by_q_P1_of_place_4;
    let residual2_by_q_P3_of_place = residual1_by_q_P1_of_place_6 * cos_q_P2;
    let residual2_by_q_P3_of_place_2 = l * residual2_by_q_P3_of_place;
    let residual2_by_q_P4_of_place = l
        * (-residual1_by_q_P1_of_q_p4_q_p5)
            .mul_add(sin_q_P2, residual1_by_q_P1_of_place_3 * sin_q_P3);
    let residual2_by_q_P5_of_place = residual1_by_q_P5_of_place_2
        .mul_add(cos_q_P2, sin_q_P2 * cos_q_P4 * cos_q_P5);
    let residual2_by_q_P5_of_place_2 = l * residual2_by_q_P5_of_place;
    let residual3_by_q_P1_of_place = l
        * (-residual1_by_q_P1_of_place_6)
            .mul_add(sin_q_P1, residual1_by_q_P1_of_place_5 * cos_q_P1);
    let residual3_by_q_P2_of_place = residual1_by_q_P2_of_place_2 * sin_q_P1;
    let sin_q_p2_sin_q_p1 = sin_q_P1 * sin_q_P2;
    let residual3_by_q_P3_of_place = l
        * (-residual1_by_q_P3_of_place)
            .mul_add(cos_q_P1, residual1_by_q_P1_of_place_6 * sin_q_p2_sin_q_p1);
    let cos_q_p3_cos_q_p1 = cos_q_P1 * cos_q_P3;
    let residual3_by_q_P4_of_place = l
        * (-residual1_by_q_P1_of_q_p4_q_p5_3)
            .mul_add(cos_q_p3_cos_q_p1, residual1_by_q_P4_of_place * sin_q_P1);
    let residual3_by_q_P5_of_place = l
        * residual1_by_q_P5_of_place_3
            .mul_add(sin_q_P1, residual1_by_q_P5_of_place * cos_q_P1);
    let residual4_by_q_P2_of_place = residual2_by_q_P5_of_place * sin_q_P1;
    let residual4_by_q_P3_of_place = residual1_by_q_P5_of_place
        .mul_add(sin_q_p2_sin_q_p1, residual1_by_q_P5_of_place_2 * cos_q_P1);
    let residual4_by_q_P4_of_place = (-sin_q_p2_sin_q_p1)
        .mul_add(sin_q_P3, cos_q_p3_cos_q_p1);
    let cos_q_p2_sin_q_p1 = sin_q_P1 * cos_q_P2;
    let residual4_by_q_P4_of_place_2 = (-cos_q_p2_sin_q_p1)
        .mul_add(sin_q_P4, residual4_by_q_P4_of_place * cos_q_P4);
    let residual5_by_q_P1_of_motion = q_P4_dot.mul_add(sin_q_P3, q_P2_dot);
    let residual5_by_q_P1_of_motion_2 = residual1_by_q_P1_of_q_p5 * residual5_by_q_P1_of_motion;
    let residual5_by_q_P1_of_motion_3 = q_P5_dot
        .mul_add(residual1_by_q_P5_of_place_2, q_P3_dot * residual1_by_q_P1_of_place_6)
        + residual5_by_q_P1_of_motion_2 * cos_q_P4;
    let q_p5_dot_cos_q_p5 = q_P5_dot * cos_q_P5;
    let residual5_by_q_P1_of_motion_4 = (-q_P4_dot)
        .mul_add(residual1_by_q_P1_of_q_p4_q_p5, q_P2_dot * residual1_by_q_P1_of_place_2)
        + q_p5_dot_cos_q_p5 * cos_q_P4;
    let residual5_by_q_P1_of_motion_5 = (-residual5_by_q_P1_of_motion_4)
        .mul_add(cos_q_P2, residual5_by_q_P1_of_motion_3 * sin_q_P2);
    let residual5_by_q_P1_of_motion_6 = q_P1_dot
        .mul_add(residual1_by_q_P1_of_place_6, residual5_by_q_P1_of_motion_5);
    let residual5_by_q_P1_of_q_p5_dot = q_p5_dot_cos_q_p5 * sin_q_P4;
    let residual5_by_q_P1_of_motion_7 = q_P4_dot
        .mul_add(residual1_by_q_P1_of_q_p4_q_p5_3, residual5_by_q_P1_of_q_p5_dot);
    let residual5_by_q_P1_of_q_p3_dot = q_P3_dot * residual1_by_q_P3_of_place;
    let residual5_by_q_P1_of_motion_8 = (-q_P1_dot)
        .mul_add(residual1_by_q_P1_of_place_5, q_P5_dot * sin_q_p3_sin_q_p5)
        - residual5_by_q_P1_of_motion_7 * cos_q_P3 - residual5_by_q_P1_of_q_p3_dot;
    let residual5_by_q_P2_of_motion = residual5_by_q_P1_of_motion_4
        .mul_add(sin_q_P2, residual5_by_q_P1_of_motion_3 * cos_q_P2);
    let q_p4_dot_cos_q_p3 = q_P4_dot * cos_q_P3;
    let residual5_by_q_P3_of_motion = q_P5_dot
        .mul_add(residual1_by_q_P5_of_place, residual5_by_q_P1_of_q_p3_dot)
        + residual1_by_q_P1_of_q_p4_q_p5_3 * q_p4_dot_cos_q_p3;
    let residual5_by_q_P3_of_motion_2 = q_P2_dot
        .mul_add(residual2_by_q_P3_of_place, q_P1_dot * residual1_by_q_P3_of_place)
        + residual5_by_q_P3_of_motion * sin_q_P2;
    let residual5_by_q_P3_of_motion_3 = q_P1_dot.mul_add(sin_q_P2, q_P3_dot);
    let residual5_by_q_P3_of_motion_4 = residual5_by_q_P1_of_motion_7
        .mul_add(sin_q_P3, q_P5_dot * cos_q_p3_sin_q_p5)
        + residual1_by_q_P1_of_place_6 * residual5_by_q_P3_of_motion_3;
    let residual5_by_q_P4_of_motion = q_P2_dot.mul_add(sin_q_P3, q_P4_dot);
    let residual5_by_q_P4_of_motion_2 = residual1_by_q_P1_of_q_p5 * residual5_by_q_P4_of_motion;
    let residual5_by_q_P4_of_motion_3 = q_P3_dot.mul_add(sin_q_P2, q_P1_dot);
    let residual5_by_q_P4_of_motion_4 = residual5_by_q_P4_of_motion_2
        .mul_add(cos_q_P2, sin_q_p2_sin_q_p3 * q_p5_dot_cos_q_p5)
        + residual1_by_q_P1_of_q_p5 * residual5_by_q_P4_of_motion_3 * cos_q_P3;
    let residual5_by_q_P4_of_motion_5 = (-(residual1_by_q_P1_of_q_p5
        * residual5_by_q_P3_of_motion_3))
        .mul_add(sin_q_P3, q_p5_dot_cos_q_p5 * cos_q_P3);
    let residual5_by_q_P4_of_motion_6 = (-q_p5_dot_cos_q_p5)
        .mul_add(cos_q_P2, residual5_by_q_P1_of_motion_2 * sin_q_P2);
    let residual5_by_q_P4_of_motion_7 = q_P1_dot.mul_add(cos_q_P2, q_p4_dot_cos_q_p3);
    let residual5_by_q_P4_of_motion_8 = residual1_by_q_P1_of_q_p5 * residual5_by_q_P4_of_motion_7;
    let residual5_by_q_P5_of_motion = q_P3_dot.mul_add(sin_q_P4, q_P5_dot);
    let residual5_by_q_P5_of_motion_2 = residual5_by_q_P5_of_motion
        .mul_add(cos_q_P3, residual5_by_q_P1_of_motion * cos_q_P4);
    let residual5_by_q_P5_of_motion_3 = residual5_by_q_P4_of_motion * cos_q_P2;
    let residual5_by_q_P5_of_motion_4 = sin_q_P4
        * q_P1_dot.mul_add(cos_q_P3, residual5_by_q_P5_of_motion_3)
        + residual5_by_q_P5_of_motion_2 * sin_q_P2;
    let residual5_by_q_P5_of_motion_5 = sin_q_P3
        * residual5_by_q_P3_of_motion_3.mul_add(sin_q_P4, q_P5_dot)
        - residual5_by_q_P4_of_motion_7 * cos_q_P4;
    let q_p5_dot_sin_q_p4 = q_P5_dot * sin_q_P4;
    let residual5_by_q_P5_of_motion_6 = q_P3_dot + q_p5_dot_sin_q_p4;
    let residual5_by_q_P5_of_motion_7 = residual5_by_q_P5_of_motion_6
        .mul_add(sin_q_P2, q_P1_dot);
    let q_p5_dot_cos_q_p4 = q_P5_dot * cos_q_P4;
    let residual5_by_q_P5_of_motion_8 = -cos_q_P2 * q_P2_dot.mul_add(cos_q_P3, q_p5_dot_cos_q_p4)
        + residual5_by_q_P5_of_motion_7 * sin_q_P3;
    let residual5_by_q_P5_of_motion_9 = residual5_by_q_P3_of_motion_3 + q_p5_dot_sin_q_p4;
    let residual5_by_q_P5_of_motion_10 = cos_q_P5
        * (-residual5_by_q_P5_of_motion_5)
            .mul_add(sin_q_P1, residual5_by_q_P5_of_motion_4 * cos_q_P1)
        - sin_q_P5
            * cos_q_p3_sin_q_p1
                .mul_add(
                    residual5_by_q_P5_of_motion_9,
                    residual5_by_q_P5_of_motion_8 * cos_q_P1,
                );
    let residual6_by_q_P5_of_motion = cos_q_P2
        * (-sin_q_p3_sin_q_p5)
            .mul_add(
                residual5_by_q_P5_of_motion_6,
                residual5_by_q_P5_of_motion_2 * cos_q_P5,
            )
        - sin_q_P2
            * (q_P2_dot
                .mul_add(residual1_by_q_P5_of_place_2, q_P4_dot * sin_q_P4 * cos_q_P5)
                + q_p5_dot_cos_q_p4 * sin_q_P5);
    let q_p1_dot_cos_q_p1 = q_P1_dot * cos_q_P1;
    let residual7_by_q_P5_of_motion = residual5_by_q_P5_of_motion_5
        .mul_add(cos_q_P1, residual5_by_q_P5_of_motion_4 * sin_q_P1);
    let residual7_by_q_P5_of_motion_2 = (-cos_q_p3_cos_q_p1)
        .mul_add(
            residual5_by_q_P5_of_motion_9,
            residual5_by_q_P5_of_motion_8 * sin_q_P1,
        );
    let residual8_by_q_P3_of_motion = residual5_by_q_P3_of_motion_3 * cos_q_P1;
    let residual8_by_q_P3_of_q_p2_dot = q_P2_dot * cos_q_p2_sin_q_p1;
    let q_p4_dot_cos_q_p4 = q_P4_dot * cos_q_P4;
    let residual8_by_q_P1_dot_of_place = sin_q_p2_sin_q_p3
        .mul_add(sin_q_P4, -cos_q_p2_cos_q_p4);
    let residual1_by_q_P1_of_place_9 = -residual1_by_q_P1_of_place_8;
    let residual1_by_q_P3_of_place_3 = -residual1_by_q_P3_of_place_2;
    let residual1_by_q_P4_of_place_3 = -residual1_by_q_P4_of_place_2;
    let residual1_by_q_P5_of_place_6 = -residual1_by_q_P5_of_place_5;
    let residual3_by_q_P1_of_place_2 = -residual3_by_q_P1_of_place;
    let residual3_by_q_P2_of_place_2 = -residual3_by_q_P2_of_place;
    let residual3_by_q_P5_of_place_2 = -residual3_by_q_P5_of_place;
    // Values.
    let residual1_by_q_P1 = residual1_by_q_P1_of_place_9;
    let residual1_by_q_P2 = residual1_by_q_P2_of_place_3;
    let residual1_by_q_P3 = residual1_by_q_P3_of_place_3;
    let residual1_by_q_P4 = residual1_by_q_P4_of_place_3;
    let residual1_by_q_P5 = residual1_by_q_P5_of_place_6;
    let residual2_by_q_P2 = residual2_by_q_P2_of_place;
    let residual2_by_q_P3 = residual2_by_q_P3_of_place_2;
    let residual2_by_q_P4 = residual2_by_q_P4_of_place;
    let residual2_by_q_P5 = residual2_by_q_P5_of_place_2;
    let residual3_by_q_P1 = residual3_by_q_P1_of_place_2;
    let residual3_by_q_P2 = residual3_by_q_P2_of_place_2;
    let residual3_by_q_P3 = residual3_by_q_P3_of_place;
    let residual3_by_q_P4 = residual3_by_q_P4_of_place;
    let residual3_by_q_P5 = residual3_by_q_P5_of_place_2;
    let residual4_by_q_P1 = residual1_by_q_P5_of_place_4;
    let residual4_by_q_P2 = residual4_by_q_P2_of_place;
    let residual4_by_q_P3 = residual4_by_q_P3_of_place;
    let residual4_by_q_P4 = -residual4_by_q_P4_of_place_2 * cos_q_P5;
    let residual4_by_q_P5 = cos_q_P1 * cos_q_p3_sin_q_p5.mul_add(sin_q_P4, sin_q_p3_cos_q_p5)
        + sin_q_P1
            * (sin_q_P2 * (-sin_q_p3_sin_q_p5).mul_add(sin_q_P4, cos_q_p3_cos_q_p5)
                + cos_q_p2_cos_q_p4 * sin_q_P5);
    let residual5_by_q_P1 = l
        * residual5_by_q_P1_of_motion_8
            .mul_add(cos_q_P1, residual5_by_q_P1_of_motion_6 * sin_q_P1);
    let residual5_by_q_P2 = -l
        * residual5_by_q_P2_of_motion
            .mul_add(cos_q_P1, q_P1_dot * residual1_by_q_P2_of_place * sin_q_P1);
    let residual5_by_q_P3 = l
        * (-residual5_by_q_P3_of_motion_2)
            .mul_add(cos_q_P1, residual5_by_q_P3_of_motion_4 * sin_q_P1);
    let residual5_by_q_P4 = l
        * (sin_q_P4
            * residual5_by_q_P4_of_motion_8
                .mul_add(sin_q_P1, residual5_by_q_P4_of_motion_6 * cos_q_P1)
            - cos_q_P4
                * residual5_by_q_P4_of_motion_5
                    .mul_add(sin_q_P1, residual5_by_q_P4_of_motion_4 * cos_q_P1));
    let residual5_by_q_P5 = -l * residual5_by_q_P5_of_motion_10;
    let residual5_by_q_P1_dot = residual1_by_q_P1_of_place_9;
    let residual5_by_q_P2_dot = residual1_by_q_P2_of_place_3;
    let residual5_by_q_P3_dot = residual1_by_q_P3_of_place_3;
    let residual5_by_q_P4_dot = residual1_by_q_P4_of_place_3;
    let residual5_by_q_P5_dot = residual1_by_q_P5_of_place_6;
    let residual6_by_q_P2 = -l * residual5_by_q_P1_of_motion_5;
    let residual6_by_q_P3 = l
        * (-(q_P2_dot * residual1_by_q_P1_of_place_6))
            .mul_add(sin_q_P2, residual5_by_q_P3_of_motion * cos_q_P2);
    let residual6_by_q_P4 = -l
        * (cos_q_P2
            * (-cos_q_P4
                * q_p5_dot_cos_q_p5
                    .mul_add(sin_q_P3, q_P3_dot * residual1_by_q_P1_of_q_p5 * cos_q_P3)
                + residual5_by_q_P1_of_motion_2 * sin_q_P4)
            + sin_q_P2
                * residual5_by_q_P4_of_motion_2
                    .mul_add(cos_q_P4, residual5_by_q_P1_of_q_p5_dot));
    let residual6_by_q_P5 = l * residual6_by_q_P5_of_motion;
    let residual6_by_q_P2_dot = residual2_by_q_P2_of_place;
    let residual6_by_q_P3_dot = residual2_by_q_P3_of_place_2;
    let residual6_by_q_P4_dot = residual2_by_q_P4_of_place;
    let residual6_by_q_P5_dot = residual2_by_q_P5_of_place_2;
    let residual7_by_q_P1 = l
        * (-residual5_by_q_P1_of_motion_8)
            .mul_add(sin_q_P1, residual5_by_q_P1_of_motion_6 * cos_q_P1);
    let residual7_by_q_P2 = l
        * (-residual1_by_q_P2_of_place)
            .mul_add(q_p1_dot_cos_q_p1, residual5_by_q_P2_of_motion * sin_q_P1);
    let residual7_by_q_P3 = l
        * residual5_by_q_P3_of_motion_4
            .mul_add(cos_q_P1, residual5_by_q_P3_of_motion_2 * sin_q_P1);
    let residual7_by_q_P4 = l
        * (cos_q_P4
            * (-residual5_by_q_P4_of_motion_5)
                .mul_add(cos_q_P1, residual5_by_q_P4_of_motion_4 * sin_q_P1)
            + sin_q_P4
                * (-residual5_by_q_P4_of_motion_6)
                    .mul_add(sin_q_P1, residual5_by_q_P4_of_motion_8 * cos_q_P1));
    let residual7_by_q_P5 = l
        * (-residual7_by_q_P5_of_motion_2)
            .mul_add(sin_q_P5, residual7_by_q_P5_of_motion * cos_q_P5);
    let residual7_by_q_P1_dot = residual3_by_q_P1_of_place_2;
    let residual7_by_q_P2_dot = residual3_by_q_P2_of_place_2;
    let residual7_by_q_P3_dot = residual3_by_q_P3_of_place;
    let residual7_by_q_P4_dot = residual3_by_q_P4_of_place;
    let residual7_by_q_P5_dot = residual3_by_q_P5_of_place_2;
    let residual8_by_q_P1 = residual5_by_q_P5_of_motion_10;
    let residual8_by_q_P2 = residual2_by_q_P5_of_place
        .mul_add(q_p1_dot_cos_q_p1, residual6_by_q_P5_of_motion * sin_q_P1);
    let residual8_by_q_P3 = cos_q_P5
        * (cos_q_P3
            * (sin_q_P4 * (residual8_by_q_P3_of_motion + residual8_by_q_P3_of_q_p2_dot)
                + q_P5_dot * cos_q_P1 + sin_q_p2_sin_q_p1 * q_p4_dot_cos_q_p4)
            + sin_q_P3
                * (-sin_q_P1 * residual5_by_q_P5_of_motion.mul_add(sin_q_P2, q_P1_dot * sin_q_P4)
                    + q_p4_dot_cos_q_p4 * cos_q_P1))
        - sin_q_P5
            * (sin_q_P3
                * residual5_by_q_P5_of_motion_9
                    .mul_add(cos_q_P1, residual8_by_q_P3_of_q_p2_dot)
                + cos_q_p3_sin_q_p1 * residual5_by_q_P5_of_motion_7);
    let residual8_by_q_P4 = cos_q_P5
        * (sin_q_P4
            * ((-q_P2_dot)
                .mul_add(sin_q_p2_sin_q_p1, q_P4_dot * residual4_by_q_P4_of_place)
                + q_p1_dot_cos_q_p1 * cos_q_P2)
            + cos_q_P4
                * (sin_q_P1
                    * residual5_by_q_P4_of_motion_3
                        .mul_add(cos_q_P3, residual5_by_q_P5_of_motion_3)
                    + residual8_by_q_P3_of_motion * sin_q_P3))
        + q_P5_dot * residual4_by_q_P4_of_place_2 * sin_q_P5;
    let residual8_by_q_P5 = (-residual7_by_q_P5_of_motion_2)
        .mul_add(cos_q_P5, -residual7_by_q_P5_of_motion * sin_q_P5);
    let residual8_by_q_P1_dot = sin_q_P5
        * (-sin_q_P1).mul_add(sin_q_P3, cos_q_p3_cos_q_p1 * sin_q_P2)
        + cos_q_P5
            * residual8_by_q_P1_dot_of_place
                .mul_add(cos_q_P1, cos_q_p3_sin_q_p1 * sin_q_P4);
    let residual8_by_q_P2_dot = residual4_by_q_P2_of_place;
    let residual8_by_q_P3_dot = residual4_by_q_P3_of_place;
    let residual8_by_q_P4_dot = cos_q_P5
        * (sin_q_P1 * sin_q_p2_sin_q_p3.mul_add(cos_q_P4, cos_q_P2 * sin_q_P4)
            - cos_q_p3_cos_q_p1 * cos_q_P4);
    let residual8_by_q_P5_dot = cos_q_P5 * sin_q_p2_sin_q_p1.mul_add(cos_q_P3, cos_q_P1 * sin_q_P3)
        + sin_q_P5
            * (-residual8_by_q_P1_dot_of_place)
                .mul_add(sin_q_P1, cos_q_p3_cos_q_p1 * sin_q_P4);
    let zero = S::int(0);
    [
        residual1_by_q_P1, residual1_by_q_P2, residual1_by_q_P3, residual1_by_q_P4,
        residual1_by_q_P5, zero, zero, zero, zero, zero, zero, residual2_by_q_P2, residual2_by_q_P3,
        residual2_by_q_P4, residual2_by_q_P5, zero, zero, zero, zero, zero, residual3_by_q_P1,
        residual3_by_q_P2, residual3_by_q_P3, residual3_by_q_P4, residual3_by_q_P5, zero, zero,
        zero, zero, zero, residual4_by_q_P1, residual4_by_q_P2, residual4_by_q_P3,
        residual4_by_q_P4, residual4_by_q_P5, zero, zero, zero, zero, zero, residual5_by_q_P1,
        residual5_by_q_P2, residual5_by_q_P3, residual5_by_q_P4, residual5_by_q_P5,
        residual5_by_q_P1_dot, residual5_by_q_P2_dot, residual5_by_q_P3_dot, residual5_by_q_P4_dot,
        residual5_by_q_P5_dot, zero, residual6_by_q_P2, residual6_by_q_P3, residual6_by_q_P4,
        residual6_by_q_P5, zero, residual6_by_q_P2_dot, residual6_by_q_P3_dot,
        residual6_by_q_P4_dot, residual6_by_q_P5_dot, residual7_by_q_P1, residual7_by_q_P2,
        residual7_by_q_P3, residual7_by_q_P4, residual7_by_q_P5, residual7_by_q_P1_dot,
        residual7_by_q_P2_dot, residual7_by_q_P3_dot, residual7_by_q_P4_dot, residual7_by_q_P5_dot,
        residual8_by_q_P1, residual8_by_q_P2, residual8_by_q_P3, residual8_by_q_P4,
        residual8_by_q_P5, residual8_by_q_P1_dot, residual8_by_q_P2_dot, residual8_by_q_P3_dot,
        residual8_by_q_P4_dot, residual8_by_q_P5_dot,
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
            parameters: 3,
            coordinates: 5,
            variables: 5,
            speeds: 1,
            reactions: 4,
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
        8
    }
    fn constraint_name(&self, at: usize) -> &str {
        [
            "P6_1", "P6_2", "P6_3", "P6_turn13", "P6_1'", "P6_2'", "P6_3'", "P6_turn13'",
        ][at]
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
