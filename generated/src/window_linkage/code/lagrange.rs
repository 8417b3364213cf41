//! N-window four-bar: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/window_linkage/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows q, q_ground1, q_ground2, q_pin1, q_pin2, constraint close1_1, constraint close1_2, constraint close2_1, constraint close2_2.
///
/// 51 operations, 5 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _q_dot: &[S; 5],
) -> [[S; 9]; 9] {
    let Parameters { m, l, .. } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    // Sines and cosines.
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_q_pin2, cos_q_pin2) = q_pin2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    // Shared terms.
    let m_l_sq = m * l * l;
    let m_l_sq_times_5_by_3 = S::ratio(5, 3) * m_l_sq;
    let m_l_sq_by_3 = S::ratio(1, 3) * m_l_sq;
    let m_l_sq_halved = S::ratio(1, 2) * m_l_sq;
    // m_l_sq_by_3 + m_l_sq_halved*cos(q_pin1)
    let m14_of_m_l_q_pin1 = m_l_sq_halved.mul_add(cos_q_pin1, m_l_sq_by_3);
    // cos(q)*sin(q_pin1) + sin(q)*cos(q_pin1)
    let sin_q_plus_q_pin1 = sin_q.mul_add(cos_q_pin1, cos_q * sin_q_pin1);
    let l_sin_q_plus_q_pin1 = l * sin_q_plus_q_pin1;
    // l*sin(q) + l_sin_q_plus_q_pin1
    let m16_of_l_q_2_q_pin1 = l.mul_add(sin_q, l_sin_q_plus_q_pin1);
    // cos(q)*cos(q_pin1) - sin(q)*sin(q_pin1)
    let cos_q_plus_q_pin1 = (-sin_q).mul_add(sin_q_pin1, cos_q * cos_q_pin1);
    let l_cos_q_plus_q_pin1 = l * cos_q_plus_q_pin1;
    // l*cos(q) + l_cos_q_plus_q_pin1
    let m17_of_l_q_2_q_pin1 = l.mul_add(cos_q, l_cos_q_plus_q_pin1);
    // m_l_sq_by_3 + m_l_sq_halved*cos(q_pin2)
    let m25_of_m_l_q_pin2 = m_l_sq_halved.mul_add(cos_q_pin2, m_l_sq_by_3);
    let l_sin_q_ground1 = l * sin_q_ground1;
    let l_cos_q_ground1 = l * cos_q_ground1;
    // cos(q_ground1)*sin(q_pin2) + sin(q_ground1)*cos(q_pin2)
    let m28_of_place = sin_q_ground1.mul_add(cos_q_pin2, cos_q_ground1 * sin_q_pin2);
    let l_m28_of_place = l * m28_of_place;
    // l_sin_q_ground1 + l_m28_of_place
    let m28_of_place_2 = l_sin_q_ground1 + l_m28_of_place;
    // cos(q_ground1)*cos(q_pin2) - sin(q_ground1)*sin(q_pin2)
    let m29_of_place = (-sin_q_ground1).mul_add(sin_q_pin2, cos_q_ground1 * cos_q_pin2);
    let l_m29_of_place = l * m29_of_place;
    // l_cos_q_ground1 + l_m29_of_place
    let m29_of_place_2 = l_cos_q_ground1 + l_m29_of_place;
    let l_sin_q_ground2 = l * sin_q_ground2;
    let l_cos_q_ground2 = l * cos_q_ground2;
    // Entries that are not zero.
    // M11 = m*l^2*(5 + 3*cos(q_pin1))/3
    let m11 = m_l_sq.mul_add(cos_q_pin1, m_l_sq_times_5_by_3);
    // M14 = m*l^2*(2 + 3*cos(q_pin1))/6
    let m14 = m14_of_m_l_q_pin1;
    // M16 = -l*(sin(q) + sin(q + q_pin1))
    let m16 = -m16_of_l_q_2_q_pin1;
    // M17 = l*(cos(q) + cos(q + q_pin1))
    let m17 = m17_of_l_q_2_q_pin1;
    // M22 = m*l^2*(5 + 3*cos(q_pin2))/3
    let m22 = m_l_sq.mul_add(cos_q_pin2, m_l_sq_times_5_by_3);
    // M25 = m*l^2*(2 + 3*cos(q_pin2))/6
    let m25 = m25_of_m_l_q_pin2;
    // M26 = l*sin(q_ground1)
    let m26 = l_sin_q_ground1;
    // M27 = -l*cos(q_ground1)
    let m27 = -l_cos_q_ground1;
    // M28 = -l*(sin(q_ground1) + sin(q_ground1 + q_pin2))
    let m28 = -m28_of_place_2;
    // M29 = l*(cos(q_ground1) + cos(q_ground1 + q_pin2))
    let m29 = m29_of_place_2;
    // M33 = m*l^2/3
    let m33 = m_l_sq_by_3;
    // M38 = l*sin(q_ground2)
    let m38 = l_sin_q_ground2;
    // M39 = -l*cos(q_ground2)
    let m39 = -l_cos_q_ground2;
    // M41 = m*l^2*(2 + 3*cos(q_pin1))/6
    let m41 = m14_of_m_l_q_pin1;
    // M44 = m*l^2/3
    let m44 = m_l_sq_by_3;
    // M46 = -l*sin(q + q_pin1)
    let m46 = -l_sin_q_plus_q_pin1;
    // M47 = l*cos(q + q_pin1)
    let m47 = l_cos_q_plus_q_pin1;
    // M52 = m*l^2*(2 + 3*cos(q_pin2))/6
    let m52 = m25_of_m_l_q_pin2;
    // M55 = m*l^2/3
    let m55 = m_l_sq_by_3;
    // M58 = -l*sin(q_ground1 + q_pin2)
    let m58 = -l_m28_of_place;
    // M59 = l*cos(q_ground1 + q_pin2)
    let m59 = l_m29_of_place;
    // M61 = l*(sin(q) + sin(q + q_pin1))
    let m61 = m16_of_l_q_2_q_pin1;
    // M62 = -l*sin(q_ground1)
    let m62 = -l_sin_q_ground1;
    // M64 = l*sin(q + q_pin1)
    let m64 = l_sin_q_plus_q_pin1;
    // M71 = -l*(cos(q) + cos(q + q_pin1))
    let m71 = -m17_of_l_q_2_q_pin1;
    // M72 = l*cos(q_ground1)
    let m72 = l_cos_q_ground1;
    // M74 = -l*cos(q + q_pin1)
    let m74 = -l_cos_q_plus_q_pin1;
    // M82 = l*(sin(q_ground1) + sin(q_ground1 + q_pin2))
    let m82 = m28_of_place_2;
    // M83 = -l*sin(q_ground2)
    let m83 = -l_sin_q_ground2;
    // M85 = l*sin(q_ground1 + q_pin2)
    let m85 = l_m28_of_place;
    // M92 = -l*(cos(q_ground1) + cos(q_ground1 + q_pin2))
    let m92 = -m29_of_place_2;
    // M93 = l*cos(q_ground2)
    let m93 = l_cos_q_ground2;
    // M95 = -l*cos(q_ground1 + q_pin2)
    let m95 = -l_m29_of_place;
    let zero = S::int(0);
    [
        [m11, zero, zero, m14, zero, m16, m17, zero, zero],
        [zero, m22, zero, zero, m25, m26, m27, m28, m29],
        [zero, zero, m33, zero, zero, zero, zero, m38, m39],
        [m41, zero, zero, m44, zero, m46, m47, zero, zero],
        [zero, m52, zero, zero, m55, zero, zero, m58, m59],
        [m61, m62, zero, m64, zero, zero, zero, zero, zero],
        [m71, m72, zero, m74, zero, zero, zero, zero, zero],
        [zero, m82, m83, zero, m85, zero, zero, zero, zero],
        [zero, m92, m93, zero, m95, zero, zero, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (q'', q_ground1'', q_ground2'', q_pin1'', q_pin2'', lambda_close1_1, lambda_close1_2, lambda_close2_1, lambda_close2_2).
///
/// 71 operations, 5 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> [S; 9] {
    let Parameters { m, l, g } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    let [q_dot_2, q_ground1_dot, q_ground2_dot, q_pin1_dot, q_pin2_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_q_pin2, cos_q_pin2) = q_pin2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    // Shared terms.
    // sin(q)*sin(q_pin1) - cos(q)*cos(q_pin1)
    let f1_of_q_2_q_pin1 = (-cos_q).mul_add(cos_q_pin1, sin_q * sin_q_pin1);
    let m_l = m * l;
    let m_l_halved = S::ratio(1, 2) * m_l;
    let g_m_l_halved = g * m_l_halved;
    let f1_of_place = f1_of_q_2_q_pin1 * g_m_l_halved;
    // q_pin1'*(2*q' + q_pin1')
    let f1_of_motion = q_pin1_dot * q_dot_2.mul_add(S::int(2), q_pin1_dot);
    let l_sin_q_pin1 = l * sin_q_pin1;
    let m_l_halved_l_sin_q_pin1 = m_l_halved * l_sin_q_pin1;
    let g_m_l_times_3_by_2 = S::ratio(3, 2) * g * m_l;
    // q_pin2'*(2*q_ground1' + q_pin2')
    let f2_of_motion = q_pin2_dot * q_ground1_dot.mul_add(S::int(2), q_pin2_dot);
    let sin_q_pin2_m_l_halved = m_l_halved * sin_q_pin2;
    // sin(q_ground1)*sin(q_pin2) - cos(q_ground1)*cos(q_pin2)
    let f2_of_place = (-cos_q_ground1).mul_add(cos_q_pin2, sin_q_ground1 * sin_q_pin2);
    let g_m_l_halved_f2_of_place = g_m_l_halved * f2_of_place;
    let q_dot_2_sq = q_dot_2 * q_dot_2;
    let q_ground1_dot_sq = q_ground1_dot * q_ground1_dot;
    let l_q_ground1_dot_sq = l * q_ground1_dot_sq;
    let f6_of_motion = l_q_ground1_dot_sq * cos_q_ground1;
    // f1_of_motion + q_dot_2_sq
    let f6_of_motion_2 = f1_of_motion + q_dot_2_sq;
    let f7_of_motion = l_q_ground1_dot_sq * sin_q_ground1;
    // l*(f2_of_motion + q_ground1_dot_sq)
    let f8_of_motion = l * (f2_of_motion + q_ground1_dot_sq);
    let l_q_ground2_dot_sq = l * q_ground2_dot * q_ground2_dot;
    // Values.
    // f1 = m*l*(l*q_pin1'*sin(q_pin1)*(2*q' + q_pin1') - g*(3*cos(q) + cos(q + q_pin1)))/2
    let f1 = f1_of_motion.mul_add(m_l_halved_l_sin_q_pin1, f1_of_place)
        - g_m_l_times_3_by_2 * cos_q;
    // f2 = m*l*(l*q_pin2'*sin(q_pin2)*(2*q_ground1' + q_pin2') - g*(3*cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)))/2
    let f2 = (-g_m_l_times_3_by_2)
        .mul_add(cos_q_ground1, l * f2_of_motion * sin_q_pin2_m_l_halved)
        + g_m_l_halved_f2_of_place;
    // f3 = -m*l*g*cos(q_ground2)/2
    let f3 = -g_m_l_halved * cos_q_ground2;
    // f4 = -m*l*(g*cos(q + q_pin1) + l*q'^2*sin(q_pin1))/2
    let f4 = (-m_l_halved_l_sin_q_pin1).mul_add(q_dot_2_sq, f1_of_place);
    // f5 = -m*l*(g*cos(q_ground1 + q_pin2) + l*q_ground1'^2*sin(q_pin2))/2
    let f5 = (-sin_q_pin2_m_l_halved)
        .mul_add(l_q_ground1_dot_sq, g_m_l_halved_f2_of_place);
    // f6 = l*(q_ground1'^2*cos(q_ground1) - q'^2*cos(q) - cos(q + q_pin1)*(q' + q_pin1')^2)
    let f6 = f6_of_motion + l * (-q_dot_2_sq).mul_add(cos_q, f1_of_q_2_q_pin1 * f6_of_motion_2);
    // f7 = l*(q_ground1'^2*sin(q_ground1) - q'^2*sin(q) - sin(q + q_pin1)*(q' + q_pin1')^2)
    let f7 = f7_of_motion - l_sin_q_pin1 * f6_of_motion_2 * cos_q
        - l * sin_q * f6_of_motion_2.mul_add(cos_q_pin1, q_dot_2_sq);
    // f8 = l*(q_ground2'^2*cos(q_ground2) - q_ground1'^2*cos(q_ground1) - cos(q_ground1 +
    //   q_pin2)*(q_ground1' + q_pin2')^2)
    let f8 = f2_of_place.mul_add(f8_of_motion, -f6_of_motion) + l_q_ground2_dot_sq * cos_q_ground2;
    // f9 = l*(q_ground2'^2*sin(q_ground2) - q_ground1'^2*sin(q_ground1) - sin(q_ground1 +
    //   q_pin2)*(q_ground1' + q_pin2')^2)
    let f9 = -f7_of_motion + l_q_ground2_dot_sq * sin_q_ground2
        - f8_of_motion * sin_q_ground1.mul_add(cos_q_pin2, cos_q_ground1 * sin_q_pin2);
    [f1, f2, f3, f4, f5, f6, f7, f8, f9]
}

/// The accelerations (q'', q_ground1'', q_ground2'', q_pin1'', q_pin2''), solved for when this code was generated.
///
/// 215 operations, 7 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 5] {
    let Parameters { m, l, g } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    let [q_dot_2, q_ground1_dot, _, q_pin1_dot, q_pin2_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_pin2, cos_q_pin2) = q_pin2.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let m_l = m * l;
    let l_m_l = l * m_l;
    // sin(q)*sin(q_pin1) - cos(q)*cos(q_pin1)
    let d1_of_q_2_q_pin1 = (-cos_q).mul_add(cos_q_pin1, sin_q * sin_q_pin1);
    // cos(q) - d1_of_q_2_q_pin1
    let d1_of_q_2_q_pin1_2 = cos_q - d1_of_q_2_q_pin1;
    // cos(q)*sin(q_pin1) + sin(q)*cos(q_pin1)
    let d1_of_q_2_q_pin1_3 = sin_q.mul_add(cos_q_pin1, cos_q * sin_q_pin1);
    // sin(q) + d1_of_q_2_q_pin1_3
    let d1_of_q_2_q_pin1_4 = sin_q + d1_of_q_2_q_pin1_3;
    // d1_of_q_2_q_pin1_2*sin(q_ground1) - d1_of_q_2_q_pin1_4*cos(q_ground1)
    let d1_of_place = (-d1_of_q_2_q_pin1_4)
        .mul_add(cos_q_ground1, d1_of_q_2_q_pin1_2 * sin_q_ground1);
    // q - q_ground1 + q_pin1
    let d1_of_place_2 = q_2 - q_ground1 + q_pin1;
    let (sin_angle, cos_angle) = d1_of_place_2.sin_cos();
    let sin_angle_inv = S::int(1) / sin_angle;
    let d1_of_place_3 = d1_of_place * sin_angle_inv;
    // sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)
    let d1_of_place_4 = (-cos_q).mul_add(sin_q_ground1, sin_q * cos_q_ground1);
    // sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + d1_of_place_4*cos(q_pin1)
    let d1_of_place_5 = sin_q_pin1 * cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1)
        + d1_of_place_4 * cos_q_pin1;
    // (2*d1_of_place_4 - 3*d1_of_place_5*cos(q_pin1))/d1_of_place_5
    let d1_of_place_6 = (-(d1_of_place_5 * cos_q_pin1))
        .mul_add(S::int(3), S::int(2) * d1_of_place_4) / d1_of_place_5;
    let cos_q_pin1_d1_of_place = d1_of_place * cos_q_pin1;
    let sin_q_pin1_sin_angle_inv = sin_angle_inv * sin_q_pin1;
    // sin(q_ground1)*sin(q_pin2) - cos(q_ground1)*cos(q_pin2)
    let d1_of_place_7 = (-cos_q_ground1).mul_add(cos_q_pin2, sin_q_ground1 * sin_q_pin2);
    // cos(q_ground1) - d1_of_place_7
    let d1_of_place_8 = cos_q_ground1 - d1_of_place_7;
    // cos(q_ground1)*sin(q_pin2) + sin(q_ground1)*cos(q_pin2)
    let d1_of_place_9 = sin_q_ground1.mul_add(cos_q_pin2, cos_q_ground1 * sin_q_pin2);
    // sin(q_ground1) + d1_of_place_9
    let d1_of_place_10 = sin_q_ground1 + d1_of_place_9;
    // d1_of_place_8*sin(q_ground2) - d1_of_place_10*cos(q_ground2)
    let d1_of_place_11 = (-d1_of_place_10)
        .mul_add(cos_q_ground2, d1_of_place_8 * sin_q_ground2);
    // 2 + 3*cos(q_pin2)
    let d1_of_q_pin2 = cos_q_pin2.mul_add(S::int(3), S::int(2));
    // q_ground1 - q_ground2 + q_pin2
    let d1_of_place_12 = q_ground1 - q_ground2 + q_pin2;
    let (sin_angle_2, cos_angle_2) = d1_of_place_12.sin_cos();
    let sin_angle_2_inv = S::int(1) / sin_angle_2;
    // 10 + 6*cos(q_pin2) + d1_of_place_11*d1_of_q_pin2*sin_angle_2_inv
    let d1_of_place_13 = cos_q_pin2.mul_add(S::int(6), S::int(10))
        + d1_of_place_11 * d1_of_q_pin2 * sin_angle_2_inv;
    let d1_of_place_14 = d1_of_place_11 * sin_angle_2_inv;
    // d1_of_q_pin2 + 2*d1_of_place_14
    let d1_of_place_15 = d1_of_place_14.mul_add(S::int(2), d1_of_q_pin2);
    let d1_of_place_16 = sin_angle_2_inv * sin_q_pin2;
    let d1_of_place_16_doubled = S::int(2) * d1_of_place_16;
    // d1_of_place_13 + d1_of_place_14*d1_of_place_15
    let d1_of_place_17 = d1_of_place_14.mul_add(d1_of_place_15, d1_of_place_13);
    // 10 + 6*cos(q_pin1) + sin_angle_inv*(2*d1_of_place + 3*cos_q_pin1_d1_of_place)
    let d1_of_place_18 = S::int(10) + S::int(6) * cos_q_pin1
        + sin_angle_inv * cos_q_pin1_d1_of_place.mul_add(S::int(3), S::int(2) * d1_of_place);
    // sin_q_pin1_sin_angle_inv^2*(d1_of_place_16*d1_of_place_16_doubled + d1_of_place_17) + d1_of_place_18
    let d1_of_place_19 = sin_q_pin1_sin_angle_inv * sin_q_pin1_sin_angle_inv
        * d1_of_place_16.mul_add(d1_of_place_16_doubled, d1_of_place_17) + d1_of_place_18;
    // d1 = m*l^2*(10 + 6*cos(q_pin1) + (2*sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   2*cos(q_ground1)*(sin(q) + sin(q + q_pin1)) + 3*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))))/sin(q - q_ground1 + q_pin1))/6 +
    //   m*l^2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))*(2*sin(q)*cos(q_ground1) - 2*cos(q)*sin(q_ground1) -
    //   3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))/(6*sin(q - q_ground1 +
    //   q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(3*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(6*sin(q - q_ground1 + q_pin1)^2) + m*l^2*sin(q_pin1)^2*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(2 +
    //   3*cos(q_pin2) + 2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(6*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2))
    let d1 = S::ratio(1, 6) * l_m_l * (-d1_of_place_3).mul_add(d1_of_place_6, d1_of_place_19);
    let q_dot_2_sin_angle_inv = q_dot_2 * sin_angle_inv;
    // q' + d1_of_place*q_dot_2_sin_angle_inv
    let u_dot_of_q_dot_2 = d1_of_place.mul_add(q_dot_2_sin_angle_inv, q_dot_2);
    let u_dot_of_q_dot_2_2 = q_dot_2_sin_angle_inv * sin_q_pin1;
    // u_dot_of_q_dot_2 - u_dot_of_q_dot_2_2
    let u_dot_of_q_dot_2_3 = u_dot_of_q_dot_2 - u_dot_of_q_dot_2_2;
    // cos(q_ground1)*(d1_of_q_2_q_pin1*u_dot_of_q_dot_2 - q'*cos(q)) - sin(q_ground1)*(q'*sin(q) +
    //   d1_of_q_2_q_pin1_3*u_dot_of_q_dot_2) + u_dot_of_q_dot_2_2*(d1_of_q_2_q_pin1_2*cos(q_ground1) +
    //   d1_of_q_2_q_pin1_4*sin(q_ground1))
    let u_dot_of_q_dot_2_4 = cos_q_ground1
        * (-q_dot_2).mul_add(cos_q, d1_of_q_2_q_pin1 * u_dot_of_q_dot_2)
        - sin_q_ground1 * d1_of_q_2_q_pin1_3.mul_add(u_dot_of_q_dot_2, q_dot_2 * sin_q)
        + u_dot_of_q_dot_2_2
            * d1_of_q_2_q_pin1_4
                .mul_add(sin_q_ground1, d1_of_q_2_q_pin1_2 * cos_q_ground1);
    // q_dot_2_sin_angle_inv*(d1_of_place_3*u_dot_of_q_dot_2_3*cos(q - q_ground1 + q_pin1) -
    //   u_dot_of_q_dot_2_4)
    let u_dot_of_q_dot_2_5 = q_dot_2_sin_angle_inv
        * (d1_of_place_3 * u_dot_of_q_dot_2_3).mul_add(cos_angle, -u_dot_of_q_dot_2_4);
    // sin(q_pin1)*cos(q - q_ground1 + q_pin1)*(sin_angle_inv*(sin(q_pin1) - d1_of_place) - 1) +
    //   cos_q_pin1_d1_of_place
    let u_dot_of_place = sin_q_pin1 * cos_angle
        * (sin_angle_inv * (sin_q_pin1 - d1_of_place) - S::int(1)) + cos_q_pin1_d1_of_place;
    let cos_angle_sin_angle_inv = sin_angle_inv * cos_angle;
    let u_dot_of_place_2 = sin_angle_2_inv * cos_angle_2;
    // sin_angle_2_inv*(cos_q_pin1_d1_of_place*sin(q_pin2) +
    //   sin(q_pin1)*(d1_of_place_14*sin(q_pin1)*cos(q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(cos_angle_sin_angle_inv + u_dot_of_place_2*(sin_angle_2_inv*(sin(q_pin2) -
    //   d1_of_place_11) - 1)) - cos(q - q_ground1 + q_pin1)*(1 + d1_of_place_3))))
    let u_dot_of_place_3 = sin_angle_2_inv
        * (sin_q_pin1
            * (sin_q_pin2
                * (sin_q_pin1
                    * (cos_angle_sin_angle_inv
                        + u_dot_of_place_2
                            * (sin_angle_2_inv * (sin_q_pin2 - d1_of_place_11)
                                - S::int(1))) - cos_angle * (S::int(1) + d1_of_place_3))
                + d1_of_place_14 * sin_q_pin1 * cos_q_pin2) + cos_q_pin1_d1_of_place * sin_q_pin2);
    let u_dot_of_q_dot_2_6 = d1_of_place_16 * u_dot_of_q_dot_2_2;
    let u_dot_of_q_dot_2_7 = d1_of_place_14 * u_dot_of_q_dot_2_2;
    // u_dot_of_q_dot_2_2 + u_dot_of_q_dot_2_7
    let u_dot_of_q_dot_2_8 = u_dot_of_q_dot_2_2 + u_dot_of_q_dot_2_7;
    let q_dot_2_sin_angle_inv_sq = q_dot_2_sin_angle_inv * q_dot_2_sin_angle_inv;
    // sin_angle_2_inv*u_dot_of_q_dot_2_2*(u_dot_of_q_dot_2_6*(d1_of_place_8*cos(q_ground2) +
    //   d1_of_place_10*sin(q_ground2)) - sin(q_ground2)*(u_dot_of_q_dot_2_2*sin(q_ground1) +
    //   d1_of_place_9*u_dot_of_q_dot_2_8) - cos(q_ground2)*(u_dot_of_q_dot_2_2*cos(q_ground1) -
    //   d1_of_place_7*u_dot_of_q_dot_2_8)) + cos_q_pin1_d1_of_place*d1_of_place_14*q_dot_2_sin_angle_inv_sq
    let u_dot_of_q_dot_2_9 = sin_angle_2_inv * u_dot_of_q_dot_2_2
        * (u_dot_of_q_dot_2_6 * d1_of_place_10.mul_add(sin_q_ground2, d1_of_place_8 * cos_q_ground2)
            - sin_q_ground2
                * d1_of_place_9
                    .mul_add(u_dot_of_q_dot_2_8, u_dot_of_q_dot_2_2 * sin_q_ground1)
            - cos_q_ground2
                * (-d1_of_place_7)
                    .mul_add(u_dot_of_q_dot_2_8, u_dot_of_q_dot_2_2 * cos_q_ground1))
        + cos_q_pin1_d1_of_place * d1_of_place_14 * q_dot_2_sin_angle_inv_sq;
    // u_dot_of_q_dot_2_7*(u_dot_of_q_dot_2_3*cos_angle_sin_angle_inv +
    //   u_dot_of_place_2*(u_dot_of_q_dot_2_8 - u_dot_of_q_dot_2_6)) - u_dot_of_q_dot_2_9
    let u_dot_of_q_dot_2_10 = u_dot_of_q_dot_2_7
        * (u_dot_of_place_2 * (u_dot_of_q_dot_2_8 - u_dot_of_q_dot_2_6)
            + u_dot_of_q_dot_2_3 * cos_angle_sin_angle_inv) - u_dot_of_q_dot_2_9;
    // sin_angle_inv*q_dot_2_sin_angle_inv*u_dot_of_q_dot_2_2*(d1_of_place_13*u_dot_of_place +
    //   d1_of_place_16_doubled*u_dot_of_place_3) -
    //   sin_q_pin1_sin_angle_inv*d1_of_place_15*u_dot_of_q_dot_2_10
    let u_dot_of_q_dot_2_11 = sin_angle_inv * q_dot_2_sin_angle_inv * u_dot_of_q_dot_2_2
        * d1_of_place_16_doubled
            .mul_add(u_dot_of_place_3, d1_of_place_13 * u_dot_of_place)
        - sin_q_pin1_sin_angle_inv * d1_of_place_15 * u_dot_of_q_dot_2_10;
    // u' = (m*l^2*(2*cos(q)*sin(q_ground1) - 2*sin(q)*cos(q_ground1) +
    //   3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(q'*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   q'*(cos(q_ground1)*(q'*cos(q) + cos(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1))
    //   - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))) -
    //   q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   2*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) -
    //   m*l^2*q'^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 - m*l^2*sin(q_pin1)*(2 + 3*cos(q_pin2) +
    //   2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(q'^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q' -
    //   q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   q'*sin(q_pin1)*(q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   cos(q_ground2)*(q'*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 +
    //   q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   sin(q_ground2)*(q'*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*(l*q_pin1'*sin(q_pin1)*(2*q' + q_pin1') - g*(3*cos(q) + cos(q + q_pin1)) + (g*cos(q +
    //   q_pin1)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))) +
    //   sin(q_pin1)*(l*(q'^2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1))) + sin(q_pin2)*(q_pin2'^2 + q_ground1'*(q_ground1'*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + 2*q_pin2'))) - g*(3*cos(q_ground1) +
    //   cos(q_ground2)*sin(q_pin2)/sin(q_ground1 - q_ground2 + q_pin2) + cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q - q_ground1 +
    //   q_pin1)))/(6*d1)
    let u_dot = S::ratio(1, 6)
        * (S::int(3) * m_l
            * (l * q_pin1_dot * sin_q_pin1 * q_dot_2.mul_add(S::int(2), q_pin1_dot)
                + g * (-cos_q).mul_add(S::int(3), d1_of_q_2_q_pin1)
                + sin_angle_inv
                    * (sin_q_pin1
                        * (l
                            * (sin_q_pin2
                                * (q_ground1_dot
                                    * (-q_ground1_dot)
                                        .mul_add(d1_of_place_14, S::int(2) * q_pin2_dot)
                                    + q_pin2_dot * q_pin2_dot) - q_dot_2 * q_dot_2 * d1_of_place)
                            + g
                                * (d1_of_place_7 * (S::int(1) + d1_of_place_14)
                                    - S::int(3) * cos_q_ground1 - d1_of_place_16 * cos_q_ground2))
                        + g * d1_of_q_2_q_pin1 * d1_of_place))
            - l_m_l * d1_of_place_6.mul_add(u_dot_of_q_dot_2_5, u_dot_of_q_dot_2_11)) / d1;
    // q'' = u'
    let q_ddot = u_dot;
    let q_ground1_ddot_of_u_dot = u_dot * sin_q_pin1_sin_angle_inv;
    // q_ground1'' = q'^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) -
    //   1))/sin(q - q_ground1 + q_pin1)^2 + u'*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    let q_ground1_ddot = u_dot_of_place
        .mul_add(q_dot_2_sin_angle_inv_sq, q_ground1_ddot_of_u_dot);
    // q_ground2'' = q'^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + u'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_ground2_ddot = d1_of_place_16
        .mul_add(q_ground1_ddot_of_u_dot, u_dot_of_place_3 * q_dot_2_sin_angle_inv_sq);
    // q_pin1'' = q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) + q'*(q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q
    //   + q_pin1))/sin(q - q_ground1 + q_pin1) + q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q +
    //   q_pin1))/sin(q - q_ground1 + q_pin1) - cos(q_ground1)*(q'*cos(q) + cos(q + q_pin1)*(q' +
    //   q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))) - sin(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q)
    //   + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/sin(q
    //   - q_ground1 + q_pin1) + u'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)
    let q_pin1_ddot = u_dot.mul_add(d1_of_place_3, -u_dot_of_q_dot_2_5);
    // q_pin2'' = q'^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q' -
    //   q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   q'*sin(q_pin1)*(q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   cos(q_ground2)*(q'*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 +
    //   q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   sin(q_ground2)*(q'*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_ddot = d1_of_place_14
        .mul_add(q_ground1_ddot_of_u_dot, -u_dot_of_q_dot_2_10);
    [q_ddot, q_ground1_ddot, q_ground2_ddot, q_pin1_ddot, q_pin2_ddot]
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
    let [q_dot_2, q_ground1_dot, q_ground2_dot, q_pin1_dot, q_pin2_dot] = *q_dot;
    // Values.
    // q'
    let q_dot_value = q_dot_2;
    // q_ground1'
    let q_ground1_dot_value = q_ground1_dot;
    // q_ground2'
    let q_ground2_dot_value = q_ground2_dot;
    // q_pin1'
    let q_pin1_dot_value = q_pin1_dot;
    // q_pin2'
    let q_pin2_dot_value = q_pin2_dot;
    [
        q_dot_value, q_ground1_dot_value, q_ground2_dot_value, q_pin1_dot_value, q_pin2_dot_value,
    ]
}

