//! Chain of three rods floating in a plane: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/floating_chain/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1, u2, u3, u4, u5.
///
/// 32 operations, 3 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 5],
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

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5').
///
/// 45 operations, 3 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> [S; 5] {
    let Parameters { m, l } = *p;
    let [_, _, theta1, theta2, theta3] = *q;
    let [_, _, u3, u4, u5] = *u;
    // Sines and cosines.
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    let (sin_theta3, cos_theta3) = theta3.sin_cos();
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Shared terms.
    let u5_sq = u5 * u5;
    let u4_sq = u4 * u4;
    let u4_sq_times_3 = S::int(3) * u4_sq;
    let u3_sq = u3 * u3;
    let u3_sq_doubled = S::int(2) * u3_sq;
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
    // f1 = m*l*(2*u3^2*cos(theta1) + 3*u4^2*cos(theta2) + u5^2*cos(theta3))/2
    let f1 = m_l_halved
        * (u4_sq_times_3.mul_add(cos_theta2, u5_sq * cos_theta3) + u3_sq_doubled * cos_theta1);
    // f2 = m*l*(2*u3^2*sin(theta1) + 3*u4^2*sin(theta2) + u5^2*sin(theta3))/2
    let f2 = m_l_halved
        * (u4_sq_times_3.mul_add(sin_theta2, u5_sq * sin_theta3) + u3_sq_doubled * sin_theta1);
    // f3 = -m*l^2*(3*u4^2*sin(theta1 - theta2) + u5^2*sin(theta1 - theta3))/4
    let f3 = -l_m_l_by_4
        * sin_theta1_minus_theta2
            .mul_add(u4_sq_times_3, sin_theta1_minus_theta3 * u5_sq);
    // f4 = m*l^2*(3*u3^2*sin(theta1 - theta2) - 2*u5^2*sin(theta2 - theta3))/4
    let f4 = l_m_l_by_4
        * (-u5_sq).mul_add(f4_of_place, S::int(3) * sin_theta1_minus_theta2 * u3_sq);
    // f5 = m*l^2*(u3^2*sin(theta1 - theta3) + 2*u4^2*sin(theta2 - theta3))/4
    let f5 = l_m_l_by_4 * u4_sq.mul_add(f4_of_place, sin_theta1_minus_theta3 * u3_sq);
    [f1, f2, f3, f4, f5]
}

