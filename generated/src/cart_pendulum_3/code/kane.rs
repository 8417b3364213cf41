//! Three-link pendulum on a cart: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/cart_pendulum_3/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u0, u1, u2, u3.
///
/// 30 operations, 3 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    _u: &[S; 4],
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

/// Right-hand side of the linear system; unknowns (u0', u1', u2', u3').
///
/// 45 operations, 3 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [S; 4] {
    let Parameters { m1, m2, m3, l0, l1, l2, g, F, .. } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, u1, u2, u3] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    let m3_l2 = m3 * l2;
    let u3_sq_m3_l2 = u3 * u3 * m3_l2;
    let l0_u1_sq = l0 * u1 * u1;
    // m2 + m3
    let m2_plus_m3 = m2 + m3;
    // sin(q1)*(m1 + m2_plus_m3)
    let f1_of_m1_m2_m3_q1 = s1 * (m1 + m2_plus_m3);
    let l1_u2_sq = l1 * u2 * u2;
    let m2_plus_m3_l1_u2_sq = m2_plus_m3 * l1_u2_sq;
    // sin(q1)*cos(q3) - cos(q1)*sin(q3)
    let sin_q1_minus_q3 = (-c1).mul_add(s3_2, s1 * c3);
    // sin(q1)*cos(q2) - cos(q1)*sin(q2)
    let sin_q1_minus_q2 = (-c1).mul_add(s2, s1 * c2);
    // sin(q2)*cos(q3) - cos(q2)*sin(q3)
    let sin_q2_minus_q3 = (-c2).mul_add(s3_2, s2 * c3);
    // Values.
    // f1 = F - l0*u1^2*sin(q1)*(m1 + m2 + m3) - l1*u2^2*sin(q2)*(m2 + m3) - m3*l2*u3^2*sin(q3)
    let f1 = (-u3_sq_m3_l2).mul_add(s3_2, F) - l0_u1_sq * f1_of_m1_m2_m3_q1
        - m2_plus_m3_l1_u2_sq * s2;
    // f2 = l0*(g*sin(q1)*(m1 + m2 + m3) - l1*u2^2*sin(q1 - q2)*(m2 + m3) - m3*l2*u3^2*sin(q1 - q3))
    let f2 = l0
        * ((-sin_q1_minus_q3).mul_add(u3_sq_m3_l2, g * f1_of_m1_m2_m3_q1)
            - sin_q1_minus_q2 * m2_plus_m3_l1_u2_sq);
    // f3 = l1*((m2 + m3)*(g*sin(q2) + l0*u1^2*sin(q1 - q2)) - m3*l2*u3^2*sin(q2 - q3))
    let f3 = l1
        * (m2_plus_m3 * sin_q1_minus_q2.mul_add(l0_u1_sq, g * s2) - sin_q2_minus_q3 * u3_sq_m3_l2);
    // f4 = m3*l2*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3))
    let f4 = m3_l2 * (sin_q1_minus_q3.mul_add(l0_u1_sq, g * s3_2) + sin_q2_minus_q3 * l1_u2_sq);
    [f1, f2, f3, f4]
}

/// The accelerations (u0', u1', u2', u3'), solved for when this code was generated.
///
/// 126 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [S; 4] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, u1, u2, u3] = *u;
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
    let u1_sq = u1 * u1;
    // sin(q1)*cos(q3) - cos(q1)*sin(q3)
    let sin_q1_minus_q3 = (-c1).mul_add(s3_2, s1 * c3);
    let l0_sin_q1_minus_q3 = l0 * sin_q1_minus_q3;
    let u2_sq = u2 * u2;
    // sin(q2)*cos(q3) - cos(q2)*sin(q3)
    let sin_q2_minus_q3 = (-c2).mul_add(s3_2, s2 * c3);
    let l1_sin_q2_minus_q3 = l1 * sin_q2_minus_q3;
    // u1_sq*l0_sin_q1_minus_q3 + u2_sq*l1_sin_q2_minus_q3
    let r6_of_u1_u2 = u2_sq.mul_add(l1_sin_q2_minus_q3, u1_sq * l0_sin_q1_minus_q3);
    // g*sin(q3) + r6_of_u1_u2
    let g_s3_2_plus_r6_of_u1_u2 = g.mul_add(s3_2, r6_of_u1_u2);
    let u3_sq_m3_l2 = u3 * u3 * m3_l2;
    let s2_l1_m2_plus_m3 = l1_m2_plus_m3 * s2;
    let s1_l0_m1_plus_m2_plus_m3 = l0_m1_plus_m2_plus_m3 * s1;
    // r6 = F - l0*u1^2*sin(q1)*(m1 + m2 + m3) - l1*u2^2*sin(q2)*(m2 + m3) - m3*l2*(u3^2*sin(q3) +
    //   l2_*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r6 = (-l2__m3_l2).mul_add(g_s3_2_plus_r6_of_u1_u2, F) - u3_sq_m3_l2 * s3_2
        - u2_sq * s2_l1_m2_plus_m3 - u1_sq * s1_l0_m1_plus_m2_plus_m3;
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
    // r10 = l0*(g*sin(q1)*(m1 + m2 + m3) - l1*u2^2*sin(q1 - q2)*(m2 + m3)) - m3*l2*(l0*u3^2*sin(q1 - q3) +
    //   l7*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r10 = (-l0_sin_q1_minus_q3).mul_add(u3_sq_m3_l2, g * s1_l0_m1_plus_m2_plus_m3)
        - g_s3_2_plus_r6_of_u1_u2 * l7_m3_l2 - u2_sq * r10_of_place;
    // l11 = m3*l1*l2*cos(q2 - q3)/d1
    let l11 = d1_inv_m3_l2 * l1_cos_q2_minus_q3;
    let l11_m3_l2 = l11 * m3_l2;
    // s12 = l1*(l1*(m2 + m3) - m3*l2*l11*cos(q2 - q3))
    let s12 = (-l1_cos_q2_minus_q3).mul_add(l11_m3_l2, l1 * l1_m2_plus_m3);
    // r13 = l1*(m2 + m3)*(g*sin(q2) + l0*u1^2*sin(q1 - q2)) - m3*l2*(l1*u3^2*sin(q2 - q3) + l11*(g*sin(q3)
    //   + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r13 = (-l1_sin_q2_minus_q3).mul_add(u3_sq_m3_l2, g * s2_l1_m2_plus_m3)
        + u1_sq * r10_of_place - g_s3_2_plus_r6_of_u1_u2 * l11_m3_l2;
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
    // u2' = r23/s22
    let u2_dot = r23 / s22;
    // u1' = (r17 - u2'*s16)/s15
    let u1_dot = (-u2_dot).mul_add(l21, r17 * s15_inv);
    // u0' = (r6 - u1'*s4 - u2'*s5)/s3
    let u0_dot = (-u1_dot).mul_add(l14, r6 * s3_inv) - u2_dot * l18;
    // u3' = m3*l2*(g*sin(q3) + u0'*cos(q3) + l0*(u1^2*sin(q1 - q3) - u1'*cos(q1 - q3)) + l1*(u2^2*sin(q2 -
    //   q3) - u2'*cos(q2 - q3)))/d1
    let u3_dot = d1_inv_m3_l2 * u0_dot.mul_add(c3, g_s3_2_plus_r6_of_u1_u2) - u1_dot * l7
        - u2_dot * l11;
    [u0_dot, u1_dot, u2_dot, u3_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
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

/// Kinetic energy T.
///
/// 39 operations, 3 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> S {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, .. } = *p;
    let [_, q1, q2, q3] = *q;
    let [u0, u1, u2, u3] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    // Shared terms.
    // m2 + m3
    let m2_plus_m3 = m2 + m3;
    // m1 + m2_plus_m3
    let m1_plus_m2_plus_m3 = m1 + m2_plus_m3;
    let l0_u1 = l0 * u1;
    let c1_l0_u1 = l0_u1 * c1;
    // u0 - c1_l0_u1
    let u0_minus_c1_l0_u1 = u0 - c1_l0_u1;
    let s1_l0_u1 = l0_u1 * s1;
    let l1_u2 = l1 * u2;
    let m2_plus_m3_l1_u2 = m2_plus_m3 * l1_u2;
    let l2_u3 = l2 * u3;
    let m3_l2_u3 = m3 * l2_u3;
    // u0_minus_c1_l0_u1*cos(q3) - l1_u2*(sin(q2)*sin(q3) + cos(q2)*cos(q3))
    let energy_of_u0_u1_u2 = -l1_u2 * c2.mul_add(c3, s2 * s3_2) + u0_minus_c1_l0_u1 * c3;
    // m1_plus_m2_plus_m3*l0_u1^2 + l2_u3*m3_l2_u3
    let energy_of_u1_u3 = l2_u3.mul_add(m3_l2_u3, m1_plus_m2_plus_m3 * l0_u1 * l0_u1);
    // u0^2*(m0 + m1_plus_m2_plus_m3) + l1_u2*m2_plus_m3_l1_u2
    let energy_of_u0_u2 = u0 * u0 * (m0 + m1_plus_m2_plus_m3) + l1_u2 * m2_plus_m3_l1_u2;
    // energy_of_u1_u3 + energy_of_u0_u2
    let energy_of_u0_u1_u2_u3 = energy_of_u1_u3 + energy_of_u0_u2;
    // Values.
    // T = u0^2*(m0 + m1 + m2 + m3)/2 + l0^2*u1^2*(m1 + m2 + m3)/2 - l0*u0*u1*cos(q1)*(m1 + m2 + m3) +
    //   l1^2*u2^2*(m2 + m3)/2 - l1*u0*u2*cos(q2)*(m2 + m3) + l0*l1*u1*u2*cos(q1 - q2)*(m2 + m3) +
    //   m3*l2^2*u3^2/2 - m3*l2*u0*u3*cos(q3) + m3*l0*l2*u1*u3*cos(q1 - q3) + m3*l1*l2*u2*u3*cos(q2 - q3)
    let energy = m2_plus_m3_l1_u2 * (-u0_minus_c1_l0_u1).mul_add(c2, s1_l0_u1 * s2)
        - u0 * m1_plus_m2_plus_m3 * c1_l0_u1
        + m3_l2_u3 * s1_l0_u1.mul_add(s3_2, -energy_of_u0_u1_u2)
        + S::ratio(1, 2) * energy_of_u0_u1_u2_u3;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 13 operations, 3 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 4]) -> S {
    let Parameters { m1, m2, m3, l0, l1, l2, g, F, .. } = *p;
    let [q0, q1, q2, q3] = *q;
    // Sines and cosines.
    let (_, c1) = q1.sin_cos();
    let (_, c2) = q2.sin_cos();
    let (_, c3) = q3.sin_cos();
    // Shared terms.
    // m2 + m3
    let m2_plus_m3 = m2 + m3;
    // Values.
    // V = g*(l0*cos(q1)*(m1 + m2 + m3) + l1*cos(q2)*(m2 + m3) + m3*l2*cos(q3)) - F*q0
    let energy = g * (m3 * l2 * c3 + l1 * m2_plus_m3 * c2 + l0 * c1 * (m1 + m2_plus_m3)) - F * q0;
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 126 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    u: &[S; 4],
) -> ([S; 4], [S; 4]) {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [u0, u1, u2, u3] = *u;
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
    let u1_sq = u1 * u1;
    // sin(q1)*cos(q3) - cos(q1)*sin(q3)
    let sin_q1_minus_q3 = (-c1).mul_add(s3_2, s1 * c3);
    let l0_sin_q1_minus_q3 = l0 * sin_q1_minus_q3;
    let u2_sq = u2 * u2;
    // sin(q2)*cos(q3) - cos(q2)*sin(q3)
    let sin_q2_minus_q3 = (-c2).mul_add(s3_2, s2 * c3);
    let l1_sin_q2_minus_q3 = l1 * sin_q2_minus_q3;
    // u1_sq*l0_sin_q1_minus_q3 + u2_sq*l1_sin_q2_minus_q3
    let r6_of_u1_u2 = u2_sq.mul_add(l1_sin_q2_minus_q3, u1_sq * l0_sin_q1_minus_q3);
    // g*sin(q3) + r6_of_u1_u2
    let g_s3_2_plus_r6_of_u1_u2 = g.mul_add(s3_2, r6_of_u1_u2);
    let u3_sq_m3_l2 = u3 * u3 * m3_l2;
    let s2_l1_m2_plus_m3 = l1_m2_plus_m3 * s2;
    let s1_l0_m1_plus_m2_plus_m3 = l0_m1_plus_m2_plus_m3 * s1;
    // r6 = F - l0*u1^2*sin(q1)*(m1 + m2 + m3) - l1*u2^2*sin(q2)*(m2 + m3) - m3*l2*(u3^2*sin(q3) +
    //   l2_*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r6 = (-l2__m3_l2).mul_add(g_s3_2_plus_r6_of_u1_u2, F) - u3_sq_m3_l2 * s3_2
        - u2_sq * s2_l1_m2_plus_m3 - u1_sq * s1_l0_m1_plus_m2_plus_m3;
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
    // r10 = l0*(g*sin(q1)*(m1 + m2 + m3) - l1*u2^2*sin(q1 - q2)*(m2 + m3)) - m3*l2*(l0*u3^2*sin(q1 - q3) +
    //   l7*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r10 = (-l0_sin_q1_minus_q3).mul_add(u3_sq_m3_l2, g * s1_l0_m1_plus_m2_plus_m3)
        - g_s3_2_plus_r6_of_u1_u2 * l7_m3_l2 - u2_sq * r10_of_place;
    // l11 = m3*l1*l2*cos(q2 - q3)/d1
    let l11 = d1_inv_m3_l2 * l1_cos_q2_minus_q3;
    let l11_m3_l2 = l11 * m3_l2;
    // s12 = l1*(l1*(m2 + m3) - m3*l2*l11*cos(q2 - q3))
    let s12 = (-l1_cos_q2_minus_q3).mul_add(l11_m3_l2, l1 * l1_m2_plus_m3);
    // r13 = l1*(m2 + m3)*(g*sin(q2) + l0*u1^2*sin(q1 - q2)) - m3*l2*(l1*u3^2*sin(q2 - q3) + l11*(g*sin(q3)
    //   + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r13 = (-l1_sin_q2_minus_q3).mul_add(u3_sq_m3_l2, g * s2_l1_m2_plus_m3)
        + u1_sq * r10_of_place - g_s3_2_plus_r6_of_u1_u2 * l11_m3_l2;
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
    // u2' = r23/s22
    let u2_dot = r23 / s22;
    // u1' = (r17 - u2'*s16)/s15
    let u1_dot = (-u2_dot).mul_add(l21, r17 * s15_inv);
    // u0' = (r6 - u1'*s4 - u2'*s5)/s3
    let u0_dot = (-u1_dot).mul_add(l14, r6 * s3_inv) - u2_dot * l18;
    // u3' = m3*l2*(g*sin(q3) + u0'*cos(q3) + l0*(u1^2*sin(q1 - q3) - u1'*cos(q1 - q3)) + l1*(u2^2*sin(q2 -
    //   q3) - u2'*cos(q2 - q3)))/d1
    let u3_dot = d1_inv_m3_l2 * u0_dot.mul_add(c3, g_s3_2_plus_r6_of_u1_u2) - u1_dot * l7
        - u2_dot * l11;
    // Values.
    // q0' = u0
    let q0_dot_value = u0;
    // q1' = u1
    let q1_dot_value = u1;
    // q2' = u2
    let q2_dot_value = u2;
    // q3' = u3
    let q3_dot_value = u3;
    (
        [q0_dot_value, q1_dot_value, q2_dot_value, q3_dot_value],
        [u0_dot, u1_dot, u2_dot, u3_dot],
    )
}