/// Kinetic energy T.
///
/// 25 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> S {
    let Parameters { m, l, .. } = *p;
    let [_, _, _, q_pin1, q_pin2] = *q;
    let [q_dot_2, q_ground1_dot, q_ground2_dot, q_pin1_dot, q_pin2_dot] = *q_dot;
    // Sines and cosines.
    let (_, cos_q_pin1) = q_pin1.sin_cos();
    let (_, cos_q_pin2) = q_pin2.sin_cos();
    // Shared terms.
    let cos_q_pin1_times_3 = S::int(3) * cos_q_pin1;
    let cos_q_pin2_times_3 = S::int(3) * cos_q_pin2;
    // q_ground2'^2 + q_pin1'^2
    let energy_of_motion = q_pin1_dot.mul_add(q_pin1_dot, q_ground2_dot * q_ground2_dot);
    // q_pin2'^2 + q'*(q'*(5 + cos_q_pin1_times_3) + q_pin1'*(2 + cos_q_pin1_times_3))
    let energy_of_motion_2 = q_dot_2
        * (q_dot_2 * (S::int(5) + cos_q_pin1_times_3)
            + q_pin1_dot * (S::int(2) + cos_q_pin1_times_3)) + q_pin2_dot * q_pin2_dot;
    // q_ground1'*(q_ground1'*(5 + cos_q_pin2_times_3) + q_pin2'*(2 + cos_q_pin2_times_3)) +
    //   energy_of_motion
    let energy_of_motion_3 = q_ground1_dot
        * (q_ground1_dot * (S::int(5) + cos_q_pin2_times_3)
            + q_pin2_dot * (S::int(2) + cos_q_pin2_times_3)) + energy_of_motion;
    // Values.
    // T = m*l^2*q'^2*(5 + 3*cos(q_pin1))/6 + m*l^2*q_ground1'^2*(5 + 3*cos(q_pin2))/6 +
    //   m*l^2*q_ground2'^2/6 + m*l^2*q_pin1'^2/6 + m*l^2*q'*q_pin1'*(2 + 3*cos(q_pin1))/6 +
    //   m*l^2*q_pin2'^2/6 + m*l^2*q_ground1'*q_pin2'*(2 + 3*cos(q_pin2))/6
    let energy = S::ratio(1, 6) * m * l * l * (energy_of_motion_2 + energy_of_motion_3);
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
    let [q_dot_2, _, _, _, _] = *q_dot;
    // Values.
    // u = q'
    let u_value = q_dot_2;
    [u_value]
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
    let [q_ddot, _, _, _, _] = *v_dot;
    // Values.
    // u' = q''
    let u_dot_value = q_ddot;
    [u_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 30 operations, 7 sines and cosines.
#[must_use]
pub fn motion_variables<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 1],
) -> [S; 5] {
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q_pin2, cos_q_pin2) = q_pin2.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    let (sin_angle, _) = (q_2 - q_ground1 + q_pin1).sin_cos();
    // Shared terms.
    let u_2_sin_angle_inv = u_2 / sin_angle;
    let q_ground1_dot_value_of_place = u_2_sin_angle_inv * sin_q_pin1;
    let (sin_angle_2, _) = (q_ground1 - q_ground2 + q_pin2).sin_cos();
    let q_ground2_dot_value_of_place = q_ground1_dot_value_of_place / sin_angle_2;
    let q_ground2_dot_value_of_place_2 = q_ground2_dot_value_of_place * sin_q_pin2;
    // Values.
    // q' = u
    let q_dot_value = u_2;
    // q_ground1' = u*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    let q_ground1_dot_value = q_ground1_dot_value_of_place;
    // q_ground2' = u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2))
    let q_ground2_dot_value = q_ground2_dot_value_of_place_2;
    // q_pin1' = u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)
    let q_pin1_dot_value = u_2_sin_angle_inv
        * (-sin_q).mul_add(cos_q_ground1, cos_q * sin_q_ground1) * (S::int(1) + cos_q_pin1)
        - q_ground1_dot_value_of_place * cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1);
    // q_pin2' = u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_dot_value = q_ground2_dot_value_of_place
        * (-sin_q_ground1).mul_add(cos_q_ground2, cos_q_ground1 * sin_q_ground2)
        * (S::int(1) + cos_q_pin2)
        - q_ground2_dot_value_of_place_2
            * cos_q_ground1.mul_add(cos_q_ground2, sin_q_ground1 * sin_q_ground2);
    [
        q_dot_value, q_ground1_dot_value, q_ground2_dot_value, q_pin1_dot_value, q_pin2_dot_value,
    ]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 215 operations, 7 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> ([S; 5], [S; 5]) {
    let Parameters { m, l, g } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    let [q_dot_2, q_ground1_dot, q_ground2_dot, q_pin1_dot, q_pin2_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_pin2, cos_q_pin2) = q_pin2.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let m_l = m * l;
    let l_m_l = l * m_l;
    // sin(q)*sin(q_pin1) - cos(q)*cos(q_pin1)
    let d1_of_q_2_q_pin1 = (-cos_q).mul_add(cos_q_pin1, sin_q * sin_q_pin1);
    // cos(q) - d1_of_q_2_q_pin1
    let d1_of_q_2_q_pin1_2 = cos_q - d1_of_q_2_q_pin1;
    // cos(q)*sin(q_pin1) + sin(q)*cos(q_pin1)
    let d1_of_q_2_q_pin1_3 = sin_q.mul_add(cos_q_pin1, cos_q * sin_q_pin1);
    // sin(q) + d1_of_q_2_q_pin1_3
    let d1_of_q_2_q_pin1_4 = sin_q + d1_of_q_2_q_pin1_3;
    // d1_of_q_2_q_pin1_2*sin(q_ground1) - d1_of_q_2_q_pin1_4*cos(q_ground1)
    let d1_of_place = (-d1_of_q_2_q_pin1_4)
        .mul_add(cos_q_ground1, d1_of_q_2_q_pin1_2 * sin_q_ground1);
    // q - q_ground1 + q_pin1
    let d1_of_place_2 = q_2 - q_ground1 + q_pin1;
    let (sin_angle, cos_angle) = d1_of_place_2.sin_cos();
    let sin_angle_inv = S::int(1) / sin_angle;
    let d1_of_place_3 = d1_of_place * sin_angle_inv;
    // sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)
    let d1_of_place_4 = (-cos_q).mul_add(sin_q_ground1, sin_q * cos_q_ground1);
    // sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) + d1_of_place_4*cos(q_pin1)
    let d1_of_place_5 = sin_q_pin1 * cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1)
        + d1_of_place_4 * cos_q_pin1;
    // (2*d1_of_place_4 - 3*d1_of_place_5*cos(q_pin1))/d1_of_place_5
    let d1_of_place_6 = (-(d1_of_place_5 * cos_q_pin1))
        .mul_add(S::int(3), S::int(2) * d1_of_place_4) / d1_of_place_5;
    let cos_q_pin1_d1_of_place = d1_of_place * cos_q_pin1;
    let sin_q_pin1_sin_angle_inv = sin_angle_inv * sin_q_pin1;
    // sin(q_ground1)*sin(q_pin2) - cos(q_ground1)*cos(q_pin2)
    let d1_of_place_7 = (-cos_q_ground1).mul_add(cos_q_pin2, sin_q_ground1 * sin_q_pin2);
    // cos(q_ground1) - d1_of_place_7
    let d1_of_place_8 = cos_q_ground1 - d1_of_place_7;
    // cos(q_ground1)*sin(q_pin2) + sin(q_ground1)*cos(q_pin2)
    let d1_of_place_9 = sin_q_ground1.mul_add(cos_q_pin2, cos_q_ground1 * sin_q_pin2);
    // sin(q_ground1) + d1_of_place_9
    let d1_of_place_10 = sin_q_ground1 + d1_of_place_9;
    // d1_of_place_8*sin(q_ground2) - d1_of_place_10*cos(q_ground2)
    let d1_of_place_11 = (-d1_of_place_10)
        .mul_add(cos_q_ground2, d1_of_place_8 * sin_q_ground2);
    // 2 + 3*cos(q_pin2)
    let d1_of_q_pin2 = cos_q_pin2.mul_add(S::int(3), S::int(2));
    // q_ground1 - q_ground2 + q_pin2
    let d1_of_place_12 = q_ground1 - q_ground2 + q_pin2;
    let (sin_angle_2, cos_angle_2) = d1_of_place_12.sin_cos();
    let sin_angle_2_inv = S::int(1) / sin_angle_2;
    // 10 + 6*cos(q_pin2) + d1_of_place_11*d1_of_q_pin2*sin_angle_2_inv
    let d1_of_place_13 = cos_q_pin2.mul_add(S::int(6), S::int(10))
        + d1_of_place_11 * d1_of_q_pin2 * sin_angle_2_inv;
    let d1_of_place_14 = d1_of_place_11 * sin_angle_2_inv;
    // d1_of_q_pin2 + 2*d1_of_place_14
    let d1_of_place_15 = d1_of_place_14.mul_add(S::int(2), d1_of_q_pin2);
    let d1_of_place_16 = sin_angle_2_inv * sin_q_pin2;
    let d1_of_place_16_doubled = S::int(2) * d1_of_place_16;
    // d1_of_place_13 + d1_of_place_14*d1_of_place_15
    let d1_of_place_17 = d1_of_place_14.mul_add(d1_of_place_15, d1_of_place_13);
    // 10 + 6*cos(q_pin1) + sin_angle_inv*(2*d1_of_place + 3*cos_q_pin1_d1_of_place)
    let d1_of_place_18 = S::int(10) + S::int(6) * cos_q_pin1
        + sin_angle_inv * cos_q_pin1_d1_of_place.mul_add(S::int(3), S::int(2) * d1_of_place);
    // sin_q_pin1_sin_angle_inv^2*(d1_of_place_16*d1_of_place_16_doubled + d1_of_place_17) + d1_of_place_18
    let d1_of_place_19 = sin_q_pin1_sin_angle_inv * sin_q_pin1_sin_angle_inv
        * d1_of_place_16.mul_add(d1_of_place_16_doubled, d1_of_place_17) + d1_of_place_18;
    // d1 = m*l^2*(10 + 6*cos(q_pin1) + (2*sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   2*cos(q_ground1)*(sin(q) + sin(q + q_pin1)) + 3*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))))/sin(q - q_ground1 + q_pin1))/6 +
    //   m*l^2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))*(2*sin(q)*cos(q_ground1) - 2*cos(q)*sin(q_ground1) -
    //   3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))/(6*sin(q - q_ground1 +
    //   q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(3*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(6*sin(q - q_ground1 + q_pin1)^2) + m*l^2*sin(q_pin1)^2*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(2 +
    //   3*cos(q_pin2) + 2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(6*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2))
    let d1 = S::ratio(1, 6) * l_m_l * (-d1_of_place_3).mul_add(d1_of_place_6, d1_of_place_19);
    let q_dot_2_sin_angle_inv = q_dot_2 * sin_angle_inv;
    // q' + d1_of_place*q_dot_2_sin_angle_inv
    let u_dot_of_q_dot_2 = d1_of_place.mul_add(q_dot_2_sin_angle_inv, q_dot_2);
    let u_dot_of_q_dot_2_2 = q_dot_2_sin_angle_inv * sin_q_pin1;
    // u_dot_of_q_dot_2 - u_dot_of_q_dot_2_2
    let u_dot_of_q_dot_2_3 = u_dot_of_q_dot_2 - u_dot_of_q_dot_2_2;
    // cos(q_ground1)*(d1_of_q_2_q_pin1*u_dot_of_q_dot_2 - q'*cos(q)) - sin(q_ground1)*(q'*sin(q) +
    //   d1_of_q_2_q_pin1_3*u_dot_of_q_dot_2) + u_dot_of_q_dot_2_2*(d1_of_q_2_q_pin1_2*cos(q_ground1) +
    //   d1_of_q_2_q_pin1_4*sin(q_ground1))
    let u_dot_of_q_dot_2_4 = cos_q_ground1
        * (-q_dot_2).mul_add(cos_q, d1_of_q_2_q_pin1 * u_dot_of_q_dot_2)
        - sin_q_ground1 * d1_of_q_2_q_pin1_3.mul_add(u_dot_of_q_dot_2, q_dot_2 * sin_q)
        + u_dot_of_q_dot_2_2
            * d1_of_q_2_q_pin1_4
                .mul_add(sin_q_ground1, d1_of_q_2_q_pin1_2 * cos_q_ground1);
    // q_dot_2_sin_angle_inv*(d1_of_place_3*u_dot_of_q_dot_2_3*cos(q - q_ground1 + q_pin1) -
    //   u_dot_of_q_dot_2_4)
    let u_dot_of_q_dot_2_5 = q_dot_2_sin_angle_inv
        * (d1_of_place_3 * u_dot_of_q_dot_2_3).mul_add(cos_angle, -u_dot_of_q_dot_2_4);
    // sin(q_pin1)*cos(q - q_ground1 + q_pin1)*(sin_angle_inv*(sin(q_pin1) - d1_of_place) - 1) +
    //   cos_q_pin1_d1_of_place
    let u_dot_of_place = sin_q_pin1 * cos_angle
        * (sin_angle_inv * (sin_q_pin1 - d1_of_place) - S::int(1)) + cos_q_pin1_d1_of_place;
    let cos_angle_sin_angle_inv = sin_angle_inv * cos_angle;
    let u_dot_of_place_2 = sin_angle_2_inv * cos_angle_2;
    // sin_angle_2_inv*(cos_q_pin1_d1_of_place*sin(q_pin2) +
    //   sin(q_pin1)*(d1_of_place_14*sin(q_pin1)*cos(q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(cos_angle_sin_angle_inv + u_dot_of_place_2*(sin_angle_2_inv*(sin(q_pin2) -
    //   d1_of_place_11) - 1)) - cos(q - q_ground1 + q_pin1)*(1 + d1_of_place_3))))
    let u_dot_of_place_3 = sin_angle_2_inv
        * (sin_q_pin1
            * (sin_q_pin2
                * (sin_q_pin1
                    * (cos_angle_sin_angle_inv
                        + u_dot_of_place_2
                            * (sin_angle_2_inv * (sin_q_pin2 - d1_of_place_11)
                                - S::int(1))) - cos_angle * (S::int(1) + d1_of_place_3))
                + d1_of_place_14 * sin_q_pin1 * cos_q_pin2) + cos_q_pin1_d1_of_place * sin_q_pin2);
    let u_dot_of_q_dot_2_6 = d1_of_place_16 * u_dot_of_q_dot_2_2;
    let u_dot_of_q_dot_2_7 = d1_of_place_14 * u_dot_of_q_dot_2_2;
    // u_dot_of_q_dot_2_2 + u_dot_of_q_dot_2_7
    let u_dot_of_q_dot_2_8 = u_dot_of_q_dot_2_2 + u_dot_of_q_dot_2_7;
    let q_dot_2_sin_angle_inv_sq = q_dot_2_sin_angle_inv * q_dot_2_sin_angle_inv;
    // sin_angle_2_inv*u_dot_of_q_dot_2_2*(u_dot_of_q_dot_2_6*(d1_of_place_8*cos(q_ground2) +
    //   d1_of_place_10*sin(q_ground2)) - sin(q_ground2)*(u_dot_of_q_dot_2_2*sin(q_ground1) +
    //   d1_of_place_9*u_dot_of_q_dot_2_8) - cos(q_ground2)*(u_dot_of_q_dot_2_2*cos(q_ground1) -
    //   d1_of_place_7*u_dot_of_q_dot_2_8)) + cos_q_pin1_d1_of_place*d1_of_place_14*q_dot_2_sin_angle_inv_sq
    let u_dot_of_q_dot_2_9 = sin_angle_2_inv * u_dot_of_q_dot_2_2
        * (u_dot_of_q_dot_2_6 * d1_of_place_10.mul_add(sin_q_ground2, d1_of_place_8 * cos_q_ground2)
            - sin_q_ground2
                * d1_of_place_9
                    .mul_add(u_dot_of_q_dot_2_8, u_dot_of_q_dot_2_2 * sin_q_ground1)
            - cos_q_ground2
                * (-d1_of_place_7)
                    .mul_add(u_dot_of_q_dot_2_8, u_dot_of_q_dot_2_2 * cos_q_ground1))
        + cos_q_pin1_d1_of_place * d1_of_place_14 * q_dot_2_sin_angle_inv_sq;
    // u_dot_of_q_dot_2_7*(u_dot_of_q_dot_2_3*cos_angle_sin_angle_inv +
    //   u_dot_of_place_2*(u_dot_of_q_dot_2_8 - u_dot_of_q_dot_2_6)) - u_dot_of_q_dot_2_9
    let u_dot_of_q_dot_2_10 = u_dot_of_q_dot_2_7
        * (u_dot_of_place_2 * (u_dot_of_q_dot_2_8 - u_dot_of_q_dot_2_6)
            + u_dot_of_q_dot_2_3 * cos_angle_sin_angle_inv) - u_dot_of_q_dot_2_9;
    // sin_angle_inv*q_dot_2_sin_angle_inv*u_dot_of_q_dot_2_2*(d1_of_place_13*u_dot_of_place +
    //   d1_of_place_16_doubled*u_dot_of_place_3) -
    //   sin_q_pin1_sin_angle_inv*d1_of_place_15*u_dot_of_q_dot_2_10
    let u_dot_of_q_dot_2_11 = sin_angle_inv * q_dot_2_sin_angle_inv * u_dot_of_q_dot_2_2
        * d1_of_place_16_doubled
            .mul_add(u_dot_of_place_3, d1_of_place_13 * u_dot_of_place)
        - sin_q_pin1_sin_angle_inv * d1_of_place_15 * u_dot_of_q_dot_2_10;
    // u' = (m*l^2*(2*cos(q)*sin(q_ground1) - 2*sin(q)*cos(q_ground1) +
    //   3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(q'*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   q'*(cos(q_ground1)*(q'*cos(q) + cos(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1))
    //   - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))) -
    //   q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   2*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) -
    //   m*l^2*q'^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 - m*l^2*sin(q_pin1)*(2 + 3*cos(q_pin2) +
    //   2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(q'^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q' -
    //   q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   q'*sin(q_pin1)*(q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   cos(q_ground2)*(q'*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 +
    //   q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   sin(q_ground2)*(q'*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*(l*q_pin1'*sin(q_pin1)*(2*q' + q_pin1') - g*(3*cos(q) + cos(q + q_pin1)) + (g*cos(q +
    //   q_pin1)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))) +
    //   sin(q_pin1)*(l*(q'^2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1))) + sin(q_pin2)*(q_pin2'^2 + q_ground1'*(q_ground1'*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + 2*q_pin2'))) - g*(3*cos(q_ground1) +
    //   cos(q_ground2)*sin(q_pin2)/sin(q_ground1 - q_ground2 + q_pin2) + cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q - q_ground1 +
    //   q_pin1)))/(6*d1)
    let u_dot = S::ratio(1, 6)
        * (S::int(3) * m_l
            * (l * q_pin1_dot * sin_q_pin1 * q_dot_2.mul_add(S::int(2), q_pin1_dot)
                + g * (-cos_q).mul_add(S::int(3), d1_of_q_2_q_pin1)
                + sin_angle_inv
                    * (sin_q_pin1
                        * (l
                            * (sin_q_pin2
                                * (q_ground1_dot
                                    * (-q_ground1_dot)
                                        .mul_add(d1_of_place_14, S::int(2) * q_pin2_dot)
                                    + q_pin2_dot * q_pin2_dot) - q_dot_2 * q_dot_2 * d1_of_place)
                            + g
                                * (d1_of_place_7 * (S::int(1) + d1_of_place_14)
                                    - S::int(3) * cos_q_ground1 - d1_of_place_16 * cos_q_ground2))
                        + g * d1_of_q_2_q_pin1 * d1_of_place))
            - l_m_l * d1_of_place_6.mul_add(u_dot_of_q_dot_2_5, u_dot_of_q_dot_2_11)) / d1;
    // q'' = u'
    let q_ddot = u_dot;
    let q_ground1_ddot_of_u_dot = u_dot * sin_q_pin1_sin_angle_inv;
    // q_ground1'' = q'^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) -
    //   1))/sin(q - q_ground1 + q_pin1)^2 + u'*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    let q_ground1_ddot = u_dot_of_place
        .mul_add(q_dot_2_sin_angle_inv_sq, q_ground1_ddot_of_u_dot);
    // q_ground2'' = q'^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + u'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_ground2_ddot = d1_of_place_16
        .mul_add(q_ground1_ddot_of_u_dot, u_dot_of_place_3 * q_dot_2_sin_angle_inv_sq);
    // q_pin1'' = q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) + q'*(q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q
    //   + q_pin1))/sin(q - q_ground1 + q_pin1) + q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q +
    //   q_pin1))/sin(q - q_ground1 + q_pin1) - cos(q_ground1)*(q'*cos(q) + cos(q + q_pin1)*(q' +
    //   q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))) - sin(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q)
    //   + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/sin(q
    //   - q_ground1 + q_pin1) + u'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)
    let q_pin1_ddot = u_dot.mul_add(d1_of_place_3, -u_dot_of_q_dot_2_5);
    // q_pin2'' = q'^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q' -
    //   q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   q'*sin(q_pin1)*(q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   cos(q_ground2)*(q'*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 +
    //   q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   sin(q_ground2)*(q'*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_ddot = d1_of_place_14
        .mul_add(q_ground1_ddot_of_u_dot, -u_dot_of_q_dot_2_10);
    // Values.
    // q'
    let q_dot_value = q_dot_2;
    // q_ground1'
    let q_ground1_dot_value = q_ground1_dot;
    // q_ground2'
    let q_ground2_dot_value = q_ground2_dot;
    // q_pin1'
    let q_pin1_dot_value = q_pin1_dot;
    // q_pin2'
    let q_pin2_dot_value = q_pin2_dot;
    (
        [
            q_dot_value, q_ground1_dot_value, q_ground2_dot_value, q_pin1_dot_value,
            q_pin2_dot_value,
        ],
        [q_ddot, q_ground1_ddot, q_ground2_ddot, q_pin1_ddot, q_pin2_ddot],
    )
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 4 operations, 2 sines and cosines.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 5], _q_dot: &[S; 5]) -> [S; 2] {
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    // Sines and cosines.
    let (sin_angle, _) = (q_2 - q_ground1 + q_pin1).sin_cos();
    let (sin_angle_2, _) = (q_ground1 - q_ground2 + q_pin2).sin_cos();
    // Values.
    // divisor1 = sin(q - q_ground1 + q_pin1)
    let divisor1 = sin_angle;
    // divisor2 = sin(q_ground1 - q_ground2 + q_pin2)
    let divisor2 = sin_angle_2;
    [divisor1, divisor2]
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 40 operations, 5 sines and cosines.
#[must_use]
pub fn constraints<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> [S; 8] {
    let Parameters { l, .. } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    let [q_dot_2, q_ground1_dot, q_ground2_dot, q_pin1_dot, q_pin2_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    // Shared terms.
    // q' + q_pin1'
    let q_dot_2_plus_q_pin1_dot = q_dot_2 + q_pin1_dot;
    // q_ground1' + q_pin2'
    let residual7_of_motion = q_ground1_dot + q_pin2_dot;
    // q + q_pin1
    let q_2_plus_q_pin1 = q_2 + q_pin1;
    let (sin_q_plus_q_pin1, cos_q_plus_q_pin1) = q_2_plus_q_pin1.sin_cos();
    // q_ground1 + q_pin2
    let q_ground1_plus_q_pin2 = q_ground1 + q_pin2;
    let (sin_q_ground1_plus_q_pin2, cos_q_ground1_plus_q_pin2) = q_ground1_plus_q_pin2
        .sin_cos();
    let residual5_of_motion = q_ground1_dot * sin_q_ground1;
    let residual6_of_motion = q_ground1_dot * cos_q_ground1;
    // Values.
    // close1_1 = l*(1 - cos(q) + cos(q_ground1) - cos(q + q_pin1))
    let residual1 = l * (S::int(1) - cos_q + cos_q_ground1 - cos_q_plus_q_pin1);
    // close1_2 = l*(sin(q_ground1) - sin(q) - sin(q + q_pin1))
    let residual2 = l * (sin_q_ground1 - sin_q - sin_q_plus_q_pin1);
    // close2_1 = l*(1 - cos(q_ground1) + cos(q_ground2) - cos(q_ground1 + q_pin2))
    let residual3 = l * (S::int(1) - cos_q_ground1 + cos_q_ground2 - cos_q_ground1_plus_q_pin2);
    // close2_2 = l*(sin(q_ground2) - sin(q_ground1) - sin(q_ground1 + q_pin2))
    let residual4 = l * (sin_q_ground2 - sin_q_ground1 - sin_q_ground1_plus_q_pin2);
    // close1_1' = l*(q'*sin(q) - q_ground1'*sin(q_ground1) + sin(q + q_pin1)*(q' + q_pin1'))
    let residual5 = l
        * (q_dot_2.mul_add(sin_q, -residual5_of_motion)
            + sin_q_plus_q_pin1 * q_dot_2_plus_q_pin1_dot);
    // close1_2' = l*(q_ground1'*cos(q_ground1) - q'*cos(q) - cos(q + q_pin1)*(q' + q_pin1'))
    let residual6 = l
        * ((-q_dot_2).mul_add(cos_q, residual6_of_motion)
            - cos_q_plus_q_pin1 * q_dot_2_plus_q_pin1_dot);
    // close2_1' = l*(q_ground1'*sin(q_ground1) - q_ground2'*sin(q_ground2) + sin(q_ground1 +
    //   q_pin2)*(q_ground1' + q_pin2'))
    let residual7 = l
        * ((-q_ground2_dot).mul_add(sin_q_ground2, residual5_of_motion)
            + sin_q_ground1_plus_q_pin2 * residual7_of_motion);
    // close2_2' = l*(q_ground2'*cos(q_ground2) - q_ground1'*cos(q_ground1) - cos(q_ground1 +
    //   q_pin2)*(q_ground1' + q_pin2'))
    let residual8 = l
        * (q_ground2_dot.mul_add(cos_q_ground2, -residual6_of_motion)
            - cos_q_ground1_plus_q_pin2 * residual7_of_motion);
    [
        residual1, residual2, residual3, residual4, residual5, residual6, residual7, residual8,
    ]
}

/// Slopes of the constraints, one after the other, along q, q_ground1, q_ground2, q_pin1, q_pin2, q', q_ground1', q_ground2', q_pin1', q_pin2'.
///
/// 42 operations, 5 sines and cosines.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 80] {
    let Parameters { l, .. } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    let [q_dot_2, q_ground1_dot, q_ground2_dot, q_pin1_dot, q_pin2_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    // Shared terms.
    // q + q_pin1
    let q_2_plus_q_pin1 = q_2 + q_pin1;
    let (sin_q_plus_q_pin1, cos_q_plus_q_pin1) = q_2_plus_q_pin1.sin_cos();
    let l_sin_q_plus_q_pin1 = l * sin_q_plus_q_pin1;
    let l_sin_q = l * sin_q;
    // l_sin_q_plus_q_pin1 + l_sin_q
    let residual1_by_q_of_l_q_2_q_pin1 = l_sin_q_plus_q_pin1 + l_sin_q;
    let l_sin_q_ground1 = l * sin_q_ground1;
    let l_cos_q_plus_q_pin1 = l * cos_q_plus_q_pin1;
    let l_cos_q = l * cos_q;
    // l_cos_q_plus_q_pin1 + l_cos_q
    let residual2_by_q_of_l_q_2_q_pin1 = l_cos_q_plus_q_pin1 + l_cos_q;
    let l_cos_q_ground1 = l * cos_q_ground1;
    // q_ground1 + q_pin2
    let q_ground1_plus_q_pin2 = q_ground1 + q_pin2;
    let (sin_q_ground1_plus_q_pin2, cos_q_ground1_plus_q_pin2) = q_ground1_plus_q_pin2
        .sin_cos();
    let residual3_by_q_ground1_of_place = l * sin_q_ground1_plus_q_pin2;
    // l_sin_q_ground1 + residual3_by_q_ground1_of_place
    let residual3_by_q_ground1_of_place_2 = l_sin_q_ground1 + residual3_by_q_ground1_of_place;
    let l_sin_q_ground2 = l * sin_q_ground2;
    let residual4_by_q_ground1_of_place = l * cos_q_ground1_plus_q_pin2;
    // l_cos_q_ground1 + residual4_by_q_ground1_of_place
    let residual4_by_q_ground1_of_place_2 = l_cos_q_ground1 + residual4_by_q_ground1_of_place;
    let l_cos_q_ground2 = l * cos_q_ground2;
    // q' + q_pin1'
    let q_dot_2_plus_q_pin1_dot = q_dot_2 + q_pin1_dot;
    let residual5_by_q_of_motion = l_cos_q_plus_q_pin1 * q_dot_2_plus_q_pin1_dot;
    let residual5_by_q_ground1_of_motion = q_ground1_dot * l_cos_q_ground1;
    let residual6_by_q_of_motion = l_sin_q_plus_q_pin1 * q_dot_2_plus_q_pin1_dot;
    let residual6_by_q_ground1_of_motion = q_ground1_dot * l_sin_q_ground1;
    // q_ground1' + q_pin2'
    let residual7_by_q_ground1_of_motion = q_ground1_dot + q_pin2_dot;
    let residual7_by_q_ground1_of_motion_2 = residual4_by_q_ground1_of_place
        * residual7_by_q_ground1_of_motion;
    let residual8_by_q_ground1_of_motion = residual3_by_q_ground1_of_place
        * residual7_by_q_ground1_of_motion;
    // -l_sin_q_ground1
    let minus_l_sin_q_ground1 = -l_sin_q_ground1;
    // -residual2_by_q_of_l_q_2_q_pin1
    let residual2_by_q_of_l_q_2_q_pin1_2 = -residual2_by_q_of_l_q_2_q_pin1;
    // -l_cos_q_plus_q_pin1
    let residual2_by_q_pin1_of_l_q_2_q_pin1 = -l_cos_q_plus_q_pin1;
    // -l_sin_q_ground2
    let minus_l_sin_q_ground2 = -l_sin_q_ground2;
    // -residual4_by_q_ground1_of_place_2
    let residual4_by_q_ground1_of_place_3 = -residual4_by_q_ground1_of_place_2;
    // -residual4_by_q_ground1_of_place
    let residual4_by_q_pin2_of_place = -residual4_by_q_ground1_of_place;
    // Values.
    // d(close1_1)/d(q) = l*(sin(q) + sin(q + q_pin1))
    let residual1_by_q = residual1_by_q_of_l_q_2_q_pin1;
    // d(close1_1)/d(q_ground1) = -l*sin(q_ground1)
    let residual1_by_q_ground1 = minus_l_sin_q_ground1;
    // d(close1_1)/d(q_pin1) = l*sin(q + q_pin1)
    let residual1_by_q_pin1 = l_sin_q_plus_q_pin1;
    // d(close1_2)/d(q) = -l*(cos(q) + cos(q + q_pin1))
    let residual2_by_q = residual2_by_q_of_l_q_2_q_pin1_2;
    // d(close1_2)/d(q_ground1) = l*cos(q_ground1)
    let residual2_by_q_ground1 = l_cos_q_ground1;
    // d(close1_2)/d(q_pin1) = -l*cos(q + q_pin1)
    let residual2_by_q_pin1 = residual2_by_q_pin1_of_l_q_2_q_pin1;
    // d(close2_1)/d(q_ground1) = l*(sin(q_ground1) + sin(q_ground1 + q_pin2))
    let residual3_by_q_ground1 = residual3_by_q_ground1_of_place_2;
    // d(close2_1)/d(q_ground2) = -l*sin(q_ground2)
    let residual3_by_q_ground2 = minus_l_sin_q_ground2;
    // d(close2_1)/d(q_pin2) = l*sin(q_ground1 + q_pin2)
    let residual3_by_q_pin2 = residual3_by_q_ground1_of_place;
    // d(close2_2)/d(q_ground1) = -l*(cos(q_ground1) + cos(q_ground1 + q_pin2))
    let residual4_by_q_ground1 = residual4_by_q_ground1_of_place_3;
    // d(close2_2)/d(q_ground2) = l*cos(q_ground2)
    let residual4_by_q_ground2 = l_cos_q_ground2;
    // d(close2_2)/d(q_pin2) = -l*cos(q_ground1 + q_pin2)
    let residual4_by_q_pin2 = residual4_by_q_pin2_of_place;
    // d(close1_1')/d(q) = l*(q'*cos(q) + cos(q + q_pin1)*(q' + q_pin1'))
    let residual5_by_q = q_dot_2.mul_add(l_cos_q, residual5_by_q_of_motion);
    // d(close1_1')/d(q_ground1) = -l*q_ground1'*cos(q_ground1)
    let residual5_by_q_ground1 = -residual5_by_q_ground1_of_motion;
    // d(close1_1')/d(q_pin1) = l*cos(q + q_pin1)*(q' + q_pin1')
    let residual5_by_q_pin1 = residual5_by_q_of_motion;
    // d(close1_1')/d(q') = l*(sin(q) + sin(q + q_pin1))
    let residual5_by_q_dot = residual1_by_q_of_l_q_2_q_pin1;
    // d(close1_1')/d(q_ground1') = -l*sin(q_ground1)
    let residual5_by_q_ground1_dot = minus_l_sin_q_ground1;
    // d(close1_1')/d(q_pin1') = l*sin(q + q_pin1)
    let residual5_by_q_pin1_dot = l_sin_q_plus_q_pin1;
    // d(close1_2')/d(q) = l*(q'*sin(q) + sin(q + q_pin1)*(q' + q_pin1'))
    let residual6_by_q = q_dot_2.mul_add(l_sin_q, residual6_by_q_of_motion);
    // d(close1_2')/d(q_ground1) = -l*q_ground1'*sin(q_ground1)
    let residual6_by_q_ground1 = -residual6_by_q_ground1_of_motion;
    // d(close1_2')/d(q_pin1) = l*sin(q + q_pin1)*(q' + q_pin1')
    let residual6_by_q_pin1 = residual6_by_q_of_motion;
    // d(close1_2')/d(q') = -l*(cos(q) + cos(q + q_pin1))
    let residual6_by_q_dot = residual2_by_q_of_l_q_2_q_pin1_2;
    // d(close1_2')/d(q_ground1') = l*cos(q_ground1)
    let residual6_by_q_ground1_dot = l_cos_q_ground1;
    // d(close1_2')/d(q_pin1') = -l*cos(q + q_pin1)
    let residual6_by_q_pin1_dot = residual2_by_q_pin1_of_l_q_2_q_pin1;
    // d(close2_1')/d(q_ground1) = l*(q_ground1'*cos(q_ground1) + cos(q_ground1 + q_pin2)*(q_ground1' +
    //   q_pin2'))
    let residual7_by_q_ground1 = residual5_by_q_ground1_of_motion
        + residual7_by_q_ground1_of_motion_2;
    // d(close2_1')/d(q_ground2) = -l*q_ground2'*cos(q_ground2)
    let residual7_by_q_ground2 = -q_ground2_dot * l_cos_q_ground2;
    // d(close2_1')/d(q_pin2) = l*cos(q_ground1 + q_pin2)*(q_ground1' + q_pin2')
    let residual7_by_q_pin2 = residual7_by_q_ground1_of_motion_2;
    // d(close2_1')/d(q_ground1') = l*(sin(q_ground1) + sin(q_ground1 + q_pin2))
    let residual7_by_q_ground1_dot = residual3_by_q_ground1_of_place_2;
    // d(close2_1')/d(q_ground2') = -l*sin(q_ground2)
    let residual7_by_q_ground2_dot = minus_l_sin_q_ground2;
    // d(close2_1')/d(q_pin2') = l*sin(q_ground1 + q_pin2)
    let residual7_by_q_pin2_dot = residual3_by_q_ground1_of_place;
    // d(close2_2')/d(q_ground1) = l*(q_ground1'*sin(q_ground1) + sin(q_ground1 + q_pin2)*(q_ground1' +
    //   q_pin2'))
    let residual8_by_q_ground1 = residual6_by_q_ground1_of_motion
        + residual8_by_q_ground1_of_motion;
    // d(close2_2')/d(q_ground2) = -l*q_ground2'*sin(q_ground2)
    let residual8_by_q_ground2 = -q_ground2_dot * l_sin_q_ground2;
    // d(close2_2')/d(q_pin2) = l*sin(q_ground1 + q_pin2)*(q_ground1' + q_pin2')
    let residual8_by_q_pin2 = residual8_by_q_ground1_of_motion;
    // d(close2_2')/d(q_ground1') = -l*(cos(q_ground1) + cos(q_ground1 + q_pin2))
    let residual8_by_q_ground1_dot = residual4_by_q_ground1_of_place_3;
    // d(close2_2')/d(q_ground2') = l*cos(q_ground2)
    let residual8_by_q_ground2_dot = l_cos_q_ground2;
    // d(close2_2')/d(q_pin2') = -l*cos(q_ground1 + q_pin2)
    let residual8_by_q_pin2_dot = residual4_by_q_pin2_of_place;
    let zero = S::int(0);
    [
        residual1_by_q, residual1_by_q_ground1, zero, residual1_by_q_pin1, zero, zero, zero, zero,
        zero, zero, residual2_by_q, residual2_by_q_ground1, zero, residual2_by_q_pin1, zero, zero,
        zero, zero, zero, zero, zero, residual3_by_q_ground1, residual3_by_q_ground2, zero,
        residual3_by_q_pin2, zero, zero, zero, zero, zero, zero, residual4_by_q_ground1,
        residual4_by_q_ground2, zero, residual4_by_q_pin2, zero, zero, zero, zero, zero,
        residual5_by_q, residual5_by_q_ground1, zero, residual5_by_q_pin1, zero, residual5_by_q_dot,
        residual5_by_q_ground1_dot, zero, residual5_by_q_pin1_dot, zero, residual6_by_q,
        residual6_by_q_ground1, zero, residual6_by_q_pin1, zero, residual6_by_q_dot,
        residual6_by_q_ground1_dot, zero, residual6_by_q_pin1_dot, zero, zero,
        residual7_by_q_ground1, residual7_by_q_ground2, zero, residual7_by_q_pin2, zero,
        residual7_by_q_ground1_dot, residual7_by_q_ground2_dot, zero, residual7_by_q_pin2_dot, zero,
        residual8_by_q_ground1, residual8_by_q_ground2, zero, residual8_by_q_pin2, zero,
        residual8_by_q_ground1_dot, residual8_by_q_ground2_dot, zero, residual8_by_q_pin2_dot,
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
        2
    }
    fn divisor_name(&self, at: usize) -> &str {
        ["sin(q - q_ground1 + q_pin1)", "sin(q_ground1 - q_ground2 + q_pin2)"][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn constraint_count(&self) -> usize {
        8
    }
    fn constraint_name(&self, at: usize) -> &str {
        [
            "close1_1", "close1_2", "close2_1", "close2_2", "close1_1'", "close1_2'", "close2_1'",
            "close2_2'",
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
