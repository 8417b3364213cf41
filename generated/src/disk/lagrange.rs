//! Thin disk sliding on a frictionless plane: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/disk/model.toml`. Do not edit; run `tripos regenerate`.
//! 5 coordinates, 5 speeds, 3 parameters. Unknowns: (q1'', q2'', q3'', q4'', q5'').
//! Cost: mass_matrix 30 operations, 2 sines and cosines; forcing 56 operations, 2 sines and cosines; accelerations 54 operations, 2 sines and cosines.
//! The kinematic equations are singular where cos(q2) = 0.
//! The accelerations divide by cos(q2), by R, by 4*cos(q2)^2 - 5.

use super::Parameters;
use tripos_traits::{Scalar, System};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows q1, q2, q3, q4, q5.
///
/// 30 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _q_dot: &[S; 5],
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
    // Entries that are not zero; upper triangle.
    // M11 = M*R^2*(6 - 5*cos(q2)^2)/4
    let m11 = S::ratio(1, 4) * M * R * R * (S::int(6) - S::int(5) * c2 * c2);
    // M13 = M*R^2*sin(q2)/2
    let m13 = S::ratio(1, 2) * M * R * R * s2;
    // M14 = -M*R*cos(q1)*sin(q2)
    let m14 = -M * R * c1 * s2;
    // M15 = -M*R*sin(q1)*sin(q2)
    let m15 = -M * R * s1 * s2;
    // M22 = 5*M*R^2/4
    let m22 = S::ratio(5, 4) * m_r_sq;
    // M24 = -M*R*sin(q1)*cos(q2)
    let m24 = -M * R * s1 * c2;
    // M25 = M*R*cos(q1)*cos(q2)
    let m25 = M * R * c1 * c2;
    // M33 = M*R^2/2
    let m33 = S::ratio(1, 2) * m_r_sq;
    // M44 = M
    let m44 = M;
    // M55 = M
    let m55 = M;
    [
        [m11, zero, m13, m14, m15],
        [zero, m22, zero, m24, m25],
        [m13, zero, m33, zero, zero],
        [m14, m24, zero, m44, zero],
        [m15, m25, zero, zero, m55],
    ]
}

/// Right-hand side of the linear system; unknowns (q1'', q2'', q3'', q4'', q5'').
///
/// 56 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> [S; 5] {
    let Parameters { M, R, g } = *p;
    let [q1, q2, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, _, _] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    // q1'*sin(q2); used 2 times
    let q1_dot_s2 = q1_dot * s2;
    // Values.
    // f1 = -M*R^2*q2'*cos(q2)*(5*q1'*sin(q2) + q3')/2
    let f1 = -S::ratio(1, 2) * M * R * R * q2_dot * c2
        * (S::int(5) * q1_dot_s2 + q3_dot);
    // f2 = M*R*(4*g*sin(q2) + R*q1'*cos(q2)*(5*q1'*sin(q2) + 2*q3'))/4
    let f2 = S::ratio(1, 4) * M * R
        * (S::int(4) * g * s2
            + R * q1_dot * c2 * (S::int(5) * q1_dot_s2 + S::int(2) * q3_dot));
    // f3 = -M*R^2*q1'*q2'*cos(q2)/2
    let f3 = -S::ratio(1, 2) * M * R * R * q1_dot * q2_dot * c2;
    // f4 = -M*R*(q2'^2*sin(q1)*sin(q2) + q1'*(q1'*sin(q1)*sin(q2) - 2*q2'*cos(q1)*cos(q2)))
    let f4 = -M * R
        * (q2_dot * q2_dot * s1 * s2
            + q1_dot * (q1_dot * s1 * s2 - S::int(2) * q2_dot * c1 * c2));
    // f5 = M*R*(q2'^2*cos(q1)*sin(q2) + q1'*(q1'*cos(q1)*sin(q2) + 2*q2'*sin(q1)*cos(q2)))
    let f5 = M * R
        * (q2_dot * q2_dot * c1 * s2
            + q1_dot * (q1_dot * c1 * s2 + S::int(2) * q2_dot * s1 * c2));
    [f1, f2, f3, f4, f5]
}