/// Jacobian of the derivative by the state; columns q0, q1, q2, q3, u0, u1, u2, u3.
///
/// 474 operations, 3 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [[S; 8]; 8] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, u1, u2, u3] = *u;
    // Sines and cosines.
    let (s3_2, c3) = q3.sin_cos();
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let m3_l2 = m3 * l2;
    // d1 = m3*l2^2
    let d1 = l2 * m3_l2;
    let d1_inv_m3_l2 = m3_l2 / d1;
    let c3_d1_inv_m3_l2 = d1_inv_m3_l2 * c3;
    // l2_ = -m3*l2*cos(q3)/d1
    let l2_ = -c3_d1_inv_m3_l2;
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
    let c1_l0_m1_plus_m2_plus_m3 = l0_m1_plus_m2_plus_m3 * c1;
    // l2__m3_l2*l0_cos_q1_minus_q3 + c1_l0_m1_plus_m2_plus_m3
    let s4_of_place = l2__m3_l2.mul_add(l0_cos_q1_minus_q3, c1_l0_m1_plus_m2_plus_m3);
    // s4 = -l0*(cos(q1)*(m1 + m2 + m3) + m3*l2*l2_*cos(q1 - q3))
    let s4 = -s4_of_place;
    // sin(q2)*sin(q3) + cos(q2)*cos(q3)
    let cos_q2_minus_q3 = c2.mul_add(c3, s2 * s3_2);
    let l1_cos_q2_minus_q3 = l1 * cos_q2_minus_q3;
    let l1_m2_plus_m3 = l1 * m2_plus_m3;
    let c2_l1_m2_plus_m3 = l1_m2_plus_m3 * c2;
    // l2__m3_l2*l1_cos_q2_minus_q3 + c2_l1_m2_plus_m3
    let s5_of_place = l2__m3_l2.mul_add(l1_cos_q2_minus_q3, c2_l1_m2_plus_m3);
    // s5 = -l1*(cos(q2)*(m2 + m3) + m3*l2*l2_*cos(q2 - q3))
    let s5 = -s5_of_place;
    // sin(q1)*cos(q3) - cos(q1)*sin(q3)
    let sin_q1_minus_q3 = (-c1).mul_add(s3_2, s1 * c3);
    let l0_sin_q1_minus_q3 = l0 * sin_q1_minus_q3;
    let u1_sq = u1 * u1;
    // sin(q2)*cos(q3) - cos(q2)*sin(q3)
    let sin_q2_minus_q3 = (-c2).mul_add(s3_2, s2 * c3);
    let l1_sin_q2_minus_q3 = l1 * sin_q2_minus_q3;
    let u2_sq = u2 * u2;
    // l0_sin_q1_minus_q3*u1_sq + l1_sin_q2_minus_q3*u2_sq
    let r6_of_u1_u2 = l1_sin_q2_minus_q3.mul_add(u2_sq, l0_sin_q1_minus_q3 * u1_sq);
    // g*sin(q3) + r6_of_u1_u2
    let g_s3_2_plus_r6_of_u1_u2 = g.mul_add(s3_2, r6_of_u1_u2);
    let u3_m3_l2 = u3 * m3_l2;
    let u3_u3_m3_l2 = u3 * u3_m3_l2;
    let s2_l1_m2_plus_m3 = l1_m2_plus_m3 * s2;
    let s1_l0_m1_plus_m2_plus_m3 = l0_m1_plus_m2_plus_m3 * s1;
    // r6 = F - l0*u1^2*sin(q1)*(m1 + m2 + m3) - l1*u2^2*sin(q2)*(m2 + m3) - m3*l2*(u3^2*sin(q3) +
    //   l2_*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r6 = (-l2__m3_l2).mul_add(g_s3_2_plus_r6_of_u1_u2, F) - u3_u3_m3_l2 * s3_2
        - u2_sq * s2_l1_m2_plus_m3 - u1_sq * s1_l0_m1_plus_m2_plus_m3;
    // l7 = m3*l0*l2*cos(q1 - q3)/d1
    let l7 = d1_inv_m3_l2 * l0_cos_q1_minus_q3;
    let l7_m3_l2 = l7 * m3_l2;
    // s8 = l0*(l0*(m1 + m2 + m3) - m3*l2*l7*cos(q1 - q3))
    let s8 = (-l0_cos_q1_minus_q3).mul_add(l7_m3_l2, l0 * l0_m1_plus_m2_plus_m3);
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let cos_q1_minus_q2 = c1.mul_add(c2, s1 * s2);
    let l0_l1_m2_plus_m3 = l0 * l1_m2_plus_m3;
    let s9_of_place = cos_q1_minus_q2 * l0_l1_m2_plus_m3;
    // l1_cos_q2_minus_q3*l7_m3_l2 - s9_of_place
    let s9_of_place_2 = l1_cos_q2_minus_q3.mul_add(l7_m3_l2, -s9_of_place);
    // s9 = l1*(l0*cos(q1 - q2)*(m2 + m3) - m3*l2*l7*cos(q2 - q3))
    let s9 = -s9_of_place_2;
    // sin(q1)*cos(q2) - cos(q1)*sin(q2)
    let sin_q1_minus_q2 = (-c1).mul_add(s2, s1 * c2);
    let r10_of_place = sin_q1_minus_q2 * l0_l1_m2_plus_m3;
    // r10 = l0*(g*sin(q1)*(m1 + m2 + m3) - l1*u2^2*sin(q1 - q2)*(m2 + m3)) - m3*l2*(l0*u3^2*sin(q1 - q3) +
    //   l7*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r10 = (-l0_sin_q1_minus_q3).mul_add(u3_u3_m3_l2, g * s1_l0_m1_plus_m2_plus_m3)
        - g_s3_2_plus_r6_of_u1_u2 * l7_m3_l2 - u2_sq * r10_of_place;
    // l11 = m3*l1*l2*cos(q2 - q3)/d1
    let l11 = d1_inv_m3_l2 * l1_cos_q2_minus_q3;
    let l11_m3_l2 = l11 * m3_l2;
    // s12 = l1*(l1*(m2 + m3) - m3*l2*l11*cos(q2 - q3))
    let s12 = (-l1_cos_q2_minus_q3).mul_add(l11_m3_l2, l1 * l1_m2_plus_m3);
    // r13 = l1*(m2 + m3)*(g*sin(q2) + l0*u1^2*sin(q1 - q2)) - m3*l2*(l1*u3^2*sin(q2 - q3) + l11*(g*sin(q3)
    //   + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r13 = (-l1_sin_q2_minus_q3).mul_add(u3_u3_m3_l2, g * s2_l1_m2_plus_m3)
        + u1_sq * r10_of_place - g_s3_2_plus_r6_of_u1_u2 * l11_m3_l2;
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
    let s22_inv = S::int(1) / s22;
    // u2' = r23/s22
    let u2_dot = r23 * s22_inv;
    let r17_s15_inv = r17 * s15_inv;
    // u1' = (r17 - u2'*s16)/s15
    let u1_dot = (-u2_dot).mul_add(l21, r17_s15_inv);
    let r6_s3_inv = r6 * s3_inv;
    // r6_s3_inv - u2'*l18
    let u0_dot_of_u2_dot = (-u2_dot).mul_add(l18, r6_s3_inv);
    // u0' = (r6 - u1'*s4 - u2'*s5)/s3
    let u0_dot = (-u1_dot).mul_add(l14, u0_dot_of_u2_dot);
    let s4_by_q1_of_place = l2__m3_l2 * l0_sin_q1_minus_q3;
    // s4_by_q1 = l0*(sin(q1)*(m1 + m2 + m3) + m3*l2*l2_*sin(q1 - q3))
    let s4_by_q1 = s1_l0_m1_plus_m2_plus_m3 + s4_by_q1_of_place;
    // r6_by_q1 = -l0*u1^2*(cos(q1)*(m1 + m2 + m3) + m3*l2*l2_*cos(q1 - q3))
    let r6_by_q1 = -s4_of_place * u1_sq;
    // l7_by_q3 = m3*l0*l2*sin(q1 - q3)/d1
    let l7_by_q3 = d1_inv_m3_l2 * l0_sin_q1_minus_q3;
    // l7_by_q1 = -m3*l0*l2*sin(q1 - q3)/d1
    let l7_by_q1 = -l7_by_q3;
    let m3_l2_l0_cos_q1_minus_q3 = m3_l2 * l0_cos_q1_minus_q3;
    let s8_by_q1_of_place = l0_sin_q1_minus_q3 * l7_m3_l2;
    // s8_by_q1 = m3*l0*l2*(l7*sin(q1 - q3) - l7_by_q1*cos(q1 - q3))
    let s8_by_q1 = (-l7_by_q1).mul_add(m3_l2_l0_cos_q1_minus_q3, s8_by_q1_of_place);
    let m3_l2_l1_cos_q2_minus_q3 = m3_l2 * l1_cos_q2_minus_q3;
    // s9_by_q1 = -l1*(l0*sin(q1 - q2)*(m2 + m3) + m3*l2*l7_by_q1*cos(q2 - q3))
    let s9_by_q1 = (-l7_by_q1).mul_add(m3_l2_l1_cos_q2_minus_q3, -r10_of_place);
    let r10_by_q1_of_u1_u2 = m3_l2 * g_s3_2_plus_r6_of_u1_u2;
    let l0_cos_q1_minus_q3_u1_sq = l0_cos_q1_minus_q3 * u1_sq;
    let r10_by_q1_of_u3 = l0_cos_q1_minus_q3 * u3_u3_m3_l2;
    // r10_by_q1 = l0*(g*cos(q1)*(m1 + m2 + m3) - l1*u2^2*cos(q1 - q2)*(m2 + m3)) -
    //   m3*l2*(l7_by_q1*(g*sin(q3) + l1*u2^2*sin(q2 - q3)) + l0*(u3^2*cos(q1 - q3) + u1^2*(l7*cos(q1 - q3) +
    //   l7_by_q1*sin(q1 - q3))))
    let r10_by_q1 = (-u2_sq).mul_add(s9_of_place, g * c1_l0_m1_plus_m2_plus_m3)
        - l7_by_q1 * r10_by_q1_of_u1_u2 - l7_m3_l2 * l0_cos_q1_minus_q3_u1_sq - r10_by_q1_of_u3;
    let u1_sq_s9_of_place = u1_sq * s9_of_place;
    // r13_by_q1 = l0*u1^2*(l1*cos(q1 - q2)*(m2 + m3) - m3*l2*l11*cos(q1 - q3))
    let r13_by_q1 = (-l11_m3_l2).mul_add(l0_cos_q1_minus_q3_u1_sq, u1_sq_s9_of_place);
    let l14_s15_inv = l14 * s15_inv;
    let l21_s4_by_q1 = l21 * s4_by_q1;
    // l14*l21 - l18
    let minus_l18_plus_l14_l21 = l14.mul_add(l21, -l18);
    let s4_by_q1_s15_inv = s4_by_q1 * s15_inv;
    let s8_by_q1_s15_inv = s8_by_q1 * s15_inv;
    // l21_by_q1 = (s16*(s4_by_q1*(s4/s3 + l14) - s8_by_q1)/s15 - s5*s4_by_q1/s3 + s9_by_q1)/s15
    let l21_by_q1 = l14_s15_inv.mul_add(l21_s4_by_q1, s9_by_q1 * s15_inv)
        + minus_l18_plus_l14_l21 * s4_by_q1_s15_inv - l21 * s8_by_q1_s15_inv;
    // s22_by_q1 = l21*(s5*s4_by_q1/s3 - s9_by_q1) - s16*l21_by_q1
    let s22_by_q1 = (-l21).mul_add(s9_by_q1, l18 * l21_s4_by_q1) - s16 * l21_by_q1;
    // r23_by_q1 = l21*(r6*s4_by_q1/s3 - r10_by_q1 + l14*r6_by_q1) - l18*r6_by_q1 + r13_by_q1 -
    //   r17*l21_by_q1
    let r23_by_q1 = (-l21).mul_add(r10_by_q1, r13_by_q1) - r17 * l21_by_q1
        + r6_s3_inv * l21_s4_by_q1 + r6_by_q1 * minus_l18_plus_l14_l21;
    // u2'*s22_by_q1 - r23_by_q1
    let u1_dot_by_q1_of_u2_dot = u2_dot.mul_add(s22_by_q1, -r23_by_q1);
    let l21_s22_inv = l21 * s22_inv;
    let u2_dot_s15_inv = u2_dot * s15_inv;
    // u1_dot_by_q1 = (u2'*s16 - r17)*(s8_by_q1 - s4_by_q1*(s4/s3 + l14))/s15^2 + (u2'*(s5*s4_by_q1/s3 -
    //   s9_by_q1) - r6*s4_by_q1/s3 - l14*r6_by_q1 + r10_by_q1 + s16*(r23*s22_by_q1/s22 - r23_by_q1)/s22)/s15
    let u1_dot_by_q1 = l14_s15_inv * (u1_dot * s4_by_q1).mul_add(S::int(2), -r6_by_q1)
        + r10_by_q1 * s15_inv - u0_dot_of_u2_dot * s4_by_q1_s15_inv
        - u1_dot * s8_by_q1_s15_inv + u1_dot_by_q1_of_u2_dot * l21_s22_inv
        - s9_by_q1 * u2_dot_s15_inv;
    let l18_s22_inv = l18 * s22_inv;
    let u1_dot_s3_inv = u1_dot * s3_inv;
    // u0_dot_by_q1 = (r6_by_q1 - u1'*s4_by_q1 + s5*(r23*s22_by_q1/s22 - r23_by_q1)/s22 -
    //   s4*u1_dot_by_q1)/s3
    let u0_dot_by_q1 = (-l14).mul_add(u1_dot_by_q1, r6_by_q1 * s3_inv)
        + u1_dot_by_q1_of_u2_dot * l18_s22_inv - s4_by_q1 * u1_dot_s3_inv;
    let l11_s22_inv = l11 * s22_inv;
    let u1_dot_l7_by_q3 = u1_dot * l7_by_q3;
    // u3_dot_by_q1 = m3*l2*(l0*(u1'*sin(q1 - q3) + cos(q1 - q3)*(u1^2 - u1_dot_by_q1)) - l1*cos(q2 -
    //   q3)*(r23_by_q1 - r23*s22_by_q1/s22)/s22 + u0_dot_by_q1*cos(q3))/d1
    let u3_dot_by_q1 = l7 * (u1_sq - u1_dot_by_q1) + u0_dot_by_q1 * c3_d1_inv_m3_l2
        + u1_dot_by_q1_of_u2_dot * l11_s22_inv + u1_dot_l7_by_q3;
    let s5_by_q2_of_place = l2__m3_l2 * l1_sin_q2_minus_q3;
    // s5_by_q2 = l1*(sin(q2)*(m2 + m3) + m3*l2*l2_*sin(q2 - q3))
    let s5_by_q2 = s2_l1_m2_plus_m3 + s5_by_q2_of_place;
    // r6_by_q2 = -l1*u2^2*(cos(q2)*(m2 + m3) + m3*l2*l2_*cos(q2 - q3))
    let r6_by_q2 = -s5_of_place * u2_sq;
    let s9_by_q2_of_place = l1_sin_q2_minus_q3 * l7_m3_l2;
    // s9_by_q2 = l1*(l0*sin(q1 - q2)*(m2 + m3) + m3*l2*l7*sin(q2 - q3))
    let s9_by_q2 = r10_of_place + s9_by_q2_of_place;
    // r10_by_q2 = l1*u2^2*(l0*cos(q1 - q2)*(m2 + m3) - m3*l2*l7*cos(q2 - q3))
    let r10_by_q2 = -u2_sq * s9_of_place_2;
    // l11_by_q3 = m3*l1*l2*sin(q2 - q3)/d1
    let l11_by_q3 = d1_inv_m3_l2 * l1_sin_q2_minus_q3;
    // l11_by_q2 = -m3*l1*l2*sin(q2 - q3)/d1
    let l11_by_q2 = -l11_by_q3;
    let s12_by_q2_of_place = l1_sin_q2_minus_q3 * l11_m3_l2;
    // s12_by_q2 = m3*l1*l2*(l11*sin(q2 - q3) - l11_by_q2*cos(q2 - q3))
    let s12_by_q2 = (-l11_by_q2).mul_add(m3_l2_l1_cos_q2_minus_q3, s12_by_q2_of_place);
    let l1_cos_q2_minus_q3_u2_sq = l1_cos_q2_minus_q3 * u2_sq;
    let r13_by_q2_of_u3 = l1_cos_q2_minus_q3 * u3_u3_m3_l2;
    // r13_by_q2 = l1*(m2 + m3)*(g*cos(q2) - l0*u1^2*cos(q1 - q2)) - m3*l2*(l11_by_q2*(g*sin(q3) +
    //   l0*u1^2*sin(q1 - q3)) + l1*(u3^2*cos(q2 - q3) + u2^2*(l11*cos(q2 - q3) + l11_by_q2*sin(q2 - q3))))
    let r13_by_q2 = (-l11_by_q2).mul_add(r10_by_q1_of_u1_u2, g * c2_l1_m2_plus_m3)
        - u1_sq_s9_of_place - l11_m3_l2 * l1_cos_q2_minus_q3_u2_sq - r13_by_q2_of_u3;
    // s22_by_q2 = s5_by_q2*(l14*(s16/s15 + l21) - s5/s3 - l18) - s9_by_q2*(s16/s15 + l21) + s12_by_q2
    let s22_by_q2 = (-(l21 * s9_by_q2)).mul_add(S::int(2), s12_by_q2)
        + S::int(2) * s5_by_q2 * minus_l18_plus_l14_l21;
    // s9_by_q2*s15_inv - s5_by_q2*l14_s15_inv
    let r23_by_q2_of_place = (-s5_by_q2).mul_add(l14_s15_inv, s9_by_q2 * s15_inv);
    // r23_by_q2 = r17*(l14*s5_by_q2 - s9_by_q2)/s15 - r6*s5_by_q2/s3 - l18*r6_by_q2 + l21*(l14*r6_by_q2 -
    //   r10_by_q2) + r13_by_q2
    let r23_by_q2 = (-l21).mul_add(r10_by_q2, r13_by_q2) - s5_by_q2 * r6_s3_inv
        + r6_by_q2 * minus_l18_plus_l14_l21 - r17 * r23_by_q2_of_place;
    // u2'*s22_by_q2 - r23_by_q2
    let u1_dot_by_q2_of_u2_dot = u2_dot.mul_add(s22_by_q2, -r23_by_q2);
    // u1_dot_by_q2 = (u2'*(l14*s5_by_q2 - s9_by_q2) - l14*r6_by_q2 + r10_by_q2 + s16*(r23*s22_by_q2/s22 -
    //   r23_by_q2)/s22)/s15
    let u1_dot_by_q2 = (-r6_by_q2).mul_add(l14_s15_inv, r10_by_q2 * s15_inv)
        - u2_dot * r23_by_q2_of_place + l21_s22_inv * u1_dot_by_q2_of_u2_dot;
    let u2_dot_s3_inv = u2_dot * s3_inv;
    // u0_dot_by_q2 = (r6_by_q2 - u2'*s5_by_q2 + s5*(r23*s22_by_q2/s22 - r23_by_q2)/s22 -
    //   s4*u1_dot_by_q2)/s3
    let u0_dot_by_q2 = (-l14).mul_add(u1_dot_by_q2, r6_by_q2 * s3_inv)
        + l18_s22_inv * u1_dot_by_q2_of_u2_dot - s5_by_q2 * u2_dot_s3_inv;
    let u2_dot_l11_by_q3 = u2_dot * l11_by_q3;
    // u3_dot_by_q2 = m3*l2*(l1*(u2'*sin(q2 - q3) + cos(q2 - q3)*(u2^2 + (r23*s22_by_q2/s22 -
    //   r23_by_q2)/s22)) - l0*u1_dot_by_q2*cos(q1 - q3) + u0_dot_by_q2*cos(q3))/d1
    let u3_dot_by_q2 = (-l7).mul_add(u1_dot_by_q2, u0_dot_by_q2 * c3_d1_inv_m3_l2)
        + l11 * u2_sq + l11_s22_inv * u1_dot_by_q2_of_u2_dot + u2_dot_l11_by_q3;
    // l2__by_q3 = m3*l2*sin(q3)/d1
    let l2__by_q3 = d1_inv_m3_l2 * s3_2;
    // s3_by_q3 = m3*l2*(l2__by_q3*cos(q3) - l2_*sin(q3))
    let s3_by_q3 = (-l2__m3_l2).mul_add(s3_2, l2__by_q3 * m3_l2 * c3);
    // s4_by_q3 = -m3*l0*l2*(l2_*sin(q1 - q3) + l2__by_q3*cos(q1 - q3))
    let s4_by_q3 = (-l2__by_q3).mul_add(m3_l2_l0_cos_q1_minus_q3, -s4_by_q1_of_place);
    // s5_by_q3 = -m3*l1*l2*(l2_*sin(q2 - q3) + l2__by_q3*cos(q2 - q3))
    let s5_by_q3 = (-l2__by_q3).mul_add(m3_l2_l1_cos_q2_minus_q3, -s5_by_q2_of_place);
    // l0_cos_q1_minus_q3_u1_sq + l1_cos_q2_minus_q3_u2_sq
    let r6_by_q3_of_u1_u2 = l0_cos_q1_minus_q3_u1_sq + l1_cos_q2_minus_q3_u2_sq;
    // g*cos(q3) - r6_by_q3_of_u1_u2
    let r6_by_q3_of_u1_u2_2 = g.mul_add(c3, -r6_by_q3_of_u1_u2);
    // r6_by_q3 = m3*l2*(l2_*(l0*u1^2*cos(q1 - q3) - g*cos(q3) + l1*u2^2*cos(q2 - q3)) - u3^2*cos(q3) -
    //   l2__by_q3*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r6_by_q3 = (-l2__by_q3).mul_add(r10_by_q1_of_u1_u2, -u3_u3_m3_l2 * c3)
        - l2__m3_l2 * r6_by_q3_of_u1_u2_2;
    // s8_by_q3 = -m3*l0*l2*(l7*sin(q1 - q3) + l7_by_q3*cos(q1 - q3))
    let s8_by_q3 = (-l7_by_q3).mul_add(m3_l2_l0_cos_q1_minus_q3, -s8_by_q1_of_place);
    // s9_by_q3 = -m3*l1*l2*(l7*sin(q2 - q3) + l7_by_q3*cos(q2 - q3))
    let s9_by_q3 = (-l7_by_q3).mul_add(m3_l2_l1_cos_q2_minus_q3, -s9_by_q2_of_place);
    // r10_by_q3 = m3*l2*(l0*(u3^2*cos(q1 - q3) + u1^2*(l7*cos(q1 - q3) - l7_by_q3*sin(q1 - q3))) +
    //   l1*u2^2*(l7*cos(q2 - q3) - l7_by_q3*sin(q2 - q3)) - g*(l7*cos(q3) + l7_by_q3*sin(q3)))
    let r10_by_q3 = (-l7_by_q3).mul_add(r10_by_q1_of_u1_u2, r10_by_q1_of_u3)
        - l7_m3_l2 * r6_by_q3_of_u1_u2_2;
    // s12_by_q3 = -m3*l1*l2*(l11*sin(q2 - q3) + l11_by_q3*cos(q2 - q3))
    let s12_by_q3 = (-l11_by_q3).mul_add(m3_l2_l1_cos_q2_minus_q3, -s12_by_q2_of_place);
    // r13_by_q3 = m3*l2*(l1*(u3^2*cos(q2 - q3) + u2^2*(l11*cos(q2 - q3) - l11_by_q3*sin(q2 - q3))) +
    //   l0*u1^2*(l11*cos(q1 - q3) - l11_by_q3*sin(q1 - q3)) - g*(l11*cos(q3) + l11_by_q3*sin(q3)))
    let r13_by_q3 = (-l11_by_q3).mul_add(r10_by_q1_of_u1_u2, r13_by_q2_of_u3)
        - l11_m3_l2 * r6_by_q3_of_u1_u2_2;
    // l14*s3_by_q3 - s4_by_q3
    let s15_by_q3_of_place = l14.mul_add(s3_by_q3, -s4_by_q3);
    // s15_by_q3 = s4*(s4*s3_by_q3/s3 - s4_by_q3)/s3 - l14*s4_by_q3 + s8_by_q3
    let s15_by_q3 = s8_by_q3 + l14 * (s15_by_q3_of_place - s4_by_q3);
    // s16_by_q3 = s5*(s4*s3_by_q3/s3 - s4_by_q3)/s3 - l14*s5_by_q3 + s9_by_q3
    let s16_by_q3 = (-l14).mul_add(s5_by_q3, s9_by_q3) + l18 * s15_by_q3_of_place;
    // r17_by_q3 = r6*(s4*s3_by_q3/s3 - s4_by_q3)/s3 - l14*r6_by_q3 + r10_by_q3
    let r17_by_q3 = (-l14).mul_add(r6_by_q3, r10_by_q3) + r6_s3_inv * s15_by_q3_of_place;
    let l18_s3_by_q3 = l18 * s3_by_q3;
    // s19_by_q3 = s5*(s5*s3_by_q3/s3 - s5_by_q3)/s3 - l18*s5_by_q3 + s12_by_q3
    let s19_by_q3 = s12_by_q3 + l18 * (-s5_by_q3).mul_add(S::int(2), l18_s3_by_q3);
    // r20_by_q3 = r6*(s5*s3_by_q3/s3 - s5_by_q3)/s3 - l18*r6_by_q3 + r13_by_q3
    let r20_by_q3 = r13_by_q3 - l18 * r6_by_q3 + r6_s3_inv * (l18_s3_by_q3 - s5_by_q3);
    let l21_s15_by_q3 = l21 * s15_by_q3;
    // s22_by_q3 = s16*(s16*s15_by_q3/s15 - s16_by_q3)/s15 - l21*s16_by_q3 + s19_by_q3
    let s22_by_q3 = s19_by_q3 + l21 * (-s16_by_q3).mul_add(S::int(2), l21_s15_by_q3);
    // r23_by_q3 = r17*(s16*s15_by_q3/s15 - s16_by_q3)/s15 - l21*r17_by_q3 + r20_by_q3
    let r23_by_q3 = r20_by_q3 - l21 * r17_by_q3 + r17_s15_inv * (l21_s15_by_q3 - s16_by_q3);
    // u2'*s22_by_q3 - r23_by_q3
    let u1_dot_by_q3_of_u2_dot = u2_dot.mul_add(s22_by_q3, -r23_by_q3);
    // u1_dot_by_q3 = s15_by_q3*(u2'*s16 - r17)/s15^2 + (r17_by_q3 - u2'*s16_by_q3 + s16*(r23*s22_by_q3/s22
    //   - r23_by_q3)/s22)/s15
    let u1_dot_by_q3 = s15_inv * (-u1_dot).mul_add(s15_by_q3, r17_by_q3)
        - s16_by_q3 * u2_dot_s15_inv + l21_s22_inv * u1_dot_by_q3_of_u2_dot;
    // u0_dot_by_q3 = (s3_by_q3*(u1'*s4 - r6 + u2'*s5)/s3 - u1'*s4_by_q3 - u2'*s5_by_q3 + r6_by_q3 +
    //   s5*(r23*s22_by_q3/s22 - r23_by_q3)/s22 - s4*u1_dot_by_q3)/s3
    let u0_dot_by_q3 = s3_inv * (-s3_by_q3).mul_add(u0_dot_of_u2_dot, r6_by_q3)
        - l14 * u1_dot_by_q3 - s5_by_q3 * u2_dot_s3_inv
        + u1_dot_s3_inv * s15_by_q3_of_place + l18_s22_inv * u1_dot_by_q3_of_u2_dot;
    // u3_dot_by_q3 = m3*l2*(cos(q3)*(g + u0_dot_by_q3) - u0'*sin(q3) - l1*(u2'*sin(q2 - q3) + cos(q2 -
    //   q3)*(u2^2 + (r23_by_q3 - r23*s22_by_q3/s22)/s22)) - l0*(u1'*sin(q1 - q3) + cos(q1 - q3)*(u1^2 +
    //   u1_dot_by_q3)))/d1
    let u3_dot_by_q3 = (-u0_dot).mul_add(l2__by_q3, u0_dot_by_q3 * c3_d1_inv_m3_l2)
        - l7 * u1_dot_by_q3 - u1_dot_l7_by_q3 - u2_dot_l11_by_q3
        + d1_inv_m3_l2 * r6_by_q3_of_u1_u2_2 + l11_s22_inv * u1_dot_by_q3_of_u2_dot;
    let u1_doubled = S::int(2) * u1;
    // r6_by_u1 = -2*l0*u1*(sin(q1)*(m1 + m2 + m3) + m3*l2*l2_*sin(q1 - q3))
    let r6_by_u1 = -s4_by_q1 * u1_doubled;
    // r10_by_u1 = -2*m3*l0*l2*u1*l7*sin(q1 - q3)
    let r10_by_u1 = -s8_by_q1_of_place * u1_doubled;
    // r13_by_u1 = 2*l0*u1*(l1*sin(q1 - q2)*(m2 + m3) - m3*l2*l11*sin(q1 - q3))
    let r13_by_u1 = u1_doubled * (-l0_sin_q1_minus_q3).mul_add(l11_m3_l2, r10_of_place);
    let u2_dot_by_u1_of_place = s22_inv * minus_l18_plus_l14_l21;
    // u2_dot_by_u1 = (l21*(l14*r6_by_u1 - r10_by_u1) - l18*r6_by_u1 + r13_by_u1)/s22
    let u2_dot_by_u1 = (-r10_by_u1).mul_add(l21_s22_inv, r13_by_u1 * s22_inv)
        + r6_by_u1 * u2_dot_by_u1_of_place;
    // s3_inv + l14*l14_s15_inv
    let u0_dot_by_u1_of_s3_l14_s15 = l14.mul_add(l14_s15_inv, s3_inv);
    // u0_dot_by_u1 = (r6_by_u1 - s5*u2_dot_by_u1 + s4*(l14*r6_by_u1 - r10_by_u1 +
    //   s16*u2_dot_by_u1)/s15)/s3
    let u0_dot_by_u1 = (-r10_by_u1)
        .mul_add(l14_s15_inv, u2_dot_by_u1 * minus_l18_plus_l14_l21)
        + r6_by_u1 * u0_dot_by_u1_of_s3_l14_s15;
    // l7*l21 - l11
    let minus_l11_plus_l7_l21 = l7.mul_add(l21, -l11);
    // r10_by_u1*s15_inv - r6_by_u1*l14_s15_inv
    let u3_dot_by_u1_of_place = (-r6_by_u1).mul_add(l14_s15_inv, r10_by_u1 * s15_inv);
    // u3_dot_by_u1 = m3*l2*(l0*(2*u1*sin(q1 - q3) + cos(q1 - q3)*(l14*r6_by_u1 - r10_by_u1 +
    //   s16*u2_dot_by_u1)/s15) - l1*u2_dot_by_u1*cos(q2 - q3) + u0_dot_by_u1*cos(q3))/d1
    let u3_dot_by_u1 = l7_by_q3.mul_add(u1_doubled, u0_dot_by_u1 * c3_d1_inv_m3_l2)
        + u2_dot_by_u1 * minus_l11_plus_l7_l21 - l7 * u3_dot_by_u1_of_place;
    let u2_doubled = S::int(2) * u2;
    // r6_by_u2 = -2*l1*u2*(sin(q2)*(m2 + m3) + m3*l2*l2_*sin(q2 - q3))
    let r6_by_u2 = -s5_by_q2 * u2_doubled;
    // r10_by_u2 = -2*l1*u2*(l0*sin(q1 - q2)*(m2 + m3) + m3*l2*l7*sin(q2 - q3))
    let r10_by_u2 = -s9_by_q2 * u2_doubled;
    // r13_by_u2 = -2*m3*l1*l2*u2*l11*sin(q2 - q3)
    let r13_by_u2 = -s12_by_q2_of_place * u2_doubled;
    // u2_dot_by_u2 = (l21*(l14*r6_by_u2 - r10_by_u2) - l18*r6_by_u2 + r13_by_u2)/s22
    let u2_dot_by_u2 = (-r10_by_u2).mul_add(l21_s22_inv, r13_by_u2 * s22_inv)
        + r6_by_u2 * u2_dot_by_u1_of_place;
    // u0_dot_by_u2 = (r6_by_u2 - s5*u2_dot_by_u2 + s4*(l14*r6_by_u2 - r10_by_u2 +
    //   s16*u2_dot_by_u2)/s15)/s3
    let u0_dot_by_u2 = (-r10_by_u2)
        .mul_add(l14_s15_inv, u2_dot_by_u2 * minus_l18_plus_l14_l21)
        + r6_by_u2 * u0_dot_by_u1_of_s3_l14_s15;
    // r10_by_u2*s15_inv - r6_by_u2*l14_s15_inv
    let u3_dot_by_u2_of_place = (-r6_by_u2).mul_add(l14_s15_inv, r10_by_u2 * s15_inv);
    // u3_dot_by_u2 = m3*l2*(u0_dot_by_u2*cos(q3) - l0*cos(q1 - q3)*(r10_by_u2 - l14*r6_by_u2 -
    //   s16*u2_dot_by_u2)/s15 - l1*(u2_dot_by_u2*cos(q2 - q3) - 2*u2*sin(q2 - q3)))/d1
    let u3_dot_by_u2 = u2_dot_by_u2
        .mul_add(minus_l11_plus_l7_l21, u0_dot_by_u2 * c3_d1_inv_m3_l2)
        + l11_by_q3 * u2_doubled - l7 * u3_dot_by_u2_of_place;
    let u3_m3_l2_doubled = S::int(2) * u3_m3_l2;
    // r6_by_u3 = -2*m3*l2*u3*sin(q3)
    let r6_by_u3 = -u3_m3_l2_doubled * s3_2;
    // r10_by_u3 = -2*m3*l0*l2*u3*sin(q1 - q3)
    let r10_by_u3 = -l0_sin_q1_minus_q3 * u3_m3_l2_doubled;
    // r13_by_u3 = -2*m3*l1*l2*u3*sin(q2 - q3)
    let r13_by_u3 = -l1_sin_q2_minus_q3 * u3_m3_l2_doubled;
    // u2_dot_by_u3 = (l21*(l14*r6_by_u3 - r10_by_u3) - l18*r6_by_u3 + r13_by_u3)/s22
    let u2_dot_by_u3 = (-r10_by_u3).mul_add(l21_s22_inv, r13_by_u3 * s22_inv)
        + r6_by_u3 * u2_dot_by_u1_of_place;
    // u0_dot_by_u3 = (r6_by_u3 - s5*u2_dot_by_u3 + s4*(l14*r6_by_u3 - r10_by_u3 +
    //   s16*u2_dot_by_u3)/s15)/s3
    let u0_dot_by_u3 = (-r10_by_u3)
        .mul_add(l14_s15_inv, u2_dot_by_u3 * minus_l18_plus_l14_l21)
        + r6_by_u3 * u0_dot_by_u1_of_s3_l14_s15;
    // r10_by_u3*s15_inv - r6_by_u3*l14_s15_inv
    let u3_dot_by_u3_of_place = (-r6_by_u3).mul_add(l14_s15_inv, r10_by_u3 * s15_inv);
    // u3_dot_by_u3 = m3*l2*(u0_dot_by_u3*cos(q3) - l1*u2_dot_by_u3*cos(q2 - q3) - l0*cos(q1 -
    //   q3)*(r10_by_u3 - l14*r6_by_u3 - s16*u2_dot_by_u3)/s15)/d1
    let u3_dot_by_u3 = u2_dot_by_u3
        .mul_add(minus_l11_plus_l7_l21, u0_dot_by_u3 * c3_d1_inv_m3_l2)
        - l7 * u3_dot_by_u3_of_place;
    // Entries that are not zero.
    // d(q0')/d(u0) = 1
    let q0_dot_by_u0_value = S::int(1);
    // d(q1')/d(u1) = 1
    let q1_dot_by_u1_value = S::int(1);
    // d(q2')/d(u2) = 1
    let q2_dot_by_u2_value = S::int(1);
    // d(q3')/d(u3) = 1
    let q3_dot_by_u3_value = S::int(1);
    // d(u1')/d(u1) = (r10_by_u1 - l14*r6_by_u1 - s16*u2_dot_by_u1)/s15
    let u1_dot_by_u1_value = (-l21).mul_add(u2_dot_by_u1, u3_dot_by_u1_of_place);
    // d(u1')/d(u2) = (r10_by_u2 - l14*r6_by_u2 - s16*u2_dot_by_u2)/s15
    let u1_dot_by_u2_value = (-l21).mul_add(u2_dot_by_u2, u3_dot_by_u2_of_place);
    // d(u1')/d(u3) = (r10_by_u3 - l14*r6_by_u3 - s16*u2_dot_by_u3)/s15
    let u1_dot_by_u3_value = (-l21).mul_add(u2_dot_by_u3, u3_dot_by_u3_of_place);
    // d(u2')/d(q1) = (r23_by_q1 - r23*s22_by_q1/s22)/s22
    let u2_dot_by_q1_value = -s22_inv * u1_dot_by_q1_of_u2_dot;
    // d(u2')/d(q2) = (r23_by_q2 - r23*s22_by_q2/s22)/s22
    let u2_dot_by_q2_value = -s22_inv * u1_dot_by_q2_of_u2_dot;
    // d(u2')/d(q3) = (r23_by_q3 - r23*s22_by_q3/s22)/s22
    let u2_dot_by_q3_value = -s22_inv * u1_dot_by_q3_of_u2_dot;
    let zero = S::int(0);
    [
        [zero, zero, zero, zero, q0_dot_by_u0_value, zero, zero, zero],
        [zero, zero, zero, zero, zero, q1_dot_by_u1_value, zero, zero],
        [zero, zero, zero, zero, zero, zero, q2_dot_by_u2_value, zero],
        [zero, zero, zero, zero, zero, zero, zero, q3_dot_by_u3_value],
        [
            zero, u0_dot_by_q1, u0_dot_by_q2, u0_dot_by_q3, zero, u0_dot_by_u1, u0_dot_by_u2,
            u0_dot_by_u3,
        ],
        [
            zero, u1_dot_by_q1, u1_dot_by_q2, u1_dot_by_q3, zero, u1_dot_by_u1_value,
            u1_dot_by_u2_value, u1_dot_by_u3_value,
        ],
        [
            zero, u2_dot_by_q1_value, u2_dot_by_q2_value, u2_dot_by_q3_value, zero, u2_dot_by_u1,
            u2_dot_by_u2, u2_dot_by_u3,
        ],
        [
            zero, u3_dot_by_q1, u3_dot_by_q2, u3_dot_by_q3, zero, u3_dot_by_u1, u3_dot_by_u2,
            u3_dot_by_u3,
        ],
    ]
}