/// The accelerations (u1', u2', u3', u4', u5'), solved for when this code was generated.
///
/// 128 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> [S; 5] {
    let Parameters { l, .. } = *p;
    let [_, _, theta1, theta2, theta3] = *q;
    let [_, _, u3, u4, u5] = *u;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    let (sin_theta3, cos_theta3) = theta3.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let cos_theta2_times_9 = S::int(9) * cos_theta2;
    // 4 - cos_theta2_times_9*cos(theta2)
    let u5_dot_of_theta2 = (-cos_theta2_times_9).mul_add(cos_theta2, S::int(4));
    let u5_dot_of_theta2_2 = cos_theta2_times_9 * sin_theta2;
    // 1/(9 - cos(theta3)*(cos_theta2_times_9*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)) -
    //   5*cos(theta3)) - sin(theta1)*(sin(theta1)*(cos(theta3)^2 + u5_dot_of_theta2) +
    //   cos(theta1)*(u5_dot_of_theta2_2 - sin(theta3)*cos(theta3))))
    let u5_dot_of_place = S::int(1)
        / (S::int(9)
            - cos_theta3
                * (cos_theta2_times_9 * cos_theta2.mul_add(cos_theta3, sin_theta2 * sin_theta3)
                    - S::int(5) * cos_theta3)
            - sin_theta1
                * (sin_theta1 * cos_theta3.mul_add(cos_theta3, u5_dot_of_theta2)
                    + cos_theta1 * (-sin_theta3).mul_add(cos_theta3, u5_dot_of_theta2_2)));
    // u5_dot_of_theta2_2 - sin(theta1)*cos(theta1)
    let u5_dot_of_place_2 = (-sin_theta1).mul_add(cos_theta1, u5_dot_of_theta2_2);
    let u5_sq = u5 * u5;
    let u3_sq = u3 * u3;
    // sin(theta1)*cos(theta2) - cos(theta1)*sin(theta2)
    let u5_dot_of_place_3 = (-cos_theta1).mul_add(sin_theta2, sin_theta1 * cos_theta2);
    let u5_dot_of_place_4 = u5_dot_of_place * cos_theta3;
    let cos_theta1_cos_theta2 = cos_theta1 * cos_theta2;
    let sin_theta1_sin_theta2 = sin_theta1 * sin_theta2;
    // cos_theta1_cos_theta2 + sin_theta1_sin_theta2
    let u5_dot_of_place_5 = cos_theta1_cos_theta2 + sin_theta1_sin_theta2;
    let u5_dot_of_place_6 = u5_dot_of_place * sin_theta3;
    let u4_sq = u4 * u4;
    let cos_theta2_u4_sq = u4_sq * cos_theta2;
    // u3_sq + u5_dot_of_place_5*u4_sq
    let u5_dot_of_u3_u4 = u5_dot_of_place_5.mul_add(u4_sq, u3_sq);
    let sin_theta1_u3_sq = u3_sq * sin_theta1;
    // u5_dot_of_place_4*u4_sq*(6*sin(theta2) - u5_dot_of_place_3*cos(theta1)) +
    //   u5_dot_of_place_6*u5_dot_of_u3_u4*cos(theta1)
    let u5_dot_of_u3_u4_2 = u5_dot_of_place_4 * u4_sq
        * (-u5_dot_of_place_3).mul_add(cos_theta1, S::int(6) * sin_theta2)
        + u5_dot_of_place_6 * u5_dot_of_u3_u4 * cos_theta1;
    // u5' = (u5^2*(sin(theta1)*cos(theta1) - 9*sin(theta2)*cos(theta2)) -
    //   3*sin(theta3)*(cos(theta1)*(u3^2*(3*cos(theta2)^2 - 1) - u4^2*(sin(theta1)*sin(theta2) +
    //   cos(theta1)*cos(theta2))) + cos(theta2)*(3*u3^2*sin(theta1)*sin(theta2) + 7*u4^2)) +
    //   cos(theta3)*(3*u3^2*(3*cos(theta1)*sin(theta2)*cos(theta2) - sin(theta1)*(3*cos(theta2)^2 - 2)) +
    //   3*u4^2*(6*sin(theta2) + cos(theta1)*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2))) +
    //   2*u5^2*(sin(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2) + cos(theta3)*(9*sin(theta2)*cos(theta2) -
    //   sin(theta1)*cos(theta1)))))/(2*(9 + sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)))))
    let u5_dot = u5_dot_of_place_4
        * (u5_sq
            * (sin_theta3 * cos_theta1.mul_add(cos_theta1, u5_dot_of_theta2)
                + u5_dot_of_place_2 * cos_theta3) + S::int(3) * sin_theta1_u3_sq)
        - S::ratio(1, 2) * u5_dot_of_place * u5_dot_of_place_2 * u5_sq
        - S::ratio(9, 2) * u3_sq * cos_theta2
            * u5_dot_of_place_5
                .mul_add(u5_dot_of_place_6, u5_dot_of_place_3 * u5_dot_of_place_4)
        - S::ratio(21, 2) * u5_dot_of_place_6 * cos_theta2_u4_sq
        + S::ratio(3, 2) * u5_dot_of_u3_u4_2;
    // cos_theta1_cos_theta2^2 + sin_theta1_sin_theta2*(2*cos_theta1_cos_theta2 + sin_theta1_sin_theta2)
    let u4_dot_of_place = sin_theta1_sin_theta2
        * cos_theta1_cos_theta2.mul_add(S::int(2), sin_theta1_sin_theta2)
        + cos_theta1_cos_theta2 * cos_theta1_cos_theta2;
    // 1/(3*u4_dot_of_place - 7)
    let u4_dot_of_place_2 = S::int(1) / u4_dot_of_place.mul_add(S::int(3), -S::int(7));
    // u5'*sin(theta3) + u5_sq*cos(theta3)
    let u4_dot_of_u5_u5_dot = u5_sq.mul_add(cos_theta3, u5_dot * sin_theta3);
    // u5'*cos(theta3) - u5_sq*sin(theta3)
    let u4_dot_of_u5_u5_dot_2 = (-u5_sq).mul_add(sin_theta3, u5_dot * cos_theta3);
    // u4_dot_of_u5_u5_dot*sin(theta1) + u4_dot_of_u5_u5_dot_2*cos(theta1)
    let u4_dot_of_u5_u5_dot_3 = u4_dot_of_u5_u5_dot_2
        .mul_add(cos_theta1, u4_dot_of_u5_u5_dot * sin_theta1);
    // u4_dot_of_u5_u5_dot*sin(theta2) + u4_dot_of_u5_u5_dot_2*cos(theta2)
    let u4_dot_of_u5_u5_dot_4 = u4_dot_of_u5_u5_dot_2
        .mul_add(cos_theta2, u4_dot_of_u5_u5_dot * sin_theta2);
    // u4' = (sin(theta1)*(3*u3^2*cos(theta2) + sin(theta1)*sin(theta2)*(3*u4^2*cos(theta2) +
    //   u5^2*cos(theta3) + u5'*sin(theta3)) + cos(theta1)*(cos(theta2)*(3*u4^2*cos(theta2) +
    //   u5^2*cos(theta3) + u5'*sin(theta3)) - sin(theta2)*(3*u4^2*sin(theta2) + u5^2*sin(theta3) -
    //   u5'*cos(theta3)))) + cos(theta2)*(3*u5^2*sin(theta3) - 3*u5'*cos(theta3) +
    //   cos(theta1)^2*(u5'*cos(theta3) - 3*u4^2*sin(theta2) - u5^2*sin(theta3))) -
    //   3*sin(theta2)*(u3^2*cos(theta1) + u5^2*cos(theta3) + u5'*sin(theta3)))/(7 -
    //   3*cos(theta1)^2*cos(theta2)^2 - 3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) +
    //   2*cos(theta1)*cos(theta2)))
    let u4_dot = S::int(3) * u4_dot_of_place_2
        * (-u5_dot_of_place_3).mul_add(u5_dot_of_u3_u4, u4_dot_of_u5_u5_dot_4)
        - u5_dot_of_place_5 * u4_dot_of_place_2 * u4_dot_of_u5_u5_dot_3;
    // u3' = cos(theta1)*(3*u4^2*sin(theta2) + u5^2*sin(theta3) - 3*u4'*cos(theta2) - u5'*cos(theta3))/3 -
    //   sin(theta1)*(3*u4^2*cos(theta2) + u5^2*cos(theta3) + 3*u4'*sin(theta2) + u5'*sin(theta3))/3
    let u3_dot = (-u5_dot_of_place_3).mul_add(u4_sq, -u4_dot * u5_dot_of_place_5)
        - S::ratio(1, 3) * u4_dot_of_u5_u5_dot_3;
    let l_by_6 = S::ratio(1, 6) * l;
    let l_halved = S::ratio(1, 2) * l;
    let l_by_3 = S::ratio(1, 3) * l;
    // u2' = l*(2*u3^2*sin(theta1) + 3*u4^2*sin(theta2) + u5^2*sin(theta3) - 2*u3'*cos(theta1) -
    //   3*u4'*cos(theta2) - u5'*cos(theta3))/6
    let u2_dot = l_halved * (-u4_dot).mul_add(cos_theta2, u4_sq * sin_theta2)
        - u4_dot_of_u5_u5_dot_2 * l_by_6 + l_by_3 * (-u3_dot).mul_add(cos_theta1, sin_theta1_u3_sq);
    // u1' = l*(2*u3^2*cos(theta1) + 3*u4^2*cos(theta2) + u5^2*cos(theta3) + 2*u3'*sin(theta1) +
    //   3*u4'*sin(theta2) + u5'*sin(theta3))/6
    let u1_dot = l_halved * u4_dot.mul_add(sin_theta2, cos_theta2_u4_sq)
        + u4_dot_of_u5_u5_dot * l_by_6 + l_by_3 * u3_sq.mul_add(cos_theta1, u3_dot * sin_theta1);
    [u1_dot, u2_dot, u3_dot, u4_dot, u5_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
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

/// Kinetic energy T.
///
/// 48 operations, 3 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> S {
    let Parameters { m, l } = *p;
    let [_, _, theta1, theta2, theta3] = *q;
    let [u1, u2, u3, u4, u5] = *u;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    let (sin_theta3, cos_theta3) = theta3.sin_cos();
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    // Shared terms.
    let m_l = m * l;
    let u4_times_3 = S::int(3) * u4;
    // u5*sin(theta3) + u4_times_3*sin(theta2)
    let energy_of_u4_u5 = u4_times_3.mul_add(sin_theta2, u5 * sin_theta3);
    // u5*cos(theta3) + u4_times_3*cos(theta2)
    let energy_of_u4_u5_2 = u4_times_3.mul_add(cos_theta2, u5 * cos_theta3);
    let l_m_l = l * m_l;
    let u3_l_m_l = u3 * l_m_l;
    // Values.
    // T = 3*m*u1^2/2 + 3*m*u2^2/2 + 7*m*l^2*u3^2/24 - m*l*u1*u3*sin(theta1) + m*l*u2*u3*cos(theta1) +
    //   2*m*l^2*u4^2/3 - 3*m*l*u1*u4*sin(theta2)/2 + 3*m*l*u2*u4*cos(theta2)/2 + 3*m*l^2*u3*u4*cos(theta1 -
    //   theta2)/4 + m*l^2*u5^2/6 - m*l*u1*u5*sin(theta3)/2 + m*l*u2*u5*cos(theta3)/2 +
    //   m*l^2*u3*u5*cos(theta1 - theta3)/4 + m*l^2*u4*u5*cos(theta2 - theta3)/2
    let energy = S::ratio(3, 2) * m * u2.mul_add(u2, u1 * u1)
        + u3 * m_l * (-u1).mul_add(sin_theta1, u2 * cos_theta1)
        + S::ratio(1, 2) * m_l * (-u1).mul_add(energy_of_u4_u5, u2 * energy_of_u4_u5_2)
        + S::ratio(1, 6) * l_m_l
            * (S::int(4) * u4 * u4
                + u5
                    * (u5
                        + u4_times_3 * cos_theta2.mul_add(cos_theta3, sin_theta2 * sin_theta3)))
        + S::ratio(7, 24) * u3 * u3_l_m_l
        + S::ratio(1, 4) * u3_l_m_l
            * energy_of_u4_u5_2.mul_add(cos_theta1, energy_of_u4_u5 * sin_theta1);
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 0 operations.
#[must_use]
pub fn potential_energy<S: Scalar>(_p: &Parameters<S>, _q: &[S; 5]) -> S {
    let zero = S::int(0);
    zero
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 128 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 5],
) -> ([S; 5], [S; 5]) {
    let Parameters { l, .. } = *p;
    let [_, _, theta1, theta2, theta3] = *q;
    let [u1, u2, u3, u4, u5] = *u;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    let (sin_theta3, cos_theta3) = theta3.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let cos_theta2_times_9 = S::int(9) * cos_theta2;
    // 4 - cos_theta2_times_9*cos(theta2)
    let u5_dot_of_theta2 = (-cos_theta2_times_9).mul_add(cos_theta2, S::int(4));
    let u5_dot_of_theta2_2 = cos_theta2_times_9 * sin_theta2;
    // 1/(9 - cos(theta3)*(cos_theta2_times_9*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)) -
    //   5*cos(theta3)) - sin(theta1)*(sin(theta1)*(cos(theta3)^2 + u5_dot_of_theta2) +
    //   cos(theta1)*(u5_dot_of_theta2_2 - sin(theta3)*cos(theta3))))
    let u5_dot_of_place = S::int(1)
        / (S::int(9)
            - cos_theta3
                * (cos_theta2_times_9 * cos_theta2.mul_add(cos_theta3, sin_theta2 * sin_theta3)
                    - S::int(5) * cos_theta3)
            - sin_theta1
                * (sin_theta1 * cos_theta3.mul_add(cos_theta3, u5_dot_of_theta2)
                    + cos_theta1 * (-sin_theta3).mul_add(cos_theta3, u5_dot_of_theta2_2)));
    // u5_dot_of_theta2_2 - sin(theta1)*cos(theta1)
    let u5_dot_of_place_2 = (-sin_theta1).mul_add(cos_theta1, u5_dot_of_theta2_2);
    let u5_sq = u5 * u5;
    let u3_sq = u3 * u3;
    // sin(theta1)*cos(theta2) - cos(theta1)*sin(theta2)
    let u5_dot_of_place_3 = (-cos_theta1).mul_add(sin_theta2, sin_theta1 * cos_theta2);
    let u5_dot_of_place_4 = u5_dot_of_place * cos_theta3;
    let cos_theta1_cos_theta2 = cos_theta1 * cos_theta2;
    let sin_theta1_sin_theta2 = sin_theta1 * sin_theta2;
    // cos_theta1_cos_theta2 + sin_theta1_sin_theta2
    let u5_dot_of_place_5 = cos_theta1_cos_theta2 + sin_theta1_sin_theta2;
    let u5_dot_of_place_6 = u5_dot_of_place * sin_theta3;
    let u4_sq = u4 * u4;
    let cos_theta2_u4_sq = u4_sq * cos_theta2;
    // u3_sq + u5_dot_of_place_5*u4_sq
    let u5_dot_of_u3_u4 = u5_dot_of_place_5.mul_add(u4_sq, u3_sq);
    let sin_theta1_u3_sq = u3_sq * sin_theta1;
    // u5_dot_of_place_4*u4_sq*(6*sin(theta2) - u5_dot_of_place_3*cos(theta1)) +
    //   u5_dot_of_place_6*u5_dot_of_u3_u4*cos(theta1)
    let u5_dot_of_u3_u4_2 = u5_dot_of_place_4 * u4_sq
        * (-u5_dot_of_place_3).mul_add(cos_theta1, S::int(6) * sin_theta2)
        + u5_dot_of_place_6 * u5_dot_of_u3_u4 * cos_theta1;
    // u5' = (u5^2*(sin(theta1)*cos(theta1) - 9*sin(theta2)*cos(theta2)) -
    //   3*sin(theta3)*(cos(theta1)*(u3^2*(3*cos(theta2)^2 - 1) - u4^2*(sin(theta1)*sin(theta2) +
    //   cos(theta1)*cos(theta2))) + cos(theta2)*(3*u3^2*sin(theta1)*sin(theta2) + 7*u4^2)) +
    //   cos(theta3)*(3*u3^2*(3*cos(theta1)*sin(theta2)*cos(theta2) - sin(theta1)*(3*cos(theta2)^2 - 2)) +
    //   3*u4^2*(6*sin(theta2) + cos(theta1)*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2))) +
    //   2*u5^2*(sin(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2) + cos(theta3)*(9*sin(theta2)*cos(theta2) -
    //   sin(theta1)*cos(theta1)))))/(2*(9 + sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)))))
    let u5_dot = u5_dot_of_place_4
        * (u5_sq
            * (sin_theta3 * cos_theta1.mul_add(cos_theta1, u5_dot_of_theta2)
                + u5_dot_of_place_2 * cos_theta3) + S::int(3) * sin_theta1_u3_sq)
        - S::ratio(1, 2) * u5_dot_of_place * u5_dot_of_place_2 * u5_sq
        - S::ratio(9, 2) * u3_sq * cos_theta2
            * u5_dot_of_place_5
                .mul_add(u5_dot_of_place_6, u5_dot_of_place_3 * u5_dot_of_place_4)
        - S::ratio(21, 2) * u5_dot_of_place_6 * cos_theta2_u4_sq
        + S::ratio(3, 2) * u5_dot_of_u3_u4_2;
    // cos_theta1_cos_theta2^2 + sin_theta1_sin_theta2*(2*cos_theta1_cos_theta2 + sin_theta1_sin_theta2)
    let u4_dot_of_place = sin_theta1_sin_theta2
        * cos_theta1_cos_theta2.mul_add(S::int(2), sin_theta1_sin_theta2)
        + cos_theta1_cos_theta2 * cos_theta1_cos_theta2;
    // 1/(3*u4_dot_of_place - 7)
    let u4_dot_of_place_2 = S::int(1) / u4_dot_of_place.mul_add(S::int(3), -S::int(7));
    // u5'*sin(theta3) + u5_sq*cos(theta3)
    let u4_dot_of_u5_u5_dot = u5_sq.mul_add(cos_theta3, u5_dot * sin_theta3);
    // u5'*cos(theta3) - u5_sq*sin(theta3)
    let u4_dot_of_u5_u5_dot_2 = (-u5_sq).mul_add(sin_theta3, u5_dot * cos_theta3);
    // u4_dot_of_u5_u5_dot*sin(theta1) + u4_dot_of_u5_u5_dot_2*cos(theta1)
    let u4_dot_of_u5_u5_dot_3 = u4_dot_of_u5_u5_dot_2
        .mul_add(cos_theta1, u4_dot_of_u5_u5_dot * sin_theta1);
    // u4_dot_of_u5_u5_dot*sin(theta2) + u4_dot_of_u5_u5_dot_2*cos(theta2)
    let u4_dot_of_u5_u5_dot_4 = u4_dot_of_u5_u5_dot_2
        .mul_add(cos_theta2, u4_dot_of_u5_u5_dot * sin_theta2);
    // u4' = (sin(theta1)*(3*u3^2*cos(theta2) + sin(theta1)*sin(theta2)*(3*u4^2*cos(theta2) +
    //   u5^2*cos(theta3) + u5'*sin(theta3)) + cos(theta1)*(cos(theta2)*(3*u4^2*cos(theta2) +
    //   u5^2*cos(theta3) + u5'*sin(theta3)) - sin(theta2)*(3*u4^2*sin(theta2) + u5^2*sin(theta3) -
    //   u5'*cos(theta3)))) + cos(theta2)*(3*u5^2*sin(theta3) - 3*u5'*cos(theta3) +
    //   cos(theta1)^2*(u5'*cos(theta3) - 3*u4^2*sin(theta2) - u5^2*sin(theta3))) -
    //   3*sin(theta2)*(u3^2*cos(theta1) + u5^2*cos(theta3) + u5'*sin(theta3)))/(7 -
    //   3*cos(theta1)^2*cos(theta2)^2 - 3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) +
    //   2*cos(theta1)*cos(theta2)))
    let u4_dot = S::int(3) * u4_dot_of_place_2
        * (-u5_dot_of_place_3).mul_add(u5_dot_of_u3_u4, u4_dot_of_u5_u5_dot_4)
        - u5_dot_of_place_5 * u4_dot_of_place_2 * u4_dot_of_u5_u5_dot_3;
    // u3' = cos(theta1)*(3*u4^2*sin(theta2) + u5^2*sin(theta3) - 3*u4'*cos(theta2) - u5'*cos(theta3))/3 -
    //   sin(theta1)*(3*u4^2*cos(theta2) + u5^2*cos(theta3) + 3*u4'*sin(theta2) + u5'*sin(theta3))/3
    let u3_dot = (-u5_dot_of_place_3).mul_add(u4_sq, -u4_dot * u5_dot_of_place_5)
        - S::ratio(1, 3) * u4_dot_of_u5_u5_dot_3;
    let l_by_6 = S::ratio(1, 6) * l;
    let l_halved = S::ratio(1, 2) * l;
    let l_by_3 = S::ratio(1, 3) * l;
    // u2' = l*(2*u3^2*sin(theta1) + 3*u4^2*sin(theta2) + u5^2*sin(theta3) - 2*u3'*cos(theta1) -
    //   3*u4'*cos(theta2) - u5'*cos(theta3))/6
    let u2_dot = l_halved * (-u4_dot).mul_add(cos_theta2, u4_sq * sin_theta2)
        - u4_dot_of_u5_u5_dot_2 * l_by_6 + l_by_3 * (-u3_dot).mul_add(cos_theta1, sin_theta1_u3_sq);
    // u1' = l*(2*u3^2*cos(theta1) + 3*u4^2*cos(theta2) + u5^2*cos(theta3) + 2*u3'*sin(theta1) +
    //   3*u4'*sin(theta2) + u5'*sin(theta3))/6
    let u1_dot = l_halved * u4_dot.mul_add(sin_theta2, cos_theta2_u4_sq)
        + u4_dot_of_u5_u5_dot * l_by_6 + l_by_3 * u3_sq.mul_add(cos_theta1, u3_dot * sin_theta1);
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
    (
        [x_dot_value, y_dot_value, theta1_dot_value, theta2_dot_value, theta3_dot_value],
        [u1_dot, u2_dot, u3_dot, u4_dot, u5_dot],
    )
}