/// The accelerations (q1'', q2'', q3'', q4'', q5''), solved for when this code was generated.
///
/// 54 operations, 2 sines and cosines.
#[must_use]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 5] {
    let Parameters { R, g, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, _, _] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step.
    // q1'' = -2*q2'*q3'/cos(q2)
    let q1_ddot = -S::int(2) * q2_dot * q3_dot / c2;
    // q2'' = (4*g*sin(q2) + R*cos(q2)*(q1'*(q1'*sin(q2) + 2*q3') - 4*q2'^2*sin(q2)))/(R*(5 - 4*cos(q2)^2))
    let q2_ddot = (S::int(4) * g * s2
        + R * c2
            * (q1_dot * (q1_dot * s2 + S::int(2) * q3_dot)
                - S::int(4) * q2_dot * q2_dot * s2))
        / (R * (S::int(5) - S::int(4) * c2 * c2));
    // Shared terms.
    // q1'^2 + q2'^2; used 2 times
    let q1_2_plus_q2_2 = q1_dot * q1_dot + q2_dot * q2_dot;
    // Elimination, step by step.
    // q5'' = R*(sin(q2)*(cos(q1)*(q1'^2 + q2'^2) + q1''*sin(q1)) + cos(q2)*(2*q1'*q2'*sin(q1) -
    //   q2''*cos(q1)))
    let q5_ddot = R
        * (s2 * (c1 * q1_2_plus_q2_2 + q1_ddot * s1)
            + c2 * (S::int(2) * q1_dot * q2_dot * s1 - q2_ddot * c1));
    // q4'' = R*(cos(q2)*(2*q1'*q2'*cos(q1) + q2''*sin(q1)) - sin(q2)*(sin(q1)*(q1'^2 + q2'^2) -
    //   q1''*cos(q1)))
    let q4_ddot = R
        * (c2 * (S::int(2) * q1_dot * q2_dot * c1 + q2_ddot * s1)
            - s2 * (s1 * q1_2_plus_q2_2 - q1_ddot * c1));
    // q3'' = -q1'*q2'*cos(q2) - q1''*sin(q2)
    let q3_ddot = -q1_dot * q2_dot * c2 - q1_ddot * s2;
    [q1_ddot, q2_ddot, q3_ddot, q4_ddot, q5_ddot]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 54 operations, 2 sines and cosines.
#[must_use]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> ([S; 5], [S; 5]) {
    let Parameters { R, g, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step.
    // q1'' = -2*q2'*q3'/cos(q2)
    let q1_ddot = -S::int(2) * q2_dot * q3_dot / c2;
    // q2'' = (4*g*sin(q2) + R*cos(q2)*(q1'*(q1'*sin(q2) + 2*q3') - 4*q2'^2*sin(q2)))/(R*(5 - 4*cos(q2)^2))
    let q2_ddot = (S::int(4) * g * s2
        + R * c2
            * (q1_dot * (q1_dot * s2 + S::int(2) * q3_dot)
                - S::int(4) * q2_dot * q2_dot * s2))
        / (R * (S::int(5) - S::int(4) * c2 * c2));
    // Shared terms.
    // q1'^2 + q2'^2; used 2 times
    let q1_2_plus_q2_2 = q1_dot * q1_dot + q2_dot * q2_dot;
    // Elimination, step by step.
    // q5'' = R*(sin(q2)*(cos(q1)*(q1'^2 + q2'^2) + q1''*sin(q1)) + cos(q2)*(2*q1'*q2'*sin(q1) -
    //   q2''*cos(q1)))
    let q5_ddot = R
        * (s2 * (c1 * q1_2_plus_q2_2 + q1_ddot * s1)
            + c2 * (S::int(2) * q1_dot * q2_dot * s1 - q2_ddot * c1));
    // q4'' = R*(cos(q2)*(2*q1'*q2'*cos(q1) + q2''*sin(q1)) - sin(q2)*(sin(q1)*(q1'^2 + q2'^2) -
    //   q1''*cos(q1)))
    let q4_ddot = R
        * (c2 * (S::int(2) * q1_dot * q2_dot * c1 + q2_ddot * s1)
            - s2 * (s1 * q1_2_plus_q2_2 - q1_ddot * c1));
    // q3'' = -q1'*q2'*cos(q2) - q1''*sin(q2)
    let q3_ddot = -q1_dot * q2_dot * c2 - q1_ddot * s2;
    // Values.
    // q1' = q1'
    let q1_dot_value = q1_dot;
    // q2' = q2'
    let q2_dot_value = q2_dot;
    // q3' = q3'
    let q3_dot_value = q3_dot;
    // q4' = q4'
    let q4_dot_value = q4_dot;
    // q5' = q5'
    let q5_dot_value = q5_dot;
    (
        [q1_dot_value, q2_dot_value, q3_dot_value, q4_dot_value, q5_dot_value],
        [q1_ddot, q2_ddot, q3_ddot, q4_ddot, q5_ddot],
    )
}

