//! Three-link pendulum on a cart: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/cart_pendulum_3/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows q0, q1, q2, q3.
///
/// 30 operations, 3 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    _q_dot: &[S; 4],
) -> [[S; 4]; 4] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, .. } = *p;
    let [_, q1, q2, q3] = *q;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    // Shared terms.
    // m2 + m3
    let m2_plus_m3 = m2 + m3;
    // m1 + m2_plus_m3
    let m1_plus_m2_plus_m3 = m1 + m2_plus_m3;
    let l0_m1_plus_m2_plus_m3 = l0 * m1_plus_m2_plus_m3;
    let l1_m2_plus_m3 = l1 * m2_plus_m3;
    let m3_l2 = m3 * l2;
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let cos_q1_minus_q2 = c1.mul_add(c2, s1 * s2);
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let cos_q1_minus_q3 = c1.mul_add(c3, s1 * s3_2);
    // sin(q2)*sin(q3) + cos(q2)*cos(q3)
    let cos_q2_minus_q3 = c2.mul_add(c3, s2 * s3_2);
    // Entries that are not zero; upper triangle.
    // M11 = m0 + m1 + m2 + m3
    let m11 = m0 + m1_plus_m2_plus_m3;
    // M12 = -l0*cos(q1)*(m1 + m2 + m3)
    let m12 = -l0_m1_plus_m2_plus_m3 * c1;
    // M13 = -l1*cos(q2)*(m2 + m3)
    let m13 = -l1_m2_plus_m3 * c2;
    // M14 = -m3*l2*cos(q3)
    let m14 = -m3_l2 * c3;
    // M22 = l0^2*(m1 + m2 + m3)
    let m22 = l0 * l0_m1_plus_m2_plus_m3;
    // M23 = l0*l1*cos(q1 - q2)*(m2 + m3)
    let m23 = l0 * cos_q1_minus_q2 * l1_m2_plus_m3;
    // M24 = m3*l0*l2*cos(q1 - q3)
    let m24 = l0 * cos_q1_minus_q3 * m3_l2;
    // M33 = l1^2*(m2 + m3)
    let m33 = l1 * l1_m2_plus_m3;
    // M34 = m3*l1*l2*cos(q2 - q3)
    let m34 = l1 * cos_q2_minus_q3 * m3_l2;
    // M44 = m3*l2^2
    let m44 = l2 * m3_l2;
    [
        [m11, m12, m13, m14],
        [m12, m22, m23, m24],
        [m13, m23, m33, m34],
        [m14, m24, m34, m44],
    ]
}

/// Right-hand side of the linear system; unknowns (q0'', q1'', q2'', q3'').
///
/// 45 operations, 3 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 4], q_dot: &[S; 4]) -> [S; 4] {
    let Parameters { m1, m2, m3, l0, l1, l2, g, F, .. } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    let m3_l2 = m3 * l2;
    let q3_dot_sq_m3_l2 = q3_dot * q3_dot * m3_l2;
    let l0_q1_dot_sq = l0 * q1_dot * q1_dot;
    // m2 + m3
    let m2_plus_m3 = m2 + m3;
    // sin(q1)*(m1 + m2_plus_m3)
    let f1_of_m1_m2_m3_q1 = s1 * (m1 + m2_plus_m3);
    let l1_q2_dot_sq = l1 * q2_dot * q2_dot;
    let m2_plus_m3_l1_q2_dot_sq = m2_plus_m3 * l1_q2_dot_sq;
    // sin(q1)*cos(q3) - cos(q1)*sin(q3)
    let sin_q1_minus_q3 = (-c1).mul_add(s3_2, s1 * c3);
    // sin(q1)*cos(q2) - cos(q1)*sin(q2)
    let sin_q1_minus_q2 = (-c1).mul_add(s2, s1 * c2);
    // sin(q2)*cos(q3) - cos(q2)*sin(q3)
    let sin_q2_minus_q3 = (-c2).mul_add(s3_2, s2 * c3);
    // Values.
    // f1 = F - l0*q1'^2*sin(q1)*(m1 + m2 + m3) - l1*q2'^2*sin(q2)*(m2 + m3) - m3*l2*q3'^2*sin(q3)
    let f1 = (-q3_dot_sq_m3_l2).mul_add(s3_2, F) - l0_q1_dot_sq * f1_of_m1_m2_m3_q1
        - m2_plus_m3_l1_q2_dot_sq * s2;
    // f2 = l0*(g*sin(q1)*(m1 + m2 + m3) - l1*q2'^2*sin(q1 - q2)*(m2 + m3) - m3*l2*q3'^2*sin(q1 - q3))
    let f2 = l0
        * ((-sin_q1_minus_q3).mul_add(q3_dot_sq_m3_l2, g * f1_of_m1_m2_m3_q1)
            - sin_q1_minus_q2 * m2_plus_m3_l1_q2_dot_sq);
    // f3 = l1*((m2 + m3)*(g*sin(q2) + l0*q1'^2*sin(q1 - q2)) - m3*l2*q3'^2*sin(q2 - q3))
    let f3 = l1
        * (m2_plus_m3 * sin_q1_minus_q2.mul_add(l0_q1_dot_sq, g * s2)
            - sin_q2_minus_q3 * q3_dot_sq_m3_l2);
    // f4 = m3*l2*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3))
    let f4 = m3_l2
        * (sin_q1_minus_q3.mul_add(l0_q1_dot_sq, g * s3_2) + sin_q2_minus_q3 * l1_q2_dot_sq);
    [f1, f2, f3, f4]
}

