//! Thin disc rolling on a plane: Lagrange's equations in q2-90°, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/rolling_disc/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::lagrange::{constraints, coordinate_rates};

pub use super::kane_q2_90deg::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows q1, q2, q3, x, y, constraint ground_1, constraint ground_2.
///
/// 22 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _q_dot: &[S; 5],
) -> [[S; 7]; 7] {
    let Parameters { r, m, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let r_m = r * m;
    let r_r_m = r * r_m;
    let r_r_m_times_5_by_4 = S::ratio(5, 4) * r_r_m;
    let r_r_m_halved = S::ratio(1, 2) * r_r_m;
    let m13_of_place = r_r_m_halved * cos_q2_minus_90deg;
    let cos_q2_minus_90deg_r_m = r_m * cos_q2_minus_90deg;
    let m14_of_place = cos_q2_minus_90deg_r_m * c1;
    let m15_of_place = cos_q2_minus_90deg_r_m * s1;
    let sin_q2_minus_90deg_r_m = r_m * sin_q2_minus_90deg;
    let m24_of_place = sin_q2_minus_90deg_r_m * s1;
    let m25_of_place = sin_q2_minus_90deg_r_m * c1;
    let r_c1 = r * c1;
    let r_s1 = r * s1;
    // -m24_of_place
    let minus_m24_of_place = -m24_of_place;
    // Entries that are not zero.
    // M11 = r^2*m*(6 - 5*sin(q2_minus_90deg)^2)/4
    let m11 = S::ratio(3, 2) * r_r_m - r_r_m_times_5_by_4 * sin_q2_minus_90deg * sin_q2_minus_90deg;
    // M13 = r^2*m*cos(q2_minus_90deg)/2
    let m13 = m13_of_place;
    // M14 = r*m*cos(q1)*cos(q2_minus_90deg)
    let m14 = m14_of_place;
    // M15 = r*m*sin(q1)*cos(q2_minus_90deg)
    let m15 = m15_of_place;
    // M22 = 5*r^2*m/4
    let m22 = r_r_m_times_5_by_4;
    // M24 = -r*m*sin(q1)*sin(q2_minus_90deg)
    let m24 = minus_m24_of_place;
    // M25 = r*m*cos(q1)*sin(q2_minus_90deg)
    let m25 = m25_of_place;
    // M31 = r^2*m*cos(q2_minus_90deg)/2
    let m31 = m13_of_place;
    // M33 = r^2*m/2
    let m33 = r_r_m_halved;
    // M36 = r*cos(q1)
    let m36 = r_c1;
    // M37 = r*sin(q1)
    let m37 = r_s1;
    // M41 = r*m*cos(q1)*cos(q2_minus_90deg)
    let m41 = m14_of_place;
    // M42 = -r*m*sin(q1)*sin(q2_minus_90deg)
    let m42 = minus_m24_of_place;
    // M44 = m
    let m44 = m;
    // M46 = -1
    let m46 = -S::int(1);
    // M51 = r*m*sin(q1)*cos(q2_minus_90deg)
    let m51 = m15_of_place;
    // M52 = r*m*cos(q1)*sin(q2_minus_90deg)
    let m52 = m25_of_place;
    // M55 = m
    let m55 = m;
    // M57 = -1
    let m57 = -S::int(1);
    // M63 = -r*cos(q1)
    let m63 = -r_c1;
    // M64 = 1
    let m64 = S::int(1);
    // M73 = -r*sin(q1)
    let m73 = -r_s1;
    // M75 = 1
    let m75 = S::int(1);
    let zero = S::int(0);
    [
        [m11, zero, m13, m14, m15, zero, zero],
        [zero, m22, zero, m24, m25, zero, zero],
        [m31, zero, m33, zero, zero, m36, m37],
        [m41, m42, zero, m44, zero, m46, zero],
        [m51, m52, zero, zero, m55, zero, m57],
        [zero, zero, m63, m64, zero, zero, zero],
        [zero, zero, m73, zero, m75, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (q1'', q2'', q3'', x'', y'', lambda_ground_1, lambda_ground_2).
///
/// 37 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> [S; 7] {
    let Parameters { r, m, g } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, _, _] = *q_dot;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let r_m = r * m;
    let sin_q2_minus_90deg_r_m = r_m * sin_q2_minus_90deg;
    let f1_of_q2_dot = q2_dot * sin_q2_minus_90deg_r_m;
    let r_q1_dot = r * q1_dot;
    let f1_of_q1_dot = r_q1_dot * cos_q2_minus_90deg;
    let f1_of_q2_dot_halved = S::ratio(1, 2) * f1_of_q2_dot;
    let cos_q2_minus_90deg_r_m = r_m * cos_q2_minus_90deg;
    let q3_dot_r_q1_dot = q3_dot * r_q1_dot;
    // cos_q2_minus_90deg_r_m*(q1'^2 + q2'^2)
    let f4_of_motion = cos_q2_minus_90deg_r_m * q2_dot.mul_add(q2_dot, q1_dot * q1_dot);
    let f4_of_motion_2 = S::int(2) * q1_dot * f1_of_q2_dot;
    // Values.
    // f1 = r^2*m*q2'*sin(q2_minus_90deg)*(q3' + 5*q1'*cos(q2_minus_90deg))/2
    let f1 = (r * q3_dot)
        .mul_add(f1_of_q2_dot_halved, S::ratio(5, 2) * f1_of_q2_dot * f1_of_q1_dot);
    // f2 = r*m*(4*g*cos(q2_minus_90deg) - r*q1'*sin(q2_minus_90deg)*(2*q3' + 5*q1'*cos(q2_minus_90deg)))/4
    let f2 = g
        .mul_add(
            cos_q2_minus_90deg_r_m,
            -S::ratio(5, 4) * q1_dot * sin_q2_minus_90deg_r_m * f1_of_q1_dot,
        ) - S::ratio(1, 2) * sin_q2_minus_90deg_r_m * q3_dot_r_q1_dot;
    // f3 = r^2*m*q1'*q2'*sin(q2_minus_90deg)/2
    let f3 = r_q1_dot * f1_of_q2_dot_halved;
    // f4 = r*m*(q2'^2*sin(q1)*cos(q2_minus_90deg) + q1'*(2*q2'*cos(q1)*sin(q2_minus_90deg) +
    //   q1'*sin(q1)*cos(q2_minus_90deg)))
    let f4 = f4_of_motion_2.mul_add(c1, f4_of_motion * s1);
    // f5 = r*m*(q1'*(2*q2'*sin(q1)*sin(q2_minus_90deg) - q1'*cos(q1)*cos(q2_minus_90deg)) -
    //   q2'^2*cos(q1)*cos(q2_minus_90deg))
    let f5 = (-f4_of_motion).mul_add(c1, f4_of_motion_2 * s1);
    // f6 = -r*q1'*q3'*sin(q1)
    let f6 = -q3_dot_r_q1_dot * s1;
    // f7 = r*q1'*q3'*cos(q1)
    let f7 = q3_dot_r_q1_dot * c1;
    [f1, f2, f3, f4, f5, f6, f7]
}

/// The accelerations (q1'', q2'', q3'', x'', y''), solved for when this code was generated.
///
/// 35 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 5] {
    let Parameters { r, g, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, _, _] = *q_dot;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let q1_dot_q2_dot = q1_dot * q2_dot;
    let u3_dot_of_motion = q1_dot_q2_dot * cos_q2_minus_90deg;
    // u3' = -q2'*(2*q3' + q1'*cos(q2_minus_90deg))
    let u3_dot = (-(q2_dot * q3_dot)).mul_add(S::int(2), -u3_dot_of_motion);
    // u2' = 2*q1'*q2'*sin(q2_minus_90deg)/3
    let u2_dot = S::ratio(2, 3) * q1_dot_q2_dot * sin_q2_minus_90deg;
    let q1_dot_q3_dot = q1_dot * q3_dot;
    // u1' = 4*g*cos(q2_minus_90deg)/(5*r) - q1'*sin(q2_minus_90deg)*(6*q3' + 5*q1'*cos(q2_minus_90deg))/5
    let u1_dot = S::ratio(4, 5) * g * cos_q2_minus_90deg / r
        - q1_dot * q1_dot * sin_q2_minus_90deg * cos_q2_minus_90deg
        - S::ratio(6, 5) * q1_dot_q3_dot * sin_q2_minus_90deg;
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    // q1'' = -u3'/sin(q2_minus_90deg) - q1'*q2'/tan(q2_minus_90deg)
    let q1_ddot = -sin_q2_minus_90deg_inv * (u3_dot + u3_dot_of_motion);
    // q2'' = u1'
    let q2_ddot = u1_dot;
    // q3'' = u2' + q1'*q2'/sin(q2_minus_90deg) + u3'/tan(q2_minus_90deg)
    let q3_ddot = u2_dot
        + sin_q2_minus_90deg_inv * u3_dot.mul_add(cos_q2_minus_90deg, q1_dot_q2_dot);
    let r_s1 = r * s1;
    let r_c1 = r * c1;
    // x'' = r*q1'*(q2'*cos(q1)/sin(q2_minus_90deg) - q3'*sin(q1)) + r*cos(q1)*(u2' +
    //   u3'/tan(q2_minus_90deg))
    let x_ddot = (-q1_dot_q3_dot).mul_add(r_s1, q3_ddot * r_c1);
    // y'' = r*q1'*(q3'*cos(q1) + q2'*sin(q1)/sin(q2_minus_90deg)) + r*sin(q1)*(u2' +
    //   u3'/tan(q2_minus_90deg))
    let y_ddot = q1_dot_q3_dot.mul_add(r_c1, q3_ddot * r_s1);
    [q1_ddot, q2_ddot, q3_ddot, x_ddot, y_ddot]
}

/// Kinetic energy T.
///
/// 34 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> S {
    let Parameters { r, m, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, x_dot, y_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let r_m = r * m;
    let energy_of_q1_dot = q1_dot * cos_q2_minus_90deg;
    // q2'^2 + energy_of_q1_dot^2
    let energy_of_motion = energy_of_q1_dot.mul_add(energy_of_q1_dot, q2_dot * q2_dot);
    // q1'^2 + 2*q3'*(q3' + 2*energy_of_q1_dot)
    let energy_of_motion_2 = S::int(2) * q3_dot
        * energy_of_q1_dot.mul_add(S::int(2), q3_dot) + q1_dot * q1_dot;
    // Values.
    // T = m*(4*x'^2 - r*(8*q2'*sin(q2_minus_90deg)*(x'*sin(q1) - y'*cos(q1)) -
    //   8*q1'*cos(q2_minus_90deg)*(x'*cos(q1) + y'*sin(q1)) + r*(q1'*(q1'*(5*sin(q2_minus_90deg)^2 - 6) -
    //   4*q3'*cos(q2_minus_90deg)) - 5*q2'^2 - 2*q3'^2)) + 4*y'^2)/8
    let energy = S::ratio(1, 2) * m * y_dot.mul_add(y_dot, x_dot * x_dot)
        + r_m
            * (energy_of_q1_dot * y_dot.mul_add(s1, x_dot * c1)
                - q2_dot * sin_q2_minus_90deg * (-y_dot).mul_add(c1, x_dot * s1))
        + S::ratio(1, 8) * r * r_m * energy_of_motion.mul_add(S::int(5), energy_of_motion_2);
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 3] {
    let [_, q2_minus_90deg, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, _, _] = *q_dot;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Values.
    // u1 = q2'
    let u1_value = q2_dot;
    // u2 = q3' + q1'*cos(q2_minus_90deg)
    let u2_value = q1_dot.mul_add(cos_q2_minus_90deg, q3_dot);
    // u3 = -q1'*sin(q2_minus_90deg)
    let u3_value = -q1_dot * sin_q2_minus_90deg;
    [u1_value, u2_value, u3_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 9 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
    v_dot: &[S; 5],
) -> [S; 3] {
    let [_, q2_minus_90deg, _, _, _] = *q;
    let [q1_dot, q2_dot, _, _, _] = *q_dot;
    let [q1_ddot, q2_ddot, q3_ddot, _, _] = *v_dot;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Shared terms.
    let q1_dot_q2_dot = q1_dot * q2_dot;
    // Values.
    // u1' = q2''
    let u1_dot_value = q2_ddot;
    // u2' = q3'' - q1'*q2'*sin(q2_minus_90deg) + q1''*cos(q2_minus_90deg)
    let u2_dot_value = q1_ddot.mul_add(cos_q2_minus_90deg, q3_ddot)
        - q1_dot_q2_dot * sin_q2_minus_90deg;
    // u3' = -q1''*sin(q2_minus_90deg) - q1'*q2'*cos(q2_minus_90deg)
    let u3_dot_value = (-q1_dot_q2_dot)
        .mul_add(cos_q2_minus_90deg, -q1_ddot * sin_q2_minus_90deg);
    [u1_dot_value, u2_dot_value, u3_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 7 operations, 2 sines and cosines.
#[must_use]
pub fn motion_variables<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 3]) -> [S; 5] {
    let Parameters { r, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let q1_dot_value_of_place = u3 / sin_q2_minus_90deg;
    // u2 + q1_dot_value_of_place*cos(q2_minus_90deg)
    let q3_dot_value_of_place = q1_dot_value_of_place.mul_add(cos_q2_minus_90deg, u2);
    let r_q3_dot_value_of_place = r * q3_dot_value_of_place;
    // Values.
    // q1' = -u3/sin(q2_minus_90deg)
    let q1_dot_value = -q1_dot_value_of_place;
    // q2' = u1
    let q2_dot_value = u1;
    // q3' = u2 + u3/tan(q2_minus_90deg)
    let q3_dot_value = q3_dot_value_of_place;
    // x' = r*cos(q1)*(u2 + u3/tan(q2_minus_90deg))
    let x_dot_value = r_q3_dot_value_of_place * c1;
    // y' = r*sin(q1)*(u2 + u3/tan(q2_minus_90deg))
    let y_dot_value = r_q3_dot_value_of_place * s1;
    [q1_dot_value, q2_dot_value, q3_dot_value, x_dot_value, y_dot_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 35 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> ([S; 5], [S; 5]) {
    let Parameters { r, g, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, x_dot, y_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let q1_dot_q2_dot = q1_dot * q2_dot;
    let u3_dot_of_motion = q1_dot_q2_dot * cos_q2_minus_90deg;
    // u3' = -q2'*(2*q3' + q1'*cos(q2_minus_90deg))
    let u3_dot = (-(q2_dot * q3_dot)).mul_add(S::int(2), -u3_dot_of_motion);
    // u2' = 2*q1'*q2'*sin(q2_minus_90deg)/3
    let u2_dot = S::ratio(2, 3) * q1_dot_q2_dot * sin_q2_minus_90deg;
    let q1_dot_q3_dot = q1_dot * q3_dot;
    // u1' = 4*g*cos(q2_minus_90deg)/(5*r) - q1'*sin(q2_minus_90deg)*(6*q3' + 5*q1'*cos(q2_minus_90deg))/5
    let u1_dot = S::ratio(4, 5) * g * cos_q2_minus_90deg / r
        - q1_dot * q1_dot * sin_q2_minus_90deg * cos_q2_minus_90deg
        - S::ratio(6, 5) * q1_dot_q3_dot * sin_q2_minus_90deg;
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    // q1'' = -u3'/sin(q2_minus_90deg) - q1'*q2'/tan(q2_minus_90deg)
    let q1_ddot = -sin_q2_minus_90deg_inv * (u3_dot + u3_dot_of_motion);
    // q2'' = u1'
    let q2_ddot = u1_dot;
    // q3'' = u2' + q1'*q2'/sin(q2_minus_90deg) + u3'/tan(q2_minus_90deg)
    let q3_ddot = u2_dot
        + sin_q2_minus_90deg_inv * u3_dot.mul_add(cos_q2_minus_90deg, q1_dot_q2_dot);
    let r_s1 = r * s1;
    let r_c1 = r * c1;
    // x'' = r*q1'*(q2'*cos(q1)/sin(q2_minus_90deg) - q3'*sin(q1)) + r*cos(q1)*(u2' +
    //   u3'/tan(q2_minus_90deg))
    let x_ddot = (-q1_dot_q3_dot).mul_add(r_s1, q3_ddot * r_c1);
    // y'' = r*q1'*(q3'*cos(q1) + q2'*sin(q1)/sin(q2_minus_90deg)) + r*sin(q1)*(u2' +
    //   u3'/tan(q2_minus_90deg))
    let y_ddot = q1_dot_q3_dot.mul_add(r_c1, q3_ddot * r_s1);
    // Values.
    // q1'
    let q1_dot_value = q1_dot;
    // q2'
    let q2_dot_value = q2_dot;
    // q3'
    let q3_dot_value = q3_dot;
    // x'
    let x_dot_value = x_dot;
    // y'
    let y_dot_value = y_dot;
    (
        [q1_dot_value, q2_dot_value, q3_dot_value, x_dot_value, y_dot_value],
        [q1_ddot, q2_ddot, q3_ddot, x_ddot, y_ddot],
    )
}

/// Jacobian of the derivative by the state; columns q1, q2_minus_90deg, q3, x, y, q1', q2', q3', x', y'.
///
/// 83 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [[S; 10]; 10] {
    let Parameters { r, g, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, _, _] = *q_dot;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let q2_dot_doubled = S::int(2) * q2_dot;
    let u3_dot_of_q1_dot = q1_dot * cos_q2_minus_90deg;
    let q2_dot_u3_dot_of_q1_dot = q2_dot * u3_dot_of_q1_dot;
    // u3' = -q2'*(2*q3' + q1'*cos(q2_minus_90deg))
    let u3_dot = (-q3_dot).mul_add(q2_dot_doubled, -q2_dot_u3_dot_of_q1_dot);
    let u2_dot_of_q1_dot = q1_dot * sin_q2_minus_90deg;
    // u2' = 2*q1'*q2'*sin(q2_minus_90deg)/3
    let u2_dot = S::ratio(2, 3) * q2_dot * u2_dot_of_q1_dot;
    let r_s1 = r * s1;
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    // u2' + sin_q2_minus_90deg_inv*(q1'*q2' + u3'*cos(q2_minus_90deg))
    let x_ddot_by_q1_of_motion = u2_dot
        + sin_q2_minus_90deg_inv * u3_dot.mul_add(cos_q2_minus_90deg, q1_dot * q2_dot);
    let r_c1 = r * c1;
    let q1_dot_q3_dot = q1_dot * q3_dot;
    // x_ddot_by_q1 = -r*(q1'*q3'*cos(q1) + sin(q1)*(u2' + (q1'*q2' +
    //   u3'*cos(q2_minus_90deg))/sin(q2_minus_90deg)))
    let x_ddot_by_q1 = (-r_c1).mul_add(q1_dot_q3_dot, -r_s1 * x_ddot_by_q1_of_motion);
    // y_ddot_by_q1 = r*(cos(q1)*(u2' + (q1'*q2' + u3'*cos(q2_minus_90deg))/sin(q2_minus_90deg)) -
    //   q1'*q3'*sin(q1))
    let y_ddot_by_q1 = (-r_s1).mul_add(q1_dot_q3_dot, x_ddot_by_q1_of_motion * r_c1);
    // u2_dot_by_q2_minus_90deg = 2*q1'*q2'*cos(q2_minus_90deg)/3
    let u2_dot_by_q2_minus_90deg = S::ratio(2, 3) * q2_dot_u3_dot_of_q1_dot;
    let q3_dot_times_6_by_5 = S::ratio(6, 5) * q3_dot;
    // u1_dot_by_q2_minus_90deg = -4*g*sin(q2_minus_90deg)/(5*r) - q1'*(6*q3'*cos(q2_minus_90deg) +
    //   5*q1'*(cos(q2_minus_90deg)^2 - sin(q2_minus_90deg)^2))/5
    let u1_dot_by_q2_minus_90deg = -S::ratio(4, 5) * g * sin_q2_minus_90deg / r
        + u2_dot_of_q1_dot * u2_dot_of_q1_dot
        - u3_dot_of_q1_dot * (u3_dot_of_q1_dot + q3_dot_times_6_by_5);
    let q1_ddot_by_q2_minus_90deg_of_place = sin_q2_minus_90deg_inv * cos_q2_minus_90deg;
    // sin_q2_minus_90deg_inv*(u3' + q2_dot_u3_dot_of_q1_dot)
    let q1_ddot_by_q2_minus_90deg_of_motion = sin_q2_minus_90deg_inv
        * (u3_dot + q2_dot_u3_dot_of_q1_dot);
    // q1_ddot_by_q2_minus_90deg = (u3' +
    //   q1'*q2'*cos(q2_minus_90deg))/(sin(q2_minus_90deg)*tan(q2_minus_90deg))
    let q1_ddot_by_q2_minus_90deg = q1_ddot_by_q2_minus_90deg_of_place
        * q1_ddot_by_q2_minus_90deg_of_motion;
    // q2_dot_u3_dot_of_q1_dot - sin_q2_minus_90deg_inv*q1_ddot_by_q2_minus_90deg_of_motion
    let q3_ddot_by_q2_minus_90deg_of_motion = (-sin_q2_minus_90deg_inv)
        .mul_add(q1_ddot_by_q2_minus_90deg_of_motion, q2_dot_u3_dot_of_q1_dot);
    // q3_ddot_by_q2_minus_90deg = q1'*q2'*cos(q2_minus_90deg)*(1 - 1/sin(q2_minus_90deg)^2) -
    //   u3'/sin(q2_minus_90deg)^2 + u2_dot_by_q2_minus_90deg
    let q3_ddot_by_q2_minus_90deg = u2_dot_by_q2_minus_90deg + q3_ddot_by_q2_minus_90deg_of_motion;
    // x_ddot_by_q2_minus_90deg = r*cos(q1)*(q1'*q2'*cos(q2_minus_90deg)*(1 - 1/sin(q2_minus_90deg)^2) -
    //   u3'/sin(q2_minus_90deg)^2 + u2_dot_by_q2_minus_90deg)
    let x_ddot_by_q2_minus_90deg = q3_ddot_by_q2_minus_90deg * r_c1;
    // y_ddot_by_q2_minus_90deg = r*sin(q1)*(q1'*q2'*cos(q2_minus_90deg)*(1 - 1/sin(q2_minus_90deg)^2) -
    //   u3'/sin(q2_minus_90deg)^2 + u2_dot_by_q2_minus_90deg)
    let y_ddot_by_q2_minus_90deg = q3_ddot_by_q2_minus_90deg * r_s1;
    // u1_dot_by_q1_dot = -2*sin(q2_minus_90deg)*(3*q3' + 5*q1'*cos(q2_minus_90deg))/5
    let u1_dot_by_q1_dot = -sin_q2_minus_90deg
        * u3_dot_of_q1_dot.mul_add(S::int(2), q3_dot_times_6_by_5);
    let x_ddot_by_q1_dot_of_q2_dot = S::ratio(5, 3) * q2_dot * sin_q2_minus_90deg;
    // x_ddot_by_q1_dot = r*(5*q2'*cos(q1)*sin(q2_minus_90deg) - 3*q3'*sin(q1))/3
    let x_ddot_by_q1_dot = (-q3_dot).mul_add(r_s1, r_c1 * x_ddot_by_q1_dot_of_q2_dot);
    // y_ddot_by_q1_dot = r*(3*q3'*cos(q1) + 5*q2'*sin(q1)*sin(q2_minus_90deg))/3
    let y_ddot_by_q1_dot = r_s1.mul_add(x_ddot_by_q1_dot_of_q2_dot, q3_dot * r_c1);
    // u3_dot_by_q2_dot = -2*q3' - q1'*cos(q2_minus_90deg)
    let u3_dot_by_q2_dot = (-q3_dot).mul_add(S::int(2), -u3_dot_of_q1_dot);
    // q1_ddot_by_q2_dot = -(q1'*cos(q2_minus_90deg) + u3_dot_by_q2_dot)/sin(q2_minus_90deg)
    let q1_ddot_by_q2_dot = -sin_q2_minus_90deg_inv * (u3_dot_by_q2_dot + u3_dot_of_q1_dot);
    // 2*u2_dot_of_q1_dot + 3*sin_q2_minus_90deg_inv*(q1' + u3_dot_by_q2_dot*cos(q2_minus_90deg))
    let q3_ddot_by_q2_dot_of_q1_dot = S::int(3) * sin_q2_minus_90deg_inv
        * u3_dot_by_q2_dot.mul_add(cos_q2_minus_90deg, q1_dot) + S::int(2) * u2_dot_of_q1_dot;
    // q3_ddot_by_q2_dot = 2*q1'*sin(q2_minus_90deg)/3 + q1'/sin(q2_minus_90deg) +
    //   u3_dot_by_q2_dot/tan(q2_minus_90deg)
    let q3_ddot_by_q2_dot = S::ratio(1, 3) * q3_ddot_by_q2_dot_of_q1_dot;
    // x_ddot_by_q2_dot = r*cos(q1)*(q1'*(2*sin(q2_minus_90deg) + 3/sin(q2_minus_90deg)) +
    //   3*u3_dot_by_q2_dot/tan(q2_minus_90deg))/3
    let x_ddot_by_q2_dot = q3_ddot_by_q2_dot * r_c1;
    // y_ddot_by_q2_dot = r*sin(q1)*(q1'*(2*sin(q2_minus_90deg) + 3/sin(q2_minus_90deg)) +
    //   3*u3_dot_by_q2_dot/tan(q2_minus_90deg))/3
    let y_ddot_by_q2_dot = q3_ddot_by_q2_dot * r_s1;
    // q1_ddot_by_q3_dot = 2*q2'/sin(q2_minus_90deg)
    let q1_ddot_by_q3_dot = q2_dot_doubled * sin_q2_minus_90deg_inv;
    let q3_ddot_by_q3_dot_of_q2_dot = q2_dot_doubled * q1_ddot_by_q2_minus_90deg_of_place;
    // q3_ddot_by_q3_dot = -2*q2'/tan(q2_minus_90deg)
    let q3_ddot_by_q3_dot = -q3_ddot_by_q3_dot_of_q2_dot;
    // x_ddot_by_q3_dot = -r*(q1'*sin(q1) + 2*q2'*cos(q1)/tan(q2_minus_90deg))
    let x_ddot_by_q3_dot = (-r_c1).mul_add(q3_ddot_by_q3_dot_of_q2_dot, -q1_dot * r_s1);
    // y_ddot_by_q3_dot = r*(q1'*cos(q1) - 2*q2'*sin(q1)/tan(q2_minus_90deg))
    let y_ddot_by_q3_dot = (-r_s1).mul_add(q3_ddot_by_q3_dot_of_q2_dot, q1_dot * r_c1);
    // Entries that are not zero.
    // d(q1')/d(q1') = 1
    let q1_dot_by_q1_dot_value = S::int(1);
    // d(q2')/d(q2') = 1
    let q2_dot_by_q2_dot_value = S::int(1);
    // d(q3')/d(q3') = 1
    let q3_dot_by_q3_dot_value = S::int(1);
    // d(x')/d(x') = 1
    let x_dot_by_x_dot_value = S::int(1);
    // d(y')/d(y') = 1
    let y_dot_by_y_dot_value = S::int(1);
    // d(q2'')/d(q3') = -6*q1'*sin(q2_minus_90deg)/5
    let q2_ddot_by_q3_dot_value = -S::ratio(6, 5) * u2_dot_of_q1_dot;
    // d(q3'')/d(q1') = 5*q2'*sin(q2_minus_90deg)/3
    let q3_ddot_by_q1_dot_value = x_ddot_by_q1_dot_of_q2_dot;
    let zero = S::int(0);
    [
        [zero, zero, zero, zero, zero, q1_dot_by_q1_dot_value, zero, zero, zero, zero],
        [zero, zero, zero, zero, zero, zero, q2_dot_by_q2_dot_value, zero, zero, zero],
        [zero, zero, zero, zero, zero, zero, zero, q3_dot_by_q3_dot_value, zero, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, x_dot_by_x_dot_value, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, y_dot_by_y_dot_value],
        [
            zero, q1_ddot_by_q2_minus_90deg, zero, zero, zero, zero, q1_ddot_by_q2_dot,
            q1_ddot_by_q3_dot, zero, zero,
        ],
        [
            zero, u1_dot_by_q2_minus_90deg, zero, zero, zero, u1_dot_by_q1_dot, zero,
            q2_ddot_by_q3_dot_value, zero, zero,
        ],
        [
            zero, q3_ddot_by_q2_minus_90deg, zero, zero, zero, q3_ddot_by_q1_dot_value,
            q3_ddot_by_q2_dot, q3_ddot_by_q3_dot, zero, zero,
        ],
        [
            x_ddot_by_q1, x_ddot_by_q2_minus_90deg, zero, zero, zero, x_ddot_by_q1_dot,
            x_ddot_by_q2_dot, x_ddot_by_q3_dot, zero, zero,
        ],
        [
            y_ddot_by_q1, y_ddot_by_q2_minus_90deg, zero, zero, zero, y_ddot_by_q1_dot,
            y_ddot_by_q2_dot, y_ddot_by_q3_dot, zero, zero,
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

/// Slopes of the constraints, one after the other, along q1, q2_minus_90deg, q3, x, y, q1', q2', q3', x', y'.
///
/// 8 operations, 1 sine and cosine.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 20] {
    let Parameters { r, .. } = *p;
    let [q1, _, _, _, _] = *q;
    let [_, _, q3_dot, _, _] = *q_dot;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let r_q3_dot = r * q3_dot;
    // Values.
    // d(ground_1)/d(q1) = r*q3'*sin(q1)
    let residual1_by_q1 = r_q3_dot * s1;
    // d(ground_1)/d(q3') = -r*cos(q1)
    let residual1_by_q3_dot = -r * c1;
    // d(ground_1)/d(x') = 1
    let residual1_by_x_dot = S::int(1);
    // d(ground_2)/d(q1) = -r*q3'*cos(q1)
    let residual2_by_q1 = -r_q3_dot * c1;
    // d(ground_2)/d(q3') = -r*sin(q1)
    let residual2_by_q3_dot = -r * s1;
    // d(ground_2)/d(y') = 1
    let residual2_by_y_dot = S::int(1);
    let zero = S::int(0);
    [
        residual1_by_q1, zero, zero, zero, zero, zero, zero, residual1_by_q3_dot,
        residual1_by_x_dot, zero, residual2_by_q1, zero, zero, zero, zero, zero, zero,
        residual2_by_q3_dot, zero, residual2_by_y_dot,
    ]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 19 convolutions and 32 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 10]],
    history: &mut [Factors<S, 24>],
) {
    let Parameters { r, g, .. } = *p;
    let [q1_0, q2_minus_90deg_0, _, _, _, q1_dot_0, q2_dot_0, q3_dot_0, x_dot_0, y_dot_0,
    ] = series[0];
    // Constant in time.
    // weight = 4*g/(5*r)
    let weight = S::ratio(4, 5) * g / r;
    // Order 0.
    let (sin_q2_minus_90deg_0, cos_q2_minus_90deg_0) = q2_minus_90deg_0.sin_cos();
    let over_sin_q2_minus_90deg = S::int(1) / sin_q2_minus_90deg_0;
    let u3_dot_of_q1_dot_0 = q1_dot_0 * cos_q2_minus_90deg_0;
    let u3_dot_of_motion_0 = S::int(2) * q3_dot_0 + u3_dot_of_q1_dot_0;
    let u3_dot_of_motion_2_0 = q2_dot_0 * u3_dot_of_motion_0;
    let q1_dot_q2_dot_0 = q1_dot_0 * q2_dot_0;
    let u2_dot_of_motion_0 = sin_q2_minus_90deg_0 * q1_dot_q2_dot_0;
    let u1_dot_of_motion_0 = u3_dot_of_q1_dot_0.mul_add(S::int(5), S::int(6) * q3_dot_0);
    let u1_dot_of_q1_dot_0 = q1_dot_0 * sin_q2_minus_90deg_0;
    let u1_dot_of_motion_2_0 = u1_dot_of_motion_0 * u1_dot_of_q1_dot_0;
    let q2_dot_dot_0 = u1_dot_of_motion_2_0
        .mul_add(-S::ratio(1, 5), weight * cos_q2_minus_90deg_0);
    let q1_ddot_of_motion_0 = cos_q2_minus_90deg_0 * q1_dot_q2_dot_0;
    let q1_ddot_of_motion_2_0 = q1_ddot_of_motion_0 - u3_dot_of_motion_2_0;
    let q1_ddot_of_motion_3_0 = q1_ddot_of_motion_2_0 * over_sin_q2_minus_90deg;
    let q3_ddot_of_motion_0 = u3_dot_of_motion_2_0 * cos_q2_minus_90deg_0;
    let q3_ddot_of_motion_2_0 = q1_dot_q2_dot_0 - q3_ddot_of_motion_0;
    let q3_ddot_of_motion_3_0 = q3_ddot_of_motion_2_0 * over_sin_q2_minus_90deg;
    let q3_dot_dot_0 = S::ratio(2, 3) * u2_dot_of_motion_0 + q3_ddot_of_motion_3_0;
    let (s1_0, c1_0) = q1_0.sin_cos();
    let x_ddot_of_motion_0 = c1_0 * q3_dot_dot_0;
    let q1_dot_q3_dot_0 = q1_dot_0 * q3_dot_0;
    let q1_dot_q3_dot_s1_0 = s1_0 * q1_dot_q3_dot_0;
    let x_ddot_of_motion_2_0 = -q1_dot_q3_dot_s1_0 + x_ddot_of_motion_0;
    let y_ddot_of_motion_0 = s1_0 * q3_dot_dot_0;
    let q1_dot_q3_dot_c1_0 = c1_0 * q1_dot_q3_dot_0;
    let y_ddot_of_motion_2_0 = q1_dot_q3_dot_c1_0 + y_ddot_of_motion_0;
    // Order 1: the rates, and what follows from them.
    let q1_1 = q1_dot_0;
    let q2_minus_90deg_1 = q2_dot_0;
    let q3_1 = q3_dot_0;
    let x_1 = x_dot_0;
    let y_1 = y_dot_0;
    let q1_dot_1 = -q1_ddot_of_motion_3_0;
    let q2_dot_1 = q2_dot_dot_0;
    let q3_dot_1 = q3_dot_dot_0;
    let x_dot_1 = r * x_ddot_of_motion_2_0;
    let y_dot_1 = r * y_ddot_of_motion_2_0;
    if series.len() > 1 {
        series[1] = [
            q1_1, q2_minus_90deg_1, q3_1, x_1, y_1, q1_dot_1, q2_dot_1, q3_dot_1, x_dot_1, y_dot_1,
        ];
    }
    let sin_q2_minus_90deg_1 = q2_minus_90deg_1 * cos_q2_minus_90deg_0;
    let cos_q2_minus_90deg_1 = -q2_minus_90deg_1 * sin_q2_minus_90deg_0;
    let u3_dot_of_q1_dot_1 = cos_q2_minus_90deg_1
        .mul_add(q1_dot_0, q1_dot_1 * cos_q2_minus_90deg_0);
    let u3_dot_of_motion_1 = S::int(2) * q3_dot_1 + u3_dot_of_q1_dot_1;
    let u3_dot_of_motion_2_1 = u3_dot_of_motion_1
        .mul_add(q2_dot_0, q2_dot_1 * u3_dot_of_motion_0);
    let q1_dot_q2_dot_1 = q2_dot_1.mul_add(q1_dot_0, q1_dot_1 * q2_dot_0);
    let u2_dot_of_motion_1 = q1_dot_q2_dot_1
        .mul_add(sin_q2_minus_90deg_0, sin_q2_minus_90deg_1 * q1_dot_q2_dot_0);
    let u1_dot_of_motion_1 = u3_dot_of_q1_dot_1.mul_add(S::int(5), S::int(6) * q3_dot_1);
    let u1_dot_of_q1_dot_1 = sin_q2_minus_90deg_1
        .mul_add(q1_dot_0, q1_dot_1 * sin_q2_minus_90deg_0);
    let u1_dot_of_motion_2_1 = u1_dot_of_motion_1
        .mul_add(u1_dot_of_q1_dot_0, u1_dot_of_q1_dot_1 * u1_dot_of_motion_0);
    let q2_dot_dot_1 = u1_dot_of_motion_2_1
        .mul_add(-S::ratio(1, 5), weight * cos_q2_minus_90deg_1);
    let q1_ddot_of_motion_1 = q1_dot_q2_dot_1
        .mul_add(cos_q2_minus_90deg_0, cos_q2_minus_90deg_1 * q1_dot_q2_dot_0);
    let q1_ddot_of_motion_2_1 = q1_ddot_of_motion_1 - u3_dot_of_motion_2_1;
    let q1_ddot_of_motion_3_1 = sin_q2_minus_90deg_1
        .mul_add(
            -(q1_ddot_of_motion_3_0 * over_sin_q2_minus_90deg),
            q1_ddot_of_motion_2_1 * over_sin_q2_minus_90deg,
        );
    let q3_ddot_of_motion_1 = u3_dot_of_motion_2_1
        .mul_add(cos_q2_minus_90deg_0, cos_q2_minus_90deg_1 * u3_dot_of_motion_2_0);
    let q3_ddot_of_motion_2_1 = q1_dot_q2_dot_1 - q3_ddot_of_motion_1;
    let q3_ddot_of_motion_3_1 = sin_q2_minus_90deg_1
        .mul_add(
            -(q3_ddot_of_motion_3_0 * over_sin_q2_minus_90deg),
            q3_ddot_of_motion_2_1 * over_sin_q2_minus_90deg,
        );
    let q3_dot_dot_1 = S::ratio(2, 3) * u2_dot_of_motion_1 + q3_ddot_of_motion_3_1;
    let s1_1 = q1_1 * c1_0;
    let c1_1 = -q1_1 * s1_0;
    let x_ddot_of_motion_1 = q3_dot_dot_1.mul_add(c1_0, c1_1 * q3_dot_dot_0);
    let q1_dot_q3_dot_1 = q3_dot_1.mul_add(q1_dot_0, q1_dot_1 * q3_dot_0);
    let q1_dot_q3_dot_s1_1 = q1_dot_q3_dot_1.mul_add(s1_0, s1_1 * q1_dot_q3_dot_0);
    let x_ddot_of_motion_2_1 = -q1_dot_q3_dot_s1_1 + x_ddot_of_motion_1;
    let y_ddot_of_motion_1 = q3_dot_dot_1.mul_add(s1_0, s1_1 * q3_dot_dot_0);
    let q1_dot_q3_dot_c1_1 = q1_dot_q3_dot_1.mul_add(c1_0, c1_1 * q1_dot_q3_dot_0);
    let y_ddot_of_motion_2_1 = q1_dot_q3_dot_c1_1 + y_ddot_of_motion_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                q2_minus_90deg_1, q2_minus_90deg_1, q1_dot_1, q2_dot_1, q1_dot_1,
                sin_q2_minus_90deg_1, q1_dot_1, u1_dot_of_motion_1, cos_q2_minus_90deg_1,
                sin_q2_minus_90deg_1, u3_dot_of_motion_2_1, sin_q2_minus_90deg_1, q1_1, q1_1, c1_1,
                q1_dot_1, s1_1, s1_1, c1_1,
            ]),
            padded([
                cos_q2_minus_90deg_1, sin_q2_minus_90deg_1, cos_q2_minus_90deg_1,
                u3_dot_of_motion_1, q2_dot_1, q1_dot_q2_dot_1, sin_q2_minus_90deg_1,
                u1_dot_of_q1_dot_1, q1_dot_q2_dot_1, q1_ddot_of_motion_3_1, cos_q2_minus_90deg_1,
                q3_ddot_of_motion_3_1, c1_1, s1_1, q3_dot_dot_1, q3_dot_1, q1_dot_q3_dot_1,
                q3_dot_dot_1, q1_dot_q3_dot_1,
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
    let mut u3_dot_of_motion_last = u3_dot_of_motion_1;
    let mut u3_dot_of_motion_2_last = u3_dot_of_motion_2_1;
    let mut q1_dot_q2_dot_last = q1_dot_q2_dot_1;
    let mut u1_dot_of_motion_last = u1_dot_of_motion_1;
    let mut u1_dot_of_q1_dot_last = u1_dot_of_q1_dot_1;
    let mut q1_ddot_of_motion_3_last = q1_ddot_of_motion_3_1;
    let mut q3_ddot_of_motion_3_last = q3_ddot_of_motion_3_1;
    let mut q3_dot_dot_last = q3_dot_dot_1;
    let mut s1_last = s1_1;
    let mut c1_last = c1_1;
    let mut q1_dot_q3_dot_last = q1_dot_q3_dot_1;
    let mut next = [S::int(0); 24];
    // Rates at order k - 1.
    let mut q1_rate = q1_dot_1;
    let mut q2_minus_90deg_rate = q2_dot_1;
    let mut q3_rate = q3_dot_1;
    let mut x_rate = x_dot_1;
    let mut y_rate = y_dot_1;
    let mut q1_dot_rate = -q1_ddot_of_motion_3_1;
    let mut q2_dot_rate = q2_dot_dot_1;
    let mut q3_dot_rate = q3_dot_dot_1;
    let mut x_dot_rate = r * x_ddot_of_motion_2_1;
    let mut y_dot_rate = r * y_ddot_of_motion_2_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q1 = q1_rate * over_k;
        let q2_minus_90deg = q2_minus_90deg_rate * over_k;
        let q3 = q3_rate * over_k;
        let x = x_rate * over_k;
        let y = y_rate * over_k;
        let q1_dot = q1_dot_rate * over_k;
        let q2_dot = q2_dot_rate * over_k;
        let q3_dot = q3_dot_rate * over_k;
        let x_dot = x_dot_rate * over_k;
        let y_dot = y_dot_rate * over_k;
        series[order] = [
            q1, q2_minus_90deg, q3, x, y, q1_dot, q2_dot, q3_dot, x_dot, y_dot,
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
                q1_dot_1
                    .mul_add(
                        cos_q2_minus_90deg_last,
                        q1_dot_last.mul_add(cos_q2_minus_90deg_1, next[2]),
                    ),
                q2_dot_1
                    .mul_add(
                        u3_dot_of_motion_last,
                        q2_dot_last.mul_add(u3_dot_of_motion_1, next[3]),
                    ),
                q1_dot_1.mul_add(q2_dot_last, q1_dot_last.mul_add(q2_dot_1, next[4])),
                sin_q2_minus_90deg_1
                    .mul_add(
                        q1_dot_q2_dot_last,
                        sin_q2_minus_90deg_last.mul_add(q1_dot_q2_dot_1, next[5]),
                    ),
                q1_dot_1
                    .mul_add(
                        sin_q2_minus_90deg_last,
                        q1_dot_last.mul_add(sin_q2_minus_90deg_1, next[6]),
                    ),
                u1_dot_of_motion_1
                    .mul_add(
                        u1_dot_of_q1_dot_last,
                        u1_dot_of_motion_last.mul_add(u1_dot_of_q1_dot_1, next[7]),
                    ),
                cos_q2_minus_90deg_1
                    .mul_add(
                        q1_dot_q2_dot_last,
                        cos_q2_minus_90deg_last.mul_add(q1_dot_q2_dot_1, next[8]),
                    ),
                sin_q2_minus_90deg_1
                    .mul_add(
                        q1_ddot_of_motion_3_last,
                        sin_q2_minus_90deg_last.mul_add(q1_ddot_of_motion_3_1, next[9]),
                    ),
                u3_dot_of_motion_2_1
                    .mul_add(
                        cos_q2_minus_90deg_last,
                        u3_dot_of_motion_2_last.mul_add(cos_q2_minus_90deg_1, next[10]),
                    ),
                sin_q2_minus_90deg_1
                    .mul_add(
                        q3_ddot_of_motion_3_last,
                        sin_q2_minus_90deg_last.mul_add(q3_ddot_of_motion_3_1, next[11]),
                    ),
                q1_1.mul_add(c1_last, (count_last * q1_last).mul_add(c1_1, next[12])),
                q1_1.mul_add(s1_last, (count_last * q1_last).mul_add(s1_1, next[13])),
                c1_1.mul_add(q3_dot_dot_last, c1_last.mul_add(q3_dot_dot_1, next[14])),
                q1_dot_1.mul_add(q3_dot_last, q1_dot_last.mul_add(q3_dot_1, next[15])),
                s1_1
                    .mul_add(
                        q1_dot_q3_dot_last,
                        s1_last.mul_add(q1_dot_q3_dot_1, next[16]),
                    ),
                s1_1.mul_add(q3_dot_dot_last, s1_last.mul_add(q3_dot_dot_1, next[17])),
                c1_1
                    .mul_add(
                        q1_dot_q3_dot_last,
                        c1_last.mul_add(q1_dot_q3_dot_1, next[18]),
                    ),
            ])
        };
        // sin_q2_minus_90deg = sin(q2_minus_90deg)
        let sin_q2_minus_90deg = q2_minus_90deg
            .mul_add(cos_q2_minus_90deg_0, sums[0] * over_k);
        // cos_q2_minus_90deg = cos(q2_minus_90deg)
        let cos_q2_minus_90deg = -q2_minus_90deg
            .mul_add(sin_q2_minus_90deg_0, sums[1] * over_k);
        // u3_dot_of_q1_dot = q1_dot*cos_q2_minus_90deg
        let u3_dot_of_q1_dot = cos_q2_minus_90deg
            .mul_add(q1_dot_0, q1_dot.mul_add(cos_q2_minus_90deg_0, sums[2]));
        // u3_dot_of_motion = 2*q3_dot + u3_dot_of_q1_dot
        let u3_dot_of_motion = S::int(2) * q3_dot + u3_dot_of_q1_dot;
        // u3_dot_of_motion_2 = q2_dot*u3_dot_of_motion
        let u3_dot_of_motion_2 = u3_dot_of_motion
            .mul_add(q2_dot_0, q2_dot.mul_add(u3_dot_of_motion_0, sums[3]));
        // q1_dot_q2_dot = q1_dot*q2_dot
        let q1_dot_q2_dot = q2_dot.mul_add(q1_dot_0, q1_dot.mul_add(q2_dot_0, sums[4]));
        // u2_dot_of_motion = sin_q2_minus_90deg*q1_dot_q2_dot
        let u2_dot_of_motion = q1_dot_q2_dot
            .mul_add(
                sin_q2_minus_90deg_0,
                sin_q2_minus_90deg.mul_add(q1_dot_q2_dot_0, sums[5]),
            );
        // u1_dot_of_motion = 6*q3_dot + 5*u3_dot_of_q1_dot
        let u1_dot_of_motion = u3_dot_of_q1_dot.mul_add(S::int(5), S::int(6) * q3_dot);
        // u1_dot_of_q1_dot = q1_dot*sin_q2_minus_90deg
        let u1_dot_of_q1_dot = sin_q2_minus_90deg
            .mul_add(q1_dot_0, q1_dot.mul_add(sin_q2_minus_90deg_0, sums[6]));
        // u1_dot_of_motion_2 = u1_dot_of_motion*u1_dot_of_q1_dot
        let u1_dot_of_motion_2 = u1_dot_of_motion
            .mul_add(
                u1_dot_of_q1_dot_0,
                u1_dot_of_q1_dot.mul_add(u1_dot_of_motion_0, sums[7]),
            );
        // q2_dot_dot = -1/5*u1_dot_of_motion_2 + weight*cos_q2_minus_90deg
        let q2_dot_dot = u1_dot_of_motion_2
            .mul_add(-S::ratio(1, 5), weight * cos_q2_minus_90deg);
        // q1_ddot_of_motion = cos_q2_minus_90deg*q1_dot_q2_dot
        let q1_ddot_of_motion = q1_dot_q2_dot
            .mul_add(
                cos_q2_minus_90deg_0,
                cos_q2_minus_90deg.mul_add(q1_dot_q2_dot_0, sums[8]),
            );
        // q1_ddot_of_motion_2 = -u3_dot_of_motion_2 + q1_ddot_of_motion
        let q1_ddot_of_motion_2 = q1_ddot_of_motion - u3_dot_of_motion_2;
        // q1_ddot_of_motion_3 = q1_ddot_of_motion_2/sin_q2_minus_90deg
        let q1_ddot_of_motion_3 = q1_ddot_of_motion_2
            .mul_add(
                over_sin_q2_minus_90deg,
                -(sin_q2_minus_90deg.mul_add(q1_ddot_of_motion_3_0, sums[9])
                    * over_sin_q2_minus_90deg),
            );
        // q3_ddot_of_motion = u3_dot_of_motion_2*cos_q2_minus_90deg
        let q3_ddot_of_motion = u3_dot_of_motion_2
            .mul_add(
                cos_q2_minus_90deg_0,
                cos_q2_minus_90deg.mul_add(u3_dot_of_motion_2_0, sums[10]),
            );
        // q3_ddot_of_motion_2 = q1_dot_q2_dot - q3_ddot_of_motion
        let q3_ddot_of_motion_2 = q1_dot_q2_dot - q3_ddot_of_motion;
        // q3_ddot_of_motion_3 = q3_ddot_of_motion_2/sin_q2_minus_90deg
        let q3_ddot_of_motion_3 = q3_ddot_of_motion_2
            .mul_add(
                over_sin_q2_minus_90deg,
                -(sin_q2_minus_90deg.mul_add(q3_ddot_of_motion_3_0, sums[11])
                    * over_sin_q2_minus_90deg),
            );
        // q3_dot_dot = 2/3*u2_dot_of_motion + q3_ddot_of_motion_3
        let q3_dot_dot = S::ratio(2, 3) * u2_dot_of_motion + q3_ddot_of_motion_3;
        // s1 = sin(q1)
        let s1 = q1.mul_add(c1_0, sums[12] * over_k);
        // c1 = cos(q1)
        let c1 = -q1.mul_add(s1_0, sums[13] * over_k);
        // x_ddot_of_motion = c1*q3_dot_dot
        let x_ddot_of_motion = q3_dot_dot
            .mul_add(c1_0, c1.mul_add(q3_dot_dot_0, sums[14]));
        // q1_dot_q3_dot = q1_dot*q3_dot
        let q1_dot_q3_dot = q3_dot.mul_add(q1_dot_0, q1_dot.mul_add(q3_dot_0, sums[15]));
        // q1_dot_q3_dot_s1 = s1*q1_dot_q3_dot
        let q1_dot_q3_dot_s1 = q1_dot_q3_dot
            .mul_add(s1_0, s1.mul_add(q1_dot_q3_dot_0, sums[16]));
        // x_ddot_of_motion_2 = x_ddot_of_motion - q1_dot_q3_dot_s1
        let x_ddot_of_motion_2 = -q1_dot_q3_dot_s1 + x_ddot_of_motion;
        // y_ddot_of_motion = s1*q3_dot_dot
        let y_ddot_of_motion = q3_dot_dot
            .mul_add(s1_0, s1.mul_add(q3_dot_dot_0, sums[17]));
        // q1_dot_q3_dot_c1 = c1*q1_dot_q3_dot
        let q1_dot_q3_dot_c1 = q1_dot_q3_dot
            .mul_add(c1_0, c1.mul_add(q1_dot_q3_dot_0, sums[18]));
        // y_ddot_of_motion_2 = y_ddot_of_motion + q1_dot_q3_dot_c1
        let y_ddot_of_motion_2 = q1_dot_q3_dot_c1 + y_ddot_of_motion;
        q1_rate = q1_dot;
        q2_minus_90deg_rate = q2_dot;
        q3_rate = q3_dot;
        x_rate = x_dot;
        y_rate = y_dot;
        q1_dot_rate = -q1_ddot_of_motion_3;
        q2_dot_rate = q2_dot_dot;
        q3_dot_rate = q3_dot_dot;
        x_dot_rate = r * x_ddot_of_motion_2;
        y_dot_rate = r * y_ddot_of_motion_2;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * q2_minus_90deg,
                count * q2_minus_90deg,
                q1_dot, q2_dot, q1_dot, sin_q2_minus_90deg, q1_dot, u1_dot_of_motion,
                cos_q2_minus_90deg, sin_q2_minus_90deg, u3_dot_of_motion_2, sin_q2_minus_90deg,
                count * q1,
                count * q1,
                c1, q1_dot, s1, s1, c1,
            ]),
            padded([
                cos_q2_minus_90deg, sin_q2_minus_90deg, cos_q2_minus_90deg, u3_dot_of_motion,
                q2_dot, q1_dot_q2_dot, sin_q2_minus_90deg, u1_dot_of_q1_dot, q1_dot_q2_dot,
                q1_ddot_of_motion_3, cos_q2_minus_90deg, q3_ddot_of_motion_3, c1, s1, q3_dot_dot,
                q3_dot, q1_dot_q3_dot, q3_dot_dot, q1_dot_q3_dot,
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
        u3_dot_of_motion_last = u3_dot_of_motion;
        u3_dot_of_motion_2_last = u3_dot_of_motion_2;
        q1_dot_q2_dot_last = q1_dot_q2_dot;
        u1_dot_of_motion_last = u1_dot_of_motion;
        u1_dot_of_q1_dot_last = u1_dot_of_q1_dot;
        q1_ddot_of_motion_3_last = q1_ddot_of_motion_3;
        q3_ddot_of_motion_3_last = q3_ddot_of_motion_3;
        q3_dot_dot_last = q3_dot_dot;
        s1_last = s1;
        c1_last = c1;
        q1_dot_q3_dot_last = q1_dot_q3_dot;
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
            speeds: 3,
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
        8
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
    fn constraint_count(&self) -> usize {
        2
    }
    fn constraint_name(&self, at: usize) -> &str {
        ["ground_1", "ground_2"][at]
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
