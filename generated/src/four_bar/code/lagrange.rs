//! Four-bar linkage: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/four_bar/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

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

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
    direction: &[S; 6],
) -> [S; 6] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: q_dot[i],
        slope: direction[3 + i],
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
    slice.try_into().expect("a slice of the length that `System` requires")
}
