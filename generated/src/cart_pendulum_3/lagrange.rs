//! Three-link pendulum on a cart: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/cart_pendulum_3/model.toml`. Do not edit; run `tripos regenerate`.
//! 4 coordinates, 4 speeds, 9 parameters. Unknowns: (q0'', q1'', q2'', q3'').
//! Cost: mass_matrix 24 operations, 6 sines and cosines; forcing 39 operations, 6 sines and cosines; accelerations 131 operations, 6 sines and cosines.
//! The kinematic equations are singular nowhere.
//! The accelerations divide by m0 + m1 + m2 + m3*sin(q3)^2, by s4, by s6 - s5^2/s4, by l2.

use super::Parameters;
use tripos_traits::{Scalar, System};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows q0, q1, q2, q3.
///
/// 24 operations, 6 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    _q_dot: &[S; 4],
) -> [[S; 4]; 4] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, .. } = *p;
    let [_, q1, q2, q3] = *q;
    // Sines and cosines.
    let (_, c1) = q1.sin_cos();
    let (_, c2) = q2.sin_cos();
    let (_, c3) = q3.sin_cos();
    // Shared terms.
    // m2 + m3; used 2 times
    let m2_plus_m3 = m2 + m3;
    // m1 + m2_plus_m3; used 2 times
    let m11_part = m1 + m2_plus_m3;
    // l0*m11_part; used 2 times
    let l0_m11_part = l0 * m11_part;
    // l1*m2_plus_m3; used 3 times
    let l1_m2_plus_m3 = l1 * m2_plus_m3;
    // m3*l2; used 4 times
    let m3_l2 = m3 * l2;
    // Sines and cosines.
    let (_, cos_q1_minus_q2) = (q1 - q2).sin_cos();
    let (_, cos_q1_minus_q3) = (q1 - q3).sin_cos();
    let (_, cos_q2_minus_q3) = (q2 - q3).sin_cos();
    // Entries that are not zero; upper triangle.
    // M11 = m0 + m1 + m2 + m3
    let m11 = m0 + m11_part;
    // M12 = -l0*cos(q1)*(m1 + m2 + m3)
    let m12 = -l0_m11_part * c1;
    // M13 = -l1*cos(q2)*(m2 + m3)
    let m13 = -l1_m2_plus_m3 * c2;
    // M14 = -m3*l2*cos(q3)
    let m14 = -m3_l2 * c3;
    // M22 = l0^2*(m1 + m2 + m3)
    let m22 = l0 * l0_m11_part;
    // M23 = l0*l1*cos(q1 - q2)*(m2 + m3)
    let m23 = l0 * l1_m2_plus_m3 * cos_q1_minus_q2;
    // M24 = m3*l0*l2*cos(q1 - q3)
    let m24 = l0 * m3_l2 * cos_q1_minus_q3;
    // M33 = l1^2*(m2 + m3)
    let m33 = l1 * l1_m2_plus_m3;
    // M34 = m3*l1*l2*cos(q2 - q3)
    let m34 = l1 * m3_l2 * cos_q2_minus_q3;
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
/// 39 operations, 6 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 4], q_dot: &[S; 4]) -> [S; 4] {
    let Parameters { m1, m2, m3, l0, l1, l2, g, F, .. } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s1, _) = q1.sin_cos();
    let (s2, _) = q2.sin_cos();
    let (s3, _) = q3.sin_cos();
    // Shared terms.
    // m3*l2; used 2 times
    let m3_l2 = m3 * l2;
    // q3'^2*m3_l2; used 3 times
    let q3_dot_sq_m3_l2 = q3_dot * q3_dot * m3_l2;
    // l0*q1'^2; used 3 times
    let l0_q1_dot_sq = l0 * q1_dot * q1_dot;
    // m2 + m3; used 2 times
    let m2_plus_m3 = m2 + m3;
    // sin(q1)*(m1 + m2_plus_m3); used 2 times
    let f1_part = s1 * (m1 + m2_plus_m3);
    // q2'^2; used 3 times
    let q2_dot_sq = q2_dot * q2_dot;
    // l1*m2_plus_m3; used 2 times
    let l1_m2_plus_m3 = l1 * m2_plus_m3;
    // l1_m2_plus_m3*sin(q2); used 2 times
    let s2_l1_m2_plus_m3 = l1_m2_plus_m3 * s2;
    // Sines and cosines.
    let (sin_q1_minus_q2, _) = (q1 - q2).sin_cos();
    // Shared terms.
    // l1_m2_plus_m3*sin(q1 - q2); used 2 times
    let f2_part = l1_m2_plus_m3 * sin_q1_minus_q2;
    // Sines and cosines.
    let (sin_q1_minus_q3, _) = (q1 - q3).sin_cos();
    // Shared terms.
    // g*f1_part - q3_dot_sq_m3_l2*sin(q1 - q3)
    let f2_part_2 = (-q3_dot_sq_m3_l2).mul_add(sin_q1_minus_q3, g * f1_part);
    // Sines and cosines.
    let (sin_q2_minus_q3, _) = (q2 - q3).sin_cos();
    // Shared terms.
    // l1*sin(q2 - q3); used 2 times
    let l1_sin_q2_minus_q3 = l1 * sin_q2_minus_q3;
    // g*sin(q3) + l0_q1_dot_sq*sin(q1 - q3)
    let f4_part = l0_q1_dot_sq.mul_add(sin_q1_minus_q3, g * s3);
    // Values.
    // f1 = F - l0*q1'^2*sin(q1)*(m1 + m2 + m3) - l1*q2'^2*sin(q2)*(m2 + m3) - m3*l2*q3'^2*sin(q3)
    let f1 = (-q2_dot_sq)
        .mul_add(
            s2_l1_m2_plus_m3,
            (-l0_q1_dot_sq).mul_add(f1_part, (-q3_dot_sq_m3_l2).mul_add(s3, F)),
        );
    // f2 = l0*(m1*g*sin(q1) - m2*(l1*q2'^2*sin(q1 - q2) - g*sin(q1)) - m3*(l1*q2'^2*sin(q1 - q2) -
    //   g*sin(q1) + l2*q3'^2*sin(q1 - q3)))
    let f2 = l0 * ((-q2_dot_sq).mul_add(f2_part, f2_part_2));
    // f3 = l1*(m2*(g*sin(q2) + l0*q1'^2*sin(q1 - q2)) + m3*(g*sin(q2) + l0*q1'^2*sin(q1 - q2) -
    //   l2*q3'^2*sin(q2 - q3)))
    let f3 = (-q3_dot_sq_m3_l2)
        .mul_add(
            l1_sin_q2_minus_q3,
            l0_q1_dot_sq.mul_add(f2_part, g * s2_l1_m2_plus_m3),
        );
    // f4 = m3*l2*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3))
    let f4 = m3_l2 * (q2_dot_sq.mul_add(l1_sin_q2_minus_q3, f4_part));
    [f1, f2, f3, f4]
}