/// Inverse dynamics: the generalized forces along (u0, u1, u2, u3) that must act beside the loads of the model for the accelerations to be (u0', u1', u2', u3').
///
/// 75 operations, 3 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    u: &[S; 4],
    v_dot: &[S; 4],
) -> [S; 4] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, u1, u2, u3] = *u;
    let [u0_dot, u1_dot, u2_dot, u3_dot] = *v_dot;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    // m2 + m3
    let m2_plus_m3 = m2 + m3;
    // m1 + m2_plus_m3
    let m1_plus_m2_plus_m3 = m1 + m2_plus_m3;
    let u1_sq = u1 * u1;
    // u0' + l0*(u1_sq*sin(q1) - u1'*cos(q1))
    let tau1_of_motion = u0_dot + l0 * (-u1_dot).mul_add(c1, u1_sq * s1);
    let m3_l2 = m3 * l2;
    let u3_sq = u3 * u3;
    // u3_sq*sin(q3) - u3'*cos(q3)
    let tau1_of_u3_u3_dot = (-u3_dot).mul_add(c3, u3_sq * s3_2);
    let u2_sq = u2 * u2;
    // u2_sq*sin(q2) - u2'*cos(q2)
    let tau1_of_u2_u2_dot = (-u2_dot).mul_add(c2, u2_sq * s2);
    let l1_m2_plus_m3 = l1 * m2_plus_m3;
    // m3_l2*tau1_of_u3_u3_dot + tau1_of_u2_u2_dot*l1_m2_plus_m3
    let tau1_of_motion_2 = tau1_of_u2_u2_dot
        .mul_add(l1_m2_plus_m3, m3_l2 * tau1_of_u3_u3_dot);
    // u2'*sin(q2) + u2_sq*cos(q2)
    let u2_dot_s2_plus_c2_u2_sq = u2_sq.mul_add(c2, u2_dot * s2);
    // u3'*sin(q3) + u3_sq*cos(q3)
    let tau2_of_u3_u3_dot = u3_sq.mul_add(c3, u3_dot * s3_2);
    // g*m1_plus_m2_plus_m3 - m3_l2*tau2_of_u3_u3_dot
    let tau2_of_u3_u3_dot_2 = (-m3_l2)
        .mul_add(tau2_of_u3_u3_dot, g * m1_plus_m2_plus_m3);
    let l1_m3_l2 = l1 * m3_l2;
    // l0*(u1'*sin(q1) + u1_sq*cos(q1)) - g
    let tau3_of_u1_u1_dot = l0 * u1_sq.mul_add(c1, u1_dot * s1) - g;
    // l1*u2' - tau1_of_motion*cos(q2)
    let tau3_of_motion = (-tau1_of_motion).mul_add(c2, l1 * u2_dot);
    // l2*u3' - tau1_of_motion*cos(q3)
    let tau4_of_motion = (-tau1_of_motion).mul_add(c3, l2 * u3_dot);
    // Values.
    // tau1 = l0*u1^2*sin(q1)*(m1 + m2 + m3) - F + l1*u2^2*sin(q2)*(m2 + m3) + m3*l2*u3^2*sin(q3) + u0'*(m0
    //   + m1 + m2 + m3) - l0*u1'*cos(q1)*(m1 + m2 + m3) - l1*u2'*cos(q2)*(m2 + m3) - m3*l2*u3'*cos(q3)
    let tau1 = m0.mul_add(u0_dot, -F) + m1_plus_m2_plus_m3 * tau1_of_motion + tau1_of_motion_2;
    // tau2 = l0*(l1*u2^2*sin(q1 - q2)*(m2 + m3) - g*sin(q1)*(m1 + m2 + m3) + m3*l2*u3^2*sin(q1 - q3)) -
    //   l0*u0'*cos(q1)*(m1 + m2 + m3) + l0^2*u1'*(m1 + m2 + m3) + l0*l1*u2'*cos(q1 - q2)*(m2 + m3) +
    //   m3*l0*l2*u3'*cos(q1 - q3)
    let tau2 = l0 * s1 * l1_m2_plus_m3.mul_add(u2_dot_s2_plus_c2_u2_sq, -tau2_of_u3_u3_dot_2)
        - l0
            * (m1_plus_m2_plus_m3 * (-l0).mul_add(u1_dot, u0_dot * c1) + tau1_of_motion_2 * c1);
    // tau3 = l1*(m3*l2*u3^2*sin(q2 - q3) - (m2 + m3)*(g*sin(q2) + l0*u1^2*sin(q1 - q2))) -
    //   l1*u0'*cos(q2)*(m2 + m3) + l0*l1*u1'*cos(q1 - q2)*(m2 + m3) + l1^2*u2'*(m2 + m3) +
    //   m3*l1*l2*u3'*cos(q2 - q3)
    let tau3 = l1_m3_l2 * (-tau1_of_u3_u3_dot).mul_add(c2, tau2_of_u3_u3_dot * s2)
        + l1_m2_plus_m3 * tau3_of_u1_u1_dot.mul_add(s2, tau3_of_motion);
    // tau4 = m3*l0*l2*u1'*cos(q1 - q3) - m3*l2*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)) -
    //   m3*l2*u0'*cos(q3) + m3*l1*l2*u2'*cos(q2 - q3) + m3*l2^2*u3'
    let tau4 = l1_m3_l2 * (-tau1_of_u2_u2_dot).mul_add(c3, u2_dot_s2_plus_c2_u2_sq * s3_2)
        + m3_l2 * tau3_of_u1_u1_dot.mul_add(s3_2, tau4_of_motion);
    [tau1, tau2, tau3, tau4]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 52 convolutions and 96 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 8]],
    history: &mut [Factors<S, 56>],
) {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1_0, q2_0, q3_0, u0_0, u1_0, u2_0, u3_0] = series[0];
    // Shared terms.
    // m1 + m2 + m3
    let m1_plus_m2_plus_m3_2 = m1 + m2 + m3;
    // m2 + m3
    let m2_plus_m3_2 = m2 + m3;
    let l0_l1_m2_plus_m3_of_m2_m3_l0_l1 = l0 * l1 * m2_plus_m3_2;
    // Constant in time.
    // weight = m0 + m1 + m2 + m3
    let weight = m0 + m1 + m2 + m3;
    // minus_m3 = -m3
    let minus_m3 = -m3;
    // m1_plus_m2_plus_m3 = m1 + m2 + m3
    let m1_plus_m2_plus_m3 = m1_plus_m2_plus_m3_2;
    // m2_plus_m3 = m2 + m3
    let m2_plus_m3 = m2_plus_m3_2;
    // weight_2 = -l0*(m1 + m2 + m3)
    let weight_2 = -l0 * m1_plus_m2_plus_m3_2;
    // minus_l1_m2_plus_m3 = -l1*(m2 + m3)
    let minus_l1_m2_plus_m3 = -l1 * m2_plus_m3_2;
    // minus_m3_l2 = -m3*l2
    let minus_m3_l2 = -m3 * l2;
    // l0_2_m1_plus_m2_plus_m3 = l0^2*(m1 + m2 + m3)
    let l0_2_m1_plus_m2_plus_m3 = l0 * l0 * m1_plus_m2_plus_m3_2;
    // minus_m3_l0_2 = -m3*l0^2
    let minus_m3_l0_2 = -m3 * l0 * l0;
    // minus_l0_2 = -l0^2
    let minus_l0_2 = -l0 * l0;
    // minus_m3_l0_l1 = -m3*l0*l1
    let minus_m3_l0_l1 = -m3 * l0 * l1;
    // l0_l1_m2_plus_m3 = l0*l1*(m2 + m3)
    let l0_l1_m2_plus_m3 = l0_l1_m2_plus_m3_of_m2_m3_l0_l1;
    // minus_l0_l1 = -l0*l1
    let minus_l0_l1 = -l0 * l1;
    // minus_m3_l0 = -m3*l0
    let minus_m3_l0 = -m3 * l0;
    // minus_m3_l0_l2 = -m3*l0*l2
    let minus_m3_l0_l2 = -m3 * l0 * l2;
    // minus_l0_l1_m2_plus_m3 = -l0*l1*(m2 + m3)
    let minus_l0_l1_m2_plus_m3 = -l0_l1_m2_plus_m3_of_m2_m3_l0_l1;
    // l0_g_m1_plus_m2_plus_m3 = l0*g*(m1 + m2 + m3)
    let l0_g_m1_plus_m2_plus_m3 = l0 * g * m1_plus_m2_plus_m3_2;
    // l1_2_m2_plus_m3 = l1^2*(m2 + m3)
    let l1_2_m2_plus_m3 = l1 * l1 * m2_plus_m3_2;
    // minus_m3_l1_2 = -m3*l1^2
    let minus_m3_l1_2 = -m3 * l1 * l1;
    // minus_l1_2 = -l1^2
    let minus_l1_2 = -l1 * l1;
    // minus_m3_l1 = -m3*l1
    let minus_m3_l1 = -m3 * l1;
    // minus_m3_l1_l2 = -m3*l1*l2
    let minus_m3_l1_l2 = -m3 * l1 * l2;
    // l1_g_m2_plus_m3 = l1*g*(m2 + m3)
    let l1_g_m2_plus_m3 = l1 * g * m2_plus_m3_2;
    // minus_l0 = -l0
    let minus_l0 = -l0;
    // minus_l1 = -l1
    let minus_l1 = -l1;
    // weight_3 = 1/l2
    let weight_3 = S::int(1) / l2;
    // Order 0.
    let (s3_2_0, c3_0) = q3_0.sin_cos();
    let c3_sq_0 = c3_0 * c3_0;
    let s3_of_place_0 = c3_sq_0.mul_add(minus_m3, weight);
    let over_s3_of_place = S::int(1) / s3_of_place_0;
    let (s1_0, c1_0) = q1_0.sin_cos();
    let q1_minus_q3_0 = q1_0 - q3_0;
    let (sin_q1_minus_q3_0, cos_q1_minus_q3_0) = q1_minus_q3_0.sin_cos();
    let c3_cos_q1_minus_q3_0 = cos_q1_minus_q3_0 * c3_0;
    let s4_of_place_0 = c3_cos_q1_minus_q3_0
        .mul_add(minus_m3, m1_plus_m2_plus_m3 * c1_0);
    let (s2_0, c2_0) = q2_0.sin_cos();
    let q2_minus_q3_0 = q2_0 - q3_0;
    let (sin_q2_minus_q3_0, cos_q2_minus_q3_0) = q2_minus_q3_0.sin_cos();
    let c3_cos_q2_minus_q3_0 = cos_q2_minus_q3_0 * c3_0;
    let s5_of_place_0 = c3_cos_q2_minus_q3_0.mul_add(minus_m3, m2_plus_m3 * c2_0);
    let u1_sq_0 = u1_0 * u1_0;
    let u1_sq_s1_0 = s1_0 * u1_sq_0;
    let u2_sq_0 = u2_0 * u2_0;
    let u2_sq_s2_0 = s2_0 * u2_sq_0;
    let u1_sq_sin_q1_minus_q3_0 = sin_q1_minus_q3_0 * u1_sq_0;
    let u2_sq_sin_q2_minus_q3_0 = sin_q2_minus_q3_0 * u2_sq_0;
    let r6_of_u1_u2_0 = u2_sq_sin_q2_minus_q3_0
        .mul_add(l1, u1_sq_sin_q1_minus_q3_0.mul_add(l0, g * s3_2_0));
    let r6_of_u1_u2_2_0 = r6_of_u1_u2_0 * c3_0;
    let u3_sq_0 = u3_0 * u3_0;
    let u3_sq_s3_2_0 = s3_2_0 * u3_sq_0;
    let r6_of_u1_u2_u3_0 = r6_of_u1_u2_2_0
        .mul_add(
            m3,
            u3_sq_s3_2_0
                .mul_add(
                    minus_m3_l2,
                    u2_sq_s2_0
                        .mul_add(minus_l1_m2_plus_m3, u1_sq_s1_0.mul_add(weight_2, F)),
                ),
        );
    let cos_q1_minus_q3_sq_0 = cos_q1_minus_q3_0 * cos_q1_minus_q3_0;
    let q1_minus_q2_0 = q1_0 - q2_0;
    let (sin_q1_minus_q2_0, cos_q1_minus_q2_0) = q1_minus_q2_0.sin_cos();
    let s9_of_q1_q2_q3_0 = cos_q2_minus_q3_0 * cos_q1_minus_q3_0;
    let u2_sq_sin_q1_minus_q2_0 = sin_q1_minus_q2_0 * u2_sq_0;
    let r10_of_u1_u2_0 = r6_of_u1_u2_0 * cos_q1_minus_q3_0;
    let u3_sq_sin_q1_minus_q3_0 = sin_q1_minus_q3_0 * u3_sq_0;
    let cos_q2_minus_q3_sq_0 = cos_q2_minus_q3_0 * cos_q2_minus_q3_0;
    let u1_sq_sin_q1_minus_q2_0 = sin_q1_minus_q2_0 * u1_sq_0;
    let r13_of_u1_u2_0 = r6_of_u1_u2_0 * cos_q2_minus_q3_0;
    let u3_sq_sin_q2_minus_q3_0 = sin_q2_minus_q3_0 * u3_sq_0;
    let l14_of_place_0 = s4_of_place_0 * over_s3_of_place;
    let s15_of_place_0 = s4_of_place_0 * l14_of_place_0;
    let s8_minus_s4_l14_0 = s15_of_place_0
        .mul_add(
            minus_l0_2,
            cos_q1_minus_q3_sq_0.mul_add(minus_m3_l0_2, l0_2_m1_plus_m2_plus_m3),
        );
    let over_s8_minus_s4_l14 = S::int(1) / s8_minus_s4_l14_0;
    let s16_of_place_0 = s5_of_place_0 * l14_of_place_0;
    let s9_minus_s5_l14_0 = s16_of_place_0
        .mul_add(
            minus_l0_l1,
            s9_of_q1_q2_q3_0
                .mul_add(minus_m3_l0_l1, l0_l1_m2_plus_m3 * cos_q1_minus_q2_0),
        );
    let r17_of_u1_u2_u3_0 = r6_of_u1_u2_u3_0 * l14_of_place_0;
    let r10_minus_r6_l14_0 = r17_of_u1_u2_u3_0
        .mul_add(
            l0,
            r10_of_u1_u2_0
                .mul_add(
                    minus_m3_l0,
                    u2_sq_sin_q1_minus_q2_0
                        .mul_add(
                            minus_l0_l1_m2_plus_m3,
                            u3_sq_sin_q1_minus_q3_0
                                .mul_add(minus_m3_l0_l2, l0_g_m1_plus_m2_plus_m3 * s1_0),
                        ),
                ),
        );
    let l18_of_place_0 = s5_of_place_0 * over_s3_of_place;
    let s19_of_place_0 = s5_of_place_0 * l18_of_place_0;
    let r20_of_u1_u2_u3_0 = r6_of_u1_u2_u3_0 * l18_of_place_0;
    let l21_of_place_0 = s9_minus_s5_l14_0 * over_s8_minus_s4_l14;
    let s22_of_place_0 = s9_minus_s5_l14_0 * l21_of_place_0;
    let s19_minus_s16_l21_0 = s19_of_place_0
        .mul_add(
            minus_l1_2,
            cos_q2_minus_q3_sq_0.mul_add(minus_m3_l1_2, l1_2_m2_plus_m3),
        ) - s22_of_place_0;
    let over_s19_minus_s16_l21 = S::int(1) / s19_minus_s16_l21_0;
    let r23_of_place_0 = r10_minus_r6_l14_0 * l21_of_place_0;
    let r20_minus_r17_l21_0 = r20_of_u1_u2_u3_0
        .mul_add(
            l1,
            r13_of_u1_u2_0
                .mul_add(
                    minus_m3_l1,
                    u1_sq_sin_q1_minus_q2_0
                        .mul_add(
                            l0_l1_m2_plus_m3,
                            u3_sq_sin_q2_minus_q3_0
                                .mul_add(minus_m3_l1_l2, l1_g_m2_plus_m3 * s2_0),
                        ),
                ),
        ) - r23_of_place_0;
    let u2_dot_2_0 = r20_minus_r17_l21_0 * over_s19_minus_s16_l21;
    let u1_dot_of_place_0 = u2_dot_2_0 * s9_minus_s5_l14_0;
    let r17_minus_u2_dot_s16_0 = r10_minus_r6_l14_0 - u1_dot_of_place_0;
    let u1_dot_2_0 = r17_minus_u2_dot_s16_0 * over_s8_minus_s4_l14;
    let u0_dot_of_u2_dot_0 = u1_dot_2_0 * s4_of_place_0;
    let u0_dot_of_place_0 = u2_dot_2_0 * s5_of_place_0;
    let u0_dot_of_motion_0 = u0_dot_of_u2_dot_0
        .mul_add(l0, u0_dot_of_place_0.mul_add(l1, r6_of_u1_u2_u3_0));
    let u0_dot_2_0 = u0_dot_of_motion_0 * over_s3_of_place;
    let u3_dot_of_u2_dot_0 = u1_dot_2_0 * cos_q1_minus_q3_0;
    let u3_dot_of_place_0 = u2_dot_2_0 * cos_q2_minus_q3_0;
    let u3_dot_of_motion_0 = u0_dot_2_0 * c3_0;
    let u3_dot_of_motion_2_0 = u3_dot_of_u2_dot_0
        .mul_add(
            minus_l0,
            u3_dot_of_place_0
                .mul_add(
                    minus_l1,
                    u2_sq_sin_q2_minus_q3_0
                        .mul_add(l1, u1_sq_sin_q1_minus_q3_0.mul_add(l0, g * s3_2_0)),
                ),
        ) + u3_dot_of_motion_0;
    // Order 1: the rates, and what follows from them.
    let q0_1 = u0_0;
    let q1_1 = u1_0;
    let q2_1 = u2_0;
    let q3_1 = u3_0;
    let u0_1 = u0_dot_2_0;
    let u1_1 = u1_dot_2_0;
    let u2_1 = u2_dot_2_0;
    let u3_1 = weight_3 * u3_dot_of_motion_2_0;
    if series.len() > 1 {
        series[1] = [q0_1, q1_1, q2_1, q3_1, u0_1, u1_1, u2_1, u3_1];
    }
    let s3_2_1 = q3_1 * c3_0;
    let c3_1 = -q3_1 * s3_2_0;
    let c3_sq_1 = c3_1 * (c3_0 + c3_0);
    let s3_of_place_1 = minus_m3 * c3_sq_1;
    let s1_1 = q1_1 * c1_0;
    let c1_1 = -q1_1 * s1_0;
    let q1_minus_q3_1 = q1_1 - q3_1;
    let sin_q1_minus_q3_1 = q1_minus_q3_1 * cos_q1_minus_q3_0;
    let cos_q1_minus_q3_1 = -q1_minus_q3_1 * sin_q1_minus_q3_0;
    let c3_cos_q1_minus_q3_1 = cos_q1_minus_q3_1.mul_add(c3_0, c3_1 * cos_q1_minus_q3_0);
    let s4_of_place_1 = c3_cos_q1_minus_q3_1
        .mul_add(minus_m3, m1_plus_m2_plus_m3 * c1_1);
    let s2_1 = q2_1 * c2_0;
    let c2_1 = -q2_1 * s2_0;
    let q2_minus_q3_1 = q2_1 - q3_1;
    let sin_q2_minus_q3_1 = q2_minus_q3_1 * cos_q2_minus_q3_0;
    let cos_q2_minus_q3_1 = -q2_minus_q3_1 * sin_q2_minus_q3_0;
    let c3_cos_q2_minus_q3_1 = cos_q2_minus_q3_1.mul_add(c3_0, c3_1 * cos_q2_minus_q3_0);
    let s5_of_place_1 = c3_cos_q2_minus_q3_1.mul_add(minus_m3, m2_plus_m3 * c2_1);
    let u1_sq_1 = u1_1 * (u1_0 + u1_0);
    let u1_sq_s1_1 = u1_sq_1.mul_add(s1_0, s1_1 * u1_sq_0);
    let u2_sq_1 = u2_1 * (u2_0 + u2_0);
    let u2_sq_s2_1 = u2_sq_1.mul_add(s2_0, s2_1 * u2_sq_0);
    let u1_sq_sin_q1_minus_q3_1 = sin_q1_minus_q3_1
        .mul_add(u1_sq_0, u1_sq_1 * sin_q1_minus_q3_0);
    let u2_sq_sin_q2_minus_q3_1 = sin_q2_minus_q3_1
        .mul_add(u2_sq_0, u2_sq_1 * sin_q2_minus_q3_0);
    let r6_of_u1_u2_1 = u2_sq_sin_q2_minus_q3_1
        .mul_add(l1, u1_sq_sin_q1_minus_q3_1.mul_add(l0, g * s3_2_1));
    let r6_of_u1_u2_2_1 = r6_of_u1_u2_1.mul_add(c3_0, c3_1 * r6_of_u1_u2_0);
    let u3_sq_1 = u3_1 * (u3_0 + u3_0);
    let u3_sq_s3_2_1 = u3_sq_1.mul_add(s3_2_0, s3_2_1 * u3_sq_0);
    let r6_of_u1_u2_u3_1 = r6_of_u1_u2_2_1
        .mul_add(
            m3,
            u3_sq_s3_2_1
                .mul_add(
                    minus_m3_l2,
                    u2_sq_s2_1.mul_add(minus_l1_m2_plus_m3, weight_2 * u1_sq_s1_1),
                ),
        );
    let cos_q1_minus_q3_sq_1 = cos_q1_minus_q3_1 * (cos_q1_minus_q3_0 + cos_q1_minus_q3_0);
    let q1_minus_q2_1 = q1_1 - q2_1;
    let sin_q1_minus_q2_1 = q1_minus_q2_1 * cos_q1_minus_q2_0;
    let cos_q1_minus_q2_1 = -q1_minus_q2_1 * sin_q1_minus_q2_0;
    let s9_of_q1_q2_q3_1 = cos_q1_minus_q3_1
        .mul_add(cos_q2_minus_q3_0, cos_q2_minus_q3_1 * cos_q1_minus_q3_0);
    let u2_sq_sin_q1_minus_q2_1 = sin_q1_minus_q2_1
        .mul_add(u2_sq_0, u2_sq_1 * sin_q1_minus_q2_0);
    let r10_of_u1_u2_1 = r6_of_u1_u2_1
        .mul_add(cos_q1_minus_q3_0, cos_q1_minus_q3_1 * r6_of_u1_u2_0);
    let u3_sq_sin_q1_minus_q3_1 = sin_q1_minus_q3_1
        .mul_add(u3_sq_0, u3_sq_1 * sin_q1_minus_q3_0);
    let cos_q2_minus_q3_sq_1 = cos_q2_minus_q3_1 * (cos_q2_minus_q3_0 + cos_q2_minus_q3_0);
    let u1_sq_sin_q1_minus_q2_1 = sin_q1_minus_q2_1
        .mul_add(u1_sq_0, u1_sq_1 * sin_q1_minus_q2_0);
    let r13_of_u1_u2_1 = r6_of_u1_u2_1
        .mul_add(cos_q2_minus_q3_0, cos_q2_minus_q3_1 * r6_of_u1_u2_0);
    let u3_sq_sin_q2_minus_q3_1 = sin_q2_minus_q3_1
        .mul_add(u3_sq_0, u3_sq_1 * sin_q2_minus_q3_0);
    let l14_of_place_1 = s3_of_place_1
        .mul_add(-(l14_of_place_0 * over_s3_of_place), s4_of_place_1 * over_s3_of_place);
    let s15_of_place_1 = l14_of_place_1
        .mul_add(s4_of_place_0, s4_of_place_1 * l14_of_place_0);
    let s8_minus_s4_l14_1 = s15_of_place_1
        .mul_add(minus_l0_2, minus_m3_l0_2 * cos_q1_minus_q3_sq_1);
    let s16_of_place_1 = l14_of_place_1
        .mul_add(s5_of_place_0, s5_of_place_1 * l14_of_place_0);
    let s9_minus_s5_l14_1 = s16_of_place_1
        .mul_add(
            minus_l0_l1,
            s9_of_q1_q2_q3_1
                .mul_add(minus_m3_l0_l1, l0_l1_m2_plus_m3 * cos_q1_minus_q2_1),
        );
    let r17_of_u1_u2_u3_1 = r6_of_u1_u2_u3_1
        .mul_add(l14_of_place_0, l14_of_place_1 * r6_of_u1_u2_u3_0);
    let r10_minus_r6_l14_1 = r17_of_u1_u2_u3_1
        .mul_add(
            l0,
            r10_of_u1_u2_1
                .mul_add(
                    minus_m3_l0,
                    u2_sq_sin_q1_minus_q2_1
                        .mul_add(
                            minus_l0_l1_m2_plus_m3,
                            u3_sq_sin_q1_minus_q3_1
                                .mul_add(minus_m3_l0_l2, l0_g_m1_plus_m2_plus_m3 * s1_1),
                        ),
                ),
        );
    let l18_of_place_1 = s3_of_place_1
        .mul_add(-(l18_of_place_0 * over_s3_of_place), s5_of_place_1 * over_s3_of_place);
    let s19_of_place_1 = l18_of_place_1
        .mul_add(s5_of_place_0, s5_of_place_1 * l18_of_place_0);
    let r20_of_u1_u2_u3_1 = r6_of_u1_u2_u3_1
        .mul_add(l18_of_place_0, l18_of_place_1 * r6_of_u1_u2_u3_0);
    let l21_of_place_1 = s8_minus_s4_l14_1
        .mul_add(
            -(l21_of_place_0 * over_s8_minus_s4_l14),
            s9_minus_s5_l14_1 * over_s8_minus_s4_l14,
        );
    let s22_of_place_1 = l21_of_place_1
        .mul_add(s9_minus_s5_l14_0, s9_minus_s5_l14_1 * l21_of_place_0);
    let s19_minus_s16_l21_1 = s19_of_place_1
        .mul_add(minus_l1_2, minus_m3_l1_2 * cos_q2_minus_q3_sq_1) - s22_of_place_1;
    let r23_of_place_1 = l21_of_place_1
        .mul_add(r10_minus_r6_l14_0, r10_minus_r6_l14_1 * l21_of_place_0);
    let r20_minus_r17_l21_1 = r20_of_u1_u2_u3_1
        .mul_add(
            l1,
            r13_of_u1_u2_1
                .mul_add(
                    minus_m3_l1,
                    u1_sq_sin_q1_minus_q2_1
                        .mul_add(
                            l0_l1_m2_plus_m3,
                            u3_sq_sin_q2_minus_q3_1
                                .mul_add(minus_m3_l1_l2, l1_g_m2_plus_m3 * s2_1),
                        ),
                ),
        ) - r23_of_place_1;
    let u2_dot_2_1 = s19_minus_s16_l21_1
        .mul_add(
            -(u2_dot_2_0 * over_s19_minus_s16_l21),
            r20_minus_r17_l21_1 * over_s19_minus_s16_l21,
        );
    let u1_dot_of_place_1 = u2_dot_2_1
        .mul_add(s9_minus_s5_l14_0, s9_minus_s5_l14_1 * u2_dot_2_0);
    let r17_minus_u2_dot_s16_1 = r10_minus_r6_l14_1 - u1_dot_of_place_1;
    let u1_dot_2_1 = s8_minus_s4_l14_1
        .mul_add(
            -(u1_dot_2_0 * over_s8_minus_s4_l14),
            r17_minus_u2_dot_s16_1 * over_s8_minus_s4_l14,
        );
    let u0_dot_of_u2_dot_1 = u1_dot_2_1
        .mul_add(s4_of_place_0, s4_of_place_1 * u1_dot_2_0);
    let u0_dot_of_place_1 = u2_dot_2_1
        .mul_add(s5_of_place_0, s5_of_place_1 * u2_dot_2_0);
    let u0_dot_of_motion_1 = u0_dot_of_u2_dot_1
        .mul_add(l0, u0_dot_of_place_1.mul_add(l1, r6_of_u1_u2_u3_1));
    let u0_dot_2_1 = s3_of_place_1
        .mul_add(
            -(u0_dot_2_0 * over_s3_of_place),
            u0_dot_of_motion_1 * over_s3_of_place,
        );
    let u3_dot_of_u2_dot_1 = u1_dot_2_1
        .mul_add(cos_q1_minus_q3_0, cos_q1_minus_q3_1 * u1_dot_2_0);
    let u3_dot_of_place_1 = u2_dot_2_1
        .mul_add(cos_q2_minus_q3_0, cos_q2_minus_q3_1 * u2_dot_2_0);
    let u3_dot_of_motion_1 = u0_dot_2_1.mul_add(c3_0, c3_1 * u0_dot_2_0);
    let u3_dot_of_motion_2_1 = u3_dot_of_u2_dot_1
        .mul_add(
            minus_l0,
            u3_dot_of_place_1
                .mul_add(
                    minus_l1,
                    u2_sq_sin_q2_minus_q3_1
                        .mul_add(l1, u1_sq_sin_q1_minus_q3_1.mul_add(l0, g * s3_2_1)),
                ),
        ) + u3_dot_of_motion_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                q3_1, q3_1, c3_1, q1_1, q1_1, q1_minus_q3_1, q1_minus_q3_1, cos_q1_minus_q3_1, q2_1,
                q2_1, q2_minus_q3_1, q2_minus_q3_1, cos_q2_minus_q3_1, u1_1, s1_1, u2_1, s2_1,
                sin_q1_minus_q3_1, sin_q2_minus_q3_1, r6_of_u1_u2_1, u3_1, s3_2_1,
                cos_q1_minus_q3_1, q1_minus_q2_1, q1_minus_q2_1, cos_q2_minus_q3_1,
                sin_q1_minus_q2_1, r6_of_u1_u2_1, sin_q1_minus_q3_1, cos_q2_minus_q3_1,
                sin_q1_minus_q2_1, r6_of_u1_u2_1, sin_q2_minus_q3_1, s3_of_place_1, s4_of_place_1,
                s5_of_place_1, r6_of_u1_u2_u3_1, s3_of_place_1, s5_of_place_1, r6_of_u1_u2_u3_1,
                s8_minus_s4_l14_1, s9_minus_s5_l14_1, r10_minus_r6_l14_1, s19_minus_s16_l21_1,
                u2_dot_2_1, s8_minus_s4_l14_1, u1_dot_2_1, u2_dot_2_1, s3_of_place_1, u1_dot_2_1,
                u2_dot_2_1, u0_dot_2_1,
            ]),
            padded([
                c3_1, s3_2_1, c3_1, c1_1, s1_1, cos_q1_minus_q3_1, sin_q1_minus_q3_1, c3_1, c2_1,
                s2_1, cos_q2_minus_q3_1, sin_q2_minus_q3_1, c3_1, u1_1, u1_sq_1, u2_1, u2_sq_1,
                u1_sq_1, u2_sq_1, c3_1, u3_1, u3_sq_1, cos_q1_minus_q3_1, cos_q1_minus_q2_1,
                sin_q1_minus_q2_1, cos_q1_minus_q3_1, u2_sq_1, cos_q1_minus_q3_1, u3_sq_1,
                cos_q2_minus_q3_1, u1_sq_1, cos_q2_minus_q3_1, u3_sq_1, l14_of_place_1,
                l14_of_place_1, l14_of_place_1, l14_of_place_1, l18_of_place_1, l18_of_place_1,
                l18_of_place_1, l21_of_place_1, l21_of_place_1, l21_of_place_1, u2_dot_2_1,
                s9_minus_s5_l14_1, u1_dot_2_1, s4_of_place_1, s5_of_place_1, u0_dot_2_1,
                cos_q1_minus_q3_1, cos_q2_minus_q3_1, c3_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q1_last = q1_1;
    let mut q2_last = q2_1;
    let mut q3_last = q3_1;
    let mut u1_last = u1_1;
    let mut u2_last = u2_1;
    let mut u3_last = u3_1;
    let mut s3_2_last = s3_2_1;
    let mut c3_last = c3_1;
    let mut s3_of_place_last = s3_of_place_1;
    let mut s1_last = s1_1;
    let mut c1_last = c1_1;
    let mut q1_minus_q3_last = q1_minus_q3_1;
    let mut sin_q1_minus_q3_last = sin_q1_minus_q3_1;
    let mut cos_q1_minus_q3_last = cos_q1_minus_q3_1;
    let mut s4_of_place_last = s4_of_place_1;
    let mut s2_last = s2_1;
    let mut c2_last = c2_1;
    let mut q2_minus_q3_last = q2_minus_q3_1;
    let mut sin_q2_minus_q3_last = sin_q2_minus_q3_1;
    let mut cos_q2_minus_q3_last = cos_q2_minus_q3_1;
    let mut s5_of_place_last = s5_of_place_1;
    let mut u1_sq_last = u1_sq_1;
    let mut u2_sq_last = u2_sq_1;
    let mut r6_of_u1_u2_last = r6_of_u1_u2_1;
    let mut u3_sq_last = u3_sq_1;
    let mut r6_of_u1_u2_u3_last = r6_of_u1_u2_u3_1;
    let mut q1_minus_q2_last = q1_minus_q2_1;
    let mut sin_q1_minus_q2_last = sin_q1_minus_q2_1;
    let mut cos_q1_minus_q2_last = cos_q1_minus_q2_1;
    let mut l14_of_place_last = l14_of_place_1;
    let mut s8_minus_s4_l14_last = s8_minus_s4_l14_1;
    let mut s9_minus_s5_l14_last = s9_minus_s5_l14_1;
    let mut r10_minus_r6_l14_last = r10_minus_r6_l14_1;
    let mut l18_of_place_last = l18_of_place_1;
    let mut l21_of_place_last = l21_of_place_1;
    let mut s19_minus_s16_l21_last = s19_minus_s16_l21_1;
    let mut u2_dot_2_last = u2_dot_2_1;
    let mut u1_dot_2_last = u1_dot_2_1;
    let mut u0_dot_2_last = u0_dot_2_1;
    let mut next = [S::int(0); 56];
    // Rates at order k - 1.
    let mut q0_rate = u0_1;
    let mut q1_rate = u1_1;
    let mut q2_rate = u2_1;
    let mut q3_rate = u3_1;
    let mut u0_rate = u0_dot_2_1;
    let mut u1_rate = u1_dot_2_1;
    let mut u2_rate = u2_dot_2_1;
    let mut u3_rate = weight_3 * u3_dot_of_motion_2_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q0 = q0_rate * over_k;
        let q1 = q1_rate * over_k;
        let q2 = q2_rate * over_k;
        let q3 = q3_rate * over_k;
        let u0 = u0_rate * over_k;
        let u1 = u1_rate * over_k;
        let u2 = u2_rate * over_k;
        let u3 = u3_rate * over_k;
        series[order] = [q0, q1, q2, q3, u0, u1, u2, u3];
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
                q3_1.mul_add(c3_last, (count_last * q3_last).mul_add(c3_1, next[0])),
                q3_1.mul_add(s3_2_last, (count_last * q3_last).mul_add(s3_2_1, next[1])),
                (c3_1 + c3_1).mul_add(c3_last, next[2]),
                q1_1.mul_add(c1_last, (count_last * q1_last).mul_add(c1_1, next[3])),
                q1_1.mul_add(s1_last, (count_last * q1_last).mul_add(s1_1, next[4])),
                q1_minus_q3_1
                    .mul_add(
                        cos_q1_minus_q3_last,
                        (count_last * q1_minus_q3_last)
                            .mul_add(cos_q1_minus_q3_1, next[5]),
                    ),
                q1_minus_q3_1
                    .mul_add(
                        sin_q1_minus_q3_last,
                        (count_last * q1_minus_q3_last)
                            .mul_add(sin_q1_minus_q3_1, next[6]),
                    ),
                cos_q1_minus_q3_1
                    .mul_add(c3_last, cos_q1_minus_q3_last.mul_add(c3_1, next[7])),
                q2_1.mul_add(c2_last, (count_last * q2_last).mul_add(c2_1, next[8])),
                q2_1.mul_add(s2_last, (count_last * q2_last).mul_add(s2_1, next[9])),
                q2_minus_q3_1
                    .mul_add(
                        cos_q2_minus_q3_last,
                        (count_last * q2_minus_q3_last)
                            .mul_add(cos_q2_minus_q3_1, next[10]),
                    ),
                q2_minus_q3_1
                    .mul_add(
                        sin_q2_minus_q3_last,
                        (count_last * q2_minus_q3_last)
                            .mul_add(sin_q2_minus_q3_1, next[11]),
                    ),
                cos_q2_minus_q3_1
                    .mul_add(c3_last, cos_q2_minus_q3_last.mul_add(c3_1, next[12])),
                (u1_1 + u1_1).mul_add(u1_last, next[13]),
                s1_1.mul_add(u1_sq_last, s1_last.mul_add(u1_sq_1, next[14])),
                (u2_1 + u2_1).mul_add(u2_last, next[15]),
                s2_1.mul_add(u2_sq_last, s2_last.mul_add(u2_sq_1, next[16])),
                sin_q1_minus_q3_1
                    .mul_add(
                        u1_sq_last,
                        sin_q1_minus_q3_last.mul_add(u1_sq_1, next[17]),
                    ),
                sin_q2_minus_q3_1
                    .mul_add(
                        u2_sq_last,
                        sin_q2_minus_q3_last.mul_add(u2_sq_1, next[18]),
                    ),
                r6_of_u1_u2_1.mul_add(c3_last, r6_of_u1_u2_last.mul_add(c3_1, next[19])),
                (u3_1 + u3_1).mul_add(u3_last, next[20]),
                s3_2_1.mul_add(u3_sq_last, s3_2_last.mul_add(u3_sq_1, next[21])),
                (cos_q1_minus_q3_1 + cos_q1_minus_q3_1)
                    .mul_add(cos_q1_minus_q3_last, next[22]),
                q1_minus_q2_1
                    .mul_add(
                        cos_q1_minus_q2_last,
                        (count_last * q1_minus_q2_last)
                            .mul_add(cos_q1_minus_q2_1, next[23]),
                    ),
                q1_minus_q2_1
                    .mul_add(
                        sin_q1_minus_q2_last,
                        (count_last * q1_minus_q2_last)
                            .mul_add(sin_q1_minus_q2_1, next[24]),
                    ),
                cos_q2_minus_q3_1
                    .mul_add(
                        cos_q1_minus_q3_last,
                        cos_q2_minus_q3_last.mul_add(cos_q1_minus_q3_1, next[25]),
                    ),
                sin_q1_minus_q2_1
                    .mul_add(
                        u2_sq_last,
                        sin_q1_minus_q2_last.mul_add(u2_sq_1, next[26]),
                    ),
                r6_of_u1_u2_1
                    .mul_add(
                        cos_q1_minus_q3_last,
                        r6_of_u1_u2_last.mul_add(cos_q1_minus_q3_1, next[27]),
                    ),
                sin_q1_minus_q3_1
                    .mul_add(
                        u3_sq_last,
                        sin_q1_minus_q3_last.mul_add(u3_sq_1, next[28]),
                    ),
                (cos_q2_minus_q3_1 + cos_q2_minus_q3_1)
                    .mul_add(cos_q2_minus_q3_last, next[29]),
                sin_q1_minus_q2_1
                    .mul_add(
                        u1_sq_last,
                        sin_q1_minus_q2_last.mul_add(u1_sq_1, next[30]),
                    ),
                r6_of_u1_u2_1
                    .mul_add(
                        cos_q2_minus_q3_last,
                        r6_of_u1_u2_last.mul_add(cos_q2_minus_q3_1, next[31]),
                    ),
                sin_q2_minus_q3_1
                    .mul_add(
                        u3_sq_last,
                        sin_q2_minus_q3_last.mul_add(u3_sq_1, next[32]),
                    ),
                s3_of_place_1
                    .mul_add(
                        l14_of_place_last,
                        s3_of_place_last.mul_add(l14_of_place_1, next[33]),
                    ),
                s4_of_place_1
                    .mul_add(
                        l14_of_place_last,
                        s4_of_place_last.mul_add(l14_of_place_1, next[34]),
                    ),
                s5_of_place_1
                    .mul_add(
                        l14_of_place_last,
                        s5_of_place_last.mul_add(l14_of_place_1, next[35]),
                    ),
                r6_of_u1_u2_u3_1
                    .mul_add(
                        l14_of_place_last,
                        r6_of_u1_u2_u3_last.mul_add(l14_of_place_1, next[36]),
                    ),
                s3_of_place_1
                    .mul_add(
                        l18_of_place_last,
                        s3_of_place_last.mul_add(l18_of_place_1, next[37]),
                    ),
                s5_of_place_1
                    .mul_add(
                        l18_of_place_last,
                        s5_of_place_last.mul_add(l18_of_place_1, next[38]),
                    ),
                r6_of_u1_u2_u3_1
                    .mul_add(
                        l18_of_place_last,
                        r6_of_u1_u2_u3_last.mul_add(l18_of_place_1, next[39]),
                    ),
                s8_minus_s4_l14_1
                    .mul_add(
                        l21_of_place_last,
                        s8_minus_s4_l14_last.mul_add(l21_of_place_1, next[40]),
                    ),
                s9_minus_s5_l14_1
                    .mul_add(
                        l21_of_place_last,
                        s9_minus_s5_l14_last.mul_add(l21_of_place_1, next[41]),
                    ),
                r10_minus_r6_l14_1
                    .mul_add(
                        l21_of_place_last,
                        r10_minus_r6_l14_last.mul_add(l21_of_place_1, next[42]),
                    ),
                s19_minus_s16_l21_1
                    .mul_add(
                        u2_dot_2_last,
                        s19_minus_s16_l21_last.mul_add(u2_dot_2_1, next[43]),
                    ),
                u2_dot_2_1
                    .mul_add(
                        s9_minus_s5_l14_last,
                        u2_dot_2_last.mul_add(s9_minus_s5_l14_1, next[44]),
                    ),
                s8_minus_s4_l14_1
                    .mul_add(
                        u1_dot_2_last,
                        s8_minus_s4_l14_last.mul_add(u1_dot_2_1, next[45]),
                    ),
                u1_dot_2_1
                    .mul_add(
                        s4_of_place_last,
                        u1_dot_2_last.mul_add(s4_of_place_1, next[46]),
                    ),
                u2_dot_2_1
                    .mul_add(
                        s5_of_place_last,
                        u2_dot_2_last.mul_add(s5_of_place_1, next[47]),
                    ),
                s3_of_place_1
                    .mul_add(
                        u0_dot_2_last,
                        s3_of_place_last.mul_add(u0_dot_2_1, next[48]),
                    ),
                u1_dot_2_1
                    .mul_add(
                        cos_q1_minus_q3_last,
                        u1_dot_2_last.mul_add(cos_q1_minus_q3_1, next[49]),
                    ),
                u2_dot_2_1
                    .mul_add(
                        cos_q2_minus_q3_last,
                        u2_dot_2_last.mul_add(cos_q2_minus_q3_1, next[50]),
                    ),
                u0_dot_2_1.mul_add(c3_last, u0_dot_2_last.mul_add(c3_1, next[51])),
            ])
        };
        // s3_2 = sin(q3)
        let s3_2 = q3.mul_add(c3_0, sums[0] * over_k);
        // c3 = cos(q3)
        let c3 = -q3.mul_add(s3_2_0, sums[1] * over_k);
        // c3_sq = c3*c3
        let c3_sq = c3.mul_add(c3_0 + c3_0, sums[2]);
        // s3_of_place = weight + minus_m3*c3_sq
        let s3_of_place = minus_m3 * c3_sq;
        // s1 = sin(q1)
        let s1 = q1.mul_add(c1_0, sums[3] * over_k);
        // c1 = cos(q1)
        let c1 = -q1.mul_add(s1_0, sums[4] * over_k);
        // q1_minus_q3 = q1 - q3
        let q1_minus_q3 = q1 - q3;
        // sin_q1_minus_q3 = sin(q1_minus_q3)
        let sin_q1_minus_q3 = q1_minus_q3.mul_add(cos_q1_minus_q3_0, sums[5] * over_k);
        // cos_q1_minus_q3 = cos(q1_minus_q3)
        let cos_q1_minus_q3 = -q1_minus_q3.mul_add(sin_q1_minus_q3_0, sums[6] * over_k);
        // c3_cos_q1_minus_q3 = cos_q1_minus_q3*c3
        let c3_cos_q1_minus_q3 = cos_q1_minus_q3
            .mul_add(c3_0, c3.mul_add(cos_q1_minus_q3_0, sums[7]));
        // s4_of_place = minus_m3*c3_cos_q1_minus_q3 + m1_plus_m2_plus_m3*c1
        let s4_of_place = c3_cos_q1_minus_q3.mul_add(minus_m3, m1_plus_m2_plus_m3 * c1);
        // s2 = sin(q2)
        let s2 = q2.mul_add(c2_0, sums[8] * over_k);
        // c2 = cos(q2)
        let c2 = -q2.mul_add(s2_0, sums[9] * over_k);
        // q2_minus_q3 = q2 - q3
        let q2_minus_q3 = q2 - q3;
        // sin_q2_minus_q3 = sin(q2_minus_q3)
        let sin_q2_minus_q3 = q2_minus_q3.mul_add(cos_q2_minus_q3_0, sums[10] * over_k);
        // cos_q2_minus_q3 = cos(q2_minus_q3)
        let cos_q2_minus_q3 = -q2_minus_q3.mul_add(sin_q2_minus_q3_0, sums[11] * over_k);
        // c3_cos_q2_minus_q3 = cos_q2_minus_q3*c3
        let c3_cos_q2_minus_q3 = cos_q2_minus_q3
            .mul_add(c3_0, c3.mul_add(cos_q2_minus_q3_0, sums[12]));
        // s5_of_place = minus_m3*c3_cos_q2_minus_q3 + m2_plus_m3*c2
        let s5_of_place = c3_cos_q2_minus_q3.mul_add(minus_m3, m2_plus_m3 * c2);
        // u1_sq = u1*u1
        let u1_sq = u1.mul_add(u1_0 + u1_0, sums[13]);
        // u1_sq_s1 = s1*u1_sq
        let u1_sq_s1 = u1_sq.mul_add(s1_0, s1.mul_add(u1_sq_0, sums[14]));
        // u2_sq = u2*u2
        let u2_sq = u2.mul_add(u2_0 + u2_0, sums[15]);
        // u2_sq_s2 = s2*u2_sq
        let u2_sq_s2 = u2_sq.mul_add(s2_0, s2.mul_add(u2_sq_0, sums[16]));
        // u1_sq_sin_q1_minus_q3 = sin_q1_minus_q3*u1_sq
        let u1_sq_sin_q1_minus_q3 = sin_q1_minus_q3
            .mul_add(u1_sq_0, u1_sq.mul_add(sin_q1_minus_q3_0, sums[17]));
        // u2_sq_sin_q2_minus_q3 = sin_q2_minus_q3*u2_sq
        let u2_sq_sin_q2_minus_q3 = sin_q2_minus_q3
            .mul_add(u2_sq_0, u2_sq.mul_add(sin_q2_minus_q3_0, sums[18]));
        // r6_of_u1_u2 = l0*u1_sq_sin_q1_minus_q3 + l1*u2_sq_sin_q2_minus_q3 + g*s3_2
        let r6_of_u1_u2 = u2_sq_sin_q2_minus_q3
            .mul_add(l1, u1_sq_sin_q1_minus_q3.mul_add(l0, g * s3_2));
        // r6_of_u1_u2_2 = r6_of_u1_u2*c3
        let r6_of_u1_u2_2 = r6_of_u1_u2
            .mul_add(c3_0, c3.mul_add(r6_of_u1_u2_0, sums[19]));
        // u3_sq = u3*u3
        let u3_sq = u3.mul_add(u3_0 + u3_0, sums[20]);
        // u3_sq_s3_2 = s3_2*u3_sq
        let u3_sq_s3_2 = u3_sq.mul_add(s3_2_0, s3_2.mul_add(u3_sq_0, sums[21]));
        // r6_of_u1_u2_u3 = F + weight_2*u1_sq_s1 + minus_l1_m2_plus_m3*u2_sq_s2 + m3*r6_of_u1_u2_2 +
        //   minus_m3_l2*u3_sq_s3_2
        let r6_of_u1_u2_u3 = r6_of_u1_u2_2
            .mul_add(
                m3,
                u3_sq_s3_2
                    .mul_add(
                        minus_m3_l2,
                        u2_sq_s2.mul_add(minus_l1_m2_plus_m3, weight_2 * u1_sq_s1),
                    ),
            );
        // cos_q1_minus_q3_sq = cos_q1_minus_q3*cos_q1_minus_q3
        let cos_q1_minus_q3_sq = cos_q1_minus_q3
            .mul_add(cos_q1_minus_q3_0 + cos_q1_minus_q3_0, sums[22]);
        // q1_minus_q2 = q1 - q2
        let q1_minus_q2 = q1 - q2;
        // sin_q1_minus_q2 = sin(q1_minus_q2)
        let sin_q1_minus_q2 = q1_minus_q2.mul_add(cos_q1_minus_q2_0, sums[23] * over_k);
        // cos_q1_minus_q2 = cos(q1_minus_q2)
        let cos_q1_minus_q2 = -q1_minus_q2.mul_add(sin_q1_minus_q2_0, sums[24] * over_k);
        // s9_of_q1_q2_q3 = cos_q2_minus_q3*cos_q1_minus_q3
        let s9_of_q1_q2_q3 = cos_q1_minus_q3
            .mul_add(
                cos_q2_minus_q3_0,
                cos_q2_minus_q3.mul_add(cos_q1_minus_q3_0, sums[25]),
            );
        // u2_sq_sin_q1_minus_q2 = sin_q1_minus_q2*u2_sq
        let u2_sq_sin_q1_minus_q2 = sin_q1_minus_q2
            .mul_add(u2_sq_0, u2_sq.mul_add(sin_q1_minus_q2_0, sums[26]));
        // r10_of_u1_u2 = r6_of_u1_u2*cos_q1_minus_q3
        let r10_of_u1_u2 = r6_of_u1_u2
            .mul_add(
                cos_q1_minus_q3_0,
                cos_q1_minus_q3.mul_add(r6_of_u1_u2_0, sums[27]),
            );
        // u3_sq_sin_q1_minus_q3 = sin_q1_minus_q3*u3_sq
        let u3_sq_sin_q1_minus_q3 = sin_q1_minus_q3
            .mul_add(u3_sq_0, u3_sq.mul_add(sin_q1_minus_q3_0, sums[28]));
        // cos_q2_minus_q3_sq = cos_q2_minus_q3*cos_q2_minus_q3
        let cos_q2_minus_q3_sq = cos_q2_minus_q3
            .mul_add(cos_q2_minus_q3_0 + cos_q2_minus_q3_0, sums[29]);
        // u1_sq_sin_q1_minus_q2 = sin_q1_minus_q2*u1_sq
        let u1_sq_sin_q1_minus_q2 = sin_q1_minus_q2
            .mul_add(u1_sq_0, u1_sq.mul_add(sin_q1_minus_q2_0, sums[30]));
        // r13_of_u1_u2 = r6_of_u1_u2*cos_q2_minus_q3
        let r13_of_u1_u2 = r6_of_u1_u2
            .mul_add(
                cos_q2_minus_q3_0,
                cos_q2_minus_q3.mul_add(r6_of_u1_u2_0, sums[31]),
            );
        // u3_sq_sin_q2_minus_q3 = sin_q2_minus_q3*u3_sq
        let u3_sq_sin_q2_minus_q3 = sin_q2_minus_q3
            .mul_add(u3_sq_0, u3_sq.mul_add(sin_q2_minus_q3_0, sums[32]));
        // l14_of_place = s4_of_place/s3_of_place
        let l14_of_place = s4_of_place
            .mul_add(
                over_s3_of_place,
                -(s3_of_place.mul_add(l14_of_place_0, sums[33]) * over_s3_of_place),
            );
        // s15_of_place = s4_of_place*l14_of_place
        let s15_of_place = l14_of_place
            .mul_add(s4_of_place_0, s4_of_place.mul_add(l14_of_place_0, sums[34]));
        // s8_minus_s4_l14 = l0_2_m1_plus_m2_plus_m3 + minus_m3_l0_2*cos_q1_minus_q3_sq +
        //   minus_l0_2*s15_of_place
        let s8_minus_s4_l14 = s15_of_place
            .mul_add(minus_l0_2, minus_m3_l0_2 * cos_q1_minus_q3_sq);
        // s16_of_place = s5_of_place*l14_of_place
        let s16_of_place = l14_of_place
            .mul_add(s5_of_place_0, s5_of_place.mul_add(l14_of_place_0, sums[35]));
        // s9_minus_s5_l14 = minus_m3_l0_l1*s9_of_q1_q2_q3 + l0_l1_m2_plus_m3*cos_q1_minus_q2 +
        //   minus_l0_l1*s16_of_place
        let s9_minus_s5_l14 = s16_of_place
            .mul_add(
                minus_l0_l1,
                s9_of_q1_q2_q3
                    .mul_add(minus_m3_l0_l1, l0_l1_m2_plus_m3 * cos_q1_minus_q2),
            );
        // r17_of_u1_u2_u3 = r6_of_u1_u2_u3*l14_of_place
        let r17_of_u1_u2_u3 = r6_of_u1_u2_u3
            .mul_add(l14_of_place_0, l14_of_place.mul_add(r6_of_u1_u2_u3_0, sums[36]));
        // r10_minus_r6_l14 = minus_m3_l0*r10_of_u1_u2 + minus_m3_l0_l2*u3_sq_sin_q1_minus_q3 +
        //   minus_l0_l1_m2_plus_m3*u2_sq_sin_q1_minus_q2 + l0_g_m1_plus_m2_plus_m3*s1 + l0*r17_of_u1_u2_u3
        let r10_minus_r6_l14 = r17_of_u1_u2_u3
            .mul_add(
                l0,
                r10_of_u1_u2
                    .mul_add(
                        minus_m3_l0,
                        u2_sq_sin_q1_minus_q2
                            .mul_add(
                                minus_l0_l1_m2_plus_m3,
                                u3_sq_sin_q1_minus_q3
                                    .mul_add(minus_m3_l0_l2, l0_g_m1_plus_m2_plus_m3 * s1),
                            ),
                    ),
            );
        // l18_of_place = s5_of_place/s3_of_place
        let l18_of_place = s5_of_place
            .mul_add(
                over_s3_of_place,
                -(s3_of_place.mul_add(l18_of_place_0, sums[37]) * over_s3_of_place),
            );
        // s19_of_place = s5_of_place*l18_of_place
        let s19_of_place = l18_of_place
            .mul_add(s5_of_place_0, s5_of_place.mul_add(l18_of_place_0, sums[38]));
        // r20_of_u1_u2_u3 = r6_of_u1_u2_u3*l18_of_place
        let r20_of_u1_u2_u3 = r6_of_u1_u2_u3
            .mul_add(l18_of_place_0, l18_of_place.mul_add(r6_of_u1_u2_u3_0, sums[39]));
        // l21_of_place = s9_minus_s5_l14/s8_minus_s4_l14
        let l21_of_place = s8_minus_s4_l14
            .mul_add(
                -(l21_of_place_0 * over_s8_minus_s4_l14),
                (s9_minus_s5_l14 - sums[40]) * over_s8_minus_s4_l14,
            );
        // s22_of_place = s9_minus_s5_l14*l21_of_place
        let s22_of_place = l21_of_place
            .mul_add(
                s9_minus_s5_l14_0,
                s9_minus_s5_l14.mul_add(l21_of_place_0, sums[41]),
            );
        // s19_minus_s16_l21 = l1_2_m2_plus_m3 + minus_m3_l1_2*cos_q2_minus_q3_sq + minus_l1_2*s19_of_place
        //   - s22_of_place
        let s19_minus_s16_l21 = s19_of_place
            .mul_add(minus_l1_2, minus_m3_l1_2 * cos_q2_minus_q3_sq) - s22_of_place;
        // r23_of_place = r10_minus_r6_l14*l21_of_place
        let r23_of_place = l21_of_place
            .mul_add(
                r10_minus_r6_l14_0,
                r10_minus_r6_l14.mul_add(l21_of_place_0, sums[42]),
            );
        // r20_minus_r17_l21 = minus_m3_l1*r13_of_u1_u2 + minus_m3_l1_l2*u3_sq_sin_q2_minus_q3 +
        //   l0_l1_m2_plus_m3*u1_sq_sin_q1_minus_q2 + l1_g_m2_plus_m3*s2 + l1*r20_of_u1_u2_u3 - r23_of_place
        let r20_minus_r17_l21 = r20_of_u1_u2_u3
            .mul_add(
                l1,
                r13_of_u1_u2
                    .mul_add(
                        minus_m3_l1,
                        u1_sq_sin_q1_minus_q2
                            .mul_add(
                                l0_l1_m2_plus_m3,
                                u3_sq_sin_q2_minus_q3
                                    .mul_add(minus_m3_l1_l2, l1_g_m2_plus_m3 * s2),
                            ),
                    ),
            ) - r23_of_place;
        // u2_dot_2 = r20_minus_r17_l21/s19_minus_s16_l21
        let u2_dot_2 = s19_minus_s16_l21
            .mul_add(
                -(u2_dot_2_0 * over_s19_minus_s16_l21),
                (r20_minus_r17_l21 - sums[43]) * over_s19_minus_s16_l21,
            );
        // u1_dot_of_place = u2_dot_2*s9_minus_s5_l14
        let u1_dot_of_place = u2_dot_2
            .mul_add(s9_minus_s5_l14_0, s9_minus_s5_l14.mul_add(u2_dot_2_0, sums[44]));
        // r17_minus_u2_dot_s16 = r10_minus_r6_l14 - u1_dot_of_place
        let r17_minus_u2_dot_s16 = r10_minus_r6_l14 - u1_dot_of_place;
        // u1_dot_2 = r17_minus_u2_dot_s16/s8_minus_s4_l14
        let u1_dot_2 = r17_minus_u2_dot_s16
            .mul_add(
                over_s8_minus_s4_l14,
                -(s8_minus_s4_l14.mul_add(u1_dot_2_0, sums[45]) * over_s8_minus_s4_l14),
            );
        // u0_dot_of_u2_dot = u1_dot_2*s4_of_place
        let u0_dot_of_u2_dot = u1_dot_2
            .mul_add(s4_of_place_0, s4_of_place.mul_add(u1_dot_2_0, sums[46]));
        // u0_dot_of_place = u2_dot_2*s5_of_place
        let u0_dot_of_place = u2_dot_2
            .mul_add(s5_of_place_0, s5_of_place.mul_add(u2_dot_2_0, sums[47]));
        // u0_dot_of_motion = r6_of_u1_u2_u3 + l0*u0_dot_of_u2_dot + l1*u0_dot_of_place
        let u0_dot_of_motion = u0_dot_of_u2_dot
            .mul_add(l0, u0_dot_of_place.mul_add(l1, r6_of_u1_u2_u3));
        // u0_dot_2 = u0_dot_of_motion/s3_of_place
        let u0_dot_2 = u0_dot_of_motion
            .mul_add(
                over_s3_of_place,
                -(s3_of_place.mul_add(u0_dot_2_0, sums[48]) * over_s3_of_place),
            );
        // u3_dot_of_u2_dot = u1_dot_2*cos_q1_minus_q3
        let u3_dot_of_u2_dot = u1_dot_2
            .mul_add(cos_q1_minus_q3_0, cos_q1_minus_q3.mul_add(u1_dot_2_0, sums[49]));
        // u3_dot_of_place = u2_dot_2*cos_q2_minus_q3
        let u3_dot_of_place = u2_dot_2
            .mul_add(cos_q2_minus_q3_0, cos_q2_minus_q3.mul_add(u2_dot_2_0, sums[50]));
        // u3_dot_of_motion = u0_dot_2*c3
        let u3_dot_of_motion = u0_dot_2.mul_add(c3_0, c3.mul_add(u0_dot_2_0, sums[51]));
        // u3_dot_of_motion_2 = g*s3_2 + l0*u1_sq_sin_q1_minus_q3 + minus_l0*u3_dot_of_u2_dot +
        //   l1*u2_sq_sin_q2_minus_q3 + minus_l1*u3_dot_of_place + u3_dot_of_motion
        let u3_dot_of_motion_2 = u3_dot_of_u2_dot
            .mul_add(
                minus_l0,
                u3_dot_of_place
                    .mul_add(
                        minus_l1,
                        u2_sq_sin_q2_minus_q3
                            .mul_add(l1, u1_sq_sin_q1_minus_q3.mul_add(l0, g * s3_2)),
                    ),
            ) + u3_dot_of_motion;
        q0_rate = u0;
        q1_rate = u1;
        q2_rate = u2;
        q3_rate = u3;
        u0_rate = u0_dot_2;
        u1_rate = u1_dot_2;
        u2_rate = u2_dot_2;
        u3_rate = weight_3 * u3_dot_of_motion_2;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * q3,
                count * q3,
                c3,
                count * q1,
                count * q1,
                count * q1_minus_q3,
                count * q1_minus_q3,
                cos_q1_minus_q3,
                count * q2,
                count * q2,
                count * q2_minus_q3,
                count * q2_minus_q3,
                cos_q2_minus_q3, u1, s1, u2, s2, sin_q1_minus_q3, sin_q2_minus_q3, r6_of_u1_u2, u3,
                s3_2, cos_q1_minus_q3,
                count * q1_minus_q2,
                count * q1_minus_q2,
                cos_q2_minus_q3, sin_q1_minus_q2, r6_of_u1_u2, sin_q1_minus_q3, cos_q2_minus_q3,
                sin_q1_minus_q2, r6_of_u1_u2, sin_q2_minus_q3, s3_of_place, s4_of_place,
                s5_of_place, r6_of_u1_u2_u3, s3_of_place, s5_of_place, r6_of_u1_u2_u3,
                s8_minus_s4_l14, s9_minus_s5_l14, r10_minus_r6_l14, s19_minus_s16_l21, u2_dot_2,
                s8_minus_s4_l14, u1_dot_2, u2_dot_2, s3_of_place, u1_dot_2, u2_dot_2, u0_dot_2,
            ]),
            padded([
                c3, s3_2, c3, c1, s1, cos_q1_minus_q3, sin_q1_minus_q3, c3, c2, s2, cos_q2_minus_q3,
                sin_q2_minus_q3, c3, u1, u1_sq, u2, u2_sq, u1_sq, u2_sq, c3, u3, u3_sq,
                cos_q1_minus_q3, cos_q1_minus_q2, sin_q1_minus_q2, cos_q1_minus_q3, u2_sq,
                cos_q1_minus_q3, u3_sq, cos_q2_minus_q3, u1_sq, cos_q2_minus_q3, u3_sq,
                l14_of_place, l14_of_place, l14_of_place, l14_of_place, l18_of_place, l18_of_place,
                l18_of_place, l21_of_place, l21_of_place, l21_of_place, u2_dot_2, s9_minus_s5_l14,
                u1_dot_2, s4_of_place, s5_of_place, u0_dot_2, cos_q1_minus_q3, cos_q2_minus_q3, c3,
            ]),
        ];
        count_last = count;
        q1_last = q1;
        q2_last = q2;
        q3_last = q3;
        u1_last = u1;
        u2_last = u2;
        u3_last = u3;
        s3_2_last = s3_2;
        c3_last = c3;
        s3_of_place_last = s3_of_place;
        s1_last = s1;
        c1_last = c1;
        q1_minus_q3_last = q1_minus_q3;
        sin_q1_minus_q3_last = sin_q1_minus_q3;
        cos_q1_minus_q3_last = cos_q1_minus_q3;
        s4_of_place_last = s4_of_place;
        s2_last = s2;
        c2_last = c2;
        q2_minus_q3_last = q2_minus_q3;
        sin_q2_minus_q3_last = sin_q2_minus_q3;
        cos_q2_minus_q3_last = cos_q2_minus_q3;
        s5_of_place_last = s5_of_place;
        u1_sq_last = u1_sq;
        u2_sq_last = u2_sq;
        r6_of_u1_u2_last = r6_of_u1_u2;
        u3_sq_last = u3_sq;
        r6_of_u1_u2_u3_last = r6_of_u1_u2_u3;
        q1_minus_q2_last = q1_minus_q2;
        sin_q1_minus_q2_last = sin_q1_minus_q2;
        cos_q1_minus_q2_last = cos_q1_minus_q2;
        l14_of_place_last = l14_of_place;
        s8_minus_s4_l14_last = s8_minus_s4_l14;
        s9_minus_s5_l14_last = s9_minus_s5_l14;
        r10_minus_r6_l14_last = r10_minus_r6_l14;
        l18_of_place_last = l18_of_place;
        l21_of_place_last = l21_of_place;
        s19_minus_s16_l21_last = s19_minus_s16_l21;
        u2_dot_2_last = u2_dot_2;
        u1_dot_2_last = u1_dot_2;
        u0_dot_2_last = u0_dot_2;
    }
}

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
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
        out.copy_from_slice(
            jacobian(&Parameters::from_slice(p), array(q), array(v)).as_flattened(),
        );
    }
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, order: usize) -> usize {
        112 * order + SLACK
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
    fn generalized_speeds(&self, _p: &[S], _q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(v);
    }
    fn generalized_speed_rates(
        &self,
        _p: &[S],
        _q: &[S],
        _v: &[S],
        v_dot: &[S],
        out: &mut [S],
    ) {
        out.copy_from_slice(v_dot);
    }
    fn motion_variables(&self, _p: &[S], _q: &[S], u: &[S], out: &mut [S]) {
        out.copy_from_slice(u);
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
