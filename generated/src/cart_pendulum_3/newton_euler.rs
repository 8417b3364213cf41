//! Three-link pendulum on a cart: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/cart_pendulum_3/model.toml`. Do not edit; run `tripos regenerate`.
//! 4 coordinates, 4 speeds, 9 parameters, 4 reactions. Unknowns: (u0', u1', u2', u3', rail, T1, T2, T3).
//! Cost: mass_matrix 36 operations, 3 sines and cosines; forcing 30 operations, 3 sines and cosines; accelerations 161 operations, 3 sines and cosines.
//! The kinematic equations are singular nowhere.
//! The accelerations divide by m0 + m1 + m2 + m3*sin(q3)^2, by s5, by s7 - s6^2/s5, by l2.

use super::Parameters;
use tripos_traits::{Scalar, System};

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
    let zero = S::int(0);
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2_2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // l0*cos(q1); used 3 times
    let l0_c1 = l0 * c1;
    // l0*sin(q1); used 3 times
    let l0_s1 = l0 * s1;
    // l1*cos(q2); used 2 times
    let l1_c2 = l1 * c2;
    // l1*sin(q2); used 2 times
    let l1_s2_2 = l1 * s2_2;
    // m3*l2; used 2 times
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
    let m37 = -s2_2;
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
    let m57 = s2_2;
    // M58 = -sin(q3)
    let m58 = -s3;
    // M62 = -m2*l0*sin(q1)
    let m62 = -m2 * l0_s1;
    // M63 = -m2*l1*sin(q2)
    let m63 = -m2 * l1_s2_2;
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
    let m78 = s3;
    // M82 = -m3*l0*sin(q1)
    let m82 = -m3 * l0_s1;
    // M83 = -m3*l1*sin(q2)
    let m83 = -m3 * l1_s2_2;
    // M84 = -m3*l2*sin(q3)
    let m84 = -m3_l2 * s3;
    // M88 = -cos(q3)
    let m88 = -c3;
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
    let (s2_2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // l0*u1^2; used 2 times
    let l0_u1_sq = l0 * u1 * u1;
    // l0_u1_sq*sin(q1); used 2 times
    let s1_l0_u1_sq = l0_u1_sq * s1;
    // g - l0_u1_sq*cos(q1); used 2 times
    let f4_part = (-l0_u1_sq).mul_add(c1, g);
    // l1*u2^2; used 2 times
    let l1_u2_sq = l1 * u2 * u2;
    // s1_l0_u1_sq + l1_u2_sq*sin(q2); used 2 times
    let f5_part = l1_u2_sq.mul_add(s2_2, s1_l0_u1_sq);
    // f4_part - l1_u2_sq*cos(q2); used 2 times
    let f6_part = (-l1_u2_sq).mul_add(c2, f4_part);
    // l2*u3^2; used 2 times
    let l2_u3_sq = l2 * u3 * u3;
    // Values.
    // f1 = F
    let f1 = F;
    // f2 = -m0*g
    let f2 = -m0 * g;
    // f3 = -m1*l0*u1^2*sin(q1)
    let f3 = -m1 * s1_l0_u1_sq;
    // f4 = m1*(l0*u1^2*cos(q1) - g)
    let f4 = -m1 * f4_part;
    // f5 = -m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2))
    let f5 = -m2 * f5_part;
    // f6 = m2*(l0*u1^2*cos(q1) - g + l1*u2^2*cos(q2))
    let f6 = -m2 * f6_part;
    // f7 = -m3*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2) + l2*u3^2*sin(q3))
    let f7 = -m3 * (l2_u3_sq.mul_add(s3, f5_part));
    // f8 = m3*(l0*u1^2*cos(q1) - g + l1*u2^2*cos(q2) + l2*u3^2*cos(q3))
    let f8 = m3 * (l2_u3_sq.mul_add(c3, -f6_part));
    [f1, f2, f3, f4, f5, f6, f7, f8]
}

/// The accelerations (u0', u1', u2', u3'), solved for when this code was generated.
///
/// 161 operations, 3 sines and cosines.
#[must_use]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [S; 4] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, u1, u2, u3] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2_2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // u1^2; used 3 times
    let u1_sq = u1 * u1;
    // l0*u1_sq; used 3 times
    let l0_u1_sq = l0 * u1_sq;
    // l0_u1_sq*sin(q1); used 3 times
    let s1_l0_u1_sq = l0_u1_sq * s1;
    // u2^2; used 3 times
    let u2_sq = u2 * u2;
    // l1*u2_sq; used 2 times
    let l1_u2_sq = l1 * u2_sq;
    // l1_u2_sq*sin(q2); used 3 times
    let s2_2_l1_u2_sq = l1_u2_sq * s2_2;
    // s1_l0_u1_sq + s2_2_l1_u2_sq; used 3 times
    let r1_part = s1_l0_u1_sq + s2_2_l1_u2_sq;
    // l1_u2_sq*cos(q2) - g; used 3 times
    let r1_part_2 = l1_u2_sq.mul_add(c2, -g);
    // l0_u1_sq*cos(q1); used 2 times
    let c1_l0_u1_sq = l0_u1_sq * c1;
    // -r1_part_2 - c1_l0_u1_sq; used 2 times
    let r1_part_3 = -r1_part_2 - c1_l0_u1_sq;
    // l2*u3^2; used 3 times
    let l2_u3_sq = l2 * u3 * u3;
    // m3*sin(q3); used 4 times
    let m3_s3 = m3 * s3;
    // Elimination, step by step.
    // r1 = F - m1*l0*u1^2*sin(q1) - m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) -
    //   m3*sin(q3)*(sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + cos(q3)*(l0*u1^2*cos(q1) - g +
    //   l1*u2^2*cos(q2)) + l2*u3^2)
    let r1 = m3_s3
        .mul_add(
            (-r1_part).mul_add(s3, r1_part_3 * c3) - l2_u3_sq,
            (-m2).mul_add(r1_part, (-m1).mul_add(s1_l0_u1_sq, F)),
        );
    // Shared terms.
    // m2 + m3; used 3 times
    let m2_plus_m3 = m2 + m3;
    // l1*(sin(q2)*sin(q3) + cos(q2)*cos(q3)); used 3 times
    let s2_part = l1 * (c2.mul_add(c3, s2_2 * s3));
    // l0*(sin(q1)*sin(q3) + cos(q1)*cos(q3)); used 2 times
    let s2_part_2 = l0 * (c1.mul_add(c3, s1 * s3));
    // m3*s2_part_2; used 3 times
    let m3_s2_part_2 = m3 * s2_part_2;
    // Elimination, step by step.
    // s2 = l0*l1*(m2*(sin(q1)*sin(q2) + cos(q1)*cos(q2)) + m3*(sin(q1)*sin(q2) + cos(q1)*cos(q2))) -
    //   m3*l0*l1*(sin(q1)*sin(q3) + cos(q1)*cos(q3))*(sin(q2)*sin(q3) + cos(q2)*cos(q3))
    let s2 = (-s2_part)
        .mul_add(m3_s2_part_2, l0 * l1 * m2_plus_m3 * (c1.mul_add(c2, s1 * s2_2)));
    // Shared terms.
    // l2_u3_sq*cos(q3); used 2 times
    let c3_l2_u3_sq = l2_u3_sq * c3;
    // l2_u3_sq*sin(q3); used 2 times
    let s3_l2_u3_sq = l2_u3_sq * s3;
    // r1_part*cos(q3) + r1_part_3*sin(q3); used 2 times
    let r3_part = r1_part_3.mul_add(s3, r1_part * c3);
    // Elimination, step by step.
    // r3 = l0*(sin(q1)*(m1*g + m2*(g - l1*u2^2*cos(q2)) + m3*(g - l1*u2^2*cos(q2) - l2*u3^2*cos(q3))) +
    //   cos(q1)*(m2*l1*u2^2*sin(q2) + m3*(l1*u2^2*sin(q2) + l2*u3^2*sin(q3)))) - m3*l0*(sin(q1)*sin(q3) +
    //   cos(q1)*cos(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g - l0*u1^2*cos(q1) -
    //   l1*u2^2*cos(q2)))
    let r3 = (-m3_s2_part_2)
        .mul_add(
            r3_part,
            l0
                * (c1
                    .mul_add(
                        m3.mul_add(s2_2_l1_u2_sq + s3_l2_u3_sq, m2 * s2_2_l1_u2_sq),
                        s1
                            * ((-m3)
                                .mul_add(
                                    r1_part_2 + c3_l2_u3_sq,
                                    (-m2).mul_add(r1_part_2, m1 * g),
                                )),
                    )),
        );
    // Shared terms.
    // m3*s2_part; used 2 times
    let m3_s2_part = m3 * s2_part;
    // Elimination, step by step.
    // r4 = l1*(m2*(g*sin(q2) + l0*u1^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2))) + m3*(sin(q2)*(g -
    //   l0*u1^2*cos(q1) - l2*u3^2*cos(q3)) + cos(q2)*(l0*u1^2*sin(q1) + l2*u3^2*sin(q3)))) -
    //   m3*l1*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g
    //   - l0*u1^2*cos(q1) - l1*u2^2*cos(q2)))
    let r4 = (-r3_part)
        .mul_add(
            m3_s2_part,
            l1
                * (m3
                    .mul_add(
                        c2
                            .mul_add(
                                s1_l0_u1_sq + s3_l2_u3_sq,
                                s2_2 * (g - c1_l0_u1_sq - c3_l2_u3_sq),
                            ),
                        m2 * (l0_u1_sq.mul_add((-c1).mul_add(s2_2, s1 * c2), g * s2_2)),
                    )),
        );
    // Shared terms.
    // m1 + m3_s3*sin(q3)
    let s5_part = m3_s3.mul_add(s3, m1);
    // m2 + s5_part; used 2 times
    let m2_plus_s5_part = m2 + s5_part;
    // l0*(m2_plus_s5_part*cos(q1) - m3_s3*sin(q1)*cos(q3)); used 3 times
    let s5_part_2 = l0 * ((-(m3_s3 * s1)).mul_add(c3, m2_plus_s5_part * c1));
    // 1/(m0 + m2_plus_s5_part); used 3 times
    let s5_part_3 = S::int(1) / (m0 + m2_plus_s5_part);
    // s5_part_2*s5_part_3; used 3 times
    let s5_part_2_s5_part_3 = s5_part_2 * s5_part_3;
    // Elimination, step by step.
    // s5 = l0^2*(m1 + m2 + m3) - m3*l0^2*(sin(q1)*sin(q3) + cos(q1)*cos(q3))^2 - l0^2*(cos(q1)*(m1 + m2 +
    //   m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s5 = (-s5_part_2)
        .mul_add(
            s5_part_2_s5_part_3,
            (-s2_part_2).mul_add(m3_s2_part_2, l0 * l0 * (m1 + m2_plus_m3)),
        );
    // Shared terms.
    // -l1*(m2*cos(q2) + m3_s3*(cos(q2)*sin(q3) - sin(q2)*cos(q3))); used 4 times
    let s6_part = -l1 * (m3_s3.mul_add((-s2_2).mul_add(c3, c2 * s3), m2 * c2));
    // Elimination, step by step.
    // s6 = l0*l1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3))*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))/(m0 + m1 +
    //   m2 + m3*sin(q3)^2) + s2
    let s6 = s5_part_2_s5_part_3.mul_add(s6_part, s2);
    // Shared terms.
    // s5_part_3*s6_part; used 2 times
    let s5_part_3_s6_part = s5_part_3 * s6_part;
    // Elimination, step by step.
    // s7 = l1^2*(m2 + m3) - m3*l1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3))^2 -
    //   l1^2*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s7 = (-s6_part)
        .mul_add(
            s5_part_3_s6_part,
            (-s2_part).mul_add(m3_s2_part, l1 * l1 * m2_plus_m3),
        );
    // Shared terms.
    // r3 + r1*s5_part_2_s5_part_3; used 2 times
    let r8_part = r1.mul_add(s5_part_2_s5_part_3, r3);
    // 1/s5; used 2 times
    let s5_inv = S::int(1) / s5;
    // s6*s5_inv; used 2 times
    let s6_s5_inv = s6 * s5_inv;
    // Elimination, step by step.
    // r8 = l1*r1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r4 - s6*(l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 +
    //   m1 + m2 + m3*sin(q3)^2) + r3)/s5
    let r8 = (-r8_part).mul_add(s6_s5_inv, (-r1).mul_add(s5_part_3_s6_part, r4));
    // u2' = r8/(s7 - s6^2/s5)
    let u2_dot = r8 / ((-s6).mul_add(s6_s5_inv, s7));
    // u1' = (l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r3 - u2'*s6)/s5
    let u1_dot = s5_inv * ((-u2_dot).mul_add(s6, r8_part));
    // u0' = (l0*u1'*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3)) + l1*u2'*(m2*cos(q2) -
    //   m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3))) + r1)/(m0 + m1 + m2 + m3*sin(q3)^2)
    let u0_dot = s5_part_3 * ((-u2_dot).mul_add(s6_part, u1_dot.mul_add(s5_part_2, r1)));
    // u3' = (cos(q3)*(u0' + l0*(u1^2*sin(q1) - u1'*cos(q1)) + l1*(u2^2*sin(q2) - u2'*cos(q2))) +
    //   sin(q3)*(g - l0*(u1^2*cos(q1) + u1'*sin(q1)) - l1*(u2^2*cos(q2) + u2'*sin(q2))))/l2
    let u3_dot = (c3
        .mul_add(
            l1
                .mul_add(
                    (-u2_dot).mul_add(c2, u2_sq * s2_2),
                    l0.mul_add((-u1_dot).mul_add(c1, u1_sq * s1), u0_dot),
                ),
            s3
                * ((-l1)
                    .mul_add(
                        u2_sq.mul_add(c2, u2_dot * s2_2),
                        (-l0).mul_add(u1_sq.mul_add(c1, u1_dot * s1), g),
                    )),
        )) / l2;
    [u0_dot, u1_dot, u2_dot, u3_dot]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 161 operations, 3 sines and cosines.
