//! Thin disk sliding on a frictionless plane: Lagrange's equations in q2-90°, E(q) q'' = A(q, q').
//!
//! Generated from `models/disk/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::lagrange::coordinate_rates;

pub use super::kane_q2_90deg::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows q1, q2, q3, q4, q5.
///
/// 18 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _q_dot: &[S; 5],
) -> [[S; 5]; 5] {
    let Parameters { M, R, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let m_r = M * R;
    let r_m_r = R * m_r;
    let r_m_r_times_5_by_4 = S::ratio(5, 4) * r_m_r;
    let r_m_r_halved = S::ratio(1, 2) * r_m_r;
    let cos_q2_minus_90deg_m_r = m_r * cos_q2_minus_90deg;
    let sin_q2_minus_90deg_m_r = m_r * sin_q2_minus_90deg;
    // Entries that are not zero; upper triangle.
    // M11 = M*R^2*(6 - 5*sin(q2_minus_90deg)^2)/4
    let m11 = S::ratio(3, 2) * r_m_r - r_m_r_times_5_by_4 * sin_q2_minus_90deg * sin_q2_minus_90deg;
    // M13 = M*R^2*cos(q2_minus_90deg)/2
    let m13 = r_m_r_halved * cos_q2_minus_90deg;
    // M14 = -M*R*cos(q1)*cos(q2_minus_90deg)
    let m14 = -cos_q2_minus_90deg_m_r * c1;
    // M15 = -M*R*sin(q1)*cos(q2_minus_90deg)
    let m15 = -cos_q2_minus_90deg_m_r * s1;
    // M22 = 5*M*R^2/4
    let m22 = r_m_r_times_5_by_4;
    // M24 = M*R*sin(q1)*sin(q2_minus_90deg)
    let m24 = sin_q2_minus_90deg_m_r * s1;
    // M25 = -M*R*cos(q1)*sin(q2_minus_90deg)
    let m25 = -sin_q2_minus_90deg_m_r * c1;
    // M33 = M*R^2/2
    let m33 = r_m_r_halved;
    // M44 = M
    let m44 = M;
    // M55 = M
    let m55 = M;
    let zero = S::int(0);
    [
        [m11, zero, m13, m14, m15],
        [zero, m22, zero, m24, m25],
        [m13, zero, m33, zero, zero],
        [m14, m24, zero, m44, zero],
        [m15, m25, zero, zero, m55],
    ]
}

/// Right-hand side of the linear system; unknowns (q1'', q2'', q3'', q4'', q5'').
///
/// 34 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> [S; 5] {
    let Parameters { M, R, g } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, _, _] = *q_dot;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let m_r = M * R;
    let sin_q2_minus_90deg_m_r = m_r * sin_q2_minus_90deg;
    let q2_dot_halved = S::ratio(1, 2) * q2_dot;
    let f1_of_q1_dot = q1_dot * sin_q2_minus_90deg_m_r;
    let r_f1_of_q1_dot = R * f1_of_q1_dot;
    let f1_of_q1_dot_2 = r_f1_of_q1_dot * cos_q2_minus_90deg;
    let cos_q2_minus_90deg_m_r = m_r * cos_q2_minus_90deg;
    // cos_q2_minus_90deg_m_r*(q1'^2 + q2'^2)
    let f4_of_motion = cos_q2_minus_90deg_m_r * q2_dot.mul_add(q2_dot, q1_dot * q1_dot);
    let f4_of_motion_2 = S::int(2) * q2_dot * f1_of_q1_dot;
    // Values.
    // f1 = M*R^2*q2'*sin(q2_minus_90deg)*(q3' + 5*q1'*cos(q2_minus_90deg))/2
    let f1 = (R * q3_dot * sin_q2_minus_90deg_m_r)
        .mul_add(q2_dot_halved, S::ratio(5, 2) * q2_dot * f1_of_q1_dot_2);
    // f2 = M*R*(4*g*cos(q2_minus_90deg) - R*q1'*sin(q2_minus_90deg)*(2*q3' + 5*q1'*cos(q2_minus_90deg)))/4
    let f2 = g.mul_add(cos_q2_minus_90deg_m_r, -S::ratio(1, 2) * q3_dot * r_f1_of_q1_dot)
        - S::ratio(5, 4) * q1_dot * f1_of_q1_dot_2;
    // f3 = M*R^2*q1'*q2'*sin(q2_minus_90deg)/2
    let f3 = q2_dot_halved * r_f1_of_q1_dot;
    // f4 = -M*R*(q2'^2*sin(q1)*cos(q2_minus_90deg) + q1'*(2*q2'*cos(q1)*sin(q2_minus_90deg) +
    //   q1'*sin(q1)*cos(q2_minus_90deg)))
    let f4 = (-f4_of_motion_2).mul_add(c1, -f4_of_motion * s1);
    // f5 = M*R*(q2'^2*cos(q1)*cos(q2_minus_90deg) + q1'*(q1'*cos(q1)*cos(q2_minus_90deg) -
    //   2*q2'*sin(q1)*sin(q2_minus_90deg)))
    let f5 = (-f4_of_motion_2).mul_add(s1, f4_of_motion * c1);
    [f1, f2, f3, f4, f5]
}

/// The accelerations (q1'', q2'', q3'', q4'', q5''), solved for when this code was generated.
///
/// 39 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 5] {
    let Parameters { R, g, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, _, _] = *q_dot;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let q2_dot_doubled = S::int(2) * q2_dot;
    // q1'' = 2*q2'*q3'/sin(q2_minus_90deg)
    let q1_ddot = q3_dot * q2_dot_doubled / sin_q2_minus_90deg;
    let q2_dot_sq = q2_dot * q2_dot;
    let q2_ddot_of_place = S::int(4) * cos_q2_minus_90deg;
    // q2'' = (4*g*cos(q2_minus_90deg) + R*sin(q2_minus_90deg)*(4*q2'^2*cos(q2_minus_90deg) - q1'*(2*q3' +
    //   q1'*cos(q2_minus_90deg))))/(R*(5 - 4*sin(q2_minus_90deg)^2))
    let q2_ddot = (R * sin_q2_minus_90deg
        * (q1_dot * q1_dot.mul_add(cos_q2_minus_90deg, S::int(2) * q3_dot)
            - q2_dot_sq * q2_ddot_of_place) - g * q2_ddot_of_place)
        / (R * (S::int(4) * sin_q2_minus_90deg * sin_q2_minus_90deg - S::int(5)));
    // q2''*sin(q2_minus_90deg) + cos(q2_minus_90deg)*(q1'^2 + q2_dot_sq)
    let q5_ddot_of_motion = cos_q2_minus_90deg * q1_dot.mul_add(q1_dot, q2_dot_sq)
        + q2_ddot * sin_q2_minus_90deg;
    let q5_ddot_of_q1_ddot = q1_ddot * cos_q2_minus_90deg;
    let q5_ddot_of_q1_dot = q1_dot * sin_q2_minus_90deg;
    // q5_ddot_of_q1_ddot - q2_dot_doubled*q5_ddot_of_q1_dot
    let q5_ddot_of_motion_2 = (-q2_dot_doubled)
        .mul_add(q5_ddot_of_q1_dot, q5_ddot_of_q1_ddot);
    // q5'' = R*(cos(q1)*(q2''*sin(q2_minus_90deg) + cos(q2_minus_90deg)*(q1'^2 + q2'^2)) +
    //   sin(q1)*(q1''*cos(q2_minus_90deg) - 2*q1'*q2'*sin(q2_minus_90deg)))
    let q5_ddot = R * q5_ddot_of_motion_2.mul_add(s1, q5_ddot_of_motion * c1);
    // q4'' = -R*(sin(q1)*(q2''*sin(q2_minus_90deg) + cos(q2_minus_90deg)*(q1'^2 + q2'^2)) +
    //   cos(q1)*(2*q1'*q2'*sin(q2_minus_90deg) - q1''*cos(q2_minus_90deg)))
    let q4_ddot = R * (-q5_ddot_of_motion).mul_add(s1, q5_ddot_of_motion_2 * c1);
    // q3'' = q1'*q2'*sin(q2_minus_90deg) - q1''*cos(q2_minus_90deg)
    let q3_ddot = q2_dot.mul_add(q5_ddot_of_q1_dot, -q5_ddot_of_q1_ddot);
    [q1_ddot, q2_ddot, q3_ddot, q4_ddot, q5_ddot]
}

