//! Three-link pendulum on a cart: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/cart_pendulum_3/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{coordinate_rates, kinetic_energy, potential_energy};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows cart force n1, cart force n2, bob1 force n1, bob1 force n2, bob2 force n1, bob2 force n2, bob3 force n1, bob3 force n2.
///
/// 36 operations, 3 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    _u: &[S; 4],
) -> [[S; 8]; 8] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, .. } = *p;
    let [_, q1, q2, q3] = *q;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    // Shared terms.
    let l0_c1 = l0 * c1;
    let l0_s1 = l0 * s1;
    let l1_c2 = l1 * c2;
    let l1_s2 = l1 * s2;
    let m3_l2 = m3 * l2;
    // Entries that are not zero.
    // M11 = m0
    let m11 = m0;
    // M16 = -sin(q1)
    let m16 = -s1;
    // M25 = -1
    let m25 = -S::int(1);
    // M26 = cos(q1)
    let m26 = c1;
    // M31 = m1
    let m31 = m1;
    // M32 = -m1*l0*cos(q1)
    let m32 = -m1 * l0_c1;
    // M36 = sin(q1)
    let m36 = s1;
    // M37 = -sin(q2)
    let m37 = -s2;
    // M42 = -m1*l0*sin(q1)
    let m42 = -m1 * l0_s1;
    // M46 = -cos(q1)
    let m46 = -c1;
    // M47 = cos(q2)
    let m47 = c2;
    // M51 = m2
    let m51 = m2;
    // M52 = -m2*l0*cos(q1)
    let m52 = -m2 * l0_c1;
    // M53 = -m2*l1*cos(q2)
    let m53 = -m2 * l1_c2;
    // M57 = sin(q2)
    let m57 = s2;
    // M58 = -sin(q3)
    let m58 = -s3_2;
    // M62 = -m2*l0*sin(q1)
    let m62 = -m2 * l0_s1;
    // M63 = -m2*l1*sin(q2)
    let m63 = -m2 * l1_s2;
    // M67 = -cos(q2)
    let m67 = -c2;
    // M68 = cos(q3)
    let m68 = c3;
    // M71 = m3
    let m71 = m3;
    // M72 = -m3*l0*cos(q1)
    let m72 = -m3 * l0_c1;
    // M73 = -m3*l1*cos(q2)
    let m73 = -m3 * l1_c2;
    // M74 = -m3*l2*cos(q3)
    let m74 = -m3_l2 * c3;
    // M78 = sin(q3)
    let m78 = s3_2;
    // M82 = -m3*l0*sin(q1)
    let m82 = -m3 * l0_s1;
    // M83 = -m3*l1*sin(q2)
    let m83 = -m3 * l1_s2;
    // M84 = -m3*l2*sin(q3)
    let m84 = -m3_l2 * s3_2;
    // M88 = -cos(q3)
    let m88 = -c3;
    let zero = S::int(0);
    [
        [m11, zero, zero, zero, zero, m16, zero, zero],
        [zero, zero, zero, zero, m25, m26, zero, zero],
        [m31, m32, zero, zero, zero, m36, m37, zero],
        [zero, m42, zero, zero, zero, m46, m47, zero],
        [m51, m52, m53, zero, zero, zero, m57, m58],
        [zero, m62, m63, zero, zero, zero, m67, m68],
        [m71, m72, m73, m74, zero, zero, zero, m78],
        [zero, m82, m83, m84, zero, zero, zero, m88],
    ]
}