#[must_use]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    u: &[S; 4],
) -> ([S; 4], [S; 4]) {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [u0, u1, u2, u3] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2_2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // u1^2; used 3 times
    let u1_sq = u1 * u1;
    // l0*u1_sq; used 3 times
    let l0_u1_sq = l0 * u1_sq;
    // l0_u1_sq*sin(q1); used 3 times
    let s1_l0_u1_sq = l0_u1_sq * s1;
    // u2^2; used 3 times
    let u2_sq = u2 * u2;
    // l1*u2_sq; used 2 times
    let l1_u2_sq = l1 * u2_sq;
    // l1_u2_sq*sin(q2); used 3 times
    let s2_2_l1_u2_sq = l1_u2_sq * s2_2;
    // s1_l0_u1_sq + s2_2_l1_u2_sq; used 3 times
    let r1_part = s1_l0_u1_sq + s2_2_l1_u2_sq;
    // l1_u2_sq*cos(q2) - g; used 3 times
    let r1_part_2 = l1_u2_sq.mul_add(c2, -g);
    // l0_u1_sq*cos(q1); used 2 times
    let c1_l0_u1_sq = l0_u1_sq * c1;
    // -r1_part_2 - c1_l0_u1_sq; used 2 times
    let r1_part_3 = -r1_part_2 - c1_l0_u1_sq;
    // l2*u3^2; used 3 times
    let l2_u3_sq = l2 * u3 * u3;
    // m3*sin(q3); used 4 times
    let m3_s3 = m3 * s3;
    // Elimination, step by step.
    // r1 = F - m1*l0*u1^2*sin(q1) - m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) -
    //   m3*sin(q3)*(sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + cos(q3)*(l0*u1^2*cos(q1) - g +
    //   l1*u2^2*cos(q2)) + l2*u3^2)
    let r1 = m3_s3
        .mul_add(
            (-r1_part).mul_add(s3, r1_part_3 * c3) - l2_u3_sq,
            (-m2).mul_add(r1_part, (-m1).mul_add(s1_l0_u1_sq, F)),
        );
    // Shared terms.
    // m2 + m3; used 3 times
    let m2_plus_m3 = m2 + m3;
    // l1*(sin(q2)*sin(q3) + cos(q2)*cos(q3)); used 3 times
    let s2_part = l1 * (c2.mul_add(c3, s2_2 * s3));
    // l0*(sin(q1)*sin(q3) + cos(q1)*cos(q3)); used 2 times
    let s2_part_2 = l0 * (c1.mul_add(c3, s1 * s3));
    // m3*s2_part_2; used 3 times
    let m3_s2_part_2 = m3 * s2_part_2;
    // Elimination, step by step.
    // s2 = l0*l1*(m2*(sin(q1)*sin(q2) + cos(q1)*cos(q2)) + m3*(sin(q1)*sin(q2) + cos(q1)*cos(q2))) -
    //   m3*l0*l1*(sin(q1)*sin(q3) + cos(q1)*cos(q3))*(sin(q2)*sin(q3) + cos(q2)*cos(q3))
    let s2 = (-s2_part)
        .mul_add(m3_s2_part_2, l0 * l1 * m2_plus_m3 * (c1.mul_add(c2, s1 * s2_2)));
    // Shared terms.
    // l2_u3_sq*cos(q3); used 2 times
    let c3_l2_u3_sq = l2_u3_sq * c3;
    // l2_u3_sq*sin(q3); used 2 times
    let s3_l2_u3_sq = l2_u3_sq * s3;
    // r1_part*cos(q3) + r1_part_3*sin(q3); used 2 times
    let r3_part = r1_part_3.mul_add(s3, r1_part * c3);
    // Elimination, step by step.
    // r3 = l0*(sin(q1)*(m1*g + m2*(g - l1*u2^2*cos(q2)) + m3*(g - l1*u2^2*cos(q2) - l2*u3^2*cos(q3))) +
    //   cos(q1)*(m2*l1*u2^2*sin(q2) + m3*(l1*u2^2*sin(q2) + l2*u3^2*sin(q3)))) - m3*l0*(sin(q1)*sin(q3) +
    //   cos(q1)*cos(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g - l0*u1^2*cos(q1) -
    //   l1*u2^2*cos(q2)))
    let r3 = (-m3_s2_part_2)
        .mul_add(
            r3_part,
            l0
                * (c1
                    .mul_add(
                        m3.mul_add(s2_2_l1_u2_sq + s3_l2_u3_sq, m2 * s2_2_l1_u2_sq),
                        s1
                            * ((-m3)
                                .mul_add(
                                    r1_part_2 + c3_l2_u3_sq,
                                    (-m2).mul_add(r1_part_2, m1 * g),
                                )),
                    )),
        );
    // Shared terms.
    // m3*s2_part; used 2 times
    let m3_s2_part = m3 * s2_part;
    // Elimination, step by step.
    // r4 = l1*(m2*(g*sin(q2) + l0*u1^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2))) + m3*(sin(q2)*(g -
    //   l0*u1^2*cos(q1) - l2*u3^2*cos(q3)) + cos(q2)*(l0*u1^2*sin(q1) + l2*u3^2*sin(q3)))) -
    //   m3*l1*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g
    //   - l0*u1^2*cos(q1) - l1*u2^2*cos(q2)))
    let r4 = (-r3_part)
        .mul_add(
            m3_s2_part,
            l1
                * (m3
                    .mul_add(
                        c2
                            .mul_add(
                                s1_l0_u1_sq + s3_l2_u3_sq,
                                s2_2 * (g - c1_l0_u1_sq - c3_l2_u3_sq),
                            ),
                        m2 * (l0_u1_sq.mul_add((-c1).mul_add(s2_2, s1 * c2), g * s2_2)),
                    )),
        );
    // Shared terms.
    // m1 + m3_s3*sin(q3)
    let s5_part = m3_s3.mul_add(s3, m1);
    // m2 + s5_part; used 2 times
    let m2_plus_s5_part = m2 + s5_part;
    // l0*(m2_plus_s5_part*cos(q1) - m3_s3*sin(q1)*cos(q3)); used 3 times
    let s5_part_2 = l0 * ((-(m3_s3 * s1)).mul_add(c3, m2_plus_s5_part * c1));
    // 1/(m0 + m2_plus_s5_part); used 3 times
    let s5_part_3 = S::int(1) / (m0 + m2_plus_s5_part);
    // s5_part_2*s5_part_3; used 3 times
    let s5_part_2_s5_part_3 = s5_part_2 * s5_part_3;
    // Elimination, step by step.
    // s5 = l0^2*(m1 + m2 + m3) - m3*l0^2*(sin(q1)*sin(q3) + cos(q1)*cos(q3))^2 - l0^2*(cos(q1)*(m1 + m2 +
    //   m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s5 = (-s5_part_2)
        .mul_add(
            s5_part_2_s5_part_3,
            (-s2_part_2).mul_add(m3_s2_part_2, l0 * l0 * (m1 + m2_plus_m3)),
        );
    // Shared terms.
    // -l1*(m2*cos(q2) + m3_s3*(cos(q2)*sin(q3) - sin(q2)*cos(q3))); used 4 times
    let s6_part = -l1 * (m3_s3.mul_add((-s2_2).mul_add(c3, c2 * s3), m2 * c2));
    // Elimination, step by step.
    // s6 = l0*l1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3))*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))/(m0 + m1 +
    //   m2 + m3*sin(q3)^2) + s2
    let s6 = s5_part_2_s5_part_3.mul_add(s6_part, s2);
    // Shared terms.
    // s5_part_3*s6_part; used 2 times
    let s5_part_3_s6_part = s5_part_3 * s6_part;
    // Elimination, step by step.
    // s7 = l1^2*(m2 + m3) - m3*l1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3))^2 -
    //   l1^2*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s7 = (-s6_part)
        .mul_add(
            s5_part_3_s6_part,
            (-s2_part).mul_add(m3_s2_part, l1 * l1 * m2_plus_m3),
        );
    // Shared terms.
    // r3 + r1*s5_part_2_s5_part_3; used 2 times
    let r8_part = r1.mul_add(s5_part_2_s5_part_3, r3);
    // 1/s5; used 2 times
    let s5_inv = S::int(1) / s5;
    // s6*s5_inv; used 2 times
    let s6_s5_inv = s6 * s5_inv;
    // Elimination, step by step.
    // r8 = l1*r1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r4 - s6*(l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 +
    //   m1 + m2 + m3*sin(q3)^2) + r3)/s5
    let r8 = (-r8_part).mul_add(s6_s5_inv, (-r1).mul_add(s5_part_3_s6_part, r4));
    // u2' = r8/(s7 - s6^2/s5)
    let u2_dot = r8 / ((-s6).mul_add(s6_s5_inv, s7));
    // u1' = (l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r3 - u2'*s6)/s5
    let u1_dot = s5_inv * ((-u2_dot).mul_add(s6, r8_part));
    // u0' = (l0*u1'*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3)) + l1*u2'*(m2*cos(q2) -
    //   m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3))) + r1)/(m0 + m1 + m2 + m3*sin(q3)^2)
    let u0_dot = s5_part_3 * ((-u2_dot).mul_add(s6_part, u1_dot.mul_add(s5_part_2, r1)));
    // u3' = (cos(q3)*(u0' + l0*(u1^2*sin(q1) - u1'*cos(q1)) + l1*(u2^2*sin(q2) - u2'*cos(q2))) +
    //   sin(q3)*(g - l0*(u1^2*cos(q1) + u1'*sin(q1)) - l1*(u2^2*cos(q2) + u2'*sin(q2))))/l2
    let u3_dot = (c3
        .mul_add(
            l1
                .mul_add(
                    (-u2_dot).mul_add(c2, u2_sq * s2_2),
                    l0.mul_add((-u1_dot).mul_add(c1, u1_sq * s1), u0_dot),
                ),
            s3
                * ((-l1)
                    .mul_add(
                        u2_sq.mul_add(c2, u2_dot * s2_2),
                        (-l0).mul_add(u1_sq.mul_add(c1, u1_dot * s1), g),
                    )),
        )) / l2;
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
/// 595 operations, 3 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [[S; 8]; 8] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, u1, u2, u3] = *u;
    let zero = S::int(0);
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2_2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // l0*u1; used 4 times
    let l0_u1 = l0 * u1;
    // u1*l0_u1; used 6 times
    let u1_l0_u1 = u1 * l0_u1;
    // u1_l0_u1*sin(q1); used 3 times
    let s1_u1_l0_u1 = u1_l0_u1 * s1;
    // l1*u2; used 3 times
    let l1_u2 = l1 * u2;
    // u2*l1_u2; used 4 times
    let u2_l1_u2 = u2 * l1_u2;
    // u2_l1_u2*sin(q2); used 3 times
    let s2_2_u2_l1_u2 = u2_l1_u2 * s2_2;
    // s1_u1_l0_u1 + s2_2_u2_l1_u2; used 3 times
    let r1_part = s1_u1_l0_u1 + s2_2_u2_l1_u2;
    // l2*u3; used 2 times
    let l2_u3 = l2 * u3;
    // u3*l2_u3; used 6 times
    let u3_l2_u3 = u3 * l2_u3;
    // g - u2_l1_u2*cos(q2); used 3 times
    let r1_part_2 = (-u2_l1_u2).mul_add(c2, g);
    // u1_l0_u1*cos(q1); used 2 times
    let c1_u1_l0_u1 = u1_l0_u1 * c1;
    // r1_part_2 - c1_u1_l0_u1; used 2 times
    let r1_part_3 = r1_part_2 - c1_u1_l0_u1;
    // r1_part_3*cos(q3); used 2 times
    let c3_r1_part_3 = r1_part_3 * c3;
    // r1_part*sin(q3); used 2 times
    let s3_r1_part = r1_part * s3;
    // s3_r1_part - c3_r1_part_3; used 2 times
    let r1_part_4 = s3_r1_part - c3_r1_part_3;
    // m3*sin(q3); used 8 times
    let m3_s3 = m3 * s3;
    // Elimination, step by step.
    // r1 = F - m1*l0*u1^2*sin(q1) - m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) -
    //   m3*sin(q3)*(sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + cos(q3)*(l0*u1^2*cos(q1) - g +
    //   l1*u2^2*cos(q2)) + l2*u3^2)
    let r1 = (-m3_s3)
        .mul_add(
            u3_l2_u3 + r1_part_4,
            (-m2).mul_add(r1_part, (-m1).mul_add(s1_u1_l0_u1, F)),
        );
    // Shared terms.
    // sin(q1)*sin(q3) + cos(q1)*cos(q3); used 3 times
    let s2_part = c1.mul_add(c3, s1 * s3);
    // l0*s2_part; used 6 times
    let l0_s2_part = l0 * s2_part;
    // sin(q2)*sin(q3) + cos(q2)*cos(q3); used 8 times
    let s2_part_2 = c2.mul_add(c3, s2_2 * s3);
    // m3*l1; used 3 times
    let m3_l1 = m3 * l1;
    // s2_part_2*m3_l1; used 8 times
    let s2_part_2_m3_l1 = s2_part_2 * m3_l1;
    // cos(q1)*cos(q2); used 2 times
    let c1_c2 = c1 * c2;
    // sin(q1)*sin(q2) + c1_c2; used 3 times
    let s2_part_3 = s1.mul_add(s2_2, c1_c2);
    // m2 + m3; used 5 times
    let m2_plus_m3 = m2 + m3;
    // l0*l1; used 2 times
    let l0_l1 = l0 * l1;
    // Elimination, step by step.
    // s2 = l0*l1*(m2*(sin(q1)*sin(q2) + cos(q1)*cos(q2)) + m3*(sin(q1)*sin(q2) + cos(q1)*cos(q2))) -
    //   m3*l0*l1*(sin(q1)*sin(q3) + cos(q1)*cos(q3))*(sin(q2)*sin(q3) + cos(q2)*cos(q3))
    let s2 = (-l0_s2_part).mul_add(s2_part_2_m3_l1, s2_part_3 * m2_plus_m3 * l0_l1);
    // Shared terms.
    // u3_l2_u3*cos(q3); used 2 times
    let c3_u3_l2_u3 = u3_l2_u3 * c3;
    // m1*g + m2*r1_part_2 + m3*(r1_part_2 - c3_u3_l2_u3); used 2 times
    let r3_part = m3.mul_add(r1_part_2 - c3_u3_l2_u3, m2.mul_add(r1_part_2, m1 * g));
    // u3_l2_u3*sin(q3); used 2 times
    let s3_u3_l2_u3 = u3_l2_u3 * s3;
    // m2*s2_2_u2_l1_u2 + m3*(s2_2_u2_l1_u2 + s3_u3_l2_u3); used 2 times
    let r3_part_2 = m3.mul_add(s2_2_u2_l1_u2 + s3_u3_l2_u3, m2 * s2_2_u2_l1_u2);
    // r1_part_3*sin(q3); used 2 times
    let s3_r1_part_3 = r1_part_3 * s3;
    // r1_part*cos(q3) + s3_r1_part_3; used 4 times
    let r3_part_3 = r1_part.mul_add(c3, s3_r1_part_3);
    // m3*l0_s2_part; used 5 times
    let m3_l0_s2_part = m3 * l0_s2_part;
    // Elimination, step by step.
    // r3 = l0*(sin(q1)*(m1*g + m2*(g - l1*u2^2*cos(q2)) + m3*(g - l1*u2^2*cos(q2) - l2*u3^2*cos(q3))) +
    //   cos(q1)*(m2*l1*u2^2*sin(q2) + m3*(l1*u2^2*sin(q2) + l2*u3^2*sin(q3)))) - m3*l0*(sin(q1)*sin(q3) +
    //   cos(q1)*cos(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g - l0*u1^2*cos(q1) -
    //   l1*u2^2*cos(q2)))
    let r3 = (-r3_part_3)
        .mul_add(m3_l0_s2_part, l0 * (r3_part_2.mul_add(c1, r3_part * s1)));
    // Shared terms.
    // g - c1_u1_l0_u1 - c3_u3_l2_u3; used 2 times
    let r4_part = g - c1_u1_l0_u1 - c3_u3_l2_u3;
    // s1_u1_l0_u1 + s3_u3_l2_u3; used 2 times
    let r4_part_2 = s1_u1_l0_u1 + s3_u3_l2_u3;
    // sin(q1)*cos(q2); used 2 times
    let s1_c2 = s1 * c2;
    // cos(q1)*sin(q2); used 2 times
    let c1_s2_2 = c1 * s2_2;
    // s1_c2 - c1_s2_2; used 3 times
    let r4_part_3 = s1_c2 - c1_s2_2;
    // Elimination, step by step.
    // r4 = l1*(m2*(g*sin(q2) + l0*u1^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2))) + m3*(sin(q2)*(g -
    //   l0*u1^2*cos(q1) - l2*u3^2*cos(q3)) + cos(q2)*(l0*u1^2*sin(q1) + l2*u3^2*sin(q3)))) -
    //   m3*l1*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g
    //   - l0*u1^2*cos(q1) - l1*u2^2*cos(q2)))
    let r4 = (-s2_part_2_m3_l1)
        .mul_add(
            r3_part_3,
            l1
                * (m2
                    .mul_add(
                        u1_l0_u1.mul_add(r4_part_3, g * s2_2),
                        m3 * (r4_part_2.mul_add(c2, r4_part * s2_2)),
                    )),
        );
    // Shared terms.
    // m1 + m2; used 2 times
    let m1_plus_m2 = m1 + m2;
    // m3_s3*sin(q3); used 3 times
    let s3_m3_s3 = m3_s3 * s3;
    // m1_plus_m2 + s3_m3_s3; used 2 times
    let s5_part = m1_plus_m2 + s3_m3_s3;
    // m3_s3*cos(q3); used 3 times
    let c3_m3_s3 = m3_s3 * c3;
    // l0*(s5_part*cos(q1) - c3_m3_s3*sin(q1)); used 10 times
    let s5_part_2 = l0 * ((-c3_m3_s3).mul_add(s1, s5_part * c1));
    // m0 + m1_plus_m2; used 3 times
    let s5_part_3 = m0 + m1_plus_m2;
    // 1/(s3_m3_s3 + s5_part_3); used 12 times
    let s5_part_4 = S::int(1) / (s3_m3_s3 + s5_part_3);
    // s5_part_2*s5_part_4; used 13 times
    let s5_part_2_s5_part_4 = s5_part_2 * s5_part_4;
    // l0^2; used 2 times
    let l0_sq = l0 * l0;
    // Elimination, step by step.
    // s5 = l0^2*(m1 + m2 + m3) - m3*l0^2*(sin(q1)*sin(q3) + cos(q1)*cos(q3))^2 - l0^2*(cos(q1)*(m1 + m2 +
    //   m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s5 = (-s5_part_2)
        .mul_add(
            s5_part_2_s5_part_4,
            (-l0_s2_part).mul_add(m3_l0_s2_part, l0_sq * (m1 + m2_plus_m3)),
        );
    // Shared terms.
    // sin(q2)*cos(q3) - cos(q2)*sin(q3); used 8 times
    let s6_part = (-c2).mul_add(s3, s2_2 * c3);
    // l1*(m3_s3*s6_part - m2*cos(q2)); used 11 times
    let s6_part_2 = l1 * ((-m2).mul_add(c2, m3_s3 * s6_part));
    // Elimination, step by step.
    // s6 = l0*l1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3))*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))/(m0 + m1 +
    //   m2 + m3*sin(q3)^2) + s2
    let s6 = s5_part_2_s5_part_4.mul_add(s6_part_2, s2);
    // Shared terms.
    // s5_part_4*s6_part_2; used 12 times
    let s5_part_4_s6_part_2 = s5_part_4 * s6_part_2;
    // l1*s2_part_2; used 3 times
    let l1_s2_part_2 = l1 * s2_part_2;
    // Elimination, step by step.
    // s7 = l1^2*(m2 + m3) - m3*l1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3))^2 -
    //   l1^2*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s7 = (-s2_part_2_m3_l1)
        .mul_add(
            l1_s2_part_2,
            (-s6_part_2).mul_add(s5_part_4_s6_part_2, l1 * l1 * m2_plus_m3),
        );
    // Shared terms.
    // r3 + r1*s5_part_2_s5_part_4; used 3 times
    let r8_part = r1.mul_add(s5_part_2_s5_part_4, r3);
    // 1/s5; used 11 times
    let s5_inv = S::int(1) / s5;
    // s6*s5_inv; used 12 times
    let s6_s5_inv = s6 * s5_inv;
    // Elimination, step by step.
    // r8 = l1*r1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r4 - s6*(l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 +
    //   m1 + m2 + m3*sin(q3)^2) + r3)/s5
    let r8 = (-r8_part).mul_add(s6_s5_inv, (-r1).mul_add(s5_part_4_s6_part_2, r4));
    // Shared terms.
    // 1/(s7 - s6*s6_s5_inv); used 7 times
    let u2_dot_part = S::int(1) / ((-s6).mul_add(s6_s5_inv, s7));
    // Elimination, step by step.
    // u2' = r8/(s7 - s6^2/s5)
    let u2_dot = r8 * u2_dot_part;
    // u1' = (l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r3 - u2'*s6)/s5
    let u1_dot = s5_inv * ((-u2_dot).mul_add(s6, r8_part));
    // u0' = (l0*u1'*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3)) + l1*u2'*(m2*cos(q2) -
    //   m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3))) + r1)/(m0 + m1 + m2 + m3*sin(q3)^2)
    let u0_dot = s5_part_4
        * ((-u2_dot).mul_add(s6_part_2, u1_dot.mul_add(s5_part_2, r1)));
    // Shared terms.
    // u1^2; used 3 times
    let u1_sq = u1 * u1;
    // Elimination, step by step.
    // r1_by_q1 = l0*u1^2*(m3*sin(q1)*sin(q3)*cos(q3) - cos(q1)*(m1 + m2 + m3*sin(q3)^2))
    let r1_by_q1 = -s5_part_2 * u1_sq;
    // Shared terms.
    // sin(q1)*cos(q3); used 3 times
    let s1_c3 = s1 * c3;
    // cos(q1)*sin(q3); used 2 times
    let c1_s3 = c1 * s3;
    // s1_c3 - c1_s3; used 3 times
    let s2_by_q1_part = s1_c3 - c1_s3;
    // l0*s2_by_q1_part; used 3 times
    let l0_s2_by_q1_part = l0 * s2_by_q1_part;
    // s2_part_2_m3_l1*l0_s2_by_q1_part; used 2 times
    let s2_by_q1_part_2 = s2_part_2_m3_l1 * l0_s2_by_q1_part;
    // m2_plus_m3*l0_l1*r4_part_3; used 2 times
    let s2_by_q1_part_3 = m2_plus_m3 * l0_l1 * r4_part_3;
    // Elimination, step by step.
    // s2_by_q1 = m3*l0*l1*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(sin(q1)*cos(q3) - cos(q1)*sin(q3)) -
    //   l0*l1*(m2*(sin(q1)*cos(q2) - cos(q1)*sin(q2)) + m3*(sin(q1)*cos(q2) - cos(q1)*sin(q2)))
    let s2_by_q1 = s2_by_q1_part_2 - s2_by_q1_part_3;
    // Shared terms.
    // m3*l0_s2_by_q1_part; used 2 times
    let m3_l0_s2_by_q1_part = m3 * l0_s2_by_q1_part;
    // r3_part_3*m3_l0_s2_by_q1_part; used 2 times
    let r3_by_q1_part = r3_part_3 * m3_l0_s2_by_q1_part;
    // Elimination, step by step.
    // r3_by_q1 = m3*l0*(sin(q1)*cos(q3) - cos(q1)*sin(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) +
    //   sin(q3)*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2))) - m3*l0*(sin(q1)*sin(q3) +
    //   cos(q1)*cos(q3))*(l0*u1^2*sin(q1)*sin(q3) + l0*u1^2*cos(q1)*cos(q3)) + l0*(cos(q1)*(m1*g + m2*(g -
    //   l1*u2^2*cos(q2)) + m3*(g - l1*u2^2*cos(q2) - l2*u3^2*cos(q3))) - sin(q1)*(m2*l1*u2^2*sin(q2) +
    //   m3*(l1*u2^2*sin(q2) + l2*u3^2*sin(q3))))
    let r3_by_q1 = (-(u1_l0_u1 * s2_part))
        .mul_add(m3_l0_s2_part, l0 * ((-r3_part_2).mul_add(s1, r3_part * c1)))
        + r3_by_q1_part;
    // Shared terms.
    // m2*s2_part_3 + m3*(c1_c2 + cos(q3)*(s6_part*sin(q1) - s2_part_2*cos(q1))); used 2 times
    let r4_by_q1_part = m3
        .mul_add(
            c3.mul_add((-s2_part_2).mul_add(c1, s6_part * s1), c1_c2),
            m2 * s2_part_3,
        );
    // Elimination, step by step.
    // r4_by_q1 = l0*l1*u1^2*(m2*(sin(q1)*sin(q2) + cos(q1)*cos(q2)) + m3*(cos(q1)*cos(q2) +
    //   cos(q3)*(sin(q1)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - cos(q1)*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)))))
    let r4_by_q1 = l1 * u1_l0_u1 * r4_by_q1_part;
    // Shared terms.
    // s5_part*sin(q1) + c3_m3_s3*cos(q1); used 2 times
    let s5_by_q1_part = c3_m3_s3.mul_add(c1, s5_part * s1);
    // l0*s5_by_q1_part; used 4 times
    let l0_s5_by_q1_part = l0 * s5_by_q1_part;
    // 2*m3_l0_s2_part; used 2 times
    let m3_l0_s2_part_scaled = S::int(2) * m3_l0_s2_part;
    // Elimination, step by step.
    // s5_by_q1 = 2*m3*l0^2*(sin(q1)*sin(q3) + cos(q1)*cos(q3))*(sin(q1)*cos(q3) - cos(q1)*sin(q3)) +
    //   2*l0^2*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))*(m3*cos(q1)*sin(q3)*cos(q3) +
    //   sin(q1)*(m1 + m2 + m3*sin(q3)^2))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s5_by_q1 = l0_s2_by_q1_part
        .mul_add(
            m3_l0_s2_part_scaled,
            S::int(2) * s5_part_2_s5_part_4 * l0_s5_by_q1_part,
        );
    // s6_by_q1 = l0*l1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3)))*(m3*cos(q1)*sin(q3)*cos(q3) + sin(q1)*(m1 + m2 + m3*sin(q3)^2))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + s2_by_q1
    let s6_by_q1 = (-s5_part_4_s6_part_2).mul_add(l0_s5_by_q1_part, s2_by_q1);
    // Shared terms.
    // r1*s5_part_4; used 3 times
    let r1_s5_part_4 = r1 * s5_part_4;
    // r1_by_q1*s5_part_2_s5_part_4 - l0_s5_by_q1_part*r1_s5_part_4
    let r8_by_q1_part = (-l0_s5_by_q1_part)
        .mul_add(r1_s5_part_4, r1_by_q1 * s5_part_2_s5_part_4);
    // r3_by_q1 + r8_by_q1_part; used 2 times
    let r8_by_q1_part_2 = r3_by_q1 + r8_by_q1_part;
    // r8_part*s5_inv; used 2 times
    let r8_part_s5_inv = r8_part * s5_inv;
    // s5_by_q1*s6_s5_inv; used 2 times
    let s5_by_q1_s6_s5_inv = s5_by_q1 * s6_s5_inv;
    // Elimination, step by step.
    // r8_by_q1 = l1*r1_by_q1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + s6*(l0*r1*(m3*cos(q1)*sin(q3)*cos(q3) + sin(q1)*(m1 + m2 + m3*sin(q3)^2))/(m0 + m1 +
    //   m2 + m3*sin(q3)^2) - l0*r1_by_q1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0
    //   + m1 + m2 + m3*sin(q3)^2) - r3_by_q1)/s5 + r4_by_q1 + s6*s5_by_q1*(l0*r1*(cos(q1)*(m1 + m2 +
    //   m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r3)/s5^2 -
    //   s6_by_q1*(l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r3)/s5
    let r8_by_q1 = r8_part_s5_inv
        .mul_add(
            s5_by_q1_s6_s5_inv - s6_by_q1,
            (-s6_s5_inv)
                .mul_add(
                    r8_by_q1_part_2,
                    (-r1_by_q1).mul_add(s5_part_4_s6_part_2, r4_by_q1),
                ),
        );
    // u2_dot_by_q1 = (s6*r8*(2*s6_by_q1 - s6*s5_by_q1/s5)/(s5*(s7 - s6^2/s5)) + r8_by_q1)/(s7 - s6^2/s5)
    let u2_dot_by_q1 = u2_dot_part
        * ((u2_dot * s6_s5_inv)
            .mul_add(s6_by_q1.mul_add(S::int(2), -s5_by_q1_s6_s5_inv), r8_by_q1));
    // Shared terms.
    // u1'*s5_inv; used 2 times
    let u1_dot_s5_inv = u1_dot * s5_inv;
    // Elimination, step by step.
    // u1_dot_by_q1 = s5_by_q1*(u2'*s6 - l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) - r3)/s5^2 + (l0*r1_by_q1*(cos(q1)*(m1 +
    //   m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) -
    //   l0*r1*(m3*cos(q1)*sin(q3)*cos(q3) + sin(q1)*(m1 + m2 + m3*sin(q3)^2))/(m0 + m1 + m2 + m3*sin(q3)^2)
    //   + r3_by_q1 - u2'*s6_by_q1 - s6*u2_dot_by_q1)/s5
    let u1_dot_by_q1 = (-s5_by_q1)
        .mul_add(
            u1_dot_s5_inv,
            s5_inv
                * ((-s6)
                    .mul_add(u2_dot_by_q1, (-u2_dot).mul_add(s6_by_q1, r8_by_q1_part_2))),
        );
    // u0_dot_by_q1 = (r1_by_q1 - l0*u1'*(m3*cos(q1)*sin(q3)*cos(q3) + sin(q1)*(m1 + m2 + m3*sin(q3)^2)) +
    //   l1*u2_dot_by_q1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3))) +
    //   l0*u1_dot_by_q1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2)
    let u0_dot_by_q1 = s5_part_4
        * ((-u1_dot)
            .mul_add(
                l0_s5_by_q1_part,
                (-u2_dot_by_q1)
                    .mul_add(s6_part_2, u1_dot_by_q1.mul_add(s5_part_2, r1_by_q1)),
            ));
    // Shared terms.
    // u1_dot_by_q1 - u1_sq; used 2 times
    let u3_dot_by_q1_part = u1_dot_by_q1 - u1_sq;
    // 1/l2; used 6 times
    let l2_inv = S::int(1) / l2;
    // Elimination, step by step.
    // u3_dot_by_q1 = (u0_dot_by_q1*cos(q3) - l1*u2_dot_by_q1*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   l0*(sin(q1)*(sin(q3)*(u1_dot_by_q1 - u1^2) - u1'*cos(q3)) + cos(q1)*(u1'*sin(q3) +
    //   cos(q3)*(u1_dot_by_q1 - u1^2))))/l2
    let u3_dot_by_q1 = l2_inv
        * (l0
            .mul_add(
                (-c1)
                    .mul_add(
                        u3_dot_by_q1_part.mul_add(c3, u1_dot * s3),
                        s1 * ((-u3_dot_by_q1_part).mul_add(s3, u1_dot * c3)),
                    ),
                (-u2_dot_by_q1).mul_add(l1_s2_part_2, u0_dot_by_q1 * c3),
            ));
    // Shared terms.
    // u2^2; used 3 times
    let u2_sq = u2 * u2;
    // Elimination, step by step.
    // r1_by_q2 = l1*u2^2*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))
    let r1_by_q2 = s6_part_2 * u2_sq;
    // Shared terms.
    // m3_l1*s6_part; used 3 times
    let m3_l1_s6_part = m3_l1 * s6_part;
    // l0_s2_part*m3_l1_s6_part; used 2 times
    let s2_by_q2_part = l0_s2_part * m3_l1_s6_part;
    // Elimination, step by step.
    // s2_by_q2 = l0*l1*(m2*(sin(q1)*cos(q2) - cos(q1)*sin(q2)) + m3*(sin(q1)*cos(q2) - cos(q1)*sin(q2))) +
    //   m3*l0*l1*(sin(q1)*sin(q3) + cos(q1)*cos(q3))*(sin(q2)*cos(q3) - cos(q2)*sin(q3))
    let s2_by_q2 = s2_by_q1_part_3 + s2_by_q2_part;
    // r3_by_q2 = l0*l1*u2^2*(m2*(sin(q1)*sin(q2) + cos(q1)*cos(q2)) + m3*(cos(q1)*cos(q2) +
    //   cos(q3)*(sin(q1)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - cos(q1)*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)))))
    let r3_by_q2 = l0 * u2_l1_u2 * r4_by_q1_part;
    // Shared terms.
    // r3_part_3*m3_l1_s6_part; used 2 times
    let r4_by_q2_part = r3_part_3 * m3_l1_s6_part;
    // Elimination, step by step.
    // r4_by_q2 = m3*l1*(sin(q2)*cos(q3) - cos(q2)*sin(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) +
    //   sin(q3)*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2))) - m3*l1*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3))*(l1*u2^2*sin(q2)*sin(q3) + l1*u2^2*cos(q2)*cos(q3)) + l1*(m2*(g*cos(q2) -
    //   l0*u1^2*(sin(q1)*sin(q2) + cos(q1)*cos(q2))) + m3*(cos(q2)*(g - l0*u1^2*cos(q1) - l2*u3^2*cos(q3)) -
    //   sin(q2)*(l0*u1^2*sin(q1) + l2*u3^2*sin(q3))))
    let r4_by_q2 = (-(u2_l1_u2 * s2_part_2))
        .mul_add(
            s2_part_2_m3_l1,
            l1
                * (m3
                    .mul_add(
                        (-r4_part_2).mul_add(s2_2, r4_part * c2),
                        m2 * ((-u1_l0_u1).mul_add(s2_part_3, g * c2)),
                    )),
        ) + r4_by_q2_part;
    // Shared terms.
    // m3_s3*s2_part_2; used 2 times
    let m3_s3_s2_part_2 = m3_s3 * s2_part_2;
    // m2*sin(q2) + m3_s3_s2_part_2; used 3 times
    let s6_by_q2_part = m2.mul_add(s2_2, m3_s3_s2_part_2);
    // l1*s6_by_q2_part; used 2 times
    let l1_s6_by_q2_part = l1 * s6_by_q2_part;
    // Elimination, step by step.
    // s6_by_q2 = l0*l1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))*(m2*sin(q2) +
    //   m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) + s2_by_q2
    let s6_by_q2 = s5_part_2_s5_part_4.mul_add(l1_s6_by_q2_part, s2_by_q2);
    // Shared terms.
    // 2*l1; used 3 times
    let l1_scaled = S::int(2) * l1;
    // s5_part_4_s6_part_2*l1_scaled; used 2 times
    let s7_by_q2_part = s5_part_4_s6_part_2 * l1_scaled;
    // s2_part_2_m3_l1*s6_part*l1_scaled; used 2 times
    let s7_by_q2_part_2 = s2_part_2_m3_l1 * s6_part * l1_scaled;
    // Elimination, step by step.
    // s7_by_q2 = 2*m3*l1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   2*l1^2*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))*(m2*sin(q2) +
    //   m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s7_by_q2 = (-s6_by_q2_part).mul_add(s7_by_q2_part, s7_by_q2_part_2);
    // Shared terms.
    // s6*r3_by_q2 + r3*s6_by_q2; used 2 times
    let r8_by_q2_part = r3.mul_add(s6_by_q2, s6 * r3_by_q2);
    // s6*r1_by_q2 + r1*s6_by_q2; used 2 times
    let r8_by_q2_part_2 = r1.mul_add(s6_by_q2, s6 * r1_by_q2);
    // l0*cos(q1); used 2 times
    let l0_c1 = l0 * c1;
    // r8_by_q2_part + r8_by_q2_part_2*l0_c1; used 2 times
    let r8_by_q2_part_3 = r8_by_q2_part_2.mul_add(l0_c1, r8_by_q2_part);
    // s5*(l1*(r1_by_q2*cos(q2) - r1*sin(q2)) + r4_by_q2) - r8_by_q2_part_3; used 2 times
    let r8_by_q2_part_4 = s5
        .mul_add(
            l1.mul_add((-r1).mul_add(s2_2, r1_by_q2 * c2), r4_by_q2),
            -r8_by_q2_part_3,
        );
    // s5*r4_by_q2; used 2 times
    let s5_r4_by_q2 = s5 * r4_by_q2;
    // l0*sin(q1); used 2 times
    let l0_s1 = l0 * s1;
    // Elimination, step by step.
    // r8_by_q2 = (m2*(s5*(l1*(r1_by_q2*cos(q2) - r1*sin(q2)) + r4_by_q2) - s6*r3_by_q2 - r3*s6_by_q2 -
    //   l0*cos(q1)*(s6*r1_by_q2 + r1*s6_by_q2)) + m3*sin(q3)*(sin(q3)*(s5*(l1*(r1_by_q2*cos(q2) -
    //   r1*sin(q2)) + r4_by_q2) - s6*r3_by_q2 - r3*s6_by_q2 - l0*cos(q1)*(s6*r1_by_q2 + r1*s6_by_q2)) +
    //   cos(q3)*(l0*sin(q1)*(s6*r1_by_q2 + r1*s6_by_q2) - l1*s5*(r1*cos(q2) + r1_by_q2*sin(q2)))) +
    //   m0*(s5*r4_by_q2 - s6*r3_by_q2 - r3*s6_by_q2) + m1*(s5*r4_by_q2 - s6*r3_by_q2 - r3*s6_by_q2 -
    //   l0*cos(q1)*(s6*r1_by_q2 + r1*s6_by_q2)))/(s5*(m0 + m1 + m2 + m3*sin(q3)^2))
    let r8_by_q2 = s5_part_4 * s5_inv
        * (m3_s3
            .mul_add(
                c3
                    .mul_add(
                        (-(l1 * s5))
                            .mul_add(
                                r1_by_q2.mul_add(s2_2, r1 * c2),
                                r8_by_q2_part_2 * l0_s1,
                            ),
                        r8_by_q2_part_4 * s3,
                    ),
                m0
                    .mul_add(
                        s5_r4_by_q2 - r8_by_q2_part,
                        m1.mul_add(s5_r4_by_q2 - r8_by_q2_part_3, m2 * r8_by_q2_part_4),
                    ),
            ));
    // u2_dot_by_q2 = (r8*(s7_by_q2 - 2*s6*s6_by_q2/s5)/(s6^2/s5 - s7) + r8_by_q2)/(s7 - s6^2/s5)
    let u2_dot_by_q2 = u2_dot_part
        * (u2_dot
            .mul_add((S::int(2) * s6_by_q2).mul_add(s6_s5_inv, -s7_by_q2), r8_by_q2));
    // u1_dot_by_q2 = (l0*r1_by_q2*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1
    //   + m2 + m3*sin(q3)^2) + r3_by_q2 - u2'*s6_by_q2 - s6*u2_dot_by_q2)/s5
    let u1_dot_by_q2 = s5_inv
        * (r1_by_q2
            .mul_add(
                s5_part_2_s5_part_4,
                (-s6).mul_add(u2_dot_by_q2, (-u2_dot).mul_add(s6_by_q2, r3_by_q2)),
            ));
    // u0_dot_by_q2 = (r1_by_q2 - l1*u2'*(m2*sin(q2) + m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) +
    //   l1*u2_dot_by_q2*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3))) +
    //   l0*u1_dot_by_q2*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2)
    let u0_dot_by_q2 = s5_part_4
        * ((-u2_dot)
            .mul_add(
                l1_s6_by_q2_part,
                (-u2_dot_by_q2)
                    .mul_add(s6_part_2, u1_dot_by_q2.mul_add(s5_part_2, r1_by_q2)),
            ));
    // Shared terms.
    // u2_dot_by_q2 - u2_sq; used 2 times
    let u3_dot_by_q2_part = u2_dot_by_q2 - u2_sq;
    // Elimination, step by step.
    // u3_dot_by_q2 = (u0_dot_by_q2*cos(q3) - l1*(sin(q2)*(sin(q3)*(u2_dot_by_q2 - u2^2) - u2'*cos(q3)) +
    //   cos(q2)*(u2'*sin(q3) + cos(q3)*(u2_dot_by_q2 - u2^2))) - l0*u1_dot_by_q2*(sin(q1)*sin(q3) +
    //   cos(q1)*cos(q3)))/l2
    let u3_dot_by_q2 = l2_inv
        * (l1
            .mul_add(
                (-c2)
                    .mul_add(
                        u3_dot_by_q2_part.mul_add(c3, u2_dot * s3),
                        s2_2 * ((-u3_dot_by_q2_part).mul_add(s3, u2_dot * c3)),
                    ),
                (-u1_dot_by_q2).mul_add(l0_s2_part, u0_dot_by_q2 * c3),
            ));
    // r1_by_q3 = -m3*(sin(q3)^2*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2)) +
    //   cos(q3)*(2*sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + cos(q3)*(l0*u1^2*cos(q1) - g +
    //   l1*u2^2*cos(q2)) + l2*u3^2))
    let r1_by_q3 = -m3
        * (s3_r1_part_3
            .mul_add(s3, c3 * (s3_r1_part.mul_add(S::int(2), u3_l2_u3 - c3_r1_part_3))));
    // s2_by_q3 = m3*l0*l1*(sin(q1)*sin(q3) + cos(q1)*cos(q3))*(cos(q2)*sin(q3) - sin(q2)*cos(q3)) +
    //   m3*l0*l1*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(cos(q1)*sin(q3) - sin(q1)*cos(q3))
    let s2_by_q3 = -s2_by_q1_part_2 - s2_by_q2_part;
    // Shared terms.
    // m3*cos(q3); used 3 times
    let m3_c3 = m3 * c3;
    // -r1_part_4; used 2 times
    let r1_part_4_scaled = -r1_part_4;
    // Elimination, step by step.
    // r3_by_q3 = m3*l0*(cos(q1)*sin(q3) - sin(q1)*cos(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) +
    //   sin(q3)*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2))) + m3*l0*(sin(q1)*sin(q3) +
    //   cos(q1)*cos(q3))*(sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) - cos(q3)*(g - l0*u1^2*cos(q1) -
    //   l1*u2^2*cos(q2))) + l0*(m3*l2*u3^2*sin(q1)*sin(q3) + m3*l2*u3^2*cos(q1)*cos(q3))
    let r3_by_q3 = (-m3_l0_s2_part)
        .mul_add(
            r1_part_4_scaled,
            (l0 * u3_l2_u3).mul_add(m3_c3.mul_add(c1, m3_s3 * s1), -r3_by_q1_part),
        );
    // r4_by_q3 = m3*l1*(cos(q2)*sin(q3) - sin(q2)*cos(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) +
    //   sin(q3)*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2))) + m3*l1*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3))*(sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) - cos(q3)*(g - l0*u1^2*cos(q1) -
    //   l1*u2^2*cos(q2))) + m3*l1*(l2*u3^2*sin(q2)*sin(q3) + l2*u3^2*cos(q2)*cos(q3))
    let r4_by_q3 = (-s2_part_2_m3_l1)
        .mul_add(
            r1_part_4_scaled,
            (u3_l2_u3 * s2_part_2).mul_add(m3_l1, -r4_by_q2_part),
        );
    // Shared terms.
    // m0*(m3 + 2*s5_part_3); used 2 times
    let s5_by_q3_part = m0 * (s5_part_3.mul_add(S::int(2), m3));
    // Elimination, step by step.
    // s5_by_q3 = 2*m3*l0^2*(m0^2*sin(q3)*cos(q3) - sin(q1)*(m0*cos(q1)*(m0 + m1 + m2) +
    //   sin(q3)*(sin(q1)*cos(q3)*(m2*(m2 + m3) + m0*(2*m0 + 2*m1 + 2*m2 + m3) + m1*(m1 + 2*m2 + m3)) -
    //   m0*cos(q1)*sin(q3)*(2*m0 + 2*m1 + 2*m2 + m3))))/(m0 + m1 + m2 + m3*sin(q3)^2)^2
    let s5_by_q3 = S::int(2) * m3 * s5_part_4 * s5_part_4 * l0_sq
        * ((-s1)
            .mul_add(
                s3
                    .mul_add(
                        (-c1_s3)
                            .mul_add(
                                s5_by_q3_part,
                                s1_c3
                                    * (m2
                                        .mul_add(m2_plus_m3, m1 * (m2.mul_add(S::int(2), m1) + m3))
                                        + s5_by_q3_part),
                            ),
                        m0 * s5_part_3 * c1,
                    ),
                m0 * m0 * s3 * c3,
            ));
    // Shared terms.
    // 2*c3_m3_s3; used 4 times
    let c3_m3_s3_scaled = S::int(2) * c3_m3_s3;
    // l0*(s3_m3_s3*sin(q1) - s1_c3*m3_c3 + c3_m3_s3_scaled*cos(q1)); used 2 times
    let s6_by_q3_part = l0
        * (c3_m3_s3_scaled.mul_add(c1, (-s1_c3).mul_add(m3_c3, s3_m3_s3 * s1)));
    // s6_by_q3_part - s5_part_2_s5_part_4*c3_m3_s3_scaled; used 2 times
    let s6_by_q3_part_2 = (-s5_part_2_s5_part_4).mul_add(c3_m3_s3_scaled, s6_by_q3_part);
    // m3_s3_s2_part_2 - s6_part*m3_c3; used 2 times
    let s6_by_q3_part_3 = (-s6_part).mul_add(m3_c3, m3_s3_s2_part_2);
    // l1*s6_by_q3_part_3; used 3 times
    let l1_s6_by_q3_part_3 = l1 * s6_by_q3_part_3;
    // Elimination, step by step.
    // s6_by_q3 = 2*m3*l0*l1*sin(q3)*cos(q3)*(m3*sin(q1)*sin(q3)*cos(q3) - cos(q1)*(m1 + m2 +
    //   m3*sin(q3)^2))*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2)^2 + l0*l1*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) -
    //   m2*cos(q2))*(m3*sin(q1)*sin(q3)^2 - m3*sin(q1)*cos(q3)^2 + 2*m3*cos(q1)*sin(q3)*cos(q3))/(m0 + m1 +
    //   m2 + m3*sin(q3)^2) + l0*l1*(m3*sin(q1)*sin(q3)*cos(q3) - cos(q1)*(m1 + m2 +
    //   m3*sin(q3)^2))*(m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) + m3*cos(q3)*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) + s2_by_q3
    let s6_by_q3 = (-s5_part_2_s5_part_4)
        .mul_add(
            l1_s6_by_q3_part_3,
            s5_part_4_s6_part_2.mul_add(s6_by_q3_part_2, s2_by_q3),
        );
    // Shared terms.
    // s5_part_4_s6_part_2*c3_m3_s3_scaled; used 2 times
    let s7_by_q3_part = s5_part_4_s6_part_2 * c3_m3_s3_scaled;
    // Elimination, step by step.
    // s7_by_q3 = 2*m3*l1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(cos(q2)*sin(q3) - sin(q2)*cos(q3)) +
    //   2*m3*l1^2*sin(q3)*cos(q3)*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))^2/(m0 + m1 +
    //   m2 + m3*sin(q3)^2)^2 + 2*l1^2*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) -
    //   m2*cos(q2))*(m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) + m3*cos(q3)*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s7_by_q3 = s5_part_4_s6_part_2
        .mul_add(
            s7_by_q3_part,
            s7_by_q2_part.mul_add(s6_by_q3_part_3, -s7_by_q2_part_2),
        );
    // Shared terms.
    // r1_by_q3*s5_part_2_s5_part_4 + r1_s5_part_4*s6_by_q3_part_2
    let r8_by_q3_part = r1_s5_part_4
        .mul_add(s6_by_q3_part_2, r1_by_q3 * s5_part_2_s5_part_4);
    // r3_by_q3 + r8_by_q3_part; used 2 times
    let r8_by_q3_part_2 = r3_by_q3 + r8_by_q3_part;
    // s5_by_q3*s6_s5_inv; used 2 times
    let s5_by_q3_s6_s5_inv = s5_by_q3 * s6_s5_inv;
    // Elimination, step by step.
    // r8_by_q3 = 2*m3*l1*r1*sin(q3)*cos(q3)*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) -
    //   m2*cos(q2))/(m0 + m1 + m2 + m3*sin(q3)^2)^2 + l1*r1*(m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))
    //   + m3*cos(q3)*(cos(q2)*sin(q3) - sin(q2)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) +
    //   l1*r1_by_q3*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) - s6*(2*m3*l0*r1*sin(q3)*cos(q3)*(m3*sin(q1)*sin(q3)*cos(q3) - cos(q1)*(m1 + m2 +
    //   m3*sin(q3)^2))/(m0 + m1 + m2 + m3*sin(q3)^2)^2 + l0*r1*(m3*sin(q1)*sin(q3)^2 - m3*sin(q1)*cos(q3)^2
    //   + 2*m3*cos(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + l0*r1_by_q3*(cos(q1)*(m1 + m2 +
    //   m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r3_by_q3)/s5 + r4_by_q3
    //   + s6*s5_by_q3*(l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r3)/s5^2 - s6_by_q3*(l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r3)/s5
    let r8_by_q3 = r8_part_s5_inv
        .mul_add(
            s5_by_q3_s6_s5_inv - s6_by_q3,
            (-s6_s5_inv)
                .mul_add(
                    r8_by_q3_part_2,
                    r1_s5_part_4
                        .mul_add(
                            l1_s6_by_q3_part_3 + s7_by_q3_part,
                            (-r1_by_q3).mul_add(s5_part_4_s6_part_2, r4_by_q3),
                        ),
                ),
        );
    // u2_dot_by_q3 = (r8*(s6*(s6*s5_by_q3/s5 - 2*s6_by_q3)/s5 + s7_by_q3)/(s6^2/s5 - s7) + r8_by_q3)/(s7 -
    //   s6^2/s5)
    let u2_dot_by_q3 = u2_dot_part
        * ((-u2_dot)
            .mul_add(
                s6_s5_inv
                    .mul_add(
                        (-s6_by_q3).mul_add(S::int(2), s5_by_q3_s6_s5_inv),
                        s7_by_q3,
                    ),
                r8_by_q3,
            ));
    // u1_dot_by_q3 = s5_by_q3*(u2'*s6 - l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) - r3)/s5^2 +
    //   (2*m3*l0*r1*sin(q3)*cos(q3)*(m3*sin(q1)*sin(q3)*cos(q3) - cos(q1)*(m1 + m2 + m3*sin(q3)^2))/(m0 + m1
    //   + m2 + m3*sin(q3)^2)^2 + l0*r1*(m3*sin(q1)*sin(q3)^2 - m3*sin(q1)*cos(q3)^2 +
    //   2*m3*cos(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + l0*r1_by_q3*(cos(q1)*(m1 + m2 +
    //   m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r3_by_q3 - u2'*s6_by_q3
    //   - s6*u2_dot_by_q3)/s5
    let u1_dot_by_q3 = (-s5_by_q3)
        .mul_add(
            u1_dot_s5_inv,
            s5_inv
                * ((-s6)
                    .mul_add(u2_dot_by_q3, (-u2_dot).mul_add(s6_by_q3, r8_by_q3_part_2))),
        );
    // Shared terms.
    // r1_by_q3 + u1_dot_by_q3*s5_part_2 - u2_dot_by_q3*s6_part_2 + u1'*s6_by_q3_part +
    //   u2'*l1_s6_by_q3_part_3
    let u0_dot_by_q3_part = u2_dot
        .mul_add(
            l1_s6_by_q3_part_3,
            u1_dot
                .mul_add(
                    s6_by_q3_part,
                    (-u2_dot_by_q3)
                        .mul_add(s6_part_2, u1_dot_by_q3.mul_add(s5_part_2, r1_by_q3)),
                ),
        );
    // Elimination, step by step.
    // u0_dot_by_q3 = (l0*u1'*(m3*sin(q1)*sin(q3)^2 - m3*sin(q1)*cos(q3)^2 + 2*m3*cos(q1)*sin(q3)*cos(q3))
    //   + l1*u2'*(m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) + m3*cos(q3)*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3))) + r1_by_q3 + l1*u2_dot_by_q3*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3))) + l0*u1_dot_by_q3*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) -
    //   2*m3*sin(q3)*cos(q3)*(l0*u1'*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3)) +
    //   l1*u2'*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3))) + r1)/(m0 + m1 + m2 +
    //   m3*sin(q3)^2)^2
    let u0_dot_by_q3 = s5_part_4
        * ((-u0_dot).mul_add(c3_m3_s3_scaled, u0_dot_by_q3_part));
    // Shared terms.
    // u1_dot_by_q3 + u1_sq; used 2 times
    let u3_dot_by_q3_part = u1_dot_by_q3 + u1_sq;
    // u2_dot_by_q3 + u2_sq; used 2 times
    let u3_dot_by_q3_part_2 = u2_dot_by_q3 + u2_sq;
    // Elimination, step by step.
    // u3_dot_by_q3 = (cos(q3)*(g - l1*(u2'*sin(q2) + cos(q2)*(u2^2 + u2_dot_by_q3)) - l0*(u1'*sin(q1) +
    //   cos(q1)*(u1^2 + u1_dot_by_q3)) + u0_dot_by_q3) - sin(q3)*(u0' + l1*(sin(q2)*(u2^2 + u2_dot_by_q3) -
    //   u2'*cos(q2)) + l0*(sin(q1)*(u1^2 + u1_dot_by_q3) - u1'*cos(q1))))/l2
    let u3_dot_by_q3 = l2_inv
        * ((-s3)
            .mul_add(
                l1
                    .mul_add(
                        (-u2_dot).mul_add(c2, u3_dot_by_q3_part_2 * s2_2),
                        l0.mul_add((-u1_dot).mul_add(c1, u3_dot_by_q3_part * s1), u0_dot),
                    ),
                c3
                    * ((-l1)
                        .mul_add(
                            u3_dot_by_q3_part_2.mul_add(c2, u2_dot * s2_2),
                            (-l0)
                                .mul_add(
                                    u3_dot_by_q3_part.mul_add(c1, u1_dot * s1),
                                    g + u0_dot_by_q3,
                                ),
                        )),
            ));
    // r1_by_u1 = -2*l0*u1*(m3*cos(q1)*sin(q3)*cos(q3) + sin(q1)*(m1 + m2 + m3*sin(q3)^2))
    let r1_by_u1 = -S::int(2) * l0_u1 * s5_by_q1_part;
    // r3_by_u1 = 2*m3*l0*(sin(q1)*sin(q3) + cos(q1)*cos(q3))*(l0*u1*cos(q1)*sin(q3) -
    //   l0*u1*sin(q1)*cos(q3))
    let r3_by_u1 = -l0_u1 * s2_by_q1_part * m3_l0_s2_part_scaled;
    // Shared terms.
    // cos(q3)*(s2_part_2*sin(q1) + s6_part*cos(q1)); used 2 times
    let r4_by_u1_part = c3 * (s6_part.mul_add(c1, s2_part_2 * s1));
    // m2*r4_part_3; used 2 times
    let m2_r4_part_3 = m2 * r4_part_3;
    // Elimination, step by step.
    // r4_by_u1 = 2*l0*l1*u1*(m2*(sin(q1)*cos(q2) - cos(q1)*sin(q2)) + m3*(sin(q1)*cos(q2) -
    //   cos(q3)*(sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) + cos(q1)*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3)))))
    let r4_by_u1 = l0_u1 * l1_scaled * (m3.mul_add(s1_c2 - r4_by_u1_part, m2_r4_part_3));
    // Shared terms.
    // r3_by_u1 + r1_by_u1*s5_part_2_s5_part_4; used 2 times
    let r8_by_u1_part = r1_by_u1.mul_add(s5_part_2_s5_part_4, r3_by_u1);
    // Elimination, step by step.
    // r8_by_u1 = l1*r1_by_u1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) - s6*(l0*r1_by_u1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0
    //   + m1 + m2 + m3*sin(q3)^2) + r3_by_u1)/s5 + r4_by_u1
    let r8_by_u1 = (-s6_s5_inv)
        .mul_add(r8_by_u1_part, (-r1_by_u1).mul_add(s5_part_4_s6_part_2, r4_by_u1));
    // Shared terms.
    // r8_by_u1*u2_dot_part; used 4 times
    let r8_by_u1_u2_dot_part = r8_by_u1 * u2_dot_part;
    // Elimination, step by step.
    // u1_dot_by_u1 = (l0*r1_by_u1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1
    //   + m2 + m3*sin(q3)^2) + r3_by_u1 + s6*r8_by_u1/(s6^2/s5 - s7))/s5
    let u1_dot_by_u1 = s5_inv * ((-s6).mul_add(r8_by_u1_u2_dot_part, r8_by_u1_part));
    // u0_dot_by_u1 = (r1_by_u1 + l1*r8_by_u1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3)))/(s7 - s6^2/s5) + l0*u1_dot_by_u1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let u0_dot_by_u1 = s5_part_4
        * ((-s6_part_2)
            .mul_add(r8_by_u1_u2_dot_part, u1_dot_by_u1.mul_add(s5_part_2, r1_by_u1)));
    // u3_dot_by_u1 = (l1*r8_by_u1*(sin(q2)*sin(q3) + cos(q2)*cos(q3))/(s6^2/s5 - s7) +
    //   l0*(2*u1*(sin(q1)*cos(q3) - cos(q1)*sin(q3)) - u1_dot_by_u1*(sin(q1)*sin(q3) + cos(q1)*cos(q3))) +
    //   u0_dot_by_u1*cos(q3))/l2
    let u3_dot_by_u1 = l2_inv
        * ((-l1_s2_part_2)
            .mul_add(
                r8_by_u1_u2_dot_part,
                l0
                    .mul_add(
                        (-u1_dot_by_u1).mul_add(s2_part, S::int(2) * u1 * s2_by_q1_part),
                        u0_dot_by_u1 * c3,
                    ),
            ));
    // Shared terms.
    // 2*l1_u2; used 2 times
    let l1_u2_scaled = S::int(2) * l1_u2;
    // Elimination, step by step.
    // r1_by_u2 = -2*l1*u2*(m2*sin(q2) + m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)))
    let r1_by_u2 = -s6_by_q2_part * l1_u2_scaled;
    // r3_by_u2 = -2*l0*l1*u2*(m2*(sin(q1)*cos(q2) - cos(q1)*sin(q2)) +
    //   m3*(cos(q3)*(sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) + cos(q1)*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3))) - cos(q1)*sin(q2)))
    let r3_by_u2 = -l0 * l1_u2_scaled
        * (m3.mul_add(r4_by_u1_part - c1_s2_2, m2_r4_part_3));
    // r4_by_u2 = 2*m3*l1*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(l1*u2*cos(q2)*sin(q3) -
    //   l1*u2*sin(q2)*cos(q3))
    let r4_by_u2 = -S::int(2) * l1_u2 * s2_part_2_m3_l1 * s6_part;
    // Shared terms.
    // r3_by_u2 + r1_by_u2*s5_part_2_s5_part_4; used 2 times
    let r8_by_u2_part = r1_by_u2.mul_add(s5_part_2_s5_part_4, r3_by_u2);
    // Elimination, step by step.
    // r8_by_u2 = l1*r1_by_u2*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) - s6*(l0*r1_by_u2*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0
    //   + m1 + m2 + m3*sin(q3)^2) + r3_by_u2)/s5 + r4_by_u2
    let r8_by_u2 = (-s6_s5_inv)
        .mul_add(r8_by_u2_part, (-r1_by_u2).mul_add(s5_part_4_s6_part_2, r4_by_u2));
    // Shared terms.
    // r8_by_u2*u2_dot_part; used 4 times
    let r8_by_u2_u2_dot_part = r8_by_u2 * u2_dot_part;
    // Elimination, step by step.
    // u1_dot_by_u2 = (l0*r1_by_u2*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1
    //   + m2 + m3*sin(q3)^2) + r3_by_u2 + s6*r8_by_u2/(s6^2/s5 - s7))/s5
    let u1_dot_by_u2 = s5_inv * ((-s6).mul_add(r8_by_u2_u2_dot_part, r8_by_u2_part));
    // u0_dot_by_u2 = (r1_by_u2 + l1*r8_by_u2*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3)))/(s7 - s6^2/s5) + l0*u1_dot_by_u2*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let u0_dot_by_u2 = s5_part_4
        * ((-s6_part_2)
            .mul_add(r8_by_u2_u2_dot_part, u1_dot_by_u2.mul_add(s5_part_2, r1_by_u2)));
    // u3_dot_by_u2 = (l1*(2*u2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) + r8_by_u2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3))/(s6^2/s5 - s7)) - l0*u1_dot_by_u2*(sin(q1)*sin(q3) + cos(q1)*cos(q3)) +
    //   u0_dot_by_u2*cos(q3))/l2
    let u3_dot_by_u2 = l2_inv
        * (l1
            .mul_add(
                (-s2_part_2).mul_add(r8_by_u2_u2_dot_part, S::int(2) * u2 * s6_part),
                (-u1_dot_by_u2).mul_add(l0_s2_part, u0_dot_by_u2 * c3),
            ));
    // Shared terms.
    // 2*l2_u3; used 3 times
    let l2_u3_scaled = S::int(2) * l2_u3;
    // Elimination, step by step.
    // r1_by_u3 = -2*m3*l2*u3*sin(q3)
    let r1_by_u3 = -m3_s3 * l2_u3_scaled;
    // r3_by_u3 = 2*m3*l0*l2*u3*(cos(q1)*sin(q3) - sin(q1)*cos(q3))
    let r3_by_u3 = -m3_l0_s2_by_q1_part * l2_u3_scaled;
    // r4_by_u3 = 2*m3*l1*l2*u3*(cos(q2)*sin(q3) - sin(q2)*cos(q3))
    let r4_by_u3 = -m3_l1_s6_part * l2_u3_scaled;
    // Shared terms.
    // r3_by_u3 + r1_by_u3*s5_part_2_s5_part_4; used 2 times
    let r8_by_u3_part = r1_by_u3.mul_add(s5_part_2_s5_part_4, r3_by_u3);
    // Elimination, step by step.
    // r8_by_u3 = l1*r1_by_u3*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) - s6*(l0*r1_by_u3*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0
    //   + m1 + m2 + m3*sin(q3)^2) + r3_by_u3)/s5 + r4_by_u3
    let r8_by_u3 = (-s6_s5_inv)
        .mul_add(r8_by_u3_part, (-r1_by_u3).mul_add(s5_part_4_s6_part_2, r4_by_u3));
    // Shared terms.
    // r8_by_u3*u2_dot_part; used 4 times
    let r8_by_u3_u2_dot_part = r8_by_u3 * u2_dot_part;
    // Elimination, step by step.
    // u1_dot_by_u3 = (l0*r1_by_u3*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1
    //   + m2 + m3*sin(q3)^2) + r3_by_u3 + s6*r8_by_u3/(s6^2/s5 - s7))/s5
    let u1_dot_by_u3 = s5_inv * ((-s6).mul_add(r8_by_u3_u2_dot_part, r8_by_u3_part));
    // u0_dot_by_u3 = (r1_by_u3 + l1*r8_by_u3*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3)))/(s7 - s6^2/s5) + l0*u1_dot_by_u3*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let u0_dot_by_u3 = s5_part_4
        * ((-s6_part_2)
            .mul_add(r8_by_u3_u2_dot_part, u1_dot_by_u3.mul_add(s5_part_2, r1_by_u3)));
    // Shared terms.
    // l1*r8_by_u3_u2_dot_part; used 2 times
    let u3_dot_by_u3_part = l1 * r8_by_u3_u2_dot_part;
    // Elimination, step by step.
    // u3_dot_by_u3 = -(sin(q3)*(l1*r8_by_u3*sin(q2)/(s7 - s6^2/s5) + l0*u1_dot_by_u3*sin(q1)) +
    //   cos(q3)*(l1*r8_by_u3*cos(q2)/(s7 - s6^2/s5) + l0*u1_dot_by_u3*cos(q1) - u0_dot_by_u3))/l2
    let u3_dot_by_u3 = -l2_inv
        * (c3
            .mul_add(
                u3_dot_by_u3_part
                    .mul_add(c2, u1_dot_by_u3.mul_add(l0_c1, -u0_dot_by_u3)),
                s3 * (u3_dot_by_u3_part.mul_add(s2_2, u1_dot_by_u3 * l0_s1)),
            ));
    // Entries that are not zero.
    // d(q0')/d(u0) = 1
    let q0_dot_by_u0_value = S::int(1);
    // d(q1')/d(u1) = 1
    let q1_dot_by_u1_value = S::int(1);
    // d(q2')/d(u2) = 1
    let q2_dot_by_u2_value = S::int(1);
    // d(q3')/d(u3) = 1
    let q3_dot_by_u3_value = S::int(1);
    // d(u2')/d(u1) = r8_by_u1/(s7 - s6^2/s5)
    let u2_dot_by_u1_value = r8_by_u1_u2_dot_part;
    // d(u2')/d(u2) = r8_by_u2/(s7 - s6^2/s5)
    let u2_dot_by_u2_value = r8_by_u2_u2_dot_part;
    // d(u2')/d(u3) = r8_by_u3/(s7 - s6^2/s5)
    let u2_dot_by_u3_value = r8_by_u3_u2_dot_part;
    [
        [zero, zero, zero, zero, q0_dot_by_u0_value, zero, zero, zero],
        [zero, zero, zero, zero, zero, q1_dot_by_u1_value, zero, zero],
        [zero, zero, zero, zero, zero, zero, q2_dot_by_u2_value, zero],
        [zero, zero, zero, zero, zero, zero, zero, q3_dot_by_u3_value],
        [
            zero,
            u0_dot_by_q1,
            u0_dot_by_q2,
            u0_dot_by_q3,
            zero,
            u0_dot_by_u1,
            u0_dot_by_u2,
            u0_dot_by_u3,
        ],
        [
            zero,
            u1_dot_by_q1,
            u1_dot_by_q2,
            u1_dot_by_q3,
            zero,
            u1_dot_by_u1,
            u1_dot_by_u2,
            u1_dot_by_u3,
        ],
        [
            zero,
            u2_dot_by_q1,
            u2_dot_by_q2,
            u2_dot_by_q3,
            zero,
            u2_dot_by_u1_value,
            u2_dot_by_u2_value,
            u2_dot_by_u3_value,
        ],
        [
            zero,
            u3_dot_by_q1,
            u3_dot_by_q2,
            u3_dot_by_q3,
            zero,
            u3_dot_by_u1,
            u3_dot_by_u2,
            u3_dot_by_u3,
        ],
    ]
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
/// 36 operations, 6 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> S {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, .. } = *p;
    let [_, q1, q2, q3] = *q;
    let [u0, u1, u2, u3] = *u;
    // Sines and cosines.
    let (_, c3) = q3.sin_cos();
    let (_, c1) = q1.sin_cos();
    let (_, c2) = q2.sin_cos();
    // Shared terms.
    // m2 + m3; used 2 times
    let m2_plus_m3 = m2 + m3;
    // m1 + m2_plus_m3; used 2 times
    let energy_part = m1 + m2_plus_m3;
    // l0*u1; used 4 times
    let l0_u1 = l0 * u1;
    // energy_part*l0_u1; used 2 times
    let energy_part_l0_u1 = energy_part * l0_u1;
    // l1*u2; used 3 times
    let l1_u2 = l1 * u2;
    // m2_plus_m3*l1_u2; used 2 times
    let m2_plus_m3_l1_u2 = m2_plus_m3 * l1_u2;
    // l2*u3; used 2 times
    let l2_u3 = l2 * u3;
    // m3*l2_u3; used 2 times
    let m3_l2_u3 = m3 * l2_u3;
    // Sines and cosines.
    let (_, cos_q1_minus_q3) = (q1 - q3).sin_cos();
    // Shared terms.
    // u0*cos(q3) - l0_u1*cos(q1 - q3)
    let energy_part_2 = (-l0_u1).mul_add(cos_q1_minus_q3, u0 * c3);
    // u0^2*(m0 + energy_part) + l2_u3*m3_l2_u3
    let energy_part_3 = l2_u3.mul_add(m3_l2_u3, u0 * u0 * (m0 + energy_part));
    // l0_u1*energy_part_l0_u1 + l1_u2*m2_plus_m3_l1_u2
    let energy_part_4 = l1_u2.mul_add(m2_plus_m3_l1_u2, l0_u1 * energy_part_l0_u1);
    // energy_part_3 + energy_part_4
    let energy_part_5 = energy_part_3 + energy_part_4;
    // Sines and cosines.
    let (_, cos_q1_minus_q2) = (q1 - q2).sin_cos();
    let (_, cos_q2_minus_q3) = (q2 - q3).sin_cos();
    // Values.
    // T = u0^2*(m0 + m1 + m2 + m3)/2 + l0^2*u1^2*(m1 + m2 + m3)/2 - l0*u0*u1*cos(q1)*(m1 + m2 + m3) +
    //   l1^2*u2^2*(m2 + m3)/2 - l1*u0*u2*cos(q2)*(m2 + m3) + l0*l1*u1*u2*cos(q1 - q2)*(m2 + m3) +
    //   m3*l2^2*u3^2/2 - m3*l2*u0*u3*cos(q3) + m3*l0*l2*u1*u3*cos(q1 - q3) + m3*l1*l2*u2*u3*cos(q2 - q3)
    let energy = m3_l2_u3
        .mul_add(
            l1_u2.mul_add(cos_q2_minus_q3, -energy_part_2),
            (-(u0 * energy_part_l0_u1))
                .mul_add(
                    c1,
                    m2_plus_m3_l1_u2 * ((-u0).mul_add(c2, l0_u1 * cos_q1_minus_q2)),
                ),
        ) + S::ratio(1, 2) * energy_part_5;
    energy
}

