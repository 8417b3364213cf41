//! Three-link pendulum on a cart: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/cart_pendulum_3/model.toml`. Do not edit; run `tripos regenerate`.
//! 4 coordinates, 4 speeds, 9 parameters. Unknowns: (u0', u1', u2', u3').
//! Cost: mass_matrix 33 operations, 6 sines and cosines; forcing 66 operations, 6 sines and cosines; accelerations 168 operations, 6 sines and cosines.
//! The kinematic equations are singular nowhere.
//! The accelerations divide by m0 + m1 + m2 + m3*sin(q3)^2, by s4, by s6 - s5^2/s4, by l2.

use super::Parameters;
use tripos_traits::{Scalar, System};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u0, u1, u2, u3.
///
/// 33 operations, 6 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    _u: &[S; 4],
) -> [[S; 4]; 4] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, .. } = *p;
    let [_, q1, q2, q3] = *q;
    // Sines and cosines.
    let (_, c1) = q1.sin_cos();
    let (_, c2) = q2.sin_cos();
    let (_, c3) = q3.sin_cos();
    // Shared terms.
    // m1 + m2 + m3; used 2 times
    let m12_part = m1 + m2 + m3;
    // m2 + m3; used 3 times
    let m2_plus_m3 = m2 + m3;
    // Sines and cosines.
    let (_, cos_q1_minus_q2) = (q1 - q2).sin_cos();
    let (_, cos_q1_minus_q3) = (q1 - q3).sin_cos();
    let (_, cos_q2_minus_q3) = (q2 - q3).sin_cos();
    // Entries that are not zero; upper triangle.
    // M11 = m0 + m1 + m2 + m3
    let m11 = m0 + m1 + m2 + m3;
    // M12 = -l0*cos(q1)*(m1 + m2 + m3)
    let m12 = -l0 * c1 * m12_part;
    // M13 = -l1*cos(q2)*(m2 + m3)
    let m13 = -l1 * c2 * m2_plus_m3;
    // M14 = -m3*l2*cos(q3)
    let m14 = -m3 * l2 * c3;
    // M22 = l0^2*(m1 + m2 + m3)
    let m22 = l0 * l0 * m12_part;
    // M23 = l0*l1*cos(q1 - q2)*(m2 + m3)
    let m23 = l0 * l1 * cos_q1_minus_q2 * m2_plus_m3;
    // M24 = m3*l0*l2*cos(q1 - q3)
    let m24 = m3 * l0 * l2 * cos_q1_minus_q3;
    // M33 = l1^2*(m2 + m3)
    let m33 = l1 * l1 * m2_plus_m3;
    // M34 = m3*l1*l2*cos(q2 - q3)
    let m34 = m3 * l1 * l2 * cos_q2_minus_q3;
    // M44 = m3*l2^2
    let m44 = m3 * l2 * l2;
    [
        [m11, m12, m13, m14],
        [m12, m22, m23, m24],
        [m13, m23, m33, m34],
        [m14, m24, m34, m44],
    ]
}

/// Right-hand side of the linear system; unknowns (u0', u1', u2', u3').
///
/// 66 operations, 6 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [S; 4] {
    let Parameters { m1, m2, m3, l0, l1, l2, g, F, .. } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, u1, u2, u3] = *u;
    // Sines and cosines.
    let (s1, _) = q1.sin_cos();
    let (s2, _) = q2.sin_cos();
    let (s3, _) = q3.sin_cos();
    let (sin_q1_minus_q2, _) = (q1 - q2).sin_cos();
    let (sin_q1_minus_q3, _) = (q1 - q3).sin_cos();
    let (sin_q2_minus_q3, _) = (q2 - q3).sin_cos();
    // Shared terms.
    // l0*u1^2*sin(q1); used 2 times
    let l0_u1_sq_s1 = l0 * u1 * u1 * s1;
    // l1*u2^2*sin(q2); used 2 times
    let l1_u2_sq_s2 = l1 * u2 * u2 * s2;
    // l1*u2^2*sin(q1 - q2); used 2 times
    let f2_part = l1 * u2 * u2 * sin_q1_minus_q2;
    // g*sin(q1); used 2 times
    let g_s1 = g * s1;
    // g*sin(q2); used 2 times
    let g_s2 = g * s2;
    // l0*u1^2*sin(q1 - q2); used 2 times
    let f3_part = l0 * u1 * u1 * sin_q1_minus_q2;
    // Values.
    // f1 = F - m1*l0*u1^2*sin(q1) - m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) - m3*(l0*u1^2*sin(q1) +
    //   l1*u2^2*sin(q2) + l2*u3^2*sin(q3))
    let f1 = F - m1 * l0 * u1 * u1 * s1 - m2 * (l0_u1_sq_s1 + l1_u2_sq_s2)
        - m3 * (l0_u1_sq_s1 + l1_u2_sq_s2 + l2 * u3 * u3 * s3);
    // f2 = l0*(m1*g*sin(q1) + m2*(g*sin(q1) - l1*u2^2*sin(q1 - q2)) + m3*(g*sin(q1) - l1*u2^2*sin(q1 - q2)
    //   - l2*u3^2*sin(q1 - q3)))
    let f2 = l0
        * (m1 * g * s1 + m2 * (g_s1 - f2_part)
            + m3 * (g_s1 - f2_part - l2 * u3 * u3 * sin_q1_minus_q3));
    // f3 = l1*(m2*(g*sin(q2) + l0*u1^2*sin(q1 - q2)) + m3*(g*sin(q2) + l0*u1^2*sin(q1 - q2) -
    //   l2*u3^2*sin(q2 - q3)))
    let f3 = l1
        * (m2 * (g_s2 + f3_part)
            + m3 * (g_s2 + f3_part - l2 * u3 * u3 * sin_q2_minus_q3));
    // f4 = m3*l2*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3))
    let f4 = m3 * l2
        * (g * s3 + l0 * u1 * u1 * sin_q1_minus_q3 + l1 * u2 * u2 * sin_q2_minus_q3);
    [f1, f2, f3, f4]
}

