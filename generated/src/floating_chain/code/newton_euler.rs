//! Chain of three rods floating in a plane: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/floating_chain/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{
    accelerations, coordinate_rates, derivative, kinetic_energy, potential_energy,
};

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows rod1 force a1, rod1 force a2, rod1 moment a3, rod2 force b1, rod2 force b2, rod2 moment b3, rod3 force c1, rod3 force c2, rod3 moment c3.
///
/// 50 operations, 3 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 5],
) -> [[S; 9]; 9] {
    let Parameters { m, l } = *p;
    let [_, _, theta1, theta2, theta3] = *q;
    // Sines and cosines.
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    let (sin_theta3, cos_theta3) = theta3.sin_cos();
    // Shared terms.
    let m_cos_theta1 = m * cos_theta1;
    let m_sin_theta1 = m * sin_theta1;
    let m_l = m * l;
    let l_m_l_by_12 = S::ratio(1, 12) * l * m_l;
    let l_halved = S::ratio(1, 2) * l;
    let m_cos_theta2 = m * cos_theta2;
    let m_sin_theta2 = m * sin_theta2;
    let m_l_halved = m * l_halved;
    let sin_theta1_m_l_halved = m_l_halved * sin_theta1;
    let cos_theta1_m_l_halved = m_l_halved * cos_theta1;
    let sin_theta2_l_halved = l_halved * sin_theta2;
    let cos_theta2_l_halved = l_halved * cos_theta2;
    let m_cos_theta3 = m * cos_theta3;
    let m_sin_theta3 = m * sin_theta3;
    // -sin(theta2)
    let minus_sin_theta2 = -sin_theta2;
    // -cos(theta2)
    let minus_cos_theta2 = -cos_theta2;
    // -cos(theta3)
    let minus_cos_theta3 = -cos_theta3;
    // -sin_theta2_l_halved
    let m66_of_l_theta2 = -sin_theta2_l_halved;
    // Entries that are not zero.
    // M11 = m*cos(theta1)
    let m11 = m_cos_theta1;
    // M12 = m*sin(theta1)
    let m12 = m_sin_theta1;
    // M16 = cos(theta1)
    let m16 = cos_theta1;
    // M17 = sin(theta1)
    let m17 = sin_theta1;
    // M21 = -m*sin(theta1)
    let m21 = -m_sin_theta1;
    // M22 = m*cos(theta1)
    let m22 = m_cos_theta1;
    // M26 = -sin(theta1)
    let m26 = -sin_theta1;
    // M27 = cos(theta1)
    let m27 = cos_theta1;
    // M33 = m*l^2/12
    let m33 = l_m_l_by_12;
    // M36 = -l*sin(theta1)/2
    let m36 = -l_halved * sin_theta1;
    // M37 = l*cos(theta1)/2
    let m37 = l_halved * cos_theta1;
    // M41 = m*cos(theta2)
    let m41 = m_cos_theta2;
    // M42 = m*sin(theta2)
    let m42 = m_sin_theta2;
    // M43 = -m*l*sin(theta1 - theta2)/2
    let m43 = (-sin_theta1_m_l_halved)
        .mul_add(cos_theta2, cos_theta1_m_l_halved * sin_theta2);
    // M46 = -cos(theta2)
    let m46 = minus_cos_theta2;
    // M47 = -sin(theta2)
    let m47 = minus_sin_theta2;
    // M48 = cos(theta2)
    let m48 = cos_theta2;
    // M49 = sin(theta2)
    let m49 = sin_theta2;
    // M51 = -m*sin(theta2)
    let m51 = -m_sin_theta2;
    // M52 = m*cos(theta2)
    let m52 = m_cos_theta2;
    // M53 = m*l*cos(theta1 - theta2)/2
    let m53 = cos_theta1_m_l_halved
        .mul_add(cos_theta2, sin_theta1_m_l_halved * sin_theta2);
    // M54 = m*l/2
    let m54 = m_l_halved;
    // M56 = sin(theta2)
    let m56 = sin_theta2;
    // M57 = -cos(theta2)
    let m57 = minus_cos_theta2;
    // M58 = -sin(theta2)
    let m58 = minus_sin_theta2;
    // M59 = cos(theta2)
    let m59 = cos_theta2;
    // M64 = m*l^2/12
    let m64 = l_m_l_by_12;
    // M66 = -l*sin(theta2)/2
    let m66 = m66_of_l_theta2;
    // M67 = l*cos(theta2)/2
    let m67 = cos_theta2_l_halved;
    // M68 = -l*sin(theta2)/2
    let m68 = m66_of_l_theta2;
    // M69 = l*cos(theta2)/2
    let m69 = cos_theta2_l_halved;
    // M71 = m*cos(theta3)
    let m71 = m_cos_theta3;
    // M72 = m*sin(theta3)
    let m72 = m_sin_theta3;
    // M73 = -m*l*sin(theta1 - theta3)/2
    let m73 = (-sin_theta1_m_l_halved)
        .mul_add(cos_theta3, cos_theta1_m_l_halved * sin_theta3);
    // M74 = -m*l*sin(theta2 - theta3)
    let m74 = m_l * (-sin_theta2).mul_add(cos_theta3, cos_theta2 * sin_theta3);
    // M78 = -cos(theta3)
    let m78 = minus_cos_theta3;
    // M79 = -sin(theta3)
    let m79 = -sin_theta3;
    // M81 = -m*sin(theta3)
    let m81 = -m_sin_theta3;
    // M82 = m*cos(theta3)
    let m82 = m_cos_theta3;
    // M83 = m*l*cos(theta1 - theta3)/2
    let m83 = cos_theta1_m_l_halved
        .mul_add(cos_theta3, sin_theta1_m_l_halved * sin_theta3);
    // M84 = m*l*cos(theta2 - theta3)
    let m84 = m_l * cos_theta2.mul_add(cos_theta3, sin_theta2 * sin_theta3);
    // M85 = m*l/2
    let m85 = m_l_halved;
    // M88 = sin(theta3)
    let m88 = sin_theta3;
    // M89 = -cos(theta3)
    let m89 = minus_cos_theta3;
    // M95 = m*l^2/12
    let m95 = l_m_l_by_12;
    // M98 = -l*sin(theta3)/2
    let m98 = -l_halved * sin_theta3;
    // M99 = l*cos(theta3)/2
    let m99 = l_halved * cos_theta3;
    let zero = S::int(0);
    [
        [m11, m12, zero, zero, zero, m16, m17, zero, zero],
        [m21, m22, zero, zero, zero, m26, m27, zero, zero],
        [zero, zero, m33, zero, zero, m36, m37, zero, zero],
        [m41, m42, m43, zero, zero, m46, m47, m48, m49],
        [m51, m52, m53, m54, zero, m56, m57, m58, m59],
        [zero, zero, zero, m64, zero, m66, m67, m68, m69],
        [m71, m72, m73, m74, zero, zero, zero, m78, m79],
        [m81, m82, m83, m84, m85, zero, zero, m88, m89],
        [zero, zero, zero, zero, m95, zero, zero, m98, m99],
    ]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5', pin1_x, pin1_y, pin2_x, pin2_y).
///
/// 26 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> [S; 9] {
    let Parameters { m, l } = *p;
    let [_, _, theta1, theta2, theta3] = *q;
    let [_, _, u3, u4, u5] = *u;
    // Shared terms.
    let m_l = m * l;
    let m_l_halved = S::ratio(1, 2) * m_l;
    let u4_sq = u4 * u4;
    let u3_sq = u3 * u3;
    let m_l_halved_u3_sq = m_l_halved * u3_sq;
    // theta1 - theta2
    let theta1_minus_theta2 = theta1 - theta2;
    // Sines and cosines.
    let (sin_theta1_minus_theta2, cos_theta1_minus_theta2) = theta1_minus_theta2
        .sin_cos();
    // 2*u4_sq*cos(theta1 - theta2) + u3_sq
    let f7_of_u3_u4 = (u4_sq * cos_theta1_minus_theta2).mul_add(S::int(2), u3_sq);
    let f7_of_u4 = m_l * u4_sq * sin_theta1_minus_theta2;
    // theta1 - theta3
    let theta1_minus_theta3 = theta1 - theta3;
    let (sin_theta1_minus_theta3, cos_theta1_minus_theta3) = theta1_minus_theta3
        .sin_cos();
    // Values.
    // f4 = m*l*(u3^2*cos(theta1 - theta2) + u4^2)/2
    let f4 = m_l_halved_u3_sq.mul_add(cos_theta1_minus_theta2, m_l_halved * u4_sq);
    // f5 = m*l*u3^2*sin(theta1 - theta2)/2
    let f5 = m_l_halved_u3_sq * sin_theta1_minus_theta2;
    // f7 = m*l*(u3^2*cos(theta1 - theta3) + 2*u4^2*cos(theta2 - theta3) + u5^2)/2
    let f7 = m_l_halved * f7_of_u3_u4.mul_add(cos_theta1_minus_theta3, u5 * u5)
        + f7_of_u4 * sin_theta1_minus_theta3;
    // f8 = m*l*(u3^2*sin(theta1 - theta3) + 2*u4^2*sin(theta2 - theta3))/2
    let f8 = (-f7_of_u4)
        .mul_add(
            cos_theta1_minus_theta3,
            m_l_halved * f7_of_u3_u4 * sin_theta1_minus_theta3,
        );
    let zero = S::int(0);
    [zero, zero, zero, f4, f5, zero, f7, f8, zero]
}