/// Potential energy V of gravity.
///
/// 11 operations, 3 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 4]) -> S {
    let Parameters { m1, m2, m3, l0, l1, l2, g, .. } = *p;
    let [_, q1, q2, q3] = *q;
    // Sines and cosines.
    let (_, c1) = q1.sin_cos();
    let (_, c2) = q2.sin_cos();
    let (_, c3) = q3.sin_cos();
    // Shared terms.
    // l0*cos(q1); used 2 times
    let l0_c1 = l0 * c1;
    // l1*cos(q2) + l0_c1; used 2 times
    let energy_part = l1.mul_add(c2, l0_c1);
    // Values.
    // V = g*(m1*l0*cos(q1) + m2*(l0*cos(q1) + l1*cos(q2)) + m3*(l0*cos(q1) + l1*cos(q2) + l2*cos(q3)))
    let energy = g
        * (m3.mul_add(l2.mul_add(c3, energy_part), m2.mul_add(energy_part, m1 * l0_c1)));
    energy
}

/// Newton–Euler equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEuler;

impl<S: Scalar> System<S> for NewtonEuler {
    fn parameters(&self) -> usize {
        9
    }
    fn coordinates(&self) -> usize {
        4
    }
    fn speeds(&self) -> usize {
        4
    }
    fn reactions(&self) -> usize {
        4
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
    fn has_accelerations(&self) -> bool {
        true
    }
    fn accelerations(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &accelerations(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn derivative(&self, p: &[S], q: &[S], v: &[S], q_dot: &mut [S], v_dot: &mut [S]) {
        let (of_q, of_v) = derivative(&Parameters::from_slice(p), array(q), array(v));
        q_dot.copy_from_slice(&of_q);
        v_dot.copy_from_slice(&of_v);
    }
    fn jacobian(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            jacobian(&Parameters::from_slice(p), array(q), array(v)).as_flattened(),
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

fn array<S, const N: usize>(slice: &[S]) -> &[S; N] {
    slice.try_into().expect("a slice of the length that System states")
}