/// The accelerations (q0'', q1'', q2'', q3''), solved for when this code was generated.
///
/// 131 operations, 6 sines and cosines.
#[must_use]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    q_dot: &[S; 4],
) -> [S; 4] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // q1'^2; used 2 times
    let q1_dot_sq = q1_dot * q1_dot;
    // l0*q1_dot_sq; used 5 times
    let l0_q1_dot_sq = l0 * q1_dot_sq;
    // q2'^2; used 2 times
    let q2_dot_sq = q2_dot * q2_dot;
    // l1*q2_dot_sq; used 4 times
    let l1_q2_dot_sq = l1 * q2_dot_sq;
    // l0_q1_dot_sq*sin(q1) + l1_q2_dot_sq*sin(q2); used 2 times
    let r1_part = l1_q2_dot_sq.mul_add(s2, l0_q1_dot_sq * s1);
    // m1*sin(q1); used 2 times
    let m1_s1 = m1 * s1;
    // l2*q3'^2; used 3 times
    let l2_q3_dot_sq = l2 * q3_dot * q3_dot;
    // m3*sin(q3); used 2 times
    let m3_s3 = m3 * s3;
    // Elimination, step by step.
    // r1 = F - m1*l0*q1'^2*sin(q1) - m2*(l0*q1'^2*sin(q1) + l1*q2'^2*sin(q2)) + m3*sin(q3)*(cos(q3)*(g -
    //   l0*q1'^2*cos(q1) - l1*q2'^2*cos(q2)) - sin(q3)*(l0*q1'^2*sin(q1) + l1*q2'^2*sin(q2)) - l2*q3'^2)
    let r1 = (-m3_s3)
        .mul_add(
            r1_part
                .mul_add(
                    s3,
                    c3 * (l1_q2_dot_sq.mul_add(c2, l0_q1_dot_sq.mul_add(c1, -g))),
                ) + l2_q3_dot_sq,
            (-l0_q1_dot_sq).mul_add(m1_s1, (-m2).mul_add(r1_part, F)),
        );
    // Shared terms.
    // q1 - q2; used 2 times
    let q1_minus_q2 = q1 - q2;
    // Sines and cosines.
    let (sin_q1_minus_q2, cos_q1_minus_q2) = q1_minus_q2.sin_cos();
    // Shared terms.
    // g*sin(q1) - l1_q2_dot_sq*sin(q1 - q2); used 2 times
    let r2_part = (-l1_q2_dot_sq).mul_add(sin_q1_minus_q2, g * s1);
    // g*sin(q3); used 2 times
    let g_s3 = g * s3;
    // q1 - q3; used 2 times
    let q1_minus_q3 = q1 - q3;
    // Sines and cosines.
    let (sin_q1_minus_q3, cos_q1_minus_q3) = q1_minus_q3.sin_cos();
    // Shared terms.
    // q2 - q3; used 2 times
    let q2_minus_q3 = q2 - q3;
    // Sines and cosines.
    let (sin_q2_minus_q3, cos_q2_minus_q3) = q2_minus_q3.sin_cos();
    // Shared terms.
    // l0_q1_dot_sq*sin(q1 - q3) + l1_q2_dot_sq*sin(q2 - q3) + g_s3; used 2 times
    let r2_part_2 = l1_q2_dot_sq.mul_add(sin_q2_minus_q3, l0_q1_dot_sq * sin_q1_minus_q3)
        + g_s3;
    // Elimination, step by step.
    // r2 = l0*(m1*g*sin(q1) - m2*(l1*q2'^2*sin(q1 - q2) - g*sin(q1)) - m3*(l1*q2'^2*sin(q1 - q2) -
    //   g*sin(q1) + cos(q1 - q3)*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)) +
    //   l2*q3'^2*sin(q1 - q3)))
    let r2 = l0
        * (m3
            .mul_add(
                (-r2_part_2)
                    .mul_add(
                        cos_q1_minus_q3,
                        (-l2_q3_dot_sq).mul_add(sin_q1_minus_q3, r2_part),
                    ),
                m2.mul_add(r2_part, g * m1_s1),
            ));
    // Shared terms.
    // g*sin(q2) + l0_q1_dot_sq*sin(q1 - q2); used 2 times
    let r3_part = l0_q1_dot_sq.mul_add(sin_q1_minus_q2, g * s2);
    // Elimination, step by step.
    // r3 = l1*(m2*(g*sin(q2) + l0*q1'^2*sin(q1 - q2)) + m3*(g*sin(q2) + l0*q1'^2*sin(q1 - q2) - cos(q2 -
    //   q3)*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)) - l2*q3'^2*sin(q2 - q3)))
    let r3 = l1
        * (m3
            .mul_add(
                (-r2_part_2)
                    .mul_add(
                        cos_q2_minus_q3,
                        (-l2_q3_dot_sq).mul_add(sin_q2_minus_q3, r3_part),
                    ),
                m2 * r3_part,
            ));
    // Shared terms.
    // m1 + m2; used 3 times
    let m1_plus_m2 = m1 + m2;
    // l0*(cos(q1)*(m3 + m1_plus_m2) - m3*cos(q3)*cos(q1 - q3)); used 3 times
    let s4_part = l0 * ((-(m3 * c3)).mul_add(cos_q1_minus_q3, c1 * (m3 + m1_plus_m2)));
    // 1/(m0 + m3_s3*sin(q3) + m1_plus_m2); used 3 times
    let s4_part_2 = S::int(1) / (m3_s3.mul_add(s3, m0) + m1_plus_m2);
    // s4_part*s4_part_2; used 3 times
    let s4_part_s4_part_2 = s4_part * s4_part_2;
    // Elimination, step by step.
    // s4 = l0^2*(m1 + m2 + m3*sin(q1 - q3)^2) - l0^2*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 -
    //   q3))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s4 = (-s4_part)
        .mul_add(
            s4_part_s4_part_2,
            l0 * l0 * (m3.mul_add(sin_q1_minus_q3 * sin_q1_minus_q3, m1_plus_m2)),
        );
    // Shared terms.
    // l1*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3))); used 4 times
    let s5_part = l1 * (m3.mul_add((-c3).mul_add(cos_q2_minus_q3, c2), m2 * c2));
    // Elimination, step by step.
    // s5 = l0*l1*(m3*cos(q3)*cos(q1 - q3) - cos(q1)*(m1 + m2 + m3))*(m2*cos(q2) + m3*(cos(q2) -
    //   cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) + l0*l1*(m2*cos(q1 - q2) + m3*(cos(q1 - q2) -
    //   cos(q1 - q3)*cos(q2 - q3)))
    let s5 = (-s4_part_s4_part_2)
        .mul_add(
            s5_part,
            l0 * l1
                * (m3
                    .mul_add(
                        (-cos_q1_minus_q3).mul_add(cos_q2_minus_q3, cos_q1_minus_q2),
                        m2 * cos_q1_minus_q2,
                    )),
        );
    // Shared terms.
    // s4_part_2*s5_part; used 2 times
    let s4_part_2_s5_part = s4_part_2 * s5_part;
    // Elimination, step by step.
    // s6 = l1^2*(m2 + m3*sin(q2 - q3)^2) - l1^2*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))^2/(m0 +
    //   m1 + m2 + m3*sin(q3)^2)
    let s6 = (-s5_part)
        .mul_add(
            s4_part_2_s5_part,
            l1 * l1 * (m3.mul_add(sin_q2_minus_q3 * sin_q2_minus_q3, m2)),
        );
    // Shared terms.
    // r2 + r1*s4_part_s4_part_2; used 2 times
    let r7_part = r1.mul_add(s4_part_s4_part_2, r2);
    // 1/s4; used 2 times
    let s4_inv = S::int(1) / s4;
    // s5*s4_inv; used 2 times
    let s5_s4_inv = s5 * s4_inv;
    // Elimination, step by step.
    // r7 = l1*r1*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) + r3 -
    //   s5*(l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2)/s4
    let r7 = (-r7_part).mul_add(s5_s4_inv, r1.mul_add(s4_part_2_s5_part, r3));
    // q2'' = r7/(s6 - s5^2/s4)
    let q2_ddot = r7 / ((-s5).mul_add(s5_s4_inv, s6));
    // q1'' = (l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2
    //   - q2''*s5)/s4
    let q1_ddot = s4_inv * ((-q2_ddot).mul_add(s5, r7_part));
    // q0'' = (l0*q1''*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3)) + l1*q2''*(m2*cos(q2) +
    //   m3*(cos(q2) - cos(q3)*cos(q2 - q3))) + r1)/(m0 + m1 + m2 + m3*sin(q3)^2)
    let q0_ddot = s4_part_2 * (q2_ddot.mul_add(s5_part, q1_ddot.mul_add(s4_part, r1)));
    // q3'' = (g*sin(q3) + q0''*cos(q3) + l0*(q1'^2*sin(q1 - q3) - q1''*cos(q1 - q3)) + l1*(q2'^2*sin(q2 -
    //   q3) - q2''*cos(q2 - q3)))/l2
    let q3_ddot = (l1
        .mul_add(
            (-q2_ddot).mul_add(cos_q2_minus_q3, q2_dot_sq * sin_q2_minus_q3),
            l0
                .mul_add(
                    (-q1_ddot).mul_add(cos_q1_minus_q3, q1_dot_sq * sin_q1_minus_q3),
                    q0_ddot * c3,
                ),
        ) + g_s3) / l2;
    [q0_ddot, q1_ddot, q2_ddot, q3_ddot]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 131 operations, 6 sines and cosines.