/// Right-hand side of the linear system; unknowns (u0', u1', u2', u3', rail, T1, T2, T3).
///
/// 30 operations, 3 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [S; 8] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, u1, u2, u3] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    // Shared terms.
    let l0_u1_sq = l0 * u1 * u1;
    let s1_l0_u1_sq = l0_u1_sq * s1;
    // g - l0_u1_sq*cos(q1)
    let g_minus_c1_l0_u1_sq = (-l0_u1_sq).mul_add(c1, g);
    let l1_u2_sq = l1 * u2 * u2;
    // s1_l0_u1_sq + l1_u2_sq*sin(q2)
    let f5_of_u1_u2 = l1_u2_sq.mul_add(s2, s1_l0_u1_sq);
    // g_minus_c1_l0_u1_sq - l1_u2_sq*cos(q2)
    let f6_of_u1_u2 = (-l1_u2_sq).mul_add(c2, g_minus_c1_l0_u1_sq);
    let l2_u3_sq = l2 * u3 * u3;
    // Values.
    // f1 = F
    let f1 = F;
    // f2 = -m0*g
    let f2 = -m0 * g;
    // f3 = -m1*l0*u1^2*sin(q1)
    let f3 = -m1 * s1_l0_u1_sq;
    // f4 = m1*(l0*u1^2*cos(q1) - g)
    let f4 = -m1 * g_minus_c1_l0_u1_sq;
    // f5 = -m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2))
    let f5 = -m2 * f5_of_u1_u2;
    // f6 = m2*(l0*u1^2*cos(q1) - g + l1*u2^2*cos(q2))
    let f6 = -m2 * f6_of_u1_u2;
    // f7 = -m3*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2) + l2*u3^2*sin(q3))
    let f7 = -m3 * l2_u3_sq.mul_add(s3_2, f5_of_u1_u2);
    // f8 = m3*(l0*u1^2*cos(q1) - g + l1*u2^2*cos(q2) + l2*u3^2*cos(q3))
    let f8 = m3 * l2_u3_sq.mul_add(c3, -f6_of_u1_u2);
    [f1, f2, f3, f4, f5, f6, f7, f8]
}

