//! Chain of three rods floating in a plane: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/floating_chain/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows x, y, theta1, theta2, theta3.
///
/// 32 operations, 3 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _q_dot: &[S; 5],
) -> [[S; 5]; 5] {
    let Parameters { m, l } = *p;
    let [_, _, theta1, theta2, theta3] = *q;
    // Sines and cosines.
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    let (sin_theta3, cos_theta3) = theta3.sin_cos();
    // Shared terms.
    let m_times_3 = S::int(3) * m;
    let m_l = m * l;
    let m_l_times_3_by_2 = S::ratio(3, 2) * m_l;
    let m_l_halved = S::ratio(1, 2) * m_l;
    let l_m_l = l * m_l;
    // sin(theta1)*sin(theta2) + cos(theta1)*cos(theta2)
    let cos_theta1_minus_theta2 = cos_theta1
        .mul_add(cos_theta2, sin_theta1 * sin_theta2);
    // sin(theta1)*sin(theta3) + cos(theta1)*cos(theta3)
    let cos_theta1_minus_theta3 = cos_theta1
        .mul_add(cos_theta3, sin_theta1 * sin_theta3);
    // sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)
    let cos_theta2_minus_theta3 = cos_theta2
        .mul_add(cos_theta3, sin_theta2 * sin_theta3);
    // Entries that are not zero; upper triangle.
    // M11 = 3*m
    let m11 = m_times_3;
    // M13 = -m*l*sin(theta1)
    let m13 = -m_l * sin_theta1;
    // M14 = -3*m*l*sin(theta2)/2
    let m14 = -m_l_times_3_by_2 * sin_theta2;
    // M15 = -m*l*sin(theta3)/2
    let m15 = -m_l_halved * sin_theta3;
    // M22 = 3*m
    let m22 = m_times_3;
    // M23 = m*l*cos(theta1)
    let m23 = m_l * cos_theta1;
    // M24 = 3*m*l*cos(theta2)/2
    let m24 = m_l_times_3_by_2 * cos_theta2;
    // M25 = m*l*cos(theta3)/2
    let m25 = m_l_halved * cos_theta3;
    // M33 = 7*m*l^2/12
    let m33 = S::ratio(7, 12) * l_m_l;
    // M34 = 3*m*l^2*cos(theta1 - theta2)/4
    let m34 = S::ratio(3, 4) * cos_theta1_minus_theta2 * l_m_l;
    // M35 = m*l^2*cos(theta1 - theta3)/4
    let m35 = S::ratio(1, 4) * cos_theta1_minus_theta3 * l_m_l;
    // M44 = 4*m*l^2/3
    let m44 = S::ratio(4, 3) * l_m_l;
    // M45 = m*l^2*cos(theta2 - theta3)/2
    let m45 = S::ratio(1, 2) * cos_theta2_minus_theta3 * l_m_l;
    // M55 = m*l^2/3
    let m55 = S::ratio(1, 3) * l_m_l;
    let zero = S::int(0);
    [
        [m11, zero, m13, m14, m15],
        [zero, m22, m23, m24, m25],
        [m13, m23, m33, m34, m35],
        [m14, m24, m34, m44, m45],
        [m15, m25, m35, m45, m55],
    ]
}

/// Right-hand side of the linear system; unknowns (x'', y'', theta1'', theta2'', theta3'').
///
/// 45 operations, 3 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> [S; 5] {
    let Parameters { m, l } = *p;
    let [_, _, theta1, theta2, theta3] = *q;
    let [_, _, theta1_dot, theta2_dot, theta3_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    let (sin_theta3, cos_theta3) = theta3.sin_cos();
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Shared terms.
    let theta3_dot_sq = theta3_dot * theta3_dot;
    let theta2_dot_sq = theta2_dot * theta2_dot;
    let theta2_dot_sq_times_3 = S::int(3) * theta2_dot_sq;
    let theta1_dot_sq = theta1_dot * theta1_dot;
    let theta1_dot_sq_doubled = S::int(2) * theta1_dot_sq;
    let m_l = m * l;
    let m_l_halved = S::ratio(1, 2) * m_l;
    // sin(theta1)*cos(theta3) - cos(theta1)*sin(theta3)
    let sin_theta1_minus_theta3 = (-cos_theta1)
        .mul_add(sin_theta3, sin_theta1 * cos_theta3);
    // sin(theta1)*cos(theta2) - cos(theta1)*sin(theta2)
    let sin_theta1_minus_theta2 = (-cos_theta1)
        .mul_add(sin_theta2, sin_theta1 * cos_theta2);
    let l_m_l_by_4 = S::ratio(1, 4) * l * m_l;
    // sin(theta2)*cos(theta3) - cos(theta2)*sin(theta3)
    let sin_theta2_minus_theta3 = (-cos_theta2)
        .mul_add(sin_theta3, sin_theta2 * cos_theta3);
    let f4_of_place = S::int(2) * sin_theta2_minus_theta3;
    // Values.
    // f1 = m*l*(2*theta1'^2*cos(theta1) + 3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3))/2
    let f1 = m_l_halved
        * (theta2_dot_sq_times_3.mul_add(cos_theta2, theta3_dot_sq * cos_theta3)
            + theta1_dot_sq_doubled * cos_theta1);
    // f2 = m*l*(2*theta1'^2*sin(theta1) + 3*theta2'^2*sin(theta2) + theta3'^2*sin(theta3))/2
    let f2 = m_l_halved
        * (theta2_dot_sq_times_3.mul_add(sin_theta2, theta3_dot_sq * sin_theta3)
            + theta1_dot_sq_doubled * sin_theta1);
    // f3 = -m*l^2*(3*theta2'^2*sin(theta1 - theta2) + theta3'^2*sin(theta1 - theta3))/4
    let f3 = -l_m_l_by_4
        * sin_theta1_minus_theta2
            .mul_add(theta2_dot_sq_times_3, sin_theta1_minus_theta3 * theta3_dot_sq);
    // f4 = m*l^2*(3*theta1'^2*sin(theta1 - theta2) - 2*theta3'^2*sin(theta2 - theta3))/4
    let f4 = l_m_l_by_4
        * (-theta3_dot_sq)
            .mul_add(f4_of_place, S::int(3) * sin_theta1_minus_theta2 * theta1_dot_sq);
    // f5 = m*l^2*(theta1'^2*sin(theta1 - theta3) + 2*theta2'^2*sin(theta2 - theta3))/4
    let f5 = l_m_l_by_4
        * theta2_dot_sq.mul_add(f4_of_place, sin_theta1_minus_theta3 * theta1_dot_sq);
    [f1, f2, f3, f4, f5]
}

/// The accelerations (x'', y'', theta1'', theta2'', theta3''), solved for when this code was generated.
///
/// 128 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 5] {
    let Parameters { l, .. } = *p;
    let [_, _, theta1, theta2, theta3] = *q;
    let [_, _, theta1_dot, theta2_dot, theta3_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    let (sin_theta3, cos_theta3) = theta3.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let cos_theta2_times_9 = S::int(9) * cos_theta2;
    // 4 - cos_theta2_times_9*cos(theta2)
    let theta3_ddot_of_theta2 = (-cos_theta2_times_9).mul_add(cos_theta2, S::int(4));
    let theta3_ddot_of_theta2_2 = cos_theta2_times_9 * sin_theta2;
    // 1/(9 - cos(theta3)*(cos_theta2_times_9*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)) -
    //   5*cos(theta3)) - sin(theta1)*(sin(theta1)*(cos(theta3)^2 + theta3_ddot_of_theta2) +
    //   cos(theta1)*(theta3_ddot_of_theta2_2 - sin(theta3)*cos(theta3))))
    let theta3_ddot_of_place = S::int(1)
        / (S::int(9)
            - cos_theta3
                * (cos_theta2_times_9 * cos_theta2.mul_add(cos_theta3, sin_theta2 * sin_theta3)
                    - S::int(5) * cos_theta3)
            - sin_theta1
                * (sin_theta1 * cos_theta3.mul_add(cos_theta3, theta3_ddot_of_theta2)
                    + cos_theta1 * (-sin_theta3).mul_add(cos_theta3, theta3_ddot_of_theta2_2)));
    // theta3_ddot_of_theta2_2 - sin(theta1)*cos(theta1)
    let theta3_ddot_of_place_2 = (-sin_theta1)
        .mul_add(cos_theta1, theta3_ddot_of_theta2_2);
    let theta3_dot_sq = theta3_dot * theta3_dot;
    let theta1_dot_sq = theta1_dot * theta1_dot;
    // sin(theta1)*cos(theta2) - cos(theta1)*sin(theta2)
    let theta3_ddot_of_place_3 = (-cos_theta1)
        .mul_add(sin_theta2, sin_theta1 * cos_theta2);
    let theta3_ddot_of_place_4 = theta3_ddot_of_place * cos_theta3;
    let cos_theta1_cos_theta2 = cos_theta1 * cos_theta2;
    let sin_theta1_sin_theta2 = sin_theta1 * sin_theta2;
    // cos_theta1_cos_theta2 + sin_theta1_sin_theta2
    let theta3_ddot_of_place_5 = cos_theta1_cos_theta2 + sin_theta1_sin_theta2;
    let theta3_ddot_of_place_6 = theta3_ddot_of_place * sin_theta3;
    let theta2_dot_sq = theta2_dot * theta2_dot;
    let cos_theta2_theta2_dot_sq = theta2_dot_sq * cos_theta2;
    // theta1_dot_sq + theta3_ddot_of_place_5*theta2_dot_sq
    let theta3_ddot_of_motion = theta3_ddot_of_place_5
        .mul_add(theta2_dot_sq, theta1_dot_sq);
    let sin_theta1_theta1_dot_sq = theta1_dot_sq * sin_theta1;
    // theta3_ddot_of_place_4*theta2_dot_sq*(6*sin(theta2) - theta3_ddot_of_place_3*cos(theta1)) +
    //   theta3_ddot_of_place_6*theta3_ddot_of_motion*cos(theta1)
    let theta3_ddot_of_motion_2 = theta3_ddot_of_place_4 * theta2_dot_sq
        * (-theta3_ddot_of_place_3).mul_add(cos_theta1, S::int(6) * sin_theta2)
        + theta3_ddot_of_place_6 * theta3_ddot_of_motion * cos_theta1;
    // theta3'' = (theta3'^2*(sin(theta1)*cos(theta1) - 9*sin(theta2)*cos(theta2)) -
    //   3*sin(theta3)*(cos(theta1)*(theta1'^2*(3*cos(theta2)^2 - 1) - theta2'^2*(sin(theta1)*sin(theta2) +
    //   cos(theta1)*cos(theta2))) + cos(theta2)*(3*theta1'^2*sin(theta1)*sin(theta2) + 7*theta2'^2)) +
    //   cos(theta3)*(3*theta1'^2*(3*cos(theta1)*sin(theta2)*cos(theta2) - sin(theta1)*(3*cos(theta2)^2 - 2))
    //   + 3*theta2'^2*(6*sin(theta2) + cos(theta1)*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2))) +
    //   2*theta3'^2*(sin(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2) +
    //   cos(theta3)*(9*sin(theta2)*cos(theta2) - sin(theta1)*cos(theta1)))))/(2*(9 +
    //   sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)))))
    let theta3_ddot = theta3_ddot_of_place_4
        * (theta3_dot_sq
            * (sin_theta3 * cos_theta1.mul_add(cos_theta1, theta3_ddot_of_theta2)
                + theta3_ddot_of_place_2 * cos_theta3) + S::int(3) * sin_theta1_theta1_dot_sq)
        - S::ratio(1, 2) * theta3_ddot_of_place * theta3_ddot_of_place_2 * theta3_dot_sq
        - S::ratio(9, 2) * theta1_dot_sq * cos_theta2
            * theta3_ddot_of_place_5
                .mul_add(
                    theta3_ddot_of_place_6,
                    theta3_ddot_of_place_3 * theta3_ddot_of_place_4,
                ) - S::ratio(21, 2) * theta3_ddot_of_place_6 * cos_theta2_theta2_dot_sq
        + S::ratio(3, 2) * theta3_ddot_of_motion_2;
    // cos_theta1_cos_theta2^2 + sin_theta1_sin_theta2*(2*cos_theta1_cos_theta2 + sin_theta1_sin_theta2)
    let theta2_ddot_of_place = sin_theta1_sin_theta2
        * cos_theta1_cos_theta2.mul_add(S::int(2), sin_theta1_sin_theta2)
        + cos_theta1_cos_theta2 * cos_theta1_cos_theta2;
    // 1/(3*theta2_ddot_of_place - 7)
    let theta2_ddot_of_place_2 = S::int(1) / theta2_ddot_of_place.mul_add(S::int(3), -S::int(7));
    // theta3''*sin(theta3) + theta3_dot_sq*cos(theta3)
    let theta2_ddot_of_motion = theta3_dot_sq
        .mul_add(cos_theta3, theta3_ddot * sin_theta3);
    // theta3''*cos(theta3) - theta3_dot_sq*sin(theta3)
    let theta2_ddot_of_motion_2 = (-theta3_dot_sq)
        .mul_add(sin_theta3, theta3_ddot * cos_theta3);
    // theta2_ddot_of_motion*sin(theta1) + theta2_ddot_of_motion_2*cos(theta1)
    let theta2_ddot_of_motion_3 = theta2_ddot_of_motion_2
        .mul_add(cos_theta1, theta2_ddot_of_motion * sin_theta1);
    // theta2_ddot_of_motion*sin(theta2) + theta2_ddot_of_motion_2*cos(theta2)
    let theta2_ddot_of_motion_4 = theta2_ddot_of_motion_2
        .mul_add(cos_theta2, theta2_ddot_of_motion * sin_theta2);
    // theta2'' = (sin(theta1)*(3*theta1'^2*cos(theta2) + sin(theta1)*sin(theta2)*(3*theta2'^2*cos(theta2)
    //   + theta3'^2*cos(theta3) + theta3''*sin(theta3)) + cos(theta1)*(cos(theta2)*(3*theta2'^2*cos(theta2)
    //   + theta3'^2*cos(theta3) + theta3''*sin(theta3)) - sin(theta2)*(3*theta2'^2*sin(theta2) +
    //   theta3'^2*sin(theta3) - theta3''*cos(theta3)))) + cos(theta2)*(3*theta3'^2*sin(theta3) -
    //   3*theta3''*cos(theta3) + cos(theta1)^2*(theta3''*cos(theta3) - 3*theta2'^2*sin(theta2) -
    //   theta3'^2*sin(theta3))) - 3*sin(theta2)*(theta1'^2*cos(theta1) + theta3'^2*cos(theta3) +
    //   theta3''*sin(theta3)))/(7 - 3*cos(theta1)^2*cos(theta2)^2 -
    //   3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)))
    let theta2_ddot = S::int(3) * theta2_ddot_of_place_2
        * (-theta3_ddot_of_place_3)
            .mul_add(theta3_ddot_of_motion, theta2_ddot_of_motion_4)
        - theta3_ddot_of_place_5 * theta2_ddot_of_place_2 * theta2_ddot_of_motion_3;
    // theta1'' = cos(theta1)*(3*theta2'^2*sin(theta2) + theta3'^2*sin(theta3) - 3*theta2''*cos(theta2) -
    //   theta3''*cos(theta3))/3 - sin(theta1)*(3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3) +
    //   3*theta2''*sin(theta2) + theta3''*sin(theta3))/3
    let theta1_ddot = (-theta3_ddot_of_place_3)
        .mul_add(theta2_dot_sq, -theta2_ddot * theta3_ddot_of_place_5)
        - S::ratio(1, 3) * theta2_ddot_of_motion_3;
    let l_by_6 = S::ratio(1, 6) * l;
    let l_halved = S::ratio(1, 2) * l;
    let l_by_3 = S::ratio(1, 3) * l;
    // y'' = l*(2*theta1'^2*sin(theta1) + 3*theta2'^2*sin(theta2) + theta3'^2*sin(theta3) -
    //   2*theta1''*cos(theta1) - 3*theta2''*cos(theta2) - theta3''*cos(theta3))/6
    let y_ddot = l_halved * (-theta2_ddot).mul_add(cos_theta2, theta2_dot_sq * sin_theta2)
        - theta2_ddot_of_motion_2 * l_by_6
        + l_by_3 * (-theta1_ddot).mul_add(cos_theta1, sin_theta1_theta1_dot_sq);
    // x'' = l*(2*theta1'^2*cos(theta1) + 3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3) +
    //   2*theta1''*sin(theta1) + 3*theta2''*sin(theta2) + theta3''*sin(theta3))/6
    let x_ddot = l_halved * theta2_ddot.mul_add(sin_theta2, cos_theta2_theta2_dot_sq)
        + theta2_ddot_of_motion * l_by_6
        + l_by_3 * theta1_dot_sq.mul_add(cos_theta1, theta1_ddot * sin_theta1);
    [x_ddot, y_ddot, theta1_ddot, theta2_ddot, theta3_ddot]
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
    let [x_dot, y_dot, theta1_dot, theta2_dot, theta3_dot] = *q_dot;
    // Values.
    // x'
    let x_dot_value = x_dot;
    // y'
    let y_dot_value = y_dot;
    // theta1'
    let theta1_dot_value = theta1_dot;
    // theta2'
    let theta2_dot_value = theta2_dot;
    // theta3'
    let theta3_dot_value = theta3_dot;
    [x_dot_value, y_dot_value, theta1_dot_value, theta2_dot_value, theta3_dot_value]
}

