//! Thin disc rolling on a plane: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/rolling_disc/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

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
    let [q1, q2, _, _, _] = *q;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let r_m = r * m;
    let r_r_m = r * r_m;
    let r_r_m_times_5_by_4 = S::ratio(5, 4) * r_r_m;
    let r_r_m_halved = S::ratio(1, 2) * r_r_m;
    let s2_r_r_m_halved = r_r_m_halved * s2;
    let s2_r_m = r_m * s2;
    let c1_s2_r_m = s2_r_m * c1;
    let s1_s2_r_m = s2_r_m * s1;
    let c2_r_m = r_m * c2;
    let s1_c2_r_m = c2_r_m * s1;
    let c1_c2_r_m = c2_r_m * c1;
    let r_c1 = r * c1;
    let r_s1 = r * s1;
    // -c1_c2_r_m
    let minus_c1_c2_r_m = -c1_c2_r_m;
    // Entries that are not zero.
    // M11 = r^2*m*(6 - 5*cos(q2)^2)/4
    let m11 = S::ratio(3, 2) * r_r_m - r_r_m_times_5_by_4 * c2 * c2;
    // M13 = r^2*m*sin(q2)/2
    let m13 = s2_r_r_m_halved;
    // M14 = r*m*cos(q1)*sin(q2)
    let m14 = c1_s2_r_m;
    // M15 = r*m*sin(q1)*sin(q2)
    let m15 = s1_s2_r_m;
    // M22 = 5*r^2*m/4
    let m22 = r_r_m_times_5_by_4;
    // M24 = r*m*sin(q1)*cos(q2)
    let m24 = s1_c2_r_m;
    // M25 = -r*m*cos(q1)*cos(q2)
    let m25 = minus_c1_c2_r_m;
    // M31 = r^2*m*sin(q2)/2
    let m31 = s2_r_r_m_halved;
    // M33 = r^2*m/2
    let m33 = r_r_m_halved;
    // M36 = r*cos(q1)
    let m36 = r_c1;
    // M37 = r*sin(q1)
    let m37 = r_s1;
    // M41 = r*m*cos(q1)*sin(q2)
    let m41 = c1_s2_r_m;
    // M42 = r*m*sin(q1)*cos(q2)
    let m42 = s1_c2_r_m;
    // M44 = m
    let m44 = m;
    // M46 = -1
    let m46 = -S::int(1);
    // M51 = r*m*sin(q1)*sin(q2)
    let m51 = s1_s2_r_m;
    // M52 = -r*m*cos(q1)*cos(q2)
    let m52 = minus_c1_c2_r_m;
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
/// 40 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> [S; 7] {
    let Parameters { r, m, g } = *p;
    let [q1, q2, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, _, _] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let r_m = r * m;
    let c2_r_m = r_m * c2;
    let q2_dot_c2_r_m = q2_dot * c2_r_m;
    let r_q1_dot = r * q1_dot;
    let s2_r_q1_dot = r_q1_dot * s2;
    let q2_dot_c2_r_m_halved = S::ratio(1, 2) * q2_dot_c2_r_m;
    let s2_r_m = r_m * s2;
    let q3_dot_r_q1_dot = q3_dot * r_q1_dot;
    // s2_r_m*(q1'^2 + q2'^2)
    let f4_of_motion = s2_r_m * q2_dot.mul_add(q2_dot, q1_dot * q1_dot);
    let f4_of_motion_2 = S::int(2) * q1_dot * q2_dot_c2_r_m;
    // Values.
    // f1 = -r^2*m*q2'*cos(q2)*(5*q1'*sin(q2) + q3')/2
    let f1 = (-(r * q3_dot))
        .mul_add(q2_dot_c2_r_m_halved, -S::ratio(5, 2) * q2_dot_c2_r_m * s2_r_q1_dot);
    // f2 = r*m*(4*g*sin(q2) + r*q1'*cos(q2)*(5*q1'*sin(q2) + 2*q3'))/4
    let f2 = g.mul_add(s2_r_m, S::ratio(5, 4) * q1_dot * c2_r_m * s2_r_q1_dot)
        + S::ratio(1, 2) * c2_r_m * q3_dot_r_q1_dot;
    // f3 = -r^2*m*q1'*q2'*cos(q2)/2
    let f3 = -r_q1_dot * q2_dot_c2_r_m_halved;
    // f4 = r*m*(q2'^2*sin(q1)*sin(q2) - q1'*(2*q2'*cos(q1)*cos(q2) - q1'*sin(q1)*sin(q2)))
    let f4 = (-f4_of_motion_2).mul_add(c1, f4_of_motion * s1);
    // f5 = -r*m*(q2'^2*cos(q1)*sin(q2) + q1'*(q1'*cos(q1)*sin(q2) + 2*q2'*sin(q1)*cos(q2)))
    let f5 = (-f4_of_motion_2).mul_add(s1, -f4_of_motion * c1);
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
    let [q1, q2, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, _, _] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let q1_dot_q2_dot = q1_dot * q2_dot;
    let s2_q1_dot_q2_dot = q1_dot_q2_dot * s2;
    // u3' = -q2'*(q1'*sin(q2) + 2*q3')
    let u3_dot = (-(q2_dot * q3_dot)).mul_add(S::int(2), -s2_q1_dot_q2_dot);
    // u2' = -2*q1'*q2'*cos(q2)/3
    let u2_dot = -S::ratio(2, 3) * q1_dot_q2_dot * c2;
    let q1_dot_q3_dot = q1_dot * q3_dot;
    // u1' = 4*g*sin(q2)/(5*r) + q1'*cos(q2)*(5*q1'*sin(q2) + 6*q3')/5
    let u1_dot = S::ratio(4, 5) * g * s2 / r + q1_dot * q1_dot * s2 * c2
        + S::ratio(6, 5) * q1_dot_q3_dot * c2;
    let c2_inv = S::int(1) / c2;
    // q1'' = q1'*q2'*tan(q2) + u3'/cos(q2)
    let q1_ddot = c2_inv * (u3_dot + s2_q1_dot_q2_dot);
    // q2'' = u1'
    let q2_ddot = u1_dot;
    // q3'' = u2' - q1'*q2'/cos(q2) - u3'*tan(q2)
    let q3_ddot = u2_dot - c2_inv * u3_dot.mul_add(s2, q1_dot_q2_dot);
    let r_s1 = r * s1;
    let r_c1 = r * c1;
    // x'' = r*cos(q1)*(u2' - u3'*tan(q2)) - r*q1'*(q2'*cos(q1)/cos(q2) + q3'*sin(q1))
    let x_ddot = (-q1_dot_q3_dot).mul_add(r_s1, q3_ddot * r_c1);
    // y'' = r*q1'*(q3'*cos(q1) - q2'*sin(q1)/cos(q2)) + r*sin(q1)*(u2' - u3'*tan(q2))
    let y_ddot = q1_dot_q3_dot.mul_add(r_c1, q3_ddot * r_s1);
    [q1_ddot, q2_ddot, q3_ddot, x_ddot, y_ddot]
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
    let [q1_dot, q2_dot, q3_dot, x_dot, y_dot] = *q_dot;
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
    [q1_dot_value, q2_dot_value, q3_dot_value, x_dot_value, y_dot_value]
}

