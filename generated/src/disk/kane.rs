//! Thin disk sliding on a frictionless plane: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/disk/model.toml`. Do not edit; run `tripos regenerate`.
//! 5 coordinates, 5 speeds, 3 parameters. Unknowns: (u1', u2', u3', u4', u5').
//! Cost: mass_matrix 27 operations, 2 sines and cosines; forcing 56 operations, 2 sines and cosines; accelerations 60 operations, 2 sines and cosines.
//! The kinematic equations are singular where cos(q2) = 0.
//! The accelerations divide by cos(q2), by R, by 4*cos(q2)^2 - 5.

use super::Parameters;
use tripos_traits::{Scalar, System};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1, u2, u3, u4, u5.
///
/// 27 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 5],
) -> [[S; 5]; 5] {
    let Parameters { M, R, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let zero = S::int(0);
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    // M*R^2; used 2 times
    let m_r_sq = M * R * R;
    // tan(q2)
    let t2 = s2 / c2;
    // Entries that are not zero; upper triangle.
    // M11 = 5*M*R^2/4
    let m11 = S::ratio(5, 4) * m_r_sq;
    // M14 = M*R*sin(q1)*cos(q2)
    let m14 = M * R * s1 * c2;
    // M15 = -M*R*cos(q1)*cos(q2)
    let m15 = -M * R * c1 * c2;
    // M22 = M*R^2*(1 + 4*tan(q2)^2)/4
    let m22 = S::ratio(1, 4) * M * R * R * (S::int(1) + S::int(4) * t2 * t2);
    // M24 = -M*R*cos(q1)*tan(q2)
    let m24 = -M * R * c1 * t2;
    // M25 = -M*R*sin(q1)*tan(q2)
    let m25 = -M * R * s1 * t2;
    // M33 = M*R^2/2
    let m33 = S::ratio(1, 2) * m_r_sq;
    // M44 = M
    let m44 = M;
    // M55 = M
    let m55 = M;
    [
        [m11, zero, zero, m14, m15],
        [zero, m22, zero, m24, m25],
        [zero, zero, m33, zero, zero],
        [m14, m24, zero, m44, zero],
        [m15, m25, zero, zero, m55],
    ]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5').
///
/// 56 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> [S; 5] {
    let Parameters { M, R, g } = *p;
    let [q1, q2, _, _, _] = *q;
    let [u1, u2, u3, _, _] = *u;
    let zero = S::int(0);
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    // 1 + 1/cos(q2)^2; used 2 times
    let f4_part = S::int(1) + S::int(1) / (c2 * c2);
    // tan(q2)
    let t2 = s2 / c2;
    // Values.
    // f1 = -M*R*(4*g*sin(q2) + R*u2*(3*u2*tan(q2) + 2*u3))/4
    let f1 = -S::ratio(1, 4) * M * R
        * (S::int(4) * g * s2 + R * u2 * (S::int(3) * u2 * t2 + S::int(2) * u3));
    // f2 = M*R^2*u1*(u2*tan(q2)*(7 + 4*tan(q2)^2) + 2*u3)/4
    let f2 = S::ratio(1, 4) * M * R * R * u1
        * (u2 * t2 * (S::int(7) + S::int(4) * t2 * t2) + S::int(2) * u3);
    // f4 = -M*R*(u2^2*sin(q1)*tan(q2)/cos(q2) + u1*(u1*sin(q1)*sin(q2) + u2*cos(q1)*(1 + 1/cos(q2)^2)))
    let f4 = -M * R * (u2 * u2 * s1 * t2 / c2 + u1 * (u1 * s1 * s2 + u2 * c1 * f4_part));
    // f5 = M*R*(u2^2*cos(q1)*tan(q2)/cos(q2) - u1*(u2*sin(q1)*(1 + 1/cos(q2)^2) - u1*cos(q1)*sin(q2)))
    let f5 = M * R * (u2 * u2 * c1 * t2 / c2 - u1 * (u2 * s1 * f4_part - u1 * c1 * s2));
    [f1, f2, zero, f4, f5]
}

/// The accelerations (u1', u2', u3', u4', u5'), solved for when this code was generated.
///
/// 60 operations, 2 sines and cosines.
#[must_use]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> [S; 5] {
    let Parameters { R, g, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let [u1, u2, u3, _, _] = *u;
    let zero = S::int(0);
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step.
    // u1' = (sin(q2)*(4*g/R - 4*u1^2*cos(q2) - u2^2/cos(q2)) + 2*u2*u3)/(4*cos(q2)^2 - 5)
    let u1_dot = (s2 * (S::int(4) * g / R - S::int(4) * u1 * u1 * c2 - u2 * u2 / c2)
        + S::int(2) * u2 * u3) / (S::int(4) * c2 * c2 - S::int(5));
    // Shared terms.
    // tan(q2)
    let t2 = s2 / c2;
    // Elimination, step by step.
    // u2' = u1*(2*u3 - u2*tan(q2))
    let u2_dot = u1 * (S::int(2) * u3 - u2 * t2);
    // Shared terms.
    // 1 + 1/cos(q2)^2; used 2 times
    let u5_dot_part = S::int(1) + S::int(1) / (c2 * c2);
    // Elimination, step by step.
    // u5' = R*(u1'*cos(q1)*cos(q2) - u1*(u2*sin(q1)*(1 + 1/cos(q2)^2) - u1*cos(q1)*sin(q2)) +
    //   tan(q2)*(u2^2*cos(q1)/cos(q2) + u2'*sin(q1)))
    let u5_dot = R
        * (u1_dot * c1 * c2 - u1 * (u2 * s1 * u5_dot_part - u1 * c1 * s2)
            + t2 * (u2 * u2 * c1 / c2 + u2_dot * s1));
    // u4' = -R*(u1*(u1*sin(q1)*sin(q2) + u2*cos(q1)*(1 + 1/cos(q2)^2)) + u1'*sin(q1)*cos(q2) +
    //   tan(q2)*(u2^2*sin(q1)/cos(q2) - u2'*cos(q1)))
    let u4_dot = -R
        * (u1 * (u1 * s1 * s2 + u2 * c1 * u5_dot_part) + u1_dot * s1 * c2
            + t2 * (u2 * u2 * s1 / c2 - u2_dot * c1));
    [u1_dot, u2_dot, zero, u4_dot, u5_dot]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 63 operations, 2 sines and cosines.
#[must_use]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 5],
) -> ([S; 5], [S; 5]) {
    let Parameters { R, g, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let [u1, u2, u3, u4, u5] = *u;
    let zero = S::int(0);
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step.
    // u1' = (sin(q2)*(4*g/R - 4*u1^2*cos(q2) - u2^2/cos(q2)) + 2*u2*u3)/(4*cos(q2)^2 - 5)
    let u1_dot = (s2 * (S::int(4) * g / R - S::int(4) * u1 * u1 * c2 - u2 * u2 / c2)
        + S::int(2) * u2 * u3) / (S::int(4) * c2 * c2 - S::int(5));
    // Shared terms.
    // tan(q2)
    let t2 = s2 / c2;
    // u2*tan(q2); used 2 times
    let u2_c2_inv_s2 = u2 * t2;
    // Elimination, step by step.
    // u2' = u1*(2*u3 - u2*tan(q2))
    let u2_dot = u1 * (S::int(2) * u3 - u2_c2_inv_s2);
    // Shared terms.
    // 1 + 1/cos(q2)^2; used 2 times
    let u5_dot_part = S::int(1) + S::int(1) / (c2 * c2);
    // Elimination, step by step.
    // u5' = R*(u1'*cos(q1)*cos(q2) - u1*(u2*sin(q1)*(1 + 1/cos(q2)^2) - u1*cos(q1)*sin(q2)) +
    //   tan(q2)*(u2^2*cos(q1)/cos(q2) + u2'*sin(q1)))
    let u5_dot = R
        * (u1_dot * c1 * c2 - u1 * (u2 * s1 * u5_dot_part - u1 * c1 * s2)
            + t2 * (u2 * u2 * c1 / c2 + u2_dot * s1));
    // u4' = -R*(u1*(u1*sin(q1)*sin(q2) + u2*cos(q1)*(1 + 1/cos(q2)^2)) + u1'*sin(q1)*cos(q2) +
    //   tan(q2)*(u2^2*sin(q1)/cos(q2) - u2'*cos(q1)))
    let u4_dot = -R
        * (u1 * (u1 * s1 * s2 + u2 * c1 * u5_dot_part) + u1_dot * s1 * c2
            + t2 * (u2 * u2 * s1 / c2 - u2_dot * c1));
    // Values.
    // q1' = u2/cos(q2)
    let q1_dot_value = u2 / c2;
    // q2' = -u1
    let q2_dot_value = -u1;
    // q3' = u3 - u2*tan(q2)
    let q3_dot_value = u3 - u2_c2_inv_s2;
    // q4' = u4
    let q4_dot_value = u4;
    // q5' = u5
    let q5_dot_value = u5;
    (
        [q1_dot_value, q2_dot_value, q3_dot_value, q4_dot_value, q5_dot_value],
        [u1_dot, u2_dot, zero, u4_dot, u5_dot],
    )
}

/// Jacobian of the derivative by the state; columns q1, q2, q3, q4, q5, u1, u2, u3, u4, u5.
///
/// 216 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> [[S; 10]; 10] {
    let Parameters { R, g, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let [u1, u2, u3, _, _] = *u;
    let zero = S::int(0);
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    // cos(q2)^2; used 4 times
    let c2_sq = c2 * c2;
    // 4*cos(q2)^2 - 5; used 5 times
    let u1_dot_part = S::int(4) * c2_sq - S::int(5);
    // Elimination, step by step.
    // u1' = (sin(q2)*(4*g/R - 4*u1^2*cos(q2) - u2^2/cos(q2)) + 2*u2*u3)/(4*cos(q2)^2 - 5)
    let u1_dot = (s2 * (S::int(4) * g / R - S::int(4) * u1 * u1 * c2 - u2 * u2 / c2)
        + S::int(2) * u2 * u3) / u1_dot_part;
    // Shared terms.
    // tan(q2)
    let t2 = s2 / c2;
    // u2*tan(q2); used 2 times
    let u2_c2_inv_s2 = u2 * t2;
    // 2*u3 - u2*tan(q2); used 2 times
    let u2_dot_part = S::int(2) * u3 - u2_c2_inv_s2;
    // Elimination, step by step.
    // u2' = u1*(2*u3 - u2*tan(q2))
    let u2_dot = u1 * u2_dot_part;
    // Shared terms.
    // 1/cos(q2)^2; used 2 times
    let c2_inv2 = S::int(1) / (c2 * c2);
    // 1 + 1/cos(q2)^2; used 3 times
    let u5_dot_by_q1_part = S::int(1) + c2_inv2;
    // Elimination, step by step.
    // u5_dot_by_q1 = -R*(u1*(u1*sin(q1)*sin(q2) + u2*cos(q1)*(1 + 1/cos(q2)^2)) + u1'*sin(q1)*cos(q2) +
    //   tan(q2)*(u2^2*sin(q1)/cos(q2) - u2'*cos(q1)))
    let u5_dot_by_q1 = -R
        * (u1 * (u1 * s1 * s2 + u2 * c1 * u5_dot_by_q1_part) + u1_dot * s1 * c2
            + t2 * (u2 * u2 * s1 / c2 - u2_dot * c1));
    // u4_dot_by_q1 = R*(u1*(u2*sin(q1)*(1 + 1/cos(q2)^2) - u1*cos(q1)*sin(q2)) - u1'*cos(q1)*cos(q2) -
    //   tan(q2)*(u2^2*cos(q1)/cos(q2) + u2'*sin(q1)))
    let u4_dot_by_q1 = R
        * (u1 * (u2 * s1 * u5_dot_by_q1_part - u1 * c1 * s2) - u1_dot * c1 * c2
            - t2 * (u2 * u2 * c1 / c2 + u2_dot * s1));
    // u1_dot_by_q2 = (5*R*u2^2 + 4*cos(q2)^2*(g*cos(q2)*(3 - 4*cos(q2)^2) + R*(u1^2*(6*cos(q2)^2 - 5) +
    //   u2*(u2*(2*cos(q2)^2 - 3) + 4*u3*sin(q2)*cos(q2)))))/(R*cos(q2)^2*(4*cos(q2)^2 - 5)^2)
    let u1_dot_by_q2 = (S::int(5) * R * u2 * u2
        + S::int(4) * c2 * c2
            * (g * c2 * (S::int(3) - S::int(4) * c2_sq)
                + R
                    * (u1 * u1 * (S::int(6) * c2_sq - S::int(5))
                        + u2
                            * (u2 * (S::int(2) * c2_sq - S::int(3))
                                + S::int(4) * u3 * s2 * c2))))
        / (R * c2 * c2 * u1_dot_part * u1_dot_part);
    // u2_dot_by_q2 = -u1*u2/cos(q2)^2
    let u2_dot_by_q2 = -u1 * u2 / (c2 * c2);
    // Shared terms.
    // 2/cos(q2)^2 - 1; used 2 times
    let u5_dot_by_q2_part = S::int(2) * c2_inv2 - S::int(1);
    // u2'/cos(q2) + u2_dot_by_q2*sin(q2); used 2 times
    let u5_dot_by_q2_part_ = u2_dot / c2 + u2_dot_by_q2 * s2;
    // cos(q2)*(u1^2 + u1_dot_by_q2) - u1'*sin(q2); used 2 times
    let u5_dot_by_q2_part_2 = c2 * (u1 * u1 + u1_dot_by_q2) - u1_dot * s2;
    // Elimination, step by step.
    // u5_dot_by_q2 = -R*(cos(q1)*(u1'*sin(q2) - cos(q2)*(u1^2 + u1_dot_by_q2)) +
    //   (u2*(2*u1*sin(q1)*tan(q2)/cos(q2) + u2*cos(q1)*(1 - 2/cos(q2)^2)) - sin(q1)*(u2'/cos(q2) +
    //   u2_dot_by_q2*sin(q2)))/cos(q2))
    let u5_dot_by_q2 = R
        * (c1 * u5_dot_by_q2_part_2
            - (u2 * (S::int(2) * u1 * s1 * t2 / c2 - u2 * c1 * u5_dot_by_q2_part)
                - s1 * u5_dot_by_q2_part_) / c2);
    // u4_dot_by_q2 = -R*(sin(q1)*(cos(q2)*(u1^2 + u1_dot_by_q2) - u1'*sin(q2)) +
    //   (u2*(2*u1*cos(q1)*tan(q2)/cos(q2) + u2*sin(q1)*(2/cos(q2)^2 - 1)) - cos(q1)*(u2'/cos(q2) +
    //   u2_dot_by_q2*sin(q2)))/cos(q2))
    let u4_dot_by_q2 = -R
        * (s1 * u5_dot_by_q2_part_2
            + (u2 * (S::int(2) * u1 * c1 * t2 / c2 + u2 * s1 * u5_dot_by_q2_part)
                - c1 * u5_dot_by_q2_part_) / c2);
    // u1_dot_by_u1 = 8*u1*sin(q2)*cos(q2)/(5 - 4*cos(q2)^2)
    let u1_dot_by_u1 = -S::int(8) * u1 * s2 * c2 / u1_dot_part;
    // u2_dot_by_u1 = 2*u3 - u2*tan(q2)
    let u2_dot_by_u1 = u2_dot_part;
    // Shared terms.
    // u2*(1 + 1/cos(q2)^2) - u2_dot_by_u1*tan(q2); used 2 times
    let u5_dot_by_u1_part = u2 * u5_dot_by_q1_part - u2_dot_by_u1 * t2;
    // 2*u1*sin(q2) + u1_dot_by_u1*cos(q2); used 2 times
    let u5_dot_by_u1_part_ = S::int(2) * u1 * s2 + u1_dot_by_u1 * c2;
    // Elimination, step by step.
    // u5_dot_by_u1 = R*(cos(q1)*(2*u1*sin(q2) + u1_dot_by_u1*cos(q2)) - sin(q1)*(u2*(1 + 1/cos(q2)^2) -
    //   u2_dot_by_u1*tan(q2)))
    let u5_dot_by_u1 = R * (c1 * u5_dot_by_u1_part_ - s1 * u5_dot_by_u1_part);
    // u4_dot_by_u1 = -R*(sin(q1)*(2*u1*sin(q2) + u1_dot_by_u1*cos(q2)) + cos(q1)*(u2*(1 + 1/cos(q2)^2) -
    //   u2_dot_by_u1*tan(q2)))
    let u4_dot_by_u1 = -R * (s1 * u5_dot_by_u1_part_ + c1 * u5_dot_by_u1_part);
    // u1_dot_by_u2 = 2*(u3 - u2*tan(q2))/(4*cos(q2)^2 - 5)
    let u1_dot_by_u2 = S::int(2) * (u3 - u2_c2_inv_s2) / u1_dot_part;
    // u2_dot_by_u2 = -u1*tan(q2)
    let u2_dot_by_u2 = -u1 * t2;
    // Shared terms.
    // u1*sin(q1); used 2 times
    let u1_s1 = u1 * s1;
    // Elimination, step by step.
    // u5_dot_by_u2 = R*(u1_dot_by_u2*cos(q1)*cos(q2) - u1*sin(q1) - ((u1*sin(q1) -
    //   2*u2*cos(q1)*sin(q2))/cos(q2) - u2_dot_by_u2*sin(q1)*sin(q2))/cos(q2))
    let u5_dot_by_u2 = R
        * (u1_dot_by_u2 * c1 * c2 - u1_s1
            - ((u1_s1 - S::int(2) * u2 * c1 * s2) / c2 - u2_dot_by_u2 * s1 * s2) / c2);
    // Shared terms.
    // u1*cos(q1); used 2 times
    let u1_c1 = u1 * c1;
    // Elimination, step by step.
    // u4_dot_by_u2 = -R*(u1*cos(q1) + u1_dot_by_u2*sin(q1)*cos(q2) + ((u1*cos(q1) +
    //   2*u2*sin(q1)*sin(q2))/cos(q2) - u2_dot_by_u2*cos(q1)*sin(q2))/cos(q2))
    let u4_dot_by_u2 = -R
        * (u1_c1 + u1_dot_by_u2 * s1 * c2
            + ((u1_c1 + S::int(2) * u2 * s1 * s2) / c2 - u2_dot_by_u2 * c1 * s2) / c2);
    // u1_dot_by_u3 = 2*u2/(4*cos(q2)^2 - 5)
    let u1_dot_by_u3 = S::int(2) * u2 / u1_dot_part;
    // u5_dot_by_u3 = R*(2*u1*sin(q1)*tan(q2) + u1_dot_by_u3*cos(q1)*cos(q2))
    let u5_dot_by_u3 = R * (S::int(2) * u1 * s1 * t2 + u1_dot_by_u3 * c1 * c2);
    // u4_dot_by_u3 = R*(2*u1*cos(q1)*tan(q2) - u1_dot_by_u3*sin(q1)*cos(q2))
    let u4_dot_by_u3 = R * (S::int(2) * u1 * c1 * t2 - u1_dot_by_u3 * s1 * c2);
    // Entries that are not zero.
    // d(q1')/d(q2) = u2*tan(q2)/cos(q2)
    let q1_dot_by_q2_value = u2 * t2 / c2;
    // d(q1')/d(u2) = 1/cos(q2)
    let q1_dot_by_u2_value = S::int(1) / c2;
    // d(q2')/d(u1) = -1
    let q2_dot_by_u1_value = -S::int(1);
    // d(q3')/d(q2) = -u2/cos(q2)^2
    let q3_dot_by_q2_value = -u2 / (c2 * c2);
    // d(q3')/d(u2) = -tan(q2)
    let q3_dot_by_u2_value = -t2;
    // d(q3')/d(u3) = 1
    let q3_dot_by_u3_value = S::int(1);
    // d(q4')/d(u4) = 1
    let q4_dot_by_u4_value = S::int(1);
    // d(q5')/d(u5) = 1
    let q5_dot_by_u5_value = S::int(1);
    // d(u2')/d(u3) = 2*u1
    let u2_dot_by_u3_value = S::int(2) * u1;
    [
        [
            zero,
            q1_dot_by_q2_value,
            zero,
            zero,
            zero,
            zero,
            q1_dot_by_u2_value,
            zero,
            zero,
            zero,
        ],
        [zero, zero, zero, zero, zero, q2_dot_by_u1_value, zero, zero, zero, zero],
        [
            zero,
            q3_dot_by_q2_value,
            zero,
            zero,
            zero,
            zero,
            q3_dot_by_u2_value,
            q3_dot_by_u3_value,
            zero,
            zero,
        ],
        [zero, zero, zero, zero, zero, zero, zero, zero, q4_dot_by_u4_value, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, q5_dot_by_u5_value],
        [
            zero,
            u1_dot_by_q2,
            zero,
            zero,
            zero,
            u1_dot_by_u1,
            u1_dot_by_u2,
            u1_dot_by_u3,
            zero,
            zero,
        ],
        [
            zero,
            u2_dot_by_q2,
            zero,
            zero,
            zero,
            u2_dot_by_u1,
            u2_dot_by_u2,
            u2_dot_by_u3_value,
            zero,
            zero,
        ],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, zero],
        [
            u4_dot_by_q1,
            u4_dot_by_q2,
            zero,
            zero,
            zero,
            u4_dot_by_u1,
            u4_dot_by_u2,
            u4_dot_by_u3,
            zero,
            zero,
        ],
        [
            u5_dot_by_q1,
            u5_dot_by_q2,
            zero,
            zero,
            zero,
            u5_dot_by_u1,
            u5_dot_by_u2,
            u5_dot_by_u3,
            zero,
            zero,
        ],
    ]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 5],
) -> [S; 5] {
    let [_, q2, _, _, _] = *q;
    let [u1, u2, u3, u4, u5] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    // tan(q2)
    let t2 = s2 / c2;
    // Values.
    // q1' = u2/cos(q2)
    let q1_dot_value = u2 / c2;
    // q2' = -u1
    let q2_dot_value = -u1;
    // q3' = u3 - u2*tan(q2)
    let q3_dot_value = u3 - u2 * t2;
    // q4' = u4
    let q4_dot_value = u4;
    // q5' = u5
    let q5_dot_value = u5;
    [q1_dot_value, q2_dot_value, q3_dot_value, q4_dot_value, q5_dot_value]
}