/// The accelerations (u0', u1', u2', u3'), solved for when this code was generated.
///
/// 168 operations, 6 sines and cosines.
#[must_use]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [S; 4] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, u1, u2, u3] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // l0*u1^2*sin(q1) + l1*u2^2*sin(q2); used 2 times
    let r1_part = l0 * u1 * u1 * s1 + l1 * u2 * u2 * s2;
    // Elimination, step by step.
    // r1 = F - m1*l0*u1^2*sin(q1) - m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) -
    //   m3*sin(q3)*(sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + cos(q3)*(l0*u1^2*cos(q1) - g +
    //   l1*u2^2*cos(q2)) + l2*u3^2)
    let r1 = F - m1 * l0 * u1 * u1 * s1 - m2 * r1_part
        - m3 * s3
            * (s3 * r1_part + c3 * (l0 * u1 * u1 * c1 - g + l1 * u2 * u2 * c2)
                + l2 * u3 * u3);
    // Shared terms.
    // q1 - q2; used 2 times
    let q1_minus_q2 = q1 - q2;
    // Sines and cosines.
    let (sin_q1_minus_q2, cos_q1_minus_q2) = q1_minus_q2.sin_cos();
    // Shared terms.
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
    // l1*u2^2*sin(q1 - q2); used 2 times
    let r2_part = l1 * u2 * u2 * sin_q1_minus_q2;
    // g*sin(q1); used 2 times
    let g_s1 = g * s1;
    // g*sin(q3); used 2 times
    let g_s3 = g * s3;
    // g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3); used 2 times
    let r2_part_ = g_s3 + l0 * u1 * u1 * sin_q1_minus_q3
        + l1 * u2 * u2 * sin_q2_minus_q3;
    // Elimination, step by step.
    // r2 = l0*(m1*g*sin(q1) + m2*(g*sin(q1) - l1*u2^2*sin(q1 - q2)) + m3*(g*sin(q1) - l1*u2^2*sin(q1 - q2)
    //   - cos(q1 - q3)*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)) - l2*u3^2*sin(q1 - q3)))
    let r2 = l0
        * (m1 * g * s1 + m2 * (g_s1 - r2_part)
            + m3
                * (g_s1 - r2_part - cos_q1_minus_q3 * r2_part_
                    - l2 * u3 * u3 * sin_q1_minus_q3));
    // Shared terms.
    // g*sin(q2); used 2 times
    let g_s2 = g * s2;
    // l0*u1^2*sin(q1 - q2); used 2 times
    let r3_part = l0 * u1 * u1 * sin_q1_minus_q2;
    // Elimination, step by step.
    // r3 = l1*(m2*(g*sin(q2) + l0*u1^2*sin(q1 - q2)) + m3*(g*sin(q2) + l0*u1^2*sin(q1 - q2) - cos(q2 -
    //   q3)*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)) - l2*u3^2*sin(q2 - q3)))
    let r3 = l1
        * (m2 * (g_s2 + r3_part)
            + m3
                * (g_s2 + r3_part - cos_q2_minus_q3 * r2_part_
                    - l2 * u3 * u3 * sin_q2_minus_q3));
    // Shared terms.
    // m0 + m1 + m2 + m3*sin(q3)^2; used 6 times
    let s4_part = m0 + m1 + m2 + m3 * s3 * s3;
    // cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3); used 4 times
    let s4_part_ = c1 * (m1 + m2 + m3) - m3 * c3 * cos_q1_minus_q3;
    // Elimination, step by step.
    // s4 = l0^2*(m1 + m2 + m3*sin(q1 - q3)^2) - l0^2*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 -
    //   q3))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s4 = l0 * l0 * (m1 + m2 + m3 * sin_q1_minus_q3 * sin_q1_minus_q3)
        - l0 * l0 * s4_part_ * s4_part_ / s4_part;
    // Shared terms.
    // m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)); used 4 times
    let s5_part = m2 * c2 + m3 * (c2 - c3 * cos_q2_minus_q3);
    // Elimination, step by step.
    // s5 = l0*l1*(m3*cos(q3)*cos(q1 - q3) - cos(q1)*(m1 + m2 + m3))*(m2*cos(q2) + m3*(cos(q2) -
    //   cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) + l0*l1*(m2*cos(q1 - q2) + m3*(cos(q1 - q2) -
    //   cos(q1 - q3)*cos(q2 - q3)))
    let s5 = l0 * l1
        * (m2 * cos_q1_minus_q2
            + m3 * (cos_q1_minus_q2 - cos_q1_minus_q3 * cos_q2_minus_q3))
        - l0 * l1 * s4_part_ * s5_part / s4_part;
    // s6 = l1^2*(m2 + m3*sin(q2 - q3)^2) - l1^2*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))^2/(m0 +
    //   m1 + m2 + m3*sin(q3)^2)
    let s6 = l1 * l1 * (m2 + m3 * sin_q2_minus_q3 * sin_q2_minus_q3)
        - l1 * l1 * s5_part * s5_part / s4_part;
    // Shared terms.
    // l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2); used 2 times
    let r7_part = l0 * r1 * s4_part_ / s4_part;
    // Elimination, step by step.
    // r7 = l1*r1*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) + r3 -
    //   s5*(l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2)/s4
    let r7 = l1 * r1 * s5_part / s4_part + r3 - s5 * (r7_part + r2) / s4;
    // u2' = r7/(s6 - s5^2/s4)
    let u2_dot = r7 / (s6 - s5 * s5 / s4);
    // u1' = (l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2 -
    //   u2'*s5)/s4
    let u1_dot = (r7_part + r2 - u2_dot * s5) / s4;
    // u0' = (l0*u1'*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3)) + l1*u2'*(m2*cos(q2) + m3*(cos(q2)
    //   - cos(q3)*cos(q2 - q3))) + r1)/(m0 + m1 + m2 + m3*sin(q3)^2)
    let u0_dot = (l0 * u1_dot * s4_part_ + l1 * u2_dot * s5_part + r1) / s4_part;
    // u3' = (g*sin(q3) + u0'*cos(q3) + l0*(u1^2*sin(q1 - q3) - u1'*cos(q1 - q3)) + l1*(u2^2*sin(q2 - q3) -
    //   u2'*cos(q2 - q3)))/l2
    let u3_dot = (g_s3 + u0_dot * c3
        + l0 * (u1 * u1 * sin_q1_minus_q3 - u1_dot * cos_q1_minus_q3)
        + l1 * (u2 * u2 * sin_q2_minus_q3 - u2_dot * cos_q2_minus_q3)) / l2;
    [u0_dot, u1_dot, u2_dot, u3_dot]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 168 operations, 6 sines and cosines.
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
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // l0*u1^2*sin(q1) + l1*u2^2*sin(q2); used 2 times
    let r1_part = l0 * u1 * u1 * s1 + l1 * u2 * u2 * s2;
    // Elimination, step by step.
    // r1 = F - m1*l0*u1^2*sin(q1) - m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) -
    //   m3*sin(q3)*(sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + cos(q3)*(l0*u1^2*cos(q1) - g +
    //   l1*u2^2*cos(q2)) + l2*u3^2)
    let r1 = F - m1 * l0 * u1 * u1 * s1 - m2 * r1_part
        - m3 * s3
            * (s3 * r1_part + c3 * (l0 * u1 * u1 * c1 - g + l1 * u2 * u2 * c2)
                + l2 * u3 * u3);
    // Shared terms.
    // q1 - q2; used 2 times
    let q1_minus_q2 = q1 - q2;
    // Sines and cosines.
    let (sin_q1_minus_q2, cos_q1_minus_q2) = q1_minus_q2.sin_cos();
    // Shared terms.
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
    // l1*u2^2*sin(q1 - q2); used 2 times
    let r2_part = l1 * u2 * u2 * sin_q1_minus_q2;
    // g*sin(q1); used 2 times
    let g_s1 = g * s1;
    // g*sin(q3); used 2 times
    let g_s3 = g * s3;
    // g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3); used 2 times
    let r2_part_ = g_s3 + l0 * u1 * u1 * sin_q1_minus_q3
        + l1 * u2 * u2 * sin_q2_minus_q3;
    // Elimination, step by step.
    // r2 = l0*(m1*g*sin(q1) + m2*(g*sin(q1) - l1*u2^2*sin(q1 - q2)) + m3*(g*sin(q1) - l1*u2^2*sin(q1 - q2)
    //   - cos(q1 - q3)*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)) - l2*u3^2*sin(q1 - q3)))
    let r2 = l0
        * (m1 * g * s1 + m2 * (g_s1 - r2_part)
            + m3
                * (g_s1 - r2_part - cos_q1_minus_q3 * r2_part_
                    - l2 * u3 * u3 * sin_q1_minus_q3));
    // Shared terms.
    // g*sin(q2); used 2 times
    let g_s2 = g * s2;
    // l0*u1^2*sin(q1 - q2); used 2 times
    let r3_part = l0 * u1 * u1 * sin_q1_minus_q2;
    // Elimination, step by step.
    // r3 = l1*(m2*(g*sin(q2) + l0*u1^2*sin(q1 - q2)) + m3*(g*sin(q2) + l0*u1^2*sin(q1 - q2) - cos(q2 -
    //   q3)*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)) - l2*u3^2*sin(q2 - q3)))
    let r3 = l1
        * (m2 * (g_s2 + r3_part)
            + m3
                * (g_s2 + r3_part - cos_q2_minus_q3 * r2_part_
                    - l2 * u3 * u3 * sin_q2_minus_q3));
    // Shared terms.
    // m0 + m1 + m2 + m3*sin(q3)^2; used 6 times
    let s4_part = m0 + m1 + m2 + m3 * s3 * s3;
    // cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3); used 4 times
    let s4_part_ = c1 * (m1 + m2 + m3) - m3 * c3 * cos_q1_minus_q3;
    // Elimination, step by step.
    // s4 = l0^2*(m1 + m2 + m3*sin(q1 - q3)^2) - l0^2*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 -
    //   q3))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s4 = l0 * l0 * (m1 + m2 + m3 * sin_q1_minus_q3 * sin_q1_minus_q3)
        - l0 * l0 * s4_part_ * s4_part_ / s4_part;
    // Shared terms.
    // m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)); used 4 times
    let s5_part = m2 * c2 + m3 * (c2 - c3 * cos_q2_minus_q3);
    // Elimination, step by step.
    // s5 = l0*l1*(m3*cos(q3)*cos(q1 - q3) - cos(q1)*(m1 + m2 + m3))*(m2*cos(q2) + m3*(cos(q2) -
    //   cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) + l0*l1*(m2*cos(q1 - q2) + m3*(cos(q1 - q2) -
    //   cos(q1 - q3)*cos(q2 - q3)))
    let s5 = l0 * l1
        * (m2 * cos_q1_minus_q2
            + m3 * (cos_q1_minus_q2 - cos_q1_minus_q3 * cos_q2_minus_q3))
        - l0 * l1 * s4_part_ * s5_part / s4_part;
    // s6 = l1^2*(m2 + m3*sin(q2 - q3)^2) - l1^2*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))^2/(m0 +
    //   m1 + m2 + m3*sin(q3)^2)
    let s6 = l1 * l1 * (m2 + m3 * sin_q2_minus_q3 * sin_q2_minus_q3)
        - l1 * l1 * s5_part * s5_part / s4_part;
    // Shared terms.
    // l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2); used 2 times
    let r7_part = l0 * r1 * s4_part_ / s4_part;
    // Elimination, step by step.
    // r7 = l1*r1*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) + r3 -
    //   s5*(l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2)/s4
    let r7 = l1 * r1 * s5_part / s4_part + r3 - s5 * (r7_part + r2) / s4;
    // u2' = r7/(s6 - s5^2/s4)
    let u2_dot = r7 / (s6 - s5 * s5 / s4);
    // u1' = (l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2 -
    //   u2'*s5)/s4
    let u1_dot = (r7_part + r2 - u2_dot * s5) / s4;
    // u0' = (l0*u1'*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3)) + l1*u2'*(m2*cos(q2) + m3*(cos(q2)
    //   - cos(q3)*cos(q2 - q3))) + r1)/(m0 + m1 + m2 + m3*sin(q3)^2)
    let u0_dot = (l0 * u1_dot * s4_part_ + l1 * u2_dot * s5_part + r1) / s4_part;
    // u3' = (g*sin(q3) + u0'*cos(q3) + l0*(u1^2*sin(q1 - q3) - u1'*cos(q1 - q3)) + l1*(u2^2*sin(q2 - q3) -
    //   u2'*cos(q2 - q3)))/l2
    let u3_dot = (g_s3 + u0_dot * c3
        + l0 * (u1 * u1 * sin_q1_minus_q3 - u1_dot * cos_q1_minus_q3)
        + l1 * (u2 * u2 * sin_q2_minus_q3 - u2_dot * cos_q2_minus_q3)) / l2;
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
/// 847 operations, 6 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [[S; 8]; 8] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, u1, u2, u3] = *u;
    let zero = S::int(0);
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // l2*u3^2; used 5 times
    let l2_u3_sq = l2 * u3 * u3;
    // l0*u1^2*sin(q1) + l1*u2^2*sin(q2); used 2 times
    let r1_part = l0 * u1 * u1 * s1 + l1 * u2 * u2 * s2;
    // g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2); used 2 times
    let r1_part_ = g - l0 * u1 * u1 * c1 - l1 * u2 * u2 * c2;
    // cos(q3)*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2)); used 2 times
    let r1_part_2 = c3 * r1_part_;
    // sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)); used 2 times
    let r1_part_3 = s3 * r1_part;
    // Elimination, step by step.
    // r1 = F - m1*l0*u1^2*sin(q1) - m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) -
    //   m3*sin(q3)*(sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + cos(q3)*(l0*u1^2*cos(q1) - g +
    //   l1*u2^2*cos(q2)) + l2*u3^2)
    let r1 = F - m1 * l0 * u1 * u1 * s1 - m2 * r1_part
        + m3 * s3 * (r1_part_2 - r1_part_3 - l2_u3_sq);
    // Shared terms.
    // q1 - q2; used 2 times
    let q1_minus_q2 = q1 - q2;
    // Sines and cosines.
    let (sin_q1_minus_q2, cos_q1_minus_q2) = q1_minus_q2.sin_cos();
    // Shared terms.
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
    // l1*u2^2*sin(q1 - q2); used 2 times
    let r2_part = l1 * u2 * u2 * sin_q1_minus_q2;
    // g*sin(q1); used 2 times
    let g_s1 = g * s1;
    // g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3); used 4 times
    let r2_part_ = g * s3 + l0 * u1 * u1 * sin_q1_minus_q3
        + l1 * u2 * u2 * sin_q2_minus_q3;
    // Elimination, step by step.
    // r2 = l0*(m1*g*sin(q1) + m2*(g*sin(q1) - l1*u2^2*sin(q1 - q2)) + m3*(g*sin(q1) - l1*u2^2*sin(q1 - q2)
    //   - cos(q1 - q3)*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)) - l2*u3^2*sin(q1 - q3)))
    let r2 = l0
        * (m1 * g * s1 + m2 * (g_s1 - r2_part)
            + m3
                * (g_s1 - r2_part - cos_q1_minus_q3 * r2_part_
                    - l2 * u3 * u3 * sin_q1_minus_q3));
    // Shared terms.
    // g*sin(q2); used 2 times
    let g_s2 = g * s2;
    // l0*u1^2*sin(q1 - q2); used 2 times
    let r3_part = l0 * u1 * u1 * sin_q1_minus_q2;
    // Elimination, step by step.
    // r3 = l1*(m2*(g*sin(q2) + l0*u1^2*sin(q1 - q2)) + m3*(g*sin(q2) + l0*u1^2*sin(q1 - q2) - cos(q2 -
    //   q3)*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)) - l2*u3^2*sin(q2 - q3)))
    let r3 = l1
        * (m2 * (g_s2 + r3_part)
            + m3
                * (g_s2 + r3_part - cos_q2_minus_q3 * r2_part_
                    - l2 * u3 * u3 * sin_q2_minus_q3));
    // Shared terms.
    // m1 + m2 + m3; used 2 times
    let s4_part = m1 + m2 + m3;
    // m3*sin(q3)^2; used 2 times
    let m3_s3_sq = m3 * s3 * s3;
    // m0 + m1 + m2 + m3*sin(q3)^2; used 41 times
    let s4_part_ = m0 + m1 + m2 + m3_s3_sq;
    // cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3); used 20 times
    let s4_part_2 = c1 * s4_part - m3 * c3 * cos_q1_minus_q3;
    // Elimination, step by step.
    // s4 = l0^2*(m1 + m2 + m3*sin(q1 - q3)^2) - l0^2*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 -
    //   q3))^2/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s4 = l0 * l0 * (m1 + m2 + m3 * sin_q1_minus_q3 * sin_q1_minus_q3)
        - l0 * l0 * s4_part_2 * s4_part_2 / s4_part_;
    // Shared terms.
    // m2*cos(q2); used 2 times
    let m2_c2 = m2 * c2;
    // m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)); used 19 times
    let s5_part = m2_c2 + m3 * (c2 - c3 * cos_q2_minus_q3);
    // m2*cos(q1 - q2) + m3*(cos(q1 - q2) - cos(q1 - q3)*cos(q2 - q3)); used 3 times
    let s5_part_ = m2 * cos_q1_minus_q2
        + m3 * (cos_q1_minus_q2 - cos_q1_minus_q3 * cos_q2_minus_q3);
    // Elimination, step by step.
    // s5 = l0*l1*(m3*cos(q3)*cos(q1 - q3) - cos(q1)*(m1 + m2 + m3))*(m2*cos(q2) + m3*(cos(q2) -
    //   cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) + l0*l1*(m2*cos(q1 - q2) + m3*(cos(q1 - q2) -
    //   cos(q1 - q3)*cos(q2 - q3)))
    let s5 = l0 * l1 * s5_part_ - l0 * l1 * s4_part_2 * s5_part / s4_part_;
    // s6 = l1^2*(m2 + m3*sin(q2 - q3)^2) - l1^2*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))^2/(m0 +
    //   m1 + m2 + m3*sin(q3)^2)
    let s6 = l1 * l1 * (m2 + m3 * sin_q2_minus_q3 * sin_q2_minus_q3)
        - l1 * l1 * s5_part * s5_part / s4_part_;
    // Shared terms.
    // l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2); used 2 times
    let r7_part = l0 * r1 * s4_part_2 / s4_part_;
    // l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2; used 5
    //   times
    let r7_part_ = r7_part + r2;
    // Elimination, step by step.
    // r7 = l1*r1*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) + r3 -
    //   s5*(l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2)/s4
    let r7 = l1 * r1 * s5_part / s4_part_ + r3 - s5 * r7_part_ / s4;
    // Shared terms.
    // s6 - s5^2/s4; used 19 times
    let u2_dot_part = s6 - s5 * s5 / s4;
    // Elimination, step by step.
    // u2' = r7/(s6 - s5^2/s4)
    let u2_dot = r7 / u2_dot_part;
    // Shared terms.
    // l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2 -
    //   u2'*s5; used 3 times
    let u1_dot_part = r7_part + r2 - u2_dot * s5;
    // Elimination, step by step.
    // u1' = (l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2 -
    //   u2'*s5)/s4
    let u1_dot = u1_dot_part / s4;
    // Shared terms.
    // l0*u1'*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3)) + l1*u2'*(m2*cos(q2) + m3*(cos(q2) -
    //   cos(q3)*cos(q2 - q3))) + r1; used 2 times
    let u0_dot_part = l0 * u1_dot * s4_part_2 + l1 * u2_dot * s5_part + r1;
    // Elimination, step by step.
    // u0' = (l0*u1'*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3)) + l1*u2'*(m2*cos(q2) + m3*(cos(q2)
    //   - cos(q3)*cos(q2 - q3))) + r1)/(m0 + m1 + m2 + m3*sin(q3)^2)
    let u0_dot = u0_dot_part / s4_part_;
    // Shared terms.
    // m1 + m2 + m3*sin(q3)^2; used 2 times
    let r1_by_q1_part = m1 + m2 + m3_s3_sq;
    // Elimination, step by step.
    // r1_by_q1 = l0*u1^2*(m3*sin(q1)*sin(q3)*cos(q3) - cos(q1)*(m1 + m2 + m3*sin(q3)^2))
    let r1_by_q1 = l0 * u1 * u1 * (m3 * s1 * s3 * c3 - c1 * r1_by_q1_part);
    // Shared terms.
    // l1*u2^2*cos(q1 - q2); used 2 times
    let r2_by_q1_part = l1 * u2 * u2 * cos_q1_minus_q2;
    // g*cos(q1); used 2 times
    let g_c1 = g * c1;
    // l0*u1^2*cos(q1 - q3); used 2 times
    let r2_by_q1_part_ = l0 * u1 * u1 * cos_q1_minus_q3;
    // sin(q1 - q3)*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)); used 2 times
    let r2_by_q1_part_2 = sin_q1_minus_q3 * r2_part_;
    // Elimination, step by step.
    // r2_by_q1 = l0*(m1*g*cos(q1) + m2*(g*cos(q1) - l1*u2^2*cos(q1 - q2)) + m3*(g*cos(q1) - l1*u2^2*cos(q1
    //   - q2) + sin(q1 - q3)*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)) - cos(q1 -
    //   q3)*(l0*u1^2*cos(q1 - q3) + l2*u3^2)))
    let r2_by_q1 = l0
        * (m1 * g * c1 + m2 * (g_c1 - r2_by_q1_part)
            + m3
                * (g_c1 - r2_by_q1_part + r2_by_q1_part_2
                    - cos_q1_minus_q3 * (r2_by_q1_part_ + l2_u3_sq)));
    // r3_by_q1 = l0*l1*u1^2*(m2*cos(q1 - q2) + m3*(cos(q1 - q2) - cos(q1 - q3)*cos(q2 - q3)))
    let r3_by_q1 = l0 * l1 * u1 * u1 * s5_part_;
    // Shared terms.
    // 2*cos(q3)^2 - 1; used 2 times
    let s4_by_q1_part = S::int(2) * c3 * c3 - S::int(1);
    // m0*(2*cos(q3)^2 - 1); used 2 times
    let s4_by_q1_part_ = m0 * s4_by_q1_part;
    // Elimination, step by step.
    // s4_by_q1 = 2*l0^2*(m0*m3*sin(q3)*cos(q3) - cos(q1)*(2*m0*m3*cos(q1)*sin(q3)*cos(q3) - sin(q1)*(m2^2
    //   + m1*(m1 + 2*m2) + m3*(m1 + m2 + m0*(2*cos(q3)^2 - 1)))))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s4_by_q1 = S::int(2) * l0 * l0
        * (m0 * m3 * s3 * c3
            - c1
                * (S::int(2) * m0 * m3 * c1 * s3 * c3
                    - s1
                        * (m2 * m2 + m1 * (m1 + S::int(2) * m2)
                            + m3 * (m1 + m2 + s4_by_q1_part_)))) / s4_part_;
    // Shared terms.
    // m3*sin(q1 - q3)*cos(q3); used 2 times
    let s5_by_q1_part = m3 * sin_q1_minus_q3 * c3;
    // sin(q1)*(m1 + m2 + m3) - m3*sin(q1 - q3)*cos(q3); used 2 times
    let s5_by_q1_part_ = s1 * s4_part - s5_by_q1_part;
    // sin(q1 - q3)*cos(q2 - q3); used 2 times
    let s5_by_q1_part_2 = sin_q1_minus_q3 * cos_q2_minus_q3;
    // m2*sin(q1 - q2); used 2 times
    let m2_sin_q1_minus_q2 = m2 * sin_q1_minus_q2;
    // m2*sin(q1 - q2) + m3*(sin(q1 - q2) - sin(q1 - q3)*cos(q2 - q3)); used 2 times
    let s5_by_q1_part_3 = m2_sin_q1_minus_q2 + m3 * (sin_q1_minus_q2 - s5_by_q1_part_2);
    // Elimination, step by step.
    // s5_by_q1 = l0*l1*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))*(sin(q1)*(m1 + m2 + m3) -
    //   m3*sin(q1 - q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) - l0*l1*(m2*sin(q1 - q2) + m3*(sin(q1 - q2) -
    //   sin(q1 - q3)*cos(q2 - q3)))
    let s5_by_q1 = l0 * l1 * s5_part * s5_by_q1_part_ / s4_part_
        - l0 * l1 * s5_by_q1_part_3;
    // Shared terms.
    // l0*r1*(sin(q1)*(m1 + m2 + m3) - m3*sin(q1 - q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2); used 2 times
    let r7_by_q1_part = l0 * r1 * s5_by_q1_part_ / s4_part_;
    // l0*r1_by_q1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2); used 2
    //   times
    let r7_by_q1_part_ = l0 * r1_by_q1 * s4_part_2 / s4_part_;
    // Elimination, step by step.
    // r7_by_q1 = l1*r1_by_q1*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) - s5*(l0*r1*(m3*sin(q1 - q3)*cos(q3) - sin(q1)*(m1 + m2 + m3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + l0*r1_by_q1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r2_by_q1)/s4 + r3_by_q1 + s5*s4_by_q1*(l0*r1*(cos(q1)*(m1 + m2 + m3) -
    //   m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2)/s4^2 - s5_by_q1*(l0*r1*(cos(q1)*(m1 +
    //   m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2)/s4
    let r7_by_q1 = l1 * r1_by_q1 * s5_part / s4_part_
        + s5 * (r7_by_q1_part - r7_by_q1_part_ - r2_by_q1) / s4 + r3_by_q1
        + s5 * s4_by_q1 * r7_part_ / (s4 * s4) - s5_by_q1 * r7_part_ / s4;
    // u2_dot_by_q1 = (s5*r7*(2*s5_by_q1 - s5*s4_by_q1/s4)/(s4*(s6 - s5^2/s4)) + r7_by_q1)/(s6 - s5^2/s4)
    let u2_dot_by_q1 = (s5 * r7 * (S::int(2) * s5_by_q1 - s5 * s4_by_q1 / s4)
        / (s4 * u2_dot_part) + r7_by_q1) / u2_dot_part;
    // u1_dot_by_q1 = s4_by_q1*(u2'*s5 - l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1
    //   + m2 + m3*sin(q3)^2) - r2)/s4^2 + (l0*r1*(m3*sin(q1 - q3)*cos(q3) - sin(q1)*(m1 + m2 + m3))/(m0 + m1
    //   + m2 + m3*sin(q3)^2) + l0*r1_by_q1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2
    //   + m3*sin(q3)^2) + r2_by_q1 - u2'*s5_by_q1 - s5*u2_dot_by_q1)/s4
    let u1_dot_by_q1 = (r7_by_q1_part_ - r7_by_q1_part + r2_by_q1 - u2_dot * s5_by_q1
        - s5 * u2_dot_by_q1) / s4 - s4_by_q1 * u1_dot_part / (s4 * s4);
    // Shared terms.
    // sin(q2)*cos(q3) - cos(q2)*sin(q3); used 2 times
    let u0_dot_by_q1_part = s2 * c3 - c2 * s3;
    // m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2); used 2 times
    let u0_dot_by_q1_part_ = m3 * s3 * u0_dot_by_q1_part - m2_c2;
    // sin(q1)*cos(q3) - cos(q1)*sin(q3); used 2 times
    let u0_dot_by_q1_part_2 = s1 * c3 - c1 * s3;
    // u1'*sin(q1) - u1_dot_by_q1*cos(q1); used 2 times
    let u0_dot_by_q1_part_3 = u1_dot * s1 - u1_dot_by_q1 * c1;
    // Elimination, step by step.
    // u0_dot_by_q1 = (r1_by_q1 + l1*u2_dot_by_q1*(m2*cos(q2) - m3*sin(q3)*(sin(q2)*cos(q3) -
    //   cos(q2)*sin(q3))) - l0*(m3*sin(q3)*(u1'*(sin(q1)*sin(q3) + cos(q1)*cos(q3)) +
    //   u1_dot_by_q1*(sin(q1)*cos(q3) - cos(q1)*sin(q3))) + m1*(u1'*sin(q1) - u1_dot_by_q1*cos(q1)) +
    //   m2*(u1'*sin(q1) - u1_dot_by_q1*cos(q1))))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let u0_dot_by_q1 = (r1_by_q1 - l1 * u2_dot_by_q1 * u0_dot_by_q1_part_
        - l0
            * (m3 * s3
                * (u1_dot * (s1 * s3 + c1 * c3) + u1_dot_by_q1 * u0_dot_by_q1_part_2)
                + m1 * u0_dot_by_q1_part_3 + m2 * u0_dot_by_q1_part_3)) / s4_part_;
    // Shared terms.
    // u1'*sin(q1 - q3); used 2 times
    let u3_dot_by_q1_part = u1_dot * sin_q1_minus_q3;
    // u1^2; used 2 times
    let u1_sq = u1 * u1;
    // Elimination, step by step.
    // u3_dot_by_q1 = (l0*(u1'*sin(q1 - q3) + cos(q1 - q3)*(u1^2 - u1_dot_by_q1)) - l1*u2_dot_by_q1*cos(q2
    //   - q3) + u0_dot_by_q1*cos(q3))/l2
    let u3_dot_by_q1 = (l0
        * (u3_dot_by_q1_part + cos_q1_minus_q3 * (u1_sq - u1_dot_by_q1))
        - l1 * u2_dot_by_q1 * cos_q2_minus_q3 + u0_dot_by_q1 * c3) / l2;
    // r1_by_q2 = l1*u2^2*(m3*sin(q3)*(sin(q2)*cos(q3) - cos(q2)*sin(q3)) - m2*cos(q2))
    let r1_by_q2 = l1 * u2 * u2 * u0_dot_by_q1_part_;
    // r2_by_q2 = l0*l1*u2^2*(m2*cos(q1 - q2) + m3*(cos(q1 - q2) - cos(q1 - q3)*cos(q2 - q3)))
    let r2_by_q2 = l0 * l1 * u2 * u2 * s5_part_;
    // Shared terms.
    // l0*u1^2*cos(q1 - q2); used 2 times
    let r3_by_q2_part = l0 * u1 * u1 * cos_q1_minus_q2;
    // l1*u2^2*cos(q2 - q3); used 2 times
    let r3_by_q2_part_ = l1 * u2 * u2 * cos_q2_minus_q3;
    // g*cos(q2); used 2 times
    let g_c2 = g * c2;
    // sin(q2 - q3)*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)); used 2 times
    let r3_by_q2_part_2 = sin_q2_minus_q3 * r2_part_;
    // Elimination, step by step.
    // r3_by_q2 = -l1*(m2*(l0*u1^2*cos(q1 - q2) - g*cos(q2)) + m3*(l0*u1^2*cos(q1 - q2) - g*cos(q2) -
    //   sin(q2 - q3)*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)) + cos(q2 -
    //   q3)*(l1*u2^2*cos(q2 - q3) + l2*u3^2)))
    let r3_by_q2 = -l1
        * (m2 * (r3_by_q2_part - g_c2)
            + m3
                * (r3_by_q2_part - g_c2 - r3_by_q2_part_2
                    + cos_q2_minus_q3 * (r3_by_q2_part_ + l2_u3_sq)));
    // Shared terms.
    // m2*sin(q2); used 2 times
    let m2_s2 = m2 * s2;
    // sin(q2 - q3)*cos(q3); used 2 times
    let c3_sin_q2_minus_q3 = sin_q2_minus_q3 * c3;
    // sin(q2 - q3)*cos(q1 - q3); used 2 times
    let s5_by_q2_part = sin_q2_minus_q3 * cos_q1_minus_q3;
    // m2*sin(q1 - q2) + m3*(sin(q1 - q2) + sin(q2 - q3)*cos(q1 - q3)); used 2 times
    let s5_by_q2_part_ = m2_sin_q1_minus_q2 + m3 * (sin_q1_minus_q2 + s5_by_q2_part);
    // Elimination, step by step.
    // s5_by_q2 = l0*l1*(m2*sin(q1 - q2) + m3*(sin(q1 - q2) + sin(q2 - q3)*cos(q1 - q3))) +
    //   l0*l1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))*(m2*sin(q2) + m3*(sin(q2) - sin(q2 -
    //   q3)*cos(q3)))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s5_by_q2 = l0 * l1 * s5_by_q2_part_
        + l0 * l1 * s4_part_2 * (m2_s2 + m3 * (s2 - c3_sin_q2_minus_q3)) / s4_part_;
    // Shared terms.
    // m0 + m1; used 2 times
    let m0_plus_m1 = m0 + m1;
    // Elimination, step by step.
    // s6_by_q2 = 2*l1^2*(m2^2*sin(q2)*cos(q2) + m3*(sin(q3)*cos(q3)*(m0 + m1) + cos(q2)*(sin(q2)*(m2 +
    //   m0*(2*cos(q3)^2 - 1) + m1*(2*cos(q3)^2 - 1)) - 2*cos(q2)*sin(q3)*cos(q3)*(m0 + m1))))/(m0 + m1 + m2
    //   + m3*sin(q3)^2)
    let s6_by_q2 = S::int(2) * l1 * l1
        * (m2 * m2 * s2 * c2
            + m3
                * (s3 * c3 * m0_plus_m1
                    + c2
                        * (s2 * (m2 + s4_by_q1_part_ + m1 * s4_by_q1_part)
                            - S::int(2) * c2 * s3 * c3 * m0_plus_m1))) / s4_part_;
    // Shared terms.
    // s5*r1_by_q2 + r1*s5_by_q2; used 2 times
    let r7_by_q2_part = s5 * r1_by_q2 + r1 * s5_by_q2;
    // l0*cos(q1)*(s5*r1_by_q2 + r1*s5_by_q2); used 2 times
    let r7_by_q2_part_ = l0 * c1 * r7_by_q2_part;
    // r2*s5_by_q2; used 3 times
    let r2_s5_by_q2 = r2 * s5_by_q2;
    // s5*r2_by_q2; used 3 times
    let s5_r2_by_q2 = s5 * r2_by_q2;
    // s4*(l1*(r1_by_q2*cos(q2) - r1*sin(q2)) + r3_by_q2) - s5*r2_by_q2 - r2*s5_by_q2 -
    //   l0*cos(q1)*(s5*r1_by_q2 + r1*s5_by_q2); used 2 times
    let r7_by_q2_part_2 = s4 * (l1 * (r1_by_q2 * c2 - r1 * s2) + r3_by_q2) - s5_r2_by_q2
        - r2_s5_by_q2 - r7_by_q2_part_;
    // s4*r3_by_q2; used 2 times
    let s4_r3_by_q2 = s4 * r3_by_q2;
    // Elimination, step by step.
    // r7_by_q2 = (m2*(s4*(l1*(r1_by_q2*cos(q2) - r1*sin(q2)) + r3_by_q2) - s5*r2_by_q2 - r2*s5_by_q2 -
    //   l0*cos(q1)*(s5*r1_by_q2 + r1*s5_by_q2)) + m3*sin(q3)*(sin(q3)*(s4*(l1*(r1_by_q2*cos(q2) -
    //   r1*sin(q2)) + r3_by_q2) - s5*r2_by_q2 - r2*s5_by_q2 - l0*cos(q1)*(s5*r1_by_q2 + r1*s5_by_q2)) +
    //   cos(q3)*(l0*sin(q1)*(s5*r1_by_q2 + r1*s5_by_q2) - l1*s4*(r1*cos(q2) + r1_by_q2*sin(q2)))) +
    //   m0*(s4*r3_by_q2 - s5*r2_by_q2 - r2*s5_by_q2) + m1*(s4*r3_by_q2 - s5*r2_by_q2 - r2*s5_by_q2 -
    //   l0*cos(q1)*(s5*r1_by_q2 + r1*s5_by_q2)))/(s4*(m0 + m1 + m2 + m3*sin(q3)^2))
    let r7_by_q2 = (m2 * r7_by_q2_part_2
        + m3 * s3
            * (s3 * r7_by_q2_part_2
                + c3 * (l0 * s1 * r7_by_q2_part - l1 * s4 * (r1 * c2 + r1_by_q2 * s2)))
        + m0 * (s4_r3_by_q2 - s5_r2_by_q2 - r2_s5_by_q2)
        + m1 * (s4_r3_by_q2 - s5_r2_by_q2 - r2_s5_by_q2 - r7_by_q2_part_))
        / (s4 * s4_part_);
    // u2_dot_by_q2 = (r7*(s6_by_q2 - 2*s5*s5_by_q2/s4)/(s5^2/s4 - s6) + r7_by_q2)/(s6 - s5^2/s4)
    let u2_dot_by_q2 = (r7 * (S::int(2) * s5 * s5_by_q2 / s4 - s6_by_q2) / u2_dot_part
        + r7_by_q2) / u2_dot_part;
    // u1_dot_by_q2 = (l0*r1_by_q2*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r2_by_q2 - u2'*s5_by_q2 - s5*u2_dot_by_q2)/s4
    let u1_dot_by_q2 = (l0 * r1_by_q2 * s4_part_2 / s4_part_ + r2_by_q2
        - u2_dot * s5_by_q2 - s5 * u2_dot_by_q2) / s4;
    // Shared terms.
    // sin(q2)*sin(q3) + cos(q2)*cos(q3); used 2 times
    let u0_dot_by_q2_part = s2 * s3 + c2 * c3;
    // Elimination, step by step.
    // u0_dot_by_q2 = (r1_by_q2 + m1*l0*u1_dot_by_q2*cos(q1) - m3*sin(q3)*(l1*(u2'*(sin(q2)*sin(q3) +
    //   cos(q2)*cos(q3)) + u2_dot_by_q2*(sin(q2)*cos(q3) - cos(q2)*sin(q3))) +
    //   l0*u1_dot_by_q2*(sin(q1)*cos(q3) - cos(q1)*sin(q3))) + m2*(l0*u1_dot_by_q2*cos(q1) - l1*(u2'*sin(q2)
    //   - u2_dot_by_q2*cos(q2))))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let u0_dot_by_q2 = (r1_by_q2 + m1 * l0 * u1_dot_by_q2 * c1
        - m3 * s3
            * (l1 * (u2_dot * u0_dot_by_q2_part + u2_dot_by_q2 * u0_dot_by_q1_part)
                + l0 * u1_dot_by_q2 * u0_dot_by_q1_part_2)
        + m2 * (l0 * u1_dot_by_q2 * c1 - l1 * (u2_dot * s2 - u2_dot_by_q2 * c2)))
        / s4_part_;
    // Shared terms.
    // u2'*sin(q2 - q3); used 2 times
    let u3_dot_by_q2_part = u2_dot * sin_q2_minus_q3;
    // u2^2; used 2 times
    let u2_sq = u2 * u2;
    // Elimination, step by step.
    // u3_dot_by_q2 = (l1*(u2'*sin(q2 - q3) + cos(q2 - q3)*(u2^2 - u2_dot_by_q2)) - l0*u1_dot_by_q2*cos(q1
    //   - q3) + u0_dot_by_q2*cos(q3))/l2
    let u3_dot_by_q2 = (l1
        * (u3_dot_by_q2_part + cos_q2_minus_q3 * (u2_sq - u2_dot_by_q2))
        - l0 * u1_dot_by_q2 * cos_q1_minus_q3 + u0_dot_by_q2 * c3) / l2;
    // r1_by_q3 = -m3*(sin(q3)^2*(g - l0*u1^2*cos(q1) - l1*u2^2*cos(q2)) +
    //   cos(q3)*(2*sin(q3)*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) + cos(q3)*(l0*u1^2*cos(q1) - g +
    //   l1*u2^2*cos(q2)) + l2*u3^2))
    let r1_by_q3 = -m3
        * (s3 * s3 * r1_part_ + c3 * (S::int(2) * r1_part_3 - r1_part_2 + l2_u3_sq));
    // Shared terms.
    // l0*u1^2*cos(q1 - q3) - g*cos(q3) + l1*u2^2*cos(q2 - q3) + l2*u3^2; used 2 times
    let r2_by_q3_part = r2_by_q1_part_ - g * c3 + r3_by_q2_part_ + l2_u3_sq;
    // Elimination, step by step.
    // r2_by_q3 = -m3*l0*(sin(q1 - q3)*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)) + cos(q1 -
    //   q3)*(g*cos(q3) - l0*u1^2*cos(q1 - q3) - l1*u2^2*cos(q2 - q3) - l2*u3^2))
    let r2_by_q3 = m3 * l0 * (cos_q1_minus_q3 * r2_by_q3_part - r2_by_q1_part_2);
    // r3_by_q3 = -m3*l1*(sin(q2 - q3)*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)) + cos(q2 -
    //   q3)*(g*cos(q3) - l0*u1^2*cos(q1 - q3) - l1*u2^2*cos(q2 - q3) - l2*u3^2))
    let r3_by_q3 = m3 * l1 * (cos_q2_minus_q3 * r2_by_q3_part - r3_by_q2_part_2);
    // Shared terms.
    // m3*sin(q1 - q3)*cos(q3) - m3*sin(q3)*cos(q1 - q3); used 4 times
    let s4_by_q3_part = s5_by_q1_part - m3 * s3 * cos_q1_minus_q3;
    // Elimination, step by step.
    // s4_by_q3 = 2*m3*l0^2*sin(q3)*cos(q3)*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))^2/(m0 + m1 +
    //   m2 + m3*sin(q3)^2)^2 - 2*m3*l0^2*sin(q1 - q3)*cos(q1 - q3) + 2*l0^2*(cos(q1)*(m1 + m2 + m3) -
    //   m3*cos(q3)*cos(q1 - q3))*(m3*sin(q1 - q3)*cos(q3) - m3*sin(q3)*cos(q1 - q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2)
    let s4_by_q3 = S::int(2) * m3 * l0 * l0 * s3 * c3 * s4_part_2 * s4_part_2
        / (s4_part_ * s4_part_)
        - S::int(2) * m3 * l0 * l0 * sin_q1_minus_q3 * cos_q1_minus_q3
        + S::int(2) * l0 * l0 * s4_part_2 * s4_by_q3_part / s4_part_;
    // Shared terms.
    // sin(q2 - q3)*cos(q3) - sin(q3)*cos(q2 - q3); used 4 times
    let s5_by_q3_part = c3_sin_q2_minus_q3 - s3 * cos_q2_minus_q3;
    // Elimination, step by step.
    // s5_by_q3 = 2*m3*l0*l1*sin(q3)*cos(q3)*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))*(m2*cos(q2)
    //   + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 + m3*sin(q3)^2)^2 + l0*l1*(m2*cos(q2) +
    //   m3*(cos(q2) - cos(q3)*cos(q2 - q3)))*(m3*sin(q1 - q3)*cos(q3) - m3*sin(q3)*cos(q1 - q3))/(m0 + m1 +
    //   m2 + m3*sin(q3)^2) + m3*l0*l1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))*(sin(q2 -
    //   q3)*cos(q3) - sin(q3)*cos(q2 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) - m3*l0*l1*(sin(q2 - q3)*cos(q1 -
    //   q3) + sin(q1 - q3)*cos(q2 - q3))
    let s5_by_q3 = S::int(2) * m3 * l0 * l1 * s3 * c3 * s4_part_2 * s5_part
        / (s4_part_ * s4_part_) + l0 * l1 * s5_part * s4_by_q3_part / s4_part_
        + m3 * l0 * l1 * s4_part_2 * s5_by_q3_part / s4_part_
        - m3 * l0 * l1 * (s5_by_q2_part + s5_by_q1_part_2);
    // s6_by_q3 = 2*m3*l1^2*sin(q3)*cos(q3)*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))^2/(m0 + m1 +
    //   m2 + m3*sin(q3)^2)^2 - 2*m3*l1^2*sin(q2 - q3)*cos(q2 - q3) + 2*m3*l1^2*(m2*cos(q2) + m3*(cos(q2) -
    //   cos(q3)*cos(q2 - q3)))*(sin(q2 - q3)*cos(q3) - sin(q3)*cos(q2 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2)
    let s6_by_q3 = S::int(2) * m3 * l1 * l1 * s3 * c3 * s5_part * s5_part
        / (s4_part_ * s4_part_)
        - S::int(2) * m3 * l1 * l1 * sin_q2_minus_q3 * cos_q2_minus_q3
        + S::int(2) * m3 * l1 * l1 * s5_part * s5_by_q3_part / s4_part_;
    // Shared terms.
    // m3*l0*r1*sin(q3)*cos(q3)*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2)^2; used 2 times
    let r7_by_q3_part = m3 * l0 * r1 * s3 * c3 * s4_part_2 / (s4_part_ * s4_part_);
    // l0*r1*(m3*sin(q1 - q3)*cos(q3) - m3*sin(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2); used 2
    //   times
    let r7_by_q3_part_ = l0 * r1 * s4_by_q3_part / s4_part_;
    // l0*r1_by_q3*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2); used 2
    //   times
    let r7_by_q3_part_2 = l0 * r1_by_q3 * s4_part_2 / s4_part_;
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
    let r7_by_q3 = l1 * r1_by_q3 * s5_part / s4_part_
        - S::int(2) * m3 * l1 * r1 * s3 * c3 * s5_part / (s4_part_ * s4_part_)
        - m3 * l1 * r1 * s5_by_q3_part / s4_part_
        + s5 * (S::int(2) * r7_by_q3_part - r7_by_q3_part_2 + r7_by_q3_part_ - r2_by_q3)
            / s4 + r3_by_q3 + s5 * s4_by_q3 * r7_part_ / (s4 * s4)
        - s5_by_q3 * r7_part_ / s4;
    // u2_dot_by_q3 = (r7*(s5*(s5*s4_by_q3/s4 - 2*s5_by_q3)/s4 + s6_by_q3)/(s5^2/s4 - s6) + r7_by_q3)/(s6 -
    //   s5^2/s4)
    let u2_dot_by_q3 = (r7_by_q3
        - r7 * (s5 * (s5 * s4_by_q3 / s4 - S::int(2) * s5_by_q3) / s4 + s6_by_q3)
            / u2_dot_part) / u2_dot_part;
    // u1_dot_by_q3 = s4_by_q3*(u2'*s5 - l0*r1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1
    //   + m2 + m3*sin(q3)^2) - r2)/s4^2 + (2*m3*l0*r1*sin(q3)*cos(q3)*(m3*cos(q3)*cos(q1 - q3) - cos(q1)*(m1
    //   + m2 + m3))/(m0 + m1 + m2 + m3*sin(q3)^2)^2 + l0*r1*(m3*sin(q3)*cos(q1 - q3) - m3*sin(q1 -
    //   q3)*cos(q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + l0*r1_by_q3*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1
    //   - q3))/(m0 + m1 + m2 + m3*sin(q3)^2) + r2_by_q3 - u2'*s5_by_q3 - s5*u2_dot_by_q3)/s4
    let u1_dot_by_q3 = (r7_by_q3_part_2 - S::int(2) * r7_by_q3_part - r7_by_q3_part_
        + r2_by_q3 - u2_dot * s5_by_q3 - s5 * u2_dot_by_q3) / s4
        - s4_by_q3 * u1_dot_part / (s4 * s4);
    // u0_dot_by_q3 = (l0*u1'*(m3*sin(q3)*cos(q1 - q3) - m3*sin(q1 - q3)*cos(q3)) +
    //   m3*l1*u2'*(sin(q3)*cos(q2 - q3) - sin(q2 - q3)*cos(q3)) + r1_by_q3 + l1*u2_dot_by_q3*(m2*cos(q2) +
    //   m3*(cos(q2) - cos(q3)*cos(q2 - q3))) + l0*u1_dot_by_q3*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 -
    //   q3)))/(m0 + m1 + m2 + m3*sin(q3)^2) - 2*m3*sin(q3)*cos(q3)*(l0*u1'*(cos(q1)*(m1 + m2 + m3) -
    //   m3*cos(q3)*cos(q1 - q3)) + l1*u2'*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3))) + r1)/(m0 + m1
    //   + m2 + m3*sin(q3)^2)^2
    let u0_dot_by_q3 = (r1_by_q3 - l0 * u1_dot * s4_by_q3_part
        - m3 * l1 * u2_dot * s5_by_q3_part + l1 * u2_dot_by_q3 * s5_part
        + l0 * u1_dot_by_q3 * s4_part_2) / s4_part_
        - S::int(2) * m3 * s3 * c3 * u0_dot_part / (s4_part_ * s4_part_);
    // u3_dot_by_q3 = (cos(q3)*(g + u0_dot_by_q3) - u0'*sin(q3) - l1*(u2'*sin(q2 - q3) + cos(q2 - q3)*(u2^2
    //   + u2_dot_by_q3)) - l0*(u1'*sin(q1 - q3) + cos(q1 - q3)*(u1^2 + u1_dot_by_q3)))/l2
    let u3_dot_by_q3 = (c3 * (g + u0_dot_by_q3) - u0_dot * s3
        - l1 * (u3_dot_by_q2_part + cos_q2_minus_q3 * (u2_sq + u2_dot_by_q3))
        - l0 * (u3_dot_by_q1_part + cos_q1_minus_q3 * (u1_sq + u1_dot_by_q3))) / l2;
    // r1_by_u1 = -2*l0*u1*(m3*cos(q1)*sin(q3)*cos(q3) + sin(q1)*(m1 + m2 + m3*sin(q3)^2))
    let r1_by_u1 = -S::int(2) * l0 * u1 * (m3 * c1 * s3 * c3 + s1 * r1_by_q1_part);
    // r2_by_u1 = -2*m3*l0^2*u1*sin(q1 - q3)*cos(q1 - q3)
    let r2_by_u1 = -S::int(2) * m3 * l0 * l0 * u1 * sin_q1_minus_q3 * cos_q1_minus_q3;
    // r3_by_u1 = 2*l0*l1*u1*(m2*sin(q1 - q2) + m3*(sin(q1 - q2) - sin(q1 - q3)*cos(q2 - q3)))
    let r3_by_u1 = S::int(2) * l0 * l1 * u1 * s5_by_q1_part_3;
    // Shared terms.
    // l0*r1_by_u1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2); used 2
    //   times
    let r7_by_u1_part = l0 * r1_by_u1 * s4_part_2 / s4_part_;
    // Elimination, step by step.
    // r7_by_u1 = l1*r1_by_u1*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) - s5*(l0*r1_by_u1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r2_by_u1)/s4 + r3_by_u1
    let r7_by_u1 = l1 * r1_by_u1 * s5_part / s4_part_
        - s5 * (r7_by_u1_part + r2_by_u1) / s4 + r3_by_u1;
    // u1_dot_by_u1 = (l0*r1_by_u1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r2_by_u1 + s5*r7_by_u1/(s5^2/s4 - s6))/s4
    let u1_dot_by_u1 = (r7_by_u1_part + r2_by_u1 - s5 * r7_by_u1 / u2_dot_part) / s4;
    // u0_dot_by_u1 = (r1_by_u1 + l1*r7_by_u1*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(s6 -
    //   s5^2/s4) + l0*u1_dot_by_u1*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2)
    let u0_dot_by_u1 = (r1_by_u1 + l1 * r7_by_u1 * s5_part / u2_dot_part
        + l0 * u1_dot_by_u1 * s4_part_2) / s4_part_;
    // u3_dot_by_u1 = (l1*r7_by_u1*cos(q2 - q3)/(s5^2/s4 - s6) + l0*(2*u1*sin(q1 - q3) -
    //   u1_dot_by_u1*cos(q1 - q3)) + u0_dot_by_u1*cos(q3))/l2
    let u3_dot_by_u1 = (l0
        * (S::int(2) * u1 * sin_q1_minus_q3 - u1_dot_by_u1 * cos_q1_minus_q3)
        - l1 * r7_by_u1 * cos_q2_minus_q3 / u2_dot_part + u0_dot_by_u1 * c3) / l2;
    // r1_by_u2 = -2*l1*u2*(m2*sin(q2) + m3*sin(q3)*(sin(q2)*sin(q3) + cos(q2)*cos(q3)))
    let r1_by_u2 = -S::int(2) * l1 * u2 * (m2_s2 + m3 * s3 * u0_dot_by_q2_part);
    // r2_by_u2 = -2*l0*l1*u2*(m2*sin(q1 - q2) + m3*(sin(q1 - q2) + sin(q2 - q3)*cos(q1 - q3)))
    let r2_by_u2 = -S::int(2) * l0 * l1 * u2 * s5_by_q2_part_;
    // r3_by_u2 = -2*m3*l1^2*u2*sin(q2 - q3)*cos(q2 - q3)
    let r3_by_u2 = -S::int(2) * m3 * l1 * l1 * u2 * sin_q2_minus_q3 * cos_q2_minus_q3;
    // Shared terms.
    // l0*r1_by_u2*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2); used 2
    //   times
    let r7_by_u2_part = l0 * r1_by_u2 * s4_part_2 / s4_part_;
    // Elimination, step by step.
    // r7_by_u2 = l1*r1_by_u2*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) - s5*(l0*r1_by_u2*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r2_by_u2)/s4 + r3_by_u2
    let r7_by_u2 = l1 * r1_by_u2 * s5_part / s4_part_
        - s5 * (r7_by_u2_part + r2_by_u2) / s4 + r3_by_u2;
    // u1_dot_by_u2 = (l0*r1_by_u2*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r2_by_u2 + s5*r7_by_u2/(s5^2/s4 - s6))/s4
    let u1_dot_by_u2 = (r7_by_u2_part + r2_by_u2 - s5 * r7_by_u2 / u2_dot_part) / s4;
    // u0_dot_by_u2 = (r1_by_u2 + l1*r7_by_u2*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(s6 -
    //   s5^2/s4) + l0*u1_dot_by_u2*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2)
    let u0_dot_by_u2 = (r1_by_u2 + l1 * r7_by_u2 * s5_part / u2_dot_part
        + l0 * u1_dot_by_u2 * s4_part_2) / s4_part_;
    // u3_dot_by_u2 = (l1*(2*u2*sin(q2 - q3) + r7_by_u2*cos(q2 - q3)/(s5^2/s4 - s6)) -
    //   l0*u1_dot_by_u2*cos(q1 - q3) + u0_dot_by_u2*cos(q3))/l2
    let u3_dot_by_u2 = (u0_dot_by_u2 * c3
        - l1
            * (r7_by_u2 * cos_q2_minus_q3 / u2_dot_part
                - S::int(2) * u2 * sin_q2_minus_q3)
        - l0 * u1_dot_by_u2 * cos_q1_minus_q3) / l2;
    // r1_by_u3 = -2*m3*l2*u3*sin(q3)
    let r1_by_u3 = -S::int(2) * m3 * l2 * u3 * s3;
    // r2_by_u3 = -2*m3*l0*l2*u3*sin(q1 - q3)
    let r2_by_u3 = -S::int(2) * m3 * l0 * l2 * u3 * sin_q1_minus_q3;
    // r3_by_u3 = -2*m3*l1*l2*u3*sin(q2 - q3)
    let r3_by_u3 = -S::int(2) * m3 * l1 * l2 * u3 * sin_q2_minus_q3;
    // Shared terms.
    // l0*r1_by_u3*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 + m3*sin(q3)^2); used 2
    //   times
    let r7_by_u3_part = l0 * r1_by_u3 * s4_part_2 / s4_part_;
    // Elimination, step by step.
    // r7_by_u3 = l1*r1_by_u3*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) - s5*(l0*r1_by_u3*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r2_by_u3)/s4 + r3_by_u3
    let r7_by_u3 = l1 * r1_by_u3 * s5_part / s4_part_
        - s5 * (r7_by_u3_part + r2_by_u3) / s4 + r3_by_u3;
    // u1_dot_by_u3 = (l0*r1_by_u3*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2) + r2_by_u3 + s5*r7_by_u3/(s5^2/s4 - s6))/s4
    let u1_dot_by_u3 = (r7_by_u3_part + r2_by_u3 - s5 * r7_by_u3 / u2_dot_part) / s4;
    // u0_dot_by_u3 = (r1_by_u3 + l1*r7_by_u3*(m2*cos(q2) + m3*(cos(q2) - cos(q3)*cos(q2 - q3)))/(s6 -
    //   s5^2/s4) + l0*u1_dot_by_u3*(cos(q1)*(m1 + m2 + m3) - m3*cos(q3)*cos(q1 - q3)))/(m0 + m1 + m2 +
    //   m3*sin(q3)^2)
    let u0_dot_by_u3 = (r1_by_u3 + l1 * r7_by_u3 * s5_part / u2_dot_part
        + l0 * u1_dot_by_u3 * s4_part_2) / s4_part_;
    // u3_dot_by_u3 = (u0_dot_by_u3*cos(q3) - l1*r7_by_u3*cos(q2 - q3)/(s6 - s5^2/s4) -
    //   l0*u1_dot_by_u3*cos(q1 - q3))/l2
    let u3_dot_by_u3 = (u0_dot_by_u3 * c3 - l1 * r7_by_u3 * cos_q2_minus_q3 / u2_dot_part
        - l0 * u1_dot_by_u3 * cos_q1_minus_q3) / l2;
    // Entries that are not zero.
    // d(q0')/d(u0) = 1
    let q0_dot_by_u0_value = S::int(1);
    // d(q1')/d(u1) = 1
    let q1_dot_by_u1_value = S::int(1);
    // d(q2')/d(u2) = 1
    let q2_dot_by_u2_value = S::int(1);
    // d(q3')/d(u3) = 1
    let q3_dot_by_u3_value = S::int(1);
    // d(u2')/d(u1) = r7_by_u1/(s6 - s5^2/s4)
    let u2_dot_by_u1_value = r7_by_u1 / u2_dot_part;
    // d(u2')/d(u2) = r7_by_u2/(s6 - s5^2/s4)
    let u2_dot_by_u2_value = r7_by_u2 / u2_dot_part;
    // d(u2')/d(u3) = r7_by_u3/(s6 - s5^2/s4)
    let u2_dot_by_u3_value = r7_by_u3 / u2_dot_part;
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
    // Shared terms.
    // m1 + m2 + m3; used 2 times
    let energy_part = m1 + m2 + m3;
    // m2 + m3; used 3 times
    let m2_plus_m3 = m2 + m3;
    // Sines and cosines.
    let (_, cos_q1_minus_q2) = (q1 - q2).sin_cos();
    let (_, cos_q1_minus_q3) = (q1 - q3).sin_cos();
    let (_, cos_q2_minus_q3) = (q2 - q3).sin_cos();
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

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
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
