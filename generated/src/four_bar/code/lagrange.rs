//! Four-bar linkage: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/four_bar/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows q1, q2, q3, constraint loop_x, constraint loop_y.
///
/// 29 operations, 3 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    _q_dot: &[S; 3],
) -> [[S; 5]; 5] {
    let Parameters { a, b, c, ma, mb, mc, .. } = *p;
    let [q1, q2, q3] = *q;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let cos_q1_minus_q2 = c1.mul_add(c2, s1 * s2);
    let b_mb = b * mb;
    let m12_of_a_b_mb_q1_q2 = S::ratio(1, 2) * a * cos_q1_minus_q2 * b_mb;
    let a_s1 = a * s1;
    let a_c1 = a * c1;
    let b_s2 = b * s2;
    let b_c2 = b * c2;
    let c_s3 = c * s3;
    let c_c3 = c * c3;
    // Entries that are not zero.
    // M11 = a^2*(ma + 3*mb)/3
    let m11 = S::ratio(1, 3) * a * a * mb.mul_add(S::int(3), ma);
    // M12 = a*b*mb*cos(q1 - q2)/2
    let m12 = m12_of_a_b_mb_q1_q2;
    // M14 = a*sin(q1)
    let m14 = a_s1;
    // M15 = -a*cos(q1)
    let m15 = -a_c1;
    // M21 = a*b*mb*cos(q1 - q2)/2
    let m21 = m12_of_a_b_mb_q1_q2;
    // M22 = b^2*mb/3
    let m22 = S::ratio(1, 3) * b * b_mb;
    // M24 = b*sin(q2)
    let m24 = b_s2;
    // M25 = -b*cos(q2)
    let m25 = -b_c2;
    // M33 = c^2*mc/3
    let m33 = S::ratio(1, 3) * c * c * mc;
    // M34 = -c*sin(q3)
    let m34 = -c_s3;
    // M35 = c*cos(q3)
    let m35 = c_c3;
    // M41 = -a*sin(q1)
    let m41 = -a_s1;
    // M42 = -b*sin(q2)
    let m42 = -b_s2;
    // M43 = c*sin(q3)
    let m43 = c_s3;
    // M51 = a*cos(q1)
    let m51 = a_c1;
    // M52 = b*cos(q2)
    let m52 = b_c2;
    // M53 = -c*cos(q3)
    let m53 = -c_c3;
    let zero = S::int(0);
    [
        [m11, m12, zero, m14, m15],
        [m21, m22, zero, m24, m25],
        [zero, zero, m33, m34, m35],
        [m41, m42, m43, zero, zero],
        [m51, m52, m53, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (q1'', q2'', q3'', lambda_loop_x, lambda_loop_y).
///
/// 40 operations, 3 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], q_dot: &[S; 3]) -> [S; 5] {
    let Parameters { a, b, c, ma, mb, mc, g, .. } = *p;
    let [q1, q2, q3] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // sin(q1)*cos(q2) - cos(q1)*sin(q2)
    let sin_q1_minus_q2 = (-c1).mul_add(s2, s1 * c2);
    let b_q2_dot_sq = b * q2_dot * q2_dot;
    let a_q1_dot_sq = a * q1_dot * q1_dot;
    let c_c3 = c * c3;
    let q3_dot_sq = q3_dot * q3_dot;
    // Values.
    // f1 = -a*(g*cos(q1)*(ma + 2*mb) + b*mb*q2'^2*sin(q1 - q2))/2
    let f1 = -S::ratio(1, 2) * a
        * (g * c1 * mb.mul_add(S::int(2), ma) + mb * sin_q1_minus_q2 * b_q2_dot_sq);
    // f2 = b*mb*(a*q1'^2*sin(q1 - q2) - g*cos(q2))/2
    let f2 = S::ratio(1, 2) * b * mb * (-g).mul_add(c2, sin_q1_minus_q2 * a_q1_dot_sq);
    // f3 = -c*mc*g*cos(q3)/2
    let f3 = -S::ratio(1, 2) * mc * g * c_c3;
    // f4 = a*q1'^2*cos(q1) + b*q2'^2*cos(q2) - c*q3'^2*cos(q3)
    let f4 = a_q1_dot_sq.mul_add(c1, b_q2_dot_sq * c2) - c_c3 * q3_dot_sq;
    // f5 = a*q1'^2*sin(q1) + b*q2'^2*sin(q2) - c*q3'^2*sin(q3)
    let f5 = a_q1_dot_sq.mul_add(s1, b_q2_dot_sq * s2) - c * q3_dot_sq * s3;
    [f1, f2, f3, f4, f5]
}

/// The accelerations (q1'', q2'', q3''), solved for when this code was generated.
///
/// 89 operations, 4 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 3] {
    let Parameters { a, b, c, ma, mb, mc, g, .. } = *p;
    let [q1, q2, q3] = *q;
    let [q1_dot, q2_dot, _] = *q_dot;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // cos(q1)*sin(q2) - sin(q1)*cos(q2)
    let c1_s2_minus_c2_s1 = (-s1).mul_add(c2, c1 * s2);
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let c1_c2_plus_s1_s2 = c1.mul_add(c2, s1 * s2);
    // q2 - q3
    let q2_minus_q3 = q2 - q3;
    let (sin_q2_minus_q3, cos_q2_minus_q3) = q2_minus_q3.sin_cos();
    let sin_q2_minus_q3_inv = S::int(1) / sin_q2_minus_q3;
    let u1_dot_of_q1_q2_q3 = c1_s2_minus_c2_s1 * sin_q2_minus_q3_inv;
    let u1_dot_of_q1_q2_q3_2 = u1_dot_of_q1_q2_q3 * cos_q2_minus_q3;
    // cos(q1)*sin(q3) - sin(q1)*cos(q3)
    let c1_s3_minus_c3_s1 = (-s1).mul_add(c3, c1 * s3);
    let b_inv = S::int(1) / b;
    let c1_s3_minus_c3_s1_b_inv = c1_s3_minus_c3_s1 * b_inv;
    let c_inv = S::int(1) / c;
    let c1_s2_minus_c2_s1_c_inv = c1_s2_minus_c2_s1 * c_inv;
    let a_sin_q2_minus_q3_inv = a * sin_q2_minus_q3_inv;
    // c1_c2_plus_s1_s2 - a_sin_q2_minus_q3_inv*(c1_s3_minus_c3_s1_b_inv*(c1_c2_plus_s1_s2 -
    //   u1_dot_of_q1_q2_q3_2) + u1_dot_of_q1_q2_q3_2*c1_s2_minus_c2_s1_c_inv)
    let u1_dot_of_place = c1_c2_plus_s1_s2
        - a_sin_q2_minus_q3_inv
            * (c1_s3_minus_c3_s1_b_inv * (c1_c2_plus_s1_s2 - u1_dot_of_q1_q2_q3_2)
                + u1_dot_of_q1_q2_q3_2 * c1_s2_minus_c2_s1_c_inv);
    let u1_dot_of_q1_dot = q1_dot * a_sin_q2_minus_q3_inv;
    let u1_dot_of_q1_q2_q3_3 = sin_q2_minus_q3_inv * c1_s3_minus_c3_s1;
    let c1_c2_plus_s1_s2_times_3 = S::int(3) * c1_c2_plus_s1_s2;
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let c1_c3_plus_s1_s3 = c1.mul_add(c3, s1 * s3);
    let u1_dot_of_q1_q2_q3_4 = u1_dot_of_q1_q2_q3_3 * cos_q2_minus_q3;
    let q1_dot_u1_dot_of_q1_dot = q1_dot * u1_dot_of_q1_dot;
    // q1_dot_u1_dot_of_q1_dot*(c1_c3_plus_s1_s3 +
    //   a_sin_q2_minus_q3_inv*(c1_s3_minus_c3_s1_b_inv*u1_dot_of_q1_q2_q3_4 -
    //   c1_s2_minus_c2_s1_c_inv*(c1_c3_plus_s1_s3 + u1_dot_of_q1_q2_q3_4)))
    let u1_dot_of_q1_dot_2 = q1_dot_u1_dot_of_q1_dot
        * (c1_c3_plus_s1_s3
            + a_sin_q2_minus_q3_inv
                * (-c1_s2_minus_c2_s1_c_inv * (c1_c3_plus_s1_s3 + u1_dot_of_q1_q2_q3_4)
                    + c1_s3_minus_c3_s1_b_inv * u1_dot_of_q1_q2_q3_4));
    let mc_u1_dot_of_q1_q2_q3 = mc * u1_dot_of_q1_q2_q3;
    // mb*(g*(2*cos(q1) + u1_dot_of_q1_q2_q3_3*cos(q2)) +
    //   c1_s2_minus_c2_s1*(c1_s3_minus_c3_s1*q1_dot_u1_dot_of_q1_dot - b*q2'^2)) + g*(ma*cos(q1) +
    //   mc_u1_dot_of_q1_q2_q3*cos(q3))
    let u1_dot_of_motion = mb
        * (g * u1_dot_of_q1_q2_q3_3.mul_add(c2, S::int(2) * c1)
            + c1_s2_minus_c2_s1
                * c1_s3_minus_c3_s1
                    .mul_add(q1_dot_u1_dot_of_q1_dot, -b * q2_dot * q2_dot))
        + g * mc_u1_dot_of_q1_q2_q3.mul_add(c3, ma * c1);
    let a_inv = S::int(1) / a;
    // u1' = -(2*a^2*mc*q1'^2*sin(q1 - q2)*(cos(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) + sin(q1 -
    //   q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3))/sin(q2 - q3)^2 +
    //   a^2*mb*q1'^2*(cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 - q3)) + sin(q1 - q2)*(sin(q1 - q3)/tan(q3
    //   - q2) + cos(q1 - q3))/c)/sin(q2 - q3))*(2*sin(q1 - q3)/sin(q2 - q3) - 3*cos(q1 - q2))/sin(q2 - q3) +
    //   3*a*(g*(ma*cos(q1) - mc*sin(q1 - q2)*cos(q3)/sin(q2 - q3)) + mb*(g*(2*cos(q1) - cos(q2)*sin(q1 -
    //   q3)/sin(q2 - q3)) + sin(q1 - q2)*(a*q1'^2*sin(q1 - q3)/sin(q2 - q3) + b*q2'^2))))/(2*a^2*(ma +
    //   mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 -
    //   q3))/sin(q2 - q3))))
    let u1_dot = S::ratio(1, 2) * a_inv * a_inv
        * (S::int(2) * mc * c1_s2_minus_c2_s1 * u1_dot_of_place * u1_dot_of_q1_dot
            * u1_dot_of_q1_dot
            + a
                * (mb * u1_dot_of_q1_dot_2
                    * u1_dot_of_q1_q2_q3_3.mul_add(S::int(2), c1_c2_plus_s1_s2_times_3)
                    - S::int(3) * u1_dot_of_motion))
        / (ma
            + mb
                * (S::int(3)
                    + u1_dot_of_q1_q2_q3_3 * (u1_dot_of_q1_q2_q3_3 + c1_c2_plus_s1_s2_times_3))
            + u1_dot_of_q1_q2_q3 * mc_u1_dot_of_q1_q2_q3);
    // q1'' = u1'
    let q1_ddot = u1_dot;
    let q2_ddot_of_u1_dot = u1_dot * a_sin_q2_minus_q3_inv;
    // q2'' = -a*q1'^2*(cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 - q3)) + sin(q1 - q2)*(sin(q1 -
    //   q3)/tan(q3 - q2) + cos(q1 - q3))/c)/sin(q2 - q3))/(b*sin(q2 - q3)) - a*u1'*sin(q1 - q3)/(b*sin(q2 -
    //   q3))
    let q2_ddot = (-b_inv)
        .mul_add(u1_dot_of_q1_dot_2, c1_s3_minus_c3_s1_b_inv * q2_ddot_of_u1_dot);
    // q3'' = -a*q1'^2*(cos(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) + sin(q1 - q3)*(cos(q1 - q2) +
    //   sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3))/(c*sin(q2 - q3)) - a*u1'*sin(q1 - q2)/(c*sin(q2 - q3))
    let q3_ddot = (-(c_inv * u1_dot_of_place))
        .mul_add(q1_dot_u1_dot_of_q1_dot, c1_s2_minus_c2_s1_c_inv * q2_ddot_of_u1_dot);
    [q1_ddot, q2_ddot, q3_ddot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 3] {
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Values.
    // q1'
    let q1_dot_value = q1_dot;
    // q2'
    let q2_dot_value = q2_dot;
    // q3'
    let q3_dot_value = q3_dot;
    [q1_dot_value, q2_dot_value, q3_dot_value]
}

/// Kinetic energy T.
///
/// 18 operations, 1 sine and cosine.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3], q_dot: &[S; 3]) -> S {
    let Parameters { a, b, c, ma, mb, mc, .. } = *p;
    let [q1, q2, _] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Shared terms.
    let c_q3_dot = c * q3_dot;
    let a_q1_dot = a * q1_dot;
    let b_q2_dot = b * q2_dot;
    // Sines and cosines.
    let (_, cos_q1_minus_q2) = (q1 - q2).sin_cos();
    // a_q1_dot^2*(ma + 3*mb) + mb*b_q2_dot*(3*a_q1_dot*cos(q1 - q2) + b_q2_dot)
    let energy_of_motion = a_q1_dot * a_q1_dot * mb.mul_add(S::int(3), ma)
        + mb * b_q2_dot * (a_q1_dot * cos_q1_minus_q2).mul_add(S::int(3), b_q2_dot);
    // mc*c_q3_dot^2 + energy_of_motion
    let energy_of_motion_2 = mc * c_q3_dot * c_q3_dot + energy_of_motion;
    // Values.
    // T = a^2*q1'^2*(ma + 3*mb)/6 + b^2*mb*q2'^2/6 + a*b*mb*q1'*q2'*cos(q1 - q2)/2 + c^2*mc*q3'^2/6
    let energy = S::ratio(1, 6) * energy_of_motion_2;
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 0 operations.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 1] {
    let [q1_dot, _, _] = *q_dot;
    // Values.
    // u1 = q1'
    let u1_value = q1_dot;
    [u1_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 0 operations.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 3],
    _q_dot: &[S; 3],
    v_dot: &[S; 3],
) -> [S; 1] {
    let [q1_ddot, _, _] = *v_dot;
    // Values.
    // u1' = q1''
    let u1_dot_value = q1_ddot;
    [u1_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 13 operations, 3 sines and cosines.
#[must_use]
pub fn motion_variables<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [S; 3] {
    let Parameters { a, b, c, .. } = *p;
    let [q1, q2, q3] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_q2_minus_q3, _) = (q2 - q3).sin_cos();
    let (sin_q1_minus_q3, _) = (q1 - q3).sin_cos();
    let (sin_q1_minus_q2, _) = (q1 - q2).sin_cos();
    // Values.
    // q1' = u1
    let q1_dot_value = u1;
    // q2' = -a*u1*sin(q1 - q3)/(b*sin(q2 - q3))
    let q2_dot_value = -a * u1 * sin_q1_minus_q3 / (b * sin_q2_minus_q3);
    // q3' = -a*u1*sin(q1 - q2)/(c*sin(q2 - q3))
    let q3_dot_value = -a * u1 * sin_q1_minus_q2 / (c * sin_q2_minus_q3);
    [q1_dot_value, q2_dot_value, q3_dot_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 89 operations, 4 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> ([S; 3], [S; 3]) {
    let Parameters { a, b, c, ma, mb, mc, g, .. } = *p;
    let [q1, q2, q3] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // cos(q1)*sin(q2) - sin(q1)*cos(q2)
    let c1_s2_minus_c2_s1 = (-s1).mul_add(c2, c1 * s2);
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let c1_c2_plus_s1_s2 = c1.mul_add(c2, s1 * s2);
    // q2 - q3
    let q2_minus_q3 = q2 - q3;
    let (sin_q2_minus_q3, cos_q2_minus_q3) = q2_minus_q3.sin_cos();
    let sin_q2_minus_q3_inv = S::int(1) / sin_q2_minus_q3;
    let u1_dot_of_q1_q2_q3 = c1_s2_minus_c2_s1 * sin_q2_minus_q3_inv;
    let u1_dot_of_q1_q2_q3_2 = u1_dot_of_q1_q2_q3 * cos_q2_minus_q3;
    // cos(q1)*sin(q3) - sin(q1)*cos(q3)
    let c1_s3_minus_c3_s1 = (-s1).mul_add(c3, c1 * s3);
    let b_inv = S::int(1) / b;
    let c1_s3_minus_c3_s1_b_inv = c1_s3_minus_c3_s1 * b_inv;
    let c_inv = S::int(1) / c;
    let c1_s2_minus_c2_s1_c_inv = c1_s2_minus_c2_s1 * c_inv;
    let a_sin_q2_minus_q3_inv = a * sin_q2_minus_q3_inv;
    // c1_c2_plus_s1_s2 - a_sin_q2_minus_q3_inv*(c1_s3_minus_c3_s1_b_inv*(c1_c2_plus_s1_s2 -
    //   u1_dot_of_q1_q2_q3_2) + u1_dot_of_q1_q2_q3_2*c1_s2_minus_c2_s1_c_inv)
    let u1_dot_of_place = c1_c2_plus_s1_s2
        - a_sin_q2_minus_q3_inv
            * (c1_s3_minus_c3_s1_b_inv * (c1_c2_plus_s1_s2 - u1_dot_of_q1_q2_q3_2)
                + u1_dot_of_q1_q2_q3_2 * c1_s2_minus_c2_s1_c_inv);
    let u1_dot_of_q1_dot = q1_dot * a_sin_q2_minus_q3_inv;
    let u1_dot_of_q1_q2_q3_3 = sin_q2_minus_q3_inv * c1_s3_minus_c3_s1;
    let c1_c2_plus_s1_s2_times_3 = S::int(3) * c1_c2_plus_s1_s2;
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let c1_c3_plus_s1_s3 = c1.mul_add(c3, s1 * s3);
    let u1_dot_of_q1_q2_q3_4 = u1_dot_of_q1_q2_q3_3 * cos_q2_minus_q3;
    let q1_dot_u1_dot_of_q1_dot = q1_dot * u1_dot_of_q1_dot;
    // q1_dot_u1_dot_of_q1_dot*(c1_c3_plus_s1_s3 +
    //   a_sin_q2_minus_q3_inv*(c1_s3_minus_c3_s1_b_inv*u1_dot_of_q1_q2_q3_4 -
    //   c1_s2_minus_c2_s1_c_inv*(c1_c3_plus_s1_s3 + u1_dot_of_q1_q2_q3_4)))
    let u1_dot_of_q1_dot_2 = q1_dot_u1_dot_of_q1_dot
        * (c1_c3_plus_s1_s3
            + a_sin_q2_minus_q3_inv
                * (-c1_s2_minus_c2_s1_c_inv * (c1_c3_plus_s1_s3 + u1_dot_of_q1_q2_q3_4)
                    + c1_s3_minus_c3_s1_b_inv * u1_dot_of_q1_q2_q3_4));
    let mc_u1_dot_of_q1_q2_q3 = mc * u1_dot_of_q1_q2_q3;
    // mb*(g*(2*cos(q1) + u1_dot_of_q1_q2_q3_3*cos(q2)) +
    //   c1_s2_minus_c2_s1*(c1_s3_minus_c3_s1*q1_dot_u1_dot_of_q1_dot - b*q2'^2)) + g*(ma*cos(q1) +
    //   mc_u1_dot_of_q1_q2_q3*cos(q3))
    let u1_dot_of_motion = mb
        * (g * u1_dot_of_q1_q2_q3_3.mul_add(c2, S::int(2) * c1)
            + c1_s2_minus_c2_s1
                * c1_s3_minus_c3_s1
                    .mul_add(q1_dot_u1_dot_of_q1_dot, -b * q2_dot * q2_dot))
        + g * mc_u1_dot_of_q1_q2_q3.mul_add(c3, ma * c1);
    let a_inv = S::int(1) / a;
    // u1' = -(2*a^2*mc*q1'^2*sin(q1 - q2)*(cos(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) + sin(q1 -
    //   q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3))/sin(q2 - q3)^2 +
    //   a^2*mb*q1'^2*(cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 - q3)) + sin(q1 - q2)*(sin(q1 - q3)/tan(q3
    //   - q2) + cos(q1 - q3))/c)/sin(q2 - q3))*(2*sin(q1 - q3)/sin(q2 - q3) - 3*cos(q1 - q2))/sin(q2 - q3) +
    //   3*a*(g*(ma*cos(q1) - mc*sin(q1 - q2)*cos(q3)/sin(q2 - q3)) + mb*(g*(2*cos(q1) - cos(q2)*sin(q1 -
    //   q3)/sin(q2 - q3)) + sin(q1 - q2)*(a*q1'^2*sin(q1 - q3)/sin(q2 - q3) + b*q2'^2))))/(2*a^2*(ma +
    //   mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 -
    //   q3))/sin(q2 - q3))))
    let u1_dot = S::ratio(1, 2) * a_inv * a_inv
        * (S::int(2) * mc * c1_s2_minus_c2_s1 * u1_dot_of_place * u1_dot_of_q1_dot
            * u1_dot_of_q1_dot
            + a
                * (mb * u1_dot_of_q1_dot_2
                    * u1_dot_of_q1_q2_q3_3.mul_add(S::int(2), c1_c2_plus_s1_s2_times_3)
                    - S::int(3) * u1_dot_of_motion))
        / (ma
            + mb
                * (S::int(3)
                    + u1_dot_of_q1_q2_q3_3 * (u1_dot_of_q1_q2_q3_3 + c1_c2_plus_s1_s2_times_3))
            + u1_dot_of_q1_q2_q3 * mc_u1_dot_of_q1_q2_q3);
    // q1'' = u1'
    let q1_ddot = u1_dot;
    let q2_ddot_of_u1_dot = u1_dot * a_sin_q2_minus_q3_inv;
    // q2'' = -a*q1'^2*(cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 - q3)) + sin(q1 - q2)*(sin(q1 -
    //   q3)/tan(q3 - q2) + cos(q1 - q3))/c)/sin(q2 - q3))/(b*sin(q2 - q3)) - a*u1'*sin(q1 - q3)/(b*sin(q2 -
    //   q3))
    let q2_ddot = (-b_inv)
        .mul_add(u1_dot_of_q1_dot_2, c1_s3_minus_c3_s1_b_inv * q2_ddot_of_u1_dot);
    // q3'' = -a*q1'^2*(cos(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) + sin(q1 - q3)*(cos(q1 - q2) +
    //   sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3))/(c*sin(q2 - q3)) - a*u1'*sin(q1 - q2)/(c*sin(q2 - q3))
    let q3_ddot = (-(c_inv * u1_dot_of_place))
        .mul_add(q1_dot_u1_dot_of_q1_dot, c1_s2_minus_c2_s1_c_inv * q2_ddot_of_u1_dot);
    // Values.
    // q1'
    let q1_dot_value = q1_dot;
    // q2'
    let q2_dot_value = q2_dot;
    // q3'
    let q3_dot_value = q3_dot;
    ([q1_dot_value, q2_dot_value, q3_dot_value], [q1_ddot, q2_ddot, q3_ddot])
}

/// Jacobian of the derivative by the state; columns q1, q2, q3, q1', q2', q3'.
///
/// 396 operations, 4 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> [[S; 6]; 6] {
    let Parameters { a, b, c, ma, mb, mc, g, .. } = *p;
    let [q1, q2, q3] = *q;
    let [q1_dot, q2_dot, _] = *q_dot;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s3, c3) = q3.sin_cos();
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // sin(q1)*cos(q3) - cos(q1)*sin(q3)
    let sin_q1_minus_q3 = (-c1).mul_add(s3, s1 * c3);
    // q2 - q3
    let q2_minus_q3 = q2 - q3;
    let (sin_q2_minus_q3, cos_q2_minus_q3) = q2_minus_q3.sin_cos();
    let sin_q2_minus_q3_inv = S::int(1) / sin_q2_minus_q3;
    let u1_dot_of_q1_q2_q3 = sin_q1_minus_q3 * sin_q2_minus_q3_inv;
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let cos_q1_minus_q2 = c1.mul_add(c2, s1 * s2);
    let cos_q1_minus_q2_times_3 = S::int(3) * cos_q1_minus_q2;
    // cos_q1_minus_q2_times_3 - u1_dot_of_q1_q2_q3
    let u1_dot_of_q1_q2_q3_2 = cos_q1_minus_q2_times_3 - u1_dot_of_q1_q2_q3;
    // sin(q1)*cos(q2) - cos(q1)*sin(q2)
    let sin_q1_minus_q2 = (-c1).mul_add(s2, s1 * c2);
    let mc_sin_q1_minus_q2 = mc * sin_q1_minus_q2;
    let u1_dot_of_mc_q1_q2_q3 = sin_q2_minus_q3_inv * mc_sin_q1_minus_q2;
    let u1_dot_of_mc_q1_q2_q3_2 = sin_q2_minus_q3_inv * u1_dot_of_mc_q1_q2_q3;
    // 1/(ma + mb*(3 - u1_dot_of_q1_q2_q3*u1_dot_of_q1_q2_q3_2) + sin(q1 - q2)*u1_dot_of_mc_q1_q2_q3_2)
    let u1_dot_of_place = S::int(1)
        / (ma + mb * (-u1_dot_of_q1_q2_q3).mul_add(u1_dot_of_q1_q2_q3_2, S::int(3))
            + sin_q1_minus_q2 * u1_dot_of_mc_q1_q2_q3_2);
    let a_sin_q2_minus_q3_inv = a * sin_q2_minus_q3_inv;
    let u1_dot_of_q1_dot = q1_dot * a_sin_q2_minus_q3_inv;
    let q1_dot_u1_dot_of_q1_dot = q1_dot * u1_dot_of_q1_dot;
    let b_inv = S::int(1) / b;
    let sin_q1_minus_q3_b_inv = sin_q1_minus_q3 * b_inv;
    let c_inv = S::int(1) / c;
    let sin_q1_minus_q2_c_inv = sin_q1_minus_q2 * c_inv;
    // sin_q1_minus_q3_b_inv - sin_q1_minus_q2_c_inv
    let u1_dot_of_b_c_q1_q2_q3 = sin_q1_minus_q3_b_inv - sin_q1_minus_q2_c_inv;
    let u1_dot_of_q2_q3 = sin_q2_minus_q3_inv * cos_q2_minus_q3;
    let u1_dot_of_q1_q2_q3_3 = sin_q1_minus_q2 * u1_dot_of_q2_q3;
    // cos(q1 - q2)*sin_q1_minus_q3_b_inv + u1_dot_of_b_c_q1_q2_q3*u1_dot_of_q1_q2_q3_3
    let u1_dot_of_b_c_q1_q2_q3_2 = u1_dot_of_b_c_q1_q2_q3
        .mul_add(u1_dot_of_q1_q2_q3_3, cos_q1_minus_q2 * sin_q1_minus_q3_b_inv);
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let cos_q1_minus_q3 = c1.mul_add(c3, s1 * s3);
    let u1_dot_of_q1_q2_q3_4 = sin_q1_minus_q3 * u1_dot_of_q2_q3;
    // cos(q1 - q3)*sin_q1_minus_q2_c_inv + u1_dot_of_b_c_q1_q2_q3*u1_dot_of_q1_q2_q3_4
    let u1_dot_of_b_c_q1_q2_q3_3 = u1_dot_of_b_c_q1_q2_q3
        .mul_add(u1_dot_of_q1_q2_q3_4, cos_q1_minus_q3 * sin_q1_minus_q2_c_inv);
    // 2*u1_dot_of_q1_q2_q3 - cos_q1_minus_q2_times_3
    let u1_dot_of_q1_q2_q3_5 = u1_dot_of_q1_q2_q3
        .mul_add(S::int(2), -cos_q1_minus_q2_times_3);
    let mb_u1_dot_of_q1_q2_q3_5 = mb * u1_dot_of_q1_q2_q3_5;
    // sin_q2_minus_q3_inv*(2*u1_dot_of_mc_q1_q2_q3*u1_dot_of_b_c_q1_q2_q3_2 +
    //   u1_dot_of_b_c_q1_q2_q3_3*mb_u1_dot_of_q1_q2_q3_5)
    let u1_dot_of_place_2 = sin_q2_minus_q3_inv
        * u1_dot_of_b_c_q1_q2_q3_3
            .mul_add(
                mb_u1_dot_of_q1_q2_q3_5,
                S::int(2) * u1_dot_of_mc_q1_q2_q3 * u1_dot_of_b_c_q1_q2_q3_2,
            );
    let cos_q1_minus_q2_doubled = S::int(2) * cos_q1_minus_q2;
    let sin_q1_minus_q2_times_3 = S::int(3) * sin_q1_minus_q2;
    let u1_dot_of_mb_q1_q2 = mb * sin_q1_minus_q2_times_3;
    // q1'*(sin_q2_minus_q3_inv*(cos(q1 - q3)*mb_u1_dot_of_q1_q2_q3_5 +
    //   u1_dot_of_mc_q1_q2_q3*cos_q1_minus_q2_doubled) + u1_dot_of_q1_q2_q3*u1_dot_of_mb_q1_q2)
    let u1_dot_of_q1_dot_2 = q1_dot
        * (sin_q2_minus_q3_inv
            * u1_dot_of_mc_q1_q2_q3
                .mul_add(
                    cos_q1_minus_q2_doubled,
                    cos_q1_minus_q3 * mb_u1_dot_of_q1_q2_q3_5,
                ) + u1_dot_of_q1_q2_q3 * u1_dot_of_mb_q1_q2);
    let a_inv = S::int(1) / a;
    let u1_dot_of_place_a_inv = u1_dot_of_place * a_inv;
    // g*(2*cos(q1) - u1_dot_of_q1_q2_q3*cos(q2))
    let u1_dot_of_g_q1_q2_q3 = g * (-u1_dot_of_q1_q2_q3).mul_add(c2, S::int(2) * c1);
    let b_q2_dot = b * q2_dot;
    let q2_dot_b_q2_dot = q2_dot * b_q2_dot;
    // g*(ma*cos(q1) - u1_dot_of_mc_q1_q2_q3*cos(q3))
    let u1_dot_of_place_3 = g * (-u1_dot_of_mc_q1_q2_q3).mul_add(c3, ma * c1);
    // u1' = -(2*a^2*mc*q1'^2*sin(q1 - q2)*(cos(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) + sin(q1 -
    //   q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3))/sin(q2 - q3)^2 +
    //   a^2*mb*q1'^2*(cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 - q3)) + sin(q1 - q2)*(sin(q1 - q3)/tan(q3
    //   - q2) + cos(q1 - q3))/c)/sin(q2 - q3))*(2*sin(q1 - q3)/sin(q2 - q3) - 3*cos(q1 - q2))/sin(q2 - q3) +
    //   3*a*(g*(ma*cos(q1) - mc*sin(q1 - q2)*cos(q3)/sin(q2 - q3)) + mb*(g*(2*cos(q1) - cos(q2)*sin(q1 -
    //   q3)/sin(q2 - q3)) + sin(q1 - q2)*(a*q1'^2*sin(q1 - q3)/sin(q2 - q3) + b*q2'^2))))/(2*a^2*(ma +
    //   mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 -
    //   q3))/sin(q2 - q3))))
    let u1_dot = -S::ratio(1, 2) * u1_dot_of_place
        * q1_dot.mul_add(u1_dot_of_q1_dot_2, q1_dot_u1_dot_of_q1_dot * u1_dot_of_place_2)
        - S::ratio(3, 2) * u1_dot_of_place_a_inv
            * (mb * sin_q1_minus_q2.mul_add(q2_dot_b_q2_dot, u1_dot_of_g_q1_q2_q3)
                + u1_dot_of_place_3);
    let u1_dot_by_q1_of_q1_q2_q3 = cos_q1_minus_q3 * sin_q2_minus_q3_inv;
    let u1_dot_by_q1_of_q1_dot = sin_q1_minus_q3 * q1_dot_u1_dot_of_q1_dot;
    // q2_dot_b_q2_dot + u1_dot_by_q1_of_q1_dot
    let u1_dot_by_q1_of_motion = q2_dot_b_q2_dot + u1_dot_by_q1_of_q1_dot;
    let u1_dot_by_q1_of_motion_2 = cos_q1_minus_q2 * u1_dot_by_q1_of_motion;
    let u1_dot_by_q1_of_mc_q2_q3 = mc * sin_q2_minus_q3_inv * c3;
    let a_times_3 = S::int(3) * a;
    // u1_dot_of_q1_q2_q3_4 - cos(q1 - q3)
    let u1_dot_by_q1_of_q1_q2_q3_2 = u1_dot_of_q1_q2_q3_4 - cos_q1_minus_q3;
    // -u1_dot_by_q1_of_q1_q2_q3_2
    let u1_dot_by_q1_of_q1_q2_q3_3 = -u1_dot_by_q1_of_q1_q2_q3_2;
    // sin_q1_minus_q3_b_inv*u1_dot_of_q1_q2_q3_4 + sin_q1_minus_q2_c_inv*u1_dot_by_q1_of_q1_q2_q3_3
    let u1_dot_by_q1_of_b_c_q1_q2_q3 = sin_q1_minus_q2_c_inv
        .mul_add(
            u1_dot_by_q1_of_q1_q2_q3_3,
            sin_q1_minus_q3_b_inv * u1_dot_of_q1_q2_q3_4,
        );
    // cos(q1 - q3) + a_sin_q2_minus_q3_inv*u1_dot_by_q1_of_b_c_q1_q2_q3
    let u1_dot_by_q1_of_place = a_sin_q2_minus_q3_inv
        .mul_add(u1_dot_by_q1_of_b_c_q1_q2_q3, cos_q1_minus_q3);
    let u1_dot_by_q1_of_q1_dot_2 = a * mb * q1_dot_u1_dot_of_q1_dot;
    let u1_dot_by_q1_of_q1_dot_3 = u1_dot_by_q1_of_place * u1_dot_by_q1_of_q1_dot_2;
    // cos(q1 - q2) + u1_dot_of_q1_q2_q3_3
    let u1_dot_by_q1_of_q1_q2_q3_4 = cos_q1_minus_q2 + u1_dot_of_q1_q2_q3_3;
    let cos_q1_minus_q3_b_inv = cos_q1_minus_q3 * b_inv;
    let u1_dot_by_q1_of_b_q1_q2_q3 = u1_dot_by_q1_of_q1_q2_q3_4 * cos_q1_minus_q3_b_inv;
    let u1_dot_by_q1_of_c_q1_q2_q3 = sin_q1_minus_q2_c_inv * u1_dot_of_q2_q3
        * cos_q1_minus_q2_doubled;
    let u1_dot_of_q1_dot_sq = u1_dot_of_q1_dot * u1_dot_of_q1_dot;
    let u1_dot_by_q1_of_q1_dot_4 = S::int(2) * mc_sin_q1_minus_q2 * u1_dot_of_q1_dot_sq;
    let u1_dot_by_q1_of_q1_q2_q3_5 = cos_q1_minus_q3 * u1_dot_of_q2_q3;
    let cos_q1_minus_q2_c_inv = cos_q1_minus_q2 * c_inv;
    let u1_dot_by_q1_of_c_q1_q2_q3_2 = u1_dot_by_q1_of_q1_q2_q3_3 * cos_q1_minus_q2_c_inv;
    let u1_dot_by_q1_of_b_q1_q2_q3_2 = S::int(2) * sin_q1_minus_q3_b_inv
        * u1_dot_by_q1_of_q1_q2_q3_5;
    // -u1_dot_of_q1_q2_q3_5
    let u1_dot_by_q1_of_q1_q2_q3_6 = -u1_dot_of_q1_q2_q3_5;
    let u1_dot_by_q1_of_q1_dot_5 = u1_dot_by_q1_of_q1_dot_2 * u1_dot_by_q1_of_q1_q2_q3_6;
    // sin_q1_minus_q3_b_inv*u1_dot_by_q1_of_q1_q2_q3_4 - sin_q1_minus_q2_c_inv*u1_dot_of_q1_q2_q3_3
    let u1_dot_by_q1_of_b_c_q1_q2_q3_2 = (-sin_q1_minus_q2_c_inv)
        .mul_add(
            u1_dot_of_q1_q2_q3_3,
            sin_q1_minus_q3_b_inv * u1_dot_by_q1_of_q1_q2_q3_4,
        );
    // cos(q1 - q2) + a_sin_q2_minus_q3_inv*u1_dot_by_q1_of_b_c_q1_q2_q3_2
    let u1_dot_by_q1_of_place_2 = a_sin_q2_minus_q3_inv
        .mul_add(u1_dot_by_q1_of_b_c_q1_q2_q3_2, cos_q1_minus_q2);
    let u1_dot_by_q1_of_q1_dot_6 = mc * cos_q1_minus_q2_doubled * u1_dot_of_q1_dot_sq
        * u1_dot_by_q1_of_place_2;
    let u1_dot_by_q1_of_place_3 = S::ratio(1, 2) * u1_dot_of_place_a_inv;
    let u1_dot_by_q1_of_place_4 = a_inv * u1_dot_by_q1_of_place_3;
    // u1_dot_of_place_a_inv*u1_dot_by_q1_of_place_3*(a_times_3*(u1_dot_of_place_3 +
    //   mb*(u1_dot_of_g_q1_q2_q3 + sin(q1 - q2)*u1_dot_by_q1_of_motion)) -
    //   u1_dot_by_q1_of_q1_dot_3*u1_dot_by_q1_of_q1_q2_q3_6 +
    //   u1_dot_by_q1_of_q1_dot_4*u1_dot_by_q1_of_place_2)
    let u1_dot_by_q1_of_motion_3 = u1_dot_of_place_a_inv * u1_dot_by_q1_of_place_3
        * (a_times_3
            * (u1_dot_of_place_3
                + mb
                    * sin_q1_minus_q2
                        .mul_add(u1_dot_by_q1_of_motion, u1_dot_of_g_q1_q2_q3))
            - u1_dot_by_q1_of_q1_dot_3 * u1_dot_by_q1_of_q1_q2_q3_6
            + u1_dot_by_q1_of_q1_dot_4 * u1_dot_by_q1_of_place_2);
    // u1_dot_by_q1 = (2*mc*sin(q1 - q2)*cos(q1 - q2)/sin(q2 - q3)^2 - mb*(cos(q1 - q3)*(3*cos(q1 - q2) -
    //   sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3) - sin(q1 - q3)*(3*sin(q1 - q2) + cos(q1 - q3)/sin(q2 -
    //   q3))/sin(q2 - q3)))*(2*a^2*mc*q1'^2*sin(q1 - q2)*(cos(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2))
    //   + sin(q1 - q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3))/sin(q2 - q3)^2 +
    //   a^2*mb*q1'^2*(cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 - q3)) + sin(q1 - q2)*(sin(q1 - q3)/tan(q3
    //   - q2) + cos(q1 - q3))/c)/sin(q2 - q3))*(2*sin(q1 - q3)/sin(q2 - q3) - 3*cos(q1 - q2))/sin(q2 - q3) +
    //   3*a*(g*(ma*cos(q1) - mc*sin(q1 - q2)*cos(q3)/sin(q2 - q3)) + mb*(g*(2*cos(q1) - cos(q2)*sin(q1 -
    //   q3)/sin(q2 - q3)) + sin(q1 - q2)*(a*q1'^2*sin(q1 - q3)/sin(q2 - q3) + b*q2'^2))))/(2*a^2*(ma +
    //   mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 -
    //   q3))/sin(q2 - q3)))^2) + (a^2*mb*q1'^2*(2*sin(q1 - q3)/sin(q2 - q3) - 3*cos(q1 - q2))*(sin(q1 - q3)
    //   + a*(sin(q1 - q2)*(sin(q1 - q3) + cos(q1 - q3)/tan(q2 - q3))/c - 2*sin(q1 - q3)*cos(q1 -
    //   q3)/(b*tan(q2 - q3)) - cos(q1 - q2)*(sin(q1 - q3)/tan(q3 - q2) + cos(q1 - q3))/c)/sin(q2 -
    //   q3))/sin(q2 - q3) - 2*a^2*mc*q1'^2*cos(q1 - q2)*(cos(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) +
    //   sin(q1 - q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3))/sin(q2 - q3)^2 -
    //   a^2*mb*q1'^2*(cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 - q3)) + sin(q1 - q2)*(sin(q1 - q3)/tan(q3
    //   - q2) + cos(q1 - q3))/c)/sin(q2 - q3))*(3*sin(q1 - q2) + 2*cos(q1 - q3)/sin(q2 - q3))/sin(q2 - q3) +
    //   2*a^2*mc*q1'^2*sin(q1 - q2)*(sin(q1 - q2) + a*(sin(q1 - q3)*(sin(q1 - q2) + cos(q1 - q2)/tan(q3 -
    //   q2))/b - 2*sin(q1 - q2)*cos(q1 - q2)/(c*tan(q3 - q2)) - cos(q1 - q3)*(cos(q1 - q2) + sin(q1 -
    //   q2)/tan(q2 - q3))/b)/sin(q2 - q3))/sin(q2 - q3)^2 + 3*a*(g*(ma*sin(q1) + mc*cos(q1 -
    //   q2)*cos(q3)/sin(q2 - q3)) + mb*(g*(2*sin(q1) + cos(q2)*cos(q1 - q3)/sin(q2 - q3)) - a*q1'^2*sin(q1 -
    //   q2)*cos(q1 - q3)/sin(q2 - q3) - cos(q1 - q2)*(a*q1'^2*sin(q1 - q3)/sin(q2 - q3) +
    //   b*q2'^2))))/(2*a^2*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) -
    //   sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3))))
    let u1_dot_by_q1 = u1_dot_by_q1_of_place_4
        * (u1_dot_by_q1_of_q1_dot_4
            * (sin_q1_minus_q2
                + a_sin_q2_minus_q3_inv
                    * (u1_dot_by_q1_of_c_q1_q2_q3
                        - sin_q1_minus_q3_b_inv
                            * cos_q1_minus_q2.mul_add(u1_dot_of_q2_q3, -sin_q1_minus_q2)
                        - u1_dot_by_q1_of_b_q1_q2_q3))
            - a_times_3
                * (mb
                    * (-g * u1_dot_by_q1_of_q1_q2_q3.mul_add(c2, S::int(2) * s1)
                        + cos_q1_minus_q3 * sin_q1_minus_q2 * q1_dot_u1_dot_of_q1_dot
                        + u1_dot_by_q1_of_motion_2)
                    - g * cos_q1_minus_q2.mul_add(u1_dot_by_q1_of_mc_q2_q3, ma * s1))
            - u1_dot_by_q1_of_q1_dot_3
                * u1_dot_by_q1_of_q1_q2_q3.mul_add(S::int(2), sin_q1_minus_q2_times_3)
            - u1_dot_by_q1_of_q1_dot_5
                * (sin_q1_minus_q3
                    + a_sin_q2_minus_q3_inv
                        * (sin_q1_minus_q2_c_inv * (sin_q1_minus_q3 + u1_dot_by_q1_of_q1_q2_q3_5)
                            - u1_dot_by_q1_of_c_q1_q2_q3_2
                            - u1_dot_by_q1_of_b_q1_q2_q3_2)) - u1_dot_by_q1_of_q1_dot_6)
        + u1_dot_by_q1_of_motion_3
            * (mb
                * (u1_dot_of_q1_q2_q3 * (sin_q1_minus_q2_times_3 + u1_dot_by_q1_of_q1_q2_q3)
                    - u1_dot_of_q1_q2_q3_2 * u1_dot_by_q1_of_q1_q2_q3)
                + u1_dot_of_mc_q1_q2_q3_2 * cos_q1_minus_q2_doubled);
    let q2_ddot_by_q1_of_a_b_q1_q2_q3 = a_sin_q2_minus_q3_inv * sin_q1_minus_q3_b_inv;
    // q1_dot_u1_dot_of_q1_dot + sin_q1_minus_q2_c_inv*u1_dot_of_q1_dot_sq
    let q2_ddot_by_q1_of_q1_dot = sin_q1_minus_q2_c_inv
        .mul_add(u1_dot_of_q1_dot_sq, q1_dot_u1_dot_of_q1_dot);
    let q2_ddot_by_q1_of_q1_dot_2 = u1_dot_of_q2_q3 * u1_dot_of_q1_dot_sq;
    let q2_ddot_by_q1_of_u1_dot = u1_dot * a_sin_q2_minus_q3_inv;
    let q2_ddot_by_q1_of_q1_dot_3 = S::int(2) * q2_ddot_by_q1_of_q1_dot_2;
    let q2_ddot_by_q1_of_q1_dot_4 = sin_q1_minus_q3_b_inv * q2_ddot_by_q1_of_q1_dot_3;
    let q2_ddot_by_q1_of_q1_dot_5 = cos_q1_minus_q3_b_inv * q2_ddot_by_q1_of_q1_dot_4;
    let q2_ddot_by_q1_of_b_q1_q2_q3 = b_inv * u1_dot_by_q1_of_q1_q2_q3_2;
    let q2_ddot_by_q1_of_q1_dot_6 = u1_dot_of_q1_dot_sq * cos_q1_minus_q2_c_inv
        * q2_ddot_by_q1_of_b_q1_q2_q3;
    // q2_ddot_by_q1 = a*(q1'^2*(sin(q1 - q3) - a*(2*sin(q1 - q3)*cos(q1 - q3)/(b*tan(q2 - q3)) + (cos(q1 -
    //   q2)*cos(q1 - q3) - sin(q1 - q2)*sin(q1 - q3) - (cos(q1 - q2)*sin(q1 - q3) + sin(q1 - q2)*cos(q1 -
    //   q3))/tan(q2 - q3))/c)/sin(q2 - q3)) - u1'*cos(q1 - q3) - u1_dot_by_q1*sin(q1 - q3))/(b*sin(q2 - q3))
    let q2_ddot_by_q1 = sin_q1_minus_q3_b_inv * q2_ddot_by_q1_of_q1_dot
        - u1_dot_by_q1 * q2_ddot_by_q1_of_a_b_q1_q2_q3
        + cos_q1_minus_q3_b_inv
            * sin_q1_minus_q2_c_inv
                .mul_add(q2_ddot_by_q1_of_q1_dot_2, -q2_ddot_by_q1_of_u1_dot)
        - q2_ddot_by_q1_of_q1_dot_5 + q2_ddot_by_q1_of_q1_dot_6;
    let q3_ddot_by_q1_of_a_c_q1_q2_q3 = a_sin_q2_minus_q3_inv * sin_q1_minus_q2_c_inv;
    // q1_dot_u1_dot_of_q1_dot + sin_q1_minus_q3_b_inv*u1_dot_of_q1_dot_sq
    let q3_ddot_by_q1_of_q1_dot = sin_q1_minus_q3_b_inv
        .mul_add(u1_dot_of_q1_dot_sq, q1_dot_u1_dot_of_q1_dot);
    let q3_ddot_by_q1_of_q1_dot_2 = sin_q1_minus_q2_c_inv * q2_ddot_by_q1_of_q1_dot_3;
    let q3_ddot_by_q1_of_q1_dot_3 = cos_q1_minus_q2_c_inv * q3_ddot_by_q1_of_q1_dot_2;
    let q3_ddot_by_q1_of_q1_dot_4 = c_inv * u1_dot_by_q1_of_b_q1_q2_q3 * u1_dot_of_q1_dot_sq;
    // q3_ddot_by_q1 = a*(q1'^2*(sin(q1 - q2) + a*(2*sin(q1 - q2)*cos(q1 - q2)/(c*tan(q2 - q3)) + (sin(q1 -
    //   q2)*sin(q1 - q3) - cos(q1 - q2)*cos(q1 - q3) + (cos(q1 - q2)*sin(q1 - q3) + sin(q1 - q2)*cos(q1 -
    //   q3))/tan(q3 - q2))/b)/sin(q2 - q3)) - u1'*cos(q1 - q2) - u1_dot_by_q1*sin(q1 - q2))/(c*sin(q2 - q3))
    let q3_ddot_by_q1 = -cos_q1_minus_q2_c_inv
        * sin_q1_minus_q3_b_inv
            .mul_add(q2_ddot_by_q1_of_q1_dot_2, q2_ddot_by_q1_of_u1_dot)
        + sin_q1_minus_q2_c_inv * q3_ddot_by_q1_of_q1_dot
        - u1_dot_by_q1 * q3_ddot_by_q1_of_a_c_q1_q2_q3 + q3_ddot_by_q1_of_q1_dot_3
        - q3_ddot_by_q1_of_q1_dot_4;
    // mb*u1_dot_by_q1_of_place*u1_dot_of_q1_dot_sq*u1_dot_by_q1_of_q1_q2_q3_6*cos(q2 - q3) -
    //   4*mc_sin_q1_minus_q2*u1_dot_by_q1_of_place_2*q2_ddot_by_q1_of_q1_dot_2
    let u1_dot_by_q2_of_q1_dot = (-(mc_sin_q1_minus_q2 * u1_dot_by_q1_of_place_2
        * q2_ddot_by_q1_of_q1_dot_2))
        .mul_add(
            S::int(4),
            mb * u1_dot_by_q1_of_place * u1_dot_of_q1_dot_sq * u1_dot_by_q1_of_q1_q2_q3_6
                * cos_q2_minus_q3,
        );
    let u1_dot_by_q2_of_q1_q2_q3 = u1_dot_of_q1_q2_q3 * u1_dot_of_q2_q3;
    // 1 + u1_dot_of_q2_q3^2
    let u1_dot_by_q2_of_q2_q3 = u1_dot_of_q2_q3.mul_add(u1_dot_of_q2_q3, S::int(1));
    let u1_dot_by_q2_of_q1_q2_q3_2 = sin_q1_minus_q2 * u1_dot_by_q2_of_q2_q3;
    let u1_dot_by_q2_of_a_q2_q3 = a_sin_q2_minus_q3_inv * u1_dot_of_q2_q3;
    let u1_dot_by_q2_of_place = u1_dot_by_q1_of_b_c_q1_q2_q3_2 * u1_dot_by_q2_of_a_q2_q3;
    let u1_dot_by_q2_of_q1_q2_q3_3 = sin_q1_minus_q3 * u1_dot_by_q2_of_q2_q3;
    let u1_dot_by_q2_of_place_2 = u1_dot_by_q1_of_b_c_q1_q2_q3 * u1_dot_by_q2_of_a_q2_q3;
    let u1_dot_by_q2_of_mc_q1_q2_q3 = S::int(2) * u1_dot_of_mc_q1_q2_q3_2;
    // u1_dot_by_q2 = (2*a^2*mc*q1'^2*cos(q1 - q2)*(cos(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) +
    //   sin(q1 - q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3))/sin(q2 - q3)^2 +
    //   4*a^2*mc*q1'^2*sin(q1 - q2)*(cos(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) + sin(q1 -
    //   q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3))/(sin(q2 - q3)^2*tan(q2 - q3)) +
    //   a^2*mb*q1'^2*(cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 - q3)) + sin(q1 - q2)*(sin(q1 - q3)/tan(q3
    //   - q2) + cos(q1 - q3))/c)/sin(q2 - q3))*(3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 - q3))/(sin(q2 -
    //   q3)*tan(q3 - q2)) - 2*a^2*mc*q1'^2*sin(q1 - q2)*(sin(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) +
    //   sin(q1 - q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b)/(sin(q2 - q3)*tan(q3 - q2)) + a*(sin(q1 -
    //   q2)^2/c + sin(q1 - q2)^2/(c*tan(q2 - q3)^2) + 2*sin(q1 - q2)*cos(q1 - q2)/(c*tan(q2 - q3)) - sin(q1
    //   - q3)*(sin(q1 - q2)/tan(q2 - q3)^2 + cos(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3))/sin(q2 - q3)^2 +
    //   a^2*mb*q1'^2*(cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 - q3)) + sin(q1 - q2)*(sin(q1 - q3)/tan(q3
    //   - q2) + cos(q1 - q3))/c)/sin(q2 - q3))*(3*sin(q1 - q2) + 2*sin(q1 - q3)/(sin(q2 - q3)*tan(q2 -
    //   q3)))/sin(q2 - q3) + a^2*mb*q1'^2*(2*sin(q1 - q3)/sin(q2 - q3) - 3*cos(q1 - q2))*(a*(sin(q1 -
    //   q3)^2/(b*tan(q2 - q3)) + sin(q1 - q2)*(sin(q1 - q3)/tan(q3 - q2) + cos(q1 - q3))/c)/(sin(q2 -
    //   q3)*tan(q2 - q3)) + a*(sin(q1 - q3)^2/b + sin(q1 - q3)^2/(b*tan(q2 - q3)^2) + cos(q1 - q2)*(sin(q1 -
    //   q3)/tan(q3 - q2) + cos(q1 - q3))/c - sin(q1 - q2)*(sin(q1 - q3) + sin(q1 - q3)/tan(q2 -
    //   q3)^2)/c)/sin(q2 - q3))/sin(q2 - q3) + 3*a*(mb*(a*q1'^2*sin(q1 - q2)*sin(q1 - q3)/(sin(q2 -
    //   q3)*tan(q2 - q3)) - g*(sin(q2)*sin(q1 - q3)/sin(q2 - q3) + cos(q2)*sin(q1 - q3)/(sin(q2 - q3)*tan(q2
    //   - q3))) + cos(q1 - q2)*(a*q1'^2*sin(q1 - q3)/sin(q2 - q3) + b*q2'^2)) - g*(mc*cos(q1 -
    //   q2)*cos(q3)/sin(q2 - q3) + mc*sin(q1 - q2)*cos(q3)/(sin(q2 - q3)*tan(q2 - q3)))))/(2*a^2*(ma +
    //   mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 -
    //   q3))/sin(q2 - q3)))) - (2*mc*sin(q1 - q2)*cos(q1 - q2)/sin(q2 - q3)^2 + 2*mc*sin(q1 - q2)^2/(sin(q2
    //   - q3)^2*tan(q2 - q3)) + mb*(sin(q1 - q3)*(3*sin(q1 - q2) + sin(q1 - q3)/(sin(q2 - q3)*tan(q2 -
    //   q3)))/sin(q2 - q3) - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/(sin(q2 - q3)*tan(q2
    //   - q3))))*(2*a^2*mc*q1'^2*sin(q1 - q2)*(cos(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) + sin(q1 -
    //   q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3))/sin(q2 - q3)^2 +
    //   a^2*mb*q1'^2*(cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 - q3)) + sin(q1 - q2)*(sin(q1 - q3)/tan(q3
    //   - q2) + cos(q1 - q3))/c)/sin(q2 - q3))*(2*sin(q1 - q3)/sin(q2 - q3) - 3*cos(q1 - q2))/sin(q2 - q3) +
    //   3*a*(g*(ma*cos(q1) - mc*sin(q1 - q2)*cos(q3)/sin(q2 - q3)) + mb*(g*(2*cos(q1) - cos(q2)*sin(q1 -
    //   q3)/sin(q2 - q3)) + sin(q1 - q2)*(a*q1'^2*sin(q1 - q3)/sin(q2 - q3) + b*q2'^2))))/(2*a^2*(ma +
    //   mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 -
    //   q3))/sin(q2 - q3)))^2)
    let u1_dot_by_q2 = u1_dot_by_q1_of_place_4
        * (u1_dot_by_q1_of_q1_dot_6 - u1_dot_by_q2_of_q1_dot
            + a_times_3
                * (mb
                    * (u1_dot_by_q1_of_motion_2 + u1_dot_of_q1_q2_q3_3 * u1_dot_by_q1_of_q1_dot
                        - g
                            * u1_dot_by_q2_of_q1_q2_q3
                                .mul_add(c2, u1_dot_of_q1_q2_q3 * s2))
                    - g * u1_dot_by_q1_of_mc_q2_q3 * u1_dot_by_q1_of_q1_q2_q3_4)
            + u1_dot_by_q1_of_q1_dot_3
                * u1_dot_by_q2_of_q1_q2_q3.mul_add(S::int(2), sin_q1_minus_q2_times_3)
            + u1_dot_by_q1_of_q1_dot_4
                * (u1_dot_by_q2_of_place - sin_q1_minus_q2
                    - a_sin_q2_minus_q3_inv
                        * ((-(sin_q1_minus_q3_b_inv * u1_dot_of_q2_q3))
                            .mul_add(
                                u1_dot_by_q1_of_q1_q2_q3_4, u1_dot_by_q1_of_c_q1_q2_q3,
                            ) + sin_q1_minus_q2_c_inv * u1_dot_by_q2_of_q1_q2_q3_2))
            - u1_dot_by_q1_of_q1_dot_5
                * (a_sin_q2_minus_q3_inv
                    * u1_dot_of_b_c_q1_q2_q3
                        .mul_add(
                            u1_dot_by_q2_of_q1_q2_q3_3, u1_dot_by_q1_of_c_q1_q2_q3_2,
                        ) + u1_dot_by_q2_of_place_2))
        - u1_dot_by_q1_of_motion_3
            * (mb
                * (u1_dot_of_q1_q2_q3 * (sin_q1_minus_q2_times_3 + u1_dot_by_q2_of_q1_q2_q3)
                    - u1_dot_of_q1_q2_q3_2 * u1_dot_by_q2_of_q1_q2_q3)
                + u1_dot_by_q1_of_q1_q2_q3_4 * u1_dot_by_q2_of_mc_q1_q2_q3);
    let q2_ddot_by_q2_of_q1_dot = S::int(3) * q2_ddot_by_q1_of_q1_dot_2;
    // u1_dot_of_b_c_q1_q2_q3*u1_dot_of_q1_dot_sq + u1_dot_of_q2_q3*(q2_ddot_by_q1_of_u1_dot +
    //   u1_dot_of_b_c_q1_q2_q3*q2_ddot_by_q2_of_q1_dot)
    let q2_ddot_by_q2_of_motion = u1_dot_of_q2_q3
        * u1_dot_of_b_c_q1_q2_q3
            .mul_add(q2_ddot_by_q2_of_q1_dot, q2_ddot_by_q1_of_u1_dot)
        + u1_dot_of_b_c_q1_q2_q3 * u1_dot_of_q1_dot_sq;
    let q2_ddot_by_q2_of_q1_dot_2 = q1_dot_u1_dot_of_q1_dot * u1_dot_of_q2_q3;
    let q2_ddot_by_q2_of_q1_dot_3 = cos_q1_minus_q3_b_inv * q2_ddot_by_q2_of_q1_dot_2;
    // q2_ddot_by_q2 = -a*((q1'^2*(a*((sin(q1 - q2)*sin(q1 - q3) - cos(q1 - q2)*cos(q1 - q3) + (2*sin(q1 -
    //   q2)*cos(q1 - q3) - sin(q1 - q3)*(cos(q1 - q2) + 3*sin(q1 - q2)/tan(q2 - q3)))/tan(q3 - q2))/c -
    //   sin(q1 - q3)^2*(1 + 3/tan(q2 - q3)^2)/b) - cos(q2 - q3)*cos(q1 - q3)) - u1'*sin(q1 - q3)*cos(q2 -
    //   q3))/sin(q2 - q3) + u1_dot_by_q2*sin(q1 - q3))/(b*sin(q2 - q3))
    let q2_ddot_by_q2 = (-u1_dot_by_q2)
        .mul_add(
            q2_ddot_by_q1_of_a_b_q1_q2_q3,
            cos_q1_minus_q3_b_inv * q3_ddot_by_q1_of_q1_dot_2,
        ) - q2_ddot_by_q1_of_q1_dot_6 + sin_q1_minus_q3_b_inv * q2_ddot_by_q2_of_motion
        + q2_ddot_by_q2_of_q1_dot_3;
    let q3_ddot_by_q2_of_b_c_q1_q2_q3 = c_inv * u1_dot_of_b_c_q1_q2_q3_2;
    let q3_ddot_by_q2_of_q1_dot = cos_q1_minus_q2_c_inv * q2_ddot_by_q2_of_q1_dot_2;
    // q3_ddot_by_q2 = a*(u1'*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3)) - q1'^2*(sin(q1 - q2) + (a*(sin(q1
    //   - q2)^2/c + (3*cos(q1 - q2)*sin(q1 - q3)/b - sin(q1 - q2)*(3*sin(q1 - q3)/(b*tan(q3 - q2)) +
    //   (2*cos(q1 - q2) + 3*sin(q1 - q2)/tan(q2 - q3))/c))/tan(q3 - q2)) - cos(q1 - q2)*cos(q2 - q3))/sin(q2
    //   - q3)) - u1_dot_by_q2*sin(q1 - q2))/(c*sin(q2 - q3))
    let q3_ddot_by_q2 = (-sin_q1_minus_q2_c_inv)
        .mul_add(
            q2_ddot_by_q1_of_q1_dot,
            c_inv * u1_dot_by_q1_of_q1_q2_q3_4 * q2_ddot_by_q1_of_u1_dot,
        ) - u1_dot_by_q2 * q3_ddot_by_q1_of_a_c_q1_q2_q3 - q3_ddot_by_q1_of_q1_dot_3
        + q2_ddot_by_q2_of_q1_dot * q3_ddot_by_q2_of_b_c_q1_q2_q3 + q3_ddot_by_q2_of_q1_dot;
    let u1_dot_by_q3_of_q1_q2_q3 = sin_q2_minus_q3_inv * u1_dot_by_q1_of_q1_q2_q3_2;
    // -u1_dot_by_q3_of_q1_q2_q3
    let u1_dot_by_q3_of_q1_q2_q3_2 = -u1_dot_by_q3_of_q1_q2_q3;
    // u1_dot_by_q3 = (4*a^2*mc*q1'^2*sin(q1 - q2)*(cos(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) +
    //   sin(q1 - q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3))/(sin(q2 - q3)^2*tan(q3 -
    //   q2)) + a^2*mb*q1'^2*(cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 - q3)) + sin(q1 - q2)*(sin(q1 -
    //   q3)/tan(q3 - q2) + cos(q1 - q3))/c)/sin(q2 - q3))*(3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 -
    //   q3))/(sin(q2 - q3)*tan(q2 - q3)) + a^2*mb*q1'^2*(3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 -
    //   q3))*(sin(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 - q3)) + sin(q1 - q2)*(sin(q1 - q3)/tan(q3 - q2) +
    //   cos(q1 - q3))/c)/(sin(q2 - q3)*tan(q2 - q3)) + a*(sin(q1 - q3)^2/b - 2*sin(q1 - q3)*cos(q1 -
    //   q3)/(b*tan(q2 - q3)) + sin(q1 - q3)^2/(b*tan(q2 - q3)^2) - sin(q1 - q2)*(sin(q1 - q3)/tan(q2 - q3)^2
    //   - cos(q1 - q3)/tan(q2 - q3))/c)/sin(q2 - q3))/sin(q2 - q3) - 2*a^2*mc*q1'^2*sin(q1 - q2)*(a*(sin(q1
    //   - q2)^2/(c*tan(q3 - q2)) + sin(q1 - q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b)/(sin(q2 -
    //   q3)*tan(q2 - q3)) + a*(sin(q1 - q3)*(sin(q1 - q2) + sin(q1 - q2)/tan(q2 - q3)^2)/b - sin(q1 -
    //   q2)^2/c - sin(q1 - q2)^2/(c*tan(q2 - q3)^2) - cos(q1 - q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 -
    //   q3))/b)/sin(q2 - q3))/sin(q2 - q3)^2 + 2*a^2*mb*q1'^2*(cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 -
    //   q3)) + sin(q1 - q2)*(sin(q1 - q3)/tan(q3 - q2) + cos(q1 - q3))/c)/sin(q2 - q3))*(sin(q1 -
    //   q3)/(sin(q2 - q3)*tan(q3 - q2)) + cos(q1 - q3)/sin(q2 - q3))/sin(q2 - q3) - 3*a*(g*(mc*sin(q1 -
    //   q2)*sin(q3)/sin(q2 - q3) - mc*sin(q1 - q2)*cos(q3)/(sin(q2 - q3)*tan(q2 - q3))) +
    //   mb*(g*(cos(q2)*sin(q1 - q3)/(sin(q2 - q3)*tan(q3 - q2)) + cos(q2)*cos(q1 - q3)/sin(q2 - q3)) -
    //   sin(q1 - q2)*(a*q1'^2*sin(q1 - q3)/(sin(q2 - q3)*tan(q3 - q2)) + a*q1'^2*cos(q1 - q3)/sin(q2 -
    //   q3)))))/(2*a^2*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) -
    //   sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3)))) + (2*mc*sin(q1 - q2)^2/(sin(q2 - q3)^2*tan(q2 - q3)) +
    //   mb*(sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/(sin(q2 - q3)*tan(q3 - q2)) + cos(q1 -
    //   q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3) - sin(q1 - q3)*(sin(q1 - q3)/(sin(q2 -
    //   q3)*tan(q3 - q2)) + cos(q1 - q3)/sin(q2 - q3))/sin(q2 - q3)))*(2*a^2*mc*q1'^2*sin(q1 - q2)*(cos(q1 -
    //   q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) + sin(q1 - q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 -
    //   q3))/b)/sin(q2 - q3))/sin(q2 - q3)^2 + a^2*mb*q1'^2*(cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 -
    //   q3)) + sin(q1 - q2)*(sin(q1 - q3)/tan(q3 - q2) + cos(q1 - q3))/c)/sin(q2 - q3))*(2*sin(q1 -
    //   q3)/sin(q2 - q3) - 3*cos(q1 - q2))/sin(q2 - q3) + 3*a*(g*(ma*cos(q1) - mc*sin(q1 -
    //   q2)*cos(q3)/sin(q2 - q3)) + mb*(g*(2*cos(q1) - cos(q2)*sin(q1 - q3)/sin(q2 - q3)) + sin(q1 -
    //   q2)*(a*q1'^2*sin(q1 - q3)/sin(q2 - q3) + b*q2'^2))))/(2*a^2*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 +
    //   mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3)))^2)
    let u1_dot_by_q3 = u1_dot_by_q1_of_place_4
        * (u1_dot_by_q2_of_q1_dot
            - u1_dot_by_q1_of_q1_dot_4
                * (a_sin_q2_minus_q3_inv
                    * u1_dot_of_b_c_q1_q2_q3
                        .mul_add(u1_dot_by_q2_of_q1_q2_q3_2, -u1_dot_by_q1_of_b_q1_q2_q3)
                    + u1_dot_by_q2_of_place)
            + u1_dot_by_q1_of_q1_dot_5
                * (sin_q1_minus_q3
                    + a_sin_q2_minus_q3_inv
                        * ((-(sin_q1_minus_q2_c_inv * u1_dot_of_q2_q3))
                            .mul_add(
                                u1_dot_by_q1_of_q1_q2_q3_2,
                                sin_q1_minus_q3_b_inv * u1_dot_by_q2_of_q1_q2_q3_3,
                            ) - u1_dot_by_q1_of_b_q1_q2_q3_2) + u1_dot_by_q2_of_place_2)
            + a_times_3
                * (g * u1_dot_of_mc_q1_q2_q3 * u1_dot_of_q2_q3.mul_add(c3, -s3)
                    + mb
                        * (-(sin_q1_minus_q2 * q1_dot_u1_dot_of_q1_dot))
                            .mul_add(
                                u1_dot_by_q1_of_q1_q2_q3_2,
                                g * u1_dot_by_q3_of_q1_q2_q3 * c2,
                            )) + S::int(2) * u1_dot_by_q1_of_q1_dot_3 * u1_dot_by_q3_of_q1_q2_q3_2)
        + u1_dot_by_q1_of_motion_3
            * (-mb
                * u1_dot_of_q1_q2_q3
                    .mul_add(
                        u1_dot_by_q3_of_q1_q2_q3_2,
                        u1_dot_of_q1_q2_q3_2 * u1_dot_by_q3_of_q1_q2_q3,
                    ) + u1_dot_of_q1_q2_q3_3 * u1_dot_by_q2_of_mc_q1_q2_q3);
    let q2_ddot_by_q3_of_b_c_q1_q2_q3 = b_inv * u1_dot_of_b_c_q1_q2_q3_3;
    // q2_ddot_by_q3 = a*(u1'*(sin(q1 - q3)/tan(q3 - q2) + cos(q1 - q3)) - q1'^2*(sin(q1 - q3) + (cos(q2 -
    //   q3)*cos(q1 - q3) + a*(sin(q1 - q3)^2/b + (3*sin(q1 - q2)*cos(q1 - q3)/c - sin(q1 - q3)*(3*sin(q1 -
    //   q2)/(c*tan(q2 - q3)) + (3*sin(q1 - q3)/tan(q3 - q2) + 2*cos(q1 - q3))/b))/tan(q2 - q3)))/sin(q2 -
    //   q3)) - u1_dot_by_q3*sin(q1 - q3))/(b*sin(q2 - q3))
    let q2_ddot_by_q3 = (-u1_dot_by_q3)
        .mul_add(q2_ddot_by_q1_of_a_b_q1_q2_q3, q2_ddot_by_q1_of_q1_dot_5)
        - q2_ddot_by_q1_of_u1_dot * q2_ddot_by_q1_of_b_q1_q2_q3
        - sin_q1_minus_q3_b_inv * q3_ddot_by_q1_of_q1_dot - q2_ddot_by_q2_of_q1_dot_3
        - q2_ddot_by_q2_of_q1_dot * q2_ddot_by_q3_of_b_c_q1_q2_q3;
    // q3_ddot_by_q3 = -a*((q1'^2*(cos(q1 - q2)*cos(q2 - q3) + a*((sin(q1 - q2)*sin(q1 - q3) - cos(q1 -
    //   q2)*cos(q1 - q3) + (sin(q1 - q2)*cos(q1 - q3) - sin(q1 - q3)*(2*cos(q1 - q2) + 3*sin(q1 - q2)/tan(q2
    //   - q3)))/tan(q3 - q2))/b - sin(q1 - q2)^2*(1 + 3/tan(q2 - q3)^2)/c)) + u1'*sin(q1 - q2)*cos(q2 -
    //   q3))/sin(q2 - q3) + u1_dot_by_q3*sin(q1 - q2))/(c*sin(q2 - q3))
    let q3_ddot_by_q3 = (-cos_q1_minus_q2_c_inv)
        .mul_add(q2_ddot_by_q1_of_q1_dot_4, q3_ddot_by_q1_of_q1_dot_4)
        - u1_dot_by_q3 * q3_ddot_by_q1_of_a_c_q1_q2_q3
        - sin_q1_minus_q2_c_inv * q2_ddot_by_q2_of_motion - q3_ddot_by_q2_of_q1_dot;
    // u1_dot_by_q1_dot = -(3*a^2*mb*q1'*sin(q1 - q2)*sin(q1 - q3)/sin(q2 - q3) + 2*a^2*mc*q1'*sin(q1 -
    //   q2)*(cos(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) + sin(q1 - q3)*(cos(q1 - q2) + sin(q1 -
    //   q2)/tan(q2 - q3))/b)/sin(q2 - q3))/sin(q2 - q3)^2 + a^2*mb*q1'*(cos(q1 - q3) + a*(sin(q1 -
    //   q3)^2/(b*tan(q2 - q3)) + sin(q1 - q2)*(sin(q1 - q3)/tan(q3 - q2) + cos(q1 - q3))/c)/sin(q2 -
    //   q3))*(2*sin(q1 - q3)/sin(q2 - q3) - 3*cos(q1 - q2))/sin(q2 - q3))/(a^2*(ma + mc*sin(q1 -
    //   q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 -
    //   q3))))
    let u1_dot_by_q1_dot = -u1_dot_of_place
        * u1_dot_of_q1_dot.mul_add(u1_dot_of_place_2, u1_dot_of_q1_dot_2);
    let u1_dot_of_q1_dot_doubled = S::int(2) * u1_dot_of_q1_dot;
    let q2_ddot_by_q1_dot_of_q1_dot = a_sin_q2_minus_q3_inv * u1_dot_of_q1_dot_doubled;
    // q2_ddot_by_q1_dot = -a*(2*q1'*(cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 - q3)) + sin(q1 -
    //   q2)*(sin(q1 - q3)/tan(q3 - q2) + cos(q1 - q3))/c)/sin(q2 - q3)) + u1_dot_by_q1_dot*sin(q1 -
    //   q3))/(b*sin(q2 - q3))
    let q2_ddot_by_q1_dot = (-cos_q1_minus_q3_b_inv)
        .mul_add(
            u1_dot_of_q1_dot_doubled,
            -u1_dot_by_q1_dot * q2_ddot_by_q1_of_a_b_q1_q2_q3,
        ) - q2_ddot_by_q3_of_b_c_q1_q2_q3 * q2_ddot_by_q1_dot_of_q1_dot;
    // q3_ddot_by_q1_dot = -a*(2*q1'*(cos(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) + sin(q1 -
    //   q3)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3)) + u1_dot_by_q1_dot*sin(q1 -
    //   q2))/(c*sin(q2 - q3))
    let q3_ddot_by_q1_dot = (-cos_q1_minus_q2_c_inv)
        .mul_add(
            u1_dot_of_q1_dot_doubled,
            -u1_dot_by_q1_dot * q3_ddot_by_q1_of_a_c_q1_q2_q3,
        ) - q3_ddot_by_q2_of_b_c_q1_q2_q3 * q2_ddot_by_q1_dot_of_q1_dot;
    // u1_dot_by_q2_dot = -3*b*mb*q2'*sin(q1 - q2)/(a*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 -
    //   sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3))))
    let u1_dot_by_q2_dot = -u1_dot_of_mb_q1_q2 * u1_dot_of_place_a_inv * b_q2_dot;
    // q2_ddot_by_q2_dot = -a*u1_dot_by_q2_dot*sin(q1 - q3)/(b*sin(q2 - q3))
    let q2_ddot_by_q2_dot = -u1_dot_by_q2_dot * q2_ddot_by_q1_of_a_b_q1_q2_q3;
    // q3_ddot_by_q2_dot = -a*u1_dot_by_q2_dot*sin(q1 - q2)/(c*sin(q2 - q3))
    let q3_ddot_by_q2_dot = -u1_dot_by_q2_dot * q3_ddot_by_q1_of_a_c_q1_q2_q3;
    // Entries that are not zero.
    // d(q1')/d(q1') = 1
    let q1_dot_by_q1_dot_value = S::int(1);
    // d(q2')/d(q2') = 1
    let q2_dot_by_q2_dot_value = S::int(1);
    // d(q3')/d(q3') = 1
    let q3_dot_by_q3_dot_value = S::int(1);
    let zero = S::int(0);
    [
        [zero, zero, zero, q1_dot_by_q1_dot_value, zero, zero],
        [zero, zero, zero, zero, q2_dot_by_q2_dot_value, zero],
        [zero, zero, zero, zero, zero, q3_dot_by_q3_dot_value],
        [
            u1_dot_by_q1, u1_dot_by_q2, u1_dot_by_q3, u1_dot_by_q1_dot, u1_dot_by_q2_dot, zero,
        ],
        [
            q2_ddot_by_q1, q2_ddot_by_q2, q2_ddot_by_q3, q2_ddot_by_q1_dot, q2_ddot_by_q2_dot, zero,
        ],
        [
            q3_ddot_by_q1, q3_ddot_by_q2, q3_ddot_by_q3, q3_ddot_by_q1_dot, q3_ddot_by_q2_dot, zero,
        ],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 1 operation, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 3], _q_dot: &[S; 3]) -> [S; 1] {
    let [_, q2, q3] = *q;
    // Sines and cosines.
    let (sin_q2_minus_q3, _) = (q2 - q3).sin_cos();
    // Values.
    // divisor1 = sin(q2 - q3)
    let divisor1 = sin_q2_minus_q3;
    [divisor1]
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 21 operations, 3 sines and cosines.
#[must_use]
pub fn constraints<S: Scalar>(p: &Parameters<S>, q: &[S; 3], q_dot: &[S; 3]) -> [S; 4] {
    let Parameters { a, b, c, d, .. } = *p;
    let [q1, q2, q3] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    let a_c1 = a * c1;
    let b_c2 = b * c2;
    let c_c3 = c * c3;
    let a_s1 = a * s1;
    let b_s2 = b * s2;
    let c_s3 = c * s3;
    // Values.
    // loop_x = a*cos(q1) - d + b*cos(q2) - c*cos(q3)
    let residual1 = a_c1 - d + b_c2 - c_c3;
    // loop_y = a*sin(q1) + b*sin(q2) - c*sin(q3)
    let residual2 = a_s1 + b_s2 - c_s3;
    // loop_x' = c*q3'*sin(q3) - a*q1'*sin(q1) - b*q2'*sin(q2)
    let residual3 = (-q1_dot).mul_add(a_s1, q3_dot * c_s3) - q2_dot * b_s2;
    // loop_y' = a*q1'*cos(q1) + b*q2'*cos(q2) - c*q3'*cos(q3)
    let residual4 = q2_dot.mul_add(b_c2, q1_dot * a_c1) - q3_dot * c_c3;
    [residual1, residual2, residual3, residual4]
}

/// Slopes of the constraints, one after the other, along q1, q2, q3, q1', q2', q3'.
///
/// 19 operations, 3 sines and cosines.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 24] {
    let Parameters { a, b, c, .. } = *p;
    let [q1, q2, q3] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    let a_s1 = a * s1;
    let b_s2 = b * s2;
    let c_s3 = c * s3;
    let a_c1 = a * c1;
    let b_c2 = b * c2;
    let c_c3 = c * c3;
    // -a_s1
    let minus_a_s1 = -a_s1;
    // -b_s2
    let minus_b_s2 = -b_s2;
    // -c_c3
    let minus_c_c3 = -c_c3;
    // Values.
    // d(loop_x)/d(q1) = -a*sin(q1)
    let residual1_by_q1 = minus_a_s1;
    // d(loop_x)/d(q2) = -b*sin(q2)
    let residual1_by_q2 = minus_b_s2;
    // d(loop_x)/d(q3) = c*sin(q3)
    let residual1_by_q3 = c_s3;
    // d(loop_y)/d(q1) = a*cos(q1)
    let residual2_by_q1 = a_c1;
    // d(loop_y)/d(q2) = b*cos(q2)
    let residual2_by_q2 = b_c2;
    // d(loop_y)/d(q3) = -c*cos(q3)
    let residual2_by_q3 = minus_c_c3;
    // d(loop_x')/d(q1) = -a*q1'*cos(q1)
    let residual3_by_q1 = -q1_dot * a_c1;
    // d(loop_x')/d(q2) = -b*q2'*cos(q2)
    let residual3_by_q2 = -q2_dot * b_c2;
    // d(loop_x')/d(q3) = c*q3'*cos(q3)
    let residual3_by_q3 = q3_dot * c_c3;
    // d(loop_x')/d(q1') = -a*sin(q1)
    let residual3_by_q1_dot = minus_a_s1;
    // d(loop_x')/d(q2') = -b*sin(q2)
    let residual3_by_q2_dot = minus_b_s2;
    // d(loop_x')/d(q3') = c*sin(q3)
    let residual3_by_q3_dot = c_s3;
    // d(loop_y')/d(q1) = -a*q1'*sin(q1)
    let residual4_by_q1 = -q1_dot * a_s1;
    // d(loop_y')/d(q2) = -b*q2'*sin(q2)
    let residual4_by_q2 = -q2_dot * b_s2;
    // d(loop_y')/d(q3) = c*q3'*sin(q3)
    let residual4_by_q3 = q3_dot * c_s3;
    // d(loop_y')/d(q1') = a*cos(q1)
    let residual4_by_q1_dot = a_c1;
    // d(loop_y')/d(q2') = b*cos(q2)
    let residual4_by_q2_dot = b_c2;
    // d(loop_y')/d(q3') = -c*cos(q3)
    let residual4_by_q3_dot = minus_c_c3;
    let zero = S::int(0);
    [
        residual1_by_q1, residual1_by_q2, residual1_by_q3, zero, zero, zero, residual2_by_q1,
        residual2_by_q2, residual2_by_q3, zero, zero, zero, residual3_by_q1, residual3_by_q2,
        residual3_by_q3, residual3_by_q1_dot, residual3_by_q2_dot, residual3_by_q3_dot,
        residual4_by_q1, residual4_by_q2, residual4_by_q3, residual4_by_q1_dot, residual4_by_q2_dot,
        residual4_by_q3_dot,
    ]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 38 convolutions and 72 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 6]],
    history: &mut [Factors<S, 40>],
) {
    let Parameters { a, b, c, ma, mb, mc, g, .. } = *p;
    let [q1_0, q2_0, q3_0, q1_dot_0, q2_dot_0, q3_dot_0] = series[0];
    // Shared terms.
    let c_inv = S::int(1) / c;
    // Constant in time.
    // weight = 1/c
    let weight = c_inv;
    // weight_2 = 1/b
    let weight_2 = S::int(1) / b;
    // minus_1_by_c = -1/c
    let minus_1_by_c = -c_inv;
    // ma_plus_3_mb = ma + 3*mb
    let ma_plus_3_mb = mb.mul_add(S::int(3), ma);
    // minus_mb = -mb
    let minus_mb = -mb;
    // weight_3 = 3*a*(ma*g + 2*mb*g)
    let weight_3 = S::int(3) * a * (mb * g).mul_add(S::int(2), ma * g);
    // minus_3_a_mb_g = -3*a*mb*g
    let minus_3_a_mb_g = -S::int(3) * a * mb * g;
    // weight_4 = 3*a*mb
    let weight_4 = S::int(3) * a * mb;
    // minus_3_a_mc_g = -3*a*mc*g
    let minus_3_a_mc_g = -S::int(3) * a * mc * g;
    // minus_a_2_mb = -a^2*mb
    let minus_a_2_mb = -a * a * mb;
    // weight_5 = 2*a^2*mc
    let weight_5 = S::int(2) * a * a * mc;
    // minus_a_by_b = -a/b
    let minus_a_by_b = -a / b;
    // weight_6 = 1/(2*a*b)
    let weight_6 = S::ratio(1, 2) / (a * b);
    // minus_a_by_c = -a/c
    let minus_a_by_c = -a / c;
    // weight_7 = 1/(2*a*c)
    let weight_7 = S::ratio(1, 2) / (a * c);
    // minus_1_by_2_a_2 = -1/(2*a^2)
    let minus_1_by_2_a_2 = -S::ratio(1, 2) / (a * a);
    // Order 0.
    let (s1_0, c1_0) = q1_0.sin_cos();
    let (s2_0, c2_0) = q2_0.sin_cos();
    let (s3_0, c3_0) = q3_0.sin_cos();
    let q2_minus_q3_0 = q2_0 - q3_0;
    let (sin_q2_minus_q3_0, cos_q2_minus_q3_0) = q2_minus_q3_0.sin_cos();
    let over_sin_q2_minus_q3 = S::int(1) / sin_q2_minus_q3_0;
    let q1_minus_q3_0 = q1_0 - q3_0;
    let (sin_q1_minus_q3_0, cos_q1_minus_q3_0) = q1_minus_q3_0.sin_cos();
    let q1_minus_q2_0 = q1_0 - q2_0;
    let (sin_q1_minus_q2_0, cos_q1_minus_q2_0) = q1_minus_q2_0.sin_cos();
    let u1_dot_of_q1_q2_q3_0 = sin_q1_minus_q3_0 * over_sin_q2_minus_q3;
    let u1_dot_of_q1_q2_q3_2_0 = cos_q2_minus_q3_0 * u1_dot_of_q1_q2_q3_0;
    let u1_dot_of_q1_q2_q3_3_0 = cos_q1_minus_q3_0 - u1_dot_of_q1_q2_q3_2_0;
    let u1_dot_of_q1_q2_q3_4_0 = sin_q1_minus_q2_0 * u1_dot_of_q1_q2_q3_3_0;
    let u1_dot_of_q1_q2_q3_5_0 = sin_q1_minus_q3_0 * u1_dot_of_q1_q2_q3_2_0;
    let u1_dot_of_b_c_q1_q2_q3_0 = u1_dot_of_q1_q2_q3_4_0
        .mul_add(weight, weight_2 * u1_dot_of_q1_q2_q3_5_0);
    let u1_dot_of_b_c_q1_q2_q3_2_0 = u1_dot_of_b_c_q1_q2_q3_0 * over_sin_q2_minus_q3;
    let u1_dot_of_place_0 = u1_dot_of_b_c_q1_q2_q3_2_0.mul_add(a, cos_q1_minus_q3_0);
    let u1_dot_of_q1_q2_q3_6_0 = sin_q1_minus_q2_0 * over_sin_q2_minus_q3;
    let u1_dot_of_q1_q2_q3_7_0 = cos_q2_minus_q3_0 * u1_dot_of_q1_q2_q3_6_0;
    let u1_dot_of_q1_q2_q3_8_0 = cos_q1_minus_q2_0 + u1_dot_of_q1_q2_q3_7_0;
    let u1_dot_of_q1_q2_q3_9_0 = sin_q1_minus_q3_0 * u1_dot_of_q1_q2_q3_8_0;
    let u1_dot_of_q1_q2_q3_10_0 = sin_q1_minus_q2_0 * u1_dot_of_q1_q2_q3_7_0;
    let u1_dot_of_b_c_q1_q2_q3_3_0 = u1_dot_of_q1_q2_q3_9_0
        .mul_add(weight_2, minus_1_by_c * u1_dot_of_q1_q2_q3_10_0);
    let u1_dot_of_b_c_q1_q2_q3_4_0 = u1_dot_of_b_c_q1_q2_q3_3_0 * over_sin_q2_minus_q3;
    let u1_dot_of_place_2_0 = u1_dot_of_b_c_q1_q2_q3_4_0.mul_add(a, cos_q1_minus_q2_0);
    let u1_dot_of_q1_q2_q3_11_0 = u1_dot_of_q1_q2_q3_0
        .mul_add(-S::int(2), S::int(3) * cos_q1_minus_q2_0);
    let q2_dot_sq_0 = q2_dot_0 * q2_dot_0;
    let u1_dot_of_q1_q2_q3_12_0 = c2_0 * u1_dot_of_q1_q2_q3_0;
    let q1_dot_sq_0 = q1_dot_0 * q1_dot_0;
    let u1_dot_of_q1_dot_0 = u1_dot_of_q1_q2_q3_0 * q1_dot_sq_0;
    let u1_dot_of_motion_0 = u1_dot_of_q1_dot_0.mul_add(a, b * q2_dot_sq_0);
    let u1_dot_of_motion_2_0 = sin_q1_minus_q2_0 * u1_dot_of_motion_0;
    let u1_dot_of_q1_q2_q3_13_0 = c3_0 * u1_dot_of_q1_q2_q3_6_0;
    let u1_dot_of_q1_dot_2_0 = q1_dot_sq_0 * over_sin_q2_minus_q3;
    let u1_dot_of_q1_dot_3_0 = u1_dot_of_place_0 * u1_dot_of_q1_dot_2_0;
    let u1_dot_of_q1_dot_4_0 = u1_dot_of_q1_q2_q3_11_0 * u1_dot_of_q1_dot_3_0;
    let u1_dot_of_q1_dot_5_0 = u1_dot_of_place_2_0 * u1_dot_of_q1_dot_2_0;
    let u1_dot_of_q1_dot_6_0 = u1_dot_of_q1_q2_q3_6_0 * u1_dot_of_q1_dot_5_0;
    let u1_dot_of_q1_q2_q3_14_0 = S::int(3) * cos_q1_minus_q2_0 - u1_dot_of_q1_q2_q3_0;
    let u1_dot_of_q1_q2_q3_15_0 = u1_dot_of_q1_q2_q3_14_0 * u1_dot_of_q1_q2_q3_0;
    let u1_dot_of_q1_q2_q3_16_0 = u1_dot_of_q1_q2_q3_6_0 * u1_dot_of_q1_q2_q3_6_0;
    let u1_dot_of_place_3_0 = u1_dot_of_q1_q2_q3_15_0
        .mul_add(minus_mb, u1_dot_of_q1_q2_q3_16_0.mul_add(mc, ma_plus_3_mb));
    let over_u1_dot_of_place_3 = S::int(1) / u1_dot_of_place_3_0;
    let u1_dot_of_motion_3_0 = u1_dot_of_q1_dot_6_0
        .mul_add(
            weight_5,
            u1_dot_of_q1_dot_4_0
                .mul_add(
                    minus_a_2_mb,
                    u1_dot_of_motion_2_0
                        .mul_add(
                            weight_4,
                            u1_dot_of_q1_q2_q3_13_0
                                .mul_add(
                                    minus_3_a_mc_g,
                                    u1_dot_of_q1_q2_q3_12_0
                                        .mul_add(minus_3_a_mb_g, weight_3 * c1_0),
                                ),
                        ),
                ),
        );
    let u1_dot_of_motion_4_0 = u1_dot_of_motion_3_0 * over_u1_dot_of_place_3;
    let q2_ddot_of_motion_0 = u1_dot_of_motion_4_0 * u1_dot_of_q1_q2_q3_0;
    let q2_dot_dot_0 = q2_ddot_of_motion_0
        .mul_add(weight_6, minus_a_by_b * u1_dot_of_q1_dot_3_0);
    let q3_ddot_of_motion_0 = u1_dot_of_motion_4_0 * u1_dot_of_q1_q2_q3_6_0;
    let q3_dot_dot_0 = q3_ddot_of_motion_0
        .mul_add(weight_7, minus_a_by_c * u1_dot_of_q1_dot_5_0);
    // Order 1: the rates, and what follows from them.
    let q1_1 = q1_dot_0;
    let q2_1 = q2_dot_0;
    let q3_1 = q3_dot_0;
    let q1_dot_1 = minus_1_by_2_a_2 * u1_dot_of_motion_4_0;
    let q2_dot_1 = q2_dot_dot_0;
    let q3_dot_1 = q3_dot_dot_0;
    if series.len() > 1 {
        series[1] = [q1_1, q2_1, q3_1, q1_dot_1, q2_dot_1, q3_dot_1];
    }
    let s1_1 = q1_1 * c1_0;
    let c1_1 = -q1_1 * s1_0;
    let s2_1 = q2_1 * c2_0;
    let c2_1 = -q2_1 * s2_0;
    let s3_1 = q3_1 * c3_0;
    let c3_1 = -q3_1 * s3_0;
    let q2_minus_q3_1 = q2_1 - q3_1;
    let sin_q2_minus_q3_1 = q2_minus_q3_1 * cos_q2_minus_q3_0;
    let cos_q2_minus_q3_1 = -q2_minus_q3_1 * sin_q2_minus_q3_0;
    let q1_minus_q3_1 = q1_1 - q3_1;
    let sin_q1_minus_q3_1 = q1_minus_q3_1 * cos_q1_minus_q3_0;
    let cos_q1_minus_q3_1 = -q1_minus_q3_1 * sin_q1_minus_q3_0;
    let q1_minus_q2_1 = q1_1 - q2_1;
    let sin_q1_minus_q2_1 = q1_minus_q2_1 * cos_q1_minus_q2_0;
    let cos_q1_minus_q2_1 = -q1_minus_q2_1 * sin_q1_minus_q2_0;
    let u1_dot_of_q1_q2_q3_1 = sin_q2_minus_q3_1
        .mul_add(
            -(u1_dot_of_q1_q2_q3_0 * over_sin_q2_minus_q3),
            sin_q1_minus_q3_1 * over_sin_q2_minus_q3,
        );
    let u1_dot_of_q1_q2_q3_2_1 = u1_dot_of_q1_q2_q3_1
        .mul_add(cos_q2_minus_q3_0, cos_q2_minus_q3_1 * u1_dot_of_q1_q2_q3_0);
    let u1_dot_of_q1_q2_q3_3_1 = cos_q1_minus_q3_1 - u1_dot_of_q1_q2_q3_2_1;
    let u1_dot_of_q1_q2_q3_4_1 = u1_dot_of_q1_q2_q3_3_1
        .mul_add(sin_q1_minus_q2_0, sin_q1_minus_q2_1 * u1_dot_of_q1_q2_q3_3_0);
    let u1_dot_of_q1_q2_q3_5_1 = u1_dot_of_q1_q2_q3_2_1
        .mul_add(sin_q1_minus_q3_0, sin_q1_minus_q3_1 * u1_dot_of_q1_q2_q3_2_0);
    let u1_dot_of_b_c_q1_q2_q3_1 = u1_dot_of_q1_q2_q3_4_1
        .mul_add(weight, weight_2 * u1_dot_of_q1_q2_q3_5_1);
    let u1_dot_of_b_c_q1_q2_q3_2_1 = sin_q2_minus_q3_1
        .mul_add(
            -(u1_dot_of_b_c_q1_q2_q3_2_0 * over_sin_q2_minus_q3),
            u1_dot_of_b_c_q1_q2_q3_1 * over_sin_q2_minus_q3,
        );
    let u1_dot_of_place_1 = u1_dot_of_b_c_q1_q2_q3_2_1.mul_add(a, cos_q1_minus_q3_1);
    let u1_dot_of_q1_q2_q3_6_1 = sin_q2_minus_q3_1
        .mul_add(
            -(u1_dot_of_q1_q2_q3_6_0 * over_sin_q2_minus_q3),
            sin_q1_minus_q2_1 * over_sin_q2_minus_q3,
        );
    let u1_dot_of_q1_q2_q3_7_1 = u1_dot_of_q1_q2_q3_6_1
        .mul_add(cos_q2_minus_q3_0, cos_q2_minus_q3_1 * u1_dot_of_q1_q2_q3_6_0);
    let u1_dot_of_q1_q2_q3_8_1 = cos_q1_minus_q2_1 + u1_dot_of_q1_q2_q3_7_1;
    let u1_dot_of_q1_q2_q3_9_1 = u1_dot_of_q1_q2_q3_8_1
        .mul_add(sin_q1_minus_q3_0, sin_q1_minus_q3_1 * u1_dot_of_q1_q2_q3_8_0);
    let u1_dot_of_q1_q2_q3_10_1 = u1_dot_of_q1_q2_q3_7_1
        .mul_add(sin_q1_minus_q2_0, sin_q1_minus_q2_1 * u1_dot_of_q1_q2_q3_7_0);
    let u1_dot_of_b_c_q1_q2_q3_3_1 = u1_dot_of_q1_q2_q3_9_1
        .mul_add(weight_2, minus_1_by_c * u1_dot_of_q1_q2_q3_10_1);
    let u1_dot_of_b_c_q1_q2_q3_4_1 = sin_q2_minus_q3_1
        .mul_add(
            -(u1_dot_of_b_c_q1_q2_q3_4_0 * over_sin_q2_minus_q3),
            u1_dot_of_b_c_q1_q2_q3_3_1 * over_sin_q2_minus_q3,
        );
    let u1_dot_of_place_2_1 = u1_dot_of_b_c_q1_q2_q3_4_1.mul_add(a, cos_q1_minus_q2_1);
    let u1_dot_of_q1_q2_q3_11_1 = u1_dot_of_q1_q2_q3_1
        .mul_add(-S::int(2), S::int(3) * cos_q1_minus_q2_1);
    let q2_dot_sq_1 = q2_dot_1 * (q2_dot_0 + q2_dot_0);
    let u1_dot_of_q1_q2_q3_12_1 = u1_dot_of_q1_q2_q3_1
        .mul_add(c2_0, c2_1 * u1_dot_of_q1_q2_q3_0);
    let q1_dot_sq_1 = q1_dot_1 * (q1_dot_0 + q1_dot_0);
    let u1_dot_of_q1_dot_1 = u1_dot_of_q1_q2_q3_1
        .mul_add(q1_dot_sq_0, q1_dot_sq_1 * u1_dot_of_q1_q2_q3_0);
    let u1_dot_of_motion_1 = u1_dot_of_q1_dot_1.mul_add(a, b * q2_dot_sq_1);
    let u1_dot_of_motion_2_1 = u1_dot_of_motion_1
        .mul_add(sin_q1_minus_q2_0, sin_q1_minus_q2_1 * u1_dot_of_motion_0);
    let u1_dot_of_q1_q2_q3_13_1 = u1_dot_of_q1_q2_q3_6_1
        .mul_add(c3_0, c3_1 * u1_dot_of_q1_q2_q3_6_0);
    let u1_dot_of_q1_dot_2_1 = sin_q2_minus_q3_1
        .mul_add(
            -(u1_dot_of_q1_dot_2_0 * over_sin_q2_minus_q3),
            q1_dot_sq_1 * over_sin_q2_minus_q3,
        );
    let u1_dot_of_q1_dot_3_1 = u1_dot_of_place_1
        .mul_add(u1_dot_of_q1_dot_2_0, u1_dot_of_q1_dot_2_1 * u1_dot_of_place_0);
    let u1_dot_of_q1_dot_4_1 = u1_dot_of_q1_dot_3_1
        .mul_add(
            u1_dot_of_q1_q2_q3_11_0,
            u1_dot_of_q1_q2_q3_11_1 * u1_dot_of_q1_dot_3_0,
        );
    let u1_dot_of_q1_dot_5_1 = u1_dot_of_place_2_1
        .mul_add(u1_dot_of_q1_dot_2_0, u1_dot_of_q1_dot_2_1 * u1_dot_of_place_2_0);
    let u1_dot_of_q1_dot_6_1 = u1_dot_of_q1_dot_5_1
        .mul_add(u1_dot_of_q1_q2_q3_6_0, u1_dot_of_q1_q2_q3_6_1 * u1_dot_of_q1_dot_5_0);
    let u1_dot_of_q1_q2_q3_14_1 = S::int(3) * cos_q1_minus_q2_1 - u1_dot_of_q1_q2_q3_1;
    let u1_dot_of_q1_q2_q3_15_1 = u1_dot_of_q1_q2_q3_14_1
        .mul_add(u1_dot_of_q1_q2_q3_0, u1_dot_of_q1_q2_q3_1 * u1_dot_of_q1_q2_q3_14_0);
    let u1_dot_of_q1_q2_q3_16_1 = u1_dot_of_q1_q2_q3_6_1
        * (u1_dot_of_q1_q2_q3_6_0 + u1_dot_of_q1_q2_q3_6_0);
    let u1_dot_of_place_3_1 = u1_dot_of_q1_q2_q3_15_1
        .mul_add(minus_mb, mc * u1_dot_of_q1_q2_q3_16_1);
    let u1_dot_of_motion_3_1 = u1_dot_of_q1_dot_6_1
        .mul_add(
            weight_5,
            u1_dot_of_q1_dot_4_1
                .mul_add(
                    minus_a_2_mb,
                    u1_dot_of_motion_2_1
                        .mul_add(
                            weight_4,
                            u1_dot_of_q1_q2_q3_13_1
                                .mul_add(
                                    minus_3_a_mc_g,
                                    u1_dot_of_q1_q2_q3_12_1
                                        .mul_add(minus_3_a_mb_g, weight_3 * c1_1),
                                ),
                        ),
                ),
        );
    let u1_dot_of_motion_4_1 = u1_dot_of_place_3_1
        .mul_add(
            -(u1_dot_of_motion_4_0 * over_u1_dot_of_place_3),
            u1_dot_of_motion_3_1 * over_u1_dot_of_place_3,
        );
    let q2_ddot_of_motion_1 = u1_dot_of_motion_4_1
        .mul_add(u1_dot_of_q1_q2_q3_0, u1_dot_of_q1_q2_q3_1 * u1_dot_of_motion_4_0);
    let q2_dot_dot_1 = q2_ddot_of_motion_1
        .mul_add(weight_6, minus_a_by_b * u1_dot_of_q1_dot_3_1);
    let q3_ddot_of_motion_1 = u1_dot_of_motion_4_1
        .mul_add(u1_dot_of_q1_q2_q3_6_0, u1_dot_of_q1_q2_q3_6_1 * u1_dot_of_motion_4_0);
    let q3_dot_dot_1 = q3_ddot_of_motion_1
        .mul_add(weight_7, minus_a_by_c * u1_dot_of_q1_dot_5_1);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                q1_1, q1_1, q2_1, q2_1, q3_1, q3_1, q2_minus_q3_1, q2_minus_q3_1, q1_minus_q3_1,
                q1_minus_q3_1, q1_minus_q2_1, q1_minus_q2_1, sin_q2_minus_q3_1, cos_q2_minus_q3_1,
                sin_q1_minus_q2_1, sin_q1_minus_q3_1, sin_q2_minus_q3_1, sin_q2_minus_q3_1,
                cos_q2_minus_q3_1, sin_q1_minus_q3_1, sin_q1_minus_q2_1, sin_q2_minus_q3_1,
                q2_dot_1, c2_1, q1_dot_1, u1_dot_of_q1_q2_q3_1, sin_q1_minus_q2_1, c3_1,
                sin_q2_minus_q3_1, u1_dot_of_place_1, u1_dot_of_q1_q2_q3_11_1, u1_dot_of_place_2_1,
                u1_dot_of_q1_q2_q3_6_1, u1_dot_of_q1_q2_q3_14_1, u1_dot_of_q1_q2_q3_6_1,
                u1_dot_of_place_3_1, u1_dot_of_motion_4_1, u1_dot_of_motion_4_1,
            ]),
            padded([
                c1_1, s1_1, c2_1, s2_1, c3_1, s3_1, cos_q2_minus_q3_1, sin_q2_minus_q3_1,
                cos_q1_minus_q3_1, sin_q1_minus_q3_1, cos_q1_minus_q2_1, sin_q1_minus_q2_1,
                u1_dot_of_q1_q2_q3_1, u1_dot_of_q1_q2_q3_1, u1_dot_of_q1_q2_q3_3_1,
                u1_dot_of_q1_q2_q3_2_1, u1_dot_of_b_c_q1_q2_q3_2_1, u1_dot_of_q1_q2_q3_6_1,
                u1_dot_of_q1_q2_q3_6_1, u1_dot_of_q1_q2_q3_8_1, u1_dot_of_q1_q2_q3_7_1,
                u1_dot_of_b_c_q1_q2_q3_4_1, q2_dot_1, u1_dot_of_q1_q2_q3_1, q1_dot_1, q1_dot_sq_1,
                u1_dot_of_motion_1, u1_dot_of_q1_q2_q3_6_1, u1_dot_of_q1_dot_2_1,
                u1_dot_of_q1_dot_2_1, u1_dot_of_q1_dot_3_1, u1_dot_of_q1_dot_2_1,
                u1_dot_of_q1_dot_5_1, u1_dot_of_q1_q2_q3_1, u1_dot_of_q1_q2_q3_6_1,
                u1_dot_of_motion_4_1, u1_dot_of_q1_q2_q3_1, u1_dot_of_q1_q2_q3_6_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q1_last = q1_1;
    let mut q2_last = q2_1;
    let mut q3_last = q3_1;
    let mut q1_dot_last = q1_dot_1;
    let mut q2_dot_last = q2_dot_1;
    let mut s1_last = s1_1;
    let mut c1_last = c1_1;
    let mut s2_last = s2_1;
    let mut c2_last = c2_1;
    let mut s3_last = s3_1;
    let mut c3_last = c3_1;
    let mut q2_minus_q3_last = q2_minus_q3_1;
    let mut sin_q2_minus_q3_last = sin_q2_minus_q3_1;
    let mut cos_q2_minus_q3_last = cos_q2_minus_q3_1;
    let mut q1_minus_q3_last = q1_minus_q3_1;
    let mut sin_q1_minus_q3_last = sin_q1_minus_q3_1;
    let mut cos_q1_minus_q3_last = cos_q1_minus_q3_1;
    let mut q1_minus_q2_last = q1_minus_q2_1;
    let mut sin_q1_minus_q2_last = sin_q1_minus_q2_1;
    let mut cos_q1_minus_q2_last = cos_q1_minus_q2_1;
    let mut u1_dot_of_q1_q2_q3_last = u1_dot_of_q1_q2_q3_1;
    let mut u1_dot_of_q1_q2_q3_2_last = u1_dot_of_q1_q2_q3_2_1;
    let mut u1_dot_of_q1_q2_q3_3_last = u1_dot_of_q1_q2_q3_3_1;
    let mut u1_dot_of_b_c_q1_q2_q3_2_last = u1_dot_of_b_c_q1_q2_q3_2_1;
    let mut u1_dot_of_place_last = u1_dot_of_place_1;
    let mut u1_dot_of_q1_q2_q3_6_last = u1_dot_of_q1_q2_q3_6_1;
    let mut u1_dot_of_q1_q2_q3_7_last = u1_dot_of_q1_q2_q3_7_1;
    let mut u1_dot_of_q1_q2_q3_8_last = u1_dot_of_q1_q2_q3_8_1;
    let mut u1_dot_of_b_c_q1_q2_q3_4_last = u1_dot_of_b_c_q1_q2_q3_4_1;
    let mut u1_dot_of_place_2_last = u1_dot_of_place_2_1;
    let mut u1_dot_of_q1_q2_q3_11_last = u1_dot_of_q1_q2_q3_11_1;
    let mut q1_dot_sq_last = q1_dot_sq_1;
    let mut u1_dot_of_motion_last = u1_dot_of_motion_1;
    let mut u1_dot_of_q1_dot_2_last = u1_dot_of_q1_dot_2_1;
    let mut u1_dot_of_q1_dot_3_last = u1_dot_of_q1_dot_3_1;
    let mut u1_dot_of_q1_dot_5_last = u1_dot_of_q1_dot_5_1;
    let mut u1_dot_of_q1_q2_q3_14_last = u1_dot_of_q1_q2_q3_14_1;
    let mut u1_dot_of_place_3_last = u1_dot_of_place_3_1;
    let mut u1_dot_of_motion_4_last = u1_dot_of_motion_4_1;
    let mut next = [S::int(0); 40];
    // Rates at order k - 1.
    let mut q1_rate = q1_dot_1;
    let mut q2_rate = q2_dot_1;
    let mut q3_rate = q3_dot_1;
    let mut q1_dot_rate = minus_1_by_2_a_2 * u1_dot_of_motion_4_1;
    let mut q2_dot_rate = q2_dot_dot_1;
    let mut q3_dot_rate = q3_dot_dot_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q1 = q1_rate * over_k;
        let q2 = q2_rate * over_k;
        let q3 = q3_rate * over_k;
        let q1_dot = q1_dot_rate * over_k;
        let q2_dot = q2_dot_rate * over_k;
        let q3_dot = q3_dot_rate * over_k;
        series[order] = [q1, q2, q3, q1_dot, q2_dot, q3_dot];
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
                q1_1.mul_add(c1_last, (count_last * q1_last).mul_add(c1_1, next[0])),
                q1_1.mul_add(s1_last, (count_last * q1_last).mul_add(s1_1, next[1])),
                q2_1.mul_add(c2_last, (count_last * q2_last).mul_add(c2_1, next[2])),
                q2_1.mul_add(s2_last, (count_last * q2_last).mul_add(s2_1, next[3])),
                q3_1.mul_add(c3_last, (count_last * q3_last).mul_add(c3_1, next[4])),
                q3_1.mul_add(s3_last, (count_last * q3_last).mul_add(s3_1, next[5])),
                q2_minus_q3_1
                    .mul_add(
                        cos_q2_minus_q3_last,
                        (count_last * q2_minus_q3_last)
                            .mul_add(cos_q2_minus_q3_1, next[6]),
                    ),
                q2_minus_q3_1
                    .mul_add(
                        sin_q2_minus_q3_last,
                        (count_last * q2_minus_q3_last)
                            .mul_add(sin_q2_minus_q3_1, next[7]),
                    ),
                q1_minus_q3_1
                    .mul_add(
                        cos_q1_minus_q3_last,
                        (count_last * q1_minus_q3_last)
                            .mul_add(cos_q1_minus_q3_1, next[8]),
                    ),
                q1_minus_q3_1
                    .mul_add(
                        sin_q1_minus_q3_last,
                        (count_last * q1_minus_q3_last)
                            .mul_add(sin_q1_minus_q3_1, next[9]),
                    ),
                q1_minus_q2_1
                    .mul_add(
                        cos_q1_minus_q2_last,
                        (count_last * q1_minus_q2_last)
                            .mul_add(cos_q1_minus_q2_1, next[10]),
                    ),
                q1_minus_q2_1
                    .mul_add(
                        sin_q1_minus_q2_last,
                        (count_last * q1_minus_q2_last)
                            .mul_add(sin_q1_minus_q2_1, next[11]),
                    ),
                sin_q2_minus_q3_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_last,
                        sin_q2_minus_q3_last.mul_add(u1_dot_of_q1_q2_q3_1, next[12]),
                    ),
                cos_q2_minus_q3_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_last,
                        cos_q2_minus_q3_last.mul_add(u1_dot_of_q1_q2_q3_1, next[13]),
                    ),
                sin_q1_minus_q2_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_3_last,
                        sin_q1_minus_q2_last.mul_add(u1_dot_of_q1_q2_q3_3_1, next[14]),
                    ),
                sin_q1_minus_q3_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_2_last,
                        sin_q1_minus_q3_last.mul_add(u1_dot_of_q1_q2_q3_2_1, next[15]),
                    ),
                sin_q2_minus_q3_1
                    .mul_add(
                        u1_dot_of_b_c_q1_q2_q3_2_last,
                        sin_q2_minus_q3_last
                            .mul_add(u1_dot_of_b_c_q1_q2_q3_2_1, next[16]),
                    ),
                sin_q2_minus_q3_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_6_last,
                        sin_q2_minus_q3_last.mul_add(u1_dot_of_q1_q2_q3_6_1, next[17]),
                    ),
                cos_q2_minus_q3_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_6_last,
                        cos_q2_minus_q3_last.mul_add(u1_dot_of_q1_q2_q3_6_1, next[18]),
                    ),
                sin_q1_minus_q3_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_8_last,
                        sin_q1_minus_q3_last.mul_add(u1_dot_of_q1_q2_q3_8_1, next[19]),
                    ),
                sin_q1_minus_q2_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_7_last,
                        sin_q1_minus_q2_last.mul_add(u1_dot_of_q1_q2_q3_7_1, next[20]),
                    ),
                sin_q2_minus_q3_1
                    .mul_add(
                        u1_dot_of_b_c_q1_q2_q3_4_last,
                        sin_q2_minus_q3_last
                            .mul_add(u1_dot_of_b_c_q1_q2_q3_4_1, next[21]),
                    ),
                (q2_dot_1 + q2_dot_1).mul_add(q2_dot_last, next[22]),
                c2_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_last,
                        c2_last.mul_add(u1_dot_of_q1_q2_q3_1, next[23]),
                    ),
                (q1_dot_1 + q1_dot_1).mul_add(q1_dot_last, next[24]),
                u1_dot_of_q1_q2_q3_1
                    .mul_add(
                        q1_dot_sq_last,
                        u1_dot_of_q1_q2_q3_last.mul_add(q1_dot_sq_1, next[25]),
                    ),
                sin_q1_minus_q2_1
                    .mul_add(
                        u1_dot_of_motion_last,
                        sin_q1_minus_q2_last.mul_add(u1_dot_of_motion_1, next[26]),
                    ),
                c3_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_6_last,
                        c3_last.mul_add(u1_dot_of_q1_q2_q3_6_1, next[27]),
                    ),
                sin_q2_minus_q3_1
                    .mul_add(
                        u1_dot_of_q1_dot_2_last,
                        sin_q2_minus_q3_last.mul_add(u1_dot_of_q1_dot_2_1, next[28]),
                    ),
                u1_dot_of_place_1
                    .mul_add(
                        u1_dot_of_q1_dot_2_last,
                        u1_dot_of_place_last.mul_add(u1_dot_of_q1_dot_2_1, next[29]),
                    ),
                u1_dot_of_q1_q2_q3_11_1
                    .mul_add(
                        u1_dot_of_q1_dot_3_last,
                        u1_dot_of_q1_q2_q3_11_last
                            .mul_add(u1_dot_of_q1_dot_3_1, next[30]),
                    ),
                u1_dot_of_place_2_1
                    .mul_add(
                        u1_dot_of_q1_dot_2_last,
                        u1_dot_of_place_2_last.mul_add(u1_dot_of_q1_dot_2_1, next[31]),
                    ),
                u1_dot_of_q1_q2_q3_6_1
                    .mul_add(
                        u1_dot_of_q1_dot_5_last,
                        u1_dot_of_q1_q2_q3_6_last.mul_add(u1_dot_of_q1_dot_5_1, next[32]),
                    ),
                u1_dot_of_q1_q2_q3_14_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_last,
                        u1_dot_of_q1_q2_q3_14_last
                            .mul_add(u1_dot_of_q1_q2_q3_1, next[33]),
                    ),
                (u1_dot_of_q1_q2_q3_6_1 + u1_dot_of_q1_q2_q3_6_1)
                    .mul_add(u1_dot_of_q1_q2_q3_6_last, next[34]),
                u1_dot_of_place_3_1
                    .mul_add(
                        u1_dot_of_motion_4_last,
                        u1_dot_of_place_3_last.mul_add(u1_dot_of_motion_4_1, next[35]),
                    ),
                u1_dot_of_motion_4_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_last,
                        u1_dot_of_motion_4_last.mul_add(u1_dot_of_q1_q2_q3_1, next[36]),
                    ),
                u1_dot_of_motion_4_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_6_last,
                        u1_dot_of_motion_4_last.mul_add(u1_dot_of_q1_q2_q3_6_1, next[37]),
                    ),
            ])
        };
        // s1 = sin(q1)
        let s1 = q1.mul_add(c1_0, sums[0] * over_k);
        // c1 = cos(q1)
        let c1 = -q1.mul_add(s1_0, sums[1] * over_k);
        // s2 = sin(q2)
        let s2 = q2.mul_add(c2_0, sums[2] * over_k);
        // c2 = cos(q2)
        let c2 = -q2.mul_add(s2_0, sums[3] * over_k);
        // s3 = sin(q3)
        let s3 = q3.mul_add(c3_0, sums[4] * over_k);
        // c3 = cos(q3)
        let c3 = -q3.mul_add(s3_0, sums[5] * over_k);
        // q2_minus_q3 = q2 - q3
        let q2_minus_q3 = q2 - q3;
        // sin_q2_minus_q3 = sin(q2_minus_q3)
        let sin_q2_minus_q3 = q2_minus_q3.mul_add(cos_q2_minus_q3_0, sums[6] * over_k);
        // cos_q2_minus_q3 = cos(q2_minus_q3)
        let cos_q2_minus_q3 = -q2_minus_q3.mul_add(sin_q2_minus_q3_0, sums[7] * over_k);
        // q1_minus_q3 = q1 - q3
        let q1_minus_q3 = q1 - q3;
        // sin_q1_minus_q3 = sin(q1_minus_q3)
        let sin_q1_minus_q3 = q1_minus_q3.mul_add(cos_q1_minus_q3_0, sums[8] * over_k);
        // cos_q1_minus_q3 = cos(q1_minus_q3)
        let cos_q1_minus_q3 = -q1_minus_q3.mul_add(sin_q1_minus_q3_0, sums[9] * over_k);
        // q1_minus_q2 = q1 - q2
        let q1_minus_q2 = q1 - q2;
        // sin_q1_minus_q2 = sin(q1_minus_q2)
        let sin_q1_minus_q2 = q1_minus_q2.mul_add(cos_q1_minus_q2_0, sums[10] * over_k);
        // cos_q1_minus_q2 = cos(q1_minus_q2)
        let cos_q1_minus_q2 = -q1_minus_q2.mul_add(sin_q1_minus_q2_0, sums[11] * over_k);
        // u1_dot_of_q1_q2_q3 = sin_q1_minus_q3/sin_q2_minus_q3
        let u1_dot_of_q1_q2_q3 = sin_q2_minus_q3
            .mul_add(
                -(u1_dot_of_q1_q2_q3_0 * over_sin_q2_minus_q3),
                (sin_q1_minus_q3 - sums[12]) * over_sin_q2_minus_q3,
            );
        // u1_dot_of_q1_q2_q3_2 = cos_q2_minus_q3*u1_dot_of_q1_q2_q3
        let u1_dot_of_q1_q2_q3_2 = u1_dot_of_q1_q2_q3
            .mul_add(
                cos_q2_minus_q3_0,
                cos_q2_minus_q3.mul_add(u1_dot_of_q1_q2_q3_0, sums[13]),
            );
        // u1_dot_of_q1_q2_q3_3 = cos_q1_minus_q3 - u1_dot_of_q1_q2_q3_2
        let u1_dot_of_q1_q2_q3_3 = cos_q1_minus_q3 - u1_dot_of_q1_q2_q3_2;
        // u1_dot_of_q1_q2_q3_4 = sin_q1_minus_q2*u1_dot_of_q1_q2_q3_3
        let u1_dot_of_q1_q2_q3_4 = u1_dot_of_q1_q2_q3_3
            .mul_add(
                sin_q1_minus_q2_0,
                sin_q1_minus_q2.mul_add(u1_dot_of_q1_q2_q3_3_0, sums[14]),
            );
        // u1_dot_of_q1_q2_q3_5 = sin_q1_minus_q3*u1_dot_of_q1_q2_q3_2
        let u1_dot_of_q1_q2_q3_5 = u1_dot_of_q1_q2_q3_2
            .mul_add(
                sin_q1_minus_q3_0,
                sin_q1_minus_q3.mul_add(u1_dot_of_q1_q2_q3_2_0, sums[15]),
            );
        // u1_dot_of_b_c_q1_q2_q3 = weight*u1_dot_of_q1_q2_q3_4 + weight_2*u1_dot_of_q1_q2_q3_5
        let u1_dot_of_b_c_q1_q2_q3 = u1_dot_of_q1_q2_q3_4
            .mul_add(weight, weight_2 * u1_dot_of_q1_q2_q3_5);
        // u1_dot_of_b_c_q1_q2_q3_2 = u1_dot_of_b_c_q1_q2_q3/sin_q2_minus_q3
        let u1_dot_of_b_c_q1_q2_q3_2 = u1_dot_of_b_c_q1_q2_q3
            .mul_add(
                over_sin_q2_minus_q3,
                -(sin_q2_minus_q3.mul_add(u1_dot_of_b_c_q1_q2_q3_2_0, sums[16])
                    * over_sin_q2_minus_q3),
            );
        // u1_dot_of_place = cos_q1_minus_q3 + a*u1_dot_of_b_c_q1_q2_q3_2
        let u1_dot_of_place = u1_dot_of_b_c_q1_q2_q3_2.mul_add(a, cos_q1_minus_q3);
        // u1_dot_of_q1_q2_q3_6 = sin_q1_minus_q2/sin_q2_minus_q3
        let u1_dot_of_q1_q2_q3_6 = sin_q2_minus_q3
            .mul_add(
                -(u1_dot_of_q1_q2_q3_6_0 * over_sin_q2_minus_q3),
                (sin_q1_minus_q2 - sums[17]) * over_sin_q2_minus_q3,
            );
        // u1_dot_of_q1_q2_q3_7 = cos_q2_minus_q3*u1_dot_of_q1_q2_q3_6
        let u1_dot_of_q1_q2_q3_7 = u1_dot_of_q1_q2_q3_6
            .mul_add(
                cos_q2_minus_q3_0,
                cos_q2_minus_q3.mul_add(u1_dot_of_q1_q2_q3_6_0, sums[18]),
            );
        // u1_dot_of_q1_q2_q3_8 = cos_q1_minus_q2 + u1_dot_of_q1_q2_q3_7
        let u1_dot_of_q1_q2_q3_8 = cos_q1_minus_q2 + u1_dot_of_q1_q2_q3_7;
        // u1_dot_of_q1_q2_q3_9 = sin_q1_minus_q3*u1_dot_of_q1_q2_q3_8
        let u1_dot_of_q1_q2_q3_9 = u1_dot_of_q1_q2_q3_8
            .mul_add(
                sin_q1_minus_q3_0,
                sin_q1_minus_q3.mul_add(u1_dot_of_q1_q2_q3_8_0, sums[19]),
            );
        // u1_dot_of_q1_q2_q3_10 = sin_q1_minus_q2*u1_dot_of_q1_q2_q3_7
        let u1_dot_of_q1_q2_q3_10 = u1_dot_of_q1_q2_q3_7
            .mul_add(
                sin_q1_minus_q2_0,
                sin_q1_minus_q2.mul_add(u1_dot_of_q1_q2_q3_7_0, sums[20]),
            );
        // u1_dot_of_b_c_q1_q2_q3_3 = weight_2*u1_dot_of_q1_q2_q3_9 + minus_1_by_c*u1_dot_of_q1_q2_q3_10
        let u1_dot_of_b_c_q1_q2_q3_3 = u1_dot_of_q1_q2_q3_9
            .mul_add(weight_2, minus_1_by_c * u1_dot_of_q1_q2_q3_10);
        // u1_dot_of_b_c_q1_q2_q3_4 = u1_dot_of_b_c_q1_q2_q3_3/sin_q2_minus_q3
        let u1_dot_of_b_c_q1_q2_q3_4 = u1_dot_of_b_c_q1_q2_q3_3
            .mul_add(
                over_sin_q2_minus_q3,
                -(sin_q2_minus_q3.mul_add(u1_dot_of_b_c_q1_q2_q3_4_0, sums[21])
                    * over_sin_q2_minus_q3),
            );
        // u1_dot_of_place_2 = cos_q1_minus_q2 + a*u1_dot_of_b_c_q1_q2_q3_4
        let u1_dot_of_place_2 = u1_dot_of_b_c_q1_q2_q3_4.mul_add(a, cos_q1_minus_q2);
        // u1_dot_of_q1_q2_q3_11 = 3*cos_q1_minus_q2 - 2*u1_dot_of_q1_q2_q3
        let u1_dot_of_q1_q2_q3_11 = u1_dot_of_q1_q2_q3
            .mul_add(-S::int(2), S::int(3) * cos_q1_minus_q2);
        // q2_dot_sq = q2_dot*q2_dot
        let q2_dot_sq = q2_dot.mul_add(q2_dot_0 + q2_dot_0, sums[22]);
        // u1_dot_of_q1_q2_q3_12 = c2*u1_dot_of_q1_q2_q3
        let u1_dot_of_q1_q2_q3_12 = u1_dot_of_q1_q2_q3
            .mul_add(c2_0, c2.mul_add(u1_dot_of_q1_q2_q3_0, sums[23]));
        // q1_dot_sq = q1_dot*q1_dot
        let q1_dot_sq = q1_dot.mul_add(q1_dot_0 + q1_dot_0, sums[24]);
        // u1_dot_of_q1_dot = u1_dot_of_q1_q2_q3*q1_dot_sq
        let u1_dot_of_q1_dot = u1_dot_of_q1_q2_q3
            .mul_add(q1_dot_sq_0, q1_dot_sq.mul_add(u1_dot_of_q1_q2_q3_0, sums[25]));
        // u1_dot_of_motion = b*q2_dot_sq + a*u1_dot_of_q1_dot
        let u1_dot_of_motion = u1_dot_of_q1_dot.mul_add(a, b * q2_dot_sq);
        // u1_dot_of_motion_2 = sin_q1_minus_q2*u1_dot_of_motion
        let u1_dot_of_motion_2 = u1_dot_of_motion
            .mul_add(
                sin_q1_minus_q2_0,
                sin_q1_minus_q2.mul_add(u1_dot_of_motion_0, sums[26]),
            );
        // u1_dot_of_q1_q2_q3_13 = c3*u1_dot_of_q1_q2_q3_6
        let u1_dot_of_q1_q2_q3_13 = u1_dot_of_q1_q2_q3_6
            .mul_add(c3_0, c3.mul_add(u1_dot_of_q1_q2_q3_6_0, sums[27]));
        // u1_dot_of_q1_dot_2 = q1_dot_sq/sin_q2_minus_q3
        let u1_dot_of_q1_dot_2 = sin_q2_minus_q3
            .mul_add(
                -(u1_dot_of_q1_dot_2_0 * over_sin_q2_minus_q3),
                (q1_dot_sq - sums[28]) * over_sin_q2_minus_q3,
            );
        // u1_dot_of_q1_dot_3 = u1_dot_of_place*u1_dot_of_q1_dot_2
        let u1_dot_of_q1_dot_3 = u1_dot_of_place
            .mul_add(
                u1_dot_of_q1_dot_2_0,
                u1_dot_of_q1_dot_2.mul_add(u1_dot_of_place_0, sums[29]),
            );
        // u1_dot_of_q1_dot_4 = u1_dot_of_q1_q2_q3_11*u1_dot_of_q1_dot_3
        let u1_dot_of_q1_dot_4 = u1_dot_of_q1_dot_3
            .mul_add(
                u1_dot_of_q1_q2_q3_11_0,
                u1_dot_of_q1_q2_q3_11.mul_add(u1_dot_of_q1_dot_3_0, sums[30]),
            );
        // u1_dot_of_q1_dot_5 = u1_dot_of_place_2*u1_dot_of_q1_dot_2
        let u1_dot_of_q1_dot_5 = u1_dot_of_place_2
            .mul_add(
                u1_dot_of_q1_dot_2_0,
                u1_dot_of_q1_dot_2.mul_add(u1_dot_of_place_2_0, sums[31]),
            );
        // u1_dot_of_q1_dot_6 = u1_dot_of_q1_q2_q3_6*u1_dot_of_q1_dot_5
        let u1_dot_of_q1_dot_6 = u1_dot_of_q1_dot_5
            .mul_add(
                u1_dot_of_q1_q2_q3_6_0,
                u1_dot_of_q1_q2_q3_6.mul_add(u1_dot_of_q1_dot_5_0, sums[32]),
            );
        // u1_dot_of_q1_q2_q3_14 = 3*cos_q1_minus_q2 - u1_dot_of_q1_q2_q3
        let u1_dot_of_q1_q2_q3_14 = S::int(3) * cos_q1_minus_q2 - u1_dot_of_q1_q2_q3;
        // u1_dot_of_q1_q2_q3_15 = u1_dot_of_q1_q2_q3_14*u1_dot_of_q1_q2_q3
        let u1_dot_of_q1_q2_q3_15 = u1_dot_of_q1_q2_q3_14
            .mul_add(
                u1_dot_of_q1_q2_q3_0,
                u1_dot_of_q1_q2_q3.mul_add(u1_dot_of_q1_q2_q3_14_0, sums[33]),
            );
        // u1_dot_of_q1_q2_q3_16 = u1_dot_of_q1_q2_q3_6*u1_dot_of_q1_q2_q3_6
        let u1_dot_of_q1_q2_q3_16 = u1_dot_of_q1_q2_q3_6
            .mul_add(u1_dot_of_q1_q2_q3_6_0 + u1_dot_of_q1_q2_q3_6_0, sums[34]);
        // u1_dot_of_place_3 = ma_plus_3_mb + minus_mb*u1_dot_of_q1_q2_q3_15 + mc*u1_dot_of_q1_q2_q3_16
        let u1_dot_of_place_3 = u1_dot_of_q1_q2_q3_15
            .mul_add(minus_mb, mc * u1_dot_of_q1_q2_q3_16);
        // u1_dot_of_motion_3 = weight_3*c1 + minus_3_a_mb_g*u1_dot_of_q1_q2_q3_12 +
        //   weight_4*u1_dot_of_motion_2 + minus_3_a_mc_g*u1_dot_of_q1_q2_q3_13 +
        //   minus_a_2_mb*u1_dot_of_q1_dot_4 + weight_5*u1_dot_of_q1_dot_6
        let u1_dot_of_motion_3 = u1_dot_of_q1_dot_6
            .mul_add(
                weight_5,
                u1_dot_of_q1_dot_4
                    .mul_add(
                        minus_a_2_mb,
                        u1_dot_of_motion_2
                            .mul_add(
                                weight_4,
                                u1_dot_of_q1_q2_q3_13
                                    .mul_add(
                                        minus_3_a_mc_g,
                                        u1_dot_of_q1_q2_q3_12.mul_add(minus_3_a_mb_g, weight_3 * c1),
                                    ),
                            ),
                    ),
            );
        // u1_dot_of_motion_4 = u1_dot_of_motion_3/u1_dot_of_place_3
        let u1_dot_of_motion_4 = u1_dot_of_motion_3
            .mul_add(
                over_u1_dot_of_place_3,
                -(u1_dot_of_place_3.mul_add(u1_dot_of_motion_4_0, sums[35])
                    * over_u1_dot_of_place_3),
            );
        // q2_ddot_of_motion = u1_dot_of_motion_4*u1_dot_of_q1_q2_q3
        let q2_ddot_of_motion = u1_dot_of_motion_4
            .mul_add(
                u1_dot_of_q1_q2_q3_0,
                u1_dot_of_q1_q2_q3.mul_add(u1_dot_of_motion_4_0, sums[36]),
            );
        // q2_dot_dot = minus_a_by_b*u1_dot_of_q1_dot_3 + weight_6*q2_ddot_of_motion
        let q2_dot_dot = q2_ddot_of_motion
            .mul_add(weight_6, minus_a_by_b * u1_dot_of_q1_dot_3);
        // q3_ddot_of_motion = u1_dot_of_motion_4*u1_dot_of_q1_q2_q3_6
        let q3_ddot_of_motion = u1_dot_of_motion_4
            .mul_add(
                u1_dot_of_q1_q2_q3_6_0,
                u1_dot_of_q1_q2_q3_6.mul_add(u1_dot_of_motion_4_0, sums[37]),
            );
        // q3_dot_dot = minus_a_by_c*u1_dot_of_q1_dot_5 + weight_7*q3_ddot_of_motion
        let q3_dot_dot = q3_ddot_of_motion
            .mul_add(weight_7, minus_a_by_c * u1_dot_of_q1_dot_5);
        q1_rate = q1_dot;
        q2_rate = q2_dot;
        q3_rate = q3_dot;
        q1_dot_rate = minus_1_by_2_a_2 * u1_dot_of_motion_4;
        q2_dot_rate = q2_dot_dot;
        q3_dot_rate = q3_dot_dot;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * q1,
                count * q1,
                count * q2,
                count * q2,
                count * q3,
                count * q3,
                count * q2_minus_q3,
                count * q2_minus_q3,
                count * q1_minus_q3,
                count * q1_minus_q3,
                count * q1_minus_q2,
                count * q1_minus_q2,
                sin_q2_minus_q3, cos_q2_minus_q3, sin_q1_minus_q2, sin_q1_minus_q3, sin_q2_minus_q3,
                sin_q2_minus_q3, cos_q2_minus_q3, sin_q1_minus_q3, sin_q1_minus_q2, sin_q2_minus_q3,
                q2_dot, c2, q1_dot, u1_dot_of_q1_q2_q3, sin_q1_minus_q2, c3, sin_q2_minus_q3,
                u1_dot_of_place, u1_dot_of_q1_q2_q3_11, u1_dot_of_place_2, u1_dot_of_q1_q2_q3_6,
                u1_dot_of_q1_q2_q3_14, u1_dot_of_q1_q2_q3_6, u1_dot_of_place_3, u1_dot_of_motion_4,
                u1_dot_of_motion_4,
            ]),
            padded([
                c1, s1, c2, s2, c3, s3, cos_q2_minus_q3, sin_q2_minus_q3, cos_q1_minus_q3,
                sin_q1_minus_q3, cos_q1_minus_q2, sin_q1_minus_q2, u1_dot_of_q1_q2_q3,
                u1_dot_of_q1_q2_q3, u1_dot_of_q1_q2_q3_3, u1_dot_of_q1_q2_q3_2,
                u1_dot_of_b_c_q1_q2_q3_2, u1_dot_of_q1_q2_q3_6, u1_dot_of_q1_q2_q3_6,
                u1_dot_of_q1_q2_q3_8, u1_dot_of_q1_q2_q3_7, u1_dot_of_b_c_q1_q2_q3_4, q2_dot,
                u1_dot_of_q1_q2_q3, q1_dot, q1_dot_sq, u1_dot_of_motion, u1_dot_of_q1_q2_q3_6,
                u1_dot_of_q1_dot_2, u1_dot_of_q1_dot_2, u1_dot_of_q1_dot_3, u1_dot_of_q1_dot_2,
                u1_dot_of_q1_dot_5, u1_dot_of_q1_q2_q3, u1_dot_of_q1_q2_q3_6, u1_dot_of_motion_4,
                u1_dot_of_q1_q2_q3, u1_dot_of_q1_q2_q3_6,
            ]),
        ];
        count_last = count;
        q1_last = q1;
        q2_last = q2;
        q3_last = q3;
        q1_dot_last = q1_dot;
        q2_dot_last = q2_dot;
        s1_last = s1;
        c1_last = c1;
        s2_last = s2;
        c2_last = c2;
        s3_last = s3;
        c3_last = c3;
        q2_minus_q3_last = q2_minus_q3;
        sin_q2_minus_q3_last = sin_q2_minus_q3;
        cos_q2_minus_q3_last = cos_q2_minus_q3;
        q1_minus_q3_last = q1_minus_q3;
        sin_q1_minus_q3_last = sin_q1_minus_q3;
        cos_q1_minus_q3_last = cos_q1_minus_q3;
        q1_minus_q2_last = q1_minus_q2;
        sin_q1_minus_q2_last = sin_q1_minus_q2;
        cos_q1_minus_q2_last = cos_q1_minus_q2;
        u1_dot_of_q1_q2_q3_last = u1_dot_of_q1_q2_q3;
        u1_dot_of_q1_q2_q3_2_last = u1_dot_of_q1_q2_q3_2;
        u1_dot_of_q1_q2_q3_3_last = u1_dot_of_q1_q2_q3_3;
        u1_dot_of_b_c_q1_q2_q3_2_last = u1_dot_of_b_c_q1_q2_q3_2;
        u1_dot_of_place_last = u1_dot_of_place;
        u1_dot_of_q1_q2_q3_6_last = u1_dot_of_q1_q2_q3_6;
        u1_dot_of_q1_q2_q3_7_last = u1_dot_of_q1_q2_q3_7;
        u1_dot_of_q1_q2_q3_8_last = u1_dot_of_q1_q2_q3_8;
        u1_dot_of_b_c_q1_q2_q3_4_last = u1_dot_of_b_c_q1_q2_q3_4;
        u1_dot_of_place_2_last = u1_dot_of_place_2;
        u1_dot_of_q1_q2_q3_11_last = u1_dot_of_q1_q2_q3_11;
        q1_dot_sq_last = q1_dot_sq;
        u1_dot_of_motion_last = u1_dot_of_motion;
        u1_dot_of_q1_dot_2_last = u1_dot_of_q1_dot_2;
        u1_dot_of_q1_dot_3_last = u1_dot_of_q1_dot_3;
        u1_dot_of_q1_dot_5_last = u1_dot_of_q1_dot_5;
        u1_dot_of_q1_q2_q3_14_last = u1_dot_of_q1_q2_q3_14;
        u1_dot_of_place_3_last = u1_dot_of_place_3;
        u1_dot_of_motion_4_last = u1_dot_of_motion_4;
    }
}

/// Lagrange's equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Lagrange;

impl<S: Scalar> System<S> for Lagrange {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 8,
            coordinates: 3,
            variables: 3,
            speeds: 1,
            reactions: 2,
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
        4
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
        80 * order + SLACK
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
        ["sin(q2 - q3)"][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn constraint_count(&self) -> usize {
        4
    }
    fn constraint_name(&self, at: usize) -> &str {
        ["loop_x", "loop_y", "loop_x'", "loop_y'"][at]
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
