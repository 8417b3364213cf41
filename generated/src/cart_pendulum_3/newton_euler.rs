//! Three-link pendulum on a cart: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/cart_pendulum_3/model.toml`. Do not edit; run `tripos regenerate`.
//! 4 coordinates, 4 speeds, 9 parameters, 4 reactions. Unknowns: (u0', u1', u2', u3', rail, T1, T2, T3).
//! Cost: mass_matrix 43 operations, 3 sines and cosines; forcing 41 operations, 3 sines and cosines; accelerations 209 operations, 3 sines and cosines.
//! The kinematic equations are singular nowhere.
//! The accelerations divide by m0 + m1 + m2 + m3*sin(q3)^2, by s5, by s7 - s6^2/s5, by l2.

use super::Parameters;
use tripos_traits::{Scalar, System};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows cart force n1, cart force n2, bob1 force n1, bob1 force n2, bob2 force n1, bob2 force n2, bob3 force n1, bob3 force n2.
///
/// 43 operations, 3 sines and cosines.
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
    let (s2_, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
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
    let m32 = -m1 * l0 * c1;
    // M36 = sin(q1)
    let m36 = s1;
    // M37 = -sin(q2)
    let m37 = -s2_;
    // M42 = -m1*l0*sin(q1)
    let m42 = -m1 * l0 * s1;
    // M46 = -cos(q1)
    let m46 = -c1;
    // M47 = cos(q2)
    let m47 = c2;
    // M51 = m2
    let m51 = m2;
    // M52 = -m2*l0*cos(q1)
    let m52 = -m2 * l0 * c1;
    // M53 = -m2*l1*cos(q2)
    let m53 = -m2 * l1 * c2;
    // M57 = sin(q2)
    let m57 = s2_;
    // M58 = -sin(q3)
    let m58 = -s3;
    // M62 = -m2*l0*sin(q1)
    let m62 = -m2 * l0 * s1;
    // M63 = -m2*l1*sin(q2)
    let m63 = -m2 * l1 * s2_;
    // M67 = -cos(q2)
    let m67 = -c2;
    // M68 = cos(q3)
    let m68 = c3;
    // M71 = m3
    let m71 = m3;
    // M72 = -m3*l0*cos(q1)
    let m72 = -m3 * l0 * c1;
    // M73 = -m3*l1*cos(q2)
    let m73 = -m3 * l1 * c2;
    // M74 = -m3*l2*cos(q3)
    let m74 = -m3 * l2 * c3;
    // M78 = sin(q3)
    let m78 = s3;
    // M82 = -m3*l0*sin(q1)
    let m82 = -m3 * l0 * s1;
    // M83 = -m3*l1*sin(q2)
    let m83 = -m3 * l1 * s2_;
    // M84 = -m3*l2*sin(q3)
    let m84 = -m3 * l2 * s3;
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
/// 41 operations, 3 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [S; 8] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, u1, u2, u3] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2_, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // l0*u1^2*cos(q1); used 3 times
    let l0_u1_sq_c1 = l0 * u1 * u1 * c1;
    // l0*u1^2*sin(q1); used 2 times
    let l0_u1_sq_s1 = l0 * u1 * u1 * s1;
    // l1*u2^2*sin(q2); used 2 times
    let l1_u2_sq_s2_ = l1 * u2 * u2 * s2_;
    // l1*u2^2*cos(q2); used 2 times
    let l1_u2_sq_c2 = l1 * u2 * u2 * c2;
    // Values.
    // f1 = F
    let f1 = F;
    // f2 = -m0*g
    let f2 = -m0 * g;
    // f3 = -m1*l0*u1^2*sin(q1)
    let f3 = -m1 * l0 * u1 * u1 * s1;
    // f4 = m1*(l0*u1^2*cos(q1) - g)
    let f4 = m1 * (l0_u1_sq_c1 - g);
    // f5 = -m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2))
    let f5 = -m2 * (l0_u1_sq_s1 + l1_u2_sq_s2_);
    // f6 = m2*(l0*u1^2*cos(q1) - g + l1*u2^2*cos(q2))
    let f6 = m2 * (l0_u1_sq_c1 - g + l1_u2_sq_c2);
    // f7 = -m3*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2) + l2*u3^2*sin(q3))
    let f7 = -m3 * (l0_u1_sq_s1 + l1_u2_sq_s2_ + l2 * u3 * u3 * s3);
    // f8 = m3*(l0*u1^2*cos(q1) - g + l1*u2^2*cos(q2) + l2*u3^2*cos(q3))
    let f8 = m3 * (l0_u1_sq_c1 - g + l1_u2_sq_c2 + l2 * u3 * u3 * c3);
    [f1, f2, f3, f4, f5, f6, f7, f8]
}