/// Jacobian of the derivative by the state; columns q1, q2, q3, q4, q5, q1', q2', q3', q4', q5'.
///
/// 187 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [[S; 10]; 10] {
    let Parameters { R, g, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, _, _] = *q_dot;
    let zero = S::int(0);
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step.
    // q1'' = -2*q2'*q3'/cos(q2)
    let q1_ddot = -S::int(2) * q2_dot * q3_dot / c2;
    // Shared terms.
    // q1'*sin(q2); used 2 times
    let q1_dot_s2 = q1_dot * s2;
    // cos(q2)^2; used 4 times
    let c2_sq = c2 * c2;
    // 4*cos(q2)^2 - 5; used 5 times
    let q2_ddot_part = S::int(4) * c2_sq - S::int(5);
    // Elimination, step by step.
    // q2'' = (4*g*sin(q2) + R*cos(q2)*(q1'*(q1'*sin(q2) + 2*q3') - 4*q2'^2*sin(q2)))/(R*(5 - 4*cos(q2)^2))
    let q2_ddot = -(S::int(4) * g * s2
        + R * c2
            * (q1_dot * (q1_dot_s2 + S::int(2) * q3_dot)
                - S::int(4) * q2_dot * q2_dot * s2)) / (R * q2_ddot_part);
    // Shared terms.
    // q1'^2; used 2 times
    let q1_dot_sq = q1_dot * q1_dot;
    // q2'^2; used 2 times
    let q2_dot_sq = q2_dot * q2_dot;
    // q1'^2 + q2'^2; used 2 times
    let q1_2_plus_q2_2 = q1_dot_sq + q2_dot_sq;
    // q1''*cos(q1); used 2 times
    let q1_ddot_c1 = q1_ddot * c1;
    // q2''*sin(q1); used 2 times
    let q2_ddot_s1 = q2_ddot * s1;
    // Elimination, step by step.
    // q5_ddot_by_q1 = R*(cos(q2)*(2*q1'*q2'*cos(q1) + q2''*sin(q1)) - sin(q2)*(sin(q1)*(q1'^2 + q2'^2) -
    //   q1''*cos(q1)))
    let q5_ddot_by_q1 = R
        * (c2 * (S::int(2) * q1_dot * q2_dot * c1 + q2_ddot_s1)
            - s2 * (s1 * q1_2_plus_q2_2 - q1_ddot_c1));
    // Shared terms.
    // q1''*sin(q1); used 2 times
    let q1_ddot_s1 = q1_ddot * s1;
    // q2''*cos(q1); used 2 times
    let q2_ddot_c1 = q2_ddot * c1;
    // Elimination, step by step.
    // q4_ddot_by_q1 = -R*(sin(q2)*(cos(q1)*(q1'^2 + q2'^2) + q1''*sin(q1)) + cos(q2)*(2*q1'*q2'*sin(q1) -
    //   q2''*cos(q1)))
    let q4_ddot_by_q1 = -R
        * (s2 * (c1 * q1_2_plus_q2_2 + q1_ddot_s1)
            + c2 * (S::int(2) * q1_dot * q2_dot * s1 - q2_ddot_c1));
    // Shared terms.
    // tan(q2)
    let t2 = s2 / c2;
    // Elimination, step by step.
    // q1_ddot_by_q2 = -2*q2'*q3'*tan(q2)/cos(q2)
    let q1_ddot_by_q2 = -S::int(2) * q2_dot * q3_dot * t2 / c2;
    // Shared terms.
    // 6*cos(q2)^2 - 5; used 2 times
    let q2_ddot_by_q2_part = S::int(6) * c2_sq - S::int(5);
    // Elimination, step by step.
    // q2_ddot_by_q2 = (4*g*cos(q2)*(4*cos(q2)^2 - 3) + R*(4*q2'^2*(5 - 6*cos(q2)^2) +
    //   q1'*(q1'*(6*cos(q2)^2 - 5) - 2*q3'*sin(q2)*(5 + 4*cos(q2)^2))))/(R*(4*cos(q2)^2 - 5)^2)
    let q2_ddot_by_q2 = (S::int(4) * g * c2 * (S::int(4) * c2_sq - S::int(3))
        + R
            * (q1_dot
                * (q1_dot * q2_ddot_by_q2_part
                    - S::int(2) * q3_dot * s2 * (S::int(5) + S::int(4) * c2_sq))
                - S::int(4) * q2_dot * q2_dot * q2_ddot_by_q2_part))
        / (R * q2_ddot_part * q2_ddot_part);
    // Shared terms.
    // q1'^2 + q2'^2 - q2_ddot_by_q2; used 2 times
    let q5_ddot_by_q2_part = q1_dot_sq + q2_dot_sq - q2_ddot_by_q2;
    // q1'*q2'; used 2 times
    let q1_dot_q2_dot = q1_dot * q2_dot;
    // q1_ddot_by_q2 - 2*q1'*q2'; used 2 times
    let q5_ddot_by_q2_part_ = q1_ddot_by_q2 - S::int(2) * q1_dot_q2_dot;
    // Elimination, step by step.
    // q5_ddot_by_q2 = R*(sin(q2)*(q2''*cos(q1) + sin(q1)*(q1_ddot_by_q2 - 2*q1'*q2')) +
    //   cos(q2)*(q1''*sin(q1) + cos(q1)*(q1'^2 + q2'^2 - q2_ddot_by_q2)))
    let q5_ddot_by_q2 = R
        * (s2 * (q2_ddot_c1 + s1 * q5_ddot_by_q2_part_)
            + c2 * (q1_ddot_s1 + c1 * q5_ddot_by_q2_part));
    // q4_ddot_by_q2 = R*(cos(q2)*(q1''*cos(q1) + sin(q1)*(q2_ddot_by_q2 - q1'^2 - q2'^2)) -
    //   sin(q2)*(q2''*sin(q1) + cos(q1)*(2*q1'*q2' - q1_ddot_by_q2)))
    let q4_ddot_by_q2 = R
        * (s2 * (c1 * q5_ddot_by_q2_part_ - q2_ddot_s1)
            + c2 * (q1_ddot_c1 - s1 * q5_ddot_by_q2_part));
    // q3_ddot_by_q2 = sin(q2)*(q1'*q2' - q1_ddot_by_q2) - q1''*cos(q2)
    let q3_ddot_by_q2 = s2 * (q1_dot_q2_dot - q1_ddot_by_q2) - q1_ddot * c2;
    // q2_ddot_by_q1_dot = 2*cos(q2)*(q1'*sin(q2) + q3')/(5 - 4*cos(q2)^2)
    let q2_ddot_by_q1_dot = -S::int(2) * c2 * (q1_dot_s2 + q3_dot) / q2_ddot_part;
    // Shared terms.
    // q2'*sin(q1); used 2 times
    let q2_dot_s1 = q2_dot * s1;
    // Elimination, step by step.
    // q5_ddot_by_q1_dot = R*(2*q1'*cos(q1)*sin(q2) + cos(q2)*(2*q2'*sin(q1) - q2_ddot_by_q1_dot*cos(q1)))
    let q5_ddot_by_q1_dot = R
        * (S::int(2) * q1_dot * c1 * s2
            + c2 * (S::int(2) * q2_dot_s1 - q2_ddot_by_q1_dot * c1));
    // Shared terms.
    // q2'*cos(q1); used 2 times
    let q2_dot_c1 = q2_dot * c1;
    // Elimination, step by step.
    // q4_ddot_by_q1_dot = R*(cos(q2)*(2*q2'*cos(q1) + q2_ddot_by_q1_dot*sin(q1)) - 2*q1'*sin(q1)*sin(q2))
    let q4_ddot_by_q1_dot = R
        * (c2 * (S::int(2) * q2_dot_c1 + q2_ddot_by_q1_dot * s1)
            - S::int(2) * q1_dot * s1 * s2);
    // q1_ddot_by_q2_dot = -2*q3'/cos(q2)
    let q1_ddot_by_q2_dot = -S::int(2) * q3_dot / c2;
    // q2_ddot_by_q2_dot = 8*q2'*sin(q2)*cos(q2)/(4*cos(q2)^2 - 5)
    let q2_ddot_by_q2_dot = S::int(8) * q2_dot * s2 * c2 / q2_ddot_part;
    // q5_ddot_by_q2_dot = R*(sin(q2)*(2*q2'*cos(q1) + q1_ddot_by_q2_dot*sin(q1)) + cos(q2)*(2*q1'*sin(q1)
    //   - q2_ddot_by_q2_dot*cos(q1)))
    let q5_ddot_by_q2_dot = R
        * (s2 * (S::int(2) * q2_dot_c1 + q1_ddot_by_q2_dot * s1)
            + c2 * (S::int(2) * q1_dot * s1 - q2_ddot_by_q2_dot * c1));
    // q4_ddot_by_q2_dot = R*(cos(q2)*(2*q1'*cos(q1) + q2_ddot_by_q2_dot*sin(q1)) - sin(q2)*(2*q2'*sin(q1)
    //   - q1_ddot_by_q2_dot*cos(q1)))
    let q4_ddot_by_q2_dot = R
        * (c2 * (S::int(2) * q1_dot * c1 + q2_ddot_by_q2_dot * s1)
            - s2 * (S::int(2) * q2_dot_s1 - q1_ddot_by_q2_dot * c1));
    // q3_ddot_by_q2_dot = -q1'*cos(q2) - q1_ddot_by_q2_dot*sin(q2)
    let q3_ddot_by_q2_dot = -q1_dot * c2 - q1_ddot_by_q2_dot * s2;
    // q1_ddot_by_q3_dot = -2*q2'/cos(q2)
    let q1_ddot_by_q3_dot = -S::int(2) * q2_dot / c2;
    // q2_ddot_by_q3_dot = 2*q1'*cos(q2)/(5 - 4*cos(q2)^2)
    let q2_ddot_by_q3_dot = -S::int(2) * q1_dot * c2 / q2_ddot_part;
    // q5_ddot_by_q3_dot = R*(q1_ddot_by_q3_dot*sin(q1)*sin(q2) - q2_ddot_by_q3_dot*cos(q1)*cos(q2))
    let q5_ddot_by_q3_dot = R
        * (q1_ddot_by_q3_dot * s1 * s2 - q2_ddot_by_q3_dot * c1 * c2);
    // q4_ddot_by_q3_dot = R*(q1_ddot_by_q3_dot*cos(q1)*sin(q2) + q2_ddot_by_q3_dot*sin(q1)*cos(q2))
    let q4_ddot_by_q3_dot = R
        * (q1_ddot_by_q3_dot * c1 * s2 + q2_ddot_by_q3_dot * s1 * c2);
    // Entries that are not zero.
    // d(q1')/d(q1') = 1
    let q1_dot_by_q1_dot_value = S::int(1);
    // d(q2')/d(q2') = 1
    let q2_dot_by_q2_dot_value = S::int(1);
    // d(q3')/d(q3') = 1
    let q3_dot_by_q3_dot_value = S::int(1);
    // d(q4')/d(q4') = 1
    let q4_dot_by_q4_dot_value = S::int(1);
    // d(q5')/d(q5') = 1
    let q5_dot_by_q5_dot_value = S::int(1);
    // d(q3'')/d(q1') = -q2'*cos(q2)
    let q3_ddot_by_q1_dot_value = -q2_dot * c2;
    // d(q3'')/d(q3') = -q1_ddot_by_q3_dot*sin(q2)
    let q3_ddot_by_q3_dot_value = -q1_ddot_by_q3_dot * s2;
    [
        [zero, zero, zero, zero, zero, q1_dot_by_q1_dot_value, zero, zero, zero, zero],
        [zero, zero, zero, zero, zero, zero, q2_dot_by_q2_dot_value, zero, zero, zero],
        [zero, zero, zero, zero, zero, zero, zero, q3_dot_by_q3_dot_value, zero, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, q4_dot_by_q4_dot_value, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, q5_dot_by_q5_dot_value],
        [
            zero,
            q1_ddot_by_q2,
            zero,
            zero,
            zero,
            zero,
            q1_ddot_by_q2_dot,
            q1_ddot_by_q3_dot,
            zero,
            zero,
        ],
        [
            zero,
            q2_ddot_by_q2,
            zero,
            zero,
            zero,
            q2_ddot_by_q1_dot,
            q2_ddot_by_q2_dot,
            q2_ddot_by_q3_dot,
            zero,
            zero,
        ],
        [
            zero,
            q3_ddot_by_q2,
            zero,
            zero,
            zero,
            q3_ddot_by_q1_dot_value,
            q3_ddot_by_q2_dot,
            q3_ddot_by_q3_dot_value,
            zero,
            zero,
        ],
        [
            q4_ddot_by_q1,
            q4_ddot_by_q2,
            zero,
            zero,
            zero,
            q4_ddot_by_q1_dot,
            q4_ddot_by_q2_dot,
            q4_ddot_by_q3_dot,
            zero,
            zero,
        ],
        [
            q5_ddot_by_q1,
            q5_ddot_by_q2,
            zero,
            zero,
            zero,
            q5_ddot_by_q1_dot,
            q5_ddot_by_q2_dot,
            q5_ddot_by_q3_dot,
            zero,
            zero,
        ],
    ]
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
    let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot] = *q_dot;
    // Values.
    // q1' = q1'
    let q1_dot_value = q1_dot;
    // q2' = q2'
    let q2_dot_value = q2_dot;
    // q3' = q3'
    let q3_dot_value = q3_dot;
    // q4' = q4'
    let q4_dot_value = q4_dot;
    // q5' = q5'
    let q5_dot_value = q5_dot;
    [q1_dot_value, q2_dot_value, q3_dot_value, q4_dot_value, q5_dot_value]
}