/// Inverse dynamics: the generalized forces along (u1, u2, u3, u4, u5) that must act beside the loads of the model for the accelerations to be (u1', u2', u3', u4', u5').
///
/// 84 operations, 3 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 5],
    v_dot: &[S; 5],
) -> [S; 5] {
    let Parameters { m, l } = *p;
    let [_, _, theta1, theta2, theta3] = *q;
    let [_, _, u3, u4, u5] = *u;
    let [u1_dot, u2_dot, u3_dot, u4_dot, u5_dot] = *v_dot;
    // Sines and cosines.
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    let (sin_theta3, cos_theta3) = theta3.sin_cos();
    // Shared terms.
    let m_l = m * l;
    let u3_sq = u3 * u3;
    // u3'*sin(theta1) + u3_sq*cos(theta1)
    let tau1_of_u3_u3_dot = u3_sq.mul_add(cos_theta1, u3_dot * sin_theta1);
    let m_times_3 = S::int(3) * m;
    let u4_sq = u4 * u4;
    // u4'*sin(theta2) + u4_sq*cos(theta2)
    let tau1_of_u4_u4_dot = u4_sq.mul_add(cos_theta2, u4_dot * sin_theta2);
    let u5_sq = u5 * u5;
    // u5'*sin(theta3) + u5_sq*cos(theta3)
    let tau1_of_u5_u5_dot = u5_sq.mul_add(cos_theta3, u5_dot * sin_theta3);
    // 3*tau1_of_u4_u4_dot + tau1_of_u5_u5_dot
    let tau1_of_motion = tau1_of_u4_u4_dot.mul_add(S::int(3), tau1_of_u5_u5_dot);
    let m_l_halved = S::ratio(1, 2) * m_l;
    // u3_sq*sin(theta1) - u3'*cos(theta1)
    let tau2_of_u3_u3_dot = (-u3_dot).mul_add(cos_theta1, u3_sq * sin_theta1);
    // u4_sq*sin(theta2) - u4'*cos(theta2)
    let tau2_of_u4_u4_dot = (-u4_dot).mul_add(cos_theta2, u4_sq * sin_theta2);
    // u5_sq*sin(theta3) - u5'*cos(theta3)
    let tau2_of_u5_u5_dot = (-u5_dot).mul_add(cos_theta3, u5_sq * sin_theta3);
    // 3*tau2_of_u4_u4_dot + tau2_of_u5_u5_dot
    let tau2_of_motion = tau2_of_u4_u4_dot.mul_add(S::int(3), tau2_of_u5_u5_dot);
    let l_m_l = l * m_l;
    let l_m_l_halved = S::ratio(1, 2) * l_m_l;
    let m_l_doubled = S::int(2) * m_l;
    // u2'*m_l_doubled - tau2_of_u3_u3_dot*l_m_l
    let tau4_of_motion = (-tau2_of_u3_u3_dot).mul_add(l_m_l, u2_dot * m_l_doubled);
    // u1'*m_l_doubled - tau1_of_u3_u3_dot*l_m_l
    let tau4_of_motion_2 = (-tau1_of_u3_u3_dot).mul_add(l_m_l, u1_dot * m_l_doubled);
    // tau4_of_motion*cos(theta2) - tau4_of_motion_2*sin(theta2)
    let tau4_of_motion_3 = (-tau4_of_motion_2)
        .mul_add(sin_theta2, tau4_of_motion * cos_theta2);
    // tau4_of_motion*cos(theta3) - tau4_of_motion_2*sin(theta3)
    let tau5_of_motion = (-tau4_of_motion_2)
        .mul_add(sin_theta3, tau4_of_motion * cos_theta3);
    // Values.
    // tau1 = 3*m*u1' - m*l*(2*u3^2*cos(theta1) + 3*u4^2*cos(theta2) + u5^2*cos(theta3))/2 -
    //   m*l*u3'*sin(theta1) - 3*m*l*u4'*sin(theta2)/2 - m*l*u5'*sin(theta3)/2
    let tau1 = (-m_l).mul_add(tau1_of_u3_u3_dot, u1_dot * m_times_3) - tau1_of_motion * m_l_halved;
    // tau2 = 3*m*u2' - m*l*(2*u3^2*sin(theta1) + 3*u4^2*sin(theta2) + u5^2*sin(theta3))/2 +
    //   m*l*u3'*cos(theta1) + 3*m*l*u4'*cos(theta2)/2 + m*l*u5'*cos(theta3)/2
    let tau2 = (-m_l).mul_add(tau2_of_u3_u3_dot, u2_dot * m_times_3) - m_l_halved * tau2_of_motion;
    // tau3 = m*l^2*(3*u4^2*sin(theta1 - theta2) + u5^2*sin(theta1 - theta3))/4 - m*l*u1'*sin(theta1) +
    //   m*l*u2'*cos(theta1) + 7*m*l^2*u3'/12 + 3*m*l^2*u4'*cos(theta1 - theta2)/4 + m*l^2*u5'*cos(theta1 -
    //   theta3)/4
    let tau3 = m_l * (-u1_dot).mul_add(sin_theta1, u2_dot * cos_theta1)
        + S::ratio(7, 12) * u3_dot * l_m_l
        + S::ratio(1, 4) * l_m_l
            * (-tau2_of_motion).mul_add(cos_theta1, tau1_of_motion * sin_theta1);
    // tau4 = m*l^2*(2*u5^2*sin(theta2 - theta3) - 3*u3^2*sin(theta1 - theta2))/4 - 3*m*l*u1'*sin(theta2)/2
    //   + 3*m*l*u2'*cos(theta2)/2 + 3*m*l^2*u3'*cos(theta1 - theta2)/4 + 4*m*l^2*u4'/3 +
    //   m*l^2*u5'*cos(theta2 - theta3)/2
    let tau4 = S::ratio(4, 3) * u4_dot * l_m_l
        + l_m_l_halved * (-tau2_of_u5_u5_dot).mul_add(cos_theta2, tau1_of_u5_u5_dot * sin_theta2)
        + S::ratio(3, 4) * tau4_of_motion_3;
    // tau5 = m*l*u2'*cos(theta3)/2 - m*l^2*(u3^2*sin(theta1 - theta3) + 2*u4^2*sin(theta2 - theta3))/4 -
    //   m*l*u1'*sin(theta3)/2 + m*l^2*u3'*cos(theta1 - theta3)/4 + m*l^2*u4'*cos(theta2 - theta3)/2 +
    //   m*l^2*u5'/3
    let tau5 = S::ratio(1, 3) * u5_dot * l_m_l
        + l_m_l_halved * (-tau2_of_u4_u4_dot).mul_add(cos_theta3, tau1_of_u4_u4_dot * sin_theta3)
        + S::ratio(1, 4) * tau5_of_motion;
    [tau1, tau2, tau3, tau4, tau5]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 5],
    direction: &[S; 10],
) -> [S; 10] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[5 + i],
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
