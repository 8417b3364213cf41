//! N-window four-bar: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/window_linkage/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

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

/// Jacobian of the derivative by the state; columns q, q_ground1, q_ground2, q_pin1, q_pin2, q', q_ground1', q_ground2', q_pin1', q_pin2'.
///
/// 1792 operations, 7 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [[S; 10]; 10] {
    let Parameters { m, l, g } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    let [q_dot_2, q_ground1_dot, _, q_pin1_dot, q_pin2_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q_pin2, cos_q_pin2) = q_pin2.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // q - q_ground1 + q_pin1
    let d1_of_place = q_2 - q_ground1 + q_pin1;
    let (sin_angle, cos_angle) = d1_of_place.sin_cos();
    let sin_angle_inv = S::int(1) / sin_angle;
    let sin_q_cos_q_ground1 = sin_q * cos_q_ground1;
    let cos_q_sin_q_ground1 = cos_q * sin_q_ground1;
    // cos_q_sin_q_ground1 - sin_q_cos_q_ground1
    let d1_of_place_2 = cos_q_sin_q_ground1 - sin_q_cos_q_ground1;
    // cos(q)*sin(q_pin1) + sin(q)*cos(q_pin1)
    let sin_q_plus_q_pin1 = sin_q.mul_add(cos_q_pin1, cos_q * sin_q_pin1);
    let d1_of_place_3 = sin_q_plus_q_pin1 * cos_q_ground1;
    let cos_q_pin1_cos_q = cos_q * cos_q_pin1;
    // cos_q_pin1_cos_q - sin(q)*sin(q_pin1)
    let cos_q_plus_q_pin1 = (-sin_q).mul_add(sin_q_pin1, cos_q_pin1_cos_q);
    let d1_of_place_4 = cos_q_plus_q_pin1 * sin_q_ground1;
    // d1_of_place_3 - d1_of_place_4
    let d1_of_place_5 = d1_of_place_3 - d1_of_place_4;
    // d1_of_place_2 - d1_of_place_5
    let d1_of_place_6 = d1_of_place_2 - d1_of_place_5;
    let d1_of_place_7 = sin_angle_inv * d1_of_place_6;
    let cos_q_pin1_times_3 = S::int(3) * cos_q_pin1;
    // 2 + cos_q_pin1_times_3
    let d1_of_q_pin1 = S::int(2) + cos_q_pin1_times_3;
    let m_l = m * l;
    let l_m_l = l * m_l;
    let l_m_l_by_6 = S::ratio(1, 6) * l_m_l;
    let sin_q_pin1_sin_angle_inv = sin_angle_inv * sin_q_pin1;
    let d1_of_place_8 = l_m_l * sin_q_pin1_sin_angle_inv;
    let d1_of_place_9 = sin_q_pin1_sin_angle_inv * d1_of_place_8;
    // q_ground1 - q_ground2 + q_pin2
    let d1_of_place_10 = q_ground1 - q_ground2 + q_pin2;
    let (sin_angle_2, cos_angle_2) = d1_of_place_10.sin_cos();
    let sin_angle_2_inv = S::int(1) / sin_angle_2;
    let d1_of_place_11 = sin_q_pin1_sin_angle_inv * sin_angle_2_inv;
    let l_m_l_d1_of_place_11 = l_m_l * d1_of_place_11;
    let d1_of_place_12 = d1_of_place_11 * l_m_l_d1_of_place_11;
    let sin_q_pin2_sin_q_ground1 = sin_q_ground1 * sin_q_pin2;
    let cos_q_pin2_cos_q_ground1 = cos_q_ground1 * cos_q_pin2;
    // cos_q_pin2_cos_q_ground1 - sin_q_pin2_sin_q_ground1
    let d1_of_place_13 = cos_q_pin2_cos_q_ground1 - sin_q_pin2_sin_q_ground1;
    // cos(q_ground1) + 2*cos(q_ground1 + q_pin2)
    let d1_of_place_14 = d1_of_place_13.mul_add(S::int(2), cos_q_ground1);
    let d1_of_place_13_sq = d1_of_place_13 * d1_of_place_13;
    // d1_of_place_14*cos(q_ground1) + d1_of_place_13_sq
    let d1_of_place_15 = d1_of_place_14.mul_add(cos_q_ground1, d1_of_place_13_sq);
    let sin_q_pin2_cos_q_ground1 = cos_q_ground1 * sin_q_pin2;
    // sin(q_ground1)*cos(q_pin2) + sin_q_pin2_cos_q_ground1
    let d1_of_place_16 = sin_q_ground1.mul_add(cos_q_pin2, sin_q_pin2_cos_q_ground1);
    // sin(q_ground1) + sin(q_ground1 + q_pin2)
    let d1_of_place_17 = sin_q_ground1 + d1_of_place_16;
    let d1_of_place_18 = d1_of_place_17 * cos_q_ground2;
    // cos(q_ground1) + cos(q_ground1 + q_pin2)
    let d1_of_place_19 = cos_q_ground1 + d1_of_place_13;
    let d1_of_place_19_doubled = S::int(2) * d1_of_place_19;
    // sin(q_ground1) + 2*sin(q_ground1 + q_pin2)
    let d1_of_place_20 = d1_of_place_16.mul_add(S::int(2), sin_q_ground1);
    let d1_of_place_16_sq = d1_of_place_16 * d1_of_place_16;
    // d1_of_place_20*sin(q_ground1) + d1_of_place_16_sq
    let d1_of_place_21 = d1_of_place_20.mul_add(sin_q_ground1, d1_of_place_16_sq);
    let cos_q_ground2_sq = cos_q_ground2 * cos_q_ground2;
    // sin(q_ground2)*(d1_of_place_15*sin(q_ground2) - d1_of_place_18*d1_of_place_19_doubled) +
    //   d1_of_place_21*cos_q_ground2_sq
    let d1_of_place_22 = sin_q_ground2
        * (-d1_of_place_18)
            .mul_add(d1_of_place_19_doubled, d1_of_place_15 * sin_q_ground2)
        + d1_of_place_21 * cos_q_ground2_sq;
    let sin_q_pin2_sq = sin_q_pin2 * sin_q_pin2;
    // sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)
    let d1_of_place_23 = cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1);
    // -d1_of_place_2
    let minus_d1_of_place_2 = -d1_of_place_2;
    // d1_of_place_23*sin(q_pin1) + minus_d1_of_place_2*cos(q_pin1)
    let d1_of_place_24 = minus_d1_of_place_2
        .mul_add(cos_q_pin1, d1_of_place_23 * sin_q_pin1);
    let d1_of_place_24_inv = S::int(1) / d1_of_place_24;
    let l_m_l_d1_of_place_24_inv = l_m_l * d1_of_place_24_inv;
    let d1_of_place_25 = S::ratio(1, 6) * sin_angle_inv * l_m_l_d1_of_place_24_inv;
    // sin_q_cos_q_ground1^2 + cos_q_sin_q_ground1^2
    let d1_of_place_26 = cos_q_sin_q_ground1
        .mul_add(cos_q_sin_q_ground1, sin_q_cos_q_ground1 * sin_q_cos_q_ground1);
    // 2*sin_q_cos_q_ground1*cos_q_sin_q_ground1 - d1_of_place_26
    let d1_of_place_27 = (sin_q_cos_q_ground1 * cos_q_sin_q_ground1)
        .mul_add(S::int(2), -d1_of_place_26);
    let d1_of_place_28 = d1_of_place_2 * d1_of_place_5;
    let d1_of_place_29 = d1_of_place_19 * sin_q_ground2;
    // d1_of_place_18 - d1_of_place_29
    let d1_of_place_30 = d1_of_place_18 - d1_of_place_29;
    let cos_q_pin2_times_3 = S::int(3) * cos_q_pin2;
    // 2 + cos_q_pin2_times_3
    let d1_of_q_pin2 = S::int(2) + cos_q_pin2_times_3;
    let d1_of_place_31 = S::ratio(1, 3) * sin_q_pin1_sin_angle_inv;
    let d1_of_place_32 = l_m_l_d1_of_place_11 * d1_of_place_31;
    let d1_of_place_33 = d1_of_q_pin2 * d1_of_place_32;
    let d1_of_place_34 = d1_of_place_23 * cos_q_pin1;
    let cos_q_pin1_l_m_l = l_m_l * cos_q_pin1;
    // l_m_l + d1_of_place_9
    let l_m_l_plus_d1_of_place_9 = l_m_l + d1_of_place_9;
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
    let d1 = d1_of_place_7 * d1_of_q_pin1 * l_m_l_by_6 + d1_of_place_9 * cos_q_pin2
        + S::ratio(1, 3) * d1_of_place_12 * (d1_of_place_22 + sin_q_pin2_sq)
        + d1_of_place_25 * cos_q_pin1_times_3.mul_add(cos_q_pin1, -S::int(2))
            * (d1_of_place_27 + d1_of_place_28) - d1_of_place_30 * d1_of_place_33
        + S::ratio(1, 2) * d1_of_place_6 * sin_q_pin1_sin_angle_inv
            * l_m_l_d1_of_place_24_inv * d1_of_place_34 + cos_q_pin1_l_m_l
        + S::ratio(5, 3) * l_m_l_plus_d1_of_place_9;
    let u_dot_of_q_dot_2 = q_dot_2 * sin_q_pin1_sin_angle_inv;
    // -d1_of_place_30
    let minus_d1_of_place_30 = -d1_of_place_30;
    let q_dot_2_d1_of_place_11 = q_dot_2 * d1_of_place_11;
    let u_dot_of_q_dot_2_2 = minus_d1_of_place_30 * q_dot_2_d1_of_place_11;
    // u_dot_of_q_dot_2 + u_dot_of_q_dot_2_2
    let u_dot_of_q_dot_2_3 = u_dot_of_q_dot_2 + u_dot_of_q_dot_2_2;
    let u_dot_of_q_dot_2_4 = d1_of_place_16 * u_dot_of_q_dot_2_3;
    // u_dot_of_q_dot_2*sin(q_ground1) + u_dot_of_q_dot_2_4
    let u_dot_of_q_dot_2_5 = u_dot_of_q_dot_2.mul_add(sin_q_ground1, u_dot_of_q_dot_2_4);
    let u_dot_of_q_dot_2_6 = d1_of_place_13 * u_dot_of_q_dot_2_3;
    // u_dot_of_q_dot_2*cos(q_ground1) + u_dot_of_q_dot_2_6
    let u_dot_of_q_dot_2_7 = u_dot_of_q_dot_2.mul_add(cos_q_ground1, u_dot_of_q_dot_2_6);
    let u_dot_of_place = d1_of_place_19 * cos_q_ground2;
    // d1_of_place_17*sin(q_ground2) + u_dot_of_place
    let u_dot_of_place_2 = d1_of_place_17.mul_add(sin_q_ground2, u_dot_of_place);
    let u_dot_of_q_dot_2_8 = q_dot_2_d1_of_place_11 * sin_q_pin2;
    // u_dot_of_place_2*u_dot_of_q_dot_2_8 - u_dot_of_q_dot_2_5*sin(q_ground2) -
    //   u_dot_of_q_dot_2_7*cos(q_ground2)
    let u_dot_of_q_dot_2_9 = (-u_dot_of_q_dot_2_5)
        .mul_add(sin_q_ground2, u_dot_of_place_2 * u_dot_of_q_dot_2_8)
        - u_dot_of_q_dot_2_7 * cos_q_ground2;
    let q_dot_2_sin_angle_inv = q_dot_2 * sin_angle_inv;
    let u_dot_of_q_dot_2_10 = sin_angle_2_inv * q_dot_2_sin_angle_inv;
    let u_dot_of_q_dot_2_11 = q_dot_2_sin_angle_inv * u_dot_of_q_dot_2_10;
    // sin(q) + sin(q + q_pin1)
    let u_dot_of_q_2_q_pin1 = sin_q + sin_q_plus_q_pin1;
    let u_dot_of_place_3 = u_dot_of_q_2_q_pin1 * cos_q_ground1;
    // cos(q) + cos(q + q_pin1)
    let u_dot_of_q_2_q_pin1_2 = cos_q + cos_q_plus_q_pin1;
    let u_dot_of_place_4 = u_dot_of_q_2_q_pin1_2 * sin_q_ground1;
    // u_dot_of_place_3 - u_dot_of_place_4
    let u_dot_of_place_5 = u_dot_of_place_3 - u_dot_of_place_4;
    // -u_dot_of_place_5
    let minus_u_dot_of_place_5 = -u_dot_of_place_5;
    let u_dot_of_place_6 = minus_u_dot_of_place_5 * cos_q_pin1;
    let u_dot_of_q_dot_2_12 = q_dot_2_sin_angle_inv * minus_u_dot_of_place_5;
    // 1 - sin_q_pin1_sin_angle_inv
    let u_dot_of_place_7 = S::int(1) - sin_q_pin1_sin_angle_inv;
    let q_dot_2_u_dot_of_place_7 = q_dot_2 * u_dot_of_place_7;
    // u_dot_of_q_dot_2_12 + q_dot_2_u_dot_of_place_7
    let u_dot_of_q_dot_2_13 = u_dot_of_q_dot_2_12 + q_dot_2_u_dot_of_place_7;
    let u_dot_of_q_dot_2_14 = q_dot_2_sin_angle_inv * cos_angle;
    let u_dot_of_q_dot_2_15 = d1_of_place_11 * u_dot_of_q_dot_2_14;
    let u_dot_of_q_dot_2_16 = u_dot_of_q_dot_2_13 * u_dot_of_q_dot_2_15;
    // u_dot_of_q_dot_2_11*u_dot_of_place_6 - u_dot_of_q_dot_2_16
    let u_dot_of_q_dot_2_17 = u_dot_of_q_dot_2_11
        .mul_add(u_dot_of_place_6, -u_dot_of_q_dot_2_16);
    // u_dot_of_q_dot_2 - u_dot_of_q_dot_2_8
    let u_dot_of_q_dot_2_18 = u_dot_of_q_dot_2 - u_dot_of_q_dot_2_8;
    // u_dot_of_q_dot_2_2 + u_dot_of_q_dot_2_18
    let u_dot_of_q_dot_2_19 = u_dot_of_q_dot_2_2 + u_dot_of_q_dot_2_18;
    let u_dot_of_place_8 = sin_angle_2_inv * cos_angle_2;
    let u_dot_of_q_dot_2_20 = q_dot_2_d1_of_place_11 * u_dot_of_place_8;
    let u_dot_of_q_dot_2_21 = minus_d1_of_place_30 * u_dot_of_q_dot_2_20;
    // q_dot_2_d1_of_place_11*u_dot_of_q_dot_2_9 + minus_d1_of_place_30*u_dot_of_q_dot_2_17 -
    //   u_dot_of_q_dot_2_19*u_dot_of_q_dot_2_21
    let u_dot_of_q_dot_2_22 = minus_d1_of_place_30
        .mul_add(u_dot_of_q_dot_2_17, q_dot_2_d1_of_place_11 * u_dot_of_q_dot_2_9)
        - u_dot_of_q_dot_2_19 * u_dot_of_q_dot_2_21;
    let u_dot_of_place_9 = sin_angle_2_inv * minus_d1_of_place_30;
    // d1_of_q_pin2 + 2*u_dot_of_place_9
    let u_dot_of_place_10 = u_dot_of_place_9.mul_add(S::int(2), d1_of_q_pin2);
    let u_dot_of_place_11 = d1_of_place_8 * u_dot_of_place_10;
    // q_pin2'^2 + q_ground1'*(2*q_pin2' - q_ground1'*u_dot_of_place_9)
    let u_dot_of_motion = q_ground1_dot
        * (-q_ground1_dot).mul_add(u_dot_of_place_9, S::int(2) * q_pin2_dot)
        + q_pin2_dot * q_pin2_dot;
    let q_dot_2_sq = q_dot_2 * q_dot_2;
    // 1 + u_dot_of_place_9
    let u_dot_of_place_12 = S::int(1) + u_dot_of_place_9;
    let u_dot_of_place_13 = sin_angle_2_inv * sin_q_pin2;
    // l*(u_dot_of_motion*sin(q_pin2) - minus_u_dot_of_place_5*q_dot_2_sq) - g*(3*cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)*u_dot_of_place_12 + u_dot_of_place_13*cos(q_ground2))
    let u_dot_of_motion_2 = l
        * (-minus_u_dot_of_place_5).mul_add(q_dot_2_sq, u_dot_of_motion * sin_q_pin2)
        - g
            * (d1_of_place_13.mul_add(u_dot_of_place_12, S::int(3) * cos_q_ground1)
                + u_dot_of_place_13 * cos_q_ground2);
    let g_cos_q_plus_q_pin1 = g * cos_q_plus_q_pin1;
    // u_dot_of_motion_2*sin(q_pin1) - minus_u_dot_of_place_5*g_cos_q_plus_q_pin1
    let u_dot_of_motion_3 = (-minus_u_dot_of_place_5)
        .mul_add(g_cos_q_plus_q_pin1, u_dot_of_motion_2 * sin_q_pin1);
    let l_sin_q_pin1 = l * sin_q_pin1;
    // q_pin1'*(2*q' + q_pin1')
    let u_dot_of_motion_4 = q_pin1_dot * q_dot_2.mul_add(S::int(2), q_pin1_dot);
    let m_l_times_3 = S::int(3) * m_l;
    let cos_angle_sin_angle_inv = sin_angle_inv * cos_angle;
    // sin(q_pin2) + d1_of_place_30
    let u_dot_of_place_14 = sin_q_pin2 + d1_of_place_30;
    let u_dot_of_place_15 = sin_angle_2_inv * u_dot_of_place_14;
    // u_dot_of_place_8*(u_dot_of_place_15 - 1)
    let u_dot_of_place_16 = u_dot_of_place_8 * (u_dot_of_place_15 - S::int(1));
    // cos_angle_sin_angle_inv + u_dot_of_place_16
    let u_dot_of_place_17 = cos_angle_sin_angle_inv + u_dot_of_place_16;
    let u_dot_of_place_18 = sin_angle_inv * minus_u_dot_of_place_5;
    // 1 + u_dot_of_place_18
    let u_dot_of_place_19 = S::int(1) + u_dot_of_place_18;
    let u_dot_of_place_20 = u_dot_of_place_19 * cos_angle;
    // u_dot_of_place_17*sin(q_pin1) - u_dot_of_place_20
    let u_dot_of_place_21 = u_dot_of_place_17.mul_add(sin_q_pin1, -u_dot_of_place_20);
    let u_dot_of_place_22 = sin_angle_2_inv * sin_q_pin1;
    let u_dot_of_place_23 = u_dot_of_place_22 * cos_q_pin2;
    // u_dot_of_place_21*sin(q_pin2) + minus_d1_of_place_30*u_dot_of_place_23
    let u_dot_of_place_24 = minus_d1_of_place_30
        .mul_add(u_dot_of_place_23, u_dot_of_place_21 * sin_q_pin2);
    // u_dot_of_place_6*sin(q_pin2) + u_dot_of_place_24*sin(q_pin1)
    let u_dot_of_place_25 = u_dot_of_place_24
        .mul_add(sin_q_pin1, u_dot_of_place_6 * sin_q_pin2);
    let sin_q_pin2_doubled = S::int(2) * sin_q_pin2;
    let u_dot_of_place_26 = l_m_l_d1_of_place_11 * sin_q_pin2_doubled;
    // sin(q_pin1) + u_dot_of_place_5
    let u_dot_of_place_27 = sin_q_pin1 + u_dot_of_place_5;
    // sin_angle_inv*u_dot_of_place_27 - 1
    let u_dot_of_place_28 = sin_angle_inv.mul_add(u_dot_of_place_27, -S::int(1));
    let u_dot_of_place_29 = u_dot_of_place_28 * sin_q_pin1;
    // u_dot_of_place_6 + u_dot_of_place_29*cos(q - q_ground1 + q_pin1)
    let u_dot_of_place_30 = u_dot_of_place_29.mul_add(cos_angle, u_dot_of_place_6);
    let d1_of_place_30_doubled = S::int(2) * d1_of_place_30;
    // sin_angle_2_inv*(cos_q_pin2_times_3*minus_d1_of_place_30 - d1_of_place_30_doubled)
    let u_dot_of_place_31 = sin_angle_2_inv
        * cos_q_pin2_times_3.mul_add(minus_d1_of_place_30, -d1_of_place_30_doubled);
    // 10 + 6*cos(q_pin2) + u_dot_of_place_31
    let u_dot_of_place_32 = cos_q_pin2.mul_add(S::int(6), S::int(10)) + u_dot_of_place_31;
    let u_dot_of_place_33 = d1_of_place_8 * u_dot_of_place_32;
    // sin_angle_2_inv*u_dot_of_place_25*u_dot_of_place_26 + u_dot_of_place_30*u_dot_of_place_33
    let u_dot_of_place_34 = u_dot_of_place_30
        .mul_add(
            u_dot_of_place_33,
            sin_angle_2_inv * u_dot_of_place_25 * u_dot_of_place_26,
        );
    let q_dot_2_sin_angle_inv_sq = q_dot_2_sin_angle_inv * q_dot_2_sin_angle_inv;
    // q' + u_dot_of_q_dot_2_12
    let u_dot_of_q_dot_2_23 = q_dot_2 + u_dot_of_q_dot_2_12;
    let u_dot_of_q_dot_2_24 = sin_q_plus_q_pin1 * u_dot_of_q_dot_2_23;
    // q'*sin(q) + u_dot_of_q_dot_2_24
    let u_dot_of_q_dot_2_25 = q_dot_2.mul_add(sin_q, u_dot_of_q_dot_2_24);
    let u_dot_of_q_dot_2_26 = cos_q_plus_q_pin1 * u_dot_of_q_dot_2_23;
    // q'*cos(q) + u_dot_of_q_dot_2_26
    let u_dot_of_q_dot_2_27 = q_dot_2.mul_add(cos_q, u_dot_of_q_dot_2_26);
    let u_dot_of_place_35 = u_dot_of_q_2_q_pin1_2 * cos_q_ground1;
    let u_dot_of_place_36 = u_dot_of_q_2_q_pin1 * sin_q_ground1;
    // u_dot_of_place_35 + u_dot_of_place_36
    let u_dot_of_place_37 = u_dot_of_place_35 + u_dot_of_place_36;
    // u_dot_of_q_dot_2*u_dot_of_place_37 - u_dot_of_q_dot_2_25*sin(q_ground1) -
    //   u_dot_of_q_dot_2_27*cos(q_ground1)
    let u_dot_of_q_dot_2_28 = (-u_dot_of_q_dot_2_25)
        .mul_add(sin_q_ground1, u_dot_of_q_dot_2 * u_dot_of_place_37)
        - u_dot_of_q_dot_2_27 * cos_q_ground1;
    let u_dot_of_q_dot_2_29 = sin_angle_inv * u_dot_of_q_dot_2_14;
    let u_dot_of_q_dot_2_30 = minus_u_dot_of_place_5 * u_dot_of_q_dot_2_29;
    // u_dot_of_q_dot_2_13*u_dot_of_q_dot_2_30 - q_dot_2_sin_angle_inv*u_dot_of_q_dot_2_28
    let u_dot_of_q_dot_2_31 = (-q_dot_2_sin_angle_inv)
        .mul_add(u_dot_of_q_dot_2_28, u_dot_of_q_dot_2_13 * u_dot_of_q_dot_2_30);
    // -2*d1_of_place_2 - cos_q_pin1_times_3*d1_of_place_24
    let u_dot_of_place_38 = (-cos_q_pin1_times_3)
        .mul_add(d1_of_place_24, -S::int(2) * d1_of_place_2);
    let u_dot_of_place_39 = l_m_l_d1_of_place_24_inv * u_dot_of_place_38;
    let d1_inv = S::int(1) / d1;
    let d1_inv_by_6 = S::ratio(1, 6) * d1_inv;
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
    let u_dot = -d1_inv_by_6
        * (m_l_times_3
            * (g * cos_q.mul_add(S::int(3), cos_q_plus_q_pin1)
                - sin_angle_inv * u_dot_of_motion_3 - l_sin_q_pin1 * u_dot_of_motion_4)
            + u_dot_of_q_dot_2_22 * u_dot_of_place_11 + u_dot_of_place_34 * q_dot_2_sin_angle_inv_sq
            + u_dot_of_q_dot_2_31 * u_dot_of_place_39);
    // l_m_l_d1_of_place_11*minus_d1_of_place_30*u_dot_of_place_10 + u_dot_of_place_33
    let d1_by_q_of_place = (l_m_l_d1_of_place_11 * minus_d1_of_place_30)
        .mul_add(u_dot_of_place_10, u_dot_of_place_33);
    let d1_by_q_of_place_2 = minus_u_dot_of_place_5 * cos_angle_sin_angle_inv;
    // u_dot_of_place_37 + d1_by_q_of_place_2
    let d1_by_q_of_place_3 = u_dot_of_place_37 + d1_by_q_of_place_2;
    let d1_by_q_of_place_4 = d1_of_place_25 * u_dot_of_place_38;
    let d1_by_q_of_place_5 = sin_angle_inv * cos_angle_sin_angle_inv;
    // d1_by_q_of_place_5*(3*u_dot_of_place_6 - 2*u_dot_of_place_5)
    let d1_by_q_of_place_6 = d1_by_q_of_place_5
        * (-u_dot_of_place_5).mul_add(S::int(2), S::int(3) * u_dot_of_place_6);
    let d1_by_q_of_place_7 = S::ratio(2, 3) * d1_of_place_12;
    let d1_by_q_of_place_8 = d1_by_q_of_place_7 * sin_q_pin2;
    // minus_d1_of_place_2*sin(q_pin1) - d1_of_place_34
    let d1_by_q_of_place_9 = minus_d1_of_place_2.mul_add(sin_q_pin1, -d1_of_place_34);
    let d1_by_q_of_place_10 = d1_of_place_24_inv * u_dot_of_place_38 * d1_by_q_of_place_9;
    // 2*d1_of_place_23 + cos_q_pin1_times_3*d1_by_q_of_place_9
    let d1_by_q_of_place_11 = cos_q_pin1_times_3
        .mul_add(d1_by_q_of_place_9, S::int(2) * d1_of_place_23);
    // d1_by_q_of_place_10 + d1_by_q_of_place_11
    let d1_by_q_of_place_12 = d1_by_q_of_place_10 + d1_by_q_of_place_11;
    let d1_by_q_of_place_13 = d1_of_place_25 * minus_u_dot_of_place_5;
    // cos_angle_sin_angle_inv*d1_by_q_of_place_8*sin(q_pin2) + d1_by_q_of_place_12*d1_by_q_of_place_13
    let d1_by_q_of_place_14 = d1_by_q_of_place_12
        .mul_add(
            d1_by_q_of_place_13,
            cos_angle_sin_angle_inv * d1_by_q_of_place_8 * sin_q_pin2,
        );
    // d1_by_q_of_place_3*d1_by_q_of_place_4 - d1_of_place_31*cos_angle_sin_angle_inv*d1_by_q_of_place
    let d1_by_q_of_place_15 = (-(d1_of_place_31 * cos_angle_sin_angle_inv))
        .mul_add(d1_by_q_of_place, d1_by_q_of_place_3 * d1_by_q_of_place_4);
    // l_m_l_by_6*(sin_angle_inv*d1_of_q_pin1*u_dot_of_place_37 + d1_by_q_of_place_6) + d1_by_q_of_place_14
    let d1_by_q_of_place_16 = l_m_l_by_6
        * (sin_angle_inv * d1_of_q_pin1).mul_add(u_dot_of_place_37, d1_by_q_of_place_6)
        + d1_by_q_of_place_14;
    // d1_by_q = m*l^2*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))*(2*sin(q)*cos(q_ground1) - 2*cos(q)*sin(q_ground1) -
    //   3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))/(6*sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + m*l^2*(sin(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))*(2*sin(q)*cos(q_ground1) -
    //   2*cos(q)*sin(q_ground1) - 3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))/(6*sin(q - q_ground1 +
    //   q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) - m*l^2*((2*sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - 2*cos(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   3*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1))))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + (2*sin(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + 2*cos(q_ground1)*(cos(q) + cos(q + q_pin1)) +
    //   3*cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1))))/sin(q - q_ground1 + q_pin1))/6 + m*l^2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) -
    //   sin(q_ground1)*(cos(q) + cos(q + q_pin1)))*(2*sin(q)*cos(q_ground1) - 2*cos(q)*sin(q_ground1) -
    //   3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)) - cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))/(6*sin(q -
    //   q_ground1 + q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) + m*l^2*(cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))*(2*sin(q)*sin(q_ground1) +
    //   2*cos(q)*cos(q_ground1) + 3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))
    //   - cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))))/(6*sin(q - q_ground1 +
    //   q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) +
    //   2*m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(3*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2*tan(q_ground1 - q - q_pin1)) + m*l^2*sin(q_pin1)^2*(10 + 6*cos(q_pin2) +
    //   (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + 3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))
    //   - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(3*sin(q - q_ground1 + q_pin1)^2*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*sin(q_pin1)^2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(2 + 3*cos(q_pin2) +
    //   2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/(3*sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1))
    let d1_by_q = d1_by_q_of_place_15 - d1_by_q_of_place_16;
    let u_dot_by_q_of_q_dot_2 = sin_q_pin1_sin_angle_inv * u_dot_of_q_dot_2_14;
    let u_dot_by_q_of_q_dot_2_2 = minus_d1_of_place_30 * u_dot_of_q_dot_2_15;
    // u_dot_by_q_of_q_dot_2 + u_dot_by_q_of_q_dot_2_2
    let u_dot_by_q_of_q_dot_2_3 = u_dot_by_q_of_q_dot_2 + u_dot_by_q_of_q_dot_2_2;
    let u_dot_by_q_of_q_dot_2_4 = u_dot_by_q_of_q_dot_2 * sin_q_ground1;
    let u_dot_by_q_of_q_dot_2_5 = u_dot_by_q_of_q_dot_2 * cos_q_ground1;
    let u_dot_by_q_of_q_dot_2_6 = u_dot_of_q_dot_2_15 * sin_q_pin2;
    let u_dot_by_q_of_q_dot_2_7 = u_dot_of_place_2 * u_dot_by_q_of_q_dot_2_6;
    // q_dot_2_sin_angle_inv*u_dot_of_place_37 + u_dot_of_q_dot_2_30
    let u_dot_by_q_of_q_dot_2_8 = q_dot_2_sin_angle_inv
        .mul_add(u_dot_of_place_37, u_dot_of_q_dot_2_30);
    // u_dot_by_q_of_q_dot_2 - u_dot_by_q_of_q_dot_2_8
    let u_dot_by_q_of_q_dot_2_9 = u_dot_by_q_of_q_dot_2 - u_dot_by_q_of_q_dot_2_8;
    let u_dot_by_q_of_q_dot_2_10 = u_dot_of_q_dot_2_10 * cos_q_pin1;
    // u_dot_of_q_dot_2_30*u_dot_by_q_of_q_dot_2_10 - u_dot_of_q_dot_2_16*cos_angle_sin_angle_inv
    let u_dot_by_q_of_q_dot_2_11 = (-u_dot_of_q_dot_2_16)
        .mul_add(
            cos_angle_sin_angle_inv,
            u_dot_of_q_dot_2_30 * u_dot_by_q_of_q_dot_2_10,
        );
    let u_dot_by_q_of_q_dot_2_12 = S::int(2) * u_dot_by_q_of_q_dot_2_11;
    let u_dot_by_q_of_place = u_dot_of_place_37 * cos_q_pin1;
    let u_dot_by_q_of_place_2 = minus_d1_of_place_30 * u_dot_of_place_8;
    // u_dot_of_q_dot_2_19*u_dot_by_q_of_place_2 - u_dot_of_q_dot_2_9
    let u_dot_by_q_of_q_dot_2_13 = u_dot_of_q_dot_2_19
        .mul_add(u_dot_by_q_of_place_2, -u_dot_of_q_dot_2_9);
    // minus_d1_of_place_30*(u_dot_of_q_dot_2_11*u_dot_by_q_of_place -
    //   q_dot_2_d1_of_place_11*u_dot_of_q_dot_2_13) - u_dot_of_q_dot_2_15*u_dot_by_q_of_q_dot_2_13
    let u_dot_by_q_of_q_dot_2_14 = minus_d1_of_place_30
        * (-q_dot_2_d1_of_place_11)
            .mul_add(u_dot_of_q_dot_2_13, u_dot_of_q_dot_2_11 * u_dot_by_q_of_place)
        - u_dot_of_q_dot_2_15 * u_dot_by_q_of_q_dot_2_13;
    // minus_d1_of_place_30*(u_dot_of_q_dot_2_15*u_dot_by_q_of_q_dot_2_9 + u_dot_by_q_of_q_dot_2_12) +
    //   u_dot_by_q_of_q_dot_2_14
    let u_dot_by_q_of_q_dot_2_15 = minus_d1_of_place_30
        * u_dot_of_q_dot_2_15.mul_add(u_dot_by_q_of_q_dot_2_9, u_dot_by_q_of_q_dot_2_12)
        + u_dot_by_q_of_q_dot_2_14;
    // g_cos_q_plus_q_pin1 + q_dot_2_sq*l_sin_q_pin1
    let u_dot_by_q_of_q_dot_2_16 = q_dot_2_sq.mul_add(l_sin_q_pin1, g_cos_q_plus_q_pin1);
    let g_sin_q_plus_q_pin1 = g * sin_q_plus_q_pin1;
    let u_dot_by_q_of_place_3 = minus_u_dot_of_place_5 * g_sin_q_plus_q_pin1;
    let u_dot_by_q_of_motion = u_dot_of_motion_3 * d1_by_q_of_place_5;
    // u_dot_of_q_dot_2*u_dot_of_place_5 + u_dot_of_place_37*u_dot_by_q_of_q_dot_2
    let u_dot_by_q_of_q_dot_2_17 = u_dot_of_place_37
        .mul_add(u_dot_by_q_of_q_dot_2, u_dot_of_q_dot_2 * u_dot_of_place_5);
    let u_dot_by_q_of_place_4 = S::int(2) * cos_angle_sin_angle_inv;
    // u_dot_of_q_dot_2_13*(u_dot_of_q_dot_2_12 + u_dot_of_q_dot_2_30*u_dot_by_q_of_place_4) -
    //   u_dot_of_q_dot_2_28*u_dot_of_q_dot_2_29
    let u_dot_by_q_of_q_dot_2_18 = u_dot_of_q_dot_2_13
        * u_dot_of_q_dot_2_30.mul_add(u_dot_by_q_of_place_4, u_dot_of_q_dot_2_12)
        - u_dot_of_q_dot_2_28 * u_dot_of_q_dot_2_29;
    let u_dot_by_q_of_q_dot_2_19 = u_dot_of_q_dot_2_13 * u_dot_of_q_dot_2_29;
    // u_dot_of_place_37*u_dot_by_q_of_q_dot_2_19 - u_dot_of_q_dot_2_30*u_dot_by_q_of_q_dot_2_9
    let u_dot_by_q_of_q_dot_2_20 = (-u_dot_of_q_dot_2_30)
        .mul_add(u_dot_by_q_of_q_dot_2_9, u_dot_of_place_37 * u_dot_by_q_of_q_dot_2_19);
    // u_dot_by_q_of_q_dot_2_18 + u_dot_by_q_of_q_dot_2_20
    let u_dot_by_q_of_q_dot_2_21 = u_dot_by_q_of_q_dot_2_18 + u_dot_by_q_of_q_dot_2_20;
    let u_dot_by_q_of_place_5 = cos_angle_sin_angle_inv * cos_angle_sin_angle_inv;
    let u_dot_by_q_of_place_6 = u_dot_of_place_19 * sin_angle;
    // sin(q_pin1)*(1 + u_dot_by_q_of_place_5) - u_dot_by_q_of_place_6
    let u_dot_by_q_of_place_7 = sin_q_pin1 * (S::int(1) + u_dot_by_q_of_place_5)
        - u_dot_by_q_of_place_6;
    let u_dot_by_q_of_place_8 = sin_angle_inv * d1_by_q_of_place_3 * cos_angle;
    let sin_q_pin1_sin_q_pin2 = sin_q_pin1 * sin_q_pin2;
    let u_dot_by_q_of_place_9 = u_dot_by_q_of_place * sin_q_pin2;
    let u_dot_by_q_of_q_dot_2_22 = u_dot_of_q_dot_2_11 * u_dot_of_place_26;
    let u_dot_by_q_of_q_dot_2_23 = u_dot_of_q_dot_2_22 * u_dot_of_place_10;
    let u_dot_by_q_of_place_10 = u_dot_of_place_27 * d1_by_q_of_place_5;
    let sin_q_pin1_cos_angle = sin_q_pin1 * cos_angle;
    let u_dot_by_q_of_place_11 = u_dot_of_place_29 * sin_angle;
    let u_dot_by_q_of_q_dot_2_24 = u_dot_of_place_32 * q_dot_2_sin_angle_inv_sq;
    let u_dot_by_q_of_q_dot_2_25 = l_m_l_d1_of_place_24_inv * u_dot_of_q_dot_2_31;
    let u_dot_by_q_of_q_dot_2_26 = S::int(3) * q_dot_2_sin_angle_inv * u_dot_of_place_34
        * u_dot_of_q_dot_2_29;
    // d1_by_q_of_place_12*u_dot_by_q_of_q_dot_2_25 - u_dot_by_q_of_q_dot_2_26
    let u_dot_by_q_of_q_dot_2_27 = d1_by_q_of_place_12
        .mul_add(u_dot_by_q_of_q_dot_2_25, -u_dot_by_q_of_q_dot_2_26);
    // d1_of_place_8*(cos_angle_sin_angle_inv*u_dot_by_q_of_q_dot_2_23 +
    //   u_dot_by_q_of_q_dot_2_24*(u_dot_by_q_of_place + sin_q_pin1_cos_angle*(u_dot_by_q_of_place_10 -
    //   sin_angle_inv*u_dot_of_place_37) + u_dot_by_q_of_place_11)) - u_dot_by_q_of_q_dot_2_27
    let u_dot_by_q_of_q_dot_2_28 = d1_of_place_8
        * (u_dot_by_q_of_q_dot_2_24
            * (u_dot_by_q_of_place
                + sin_q_pin1_cos_angle
                    * (-sin_angle_inv).mul_add(u_dot_of_place_37, u_dot_by_q_of_place_10)
                + u_dot_by_q_of_place_11) + cos_angle_sin_angle_inv * u_dot_by_q_of_q_dot_2_23)
        - u_dot_by_q_of_q_dot_2_27;
    let u_dot_d1_inv = u_dot * d1_inv;
    // u_dot_by_q = (6*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q)
    //   + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q - q_ground1 + q_pin1)) +
    //   3*m*l^2*q'^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)^3*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*q'^2*sin(q_pin1)*(sin(q_pin1)*sin(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1) + cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   cos(q_ground1)*(cos(q) + cos(q + q_pin1))) - sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) + (sin(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))*(10 + 6*cos(q_pin2) +
    //   (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + 3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))
    //   - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 +
    //   2*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1))) + sin(q_pin1)*sin(q_pin2)*(sin(q_pin1)*(1 +
    //   1/tan(q - q_ground1 + q_pin1)^2) - sin(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)) - cos(q -
    //   q_ground1 + q_pin1)*((sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + (sin(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/(sin(q
    //   - q_ground1 + q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*sin(q_pin1)*(2 +
    //   3*cos(q_pin2) + 2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + m*l^2*(2*cos(q)*sin(q_ground1) - 2*sin(q)*cos(q_ground1) +
    //   3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))*(q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*(cos(q_ground1)*(q'*cos(q) + cos(q +
    //   q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))) - q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q +
    //   q_pin1))/sin(q - q_ground1 + q_pin1) - q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q +
    //   q_pin1))/sin(q - q_ground1 + q_pin1) + sin(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' +
    //   q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))))/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 -
    //   m*l^2*(2*sin(q)*sin(q_ground1) + 2*cos(q)*cos(q_ground1) +
    //   3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))))*(q'*(sin(q_ground1)*(cos(q) + cos(q +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(2*sin(q)*cos(q_ground1) -
    //   2*cos(q)*sin(q_ground1) - 3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(q'*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) + 2*q'*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) +
    //   q'*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))*(q' -
    //   q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*(q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q +
    //   q_pin1))/sin(q - q_ground1 + q_pin1) + q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q +
    //   q_pin1))/sin(q - q_ground1 + q_pin1) - cos(q_ground1)*(q'*cos(q) + cos(q + q_pin1)*(q' +
    //   q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))) - sin(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q)
    //   + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) + q'*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q'*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - q'*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) +
    //   q'*(q'*sin(q_ground1)*sin(q_pin1)*(cos(q) + cos(q + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   q'*cos(q_ground1)*sin(q_pin1)*(sin(q) + sin(q + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) - q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) - sin(q_ground1)*(q'*cos(q) + cos(q + q_pin1)*(q' +
    //   q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1)) - sin(q + q_pin1)*(q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))
    //   + q'*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))) + cos(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q)
    //   + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)) + cos(q
    //   + q_pin1)*(q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*(sin(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*sin(q_pin1)*(2 + 3*cos(q_pin2)
    //   + 2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*q'^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   q'^2*cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + q'*sin(q_pin1)*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(q' -
    //   q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + 2*q'*sin(q_pin1)*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(q' -
    //   q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)^2) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q - q_pin1)*tan(q_ground1 - q_ground2 + q_pin2)) +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - q'*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q -
    //   q_ground1 + q_pin1)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   q'*sin(q_pin1)*(q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 +
    //   q_pin1)) + q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 +
    //   q_pin1)) - sin(q_ground2)*(q'*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) + sin(q_ground1 + q_pin2)*(q'*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))) -
    //   cos(q_ground2)*(q'*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + cos(q_ground1 + q_pin2)*(q'*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) + 3*m*l*(g*(3*sin(q) +
    //   sin(q + q_pin1)) + (g*sin(q + q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + g*cos(q + q_pin1)*(sin(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1))) + l*q'^2*sin(q_pin1)*(sin(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1))))/sin(q - q_ground1 + q_pin1) +
    //   (g*cos(q + q_pin1)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1))) + sin(q_pin1)*(l*(q'^2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q)
    //   + cos(q + q_pin1))) + sin(q_pin2)*(q_pin2'^2 +
    //   q_ground1'*(q_ground1'*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   2*q_pin2'))) - g*(3*cos(q_ground1) + cos(q_ground2)*sin(q_pin2)/sin(q_ground1 - q_ground2 + q_pin2)
    //   + cos(q_ground1 + q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2)))))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/(6*d1) +
    //   d1_by_q*(2*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) - m*l^2*(2*cos(q)*sin(q_ground1) -
    //   2*sin(q)*cos(q_ground1) + 3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(q'*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   q'*(cos(q_ground1)*(q'*cos(q) + cos(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1))
    //   - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))) -
    //   q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*q'^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + m*l^2*sin(q_pin1)*(2 + 3*cos(q_pin2) +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) -
    //   3*m*l*(l*q_pin1'*sin(q_pin1)*(2*q' + q_pin1') - g*(3*cos(q) + cos(q + q_pin1)) + (g*cos(q +
    //   q_pin1)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))) +
    //   sin(q_pin1)*(l*(q'^2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1))) + sin(q_pin2)*(q_pin2'^2 + q_ground1'*(q_ground1'*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + 2*q_pin2'))) - g*(3*cos(q_ground1) +
    //   cos(q_ground2)*sin(q_pin2)/sin(q_ground1 - q_ground2 + q_pin2) + cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q - q_ground1 +
    //   q_pin1)))/(6*d1^2)
    let u_dot_by_q = d1_inv_by_6
        * (u_dot_of_place_11
            * (u_dot_of_q_dot_2_21 * (u_dot_by_q_of_q_dot_2_6 - u_dot_by_q_of_q_dot_2_3)
                + q_dot_2_d1_of_place_11
                    * (u_dot_by_q_of_q_dot_2_7
                        - sin_q_ground2
                            * d1_of_place_16
                                .mul_add(u_dot_by_q_of_q_dot_2_3, u_dot_by_q_of_q_dot_2_4)
                        - cos_q_ground2
                            * d1_of_place_13
                                .mul_add(u_dot_by_q_of_q_dot_2_3, u_dot_by_q_of_q_dot_2_5))
                + u_dot_by_q_of_q_dot_2_15)
            + m_l_times_3
                * (g * sin_q.mul_add(S::int(3), sin_q_plus_q_pin1)
                    + sin_angle_inv
                        * u_dot_of_place_37
                            .mul_add(u_dot_by_q_of_q_dot_2_16, u_dot_by_q_of_place_3)
                    - u_dot_by_q_of_motion)
            + u_dot_of_place_39
                * (q_dot_2_sin_angle_inv
                    * (cos_q_ground1
                        * cos_q_plus_q_pin1
                            .mul_add(u_dot_by_q_of_q_dot_2_8, u_dot_of_q_dot_2_25)
                        - sin_q_ground1
                            * (-sin_q_plus_q_pin1)
                                .mul_add(u_dot_by_q_of_q_dot_2_8, u_dot_of_q_dot_2_27)
                        - u_dot_by_q_of_q_dot_2_17) + u_dot_by_q_of_q_dot_2_21)
            + u_dot_by_q_of_q_dot_2_22
                * (sin_q_pin1_sin_q_pin2 * (u_dot_by_q_of_place_7 - u_dot_by_q_of_place_8)
                    + u_dot_by_q_of_place_9) + u_dot_by_q_of_q_dot_2_28) - d1_by_q * u_dot_d1_inv;
    let q_ground1_ddot_by_q_of_u_dot = u_dot * cos_angle_sin_angle_inv;
    // q_ground1_ddot_by_q_of_u_dot - u_dot_by_q
    let q_ground1_ddot_by_q_of_u_dot_2 = q_ground1_ddot_by_q_of_u_dot - u_dot_by_q;
    // sin_q_pin1_sin_angle_inv*cos(q - q_ground1 + q_pin1) - cos(q_pin1)
    let q_ground1_ddot_by_q_of_place = sin_q_pin1_sin_angle_inv
        .mul_add(cos_angle, -cos_q_pin1);
    let q_ground1_ddot_by_q_of_q_dot_2 = q_dot_2_sin_angle_inv * q_ground1_ddot_by_q_of_place;
    let q_ground1_ddot_by_q_of_place_2 = cos_q_plus_q_pin1 * cos_q_ground1;
    let q_ground1_ddot_by_q_of_place_3 = sin_q_plus_q_pin1 * sin_q_ground1;
    // q_ground1_ddot_by_q_of_place_2 + q_ground1_ddot_by_q_of_place_3
    let q_ground1_ddot_by_q_of_place_4 = q_ground1_ddot_by_q_of_place_2
        + q_ground1_ddot_by_q_of_place_3;
    // d1_of_place_23 + q_ground1_ddot_by_q_of_place_4
    let q_ground1_ddot_by_q_of_place_5 = d1_of_place_23 + q_ground1_ddot_by_q_of_place_4;
    let cos_q_pin1_doubled = S::int(2) * cos_q_pin1;
    let q_ground1_ddot_by_q_of_q_dot_2_2 = S::int(3) * u_dot_by_q_of_q_dot_2;
    // q_dot_2_sin_angle_inv*cos_q_pin1_doubled - q_ground1_ddot_by_q_of_q_dot_2_2
    let q_ground1_ddot_by_q_of_q_dot_2_3 = q_dot_2_sin_angle_inv
        .mul_add(cos_q_pin1_doubled, -q_ground1_ddot_by_q_of_q_dot_2_2);
    let q_ground1_ddot_by_q_of_q_dot_2_4 = d1_of_place_6 * u_dot_of_q_dot_2_29;
    // u_dot_of_q_dot_2*q_dot_2_u_dot_of_place_7 + 2*u_dot_of_q_dot_2_14*u_dot_by_q_of_q_dot_2
    let q_ground1_ddot_by_q_of_q_dot_2_5 = (u_dot_of_q_dot_2_14 * u_dot_by_q_of_q_dot_2)
        .mul_add(S::int(2), u_dot_of_q_dot_2 * q_dot_2_u_dot_of_place_7);
    let q_ground1_ddot_by_q_of_q_dot_2_6 = d1_of_place_6 * q_dot_2_sin_angle_inv;
    // u_dot_of_q_dot_2*q_ground1_ddot_by_q_of_q_dot_2_6 -
    //   u_dot_by_q_of_q_dot_2*q_ground1_ddot_by_q_of_q_dot_2_2
    let q_ground1_ddot_by_q_of_q_dot_2_7 = (-u_dot_by_q_of_q_dot_2)
        .mul_add(
            q_ground1_ddot_by_q_of_q_dot_2_2,
            u_dot_of_q_dot_2 * q_ground1_ddot_by_q_of_q_dot_2_6,
        );
    // q_dot_2_sin_angle_inv*q_ground1_ddot_by_q_of_q_dot_2*q_ground1_ddot_by_q_of_place_5 -
    //   q_ground1_ddot_by_q_of_q_dot_2_3*q_ground1_ddot_by_q_of_q_dot_2_4
    let q_ground1_ddot_by_q_of_q_dot_2_8 = (-q_ground1_ddot_by_q_of_q_dot_2_3)
        .mul_add(
            q_ground1_ddot_by_q_of_q_dot_2_4,
            q_dot_2_sin_angle_inv * q_ground1_ddot_by_q_of_q_dot_2 * q_ground1_ddot_by_q_of_place_5,
        );
    // q_ground1_ddot_by_q_of_q_dot_2_5 + q_ground1_ddot_by_q_of_q_dot_2_7
    let q_ground1_ddot_by_q_of_q_dot_2_9 = q_ground1_ddot_by_q_of_q_dot_2_5
        + q_ground1_ddot_by_q_of_q_dot_2_7;
    // q_ground1_ddot_by_q_of_q_dot_2_8 + q_ground1_ddot_by_q_of_q_dot_2_9
    let q_ground1_ddot_by_q_of_q_dot_2_10 = q_ground1_ddot_by_q_of_q_dot_2_8
        + q_ground1_ddot_by_q_of_q_dot_2_9;
    // q_ground1_ddot_by_q = (q'^2*(sin(q_pin1) - (sin(q_pin1)*(sin(q_pin1) + cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)) + (sin(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)) + cos(q - q_ground1 + q_pin1)*(2 -
    //   3*(sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)))/tan(q_ground1 - q - q_pin1)) +
    //   cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1) + 2*(cos(q) + cos(q + q_pin1))/tan(q -
    //   q_ground1 + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1) + 2*(sin(q) + sin(q +
    //   q_pin1))/tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1)) + sin(q_pin1)*(u'/tan(q_ground1
    //   - q - q_pin1) + u_dot_by_q))/sin(q - q_ground1 + q_pin1)
    let q_ground1_ddot_by_q = (-sin_q_pin1_sin_angle_inv)
        .mul_add(q_ground1_ddot_by_q_of_u_dot_2, q_ground1_ddot_by_q_of_q_dot_2_10);
    let q_ground2_ddot_by_q_of_place = d1_of_place_11 * sin_q_pin2;
    let q_ground2_ddot_by_q_of_q_dot_2 = u_dot_of_q_dot_2_20 * sin_q_pin2;
    let q_ground2_ddot_by_q_of_place_2 = u_dot_of_place_8 * sin_q_pin2;
    // q_ground2_ddot_by_q_of_place_2 - cos(q_pin2)
    let q_ground2_ddot_by_q_of_place_3 = q_ground2_ddot_by_q_of_place_2 - cos_q_pin2;
    let q_ground2_ddot_by_q_of_q_dot_2_2 = q_dot_2_d1_of_place_11 * q_ground2_ddot_by_q_of_place_3;
    // sin_q_pin2_doubled*q_ground2_ddot_by_q_of_q_dot_2 +
    //   d1_of_place_30_doubled*q_ground2_ddot_by_q_of_q_dot_2_2
    let q_ground2_ddot_by_q_of_q_dot_2_3 = d1_of_place_30_doubled
        .mul_add(
            q_ground2_ddot_by_q_of_q_dot_2_2,
            sin_q_pin2_doubled * q_ground2_ddot_by_q_of_q_dot_2,
        );
    let q_ground2_ddot_by_q_of_q_dot_2_4 = q_dot_2_d1_of_place_11 * cos_angle_2;
    // sin_q_pin2_doubled*q_ground2_ddot_by_q_of_q_dot_2_4 - q_ground2_ddot_by_q_of_q_dot_2_3
    let q_ground2_ddot_by_q_of_q_dot_2_5 = sin_q_pin2_doubled
        .mul_add(q_ground2_ddot_by_q_of_q_dot_2_4, -q_ground2_ddot_by_q_of_q_dot_2_3);
    let q_ground2_ddot_by_q_of_q_dot_2_6 = u_dot_of_q_dot_2_15 * sin_q_pin2_doubled;
    let sin_q_pin2_times_3 = S::int(3) * sin_q_pin2;
    let q_ground2_ddot_by_q_of_q_dot_2_7 = u_dot_of_q_dot_2_15 * sin_q_pin2_times_3;
    // u_dot_of_q_dot_2_8*q_dot_2_u_dot_of_place_7 + u_dot_of_q_dot_2_14*q_ground2_ddot_by_q_of_q_dot_2_6
    let q_ground2_ddot_by_q_of_q_dot_2_8 = u_dot_of_q_dot_2_14
        .mul_add(
            q_ground2_ddot_by_q_of_q_dot_2_6,
            u_dot_of_q_dot_2_8 * q_dot_2_u_dot_of_place_7,
        );
    // u_dot_by_q_of_q_dot_2*q_ground2_ddot_by_q_of_q_dot_2_7 - q_ground2_ddot_by_q_of_q_dot_2_8
    let q_ground2_ddot_by_q_of_q_dot_2_9 = u_dot_by_q_of_q_dot_2
        .mul_add(q_ground2_ddot_by_q_of_q_dot_2_7, -q_ground2_ddot_by_q_of_q_dot_2_8);
    let q_ground2_ddot_by_q_of_q_dot_2_10 = u_dot_of_q_dot_2_10 * q_ground1_ddot_by_q_of_q_dot_2;
    // q_ground2_ddot_by_q = (q'^2*(sin(q_pin1)*sin(q_pin2) -
    //   (2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q - q_ground1 + q_pin1)) + sin(q_pin2)*(cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q +
    //   q_pin1) + 2*(cos(q) + cos(q + q_pin1))/tan(q - q_ground1 + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q
    //   + q_pin1) + 2*(sin(q) + sin(q + q_pin1))/tan(q_ground1 - q - q_pin1))) + sin(q_pin1)*(sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)) +
    //   (sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)) + cos(q -
    //   q_ground1 + q_pin1)*(2 + 3*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)) - sin(q_pin1)*(3/tan(q - q_ground1 + q_pin1) +
    //   2*((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) -
    //   1)/tan(q_ground1 - q_ground2 + q_pin2)))/tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1))
    //   + sin(q_pin1)*sin(q_pin2)*(u'/tan(q_ground1 - q - q_pin1) + u_dot_by_q))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_ground2_ddot_by_q = u_dot_of_q_dot_2_8 * q_ground1_ddot_by_q_of_q_dot_2_6
        - q_ground1_ddot_by_q_of_u_dot_2 * q_ground2_ddot_by_q_of_place
        + u_dot_of_q_dot_2_15 * q_ground2_ddot_by_q_of_q_dot_2_5
        + q_ground1_ddot_by_q_of_q_dot_2_4
            * (-sin_q_pin2_doubled)
                .mul_add(u_dot_by_q_of_q_dot_2_10, q_ground2_ddot_by_q_of_q_dot_2_7)
        - q_ground2_ddot_by_q_of_q_dot_2_9
        + q_ground1_ddot_by_q_of_place_5 * q_ground2_ddot_by_q_of_q_dot_2_10 * sin_q_pin2;
    let q_pin1_ddot_by_q_of_u_dot = u_dot * u_dot_of_q_2_q_pin1;
    let q_pin1_ddot_by_q_of_u_dot_2 = u_dot * u_dot_of_q_2_q_pin1_2;
    let sin_q_pin1_times_3 = S::int(3) * sin_q_pin1;
    let q_pin1_ddot_by_q_of_q_2_q_pin1 = S::int(2) * cos_q_plus_q_pin1;
    let q_pin1_ddot_by_q_of_q_2_q_pin1_2 = S::int(2) * sin_q_plus_q_pin1;
    let cos_q_ground1_doubled = S::int(2) * cos_q_ground1;
    // sin(q) + q_pin1_ddot_by_q_of_q_2_q_pin1_2
    let q_pin1_ddot_by_q_of_q_2_q_pin1_3 = sin_q + q_pin1_ddot_by_q_of_q_2_q_pin1_2;
    let sin_q_ground1_doubled = S::int(2) * sin_q_ground1;
    // cos(q) + q_pin1_ddot_by_q_of_q_2_q_pin1
    let q_pin1_ddot_by_q_of_q_2_q_pin1_4 = cos_q + q_pin1_ddot_by_q_of_q_2_q_pin1;
    // sin(q_pin1) + 2*u_dot_of_place_3
    let q_pin1_ddot_by_q_of_place = u_dot_of_place_3.mul_add(S::int(2), sin_q_pin1);
    let sin_angle_inv_times_3 = S::int(3) * sin_angle_inv;
    // cos(q - q_ground1 + q_pin1)*(2*u_dot_of_q_2_q_pin1_2 -
    //   sin_angle_inv_times_3*(cos(q)*(q_pin1_ddot_by_q_of_place -
    //   q_pin1_ddot_by_q_of_q_2_q_pin1_4*sin(q_ground1)) + cos(q + q_pin1)*(q_pin1_ddot_by_q_of_place -
    //   d1_of_place_4)))
    let q_pin1_ddot_by_q_of_place_2 = cos_angle
        * (-sin_angle_inv_times_3
            * (cos_q
                * (-q_pin1_ddot_by_q_of_q_2_q_pin1_4)
                    .mul_add(sin_q_ground1, q_pin1_ddot_by_q_of_place)
                + cos_q_plus_q_pin1 * (q_pin1_ddot_by_q_of_place - d1_of_place_4))
            + S::int(2) * u_dot_of_q_2_q_pin1_2);
    let q_pin1_ddot_by_q_of_place_3 = S::int(3) * cos_angle_sin_angle_inv;
    let q_pin1_ddot_by_q_of_q_2_q_pin1_5 = S::int(2) * q_pin1_ddot_by_q_of_q_2_q_pin1_4;
    let cos_angle_doubled = S::int(2) * cos_angle;
    let q_pin1_ddot_by_q_of_u_dot_3 = u_dot * minus_u_dot_of_place_5 * cos_angle;
    // sin_angle_inv*(q_dot_2_sq*(cos(q_ground1)^2*(u_dot_of_q_2_q_pin1*sin(q) + cos(q +
    //   q_pin1)*u_dot_of_q_2_q_pin1_2) + sin(q_ground1)*(sin(q_ground1)*(sin(q + q_pin1)*u_dot_of_q_2_q_pin1
    //   + u_dot_of_q_2_q_pin1_2*cos(q)) + cos_q_ground1_doubled*(sin(q + q_pin1)*cos(q + q_pin1) -
    //   sin(q)*cos(q))) + cos(q - q_ground1 + q_pin1)*(2*u_dot_of_place_37 +
    //   sin_angle_inv*(sin(q_ground1)*(cos_q_ground1_doubled*(cos(q)*(cos(q) + 3*cos(q + q_pin1)) -
    //   sin(q)*(sin(q) + 3*sin(q + q_pin1)) + cos(q + q_pin1)*q_pin1_ddot_by_q_of_q_2_q_pin1 - sin(q +
    //   q_pin1)*q_pin1_ddot_by_q_of_q_2_q_pin1_2) - u_dot_of_q_2_q_pin1*sin_q_pin1_times_3 +
    //   u_dot_of_q_2_q_pin1_2*q_pin1_ddot_by_q_of_q_2_q_pin1_3*sin_q_ground1_doubled +
    //   q_pin1_ddot_by_q_of_place_2) - cos(q_ground1)*(sin_q_pin1_times_3*(u_dot_of_q_2_q_pin1_2 -
    //   u_dot_of_q_2_q_pin1*cos_angle_sin_angle_inv) +
    //   cos(q_ground1)*(sin(q)*(q_pin1_ddot_by_q_of_q_2_q_pin1_5 -
    //   q_pin1_ddot_by_q_of_q_2_q_pin1_3*q_pin1_ddot_by_q_of_place_3) + sin(q +
    //   q_pin1)*(q_pin1_ddot_by_q_of_q_2_q_pin1_5 - sin(q + q_pin1)*q_pin1_ddot_by_q_of_place_3)) +
    //   u_dot_of_q_2_q_pin1*cos_angle_doubled)))) - q_pin1_ddot_by_q_of_u_dot_3)
    let q_pin1_ddot_by_q_of_motion = sin_angle_inv
        * (q_dot_2_sq
            * (cos_q_ground1 * cos_q_ground1
                * cos_q_plus_q_pin1
                    .mul_add(u_dot_of_q_2_q_pin1_2, u_dot_of_q_2_q_pin1 * sin_q)
                + sin_q_ground1
                    * (sin_q_ground1
                        * u_dot_of_q_2_q_pin1_2
                            .mul_add(cos_q, sin_q_plus_q_pin1 * u_dot_of_q_2_q_pin1)
                        + cos_q_ground1_doubled
                            * (-sin_q)
                                .mul_add(cos_q, sin_q_plus_q_pin1 * cos_q_plus_q_pin1))
                + cos_angle
                    * (sin_angle_inv
                        * (sin_q_ground1
                            * (cos_q_ground1_doubled
                                * (cos_q * cos_q_plus_q_pin1.mul_add(S::int(3), cos_q)
                                    - sin_q * sin_q_plus_q_pin1.mul_add(S::int(3), sin_q)
                                    + cos_q_plus_q_pin1 * q_pin1_ddot_by_q_of_q_2_q_pin1
                                    - sin_q_plus_q_pin1 * q_pin1_ddot_by_q_of_q_2_q_pin1_2)
                                - u_dot_of_q_2_q_pin1 * sin_q_pin1_times_3
                                + u_dot_of_q_2_q_pin1_2 * q_pin1_ddot_by_q_of_q_2_q_pin1_3
                                    * sin_q_ground1_doubled + q_pin1_ddot_by_q_of_place_2)
                            - cos_q_ground1
                                * (sin_q_pin1_times_3
                                    * (-u_dot_of_q_2_q_pin1)
                                        .mul_add(cos_angle_sin_angle_inv, u_dot_of_q_2_q_pin1_2)
                                    + cos_q_ground1
                                        * (sin_q
                                            * (-q_pin1_ddot_by_q_of_q_2_q_pin1_3)
                                                .mul_add(
                                                    q_pin1_ddot_by_q_of_place_3,
                                                    q_pin1_ddot_by_q_of_q_2_q_pin1_5,
                                                )
                                            + sin_q_plus_q_pin1
                                                * (-sin_q_plus_q_pin1)
                                                    .mul_add(
                                                        q_pin1_ddot_by_q_of_place_3,
                                                        q_pin1_ddot_by_q_of_q_2_q_pin1_5,
                                                    )) + u_dot_of_q_2_q_pin1 * cos_angle_doubled))
                        + S::int(2) * u_dot_of_place_37)) - q_pin1_ddot_by_q_of_u_dot_3);
    // q_pin1_ddot_by_q = ((q'^2*(cos(q - q_ground1 + q_pin1)*(2*sin(q_ground1)*(sin(q) + sin(q + q_pin1))
    //   + 2*cos(q_ground1)*(cos(q) + cos(q + q_pin1)) - (sin(q_ground1)*(3*sin(q_pin1)*(sin(q) + sin(q +
    //   q_pin1)) + cos(q - q_ground1 + q_pin1)*(3*(cos(q)*(sin(q_pin1) + 2*cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + 2*cos(q + q_pin1))) + cos(q + q_pin1)*(sin(q_pin1) -
    //   sin(q_ground1)*cos(q + q_pin1) + 2*cos(q_ground1)*(sin(q) + sin(q + q_pin1))))/sin(q - q_ground1 +
    //   q_pin1) - 2*cos(q) - 2*cos(q + q_pin1)) + 2*cos(q_ground1)*(2*sin(q + q_pin1)^2 - 2*cos(q +
    //   q_pin1)^2 + sin(q)*(sin(q) + 3*sin(q + q_pin1)) - cos(q)*(cos(q) + 3*cos(q + q_pin1))) -
    //   2*sin(q_ground1)*(sin(q)*(cos(q) + cos(q + q_pin1)) + 2*sin(q + q_pin1)*(cos(q) + cos(q + q_pin1))))
    //   + cos(q_ground1)*(2*cos(q - q_ground1 + q_pin1)*(sin(q) + sin(q + q_pin1)) +
    //   cos(q_ground1)*(sin(q)*(2*cos(q) + 4*cos(q + q_pin1) + 3*(sin(q) + 2*sin(q + q_pin1))/tan(q_ground1
    //   - q - q_pin1)) + sin(q + q_pin1)*(2*cos(q) + 4*cos(q + q_pin1) + 3*sin(q + q_pin1)/tan(q_ground1 - q
    //   - q_pin1))) + 3*sin(q_pin1)*(cos(q) + cos(q + q_pin1) + (sin(q) + sin(q + q_pin1))/tan(q_ground1 - q
    //   - q_pin1))))/sin(q - q_ground1 + q_pin1)) + sin(q_ground1)*(sin(q_ground1)*(sin(q + q_pin1)*(sin(q)
    //   + sin(q + q_pin1)) + cos(q)*(cos(q) + cos(q + q_pin1))) + 2*cos(q_ground1)*(sin(q + q_pin1)*cos(q +
    //   q_pin1) - sin(q)*cos(q))) + cos(q_ground1)^2*(sin(q)*(sin(q) + sin(q + q_pin1)) + cos(q +
    //   q_pin1)*(cos(q) + cos(q + q_pin1)))) + u'*cos(q - q_ground1 + q_pin1)*(cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_ground1)*(u_dot_by_q*(cos(q) + cos(q + q_pin1)) - u'*(sin(q) + sin(q + q_pin1))) -
    //   cos(q_ground1)*(u'*(cos(q) + cos(q + q_pin1)) + u_dot_by_q*(sin(q) + sin(q + q_pin1))))/sin(q -
    //   q_ground1 + q_pin1)
    let q_pin1_ddot_by_q = sin_angle_inv
        * (sin_q_ground1 * u_dot_by_q.mul_add(u_dot_of_q_2_q_pin1_2, -q_pin1_ddot_by_q_of_u_dot)
            - cos_q_ground1 * u_dot_by_q.mul_add(u_dot_of_q_2_q_pin1, q_pin1_ddot_by_q_of_u_dot_2)
            + q_pin1_ddot_by_q_of_motion);
    // d1_of_place_17*u_dot_of_q_2_q_pin1_2 - u_dot_of_place_3
    let q_pin2_ddot_by_q_of_place = d1_of_place_17
        .mul_add(u_dot_of_q_2_q_pin1_2, -u_dot_of_place_3);
    // sin(q_pin1) - q_pin2_ddot_by_q_of_place
    let q_pin2_ddot_by_q_of_place_2 = sin_q_pin1 - q_pin2_ddot_by_q_of_place;
    let q_pin2_ddot_by_q_of_place_3 = d1_of_place_19 * u_dot_of_q_2_q_pin1_2;
    let q_pin2_ddot_by_q_of_place_4 = q_pin2_ddot_by_q_of_place_3 * sin_q_ground2;
    let q_pin2_ddot_by_q_of_place_5 = d1_of_place_19 * u_dot_of_q_2_q_pin1;
    // sin(q_pin1) + q_pin2_ddot_by_q_of_place_5
    let q_pin2_ddot_by_q_of_place_6 = sin_q_pin1 + q_pin2_ddot_by_q_of_place_5;
    let q_pin2_ddot_by_q_of_place_7 = d1_of_place_16 * cos_q_ground2;
    let q_pin2_ddot_by_q_of_place_8 = u_dot_of_q_2_q_pin1 * q_pin2_ddot_by_q_of_place_7;
    let q_pin2_ddot_by_q_of_place_9 = d1_of_place_13 * sin_q_ground2;
    // q_pin2_ddot_by_q_of_place_9 - q_pin2_ddot_by_q_of_place_7
    let q_pin2_ddot_by_q_of_place_10 = q_pin2_ddot_by_q_of_place_9 - q_pin2_ddot_by_q_of_place_7;
    // cos(q - q_ground1 + q_pin1)*(2 + sin_angle_inv_times_3*(u_dot_of_place_4 -
    //   q_pin2_ddot_by_q_of_place_5))
    let q_pin2_ddot_by_q_of_place_11 = cos_angle
        * (S::int(2) + sin_angle_inv_times_3 * (u_dot_of_place_4 - q_pin2_ddot_by_q_of_place_5));
    let q_pin2_ddot_by_q_of_place_12 = u_dot_of_q_2_q_pin1_2 * q_pin1_ddot_by_q_of_place_3;
    let d1_of_place_17_doubled = S::int(2) * d1_of_place_17;
    // sin(q_pin2) + 2*d1_of_place_18
    let q_pin2_ddot_by_q_of_place_13 = d1_of_place_18.mul_add(S::int(2), sin_q_pin2);
    // cos(q_ground1)*(q_pin2_ddot_by_q_of_place_13 - d1_of_place_14*sin(q_ground2)) + cos(q_ground1 +
    //   q_pin2)*(q_pin2_ddot_by_q_of_place_13 - q_pin2_ddot_by_q_of_place_9)
    let q_pin2_ddot_by_q_of_place_14 = cos_q_ground1
        * (-d1_of_place_14).mul_add(sin_q_ground2, q_pin2_ddot_by_q_of_place_13)
        + d1_of_place_13 * (q_pin2_ddot_by_q_of_place_13 - q_pin2_ddot_by_q_of_place_9);
    let q_pin2_ddot_by_q_of_place_15 = d1_of_place_13 * cos_q_ground2;
    // sin_q_pin2_sin_q_ground1 + sin(q_ground1 + q_pin2)*u_dot_of_place_14 + cos(q_ground1 - q_ground2 +
    //   q_pin2)*(sin_angle_2_inv*q_pin2_ddot_by_q_of_place_14 - d1_of_place_19) -
    //   d1_of_place_19*q_pin2_ddot_by_q_of_place_15
    let q_pin2_ddot_by_q_of_place_16 = sin_q_pin2_sin_q_ground1 + d1_of_place_16 * u_dot_of_place_14
        + cos_angle_2 * sin_angle_2_inv.mul_add(q_pin2_ddot_by_q_of_place_14, -d1_of_place_19)
        - d1_of_place_19 * q_pin2_ddot_by_q_of_place_15;
    let sin_angle_2_inv_doubled = S::int(2) * sin_angle_2_inv;
    // sin(q_pin1)*(d1_of_place_17_doubled - d1_of_place_19*q_pin1_ddot_by_q_of_place_3 -
    //   q_pin2_ddot_by_q_of_place_16*sin_angle_2_inv_doubled)
    let q_pin2_ddot_by_q_of_place_17 = sin_q_pin1
        * ((-d1_of_place_19).mul_add(q_pin1_ddot_by_q_of_place_3, d1_of_place_17_doubled)
            - q_pin2_ddot_by_q_of_place_16 * sin_angle_2_inv_doubled);
    // sin(q_pin2) + d1_of_place_20*cos(q_ground2)
    let q_pin2_ddot_by_q_of_place_18 = d1_of_place_20.mul_add(cos_q_ground2, sin_q_pin2);
    // cos(q - q_ground1 + q_pin1)*(sin_angle_inv_times_3*q_pin2_ddot_by_q_of_place_2 - 2) -
    //   2*u_dot_of_place_22*(q_pin2_ddot_by_q_of_place_15 + cos(q_ground1 - q_ground2 + q_pin2)*(1 -
    //   sin_angle_2_inv*q_pin2_ddot_by_q_of_place_18))
    let q_pin2_ddot_by_q_of_place_19 = cos_angle
        * sin_angle_inv_times_3.mul_add(q_pin2_ddot_by_q_of_place_2, -S::int(2))
        - S::int(2) * u_dot_of_place_22
            * (q_pin2_ddot_by_q_of_place_15
                + cos_angle_2
                    * (-sin_angle_2_inv)
                        .mul_add(q_pin2_ddot_by_q_of_place_18, S::int(1)));
    // d1_of_place_17*u_dot_of_q_2_q_pin1 + u_dot_of_place_35
    let q_pin2_ddot_by_q_of_place_20 = d1_of_place_17
        .mul_add(u_dot_of_q_2_q_pin1, u_dot_of_place_35);
    let q_pin2_ddot_by_q_of_place_21 = u_dot_of_q_2_q_pin1 * q_pin1_ddot_by_q_of_place_3;
    // sin(q_pin2) + q_pin2_ddot_by_q_of_place_7
    let q_pin2_ddot_by_q_of_place_22 = sin_q_pin2 + q_pin2_ddot_by_q_of_place_7;
    // sin(q_pin1)*(q_pin1_ddot_by_q_of_place_3 - sin_angle_2_inv_doubled*(q_pin2_ddot_by_q_of_place_15 +
    //   cos(q_ground1 - q_ground2 + q_pin2)*(1 - sin_angle_2_inv*q_pin2_ddot_by_q_of_place_22))) -
    //   cos_angle_doubled
    let q_pin2_ddot_by_q_of_place_23 = sin_q_pin1
        * (q_pin1_ddot_by_q_of_place_3
            - sin_angle_2_inv_doubled
                * (q_pin2_ddot_by_q_of_place_15
                    + cos_angle_2
                        * (-sin_angle_2_inv)
                            .mul_add(q_pin2_ddot_by_q_of_place_22, S::int(1)))) - cos_angle_doubled;
    let sin_q_pin1_doubled = S::int(2) * sin_q_pin1;
    // sin_q_pin1_doubled*(d1_of_place_19 - d1_of_place_19*u_dot_of_place_13)
    let q_pin2_ddot_by_q_of_place_24 = sin_q_pin1_doubled
        * (-d1_of_place_19).mul_add(u_dot_of_place_13, d1_of_place_19);
    // -q_pin2_ddot_by_q_of_place
    let q_pin2_ddot_by_q_of_place_25 = -q_pin2_ddot_by_q_of_place;
    // u_dot_of_q_2_q_pin1_2 - u_dot_of_q_2_q_pin1*u_dot_by_q_of_place_4
    let q_pin2_ddot_by_q_of_place_26 = (-u_dot_of_q_2_q_pin1)
        .mul_add(u_dot_by_q_of_place_4, u_dot_of_q_2_q_pin1_2);
    let q_pin2_ddot_by_q_of_place_27 = minus_d1_of_place_30 * sin_q_pin1;
    let q_pin2_ddot_by_q_of_place_28 = sin_angle_inv * sin_angle_2_inv;
    // q_pin2_ddot_by_q = (q'^2*(sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))) +
    //   (sin(q_pin1)*(sin(q_pin1)*(cos(q_ground2)*sin(q_ground1 + q_pin2) - sin(q_ground2)*cos(q_ground1 +
    //   q_pin2)) + (sin(q_ground2)*(cos(q_ground1 + q_pin2)*(2*cos(q - q_ground1 + q_pin1) +
    //   sin(q_ground1)*(sin(q) + sin(q + q_pin1) + 3*(cos(q) + cos(q + q_pin1))/tan(q - q_ground1 +
    //   q_pin1))) + sin(q_pin1)*(2*sin(q_ground1) + 2*sin(q_ground1 + q_pin2) + 3*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2))/tan(q_ground1 - q - q_pin1) + 2*(cos(q_ground2)*cos(q_ground1 +
    //   q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - sin(q_ground1)*sin(q_pin2) - sin(q_ground1 +
    //   q_pin2)*(sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))) - cos(q_ground1 - q_ground2 +
    //   q_pin2)*((cos(q_ground1)*(sin(q_pin2) + 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))
    //   - sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(sin(q_pin2) - sin(q_ground2)*cos(q_ground1 + q_pin2) + 2*cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2) - cos(q_ground1) - cos(q_ground1 +
    //   q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) + cos(q_ground1)*(sin(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) + cos(q)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + cos(q + q_pin1)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) + cos(q - q_ground1 + q_pin1)*(2 + 3*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - sin(q)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - sin(q + q_pin1)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q - q_ground1 + q_pin1)))) -
    //   cos(q_ground2)*(sin(q_ground1)*(cos(q_ground1)*(cos(q) + cos(q + q_pin1)) + sin(q)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + sin(q + q_pin1)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) + cos(q -
    //   q_ground1 + q_pin1)*(2 - 3*(sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) -
    //   cos(q)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - cos(q + q_pin1)*(sin(q_ground1) + sin(q_ground1
    //   + q_pin2)))/sin(q - q_ground1 + q_pin1)) + 2*sin(q_pin1)*(cos(q_ground2)*cos(q_ground1 + q_pin2) +
    //   cos(q_ground1 - q_ground2 + q_pin2)*(1 - (sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
    //   2*sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2)) + sin(q_ground1 + q_pin2)*(2*cos(q - q_ground1 + q_pin1) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1) + 3*(sin(q) + sin(q + q_pin1))/tan(q_ground1 - q - q_pin1)) +
    //   sin(q_pin1)*(2*(cos(q_ground2)*cos(q_ground1 + q_pin2) + cos(q_ground1 - q_ground2 + q_pin2)*(1 -
    //   (sin(q_pin2) + cos(q_ground2)*sin(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 +
    //   q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 3/tan(q - q_ground1 + q_pin1))) +
    //   2*sin(q_pin1)*(sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 +
    //   q_pin2) - cos(q_ground1) - cos(q_ground1 + q_pin2))))/tan(q - q_ground1 + q_pin1) +
    //   sin(q_ground1)*(sin(q_ground2)*(cos(q)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + cos(q +
    //   q_pin1)*(cos(q_ground1) + cos(q_ground1 + q_pin2))) + cos(q_ground2)*(sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - cos(q)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   cos(q + q_pin1)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))) +
    //   cos(q_ground1)*(cos(q_ground2)*sin(q_ground1 + q_pin2)*(sin(q) + sin(q + q_pin1)) -
    //   sin(q_ground2)*(sin(q_pin1) + sin(q)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + sin(q +
    //   q_pin1)*(cos(q_ground1) + cos(q_ground1 + q_pin2))))) +
    //   cos(q_pin1)*(sin(q_ground1)*(cos(q_ground2)*(cos(q_ground1)*(cos(q) + cos(q + q_pin1)) +
    //   sin(q)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) + sin(q + q_pin1)*(sin(q_ground1) + sin(q_ground1
    //   + q_pin2)) + 2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - cos(q)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) - cos(q + q_pin1)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/tan(q_ground1 - q - q_pin1))
    //   - sin(q_ground2)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1) + 2*(cos(q) + cos(q + q_pin1))/tan(q -
    //   q_ground1 + q_pin1)) + cos(q_ground1 + q_pin2)*(sin(q) + sin(q + q_pin1) + 2*(cos(q) + cos(q +
    //   q_pin1))/tan(q - q_ground1 + q_pin1)))) + cos(q_ground1)*(cos(q_ground2)*sin(q_ground1 +
    //   q_pin2)*(cos(q) + cos(q + q_pin1) + 2*(sin(q) + sin(q + q_pin1))/tan(q_ground1 - q - q_pin1)) -
    //   sin(q_ground2)*(cos(q_ground1)*(cos(q) + cos(q + q_pin1) + 2*(sin(q) + sin(q +
    //   q_pin1))/tan(q_ground1 - q - q_pin1)) + cos(q_ground1 + q_pin2)*(cos(q) + cos(q + q_pin1) +
    //   2*(sin(q) + sin(q + q_pin1))/tan(q_ground1 - q - q_pin1))))))/sin(q - q_ground1 + q_pin1)) -
    //   sin(q_pin1)*(u'*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/tan(q - q_ground1 + q_pin1) +
    //   u_dot_by_q*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_ddot_by_q = q_pin2_ddot_by_q_of_place_28
        * (q_dot_2_sq
            * (sin_angle_inv
                * (sin_q_pin1
                    * (sin_q_ground1
                        * q_pin2_ddot_by_q_of_place_2
                            .mul_add(cos_q_ground2, q_pin2_ddot_by_q_of_place_4)
                        + cos_q_ground1
                            * (-q_pin2_ddot_by_q_of_place_6)
                                .mul_add(sin_q_ground2, q_pin2_ddot_by_q_of_place_8)
                        - q_pin2_ddot_by_q_of_place_10 * sin_q_pin1
                        + cos_angle_sin_angle_inv
                            * (sin_q_ground2
                                * (cos_q_ground1
                                    * (u_dot_of_place_36 + q_pin2_ddot_by_q_of_place_3
                                        + q_pin2_ddot_by_q_of_place_11)
                                    + d1_of_place_13
                                        * (cos_angle_doubled
                                            + sin_q_ground1
                                                * (u_dot_of_q_2_q_pin1 + q_pin2_ddot_by_q_of_place_12))
                                    + q_pin2_ddot_by_q_of_place_17)
                                + cos_q_ground2
                                    * (sin_q_ground1
                                        * (q_pin2_ddot_by_q_of_place_19
                                            - q_pin2_ddot_by_q_of_place_20)
                                        + d1_of_place_16
                                            * (cos_q_ground1
                                                * (q_pin2_ddot_by_q_of_place_21 - u_dot_of_q_2_q_pin1_2)
                                                + q_pin2_ddot_by_q_of_place_23)
                                        + q_pin2_ddot_by_q_of_place_24)))
                    + cos_q_pin1
                        * (sin_q_ground1
                            * (cos_q_ground2
                                * (-u_dot_by_q_of_place_4)
                                    .mul_add(
                                        q_pin2_ddot_by_q_of_place_25, q_pin2_ddot_by_q_of_place_20,
                                    )
                                - d1_of_place_19 * sin_q_ground2
                                    * u_dot_of_q_2_q_pin1_2
                                        .mul_add(u_dot_by_q_of_place_4, u_dot_of_q_2_q_pin1))
                            + cos_q_ground1
                                * (-(d1_of_place_19 * q_pin2_ddot_by_q_of_place_26))
                                    .mul_add(
                                        sin_q_ground2,
                                        q_pin2_ddot_by_q_of_place_7 * q_pin2_ddot_by_q_of_place_26,
                                    ))) + q_pin2_ddot_by_q_of_place_27)
            - minus_d1_of_place_30 * q_ground1_ddot_by_q_of_u_dot_2 * sin_q_pin1);
    // u_dot_of_place_2 + u_dot_by_q_of_place_2
    let d1_by_q_ground1_of_place = u_dot_of_place_2 + u_dot_by_q_of_place_2;
    let d1_by_q_ground1_of_place_2 = sin_angle_2_inv * d1_by_q_ground1_of_place;
    let d1_by_q_ground1_of_place_3 = d1_by_q_of_place_8 * q_ground2_ddot_by_q_of_place_2;
    let d1_by_q_ground1_of_place_4 = sin_q_pin1_sin_angle_inv * l_m_l_d1_of_place_11;
    let d1_by_q_ground1_of_place_5 = d1_of_place_12 * cos_angle_2;
    let d1_by_q_ground1_of_place_6 = u_dot_of_place_8 * u_dot_of_place_31;
    // sin_angle_2_inv*d1_of_q_pin2*u_dot_of_place_2 + d1_by_q_ground1_of_place_6
    let d1_by_q_ground1_of_place_7 = (sin_angle_2_inv * d1_of_q_pin2)
        .mul_add(u_dot_of_place_2, d1_by_q_ground1_of_place_6);
    // u_dot_of_place_10*(u_dot_of_place_2*d1_by_q_ground1_of_place_4 +
    //   minus_d1_of_place_30*d1_by_q_ground1_of_place_5) + d1_of_place_9*d1_by_q_ground1_of_place_7
    let d1_by_q_ground1_of_place_8 = u_dot_of_place_10
        * minus_d1_of_place_30
            .mul_add(
                d1_by_q_ground1_of_place_5,
                u_dot_of_place_2 * d1_by_q_ground1_of_place_4,
            ) + d1_of_place_9 * d1_by_q_ground1_of_place_7;
    // d1_by_q_ground1 = m*l^2*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))*(2*sin(q)*cos(q_ground1) - 2*cos(q)*sin(q_ground1) -
    //   3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))/(6*sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + m*l^2*(sin(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))*(2*cos(q)*sin(q_ground1) -
    //   2*sin(q)*cos(q_ground1) + 3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))/(6*sin(q - q_ground1 +
    //   q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + m*l^2*((2*sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - 2*cos(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   3*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1))))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + (2*sin(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + 2*cos(q_ground1)*(cos(q) + cos(q + q_pin1)) +
    //   3*cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1))))/sin(q - q_ground1 + q_pin1))/6 + m*l^2*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(2*sin(q)*cos(q_ground1) - 2*cos(q)*sin(q_ground1) -
    //   3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)) - cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))/(6*sin(q -
    //   q_ground1 + q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) + m*l^2*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(2*sin(q)*sin(q_ground1) +
    //   2*cos(q)*cos(q_ground1) + 3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))
    //   - cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))))/(6*sin(q - q_ground1 +
    //   q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) +
    //   2*m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(3*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2*tan(q - q_ground1 + q_pin1)) + 2*m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(3*sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   m*l^2*sin(q_pin1)^2*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(3*sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*sin(q_pin1)^2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(2 + 3*cos(q_pin2) +
    //   2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/(3*sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*sin(q_pin1)^2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(2 + 3*cos(q_pin2) +
    //   2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/(6*sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   m*l^2*sin(q_pin1)^2*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(2 + 3*cos(q_pin2) +
    //   2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/(6*sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   m*l^2*sin(q_pin1)^2*((2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (2*sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + 2*cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(6*sin(q - q_ground1 + q_pin1)^2) + m*l^2*sin(q_pin1)^2*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)))*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(3*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2))
    let d1_by_q_ground1 = (-(d1_of_place_32 * minus_d1_of_place_30))
        .mul_add(d1_by_q_ground1_of_place_2, -d1_by_q) - d1_by_q_ground1_of_place_3
        - S::ratio(1, 6) * d1_by_q_ground1_of_place_8;
    // u_dot_of_q_dot_2_19*(u_dot_of_q_dot_2_2 + 2*u_dot_of_place_8*u_dot_of_q_dot_2_21) -
    //   u_dot_of_q_dot_2_9*u_dot_of_q_dot_2_20
    let u_dot_by_q_ground1_of_q_dot_2 = u_dot_of_q_dot_2_19
        * (u_dot_of_place_8 * u_dot_of_q_dot_2_21).mul_add(S::int(2), u_dot_of_q_dot_2_2)
        - u_dot_of_q_dot_2_9 * u_dot_of_q_dot_2_20;
    let u_dot_by_q_ground1_of_q_dot_2_2 = u_dot_of_q_dot_2_19 * u_dot_of_q_dot_2_20;
    // u_dot_of_place_2*u_dot_by_q_ground1_of_q_dot_2_2 - u_dot_of_q_dot_2_17*d1_by_q_ground1_of_place
    let u_dot_by_q_ground1_of_q_dot_2_3 = (-u_dot_of_q_dot_2_17)
        .mul_add(
            d1_by_q_ground1_of_place,
            u_dot_of_place_2 * u_dot_by_q_ground1_of_q_dot_2_2,
        );
    // u_dot_by_q_ground1_of_q_dot_2 + u_dot_by_q_ground1_of_q_dot_2_3
    let u_dot_by_q_ground1_of_q_dot_2_4 = u_dot_by_q_ground1_of_q_dot_2
        + u_dot_by_q_ground1_of_q_dot_2_3;
    let u_dot_by_q_ground1_of_q_dot_2_5 = q_dot_2_d1_of_place_11 * u_dot_of_place_2;
    // u_dot_of_q_dot_2_21 + u_dot_by_q_ground1_of_q_dot_2_5
    let u_dot_by_q_ground1_of_q_dot_2_6 = u_dot_of_q_dot_2_21 + u_dot_by_q_ground1_of_q_dot_2_5;
    // u_dot_by_q_of_q_dot_2_3 - u_dot_by_q_ground1_of_q_dot_2_6
    let u_dot_by_q_ground1_of_q_dot_2_7 = u_dot_by_q_of_q_dot_2_3 - u_dot_by_q_ground1_of_q_dot_2_6;
    let u_dot_by_q_ground1_of_q_dot_2_8 = d1_of_place_30 * u_dot_of_q_dot_2_8;
    // u_dot_of_place_2*q_ground2_ddot_by_q_of_q_dot_2 + u_dot_by_q_ground1_of_q_dot_2_8
    let u_dot_by_q_ground1_of_q_dot_2_9 = u_dot_of_place_2
        .mul_add(q_ground2_ddot_by_q_of_q_dot_2, u_dot_by_q_ground1_of_q_dot_2_8);
    // u_dot_of_q_dot_2_21*(q_ground2_ddot_by_q_of_q_dot_2 - u_dot_by_q_of_q_dot_2_6 +
    //   u_dot_by_q_ground1_of_q_dot_2_7) + q_dot_2_d1_of_place_11*(sin(q_ground2)*(u_dot_of_q_dot_2_7 +
    //   u_dot_by_q_of_q_dot_2_4 + sin(q_ground1 + q_pin2)*u_dot_by_q_ground1_of_q_dot_2_7) -
    //   u_dot_by_q_of_q_dot_2_7 - cos(q_ground2)*(u_dot_of_q_dot_2_5 - u_dot_by_q_of_q_dot_2_5 -
    //   cos(q_ground1 + q_pin2)*u_dot_by_q_ground1_of_q_dot_2_7) + u_dot_by_q_ground1_of_q_dot_2_9)
    let u_dot_by_q_ground1_of_q_dot_2_10 = u_dot_of_q_dot_2_21
        * (q_ground2_ddot_by_q_of_q_dot_2 - u_dot_by_q_of_q_dot_2_6
            + u_dot_by_q_ground1_of_q_dot_2_7)
        + q_dot_2_d1_of_place_11
            * (sin_q_ground2
                * d1_of_place_16
                    .mul_add(
                        u_dot_by_q_ground1_of_q_dot_2_7,
                        u_dot_of_q_dot_2_7 + u_dot_by_q_of_q_dot_2_4,
                    ) - u_dot_by_q_of_q_dot_2_7
                - cos_q_ground2
                    * (-d1_of_place_13)
                        .mul_add(
                            u_dot_by_q_ground1_of_q_dot_2_7,
                            u_dot_of_q_dot_2_5 - u_dot_by_q_of_q_dot_2_5,
                        ) + u_dot_by_q_ground1_of_q_dot_2_9);
    // u_dot_by_q_of_q_dot_2_15 - u_dot_by_q_ground1_of_q_dot_2_10
    let u_dot_by_q_ground1_of_q_dot_2_11 = u_dot_by_q_of_q_dot_2_15
        - u_dot_by_q_ground1_of_q_dot_2_10;
    // u_dot_by_q_ground1_of_q_dot_2_4 + u_dot_by_q_ground1_of_q_dot_2_11
    let u_dot_by_q_ground1_of_q_dot_2_12 = u_dot_by_q_ground1_of_q_dot_2_4
        + u_dot_by_q_ground1_of_q_dot_2_11;
    let u_dot_by_q_ground1_of_motion = q_ground1_dot * sin_angle_2_inv;
    let q_ground1_dot_sin_q_pin2 = q_ground1_dot * sin_q_pin2;
    let u_dot_by_q_ground1_of_motion_2 = d1_by_q_ground1_of_place
        * u_dot_by_q_ground1_of_motion * q_ground1_dot_sin_q_pin2;
    let u_dot_by_q_ground1_of_place = sin_angle_2_inv * cos_q_ground2;
    // cos(q_ground1 + q_pin2)*d1_by_q_ground1_of_place_2 +
    //   q_ground2_ddot_by_q_of_place_2*u_dot_by_q_ground1_of_place
    let u_dot_by_q_ground1_of_place_2 = q_ground2_ddot_by_q_of_place_2
        .mul_add(
            u_dot_by_q_ground1_of_place,
            d1_of_place_13 * d1_by_q_ground1_of_place_2,
        );
    let u_dot_by_q_ground1_of_place_3 = d1_of_place_16 * u_dot_of_place_12;
    let u_dot_by_q_ground1_of_place_4 = l_m_l_d1_of_place_11 * u_dot_of_place_25;
    let u_dot_by_q_ground1_of_place_5 = d1_of_place_8 * u_dot_of_place_30;
    let u_dot_by_q_ground1_of_q_dot_2_13 = d1_of_place_8 * u_dot_of_q_dot_2_22;
    // q_dot_2_sin_angle_inv*(4*u_dot_of_q_dot_2_10*q_ground2_ddot_by_q_of_place_2*u_dot_by_q_ground1_of_place_4
    //   + q_dot_2_sin_angle_inv*d1_by_q_ground1_of_place_7*u_dot_by_q_ground1_of_place_5) +
    //   2*d1_by_q_ground1_of_place_2*u_dot_by_q_ground1_of_q_dot_2_13
    let u_dot_by_q_ground1_of_q_dot_2_14 = q_dot_2_sin_angle_inv
        * (q_dot_2_sin_angle_inv * d1_by_q_ground1_of_place_7)
            .mul_add(
                u_dot_by_q_ground1_of_place_5,
                S::int(4) * u_dot_of_q_dot_2_10 * q_ground2_ddot_by_q_of_place_2
                    * u_dot_by_q_ground1_of_place_4,
            ) + S::int(2) * d1_by_q_ground1_of_place_2 * u_dot_by_q_ground1_of_q_dot_2_13;
    let u_dot_by_q_ground1_of_place_6 = u_dot_of_place_8 * u_dot_of_place_15;
    // u_dot_of_place_15 + u_dot_of_place_8*u_dot_of_place_16
    let u_dot_by_q_ground1_of_place_7 = u_dot_of_place_8
        .mul_add(u_dot_of_place_16, u_dot_of_place_15);
    // u_dot_of_place_8*(sin_angle_2_inv*u_dot_of_place_2 - u_dot_by_q_ground1_of_place_6) -
    //   u_dot_by_q_ground1_of_place_7
    let u_dot_by_q_ground1_of_place_8 = u_dot_of_place_8
        * sin_angle_2_inv.mul_add(u_dot_of_place_2, -u_dot_by_q_ground1_of_place_6)
        - u_dot_by_q_ground1_of_place_7;
    let u_dot_by_q_ground1_of_place_9 = u_dot_of_place_23 * d1_by_q_ground1_of_place;
    // u_dot_by_q_ground1 = (m*l^2*q'^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1))
    //   - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1)
    //   + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))*((2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (2*sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + 2*cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 -
    //   6*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q - q_ground1 + q_pin1)) -
    //   4*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   3*m*l^2*q'^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)^3*tan(q - q_ground1 + q_pin1)) -
    //   m*l^2*q'^2*sin(q_pin1)*(sin(q_pin1)*sin(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1) + cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   cos(q_ground1)*(cos(q) + cos(q + q_pin1))) - sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) + (sin(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))*(10 + 6*cos(q_pin2) +
    //   (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + 3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))
    //   - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 -
    //   2*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1))) -
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)) + cos(q - q_ground1 +
    //   q_pin1)*((sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + (sin(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1)) +
    //   sin(q_pin1)*((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 2 -
    //   1/tan(q - q_ground1 + q_pin1)^2 + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2) - 1)/tan(q_ground1 - q_ground2 + q_pin2)^2 + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1)
    //   + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/tan(q_ground2 - q_ground1 -
    //   q_pin2)))))/(sin(q - q_ground1 + q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) -
    //   m*l^2*sin(q_pin1)*(2 + 3*cos(q_pin2) + 2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))
    //   - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + 2*m*l^2*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) -
    //   m*l^2*(2*cos(q)*sin(q_ground1) - 2*sin(q)*cos(q_ground1) +
    //   3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))*(q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*(cos(q_ground1)*(q'*cos(q) + cos(q +
    //   q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))) - q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q +
    //   q_pin1))/sin(q - q_ground1 + q_pin1) - q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q +
    //   q_pin1))/sin(q - q_ground1 + q_pin1) + sin(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' +
    //   q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))))/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*(2*sin(q)*sin(q_ground1) + 2*cos(q)*cos(q_ground1) +
    //   3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))))*(q'*(sin(q_ground1)*(cos(q) + cos(q +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) - m*l^2*sin(q_pin1)*(2 + 3*cos(q_pin2)
    //   + 2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*q'^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   q'^2*cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + q'^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   q'^2*cos(q_pin1)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + q'*sin(q_pin1)*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(q' -
    //   q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + 2*q'*sin(q_pin1)*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(q' -
    //   q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)^2) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q - q_ground1 + q_pin1)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q - q_ground1 + q_pin1)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)) + 2*q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)^2) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q - q_pin1)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - q'*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q -
    //   q_ground1 + q_pin1)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   q'*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   q'*sin(q_pin1)*(q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 +
    //   q_pin1)) - q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   sin(q_ground2)*(q'*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   q'*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   cos(q_ground1 + q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))) + sin(q_ground1 + q_pin2)*(q'*sin(q_pin1)/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   q'*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) + cos(q_ground2)*(q'*sin(q_ground1)*sin(q_pin1)/sin(q
    //   - q_ground1 + q_pin1) + q'*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q
    //   - q_pin1)) + sin(q_ground1 + q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(q'*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - q'*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) - q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) -
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) -
    //   m*l^2*(2*sin(q)*cos(q_ground1) - 2*cos(q)*sin(q_ground1) -
    //   3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(q'*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) + 2*q'*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) +
    //   q'*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))*(q' -
    //   q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*(q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q +
    //   q_pin1))/sin(q - q_ground1 + q_pin1) + q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q +
    //   q_pin1))/sin(q - q_ground1 + q_pin1) - cos(q_ground1)*(q'*cos(q) + cos(q + q_pin1)*(q' +
    //   q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))) - sin(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q)
    //   + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) + q'*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q'*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - q'*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) +
    //   q'*(q'*sin(q_ground1)*sin(q_pin1)*(cos(q) + cos(q + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   q'*cos(q_ground1)*sin(q_pin1)*(sin(q) + sin(q + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) - q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) - sin(q_ground1)*(q'*cos(q) + cos(q + q_pin1)*(q' +
    //   q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))) + cos(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q)
    //   + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))) +
    //   sin(q_ground1)*sin(q + q_pin1)*(q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))
    //   + q'*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1)) + cos(q_ground1)*cos(q + q_pin1)*(q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1))
    //   - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + q'*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) - 3*m*l*((g*cos(q +
    //   q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1))) +
    //   sin(q_pin1)*(l*(q'^2*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1))) - q_ground1'*sin(q_pin2)*(q_ground1'*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + q_ground1'*(sin(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))) - g*(3*sin(q_ground1) + cos(q_ground2)*sin(q_pin2)/(sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + sin(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) + cos(q_ground1 +
    //   q_pin2)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1)
    //   + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 +
    //   q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2)))))/sin(q - q_ground1 + q_pin1) - (g*cos(q + q_pin1)*(cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))) + sin(q_pin1)*(l*(q'^2*(cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))) + sin(q_pin2)*(q_pin2'^2 +
    //   q_ground1'*(q_ground1'*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   2*q_pin2'))) - g*(3*cos(q_ground1) + cos(q_ground2)*sin(q_pin2)/sin(q_ground1 - q_ground2 + q_pin2)
    //   + cos(q_ground1 + q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2)))))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))))/(6*d1) +
    //   d1_by_q_ground1*(2*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q)
    //   + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) - m*l^2*(2*cos(q)*sin(q_ground1) -
    //   2*sin(q)*cos(q_ground1) + 3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(q'*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   q'*(cos(q_ground1)*(q'*cos(q) + cos(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1))
    //   - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))) -
    //   q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*q'^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + m*l^2*sin(q_pin1)*(2 + 3*cos(q_pin2) +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) -
    //   3*m*l*(l*q_pin1'*sin(q_pin1)*(2*q' + q_pin1') - g*(3*cos(q) + cos(q + q_pin1)) + (g*cos(q +
    //   q_pin1)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))) +
    //   sin(q_pin1)*(l*(q'^2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1))) + sin(q_pin2)*(q_pin2'^2 + q_ground1'*(q_ground1'*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + 2*q_pin2'))) - g*(3*cos(q_ground1) +
    //   cos(q_ground2)*sin(q_pin2)/sin(q_ground1 - q_ground2 + q_pin2) + cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q - q_ground1 +
    //   q_pin1)))/(6*d1^2)
    let u_dot_by_q_ground1 = d1_inv_by_6
        * (m_l_times_3
            * (u_dot_by_q_of_motion
                + sin_angle_inv
                    * (sin_q_pin1
                        * (l
                            * (-q_dot_2_sq)
                                .mul_add(u_dot_of_place_37, u_dot_by_q_ground1_of_motion_2)
                            + g
                                * (sin_q_ground1
                                    .mul_add(S::int(3), u_dot_by_q_ground1_of_place_2)
                                    + u_dot_by_q_ground1_of_place_3))
                        - g_cos_q_plus_q_pin1 * u_dot_of_place_37)) - u_dot_by_q_of_q_dot_2_28
            - u_dot_of_place_39
                * (u_dot_by_q_of_q_dot_2_21
                    + q_dot_2_sin_angle_inv
                        * ((-u_dot_of_q_dot_2_27)
                            .mul_add(sin_q_ground1, u_dot_of_q_dot_2_25 * cos_q_ground1)
                            - u_dot_by_q_of_q_dot_2_17
                            + u_dot_by_q_of_q_dot_2_8 * q_ground1_ddot_by_q_of_place_4))
            - u_dot_of_place_11 * u_dot_by_q_ground1_of_q_dot_2_12
            + u_dot_by_q_ground1_of_q_dot_2_14
            - u_dot_by_q_of_q_dot_2_22
                * (u_dot_by_q_of_place_9
                    - sin_q_pin1
                        * (sin_q_pin2
                            * (u_dot_by_q_of_place_6 + u_dot_by_q_of_place_8
                                - sin_q_pin1
                                    * (S::int(2) + u_dot_by_q_of_place_5
                                        + u_dot_by_q_ground1_of_place_8))
                            + u_dot_by_q_ground1_of_place_9))) - d1_by_q_ground1 * u_dot_d1_inv;
    // q_ground1_ddot_by_q_ground1 = (sin(q_pin1)*(u'/tan(q - q_ground1 + q_pin1) + u_dot_by_q_ground1) -
    //   q'^2*(sin(q_pin1) - (sin(q_pin1)*(sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) -
    //   sin(q_ground1)*(cos(q) + cos(q + q_pin1)) + (sin(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   cos(q_ground1)*(cos(q) + cos(q + q_pin1)) + cos(q - q_ground1 + q_pin1)*(2 - 3*(sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1)))/tan(q_ground1 - q - q_pin1)) + cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q +
    //   q_pin1) + 2*(cos(q) + cos(q + q_pin1))/tan(q - q_ground1 + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q
    //   + q_pin1) + 2*(sin(q) + sin(q + q_pin1))/tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)
    let q_ground1_ddot_by_q_ground1 = sin_q_pin1_sin_angle_inv
        * (u_dot_by_q_ground1 + q_ground1_ddot_by_q_of_u_dot) - q_ground1_ddot_by_q_of_q_dot_2_10;
    // u_dot_of_place_8 - cos_angle_sin_angle_inv
    let q_ground2_ddot_by_q_ground1_of_place = u_dot_of_place_8 - cos_angle_sin_angle_inv;
    // u_dot_of_place_8 - u_dot_by_q_of_place_4
    let q_ground2_ddot_by_q_ground1_of_place_2 = u_dot_of_place_8 - u_dot_by_q_of_place_4;
    // q_ground2_ddot_by_q_ground1 = -(q'^2*(sin(q_pin1)*sin(q_pin2) +
    //   (sin(q_pin1)*(sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + (sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) + cos(q - q_ground1 + q_pin1)*(2 - 3*(sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))/tan(q -
    //   q_ground1 + q_pin1) - (cos(q - q_ground1 + q_pin1)*cos(q_ground1 - q_ground2 + q_pin2)*(1 +
    //   (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1)) + sin(q_pin1)*(2*sin(q_pin2) + 3*cos(q_ground1 - q_ground2 +
    //   q_pin2)/tan(q_ground1 - q - q_pin1) + 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + (2 - 3*(sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) + cos(q_ground1 - q_ground2 +
    //   q_pin2)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) + 2*(sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/tan(q - q_ground1 +
    //   q_pin1)))/sin(q_ground1 - q_ground2 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2) +
    //   2*cos(q_ground1)*(1/tan(q_ground1 - q - q_pin1) + 1/tan(q_ground1 - q_ground2 + q_pin2)) +
    //   2*cos(q_ground1 + q_pin2)*(1/tan(q_ground1 - q - q_pin1) + 1/tan(q_ground1 - q_ground2 + q_pin2))) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2) - 2*sin(q_ground1)*(1/tan(q_ground1 - q -
    //   q_pin1) + 1/tan(q_ground1 - q_ground2 + q_pin2)) - 2*sin(q_ground1 + q_pin2)*(1/tan(q_ground1 - q -
    //   q_pin1) + 1/tan(q_ground1 - q_ground2 + q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2)) -
    //   cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1) - cos(q)*(2/tan(q_ground1 - q -
    //   q_pin1) + 1/tan(q_ground1 - q_ground2 + q_pin2)) - cos(q + q_pin1)*(2/tan(q_ground1 - q - q_pin1) +
    //   1/tan(q_ground1 - q_ground2 + q_pin2))) + cos(q_ground1)*(cos(q) + cos(q + q_pin1) +
    //   sin(q)*(2/tan(q_ground1 - q - q_pin1) + 1/tan(q_ground1 - q_ground2 + q_pin2)) + sin(q +
    //   q_pin1)*(2/tan(q_ground1 - q - q_pin1) + 1/tan(q_ground1 - q_ground2 + q_pin2)))))/sin(q - q_ground1
    //   + q_pin1)) + sin(q_pin1)*sin(q_pin2)*(u'*(1/tan(q_ground1 - q - q_pin1) + 1/tan(q_ground1 -
    //   q_ground2 + q_pin2)) - u_dot_by_q_ground1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2))
    let q_ground2_ddot_by_q_ground1 = -q_pin2_ddot_by_q_of_place_28
        * (sin_q_pin1_sin_q_pin2
            * u_dot.mul_add(q_ground2_ddot_by_q_ground1_of_place, -u_dot_by_q_ground1)
            + q_dot_2_sq
                * (sin_q_pin1_sin_q_pin2
                    - sin_angle_inv
                        * (sin_q_pin1
                            * (sin_q_pin2
                                * (u_dot_of_place_5
                                    - cos_angle_sin_angle_inv
                                        * (u_dot_of_place_37
                                            + cos_angle
                                                * (-u_dot_of_place_27)
                                                    .mul_add(sin_angle_inv_times_3, S::int(2)))
                                    + sin_angle_2_inv
                                        * (sin_q_pin1
                                            * (sin_q_pin2_doubled + d1_of_place_30_doubled
                                                + sin_angle_2_inv
                                                    * (S::int(2) - S::int(3) * u_dot_of_place_15
                                                        + cos_angle_2
                                                            * u_dot_of_place_14
                                                                .mul_add(u_dot_by_q_of_place_4, u_dot_of_place_2))
                                                - q_pin1_ddot_by_q_of_place_3 * cos_angle_2)
                                            + u_dot_of_place_20 * cos_angle_2))
                                - u_dot_of_place_23
                                    * (sin_q_ground2
                                        * d1_of_place_19_doubled
                                            .mul_add(
                                                q_ground2_ddot_by_q_ground1_of_place,
                                                d1_of_place_17,
                                            )
                                        + cos_q_ground2
                                            * (-d1_of_place_17_doubled)
                                                .mul_add(
                                                    q_ground2_ddot_by_q_ground1_of_place,
                                                    d1_of_place_19,
                                                )))
                            + cos_q_pin1 * sin_q_pin2
                                * (sin_q_ground1
                                    * (-u_dot_of_q_2_q_pin1_2)
                                        .mul_add(
                                            q_ground2_ddot_by_q_ground1_of_place_2,
                                            u_dot_of_q_2_q_pin1,
                                        )
                                    + cos_q_ground1
                                        * u_dot_of_q_2_q_pin1
                                            .mul_add(
                                                q_ground2_ddot_by_q_ground1_of_place_2,
                                                u_dot_of_q_2_q_pin1_2,
                                            )))));
    // q_pin1_ddot_by_q_ground1 = (sin(q_ground1)*(u'*(sin(q) + sin(q + q_pin1)) +
    //   u_dot_by_q_ground1*(cos(q) + cos(q + q_pin1))) - (q'^2*(cos(q - q_ground1 +
    //   q_pin1)*(2*sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + 2*cos(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   (sin(q_ground1)*(3*sin(q_pin1)*(sin(q) + sin(q + q_pin1)) + cos(q - q_ground1 +
    //   q_pin1)*(3*(cos(q)*(sin(q_pin1) + 2*cos(q_ground1)*(sin(q) + sin(q + q_pin1)) -
    //   sin(q_ground1)*(cos(q) + 2*cos(q + q_pin1))) + cos(q + q_pin1)*(sin(q_pin1) - sin(q_ground1)*cos(q +
    //   q_pin1) + 2*cos(q_ground1)*(sin(q) + sin(q + q_pin1))))/sin(q - q_ground1 + q_pin1) - 2*cos(q) -
    //   2*cos(q + q_pin1)) + 2*cos(q_ground1)*(2*sin(q + q_pin1)^2 - 2*cos(q + q_pin1)^2 + sin(q)*(sin(q) +
    //   3*sin(q + q_pin1)) - cos(q)*(cos(q) + 3*cos(q + q_pin1))) - 2*sin(q_ground1)*(sin(q)*(cos(q) + cos(q
    //   + q_pin1)) + 2*sin(q + q_pin1)*(cos(q) + cos(q + q_pin1)))) + cos(q_ground1)*(2*cos(q - q_ground1 +
    //   q_pin1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(sin(q)*(2*cos(q) + 4*cos(q + q_pin1) +
    //   3*(sin(q) + 2*sin(q + q_pin1))/tan(q_ground1 - q - q_pin1)) + sin(q + q_pin1)*(2*cos(q) + 4*cos(q +
    //   q_pin1) + 3*sin(q + q_pin1)/tan(q_ground1 - q - q_pin1))) + 3*sin(q_pin1)*(cos(q) + cos(q + q_pin1)
    //   + (sin(q) + sin(q + q_pin1))/tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1)) +
    //   sin(q_ground1)*(sin(q_ground1)*(sin(q + q_pin1)*(sin(q) + sin(q + q_pin1)) + cos(q)*(cos(q) + cos(q
    //   + q_pin1))) + 2*cos(q_ground1)*(sin(q + q_pin1)*cos(q + q_pin1) - sin(q)*cos(q))) +
    //   cos(q_ground1)^2*(sin(q)*(sin(q) + sin(q + q_pin1)) + cos(q + q_pin1)*(cos(q) + cos(q + q_pin1)))) +
    //   u'*cos(q - q_ground1 + q_pin1)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1))))/sin(q - q_ground1 + q_pin1) - cos(q_ground1)*(u_dot_by_q_ground1*(sin(q) + sin(q
    //   + q_pin1)) - u'*(cos(q) + cos(q + q_pin1))))/sin(q - q_ground1 + q_pin1)
    let q_pin1_ddot_by_q_ground1 = sin_angle_inv
        * (sin_q_ground1
            * u_dot_by_q_ground1
                .mul_add(u_dot_of_q_2_q_pin1_2, q_pin1_ddot_by_q_of_u_dot)
            - cos_q_ground1
                * u_dot_by_q_ground1
                    .mul_add(u_dot_of_q_2_q_pin1, -q_pin1_ddot_by_q_of_u_dot_2)
            - q_pin1_ddot_by_q_of_motion);
    let q_pin2_ddot_by_q_ground1_of_place = d1_of_place_11 * minus_d1_of_place_30;
    let u_dot_d1_of_place_11 = u_dot * d1_of_place_11;
    let q_pin2_ddot_by_q_ground1_of_place_2 = minus_d1_of_place_30 * cos_angle_sin_angle_inv;
    // q_pin2_ddot_by_q_ground1 = 2*q'^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   q'^2*cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + q'^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   q'^2*cos(q_pin1)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + q'*sin(q_pin1)*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(q' -
    //   q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + 2*q'*sin(q_pin1)*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(q' -
    //   q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)^2) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q - q_ground1 + q_pin1)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q - q_ground1 + q_pin1)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)) + 2*q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)^2) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q - q_pin1)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - q'*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q -
    //   q_ground1 + q_pin1)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   q'*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   q'*sin(q_pin1)*(q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 +
    //   q_pin1)) - q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   sin(q_ground2)*(q'*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   q'*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   cos(q_ground1 + q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))) + sin(q_ground1 + q_pin2)*(q'*sin(q_pin1)/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   q'*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) + cos(q_ground2)*(q'*sin(q_ground1)*sin(q_pin1)/sin(q
    //   - q_ground1 + q_pin1) + q'*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q
    //   - q_pin1)) + sin(q_ground1 + q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(q'*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - q'*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) - q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) -
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   u'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u'*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u_dot_by_q_ground1*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_ddot_by_q_ground1 = u_dot_by_q_ground1_of_q_dot_2_12
        + u_dot_by_q_ground1 * q_pin2_ddot_by_q_ground1_of_place
        + u_dot_d1_of_place_11 * (q_pin2_ddot_by_q_ground1_of_place_2 - d1_by_q_ground1_of_place);
    let u_dot_of_place_8_times_3 = S::int(3) * u_dot_of_place_8;
    // d1_of_place_30*d1_of_q_pin2*d1_by_q_ground1_of_place_5 -
    //   d1_of_place_22*d1_by_q_of_place_7*u_dot_of_place_8_times_3
    let d1_by_q_ground2_of_place = (-(d1_of_place_22 * d1_by_q_of_place_7))
        .mul_add(
            u_dot_of_place_8_times_3,
            d1_of_place_30 * d1_of_q_pin2 * d1_by_q_ground1_of_place_5,
        );
    let d1_by_q_ground2_of_place_2 = S::ratio(1, 3) * d1_by_q_ground2_of_place;
    // d1_by_q_ground2 = m*l^2*sin(q_pin1)^2*(2*sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   2*cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))) + (2*sin(q_pin2)^2/tan(q_ground1 -
    //   q_ground2 + q_pin2) + sin(q_ground2)*(cos(q_ground1 - q_ground2 + q_pin2)*(2*cos(q_ground1) +
    //   2*cos(q_ground1 + q_pin2) + 3*cos(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   2*(cos(q_ground1)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*cos(q_ground1
    //   + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) + 2*cos(q_ground2)*(cos(q_ground1 + q_pin2)^2 -
    //   sin(q_ground1 + q_pin2)^2 + cos(q_ground1)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2)) -
    //   sin(q_ground1)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2))) +
    //   2*sin(q_ground2)*(sin(q_ground1)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + sin(q_ground1 +
    //   q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))) - cos(q_ground2)*(cos(q_ground1 - q_ground2 +
    //   q_pin2)*(2*sin(q_ground1) + 2*sin(q_ground1 + q_pin2) + 3*cos(q_pin2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2))) + 2*cos(q_ground2)*(sin(q_ground1)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2) + (sin(q_ground1) + 2*sin(q_ground1 + q_pin2))/tan(q_ground2 - q_ground1 - q_pin2)) +
    //   sin(q_ground1 + q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2) + sin(q_ground1 +
    //   q_pin2)/tan(q_ground2 - q_ground1 - q_pin2)))))/sin(q_ground1 - q_ground2 + q_pin2))/(3*sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2))
    let d1_by_q_ground2 = d1_by_q_of_place_7
        * (sin_q_ground2
            * (cos_q_ground2 * (d1_of_place_15 - d1_of_place_21)
                + d1_of_place_17 * d1_of_place_29) - d1_of_place_18 * u_dot_of_place)
        + d1_of_place_33 * u_dot_of_place_2 + d1_by_q_ground1_of_place_3
        - d1_by_q_ground2_of_place_2;
    let u_dot_by_q_ground2_of_place = d1_of_place_16 * sin_q_ground2;
    // q_pin2_ddot_by_q_of_place_15 + u_dot_by_q_ground2_of_place
    let u_dot_by_q_ground2_of_place_2 = q_pin2_ddot_by_q_of_place_15 + u_dot_by_q_ground2_of_place;
    let u_dot_by_q_ground2_of_place_3 = sin_q_pin1_sin_angle_inv * m_l_times_3;
    // u_dot_by_q_ground2 =
    //   d1_by_q_ground2*(2*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q)
    //   + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) - m*l^2*(2*cos(q)*sin(q_ground1) -
    //   2*sin(q)*cos(q_ground1) + 3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(q'*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   q'*(cos(q_ground1)*(q'*cos(q) + cos(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1))
    //   - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))) -
    //   q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*q'^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + m*l^2*sin(q_pin1)*(2 + 3*cos(q_pin2) +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) -
    //   3*m*l*(l*q_pin1'*sin(q_pin1)*(2*q' + q_pin1') - g*(3*cos(q) + cos(q + q_pin1)) + (g*cos(q +
    //   q_pin1)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))) +
    //   sin(q_pin1)*(l*(q'^2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1))) + sin(q_pin2)*(q_pin2'^2 + q_ground1'*(q_ground1'*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + 2*q_pin2'))) - g*(3*cos(q_ground1) +
    //   cos(q_ground2)*sin(q_pin2)/sin(q_ground1 - q_ground2 + q_pin2) + cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q - q_ground1 +
    //   q_pin1)))/(6*d1^2) -
    //   (4*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   m*l^2*q'^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))*((2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (2*sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + 2*cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 +
    //   2*m*l^2*q'^2*sin(q_pin1)^2*sin(q_pin2)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin1)*sin(q_pin2)*((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1 +
    //   ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) -
    //   1)/tan(q_ground1 - q_ground2 + q_pin2)^2 + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) + (sin(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) +
    //   2*m*l^2*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) + m*l^2*sin(q_pin1)*(2 +
    //   3*cos(q_pin2) + 2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(q'^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   q'^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q' -
    //   q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)*tan(q_ground1 - q_ground2 +
    //   q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q - q_pin1)) + q'*sin(q_pin1)*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)) + 2*q'*sin(q_pin1)*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)^2) + q'*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(q'*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 +
    //   q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   cos(q_ground2)*(q'*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) - sin(q_ground2)*sin(q_ground1 +
    //   q_pin2)*(q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))) - cos(q_ground2)*cos(q_ground1 +
    //   q_pin2)*(q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)*sin(q_pin2)/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   q'*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*sin(q_pin1)*(g*(cos(q_ground2)*sin(q_pin2)/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1
    //   - q_ground2 + q_pin2)) - sin(q_ground2)*sin(q_pin2)/sin(q_ground1 - q_ground2 + q_pin2) +
    //   cos(q_ground1 + q_pin2)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))) + l*q_ground1'*sin(q_pin2)*(q_ground1'*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + q_ground1'*(sin(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1))/(6*d1)
    let u_dot_by_q_ground2 = d1_inv_by_6
        * (u_dot_of_place_11
            * (u_dot_by_q_ground1_of_q_dot_2_4
                + u_dot_of_q_dot_2_21
                    * (u_dot_by_q_ground1_of_q_dot_2_6 - q_ground2_ddot_by_q_of_q_dot_2)
                + q_dot_2_d1_of_place_11
                    * ((-u_dot_of_q_dot_2_7)
                        .mul_add(sin_q_ground2, u_dot_of_q_dot_2_5 * cos_q_ground2)
                        - u_dot_by_q_ground1_of_q_dot_2_9
                        + u_dot_by_q_ground1_of_q_dot_2_6 * u_dot_by_q_ground2_of_place_2))
            - u_dot_by_q_ground1_of_q_dot_2_14
            - q_dot_2_d1_of_place_11 * q_dot_2_sin_angle_inv * u_dot_of_place_26
                * (u_dot_by_q_ground1_of_place_9
                    - sin_q_pin1_sin_q_pin2 * (S::int(1) + u_dot_by_q_ground1_of_place_8))
            - u_dot_by_q_ground2_of_place_3
                * (g
                    * (-u_dot_of_place_13)
                        .mul_add(sin_q_ground2, u_dot_by_q_ground1_of_place_2)
                    + l * u_dot_by_q_ground1_of_motion_2)) - d1_by_q_ground2 * u_dot_d1_inv;
    // q_ground1_ddot_by_q_ground2 = u_dot_by_q_ground2*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    let q_ground1_ddot_by_q_ground2 = u_dot_by_q_ground2 * sin_q_pin1_sin_angle_inv;
    let q_ground2_ddot_by_q_ground2_of_q_dot_2 = q_dot_2_d1_of_place_11 * cos_q_pin2;
    let q_ground2_ddot_by_q_ground2_of_q_dot_2_2 = u_dot_of_q_dot_2_20 * sin_q_pin2_doubled;
    let q_ground2_ddot_by_q_ground2_of_q_dot_2_3 = u_dot_of_q_dot_2_20 * sin_q_pin2_times_3;
    // cos(q_ground1 - q_ground2 + q_pin2)*(q_dot_2_d1_of_place_11*q_ground2_ddot_by_q_ground2_of_q_dot_2_2
    //   - u_dot_of_q_dot_2_8*u_dot_of_q_dot_2_15) -
    //   q_ground2_ddot_by_q_of_q_dot_2*q_ground2_ddot_by_q_ground2_of_q_dot_2_3
    let q_ground2_ddot_by_q_ground2_of_q_dot_2_4 = cos_angle_2
        * (-u_dot_of_q_dot_2_8)
            .mul_add(
                u_dot_of_q_dot_2_15,
                q_dot_2_d1_of_place_11 * q_ground2_ddot_by_q_ground2_of_q_dot_2_2,
            ) - q_ground2_ddot_by_q_of_q_dot_2 * q_ground2_ddot_by_q_ground2_of_q_dot_2_3;
    // u_dot_of_q_dot_2_8*u_dot_of_q_dot_2_18 + q_ground2_ddot_by_q_ground2_of_q_dot_2_4
    let q_ground2_ddot_by_q_ground2_of_q_dot_2_5 = u_dot_of_q_dot_2_8
        .mul_add(u_dot_of_q_dot_2_18, q_ground2_ddot_by_q_ground2_of_q_dot_2_4);
    let q_ground2_ddot_by_q_ground2_of_q_dot_2_6 = d1_of_place_30 * u_dot_of_q_dot_2_20;
    let q_ground2_ddot_by_q_ground2_of_q_dot_2_7 = d1_of_place_6
        * q_ground2_ddot_by_q_of_q_dot_2_10;
    // q_ground2_ddot_by_q_ground2 = (q'^2*((cos(q_pin1)*sin(q_pin2)*cos(q_ground1 - q_ground2 +
    //   q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*(sin(q_pin2)*(sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1
    //   + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + cos(q_ground1 - q_ground2 +
    //   q_pin2)*(1/tan(q - q_ground1 + q_pin1) - (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))
    //   + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + cos(q_ground1 - q_ground2 + q_pin2)*(2
    //   - 3*(sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))) + cos(q_pin2)*(sin(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2) + 2*(cos(q_ground1) + cos(q_ground1 + q_pin2))/tan(q_ground1 - q_ground2 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2) + 2*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2))/tan(q_ground2 - q_ground1 - q_pin2)))) - cos(q - q_ground1 +
    //   q_pin1)*sin(q_pin2)*cos(q_ground1 - q_ground2 + q_pin2)*(1 + (sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/sin(q_ground1 -
    //   q_ground2 + q_pin2) - sin(q_pin1)^2*sin(q_pin2))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*sin(q_pin2)*(u'/tan(q_ground1 - q_ground2 + q_pin2) + u_dot_by_q_ground2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_ground2_ddot_by_q_ground2 = q_ground2_ddot_by_q_of_place
        * u_dot.mul_add(u_dot_of_place_8, u_dot_by_q_ground2)
        - u_dot_of_q_dot_2_14 * q_ground2_ddot_by_q_of_q_dot_2
        - q_ground2_ddot_by_q_of_q_dot_2_2 * u_dot_by_q_ground1_of_q_dot_2_5
        + q_dot_2_d1_of_place_11 * u_dot_by_q_ground1_of_q_dot_2_8
        - u_dot_of_q_dot_2_20 * d1_of_place_30_doubled * q_ground2_ddot_by_q_ground2_of_q_dot_2
        - q_ground2_ddot_by_q_ground2_of_q_dot_2_5
        + q_ground2_ddot_by_q_ground2_of_q_dot_2_3 * q_ground2_ddot_by_q_ground2_of_q_dot_2_6
        - q_ground2_ddot_by_q_of_place_2 * q_ground2_ddot_by_q_ground2_of_q_dot_2_7;
    // q_pin1_ddot_by_q_ground2 = u_dot_by_q_ground2*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)
    let q_pin1_ddot_by_q_ground2 = u_dot_by_q_ground2 * d1_of_place_7;
    let q_pin2_ddot_by_q_ground2_of_place = d1_of_place_19 * u_dot_of_place_8;
    // d1_of_place_17 + q_pin2_ddot_by_q_ground2_of_place
    let q_pin2_ddot_by_q_ground2_of_place_2 = d1_of_place_17 + q_pin2_ddot_by_q_ground2_of_place;
    // d1_of_place_19 - d1_of_place_17*u_dot_of_place_8
    let q_pin2_ddot_by_q_ground2_of_place_3 = (-d1_of_place_17)
        .mul_add(u_dot_of_place_8, d1_of_place_19);
    // d1_of_place_13_sq - d1_of_place_16_sq
    let q_pin2_ddot_by_q_ground2_of_place_4 = d1_of_place_13_sq - d1_of_place_16_sq;
    let cos_q_ground2_doubled = S::int(2) * cos_q_ground2;
    let sin_angle_2_inv_times_3 = S::int(3) * sin_angle_2_inv;
    // cos(q_ground1 - q_ground2 + q_pin2)*(d1_of_place_19_doubled -
    //   q_pin2_ddot_by_q_of_place_14*sin_angle_2_inv_times_3)
    let q_pin2_ddot_by_q_ground2_of_place_5 = cos_angle_2
        * (-q_pin2_ddot_by_q_of_place_14)
            .mul_add(sin_angle_2_inv_times_3, d1_of_place_19_doubled);
    let d1_of_place_14_doubled = S::int(2) * d1_of_place_14;
    // cos(q_ground1)*(q_pin2_ddot_by_q_of_place_8 - q_pin2_ddot_by_q_of_place_5*sin(q_ground2)) +
    //   sin(q_ground1)*(q_pin2_ddot_by_q_of_place_4 + q_pin2_ddot_by_q_of_place_25*cos(q_ground2))
    let q_pin2_ddot_by_q_ground2_of_place_6 = cos_q_ground1
        * (-q_pin2_ddot_by_q_of_place_5)
            .mul_add(sin_q_ground2, q_pin2_ddot_by_q_of_place_8)
        + sin_q_ground1
            * q_pin2_ddot_by_q_of_place_25
                .mul_add(cos_q_ground2, q_pin2_ddot_by_q_of_place_4);
    // cos(q - q_ground1 + q_pin1)*(sin_angle_inv*q_pin2_ddot_by_q_ground2_of_place_6 - d1_of_place_30)
    let q_pin2_ddot_by_q_ground2_of_place_7 = cos_angle
        * sin_angle_inv.mul_add(q_pin2_ddot_by_q_ground2_of_place_6, -d1_of_place_30);
    let q_pin2_ddot_by_q_ground2_of_q_dot_2 = q_dot_2 * q_dot_2_sin_angle_inv;
    // q_pin2_ddot_by_q_ground2 = (sin(q_pin1)*(u'*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2) + (cos(q_ground1) + cos(q_ground1 + q_pin2))/tan(q_ground1 - q_ground2 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2) + (sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/tan(q_ground2 - q_ground1 - q_pin2))) + u_dot_by_q_ground2*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))) -
    //   q'^2*(sin(q_pin1)*((cos(q_ground1 - q_ground2 + q_pin2)*(cos(q - q_ground1 +
    //   q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1)
    //   + sin(q_ground1 + q_pin2)) + (sin(q_ground1)*(cos(q_ground2)*(cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - cos(q)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - cos(q + q_pin1)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2))) + sin(q_ground2)*(cos(q)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) +
    //   cos(q + q_pin1)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))) +
    //   cos(q_ground1)*(cos(q_ground2)*sin(q_ground1 + q_pin2)*(sin(q) + sin(q + q_pin1)) -
    //   sin(q_ground2)*(sin(q)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + sin(q + q_pin1)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)))))/sin(q - q_ground1 + q_pin1)) +
    //   sin(q_pin1)*(2*sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/tan(q - q_ground1 + q_pin1) + 2*cos(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - (sin(q_ground2)*(3*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))
    //   + cos(q_ground1 - q_ground2 + q_pin2)*(3*(cos(q_ground1)*(sin(q_pin2) +
    //   2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   2*cos(q_ground1 + q_pin2))) + cos(q_ground1 + q_pin2)*(sin(q_pin2) - sin(q_ground2)*cos(q_ground1 +
    //   q_pin2) + 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2) - 2*cos(q_ground1) - 2*cos(q_ground1 + q_pin2)) + 2*cos(q_ground2)*(2*sin(q_ground1 +
    //   q_pin2)^2 - 2*cos(q_ground1 + q_pin2)^2 - cos(q_ground1)*(cos(q_ground1) + 3*cos(q_ground1 +
    //   q_pin2)) + sin(q_ground1)*(sin(q_ground1) + 3*sin(q_ground1 + q_pin2))) -
    //   2*sin(q_ground2)*(sin(q_ground1)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + 2*sin(q_ground1 +
    //   q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))) + cos(q_ground2)*(2*cos(q_ground1 - q_ground2 +
    //   q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) + 3*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2) + (sin(q_ground1) + sin(q_ground1 + q_pin2))/tan(q_ground2 - q_ground1 - q_pin2)) +
    //   cos(q_ground2)*(sin(q_ground1)*(2*cos(q_ground1) + 4*cos(q_ground1 + q_pin2) + 3*(sin(q_ground1) +
    //   2*sin(q_ground1 + q_pin2))/tan(q_ground2 - q_ground1 - q_pin2)) + sin(q_ground1 +
    //   q_pin2)*(2*cos(q_ground1) + 4*cos(q_ground1 + q_pin2) + 3*sin(q_ground1 + q_pin2)/tan(q_ground2 -
    //   q_ground1 - q_pin2)))))/sin(q_ground1 - q_ground2 + q_pin2))) +
    //   sin(q_pin1)*(sin(q_ground2)*(sin(q_ground2)*(sin(q_ground1 + q_pin2)*(sin(q_ground1) + sin(q_ground1
    //   + q_pin2)) + cos(q_ground1)*(cos(q_ground1) + cos(q_ground1 + q_pin2))) +
    //   2*cos(q_ground2)*(sin(q_ground1 + q_pin2)*cos(q_ground1 + q_pin2) - sin(q_ground1)*cos(q_ground1)))
    //   + cos(q_ground2)^2*(sin(q_ground1)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) + cos(q_ground1 +
    //   q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))))/sin(q_ground1 - q_ground2 + q_pin2) + cos(q -
    //   q_ground1 + q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   (sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 + q_pin2)) +
    //   sin(q_ground1)*(sin(q_ground2)*(sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) -
    //   cos(q)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - cos(q + q_pin1)*(sin(q_ground1) + sin(q_ground1
    //   + q_pin2))) - cos(q_ground2)*(cos(q)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + cos(q +
    //   q_pin1)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))) + cos(q_ground1)*(sin(q_ground2)*sin(q_ground1
    //   + q_pin2)*(sin(q) + sin(q + q_pin1)) + cos(q_ground2)*(sin(q_pin1) + sin(q)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) + sin(q + q_pin1)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))))/sin(q -
    //   q_ground1 + q_pin1))) + cos(q_pin1)*(sin(q_ground1)*(sin(q_ground2)*(cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)) - cos(q)*(sin(q_ground1) + sin(q_ground1 + q_pin2) + (cos(q_ground1) + cos(q_ground1 +
    //   q_pin2))/tan(q_ground1 - q_ground2 + q_pin2)) - cos(q + q_pin1)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2) + (cos(q_ground1) + cos(q_ground1 + q_pin2))/tan(q_ground1 - q_ground2 + q_pin2))) -
    //   cos(q_ground2)*(cos(q)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + cos(q + q_pin1)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) + (cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - cos(q)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - cos(q + q_pin1)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/tan(q_ground1
    //   - q_ground2 + q_pin2))) + cos(q_ground1)*(sin(q)*(cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2) + sin(q_ground1 + q_pin2)/tan(q_ground2 - q_ground1 - q_pin2)) +
    //   sin(q_ground2)*(sin(q_ground1 + q_pin2) + (cos(q_ground1) + cos(q_ground1 + q_pin2))/tan(q_ground1 -
    //   q_ground2 + q_pin2))) + sin(q + q_pin1)*(cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2) +
    //   sin(q_ground1 + q_pin2)/tan(q_ground2 - q_ground1 - q_pin2)) + sin(q_ground2)*(sin(q_ground1 +
    //   q_pin2) + (cos(q_ground1) + cos(q_ground1 + q_pin2))/tan(q_ground1 - q_ground2 + q_pin2))))))/sin(q
    //   - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_ddot_by_q_ground2 = q_pin2_ddot_by_q_of_place_28
        * (sin_q_pin1
            * (u_dot
                * q_pin2_ddot_by_q_ground2_of_place_3
                    .mul_add(
                        cos_q_ground2,
                        q_pin2_ddot_by_q_ground2_of_place_2 * sin_q_ground2,
                    ) + u_dot_by_q_ground2 * minus_d1_of_place_30)
            - q_pin2_ddot_by_q_ground2_of_q_dot_2
                * (cos_q_pin1
                    * (u_dot_of_q_2_q_pin1 * cos_q_ground1
                        * (cos_q_ground2
                            * (-d1_of_place_16).mul_add(u_dot_of_place_8, d1_of_place_19)
                            + sin_q_ground2 * (d1_of_place_16 + q_pin2_ddot_by_q_ground2_of_place))
                        + sin_q_ground1
                            * (sin_q_ground2
                                * (-u_dot_of_q_2_q_pin1_2)
                                    .mul_add(
                                        q_pin2_ddot_by_q_ground2_of_place_2, u_dot_of_place_3,
                                    )
                                - cos_q_ground2
                                    * u_dot_of_place_8
                                        .mul_add(
                                            q_pin2_ddot_by_q_of_place_25,
                                            q_pin2_ddot_by_q_of_place_3,
                                        )))
                    + sin_q_pin1
                        * (cos_angle
                            * (u_dot_of_place_2
                                - sin_angle_inv
                                    * (sin_q_ground1
                                        * (-q_pin2_ddot_by_q_of_place_3)
                                            .mul_add(
                                                cos_q_ground2,
                                                q_pin2_ddot_by_q_of_place_2 * sin_q_ground2,
                                            )
                                        + cos_q_ground1
                                            * u_dot_of_q_2_q_pin1
                                                .mul_add(
                                                    u_dot_by_q_ground2_of_place,
                                                    q_pin2_ddot_by_q_of_place_6 * cos_q_ground2,
                                                ) + u_dot_by_q_ground2_of_place_2 * sin_q_pin1))
                            + sin_angle_2_inv
                                * (sin_q_pin1
                                    * (cos_q_ground2_sq
                                        * d1_of_place_13
                                            .mul_add(d1_of_place_19, d1_of_place_17 * sin_q_ground1)
                                        + sin_q_ground2
                                            * (sin_q_ground2
                                                * d1_of_place_19
                                                    .mul_add(cos_q_ground1, d1_of_place_16 * d1_of_place_17)
                                                + cos_q_ground2_doubled
                                                    * (-sin_q_ground1)
                                                        .mul_add(cos_q_ground1, d1_of_place_16 * d1_of_place_13)))
                                    + cos_angle_2
                                        * (sin_q_pin1
                                            * (-q_pin2_ddot_by_q_ground1_of_place_2
                                                + S::int(2) * u_dot_of_place_2
                                                + sin_angle_2_inv
                                                    * (sin_q_ground2
                                                        * (S::int(2) * d1_of_place_19 * d1_of_place_20
                                                            * sin_q_ground2 - d1_of_place_17 * sin_q_pin2_times_3
                                                            + cos_q_ground2_doubled
                                                                * (cos_q_ground1
                                                                    * d1_of_place_13.mul_add(S::int(3), cos_q_ground1)
                                                                    - sin_q_ground1
                                                                        * d1_of_place_16.mul_add(S::int(3), sin_q_ground1)
                                                                    + S::int(2) * q_pin2_ddot_by_q_ground2_of_place_4)
                                                            + q_pin2_ddot_by_q_ground2_of_place_5)
                                                        - cos_q_ground2
                                                            * (d1_of_place_17_doubled * cos_angle_2
                                                                + sin_q_pin2_times_3 * q_pin2_ddot_by_q_ground2_of_place_3
                                                                + cos_q_ground2
                                                                    * (sin_q_ground1
                                                                        * (-d1_of_place_20)
                                                                            .mul_add(u_dot_of_place_8_times_3, d1_of_place_14_doubled)
                                                                        + d1_of_place_16
                                                                            * (-d1_of_place_16)
                                                                                .mul_add(
                                                                                    u_dot_of_place_8_times_3,
                                                                                    d1_of_place_14_doubled,
                                                                                ))))) + q_pin2_ddot_by_q_ground2_of_place_7)))));
    // minus_u_dot_of_place_5*sin(q_pin1) + q_ground1_ddot_by_q_of_place_4*cos(q_pin1)
    let d1_by_q_pin1_of_place = q_ground1_ddot_by_q_of_place_4
        .mul_add(cos_q_pin1, minus_u_dot_of_place_5 * sin_q_pin1);
    let d1_by_q_pin1_of_place_2 = sin_angle_inv * q_ground1_ddot_by_q_of_place;
    // d1_of_place_24*sin(q_pin1) + d1_by_q_of_place_9*cos(q_pin1)
    let d1_by_q_pin1_of_place_3 = d1_by_q_of_place_9
        .mul_add(cos_q_pin1, d1_of_place_24 * sin_q_pin1);
    // d1_by_q_of_place_10 + 3*d1_by_q_pin1_of_place_3
    let d1_by_q_pin1_of_place_4 = d1_by_q_pin1_of_place_3
        .mul_add(S::int(3), d1_by_q_of_place_10);
    let d1_by_q_pin1_of_place_5 = q_ground1_ddot_by_q_of_place * q_pin2_ddot_by_q_of_place_28;
    // d1_by_q_pin1 = m*l^2*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))*(2*sin(q)*cos(q_ground1) - 2*cos(q)*sin(q_ground1) -
    //   3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))/(6*sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + m*l^2*(2*sin(q)*cos(q_ground1) -
    //   2*cos(q)*sin(q_ground1) - 3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(sin(q_ground1)*sin(q + q_pin1) +
    //   cos(q_ground1)*cos(q + q_pin1))/(6*sin(q - q_ground1 + q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) +
    //   m*l^2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))*(2*sin(q)*cos(q_ground1) - 2*cos(q)*sin(q_ground1) -
    //   3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)) - cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))/(6*sin(q -
    //   q_ground1 + q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) - m*l^2*(6*sin(q_pin1) +
    //   (2*sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - 2*cos(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   3*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1))))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + (2*sin(q_ground1)*sin(q +
    //   q_pin1) + 2*cos(q_ground1)*cos(q + q_pin1) + 3*sin(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + 3*cos(q_pin1)*(sin(q_ground1)*sin(q +
    //   q_pin1) + cos(q_ground1)*cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/6 +
    //   m*l^2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))*(sin(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   cos(q_pin1)*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))))/(2*sin(q - q_ground1 +
    //   q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) +
    //   2*m*l^2*sin(q_pin1)*cos(q_pin1)*sin(q_pin2)^2/(3*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)^2) + 2*m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(3*sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*sin(q_pin1)*cos(q_pin1)*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(3*sin(q - q_ground1 + q_pin1)^2) + m*l^2*sin(q_pin1)^2*(10 + 6*cos(q_pin2) +
    //   (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + 3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))
    //   - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(3*sin(q - q_ground1 + q_pin1)^2*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*sin(q_pin1)*cos(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(2 + 3*cos(q_pin2) +
    //   2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/(3*sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + m*l^2*sin(q_pin1)^2*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(2 +
    //   3*cos(q_pin2) + 2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(3*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q -
    //   q_pin1))
    let d1_by_q_pin1 = d1_by_q_of_place_4 * (d1_by_q_of_place_2 + q_ground1_ddot_by_q_of_place_4)
        - l_m_l_by_6
            * (d1_by_q_of_place_6 + S::int(6) * sin_q_pin1
                + sin_angle_inv
                    * d1_by_q_pin1_of_place
                        .mul_add(S::int(3), S::int(2) * q_ground1_ddot_by_q_of_place_4))
        - S::ratio(1, 3) * d1_by_q_of_place * d1_by_q_pin1_of_place_2
        - d1_by_q_of_place_13 * d1_by_q_pin1_of_place_4
        - S::ratio(2, 3) * l_m_l_d1_of_place_11 * sin_q_pin2_sq * d1_by_q_pin1_of_place_5;
    let u_dot_by_q_pin1_of_q_dot_2 = u_dot_of_q_dot_2_10 * q_ground1_ddot_by_q_of_place;
    // q_ground1_ddot_by_q_of_q_dot_2 + minus_d1_of_place_30*u_dot_by_q_pin1_of_q_dot_2
    let u_dot_by_q_pin1_of_q_dot_2_2 = minus_d1_of_place_30
        .mul_add(u_dot_by_q_pin1_of_q_dot_2, q_ground1_ddot_by_q_of_q_dot_2);
    let u_dot_by_q_pin1_of_q_dot_2_3 = u_dot_by_q_pin1_of_q_dot_2 * sin_q_pin2;
    // u_dot_of_q_dot_2_30 + q_dot_2_sin_angle_inv*q_ground1_ddot_by_q_of_place_4
    let u_dot_by_q_pin1_of_q_dot_2_4 = q_dot_2_sin_angle_inv
        .mul_add(q_ground1_ddot_by_q_of_place_4, u_dot_of_q_dot_2_30);
    // q_ground1_ddot_by_q_of_q_dot_2 - u_dot_by_q_pin1_of_q_dot_2_4
    let u_dot_by_q_pin1_of_q_dot_2_5 = q_ground1_ddot_by_q_of_q_dot_2
        - u_dot_by_q_pin1_of_q_dot_2_4;
    let u_dot_by_q_pin1_of_place = minus_d1_of_place_30 * cos_q_pin1;
    let u_dot_by_q_pin1_of_place_2 = u_dot_of_place_9 * cos_q_pin1;
    let u_dot_by_q_pin1_of_place_3 = minus_u_dot_of_place_5 * d1_by_q_of_place_5;
    // u_dot_by_q_pin1 =
    //   (6*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q - q_ground1 + q_pin1)) -
    //   2*m*l^2*q'^2*cos(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) -
    //   m*l^2*q'^2*cos(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 +
    //   3*m*l^2*q'^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)^3*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*q'^2*sin(q_pin1)*(sin(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*sin(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1) + cos(q_pin1)*cos(q - q_ground1 + q_pin1)*(1 - (sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1)) + cos(q_pin1)*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))
    //   + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1))
    //   - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) - (sin(q_ground1)*sin(q + q_pin1) + cos(q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q -
    //   q_ground1 + q_pin1)))*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 +
    //   2*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*sin(q + q_pin1) +
    //   cos(q_ground1)*cos(q + q_pin1)) - sin(q_pin1)*sin(q_pin2)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1))
    //   - sin(q_ground1)*(cos(q) + cos(q + q_pin1))) -
    //   cos(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))) +
    //   sin(q_pin1)*(cos(q_pin1)*cos(q_pin2)*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1 + 1/tan(q - q_ground1 + q_pin1)^2) - sin(q - q_ground1 + q_pin1)*(1 +
    //   (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1)) - cos(q - q_ground1 + q_pin1)*((sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))
    //   + (sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 + q_pin1)) -
    //   cos(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 + q_pin2)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) - m*l^2*cos(q_pin1)*(2 + 3*cos(q_pin2) +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) + m*l^2*sin(q_pin1)*(2 +
    //   3*cos(q_pin2) + 2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + m*l^2*(2*cos(q)*sin(q_ground1) - 2*sin(q)*cos(q_ground1) +
    //   3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))*(q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*(cos(q_ground1)*(q'*cos(q) + cos(q +
    //   q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))) - q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q +
    //   q_pin1))/sin(q - q_ground1 + q_pin1) - q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q +
    //   q_pin1))/sin(q - q_ground1 + q_pin1) + sin(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' +
    //   q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))))/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 -
    //   3*m*l^2*(sin(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   cos(q_pin1)*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))))*(q'*(sin(q_ground1)*(cos(q) + cos(q +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(2*sin(q)*cos(q_ground1) -
    //   2*cos(q)*sin(q_ground1) - 3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(q'*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) + 2*q'*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) +
    //   q'*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))*(q' - q'*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   q'*(q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   cos(q_ground1)*(q'*cos(q) + cos(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))) - sin(q_ground1)*(q'*sin(q)
    //   + sin(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))*(q'*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   q'*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - q'*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) +
    //   q'*(q'*sin(q_ground1)*sin(q_pin1)*cos(q + q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   q'*cos(q_ground1)*sin(q_pin1)*sin(q + q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   q'*sin(q_ground1)*cos(q_pin1)*(sin(q) + sin(q + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) + q'*cos(q_ground1)*cos(q_pin1)*(cos(q) + cos(q + q_pin1))/sin(q - q_ground1 +
    //   q_pin1) - q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) - sin(q_ground1)*(cos(q + q_pin1)*(q' +
    //   q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1)) - sin(q + q_pin1)*(q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))
    //   + q'*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 + q_pin1)))
    //   + cos(q_ground1)*(sin(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)) + cos(q +
    //   q_pin1)*(q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + q'*(sin(q_ground1)*sin(q +
    //   q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 + q_pin1))))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*sin(q_pin1)*(2 + 3*cos(q_pin2)
    //   + 2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(q'^2*sin(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + 2*q'^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   q'^2*cos(q_pin1)*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q +
    //   q_pin1))*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1)
    //   + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + 2*q'*sin(q_pin1)*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q - q_ground1 + q_pin1)^2) + q'*cos(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q' -
    //   q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   q'*cos(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q - q_pin1)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*cos(q_pin1)*(cos(q_ground2)*(q'*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(q'*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) - q'*cos(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - q'*(sin(q_ground1)*sin(q + q_pin1) +
    //   cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) - q'*cos(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   q'*cos(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q - q_pin1)) + q'*cos(q_pin1)*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   q'*sin(q_pin1)*(q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 +
    //   q_pin1)) - q'*sin(q_ground2)*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   q'*cos(q_ground2)*cos(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   sin(q_ground2)*(q'*sin(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   q'*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   sin(q_ground1 + q_pin2)*(q'*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   q'*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*cos(q_pin1)*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))) +
    //   cos(q_ground2)*(q'*cos(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   q'*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   cos(q_ground1 + q_pin2)*(q'*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   q'*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*cos(q_pin1)*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) + 3*m*l*(g*sin(q + q_pin1)
    //   - (g*cos(q + q_pin1)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1))) + sin(q_pin1)*(l*(q'^2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q)
    //   + cos(q + q_pin1))) + sin(q_pin2)*(q_pin2'^2 +
    //   q_ground1'*(q_ground1'*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   2*q_pin2'))) - g*(3*cos(q_ground1) + cos(q_ground2)*sin(q_pin2)/sin(q_ground1 - q_ground2 + q_pin2)
    //   + cos(q_ground1 + q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2)))))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + l*q_pin1'*cos(q_pin1)*(2*q'
    //   + q_pin1') + (g*sin(q + q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1))) + g*cos(q + q_pin1)*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q +
    //   q_pin1)) + l*q'^2*sin(q_pin1)*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1)) +
    //   cos(q_pin1)*(l*(q'^2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1))) + sin(q_pin2)*(q_pin2'^2 + q_ground1'*(q_ground1'*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + 2*q_pin2'))) - g*(3*cos(q_ground1) +
    //   cos(q_ground2)*sin(q_pin2)/sin(q_ground1 - q_ground2 + q_pin2) + cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q - q_ground1 +
    //   q_pin1)))/(6*d1) +
    //   d1_by_q_pin1*(2*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q)
    //   + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) - m*l^2*(2*cos(q)*sin(q_ground1) -
    //   2*sin(q)*cos(q_ground1) + 3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(q'*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   q'*(cos(q_ground1)*(q'*cos(q) + cos(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1))
    //   - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))) -
    //   q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*q'^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + m*l^2*sin(q_pin1)*(2 + 3*cos(q_pin2) +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) -
    //   3*m*l*(l*q_pin1'*sin(q_pin1)*(2*q' + q_pin1') - g*(3*cos(q) + cos(q + q_pin1)) + (g*cos(q +
    //   q_pin1)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))) +
    //   sin(q_pin1)*(l*(q'^2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1))) + sin(q_pin2)*(q_pin2'^2 + q_ground1'*(q_ground1'*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + 2*q_pin2'))) - g*(3*cos(q_ground1) +
    //   cos(q_ground2)*sin(q_pin2)/sin(q_ground1 - q_ground2 + q_pin2) + cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q - q_ground1 +
    //   q_pin1)))/(6*d1^2)
    let u_dot_by_q_pin1 = d1_inv_by_6
        * (u_dot_by_q_of_q_dot_2_26
            - sin_angle_inv * cos_q_pin1_l_m_l
                * u_dot_of_place_30
                    .mul_add(
                        u_dot_by_q_of_q_dot_2_24,
                        u_dot_of_q_dot_2_10 * u_dot_of_q_dot_2_10 * u_dot_of_place_25
                            * sin_q_pin2_doubled,
                    )
            + m_l_times_3
                * (g_sin_q_plus_q_pin1 + l * u_dot_of_motion_4 * cos_q_pin1 - u_dot_by_q_of_motion
                    + sin_angle_inv
                        * (u_dot_of_motion_2.mul_add(cos_q_pin1, u_dot_by_q_of_place_3)
                            + u_dot_by_q_of_q_dot_2_16 * q_ground1_ddot_by_q_of_place_4))
            + u_dot_of_place_33 * q_dot_2_sin_angle_inv_sq
                * (u_dot_by_q_of_place_11 - u_dot_of_place_28 * cos_q_pin1 * cos_angle
                    + sin_q_pin1_cos_angle
                        * (u_dot_by_q_of_place_10
                            - sin_angle_inv * (cos_q_pin1 + q_ground1_ddot_by_q_of_place_4))
                    + d1_by_q_pin1_of_place)
            + l_m_l * u_dot_by_q_of_q_dot_2_23 * d1_by_q_pin1_of_place_2
            - u_dot_by_q_of_q_dot_2_25 * d1_by_q_pin1_of_place_4
            + u_dot_of_place_39
                * (u_dot_by_q_of_q_dot_2_18
                    + u_dot_by_q_of_q_dot_2_19 * q_ground1_ddot_by_q_of_place_4
                    + q_dot_2_sin_angle_inv
                        * (cos_q_ground1
                            * cos_q_plus_q_pin1
                                .mul_add(u_dot_by_q_pin1_of_q_dot_2_4, u_dot_of_q_dot_2_24)
                            - d1_of_place_5 * u_dot_of_q_dot_2
                            - u_dot_of_place_37 * q_ground1_ddot_by_q_of_q_dot_2
                            - sin_q_ground1
                                * (-sin_q_plus_q_pin1)
                                    .mul_add(u_dot_by_q_pin1_of_q_dot_2_4, u_dot_of_q_dot_2_26))
                    - u_dot_of_q_dot_2_30 * u_dot_by_q_pin1_of_q_dot_2_5)
            + u_dot_of_place_11
                * (-u_dot_of_q_dot_2_2 * (u_dot_of_q_dot_2_13 - u_dot_of_q_dot_2_12)
                    + minus_d1_of_place_30 * u_dot_by_q_of_q_dot_2_12
                    - u_dot_by_q_of_q_dot_2_13 * u_dot_by_q_pin1_of_q_dot_2
                    - u_dot_of_q_dot_2_21
                        * (u_dot_by_q_pin1_of_q_dot_2_2 - u_dot_by_q_pin1_of_q_dot_2_3)
                    - q_dot_2_d1_of_place_11
                        * (sin_q_ground2
                            * d1_of_place_16
                                .mul_add(
                                    u_dot_by_q_pin1_of_q_dot_2_2,
                                    q_ground1_ddot_by_q_of_q_dot_2 * sin_q_ground1,
                                )
                            + cos_q_ground2
                                * d1_of_place_13
                                    .mul_add(
                                        u_dot_by_q_pin1_of_q_dot_2_2,
                                        q_ground1_ddot_by_q_of_q_dot_2 * cos_q_ground1,
                                    ) - u_dot_of_place_2 * u_dot_by_q_pin1_of_q_dot_2_3)
                    + u_dot_by_q_of_q_dot_2_2 * u_dot_by_q_pin1_of_q_dot_2_5
                    + u_dot_of_q_dot_2_11 * q_ground1_ddot_by_q_of_place_4
                        * u_dot_by_q_pin1_of_place
                    + u_dot_by_q_of_q_dot_2_19 * u_dot_by_q_pin1_of_place_2)
            + u_dot_by_q_of_q_dot_2_22
                * (d1_by_q_pin1_of_place * sin_q_pin2 - u_dot_of_place_24 * cos_q_pin1
                    - sin_q_pin1
                        * (-sin_q_pin2
                            * (u_dot_by_q_of_place_7 - u_dot_of_place_17 * cos_q_pin1
                                - cos_angle
                                    * sin_angle_inv
                                        .mul_add(
                                            q_ground1_ddot_by_q_of_place_4,
                                            u_dot_by_q_pin1_of_place_3,
                                        )) + u_dot_by_q_pin1_of_place_2 * cos_q_pin2)))
        - d1_by_q_pin1 * u_dot_d1_inv;
    // u_dot_of_q_dot_2_14*cos(q_pin1) - q_ground1_ddot_by_q_of_q_dot_2*q_ground1_ddot_by_q_of_place_4
    let q_ground1_ddot_by_q_pin1_of_q_dot_2 = (-q_ground1_ddot_by_q_of_q_dot_2)
        .mul_add(q_ground1_ddot_by_q_of_place_4, u_dot_of_q_dot_2_14 * cos_q_pin1);
    // q_ground1_ddot_by_q_pin1 = (q'^2*(sin(q_pin1) - (sin(q_pin1)^2 + cos(q_pin1)*(sin(q_ground1)*sin(q +
    //   q_pin1) + cos(q_ground1)*cos(q + q_pin1)) + cos(q - q_ground1 + q_pin1)*(cos(q_pin1) +
    //   (3*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1))) - sin(q_pin1)*(sin(q_ground1)*sin(q + q_pin1) + 2*cos(q_pin1) + cos(q_ground1)*cos(q +
    //   q_pin1) + cos(q - q_ground1 + q_pin1)*(2 - 3*(sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/sin(q -
    //   q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1)) + u'*cos(q_pin1) + sin(q_pin1)*(u_dot_by_q_pin1 -
    //   u'/tan(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1)
    let q_ground1_ddot_by_q_pin1 = u_dot_by_q_of_q_dot_2
        .mul_add(
            q_ground1_ddot_by_q_of_q_dot_2_3,
            u_dot_by_q_pin1 * sin_q_pin1_sin_angle_inv,
        ) + S::int(3) * q_ground1_ddot_by_q_of_q_dot_2 * q_ground1_ddot_by_q_of_q_dot_2_4
        + q_ground1_ddot_by_q_of_q_dot_2_5 - u_dot * d1_by_q_pin1_of_place_2
        - q_dot_2_sin_angle_inv * q_ground1_ddot_by_q_pin1_of_q_dot_2;
    // q_ground2_ddot_by_q_pin1 = (q'^2*(sin(q_pin1)*sin(q_pin2) -
    //   (cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1) + cos(q -
    //   q_ground1 + q_pin1)*(1 + 3*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))) + sin(q_pin1)*(sin(q_pin2)*(sin(q_pin1) +
    //   2*cos(q_pin1)*((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) -
    //   1)/tan(q_ground2 - q_ground1 - q_pin2) + (sin(q_ground1)*sin(q + q_pin1) + 2*cos(q_pin1) +
    //   cos(q_ground1)*cos(q + q_pin1) + cos(q - q_ground1 + q_pin1)*(2 + 3*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)) -
    //   sin(q_pin1)*(3/tan(q - q_ground1 + q_pin1) + 2*((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 + q_pin2)))/tan(q_ground1 - q - q_pin1)) +
    //   2*cos(q_pin2)*(cos(q_pin1)*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))) +
    //   sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/tan(q - q_ground1 +
    //   q_pin1))/sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1)) +
    //   sin(q_pin2)*(u'*cos(q_pin1) - sin(q_pin1)*(u'/tan(q - q_ground1 + q_pin1) -
    //   u_dot_by_q_pin1)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_ground2_ddot_by_q_pin1 = u_dot_by_q_pin1 * q_ground2_ddot_by_q_of_place
        + q_dot_2_sin_angle_inv * q_ground2_ddot_by_q_of_q_dot_2_6 * cos_q_pin1
        - q_ground2_ddot_by_q_of_q_dot_2_9
        + q_ground1_ddot_by_q_of_q_dot_2 * q_ground2_ddot_by_q_ground2_of_q_dot_2_2
        + u_dot_by_q_pin1_of_q_dot_2
            * q_ground1_ddot_by_q_of_q_dot_2_4
                .mul_add(sin_q_pin2_times_3, -q_ground2_ddot_by_q_of_q_dot_2_3)
        - sin_q_pin2
            * u_dot_of_q_dot_2_10
                .mul_add(
                    q_ground1_ddot_by_q_pin1_of_q_dot_2,
                    u_dot * d1_by_q_pin1_of_place_5,
                );
    // u_dot_by_q_pin1 + q_dot_2_sq
    let q_pin1_ddot_by_q_pin1_of_q_dot_2 = u_dot_by_q_pin1 + q_dot_2_sq;
    // q_pin1_ddot_by_q_pin1 = -((q'^2*(cos(q - q_ground1 + q_pin1)*((sin(q_ground1)*(2*sin(q)*sin(q_pin1)
    //   - cos(q)*cos(q_pin1) + cos(q - q_ground1 + q_pin1)*(3*(cos(q)*(sin(q_pin1) +
    //   2*cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + 2*cos(q + q_pin1))) + cos(q +
    //   q_pin1)*(sin(q_pin1) - sin(q_ground1)*cos(q + q_pin1) + 2*cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1))))/sin(q - q_ground1 + q_pin1) - 2*cos(q) - 2*cos(q + q_pin1)) + sin(q +
    //   q_pin1)*(3*sin(q_pin1) + 4*cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - 4*sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1))) - cos(q + q_pin1)*(cos(q_pin1) + 4*cos(q_ground1)*(cos(q) + cos(q + q_pin1)))) +
    //   cos(q_ground1)*(2*cos(q)*sin(q_pin1) + cos(q_pin1)*(sin(q) + sin(q + q_pin1)) + cos(q +
    //   q_pin1)*(3*sin(q_pin1) + 4*cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + cos(q - q_ground1 +
    //   q_pin1)*(2*sin(q) + 2*sin(q + q_pin1) - 3*(sin(q)*(sin(q_pin1) + cos(q_ground1)*(sin(q) + 2*sin(q +
    //   q_pin1))) + sin(q + q_pin1)*(sin(q_pin1) + cos(q_ground1)*sin(q + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))))/sin(q - q_ground1 + q_pin1) - cos(q_ground1)*(cos(q) + 2*cos(q + q_pin1)) -
    //   sin(q_ground1)*(sin(q) + 2*sin(q + q_pin1))) + sin(q_ground1)*(cos(q)*(sin(q_pin1) -
    //   sin(q_ground1)*(cos(q) + cos(q + q_pin1)) + cos(q_ground1)*(2*sin(q) + sin(q + q_pin1))) - sin(q +
    //   q_pin1)*(sin(q_ground1)*sin(q + q_pin1) + cos(q_pin1) + 2*cos(q_ground1)*cos(q + q_pin1)) +
    //   sin(q)*(cos(q_ground1)*cos(q + q_pin1) - cos(q_pin1))) - cos(q_ground1)*(cos(q_ground1)*cos(q +
    //   q_pin1)^2 + cos(q_pin1)*(cos(q) + cos(q + q_pin1)) + sin(q)*(sin(q_pin1) + cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))))) + u'*cos(q - q_ground1 + q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))))/sin(q - q_ground1 + q_pin1) + sin(q_ground1)*(u'*sin(q +
    //   q_pin1) - u_dot_by_q_pin1*cos(q + q_pin1) - cos(q)*(q'^2 + u_dot_by_q_pin1)) +
    //   cos(q_ground1)*(u'*cos(q + q_pin1) + u_dot_by_q_pin1*sin(q + q_pin1) + sin(q)*(q'^2 +
    //   u_dot_by_q_pin1)))/sin(q - q_ground1 + q_pin1)
    let q_pin1_ddot_by_q_pin1 = -sin_angle_inv
        * (sin_angle_inv
            * (q_pin1_ddot_by_q_of_u_dot_3
                - q_dot_2_sq
                    * (cos_q_ground1
                        * (sin_q * (sin_q_pin1 + u_dot_of_place_3)
                            + u_dot_of_q_2_q_pin1_2 * cos_q_pin1
                            + cos_q_plus_q_pin1 * q_ground1_ddot_by_q_of_place_2)
                        + sin_q_ground1
                            * (sin_q_plus_q_pin1
                                * (q_ground1_ddot_by_q_of_place_2
                                    .mul_add(S::int(2), cos_q_pin1)
                                    + q_ground1_ddot_by_q_of_place_3)
                                - cos_q
                                    * (sin_q_pin1
                                        + cos_q_ground1
                                            * sin_q.mul_add(S::int(2), sin_q_plus_q_pin1)
                                        - u_dot_of_place_4)
                                - sin_q * (q_ground1_ddot_by_q_of_place_2 - cos_q_pin1))
                        + cos_angle
                            * (q_pin1_ddot_by_q_of_q_2_q_pin1_3 * sin_q_ground1
                                + q_pin1_ddot_by_q_of_q_2_q_pin1_4 * cos_q_ground1
                                + sin_angle_inv
                                    * (sin_q_ground1
                                        * (cos_q_pin1_cos_q
                                            + cos_q_plus_q_pin1
                                                * u_dot_of_place_35.mul_add(S::int(4), cos_q_pin1)
                                            - sin_q_plus_q_pin1
                                                * u_dot_of_place_5.mul_add(S::int(4), sin_q_pin1_times_3)
                                            + q_pin1_ddot_by_q_of_place_2 - sin_q_pin1_doubled * sin_q)
                                        - cos_q_ground1
                                            * (cos_q_plus_q_pin1
                                                * u_dot_of_place_3.mul_add(S::int(4), sin_q_pin1_times_3)
                                                + u_dot_of_q_2_q_pin1 * cos_q_pin1
                                                + cos_angle
                                                    * (-sin_angle_inv_times_3
                                                        * (sin_q_plus_q_pin1 * (sin_q_pin1 + d1_of_place_3)
                                                            + sin_q
                                                                * q_pin1_ddot_by_q_of_q_2_q_pin1_3
                                                                    .mul_add(cos_q_ground1, sin_q_pin1))
                                                        + S::int(2) * u_dot_of_q_2_q_pin1)
                                                + sin_q_pin1_doubled * cos_q)))))
            + cos_q_ground1
                * (u_dot.mul_add(cos_q_plus_q_pin1, u_dot_by_q_pin1 * sin_q_plus_q_pin1)
                    + q_pin1_ddot_by_q_pin1_of_q_dot_2 * sin_q)
            + sin_q_ground1
                * ((-u_dot_by_q_pin1)
                    .mul_add(cos_q_plus_q_pin1, u_dot * sin_q_plus_q_pin1)
                    - q_pin1_ddot_by_q_pin1_of_q_dot_2 * cos_q));
    // q_pin2_ddot_by_q_of_place_18*sin(q_ground1) + sin(q_ground1 + q_pin2)*q_pin2_ddot_by_q_of_place_22
    let q_pin2_ddot_by_q_pin1_of_place = d1_of_place_16
        .mul_add(
            q_pin2_ddot_by_q_of_place_22,
            q_pin2_ddot_by_q_of_place_18 * sin_q_ground1,
        );
    // sin(q_pin2) + d1_of_place_18
    let q_pin2_ddot_by_q_pin1_of_place_2 = sin_q_pin2 + d1_of_place_18;
    // sin_angle_2_inv*(q_pin2_ddot_by_q_of_place_16*sin(q_ground2) +
    //   cos(q_ground2)*(sin_q_pin2_cos_q_ground1 + cos(q_ground1 - q_ground2 + q_pin2)*(d1_of_place_17 -
    //   sin_angle_2_inv*q_pin2_ddot_by_q_pin1_of_place) + cos(q_ground1 +
    //   q_pin2)*q_pin2_ddot_by_q_pin1_of_place_2)) - u_dot_of_place_2
    let q_pin2_ddot_by_q_pin1_of_place_3 = sin_angle_2_inv
        * (cos_q_ground2
            * (sin_q_pin2_cos_q_ground1
                + cos_angle_2
                    * (-sin_angle_2_inv)
                        .mul_add(q_pin2_ddot_by_q_pin1_of_place, d1_of_place_17)
                + d1_of_place_13 * q_pin2_ddot_by_q_pin1_of_place_2)
            + q_pin2_ddot_by_q_of_place_16 * sin_q_ground2) - u_dot_of_place_2;
    // q_pin2_ddot_by_q_pin1 = (q'^2*(sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))) -
    //   (sin(q_pin1)*(sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))) + (sin(q_ground2)*(cos(q_ground1 +
    //   q_pin2)*(2*cos(q_pin1) + 2*cos(q - q_ground1 + q_pin1) + sin(q_ground1)*(sin(q + q_pin1) + 3*(cos(q)
    //   + cos(q + q_pin1))/tan(q - q_ground1 + q_pin1))) + sin(q_pin1)*(2*sin(q_ground1) + 2*sin(q_ground1 +
    //   q_pin2) + 3*(cos(q_ground1) + cos(q_ground1 + q_pin2))/tan(q_ground1 - q - q_pin1) +
    //   2*(cos(q_ground2)*cos(q_ground1 + q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   sin(q_ground1)*sin(q_pin2) - sin(q_ground1 + q_pin2)*(sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))) -
    //   cos(q_ground1 - q_ground2 + q_pin2)*((cos(q_ground1)*(sin(q_pin2) + 2*cos(q_ground2)*(sin(q_ground1)
    //   + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) +
    //   cos(q_ground1 + q_pin2)*(sin(q_pin2) - sin(q_ground2)*cos(q_ground1 + q_pin2) +
    //   2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2) -
    //   cos(q_ground1) - cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) +
    //   cos(q_ground1)*(sin(q_ground1)*sin(q + q_pin1) + 2*cos(q_pin1) + cos(q + q_pin1)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) + cos(q - q_ground1 + q_pin1)*(2 + 3*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - sin(q)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - sin(q + q_pin1)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q - q_ground1 + q_pin1)))) +
    //   cos(q_ground2)*(2*sin(q_pin1)*(cos(q_ground1) + cos(q_ground1 + q_pin2) -
    //   sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2)) -
    //   sin(q_ground1)*(2*cos(q_pin1) + cos(q_ground1)*cos(q + q_pin1) + sin(q + q_pin1)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + cos(q - q_ground1 + q_pin1)*(2 - 3*(sin(q_pin1) + cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)) - cos(q)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - cos(q +
    //   q_pin1)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q - q_ground1 + q_pin1)) +
    //   2*sin(q_pin1)*(cos(q_ground2)*cos(q_ground1 + q_pin2) + cos(q_ground1 - q_ground2 + q_pin2)*(1 -
    //   (sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2)))/sin(q_ground1 -
    //   q_ground2 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) - sin(q_ground1 + q_pin2)*(2*cos(q_pin1)
    //   + 2*cos(q - q_ground1 + q_pin1) + cos(q_ground1)*(cos(q + q_pin1) + 3*(sin(q) + sin(q +
    //   q_pin1))/tan(q_ground1 - q - q_pin1)) + sin(q_pin1)*(2*(cos(q_ground2)*cos(q_ground1 + q_pin2) +
    //   cos(q_ground1 - q_ground2 + q_pin2)*(1 - (sin(q_pin2) + cos(q_ground2)*sin(q_ground1 +
    //   q_pin2))/sin(q_ground1 - q_ground2 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 3/tan(q -
    //   q_ground1 + q_pin1)))))/tan(q_ground1 - q - q_pin1) + 2*cos(q_pin1)*(sin(q_ground2)*(sin(q_ground1)
    //   + sin(q_ground1 + q_pin2)) - (sin(q_ground2)*(sin(q_ground1)*sin(q_pin2) -
    //   cos(q_ground2)*cos(q_ground1 + q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + sin(q_ground1 +
    //   q_pin2)*(sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))) + cos(q_ground1 - q_ground2 +
    //   q_pin2)*((cos(q_ground1)*(sin(q_pin2) + 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))
    //   - sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(sin(q_pin2) - sin(q_ground2)*cos(q_ground1 + q_pin2) + 2*cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2) - cos(q_ground1) - cos(q_ground1 +
    //   q_pin2))) + cos(q_ground2)*(cos(q_ground1)*sin(q_pin2) + cos(q_ground1 + q_pin2)*(sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))) + cos(q_ground1 - q_ground2 +
    //   q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2) - (sin(q_ground1)*(sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2))) + sin(q_ground1 + q_pin2)*(sin(q_pin2)
    //   + cos(q_ground2)*sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))))/sin(q_ground1 -
    //   q_ground2 + q_pin2) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))) +
    //   cos(q_pin1)*(cos(q - q_ground1 + q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))
    //   - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*(sin(q_ground1)*(cos(q_ground2)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) -
    //   cos(q)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - cos(q + q_pin1)*(sin(q_ground1) + sin(q_ground1
    //   + q_pin2))) + sin(q_ground2)*(cos(q)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + cos(q +
    //   q_pin1)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))) + cos(q_ground1)*(cos(q_ground2)*sin(q_ground1
    //   + q_pin2)*(sin(q) + sin(q + q_pin1)) - sin(q_ground2)*(sin(q)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) + sin(q + q_pin1)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))))/sin(q - q_ground1 +
    //   q_pin1)) + sin(q_ground1)*(sin(q + q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))) -
    //   cos(q_ground1)*cos(q_ground2)*cos(q + q_pin1)) + cos(q_ground1)*cos(q +
    //   q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*sin(q_ground1 +
    //   q_pin2))))/sin(q - q_ground1 + q_pin1)) + u'*cos(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))) -
    //   sin(q_pin1)*(u'*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/tan(q - q_ground1 + q_pin1) +
    //   u_dot_by_q_pin1*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_ddot_by_q_pin1 = q_pin2_ddot_by_q_of_place_28
        * (sin_q_pin1
            * (-u_dot)
                .mul_add(
                    q_pin2_ddot_by_q_ground1_of_place_2,
                    u_dot_by_q_pin1 * minus_d1_of_place_30,
                ) + u_dot * u_dot_by_q_pin1_of_place
            + q_dot_2_sq
                * (q_pin2_ddot_by_q_of_place_27
                    + sin_angle_inv
                        * (cos_q_pin1
                            * (sin_q_ground1
                                * (-sin_q_plus_q_pin1)
                                    .mul_add(
                                        minus_d1_of_place_30,
                                        q_ground1_ddot_by_q_of_place_2 * cos_q_ground2,
                                    )
                                + q_ground1_ddot_by_q_of_place_2
                                    * (q_pin2_ddot_by_q_of_place_7 - d1_of_place_29)
                                + cos_angle
                                    * (-sin_angle_inv_times_3)
                                        .mul_add(
                                            q_pin2_ddot_by_q_ground2_of_place_6, d1_of_place_30,
                                        ))
                            - sin_q_pin1
                                * (q_pin2_ddot_by_q_of_place_27
                                    - cos_angle_sin_angle_inv
                                        * (sin_q_ground2
                                            * (cos_q_ground1
                                                * (cos_q_plus_q_pin1
                                                    .mul_add(d1_of_place_19, q_ground1_ddot_by_q_of_place_3)
                                                    + cos_q_pin1_doubled + q_pin2_ddot_by_q_of_place_11)
                                                + d1_of_place_13
                                                    * (cos_q_pin1_doubled + cos_angle_doubled
                                                        + sin_q_ground1
                                                            * (sin_q_plus_q_pin1 + q_pin2_ddot_by_q_of_place_12))
                                                + q_pin2_ddot_by_q_of_place_17)
                                            + cos_q_ground2
                                                * (sin_q_ground1
                                                    * ((-sin_q_plus_q_pin1)
                                                        .mul_add(d1_of_place_17, q_pin2_ddot_by_q_of_place_19)
                                                        - q_ground1_ddot_by_q_of_place_2 - cos_q_pin1_doubled)
                                                    + d1_of_place_16
                                                        * (q_pin2_ddot_by_q_of_place_23 - cos_q_pin1_doubled
                                                            - cos_q_ground1
                                                                * (cos_q_plus_q_pin1 - q_pin2_ddot_by_q_of_place_21))
                                                    + q_pin2_ddot_by_q_of_place_24))
                                    - cos_q_pin1_doubled * q_pin2_ddot_by_q_pin1_of_place_3))));
    // d1_by_q_pin2 = -m*l^2*sin(q_pin1)^2*(3*sin(q_pin2) + (2*sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   2*cos(q_ground2)*cos(q_ground1 + q_pin2) + 3*sin(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))) +
    //   3*cos(q_pin2)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 + q_pin2)) +
    //   (cos(q_ground1 - q_ground2 + q_pin2)*(2*sin(q_pin2)^2/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_ground2)*(2*cos(q_ground1) + 2*cos(q_ground1 + q_pin2) + 3*cos(q_pin2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - 2*(cos(q_ground1)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) - sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*cos(q_ground1
    //   + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) - cos(q_ground2)*(sin(q_ground1)*(2 + 3*cos(q_pin2)
    //   - 2*cos(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2))
    //   + sin(q_ground1 + q_pin2)*(2 - 2*cos(q_ground2)*sin(q_ground1 + q_pin2)/sin(q_ground1 - q_ground2 +
    //   q_pin2) + 3*cos(q_pin2)))) - 2*sin(q_pin2)*cos(q_pin2) - 2*cos(q_ground2)^2*cos(q_ground1 +
    //   q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) + 2*sin(q_ground2)*(sin(q_ground2)*sin(q_ground1
    //   + q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1 +
    //   q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - cos(q_ground1 + q_pin2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(3*sin(q - q_ground1 + q_pin1)^2)
    let d1_by_q_pin2 = sin_q_pin2
        * d1_of_place_30.mul_add(d1_by_q_ground1_of_place_4, -d1_of_place_9)
        - d1_by_q_of_place_8 * q_ground2_ddot_by_q_of_place_3 + d1_by_q_ground2_of_place_2
        + u_dot_by_q_ground2_of_place_2
            * d1_of_place_30.mul_add(d1_by_q_of_place_7, -d1_of_place_33);
    let u_dot_by_q_pin2_of_q_dot_2 = q_dot_2_d1_of_place_11 * u_dot_by_q_ground2_of_place_2;
    // u_dot_of_q_dot_2_21 + u_dot_by_q_pin2_of_q_dot_2
    let u_dot_by_q_pin2_of_q_dot_2_2 = u_dot_of_q_dot_2_21 + u_dot_by_q_pin2_of_q_dot_2;
    // u_dot_by_q_of_place_2 + u_dot_by_q_ground2_of_place_2
    let u_dot_by_q_pin2_of_place = u_dot_by_q_of_place_2 + u_dot_by_q_ground2_of_place_2;
    // u_dot_by_q_pin2 =
    //   (4*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   2*m*l^2*q'^2*sin(q_pin1)*cos(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) +
    //   m*l^2*q'^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))*(6*sin(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (2*sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   2*cos(q_ground2)*cos(q_ground1 + q_pin2) + 3*sin(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))) +
    //   3*cos(q_pin2)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^3 +
    //   2*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*cos(q_pin2)*(cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*sin(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + cos(q_pin2)*(cos(q - q_ground1 + q_pin1)*(1 +
    //   (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1)) - sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2))) + sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin1)*sin(q_pin2)*((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1 +
    //   ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) -
    //   1)/tan(q_ground1 - q_ground2 + q_pin2)^2 + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) - (sin(q_ground2)*sin(q_ground1 + q_pin2)
    //   + cos(q_pin2) + cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/tan(q_ground1 - q_ground2 + q_pin2))))/(sin(q - q_ground1 + q_pin1)^3*sin(q_ground1 -
    //   q_ground2 + q_pin2)^2) + m*l^2*sin(q_pin1)*(3*sin(q_pin2) + 2*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + 2*(sin(q_ground2)*sin(q_ground1 +
    //   q_pin2) + cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) + m*l^2*sin(q_pin1)*(2 +
    //   3*cos(q_pin2) + 2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(q'^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   q'^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q - q_pin1)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 + q_pin2))*(q'
    //   - q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   q'*sin(q_pin1)*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)) + 2*q'*sin(q_pin1)*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)^2) + q'*sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 +
    //   q_pin2) + cos(q_ground2)*cos(q_ground1 + q_pin2))*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)*sin(q_pin2)/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   q'*sin(q_pin1)*cos(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   q'*sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*sin(q_ground1 + q_pin2)/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*cos(q_ground1 + q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   q'*sin(q_ground2)*sin(q_pin1)*cos(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   q'*cos(q_ground2)*sin(q_pin1)*cos(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(cos(q_ground1 + q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))) - sin(q_ground1 +
    //   q_pin2)*(q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   cos(q_ground2)*(sin(q_ground1 + q_pin2)*(q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*sin(q_pin1)*(g*(cos(q_ground2)*sin(q_pin2)/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1
    //   - q_ground2 + q_pin2)) - cos(q_ground2)*cos(q_pin2)/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_ground1 + q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) +
    //   cos(q_ground1 + q_pin2)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2))) +
    //   l*(q_ground1'*sin(q_pin2)*(q_ground1'*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + q_ground1'*(sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2)) +
    //   cos(q_pin2)*(q_pin2'^2 + q_ground1'*(q_ground1'*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2) + 2*q_pin2'))))/sin(q - q_ground1 + q_pin1))/(6*d1) +
    //   d1_by_q_pin2*(2*m*l^2*q'^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q)
    //   + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) - m*l^2*(2*cos(q)*sin(q_ground1) -
    //   2*sin(q)*cos(q_ground1) + 3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(q'*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   q'*(cos(q_ground1)*(q'*cos(q) + cos(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1))
    //   - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))) -
    //   q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*q'^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + m*l^2*sin(q_pin1)*(2 + 3*cos(q_pin2) +
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) -
    //   3*m*l*(l*q_pin1'*sin(q_pin1)*(2*q' + q_pin1') - g*(3*cos(q) + cos(q + q_pin1)) + (g*cos(q +
    //   q_pin1)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))) +
    //   sin(q_pin1)*(l*(q'^2*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1))) + sin(q_pin2)*(q_pin2'^2 + q_ground1'*(q_ground1'*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + 2*q_pin2'))) - g*(3*cos(q_ground1) +
    //   cos(q_ground2)*sin(q_pin2)/sin(q_ground1 - q_ground2 + q_pin2) + cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q - q_ground1 +
    //   q_pin1)))/(6*d1^2)
    let u_dot_by_q_pin2 = d1_inv_by_6
        * (q_dot_2_sin_angle_inv_sq * u_dot_by_q_ground1_of_place_5
            * (d1_by_q_ground1_of_place_6 + S::int(6) * sin_q_pin2
                + sin_angle_2_inv
                    * d1_of_q_pin2
                        .mul_add(
                            u_dot_by_q_ground2_of_place_2,
                            minus_d1_of_place_30 * sin_q_pin2_times_3,
                        ))
            - S::int(2) * u_dot_of_q_dot_2_11 * u_dot_by_q_ground1_of_place_4
                * (-q_ground2_ddot_by_q_of_place_2).mul_add(S::int(2), cos_q_pin2)
            + u_dot_by_q_ground1_of_q_dot_2_13
                * sin_angle_2_inv_doubled
                    .mul_add(u_dot_by_q_pin2_of_place, sin_q_pin2_times_3)
            + u_dot_by_q_ground2_of_place_3
                * (l
                    * (u_dot_by_q_ground1_of_motion * q_ground1_dot_sin_q_pin2)
                        .mul_add(u_dot_by_q_pin2_of_place, u_dot_of_motion * cos_q_pin2)
                    + g
                        * (q_ground2_ddot_by_q_of_place_3
                            .mul_add(
                                u_dot_by_q_ground1_of_place, u_dot_by_q_ground1_of_place_3,
                            )
                            + d1_of_place_13 * sin_angle_2_inv * u_dot_by_q_pin2_of_place))
            - u_dot_of_place_11
                * (u_dot_by_q_ground1_of_q_dot_2
                    + u_dot_by_q_ground1_of_q_dot_2_2 * u_dot_by_q_ground2_of_place_2
                    + q_dot_2_d1_of_place_11
                        * (u_dot_of_q_dot_2_8 * q_pin2_ddot_by_q_of_place_10
                            - u_dot_of_place_2 * q_ground2_ddot_by_q_of_q_dot_2_2
                            - sin_q_ground2
                                * (-d1_of_place_16)
                                    .mul_add(u_dot_by_q_pin2_of_q_dot_2_2, u_dot_of_q_dot_2_6)
                            + cos_q_ground2
                                * d1_of_place_13
                                    .mul_add(u_dot_by_q_pin2_of_q_dot_2_2, u_dot_of_q_dot_2_4))
                    + u_dot_of_q_dot_2_21
                        * (u_dot_by_q_pin2_of_q_dot_2_2 - q_ground2_ddot_by_q_of_q_dot_2_2)
                    - u_dot_of_q_dot_2_17 * u_dot_by_q_pin2_of_place)
            - u_dot_by_q_of_q_dot_2_22
                * (sin_q_pin1
                    * (u_dot_of_place_21 * cos_q_pin2
                        - minus_d1_of_place_30 * u_dot_of_place_22 * sin_q_pin2
                        + sin_q_pin1_sin_q_pin2
                            * (S::int(1) - u_dot_by_q_ground1_of_place_7
                                - u_dot_of_place_8
                                    * (u_dot_by_q_ground1_of_place_6
                                        - sin_angle_2_inv
                                            * (cos_q_pin2 + u_dot_by_q_ground2_of_place_2)))
                        - u_dot_of_place_23 * u_dot_by_q_pin2_of_place)
                    + u_dot_of_place_6 * cos_q_pin2)) - d1_by_q_pin2 * u_dot_d1_inv;
    // q_ground1_ddot_by_q_pin2 = u_dot_by_q_pin2*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    let q_ground1_ddot_by_q_pin2 = u_dot_by_q_pin2 * sin_q_pin1_sin_angle_inv;
    // u_dot_of_q_dot_2_14 + u_dot_by_q_pin2_of_q_dot_2
    let q_ground2_ddot_by_q_pin2_of_q_dot_2 = u_dot_of_q_dot_2_14 + u_dot_by_q_pin2_of_q_dot_2;
    // u_dot_by_q_of_q_dot_2 + q_ground2_ddot_by_q_ground2_of_q_dot_2_2
    let q_ground2_ddot_by_q_pin2_of_q_dot_2_2 = u_dot_by_q_of_q_dot_2
        + q_ground2_ddot_by_q_ground2_of_q_dot_2_2;
    // q_ground2_ddot_by_q_pin2 = (q'^2*(sin(q_pin1)*(sin(q_pin1)*sin(q_pin2) + cos(q - q_ground1 +
    //   q_pin1)*cos(q_pin2)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) -
    //   sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1) - (cos(q_ground1 -
    //   q_ground2 + q_pin2)*(sin(q_pin1)*(sin(q_pin2)/tan(q - q_ground1 + q_pin1) + cos(q_pin2) +
    //   (3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))) -
    //   sin(q_pin2)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + 2*cos(q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2) + cos(q_ground1 - q_ground2 + q_pin2)*(2 - 3*(sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2)) - cos(q - q_ground1 +
    //   q_pin1)*sin(q_pin2)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))) + sin(q_pin1)*(sin(q_pin2)^2 +
    //   cos(q_pin2)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2)) + cos(q_pin1)*(cos(q_pin2)*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin2)*(sin(q_ground1)*(cos(q)
    //   + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/tan(q_ground2 - q_ground1 -
    //   q_pin2)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u'*cos(q_pin2) - sin(q_pin2)*(u'/tan(q_ground1
    //   - q_ground2 + q_pin2) - u_dot_by_q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2))
    let q_ground2_ddot_by_q_pin2 = q_ground2_ddot_by_q_ground2_of_q_dot_2_5
        + u_dot_by_q_pin2 * q_ground2_ddot_by_q_of_place
        + q_ground2_ddot_by_q_of_place_3
            * (q_ground2_ddot_by_q_ground2_of_q_dot_2_7 - u_dot_d1_of_place_11)
        + q_ground2_ddot_by_q_of_q_dot_2_2
            * (-q_ground2_ddot_by_q_ground2_of_q_dot_2_6)
                .mul_add(S::int(3), q_ground2_ddot_by_q_pin2_of_q_dot_2)
        + q_ground2_ddot_by_q_ground2_of_q_dot_2
            * (q_ground2_ddot_by_q_pin2_of_q_dot_2_2 - q_ground2_ddot_by_q_of_q_dot_2_4);
    // q_pin1_ddot_by_q_pin2 = u_dot_by_q_pin2*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)
    let q_pin1_ddot_by_q_pin2 = u_dot_by_q_pin2 * d1_of_place_7;
    let q_pin2_ddot_by_q_pin2_of_place = q_pin2_ddot_by_q_ground2_of_place_6 * cos_q_pin1;
    // q_pin2_ddot_by_q_pin2 = (q'^2*((sin(q_pin1)*(cos(q_ground1 - q_ground2 + q_pin2)*(cos(q - q_ground1
    //   + q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   (sin(q_ground1)*(cos(q_ground2)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - cos(q)*(sin(q_ground1)
    //   + sin(q_ground1 + q_pin2)) - cos(q + q_pin1)*(sin(q_ground1) + sin(q_ground1 + q_pin2))) +
    //   sin(q_ground2)*(cos(q)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + cos(q + q_pin1)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)))) + cos(q_ground1)*(cos(q_ground2)*sin(q_ground1 + q_pin2)*(sin(q) +
    //   sin(q + q_pin1)) - sin(q_ground2)*(sin(q)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + sin(q +
    //   q_pin1)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))))/sin(q - q_ground1 + q_pin1)) +
    //   sin(q_pin1)*(cos(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2)) -
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/tan(q - q_ground1 + q_pin1) + sin(q_ground2)*(sin(q_ground1) +
    //   2*sin(q_ground1 + q_pin2)) - (sin(q_ground2)*(2*sin(q_ground1)*sin(q_pin2) -
    //   cos(q_ground1)*cos(q_pin2) + cos(q_ground1 - q_ground2 + q_pin2)*(3*(cos(q_ground1)*(sin(q_pin2) +
    //   2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   2*cos(q_ground1 + q_pin2))) + cos(q_ground1 + q_pin2)*(sin(q_pin2) - sin(q_ground2)*cos(q_ground1 +
    //   q_pin2) + 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2) - 2*cos(q_ground1) - 2*cos(q_ground1 + q_pin2)) + sin(q_ground1 + q_pin2)*(3*sin(q_pin2) +
    //   4*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - 4*sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2))) - cos(q_ground1 + q_pin2)*(cos(q_pin2) + 4*cos(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)))) + cos(q_ground2)*(2*cos(q_ground1)*sin(q_pin2) +
    //   cos(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) + cos(q_ground1 + q_pin2)*(3*sin(q_pin2) +
    //   4*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))) + cos(q_ground1 - q_ground2 +
    //   q_pin2)*(2*sin(q_ground1) + 2*sin(q_ground1 + q_pin2) - 3*(sin(q_ground1)*(sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2))) + sin(q_ground1 + q_pin2)*(sin(q_pin2)
    //   + cos(q_ground2)*sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))))/sin(q_ground1 -
    //   q_ground2 + q_pin2))) + sin(q_pin1)*(cos(q_ground2)*(cos(q_ground2)*cos(q_ground1 + q_pin2)^2 +
    //   cos(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + sin(q_ground1)*(sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))) -
    //   sin(q_ground2)*(cos(q_ground1)*(sin(q_pin2) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(2*sin(q_ground1) + sin(q_ground1 + q_pin2))) - sin(q_ground1 +
    //   q_pin2)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_pin2) + 2*cos(q_ground2)*cos(q_ground1 +
    //   q_pin2)) + sin(q_ground1)*(cos(q_ground2)*cos(q_ground1 + q_pin2) - cos(q_pin2))))) -
    //   cos(q_pin1)*cos(q_ground1 - q_ground2 +
    //   q_pin2)*(sin(q_ground1)*(cos(q_ground2)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) -
    //   cos(q)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - cos(q + q_pin1)*(sin(q_ground1) + sin(q_ground1
    //   + q_pin2))) + sin(q_ground2)*(cos(q)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + cos(q +
    //   q_pin1)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))) + cos(q_ground1)*(cos(q_ground2)*sin(q_ground1
    //   + q_pin2)*(sin(q) + sin(q + q_pin1)) - sin(q_ground2)*(sin(q)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) + sin(q + q_pin1)*(cos(q_ground1) + cos(q_ground1 + q_pin2))))))/sin(q_ground1 - q_ground2
    //   + q_pin2) + sin(q_pin1)*(sin(q_pin1)*(cos(q_ground1)*sin(q_ground2) - sin(q_ground1)*cos(q_ground2))
    //   + cos(q - q_ground1 + q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1
    //   + q_pin2) - (sin(q_ground2)*sin(q_ground1 + q_pin2)*(sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2)*(sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1))))/sin(q - q_ground1 + q_pin1))) +
    //   cos(q_pin1)*(cos(q_ground1)*(sin(q)*(sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2)) + sin(q + q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))) - sin(q_ground1)*(cos(q)*(sin(q_ground2)*sin(q_ground1 +
    //   q_pin2) + cos(q_ground2)*cos(q_ground1 + q_pin2)) + cos(q + q_pin1)*(sin(q_ground2)*sin(q_ground1 +
    //   q_pin2) + cos(q_ground2)*cos(q_ground1 + q_pin2)))))/sin(q - q_ground1 + q_pin1) -
    //   sin(q_pin1)*(u'*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 + q_pin2) +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u_dot_by_q_pin2*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_ddot_by_q_pin2 = -q_pin2_ddot_by_q_of_place_28
        * (sin_q_pin1
            * (-u_dot_by_q_pin2)
                .mul_add(minus_d1_of_place_30, u_dot * u_dot_by_q_pin2_of_place)
            + q_pin2_ddot_by_q_ground2_of_q_dot_2
                * (sin_q_pin1
                    * (sin_q_pin1
                        * (-cos_q_ground1)
                            .mul_add(sin_q_ground2, sin_q_ground1 * cos_q_ground2)
                        + cos_angle
                            * (sin_angle_inv * u_dot_of_place_27)
                                .mul_add(
                                    u_dot_by_q_ground2_of_place_2, -u_dot_by_q_ground2_of_place_2,
                                ))
                    - cos_q_pin1
                        * (-(u_dot_of_q_2_q_pin1_2 * u_dot_by_q_ground2_of_place_2))
                            .mul_add(
                                sin_q_ground1,
                                u_dot_of_q_2_q_pin1 * u_dot_by_q_ground2_of_place_2 * cos_q_ground1,
                            )
                    - sin_angle_2_inv
                        * (sin_q_pin1
                            * (cos_angle_2
                                * (q_pin2_ddot_by_q_ground2_of_place_7
                                    + sin_q_pin1
                                        * (-q_pin2_ddot_by_q_ground1_of_place_2
                                            + d1_of_place_14 * cos_q_ground2
                                            + d1_of_place_20 * sin_q_ground2
                                            - sin_angle_2_inv
                                                * (cos_q_ground2
                                                    * (d1_of_place_17 * cos_q_pin2
                                                        + sin_q_pin2_doubled * cos_q_ground1
                                                        + d1_of_place_13
                                                            * d1_of_place_18.mul_add(S::int(4), sin_q_pin2_times_3)
                                                        + cos_angle_2
                                                            * (-sin_angle_2_inv_times_3)
                                                                .mul_add(
                                                                    q_pin2_ddot_by_q_pin1_of_place,
                                                                    d1_of_place_17_doubled,
                                                                ))
                                                    - sin_q_ground2
                                                        * (cos_q_pin2_cos_q_ground1
                                                            + d1_of_place_13
                                                                * u_dot_of_place.mul_add(S::int(4), cos_q_pin2)
                                                            - sin_q_pin2_doubled * sin_q_ground1
                                                            - d1_of_place_16
                                                                * d1_of_place_30.mul_add(S::int(4), sin_q_pin2_times_3)
                                                            + q_pin2_ddot_by_q_ground2_of_place_5))))
                                + sin_q_pin1
                                    * (cos_q_ground2
                                        * (d1_of_place_13
                                            .mul_add(
                                                q_pin2_ddot_by_q_of_place_15,
                                                d1_of_place_19 * cos_q_pin2,
                                            ) + q_pin2_ddot_by_q_pin1_of_place_2 * sin_q_ground1)
                                        - sin_q_ground2
                                            * (cos_q_ground1
                                                * (sin_q_pin2 - d1_of_place_29
                                                    + cos_q_ground2 * (d1_of_place_16 + sin_q_ground1_doubled))
                                                + sin_q_ground1
                                                    * (q_pin2_ddot_by_q_of_place_15 - cos_q_pin2)
                                                - d1_of_place_16
                                                    * (q_pin2_ddot_by_q_of_place_15
                                                        .mul_add(S::int(2), cos_q_pin2)
                                                        + u_dot_by_q_ground2_of_place))))
                            - q_pin2_ddot_by_q_pin2_of_place * cos_angle_2)));
    // sin_q_pin1_sin_angle_inv + q_pin2_ddot_by_q_ground1_of_place
    let u_dot_by_q_dot_of_place = sin_q_pin1_sin_angle_inv + q_pin2_ddot_by_q_ground1_of_place;
    // -u_dot_of_place_7 - u_dot_of_place_18
    let u_dot_by_q_dot_of_place_2 = -u_dot_of_place_7 - u_dot_of_place_18;
    let u_dot_by_q_dot_of_q_dot_2 = S::int(2) * q_dot_2_sin_angle_inv;
    // u_dot_by_q_dot = (m*l^2*(2*cos(q)*sin(q_ground1) - 2*sin(q)*cos(q_ground1) +
    //   3*cos(q_pin1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(q'*(cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))) - sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q +
    //   q_pin1))/sin(q - q_ground1 + q_pin1) - cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q + q_pin1))/sin(q -
    //   q_ground1 + q_pin1) + sin(q_ground1)*(sin(q) + sin(q + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/sin(q -
    //   q_ground1 + q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) - 1 + (cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   (cos(q_ground1)*(q'*cos(q) + cos(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))) -
    //   q'*sin(q_ground1)*sin(q_pin1)*(sin(q) + sin(q + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   q'*cos(q_ground1)*sin(q_pin1)*(cos(q) + cos(q + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_ground1)*(q'*sin(q) + sin(q + q_pin1)*(q' + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   4*m*l^2*q'*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) -
    //   2*m*l^2*q'*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))*(10 + 6*cos(q_pin2) + (2*sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - 2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 - m*l^2*sin(q_pin1)*(2 + 3*cos(q_pin2) +
    //   2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*q'*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) + q'*sin(q_pin1)*(sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - 1 + (cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    //   - sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   q'*sin(q_pin1)*(sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - cos(q_ground2)*(cos(q_ground1)*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + cos(q_ground1 + q_pin2)*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) - sin(q_ground2)*(sin(q_ground1)*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + sin(q_ground1 + q_pin2)*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q' - q'*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + q'*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q - q_pin1)) + sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(q'*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) - q'*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + q'*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   sin(q_pin1)*(q'*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
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
    //   6*m*l*(l*q'*sin(q_pin1)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1) + l*q_pin1'*sin(q_pin1)))/(6*d1)
    let u_dot_by_q_dot = -d1_inv_by_6
        * (S::int(6) * m_l
            * (-q_pin1_dot)
                .mul_add(l_sin_q_pin1, l * u_dot_of_q_dot_2 * minus_u_dot_of_place_5)
            + u_dot_of_place_11
                * (-d1_of_place_11
                    * u_dot_of_q_dot_2_13
                        .mul_add(
                            q_pin2_ddot_by_q_ground1_of_place_2, u_dot_by_q_of_q_dot_2_13,
                        )
                    + minus_d1_of_place_30 * u_dot_of_q_dot_2_10 * u_dot_of_place_18
                        * cos_q_pin1_doubled
                    - q_dot_2_d1_of_place_11
                        * (sin_q_ground2
                            * d1_of_place_16
                                .mul_add(
                                    u_dot_by_q_dot_of_place,
                                    sin_q_pin1_sin_angle_inv * sin_q_ground1,
                                ) - u_dot_of_place_2 * q_ground2_ddot_by_q_of_place
                            + cos_q_ground2
                                * d1_of_place_13
                                    .mul_add(
                                        u_dot_by_q_dot_of_place,
                                        sin_q_pin1_sin_angle_inv * cos_q_ground1,
                                    ))
                    - u_dot_of_q_dot_2_21 * (u_dot_by_q_dot_of_place - q_ground2_ddot_by_q_of_place)
                    + u_dot_by_q_of_q_dot_2_2 * u_dot_by_q_dot_of_place_2)
            + u_dot_of_place_39
                * (-q_dot_2_sin_angle_inv
                    * (-sin_q_ground1 * sin_q_plus_q_pin1.mul_add(u_dot_of_place_19, sin_q)
                        + sin_q_pin1_sin_angle_inv * u_dot_of_place_37
                        - cos_q_ground1 * cos_q_plus_q_pin1.mul_add(u_dot_of_place_19, cos_q))
                    + u_dot_of_q_dot_2_13 * u_dot_by_q_pin1_of_place_3
                    - sin_angle_inv * u_dot_of_q_dot_2_28
                    - u_dot_of_q_dot_2_30 * u_dot_by_q_dot_of_place_2)
            + sin_angle_inv * u_dot_of_place_34 * u_dot_by_q_dot_of_q_dot_2);
    let u_dot_of_place_7_doubled = S::int(2) * u_dot_of_place_7;
    // q_ground1_ddot_by_q_dot = (2*q'*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))/sin(q - q_ground1 + q_pin1) + u_dot_by_q_dot*sin(q_pin1))/sin(q -
    //   q_ground1 + q_pin1)
    let q_ground1_ddot_by_q_dot = (-(d1_of_place_7 * q_ground1_ddot_by_q_of_q_dot_2))
        .mul_add(S::int(2), u_dot_by_q_dot * sin_q_pin1_sin_angle_inv)
        - u_dot_by_q_of_q_dot_2 * u_dot_of_place_7_doubled;
    // q_ground2_ddot_by_q_dot = (2*q'*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1))
    //   - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/sin(q - q_ground1 +
    //   q_pin1) + u_dot_by_q_dot*sin(q_pin1)*sin(q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2))
    let q_ground2_ddot_by_q_dot = (-d1_of_place_11)
        .mul_add(
            q_ground2_ddot_by_q_of_q_dot_2_5,
            u_dot_by_q_dot * q_ground2_ddot_by_q_of_place,
        ) - u_dot_of_place_7 * q_ground2_ddot_by_q_of_q_dot_2_6
        - d1_of_place_7 * sin_q_pin2_doubled * u_dot_by_q_pin1_of_q_dot_2;
    let q_pin1_ddot_by_q_dot_of_q_dot_2 = sin_angle_inv * u_dot_of_q_dot_2_29;
    // d1_of_place_27 - d1_of_place_3^2
    let q_pin1_ddot_by_q_dot_of_place = (-d1_of_place_3)
        .mul_add(d1_of_place_3, d1_of_place_27);
    // q_pin1_ddot_by_q_dot = (2*q'*((sin(q_ground1)*(sin(q)*sin(q_pin1) - cos(q_ground1)*cos(q +
    //   q_pin1)*(cos(q) + cos(q + q_pin1)) + sin(q + q_pin1)*(sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))) + cos(q - q_ground1 +
    //   q_pin1)*((cos(q)*(sin(q_pin1) + 2*cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q)
    //   + 2*cos(q + q_pin1))) + cos(q + q_pin1)*(sin(q_pin1) - sin(q_ground1)*cos(q + q_pin1) +
    //   2*cos(q_ground1)*(sin(q) + sin(q + q_pin1))))/sin(q - q_ground1 + q_pin1) - cos(q) - cos(q +
    //   q_pin1))) + cos(q_ground1)*(cos(q)*sin(q_pin1) + cos(q + q_pin1)*(sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + cos(q - q_ground1 + q_pin1)*(sin(q) + sin(q + q_pin1) -
    //   (sin(q)*(sin(q_pin1) + cos(q_ground1)*(sin(q) + 2*sin(q + q_pin1))) + sin(q + q_pin1)*(sin(q_pin1) +
    //   cos(q_ground1)*sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/sin(q - q_ground1 + q_pin1) -
    //   sin(q_ground1)*(sin(q) + sin(q + q_pin1)) - cos(q_ground1)*(cos(q) + cos(q + q_pin1))) +
    //   u_dot_by_q_dot*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1))))/sin(q - q_ground1 + q_pin1)
    let q_pin1_ddot_by_q_dot = -u_dot_by_q_dot_of_q_dot_2
        * u_dot_of_place_7
            .mul_add(
                q_ground1_ddot_by_q_of_place_5,
                d1_of_place_7 * q_ground1_ddot_by_q_of_place_4,
            ) + u_dot_by_q_dot * d1_of_place_7
        - q_ground1_ddot_by_q_of_q_dot_2_4 * u_dot_of_place_7_doubled
        + S::int(4) * q_pin1_ddot_by_q_dot_of_q_dot_2
            * q_ground1_ddot_by_q_of_place_2
                .mul_add(q_ground1_ddot_by_q_of_place_3, d1_of_place_28)
        + S::int(2) * q_pin1_ddot_by_q_dot_of_q_dot_2
            * (-d1_of_place_4).mul_add(d1_of_place_4, q_pin1_ddot_by_q_dot_of_place);
    // q_pin2_ddot_by_q_dot = (2*q'*(cos(q_pin1)*(sin(q_ground1)*(cos(q_ground2)*(cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) - cos(q)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - cos(q +
    //   q_pin1)*(sin(q_ground1) + sin(q_ground1 + q_pin2))) + sin(q_ground2)*(cos(q)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) + cos(q + q_pin1)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))) +
    //   cos(q_ground1)*(cos(q_ground2)*sin(q_ground1 + q_pin2)*(sin(q) + sin(q + q_pin1)) -
    //   sin(q_ground2)*(sin(q)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + sin(q + q_pin1)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2))))) + sin(q_pin1)*(sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/tan(q -
    //   q_ground1 + q_pin1) - sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) +
    //   (sin(q_ground2)*(sin(q_ground1)*sin(q_pin2) - cos(q_ground2)*cos(q_ground1 + q_pin2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) + sin(q_ground1 + q_pin2)*(sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))) +
    //   cos(q_ground1 - q_ground2 + q_pin2)*((cos(q_ground1)*(sin(q_pin2) + 2*cos(q_ground2)*(sin(q_ground1)
    //   + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) +
    //   cos(q_ground1 + q_pin2)*(sin(q_pin2) - sin(q_ground2)*cos(q_ground1 + q_pin2) +
    //   2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2) -
    //   cos(q_ground1) - cos(q_ground1 + q_pin2))) + cos(q_ground2)*(cos(q_ground1)*sin(q_pin2) +
    //   cos(q_ground1 + q_pin2)*(sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))) +
    //   cos(q_ground1 - q_ground2 + q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2) -
    //   (sin(q_ground1)*(sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2))) +
    //   sin(q_ground1 + q_pin2)*(sin(q_pin2) + cos(q_ground2)*sin(q_ground1 + q_pin2)))/sin(q_ground1 -
    //   q_ground2 + q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2)) + cos(q - q_ground1 +
    //   q_pin1)*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - (sin(q_ground1)*(cos(q_ground2)*(cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - cos(q)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - cos(q + q_pin1)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2))) + sin(q_ground2)*(cos(q)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) +
    //   cos(q + q_pin1)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))) +
    //   cos(q_ground1)*(cos(q_ground2)*sin(q_ground1 + q_pin2)*(sin(q) + sin(q + q_pin1)) -
    //   sin(q_ground2)*(sin(q)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + sin(q + q_pin1)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)))))/sin(q - q_ground1 + q_pin1))))/sin(q - q_ground1 + q_pin1) +
    //   u_dot_by_q_dot*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_ddot_by_q_dot = q_pin2_ddot_by_q_of_place_28
        * (u_dot_by_q_dot_of_q_dot_2
            * (sin_q_pin1
                * (sin_q_pin1
                    * (q_pin2_ddot_by_q_ground1_of_place_2 + q_pin2_ddot_by_q_pin1_of_place_3)
                    - q_pin2_ddot_by_q_ground2_of_place_7) + q_pin2_ddot_by_q_pin2_of_place)
            + u_dot_by_q_dot * q_pin2_ddot_by_q_of_place_27);
    let d1_of_place_8_d1_inv = d1_of_place_8 * d1_inv;
    let u_dot_by_q_ground1_dot_of_q_pin2_dot = q_pin2_dot * d1_of_place_8_d1_inv * sin_q_pin2;
    // u_dot_by_q_ground1_dot = m*l^2*sin(q_pin1)*sin(q_pin2)*(q_ground1'*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + q_pin2')/(d1*sin(q - q_ground1 + q_pin1))
    let u_dot_by_q_ground1_dot = (l_m_l_d1_of_place_11 * d1_of_place_30 * d1_inv)
        .mul_add(q_ground1_dot_sin_q_pin2, u_dot_by_q_ground1_dot_of_q_pin2_dot);
    // q_ground1_ddot_by_q_ground1_dot = u_dot_by_q_ground1_dot*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    let q_ground1_ddot_by_q_ground1_dot = u_dot_by_q_ground1_dot * sin_q_pin1_sin_angle_inv;
    // q_ground2_ddot_by_q_ground1_dot = u_dot_by_q_ground1_dot*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_ground2_ddot_by_q_ground1_dot = u_dot_by_q_ground1_dot * q_ground2_ddot_by_q_of_place;
    // q_pin1_ddot_by_q_ground1_dot = u_dot_by_q_ground1_dot*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)
    let q_pin1_ddot_by_q_ground1_dot = u_dot_by_q_ground1_dot * d1_of_place_7;
    let q_pin2_ddot_by_q_ground1_dot_of_place = d1_of_place_11 * d1_of_place_30;
    // q_pin2_ddot_by_q_ground1_dot = u_dot_by_q_ground1_dot*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_ddot_by_q_ground1_dot = -u_dot_by_q_ground1_dot
        * q_pin2_ddot_by_q_ground1_dot_of_place;
    // u_dot_by_q_pin1_dot = m*l^2*sin(q_pin1)*(q' + q_pin1')/d1
    let u_dot_by_q_pin1_dot = l_m_l * d1_inv * sin_q_pin1 * (q_dot_2 + q_pin1_dot);
    // q_ground1_ddot_by_q_pin1_dot = u_dot_by_q_pin1_dot*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    let q_ground1_ddot_by_q_pin1_dot = u_dot_by_q_pin1_dot * sin_q_pin1_sin_angle_inv;
    // q_ground2_ddot_by_q_pin1_dot = u_dot_by_q_pin1_dot*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_ground2_ddot_by_q_pin1_dot = u_dot_by_q_pin1_dot * q_ground2_ddot_by_q_of_place;
    // q_pin1_ddot_by_q_pin1_dot = u_dot_by_q_pin1_dot*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)
    let q_pin1_ddot_by_q_pin1_dot = u_dot_by_q_pin1_dot * d1_of_place_7;
    // q_pin2_ddot_by_q_pin1_dot = u_dot_by_q_pin1_dot*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_ddot_by_q_pin1_dot = -u_dot_by_q_pin1_dot * q_pin2_ddot_by_q_ground1_dot_of_place;
    // u_dot_by_q_pin2_dot = m*l^2*sin(q_pin1)*sin(q_pin2)*(q_ground1' + q_pin2')/(d1*sin(q - q_ground1 +
    //   q_pin1))
    let u_dot_by_q_pin2_dot = q_ground1_dot_sin_q_pin2
        .mul_add(d1_of_place_8_d1_inv, u_dot_by_q_ground1_dot_of_q_pin2_dot);
    // q_ground1_ddot_by_q_pin2_dot = u_dot_by_q_pin2_dot*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    let q_ground1_ddot_by_q_pin2_dot = u_dot_by_q_pin2_dot * sin_q_pin1_sin_angle_inv;
    // q_ground2_ddot_by_q_pin2_dot = u_dot_by_q_pin2_dot*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_ground2_ddot_by_q_pin2_dot = u_dot_by_q_pin2_dot * q_ground2_ddot_by_q_of_place;
    // q_pin1_ddot_by_q_pin2_dot = u_dot_by_q_pin2_dot*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)
    let q_pin1_ddot_by_q_pin2_dot = u_dot_by_q_pin2_dot * d1_of_place_7;
    // q_pin2_ddot_by_q_pin2_dot = u_dot_by_q_pin2_dot*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_ddot_by_q_pin2_dot = -u_dot_by_q_pin2_dot * q_pin2_ddot_by_q_ground1_dot_of_place;
    // Entries that are not zero.
    // d(q')/d(q') = 1
    let q_dot_by_q_dot_value = S::int(1);
    // d(q_ground1')/d(q_ground1') = 1
    let q_ground1_dot_by_q_ground1_dot_value = S::int(1);
    // d(q_ground2')/d(q_ground2') = 1
    let q_ground2_dot_by_q_ground2_dot_value = S::int(1);
    // d(q_pin1')/d(q_pin1') = 1
    let q_pin1_dot_by_q_pin1_dot_value = S::int(1);
    // d(q_pin2')/d(q_pin2') = 1
    let q_pin2_dot_by_q_pin2_dot_value = S::int(1);
    let zero = S::int(0);
    [
        [zero, zero, zero, zero, zero, q_dot_by_q_dot_value, zero, zero, zero, zero],
        [
            zero, zero, zero, zero, zero, zero, q_ground1_dot_by_q_ground1_dot_value, zero, zero,
            zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, q_ground2_dot_by_q_ground2_dot_value, zero,
            zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, q_pin1_dot_by_q_pin1_dot_value, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, q_pin2_dot_by_q_pin2_dot_value,
        ],
        [
            u_dot_by_q, u_dot_by_q_ground1, u_dot_by_q_ground2, u_dot_by_q_pin1, u_dot_by_q_pin2,
            u_dot_by_q_dot, u_dot_by_q_ground1_dot, zero, u_dot_by_q_pin1_dot, u_dot_by_q_pin2_dot,
        ],
        [
            q_ground1_ddot_by_q, q_ground1_ddot_by_q_ground1, q_ground1_ddot_by_q_ground2,
            q_ground1_ddot_by_q_pin1, q_ground1_ddot_by_q_pin2, q_ground1_ddot_by_q_dot,
            q_ground1_ddot_by_q_ground1_dot, zero, q_ground1_ddot_by_q_pin1_dot,
            q_ground1_ddot_by_q_pin2_dot,
        ],
        [
            q_ground2_ddot_by_q, q_ground2_ddot_by_q_ground1, q_ground2_ddot_by_q_ground2,
            q_ground2_ddot_by_q_pin1, q_ground2_ddot_by_q_pin2, q_ground2_ddot_by_q_dot,
            q_ground2_ddot_by_q_ground1_dot, zero, q_ground2_ddot_by_q_pin1_dot,
            q_ground2_ddot_by_q_pin2_dot,
        ],
        [
            q_pin1_ddot_by_q, q_pin1_ddot_by_q_ground1, q_pin1_ddot_by_q_ground2,
            q_pin1_ddot_by_q_pin1, q_pin1_ddot_by_q_pin2, q_pin1_ddot_by_q_dot,
            q_pin1_ddot_by_q_ground1_dot, zero, q_pin1_ddot_by_q_pin1_dot,
            q_pin1_ddot_by_q_pin2_dot,
        ],
        [
            q_pin2_ddot_by_q, q_pin2_ddot_by_q_ground1, q_pin2_ddot_by_q_ground2,
            q_pin2_ddot_by_q_pin1, q_pin2_ddot_by_q_pin2, q_pin2_ddot_by_q_dot,
            q_pin2_ddot_by_q_ground1_dot, zero, q_pin2_ddot_by_q_pin1_dot,
            q_pin2_ddot_by_q_pin2_dot,
        ],
    ]
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

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 125 convolutions and 264 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 10]],
    history: &mut [Factors<S, 128>],
) {
    let Parameters { m, l, g } = *p;
    let [q_2_0, q_ground1_0, q_ground2_0, q_pin1_0, q_pin2_0, q_dot_2_0, q_ground1_dot_0,
    q_ground2_dot_0, q_pin1_dot_0, q_pin2_dot_0] = series[0];
    // Shared terms.
    let m_l_sq = m * l * l;
    let m_l_g = m * l * g;
    // Constant in time.
    // weight = 5*m*l^2/3
    let weight = S::ratio(5, 3) * m_l_sq;
    // m_l_2 = m*l^2
    let m_l_2 = m_l_sq;
    // m_l_2_by_6 = m*l^2/6
    let m_l_2_by_6 = S::ratio(1, 6) * m_l_sq;
    // m_l_2_by_3 = m*l^2/3
    let m_l_2_by_3 = S::ratio(1, 3) * m_l_sq;
    // minus_m_l_2_by_6 = -m*l^2/6
    let minus_m_l_2_by_6 = -S::ratio(1, 6) * m_l_sq;
    // minus_l = -l
    let minus_l = -l;
    // minus_3_g = -3*g
    let minus_3_g = -S::int(3) * g;
    // minus_g = -g
    let minus_g = -g;
    // weight_2 = 3*m*l^2
    let weight_2 = S::int(3) * m_l_sq;
    // minus_9_m_l_g = -9*m*l*g
    let minus_9_m_l_g = -S::int(9) * m_l_g;
    // minus_3_m_l_g = -3*m*l*g
    let minus_3_m_l_g = -S::int(3) * m_l_g;
    // weight_3 = 3*m*l
    let weight_3 = S::int(3) * m * l;
    // minus_m_l_2 = -m*l^2
    let minus_m_l_2 = -m_l_sq;
    // minus_2_m_l_2 = -2*m*l^2
    let minus_2_m_l_2 = -S::int(2) * m_l_sq;
    // Order 0.
    let (sin_q_pin1_0, cos_q_pin1_0) = q_pin1_0.sin_cos();
    let (sin_q_pin2_0, cos_q_pin2_0) = q_pin2_0.sin_cos();
    let (sin_q_0, cos_q_0) = q_2_0.sin_cos();
    let (sin_q_ground1_0, cos_q_ground1_0) = q_ground1_0.sin_cos();
    let q_2_plus_q_pin1_0 = q_2_0 + q_pin1_0;
    let (sin_q_plus_q_pin1_0, cos_q_plus_q_pin1_0) = q_2_plus_q_pin1_0.sin_cos();
    let d1_of_place_0 = q_2_0 + q_pin1_0 - q_ground1_0;
    let (sin_angle_0, cos_angle_0) = d1_of_place_0.sin_cos();
    let over_sin_angle = S::int(1) / sin_angle_0;
    let (sin_q_ground2_0, cos_q_ground2_0) = q_ground2_0.sin_cos();
    let q_ground1_plus_q_pin2_0 = q_ground1_0 + q_pin2_0;
    let (sin_q_ground1_plus_q_pin2_0, cos_q_ground1_plus_q_pin2_0) = q_ground1_plus_q_pin2_0
        .sin_cos();
    let d1_of_place_2_0 = q_ground1_0 + q_pin2_0 - q_ground2_0;
    let (sin_angle_2_0, cos_angle_2_0) = d1_of_place_2_0.sin_cos();
    let over_sin_angle_2 = S::int(1) / sin_angle_2_0;
    let d1_of_q_2_q_pin1_0 = sin_q_0 + sin_q_plus_q_pin1_0;
    let d1_of_q_2_q_pin1_2_0 = cos_q_0 + cos_q_plus_q_pin1_0;
    let d1_of_place_3_0 = sin_q_ground1_0 + sin_q_ground1_plus_q_pin2_0;
    let d1_of_place_4_0 = cos_q_ground1_0 + cos_q_ground1_plus_q_pin2_0;
    let sin_q_sin_q_ground1_0 = sin_q_0 * sin_q_ground1_0;
    let cos_q_cos_q_ground1_0 = cos_q_0 * cos_q_ground1_0;
    let d1_of_place_5_0 = sin_q_sin_q_ground1_0 + cos_q_cos_q_ground1_0;
    let d1_of_place_6_0 = sin_q_pin1_0 * d1_of_place_5_0;
    let sin_q_cos_q_ground1_0 = sin_q_0 * cos_q_ground1_0;
    let cos_q_sin_q_ground1_0 = cos_q_0 * sin_q_ground1_0;
    let d1_of_place_7_0 = sin_q_cos_q_ground1_0 - cos_q_sin_q_ground1_0;
    let d1_of_place_8_0 = cos_q_pin1_0 * d1_of_place_7_0;
    let d1_of_place_9_0 = d1_of_place_6_0 + d1_of_place_8_0;
    let over_d1_of_place_9 = S::int(1) / d1_of_place_9_0;
    let d1_of_place_10_0 = sin_q_ground1_0 * d1_of_q_2_q_pin1_2_0;
    let d1_of_place_11_0 = cos_q_ground1_0 * d1_of_q_2_q_pin1_0;
    let d1_of_place_12_0 = d1_of_place_10_0 - d1_of_place_11_0;
    let d1_of_place_13_0 = sin_q_ground2_0 * d1_of_place_4_0;
    let d1_of_place_14_0 = cos_q_ground2_0 * d1_of_place_3_0;
    let d1_of_place_15_0 = d1_of_place_13_0 - d1_of_place_14_0;
    let d1_of_place_16_0 = cos_q_pin1_0 * d1_of_place_12_0;
    let d1_of_place_17_0 = d1_of_place_16_0
        .mul_add(
            S::int(3),
            d1_of_place_11_0.mul_add(-S::int(2), S::int(2) * d1_of_place_10_0),
        );
    let d1_of_place_18_0 = d1_of_place_17_0 * over_sin_angle;
    let d1_of_place_19_0 = cos_q_pin2_0 * d1_of_place_15_0;
    let d1_of_place_20_0 = d1_of_place_19_0
        .mul_add(
            S::int(3),
            d1_of_place_14_0.mul_add(-S::int(2), S::int(2) * d1_of_place_13_0),
        );
    let d1_of_place_21_0 = d1_of_place_20_0 * over_sin_angle_2;
    let d1_of_place_22_0 = cos_q_pin2_0.mul_add(S::int(6), S::int(10)) + d1_of_place_21_0;
    let d1_of_place_23_0 = cos_q_pin1_0 * d1_of_place_9_0;
    let d1_of_place_24_0 = d1_of_place_23_0
        .mul_add(
            -S::int(3),
            cos_q_sin_q_ground1_0.mul_add(-S::int(2), S::int(2) * sin_q_cos_q_ground1_0),
        );
    let d1_of_place_25_0 = d1_of_place_15_0 * over_sin_angle_2;
    let d1_of_place_26_0 = d1_of_place_25_0
        .mul_add(S::int(2), cos_q_pin2_0.mul_add(S::int(3), S::int(2)));
    let sin_q_pin1_sin_angle_inv_0 = sin_q_pin1_0 * over_sin_angle;
    let d1_of_place_27_0 = sin_q_pin1_sin_angle_inv_0 * sin_q_pin1_sin_angle_inv_0;
    let d1_of_place_28_0 = d1_of_place_22_0 * d1_of_place_27_0;
    let d1_of_place_29_0 = sin_q_pin2_0 * over_sin_angle_2;
    let d1_of_place_30_0 = d1_of_place_29_0 * d1_of_place_29_0;
    let d1_of_place_31_0 = d1_of_place_27_0 * d1_of_place_30_0;
    let d1_of_place_32_0 = d1_of_place_12_0 * over_sin_angle;
    let d1_of_place_33_0 = d1_of_place_24_0 * over_d1_of_place_9;
    let d1_of_place_34_0 = d1_of_place_32_0 * d1_of_place_33_0;
    let d1_of_place_35_0 = d1_of_place_25_0 * d1_of_place_27_0;
    let d1_of_place_36_0 = d1_of_place_26_0 * d1_of_place_35_0;
    let d1_of_place_37_0 = d1_of_place_34_0
        .mul_add(
            minus_m_l_2_by_6,
            d1_of_place_28_0
                .mul_add(
                    m_l_2_by_6,
                    d1_of_place_36_0
                        .mul_add(
                            m_l_2_by_6,
                            d1_of_place_18_0
                                .mul_add(
                                    m_l_2_by_6,
                                    d1_of_place_31_0
                                        .mul_add(m_l_2_by_3, cos_q_pin1_0.mul_add(m_l_2, weight)),
                                ),
                        ),
                ),
        );
    let over_d1_of_place_37 = S::int(1) / d1_of_place_37_0;
    let q_dot_2_sin_q_0 = q_dot_2_0 * sin_q_0;
    let q_dot_2_cos_q_0 = q_dot_2_0 * cos_q_0;
    let u_dot_of_q_dot_2_0 = q_dot_2_0 * sin_q_pin1_sin_angle_inv_0;
    let q_dot_2_sin_angle_inv_0 = q_dot_2_0 * over_sin_angle;
    let u_dot_of_q_dot_2_2_0 = d1_of_place_12_0 * q_dot_2_sin_angle_inv_0;
    let u_dot_of_q_dot_2_3_0 = q_dot_2_0 - u_dot_of_q_dot_2_0 + u_dot_of_q_dot_2_2_0;
    let u_dot_of_place_0 = sin_q_pin1_0 + d1_of_place_11_0 - d1_of_place_10_0;
    let u_dot_of_place_2_0 = u_dot_of_place_0 * over_sin_angle;
    let u_dot_of_place_3_0 = -S::int(1) + u_dot_of_place_2_0;
    let sin_q_pin1_cos_angle_0 = sin_q_pin1_0 * cos_angle_0;
    let u_dot_of_place_4_0 = u_dot_of_place_3_0 * sin_q_pin1_cos_angle_0;
    let u_dot_of_place_5_0 = d1_of_place_16_0 + u_dot_of_place_4_0;
    let u_dot_of_q_dot_2_4_0 = u_dot_of_q_dot_2_0 * d1_of_place_29_0;
    let u_dot_of_q_dot_2_5_0 = u_dot_of_q_dot_2_0 * d1_of_place_25_0;
    let u_dot_of_q_dot_2_6_0 = u_dot_of_q_dot_2_0 - u_dot_of_q_dot_2_4_0 + u_dot_of_q_dot_2_5_0;
    let u_dot_of_place_6_0 = sin_q_pin2_0 + d1_of_place_14_0 - d1_of_place_13_0;
    let u_dot_of_place_7_0 = u_dot_of_place_6_0 * over_sin_angle_2;
    let u_dot_of_place_8_0 = -S::int(1) + u_dot_of_place_7_0;
    let u_dot_of_place_9_0 = cos_angle_2_0 * over_sin_angle_2;
    let u_dot_of_place_10_0 = u_dot_of_place_8_0 * u_dot_of_place_9_0;
    let sin_angle_inv_cos_angle_0 = cos_angle_0 * over_sin_angle;
    let u_dot_of_place_11_0 = sin_angle_inv_cos_angle_0 + u_dot_of_place_10_0;
    let u_dot_of_place_12_0 = sin_q_pin1_0 * u_dot_of_place_11_0;
    let u_dot_of_place_13_0 = S::int(1) + d1_of_place_32_0;
    let u_dot_of_place_14_0 = cos_angle_0 * u_dot_of_place_13_0;
    let u_dot_of_place_15_0 = -u_dot_of_place_14_0 + u_dot_of_place_12_0;
    let u_dot_of_place_16_0 = sin_q_pin2_0 * u_dot_of_place_15_0;
    let sin_q_pin1_cos_q_pin2_0 = sin_q_pin1_0 * cos_q_pin2_0;
    let u_dot_of_place_17_0 = d1_of_place_25_0 * sin_q_pin1_cos_q_pin2_0;
    let u_dot_of_place_18_0 = u_dot_of_place_17_0 + u_dot_of_place_16_0;
    let u_dot_of_place_19_0 = sin_q_pin1_0 * u_dot_of_place_18_0;
    let u_dot_of_place_20_0 = sin_q_pin2_0 * d1_of_place_16_0;
    let u_dot_of_place_21_0 = u_dot_of_place_20_0 + u_dot_of_place_19_0;
    let u_dot_of_q_dot_2_7_0 = q_dot_2_0 + u_dot_of_q_dot_2_2_0;
    let u_dot_of_q_dot_2_8_0 = cos_q_plus_q_pin1_0 * u_dot_of_q_dot_2_7_0;
    let u_dot_of_q_dot_2_9_0 = sin_q_plus_q_pin1_0 * u_dot_of_q_dot_2_7_0;
    let u_dot_of_q_dot_2_10_0 = q_dot_2_cos_q_0 + u_dot_of_q_dot_2_8_0;
    let u_dot_of_q_dot_2_11_0 = cos_q_ground1_0 * u_dot_of_q_dot_2_0;
    let u_dot_of_q_dot_2_12_0 = d1_of_q_2_q_pin1_2_0 * u_dot_of_q_dot_2_11_0;
    let u_dot_of_q_dot_2_13_0 = q_dot_2_sin_q_0 + u_dot_of_q_dot_2_9_0;
    let u_dot_of_q_dot_2_14_0 = sin_q_ground1_0 * u_dot_of_q_dot_2_13_0;
    let u_dot_of_q_dot_2_15_0 = sin_q_ground1_0 * u_dot_of_q_dot_2_0;
    let u_dot_of_q_dot_2_16_0 = d1_of_q_2_q_pin1_0 * u_dot_of_q_dot_2_15_0;
    let u_dot_of_q_dot_2_17_0 = cos_q_ground1_0 * u_dot_of_q_dot_2_10_0;
    let u_dot_of_q_dot_2_18_0 = u_dot_of_q_dot_2_12_0 + u_dot_of_q_dot_2_16_0
        - u_dot_of_q_dot_2_14_0 - u_dot_of_q_dot_2_17_0;
    let u_dot_of_q_dot_2_19_0 = cos_angle_0 * q_dot_2_sin_angle_inv_0;
    let u_dot_of_q_dot_2_20_0 = d1_of_place_32_0 * u_dot_of_q_dot_2_19_0;
    let u_dot_of_q_dot_2_21_0 = u_dot_of_q_dot_2_3_0 * u_dot_of_q_dot_2_20_0;
    let u_dot_of_q_dot_2_22_0 = u_dot_of_q_dot_2_18_0 * q_dot_2_sin_angle_inv_0;
    let u_dot_of_q_dot_2_23_0 = u_dot_of_q_dot_2_0 + u_dot_of_q_dot_2_5_0;
    let u_dot_of_q_dot_2_24_0 = cos_q_ground1_plus_q_pin2_0 * u_dot_of_q_dot_2_23_0;
    let u_dot_of_q_dot_2_25_0 = sin_q_ground1_plus_q_pin2_0 * u_dot_of_q_dot_2_23_0;
    let u_dot_of_q_dot_2_26_0 = u_dot_of_q_dot_2_11_0 + u_dot_of_q_dot_2_24_0;
    let u_dot_of_place_22_0 = cos_q_ground2_0 * d1_of_place_4_0;
    let u_dot_of_q_dot_2_27_0 = u_dot_of_q_dot_2_4_0 * u_dot_of_place_22_0;
    let u_dot_of_q_dot_2_28_0 = u_dot_of_q_dot_2_15_0 + u_dot_of_q_dot_2_25_0;
    let u_dot_of_q_dot_2_29_0 = sin_q_ground2_0 * u_dot_of_q_dot_2_28_0;
    let u_dot_of_place_23_0 = sin_q_ground2_0 * d1_of_place_3_0;
    let u_dot_of_q_dot_2_30_0 = u_dot_of_q_dot_2_4_0 * u_dot_of_place_23_0;
    let u_dot_of_q_dot_2_31_0 = cos_q_ground2_0 * u_dot_of_q_dot_2_26_0;
    let u_dot_of_q_dot_2_32_0 = u_dot_of_q_dot_2_27_0 + u_dot_of_q_dot_2_30_0
        - u_dot_of_q_dot_2_29_0 - u_dot_of_q_dot_2_31_0;
    let u_dot_of_q_dot_2_33_0 = q_dot_2_sin_angle_inv_0 * q_dot_2_sin_angle_inv_0;
    let u_dot_of_q_dot_2_34_0 = d1_of_place_16_0 * u_dot_of_q_dot_2_33_0;
    let u_dot_of_q_dot_2_35_0 = d1_of_place_25_0 * u_dot_of_q_dot_2_34_0;
    let u_dot_of_q_dot_2_36_0 = u_dot_of_q_dot_2_3_0 * sin_angle_inv_cos_angle_0;
    let u_dot_of_q_dot_2_37_0 = u_dot_of_q_dot_2_5_0 * u_dot_of_q_dot_2_36_0;
    let u_dot_of_q_dot_2_38_0 = u_dot_of_q_dot_2_5_0 * u_dot_of_place_9_0;
    let u_dot_of_q_dot_2_39_0 = u_dot_of_q_dot_2_6_0 * u_dot_of_q_dot_2_38_0;
    let u_dot_of_q_dot_2_40_0 = u_dot_of_q_dot_2_0 * over_sin_angle_2;
    let u_dot_of_q_dot_2_41_0 = u_dot_of_q_dot_2_32_0 * u_dot_of_q_dot_2_40_0;
    let u_dot_of_q_dot_2_42_0 = u_dot_of_q_dot_2_35_0 - u_dot_of_q_dot_2_37_0
        - u_dot_of_q_dot_2_39_0 + u_dot_of_q_dot_2_41_0;
    let u_dot_of_motion_0 = S::int(2) * q_dot_2_0 + q_pin1_dot_0;
    let u_dot_of_motion_2_0 = q_pin1_dot_0 * u_dot_of_motion_0;
    let u_dot_of_motion_3_0 = sin_q_pin1_0 * u_dot_of_motion_2_0;
    let q_pin2_dot_sq_0 = q_pin2_dot_0 * q_pin2_dot_0;
    let u_dot_of_motion_4_0 = q_ground1_dot_0 * d1_of_place_25_0;
    let u_dot_of_motion_5_0 = S::int(2) * q_pin2_dot_0 - u_dot_of_motion_4_0;
    let u_dot_of_motion_6_0 = q_ground1_dot_0 * u_dot_of_motion_5_0;
    let u_dot_of_motion_7_0 = q_pin2_dot_sq_0 + u_dot_of_motion_6_0;
    let u_dot_of_motion_8_0 = sin_q_pin2_0 * u_dot_of_motion_7_0;
    let q_dot_2_sq_0 = q_dot_2_0 * q_dot_2_0;
    let u_dot_of_q_dot_2_43_0 = d1_of_place_12_0 * q_dot_2_sq_0;
    let u_dot_of_place_24_0 = S::int(1) + d1_of_place_25_0;
    let u_dot_of_place_25_0 = cos_q_ground1_plus_q_pin2_0 * u_dot_of_place_24_0;
    let u_dot_of_place_26_0 = cos_q_ground2_0 * d1_of_place_29_0;
    let u_dot_of_motion_9_0 = u_dot_of_motion_8_0
        .mul_add(
            l,
            u_dot_of_place_25_0
                .mul_add(
                    minus_g,
                    u_dot_of_q_dot_2_43_0
                        .mul_add(
                            minus_l,
                            u_dot_of_place_26_0
                                .mul_add(minus_g, minus_3_g * cos_q_ground1_0),
                        ),
                ),
        );
    let u_dot_of_motion_10_0 = sin_q_pin1_0 * u_dot_of_motion_9_0;
    let u_dot_of_place_27_0 = cos_q_plus_q_pin1_0 * d1_of_place_12_0;
    let u_dot_of_motion_11_0 = minus_g * u_dot_of_place_27_0 + u_dot_of_motion_10_0;
    let u_dot_of_motion_12_0 = u_dot_of_motion_11_0 * over_sin_angle;
    let q_dot_2_sin_angle_inv2_0 = q_dot_2_sin_angle_inv_0 * over_sin_angle;
    let u_dot_of_q_dot_2_44_0 = u_dot_of_q_dot_2_0 * q_dot_2_sin_angle_inv2_0;
    let u_dot_of_q_dot_2_45_0 = d1_of_place_22_0 * u_dot_of_q_dot_2_44_0;
    let u_dot_of_q_dot_2_46_0 = u_dot_of_place_5_0 * u_dot_of_q_dot_2_45_0;
    let u_dot_of_place_28_0 = u_dot_of_place_21_0 * over_sin_angle_2;
    let u_dot_of_q_dot_2_47_0 = u_dot_of_q_dot_2_4_0 * q_dot_2_sin_angle_inv2_0;
    let u_dot_of_q_dot_2_48_0 = u_dot_of_place_28_0 * u_dot_of_q_dot_2_47_0;
    let u_dot_of_q_dot_2_49_0 = u_dot_of_q_dot_2_21_0 - u_dot_of_q_dot_2_22_0;
    let u_dot_of_q_dot_2_50_0 = u_dot_of_q_dot_2_49_0 * d1_of_place_33_0;
    let u_dot_of_place_29_0 = d1_of_place_26_0 * sin_q_pin1_sin_angle_inv_0;
    let u_dot_of_q_dot_2_51_0 = u_dot_of_q_dot_2_42_0 * u_dot_of_place_29_0;
    let u_dot_of_motion_13_0 = u_dot_of_q_dot_2_48_0
        .mul_add(
            minus_2_m_l_2,
            u_dot_of_q_dot_2_51_0
                .mul_add(
                    minus_m_l_2,
                    u_dot_of_motion_12_0
                        .mul_add(
                            weight_3,
                            u_dot_of_q_dot_2_50_0
                                .mul_add(
                                    minus_m_l_2,
                                    u_dot_of_q_dot_2_46_0
                                        .mul_add(
                                            minus_m_l_2,
                                            u_dot_of_motion_3_0
                                                .mul_add(
                                                    weight_2,
                                                    cos_q_plus_q_pin1_0
                                                        .mul_add(minus_3_m_l_g, minus_9_m_l_g * cos_q_0),
                                                ),
                                        ),
                                ),
                        ),
                ),
        );
    let u_dot_of_motion_14_0 = u_dot_of_motion_13_0 * over_d1_of_place_37;
    let q_ground1_ddot_of_q_dot_2_0 = u_dot_of_place_5_0 * u_dot_of_q_dot_2_33_0;
    let q_ground1_ddot_of_motion_0 = u_dot_of_motion_14_0 * sin_q_pin1_sin_angle_inv_0;
    let q_ground1_dot_dot_0 = q_ground1_ddot_of_motion_0
        .mul_add(S::ratio(1, 6), q_ground1_ddot_of_q_dot_2_0);
    let q_ground2_ddot_of_q_dot_2_0 = u_dot_of_q_dot_2_33_0 * u_dot_of_place_28_0;
    let q_ground2_ddot_of_motion_0 = d1_of_place_29_0 * q_ground1_ddot_of_motion_0;
    let q_ground2_dot_dot_0 = q_ground2_ddot_of_motion_0
        .mul_add(S::ratio(1, 6), q_ground2_ddot_of_q_dot_2_0);
    let q_pin1_ddot_of_motion_0 = u_dot_of_motion_14_0 * d1_of_place_32_0;
    let q_pin1_dot_dot_0 = q_pin1_ddot_of_motion_0
        .mul_add(S::ratio(1, 6), -u_dot_of_q_dot_2_21_0 + u_dot_of_q_dot_2_22_0);
    let q_pin2_ddot_of_motion_0 = d1_of_place_25_0 * q_ground1_ddot_of_motion_0;
    let q_pin2_dot_dot_0 = q_pin2_ddot_of_motion_0
        .mul_add(
            S::ratio(1, 6),
            u_dot_of_q_dot_2_35_0 - u_dot_of_q_dot_2_37_0 - u_dot_of_q_dot_2_39_0
                + u_dot_of_q_dot_2_41_0,
        );
    // Order 1: the rates, and what follows from them.
    let q_2_1 = q_dot_2_0;
    let q_ground1_1 = q_ground1_dot_0;
    let q_ground2_1 = q_ground2_dot_0;
    let q_pin1_1 = q_pin1_dot_0;
    let q_pin2_1 = q_pin2_dot_0;
    let q_dot_2_1 = S::ratio(1, 6) * u_dot_of_motion_14_0;
    let q_ground1_dot_1 = q_ground1_dot_dot_0;
    let q_ground2_dot_1 = q_ground2_dot_dot_0;
    let q_pin1_dot_1 = q_pin1_dot_dot_0;
    let q_pin2_dot_1 = q_pin2_dot_dot_0;
    if series.len() > 1 {
        series[1] = [
            q_2_1, q_ground1_1, q_ground2_1, q_pin1_1, q_pin2_1, q_dot_2_1, q_ground1_dot_1,
            q_ground2_dot_1, q_pin1_dot_1, q_pin2_dot_1,
        ];
    }
    let sin_q_pin1_1 = q_pin1_1 * cos_q_pin1_0;
    let cos_q_pin1_1 = -q_pin1_1 * sin_q_pin1_0;
    let sin_q_pin2_1 = q_pin2_1 * cos_q_pin2_0;
    let cos_q_pin2_1 = -q_pin2_1 * sin_q_pin2_0;
    let sin_q_1 = q_2_1 * cos_q_0;
    let cos_q_1 = -q_2_1 * sin_q_0;
    let sin_q_ground1_1 = q_ground1_1 * cos_q_ground1_0;
    let cos_q_ground1_1 = -q_ground1_1 * sin_q_ground1_0;
    let q_2_plus_q_pin1_1 = q_2_1 + q_pin1_1;
    let sin_q_plus_q_pin1_1 = q_2_plus_q_pin1_1 * cos_q_plus_q_pin1_0;
    let cos_q_plus_q_pin1_1 = -q_2_plus_q_pin1_1 * sin_q_plus_q_pin1_0;
    let d1_of_place_1 = q_2_1 + q_pin1_1 - q_ground1_1;
    let sin_angle_1 = d1_of_place_1 * cos_angle_0;
    let cos_angle_1 = -d1_of_place_1 * sin_angle_0;
    let sin_q_ground2_1 = q_ground2_1 * cos_q_ground2_0;
    let cos_q_ground2_1 = -q_ground2_1 * sin_q_ground2_0;
    let q_ground1_plus_q_pin2_1 = q_ground1_1 + q_pin2_1;
    let sin_q_ground1_plus_q_pin2_1 = q_ground1_plus_q_pin2_1 * cos_q_ground1_plus_q_pin2_0;
    let cos_q_ground1_plus_q_pin2_1 = -q_ground1_plus_q_pin2_1 * sin_q_ground1_plus_q_pin2_0;
    let d1_of_place_2_1 = q_ground1_1 + q_pin2_1 - q_ground2_1;
    let sin_angle_2_1 = d1_of_place_2_1 * cos_angle_2_0;
    let cos_angle_2_1 = -d1_of_place_2_1 * sin_angle_2_0;
    let d1_of_q_2_q_pin1_1 = sin_q_1 + sin_q_plus_q_pin1_1;
    let d1_of_q_2_q_pin1_2_1 = cos_q_1 + cos_q_plus_q_pin1_1;
    let d1_of_place_3_1 = sin_q_ground1_1 + sin_q_ground1_plus_q_pin2_1;
    let d1_of_place_4_1 = cos_q_ground1_1 + cos_q_ground1_plus_q_pin2_1;
    let sin_q_sin_q_ground1_1 = sin_q_ground1_1
        .mul_add(sin_q_0, sin_q_1 * sin_q_ground1_0);
    let cos_q_cos_q_ground1_1 = cos_q_ground1_1
        .mul_add(cos_q_0, cos_q_1 * cos_q_ground1_0);
    let d1_of_place_5_1 = sin_q_sin_q_ground1_1 + cos_q_cos_q_ground1_1;
    let d1_of_place_6_1 = d1_of_place_5_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * d1_of_place_5_0);
    let sin_q_cos_q_ground1_1 = cos_q_ground1_1
        .mul_add(sin_q_0, sin_q_1 * cos_q_ground1_0);
    let cos_q_sin_q_ground1_1 = sin_q_ground1_1
        .mul_add(cos_q_0, cos_q_1 * sin_q_ground1_0);
    let d1_of_place_7_1 = sin_q_cos_q_ground1_1 - cos_q_sin_q_ground1_1;
    let d1_of_place_8_1 = d1_of_place_7_1
        .mul_add(cos_q_pin1_0, cos_q_pin1_1 * d1_of_place_7_0);
    let d1_of_place_9_1 = d1_of_place_6_1 + d1_of_place_8_1;
    let d1_of_place_10_1 = d1_of_q_2_q_pin1_2_1
        .mul_add(sin_q_ground1_0, sin_q_ground1_1 * d1_of_q_2_q_pin1_2_0);
    let d1_of_place_11_1 = d1_of_q_2_q_pin1_1
        .mul_add(cos_q_ground1_0, cos_q_ground1_1 * d1_of_q_2_q_pin1_0);
    let d1_of_place_12_1 = d1_of_place_10_1 - d1_of_place_11_1;
    let d1_of_place_13_1 = d1_of_place_4_1
        .mul_add(sin_q_ground2_0, sin_q_ground2_1 * d1_of_place_4_0);
    let d1_of_place_14_1 = d1_of_place_3_1
        .mul_add(cos_q_ground2_0, cos_q_ground2_1 * d1_of_place_3_0);
    let d1_of_place_15_1 = d1_of_place_13_1 - d1_of_place_14_1;
    let d1_of_place_16_1 = d1_of_place_12_1
        .mul_add(cos_q_pin1_0, cos_q_pin1_1 * d1_of_place_12_0);
    let d1_of_place_17_1 = d1_of_place_16_1
        .mul_add(
            S::int(3),
            d1_of_place_11_1.mul_add(-S::int(2), S::int(2) * d1_of_place_10_1),
        );
    let d1_of_place_18_1 = sin_angle_1
        .mul_add(
            -(d1_of_place_18_0 * over_sin_angle),
            d1_of_place_17_1 * over_sin_angle,
        );
    let d1_of_place_19_1 = d1_of_place_15_1
        .mul_add(cos_q_pin2_0, cos_q_pin2_1 * d1_of_place_15_0);
    let d1_of_place_20_1 = d1_of_place_19_1
        .mul_add(
            S::int(3),
            d1_of_place_14_1.mul_add(-S::int(2), S::int(2) * d1_of_place_13_1),
        );
    let d1_of_place_21_1 = sin_angle_2_1
        .mul_add(
            -(d1_of_place_21_0 * over_sin_angle_2),
            d1_of_place_20_1 * over_sin_angle_2,
        );
    let d1_of_place_22_1 = S::int(6) * cos_q_pin2_1 + d1_of_place_21_1;
    let d1_of_place_23_1 = d1_of_place_9_1
        .mul_add(cos_q_pin1_0, cos_q_pin1_1 * d1_of_place_9_0);
    let d1_of_place_24_1 = d1_of_place_23_1
        .mul_add(
            -S::int(3),
            cos_q_sin_q_ground1_1.mul_add(-S::int(2), S::int(2) * sin_q_cos_q_ground1_1),
        );
    let d1_of_place_25_1 = sin_angle_2_1
        .mul_add(
            -(d1_of_place_25_0 * over_sin_angle_2),
            d1_of_place_15_1 * over_sin_angle_2,
        );
    let d1_of_place_26_1 = d1_of_place_25_1.mul_add(S::int(2), S::int(3) * cos_q_pin2_1);
    let sin_q_pin1_sin_angle_inv_1 = sin_angle_1
        .mul_add(
            -(sin_q_pin1_sin_angle_inv_0 * over_sin_angle),
            sin_q_pin1_1 * over_sin_angle,
        );
    let d1_of_place_27_1 = sin_q_pin1_sin_angle_inv_1
        * (sin_q_pin1_sin_angle_inv_0 + sin_q_pin1_sin_angle_inv_0);
    let d1_of_place_28_1 = d1_of_place_22_1
        .mul_add(d1_of_place_27_0, d1_of_place_27_1 * d1_of_place_22_0);
    let d1_of_place_29_1 = sin_angle_2_1
        .mul_add(
            -(d1_of_place_29_0 * over_sin_angle_2),
            sin_q_pin2_1 * over_sin_angle_2,
        );
    let d1_of_place_30_1 = d1_of_place_29_1 * (d1_of_place_29_0 + d1_of_place_29_0);
    let d1_of_place_31_1 = d1_of_place_30_1
        .mul_add(d1_of_place_27_0, d1_of_place_27_1 * d1_of_place_30_0);
    let d1_of_place_32_1 = sin_angle_1
        .mul_add(
            -(d1_of_place_32_0 * over_sin_angle),
            d1_of_place_12_1 * over_sin_angle,
        );
    let d1_of_place_33_1 = d1_of_place_9_1
        .mul_add(
            -(d1_of_place_33_0 * over_d1_of_place_9),
            d1_of_place_24_1 * over_d1_of_place_9,
        );
    let d1_of_place_34_1 = d1_of_place_33_1
        .mul_add(d1_of_place_32_0, d1_of_place_32_1 * d1_of_place_33_0);
    let d1_of_place_35_1 = d1_of_place_25_1
        .mul_add(d1_of_place_27_0, d1_of_place_27_1 * d1_of_place_25_0);
    let d1_of_place_36_1 = d1_of_place_35_1
        .mul_add(d1_of_place_26_0, d1_of_place_26_1 * d1_of_place_35_0);
    let d1_of_place_37_1 = d1_of_place_34_1
        .mul_add(
            minus_m_l_2_by_6,
            d1_of_place_28_1
                .mul_add(
                    m_l_2_by_6,
                    d1_of_place_36_1
                        .mul_add(
                            m_l_2_by_6,
                            d1_of_place_18_1
                                .mul_add(
                                    m_l_2_by_6,
                                    d1_of_place_31_1.mul_add(m_l_2_by_3, m_l_2 * cos_q_pin1_1),
                                ),
                        ),
                ),
        );
    let q_dot_2_sin_q_1 = sin_q_1.mul_add(q_dot_2_0, q_dot_2_1 * sin_q_0);
    let q_dot_2_cos_q_1 = cos_q_1.mul_add(q_dot_2_0, q_dot_2_1 * cos_q_0);
    let u_dot_of_q_dot_2_1 = sin_q_pin1_sin_angle_inv_1
        .mul_add(q_dot_2_0, q_dot_2_1 * sin_q_pin1_sin_angle_inv_0);
    let q_dot_2_sin_angle_inv_1 = sin_angle_1
        .mul_add(
            -(q_dot_2_sin_angle_inv_0 * over_sin_angle),
            q_dot_2_1 * over_sin_angle,
        );
    let u_dot_of_q_dot_2_2_1 = d1_of_place_12_1
        .mul_add(q_dot_2_sin_angle_inv_0, q_dot_2_sin_angle_inv_1 * d1_of_place_12_0);
    let u_dot_of_q_dot_2_3_1 = q_dot_2_1 - u_dot_of_q_dot_2_1 + u_dot_of_q_dot_2_2_1;
    let u_dot_of_place_1 = sin_q_pin1_1 + d1_of_place_11_1 - d1_of_place_10_1;
    let u_dot_of_place_2_1 = sin_angle_1
        .mul_add(
            -(u_dot_of_place_2_0 * over_sin_angle),
            u_dot_of_place_1 * over_sin_angle,
        );
    let u_dot_of_place_3_1 = u_dot_of_place_2_1;
    let sin_q_pin1_cos_angle_1 = cos_angle_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * cos_angle_0);
    let u_dot_of_place_4_1 = u_dot_of_place_3_1
        .mul_add(sin_q_pin1_cos_angle_0, sin_q_pin1_cos_angle_1 * u_dot_of_place_3_0);
    let u_dot_of_place_5_1 = d1_of_place_16_1 + u_dot_of_place_4_1;
    let u_dot_of_q_dot_2_4_1 = u_dot_of_q_dot_2_1
        .mul_add(d1_of_place_29_0, d1_of_place_29_1 * u_dot_of_q_dot_2_0);
    let u_dot_of_q_dot_2_5_1 = d1_of_place_25_1
        .mul_add(u_dot_of_q_dot_2_0, u_dot_of_q_dot_2_1 * d1_of_place_25_0);
    let u_dot_of_q_dot_2_6_1 = u_dot_of_q_dot_2_1 - u_dot_of_q_dot_2_4_1 + u_dot_of_q_dot_2_5_1;
    let u_dot_of_place_6_1 = sin_q_pin2_1 + d1_of_place_14_1 - d1_of_place_13_1;
    let u_dot_of_place_7_1 = sin_angle_2_1
        .mul_add(
            -(u_dot_of_place_7_0 * over_sin_angle_2),
            u_dot_of_place_6_1 * over_sin_angle_2,
        );
    let u_dot_of_place_8_1 = u_dot_of_place_7_1;
    let u_dot_of_place_9_1 = sin_angle_2_1
        .mul_add(
            -(u_dot_of_place_9_0 * over_sin_angle_2),
            cos_angle_2_1 * over_sin_angle_2,
        );
    let u_dot_of_place_10_1 = u_dot_of_place_8_1
        .mul_add(u_dot_of_place_9_0, u_dot_of_place_9_1 * u_dot_of_place_8_0);
    let sin_angle_inv_cos_angle_1 = sin_angle_1
        .mul_add(
            -(sin_angle_inv_cos_angle_0 * over_sin_angle),
            cos_angle_1 * over_sin_angle,
        );
    let u_dot_of_place_11_1 = sin_angle_inv_cos_angle_1 + u_dot_of_place_10_1;
    let u_dot_of_place_12_1 = u_dot_of_place_11_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * u_dot_of_place_11_0);
    let u_dot_of_place_13_1 = d1_of_place_32_1;
    let u_dot_of_place_14_1 = u_dot_of_place_13_1
        .mul_add(cos_angle_0, cos_angle_1 * u_dot_of_place_13_0);
    let u_dot_of_place_15_1 = -u_dot_of_place_14_1 + u_dot_of_place_12_1;
    let u_dot_of_place_16_1 = u_dot_of_place_15_1
        .mul_add(sin_q_pin2_0, sin_q_pin2_1 * u_dot_of_place_15_0);
    let sin_q_pin1_cos_q_pin2_1 = cos_q_pin2_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * cos_q_pin2_0);
    let u_dot_of_place_17_1 = d1_of_place_25_1
        .mul_add(sin_q_pin1_cos_q_pin2_0, sin_q_pin1_cos_q_pin2_1 * d1_of_place_25_0);
    let u_dot_of_place_18_1 = u_dot_of_place_17_1 + u_dot_of_place_16_1;
    let u_dot_of_place_19_1 = u_dot_of_place_18_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * u_dot_of_place_18_0);
    let u_dot_of_place_20_1 = d1_of_place_16_1
        .mul_add(sin_q_pin2_0, sin_q_pin2_1 * d1_of_place_16_0);
    let u_dot_of_place_21_1 = u_dot_of_place_20_1 + u_dot_of_place_19_1;
    let u_dot_of_q_dot_2_7_1 = q_dot_2_1 + u_dot_of_q_dot_2_2_1;
    let u_dot_of_q_dot_2_8_1 = u_dot_of_q_dot_2_7_1
        .mul_add(cos_q_plus_q_pin1_0, cos_q_plus_q_pin1_1 * u_dot_of_q_dot_2_7_0);
    let u_dot_of_q_dot_2_9_1 = u_dot_of_q_dot_2_7_1
        .mul_add(sin_q_plus_q_pin1_0, sin_q_plus_q_pin1_1 * u_dot_of_q_dot_2_7_0);
    let u_dot_of_q_dot_2_10_1 = q_dot_2_cos_q_1 + u_dot_of_q_dot_2_8_1;
    let u_dot_of_q_dot_2_11_1 = u_dot_of_q_dot_2_1
        .mul_add(cos_q_ground1_0, cos_q_ground1_1 * u_dot_of_q_dot_2_0);
    let u_dot_of_q_dot_2_12_1 = u_dot_of_q_dot_2_11_1
        .mul_add(d1_of_q_2_q_pin1_2_0, d1_of_q_2_q_pin1_2_1 * u_dot_of_q_dot_2_11_0);
    let u_dot_of_q_dot_2_13_1 = q_dot_2_sin_q_1 + u_dot_of_q_dot_2_9_1;
    let u_dot_of_q_dot_2_14_1 = u_dot_of_q_dot_2_13_1
        .mul_add(sin_q_ground1_0, sin_q_ground1_1 * u_dot_of_q_dot_2_13_0);
    let u_dot_of_q_dot_2_15_1 = u_dot_of_q_dot_2_1
        .mul_add(sin_q_ground1_0, sin_q_ground1_1 * u_dot_of_q_dot_2_0);
    let u_dot_of_q_dot_2_16_1 = u_dot_of_q_dot_2_15_1
        .mul_add(d1_of_q_2_q_pin1_0, d1_of_q_2_q_pin1_1 * u_dot_of_q_dot_2_15_0);
    let u_dot_of_q_dot_2_17_1 = u_dot_of_q_dot_2_10_1
        .mul_add(cos_q_ground1_0, cos_q_ground1_1 * u_dot_of_q_dot_2_10_0);
    let u_dot_of_q_dot_2_18_1 = u_dot_of_q_dot_2_12_1 + u_dot_of_q_dot_2_16_1
        - u_dot_of_q_dot_2_14_1 - u_dot_of_q_dot_2_17_1;
    let u_dot_of_q_dot_2_19_1 = q_dot_2_sin_angle_inv_1
        .mul_add(cos_angle_0, cos_angle_1 * q_dot_2_sin_angle_inv_0);
    let u_dot_of_q_dot_2_20_1 = d1_of_place_32_1
        .mul_add(u_dot_of_q_dot_2_19_0, u_dot_of_q_dot_2_19_1 * d1_of_place_32_0);
    let u_dot_of_q_dot_2_21_1 = u_dot_of_q_dot_2_20_1
        .mul_add(u_dot_of_q_dot_2_3_0, u_dot_of_q_dot_2_3_1 * u_dot_of_q_dot_2_20_0);
    let u_dot_of_q_dot_2_22_1 = u_dot_of_q_dot_2_18_1
        .mul_add(
            q_dot_2_sin_angle_inv_0,
            q_dot_2_sin_angle_inv_1 * u_dot_of_q_dot_2_18_0,
        );
    let u_dot_of_q_dot_2_23_1 = u_dot_of_q_dot_2_1 + u_dot_of_q_dot_2_5_1;
    let u_dot_of_q_dot_2_24_1 = u_dot_of_q_dot_2_23_1
        .mul_add(
            cos_q_ground1_plus_q_pin2_0,
            cos_q_ground1_plus_q_pin2_1 * u_dot_of_q_dot_2_23_0,
        );
    let u_dot_of_q_dot_2_25_1 = u_dot_of_q_dot_2_23_1
        .mul_add(
            sin_q_ground1_plus_q_pin2_0,
            sin_q_ground1_plus_q_pin2_1 * u_dot_of_q_dot_2_23_0,
        );
    let u_dot_of_q_dot_2_26_1 = u_dot_of_q_dot_2_11_1 + u_dot_of_q_dot_2_24_1;
    let u_dot_of_place_22_1 = d1_of_place_4_1
        .mul_add(cos_q_ground2_0, cos_q_ground2_1 * d1_of_place_4_0);
    let u_dot_of_q_dot_2_27_1 = u_dot_of_q_dot_2_4_1
        .mul_add(u_dot_of_place_22_0, u_dot_of_place_22_1 * u_dot_of_q_dot_2_4_0);
    let u_dot_of_q_dot_2_28_1 = u_dot_of_q_dot_2_15_1 + u_dot_of_q_dot_2_25_1;
    let u_dot_of_q_dot_2_29_1 = u_dot_of_q_dot_2_28_1
        .mul_add(sin_q_ground2_0, sin_q_ground2_1 * u_dot_of_q_dot_2_28_0);
    let u_dot_of_place_23_1 = d1_of_place_3_1
        .mul_add(sin_q_ground2_0, sin_q_ground2_1 * d1_of_place_3_0);
    let u_dot_of_q_dot_2_30_1 = u_dot_of_q_dot_2_4_1
        .mul_add(u_dot_of_place_23_0, u_dot_of_place_23_1 * u_dot_of_q_dot_2_4_0);
    let u_dot_of_q_dot_2_31_1 = u_dot_of_q_dot_2_26_1
        .mul_add(cos_q_ground2_0, cos_q_ground2_1 * u_dot_of_q_dot_2_26_0);
    let u_dot_of_q_dot_2_32_1 = u_dot_of_q_dot_2_27_1 + u_dot_of_q_dot_2_30_1
        - u_dot_of_q_dot_2_29_1 - u_dot_of_q_dot_2_31_1;
    let u_dot_of_q_dot_2_33_1 = q_dot_2_sin_angle_inv_1
        * (q_dot_2_sin_angle_inv_0 + q_dot_2_sin_angle_inv_0);
    let u_dot_of_q_dot_2_34_1 = d1_of_place_16_1
        .mul_add(u_dot_of_q_dot_2_33_0, u_dot_of_q_dot_2_33_1 * d1_of_place_16_0);
    let u_dot_of_q_dot_2_35_1 = u_dot_of_q_dot_2_34_1
        .mul_add(d1_of_place_25_0, d1_of_place_25_1 * u_dot_of_q_dot_2_34_0);
    let u_dot_of_q_dot_2_36_1 = u_dot_of_q_dot_2_3_1
        .mul_add(
            sin_angle_inv_cos_angle_0,
            sin_angle_inv_cos_angle_1 * u_dot_of_q_dot_2_3_0,
        );
    let u_dot_of_q_dot_2_37_1 = u_dot_of_q_dot_2_36_1
        .mul_add(u_dot_of_q_dot_2_5_0, u_dot_of_q_dot_2_5_1 * u_dot_of_q_dot_2_36_0);
    let u_dot_of_q_dot_2_38_1 = u_dot_of_q_dot_2_5_1
        .mul_add(u_dot_of_place_9_0, u_dot_of_place_9_1 * u_dot_of_q_dot_2_5_0);
    let u_dot_of_q_dot_2_39_1 = u_dot_of_q_dot_2_38_1
        .mul_add(u_dot_of_q_dot_2_6_0, u_dot_of_q_dot_2_6_1 * u_dot_of_q_dot_2_38_0);
    let u_dot_of_q_dot_2_40_1 = sin_angle_2_1
        .mul_add(
            -(u_dot_of_q_dot_2_40_0 * over_sin_angle_2),
            u_dot_of_q_dot_2_1 * over_sin_angle_2,
        );
    let u_dot_of_q_dot_2_41_1 = u_dot_of_q_dot_2_32_1
        .mul_add(u_dot_of_q_dot_2_40_0, u_dot_of_q_dot_2_40_1 * u_dot_of_q_dot_2_32_0);
    let u_dot_of_q_dot_2_42_1 = u_dot_of_q_dot_2_35_1 - u_dot_of_q_dot_2_37_1
        - u_dot_of_q_dot_2_39_1 + u_dot_of_q_dot_2_41_1;
    let u_dot_of_motion_1 = S::int(2) * q_dot_2_1 + q_pin1_dot_1;
    let u_dot_of_motion_2_1 = u_dot_of_motion_1
        .mul_add(q_pin1_dot_0, q_pin1_dot_1 * u_dot_of_motion_0);
    let u_dot_of_motion_3_1 = u_dot_of_motion_2_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * u_dot_of_motion_2_0);
    let q_pin2_dot_sq_1 = q_pin2_dot_1 * (q_pin2_dot_0 + q_pin2_dot_0);
    let u_dot_of_motion_4_1 = d1_of_place_25_1
        .mul_add(q_ground1_dot_0, q_ground1_dot_1 * d1_of_place_25_0);
    let u_dot_of_motion_5_1 = S::int(2) * q_pin2_dot_1 - u_dot_of_motion_4_1;
    let u_dot_of_motion_6_1 = u_dot_of_motion_5_1
        .mul_add(q_ground1_dot_0, q_ground1_dot_1 * u_dot_of_motion_5_0);
    let u_dot_of_motion_7_1 = q_pin2_dot_sq_1 + u_dot_of_motion_6_1;
    let u_dot_of_motion_8_1 = u_dot_of_motion_7_1
        .mul_add(sin_q_pin2_0, sin_q_pin2_1 * u_dot_of_motion_7_0);
    let q_dot_2_sq_1 = q_dot_2_1 * (q_dot_2_0 + q_dot_2_0);
    let u_dot_of_q_dot_2_43_1 = d1_of_place_12_1
        .mul_add(q_dot_2_sq_0, q_dot_2_sq_1 * d1_of_place_12_0);
    let u_dot_of_place_24_1 = d1_of_place_25_1;
    let u_dot_of_place_25_1 = u_dot_of_place_24_1
        .mul_add(
            cos_q_ground1_plus_q_pin2_0,
            cos_q_ground1_plus_q_pin2_1 * u_dot_of_place_24_0,
        );
    let u_dot_of_place_26_1 = d1_of_place_29_1
        .mul_add(cos_q_ground2_0, cos_q_ground2_1 * d1_of_place_29_0);
    let u_dot_of_motion_9_1 = u_dot_of_motion_8_1
        .mul_add(
            l,
            u_dot_of_place_25_1
                .mul_add(
                    minus_g,
                    u_dot_of_q_dot_2_43_1
                        .mul_add(
                            minus_l,
                            u_dot_of_place_26_1
                                .mul_add(minus_g, minus_3_g * cos_q_ground1_1),
                        ),
                ),
        );
    let u_dot_of_motion_10_1 = u_dot_of_motion_9_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * u_dot_of_motion_9_0);
    let u_dot_of_place_27_1 = d1_of_place_12_1
        .mul_add(cos_q_plus_q_pin1_0, cos_q_plus_q_pin1_1 * d1_of_place_12_0);
    let u_dot_of_motion_11_1 = minus_g * u_dot_of_place_27_1 + u_dot_of_motion_10_1;
    let u_dot_of_motion_12_1 = sin_angle_1
        .mul_add(
            -(u_dot_of_motion_12_0 * over_sin_angle),
            u_dot_of_motion_11_1 * over_sin_angle,
        );
    let q_dot_2_sin_angle_inv2_1 = sin_angle_1
        .mul_add(
            -(q_dot_2_sin_angle_inv2_0 * over_sin_angle),
            q_dot_2_sin_angle_inv_1 * over_sin_angle,
        );
    let u_dot_of_q_dot_2_44_1 = q_dot_2_sin_angle_inv2_1
        .mul_add(u_dot_of_q_dot_2_0, u_dot_of_q_dot_2_1 * q_dot_2_sin_angle_inv2_0);
    let u_dot_of_q_dot_2_45_1 = d1_of_place_22_1
        .mul_add(u_dot_of_q_dot_2_44_0, u_dot_of_q_dot_2_44_1 * d1_of_place_22_0);
    let u_dot_of_q_dot_2_46_1 = u_dot_of_q_dot_2_45_1
        .mul_add(u_dot_of_place_5_0, u_dot_of_place_5_1 * u_dot_of_q_dot_2_45_0);
    let u_dot_of_place_28_1 = sin_angle_2_1
        .mul_add(
            -(u_dot_of_place_28_0 * over_sin_angle_2),
            u_dot_of_place_21_1 * over_sin_angle_2,
        );
    let u_dot_of_q_dot_2_47_1 = u_dot_of_q_dot_2_4_1
        .mul_add(
            q_dot_2_sin_angle_inv2_0,
            q_dot_2_sin_angle_inv2_1 * u_dot_of_q_dot_2_4_0,
        );
    let u_dot_of_q_dot_2_48_1 = u_dot_of_place_28_1
        .mul_add(u_dot_of_q_dot_2_47_0, u_dot_of_q_dot_2_47_1 * u_dot_of_place_28_0);
    let u_dot_of_q_dot_2_49_1 = u_dot_of_q_dot_2_21_1 - u_dot_of_q_dot_2_22_1;
    let u_dot_of_q_dot_2_50_1 = u_dot_of_q_dot_2_49_1
        .mul_add(d1_of_place_33_0, d1_of_place_33_1 * u_dot_of_q_dot_2_49_0);
    let u_dot_of_place_29_1 = d1_of_place_26_1
        .mul_add(
            sin_q_pin1_sin_angle_inv_0,
            sin_q_pin1_sin_angle_inv_1 * d1_of_place_26_0,
        );
    let u_dot_of_q_dot_2_51_1 = u_dot_of_q_dot_2_42_1
        .mul_add(u_dot_of_place_29_0, u_dot_of_place_29_1 * u_dot_of_q_dot_2_42_0);
    let u_dot_of_motion_13_1 = u_dot_of_q_dot_2_48_1
        .mul_add(
            minus_2_m_l_2,
            u_dot_of_q_dot_2_51_1
                .mul_add(
                    minus_m_l_2,
                    u_dot_of_motion_12_1
                        .mul_add(
                            weight_3,
                            u_dot_of_q_dot_2_50_1
                                .mul_add(
                                    minus_m_l_2,
                                    u_dot_of_q_dot_2_46_1
                                        .mul_add(
                                            minus_m_l_2,
                                            u_dot_of_motion_3_1
                                                .mul_add(
                                                    weight_2,
                                                    cos_q_plus_q_pin1_1
                                                        .mul_add(minus_3_m_l_g, minus_9_m_l_g * cos_q_1),
                                                ),
                                        ),
                                ),
                        ),
                ),
        );
    let u_dot_of_motion_14_1 = d1_of_place_37_1
        .mul_add(
            -(u_dot_of_motion_14_0 * over_d1_of_place_37),
            u_dot_of_motion_13_1 * over_d1_of_place_37,
        );
    let q_ground1_ddot_of_q_dot_2_1 = u_dot_of_place_5_1
        .mul_add(u_dot_of_q_dot_2_33_0, u_dot_of_q_dot_2_33_1 * u_dot_of_place_5_0);
    let q_ground1_ddot_of_motion_1 = u_dot_of_motion_14_1
        .mul_add(
            sin_q_pin1_sin_angle_inv_0,
            sin_q_pin1_sin_angle_inv_1 * u_dot_of_motion_14_0,
        );
    let q_ground1_dot_dot_1 = q_ground1_ddot_of_motion_1
        .mul_add(S::ratio(1, 6), q_ground1_ddot_of_q_dot_2_1);
    let q_ground2_ddot_of_q_dot_2_1 = u_dot_of_place_28_1
        .mul_add(u_dot_of_q_dot_2_33_0, u_dot_of_q_dot_2_33_1 * u_dot_of_place_28_0);
    let q_ground2_ddot_of_motion_1 = q_ground1_ddot_of_motion_1
        .mul_add(d1_of_place_29_0, d1_of_place_29_1 * q_ground1_ddot_of_motion_0);
    let q_ground2_dot_dot_1 = q_ground2_ddot_of_motion_1
        .mul_add(S::ratio(1, 6), q_ground2_ddot_of_q_dot_2_1);
    let q_pin1_ddot_of_motion_1 = u_dot_of_motion_14_1
        .mul_add(d1_of_place_32_0, d1_of_place_32_1 * u_dot_of_motion_14_0);
    let q_pin1_dot_dot_1 = q_pin1_ddot_of_motion_1
        .mul_add(S::ratio(1, 6), -u_dot_of_q_dot_2_21_1 + u_dot_of_q_dot_2_22_1);
    let q_pin2_ddot_of_motion_1 = q_ground1_ddot_of_motion_1
        .mul_add(d1_of_place_25_0, d1_of_place_25_1 * q_ground1_ddot_of_motion_0);
    let q_pin2_dot_dot_1 = q_pin2_ddot_of_motion_1
        .mul_add(
            S::ratio(1, 6),
            u_dot_of_q_dot_2_35_1 - u_dot_of_q_dot_2_37_1 - u_dot_of_q_dot_2_39_1
                + u_dot_of_q_dot_2_41_1,
        );
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                q_pin1_1, q_pin1_1, q_pin2_1, q_pin2_1, q_2_1, q_2_1, q_ground1_1, q_ground1_1,
                q_2_plus_q_pin1_1, q_2_plus_q_pin1_1, d1_of_place_1, d1_of_place_1, q_ground2_1,
                q_ground2_1, q_ground1_plus_q_pin2_1, q_ground1_plus_q_pin2_1, d1_of_place_2_1,
                d1_of_place_2_1, sin_q_1, cos_q_1, sin_q_pin1_1, sin_q_1, cos_q_1, cos_q_pin1_1,
                sin_q_ground1_1, cos_q_ground1_1, sin_q_ground2_1, cos_q_ground2_1, cos_q_pin1_1,
                sin_angle_1, cos_q_pin2_1, sin_angle_2_1, cos_q_pin1_1, sin_angle_2_1, sin_angle_1,
                sin_q_pin1_sin_angle_inv_1, d1_of_place_22_1, sin_angle_2_1, d1_of_place_29_1,
                d1_of_place_27_1, sin_angle_1, d1_of_place_9_1, d1_of_place_32_1, d1_of_place_25_1,
                d1_of_place_26_1, q_dot_2_1, q_dot_2_1, q_dot_2_1, sin_angle_1, d1_of_place_12_1,
                sin_angle_1, sin_q_pin1_1, u_dot_of_place_3_1, u_dot_of_q_dot_2_1,
                u_dot_of_q_dot_2_1, sin_angle_2_1, sin_angle_2_1, u_dot_of_place_8_1, sin_angle_1,
                sin_q_pin1_1, cos_angle_1, sin_q_pin2_1, sin_q_pin1_1, d1_of_place_25_1,
                sin_q_pin1_1, sin_q_pin2_1, cos_q_plus_q_pin1_1, sin_q_plus_q_pin1_1,
                cos_q_ground1_1, d1_of_q_2_q_pin1_2_1, sin_q_ground1_1, sin_q_ground1_1,
                d1_of_q_2_q_pin1_1, cos_q_ground1_1, cos_angle_1, d1_of_place_32_1,
                u_dot_of_q_dot_2_3_1, u_dot_of_q_dot_2_18_1, cos_q_ground1_plus_q_pin2_1,
                sin_q_ground1_plus_q_pin2_1, cos_q_ground2_1, u_dot_of_q_dot_2_4_1, sin_q_ground2_1,
                sin_q_ground2_1, u_dot_of_q_dot_2_4_1, cos_q_ground2_1, q_dot_2_sin_angle_inv_1,
                d1_of_place_16_1, d1_of_place_25_1, u_dot_of_q_dot_2_3_1, u_dot_of_q_dot_2_5_1,
                u_dot_of_q_dot_2_5_1, u_dot_of_q_dot_2_6_1, sin_angle_2_1, u_dot_of_q_dot_2_32_1,
                q_pin1_dot_1, sin_q_pin1_1, q_pin2_dot_1, q_ground1_dot_1, q_ground1_dot_1,
                sin_q_pin2_1, q_dot_2_1, d1_of_place_12_1, cos_q_ground1_plus_q_pin2_1,
                cos_q_ground2_1, sin_q_pin1_1, cos_q_plus_q_pin1_1, sin_angle_1, sin_angle_1,
                u_dot_of_q_dot_2_1, d1_of_place_22_1, u_dot_of_place_5_1, sin_angle_2_1,
                u_dot_of_q_dot_2_4_1, u_dot_of_place_28_1, u_dot_of_q_dot_2_49_1, d1_of_place_26_1,
                u_dot_of_q_dot_2_42_1, d1_of_place_37_1, u_dot_of_place_5_1, u_dot_of_motion_14_1,
                u_dot_of_q_dot_2_33_1, d1_of_place_29_1, u_dot_of_motion_14_1, d1_of_place_25_1,
            ]),
            padded([
                cos_q_pin1_1, sin_q_pin1_1, cos_q_pin2_1, sin_q_pin2_1, cos_q_1, sin_q_1,
                cos_q_ground1_1, sin_q_ground1_1, cos_q_plus_q_pin1_1, sin_q_plus_q_pin1_1,
                cos_angle_1, sin_angle_1, cos_q_ground2_1, sin_q_ground2_1,
                cos_q_ground1_plus_q_pin2_1, sin_q_ground1_plus_q_pin2_1, cos_angle_2_1,
                sin_angle_2_1, sin_q_ground1_1, cos_q_ground1_1, d1_of_place_5_1, cos_q_ground1_1,
                sin_q_ground1_1, d1_of_place_7_1, d1_of_q_2_q_pin1_2_1, d1_of_q_2_q_pin1_1,
                d1_of_place_4_1, d1_of_place_3_1, d1_of_place_12_1, d1_of_place_18_1,
                d1_of_place_15_1, d1_of_place_21_1, d1_of_place_9_1, d1_of_place_25_1,
                sin_q_pin1_sin_angle_inv_1, sin_q_pin1_sin_angle_inv_1, d1_of_place_27_1,
                d1_of_place_29_1, d1_of_place_29_1, d1_of_place_30_1, d1_of_place_32_1,
                d1_of_place_33_1, d1_of_place_33_1, d1_of_place_27_1, d1_of_place_35_1, sin_q_1,
                cos_q_1, sin_q_pin1_sin_angle_inv_1, q_dot_2_sin_angle_inv_1,
                q_dot_2_sin_angle_inv_1, u_dot_of_place_2_1, cos_angle_1, sin_q_pin1_cos_angle_1,
                d1_of_place_29_1, d1_of_place_25_1, u_dot_of_place_7_1, u_dot_of_place_9_1,
                u_dot_of_place_9_1, sin_angle_inv_cos_angle_1, u_dot_of_place_11_1,
                u_dot_of_place_13_1, u_dot_of_place_15_1, cos_q_pin2_1, sin_q_pin1_cos_q_pin2_1,
                u_dot_of_place_18_1, d1_of_place_16_1, u_dot_of_q_dot_2_7_1, u_dot_of_q_dot_2_7_1,
                u_dot_of_q_dot_2_1, u_dot_of_q_dot_2_11_1, u_dot_of_q_dot_2_13_1,
                u_dot_of_q_dot_2_1, u_dot_of_q_dot_2_15_1, u_dot_of_q_dot_2_10_1,
                q_dot_2_sin_angle_inv_1, u_dot_of_q_dot_2_19_1, u_dot_of_q_dot_2_20_1,
                q_dot_2_sin_angle_inv_1, u_dot_of_q_dot_2_23_1, u_dot_of_q_dot_2_23_1,
                d1_of_place_4_1, u_dot_of_place_22_1, u_dot_of_q_dot_2_28_1, d1_of_place_3_1,
                u_dot_of_place_23_1, u_dot_of_q_dot_2_26_1, q_dot_2_sin_angle_inv_1,
                u_dot_of_q_dot_2_33_1, u_dot_of_q_dot_2_34_1, sin_angle_inv_cos_angle_1,
                u_dot_of_q_dot_2_36_1, u_dot_of_place_9_1, u_dot_of_q_dot_2_38_1,
                u_dot_of_q_dot_2_40_1, u_dot_of_q_dot_2_40_1, u_dot_of_motion_1,
                u_dot_of_motion_2_1, q_pin2_dot_1, d1_of_place_25_1, u_dot_of_motion_5_1,
                u_dot_of_motion_7_1, q_dot_2_1, q_dot_2_sq_1, u_dot_of_place_24_1, d1_of_place_29_1,
                u_dot_of_motion_9_1, d1_of_place_12_1, u_dot_of_motion_12_1,
                q_dot_2_sin_angle_inv2_1, q_dot_2_sin_angle_inv2_1, u_dot_of_q_dot_2_44_1,
                u_dot_of_q_dot_2_45_1, u_dot_of_place_28_1, q_dot_2_sin_angle_inv2_1,
                u_dot_of_q_dot_2_47_1, d1_of_place_33_1, sin_q_pin1_sin_angle_inv_1,
                u_dot_of_place_29_1, u_dot_of_motion_14_1, u_dot_of_q_dot_2_33_1,
                sin_q_pin1_sin_angle_inv_1, u_dot_of_place_28_1, q_ground1_ddot_of_motion_1,
                d1_of_place_32_1, q_ground1_ddot_of_motion_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q_2_last = q_2_1;
    let mut q_ground1_last = q_ground1_1;
    let mut q_ground2_last = q_ground2_1;
    let mut q_pin1_last = q_pin1_1;
    let mut q_pin2_last = q_pin2_1;
    let mut q_dot_2_last = q_dot_2_1;
    let mut q_ground1_dot_last = q_ground1_dot_1;
    let mut q_pin1_dot_last = q_pin1_dot_1;
    let mut q_pin2_dot_last = q_pin2_dot_1;
    let mut sin_q_pin1_last = sin_q_pin1_1;
    let mut cos_q_pin1_last = cos_q_pin1_1;
    let mut sin_q_pin2_last = sin_q_pin2_1;
    let mut cos_q_pin2_last = cos_q_pin2_1;
    let mut sin_q_last = sin_q_1;
    let mut cos_q_last = cos_q_1;
    let mut sin_q_ground1_last = sin_q_ground1_1;
    let mut cos_q_ground1_last = cos_q_ground1_1;
    let mut q_2_plus_q_pin1_last = q_2_plus_q_pin1_1;
    let mut sin_q_plus_q_pin1_last = sin_q_plus_q_pin1_1;
    let mut cos_q_plus_q_pin1_last = cos_q_plus_q_pin1_1;
    let mut d1_of_place_last = d1_of_place_1;
    let mut sin_angle_last = sin_angle_1;
    let mut cos_angle_last = cos_angle_1;
    let mut sin_q_ground2_last = sin_q_ground2_1;
    let mut cos_q_ground2_last = cos_q_ground2_1;
    let mut q_ground1_plus_q_pin2_last = q_ground1_plus_q_pin2_1;
    let mut sin_q_ground1_plus_q_pin2_last = sin_q_ground1_plus_q_pin2_1;
    let mut cos_q_ground1_plus_q_pin2_last = cos_q_ground1_plus_q_pin2_1;
    let mut d1_of_place_2_last = d1_of_place_2_1;
    let mut sin_angle_2_last = sin_angle_2_1;
    let mut cos_angle_2_last = cos_angle_2_1;
    let mut d1_of_q_2_q_pin1_last = d1_of_q_2_q_pin1_1;
    let mut d1_of_q_2_q_pin1_2_last = d1_of_q_2_q_pin1_2_1;
    let mut d1_of_place_3_last = d1_of_place_3_1;
    let mut d1_of_place_4_last = d1_of_place_4_1;
    let mut d1_of_place_5_last = d1_of_place_5_1;
    let mut d1_of_place_7_last = d1_of_place_7_1;
    let mut d1_of_place_9_last = d1_of_place_9_1;
    let mut d1_of_place_12_last = d1_of_place_12_1;
    let mut d1_of_place_15_last = d1_of_place_15_1;
    let mut d1_of_place_16_last = d1_of_place_16_1;
    let mut d1_of_place_18_last = d1_of_place_18_1;
    let mut d1_of_place_21_last = d1_of_place_21_1;
    let mut d1_of_place_22_last = d1_of_place_22_1;
    let mut d1_of_place_25_last = d1_of_place_25_1;
    let mut d1_of_place_26_last = d1_of_place_26_1;
    let mut sin_q_pin1_sin_angle_inv_last = sin_q_pin1_sin_angle_inv_1;
    let mut d1_of_place_27_last = d1_of_place_27_1;
    let mut d1_of_place_29_last = d1_of_place_29_1;
    let mut d1_of_place_30_last = d1_of_place_30_1;
    let mut d1_of_place_32_last = d1_of_place_32_1;
    let mut d1_of_place_33_last = d1_of_place_33_1;
    let mut d1_of_place_35_last = d1_of_place_35_1;
    let mut d1_of_place_37_last = d1_of_place_37_1;
    let mut u_dot_of_q_dot_2_last = u_dot_of_q_dot_2_1;
    let mut q_dot_2_sin_angle_inv_last = q_dot_2_sin_angle_inv_1;
    let mut u_dot_of_q_dot_2_3_last = u_dot_of_q_dot_2_3_1;
    let mut u_dot_of_place_2_last = u_dot_of_place_2_1;
    let mut u_dot_of_place_3_last = u_dot_of_place_3_1;
    let mut sin_q_pin1_cos_angle_last = sin_q_pin1_cos_angle_1;
    let mut u_dot_of_place_5_last = u_dot_of_place_5_1;
    let mut u_dot_of_q_dot_2_4_last = u_dot_of_q_dot_2_4_1;
    let mut u_dot_of_q_dot_2_5_last = u_dot_of_q_dot_2_5_1;
    let mut u_dot_of_q_dot_2_6_last = u_dot_of_q_dot_2_6_1;
    let mut u_dot_of_place_7_last = u_dot_of_place_7_1;
    let mut u_dot_of_place_8_last = u_dot_of_place_8_1;
    let mut u_dot_of_place_9_last = u_dot_of_place_9_1;
    let mut sin_angle_inv_cos_angle_last = sin_angle_inv_cos_angle_1;
    let mut u_dot_of_place_11_last = u_dot_of_place_11_1;
    let mut u_dot_of_place_13_last = u_dot_of_place_13_1;
    let mut u_dot_of_place_15_last = u_dot_of_place_15_1;
    let mut sin_q_pin1_cos_q_pin2_last = sin_q_pin1_cos_q_pin2_1;
    let mut u_dot_of_place_18_last = u_dot_of_place_18_1;
    let mut u_dot_of_q_dot_2_7_last = u_dot_of_q_dot_2_7_1;
    let mut u_dot_of_q_dot_2_10_last = u_dot_of_q_dot_2_10_1;
    let mut u_dot_of_q_dot_2_11_last = u_dot_of_q_dot_2_11_1;
    let mut u_dot_of_q_dot_2_13_last = u_dot_of_q_dot_2_13_1;
    let mut u_dot_of_q_dot_2_15_last = u_dot_of_q_dot_2_15_1;
    let mut u_dot_of_q_dot_2_18_last = u_dot_of_q_dot_2_18_1;
    let mut u_dot_of_q_dot_2_19_last = u_dot_of_q_dot_2_19_1;
    let mut u_dot_of_q_dot_2_20_last = u_dot_of_q_dot_2_20_1;
    let mut u_dot_of_q_dot_2_23_last = u_dot_of_q_dot_2_23_1;
    let mut u_dot_of_q_dot_2_26_last = u_dot_of_q_dot_2_26_1;
    let mut u_dot_of_place_22_last = u_dot_of_place_22_1;
    let mut u_dot_of_q_dot_2_28_last = u_dot_of_q_dot_2_28_1;
    let mut u_dot_of_place_23_last = u_dot_of_place_23_1;
    let mut u_dot_of_q_dot_2_32_last = u_dot_of_q_dot_2_32_1;
    let mut u_dot_of_q_dot_2_33_last = u_dot_of_q_dot_2_33_1;
    let mut u_dot_of_q_dot_2_34_last = u_dot_of_q_dot_2_34_1;
    let mut u_dot_of_q_dot_2_36_last = u_dot_of_q_dot_2_36_1;
    let mut u_dot_of_q_dot_2_38_last = u_dot_of_q_dot_2_38_1;
    let mut u_dot_of_q_dot_2_40_last = u_dot_of_q_dot_2_40_1;
    let mut u_dot_of_q_dot_2_42_last = u_dot_of_q_dot_2_42_1;
    let mut u_dot_of_motion_last = u_dot_of_motion_1;
    let mut u_dot_of_motion_2_last = u_dot_of_motion_2_1;
    let mut u_dot_of_motion_5_last = u_dot_of_motion_5_1;
    let mut u_dot_of_motion_7_last = u_dot_of_motion_7_1;
    let mut q_dot_2_sq_last = q_dot_2_sq_1;
    let mut u_dot_of_place_24_last = u_dot_of_place_24_1;
    let mut u_dot_of_motion_9_last = u_dot_of_motion_9_1;
    let mut u_dot_of_motion_12_last = u_dot_of_motion_12_1;
    let mut q_dot_2_sin_angle_inv2_last = q_dot_2_sin_angle_inv2_1;
    let mut u_dot_of_q_dot_2_44_last = u_dot_of_q_dot_2_44_1;
    let mut u_dot_of_q_dot_2_45_last = u_dot_of_q_dot_2_45_1;
    let mut u_dot_of_place_28_last = u_dot_of_place_28_1;
    let mut u_dot_of_q_dot_2_47_last = u_dot_of_q_dot_2_47_1;
    let mut u_dot_of_q_dot_2_49_last = u_dot_of_q_dot_2_49_1;
    let mut u_dot_of_place_29_last = u_dot_of_place_29_1;
    let mut u_dot_of_motion_14_last = u_dot_of_motion_14_1;
    let mut q_ground1_ddot_of_motion_last = q_ground1_ddot_of_motion_1;
    let mut next = [S::int(0); 128];
    // Rates at order k - 1.
    let mut q_2_rate = q_dot_2_1;
    let mut q_ground1_rate = q_ground1_dot_1;
    let mut q_ground2_rate = q_ground2_dot_1;
    let mut q_pin1_rate = q_pin1_dot_1;
    let mut q_pin2_rate = q_pin2_dot_1;
    let mut q_dot_2_rate = S::ratio(1, 6) * u_dot_of_motion_14_1;
    let mut q_ground1_dot_rate = q_ground1_dot_dot_1;
    let mut q_ground2_dot_rate = q_ground2_dot_dot_1;
    let mut q_pin1_dot_rate = q_pin1_dot_dot_1;
    let mut q_pin2_dot_rate = q_pin2_dot_dot_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q_2 = q_2_rate * over_k;
        let q_ground1 = q_ground1_rate * over_k;
        let q_ground2 = q_ground2_rate * over_k;
        let q_pin1 = q_pin1_rate * over_k;
        let q_pin2 = q_pin2_rate * over_k;
        let q_dot_2 = q_dot_2_rate * over_k;
        let q_ground1_dot = q_ground1_dot_rate * over_k;
        let q_ground2_dot = q_ground2_dot_rate * over_k;
        let q_pin1_dot = q_pin1_dot_rate * over_k;
        let q_pin2_dot = q_pin2_dot_rate * over_k;
        series[order] = [
            q_2, q_ground1, q_ground2, q_pin1, q_pin2, q_dot_2, q_ground1_dot, q_ground2_dot,
            q_pin1_dot, q_pin2_dot,
        ];
        if order + 1 == series.len() {
            break;
        }
        let count = S::int(order as i64);
        let sums = if order % 2 == 0 {
            // All convolutions of order k, and of order k + 1 but for the terms with coefficients of order
            //   k.
            let pair = pair_sums(&history[..order]);
            next = pair[1];
            pair[0]
        } else {
            // Those terms, which also have coefficients of order 1.
            padded([
                q_pin1_1
                    .mul_add(
                        cos_q_pin1_last,
                        (count_last * q_pin1_last).mul_add(cos_q_pin1_1, next[0]),
                    ),
                q_pin1_1
                    .mul_add(
                        sin_q_pin1_last,
                        (count_last * q_pin1_last).mul_add(sin_q_pin1_1, next[1]),
                    ),
                q_pin2_1
                    .mul_add(
                        cos_q_pin2_last,
                        (count_last * q_pin2_last).mul_add(cos_q_pin2_1, next[2]),
                    ),
                q_pin2_1
                    .mul_add(
                        sin_q_pin2_last,
                        (count_last * q_pin2_last).mul_add(sin_q_pin2_1, next[3]),
                    ),
                q_2_1
                    .mul_add(
                        cos_q_last,
                        (count_last * q_2_last).mul_add(cos_q_1, next[4]),
                    ),
                q_2_1
                    .mul_add(
                        sin_q_last,
                        (count_last * q_2_last).mul_add(sin_q_1, next[5]),
                    ),
                q_ground1_1
                    .mul_add(
                        cos_q_ground1_last,
                        (count_last * q_ground1_last).mul_add(cos_q_ground1_1, next[6]),
                    ),
                q_ground1_1
                    .mul_add(
                        sin_q_ground1_last,
                        (count_last * q_ground1_last).mul_add(sin_q_ground1_1, next[7]),
                    ),
                q_2_plus_q_pin1_1
                    .mul_add(
                        cos_q_plus_q_pin1_last,
                        (count_last * q_2_plus_q_pin1_last)
                            .mul_add(cos_q_plus_q_pin1_1, next[8]),
                    ),
                q_2_plus_q_pin1_1
                    .mul_add(
                        sin_q_plus_q_pin1_last,
                        (count_last * q_2_plus_q_pin1_last)
                            .mul_add(sin_q_plus_q_pin1_1, next[9]),
                    ),
                d1_of_place_1
                    .mul_add(
                        cos_angle_last,
                        (count_last * d1_of_place_last).mul_add(cos_angle_1, next[10]),
                    ),
                d1_of_place_1
                    .mul_add(
                        sin_angle_last,
                        (count_last * d1_of_place_last).mul_add(sin_angle_1, next[11]),
                    ),
                q_ground2_1
                    .mul_add(
                        cos_q_ground2_last,
                        (count_last * q_ground2_last).mul_add(cos_q_ground2_1, next[12]),
                    ),
                q_ground2_1
                    .mul_add(
                        sin_q_ground2_last,
                        (count_last * q_ground2_last).mul_add(sin_q_ground2_1, next[13]),
                    ),
                q_ground1_plus_q_pin2_1
                    .mul_add(
                        cos_q_ground1_plus_q_pin2_last,
                        (count_last * q_ground1_plus_q_pin2_last)
                            .mul_add(cos_q_ground1_plus_q_pin2_1, next[14]),
                    ),
                q_ground1_plus_q_pin2_1
                    .mul_add(
                        sin_q_ground1_plus_q_pin2_last,
                        (count_last * q_ground1_plus_q_pin2_last)
                            .mul_add(sin_q_ground1_plus_q_pin2_1, next[15]),
                    ),
                d1_of_place_2_1
                    .mul_add(
                        cos_angle_2_last,
                        (count_last * d1_of_place_2_last)
                            .mul_add(cos_angle_2_1, next[16]),
                    ),
                d1_of_place_2_1
                    .mul_add(
                        sin_angle_2_last,
                        (count_last * d1_of_place_2_last)
                            .mul_add(sin_angle_2_1, next[17]),
                    ),
                sin_q_1
                    .mul_add(
                        sin_q_ground1_last,
                        sin_q_last.mul_add(sin_q_ground1_1, next[18]),
                    ),
                cos_q_1
                    .mul_add(
                        cos_q_ground1_last,
                        cos_q_last.mul_add(cos_q_ground1_1, next[19]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        d1_of_place_5_last,
                        sin_q_pin1_last.mul_add(d1_of_place_5_1, next[20]),
                    ),
                sin_q_1
                    .mul_add(
                        cos_q_ground1_last,
                        sin_q_last.mul_add(cos_q_ground1_1, next[21]),
                    ),
                cos_q_1
                    .mul_add(
                        sin_q_ground1_last,
                        cos_q_last.mul_add(sin_q_ground1_1, next[22]),
                    ),
                cos_q_pin1_1
                    .mul_add(
                        d1_of_place_7_last,
                        cos_q_pin1_last.mul_add(d1_of_place_7_1, next[23]),
                    ),
                sin_q_ground1_1
                    .mul_add(
                        d1_of_q_2_q_pin1_2_last,
                        sin_q_ground1_last.mul_add(d1_of_q_2_q_pin1_2_1, next[24]),
                    ),
                cos_q_ground1_1
                    .mul_add(
                        d1_of_q_2_q_pin1_last,
                        cos_q_ground1_last.mul_add(d1_of_q_2_q_pin1_1, next[25]),
                    ),
                sin_q_ground2_1
                    .mul_add(
                        d1_of_place_4_last,
                        sin_q_ground2_last.mul_add(d1_of_place_4_1, next[26]),
                    ),
                cos_q_ground2_1
                    .mul_add(
                        d1_of_place_3_last,
                        cos_q_ground2_last.mul_add(d1_of_place_3_1, next[27]),
                    ),
                cos_q_pin1_1
                    .mul_add(
                        d1_of_place_12_last,
                        cos_q_pin1_last.mul_add(d1_of_place_12_1, next[28]),
                    ),
                sin_angle_1
                    .mul_add(
                        d1_of_place_18_last,
                        sin_angle_last.mul_add(d1_of_place_18_1, next[29]),
                    ),
                cos_q_pin2_1
                    .mul_add(
                        d1_of_place_15_last,
                        cos_q_pin2_last.mul_add(d1_of_place_15_1, next[30]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        d1_of_place_21_last,
                        sin_angle_2_last.mul_add(d1_of_place_21_1, next[31]),
                    ),
                cos_q_pin1_1
                    .mul_add(
                        d1_of_place_9_last,
                        cos_q_pin1_last.mul_add(d1_of_place_9_1, next[32]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        d1_of_place_25_last,
                        sin_angle_2_last.mul_add(d1_of_place_25_1, next[33]),
                    ),
                sin_angle_1
                    .mul_add(
                        sin_q_pin1_sin_angle_inv_last,
                        sin_angle_last.mul_add(sin_q_pin1_sin_angle_inv_1, next[34]),
                    ),
                (sin_q_pin1_sin_angle_inv_1 + sin_q_pin1_sin_angle_inv_1)
                    .mul_add(sin_q_pin1_sin_angle_inv_last, next[35]),
                d1_of_place_22_1
                    .mul_add(
                        d1_of_place_27_last,
                        d1_of_place_22_last.mul_add(d1_of_place_27_1, next[36]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        d1_of_place_29_last,
                        sin_angle_2_last.mul_add(d1_of_place_29_1, next[37]),
                    ),
                (d1_of_place_29_1 + d1_of_place_29_1)
                    .mul_add(d1_of_place_29_last, next[38]),
                d1_of_place_27_1
                    .mul_add(
                        d1_of_place_30_last,
                        d1_of_place_27_last.mul_add(d1_of_place_30_1, next[39]),
                    ),
                sin_angle_1
                    .mul_add(
                        d1_of_place_32_last,
                        sin_angle_last.mul_add(d1_of_place_32_1, next[40]),
                    ),
                d1_of_place_9_1
                    .mul_add(
                        d1_of_place_33_last,
                        d1_of_place_9_last.mul_add(d1_of_place_33_1, next[41]),
                    ),
                d1_of_place_32_1
                    .mul_add(
                        d1_of_place_33_last,
                        d1_of_place_32_last.mul_add(d1_of_place_33_1, next[42]),
                    ),
                d1_of_place_25_1
                    .mul_add(
                        d1_of_place_27_last,
                        d1_of_place_25_last.mul_add(d1_of_place_27_1, next[43]),
                    ),
                d1_of_place_26_1
                    .mul_add(
                        d1_of_place_35_last,
                        d1_of_place_26_last.mul_add(d1_of_place_35_1, next[44]),
                    ),
                q_dot_2_1.mul_add(sin_q_last, q_dot_2_last.mul_add(sin_q_1, next[45])),
                q_dot_2_1.mul_add(cos_q_last, q_dot_2_last.mul_add(cos_q_1, next[46])),
                q_dot_2_1
                    .mul_add(
                        sin_q_pin1_sin_angle_inv_last,
                        q_dot_2_last.mul_add(sin_q_pin1_sin_angle_inv_1, next[47]),
                    ),
                sin_angle_1
                    .mul_add(
                        q_dot_2_sin_angle_inv_last,
                        sin_angle_last.mul_add(q_dot_2_sin_angle_inv_1, next[48]),
                    ),
                d1_of_place_12_1
                    .mul_add(
                        q_dot_2_sin_angle_inv_last,
                        d1_of_place_12_last.mul_add(q_dot_2_sin_angle_inv_1, next[49]),
                    ),
                sin_angle_1
                    .mul_add(
                        u_dot_of_place_2_last,
                        sin_angle_last.mul_add(u_dot_of_place_2_1, next[50]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        cos_angle_last,
                        sin_q_pin1_last.mul_add(cos_angle_1, next[51]),
                    ),
                u_dot_of_place_3_1
                    .mul_add(
                        sin_q_pin1_cos_angle_last,
                        u_dot_of_place_3_last.mul_add(sin_q_pin1_cos_angle_1, next[52]),
                    ),
                u_dot_of_q_dot_2_1
                    .mul_add(
                        d1_of_place_29_last,
                        u_dot_of_q_dot_2_last.mul_add(d1_of_place_29_1, next[53]),
                    ),
                u_dot_of_q_dot_2_1
                    .mul_add(
                        d1_of_place_25_last,
                        u_dot_of_q_dot_2_last.mul_add(d1_of_place_25_1, next[54]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        u_dot_of_place_7_last,
                        sin_angle_2_last.mul_add(u_dot_of_place_7_1, next[55]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        u_dot_of_place_9_last,
                        sin_angle_2_last.mul_add(u_dot_of_place_9_1, next[56]),
                    ),
                u_dot_of_place_8_1
                    .mul_add(
                        u_dot_of_place_9_last,
                        u_dot_of_place_8_last.mul_add(u_dot_of_place_9_1, next[57]),
                    ),
                sin_angle_1
                    .mul_add(
                        sin_angle_inv_cos_angle_last,
                        sin_angle_last.mul_add(sin_angle_inv_cos_angle_1, next[58]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        u_dot_of_place_11_last,
                        sin_q_pin1_last.mul_add(u_dot_of_place_11_1, next[59]),
                    ),
                cos_angle_1
                    .mul_add(
                        u_dot_of_place_13_last,
                        cos_angle_last.mul_add(u_dot_of_place_13_1, next[60]),
                    ),
                sin_q_pin2_1
                    .mul_add(
                        u_dot_of_place_15_last,
                        sin_q_pin2_last.mul_add(u_dot_of_place_15_1, next[61]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        cos_q_pin2_last,
                        sin_q_pin1_last.mul_add(cos_q_pin2_1, next[62]),
                    ),
                d1_of_place_25_1
                    .mul_add(
                        sin_q_pin1_cos_q_pin2_last,
                        d1_of_place_25_last.mul_add(sin_q_pin1_cos_q_pin2_1, next[63]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        u_dot_of_place_18_last,
                        sin_q_pin1_last.mul_add(u_dot_of_place_18_1, next[64]),
                    ),
                sin_q_pin2_1
                    .mul_add(
                        d1_of_place_16_last,
                        sin_q_pin2_last.mul_add(d1_of_place_16_1, next[65]),
                    ),
                cos_q_plus_q_pin1_1
                    .mul_add(
                        u_dot_of_q_dot_2_7_last,
                        cos_q_plus_q_pin1_last.mul_add(u_dot_of_q_dot_2_7_1, next[66]),
                    ),
                sin_q_plus_q_pin1_1
                    .mul_add(
                        u_dot_of_q_dot_2_7_last,
                        sin_q_plus_q_pin1_last.mul_add(u_dot_of_q_dot_2_7_1, next[67]),
                    ),
                cos_q_ground1_1
                    .mul_add(
                        u_dot_of_q_dot_2_last,
                        cos_q_ground1_last.mul_add(u_dot_of_q_dot_2_1, next[68]),
                    ),
                d1_of_q_2_q_pin1_2_1
                    .mul_add(
                        u_dot_of_q_dot_2_11_last,
                        d1_of_q_2_q_pin1_2_last.mul_add(u_dot_of_q_dot_2_11_1, next[69]),
                    ),
                sin_q_ground1_1
                    .mul_add(
                        u_dot_of_q_dot_2_13_last,
                        sin_q_ground1_last.mul_add(u_dot_of_q_dot_2_13_1, next[70]),
                    ),
                sin_q_ground1_1
                    .mul_add(
                        u_dot_of_q_dot_2_last,
                        sin_q_ground1_last.mul_add(u_dot_of_q_dot_2_1, next[71]),
                    ),
                d1_of_q_2_q_pin1_1
                    .mul_add(
                        u_dot_of_q_dot_2_15_last,
                        d1_of_q_2_q_pin1_last.mul_add(u_dot_of_q_dot_2_15_1, next[72]),
                    ),
                cos_q_ground1_1
                    .mul_add(
                        u_dot_of_q_dot_2_10_last,
                        cos_q_ground1_last.mul_add(u_dot_of_q_dot_2_10_1, next[73]),
                    ),
                cos_angle_1
                    .mul_add(
                        q_dot_2_sin_angle_inv_last,
                        cos_angle_last.mul_add(q_dot_2_sin_angle_inv_1, next[74]),
                    ),
                d1_of_place_32_1
                    .mul_add(
                        u_dot_of_q_dot_2_19_last,
                        d1_of_place_32_last.mul_add(u_dot_of_q_dot_2_19_1, next[75]),
                    ),
                u_dot_of_q_dot_2_3_1
                    .mul_add(
                        u_dot_of_q_dot_2_20_last,
                        u_dot_of_q_dot_2_3_last.mul_add(u_dot_of_q_dot_2_20_1, next[76]),
                    ),
                u_dot_of_q_dot_2_18_1
                    .mul_add(
                        q_dot_2_sin_angle_inv_last,
                        u_dot_of_q_dot_2_18_last
                            .mul_add(q_dot_2_sin_angle_inv_1, next[77]),
                    ),
                cos_q_ground1_plus_q_pin2_1
                    .mul_add(
                        u_dot_of_q_dot_2_23_last,
                        cos_q_ground1_plus_q_pin2_last
                            .mul_add(u_dot_of_q_dot_2_23_1, next[78]),
                    ),
                sin_q_ground1_plus_q_pin2_1
                    .mul_add(
                        u_dot_of_q_dot_2_23_last,
                        sin_q_ground1_plus_q_pin2_last
                            .mul_add(u_dot_of_q_dot_2_23_1, next[79]),
                    ),
                cos_q_ground2_1
                    .mul_add(
                        d1_of_place_4_last,
                        cos_q_ground2_last.mul_add(d1_of_place_4_1, next[80]),
                    ),
                u_dot_of_q_dot_2_4_1
                    .mul_add(
                        u_dot_of_place_22_last,
                        u_dot_of_q_dot_2_4_last.mul_add(u_dot_of_place_22_1, next[81]),
                    ),
                sin_q_ground2_1
                    .mul_add(
                        u_dot_of_q_dot_2_28_last,
                        sin_q_ground2_last.mul_add(u_dot_of_q_dot_2_28_1, next[82]),
                    ),
                sin_q_ground2_1
                    .mul_add(
                        d1_of_place_3_last,
                        sin_q_ground2_last.mul_add(d1_of_place_3_1, next[83]),
                    ),
                u_dot_of_q_dot_2_4_1
                    .mul_add(
                        u_dot_of_place_23_last,
                        u_dot_of_q_dot_2_4_last.mul_add(u_dot_of_place_23_1, next[84]),
                    ),
                cos_q_ground2_1
                    .mul_add(
                        u_dot_of_q_dot_2_26_last,
                        cos_q_ground2_last.mul_add(u_dot_of_q_dot_2_26_1, next[85]),
                    ),
                (q_dot_2_sin_angle_inv_1 + q_dot_2_sin_angle_inv_1)
                    .mul_add(q_dot_2_sin_angle_inv_last, next[86]),
                d1_of_place_16_1
                    .mul_add(
                        u_dot_of_q_dot_2_33_last,
                        d1_of_place_16_last.mul_add(u_dot_of_q_dot_2_33_1, next[87]),
                    ),
                d1_of_place_25_1
                    .mul_add(
                        u_dot_of_q_dot_2_34_last,
                        d1_of_place_25_last.mul_add(u_dot_of_q_dot_2_34_1, next[88]),
                    ),
                u_dot_of_q_dot_2_3_1
                    .mul_add(
                        sin_angle_inv_cos_angle_last,
                        u_dot_of_q_dot_2_3_last
                            .mul_add(sin_angle_inv_cos_angle_1, next[89]),
                    ),
                u_dot_of_q_dot_2_5_1
                    .mul_add(
                        u_dot_of_q_dot_2_36_last,
                        u_dot_of_q_dot_2_5_last.mul_add(u_dot_of_q_dot_2_36_1, next[90]),
                    ),
                u_dot_of_q_dot_2_5_1
                    .mul_add(
                        u_dot_of_place_9_last,
                        u_dot_of_q_dot_2_5_last.mul_add(u_dot_of_place_9_1, next[91]),
                    ),
                u_dot_of_q_dot_2_6_1
                    .mul_add(
                        u_dot_of_q_dot_2_38_last,
                        u_dot_of_q_dot_2_6_last.mul_add(u_dot_of_q_dot_2_38_1, next[92]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        u_dot_of_q_dot_2_40_last,
                        sin_angle_2_last.mul_add(u_dot_of_q_dot_2_40_1, next[93]),
                    ),
                u_dot_of_q_dot_2_32_1
                    .mul_add(
                        u_dot_of_q_dot_2_40_last,
                        u_dot_of_q_dot_2_32_last.mul_add(u_dot_of_q_dot_2_40_1, next[94]),
                    ),
                q_pin1_dot_1
                    .mul_add(
                        u_dot_of_motion_last,
                        q_pin1_dot_last.mul_add(u_dot_of_motion_1, next[95]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        u_dot_of_motion_2_last,
                        sin_q_pin1_last.mul_add(u_dot_of_motion_2_1, next[96]),
                    ),
                (q_pin2_dot_1 + q_pin2_dot_1).mul_add(q_pin2_dot_last, next[97]),
                q_ground1_dot_1
                    .mul_add(
                        d1_of_place_25_last,
                        q_ground1_dot_last.mul_add(d1_of_place_25_1, next[98]),
                    ),
                q_ground1_dot_1
                    .mul_add(
                        u_dot_of_motion_5_last,
                        q_ground1_dot_last.mul_add(u_dot_of_motion_5_1, next[99]),
                    ),
                sin_q_pin2_1
                    .mul_add(
                        u_dot_of_motion_7_last,
                        sin_q_pin2_last.mul_add(u_dot_of_motion_7_1, next[100]),
                    ),
                (q_dot_2_1 + q_dot_2_1).mul_add(q_dot_2_last, next[101]),
                d1_of_place_12_1
                    .mul_add(
                        q_dot_2_sq_last,
                        d1_of_place_12_last.mul_add(q_dot_2_sq_1, next[102]),
                    ),
                cos_q_ground1_plus_q_pin2_1
                    .mul_add(
                        u_dot_of_place_24_last,
                        cos_q_ground1_plus_q_pin2_last
                            .mul_add(u_dot_of_place_24_1, next[103]),
                    ),
                cos_q_ground2_1
                    .mul_add(
                        d1_of_place_29_last,
                        cos_q_ground2_last.mul_add(d1_of_place_29_1, next[104]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        u_dot_of_motion_9_last,
                        sin_q_pin1_last.mul_add(u_dot_of_motion_9_1, next[105]),
                    ),
                cos_q_plus_q_pin1_1
                    .mul_add(
                        d1_of_place_12_last,
                        cos_q_plus_q_pin1_last.mul_add(d1_of_place_12_1, next[106]),
                    ),
                sin_angle_1
                    .mul_add(
                        u_dot_of_motion_12_last,
                        sin_angle_last.mul_add(u_dot_of_motion_12_1, next[107]),
                    ),
                sin_angle_1
                    .mul_add(
                        q_dot_2_sin_angle_inv2_last,
                        sin_angle_last.mul_add(q_dot_2_sin_angle_inv2_1, next[108]),
                    ),
                u_dot_of_q_dot_2_1
                    .mul_add(
                        q_dot_2_sin_angle_inv2_last,
                        u_dot_of_q_dot_2_last
                            .mul_add(q_dot_2_sin_angle_inv2_1, next[109]),
                    ),
                d1_of_place_22_1
                    .mul_add(
                        u_dot_of_q_dot_2_44_last,
                        d1_of_place_22_last.mul_add(u_dot_of_q_dot_2_44_1, next[110]),
                    ),
                u_dot_of_place_5_1
                    .mul_add(
                        u_dot_of_q_dot_2_45_last,
                        u_dot_of_place_5_last.mul_add(u_dot_of_q_dot_2_45_1, next[111]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        u_dot_of_place_28_last,
                        sin_angle_2_last.mul_add(u_dot_of_place_28_1, next[112]),
                    ),
                u_dot_of_q_dot_2_4_1
                    .mul_add(
                        q_dot_2_sin_angle_inv2_last,
                        u_dot_of_q_dot_2_4_last
                            .mul_add(q_dot_2_sin_angle_inv2_1, next[113]),
                    ),
                u_dot_of_place_28_1
                    .mul_add(
                        u_dot_of_q_dot_2_47_last,
                        u_dot_of_place_28_last.mul_add(u_dot_of_q_dot_2_47_1, next[114]),
                    ),
                u_dot_of_q_dot_2_49_1
                    .mul_add(
                        d1_of_place_33_last,
                        u_dot_of_q_dot_2_49_last.mul_add(d1_of_place_33_1, next[115]),
                    ),
                d1_of_place_26_1
                    .mul_add(
                        sin_q_pin1_sin_angle_inv_last,
                        d1_of_place_26_last
                            .mul_add(sin_q_pin1_sin_angle_inv_1, next[116]),
                    ),
                u_dot_of_q_dot_2_42_1
                    .mul_add(
                        u_dot_of_place_29_last,
                        u_dot_of_q_dot_2_42_last.mul_add(u_dot_of_place_29_1, next[117]),
                    ),
                d1_of_place_37_1
                    .mul_add(
                        u_dot_of_motion_14_last,
                        d1_of_place_37_last.mul_add(u_dot_of_motion_14_1, next[118]),
                    ),
                u_dot_of_place_5_1
                    .mul_add(
                        u_dot_of_q_dot_2_33_last,
                        u_dot_of_place_5_last.mul_add(u_dot_of_q_dot_2_33_1, next[119]),
                    ),
                u_dot_of_motion_14_1
                    .mul_add(
                        sin_q_pin1_sin_angle_inv_last,
                        u_dot_of_motion_14_last
                            .mul_add(sin_q_pin1_sin_angle_inv_1, next[120]),
                    ),
                u_dot_of_q_dot_2_33_1
                    .mul_add(
                        u_dot_of_place_28_last,
                        u_dot_of_q_dot_2_33_last.mul_add(u_dot_of_place_28_1, next[121]),
                    ),
                d1_of_place_29_1
                    .mul_add(
                        q_ground1_ddot_of_motion_last,
                        d1_of_place_29_last
                            .mul_add(q_ground1_ddot_of_motion_1, next[122]),
                    ),
                u_dot_of_motion_14_1
                    .mul_add(
                        d1_of_place_32_last,
                        u_dot_of_motion_14_last.mul_add(d1_of_place_32_1, next[123]),
                    ),
                d1_of_place_25_1
                    .mul_add(
                        q_ground1_ddot_of_motion_last,
                        d1_of_place_25_last
                            .mul_add(q_ground1_ddot_of_motion_1, next[124]),
                    ),
            ])
        };
        // sin_q_pin1 = sin(q_pin1)
        let sin_q_pin1 = q_pin1.mul_add(cos_q_pin1_0, sums[0] * over_k);
        // cos_q_pin1 = cos(q_pin1)
        let cos_q_pin1 = -q_pin1.mul_add(sin_q_pin1_0, sums[1] * over_k);
        // sin_q_pin2 = sin(q_pin2)
        let sin_q_pin2 = q_pin2.mul_add(cos_q_pin2_0, sums[2] * over_k);
        // cos_q_pin2 = cos(q_pin2)
        let cos_q_pin2 = -q_pin2.mul_add(sin_q_pin2_0, sums[3] * over_k);
        // sin_q = sin(q_2)
        let sin_q = q_2.mul_add(cos_q_0, sums[4] * over_k);
        // cos_q = cos(q_2)
        let cos_q = -q_2.mul_add(sin_q_0, sums[5] * over_k);
        // sin_q_ground1 = sin(q_ground1)
        let sin_q_ground1 = q_ground1.mul_add(cos_q_ground1_0, sums[6] * over_k);
        // cos_q_ground1 = cos(q_ground1)
        let cos_q_ground1 = -q_ground1.mul_add(sin_q_ground1_0, sums[7] * over_k);
        // q_2_plus_q_pin1 = q_2 + q_pin1
        let q_2_plus_q_pin1 = q_2 + q_pin1;
        // sin_q_plus_q_pin1 = sin(q_2_plus_q_pin1)
        let sin_q_plus_q_pin1 = q_2_plus_q_pin1
            .mul_add(cos_q_plus_q_pin1_0, sums[8] * over_k);
        // cos_q_plus_q_pin1 = cos(q_2_plus_q_pin1)
        let cos_q_plus_q_pin1 = -q_2_plus_q_pin1
            .mul_add(sin_q_plus_q_pin1_0, sums[9] * over_k);
        // d1_of_place = q_2 - q_ground1 + q_pin1
        let d1_of_place = q_2 + q_pin1 - q_ground1;
        // sin_angle = sin(d1_of_place)
        let sin_angle = d1_of_place.mul_add(cos_angle_0, sums[10] * over_k);
        // cos_angle = cos(d1_of_place)
        let cos_angle = -d1_of_place.mul_add(sin_angle_0, sums[11] * over_k);
        // sin_q_ground2 = sin(q_ground2)
        let sin_q_ground2 = q_ground2.mul_add(cos_q_ground2_0, sums[12] * over_k);
        // cos_q_ground2 = cos(q_ground2)
        let cos_q_ground2 = -q_ground2.mul_add(sin_q_ground2_0, sums[13] * over_k);
        // q_ground1_plus_q_pin2 = q_ground1 + q_pin2
        let q_ground1_plus_q_pin2 = q_ground1 + q_pin2;
        // sin_q_ground1_plus_q_pin2 = sin(q_ground1_plus_q_pin2)
        let sin_q_ground1_plus_q_pin2 = q_ground1_plus_q_pin2
            .mul_add(cos_q_ground1_plus_q_pin2_0, sums[14] * over_k);
        // cos_q_ground1_plus_q_pin2 = cos(q_ground1_plus_q_pin2)
        let cos_q_ground1_plus_q_pin2 = -q_ground1_plus_q_pin2
            .mul_add(sin_q_ground1_plus_q_pin2_0, sums[15] * over_k);
        // d1_of_place_2 = q_ground1 - q_ground2 + q_pin2
        let d1_of_place_2 = q_ground1 + q_pin2 - q_ground2;
        // sin_angle_2 = sin(d1_of_place_2)
        let sin_angle_2 = d1_of_place_2.mul_add(cos_angle_2_0, sums[16] * over_k);
        // cos_angle_2 = cos(d1_of_place_2)
        let cos_angle_2 = -d1_of_place_2.mul_add(sin_angle_2_0, sums[17] * over_k);
        // d1_of_q_2_q_pin1 = sin_q + sin_q_plus_q_pin1
        let d1_of_q_2_q_pin1 = sin_q + sin_q_plus_q_pin1;
        // d1_of_q_2_q_pin1_2 = cos_q + cos_q_plus_q_pin1
        let d1_of_q_2_q_pin1_2 = cos_q + cos_q_plus_q_pin1;
        // d1_of_place_3 = sin_q_ground1 + sin_q_ground1_plus_q_pin2
        let d1_of_place_3 = sin_q_ground1 + sin_q_ground1_plus_q_pin2;
        // d1_of_place_4 = cos_q_ground1 + cos_q_ground1_plus_q_pin2
        let d1_of_place_4 = cos_q_ground1 + cos_q_ground1_plus_q_pin2;
        // sin_q_sin_q_ground1 = sin_q*sin_q_ground1
        let sin_q_sin_q_ground1 = sin_q_ground1
            .mul_add(sin_q_0, sin_q.mul_add(sin_q_ground1_0, sums[18]));
        // cos_q_cos_q_ground1 = cos_q*cos_q_ground1
        let cos_q_cos_q_ground1 = cos_q_ground1
            .mul_add(cos_q_0, cos_q.mul_add(cos_q_ground1_0, sums[19]));
        // d1_of_place_5 = sin_q_sin_q_ground1 + cos_q_cos_q_ground1
        let d1_of_place_5 = sin_q_sin_q_ground1 + cos_q_cos_q_ground1;
        // d1_of_place_6 = sin_q_pin1*d1_of_place_5
        let d1_of_place_6 = d1_of_place_5
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(d1_of_place_5_0, sums[20]));
        // sin_q_cos_q_ground1 = sin_q*cos_q_ground1
        let sin_q_cos_q_ground1 = cos_q_ground1
            .mul_add(sin_q_0, sin_q.mul_add(cos_q_ground1_0, sums[21]));
        // cos_q_sin_q_ground1 = cos_q*sin_q_ground1
        let cos_q_sin_q_ground1 = sin_q_ground1
            .mul_add(cos_q_0, cos_q.mul_add(sin_q_ground1_0, sums[22]));
        // d1_of_place_7 = sin_q_cos_q_ground1 - cos_q_sin_q_ground1
        let d1_of_place_7 = sin_q_cos_q_ground1 - cos_q_sin_q_ground1;
        // d1_of_place_8 = cos_q_pin1*d1_of_place_7
        let d1_of_place_8 = d1_of_place_7
            .mul_add(cos_q_pin1_0, cos_q_pin1.mul_add(d1_of_place_7_0, sums[23]));
        // d1_of_place_9 = d1_of_place_6 + d1_of_place_8
        let d1_of_place_9 = d1_of_place_6 + d1_of_place_8;
        // d1_of_place_10 = sin_q_ground1*d1_of_q_2_q_pin1_2
        let d1_of_place_10 = d1_of_q_2_q_pin1_2
            .mul_add(
                sin_q_ground1_0,
                sin_q_ground1.mul_add(d1_of_q_2_q_pin1_2_0, sums[24]),
            );
        // d1_of_place_11 = cos_q_ground1*d1_of_q_2_q_pin1
        let d1_of_place_11 = d1_of_q_2_q_pin1
            .mul_add(
                cos_q_ground1_0,
                cos_q_ground1.mul_add(d1_of_q_2_q_pin1_0, sums[25]),
            );
        // d1_of_place_12 = d1_of_place_10 - d1_of_place_11
        let d1_of_place_12 = d1_of_place_10 - d1_of_place_11;
        // d1_of_place_13 = sin_q_ground2*d1_of_place_4
        let d1_of_place_13 = d1_of_place_4
            .mul_add(sin_q_ground2_0, sin_q_ground2.mul_add(d1_of_place_4_0, sums[26]));
        // d1_of_place_14 = cos_q_ground2*d1_of_place_3
        let d1_of_place_14 = d1_of_place_3
            .mul_add(cos_q_ground2_0, cos_q_ground2.mul_add(d1_of_place_3_0, sums[27]));
        // d1_of_place_15 = d1_of_place_13 - d1_of_place_14
        let d1_of_place_15 = d1_of_place_13 - d1_of_place_14;
        // d1_of_place_16 = cos_q_pin1*d1_of_place_12
        let d1_of_place_16 = d1_of_place_12
            .mul_add(cos_q_pin1_0, cos_q_pin1.mul_add(d1_of_place_12_0, sums[28]));
        // d1_of_place_17 = 2*d1_of_place_10 - 2*d1_of_place_11 + 3*d1_of_place_16
        let d1_of_place_17 = d1_of_place_16
            .mul_add(
                S::int(3),
                d1_of_place_11.mul_add(-S::int(2), S::int(2) * d1_of_place_10),
            );
        // d1_of_place_18 = d1_of_place_17/sin_angle
        let d1_of_place_18 = d1_of_place_17
            .mul_add(
                over_sin_angle,
                -(sin_angle.mul_add(d1_of_place_18_0, sums[29]) * over_sin_angle),
            );
        // d1_of_place_19 = cos_q_pin2*d1_of_place_15
        let d1_of_place_19 = d1_of_place_15
            .mul_add(cos_q_pin2_0, cos_q_pin2.mul_add(d1_of_place_15_0, sums[30]));
        // d1_of_place_20 = 2*d1_of_place_13 - 2*d1_of_place_14 + 3*d1_of_place_19
        let d1_of_place_20 = d1_of_place_19
            .mul_add(
                S::int(3),
                d1_of_place_14.mul_add(-S::int(2), S::int(2) * d1_of_place_13),
            );
        // d1_of_place_21 = d1_of_place_20/sin_angle_2
        let d1_of_place_21 = d1_of_place_20
            .mul_add(
                over_sin_angle_2,
                -(sin_angle_2.mul_add(d1_of_place_21_0, sums[31]) * over_sin_angle_2),
            );
        // d1_of_place_22 = 10 + 6*cos_q_pin2 + d1_of_place_21
        let d1_of_place_22 = S::int(6) * cos_q_pin2 + d1_of_place_21;
        // d1_of_place_23 = cos_q_pin1*d1_of_place_9
        let d1_of_place_23 = d1_of_place_9
            .mul_add(cos_q_pin1_0, cos_q_pin1.mul_add(d1_of_place_9_0, sums[32]));
        // d1_of_place_24 = 2*sin_q_cos_q_ground1 - 2*cos_q_sin_q_ground1 - 3*d1_of_place_23
        let d1_of_place_24 = d1_of_place_23
            .mul_add(
                -S::int(3),
                cos_q_sin_q_ground1.mul_add(-S::int(2), S::int(2) * sin_q_cos_q_ground1),
            );
        // d1_of_place_25 = d1_of_place_15/sin_angle_2
        let d1_of_place_25 = d1_of_place_15
            .mul_add(
                over_sin_angle_2,
                -(sin_angle_2.mul_add(d1_of_place_25_0, sums[33]) * over_sin_angle_2),
            );
        // d1_of_place_26 = 2 + 3*cos_q_pin2 + 2*d1_of_place_25
        let d1_of_place_26 = d1_of_place_25.mul_add(S::int(2), S::int(3) * cos_q_pin2);
        // sin_q_pin1_sin_angle_inv = sin_q_pin1/sin_angle
        let sin_q_pin1_sin_angle_inv = sin_angle
            .mul_add(
                -(sin_q_pin1_sin_angle_inv_0 * over_sin_angle),
                (sin_q_pin1 - sums[34]) * over_sin_angle,
            );
        // d1_of_place_27 = sin_q_pin1_sin_angle_inv*sin_q_pin1_sin_angle_inv
        let d1_of_place_27 = sin_q_pin1_sin_angle_inv
            .mul_add(sin_q_pin1_sin_angle_inv_0 + sin_q_pin1_sin_angle_inv_0, sums[35]);
        // d1_of_place_28 = d1_of_place_22*d1_of_place_27
        let d1_of_place_28 = d1_of_place_22
            .mul_add(
                d1_of_place_27_0,
                d1_of_place_27.mul_add(d1_of_place_22_0, sums[36]),
            );
        // d1_of_place_29 = sin_q_pin2/sin_angle_2
        let d1_of_place_29 = sin_angle_2
            .mul_add(
                -(d1_of_place_29_0 * over_sin_angle_2),
                (sin_q_pin2 - sums[37]) * over_sin_angle_2,
            );
        // d1_of_place_30 = d1_of_place_29*d1_of_place_29
        let d1_of_place_30 = d1_of_place_29
            .mul_add(d1_of_place_29_0 + d1_of_place_29_0, sums[38]);
        // d1_of_place_31 = d1_of_place_27*d1_of_place_30
        let d1_of_place_31 = d1_of_place_30
            .mul_add(
                d1_of_place_27_0,
                d1_of_place_27.mul_add(d1_of_place_30_0, sums[39]),
            );
        // d1_of_place_32 = d1_of_place_12/sin_angle
        let d1_of_place_32 = d1_of_place_12
            .mul_add(
                over_sin_angle,
                -(sin_angle.mul_add(d1_of_place_32_0, sums[40]) * over_sin_angle),
            );
        // d1_of_place_33 = d1_of_place_24/d1_of_place_9
        let d1_of_place_33 = d1_of_place_24
            .mul_add(
                over_d1_of_place_9,
                -(d1_of_place_9.mul_add(d1_of_place_33_0, sums[41]) * over_d1_of_place_9),
            );
        // d1_of_place_34 = d1_of_place_32*d1_of_place_33
        let d1_of_place_34 = d1_of_place_33
            .mul_add(
                d1_of_place_32_0,
                d1_of_place_32.mul_add(d1_of_place_33_0, sums[42]),
            );
        // d1_of_place_35 = d1_of_place_25*d1_of_place_27
        let d1_of_place_35 = d1_of_place_25
            .mul_add(
                d1_of_place_27_0,
                d1_of_place_27.mul_add(d1_of_place_25_0, sums[43]),
            );
        // d1_of_place_36 = d1_of_place_26*d1_of_place_35
        let d1_of_place_36 = d1_of_place_35
            .mul_add(
                d1_of_place_26_0,
                d1_of_place_26.mul_add(d1_of_place_35_0, sums[44]),
            );
        // d1_of_place_37 = weight + m_l_2*cos_q_pin1 + m_l_2_by_6*d1_of_place_18 +
        //   m_l_2_by_6*d1_of_place_28 + m_l_2_by_3*d1_of_place_31 + minus_m_l_2_by_6*d1_of_place_34 +
        //   m_l_2_by_6*d1_of_place_36
        let d1_of_place_37 = d1_of_place_34
            .mul_add(
                minus_m_l_2_by_6,
                d1_of_place_28
                    .mul_add(
                        m_l_2_by_6,
                        d1_of_place_36
                            .mul_add(
                                m_l_2_by_6,
                                d1_of_place_18
                                    .mul_add(
                                        m_l_2_by_6,
                                        d1_of_place_31.mul_add(m_l_2_by_3, m_l_2 * cos_q_pin1),
                                    ),
                            ),
                    ),
            );
        // q_dot_2_sin_q = q_dot_2*sin_q
        let q_dot_2_sin_q = sin_q.mul_add(q_dot_2_0, q_dot_2.mul_add(sin_q_0, sums[45]));
        // q_dot_2_cos_q = q_dot_2*cos_q
        let q_dot_2_cos_q = cos_q.mul_add(q_dot_2_0, q_dot_2.mul_add(cos_q_0, sums[46]));
        // u_dot_of_q_dot_2 = q_dot_2*sin_q_pin1_sin_angle_inv
        let u_dot_of_q_dot_2 = sin_q_pin1_sin_angle_inv
            .mul_add(q_dot_2_0, q_dot_2.mul_add(sin_q_pin1_sin_angle_inv_0, sums[47]));
        // q_dot_2_sin_angle_inv = q_dot_2/sin_angle
        let q_dot_2_sin_angle_inv = sin_angle
            .mul_add(
                -(q_dot_2_sin_angle_inv_0 * over_sin_angle),
                (q_dot_2 - sums[48]) * over_sin_angle,
            );
        // u_dot_of_q_dot_2_2 = d1_of_place_12*q_dot_2_sin_angle_inv
        let u_dot_of_q_dot_2_2 = d1_of_place_12
            .mul_add(
                q_dot_2_sin_angle_inv_0,
                q_dot_2_sin_angle_inv.mul_add(d1_of_place_12_0, sums[49]),
            );
        // u_dot_of_q_dot_2_3 = q_dot_2 - u_dot_of_q_dot_2 + u_dot_of_q_dot_2_2
        let u_dot_of_q_dot_2_3 = q_dot_2 - u_dot_of_q_dot_2 + u_dot_of_q_dot_2_2;
        // u_dot_of_place = sin_q_pin1 - d1_of_place_10 + d1_of_place_11
        let u_dot_of_place = sin_q_pin1 + d1_of_place_11 - d1_of_place_10;
        // u_dot_of_place_2 = u_dot_of_place/sin_angle
        let u_dot_of_place_2 = u_dot_of_place
            .mul_add(
                over_sin_angle,
                -(sin_angle.mul_add(u_dot_of_place_2_0, sums[50]) * over_sin_angle),
            );
        // u_dot_of_place_3 = -1 + u_dot_of_place_2
        let u_dot_of_place_3 = u_dot_of_place_2;
        // sin_q_pin1_cos_angle = sin_q_pin1*cos_angle
        let sin_q_pin1_cos_angle = cos_angle
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(cos_angle_0, sums[51]));
        // u_dot_of_place_4 = u_dot_of_place_3*sin_q_pin1_cos_angle
        let u_dot_of_place_4 = u_dot_of_place_3
            .mul_add(
                sin_q_pin1_cos_angle_0,
                sin_q_pin1_cos_angle.mul_add(u_dot_of_place_3_0, sums[52]),
            );
        // u_dot_of_place_5 = u_dot_of_place_4 + d1_of_place_16
        let u_dot_of_place_5 = d1_of_place_16 + u_dot_of_place_4;
        // u_dot_of_q_dot_2_4 = u_dot_of_q_dot_2*d1_of_place_29
        let u_dot_of_q_dot_2_4 = u_dot_of_q_dot_2
            .mul_add(
                d1_of_place_29_0,
                d1_of_place_29.mul_add(u_dot_of_q_dot_2_0, sums[53]),
            );
        // u_dot_of_q_dot_2_5 = u_dot_of_q_dot_2*d1_of_place_25
        let u_dot_of_q_dot_2_5 = d1_of_place_25
            .mul_add(
                u_dot_of_q_dot_2_0,
                u_dot_of_q_dot_2.mul_add(d1_of_place_25_0, sums[54]),
            );
        // u_dot_of_q_dot_2_6 = u_dot_of_q_dot_2 - u_dot_of_q_dot_2_4 + u_dot_of_q_dot_2_5
        let u_dot_of_q_dot_2_6 = u_dot_of_q_dot_2 - u_dot_of_q_dot_2_4 + u_dot_of_q_dot_2_5;
        // u_dot_of_place_6 = sin_q_pin2 - d1_of_place_13 + d1_of_place_14
        let u_dot_of_place_6 = sin_q_pin2 + d1_of_place_14 - d1_of_place_13;
        // u_dot_of_place_7 = u_dot_of_place_6/sin_angle_2
        let u_dot_of_place_7 = u_dot_of_place_6
            .mul_add(
                over_sin_angle_2,
                -(sin_angle_2.mul_add(u_dot_of_place_7_0, sums[55]) * over_sin_angle_2),
            );
        // u_dot_of_place_8 = -1 + u_dot_of_place_7
        let u_dot_of_place_8 = u_dot_of_place_7;
        // u_dot_of_place_9 = cos_angle_2/sin_angle_2
        let u_dot_of_place_9 = sin_angle_2
            .mul_add(
                -(u_dot_of_place_9_0 * over_sin_angle_2),
                (cos_angle_2 - sums[56]) * over_sin_angle_2,
            );
        // u_dot_of_place_10 = u_dot_of_place_8*u_dot_of_place_9
        let u_dot_of_place_10 = u_dot_of_place_8
            .mul_add(
                u_dot_of_place_9_0,
                u_dot_of_place_9.mul_add(u_dot_of_place_8_0, sums[57]),
            );
        // sin_angle_inv_cos_angle = cos_angle/sin_angle
        let sin_angle_inv_cos_angle = sin_angle
            .mul_add(
                -(sin_angle_inv_cos_angle_0 * over_sin_angle),
                (cos_angle - sums[58]) * over_sin_angle,
            );
        // u_dot_of_place_11 = u_dot_of_place_10 + sin_angle_inv_cos_angle
        let u_dot_of_place_11 = sin_angle_inv_cos_angle + u_dot_of_place_10;
        // u_dot_of_place_12 = sin_q_pin1*u_dot_of_place_11
        let u_dot_of_place_12 = u_dot_of_place_11
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(u_dot_of_place_11_0, sums[59]));
        // u_dot_of_place_13 = 1 + d1_of_place_32
        let u_dot_of_place_13 = d1_of_place_32;
        // u_dot_of_place_14 = cos_angle*u_dot_of_place_13
        let u_dot_of_place_14 = u_dot_of_place_13
            .mul_add(cos_angle_0, cos_angle.mul_add(u_dot_of_place_13_0, sums[60]));
        // u_dot_of_place_15 = u_dot_of_place_12 - u_dot_of_place_14
        let u_dot_of_place_15 = -u_dot_of_place_14 + u_dot_of_place_12;
        // u_dot_of_place_16 = sin_q_pin2*u_dot_of_place_15
        let u_dot_of_place_16 = u_dot_of_place_15
            .mul_add(sin_q_pin2_0, sin_q_pin2.mul_add(u_dot_of_place_15_0, sums[61]));
        // sin_q_pin1_cos_q_pin2 = sin_q_pin1*cos_q_pin2
        let sin_q_pin1_cos_q_pin2 = cos_q_pin2
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(cos_q_pin2_0, sums[62]));
        // u_dot_of_place_17 = d1_of_place_25*sin_q_pin1_cos_q_pin2
        let u_dot_of_place_17 = d1_of_place_25
            .mul_add(
                sin_q_pin1_cos_q_pin2_0,
                sin_q_pin1_cos_q_pin2.mul_add(d1_of_place_25_0, sums[63]),
            );
        // u_dot_of_place_18 = u_dot_of_place_16 + u_dot_of_place_17
        let u_dot_of_place_18 = u_dot_of_place_17 + u_dot_of_place_16;
        // u_dot_of_place_19 = sin_q_pin1*u_dot_of_place_18
        let u_dot_of_place_19 = u_dot_of_place_18
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(u_dot_of_place_18_0, sums[64]));
        // u_dot_of_place_20 = sin_q_pin2*d1_of_place_16
        let u_dot_of_place_20 = d1_of_place_16
            .mul_add(sin_q_pin2_0, sin_q_pin2.mul_add(d1_of_place_16_0, sums[65]));
        // u_dot_of_place_21 = u_dot_of_place_19 + u_dot_of_place_20
        let u_dot_of_place_21 = u_dot_of_place_20 + u_dot_of_place_19;
        // u_dot_of_q_dot_2_7 = q_dot_2 + u_dot_of_q_dot_2_2
        let u_dot_of_q_dot_2_7 = q_dot_2 + u_dot_of_q_dot_2_2;
        // u_dot_of_q_dot_2_8 = cos_q_plus_q_pin1*u_dot_of_q_dot_2_7
        let u_dot_of_q_dot_2_8 = u_dot_of_q_dot_2_7
            .mul_add(
                cos_q_plus_q_pin1_0,
                cos_q_plus_q_pin1.mul_add(u_dot_of_q_dot_2_7_0, sums[66]),
            );
        // u_dot_of_q_dot_2_9 = sin_q_plus_q_pin1*u_dot_of_q_dot_2_7
        let u_dot_of_q_dot_2_9 = u_dot_of_q_dot_2_7
            .mul_add(
                sin_q_plus_q_pin1_0,
                sin_q_plus_q_pin1.mul_add(u_dot_of_q_dot_2_7_0, sums[67]),
            );
        // u_dot_of_q_dot_2_10 = q_dot_2_cos_q + u_dot_of_q_dot_2_8
        let u_dot_of_q_dot_2_10 = q_dot_2_cos_q + u_dot_of_q_dot_2_8;
        // u_dot_of_q_dot_2_11 = cos_q_ground1*u_dot_of_q_dot_2
        let u_dot_of_q_dot_2_11 = u_dot_of_q_dot_2
            .mul_add(
                cos_q_ground1_0,
                cos_q_ground1.mul_add(u_dot_of_q_dot_2_0, sums[68]),
            );
        // u_dot_of_q_dot_2_12 = d1_of_q_2_q_pin1_2*u_dot_of_q_dot_2_11
        let u_dot_of_q_dot_2_12 = u_dot_of_q_dot_2_11
            .mul_add(
                d1_of_q_2_q_pin1_2_0,
                d1_of_q_2_q_pin1_2.mul_add(u_dot_of_q_dot_2_11_0, sums[69]),
            );
        // u_dot_of_q_dot_2_13 = q_dot_2_sin_q + u_dot_of_q_dot_2_9
        let u_dot_of_q_dot_2_13 = q_dot_2_sin_q + u_dot_of_q_dot_2_9;
        // u_dot_of_q_dot_2_14 = sin_q_ground1*u_dot_of_q_dot_2_13
        let u_dot_of_q_dot_2_14 = u_dot_of_q_dot_2_13
            .mul_add(
                sin_q_ground1_0,
                sin_q_ground1.mul_add(u_dot_of_q_dot_2_13_0, sums[70]),
            );
        // u_dot_of_q_dot_2_15 = sin_q_ground1*u_dot_of_q_dot_2
        let u_dot_of_q_dot_2_15 = u_dot_of_q_dot_2
            .mul_add(
                sin_q_ground1_0,
                sin_q_ground1.mul_add(u_dot_of_q_dot_2_0, sums[71]),
            );
        // u_dot_of_q_dot_2_16 = d1_of_q_2_q_pin1*u_dot_of_q_dot_2_15
        let u_dot_of_q_dot_2_16 = u_dot_of_q_dot_2_15
            .mul_add(
                d1_of_q_2_q_pin1_0,
                d1_of_q_2_q_pin1.mul_add(u_dot_of_q_dot_2_15_0, sums[72]),
            );
        // u_dot_of_q_dot_2_17 = cos_q_ground1*u_dot_of_q_dot_2_10
        let u_dot_of_q_dot_2_17 = u_dot_of_q_dot_2_10
            .mul_add(
                cos_q_ground1_0,
                cos_q_ground1.mul_add(u_dot_of_q_dot_2_10_0, sums[73]),
            );
        // u_dot_of_q_dot_2_18 = u_dot_of_q_dot_2_12 - u_dot_of_q_dot_2_14 + u_dot_of_q_dot_2_16 -
        //   u_dot_of_q_dot_2_17
        let u_dot_of_q_dot_2_18 = u_dot_of_q_dot_2_12 + u_dot_of_q_dot_2_16
            - u_dot_of_q_dot_2_14 - u_dot_of_q_dot_2_17;
        // u_dot_of_q_dot_2_19 = cos_angle*q_dot_2_sin_angle_inv
        let u_dot_of_q_dot_2_19 = q_dot_2_sin_angle_inv
            .mul_add(cos_angle_0, cos_angle.mul_add(q_dot_2_sin_angle_inv_0, sums[74]));
        // u_dot_of_q_dot_2_20 = d1_of_place_32*u_dot_of_q_dot_2_19
        let u_dot_of_q_dot_2_20 = d1_of_place_32
            .mul_add(
                u_dot_of_q_dot_2_19_0,
                u_dot_of_q_dot_2_19.mul_add(d1_of_place_32_0, sums[75]),
            );
        // u_dot_of_q_dot_2_21 = u_dot_of_q_dot_2_3*u_dot_of_q_dot_2_20
        let u_dot_of_q_dot_2_21 = u_dot_of_q_dot_2_20
            .mul_add(
                u_dot_of_q_dot_2_3_0,
                u_dot_of_q_dot_2_3.mul_add(u_dot_of_q_dot_2_20_0, sums[76]),
            );
        // u_dot_of_q_dot_2_22 = u_dot_of_q_dot_2_18*q_dot_2_sin_angle_inv
        let u_dot_of_q_dot_2_22 = u_dot_of_q_dot_2_18
            .mul_add(
                q_dot_2_sin_angle_inv_0,
                q_dot_2_sin_angle_inv.mul_add(u_dot_of_q_dot_2_18_0, sums[77]),
            );
        // u_dot_of_q_dot_2_23 = u_dot_of_q_dot_2 + u_dot_of_q_dot_2_5
        let u_dot_of_q_dot_2_23 = u_dot_of_q_dot_2 + u_dot_of_q_dot_2_5;
        // u_dot_of_q_dot_2_24 = cos_q_ground1_plus_q_pin2*u_dot_of_q_dot_2_23
        let u_dot_of_q_dot_2_24 = u_dot_of_q_dot_2_23
            .mul_add(
                cos_q_ground1_plus_q_pin2_0,
                cos_q_ground1_plus_q_pin2.mul_add(u_dot_of_q_dot_2_23_0, sums[78]),
            );
        // u_dot_of_q_dot_2_25 = sin_q_ground1_plus_q_pin2*u_dot_of_q_dot_2_23
        let u_dot_of_q_dot_2_25 = u_dot_of_q_dot_2_23
            .mul_add(
                sin_q_ground1_plus_q_pin2_0,
                sin_q_ground1_plus_q_pin2.mul_add(u_dot_of_q_dot_2_23_0, sums[79]),
            );
        // u_dot_of_q_dot_2_26 = u_dot_of_q_dot_2_11 + u_dot_of_q_dot_2_24
        let u_dot_of_q_dot_2_26 = u_dot_of_q_dot_2_11 + u_dot_of_q_dot_2_24;
        // u_dot_of_place_22 = cos_q_ground2*d1_of_place_4
        let u_dot_of_place_22 = d1_of_place_4
            .mul_add(cos_q_ground2_0, cos_q_ground2.mul_add(d1_of_place_4_0, sums[80]));
        // u_dot_of_q_dot_2_27 = u_dot_of_q_dot_2_4*u_dot_of_place_22
        let u_dot_of_q_dot_2_27 = u_dot_of_q_dot_2_4
            .mul_add(
                u_dot_of_place_22_0,
                u_dot_of_place_22.mul_add(u_dot_of_q_dot_2_4_0, sums[81]),
            );
        // u_dot_of_q_dot_2_28 = u_dot_of_q_dot_2_15 + u_dot_of_q_dot_2_25
        let u_dot_of_q_dot_2_28 = u_dot_of_q_dot_2_15 + u_dot_of_q_dot_2_25;
        // u_dot_of_q_dot_2_29 = sin_q_ground2*u_dot_of_q_dot_2_28
        let u_dot_of_q_dot_2_29 = u_dot_of_q_dot_2_28
            .mul_add(
                sin_q_ground2_0,
                sin_q_ground2.mul_add(u_dot_of_q_dot_2_28_0, sums[82]),
            );
        // u_dot_of_place_23 = sin_q_ground2*d1_of_place_3
        let u_dot_of_place_23 = d1_of_place_3
            .mul_add(sin_q_ground2_0, sin_q_ground2.mul_add(d1_of_place_3_0, sums[83]));
        // u_dot_of_q_dot_2_30 = u_dot_of_q_dot_2_4*u_dot_of_place_23
        let u_dot_of_q_dot_2_30 = u_dot_of_q_dot_2_4
            .mul_add(
                u_dot_of_place_23_0,
                u_dot_of_place_23.mul_add(u_dot_of_q_dot_2_4_0, sums[84]),
            );
        // u_dot_of_q_dot_2_31 = cos_q_ground2*u_dot_of_q_dot_2_26
        let u_dot_of_q_dot_2_31 = u_dot_of_q_dot_2_26
            .mul_add(
                cos_q_ground2_0,
                cos_q_ground2.mul_add(u_dot_of_q_dot_2_26_0, sums[85]),
            );
        // u_dot_of_q_dot_2_32 = u_dot_of_q_dot_2_27 - u_dot_of_q_dot_2_29 + u_dot_of_q_dot_2_30 -
        //   u_dot_of_q_dot_2_31
        let u_dot_of_q_dot_2_32 = u_dot_of_q_dot_2_27 + u_dot_of_q_dot_2_30
            - u_dot_of_q_dot_2_29 - u_dot_of_q_dot_2_31;
        // u_dot_of_q_dot_2_33 = q_dot_2_sin_angle_inv*q_dot_2_sin_angle_inv
        let u_dot_of_q_dot_2_33 = q_dot_2_sin_angle_inv
            .mul_add(q_dot_2_sin_angle_inv_0 + q_dot_2_sin_angle_inv_0, sums[86]);
        // u_dot_of_q_dot_2_34 = d1_of_place_16*u_dot_of_q_dot_2_33
        let u_dot_of_q_dot_2_34 = d1_of_place_16
            .mul_add(
                u_dot_of_q_dot_2_33_0,
                u_dot_of_q_dot_2_33.mul_add(d1_of_place_16_0, sums[87]),
            );
        // u_dot_of_q_dot_2_35 = d1_of_place_25*u_dot_of_q_dot_2_34
        let u_dot_of_q_dot_2_35 = u_dot_of_q_dot_2_34
            .mul_add(
                d1_of_place_25_0,
                d1_of_place_25.mul_add(u_dot_of_q_dot_2_34_0, sums[88]),
            );
        // u_dot_of_q_dot_2_36 = u_dot_of_q_dot_2_3*sin_angle_inv_cos_angle
        let u_dot_of_q_dot_2_36 = u_dot_of_q_dot_2_3
            .mul_add(
                sin_angle_inv_cos_angle_0,
                sin_angle_inv_cos_angle.mul_add(u_dot_of_q_dot_2_3_0, sums[89]),
            );
        // u_dot_of_q_dot_2_37 = u_dot_of_q_dot_2_5*u_dot_of_q_dot_2_36
        let u_dot_of_q_dot_2_37 = u_dot_of_q_dot_2_36
            .mul_add(
                u_dot_of_q_dot_2_5_0,
                u_dot_of_q_dot_2_5.mul_add(u_dot_of_q_dot_2_36_0, sums[90]),
            );
        // u_dot_of_q_dot_2_38 = u_dot_of_q_dot_2_5*u_dot_of_place_9
        let u_dot_of_q_dot_2_38 = u_dot_of_q_dot_2_5
            .mul_add(
                u_dot_of_place_9_0,
                u_dot_of_place_9.mul_add(u_dot_of_q_dot_2_5_0, sums[91]),
            );
        // u_dot_of_q_dot_2_39 = u_dot_of_q_dot_2_6*u_dot_of_q_dot_2_38
        let u_dot_of_q_dot_2_39 = u_dot_of_q_dot_2_38
            .mul_add(
                u_dot_of_q_dot_2_6_0,
                u_dot_of_q_dot_2_6.mul_add(u_dot_of_q_dot_2_38_0, sums[92]),
            );
        // u_dot_of_q_dot_2_40 = u_dot_of_q_dot_2/sin_angle_2
        let u_dot_of_q_dot_2_40 = u_dot_of_q_dot_2
            .mul_add(
                over_sin_angle_2,
                -(sin_angle_2.mul_add(u_dot_of_q_dot_2_40_0, sums[93]) * over_sin_angle_2),
            );
        // u_dot_of_q_dot_2_41 = u_dot_of_q_dot_2_32*u_dot_of_q_dot_2_40
        let u_dot_of_q_dot_2_41 = u_dot_of_q_dot_2_32
            .mul_add(
                u_dot_of_q_dot_2_40_0,
                u_dot_of_q_dot_2_40.mul_add(u_dot_of_q_dot_2_32_0, sums[94]),
            );
        // u_dot_of_q_dot_2_42 = u_dot_of_q_dot_2_35 - u_dot_of_q_dot_2_37 - u_dot_of_q_dot_2_39 +
        //   u_dot_of_q_dot_2_41
        let u_dot_of_q_dot_2_42 = u_dot_of_q_dot_2_35 - u_dot_of_q_dot_2_37
            - u_dot_of_q_dot_2_39 + u_dot_of_q_dot_2_41;
        // u_dot_of_motion = 2*q_dot_2 + q_pin1_dot
        let u_dot_of_motion = S::int(2) * q_dot_2 + q_pin1_dot;
        // u_dot_of_motion_2 = q_pin1_dot*u_dot_of_motion
        let u_dot_of_motion_2 = u_dot_of_motion
            .mul_add(q_pin1_dot_0, q_pin1_dot.mul_add(u_dot_of_motion_0, sums[95]));
        // u_dot_of_motion_3 = sin_q_pin1*u_dot_of_motion_2
        let u_dot_of_motion_3 = u_dot_of_motion_2
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(u_dot_of_motion_2_0, sums[96]));
        // q_pin2_dot_sq = q_pin2_dot*q_pin2_dot
        let q_pin2_dot_sq = q_pin2_dot.mul_add(q_pin2_dot_0 + q_pin2_dot_0, sums[97]);
        // u_dot_of_motion_4 = q_ground1_dot*d1_of_place_25
        let u_dot_of_motion_4 = d1_of_place_25
            .mul_add(q_ground1_dot_0, q_ground1_dot.mul_add(d1_of_place_25_0, sums[98]));
        // u_dot_of_motion_5 = 2*q_pin2_dot - u_dot_of_motion_4
        let u_dot_of_motion_5 = S::int(2) * q_pin2_dot - u_dot_of_motion_4;
        // u_dot_of_motion_6 = q_ground1_dot*u_dot_of_motion_5
        let u_dot_of_motion_6 = u_dot_of_motion_5
            .mul_add(
                q_ground1_dot_0,
                q_ground1_dot.mul_add(u_dot_of_motion_5_0, sums[99]),
            );
        // u_dot_of_motion_7 = q_pin2_dot_sq + u_dot_of_motion_6
        let u_dot_of_motion_7 = q_pin2_dot_sq + u_dot_of_motion_6;
        // u_dot_of_motion_8 = sin_q_pin2*u_dot_of_motion_7
        let u_dot_of_motion_8 = u_dot_of_motion_7
            .mul_add(sin_q_pin2_0, sin_q_pin2.mul_add(u_dot_of_motion_7_0, sums[100]));
        // q_dot_2_sq = q_dot_2*q_dot_2
        let q_dot_2_sq = q_dot_2.mul_add(q_dot_2_0 + q_dot_2_0, sums[101]);
        // u_dot_of_q_dot_2_43 = d1_of_place_12*q_dot_2_sq
        let u_dot_of_q_dot_2_43 = d1_of_place_12
            .mul_add(q_dot_2_sq_0, q_dot_2_sq.mul_add(d1_of_place_12_0, sums[102]));
        // u_dot_of_place_24 = 1 + d1_of_place_25
        let u_dot_of_place_24 = d1_of_place_25;
        // u_dot_of_place_25 = cos_q_ground1_plus_q_pin2*u_dot_of_place_24
        let u_dot_of_place_25 = u_dot_of_place_24
            .mul_add(
                cos_q_ground1_plus_q_pin2_0,
                cos_q_ground1_plus_q_pin2.mul_add(u_dot_of_place_24_0, sums[103]),
            );
        // u_dot_of_place_26 = cos_q_ground2*d1_of_place_29
        let u_dot_of_place_26 = d1_of_place_29
            .mul_add(
                cos_q_ground2_0,
                cos_q_ground2.mul_add(d1_of_place_29_0, sums[104]),
            );
        // u_dot_of_motion_9 = l*u_dot_of_motion_8 + minus_l*u_dot_of_q_dot_2_43 + minus_3_g*cos_q_ground1
        //   + minus_g*u_dot_of_place_25 + minus_g*u_dot_of_place_26
        let u_dot_of_motion_9 = u_dot_of_motion_8
            .mul_add(
                l,
                u_dot_of_place_25
                    .mul_add(
                        minus_g,
                        u_dot_of_q_dot_2_43
                            .mul_add(
                                minus_l,
                                u_dot_of_place_26
                                    .mul_add(minus_g, minus_3_g * cos_q_ground1),
                            ),
                    ),
            );
        // u_dot_of_motion_10 = sin_q_pin1*u_dot_of_motion_9
        let u_dot_of_motion_10 = u_dot_of_motion_9
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(u_dot_of_motion_9_0, sums[105]));
        // u_dot_of_place_27 = cos_q_plus_q_pin1*d1_of_place_12
        let u_dot_of_place_27 = d1_of_place_12
            .mul_add(
                cos_q_plus_q_pin1_0,
                cos_q_plus_q_pin1.mul_add(d1_of_place_12_0, sums[106]),
            );
        // u_dot_of_motion_11 = u_dot_of_motion_10 + minus_g*u_dot_of_place_27
        let u_dot_of_motion_11 = minus_g * u_dot_of_place_27 + u_dot_of_motion_10;
        // u_dot_of_motion_12 = u_dot_of_motion_11/sin_angle
        let u_dot_of_motion_12 = u_dot_of_motion_11
            .mul_add(
                over_sin_angle,
                -(sin_angle.mul_add(u_dot_of_motion_12_0, sums[107]) * over_sin_angle),
            );
        // q_dot_2_sin_angle_inv2 = q_dot_2_sin_angle_inv/sin_angle
        let q_dot_2_sin_angle_inv2 = q_dot_2_sin_angle_inv
            .mul_add(
                over_sin_angle,
                -(sin_angle.mul_add(q_dot_2_sin_angle_inv2_0, sums[108]) * over_sin_angle),
            );
        // u_dot_of_q_dot_2_44 = u_dot_of_q_dot_2*q_dot_2_sin_angle_inv2
        let u_dot_of_q_dot_2_44 = q_dot_2_sin_angle_inv2
            .mul_add(
                u_dot_of_q_dot_2_0,
                u_dot_of_q_dot_2.mul_add(q_dot_2_sin_angle_inv2_0, sums[109]),
            );
        // u_dot_of_q_dot_2_45 = d1_of_place_22*u_dot_of_q_dot_2_44
        let u_dot_of_q_dot_2_45 = d1_of_place_22
            .mul_add(
                u_dot_of_q_dot_2_44_0,
                u_dot_of_q_dot_2_44.mul_add(d1_of_place_22_0, sums[110]),
            );
        // u_dot_of_q_dot_2_46 = u_dot_of_place_5*u_dot_of_q_dot_2_45
        let u_dot_of_q_dot_2_46 = u_dot_of_q_dot_2_45
            .mul_add(
                u_dot_of_place_5_0,
                u_dot_of_place_5.mul_add(u_dot_of_q_dot_2_45_0, sums[111]),
            );
        // u_dot_of_place_28 = u_dot_of_place_21/sin_angle_2
        let u_dot_of_place_28 = u_dot_of_place_21
            .mul_add(
                over_sin_angle_2,
                -(sin_angle_2.mul_add(u_dot_of_place_28_0, sums[112]) * over_sin_angle_2),
            );
        // u_dot_of_q_dot_2_47 = u_dot_of_q_dot_2_4*q_dot_2_sin_angle_inv2
        let u_dot_of_q_dot_2_47 = u_dot_of_q_dot_2_4
            .mul_add(
                q_dot_2_sin_angle_inv2_0,
                q_dot_2_sin_angle_inv2.mul_add(u_dot_of_q_dot_2_4_0, sums[113]),
            );
        // u_dot_of_q_dot_2_48 = u_dot_of_place_28*u_dot_of_q_dot_2_47
        let u_dot_of_q_dot_2_48 = u_dot_of_place_28
            .mul_add(
                u_dot_of_q_dot_2_47_0,
                u_dot_of_q_dot_2_47.mul_add(u_dot_of_place_28_0, sums[114]),
            );
        // u_dot_of_q_dot_2_49 = u_dot_of_q_dot_2_21 - u_dot_of_q_dot_2_22
        let u_dot_of_q_dot_2_49 = u_dot_of_q_dot_2_21 - u_dot_of_q_dot_2_22;
        // u_dot_of_q_dot_2_50 = u_dot_of_q_dot_2_49*d1_of_place_33
        let u_dot_of_q_dot_2_50 = u_dot_of_q_dot_2_49
            .mul_add(
                d1_of_place_33_0,
                d1_of_place_33.mul_add(u_dot_of_q_dot_2_49_0, sums[115]),
            );
        // u_dot_of_place_29 = d1_of_place_26*sin_q_pin1_sin_angle_inv
        let u_dot_of_place_29 = d1_of_place_26
            .mul_add(
                sin_q_pin1_sin_angle_inv_0,
                sin_q_pin1_sin_angle_inv.mul_add(d1_of_place_26_0, sums[116]),
            );
        // u_dot_of_q_dot_2_51 = u_dot_of_q_dot_2_42*u_dot_of_place_29
        let u_dot_of_q_dot_2_51 = u_dot_of_q_dot_2_42
            .mul_add(
                u_dot_of_place_29_0,
                u_dot_of_place_29.mul_add(u_dot_of_q_dot_2_42_0, sums[117]),
            );
        // u_dot_of_motion_13 = weight_2*u_dot_of_motion_3 + minus_9_m_l_g*cos_q +
        //   minus_3_m_l_g*cos_q_plus_q_pin1 + weight_3*u_dot_of_motion_12 + minus_m_l_2*u_dot_of_q_dot_2_46
        //   + minus_2_m_l_2*u_dot_of_q_dot_2_48 + minus_m_l_2*u_dot_of_q_dot_2_50 +
        //   minus_m_l_2*u_dot_of_q_dot_2_51
        let u_dot_of_motion_13 = u_dot_of_q_dot_2_48
            .mul_add(
                minus_2_m_l_2,
                u_dot_of_q_dot_2_51
                    .mul_add(
                        minus_m_l_2,
                        u_dot_of_motion_12
                            .mul_add(
                                weight_3,
                                u_dot_of_q_dot_2_50
                                    .mul_add(
                                        minus_m_l_2,
                                        u_dot_of_q_dot_2_46
                                            .mul_add(
                                                minus_m_l_2,
                                                u_dot_of_motion_3
                                                    .mul_add(
                                                        weight_2,
                                                        cos_q_plus_q_pin1
                                                            .mul_add(minus_3_m_l_g, minus_9_m_l_g * cos_q),
                                                    ),
                                            ),
                                    ),
                            ),
                    ),
            );
        // u_dot_of_motion_14 = u_dot_of_motion_13/d1_of_place_37
        let u_dot_of_motion_14 = u_dot_of_motion_13
            .mul_add(
                over_d1_of_place_37,
                -(d1_of_place_37.mul_add(u_dot_of_motion_14_0, sums[118]) * over_d1_of_place_37),
            );
        // q_ground1_ddot_of_q_dot_2 = u_dot_of_place_5*u_dot_of_q_dot_2_33
        let q_ground1_ddot_of_q_dot_2 = u_dot_of_place_5
            .mul_add(
                u_dot_of_q_dot_2_33_0,
                u_dot_of_q_dot_2_33.mul_add(u_dot_of_place_5_0, sums[119]),
            );
        // q_ground1_ddot_of_motion = u_dot_of_motion_14*sin_q_pin1_sin_angle_inv
        let q_ground1_ddot_of_motion = u_dot_of_motion_14
            .mul_add(
                sin_q_pin1_sin_angle_inv_0,
                sin_q_pin1_sin_angle_inv.mul_add(u_dot_of_motion_14_0, sums[120]),
            );
        // q_ground1_dot_dot = q_ground1_ddot_of_q_dot_2 + 1/6*q_ground1_ddot_of_motion
        let q_ground1_dot_dot = q_ground1_ddot_of_motion
            .mul_add(S::ratio(1, 6), q_ground1_ddot_of_q_dot_2);
        // q_ground2_ddot_of_q_dot_2 = u_dot_of_q_dot_2_33*u_dot_of_place_28
        let q_ground2_ddot_of_q_dot_2 = u_dot_of_place_28
            .mul_add(
                u_dot_of_q_dot_2_33_0,
                u_dot_of_q_dot_2_33.mul_add(u_dot_of_place_28_0, sums[121]),
            );
        // q_ground2_ddot_of_motion = d1_of_place_29*q_ground1_ddot_of_motion
        let q_ground2_ddot_of_motion = q_ground1_ddot_of_motion
            .mul_add(
                d1_of_place_29_0,
                d1_of_place_29.mul_add(q_ground1_ddot_of_motion_0, sums[122]),
            );
        // q_ground2_dot_dot = q_ground2_ddot_of_q_dot_2 + 1/6*q_ground2_ddot_of_motion
        let q_ground2_dot_dot = q_ground2_ddot_of_motion
            .mul_add(S::ratio(1, 6), q_ground2_ddot_of_q_dot_2);
        // q_pin1_ddot_of_motion = u_dot_of_motion_14*d1_of_place_32
        let q_pin1_ddot_of_motion = u_dot_of_motion_14
            .mul_add(
                d1_of_place_32_0,
                d1_of_place_32.mul_add(u_dot_of_motion_14_0, sums[123]),
            );
        // q_pin1_dot_dot = -u_dot_of_q_dot_2_21 + u_dot_of_q_dot_2_22 + 1/6*q_pin1_ddot_of_motion
        let q_pin1_dot_dot = q_pin1_ddot_of_motion
            .mul_add(S::ratio(1, 6), -u_dot_of_q_dot_2_21 + u_dot_of_q_dot_2_22);
        // q_pin2_ddot_of_motion = d1_of_place_25*q_ground1_ddot_of_motion
        let q_pin2_ddot_of_motion = q_ground1_ddot_of_motion
            .mul_add(
                d1_of_place_25_0,
                d1_of_place_25.mul_add(q_ground1_ddot_of_motion_0, sums[124]),
            );
        // q_pin2_dot_dot = u_dot_of_q_dot_2_35 - u_dot_of_q_dot_2_37 - u_dot_of_q_dot_2_39 +
        //   u_dot_of_q_dot_2_41 + 1/6*q_pin2_ddot_of_motion
        let q_pin2_dot_dot = q_pin2_ddot_of_motion
            .mul_add(
                S::ratio(1, 6),
                u_dot_of_q_dot_2_35 - u_dot_of_q_dot_2_37 - u_dot_of_q_dot_2_39
                    + u_dot_of_q_dot_2_41,
            );
        q_2_rate = q_dot_2;
        q_ground1_rate = q_ground1_dot;
        q_ground2_rate = q_ground2_dot;
        q_pin1_rate = q_pin1_dot;
        q_pin2_rate = q_pin2_dot;
        q_dot_2_rate = S::ratio(1, 6) * u_dot_of_motion_14;
        q_ground1_dot_rate = q_ground1_dot_dot;
        q_ground2_dot_rate = q_ground2_dot_dot;
        q_pin1_dot_rate = q_pin1_dot_dot;
        q_pin2_dot_rate = q_pin2_dot_dot;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * q_pin1,
                count * q_pin1,
                count * q_pin2,
                count * q_pin2,
                count * q_2,
                count * q_2,
                count * q_ground1,
                count * q_ground1,
                count * q_2_plus_q_pin1,
                count * q_2_plus_q_pin1,
                count * d1_of_place,
                count * d1_of_place,
                count * q_ground2,
                count * q_ground2,
                count * q_ground1_plus_q_pin2,
                count * q_ground1_plus_q_pin2,
                count * d1_of_place_2,
                count * d1_of_place_2,
                sin_q, cos_q, sin_q_pin1, sin_q, cos_q, cos_q_pin1, sin_q_ground1, cos_q_ground1,
                sin_q_ground2, cos_q_ground2, cos_q_pin1, sin_angle, cos_q_pin2, sin_angle_2,
                cos_q_pin1, sin_angle_2, sin_angle, sin_q_pin1_sin_angle_inv, d1_of_place_22,
                sin_angle_2, d1_of_place_29, d1_of_place_27, sin_angle, d1_of_place_9,
                d1_of_place_32, d1_of_place_25, d1_of_place_26, q_dot_2, q_dot_2, q_dot_2,
                sin_angle, d1_of_place_12, sin_angle, sin_q_pin1, u_dot_of_place_3,
                u_dot_of_q_dot_2, u_dot_of_q_dot_2, sin_angle_2, sin_angle_2, u_dot_of_place_8,
                sin_angle, sin_q_pin1, cos_angle, sin_q_pin2, sin_q_pin1, d1_of_place_25,
                sin_q_pin1, sin_q_pin2, cos_q_plus_q_pin1, sin_q_plus_q_pin1, cos_q_ground1,
                d1_of_q_2_q_pin1_2, sin_q_ground1, sin_q_ground1, d1_of_q_2_q_pin1, cos_q_ground1,
                cos_angle, d1_of_place_32, u_dot_of_q_dot_2_3, u_dot_of_q_dot_2_18,
                cos_q_ground1_plus_q_pin2, sin_q_ground1_plus_q_pin2, cos_q_ground2,
                u_dot_of_q_dot_2_4, sin_q_ground2, sin_q_ground2, u_dot_of_q_dot_2_4, cos_q_ground2,
                q_dot_2_sin_angle_inv, d1_of_place_16, d1_of_place_25, u_dot_of_q_dot_2_3,
                u_dot_of_q_dot_2_5, u_dot_of_q_dot_2_5, u_dot_of_q_dot_2_6, sin_angle_2,
                u_dot_of_q_dot_2_32, q_pin1_dot, sin_q_pin1, q_pin2_dot, q_ground1_dot,
                q_ground1_dot, sin_q_pin2, q_dot_2, d1_of_place_12, cos_q_ground1_plus_q_pin2,
                cos_q_ground2, sin_q_pin1, cos_q_plus_q_pin1, sin_angle, sin_angle,
                u_dot_of_q_dot_2, d1_of_place_22, u_dot_of_place_5, sin_angle_2, u_dot_of_q_dot_2_4,
                u_dot_of_place_28, u_dot_of_q_dot_2_49, d1_of_place_26, u_dot_of_q_dot_2_42,
                d1_of_place_37, u_dot_of_place_5, u_dot_of_motion_14, u_dot_of_q_dot_2_33,
                d1_of_place_29, u_dot_of_motion_14, d1_of_place_25,
            ]),
            padded([
                cos_q_pin1, sin_q_pin1, cos_q_pin2, sin_q_pin2, cos_q, sin_q, cos_q_ground1,
                sin_q_ground1, cos_q_plus_q_pin1, sin_q_plus_q_pin1, cos_angle, sin_angle,
                cos_q_ground2, sin_q_ground2, cos_q_ground1_plus_q_pin2, sin_q_ground1_plus_q_pin2,
                cos_angle_2, sin_angle_2, sin_q_ground1, cos_q_ground1, d1_of_place_5,
                cos_q_ground1, sin_q_ground1, d1_of_place_7, d1_of_q_2_q_pin1_2, d1_of_q_2_q_pin1,
                d1_of_place_4, d1_of_place_3, d1_of_place_12, d1_of_place_18, d1_of_place_15,
                d1_of_place_21, d1_of_place_9, d1_of_place_25, sin_q_pin1_sin_angle_inv,
                sin_q_pin1_sin_angle_inv, d1_of_place_27, d1_of_place_29, d1_of_place_29,
                d1_of_place_30, d1_of_place_32, d1_of_place_33, d1_of_place_33, d1_of_place_27,
                d1_of_place_35, sin_q, cos_q, sin_q_pin1_sin_angle_inv, q_dot_2_sin_angle_inv,
                q_dot_2_sin_angle_inv, u_dot_of_place_2, cos_angle, sin_q_pin1_cos_angle,
                d1_of_place_29, d1_of_place_25, u_dot_of_place_7, u_dot_of_place_9,
                u_dot_of_place_9, sin_angle_inv_cos_angle, u_dot_of_place_11, u_dot_of_place_13,
                u_dot_of_place_15, cos_q_pin2, sin_q_pin1_cos_q_pin2, u_dot_of_place_18,
                d1_of_place_16, u_dot_of_q_dot_2_7, u_dot_of_q_dot_2_7, u_dot_of_q_dot_2,
                u_dot_of_q_dot_2_11, u_dot_of_q_dot_2_13, u_dot_of_q_dot_2, u_dot_of_q_dot_2_15,
                u_dot_of_q_dot_2_10, q_dot_2_sin_angle_inv, u_dot_of_q_dot_2_19,
                u_dot_of_q_dot_2_20, q_dot_2_sin_angle_inv, u_dot_of_q_dot_2_23,
                u_dot_of_q_dot_2_23, d1_of_place_4, u_dot_of_place_22, u_dot_of_q_dot_2_28,
                d1_of_place_3, u_dot_of_place_23, u_dot_of_q_dot_2_26, q_dot_2_sin_angle_inv,
                u_dot_of_q_dot_2_33, u_dot_of_q_dot_2_34, sin_angle_inv_cos_angle,
                u_dot_of_q_dot_2_36, u_dot_of_place_9, u_dot_of_q_dot_2_38, u_dot_of_q_dot_2_40,
                u_dot_of_q_dot_2_40, u_dot_of_motion, u_dot_of_motion_2, q_pin2_dot, d1_of_place_25,
                u_dot_of_motion_5, u_dot_of_motion_7, q_dot_2, q_dot_2_sq, u_dot_of_place_24,
                d1_of_place_29, u_dot_of_motion_9, d1_of_place_12, u_dot_of_motion_12,
                q_dot_2_sin_angle_inv2, q_dot_2_sin_angle_inv2, u_dot_of_q_dot_2_44,
                u_dot_of_q_dot_2_45, u_dot_of_place_28, q_dot_2_sin_angle_inv2, u_dot_of_q_dot_2_47,
                d1_of_place_33, sin_q_pin1_sin_angle_inv, u_dot_of_place_29, u_dot_of_motion_14,
                u_dot_of_q_dot_2_33, sin_q_pin1_sin_angle_inv, u_dot_of_place_28,
                q_ground1_ddot_of_motion, d1_of_place_32, q_ground1_ddot_of_motion,
            ]),
        ];
        count_last = count;
        q_2_last = q_2;
        q_ground1_last = q_ground1;
        q_ground2_last = q_ground2;
        q_pin1_last = q_pin1;
        q_pin2_last = q_pin2;
        q_dot_2_last = q_dot_2;
        q_ground1_dot_last = q_ground1_dot;
        q_pin1_dot_last = q_pin1_dot;
        q_pin2_dot_last = q_pin2_dot;
        sin_q_pin1_last = sin_q_pin1;
        cos_q_pin1_last = cos_q_pin1;
        sin_q_pin2_last = sin_q_pin2;
        cos_q_pin2_last = cos_q_pin2;
        sin_q_last = sin_q;
        cos_q_last = cos_q;
        sin_q_ground1_last = sin_q_ground1;
        cos_q_ground1_last = cos_q_ground1;
        q_2_plus_q_pin1_last = q_2_plus_q_pin1;
        sin_q_plus_q_pin1_last = sin_q_plus_q_pin1;
        cos_q_plus_q_pin1_last = cos_q_plus_q_pin1;
        d1_of_place_last = d1_of_place;
        sin_angle_last = sin_angle;
        cos_angle_last = cos_angle;
        sin_q_ground2_last = sin_q_ground2;
        cos_q_ground2_last = cos_q_ground2;
        q_ground1_plus_q_pin2_last = q_ground1_plus_q_pin2;
        sin_q_ground1_plus_q_pin2_last = sin_q_ground1_plus_q_pin2;
        cos_q_ground1_plus_q_pin2_last = cos_q_ground1_plus_q_pin2;
        d1_of_place_2_last = d1_of_place_2;
        sin_angle_2_last = sin_angle_2;
        cos_angle_2_last = cos_angle_2;
        d1_of_q_2_q_pin1_last = d1_of_q_2_q_pin1;
        d1_of_q_2_q_pin1_2_last = d1_of_q_2_q_pin1_2;
        d1_of_place_3_last = d1_of_place_3;
        d1_of_place_4_last = d1_of_place_4;
        d1_of_place_5_last = d1_of_place_5;
        d1_of_place_7_last = d1_of_place_7;
        d1_of_place_9_last = d1_of_place_9;
        d1_of_place_12_last = d1_of_place_12;
        d1_of_place_15_last = d1_of_place_15;
        d1_of_place_16_last = d1_of_place_16;
        d1_of_place_18_last = d1_of_place_18;
        d1_of_place_21_last = d1_of_place_21;
        d1_of_place_22_last = d1_of_place_22;
        d1_of_place_25_last = d1_of_place_25;
        d1_of_place_26_last = d1_of_place_26;
        sin_q_pin1_sin_angle_inv_last = sin_q_pin1_sin_angle_inv;
        d1_of_place_27_last = d1_of_place_27;
        d1_of_place_29_last = d1_of_place_29;
        d1_of_place_30_last = d1_of_place_30;
        d1_of_place_32_last = d1_of_place_32;
        d1_of_place_33_last = d1_of_place_33;
        d1_of_place_35_last = d1_of_place_35;
        d1_of_place_37_last = d1_of_place_37;
        u_dot_of_q_dot_2_last = u_dot_of_q_dot_2;
        q_dot_2_sin_angle_inv_last = q_dot_2_sin_angle_inv;
        u_dot_of_q_dot_2_3_last = u_dot_of_q_dot_2_3;
        u_dot_of_place_2_last = u_dot_of_place_2;
        u_dot_of_place_3_last = u_dot_of_place_3;
        sin_q_pin1_cos_angle_last = sin_q_pin1_cos_angle;
        u_dot_of_place_5_last = u_dot_of_place_5;
        u_dot_of_q_dot_2_4_last = u_dot_of_q_dot_2_4;
        u_dot_of_q_dot_2_5_last = u_dot_of_q_dot_2_5;
        u_dot_of_q_dot_2_6_last = u_dot_of_q_dot_2_6;
        u_dot_of_place_7_last = u_dot_of_place_7;
        u_dot_of_place_8_last = u_dot_of_place_8;
        u_dot_of_place_9_last = u_dot_of_place_9;
        sin_angle_inv_cos_angle_last = sin_angle_inv_cos_angle;
        u_dot_of_place_11_last = u_dot_of_place_11;
        u_dot_of_place_13_last = u_dot_of_place_13;
        u_dot_of_place_15_last = u_dot_of_place_15;
        sin_q_pin1_cos_q_pin2_last = sin_q_pin1_cos_q_pin2;
        u_dot_of_place_18_last = u_dot_of_place_18;
        u_dot_of_q_dot_2_7_last = u_dot_of_q_dot_2_7;
        u_dot_of_q_dot_2_10_last = u_dot_of_q_dot_2_10;
        u_dot_of_q_dot_2_11_last = u_dot_of_q_dot_2_11;
        u_dot_of_q_dot_2_13_last = u_dot_of_q_dot_2_13;
        u_dot_of_q_dot_2_15_last = u_dot_of_q_dot_2_15;
        u_dot_of_q_dot_2_18_last = u_dot_of_q_dot_2_18;
        u_dot_of_q_dot_2_19_last = u_dot_of_q_dot_2_19;
        u_dot_of_q_dot_2_20_last = u_dot_of_q_dot_2_20;
        u_dot_of_q_dot_2_23_last = u_dot_of_q_dot_2_23;
        u_dot_of_q_dot_2_26_last = u_dot_of_q_dot_2_26;
        u_dot_of_place_22_last = u_dot_of_place_22;
        u_dot_of_q_dot_2_28_last = u_dot_of_q_dot_2_28;
        u_dot_of_place_23_last = u_dot_of_place_23;
        u_dot_of_q_dot_2_32_last = u_dot_of_q_dot_2_32;
        u_dot_of_q_dot_2_33_last = u_dot_of_q_dot_2_33;
        u_dot_of_q_dot_2_34_last = u_dot_of_q_dot_2_34;
        u_dot_of_q_dot_2_36_last = u_dot_of_q_dot_2_36;
        u_dot_of_q_dot_2_38_last = u_dot_of_q_dot_2_38;
        u_dot_of_q_dot_2_40_last = u_dot_of_q_dot_2_40;
        u_dot_of_q_dot_2_42_last = u_dot_of_q_dot_2_42;
        u_dot_of_motion_last = u_dot_of_motion;
        u_dot_of_motion_2_last = u_dot_of_motion_2;
        u_dot_of_motion_5_last = u_dot_of_motion_5;
        u_dot_of_motion_7_last = u_dot_of_motion_7;
        q_dot_2_sq_last = q_dot_2_sq;
        u_dot_of_place_24_last = u_dot_of_place_24;
        u_dot_of_motion_9_last = u_dot_of_motion_9;
        u_dot_of_motion_12_last = u_dot_of_motion_12;
        q_dot_2_sin_angle_inv2_last = q_dot_2_sin_angle_inv2;
        u_dot_of_q_dot_2_44_last = u_dot_of_q_dot_2_44;
        u_dot_of_q_dot_2_45_last = u_dot_of_q_dot_2_45;
        u_dot_of_place_28_last = u_dot_of_place_28;
        u_dot_of_q_dot_2_47_last = u_dot_of_q_dot_2_47;
        u_dot_of_q_dot_2_49_last = u_dot_of_q_dot_2_49;
        u_dot_of_place_29_last = u_dot_of_place_29;
        u_dot_of_motion_14_last = u_dot_of_motion_14;
        q_ground1_ddot_of_motion_last = q_ground1_ddot_of_motion;
    }
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
        out.copy_from_slice(
            jacobian(&Parameters::from_slice(p), array(q), array(v)).as_flattened(),
        );
    }
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, order: usize) -> usize {
        256 * order + SLACK
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
    slice.try_into().expect("a slice of the length that System states")
}