/// Kinetic energy T.
///
/// 48 operations, 3 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> S {
    let Parameters { m, l } = *p;
    let [_, _, theta1, theta2, theta3] = *q;
    let [x_dot, y_dot, theta1_dot, theta2_dot, theta3_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    let (sin_theta3, cos_theta3) = theta3.sin_cos();
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    // Shared terms.
    let m_l = m * l;
    let theta2_dot_times_3 = S::int(3) * theta2_dot;
    // theta3'*sin(theta3) + theta2_dot_times_3*sin(theta2)
    let energy_of_motion = theta2_dot_times_3
        .mul_add(sin_theta2, theta3_dot * sin_theta3);
    // theta3'*cos(theta3) + theta2_dot_times_3*cos(theta2)
    let energy_of_motion_2 = theta2_dot_times_3
        .mul_add(cos_theta2, theta3_dot * cos_theta3);
    let l_m_l = l * m_l;
    let theta1_dot_l_m_l = theta1_dot * l_m_l;
    // Values.
    // T = 3*m*x'^2/2 + 3*m*y'^2/2 + 7*m*l^2*theta1'^2/24 - m*l*x'*theta1'*sin(theta1) +
    //   m*l*y'*theta1'*cos(theta1) + 2*m*l^2*theta2'^2/3 - 3*m*l*x'*theta2'*sin(theta2)/2 +
    //   3*m*l*y'*theta2'*cos(theta2)/2 + 3*m*l^2*theta1'*theta2'*cos(theta1 - theta2)/4 + m*l^2*theta3'^2/6
    //   - m*l*x'*theta3'*sin(theta3)/2 + m*l*y'*theta3'*cos(theta3)/2 + m*l^2*theta1'*theta3'*cos(theta1 -
    //   theta3)/4 + m*l^2*theta2'*theta3'*cos(theta2 - theta3)/2
    let energy = S::ratio(3, 2) * m * y_dot.mul_add(y_dot, x_dot * x_dot)
        + theta1_dot * m_l * (-x_dot).mul_add(sin_theta1, y_dot * cos_theta1)
        + S::ratio(1, 2) * m_l * (-x_dot).mul_add(energy_of_motion, y_dot * energy_of_motion_2)
        + S::ratio(1, 6) * l_m_l
            * (S::int(4) * theta2_dot * theta2_dot
                + theta3_dot
                    * (theta3_dot
                        + theta2_dot_times_3
                            * cos_theta2.mul_add(cos_theta3, sin_theta2 * sin_theta3)))
        + S::ratio(7, 24) * theta1_dot * theta1_dot_l_m_l
        + S::ratio(1, 4) * theta1_dot_l_m_l
            * energy_of_motion_2.mul_add(cos_theta1, energy_of_motion * sin_theta1);
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 0 operations.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 5],
    q_dot: &[S; 5],
) -> [S; 5] {
    let [x_dot, y_dot, theta1_dot, theta2_dot, theta3_dot] = *q_dot;
    // Values.
    // u1 = x'
    let u1_value = x_dot;
    // u2 = y'
    let u2_value = y_dot;
    // u3 = theta1'
    let u3_value = theta1_dot;
    // u4 = theta2'
    let u4_value = theta2_dot;
    // u5 = theta3'
    let u5_value = theta3_dot;
    [u1_value, u2_value, u3_value, u4_value, u5_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 0 operations.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 5],
    _q_dot: &[S; 5],
    v_dot: &[S; 5],
) -> [S; 5] {
    let [x_ddot, y_ddot, theta1_ddot, theta2_ddot, theta3_ddot] = *v_dot;
    // Values.
    // u1' = x''
    let u1_dot_value = x_ddot;
    // u2' = y''
    let u2_dot_value = y_ddot;
    // u3' = theta1''
    let u3_dot_value = theta1_ddot;
    // u4' = theta2''
    let u4_dot_value = theta2_ddot;
    // u5' = theta3''
    let u5_dot_value = theta3_ddot;
    [u1_dot_value, u2_dot_value, u3_dot_value, u4_dot_value, u5_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 0 operations.
#[must_use]
pub fn motion_variables<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 5],
    u: &[S; 5],
) -> [S; 5] {
    let [u1, u2, u3, u4, u5] = *u;
    // Values.
    // x' = u1
    let x_dot_value = u1;
    // y' = u2
    let y_dot_value = u2;
    // theta1' = u3
    let theta1_dot_value = u3;
    // theta2' = u4
    let theta2_dot_value = u4;
    // theta3' = u5
    let theta3_dot_value = u5;
    [x_dot_value, y_dot_value, theta1_dot_value, theta2_dot_value, theta3_dot_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 128 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> ([S; 5], [S; 5]) {
    let Parameters { l, .. } = *p;
    let [_, _, theta1, theta2, theta3] = *q;
    let [x_dot, y_dot, theta1_dot, theta2_dot, theta3_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    let (sin_theta3, cos_theta3) = theta3.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let cos_theta2_times_9 = S::int(9) * cos_theta2;
    // 4 - cos_theta2_times_9*cos(theta2)
    let theta3_ddot_of_theta2 = (-cos_theta2_times_9).mul_add(cos_theta2, S::int(4));
    let theta3_ddot_of_theta2_2 = cos_theta2_times_9 * sin_theta2;
    // 1/(9 - cos(theta3)*(cos_theta2_times_9*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)) -
    //   5*cos(theta3)) - sin(theta1)*(sin(theta1)*(cos(theta3)^2 + theta3_ddot_of_theta2) +
    //   cos(theta1)*(theta3_ddot_of_theta2_2 - sin(theta3)*cos(theta3))))
    let theta3_ddot_of_place = S::int(1)
        / (S::int(9)
            - cos_theta3
                * (cos_theta2_times_9 * cos_theta2.mul_add(cos_theta3, sin_theta2 * sin_theta3)
                    - S::int(5) * cos_theta3)
            - sin_theta1
                * (sin_theta1 * cos_theta3.mul_add(cos_theta3, theta3_ddot_of_theta2)
                    + cos_theta1 * (-sin_theta3).mul_add(cos_theta3, theta3_ddot_of_theta2_2)));
    // theta3_ddot_of_theta2_2 - sin(theta1)*cos(theta1)
    let theta3_ddot_of_place_2 = (-sin_theta1)
        .mul_add(cos_theta1, theta3_ddot_of_theta2_2);
    let theta3_dot_sq = theta3_dot * theta3_dot;
    let theta1_dot_sq = theta1_dot * theta1_dot;
    // sin(theta1)*cos(theta2) - cos(theta1)*sin(theta2)
    let theta3_ddot_of_place_3 = (-cos_theta1)
        .mul_add(sin_theta2, sin_theta1 * cos_theta2);
    let theta3_ddot_of_place_4 = theta3_ddot_of_place * cos_theta3;
    let cos_theta1_cos_theta2 = cos_theta1 * cos_theta2;
    let sin_theta1_sin_theta2 = sin_theta1 * sin_theta2;
    // cos_theta1_cos_theta2 + sin_theta1_sin_theta2
    let theta3_ddot_of_place_5 = cos_theta1_cos_theta2 + sin_theta1_sin_theta2;
    let theta3_ddot_of_place_6 = theta3_ddot_of_place * sin_theta3;
    let theta2_dot_sq = theta2_dot * theta2_dot;
    let cos_theta2_theta2_dot_sq = theta2_dot_sq * cos_theta2;
    // theta1_dot_sq + theta3_ddot_of_place_5*theta2_dot_sq
    let theta3_ddot_of_motion = theta3_ddot_of_place_5
        .mul_add(theta2_dot_sq, theta1_dot_sq);
    let sin_theta1_theta1_dot_sq = theta1_dot_sq * sin_theta1;
    // theta3_ddot_of_place_4*theta2_dot_sq*(6*sin(theta2) - theta3_ddot_of_place_3*cos(theta1)) +
    //   theta3_ddot_of_place_6*theta3_ddot_of_motion*cos(theta1)
    let theta3_ddot_of_motion_2 = theta3_ddot_of_place_4 * theta2_dot_sq
        * (-theta3_ddot_of_place_3).mul_add(cos_theta1, S::int(6) * sin_theta2)
        + theta3_ddot_of_place_6 * theta3_ddot_of_motion * cos_theta1;
    // theta3'' = (theta3'^2*(sin(theta1)*cos(theta1) - 9*sin(theta2)*cos(theta2)) -
    //   3*sin(theta3)*(cos(theta1)*(theta1'^2*(3*cos(theta2)^2 - 1) - theta2'^2*(sin(theta1)*sin(theta2) +
    //   cos(theta1)*cos(theta2))) + cos(theta2)*(3*theta1'^2*sin(theta1)*sin(theta2) + 7*theta2'^2)) +
    //   cos(theta3)*(3*theta1'^2*(3*cos(theta1)*sin(theta2)*cos(theta2) - sin(theta1)*(3*cos(theta2)^2 - 2))
    //   + 3*theta2'^2*(6*sin(theta2) + cos(theta1)*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2))) +
    //   2*theta3'^2*(sin(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2) +
    //   cos(theta3)*(9*sin(theta2)*cos(theta2) - sin(theta1)*cos(theta1)))))/(2*(9 +
    //   sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)))))
    let theta3_ddot = theta3_ddot_of_place_4
        * (theta3_dot_sq
            * (sin_theta3 * cos_theta1.mul_add(cos_theta1, theta3_ddot_of_theta2)
                + theta3_ddot_of_place_2 * cos_theta3) + S::int(3) * sin_theta1_theta1_dot_sq)
        - S::ratio(1, 2) * theta3_ddot_of_place * theta3_ddot_of_place_2 * theta3_dot_sq
        - S::ratio(9, 2) * theta1_dot_sq * cos_theta2
            * theta3_ddot_of_place_5
                .mul_add(
                    theta3_ddot_of_place_6,
                    theta3_ddot_of_place_3 * theta3_ddot_of_place_4,
                ) - S::ratio(21, 2) * theta3_ddot_of_place_6 * cos_theta2_theta2_dot_sq
        + S::ratio(3, 2) * theta3_ddot_of_motion_2;
    // cos_theta1_cos_theta2^2 + sin_theta1_sin_theta2*(2*cos_theta1_cos_theta2 + sin_theta1_sin_theta2)
    let theta2_ddot_of_place = sin_theta1_sin_theta2
        * cos_theta1_cos_theta2.mul_add(S::int(2), sin_theta1_sin_theta2)
        + cos_theta1_cos_theta2 * cos_theta1_cos_theta2;
    // 1/(3*theta2_ddot_of_place - 7)
    let theta2_ddot_of_place_2 = S::int(1) / theta2_ddot_of_place.mul_add(S::int(3), -S::int(7));
    // theta3''*sin(theta3) + theta3_dot_sq*cos(theta3)
    let theta2_ddot_of_motion = theta3_dot_sq
        .mul_add(cos_theta3, theta3_ddot * sin_theta3);
    // theta3''*cos(theta3) - theta3_dot_sq*sin(theta3)
    let theta2_ddot_of_motion_2 = (-theta3_dot_sq)
        .mul_add(sin_theta3, theta3_ddot * cos_theta3);
    // theta2_ddot_of_motion*sin(theta1) + theta2_ddot_of_motion_2*cos(theta1)
    let theta2_ddot_of_motion_3 = theta2_ddot_of_motion_2
        .mul_add(cos_theta1, theta2_ddot_of_motion * sin_theta1);
    // theta2_ddot_of_motion*sin(theta2) + theta2_ddot_of_motion_2*cos(theta2)
    let theta2_ddot_of_motion_4 = theta2_ddot_of_motion_2
        .mul_add(cos_theta2, theta2_ddot_of_motion * sin_theta2);
    // theta2'' = (sin(theta1)*(3*theta1'^2*cos(theta2) + sin(theta1)*sin(theta2)*(3*theta2'^2*cos(theta2)
    //   + theta3'^2*cos(theta3) + theta3''*sin(theta3)) + cos(theta1)*(cos(theta2)*(3*theta2'^2*cos(theta2)
    //   + theta3'^2*cos(theta3) + theta3''*sin(theta3)) - sin(theta2)*(3*theta2'^2*sin(theta2) +
    //   theta3'^2*sin(theta3) - theta3''*cos(theta3)))) + cos(theta2)*(3*theta3'^2*sin(theta3) -
    //   3*theta3''*cos(theta3) + cos(theta1)^2*(theta3''*cos(theta3) - 3*theta2'^2*sin(theta2) -
    //   theta3'^2*sin(theta3))) - 3*sin(theta2)*(theta1'^2*cos(theta1) + theta3'^2*cos(theta3) +
    //   theta3''*sin(theta3)))/(7 - 3*cos(theta1)^2*cos(theta2)^2 -
    //   3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)))
    let theta2_ddot = S::int(3) * theta2_ddot_of_place_2
        * (-theta3_ddot_of_place_3)
            .mul_add(theta3_ddot_of_motion, theta2_ddot_of_motion_4)
        - theta3_ddot_of_place_5 * theta2_ddot_of_place_2 * theta2_ddot_of_motion_3;
    // theta1'' = cos(theta1)*(3*theta2'^2*sin(theta2) + theta3'^2*sin(theta3) - 3*theta2''*cos(theta2) -
    //   theta3''*cos(theta3))/3 - sin(theta1)*(3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3) +
    //   3*theta2''*sin(theta2) + theta3''*sin(theta3))/3
    let theta1_ddot = (-theta3_ddot_of_place_3)
        .mul_add(theta2_dot_sq, -theta2_ddot * theta3_ddot_of_place_5)
        - S::ratio(1, 3) * theta2_ddot_of_motion_3;
    let l_by_6 = S::ratio(1, 6) * l;
    let l_halved = S::ratio(1, 2) * l;
    let l_by_3 = S::ratio(1, 3) * l;
    // y'' = l*(2*theta1'^2*sin(theta1) + 3*theta2'^2*sin(theta2) + theta3'^2*sin(theta3) -
    //   2*theta1''*cos(theta1) - 3*theta2''*cos(theta2) - theta3''*cos(theta3))/6
    let y_ddot = l_halved * (-theta2_ddot).mul_add(cos_theta2, theta2_dot_sq * sin_theta2)
        - theta2_ddot_of_motion_2 * l_by_6
        + l_by_3 * (-theta1_ddot).mul_add(cos_theta1, sin_theta1_theta1_dot_sq);
    // x'' = l*(2*theta1'^2*cos(theta1) + 3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3) +
    //   2*theta1''*sin(theta1) + 3*theta2''*sin(theta2) + theta3''*sin(theta3))/6
    let x_ddot = l_halved * theta2_ddot.mul_add(sin_theta2, cos_theta2_theta2_dot_sq)
        + theta2_ddot_of_motion * l_by_6
        + l_by_3 * theta1_dot_sq.mul_add(cos_theta1, theta1_ddot * sin_theta1);
    // Values.
    // x'
    let x_dot_value = x_dot;
    // y'
    let y_dot_value = y_dot;
    // theta1'
    let theta1_dot_value = theta1_dot;
    // theta2'
    let theta2_dot_value = theta2_dot;
    // theta3'
    let theta3_dot_value = theta3_dot;
    (
        [x_dot_value, y_dot_value, theta1_dot_value, theta2_dot_value, theta3_dot_value],
        [x_ddot, y_ddot, theta1_ddot, theta2_ddot, theta3_ddot],
    )
}

/// Jacobian of the derivative by the state; columns x, y, theta1, theta2, theta3, x', y', theta1', theta2', theta3'.
///
/// 544 operations, 3 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
) -> [[S; 10]; 10] {
    let Parameters { l, .. } = *p;
    let [_, _, theta1, theta2, theta3] = *q;
    let [_, _, theta1_dot, theta2_dot, theta3_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    let (sin_theta3, cos_theta3) = theta3.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let theta3_dot_sq = theta3_dot * theta3_dot;
    let sin_theta1_cos_theta1 = sin_theta1 * cos_theta1;
    let cos_theta2_times_9 = S::int(9) * cos_theta2;
    let theta3_ddot_of_theta2 = cos_theta2_times_9 * sin_theta2;
    // theta3_ddot_of_theta2 - sin_theta1_cos_theta1
    let theta3_ddot_of_place = theta3_ddot_of_theta2 - sin_theta1_cos_theta1;
    // 4 - cos_theta2_times_9*cos(theta2)
    let theta3_ddot_of_theta2_2 = (-cos_theta2_times_9).mul_add(cos_theta2, S::int(4));
    let cos_theta1_sq = cos_theta1 * cos_theta1;
    // theta3_ddot_of_theta2_2 + cos_theta1_sq
    let theta3_ddot_of_place_2 = theta3_ddot_of_theta2_2 + cos_theta1_sq;
    // theta3_ddot_of_place*cos(theta3) + theta3_ddot_of_place_2*sin(theta3)
    let theta3_ddot_of_place_3 = theta3_ddot_of_place_2
        .mul_add(sin_theta3, theta3_ddot_of_place * cos_theta3);
    let cos_theta3_doubled = S::int(2) * cos_theta3;
    // theta3_ddot_of_place_3*cos_theta3_doubled - theta3_ddot_of_place
    let theta3_ddot_of_place_4 = theta3_ddot_of_place_3
        .mul_add(cos_theta3_doubled, -theta3_ddot_of_place);
    let cos_theta3_sq = cos_theta3 * cos_theta3;
    // -theta3_ddot_of_theta2_2 - cos_theta3_sq
    let theta3_ddot_of_place_5 = -theta3_ddot_of_theta2_2 - cos_theta3_sq;
    // theta3_ddot_of_theta2 - sin(theta3)*cos(theta3)
    let theta3_ddot_of_place_6 = (-sin_theta3)
        .mul_add(cos_theta3, theta3_ddot_of_theta2);
    // theta3_ddot_of_place_5*sin(theta1) - theta3_ddot_of_place_6*cos(theta1)
    let theta3_ddot_of_place_7 = (-theta3_ddot_of_place_6)
        .mul_add(cos_theta1, theta3_ddot_of_place_5 * sin_theta1);
    let sin_theta2_sin_theta3 = sin_theta2 * sin_theta3;
    // cos(theta2)*cos(theta3) + sin_theta2_sin_theta3
    let theta3_ddot_of_place_8 = cos_theta2.mul_add(cos_theta3, sin_theta2_sin_theta3);
    // 5*cos(theta3) - cos_theta2_times_9*theta3_ddot_of_place_8
    let theta3_ddot_of_place_9 = (-cos_theta2_times_9)
        .mul_add(theta3_ddot_of_place_8, S::int(5) * cos_theta3);
    // 1/(9 + theta3_ddot_of_place_7*sin(theta1) + theta3_ddot_of_place_9*cos(theta3))
    let theta3_ddot_of_place_10 = S::int(1)
        / (theta3_ddot_of_place_7.mul_add(sin_theta1, S::int(9))
            + theta3_ddot_of_place_9 * cos_theta3);
    let theta3_ddot_of_place_11 = S::ratio(1, 2) * theta3_ddot_of_place_10;
    let theta3_ddot_of_place_12 = S::ratio(3, 2) * theta3_ddot_of_place_10;
    let theta2_dot_sq = theta2_dot * theta2_dot;
    let cos_theta1_sin_theta2 = cos_theta1 * sin_theta2;
    let sin_theta1_cos_theta2 = sin_theta1 * cos_theta2;
    // sin_theta1_cos_theta2 - cos_theta1_sin_theta2
    let theta3_ddot_of_place_13 = sin_theta1_cos_theta2 - cos_theta1_sin_theta2;
    let theta3_ddot_of_place_14 = theta3_ddot_of_place_13 * cos_theta1;
    // 6*sin(theta2) - theta3_ddot_of_place_14
    let theta3_ddot_of_place_15 = sin_theta2
        .mul_add(S::int(6), -theta3_ddot_of_place_14);
    let sin_theta1_sin_theta2 = sin_theta1 * sin_theta2;
    // cos(theta1)*cos(theta2) + sin_theta1_sin_theta2
    let theta3_ddot_of_place_16 = cos_theta1.mul_add(cos_theta2, sin_theta1_sin_theta2);
    let cos_theta1_sin_theta3 = cos_theta1 * sin_theta3;
    let cos_theta2_sin_theta3 = cos_theta2 * sin_theta3;
    // theta3_ddot_of_place_15*cos(theta3) + theta3_ddot_of_place_16*cos_theta1_sin_theta3
    let theta3_ddot_of_place_17 = theta3_ddot_of_place_16
        .mul_add(cos_theta1_sin_theta3, theta3_ddot_of_place_15 * cos_theta3);
    // 7*cos_theta2_sin_theta3 - theta3_ddot_of_place_17
    let theta3_ddot_of_place_18 = cos_theta2_sin_theta3
        .mul_add(S::int(7), -theta3_ddot_of_place_17);
    let theta1_dot_sq = theta1_dot * theta1_dot;
    let cos_theta2_times_3 = S::int(3) * cos_theta2;
    // cos_theta3_doubled*sin(theta1) + cos_theta1_sin_theta3
    let theta3_ddot_of_place_19 = cos_theta3_doubled
        .mul_add(sin_theta1, cos_theta1_sin_theta3);
    // cos_theta2_times_3*(theta3_ddot_of_place_13*cos(theta3) + theta3_ddot_of_place_16*sin(theta3)) -
    //   theta3_ddot_of_place_19
    let theta3_ddot_of_place_20 = cos_theta2_times_3
        * theta3_ddot_of_place_16
            .mul_add(sin_theta3, theta3_ddot_of_place_13 * cos_theta3) - theta3_ddot_of_place_19;
    // theta3'' = (theta3'^2*(sin(theta1)*cos(theta1) - 9*sin(theta2)*cos(theta2)) -
    //   3*sin(theta3)*(cos(theta1)*(theta1'^2*(3*cos(theta2)^2 - 1) - theta2'^2*(sin(theta1)*sin(theta2) +
    //   cos(theta1)*cos(theta2))) + cos(theta2)*(3*theta1'^2*sin(theta1)*sin(theta2) + 7*theta2'^2)) +
    //   cos(theta3)*(3*theta1'^2*(3*cos(theta1)*sin(theta2)*cos(theta2) - sin(theta1)*(3*cos(theta2)^2 - 2))
    //   + 3*theta2'^2*(6*sin(theta2) + cos(theta1)*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2))) +
    //   2*theta3'^2*(sin(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2) +
    //   cos(theta3)*(9*sin(theta2)*cos(theta2) - sin(theta1)*cos(theta1)))))/(2*(9 +
    //   sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)))))
    let theta3_ddot = -theta3_ddot_of_place_12
        * theta1_dot_sq
            .mul_add(theta3_ddot_of_place_20, theta2_dot_sq * theta3_ddot_of_place_18)
        + theta3_dot_sq * theta3_ddot_of_place_4 * theta3_ddot_of_place_11;
    let cos_theta2_doubled = S::int(2) * cos_theta2;
    let theta2_ddot_of_place = cos_theta2_doubled * cos_theta1;
    // sin_theta1_sin_theta2 + theta2_ddot_of_place
    let theta2_ddot_of_place_2 = sin_theta1_sin_theta2 + theta2_ddot_of_place;
    let theta2_ddot_of_theta2 = cos_theta2_times_3 * cos_theta2;
    // 1/(3*sin_theta1_sin_theta2*theta2_ddot_of_place_2 - 7 + cos_theta1_sq*theta2_ddot_of_theta2)
    let theta2_ddot_of_place_3 = S::int(1)
        / ((sin_theta1_sin_theta2 * theta2_ddot_of_place_2)
            .mul_add(S::int(3), -S::int(7)) + cos_theta1_sq * theta2_ddot_of_theta2);
    let theta2_ddot_of_place_4 = S::int(3) * theta2_ddot_of_place_3;
    // cos(theta1)*(theta3_ddot_of_place_13*cos_theta2_doubled - sin(theta1))
    let theta2_ddot_of_place_5 = cos_theta1
        * theta3_ddot_of_place_13.mul_add(cos_theta2_doubled, -sin_theta1);
    // theta3''*cos(theta3) - theta3_dot_sq*sin(theta3)
    let theta2_ddot_of_motion = (-theta3_dot_sq)
        .mul_add(sin_theta3, theta3_ddot * cos_theta3);
    let theta2_ddot_of_place_6 = theta3_ddot_of_place_16 * cos_theta1;
    // cos_theta2_times_3 - theta2_ddot_of_place_6
    let theta2_ddot_of_place_7 = cos_theta2_times_3 - theta2_ddot_of_place_6;
    // theta3''*sin(theta3) + theta3_dot_sq*cos(theta3)
    let theta2_ddot_of_motion_2 = theta3_dot_sq
        .mul_add(cos_theta3, theta3_ddot * sin_theta3);
    // 2*sin(theta2) - theta3_ddot_of_place_14
    let theta2_ddot_of_place_8 = sin_theta2.mul_add(S::int(2), -theta3_ddot_of_place_14);
    let theta2_ddot_of_theta2_dot = theta2_dot_sq * cos_theta2_times_3;
    let theta1_dot_sq_times_3 = S::int(3) * theta1_dot_sq;
    // theta2_ddot_of_motion*theta2_ddot_of_place_7 + theta2_ddot_of_motion_2*theta2_ddot_of_place_8
    let theta2_ddot_of_motion_3 = theta2_ddot_of_motion_2
        .mul_add(theta2_ddot_of_place_8, theta2_ddot_of_motion * theta2_ddot_of_place_7);
    // theta2_ddot_of_theta2_dot*sin(theta2) + theta3_ddot_of_place_13*theta1_dot_sq_times_3
    let theta2_ddot_of_motion_4 = theta3_ddot_of_place_13
        .mul_add(theta1_dot_sq_times_3, theta2_ddot_of_theta2_dot * sin_theta2);
    // theta2'' = (sin(theta1)*(3*theta1'^2*cos(theta2) + sin(theta1)*sin(theta2)*(3*theta2'^2*cos(theta2)
    //   + theta3'^2*cos(theta3) + theta3''*sin(theta3)) + cos(theta1)*(cos(theta2)*(3*theta2'^2*cos(theta2)
    //   + theta3'^2*cos(theta3) + theta3''*sin(theta3)) - sin(theta2)*(3*theta2'^2*sin(theta2) +
    //   theta3'^2*sin(theta3) - theta3''*cos(theta3)))) + cos(theta2)*(3*theta3'^2*sin(theta3) -
    //   3*theta3''*cos(theta3) + cos(theta1)^2*(theta3''*cos(theta3) - 3*theta2'^2*sin(theta2) -
    //   theta3'^2*sin(theta3))) - 3*sin(theta2)*(theta1'^2*cos(theta1) + theta3'^2*cos(theta3) +
    //   theta3''*sin(theta3)))/(7 - 3*cos(theta1)^2*cos(theta2)^2 -
    //   3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)))
    let theta2_ddot = theta2_ddot_of_place_3 * (theta2_ddot_of_motion_3 - theta2_ddot_of_motion_4)
        - theta2_dot_sq * theta2_ddot_of_place_4 * theta2_ddot_of_place_5;
    let theta1_ddot_of_theta2_dot = theta2_dot_sq * theta3_ddot_of_place_13;
    // theta2_ddot_of_motion*cos(theta1) + theta2_ddot_of_motion_2*sin(theta1)
    let theta1_ddot_of_motion = theta2_ddot_of_motion_2
        .mul_add(sin_theta1, theta2_ddot_of_motion * cos_theta1);
    // theta1'' = cos(theta1)*(3*theta2'^2*sin(theta2) + theta3'^2*sin(theta3) - 3*theta2''*cos(theta2) -
    //   theta3''*cos(theta3))/3 - sin(theta1)*(3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3) +
    //   3*theta2''*sin(theta2) + theta3''*sin(theta3))/3
    let theta1_ddot = (-theta2_ddot)
        .mul_add(theta3_ddot_of_place_16, -theta1_ddot_of_theta2_dot)
        - S::ratio(1, 3) * theta1_ddot_of_motion;
    // theta2_ddot_of_theta2 - 2
    let theta3_ddot_by_theta1_of_theta2 = theta2_ddot_of_theta2 - S::int(2);
    let theta2_dot_sq_times_3 = S::int(3) * theta2_dot_sq;
    // sin(theta1)^2 - cos_theta1_sq
    let theta3_ddot_by_theta1_of_theta1 = sin_theta1.mul_add(sin_theta1, -cos_theta1_sq);
    let theta3_dot_sq_doubled = S::int(2) * theta3_dot_sq;
    let theta3_ddot_by_theta1_of_theta2_dot = theta2_dot_sq * theta3_ddot_of_place_16;
    // theta1_dot_sq*(theta2_ddot_of_theta2 - 1) - theta3_ddot_by_theta1_of_theta2_dot
    let theta3_ddot_by_theta1_of_motion = theta1_dot_sq
        * (theta2_ddot_of_theta2 - S::int(1)) - theta3_ddot_by_theta1_of_theta2_dot;
    let theta3_ddot_by_theta1_of_theta1_dot = theta1_dot_sq * cos_theta2_times_3;
    let sin_theta3_times_3 = S::int(3) * sin_theta3;
    // theta1_dot_sq_times_3*(cos_theta1_sin_theta2*cos_theta2_times_3 -
    //   theta3_ddot_by_theta1_of_theta2*sin(theta1)) + theta3_ddot_of_place_15*theta2_dot_sq_times_3 +
    //   theta3_ddot_of_place_3*theta3_dot_sq_doubled
    let theta3_ddot_by_theta1_of_motion_2 = theta1_dot_sq_times_3
        * (-theta3_ddot_by_theta1_of_theta2)
            .mul_add(sin_theta1, cos_theta1_sin_theta2 * cos_theta2_times_3)
        + theta3_ddot_of_place_15 * theta2_dot_sq_times_3
        + theta3_ddot_of_place_3 * theta3_dot_sq_doubled;
    // 7*theta2_dot_sq + sin_theta1_sin_theta2*theta1_dot_sq_times_3
    let theta3_ddot_by_theta1_of_motion_3 = sin_theta1_sin_theta2
        .mul_add(theta1_dot_sq_times_3, S::int(7) * theta2_dot_sq);
    // theta3_ddot_by_theta1_of_motion*cos(theta1) + theta3_ddot_by_theta1_of_motion_3*cos(theta2)
    let theta3_ddot_by_theta1_of_motion_4 = theta3_ddot_by_theta1_of_motion_3
        .mul_add(cos_theta2, theta3_ddot_by_theta1_of_motion * cos_theta1);
    // theta3_ddot_of_place_10*(theta3_ddot_by_theta1_of_motion_2*cos(theta3) -
    //   theta3_dot_sq*theta3_ddot_of_place - sin_theta3_times_3*theta3_ddot_by_theta1_of_motion_4)
    let theta3_ddot_by_theta1_of_motion_5 = theta3_ddot_of_place_10
        * ((-theta3_dot_sq)
            .mul_add(
                theta3_ddot_of_place,
                theta3_ddot_by_theta1_of_motion_2 * cos_theta3,
            ) - sin_theta3_times_3 * theta3_ddot_by_theta1_of_motion_4);
    let theta3_ddot_by_theta1_of_motion_6 = theta3_ddot_of_place_11
        * theta3_ddot_by_theta1_of_motion_5;
    // theta3_ddot_by_theta1 = (cos(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) +
    //   sin(theta1)*(cos(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   sin(theta1)*(9*sin(theta2)*cos(theta2) -
    //   sin(theta3)*cos(theta3))))*(3*sin(theta3)*(cos(theta1)*(theta1'^2*(3*cos(theta2)^2 - 1) -
    //   theta2'^2*(sin(theta1)*sin(theta2) + cos(theta1)*cos(theta2))) +
    //   cos(theta2)*(3*theta1'^2*sin(theta1)*sin(theta2) + 7*theta2'^2)) -
    //   theta3'^2*(sin(theta1)*cos(theta1) - 9*sin(theta2)*cos(theta2)) -
    //   cos(theta3)*(3*theta1'^2*(3*cos(theta1)*sin(theta2)*cos(theta2) - sin(theta1)*(3*cos(theta2)^2 - 2))
    //   + 3*theta2'^2*(6*sin(theta2) + cos(theta1)*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2))) +
    //   2*theta3'^2*(sin(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2) +
    //   cos(theta3)*(9*sin(theta2)*cos(theta2) - sin(theta1)*cos(theta1)))))/(2*(9 +
    //   sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3))))^2) -
    //   (3*sin(theta3)*(3*theta1'^2*cos(theta1)*sin(theta2)*cos(theta2) -
    //   theta2'^2*cos(theta1)*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2)) -
    //   sin(theta1)*(theta1'^2*(3*cos(theta2)^2 - 1) - theta2'^2*(sin(theta1)*sin(theta2) +
    //   cos(theta1)*cos(theta2)))) + theta3'^2*(sin(theta1)^2 - cos(theta1)^2) +
    //   cos(theta3)*(3*theta1'^2*(3*sin(theta1)*sin(theta2)*cos(theta2) + cos(theta1)*(3*cos(theta2)^2 - 2))
    //   + 3*theta2'^2*(cos(theta1)*(sin(theta1)*sin(theta2) + cos(theta1)*cos(theta2)) -
    //   sin(theta1)*(sin(theta1)*cos(theta2) - cos(theta1)*sin(theta2))) +
    //   2*theta3'^2*(2*sin(theta1)*cos(theta1)*sin(theta3) + cos(theta3)*(cos(theta1)^2 -
    //   sin(theta1)^2))))/(2*(9 + sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)))))
    let theta3_ddot_by_theta1 = -theta3_ddot_of_place_11
        * (cos_theta3
            * (theta1_dot_sq_times_3
                * theta3_ddot_by_theta1_of_theta2
                    .mul_add(cos_theta1, sin_theta1_sin_theta2 * cos_theta2_times_3)
                + theta2_dot_sq_times_3
                    * (-theta3_ddot_of_place_13)
                        .mul_add(sin_theta1, theta2_ddot_of_place_6)
                + theta3_dot_sq_doubled
                    * (-theta3_ddot_by_theta1_of_theta1)
                        .mul_add(
                            cos_theta3,
                            S::int(2) * cos_theta1_sin_theta3 * sin_theta1,
                        )) + theta3_dot_sq * theta3_ddot_by_theta1_of_theta1
            + sin_theta3_times_3
                * ((-theta3_ddot_by_theta1_of_motion)
                    .mul_add(sin_theta1, theta2_dot_sq * theta3_ddot_of_place_14)
                    + cos_theta1_sin_theta2 * theta3_ddot_by_theta1_of_theta1_dot))
        - theta3_ddot_by_theta1_of_motion_6
            * (sin_theta1
                * theta3_ddot_of_place_6
                    .mul_add(sin_theta1, theta3_ddot_of_place_5 * cos_theta1)
                + theta3_ddot_of_place_7 * cos_theta1);
    let sin_theta2_times_3 = S::int(3) * sin_theta2;
    let theta2_ddot_by_theta1_of_theta2_dot = theta2_dot_sq * sin_theta2_times_3;
    // theta2_ddot_by_theta1_of_theta2_dot - theta2_ddot_of_motion
    let theta2_ddot_by_theta1_of_motion = theta2_ddot_by_theta1_of_theta2_dot
        - theta2_ddot_of_motion;
    // theta2_ddot_of_motion_2 + theta2_ddot_of_theta2_dot
    let theta2_ddot_by_theta1_of_motion_2 = theta2_ddot_of_motion_2 + theta2_ddot_of_theta2_dot;
    // theta2_ddot_by_theta1_of_motion*sin(theta2) - theta2_ddot_by_theta1_of_motion_2*cos(theta2)
    let theta2_ddot_by_theta1_of_motion_3 = (-theta2_ddot_by_theta1_of_motion_2)
        .mul_add(cos_theta2, theta2_ddot_by_theta1_of_motion * sin_theta2);
    // theta3_ddot_by_theta1_of_theta1_dot + sin_theta1_sin_theta2*theta2_ddot_by_theta1_of_motion_2 -
    //   theta2_ddot_by_theta1_of_motion_3*cos(theta1)
    let theta2_ddot_by_theta1_of_motion_4 = sin_theta1_sin_theta2
        .mul_add(theta2_ddot_by_theta1_of_motion_2, theta3_ddot_by_theta1_of_theta1_dot)
        - theta2_ddot_by_theta1_of_motion_3 * cos_theta1;
    let sin_theta2_cos_theta3 = sin_theta2 * cos_theta3;
    let theta2_ddot_by_theta1_of_place = theta3_ddot_by_theta1 * sin_theta3;
    let cos_theta3_times_3 = S::int(3) * cos_theta3;
    // -3*theta2_ddot_of_motion - cos_theta1_sq*theta2_ddot_by_theta1_of_motion
    let theta2_ddot_by_theta1_of_motion_5 = (-cos_theta1_sq)
        .mul_add(theta2_ddot_by_theta1_of_motion, -S::int(3) * theta2_ddot_of_motion);
    // theta1_dot_sq*cos(theta1) + theta2_ddot_of_motion_2
    let theta2_ddot_by_theta1_of_motion_6 = theta1_dot_sq
        .mul_add(cos_theta1, theta2_ddot_of_motion_2);
    // theta2_ddot_of_place_3*theta2_ddot_of_place_4*(theta2_ddot_by_theta1_of_motion_4*sin(theta1) +
    //   theta2_ddot_by_theta1_of_motion_5*cos(theta2) -
    //   sin_theta2_times_3*theta2_ddot_by_theta1_of_motion_6)
    let theta2_ddot_by_theta1_of_motion_7 = theta2_ddot_of_place_3 * theta2_ddot_of_place_4
        * (theta2_ddot_by_theta1_of_motion_5
            .mul_add(cos_theta2, theta2_ddot_by_theta1_of_motion_4 * sin_theta1)
            - sin_theta2_times_3 * theta2_ddot_by_theta1_of_motion_6);
    // theta2_ddot_by_theta1 = 3*(cos(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) +
    //   2*cos(theta1)*cos(theta2)) - 2*sin(theta1)*cos(theta1)*cos(theta2)^2 +
    //   sin(theta1)*sin(theta2)*(cos(theta1)*sin(theta2) -
    //   2*sin(theta1)*cos(theta2)))*(sin(theta1)*(3*theta1'^2*cos(theta2) +
    //   sin(theta1)*sin(theta2)*(3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3) + theta3''*sin(theta3)) +
    //   cos(theta1)*(cos(theta2)*(3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3) + theta3''*sin(theta3)) -
    //   sin(theta2)*(3*theta2'^2*sin(theta2) + theta3'^2*sin(theta3) - theta3''*cos(theta3)))) +
    //   cos(theta2)*(3*theta3'^2*sin(theta3) - 3*theta3''*cos(theta3) + cos(theta1)^2*(theta3''*cos(theta3)
    //   - 3*theta2'^2*sin(theta2) - theta3'^2*sin(theta3))) - 3*sin(theta2)*(theta1'^2*cos(theta1) +
    //   theta3'^2*cos(theta3) + theta3''*sin(theta3)))/(3*cos(theta1)^2*cos(theta2)^2 - 7 +
    //   3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)))^2 +
    //   (cos(theta1)*(3*theta1'^2*cos(theta2) + sin(theta1)*sin(theta2)*(3*theta2'^2*cos(theta2) +
    //   theta3'^2*cos(theta3) + theta3''*sin(theta3)) + cos(theta1)*(cos(theta2)*(3*theta2'^2*cos(theta2) +
    //   theta3'^2*cos(theta3) + theta3''*sin(theta3)) - sin(theta2)*(3*theta2'^2*sin(theta2) +
    //   theta3'^2*sin(theta3) - theta3''*cos(theta3)))) +
    //   sin(theta1)*(cos(theta1)*sin(theta2)*(3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3) +
    //   theta3''*sin(theta3)) + sin(theta1)*(sin(theta2)*(3*theta2'^2*sin(theta2) + theta3'^2*sin(theta3) -
    //   theta3''*cos(theta3)) - cos(theta2)*(3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3) +
    //   theta3''*sin(theta3))) + theta3_ddot_by_theta1*sin(theta1)*sin(theta2)*sin(theta3) +
    //   cos(theta1)*(theta3_ddot_by_theta1*cos(theta2)*sin(theta3) +
    //   theta3_ddot_by_theta1*sin(theta2)*cos(theta3))) +
    //   cos(theta2)*(theta3_ddot_by_theta1*cos(theta1)^2*cos(theta3) -
    //   2*sin(theta1)*cos(theta1)*(theta3''*cos(theta3) - 3*theta2'^2*sin(theta2) - theta3'^2*sin(theta3)) -
    //   3*theta3_ddot_by_theta1*cos(theta3)) + 3*sin(theta2)*(theta1'^2*sin(theta1) -
    //   theta3_ddot_by_theta1*sin(theta3)))/(7 - 3*cos(theta1)^2*cos(theta2)^2 -
    //   3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)))
    let theta2_ddot_by_theta1 = theta2_ddot_by_theta1_of_motion_7
        * (sin_theta1_sin_theta2 * (-cos_theta2_doubled).mul_add(sin_theta1, cos_theta1_sin_theta2)
            - sin_theta1_cos_theta2 * theta2_ddot_of_place
            + cos_theta1_sin_theta2 * theta2_ddot_of_place_2)
        - theta2_ddot_of_place_3
            * (sin_theta1
                * (cos_theta1_sin_theta2 * theta2_ddot_by_theta1_of_motion_2
                    + theta2_ddot_by_theta1_of_motion_3 * sin_theta1
                    + theta3_ddot_by_theta1 * cos_theta1
                        * (cos_theta2_sin_theta3 + sin_theta2_cos_theta3)
                    + sin_theta1_sin_theta2 * theta2_ddot_by_theta1_of_place)
                + theta2_ddot_by_theta1_of_motion_4 * cos_theta1
                + sin_theta2_times_3
                    * theta1_dot_sq.mul_add(sin_theta1, -theta2_ddot_by_theta1_of_place)
                + cos_theta2
                    * (theta3_ddot_by_theta1
                        * cos_theta1_sq.mul_add(cos_theta3, -cos_theta3_times_3)
                        + S::int(2) * sin_theta1_cos_theta1 * theta2_ddot_by_theta1_of_motion));
    let sin_theta1_sin_theta3 = sin_theta1 * sin_theta3;
    // cos(theta1)*cos(theta3) + sin_theta1_sin_theta3
    let theta1_ddot_by_theta1_of_place = cos_theta1
        .mul_add(cos_theta3, sin_theta1_sin_theta3);
    let theta1_ddot_by_theta1_of_place_2 = S::ratio(1, 3) * theta1_ddot_by_theta1_of_place;
    let theta1_ddot_by_theta1_of_theta2_ddot = theta2_ddot * theta3_ddot_of_place_13;
    // theta2_ddot_of_motion*sin(theta1) - theta2_ddot_of_motion_2*cos(theta1)
    let theta1_ddot_by_theta1_of_motion = (-theta2_ddot_of_motion_2)
        .mul_add(cos_theta1, theta2_ddot_of_motion * sin_theta1);
    let theta1_ddot_by_theta1_of_motion_2 = S::ratio(1, 3) * theta1_ddot_by_theta1_of_motion;
    // theta1_ddot_by_theta1 = sin(theta1)*(3*theta2''*cos(theta2) + theta3''*cos(theta3) -
    //   sin(theta3)*(theta3'^2 + theta3_ddot_by_theta1) - 3*sin(theta2)*(theta2'^2 +
    //   theta2_ddot_by_theta1))/3 - cos(theta1)*(3*theta2''*sin(theta2) + theta3''*sin(theta3) +
    //   cos(theta3)*(theta3'^2 + theta3_ddot_by_theta1) + 3*cos(theta2)*(theta2'^2 +
    //   theta2_ddot_by_theta1))/3
    let theta1_ddot_by_theta1 = (-theta2_ddot_by_theta1)
        .mul_add(theta3_ddot_of_place_16, theta1_ddot_by_theta1_of_theta2_ddot)
        - theta3_ddot_by_theta1_of_theta2_dot
        - theta3_ddot_by_theta1 * theta1_ddot_by_theta1_of_place_2
        + theta1_ddot_by_theta1_of_motion_2;
    let l_by_3 = S::ratio(1, 3) * l;
    let sin_theta1_l_by_3 = l_by_3 * sin_theta1;
    let l_halved = S::ratio(1, 2) * l;
    let cos_theta2_l_halved = l_halved * cos_theta2;
    let l_by_6 = S::ratio(1, 6) * l;
    let cos_theta3_l_by_6 = l_by_6 * cos_theta3;
    let cos_theta1_l_by_3 = l_by_3 * cos_theta1;
    // theta1_ddot_by_theta1 - theta1_dot_sq
    let y_ddot_by_theta1_of_theta1_dot = theta1_ddot_by_theta1 - theta1_dot_sq;
    // y_ddot_by_theta1 = l*(2*theta1''*sin(theta1) - theta3_ddot_by_theta1*cos(theta3) -
    //   3*theta2_ddot_by_theta1*cos(theta2) + 2*cos(theta1)*(theta1'^2 - theta1_ddot_by_theta1))/6
    let y_ddot_by_theta1 = (-theta2_ddot_by_theta1)
        .mul_add(cos_theta2_l_halved, theta1_ddot * sin_theta1_l_by_3)
        - theta3_ddot_by_theta1 * cos_theta3_l_by_6
        - cos_theta1_l_by_3 * y_ddot_by_theta1_of_theta1_dot;
    let sin_theta2_l_halved = l_halved * sin_theta2;
    let sin_theta3_l_by_6 = l_by_6 * sin_theta3;
    // x_ddot_by_theta1 = l*(2*theta1''*cos(theta1) + theta3_ddot_by_theta1*sin(theta3) +
    //   3*theta2_ddot_by_theta1*sin(theta2) + 2*sin(theta1)*(theta1_ddot_by_theta1 - theta1'^2))/6
    let x_ddot_by_theta1 = sin_theta1_l_by_3
        .mul_add(y_ddot_by_theta1_of_theta1_dot, theta1_ddot * cos_theta1_l_by_3)
        + theta2_ddot_by_theta1 * sin_theta2_l_halved + theta3_ddot_by_theta1 * sin_theta3_l_by_6;
    let cos_theta2_sq = cos_theta2 * cos_theta2;
    // sin(theta2)^2 - cos_theta2_sq
    let theta3_ddot_by_theta2_of_theta2 = sin_theta2.mul_add(sin_theta2, -cos_theta2_sq);
    let theta3_ddot_by_theta2_of_place = sin_theta1_sin_theta2 * cos_theta2_doubled;
    let sin_theta2_cos_theta2 = sin_theta2 * cos_theta2;
    // sin_theta2_cos_theta3 - cos_theta2_sin_theta3
    let theta3_ddot_by_theta2_of_place_2 = sin_theta2_cos_theta3 - cos_theta2_sin_theta3;
    // theta3_ddot_by_theta2 = 9*(sin(theta1)*(2*sin(theta1)*sin(theta2)*cos(theta2) +
    //   cos(theta1)*(cos(theta2)^2 - sin(theta2)^2)) - cos(theta3)*(sin(theta2)*(sin(theta2)*sin(theta3) +
    //   cos(theta2)*cos(theta3)) + cos(theta2)*(sin(theta2)*cos(theta3) -
    //   cos(theta2)*sin(theta3))))*(theta3'^2*(sin(theta1)*cos(theta1) - 9*sin(theta2)*cos(theta2)) -
    //   3*sin(theta3)*(cos(theta1)*(theta1'^2*(3*cos(theta2)^2 - 1) - theta2'^2*(sin(theta1)*sin(theta2) +
    //   cos(theta1)*cos(theta2))) + cos(theta2)*(3*theta1'^2*sin(theta1)*sin(theta2) + 7*theta2'^2)) +
    //   cos(theta3)*(3*theta1'^2*(3*cos(theta1)*sin(theta2)*cos(theta2) - sin(theta1)*(3*cos(theta2)^2 - 2))
    //   + 3*theta2'^2*(6*sin(theta2) + cos(theta1)*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2))) +
    //   2*theta3'^2*(sin(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2) +
    //   cos(theta3)*(9*sin(theta2)*cos(theta2) - sin(theta1)*cos(theta1)))))/(2*(9 +
    //   sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3))))^2) +
    //   3*(sin(theta3)*(sin(theta2)*(3*theta1'^2*sin(theta1)*sin(theta2) + 7*theta2'^2) -
    //   3*theta1'^2*sin(theta1)*cos(theta2)^2 + cos(theta1)*(6*theta1'^2*sin(theta2)*cos(theta2) +
    //   theta2'^2*(sin(theta1)*cos(theta2) - cos(theta1)*sin(theta2)))) + 3*theta3'^2*(sin(theta2)^2 -
    //   cos(theta2)^2) + cos(theta3)*(3*theta1'^2*(cos(theta1)*cos(theta2)^2 - cos(theta1)*sin(theta2)^2 +
    //   2*sin(theta1)*sin(theta2)*cos(theta2)) + theta2'^2*(6*cos(theta2) +
    //   cos(theta1)*(sin(theta1)*sin(theta2) + cos(theta1)*cos(theta2))) +
    //   6*theta3'^2*(2*sin(theta2)*cos(theta2)*sin(theta3) + cos(theta3)*(cos(theta2)^2 -
    //   sin(theta2)^2))))/(2*(9 + sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)))))
    let theta3_ddot_by_theta2 = theta3_ddot_of_place_12
        * (cos_theta3
            * (theta2_dot_sq * cos_theta2.mul_add(S::int(6), theta2_ddot_of_place_6)
                + S::int(6) * theta3_dot_sq
                    * (-theta3_ddot_by_theta2_of_theta2)
                        .mul_add(cos_theta3, sin_theta2_sin_theta3 * cos_theta2_doubled)
                + theta1_dot_sq_times_3
                    * ((-cos_theta1_sin_theta2)
                        .mul_add(sin_theta2, cos_theta2_sq * cos_theta1)
                        + theta3_ddot_by_theta2_of_place))
            + S::int(3) * theta3_dot_sq * theta3_ddot_by_theta2_of_theta2
            + sin_theta3
                * (theta3_ddot_by_theta1_of_motion_3 * sin_theta2
                    - sin_theta1_cos_theta2 * theta3_ddot_by_theta1_of_theta1_dot
                    + cos_theta1
                        * (theta1_dot_sq * sin_theta2_cos_theta2)
                            .mul_add(S::int(6), theta1_ddot_of_theta2_dot)))
        + S::ratio(9, 2) * theta3_ddot_of_place_10 * theta3_ddot_by_theta1_of_motion_5
            * (sin_theta1
                * (-theta3_ddot_by_theta2_of_theta2)
                    .mul_add(cos_theta1, theta3_ddot_by_theta2_of_place)
                - cos_theta3
                    * theta3_ddot_by_theta2_of_place_2
                        .mul_add(cos_theta2, theta3_ddot_of_place_8 * sin_theta2));
    // theta2_ddot_of_theta2_dot - theta3_ddot_by_theta2*cos(theta3)
    let theta2_ddot_by_theta2_of_theta2_dot = (-theta3_ddot_by_theta2)
        .mul_add(cos_theta3, theta2_ddot_of_theta2_dot);
    let theta2_ddot_by_theta2_of_place = theta3_ddot_by_theta2 * sin_theta3;
    // theta2_ddot_by_theta1_of_theta2_dot - theta2_ddot_by_theta2_of_place
    let theta2_ddot_by_theta2_of_theta2_dot_2 = theta2_ddot_by_theta1_of_theta2_dot
        - theta2_ddot_by_theta2_of_place;
    // theta2_ddot_by_theta2 = 3*(sin(theta1)*cos(theta2)*(sin(theta1)*sin(theta2) +
    //   2*cos(theta1)*cos(theta2)) - 2*cos(theta1)^2*sin(theta2)*cos(theta2) +
    //   sin(theta1)*sin(theta2)*(sin(theta1)*cos(theta2) -
    //   2*cos(theta1)*sin(theta2)))*(sin(theta1)*(3*theta1'^2*cos(theta2) +
    //   sin(theta1)*sin(theta2)*(3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3) + theta3''*sin(theta3)) +
    //   cos(theta1)*(cos(theta2)*(3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3) + theta3''*sin(theta3)) -
    //   sin(theta2)*(3*theta2'^2*sin(theta2) + theta3'^2*sin(theta3) - theta3''*cos(theta3)))) +
    //   cos(theta2)*(3*theta3'^2*sin(theta3) - 3*theta3''*cos(theta3) + cos(theta1)^2*(theta3''*cos(theta3)
    //   - 3*theta2'^2*sin(theta2) - theta3'^2*sin(theta3))) - 3*sin(theta2)*(theta1'^2*cos(theta1) +
    //   theta3'^2*cos(theta3) + theta3''*sin(theta3)))/(3*cos(theta1)^2*cos(theta2)^2 - 7 +
    //   3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)))^2 +
    //   (sin(theta2)*(3*theta3'^2*sin(theta3) - 3*theta3''*cos(theta3) + cos(theta1)^2*(theta3''*cos(theta3)
    //   - 3*theta2'^2*sin(theta2) - theta3'^2*sin(theta3))) + 3*cos(theta2)*(theta1'^2*cos(theta1) +
    //   theta3'^2*cos(theta3) + theta3''*sin(theta3)) + 3*theta3_ddot_by_theta2*sin(theta2)*sin(theta3) +
    //   sin(theta1)*(3*theta1'^2*sin(theta2) - sin(theta1)*cos(theta2)*(3*theta2'^2*cos(theta2) +
    //   theta3'^2*cos(theta3) + theta3''*sin(theta3)) + sin(theta1)*sin(theta2)*(3*theta2'^2*sin(theta2) -
    //   theta3_ddot_by_theta2*sin(theta3)) + cos(theta1)*(cos(theta2)*(3*theta2'^2*sin(theta2) +
    //   theta3'^2*sin(theta3) - theta3''*cos(theta3)) + sin(theta2)*(3*theta2'^2*cos(theta2) +
    //   theta3'^2*cos(theta3) + theta3''*sin(theta3)) + sin(theta2)*(3*theta2'^2*cos(theta2) -
    //   theta3_ddot_by_theta2*cos(theta3)) + cos(theta2)*(3*theta2'^2*sin(theta2) -
    //   theta3_ddot_by_theta2*sin(theta3)))) + cos(theta2)*(3*theta3_ddot_by_theta2*cos(theta3) +
    //   cos(theta1)^2*(3*theta2'^2*cos(theta2) -
    //   theta3_ddot_by_theta2*cos(theta3))))/(3*cos(theta1)^2*cos(theta2)^2 - 7 +
    //   3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)))
    let theta2_ddot_by_theta2 = theta2_ddot_by_theta1_of_motion_7
        * (-sin_theta1_sin_theta2 * cos_theta1_sin_theta2.mul_add(S::int(2), -sin_theta1_cos_theta2)
            + sin_theta1_cos_theta2 * theta2_ddot_of_place_2
            - cos_theta1_sin_theta2 * theta2_ddot_of_place)
        + theta2_ddot_of_place_3
            * (theta2_ddot_by_theta1_of_motion_5 * sin_theta2
                + cos_theta2_times_3 * theta2_ddot_by_theta1_of_motion_6
                + cos_theta2
                    * cos_theta1_sq
                        .mul_add(
                            theta2_ddot_by_theta2_of_theta2_dot,
                            theta3_ddot_by_theta2 * cos_theta3_times_3,
                        ) + sin_theta2_times_3 * theta2_ddot_by_theta2_of_place
                + sin_theta1
                    * (theta1_dot_sq * sin_theta2_times_3
                        - sin_theta1_cos_theta2 * theta2_ddot_by_theta1_of_motion_2
                        + sin_theta1_sin_theta2 * theta2_ddot_by_theta2_of_theta2_dot_2
                        + cos_theta1
                            * (sin_theta2
                                * (theta2_ddot_by_theta1_of_motion_2
                                    + theta2_ddot_by_theta2_of_theta2_dot)
                                + cos_theta2
                                    * (theta2_ddot_by_theta1_of_motion
                                        + theta2_ddot_by_theta2_of_theta2_dot_2))));
    // theta2_ddot_by_theta2 - theta2_dot_sq
    let theta1_ddot_by_theta2_of_theta2_dot = theta2_ddot_by_theta2 - theta2_dot_sq;
    // theta1_ddot_by_theta2 = cos(theta1)*(3*theta2''*sin(theta2) - theta3_ddot_by_theta2*cos(theta3) +
    //   3*cos(theta2)*(theta2'^2 - theta2_ddot_by_theta2))/3 - sin(theta1)*(3*theta2''*cos(theta2) +
    //   theta3_ddot_by_theta2*sin(theta3) + 3*sin(theta2)*(theta2_ddot_by_theta2 - theta2'^2))/3
    let theta1_ddot_by_theta2 = (-theta3_ddot_by_theta2)
        .mul_add(theta1_ddot_by_theta1_of_place_2, -theta1_ddot_by_theta1_of_theta2_ddot)
        - theta3_ddot_of_place_16 * theta1_ddot_by_theta2_of_theta2_dot;
    // y_ddot_by_theta2 = l*(3*theta2''*sin(theta2) - theta3_ddot_by_theta2*cos(theta3) +
    //   3*cos(theta2)*(theta2'^2 - theta2_ddot_by_theta2) - 2*theta1_ddot_by_theta2*cos(theta1))/6
    let y_ddot_by_theta2 = (-theta3_ddot_by_theta2)
        .mul_add(cos_theta3_l_by_6, theta2_ddot * sin_theta2_l_halved)
        - theta1_ddot_by_theta2 * cos_theta1_l_by_3
        - cos_theta2_l_halved * theta1_ddot_by_theta2_of_theta2_dot;
    // x_ddot_by_theta2 = l*(3*theta2''*cos(theta2) + theta3_ddot_by_theta2*sin(theta3) +
    //   3*sin(theta2)*(theta2_ddot_by_theta2 - theta2'^2) + 2*theta1_ddot_by_theta2*sin(theta1))/6
    let x_ddot_by_theta2 = theta2_ddot
        .mul_add(cos_theta2_l_halved, theta1_ddot_by_theta2 * sin_theta1_l_by_3)
        + theta3_ddot_by_theta2 * sin_theta3_l_by_6
        + sin_theta2_l_halved * theta1_ddot_by_theta2_of_theta2_dot;
    // theta3_ddot_by_theta3 = (cos(theta3)*(5*sin(theta3) + 9*cos(theta2)*(sin(theta2)*cos(theta3) -
    //   cos(theta2)*sin(theta3))) - sin(theta3)*(9*cos(theta2)*(sin(theta2)*sin(theta3) +
    //   cos(theta2)*cos(theta3)) - 5*cos(theta3)) - sin(theta1)*(2*sin(theta1)*sin(theta3)*cos(theta3) +
    //   cos(theta1)*(cos(theta3)^2 - sin(theta3)^2)))*(theta3'^2*(sin(theta1)*cos(theta1) -
    //   9*sin(theta2)*cos(theta2)) - 3*sin(theta3)*(cos(theta1)*(theta1'^2*(3*cos(theta2)^2 - 1) -
    //   theta2'^2*(sin(theta1)*sin(theta2) + cos(theta1)*cos(theta2))) +
    //   cos(theta2)*(3*theta1'^2*sin(theta1)*sin(theta2) + 7*theta2'^2)) +
    //   cos(theta3)*(3*theta1'^2*(3*cos(theta1)*sin(theta2)*cos(theta2) - sin(theta1)*(3*cos(theta2)^2 - 2))
    //   + 3*theta2'^2*(6*sin(theta2) + cos(theta1)*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2))) +
    //   2*theta3'^2*(sin(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2) +
    //   cos(theta3)*(9*sin(theta2)*cos(theta2) - sin(theta1)*cos(theta1)))))/(2*(9 +
    //   sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3))))^2) +
    //   (2*theta3'^2*cos(theta3)*(sin(theta3)*(sin(theta1)*cos(theta1) - 9*sin(theta2)*cos(theta2)) +
    //   cos(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2)) -
    //   3*cos(theta3)*(cos(theta1)*(theta1'^2*(3*cos(theta2)^2 - 1) - theta2'^2*(sin(theta1)*sin(theta2) +
    //   cos(theta1)*cos(theta2))) + cos(theta2)*(3*theta1'^2*sin(theta1)*sin(theta2) + 7*theta2'^2)) -
    //   sin(theta3)*(3*theta1'^2*(3*cos(theta1)*sin(theta2)*cos(theta2) - sin(theta1)*(3*cos(theta2)^2 - 2))
    //   + 3*theta2'^2*(6*sin(theta2) + cos(theta1)*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2))) +
    //   2*theta3'^2*(sin(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2) +
    //   cos(theta3)*(9*sin(theta2)*cos(theta2) - sin(theta1)*cos(theta1)))))/(2*(9 +
    //   sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)))))
    let theta3_ddot_by_theta3 = theta3_ddot_by_theta1_of_motion_6
        * (sin_theta1
            * (cos_theta1 * sin_theta3.mul_add(sin_theta3, -cos_theta3_sq)
                - cos_theta3_doubled * sin_theta1_sin_theta3) + theta3_ddot_of_place_9 * sin_theta3
            + cos_theta3
                * cos_theta2_times_9
                    .mul_add(theta3_ddot_by_theta2_of_place_2, S::int(5) * sin_theta3))
        - theta3_ddot_of_place_11
            * (theta3_dot_sq * cos_theta3_doubled
                * (-theta3_ddot_of_place_2)
                    .mul_add(cos_theta3, theta3_ddot_of_place * sin_theta3)
                + theta3_ddot_by_theta1_of_motion_2 * sin_theta3
                + theta3_ddot_by_theta1_of_motion_4 * cos_theta3_times_3);
    // 1/(4 + theta2_ddot_of_theta2 - 3*cos(theta1)*(cos(theta1)*(cos_theta2_doubled*cos(theta2) - 1) +
    //   theta3_ddot_by_theta2_of_place))
    let theta2_ddot_by_theta3_of_place = S::int(1)
        / (S::int(4) + theta2_ddot_of_theta2
            - S::int(3) * cos_theta1
                * (cos_theta1 * cos_theta2_doubled.mul_add(cos_theta2, -S::int(1))
                    + theta3_ddot_by_theta2_of_place));
    // theta2_ddot_of_place_7*cos(theta3) + theta2_ddot_of_place_8*sin(theta3)
    let theta2_ddot_by_theta3_of_place_2 = theta2_ddot_of_place_8
        .mul_add(sin_theta3, theta2_ddot_of_place_7 * cos_theta3);
    let theta2_ddot_by_theta3_of_place_3 = theta2_ddot_by_theta3_of_place
        * theta2_ddot_by_theta3_of_place_2;
    // theta2_ddot_by_theta3 = (2*sin(theta2)*(theta3''*cos(theta3) + sin(theta3)*(theta3_ddot_by_theta3 -
    //   theta3'^2)) - 3*cos(theta2)*(theta3''*sin(theta3) + cos(theta3)*(theta3'^2 - theta3_ddot_by_theta3))
    //   + cos(theta1)*(sin(theta1)*(sin(theta2)*(theta3''*sin(theta3) + cos(theta3)*(theta3'^2 -
    //   theta3_ddot_by_theta3)) - cos(theta2)*(theta3''*cos(theta3) + sin(theta3)*(theta3_ddot_by_theta3 -
    //   theta3'^2))) + cos(theta1)*(cos(theta2)*(theta3''*sin(theta3) + cos(theta3)*(theta3'^2 -
    //   theta3_ddot_by_theta3)) + sin(theta2)*(theta3''*cos(theta3) + sin(theta3)*(theta3_ddot_by_theta3 -
    //   theta3'^2)))))/(3*cos(theta1)*(2*sin(theta1)*sin(theta2)*cos(theta2) + cos(theta1)*(2*cos(theta2)^2
    //   - 1)) - 4 - 3*cos(theta2)^2)
    let theta2_ddot_by_theta3 = theta2_ddot_by_theta3_of_place
        * (-theta2_ddot_of_motion)
            .mul_add(
                theta2_ddot_of_place_8,
                theta2_ddot_of_place_7 * theta2_ddot_of_motion_2,
            ) - theta3_ddot_by_theta3 * theta2_ddot_by_theta3_of_place_3;
    // theta1_ddot_by_theta3 = cos(theta1)*(theta3''*sin(theta3) + cos(theta3)*(theta3'^2 -
    //   theta3_ddot_by_theta3) - 3*theta2_ddot_by_theta3*cos(theta2))/3 - sin(theta1)*(theta3''*cos(theta3)
    //   + sin(theta3)*(theta3_ddot_by_theta3 - theta3'^2) + 3*theta2_ddot_by_theta3*sin(theta2))/3
    let theta1_ddot_by_theta3 = (-theta3_ddot_by_theta3)
        .mul_add(
            theta1_ddot_by_theta1_of_place_2,
            -theta2_ddot_by_theta3 * theta3_ddot_of_place_16,
        ) - theta1_ddot_by_theta1_of_motion_2;
    // y_ddot_by_theta3 = l*(theta3''*sin(theta3) + cos(theta3)*(theta3'^2 - theta3_ddot_by_theta3) -
    //   3*theta2_ddot_by_theta3*cos(theta2) - 2*theta1_ddot_by_theta3*cos(theta1))/6
    let y_ddot_by_theta3 = (-theta2_ddot_by_theta3)
        .mul_add(cos_theta2_l_halved, theta2_ddot_of_motion_2 * l_by_6)
        - theta3_ddot_by_theta3 * cos_theta3_l_by_6 - theta1_ddot_by_theta3 * cos_theta1_l_by_3;
    // x_ddot_by_theta3 = l*(theta3''*cos(theta3) + sin(theta3)*(theta3_ddot_by_theta3 - theta3'^2) +
    //   3*theta2_ddot_by_theta3*sin(theta2) + 2*theta1_ddot_by_theta3*sin(theta1))/6
    let x_ddot_by_theta3 = theta2_ddot_of_motion
        .mul_add(l_by_6, theta1_ddot_by_theta3 * sin_theta1_l_by_3)
        + theta2_ddot_by_theta3 * sin_theta2_l_halved + theta3_ddot_by_theta3 * sin_theta3_l_by_6;
    let theta3_ddot_by_theta1_dot_of_place = S::int(3) * theta3_ddot_of_place_10;
    // theta3_ddot_by_theta1_dot = 3*theta1'*(cos(theta1)*sin(theta3) + 2*sin(theta1)*cos(theta3) -
    //   3*cos(theta2)*(sin(theta1)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)) +
    //   cos(theta1)*(cos(theta2)*sin(theta3) - sin(theta2)*cos(theta3))))/(9 +
    //   sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3))))
    let theta3_ddot_by_theta1_dot = -theta1_dot * theta3_ddot_of_place_20
        * theta3_ddot_by_theta1_dot_of_place;
    // theta2_ddot_by_theta1_dot = (6*theta1'*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2)) +
    //   theta3_ddot_by_theta1_dot*(2*sin(theta2)*sin(theta3) + 3*cos(theta2)*cos(theta3) -
    //   cos(theta1)*(sin(theta1)*(cos(theta2)*sin(theta3) + sin(theta2)*cos(theta3)) +
    //   cos(theta1)*(cos(theta2)*cos(theta3) -
    //   sin(theta2)*sin(theta3)))))/(3*cos(theta1)*(2*sin(theta1)*sin(theta2)*cos(theta2) +
    //   cos(theta1)*(2*cos(theta2)^2 - 1)) - 4 - 3*cos(theta2)^2)
    let theta2_ddot_by_theta1_dot = (-theta3_ddot_by_theta1_dot)
        .mul_add(
            theta2_ddot_by_theta3_of_place_3,
            S::int(6) * theta1_dot * theta3_ddot_of_place_13 * theta2_ddot_by_theta3_of_place,
        );
    // theta1_ddot_by_theta1_dot = -sin(theta1)*(theta3_ddot_by_theta1_dot*sin(theta3) +
    //   3*theta2_ddot_by_theta1_dot*sin(theta2))/3 - cos(theta1)*(theta3_ddot_by_theta1_dot*cos(theta3) +
    //   3*theta2_ddot_by_theta1_dot*cos(theta2))/3
    let theta1_ddot_by_theta1_dot = (-theta3_ddot_by_theta1_dot)
        .mul_add(
            theta1_ddot_by_theta1_of_place_2,
            -theta2_ddot_by_theta1_dot * theta3_ddot_of_place_16,
        );
    let y_ddot_by_theta1_dot_of_theta1_dot = S::ratio(2, 3) * l * theta1_dot;
    // y_ddot_by_theta1_dot = l*(4*theta1'*sin(theta1) - theta3_ddot_by_theta1_dot*cos(theta3) -
    //   3*theta2_ddot_by_theta1_dot*cos(theta2) - 2*theta1_ddot_by_theta1_dot*cos(theta1))/6
    let y_ddot_by_theta1_dot = (-theta2_ddot_by_theta1_dot)
        .mul_add(cos_theta2_l_halved, y_ddot_by_theta1_dot_of_theta1_dot * sin_theta1)
        - theta3_ddot_by_theta1_dot * cos_theta3_l_by_6
        - theta1_ddot_by_theta1_dot * cos_theta1_l_by_3;
    // x_ddot_by_theta1_dot = l*(4*theta1'*cos(theta1) + theta3_ddot_by_theta1_dot*sin(theta3) +
    //   3*theta2_ddot_by_theta1_dot*sin(theta2) + 2*theta1_ddot_by_theta1_dot*sin(theta1))/6
    let x_ddot_by_theta1_dot = theta2_ddot_by_theta1_dot
        .mul_add(sin_theta2_l_halved, theta1_ddot_by_theta1_dot * sin_theta1_l_by_3)
        + theta3_ddot_by_theta1_dot * sin_theta3_l_by_6
        + y_ddot_by_theta1_dot_of_theta1_dot * cos_theta1;
    // theta3_ddot_by_theta2_dot = 3*theta2'*(6*sin(theta2)*cos(theta3) - 7*cos(theta2)*sin(theta3) +
    //   cos(theta1)*(cos(theta1)*(cos(theta2)*sin(theta3) + sin(theta2)*cos(theta3)) +
    //   sin(theta1)*(sin(theta2)*sin(theta3) - cos(theta2)*cos(theta3))))/(9 +
    //   sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3))))
    let theta3_ddot_by_theta2_dot = -theta2_dot * theta3_ddot_of_place_18
        * theta3_ddot_by_theta1_dot_of_place;
    let theta2_ddot_by_theta2_dot_of_place = theta2_ddot_of_place_3
        * theta2_ddot_by_theta3_of_place_2;
    // theta2_ddot_by_theta2_dot = (3*theta3_ddot_by_theta2_dot*sin(theta2)*sin(theta3) +
    //   sin(theta1)*(cos(theta1)*(sin(theta2)*(6*theta2'*sin(theta2) -
    //   theta3_ddot_by_theta2_dot*cos(theta3)) - cos(theta2)*(6*theta2'*cos(theta2) +
    //   theta3_ddot_by_theta2_dot*sin(theta3))) - sin(theta1)*sin(theta2)*(6*theta2'*cos(theta2) +
    //   theta3_ddot_by_theta2_dot*sin(theta3))) + cos(theta2)*(3*theta3_ddot_by_theta2_dot*cos(theta3) +
    //   cos(theta1)^2*(6*theta2'*sin(theta2) -
    //   theta3_ddot_by_theta2_dot*cos(theta3))))/(3*cos(theta1)^2*cos(theta2)^2 - 7 +
    //   3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)))
    let theta2_ddot_by_theta2_dot = -S::int(6) * theta2_dot * theta2_ddot_of_place_3
        * (theta2_ddot_of_place_5 + sin_theta2_cos_theta2)
        + theta3_ddot_by_theta2_dot * theta2_ddot_by_theta2_dot_of_place;
    // theta1_ddot_by_theta2_dot = cos(theta1)*(6*theta2'*sin(theta2) -
    //   theta3_ddot_by_theta2_dot*cos(theta3) - 3*theta2_ddot_by_theta2_dot*cos(theta2))/3 -
    //   sin(theta1)*(6*theta2'*cos(theta2) + theta3_ddot_by_theta2_dot*sin(theta3) +
    //   3*theta2_ddot_by_theta2_dot*sin(theta2))/3
    let theta1_ddot_by_theta2_dot = (-theta2_ddot_by_theta2_dot)
        .mul_add(
            theta3_ddot_of_place_16,
            -S::int(2) * theta2_dot * theta3_ddot_of_place_13,
        ) - theta3_ddot_by_theta2_dot * theta1_ddot_by_theta1_of_place_2;
    let l_theta2_dot = l * theta2_dot;
    // y_ddot_by_theta2_dot = l*(6*theta2'*sin(theta2) - theta3_ddot_by_theta2_dot*cos(theta3) -
    //   3*theta2_ddot_by_theta2_dot*cos(theta2) - 2*theta1_ddot_by_theta2_dot*cos(theta1))/6
    let y_ddot_by_theta2_dot = (-theta2_ddot_by_theta2_dot)
        .mul_add(cos_theta2_l_halved, l_theta2_dot * sin_theta2)
        - theta3_ddot_by_theta2_dot * cos_theta3_l_by_6
        - theta1_ddot_by_theta2_dot * cos_theta1_l_by_3;
    // x_ddot_by_theta2_dot = l*(6*theta2'*cos(theta2) + theta3_ddot_by_theta2_dot*sin(theta3) +
    //   3*theta2_ddot_by_theta2_dot*sin(theta2) + 2*theta1_ddot_by_theta2_dot*sin(theta1))/6
    let x_ddot_by_theta2_dot = theta2_ddot_by_theta2_dot
        .mul_add(sin_theta2_l_halved, theta1_ddot_by_theta2_dot * sin_theta1_l_by_3)
        + theta3_ddot_by_theta2_dot * sin_theta3_l_by_6 + l_theta2_dot * cos_theta2;
    // theta3_ddot_by_theta3_dot = (theta3'*(sin(theta1)*cos(theta1) - 9*sin(theta2)*cos(theta2)) +
    //   2*theta3'*cos(theta3)*(sin(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2) +
    //   cos(theta3)*(9*sin(theta2)*cos(theta2) - sin(theta1)*cos(theta1))))/(9 +
    //   sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3))))
    let theta3_ddot_by_theta3_dot = theta3_dot * theta3_ddot_of_place_4 * theta3_ddot_of_place_10;
    // theta2_ddot_by_theta3_dot = (3*sin(theta2)*(2*theta3'*cos(theta3) +
    //   theta3_ddot_by_theta3_dot*sin(theta3)) +
    //   sin(theta1)*(cos(theta1)*(sin(theta2)*(2*theta3'*sin(theta3) -
    //   theta3_ddot_by_theta3_dot*cos(theta3)) - cos(theta2)*(2*theta3'*cos(theta3) +
    //   theta3_ddot_by_theta3_dot*sin(theta3))) - sin(theta1)*sin(theta2)*(2*theta3'*cos(theta3) +
    //   theta3_ddot_by_theta3_dot*sin(theta3))) + cos(theta2)*(3*theta3_ddot_by_theta3_dot*cos(theta3) -
    //   6*theta3'*sin(theta3) - cos(theta1)^2*(theta3_ddot_by_theta3_dot*cos(theta3) -
    //   2*theta3'*sin(theta3))))/(3*cos(theta1)^2*cos(theta2)^2 - 7 +
    //   3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)))
    let theta2_ddot_by_theta3_dot = theta3_dot * theta2_ddot_of_place_3
        * (-(theta2_ddot_of_place_7 * sin_theta3))
            .mul_add(S::int(2), cos_theta3_doubled * theta2_ddot_of_place_8)
        + theta3_ddot_by_theta3_dot * theta2_ddot_by_theta2_dot_of_place;
    // theta1_ddot_by_theta3_dot = cos(theta1)*(2*theta3'*sin(theta3) -
    //   theta3_ddot_by_theta3_dot*cos(theta3) - 3*theta2_ddot_by_theta3_dot*cos(theta2))/3 -
    //   sin(theta1)*(2*theta3'*cos(theta3) + theta3_ddot_by_theta3_dot*sin(theta3) +
    //   3*theta2_ddot_by_theta3_dot*sin(theta2))/3
    let theta1_ddot_by_theta3_dot = S::ratio(2, 3) * theta3_dot
        * (-sin_theta1).mul_add(cos_theta3, cos_theta1_sin_theta3)
        - theta2_ddot_by_theta3_dot * theta3_ddot_of_place_16
        - theta3_ddot_by_theta3_dot * theta1_ddot_by_theta1_of_place_2;
    let theta3_dot_l_by_3 = theta3_dot * l_by_3;
    // y_ddot_by_theta3_dot = l*(2*theta3'*sin(theta3) - theta3_ddot_by_theta3_dot*cos(theta3) -
    //   3*theta2_ddot_by_theta3_dot*cos(theta2) - 2*theta1_ddot_by_theta3_dot*cos(theta1))/6
    let y_ddot_by_theta3_dot = (-theta2_ddot_by_theta3_dot)
        .mul_add(cos_theta2_l_halved, theta3_dot_l_by_3 * sin_theta3)
        - theta3_ddot_by_theta3_dot * cos_theta3_l_by_6
        - theta1_ddot_by_theta3_dot * cos_theta1_l_by_3;
    // x_ddot_by_theta3_dot = l*(2*theta3'*cos(theta3) + theta3_ddot_by_theta3_dot*sin(theta3) +
    //   3*theta2_ddot_by_theta3_dot*sin(theta2) + 2*theta1_ddot_by_theta3_dot*sin(theta1))/6
    let x_ddot_by_theta3_dot = theta2_ddot_by_theta3_dot
        .mul_add(sin_theta2_l_halved, theta1_ddot_by_theta3_dot * sin_theta1_l_by_3)
        + theta3_ddot_by_theta3_dot * sin_theta3_l_by_6 + theta3_dot_l_by_3 * cos_theta3;
    // Entries that are not zero.
    // d(x')/d(x') = 1
    let x_dot_by_x_dot_value = S::int(1);
    // d(y')/d(y') = 1
    let y_dot_by_y_dot_value = S::int(1);
    // d(theta1')/d(theta1') = 1
    let theta1_dot_by_theta1_dot_value = S::int(1);
    // d(theta2')/d(theta2') = 1
    let theta2_dot_by_theta2_dot_value = S::int(1);
    // d(theta3')/d(theta3') = 1
    let theta3_dot_by_theta3_dot_value = S::int(1);
    let zero = S::int(0);
    [
        [zero, zero, zero, zero, zero, x_dot_by_x_dot_value, zero, zero, zero, zero],
        [zero, zero, zero, zero, zero, zero, y_dot_by_y_dot_value, zero, zero, zero],
        [
            zero, zero, zero, zero, zero, zero, zero, theta1_dot_by_theta1_dot_value, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, theta2_dot_by_theta2_dot_value, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, theta3_dot_by_theta3_dot_value,
        ],
        [
            zero, zero, x_ddot_by_theta1, x_ddot_by_theta2, x_ddot_by_theta3, zero, zero,
            x_ddot_by_theta1_dot, x_ddot_by_theta2_dot, x_ddot_by_theta3_dot,
        ],
        [
            zero, zero, y_ddot_by_theta1, y_ddot_by_theta2, y_ddot_by_theta3, zero, zero,
            y_ddot_by_theta1_dot, y_ddot_by_theta2_dot, y_ddot_by_theta3_dot,
        ],
        [
            zero, zero, theta1_ddot_by_theta1, theta1_ddot_by_theta2, theta1_ddot_by_theta3, zero,
            zero, theta1_ddot_by_theta1_dot, theta1_ddot_by_theta2_dot, theta1_ddot_by_theta3_dot,
        ],
        [
            zero, zero, theta2_ddot_by_theta1, theta2_ddot_by_theta2, theta2_ddot_by_theta3, zero,
            zero, theta2_ddot_by_theta1_dot, theta2_ddot_by_theta2_dot, theta2_ddot_by_theta3_dot,
        ],
        [
            zero, zero, theta3_ddot_by_theta1, theta3_ddot_by_theta2, theta3_ddot_by_theta3, zero,
            zero, theta3_ddot_by_theta1_dot, theta3_ddot_by_theta2_dot, theta3_ddot_by_theta3_dot,
        ],
    ]
}

/// Inverse dynamics: the generalized forces along (x', y', theta1', theta2', theta3') that must act beside the loads of the model for the accelerations to be (x'', y'', theta1'', theta2'', theta3'').
///
/// 84 operations, 3 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
    v_dot: &[S; 5],
) -> [S; 5] {
    let Parameters { m, l } = *p;
    let [_, _, theta1, theta2, theta3] = *q;
    let [_, _, theta1_dot, theta2_dot, theta3_dot] = *q_dot;
    let [x_ddot, y_ddot, theta1_ddot, theta2_ddot, theta3_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    let (sin_theta3, cos_theta3) = theta3.sin_cos();
    // Shared terms.
    let m_l = m * l;
    let theta1_dot_sq = theta1_dot * theta1_dot;
    // theta1''*sin(theta1) + theta1_dot_sq*cos(theta1)
    let tau1_of_motion = theta1_dot_sq.mul_add(cos_theta1, theta1_ddot * sin_theta1);
    let m_times_3 = S::int(3) * m;
    let theta2_dot_sq = theta2_dot * theta2_dot;
    // theta2''*sin(theta2) + theta2_dot_sq*cos(theta2)
    let tau1_of_motion_2 = theta2_dot_sq.mul_add(cos_theta2, theta2_ddot * sin_theta2);
    let theta3_dot_sq = theta3_dot * theta3_dot;
    // theta3''*sin(theta3) + theta3_dot_sq*cos(theta3)
    let tau1_of_motion_3 = theta3_dot_sq.mul_add(cos_theta3, theta3_ddot * sin_theta3);
    // 3*tau1_of_motion_2 + tau1_of_motion_3
    let tau1_of_motion_4 = tau1_of_motion_2.mul_add(S::int(3), tau1_of_motion_3);
    let m_l_halved = S::ratio(1, 2) * m_l;
    // theta1_dot_sq*sin(theta1) - theta1''*cos(theta1)
    let tau2_of_motion = (-theta1_ddot).mul_add(cos_theta1, theta1_dot_sq * sin_theta1);
    // theta2_dot_sq*sin(theta2) - theta2''*cos(theta2)
    let tau2_of_motion_2 = (-theta2_ddot)
        .mul_add(cos_theta2, theta2_dot_sq * sin_theta2);
    // theta3_dot_sq*sin(theta3) - theta3''*cos(theta3)
    let tau2_of_motion_3 = (-theta3_ddot)
        .mul_add(cos_theta3, theta3_dot_sq * sin_theta3);
    // 3*tau2_of_motion_2 + tau2_of_motion_3
    let tau2_of_motion_4 = tau2_of_motion_2.mul_add(S::int(3), tau2_of_motion_3);
    let l_m_l = l * m_l;
    let l_m_l_halved = S::ratio(1, 2) * l_m_l;
    let m_l_doubled = S::int(2) * m_l;
    // y''*m_l_doubled - tau2_of_motion*l_m_l
    let tau4_of_motion = (-tau2_of_motion).mul_add(l_m_l, y_ddot * m_l_doubled);
    // x''*m_l_doubled - tau1_of_motion*l_m_l
    let tau4_of_motion_2 = (-tau1_of_motion).mul_add(l_m_l, x_ddot * m_l_doubled);
    // tau4_of_motion*cos(theta2) - tau4_of_motion_2*sin(theta2)
    let tau4_of_motion_3 = (-tau4_of_motion_2)
        .mul_add(sin_theta2, tau4_of_motion * cos_theta2);
    // tau4_of_motion*cos(theta3) - tau4_of_motion_2*sin(theta3)
    let tau5_of_motion = (-tau4_of_motion_2)
        .mul_add(sin_theta3, tau4_of_motion * cos_theta3);
    // Values.
    // tau1 = 3*m*x'' - m*l*(2*theta1'^2*cos(theta1) + 3*theta2'^2*cos(theta2) + theta3'^2*cos(theta3))/2 -
    //   m*l*theta1''*sin(theta1) - 3*m*l*theta2''*sin(theta2)/2 - m*l*theta3''*sin(theta3)/2
    let tau1 = (-m_l).mul_add(tau1_of_motion, x_ddot * m_times_3) - tau1_of_motion_4 * m_l_halved;
    // tau2 = 3*m*y'' - m*l*(2*theta1'^2*sin(theta1) + 3*theta2'^2*sin(theta2) + theta3'^2*sin(theta3))/2 +
    //   m*l*theta1''*cos(theta1) + 3*m*l*theta2''*cos(theta2)/2 + m*l*theta3''*cos(theta3)/2
    let tau2 = (-m_l).mul_add(tau2_of_motion, y_ddot * m_times_3) - m_l_halved * tau2_of_motion_4;
    // tau3 = m*l^2*(3*theta2'^2*sin(theta1 - theta2) + theta3'^2*sin(theta1 - theta3))/4 -
    //   m*l*x''*sin(theta1) + m*l*y''*cos(theta1) + 7*m*l^2*theta1''/12 + 3*m*l^2*theta2''*cos(theta1 -
    //   theta2)/4 + m*l^2*theta3''*cos(theta1 - theta3)/4
    let tau3 = m_l * (-x_ddot).mul_add(sin_theta1, y_ddot * cos_theta1)
        + S::ratio(7, 12) * theta1_ddot * l_m_l
        + S::ratio(1, 4) * l_m_l
            * (-tau2_of_motion_4).mul_add(cos_theta1, tau1_of_motion_4 * sin_theta1);
    // tau4 = m*l^2*(2*theta3'^2*sin(theta2 - theta3) - 3*theta1'^2*sin(theta1 - theta2))/4 -
    //   3*m*l*x''*sin(theta2)/2 + 3*m*l*y''*cos(theta2)/2 + 3*m*l^2*theta1''*cos(theta1 - theta2)/4 +
    //   4*m*l^2*theta2''/3 + m*l^2*theta3''*cos(theta2 - theta3)/2
    let tau4 = S::ratio(4, 3) * theta2_ddot * l_m_l
        + l_m_l_halved * (-tau2_of_motion_3).mul_add(cos_theta2, tau1_of_motion_3 * sin_theta2)
        + S::ratio(3, 4) * tau4_of_motion_3;
    // tau5 = m*l*y''*cos(theta3)/2 - m*l^2*(theta1'^2*sin(theta1 - theta3) + 2*theta2'^2*sin(theta2 -
    //   theta3))/4 - m*l*x''*sin(theta3)/2 + m*l^2*theta1''*cos(theta1 - theta3)/4 +
    //   m*l^2*theta2''*cos(theta2 - theta3)/2 + m*l^2*theta3''/3
    let tau5 = S::ratio(1, 3) * theta3_ddot * l_m_l
        + l_m_l_halved * (-tau2_of_motion_2).mul_add(cos_theta3, tau1_of_motion_2 * sin_theta3)
        + S::ratio(1, 4) * tau5_of_motion;
    [tau1, tau2, tau3, tau4, tau5]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 66 convolutions and 180 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 10]],
    history: &mut [Factors<S, 72>],
) {
    let Parameters { l, .. } = *p;
    let [_, _, theta1_0, theta2_0, theta3_0, x_dot_0, y_dot_0, theta1_dot_0,
    theta2_dot_0, theta3_dot_0] = series[0];
    // Constant in time.
    // l_by_6 = l/6
    let l_by_6 = S::ratio(1, 6) * l;
    // Order 0.
    let (sin_theta1_0, cos_theta1_0) = theta1_0.sin_cos();
    let (sin_theta2_0, cos_theta2_0) = theta2_0.sin_cos();
    let (sin_theta3_0, cos_theta3_0) = theta3_0.sin_cos();
    let theta1_dot_sq_0 = theta1_dot_0 * theta1_dot_0;
    let theta1_dot_sq_cos_theta1_0 = cos_theta1_0 * theta1_dot_sq_0;
    let theta3_dot_sq_0 = theta3_dot_0 * theta3_dot_0;
    let theta3_dot_sq_cos_theta3_0 = cos_theta3_0 * theta3_dot_sq_0;
    let theta1_dot_sq_sin_theta1_0 = sin_theta1_0 * theta1_dot_sq_0;
    let theta2_dot_sq_0 = theta2_dot_0 * theta2_dot_0;
    let theta2_dot_sq_sin_theta2_0 = sin_theta2_0 * theta2_dot_sq_0;
    let theta3_dot_sq_sin_theta3_0 = sin_theta3_0 * theta3_dot_sq_0;
    let theta3_ddot_of_theta3_dot_0 = sin_theta1_0 * theta3_dot_sq_cos_theta3_0;
    let sin_theta2_sin_theta3_0 = sin_theta2_0 * sin_theta3_0;
    let cos_theta2_cos_theta3_0 = cos_theta2_0 * cos_theta3_0;
    let cos_theta2_sq_0 = cos_theta2_0 * cos_theta2_0;
    let theta3_ddot_of_place_0 = sin_theta2_sin_theta3_0 + cos_theta2_cos_theta3_0;
    let cos_theta3_sq_0 = cos_theta3_0 * cos_theta3_0;
    let theta1_dot_sq_cos_theta2_0 = cos_theta2_0 * theta1_dot_sq_0;
    let theta3_ddot_of_place_2_0 = cos_theta2_sq_0.mul_add(S::int(9), -S::int(4)) - cos_theta3_sq_0;
    let theta3_ddot_of_place_3_0 = sin_theta1_0 * theta3_ddot_of_place_2_0;
    let sin_theta2_cos_theta2_0 = sin_theta2_0 * cos_theta2_0;
    let sin_theta3_cos_theta3_0 = sin_theta3_0 * cos_theta3_0;
    let theta3_ddot_of_place_4_0 = S::int(9) * sin_theta2_cos_theta2_0 - sin_theta3_cos_theta3_0;
    let theta3_ddot_of_place_5_0 = cos_theta1_0 * theta3_ddot_of_place_4_0;
    let theta3_ddot_of_place_6_0 = theta3_ddot_of_place_3_0 - theta3_ddot_of_place_5_0;
    let theta3_ddot_of_place_7_0 = sin_theta1_0 * theta3_ddot_of_place_6_0;
    let theta3_ddot_of_place_8_0 = cos_theta2_0 * theta3_ddot_of_place_0;
    let theta3_ddot_of_place_9_0 = theta3_ddot_of_place_8_0
        .mul_add(-S::int(9), S::int(5) * cos_theta3_0);
    let theta3_ddot_of_place_10_0 = cos_theta3_0 * theta3_ddot_of_place_9_0;
    let theta3_ddot_of_place_11_0 = S::int(9) + theta3_ddot_of_place_7_0
        + theta3_ddot_of_place_10_0;
    let over_theta3_ddot_of_place_11 = S::int(1) / theta3_ddot_of_place_11_0;
    let sin_theta1_cos_theta1_0 = sin_theta1_0 * cos_theta1_0;
    let theta3_ddot_of_place_12_0 = S::int(9) * sin_theta2_cos_theta2_0 - sin_theta1_cos_theta1_0;
    let sin_theta1_sin_theta2_0 = sin_theta1_0 * sin_theta2_0;
    let theta3_ddot_of_theta1_dot_0 = theta1_dot_sq_0 * sin_theta1_sin_theta2_0;
    let theta3_ddot_of_theta3_dot_2_0 = theta3_ddot_of_place_12_0 * theta3_dot_sq_0;
    let theta3_ddot_of_theta2_dot_0 = theta2_dot_sq_0 * sin_theta1_sin_theta2_0;
    let theta3_ddot_of_motion_0 = theta3_dot_sq_cos_theta3_0
        .mul_add(S::int(2), theta1_dot_sq_cos_theta1_0);
    let theta3_ddot_of_motion_2_0 = theta3_dot_sq_sin_theta3_0
        .mul_add(S::int(2), theta1_dot_sq_sin_theta1_0);
    let theta3_ddot_of_theta2_dot_2_0 = theta2_dot_sq_0 * sin_theta1_cos_theta1_0;
    let theta3_ddot_of_motion_3_0 = theta3_dot_sq_sin_theta3_0
        .mul_add(S::int(2), S::int(3) * theta2_dot_sq_sin_theta2_0);
    let theta2_dot_sq_cos_theta1_0 = cos_theta1_0 * theta2_dot_sq_0;
    let theta3_ddot_of_motion_4_0 = theta1_dot_sq_0 + theta3_ddot_of_theta2_dot_0;
    let theta3_ddot_of_motion_5_0 = cos_theta2_0 * theta3_ddot_of_motion_2_0;
    let theta3_ddot_of_motion_6_0 = sin_theta2_0 * theta3_ddot_of_motion_0;
    let theta3_ddot_of_motion_7_0 = theta3_ddot_of_motion_6_0
        .mul_add(
            -S::int(3),
            theta3_ddot_of_motion_5_0.mul_add(S::int(3), theta3_ddot_of_theta2_dot_2_0),
        );
    let theta3_ddot_of_motion_8_0 = cos_theta2_0 * theta3_ddot_of_motion_7_0;
    let theta3_ddot_of_motion_9_0 = cos_theta1_0 * theta3_ddot_of_motion_3_0;
    let theta3_ddot_of_motion_10_0 = S::int(2) * theta3_ddot_of_theta3_dot_0
        - theta3_ddot_of_motion_9_0;
    let theta3_ddot_of_motion_11_0 = cos_theta1_0 * theta3_ddot_of_motion_10_0;
    let theta3_ddot_of_motion_12_0 = theta3_ddot_of_motion_8_0
        .mul_add(
            -S::int(3),
            theta3_dot_sq_sin_theta3_0
                .mul_add(
                    S::int(8),
                    theta2_dot_sq_sin_theta2_0
                        .mul_add(S::int(18), S::int(6) * theta1_dot_sq_sin_theta1_0),
                ),
        ) - theta3_ddot_of_motion_11_0;
    let theta3_ddot_of_motion_13_0 = cos_theta3_0 * theta3_ddot_of_motion_12_0;
    let theta3_ddot_of_motion_14_0 = S::int(3) * theta1_dot_sq_cos_theta2_0
        - theta2_dot_sq_cos_theta1_0;
    let theta3_ddot_of_motion_15_0 = cos_theta1_0 * theta3_ddot_of_motion_14_0;
    let theta3_ddot_of_motion_16_0 = theta3_ddot_of_theta1_dot_0
        .mul_add(S::int(3), S::int(7) * theta2_dot_sq_0) + theta3_ddot_of_motion_15_0;
    let theta3_ddot_of_motion_17_0 = cos_theta2_0 * theta3_ddot_of_motion_16_0;
    let theta3_ddot_of_motion_18_0 = cos_theta1_0 * theta3_ddot_of_motion_4_0;
    let theta3_ddot_of_motion_19_0 = -theta3_ddot_of_motion_18_0 + theta3_ddot_of_motion_17_0;
    let theta3_ddot_of_motion_20_0 = sin_theta3_0 * theta3_ddot_of_motion_19_0;
    let theta3_ddot_of_motion_21_0 = theta3_ddot_of_motion_20_0
        .mul_add(S::int(3), theta3_ddot_of_theta3_dot_2_0) - theta3_ddot_of_motion_13_0;
    let theta3_ddot_of_motion_22_0 = theta3_ddot_of_motion_21_0 * over_theta3_ddot_of_place_11;
    let theta2_dot_sq_cos_theta2_0 = cos_theta2_0 * theta2_dot_sq_0;
    let cos_theta1_cos_theta2_0 = cos_theta1_0 * cos_theta2_0;
    let theta2_ddot_of_place_0 = cos_theta1_cos_theta2_0
        .mul_add(S::int(2), sin_theta1_sin_theta2_0);
    let theta2_ddot_of_place_2_0 = theta2_ddot_of_place_0 * sin_theta1_sin_theta2_0;
    let theta2_ddot_of_place_3_0 = cos_theta1_cos_theta2_0 * cos_theta1_cos_theta2_0;
    let theta2_ddot_of_place_4_0 = theta2_ddot_of_place_2_0
        .mul_add(S::int(3), theta2_ddot_of_place_3_0.mul_add(S::int(3), -S::int(7)));
    let over_theta2_ddot_of_place_4 = S::int(1) / theta2_ddot_of_place_4_0;
    let theta2_ddot_of_motion_0 = theta3_ddot_of_motion_22_0 * sin_theta3_0;
    let theta2_ddot_of_motion_2_0 = theta3_ddot_of_motion_22_0 * cos_theta3_0;
    let theta2_ddot_of_motion_3_0 = theta2_ddot_of_motion_0
        .mul_add(-S::ratio(1, 2), theta3_dot_sq_cos_theta3_0);
    let theta2_ddot_of_motion_4_0 = theta2_ddot_of_motion_2_0
        .mul_add(
            S::ratio(1, 2),
            S::int(3) * theta2_dot_sq_sin_theta2_0 + theta3_dot_sq_sin_theta3_0,
        );
    let theta2_ddot_of_motion_5_0 = theta2_ddot_of_motion_0
        .mul_add(
            -S::ratio(1, 2),
            S::int(3) * theta2_dot_sq_cos_theta2_0 + theta3_dot_sq_cos_theta3_0,
        );
    let theta2_ddot_of_motion_6_0 = sin_theta1_0 * theta2_ddot_of_motion_3_0;
    let theta2_ddot_of_motion_7_0 = cos_theta1_0 * theta2_ddot_of_motion_4_0;
    let theta2_ddot_of_motion_8_0 = theta2_ddot_of_motion_6_0 - theta2_ddot_of_motion_7_0;
    let theta2_ddot_of_motion_9_0 = sin_theta1_0 * theta2_ddot_of_motion_5_0;
    let theta2_ddot_of_motion_10_0 = sin_theta1_0 * theta2_ddot_of_motion_8_0;
    let theta2_ddot_of_motion_11_0 = theta2_ddot_of_motion_0
        .mul_add(
            -S::ratio(3, 2),
            theta3_dot_sq_cos_theta3_0
                .mul_add(S::int(3), S::int(3) * theta1_dot_sq_cos_theta1_0),
        ) - theta2_ddot_of_motion_10_0;
    let theta2_ddot_of_motion_12_0 = theta2_ddot_of_motion_7_0 - theta2_ddot_of_motion_9_0;
    let theta2_ddot_of_motion_13_0 = cos_theta1_0 * theta2_ddot_of_motion_12_0;
    let theta2_ddot_of_motion_14_0 = sin_theta1_0 * theta3_ddot_of_motion_4_0;
    let theta2_ddot_of_motion_15_0 = theta2_ddot_of_motion_2_0
        .mul_add(
            S::ratio(3, 2),
            theta2_ddot_of_motion_14_0
                .mul_add(S::int(3), S::int(3) * theta3_dot_sq_sin_theta3_0),
        ) - theta2_ddot_of_motion_13_0;
    let theta2_ddot_of_motion_16_0 = cos_theta2_0 * theta2_ddot_of_motion_15_0;
    let theta2_ddot_of_motion_17_0 = sin_theta2_0 * theta2_ddot_of_motion_11_0;
    let theta2_ddot_of_motion_18_0 = theta2_ddot_of_motion_16_0 - theta2_ddot_of_motion_17_0;
    let theta2_ddot_of_motion_19_0 = theta2_ddot_of_motion_18_0 * over_theta2_ddot_of_place_4;
    let theta1_ddot_of_motion_0 = theta2_ddot_of_motion_19_0 * sin_theta2_0;
    let theta1_ddot_of_motion_2_0 = theta1_ddot_of_motion_0
        .mul_add(
            -S::int(3),
            theta2_ddot_of_motion_0
                .mul_add(
                    -S::ratio(1, 2),
                    S::int(3) * theta2_dot_sq_cos_theta2_0 + theta3_dot_sq_cos_theta3_0,
                ),
        );
    let theta1_ddot_of_motion_3_0 = sin_theta1_0 * theta1_ddot_of_motion_2_0;
    let theta1_ddot_of_motion_4_0 = theta2_ddot_of_motion_19_0 * cos_theta2_0;
    let theta1_ddot_of_motion_5_0 = theta1_ddot_of_motion_4_0
        .mul_add(
            S::int(3),
            theta2_ddot_of_motion_2_0
                .mul_add(
                    S::ratio(1, 2),
                    S::int(3) * theta2_dot_sq_sin_theta2_0 + theta3_dot_sq_sin_theta3_0,
                ),
        );
    let theta1_ddot_of_motion_6_0 = cos_theta1_0 * theta1_ddot_of_motion_5_0;
    let theta1_dot_dot_0 = theta1_ddot_of_motion_6_0
        .mul_add(S::ratio(1, 3), -S::ratio(1, 3) * theta1_ddot_of_motion_3_0);
    let y_ddot_of_motion_0 = theta1_dot_dot_0 * cos_theta1_0;
    let y_ddot_of_motion_2_0 = y_ddot_of_motion_0
        .mul_add(
            -S::int(2),
            theta1_ddot_of_motion_4_0
                .mul_add(
                    S::int(3),
                    theta2_ddot_of_motion_2_0
                        .mul_add(
                            S::ratio(1, 2),
                            theta2_dot_sq_sin_theta2_0
                                .mul_add(S::int(3), S::int(2) * theta1_dot_sq_sin_theta1_0)
                                + theta3_dot_sq_sin_theta3_0,
                        ),
                ),
        );
    let x_ddot_of_motion_0 = theta1_dot_dot_0 * sin_theta1_0;
    let x_ddot_of_motion_2_0 = x_ddot_of_motion_0
        .mul_add(
            S::int(2),
            theta1_ddot_of_motion_0
                .mul_add(
                    -S::int(3),
                    theta2_ddot_of_motion_0
                        .mul_add(
                            -S::ratio(1, 2),
                            theta2_dot_sq_cos_theta2_0
                                .mul_add(S::int(3), S::int(2) * theta1_dot_sq_cos_theta1_0)
                                + theta3_dot_sq_cos_theta3_0,
                        ),
                ),
        );
    // Order 1: the rates, and what follows from them.
    let x_1 = x_dot_0;
    let y_1 = y_dot_0;
    let theta1_1 = theta1_dot_0;
    let theta2_1 = theta2_dot_0;
    let theta3_1 = theta3_dot_0;
    let x_dot_1 = l_by_6 * x_ddot_of_motion_2_0;
    let y_dot_1 = l_by_6 * y_ddot_of_motion_2_0;
    let theta1_dot_1 = theta1_dot_dot_0;
    let theta2_dot_1 = -theta2_ddot_of_motion_19_0;
    let theta3_dot_1 = -S::ratio(1, 2) * theta3_ddot_of_motion_22_0;
    if series.len() > 1 {
        series[1] = [
            x_1, y_1, theta1_1, theta2_1, theta3_1, x_dot_1, y_dot_1, theta1_dot_1, theta2_dot_1,
            theta3_dot_1,
        ];
    }
    let sin_theta1_1 = theta1_1 * cos_theta1_0;
    let cos_theta1_1 = -theta1_1 * sin_theta1_0;
    let sin_theta2_1 = theta2_1 * cos_theta2_0;
    let cos_theta2_1 = -theta2_1 * sin_theta2_0;
    let sin_theta3_1 = theta3_1 * cos_theta3_0;
    let cos_theta3_1 = -theta3_1 * sin_theta3_0;
    let theta1_dot_sq_1 = theta1_dot_1 * (theta1_dot_0 + theta1_dot_0);
    let theta1_dot_sq_cos_theta1_1 = theta1_dot_sq_1
        .mul_add(cos_theta1_0, cos_theta1_1 * theta1_dot_sq_0);
    let theta3_dot_sq_1 = theta3_dot_1 * (theta3_dot_0 + theta3_dot_0);
    let theta3_dot_sq_cos_theta3_1 = theta3_dot_sq_1
        .mul_add(cos_theta3_0, cos_theta3_1 * theta3_dot_sq_0);
    let theta1_dot_sq_sin_theta1_1 = theta1_dot_sq_1
        .mul_add(sin_theta1_0, sin_theta1_1 * theta1_dot_sq_0);
    let theta2_dot_sq_1 = theta2_dot_1 * (theta2_dot_0 + theta2_dot_0);
    let theta2_dot_sq_sin_theta2_1 = theta2_dot_sq_1
        .mul_add(sin_theta2_0, sin_theta2_1 * theta2_dot_sq_0);
    let theta3_dot_sq_sin_theta3_1 = theta3_dot_sq_1
        .mul_add(sin_theta3_0, sin_theta3_1 * theta3_dot_sq_0);
    let theta3_ddot_of_theta3_dot_1 = theta3_dot_sq_cos_theta3_1
        .mul_add(sin_theta1_0, sin_theta1_1 * theta3_dot_sq_cos_theta3_0);
    let sin_theta2_sin_theta3_1 = sin_theta3_1
        .mul_add(sin_theta2_0, sin_theta2_1 * sin_theta3_0);
    let cos_theta2_cos_theta3_1 = cos_theta3_1
        .mul_add(cos_theta2_0, cos_theta2_1 * cos_theta3_0);
    let cos_theta2_sq_1 = cos_theta2_1 * (cos_theta2_0 + cos_theta2_0);
    let theta3_ddot_of_place_1 = sin_theta2_sin_theta3_1 + cos_theta2_cos_theta3_1;
    let cos_theta3_sq_1 = cos_theta3_1 * (cos_theta3_0 + cos_theta3_0);
    let theta1_dot_sq_cos_theta2_1 = theta1_dot_sq_1
        .mul_add(cos_theta2_0, cos_theta2_1 * theta1_dot_sq_0);
    let theta3_ddot_of_place_2_1 = S::int(9) * cos_theta2_sq_1 - cos_theta3_sq_1;
    let theta3_ddot_of_place_3_1 = theta3_ddot_of_place_2_1
        .mul_add(sin_theta1_0, sin_theta1_1 * theta3_ddot_of_place_2_0);
    let sin_theta2_cos_theta2_1 = cos_theta2_1
        .mul_add(sin_theta2_0, sin_theta2_1 * cos_theta2_0);
    let sin_theta3_cos_theta3_1 = cos_theta3_1
        .mul_add(sin_theta3_0, sin_theta3_1 * cos_theta3_0);
    let theta3_ddot_of_place_4_1 = S::int(9) * sin_theta2_cos_theta2_1 - sin_theta3_cos_theta3_1;
    let theta3_ddot_of_place_5_1 = theta3_ddot_of_place_4_1
        .mul_add(cos_theta1_0, cos_theta1_1 * theta3_ddot_of_place_4_0);
    let theta3_ddot_of_place_6_1 = theta3_ddot_of_place_3_1 - theta3_ddot_of_place_5_1;
    let theta3_ddot_of_place_7_1 = theta3_ddot_of_place_6_1
        .mul_add(sin_theta1_0, sin_theta1_1 * theta3_ddot_of_place_6_0);
    let theta3_ddot_of_place_8_1 = theta3_ddot_of_place_1
        .mul_add(cos_theta2_0, cos_theta2_1 * theta3_ddot_of_place_0);
    let theta3_ddot_of_place_9_1 = theta3_ddot_of_place_8_1
        .mul_add(-S::int(9), S::int(5) * cos_theta3_1);
    let theta3_ddot_of_place_10_1 = theta3_ddot_of_place_9_1
        .mul_add(cos_theta3_0, cos_theta3_1 * theta3_ddot_of_place_9_0);
    let theta3_ddot_of_place_11_1 = theta3_ddot_of_place_7_1 + theta3_ddot_of_place_10_1;
    let sin_theta1_cos_theta1_1 = cos_theta1_1
        .mul_add(sin_theta1_0, sin_theta1_1 * cos_theta1_0);
    let theta3_ddot_of_place_12_1 = S::int(9) * sin_theta2_cos_theta2_1 - sin_theta1_cos_theta1_1;
    let sin_theta1_sin_theta2_1 = sin_theta2_1
        .mul_add(sin_theta1_0, sin_theta1_1 * sin_theta2_0);
    let theta3_ddot_of_theta1_dot_1 = sin_theta1_sin_theta2_1
        .mul_add(theta1_dot_sq_0, theta1_dot_sq_1 * sin_theta1_sin_theta2_0);
    let theta3_ddot_of_theta3_dot_2_1 = theta3_ddot_of_place_12_1
        .mul_add(theta3_dot_sq_0, theta3_dot_sq_1 * theta3_ddot_of_place_12_0);
    let theta3_ddot_of_theta2_dot_1 = sin_theta1_sin_theta2_1
        .mul_add(theta2_dot_sq_0, theta2_dot_sq_1 * sin_theta1_sin_theta2_0);
    let theta3_ddot_of_motion_1 = theta3_dot_sq_cos_theta3_1
        .mul_add(S::int(2), theta1_dot_sq_cos_theta1_1);
    let theta3_ddot_of_motion_2_1 = theta3_dot_sq_sin_theta3_1
        .mul_add(S::int(2), theta1_dot_sq_sin_theta1_1);
    let theta3_ddot_of_theta2_dot_2_1 = sin_theta1_cos_theta1_1
        .mul_add(theta2_dot_sq_0, theta2_dot_sq_1 * sin_theta1_cos_theta1_0);
    let theta3_ddot_of_motion_3_1 = theta3_dot_sq_sin_theta3_1
        .mul_add(S::int(2), S::int(3) * theta2_dot_sq_sin_theta2_1);
    let theta2_dot_sq_cos_theta1_1 = theta2_dot_sq_1
        .mul_add(cos_theta1_0, cos_theta1_1 * theta2_dot_sq_0);
    let theta3_ddot_of_motion_4_1 = theta1_dot_sq_1 + theta3_ddot_of_theta2_dot_1;
    let theta3_ddot_of_motion_5_1 = theta3_ddot_of_motion_2_1
        .mul_add(cos_theta2_0, cos_theta2_1 * theta3_ddot_of_motion_2_0);
    let theta3_ddot_of_motion_6_1 = theta3_ddot_of_motion_1
        .mul_add(sin_theta2_0, sin_theta2_1 * theta3_ddot_of_motion_0);
    let theta3_ddot_of_motion_7_1 = theta3_ddot_of_motion_6_1
        .mul_add(
            -S::int(3),
            theta3_ddot_of_motion_5_1.mul_add(S::int(3), theta3_ddot_of_theta2_dot_2_1),
        );
    let theta3_ddot_of_motion_8_1 = theta3_ddot_of_motion_7_1
        .mul_add(cos_theta2_0, cos_theta2_1 * theta3_ddot_of_motion_7_0);
    let theta3_ddot_of_motion_9_1 = theta3_ddot_of_motion_3_1
        .mul_add(cos_theta1_0, cos_theta1_1 * theta3_ddot_of_motion_3_0);
    let theta3_ddot_of_motion_10_1 = S::int(2) * theta3_ddot_of_theta3_dot_1
        - theta3_ddot_of_motion_9_1;
    let theta3_ddot_of_motion_11_1 = theta3_ddot_of_motion_10_1
        .mul_add(cos_theta1_0, cos_theta1_1 * theta3_ddot_of_motion_10_0);
    let theta3_ddot_of_motion_12_1 = theta3_ddot_of_motion_8_1
        .mul_add(
            -S::int(3),
            theta3_dot_sq_sin_theta3_1
                .mul_add(
                    S::int(8),
                    theta2_dot_sq_sin_theta2_1
                        .mul_add(S::int(18), S::int(6) * theta1_dot_sq_sin_theta1_1),
                ),
        ) - theta3_ddot_of_motion_11_1;
    let theta3_ddot_of_motion_13_1 = theta3_ddot_of_motion_12_1
        .mul_add(cos_theta3_0, cos_theta3_1 * theta3_ddot_of_motion_12_0);
    let theta3_ddot_of_motion_14_1 = S::int(3) * theta1_dot_sq_cos_theta2_1
        - theta2_dot_sq_cos_theta1_1;
    let theta3_ddot_of_motion_15_1 = theta3_ddot_of_motion_14_1
        .mul_add(cos_theta1_0, cos_theta1_1 * theta3_ddot_of_motion_14_0);
    let theta3_ddot_of_motion_16_1 = theta3_ddot_of_theta1_dot_1
        .mul_add(S::int(3), S::int(7) * theta2_dot_sq_1) + theta3_ddot_of_motion_15_1;
    let theta3_ddot_of_motion_17_1 = theta3_ddot_of_motion_16_1
        .mul_add(cos_theta2_0, cos_theta2_1 * theta3_ddot_of_motion_16_0);
    let theta3_ddot_of_motion_18_1 = theta3_ddot_of_motion_4_1
        .mul_add(cos_theta1_0, cos_theta1_1 * theta3_ddot_of_motion_4_0);
    let theta3_ddot_of_motion_19_1 = -theta3_ddot_of_motion_18_1 + theta3_ddot_of_motion_17_1;
    let theta3_ddot_of_motion_20_1 = theta3_ddot_of_motion_19_1
        .mul_add(sin_theta3_0, sin_theta3_1 * theta3_ddot_of_motion_19_0);
    let theta3_ddot_of_motion_21_1 = theta3_ddot_of_motion_20_1
        .mul_add(S::int(3), theta3_ddot_of_theta3_dot_2_1) - theta3_ddot_of_motion_13_1;
    let theta3_ddot_of_motion_22_1 = theta3_ddot_of_place_11_1
        .mul_add(
            -(theta3_ddot_of_motion_22_0 * over_theta3_ddot_of_place_11),
            theta3_ddot_of_motion_21_1 * over_theta3_ddot_of_place_11,
        );
    let theta2_dot_sq_cos_theta2_1 = theta2_dot_sq_1
        .mul_add(cos_theta2_0, cos_theta2_1 * theta2_dot_sq_0);
    let cos_theta1_cos_theta2_1 = cos_theta2_1
        .mul_add(cos_theta1_0, cos_theta1_1 * cos_theta2_0);
    let theta2_ddot_of_place_1 = cos_theta1_cos_theta2_1
        .mul_add(S::int(2), sin_theta1_sin_theta2_1);
    let theta2_ddot_of_place_2_1 = theta2_ddot_of_place_1
        .mul_add(
            sin_theta1_sin_theta2_0,
            sin_theta1_sin_theta2_1 * theta2_ddot_of_place_0,
        );
    let theta2_ddot_of_place_3_1 = cos_theta1_cos_theta2_1
        * (cos_theta1_cos_theta2_0 + cos_theta1_cos_theta2_0);
    let theta2_ddot_of_place_4_1 = theta2_ddot_of_place_2_1
        .mul_add(S::int(3), S::int(3) * theta2_ddot_of_place_3_1);
    let theta2_ddot_of_motion_1 = theta3_ddot_of_motion_22_1
        .mul_add(sin_theta3_0, sin_theta3_1 * theta3_ddot_of_motion_22_0);
    let theta2_ddot_of_motion_2_1 = theta3_ddot_of_motion_22_1
        .mul_add(cos_theta3_0, cos_theta3_1 * theta3_ddot_of_motion_22_0);
    let theta2_ddot_of_motion_3_1 = theta2_ddot_of_motion_1
        .mul_add(-S::ratio(1, 2), theta3_dot_sq_cos_theta3_1);
    let theta2_ddot_of_motion_4_1 = theta2_ddot_of_motion_2_1
        .mul_add(
            S::ratio(1, 2),
            S::int(3) * theta2_dot_sq_sin_theta2_1 + theta3_dot_sq_sin_theta3_1,
        );
    let theta2_ddot_of_motion_5_1 = theta2_ddot_of_motion_1
        .mul_add(
            -S::ratio(1, 2),
            S::int(3) * theta2_dot_sq_cos_theta2_1 + theta3_dot_sq_cos_theta3_1,
        );
    let theta2_ddot_of_motion_6_1 = theta2_ddot_of_motion_3_1
        .mul_add(sin_theta1_0, sin_theta1_1 * theta2_ddot_of_motion_3_0);
    let theta2_ddot_of_motion_7_1 = theta2_ddot_of_motion_4_1
        .mul_add(cos_theta1_0, cos_theta1_1 * theta2_ddot_of_motion_4_0);
    let theta2_ddot_of_motion_8_1 = theta2_ddot_of_motion_6_1 - theta2_ddot_of_motion_7_1;
    let theta2_ddot_of_motion_9_1 = theta2_ddot_of_motion_5_1
        .mul_add(sin_theta1_0, sin_theta1_1 * theta2_ddot_of_motion_5_0);
    let theta2_ddot_of_motion_10_1 = theta2_ddot_of_motion_8_1
        .mul_add(sin_theta1_0, sin_theta1_1 * theta2_ddot_of_motion_8_0);
    let theta2_ddot_of_motion_11_1 = theta2_ddot_of_motion_1
        .mul_add(
            -S::ratio(3, 2),
            theta3_dot_sq_cos_theta3_1
                .mul_add(S::int(3), S::int(3) * theta1_dot_sq_cos_theta1_1),
        ) - theta2_ddot_of_motion_10_1;
    let theta2_ddot_of_motion_12_1 = theta2_ddot_of_motion_7_1 - theta2_ddot_of_motion_9_1;
    let theta2_ddot_of_motion_13_1 = theta2_ddot_of_motion_12_1
        .mul_add(cos_theta1_0, cos_theta1_1 * theta2_ddot_of_motion_12_0);
    let theta2_ddot_of_motion_14_1 = theta3_ddot_of_motion_4_1
        .mul_add(sin_theta1_0, sin_theta1_1 * theta3_ddot_of_motion_4_0);
    let theta2_ddot_of_motion_15_1 = theta2_ddot_of_motion_2_1
        .mul_add(
            S::ratio(3, 2),
            theta2_ddot_of_motion_14_1
                .mul_add(S::int(3), S::int(3) * theta3_dot_sq_sin_theta3_1),
        ) - theta2_ddot_of_motion_13_1;
    let theta2_ddot_of_motion_16_1 = theta2_ddot_of_motion_15_1
        .mul_add(cos_theta2_0, cos_theta2_1 * theta2_ddot_of_motion_15_0);
    let theta2_ddot_of_motion_17_1 = theta2_ddot_of_motion_11_1
        .mul_add(sin_theta2_0, sin_theta2_1 * theta2_ddot_of_motion_11_0);
    let theta2_ddot_of_motion_18_1 = theta2_ddot_of_motion_16_1 - theta2_ddot_of_motion_17_1;
    let theta2_ddot_of_motion_19_1 = theta2_ddot_of_place_4_1
        .mul_add(
            -(theta2_ddot_of_motion_19_0 * over_theta2_ddot_of_place_4),
            theta2_ddot_of_motion_18_1 * over_theta2_ddot_of_place_4,
        );
    let theta1_ddot_of_motion_1 = theta2_ddot_of_motion_19_1
        .mul_add(sin_theta2_0, sin_theta2_1 * theta2_ddot_of_motion_19_0);
    let theta1_ddot_of_motion_2_1 = theta1_ddot_of_motion_1
        .mul_add(
            -S::int(3),
            theta2_ddot_of_motion_1
                .mul_add(
                    -S::ratio(1, 2),
                    S::int(3) * theta2_dot_sq_cos_theta2_1 + theta3_dot_sq_cos_theta3_1,
                ),
        );
    let theta1_ddot_of_motion_3_1 = theta1_ddot_of_motion_2_1
        .mul_add(sin_theta1_0, sin_theta1_1 * theta1_ddot_of_motion_2_0);
    let theta1_ddot_of_motion_4_1 = theta2_ddot_of_motion_19_1
        .mul_add(cos_theta2_0, cos_theta2_1 * theta2_ddot_of_motion_19_0);
    let theta1_ddot_of_motion_5_1 = theta1_ddot_of_motion_4_1
        .mul_add(
            S::int(3),
            theta2_ddot_of_motion_2_1
                .mul_add(
                    S::ratio(1, 2),
                    S::int(3) * theta2_dot_sq_sin_theta2_1 + theta3_dot_sq_sin_theta3_1,
                ),
        );
    let theta1_ddot_of_motion_6_1 = theta1_ddot_of_motion_5_1
        .mul_add(cos_theta1_0, cos_theta1_1 * theta1_ddot_of_motion_5_0);
    let theta1_dot_dot_1 = theta1_ddot_of_motion_6_1
        .mul_add(S::ratio(1, 3), -S::ratio(1, 3) * theta1_ddot_of_motion_3_1);
    let y_ddot_of_motion_1 = theta1_dot_dot_1
        .mul_add(cos_theta1_0, cos_theta1_1 * theta1_dot_dot_0);
    let y_ddot_of_motion_2_1 = y_ddot_of_motion_1
        .mul_add(
            -S::int(2),
            theta1_ddot_of_motion_4_1
                .mul_add(
                    S::int(3),
                    theta2_ddot_of_motion_2_1
                        .mul_add(
                            S::ratio(1, 2),
                            theta2_dot_sq_sin_theta2_1
                                .mul_add(S::int(3), S::int(2) * theta1_dot_sq_sin_theta1_1)
                                + theta3_dot_sq_sin_theta3_1,
                        ),
                ),
        );
    let x_ddot_of_motion_1 = theta1_dot_dot_1
        .mul_add(sin_theta1_0, sin_theta1_1 * theta1_dot_dot_0);
    let x_ddot_of_motion_2_1 = x_ddot_of_motion_1
        .mul_add(
            S::int(2),
            theta1_ddot_of_motion_1
                .mul_add(
                    -S::int(3),
                    theta2_ddot_of_motion_1
                        .mul_add(
                            -S::ratio(1, 2),
                            theta2_dot_sq_cos_theta2_1
                                .mul_add(S::int(3), S::int(2) * theta1_dot_sq_cos_theta1_1)
                                + theta3_dot_sq_cos_theta3_1,
                        ),
                ),
        );
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                theta1_1, theta1_1, theta2_1, theta2_1, theta3_1, theta3_1, theta1_dot_1,
                cos_theta1_1, theta3_dot_1, cos_theta3_1, sin_theta1_1, theta2_dot_1, sin_theta2_1,
                sin_theta3_1, sin_theta1_1, sin_theta2_1, cos_theta2_1, cos_theta2_1, cos_theta3_1,
                cos_theta2_1, sin_theta1_1, sin_theta2_1, sin_theta3_1, cos_theta1_1, sin_theta1_1,
                cos_theta2_1, cos_theta3_1, sin_theta1_1, sin_theta1_1, theta1_dot_sq_1,
                theta3_ddot_of_place_12_1, theta2_dot_sq_1, theta2_dot_sq_1, cos_theta1_1,
                cos_theta2_1, sin_theta2_1, cos_theta2_1, cos_theta1_1, cos_theta1_1, cos_theta3_1,
                cos_theta1_1, cos_theta2_1, cos_theta1_1, sin_theta3_1, theta3_ddot_of_place_11_1,
                cos_theta2_1, cos_theta1_1, theta2_ddot_of_place_1, cos_theta1_cos_theta2_1,
                theta3_ddot_of_motion_22_1, theta3_ddot_of_motion_22_1, sin_theta1_1, cos_theta1_1,
                sin_theta1_1, sin_theta1_1, cos_theta1_1, sin_theta1_1, cos_theta2_1, sin_theta2_1,
                theta2_ddot_of_place_4_1, theta2_ddot_of_motion_19_1, sin_theta1_1,
                theta2_ddot_of_motion_19_1, cos_theta1_1, theta1_dot_dot_1, theta1_dot_dot_1,
            ]),
            padded([
                cos_theta1_1, sin_theta1_1, cos_theta2_1, sin_theta2_1, cos_theta3_1, sin_theta3_1,
                theta1_dot_1, theta1_dot_sq_1, theta3_dot_1, theta3_dot_sq_1, theta1_dot_sq_1,
                theta2_dot_1, theta2_dot_sq_1, theta3_dot_sq_1, theta3_dot_sq_cos_theta3_1,
                sin_theta3_1, cos_theta3_1, cos_theta2_1, cos_theta3_1, theta1_dot_sq_1,
                theta3_ddot_of_place_2_1, cos_theta2_1, cos_theta3_1, theta3_ddot_of_place_4_1,
                theta3_ddot_of_place_6_1, theta3_ddot_of_place_1, theta3_ddot_of_place_9_1,
                cos_theta1_1, sin_theta2_1, sin_theta1_sin_theta2_1, theta3_dot_sq_1,
                sin_theta1_sin_theta2_1, sin_theta1_cos_theta1_1, theta2_dot_sq_1,
                theta3_ddot_of_motion_2_1, theta3_ddot_of_motion_1, theta3_ddot_of_motion_7_1,
                theta3_ddot_of_motion_3_1, theta3_ddot_of_motion_10_1, theta3_ddot_of_motion_12_1,
                theta3_ddot_of_motion_14_1, theta3_ddot_of_motion_16_1, theta3_ddot_of_motion_4_1,
                theta3_ddot_of_motion_19_1, theta3_ddot_of_motion_22_1, theta2_dot_sq_1,
                cos_theta2_1, sin_theta1_sin_theta2_1, cos_theta1_cos_theta2_1, sin_theta3_1,
                cos_theta3_1, theta2_ddot_of_motion_3_1, theta2_ddot_of_motion_4_1,
                theta2_ddot_of_motion_5_1, theta2_ddot_of_motion_8_1, theta2_ddot_of_motion_12_1,
                theta3_ddot_of_motion_4_1, theta2_ddot_of_motion_15_1, theta2_ddot_of_motion_11_1,
                theta2_ddot_of_motion_19_1, sin_theta2_1, theta1_ddot_of_motion_2_1, cos_theta2_1,
                theta1_ddot_of_motion_5_1, cos_theta1_1, sin_theta1_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta1_last = theta1_1;
    let mut theta2_last = theta2_1;
    let mut theta3_last = theta3_1;
    let mut theta1_dot_last = theta1_dot_1;
    let mut theta2_dot_last = theta2_dot_1;
    let mut theta3_dot_last = theta3_dot_1;
    let mut sin_theta1_last = sin_theta1_1;
    let mut cos_theta1_last = cos_theta1_1;
    let mut sin_theta2_last = sin_theta2_1;
    let mut cos_theta2_last = cos_theta2_1;
    let mut sin_theta3_last = sin_theta3_1;
    let mut cos_theta3_last = cos_theta3_1;
    let mut theta1_dot_sq_last = theta1_dot_sq_1;
    let mut theta3_dot_sq_last = theta3_dot_sq_1;
    let mut theta3_dot_sq_cos_theta3_last = theta3_dot_sq_cos_theta3_1;
    let mut theta2_dot_sq_last = theta2_dot_sq_1;
    let mut theta3_ddot_of_place_last = theta3_ddot_of_place_1;
    let mut theta3_ddot_of_place_2_last = theta3_ddot_of_place_2_1;
    let mut theta3_ddot_of_place_4_last = theta3_ddot_of_place_4_1;
    let mut theta3_ddot_of_place_6_last = theta3_ddot_of_place_6_1;
    let mut theta3_ddot_of_place_9_last = theta3_ddot_of_place_9_1;
    let mut theta3_ddot_of_place_11_last = theta3_ddot_of_place_11_1;
    let mut sin_theta1_cos_theta1_last = sin_theta1_cos_theta1_1;
    let mut theta3_ddot_of_place_12_last = theta3_ddot_of_place_12_1;
    let mut sin_theta1_sin_theta2_last = sin_theta1_sin_theta2_1;
    let mut theta3_ddot_of_motion_last = theta3_ddot_of_motion_1;
    let mut theta3_ddot_of_motion_2_last = theta3_ddot_of_motion_2_1;
    let mut theta3_ddot_of_motion_3_last = theta3_ddot_of_motion_3_1;
    let mut theta3_ddot_of_motion_4_last = theta3_ddot_of_motion_4_1;
    let mut theta3_ddot_of_motion_7_last = theta3_ddot_of_motion_7_1;
    let mut theta3_ddot_of_motion_10_last = theta3_ddot_of_motion_10_1;
    let mut theta3_ddot_of_motion_12_last = theta3_ddot_of_motion_12_1;
    let mut theta3_ddot_of_motion_14_last = theta3_ddot_of_motion_14_1;
    let mut theta3_ddot_of_motion_16_last = theta3_ddot_of_motion_16_1;
    let mut theta3_ddot_of_motion_19_last = theta3_ddot_of_motion_19_1;
    let mut theta3_ddot_of_motion_22_last = theta3_ddot_of_motion_22_1;
    let mut cos_theta1_cos_theta2_last = cos_theta1_cos_theta2_1;
    let mut theta2_ddot_of_place_last = theta2_ddot_of_place_1;
    let mut theta2_ddot_of_place_4_last = theta2_ddot_of_place_4_1;
    let mut theta2_ddot_of_motion_3_last = theta2_ddot_of_motion_3_1;
    let mut theta2_ddot_of_motion_4_last = theta2_ddot_of_motion_4_1;
    let mut theta2_ddot_of_motion_5_last = theta2_ddot_of_motion_5_1;
    let mut theta2_ddot_of_motion_8_last = theta2_ddot_of_motion_8_1;
    let mut theta2_ddot_of_motion_11_last = theta2_ddot_of_motion_11_1;
    let mut theta2_ddot_of_motion_12_last = theta2_ddot_of_motion_12_1;
    let mut theta2_ddot_of_motion_15_last = theta2_ddot_of_motion_15_1;
    let mut theta2_ddot_of_motion_19_last = theta2_ddot_of_motion_19_1;
    let mut theta1_ddot_of_motion_2_last = theta1_ddot_of_motion_2_1;
    let mut theta1_ddot_of_motion_5_last = theta1_ddot_of_motion_5_1;
    let mut theta1_dot_dot_last = theta1_dot_dot_1;
    let mut next = [S::int(0); 72];
    // Rates at order k - 1.
    let mut x_rate = x_dot_1;
    let mut y_rate = y_dot_1;
    let mut theta1_rate = theta1_dot_1;
    let mut theta2_rate = theta2_dot_1;
    let mut theta3_rate = theta3_dot_1;
    let mut x_dot_rate = l_by_6 * x_ddot_of_motion_2_1;
    let mut y_dot_rate = l_by_6 * y_ddot_of_motion_2_1;
    let mut theta1_dot_rate = theta1_dot_dot_1;
    let mut theta2_dot_rate = -theta2_ddot_of_motion_19_1;
    let mut theta3_dot_rate = -S::ratio(1, 2) * theta3_ddot_of_motion_22_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let x = x_rate * over_k;
        let y = y_rate * over_k;
        let theta1 = theta1_rate * over_k;
        let theta2 = theta2_rate * over_k;
        let theta3 = theta3_rate * over_k;
        let x_dot = x_dot_rate * over_k;
        let y_dot = y_dot_rate * over_k;
        let theta1_dot = theta1_dot_rate * over_k;
        let theta2_dot = theta2_dot_rate * over_k;
        let theta3_dot = theta3_dot_rate * over_k;
        series[order] = [
            x, y, theta1, theta2, theta3, x_dot, y_dot, theta1_dot, theta2_dot, theta3_dot,
        ];
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
                theta1_1
                    .mul_add(
                        cos_theta1_last,
                        (count_last * theta1_last).mul_add(cos_theta1_1, next[0]),
                    ),
                theta1_1
                    .mul_add(
                        sin_theta1_last,
                        (count_last * theta1_last).mul_add(sin_theta1_1, next[1]),
                    ),
                theta2_1
                    .mul_add(
                        cos_theta2_last,
                        (count_last * theta2_last).mul_add(cos_theta2_1, next[2]),
                    ),
                theta2_1
                    .mul_add(
                        sin_theta2_last,
                        (count_last * theta2_last).mul_add(sin_theta2_1, next[3]),
                    ),
                theta3_1
                    .mul_add(
                        cos_theta3_last,
                        (count_last * theta3_last).mul_add(cos_theta3_1, next[4]),
                    ),
                theta3_1
                    .mul_add(
                        sin_theta3_last,
                        (count_last * theta3_last).mul_add(sin_theta3_1, next[5]),
                    ),
                (theta1_dot_1 + theta1_dot_1).mul_add(theta1_dot_last, next[6]),
                cos_theta1_1
                    .mul_add(
                        theta1_dot_sq_last,
                        cos_theta1_last.mul_add(theta1_dot_sq_1, next[7]),
                    ),
                (theta3_dot_1 + theta3_dot_1).mul_add(theta3_dot_last, next[8]),
                cos_theta3_1
                    .mul_add(
                        theta3_dot_sq_last,
                        cos_theta3_last.mul_add(theta3_dot_sq_1, next[9]),
                    ),
                sin_theta1_1
                    .mul_add(
                        theta1_dot_sq_last,
                        sin_theta1_last.mul_add(theta1_dot_sq_1, next[10]),
                    ),
                (theta2_dot_1 + theta2_dot_1).mul_add(theta2_dot_last, next[11]),
                sin_theta2_1
                    .mul_add(
                        theta2_dot_sq_last,
                        sin_theta2_last.mul_add(theta2_dot_sq_1, next[12]),
                    ),
                sin_theta3_1
                    .mul_add(
                        theta3_dot_sq_last,
                        sin_theta3_last.mul_add(theta3_dot_sq_1, next[13]),
                    ),
                sin_theta1_1
                    .mul_add(
                        theta3_dot_sq_cos_theta3_last,
                        sin_theta1_last.mul_add(theta3_dot_sq_cos_theta3_1, next[14]),
                    ),
                sin_theta2_1
                    .mul_add(
                        sin_theta3_last,
                        sin_theta2_last.mul_add(sin_theta3_1, next[15]),
                    ),
                cos_theta2_1
                    .mul_add(
                        cos_theta3_last,
                        cos_theta2_last.mul_add(cos_theta3_1, next[16]),
                    ),
                (cos_theta2_1 + cos_theta2_1).mul_add(cos_theta2_last, next[17]),
                (cos_theta3_1 + cos_theta3_1).mul_add(cos_theta3_last, next[18]),
                cos_theta2_1
                    .mul_add(
                        theta1_dot_sq_last,
                        cos_theta2_last.mul_add(theta1_dot_sq_1, next[19]),
                    ),
                sin_theta1_1
                    .mul_add(
                        theta3_ddot_of_place_2_last,
                        sin_theta1_last.mul_add(theta3_ddot_of_place_2_1, next[20]),
                    ),
                sin_theta2_1
                    .mul_add(
                        cos_theta2_last,
                        sin_theta2_last.mul_add(cos_theta2_1, next[21]),
                    ),
                sin_theta3_1
                    .mul_add(
                        cos_theta3_last,
                        sin_theta3_last.mul_add(cos_theta3_1, next[22]),
                    ),
                cos_theta1_1
                    .mul_add(
                        theta3_ddot_of_place_4_last,
                        cos_theta1_last.mul_add(theta3_ddot_of_place_4_1, next[23]),
                    ),
                sin_theta1_1
                    .mul_add(
                        theta3_ddot_of_place_6_last,
                        sin_theta1_last.mul_add(theta3_ddot_of_place_6_1, next[24]),
                    ),
                cos_theta2_1
                    .mul_add(
                        theta3_ddot_of_place_last,
                        cos_theta2_last.mul_add(theta3_ddot_of_place_1, next[25]),
                    ),
                cos_theta3_1
                    .mul_add(
                        theta3_ddot_of_place_9_last,
                        cos_theta3_last.mul_add(theta3_ddot_of_place_9_1, next[26]),
                    ),
                sin_theta1_1
                    .mul_add(
                        cos_theta1_last,
                        sin_theta1_last.mul_add(cos_theta1_1, next[27]),
                    ),
                sin_theta1_1
                    .mul_add(
                        sin_theta2_last,
                        sin_theta1_last.mul_add(sin_theta2_1, next[28]),
                    ),
                theta1_dot_sq_1
                    .mul_add(
                        sin_theta1_sin_theta2_last,
                        theta1_dot_sq_last.mul_add(sin_theta1_sin_theta2_1, next[29]),
                    ),
                theta3_ddot_of_place_12_1
                    .mul_add(
                        theta3_dot_sq_last,
                        theta3_ddot_of_place_12_last.mul_add(theta3_dot_sq_1, next[30]),
                    ),
                theta2_dot_sq_1
                    .mul_add(
                        sin_theta1_sin_theta2_last,
                        theta2_dot_sq_last.mul_add(sin_theta1_sin_theta2_1, next[31]),
                    ),
                theta2_dot_sq_1
                    .mul_add(
                        sin_theta1_cos_theta1_last,
                        theta2_dot_sq_last.mul_add(sin_theta1_cos_theta1_1, next[32]),
                    ),
                cos_theta1_1
                    .mul_add(
                        theta2_dot_sq_last,
                        cos_theta1_last.mul_add(theta2_dot_sq_1, next[33]),
                    ),
                cos_theta2_1
                    .mul_add(
                        theta3_ddot_of_motion_2_last,
                        cos_theta2_last.mul_add(theta3_ddot_of_motion_2_1, next[34]),
                    ),
                sin_theta2_1
                    .mul_add(
                        theta3_ddot_of_motion_last,
                        sin_theta2_last.mul_add(theta3_ddot_of_motion_1, next[35]),
                    ),
                cos_theta2_1
                    .mul_add(
                        theta3_ddot_of_motion_7_last,
                        cos_theta2_last.mul_add(theta3_ddot_of_motion_7_1, next[36]),
                    ),
                cos_theta1_1
                    .mul_add(
                        theta3_ddot_of_motion_3_last,
                        cos_theta1_last.mul_add(theta3_ddot_of_motion_3_1, next[37]),
                    ),
                cos_theta1_1
                    .mul_add(
                        theta3_ddot_of_motion_10_last,
                        cos_theta1_last.mul_add(theta3_ddot_of_motion_10_1, next[38]),
                    ),
                cos_theta3_1
                    .mul_add(
                        theta3_ddot_of_motion_12_last,
                        cos_theta3_last.mul_add(theta3_ddot_of_motion_12_1, next[39]),
                    ),
                cos_theta1_1
                    .mul_add(
                        theta3_ddot_of_motion_14_last,
                        cos_theta1_last.mul_add(theta3_ddot_of_motion_14_1, next[40]),
                    ),
                cos_theta2_1
                    .mul_add(
                        theta3_ddot_of_motion_16_last,
                        cos_theta2_last.mul_add(theta3_ddot_of_motion_16_1, next[41]),
                    ),
                cos_theta1_1
                    .mul_add(
                        theta3_ddot_of_motion_4_last,
                        cos_theta1_last.mul_add(theta3_ddot_of_motion_4_1, next[42]),
                    ),
                sin_theta3_1
                    .mul_add(
                        theta3_ddot_of_motion_19_last,
                        sin_theta3_last.mul_add(theta3_ddot_of_motion_19_1, next[43]),
                    ),
                theta3_ddot_of_place_11_1
                    .mul_add(
                        theta3_ddot_of_motion_22_last,
                        theta3_ddot_of_place_11_last
                            .mul_add(theta3_ddot_of_motion_22_1, next[44]),
                    ),
                cos_theta2_1
                    .mul_add(
                        theta2_dot_sq_last,
                        cos_theta2_last.mul_add(theta2_dot_sq_1, next[45]),
                    ),
                cos_theta1_1
                    .mul_add(
                        cos_theta2_last,
                        cos_theta1_last.mul_add(cos_theta2_1, next[46]),
                    ),
                theta2_ddot_of_place_1
                    .mul_add(
                        sin_theta1_sin_theta2_last,
                        theta2_ddot_of_place_last
                            .mul_add(sin_theta1_sin_theta2_1, next[47]),
                    ),
                (cos_theta1_cos_theta2_1 + cos_theta1_cos_theta2_1)
                    .mul_add(cos_theta1_cos_theta2_last, next[48]),
                theta3_ddot_of_motion_22_1
                    .mul_add(
                        sin_theta3_last,
                        theta3_ddot_of_motion_22_last.mul_add(sin_theta3_1, next[49]),
                    ),
                theta3_ddot_of_motion_22_1
                    .mul_add(
                        cos_theta3_last,
                        theta3_ddot_of_motion_22_last.mul_add(cos_theta3_1, next[50]),
                    ),
                sin_theta1_1
                    .mul_add(
                        theta2_ddot_of_motion_3_last,
                        sin_theta1_last.mul_add(theta2_ddot_of_motion_3_1, next[51]),
                    ),
                cos_theta1_1
                    .mul_add(
                        theta2_ddot_of_motion_4_last,
                        cos_theta1_last.mul_add(theta2_ddot_of_motion_4_1, next[52]),
                    ),
                sin_theta1_1
                    .mul_add(
                        theta2_ddot_of_motion_5_last,
                        sin_theta1_last.mul_add(theta2_ddot_of_motion_5_1, next[53]),
                    ),
                sin_theta1_1
                    .mul_add(
                        theta2_ddot_of_motion_8_last,
                        sin_theta1_last.mul_add(theta2_ddot_of_motion_8_1, next[54]),
                    ),
                cos_theta1_1
                    .mul_add(
                        theta2_ddot_of_motion_12_last,
                        cos_theta1_last.mul_add(theta2_ddot_of_motion_12_1, next[55]),
                    ),
                sin_theta1_1
                    .mul_add(
                        theta3_ddot_of_motion_4_last,
                        sin_theta1_last.mul_add(theta3_ddot_of_motion_4_1, next[56]),
                    ),
                cos_theta2_1
                    .mul_add(
                        theta2_ddot_of_motion_15_last,
                        cos_theta2_last.mul_add(theta2_ddot_of_motion_15_1, next[57]),
                    ),
                sin_theta2_1
                    .mul_add(
                        theta2_ddot_of_motion_11_last,
                        sin_theta2_last.mul_add(theta2_ddot_of_motion_11_1, next[58]),
                    ),
                theta2_ddot_of_place_4_1
                    .mul_add(
                        theta2_ddot_of_motion_19_last,
                        theta2_ddot_of_place_4_last
                            .mul_add(theta2_ddot_of_motion_19_1, next[59]),
                    ),
                theta2_ddot_of_motion_19_1
                    .mul_add(
                        sin_theta2_last,
                        theta2_ddot_of_motion_19_last.mul_add(sin_theta2_1, next[60]),
                    ),
                sin_theta1_1
                    .mul_add(
                        theta1_ddot_of_motion_2_last,
                        sin_theta1_last.mul_add(theta1_ddot_of_motion_2_1, next[61]),
                    ),
                theta2_ddot_of_motion_19_1
                    .mul_add(
                        cos_theta2_last,
                        theta2_ddot_of_motion_19_last.mul_add(cos_theta2_1, next[62]),
                    ),
                cos_theta1_1
                    .mul_add(
                        theta1_ddot_of_motion_5_last,
                        cos_theta1_last.mul_add(theta1_ddot_of_motion_5_1, next[63]),
                    ),
                theta1_dot_dot_1
                    .mul_add(
                        cos_theta1_last,
                        theta1_dot_dot_last.mul_add(cos_theta1_1, next[64]),
                    ),
                theta1_dot_dot_1
                    .mul_add(
                        sin_theta1_last,
                        theta1_dot_dot_last.mul_add(sin_theta1_1, next[65]),
                    ),
            ])
        };
        // sin_theta1 = sin(theta1)
        let sin_theta1 = theta1.mul_add(cos_theta1_0, sums[0] * over_k);
        // cos_theta1 = cos(theta1)
        let cos_theta1 = -theta1.mul_add(sin_theta1_0, sums[1] * over_k);
        // sin_theta2 = sin(theta2)
        let sin_theta2 = theta2.mul_add(cos_theta2_0, sums[2] * over_k);
        // cos_theta2 = cos(theta2)
        let cos_theta2 = -theta2.mul_add(sin_theta2_0, sums[3] * over_k);
        // sin_theta3 = sin(theta3)
        let sin_theta3 = theta3.mul_add(cos_theta3_0, sums[4] * over_k);
        // cos_theta3 = cos(theta3)
        let cos_theta3 = -theta3.mul_add(sin_theta3_0, sums[5] * over_k);
        // theta1_dot_sq = theta1_dot*theta1_dot
        let theta1_dot_sq = theta1_dot.mul_add(theta1_dot_0 + theta1_dot_0, sums[6]);
        // theta1_dot_sq_cos_theta1 = cos_theta1*theta1_dot_sq
        let theta1_dot_sq_cos_theta1 = theta1_dot_sq
            .mul_add(cos_theta1_0, cos_theta1.mul_add(theta1_dot_sq_0, sums[7]));
        // theta3_dot_sq = theta3_dot*theta3_dot
        let theta3_dot_sq = theta3_dot.mul_add(theta3_dot_0 + theta3_dot_0, sums[8]);
        // theta3_dot_sq_cos_theta3 = cos_theta3*theta3_dot_sq
        let theta3_dot_sq_cos_theta3 = theta3_dot_sq
            .mul_add(cos_theta3_0, cos_theta3.mul_add(theta3_dot_sq_0, sums[9]));
        // theta1_dot_sq_sin_theta1 = sin_theta1*theta1_dot_sq
        let theta1_dot_sq_sin_theta1 = theta1_dot_sq
            .mul_add(sin_theta1_0, sin_theta1.mul_add(theta1_dot_sq_0, sums[10]));
        // theta2_dot_sq = theta2_dot*theta2_dot
        let theta2_dot_sq = theta2_dot.mul_add(theta2_dot_0 + theta2_dot_0, sums[11]);
        // theta2_dot_sq_sin_theta2 = sin_theta2*theta2_dot_sq
        let theta2_dot_sq_sin_theta2 = theta2_dot_sq
            .mul_add(sin_theta2_0, sin_theta2.mul_add(theta2_dot_sq_0, sums[12]));
        // theta3_dot_sq_sin_theta3 = sin_theta3*theta3_dot_sq
        let theta3_dot_sq_sin_theta3 = theta3_dot_sq
            .mul_add(sin_theta3_0, sin_theta3.mul_add(theta3_dot_sq_0, sums[13]));
        // theta3_ddot_of_theta3_dot = sin_theta1*theta3_dot_sq_cos_theta3
        let theta3_ddot_of_theta3_dot = theta3_dot_sq_cos_theta3
            .mul_add(
                sin_theta1_0,
                sin_theta1.mul_add(theta3_dot_sq_cos_theta3_0, sums[14]),
            );
        // sin_theta2_sin_theta3 = sin_theta2*sin_theta3
        let sin_theta2_sin_theta3 = sin_theta3
            .mul_add(sin_theta2_0, sin_theta2.mul_add(sin_theta3_0, sums[15]));
        // cos_theta2_cos_theta3 = cos_theta2*cos_theta3
        let cos_theta2_cos_theta3 = cos_theta3
            .mul_add(cos_theta2_0, cos_theta2.mul_add(cos_theta3_0, sums[16]));
        // cos_theta2_sq = cos_theta2*cos_theta2
        let cos_theta2_sq = cos_theta2.mul_add(cos_theta2_0 + cos_theta2_0, sums[17]);
        // theta3_ddot_of_place = sin_theta2_sin_theta3 + cos_theta2_cos_theta3
        let theta3_ddot_of_place = sin_theta2_sin_theta3 + cos_theta2_cos_theta3;
        // cos_theta3_sq = cos_theta3*cos_theta3
        let cos_theta3_sq = cos_theta3.mul_add(cos_theta3_0 + cos_theta3_0, sums[18]);
        // theta1_dot_sq_cos_theta2 = cos_theta2*theta1_dot_sq
        let theta1_dot_sq_cos_theta2 = theta1_dot_sq
            .mul_add(cos_theta2_0, cos_theta2.mul_add(theta1_dot_sq_0, sums[19]));
        // theta3_ddot_of_place_2 = -4 + 9*cos_theta2_sq - cos_theta3_sq
        let theta3_ddot_of_place_2 = S::int(9) * cos_theta2_sq - cos_theta3_sq;
        // theta3_ddot_of_place_3 = sin_theta1*theta3_ddot_of_place_2
        let theta3_ddot_of_place_3 = theta3_ddot_of_place_2
            .mul_add(
                sin_theta1_0,
                sin_theta1.mul_add(theta3_ddot_of_place_2_0, sums[20]),
            );
        // sin_theta2_cos_theta2 = sin_theta2*cos_theta2
        let sin_theta2_cos_theta2 = cos_theta2
            .mul_add(sin_theta2_0, sin_theta2.mul_add(cos_theta2_0, sums[21]));
        // sin_theta3_cos_theta3 = sin_theta3*cos_theta3
        let sin_theta3_cos_theta3 = cos_theta3
            .mul_add(sin_theta3_0, sin_theta3.mul_add(cos_theta3_0, sums[22]));
        // theta3_ddot_of_place_4 = 9*sin_theta2_cos_theta2 - sin_theta3_cos_theta3
        let theta3_ddot_of_place_4 = S::int(9) * sin_theta2_cos_theta2 - sin_theta3_cos_theta3;
        // theta3_ddot_of_place_5 = cos_theta1*theta3_ddot_of_place_4
        let theta3_ddot_of_place_5 = theta3_ddot_of_place_4
            .mul_add(
                cos_theta1_0,
                cos_theta1.mul_add(theta3_ddot_of_place_4_0, sums[23]),
            );
        // theta3_ddot_of_place_6 = theta3_ddot_of_place_3 - theta3_ddot_of_place_5
        let theta3_ddot_of_place_6 = theta3_ddot_of_place_3 - theta3_ddot_of_place_5;
        // theta3_ddot_of_place_7 = sin_theta1*theta3_ddot_of_place_6
        let theta3_ddot_of_place_7 = theta3_ddot_of_place_6
            .mul_add(
                sin_theta1_0,
                sin_theta1.mul_add(theta3_ddot_of_place_6_0, sums[24]),
            );
        // theta3_ddot_of_place_8 = cos_theta2*theta3_ddot_of_place
        let theta3_ddot_of_place_8 = theta3_ddot_of_place
            .mul_add(cos_theta2_0, cos_theta2.mul_add(theta3_ddot_of_place_0, sums[25]));
        // theta3_ddot_of_place_9 = 5*cos_theta3 - 9*theta3_ddot_of_place_8
        let theta3_ddot_of_place_9 = theta3_ddot_of_place_8
            .mul_add(-S::int(9), S::int(5) * cos_theta3);
        // theta3_ddot_of_place_10 = cos_theta3*theta3_ddot_of_place_9
        let theta3_ddot_of_place_10 = theta3_ddot_of_place_9
            .mul_add(
                cos_theta3_0,
                cos_theta3.mul_add(theta3_ddot_of_place_9_0, sums[26]),
            );
        // theta3_ddot_of_place_11 = 9 + theta3_ddot_of_place_7 + theta3_ddot_of_place_10
        let theta3_ddot_of_place_11 = theta3_ddot_of_place_7 + theta3_ddot_of_place_10;
        // sin_theta1_cos_theta1 = sin_theta1*cos_theta1
        let sin_theta1_cos_theta1 = cos_theta1
            .mul_add(sin_theta1_0, sin_theta1.mul_add(cos_theta1_0, sums[27]));
        // theta3_ddot_of_place_12 = 9*sin_theta2_cos_theta2 - sin_theta1_cos_theta1
        let theta3_ddot_of_place_12 = S::int(9) * sin_theta2_cos_theta2 - sin_theta1_cos_theta1;
        // sin_theta1_sin_theta2 = sin_theta1*sin_theta2
        let sin_theta1_sin_theta2 = sin_theta2
            .mul_add(sin_theta1_0, sin_theta1.mul_add(sin_theta2_0, sums[28]));
        // theta3_ddot_of_theta1_dot = theta1_dot_sq*sin_theta1_sin_theta2
        let theta3_ddot_of_theta1_dot = sin_theta1_sin_theta2
            .mul_add(
                theta1_dot_sq_0,
                theta1_dot_sq.mul_add(sin_theta1_sin_theta2_0, sums[29]),
            );
        // theta3_ddot_of_theta3_dot_2 = theta3_ddot_of_place_12*theta3_dot_sq
        let theta3_ddot_of_theta3_dot_2 = theta3_ddot_of_place_12
            .mul_add(
                theta3_dot_sq_0,
                theta3_dot_sq.mul_add(theta3_ddot_of_place_12_0, sums[30]),
            );
        // theta3_ddot_of_theta2_dot = theta2_dot_sq*sin_theta1_sin_theta2
        let theta3_ddot_of_theta2_dot = sin_theta1_sin_theta2
            .mul_add(
                theta2_dot_sq_0,
                theta2_dot_sq.mul_add(sin_theta1_sin_theta2_0, sums[31]),
            );
        // theta3_ddot_of_motion = theta1_dot_sq_cos_theta1 + 2*theta3_dot_sq_cos_theta3
        let theta3_ddot_of_motion = theta3_dot_sq_cos_theta3
            .mul_add(S::int(2), theta1_dot_sq_cos_theta1);
        // theta3_ddot_of_motion_2 = theta1_dot_sq_sin_theta1 + 2*theta3_dot_sq_sin_theta3
        let theta3_ddot_of_motion_2 = theta3_dot_sq_sin_theta3
            .mul_add(S::int(2), theta1_dot_sq_sin_theta1);
        // theta3_ddot_of_theta2_dot_2 = theta2_dot_sq*sin_theta1_cos_theta1
        let theta3_ddot_of_theta2_dot_2 = sin_theta1_cos_theta1
            .mul_add(
                theta2_dot_sq_0,
                theta2_dot_sq.mul_add(sin_theta1_cos_theta1_0, sums[32]),
            );
        // theta3_ddot_of_motion_3 = 3*theta2_dot_sq_sin_theta2 + 2*theta3_dot_sq_sin_theta3
        let theta3_ddot_of_motion_3 = theta3_dot_sq_sin_theta3
            .mul_add(S::int(2), S::int(3) * theta2_dot_sq_sin_theta2);
        // theta2_dot_sq_cos_theta1 = cos_theta1*theta2_dot_sq
        let theta2_dot_sq_cos_theta1 = theta2_dot_sq
            .mul_add(cos_theta1_0, cos_theta1.mul_add(theta2_dot_sq_0, sums[33]));
        // theta3_ddot_of_motion_4 = theta1_dot_sq + theta3_ddot_of_theta2_dot
        let theta3_ddot_of_motion_4 = theta1_dot_sq + theta3_ddot_of_theta2_dot;
        // theta3_ddot_of_motion_5 = cos_theta2*theta3_ddot_of_motion_2
        let theta3_ddot_of_motion_5 = theta3_ddot_of_motion_2
            .mul_add(
                cos_theta2_0,
                cos_theta2.mul_add(theta3_ddot_of_motion_2_0, sums[34]),
            );
        // theta3_ddot_of_motion_6 = sin_theta2*theta3_ddot_of_motion
        let theta3_ddot_of_motion_6 = theta3_ddot_of_motion
            .mul_add(
                sin_theta2_0,
                sin_theta2.mul_add(theta3_ddot_of_motion_0, sums[35]),
            );
        // theta3_ddot_of_motion_7 = theta3_ddot_of_theta2_dot_2 + 3*theta3_ddot_of_motion_5 -
        //   3*theta3_ddot_of_motion_6
        let theta3_ddot_of_motion_7 = theta3_ddot_of_motion_6
            .mul_add(
                -S::int(3),
                theta3_ddot_of_motion_5.mul_add(S::int(3), theta3_ddot_of_theta2_dot_2),
            );
        // theta3_ddot_of_motion_8 = cos_theta2*theta3_ddot_of_motion_7
        let theta3_ddot_of_motion_8 = theta3_ddot_of_motion_7
            .mul_add(
                cos_theta2_0,
                cos_theta2.mul_add(theta3_ddot_of_motion_7_0, sums[36]),
            );
        // theta3_ddot_of_motion_9 = cos_theta1*theta3_ddot_of_motion_3
        let theta3_ddot_of_motion_9 = theta3_ddot_of_motion_3
            .mul_add(
                cos_theta1_0,
                cos_theta1.mul_add(theta3_ddot_of_motion_3_0, sums[37]),
            );
        // theta3_ddot_of_motion_10 = 2*theta3_ddot_of_theta3_dot - theta3_ddot_of_motion_9
        let theta3_ddot_of_motion_10 = S::int(2) * theta3_ddot_of_theta3_dot
            - theta3_ddot_of_motion_9;
        // theta3_ddot_of_motion_11 = cos_theta1*theta3_ddot_of_motion_10
        let theta3_ddot_of_motion_11 = theta3_ddot_of_motion_10
            .mul_add(
                cos_theta1_0,
                cos_theta1.mul_add(theta3_ddot_of_motion_10_0, sums[38]),
            );
        // theta3_ddot_of_motion_12 = 6*theta1_dot_sq_sin_theta1 + 18*theta2_dot_sq_sin_theta2 +
        //   8*theta3_dot_sq_sin_theta3 - 3*theta3_ddot_of_motion_8 - theta3_ddot_of_motion_11
        let theta3_ddot_of_motion_12 = theta3_ddot_of_motion_8
            .mul_add(
                -S::int(3),
                theta3_dot_sq_sin_theta3
                    .mul_add(
                        S::int(8),
                        theta2_dot_sq_sin_theta2
                            .mul_add(S::int(18), S::int(6) * theta1_dot_sq_sin_theta1),
                    ),
            ) - theta3_ddot_of_motion_11;
        // theta3_ddot_of_motion_13 = cos_theta3*theta3_ddot_of_motion_12
        let theta3_ddot_of_motion_13 = theta3_ddot_of_motion_12
            .mul_add(
                cos_theta3_0,
                cos_theta3.mul_add(theta3_ddot_of_motion_12_0, sums[39]),
            );
        // theta3_ddot_of_motion_14 = 3*theta1_dot_sq_cos_theta2 - theta2_dot_sq_cos_theta1
        let theta3_ddot_of_motion_14 = S::int(3) * theta1_dot_sq_cos_theta2
            - theta2_dot_sq_cos_theta1;
        // theta3_ddot_of_motion_15 = cos_theta1*theta3_ddot_of_motion_14
        let theta3_ddot_of_motion_15 = theta3_ddot_of_motion_14
            .mul_add(
                cos_theta1_0,
                cos_theta1.mul_add(theta3_ddot_of_motion_14_0, sums[40]),
            );
        // theta3_ddot_of_motion_16 = 7*theta2_dot_sq + 3*theta3_ddot_of_theta1_dot +
        //   theta3_ddot_of_motion_15
        let theta3_ddot_of_motion_16 = theta3_ddot_of_theta1_dot
            .mul_add(S::int(3), S::int(7) * theta2_dot_sq) + theta3_ddot_of_motion_15;
        // theta3_ddot_of_motion_17 = cos_theta2*theta3_ddot_of_motion_16
        let theta3_ddot_of_motion_17 = theta3_ddot_of_motion_16
            .mul_add(
                cos_theta2_0,
                cos_theta2.mul_add(theta3_ddot_of_motion_16_0, sums[41]),
            );
        // theta3_ddot_of_motion_18 = cos_theta1*theta3_ddot_of_motion_4
        let theta3_ddot_of_motion_18 = theta3_ddot_of_motion_4
            .mul_add(
                cos_theta1_0,
                cos_theta1.mul_add(theta3_ddot_of_motion_4_0, sums[42]),
            );
        // theta3_ddot_of_motion_19 = theta3_ddot_of_motion_17 - theta3_ddot_of_motion_18
        let theta3_ddot_of_motion_19 = -theta3_ddot_of_motion_18 + theta3_ddot_of_motion_17;
        // theta3_ddot_of_motion_20 = sin_theta3*theta3_ddot_of_motion_19
        let theta3_ddot_of_motion_20 = theta3_ddot_of_motion_19
            .mul_add(
                sin_theta3_0,
                sin_theta3.mul_add(theta3_ddot_of_motion_19_0, sums[43]),
            );
        // theta3_ddot_of_motion_21 = theta3_ddot_of_theta3_dot_2 - theta3_ddot_of_motion_13 +
        //   3*theta3_ddot_of_motion_20
        let theta3_ddot_of_motion_21 = theta3_ddot_of_motion_20
            .mul_add(S::int(3), theta3_ddot_of_theta3_dot_2) - theta3_ddot_of_motion_13;
        // theta3_ddot_of_motion_22 = theta3_ddot_of_motion_21/theta3_ddot_of_place_11
        let theta3_ddot_of_motion_22 = theta3_ddot_of_motion_21
            .mul_add(
                over_theta3_ddot_of_place_11,
                -(theta3_ddot_of_place_11.mul_add(theta3_ddot_of_motion_22_0, sums[44])
                    * over_theta3_ddot_of_place_11),
            );
        // theta2_dot_sq_cos_theta2 = cos_theta2*theta2_dot_sq
        let theta2_dot_sq_cos_theta2 = theta2_dot_sq
            .mul_add(cos_theta2_0, cos_theta2.mul_add(theta2_dot_sq_0, sums[45]));
        // cos_theta1_cos_theta2 = cos_theta1*cos_theta2
        let cos_theta1_cos_theta2 = cos_theta2
            .mul_add(cos_theta1_0, cos_theta1.mul_add(cos_theta2_0, sums[46]));
        // theta2_ddot_of_place = sin_theta1_sin_theta2 + 2*cos_theta1_cos_theta2
        let theta2_ddot_of_place = cos_theta1_cos_theta2
            .mul_add(S::int(2), sin_theta1_sin_theta2);
        // theta2_ddot_of_place_2 = theta2_ddot_of_place*sin_theta1_sin_theta2
        let theta2_ddot_of_place_2 = theta2_ddot_of_place
            .mul_add(
                sin_theta1_sin_theta2_0,
                sin_theta1_sin_theta2.mul_add(theta2_ddot_of_place_0, sums[47]),
            );
        // theta2_ddot_of_place_3 = cos_theta1_cos_theta2*cos_theta1_cos_theta2
        let theta2_ddot_of_place_3 = cos_theta1_cos_theta2
            .mul_add(cos_theta1_cos_theta2_0 + cos_theta1_cos_theta2_0, sums[48]);
        // theta2_ddot_of_place_4 = -7 + 3*theta2_ddot_of_place_2 + 3*theta2_ddot_of_place_3
        let theta2_ddot_of_place_4 = theta2_ddot_of_place_2
            .mul_add(S::int(3), S::int(3) * theta2_ddot_of_place_3);
        // theta2_ddot_of_motion = theta3_ddot_of_motion_22*sin_theta3
        let theta2_ddot_of_motion = theta3_ddot_of_motion_22
            .mul_add(
                sin_theta3_0,
                sin_theta3.mul_add(theta3_ddot_of_motion_22_0, sums[49]),
            );
        // theta2_ddot_of_motion_2 = theta3_ddot_of_motion_22*cos_theta3
        let theta2_ddot_of_motion_2 = theta3_ddot_of_motion_22
            .mul_add(
                cos_theta3_0,
                cos_theta3.mul_add(theta3_ddot_of_motion_22_0, sums[50]),
            );
        // theta2_ddot_of_motion_3 = theta3_dot_sq_cos_theta3 - 1/2*theta2_ddot_of_motion
        let theta2_ddot_of_motion_3 = theta2_ddot_of_motion
            .mul_add(-S::ratio(1, 2), theta3_dot_sq_cos_theta3);
        // theta2_ddot_of_motion_4 = 3*theta2_dot_sq_sin_theta2 + theta3_dot_sq_sin_theta3 +
        //   1/2*theta2_ddot_of_motion_2
        let theta2_ddot_of_motion_4 = theta2_ddot_of_motion_2
            .mul_add(
                S::ratio(1, 2),
                S::int(3) * theta2_dot_sq_sin_theta2 + theta3_dot_sq_sin_theta3,
            );
        // theta2_ddot_of_motion_5 = 3*theta2_dot_sq_cos_theta2 + theta3_dot_sq_cos_theta3 -
        //   1/2*theta2_ddot_of_motion
        let theta2_ddot_of_motion_5 = theta2_ddot_of_motion
            .mul_add(
                -S::ratio(1, 2),
                S::int(3) * theta2_dot_sq_cos_theta2 + theta3_dot_sq_cos_theta3,
            );
        // theta2_ddot_of_motion_6 = sin_theta1*theta2_ddot_of_motion_3
        let theta2_ddot_of_motion_6 = theta2_ddot_of_motion_3
            .mul_add(
                sin_theta1_0,
                sin_theta1.mul_add(theta2_ddot_of_motion_3_0, sums[51]),
            );
        // theta2_ddot_of_motion_7 = cos_theta1*theta2_ddot_of_motion_4
        let theta2_ddot_of_motion_7 = theta2_ddot_of_motion_4
            .mul_add(
                cos_theta1_0,
                cos_theta1.mul_add(theta2_ddot_of_motion_4_0, sums[52]),
            );
        // theta2_ddot_of_motion_8 = theta2_ddot_of_motion_6 - theta2_ddot_of_motion_7
        let theta2_ddot_of_motion_8 = theta2_ddot_of_motion_6 - theta2_ddot_of_motion_7;
        // theta2_ddot_of_motion_9 = sin_theta1*theta2_ddot_of_motion_5
        let theta2_ddot_of_motion_9 = theta2_ddot_of_motion_5
            .mul_add(
                sin_theta1_0,
                sin_theta1.mul_add(theta2_ddot_of_motion_5_0, sums[53]),
            );
        // theta2_ddot_of_motion_10 = sin_theta1*theta2_ddot_of_motion_8
        let theta2_ddot_of_motion_10 = theta2_ddot_of_motion_8
            .mul_add(
                sin_theta1_0,
                sin_theta1.mul_add(theta2_ddot_of_motion_8_0, sums[54]),
            );
        // theta2_ddot_of_motion_11 = 3*theta1_dot_sq_cos_theta1 + 3*theta3_dot_sq_cos_theta3 -
        //   3/2*theta2_ddot_of_motion - theta2_ddot_of_motion_10
        let theta2_ddot_of_motion_11 = theta2_ddot_of_motion
            .mul_add(
                -S::ratio(3, 2),
                theta3_dot_sq_cos_theta3
                    .mul_add(S::int(3), S::int(3) * theta1_dot_sq_cos_theta1),
            ) - theta2_ddot_of_motion_10;
        // theta2_ddot_of_motion_12 = theta2_ddot_of_motion_7 - theta2_ddot_of_motion_9
        let theta2_ddot_of_motion_12 = theta2_ddot_of_motion_7 - theta2_ddot_of_motion_9;
        // theta2_ddot_of_motion_13 = cos_theta1*theta2_ddot_of_motion_12
        let theta2_ddot_of_motion_13 = theta2_ddot_of_motion_12
            .mul_add(
                cos_theta1_0,
                cos_theta1.mul_add(theta2_ddot_of_motion_12_0, sums[55]),
            );
        // theta2_ddot_of_motion_14 = sin_theta1*theta3_ddot_of_motion_4
        let theta2_ddot_of_motion_14 = theta3_ddot_of_motion_4
            .mul_add(
                sin_theta1_0,
                sin_theta1.mul_add(theta3_ddot_of_motion_4_0, sums[56]),
            );
        // theta2_ddot_of_motion_15 = 3*theta3_dot_sq_sin_theta3 + 3/2*theta2_ddot_of_motion_2 -
        //   theta2_ddot_of_motion_13 + 3*theta2_ddot_of_motion_14
        let theta2_ddot_of_motion_15 = theta2_ddot_of_motion_2
            .mul_add(
                S::ratio(3, 2),
                theta2_ddot_of_motion_14
                    .mul_add(S::int(3), S::int(3) * theta3_dot_sq_sin_theta3),
            ) - theta2_ddot_of_motion_13;
        // theta2_ddot_of_motion_16 = cos_theta2*theta2_ddot_of_motion_15
        let theta2_ddot_of_motion_16 = theta2_ddot_of_motion_15
            .mul_add(
                cos_theta2_0,
                cos_theta2.mul_add(theta2_ddot_of_motion_15_0, sums[57]),
            );
        // theta2_ddot_of_motion_17 = sin_theta2*theta2_ddot_of_motion_11
        let theta2_ddot_of_motion_17 = theta2_ddot_of_motion_11
            .mul_add(
                sin_theta2_0,
                sin_theta2.mul_add(theta2_ddot_of_motion_11_0, sums[58]),
            );
        // theta2_ddot_of_motion_18 = theta2_ddot_of_motion_16 - theta2_ddot_of_motion_17
        let theta2_ddot_of_motion_18 = theta2_ddot_of_motion_16 - theta2_ddot_of_motion_17;
        // theta2_ddot_of_motion_19 = theta2_ddot_of_motion_18/theta2_ddot_of_place_4
        let theta2_ddot_of_motion_19 = theta2_ddot_of_motion_18
            .mul_add(
                over_theta2_ddot_of_place_4,
                -(theta2_ddot_of_place_4.mul_add(theta2_ddot_of_motion_19_0, sums[59])
                    * over_theta2_ddot_of_place_4),
            );
        // theta1_ddot_of_motion = theta2_ddot_of_motion_19*sin_theta2
        let theta1_ddot_of_motion = theta2_ddot_of_motion_19
            .mul_add(
                sin_theta2_0,
                sin_theta2.mul_add(theta2_ddot_of_motion_19_0, sums[60]),
            );
        // theta1_ddot_of_motion_2 = 3*theta2_dot_sq_cos_theta2 + theta3_dot_sq_cos_theta3 -
        //   1/2*theta2_ddot_of_motion - 3*theta1_ddot_of_motion
        let theta1_ddot_of_motion_2 = theta1_ddot_of_motion
            .mul_add(
                -S::int(3),
                theta2_ddot_of_motion
                    .mul_add(
                        -S::ratio(1, 2),
                        S::int(3) * theta2_dot_sq_cos_theta2 + theta3_dot_sq_cos_theta3,
                    ),
            );
        // theta1_ddot_of_motion_3 = sin_theta1*theta1_ddot_of_motion_2
        let theta1_ddot_of_motion_3 = theta1_ddot_of_motion_2
            .mul_add(
                sin_theta1_0,
                sin_theta1.mul_add(theta1_ddot_of_motion_2_0, sums[61]),
            );
        // theta1_ddot_of_motion_4 = theta2_ddot_of_motion_19*cos_theta2
        let theta1_ddot_of_motion_4 = theta2_ddot_of_motion_19
            .mul_add(
                cos_theta2_0,
                cos_theta2.mul_add(theta2_ddot_of_motion_19_0, sums[62]),
            );
        // theta1_ddot_of_motion_5 = 3*theta2_dot_sq_sin_theta2 + theta3_dot_sq_sin_theta3 +
        //   1/2*theta2_ddot_of_motion_2 + 3*theta1_ddot_of_motion_4
        let theta1_ddot_of_motion_5 = theta1_ddot_of_motion_4
            .mul_add(
                S::int(3),
                theta2_ddot_of_motion_2
                    .mul_add(
                        S::ratio(1, 2),
                        S::int(3) * theta2_dot_sq_sin_theta2 + theta3_dot_sq_sin_theta3,
                    ),
            );
        // theta1_ddot_of_motion_6 = cos_theta1*theta1_ddot_of_motion_5
        let theta1_ddot_of_motion_6 = theta1_ddot_of_motion_5
            .mul_add(
                cos_theta1_0,
                cos_theta1.mul_add(theta1_ddot_of_motion_5_0, sums[63]),
            );
        // theta1_dot_dot = -1/3*theta1_ddot_of_motion_3 + 1/3*theta1_ddot_of_motion_6
        let theta1_dot_dot = theta1_ddot_of_motion_6
            .mul_add(S::ratio(1, 3), -S::ratio(1, 3) * theta1_ddot_of_motion_3);
        // y_ddot_of_motion = theta1_dot_dot*cos_theta1
        let y_ddot_of_motion = theta1_dot_dot
            .mul_add(cos_theta1_0, cos_theta1.mul_add(theta1_dot_dot_0, sums[64]));
        // y_ddot_of_motion_2 = 2*theta1_dot_sq_sin_theta1 + 3*theta2_dot_sq_sin_theta2 +
        //   theta3_dot_sq_sin_theta3 + 1/2*theta2_ddot_of_motion_2 + 3*theta1_ddot_of_motion_4 -
        //   2*y_ddot_of_motion
        let y_ddot_of_motion_2 = y_ddot_of_motion
            .mul_add(
                -S::int(2),
                theta1_ddot_of_motion_4
                    .mul_add(
                        S::int(3),
                        theta2_ddot_of_motion_2
                            .mul_add(
                                S::ratio(1, 2),
                                theta2_dot_sq_sin_theta2
                                    .mul_add(S::int(3), S::int(2) * theta1_dot_sq_sin_theta1)
                                    + theta3_dot_sq_sin_theta3,
                            ),
                    ),
            );
        // x_ddot_of_motion = theta1_dot_dot*sin_theta1
        let x_ddot_of_motion = theta1_dot_dot
            .mul_add(sin_theta1_0, sin_theta1.mul_add(theta1_dot_dot_0, sums[65]));
        // x_ddot_of_motion_2 = 2*theta1_dot_sq_cos_theta1 + 3*theta2_dot_sq_cos_theta2 +
        //   theta3_dot_sq_cos_theta3 - 1/2*theta2_ddot_of_motion - 3*theta1_ddot_of_motion +
        //   2*x_ddot_of_motion
        let x_ddot_of_motion_2 = x_ddot_of_motion
            .mul_add(
                S::int(2),
                theta1_ddot_of_motion
                    .mul_add(
                        -S::int(3),
                        theta2_ddot_of_motion
                            .mul_add(
                                -S::ratio(1, 2),
                                theta2_dot_sq_cos_theta2
                                    .mul_add(S::int(3), S::int(2) * theta1_dot_sq_cos_theta1)
                                    + theta3_dot_sq_cos_theta3,
                            ),
                    ),
            );
        x_rate = x_dot;
        y_rate = y_dot;
        theta1_rate = theta1_dot;
        theta2_rate = theta2_dot;
        theta3_rate = theta3_dot;
        x_dot_rate = l_by_6 * x_ddot_of_motion_2;
        y_dot_rate = l_by_6 * y_ddot_of_motion_2;
        theta1_dot_rate = theta1_dot_dot;
        theta2_dot_rate = -theta2_ddot_of_motion_19;
        theta3_dot_rate = -S::ratio(1, 2) * theta3_ddot_of_motion_22;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * theta1,
                count * theta1,
                count * theta2,
                count * theta2,
                count * theta3,
                count * theta3,
                theta1_dot, cos_theta1, theta3_dot, cos_theta3, sin_theta1, theta2_dot, sin_theta2,
                sin_theta3, sin_theta1, sin_theta2, cos_theta2, cos_theta2, cos_theta3, cos_theta2,
                sin_theta1, sin_theta2, sin_theta3, cos_theta1, sin_theta1, cos_theta2, cos_theta3,
                sin_theta1, sin_theta1, theta1_dot_sq, theta3_ddot_of_place_12, theta2_dot_sq,
                theta2_dot_sq, cos_theta1, cos_theta2, sin_theta2, cos_theta2, cos_theta1,
                cos_theta1, cos_theta3, cos_theta1, cos_theta2, cos_theta1, sin_theta3,
                theta3_ddot_of_place_11, cos_theta2, cos_theta1, theta2_ddot_of_place,
                cos_theta1_cos_theta2, theta3_ddot_of_motion_22, theta3_ddot_of_motion_22,
                sin_theta1, cos_theta1, sin_theta1, sin_theta1, cos_theta1, sin_theta1, cos_theta2,
                sin_theta2, theta2_ddot_of_place_4, theta2_ddot_of_motion_19, sin_theta1,
                theta2_ddot_of_motion_19, cos_theta1, theta1_dot_dot, theta1_dot_dot,
            ]),
            padded([
                cos_theta1, sin_theta1, cos_theta2, sin_theta2, cos_theta3, sin_theta3, theta1_dot,
                theta1_dot_sq, theta3_dot, theta3_dot_sq, theta1_dot_sq, theta2_dot, theta2_dot_sq,
                theta3_dot_sq, theta3_dot_sq_cos_theta3, sin_theta3, cos_theta3, cos_theta2,
                cos_theta3, theta1_dot_sq, theta3_ddot_of_place_2, cos_theta2, cos_theta3,
                theta3_ddot_of_place_4, theta3_ddot_of_place_6, theta3_ddot_of_place,
                theta3_ddot_of_place_9, cos_theta1, sin_theta2, sin_theta1_sin_theta2,
                theta3_dot_sq, sin_theta1_sin_theta2, sin_theta1_cos_theta1, theta2_dot_sq,
                theta3_ddot_of_motion_2, theta3_ddot_of_motion, theta3_ddot_of_motion_7,
                theta3_ddot_of_motion_3, theta3_ddot_of_motion_10, theta3_ddot_of_motion_12,
                theta3_ddot_of_motion_14, theta3_ddot_of_motion_16, theta3_ddot_of_motion_4,
                theta3_ddot_of_motion_19, theta3_ddot_of_motion_22, theta2_dot_sq, cos_theta2,
                sin_theta1_sin_theta2, cos_theta1_cos_theta2, sin_theta3, cos_theta3,
                theta2_ddot_of_motion_3, theta2_ddot_of_motion_4, theta2_ddot_of_motion_5,
                theta2_ddot_of_motion_8, theta2_ddot_of_motion_12, theta3_ddot_of_motion_4,
                theta2_ddot_of_motion_15, theta2_ddot_of_motion_11, theta2_ddot_of_motion_19,
                sin_theta2, theta1_ddot_of_motion_2, cos_theta2, theta1_ddot_of_motion_5,
                cos_theta1, sin_theta1,
            ]),
        ];
        count_last = count;
        theta1_last = theta1;
        theta2_last = theta2;
        theta3_last = theta3;
        theta1_dot_last = theta1_dot;
        theta2_dot_last = theta2_dot;
        theta3_dot_last = theta3_dot;
        sin_theta1_last = sin_theta1;
        cos_theta1_last = cos_theta1;
        sin_theta2_last = sin_theta2;
        cos_theta2_last = cos_theta2;
        sin_theta3_last = sin_theta3;
        cos_theta3_last = cos_theta3;
        theta1_dot_sq_last = theta1_dot_sq;
        theta3_dot_sq_last = theta3_dot_sq;
        theta3_dot_sq_cos_theta3_last = theta3_dot_sq_cos_theta3;
        theta2_dot_sq_last = theta2_dot_sq;
        theta3_ddot_of_place_last = theta3_ddot_of_place;
        theta3_ddot_of_place_2_last = theta3_ddot_of_place_2;
        theta3_ddot_of_place_4_last = theta3_ddot_of_place_4;
        theta3_ddot_of_place_6_last = theta3_ddot_of_place_6;
        theta3_ddot_of_place_9_last = theta3_ddot_of_place_9;
        theta3_ddot_of_place_11_last = theta3_ddot_of_place_11;
        sin_theta1_cos_theta1_last = sin_theta1_cos_theta1;
        theta3_ddot_of_place_12_last = theta3_ddot_of_place_12;
        sin_theta1_sin_theta2_last = sin_theta1_sin_theta2;
        theta3_ddot_of_motion_last = theta3_ddot_of_motion;
        theta3_ddot_of_motion_2_last = theta3_ddot_of_motion_2;
        theta3_ddot_of_motion_3_last = theta3_ddot_of_motion_3;
        theta3_ddot_of_motion_4_last = theta3_ddot_of_motion_4;
        theta3_ddot_of_motion_7_last = theta3_ddot_of_motion_7;
        theta3_ddot_of_motion_10_last = theta3_ddot_of_motion_10;
        theta3_ddot_of_motion_12_last = theta3_ddot_of_motion_12;
        theta3_ddot_of_motion_14_last = theta3_ddot_of_motion_14;
        theta3_ddot_of_motion_16_last = theta3_ddot_of_motion_16;
        theta3_ddot_of_motion_19_last = theta3_ddot_of_motion_19;
        theta3_ddot_of_motion_22_last = theta3_ddot_of_motion_22;
        cos_theta1_cos_theta2_last = cos_theta1_cos_theta2;
        theta2_ddot_of_place_last = theta2_ddot_of_place;
        theta2_ddot_of_place_4_last = theta2_ddot_of_place_4;
        theta2_ddot_of_motion_3_last = theta2_ddot_of_motion_3;
        theta2_ddot_of_motion_4_last = theta2_ddot_of_motion_4;
        theta2_ddot_of_motion_5_last = theta2_ddot_of_motion_5;
        theta2_ddot_of_motion_8_last = theta2_ddot_of_motion_8;
        theta2_ddot_of_motion_11_last = theta2_ddot_of_motion_11;
        theta2_ddot_of_motion_12_last = theta2_ddot_of_motion_12;
        theta2_ddot_of_motion_15_last = theta2_ddot_of_motion_15;
        theta2_ddot_of_motion_19_last = theta2_ddot_of_motion_19;
        theta1_ddot_of_motion_2_last = theta1_ddot_of_motion_2;
        theta1_ddot_of_motion_5_last = theta1_ddot_of_motion_5;
        theta1_dot_dot_last = theta1_dot_dot;
    }
}

/// Lagrange's equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Lagrange;

impl<S: Scalar> System<S> for Lagrange {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 2,
            coordinates: 5,
            variables: 5,
            speeds: 5,
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
        10
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
        144 * order + SLACK
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
    slice.try_into().expect("a slice of the length that System states")
}