/// The accelerations (q0'', q1'', q2'', q3''), solved for when this code was generated.
///
/// 126 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    q_dot: &[S; 4],
) -> [S; 4] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s3_2, c3) = q3.sin_cos();
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let m3_l2 = m3 * l2;
    // d1 = m3*l2^2
    let d1 = l2 * m3_l2;
    let d1_inv_m3_l2 = m3_l2 / d1;
    // l2_ = -m3*l2*cos(q3)/d1
    let l2_ = -d1_inv_m3_l2 * c3;
    // m2 + m3
    let m2_plus_m3 = m2 + m3;
    // m1 + m2_plus_m3
    let m1_plus_m2_plus_m3 = m1 + m2_plus_m3;
    let l2__m3_l2 = l2_ * m3_l2;
    // s3 = m0 + m1 + m2 + m3 + m3*l2*l2_*cos(q3)
    let s3 = l2__m3_l2.mul_add(c3, m0 + m1_plus_m2_plus_m3);
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let cos_q1_minus_q3 = c1.mul_add(c3, s1 * s3_2);
    let l0_cos_q1_minus_q3 = l0 * cos_q1_minus_q3;
    let l0_m1_plus_m2_plus_m3 = l0 * m1_plus_m2_plus_m3;
    // s4 = -l0*(cos(q1)*(m1 + m2 + m3) + m3*l2*l2_*cos(q1 - q3))
    let s4 = (-l0_m1_plus_m2_plus_m3).mul_add(c1, -l2__m3_l2 * l0_cos_q1_minus_q3);
    let l1_m2_plus_m3 = l1 * m2_plus_m3;
    // sin(q2)*sin(q3) + cos(q2)*cos(q3)
    let cos_q2_minus_q3 = c2.mul_add(c3, s2 * s3_2);
    let l1_cos_q2_minus_q3 = l1 * cos_q2_minus_q3;
    // s5 = -l1*(cos(q2)*(m2 + m3) + m3*l2*l2_*cos(q2 - q3))
    let s5 = (-l2__m3_l2).mul_add(l1_cos_q2_minus_q3, -l1_m2_plus_m3 * c2);
    let q1_dot_sq = q1_dot * q1_dot;
    // sin(q1)*cos(q3) - cos(q1)*sin(q3)
    let sin_q1_minus_q3 = (-c1).mul_add(s3_2, s1 * c3);
    let l0_sin_q1_minus_q3 = l0 * sin_q1_minus_q3;
    let q2_dot_sq = q2_dot * q2_dot;
    // sin(q2)*cos(q3) - cos(q2)*sin(q3)
    let sin_q2_minus_q3 = (-c2).mul_add(s3_2, s2 * c3);
    let l1_sin_q2_minus_q3 = l1 * sin_q2_minus_q3;
    // q1_dot_sq*l0_sin_q1_minus_q3 + q2_dot_sq*l1_sin_q2_minus_q3
    let r6_of_motion = q2_dot_sq
        .mul_add(l1_sin_q2_minus_q3, q1_dot_sq * l0_sin_q1_minus_q3);
    // g*sin(q3) + r6_of_motion
    let g_s3_2_plus_r6_of_motion = g.mul_add(s3_2, r6_of_motion);
    let q3_dot_sq_m3_l2 = q3_dot * q3_dot * m3_l2;
    let s2_l1_m2_plus_m3 = l1_m2_plus_m3 * s2;
    let s1_l0_m1_plus_m2_plus_m3 = l0_m1_plus_m2_plus_m3 * s1;
    // r6 = F - l0*q1'^2*sin(q1)*(m1 + m2 + m3) - l1*q2'^2*sin(q2)*(m2 + m3) - m3*l2*(q3'^2*sin(q3) +
    //   l2_*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)))
    let r6 = (-l2__m3_l2).mul_add(g_s3_2_plus_r6_of_motion, F) - q3_dot_sq_m3_l2 * s3_2
        - q2_dot_sq * s2_l1_m2_plus_m3 - q1_dot_sq * s1_l0_m1_plus_m2_plus_m3;
    // l7 = m3*l0*l2*cos(q1 - q3)/d1
    let l7 = d1_inv_m3_l2 * l0_cos_q1_minus_q3;
    let l7_m3_l2 = l7 * m3_l2;
    // s8 = l0*(l0*(m1 + m2 + m3) - m3*l2*l7*cos(q1 - q3))
    let s8 = (-l0_cos_q1_minus_q3).mul_add(l7_m3_l2, l0 * l0_m1_plus_m2_plus_m3);
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let cos_q1_minus_q2 = c1.mul_add(c2, s1 * s2);
    let l0_l1_m2_plus_m3 = l0 * l1_m2_plus_m3;
    // s9 = l1*(l0*cos(q1 - q2)*(m2 + m3) - m3*l2*l7*cos(q2 - q3))
    let s9 = (-l1_cos_q2_minus_q3).mul_add(l7_m3_l2, cos_q1_minus_q2 * l0_l1_m2_plus_m3);
    // sin(q1)*cos(q2) - cos(q1)*sin(q2)
    let sin_q1_minus_q2 = (-c1).mul_add(s2, s1 * c2);
    let r10_of_place = sin_q1_minus_q2 * l0_l1_m2_plus_m3;
    // r10 = l0*(g*sin(q1)*(m1 + m2 + m3) - l1*q2'^2*sin(q1 - q2)*(m2 + m3)) - m3*l2*(l0*q3'^2*sin(q1 - q3)
    //   + l7*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)))
    let r10 = (-l0_sin_q1_minus_q3)
        .mul_add(q3_dot_sq_m3_l2, g * s1_l0_m1_plus_m2_plus_m3)
        - g_s3_2_plus_r6_of_motion * l7_m3_l2 - q2_dot_sq * r10_of_place;
    // l11 = m3*l1*l2*cos(q2 - q3)/d1
    let l11 = d1_inv_m3_l2 * l1_cos_q2_minus_q3;
    let l11_m3_l2 = l11 * m3_l2;
    // s12 = l1*(l1*(m2 + m3) - m3*l2*l11*cos(q2 - q3))
    let s12 = (-l1_cos_q2_minus_q3).mul_add(l11_m3_l2, l1 * l1_m2_plus_m3);
    // r13 = l1*(m2 + m3)*(g*sin(q2) + l0*q1'^2*sin(q1 - q2)) - m3*l2*(l1*q3'^2*sin(q2 - q3) +
    //   l11*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)))
    let r13 = (-l1_sin_q2_minus_q3).mul_add(q3_dot_sq_m3_l2, g * s2_l1_m2_plus_m3)
        + q1_dot_sq * r10_of_place - g_s3_2_plus_r6_of_motion * l11_m3_l2;
    let s3_inv = S::int(1) / s3;
    // l14 = s4/s3
    let l14 = s4 * s3_inv;
    // s15 = s8 - s4*l14
    let s15 = (-s4).mul_add(l14, s8);
    // s16 = s9 - s5*l14
    let s16 = (-s5).mul_add(l14, s9);
    // r17 = r10 - r6*l14
    let r17 = (-r6).mul_add(l14, r10);
    // l18 = s5/s3
    let l18 = s5 * s3_inv;
    // s19 = s12 - s5*l18
    let s19 = (-s5).mul_add(l18, s12);
    // r20 = r13 - r6*l18
    let r20 = (-r6).mul_add(l18, r13);
    let s15_inv = S::int(1) / s15;
    // l21 = s16/s15
    let l21 = s16 * s15_inv;
    // s22 = s19 - s16*l21
    let s22 = (-s16).mul_add(l21, s19);
    // r23 = r20 - r17*l21
    let r23 = (-r17).mul_add(l21, r20);
    // q2'' = r23/s22
    let q2_ddot = r23 / s22;
    // q1'' = (r17 - q2''*s16)/s15
    let q1_ddot = (-q2_ddot).mul_add(l21, r17 * s15_inv);
    // q0'' = (r6 - q1''*s4 - q2''*s5)/s3
    let q0_ddot = (-q1_ddot).mul_add(l14, r6 * s3_inv) - q2_ddot * l18;
    // q3'' = m3*l2*(g*sin(q3) + q0''*cos(q3) + l0*(q1'^2*sin(q1 - q3) - q1''*cos(q1 - q3)) +
    //   l1*(q2'^2*sin(q2 - q3) - q2''*cos(q2 - q3)))/d1
    let q3_ddot = d1_inv_m3_l2 * q0_ddot.mul_add(c3, g_s3_2_plus_r6_of_motion)
        - q1_ddot * l7 - q2_ddot * l11;
    [q0_ddot, q1_ddot, q2_ddot, q3_ddot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 4],
    q_dot: &[S; 4],
) -> [S; 4] {
    let [q0_dot, q1_dot, q2_dot, q3_dot] = *q_dot;
    // Values.
    // q0'
    let q0_dot_value = q0_dot;
    // q1'
    let q1_dot_value = q1_dot;
    // q2'
    let q2_dot_value = q2_dot;
    // q3'
    let q3_dot_value = q3_dot;
    [q0_dot_value, q1_dot_value, q2_dot_value, q3_dot_value]
}