/// Kinetic energy T.
///
/// 54 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> S {
    let Parameters { M, R, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let [u1, u2, u3, u4, u5] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    // tan(q2)
    let t2 = s2 / c2;
    // Values.
    // T = 5*M*R^2*u1^2/8 + M*R^2*u2^2*(1 + 4*tan(q2)^2)/8 + M*R^2*u3^2/4 + M*u4^2/2 +
    //   M*R*u1*u4*sin(q1)*cos(q2) - M*R*u2*u4*cos(q1)*tan(q2) + M*u5^2/2 - M*R*u1*u5*cos(q1)*cos(q2) -
    //   M*R*u2*u5*sin(q1)*tan(q2)
    let energy = S::ratio(5, 8) * M * R * R * u1 * u1
        + S::ratio(1, 8) * M * R * R * u2 * u2 * (S::int(1) + S::int(4) * t2 * t2)
        + S::ratio(1, 4) * M * R * R * u3 * u3 + S::ratio(1, 2) * M * u4 * u4
        + M * R * u1 * u4 * s1 * c2 - M * R * u2 * u4 * c1 * t2
        + S::ratio(1, 2) * M * u5 * u5 - M * R * u1 * u5 * c1 * c2
        - M * R * u2 * u5 * s1 * t2;
    energy
}

/// Potential energy V of gravity.
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5]) -> S {
    let Parameters { M, R, g } = *p;
    let [_, q2, _, _, _] = *q;
    // Sines and cosines.
    let (_, c2) = q2.sin_cos();
    // Values.
    // V = M*R*g*(cos(q2) - 1)
    let energy = M * R * g * (c2 - S::int(1));
    energy
}

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn parameters(&self) -> usize {
        3
    }
    fn coordinates(&self) -> usize {
        5
    }
    fn speeds(&self) -> usize {
        5
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