/// Kinetic energy T.
///
/// 34 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> S {
    let Parameters { r, m, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, x_dot, y_dot] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let r_m = r * m;
    let q1_dot_s2 = q1_dot * s2;
    // q2'^2 + q1_dot_s2^2
    let energy_of_motion = q1_dot_s2.mul_add(q1_dot_s2, q2_dot * q2_dot);
    // q1'^2 + 2*q3'*(q3' + 2*q1_dot_s2)
    let energy_of_motion_2 = S::int(2) * q3_dot * q1_dot_s2.mul_add(S::int(2), q3_dot)
        + q1_dot * q1_dot;
    // Values.
    // T = r^2*m*q1'^2*(6 - 5*cos(q2)^2)/8 + 5*r^2*m*q2'^2/8 + r^2*m*q3'^2/4 + r^2*m*q1'*q3'*sin(q2)/2 +
    //   m*x'^2/2 + r*m*q1'*x'*cos(q1)*sin(q2) + r*m*q2'*x'*sin(q1)*cos(q2) + m*y'^2/2 +
    //   r*m*q1'*y'*sin(q1)*sin(q2) - r*m*q2'*y'*cos(q1)*cos(q2)
    let energy = S::ratio(1, 2) * m * y_dot.mul_add(y_dot, x_dot * x_dot)
        + r_m
            * (q2_dot * c2 * (-y_dot).mul_add(c1, x_dot * s1)
                + q1_dot_s2 * y_dot.mul_add(s1, x_dot * c1))
        + S::ratio(1, 8) * r * r_m * energy_of_motion.mul_add(S::int(5), energy_of_motion_2);
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 3] {
    let [_, q2, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, _, _] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Values.
    // u1 = q2'
    let u1_value = q2_dot;
    // u2 = q1'*sin(q2) + q3'
    let u2_value = q1_dot.mul_add(s2, q3_dot);
    // u3 = q1'*cos(q2)
    let u3_value = q1_dot * c2;
    [u1_value, u2_value, u3_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 8 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
    v_dot: &[S; 5],
) -> [S; 3] {
    let [_, q2, _, _, _] = *q;
    let [q1_dot, q2_dot, _, _, _] = *q_dot;
    let [q1_ddot, q2_ddot, q3_ddot, _, _] = *v_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    let q1_dot_q2_dot = q1_dot * q2_dot;
    // Values.
    // u1' = q2''
    let u1_dot_value = q2_ddot;
    // u2' = q1'*q2'*cos(q2) + q1''*sin(q2) + q3''
    let u2_dot_value = q1_ddot.mul_add(s2, q3_ddot) + q1_dot_q2_dot * c2;
    // u3' = q1''*cos(q2) - q1'*q2'*sin(q2)
    let u3_dot_value = (-q1_dot_q2_dot).mul_add(s2, q1_ddot * c2);
    [u1_dot_value, u2_dot_value, u3_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 8 operations, 2 sines and cosines.
#[must_use]
pub fn motion_variables<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 3]) -> [S; 5] {
    let Parameters { r, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let u3_c2_inv = u3 / c2;
    // u3_c2_inv*sin(q2) - u2
    let q3_dot_value_of_q2_u2_u3 = u3_c2_inv.mul_add(s2, -u2);
    // -r*q3_dot_value_of_q2_u2_u3
    let x_dot_value_of_r_q2_u2_u3 = -r * q3_dot_value_of_q2_u2_u3;
    // Values.
    // q1' = u3/cos(q2)
    let q1_dot_value = u3_c2_inv;
    // q2' = u1
    let q2_dot_value = u1;
    // q3' = u2 - u3*tan(q2)
    let q3_dot_value = -q3_dot_value_of_q2_u2_u3;
    // x' = r*cos(q1)*(u2 - u3*tan(q2))
    let x_dot_value = x_dot_value_of_r_q2_u2_u3 * c1;
    // y' = r*sin(q1)*(u2 - u3*tan(q2))
    let y_dot_value = x_dot_value_of_r_q2_u2_u3 * s1;
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
    let [q1, q2, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, x_dot, y_dot] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let q1_dot_q2_dot = q1_dot * q2_dot;
    let s2_q1_dot_q2_dot = q1_dot_q2_dot * s2;
    // u3' = -q2'*(q1'*sin(q2) + 2*q3')
    let u3_dot = (-(q2_dot * q3_dot)).mul_add(S::int(2), -s2_q1_dot_q2_dot);
    // u2' = -2*q1'*q2'*cos(q2)/3
    let u2_dot = -S::ratio(2, 3) * q1_dot_q2_dot * c2;
    let q1_dot_q3_dot = q1_dot * q3_dot;
    // u1' = 4*g*sin(q2)/(5*r) + q1'*cos(q2)*(5*q1'*sin(q2) + 6*q3')/5
    let u1_dot = S::ratio(4, 5) * g * s2 / r + q1_dot * q1_dot * s2 * c2
        + S::ratio(6, 5) * q1_dot_q3_dot * c2;
    let c2_inv = S::int(1) / c2;
    // q1'' = q1'*q2'*tan(q2) + u3'/cos(q2)
    let q1_ddot = c2_inv * (u3_dot + s2_q1_dot_q2_dot);
    // q2'' = u1'
    let q2_ddot = u1_dot;
    // q3'' = u2' - q1'*q2'/cos(q2) - u3'*tan(q2)
    let q3_ddot = u2_dot - c2_inv * u3_dot.mul_add(s2, q1_dot_q2_dot);
    let r_s1 = r * s1;
    let r_c1 = r * c1;
    // x'' = r*cos(q1)*(u2' - u3'*tan(q2)) - r*q1'*(q2'*cos(q1)/cos(q2) + q3'*sin(q1))
    let x_ddot = (-q1_dot_q3_dot).mul_add(r_s1, q3_ddot * r_c1);
    // y'' = r*q1'*(q3'*cos(q1) - q2'*sin(q1)/cos(q2)) + r*sin(q1)*(u2' - u3'*tan(q2))
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

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 5], _q_dot: &[S; 5]) -> [S; 1] {
    let [_, q2, _, _, _] = *q;
    // Sines and cosines.
    let (_, c2) = q2.sin_cos();
    // Values.
    // divisor1 = cos(q2)
    let divisor1 = c2;
    [divisor1]
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn constraints<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> [S; 2] {
    let Parameters { r, .. } = *p;
    let [q1, _, _, _, _] = *q;
    let [_, _, q3_dot, x_dot, y_dot] = *q_dot;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let r_q3_dot = r * q3_dot;
    // Values.
    // ground_1 = x' - r*q3'*cos(q1)
    let residual1 = (-r_q3_dot).mul_add(c1, x_dot);
    // ground_2 = y' - r*q3'*sin(q1)
    let residual2 = (-r_q3_dot).mul_add(s1, y_dot);
    [residual1, residual2]
}

/// Slopes of the constraints, one after the other, along q1, q2, q3, x, y, q1', q2', q3', x', y'.
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
        ["cos(q2)"][at]
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
    slice.try_into().expect("a slice of the length that `System` requires")
}