/// Kinetic energy T.
///
/// 39 operations, 3 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 4], q_dot: &[S; 4]) -> S {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, .. } = *p;
    let [_, q1, q2, q3] = *q;
    let [q0_dot, q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    // Shared terms.
    // m2 + m3
    let m2_plus_m3 = m2 + m3;
    // m1 + m2_plus_m3
    let m1_plus_m2_plus_m3 = m1 + m2_plus_m3;
    let l0_q1_dot = l0 * q1_dot;
    let c1_l0_q1_dot = l0_q1_dot * c1;
    // q0' - c1_l0_q1_dot
    let energy_of_motion = q0_dot - c1_l0_q1_dot;
    let s1_l0_q1_dot = l0_q1_dot * s1;
    let l1_q2_dot = l1 * q2_dot;
    let m2_plus_m3_l1_q2_dot = m2_plus_m3 * l1_q2_dot;
    let l2_q3_dot = l2 * q3_dot;
    let m3_l2_q3_dot = m3 * l2_q3_dot;
    // energy_of_motion*cos(q3) - l1_q2_dot*(sin(q2)*sin(q3) + cos(q2)*cos(q3))
    let energy_of_motion_2 = -l1_q2_dot * c2.mul_add(c3, s2 * s3_2) + energy_of_motion * c3;
    // m1_plus_m2_plus_m3*l0_q1_dot^2 + l2_q3_dot*m3_l2_q3_dot
    let energy_of_motion_3 = l2_q3_dot
        .mul_add(m3_l2_q3_dot, m1_plus_m2_plus_m3 * l0_q1_dot * l0_q1_dot);
    // q0'^2*(m0 + m1_plus_m2_plus_m3) + l1_q2_dot*m2_plus_m3_l1_q2_dot
    let energy_of_motion_4 = q0_dot * q0_dot * (m0 + m1_plus_m2_plus_m3)
        + l1_q2_dot * m2_plus_m3_l1_q2_dot;
    // energy_of_motion_3 + energy_of_motion_4
    let energy_of_motion_5 = energy_of_motion_3 + energy_of_motion_4;
    // Values.
    // T = q0'^2*(m0 + m1 + m2 + m3)/2 + l0^2*q1'^2*(m1 + m2 + m3)/2 - l0*q0'*q1'*cos(q1)*(m1 + m2 + m3) +
    //   l1^2*q2'^2*(m2 + m3)/2 - l1*q0'*q2'*cos(q2)*(m2 + m3) + l0*l1*q1'*q2'*cos(q1 - q2)*(m2 + m3) +
    //   m3*l2^2*q3'^2/2 - m3*l2*q0'*q3'*cos(q3) + m3*l0*l2*q1'*q3'*cos(q1 - q3) + m3*l1*l2*q2'*q3'*cos(q2 -
    //   q3)
    let energy = m2_plus_m3_l1_q2_dot * (-energy_of_motion).mul_add(c2, s1_l0_q1_dot * s2)
        - q0_dot * m1_plus_m2_plus_m3 * c1_l0_q1_dot
        + m3_l2_q3_dot * s1_l0_q1_dot.mul_add(s3_2, -energy_of_motion_2)
        + S::ratio(1, 2) * energy_of_motion_5;
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 0 operations.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 4],
    q_dot: &[S; 4],
) -> [S; 4] {
    let [q0_dot, q1_dot, q2_dot, q3_dot] = *q_dot;
    // Values.
    // u0 = q0'
    let u0_value = q0_dot;
    // u1 = q1'
    let u1_value = q1_dot;
    // u2 = q2'
    let u2_value = q2_dot;
    // u3 = q3'
    let u3_value = q3_dot;
    [u0_value, u1_value, u2_value, u3_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 0 operations.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 4],
    _q_dot: &[S; 4],
    v_dot: &[S; 4],
) -> [S; 4] {
    let [q0_ddot, q1_ddot, q2_ddot, q3_ddot] = *v_dot;
    // Values.
    // u0' = q0''
    let u0_dot_value = q0_ddot;
    // u1' = q1''
    let u1_dot_value = q1_ddot;
    // u2' = q2''
    let u2_dot_value = q2_ddot;
    // u3' = q3''
    let u3_dot_value = q3_ddot;
    [u0_dot_value, u1_dot_value, u2_dot_value, u3_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 0 operations.
#[must_use]
pub fn motion_variables<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 4],
    u: &[S; 4],
) -> [S; 4] {
    let [u0, u1, u2, u3] = *u;
    // Values.
    // q0' = u0
    let q0_dot_value = u0;
    // q1' = u1
    let q1_dot_value = u1;
    // q2' = u2
    let q2_dot_value = u2;
    // q3' = u3
    let q3_dot_value = u3;
    [q0_dot_value, q1_dot_value, q2_dot_value, q3_dot_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 126 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    q_dot: &[S; 4],
) -> ([S; 4], [S; 4]) {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [q0_dot, q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s3_2, c3) = q3.sin_cos();
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let m3_l2 = m3 * l2;
    // d1 = m3*l2^2
    let d1 = l2 * m3_l2;
    let d1_inv_m3_l2 = m3_l2 / d1;
    // l2_ = -m3*l2*cos(q3)/d1
    let l2_ = -d1_inv_m3_l2 * c3;
    // m2 + m3
    let m2_plus_m3 = m2 + m3;
    // m1 + m2_plus_m3
    let m1_plus_m2_plus_m3 = m1 + m2_plus_m3;
    let l2__m3_l2 = l2_ * m3_l2;
    // s3 = m0 + m1 + m2 + m3 + m3*l2*l2_*cos(q3)
    let s3 = l2__m3_l2.mul_add(c3, m0 + m1_plus_m2_plus_m3);
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let cos_q1_minus_q3 = c1.mul_add(c3, s1 * s3_2);
    let l0_cos_q1_minus_q3 = l0 * cos_q1_minus_q3;
    let l0_m1_plus_m2_plus_m3 = l0 * m1_plus_m2_plus_m3;
    // s4 = -l0*(cos(q1)*(m1 + m2 + m3) + m3*l2*l2_*cos(q1 - q3))
    let s4 = (-l0_m1_plus_m2_plus_m3).mul_add(c1, -l2__m3_l2 * l0_cos_q1_minus_q3);
    let l1_m2_plus_m3 = l1 * m2_plus_m3;
    // sin(q2)*sin(q3) + cos(q2)*cos(q3)
    let cos_q2_minus_q3 = c2.mul_add(c3, s2 * s3_2);
    let l1_cos_q2_minus_q3 = l1 * cos_q2_minus_q3;
    // s5 = -l1*(cos(q2)*(m2 + m3) + m3*l2*l2_*cos(q2 - q3))
    let s5 = (-l2__m3_l2).mul_add(l1_cos_q2_minus_q3, -l1_m2_plus_m3 * c2);
    let q1_dot_sq = q1_dot * q1_dot;
    // sin(q1)*cos(q3) - cos(q1)*sin(q3)
    let sin_q1_minus_q3 = (-c1).mul_add(s3_2, s1 * c3);
    let l0_sin_q1_minus_q3 = l0 * sin_q1_minus_q3;
    let q2_dot_sq = q2_dot * q2_dot;
    // sin(q2)*cos(q3) - cos(q2)*sin(q3)
    let sin_q2_minus_q3 = (-c2).mul_add(s3_2, s2 * c3);
    let l1_sin_q2_minus_q3 = l1 * sin_q2_minus_q3;
    // q1_dot_sq*l0_sin_q1_minus_q3 + q2_dot_sq*l1_sin_q2_minus_q3
    let r6_of_motion = q2_dot_sq
        .mul_add(l1_sin_q2_minus_q3, q1_dot_sq * l0_sin_q1_minus_q3);
    // g*sin(q3) + r6_of_motion
    let g_s3_2_plus_r6_of_motion = g.mul_add(s3_2, r6_of_motion);
    let q3_dot_sq_m3_l2 = q3_dot * q3_dot * m3_l2;
    let s2_l1_m2_plus_m3 = l1_m2_plus_m3 * s2;
    let s1_l0_m1_plus_m2_plus_m3 = l0_m1_plus_m2_plus_m3 * s1;
    // r6 = F - l0*q1'^2*sin(q1)*(m1 + m2 + m3) - l1*q2'^2*sin(q2)*(m2 + m3) - m3*l2*(q3'^2*sin(q3) +
    //   l2_*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)))
    let r6 = (-l2__m3_l2).mul_add(g_s3_2_plus_r6_of_motion, F) - q3_dot_sq_m3_l2 * s3_2
        - q2_dot_sq * s2_l1_m2_plus_m3 - q1_dot_sq * s1_l0_m1_plus_m2_plus_m3;
    // l7 = m3*l0*l2*cos(q1 - q3)/d1
    let l7 = d1_inv_m3_l2 * l0_cos_q1_minus_q3;
    let l7_m3_l2 = l7 * m3_l2;
    // s8 = l0*(l0*(m1 + m2 + m3) - m3*l2*l7*cos(q1 - q3))
    let s8 = (-l0_cos_q1_minus_q3).mul_add(l7_m3_l2, l0 * l0_m1_plus_m2_plus_m3);
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let cos_q1_minus_q2 = c1.mul_add(c2, s1 * s2);
    let l0_l1_m2_plus_m3 = l0 * l1_m2_plus_m3;
    // s9 = l1*(l0*cos(q1 - q2)*(m2 + m3) - m3*l2*l7*cos(q2 - q3))
    let s9 = (-l1_cos_q2_minus_q3).mul_add(l7_m3_l2, cos_q1_minus_q2 * l0_l1_m2_plus_m3);
    // sin(q1)*cos(q2) - cos(q1)*sin(q2)
    let sin_q1_minus_q2 = (-c1).mul_add(s2, s1 * c2);
    let r10_of_place = sin_q1_minus_q2 * l0_l1_m2_plus_m3;
    // r10 = l0*(g*sin(q1)*(m1 + m2 + m3) - l1*q2'^2*sin(q1 - q2)*(m2 + m3)) - m3*l2*(l0*q3'^2*sin(q1 - q3)
    //   + l7*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)))
    let r10 = (-l0_sin_q1_minus_q3)
        .mul_add(q3_dot_sq_m3_l2, g * s1_l0_m1_plus_m2_plus_m3)
        - g_s3_2_plus_r6_of_motion * l7_m3_l2 - q2_dot_sq * r10_of_place;
    // l11 = m3*l1*l2*cos(q2 - q3)/d1
    let l11 = d1_inv_m3_l2 * l1_cos_q2_minus_q3;
    let l11_m3_l2 = l11 * m3_l2;
    // s12 = l1*(l1*(m2 + m3) - m3*l2*l11*cos(q2 - q3))
    let s12 = (-l1_cos_q2_minus_q3).mul_add(l11_m3_l2, l1 * l1_m2_plus_m3);
    // r13 = l1*(m2 + m3)*(g*sin(q2) + l0*q1'^2*sin(q1 - q2)) - m3*l2*(l1*q3'^2*sin(q2 - q3) +
    //   l11*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)))
    let r13 = (-l1_sin_q2_minus_q3).mul_add(q3_dot_sq_m3_l2, g * s2_l1_m2_plus_m3)
        + q1_dot_sq * r10_of_place - g_s3_2_plus_r6_of_motion * l11_m3_l2;
    let s3_inv = S::int(1) / s3;
    // l14 = s4/s3
    let l14 = s4 * s3_inv;
    // s15 = s8 - s4*l14
    let s15 = (-s4).mul_add(l14, s8);
    // s16 = s9 - s5*l14
    let s16 = (-s5).mul_add(l14, s9);
    // r17 = r10 - r6*l14
    let r17 = (-r6).mul_add(l14, r10);
    // l18 = s5/s3
    let l18 = s5 * s3_inv;
    // s19 = s12 - s5*l18
    let s19 = (-s5).mul_add(l18, s12);
    // r20 = r13 - r6*l18
    let r20 = (-r6).mul_add(l18, r13);
    let s15_inv = S::int(1) / s15;
    // l21 = s16/s15
    let l21 = s16 * s15_inv;
    // s22 = s19 - s16*l21
    let s22 = (-s16).mul_add(l21, s19);
    // r23 = r20 - r17*l21
    let r23 = (-r17).mul_add(l21, r20);
    // q2'' = r23/s22
    let q2_ddot = r23 / s22;
    // q1'' = (r17 - q2''*s16)/s15
    let q1_ddot = (-q2_ddot).mul_add(l21, r17 * s15_inv);
    // q0'' = (r6 - q1''*s4 - q2''*s5)/s3
    let q0_ddot = (-q1_ddot).mul_add(l14, r6 * s3_inv) - q2_ddot * l18;
    // q3'' = m3*l2*(g*sin(q3) + q0''*cos(q3) + l0*(q1'^2*sin(q1 - q3) - q1''*cos(q1 - q3)) +
    //   l1*(q2'^2*sin(q2 - q3) - q2''*cos(q2 - q3)))/d1
    let q3_ddot = d1_inv_m3_l2 * q0_ddot.mul_add(c3, g_s3_2_plus_r6_of_motion)
        - q1_ddot * l7 - q2_ddot * l11;
    // Values.
    // q0'
    let q0_dot_value = q0_dot;
    // q1'
    let q1_dot_value = q1_dot;
    // q2'
    let q2_dot_value = q2_dot;
    // q3'
    let q3_dot_value = q3_dot;
    (
        [q0_dot_value, q1_dot_value, q2_dot_value, q3_dot_value],
        [q0_ddot, q1_ddot, q2_ddot, q3_ddot],
    )
}

/// Inverse dynamics: the generalized forces along (q0', q1', q2', q3') that must act beside the loads of the model for the accelerations to be (q0'', q1'', q2'', q3'').
///
/// 75 operations, 3 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    q_dot: &[S; 4],
    v_dot: &[S; 4],
) -> [S; 4] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, q1_dot, q2_dot, q3_dot] = *q_dot;
    let [q0_ddot, q1_ddot, q2_ddot, q3_ddot] = *v_dot;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    // m2 + m3
    let m2_plus_m3 = m2 + m3;
    // m1 + m2_plus_m3
    let m1_plus_m2_plus_m3 = m1 + m2_plus_m3;
    let q1_dot_sq = q1_dot * q1_dot;
    // q0'' + l0*(q1_dot_sq*sin(q1) - q1''*cos(q1))
    let tau1_of_motion = q0_ddot + l0 * (-q1_ddot).mul_add(c1, q1_dot_sq * s1);
    let m3_l2 = m3 * l2;
    let q3_dot_sq = q3_dot * q3_dot;
    // q3_dot_sq*sin(q3) - q3''*cos(q3)
    let tau1_of_motion_2 = (-q3_ddot).mul_add(c3, q3_dot_sq * s3_2);
    let q2_dot_sq = q2_dot * q2_dot;
    // q2_dot_sq*sin(q2) - q2''*cos(q2)
    let tau1_of_motion_3 = (-q2_ddot).mul_add(c2, q2_dot_sq * s2);
    let l1_m2_plus_m3 = l1 * m2_plus_m3;
    // m3_l2*tau1_of_motion_2 + tau1_of_motion_3*l1_m2_plus_m3
    let tau1_of_motion_4 = tau1_of_motion_3
        .mul_add(l1_m2_plus_m3, m3_l2 * tau1_of_motion_2);
    // q2''*sin(q2) + q2_dot_sq*cos(q2)
    let tau2_of_motion = q2_dot_sq.mul_add(c2, q2_ddot * s2);
    // q3''*sin(q3) + q3_dot_sq*cos(q3)
    let tau2_of_motion_2 = q3_dot_sq.mul_add(c3, q3_ddot * s3_2);
    // g*m1_plus_m2_plus_m3 - m3_l2*tau2_of_motion_2
    let tau2_of_motion_3 = (-m3_l2).mul_add(tau2_of_motion_2, g * m1_plus_m2_plus_m3);
    let l1_m3_l2 = l1 * m3_l2;
    // l0*(q1''*sin(q1) + q1_dot_sq*cos(q1)) - g
    let tau3_of_motion = l0 * q1_dot_sq.mul_add(c1, q1_ddot * s1) - g;
    // l1*q2'' - tau1_of_motion*cos(q2)
    let tau3_of_motion_2 = (-tau1_of_motion).mul_add(c2, l1 * q2_ddot);
    // l2*q3'' - tau1_of_motion*cos(q3)
    let tau4_of_motion = (-tau1_of_motion).mul_add(c3, l2 * q3_ddot);
    // Values.
    // tau1 = l0*q1'^2*sin(q1)*(m1 + m2 + m3) - F + l1*q2'^2*sin(q2)*(m2 + m3) + m3*l2*q3'^2*sin(q3) +
    //   q0''*(m0 + m1 + m2 + m3) - l0*q1''*cos(q1)*(m1 + m2 + m3) - l1*q2''*cos(q2)*(m2 + m3) -
    //   m3*l2*q3''*cos(q3)
    let tau1 = m0.mul_add(q0_ddot, -F) + m1_plus_m2_plus_m3 * tau1_of_motion + tau1_of_motion_4;
    // tau2 = l0*(l1*q2'^2*sin(q1 - q2)*(m2 + m3) - g*sin(q1)*(m1 + m2 + m3) + m3*l2*q3'^2*sin(q1 - q3)) -
    //   l0*q0''*cos(q1)*(m1 + m2 + m3) + l0^2*q1''*(m1 + m2 + m3) + l0*l1*q2''*cos(q1 - q2)*(m2 + m3) +
    //   m3*l0*l2*q3''*cos(q1 - q3)
    let tau2 = l0 * s1 * l1_m2_plus_m3.mul_add(tau2_of_motion, -tau2_of_motion_3)
        - l0
            * (m1_plus_m2_plus_m3 * (-l0).mul_add(q1_ddot, q0_ddot * c1) + tau1_of_motion_4 * c1);
    // tau3 = l1*(m3*l2*q3'^2*sin(q2 - q3) - (m2 + m3)*(g*sin(q2) + l0*q1'^2*sin(q1 - q2))) -
    //   l1*q0''*cos(q2)*(m2 + m3) + l0*l1*q1''*cos(q1 - q2)*(m2 + m3) + l1^2*q2''*(m2 + m3) +
    //   m3*l1*l2*q3''*cos(q2 - q3)
    let tau3 = l1_m3_l2 * (-tau1_of_motion_2).mul_add(c2, tau2_of_motion_2 * s2)
        + l1_m2_plus_m3 * tau3_of_motion.mul_add(s2, tau3_of_motion_2);
    // tau4 = m3*l0*l2*q1''*cos(q1 - q3) - m3*l2*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 -
    //   q3)) - m3*l2*q0''*cos(q3) + m3*l1*l2*q2''*cos(q2 - q3) + m3*l2^2*q3''
    let tau4 = l1_m3_l2 * (-tau1_of_motion_3).mul_add(c3, tau2_of_motion * s3_2)
        + m3_l2 * tau3_of_motion.mul_add(s3_2, tau4_of_motion);
    [tau1, tau2, tau3, tau4]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    q_dot: &[S; 4],
    direction: &[S; 8],
) -> [S; 8] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: q_dot[i],
        slope: direction[4 + i],
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
            parameters: 9,
            coordinates: 4,
            variables: 4,
            speeds: 4,
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
