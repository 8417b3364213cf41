//! Chain of three rods floating in a plane: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/floating_chain/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

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

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
    direction: &[S; 10],
) -> [S; 10] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: q_dot[i],
        slope: direction[5 + i],
    });
    let (of_q, of_v) = derivative(&p, &q, &v);
    let mut slopes = of_q.into_iter().chain(of_v).map(|rate| rate.slope);
    core::array::from_fn(|_| {
        slopes.next().expect("a slope for each component of the state")
    })
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
    slice.try_into().expect("a slice of the length that `System` requires")
}