/// Kinetic energy T.
///
/// 60 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> S {
    let Parameters { M, R, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Values.
    // T = M*R^2*q1'^2*(6 - 5*cos(q2)^2)/8 + 5*M*R^2*q2'^2/8 + M*R^2*q3'^2/4 + M*R^2*q1'*q3'*sin(q2)/2 +
    //   M*q4'^2/2 - M*R*q1'*q4'*cos(q1)*sin(q2) - M*R*q2'*q4'*sin(q1)*cos(q2) + M*q5'^2/2 -
    //   M*R*q1'*q5'*sin(q1)*sin(q2) + M*R*q2'*q5'*cos(q1)*cos(q2)
    let energy = S::ratio(1, 8) * M * R * R * q1_dot * q1_dot
        * (S::int(6) - S::int(5) * c2 * c2)
        + S::ratio(5, 8) * M * R * R * q2_dot * q2_dot
        + S::ratio(1, 4) * M * R * R * q3_dot * q3_dot
        + S::ratio(1, 2) * M * R * R * q1_dot * q3_dot * s2
        + S::ratio(1, 2) * M * q4_dot * q4_dot - M * R * q1_dot * q4_dot * c1 * s2
        - M * R * q2_dot * q4_dot * s1 * c2 + S::ratio(1, 2) * M * q5_dot * q5_dot
        - M * R * q1_dot * q5_dot * s1 * s2 + M * R * q2_dot * q5_dot * c1 * c2;
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

/// The generalized speeds u, from q and q'.
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 5] {
    let [_, q2, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Values.
    // u1 = -q2'
    let u1_value = -q2_dot;
    // u2 = q1'*cos(q2)
    let u2_value = q1_dot * c2;
    // u3 = q1'*sin(q2) + q3'
    let u3_value = q1_dot * s2 + q3_dot;
    // u4 = q4'
    let u4_value = q4_dot;
    // u5 = q5'
    let u5_value = q5_dot;
    [u1_value, u2_value, u3_value, u4_value, u5_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 10 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
    v_dot: &[S; 5],
) -> [S; 5] {
    let [_, q2, _, _, _] = *q;
    let [q1_dot, q2_dot, _, _, _] = *q_dot;
    let [q1_ddot, q2_ddot, q3_ddot, q4_ddot, q5_ddot] = *v_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Values.
    // u1' = -q2''
    let u1_dot_value = -q2_ddot;
    // u2' = q1''*cos(q2) - q1'*q2'*sin(q2)
    let u2_dot_value = q1_ddot * c2 - q1_dot * q2_dot * s2;
    // u3' = q1'*q2'*cos(q2) + q1''*sin(q2) + q3''
    let u3_dot_value = q1_dot * q2_dot * c2 + q1_ddot * s2 + q3_ddot;
    // u4' = q4''
    let u4_dot_value = q4_ddot;
    // u5' = q5''
    let u5_dot_value = q5_ddot;
    [u1_dot_value, u2_dot_value, u3_dot_value, u4_dot_value, u5_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn motion_variables<S: Scalar>(
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

/// Lagrange's equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Lagrange;

impl<S: Scalar> System<S> for Lagrange {
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
