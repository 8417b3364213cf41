//! Three-link pendulum on a cart: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/cart_pendulum_3/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

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

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    u: &[S; 4],
    direction: &[S; 8],
) -> [S; 8] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[4 + i],
    });
    let (of_q, of_v) = derivative(&p, &q, &v);
    let mut slopes = of_q.into_iter().chain(of_v).map(|rate| rate.slope);
    core::array::from_fn(|_| {
        slopes.next().expect("a slope for each component of the state")
    })
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
    slice.try_into().expect("a slice of the length that `System` requires")
}