/// The accelerations (u0', u1', u2', u3'), solved for when this code was generated.
///
/// 209 operations, 3 sines and cosines.
#[must_use]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [S; 4] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, u1, u2, u3] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2_, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // l0*u1^2*cos(q1); used 2 times
    let l0_u1_sq_c1 = l0 * u1 * u1 * c1;
    // l0*u1^2*sin(q1); used 2 times
    let l0_u1_sq_s1 = l0 * u1 * u1 * s1;
    // l1*u2^2*sin(q2); used 2 times
    let l1_u2_sq_s2_ = l1 * u2 * u2 * s2_;
    // l0*u1^2*sin(q1) + l1*u2^2*sin(q2); used 3 times
    let r1_part = l0_u1_sq_s1 + l1_u2_sq_s2_;
    // l1*u2^2*cos(q2); used 3 times
    let l1_u2_sq_c2 = l1 * u2 * u2 * c2;
    // g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2); used 2 times
    let r1_part_ = g - l0_u1_sq_c1 - l1_u2_sq_c2;
    // Elimination, step by step.
    // r1 = F - m1*l0*u1^2*sin(q1) - m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) -
    //   m3*sin(q3)*(sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + cos(q3)*(l0*u1^2*cos(q1) - g +
    //   l1*u2^2*cos(q2)) + l2*u3^2)
    let r1 = F - m1 * l0 * u1 * u1 * s1 - m2 * r1_part
        + m3 * s3 * (c3 * r1_part_ - s3 * r1_part - l2 * u3 * u3);
    // Shared terms.
    // sin(q1)*sin(q2) + cos(q1)*cos(q2); used 2 times
    let s2_part = s1 * s2_ + c1 * c2;
    // sin(q1)*sin(q3) + cos(q1)*cos(q3); used 3 times
    let s2_part_ = s1 * s3 + c1 * c3;
    // sin(q2)*sin(q3) + cos(q2)*cos(q3); used 3 times
    let s2_part_2 = s2_ * s3 + c2 * c3;
    // Elimination, step by step.
    // s2 = l0*l1*(m2*(sin(q1)*sin(q2) + cos(q1)*cos(q2)) + m3*(sin(q1)*sin(q2) + cos(q1)*cos(q2))) -
    //   m3*l0*l1*(sin(q1)*sin(q3) + cos(q1)*cos(q3))*(sin(q2)*sin(q3) + cos(q2)*cos(q3))
    let s2 = l0 * l1 * (m2 * s2_part + m3 * s2_part)
        - m3 * l0 * l1 * s2_part_ * s2_part_2;
    // Shared terms.
    // l2*u3^2*sin(q3); used 2 times
    let l2_u3_sq_s3 = l2 * u3 * u3 * s3;
    // l2*u3^2*cos(q3); used 2 times
    let l2_u3_sq_c3 = l2 * u3 * u3 * c3;
    // cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2)); used
    //   2 times
    let r3_part = c3 * r1_part + s3 * r1_part_;
    // Elimination, step by step.
    // r3 = l0*(sin(q1)*(m1*g + m2*(g - l1*u2^2*cos(q2)) + m3*(g - l1*u2^2*cos(q2) - l2*u3^2*cos(q3))) +
    //   cos(q1)*(m2*l1*u2^2*sin(q2) + m3*(l1*u2^2*sin(q2) + l2*u3^2*sin(q3)))) - m3*l0*(sin(q1)*sin(q3) +
    //   cos(q1)*cos(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g - l0*u1^2*cos(q1) -
    //   l1*u2^2*cos(q2)))
    let r3 = l0
        * (s1 * (m1 * g + m2 * (g - l1_u2_sq_c2) + m3 * (g - l1_u2_sq_c2 - l2_u3_sq_c3))
            + c1 * (m2 * l1 * u2 * u2 * s2_ + m3 * (l1_u2_sq_s2_ + l2_u3_sq_s3)))
        - m3 * l0 * s2_part_ * r3_part;
    // r4 = l1*(m2*(g*sin(q2) + l0*u1^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2))) + m3*(sin(q2)*(g -
    //   l0*u1^2*cos(q1) - l2*u3^2*cos(q3)) + cos(q2)*(l0*u1^2*sin(q1) + l2*u3^2*sin(q3)))) -
    //   m3*l1*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g
    //   - l0*u1^2*cos(q1) - l1*u2^2*cos(q2)))
    let r4 = l1
        * (m2 * (g * s2_ + l0 * u1 * u1 * (s1 * c2 - c1 * s2_))
            + m3
                * (s2_ * (g - l0_u1_sq_c1 - l2_u3_sq_c3)
                    + c2 * (l0_u1_sq_s1 + l2_u3_sq_s3))) - m3 * l1 * s2_part_2 * r3_part;
    // Shared terms.
    // m3*sin(q3)^2; used 2 times
    let m3_s3_sq = m3 * s3 * s3;
    // m0 + m1 + m2 + m3*sin(q3)^2; used 6 times
    let s5_part = m0 + m1 + m2 + m3_s3_sq;
    // cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3); used 4 times
    let s5_part_ = c1 * (m1 + m2 + m3_s3_sq) - m3 * s1 * s3 * c3;
    // Elimination, step by step.
    // s5 = l0^2*(m1 + m2 + m3) - m3*l0^2*(sin(q1)*sin(q3) + cos(q1)*cos(q3))^2 - l0^2*(cos(q1)*(m1 + m2 +
    //   m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s5 = l0 * l0 * (m1 + m2 + m3) - m3 * l0 * l0 * s2_part_ * s2_part_
        - l0 * l0 * s5_part_ * s5_part_ / s5_part;
    // Shared terms.
    // m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2); used 4 times
    let s6_part = m3 * s3 * (s2_ * c3 - c2 * s3) - m2 * c2;
    // Elimination, step by step.
    // s6 = l0*l1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3))*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))/(m0 + m1 +
    //   m2 + m3*sin(q3)^2) + s2
    let s6 = l0 * l1 * s5_part_ * s6_part / s5_part + s2;
    // s7 = l1^2*(m2 + m3) - m3*l1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3))^2 -
    //   l1^2*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s7 = l1 * l1 * (m2 + m3) - m3 * l1 * l1 * s2_part_2 * s2_part_2
        - l1 * l1 * s6_part * s6_part / s5_part;
    // Shared terms.
    // l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2);
    //   used 2 times
    let r8_part = l0 * r1 * s5_part_ / s5_part;
    // Elimination, step by step.
    // r8 = l1*r1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r4 - s6*(l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 +
    //   m1 + m2 + m3*sin(q3)^2) + r3)/s5
    let r8 = r4 - l1 * r1 * s6_part / s5_part - s6 * (r8_part + r3) / s5;
    // u2' = r8/(s7 - s6^2/s5)
    let u2_dot = r8 / (s7 - s6 * s6 / s5);
    // u1' = (l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r3 - u2'*s6)/s5
    let u1_dot = (r8_part + r3 - u2_dot * s6) / s5;
    // u0' = (l0*u1'*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3)) + l1*u2'*(m2*cos(q2) -
    //   m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3))) + r1)/(m0 + m1 + m2 + m3*sin(q3)^2)
    let u0_dot = (l0 * u1_dot * s5_part_ - l1 * u2_dot * s6_part + r1) / s5_part;
    // u3' = (cos(q3)*(u0' + l0*(u1^2*sin(q1) - u1'*cos(q1)) + l1*(u2^2*sin(q2) - u2'*cos(q2))) +
    //   sin(q3)*(g - l0*(u1^2*cos(q1) + u1'*sin(q1)) - l1*(u2^2*cos(q2) + u2'*sin(q2))))/l2
    let u3_dot = (c3
        * (u0_dot + l0 * (u1 * u1 * s1 - u1_dot * c1)
            + l1 * (u2 * u2 * s2_ - u2_dot * c2))
        + s3
            * (g - l0 * (u1 * u1 * c1 + u1_dot * s1)
                - l1 * (u2 * u2 * c2 + u2_dot * s2_))) / l2;
    [u0_dot, u1_dot, u2_dot, u3_dot]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 209 operations, 3 sines and cosines.
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
    let (s2_, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // l0*u1^2*cos(q1); used 2 times
    let l0_u1_sq_c1 = l0 * u1 * u1 * c1;
    // l0*u1^2*sin(q1); used 2 times
    let l0_u1_sq_s1 = l0 * u1 * u1 * s1;
    // l1*u2^2*sin(q2); used 2 times
    let l1_u2_sq_s2_ = l1 * u2 * u2 * s2_;
    // l0*u1^2*sin(q1) + l1*u2^2*sin(q2); used 3 times
    let r1_part = l0_u1_sq_s1 + l1_u2_sq_s2_;
    // l1*u2^2*cos(q2); used 3 times
    let l1_u2_sq_c2 = l1 * u2 * u2 * c2;
    // g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2); used 2 times
    let r1_part_ = g - l0_u1_sq_c1 - l1_u2_sq_c2;
    // Elimination, step by step.
    // r1 = F - m1*l0*u1^2*sin(q1) - m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) -
    //   m3*sin(q3)*(sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + cos(q3)*(l0*u1^2*cos(q1) - g +
    //   l1*u2^2*cos(q2)) + l2*u3^2)
    let r1 = F - m1 * l0 * u1 * u1 * s1 - m2 * r1_part
        + m3 * s3 * (c3 * r1_part_ - s3 * r1_part - l2 * u3 * u3);
    // Shared terms.
    // sin(q1)*sin(q2) + cos(q1)*cos(q2); used 2 times
    let s2_part = s1 * s2_ + c1 * c2;
    // sin(q1)*sin(q3) + cos(q1)*cos(q3); used 3 times
    let s2_part_ = s1 * s3 + c1 * c3;
    // sin(q2)*sin(q3) + cos(q2)*cos(q3); used 3 times
    let s2_part_2 = s2_ * s3 + c2 * c3;
    // Elimination, step by step.
    // s2 = l0*l1*(m2*(sin(q1)*sin(q2) + cos(q1)*cos(q2)) + m3*(sin(q1)*sin(q2) + cos(q1)*cos(q2))) -
    //   m3*l0*l1*(sin(q1)*sin(q3) + cos(q1)*cos(q3))*(sin(q2)*sin(q3) + cos(q2)*cos(q3))
    let s2 = l0 * l1 * (m2 * s2_part + m3 * s2_part)
        - m3 * l0 * l1 * s2_part_ * s2_part_2;
    // Shared terms.
    // l2*u3^2*sin(q3); used 2 times
    let l2_u3_sq_s3 = l2 * u3 * u3 * s3;
    // l2*u3^2*cos(q3); used 2 times
    let l2_u3_sq_c3 = l2 * u3 * u3 * c3;
    // cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2)); used
    //   2 times
    let r3_part = c3 * r1_part + s3 * r1_part_;
    // Elimination, step by step.
    // r3 = l0*(sin(q1)*(m1*g + m2*(g - l1*u2^2*cos(q2)) + m3*(g - l1*u2^2*cos(q2) - l2*u3^2*cos(q3))) +
    //   cos(q1)*(m2*l1*u2^2*sin(q2) + m3*(l1*u2^2*sin(q2) + l2*u3^2*sin(q3)))) - m3*l0*(sin(q1)*sin(q3) +
    //   cos(q1)*cos(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g - l0*u1^2*cos(q1) -
    //   l1*u2^2*cos(q2)))
    let r3 = l0
        * (s1 * (m1 * g + m2 * (g - l1_u2_sq_c2) + m3 * (g - l1_u2_sq_c2 - l2_u3_sq_c3))
            + c1 * (m2 * l1 * u2 * u2 * s2_ + m3 * (l1_u2_sq_s2_ + l2_u3_sq_s3)))
        - m3 * l0 * s2_part_ * r3_part;
    // r4 = l1*(m2*(g*sin(q2) + l0*u1^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2))) + m3*(sin(q2)*(g -
    //   l0*u1^2*cos(q1) - l2*u3^2*cos(q3)) + cos(q2)*(l0*u1^2*sin(q1) + l2*u3^2*sin(q3)))) -
    //   m3*l1*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g
    //   - l0*u1^2*cos(q1) - l1*u2^2*cos(q2)))
    let r4 = l1
        * (m2 * (g * s2_ + l0 * u1 * u1 * (s1 * c2 - c1 * s2_))
            + m3
                * (s2_ * (g - l0_u1_sq_c1 - l2_u3_sq_c3)
                    + c2 * (l0_u1_sq_s1 + l2_u3_sq_s3))) - m3 * l1 * s2_part_2 * r3_part;
    // Shared terms.
    // m3*sin(q3)^2; used 2 times
    let m3_s3_sq = m3 * s3 * s3;
    // m0 + m1 + m2 + m3*sin(q3)^2; used 6 times
    let s5_part = m0 + m1 + m2 + m3_s3_sq;
    // cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3); used 4 times
    let s5_part_ = c1 * (m1 + m2 + m3_s3_sq) - m3 * s1 * s3 * c3;
    // Elimination, step by step.
    // s5 = l0^2*(m1 + m2 + m3) - m3*l0^2*(sin(q1)*sin(q3) + cos(q1)*cos(q3))^2 - l0^2*(cos(q1)*(m1 + m2 +
    //   m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s5 = l0 * l0 * (m1 + m2 + m3) - m3 * l0 * l0 * s2_part_ * s2_part_
        - l0 * l0 * s5_part_ * s5_part_ / s5_part;
    // Shared terms.
    // m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2); used 4 times
    let s6_part = m3 * s3 * (s2_ * c3 - c2 * s3) - m2 * c2;
    // Elimination, step by step.
    // s6 = l0*l1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3))*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))/(m0 + m1 +
    //   m2 + m3*sin(q3)^2) + s2
    let s6 = l0 * l1 * s5_part_ * s6_part / s5_part + s2;
    // s7 = l1^2*(m2 + m3) - m3*l1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3))^2 -
    //   l1^2*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s7 = l1 * l1 * (m2 + m3) - m3 * l1 * l1 * s2_part_2 * s2_part_2
        - l1 * l1 * s6_part * s6_part / s5_part;
    // Shared terms.
    // l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2);
    //   used 2 times
    let r8_part = l0 * r1 * s5_part_ / s5_part;
    // Elimination, step by step.
    // r8 = l1*r1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r4 - s6*(l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 +
    //   m1 + m2 + m3*sin(q3)^2) + r3)/s5
    let r8 = r4 - l1 * r1 * s6_part / s5_part - s6 * (r8_part + r3) / s5;
    // u2' = r8/(s7 - s6^2/s5)
    let u2_dot = r8 / (s7 - s6 * s6 / s5);
    // u1' = (l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r3 - u2'*s6)/s5
    let u1_dot = (r8_part + r3 - u2_dot * s6) / s5;
    // u0' = (l0*u1'*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3)) + l1*u2'*(m2*cos(q2) -
    //   m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3))) + r1)/(m0 + m1 + m2 + m3*sin(q3)^2)
    let u0_dot = (l0 * u1_dot * s5_part_ - l1 * u2_dot * s6_part + r1) / s5_part;
    // u3' = (cos(q3)*(u0' + l0*(u1^2*sin(q1) - u1'*cos(q1)) + l1*(u2^2*sin(q2) - u2'*cos(q2))) +
    //   sin(q3)*(g - l0*(u1^2*cos(q1) + u1'*sin(q1)) - l1*(u2^2*cos(q2) + u2'*sin(q2))))/l2
    let u3_dot = (c3
        * (u0_dot + l0 * (u1 * u1 * s1 - u1_dot * c1)
            + l1 * (u2 * u2 * s2_ - u2_dot * c2))
        + s3
            * (g - l0 * (u1 * u1 * c1 + u1_dot * s1)
                - l1 * (u2 * u2 * c2 + u2_dot * s2_))) / l2;
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
/// 902 operations, 3 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [[S; 8]; 8] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, u1, u2, u3] = *u;
    let zero = S::int(0);
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2_, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // l2*u3^2; used 2 times
    let l2_u3_sq = l2 * u3 * u3;
    // l0*u1^2*cos(q1); used 2 times
    let l0_u1_sq_c1 = l0 * u1 * u1 * c1;
    // l0*u1^2*sin(q1); used 2 times
    let l0_u1_sq_s1 = l0 * u1 * u1 * s1;
    // l1*u2^2*sin(q2); used 2 times
    let l1_u2_sq_s2_ = l1 * u2 * u2 * s2_;
    // l0*u1^2*sin(q1) + l1*u2^2*sin(q2); used 3 times
    let r1_part = l0_u1_sq_s1 + l1_u2_sq_s2_;
    // l1*u2^2*cos(q2); used 3 times
    let l1_u2_sq_c2 = l1 * u2 * u2 * c2;
    // g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2); used 3 times
    let r1_part_ = g - l0_u1_sq_c1 - l1_u2_sq_c2;
    // cos(q3)*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2)); used 3 times
    let r1_part_2 = c3 * r1_part_;
    // sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)); used 3 times
    let r1_part_3 = s3 * r1_part;
    // Elimination, step by step.
    // r1 = F - m1*l0*u1^2*sin(q1) - m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) -
    //   m3*sin(q3)*(sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + cos(q3)*(l0*u1^2*cos(q1) - g +
    //   l1*u2^2*cos(q2)) + l2*u3^2)
    let r1 = F - m1 * l0 * u1 * u1 * s1 - m2 * r1_part
        + m3 * s3 * (r1_part_2 - r1_part_3 - l2_u3_sq);
    // Shared terms.
    // cos(q1)*cos(q2); used 2 times
    let c1_c2 = c1 * c2;
    // sin(q1)*sin(q2) + cos(q1)*cos(q2); used 3 times
    let s2_part = s1 * s2_ + c1_c2;
    // m2*(sin(q1)*sin(q2) + cos(q1)*cos(q2)); used 2 times
    let s2_part_ = m2 * s2_part;
    // sin(q1)*sin(q3) + cos(q1)*cos(q3); used 11 times
    let s2_part_2 = s1 * s3 + c1 * c3;
    // sin(q2)*sin(q3) + cos(q2)*cos(q3); used 14 times
    let s2_part_3 = s2_ * s3 + c2 * c3;
    // Elimination, step by step.
    // s2 = l0*l1*(m2*(sin(q1)*sin(q2) + cos(q1)*cos(q2)) + m3*(sin(q1)*sin(q2) + cos(q1)*cos(q2))) -
    //   m3*l0*l1*(sin(q1)*sin(q3) + cos(q1)*cos(q3))*(sin(q2)*sin(q3) + cos(q2)*cos(q3))
    let s2 = l0 * l1 * (s2_part_ + m3 * s2_part) - m3 * l0 * l1 * s2_part_2 * s2_part_3;
    // Shared terms.
    // l2*u3^2*sin(q3); used 2 times
    let l2_u3_sq_s3 = l2 * u3 * u3 * s3;
    // l2*u3^2*cos(q3); used 2 times
    let l2_u3_sq_c3 = l2 * u3 * u3 * c3;
    // m1*g + m2*(g - l1*u2^2*cos(q2)) + m3*(g - l1*u2^2*cos(q2) - l2*u3^2*cos(q3)); used 2 times
    let r3_part = m1 * g + m2 * (g - l1_u2_sq_c2) + m3 * (g - l1_u2_sq_c2 - l2_u3_sq_c3);
    // m2*l1*u2^2*sin(q2) + m3*(l1*u2^2*sin(q2) + l2*u3^2*sin(q3)); used 2 times
    let r3_part_ = m2 * l1 * u2 * u2 * s2_ + m3 * (l1_u2_sq_s2_ + l2_u3_sq_s3);
    // cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2)); used
    //   4 times
    let r3_part_2 = c3 * r1_part + s3 * r1_part_;
    // Elimination, step by step.
    // r3 = l0*(sin(q1)*(m1*g + m2*(g - l1*u2^2*cos(q2)) + m3*(g - l1*u2^2*cos(q2) - l2*u3^2*cos(q3))) +
    //   cos(q1)*(m2*l1*u2^2*sin(q2) + m3*(l1*u2^2*sin(q2) + l2*u3^2*sin(q3)))) - m3*l0*(sin(q1)*sin(q3) +
    //   cos(q1)*cos(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g - l0*u1^2*cos(q1) -
    //   l1*u2^2*cos(q2)))
    let r3 = l0 * (s1 * r3_part + c1 * r3_part_) - m3 * l0 * s2_part_2 * r3_part_2;
    // Shared terms.
    // g - l0*u1^2*cos(q1) - l2*u3^2*cos(q3); used 2 times
    let r4_part = g - l0_u1_sq_c1 - l2_u3_sq_c3;
    // l0*u1^2*sin(q1) + l2*u3^2*sin(q3); used 2 times
    let r4_part_ = l0_u1_sq_s1 + l2_u3_sq_s3;
    // sin(q1)*cos(q2); used 2 times
    let s1_c2 = s1 * c2;
    // cos(q1)*sin(q2); used 2 times
    let c1_s2_ = c1 * s2_;
    // sin(q1)*cos(q2) - cos(q1)*sin(q2); used 3 times
    let r4_part_2 = s1_c2 - c1_s2_;
    // Elimination, step by step.
    // r4 = l1*(m2*(g*sin(q2) + l0*u1^2*(sin(q1)*cos(q2) - cos(q1)*sin(q2))) + m3*(sin(q2)*(g -
    //   l0*u1^2*cos(q1) - l2*u3^2*cos(q3)) + cos(q2)*(l0*u1^2*sin(q1) + l2*u3^2*sin(q3)))) -
    //   m3*l1*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g
    //   - l0*u1^2*cos(q1) - l1*u2^2*cos(q2)))
    let r4 = l1
        * (m2 * (g * s2_ + l0 * u1 * u1 * r4_part_2)
            + m3 * (s2_ * r4_part + c2 * r4_part_)) - m3 * l1 * s2_part_3 * r3_part_2;
    // Shared terms.
    // m3*sin(q3)^2; used 2 times
    let m3_s3_sq = m3 * s3 * s3;
    // m0 + m1 + m2 + m3*sin(q3)^2; used 40 times
    let s5_part = m0 + m1 + m2 + m3_s3_sq;
    // m1 + m2 + m3*sin(q3)^2; used 2 times
    let s5_part_ = m1 + m2 + m3_s3_sq;
    // cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3); used 22 times
    let s5_part_2 = c1 * s5_part_ - m3 * s1 * s3 * c3;
    // Elimination, step by step.
    // s5 = l0^2*(m1 + m2 + m3) - m3*l0^2*(sin(q1)*sin(q3) + cos(q1)*cos(q3))^2 - l0^2*(cos(q1)*(m1 + m2 +
    //   m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s5 = l0 * l0 * (m1 + m2 + m3) - m3 * l0 * l0 * s2_part_2 * s2_part_2
        - l0 * l0 * s5_part_2 * s5_part_2 / s5_part;
    // Shared terms.
    // sin(q2)*cos(q3) - cos(q2)*sin(q3); used 9 times
    let s6_part = s2_ * c3 - c2 * s3;
    // m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2); used 23 times
    let s6_part_ = m3 * s3 * s6_part - m2 * c2;
    // Elimination, step by step.
    // s6 = l0*l1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3))*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))/(m0 + m1 +
    //   m2 + m3*sin(q3)^2) + s2
    let s6 = l0 * l1 * s5_part_2 * s6_part_ / s5_part + s2;
    // Shared terms.
    // m2 + m3; used 2 times
    let m2_plus_m3 = m2 + m3;
    // Elimination, step by step.
    // s7 = l1^2*(m2 + m3) - m3*l1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3))^2 -
    //   l1^2*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s7 = l1 * l1 * m2_plus_m3 - m3 * l1 * l1 * s2_part_3 * s2_part_3
        - l1 * l1 * s6_part_ * s6_part_ / s5_part;
    // Shared terms.
    // l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2);
    //   used 2 times
    let r8_part = l0 * r1 * s5_part_2 / s5_part;
    // l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2)
    //   + r3; used 5 times
    let r8_part_ = r8_part + r3;
    // Elimination, step by step.
    // r8 = l1*r1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r4 - s6*(l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 +
    //   m1 + m2 + m3*sin(q3)^2) + r3)/s5
    let r8 = r4 - l1 * r1 * s6_part_ / s5_part - s6 * r8_part_ / s5;
    // Shared terms.
    // s7 - s6^2/s5; used 20 times
    let u2_dot_part = s7 - s6 * s6 / s5;
    // Elimination, step by step.
    // u2' = r8/(s7 - s6^2/s5)
    let u2_dot = r8 / u2_dot_part;
    // Shared terms.
    // l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2)
    //   + r3 - u2'*s6; used 3 times
    let u1_dot_part = r8_part + r3 - u2_dot * s6;
    // Elimination, step by step.
    // u1' = (l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r3 - u2'*s6)/s5
    let u1_dot = u1_dot_part / s5;
    // Shared terms.
    // l0*u1'*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3)) + l1*u2'*(m2*cos(q2) -
    //   m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3))) + r1; used 2 times
    let u0_dot_part = l0 * u1_dot * s5_part_2 - l1 * u2_dot * s6_part_ + r1;
    // Elimination, step by step.
    // u0' = (l0*u1'*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3)) + l1*u2'*(m2*cos(q2) -
    //   m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3))) + r1)/(m0 + m1 + m2 + m3*sin(q3)^2)
    let u0_dot = u0_dot_part / s5_part;
    // r1_by_q1 = l0*u1^2*(m3*sin(q1)*sin(q3)*cos(q3) - cos(q1)*(m1 + m2 + m3*sin(q3)^2))
    let r1_by_q1 = -l0 * u1 * u1 * s5_part_2;
    // Shared terms.
    // sin(q1)*cos(q3) - cos(q1)*sin(q3); used 5 times
    let s2_by_q1_part = s1 * c3 - c1 * s3;
    // m2*(sin(q1)*cos(q2) - cos(q1)*sin(q2)); used 3 times
    let s2_by_q1_part_ = m2 * r4_part_2;
    // l0*l1*(m2*(sin(q1)*cos(q2) - cos(q1)*sin(q2)) + m3*(sin(q1)*cos(q2) - cos(q1)*sin(q2))); used 2
    //   times
    let s2_by_q1_part_2 = l0 * l1 * (s2_by_q1_part_ + m3 * r4_part_2);
    // m3*l0*l1*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(sin(q1)*cos(q3) - cos(q1)*sin(q3)); used 2 times
    let s2_by_q1_part_3 = m3 * l0 * l1 * s2_part_3 * s2_by_q1_part;
    // Elimination, step by step.
    // s2_by_q1 = m3*l0*l1*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(sin(q1)*cos(q3) - cos(q1)*sin(q3)) -
    //   l0*l1*(m2*(sin(q1)*cos(q2) - cos(q1)*sin(q2)) + m3*(sin(q1)*cos(q2) - cos(q1)*sin(q2)))
    let s2_by_q1 = s2_by_q1_part_3 - s2_by_q1_part_2;
    // Shared terms.
    // m3*l0*(sin(q1)*cos(q3) - cos(q1)*sin(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g
    //   - l0*u1^2*cos(q1) - l1*u2^2*cos(q2))); used 2 times
    let r3_by_q1_part = m3 * l0 * s2_by_q1_part * r3_part_2;
    // Elimination, step by step.
    // r3_by_q1 = m3*l0*(sin(q1)*cos(q3) - cos(q1)*sin(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) +
    //   sin(q3)*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2))) - m3*l0*(sin(q1)*sin(q3) +
    //   cos(q1)*cos(q3))*(l0*u1^2*sin(q1)*sin(q3) + l0*u1^2*cos(q1)*cos(q3)) + l0*(cos(q1)*(m1*g + m2*(g -
    //   l1*u2^2*cos(q2)) + m3*(g - l1*u2^2*cos(q2) - l2*u3^2*cos(q3))) - sin(q1)*(m2*l1*u2^2*sin(q2) +
    //   m3*(l1*u2^2*sin(q2) + l2*u3^2*sin(q3))))
    let r3_by_q1 = r3_by_q1_part
        - m3 * l0 * s2_part_2 * (l0 * u1 * u1 * s1 * s3 + l0 * u1 * u1 * c1 * c3)
        + l0 * (c1 * r3_part - s1 * r3_part_);
    // Shared terms.
    // m2*(sin(q1)*sin(q2) + cos(q1)*cos(q2)) + m3*(cos(q1)*cos(q2) + cos(q3)*(sin(q1)*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3)) - cos(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)))); used 2 times
    let r4_by_q1_part = s2_part_ + m3 * (c1_c2 + c3 * (s1 * s6_part - c1 * s2_part_3));
    // Elimination, step by step.
    // r4_by_q1 = l0*l1*u1^2*(m2*(sin(q1)*sin(q2) + cos(q1)*cos(q2)) + m3*(cos(q1)*cos(q2) +
    //   cos(q3)*(sin(q1)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - cos(q1)*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)))))
    let r4_by_q1 = l0 * l1 * u1 * u1 * r4_by_q1_part;
    // Shared terms.
    // m3*cos(q1)*sin(q3)*cos(q3); used 2 times
    let m3_c1_s3_c3 = m3 * c1 * s3 * c3;
    // m3*cos(q1)*sin(q3)*cos(q3) + sin(q1)*(m1 + m2 + m3*sin(q3)^2); used 5 times
    let s5_by_q1_part = m3_c1_s3_c3 + s1 * s5_part_;
    // Elimination, step by step.
    // s5_by_q1 = 2*m3*l0^2*(sin(q1)*sin(q3) + cos(q1)*cos(q3))*(sin(q1)*cos(q3) - cos(q1)*sin(q3)) +
    //   2*l0^2*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))*(m3*cos(q1)*sin(q3)*cos(q3) +
    //   sin(q1)*(m1 + m2 + m3*sin(q3)^2))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s5_by_q1 = S::int(2) * m3 * l0 * l0 * s2_part_2 * s2_by_q1_part
        + S::int(2) * l0 * l0 * s5_part_2 * s5_by_q1_part / s5_part;
    // s6_by_q1 = l0*l1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3)))*(m3*cos(q1)*sin(q3)*cos(q3) + sin(q1)*(m1 + m2 + m3*sin(q3)^2))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + s2_by_q1
    let s6_by_q1 = s2_by_q1 - l0 * l1 * s6_part_ * s5_by_q1_part / s5_part;
    // Shared terms.
    // l0*r1*(m3*cos(q1)*sin(q3)*cos(q3) + sin(q1)*(m1 + m2 + m3*sin(q3)^2))/(m0 + m1 + m2 + m3*sin(q3)^2);
    //   used 2 times
    let r8_by_q1_part = l0 * r1 * s5_by_q1_part / s5_part;
    // l0*r1_by_q1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2); used 2 times
    let r8_by_q1_part_ = l0 * r1_by_q1 * s5_part_2 / s5_part;
    // Elimination, step by step.
    // r8_by_q1 = l1*r1_by_q1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + s6*(l0*r1*(m3*cos(q1)*sin(q3)*cos(q3) + sin(q1)*(m1 + m2 + m3*sin(q3)^2))/(m0 + m1 +
    //   m2 + m3*sin(q3)^2) - l0*r1_by_q1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0
    //   + m1 + m2 + m3*sin(q3)^2) - r3_by_q1)/s5 + r4_by_q1 + s6*s5_by_q1*(l0*r1*(cos(q1)*(m1 + m2 +
    //   m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r3)/s5^2 -
    //   s6_by_q1*(l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r3)/s5
    let r8_by_q1 = s6 * (r8_by_q1_part - r8_by_q1_part_ - r3_by_q1) / s5
        - l1 * r1_by_q1 * s6_part_ / s5_part + r4_by_q1
        + s6 * s5_by_q1 * r8_part_ / (s5 * s5) - s6_by_q1 * r8_part_ / s5;
    // u2_dot_by_q1 = (s6*r8*(2*s6_by_q1 - s6*s5_by_q1/s5)/(s5*(s7 - s6^2/s5)) + r8_by_q1)/(s7 - s6^2/s5)
    let u2_dot_by_q1 = (s6 * r8 * (S::int(2) * s6_by_q1 - s6 * s5_by_q1 / s5)
        / (s5 * u2_dot_part) + r8_by_q1) / u2_dot_part;
    // u1_dot_by_q1 = s5_by_q1*(u2'*s6 - l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) - r3)/s5^2 + (l0*r1_by_q1*(cos(q1)*(m1 +
    //   m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) -
    //   l0*r1*(m3*cos(q1)*sin(q3)*cos(q3) + sin(q1)*(m1 + m2 + m3*sin(q3)^2))/(m0 + m1 + m2 + m3*sin(q3)^2)
    //   + r3_by_q1 - u2'*s6_by_q1 - s6*u2_dot_by_q1)/s5
    let u1_dot_by_q1 = (r8_by_q1_part_ - r8_by_q1_part + r3_by_q1 - u2_dot * s6_by_q1
        - s6 * u2_dot_by_q1) / s5 - s5_by_q1 * u1_dot_part / (s5 * s5);
    // u0_dot_by_q1 = (r1_by_q1 - l0*u1'*(m3*cos(q1)*sin(q3)*cos(q3) + sin(q1)*(m1 + m2 + m3*sin(q3)^2)) +
    //   l1*u2_dot_by_q1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3))) +
    //   l0*u1_dot_by_q1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2)
    let u0_dot_by_q1 = (r1_by_q1 - l0 * u1_dot * s5_by_q1_part
        - l1 * u2_dot_by_q1 * s6_part_ + l0 * u1_dot_by_q1 * s5_part_2) / s5_part;
    // Shared terms.
    // u1^2; used 2 times
    let u1_sq = u1 * u1;
    // u1_dot_by_q1 - u1^2; used 2 times
    let u3_dot_by_q1_part = u1_dot_by_q1 - u1_sq;
    // Elimination, step by step.
    // u3_dot_by_q1 = (u0_dot_by_q1*cos(q3) - l1*u2_dot_by_q1*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) -
    //   l0*(sin(q1)*(sin(q3)*(u1_dot_by_q1 - u1^2) - u1'*cos(q3)) + cos(q1)*(u1'*sin(q3) +
    //   cos(q3)*(u1_dot_by_q1 - u1^2))))/l2
    let u3_dot_by_q1 = (u0_dot_by_q1 * c3 - l1 * u2_dot_by_q1 * s2_part_3
        - l0
            * (s1 * (s3 * u3_dot_by_q1_part - u1_dot * c3)
                + c1 * (u1_dot * s3 + c3 * u3_dot_by_q1_part))) / l2;
    // r1_by_q2 = l1*u2^2*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))
    let r1_by_q2 = l1 * u2 * u2 * s6_part_;
    // Shared terms.
    // m3*l0*l1*(sin(q1)*sin(q3) + cos(q1)*cos(q3))*(sin(q2)*cos(q3) - cos(q2)*sin(q3)); used 2 times
    let s2_by_q2_part = m3 * l0 * l1 * s2_part_2 * s6_part;
    // Elimination, step by step.
    // s2_by_q2 = l0*l1*(m2*(sin(q1)*cos(q2) - cos(q1)*sin(q2)) + m3*(sin(q1)*cos(q2) - cos(q1)*sin(q2))) +
    //   m3*l0*l1*(sin(q1)*sin(q3) + cos(q1)*cos(q3))*(sin(q2)*cos(q3) - cos(q2)*sin(q3))
    let s2_by_q2 = s2_by_q1_part_2 + s2_by_q2_part;
    // r3_by_q2 = l0*l1*u2^2*(m2*(sin(q1)*sin(q2) + cos(q1)*cos(q2)) + m3*(cos(q1)*cos(q2) +
    //   cos(q3)*(sin(q1)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - cos(q1)*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)))))
    let r3_by_q2 = l0 * l1 * u2 * u2 * r4_by_q1_part;
    // Shared terms.
    // m3*l1*(sin(q2)*cos(q3) - cos(q2)*sin(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + sin(q3)*(g
    //   - l0*u1^2*cos(q1) - l1*u2^2*cos(q2))); used 2 times
    let r4_by_q2_part = m3 * l1 * s6_part * r3_part_2;
    // Elimination, step by step.
    // r4_by_q2 = m3*l1*(sin(q2)*cos(q3) - cos(q2)*sin(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) +
    //   sin(q3)*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2))) - m3*l1*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3))*(l1*u2^2*sin(q2)*sin(q3) + l1*u2^2*cos(q2)*cos(q3)) + l1*(m2*(g*cos(q2) -
    //   l0*u1^2*(sin(q1)*sin(q2) + cos(q1)*cos(q2))) + m3*(cos(q2)*(g - l0*u1^2*cos(q1) - l2*u3^2*cos(q3)) -
    //   sin(q2)*(l0*u1^2*sin(q1) + l2*u3^2*sin(q3))))
    let r4_by_q2 = r4_by_q2_part
        - m3 * l1 * s2_part_3 * (l1 * u2 * u2 * s2_ * s3 + l1 * u2 * u2 * c2 * c3)
        + l1
            * (m2 * (g * c2 - l0 * u1 * u1 * s2_part)
                + m3 * (c2 * r4_part - s2_ * r4_part_));
    // Shared terms.
    // m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)); used 2 times
    let s6_by_q2_part = m3 * s3 * s2_part_3;
    // m2*sin(q2) + m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)); used 4 times
    let s6_by_q2_part_ = m2 * s2_ + s6_by_q2_part;
    // Elimination, step by step.
    // s6_by_q2 = l0*l1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))*(m2*sin(q2) +
    //   m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) + s2_by_q2
    let s6_by_q2 = l0 * l1 * s5_part_2 * s6_by_q2_part_ / s5_part + s2_by_q2;
    // Shared terms.
    // m3*l1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(sin(q2)*cos(q3) - cos(q2)*sin(q3)); used 2 times
    let s7_by_q2_part = m3 * l1 * l1 * s2_part_3 * s6_part;
    // Elimination, step by step.
    // s7_by_q2 = 2*m3*l1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) +
    //   2*l1^2*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))*(m2*sin(q2) +
    //   m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s7_by_q2 = S::int(2) * s7_by_q2_part
        - S::int(2) * l1 * l1 * s6_part_ * s6_by_q2_part_ / s5_part;
    // Shared terms.
    // s6*r1_by_q2 + r1*s6_by_q2; used 2 times
    let r8_by_q2_part = s6 * r1_by_q2 + r1 * s6_by_q2;
    // l0*cos(q1)*(s6*r1_by_q2 + r1*s6_by_q2); used 2 times
    let r8_by_q2_part_ = l0 * c1 * r8_by_q2_part;
    // r3*s6_by_q2; used 3 times
    let r3_s6_by_q2 = r3 * s6_by_q2;
    // s6*r3_by_q2; used 3 times
    let s6_r3_by_q2 = s6 * r3_by_q2;
    // s5*(l1*(r1_by_q2*cos(q2) - r1*sin(q2)) + r4_by_q2) - s6*r3_by_q2 - r3*s6_by_q2 -
    //   l0*cos(q1)*(s6*r1_by_q2 + r1*s6_by_q2); used 2 times
    let r8_by_q2_part_2 = s5 * (l1 * (r1_by_q2 * c2 - r1 * s2_) + r4_by_q2) - s6_r3_by_q2
        - r3_s6_by_q2 - r8_by_q2_part_;
    // s5*r4_by_q2; used 2 times
    let s5_r4_by_q2 = s5 * r4_by_q2;
    // Elimination, step by step.
    // r8_by_q2 = (m2*(s5*(l1*(r1_by_q2*cos(q2) - r1*sin(q2)) + r4_by_q2) - s6*r3_by_q2 - r3*s6_by_q2 -
    //   l0*cos(q1)*(s6*r1_by_q2 + r1*s6_by_q2)) + m3*sin(q3)*(sin(q3)*(s5*(l1*(r1_by_q2*cos(q2) -
    //   r1*sin(q2)) + r4_by_q2) - s6*r3_by_q2 - r3*s6_by_q2 - l0*cos(q1)*(s6*r1_by_q2 + r1*s6_by_q2)) +
    //   cos(q3)*(l0*sin(q1)*(s6*r1_by_q2 + r1*s6_by_q2) - l1*s5*(r1*cos(q2) + r1_by_q2*sin(q2)))) +
    //   m0*(s5*r4_by_q2 - s6*r3_by_q2 - r3*s6_by_q2) + m1*(s5*r4_by_q2 - s6*r3_by_q2 - r3*s6_by_q2 -
    //   l0*cos(q1)*(s6*r1_by_q2 + r1*s6_by_q2)))/(s5*(m0 + m1 + m2 + m3*sin(q3)^2))
    let r8_by_q2 = (m2 * r8_by_q2_part_2
        + m3 * s3
            * (s3 * r8_by_q2_part_2
                + c3 * (l0 * s1 * r8_by_q2_part - l1 * s5 * (r1 * c2 + r1_by_q2 * s2_)))
        + m0 * (s5_r4_by_q2 - s6_r3_by_q2 - r3_s6_by_q2)
        + m1 * (s5_r4_by_q2 - s6_r3_by_q2 - r3_s6_by_q2 - r8_by_q2_part_))
        / (s5 * s5_part);
    // u2_dot_by_q2 = (r8*(s7_by_q2 - 2*s6*s6_by_q2/s5)/(s6^2/s5 - s7) + r8_by_q2)/(s7 - s6^2/s5)
    let u2_dot_by_q2 = (r8 * (S::int(2) * s6 * s6_by_q2 / s5 - s7_by_q2) / u2_dot_part
        + r8_by_q2) / u2_dot_part;
    // u1_dot_by_q2 = (l0*r1_by_q2*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1
    //   + m2 + m3*sin(q3)^2) + r3_by_q2 - u2'*s6_by_q2 - s6*u2_dot_by_q2)/s5
    let u1_dot_by_q2 = (l0 * r1_by_q2 * s5_part_2 / s5_part + r3_by_q2
        - u2_dot * s6_by_q2 - s6 * u2_dot_by_q2) / s5;
    // u0_dot_by_q2 = (r1_by_q2 - l1*u2'*(m2*sin(q2) + m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3))) +
    //   l1*u2_dot_by_q2*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3))) +
    //   l0*u1_dot_by_q2*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2)
    let u0_dot_by_q2 = (r1_by_q2 - l1 * u2_dot * s6_by_q2_part_
        - l1 * u2_dot_by_q2 * s6_part_ + l0 * u1_dot_by_q2 * s5_part_2) / s5_part;
    // Shared terms.
    // u2^2; used 2 times
    let u2_sq = u2 * u2;
    // u2_dot_by_q2 - u2^2; used 2 times
    let u3_dot_by_q2_part = u2_dot_by_q2 - u2_sq;
    // Elimination, step by step.
    // u3_dot_by_q2 = (u0_dot_by_q2*cos(q3) - l1*(sin(q2)*(sin(q3)*(u2_dot_by_q2 - u2^2) - u2'*cos(q3)) +
    //   cos(q2)*(u2'*sin(q3) + cos(q3)*(u2_dot_by_q2 - u2^2))) - l0*u1_dot_by_q2*(sin(q1)*sin(q3) +
    //   cos(q1)*cos(q3)))/l2
    let u3_dot_by_q2 = (u0_dot_by_q2 * c3
        - l1
            * (s2_ * (s3 * u3_dot_by_q2_part - u2_dot * c3)
                + c2 * (u2_dot * s3 + c3 * u3_dot_by_q2_part))
        - l0 * u1_dot_by_q2 * s2_part_2) / l2;
    // r1_by_q3 = -m3*(sin(q3)^2*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2)) +
    //   cos(q3)*(2*sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + cos(q3)*(l0*u1^2*cos(q1) - g +
    //   l1*u2^2*cos(q2)) + l2*u3^2))
    let r1_by_q3 = -m3
        * (s3 * s3 * r1_part_ + c3 * (S::int(2) * r1_part_3 - r1_part_2 + l2_u3_sq));
    // s2_by_q3 = m3*l0*l1*(sin(q1)*sin(q3) + cos(q1)*cos(q3))*(cos(q2)*sin(q3) - sin(q2)*cos(q3)) +
    //   m3*l0*l1*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(cos(q1)*sin(q3) - sin(q1)*cos(q3))
    let s2_by_q3 = -s2_by_q2_part - s2_by_q1_part_3;
    // Shared terms.
    // cos(q3)*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2)) - sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)); used
    //   2 times
    let r3_by_q3_part = r1_part_2 - r1_part_3;
    // Elimination, step by step.
    // r3_by_q3 = m3*l0*(cos(q1)*sin(q3) - sin(q1)*cos(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) +
    //   sin(q3)*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2))) + m3*l0*(sin(q1)*sin(q3) +
    //   cos(q1)*cos(q3))*(sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) - cos(q3)*(g - l0*u1^2*cos(q1) -
    //   l1*u2^2*cos(q2))) + l0*(m3*l2*u3^2*sin(q1)*sin(q3) + m3*l2*u3^2*cos(q1)*cos(q3))
    let r3_by_q3 = l0 * (m3 * l2 * u3 * u3 * s1 * s3 + m3 * l2 * u3 * u3 * c1 * c3)
        - r3_by_q1_part - m3 * l0 * s2_part_2 * r3_by_q3_part;
    // r4_by_q3 = m3*l1*(cos(q2)*sin(q3) - sin(q2)*cos(q3))*(cos(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) +
    //   sin(q3)*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2))) + m3*l1*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3))*(sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) - cos(q3)*(g - l0*u1^2*cos(q1) -
    //   l1*u2^2*cos(q2))) + m3*l1*(l2*u3^2*sin(q2)*sin(q3) + l2*u3^2*cos(q2)*cos(q3))
    let r4_by_q3 = m3 * l1 * (l2 * u3 * u3 * s2_ * s3 + l2 * u3 * u3 * c2 * c3)
        - r4_by_q2_part - m3 * l1 * s2_part_3 * r3_by_q3_part;
    // Shared terms.
    // 2*m0 + 2*m1 + 2*m2 + m3; used 2 times
    let s5_by_q3_part = S::int(2) * m0 + S::int(2) * m1 + S::int(2) * m2 + m3;
    // Elimination, step by step.
    // s5_by_q3 = 2*m3*l0^2*(m0^2*sin(q3)*cos(q3) - sin(q1)*(m0*cos(q1)*(m0 + m1 + m2) +
    //   sin(q3)*(sin(q1)*cos(q3)*(m2*(m2 + m3) + m0*(2*m0 + 2*m1 + 2*m2 + m3) + m1*(m1 + 2*m2 + m3)) -
    //   m0*cos(q1)*sin(q3)*(2*m0 + 2*m1 + 2*m2 + m3))))/(m0 + m1 + m2 + m3*sin(q3)^2)^2
    let s5_by_q3 = S::int(2) * m3 * l0 * l0
        * (m0 * m0 * s3 * c3
            - s1
                * (m0 * c1 * (m0 + m1 + m2)
                    + s3
                        * (s1 * c3
                            * (m2 * m2_plus_m3 + m0 * s5_by_q3_part
                                + m1 * (m1 + S::int(2) * m2 + m3))
                            - m0 * c1 * s3 * s5_by_q3_part))) / (s5_part * s5_part);
    // Shared terms.
    // m3*sin(q1)*sin(q3)^2 - m3*sin(q1)*cos(q3)^2 + 2*m3*cos(q1)*sin(q3)*cos(q3); used 3 times
    let s6_by_q3_part = m3 * s1 * s3 * s3 - m3 * s1 * c3 * c3 + S::int(2) * m3_c1_s3_c3;
    // m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) + m3*cos(q3)*(cos(q2)*sin(q3) - sin(q2)*cos(q3));
    //   used 4 times
    let s6_by_q3_part_ = s6_by_q2_part - m3 * c3 * s6_part;
    // Elimination, step by step.
    // s6_by_q3 = 2*m3*l0*l1*sin(q3)*cos(q3)*(m3*sin(q1)*sin(q3)*cos(q3) - cos(q1)*(m1 + m2 +
    //   m3*sin(q3)^2))*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2)^2 + l0*l1*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) -
    //   m2*cos(q2))*(m3*sin(q1)*sin(q3)^2 - m3*sin(q1)*cos(q3)^2 + 2*m3*cos(q1)*sin(q3)*cos(q3))/(m0 + m1 +
    //   m2 + m3*sin(q3)^2) + l0*l1*(m3*sin(q1)*sin(q3)*cos(q3) - cos(q1)*(m1 + m2 +
    //   m3*sin(q3)^2))*(m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) + m3*cos(q3)*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) + s2_by_q3
    let s6_by_q3 = l0 * l1 * s6_part_ * s6_by_q3_part / s5_part
        - S::int(2) * m3 * l0 * l1 * s3 * c3 * s5_part_2 * s6_part_ / (s5_part * s5_part)
        - l0 * l1 * s5_part_2 * s6_by_q3_part_ / s5_part + s2_by_q3;
    // s7_by_q3 = 2*m3*l1^2*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(cos(q2)*sin(q3) - sin(q2)*cos(q3)) +
    //   2*m3*l1^2*sin(q3)*cos(q3)*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))^2/(m0 + m1 +
    //   m2 + m3*sin(q3)^2)^2 + 2*l1^2*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) -
    //   m2*cos(q2))*(m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) + m3*cos(q3)*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s7_by_q3 = S::int(2) * m3 * l1 * l1 * s3 * c3 * s6_part_ * s6_part_
        / (s5_part * s5_part) - S::int(2) * s7_by_q2_part
        + S::int(2) * l1 * l1 * s6_part_ * s6_by_q3_part_ / s5_part;
    // Shared terms.
    // m3*l0*r1*sin(q3)*cos(q3)*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 +
    //   m2 + m3*sin(q3)^2)^2; used 2 times
    let r8_by_q3_part = m3 * l0 * r1 * s3 * c3 * s5_part_2 / (s5_part * s5_part);
    // l0*r1*(m3*sin(q1)*sin(q3)^2 - m3*sin(q1)*cos(q3)^2 + 2*m3*cos(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2); used 2 times
    let r8_by_q3_part_ = l0 * r1 * s6_by_q3_part / s5_part;
    // l0*r1_by_q3*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2); used 2 times
    let r8_by_q3_part_2 = l0 * r1_by_q3 * s5_part_2 / s5_part;
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
    let r8_by_q3 = S::int(2) * m3 * l1 * r1 * s3 * c3 * s6_part_ / (s5_part * s5_part)
        + l1 * r1 * s6_by_q3_part_ / s5_part - l1 * r1_by_q3 * s6_part_ / s5_part
        + s6 * (S::int(2) * r8_by_q3_part - r8_by_q3_part_ - r8_by_q3_part_2 - r3_by_q3)
            / s5 + r4_by_q3 + s6 * s5_by_q3 * r8_part_ / (s5 * s5)
        - s6_by_q3 * r8_part_ / s5;
    // u2_dot_by_q3 = (r8*(s6*(s6*s5_by_q3/s5 - 2*s6_by_q3)/s5 + s7_by_q3)/(s6^2/s5 - s7) + r8_by_q3)/(s7 -
    //   s6^2/s5)
    let u2_dot_by_q3 = (r8_by_q3
        - r8 * (s6 * (s6 * s5_by_q3 / s5 - S::int(2) * s6_by_q3) / s5 + s7_by_q3)
            / u2_dot_part) / u2_dot_part;
    // u1_dot_by_q3 = s5_by_q3*(u2'*s6 - l0*r1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) - r3)/s5^2 +
    //   (2*m3*l0*r1*sin(q3)*cos(q3)*(m3*sin(q1)*sin(q3)*cos(q3) - cos(q1)*(m1 + m2 + m3*sin(q3)^2))/(m0 + m1
    //   + m2 + m3*sin(q3)^2)^2 + l0*r1*(m3*sin(q1)*sin(q3)^2 - m3*sin(q1)*cos(q3)^2 +
    //   2*m3*cos(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + l0*r1_by_q3*(cos(q1)*(m1 + m2 +
    //   m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r3_by_q3 - u2'*s6_by_q3
    //   - s6*u2_dot_by_q3)/s5
    let u1_dot_by_q3 = (r8_by_q3_part_ - S::int(2) * r8_by_q3_part + r8_by_q3_part_2
        + r3_by_q3 - u2_dot * s6_by_q3 - s6 * u2_dot_by_q3) / s5
        - s5_by_q3 * u1_dot_part / (s5 * s5);
    // u0_dot_by_q3 = (l0*u1'*(m3*sin(q1)*sin(q3)^2 - m3*sin(q1)*cos(q3)^2 + 2*m3*cos(q1)*sin(q3)*cos(q3))
    //   + l1*u2'*(m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) + m3*cos(q3)*(cos(q2)*sin(q3) -
    //   sin(q2)*cos(q3))) + r1_by_q3 + l1*u2_dot_by_q3*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3))) + l0*u1_dot_by_q3*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) -
    //   2*m3*sin(q3)*cos(q3)*(l0*u1'*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3)) +
    //   l1*u2'*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3))) + r1)/(m0 + m1 + m2 +
    //   m3*sin(q3)^2)^2
    let u0_dot_by_q3 = (l0 * u1_dot * s6_by_q3_part + l1 * u2_dot * s6_by_q3_part_
        + r1_by_q3 - l1 * u2_dot_by_q3 * s6_part_ + l0 * u1_dot_by_q3 * s5_part_2)
        / s5_part - S::int(2) * m3 * s3 * c3 * u0_dot_part / (s5_part * s5_part);
    // Shared terms.
    // u1^2 + u1_dot_by_q3; used 2 times
    let u3_dot_by_q3_part = u1_sq + u1_dot_by_q3;
    // u2^2 + u2_dot_by_q3; used 2 times
    let u3_dot_by_q3_part_ = u2_sq + u2_dot_by_q3;
    // Elimination, step by step.
    // u3_dot_by_q3 = (cos(q3)*(g - l1*(u2'*sin(q2) + cos(q2)*(u2^2 + u2_dot_by_q3)) - l0*(u1'*sin(q1) +
    //   cos(q1)*(u1^2 + u1_dot_by_q3)) + u0_dot_by_q3) - sin(q3)*(u0' + l1*(sin(q2)*(u2^2 + u2_dot_by_q3) -
    //   u2'*cos(q2)) + l0*(sin(q1)*(u1^2 + u1_dot_by_q3) - u1'*cos(q1))))/l2
    let u3_dot_by_q3 = (c3
        * (g - l1 * (u2_dot * s2_ + c2 * u3_dot_by_q3_part_)
            - l0 * (u1_dot * s1 + c1 * u3_dot_by_q3_part) + u0_dot_by_q3)
        - s3
            * (u0_dot + l1 * (s2_ * u3_dot_by_q3_part_ - u2_dot * c2)
                + l0 * (s1 * u3_dot_by_q3_part - u1_dot * c1))) / l2;
    // r1_by_u1 = -2*l0*u1*(m3*cos(q1)*sin(q3)*cos(q3) + sin(q1)*(m1 + m2 + m3*sin(q3)^2))
    let r1_by_u1 = -S::int(2) * l0 * u1 * s5_by_q1_part;
    // r3_by_u1 = 2*m3*l0*(sin(q1)*sin(q3) + cos(q1)*cos(q3))*(l0*u1*cos(q1)*sin(q3) -
    //   l0*u1*sin(q1)*cos(q3))
    let r3_by_u1 = S::int(2) * m3 * l0 * s2_part_2
        * (l0 * u1 * c1 * s3 - l0 * u1 * s1 * c3);
    // Shared terms.
    // cos(q3)*(sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) + cos(q1)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)));
    //   used 2 times
    let r4_by_u1_part = c3 * (s1 * s2_part_3 + c1 * s6_part);
    // Elimination, step by step.
    // r4_by_u1 = 2*l0*l1*u1*(m2*(sin(q1)*cos(q2) - cos(q1)*sin(q2)) + m3*(sin(q1)*cos(q2) -
    //   cos(q3)*(sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) + cos(q1)*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3)))))
    let r4_by_u1 = S::int(2) * l0 * l1 * u1
        * (s2_by_q1_part_ + m3 * (s1_c2 - r4_by_u1_part));
    // Shared terms.
    // l0*r1_by_u1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2); used 2 times
    let r8_by_u1_part = l0 * r1_by_u1 * s5_part_2 / s5_part;
    // Elimination, step by step.
    // r8_by_u1 = l1*r1_by_u1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) - s6*(l0*r1_by_u1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0
    //   + m1 + m2 + m3*sin(q3)^2) + r3_by_u1)/s5 + r4_by_u1
    let r8_by_u1 = r4_by_u1 - l1 * r1_by_u1 * s6_part_ / s5_part
        - s6 * (r8_by_u1_part + r3_by_u1) / s5;
    // u1_dot_by_u1 = (l0*r1_by_u1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1
    //   + m2 + m3*sin(q3)^2) + r3_by_u1 + s6*r8_by_u1/(s6^2/s5 - s7))/s5
    let u1_dot_by_u1 = (r8_by_u1_part + r3_by_u1 - s6 * r8_by_u1 / u2_dot_part) / s5;
    // u0_dot_by_u1 = (r1_by_u1 + l1*r8_by_u1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3)))/(s7 - s6^2/s5) + l0*u1_dot_by_u1*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let u0_dot_by_u1 = (r1_by_u1 - l1 * r8_by_u1 * s6_part_ / u2_dot_part
        + l0 * u1_dot_by_u1 * s5_part_2) / s5_part;
    // u3_dot_by_u1 = (l1*r8_by_u1*(sin(q2)*sin(q3) + cos(q2)*cos(q3))/(s6^2/s5 - s7) +
    //   l0*(2*u1*(sin(q1)*cos(q3) - cos(q1)*sin(q3)) - u1_dot_by_u1*(sin(q1)*sin(q3) + cos(q1)*cos(q3))) +
    //   u0_dot_by_u1*cos(q3))/l2
    let u3_dot_by_u1 = (l0 * (S::int(2) * u1 * s2_by_q1_part - u1_dot_by_u1 * s2_part_2)
        - l1 * r8_by_u1 * s2_part_3 / u2_dot_part + u0_dot_by_u1 * c3) / l2;
    // r1_by_u2 = -2*l1*u2*(m2*sin(q2) + m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)))
    let r1_by_u2 = -S::int(2) * l1 * u2 * s6_by_q2_part_;
    // r3_by_u2 = -2*l0*l1*u2*(m2*(sin(q1)*cos(q2) - cos(q1)*sin(q2)) +
    //   m3*(cos(q3)*(sin(q1)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)) + cos(q1)*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3))) - cos(q1)*sin(q2)))
    let r3_by_u2 = -S::int(2) * l0 * l1 * u2
        * (s2_by_q1_part_ + m3 * (r4_by_u1_part - c1_s2_));
    // r4_by_u2 = 2*m3*l1*(sin(q2)*sin(q3) + cos(q2)*cos(q3))*(l1*u2*cos(q2)*sin(q3) -
    //   l1*u2*sin(q2)*cos(q3))
    let r4_by_u2 = S::int(2) * m3 * l1 * s2_part_3
        * (l1 * u2 * c2 * s3 - l1 * u2 * s2_ * c3);
    // Shared terms.
    // l0*r1_by_u2*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2); used 2 times
    let r8_by_u2_part = l0 * r1_by_u2 * s5_part_2 / s5_part;
    // Elimination, step by step.
    // r8_by_u2 = l1*r1_by_u2*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) - s6*(l0*r1_by_u2*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0
    //   + m1 + m2 + m3*sin(q3)^2) + r3_by_u2)/s5 + r4_by_u2
    let r8_by_u2 = r4_by_u2 - l1 * r1_by_u2 * s6_part_ / s5_part
        - s6 * (r8_by_u2_part + r3_by_u2) / s5;
    // u1_dot_by_u2 = (l0*r1_by_u2*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1
    //   + m2 + m3*sin(q3)^2) + r3_by_u2 + s6*r8_by_u2/(s6^2/s5 - s7))/s5
    let u1_dot_by_u2 = (r8_by_u2_part + r3_by_u2 - s6 * r8_by_u2 / u2_dot_part) / s5;
    // u0_dot_by_u2 = (r1_by_u2 + l1*r8_by_u2*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3)))/(s7 - s6^2/s5) + l0*u1_dot_by_u2*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let u0_dot_by_u2 = (r1_by_u2 - l1 * r8_by_u2 * s6_part_ / u2_dot_part
        + l0 * u1_dot_by_u2 * s5_part_2) / s5_part;
    // u3_dot_by_u2 = (l1*(2*u2*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) + r8_by_u2*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3))/(s6^2/s5 - s7)) - l0*u1_dot_by_u2*(sin(q1)*sin(q3) + cos(q1)*cos(q3)) +
    //   u0_dot_by_u2*cos(q3))/l2
    let u3_dot_by_u2 = (l1
        * (S::int(2) * u2 * s6_part - r8_by_u2 * s2_part_3 / u2_dot_part)
        - l0 * u1_dot_by_u2 * s2_part_2 + u0_dot_by_u2 * c3) / l2;
    // r1_by_u3 = -2*m3*l2*u3*sin(q3)
    let r1_by_u3 = -S::int(2) * m3 * l2 * u3 * s3;
    // r3_by_u3 = 2*m3*l0*l2*u3*(cos(q1)*sin(q3) - sin(q1)*cos(q3))
    let r3_by_u3 = -S::int(2) * m3 * l0 * l2 * u3 * s2_by_q1_part;
    // r4_by_u3 = 2*m3*l1*l2*u3*(cos(q2)*sin(q3) - sin(q2)*cos(q3))
    let r4_by_u3 = -S::int(2) * m3 * l1 * l2 * u3 * s6_part;
    // Shared terms.
    // l0*r1_by_u3*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2); used 2 times
    let r8_by_u3_part = l0 * r1_by_u3 * s5_part_2 / s5_part;
    // Elimination, step by step.
    // r8_by_u3 = l1*r1_by_u3*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) - s6*(l0*r1_by_u3*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0
    //   + m1 + m2 + m3*sin(q3)^2) + r3_by_u3)/s5 + r4_by_u3
    let r8_by_u3 = r4_by_u3 - l1 * r1_by_u3 * s6_part_ / s5_part
        - s6 * (r8_by_u3_part + r3_by_u3) / s5;
    // u1_dot_by_u3 = (l0*r1_by_u3*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) - m3*sin(q1)*sin(q3)*cos(q3))/(m0 + m1
    //   + m2 + m3*sin(q3)^2) + r3_by_u3 + s6*r8_by_u3/(s6^2/s5 - s7))/s5
    let u1_dot_by_u3 = (r8_by_u3_part + r3_by_u3 - s6 * r8_by_u3 / u2_dot_part) / s5;
    // u0_dot_by_u3 = (r1_by_u3 + l1*r8_by_u3*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3)))/(s7 - s6^2/s5) + l0*u1_dot_by_u3*(cos(q1)*(m1 + m2 + m3*sin(q3)^2) -
    //   m3*sin(q1)*sin(q3)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let u0_dot_by_u3 = (r1_by_u3 - l1 * r8_by_u3 * s6_part_ / u2_dot_part
        + l0 * u1_dot_by_u3 * s5_part_2) / s5_part;
    // u3_dot_by_u3 = -(sin(q3)*(l1*r8_by_u3*sin(q2)/(s7 - s6^2/s5) + l0*u1_dot_by_u3*sin(q1)) +
    //   cos(q3)*(l1*r8_by_u3*cos(q2)/(s7 - s6^2/s5) + l0*u1_dot_by_u3*cos(q1) - u0_dot_by_u3))/l2
    let u3_dot_by_u3 = -(s3
        * (l1 * r8_by_u3 * s2_ / u2_dot_part + l0 * u1_dot_by_u3 * s1)
        + c3
            * (l1 * r8_by_u3 * c2 / u2_dot_part + l0 * u1_dot_by_u3 * c1 - u0_dot_by_u3))
        / l2;
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
    let u2_dot_by_u1_value = r8_by_u1 / u2_dot_part;
    // d(u2')/d(u2) = r8_by_u2/(s7 - s6^2/s5)
    let u2_dot_by_u2_value = r8_by_u2 / u2_dot_part;
    // d(u2')/d(u3) = r8_by_u3/(s7 - s6^2/s5)
    let u2_dot_by_u3_value = r8_by_u3 / u2_dot_part;
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
/// 63 operations, 6 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> S {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, .. } = *p;
    let [_, q1, q2, q3] = *q;
    let [u0, u1, u2, u3] = *u;
    // Sines and cosines.
    let (_, c1) = q1.sin_cos();
    let (_, c2) = q2.sin_cos();
    let (_, c3) = q3.sin_cos();
    let (_, cos_q1_minus_q2) = (q1 - q2).sin_cos();
    let (_, cos_q1_minus_q3) = (q1 - q3).sin_cos();
    let (_, cos_q2_minus_q3) = (q2 - q3).sin_cos();
    // Shared terms.
    // m1 + m2 + m3; used 2 times
    let energy_part = m1 + m2 + m3;
    // m2 + m3; used 3 times
    let m2_plus_m3 = m2 + m3;
    // Values.
    // T = u0^2*(m0 + m1 + m2 + m3)/2 + l0^2*u1^2*(m1 + m2 + m3)/2 - l0*u0*u1*cos(q1)*(m1 + m2 + m3) +
    //   l1^2*u2^2*(m2 + m3)/2 - l1*u0*u2*cos(q2)*(m2 + m3) + l0*l1*u1*u2*cos(q1 - q2)*(m2 + m3) +
    //   m3*l2^2*u3^2/2 - m3*l2*u0*u3*cos(q3) + m3*l0*l2*u1*u3*cos(q1 - q3) + m3*l1*l2*u2*u3*cos(q2 - q3)
    let energy = S::ratio(1, 2) * u0 * u0 * (m0 + m1 + m2 + m3)
        + S::ratio(1, 2) * l0 * l0 * u1 * u1 * energy_part
        - l0 * u0 * u1 * c1 * energy_part
        + S::ratio(1, 2) * l1 * l1 * u2 * u2 * m2_plus_m3
        - l1 * u0 * u2 * c2 * m2_plus_m3
        + l0 * l1 * u1 * u2 * cos_q1_minus_q2 * m2_plus_m3
        + S::ratio(1, 2) * m3 * l2 * l2 * u3 * u3 - m3 * l2 * u0 * u3 * c3
        + m3 * l0 * l2 * u1 * u3 * cos_q1_minus_q3
        + m3 * l1 * l2 * u2 * u3 * cos_q2_minus_q3;
    energy
}

/// Potential energy V of gravity.
///
/// 13 operations, 3 sines and cosines.
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
    // l1*cos(q2); used 2 times
    let l1_c2 = l1 * c2;
    // Values.
    // V = g*(m1*l0*cos(q1) + m2*(l0*cos(q1) + l1*cos(q2)) + m3*(l0*cos(q1) + l1*cos(q2) + l2*cos(q3)))
    let energy = g
        * (m1 * l0 * c1 + m2 * (l0_c1 + l1_c2) + m3 * (l0_c1 + l1_c2 + l2 * c3));
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