/// The accelerations (u0', u1', u2', u3'), solved for when this code was generated.
///
/// 135 operations, 3 sines and cosines.
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
    let l0_c1 = l0 * c1;
    // l0*(sin(q1)*sin(q3) + cos(q1)*cos(q3))
    let s4_of_l0_q1_q3 = l0 * c1.mul_add(c3, s1 * s3_2);
    // s4 = -l0*(cos(q1)*(m1 + m2 + m3) + m3*l2*l2_*(sin(q1)*sin(q3) + cos(q1)*cos(q3)))
    let s4 = (-l2__m3_l2).mul_add(s4_of_l0_q1_q3, -m1_plus_m2_plus_m3 * l0_c1);
    // sin(q2)*sin(q3) + cos(q2)*cos(q3)
    let s2_s3_2_plus_c2_c3 = c2.mul_add(c3, s2 * s3_2);
    let l1_m3_l2 = l1 * m3_l2;
    let s5_of_place = s2_s3_2_plus_c2_c3 * l1_m3_l2;
    let l1_m2_plus_m3 = l1 * m2_plus_m3;
    let c2_l1_m2_plus_m3 = l1_m2_plus_m3 * c2;
    // s5 = -l1*(cos(q2)*(m2 + m3) + m3*l2*l2_*(sin(q2)*sin(q3) + cos(q2)*cos(q3)))
    let s5 = (-l2_).mul_add(s5_of_place, -c2_l1_m2_plus_m3);
    let l0_s1 = l0 * s1;
    let u1_sq = u1 * u1;
    let l0_s1_u1_sq = l0_s1 * u1_sq;
    let u2_sq = u2 * u2;
    let l1_u2_sq = l1 * u2_sq;
    // l0_s1_u1_sq + l1_u2_sq*sin(q2)
    let r6_of_u1_u2 = l1_u2_sq.mul_add(s2, l0_s1_u1_sq);
    // g*sin(q3) + r6_of_u1_u2*cos(q3)
    let r6_of_u1_u2_2 = r6_of_u1_u2.mul_add(c3, g * s3_2);
    // sin(q3)*(l0_c1*u1_sq + l1_u2_sq*cos(q2)) - r6_of_u1_u2_2
    let r6_of_u1_u2_3 = s3_2 * l1_u2_sq.mul_add(c2, l0_c1 * u1_sq) - r6_of_u1_u2_2;
    let u3_sq = u3 * u3;
    let m3_l2_u3_sq = m3_l2 * u3_sq;
    // r6 = F - m1*l0*u1^2*sin(q1) - m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) - m3*(l0*u1^2*sin(q1) +
    //   l1*u2^2*sin(q2) + l2*(u3^2*sin(q3) + l2_*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g -
    //   l0*u1^2*cos(q1) - l1*u2^2*cos(q2)))))
    let r6 = (-m1).mul_add(l0_s1_u1_sq, F) - m2_plus_m3 * r6_of_u1_u2
        + l2__m3_l2 * r6_of_u1_u2_3 - m3_l2_u3_sq * s3_2;
    // l7 = m3*l0*l2*(sin(q1)*sin(q3) + cos(q1)*cos(q3))/d1
    let l7 = d1_inv_m3_l2 * s4_of_l0_q1_q3;
    let l7_m3_l2 = l7 * m3_l2;
    // s8 = l0*(l0*(m1 + m2 + m3) - m3*l2*l7*(sin(q1)*sin(q3) + cos(q1)*cos(q3)))
    let s8 = (-s4_of_l0_q1_q3).mul_add(l7_m3_l2, l0 * l0 * m1_plus_m2_plus_m3);
    let s2_l1_m2_plus_m3 = l1_m2_plus_m3 * s2;
    // s9 = l1*(m2*l0*(sin(q1)*sin(q2) + cos(q1)*cos(q2)) + m3*(l0*(sin(q1)*sin(q2) + cos(q1)*cos(q2)) -
    //   l2*l7*(sin(q2)*sin(q3) + cos(q2)*cos(q3))))
    let s9 = (-l7).mul_add(s5_of_place, l0_c1 * c2_l1_m2_plus_m3) + l0_s1 * s2_l1_m2_plus_m3;
    // l0*l1_m2_plus_m3*(cos(q1)*sin(q2) - sin(q1)*cos(q2))
    let r10_of_place = l0 * l1_m2_plus_m3 * (-s1).mul_add(c2, c1 * s2);
    // r10 = l0*(m1*g*sin(q1) + m2*(g*sin(q1) - l1*u2^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2))) +
    //   m3*(g*sin(q1) - l1*u2^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2)) - l2*(u3^2*(sin(q1)*cos(q3) -
    //   cos(q1)*sin(q3)) + u1^2*l7*(sin(q1)*cos(q3) - cos(q1)*sin(q3))))) - m3*l2*l7*(g*sin(q3) +
    //   l1*u2^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))
    let r10 = m3_l2_u3_sq * (-l0_s1).mul_add(c3, l0_c1 * s3_2)
        + g * m1_plus_m2_plus_m3 * l0_s1 + r6_of_u1_u2_3 * l7_m3_l2 + u2_sq * r10_of_place;
    // l11 = m3*l1*l2*(sin(q2)*sin(q3) + cos(q2)*cos(q3))/d1
    let l11 = l1 * d1_inv_m3_l2 * s2_s3_2_plus_c2_c3;
    // s12 = l1*(l1*(m2 + m3) - m3*l2*l11*(sin(q2)*sin(q3) + cos(q2)*cos(q3)))
    let s12 = (-l11).mul_add(s5_of_place, l1 * l1_m2_plus_m3);
    // r13 = m2*l1*(g*sin(q2) + l0*u1^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2))) + m3*(l1*(g*sin(q2) +
    //   l0*u1^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2)) - l2*(u3^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   u2^2*l11*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))) - l2*l11*(g*sin(q3) + l0*u1^2*(sin(q1)*cos(q3) -
    //   cos(q1)*sin(q3))))
    let r13 = l1_m3_l2 * u3_sq * (-s2).mul_add(c3, c2 * s3_2)
        + l11 * m3_l2 * r6_of_u1_u2_3 + g * s2_l1_m2_plus_m3 - u1_sq * r10_of_place;
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
    // u3' = m3*l2*(sin(q3)*(g - l0*(u1^2*cos(q1) + u1'*sin(q1)) - l1*(u2^2*cos(q2) + u2'*sin(q2))) +
    //   cos(q3)*(u0' + l0*(u1^2*sin(q1) - u1'*cos(q1)) + l1*(u2^2*sin(q2) - u2'*cos(q2))))/d1
    let u3_dot = d1_inv_m3_l2 * u0_dot.mul_add(c3, -r6_of_u1_u2_3) - u1_dot * l7 - u2_dot * l11;
    [u0_dot, u1_dot, u2_dot, u3_dot]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 135 operations, 3 sines and cosines.
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
    let l0_c1 = l0 * c1;
    // l0*(sin(q1)*sin(q3) + cos(q1)*cos(q3))
    let s4_of_l0_q1_q3 = l0 * c1.mul_add(c3, s1 * s3_2);
    // s4 = -l0*(cos(q1)*(m1 + m2 + m3) + m3*l2*l2_*(sin(q1)*sin(q3) + cos(q1)*cos(q3)))
    let s4 = (-l2__m3_l2).mul_add(s4_of_l0_q1_q3, -m1_plus_m2_plus_m3 * l0_c1);
    // sin(q2)*sin(q3) + cos(q2)*cos(q3)
    let s2_s3_2_plus_c2_c3 = c2.mul_add(c3, s2 * s3_2);
    let l1_m3_l2 = l1 * m3_l2;
    let s5_of_place = s2_s3_2_plus_c2_c3 * l1_m3_l2;
    let l1_m2_plus_m3 = l1 * m2_plus_m3;
    let c2_l1_m2_plus_m3 = l1_m2_plus_m3 * c2;
    // s5 = -l1*(cos(q2)*(m2 + m3) + m3*l2*l2_*(sin(q2)*sin(q3) + cos(q2)*cos(q3)))
    let s5 = (-l2_).mul_add(s5_of_place, -c2_l1_m2_plus_m3);
    let l0_s1 = l0 * s1;
    let u1_sq = u1 * u1;
    let l0_s1_u1_sq = l0_s1 * u1_sq;
    let u2_sq = u2 * u2;
    let l1_u2_sq = l1 * u2_sq;
    // l0_s1_u1_sq + l1_u2_sq*sin(q2)
    let r6_of_u1_u2 = l1_u2_sq.mul_add(s2, l0_s1_u1_sq);
    // g*sin(q3) + r6_of_u1_u2*cos(q3)
    let r6_of_u1_u2_2 = r6_of_u1_u2.mul_add(c3, g * s3_2);
    // sin(q3)*(l0_c1*u1_sq + l1_u2_sq*cos(q2)) - r6_of_u1_u2_2
    let r6_of_u1_u2_3 = s3_2 * l1_u2_sq.mul_add(c2, l0_c1 * u1_sq) - r6_of_u1_u2_2;
    let u3_sq = u3 * u3;
    let m3_l2_u3_sq = m3_l2 * u3_sq;
    // r6 = F - m1*l0*u1^2*sin(q1) - m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) - m3*(l0*u1^2*sin(q1) +
    //   l1*u2^2*sin(q2) + l2*(u3^2*sin(q3) + l2_*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g -
    //   l0*u1^2*cos(q1) - l1*u2^2*cos(q2)))))
    let r6 = (-m1).mul_add(l0_s1_u1_sq, F) - m2_plus_m3 * r6_of_u1_u2
        + l2__m3_l2 * r6_of_u1_u2_3 - m3_l2_u3_sq * s3_2;
    // l7 = m3*l0*l2*(sin(q1)*sin(q3) + cos(q1)*cos(q3))/d1
    let l7 = d1_inv_m3_l2 * s4_of_l0_q1_q3;
    let l7_m3_l2 = l7 * m3_l2;
    // s8 = l0*(l0*(m1 + m2 + m3) - m3*l2*l7*(sin(q1)*sin(q3) + cos(q1)*cos(q3)))
    let s8 = (-s4_of_l0_q1_q3).mul_add(l7_m3_l2, l0 * l0 * m1_plus_m2_plus_m3);
    let s2_l1_m2_plus_m3 = l1_m2_plus_m3 * s2;
    // s9 = l1*(m2*l0*(sin(q1)*sin(q2) + cos(q1)*cos(q2)) + m3*(l0*(sin(q1)*sin(q2) + cos(q1)*cos(q2)) -
    //   l2*l7*(sin(q2)*sin(q3) + cos(q2)*cos(q3))))
    let s9 = (-l7).mul_add(s5_of_place, l0_c1 * c2_l1_m2_plus_m3) + l0_s1 * s2_l1_m2_plus_m3;
    // l0*l1_m2_plus_m3*(cos(q1)*sin(q2) - sin(q1)*cos(q2))
    let r10_of_place = l0 * l1_m2_plus_m3 * (-s1).mul_add(c2, c1 * s2);
    // r10 = l0*(m1*g*sin(q1) + m2*(g*sin(q1) - l1*u2^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2))) +
    //   m3*(g*sin(q1) - l1*u2^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2)) - l2*(u3^2*(sin(q1)*cos(q3) -
    //   cos(q1)*sin(q3)) + u1^2*l7*(sin(q1)*cos(q3) - cos(q1)*sin(q3))))) - m3*l2*l7*(g*sin(q3) +
    //   l1*u2^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))
    let r10 = m3_l2_u3_sq * (-l0_s1).mul_add(c3, l0_c1 * s3_2)
        + g * m1_plus_m2_plus_m3 * l0_s1 + r6_of_u1_u2_3 * l7_m3_l2 + u2_sq * r10_of_place;
    // l11 = m3*l1*l2*(sin(q2)*sin(q3) + cos(q2)*cos(q3))/d1
    let l11 = l1 * d1_inv_m3_l2 * s2_s3_2_plus_c2_c3;
    // s12 = l1*(l1*(m2 + m3) - m3*l2*l11*(sin(q2)*sin(q3) + cos(q2)*cos(q3)))
    let s12 = (-l11).mul_add(s5_of_place, l1 * l1_m2_plus_m3);
    // r13 = m2*l1*(g*sin(q2) + l0*u1^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2))) + m3*(l1*(g*sin(q2) +
    //   l0*u1^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2)) - l2*(u3^2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   u2^2*l11*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))) - l2*l11*(g*sin(q3) + l0*u1^2*(sin(q1)*cos(q3) -
    //   cos(q1)*sin(q3))))
    let r13 = l1_m3_l2 * u3_sq * (-s2).mul_add(c3, c2 * s3_2)
        + l11 * m3_l2 * r6_of_u1_u2_3 + g * s2_l1_m2_plus_m3 - u1_sq * r10_of_place;
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
    // u3' = m3*l2*(sin(q3)*(g - l0*(u1^2*cos(q1) + u1'*sin(q1)) - l1*(u2^2*cos(q2) + u2'*sin(q2))) +
    //   cos(q3)*(u0' + l0*(u1^2*sin(q1) - u1'*cos(q1)) + l1*(u2^2*sin(q2) - u2'*cos(q2))))/d1
    let u3_dot = d1_inv_m3_l2 * u0_dot.mul_add(c3, -r6_of_u1_u2_3) - u1_dot * l7 - u2_dot * l11;
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

/// Newton–Euler equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEuler;

impl<S: Scalar> System<S> for NewtonEuler {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 9,
            coordinates: 4,
            variables: 4,
            speeds: 4,
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