#[must_use]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    q_dot: &[S; 4],
) -> ([S; 4], [S; 4]) {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [q0_dot, q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // q1'^2; used 2 times
    let q1_dot_sq = q1_dot * q1_dot;
    // l0*q1_dot_sq; used 5 times
    let l0_q1_dot_sq = l0 * q1_dot_sq;
    // q2'^2; used 2 times
    let q2_dot_sq = q2_dot * q2_dot;
    // l1*q2_dot_sq; used 4 times
    let l1_q2_dot_sq = l1 * q2_dot_sq;
    // l0_q1_dot_sq*sin(q1) + l1_q2_dot_sq*sin(q2); used 2 times
    let r1_part = l1_q2_dot_sq.mul_add(s2, l0_q1_dot_sq * s1);
    // m1*sin(q1); used 2 times
    let m1_s1 = m1 * s1;
    // l2*q3'^2; used 3 times
    let l2_q3_dot_sq = l2 * q3_dot * q3_dot;
    // m3*sin(q3); used 2 times
    let m3_s3 = m3 * s3;
    // Elimination, step by step.
    // r1 = F - m1*l0*q1'^2*sin(q1) - m2*(l0*q1'^2*sin(q1) + l1*q2'^2*sin(q2)) + m3*sin(q3)*(cos(q3)*(g -
    //   l0*q1'^2*cos(q1) - l1*q2'^2*cos(q2)) - sin(q3)*(l0*q1'^2*sin(q1) + l1*q2'^2*sin(q2)) - l2*q3'^2)
    let r1 = (-m3_s3)
        .mul_add(
            r1_part
                .mul_add(
                    s3,
                    c3 * (l1_q2_dot_sq.mul_add(c2, l0_q1_dot_sq.mul_add(c1, -g))),
                ) + l2_q3_dot_sq,
            (-l0_q1_dot_sq).mul_add(m1_s1, (-m2).mul_add(r1_part, F)),
        );
    // Shared terms.
    // q1 - q2; used 2 times
    let q1_minus_q2 = q1 - q2;
    // Sines and cosines.
    let (sin_q1_minus_q2, cos_q1_minus_q2) = q1_minus_q2.sin_cos();
    // Shared terms.
    // g*sin(q1) - l1_q2_dot_sq*sin(q1 - q2); used 2 times
    let r2_part = (-l1_q2_dot_sq).mul_add(sin_q1_minus_q2, g * s1);
    // g*sin(q3); used 2 times
    let g_s3 = g * s3;
    // q1 - q3; used 2 times
    let q1_minus_q3 = q1 - q3;
    // Sines and cosines.
    let (sin_q1_minus_q3, cos_q1_minus_q3) = q1_minus_q3.sin_cos();
    // Shared terms.
    // q2 - q3; used 2 times
    let q2_minus_q3 = q2 - q3;
    // Sines and cosines.
    let (sin_q2_minus_q3, cos_q2_minus_q3) = q2_minus_q3.sin_cos();
    // Shared terms.
    // l0_q1_dot_sq*sin(q1 - q3) + l1_q2_dot_sq*sin(q2 - q3) + g_s3; used 2 times
    let r2_part_2 = l1_q2_dot_sq.mul_add(sin_q2_minus_q3, l0_q1_dot_sq * sin_q1_minus_q3)
        + g_s3;
    // Elimination, step by step.
    // r2 = l0*(m1*g*sin(q1) - m2*(l1*q2'^2*sin(q1 - q2) - g*sin(q1)) - m3*(l1*q2'^2*sin(q1 - q2) -
    //   g*sin(q1) + cos(q1 - q3)*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)) +
    //   l2*q3'^2*sin(q1 - q3)))
    let r2 = l0
        * (m3
            .mul_add(
                (-r2_part_2)
                    .mul_add(
                        cos_q1_minus_q3,
                        (-l2_q3_dot_sq).mul_add(sin_q1_minus_q3, r2_part),
                    ),
                m2.mul_add(r2_part, g * m1_s1),
            ));
    // Shared terms.
    // g*sin(q2) + l0_q1_dot_sq*sin(q1 - q2); used 2 times
    let r3_part = l0_q1_dot_sq.mul_add(sin_q1_minus_q2, g * s2);
    // Elimination, step by step.
    // r3 = l1*(m2*(g*sin(q2) + l0*q1'^2*sin(q1 - q2)) + m3*(g*sin(q2) + l0*q1'^2*sin(q1 - q2) - cos(q2 -
    //   q3)*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)) - l2*q3'^2*sin(q2 - q3)))
    let r3 = l1
        * (m3
            .mul_add(
                (-r2_part_2)
                    .mul_add(
                        cos_q2_minus_q3,
                        (-l2_q3_dot_sq).mul_add(sin_q2_minus_q3, r3_part),
                    ),
                m2 * r3_part,
            ));
    // Shared terms.
    // m1 + m2; used 3 times
    let m1_plus_m2 = m1 + m2;
    // l0*(cos(q1)*(m3 + m1_plus_m2) - m3*cos(q3)*cos(q1 - q3)); used 3 times
    let s4_part = l0 * ((-(m3 * c3)).mul_add(cos_q1_minus_q3, c1 * (m3 + m1_plus_m2)));
    // 1/(m0 + m3_s3*sin(q3) + m1_plus_m2); used 3 times
    let s4_part_2 = S::int(1) / (m3_s3.mul_add(s3, m0) + m1_plus_m2);
    // s4_part*s4_part_2; used 3 times
    let s4_part_s4_part_2 = s4_part * s4_part_2;
    // Elimination, step by step.
    // s4 = l0^2*(m1 + m2 + m3*sin(q1 - q3)^2) - l0^2*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 -
    //   q3))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s4 = (-s4_part)
        .mul_add(
            s4_part_s4_part_2,
            l0 * l0 * (m3.mul_add(sin_q1_minus_q3 * sin_q1_minus_q3, m1_plus_m2)),
        );
    // Shared terms.
    // l1*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3))); used 4 times
    let s5_part = l1 * (m3.mul_add((-c3).mul_add(cos_q2_minus_q3, c2), m2 * c2));
    // Elimination, step by step.
    // s5 = l0*l1*(m3*cos(q3)*cos(q1 - q3) - cos(q1)*(m1 + m2 + m3))*(m2*cos(q2) + m3*(cos(q2) -
    //   cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) + l0*l1*(m2*cos(q1 - q2) + m3*(cos(q1 - q2) -
    //   cos(q1 - q3)*cos(q2 - q3)))
    let s5 = (-s4_part_s4_part_2)
        .mul_add(
            s5_part,
            l0 * l1
                * (m3
                    .mul_add(
                        (-cos_q1_minus_q3).mul_add(cos_q2_minus_q3, cos_q1_minus_q2),
                        m2 * cos_q1_minus_q2,
                    )),
        );
    // Shared terms.
    // s4_part_2*s5_part; used 2 times
    let s4_part_2_s5_part = s4_part_2 * s5_part;
    // Elimination, step by step.
    // s6 = l1^2*(m2 + m3*sin(q2 - q3)^2) - l1^2*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))^2/(m0 +
    //   m1 + m2 + m3*sin(q3)^2)
    let s6 = (-s5_part)
        .mul_add(
            s4_part_2_s5_part,
            l1 * l1 * (m3.mul_add(sin_q2_minus_q3 * sin_q2_minus_q3, m2)),
        );
    // Shared terms.
    // r2 + r1*s4_part_s4_part_2; used 2 times
    let r7_part = r1.mul_add(s4_part_s4_part_2, r2);
    // 1/s4; used 2 times
    let s4_inv = S::int(1) / s4;
    // s5*s4_inv; used 2 times
    let s5_s4_inv = s5 * s4_inv;
    // Elimination, step by step.
    // r7 = l1*r1*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) + r3 -
    //   s5*(l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2)/s4
    let r7 = (-r7_part).mul_add(s5_s4_inv, r1.mul_add(s4_part_2_s5_part, r3));
    // q2'' = r7/(s6 - s5^2/s4)
    let q2_ddot = r7 / ((-s5).mul_add(s5_s4_inv, s6));
    // q1'' = (l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2
    //   - q2''*s5)/s4
    let q1_ddot = s4_inv * ((-q2_ddot).mul_add(s5, r7_part));
    // q0'' = (l0*q1''*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3)) + l1*q2''*(m2*cos(q2) +
    //   m3*(cos(q2) - cos(q3)*cos(q2 - q3))) + r1)/(m0 + m1 + m2 + m3*sin(q3)^2)
    let q0_ddot = s4_part_2 * (q2_ddot.mul_add(s5_part, q1_ddot.mul_add(s4_part, r1)));
    // q3'' = (g*sin(q3) + q0''*cos(q3) + l0*(q1'^2*sin(q1 - q3) - q1''*cos(q1 - q3)) + l1*(q2'^2*sin(q2 -
    //   q3) - q2''*cos(q2 - q3)))/l2
    let q3_ddot = (l1
        .mul_add(
            (-q2_ddot).mul_add(cos_q2_minus_q3, q2_dot_sq * sin_q2_minus_q3),
            l0
                .mul_add(
                    (-q1_ddot).mul_add(cos_q1_minus_q3, q1_dot_sq * sin_q1_minus_q3),
                    q0_ddot * c3,
                ),
        ) + g_s3) / l2;
    // Values.
    // q0' = q0'
    let q0_dot_value = q0_dot;
    // q1' = q1'
    let q1_dot_value = q1_dot;
    // q2' = q2'
    let q2_dot_value = q2_dot;
    // q3' = q3'
    let q3_dot_value = q3_dot;
    (
        [q0_dot_value, q1_dot_value, q2_dot_value, q3_dot_value],
        [q0_ddot, q1_ddot, q2_ddot, q3_ddot],
    )
}

/// Jacobian of the derivative by the state; columns q0, q1, q2, q3, q0', q1', q2', q3'.
///
/// 582 operations, 6 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    q_dot: &[S; 4],
) -> [[S; 8]; 8] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, q1_dot, q2_dot, q3_dot] = *q_dot;
    let zero = S::int(0);
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // l0*q1'; used 3 times
    let l0_q1_dot = l0 * q1_dot;
    // q1'*l0_q1_dot; used 9 times
    let q1_dot_l0_q1_dot = q1_dot * l0_q1_dot;
    // l1*q2'; used 4 times
    let l1_q2_dot = l1 * q2_dot;
    // q2'*l1_q2_dot; used 8 times
    let q2_dot_l1_q2_dot = q2_dot * l1_q2_dot;
    // q1_dot_l0_q1_dot*sin(q1) + q2_dot_l1_q2_dot*sin(q2); used 2 times
    let r1_part = q2_dot_l1_q2_dot.mul_add(s2, q1_dot_l0_q1_dot * s1);
    // g - q1_dot_l0_q1_dot*cos(q1) - q2_dot_l1_q2_dot*cos(q2); used 2 times
    let r1_part_2 = (-q2_dot_l1_q2_dot).mul_add(c2, (-q1_dot_l0_q1_dot).mul_add(c1, g));
    // l2*q3'; used 4 times
    let l2_q3_dot = l2 * q3_dot;
    // q3'*l2_q3_dot; used 5 times
    let q3_dot_l2_q3_dot = q3_dot * l2_q3_dot;
    // r1_part_2*cos(q3) - q3_dot_l2_q3_dot; used 2 times
    let r1_part_3 = r1_part_2.mul_add(c3, -q3_dot_l2_q3_dot);
    // r1_part*sin(q3); used 2 times
    let s3_r1_part = r1_part * s3;
    // m3*sin(q3); used 10 times
    let m3_s3 = m3 * s3;
    // m1*sin(q1); used 2 times
    let m1_s1 = m1 * s1;
    // Elimination, step by step.
    // r1 = F - m1*l0*q1'^2*sin(q1) - m2*(l0*q1'^2*sin(q1) + l1*q2'^2*sin(q2)) + m3*sin(q3)*(cos(q3)*(g -
    //   l0*q1'^2*cos(q1) - l1*q2'^2*cos(q2)) - sin(q3)*(l0*q1'^2*sin(q1) + l1*q2'^2*sin(q2)) - l2*q3'^2)
    let r1 = (-q1_dot_l0_q1_dot)
        .mul_add(
            m1_s1,
            m3_s3.mul_add(r1_part_3 - s3_r1_part, (-m2).mul_add(r1_part, F)),
        );
    // Shared terms.
    // q1 - q2; used 2 times
    let q1_minus_q2 = q1 - q2;
    // Sines and cosines.
    let (sin_q1_minus_q2, cos_q1_minus_q2) = q1_minus_q2.sin_cos();
    // Shared terms.
    // g*sin(q1) - q2_dot_l1_q2_dot*sin(q1 - q2); used 2 times
    let r2_part = (-q2_dot_l1_q2_dot).mul_add(sin_q1_minus_q2, g * s1);
    // q1 - q3; used 2 times
    let q1_minus_q3 = q1 - q3;
    // Sines and cosines.
    let (sin_q1_minus_q3, cos_q1_minus_q3) = q1_minus_q3.sin_cos();
    // Shared terms.
    // q2 - q3; used 2 times
    let q2_minus_q3 = q2 - q3;
    // Sines and cosines.
    let (sin_q2_minus_q3, cos_q2_minus_q3) = q2_minus_q3.sin_cos();
    // Shared terms.
    // g*sin(q3) + q1_dot_l0_q1_dot*sin(q1 - q3) + q2_dot_l1_q2_dot*sin(q2 - q3); used 4 times
    let r2_part_2 = q2_dot_l1_q2_dot
        .mul_add(sin_q2_minus_q3, q1_dot_l0_q1_dot.mul_add(sin_q1_minus_q3, g * s3));
    // Elimination, step by step.
    // r2 = l0*(m1*g*sin(q1) - m2*(l1*q2'^2*sin(q1 - q2) - g*sin(q1)) - m3*(l1*q2'^2*sin(q1 - q2) -
    //   g*sin(q1) + cos(q1 - q3)*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)) +
    //   l2*q3'^2*sin(q1 - q3)))
    let r2 = l0
        * (m3
            .mul_add(
                (-r2_part_2)
                    .mul_add(
                        cos_q1_minus_q3,
                        (-q3_dot_l2_q3_dot).mul_add(sin_q1_minus_q3, r2_part),
                    ),
                m2.mul_add(r2_part, g * m1_s1),
            ));
    // Shared terms.
    // g*sin(q2) + q1_dot_l0_q1_dot*sin(q1 - q2); used 2 times
    let r3_part = q1_dot_l0_q1_dot.mul_add(sin_q1_minus_q2, g * s2);
    // Elimination, step by step.
    // r3 = l1*(m2*(g*sin(q2) + l0*q1'^2*sin(q1 - q2)) + m3*(g*sin(q2) + l0*q1'^2*sin(q1 - q2) - cos(q2 -
    //   q3)*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)) - l2*q3'^2*sin(q2 - q3)))
    let r3 = l1
        * (m3
            .mul_add(
                (-r2_part_2)
                    .mul_add(
                        cos_q2_minus_q3,
                        (-q3_dot_l2_q3_dot).mul_add(sin_q2_minus_q3, r3_part),
                    ),
                m2 * r3_part,
            ));
    // Shared terms.
    // m1 + m2; used 5 times
    let m1_plus_m2 = m1 + m2;
    // m3*sin(q1 - q3); used 3 times
    let m3_sin_q1_minus_q3 = m3 * sin_q1_minus_q3;
    // m3 + m1_plus_m2; used 2 times
    let s4_part = m3 + m1_plus_m2;
    // s4_part*cos(q1) - m3*cos(q3)*cos(q1 - q3); used 2 times
    let s4_part_2 = (-(m3 * c3)).mul_add(cos_q1_minus_q3, s4_part * c1);
    // m3_s3*sin(q3) + m1_plus_m2; used 3 times
    let s4_part_3 = m3_s3.mul_add(s3, m1_plus_m2);
    // 1/(m0 + s4_part_3); used 13 times
    let s4_part_4 = S::int(1) / (m0 + s4_part_3);
    // l0*s4_part_4; used 4 times
    let l0_s4_part_4 = l0 * s4_part_4;
    // s4_part_2*l0_s4_part_4; used 14 times
    let s4_part_5 = s4_part_2 * l0_s4_part_4;
    // l0*s4_part_2; used 6 times
    let l0_s4_part_2 = l0 * s4_part_2;
    // Elimination, step by step.
    // s4 = l0^2*(m1 + m2 + m3*sin(q1 - q3)^2) - l0^2*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 -
    //   q3))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s4 = (-s4_part_5)
        .mul_add(
            l0_s4_part_2,
            l0 * l0 * (m3_sin_q1_minus_q3.mul_add(sin_q1_minus_q3, m1_plus_m2)),
        );
    // Shared terms.
    // m2*cos(q2); used 3 times
    let m2_c2 = m2 * c2;
    // l1*(m3*(cos(q2) - cos(q3)*cos(q2 - q3)) + m2_c2); used 10 times
    let s5_part = l1 * (m3.mul_add((-c3).mul_add(cos_q2_minus_q3, c2), m2_c2));
    // m2*cos(q1 - q2) + m3*(cos(q1 - q2) - cos(q1 - q3)*cos(q2 - q3)); used 3 times
    let s5_part_2 = m3
        .mul_add(
            (-cos_q1_minus_q3).mul_add(cos_q2_minus_q3, cos_q1_minus_q2),
            m2 * cos_q1_minus_q2,
        );
    // l0*l1; used 3 times
    let l0_l1 = l0 * l1;
    // Elimination, step by step.
    // s5 = l0*l1*(m3*cos(q3)*cos(q1 - q3) - cos(q1)*(m1 + m2 + m3))*(m2*cos(q2) + m3*(cos(q2) -
    //   cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) + l0*l1*(m2*cos(q1 - q2) + m3*(cos(q1 - q2) -
    //   cos(q1 - q3)*cos(q2 - q3)))
    let s5 = (-s4_part_5).mul_add(s5_part, s5_part_2 * l0_l1);
    // Shared terms.
    // s4_part_4*s5_part; used 9 times
    let s4_part_4_s5_part = s4_part_4 * s5_part;
    // l1^2; used 2 times
    let l1_sq = l1 * l1;
    // Elimination, step by step.
    // s6 = l1^2*(m2 + m3*sin(q2 - q3)^2) - l1^2*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))^2/(m0 +
    //   m1 + m2 + m3*sin(q3)^2)
    let s6 = (-s5_part)
        .mul_add(
            s4_part_4_s5_part,
            l1_sq * (m3.mul_add(sin_q2_minus_q3 * sin_q2_minus_q3, m2)),
        );
    // Shared terms.
    // r2 + r1*s4_part_5; used 3 times
    let r7_part = r1.mul_add(s4_part_5, r2);
    // 1/s4; used 11 times
    let s4_inv = S::int(1) / s4;
    // s5*s4_inv; used 12 times
    let s5_s4_inv = s5 * s4_inv;
    // r1*s4_part_4_s5_part; used 2 times
    let r1_s4_part_4_s5_part = r1 * s4_part_4_s5_part;
    // Elimination, step by step.
    // r7 = l1*r1*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) + r3 -
    //   s5*(l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2)/s4
    let r7 = (-r7_part).mul_add(s5_s4_inv, r3) + r1_s4_part_4_s5_part;
    // Shared terms.
    // 1/(s6 - s5*s5_s4_inv); used 7 times
    let q2_ddot_part = S::int(1) / ((-s5).mul_add(s5_s4_inv, s6));
    // Elimination, step by step.
    // q2'' = r7/(s6 - s5^2/s4)
    let q2_ddot = r7 * q2_ddot_part;
    // q1'' = (l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2
    //   - q2''*s5)/s4
    let q1_ddot = s4_inv * ((-q2_ddot).mul_add(s5, r7_part));
    // q0'' = (l0*q1''*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3)) + l1*q2''*(m2*cos(q2) +
    //   m3*(cos(q2) - cos(q3)*cos(q2 - q3))) + r1)/(m0 + m1 + m2 + m3*sin(q3)^2)
    let q0_ddot = s4_part_4
        * (q2_ddot.mul_add(s5_part, q1_ddot.mul_add(l0_s4_part_2, r1)));
    // Shared terms.
    // m3_s3*cos(q3); used 4 times
    let c3_m3_s3 = m3_s3 * c3;
    // Elimination, step by step.
    // r1_by_q1 = l0*q1'^2*(m3*sin(q1)*sin(q3)*cos(q3) - cos(q1)*(m1 + m2 + m3*sin(q3)^2))
    let r1_by_q1 = q1_dot_l0_q1_dot * ((-s4_part_3).mul_add(c1, c3_m3_s3 * s1));
    // Shared terms.
    // g*cos(q1); used 2 times
    let g_c1 = g * c1;
    // g_c1 - q2_dot_l1_q2_dot*cos(q1 - q2); used 2 times
    let r2_by_q1_part = (-q2_dot_l1_q2_dot).mul_add(cos_q1_minus_q2, g_c1);
    // q1_dot_l0_q1_dot*cos(q1 - q3) + q3_dot_l2_q3_dot; used 2 times
    let r2_by_q1_part_2 = q1_dot_l0_q1_dot.mul_add(cos_q1_minus_q3, q3_dot_l2_q3_dot);
    // r2_part_2*sin(q1 - q3); used 2 times
    let r2_by_q1_part_3 = r2_part_2 * sin_q1_minus_q3;
    // Elimination, step by step.
    // r2_by_q1 = l0*(m1*g*cos(q1) - m2*(l1*q2'^2*cos(q1 - q2) - g*cos(q1)) - m3*(l1*q2'^2*cos(q1 - q2) -
    //   g*cos(q1) - sin(q1 - q3)*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)) + cos(q1 -
    //   q3)*(l0*q1'^2*cos(q1 - q3) + l2*q3'^2)))
    let r2_by_q1 = l0
        * (m3
            .mul_add(
                (-r2_by_q1_part_2).mul_add(cos_q1_minus_q3, r2_by_q1_part)
                    + r2_by_q1_part_3,
                m2.mul_add(r2_by_q1_part, m1 * g_c1),
            ));
    // r3_by_q1 = l0*l1*q1'^2*(m2*cos(q1 - q2) + m3*(cos(q1 - q2) - cos(q1 - q3)*cos(q2 - q3)))
    let r3_by_q1 = l1 * q1_dot_l0_q1_dot * s5_part_2;
    // Shared terms.
    // 2*cos(q3)^2 - 1; used 2 times
    let s4_by_q1_part = (c3 * c3).mul_add(S::int(2), -S::int(1));
    // 2*c3_m3_s3; used 4 times
    let c3_m3_s3_scaled = S::int(2) * c3_m3_s3;
    // 2*l0; used 4 times
    let l0_scaled = S::int(2) * l0;
    // Elimination, step by step.
    // s4_by_q1 = 2*l0^2*(m0*m3*sin(q3)*cos(q3) - cos(q1)*(2*m0*m3*cos(q1)*sin(q3)*cos(q3) - sin(q1)*(m2^2
    //   + m1*(m1 + 2*m2) + m3*(m1 + m2 + m0*(2*cos(q3)^2 - 1)))))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s4_by_q1 = l0_s4_part_4 * l0_scaled
        * (c1
            .mul_add(
                (-(m0 * c3_m3_s3_scaled))
                    .mul_add(
                        c1,
                        s1
                            * (m3
                                .mul_add(
                                    m0.mul_add(s4_by_q1_part, m1_plus_m2),
                                    m1.mul_add(m2.mul_add(S::int(2), m1), m2 * m2),
                                )),
                    ),
                m0 * c3_m3_s3,
            ));
    // Shared terms.
    // sin(q1 - q3)*cos(q2 - q3); used 2 times
    let s5_by_q1_part = sin_q1_minus_q3 * cos_q2_minus_q3;
    // m2*sin(q1 - q2); used 2 times
    let m2_sin_q1_minus_q2 = m2 * sin_q1_minus_q2;
    // m3*(sin(q1 - q2) - s5_by_q1_part) + m2_sin_q1_minus_q2; used 2 times
    let s5_by_q1_part_2 = m3
        .mul_add(sin_q1_minus_q2 - s5_by_q1_part, m2_sin_q1_minus_q2);
    // m3_sin_q1_minus_q3*cos(q3); used 2 times
    let s5_by_q1_part_3 = m3_sin_q1_minus_q3 * c3;
    // l0_s4_part_4*(s4_part*sin(q1) - s5_by_q1_part_3); used 2 times
    let s5_by_q1_part_4 = l0_s4_part_4 * (s4_part.mul_add(s1, -s5_by_q1_part_3));
    // Elimination, step by step.
    // s5_by_q1 = l0*l1*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))*(sin(q1)*(m1 + m2 + m3) -
    //   m3*sin(q1 - q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) - l0*l1*(m2*sin(q1 - q2) + m3*(sin(q1 - q2) -
    //   sin(q1 - q3)*cos(q2 - q3)))
    let s5_by_q1 = (-l0_l1).mul_add(s5_by_q1_part_2, s5_part * s5_by_q1_part_4);
    // Shared terms.
    // r1*s5_by_q1_part_4 - r1_by_q1*s4_part_5
    let r7_by_q1_part = (-r1_by_q1).mul_add(s4_part_5, r1 * s5_by_q1_part_4);
    // r2_by_q1 - r7_by_q1_part; used 2 times
    let r7_by_q1_part_2 = r2_by_q1 - r7_by_q1_part;
    // r7_part*s4_inv; used 2 times
    let r7_part_s4_inv = r7_part * s4_inv;
    // s4_by_q1*s5_s4_inv; used 2 times
    let s4_by_q1_s5_s4_inv = s4_by_q1 * s5_s4_inv;
    // Elimination, step by step.
    // r7_by_q1 = l1*r1_by_q1*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) - s5*(l0*r1*(m3*sin(q1 - q3)*cos(q3) - sin(q1)*(m1 + m2 + m3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + l0*r1_by_q1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r2_by_q1)/s4 + r3_by_q1 + s5*s4_by_q1*(l0*r1*(cos(q1)*(m1 + m2 + m3) -
    //   m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2)/s4^2 - s5_by_q1*(l0*r1*(cos(q1)*(m1 +
    //   m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2)/s4
    let r7_by_q1 = r7_part_s4_inv
        .mul_add(
            s4_by_q1_s5_s4_inv - s5_by_q1,
            (-s5_s4_inv)
                .mul_add(r7_by_q1_part_2, r1_by_q1.mul_add(s4_part_4_s5_part, r3_by_q1)),
        );
    // q2_ddot_by_q1 = (s5*r7*(2*s5_by_q1 - s5*s4_by_q1/s4)/(s4*(s6 - s5^2/s4)) + r7_by_q1)/(s6 - s5^2/s4)
    let q2_ddot_by_q1 = q2_ddot_part
        * ((q2_ddot * s5_s4_inv)
            .mul_add(s5_by_q1.mul_add(S::int(2), -s4_by_q1_s5_s4_inv), r7_by_q1));
    // Shared terms.
    // q1''*s4_inv; used 2 times
    let q1_ddot_s4_inv = q1_ddot * s4_inv;
    // Elimination, step by step.
    // q1_ddot_by_q1 = s4_by_q1*(q2''*s5 - l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 +
    //   m1 + m2 + m3*sin(q3)^2) - r2)/s4^2 + (l0*r1*(m3*sin(q1 - q3)*cos(q3) - sin(q1)*(m1 + m2 + m3))/(m0 +
    //   m1 + m2 + m3*sin(q3)^2) + l0*r1_by_q1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 +
    //   m2 + m3*sin(q3)^2) + r2_by_q1 - q2''*s5_by_q1 - s5*q2_ddot_by_q1)/s4
    let q1_ddot_by_q1 = (-s4_by_q1)
        .mul_add(
            q1_ddot_s4_inv,
            s4_inv
                * ((-s5)
                    .mul_add(
                        q2_ddot_by_q1,
                        (-q2_ddot).mul_add(s5_by_q1, r7_by_q1_part_2),
                    )),
        );
    // Shared terms.
    // sin(q1)*cos(q3) - cos(q1)*sin(q3); used 2 times
    let q0_ddot_by_q1_part = (-c1).mul_add(s3, s1 * c3);
    // sin(q2)*cos(q3) - cos(q2)*sin(q3); used 2 times
    let q0_ddot_by_q1_part_2 = (-c2).mul_add(s3, s2 * c3);
    // m3_s3*q0_ddot_by_q1_part_2 - m2_c2; used 2 times
    let q0_ddot_by_q1_part_3 = m3_s3.mul_add(q0_ddot_by_q1_part_2, -m2_c2);
    // Elimination, step by step.
    // q0_ddot_by_q1 = (r1_by_q1 + l1*q2_ddot_by_q1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3))) - l0*(m3*sin(q3)*(q1''*(sin(q1)*sin(q3) + cos(q1)*cos(q3)) +
    //   q1_ddot_by_q1*(sin(q1)*cos(q3) - cos(q1)*sin(q3))) + m1*(q1''*sin(q1) - q1_ddot_by_q1*cos(q1)) +
    //   m2*(q1''*sin(q1) - q1_ddot_by_q1*cos(q1))))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let q0_ddot_by_q1 = s4_part_4
        * ((-(l1 * q2_ddot_by_q1))
            .mul_add(
                q0_ddot_by_q1_part_3,
                (-l0)
                    .mul_add(
                        m3_s3
                            .mul_add(
                                q1_ddot_by_q1
                                    .mul_add(
                                        q0_ddot_by_q1_part,
                                        q1_ddot * (c1.mul_add(c3, s1 * s3)),
                                    ),
                                m1_plus_m2 * ((-q1_ddot_by_q1).mul_add(c1, q1_ddot * s1)),
                            ),
                        r1_by_q1,
                    ),
            ));
    // Shared terms.
    // q1'^2; used 2 times
    let q1_dot_sq = q1_dot * q1_dot;
    // q1''*sin(q1 - q3); used 2 times
    let q3_ddot_by_q1_part = q1_ddot * sin_q1_minus_q3;
    // l1*cos(q2 - q3); used 4 times
    let l1_cos_q2_minus_q3 = l1 * cos_q2_minus_q3;
    // 1/l2; used 6 times
    let l2_inv = S::int(1) / l2;
    // Elimination, step by step.
    // q3_ddot_by_q1 = (l0*(q1''*sin(q1 - q3) + cos(q1 - q3)*(q1'^2 - q1_ddot_by_q1)) -
    //   l1*q2_ddot_by_q1*cos(q2 - q3) + q0_ddot_by_q1*cos(q3))/l2
    let q3_ddot_by_q1 = l2_inv
        * ((-q2_ddot_by_q1)
            .mul_add(
                l1_cos_q2_minus_q3,
                l0
                    .mul_add(
                        cos_q1_minus_q3
                            .mul_add(q1_dot_sq - q1_ddot_by_q1, q3_ddot_by_q1_part),
                        q0_ddot_by_q1 * c3,
                    ),
            ));
    // r1_by_q2 = l1*q2'^2*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))
    let r1_by_q2 = q2_dot_l1_q2_dot * q0_ddot_by_q1_part_3;
    // r2_by_q2 = l0*l1*q2'^2*(m2*cos(q1 - q2) + m3*(cos(q1 - q2) - cos(q1 - q3)*cos(q2 - q3)))
    let r2_by_q2 = l0 * q2_dot_l1_q2_dot * s5_part_2;
    // Shared terms.
    // g*cos(q2) - q1_dot_l0_q1_dot*cos(q1 - q2); used 2 times
    let r3_by_q2_part = (-q1_dot_l0_q1_dot).mul_add(cos_q1_minus_q2, g * c2);
    // q2_dot_l1_q2_dot*cos(q2 - q3); used 2 times
    let r3_by_q2_part_2 = q2_dot_l1_q2_dot * cos_q2_minus_q3;
    // r2_part_2*sin(q2 - q3); used 2 times
    let r3_by_q2_part_3 = r2_part_2 * sin_q2_minus_q3;
    // Elimination, step by step.
    // r3_by_q2 = -l1*(m2*(l0*q1'^2*cos(q1 - q2) - g*cos(q2)) + m3*(l0*q1'^2*cos(q1 - q2) - g*cos(q2) -
    //   sin(q2 - q3)*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)) + cos(q2 -
    //   q3)*(l1*q2'^2*cos(q2 - q3) + l2*q3'^2)))
    let r3_by_q2 = l1
        * (m3
            .mul_add(
                (-cos_q2_minus_q3)
                    .mul_add(q3_dot_l2_q3_dot + r3_by_q2_part_2, r3_by_q2_part)
                    + r3_by_q2_part_3,
                m2 * r3_by_q2_part,
            ));
    // Shared terms.
    // sin(q2 - q3)*cos(q3); used 2 times
    let c3_sin_q2_minus_q3 = sin_q2_minus_q3 * c3;
    // m2*sin(q2); used 3 times
    let m2_s2 = m2 * s2;
    // sin(q2 - q3)*cos(q1 - q3); used 2 times
    let s5_by_q2_part = sin_q2_minus_q3 * cos_q1_minus_q3;
    // m2_sin_q1_minus_q2 + m3*(sin(q1 - q2) + s5_by_q2_part); used 2 times
    let s5_by_q2_part_2 = m3
        .mul_add(sin_q1_minus_q2 + s5_by_q2_part, m2_sin_q1_minus_q2);
    // Elimination, step by step.
    // s5_by_q2 = l0*l1*(m2*sin(q1 - q2) + m3*(sin(q1 - q2) + sin(q2 - q3)*cos(q1 - q3))) +
    //   l0*l1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))*(m2*sin(q2) + m3*(sin(q2) - sin(q2 -
    //   q3)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s5_by_q2 = l0_l1
        .mul_add(
            s5_by_q2_part_2,
            l1 * s4_part_5 * (m3.mul_add(s2 - c3_sin_q2_minus_q3, m2_s2)),
        );
    // Shared terms.
    // m0 + m1; used 2 times
    let m0_plus_m1 = m0 + m1;
    // m0_plus_m1*sin(q3)*cos(q3); used 2 times
    let s3_c3_m0_plus_m1 = m0_plus_m1 * s3 * c3;
    // Elimination, step by step.
    // s6_by_q2 = 2*l1^2*(m2^2*sin(q2)*cos(q2) + m3*(sin(q3)*cos(q3)*(m0 + m1) + cos(q2)*(sin(q2)*(m2 +
    //   m0*(2*cos(q3)^2 - 1) + m1*(2*cos(q3)^2 - 1)) - 2*cos(q2)*sin(q3)*cos(q3)*(m0 + m1))))/(m0 + m1 + m2
    //   + m3*sin(q3)^2)
    let s6_by_q2 = S::int(2) * s4_part_4 * l1_sq
        * (m3
            .mul_add(
                c2
                    .mul_add(
                        (-(S::int(2) * s3_c3_m0_plus_m1))
                            .mul_add(c2, s2 * (s4_by_q1_part.mul_add(m0_plus_m1, m2))),
                        s3_c3_m0_plus_m1,
                    ),
                m2_c2 * m2_s2,
            ));
    // Shared terms.
    // s5*r2_by_q2 + r2*s5_by_q2; used 2 times
    let r7_by_q2_part = r2.mul_add(s5_by_q2, s5 * r2_by_q2);
    // s5*r1_by_q2 + r1*s5_by_q2; used 2 times
    let r7_by_q2_part_2 = r1.mul_add(s5_by_q2, s5 * r1_by_q2);
    // l0*cos(q1); used 2 times
    let l0_c1 = l0 * c1;
    // r7_by_q2_part_2*l0_c1; used 2 times
    let r7_by_q2_part_3 = r7_by_q2_part_2 * l0_c1;
    // s4*(l1*(r1_by_q2*cos(q2) - r1*sin(q2)) + r3_by_q2) - r7_by_q2_part - r7_by_q2_part_3; used 2 times
    let r7_by_q2_part_4 = s4
        .mul_add(l1.mul_add((-r1).mul_add(s2, r1_by_q2 * c2), r3_by_q2), -r7_by_q2_part)
        - r7_by_q2_part_3;
    // s4*r3_by_q2 - r7_by_q2_part; used 2 times
    let r7_by_q2_part_5 = s4.mul_add(r3_by_q2, -r7_by_q2_part);
    // Elimination, step by step.
    // r7_by_q2 = (m2*(s4*(l1*(r1_by_q2*cos(q2) - r1*sin(q2)) + r3_by_q2) - s5*r2_by_q2 - r2*s5_by_q2 -
    //   l0*cos(q1)*(s5*r1_by_q2 + r1*s5_by_q2)) + m3*sin(q3)*(sin(q3)*(s4*(l1*(r1_by_q2*cos(q2) -
    //   r1*sin(q2)) + r3_by_q2) - s5*r2_by_q2 - r2*s5_by_q2 - l0*cos(q1)*(s5*r1_by_q2 + r1*s5_by_q2)) +
    //   cos(q3)*(l0*sin(q1)*(s5*r1_by_q2 + r1*s5_by_q2) - l1*s4*(r1*cos(q2) + r1_by_q2*sin(q2)))) +
    //   m0*(s4*r3_by_q2 - s5*r2_by_q2 - r2*s5_by_q2) + m1*(s4*r3_by_q2 - s5*r2_by_q2 - r2*s5_by_q2 -
    //   l0*cos(q1)*(s5*r1_by_q2 + r1*s5_by_q2)))/(s4*(m0 + m1 + m2 + m3*sin(q3)^2))
    let r7_by_q2 = s4_part_4 * s4_inv
        * (m1
            .mul_add(
                r7_by_q2_part_5 - r7_by_q2_part_3,
                m0
                    .mul_add(
                        r7_by_q2_part_5,
                        m3_s3
                            .mul_add(
                                r7_by_q2_part_4
                                    .mul_add(
                                        s3,
                                        c3
                                            * ((-(l1 * s4))
                                                .mul_add(
                                                    r1_by_q2.mul_add(s2, r1 * c2),
                                                    l0 * r7_by_q2_part_2 * s1,
                                                )),
                                    ),
                                m2 * r7_by_q2_part_4,
                            ),
                    ),
            ));
    // q2_ddot_by_q2 = (r7*(s6_by_q2 - 2*s5*s5_by_q2/s4)/(s5^2/s4 - s6) + r7_by_q2)/(s6 - s5^2/s4)
    let q2_ddot_by_q2 = q2_ddot_part
        * (q2_ddot
            .mul_add((S::int(2) * s5_by_q2).mul_add(s5_s4_inv, -s6_by_q2), r7_by_q2));
    // q1_ddot_by_q2 = (l0*r1_by_q2*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r2_by_q2 - q2''*s5_by_q2 - s5*q2_ddot_by_q2)/s4
    let q1_ddot_by_q2 = s4_inv
        * (r1_by_q2
            .mul_add(
                s4_part_5,
                (-s5).mul_add(q2_ddot_by_q2, (-q2_ddot).mul_add(s5_by_q2, r2_by_q2)),
            ));
    // Shared terms.
    // q1_ddot_by_q2*l0_c1; used 2 times
    let q1_ddot_by_q2_l0_c1 = q1_ddot_by_q2 * l0_c1;
    // sin(q2)*sin(q3) + cos(q2)*cos(q3); used 2 times
    let q0_ddot_by_q2_part = c2.mul_add(c3, s2 * s3);
    // Elimination, step by step.
    // q0_ddot_by_q2 = (r1_by_q2 + m1*l0*q1_ddot_by_q2*cos(q1) - m3*sin(q3)*(l1*(q2''*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) + q2_ddot_by_q2*(sin(q2)*cos(q3) - cos(q2)*sin(q3))) +
    //   l0*q1_ddot_by_q2*(sin(q1)*cos(q3) - cos(q1)*sin(q3))) + m2*(l0*q1_ddot_by_q2*cos(q1) -
    //   l1*(q2''*sin(q2) - q2_ddot_by_q2*cos(q2))))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let q0_ddot_by_q2 = s4_part_4
        * ((-m3_s3)
            .mul_add(
                l1
                    .mul_add(
                        q2_ddot
                            .mul_add(
                                q0_ddot_by_q2_part,
                                q2_ddot_by_q2 * q0_ddot_by_q1_part_2,
                            ),
                        l0 * q1_ddot_by_q2 * q0_ddot_by_q1_part,
                    ),
                m2
                    .mul_add(
                        (-l1)
                            .mul_add(
                                (-q2_ddot_by_q2).mul_add(c2, q2_ddot * s2),
                                q1_ddot_by_q2_l0_c1,
                            ),
                        m1.mul_add(q1_ddot_by_q2_l0_c1, r1_by_q2),
                    ),
            ));
    // Shared terms.
    // q2'^2; used 2 times
    let q2_dot_sq = q2_dot * q2_dot;
    // q2''*sin(q2 - q3); used 2 times
    let q3_ddot_by_q2_part = q2_ddot * sin_q2_minus_q3;
    // l0*cos(q1 - q3); used 4 times
    let l0_cos_q1_minus_q3 = l0 * cos_q1_minus_q3;
    // Elimination, step by step.
    // q3_ddot_by_q2 = (l1*(q2''*sin(q2 - q3) + cos(q2 - q3)*(q2'^2 - q2_ddot_by_q2)) -
    //   l0*q1_ddot_by_q2*cos(q1 - q3) + q0_ddot_by_q2*cos(q3))/l2
    let q3_ddot_by_q2 = l2_inv
        * ((-q1_ddot_by_q2)
            .mul_add(
                l0_cos_q1_minus_q3,
                l1
                    .mul_add(
                        cos_q2_minus_q3
                            .mul_add(q2_dot_sq - q2_ddot_by_q2, q3_ddot_by_q2_part),
                        q0_ddot_by_q2 * c3,
                    ),
            ));
    // r1_by_q3 = m3*(sin(q3)^2*(l0*q1'^2*cos(q1) - g + l1*q2'^2*cos(q2)) + cos(q3)*(cos(q3)*(g -
    //   l0*q1'^2*cos(q1) - l1*q2'^2*cos(q2)) - 2*sin(q3)*(l0*q1'^2*sin(q1) + l1*q2'^2*sin(q2)) - l2*q3'^2))
    let r1_by_q3 = m3
        * ((-r1_part_2)
            .mul_add(s3 * s3, c3 * ((-s3_r1_part).mul_add(S::int(2), r1_part_3))));
    // Shared terms.
    // r2_by_q1_part_2 - g*cos(q3) + r3_by_q2_part_2; used 2 times
    let r2_by_q3_part = (-g).mul_add(c3, r2_by_q1_part_2) + r3_by_q2_part_2;
    // Elimination, step by step.
    // r2_by_q3 = -m3*l0*(sin(q1 - q3)*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)) + cos(q1
    //   - q3)*(g*cos(q3) - l0*q1'^2*cos(q1 - q3) - l1*q2'^2*cos(q2 - q3) - l2*q3'^2))
    let r2_by_q3 = m3 * l0 * (r2_by_q3_part.mul_add(cos_q1_minus_q3, -r2_by_q1_part_3));
    // Shared terms.
    // m3*l1; used 4 times
    let m3_l1 = m3 * l1;
    // Elimination, step by step.
    // r3_by_q3 = -m3*l1*(sin(q2 - q3)*(g*sin(q3) + l0*q1'^2*sin(q1 - q3) + l1*q2'^2*sin(q2 - q3)) + cos(q2
    //   - q3)*(g*cos(q3) - l0*q1'^2*cos(q1 - q3) - l1*q2'^2*cos(q2 - q3) - l2*q3'^2))
    let r3_by_q3 = m3_l1 * (r2_by_q3_part.mul_add(cos_q2_minus_q3, -r3_by_q2_part_3));
    // Shared terms.
    // m3_sin_q1_minus_q3*l0_scaled; used 3 times
    let s4_by_q3_part = m3_sin_q1_minus_q3 * l0_scaled;
    // s5_by_q1_part_3 - m3_s3*cos(q1 - q3); used 3 times
    let s4_by_q3_part_2 = (-m3_s3).mul_add(cos_q1_minus_q3, s5_by_q1_part_3);
    // Elimination, step by step.
    // s4_by_q3 = 2*m3*l0^2*sin(q3)*cos(q3)*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))^2/(m0 + m1 +
    //   m2 + m3*sin(q3)^2)^2 - 2*m3*l0^2*sin(q1 - q3)*cos(q1 - q3) + 2*l0^2*(cos(q1)*(m1 + m2 + m3) -
    //   m3*cos(q3)*cos(q1 - q3))*(m3*sin(q1 - q3)*cos(q3) - m3*sin(q3)*cos(q1 - q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2)
    let s4_by_q3 = (-l0_cos_q1_minus_q3)
        .mul_add(
            s4_by_q3_part,
            s4_part_5 * (l0_scaled.mul_add(s4_by_q3_part_2, s4_part_5 * c3_m3_s3_scaled)),
        );
    // Shared terms.
    // s4_part_4*c3_m3_s3_scaled; used 3 times
    let s5_by_q3_part = s4_part_4 * c3_m3_s3_scaled;
    // l0_s4_part_4*s4_by_q3_part_2 + s4_part_5*s5_by_q3_part; used 2 times
    let s5_by_q3_part_2 = s4_part_5
        .mul_add(s5_by_q3_part, l0_s4_part_4 * s4_by_q3_part_2);
    // m3_l1*(c3_sin_q2_minus_q3 - sin(q3)*cos(q2 - q3)); used 4 times
    let s5_by_q3_part_3 = m3_l1 * ((-s3).mul_add(cos_q2_minus_q3, c3_sin_q2_minus_q3));
    // Elimination, step by step.
    // s5_by_q3 = 2*m3*l0*l1*sin(q3)*cos(q3)*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))*(m2*cos(q2)
    //   + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 + m3*sin(q3)^2)^2 + l0*l1*(m2*cos(q2) +
    //   m3*(cos(q2) - cos(q3)*cos(q2 - q3)))*(m3*sin(q1 - q3)*cos(q3) - m3*sin(q3)*cos(q1 - q3))/(m0 + m1 +
    //   m2 + m3*sin(q3)^2) + m3*l0*l1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))*(sin(q2 -
    //   q3)*cos(q3) - sin(q3)*cos(q2 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) - m3*l0*l1*(sin(q2 - q3)*cos(q1 -
    //   q3) + sin(q1 - q3)*cos(q2 - q3))
    let s5_by_q3 = s4_part_5
        .mul_add(
            s5_by_q3_part_3,
            (-(l0 * m3_l1))
                .mul_add(s5_by_q1_part + s5_by_q2_part, s5_part * s5_by_q3_part_2),
        );
    // Shared terms.
    // 2*sin(q2 - q3); used 2 times
    let sin_q2_minus_q3_scaled = S::int(2) * sin_q2_minus_q3;
    // m3_l1*sin_q2_minus_q3_scaled; used 3 times
    let s6_by_q3_part = m3_l1 * sin_q2_minus_q3_scaled;
    // Elimination, step by step.
    // s6_by_q3 = 2*m3*l1^2*sin(q3)*cos(q3)*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))^2/(m0 + m1 +
    //   m2 + m3*sin(q3)^2)^2 - 2*m3*l1^2*sin(q2 - q3)*cos(q2 - q3) + 2*m3*l1^2*(m2*cos(q2) + m3*(cos(q2) -
    //   cos(q3)*cos(q2 - q3)))*(sin(q2 - q3)*cos(q3) - sin(q3)*cos(q2 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s6_by_q3 = (-l1_cos_q2_minus_q3)
        .mul_add(
            s6_by_q3_part,
            s4_part_4_s5_part
                * (s5_by_q3_part_3
                    .mul_add(S::int(2), s4_part_4_s5_part * c3_m3_s3_scaled)),
        );
    // Shared terms.
    // r1*s5_by_q3_part_2 - r1_by_q3*s4_part_5
    let r7_by_q3_part = (-r1_by_q3).mul_add(s4_part_5, r1 * s5_by_q3_part_2);
    // r2_by_q3 - r7_by_q3_part; used 2 times
    let r7_by_q3_part_2 = r2_by_q3 - r7_by_q3_part;
    // s4_by_q3*s5_s4_inv; used 2 times
    let s4_by_q3_s5_s4_inv = s4_by_q3 * s5_s4_inv;
    // Elimination, step by step.
    // r7_by_q3 = m3*l1*r1*(sin(q3)*cos(q2 - q3) - sin(q2 - q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) -
    //   2*m3*l1*r1*sin(q3)*cos(q3)*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2)^2 + l1*r1_by_q3*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) - s5*(2*m3*l0*r1*sin(q3)*cos(q3)*(m3*cos(q3)*cos(q1 - q3) - cos(q1)*(m1 + m2 +
    //   m3))/(m0 + m1 + m2 + m3*sin(q3)^2)^2 + l0*r1*(m3*sin(q3)*cos(q1 - q3) - m3*sin(q1 - q3)*cos(q3))/(m0
    //   + m1 + m2 + m3*sin(q3)^2) + l0*r1_by_q3*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1
    //   + m2 + m3*sin(q3)^2) + r2_by_q3)/s4 + r3_by_q3 + s5*s4_by_q3*(l0*r1*(cos(q1)*(m1 + m2 + m3) -
    //   m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2)/s4^2 - s5_by_q3*(l0*r1*(cos(q1)*(m1 +
    //   m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2)/s4
    let r7_by_q3 = r7_part_s4_inv
        .mul_add(
            s4_by_q3_s5_s4_inv - s5_by_q3,
            (-s5_s4_inv)
                .mul_add(
                    r7_by_q3_part_2,
                    (-(r1 * s4_part_4))
                        .mul_add(
                            s5_by_q3_part_3,
                            (-r1_s4_part_4_s5_part)
                                .mul_add(
                                    s5_by_q3_part,
                                    r1_by_q3.mul_add(s4_part_4_s5_part, r3_by_q3),
                                ),
                        ),
                ),
        );
    // q2_ddot_by_q3 = (r7*(s5*(s5*s4_by_q3/s4 - 2*s5_by_q3)/s4 + s6_by_q3)/(s5^2/s4 - s6) + r7_by_q3)/(s6
    //   - s5^2/s4)
    let q2_ddot_by_q3 = q2_ddot_part
        * ((-q2_ddot)
            .mul_add(
                s5_s4_inv
                    .mul_add(
                        (-s5_by_q3).mul_add(S::int(2), s4_by_q3_s5_s4_inv),
                        s6_by_q3,
                    ),
                r7_by_q3,
            ));
    // q1_ddot_by_q3 = s4_by_q3*(q2''*s5 - l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 +
    //   m1 + m2 + m3*sin(q3)^2) - r2)/s4^2 + (2*m3*l0*r1*sin(q3)*cos(q3)*(m3*cos(q3)*cos(q1 - q3) -
    //   cos(q1)*(m1 + m2 + m3))/(m0 + m1 + m2 + m3*sin(q3)^2)^2 + l0*r1*(m3*sin(q3)*cos(q1 - q3) - m3*sin(q1
    //   - q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + l0*r1_by_q3*(cos(q1)*(m1 + m2 + m3) -
    //   m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2_by_q3 - q2''*s5_by_q3 -
    //   s5*q2_ddot_by_q3)/s4
    let q1_ddot_by_q3 = (-s4_by_q3)
        .mul_add(
            q1_ddot_s4_inv,
            s4_inv
                * ((-s5)
                    .mul_add(
                        q2_ddot_by_q3,
                        (-q2_ddot).mul_add(s5_by_q3, r7_by_q3_part_2),
                    )),
        );
    // q0_ddot_by_q3 = (l0*q1''*(m3*sin(q3)*cos(q1 - q3) - m3*sin(q1 - q3)*cos(q3)) +
    //   m3*l1*q2''*(sin(q3)*cos(q2 - q3) - sin(q2 - q3)*cos(q3)) + r1_by_q3 + l1*q2_ddot_by_q3*(m2*cos(q2) +
    //   m3*(cos(q2) - cos(q3)*cos(q2 - q3))) + l0*q1_ddot_by_q3*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1
    //   - q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) - 2*m3*sin(q3)*cos(q3)*(l0*q1''*(cos(q1)*(m1 + m2 + m3) -
    //   m3*cos(q3)*cos(q1 - q3)) + l1*q2''*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3))) + r1)/(m0 + m1
    //   + m2 + m3*sin(q3)^2)^2
    let q0_ddot_by_q3 = (-q0_ddot)
        .mul_add(
            s5_by_q3_part,
            s4_part_4
                * ((-q2_ddot)
                    .mul_add(
                        s5_by_q3_part_3,
                        (-(l0 * q1_ddot))
                            .mul_add(
                                s4_by_q3_part_2,
                                q2_ddot_by_q3
                                    .mul_add(
                                        s5_part,
                                        q1_ddot_by_q3.mul_add(l0_s4_part_2, r1_by_q3),
                                    ),
                            ),
                    )),
        );
    // q3_ddot_by_q3 = (cos(q3)*(g + q0_ddot_by_q3) - q0''*sin(q3) - l1*(q2''*sin(q2 - q3) + cos(q2 -
    //   q3)*(q2'^2 + q2_ddot_by_q3)) - l0*(q1''*sin(q1 - q3) + cos(q1 - q3)*(q1'^2 + q1_ddot_by_q3)))/l2
    let q3_ddot_by_q3 = l2_inv
        * ((-l1)
            .mul_add(
                cos_q2_minus_q3.mul_add(q2_ddot_by_q3 + q2_dot_sq, q3_ddot_by_q2_part),
                (-l0)
                    .mul_add(
                        cos_q1_minus_q3
                            .mul_add(q1_ddot_by_q3 + q1_dot_sq, q3_ddot_by_q1_part),
                        (-q0_ddot).mul_add(s3, c3 * (g + q0_ddot_by_q3)),
                    ),
            ));
    // Shared terms.
    // 2*l0_q1_dot; used 2 times
    let l0_q1_dot_scaled = S::int(2) * l0_q1_dot;
    // Elimination, step by step.
    // r1_by_q1_dot = -2*l0*q1'*(m3*cos(q1)*sin(q3)*cos(q3) + sin(q1)*(m1 + m2 + m3*sin(q3)^2))
    let r1_by_q1_dot = -l0_q1_dot_scaled * (c3_m3_s3.mul_add(c1, s4_part_3 * s1));
    // r2_by_q1_dot = -2*m3*l0^2*q1'*sin(q1 - q3)*cos(q1 - q3)
    let r2_by_q1_dot = -l0_q1_dot * s4_by_q3_part * cos_q1_minus_q3;
    // r3_by_q1_dot = 2*l0*l1*q1'*(m2*sin(q1 - q2) + m3*(sin(q1 - q2) - sin(q1 - q3)*cos(q2 - q3)))
    let r3_by_q1_dot = l1 * s5_by_q1_part_2 * l0_q1_dot_scaled;
    // Shared terms.
    // r2_by_q1_dot + r1_by_q1_dot*s4_part_5; used 2 times
    let r7_by_q1_dot_part = r1_by_q1_dot.mul_add(s4_part_5, r2_by_q1_dot);
    // Elimination, step by step.
    // r7_by_q1_dot = l1*r1_by_q1_dot*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) - s5*(l0*r1_by_q1_dot*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2
    //   + m3*sin(q3)^2) + r2_by_q1_dot)/s4 + r3_by_q1_dot
    let r7_by_q1_dot = (-s5_s4_inv)
        .mul_add(
            r7_by_q1_dot_part,
            r1_by_q1_dot.mul_add(s4_part_4_s5_part, r3_by_q1_dot),
        );
    // Shared terms.
    // r7_by_q1_dot*q2_ddot_part; used 4 times
    let q1_ddot_by_q1_dot_part = r7_by_q1_dot * q2_ddot_part;
    // Elimination, step by step.
    // q1_ddot_by_q1_dot = (l0*r1_by_q1_dot*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 +
    //   m2 + m3*sin(q3)^2) + r2_by_q1_dot + s5*r7_by_q1_dot/(s5^2/s4 - s6))/s4
    let q1_ddot_by_q1_dot = s4_inv
        * ((-s5).mul_add(q1_ddot_by_q1_dot_part, r7_by_q1_dot_part));
    // q0_ddot_by_q1_dot = (r1_by_q1_dot + l1*r7_by_q1_dot*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 -
    //   q3)))/(s6 - s5^2/s4) + l0*q1_ddot_by_q1_dot*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3)))/(m0
    //   + m1 + m2 + m3*sin(q3)^2)
    let q0_ddot_by_q1_dot = s4_part_4
        * (s5_part
            .mul_add(
                q1_ddot_by_q1_dot_part,
                q1_ddot_by_q1_dot.mul_add(l0_s4_part_2, r1_by_q1_dot),
            ));
    // q3_ddot_by_q1_dot = (l1*r7_by_q1_dot*cos(q2 - q3)/(s5^2/s4 - s6) + l0*(2*q1'*sin(q1 - q3) -
    //   q1_ddot_by_q1_dot*cos(q1 - q3)) + q0_ddot_by_q1_dot*cos(q3))/l2
    let q3_ddot_by_q1_dot = l2_inv
        * ((-l1_cos_q2_minus_q3)
            .mul_add(
                q1_ddot_by_q1_dot_part,
                q0_ddot_by_q1_dot
                    .mul_add(
                        c3,
                        l0
                            * ((-q1_ddot_by_q1_dot)
                                .mul_add(
                                    cos_q1_minus_q3,
                                    S::int(2) * q1_dot * sin_q1_minus_q3,
                                )),
                    ),
            ));
    // r1_by_q2_dot = -2*l1*q2'*(m2*sin(q2) + m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)))
    let r1_by_q2_dot = -S::int(2) * l1_q2_dot
        * (m3_s3.mul_add(q0_ddot_by_q2_part, m2_s2));
    // r2_by_q2_dot = -2*l0*l1*q2'*(m2*sin(q1 - q2) + m3*(sin(q1 - q2) + sin(q2 - q3)*cos(q1 - q3)))
    let r2_by_q2_dot = -l1_q2_dot * l0_scaled * s5_by_q2_part_2;
    // r3_by_q2_dot = -2*m3*l1^2*q2'*sin(q2 - q3)*cos(q2 - q3)
    let r3_by_q2_dot = -l1_q2_dot * s6_by_q3_part * cos_q2_minus_q3;
    // Shared terms.
    // r2_by_q2_dot + r1_by_q2_dot*s4_part_5; used 2 times
    let r7_by_q2_dot_part = r1_by_q2_dot.mul_add(s4_part_5, r2_by_q2_dot);
    // Elimination, step by step.
    // r7_by_q2_dot = l1*r1_by_q2_dot*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) - s5*(l0*r1_by_q2_dot*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2
    //   + m3*sin(q3)^2) + r2_by_q2_dot)/s4 + r3_by_q2_dot
    let r7_by_q2_dot = (-s5_s4_inv)
        .mul_add(
            r7_by_q2_dot_part,
            r1_by_q2_dot.mul_add(s4_part_4_s5_part, r3_by_q2_dot),
        );
    // Shared terms.
    // r7_by_q2_dot*q2_ddot_part; used 4 times
    let q1_ddot_by_q2_dot_part = r7_by_q2_dot * q2_ddot_part;
    // Elimination, step by step.
    // q1_ddot_by_q2_dot = (l0*r1_by_q2_dot*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 +
    //   m2 + m3*sin(q3)^2) + r2_by_q2_dot + s5*r7_by_q2_dot/(s5^2/s4 - s6))/s4
    let q1_ddot_by_q2_dot = s4_inv
        * ((-s5).mul_add(q1_ddot_by_q2_dot_part, r7_by_q2_dot_part));
    // q0_ddot_by_q2_dot = (r1_by_q2_dot + l1*r7_by_q2_dot*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 -
    //   q3)))/(s6 - s5^2/s4) + l0*q1_ddot_by_q2_dot*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3)))/(m0
    //   + m1 + m2 + m3*sin(q3)^2)
    let q0_ddot_by_q2_dot = s4_part_4
        * (s5_part
            .mul_add(
                q1_ddot_by_q2_dot_part,
                q1_ddot_by_q2_dot.mul_add(l0_s4_part_2, r1_by_q2_dot),
            ));
    // q3_ddot_by_q2_dot = (l1*(2*q2'*sin(q2 - q3) + r7_by_q2_dot*cos(q2 - q3)/(s5^2/s4 - s6)) -
    //   l0*q1_ddot_by_q2_dot*cos(q1 - q3) + q0_ddot_by_q2_dot*cos(q3))/l2
    let q3_ddot_by_q2_dot = l2_inv
        * (l1
            .mul_add(
                (-q1_ddot_by_q2_dot_part)
                    .mul_add(cos_q2_minus_q3, q2_dot * sin_q2_minus_q3_scaled),
                (-q1_ddot_by_q2_dot).mul_add(l0_cos_q1_minus_q3, q0_ddot_by_q2_dot * c3),
            ));
    // r1_by_q3_dot = -2*m3*l2*q3'*sin(q3)
    let r1_by_q3_dot = -S::int(2) * l2_q3_dot * m3_s3;
    // r2_by_q3_dot = -2*m3*l0*l2*q3'*sin(q1 - q3)
    let r2_by_q3_dot = -l2_q3_dot * s4_by_q3_part;
    // r3_by_q3_dot = -2*m3*l1*l2*q3'*sin(q2 - q3)
    let r3_by_q3_dot = -l2_q3_dot * s6_by_q3_part;
    // Shared terms.
    // r2_by_q3_dot + r1_by_q3_dot*s4_part_5; used 2 times
    let r7_by_q3_dot_part = r1_by_q3_dot.mul_add(s4_part_5, r2_by_q3_dot);
    // Elimination, step by step.
    // r7_by_q3_dot = l1*r1_by_q3_dot*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) - s5*(l0*r1_by_q3_dot*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2
    //   + m3*sin(q3)^2) + r2_by_q3_dot)/s4 + r3_by_q3_dot
    let r7_by_q3_dot = (-s5_s4_inv)
        .mul_add(
            r7_by_q3_dot_part,
            r1_by_q3_dot.mul_add(s4_part_4_s5_part, r3_by_q3_dot),
        );
    // Shared terms.
    // r7_by_q3_dot*q2_ddot_part; used 4 times
    let q1_ddot_by_q3_dot_part = r7_by_q3_dot * q2_ddot_part;
    // Elimination, step by step.
    // q1_ddot_by_q3_dot = (l0*r1_by_q3_dot*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 +
    //   m2 + m3*sin(q3)^2) + r2_by_q3_dot + s5*r7_by_q3_dot/(s5^2/s4 - s6))/s4
    let q1_ddot_by_q3_dot = s4_inv
        * ((-s5).mul_add(q1_ddot_by_q3_dot_part, r7_by_q3_dot_part));
    // q0_ddot_by_q3_dot = (r1_by_q3_dot + l1*r7_by_q3_dot*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 -
    //   q3)))/(s6 - s5^2/s4) + l0*q1_ddot_by_q3_dot*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3)))/(m0
    //   + m1 + m2 + m3*sin(q3)^2)
    let q0_ddot_by_q3_dot = s4_part_4
        * (s5_part
            .mul_add(
                q1_ddot_by_q3_dot_part,
                q1_ddot_by_q3_dot.mul_add(l0_s4_part_2, r1_by_q3_dot),
            ));
    // q3_ddot_by_q3_dot = (q0_ddot_by_q3_dot*cos(q3) - l1*r7_by_q3_dot*cos(q2 - q3)/(s6 - s5^2/s4) -
    //   l0*q1_ddot_by_q3_dot*cos(q1 - q3))/l2
    let q3_ddot_by_q3_dot = l2_inv
        * ((-l1_cos_q2_minus_q3)
            .mul_add(
                q1_ddot_by_q3_dot_part,
                (-q1_ddot_by_q3_dot).mul_add(l0_cos_q1_minus_q3, q0_ddot_by_q3_dot * c3),
            ));
    // Entries that are not zero.
    // d(q0')/d(q0') = 1
    let q0_dot_by_q0_dot_value = S::int(1);
    // d(q1')/d(q1') = 1
    let q1_dot_by_q1_dot_value = S::int(1);
    // d(q2')/d(q2') = 1
    let q2_dot_by_q2_dot_value = S::int(1);
    // d(q3')/d(q3') = 1
    let q3_dot_by_q3_dot_value = S::int(1);
    // d(q2'')/d(q1') = r7_by_q1_dot/(s6 - s5^2/s4)
    let q2_ddot_by_q1_dot_value = q1_ddot_by_q1_dot_part;
    // d(q2'')/d(q2') = r7_by_q2_dot/(s6 - s5^2/s4)
    let q2_ddot_by_q2_dot_value = q1_ddot_by_q2_dot_part;
    // d(q2'')/d(q3') = r7_by_q3_dot/(s6 - s5^2/s4)
    let q2_ddot_by_q3_dot_value = q1_ddot_by_q3_dot_part;
    [
        [zero, zero, zero, zero, q0_dot_by_q0_dot_value, zero, zero, zero],
        [zero, zero, zero, zero, zero, q1_dot_by_q1_dot_value, zero, zero],
        [zero, zero, zero, zero, zero, zero, q2_dot_by_q2_dot_value, zero],
        [zero, zero, zero, zero, zero, zero, zero, q3_dot_by_q3_dot_value],
        [
            zero,
            q0_ddot_by_q1,
            q0_ddot_by_q2,
            q0_ddot_by_q3,
            zero,
            q0_ddot_by_q1_dot,
            q0_ddot_by_q2_dot,
            q0_ddot_by_q3_dot,
        ],
        [
            zero,
            q1_ddot_by_q1,
            q1_ddot_by_q2,
            q1_ddot_by_q3,
            zero,
            q1_ddot_by_q1_dot,
            q1_ddot_by_q2_dot,
            q1_ddot_by_q3_dot,
        ],
        [
            zero,
            q2_ddot_by_q1,
            q2_ddot_by_q2,
            q2_ddot_by_q3,
            zero,
            q2_ddot_by_q1_dot_value,
            q2_ddot_by_q2_dot_value,
            q2_ddot_by_q3_dot_value,
        ],
        [
            zero,
            q3_ddot_by_q1,
            q3_ddot_by_q2,
            q3_ddot_by_q3,
            zero,
            q3_ddot_by_q1_dot,
            q3_ddot_by_q2_dot,
            q3_ddot_by_q3_dot,
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
    q_dot: &[S; 4],
) -> [S; 4] {
    let [q0_dot, q1_dot, q2_dot, q3_dot] = *q_dot;
    // Values.
    // q0' = q0'
    let q0_dot_value = q0_dot;
    // q1' = q1'
    let q1_dot_value = q1_dot;
    // q2' = q2'
    let q2_dot_value = q2_dot;
    // q3' = q3'
    let q3_dot_value = q3_dot;
    [q0_dot_value, q1_dot_value, q2_dot_value, q3_dot_value]
}

/// Kinetic energy T.
///
/// 36 operations, 6 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 4], q_dot: &[S; 4]) -> S {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, .. } = *p;
    let [_, q1, q2, q3] = *q;
    let [q0_dot, q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (_, c3) = q3.sin_cos();
    let (_, c1) = q1.sin_cos();
    let (_, c2) = q2.sin_cos();
    // Shared terms.
    // m2 + m3; used 2 times
    let m2_plus_m3 = m2 + m3;
    // m1 + m2_plus_m3; used 2 times
    let energy_part = m1 + m2_plus_m3;
    // l0*q1'; used 4 times
    let l0_q1_dot = l0 * q1_dot;
    // energy_part*l0_q1_dot; used 2 times
    let energy_part_2 = energy_part * l0_q1_dot;
    // l1*q2'; used 3 times
    let l1_q2_dot = l1 * q2_dot;
    // m2_plus_m3*l1_q2_dot; used 2 times
    let m2_plus_m3_l1_q2_dot = m2_plus_m3 * l1_q2_dot;
    // l2*q3'; used 2 times
    let l2_q3_dot = l2 * q3_dot;
    // m3*l2_q3_dot; used 2 times
    let m3_l2_q3_dot = m3 * l2_q3_dot;
    // Sines and cosines.
    let (_, cos_q1_minus_q3) = (q1 - q3).sin_cos();
    // Shared terms.
    // q0'*cos(q3) - l0_q1_dot*cos(q1 - q3)
    let energy_part_3 = (-l0_q1_dot).mul_add(cos_q1_minus_q3, q0_dot * c3);
    // q0'^2*(m0 + energy_part) + l2_q3_dot*m3_l2_q3_dot
    let energy_part_4 = l2_q3_dot
        .mul_add(m3_l2_q3_dot, q0_dot * q0_dot * (m0 + energy_part));
    // l0_q1_dot*energy_part_2 + l1_q2_dot*m2_plus_m3_l1_q2_dot
    let energy_part_5 = l1_q2_dot
        .mul_add(m2_plus_m3_l1_q2_dot, l0_q1_dot * energy_part_2);
    // energy_part_4 + energy_part_5
    let energy_part_6 = energy_part_4 + energy_part_5;
    // Sines and cosines.
    let (_, cos_q1_minus_q2) = (q1 - q2).sin_cos();
    let (_, cos_q2_minus_q3) = (q2 - q3).sin_cos();
    // Values.
    // T = q0'^2*(m0 + m1 + m2 + m3)/2 + l0^2*q1'^2*(m1 + m2 + m3)/2 - l0*q0'*q1'*cos(q1)*(m1 + m2 + m3) +
    //   l1^2*q2'^2*(m2 + m3)/2 - l1*q0'*q2'*cos(q2)*(m2 + m3) + l0*l1*q1'*q2'*cos(q1 - q2)*(m2 + m3) +
    //   m3*l2^2*q3'^2/2 - m3*l2*q0'*q3'*cos(q3) + m3*l0*l2*q1'*q3'*cos(q1 - q3) + m3*l1*l2*q2'*q3'*cos(q2 -
    //   q3)
    let energy = m3_l2_q3_dot
        .mul_add(
            l1_q2_dot.mul_add(cos_q2_minus_q3, -energy_part_3),
            (-(q0_dot * energy_part_2))
                .mul_add(
                    c1,
                    m2_plus_m3_l1_q2_dot
                        * ((-q0_dot).mul_add(c2, l0_q1_dot * cos_q1_minus_q2)),
                ),
        ) + S::ratio(1, 2) * energy_part_6;
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

/// Lagrange's equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Lagrange;

impl<S: Scalar> System<S> for Lagrange {
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
        0
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

fn array<S, const N: usize>(slice: &[S]) -> &[S; N] {
    slice.try_into().expect("a slice of the length that System states")
}