/// Kinetic energy T.
///
/// 34 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> S {
    let Parameters { M, R, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let m_r = M * R;
    let energy_of_q1_dot = q1_dot * cos_q2_minus_90deg;
    // q2'^2 + energy_of_q1_dot^2
    let energy_of_motion = energy_of_q1_dot.mul_add(energy_of_q1_dot, q2_dot * q2_dot);
    // q1'^2 + 2*q3'*(q3' + 2*energy_of_q1_dot)
    let energy_of_motion_2 = S::int(2) * q3_dot
        * energy_of_q1_dot.mul_add(S::int(2), q3_dot) + q1_dot * q1_dot;
    // Values.
    // T = M*(4*q4'^2 - R*(8*q2'*sin(q2_minus_90deg)*(q5'*cos(q1) - q4'*sin(q1)) +
    //   8*q1'*cos(q2_minus_90deg)*(q4'*cos(q1) + q5'*sin(q1)) + R*(q1'*(q1'*(5*sin(q2_minus_90deg)^2 - 6) -
    //   4*q3'*cos(q2_minus_90deg)) - 5*q2'^2 - 2*q3'^2)) + 4*q5'^2)/8
    let energy = S::ratio(1, 2) * M * q5_dot.mul_add(q5_dot, q4_dot * q4_dot)
        + m_r
            * (q2_dot * sin_q2_minus_90deg * (-q5_dot).mul_add(c1, q4_dot * s1)
                - energy_of_q1_dot * q5_dot.mul_add(s1, q4_dot * c1))
        + S::ratio(1, 8) * R * m_r * energy_of_motion.mul_add(S::int(5), energy_of_motion_2);
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 5] {
    let [_, q2_minus_90deg, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Values.
    // u1 = -q2'
    let u1_value = -q2_dot;
    // u2 = -q1'*sin(q2_minus_90deg)
    let u2_value = -q1_dot * sin_q2_minus_90deg;
    // u3 = q3' + q1'*cos(q2_minus_90deg)
    let u3_value = q1_dot.mul_add(cos_q2_minus_90deg, q3_dot);
    // u4 = q4'
    let u4_value = q4_dot;
    // u5 = q5'
    let u5_value = q5_dot;
    [u1_value, u2_value, u3_value, u4_value, u5_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 10 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
    v_dot: &[S; 5],
) -> [S; 5] {
    let [_, q2_minus_90deg, _, _, _] = *q;
    let [q1_dot, q2_dot, _, _, _] = *q_dot;
    let [q1_ddot, q2_ddot, q3_ddot, q4_ddot, q5_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Shared terms.
    let q1_dot_q2_dot = q1_dot * q2_dot;
    // Values.
    // u1' = -q2''
    let u1_dot_value = -q2_ddot;
    // u2' = -q1''*sin(q2_minus_90deg) - q1'*q2'*cos(q2_minus_90deg)
    let u2_dot_value = (-q1_dot_q2_dot)
        .mul_add(cos_q2_minus_90deg, -q1_ddot * sin_q2_minus_90deg);
    // u3' = q3'' - q1'*q2'*sin(q2_minus_90deg) + q1''*cos(q2_minus_90deg)
    let u3_dot_value = q1_ddot.mul_add(cos_q2_minus_90deg, q3_ddot)
        - q1_dot_q2_dot * sin_q2_minus_90deg;
    // u4' = q4''
    let u4_dot_value = q4_ddot;
    // u5' = q5''
    let u5_dot_value = q5_ddot;
    [u1_dot_value, u2_dot_value, u3_dot_value, u4_dot_value, u5_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn motion_variables<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 5],
) -> [S; 5] {
    let [_, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3, u4, u5] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Shared terms.
    let q1_dot_value_of_place = u2 / sin_q2_minus_90deg;
    // Values.
    // q1' = -u2/sin(q2_minus_90deg)
    let q1_dot_value = -q1_dot_value_of_place;
    // q2' = -u1
    let q2_dot_value = -u1;
    // q3' = u3 + u2/tan(q2_minus_90deg)
    let q3_dot_value = q1_dot_value_of_place.mul_add(cos_q2_minus_90deg, u3);
    // q4' = u4
    let q4_dot_value = u4;
    // q5' = u5
    let q5_dot_value = u5;
    [q1_dot_value, q2_dot_value, q3_dot_value, q4_dot_value, q5_dot_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 39 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> ([S; 5], [S; 5]) {
    let Parameters { R, g, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let q2_dot_doubled = S::int(2) * q2_dot;
    // q1'' = 2*q2'*q3'/sin(q2_minus_90deg)
    let q1_ddot = q3_dot * q2_dot_doubled / sin_q2_minus_90deg;
    let q2_dot_sq = q2_dot * q2_dot;
    let q2_ddot_of_place = S::int(4) * cos_q2_minus_90deg;
    // q2'' = (4*g*cos(q2_minus_90deg) + R*sin(q2_minus_90deg)*(4*q2'^2*cos(q2_minus_90deg) - q1'*(2*q3' +
    //   q1'*cos(q2_minus_90deg))))/(R*(5 - 4*sin(q2_minus_90deg)^2))
    let q2_ddot = (R * sin_q2_minus_90deg
        * (q1_dot * q1_dot.mul_add(cos_q2_minus_90deg, S::int(2) * q3_dot)
            - q2_dot_sq * q2_ddot_of_place) - g * q2_ddot_of_place)
        / (R * (S::int(4) * sin_q2_minus_90deg * sin_q2_minus_90deg - S::int(5)));
    // q2''*sin(q2_minus_90deg) + cos(q2_minus_90deg)*(q1'^2 + q2_dot_sq)
    let q5_ddot_of_motion = cos_q2_minus_90deg * q1_dot.mul_add(q1_dot, q2_dot_sq)
        + q2_ddot * sin_q2_minus_90deg;
    let q5_ddot_of_q1_ddot = q1_ddot * cos_q2_minus_90deg;
    let q5_ddot_of_q1_dot = q1_dot * sin_q2_minus_90deg;
    // q5_ddot_of_q1_ddot - q2_dot_doubled*q5_ddot_of_q1_dot
    let q5_ddot_of_motion_2 = (-q2_dot_doubled)
        .mul_add(q5_ddot_of_q1_dot, q5_ddot_of_q1_ddot);
    // q5'' = R*(cos(q1)*(q2''*sin(q2_minus_90deg) + cos(q2_minus_90deg)*(q1'^2 + q2'^2)) +
    //   sin(q1)*(q1''*cos(q2_minus_90deg) - 2*q1'*q2'*sin(q2_minus_90deg)))
    let q5_ddot = R * q5_ddot_of_motion_2.mul_add(s1, q5_ddot_of_motion * c1);
    // q4'' = -R*(sin(q1)*(q2''*sin(q2_minus_90deg) + cos(q2_minus_90deg)*(q1'^2 + q2'^2)) +
    //   cos(q1)*(2*q1'*q2'*sin(q2_minus_90deg) - q1''*cos(q2_minus_90deg)))
    let q4_ddot = R * (-q5_ddot_of_motion).mul_add(s1, q5_ddot_of_motion_2 * c1);
    // q3'' = q1'*q2'*sin(q2_minus_90deg) - q1''*cos(q2_minus_90deg)
    let q3_ddot = q2_dot.mul_add(q5_ddot_of_q1_dot, -q5_ddot_of_q1_ddot);
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
    (
        [q1_dot_value, q2_dot_value, q3_dot_value, q4_dot_value, q5_dot_value],
        [q1_ddot, q2_ddot, q3_ddot, q4_ddot, q5_ddot],
    )
}

/// Jacobian of the derivative by the state; columns q1, q2_minus_90deg, q3, q4, q5, q1', q2', q3', q4', q5'.
///
/// 139 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [[S; 10]; 10] {
    let Parameters { R, g, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, _, _] = *q_dot;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let q2_dot_doubled = S::int(2) * q2_dot;
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    let q1_ddot_of_q3_dot = q3_dot * sin_q2_minus_90deg_inv;
    // q1'' = 2*q2'*q3'/sin(q2_minus_90deg)
    let q1_ddot = q2_dot_doubled * q1_ddot_of_q3_dot;
    let q1_dot_sq = q1_dot * q1_dot;
    let q2_dot_sq = q2_dot * q2_dot;
    // 4*q2_dot_sq - q1_dot_sq
    let q2_ddot_of_motion = q2_dot_sq.mul_add(S::int(4), -q1_dot_sq);
    let q2_ddot_of_place = S::int(4) * sin_q2_minus_90deg;
    // 1/(q2_ddot_of_place*sin(q2_minus_90deg) - 5)
    let q2_ddot_of_place_2 = S::int(1) / q2_ddot_of_place.mul_add(sin_q2_minus_90deg, -S::int(5));
    let q2_ddot_of_place_3 = q2_ddot_of_place_2 * sin_q2_minus_90deg;
    let q2_ddot_of_place_4 = q2_ddot_of_place_3 * cos_q2_minus_90deg;
    let r_inv_g = g / R;
    let q2_ddot_of_place_5 = S::int(4) * cos_q2_minus_90deg;
    let q1_dot_doubled = S::int(2) * q1_dot;
    let q2_ddot_of_q3_dot = q3_dot * q2_ddot_of_place_3;
    // q2'' = (4*g*cos(q2_minus_90deg) + R*sin(q2_minus_90deg)*(4*q2'^2*cos(q2_minus_90deg) - q1'*(2*q3' +
    //   q1'*cos(q2_minus_90deg))))/(R*(5 - 4*sin(q2_minus_90deg)^2))
    let q2_ddot = (-q2_ddot_of_motion)
        .mul_add(q2_ddot_of_place_4, q1_dot_doubled * q2_ddot_of_q3_dot)
        - q2_ddot_of_place_2 * r_inv_g * q2_ddot_of_place_5;
    let r_sin_q2_minus_90deg = R * sin_q2_minus_90deg;
    let s1_r_sin_q2_minus_90deg = r_sin_q2_minus_90deg * s1;
    // q1_dot_sq + q2_dot_sq
    let q1_dot_sq_plus_q2_dot_sq = q1_dot_sq + q2_dot_sq;
    let r_cos_q2_minus_90deg = R * cos_q2_minus_90deg;
    let s1_r_cos_q2_minus_90deg = r_cos_q2_minus_90deg * s1;
    let c1_r_cos_q2_minus_90deg = r_cos_q2_minus_90deg * c1;
    let c1_r_sin_q2_minus_90deg = r_sin_q2_minus_90deg * c1;
    let q1_dot_q2_dot_doubled = q1_dot * q2_dot_doubled;
    // q5_ddot_by_q1 = -R*(sin(q1)*(q2''*sin(q2_minus_90deg) + cos(q2_minus_90deg)*(q1'^2 + q2'^2)) +
    //   cos(q1)*(2*q1'*q2'*sin(q2_minus_90deg) - q1''*cos(q2_minus_90deg)))
    let q5_ddot_by_q1 = (-q2_ddot)
        .mul_add(s1_r_sin_q2_minus_90deg, q1_ddot * c1_r_cos_q2_minus_90deg)
        - q1_dot_sq_plus_q2_dot_sq * s1_r_cos_q2_minus_90deg
        - c1_r_sin_q2_minus_90deg * q1_dot_q2_dot_doubled;
    // q4_ddot_by_q1 = -R*(cos(q1)*(q2''*sin(q2_minus_90deg) + cos(q2_minus_90deg)*(q1'^2 + q2'^2)) +
    //   sin(q1)*(q1''*cos(q2_minus_90deg) - 2*q1'*q2'*sin(q2_minus_90deg)))
    let q4_ddot_by_q1 = (-q1_ddot)
        .mul_add(
            s1_r_cos_q2_minus_90deg,
            s1_r_sin_q2_minus_90deg * q1_dot_q2_dot_doubled,
        ) - q1_dot_sq_plus_q2_dot_sq * c1_r_cos_q2_minus_90deg - q2_ddot * c1_r_sin_q2_minus_90deg;
    // q1_ddot_by_q3_dot = 2*q2'/sin(q2_minus_90deg)
    let q1_ddot_by_q3_dot = q2_dot_doubled * sin_q2_minus_90deg_inv;
    let q1_ddot_by_q2_minus_90deg_of_place = q1_ddot_by_q3_dot * cos_q2_minus_90deg;
    // q1_ddot_by_q2_minus_90deg = -2*q2'*q3'/(sin(q2_minus_90deg)*tan(q2_minus_90deg))
    let q1_ddot_by_q2_minus_90deg = -q1_ddot_of_q3_dot * q1_ddot_by_q2_minus_90deg_of_place;
    // 1/(1 + q2_ddot_of_place_5*cos(q2_minus_90deg))
    let q2_ddot_by_q2_minus_90deg_of_place = S::int(1)
        / q2_ddot_of_place_5.mul_add(cos_q2_minus_90deg, S::int(1));
    let q2_ddot_by_q2_minus_90deg_of_place_2 = q2_ddot_by_q2_minus_90deg_of_place
        * cos_q2_minus_90deg;
    let q2_ddot_by_q2_minus_90deg_of_place_3 = q2_ddot_by_q2_minus_90deg_of_place_2
        * q2_ddot_by_q2_minus_90deg_of_place_2;
    let q2_ddot_by_q2_minus_90deg_of_place_4 = q2_ddot_by_q2_minus_90deg_of_place
        * q2_ddot_by_q2_minus_90deg_of_place;
    let q1_dot_q3_dot = q1_dot * q3_dot;
    // q2_ddot_by_q2_minus_90deg = (R*(q1'*(q1' - 2*cos(q2_minus_90deg)*(3*q1'*cos(q2_minus_90deg) + q3'*(9
    //   - 4*cos(q2_minus_90deg)^2))) + 4*q2'^2*(6*cos(q2_minus_90deg)^2 - 1)) +
    //   4*g*sin(q2_minus_90deg)*(4*cos(q2_minus_90deg)^2 - 1))/(R*(1 + 4*cos(q2_minus_90deg)^2)^2)
    let q2_ddot_by_q2_minus_90deg = q2_ddot_of_motion
        * q2_ddot_by_q2_minus_90deg_of_place_3
            .mul_add(S::int(6), -q2_ddot_by_q2_minus_90deg_of_place_4)
        + q2_ddot_of_place * r_inv_g
            * q2_ddot_by_q2_minus_90deg_of_place_3
                .mul_add(S::int(4), -q2_ddot_by_q2_minus_90deg_of_place_4)
        - S::int(18) * q2_ddot_by_q2_minus_90deg_of_place
            * q2_ddot_by_q2_minus_90deg_of_place_2 * q1_dot_q3_dot
        + S::int(8) * q2_ddot_by_q2_minus_90deg_of_place_3 * q1_dot_q3_dot * cos_q2_minus_90deg;
    // q1_dot_q2_dot_doubled - q1_ddot_by_q2_minus_90deg
    let q5_ddot_by_q2_minus_90deg_of_motion = q1_dot_q2_dot_doubled - q1_ddot_by_q2_minus_90deg;
    // q2_ddot_by_q2_minus_90deg - q1_dot_sq_plus_q2_dot_sq
    let q5_ddot_by_q2_minus_90deg_of_motion_2 = q2_ddot_by_q2_minus_90deg
        - q1_dot_sq_plus_q2_dot_sq;
    // q5_ddot_by_q2_minus_90deg = R*(cos(q1)*(q2''*cos(q2_minus_90deg) +
    //   sin(q2_minus_90deg)*(q2_ddot_by_q2_minus_90deg - q1'^2 - q2'^2)) - sin(q1)*(q1''*sin(q2_minus_90deg)
    //   + cos(q2_minus_90deg)*(2*q1'*q2' - q1_ddot_by_q2_minus_90deg)))
    let q5_ddot_by_q2_minus_90deg = (-q1_ddot)
        .mul_add(s1_r_sin_q2_minus_90deg, q2_ddot * c1_r_cos_q2_minus_90deg)
        - s1_r_cos_q2_minus_90deg * q5_ddot_by_q2_minus_90deg_of_motion
        + c1_r_sin_q2_minus_90deg * q5_ddot_by_q2_minus_90deg_of_motion_2;
    // q4_ddot_by_q2_minus_90deg = -R*(cos(q1)*(q1''*sin(q2_minus_90deg) + cos(q2_minus_90deg)*(2*q1'*q2' -
    //   q1_ddot_by_q2_minus_90deg)) + sin(q1)*(q2''*cos(q2_minus_90deg) +
    //   sin(q2_minus_90deg)*(q2_ddot_by_q2_minus_90deg - q1'^2 - q2'^2)))
    let q4_ddot_by_q2_minus_90deg = (-q1_ddot)
        .mul_add(c1_r_sin_q2_minus_90deg, -q2_ddot * s1_r_cos_q2_minus_90deg)
        - c1_r_cos_q2_minus_90deg * q5_ddot_by_q2_minus_90deg_of_motion
        - s1_r_sin_q2_minus_90deg * q5_ddot_by_q2_minus_90deg_of_motion_2;
    // q3_ddot_by_q2_minus_90deg = q1''*sin(q2_minus_90deg) + cos(q2_minus_90deg)*(q1'*q2' -
    //   q1_ddot_by_q2_minus_90deg)
    let q3_ddot_by_q2_minus_90deg = cos_q2_minus_90deg
        * q1_dot.mul_add(q2_dot, -q1_ddot_by_q2_minus_90deg) + q1_ddot * sin_q2_minus_90deg;
    // q2_ddot_by_q1_dot = 2*sin(q2_minus_90deg)*(q3' + q1'*cos(q2_minus_90deg))/(4*sin(q2_minus_90deg)^2 -
    //   5)
    let q2_ddot_by_q1_dot = q2_ddot_of_q3_dot
        .mul_add(S::int(2), q2_ddot_of_place_4 * q1_dot_doubled);
    // q5_ddot_by_q1_dot = R*(cos(q1)*(2*q1'*cos(q2_minus_90deg) + q2_ddot_by_q1_dot*sin(q2_minus_90deg)) -
    //   2*q2'*sin(q1)*sin(q2_minus_90deg))
    let q5_ddot_by_q1_dot = (-q2_dot_doubled)
        .mul_add(s1_r_sin_q2_minus_90deg, q1_dot_doubled * c1_r_cos_q2_minus_90deg)
        + q2_ddot_by_q1_dot * c1_r_sin_q2_minus_90deg;
    // q4_ddot_by_q1_dot = -R*(2*q2'*cos(q1)*sin(q2_minus_90deg) + sin(q1)*(2*q1'*cos(q2_minus_90deg) +
    //   q2_ddot_by_q1_dot*sin(q2_minus_90deg)))
    let q4_ddot_by_q1_dot = (-q1_dot_doubled)
        .mul_add(s1_r_cos_q2_minus_90deg, -q2_ddot_by_q1_dot * s1_r_sin_q2_minus_90deg)
        - q2_dot_doubled * c1_r_sin_q2_minus_90deg;
    // q1_ddot_by_q2_dot = 2*q3'/sin(q2_minus_90deg)
    let q1_ddot_by_q2_dot = S::int(2) * q1_ddot_of_q3_dot;
    // q2_ddot_by_q2_dot = 8*q2'*sin(q2_minus_90deg)*cos(q2_minus_90deg)/(5 - 4*sin(q2_minus_90deg)^2)
    let q2_ddot_by_q2_dot = -S::int(8) * q2_dot * q2_ddot_of_place_4;
    // q5_ddot_by_q2_dot = R*(sin(q1)*(q1_ddot_by_q2_dot*cos(q2_minus_90deg) - 2*q1'*sin(q2_minus_90deg)) +
    //   cos(q1)*(2*q2'*cos(q2_minus_90deg) + q2_ddot_by_q2_dot*sin(q2_minus_90deg)))
    let q5_ddot_by_q2_dot = (-q1_dot_doubled)
        .mul_add(s1_r_sin_q2_minus_90deg, q1_ddot_by_q2_dot * s1_r_cos_q2_minus_90deg)
        + q2_dot_doubled * c1_r_cos_q2_minus_90deg + q2_ddot_by_q2_dot * c1_r_sin_q2_minus_90deg;
    // q4_ddot_by_q2_dot = -R*(cos(q1)*(2*q1'*sin(q2_minus_90deg) - q1_ddot_by_q2_dot*cos(q2_minus_90deg))
    //   + sin(q1)*(2*q2'*cos(q2_minus_90deg) + q2_ddot_by_q2_dot*sin(q2_minus_90deg)))
    let q4_ddot_by_q2_dot = (-q2_ddot_by_q2_dot)
        .mul_add(s1_r_sin_q2_minus_90deg, q1_ddot_by_q2_dot * c1_r_cos_q2_minus_90deg)
        - q2_dot_doubled * s1_r_cos_q2_minus_90deg - q1_dot_doubled * c1_r_sin_q2_minus_90deg;
    // q3_ddot_by_q2_dot = q1'*sin(q2_minus_90deg) - q1_ddot_by_q2_dot*cos(q2_minus_90deg)
    let q3_ddot_by_q2_dot = (-q1_ddot_by_q2_dot)
        .mul_add(cos_q2_minus_90deg, q1_dot * sin_q2_minus_90deg);
    // q2_ddot_by_q3_dot = 2*q1'*sin(q2_minus_90deg)/(4*sin(q2_minus_90deg)^2 - 5)
    let q2_ddot_by_q3_dot = q2_ddot_of_place_3 * q1_dot_doubled;
    // q5_ddot_by_q3_dot = R*(q1_ddot_by_q3_dot*sin(q1)*cos(q2_minus_90deg) +
    //   q2_ddot_by_q3_dot*cos(q1)*sin(q2_minus_90deg))
    let q5_ddot_by_q3_dot = q2_ddot_by_q3_dot
        .mul_add(c1_r_sin_q2_minus_90deg, q1_ddot_by_q3_dot * s1_r_cos_q2_minus_90deg);
    // q4_ddot_by_q3_dot = R*(q1_ddot_by_q3_dot*cos(q1)*cos(q2_minus_90deg) -
    //   q2_ddot_by_q3_dot*sin(q1)*sin(q2_minus_90deg))
    let q4_ddot_by_q3_dot = (-q2_ddot_by_q3_dot)
        .mul_add(s1_r_sin_q2_minus_90deg, q1_ddot_by_q3_dot * c1_r_cos_q2_minus_90deg);
    // Entries that are not zero.
    // d(q1')/d(q1') = 1
    let q1_dot_by_q1_dot_value = S::int(1);
    // d(q2')/d(q2') = 1
    let q2_dot_by_q2_dot_value = S::int(1);
    // d(q3')/d(q3') = 1
    let q3_dot_by_q3_dot_value = S::int(1);
    // d(q4')/d(q4') = 1
    let q4_dot_by_q4_dot_value = S::int(1);
    // d(q5')/d(q5') = 1
    let q5_dot_by_q5_dot_value = S::int(1);
    // d(q3'')/d(q1') = q2'*sin(q2_minus_90deg)
    let q3_ddot_by_q1_dot_value = q2_dot * sin_q2_minus_90deg;
    // d(q3'')/d(q3') = -q1_ddot_by_q3_dot*cos(q2_minus_90deg)
    let q3_ddot_by_q3_dot_value = -q1_ddot_by_q2_minus_90deg_of_place;
    let zero = S::int(0);
    [
        [zero, zero, zero, zero, zero, q1_dot_by_q1_dot_value, zero, zero, zero, zero],
        [zero, zero, zero, zero, zero, zero, q2_dot_by_q2_dot_value, zero, zero, zero],
        [zero, zero, zero, zero, zero, zero, zero, q3_dot_by_q3_dot_value, zero, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, q4_dot_by_q4_dot_value, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, q5_dot_by_q5_dot_value],
        [
            zero, q1_ddot_by_q2_minus_90deg, zero, zero, zero, zero, q1_ddot_by_q2_dot,
            q1_ddot_by_q3_dot, zero, zero,
        ],
        [
            zero, q2_ddot_by_q2_minus_90deg, zero, zero, zero, q2_ddot_by_q1_dot, q2_ddot_by_q2_dot,
            q2_ddot_by_q3_dot, zero, zero,
        ],
        [
            zero, q3_ddot_by_q2_minus_90deg, zero, zero, zero, q3_ddot_by_q1_dot_value,
            q3_ddot_by_q2_dot, q3_ddot_by_q3_dot_value, zero, zero,
        ],
        [
            q4_ddot_by_q1, q4_ddot_by_q2_minus_90deg, zero, zero, zero, q4_ddot_by_q1_dot,
            q4_ddot_by_q2_dot, q4_ddot_by_q3_dot, zero, zero,
        ],
        [
            q5_ddot_by_q1, q5_ddot_by_q2_minus_90deg, zero, zero, zero, q5_ddot_by_q1_dot,
            q5_ddot_by_q2_dot, q5_ddot_by_q3_dot, zero, zero,
        ],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 5], _q_dot: &[S; 5]) -> [S; 1] {
    let [_, q2_minus_90deg, _, _, _] = *q;
    // Sines and cosines.
    let (sin_q2_minus_90deg, _) = q2_minus_90deg.sin_cos();
    // Values.
    // divisor1 = sin(q2_minus_90deg)
    let divisor1 = sin_q2_minus_90deg;
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (q1', q2', q3', q4', q5') that must act beside the loads of the model for the accelerations to be (q1'', q2'', q3'', q4'', q5'').
///
/// 64 operations, 2 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
    v_dot: &[S; 5],
) -> [S; 5] {
    let Parameters { M, R, g } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, _, _] = *q_dot;
    let [q1_ddot, q2_ddot, q3_ddot, q4_ddot, q5_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let m_r = M * R;
    let q1_dot_q2_dot = q1_dot * q2_dot;
    // 2*q1_dot_q2_dot*sin(q2_minus_90deg) - q1''*cos(q2_minus_90deg)
    let tau1_of_motion = (-q1_ddot)
        .mul_add(cos_q2_minus_90deg, S::int(2) * q1_dot_q2_dot * sin_q2_minus_90deg);
    let cos_q2_minus_90deg_m_r = m_r * cos_q2_minus_90deg;
    let r_times_5_by_4 = S::ratio(5, 4) * R;
    let tau1_of_place = cos_q2_minus_90deg_m_r * r_times_5_by_4;
    let sin_q2_minus_90deg_m_r = m_r * sin_q2_minus_90deg;
    let r_halved = S::ratio(1, 2) * R;
    let tau1_of_place_2 = sin_q2_minus_90deg_m_r * r_halved;
    let q3_dot_tau1_of_place_2 = q3_dot * tau1_of_place_2;
    // q4''*cos(q1) + q5''*sin(q1)
    let tau1_of_motion_2 = q5_ddot.mul_add(s1, q4_ddot * c1);
    let q1_dot_sq = q1_dot * q1_dot;
    // q2''*sin_q2_minus_90deg_m_r + cos_q2_minus_90deg_m_r*(q2'^2 + q1_dot_sq)
    let tau4_of_motion = cos_q2_minus_90deg_m_r * q2_dot.mul_add(q2_dot, q1_dot_sq)
        + q2_ddot * sin_q2_minus_90deg_m_r;
    let m_r_tau1_of_motion = m_r * tau1_of_motion;
    // Values.
    // tau1 = M*R^2*q3''*cos(q2_minus_90deg)/2 - M*R*q4''*cos(q1)*cos(q2_minus_90deg) -
    //   M*R*q5''*sin(q1)*cos(q2_minus_90deg) - M*R^2*q2'*sin(q2_minus_90deg)*(q3' +
    //   5*q1'*cos(q2_minus_90deg))/2 + M*R^2*q1''*(6 - 5*sin(q2_minus_90deg)^2)/4
    let tau1 = S::ratio(1, 4) * R * q1_ddot * m_r - tau1_of_motion * tau1_of_place
        - q2_dot * q3_dot_tau1_of_place_2
        + cos_q2_minus_90deg_m_r * q3_ddot.mul_add(r_halved, -tau1_of_motion_2);
    // tau2 = 5*M*R^2*q2''/4 + M*R*q4''*sin(q1)*sin(q2_minus_90deg) - M*R*q5''*cos(q1)*sin(q2_minus_90deg)
    //   + M*R*(R*q1'*sin(q2_minus_90deg)*(2*q3' + 5*q1'*cos(q2_minus_90deg)) - 4*g*cos(q2_minus_90deg))/4
    let tau2 = q2_ddot * m_r * r_times_5_by_4 - g * cos_q2_minus_90deg_m_r
        + sin_q2_minus_90deg_m_r * (-q5_ddot).mul_add(c1, q4_ddot * s1)
        + q1_dot * q3_dot_tau1_of_place_2 + tau1_of_place * q1_dot_sq * sin_q2_minus_90deg;
    // tau3 = M*R^2*q3''/2 - M*R^2*q1'*q2'*sin(q2_minus_90deg)/2 + M*R^2*q1''*cos(q2_minus_90deg)/2
    let tau3 = r_halved * q1_ddot.mul_add(cos_q2_minus_90deg_m_r, q3_ddot * m_r)
        - q1_dot_q2_dot * tau1_of_place_2;
    // tau4 = M*q4'' + M*R*q2''*sin(q1)*sin(q2_minus_90deg) - M*R*q1''*cos(q1)*cos(q2_minus_90deg) +
    //   M*R*(q2'^2*sin(q1)*cos(q2_minus_90deg) + q1'*(2*q2'*cos(q1)*sin(q2_minus_90deg) +
    //   q1'*sin(q1)*cos(q2_minus_90deg)))
    let tau4 = tau4_of_motion.mul_add(s1, M * q4_ddot) + m_r_tau1_of_motion * c1;
    // tau5 = M*q5'' - M*R*q2''*cos(q1)*sin(q2_minus_90deg) - M*R*q1''*sin(q1)*cos(q2_minus_90deg) -
    //   M*R*(q2'^2*cos(q1)*cos(q2_minus_90deg) + q1'*(q1'*cos(q1)*cos(q2_minus_90deg) -
    //   2*q2'*sin(q1)*sin(q2_minus_90deg)))
    let tau5 = (-tau4_of_motion).mul_add(c1, M * q5_ddot) + m_r_tau1_of_motion * s1;
    [tau1, tau2, tau3, tau4, tau5]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 22 convolutions and 36 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 10]],
    history: &mut [Factors<S, 24>],
) {
    let Parameters { R, g, .. } = *p;
    let [q1_0, q2_minus_90deg_0, _, _, _, q1_dot_0, q2_dot_0, q3_dot_0, q4_dot_0,
    q5_dot_0] = series[0];
    // Constant in time.
    // weight = 4*g/R
    let weight = S::int(4) * g / R;
    // minus_r = -R
    let minus_r = -R;
    // Order 0.
    let (sin_q2_minus_90deg_0, cos_q2_minus_90deg_0) = q2_minus_90deg_0.sin_cos();
    let over_sin_q2_minus_90deg = S::int(1) / sin_q2_minus_90deg_0;
    let q2_dot_q3_dot_0 = q2_dot_0 * q3_dot_0;
    let q1_ddot_of_motion_0 = q2_dot_q3_dot_0 * over_sin_q2_minus_90deg;
    let sin_q2_minus_90deg_sq_0 = sin_q2_minus_90deg_0 * sin_q2_minus_90deg_0;
    let q2_dot_sq_0 = q2_dot_0 * q2_dot_0;
    let q2_ddot_of_place_0 = sin_q2_minus_90deg_sq_0.mul_add(S::int(4), -S::int(5));
    let over_q2_ddot_of_place = S::int(1) / q2_ddot_of_place_0;
    let q1_dot_sq_0 = q1_dot_0 * q1_dot_0;
    let q2_ddot_of_q1_dot_0 = q1_dot_0 * sin_q2_minus_90deg_0;
    let q2_ddot_of_motion_0 = q3_dot_0 * q2_ddot_of_q1_dot_0;
    let q2_ddot_of_motion_2_0 = S::int(4) * q2_dot_sq_0 - q1_dot_sq_0;
    let q2_ddot_of_motion_3_0 = sin_q2_minus_90deg_0 * q2_ddot_of_motion_2_0;
    let q2_ddot_of_motion_4_0 = weight + q2_ddot_of_motion_3_0;
    let q2_ddot_of_motion_5_0 = cos_q2_minus_90deg_0 * q2_ddot_of_motion_4_0;
    let q2_ddot_of_motion_6_0 = S::int(2) * q2_ddot_of_motion_0 - q2_ddot_of_motion_5_0;
    let q2_dot_dot_0 = q2_ddot_of_motion_6_0 * over_q2_ddot_of_place;
    let (s1_0, c1_0) = q1_0.sin_cos();
    let q5_ddot_of_motion_0 = q1_ddot_of_motion_0 * cos_q2_minus_90deg_0;
    let q5_ddot_of_motion_2_0 = q2_dot_0 * q2_ddot_of_q1_dot_0;
    let q2_dot_sq_plus_q1_dot_sq_0 = q2_dot_sq_0 + q1_dot_sq_0;
    let q5_ddot_of_motion_3_0 = cos_q2_minus_90deg_0 * q2_dot_sq_plus_q1_dot_sq_0;
    let q5_ddot_of_motion_4_0 = q2_dot_dot_0 * sin_q2_minus_90deg_0;
    let q5_ddot_of_motion_5_0 = q5_ddot_of_motion_3_0 + q5_ddot_of_motion_4_0;
    let q5_ddot_of_motion_6_0 = c1_0 * q5_ddot_of_motion_5_0;
    let q5_ddot_of_motion_7_0 = q5_ddot_of_motion_2_0
        .mul_add(-S::int(2), S::int(2) * q5_ddot_of_motion_0);
    let q5_ddot_of_motion_8_0 = s1_0 * q5_ddot_of_motion_7_0;
    let q5_ddot_of_motion_9_0 = q5_ddot_of_motion_8_0 + q5_ddot_of_motion_6_0;
    let q4_ddot_of_motion_0 = s1_0 * q5_ddot_of_motion_5_0;
    let q4_ddot_of_motion_2_0 = c1_0 * q5_ddot_of_motion_7_0;
    let q4_ddot_of_motion_3_0 = -q4_ddot_of_motion_2_0 + q4_ddot_of_motion_0;
    let q3_dot_dot_0 = -S::int(2) * q5_ddot_of_motion_0 + q5_ddot_of_motion_2_0;
    // Order 1: the rates, and what follows from them.
    let q1_1 = q1_dot_0;
    let q2_minus_90deg_1 = q2_dot_0;
    let q3_1 = q3_dot_0;
    let q4_1 = q4_dot_0;
    let q5_1 = q5_dot_0;
    let q1_dot_1 = S::int(2) * q1_ddot_of_motion_0;
    let q2_dot_1 = q2_dot_dot_0;
    let q3_dot_1 = q3_dot_dot_0;
    let q4_dot_1 = minus_r * q4_ddot_of_motion_3_0;
    let q5_dot_1 = R * q5_ddot_of_motion_9_0;
    if series.len() > 1 {
        series[1] = [
            q1_1, q2_minus_90deg_1, q3_1, q4_1, q5_1, q1_dot_1, q2_dot_1, q3_dot_1, q4_dot_1,
            q5_dot_1,
        ];
    }
    let sin_q2_minus_90deg_1 = q2_minus_90deg_1 * cos_q2_minus_90deg_0;
    let cos_q2_minus_90deg_1 = -q2_minus_90deg_1 * sin_q2_minus_90deg_0;
    let q2_dot_q3_dot_1 = q3_dot_1.mul_add(q2_dot_0, q2_dot_1 * q3_dot_0);
    let q1_ddot_of_motion_1 = sin_q2_minus_90deg_1
        .mul_add(
            -(q1_ddot_of_motion_0 * over_sin_q2_minus_90deg),
            q2_dot_q3_dot_1 * over_sin_q2_minus_90deg,
        );
    let sin_q2_minus_90deg_sq_1 = sin_q2_minus_90deg_1
        * (sin_q2_minus_90deg_0 + sin_q2_minus_90deg_0);
    let q2_dot_sq_1 = q2_dot_1 * (q2_dot_0 + q2_dot_0);
    let q2_ddot_of_place_1 = S::int(4) * sin_q2_minus_90deg_sq_1;
    let q1_dot_sq_1 = q1_dot_1 * (q1_dot_0 + q1_dot_0);
    let q2_ddot_of_q1_dot_1 = sin_q2_minus_90deg_1
        .mul_add(q1_dot_0, q1_dot_1 * sin_q2_minus_90deg_0);
    let q2_ddot_of_motion_1 = q2_ddot_of_q1_dot_1
        .mul_add(q3_dot_0, q3_dot_1 * q2_ddot_of_q1_dot_0);
    let q2_ddot_of_motion_2_1 = S::int(4) * q2_dot_sq_1 - q1_dot_sq_1;
    let q2_ddot_of_motion_3_1 = q2_ddot_of_motion_2_1
        .mul_add(sin_q2_minus_90deg_0, sin_q2_minus_90deg_1 * q2_ddot_of_motion_2_0);
    let q2_ddot_of_motion_4_1 = q2_ddot_of_motion_3_1;
    let q2_ddot_of_motion_5_1 = q2_ddot_of_motion_4_1
        .mul_add(cos_q2_minus_90deg_0, cos_q2_minus_90deg_1 * q2_ddot_of_motion_4_0);
    let q2_ddot_of_motion_6_1 = S::int(2) * q2_ddot_of_motion_1 - q2_ddot_of_motion_5_1;
    let q2_dot_dot_1 = q2_ddot_of_place_1
        .mul_add(
            -(q2_dot_dot_0 * over_q2_ddot_of_place),
            q2_ddot_of_motion_6_1 * over_q2_ddot_of_place,
        );
    let s1_1 = q1_1 * c1_0;
    let c1_1 = -q1_1 * s1_0;
    let q5_ddot_of_motion_1 = q1_ddot_of_motion_1
        .mul_add(cos_q2_minus_90deg_0, cos_q2_minus_90deg_1 * q1_ddot_of_motion_0);
    let q5_ddot_of_motion_2_1 = q2_ddot_of_q1_dot_1
        .mul_add(q2_dot_0, q2_dot_1 * q2_ddot_of_q1_dot_0);
    let q2_dot_sq_plus_q1_dot_sq_1 = q2_dot_sq_1 + q1_dot_sq_1;
    let q5_ddot_of_motion_3_1 = q2_dot_sq_plus_q1_dot_sq_1
        .mul_add(
            cos_q2_minus_90deg_0,
            cos_q2_minus_90deg_1 * q2_dot_sq_plus_q1_dot_sq_0,
        );
    let q5_ddot_of_motion_4_1 = q2_dot_dot_1
        .mul_add(sin_q2_minus_90deg_0, sin_q2_minus_90deg_1 * q2_dot_dot_0);
    let q5_ddot_of_motion_5_1 = q5_ddot_of_motion_3_1 + q5_ddot_of_motion_4_1;
    let q5_ddot_of_motion_6_1 = q5_ddot_of_motion_5_1
        .mul_add(c1_0, c1_1 * q5_ddot_of_motion_5_0);
    let q5_ddot_of_motion_7_1 = q5_ddot_of_motion_2_1
        .mul_add(-S::int(2), S::int(2) * q5_ddot_of_motion_1);
    let q5_ddot_of_motion_8_1 = q5_ddot_of_motion_7_1
        .mul_add(s1_0, s1_1 * q5_ddot_of_motion_7_0);
    let q5_ddot_of_motion_9_1 = q5_ddot_of_motion_8_1 + q5_ddot_of_motion_6_1;
    let q4_ddot_of_motion_1 = q5_ddot_of_motion_5_1
        .mul_add(s1_0, s1_1 * q5_ddot_of_motion_5_0);
    let q4_ddot_of_motion_2_1 = q5_ddot_of_motion_7_1
        .mul_add(c1_0, c1_1 * q5_ddot_of_motion_7_0);
    let q4_ddot_of_motion_3_1 = -q4_ddot_of_motion_2_1 + q4_ddot_of_motion_1;
    let q3_dot_dot_1 = -S::int(2) * q5_ddot_of_motion_1 + q5_ddot_of_motion_2_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                q2_minus_90deg_1, q2_minus_90deg_1, q2_dot_1, sin_q2_minus_90deg_1,
                sin_q2_minus_90deg_1, q2_dot_1, q1_dot_1, q1_dot_1, q3_dot_1, sin_q2_minus_90deg_1,
                cos_q2_minus_90deg_1, q2_ddot_of_place_1, q1_1, q1_1, q1_ddot_of_motion_1, q2_dot_1,
                cos_q2_minus_90deg_1, q2_dot_dot_1, c1_1, s1_1, s1_1, c1_1,
            ]),
            padded([
                cos_q2_minus_90deg_1, sin_q2_minus_90deg_1, q3_dot_1, q1_ddot_of_motion_1,
                sin_q2_minus_90deg_1, q2_dot_1, q1_dot_1, sin_q2_minus_90deg_1, q2_ddot_of_q1_dot_1,
                q2_ddot_of_motion_2_1, q2_ddot_of_motion_4_1, q2_dot_dot_1, c1_1, s1_1,
                cos_q2_minus_90deg_1, q2_ddot_of_q1_dot_1, q2_dot_sq_plus_q1_dot_sq_1,
                sin_q2_minus_90deg_1, q5_ddot_of_motion_5_1, q5_ddot_of_motion_7_1,
                q5_ddot_of_motion_5_1, q5_ddot_of_motion_7_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q1_last = q1_1;
    let mut q2_minus_90deg_last = q2_minus_90deg_1;
    let mut q1_dot_last = q1_dot_1;
    let mut q2_dot_last = q2_dot_1;
    let mut q3_dot_last = q3_dot_1;
    let mut sin_q2_minus_90deg_last = sin_q2_minus_90deg_1;
    let mut cos_q2_minus_90deg_last = cos_q2_minus_90deg_1;
    let mut q1_ddot_of_motion_last = q1_ddot_of_motion_1;
    let mut q2_ddot_of_place_last = q2_ddot_of_place_1;
    let mut q2_ddot_of_q1_dot_last = q2_ddot_of_q1_dot_1;
    let mut q2_ddot_of_motion_2_last = q2_ddot_of_motion_2_1;
    let mut q2_ddot_of_motion_4_last = q2_ddot_of_motion_4_1;
    let mut q2_dot_dot_last = q2_dot_dot_1;
    let mut s1_last = s1_1;
    let mut c1_last = c1_1;
    let mut q2_dot_sq_plus_q1_dot_sq_last = q2_dot_sq_plus_q1_dot_sq_1;
    let mut q5_ddot_of_motion_5_last = q5_ddot_of_motion_5_1;
    let mut q5_ddot_of_motion_7_last = q5_ddot_of_motion_7_1;
    let mut next = [S::int(0); 24];
    // Rates at order k - 1.
    let mut q1_rate = q1_dot_1;
    let mut q2_minus_90deg_rate = q2_dot_1;
    let mut q3_rate = q3_dot_1;
    let mut q4_rate = q4_dot_1;
    let mut q5_rate = q5_dot_1;
    let mut q1_dot_rate = S::int(2) * q1_ddot_of_motion_1;
    let mut q2_dot_rate = q2_dot_dot_1;
    let mut q3_dot_rate = q3_dot_dot_1;
    let mut q4_dot_rate = minus_r * q4_ddot_of_motion_3_1;
    let mut q5_dot_rate = R * q5_ddot_of_motion_9_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q1 = q1_rate * over_k;
        let q2_minus_90deg = q2_minus_90deg_rate * over_k;
        let q3 = q3_rate * over_k;
        let q4 = q4_rate * over_k;
        let q5 = q5_rate * over_k;
        let q1_dot = q1_dot_rate * over_k;
        let q2_dot = q2_dot_rate * over_k;
        let q3_dot = q3_dot_rate * over_k;
        let q4_dot = q4_dot_rate * over_k;
        let q5_dot = q5_dot_rate * over_k;
        series[order] = [
            q1, q2_minus_90deg, q3, q4, q5, q1_dot, q2_dot, q3_dot, q4_dot, q5_dot,
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
                q2_minus_90deg_1
                    .mul_add(
                        cos_q2_minus_90deg_last,
                        (count_last * q2_minus_90deg_last)
                            .mul_add(cos_q2_minus_90deg_1, next[0]),
                    ),
                q2_minus_90deg_1
                    .mul_add(
                        sin_q2_minus_90deg_last,
                        (count_last * q2_minus_90deg_last)
                            .mul_add(sin_q2_minus_90deg_1, next[1]),
                    ),
                q2_dot_1.mul_add(q3_dot_last, q2_dot_last.mul_add(q3_dot_1, next[2])),
                sin_q2_minus_90deg_1
                    .mul_add(
                        q1_ddot_of_motion_last,
                        sin_q2_minus_90deg_last.mul_add(q1_ddot_of_motion_1, next[3]),
                    ),
                (sin_q2_minus_90deg_1 + sin_q2_minus_90deg_1)
                    .mul_add(sin_q2_minus_90deg_last, next[4]),
                (q2_dot_1 + q2_dot_1).mul_add(q2_dot_last, next[5]),
                (q1_dot_1 + q1_dot_1).mul_add(q1_dot_last, next[6]),
                q1_dot_1
                    .mul_add(
                        sin_q2_minus_90deg_last,
                        q1_dot_last.mul_add(sin_q2_minus_90deg_1, next[7]),
                    ),
                q3_dot_1
                    .mul_add(
                        q2_ddot_of_q1_dot_last,
                        q3_dot_last.mul_add(q2_ddot_of_q1_dot_1, next[8]),
                    ),
                sin_q2_minus_90deg_1
                    .mul_add(
                        q2_ddot_of_motion_2_last,
                        sin_q2_minus_90deg_last.mul_add(q2_ddot_of_motion_2_1, next[9]),
                    ),
                cos_q2_minus_90deg_1
                    .mul_add(
                        q2_ddot_of_motion_4_last,
                        cos_q2_minus_90deg_last.mul_add(q2_ddot_of_motion_4_1, next[10]),
                    ),
                q2_ddot_of_place_1
                    .mul_add(
                        q2_dot_dot_last,
                        q2_ddot_of_place_last.mul_add(q2_dot_dot_1, next[11]),
                    ),
                q1_1.mul_add(c1_last, (count_last * q1_last).mul_add(c1_1, next[12])),
                q1_1.mul_add(s1_last, (count_last * q1_last).mul_add(s1_1, next[13])),
                q1_ddot_of_motion_1
                    .mul_add(
                        cos_q2_minus_90deg_last,
                        q1_ddot_of_motion_last.mul_add(cos_q2_minus_90deg_1, next[14]),
                    ),
                q2_dot_1
                    .mul_add(
                        q2_ddot_of_q1_dot_last,
                        q2_dot_last.mul_add(q2_ddot_of_q1_dot_1, next[15]),
                    ),
                cos_q2_minus_90deg_1
                    .mul_add(
                        q2_dot_sq_plus_q1_dot_sq_last,
                        cos_q2_minus_90deg_last
                            .mul_add(q2_dot_sq_plus_q1_dot_sq_1, next[16]),
                    ),
                q2_dot_dot_1
                    .mul_add(
                        sin_q2_minus_90deg_last,
                        q2_dot_dot_last.mul_add(sin_q2_minus_90deg_1, next[17]),
                    ),
                c1_1
                    .mul_add(
                        q5_ddot_of_motion_5_last,
                        c1_last.mul_add(q5_ddot_of_motion_5_1, next[18]),
                    ),
                s1_1
                    .mul_add(
                        q5_ddot_of_motion_7_last,
                        s1_last.mul_add(q5_ddot_of_motion_7_1, next[19]),
                    ),
                s1_1
                    .mul_add(
                        q5_ddot_of_motion_5_last,
                        s1_last.mul_add(q5_ddot_of_motion_5_1, next[20]),
                    ),
                c1_1
                    .mul_add(
                        q5_ddot_of_motion_7_last,
                        c1_last.mul_add(q5_ddot_of_motion_7_1, next[21]),
                    ),
            ])
        };
        // sin_q2_minus_90deg = sin(q2_minus_90deg)
        let sin_q2_minus_90deg = q2_minus_90deg
            .mul_add(cos_q2_minus_90deg_0, sums[0] * over_k);
        // cos_q2_minus_90deg = cos(q2_minus_90deg)
        let cos_q2_minus_90deg = -q2_minus_90deg
            .mul_add(sin_q2_minus_90deg_0, sums[1] * over_k);
        // q2_dot_q3_dot = q2_dot*q3_dot
        let q2_dot_q3_dot = q3_dot.mul_add(q2_dot_0, q2_dot.mul_add(q3_dot_0, sums[2]));
        // q1_ddot_of_motion = q2_dot_q3_dot/sin_q2_minus_90deg
        let q1_ddot_of_motion = sin_q2_minus_90deg
            .mul_add(
                -(q1_ddot_of_motion_0 * over_sin_q2_minus_90deg),
                (q2_dot_q3_dot - sums[3]) * over_sin_q2_minus_90deg,
            );
        // sin_q2_minus_90deg_sq = sin_q2_minus_90deg*sin_q2_minus_90deg
        let sin_q2_minus_90deg_sq = sin_q2_minus_90deg
            .mul_add(sin_q2_minus_90deg_0 + sin_q2_minus_90deg_0, sums[4]);
        // q2_dot_sq = q2_dot*q2_dot
        let q2_dot_sq = q2_dot.mul_add(q2_dot_0 + q2_dot_0, sums[5]);
        // q2_ddot_of_place = -5 + 4*sin_q2_minus_90deg_sq
        let q2_ddot_of_place = S::int(4) * sin_q2_minus_90deg_sq;
        // q1_dot_sq = q1_dot*q1_dot
        let q1_dot_sq = q1_dot.mul_add(q1_dot_0 + q1_dot_0, sums[6]);
        // q2_ddot_of_q1_dot = q1_dot*sin_q2_minus_90deg
        let q2_ddot_of_q1_dot = sin_q2_minus_90deg
            .mul_add(q1_dot_0, q1_dot.mul_add(sin_q2_minus_90deg_0, sums[7]));
        // q2_ddot_of_motion = q3_dot*q2_ddot_of_q1_dot
        let q2_ddot_of_motion = q2_ddot_of_q1_dot
            .mul_add(q3_dot_0, q3_dot.mul_add(q2_ddot_of_q1_dot_0, sums[8]));
        // q2_ddot_of_motion_2 = 4*q2_dot_sq - q1_dot_sq
        let q2_ddot_of_motion_2 = S::int(4) * q2_dot_sq - q1_dot_sq;
        // q2_ddot_of_motion_3 = sin_q2_minus_90deg*q2_ddot_of_motion_2
        let q2_ddot_of_motion_3 = q2_ddot_of_motion_2
            .mul_add(
                sin_q2_minus_90deg_0,
                sin_q2_minus_90deg.mul_add(q2_ddot_of_motion_2_0, sums[9]),
            );
        // q2_ddot_of_motion_4 = weight + q2_ddot_of_motion_3
        let q2_ddot_of_motion_4 = q2_ddot_of_motion_3;
        // q2_ddot_of_motion_5 = cos_q2_minus_90deg*q2_ddot_of_motion_4
        let q2_ddot_of_motion_5 = q2_ddot_of_motion_4
            .mul_add(
                cos_q2_minus_90deg_0,
                cos_q2_minus_90deg.mul_add(q2_ddot_of_motion_4_0, sums[10]),
            );
        // q2_ddot_of_motion_6 = 2*q2_ddot_of_motion - q2_ddot_of_motion_5
        let q2_ddot_of_motion_6 = S::int(2) * q2_ddot_of_motion - q2_ddot_of_motion_5;
        // q2_dot_dot = q2_ddot_of_motion_6/q2_ddot_of_place
        let q2_dot_dot = q2_ddot_of_motion_6
            .mul_add(
                over_q2_ddot_of_place,
                -(q2_ddot_of_place.mul_add(q2_dot_dot_0, sums[11]) * over_q2_ddot_of_place),
            );
        // s1 = sin(q1)
        let s1 = q1.mul_add(c1_0, sums[12] * over_k);
        // c1 = cos(q1)
        let c1 = -q1.mul_add(s1_0, sums[13] * over_k);
        // q5_ddot_of_motion = q1_ddot_of_motion*cos_q2_minus_90deg
        let q5_ddot_of_motion = q1_ddot_of_motion
            .mul_add(
                cos_q2_minus_90deg_0,
                cos_q2_minus_90deg.mul_add(q1_ddot_of_motion_0, sums[14]),
            );
        // q5_ddot_of_motion_2 = q2_dot*q2_ddot_of_q1_dot
        let q5_ddot_of_motion_2 = q2_ddot_of_q1_dot
            .mul_add(q2_dot_0, q2_dot.mul_add(q2_ddot_of_q1_dot_0, sums[15]));
        // q2_dot_sq_plus_q1_dot_sq = q2_dot_sq + q1_dot_sq
        let q2_dot_sq_plus_q1_dot_sq = q2_dot_sq + q1_dot_sq;
        // q5_ddot_of_motion_3 = cos_q2_minus_90deg*q2_dot_sq_plus_q1_dot_sq
        let q5_ddot_of_motion_3 = q2_dot_sq_plus_q1_dot_sq
            .mul_add(
                cos_q2_minus_90deg_0,
                cos_q2_minus_90deg.mul_add(q2_dot_sq_plus_q1_dot_sq_0, sums[16]),
            );
        // q5_ddot_of_motion_4 = q2_dot_dot*sin_q2_minus_90deg
        let q5_ddot_of_motion_4 = q2_dot_dot
            .mul_add(
                sin_q2_minus_90deg_0,
                sin_q2_minus_90deg.mul_add(q2_dot_dot_0, sums[17]),
            );
        // q5_ddot_of_motion_5 = q5_ddot_of_motion_3 + q5_ddot_of_motion_4
        let q5_ddot_of_motion_5 = q5_ddot_of_motion_3 + q5_ddot_of_motion_4;
        // q5_ddot_of_motion_6 = c1*q5_ddot_of_motion_5
        let q5_ddot_of_motion_6 = q5_ddot_of_motion_5
            .mul_add(c1_0, c1.mul_add(q5_ddot_of_motion_5_0, sums[18]));
        // q5_ddot_of_motion_7 = 2*q5_ddot_of_motion - 2*q5_ddot_of_motion_2
        let q5_ddot_of_motion_7 = q5_ddot_of_motion_2
            .mul_add(-S::int(2), S::int(2) * q5_ddot_of_motion);
        // q5_ddot_of_motion_8 = s1*q5_ddot_of_motion_7
        let q5_ddot_of_motion_8 = q5_ddot_of_motion_7
            .mul_add(s1_0, s1.mul_add(q5_ddot_of_motion_7_0, sums[19]));
        // q5_ddot_of_motion_9 = q5_ddot_of_motion_6 + q5_ddot_of_motion_8
        let q5_ddot_of_motion_9 = q5_ddot_of_motion_8 + q5_ddot_of_motion_6;
        // q4_ddot_of_motion = s1*q5_ddot_of_motion_5
        let q4_ddot_of_motion = q5_ddot_of_motion_5
            .mul_add(s1_0, s1.mul_add(q5_ddot_of_motion_5_0, sums[20]));
        // q4_ddot_of_motion_2 = c1*q5_ddot_of_motion_7
        let q4_ddot_of_motion_2 = q5_ddot_of_motion_7
            .mul_add(c1_0, c1.mul_add(q5_ddot_of_motion_7_0, sums[21]));
        // q4_ddot_of_motion_3 = q4_ddot_of_motion - q4_ddot_of_motion_2
        let q4_ddot_of_motion_3 = -q4_ddot_of_motion_2 + q4_ddot_of_motion;
        // q3_dot_dot = -2*q5_ddot_of_motion + q5_ddot_of_motion_2
        let q3_dot_dot = -S::int(2) * q5_ddot_of_motion + q5_ddot_of_motion_2;
        q1_rate = q1_dot;
        q2_minus_90deg_rate = q2_dot;
        q3_rate = q3_dot;
        q4_rate = q4_dot;
        q5_rate = q5_dot;
        q1_dot_rate = S::int(2) * q1_ddot_of_motion;
        q2_dot_rate = q2_dot_dot;
        q3_dot_rate = q3_dot_dot;
        q4_dot_rate = minus_r * q4_ddot_of_motion_3;
        q5_dot_rate = R * q5_ddot_of_motion_9;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * q2_minus_90deg,
                count * q2_minus_90deg,
                q2_dot, sin_q2_minus_90deg, sin_q2_minus_90deg, q2_dot, q1_dot, q1_dot, q3_dot,
                sin_q2_minus_90deg, cos_q2_minus_90deg, q2_ddot_of_place,
                count * q1,
                count * q1,
                q1_ddot_of_motion, q2_dot, cos_q2_minus_90deg, q2_dot_dot, c1, s1, s1, c1,
            ]),
            padded([
                cos_q2_minus_90deg, sin_q2_minus_90deg, q3_dot, q1_ddot_of_motion,
                sin_q2_minus_90deg, q2_dot, q1_dot, sin_q2_minus_90deg, q2_ddot_of_q1_dot,
                q2_ddot_of_motion_2, q2_ddot_of_motion_4, q2_dot_dot, c1, s1, cos_q2_minus_90deg,
                q2_ddot_of_q1_dot, q2_dot_sq_plus_q1_dot_sq, sin_q2_minus_90deg,
                q5_ddot_of_motion_5, q5_ddot_of_motion_7, q5_ddot_of_motion_5, q5_ddot_of_motion_7,
            ]),
        ];
        count_last = count;
        q1_last = q1;
        q2_minus_90deg_last = q2_minus_90deg;
        q1_dot_last = q1_dot;
        q2_dot_last = q2_dot;
        q3_dot_last = q3_dot;
        sin_q2_minus_90deg_last = sin_q2_minus_90deg;
        cos_q2_minus_90deg_last = cos_q2_minus_90deg;
        q1_ddot_of_motion_last = q1_ddot_of_motion;
        q2_ddot_of_place_last = q2_ddot_of_place;
        q2_ddot_of_q1_dot_last = q2_ddot_of_q1_dot;
        q2_ddot_of_motion_2_last = q2_ddot_of_motion_2;
        q2_ddot_of_motion_4_last = q2_ddot_of_motion_4;
        q2_dot_dot_last = q2_dot_dot;
        s1_last = s1;
        c1_last = c1;
        q2_dot_sq_plus_q1_dot_sq_last = q2_dot_sq_plus_q1_dot_sq;
        q5_ddot_of_motion_5_last = q5_ddot_of_motion_5;
        q5_ddot_of_motion_7_last = q5_ddot_of_motion_7;
    }
}

/// Lagrange's equations in q2-90° of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct LagrangeQ290deg;

impl<S: Scalar> System<S> for LagrangeQ290deg {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 3,
            coordinates: 5,
            variables: 5,
            speeds: 5,
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
        10
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
        48 * order + SLACK
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
        ["sin(q2_minus_90deg)"][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
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