/// Jacobian of the derivative by the state; columns x, y, theta1, theta2, theta3, u1, u2, u3, u4, u5.
///
/// 544 operations, 3 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> [[S; 10]; 10] {
    let Parameters { l, .. } = *p;
    let [_, _, theta1, theta2, theta3] = *q;
    let [_, _, u3, u4, u5] = *u;
    // Sines and cosines.
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    let (sin_theta3, cos_theta3) = theta3.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let u5_sq = u5 * u5;
    let sin_theta1_cos_theta1 = sin_theta1 * cos_theta1;
    let cos_theta2_times_9 = S::int(9) * cos_theta2;
    let u5_dot_of_theta2 = cos_theta2_times_9 * sin_theta2;
    // u5_dot_of_theta2 - sin_theta1_cos_theta1
    let u5_dot_of_place = u5_dot_of_theta2 - sin_theta1_cos_theta1;
    // 4 - cos_theta2_times_9*cos(theta2)
    let u5_dot_of_theta2_2 = (-cos_theta2_times_9).mul_add(cos_theta2, S::int(4));
    let cos_theta1_sq = cos_theta1 * cos_theta1;
    // u5_dot_of_theta2_2 + cos_theta1_sq
    let u5_dot_of_place_2 = u5_dot_of_theta2_2 + cos_theta1_sq;
    // u5_dot_of_place*cos(theta3) + u5_dot_of_place_2*sin(theta3)
    let u5_dot_of_place_3 = u5_dot_of_place_2
        .mul_add(sin_theta3, u5_dot_of_place * cos_theta3);
    let cos_theta3_doubled = S::int(2) * cos_theta3;
    // u5_dot_of_place_3*cos_theta3_doubled - u5_dot_of_place
    let u5_dot_of_place_4 = u5_dot_of_place_3
        .mul_add(cos_theta3_doubled, -u5_dot_of_place);
    let cos_theta3_sq = cos_theta3 * cos_theta3;
    // -u5_dot_of_theta2_2 - cos_theta3_sq
    let u5_dot_of_place_5 = -u5_dot_of_theta2_2 - cos_theta3_sq;
    // u5_dot_of_theta2 - sin(theta3)*cos(theta3)
    let u5_dot_of_place_6 = (-sin_theta3).mul_add(cos_theta3, u5_dot_of_theta2);
    // u5_dot_of_place_5*sin(theta1) - u5_dot_of_place_6*cos(theta1)
    let u5_dot_of_place_7 = (-u5_dot_of_place_6)
        .mul_add(cos_theta1, u5_dot_of_place_5 * sin_theta1);
    let sin_theta2_sin_theta3 = sin_theta2 * sin_theta3;
    // cos(theta2)*cos(theta3) + sin_theta2_sin_theta3
    let u5_dot_of_place_8 = cos_theta2.mul_add(cos_theta3, sin_theta2_sin_theta3);
    // 5*cos(theta3) - cos_theta2_times_9*u5_dot_of_place_8
    let u5_dot_of_place_9 = (-cos_theta2_times_9)
        .mul_add(u5_dot_of_place_8, S::int(5) * cos_theta3);
    // 1/(9 + u5_dot_of_place_7*sin(theta1) + u5_dot_of_place_9*cos(theta3))
    let u5_dot_of_place_10 = S::int(1)
        / (u5_dot_of_place_7.mul_add(sin_theta1, S::int(9)) + u5_dot_of_place_9 * cos_theta3);
    let u5_dot_of_place_11 = S::ratio(1, 2) * u5_dot_of_place_10;
    let u5_dot_of_place_12 = S::ratio(3, 2) * u5_dot_of_place_10;
    let u4_sq = u4 * u4;
    let cos_theta1_sin_theta2 = cos_theta1 * sin_theta2;
    let sin_theta1_cos_theta2 = sin_theta1 * cos_theta2;
    // sin_theta1_cos_theta2 - cos_theta1_sin_theta2
    let u5_dot_of_place_13 = sin_theta1_cos_theta2 - cos_theta1_sin_theta2;
    let u5_dot_of_place_14 = u5_dot_of_place_13 * cos_theta1;
    // 6*sin(theta2) - u5_dot_of_place_14
    let u5_dot_of_place_15 = sin_theta2.mul_add(S::int(6), -u5_dot_of_place_14);
    let sin_theta1_sin_theta2 = sin_theta1 * sin_theta2;
    // cos(theta1)*cos(theta2) + sin_theta1_sin_theta2
    let u5_dot_of_place_16 = cos_theta1.mul_add(cos_theta2, sin_theta1_sin_theta2);
    let cos_theta1_sin_theta3 = cos_theta1 * sin_theta3;
    let cos_theta2_sin_theta3 = cos_theta2 * sin_theta3;
    // u5_dot_of_place_15*cos(theta3) + u5_dot_of_place_16*cos_theta1_sin_theta3
    let u5_dot_of_place_17 = u5_dot_of_place_16
        .mul_add(cos_theta1_sin_theta3, u5_dot_of_place_15 * cos_theta3);
    // 7*cos_theta2_sin_theta3 - u5_dot_of_place_17
    let u5_dot_of_place_18 = cos_theta2_sin_theta3
        .mul_add(S::int(7), -u5_dot_of_place_17);
    let u3_sq = u3 * u3;
    let cos_theta2_times_3 = S::int(3) * cos_theta2;
    // cos_theta3_doubled*sin(theta1) + cos_theta1_sin_theta3
    let u5_dot_of_place_19 = cos_theta3_doubled
        .mul_add(sin_theta1, cos_theta1_sin_theta3);
    // cos_theta2_times_3*(u5_dot_of_place_13*cos(theta3) + u5_dot_of_place_16*sin(theta3)) -
    //   u5_dot_of_place_19
    let u5_dot_of_place_20 = cos_theta2_times_3
        * u5_dot_of_place_16.mul_add(sin_theta3, u5_dot_of_place_13 * cos_theta3)
        - u5_dot_of_place_19;
    // u5' = (u5^2*(sin(theta1)*cos(theta1) - 9*sin(theta2)*cos(theta2)) -
    //   3*sin(theta3)*(cos(theta1)*(u3^2*(3*cos(theta2)^2 - 1) - u4^2*(sin(theta1)*sin(theta2) +
    //   cos(theta1)*cos(theta2))) + cos(theta2)*(3*u3^2*sin(theta1)*sin(theta2) + 7*u4^2)) +
    //   cos(theta3)*(3*u3^2*(3*cos(theta1)*sin(theta2)*cos(theta2) - sin(theta1)*(3*cos(theta2)^2 - 2)) +
    //   3*u4^2*(6*sin(theta2) + cos(theta1)*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2))) +
    //   2*u5^2*(sin(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2) + cos(theta3)*(9*sin(theta2)*cos(theta2) -
    //   sin(theta1)*cos(theta1)))))/(2*(9 + sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)))))
    let u5_dot = -u5_dot_of_place_12 * u3_sq.mul_add(u5_dot_of_place_20, u4_sq * u5_dot_of_place_18)
        + u5_sq * u5_dot_of_place_4 * u5_dot_of_place_11;
    let cos_theta2_doubled = S::int(2) * cos_theta2;
    let u4_dot_of_place = cos_theta2_doubled * cos_theta1;
    // sin_theta1_sin_theta2 + u4_dot_of_place
    let u4_dot_of_place_2 = sin_theta1_sin_theta2 + u4_dot_of_place;
    let u4_dot_of_theta2 = cos_theta2_times_3 * cos_theta2;
    // 1/(3*sin_theta1_sin_theta2*u4_dot_of_place_2 - 7 + cos_theta1_sq*u4_dot_of_theta2)
    let u4_dot_of_place_3 = S::int(1)
        / ((sin_theta1_sin_theta2 * u4_dot_of_place_2).mul_add(S::int(3), -S::int(7))
            + cos_theta1_sq * u4_dot_of_theta2);
    let u4_dot_of_place_4 = S::int(3) * u4_dot_of_place_3;
    // cos(theta1)*(u5_dot_of_place_13*cos_theta2_doubled - sin(theta1))
    let u4_dot_of_place_5 = cos_theta1
        * u5_dot_of_place_13.mul_add(cos_theta2_doubled, -sin_theta1);
    // u5'*cos(theta3) - u5_sq*sin(theta3)
    let u4_dot_of_u5_u5_dot = (-u5_sq).mul_add(sin_theta3, u5_dot * cos_theta3);
    let u4_dot_of_place_6 = u5_dot_of_place_16 * cos_theta1;
    // cos_theta2_times_3 - u4_dot_of_place_6
    let u4_dot_of_place_7 = cos_theta2_times_3 - u4_dot_of_place_6;
    // u5'*sin(theta3) + u5_sq*cos(theta3)
    let u4_dot_of_u5_u5_dot_2 = u5_sq.mul_add(cos_theta3, u5_dot * sin_theta3);
    // 2*sin(theta2) - u5_dot_of_place_14
    let u4_dot_of_place_8 = sin_theta2.mul_add(S::int(2), -u5_dot_of_place_14);
    let u4_sq_cos_theta2_times_3 = u4_sq * cos_theta2_times_3;
    let u3_sq_times_3 = S::int(3) * u3_sq;
    // u4_dot_of_u5_u5_dot*u4_dot_of_place_7 + u4_dot_of_u5_u5_dot_2*u4_dot_of_place_8
    let u4_dot_of_u5_u5_dot_3 = u4_dot_of_u5_u5_dot_2
        .mul_add(u4_dot_of_place_8, u4_dot_of_u5_u5_dot * u4_dot_of_place_7);
    // u4_sq_cos_theta2_times_3*sin(theta2) + u5_dot_of_place_13*u3_sq_times_3
    let u4_dot_of_u3_u4 = u5_dot_of_place_13
        .mul_add(u3_sq_times_3, u4_sq_cos_theta2_times_3 * sin_theta2);
    // u4' = (sin(theta1)*(3*u3^2*cos(theta2) + sin(theta1)*sin(theta2)*(3*u4^2*cos(theta2) +
    //   u5^2*cos(theta3) + u5'*sin(theta3)) + cos(theta1)*(cos(theta2)*(3*u4^2*cos(theta2) +
    //   u5^2*cos(theta3) + u5'*sin(theta3)) - sin(theta2)*(3*u4^2*sin(theta2) + u5^2*sin(theta3) -
    //   u5'*cos(theta3)))) + cos(theta2)*(3*u5^2*sin(theta3) - 3*u5'*cos(theta3) +
    //   cos(theta1)^2*(u5'*cos(theta3) - 3*u4^2*sin(theta2) - u5^2*sin(theta3))) -
    //   3*sin(theta2)*(u3^2*cos(theta1) + u5^2*cos(theta3) + u5'*sin(theta3)))/(7 -
    //   3*cos(theta1)^2*cos(theta2)^2 - 3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) +
    //   2*cos(theta1)*cos(theta2)))
    let u4_dot = u4_dot_of_place_3 * (u4_dot_of_u5_u5_dot_3 - u4_dot_of_u3_u4)
        - u4_sq * u4_dot_of_place_4 * u4_dot_of_place_5;
    let u4_sq_u5_dot_of_place_13 = u4_sq * u5_dot_of_place_13;
    // u4_dot_of_u5_u5_dot*cos(theta1) + u4_dot_of_u5_u5_dot_2*sin(theta1)
    let u3_dot_of_u5_u5_dot = u4_dot_of_u5_u5_dot_2
        .mul_add(sin_theta1, u4_dot_of_u5_u5_dot * cos_theta1);
    // u3' = cos(theta1)*(3*u4^2*sin(theta2) + u5^2*sin(theta3) - 3*u4'*cos(theta2) - u5'*cos(theta3))/3 -
    //   sin(theta1)*(3*u4^2*cos(theta2) + u5^2*cos(theta3) + 3*u4'*sin(theta2) + u5'*sin(theta3))/3
    let u3_dot = (-u4_dot).mul_add(u5_dot_of_place_16, -u4_sq_u5_dot_of_place_13)
        - S::ratio(1, 3) * u3_dot_of_u5_u5_dot;
    // u4_dot_of_theta2 - 2
    let u5_dot_by_theta1_of_theta2 = u4_dot_of_theta2 - S::int(2);
    let u4_sq_times_3 = S::int(3) * u4_sq;
    // sin(theta1)^2 - cos_theta1_sq
    let u5_dot_by_theta1_of_theta1 = sin_theta1.mul_add(sin_theta1, -cos_theta1_sq);
    let u5_sq_doubled = S::int(2) * u5_sq;
    let u4_sq_u5_dot_of_place_16 = u4_sq * u5_dot_of_place_16;
    // u3_sq*(u4_dot_of_theta2 - 1) - u4_sq_u5_dot_of_place_16
    let u5_dot_by_theta1_of_u3_u4 = u3_sq * (u4_dot_of_theta2 - S::int(1))
        - u4_sq_u5_dot_of_place_16;
    let u3_sq_cos_theta2_times_3 = u3_sq * cos_theta2_times_3;
    let sin_theta3_times_3 = S::int(3) * sin_theta3;
    // u3_sq_times_3*(cos_theta1_sin_theta2*cos_theta2_times_3 - u5_dot_by_theta1_of_theta2*sin(theta1)) +
    //   u5_dot_of_place_15*u4_sq_times_3 + u5_dot_of_place_3*u5_sq_doubled
    let u5_dot_by_theta1_of_u3_u4_u5 = u3_sq_times_3
        * (-u5_dot_by_theta1_of_theta2)
            .mul_add(sin_theta1, cos_theta1_sin_theta2 * cos_theta2_times_3)
        + u5_dot_of_place_15 * u4_sq_times_3 + u5_dot_of_place_3 * u5_sq_doubled;
    // 7*u4_sq + sin_theta1_sin_theta2*u3_sq_times_3
    let u5_dot_by_theta1_of_u3_u4_2 = sin_theta1_sin_theta2
        .mul_add(u3_sq_times_3, S::int(7) * u4_sq);
    // u5_dot_by_theta1_of_u3_u4*cos(theta1) + u5_dot_by_theta1_of_u3_u4_2*cos(theta2)
    let u5_dot_by_theta1_of_u3_u4_3 = u5_dot_by_theta1_of_u3_u4_2
        .mul_add(cos_theta2, u5_dot_by_theta1_of_u3_u4 * cos_theta1);
    // u5_dot_of_place_10*(u5_dot_by_theta1_of_u3_u4_u5*cos(theta3) - u5_sq*u5_dot_of_place -
    //   sin_theta3_times_3*u5_dot_by_theta1_of_u3_u4_3)
    let u5_dot_by_theta1_of_u3_u4_u5_2 = u5_dot_of_place_10
        * ((-u5_sq).mul_add(u5_dot_of_place, u5_dot_by_theta1_of_u3_u4_u5 * cos_theta3)
            - sin_theta3_times_3 * u5_dot_by_theta1_of_u3_u4_3);
    let u5_dot_by_theta1_of_u3_u4_u5_3 = u5_dot_of_place_11 * u5_dot_by_theta1_of_u3_u4_u5_2;
    // u5_dot_by_theta1 = (cos(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) +
    //   sin(theta1)*(cos(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   sin(theta1)*(9*sin(theta2)*cos(theta2) -
    //   sin(theta3)*cos(theta3))))*(3*sin(theta3)*(cos(theta1)*(u3^2*(3*cos(theta2)^2 - 1) -
    //   u4^2*(sin(theta1)*sin(theta2) + cos(theta1)*cos(theta2))) +
    //   cos(theta2)*(3*u3^2*sin(theta1)*sin(theta2) + 7*u4^2)) - u5^2*(sin(theta1)*cos(theta1) -
    //   9*sin(theta2)*cos(theta2)) - cos(theta3)*(3*u3^2*(3*cos(theta1)*sin(theta2)*cos(theta2) -
    //   sin(theta1)*(3*cos(theta2)^2 - 2)) + 3*u4^2*(6*sin(theta2) + cos(theta1)*(cos(theta1)*sin(theta2) -
    //   sin(theta1)*cos(theta2))) + 2*u5^2*(sin(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2) +
    //   cos(theta3)*(9*sin(theta2)*cos(theta2) - sin(theta1)*cos(theta1)))))/(2*(9 +
    //   sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3))))^2) -
    //   (3*sin(theta3)*(3*u3^2*cos(theta1)*sin(theta2)*cos(theta2) -
    //   u4^2*cos(theta1)*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2)) -
    //   sin(theta1)*(u3^2*(3*cos(theta2)^2 - 1) - u4^2*(sin(theta1)*sin(theta2) + cos(theta1)*cos(theta2))))
    //   + u5^2*(sin(theta1)^2 - cos(theta1)^2) + cos(theta3)*(3*u3^2*(3*sin(theta1)*sin(theta2)*cos(theta2)
    //   + cos(theta1)*(3*cos(theta2)^2 - 2)) + 3*u4^2*(cos(theta1)*(sin(theta1)*sin(theta2) +
    //   cos(theta1)*cos(theta2)) - sin(theta1)*(sin(theta1)*cos(theta2) - cos(theta1)*sin(theta2))) +
    //   2*u5^2*(2*sin(theta1)*cos(theta1)*sin(theta3) + cos(theta3)*(cos(theta1)^2 - sin(theta1)^2))))/(2*(9
    //   + sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)))))
    let u5_dot_by_theta1 = -u5_dot_of_place_11
        * (cos_theta3
            * (u3_sq_times_3
                * u5_dot_by_theta1_of_theta2
                    .mul_add(cos_theta1, sin_theta1_sin_theta2 * cos_theta2_times_3)
                + u4_sq_times_3 * (-u5_dot_of_place_13).mul_add(sin_theta1, u4_dot_of_place_6)
                + u5_sq_doubled
                    * (-u5_dot_by_theta1_of_theta1)
                        .mul_add(
                            cos_theta3,
                            S::int(2) * cos_theta1_sin_theta3 * sin_theta1,
                        )) + u5_sq * u5_dot_by_theta1_of_theta1
            + sin_theta3_times_3
                * ((-u5_dot_by_theta1_of_u3_u4)
                    .mul_add(sin_theta1, u4_sq * u5_dot_of_place_14)
                    + cos_theta1_sin_theta2 * u3_sq_cos_theta2_times_3))
        - u5_dot_by_theta1_of_u3_u4_u5_3
            * (sin_theta1 * u5_dot_of_place_6.mul_add(sin_theta1, u5_dot_of_place_5 * cos_theta1)
                + u5_dot_of_place_7 * cos_theta1);
    let sin_theta2_times_3 = S::int(3) * sin_theta2;
    let u4_sq_sin_theta2_times_3 = u4_sq * sin_theta2_times_3;
    // u4_sq_sin_theta2_times_3 - u4_dot_of_u5_u5_dot
    let u4_dot_by_theta1_of_u4_u5_u5_dot = u4_sq_sin_theta2_times_3 - u4_dot_of_u5_u5_dot;
    // u4_dot_of_u5_u5_dot_2 + u4_sq_cos_theta2_times_3
    let u4_dot_by_theta1_of_u4_u5_u5_dot_2 = u4_dot_of_u5_u5_dot_2 + u4_sq_cos_theta2_times_3;
    // u4_dot_by_theta1_of_u4_u5_u5_dot*sin(theta2) - u4_dot_by_theta1_of_u4_u5_u5_dot_2*cos(theta2)
    let u4_dot_by_theta1_of_u4_u5_u5_dot_3 = (-u4_dot_by_theta1_of_u4_u5_u5_dot_2)
        .mul_add(cos_theta2, u4_dot_by_theta1_of_u4_u5_u5_dot * sin_theta2);
    // u3_sq_cos_theta2_times_3 + sin_theta1_sin_theta2*u4_dot_by_theta1_of_u4_u5_u5_dot_2 -
    //   u4_dot_by_theta1_of_u4_u5_u5_dot_3*cos(theta1)
    let u4_dot_by_theta1_of_motion = sin_theta1_sin_theta2
        .mul_add(u4_dot_by_theta1_of_u4_u5_u5_dot_2, u3_sq_cos_theta2_times_3)
        - u4_dot_by_theta1_of_u4_u5_u5_dot_3 * cos_theta1;
    let sin_theta2_cos_theta3 = sin_theta2 * cos_theta3;
    let u4_dot_by_theta1_of_place = u5_dot_by_theta1 * sin_theta3;
    let cos_theta3_times_3 = S::int(3) * cos_theta3;
    // -3*u4_dot_of_u5_u5_dot - cos_theta1_sq*u4_dot_by_theta1_of_u4_u5_u5_dot
    let u4_dot_by_theta1_of_u4_u5_u5_dot_4 = (-cos_theta1_sq)
        .mul_add(u4_dot_by_theta1_of_u4_u5_u5_dot, -S::int(3) * u4_dot_of_u5_u5_dot);
    // u3_sq*cos(theta1) + u4_dot_of_u5_u5_dot_2
    let u4_dot_by_theta1_of_u3_u5_u5_dot = u3_sq
        .mul_add(cos_theta1, u4_dot_of_u5_u5_dot_2);
    // u4_dot_of_place_3*u4_dot_of_place_4*(u4_dot_by_theta1_of_motion*sin(theta1) +
    //   u4_dot_by_theta1_of_u4_u5_u5_dot_4*cos(theta2) -
    //   sin_theta2_times_3*u4_dot_by_theta1_of_u3_u5_u5_dot)
    let u4_dot_by_theta1_of_motion_2 = u4_dot_of_place_3 * u4_dot_of_place_4
        * (u4_dot_by_theta1_of_u4_u5_u5_dot_4
            .mul_add(cos_theta2, u4_dot_by_theta1_of_motion * sin_theta1)
            - sin_theta2_times_3 * u4_dot_by_theta1_of_u3_u5_u5_dot);
    // u4_dot_by_theta1 = 3*(cos(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2))
    //   - 2*sin(theta1)*cos(theta1)*cos(theta2)^2 + sin(theta1)*sin(theta2)*(cos(theta1)*sin(theta2) -
    //   2*sin(theta1)*cos(theta2)))*(sin(theta1)*(3*u3^2*cos(theta2) +
    //   sin(theta1)*sin(theta2)*(3*u4^2*cos(theta2) + u5^2*cos(theta3) + u5'*sin(theta3)) +
    //   cos(theta1)*(cos(theta2)*(3*u4^2*cos(theta2) + u5^2*cos(theta3) + u5'*sin(theta3)) -
    //   sin(theta2)*(3*u4^2*sin(theta2) + u5^2*sin(theta3) - u5'*cos(theta3)))) +
    //   cos(theta2)*(3*u5^2*sin(theta3) - 3*u5'*cos(theta3) + cos(theta1)^2*(u5'*cos(theta3) -
    //   3*u4^2*sin(theta2) - u5^2*sin(theta3))) - 3*sin(theta2)*(u3^2*cos(theta1) + u5^2*cos(theta3) +
    //   u5'*sin(theta3)))/(3*cos(theta1)^2*cos(theta2)^2 - 7 +
    //   3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)))^2 +
    //   (cos(theta1)*(3*u3^2*cos(theta2) + sin(theta1)*sin(theta2)*(3*u4^2*cos(theta2) + u5^2*cos(theta3) +
    //   u5'*sin(theta3)) + cos(theta1)*(cos(theta2)*(3*u4^2*cos(theta2) + u5^2*cos(theta3) +
    //   u5'*sin(theta3)) - sin(theta2)*(3*u4^2*sin(theta2) + u5^2*sin(theta3) - u5'*cos(theta3)))) +
    //   sin(theta1)*(cos(theta1)*sin(theta2)*(3*u4^2*cos(theta2) + u5^2*cos(theta3) + u5'*sin(theta3)) +
    //   sin(theta1)*(sin(theta2)*(3*u4^2*sin(theta2) + u5^2*sin(theta3) - u5'*cos(theta3)) -
    //   cos(theta2)*(3*u4^2*cos(theta2) + u5^2*cos(theta3) + u5'*sin(theta3))) +
    //   u5_dot_by_theta1*sin(theta1)*sin(theta2)*sin(theta3) +
    //   cos(theta1)*(u5_dot_by_theta1*cos(theta2)*sin(theta3) + u5_dot_by_theta1*sin(theta2)*cos(theta3))) +
    //   cos(theta2)*(u5_dot_by_theta1*cos(theta1)^2*cos(theta3) - 2*sin(theta1)*cos(theta1)*(u5'*cos(theta3)
    //   - 3*u4^2*sin(theta2) - u5^2*sin(theta3)) - 3*u5_dot_by_theta1*cos(theta3)) +
    //   3*sin(theta2)*(u3^2*sin(theta1) - u5_dot_by_theta1*sin(theta3)))/(7 - 3*cos(theta1)^2*cos(theta2)^2
    //   - 3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)))
    let u4_dot_by_theta1 = u4_dot_by_theta1_of_motion_2
        * (sin_theta1_sin_theta2 * (-cos_theta2_doubled).mul_add(sin_theta1, cos_theta1_sin_theta2)
            - sin_theta1_cos_theta2 * u4_dot_of_place + cos_theta1_sin_theta2 * u4_dot_of_place_2)
        - u4_dot_of_place_3
            * (sin_theta1
                * (cos_theta1_sin_theta2 * u4_dot_by_theta1_of_u4_u5_u5_dot_2
                    + u4_dot_by_theta1_of_u4_u5_u5_dot_3 * sin_theta1
                    + u5_dot_by_theta1 * cos_theta1
                        * (cos_theta2_sin_theta3 + sin_theta2_cos_theta3)
                    + sin_theta1_sin_theta2 * u4_dot_by_theta1_of_place)
                + u4_dot_by_theta1_of_motion * cos_theta1
                + sin_theta2_times_3 * u3_sq.mul_add(sin_theta1, -u4_dot_by_theta1_of_place)
                + cos_theta2
                    * (u5_dot_by_theta1 * cos_theta1_sq.mul_add(cos_theta3, -cos_theta3_times_3)
                        + S::int(2) * sin_theta1_cos_theta1 * u4_dot_by_theta1_of_u4_u5_u5_dot));
    let sin_theta1_sin_theta3 = sin_theta1 * sin_theta3;
    // cos(theta1)*cos(theta3) + sin_theta1_sin_theta3
    let u3_dot_by_theta1_of_place = cos_theta1
        .mul_add(cos_theta3, sin_theta1_sin_theta3);
    let u3_dot_by_theta1_of_place_2 = S::ratio(1, 3) * u3_dot_by_theta1_of_place;
    let u3_dot_by_theta1_of_u4_dot = u4_dot * u5_dot_of_place_13;
    // u4_dot_of_u5_u5_dot*sin(theta1) - u4_dot_of_u5_u5_dot_2*cos(theta1)
    let u3_dot_by_theta1_of_u5_u5_dot = (-u4_dot_of_u5_u5_dot_2)
        .mul_add(cos_theta1, u4_dot_of_u5_u5_dot * sin_theta1);
    let u3_dot_by_theta1_of_u5_u5_dot_2 = S::ratio(1, 3) * u3_dot_by_theta1_of_u5_u5_dot;
    // u3_dot_by_theta1 = sin(theta1)*(3*u4'*cos(theta2) + u5'*cos(theta3) - sin(theta3)*(u5^2 +
    //   u5_dot_by_theta1) - 3*sin(theta2)*(u4^2 + u4_dot_by_theta1))/3 - cos(theta1)*(3*u4'*sin(theta2) +
    //   u5'*sin(theta3) + cos(theta3)*(u5^2 + u5_dot_by_theta1) + 3*cos(theta2)*(u4^2 + u4_dot_by_theta1))/3
    let u3_dot_by_theta1 = (-u4_dot_by_theta1)
        .mul_add(u5_dot_of_place_16, u3_dot_by_theta1_of_u4_dot)
        - u4_sq_u5_dot_of_place_16 - u5_dot_by_theta1 * u3_dot_by_theta1_of_place_2
        + u3_dot_by_theta1_of_u5_u5_dot_2;
    let l_by_3 = S::ratio(1, 3) * l;
    let sin_theta1_l_by_3 = l_by_3 * sin_theta1;
    let l_halved = S::ratio(1, 2) * l;
    let cos_theta2_l_halved = l_halved * cos_theta2;
    let l_by_6 = S::ratio(1, 6) * l;
    let cos_theta3_l_by_6 = l_by_6 * cos_theta3;
    let cos_theta1_l_by_3 = l_by_3 * cos_theta1;
    // u3_dot_by_theta1 - u3_sq
    let u2_dot_by_theta1_of_u3 = u3_dot_by_theta1 - u3_sq;
    // u2_dot_by_theta1 = l*(2*u3'*sin(theta1) - u5_dot_by_theta1*cos(theta3) -
    //   3*u4_dot_by_theta1*cos(theta2) + 2*cos(theta1)*(u3^2 - u3_dot_by_theta1))/6
    let u2_dot_by_theta1 = (-u4_dot_by_theta1)
        .mul_add(cos_theta2_l_halved, u3_dot * sin_theta1_l_by_3)
        - u5_dot_by_theta1 * cos_theta3_l_by_6 - cos_theta1_l_by_3 * u2_dot_by_theta1_of_u3;
    let sin_theta2_l_halved = l_halved * sin_theta2;
    let sin_theta3_l_by_6 = l_by_6 * sin_theta3;
    // u1_dot_by_theta1 = l*(2*u3'*cos(theta1) + u5_dot_by_theta1*sin(theta3) +
    //   3*u4_dot_by_theta1*sin(theta2) + 2*sin(theta1)*(u3_dot_by_theta1 - u3^2))/6
    let u1_dot_by_theta1 = sin_theta1_l_by_3
        .mul_add(u2_dot_by_theta1_of_u3, u3_dot * cos_theta1_l_by_3)
        + u4_dot_by_theta1 * sin_theta2_l_halved + u5_dot_by_theta1 * sin_theta3_l_by_6;
    let cos_theta2_sq = cos_theta2 * cos_theta2;
    // sin(theta2)^2 - cos_theta2_sq
    let u5_dot_by_theta2_of_theta2 = sin_theta2.mul_add(sin_theta2, -cos_theta2_sq);
    let u5_dot_by_theta2_of_place = sin_theta1_sin_theta2 * cos_theta2_doubled;
    let sin_theta2_cos_theta2 = sin_theta2 * cos_theta2;
    // sin_theta2_cos_theta3 - cos_theta2_sin_theta3
    let u5_dot_by_theta2_of_place_2 = sin_theta2_cos_theta3 - cos_theta2_sin_theta3;
    // u5_dot_by_theta2 = 9*(sin(theta1)*(2*sin(theta1)*sin(theta2)*cos(theta2) +
    //   cos(theta1)*(cos(theta2)^2 - sin(theta2)^2)) - cos(theta3)*(cos(theta2)*(sin(theta2)*cos(theta3) -
    //   cos(theta2)*sin(theta3)) + sin(theta2)*(sin(theta2)*sin(theta3) +
    //   cos(theta2)*cos(theta3))))*(u5^2*(sin(theta1)*cos(theta1) - 9*sin(theta2)*cos(theta2)) -
    //   3*sin(theta3)*(cos(theta1)*(u3^2*(3*cos(theta2)^2 - 1) - u4^2*(sin(theta1)*sin(theta2) +
    //   cos(theta1)*cos(theta2))) + cos(theta2)*(3*u3^2*sin(theta1)*sin(theta2) + 7*u4^2)) +
    //   cos(theta3)*(3*u3^2*(3*cos(theta1)*sin(theta2)*cos(theta2) - sin(theta1)*(3*cos(theta2)^2 - 2)) +
    //   3*u4^2*(6*sin(theta2) + cos(theta1)*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2))) +
    //   2*u5^2*(sin(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2) + cos(theta3)*(9*sin(theta2)*cos(theta2) -
    //   sin(theta1)*cos(theta1)))))/(2*(9 + sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3))))^2) +
    //   3*(sin(theta3)*(sin(theta2)*(3*u3^2*sin(theta1)*sin(theta2) + 7*u4^2) -
    //   3*u3^2*sin(theta1)*cos(theta2)^2 + cos(theta1)*(6*u3^2*sin(theta2)*cos(theta2) +
    //   u4^2*(sin(theta1)*cos(theta2) - cos(theta1)*sin(theta2)))) + 3*u5^2*(sin(theta2)^2 - cos(theta2)^2)
    //   + cos(theta3)*(3*u3^2*(cos(theta1)*cos(theta2)^2 - cos(theta1)*sin(theta2)^2 +
    //   2*sin(theta1)*sin(theta2)*cos(theta2)) + u4^2*(6*cos(theta2) + cos(theta1)*(sin(theta1)*sin(theta2)
    //   + cos(theta1)*cos(theta2))) + 6*u5^2*(2*sin(theta2)*cos(theta2)*sin(theta3) +
    //   cos(theta3)*(cos(theta2)^2 - sin(theta2)^2))))/(2*(9 + sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4
    //   - cos(theta3)^2) + cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) +
    //   cos(theta3)*(5*cos(theta3) - 9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)))))
    let u5_dot_by_theta2 = u5_dot_of_place_12
        * (cos_theta3
            * (u4_sq * cos_theta2.mul_add(S::int(6), u4_dot_of_place_6)
                + S::int(6) * u5_sq
                    * (-u5_dot_by_theta2_of_theta2)
                        .mul_add(cos_theta3, sin_theta2_sin_theta3 * cos_theta2_doubled)
                + u3_sq_times_3
                    * ((-cos_theta1_sin_theta2)
                        .mul_add(sin_theta2, cos_theta2_sq * cos_theta1)
                        + u5_dot_by_theta2_of_place))
            + S::int(3) * u5_sq * u5_dot_by_theta2_of_theta2
            + sin_theta3
                * (u5_dot_by_theta1_of_u3_u4_2 * sin_theta2
                    - sin_theta1_cos_theta2 * u3_sq_cos_theta2_times_3
                    + cos_theta1
                        * (u3_sq * sin_theta2_cos_theta2)
                            .mul_add(S::int(6), u4_sq_u5_dot_of_place_13)))
        + S::ratio(9, 2) * u5_dot_of_place_10 * u5_dot_by_theta1_of_u3_u4_u5_2
            * (sin_theta1
                * (-u5_dot_by_theta2_of_theta2)
                    .mul_add(cos_theta1, u5_dot_by_theta2_of_place)
                - cos_theta3
                    * u5_dot_by_theta2_of_place_2
                        .mul_add(cos_theta2, u5_dot_of_place_8 * sin_theta2));
    // u4_sq_cos_theta2_times_3 - u5_dot_by_theta2*cos(theta3)
    let u4_dot_by_theta2_of_u4 = (-u5_dot_by_theta2)
        .mul_add(cos_theta3, u4_sq_cos_theta2_times_3);
    let u4_dot_by_theta2_of_place = u5_dot_by_theta2 * sin_theta3;
    // u4_sq_sin_theta2_times_3 - u4_dot_by_theta2_of_place
    let u4_dot_by_theta2_of_u4_2 = u4_sq_sin_theta2_times_3 - u4_dot_by_theta2_of_place;
    // u4_dot_by_theta2 = 3*(sin(theta1)*cos(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2))
    //   - 2*cos(theta1)^2*sin(theta2)*cos(theta2) + sin(theta1)*sin(theta2)*(sin(theta1)*cos(theta2) -
    //   2*cos(theta1)*sin(theta2)))*(sin(theta1)*(3*u3^2*cos(theta2) +
    //   sin(theta1)*sin(theta2)*(3*u4^2*cos(theta2) + u5^2*cos(theta3) + u5'*sin(theta3)) +
    //   cos(theta1)*(cos(theta2)*(3*u4^2*cos(theta2) + u5^2*cos(theta3) + u5'*sin(theta3)) -
    //   sin(theta2)*(3*u4^2*sin(theta2) + u5^2*sin(theta3) - u5'*cos(theta3)))) +
    //   cos(theta2)*(3*u5^2*sin(theta3) - 3*u5'*cos(theta3) + cos(theta1)^2*(u5'*cos(theta3) -
    //   3*u4^2*sin(theta2) - u5^2*sin(theta3))) - 3*sin(theta2)*(u3^2*cos(theta1) + u5^2*cos(theta3) +
    //   u5'*sin(theta3)))/(3*cos(theta1)^2*cos(theta2)^2 - 7 +
    //   3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)))^2 +
    //   (sin(theta2)*(3*u5^2*sin(theta3) - 3*u5'*cos(theta3) + cos(theta1)^2*(u5'*cos(theta3) -
    //   3*u4^2*sin(theta2) - u5^2*sin(theta3))) + 3*cos(theta2)*(u3^2*cos(theta1) + u5^2*cos(theta3) +
    //   u5'*sin(theta3)) + 3*u5_dot_by_theta2*sin(theta2)*sin(theta3) + sin(theta1)*(3*u3^2*sin(theta2) -
    //   sin(theta1)*cos(theta2)*(3*u4^2*cos(theta2) + u5^2*cos(theta3) + u5'*sin(theta3)) +
    //   sin(theta1)*sin(theta2)*(3*u4^2*sin(theta2) - u5_dot_by_theta2*sin(theta3)) +
    //   cos(theta1)*(cos(theta2)*(3*u4^2*sin(theta2) + u5^2*sin(theta3) - u5'*cos(theta3)) +
    //   sin(theta2)*(3*u4^2*cos(theta2) + u5^2*cos(theta3) + u5'*sin(theta3)) +
    //   sin(theta2)*(3*u4^2*cos(theta2) - u5_dot_by_theta2*cos(theta3)) + cos(theta2)*(3*u4^2*sin(theta2) -
    //   u5_dot_by_theta2*sin(theta3)))) + cos(theta2)*(3*u5_dot_by_theta2*cos(theta3) +
    //   cos(theta1)^2*(3*u4^2*cos(theta2) - u5_dot_by_theta2*cos(theta3))))/(3*cos(theta1)^2*cos(theta2)^2 -
    //   7 + 3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)))
    let u4_dot_by_theta2 = u4_dot_by_theta1_of_motion_2
        * (-sin_theta1_sin_theta2 * cos_theta1_sin_theta2.mul_add(S::int(2), -sin_theta1_cos_theta2)
            + sin_theta1_cos_theta2 * u4_dot_of_place_2 - cos_theta1_sin_theta2 * u4_dot_of_place)
        + u4_dot_of_place_3
            * (u4_dot_by_theta1_of_u4_u5_u5_dot_4 * sin_theta2
                + cos_theta2_times_3 * u4_dot_by_theta1_of_u3_u5_u5_dot
                + cos_theta2
                    * cos_theta1_sq
                        .mul_add(
                            u4_dot_by_theta2_of_u4,
                            u5_dot_by_theta2 * cos_theta3_times_3,
                        ) + sin_theta2_times_3 * u4_dot_by_theta2_of_place
                + sin_theta1
                    * (u3_sq * sin_theta2_times_3
                        - sin_theta1_cos_theta2 * u4_dot_by_theta1_of_u4_u5_u5_dot_2
                        + sin_theta1_sin_theta2 * u4_dot_by_theta2_of_u4_2
                        + cos_theta1
                            * (sin_theta2
                                * (u4_dot_by_theta1_of_u4_u5_u5_dot_2 + u4_dot_by_theta2_of_u4)
                                + cos_theta2
                                    * (u4_dot_by_theta1_of_u4_u5_u5_dot
                                        + u4_dot_by_theta2_of_u4_2))));
    // u4_dot_by_theta2 - u4_sq
    let u3_dot_by_theta2_of_u4 = u4_dot_by_theta2 - u4_sq;
    // u3_dot_by_theta2 = cos(theta1)*(3*u4'*sin(theta2) - u5_dot_by_theta2*cos(theta3) +
    //   3*cos(theta2)*(u4^2 - u4_dot_by_theta2))/3 - sin(theta1)*(3*u4'*cos(theta2) +
    //   u5_dot_by_theta2*sin(theta3) + 3*sin(theta2)*(u4_dot_by_theta2 - u4^2))/3
    let u3_dot_by_theta2 = (-u5_dot_by_theta2)
        .mul_add(u3_dot_by_theta1_of_place_2, -u3_dot_by_theta1_of_u4_dot)
        - u5_dot_of_place_16 * u3_dot_by_theta2_of_u4;
    // u2_dot_by_theta2 = l*(3*u4'*sin(theta2) - u5_dot_by_theta2*cos(theta3) + 3*cos(theta2)*(u4^2 -
    //   u4_dot_by_theta2) - 2*u3_dot_by_theta2*cos(theta1))/6
    let u2_dot_by_theta2 = (-u5_dot_by_theta2)
        .mul_add(cos_theta3_l_by_6, u4_dot * sin_theta2_l_halved)
        - u3_dot_by_theta2 * cos_theta1_l_by_3 - cos_theta2_l_halved * u3_dot_by_theta2_of_u4;
    // u1_dot_by_theta2 = l*(3*u4'*cos(theta2) + u5_dot_by_theta2*sin(theta3) +
    //   3*sin(theta2)*(u4_dot_by_theta2 - u4^2) + 2*u3_dot_by_theta2*sin(theta1))/6
    let u1_dot_by_theta2 = u4_dot
        .mul_add(cos_theta2_l_halved, u3_dot_by_theta2 * sin_theta1_l_by_3)
        + u5_dot_by_theta2 * sin_theta3_l_by_6 + sin_theta2_l_halved * u3_dot_by_theta2_of_u4;
    // u5_dot_by_theta3 = (cos(theta3)*(5*sin(theta3) + 9*cos(theta2)*(sin(theta2)*cos(theta3) -
    //   cos(theta2)*sin(theta3))) - sin(theta3)*(9*cos(theta2)*(sin(theta2)*sin(theta3) +
    //   cos(theta2)*cos(theta3)) - 5*cos(theta3)) - sin(theta1)*(2*sin(theta1)*sin(theta3)*cos(theta3) +
    //   cos(theta1)*(cos(theta3)^2 - sin(theta3)^2)))*(u5^2*(sin(theta1)*cos(theta1) -
    //   9*sin(theta2)*cos(theta2)) - 3*sin(theta3)*(cos(theta1)*(u3^2*(3*cos(theta2)^2 - 1) -
    //   u4^2*(sin(theta1)*sin(theta2) + cos(theta1)*cos(theta2))) +
    //   cos(theta2)*(3*u3^2*sin(theta1)*sin(theta2) + 7*u4^2)) +
    //   cos(theta3)*(3*u3^2*(3*cos(theta1)*sin(theta2)*cos(theta2) - sin(theta1)*(3*cos(theta2)^2 - 2)) +
    //   3*u4^2*(6*sin(theta2) + cos(theta1)*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2))) +
    //   2*u5^2*(sin(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2) + cos(theta3)*(9*sin(theta2)*cos(theta2) -
    //   sin(theta1)*cos(theta1)))))/(2*(9 + sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3))))^2) +
    //   (2*u5^2*cos(theta3)*(sin(theta3)*(sin(theta1)*cos(theta1) - 9*sin(theta2)*cos(theta2)) +
    //   cos(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2)) -
    //   3*cos(theta3)*(cos(theta1)*(u3^2*(3*cos(theta2)^2 - 1) - u4^2*(sin(theta1)*sin(theta2) +
    //   cos(theta1)*cos(theta2))) + cos(theta2)*(3*u3^2*sin(theta1)*sin(theta2) + 7*u4^2)) -
    //   sin(theta3)*(3*u3^2*(3*cos(theta1)*sin(theta2)*cos(theta2) - sin(theta1)*(3*cos(theta2)^2 - 2)) +
    //   3*u4^2*(6*sin(theta2) + cos(theta1)*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2))) +
    //   2*u5^2*(sin(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2) + cos(theta3)*(9*sin(theta2)*cos(theta2) -
    //   sin(theta1)*cos(theta1)))))/(2*(9 + sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3)))))
    let u5_dot_by_theta3 = u5_dot_by_theta1_of_u3_u4_u5_3
        * (sin_theta1
            * (cos_theta1 * sin_theta3.mul_add(sin_theta3, -cos_theta3_sq)
                - cos_theta3_doubled * sin_theta1_sin_theta3) + u5_dot_of_place_9 * sin_theta3
            + cos_theta3
                * cos_theta2_times_9
                    .mul_add(u5_dot_by_theta2_of_place_2, S::int(5) * sin_theta3))
        - u5_dot_of_place_11
            * (u5_sq * cos_theta3_doubled
                * (-u5_dot_of_place_2).mul_add(cos_theta3, u5_dot_of_place * sin_theta3)
                + u5_dot_by_theta1_of_u3_u4_u5 * sin_theta3
                + u5_dot_by_theta1_of_u3_u4_3 * cos_theta3_times_3);
    // 1/(4 + u4_dot_of_theta2 - 3*cos(theta1)*(cos(theta1)*(cos_theta2_doubled*cos(theta2) - 1) +
    //   u5_dot_by_theta2_of_place))
    let u4_dot_by_theta3_of_place = S::int(1)
        / (S::int(4) + u4_dot_of_theta2
            - S::int(3) * cos_theta1
                * (cos_theta1 * cos_theta2_doubled.mul_add(cos_theta2, -S::int(1))
                    + u5_dot_by_theta2_of_place));
    // u4_dot_of_place_7*cos(theta3) + u4_dot_of_place_8*sin(theta3)
    let u4_dot_by_theta3_of_place_2 = u4_dot_of_place_8
        .mul_add(sin_theta3, u4_dot_of_place_7 * cos_theta3);
    let u4_dot_by_theta3_of_place_3 = u4_dot_by_theta3_of_place * u4_dot_by_theta3_of_place_2;
    // u4_dot_by_theta3 = (2*sin(theta2)*(u5'*cos(theta3) + sin(theta3)*(u5_dot_by_theta3 - u5^2)) -
    //   3*cos(theta2)*(u5'*sin(theta3) + cos(theta3)*(u5^2 - u5_dot_by_theta3)) +
    //   cos(theta1)*(sin(theta1)*(sin(theta2)*(u5'*sin(theta3) + cos(theta3)*(u5^2 - u5_dot_by_theta3)) -
    //   cos(theta2)*(u5'*cos(theta3) + sin(theta3)*(u5_dot_by_theta3 - u5^2))) +
    //   cos(theta1)*(cos(theta2)*(u5'*sin(theta3) + cos(theta3)*(u5^2 - u5_dot_by_theta3)) +
    //   sin(theta2)*(u5'*cos(theta3) + sin(theta3)*(u5_dot_by_theta3 -
    //   u5^2)))))/(3*cos(theta1)*(2*sin(theta1)*sin(theta2)*cos(theta2) + cos(theta1)*(2*cos(theta2)^2 - 1))
    //   - 4 - 3*cos(theta2)^2)
    let u4_dot_by_theta3 = u4_dot_by_theta3_of_place
        * (-u4_dot_of_u5_u5_dot)
            .mul_add(u4_dot_of_place_8, u4_dot_of_place_7 * u4_dot_of_u5_u5_dot_2)
        - u5_dot_by_theta3 * u4_dot_by_theta3_of_place_3;
    // u3_dot_by_theta3 = cos(theta1)*(u5'*sin(theta3) + cos(theta3)*(u5^2 - u5_dot_by_theta3) -
    //   3*u4_dot_by_theta3*cos(theta2))/3 - sin(theta1)*(u5'*cos(theta3) + sin(theta3)*(u5_dot_by_theta3 -
    //   u5^2) + 3*u4_dot_by_theta3*sin(theta2))/3
    let u3_dot_by_theta3 = (-u5_dot_by_theta3)
        .mul_add(u3_dot_by_theta1_of_place_2, -u4_dot_by_theta3 * u5_dot_of_place_16)
        - u3_dot_by_theta1_of_u5_u5_dot_2;
    // u2_dot_by_theta3 = l*(u5'*sin(theta3) + cos(theta3)*(u5^2 - u5_dot_by_theta3) -
    //   3*u4_dot_by_theta3*cos(theta2) - 2*u3_dot_by_theta3*cos(theta1))/6
    let u2_dot_by_theta3 = (-u4_dot_by_theta3)
        .mul_add(cos_theta2_l_halved, u4_dot_of_u5_u5_dot_2 * l_by_6)
        - u5_dot_by_theta3 * cos_theta3_l_by_6 - u3_dot_by_theta3 * cos_theta1_l_by_3;
    // u1_dot_by_theta3 = l*(u5'*cos(theta3) + sin(theta3)*(u5_dot_by_theta3 - u5^2) +
    //   3*u4_dot_by_theta3*sin(theta2) + 2*u3_dot_by_theta3*sin(theta1))/6
    let u1_dot_by_theta3 = u4_dot_of_u5_u5_dot
        .mul_add(l_by_6, u3_dot_by_theta3 * sin_theta1_l_by_3)
        + u4_dot_by_theta3 * sin_theta2_l_halved + u5_dot_by_theta3 * sin_theta3_l_by_6;
    let u5_dot_by_u3_of_place = S::int(3) * u5_dot_of_place_10;
    // u5_dot_by_u3 = 3*u3*(cos(theta1)*sin(theta3) + 2*sin(theta1)*cos(theta3) -
    //   3*cos(theta2)*(cos(theta1)*(cos(theta2)*sin(theta3) - sin(theta2)*cos(theta3)) +
    //   sin(theta1)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3))))/(9 +
    //   sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3))))
    let u5_dot_by_u3 = -u3 * u5_dot_of_place_20 * u5_dot_by_u3_of_place;
    // u4_dot_by_u3 = (6*u3*(cos(theta1)*sin(theta2) - sin(theta1)*cos(theta2)) +
    //   u5_dot_by_u3*(2*sin(theta2)*sin(theta3) + 3*cos(theta2)*cos(theta3) -
    //   cos(theta1)*(sin(theta1)*(cos(theta2)*sin(theta3) + sin(theta2)*cos(theta3)) +
    //   cos(theta1)*(cos(theta2)*cos(theta3) -
    //   sin(theta2)*sin(theta3)))))/(3*cos(theta1)*(2*sin(theta1)*sin(theta2)*cos(theta2) +
    //   cos(theta1)*(2*cos(theta2)^2 - 1)) - 4 - 3*cos(theta2)^2)
    let u4_dot_by_u3 = (-u5_dot_by_u3)
        .mul_add(
            u4_dot_by_theta3_of_place_3,
            S::int(6) * u3 * u5_dot_of_place_13 * u4_dot_by_theta3_of_place,
        );
    // u3_dot_by_u3 = -sin(theta1)*(u5_dot_by_u3*sin(theta3) + 3*u4_dot_by_u3*sin(theta2))/3 -
    //   cos(theta1)*(u5_dot_by_u3*cos(theta3) + 3*u4_dot_by_u3*cos(theta2))/3
    let u3_dot_by_u3 = (-u5_dot_by_u3)
        .mul_add(u3_dot_by_theta1_of_place_2, -u4_dot_by_u3 * u5_dot_of_place_16);
    let l_u3_times_2_by_3 = S::ratio(2, 3) * l * u3;
    // u2_dot_by_u3 = l*(4*u3*sin(theta1) - u5_dot_by_u3*cos(theta3) - 3*u4_dot_by_u3*cos(theta2) -
    //   2*u3_dot_by_u3*cos(theta1))/6
    let u2_dot_by_u3 = (-u4_dot_by_u3)
        .mul_add(cos_theta2_l_halved, l_u3_times_2_by_3 * sin_theta1)
        - u5_dot_by_u3 * cos_theta3_l_by_6 - u3_dot_by_u3 * cos_theta1_l_by_3;
    // u1_dot_by_u3 = l*(4*u3*cos(theta1) + u5_dot_by_u3*sin(theta3) + 3*u4_dot_by_u3*sin(theta2) +
    //   2*u3_dot_by_u3*sin(theta1))/6
    let u1_dot_by_u3 = u4_dot_by_u3
        .mul_add(sin_theta2_l_halved, u3_dot_by_u3 * sin_theta1_l_by_3)
        + u5_dot_by_u3 * sin_theta3_l_by_6 + l_u3_times_2_by_3 * cos_theta1;
    // u5_dot_by_u4 = 3*u4*(6*sin(theta2)*cos(theta3) - 7*cos(theta2)*sin(theta3) +
    //   cos(theta1)*(cos(theta1)*(cos(theta2)*sin(theta3) + sin(theta2)*cos(theta3)) +
    //   sin(theta1)*(sin(theta2)*sin(theta3) - cos(theta2)*cos(theta3))))/(9 +
    //   sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3))))
    let u5_dot_by_u4 = -u4 * u5_dot_of_place_18 * u5_dot_by_u3_of_place;
    let u4_dot_by_u4_of_place = u4_dot_of_place_3 * u4_dot_by_theta3_of_place_2;
    // u4_dot_by_u4 = (3*u5_dot_by_u4*sin(theta2)*sin(theta3) +
    //   sin(theta1)*(cos(theta1)*(sin(theta2)*(6*u4*sin(theta2) - u5_dot_by_u4*cos(theta3)) -
    //   cos(theta2)*(6*u4*cos(theta2) + u5_dot_by_u4*sin(theta3))) -
    //   sin(theta1)*sin(theta2)*(6*u4*cos(theta2) + u5_dot_by_u4*sin(theta3))) +
    //   cos(theta2)*(3*u5_dot_by_u4*cos(theta3) + cos(theta1)^2*(6*u4*sin(theta2) -
    //   u5_dot_by_u4*cos(theta3))))/(3*cos(theta1)^2*cos(theta2)^2 - 7 +
    //   3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)))
    let u4_dot_by_u4 = -S::int(6) * u4 * u4_dot_of_place_3
        * (u4_dot_of_place_5 + sin_theta2_cos_theta2) + u5_dot_by_u4 * u4_dot_by_u4_of_place;
    // u3_dot_by_u4 = cos(theta1)*(6*u4*sin(theta2) - u5_dot_by_u4*cos(theta3) -
    //   3*u4_dot_by_u4*cos(theta2))/3 - sin(theta1)*(6*u4*cos(theta2) + u5_dot_by_u4*sin(theta3) +
    //   3*u4_dot_by_u4*sin(theta2))/3
    let u3_dot_by_u4 = (-u4_dot_by_u4)
        .mul_add(u5_dot_of_place_16, -S::int(2) * u4 * u5_dot_of_place_13)
        - u5_dot_by_u4 * u3_dot_by_theta1_of_place_2;
    let l_u4 = l * u4;
    // u2_dot_by_u4 = l*(6*u4*sin(theta2) - u5_dot_by_u4*cos(theta3) - 3*u4_dot_by_u4*cos(theta2) -
    //   2*u3_dot_by_u4*cos(theta1))/6
    let u2_dot_by_u4 = (-u4_dot_by_u4).mul_add(cos_theta2_l_halved, l_u4 * sin_theta2)
        - u5_dot_by_u4 * cos_theta3_l_by_6 - u3_dot_by_u4 * cos_theta1_l_by_3;
    // u1_dot_by_u4 = l*(6*u4*cos(theta2) + u5_dot_by_u4*sin(theta3) + 3*u4_dot_by_u4*sin(theta2) +
    //   2*u3_dot_by_u4*sin(theta1))/6
    let u1_dot_by_u4 = u4_dot_by_u4
        .mul_add(sin_theta2_l_halved, u3_dot_by_u4 * sin_theta1_l_by_3)
        + u5_dot_by_u4 * sin_theta3_l_by_6 + l_u4 * cos_theta2;
    // u5_dot_by_u5 = (u5*(sin(theta1)*cos(theta1) - 9*sin(theta2)*cos(theta2)) +
    //   2*u5*cos(theta3)*(sin(theta3)*(4 + cos(theta1)^2 - 9*cos(theta2)^2) +
    //   cos(theta3)*(9*sin(theta2)*cos(theta2) - sin(theta1)*cos(theta1))))/(9 +
    //   sin(theta1)*(sin(theta1)*(9*cos(theta2)^2 - 4 - cos(theta3)^2) +
    //   cos(theta1)*(sin(theta3)*cos(theta3) - 9*sin(theta2)*cos(theta2))) + cos(theta3)*(5*cos(theta3) -
    //   9*cos(theta2)*(sin(theta2)*sin(theta3) + cos(theta2)*cos(theta3))))
    let u5_dot_by_u5 = u5 * u5_dot_of_place_4 * u5_dot_of_place_10;
    // u4_dot_by_u5 = (3*sin(theta2)*(2*u5*cos(theta3) + u5_dot_by_u5*sin(theta3)) +
    //   sin(theta1)*(cos(theta1)*(sin(theta2)*(2*u5*sin(theta3) - u5_dot_by_u5*cos(theta3)) -
    //   cos(theta2)*(2*u5*cos(theta3) + u5_dot_by_u5*sin(theta3))) -
    //   sin(theta1)*sin(theta2)*(2*u5*cos(theta3) + u5_dot_by_u5*sin(theta3))) +
    //   cos(theta2)*(3*u5_dot_by_u5*cos(theta3) - 6*u5*sin(theta3) - cos(theta1)^2*(u5_dot_by_u5*cos(theta3)
    //   - 2*u5*sin(theta3))))/(3*cos(theta1)^2*cos(theta2)^2 - 7 +
    //   3*sin(theta1)*sin(theta2)*(sin(theta1)*sin(theta2) + 2*cos(theta1)*cos(theta2)))
    let u4_dot_by_u5 = u5 * u4_dot_of_place_3
        * (-(u4_dot_of_place_7 * sin_theta3))
            .mul_add(S::int(2), cos_theta3_doubled * u4_dot_of_place_8)
        + u5_dot_by_u5 * u4_dot_by_u4_of_place;
    // u3_dot_by_u5 = cos(theta1)*(2*u5*sin(theta3) - u5_dot_by_u5*cos(theta3) -
    //   3*u4_dot_by_u5*cos(theta2))/3 - sin(theta1)*(2*u5*cos(theta3) + u5_dot_by_u5*sin(theta3) +
    //   3*u4_dot_by_u5*sin(theta2))/3
    let u3_dot_by_u5 = S::ratio(2, 3) * u5
        * (-sin_theta1).mul_add(cos_theta3, cos_theta1_sin_theta3)
        - u4_dot_by_u5 * u5_dot_of_place_16 - u5_dot_by_u5 * u3_dot_by_theta1_of_place_2;
    let u5_l_by_3 = u5 * l_by_3;
    // u2_dot_by_u5 = l*(2*u5*sin(theta3) - u5_dot_by_u5*cos(theta3) - 3*u4_dot_by_u5*cos(theta2) -
    //   2*u3_dot_by_u5*cos(theta1))/6
    let u2_dot_by_u5 = (-u4_dot_by_u5)
        .mul_add(cos_theta2_l_halved, u5_l_by_3 * sin_theta3)
        - u5_dot_by_u5 * cos_theta3_l_by_6 - u3_dot_by_u5 * cos_theta1_l_by_3;
    // u1_dot_by_u5 = l*(2*u5*cos(theta3) + u5_dot_by_u5*sin(theta3) + 3*u4_dot_by_u5*sin(theta2) +
    //   2*u3_dot_by_u5*sin(theta1))/6
    let u1_dot_by_u5 = u4_dot_by_u5
        .mul_add(sin_theta2_l_halved, u3_dot_by_u5 * sin_theta1_l_by_3)
        + u5_dot_by_u5 * sin_theta3_l_by_6 + u5_l_by_3 * cos_theta3;
    // Entries that are not zero.
    // d(x')/d(u1) = 1
    let x_dot_by_u1_value = S::int(1);
    // d(y')/d(u2) = 1
    let y_dot_by_u2_value = S::int(1);
    // d(theta1')/d(u3) = 1
    let theta1_dot_by_u3_value = S::int(1);
    // d(theta2')/d(u4) = 1
    let theta2_dot_by_u4_value = S::int(1);
    // d(theta3')/d(u5) = 1
    let theta3_dot_by_u5_value = S::int(1);
    let zero = S::int(0);
    [
        [zero, zero, zero, zero, zero, x_dot_by_u1_value, zero, zero, zero, zero],
        [zero, zero, zero, zero, zero, zero, y_dot_by_u2_value, zero, zero, zero],
        [zero, zero, zero, zero, zero, zero, zero, theta1_dot_by_u3_value, zero, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, theta2_dot_by_u4_value, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, theta3_dot_by_u5_value],
        [
            zero, zero, u1_dot_by_theta1, u1_dot_by_theta2, u1_dot_by_theta3, zero, zero,
            u1_dot_by_u3, u1_dot_by_u4, u1_dot_by_u5,
        ],
        [
            zero, zero, u2_dot_by_theta1, u2_dot_by_theta2, u2_dot_by_theta3, zero, zero,
            u2_dot_by_u3, u2_dot_by_u4, u2_dot_by_u5,
        ],
        [
            zero, zero, u3_dot_by_theta1, u3_dot_by_theta2, u3_dot_by_theta3, zero, zero,
            u3_dot_by_u3, u3_dot_by_u4, u3_dot_by_u5,
        ],
        [
            zero, zero, u4_dot_by_theta1, u4_dot_by_theta2, u4_dot_by_theta3, zero, zero,
            u4_dot_by_u3, u4_dot_by_u4, u4_dot_by_u5,
        ],
        [
            zero, zero, u5_dot_by_theta1, u5_dot_by_theta2, u5_dot_by_theta3, zero, zero,
            u5_dot_by_u3, u5_dot_by_u4, u5_dot_by_u5,
        ],
    ]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 67 convolutions and 176 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 10]],
    history: &mut [Factors<S, 72>],
) {
    let Parameters { l, .. } = *p;
    let [_, _, theta1_0, theta2_0, theta3_0, u1_0, u2_0, u3_0, u4_0, u5_0] = series[0];
    // Constant in time.
    // l_by_6 = l/6
    let l_by_6 = S::ratio(1, 6) * l;
    // Order 0.
    let (sin_theta1_0, cos_theta1_0) = theta1_0.sin_cos();
    let (sin_theta2_0, cos_theta2_0) = theta2_0.sin_cos();
    let (sin_theta3_0, cos_theta3_0) = theta3_0.sin_cos();
    let u4_sq_0 = u4_0 * u4_0;
    let cos_theta2_sq_0 = cos_theta2_0 * cos_theta2_0;
    let cos_theta3_sq_0 = cos_theta3_0 * cos_theta3_0;
    let u4_sq_cos_theta2_0 = cos_theta2_0 * u4_sq_0;
    let u5_sq_0 = u5_0 * u5_0;
    let u5_sq_cos_theta3_0 = cos_theta3_0 * u5_sq_0;
    let u3_sq_0 = u3_0 * u3_0;
    let u3_sq_sin_theta1_0 = sin_theta1_0 * u3_sq_0;
    let u4_sq_sin_theta2_0 = sin_theta2_0 * u4_sq_0;
    let u5_sq_sin_theta3_0 = sin_theta3_0 * u5_sq_0;
    let sin_theta2_sin_theta3_0 = sin_theta2_0 * sin_theta3_0;
    let cos_theta2_cos_theta3_0 = cos_theta2_0 * cos_theta3_0;
    let u5_dot_of_u5_0 = sin_theta2_0 * u5_sq_cos_theta3_0;
    let u5_dot_of_place_0 = sin_theta2_sin_theta3_0 + cos_theta2_cos_theta3_0;
    let u3_sq_cos_theta2_0 = cos_theta2_0 * u3_sq_0;
    let u5_dot_of_place_2_0 = cos_theta2_sq_0.mul_add(S::int(9), -S::int(4)) - cos_theta3_sq_0;
    let u5_dot_of_place_3_0 = sin_theta1_0 * u5_dot_of_place_2_0;
    let sin_theta2_cos_theta2_0 = sin_theta2_0 * cos_theta2_0;
    let sin_theta3_cos_theta3_0 = sin_theta3_0 * cos_theta3_0;
    let u5_dot_of_place_4_0 = S::int(9) * sin_theta2_cos_theta2_0 - sin_theta3_cos_theta3_0;
    let u5_dot_of_place_5_0 = cos_theta1_0 * u5_dot_of_place_4_0;
    let u5_dot_of_place_6_0 = u5_dot_of_place_3_0 - u5_dot_of_place_5_0;
    let u5_dot_of_place_7_0 = sin_theta1_0 * u5_dot_of_place_6_0;
    let u5_dot_of_place_8_0 = cos_theta2_0 * u5_dot_of_place_0;
    let u5_dot_of_place_9_0 = u5_dot_of_place_8_0
        .mul_add(-S::int(9), S::int(5) * cos_theta3_0);
    let u5_dot_of_place_10_0 = cos_theta3_0 * u5_dot_of_place_9_0;
    let u5_dot_of_place_11_0 = S::int(9) + u5_dot_of_place_7_0 + u5_dot_of_place_10_0;
    let over_u5_dot_of_place_11 = S::int(1) / u5_dot_of_place_11_0;
    let sin_theta1_cos_theta1_0 = sin_theta1_0 * cos_theta1_0;
    let u5_dot_of_place_12_0 = S::int(9) * sin_theta2_cos_theta2_0 - sin_theta1_cos_theta1_0;
    let sin_theta1_sin_theta2_0 = sin_theta1_0 * sin_theta2_0;
    let u5_dot_of_u3_0 = u3_sq_0 * sin_theta1_sin_theta2_0;
    let u5_dot_of_u3_u4_0 = u5_dot_of_u3_0.mul_add(S::int(3), S::int(7) * u4_sq_0);
    let u5_dot_of_u3_u4_2_0 = cos_theta2_0 * u5_dot_of_u3_u4_0;
    let u5_dot_of_u5_2_0 = u5_dot_of_place_12_0 * u5_sq_0;
    let u5_dot_of_u4_u5_0 = u5_sq_cos_theta3_0
        .mul_add(S::int(2), S::int(3) * u4_sq_cos_theta2_0);
    let u5_dot_of_u4_0 = u4_sq_0 * sin_theta1_sin_theta2_0;
    let u5_dot_of_u3_2_0 = sin_theta2_0 * u3_sq_cos_theta2_0;
    let u5_dot_of_u3_u5_0 = u5_sq_sin_theta3_0.mul_add(S::int(2), u3_sq_sin_theta1_0);
    let u5_dot_of_u4_u5_2_0 = u5_sq_sin_theta3_0
        .mul_add(S::int(2), S::int(3) * u4_sq_sin_theta2_0);
    let u4_sq_cos_theta1_0 = cos_theta1_0 * u4_sq_0;
    let u5_dot_of_u3_u5_2_0 = cos_theta2_0 * u5_dot_of_u3_u5_0;
    let u5_dot_of_u4_u5_3_0 = cos_theta1_0 * u5_dot_of_u4_u5_2_0;
    let u5_dot_of_u3_u4_3_0 = S::int(3) * u3_sq_cos_theta2_0 - u4_sq_cos_theta1_0;
    let u5_dot_of_u4_u5_4_0 = sin_theta1_0 * u5_dot_of_u4_u5_0;
    let u5_dot_of_u3_u4_u5_0 = S::int(9) * u5_dot_of_u3_2_0 + u5_dot_of_u4_u5_3_0
        - u5_dot_of_u4_u5_4_0;
    let u5_dot_of_u3_u4_u5_2_0 = cos_theta1_0 * u5_dot_of_u3_u4_u5_0;
    let u5_dot_of_u3_u5_3_0 = S::int(2) * u5_dot_of_u5_0 - u5_dot_of_u3_u5_2_0;
    let u5_dot_of_u3_u5_4_0 = cos_theta2_0 * u5_dot_of_u3_u5_3_0;
    let u5_dot_of_u3_u4_u5_3_0 = u5_dot_of_u3_u5_4_0
        .mul_add(
            S::int(9),
            u5_sq_sin_theta3_0
                .mul_add(
                    S::int(8),
                    u4_sq_sin_theta2_0
                        .mul_add(S::int(18), S::int(6) * u3_sq_sin_theta1_0),
                ) + u5_dot_of_u3_u4_u5_2_0,
        );
    let u5_dot_of_u3_u4_u5_4_0 = cos_theta3_0 * u5_dot_of_u3_u4_u5_3_0;
    let u5_dot_of_u3_u4_4_0 = cos_theta2_0 * u5_dot_of_u3_u4_3_0;
    let u5_dot_of_u3_u4_5_0 = u3_sq_0 + u5_dot_of_u4_0 - u5_dot_of_u3_u4_4_0;
    let u5_dot_of_u3_u4_6_0 = cos_theta1_0 * u5_dot_of_u3_u4_5_0;
    let u5_dot_of_u3_u4_7_0 = u5_dot_of_u3_u4_2_0 - u5_dot_of_u3_u4_6_0;
    let u5_dot_of_u3_u4_8_0 = sin_theta3_0 * u5_dot_of_u3_u4_7_0;
    let u5_dot_of_u3_u4_u5_5_0 = u5_dot_of_u3_u4_8_0.mul_add(S::int(3), u5_dot_of_u5_2_0)
        - u5_dot_of_u3_u4_u5_4_0;
    let u5_dot_of_u3_u4_u5_6_0 = u5_dot_of_u3_u4_u5_5_0 * over_u5_dot_of_place_11;
    let u3_sq_cos_theta1_0 = cos_theta1_0 * u3_sq_0;
    let cos_theta1_cos_theta2_0 = cos_theta1_0 * cos_theta2_0;
    let u4_dot_of_place_0 = cos_theta1_cos_theta2_0
        .mul_add(S::int(2), sin_theta1_sin_theta2_0);
    let u4_dot_of_place_2_0 = u4_dot_of_place_0 * sin_theta1_sin_theta2_0;
    let cos_theta1_sq_0 = cos_theta1_0 * cos_theta1_0;
    let u4_dot_of_place_3_0 = cos_theta2_sq_0 * cos_theta1_sq_0;
    let u4_dot_of_place_4_0 = u4_dot_of_place_2_0
        .mul_add(S::int(3), u4_dot_of_place_3_0.mul_add(S::int(3), -S::int(7)));
    let over_u4_dot_of_place_4 = S::int(1) / u4_dot_of_place_4_0;
    let u4_dot_of_u3_u4_u5_0 = u5_dot_of_u3_u4_u5_6_0 * sin_theta3_0;
    let u4_dot_of_u3_u4_u5_2_0 = u5_dot_of_u3_u4_u5_6_0 * cos_theta3_0;
    let u4_dot_of_u4_u5_u5_dot_0 = u4_dot_of_u3_u4_u5_2_0
        .mul_add(S::ratio(1, 2), S::int(3) * u4_sq_sin_theta2_0 + u5_sq_sin_theta3_0);
    let u4_dot_of_u4_u5_u5_dot_2_0 = sin_theta2_0 * u4_dot_of_u4_u5_u5_dot_0;
    let u4_dot_of_u4_u5_u5_dot_3_0 = u4_dot_of_u3_u4_u5_0
        .mul_add(-S::ratio(1, 2), S::int(3) * u4_sq_cos_theta2_0 + u5_sq_cos_theta3_0);
    let u4_dot_of_u4_u5_u5_dot_4_0 = cos_theta2_0 * u4_dot_of_u4_u5_u5_dot_3_0;
    let u4_dot_of_u4_u5_u5_dot_5_0 = u4_dot_of_u4_u5_u5_dot_2_0 - u4_dot_of_u4_u5_u5_dot_4_0;
    let u4_dot_of_u4_u5_u5_dot_6_0 = cos_theta1_0 * u4_dot_of_u4_u5_u5_dot_5_0;
    let u4_dot_of_u4_u5_u5_dot_7_0 = u4_dot_of_u4_u5_u5_dot_3_0 * sin_theta1_sin_theta2_0;
    let u4_dot_of_motion_0 = S::int(3) * u3_sq_cos_theta2_0 + u4_dot_of_u4_u5_u5_dot_7_0
        - u4_dot_of_u4_u5_u5_dot_6_0;
    let u4_dot_of_motion_2_0 = sin_theta1_0 * u4_dot_of_motion_0;
    let u4_dot_of_u4_u5_u5_dot_8_0 = u4_dot_of_u4_u5_u5_dot_0 * cos_theta1_sq_0;
    let u4_dot_of_u4_u5_u5_dot_9_0 = u4_dot_of_u3_u4_u5_2_0
        .mul_add(S::ratio(3, 2), S::int(3) * u5_sq_sin_theta3_0) - u4_dot_of_u4_u5_u5_dot_8_0;
    let u4_dot_of_u4_u5_u5_dot_10_0 = cos_theta2_0 * u4_dot_of_u4_u5_u5_dot_9_0;
    let u4_dot_of_u3_u5_u5_dot_0 = u4_dot_of_u3_u4_u5_0
        .mul_add(-S::ratio(1, 2), u3_sq_cos_theta1_0 + u5_sq_cos_theta3_0);
    let u4_dot_of_u3_u5_u5_dot_2_0 = sin_theta2_0 * u4_dot_of_u3_u5_u5_dot_0;
    let u4_dot_of_motion_3_0 = -S::int(3) * u4_dot_of_u3_u5_u5_dot_2_0
        + u4_dot_of_u4_u5_u5_dot_10_0 + u4_dot_of_motion_2_0;
    let u4_dot_of_motion_4_0 = u4_dot_of_motion_3_0 * over_u4_dot_of_place_4;
    let u3_dot_of_motion_0 = u4_dot_of_motion_4_0 * sin_theta2_0;
    let u3_dot_of_motion_2_0 = u3_dot_of_motion_0
        .mul_add(
            -S::int(3),
            u4_dot_of_u3_u4_u5_0
                .mul_add(
                    -S::ratio(1, 2),
                    S::int(3) * u4_sq_cos_theta2_0 + u5_sq_cos_theta3_0,
                ),
        );
    let u3_dot_of_motion_3_0 = sin_theta1_0 * u3_dot_of_motion_2_0;
    let u3_dot_of_motion_4_0 = u4_dot_of_motion_4_0 * cos_theta2_0;
    let u3_dot_of_motion_5_0 = u3_dot_of_motion_4_0
        .mul_add(
            S::int(3),
            u4_dot_of_u3_u4_u5_2_0
                .mul_add(
                    S::ratio(1, 2),
                    S::int(3) * u4_sq_sin_theta2_0 + u5_sq_sin_theta3_0,
                ),
        );
    let u3_dot_of_motion_6_0 = cos_theta1_0 * u3_dot_of_motion_5_0;
    let u3_dot_2_0 = u3_dot_of_motion_6_0
        .mul_add(S::ratio(1, 3), -S::ratio(1, 3) * u3_dot_of_motion_3_0);
    let u2_dot_of_motion_0 = u3_dot_2_0 * cos_theta1_0;
    let u2_dot_of_motion_2_0 = u2_dot_of_motion_0
        .mul_add(
            -S::int(2),
            u3_dot_of_motion_4_0
                .mul_add(
                    S::int(3),
                    u4_dot_of_u3_u4_u5_2_0
                        .mul_add(
                            S::ratio(1, 2),
                            u4_sq_sin_theta2_0
                                .mul_add(S::int(3), S::int(2) * u3_sq_sin_theta1_0)
                                + u5_sq_sin_theta3_0,
                        ),
                ),
        );
    let u1_dot_of_motion_0 = u3_dot_2_0 * sin_theta1_0;
    let u1_dot_of_motion_2_0 = u1_dot_of_motion_0
        .mul_add(
            S::int(2),
            u3_dot_of_motion_0
                .mul_add(
                    -S::int(3),
                    u4_dot_of_u3_u4_u5_0
                        .mul_add(
                            -S::ratio(1, 2),
                            u4_sq_cos_theta2_0
                                .mul_add(S::int(3), S::int(2) * u3_sq_cos_theta1_0)
                                + u5_sq_cos_theta3_0,
                        ),
                ),
        );
    // Order 1: the rates, and what follows from them.
    let x_1 = u1_0;
    let y_1 = u2_0;
    let theta1_1 = u3_0;
    let theta2_1 = u4_0;
    let theta3_1 = u5_0;
    let u1_1 = l_by_6 * u1_dot_of_motion_2_0;
    let u2_1 = l_by_6 * u2_dot_of_motion_2_0;
    let u3_1 = u3_dot_2_0;
    let u4_1 = -u4_dot_of_motion_4_0;
    let u5_1 = -S::ratio(1, 2) * u5_dot_of_u3_u4_u5_6_0;
    if series.len() > 1 {
        series[1] = [
            x_1, y_1, theta1_1, theta2_1, theta3_1, u1_1, u2_1, u3_1, u4_1, u5_1,
        ];
    }
    let sin_theta1_1 = theta1_1 * cos_theta1_0;
    let cos_theta1_1 = -theta1_1 * sin_theta1_0;
    let sin_theta2_1 = theta2_1 * cos_theta2_0;
    let cos_theta2_1 = -theta2_1 * sin_theta2_0;
    let sin_theta3_1 = theta3_1 * cos_theta3_0;
    let cos_theta3_1 = -theta3_1 * sin_theta3_0;
    let u4_sq_1 = u4_1 * (u4_0 + u4_0);
    let cos_theta2_sq_1 = cos_theta2_1 * (cos_theta2_0 + cos_theta2_0);
    let cos_theta3_sq_1 = cos_theta3_1 * (cos_theta3_0 + cos_theta3_0);
    let u4_sq_cos_theta2_1 = u4_sq_1.mul_add(cos_theta2_0, cos_theta2_1 * u4_sq_0);
    let u5_sq_1 = u5_1 * (u5_0 + u5_0);
    let u5_sq_cos_theta3_1 = u5_sq_1.mul_add(cos_theta3_0, cos_theta3_1 * u5_sq_0);
    let u3_sq_1 = u3_1 * (u3_0 + u3_0);
    let u3_sq_sin_theta1_1 = u3_sq_1.mul_add(sin_theta1_0, sin_theta1_1 * u3_sq_0);
    let u4_sq_sin_theta2_1 = u4_sq_1.mul_add(sin_theta2_0, sin_theta2_1 * u4_sq_0);
    let u5_sq_sin_theta3_1 = u5_sq_1.mul_add(sin_theta3_0, sin_theta3_1 * u5_sq_0);
    let sin_theta2_sin_theta3_1 = sin_theta3_1
        .mul_add(sin_theta2_0, sin_theta2_1 * sin_theta3_0);
    let cos_theta2_cos_theta3_1 = cos_theta3_1
        .mul_add(cos_theta2_0, cos_theta2_1 * cos_theta3_0);
    let u5_dot_of_u5_1 = u5_sq_cos_theta3_1
        .mul_add(sin_theta2_0, sin_theta2_1 * u5_sq_cos_theta3_0);
    let u5_dot_of_place_1 = sin_theta2_sin_theta3_1 + cos_theta2_cos_theta3_1;
    let u3_sq_cos_theta2_1 = u3_sq_1.mul_add(cos_theta2_0, cos_theta2_1 * u3_sq_0);
    let u5_dot_of_place_2_1 = S::int(9) * cos_theta2_sq_1 - cos_theta3_sq_1;
    let u5_dot_of_place_3_1 = u5_dot_of_place_2_1
        .mul_add(sin_theta1_0, sin_theta1_1 * u5_dot_of_place_2_0);
    let sin_theta2_cos_theta2_1 = cos_theta2_1
        .mul_add(sin_theta2_0, sin_theta2_1 * cos_theta2_0);
    let sin_theta3_cos_theta3_1 = cos_theta3_1
        .mul_add(sin_theta3_0, sin_theta3_1 * cos_theta3_0);
    let u5_dot_of_place_4_1 = S::int(9) * sin_theta2_cos_theta2_1 - sin_theta3_cos_theta3_1;
    let u5_dot_of_place_5_1 = u5_dot_of_place_4_1
        .mul_add(cos_theta1_0, cos_theta1_1 * u5_dot_of_place_4_0);
    let u5_dot_of_place_6_1 = u5_dot_of_place_3_1 - u5_dot_of_place_5_1;
    let u5_dot_of_place_7_1 = u5_dot_of_place_6_1
        .mul_add(sin_theta1_0, sin_theta1_1 * u5_dot_of_place_6_0);
    let u5_dot_of_place_8_1 = u5_dot_of_place_1
        .mul_add(cos_theta2_0, cos_theta2_1 * u5_dot_of_place_0);
    let u5_dot_of_place_9_1 = u5_dot_of_place_8_1
        .mul_add(-S::int(9), S::int(5) * cos_theta3_1);
    let u5_dot_of_place_10_1 = u5_dot_of_place_9_1
        .mul_add(cos_theta3_0, cos_theta3_1 * u5_dot_of_place_9_0);
    let u5_dot_of_place_11_1 = u5_dot_of_place_7_1 + u5_dot_of_place_10_1;
    let sin_theta1_cos_theta1_1 = cos_theta1_1
        .mul_add(sin_theta1_0, sin_theta1_1 * cos_theta1_0);
    let u5_dot_of_place_12_1 = S::int(9) * sin_theta2_cos_theta2_1 - sin_theta1_cos_theta1_1;
    let sin_theta1_sin_theta2_1 = sin_theta2_1
        .mul_add(sin_theta1_0, sin_theta1_1 * sin_theta2_0);
    let u5_dot_of_u3_1 = sin_theta1_sin_theta2_1
        .mul_add(u3_sq_0, u3_sq_1 * sin_theta1_sin_theta2_0);
    let u5_dot_of_u3_u4_1 = u5_dot_of_u3_1.mul_add(S::int(3), S::int(7) * u4_sq_1);
    let u5_dot_of_u3_u4_2_1 = u5_dot_of_u3_u4_1
        .mul_add(cos_theta2_0, cos_theta2_1 * u5_dot_of_u3_u4_0);
    let u5_dot_of_u5_2_1 = u5_dot_of_place_12_1
        .mul_add(u5_sq_0, u5_sq_1 * u5_dot_of_place_12_0);
    let u5_dot_of_u4_u5_1 = u5_sq_cos_theta3_1
        .mul_add(S::int(2), S::int(3) * u4_sq_cos_theta2_1);
    let u5_dot_of_u4_1 = sin_theta1_sin_theta2_1
        .mul_add(u4_sq_0, u4_sq_1 * sin_theta1_sin_theta2_0);
    let u5_dot_of_u3_2_1 = u3_sq_cos_theta2_1
        .mul_add(sin_theta2_0, sin_theta2_1 * u3_sq_cos_theta2_0);
    let u5_dot_of_u3_u5_1 = u5_sq_sin_theta3_1.mul_add(S::int(2), u3_sq_sin_theta1_1);
    let u5_dot_of_u4_u5_2_1 = u5_sq_sin_theta3_1
        .mul_add(S::int(2), S::int(3) * u4_sq_sin_theta2_1);
    let u4_sq_cos_theta1_1 = u4_sq_1.mul_add(cos_theta1_0, cos_theta1_1 * u4_sq_0);
    let u5_dot_of_u3_u5_2_1 = u5_dot_of_u3_u5_1
        .mul_add(cos_theta2_0, cos_theta2_1 * u5_dot_of_u3_u5_0);
    let u5_dot_of_u4_u5_3_1 = u5_dot_of_u4_u5_2_1
        .mul_add(cos_theta1_0, cos_theta1_1 * u5_dot_of_u4_u5_2_0);
    let u5_dot_of_u3_u4_3_1 = S::int(3) * u3_sq_cos_theta2_1 - u4_sq_cos_theta1_1;
    let u5_dot_of_u4_u5_4_1 = u5_dot_of_u4_u5_1
        .mul_add(sin_theta1_0, sin_theta1_1 * u5_dot_of_u4_u5_0);
    let u5_dot_of_u3_u4_u5_1 = S::int(9) * u5_dot_of_u3_2_1 + u5_dot_of_u4_u5_3_1
        - u5_dot_of_u4_u5_4_1;
    let u5_dot_of_u3_u4_u5_2_1 = u5_dot_of_u3_u4_u5_1
        .mul_add(cos_theta1_0, cos_theta1_1 * u5_dot_of_u3_u4_u5_0);
    let u5_dot_of_u3_u5_3_1 = S::int(2) * u5_dot_of_u5_1 - u5_dot_of_u3_u5_2_1;
    let u5_dot_of_u3_u5_4_1 = u5_dot_of_u3_u5_3_1
        .mul_add(cos_theta2_0, cos_theta2_1 * u5_dot_of_u3_u5_3_0);
    let u5_dot_of_u3_u4_u5_3_1 = u5_dot_of_u3_u5_4_1
        .mul_add(
            S::int(9),
            u5_sq_sin_theta3_1
                .mul_add(
                    S::int(8),
                    u4_sq_sin_theta2_1
                        .mul_add(S::int(18), S::int(6) * u3_sq_sin_theta1_1),
                ) + u5_dot_of_u3_u4_u5_2_1,
        );
    let u5_dot_of_u3_u4_u5_4_1 = u5_dot_of_u3_u4_u5_3_1
        .mul_add(cos_theta3_0, cos_theta3_1 * u5_dot_of_u3_u4_u5_3_0);
    let u5_dot_of_u3_u4_4_1 = u5_dot_of_u3_u4_3_1
        .mul_add(cos_theta2_0, cos_theta2_1 * u5_dot_of_u3_u4_3_0);
    let u5_dot_of_u3_u4_5_1 = u3_sq_1 + u5_dot_of_u4_1 - u5_dot_of_u3_u4_4_1;
    let u5_dot_of_u3_u4_6_1 = u5_dot_of_u3_u4_5_1
        .mul_add(cos_theta1_0, cos_theta1_1 * u5_dot_of_u3_u4_5_0);
    let u5_dot_of_u3_u4_7_1 = u5_dot_of_u3_u4_2_1 - u5_dot_of_u3_u4_6_1;
    let u5_dot_of_u3_u4_8_1 = u5_dot_of_u3_u4_7_1
        .mul_add(sin_theta3_0, sin_theta3_1 * u5_dot_of_u3_u4_7_0);
    let u5_dot_of_u3_u4_u5_5_1 = u5_dot_of_u3_u4_8_1.mul_add(S::int(3), u5_dot_of_u5_2_1)
        - u5_dot_of_u3_u4_u5_4_1;
    let u5_dot_of_u3_u4_u5_6_1 = u5_dot_of_place_11_1
        .mul_add(
            -(u5_dot_of_u3_u4_u5_6_0 * over_u5_dot_of_place_11),
            u5_dot_of_u3_u4_u5_5_1 * over_u5_dot_of_place_11,
        );
    let u3_sq_cos_theta1_1 = u3_sq_1.mul_add(cos_theta1_0, cos_theta1_1 * u3_sq_0);
    let cos_theta1_cos_theta2_1 = cos_theta2_1
        .mul_add(cos_theta1_0, cos_theta1_1 * cos_theta2_0);
    let u4_dot_of_place_1 = cos_theta1_cos_theta2_1
        .mul_add(S::int(2), sin_theta1_sin_theta2_1);
    let u4_dot_of_place_2_1 = u4_dot_of_place_1
        .mul_add(sin_theta1_sin_theta2_0, sin_theta1_sin_theta2_1 * u4_dot_of_place_0);
    let cos_theta1_sq_1 = cos_theta1_1 * (cos_theta1_0 + cos_theta1_0);
    let u4_dot_of_place_3_1 = cos_theta1_sq_1
        .mul_add(cos_theta2_sq_0, cos_theta2_sq_1 * cos_theta1_sq_0);
    let u4_dot_of_place_4_1 = u4_dot_of_place_2_1
        .mul_add(S::int(3), S::int(3) * u4_dot_of_place_3_1);
    let u4_dot_of_u3_u4_u5_1 = u5_dot_of_u3_u4_u5_6_1
        .mul_add(sin_theta3_0, sin_theta3_1 * u5_dot_of_u3_u4_u5_6_0);
    let u4_dot_of_u3_u4_u5_2_1 = u5_dot_of_u3_u4_u5_6_1
        .mul_add(cos_theta3_0, cos_theta3_1 * u5_dot_of_u3_u4_u5_6_0);
    let u4_dot_of_u4_u5_u5_dot_1 = u4_dot_of_u3_u4_u5_2_1
        .mul_add(S::ratio(1, 2), S::int(3) * u4_sq_sin_theta2_1 + u5_sq_sin_theta3_1);
    let u4_dot_of_u4_u5_u5_dot_2_1 = u4_dot_of_u4_u5_u5_dot_1
        .mul_add(sin_theta2_0, sin_theta2_1 * u4_dot_of_u4_u5_u5_dot_0);
    let u4_dot_of_u4_u5_u5_dot_3_1 = u4_dot_of_u3_u4_u5_1
        .mul_add(-S::ratio(1, 2), S::int(3) * u4_sq_cos_theta2_1 + u5_sq_cos_theta3_1);
    let u4_dot_of_u4_u5_u5_dot_4_1 = u4_dot_of_u4_u5_u5_dot_3_1
        .mul_add(cos_theta2_0, cos_theta2_1 * u4_dot_of_u4_u5_u5_dot_3_0);
    let u4_dot_of_u4_u5_u5_dot_5_1 = u4_dot_of_u4_u5_u5_dot_2_1 - u4_dot_of_u4_u5_u5_dot_4_1;
    let u4_dot_of_u4_u5_u5_dot_6_1 = u4_dot_of_u4_u5_u5_dot_5_1
        .mul_add(cos_theta1_0, cos_theta1_1 * u4_dot_of_u4_u5_u5_dot_5_0);
    let u4_dot_of_u4_u5_u5_dot_7_1 = u4_dot_of_u4_u5_u5_dot_3_1
        .mul_add(
            sin_theta1_sin_theta2_0,
            sin_theta1_sin_theta2_1 * u4_dot_of_u4_u5_u5_dot_3_0,
        );
    let u4_dot_of_motion_1 = S::int(3) * u3_sq_cos_theta2_1 + u4_dot_of_u4_u5_u5_dot_7_1
        - u4_dot_of_u4_u5_u5_dot_6_1;
    let u4_dot_of_motion_2_1 = u4_dot_of_motion_1
        .mul_add(sin_theta1_0, sin_theta1_1 * u4_dot_of_motion_0);
    let u4_dot_of_u4_u5_u5_dot_8_1 = u4_dot_of_u4_u5_u5_dot_1
        .mul_add(cos_theta1_sq_0, cos_theta1_sq_1 * u4_dot_of_u4_u5_u5_dot_0);
    let u4_dot_of_u4_u5_u5_dot_9_1 = u4_dot_of_u3_u4_u5_2_1
        .mul_add(S::ratio(3, 2), S::int(3) * u5_sq_sin_theta3_1) - u4_dot_of_u4_u5_u5_dot_8_1;
    let u4_dot_of_u4_u5_u5_dot_10_1 = u4_dot_of_u4_u5_u5_dot_9_1
        .mul_add(cos_theta2_0, cos_theta2_1 * u4_dot_of_u4_u5_u5_dot_9_0);
    let u4_dot_of_u3_u5_u5_dot_1 = u4_dot_of_u3_u4_u5_1
        .mul_add(-S::ratio(1, 2), u3_sq_cos_theta1_1 + u5_sq_cos_theta3_1);
    let u4_dot_of_u3_u5_u5_dot_2_1 = u4_dot_of_u3_u5_u5_dot_1
        .mul_add(sin_theta2_0, sin_theta2_1 * u4_dot_of_u3_u5_u5_dot_0);
    let u4_dot_of_motion_3_1 = -S::int(3) * u4_dot_of_u3_u5_u5_dot_2_1
        + u4_dot_of_u4_u5_u5_dot_10_1 + u4_dot_of_motion_2_1;
    let u4_dot_of_motion_4_1 = u4_dot_of_place_4_1
        .mul_add(
            -(u4_dot_of_motion_4_0 * over_u4_dot_of_place_4),
            u4_dot_of_motion_3_1 * over_u4_dot_of_place_4,
        );
    let u3_dot_of_motion_1 = u4_dot_of_motion_4_1
        .mul_add(sin_theta2_0, sin_theta2_1 * u4_dot_of_motion_4_0);
    let u3_dot_of_motion_2_1 = u3_dot_of_motion_1
        .mul_add(
            -S::int(3),
            u4_dot_of_u3_u4_u5_1
                .mul_add(
                    -S::ratio(1, 2),
                    S::int(3) * u4_sq_cos_theta2_1 + u5_sq_cos_theta3_1,
                ),
        );
    let u3_dot_of_motion_3_1 = u3_dot_of_motion_2_1
        .mul_add(sin_theta1_0, sin_theta1_1 * u3_dot_of_motion_2_0);
    let u3_dot_of_motion_4_1 = u4_dot_of_motion_4_1
        .mul_add(cos_theta2_0, cos_theta2_1 * u4_dot_of_motion_4_0);
    let u3_dot_of_motion_5_1 = u3_dot_of_motion_4_1
        .mul_add(
            S::int(3),
            u4_dot_of_u3_u4_u5_2_1
                .mul_add(
                    S::ratio(1, 2),
                    S::int(3) * u4_sq_sin_theta2_1 + u5_sq_sin_theta3_1,
                ),
        );
    let u3_dot_of_motion_6_1 = u3_dot_of_motion_5_1
        .mul_add(cos_theta1_0, cos_theta1_1 * u3_dot_of_motion_5_0);
    let u3_dot_2_1 = u3_dot_of_motion_6_1
        .mul_add(S::ratio(1, 3), -S::ratio(1, 3) * u3_dot_of_motion_3_1);
    let u2_dot_of_motion_1 = u3_dot_2_1.mul_add(cos_theta1_0, cos_theta1_1 * u3_dot_2_0);
    let u2_dot_of_motion_2_1 = u2_dot_of_motion_1
        .mul_add(
            -S::int(2),
            u3_dot_of_motion_4_1
                .mul_add(
                    S::int(3),
                    u4_dot_of_u3_u4_u5_2_1
                        .mul_add(
                            S::ratio(1, 2),
                            u4_sq_sin_theta2_1
                                .mul_add(S::int(3), S::int(2) * u3_sq_sin_theta1_1)
                                + u5_sq_sin_theta3_1,
                        ),
                ),
        );
    let u1_dot_of_motion_1 = u3_dot_2_1.mul_add(sin_theta1_0, sin_theta1_1 * u3_dot_2_0);
    let u1_dot_of_motion_2_1 = u1_dot_of_motion_1
        .mul_add(
            S::int(2),
            u3_dot_of_motion_1
                .mul_add(
                    -S::int(3),
                    u4_dot_of_u3_u4_u5_1
                        .mul_add(
                            -S::ratio(1, 2),
                            u4_sq_cos_theta2_1
                                .mul_add(S::int(3), S::int(2) * u3_sq_cos_theta1_1)
                                + u5_sq_cos_theta3_1,
                        ),
                ),
        );
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                theta1_1, theta1_1, theta2_1, theta2_1, theta3_1, theta3_1, u4_1, cos_theta2_1,
                cos_theta3_1, cos_theta2_1, u5_1, cos_theta3_1, u3_1, sin_theta1_1, sin_theta2_1,
                sin_theta3_1, sin_theta2_1, cos_theta2_1, sin_theta2_1, cos_theta2_1, sin_theta1_1,
                sin_theta2_1, sin_theta3_1, cos_theta1_1, sin_theta1_1, cos_theta2_1, cos_theta3_1,
                sin_theta1_1, sin_theta1_1, u3_sq_1, cos_theta2_1, u5_dot_of_place_12_1, u4_sq_1,
                sin_theta2_1, cos_theta1_1, cos_theta2_1, cos_theta1_1, sin_theta1_1, cos_theta1_1,
                cos_theta2_1, cos_theta3_1, cos_theta2_1, cos_theta1_1, sin_theta3_1,
                u5_dot_of_place_11_1, cos_theta1_1, cos_theta1_1, u4_dot_of_place_1, cos_theta1_1,
                cos_theta2_sq_1, u5_dot_of_u3_u4_u5_6_1, u5_dot_of_u3_u4_u5_6_1, sin_theta2_1,
                cos_theta2_1, cos_theta1_1, u4_dot_of_u4_u5_u5_dot_3_1, sin_theta1_1,
                u4_dot_of_u4_u5_u5_dot_1, cos_theta2_1, sin_theta2_1, u4_dot_of_place_4_1,
                u4_dot_of_motion_4_1, sin_theta1_1, u4_dot_of_motion_4_1, cos_theta1_1, u3_dot_2_1,
                u3_dot_2_1,
            ]),
            padded([
                cos_theta1_1, sin_theta1_1, cos_theta2_1, sin_theta2_1, cos_theta3_1, sin_theta3_1,
                u4_1, cos_theta2_1, cos_theta3_1, u4_sq_1, u5_1, u5_sq_1, u3_1, u3_sq_1, u4_sq_1,
                u5_sq_1, sin_theta3_1, cos_theta3_1, u5_sq_cos_theta3_1, u3_sq_1,
                u5_dot_of_place_2_1, cos_theta2_1, cos_theta3_1, u5_dot_of_place_4_1,
                u5_dot_of_place_6_1, u5_dot_of_place_1, u5_dot_of_place_9_1, cos_theta1_1,
                sin_theta2_1, sin_theta1_sin_theta2_1, u5_dot_of_u3_u4_1, u5_sq_1,
                sin_theta1_sin_theta2_1, u3_sq_cos_theta2_1, u4_sq_1, u5_dot_of_u3_u5_1,
                u5_dot_of_u4_u5_2_1, u5_dot_of_u4_u5_1, u5_dot_of_u3_u4_u5_1, u5_dot_of_u3_u5_3_1,
                u5_dot_of_u3_u4_u5_3_1, u5_dot_of_u3_u4_3_1, u5_dot_of_u3_u4_5_1,
                u5_dot_of_u3_u4_7_1, u5_dot_of_u3_u4_u5_6_1, u3_sq_1, cos_theta2_1,
                sin_theta1_sin_theta2_1, cos_theta1_1, cos_theta1_sq_1, sin_theta3_1, cos_theta3_1,
                u4_dot_of_u4_u5_u5_dot_1, u4_dot_of_u4_u5_u5_dot_3_1, u4_dot_of_u4_u5_u5_dot_5_1,
                sin_theta1_sin_theta2_1, u4_dot_of_motion_1, cos_theta1_sq_1,
                u4_dot_of_u4_u5_u5_dot_9_1, u4_dot_of_u3_u5_u5_dot_1, u4_dot_of_motion_4_1,
                sin_theta2_1, u3_dot_of_motion_2_1, cos_theta2_1, u3_dot_of_motion_5_1,
                cos_theta1_1, sin_theta1_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta1_last = theta1_1;
    let mut theta2_last = theta2_1;
    let mut theta3_last = theta3_1;
    let mut u3_last = u3_1;
    let mut u4_last = u4_1;
    let mut u5_last = u5_1;
    let mut sin_theta1_last = sin_theta1_1;
    let mut cos_theta1_last = cos_theta1_1;
    let mut sin_theta2_last = sin_theta2_1;
    let mut cos_theta2_last = cos_theta2_1;
    let mut sin_theta3_last = sin_theta3_1;
    let mut cos_theta3_last = cos_theta3_1;
    let mut u4_sq_last = u4_sq_1;
    let mut cos_theta2_sq_last = cos_theta2_sq_1;
    let mut u5_sq_last = u5_sq_1;
    let mut u5_sq_cos_theta3_last = u5_sq_cos_theta3_1;
    let mut u3_sq_last = u3_sq_1;
    let mut u5_dot_of_place_last = u5_dot_of_place_1;
    let mut u3_sq_cos_theta2_last = u3_sq_cos_theta2_1;
    let mut u5_dot_of_place_2_last = u5_dot_of_place_2_1;
    let mut u5_dot_of_place_4_last = u5_dot_of_place_4_1;
    let mut u5_dot_of_place_6_last = u5_dot_of_place_6_1;
    let mut u5_dot_of_place_9_last = u5_dot_of_place_9_1;
    let mut u5_dot_of_place_11_last = u5_dot_of_place_11_1;
    let mut u5_dot_of_place_12_last = u5_dot_of_place_12_1;
    let mut sin_theta1_sin_theta2_last = sin_theta1_sin_theta2_1;
    let mut u5_dot_of_u3_u4_last = u5_dot_of_u3_u4_1;
    let mut u5_dot_of_u4_u5_last = u5_dot_of_u4_u5_1;
    let mut u5_dot_of_u3_u5_last = u5_dot_of_u3_u5_1;
    let mut u5_dot_of_u4_u5_2_last = u5_dot_of_u4_u5_2_1;
    let mut u5_dot_of_u3_u4_3_last = u5_dot_of_u3_u4_3_1;
    let mut u5_dot_of_u3_u4_u5_last = u5_dot_of_u3_u4_u5_1;
    let mut u5_dot_of_u3_u5_3_last = u5_dot_of_u3_u5_3_1;
    let mut u5_dot_of_u3_u4_u5_3_last = u5_dot_of_u3_u4_u5_3_1;
    let mut u5_dot_of_u3_u4_5_last = u5_dot_of_u3_u4_5_1;
    let mut u5_dot_of_u3_u4_7_last = u5_dot_of_u3_u4_7_1;
    let mut u5_dot_of_u3_u4_u5_6_last = u5_dot_of_u3_u4_u5_6_1;
    let mut u4_dot_of_place_last = u4_dot_of_place_1;
    let mut cos_theta1_sq_last = cos_theta1_sq_1;
    let mut u4_dot_of_place_4_last = u4_dot_of_place_4_1;
    let mut u4_dot_of_u4_u5_u5_dot_last = u4_dot_of_u4_u5_u5_dot_1;
    let mut u4_dot_of_u4_u5_u5_dot_3_last = u4_dot_of_u4_u5_u5_dot_3_1;
    let mut u4_dot_of_u4_u5_u5_dot_5_last = u4_dot_of_u4_u5_u5_dot_5_1;
    let mut u4_dot_of_motion_last = u4_dot_of_motion_1;
    let mut u4_dot_of_u4_u5_u5_dot_9_last = u4_dot_of_u4_u5_u5_dot_9_1;
    let mut u4_dot_of_u3_u5_u5_dot_last = u4_dot_of_u3_u5_u5_dot_1;
    let mut u4_dot_of_motion_4_last = u4_dot_of_motion_4_1;
    let mut u3_dot_of_motion_2_last = u3_dot_of_motion_2_1;
    let mut u3_dot_of_motion_5_last = u3_dot_of_motion_5_1;
    let mut u3_dot_2_last = u3_dot_2_1;
    let mut next = [S::int(0); 72];
    // Rates at order k - 1.
    let mut x_rate = u1_1;
    let mut y_rate = u2_1;
    let mut theta1_rate = u3_1;
    let mut theta2_rate = u4_1;
    let mut theta3_rate = u5_1;
    let mut u1_rate = l_by_6 * u1_dot_of_motion_2_1;
    let mut u2_rate = l_by_6 * u2_dot_of_motion_2_1;
    let mut u3_rate = u3_dot_2_1;
    let mut u4_rate = -u4_dot_of_motion_4_1;
    let mut u5_rate = -S::ratio(1, 2) * u5_dot_of_u3_u4_u5_6_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let x = x_rate * over_k;
        let y = y_rate * over_k;
        let theta1 = theta1_rate * over_k;
        let theta2 = theta2_rate * over_k;
        let theta3 = theta3_rate * over_k;
        let u1 = u1_rate * over_k;
        let u2 = u2_rate * over_k;
        let u3 = u3_rate * over_k;
        let u4 = u4_rate * over_k;
        let u5 = u5_rate * over_k;
        series[order] = [x, y, theta1, theta2, theta3, u1, u2, u3, u4, u5];
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
                (u4_1 + u4_1).mul_add(u4_last, next[6]),
                (cos_theta2_1 + cos_theta2_1).mul_add(cos_theta2_last, next[7]),
                (cos_theta3_1 + cos_theta3_1).mul_add(cos_theta3_last, next[8]),
                cos_theta2_1
                    .mul_add(u4_sq_last, cos_theta2_last.mul_add(u4_sq_1, next[9])),
                (u5_1 + u5_1).mul_add(u5_last, next[10]),
                cos_theta3_1
                    .mul_add(u5_sq_last, cos_theta3_last.mul_add(u5_sq_1, next[11])),
                (u3_1 + u3_1).mul_add(u3_last, next[12]),
                sin_theta1_1
                    .mul_add(u3_sq_last, sin_theta1_last.mul_add(u3_sq_1, next[13])),
                sin_theta2_1
                    .mul_add(u4_sq_last, sin_theta2_last.mul_add(u4_sq_1, next[14])),
                sin_theta3_1
                    .mul_add(u5_sq_last, sin_theta3_last.mul_add(u5_sq_1, next[15])),
                sin_theta2_1
                    .mul_add(
                        sin_theta3_last,
                        sin_theta2_last.mul_add(sin_theta3_1, next[16]),
                    ),
                cos_theta2_1
                    .mul_add(
                        cos_theta3_last,
                        cos_theta2_last.mul_add(cos_theta3_1, next[17]),
                    ),
                sin_theta2_1
                    .mul_add(
                        u5_sq_cos_theta3_last,
                        sin_theta2_last.mul_add(u5_sq_cos_theta3_1, next[18]),
                    ),
                cos_theta2_1
                    .mul_add(u3_sq_last, cos_theta2_last.mul_add(u3_sq_1, next[19])),
                sin_theta1_1
                    .mul_add(
                        u5_dot_of_place_2_last,
                        sin_theta1_last.mul_add(u5_dot_of_place_2_1, next[20]),
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
                        u5_dot_of_place_4_last,
                        cos_theta1_last.mul_add(u5_dot_of_place_4_1, next[23]),
                    ),
                sin_theta1_1
                    .mul_add(
                        u5_dot_of_place_6_last,
                        sin_theta1_last.mul_add(u5_dot_of_place_6_1, next[24]),
                    ),
                cos_theta2_1
                    .mul_add(
                        u5_dot_of_place_last,
                        cos_theta2_last.mul_add(u5_dot_of_place_1, next[25]),
                    ),
                cos_theta3_1
                    .mul_add(
                        u5_dot_of_place_9_last,
                        cos_theta3_last.mul_add(u5_dot_of_place_9_1, next[26]),
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
                u3_sq_1
                    .mul_add(
                        sin_theta1_sin_theta2_last,
                        u3_sq_last.mul_add(sin_theta1_sin_theta2_1, next[29]),
                    ),
                cos_theta2_1
                    .mul_add(
                        u5_dot_of_u3_u4_last,
                        cos_theta2_last.mul_add(u5_dot_of_u3_u4_1, next[30]),
                    ),
                u5_dot_of_place_12_1
                    .mul_add(
                        u5_sq_last,
                        u5_dot_of_place_12_last.mul_add(u5_sq_1, next[31]),
                    ),
                u4_sq_1
                    .mul_add(
                        sin_theta1_sin_theta2_last,
                        u4_sq_last.mul_add(sin_theta1_sin_theta2_1, next[32]),
                    ),
                sin_theta2_1
                    .mul_add(
                        u3_sq_cos_theta2_last,
                        sin_theta2_last.mul_add(u3_sq_cos_theta2_1, next[33]),
                    ),
                cos_theta1_1
                    .mul_add(u4_sq_last, cos_theta1_last.mul_add(u4_sq_1, next[34])),
                cos_theta2_1
                    .mul_add(
                        u5_dot_of_u3_u5_last,
                        cos_theta2_last.mul_add(u5_dot_of_u3_u5_1, next[35]),
                    ),
                cos_theta1_1
                    .mul_add(
                        u5_dot_of_u4_u5_2_last,
                        cos_theta1_last.mul_add(u5_dot_of_u4_u5_2_1, next[36]),
                    ),
                sin_theta1_1
                    .mul_add(
                        u5_dot_of_u4_u5_last,
                        sin_theta1_last.mul_add(u5_dot_of_u4_u5_1, next[37]),
                    ),
                cos_theta1_1
                    .mul_add(
                        u5_dot_of_u3_u4_u5_last,
                        cos_theta1_last.mul_add(u5_dot_of_u3_u4_u5_1, next[38]),
                    ),
                cos_theta2_1
                    .mul_add(
                        u5_dot_of_u3_u5_3_last,
                        cos_theta2_last.mul_add(u5_dot_of_u3_u5_3_1, next[39]),
                    ),
                cos_theta3_1
                    .mul_add(
                        u5_dot_of_u3_u4_u5_3_last,
                        cos_theta3_last.mul_add(u5_dot_of_u3_u4_u5_3_1, next[40]),
                    ),
                cos_theta2_1
                    .mul_add(
                        u5_dot_of_u3_u4_3_last,
                        cos_theta2_last.mul_add(u5_dot_of_u3_u4_3_1, next[41]),
                    ),
                cos_theta1_1
                    .mul_add(
                        u5_dot_of_u3_u4_5_last,
                        cos_theta1_last.mul_add(u5_dot_of_u3_u4_5_1, next[42]),
                    ),
                sin_theta3_1
                    .mul_add(
                        u5_dot_of_u3_u4_7_last,
                        sin_theta3_last.mul_add(u5_dot_of_u3_u4_7_1, next[43]),
                    ),
                u5_dot_of_place_11_1
                    .mul_add(
                        u5_dot_of_u3_u4_u5_6_last,
                        u5_dot_of_place_11_last.mul_add(u5_dot_of_u3_u4_u5_6_1, next[44]),
                    ),
                cos_theta1_1
                    .mul_add(u3_sq_last, cos_theta1_last.mul_add(u3_sq_1, next[45])),
                cos_theta1_1
                    .mul_add(
                        cos_theta2_last,
                        cos_theta1_last.mul_add(cos_theta2_1, next[46]),
                    ),
                u4_dot_of_place_1
                    .mul_add(
                        sin_theta1_sin_theta2_last,
                        u4_dot_of_place_last.mul_add(sin_theta1_sin_theta2_1, next[47]),
                    ),
                (cos_theta1_1 + cos_theta1_1).mul_add(cos_theta1_last, next[48]),
                cos_theta2_sq_1
                    .mul_add(
                        cos_theta1_sq_last,
                        cos_theta2_sq_last.mul_add(cos_theta1_sq_1, next[49]),
                    ),
                u5_dot_of_u3_u4_u5_6_1
                    .mul_add(
                        sin_theta3_last,
                        u5_dot_of_u3_u4_u5_6_last.mul_add(sin_theta3_1, next[50]),
                    ),
                u5_dot_of_u3_u4_u5_6_1
                    .mul_add(
                        cos_theta3_last,
                        u5_dot_of_u3_u4_u5_6_last.mul_add(cos_theta3_1, next[51]),
                    ),
                sin_theta2_1
                    .mul_add(
                        u4_dot_of_u4_u5_u5_dot_last,
                        sin_theta2_last.mul_add(u4_dot_of_u4_u5_u5_dot_1, next[52]),
                    ),
                cos_theta2_1
                    .mul_add(
                        u4_dot_of_u4_u5_u5_dot_3_last,
                        cos_theta2_last.mul_add(u4_dot_of_u4_u5_u5_dot_3_1, next[53]),
                    ),
                cos_theta1_1
                    .mul_add(
                        u4_dot_of_u4_u5_u5_dot_5_last,
                        cos_theta1_last.mul_add(u4_dot_of_u4_u5_u5_dot_5_1, next[54]),
                    ),
                u4_dot_of_u4_u5_u5_dot_3_1
                    .mul_add(
                        sin_theta1_sin_theta2_last,
                        u4_dot_of_u4_u5_u5_dot_3_last
                            .mul_add(sin_theta1_sin_theta2_1, next[55]),
                    ),
                sin_theta1_1
                    .mul_add(
                        u4_dot_of_motion_last,
                        sin_theta1_last.mul_add(u4_dot_of_motion_1, next[56]),
                    ),
                u4_dot_of_u4_u5_u5_dot_1
                    .mul_add(
                        cos_theta1_sq_last,
                        u4_dot_of_u4_u5_u5_dot_last.mul_add(cos_theta1_sq_1, next[57]),
                    ),
                cos_theta2_1
                    .mul_add(
                        u4_dot_of_u4_u5_u5_dot_9_last,
                        cos_theta2_last.mul_add(u4_dot_of_u4_u5_u5_dot_9_1, next[58]),
                    ),
                sin_theta2_1
                    .mul_add(
                        u4_dot_of_u3_u5_u5_dot_last,
                        sin_theta2_last.mul_add(u4_dot_of_u3_u5_u5_dot_1, next[59]),
                    ),
                u4_dot_of_place_4_1
                    .mul_add(
                        u4_dot_of_motion_4_last,
                        u4_dot_of_place_4_last.mul_add(u4_dot_of_motion_4_1, next[60]),
                    ),
                u4_dot_of_motion_4_1
                    .mul_add(
                        sin_theta2_last,
                        u4_dot_of_motion_4_last.mul_add(sin_theta2_1, next[61]),
                    ),
                sin_theta1_1
                    .mul_add(
                        u3_dot_of_motion_2_last,
                        sin_theta1_last.mul_add(u3_dot_of_motion_2_1, next[62]),
                    ),
                u4_dot_of_motion_4_1
                    .mul_add(
                        cos_theta2_last,
                        u4_dot_of_motion_4_last.mul_add(cos_theta2_1, next[63]),
                    ),
                cos_theta1_1
                    .mul_add(
                        u3_dot_of_motion_5_last,
                        cos_theta1_last.mul_add(u3_dot_of_motion_5_1, next[64]),
                    ),
                u3_dot_2_1
                    .mul_add(
                        cos_theta1_last,
                        u3_dot_2_last.mul_add(cos_theta1_1, next[65]),
                    ),
                u3_dot_2_1
                    .mul_add(
                        sin_theta1_last,
                        u3_dot_2_last.mul_add(sin_theta1_1, next[66]),
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
        // u4_sq = u4*u4
        let u4_sq = u4.mul_add(u4_0 + u4_0, sums[6]);
        // cos_theta2_sq = cos_theta2*cos_theta2
        let cos_theta2_sq = cos_theta2.mul_add(cos_theta2_0 + cos_theta2_0, sums[7]);
        // cos_theta3_sq = cos_theta3*cos_theta3
        let cos_theta3_sq = cos_theta3.mul_add(cos_theta3_0 + cos_theta3_0, sums[8]);
        // u4_sq_cos_theta2 = cos_theta2*u4_sq
        let u4_sq_cos_theta2 = u4_sq
            .mul_add(cos_theta2_0, cos_theta2.mul_add(u4_sq_0, sums[9]));
        // u5_sq = u5*u5
        let u5_sq = u5.mul_add(u5_0 + u5_0, sums[10]);
        // u5_sq_cos_theta3 = cos_theta3*u5_sq
        let u5_sq_cos_theta3 = u5_sq
            .mul_add(cos_theta3_0, cos_theta3.mul_add(u5_sq_0, sums[11]));
        // u3_sq = u3*u3
        let u3_sq = u3.mul_add(u3_0 + u3_0, sums[12]);
        // u3_sq_sin_theta1 = sin_theta1*u3_sq
        let u3_sq_sin_theta1 = u3_sq
            .mul_add(sin_theta1_0, sin_theta1.mul_add(u3_sq_0, sums[13]));
        // u4_sq_sin_theta2 = sin_theta2*u4_sq
        let u4_sq_sin_theta2 = u4_sq
            .mul_add(sin_theta2_0, sin_theta2.mul_add(u4_sq_0, sums[14]));
        // u5_sq_sin_theta3 = sin_theta3*u5_sq
        let u5_sq_sin_theta3 = u5_sq
            .mul_add(sin_theta3_0, sin_theta3.mul_add(u5_sq_0, sums[15]));
        // sin_theta2_sin_theta3 = sin_theta2*sin_theta3
        let sin_theta2_sin_theta3 = sin_theta3
            .mul_add(sin_theta2_0, sin_theta2.mul_add(sin_theta3_0, sums[16]));
        // cos_theta2_cos_theta3 = cos_theta2*cos_theta3
        let cos_theta2_cos_theta3 = cos_theta3
            .mul_add(cos_theta2_0, cos_theta2.mul_add(cos_theta3_0, sums[17]));
        // u5_dot_of_u5 = sin_theta2*u5_sq_cos_theta3
        let u5_dot_of_u5 = u5_sq_cos_theta3
            .mul_add(sin_theta2_0, sin_theta2.mul_add(u5_sq_cos_theta3_0, sums[18]));
        // u5_dot_of_place = sin_theta2_sin_theta3 + cos_theta2_cos_theta3
        let u5_dot_of_place = sin_theta2_sin_theta3 + cos_theta2_cos_theta3;
        // u3_sq_cos_theta2 = cos_theta2*u3_sq
        let u3_sq_cos_theta2 = u3_sq
            .mul_add(cos_theta2_0, cos_theta2.mul_add(u3_sq_0, sums[19]));
        // u5_dot_of_place_2 = -4 + 9*cos_theta2_sq - cos_theta3_sq
        let u5_dot_of_place_2 = S::int(9) * cos_theta2_sq - cos_theta3_sq;
        // u5_dot_of_place_3 = sin_theta1*u5_dot_of_place_2
        let u5_dot_of_place_3 = u5_dot_of_place_2
            .mul_add(sin_theta1_0, sin_theta1.mul_add(u5_dot_of_place_2_0, sums[20]));
        // sin_theta2_cos_theta2 = sin_theta2*cos_theta2
        let sin_theta2_cos_theta2 = cos_theta2
            .mul_add(sin_theta2_0, sin_theta2.mul_add(cos_theta2_0, sums[21]));
        // sin_theta3_cos_theta3 = sin_theta3*cos_theta3
        let sin_theta3_cos_theta3 = cos_theta3
            .mul_add(sin_theta3_0, sin_theta3.mul_add(cos_theta3_0, sums[22]));
        // u5_dot_of_place_4 = 9*sin_theta2_cos_theta2 - sin_theta3_cos_theta3
        let u5_dot_of_place_4 = S::int(9) * sin_theta2_cos_theta2 - sin_theta3_cos_theta3;
        // u5_dot_of_place_5 = cos_theta1*u5_dot_of_place_4
        let u5_dot_of_place_5 = u5_dot_of_place_4
            .mul_add(cos_theta1_0, cos_theta1.mul_add(u5_dot_of_place_4_0, sums[23]));
        // u5_dot_of_place_6 = u5_dot_of_place_3 - u5_dot_of_place_5
        let u5_dot_of_place_6 = u5_dot_of_place_3 - u5_dot_of_place_5;
        // u5_dot_of_place_7 = sin_theta1*u5_dot_of_place_6
        let u5_dot_of_place_7 = u5_dot_of_place_6
            .mul_add(sin_theta1_0, sin_theta1.mul_add(u5_dot_of_place_6_0, sums[24]));
        // u5_dot_of_place_8 = cos_theta2*u5_dot_of_place
        let u5_dot_of_place_8 = u5_dot_of_place
            .mul_add(cos_theta2_0, cos_theta2.mul_add(u5_dot_of_place_0, sums[25]));
        // u5_dot_of_place_9 = 5*cos_theta3 - 9*u5_dot_of_place_8
        let u5_dot_of_place_9 = u5_dot_of_place_8
            .mul_add(-S::int(9), S::int(5) * cos_theta3);
        // u5_dot_of_place_10 = cos_theta3*u5_dot_of_place_9
        let u5_dot_of_place_10 = u5_dot_of_place_9
            .mul_add(cos_theta3_0, cos_theta3.mul_add(u5_dot_of_place_9_0, sums[26]));
        // u5_dot_of_place_11 = 9 + u5_dot_of_place_7 + u5_dot_of_place_10
        let u5_dot_of_place_11 = u5_dot_of_place_7 + u5_dot_of_place_10;
        // sin_theta1_cos_theta1 = sin_theta1*cos_theta1
        let sin_theta1_cos_theta1 = cos_theta1
            .mul_add(sin_theta1_0, sin_theta1.mul_add(cos_theta1_0, sums[27]));
        // u5_dot_of_place_12 = 9*sin_theta2_cos_theta2 - sin_theta1_cos_theta1
        let u5_dot_of_place_12 = S::int(9) * sin_theta2_cos_theta2 - sin_theta1_cos_theta1;
        // sin_theta1_sin_theta2 = sin_theta1*sin_theta2
        let sin_theta1_sin_theta2 = sin_theta2
            .mul_add(sin_theta1_0, sin_theta1.mul_add(sin_theta2_0, sums[28]));
        // u5_dot_of_u3 = u3_sq*sin_theta1_sin_theta2
        let u5_dot_of_u3 = sin_theta1_sin_theta2
            .mul_add(u3_sq_0, u3_sq.mul_add(sin_theta1_sin_theta2_0, sums[29]));
        // u5_dot_of_u3_u4 = 7*u4_sq + 3*u5_dot_of_u3
        let u5_dot_of_u3_u4 = u5_dot_of_u3.mul_add(S::int(3), S::int(7) * u4_sq);
        // u5_dot_of_u3_u4_2 = cos_theta2*u5_dot_of_u3_u4
        let u5_dot_of_u3_u4_2 = u5_dot_of_u3_u4
            .mul_add(cos_theta2_0, cos_theta2.mul_add(u5_dot_of_u3_u4_0, sums[30]));
        // u5_dot_of_u5_2 = u5_dot_of_place_12*u5_sq
        let u5_dot_of_u5_2 = u5_dot_of_place_12
            .mul_add(u5_sq_0, u5_sq.mul_add(u5_dot_of_place_12_0, sums[31]));
        // u5_dot_of_u4_u5 = 3*u4_sq_cos_theta2 + 2*u5_sq_cos_theta3
        let u5_dot_of_u4_u5 = u5_sq_cos_theta3
            .mul_add(S::int(2), S::int(3) * u4_sq_cos_theta2);
        // u5_dot_of_u4 = u4_sq*sin_theta1_sin_theta2
        let u5_dot_of_u4 = sin_theta1_sin_theta2
            .mul_add(u4_sq_0, u4_sq.mul_add(sin_theta1_sin_theta2_0, sums[32]));
        // u5_dot_of_u3_2 = sin_theta2*u3_sq_cos_theta2
        let u5_dot_of_u3_2 = u3_sq_cos_theta2
            .mul_add(sin_theta2_0, sin_theta2.mul_add(u3_sq_cos_theta2_0, sums[33]));
        // u5_dot_of_u3_u5 = u3_sq_sin_theta1 + 2*u5_sq_sin_theta3
        let u5_dot_of_u3_u5 = u5_sq_sin_theta3.mul_add(S::int(2), u3_sq_sin_theta1);
        // u5_dot_of_u4_u5_2 = 3*u4_sq_sin_theta2 + 2*u5_sq_sin_theta3
        let u5_dot_of_u4_u5_2 = u5_sq_sin_theta3
            .mul_add(S::int(2), S::int(3) * u4_sq_sin_theta2);
        // u4_sq_cos_theta1 = cos_theta1*u4_sq
        let u4_sq_cos_theta1 = u4_sq
            .mul_add(cos_theta1_0, cos_theta1.mul_add(u4_sq_0, sums[34]));
        // u5_dot_of_u3_u5_2 = cos_theta2*u5_dot_of_u3_u5
        let u5_dot_of_u3_u5_2 = u5_dot_of_u3_u5
            .mul_add(cos_theta2_0, cos_theta2.mul_add(u5_dot_of_u3_u5_0, sums[35]));
        // u5_dot_of_u4_u5_3 = cos_theta1*u5_dot_of_u4_u5_2
        let u5_dot_of_u4_u5_3 = u5_dot_of_u4_u5_2
            .mul_add(cos_theta1_0, cos_theta1.mul_add(u5_dot_of_u4_u5_2_0, sums[36]));
        // u5_dot_of_u3_u4_3 = 3*u3_sq_cos_theta2 - u4_sq_cos_theta1
        let u5_dot_of_u3_u4_3 = S::int(3) * u3_sq_cos_theta2 - u4_sq_cos_theta1;
        // u5_dot_of_u4_u5_4 = sin_theta1*u5_dot_of_u4_u5
        let u5_dot_of_u4_u5_4 = u5_dot_of_u4_u5
            .mul_add(sin_theta1_0, sin_theta1.mul_add(u5_dot_of_u4_u5_0, sums[37]));
        // u5_dot_of_u3_u4_u5 = 9*u5_dot_of_u3_2 + u5_dot_of_u4_u5_3 - u5_dot_of_u4_u5_4
        let u5_dot_of_u3_u4_u5 = S::int(9) * u5_dot_of_u3_2 + u5_dot_of_u4_u5_3 - u5_dot_of_u4_u5_4;
        // u5_dot_of_u3_u4_u5_2 = cos_theta1*u5_dot_of_u3_u4_u5
        let u5_dot_of_u3_u4_u5_2 = u5_dot_of_u3_u4_u5
            .mul_add(cos_theta1_0, cos_theta1.mul_add(u5_dot_of_u3_u4_u5_0, sums[38]));
        // u5_dot_of_u3_u5_3 = 2*u5_dot_of_u5 - u5_dot_of_u3_u5_2
        let u5_dot_of_u3_u5_3 = S::int(2) * u5_dot_of_u5 - u5_dot_of_u3_u5_2;
        // u5_dot_of_u3_u5_4 = cos_theta2*u5_dot_of_u3_u5_3
        let u5_dot_of_u3_u5_4 = u5_dot_of_u3_u5_3
            .mul_add(cos_theta2_0, cos_theta2.mul_add(u5_dot_of_u3_u5_3_0, sums[39]));
        // u5_dot_of_u3_u4_u5_3 = 6*u3_sq_sin_theta1 + 18*u4_sq_sin_theta2 + 8*u5_sq_sin_theta3 +
        //   u5_dot_of_u3_u4_u5_2 + 9*u5_dot_of_u3_u5_4
        let u5_dot_of_u3_u4_u5_3 = u5_dot_of_u3_u5_4
            .mul_add(
                S::int(9),
                u5_sq_sin_theta3
                    .mul_add(
                        S::int(8),
                        u4_sq_sin_theta2
                            .mul_add(S::int(18), S::int(6) * u3_sq_sin_theta1),
                    ) + u5_dot_of_u3_u4_u5_2,
            );
        // u5_dot_of_u3_u4_u5_4 = cos_theta3*u5_dot_of_u3_u4_u5_3
        let u5_dot_of_u3_u4_u5_4 = u5_dot_of_u3_u4_u5_3
            .mul_add(cos_theta3_0, cos_theta3.mul_add(u5_dot_of_u3_u4_u5_3_0, sums[40]));
        // u5_dot_of_u3_u4_4 = cos_theta2*u5_dot_of_u3_u4_3
        let u5_dot_of_u3_u4_4 = u5_dot_of_u3_u4_3
            .mul_add(cos_theta2_0, cos_theta2.mul_add(u5_dot_of_u3_u4_3_0, sums[41]));
        // u5_dot_of_u3_u4_5 = u3_sq + u5_dot_of_u4 - u5_dot_of_u3_u4_4
        let u5_dot_of_u3_u4_5 = u3_sq + u5_dot_of_u4 - u5_dot_of_u3_u4_4;
        // u5_dot_of_u3_u4_6 = cos_theta1*u5_dot_of_u3_u4_5
        let u5_dot_of_u3_u4_6 = u5_dot_of_u3_u4_5
            .mul_add(cos_theta1_0, cos_theta1.mul_add(u5_dot_of_u3_u4_5_0, sums[42]));
        // u5_dot_of_u3_u4_7 = u5_dot_of_u3_u4_2 - u5_dot_of_u3_u4_6
        let u5_dot_of_u3_u4_7 = u5_dot_of_u3_u4_2 - u5_dot_of_u3_u4_6;
        // u5_dot_of_u3_u4_8 = sin_theta3*u5_dot_of_u3_u4_7
        let u5_dot_of_u3_u4_8 = u5_dot_of_u3_u4_7
            .mul_add(sin_theta3_0, sin_theta3.mul_add(u5_dot_of_u3_u4_7_0, sums[43]));
        // u5_dot_of_u3_u4_u5_5 = u5_dot_of_u5_2 - u5_dot_of_u3_u4_u5_4 + 3*u5_dot_of_u3_u4_8
        let u5_dot_of_u3_u4_u5_5 = u5_dot_of_u3_u4_8.mul_add(S::int(3), u5_dot_of_u5_2)
            - u5_dot_of_u3_u4_u5_4;
        // u5_dot_of_u3_u4_u5_6 = u5_dot_of_u3_u4_u5_5/u5_dot_of_place_11
        let u5_dot_of_u3_u4_u5_6 = u5_dot_of_u3_u4_u5_5
            .mul_add(
                over_u5_dot_of_place_11,
                -(u5_dot_of_place_11.mul_add(u5_dot_of_u3_u4_u5_6_0, sums[44])
                    * over_u5_dot_of_place_11),
            );
        // u3_sq_cos_theta1 = cos_theta1*u3_sq
        let u3_sq_cos_theta1 = u3_sq
            .mul_add(cos_theta1_0, cos_theta1.mul_add(u3_sq_0, sums[45]));
        // cos_theta1_cos_theta2 = cos_theta1*cos_theta2
        let cos_theta1_cos_theta2 = cos_theta2
            .mul_add(cos_theta1_0, cos_theta1.mul_add(cos_theta2_0, sums[46]));
        // u4_dot_of_place = sin_theta1_sin_theta2 + 2*cos_theta1_cos_theta2
        let u4_dot_of_place = cos_theta1_cos_theta2
            .mul_add(S::int(2), sin_theta1_sin_theta2);
        // u4_dot_of_place_2 = u4_dot_of_place*sin_theta1_sin_theta2
        let u4_dot_of_place_2 = u4_dot_of_place
            .mul_add(
                sin_theta1_sin_theta2_0,
                sin_theta1_sin_theta2.mul_add(u4_dot_of_place_0, sums[47]),
            );
        // cos_theta1_sq = cos_theta1*cos_theta1
        let cos_theta1_sq = cos_theta1.mul_add(cos_theta1_0 + cos_theta1_0, sums[48]);
        // u4_dot_of_place_3 = cos_theta2_sq*cos_theta1_sq
        let u4_dot_of_place_3 = cos_theta1_sq
            .mul_add(cos_theta2_sq_0, cos_theta2_sq.mul_add(cos_theta1_sq_0, sums[49]));
        // u4_dot_of_place_4 = -7 + 3*u4_dot_of_place_2 + 3*u4_dot_of_place_3
        let u4_dot_of_place_4 = u4_dot_of_place_2
            .mul_add(S::int(3), S::int(3) * u4_dot_of_place_3);
        // u4_dot_of_u3_u4_u5 = u5_dot_of_u3_u4_u5_6*sin_theta3
        let u4_dot_of_u3_u4_u5 = u5_dot_of_u3_u4_u5_6
            .mul_add(sin_theta3_0, sin_theta3.mul_add(u5_dot_of_u3_u4_u5_6_0, sums[50]));
        // u4_dot_of_u3_u4_u5_2 = u5_dot_of_u3_u4_u5_6*cos_theta3
        let u4_dot_of_u3_u4_u5_2 = u5_dot_of_u3_u4_u5_6
            .mul_add(cos_theta3_0, cos_theta3.mul_add(u5_dot_of_u3_u4_u5_6_0, sums[51]));
        // u4_dot_of_u4_u5_u5_dot = 3*u4_sq_sin_theta2 + u5_sq_sin_theta3 + 1/2*u4_dot_of_u3_u4_u5_2
        let u4_dot_of_u4_u5_u5_dot = u4_dot_of_u3_u4_u5_2
            .mul_add(S::ratio(1, 2), S::int(3) * u4_sq_sin_theta2 + u5_sq_sin_theta3);
        // u4_dot_of_u4_u5_u5_dot_2 = sin_theta2*u4_dot_of_u4_u5_u5_dot
        let u4_dot_of_u4_u5_u5_dot_2 = u4_dot_of_u4_u5_u5_dot
            .mul_add(
                sin_theta2_0,
                sin_theta2.mul_add(u4_dot_of_u4_u5_u5_dot_0, sums[52]),
            );
        // u4_dot_of_u4_u5_u5_dot_3 = 3*u4_sq_cos_theta2 + u5_sq_cos_theta3 - 1/2*u4_dot_of_u3_u4_u5
        let u4_dot_of_u4_u5_u5_dot_3 = u4_dot_of_u3_u4_u5
            .mul_add(-S::ratio(1, 2), S::int(3) * u4_sq_cos_theta2 + u5_sq_cos_theta3);
        // u4_dot_of_u4_u5_u5_dot_4 = cos_theta2*u4_dot_of_u4_u5_u5_dot_3
        let u4_dot_of_u4_u5_u5_dot_4 = u4_dot_of_u4_u5_u5_dot_3
            .mul_add(
                cos_theta2_0,
                cos_theta2.mul_add(u4_dot_of_u4_u5_u5_dot_3_0, sums[53]),
            );
        // u4_dot_of_u4_u5_u5_dot_5 = u4_dot_of_u4_u5_u5_dot_2 - u4_dot_of_u4_u5_u5_dot_4
        let u4_dot_of_u4_u5_u5_dot_5 = u4_dot_of_u4_u5_u5_dot_2 - u4_dot_of_u4_u5_u5_dot_4;
        // u4_dot_of_u4_u5_u5_dot_6 = cos_theta1*u4_dot_of_u4_u5_u5_dot_5
        let u4_dot_of_u4_u5_u5_dot_6 = u4_dot_of_u4_u5_u5_dot_5
            .mul_add(
                cos_theta1_0,
                cos_theta1.mul_add(u4_dot_of_u4_u5_u5_dot_5_0, sums[54]),
            );
        // u4_dot_of_u4_u5_u5_dot_7 = u4_dot_of_u4_u5_u5_dot_3*sin_theta1_sin_theta2
        let u4_dot_of_u4_u5_u5_dot_7 = u4_dot_of_u4_u5_u5_dot_3
            .mul_add(
                sin_theta1_sin_theta2_0,
                sin_theta1_sin_theta2.mul_add(u4_dot_of_u4_u5_u5_dot_3_0, sums[55]),
            );
        // u4_dot_of_motion = 3*u3_sq_cos_theta2 - u4_dot_of_u4_u5_u5_dot_6 + u4_dot_of_u4_u5_u5_dot_7
        let u4_dot_of_motion = S::int(3) * u3_sq_cos_theta2 + u4_dot_of_u4_u5_u5_dot_7
            - u4_dot_of_u4_u5_u5_dot_6;
        // u4_dot_of_motion_2 = sin_theta1*u4_dot_of_motion
        let u4_dot_of_motion_2 = u4_dot_of_motion
            .mul_add(sin_theta1_0, sin_theta1.mul_add(u4_dot_of_motion_0, sums[56]));
        // u4_dot_of_u4_u5_u5_dot_8 = u4_dot_of_u4_u5_u5_dot*cos_theta1_sq
        let u4_dot_of_u4_u5_u5_dot_8 = u4_dot_of_u4_u5_u5_dot
            .mul_add(
                cos_theta1_sq_0,
                cos_theta1_sq.mul_add(u4_dot_of_u4_u5_u5_dot_0, sums[57]),
            );
        // u4_dot_of_u4_u5_u5_dot_9 = 3*u5_sq_sin_theta3 + 3/2*u4_dot_of_u3_u4_u5_2 -
        //   u4_dot_of_u4_u5_u5_dot_8
        let u4_dot_of_u4_u5_u5_dot_9 = u4_dot_of_u3_u4_u5_2
            .mul_add(S::ratio(3, 2), S::int(3) * u5_sq_sin_theta3) - u4_dot_of_u4_u5_u5_dot_8;
        // u4_dot_of_u4_u5_u5_dot_10 = cos_theta2*u4_dot_of_u4_u5_u5_dot_9
        let u4_dot_of_u4_u5_u5_dot_10 = u4_dot_of_u4_u5_u5_dot_9
            .mul_add(
                cos_theta2_0,
                cos_theta2.mul_add(u4_dot_of_u4_u5_u5_dot_9_0, sums[58]),
            );
        // u4_dot_of_u3_u5_u5_dot = u3_sq_cos_theta1 + u5_sq_cos_theta3 - 1/2*u4_dot_of_u3_u4_u5
        let u4_dot_of_u3_u5_u5_dot = u4_dot_of_u3_u4_u5
            .mul_add(-S::ratio(1, 2), u3_sq_cos_theta1 + u5_sq_cos_theta3);
        // u4_dot_of_u3_u5_u5_dot_2 = sin_theta2*u4_dot_of_u3_u5_u5_dot
        let u4_dot_of_u3_u5_u5_dot_2 = u4_dot_of_u3_u5_u5_dot
            .mul_add(
                sin_theta2_0,
                sin_theta2.mul_add(u4_dot_of_u3_u5_u5_dot_0, sums[59]),
            );
        // u4_dot_of_motion_3 = u4_dot_of_motion_2 + u4_dot_of_u4_u5_u5_dot_10 - 3*u4_dot_of_u3_u5_u5_dot_2
        let u4_dot_of_motion_3 = -S::int(3) * u4_dot_of_u3_u5_u5_dot_2
            + u4_dot_of_u4_u5_u5_dot_10 + u4_dot_of_motion_2;
        // u4_dot_of_motion_4 = u4_dot_of_motion_3/u4_dot_of_place_4
        let u4_dot_of_motion_4 = u4_dot_of_motion_3
            .mul_add(
                over_u4_dot_of_place_4,
                -(u4_dot_of_place_4.mul_add(u4_dot_of_motion_4_0, sums[60])
                    * over_u4_dot_of_place_4),
            );
        // u3_dot_of_motion = u4_dot_of_motion_4*sin_theta2
        let u3_dot_of_motion = u4_dot_of_motion_4
            .mul_add(sin_theta2_0, sin_theta2.mul_add(u4_dot_of_motion_4_0, sums[61]));
        // u3_dot_of_motion_2 = 3*u4_sq_cos_theta2 + u5_sq_cos_theta3 - 1/2*u4_dot_of_u3_u4_u5 -
        //   3*u3_dot_of_motion
        let u3_dot_of_motion_2 = u3_dot_of_motion
            .mul_add(
                -S::int(3),
                u4_dot_of_u3_u4_u5
                    .mul_add(
                        -S::ratio(1, 2),
                        S::int(3) * u4_sq_cos_theta2 + u5_sq_cos_theta3,
                    ),
            );
        // u3_dot_of_motion_3 = sin_theta1*u3_dot_of_motion_2
        let u3_dot_of_motion_3 = u3_dot_of_motion_2
            .mul_add(sin_theta1_0, sin_theta1.mul_add(u3_dot_of_motion_2_0, sums[62]));
        // u3_dot_of_motion_4 = u4_dot_of_motion_4*cos_theta2
        let u3_dot_of_motion_4 = u4_dot_of_motion_4
            .mul_add(cos_theta2_0, cos_theta2.mul_add(u4_dot_of_motion_4_0, sums[63]));
        // u3_dot_of_motion_5 = 3*u4_sq_sin_theta2 + u5_sq_sin_theta3 + 1/2*u4_dot_of_u3_u4_u5_2 +
        //   3*u3_dot_of_motion_4
        let u3_dot_of_motion_5 = u3_dot_of_motion_4
            .mul_add(
                S::int(3),
                u4_dot_of_u3_u4_u5_2
                    .mul_add(
                        S::ratio(1, 2),
                        S::int(3) * u4_sq_sin_theta2 + u5_sq_sin_theta3,
                    ),
            );
        // u3_dot_of_motion_6 = cos_theta1*u3_dot_of_motion_5
        let u3_dot_of_motion_6 = u3_dot_of_motion_5
            .mul_add(cos_theta1_0, cos_theta1.mul_add(u3_dot_of_motion_5_0, sums[64]));
        // u3_dot_2 = -1/3*u3_dot_of_motion_3 + 1/3*u3_dot_of_motion_6
        let u3_dot_2 = u3_dot_of_motion_6
            .mul_add(S::ratio(1, 3), -S::ratio(1, 3) * u3_dot_of_motion_3);
        // u2_dot_of_motion = u3_dot_2*cos_theta1
        let u2_dot_of_motion = u3_dot_2
            .mul_add(cos_theta1_0, cos_theta1.mul_add(u3_dot_2_0, sums[65]));
        // u2_dot_of_motion_2 = 2*u3_sq_sin_theta1 + 3*u4_sq_sin_theta2 + u5_sq_sin_theta3 +
        //   1/2*u4_dot_of_u3_u4_u5_2 + 3*u3_dot_of_motion_4 - 2*u2_dot_of_motion
        let u2_dot_of_motion_2 = u2_dot_of_motion
            .mul_add(
                -S::int(2),
                u3_dot_of_motion_4
                    .mul_add(
                        S::int(3),
                        u4_dot_of_u3_u4_u5_2
                            .mul_add(
                                S::ratio(1, 2),
                                u4_sq_sin_theta2
                                    .mul_add(S::int(3), S::int(2) * u3_sq_sin_theta1)
                                    + u5_sq_sin_theta3,
                            ),
                    ),
            );
        // u1_dot_of_motion = u3_dot_2*sin_theta1
        let u1_dot_of_motion = u3_dot_2
            .mul_add(sin_theta1_0, sin_theta1.mul_add(u3_dot_2_0, sums[66]));
        // u1_dot_of_motion_2 = 2*u3_sq_cos_theta1 + 3*u4_sq_cos_theta2 + u5_sq_cos_theta3 -
        //   1/2*u4_dot_of_u3_u4_u5 - 3*u3_dot_of_motion + 2*u1_dot_of_motion
        let u1_dot_of_motion_2 = u1_dot_of_motion
            .mul_add(
                S::int(2),
                u3_dot_of_motion
                    .mul_add(
                        -S::int(3),
                        u4_dot_of_u3_u4_u5
                            .mul_add(
                                -S::ratio(1, 2),
                                u4_sq_cos_theta2
                                    .mul_add(S::int(3), S::int(2) * u3_sq_cos_theta1)
                                    + u5_sq_cos_theta3,
                            ),
                    ),
            );
        x_rate = u1;
        y_rate = u2;
        theta1_rate = u3;
        theta2_rate = u4;
        theta3_rate = u5;
        u1_rate = l_by_6 * u1_dot_of_motion_2;
        u2_rate = l_by_6 * u2_dot_of_motion_2;
        u3_rate = u3_dot_2;
        u4_rate = -u4_dot_of_motion_4;
        u5_rate = -S::ratio(1, 2) * u5_dot_of_u3_u4_u5_6;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * theta1,
                count * theta1,
                count * theta2,
                count * theta2,
                count * theta3,
                count * theta3,
                u4, cos_theta2, cos_theta3, cos_theta2, u5, cos_theta3, u3, sin_theta1, sin_theta2,
                sin_theta3, sin_theta2, cos_theta2, sin_theta2, cos_theta2, sin_theta1, sin_theta2,
                sin_theta3, cos_theta1, sin_theta1, cos_theta2, cos_theta3, sin_theta1, sin_theta1,
                u3_sq, cos_theta2, u5_dot_of_place_12, u4_sq, sin_theta2, cos_theta1, cos_theta2,
                cos_theta1, sin_theta1, cos_theta1, cos_theta2, cos_theta3, cos_theta2, cos_theta1,
                sin_theta3, u5_dot_of_place_11, cos_theta1, cos_theta1, u4_dot_of_place, cos_theta1,
                cos_theta2_sq, u5_dot_of_u3_u4_u5_6, u5_dot_of_u3_u4_u5_6, sin_theta2, cos_theta2,
                cos_theta1, u4_dot_of_u4_u5_u5_dot_3, sin_theta1, u4_dot_of_u4_u5_u5_dot,
                cos_theta2, sin_theta2, u4_dot_of_place_4, u4_dot_of_motion_4, sin_theta1,
                u4_dot_of_motion_4, cos_theta1, u3_dot_2, u3_dot_2,
            ]),
            padded([
                cos_theta1, sin_theta1, cos_theta2, sin_theta2, cos_theta3, sin_theta3, u4,
                cos_theta2, cos_theta3, u4_sq, u5, u5_sq, u3, u3_sq, u4_sq, u5_sq, sin_theta3,
                cos_theta3, u5_sq_cos_theta3, u3_sq, u5_dot_of_place_2, cos_theta2, cos_theta3,
                u5_dot_of_place_4, u5_dot_of_place_6, u5_dot_of_place, u5_dot_of_place_9,
                cos_theta1, sin_theta2, sin_theta1_sin_theta2, u5_dot_of_u3_u4, u5_sq,
                sin_theta1_sin_theta2, u3_sq_cos_theta2, u4_sq, u5_dot_of_u3_u5, u5_dot_of_u4_u5_2,
                u5_dot_of_u4_u5, u5_dot_of_u3_u4_u5, u5_dot_of_u3_u5_3, u5_dot_of_u3_u4_u5_3,
                u5_dot_of_u3_u4_3, u5_dot_of_u3_u4_5, u5_dot_of_u3_u4_7, u5_dot_of_u3_u4_u5_6,
                u3_sq, cos_theta2, sin_theta1_sin_theta2, cos_theta1, cos_theta1_sq, sin_theta3,
                cos_theta3, u4_dot_of_u4_u5_u5_dot, u4_dot_of_u4_u5_u5_dot_3,
                u4_dot_of_u4_u5_u5_dot_5, sin_theta1_sin_theta2, u4_dot_of_motion, cos_theta1_sq,
                u4_dot_of_u4_u5_u5_dot_9, u4_dot_of_u3_u5_u5_dot, u4_dot_of_motion_4, sin_theta2,
                u3_dot_of_motion_2, cos_theta2, u3_dot_of_motion_5, cos_theta1, sin_theta1,
            ]),
        ];
        count_last = count;
        theta1_last = theta1;
        theta2_last = theta2;
        theta3_last = theta3;
        u3_last = u3;
        u4_last = u4;
        u5_last = u5;
        sin_theta1_last = sin_theta1;
        cos_theta1_last = cos_theta1;
        sin_theta2_last = sin_theta2;
        cos_theta2_last = cos_theta2;
        sin_theta3_last = sin_theta3;
        cos_theta3_last = cos_theta3;
        u4_sq_last = u4_sq;
        cos_theta2_sq_last = cos_theta2_sq;
        u5_sq_last = u5_sq;
        u5_sq_cos_theta3_last = u5_sq_cos_theta3;
        u3_sq_last = u3_sq;
        u5_dot_of_place_last = u5_dot_of_place;
        u3_sq_cos_theta2_last = u3_sq_cos_theta2;
        u5_dot_of_place_2_last = u5_dot_of_place_2;
        u5_dot_of_place_4_last = u5_dot_of_place_4;
        u5_dot_of_place_6_last = u5_dot_of_place_6;
        u5_dot_of_place_9_last = u5_dot_of_place_9;
        u5_dot_of_place_11_last = u5_dot_of_place_11;
        u5_dot_of_place_12_last = u5_dot_of_place_12;
        sin_theta1_sin_theta2_last = sin_theta1_sin_theta2;
        u5_dot_of_u3_u4_last = u5_dot_of_u3_u4;
        u5_dot_of_u4_u5_last = u5_dot_of_u4_u5;
        u5_dot_of_u3_u5_last = u5_dot_of_u3_u5;
        u5_dot_of_u4_u5_2_last = u5_dot_of_u4_u5_2;
        u5_dot_of_u3_u4_3_last = u5_dot_of_u3_u4_3;
        u5_dot_of_u3_u4_u5_last = u5_dot_of_u3_u4_u5;
        u5_dot_of_u3_u5_3_last = u5_dot_of_u3_u5_3;
        u5_dot_of_u3_u4_u5_3_last = u5_dot_of_u3_u4_u5_3;
        u5_dot_of_u3_u4_5_last = u5_dot_of_u3_u4_5;
        u5_dot_of_u3_u4_7_last = u5_dot_of_u3_u4_7;
        u5_dot_of_u3_u4_u5_6_last = u5_dot_of_u3_u4_u5_6;
        u4_dot_of_place_last = u4_dot_of_place;
        cos_theta1_sq_last = cos_theta1_sq;
        u4_dot_of_place_4_last = u4_dot_of_place_4;
        u4_dot_of_u4_u5_u5_dot_last = u4_dot_of_u4_u5_u5_dot;
        u4_dot_of_u4_u5_u5_dot_3_last = u4_dot_of_u4_u5_u5_dot_3;
        u4_dot_of_u4_u5_u5_dot_5_last = u4_dot_of_u4_u5_u5_dot_5;
        u4_dot_of_motion_last = u4_dot_of_motion;
        u4_dot_of_u4_u5_u5_dot_9_last = u4_dot_of_u4_u5_u5_dot_9;
        u4_dot_of_u3_u5_u5_dot_last = u4_dot_of_u3_u5_u5_dot;
        u4_dot_of_motion_4_last = u4_dot_of_motion_4;
        u3_dot_of_motion_2_last = u3_dot_of_motion_2;
        u3_dot_of_motion_5_last = u3_dot_of_motion_5;
        u3_dot_2_last = u3_dot_2;
    }
}

/// Newton–Euler equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEuler;

impl<S: Scalar> System<S> for NewtonEuler {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 2,
            coordinates: 5,
            variables: 5,
            speeds: 5,
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
    slice.try_into().expect("a slice of the length that System states")
}
