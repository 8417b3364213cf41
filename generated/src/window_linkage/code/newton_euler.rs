//! N-window four-bar: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/window_linkage/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{
    constraint_slopes, constraints, coordinate_rates, divisors, kinetic_energy,
    potential_energy,
};

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows crank0 force crank0_frame1, crank0 force crank0_frame2, crank0 moment crank0_frame3, crank1 force crank1_frame1, crank1 force crank1_frame2, crank1 moment crank1_frame3, crank2 force crank2_frame1, crank2 force crank2_frame2, crank2 moment crank2_frame3, coupler1 force coupler1_frame1, coupler1 force coupler1_frame2, coupler1 moment coupler1_frame3, coupler2 force coupler2_frame1, coupler2 force coupler2_frame2, coupler2 moment coupler2_frame3.
///
/// 93 operations, 7 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 1],
) -> [[S; 15]; 15] {
    let Parameters { m, l, .. } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    // Sines and cosines.
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_pin2, cos_q_pin2) = q_pin2.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    // Shared terms.
    let l_halved = S::ratio(1, 2) * l;
    let m_l_halved = m * l_halved;
    let l_sq_by_12 = S::ratio(1, 12) * l * l;
    let m_l_sq_by_12 = m * l_sq_by_12;
    let m_sin_q_pin1 = m * sin_q_pin1;
    let (sin_angle, _) = (q_2 - q_ground1 + q_pin1).sin_cos();
    let m_5_1_of_place = m_sin_q_pin1 / sin_angle;
    let l_halved_m_5_1_of_place = l_halved * m_5_1_of_place;
    let m_6_1_of_place = l_sq_by_12 * m_5_1_of_place;
    let sin_q_ground1_l_halved = l_halved * sin_q_ground1;
    let cos_q_ground1_l_halved = l_halved * cos_q_ground1;
    let (sin_angle_2, _) = (q_ground1 - q_ground2 + q_pin2).sin_cos();
    let sin_angle_2_inv = S::int(1) / sin_angle_2;
    let m_8_1_of_place = m_5_1_of_place * sin_q_pin2;
    let m_8_1_of_place_2 = sin_angle_2_inv * m_8_1_of_place;
    let sin_q_ground2_l_halved = l_halved * sin_q_ground2;
    let cos_q_ground2_l_halved = l_halved * cos_q_ground2;
    // cos(q)*cos(q_pin1) - sin(q)*sin(q_pin1)
    let cos_q_plus_q_pin1 = (-sin_q).mul_add(sin_q_pin1, cos_q * cos_q_pin1);
    // cos(q)*sin(q_pin1) + sin(q)*cos(q_pin1)
    let sin_q_plus_q_pin1 = sin_q.mul_add(cos_q_pin1, cos_q * sin_q_pin1);
    // sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)
    let m_11_1_of_place = (-cos_q).mul_add(sin_q_ground1, sin_q * cos_q_ground1);
    // m_11_1_of_place/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   m_11_1_of_place*cos(q_pin1))
    let m_11_1_of_place_2 = m_11_1_of_place
        / (sin_q_pin1 * cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1)
            + m_11_1_of_place * cos_q_pin1);
    // cos(q_ground1)*cos(q_pin2) - sin(q_ground1)*sin(q_pin2)
    let m_13_4_of_place = (-sin_q_ground1)
        .mul_add(sin_q_pin2, cos_q_ground1 * cos_q_pin2);
    // cos(q_ground1)*sin(q_pin2) + sin(q_ground1)*cos(q_pin2)
    let m_13_5_of_place = sin_q_ground1.mul_add(cos_q_pin2, cos_q_ground1 * sin_q_pin2);
    // 1 + sin_angle_2_inv*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))
    let m_14_1_of_place = S::int(1)
        + sin_angle_2_inv
            * (sin_q_ground2 * (cos_q_ground1 + m_13_4_of_place)
                - cos_q_ground2 * (sin_q_ground1 + m_13_5_of_place));
    // -sin(q_ground1)
    let minus_sin_q_ground1 = -sin_q_ground1;
    // -sin(q_ground2)
    let minus_sin_q_ground2 = -sin_q_ground2;
    // -cos(q_ground1)
    let minus_cos_q_ground1 = -cos_q_ground1;
    // -cos(q_ground2)
    let minus_cos_q_ground2 = -cos_q_ground2;
    // -cos(q)
    let minus_cos_q = -cos_q;
    // -cos(q_pin1)
    let minus_cos_q_pin1 = -cos_q_pin1;
    // -cos(q_pin2)
    let minus_cos_q_pin2 = -cos_q_pin2;
    // Entries that are not zero.
    // M_1_8 = 1
    let m_1_8 = S::int(1);
    // M_1_14 = -cos(q)
    let m_1_14 = minus_cos_q;
    // M_1_15 = -sin(q)
    let m_1_15 = -sin_q;
    // M_2_1 = m*l/2
    let m_2_1 = m_l_halved;
    // M_2_9 = 1
    let m_2_9 = S::int(1);
    // M_2_14 = sin(q)
    let m_2_14 = sin_q;
    // M_2_15 = -cos(q)
    let m_2_15 = minus_cos_q;
    // M_3_1 = m*l^2/12
    let m_3_1 = m_l_sq_by_12;
    // M_3_9 = l/2
    let m_3_9 = l_halved;
    // M_3_14 = -l*sin(q)/2
    let m_3_14 = -l_halved * sin_q;
    // M_3_15 = l*cos(q)/2
    let m_3_15 = l_halved * cos_q;
    // M_4_2 = -cos(q_ground1)
    let m_4_2 = minus_cos_q_ground1;
    // M_4_3 = -sin(q_ground1)
    let m_4_3 = minus_sin_q_ground1;
    // M_4_6 = 1
    let m_4_6 = S::int(1);
    // M_4_12 = -cos(q_ground1)
    let m_4_12 = minus_cos_q_ground1;
    // M_4_13 = -sin(q_ground1)
    let m_4_13 = minus_sin_q_ground1;
    // M_5_1 = m*l*sin(q_pin1)/(2*sin(q - q_ground1 + q_pin1))
    let m_5_1 = l_halved_m_5_1_of_place;
    // M_5_2 = sin(q_ground1)
    let m_5_2 = sin_q_ground1;
    // M_5_3 = -cos(q_ground1)
    let m_5_3 = minus_cos_q_ground1;
    // M_5_7 = 1
    let m_5_7 = S::int(1);
    // M_5_12 = sin(q_ground1)
    let m_5_12 = sin_q_ground1;
    // M_5_13 = -cos(q_ground1)
    let m_5_13 = minus_cos_q_ground1;
    // M_6_1 = m*l^2*sin(q_pin1)/(12*sin(q - q_ground1 + q_pin1))
    let m_6_1 = m_6_1_of_place;
    // M_6_2 = l*sin(q_ground1)/2
    let m_6_2 = sin_q_ground1_l_halved;
    // M_6_3 = -l*cos(q_ground1)/2
    let m_6_3 = -cos_q_ground1_l_halved;
    // M_6_7 = l/2
    let m_6_7 = l_halved;
    // M_6_12 = -l*sin(q_ground1)/2
    let m_6_12 = -sin_q_ground1_l_halved;
    // M_6_13 = l*cos(q_ground1)/2
    let m_6_13 = cos_q_ground1_l_halved;
    // M_7_4 = -cos(q_ground2)
    let m_7_4 = minus_cos_q_ground2;
    // M_7_5 = -sin(q_ground2)
    let m_7_5 = minus_sin_q_ground2;
    // M_7_10 = -cos(q_ground2)
    let m_7_10 = minus_cos_q_ground2;
    // M_7_11 = -sin(q_ground2)
    let m_7_11 = minus_sin_q_ground2;
    // M_8_1 = m*l*sin(q_pin1)*sin(q_pin2)/(2*sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2))
    let m_8_1 = l_halved * m_8_1_of_place_2;
    // M_8_4 = sin(q_ground2)
    let m_8_4 = sin_q_ground2;
    // M_8_5 = -cos(q_ground2)
    let m_8_5 = minus_cos_q_ground2;
    // M_8_10 = sin(q_ground2)
    let m_8_10 = sin_q_ground2;
    // M_8_11 = -cos(q_ground2)
    let m_8_11 = minus_cos_q_ground2;
    // M_9_1 = m*l^2*sin(q_pin1)*sin(q_pin2)/(12*sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2))
    let m_9_1 = l_sq_by_12 * m_8_1_of_place_2;
    // M_9_4 = l*sin(q_ground2)/2
    let m_9_4 = sin_q_ground2_l_halved;
    // M_9_5 = -l*cos(q_ground2)/2
    let m_9_5 = -cos_q_ground2_l_halved;
    // M_9_10 = -l*sin(q_ground2)/2
    let m_9_10 = -sin_q_ground2_l_halved;
    // M_9_11 = l*cos(q_ground2)/2
    let m_9_11 = cos_q_ground2_l_halved;
    // M_10_1 = m*l*sin(q_pin1)
    let m_10_1 = l * m_sin_q_pin1;
    // M_10_2 = cos(q + q_pin1)
    let m_10_2 = cos_q_plus_q_pin1;
    // M_10_3 = sin(q + q_pin1)
    let m_10_3 = sin_q_plus_q_pin1;
    // M_10_8 = -cos(q_pin1)
    let m_10_8 = minus_cos_q_pin1;
    // M_10_9 = -sin(q_pin1)
    let m_10_9 = -sin_q_pin1;
    // M_11_1 = m*l*(2*cos(q_pin1) + (cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))/2
    let m_11_1 = m_l_halved * cos_q_pin1.mul_add(S::int(2), -m_11_1_of_place_2);
    // M_11_2 = -sin(q + q_pin1)
    let m_11_2 = -sin_q_plus_q_pin1;
    // M_11_3 = cos(q + q_pin1)
    let m_11_3 = cos_q_plus_q_pin1;
    // M_11_8 = sin(q_pin1)
    let m_11_8 = sin_q_pin1;
    // M_11_9 = -cos(q_pin1)
    let m_11_9 = minus_cos_q_pin1;
    // M_12_1 = m*l^2*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(12*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))
    let m_12_1 = -m_l_sq_by_12 * m_11_1_of_place_2;
    // M_12_2 = -l*sin(q + q_pin1)/2
    let m_12_2 = -sin_q_plus_q_pin1 * l_halved;
    // M_12_3 = l*cos(q + q_pin1)/2
    let m_12_3 = cos_q_plus_q_pin1 * l_halved;
    // M_12_8 = -l*sin(q_pin1)/2
    let m_12_8 = -l_halved * sin_q_pin1;
    // M_12_9 = l*cos(q_pin1)/2
    let m_12_9 = l_halved * cos_q_pin1;
    // M_13_1 = m*l*sin(q_pin1)*sin(q_pin2)/sin(q - q_ground1 + q_pin1)
    let m_13_1 = l * m_8_1_of_place;
    // M_13_4 = cos(q_ground1 + q_pin2)
    let m_13_4 = m_13_4_of_place;
    // M_13_5 = sin(q_ground1 + q_pin2)
    let m_13_5 = m_13_5_of_place;
    // M_13_6 = -cos(q_pin2)
    let m_13_6 = minus_cos_q_pin2;
    // M_13_7 = -sin(q_pin2)
    let m_13_7 = -sin_q_pin2;
    // M_14_1 = m*l*sin(q_pin1)*(1 + 2*cos(q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(2*sin(q - q_ground1 + q_pin1))
    let m_14_1 = l_halved_m_5_1_of_place * cos_q_pin2.mul_add(S::int(2), m_14_1_of_place);
    // M_14_4 = -sin(q_ground1 + q_pin2)
    let m_14_4 = -m_13_5_of_place;
    // M_14_5 = cos(q_ground1 + q_pin2)
    let m_14_5 = m_13_4_of_place;
    // M_14_6 = sin(q_pin2)
    let m_14_6 = sin_q_pin2;
    // M_14_7 = -cos(q_pin2)
    let m_14_7 = minus_cos_q_pin2;
    // M_15_1 = m*l^2*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(12*sin(q - q_ground1 + q_pin1))
    let m_15_1 = m_6_1_of_place * m_14_1_of_place;
    // M_15_4 = -l*sin(q_ground1 + q_pin2)/2
    let m_15_4 = -m_13_5_of_place * l_halved;
    // M_15_5 = l*cos(q_ground1 + q_pin2)/2
    let m_15_5 = m_13_4_of_place * l_halved;
    // M_15_6 = -l*sin(q_pin2)/2
    let m_15_6 = -l_halved * sin_q_pin2;
    // M_15_7 = l*cos(q_pin2)/2
    let m_15_7 = l_halved * cos_q_pin2;
    let zero = S::int(0);
    [
        [
            zero, zero, zero, zero, zero, zero, zero, m_1_8, zero, zero, zero, zero, zero, m_1_14,
            m_1_15,
        ],
        [
            m_2_1, zero, zero, zero, zero, zero, zero, zero, m_2_9, zero, zero, zero, zero, m_2_14,
            m_2_15,
        ],
        [
            m_3_1, zero, zero, zero, zero, zero, zero, zero, m_3_9, zero, zero, zero, zero, m_3_14,
            m_3_15,
        ],
        [
            zero, m_4_2, m_4_3, zero, zero, m_4_6, zero, zero, zero, zero, zero, m_4_12, m_4_13,
            zero, zero,
        ],
        [
            m_5_1, m_5_2, m_5_3, zero, zero, zero, m_5_7, zero, zero, zero, zero, m_5_12, m_5_13,
            zero, zero,
        ],
        [
            m_6_1, m_6_2, m_6_3, zero, zero, zero, m_6_7, zero, zero, zero, zero, m_6_12, m_6_13,
            zero, zero,
        ],
        [
            zero, zero, zero, m_7_4, m_7_5, zero, zero, zero, zero, m_7_10, m_7_11, zero, zero,
            zero, zero,
        ],
        [
            m_8_1, zero, zero, m_8_4, m_8_5, zero, zero, zero, zero, m_8_10, m_8_11, zero, zero,
            zero, zero,
        ],
        [
            m_9_1, zero, zero, m_9_4, m_9_5, zero, zero, zero, zero, m_9_10, m_9_11, zero, zero,
            zero, zero,
        ],
        [
            m_10_1, m_10_2, m_10_3, zero, zero, zero, zero, m_10_8, m_10_9, zero, zero, zero, zero,
            zero, zero,
        ],
        [
            m_11_1, m_11_2, m_11_3, zero, zero, zero, zero, m_11_8, m_11_9, zero, zero, zero, zero,
            zero, zero,
        ],
        [
            m_12_1, m_12_2, m_12_3, zero, zero, zero, zero, m_12_8, m_12_9, zero, zero, zero, zero,
            zero, zero,
        ],
        [
            m_13_1, zero, zero, m_13_4, m_13_5, m_13_6, m_13_7, zero, zero, zero, zero, zero, zero,
            zero, zero,
        ],
        [
            m_14_1, zero, zero, m_14_4, m_14_5, m_14_6, m_14_7, zero, zero, zero, zero, zero, zero,
            zero, zero,
        ],
        [
            m_15_1, zero, zero, m_15_4, m_15_5, m_15_6, m_15_7, zero, zero, zero, zero, zero, zero,
            zero, zero,
        ],
    ]
}

/// Right-hand side of the linear system; unknowns (u', close1_force1, close1_force2, close2_force1, close2_force2, coupler2_force_crank1_frame1, coupler2_force_crank1_frame2, coupler1_force_crank0_frame1, coupler1_force_crank0_frame2, crank2_force_n1, crank2_force_n2, crank1_force_n1, crank1_force_n2, crank0_force_n1, crank0_force_n2).
///
/// 259 operations, 7 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 1]) -> [S; 15] {
    let Parameters { m, l, g } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_pin2, cos_q_pin2) = q_pin2.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    // Shared terms.
    let m_g = m * g;
    let m_l = m * l;
    let m_l_halved = S::ratio(1, 2) * m_l;
    let u_2_sq = u_2 * u_2;
    // q - q_ground1 + q_pin1
    let f_4_of_place = q_2 - q_ground1 + q_pin1;
    let (sin_angle, cos_angle) = f_4_of_place.sin_cos();
    let sin_angle_inv = S::int(1) / sin_angle;
    let u_2_sin_angle_inv = u_2 * sin_angle_inv;
    let f_4_of_u_2 = u_2_sin_angle_inv * sin_q_pin1;
    let f_4_of_u_2_sq = f_4_of_u_2 * f_4_of_u_2;
    let g_doubled = S::int(2) * g;
    let sin_q_pin1_sin_q = sin_q * sin_q_pin1;
    // 1 + cos(q_pin1)
    let f_5_of_q_pin1 = S::int(1) + cos_q_pin1;
    let cos_q_f_5_of_q_pin1 = f_5_of_q_pin1 * cos_q;
    let sin_q_pin1_cos_q = cos_q * sin_q_pin1;
    let sin_q_f_5_of_q_pin1 = f_5_of_q_pin1 * sin_q;
    // sin(q_ground1)*(cos_q_f_5_of_q_pin1 - sin_q_pin1_sin_q) - cos(q_ground1)*(sin_q_pin1_cos_q +
    //   sin_q_f_5_of_q_pin1)
    let f_5_of_place = sin_q_ground1 * (cos_q_f_5_of_q_pin1 - sin_q_pin1_sin_q)
        - cos_q_ground1 * (sin_q_pin1_cos_q + sin_q_f_5_of_q_pin1);
    let cos_q_pin1_f_5_of_place = f_5_of_place * cos_q_pin1;
    // sin(q_pin1)*cos(q - q_ground1 + q_pin1)*(sin_angle_inv*(sin(q_pin1) - f_5_of_place) - 1) +
    //   cos_q_pin1_f_5_of_place
    let f_5_of_place_2 = sin_q_pin1 * cos_angle
        * (sin_angle_inv * (sin_q_pin1 - f_5_of_place) - S::int(1)) + cos_q_pin1_f_5_of_place;
    let u_2_sin_angle_inv_sq = u_2_sin_angle_inv * u_2_sin_angle_inv;
    let l_u_2_sin_angle_inv_sq = l * u_2_sin_angle_inv_sq;
    let m_halved = S::ratio(1, 2) * m;
    let l_m_l_by_12 = S::ratio(1, 12) * l * m_l;
    let f_6_of_u_2 = u_2_sin_angle_inv_sq * l_m_l_by_12;
    // q_ground1 - q_ground2 + q_pin2
    let f_7_of_place = q_ground1 - q_ground2 + q_pin2;
    let (sin_angle_2, cos_angle_2) = f_7_of_place.sin_cos();
    let sin_angle_2_inv = S::int(1) / sin_angle_2;
    let f_7_of_u_2 = f_4_of_u_2 * sin_angle_2_inv;
    let sin_q_pin2_f_7_of_u_2 = f_7_of_u_2 * sin_q_pin2;
    let cos_angle_sin_angle_inv = sin_angle_inv * cos_angle;
    // sin(q_ground1)*sin(q_pin2) - cos(q_ground1)*cos(q_pin2)
    let f_8_of_place = (-cos_q_ground1).mul_add(cos_q_pin2, sin_q_ground1 * sin_q_pin2);
    // cos(q_ground1) - f_8_of_place
    let f_8_of_place_2 = cos_q_ground1 - f_8_of_place;
    // cos(q_ground1)*sin(q_pin2) + sin(q_ground1)*cos(q_pin2)
    let f_8_of_place_3 = sin_q_ground1.mul_add(cos_q_pin2, cos_q_ground1 * sin_q_pin2);
    // sin(q_ground1) + f_8_of_place_3
    let f_8_of_place_4 = sin_q_ground1 + f_8_of_place_3;
    // f_8_of_place_2*sin(q_ground2) - f_8_of_place_4*cos(q_ground2)
    let f_8_of_place_5 = (-f_8_of_place_4)
        .mul_add(cos_q_ground2, f_8_of_place_2 * sin_q_ground2);
    let f_8_of_place_6 = sin_angle_2_inv * cos_angle_2;
    let f_8_of_place_7 = sin_angle_2_inv * f_8_of_place_5;
    // sin_angle_2_inv*(cos_q_pin1_f_5_of_place*sin(q_pin2) +
    //   sin(q_pin1)*(sin(q_pin2)*(sin(q_pin1)*(cos_angle_sin_angle_inv +
    //   f_8_of_place_6*(sin_angle_2_inv*(sin(q_pin2) - f_8_of_place_5) - 1)) - cos(q - q_ground1 +
    //   q_pin1)*(1 + sin_angle_inv*f_5_of_place)) + f_8_of_place_7*sin(q_pin1)*cos(q_pin2)))
    let f_8_of_place_8 = sin_angle_2_inv
        * (sin_q_pin1
            * (sin_q_pin2
                * (sin_q_pin1
                    * (cos_angle_sin_angle_inv
                        + f_8_of_place_6
                            * (sin_angle_2_inv * (sin_q_pin2 - f_8_of_place_5) - S::int(1)))
                    - cos_angle * sin_angle_inv.mul_add(f_5_of_place, S::int(1)))
                + f_8_of_place_7 * sin_q_pin1 * cos_q_pin2) + cos_q_pin1_f_5_of_place * sin_q_pin2);
    // sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)
    let f_10_of_place = (-cos_q).mul_add(sin_q_ground1, sin_q * cos_q_ground1);
    let f_10_of_u_2 = u_2_sin_angle_inv * f_5_of_place;
    // sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)
    let f_10_of_place_2 = cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1);
    // 1/(f_10_of_place*cos(q_pin1) + f_10_of_place_2*sin(q_pin1))
    let f_10_of_place_3 = S::int(1)
        / f_10_of_place_2.mul_add(sin_q_pin1, f_10_of_place * cos_q_pin1);
    let u_2_f_10_of_place_3 = u_2 * f_10_of_place_3;
    let m_l_u_2_sq = m_l * u_2_sq;
    // u - f_4_of_u_2
    let u_2_minus_f_4_of_u_2 = u_2 - f_4_of_u_2;
    let f_11_of_u_2 = f_10_of_place_2 * u_2_minus_f_4_of_u_2;
    // 1 + 2*cos(q_pin1)
    let f_12_of_q_pin1 = cos_q_pin1.mul_add(S::int(2), S::int(1));
    let sin_q_pin1_doubled = S::int(2) * sin_q_pin1;
    // f_12_of_q_pin1*cos(q_ground1) + sin_q_pin1_doubled*sin(q_ground1)
    let f_12_of_place = sin_q_pin1_doubled
        .mul_add(sin_q_ground1, f_12_of_q_pin1 * cos_q_ground1);
    // sin_q_pin1_doubled*cos(q_ground1) - f_12_of_q_pin1*sin(q_ground1)
    let f_12_of_place_2 = (-f_12_of_q_pin1)
        .mul_add(sin_q_ground1, sin_q_pin1_doubled * cos_q_ground1);
    // sin(q_pin1)*(f_12_of_q_pin1*sin(q) + sin_q_pin1_doubled*cos(q)) - cos_q_f_5_of_q_pin1
    let f_12_of_q_2_q_pin1 = sin_q_pin1 * sin_q_pin1_doubled.mul_add(cos_q, f_12_of_q_pin1 * sin_q)
        - cos_q_f_5_of_q_pin1;
    let sin_q_pin1_sq = sin_q_pin1 * sin_q_pin1;
    let f_12_of_q_pin1_2 = sin_q_pin1_doubled * cos_q_pin1;
    // f_4_of_u_2 + f_7_of_u_2*f_8_of_place_5
    let f_13_of_u_2 = f_7_of_u_2.mul_add(f_8_of_place_5, f_4_of_u_2);
    // 1 + f_8_of_place_7
    let f_13_of_place = S::int(1) + f_8_of_place_7;
    // f_4_of_u_2*cos_angle_sin_angle_inv*(f_10_of_u_2 + u_2_minus_f_4_of_u_2) -
    //   cos_q_pin1_f_5_of_place*u_2_sin_angle_inv_sq
    let f_13_of_u_2_2 = f_4_of_u_2 * cos_angle_sin_angle_inv * (f_10_of_u_2 + u_2_minus_f_4_of_u_2)
        - cos_q_pin1_f_5_of_place * u_2_sin_angle_inv_sq;
    // -m*l*f_13_of_u_2_2
    let minus_m_l_f_13_of_u_2_2 = -m * l * f_13_of_u_2_2;
    let m_l_f_4_of_u_2_sq = m_l * f_4_of_u_2_sq;
    // f_4_of_u_2*(sin_angle_2_inv*(sin(q_ground2)*(f_4_of_u_2*sin(q_ground1) + f_8_of_place_3*f_13_of_u_2)
    //   - sin_q_pin2_f_7_of_u_2*(f_8_of_place_2*cos(q_ground2) + f_8_of_place_4*sin(q_ground2)) +
    //   cos(q_ground2)*(f_4_of_u_2*cos(q_ground1) - f_8_of_place*f_13_of_u_2)) +
    //   f_8_of_place_6*f_8_of_place_7*(f_13_of_u_2 - sin_q_pin2_f_7_of_u_2)) + f_13_of_place*f_13_of_u_2_2
    let f_14_of_u_2 = f_4_of_u_2
        * (sin_angle_2_inv
            * (sin_q_ground2 * f_8_of_place_3.mul_add(f_13_of_u_2, f_4_of_u_2 * sin_q_ground1)
                - sin_q_pin2_f_7_of_u_2
                    * f_8_of_place_4
                        .mul_add(sin_q_ground2, f_8_of_place_2 * cos_q_ground2)
                + cos_q_ground2 * (-f_8_of_place).mul_add(f_13_of_u_2, f_4_of_u_2 * cos_q_ground1))
            + f_8_of_place_6 * f_8_of_place_7 * (f_13_of_u_2 - sin_q_pin2_f_7_of_u_2))
        + f_13_of_place * f_13_of_u_2_2;
    // Values.
    // f_1 = m*l*u^2/2 - m*g*sin(q)
    let f_1 = (-m_g).mul_add(sin_q, m_l_halved * u_2_sq);
    // f_2 = -m*g*cos(q)
    let f_2 = -m_g * cos_q;
    // f_4 = m*l*u^2*sin(q_pin1)^2/(2*sin(q - q_ground1 + q_pin1)^2) - m*g*sin(q_ground1)
    let f_4 = (-m_g).mul_add(sin_q_ground1, m_l_halved * f_4_of_u_2_sq);
    // f_5 = -m*(2*g*cos(q_ground1) + l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))/sin(q - q_ground1 + q_pin1)^2)/2
    let f_5 = -m_halved * f_5_of_place_2.mul_add(l_u_2_sin_angle_inv_sq, g_doubled * cos_q_ground1);
    // f_6 = -m*l^2*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) -
    //   1))/(12*sin(q - q_ground1 + q_pin1)^2)
    let f_6 = -f_5_of_place_2 * f_6_of_u_2;
    // f_7 = m*l*u^2*sin(q_pin1)^2*sin(q_pin2)^2/(2*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2
    //   + q_pin2)^2) - m*g*sin(q_ground2)
    let f_7 = (-m_g)
        .mul_add(
            sin_q_ground2,
            m_l_halved * sin_q_pin2_f_7_of_u_2 * sin_q_pin2_f_7_of_u_2,
        );
    // f_8 = -m*(2*g*cos(q_ground2) + l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/2
    let f_8 = -m_halved * l_u_2_sin_angle_inv_sq.mul_add(f_8_of_place_8, g_doubled * cos_q_ground2);
    // f_9 = -m*l^2*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(12*sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2))
    let f_9 = -f_6_of_u_2 * f_8_of_place_8;
    // f_10 = m*l*u^2*cos(q_pin1) - m*g*sin(q + q_pin1) + m*l*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(2*(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))
    let f_10 = -m_g * sin_q.mul_add(cos_q_pin1, sin_q_pin1_cos_q) + m_l_u_2_sq * cos_q_pin1
        - m_l_halved * f_10_of_place * u_2_f_10_of_place_3 * (u_2 + f_10_of_u_2);
    // f_11 = m*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/2 - m*g*cos(q + q_pin1) -
    //   m*l*u^2*sin(q_pin1)
    let f_11 = m_g * (-cos_q).mul_add(cos_q_pin1, sin_q_pin1_sin_q) - m_l_u_2_sq * sin_q_pin1
        + l * m_halved * u_2_f_10_of_place_3
            * (f_11_of_u_2
                + f_10_of_place * f_10_of_place_3
                    * ((-(u_2_sin_angle_inv * cos_q_pin1_f_5_of_place))
                        .mul_add(
                            f_10_of_place_2,
                            f_4_of_u_2 * f_5_of_place * f_10_of_place,
                        ) + f_10_of_place * u_2_minus_f_4_of_u_2 * sin_q_pin1
                        - f_11_of_u_2 * cos_q_pin1));
    // f_12 = m*l^2*u^2*(sin(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1)))))) - sin(q_pin1)^2 - cos(q)*(cos(q_ground1)*(2 - 5*sin(q_pin1)^2
    //   + 2*cos(q_pin1) + cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 + 2*cos(q_pin1))) -
    //   3*cos(q)*(1 + cos(q_pin1)) - 4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 +
    //   2*cos(q_pin1)))) - sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))) - 3*cos(q_ground1)*(cos(q_ground1)*(1
    //   + cos(q_pin1)) + sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
    //   sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) -
    //   2*sin(q)*sin(q_pin1))))))/(12*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^3)
    let f_12 = l_m_l_by_12 * f_10_of_place_3 * u_2_f_10_of_place_3 * u_2_f_10_of_place_3
        * (sin_q
            * (cos_q_ground1
                * (cos_q_ground1
                    * (-f_12_of_place).mul_add(sin_q_pin1, f_5_of_q_pin1 * sin_q_ground1)
                    + f_12_of_q_pin1_2) + sin_q_pin1_sq * sin_q_ground1) - sin_q_pin1_sq
            - cos_q
                * (cos_q_ground1
                    * (S::int(3) * cos_q_ground1
                        * (-f_5_of_q_pin1)
                            .mul_add(cos_q_ground1, f_12_of_place_2 * sin_q_pin1)
                        + S::int(2) * f_5_of_q_pin1
                        + cos_q
                            * (-S::int(4) * cos_q_ground1
                                * (sin_q_pin1
                                    * f_12_of_place_2.mul_add(cos_q, f_12_of_place * sin_q)
                                    - f_5_of_q_pin1 * f_10_of_place_2)
                                + S::int(3) * f_12_of_q_2_q_pin1) - S::int(5) * sin_q_pin1_sq)
                    + sin_q_ground1
                        * (f_12_of_q_pin1_2
                            - cos_q
                                * (sin_q_f_5_of_q_pin1
                                    + sin_q_pin1
                                        * (-sin_q_pin1_doubled)
                                            .mul_add(sin_q, f_12_of_q_pin1 * cos_q)))));
    // f_13 = m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 - m*g*sin(q_ground1 + q_pin2)
    //   + m*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(2*sin(q - q_ground1 + q_pin1)) -
    //   m*sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))
    let f_13 = (-m_g)
        .mul_add(f_8_of_place_3, m_l_halved * f_4_of_u_2 * f_13_of_u_2 * f_13_of_place)
        - minus_m_l_f_13_of_u_2_2 * sin_q_pin2 + m_l_f_4_of_u_2_sq * cos_q_pin2;
    // f_14 = m*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1) - l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1))
    //   - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 - l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))/2 - m*g*cos(q_ground1 + q_pin2) -
    //   m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 + q_pin1)^2 -
    //   m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))
    let f_14 = (-minus_m_l_f_13_of_u_2_2).mul_add(cos_q_pin2, m_g * f_8_of_place)
        - m_l_f_4_of_u_2_sq * sin_q_pin2 + l * m_halved * f_14_of_u_2;
    // f_15 = m*l^2*u^2*cos(q_pin1)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(12*sin(q - q_ground1 + q_pin1)^2) + m*l^2*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(12*sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))
    //   + m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(12*sin(q - q_ground1 + q_pin1))
    let f_15 = l_m_l_by_12 * f_14_of_u_2;
    let zero = S::int(0);
    [f_1, f_2, zero, f_4, f_5, f_6, f_7, f_8, f_9, f_10, f_11, f_12, f_13, f_14, f_15]
}

/// The accelerations (u'), solved for when this code was generated.
///
/// 322 operations, 7 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 1]) -> [S; 1] {
    let Parameters { m, l, g } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q_pin2, cos_q_pin2) = q_pin2.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)
    let d1_of_place = cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1);
    let cos_q_sin_q_ground1 = cos_q * sin_q_ground1;
    let sin_q_cos_q_ground1 = sin_q * cos_q_ground1;
    // cos_q_sin_q_ground1 - sin_q_cos_q_ground1
    let d1_of_place_2 = cos_q_sin_q_ground1 - sin_q_cos_q_ground1;
    // -d1_of_place_2
    let minus_d1_of_place_2 = -d1_of_place_2;
    // 1/(d1_of_place*sin(q_pin1) + minus_d1_of_place_2*cos(q_pin1))
    let d1_of_place_3 = S::int(1)
        / minus_d1_of_place_2.mul_add(cos_q_pin1, d1_of_place * sin_q_pin1);
    let cos_q_pin1_times_3 = S::int(3) * cos_q_pin1;
    // q_ground1 - q_ground2 + q_pin2
    let d1_of_place_4 = q_ground1 - q_ground2 + q_pin2;
    let (sin_angle, cos_angle) = d1_of_place_4.sin_cos();
    let sin_angle_inv = S::int(1) / sin_angle;
    // cos(q_ground1)*cos(q_pin2) - sin(q_ground1)*sin(q_pin2)
    let d1_of_place_5 = (-sin_q_ground1).mul_add(sin_q_pin2, cos_q_ground1 * cos_q_pin2);
    // cos(q_ground1)*sin(q_pin2) + sin(q_ground1)*cos(q_pin2)
    let d1_of_place_6 = sin_q_ground1.mul_add(cos_q_pin2, cos_q_ground1 * sin_q_pin2);
    // sin(q_ground1) + sin(q_ground1 + q_pin2)
    let d1_of_place_7 = sin_q_ground1 + d1_of_place_6;
    let d1_of_place_8 = d1_of_place_7 * cos_q_ground2;
    let d1_of_place_8_doubled = S::int(2) * d1_of_place_8;
    // cos(q_ground1) + cos(q_ground1 + q_pin2)
    let d1_of_place_9 = cos_q_ground1 + d1_of_place_5;
    let cos_q_pin2_times_3 = S::int(3) * cos_q_pin2;
    // 2 + cos_q_pin2_times_3
    let d1_of_q_pin2 = S::int(2) + cos_q_pin2_times_3;
    let d1_of_place_10 = sin_angle_inv * cos_q_ground2;
    let sin_q_pin2_sin_angle_inv = sin_angle_inv * sin_q_pin2;
    // q - q_ground1 + q_pin1
    let d1_of_place_11 = q_2 - q_ground1 + q_pin1;
    let (sin_angle_2, cos_angle_2) = d1_of_place_11.sin_cos();
    let sin_angle_2_inv = S::int(1) / sin_angle_2;
    let d1_of_place_12 = sin_angle_2_inv * sin_q_pin1;
    let m_l = m * l;
    let l_m_l = l * m_l;
    // d1 = m*l^2*(4 + (cos(q)*sin(q_ground1)*(3*cos(q_pin1) +
    //   cos(q)*sin(q_ground1)/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) - sin(q)*cos(q_ground1)*(3*cos(q_pin1)
    //   + (2*cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + sin(q_pin1)^2*(5 + 3*cos(q_pin2) +
    //   (sin(q_pin2)^2/sin(q_ground1 - q_ground2 + q_pin2) + sin(q_ground2)*(2*cos(q_ground1) +
    //   2*cos(q_ground1 + q_pin2) + 3*cos(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   (cos(q_ground1)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*cos(q_ground1
    //   + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) - cos(q_ground2)*(sin(q_ground1)*(2 + 3*cos(q_pin2)
    //   - cos(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground1 + q_pin2)*(2 - cos(q_ground2)*sin(q_ground1 + q_pin2)/sin(q_ground1 - q_ground2 +
    //   q_pin2) + 3*cos(q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2)/3
    let d1 = S::ratio(1, 3) * l_m_l
        * (S::int(4)
            + d1_of_place_3
                * (cos_q_sin_q_ground1
                    * cos_q_sin_q_ground1.mul_add(d1_of_place_3, cos_q_pin1_times_3)
                    - sin_q_cos_q_ground1
                        * (d1_of_place_3
                            * cos_q_sin_q_ground1
                                .mul_add(S::int(2), -sin_q_cos_q_ground1) + cos_q_pin1_times_3))
            + d1_of_place_12 * d1_of_place_12
                * (S::int(5) + cos_q_pin2_times_3
                    + sin_angle_inv
                        * (sin_q_ground2
                            * (sin_angle_inv
                                * (d1_of_place_5
                                    * d1_of_place_5
                                        .mul_add(sin_q_ground2, -d1_of_place_8_doubled)
                                    + cos_q_ground1
                                        * (sin_q_ground2
                                            * d1_of_place_5.mul_add(S::int(2), cos_q_ground1)
                                            - d1_of_place_8_doubled)) + d1_of_place_9 * d1_of_q_pin2)
                            - cos_q_ground2
                                * (sin_q_ground1
                                    * (d1_of_q_pin2
                                        - d1_of_place_10
                                            * d1_of_place_6.mul_add(S::int(2), sin_q_ground1))
                                    + d1_of_place_6
                                        * (-d1_of_place_6).mul_add(d1_of_place_10, d1_of_q_pin2))
                            + sin_q_pin2_sin_angle_inv * sin_q_pin2)));
    // d1_of_place_9*sin(q_ground2) - d1_of_place_8
    let u_dot_of_place = d1_of_place_9.mul_add(sin_q_ground2, -d1_of_place_8);
    let u_dot_of_place_2 = sin_angle_inv * u_dot_of_place;
    // 1 + u_dot_of_place_2
    let u_dot_of_place_3 = S::int(1) + u_dot_of_place_2;
    // cos(q)*sin(q_pin1) + sin(q)*cos(q_pin1)
    let sin_q_plus_q_pin1 = sin_q.mul_add(cos_q_pin1, cos_q * sin_q_pin1);
    // cos(q)*cos(q_pin1) - sin(q)*sin(q_pin1)
    let cos_q_plus_q_pin1 = (-sin_q).mul_add(sin_q_pin1, cos_q * cos_q_pin1);
    // cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))
    let u_dot_of_place_4 = cos_q_ground1 * (sin_q + sin_q_plus_q_pin1)
        - sin_q_ground1 * (cos_q + cos_q_plus_q_pin1);
    // -u_dot_of_place_4
    let minus_u_dot_of_place_4 = -u_dot_of_place_4;
    let u_dot_of_place_5 = minus_u_dot_of_place_4 * cos_q_pin1;
    let u_2_sin_angle_2_inv = u_2 * sin_angle_2_inv;
    let u_2_sin_angle_2_inv_sq = u_2_sin_angle_2_inv * u_2_sin_angle_2_inv;
    let u_dot_of_u_2 = u_2_sin_angle_2_inv * sin_q_pin1;
    // u - u_dot_of_u_2
    let u_2_minus_u_dot_of_u_2 = u_2 - u_dot_of_u_2;
    let u_dot_of_u_2_2 = minus_u_dot_of_place_4 * u_2_sin_angle_2_inv;
    let u_dot_of_place_6 = sin_angle_2_inv * cos_angle_2;
    // u_dot_of_place_5*u_2_sin_angle_2_inv_sq - u_dot_of_u_2*u_dot_of_place_6*(u_2_minus_u_dot_of_u_2 +
    //   u_dot_of_u_2_2)
    let u_dot_of_u_2_3 = -u_dot_of_u_2 * u_dot_of_place_6
        * (u_2_minus_u_dot_of_u_2 + u_dot_of_u_2_2) + u_dot_of_place_5 * u_2_sin_angle_2_inv_sq;
    let u_dot_of_u_2_4 = u_dot_of_place_3 * u_dot_of_u_2;
    let u_dot_of_u_2_5 = sin_q_pin2_sin_angle_inv * u_dot_of_u_2;
    let cos_angle_sin_angle_inv = sin_angle_inv * cos_angle;
    // u_dot_of_place_3*u_dot_of_u_2_3 -
    //   u_dot_of_u_2*(sin_angle_inv*(sin(q_ground2)*(u_dot_of_u_2*sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)*u_dot_of_u_2_4) + cos(q_ground2)*(u_dot_of_u_2*cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)*u_dot_of_u_2_4) - u_dot_of_u_2_5*(d1_of_place_7*sin(q_ground2) +
    //   d1_of_place_9*cos(q_ground2))) + u_dot_of_place_2*cos_angle_sin_angle_inv*(u_dot_of_u_2_4 -
    //   u_dot_of_u_2_5))
    let u_dot_of_u_2_6 = -u_dot_of_u_2
        * (sin_angle_inv
            * (sin_q_ground2 * d1_of_place_6.mul_add(u_dot_of_u_2_4, u_dot_of_u_2 * sin_q_ground1)
                + cos_q_ground2
                    * d1_of_place_5.mul_add(u_dot_of_u_2_4, u_dot_of_u_2 * cos_q_ground1)
                - u_dot_of_u_2_5
                    * d1_of_place_9
                        .mul_add(cos_q_ground2, d1_of_place_7 * sin_q_ground2))
            + u_dot_of_place_2 * cos_angle_sin_angle_inv
                * (u_dot_of_u_2_4 - u_dot_of_u_2_5)) + u_dot_of_place_3 * u_dot_of_u_2_3;
    let u_2_d1_of_place_3 = u_2 * d1_of_place_3;
    let g_doubled = S::int(2) * g;
    let m_g_doubled = m * g_doubled;
    let cos_q_pin1_doubled = S::int(2) * cos_q_pin1;
    let u_2_sq_m_l = u_2 * u_2 * m_l;
    // 1 + cos_q_pin1_doubled
    let u_dot_of_q_pin1 = S::int(1) + cos_q_pin1_doubled;
    let sin_q_pin1_doubled = S::int(2) * sin_q_pin1;
    // u_dot_of_q_pin1*cos(q_ground1) + sin_q_pin1_doubled*sin(q_ground1)
    let u_dot_of_place_7 = sin_q_pin1_doubled
        .mul_add(sin_q_ground1, u_dot_of_q_pin1 * cos_q_ground1);
    // sin_q_pin1_doubled*cos(q_ground1) - u_dot_of_q_pin1*sin(q_ground1)
    let u_dot_of_place_8 = (-u_dot_of_q_pin1)
        .mul_add(sin_q_ground1, sin_q_pin1_doubled * cos_q_ground1);
    // 1 + cos(q_pin1)
    let u_dot_of_q_pin1_2 = S::int(1) + cos_q_pin1;
    // sin(q_pin1)*(u_dot_of_q_pin1*sin(q) + sin_q_pin1_doubled*cos(q)) - u_dot_of_q_pin1_2*cos(q)
    let u_dot_of_q_2_q_pin1 = sin_q_pin1
        * sin_q_pin1_doubled.mul_add(cos_q, u_dot_of_q_pin1 * sin_q) - u_dot_of_q_pin1_2 * cos_q;
    let sin_q_pin1_sq = sin_q_pin1 * sin_q_pin1;
    let u_dot_of_q_pin1_3 = sin_q_pin1_doubled * cos_q_pin1;
    let u_dot_of_place_9 = minus_d1_of_place_2 * d1_of_place_3;
    // sin(q_pin1)*cos(q - q_ground1 + q_pin1)*(sin_angle_2_inv*(sin(q_pin1) + u_dot_of_place_4) - 1) +
    //   u_dot_of_place_5
    let u_dot_of_place_10 = sin_q_pin1 * cos_angle_2
        * (sin_angle_2_inv * (sin_q_pin1 + u_dot_of_place_4) - S::int(1)) + u_dot_of_place_5;
    // sin_angle_inv*(u_dot_of_place_5*sin(q_pin2) + sin(q_pin1)*(u_dot_of_place_2*sin(q_pin1)*cos(q_pin2)
    //   + sin(q_pin2)*(sin(q_pin1)*(u_dot_of_place_6 + cos_angle_sin_angle_inv*(sin_angle_inv*(sin(q_pin2) -
    //   u_dot_of_place) - 1)) - cos(q - q_ground1 + q_pin1)*(1 + sin_angle_2_inv*minus_u_dot_of_place_4))))
    let u_dot_of_place_11 = sin_angle_inv
        * (sin_q_pin1
            * (sin_q_pin2
                * (sin_q_pin1
                    * (u_dot_of_place_6
                        + cos_angle_sin_angle_inv
                            * (sin_angle_inv * (sin_q_pin2 - u_dot_of_place) - S::int(1)))
                    - cos_angle_2 * sin_angle_2_inv.mul_add(minus_u_dot_of_place_4, S::int(1)))
                + u_dot_of_place_2 * sin_q_pin1 * cos_q_pin2) + u_dot_of_place_5 * sin_q_pin2);
    let u_dot_of_u_2_7 = d1_of_place * u_2_minus_u_dot_of_u_2;
    let cos_q_pin2_doubled = S::int(2) * cos_q_pin2;
    let m_l_u_dot_of_u_2_3 = m * l * u_dot_of_u_2_3;
    let sin_q_pin2_doubled = S::int(2) * sin_q_pin2;
    let m_l_u_dot_of_u_2_sq = m_l * u_dot_of_u_2 * u_dot_of_u_2;
    let l_u_2_sin_angle_2_inv_sq = l * u_2_sin_angle_2_inv_sq;
    // g_doubled*cos(q_ground1) + u_dot_of_place_10*l_u_2_sin_angle_2_inv_sq
    let u_dot_of_u_2_8 = u_dot_of_place_10
        .mul_add(l_u_2_sin_angle_2_inv_sq, g_doubled * cos_q_ground1);
    // l*sin(q_pin1)*(cos_q_pin1_doubled*u_2_sq_m_l - minus_d1_of_place_2*m_l*u_2_d1_of_place_3*(u +
    //   u_dot_of_u_2_2) - sin(q + q_pin1)*m_g_doubled) - g*m_l*cos(q)
    let u_dot_of_u_2_9 = l * sin_q_pin1
        * (-minus_d1_of_place_2 * m_l * u_2_d1_of_place_3 * (u_2 + u_dot_of_u_2_2)
            + cos_q_pin1_doubled * u_2_sq_m_l - sin_q_plus_q_pin1 * m_g_doubled) - g * m_l * cos_q;
    // l*(u_dot_of_place_9 - cos_q_pin1_doubled)*(m*l*u_2_d1_of_place_3*(u_dot_of_u_2_7 +
    //   u_dot_of_place_9*(minus_d1_of_place_2*minus_u_dot_of_place_4*u_dot_of_u_2 -
    //   d1_of_place*u_dot_of_place_5*u_2_sin_angle_2_inv - d1_of_place_2*u_2_minus_u_dot_of_u_2*sin(q_pin1)
    //   - u_dot_of_u_2_7*cos(q_pin1))) - cos(q + q_pin1)*m_g_doubled - u_2_sq_m_l*sin_q_pin1_doubled) +
    //   d1_of_place_12*(l*((u_dot_of_place_3 + cos_q_pin2_doubled)*(m*l*u_dot_of_u_2_6 + cos(q_ground1 +
    //   q_pin2)*m_g_doubled + cos_q_pin2_doubled*m_l_u_dot_of_u_2_3 +
    //   sin_q_pin2_doubled*m_l_u_dot_of_u_2_sq) + sin_q_pin2_doubled*(sin(q_ground1 + q_pin2)*m_g_doubled -
    //   m_l*u_dot_of_u_2_4^2 + m_l_u_dot_of_u_2_3*sin_q_pin2_doubled -
    //   cos_q_pin2_doubled*m_l_u_dot_of_u_2_sq)) + m_l*(sin_q_pin2_sin_angle_inv*(g_doubled*cos(q_ground2) +
    //   u_dot_of_place_11*l_u_2_sin_angle_2_inv_sq) + u_dot_of_u_2_8))
    let u_dot_of_u_2_10 = l * (u_dot_of_place_9 - cos_q_pin1_doubled)
        * (m * l * u_2_d1_of_place_3
            * (u_dot_of_u_2_7
                + u_dot_of_place_9
                    * ((-(d1_of_place * u_dot_of_place_5))
                        .mul_add(
                            u_2_sin_angle_2_inv,
                            minus_d1_of_place_2 * minus_u_dot_of_place_4 * u_dot_of_u_2,
                        ) - d1_of_place_2 * u_2_minus_u_dot_of_u_2 * sin_q_pin1
                        - u_dot_of_u_2_7 * cos_q_pin1)) - cos_q_plus_q_pin1 * m_g_doubled
            - u_2_sq_m_l * sin_q_pin1_doubled)
        + d1_of_place_12
            * (l
                * ((u_dot_of_place_3 + cos_q_pin2_doubled)
                    * (d1_of_place_5.mul_add(m_g_doubled, m * l * u_dot_of_u_2_6)
                        + cos_q_pin2_doubled * m_l_u_dot_of_u_2_3
                        + sin_q_pin2_doubled * m_l_u_dot_of_u_2_sq)
                    + sin_q_pin2_doubled
                        * (d1_of_place_6
                            .mul_add(m_g_doubled, -m_l * u_dot_of_u_2_4 * u_dot_of_u_2_4)
                            + m_l_u_dot_of_u_2_3 * sin_q_pin2_doubled
                            - cos_q_pin2_doubled * m_l_u_dot_of_u_2_sq))
                + m_l
                    * (sin_q_pin2_sin_angle_inv
                        * u_dot_of_place_11
                            .mul_add(l_u_2_sin_angle_2_inv_sq, g_doubled * cos_q_ground2)
                        + u_dot_of_u_2_8));
    // u' = -(6*m*l*g*cos(q) + m*l^2*u^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 +
    //   q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q - q_ground1 + q_pin1)^3 +
    //   m*l^2*u^2*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_pin1)^2 + cos(q)*(cos(q_ground1)*(2
    //   - 5*sin(q_pin1)^2 + 2*cos(q_pin1) + cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 +
    //   2*cos(q_pin1))) - 3*cos(q)*(1 + cos(q_pin1)) -
    //   4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 +
    //   2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 + 2*cos(q_pin1)))) -
    //   sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))) - 3*cos(q_ground1)*(cos(q_ground1)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
    //   sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) - 2*sin(q)*sin(q_pin1))))) -
    //   sin(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1)))))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^4 +
    //   m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) + 3*m*l*sin(q_pin1)*(2*g*cos(q_ground1) +
    //   l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q -
    //   q_ground1 + q_pin1)^2)/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(2*g*cos(q_ground2) +
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 6*l*sin(q_pin1)*(2*m*g*sin(q + q_pin1) - 2*m*l*u^2*cos(q_pin1) +
    //   m*l*u*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + 3*(2*l*cos(q_pin1) +
    //   l*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(2*m*g*cos(q
    //   + q_pin1) - m*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) + 2*m*l*u^2*sin(q_pin1)) +
    //   6*l*sin(q_pin1)*sin(q_pin2)*(2*m*g*sin(q_ground1 + q_pin2) -
    //   2*m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 - m*l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   2*m*sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) + 3*l*sin(q_pin1)*(1 +
    //   2*cos(q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*m*g*cos(q_ground1 + q_pin2) + 2*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 +
    //   q_pin1)^2 + 2*m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))) + m*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1))/(12*d1)
    let u_dot = S::ratio(1, 12)
        * (S::int(6) * u_dot_of_u_2_9 - d1_of_place_12 * l_m_l * u_dot_of_place_3 * u_dot_of_u_2_6
            - l_m_l
                * (sin_angle_2_inv * u_2_sin_angle_2_inv * u_dot_of_u_2
                    * sin_q_pin2_sin_angle_inv
                        .mul_add(u_dot_of_place_11, u_dot_of_place_10)
                    - d1_of_place_3 * u_2_d1_of_place_3 * u_2_d1_of_place_3 * u_dot_of_place_9
                        * (sin_q_pin1_sq
                            + cos_q
                                * (cos_q_ground1
                                    * (S::int(2) + cos_q_pin1_doubled
                                        + S::int(3) * cos_q_ground1
                                            * (-u_dot_of_q_pin1_2)
                                                .mul_add(cos_q_ground1, u_dot_of_place_8 * sin_q_pin1)
                                        + cos_q
                                            * (-S::int(4) * cos_q_ground1
                                                * (sin_q_pin1
                                                    * u_dot_of_place_8.mul_add(cos_q, u_dot_of_place_7 * sin_q)
                                                    - d1_of_place * u_dot_of_q_pin1_2)
                                                + S::int(3) * u_dot_of_q_2_q_pin1)
                                        - S::int(5) * sin_q_pin1_sq)
                                    + sin_q_ground1
                                        * (u_dot_of_q_pin1_3
                                            - cos_q
                                                * (sin_q_pin1
                                                    * (-sin_q_pin1_doubled)
                                                        .mul_add(sin_q, u_dot_of_q_pin1 * cos_q)
                                                    + u_dot_of_q_pin1_2 * sin_q)))
                            - sin_q
                                * (cos_q_ground1
                                    * (cos_q_ground1
                                        * (-u_dot_of_place_7)
                                            .mul_add(sin_q_pin1, u_dot_of_q_pin1_2 * sin_q_ground1)
                                        + u_dot_of_q_pin1_3) + sin_q_pin1_sq * sin_q_ground1)))
            - S::int(3) * u_dot_of_u_2_10) / d1;
    [u_dot]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 324 operations, 7 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 1],
) -> ([S; 5], [S; 1]) {
    let Parameters { m, l, g } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q_pin2, cos_q_pin2) = q_pin2.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)
    let d1_of_place = cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1);
    let cos_q_sin_q_ground1 = cos_q * sin_q_ground1;
    let sin_q_cos_q_ground1 = sin_q * cos_q_ground1;
    // cos_q_sin_q_ground1 - sin_q_cos_q_ground1
    let d1_of_place_2 = cos_q_sin_q_ground1 - sin_q_cos_q_ground1;
    // -d1_of_place_2
    let minus_d1_of_place_2 = -d1_of_place_2;
    // 1/(d1_of_place*sin(q_pin1) + minus_d1_of_place_2*cos(q_pin1))
    let d1_of_place_3 = S::int(1)
        / minus_d1_of_place_2.mul_add(cos_q_pin1, d1_of_place * sin_q_pin1);
    let cos_q_pin1_times_3 = S::int(3) * cos_q_pin1;
    // q_ground1 - q_ground2 + q_pin2
    let d1_of_place_4 = q_ground1 - q_ground2 + q_pin2;
    let (sin_angle, cos_angle) = d1_of_place_4.sin_cos();
    let sin_angle_inv = S::int(1) / sin_angle;
    // cos(q_ground1)*cos(q_pin2) - sin(q_ground1)*sin(q_pin2)
    let d1_of_place_5 = (-sin_q_ground1).mul_add(sin_q_pin2, cos_q_ground1 * cos_q_pin2);
    // cos(q_ground1)*sin(q_pin2) + sin(q_ground1)*cos(q_pin2)
    let d1_of_place_6 = sin_q_ground1.mul_add(cos_q_pin2, cos_q_ground1 * sin_q_pin2);
    // sin(q_ground1) + sin(q_ground1 + q_pin2)
    let d1_of_place_7 = sin_q_ground1 + d1_of_place_6;
    let d1_of_place_8 = d1_of_place_7 * cos_q_ground2;
    let d1_of_place_8_doubled = S::int(2) * d1_of_place_8;
    // cos(q_ground1) + cos(q_ground1 + q_pin2)
    let d1_of_place_9 = cos_q_ground1 + d1_of_place_5;
    let cos_q_pin2_times_3 = S::int(3) * cos_q_pin2;
    // 2 + cos_q_pin2_times_3
    let d1_of_q_pin2 = S::int(2) + cos_q_pin2_times_3;
    let d1_of_place_10 = sin_angle_inv * cos_q_ground2;
    let sin_q_pin2_sin_angle_inv = sin_angle_inv * sin_q_pin2;
    // q - q_ground1 + q_pin1
    let d1_of_place_11 = q_2 - q_ground1 + q_pin1;
    let (sin_angle_2, cos_angle_2) = d1_of_place_11.sin_cos();
    let sin_angle_2_inv = S::int(1) / sin_angle_2;
    let d1_of_place_12 = sin_angle_2_inv * sin_q_pin1;
    let m_l = m * l;
    let l_m_l = l * m_l;
    // d1 = m*l^2*(4 + (cos(q)*sin(q_ground1)*(3*cos(q_pin1) +
    //   cos(q)*sin(q_ground1)/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) - sin(q)*cos(q_ground1)*(3*cos(q_pin1)
    //   + (2*cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + sin(q_pin1)^2*(5 + 3*cos(q_pin2) +
    //   (sin(q_pin2)^2/sin(q_ground1 - q_ground2 + q_pin2) + sin(q_ground2)*(2*cos(q_ground1) +
    //   2*cos(q_ground1 + q_pin2) + 3*cos(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   (cos(q_ground1)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*cos(q_ground1
    //   + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) - cos(q_ground2)*(sin(q_ground1)*(2 + 3*cos(q_pin2)
    //   - cos(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground1 + q_pin2)*(2 - cos(q_ground2)*sin(q_ground1 + q_pin2)/sin(q_ground1 - q_ground2 +
    //   q_pin2) + 3*cos(q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2)/3
    let d1 = S::ratio(1, 3) * l_m_l
        * (S::int(4)
            + d1_of_place_3
                * (cos_q_sin_q_ground1
                    * cos_q_sin_q_ground1.mul_add(d1_of_place_3, cos_q_pin1_times_3)
                    - sin_q_cos_q_ground1
                        * (d1_of_place_3
                            * cos_q_sin_q_ground1
                                .mul_add(S::int(2), -sin_q_cos_q_ground1) + cos_q_pin1_times_3))
            + d1_of_place_12 * d1_of_place_12
                * (S::int(5) + cos_q_pin2_times_3
                    + sin_angle_inv
                        * (sin_q_ground2
                            * (sin_angle_inv
                                * (d1_of_place_5
                                    * d1_of_place_5
                                        .mul_add(sin_q_ground2, -d1_of_place_8_doubled)
                                    + cos_q_ground1
                                        * (sin_q_ground2
                                            * d1_of_place_5.mul_add(S::int(2), cos_q_ground1)
                                            - d1_of_place_8_doubled)) + d1_of_place_9 * d1_of_q_pin2)
                            - cos_q_ground2
                                * (sin_q_ground1
                                    * (d1_of_q_pin2
                                        - d1_of_place_10
                                            * d1_of_place_6.mul_add(S::int(2), sin_q_ground1))
                                    + d1_of_place_6
                                        * (-d1_of_place_6).mul_add(d1_of_place_10, d1_of_q_pin2))
                            + sin_q_pin2_sin_angle_inv * sin_q_pin2)));
    // d1_of_place_9*sin(q_ground2) - d1_of_place_8
    let u_dot_of_place = d1_of_place_9.mul_add(sin_q_ground2, -d1_of_place_8);
    let u_dot_of_place_2 = sin_angle_inv * u_dot_of_place;
    // 1 + u_dot_of_place_2
    let u_dot_of_place_3 = S::int(1) + u_dot_of_place_2;
    let u_2_sin_angle_2_inv = u_2 * sin_angle_2_inv;
    let u_dot_of_u_2 = u_2_sin_angle_2_inv * sin_q_pin1;
    // u - u_dot_of_u_2
    let u_2_minus_u_dot_of_u_2 = u_2 - u_dot_of_u_2;
    // cos(q)*sin(q_pin1) + sin(q)*cos(q_pin1)
    let sin_q_plus_q_pin1 = sin_q.mul_add(cos_q_pin1, cos_q * sin_q_pin1);
    // cos(q)*cos(q_pin1) - sin(q)*sin(q_pin1)
    let cos_q_plus_q_pin1 = (-sin_q).mul_add(sin_q_pin1, cos_q * cos_q_pin1);
    // cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))
    let u_dot_of_place_4 = cos_q_ground1 * (sin_q + sin_q_plus_q_pin1)
        - sin_q_ground1 * (cos_q + cos_q_plus_q_pin1);
    // -u_dot_of_place_4
    let minus_u_dot_of_place_4 = -u_dot_of_place_4;
    let u_dot_of_u_2_2 = u_2_sin_angle_2_inv * minus_u_dot_of_place_4;
    let u_dot_of_place_5 = sin_angle_2_inv * cos_angle_2;
    let u_dot_of_u_2_3 = u_dot_of_u_2_2 * cos_q_pin1;
    // u_2_sin_angle_2_inv*u_dot_of_u_2_3 - u_dot_of_u_2*u_dot_of_place_5*(u_2_minus_u_dot_of_u_2 +
    //   u_dot_of_u_2_2)
    let u_dot_of_u_2_4 = -u_dot_of_u_2 * u_dot_of_place_5
        * (u_2_minus_u_dot_of_u_2 + u_dot_of_u_2_2) + u_2_sin_angle_2_inv * u_dot_of_u_2_3;
    let u_dot_of_u_2_5 = sin_angle_inv * u_dot_of_u_2;
    let u_dot_of_u_2_6 = u_dot_of_place * u_dot_of_u_2_5;
    // u_dot_of_u_2 + u_dot_of_u_2_6
    let u_dot_of_u_2_7 = u_dot_of_u_2 + u_dot_of_u_2_6;
    let u_dot_of_u_2_8 = u_dot_of_u_2_5 * sin_q_pin2;
    let cos_angle_sin_angle_inv = sin_angle_inv * cos_angle;
    // u_dot_of_place_3*u_dot_of_u_2_4 -
    //   u_dot_of_u_2*(sin_angle_inv*(sin(q_ground2)*(u_dot_of_u_2*sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)*u_dot_of_u_2_7) + cos(q_ground2)*(u_dot_of_u_2*cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)*u_dot_of_u_2_7) - u_dot_of_u_2_8*(d1_of_place_7*sin(q_ground2) +
    //   d1_of_place_9*cos(q_ground2))) + u_dot_of_place_2*cos_angle_sin_angle_inv*(u_dot_of_u_2_7 -
    //   u_dot_of_u_2_8))
    let u_dot_of_u_2_9 = -u_dot_of_u_2
        * (sin_angle_inv
            * (sin_q_ground2 * d1_of_place_6.mul_add(u_dot_of_u_2_7, u_dot_of_u_2 * sin_q_ground1)
                + cos_q_ground2
                    * d1_of_place_5.mul_add(u_dot_of_u_2_7, u_dot_of_u_2 * cos_q_ground1)
                - u_dot_of_u_2_8
                    * d1_of_place_9
                        .mul_add(cos_q_ground2, d1_of_place_7 * sin_q_ground2))
            + u_dot_of_place_2 * cos_angle_sin_angle_inv
                * (u_dot_of_u_2_7 - u_dot_of_u_2_8)) + u_dot_of_place_3 * u_dot_of_u_2_4;
    let u_2_d1_of_place_3 = u_2 * d1_of_place_3;
    let g_doubled = S::int(2) * g;
    let m_g_doubled = m * g_doubled;
    let cos_q_pin1_doubled = S::int(2) * cos_q_pin1;
    let u_2_sq_m_l = u_2 * u_2 * m_l;
    // 1 + cos_q_pin1_doubled
    let u_dot_of_q_pin1 = S::int(1) + cos_q_pin1_doubled;
    let sin_q_pin1_doubled = S::int(2) * sin_q_pin1;
    // u_dot_of_q_pin1*cos(q_ground1) + sin_q_pin1_doubled*sin(q_ground1)
    let u_dot_of_place_6 = sin_q_pin1_doubled
        .mul_add(sin_q_ground1, u_dot_of_q_pin1 * cos_q_ground1);
    // sin_q_pin1_doubled*cos(q_ground1) - u_dot_of_q_pin1*sin(q_ground1)
    let u_dot_of_place_7 = (-u_dot_of_q_pin1)
        .mul_add(sin_q_ground1, sin_q_pin1_doubled * cos_q_ground1);
    // 1 + cos(q_pin1)
    let u_dot_of_q_pin1_2 = S::int(1) + cos_q_pin1;
    // sin(q_pin1)*(u_dot_of_q_pin1*sin(q) + sin_q_pin1_doubled*cos(q)) - u_dot_of_q_pin1_2*cos(q)
    let u_dot_of_q_2_q_pin1 = sin_q_pin1
        * sin_q_pin1_doubled.mul_add(cos_q, u_dot_of_q_pin1 * sin_q) - u_dot_of_q_pin1_2 * cos_q;
    let sin_q_pin1_sq = sin_q_pin1 * sin_q_pin1;
    let u_dot_of_q_pin1_3 = sin_q_pin1_doubled * cos_q_pin1;
    let u_dot_of_place_8 = minus_d1_of_place_2 * d1_of_place_3;
    let u_dot_of_place_9 = minus_u_dot_of_place_4 * cos_q_pin1;
    // sin(q_pin1)*cos(q - q_ground1 + q_pin1)*(sin_angle_2_inv*(sin(q_pin1) + u_dot_of_place_4) - 1) +
    //   u_dot_of_place_9
    let u_dot_of_place_10 = sin_q_pin1 * cos_angle_2
        * (sin_angle_2_inv * (sin_q_pin1 + u_dot_of_place_4) - S::int(1)) + u_dot_of_place_9;
    // sin_angle_inv*(sin(q_pin1)*(u_dot_of_place_2*sin(q_pin1)*cos(q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(u_dot_of_place_5 + cos_angle_sin_angle_inv*(sin_angle_inv*(sin(q_pin2) -
    //   u_dot_of_place) - 1)) - cos(q - q_ground1 + q_pin1)*(1 + sin_angle_2_inv*minus_u_dot_of_place_4))) +
    //   u_dot_of_place_9*sin(q_pin2))
    let u_dot_of_place_11 = sin_angle_inv
        * (sin_q_pin1
            * (sin_q_pin2
                * (sin_q_pin1
                    * (u_dot_of_place_5
                        + cos_angle_sin_angle_inv
                            * (sin_angle_inv * (sin_q_pin2 - u_dot_of_place) - S::int(1)))
                    - cos_angle_2 * sin_angle_2_inv.mul_add(minus_u_dot_of_place_4, S::int(1)))
                + u_dot_of_place_2 * sin_q_pin1 * cos_q_pin2) + u_dot_of_place_9 * sin_q_pin2);
    let u_dot_of_u_2_10 = d1_of_place * u_2_minus_u_dot_of_u_2;
    let cos_q_pin2_doubled = S::int(2) * cos_q_pin2;
    let sin_q_pin2_doubled = S::int(2) * sin_q_pin2;
    let m_l_u_dot_of_u_2 = m_l * u_dot_of_u_2;
    let m_l_u_dot_of_u_2_4 = m * l * u_dot_of_u_2_4;
    let l_u_2_sin_angle_2_inv_sq = l * u_2_sin_angle_2_inv * u_2_sin_angle_2_inv;
    // g_doubled*cos(q_ground1) + u_dot_of_place_10*l_u_2_sin_angle_2_inv_sq
    let u_dot_of_u_2_11 = u_dot_of_place_10
        .mul_add(l_u_2_sin_angle_2_inv_sq, g_doubled * cos_q_ground1);
    // l*sin(q_pin1)*(cos_q_pin1_doubled*u_2_sq_m_l - minus_d1_of_place_2*m_l*u_2_d1_of_place_3*(u +
    //   u_dot_of_u_2_2) - sin(q + q_pin1)*m_g_doubled) - g*m_l*cos(q)
    let u_dot_of_u_2_12 = l * sin_q_pin1
        * (-minus_d1_of_place_2 * m_l * u_2_d1_of_place_3 * (u_2 + u_dot_of_u_2_2)
            + cos_q_pin1_doubled * u_2_sq_m_l - sin_q_plus_q_pin1 * m_g_doubled) - g * m_l * cos_q;
    // l*(u_dot_of_place_8 - cos_q_pin1_doubled)*(m*l*u_2_d1_of_place_3*(u_dot_of_u_2_10 +
    //   u_dot_of_place_8*(minus_d1_of_place_2*u_dot_of_u_2*minus_u_dot_of_place_4 -
    //   d1_of_place_2*u_2_minus_u_dot_of_u_2*sin(q_pin1) - d1_of_place*u_dot_of_u_2_3 -
    //   u_dot_of_u_2_10*cos(q_pin1))) - cos(q + q_pin1)*m_g_doubled - u_2_sq_m_l*sin_q_pin1_doubled) +
    //   d1_of_place_12*(l*((u_dot_of_place_3 + cos_q_pin2_doubled)*(m*l*u_dot_of_u_2_9 + cos(q_ground1 +
    //   q_pin2)*m_g_doubled + u_dot_of_u_2*sin_q_pin2_doubled*m_l_u_dot_of_u_2 +
    //   cos_q_pin2_doubled*m_l_u_dot_of_u_2_4) + sin_q_pin2_doubled*(sin(q_ground1 + q_pin2)*m_g_doubled -
    //   m_l_u_dot_of_u_2*(u_dot_of_place_3*u_dot_of_u_2_7 + u_dot_of_u_2*cos_q_pin2_doubled) +
    //   sin_q_pin2_doubled*m_l_u_dot_of_u_2_4)) + m_l*(sin_q_pin2_sin_angle_inv*(g_doubled*cos(q_ground2) +
    //   u_dot_of_place_11*l_u_2_sin_angle_2_inv_sq) + u_dot_of_u_2_11))
    let u_dot_of_u_2_13 = l * (u_dot_of_place_8 - cos_q_pin1_doubled)
        * (m * l * u_2_d1_of_place_3
            * (u_dot_of_u_2_10
                + u_dot_of_place_8
                    * ((-(d1_of_place_2 * u_2_minus_u_dot_of_u_2))
                        .mul_add(
                            sin_q_pin1,
                            minus_d1_of_place_2 * u_dot_of_u_2 * minus_u_dot_of_place_4,
                        ) - d1_of_place * u_dot_of_u_2_3 - u_dot_of_u_2_10 * cos_q_pin1))
            - cos_q_plus_q_pin1 * m_g_doubled - u_2_sq_m_l * sin_q_pin1_doubled)
        + d1_of_place_12
            * (l
                * ((u_dot_of_place_3 + cos_q_pin2_doubled)
                    * (d1_of_place_5.mul_add(m_g_doubled, m * l * u_dot_of_u_2_9)
                        + u_dot_of_u_2 * sin_q_pin2_doubled * m_l_u_dot_of_u_2
                        + cos_q_pin2_doubled * m_l_u_dot_of_u_2_4)
                    + sin_q_pin2_doubled
                        * (-m_l_u_dot_of_u_2
                            * u_dot_of_u_2
                                .mul_add(
                                    cos_q_pin2_doubled,
                                    u_dot_of_place_3 * u_dot_of_u_2_7,
                                ) + d1_of_place_6 * m_g_doubled
                            + sin_q_pin2_doubled * m_l_u_dot_of_u_2_4))
                + m_l
                    * (sin_q_pin2_sin_angle_inv
                        * u_dot_of_place_11
                            .mul_add(l_u_2_sin_angle_2_inv_sq, g_doubled * cos_q_ground2)
                        + u_dot_of_u_2_11));
    // u' = -(6*m*l*g*cos(q) + m*l^2*u^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 +
    //   q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q - q_ground1 + q_pin1)^3 +
    //   m*l^2*u^2*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_pin1)^2 + cos(q)*(cos(q_ground1)*(2
    //   - 5*sin(q_pin1)^2 + 2*cos(q_pin1) + cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 +
    //   2*cos(q_pin1))) - 3*cos(q)*(1 + cos(q_pin1)) -
    //   4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 +
    //   2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 + 2*cos(q_pin1)))) -
    //   sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))) - 3*cos(q_ground1)*(cos(q_ground1)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
    //   sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) - 2*sin(q)*sin(q_pin1))))) -
    //   sin(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1)))))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^4 +
    //   m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) + 3*m*l*sin(q_pin1)*(2*g*cos(q_ground1) +
    //   l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q -
    //   q_ground1 + q_pin1)^2)/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(2*g*cos(q_ground2) +
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 6*l*sin(q_pin1)*(2*m*g*sin(q + q_pin1) - 2*m*l*u^2*cos(q_pin1) +
    //   m*l*u*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + 3*(2*l*cos(q_pin1) +
    //   l*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(2*m*g*cos(q
    //   + q_pin1) - m*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) + 2*m*l*u^2*sin(q_pin1)) +
    //   6*l*sin(q_pin1)*sin(q_pin2)*(2*m*g*sin(q_ground1 + q_pin2) -
    //   2*m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 - m*l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   2*m*sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) + 3*l*sin(q_pin1)*(1 +
    //   2*cos(q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*m*g*cos(q_ground1 + q_pin2) + 2*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 +
    //   q_pin1)^2 + 2*m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))) + m*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1))/(12*d1)
    let u_dot = S::ratio(1, 12)
        * (S::int(6) * u_dot_of_u_2_12 - d1_of_place_12 * l_m_l * u_dot_of_place_3 * u_dot_of_u_2_9
            - l_m_l
                * (sin_angle_2_inv * u_2_sin_angle_2_inv
                    * u_dot_of_u_2_8
                        .mul_add(u_dot_of_place_11, u_dot_of_u_2 * u_dot_of_place_10)
                    - d1_of_place_3 * u_2_d1_of_place_3 * u_2_d1_of_place_3 * u_dot_of_place_8
                        * (sin_q_pin1_sq
                            + cos_q
                                * (cos_q_ground1
                                    * (S::int(2) + cos_q_pin1_doubled
                                        + S::int(3) * cos_q_ground1
                                            * (-u_dot_of_q_pin1_2)
                                                .mul_add(cos_q_ground1, u_dot_of_place_7 * sin_q_pin1)
                                        + cos_q
                                            * (-S::int(4) * cos_q_ground1
                                                * (sin_q_pin1
                                                    * u_dot_of_place_7.mul_add(cos_q, u_dot_of_place_6 * sin_q)
                                                    - d1_of_place * u_dot_of_q_pin1_2)
                                                + S::int(3) * u_dot_of_q_2_q_pin1)
                                        - S::int(5) * sin_q_pin1_sq)
                                    + sin_q_ground1
                                        * (u_dot_of_q_pin1_3
                                            - cos_q
                                                * (sin_q_pin1
                                                    * (-sin_q_pin1_doubled)
                                                        .mul_add(sin_q, u_dot_of_q_pin1 * cos_q)
                                                    + u_dot_of_q_pin1_2 * sin_q)))
                            - sin_q
                                * (cos_q_ground1
                                    * (cos_q_ground1
                                        * (-u_dot_of_place_6)
                                            .mul_add(sin_q_pin1, u_dot_of_q_pin1_2 * sin_q_ground1)
                                        + u_dot_of_q_pin1_3) + sin_q_pin1_sq * sin_q_ground1)))
            - S::int(3) * u_dot_of_u_2_13) / d1;
    // Values.
    // q' = u
    let q_dot_value = u_2;
    // q_ground1' = u*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    let q_ground1_dot_value = u_dot_of_u_2;
    // q_ground2' = u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2))
    let q_ground2_dot_value = u_dot_of_u_2_8;
    // q_pin1' = u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)
    let q_pin1_dot_value = u_dot_of_u_2_2;
    // q_pin2' = u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_dot_value = u_dot_of_u_2_6;
    (
        [
            q_dot_value, q_ground1_dot_value, q_ground2_dot_value, q_pin1_dot_value,
            q_pin2_dot_value,
        ],
        [u_dot],
    )
}

/// Jacobian of the derivative by the state; columns q, q_ground1, q_ground2, q_pin1, q_pin2, u.
///
/// 1356 operations, 7 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 1]) -> [[S; 6]; 6] {
    let Parameters { m, l, g } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q_pin2, cos_q_pin2) = q_pin2.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let cos_q_sin_q_ground1 = cos_q * sin_q_ground1;
    let sin_q_cos_q_ground1 = sin_q * cos_q_ground1;
    // sin_q_cos_q_ground1 - cos_q_sin_q_ground1
    let d1_of_place = sin_q_cos_q_ground1 - cos_q_sin_q_ground1;
    let sin_q_sin_q_ground1 = sin_q * sin_q_ground1;
    let cos_q_cos_q_ground1 = cos_q * cos_q_ground1;
    // sin_q_sin_q_ground1 + cos_q_cos_q_ground1
    let d1_of_place_2 = sin_q_sin_q_ground1 + cos_q_cos_q_ground1;
    let sin_q_pin1_d1_of_place_2 = d1_of_place_2 * sin_q_pin1;
    // d1_of_place*cos(q_pin1) + sin_q_pin1_d1_of_place_2
    let d1_of_place_3 = d1_of_place.mul_add(cos_q_pin1, sin_q_pin1_d1_of_place_2);
    let d1_of_place_3_inv = S::int(1) / d1_of_place_3;
    let cos_q_pin1_times_3 = S::int(3) * cos_q_pin1;
    // cos_q_sin_q_ground1*d1_of_place_3_inv + cos_q_pin1_times_3
    let d1_of_place_4 = cos_q_sin_q_ground1
        .mul_add(d1_of_place_3_inv, cos_q_pin1_times_3);
    // sin_q_cos_q_ground1 - 2*cos_q_sin_q_ground1
    let d1_of_place_5 = (-cos_q_sin_q_ground1).mul_add(S::int(2), sin_q_cos_q_ground1);
    // cos_q_pin1_times_3 - d1_of_place_3_inv*d1_of_place_5
    let d1_of_place_6 = (-d1_of_place_3_inv).mul_add(d1_of_place_5, cos_q_pin1_times_3);
    // sin_q_cos_q_ground1*d1_of_place_6 - cos_q_sin_q_ground1*d1_of_place_4
    let d1_of_place_7 = (-cos_q_sin_q_ground1)
        .mul_add(d1_of_place_4, sin_q_cos_q_ground1 * d1_of_place_6);
    // q_ground1 - q_ground2 + q_pin2
    let d1_of_place_8 = q_ground1 - q_ground2 + q_pin2;
    let (sin_angle, cos_angle) = d1_of_place_8.sin_cos();
    let sin_angle_inv = S::int(1) / sin_angle;
    // sin(q_ground1)*sin(q_pin2) - cos(q_ground1)*cos(q_pin2)
    let d1_of_place_9 = (-cos_q_ground1).mul_add(cos_q_pin2, sin_q_ground1 * sin_q_pin2);
    // cos(q_ground1) - 2*d1_of_place_9
    let d1_of_place_10 = (-d1_of_place_9).mul_add(S::int(2), cos_q_ground1);
    // cos(q_ground1)*sin(q_pin2) + sin(q_ground1)*cos(q_pin2)
    let d1_of_place_11 = sin_q_ground1.mul_add(cos_q_pin2, cos_q_ground1 * sin_q_pin2);
    // sin(q_ground1) + d1_of_place_11
    let d1_of_place_12 = sin_q_ground1 + d1_of_place_11;
    let cos_q_ground2_doubled = S::int(2) * cos_q_ground2;
    let d1_of_place_13 = d1_of_place_12 * cos_q_ground2_doubled;
    // d1_of_place_13 - d1_of_place_10*sin(q_ground2)
    let d1_of_place_14 = (-d1_of_place_10).mul_add(sin_q_ground2, d1_of_place_13);
    let d1_of_place_15 = d1_of_place_9 * sin_q_ground2;
    // d1_of_place_13 + d1_of_place_15
    let d1_of_place_16 = d1_of_place_13 + d1_of_place_15;
    // d1_of_place_14*cos(q_ground1) - d1_of_place_9*d1_of_place_16
    let d1_of_place_17 = (-d1_of_place_9)
        .mul_add(d1_of_place_16, d1_of_place_14 * cos_q_ground1);
    let d1_of_place_18 = sin_angle_inv * d1_of_place_17;
    // cos(q_ground1) - d1_of_place_9
    let d1_of_place_19 = cos_q_ground1 - d1_of_place_9;
    let cos_q_pin2_times_3 = S::int(3) * cos_q_pin2;
    // 2 + cos_q_pin2_times_3
    let d1_of_q_pin2 = S::int(2) + cos_q_pin2_times_3;
    let d1_of_place_20 = d1_of_place_19 * d1_of_q_pin2;
    // sin(q_ground1) + 2*d1_of_place_11
    let d1_of_place_21 = d1_of_place_11.mul_add(S::int(2), sin_q_ground1);
    let d1_of_place_22 = sin_angle_inv * cos_q_ground2;
    // d1_of_q_pin2 - d1_of_place_21*d1_of_place_22
    let d1_of_place_23 = (-d1_of_place_21).mul_add(d1_of_place_22, d1_of_q_pin2);
    // d1_of_q_pin2 - d1_of_place_11*d1_of_place_22
    let d1_of_place_24 = (-d1_of_place_11).mul_add(d1_of_place_22, d1_of_q_pin2);
    let sin_q_pin2_sin_angle_inv = sin_angle_inv * sin_q_pin2;
    // sin(q_ground2)*(d1_of_place_20 - d1_of_place_18) - cos(q_ground2)*(d1_of_place_23*sin(q_ground1) +
    //   d1_of_place_11*d1_of_place_24) + sin_q_pin2_sin_angle_inv*sin(q_pin2)
    let d1_of_place_25 = sin_q_ground2 * (d1_of_place_20 - d1_of_place_18)
        - cos_q_ground2 * d1_of_place_11.mul_add(d1_of_place_24, d1_of_place_23 * sin_q_ground1)
        + sin_q_pin2_sin_angle_inv * sin_q_pin2;
    // 5 + cos_q_pin2_times_3 + sin_angle_inv*d1_of_place_25
    let d1_of_place_26 = sin_angle_inv
        .mul_add(d1_of_place_25, S::int(5) + cos_q_pin2_times_3);
    // q - q_ground1 + q_pin1
    let d1_of_place_27 = q_2 - q_ground1 + q_pin1;
    let (sin_angle_2, cos_angle_2) = d1_of_place_27.sin_cos();
    let sin_angle_2_inv = S::int(1) / sin_angle_2;
    let d1_of_place_28 = sin_angle_2_inv * sin_q_pin1;
    let d1_of_place_28_sq = d1_of_place_28 * d1_of_place_28;
    let d1_of_place_29 = d1_of_place_26 * d1_of_place_28_sq;
    let m_l = m * l;
    let l_m_l = l * m_l;
    let l_m_l_by_3 = S::ratio(1, 3) * l_m_l;
    // d1 = m*l^2*(4 + (cos(q)*sin(q_ground1)*(3*cos(q_pin1) +
    //   cos(q)*sin(q_ground1)/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) - sin(q)*cos(q_ground1)*(3*cos(q_pin1)
    //   + (2*cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + sin(q_pin1)^2*(5 + 3*cos(q_pin2) +
    //   (sin(q_pin2)^2/sin(q_ground1 - q_ground2 + q_pin2) + sin(q_ground2)*(2*cos(q_ground1) +
    //   2*cos(q_ground1 + q_pin2) + 3*cos(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   (cos(q_ground1)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*cos(q_ground1
    //   + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) - cos(q_ground2)*(sin(q_ground1)*(2 + 3*cos(q_pin2)
    //   - cos(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground1 + q_pin2)*(2 - cos(q_ground2)*sin(q_ground1 + q_pin2)/sin(q_ground1 - q_ground2 +
    //   q_pin2) + 3*cos(q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2)/3
    let d1 = l_m_l_by_3 * ((-d1_of_place_3_inv).mul_add(d1_of_place_7, S::int(4)) + d1_of_place_29);
    let cos_q_pin1_d1_of_place_2 = d1_of_place_2 * cos_q_pin1;
    // d1_of_place*sin(q_pin1) - cos_q_pin1_d1_of_place_2
    let d1_by_q_of_place = d1_of_place.mul_add(sin_q_pin1, -cos_q_pin1_d1_of_place_2);
    let d1_of_place_3_inv_sq = d1_of_place_3_inv * d1_of_place_3_inv;
    let d1_by_q_of_place_2 = d1_by_q_of_place * d1_of_place_3_inv_sq;
    let d1_by_q_of_place_3 = cos_q_sin_q_ground1 * d1_by_q_of_place_2;
    let d1_by_q_of_place_4 = d1_of_place_5 * d1_by_q_of_place_2;
    let d1_by_q_of_place_5 = sin_angle_2_inv * cos_angle_2;
    let d1_by_q_of_place_6 = S::int(2) * d1_by_q_of_place_5;
    // d1_of_place_7*d1_by_q_of_place_2 + d1_of_place_29*d1_by_q_of_place_6
    let d1_by_q_of_place_7 = d1_of_place_29
        .mul_add(d1_by_q_of_place_6, d1_of_place_7 * d1_by_q_of_place_2);
    // d1_by_q = -m*l^2*((sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(sin(q)*cos(q_ground1)*(3*cos(q_pin1) +
    //   (2*cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) -
    //   cos(q)*sin(q_ground1)*(3*cos(q_pin1) + cos(q)*sin(q_ground1)/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   (cos(q)*cos(q_ground1)*(3*cos(q_pin1) + (2*cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + sin(q)*sin(q_ground1)*(3*cos(q_pin1)
    //   + cos(q)*sin(q_ground1)/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) -
    //   sin(q)*cos(q_ground1)*((2*sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + (sin(q)*cos(q_ground1) -
    //   2*cos(q)*sin(q_ground1))*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) +
    //   cos(q)*sin(q_ground1)*(sin(q)*sin(q_ground1)/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   cos(q)*sin(q_ground1)*(cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) -
    //   sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)))^2))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + 2*sin(q_pin1)^2*(5 + 3*cos(q_pin2) +
    //   (sin(q_pin2)^2/sin(q_ground1 - q_ground2 + q_pin2) + sin(q_ground2)*(2*cos(q_ground1) +
    //   2*cos(q_ground1 + q_pin2) + 3*cos(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   (cos(q_ground1)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*cos(q_ground1
    //   + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) - cos(q_ground2)*(sin(q_ground1)*(2 + 3*cos(q_pin2)
    //   - cos(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground1 + q_pin2)*(2 - cos(q_ground2)*sin(q_ground1 + q_pin2)/sin(q_ground1 - q_ground2 +
    //   q_pin2) + 3*cos(q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2))/(sin(q - q_ground1 + q_pin1)^2*tan(q
    //   - q_ground1 + q_pin1)))/3
    let d1_by_q = -l_m_l_by_3
        * (d1_of_place_3_inv
            * (-cos_q_sin_q_ground1
                * (-sin_q_sin_q_ground1).mul_add(d1_of_place_3_inv, d1_by_q_of_place_3)
                + sin_q_sin_q_ground1 * d1_of_place_4 + cos_q_cos_q_ground1 * d1_of_place_6
                - sin_q_cos_q_ground1
                    * (d1_of_place_3_inv
                        * sin_q_sin_q_ground1.mul_add(S::int(2), cos_q_cos_q_ground1)
                        + d1_by_q_of_place_4)) + d1_by_q_of_place_7);
    let u_2_sin_angle_2_inv = u_2 * sin_angle_2_inv;
    let l_u_2_sin_angle_2_inv = l * u_2_sin_angle_2_inv;
    let u_dot_by_q_of_u_2 = u_2_sin_angle_2_inv * l_u_2_sin_angle_2_inv;
    let sin_q_pin1_sin_q = sin_q * sin_q_pin1;
    // 1 + cos(q_pin1)
    let u_dot_by_q_of_q_pin1 = S::int(1) + cos_q_pin1;
    let u_dot_by_q_of_q_2_q_pin1 = u_dot_by_q_of_q_pin1 * cos_q;
    // u_dot_by_q_of_q_2_q_pin1 - sin_q_pin1_sin_q
    let u_dot_by_q_of_q_2_q_pin1_2 = u_dot_by_q_of_q_2_q_pin1 - sin_q_pin1_sin_q;
    // cos(q)*sin(q_pin1) + sin(q)*cos(q_pin1)
    let u_dot_by_q_of_q_2_q_pin1_3 = sin_q.mul_add(cos_q_pin1, cos_q * sin_q_pin1);
    // sin(q) + u_dot_by_q_of_q_2_q_pin1_3
    let u_dot_by_q_of_q_2_q_pin1_4 = sin_q + u_dot_by_q_of_q_2_q_pin1_3;
    // u_dot_by_q_of_q_2_q_pin1_2*sin(q_ground1) - u_dot_by_q_of_q_2_q_pin1_4*cos(q_ground1)
    let u_dot_by_q_of_place = (-u_dot_by_q_of_q_2_q_pin1_4)
        .mul_add(cos_q_ground1, u_dot_by_q_of_q_2_q_pin1_2 * sin_q_ground1);
    // sin_angle_2_inv*(sin(q_pin1) - u_dot_by_q_of_place)
    let u_dot_by_q_of_place_2 = sin_angle_2_inv * (sin_q_pin1 - u_dot_by_q_of_place);
    // u_dot_by_q_of_place_2 - 1
    let u_dot_by_q_of_place_3 = u_dot_by_q_of_place_2 - S::int(1);
    let sin_q_pin1_cos_angle_2 = sin_q_pin1 * cos_angle_2;
    let u_dot_by_q_of_place_4 = u_dot_by_q_of_place * cos_q_pin1;
    // u_dot_by_q_of_place_3*sin_q_pin1_cos_angle_2 + u_dot_by_q_of_place_4
    let u_dot_by_q_of_place_5 = u_dot_by_q_of_place_3
        .mul_add(sin_q_pin1_cos_angle_2, u_dot_by_q_of_place_4);
    // u_dot_by_q_of_q_2_q_pin1_2*cos(q_ground1) + u_dot_by_q_of_q_2_q_pin1_4*sin(q_ground1)
    let u_dot_by_q_of_place_6 = u_dot_by_q_of_q_2_q_pin1_4
        .mul_add(sin_q_ground1, u_dot_by_q_of_q_2_q_pin1_2 * cos_q_ground1);
    let u_dot_by_q_of_place_7 = u_dot_by_q_of_place_6 * cos_q_pin1;
    let u_dot_by_q_of_place_8 = d1_by_q_of_place_5 * u_dot_by_q_of_place_2;
    let u_dot_by_q_of_place_9 = u_dot_by_q_of_place_3 * sin_q_pin1 * sin_angle_2;
    // u_dot_by_q_of_place_7 + sin_q_pin1_cos_angle_2*(u_dot_by_q_of_place_8 -
    //   sin_angle_2_inv*u_dot_by_q_of_place_6) + u_dot_by_q_of_place_9
    let u_dot_by_q_of_place_10 = u_dot_by_q_of_place_7
        + sin_q_pin1_cos_angle_2
            * (-sin_angle_2_inv).mul_add(u_dot_by_q_of_place_6, u_dot_by_q_of_place_8)
        + u_dot_by_q_of_place_9;
    // u_dot_by_q_of_u_2*(d1_by_q_of_place_6*u_dot_by_q_of_place_5 + u_dot_by_q_of_place_10)
    let u_dot_by_q_of_u_2_2 = u_dot_by_q_of_u_2
        * d1_by_q_of_place_6.mul_add(u_dot_by_q_of_place_5, u_dot_by_q_of_place_10);
    let d1_of_place_28_times_3 = S::int(3) * d1_of_place_28;
    let u_dot_by_q_of_place_11 = m_l * d1_of_place_28_times_3;
    let u_dot_by_q_of_u_2_3 = u_2_sin_angle_2_inv * sin_q_pin1;
    let u_dot_by_q_of_u_2_4 = d1_by_q_of_place_5 * u_dot_by_q_of_u_2_3;
    // d1_of_place_12*cos(q_ground2) - d1_of_place_19*sin(q_ground2)
    let u_dot_by_q_of_place_12 = (-d1_of_place_19)
        .mul_add(sin_q_ground2, d1_of_place_12 * cos_q_ground2);
    // -u_dot_by_q_of_place_12
    let u_dot_by_q_of_place_13 = -u_dot_by_q_of_place_12;
    let u_dot_by_q_of_u_2_5 = sin_angle_inv * u_dot_by_q_of_u_2_3;
    let u_dot_by_q_of_u_2_6 = u_dot_by_q_of_place_13 * u_dot_by_q_of_u_2_5;
    let u_dot_by_q_of_u_2_7 = d1_by_q_of_place_5 * u_dot_by_q_of_u_2_6;
    // u_dot_by_q_of_u_2_4 + u_dot_by_q_of_u_2_7
    let u_dot_by_q_of_u_2_8 = u_dot_by_q_of_u_2_4 + u_dot_by_q_of_u_2_7;
    let u_dot_by_q_of_u_2_9 = u_dot_by_q_of_u_2_4 * sin_q_ground1;
    let u_dot_by_q_of_u_2_10 = u_dot_by_q_of_u_2_4 * cos_q_ground1;
    // d1_of_place_12*sin(q_ground2) + d1_of_place_19*cos(q_ground2)
    let u_dot_by_q_of_place_14 = d1_of_place_19
        .mul_add(cos_q_ground2, d1_of_place_12 * sin_q_ground2);
    let u_dot_by_q_of_u_2_11 = u_dot_by_q_of_u_2_5 * sin_q_pin2;
    let u_dot_by_q_of_u_2_12 = u_dot_by_q_of_place_14 * u_dot_by_q_of_u_2_11;
    // u_dot_by_q_of_u_2_6 - u_dot_by_q_of_u_2_11
    let u_dot_by_q_of_u_2_13 = u_dot_by_q_of_u_2_6 - u_dot_by_q_of_u_2_11;
    let cos_angle_sin_angle_inv = sin_angle_inv * cos_angle;
    let u_dot_by_q_of_place_15 = sin_angle_inv * cos_angle_sin_angle_inv;
    let u_dot_by_q_of_place_16 = u_dot_by_q_of_place_13 * u_dot_by_q_of_place_15;
    // sin_angle_inv*(sin(q_ground2)*(d1_of_place_11*u_dot_by_q_of_u_2_8 + u_dot_by_q_of_u_2_9) +
    //   cos(q_ground2)*(u_dot_by_q_of_u_2_10 - d1_of_place_9*u_dot_by_q_of_u_2_8) -
    //   d1_by_q_of_place_5*u_dot_by_q_of_u_2_12) + u_dot_by_q_of_place_16*(u_dot_by_q_of_u_2_4 +
    //   d1_by_q_of_place_5*u_dot_by_q_of_u_2_13)
    let u_dot_by_q_of_u_2_14 = sin_angle_inv
        * (sin_q_ground2 * d1_of_place_11.mul_add(u_dot_by_q_of_u_2_8, u_dot_by_q_of_u_2_9)
            + cos_q_ground2 * (-d1_of_place_9).mul_add(u_dot_by_q_of_u_2_8, u_dot_by_q_of_u_2_10)
            - d1_by_q_of_place_5 * u_dot_by_q_of_u_2_12)
        + u_dot_by_q_of_place_16
            * d1_by_q_of_place_5.mul_add(u_dot_by_q_of_u_2_13, u_dot_by_q_of_u_2_4);
    let u_dot_by_q_of_u_2_15 = l_m_l * u_dot_by_q_of_u_2_3;
    let u_dot_by_q_of_place_17 = sin_angle_inv * u_dot_by_q_of_place_13;
    // 1 + u_dot_by_q_of_place_17
    let u_dot_by_q_of_place_18 = S::int(1) + u_dot_by_q_of_place_17;
    let u_dot_by_q_of_place_19 = d1_by_q_of_place_5 * u_dot_by_q_of_place;
    // u_dot_by_q_of_place_6 + u_dot_by_q_of_place_19
    let u_dot_by_q_of_place_20 = u_dot_by_q_of_place_6 + u_dot_by_q_of_place_19;
    let u_dot_by_q_of_u_2_16 = u_2_sin_angle_2_inv * u_dot_by_q_of_place_20;
    // u - u_dot_by_q_of_u_2_3
    let u_dot_by_q_of_u_2_17 = u_2 - u_dot_by_q_of_u_2_3;
    let u_dot_by_q_of_u_2_18 = u_2_sin_angle_2_inv * u_dot_by_q_of_place;
    // u_dot_by_q_of_u_2_17 + u_dot_by_q_of_u_2_18
    let u_dot_by_q_of_u_2_19 = u_dot_by_q_of_u_2_17 + u_dot_by_q_of_u_2_18;
    let u_dot_by_q_of_u_2_20 = u_2_sin_angle_2_inv * cos_q_pin1;
    // u_dot_by_q_of_u_2_18*u_dot_by_q_of_u_2_20 - u_dot_by_q_of_u_2_4*u_dot_by_q_of_u_2_19
    let u_dot_by_q_of_u_2_21 = (-u_dot_by_q_of_u_2_4)
        .mul_add(u_dot_by_q_of_u_2_19, u_dot_by_q_of_u_2_18 * u_dot_by_q_of_u_2_20);
    // u_dot_by_q_of_u_2_3*u_dot_by_q_of_u_2_19 - d1_by_q_of_place_6*u_dot_by_q_of_u_2_21
    let u_dot_by_q_of_u_2_22 = (-d1_by_q_of_place_6)
        .mul_add(u_dot_by_q_of_u_2_21, u_dot_by_q_of_u_2_3 * u_dot_by_q_of_u_2_19);
    // u_dot_by_q_of_u_2_4*(u_dot_by_q_of_u_2_4 - u_dot_by_q_of_u_2_16) - u_dot_by_q_of_u_2_22
    let u_dot_by_q_of_u_2_23 = u_dot_by_q_of_u_2_4
        * (u_dot_by_q_of_u_2_4 - u_dot_by_q_of_u_2_16) - u_dot_by_q_of_u_2_22;
    // u_dot_by_q_of_u_2_3 + u_dot_by_q_of_u_2_6
    let u_dot_by_q_of_u_2_24 = u_dot_by_q_of_u_2_3 + u_dot_by_q_of_u_2_6;
    let u_dot_by_q_of_u_2_25 = d1_of_place_11 * u_dot_by_q_of_u_2_24;
    // u_dot_by_q_of_u_2_3*sin(q_ground1) + u_dot_by_q_of_u_2_25
    let u_dot_by_q_of_u_2_26 = u_dot_by_q_of_u_2_3
        .mul_add(sin_q_ground1, u_dot_by_q_of_u_2_25);
    let u_dot_by_q_of_u_2_27 = d1_of_place_9 * u_dot_by_q_of_u_2_24;
    // u_dot_by_q_of_u_2_3*cos(q_ground1) - u_dot_by_q_of_u_2_27
    let u_dot_by_q_of_u_2_28 = u_dot_by_q_of_u_2_3
        .mul_add(cos_q_ground1, -u_dot_by_q_of_u_2_27);
    // u_dot_by_q_of_u_2_12 - u_dot_by_q_of_u_2_26*sin(q_ground2) - u_dot_by_q_of_u_2_28*cos(q_ground2)
    let u_dot_by_q_of_u_2_29 = (-u_dot_by_q_of_u_2_26)
        .mul_add(sin_q_ground2, u_dot_by_q_of_u_2_12) - u_dot_by_q_of_u_2_28 * cos_q_ground2;
    // u_dot_by_q_of_u_2_3 + u_dot_by_q_of_u_2_13
    let u_dot_by_q_of_u_2_30 = u_dot_by_q_of_u_2_3 + u_dot_by_q_of_u_2_13;
    let u_dot_by_q_of_u_2_31 = u_dot_by_q_of_place_16 * u_dot_by_q_of_u_2_30;
    // u_dot_by_q_of_u_2_31 - sin_angle_inv*u_dot_by_q_of_u_2_29
    let u_dot_by_q_of_u_2_32 = (-sin_angle_inv)
        .mul_add(u_dot_by_q_of_u_2_29, u_dot_by_q_of_u_2_31);
    // u_dot_by_q_of_place_18*u_dot_by_q_of_u_2_23 - u_dot_by_q_of_u_2_4*u_dot_by_q_of_u_2_32
    let u_dot_by_q_of_u_2_33 = (-u_dot_by_q_of_u_2_4)
        .mul_add(u_dot_by_q_of_u_2_32, u_dot_by_q_of_place_18 * u_dot_by_q_of_u_2_23);
    let u_dot_by_q_of_u_2_34 = l_m_l * u_2_sin_angle_2_inv;
    let u_dot_by_q_of_u_2_35 = u_dot_by_q_of_place_18 * u_dot_by_q_of_u_2_34;
    // l_m_l*u_dot_by_q_of_u_2_33 + u_dot_by_q_of_place_6*u_dot_by_q_of_u_2_20*u_dot_by_q_of_u_2_35
    let u_dot_by_q_of_u_2_36 = (u_dot_by_q_of_place_6 * u_dot_by_q_of_u_2_20)
        .mul_add(u_dot_by_q_of_u_2_35, l_m_l * u_dot_by_q_of_u_2_33);
    let u_dot_by_q_of_place_21 = d1_of_place_28 * u_dot_by_q_of_place_18;
    let m_l_u_dot_by_q_of_u_2_3 = m_l * u_dot_by_q_of_u_2_3;
    let u_dot_by_q_of_u_2_37 = u_dot_by_q_of_place_18 * m_l_u_dot_by_q_of_u_2_3;
    let u_dot_by_q_of_u_2_38 = u_dot_by_q_of_u_2 * u_dot_by_q_of_place_7;
    // l*u_dot_by_q_of_u_2_23 + u_dot_by_q_of_u_2_38
    let u_dot_by_q_of_u_2_39 = l.mul_add(u_dot_by_q_of_u_2_23, u_dot_by_q_of_u_2_38);
    let m_doubled = S::int(2) * m;
    let sin_q_pin2_m_doubled = m_doubled * sin_q_pin2;
    let u_dot_by_q_of_u_2_40 = S::int(4) * m_l_u_dot_by_q_of_u_2_3;
    // m_l*u_dot_by_q_of_place_18*u_dot_by_q_of_u_2_24 + u_dot_by_q_of_u_2_40*cos(q_pin2)
    let u_dot_by_q_of_u_2_41 = u_dot_by_q_of_u_2_40
        .mul_add(cos_q_pin2, m_l * u_dot_by_q_of_place_18 * u_dot_by_q_of_u_2_24);
    // u_dot_by_q_of_u_2_39*sin_q_pin2_m_doubled - u_dot_by_q_of_u_2_4*u_dot_by_q_of_u_2_41
    let u_dot_by_q_of_u_2_42 = (-u_dot_by_q_of_u_2_4)
        .mul_add(u_dot_by_q_of_u_2_41, u_dot_by_q_of_u_2_39 * sin_q_pin2_m_doubled);
    let l_times_6 = S::int(6) * l;
    let u_dot_by_q_of_place_22 = d1_of_place_28 * sin_q_pin2;
    let u_dot_by_q_of_place_23 = l_times_6 * u_dot_by_q_of_place_22;
    let u_dot_by_q_of_u_2_43 = d1_of_place_2 * u_dot_by_q_of_u_2_17;
    let u_dot_by_q_of_u_2_44 = d1_of_place * u_dot_by_q_of_u_2_17;
    // d1_of_place_2*u_dot_by_q_of_u_2_4 - u_dot_by_q_of_u_2_44
    let u_dot_by_q_of_u_2_45 = d1_of_place_2
        .mul_add(u_dot_by_q_of_u_2_4, -u_dot_by_q_of_u_2_44);
    let u_dot_by_q_of_u_2_46 = d1_of_place * u_dot_by_q_of_u_2_3;
    let u_dot_by_q_of_u_2_47 = d1_of_place_2 * u_dot_by_q_of_u_2_20;
    // u_dot_by_q_of_u_2_20 - u_dot_by_q_of_u_2_4
    let u_dot_by_q_of_u_2_48 = u_dot_by_q_of_u_2_20 - u_dot_by_q_of_u_2_4;
    let u_dot_by_q_of_u_2_49 = d1_of_place * u_dot_by_q_of_u_2_48;
    // u_dot_by_q_of_place*(d1_of_place_2*u_dot_by_q_of_u_2_3 + u_dot_by_q_of_u_2_49)
    let u_dot_by_q_of_u_2_50 = u_dot_by_q_of_place
        * d1_of_place_2.mul_add(u_dot_by_q_of_u_2_3, u_dot_by_q_of_u_2_49);
    let u_2_d1_of_place_3_inv_sq = u_2 * d1_of_place_3_inv_sq;
    let u_dot_by_q_of_u_2_51 = d1_of_place * u_2_d1_of_place_3_inv_sq;
    let l_u_dot_by_q_of_u_2_51 = l * u_dot_by_q_of_u_2_51;
    let l_d1_of_place_3_inv = l * d1_of_place_3_inv;
    let u_2_l_d1_of_place_3_inv = u_2 * l_d1_of_place_3_inv;
    // -u_dot_by_q_of_u_2_44
    let u_dot_by_q_of_u_2_52 = -u_dot_by_q_of_u_2_44;
    // u_dot_by_q_of_u_2_43*cos(q_pin1) + u_dot_by_q_of_place*(u_dot_by_q_of_u_2_47 - u_dot_by_q_of_u_2_46)
    //   + u_dot_by_q_of_u_2_52*sin(q_pin1)
    let u_dot_by_q_of_u_2_53 = u_dot_by_q_of_place * (u_dot_by_q_of_u_2_47 - u_dot_by_q_of_u_2_46)
        + u_dot_by_q_of_u_2_43 * cos_q_pin1 + u_dot_by_q_of_u_2_52 * sin_q_pin1;
    let u_dot_by_q_of_u_2_54 = d1_of_place_2 * u_2_d1_of_place_3_inv_sq;
    let u_dot_by_q_of_u_2_55 = S::int(2) * u_dot_by_q_of_u_2_51;
    // l*d1_by_q_of_place*(d1_of_place_3_inv*u_dot_by_q_of_u_2_53*u_dot_by_q_of_u_2_55 -
    //   u_dot_by_q_of_u_2_43*u_2_d1_of_place_3_inv_sq)
    let u_dot_by_q_of_u_2_56 = l * d1_by_q_of_place
        * (-u_dot_by_q_of_u_2_43)
            .mul_add(
                u_2_d1_of_place_3_inv_sq,
                d1_of_place_3_inv * u_dot_by_q_of_u_2_53 * u_dot_by_q_of_u_2_55,
            );
    // m*(u_dot_by_q_of_u_2_45*u_2_l_d1_of_place_3_inv -
    //   l_u_dot_by_q_of_u_2_51*(u_dot_by_q_of_u_2_45*cos(q_pin1) -
    //   sin(q_pin1)*(d1_of_place*u_dot_by_q_of_u_2_4 + u_dot_by_q_of_u_2_43) +
    //   u_dot_by_q_of_place_6*u_dot_by_q_of_u_2_46 - u_dot_by_q_of_place_20*u_dot_by_q_of_u_2_47 -
    //   u_dot_by_q_of_u_2_50) - l*u_dot_by_q_of_u_2_53*u_dot_by_q_of_u_2_54 - u_dot_by_q_of_u_2_56)
    let u_dot_by_q_of_u_2_57 = m
        * (-l_u_dot_by_q_of_u_2_51
            * (-sin_q_pin1 * d1_of_place.mul_add(u_dot_by_q_of_u_2_4, u_dot_by_q_of_u_2_43)
                + u_dot_by_q_of_u_2_45 * cos_q_pin1 + u_dot_by_q_of_place_6 * u_dot_by_q_of_u_2_46
                - u_dot_by_q_of_place_20 * u_dot_by_q_of_u_2_47 - u_dot_by_q_of_u_2_50)
            + u_dot_by_q_of_u_2_45 * u_2_l_d1_of_place_3_inv
            - l * u_dot_by_q_of_u_2_53 * u_dot_by_q_of_u_2_54 - u_dot_by_q_of_u_2_56);
    let g_m_doubled = g * m_doubled;
    let u_dot_by_q_of_place_24 = u_dot_by_q_of_q_2_q_pin1_3 * g_m_doubled;
    let cos_q_pin1_doubled = S::int(2) * cos_q_pin1;
    // l*cos_q_pin1_doubled - d1_of_place*l_d1_of_place_3_inv
    let u_dot_by_q_of_place_25 = (-d1_of_place)
        .mul_add(l_d1_of_place_3_inv, l * cos_q_pin1_doubled);
    let u_dot_by_q_of_place_26 = S::int(3) * u_dot_by_q_of_place_25;
    let u_2_m_l = u_2 * m_l;
    // u + u_dot_by_q_of_u_2_18
    let u_dot_by_q_of_u_2_58 = u_2 + u_dot_by_q_of_u_2_18;
    let m_l_u_dot_by_q_of_u_2_58 = m_l * u_dot_by_q_of_u_2_58;
    let u_dot_by_q_of_u_2_59 = d1_by_q_of_place * u_dot_by_q_of_u_2_51;
    let u_dot_by_q_of_u_2_60 = m_l_u_dot_by_q_of_u_2_58 * u_dot_by_q_of_u_2_59;
    // d1_of_place_3_inv*u_2_m_l*(d1_of_place_2*u_dot_by_q_of_u_2_58 - d1_of_place*u_dot_by_q_of_u_2_16) +
    //   u_dot_by_q_of_u_2_60
    let u_dot_by_q_of_u_2_61 = d1_of_place_3_inv * u_2_m_l
        * (-d1_of_place)
            .mul_add(u_dot_by_q_of_u_2_16, d1_of_place_2 * u_dot_by_q_of_u_2_58)
        + u_dot_by_q_of_u_2_60;
    // sin_q_pin1_sin_q - cos(q)*cos(q_pin1)
    let u_dot_by_q_of_q_2_q_pin1_5 = (-cos_q).mul_add(cos_q_pin1, sin_q_pin1_sin_q);
    let u_dot_by_q_of_place_27 = g_m_doubled * u_dot_by_q_of_q_2_q_pin1_5;
    let sin_q_pin1_l_times_6 = l_times_6 * sin_q_pin1;
    let d1_by_q_of_place_5_sq = d1_by_q_of_place_5 * d1_by_q_of_place_5;
    let u_dot_by_q_of_place_28 = sin_angle_2_inv * u_dot_by_q_of_place;
    // 1 + u_dot_by_q_of_place_28
    let u_dot_by_q_of_place_29 = S::int(1) + u_dot_by_q_of_place_28;
    let u_dot_by_q_of_place_30 = u_dot_by_q_of_place_29 * sin_angle_2;
    // sin(q_pin1)*(1 + d1_by_q_of_place_5_sq) - u_dot_by_q_of_place_30
    let u_dot_by_q_of_place_31 = sin_q_pin1 * (S::int(1) + d1_by_q_of_place_5_sq)
        - u_dot_by_q_of_place_30;
    let u_dot_by_q_of_place_32 = sin_angle_2_inv * u_dot_by_q_of_place_20 * cos_angle_2;
    let sin_q_pin1_sin_q_pin2 = sin_q_pin1 * sin_q_pin2;
    let u_dot_by_q_of_place_33 = u_dot_by_q_of_place_7 * sin_q_pin2;
    // sin_q_pin1_sin_q_pin2*(u_dot_by_q_of_place_31 - u_dot_by_q_of_place_32) + u_dot_by_q_of_place_33
    let u_dot_by_q_of_place_34 = sin_q_pin1_sin_q_pin2
        * (u_dot_by_q_of_place_31 - u_dot_by_q_of_place_32) + u_dot_by_q_of_place_33;
    let u_dot_by_q_of_u_2_62 = sin_angle_inv * u_dot_by_q_of_u_2;
    // sin(q_pin2) + u_dot_by_q_of_place_12
    let u_dot_by_q_of_place_35 = sin_q_pin2 + u_dot_by_q_of_place_12;
    let u_dot_by_q_of_place_36 = sin_angle_inv * u_dot_by_q_of_place_35;
    // cos_angle_sin_angle_inv*(u_dot_by_q_of_place_36 - 1)
    let u_dot_by_q_of_place_37 = cos_angle_sin_angle_inv * (u_dot_by_q_of_place_36 - S::int(1));
    // d1_by_q_of_place_5 + u_dot_by_q_of_place_37
    let u_dot_by_q_of_place_38 = d1_by_q_of_place_5 + u_dot_by_q_of_place_37;
    // u_dot_by_q_of_place_38*sin(q_pin1) - u_dot_by_q_of_place_29*cos(q - q_ground1 + q_pin1)
    let u_dot_by_q_of_place_39 = (-u_dot_by_q_of_place_29)
        .mul_add(cos_angle_2, u_dot_by_q_of_place_38 * sin_q_pin1);
    let sin_q_pin1_cos_q_pin2 = sin_q_pin1 * cos_q_pin2;
    // u_dot_by_q_of_place_39*sin(q_pin2) + u_dot_by_q_of_place_17*sin_q_pin1_cos_q_pin2
    let u_dot_by_q_of_place_40 = u_dot_by_q_of_place_17
        .mul_add(sin_q_pin1_cos_q_pin2, u_dot_by_q_of_place_39 * sin_q_pin2);
    // u_dot_by_q_of_place_4*sin(q_pin2) + u_dot_by_q_of_place_40*sin(q_pin1)
    let u_dot_by_q_of_place_41 = u_dot_by_q_of_place_40
        .mul_add(sin_q_pin1, u_dot_by_q_of_place_4 * sin_q_pin2);
    let u_dot_by_q_of_u_2_63 = u_dot_by_q_of_u_2_62 * u_dot_by_q_of_place_41;
    let u_dot_by_q_of_u_2_64 = d1_by_q_of_place_6 * u_dot_by_q_of_u_2_63;
    let u_dot_by_q_of_place_42 = sin_q_pin2_sin_angle_inv * u_dot_by_q_of_place_11;
    let l_u_dot_by_q_of_u_2_3 = l * u_dot_by_q_of_u_2_3;
    // l*u_dot_by_q_of_u_2_33 + u_dot_by_q_of_place_18*u_dot_by_q_of_u_2_38
    let u_dot_by_q_of_u_2_65 = u_dot_by_q_of_place_18
        .mul_add(u_dot_by_q_of_u_2_38, l * u_dot_by_q_of_u_2_33);
    let cos_q_pin2_m_doubled = m_doubled * cos_q_pin2;
    let u_dot_by_q_of_u_2_66 = u_dot_by_q_of_u_2_40 * sin_q_pin2;
    // u_dot_by_q_of_u_2_39*cos_q_pin2_m_doubled + u_dot_by_q_of_u_2_4*u_dot_by_q_of_u_2_66
    let u_dot_by_q_of_u_2_67 = u_dot_by_q_of_u_2_4
        .mul_add(u_dot_by_q_of_u_2_66, u_dot_by_q_of_u_2_39 * cos_q_pin2_m_doubled);
    let cos_q_pin2_doubled = S::int(2) * cos_q_pin2;
    // u_dot_by_q_of_place_18 + cos_q_pin2_doubled
    let u_dot_by_q_of_place_43 = u_dot_by_q_of_place_18 + cos_q_pin2_doubled;
    let l_d1_of_place_28_times_3 = l * d1_of_place_28_times_3;
    let u_dot_by_q_of_place_44 = u_dot_by_q_of_place_43 * l_d1_of_place_28_times_3;
    let u_dot_by_q_of_u_2_68 = sin_angle_2_inv * u_dot_by_q_of_u_2_34;
    let u_dot_by_q_of_u_2_69 = sin_angle_inv * u_dot_by_q_of_u_2_68;
    let u_dot_by_q_of_u_2_70 = u_dot_by_q_of_u_2_11 * u_dot_by_q_of_u_2_69;
    // 1 + cos_q_pin1_doubled
    let u_dot_by_q_of_q_pin1_2 = S::int(1) + cos_q_pin1_doubled;
    let sin_q_pin1_doubled = S::int(2) * sin_q_pin1;
    // u_dot_by_q_of_q_pin1_2*sin(q) + sin_q_pin1_doubled*cos(q)
    let u_dot_by_q_of_q_2_q_pin1_6 = sin_q_pin1_doubled
        .mul_add(cos_q, u_dot_by_q_of_q_pin1_2 * sin_q);
    let sin_q_pin1_times_3 = S::int(3) * sin_q_pin1;
    // u_dot_by_q_of_q_pin1_2*cos(q_ground1) + sin_q_pin1_doubled*sin(q_ground1)
    let u_dot_by_q_of_place_45 = sin_q_pin1_doubled
        .mul_add(sin_q_ground1, u_dot_by_q_of_q_pin1_2 * cos_q_ground1);
    // sin_q_pin1_doubled*cos(q_ground1) - u_dot_by_q_of_q_pin1_2*sin(q_ground1)
    let u_dot_by_q_of_place_46 = (-u_dot_by_q_of_q_pin1_2)
        .mul_add(sin_q_ground1, sin_q_pin1_doubled * cos_q_ground1);
    // u_dot_by_q_of_place_45*sin(q) + u_dot_by_q_of_place_46*cos(q)
    let u_dot_by_q_of_place_47 = u_dot_by_q_of_place_46
        .mul_add(cos_q, u_dot_by_q_of_place_45 * sin_q);
    // d1_of_place_2*u_dot_by_q_of_q_pin1 - u_dot_by_q_of_place_47*sin(q_pin1)
    let u_dot_by_q_of_place_48 = (-u_dot_by_q_of_place_47)
        .mul_add(sin_q_pin1, d1_of_place_2 * u_dot_by_q_of_q_pin1);
    let cos_q_ground1_times_4 = S::int(4) * cos_q_ground1;
    // 3*u_dot_by_q_of_q_2_q_pin1 - u_dot_by_q_of_q_2_q_pin1_6*sin_q_pin1_times_3 -
    //   u_dot_by_q_of_place_48*cos_q_ground1_times_4
    let u_dot_by_q_of_place_49 = (-u_dot_by_q_of_q_2_q_pin1_6)
        .mul_add(sin_q_pin1_times_3, S::int(3) * u_dot_by_q_of_q_2_q_pin1)
        - u_dot_by_q_of_place_48 * cos_q_ground1_times_4;
    let sin_q_pin1_sq = sin_q_pin1 * sin_q_pin1;
    // u_dot_by_q_of_q_pin1*cos(q_ground1) - u_dot_by_q_of_place_46*sin(q_pin1)
    let u_dot_by_q_of_place_50 = (-u_dot_by_q_of_place_46)
        .mul_add(sin_q_pin1, u_dot_by_q_of_q_pin1 * cos_q_ground1);
    let cos_q_ground1_times_3 = S::int(3) * cos_q_ground1;
    // 2 + cos_q_pin1_doubled - u_dot_by_q_of_place_49*cos(q) - 5*sin_q_pin1_sq -
    //   u_dot_by_q_of_place_50*cos_q_ground1_times_3
    let u_dot_by_q_of_place_51 = (-u_dot_by_q_of_place_49)
        .mul_add(cos_q, S::int(2) + cos_q_pin1_doubled) - S::int(5) * sin_q_pin1_sq
        - u_dot_by_q_of_place_50 * cos_q_ground1_times_3;
    // sin_q_pin1_doubled*sin(q) - u_dot_by_q_of_q_pin1_2*cos(q)
    let u_dot_by_q_of_q_2_q_pin1_7 = (-u_dot_by_q_of_q_pin1_2)
        .mul_add(cos_q, sin_q_pin1_doubled * sin_q);
    let u_dot_by_q_of_q_2_q_pin1_8 = u_dot_by_q_of_q_pin1 * sin_q;
    // u_dot_by_q_of_q_2_q_pin1_8 - u_dot_by_q_of_q_2_q_pin1_7*sin(q_pin1)
    let u_dot_by_q_of_q_2_q_pin1_9 = (-u_dot_by_q_of_q_2_q_pin1_7)
        .mul_add(sin_q_pin1, u_dot_by_q_of_q_2_q_pin1_8);
    let u_dot_by_q_of_q_pin1_3 = sin_q_pin1_doubled * cos_q_pin1;
    // u_dot_by_q_of_q_2_q_pin1_9*cos(q) - u_dot_by_q_of_q_pin1_3
    let u_dot_by_q_of_q_2_q_pin1_10 = u_dot_by_q_of_q_2_q_pin1_9
        .mul_add(cos_q, -u_dot_by_q_of_q_pin1_3);
    // u_dot_by_q_of_place_51*cos(q_ground1) - u_dot_by_q_of_q_2_q_pin1_10*sin(q_ground1)
    let u_dot_by_q_of_place_52 = (-u_dot_by_q_of_q_2_q_pin1_10)
        .mul_add(sin_q_ground1, u_dot_by_q_of_place_51 * cos_q_ground1);
    // u_dot_by_q_of_q_pin1*sin(q_ground1) - u_dot_by_q_of_place_45*sin(q_pin1)
    let u_dot_by_q_of_place_53 = (-u_dot_by_q_of_place_45)
        .mul_add(sin_q_pin1, u_dot_by_q_of_q_pin1 * sin_q_ground1);
    // u_dot_by_q_of_q_pin1_3 + u_dot_by_q_of_place_53*cos(q_ground1)
    let u_dot_by_q_of_place_54 = u_dot_by_q_of_place_53
        .mul_add(cos_q_ground1, u_dot_by_q_of_q_pin1_3);
    // sin_q_pin1_sq*sin(q_ground1) + u_dot_by_q_of_place_54*cos(q_ground1)
    let u_dot_by_q_of_place_55 = u_dot_by_q_of_place_54
        .mul_add(cos_q_ground1, sin_q_pin1_sq * sin_q_ground1);
    // d1_of_place*u_dot_by_q_of_q_pin1 + sin(q_pin1)*(u_dot_by_q_of_place_45*cos(q) -
    //   u_dot_by_q_of_place_46*sin(q))
    let u_dot_by_q_of_place_56 = sin_q_pin1
        * (-u_dot_by_q_of_place_46).mul_add(sin_q, u_dot_by_q_of_place_45 * cos_q)
        + d1_of_place * u_dot_by_q_of_q_pin1;
    // sin(q_ground1)*(cos(q)*(u_dot_by_q_of_q_2_q_pin1_6*sin(q_pin1) - u_dot_by_q_of_q_2_q_pin1) +
    //   u_dot_by_q_of_q_2_q_pin1_9*sin(q)) + cos(q_ground1)*(u_dot_by_q_of_place_49*sin(q) +
    //   cos(q)*(3*u_dot_by_q_of_q_2_q_pin1_8 - sin_q_pin1_times_3*u_dot_by_q_of_q_2_q_pin1_7 -
    //   cos_q_ground1_times_4*u_dot_by_q_of_place_56))
    let u_dot_by_q_of_place_57 = sin_q_ground1
        * (cos_q * u_dot_by_q_of_q_2_q_pin1_6.mul_add(sin_q_pin1, -u_dot_by_q_of_q_2_q_pin1)
            + u_dot_by_q_of_q_2_q_pin1_9 * sin_q)
        + cos_q_ground1
            * (cos_q
                * ((-sin_q_pin1_times_3)
                    .mul_add(
                        u_dot_by_q_of_q_2_q_pin1_7,
                        S::int(3) * u_dot_by_q_of_q_2_q_pin1_8,
                    ) - cos_q_ground1_times_4 * u_dot_by_q_of_place_56)
                + u_dot_by_q_of_place_49 * sin_q);
    let u_dot_by_q_of_u_2_71 = l_m_l * u_2_d1_of_place_3_inv_sq;
    let u_dot_by_q_of_u_2_72 = u_dot_by_q_of_u_2_51 * u_dot_by_q_of_u_2_71;
    let l_u_dot_by_q_of_u_2_21 = l * u_dot_by_q_of_u_2_21;
    let sin_q_pin2_doubled = S::int(2) * sin_q_pin2;
    let u_dot_by_q_of_u_2_73 = u_dot_by_q_of_u_2_3 * m_l_u_dot_by_q_of_u_2_3;
    let u_dot_by_q_of_place_58 = d1_of_place_9 * g_m_doubled;
    // cos_q_pin2_m_doubled*l_u_dot_by_q_of_u_2_21 + sin_q_pin2_doubled*u_dot_by_q_of_u_2_73
    let u_dot_by_q_of_u_2_74 = sin_q_pin2_doubled
        .mul_add(u_dot_by_q_of_u_2_73, cos_q_pin2_m_doubled * l_u_dot_by_q_of_u_2_21);
    // u_dot_by_q_of_u_2_74 - u_dot_by_q_of_place_58
    let u_dot_by_q_of_u_2_75 = u_dot_by_q_of_u_2_74 - u_dot_by_q_of_place_58;
    // m*(u_dot_by_q_of_place_18*l_u_dot_by_q_of_u_2_21 - u_dot_by_q_of_u_2_32*l_u_dot_by_q_of_u_2_3) +
    //   u_dot_by_q_of_u_2_75
    let u_dot_by_q_of_u_2_76 = m
        * (-u_dot_by_q_of_u_2_32)
            .mul_add(
                l_u_dot_by_q_of_u_2_3,
                u_dot_by_q_of_place_18 * l_u_dot_by_q_of_u_2_21,
            ) + u_dot_by_q_of_u_2_75;
    let g_doubled = S::int(2) * g;
    let u_dot_by_q_of_u_2_77 = u_dot_by_q_of_u_2 * u_dot_by_q_of_place_5;
    // l*u_dot_by_q_of_place_43*u_dot_by_q_of_u_2_76 + m_l*(g_doubled*cos(q_ground1) +
    //   u_dot_by_q_of_u_2_77)
    let u_dot_by_q_of_u_2_78 = m_l * g_doubled.mul_add(cos_q_ground1, u_dot_by_q_of_u_2_77)
        + l * u_dot_by_q_of_place_43 * u_dot_by_q_of_u_2_76;
    let u_dot_by_q_of_u_2_79 = l_m_l * u_dot_by_q_of_u_2_21;
    // u_dot_by_q_of_place_18*u_dot_by_q_of_u_2_79 - u_dot_by_q_of_u_2_15*u_dot_by_q_of_u_2_32
    let u_dot_by_q_of_u_2_80 = (-u_dot_by_q_of_u_2_15)
        .mul_add(u_dot_by_q_of_u_2_32, u_dot_by_q_of_place_18 * u_dot_by_q_of_u_2_79);
    // g*cos_q_ground2_doubled + u_dot_by_q_of_u_2_63
    let u_dot_by_q_of_u_2_81 = g.mul_add(cos_q_ground2_doubled, u_dot_by_q_of_u_2_63);
    let u_dot_by_q_of_place_59 = d1_of_place_11 * g_m_doubled;
    // sin_q_pin2_m_doubled*l_u_dot_by_q_of_u_2_21 - cos_q_pin2_doubled*u_dot_by_q_of_u_2_73
    let u_dot_by_q_of_u_2_82 = (-cos_q_pin2_doubled)
        .mul_add(u_dot_by_q_of_u_2_73, sin_q_pin2_m_doubled * l_u_dot_by_q_of_u_2_21);
    // u_dot_by_q_of_place_59 + u_dot_by_q_of_u_2_82
    let u_dot_by_q_of_u_2_83 = u_dot_by_q_of_place_59 + u_dot_by_q_of_u_2_82;
    // sin_angle_inv*m_l*u_dot_by_q_of_u_2_81 + 2*l*(u_dot_by_q_of_u_2_83 -
    //   u_dot_by_q_of_u_2_24*u_dot_by_q_of_u_2_37)
    let u_dot_by_q_of_u_2_84 = S::int(2) * l
        * (-u_dot_by_q_of_u_2_24).mul_add(u_dot_by_q_of_u_2_37, u_dot_by_q_of_u_2_83)
        + sin_angle_inv * m_l * u_dot_by_q_of_u_2_81;
    let u_dot_by_q_of_u_2_85 = u_dot_by_q_of_u_2_84 * sin_q_pin2;
    // u_dot_by_q_of_place_21*u_dot_by_q_of_u_2_80 + d1_of_place_28_times_3*u_dot_by_q_of_u_2_85
    let u_dot_by_q_of_u_2_86 = d1_of_place_28_times_3
        .mul_add(u_dot_by_q_of_u_2_85, u_dot_by_q_of_place_21 * u_dot_by_q_of_u_2_80);
    // d1_of_place_28_times_3*u_dot_by_q_of_u_2_78 + u_dot_by_q_of_u_2_86
    let u_dot_by_q_of_u_2_87 = d1_of_place_28_times_3
        .mul_add(u_dot_by_q_of_u_2_78, u_dot_by_q_of_u_2_86);
    // sin_q_pin1_sq + u_dot_by_q_of_place_52*cos(q) - u_dot_by_q_of_place_55*sin(q)
    let u_dot_by_q_of_place_60 = u_dot_by_q_of_place_52.mul_add(cos_q, sin_q_pin1_sq)
        - u_dot_by_q_of_place_55 * sin_q;
    let u_dot_by_q_of_u_2_88 = u_dot_by_q_of_u_2_11 * u_dot_by_q_of_place_41;
    // u_dot_by_q_of_place_5*u_dot_by_q_of_u_2_3 + sin_angle_inv*u_dot_by_q_of_u_2_88
    let u_dot_by_q_of_u_2_89 = sin_angle_inv
        .mul_add(u_dot_by_q_of_u_2_88, u_dot_by_q_of_place_5 * u_dot_by_q_of_u_2_3);
    let u_dot_by_q_of_u_2_90 = sin_angle_2_inv * u_dot_by_q_of_u_2_89;
    // d1_by_q_of_place_5*u_dot_by_q_of_u_2_87 +
    //   l_m_l*(4*d1_of_place_3_inv*u_2_d1_of_place_3_inv_sq*u_dot_by_q_of_u_2_59*u_dot_by_q_of_place_60 +
    //   3*d1_by_q_of_place_5*u_2_sin_angle_2_inv*u_dot_by_q_of_u_2_90)
    let u_dot_by_q_of_u_2_91 = l_m_l
        * (d1_by_q_of_place_5 * u_2_sin_angle_2_inv * u_dot_by_q_of_u_2_90)
            .mul_add(
                S::int(3),
                S::int(4) * d1_of_place_3_inv * u_2_d1_of_place_3_inv_sq
                    * u_dot_by_q_of_u_2_59 * u_dot_by_q_of_place_60,
            ) + d1_by_q_of_place_5 * u_dot_by_q_of_u_2_87;
    let l_d1_of_place = l * d1_of_place;
    let u_dot_by_q_of_place_61 = d1_by_q_of_place_2 * l_d1_of_place;
    let u_2_u_2_m_l = u_2 * u_2_m_l;
    // sin_q_pin1_doubled*u_2_u_2_m_l - u_dot_by_q_of_place_27
    let u_dot_by_q_of_u_2_92 = sin_q_pin1_doubled
        .mul_add(u_2_u_2_m_l, -u_dot_by_q_of_place_27);
    // m*(l_u_dot_by_q_of_u_2_51*u_dot_by_q_of_u_2_53 - u_dot_by_q_of_u_2_43*u_2_l_d1_of_place_3_inv) +
    //   u_dot_by_q_of_u_2_92
    let u_dot_by_q_of_u_2_93 = m
        * (-u_dot_by_q_of_u_2_43)
            .mul_add(
                u_2_l_d1_of_place_3_inv,
                l_u_dot_by_q_of_u_2_51 * u_dot_by_q_of_u_2_53,
            ) + u_dot_by_q_of_u_2_92;
    let u_dot_by_q_of_u_2_94 = S::int(3) * u_dot_by_q_of_u_2_93;
    let u_dot_by_q_of_u_2_95 = u_dot_by_q_of_u_2_3 * u_dot_by_q_of_u_2_68;
    // u_dot_by_q_of_u_2_54*u_dot_by_q_of_u_2_71*u_dot_by_q_of_place_60 +
    //   u_dot_by_q_of_u_2_94*(d1_of_place_2*l_d1_of_place_3_inv + u_dot_by_q_of_place_61)
    let u_dot_by_q_of_u_2_96 = u_dot_by_q_of_u_2_94
        * d1_of_place_2.mul_add(l_d1_of_place_3_inv, u_dot_by_q_of_place_61)
        + u_dot_by_q_of_u_2_54 * u_dot_by_q_of_u_2_71 * u_dot_by_q_of_place_60;
    // u_dot_by_q_of_place_10*u_dot_by_q_of_u_2_95 + u_dot_by_q_of_u_2_96
    let u_dot_by_q_of_u_2_97 = u_dot_by_q_of_place_10
        .mul_add(u_dot_by_q_of_u_2_95, u_dot_by_q_of_u_2_96);
    // u_dot_by_q_of_u_2_91 + u_dot_by_q_of_u_2_97
    let u_dot_by_q_of_u_2_98 = u_dot_by_q_of_u_2_91 + u_dot_by_q_of_u_2_97;
    let g_m_l_times_6 = S::int(6) * g * m_l;
    let d1_inv = S::int(1) / d1;
    let d1_inv_by_12 = S::ratio(1, 12) * d1_inv;
    // cos_q_pin1_doubled*u_2_u_2_m_l - u_dot_by_q_of_place_24
    let u_dot_by_q_of_u_2_99 = cos_q_pin1_doubled
        .mul_add(u_2_u_2_m_l, -u_dot_by_q_of_place_24);
    let u_dot_by_q_of_place_62 = d1_of_place * d1_of_place_3_inv;
    let u_dot_by_q_of_u_2_100 = u_2_m_l * u_dot_by_q_of_place_62;
    // u_dot_by_q_of_u_2_99 - u_dot_by_q_of_u_2_58*u_dot_by_q_of_u_2_100
    let u_dot_by_q_of_u_2_101 = (-u_dot_by_q_of_u_2_58)
        .mul_add(u_dot_by_q_of_u_2_100, u_dot_by_q_of_u_2_99);
    // d1_inv*d1_inv_by_12*(u_dot_by_q_of_u_2_87 - u_dot_by_q_of_u_2_72*u_dot_by_q_of_place_60 +
    //   u_dot_by_q_of_u_2_68*u_dot_by_q_of_u_2_89 + u_dot_by_q_of_place_26*u_dot_by_q_of_u_2_93 +
    //   g_m_l_times_6*cos(q) - sin_q_pin1_l_times_6*u_dot_by_q_of_u_2_101)
    let u_dot_by_q_of_u_2_102 = d1_inv * d1_inv_by_12
        * ((-u_dot_by_q_of_u_2_72).mul_add(u_dot_by_q_of_place_60, u_dot_by_q_of_u_2_87)
            + u_dot_by_q_of_u_2_68 * u_dot_by_q_of_u_2_89
            + u_dot_by_q_of_place_26 * u_dot_by_q_of_u_2_93 + g_m_l_times_6 * cos_q
            - sin_q_pin1_l_times_6 * u_dot_by_q_of_u_2_101);
    // u_dot_by_q = (6*m*l*g*sin(q) + 3*m*l^2*u^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 +
    //   q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/(sin(q - q_ground1 + q_pin1)^3*tan(q - q_ground1 +
    //   q_pin1)) + m*l^2*u^2*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(sin(q_pin1)^2 +
    //   cos(q)*(cos(q_ground1)*(2 - 5*sin(q_pin1)^2 + 2*cos(q_pin1) +
    //   cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 + 2*cos(q_pin1))) - 3*cos(q)*(1 +
    //   cos(q_pin1)) - 4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 +
    //   2*cos(q_pin1)))) - sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))) - 3*cos(q_ground1)*(cos(q_ground1)*(1
    //   + cos(q_pin1)) + sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
    //   sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) - 2*sin(q)*sin(q_pin1))))) -
    //   sin(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1)))))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^4 +
    //   4*m*l^2*u^2*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)) - cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(sin(q_pin1)^2
    //   + cos(q)*(cos(q_ground1)*(2 - 5*sin(q_pin1)^2 + 2*cos(q_pin1) +
    //   cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 + 2*cos(q_pin1))) - 3*cos(q)*(1 +
    //   cos(q_pin1)) - 4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 +
    //   2*cos(q_pin1)))) - sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))) - 3*cos(q_ground1)*(cos(q_ground1)*(1
    //   + cos(q_pin1)) + sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
    //   sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) - 2*sin(q)*sin(q_pin1))))) -
    //   sin(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1)))))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^5 +
    //   m*l^2*u^2*sin(q_pin1)*(sin(q_pin1)*sin(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1) + cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   cos(q_ground1)*(cos(q) + cos(q + q_pin1))) - sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) + (sin(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1)^3 + m*l^2*u^2*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q)*(cos(q_ground1)*(2 -
    //   5*sin(q_pin1)^2 + 2*cos(q_pin1) + cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 +
    //   2*cos(q_pin1))) - 3*cos(q)*(1 + cos(q_pin1)) -
    //   4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 +
    //   2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 + 2*cos(q_pin1)))) -
    //   sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))) - 3*cos(q_ground1)*(cos(q_ground1)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
    //   sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) - 2*sin(q)*sin(q_pin1))))) +
    //   cos(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1)))))) - cos(q)*(cos(q_ground1)*(sin(q)*(3*cos(q)*(1 + cos(q_pin1))
    //   + 4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 +
    //   2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 + 2*cos(q_pin1)))) -
    //   sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))) - 3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 + 2*cos(q_pin1)))) +
    //   cos(q)*(3*sin(q)*(1 + cos(q_pin1)) + 3*sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) -
    //   2*sin(q)*sin(q_pin1)) + 4*cos(q_ground1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1) -
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   sin(q_pin1)*(cos(q)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 + 2*cos(q_pin1))) +
    //   sin(q)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))))) +
    //   sin(q_ground1)*(sin(q)*(sin(q)*(1 + cos(q_pin1)) + sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) -
    //   2*sin(q)*sin(q_pin1))) + cos(q)*(sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 + 2*cos(q_pin1))) -
    //   cos(q)*(1 + cos(q_pin1))))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^4 +
    //   3*m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1))) + sin(q_pin1)*sin(q_pin2)*(sin(q_pin1)*(1 +
    //   1/tan(q - q_ground1 + q_pin1)^2) - sin(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)) - cos(q -
    //   q_ground1 + q_pin1)*((sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + (sin(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/(sin(q
    //   - q_ground1 + q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) +
    //   3*m*l*sin(q_pin1)*(2*g*cos(q_ground1) + l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 +
    //   q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q - q_ground1 + q_pin1)^2)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + 3*m*l*sin(q_pin1)*sin(q_pin2)*(2*g*cos(q_ground2) +
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) + 3*(l*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)))^2)*(2*m*g*cos(q + q_pin1) - m*(l*u*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) + 2*m*l*u^2*sin(q_pin1)) +
    //   6*l*sin(q_pin1)*sin(q_pin2)*(2*m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 -
    //   2*m*g*sin(q_ground1 + q_pin2) + m*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) -
    //   2*m*sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) +
    //   3*l*sin(q_pin1)*(1 + 2*cos(q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*m*g*cos(q_ground1 + q_pin2) + 2*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 +
    //   q_pin1)^2 + 2*m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))) + m*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   3*m*l*sin(q_pin1)*(2*l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) +
    //   l*u^2*(sin(q_pin1)*sin(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1) +
    //   cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))
    //   - sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1))
    //   - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)) + (sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1)^2)/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(2*l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) +
    //   cos(q + q_pin1))) + sin(q_pin1)*sin(q_pin2)*(sin(q_pin1)*(1 + 1/tan(q - q_ground1 + q_pin1)^2) -
    //   sin(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)) - cos(q - q_ground1 +
    //   q_pin1)*((sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + (sin(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1))))/(sin(q
    //   - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - 6*l*sin(q_pin1)*(2*m*g*cos(q + q_pin1) +
    //   m*l*u*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l*u*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u + u*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 + m*l*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + 3*(2*l*cos(q_pin1) +
    //   l*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(2*m*g*sin(q
    //   + q_pin1) + m*(l*u*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 -
    //   l*u*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 + 2*l*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^3 + l*u*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*u*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(u*sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) +
    //   u*cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1
    //   + q_pin1)) + u*sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   u*cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(sin(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*cos(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))) +
    //   cos(q_pin1)*(u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1) +
    //   u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)) +
    //   6*l*sin(q_pin1)*sin(q_pin2)*(2*m*sin(q_pin2)*(2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*tan(q -
    //   q_ground1 + q_pin1)) + l*u^2*cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 +
    //   l*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1
    //   + q_pin1) + 2*l*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u -
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) +
    //   l*u*sin(q_pin1)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1))) - 4*m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)^2*tan(q - q_ground1 + q_pin1)) - m*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) - m*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))/sin(q - q_ground1 + q_pin1) + 3*l*sin(q_pin1)*(1 + 2*cos(q_pin2) +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(4*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 +
    //   q_pin1)) + 2*m*cos(q_pin2)*(2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 +
    //   q_pin1)) + l*u^2*cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   2*l*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) + l*u*sin(q_pin1)*(u*sin(q_pin1)/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))) +
    //   m*(2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) +
    //   l*u^2*cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q -
    //   q_ground1 + q_pin1) + 2*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) +
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))/(sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   (sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + sin(q_ground1 + q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))))/sin(q_ground1 -
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q -
    //   q_ground1 + q_pin1) + 2*m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) +
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) + m*l^2*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))/(sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   (sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + sin(q_ground1 + q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))))/sin(q_ground1 -
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1))/(12*d1) +
    //   d1_by_q*(6*m*l*g*cos(q) + m*l^2*u^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 +
    //   q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q - q_ground1 + q_pin1)^3 +
    //   m*l^2*u^2*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_pin1)^2 + cos(q)*(cos(q_ground1)*(2
    //   - 5*sin(q_pin1)^2 + 2*cos(q_pin1) + cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 +
    //   2*cos(q_pin1))) - 3*cos(q)*(1 + cos(q_pin1)) -
    //   4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 +
    //   2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 + 2*cos(q_pin1)))) -
    //   sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))) - 3*cos(q_ground1)*(cos(q_ground1)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
    //   sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) - 2*sin(q)*sin(q_pin1))))) -
    //   sin(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1)))))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^4 +
    //   m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) + 3*m*l*sin(q_pin1)*(2*g*cos(q_ground1) +
    //   l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q -
    //   q_ground1 + q_pin1)^2)/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(2*g*cos(q_ground2) +
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 6*l*sin(q_pin1)*(2*m*g*sin(q + q_pin1) - 2*m*l*u^2*cos(q_pin1) +
    //   m*l*u*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + 3*(2*l*cos(q_pin1) +
    //   l*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(2*m*g*cos(q
    //   + q_pin1) - m*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) + 2*m*l*u^2*sin(q_pin1)) +
    //   6*l*sin(q_pin1)*sin(q_pin2)*(2*m*g*sin(q_ground1 + q_pin2) -
    //   2*m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 - m*l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   2*m*sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) + 3*l*sin(q_pin1)*(1 +
    //   2*cos(q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*m*g*cos(q_ground1 + q_pin2) + 2*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 +
    //   q_pin1)^2 + 2*m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))) + m*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1))/(12*d1^2)
    let u_dot_by_q = d1_inv_by_12
        * (u_dot_by_q_of_place_21
            * (-u_dot_by_q_of_u_2_14).mul_add(u_dot_by_q_of_u_2_15, u_dot_by_q_of_u_2_36)
            + u_dot_by_q_of_u_2_2 * u_dot_by_q_of_place_11
            + u_dot_by_q_of_place_23
                * (-u_dot_by_q_of_u_2_8)
                    .mul_add(u_dot_by_q_of_u_2_37, u_dot_by_q_of_u_2_42)
            + u_dot_by_q_of_place_26 * (u_dot_by_q_of_u_2_57 + u_dot_by_q_of_place_24)
            + sin_q_pin1_l_times_6 * (u_dot_by_q_of_place_27 - u_dot_by_q_of_u_2_61)
            + u_dot_by_q_of_place_42
                * u_dot_by_q_of_place_34
                    .mul_add(u_dot_by_q_of_u_2_62, u_dot_by_q_of_u_2_64)
            + u_dot_by_q_of_place_44
                * (m
                    * (-u_dot_by_q_of_u_2_14)
                        .mul_add(l_u_dot_by_q_of_u_2_3, u_dot_by_q_of_u_2_65)
                    + u_dot_by_q_of_u_2_67) + u_dot_by_q_of_place_34 * u_dot_by_q_of_u_2_70
            - u_dot_by_q_of_u_2_72
                * (cos_q * (u_dot_by_q_of_place_55 - u_dot_by_q_of_place_57)
                    + u_dot_by_q_of_place_52 * sin_q) + u_dot_by_q_of_u_2_98
            + g_m_l_times_6 * sin_q) + d1_by_q * u_dot_by_q_of_u_2_102;
    let d1_by_q_ground1_of_place = cos_q_ground2_doubled * d1_of_place_19;
    let d1_by_q_ground1_of_place_2 = d1_of_place_11 * sin_q_ground2;
    let d1_by_q_ground1_of_place_3 = d1_of_place_12 * d1_of_q_pin2;
    let d1_by_q_ground1_of_place_4 = d1_of_place_11 * cos_q_ground2;
    // d1_by_q_ground1 = m*l^2*((sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(sin(q)*cos(q_ground1)*(3*cos(q_pin1) +
    //   (2*cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) -
    //   cos(q)*sin(q_ground1)*(3*cos(q_pin1) + cos(q)*sin(q_ground1)/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   (sin(q)*sin(q_ground1)*(3*cos(q_pin1) + (2*cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + cos(q)*cos(q_ground1)*(3*cos(q_pin1)
    //   + cos(q)*sin(q_ground1)/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) -
    //   sin(q)*cos(q_ground1)*((sin(q)*sin(q_ground1) +
    //   2*cos(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + (sin(q)*cos(q_ground1) -
    //   2*cos(q)*sin(q_ground1))*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) +
    //   cos(q)*sin(q_ground1)*(cos(q)*cos(q_ground1)/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   cos(q)*sin(q_ground1)*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)))^2))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + 2*sin(q_pin1)^2*(5 + 3*cos(q_pin2) +
    //   (sin(q_pin2)^2/sin(q_ground1 - q_ground2 + q_pin2) + sin(q_ground2)*(2*cos(q_ground1) +
    //   2*cos(q_ground1 + q_pin2) + 3*cos(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   (cos(q_ground1)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*cos(q_ground1
    //   + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) - cos(q_ground2)*(sin(q_ground1)*(2 + 3*cos(q_pin2)
    //   - cos(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground1 + q_pin2)*(2 - cos(q_ground2)*sin(q_ground1 + q_pin2)/sin(q_ground1 - q_ground2 +
    //   q_pin2) + 3*cos(q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2))/(sin(q - q_ground1 + q_pin1)^2*tan(q
    //   - q_ground1 + q_pin1)) - sin(q_pin1)^2*((sin(q_pin2)^2/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_ground2)*(2*cos(q_ground1) + 2*cos(q_ground1 + q_pin2) + 3*cos(q_pin2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - (cos(q_ground1)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) - sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*cos(q_ground1
    //   + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) - cos(q_ground2)*(sin(q_ground1)*(2 + 3*cos(q_pin2)
    //   - cos(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground1 + q_pin2)*(2 - cos(q_ground2)*sin(q_ground1 + q_pin2)/sin(q_ground1 - q_ground2 +
    //   q_pin2) + 3*cos(q_pin2))))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2))
    //   + (sin(q_pin2)^2/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(2*sin(q_ground1) + 2*sin(q_ground1 + q_pin2) + 3*cos(q_pin2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + (cos(q_ground1)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) - sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*cos(q_ground1
    //   + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   (cos(q_ground1)*(2*cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) +
    //   sin(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2))) -
    //   sin(q_ground1)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) - sin(q_ground1 +
    //   q_pin2)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*cos(q_ground1
    //   + q_pin2)) + cos(q_ground1 + q_pin2)*(sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   2*cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1)*(2 + 3*cos(q_pin2) - cos(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1
    //   + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2)) + cos(q_ground1 + q_pin2)*(2 -
    //   cos(q_ground2)*sin(q_ground1 + q_pin2)/sin(q_ground1 - q_ground2 + q_pin2) + 3*cos(q_pin2)) -
    //   sin(q_ground1 + q_pin2)*(cos(q_ground2)*cos(q_ground1 + q_pin2)/sin(q_ground1 - q_ground2 + q_pin2)
    //   + cos(q_ground2)*sin(q_ground1 + q_pin2)/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 -
    //   q_ground1 - q_pin2))) + sin(q_ground1)*(cos(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1 +
    //   q_pin2))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   cos(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 +
    //   q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2)/3
    let d1_by_q_ground1 = l_m_l_by_3
        * (d1_of_place_3_inv
            * (-cos_q_sin_q_ground1
                * (-cos_q_cos_q_ground1).mul_add(d1_of_place_3_inv, d1_by_q_of_place_3)
                + cos_q_cos_q_ground1 * d1_of_place_4 + sin_q_sin_q_ground1 * d1_of_place_6
                - sin_q_cos_q_ground1
                    * (d1_of_place_3_inv
                        * cos_q_cos_q_ground1.mul_add(S::int(2), sin_q_sin_q_ground1)
                        + d1_by_q_of_place_4)) + d1_by_q_of_place_7
            - d1_of_place_28_sq
                * (sin_angle_inv
                    * (u_dot_by_q_of_place_15 * sin_q_pin2 * sin_q_pin2
                        + sin_q_ground2
                            * (sin_angle_inv
                                * (cos_q_ground1
                                    * d1_of_place_21
                                        .mul_add(sin_q_ground2, d1_by_q_ground1_of_place)
                                    - d1_of_place_14 * sin_q_ground1
                                    - d1_of_place_11 * d1_of_place_16
                                    - d1_of_place_9
                                        * (d1_by_q_ground1_of_place + d1_by_q_ground1_of_place_2))
                                - d1_of_place_17 * u_dot_by_q_of_place_15
                                + d1_by_q_ground1_of_place_3)
                        + cos_q_ground2
                            * (d1_of_place_23 * cos_q_ground1 - d1_of_place_9 * d1_of_place_24
                                + sin_q_ground1
                                    * (-d1_of_place_10)
                                        .mul_add(
                                            d1_of_place_22,
                                            d1_of_place_21 * u_dot_by_q_of_place_15 * cos_q_ground2,
                                        )
                                + d1_of_place_11
                                    * u_dot_by_q_of_place_15
                                        .mul_add(
                                            d1_by_q_ground1_of_place_4,
                                            d1_of_place_9 * d1_of_place_22,
                                        ))) + d1_of_place_25 * u_dot_by_q_of_place_15));
    // d1_by_q_of_place_5 - cos_angle_sin_angle_inv
    let u_dot_by_q_ground1_of_place = d1_by_q_of_place_5 - cos_angle_sin_angle_inv;
    let u_dot_by_q_ground1_of_u_2 = u_dot_by_q_of_u_2_5 * u_dot_by_q_of_place_14;
    // u_dot_by_q_of_u_2_4 - u_dot_by_q_ground1_of_u_2
    let u_dot_by_q_ground1_of_u_2_2 = u_dot_by_q_of_u_2_4 - u_dot_by_q_ground1_of_u_2;
    // u_dot_by_q_of_u_2_6*u_dot_by_q_ground1_of_place + u_dot_by_q_ground1_of_u_2_2
    let u_dot_by_q_ground1_of_u_2_3 = u_dot_by_q_of_u_2_6
        .mul_add(u_dot_by_q_ground1_of_place, u_dot_by_q_ground1_of_u_2_2);
    let u_dot_by_q_ground1_of_u_2_4 = u_dot_by_q_of_place_12 * u_dot_by_q_of_u_2_11;
    // 2*cos_angle_sin_angle_inv*u_dot_by_q_of_u_2_31 - u_dot_by_q_of_place_15*u_dot_by_q_of_u_2_29
    let u_dot_by_q_ground1_of_u_2_5 = (-u_dot_by_q_of_place_15)
        .mul_add(
            u_dot_by_q_of_u_2_29,
            S::int(2) * cos_angle_sin_angle_inv * u_dot_by_q_of_u_2_31,
        );
    // u_dot_by_q_of_u_2_30*(u_dot_by_q_of_place_14*u_dot_by_q_of_place_15 + u_dot_by_q_of_place_17) +
    //   u_dot_by_q_ground1_of_u_2_5
    let u_dot_by_q_ground1_of_u_2_6 = u_dot_by_q_of_u_2_30
        * u_dot_by_q_of_place_14.mul_add(u_dot_by_q_of_place_15, u_dot_by_q_of_place_17)
        + u_dot_by_q_ground1_of_u_2_5;
    // sin_angle_inv*(u_dot_by_q_of_u_2_12*u_dot_by_q_ground1_of_place -
    //   sin(q_ground2)*(u_dot_by_q_of_u_2_9 + u_dot_by_q_of_u_2_28 +
    //   d1_of_place_11*u_dot_by_q_ground1_of_u_2_3) - cos(q_ground2)*(u_dot_by_q_of_u_2_10 -
    //   u_dot_by_q_of_u_2_26 - d1_of_place_9*u_dot_by_q_ground1_of_u_2_3) - u_dot_by_q_ground1_of_u_2_4) -
    //   u_dot_by_q_of_place_16*(u_dot_by_q_of_u_2_13*u_dot_by_q_ground1_of_place +
    //   u_dot_by_q_ground1_of_u_2_2) + u_dot_by_q_ground1_of_u_2_6
    let u_dot_by_q_ground1_of_u_2_7 = sin_angle_inv
        * (-sin_q_ground2
            * d1_of_place_11
                .mul_add(
                    u_dot_by_q_ground1_of_u_2_3,
                    u_dot_by_q_of_u_2_9 + u_dot_by_q_of_u_2_28,
                ) + u_dot_by_q_of_u_2_12 * u_dot_by_q_ground1_of_place
            - cos_q_ground2
                * (-d1_of_place_9)
                    .mul_add(
                        u_dot_by_q_ground1_of_u_2_3,
                        u_dot_by_q_of_u_2_10 - u_dot_by_q_of_u_2_26,
                    ) - u_dot_by_q_ground1_of_u_2_4)
        - u_dot_by_q_of_place_16
            * u_dot_by_q_of_u_2_13
                .mul_add(u_dot_by_q_ground1_of_place, u_dot_by_q_ground1_of_u_2_2)
        + u_dot_by_q_ground1_of_u_2_6;
    let u_dot_by_q_ground1_of_place_2 = sin_angle_inv * u_dot_by_q_of_place_14;
    // u_dot_by_q_of_place_16 + u_dot_by_q_ground1_of_place_2
    let u_dot_by_q_ground1_of_place_3 = u_dot_by_q_of_place_16 + u_dot_by_q_ground1_of_place_2;
    let u_dot_by_q_ground1_of_u_2_8 = u_dot_by_q_of_u_2_79 * u_dot_by_q_ground1_of_place_3;
    let u_dot_by_q_ground1_of_u_2_9 = u_dot_by_q_of_u_2_24 * m_l_u_dot_by_q_of_u_2_3;
    let u_dot_by_q_ground1_of_u_2_10 = u_dot_by_q_ground1_of_place_3 * u_dot_by_q_ground1_of_u_2_9;
    let u_dot_by_q_ground1_of_place_4 = u_dot_by_q_of_place_15 * u_dot_by_q_of_place_35;
    // u_dot_by_q_of_place_36 + cos_angle_sin_angle_inv*u_dot_by_q_of_place_37
    let u_dot_by_q_ground1_of_place_5 = cos_angle_sin_angle_inv
        .mul_add(u_dot_by_q_of_place_37, u_dot_by_q_of_place_36);
    // cos_angle_sin_angle_inv*(u_dot_by_q_ground1_of_place_2 - u_dot_by_q_ground1_of_place_4) -
    //   u_dot_by_q_ground1_of_place_5
    let u_dot_by_q_ground1_of_place_6 = cos_angle_sin_angle_inv
        * (u_dot_by_q_ground1_of_place_2 - u_dot_by_q_ground1_of_place_4)
        - u_dot_by_q_ground1_of_place_5;
    let u_dot_by_q_ground1_of_place_7 = sin_q_pin1_cos_q_pin2 * u_dot_by_q_ground1_of_place_3;
    // u_dot_by_q_of_place_33 - sin(q_pin1)*(sin(q_pin2)*(u_dot_by_q_of_place_30 + u_dot_by_q_of_place_32 -
    //   sin(q_pin1)*(2 + d1_by_q_of_place_5_sq + u_dot_by_q_ground1_of_place_6)) +
    //   u_dot_by_q_ground1_of_place_7)
    let u_dot_by_q_ground1_of_place_8 = u_dot_by_q_of_place_33
        - sin_q_pin1
            * (sin_q_pin2
                * (u_dot_by_q_of_place_30 + u_dot_by_q_of_place_32
                    - sin_q_pin1
                        * (S::int(2) + d1_by_q_of_place_5_sq + u_dot_by_q_ground1_of_place_6))
                + u_dot_by_q_ground1_of_place_7);
    let u_dot_by_q_ground1_of_u_2_11 = u_dot_by_q_of_u_2 * u_dot_by_q_of_place_15
        * u_dot_by_q_of_place_41;
    let u_dot_by_q_ground1_of_u_2_12 = l_u_dot_by_q_of_u_2_21 * u_dot_by_q_ground1_of_place_3;
    let u_dot_by_q_ground1_of_u_2_13 = d1_of_place_28 * u_dot_by_q_of_u_2_80;
    let u_dot_by_q_ground1_of_u_2_14 = l_d1_of_place_28_times_3 * u_dot_by_q_of_u_2_76;
    // u_dot_by_q_of_place_15*(u_dot_by_q_of_place_11*u_dot_by_q_of_u_2_81*sin(q_pin2) +
    //   2*u_dot_by_q_of_u_2_68*u_dot_by_q_of_u_2_88)
    let u_dot_by_q_ground1_of_u_2_15 = u_dot_by_q_of_place_15
        * (u_dot_by_q_of_u_2_68 * u_dot_by_q_of_u_2_88)
            .mul_add(
                S::int(2),
                u_dot_by_q_of_place_11 * u_dot_by_q_of_u_2_81 * sin_q_pin2,
            );
    // u_dot_by_q_ground1_of_place_3*(u_dot_by_q_ground1_of_u_2_13 + u_dot_by_q_ground1_of_u_2_14) +
    //   u_dot_by_q_ground1_of_u_2_15
    let u_dot_by_q_ground1_of_u_2_16 = u_dot_by_q_ground1_of_place_3
        * (u_dot_by_q_ground1_of_u_2_13 + u_dot_by_q_ground1_of_u_2_14)
        + u_dot_by_q_ground1_of_u_2_15;
    // 3*u_dot_by_q_of_place_50*sin(q_ground1) + cos_q_ground1_times_3*u_dot_by_q_of_place_53 +
    //   4*cos(q)*(u_dot_by_q_of_place_56*cos(q_ground1) - u_dot_by_q_of_place_48*sin(q_ground1))
    let u_dot_by_q_ground1_of_place_9 = S::int(3) * u_dot_by_q_of_place_50
        * sin_q_ground1 + cos_q_ground1_times_3 * u_dot_by_q_of_place_53
        + S::int(4) * cos_q
            * (-u_dot_by_q_of_place_48)
                .mul_add(sin_q_ground1, u_dot_by_q_of_place_56 * cos_q_ground1);
    // u_dot_by_q_of_place_50*cos(q_ground1) - u_dot_by_q_of_place_53*sin(q_ground1)
    let u_dot_by_q_ground1_of_place_10 = (-u_dot_by_q_of_place_53)
        .mul_add(sin_q_ground1, u_dot_by_q_of_place_50 * cos_q_ground1);
    // u_dot_by_q_ground1 = (3*l*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*m*g*cos(q_ground1 + q_pin2) + 2*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 +
    //   q_pin1)^2 + 2*m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))) + m*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) -
    //   3*m*l^2*u^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))/(sin(q - q_ground1 + q_pin1)^3*tan(q - q_ground1 + q_pin1)) -
    //   m*l^2*u^2*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(sin(q_pin1)^2 + cos(q)*(cos(q_ground1)*(2
    //   - 5*sin(q_pin1)^2 + 2*cos(q_pin1) + cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 +
    //   2*cos(q_pin1))) - 3*cos(q)*(1 + cos(q_pin1)) -
    //   4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 +
    //   2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 + 2*cos(q_pin1)))) -
    //   sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))) - 3*cos(q_ground1)*(cos(q_ground1)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
    //   sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) - 2*sin(q)*sin(q_pin1))))) -
    //   sin(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1)))))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^4 -
    //   4*m*l^2*u^2*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)) - cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(sin(q_pin1)^2
    //   + cos(q)*(cos(q_ground1)*(2 - 5*sin(q_pin1)^2 + 2*cos(q_pin1) +
    //   cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 + 2*cos(q_pin1))) - 3*cos(q)*(1 +
    //   cos(q_pin1)) - 4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 +
    //   2*cos(q_pin1)))) - sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))) - 3*cos(q_ground1)*(cos(q_ground1)*(1
    //   + cos(q_pin1)) + sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
    //   sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) - 2*sin(q)*sin(q_pin1))))) -
    //   sin(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1)))))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^5 -
    //   m*l^2*u^2*sin(q_pin1)*(sin(q_pin1)*sin(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1) + cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   cos(q_ground1)*(cos(q) + cos(q + q_pin1))) - sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) + (sin(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1)^3 - m*l^2*u^2*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(cos(q)*(sin(q_ground1)*(2 -
    //   5*sin(q_pin1)^2 + 2*cos(q_pin1) + cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 +
    //   2*cos(q_pin1))) - 3*cos(q)*(1 + cos(q_pin1)) -
    //   4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 +
    //   2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 + 2*cos(q_pin1)))) -
    //   sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))) - 3*cos(q_ground1)*(cos(q_ground1)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
    //   cos(q_ground1)*(cos(q)*(sin(q)*(1 + cos(q_pin1)) + sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) -
    //   2*sin(q)*sin(q_pin1))) - 2*sin(q_pin1)*cos(q_pin1)) -
    //   cos(q_ground1)*(3*sin(q_ground1)*(cos(q_ground1)*(1 + cos(q_pin1)) + sin(q_pin1)*(sin(q_ground1)*(1
    //   + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1))) + 3*cos(q_ground1)*(sin(q_ground1)*(1 +
    //   cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 + 2*cos(q_pin1)))) +
    //   4*cos(q)*(sin(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 +
    //   2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 + 2*cos(q_pin1)))) -
    //   sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))) + cos(q_ground1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) +
    //   sin(q_pin1)*(cos(q)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 + 2*cos(q_pin1))) +
    //   sin(q)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1))))))) +
    //   sin(q)*(cos(q_ground1)*sin(q_pin1)^2 - sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1))))) + cos(q_ground1)*(cos(q_ground1)*(cos(q_ground1)*(1 +
    //   cos(q_pin1)) + sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1))) +
    //   sin(q_ground1)*(sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 + 2*cos(q_pin1))) -
    //   sin(q_ground1)*(1 + cos(q_pin1))))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^4 -
    //   3*m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q - q_ground1 + q_pin1)) -
    //   2*m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1))) -
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)) + cos(q - q_ground1 +
    //   q_pin1)*((sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + (sin(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1)) +
    //   sin(q_pin1)*((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 2 -
    //   1/tan(q - q_ground1 + q_pin1)^2 + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2) - 1)/tan(q_ground1 - q_ground2 + q_pin2)^2 + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1)
    //   + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/tan(q_ground2 - q_ground1 -
    //   q_pin2)))))/(sin(q - q_ground1 + q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) -
    //   3*m*l*sin(q_pin1)*(2*g*cos(q_ground1) + l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 +
    //   q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q - q_ground1 + q_pin1)^2)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) - 3*m*l*sin(q_pin1)*sin(q_pin2)*(2*g*cos(q_ground2) +
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) - 3*m*l*sin(q_pin1)*sin(q_pin2)*(2*g*cos(q_ground2)
    //   + l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) - 3*(l*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)))^2)*(2*m*g*cos(q + q_pin1) - m*(l*u*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) + 2*m*l*u^2*sin(q_pin1)) -
    //   6*l*sin(q_pin1)*sin(q_pin2)*(2*m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 -
    //   2*m*g*sin(q_ground1 + q_pin2) + m*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) -
    //   2*m*sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   3*l*sin(q_pin1)*(1 + 2*cos(q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*m*g*cos(q_ground1 + q_pin2) + 2*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 +
    //   q_pin1)^2 + 2*m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))) + m*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1) - m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 - m*l^2*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + 6*l*sin(q_pin1)*(m*l*u*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l*u*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)) - cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 + m*l*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) - 3*m*(2*l*cos(q_pin1) +
    //   l*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))))*(l*u*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 -
    //   l*u*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 + 2*l*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^3 + l*u*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*u*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(u*sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) +
    //   u*cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1
    //   + q_pin1)) + u*sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   u*cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(sin(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*cos(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))) +
    //   cos(q_pin1)*(u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1) +
    //   u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) -
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(2*l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) +
    //   cos(q + q_pin1))) - sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)) + cos(q - q_ground1 +
    //   q_pin1)*((sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + (sin(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1)) +
    //   sin(q_pin1)*((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 2 -
    //   1/tan(q - q_ground1 + q_pin1)^2 + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2) - 1)/tan(q_ground1 - q_ground2 + q_pin2)^2 + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1)
    //   + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/tan(q_ground2 - q_ground1 -
    //   q_pin2)))))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + 3*m*l*sin(q_pin1)*(2*g*sin(q_ground1) +
    //   2*l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/(sin(q -
    //   q_ground1 + q_pin1)^2*tan(q_ground1 - q - q_pin1)) + l*u^2*(sin(q_pin1)*cos(q - q_ground1 +
    //   q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) + (sin(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1)) -
    //   sin(q_pin1)*sin(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) -
    //   sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1) -
    //   cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1))))/sin(q - q_ground1 + q_pin1)^2)/sin(q - q_ground1 + q_pin1) -
    //   6*l*sin(q_pin1)*sin(q_pin2)*(2*m*g*cos(q_ground1 + q_pin2) +
    //   4*m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/(sin(q - q_ground1 + q_pin1)^2*tan(q_ground1 - q - q_pin1)) +
    //   m*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1
    //   - q - q_pin1)) + m*l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   2*m*sin(q_pin2)*(2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 +
    //   q_pin1)) + l*u^2*cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   2*l*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) + l*u*sin(q_pin1)*(u*sin(q_pin1)/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))) +
    //   m*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) - u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/sin(q - q_ground1
    //   + q_pin1))/sin(q - q_ground1 + q_pin1) - 3*l*sin(q_pin1)*(1 + 2*cos(q_pin2) +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*m*cos(q_pin2)*(2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 +
    //   q_pin1)) + l*u^2*cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   2*l*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) + l*u*sin(q_pin1)*(u*sin(q_pin1)/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))) -
    //   2*m*g*sin(q_ground1 + q_pin2) - 4*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)^2*tan(q_ground1 - q - q_pin1)) + m*(2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) +
    //   l*u^2*cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u^2*cos(q_pin1)*(cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))*((sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) + 2*l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) +
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)^2) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 -
    //   q_ground1 - q_pin2)) + (u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 +
    //   q_pin1)) - u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   sin(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))) + sin(q_ground1 + q_pin2)*(u*sin(q_pin1)/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) + cos(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q
    //   - q_ground1 + q_pin1) + u*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q
    //   - q_pin1)) + sin(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) - u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))))/sin(q_ground1 -
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) - sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u^2*cos(q_pin1)*(cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))*((sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) + 2*m*l^2*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) +
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) + m*l^2*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)^2) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 -
    //   q_ground1 - q_pin2)) + (u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 +
    //   q_pin1)) - u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   sin(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))) + sin(q_ground1 + q_pin2)*(u*sin(q_pin1)/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) + cos(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q
    //   - q_ground1 + q_pin1) + u*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q
    //   - q_pin1)) + sin(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) - u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))))/sin(q_ground1 -
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1))/(12*d1) +
    //   d1_by_q_ground1*(6*m*l*g*cos(q) + m*l^2*u^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 +
    //   q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q - q_ground1 + q_pin1)^3 +
    //   m*l^2*u^2*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_pin1)^2 + cos(q)*(cos(q_ground1)*(2
    //   - 5*sin(q_pin1)^2 + 2*cos(q_pin1) + cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 +
    //   2*cos(q_pin1))) - 3*cos(q)*(1 + cos(q_pin1)) -
    //   4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 +
    //   2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 + 2*cos(q_pin1)))) -
    //   sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))) - 3*cos(q_ground1)*(cos(q_ground1)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
    //   sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) - 2*sin(q)*sin(q_pin1))))) -
    //   sin(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1)))))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^4 +
    //   m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) + 3*m*l*sin(q_pin1)*(2*g*cos(q_ground1) +
    //   l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q -
    //   q_ground1 + q_pin1)^2)/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(2*g*cos(q_ground2) +
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 6*l*sin(q_pin1)*(2*m*g*sin(q + q_pin1) - 2*m*l*u^2*cos(q_pin1) +
    //   m*l*u*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + 3*(2*l*cos(q_pin1) +
    //   l*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(2*m*g*cos(q
    //   + q_pin1) - m*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) + 2*m*l*u^2*sin(q_pin1)) +
    //   6*l*sin(q_pin1)*sin(q_pin2)*(2*m*g*sin(q_ground1 + q_pin2) -
    //   2*m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 - m*l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   2*m*sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) + 3*l*sin(q_pin1)*(1 +
    //   2*cos(q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*m*g*cos(q_ground1 + q_pin2) + 2*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 +
    //   q_pin1)^2 + 2*m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))) + m*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1))/(12*d1^2)
    let u_dot_by_q_ground1 = d1_inv_by_12
        * (u_dot_by_q_of_u_2_61 * sin_q_pin1_l_times_6
            - u_dot_by_q_of_u_2_57 * u_dot_by_q_of_place_26
            - u_dot_by_q_of_place_11 * (-g_doubled).mul_add(sin_q_ground1, u_dot_by_q_of_u_2_2)
            - u_dot_by_q_of_u_2_98
            - u_dot_by_q_of_place_21
                * (u_dot_by_q_of_u_2_15
                    .mul_add(u_dot_by_q_ground1_of_u_2_7, u_dot_by_q_of_u_2_36)
                    - u_dot_by_q_ground1_of_u_2_8)
            - u_dot_by_q_of_place_23
                * ((-u_dot_by_q_of_u_2_37)
                    .mul_add(
                        u_dot_by_q_ground1_of_u_2_3,
                        u_dot_by_q_of_u_2_42 - u_dot_by_q_of_place_58,
                    ) + u_dot_by_q_ground1_of_u_2_10)
            - u_dot_by_q_of_u_2_70 * u_dot_by_q_ground1_of_place_8
            - u_dot_by_q_of_place_42
                * (u_dot_by_q_of_u_2_62
                    .mul_add(u_dot_by_q_ground1_of_place_8, u_dot_by_q_of_u_2_64)
                    - u_dot_by_q_ground1_of_u_2_11)
            - u_dot_by_q_of_place_44
                * (u_dot_by_q_of_u_2_67 - u_dot_by_q_of_place_59
                    + m
                        * (l_u_dot_by_q_of_u_2_3
                            .mul_add(u_dot_by_q_ground1_of_u_2_7, u_dot_by_q_of_u_2_65)
                            - u_dot_by_q_ground1_of_u_2_12)) + u_dot_by_q_ground1_of_u_2_16
            - u_dot_by_q_of_u_2_72
                * (cos_q
                    * (cos_q_ground1 * (u_dot_by_q_of_q_2_q_pin1_10 - u_dot_by_q_ground1_of_place_9)
                        + u_dot_by_q_of_place_51 * sin_q_ground1)
                    + sin_q
                        * (cos_q_ground1 * (sin_q_pin1_sq + u_dot_by_q_ground1_of_place_10)
                            - u_dot_by_q_of_place_54 * sin_q_ground1)))
        + d1_by_q_ground1 * u_dot_by_q_of_u_2_102;
    // d1_of_place_20 - 2*d1_of_place_18
    let d1_by_q_ground2_of_place = (-d1_of_place_18).mul_add(S::int(2), d1_of_place_20);
    let sin_q_ground2_doubled = S::int(2) * sin_q_ground2;
    let d1_by_q_ground2_of_place_2 = cos_angle_sin_angle_inv * sin_q_pin2;
    let d1_by_q_ground2_of_place_3 = d1_of_place_28_sq * l_m_l_by_3;
    // d1_by_q_ground2 = m*l^2*sin(q_pin1)^2*(2*sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   2*cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) +
    //   3*cos(q_pin2)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))) + (2*sin(q_pin2)^2/tan(q_ground1 -
    //   q_ground2 + q_pin2) + sin(q_ground2)*(cos(q_ground1 - q_ground2 + q_pin2)*(2*cos(q_ground1) +
    //   2*cos(q_ground1 + q_pin2) + 3*cos(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   2*(cos(q_ground1)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*cos(q_ground1
    //   + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) + 2*cos(q_ground2)*(cos(q_ground1 + q_pin2)^2 -
    //   sin(q_ground1 + q_pin2)^2 + cos(q_ground1)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2)) -
    //   sin(q_ground1)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2))) +
    //   2*sin(q_ground2)*(sin(q_ground1)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) + sin(q_ground1 +
    //   q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))) - cos(q_ground2)*(cos(q_ground1 - q_ground2 +
    //   q_pin2)*(2*sin(q_ground1) + 2*sin(q_ground1 + q_pin2) + 3*cos(q_pin2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2))) + 2*cos(q_ground2)*(sin(q_ground1)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2) + (sin(q_ground1) + 2*sin(q_ground1 + q_pin2))/tan(q_ground2 - q_ground1 - q_pin2)) +
    //   sin(q_ground1 + q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2) + sin(q_ground1 +
    //   q_pin2)/tan(q_ground2 - q_ground1 - q_pin2)))))/sin(q_ground1 - q_ground2 + q_pin2))/(3*sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2))
    let d1_by_q_ground2 = sin_angle_inv * d1_by_q_ground2_of_place_3
        * (sin_angle_inv
            * (sin_q_ground2
                * (cos_q_ground2_doubled
                    * ((-d1_of_place_11)
                        .mul_add(d1_of_place_11, d1_of_place_9 * d1_of_place_9)
                        + d1_of_place_10 * cos_q_ground1 - d1_of_place_21 * sin_q_ground1)
                    + d1_by_q_ground2_of_place * cos_angle
                    + d1_of_place_12 * d1_of_place_19 * sin_q_ground2_doubled)
                - cos_q_ground2
                    * (cos_q_ground2_doubled
                        * (sin_q_ground1
                            * (-d1_of_place_21)
                                .mul_add(cos_angle_sin_angle_inv, d1_of_place_19)
                            + d1_of_place_11
                                * (-d1_of_place_11)
                                    .mul_add(cos_angle_sin_angle_inv, d1_of_place_19))
                        + d1_by_q_ground1_of_place_3 * cos_angle)
                + sin_q_pin2_doubled * d1_by_q_ground2_of_place_2)
            + d1_of_q_pin2 * u_dot_by_q_of_place_14);
    let u_dot_by_q_ground2_of_u_2 = u_dot_by_q_of_u_2_6 * cos_angle_sin_angle_inv;
    // u_dot_by_q_ground1_of_u_2 + u_dot_by_q_ground2_of_u_2
    let u_dot_by_q_ground2_of_u_2_2 = u_dot_by_q_ground1_of_u_2 + u_dot_by_q_ground2_of_u_2;
    let u_dot_by_q_ground2_of_place = d1_of_place_9 * cos_q_ground2;
    // u_dot_by_q_ground2_of_place - d1_by_q_ground1_of_place_2
    let u_dot_by_q_ground2_of_place_2 = u_dot_by_q_ground2_of_place - d1_by_q_ground1_of_place_2;
    let u_dot_by_q_ground2_of_u_2_3 = u_dot_by_q_of_u_2_12 * cos_angle_sin_angle_inv;
    let u_dot_by_q_ground2_of_u_2_4 = u_dot_by_q_of_u_2_13 * cos_angle_sin_angle_inv;
    // u_dot_by_q_ground1_of_u_2_6 + sin_angle_inv*(u_dot_by_q_of_u_2_26*cos(q_ground2) -
    //   u_dot_by_q_of_u_2_28*sin(q_ground2) - u_dot_by_q_ground1_of_u_2_4 -
    //   u_dot_by_q_ground2_of_u_2_2*u_dot_by_q_ground2_of_place_2 - u_dot_by_q_ground2_of_u_2_3) +
    //   u_dot_by_q_of_place_16*(u_dot_by_q_ground1_of_u_2 + u_dot_by_q_ground2_of_u_2_4)
    let u_dot_by_q_ground2_of_u_2_5 = u_dot_by_q_ground1_of_u_2_6
        + sin_angle_inv
            * ((-u_dot_by_q_of_u_2_28)
                .mul_add(sin_q_ground2, u_dot_by_q_of_u_2_26 * cos_q_ground2)
                - u_dot_by_q_ground1_of_u_2_4
                - u_dot_by_q_ground2_of_u_2_2 * u_dot_by_q_ground2_of_place_2
                - u_dot_by_q_ground2_of_u_2_3)
        + u_dot_by_q_of_place_16 * (u_dot_by_q_ground1_of_u_2 + u_dot_by_q_ground2_of_u_2_4);
    // u_dot_by_q_of_u_2_5*(u_dot_by_q_ground1_of_place_7 - sin_q_pin1_sin_q_pin2*(1 +
    //   u_dot_by_q_ground1_of_place_6))
    let u_dot_by_q_ground2_of_u_2_6 = u_dot_by_q_of_u_2_5
        * (u_dot_by_q_ground1_of_place_7
            - sin_q_pin1_sin_q_pin2 * (S::int(1) + u_dot_by_q_ground1_of_place_6));
    let sin_angle_2_inv_l_m_l = sin_angle_2_inv * l_m_l;
    // u_dot_by_q_ground2 =
    //   (6*l*sin(q_pin1)*sin(q_pin2)*(m*l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   m*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 +
    //   q_pin1) - 2*m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   m*l^2*u^2*sin(q_pin1)^2*sin(q_pin2)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin1)*sin(q_pin2)*((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1 +
    //   ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) -
    //   1)/tan(q_ground1 - q_ground2 + q_pin2)^2 + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) + (sin(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) - 3*m*l*sin(q_pin1)*sin(q_pin2)*(2*g*cos(q_ground2)
    //   + l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   3*l*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*m*g*cos(q_ground1 + q_pin2) + 2*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 +
    //   q_pin1)^2 + 2*m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))) + m*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) -
    //   sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) - 3*m*l*sin(q_pin1)*(1 +
    //   2*cos(q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)^2) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   (u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   sin(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) +
    //   cos(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) + sin(q_ground2)*sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 -
    //   q_ground1 - q_pin2)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin1)*sin(q_pin2)*((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1 +
    //   ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) -
    //   1)/tan(q_ground1 - q_ground2 + q_pin2)^2 + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) + (sin(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) - 2*g*sin(q_ground2) -
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)^2) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   (u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   sin(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) +
    //   cos(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) + sin(q_ground2)*sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 -
    //   q_ground1 - q_pin2)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1))/(12*d1) +
    //   d1_by_q_ground2*(6*m*l*g*cos(q) + m*l^2*u^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 +
    //   q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q - q_ground1 + q_pin1)^3 +
    //   m*l^2*u^2*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_pin1)^2 + cos(q)*(cos(q_ground1)*(2
    //   - 5*sin(q_pin1)^2 + 2*cos(q_pin1) + cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 +
    //   2*cos(q_pin1))) - 3*cos(q)*(1 + cos(q_pin1)) -
    //   4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 +
    //   2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 + 2*cos(q_pin1)))) -
    //   sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))) - 3*cos(q_ground1)*(cos(q_ground1)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
    //   sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) - 2*sin(q)*sin(q_pin1))))) -
    //   sin(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1)))))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^4 +
    //   m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) + 3*m*l*sin(q_pin1)*(2*g*cos(q_ground1) +
    //   l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q -
    //   q_ground1 + q_pin1)^2)/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(2*g*cos(q_ground2) +
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 6*l*sin(q_pin1)*(2*m*g*sin(q + q_pin1) - 2*m*l*u^2*cos(q_pin1) +
    //   m*l*u*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + 3*(2*l*cos(q_pin1) +
    //   l*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(2*m*g*cos(q
    //   + q_pin1) - m*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) + 2*m*l*u^2*sin(q_pin1)) +
    //   6*l*sin(q_pin1)*sin(q_pin2)*(2*m*g*sin(q_ground1 + q_pin2) -
    //   2*m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 - m*l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   2*m*sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) + 3*l*sin(q_pin1)*(1 +
    //   2*cos(q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*m*g*cos(q_ground1 + q_pin2) + 2*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 +
    //   q_pin1)^2 + 2*m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))) + m*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1))/(12*d1^2)
    let u_dot_by_q_ground2 = d1_inv_by_12
        * (u_dot_by_q_of_place_23
            * u_dot_by_q_of_u_2_37
                .mul_add(u_dot_by_q_ground2_of_u_2_2, u_dot_by_q_ground1_of_u_2_10)
            - u_dot_by_q_ground1_of_u_2_16
            - u_dot_by_q_of_place_11 * u_dot_by_q_of_place_43
                * (-l_u_dot_by_q_of_u_2_3)
                    .mul_add(u_dot_by_q_ground2_of_u_2_5, u_dot_by_q_ground1_of_u_2_12)
            - u_dot_by_q_of_place_21
                * (-u_dot_by_q_of_u_2_15)
                    .mul_add(u_dot_by_q_ground2_of_u_2_5, u_dot_by_q_ground1_of_u_2_8)
            - u_dot_by_q_of_place_42
                * ((-g_doubled).mul_add(sin_q_ground2, u_dot_by_q_ground1_of_u_2_11)
                    + l_u_2_sin_angle_2_inv * u_dot_by_q_ground2_of_u_2_6)
            - u_dot_by_q_of_u_2_11 * u_dot_by_q_ground2_of_u_2_6 * sin_angle_2_inv_l_m_l)
        + d1_by_q_ground2 * u_dot_by_q_of_u_2_102;
    // d1_by_q_pin1 = m*l^2*(2*sin(q_pin1)*cos(q_pin1)*(5 + 3*cos(q_pin2) + (sin(q_pin2)^2/sin(q_ground1 -
    //   q_ground2 + q_pin2) + sin(q_ground2)*(2*cos(q_ground1) + 2*cos(q_ground1 + q_pin2) +
    //   3*cos(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   (cos(q_ground1)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*cos(q_ground1
    //   + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) - cos(q_ground2)*(sin(q_ground1)*(2 + 3*cos(q_pin2)
    //   - cos(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground1 + q_pin2)*(2 - cos(q_ground2)*sin(q_ground1 + q_pin2)/sin(q_ground1 - q_ground2 +
    //   q_pin2) + 3*cos(q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 -
    //   (sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))*(sin(q)*cos(q_ground1)*(3*cos(q_pin1) + (2*cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) - cos(q)*sin(q_ground1)*(3*cos(q_pin1)
    //   + cos(q)*sin(q_ground1)/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 -
    //   (cos(q)*sin(q_ground1)*(3*sin(q_pin1) + cos(q)*sin(q_ground1)*(cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) - sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) -
    //   sin(q)*cos(q_ground1)*(3*sin(q_pin1) + (sin(q)*cos(q_ground1) -
    //   2*cos(q)*sin(q_ground1))*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)))^2))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) - 2*sin(q_pin1)^2*(5 + 3*cos(q_pin2) +
    //   (sin(q_pin2)^2/sin(q_ground1 - q_ground2 + q_pin2) + sin(q_ground2)*(2*cos(q_ground1) +
    //   2*cos(q_ground1 + q_pin2) + 3*cos(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   (cos(q_ground1)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*cos(q_ground1
    //   + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) - cos(q_ground2)*(sin(q_ground1)*(2 + 3*cos(q_pin2)
    //   - cos(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground1 + q_pin2)*(2 - cos(q_ground2)*sin(q_ground1 + q_pin2)/sin(q_ground1 - q_ground2 +
    //   q_pin2) + 3*cos(q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2))/(sin(q - q_ground1 + q_pin1)^2*tan(q
    //   - q_ground1 + q_pin1)))/3
    let d1_by_q_pin1 = l_m_l_by_3
        * (-d1_by_q_of_place_7
            + d1_of_place_26 * sin_angle_2_inv * d1_of_place_28 * cos_q_pin1_doubled
            + d1_of_place_3_inv
                * (sin_q_cos_q_ground1 * (d1_by_q_of_place_4 + sin_q_pin1_times_3)
                    + cos_q_sin_q_ground1 * (d1_by_q_of_place_3 - sin_q_pin1_times_3)));
    // u_dot_by_q_of_q_2_q_pin1_3*sin(q_ground1) - u_dot_by_q_of_q_2_q_pin1_5*cos(q_ground1)
    let u_dot_by_q_pin1_of_place = (-u_dot_by_q_of_q_2_q_pin1_5)
        .mul_add(cos_q_ground1, u_dot_by_q_of_q_2_q_pin1_3 * sin_q_ground1);
    // -u_dot_by_q_pin1_of_place
    let u_dot_by_q_pin1_of_place_2 = -u_dot_by_q_pin1_of_place;
    let u_dot_by_q_pin1_of_place_3 = u_dot_by_q_pin1_of_place_2 * cos_q_pin1;
    // u_dot_by_q_of_place*sin(q_pin1) - u_dot_by_q_pin1_of_place_3
    let u_dot_by_q_pin1_of_place_4 = u_dot_by_q_of_place
        .mul_add(sin_q_pin1, -u_dot_by_q_pin1_of_place_3);
    // u_dot_by_q_of_place_9 - u_dot_by_q_of_place_3*cos(q_pin1)*cos(q - q_ground1 + q_pin1) +
    //   sin_q_pin1_cos_angle_2*(u_dot_by_q_of_place_8 - sin_angle_2_inv*(cos(q_pin1) +
    //   u_dot_by_q_pin1_of_place)) + u_dot_by_q_pin1_of_place_4
    let u_dot_by_q_pin1_of_place_5 = u_dot_by_q_of_place_9
        - u_dot_by_q_of_place_3 * cos_q_pin1 * cos_angle_2
        + sin_q_pin1_cos_angle_2
            * (u_dot_by_q_of_place_8 - sin_angle_2_inv * (cos_q_pin1 + u_dot_by_q_pin1_of_place))
        + u_dot_by_q_pin1_of_place_4;
    // -u_dot_by_q_of_place_18*u_dot_by_q_of_u_2_48
    let u_dot_by_q_pin1_of_u_2 = -u_dot_by_q_of_place_18 * u_dot_by_q_of_u_2_48;
    // u_dot_by_q_of_place_18 - sin_q_pin2_sin_angle_inv
    let u_dot_by_q_pin1_of_place_6 = u_dot_by_q_of_place_18 - sin_q_pin2_sin_angle_inv;
    // sin_angle_inv*(sin_q_pin2_sin_angle_inv*u_dot_by_q_of_place_14*u_dot_by_q_of_u_2_48 +
    //   sin(q_ground2)*(d1_of_place_11*u_dot_by_q_pin1_of_u_2 - u_dot_by_q_of_u_2_48*sin(q_ground1)) -
    //   cos(q_ground2)*(u_dot_by_q_of_u_2_48*cos(q_ground1) + d1_of_place_9*u_dot_by_q_pin1_of_u_2)) -
    //   u_dot_by_q_of_place_16*u_dot_by_q_of_u_2_48*u_dot_by_q_pin1_of_place_6
    let u_dot_by_q_pin1_of_u_2_2 = sin_angle_inv
        * (sin_q_ground2
            * (-u_dot_by_q_of_u_2_48)
                .mul_add(sin_q_ground1, d1_of_place_11 * u_dot_by_q_pin1_of_u_2)
            + sin_q_pin2_sin_angle_inv * u_dot_by_q_of_place_14 * u_dot_by_q_of_u_2_48
            - cos_q_ground2
                * d1_of_place_9
                    .mul_add(
                        u_dot_by_q_pin1_of_u_2,
                        u_dot_by_q_of_u_2_48 * cos_q_ground1,
                    )) - u_dot_by_q_of_place_16 * u_dot_by_q_of_u_2_48 * u_dot_by_q_pin1_of_place_6;
    // u_dot_by_q_of_place_19 - u_dot_by_q_pin1_of_place_2
    let u_dot_by_q_pin1_of_place_7 = u_dot_by_q_of_place_19 - u_dot_by_q_pin1_of_place_2;
    let u_dot_by_q_pin1_of_u_2_3 = u_2_sin_angle_2_inv * u_dot_by_q_pin1_of_place_7;
    // -u_dot_by_q_of_u_2_22 - u_dot_by_q_of_u_2_4*(u_dot_by_q_of_u_2_48 + u_dot_by_q_pin1_of_u_2_3)
    let u_dot_by_q_pin1_of_u_2_4 = -u_dot_by_q_of_u_2_22
        - u_dot_by_q_of_u_2_4 * (u_dot_by_q_of_u_2_48 + u_dot_by_q_pin1_of_u_2_3);
    // u_dot_by_q_of_u_2_32*u_dot_by_q_of_u_2_48 + u_dot_by_q_of_place_18*u_dot_by_q_pin1_of_u_2_4
    let u_dot_by_q_pin1_of_u_2_5 = u_dot_by_q_of_place_18
        .mul_add(u_dot_by_q_pin1_of_u_2_4, u_dot_by_q_of_u_2_32 * u_dot_by_q_of_u_2_48);
    let u_dot_by_q_pin1_of_u_2_6 = d1_by_q_of_place_5 * u_dot_by_q_of_u_2_19;
    // u_dot_by_q_of_place*u_dot_by_q_of_u_2_3 + u_dot_by_q_pin1_of_u_2_6*cos(q_pin1)
    let u_dot_by_q_pin1_of_u_2_7 = u_dot_by_q_pin1_of_u_2_6
        .mul_add(cos_q_pin1, u_dot_by_q_of_place * u_dot_by_q_of_u_2_3);
    // u_dot_by_q_of_u_2*u_dot_by_q_pin1_of_place_3 - l_u_2_sin_angle_2_inv*u_dot_by_q_pin1_of_u_2_7
    let u_dot_by_q_pin1_of_u_2_8 = (-l_u_2_sin_angle_2_inv)
        .mul_add(
            u_dot_by_q_pin1_of_u_2_7,
            u_dot_by_q_of_u_2 * u_dot_by_q_pin1_of_place_3,
        );
    // l*u_dot_by_q_pin1_of_u_2_4 - u_dot_by_q_pin1_of_u_2_8
    let u_dot_by_q_pin1_of_u_2_9 = l
        .mul_add(u_dot_by_q_pin1_of_u_2_4, -u_dot_by_q_pin1_of_u_2_8);
    // -u_dot_by_q_of_u_2_49
    let u_dot_by_q_pin1_of_u_2_10 = -u_dot_by_q_of_u_2_49;
    // -d1_of_place_2*u_dot_by_q_of_u_2_48
    let u_dot_by_q_pin1_of_u_2_11 = -d1_of_place_2 * u_dot_by_q_of_u_2_48;
    // u_dot_by_q_of_place_40*cos(q_pin1) - u_dot_by_q_pin1_of_place_4*sin(q_pin2) +
    //   sin(q_pin1)*(u_dot_by_q_of_place_17*cos(q_pin1)*cos(q_pin2) - sin(q_pin2)*(u_dot_by_q_of_place_31 -
    //   u_dot_by_q_of_place_38*cos(q_pin1) - sin_angle_2_inv*u_dot_by_q_pin1_of_place_7*cos(q - q_ground1 +
    //   q_pin1)))
    let u_dot_by_q_pin1_of_place_8 = u_dot_by_q_of_place_40 * cos_q_pin1
        - u_dot_by_q_pin1_of_place_4 * sin_q_pin2
        + sin_q_pin1
            * (-sin_q_pin2
                * ((-u_dot_by_q_of_place_38).mul_add(cos_q_pin1, u_dot_by_q_of_place_31)
                    - sin_angle_2_inv * u_dot_by_q_pin1_of_place_7 * cos_angle_2)
                + u_dot_by_q_of_place_17 * cos_q_pin1 * cos_q_pin2);
    let sin_q_pin1_cos_q_ground1 = cos_q_ground1 * sin_q_pin1;
    // sin_q_pin1_cos_q_ground1 - sin(q_ground1)*cos(q_pin1)
    let u_dot_by_q_pin1_of_place_9 = (-sin_q_ground1)
        .mul_add(cos_q_pin1, sin_q_pin1_cos_q_ground1);
    let sin_q_pin1_sin_q_ground1 = sin_q_ground1 * sin_q_pin1;
    // cos(q_ground1)*cos(q_pin1) + sin_q_pin1_sin_q_ground1
    let u_dot_by_q_pin1_of_place_10 = cos_q_ground1
        .mul_add(cos_q_pin1, sin_q_pin1_sin_q_ground1);
    // sin_q_pin1_doubled*sin(q_pin1) - cos_q_pin1_doubled*cos(q_pin1)
    let u_dot_by_q_pin1_of_q_pin1 = (-cos_q_pin1_doubled)
        .mul_add(cos_q_pin1, sin_q_pin1_doubled * sin_q_pin1);
    let u_dot_by_q_pin1_of_u_2_12 = u_dot_by_q_of_place_41 * u_dot_by_q_of_u_2_69;
    // u_dot_by_q_pin1 = (3*m*l^2*u^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))/(sin(q - q_ground1 + q_pin1)^3*tan(q - q_ground1 + q_pin1)) -
    //   m*l^2*u^2*cos(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))/sin(q - q_ground1 + q_pin1)^3 + 4*m*l^2*u^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(sin(q_pin1)^2 +
    //   cos(q)*(cos(q_ground1)*(2 - 5*sin(q_pin1)^2 + 2*cos(q_pin1) +
    //   cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 + 2*cos(q_pin1))) - 3*cos(q)*(1 +
    //   cos(q_pin1)) - 4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 +
    //   2*cos(q_pin1)))) - sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))) - 3*cos(q_ground1)*(cos(q_ground1)*(1
    //   + cos(q_pin1)) + sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
    //   sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) - 2*sin(q)*sin(q_pin1))))) -
    //   sin(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1)))))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^5 +
    //   m*l^2*u^2*sin(q_pin1)*(sin(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*sin(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1) + cos(q_pin1)*cos(q - q_ground1 + q_pin1)*(1 - (sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1)) + cos(q_pin1)*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))
    //   + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1))
    //   - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) - (sin(q_ground1)*sin(q + q_pin1) + cos(q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q -
    //   q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1)^3 + m*l^2*u^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(cos(q_ground1)*(2*sin(q_pin1) +
    //   10*sin(q_pin1)*cos(q_pin1) + cos(q)*(4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 +
    //   2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 + 2*cos(q_pin1)))) +
    //   2*sin(q_pin1)*(cos(q)*(sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*cos(q_pin1)) -
    //   sin(q)*(cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*cos(q_pin1)))) - 3*cos(q)*sin(q_pin1) -
    //   6*sin(q_pin1)*(cos(q)*cos(q_pin1) - sin(q)*sin(q_pin1)) - 3*cos(q_pin1)*(2*cos(q)*sin(q_pin1) +
    //   sin(q)*(1 + 2*cos(q_pin1)))) - 3*cos(q_ground1)*(cos(q_ground1)*sin(q_pin1) +
    //   2*sin(q_pin1)*(sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*cos(q_pin1)) +
    //   cos(q_pin1)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 + 2*cos(q_pin1))))) +
    //   sin(q_ground1)*(2*sin(q_pin1)^2 - 2*cos(q_pin1)^2 - cos(q)*(sin(q)*sin(q_pin1) +
    //   2*sin(q_pin1)*(cos(q)*sin(q_pin1) + sin(q)*cos(q_pin1)) + cos(q_pin1)*(2*sin(q)*sin(q_pin1) -
    //   cos(q)*(1 + 2*cos(q_pin1)))))) - sin(q)*(2*sin(q_ground1)*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(2*cos(q_pin1)^2 - 2*sin(q_pin1)^2 - cos(q_ground1)*(sin(q_ground1)*sin(q_pin1) +
    //   2*sin(q_pin1)*(sin(q_ground1)*cos(q_pin1) - cos(q_ground1)*sin(q_pin1)) +
    //   cos(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 +
    //   2*cos(q_pin1)))))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^4 -
    //   m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) +
    //   3*m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*sin(q + q_pin1) +
    //   cos(q_ground1)*cos(q + q_pin1)) - sin(q_pin1)*sin(q_pin2)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1))
    //   - sin(q_ground1)*(cos(q) + cos(q + q_pin1))) -
    //   cos(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))) +
    //   sin(q_pin1)*(cos(q_pin1)*cos(q_pin2)*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1 + 1/tan(q - q_ground1 + q_pin1)^2) - sin(q - q_ground1 + q_pin1)*(1 +
    //   (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1)) - cos(q - q_ground1 + q_pin1)*((sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))
    //   + (sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 + q_pin1)) -
    //   cos(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 + q_pin2)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) - 3*m*l*cos(q_pin1)*(2*g*cos(q_ground1) +
    //   l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q -
    //   q_ground1 + q_pin1)^2)/sin(q - q_ground1 + q_pin1) + 3*m*l*sin(q_pin1)*(2*g*cos(q_ground1) +
    //   l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q -
    //   q_ground1 + q_pin1)^2)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   3*m*l*cos(q_pin1)*sin(q_pin2)*(2*g*cos(q_ground2) +
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 3*m*l*sin(q_pin1)*sin(q_pin2)*(2*g*cos(q_ground2) +
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) + 6*l*cos(q_pin1)*(2*m*l*u^2*cos(q_pin1) -
    //   2*m*g*sin(q + q_pin1) - m*l*u*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + 3*(2*l*sin(q_pin1) +
    //   l*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)*(2*m*g*cos(q + q_pin1) -
    //   m*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) + 2*m*l*u^2*sin(q_pin1)) +
    //   6*l*cos(q_pin1)*sin(q_pin2)*(2*m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 -
    //   2*m*g*sin(q_ground1 + q_pin2) + m*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) -
    //   2*m*sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) +
    //   6*l*sin(q_pin1)*sin(q_pin2)*(2*m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 -
    //   2*m*g*sin(q_ground1 + q_pin2) + m*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) -
    //   2*m*sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   3*l*cos(q_pin1)*(1 + 2*cos(q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*m*g*cos(q_ground1 + q_pin2) + 2*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 +
    //   q_pin1)^2 + 2*m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))) + m*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) + 3*l*sin(q_pin1)*(1 +
    //   2*cos(q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*m*g*cos(q_ground1 + q_pin2) + 2*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 +
    //   q_pin1)^2 + 2*m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))) + m*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1) - m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 - m*l^2*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   3*m*l*sin(q_pin1)*(2*l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) +
    //   l*u^2*(sin(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1))) + sin(q_pin1)*sin(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1) +
    //   cos(q_pin1)*cos(q - q_ground1 + q_pin1)*(1 - (sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1)) + sin(q_pin1)*cos(q -
    //   q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) -
    //   sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))
    //   - (sin(q_ground1)*sin(q + q_pin1) + cos(q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1)^2)/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(2*l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1)) -
    //   sin(q_pin1)*sin(q_pin2)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1))) - cos(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))) +
    //   sin(q_pin1)*(cos(q_pin1)*cos(q_pin2)*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1 + 1/tan(q - q_ground1 + q_pin1)^2) - sin(q - q_ground1 + q_pin1)*(1 +
    //   (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1)) - cos(q - q_ground1 + q_pin1)*((sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))
    //   + (sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 + q_pin1)) -
    //   cos(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 + q_pin2)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) - 6*l*sin(q_pin1)*(2*m*g*cos(q + q_pin1) + 2*m*l*u^2*sin(q_pin1) +
    //   m*l*u*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)) - cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 + m*l*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   u*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + 3*(2*l*cos(q_pin1) +
    //   l*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(2*m*g*sin(q
    //   + q_pin1) - 2*m*l*u^2*cos(q_pin1) + m*(l*u*(sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   2*l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^3 +
    //   l*u*(u*sin(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*sin(q)*sin(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*u*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(u*sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) +
    //   u*cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1
    //   + q_pin1)) + u*sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_ground1)*sin(q +
    //   q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   u*cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(sin(q_ground1)*sin(q + q_pin1) +
    //   cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 + q_pin1) + cos(q_pin1)*(u*sin(q)*cos(q_ground1) -
    //   u*cos(q)*sin(q_ground1) + u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   sin(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   sin(q_pin1)*(u*cos(q)*sin(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*cos(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*cos(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   u*cos(q)*cos(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)) +
    //   6*l*sin(q_pin1)*sin(q_pin2)*(4*m*l*u^2*sin(q_pin1)*cos(q_pin1)*cos(q_pin2)/sin(q - q_ground1 +
    //   q_pin1)^2 - 4*m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 +
    //   q_pin1)) + m*l*u*cos(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) -
    //   m*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) - m*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1) + 2*m*sin(q_pin2)*(l*u^2*sin(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 +
    //   2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) +
    //   l*u^2*cos(q_pin1)*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q -
    //   q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u -
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) + 2*l*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)^2) + l*u*cos(q_pin1)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   l*u*sin(q_pin1)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - u*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))))/sin(q - q_ground1 + q_pin1) +
    //   3*l*sin(q_pin1)*(1 + 2*cos(q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(4*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 +
    //   q_pin1)) - 4*m*l*u^2*sin(q_pin1)*cos(q_pin1)*sin(q_pin2)/sin(q - q_ground1 + q_pin1)^2 +
    //   2*m*cos(q_pin2)*(l*u^2*sin(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 +
    //   2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) +
    //   l*u^2*cos(q_pin1)*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q -
    //   q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u -
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) + 2*l*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)^2) + l*u*cos(q_pin1)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   l*u*sin(q_pin1)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - u*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))) +
    //   m*(l*u^2*sin(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + 2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) +
    //   l*u^2*cos(q_pin1)*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 +
    //   l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1
    //   + q_pin1) + 2*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) + l*u*cos(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   l*u*cos(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1) + l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) - u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - u*(sin(q_ground1)*sin(q + q_pin1) +
    //   cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) - u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*cos(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q - q_pin1)) + u*cos(q_pin1)*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1
    //   + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   (u*sin(q_ground2)*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   u*cos(q_ground2)*cos(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) -
    //   sin(q_ground2)*(u*sin(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   sin(q_ground1 + q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))) -
    //   cos(q_ground2)*(u*cos(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))))/sin(q_ground1 -
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(m*l^2*u^2*sin(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + 2*m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 +
    //   m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1
    //   + q_pin1) + 2*m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) + m*l^2*u*cos(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*u*cos(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1) + m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) + m*l^2*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) - u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - u*(sin(q_ground1)*sin(q + q_pin1) +
    //   cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) - m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) - u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*cos(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q - q_pin1)) + u*cos(q_pin1)*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1
    //   + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   (u*sin(q_ground2)*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   u*cos(q_ground2)*cos(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) -
    //   sin(q_ground2)*(u*sin(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   sin(q_ground1 + q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))) -
    //   cos(q_ground2)*(u*cos(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))))/sin(q_ground1 -
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1))/(12*d1) +
    //   d1_by_q_pin1*(6*m*l*g*cos(q) + m*l^2*u^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 +
    //   q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q - q_ground1 + q_pin1)^3 +
    //   m*l^2*u^2*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_pin1)^2 + cos(q)*(cos(q_ground1)*(2
    //   - 5*sin(q_pin1)^2 + 2*cos(q_pin1) + cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 +
    //   2*cos(q_pin1))) - 3*cos(q)*(1 + cos(q_pin1)) -
    //   4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 +
    //   2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 + 2*cos(q_pin1)))) -
    //   sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))) - 3*cos(q_ground1)*(cos(q_ground1)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
    //   sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) - 2*sin(q)*sin(q_pin1))))) -
    //   sin(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1)))))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^4 +
    //   m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) + 3*m*l*sin(q_pin1)*(2*g*cos(q_ground1) +
    //   l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q -
    //   q_ground1 + q_pin1)^2)/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(2*g*cos(q_ground2) +
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 6*l*sin(q_pin1)*(2*m*g*sin(q + q_pin1) - 2*m*l*u^2*cos(q_pin1) +
    //   m*l*u*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + 3*(2*l*cos(q_pin1) +
    //   l*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(2*m*g*cos(q
    //   + q_pin1) - m*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) + 2*m*l*u^2*sin(q_pin1)) +
    //   6*l*sin(q_pin1)*sin(q_pin2)*(2*m*g*sin(q_ground1 + q_pin2) -
    //   2*m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 - m*l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   2*m*sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) + 3*l*sin(q_pin1)*(1 +
    //   2*cos(q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*m*g*cos(q_ground1 + q_pin2) + 2*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 +
    //   q_pin1)^2 + 2*m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))) + m*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1))/(12*d1^2)
    let u_dot_by_q_pin1 = d1_inv_by_12
        * (u_dot_by_q_of_u_2_91
            - cos_q_pin1_times_3 * sin_angle_2_inv * (u_dot_by_q_of_u_2_78 + u_dot_by_q_of_u_2_85)
            + u_dot_by_q_of_u_2_94 * l.mul_add(sin_q_pin1_doubled, u_dot_by_q_of_place_61)
            + cos_q_pin1
                * (-(sin_angle_2_inv * u_dot_by_q_of_place_18))
                    .mul_add(u_dot_by_q_of_u_2_80, l_times_6 * u_dot_by_q_of_u_2_101)
            + u_dot_by_q_of_u_2_95 * u_dot_by_q_pin1_of_place_5
            + u_dot_by_q_of_place_11
                * u_dot_by_q_of_u_2
                    .mul_add(
                        u_dot_by_q_pin1_of_place_5,
                        d1_by_q_of_place_6 * u_dot_by_q_of_u_2_77,
                    )
            + sin_q_pin1_l_times_6
                * (u_dot_by_q_of_u_2_100
                    .mul_add(u_dot_by_q_pin1_of_u_2_3, -u_dot_by_q_of_u_2_60)
                    - u_dot_by_q_of_u_2_92)
            + u_dot_by_q_of_place_21
                * (l_m_l * u_dot_by_q_pin1_of_u_2_5
                    - u_dot_by_q_of_u_2_15 * u_dot_by_q_pin1_of_u_2_2
                    - u_dot_by_q_of_u_2_35
                        * u_dot_by_q_of_u_2_20
                            .mul_add(
                                u_dot_by_q_pin1_of_place_2, -u_dot_by_q_pin1_of_u_2_7,
                            ))
            + u_dot_by_q_of_place_23
                * ((-u_dot_by_q_of_u_2_37)
                    .mul_add(
                        u_dot_by_q_pin1_of_u_2,
                        u_dot_by_q_of_u_2_41 * u_dot_by_q_of_u_2_48,
                    ) + sin_q_pin2_m_doubled * u_dot_by_q_pin1_of_u_2_9)
            + u_dot_by_q_of_place_44
                * (cos_q_pin2_m_doubled * u_dot_by_q_pin1_of_u_2_9
                    - u_dot_by_q_of_u_2_48 * u_dot_by_q_of_u_2_66
                    - m
                        * ((-l)
                            .mul_add(
                                u_dot_by_q_pin1_of_u_2_5,
                                l_u_dot_by_q_of_u_2_3 * u_dot_by_q_pin1_of_u_2_2,
                            ) + u_dot_by_q_of_place_18 * u_dot_by_q_pin1_of_u_2_8))
            - u_dot_by_q_of_place_26
                * (u_dot_by_q_of_u_2_99
                    + m
                        * (u_dot_by_q_of_u_2_56
                            - u_2_l_d1_of_place_3_inv * u_dot_by_q_pin1_of_u_2_11
                            + l_u_dot_by_q_of_u_2_51
                                * (cos_q_pin1 * (u_dot_by_q_of_u_2_52 + u_dot_by_q_pin1_of_u_2_11)
                                    - u_dot_by_q_of_u_2_50
                                    - u_dot_by_q_of_u_2_46 * u_dot_by_q_pin1_of_place_2
                                    - u_dot_by_q_of_u_2_47 * u_dot_by_q_pin1_of_place_7
                                    - sin_q_pin1
                                        * (u_dot_by_q_of_u_2_43 + u_dot_by_q_pin1_of_u_2_10))))
            - u_dot_by_q_of_u_2_70 * u_dot_by_q_pin1_of_place_8
            + u_dot_by_q_of_place_42
                * (-u_dot_by_q_of_u_2_62)
                    .mul_add(u_dot_by_q_pin1_of_place_8, u_dot_by_q_of_u_2_64)
            + u_dot_by_q_of_u_2_72
                * (u_dot_by_q_of_q_pin1_3
                    - cos_q
                        * (cos_q_ground1
                            * (sin_q_pin1_doubled + S::int(10) * sin_q_pin1 * cos_q_pin1
                                - cos_q_ground1_times_3
                                    * (u_dot_by_q_of_place_46
                                        .mul_add(cos_q_pin1, sin_q_pin1_cos_q_ground1)
                                        + sin_q_pin1_doubled * u_dot_by_q_pin1_of_place_10)
                                + cos_q
                                    * (S::int(6) * u_dot_by_q_of_q_2_q_pin1_5 * sin_q_pin1
                                        - cos_q_pin1_times_3 * u_dot_by_q_of_q_2_q_pin1_6
                                        - sin_q_pin1_times_3 * cos_q
                                        + cos_q_ground1_times_4
                                            * (sin_q_pin1_d1_of_place_2
                                                + u_dot_by_q_of_place_47 * cos_q_pin1
                                                + sin_q_pin1_doubled
                                                    * (-u_dot_by_q_pin1_of_place_9)
                                                        .mul_add(sin_q, u_dot_by_q_pin1_of_place_10 * cos_q))))
                            + sin_q_ground1
                                * (u_dot_by_q_pin1_of_q_pin1
                                    - cos_q
                                        * (u_dot_by_q_of_q_2_q_pin1_3
                                            .mul_add(sin_q_pin1_doubled, sin_q_pin1_sin_q)
                                            + u_dot_by_q_of_q_2_q_pin1_7 * cos_q_pin1)))
                    + sin_q
                        * (cos_q_ground1
                            * (cos_q_ground1
                                * ((-sin_q_pin1_doubled)
                                    .mul_add(
                                        u_dot_by_q_pin1_of_place_9,
                                        u_dot_by_q_of_place_45 * cos_q_pin1,
                                    ) + sin_q_pin1_sin_q_ground1) + u_dot_by_q_pin1_of_q_pin1)
                            - u_dot_by_q_of_q_pin1_3 * sin_q_ground1))
            - u_dot_by_q_of_u_2_20
                * sin_q_pin2_sin_angle_inv
                    .mul_add(
                        u_dot_by_q_pin1_of_u_2_12,
                        u_dot_by_q_of_place_5 * u_dot_by_q_of_u_2_68,
                    )) + d1_by_q_pin1 * u_dot_by_q_of_u_2_102;
    let d1_by_q_pin2_of_place = sin_angle_inv * cos_q_ground2_doubled;
    let sin_q_pin2_times_3 = S::int(3) * sin_q_pin2;
    // d1_by_q_pin2 = -m*l^2*sin(q_pin1)^2*(3*sin(q_pin2) + (2*sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   2*cos(q_ground2)*cos(q_ground1 + q_pin2) + 3*sin(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))) +
    //   3*cos(q_pin2)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 + q_pin2)) +
    //   (cos(q_ground1 - q_ground2 + q_pin2)*(2*sin(q_pin2)^2/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_ground2)*(2*cos(q_ground1) + 2*cos(q_ground1 + q_pin2) + 3*cos(q_pin2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - 2*(cos(q_ground1)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) - sin(q_ground2)*(cos(q_ground1) + 2*cos(q_ground1 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(2*cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*cos(q_ground1
    //   + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2)) - cos(q_ground2)*(sin(q_ground1)*(2 + 3*cos(q_pin2)
    //   - 2*cos(q_ground2)*(sin(q_ground1) + 2*sin(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2))
    //   + sin(q_ground1 + q_pin2)*(2 - 2*cos(q_ground2)*sin(q_ground1 + q_pin2)/sin(q_ground1 - q_ground2 +
    //   q_pin2) + 3*cos(q_pin2)))) - 2*sin(q_pin2)*cos(q_pin2) - 2*cos(q_ground2)^2*cos(q_ground1 +
    //   q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) + 2*sin(q_ground2)*(sin(q_ground2)*sin(q_ground1
    //   + q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1 +
    //   q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - cos(q_ground1 + q_pin2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(3*sin(q - q_ground1 + q_pin1)^2)
    let d1_by_q_pin2 = -d1_by_q_ground2_of_place_3
        * (sin_q_pin2_times_3
            + sin_angle_inv
                * (sin_angle_inv
                    * (sin_q_ground2_doubled
                        * (-cos_q_ground2
                            * d1_of_place_9
                                .mul_add(d1_of_place_19, d1_of_place_11 * d1_of_place_12)
                            + d1_of_place_19 * d1_by_q_ground1_of_place_2)
                        - sin_q_pin2_doubled * cos_q_pin2
                        + d1_of_place_13 * u_dot_by_q_ground2_of_place
                        + cos_angle
                            * (sin_q_pin2_sin_angle_inv * sin_q_pin2_doubled
                                + d1_by_q_ground2_of_place * sin_q_ground2
                                - cos_q_ground2
                                    * (sin_q_ground1
                                        * (-d1_of_place_21)
                                            .mul_add(d1_by_q_pin2_of_place, d1_of_q_pin2)
                                        + d1_of_place_11
                                            * (-d1_of_place_11)
                                                .mul_add(d1_by_q_pin2_of_place, d1_of_q_pin2))))
                    - d1_of_q_pin2 * u_dot_by_q_ground2_of_place_2
                    + u_dot_by_q_of_place_13 * sin_q_pin2_times_3));
    // u_dot_by_q_ground2_of_u_2 - u_dot_by_q_of_u_2_5*u_dot_by_q_ground2_of_place_2
    let u_dot_by_q_pin2_of_u_2 = (-u_dot_by_q_of_u_2_5)
        .mul_add(u_dot_by_q_ground2_of_place_2, u_dot_by_q_ground2_of_u_2);
    // cos(q_pin2) - u_dot_by_q_ground2_of_place_2
    let u_dot_by_q_pin2_of_place = cos_q_pin2 - u_dot_by_q_ground2_of_place_2;
    // u_dot_by_q_ground1_of_u_2_5 + u_dot_by_q_of_u_2_30*(u_dot_by_q_of_place_17 -
    //   u_dot_by_q_of_place_15*u_dot_by_q_ground2_of_place_2) +
    //   sin_angle_inv*(u_dot_by_q_ground1_of_u_2*cos(q_pin2) - u_dot_by_q_of_u_2_11*(d1_of_place_15 +
    //   d1_by_q_ground1_of_place_4) - u_dot_by_q_ground2_of_u_2_3 + sin(q_ground2)*(u_dot_by_q_of_u_2_27 +
    //   d1_of_place_11*u_dot_by_q_pin2_of_u_2) - cos(q_ground2)*(d1_of_place_9*u_dot_by_q_pin2_of_u_2 -
    //   u_dot_by_q_of_u_2_25)) + u_dot_by_q_of_place_16*(u_dot_by_q_ground2_of_u_2_4 +
    //   u_dot_by_q_of_u_2_5*u_dot_by_q_pin2_of_place)
    let u_dot_by_q_pin2_of_u_2_2 = u_dot_by_q_ground1_of_u_2_5
        + u_dot_by_q_of_u_2_30
            * (-u_dot_by_q_of_place_15)
                .mul_add(u_dot_by_q_ground2_of_place_2, u_dot_by_q_of_place_17)
        + sin_angle_inv
            * (-u_dot_by_q_of_u_2_11 * (d1_of_place_15 + d1_by_q_ground1_of_place_4)
                + u_dot_by_q_ground1_of_u_2 * cos_q_pin2 - u_dot_by_q_ground2_of_u_2_3
                + sin_q_ground2
                    * d1_of_place_11
                        .mul_add(u_dot_by_q_pin2_of_u_2, u_dot_by_q_of_u_2_27)
                - cos_q_ground2
                    * d1_of_place_9
                        .mul_add(u_dot_by_q_pin2_of_u_2, -u_dot_by_q_of_u_2_25))
        + u_dot_by_q_of_place_16
            * u_dot_by_q_of_u_2_5
                .mul_add(u_dot_by_q_pin2_of_place, u_dot_by_q_ground2_of_u_2_4);
    // sin_angle_inv*u_dot_by_q_ground2_of_place_2 - u_dot_by_q_of_place_16
    let u_dot_by_q_pin2_of_place_2 = sin_angle_inv
        .mul_add(u_dot_by_q_ground2_of_place_2, -u_dot_by_q_of_place_16);
    // -u_dot_by_q_pin2_of_place_2
    let u_dot_by_q_pin2_of_place_3 = -u_dot_by_q_pin2_of_place_2;
    // sin(q_pin1)*(sin_q_pin2_sin_angle_inv*u_dot_by_q_of_place_13*sin(q_pin1) -
    //   u_dot_by_q_of_place_39*cos(q_pin2) - sin_q_pin1_sin_q_pin2*(1 - u_dot_by_q_ground1_of_place_5 -
    //   cos_angle_sin_angle_inv*(u_dot_by_q_ground1_of_place_4 - sin_angle_inv*u_dot_by_q_pin2_of_place)) -
    //   sin_q_pin1_cos_q_pin2*u_dot_by_q_pin2_of_place_2) - u_dot_by_q_of_place_4*cos(q_pin2)
    let u_dot_by_q_pin2_of_place_4 = sin_q_pin1
        * (sin_q_pin2_sin_angle_inv * u_dot_by_q_of_place_13 * sin_q_pin1
            - u_dot_by_q_of_place_39 * cos_q_pin2
            - sin_q_pin1_sin_q_pin2
                * (S::int(1) - u_dot_by_q_ground1_of_place_5
                    - cos_angle_sin_angle_inv
                        * (-sin_angle_inv)
                            .mul_add(
                                u_dot_by_q_pin2_of_place, u_dot_by_q_ground1_of_place_4,
                            )) - sin_q_pin1_cos_q_pin2 * u_dot_by_q_pin2_of_place_2)
        - u_dot_by_q_of_place_4 * cos_q_pin2;
    // u_dot_by_q_pin2 =
    //   (2*m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   m*l^2*u^2*sin(q_pin1)*cos(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) +
    //   m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*cos(q_pin2)*(cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*sin(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + cos(q_pin2)*(cos(q - q_ground1 + q_pin1)*(1 +
    //   (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1)) - sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2))) + sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin1)*sin(q_pin2)*((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1 +
    //   ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) -
    //   1)/tan(q_ground1 - q_ground2 + q_pin2)^2 + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) - (sin(q_ground2)*sin(q_ground1 + q_pin2)
    //   + cos(q_pin2) + cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/tan(q_ground1 - q_ground2 + q_pin2))))/(sin(q - q_ground1 + q_pin1)^3*sin(q_ground1 -
    //   q_ground2 + q_pin2)^2) - 3*m*l*sin(q_pin1)*cos(q_pin2)*(2*g*cos(q_ground2) +
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 3*m*l*sin(q_pin1)*sin(q_pin2)*(2*g*cos(q_ground2) +
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   6*l*sin(q_pin1)*cos(q_pin2)*(2*m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 -
    //   2*m*g*sin(q_ground1 + q_pin2) + m*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) -
    //   2*m*sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) + 3*l*sin(q_pin1)*(2*sin(q_pin2)
    //   + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2))
    //   + (sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 -
    //   q_ground2 + q_pin2))*(2*m*g*cos(q_ground1 + q_pin2) + 2*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q -
    //   q_ground1 + q_pin1)^2 + 2*m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 +
    //   l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))) + m*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   l*u^2*(cos(q_pin1)*cos(q_pin2)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*sin(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + cos(q_pin2)*(cos(q - q_ground1 + q_pin1)*(1 +
    //   (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1)) - sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2))) + sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin1)*sin(q_pin2)*((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1 +
    //   ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) -
    //   1)/tan(q_ground1 - q_ground2 + q_pin2)^2 + ((sin(q_pin2) + cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) - (sin(q_ground2)*sin(q_ground1 + q_pin2)
    //   + cos(q_pin2) + cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/tan(q_ground1 - q_ground2 + q_pin2))))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   6*l*sin(q_pin1)*sin(q_pin2)*(2*m*g*cos(q_ground1 + q_pin2) +
    //   2*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 + q_pin1)^2 +
    //   m*l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   2*m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))) + m*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 +
    //   q_pin1))/sin(q - q_ground1 + q_pin1) + 3*l*sin(q_pin1)*(1 + 2*cos(q_pin2) +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(2*m*g*sin(q_ground1 + q_pin2) -
    //   2*m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 +
    //   2*m*sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))) + m*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*((sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*sin(q_ground1 + q_pin2)
    //   + cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 +
    //   q_pin1)^2 + l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2))*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)^2) + (sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   (u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) - u*sin(q_pin1)*cos(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   (u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*cos(q_ground1 + q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*sin(q_ground1 + q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_ground2)*sin(q_pin1)*cos(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*cos(q_ground2)*sin(q_pin1)*cos(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))) - sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) +
    //   cos(q_ground2)*(sin(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 -
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 +
    //   q_pin1)^2 + m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2))*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)) - m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   2*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)^2) + (sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   (u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + cos(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) - u*sin(q_pin1)*cos(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   (u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*cos(q_ground1 + q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*sin(q_ground1 + q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_ground2)*sin(q_pin1)*cos(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*cos(q_ground2)*sin(q_pin1)*cos(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))) - sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) +
    //   cos(q_ground2)*(sin(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))) + cos(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 -
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1))/(12*d1) +
    //   d1_by_q_pin2*(6*m*l*g*cos(q) + m*l^2*u^2*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 +
    //   q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q - q_ground1 + q_pin1)^3 +
    //   m*l^2*u^2*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_pin1)^2 + cos(q)*(cos(q_ground1)*(2
    //   - 5*sin(q_pin1)^2 + 2*cos(q_pin1) + cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 +
    //   2*cos(q_pin1))) - 3*cos(q)*(1 + cos(q_pin1)) -
    //   4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) + cos(q_ground1)*(1 +
    //   2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 + 2*cos(q_pin1)))) -
    //   sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) - cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))) - 3*cos(q_ground1)*(cos(q_ground1)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
    //   sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) - 2*sin(q)*sin(q_pin1))))) -
    //   sin(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1)))))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^4 +
    //   m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) + 3*m*l*sin(q_pin1)*(2*g*cos(q_ground1) +
    //   l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) - 1))/sin(q -
    //   q_ground1 + q_pin1)^2)/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(2*g*cos(q_ground2) +
    //   l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))) + sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2) + sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 6*l*sin(q_pin1)*(2*m*g*sin(q + q_pin1) - 2*m*l*u^2*cos(q_pin1) +
    //   m*l*u*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + 3*(2*l*cos(q_pin1) +
    //   l*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))*(2*m*g*cos(q
    //   + q_pin1) - m*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) + 2*m*l*u^2*sin(q_pin1)) +
    //   6*l*sin(q_pin1)*sin(q_pin2)*(2*m*g*sin(q_ground1 + q_pin2) -
    //   2*m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 - m*l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   2*m*sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) + 3*l*sin(q_pin1)*(1 +
    //   2*cos(q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*m*g*cos(q_ground1 + q_pin2) + 2*m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 +
    //   q_pin1)^2 + 2*m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1))) + m*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1))/(12*d1^2)
    let u_dot_by_q_pin2 = d1_inv_by_12
        * (u_dot_by_q_ground1_of_u_2_15
            - cos_q_pin2
                * u_dot_by_q_of_u_2_5
                    .mul_add(
                        u_dot_by_q_pin1_of_u_2_12,
                        d1_of_place_28_times_3 * u_dot_by_q_of_u_2_84,
                    )
            + u_dot_by_q_ground1_of_u_2_14 * (sin_q_pin2_doubled - u_dot_by_q_pin2_of_place_2)
            + u_dot_by_q_ground1_of_u_2_13 * u_dot_by_q_pin2_of_place_3
            - u_dot_by_q_of_place_23
                * (u_dot_by_q_of_u_2_37
                    .mul_add(u_dot_by_q_pin2_of_u_2, u_dot_by_q_of_u_2_75)
                    + u_dot_by_q_ground1_of_u_2_9 * u_dot_by_q_pin2_of_place_3)
            + u_dot_by_q_of_place_21
                * (-u_dot_by_q_of_u_2_15)
                    .mul_add(
                        u_dot_by_q_pin2_of_u_2_2,
                        u_dot_by_q_of_u_2_79 * u_dot_by_q_pin2_of_place_3,
                    )
            + u_dot_by_q_of_place_44
                * (u_dot_by_q_of_u_2_83
                    + m
                        * (-l_u_dot_by_q_of_u_2_3)
                            .mul_add(
                                u_dot_by_q_pin2_of_u_2_2,
                                l_u_dot_by_q_of_u_2_21 * u_dot_by_q_pin2_of_place_3,
                            )) + u_dot_by_q_of_u_2_70 * u_dot_by_q_pin2_of_place_4
            + u_dot_by_q_of_place_42
                * u_dot_by_q_of_u_2_62
                    .mul_add(u_dot_by_q_pin2_of_place_4, u_dot_by_q_ground1_of_u_2_11))
        + d1_by_q_pin2 * u_dot_by_q_of_u_2_102;
    let u_dot_by_u_of_place = sin_q_pin2_sin_angle_inv * d1_of_place_28;
    // d1_of_place_28*u_dot_by_q_of_place_16*u_dot_by_q_pin1_of_place_6 +
    //   sin_angle_inv*(sin(q_ground2)*(d1_of_place_28*sin(q_ground1) +
    //   d1_of_place_11*u_dot_by_q_of_place_21) + cos(q_ground2)*(d1_of_place_28*cos(q_ground1) -
    //   d1_of_place_9*u_dot_by_q_of_place_21) - u_dot_by_q_of_place_14*u_dot_by_u_of_place)
    let u_dot_by_u_of_place_2 = sin_angle_inv
        * (sin_q_ground2
            * d1_of_place_11
                .mul_add(u_dot_by_q_of_place_21, d1_of_place_28 * sin_q_ground1)
            + cos_q_ground2
                * (-d1_of_place_9)
                    .mul_add(u_dot_by_q_of_place_21, d1_of_place_28 * cos_q_ground1)
            - u_dot_by_q_of_place_14 * u_dot_by_u_of_place)
        + d1_of_place_28 * u_dot_by_q_of_place_16 * u_dot_by_q_pin1_of_place_6;
    let u_dot_by_u_of_u_2 = d1_of_place_28 * u_dot_by_q_of_u_2_32;
    // 1 - d1_of_place_28
    let u_dot_by_u_of_place_3 = S::int(1) - d1_of_place_28;
    // d1_of_place_28*u_dot_by_q_pin1_of_u_2_6 + u_dot_by_q_of_u_2_4*(u_dot_by_q_of_place_28 +
    //   u_dot_by_u_of_place_3)
    let u_dot_by_u_of_u_2_2 = u_dot_by_q_of_u_2_4 * (u_dot_by_q_of_place_28 + u_dot_by_u_of_place_3)
        + d1_of_place_28 * u_dot_by_q_pin1_of_u_2_6;
    // l_u_2_sin_angle_2_inv*cos_q_pin1_doubled*u_dot_by_q_of_place_28 - l*u_dot_by_u_of_u_2_2
    let u_dot_by_u_of_u_2_3 = (-l)
        .mul_add(
            u_dot_by_u_of_u_2_2,
            l_u_2_sin_angle_2_inv * cos_q_pin1_doubled * u_dot_by_q_of_place_28,
        );
    let u_dot_by_u_of_place_4 = d1_of_place_2 * u_dot_by_u_of_place_3;
    let u_2_m_l_times_4 = S::int(4) * u_2_m_l;
    // u_dot_by_u = -(8*m*l^2*u*sin(q_pin1)*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))/sin(q - q_ground1 + q_pin1)^3 + 2*m*l^2*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_pin1)^2 + cos(q)*(cos(q_ground1)*(2 - 5*sin(q_pin1)^2 + 2*cos(q_pin1)
    //   + cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 + 2*cos(q_pin1))) - 3*cos(q)*(1 +
    //   cos(q_pin1)) - 4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 +
    //   2*cos(q_pin1)))) - sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))) - 3*cos(q_ground1)*(cos(q_ground1)*(1
    //   + cos(q_pin1)) + sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
    //   sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) - 2*sin(q)*sin(q_pin1))))) -
    //   sin(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1)))))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^4 +
    //   8*m*l^2*u*sin(q_pin1)*sin(q_pin2)*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^3*sin(q_ground1 - q_ground2 + q_pin2)^2) + 6*l*sin(q_pin1)*(m*l*u*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   4*m*l*u*cos(q_pin1) + m*l*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + 3*(2*l*cos(q_pin1) +
    //   l*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))))*(4*m*l*u*sin(q_pin1) - m*(l*u*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1) - sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) + cos(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1) - sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   l*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) - u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)) +
    //   6*l*sin(q_pin1)*sin(q_pin2)*(2*m*sin(q_pin2)*(2*l*u*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 +
    //   l*u*sin(q_pin1)*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) - 1 + (cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + l*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))
    //   - 4*m*l*u*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 -
    //   m*l*u*sin(q_pin1)*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1) - m*l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 +
    //   q_pin1) + 3*l*sin(q_pin1)*(1 + 2*cos(q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(4*m*l*u*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 + q_pin1)^2 +
    //   2*m*cos(q_pin2)*(2*l*u*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 +
    //   l*u*sin(q_pin1)*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) - 1 + (cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + l*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))
    //   + m*(2*l*u*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   1 + (cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    //   - sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + sin(q_ground2)*(sin(q_ground1)*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + sin(q_ground1 + q_pin2)*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q -
    //   q_ground1 + q_pin1) + l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))
    //   - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u
    //   - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)) - l*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*m*l^2*u*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - 1 + (cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    //   - sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + sin(q_ground2)*(sin(q_ground1)*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + sin(q_ground1 + q_pin2)*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q -
    //   q_ground1 + q_pin1) + m*l^2*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) -
    //   m*l^2*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1))/(12*d1)
    let u_dot_by_u = d1_inv_by_12
        * (l_m_l * d1_of_place_3_inv_sq * u_dot_by_q_of_u_2_55 * u_dot_by_q_of_place_60
            - S::int(8) * u_dot_by_q_of_u_2_90 * sin_angle_2_inv_l_m_l
            + u_dot_by_q_of_place_21
                * (u_dot_by_q_of_u_2_15 * u_dot_by_u_of_place_2 + l_m_l * u_dot_by_u_of_u_2
                    + u_dot_by_q_of_place_18
                        * (-(u_dot_by_q_of_place * cos_q_pin1_doubled))
                            .mul_add(u_dot_by_q_of_u_2_68, l_m_l * u_dot_by_u_of_u_2_2))
            + u_dot_by_q_of_place_23
                * (d1_of_place_28
                    .mul_add(
                        u_dot_by_q_of_u_2_41,
                        u_dot_by_q_of_place_21 * u_dot_by_q_of_u_2_37,
                    ) - sin_q_pin2_m_doubled * u_dot_by_u_of_u_2_3)
            + u_dot_by_q_of_place_44
                * (m
                    * (l
                        .mul_add(
                            u_dot_by_u_of_u_2,
                            l_u_dot_by_q_of_u_2_3 * u_dot_by_u_of_place_2,
                        ) - u_dot_by_q_of_place_18 * u_dot_by_u_of_u_2_3)
                    - u_dot_by_q_of_u_2_40 * u_dot_by_q_of_place_22
                    - cos_q_pin2_m_doubled * u_dot_by_u_of_u_2_3)
            + u_dot_by_q_of_place_26
                * (m
                    * (u_dot_by_q_of_u_2_43 * l_d1_of_place_3_inv
                        - d1_of_place_3_inv_sq * u_dot_by_q_of_u_2_53 * l_d1_of_place
                        + u_2_l_d1_of_place_3_inv * u_dot_by_u_of_place_4
                        + l_u_dot_by_q_of_u_2_51
                            * ((-cos_q_pin1_d1_of_place_2)
                                .mul_add(
                                    u_dot_by_q_of_place_28,
                                    d1_of_place * d1_of_place_28 * u_dot_by_q_of_place,
                                ) + d1_of_place * u_dot_by_u_of_place_3 * sin_q_pin1
                                - u_dot_by_u_of_place_4 * cos_q_pin1))
                    - u_2_m_l_times_4 * sin_q_pin1)
            + sin_q_pin1_l_times_6
                * ((-m_l_u_dot_by_q_of_u_2_58)
                    .mul_add(u_dot_by_q_of_place_62, u_2_m_l_times_4 * cos_q_pin1)
                    - u_dot_by_q_of_place_29 * u_dot_by_q_of_u_2_100));
    // d1_by_q_of_place_5*sin(q_pin1) - cos(q_pin1)
    let q_ground1_dot_by_q_pin1_value_of_place = d1_by_q_of_place_5
        .mul_add(sin_q_pin1, -cos_q_pin1);
    // -u_2_sin_angle_2_inv*q_ground1_dot_by_q_pin1_value_of_place
    let q_ground1_dot_by_q_pin1_value_of_u_2 = -u_2_sin_angle_2_inv
        * q_ground1_dot_by_q_pin1_value_of_place;
    // -u_dot_by_q_ground1_of_place
    let q_ground2_dot_by_q_ground1_value_of_place = -u_dot_by_q_ground1_of_place;
    let q_pin1_dot_by_q_value_of_u_2 = u_2_d1_of_place_3_inv_sq * sin_q_pin1;
    // Entries that are not zero.
    // d(q')/d(u) = 1
    let q_dot_by_u_value = S::int(1);
    // d(q_ground1')/d(q) = u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    let q_ground1_dot_by_q_value = -u_dot_by_q_of_u_2_4;
    // d(q_ground1')/d(q_ground1) = u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))
    let q_ground1_dot_by_q_ground1_value = u_dot_by_q_of_u_2_4;
    // d(q_ground1')/d(q_pin1) = u*(cos(q_pin1) + sin(q_pin1)/tan(q_ground1 - q - q_pin1))/sin(q -
    //   q_ground1 + q_pin1)
    let q_ground1_dot_by_q_pin1_value = q_ground1_dot_by_q_pin1_value_of_u_2;
    // d(q_ground1')/d(u) = sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    let q_ground1_dot_by_u_value = d1_of_place_28;
    // d(q_ground2')/d(q) = u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1))
    let q_ground2_dot_by_q_value = -d1_by_q_of_place_5 * u_dot_by_q_of_u_2_11;
    // d(q_ground2')/d(q_ground1) = -u*sin(q_pin1)*sin(q_pin2)*(1/tan(q_ground1 - q - q_pin1) +
    //   1/tan(q_ground1 - q_ground2 + q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2))
    let q_ground2_dot_by_q_ground1_value = -u_dot_by_q_of_u_2_11
        * q_ground2_dot_by_q_ground1_value_of_place;
    // d(q_ground2')/d(q_ground2) = u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2))
    let q_ground2_dot_by_q_ground2_value = u_dot_by_q_of_u_2_11 * cos_angle_sin_angle_inv;
    // d(q_ground2')/d(q_pin1) = u*sin(q_pin2)*(cos(q_pin1) + sin(q_pin1)/tan(q_ground1 - q -
    //   q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_ground2_dot_by_q_pin1_value = sin_q_pin2_sin_angle_inv
        * q_ground1_dot_by_q_pin1_value_of_u_2;
    // d(q_ground2')/d(q_pin2) = u*sin(q_pin1)*(cos(q_pin2) + sin(q_pin2)/tan(q_ground2 - q_ground1 -
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_ground2_dot_by_q_pin2_value = u_dot_by_q_of_u_2_5
        * (cos_q_pin2 - d1_by_q_ground2_of_place_2);
    // d(q_ground2')/d(u) = sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2))
    let q_ground2_dot_by_u_value = u_dot_by_u_of_place;
    // d(q_pin1')/d(q) = -u*sin(q_pin1)/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2
    let q_pin1_dot_by_q_value = -q_pin1_dot_by_q_value_of_u_2;
    // d(q_pin1')/d(q_ground1) = u*sin(q_pin1)/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2
    let q_pin1_dot_by_q_ground1_value = q_pin1_dot_by_q_value_of_u_2;
    // d(q_pin1')/d(q_pin1) = -u*(cos(q_ground1)*(cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*cos(q_pin1))
    //   + cos(q)*(cos(q)*sin(q_pin1) + sin(q)*cos(q_pin1) -
    //   2*cos(q_ground1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2
    let q_pin1_dot_by_q_pin1_value = -u_2_d1_of_place_3_inv_sq
        * (cos_q
            * (-(d1_of_place_3 * cos_q_ground1))
                .mul_add(S::int(2), u_dot_by_q_of_q_2_q_pin1_3)
            + u_dot_by_q_pin1_of_place_9 * cos_q_ground1);
    // d(q_pin1')/d(u) = (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)
    let q_pin1_dot_by_u_value = u_dot_by_q_of_place_28;
    // d(q_pin2')/d(q) = u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1))
    let q_pin2_dot_by_q_value = -u_dot_by_q_of_u_2_7;
    // d(q_pin2')/d(q_ground1) = -u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2) +
    //   cos(q_ground1)*(1/tan(q_ground1 - q - q_pin1) + 1/tan(q_ground1 - q_ground2 + q_pin2)) +
    //   cos(q_ground1 + q_pin2)*(1/tan(q_ground1 - q - q_pin1) + 1/tan(q_ground1 - q_ground2 + q_pin2))) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2) - sin(q_ground1)*(1/tan(q_ground1 - q -
    //   q_pin1) + 1/tan(q_ground1 - q_ground2 + q_pin2)) - sin(q_ground1 + q_pin2)*(1/tan(q_ground1 - q -
    //   q_pin1) + 1/tan(q_ground1 - q_ground2 + q_pin2))))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2))
    let q_pin2_dot_by_q_ground1_value = -u_dot_by_q_of_u_2_5
        * (sin_q_ground2
            * d1_of_place_19
                .mul_add(q_ground2_dot_by_q_ground1_value_of_place, d1_of_place_12)
            + cos_q_ground2
                * (-d1_of_place_12)
                    .mul_add(q_ground2_dot_by_q_ground1_value_of_place, d1_of_place_19));
    // d(q_pin2')/d(q_ground2) = u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2) +
    //   (cos(q_ground1) + cos(q_ground1 + q_pin2))/tan(q_ground1 - q_ground2 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2) + (sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2))
    let q_pin2_dot_by_q_ground2_value = u_dot_by_q_of_u_2_5
        * (sin_q_ground2 * d1_of_place_19.mul_add(cos_angle_sin_angle_inv, d1_of_place_12)
            + cos_q_ground2 * (-d1_of_place_12).mul_add(cos_angle_sin_angle_inv, d1_of_place_19));
    // d(q_pin2')/d(q_pin1) = -u*(cos(q_pin1)*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))) +
    //   sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/tan(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_dot_by_q_pin1_value = -sin_angle_inv * u_2_sin_angle_2_inv
        * u_dot_by_q_of_place_13 * q_ground1_dot_by_q_pin1_value_of_place;
    // d(q_pin2')/d(q_pin2) = -u*sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))
    //   - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/tan(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_dot_by_q_pin2_value = u_dot_by_q_of_u_2_5
        * (-u_dot_by_q_of_place_13)
            .mul_add(cos_angle_sin_angle_inv, u_dot_by_q_ground2_of_place_2);
    // d(q_pin2')/d(u) = sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_dot_by_u_value = d1_of_place_28 * u_dot_by_q_of_place_17;
    let zero = S::int(0);
    [
        [zero, zero, zero, zero, zero, q_dot_by_u_value],
        [
            q_ground1_dot_by_q_value, q_ground1_dot_by_q_ground1_value, zero,
            q_ground1_dot_by_q_pin1_value, zero, q_ground1_dot_by_u_value,
        ],
        [
            q_ground2_dot_by_q_value, q_ground2_dot_by_q_ground1_value,
            q_ground2_dot_by_q_ground2_value, q_ground2_dot_by_q_pin1_value,
            q_ground2_dot_by_q_pin2_value, q_ground2_dot_by_u_value,
        ],
        [
            q_pin1_dot_by_q_value, q_pin1_dot_by_q_ground1_value, zero, q_pin1_dot_by_q_pin1_value,
            zero, q_pin1_dot_by_u_value,
        ],
        [
            q_pin2_dot_by_q_value, q_pin2_dot_by_q_ground1_value, q_pin2_dot_by_q_ground2_value,
            q_pin2_dot_by_q_pin1_value, q_pin2_dot_by_q_pin2_value, q_pin2_dot_by_u_value,
        ],
        [
            u_dot_by_q, u_dot_by_q_ground1, u_dot_by_q_ground2, u_dot_by_q_pin1, u_dot_by_q_pin2,
            u_dot_by_u,
        ],
    ]
}

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u) row by row, and its right-hand side, which share terms.
///
/// 313 operations, 7 sines and cosines.
#[must_use]
pub fn linear_system<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 1],
) -> ([S; 225], [S; 15]) {
    let Parameters { m, l, g } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_pin2, cos_q_pin2) = q_pin2.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    // Shared terms.
    let l_halved = S::ratio(1, 2) * l;
    let m_l_halved = m * l_halved;
    let m_l = m * l;
    let l_m_l_by_12 = S::ratio(1, 12) * l * m_l;
    // q - q_ground1 + q_pin1
    let m_5_1_of_place = q_2 - q_ground1 + q_pin1;
    let (sin_angle, cos_angle) = m_5_1_of_place.sin_cos();
    let sin_angle_inv = S::int(1) / sin_angle;
    let sin_q_pin1_sin_angle_inv = sin_angle_inv * sin_q_pin1;
    let m_5_1_of_place_2 = m_l_halved * sin_q_pin1_sin_angle_inv;
    let m_6_1_of_place = l_m_l_by_12 * sin_q_pin1_sin_angle_inv;
    let sin_q_ground1_l_halved = l_halved * sin_q_ground1;
    let cos_q_ground1_l_halved = l_halved * cos_q_ground1;
    // q_ground1 - q_ground2 + q_pin2
    let m_8_1_of_place = q_ground1 - q_ground2 + q_pin2;
    let (sin_angle_2, cos_angle_2) = m_8_1_of_place.sin_cos();
    let sin_angle_2_inv = S::int(1) / sin_angle_2;
    let m_8_1_of_place_2 = sin_angle_2_inv * sin_q_pin2;
    let sin_q_ground2_l_halved = l_halved * sin_q_ground2;
    let cos_q_ground2_l_halved = l_halved * cos_q_ground2;
    let sin_q_pin1_m_l = m_l * sin_q_pin1;
    // cos(q)*cos(q_pin1) - sin(q)*sin(q_pin1)
    let cos_q_plus_q_pin1 = (-sin_q).mul_add(sin_q_pin1, cos_q * cos_q_pin1);
    // cos(q)*sin(q_pin1) + sin(q)*cos(q_pin1)
    let sin_q_plus_q_pin1 = sin_q.mul_add(cos_q_pin1, cos_q * sin_q_pin1);
    let cos_q_pin1_doubled = S::int(2) * cos_q_pin1;
    // cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)
    let m_11_1_of_place = (-sin_q).mul_add(cos_q_ground1, cos_q * sin_q_ground1);
    // -m_11_1_of_place
    let minus_m_11_1_of_place = -m_11_1_of_place;
    // sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)
    let m_11_1_of_place_2 = cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1);
    // 1/(minus_m_11_1_of_place*cos(q_pin1) + m_11_1_of_place_2*sin(q_pin1))
    let m_11_1_of_place_3 = S::int(1)
        / m_11_1_of_place_2.mul_add(sin_q_pin1, minus_m_11_1_of_place * cos_q_pin1);
    let m_11_1_of_place_4 = minus_m_11_1_of_place * m_11_1_of_place_3;
    let sin_q_pin2_m_l = m_l * sin_q_pin2;
    // cos(q_ground1)*cos(q_pin2) - sin(q_ground1)*sin(q_pin2)
    let m_13_4_of_place = (-sin_q_ground1)
        .mul_add(sin_q_pin2, cos_q_ground1 * cos_q_pin2);
    // cos(q_ground1)*sin(q_pin2) + sin(q_ground1)*cos(q_pin2)
    let m_13_5_of_place = sin_q_ground1.mul_add(cos_q_pin2, cos_q_ground1 * sin_q_pin2);
    // sin(q_ground1) + sin(q_ground1 + q_pin2)
    let m_14_1_of_place = sin_q_ground1 + m_13_5_of_place;
    // cos(q_ground1) + cos(q_ground1 + q_pin2)
    let m_14_1_of_place_2 = cos_q_ground1 + m_13_4_of_place;
    // m_14_1_of_place*cos(q_ground2) - m_14_1_of_place_2*sin(q_ground2)
    let m_14_1_of_place_3 = (-m_14_1_of_place_2)
        .mul_add(sin_q_ground2, m_14_1_of_place * cos_q_ground2);
    // -sin_angle_2_inv*m_14_1_of_place_3
    let m_14_1_of_place_4 = -sin_angle_2_inv * m_14_1_of_place_3;
    // 1 + m_14_1_of_place_4
    let m_14_1_of_place_5 = S::int(1) + m_14_1_of_place_4;
    let m_g = m * g;
    let u_2_sq = u_2 * u_2;
    let u_2_sin_angle_inv = u_2 * sin_angle_inv;
    let f_4_of_u_2 = u_2_sin_angle_inv * sin_q_pin1;
    let f_4_of_u_2_sq = f_4_of_u_2 * f_4_of_u_2;
    let g_doubled = S::int(2) * g;
    // cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1))
    let f_5_of_place = cos_q_ground1 * (sin_q + sin_q_plus_q_pin1)
        - sin_q_ground1 * (cos_q + cos_q_plus_q_pin1);
    // -f_5_of_place
    let minus_f_5_of_place = -f_5_of_place;
    let f_5_of_place_2 = minus_f_5_of_place * cos_q_pin1;
    // sin(q_pin1)*cos(q - q_ground1 + q_pin1)*(sin_angle_inv*(sin(q_pin1) + f_5_of_place) - 1) +
    //   f_5_of_place_2
    let f_5_of_place_3 = sin_q_pin1 * cos_angle
        * (sin_angle_inv * (sin_q_pin1 + f_5_of_place) - S::int(1)) + f_5_of_place_2;
    let u_2_sin_angle_inv_sq = u_2_sin_angle_inv * u_2_sin_angle_inv;
    let l_u_2_sin_angle_inv_sq = l * u_2_sin_angle_inv_sq;
    let m_halved = S::ratio(1, 2) * m;
    let f_6_of_u_2 = l_m_l_by_12 * u_2_sin_angle_inv_sq;
    let f_7_of_u_2 = m_8_1_of_place_2 * f_4_of_u_2;
    let cos_angle_sin_angle_inv = sin_angle_inv * cos_angle;
    let f_8_of_place = sin_angle_2_inv * cos_angle_2;
    // sin_angle_2_inv*(f_5_of_place_2*sin(q_pin2) + sin(q_pin1)*(m_14_1_of_place_4*sin(q_pin1)*cos(q_pin2)
    //   + sin(q_pin2)*(sin(q_pin1)*(cos_angle_sin_angle_inv + f_8_of_place*(sin_angle_2_inv*(sin(q_pin2) +
    //   m_14_1_of_place_3) - 1)) - cos(q - q_ground1 + q_pin1)*(1 + sin_angle_inv*minus_f_5_of_place))))
    let f_8_of_place_2 = sin_angle_2_inv
        * (sin_q_pin1
            * (sin_q_pin2
                * (sin_q_pin1
                    * (cos_angle_sin_angle_inv
                        + f_8_of_place
                            * (sin_angle_2_inv * (sin_q_pin2 + m_14_1_of_place_3) - S::int(1)))
                    - cos_angle * sin_angle_inv.mul_add(minus_f_5_of_place, S::int(1)))
                + m_14_1_of_place_4 * sin_q_pin1 * cos_q_pin2) + f_5_of_place_2 * sin_q_pin2);
    let f_10_of_u_2 = u_2_sin_angle_inv * minus_f_5_of_place;
    let u_2_m_11_1_of_place_3 = u_2 * m_11_1_of_place_3;
    // u - f_4_of_u_2
    let u_2_minus_f_4_of_u_2 = u_2 - f_4_of_u_2;
    let f_11_of_u_2 = m_11_1_of_place_2 * u_2_minus_f_4_of_u_2;
    // 1 + cos_q_pin1_doubled
    let f_12_of_q_pin1 = S::int(1) + cos_q_pin1_doubled;
    let sin_q_pin1_doubled = S::int(2) * sin_q_pin1;
    // f_12_of_q_pin1*cos(q_ground1) + sin_q_pin1_doubled*sin(q_ground1)
    let f_12_of_place = sin_q_pin1_doubled
        .mul_add(sin_q_ground1, f_12_of_q_pin1 * cos_q_ground1);
    // sin_q_pin1_doubled*cos(q_ground1) - f_12_of_q_pin1*sin(q_ground1)
    let f_12_of_place_2 = (-f_12_of_q_pin1)
        .mul_add(sin_q_ground1, sin_q_pin1_doubled * cos_q_ground1);
    // 1 + cos(q_pin1)
    let f_12_of_q_pin1_2 = S::int(1) + cos_q_pin1;
    // sin(q_pin1)*(f_12_of_q_pin1*sin(q) + sin_q_pin1_doubled*cos(q)) - f_12_of_q_pin1_2*cos(q)
    let f_12_of_q_2_q_pin1 = sin_q_pin1 * sin_q_pin1_doubled.mul_add(cos_q, f_12_of_q_pin1 * sin_q)
        - f_12_of_q_pin1_2 * cos_q;
    let sin_q_pin1_sq = sin_q_pin1 * sin_q_pin1;
    let f_12_of_q_pin1_3 = sin_q_pin1_doubled * cos_q_pin1;
    let f_13_of_u_2 = m_14_1_of_place_5 * f_4_of_u_2;
    // f_5_of_place_2*u_2_sin_angle_inv_sq - f_4_of_u_2*cos_angle_sin_angle_inv*(f_10_of_u_2 +
    //   u_2_minus_f_4_of_u_2)
    let f_13_of_u_2_2 = -f_4_of_u_2 * cos_angle_sin_angle_inv
        * (f_10_of_u_2 + u_2_minus_f_4_of_u_2) + f_5_of_place_2 * u_2_sin_angle_inv_sq;
    let m_l_f_13_of_u_2_2 = m * l * f_13_of_u_2_2;
    // m_14_1_of_place_5*f_13_of_u_2_2 -
    //   f_4_of_u_2*(sin_angle_2_inv*(sin(q_ground2)*(f_4_of_u_2*sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)*f_13_of_u_2) - f_7_of_u_2*(m_14_1_of_place*sin(q_ground2) +
    //   m_14_1_of_place_2*cos(q_ground2)) + cos(q_ground2)*(f_4_of_u_2*cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)*f_13_of_u_2)) + m_14_1_of_place_4*f_8_of_place*(f_13_of_u_2 - f_7_of_u_2))
    let f_14_of_u_2 = -f_4_of_u_2
        * (sin_angle_2_inv
            * (sin_q_ground2 * m_13_5_of_place.mul_add(f_13_of_u_2, f_4_of_u_2 * sin_q_ground1)
                - f_7_of_u_2
                    * m_14_1_of_place_2
                        .mul_add(cos_q_ground2, m_14_1_of_place * sin_q_ground2)
                + cos_q_ground2 * m_13_4_of_place.mul_add(f_13_of_u_2, f_4_of_u_2 * cos_q_ground1))
            + m_14_1_of_place_4 * f_8_of_place * (f_13_of_u_2 - f_7_of_u_2))
        + m_14_1_of_place_5 * f_13_of_u_2_2;
    // -sin(q_ground1)
    let minus_sin_q_ground1 = -sin_q_ground1;
    // -sin(q_ground2)
    let minus_sin_q_ground2 = -sin_q_ground2;
    // -cos(q_ground1)
    let minus_cos_q_ground1 = -cos_q_ground1;
    // -cos(q_ground2)
    let minus_cos_q_ground2 = -cos_q_ground2;
    // -cos(q)
    let minus_cos_q = -cos_q;
    // -cos(q_pin1)
    let minus_cos_q_pin1 = -cos_q_pin1;
    // -cos(q_pin2)
    let minus_cos_q_pin2 = -cos_q_pin2;
    // Values.
    // M_1_8 = 1
    let m_1_8 = S::int(1);
    // M_1_14 = -cos(q)
    let m_1_14 = minus_cos_q;
    // M_1_15 = -sin(q)
    let m_1_15 = -sin_q;
    // M_2_1 = m*l/2
    let m_2_1 = m_l_halved;
    // M_2_9 = 1
    let m_2_9 = S::int(1);
    // M_2_14 = sin(q)
    let m_2_14 = sin_q;
    // M_2_15 = -cos(q)
    let m_2_15 = minus_cos_q;
    // M_3_1 = m*l^2/12
    let m_3_1 = l_m_l_by_12;
    // M_3_9 = l/2
    let m_3_9 = l_halved;
    // M_3_14 = -l*sin(q)/2
    let m_3_14 = -l_halved * sin_q;
    // M_3_15 = l*cos(q)/2
    let m_3_15 = l_halved * cos_q;
    // M_4_2 = -cos(q_ground1)
    let m_4_2 = minus_cos_q_ground1;
    // M_4_3 = -sin(q_ground1)
    let m_4_3 = minus_sin_q_ground1;
    // M_4_6 = 1
    let m_4_6 = S::int(1);
    // M_4_12 = -cos(q_ground1)
    let m_4_12 = minus_cos_q_ground1;
    // M_4_13 = -sin(q_ground1)
    let m_4_13 = minus_sin_q_ground1;
    // M_5_1 = m*l*sin(q_pin1)/(2*sin(q - q_ground1 + q_pin1))
    let m_5_1 = m_5_1_of_place_2;
    // M_5_2 = sin(q_ground1)
    let m_5_2 = sin_q_ground1;
    // M_5_3 = -cos(q_ground1)
    let m_5_3 = minus_cos_q_ground1;
    // M_5_7 = 1
    let m_5_7 = S::int(1);
    // M_5_12 = sin(q_ground1)
    let m_5_12 = sin_q_ground1;
    // M_5_13 = -cos(q_ground1)
    let m_5_13 = minus_cos_q_ground1;
    // M_6_1 = m*l^2*sin(q_pin1)/(12*sin(q - q_ground1 + q_pin1))
    let m_6_1 = m_6_1_of_place;
    // M_6_2 = l*sin(q_ground1)/2
    let m_6_2 = sin_q_ground1_l_halved;
    // M_6_3 = -l*cos(q_ground1)/2
    let m_6_3 = -cos_q_ground1_l_halved;
    // M_6_7 = l/2
    let m_6_7 = l_halved;
    // M_6_12 = -l*sin(q_ground1)/2
    let m_6_12 = -sin_q_ground1_l_halved;
    // M_6_13 = l*cos(q_ground1)/2
    let m_6_13 = cos_q_ground1_l_halved;
    // M_7_4 = -cos(q_ground2)
    let m_7_4 = minus_cos_q_ground2;
    // M_7_5 = -sin(q_ground2)
    let m_7_5 = minus_sin_q_ground2;
    // M_7_10 = -cos(q_ground2)
    let m_7_10 = minus_cos_q_ground2;
    // M_7_11 = -sin(q_ground2)
    let m_7_11 = minus_sin_q_ground2;
    // M_8_1 = m*l*sin(q_pin1)*sin(q_pin2)/(2*sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2))
    let m_8_1 = m_5_1_of_place_2 * m_8_1_of_place_2;
    // M_8_4 = sin(q_ground2)
    let m_8_4 = sin_q_ground2;
    // M_8_5 = -cos(q_ground2)
    let m_8_5 = minus_cos_q_ground2;
    // M_8_10 = sin(q_ground2)
    let m_8_10 = sin_q_ground2;
    // M_8_11 = -cos(q_ground2)
    let m_8_11 = minus_cos_q_ground2;
    // M_9_1 = m*l^2*sin(q_pin1)*sin(q_pin2)/(12*sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2))
    let m_9_1 = m_6_1_of_place * m_8_1_of_place_2;
    // M_9_4 = l*sin(q_ground2)/2
    let m_9_4 = sin_q_ground2_l_halved;
    // M_9_5 = -l*cos(q_ground2)/2
    let m_9_5 = -cos_q_ground2_l_halved;
    // M_9_10 = -l*sin(q_ground2)/2
    let m_9_10 = -sin_q_ground2_l_halved;
    // M_9_11 = l*cos(q_ground2)/2
    let m_9_11 = cos_q_ground2_l_halved;
    // M_10_1 = m*l*sin(q_pin1)
    let m_10_1 = sin_q_pin1_m_l;
    // M_10_2 = cos(q + q_pin1)
    let m_10_2 = cos_q_plus_q_pin1;
    // M_10_3 = sin(q + q_pin1)
    let m_10_3 = sin_q_plus_q_pin1;
    // M_10_8 = -cos(q_pin1)
    let m_10_8 = minus_cos_q_pin1;
    // M_10_9 = -sin(q_pin1)
    let m_10_9 = -sin_q_pin1;
    // M_11_1 = m*l*(2*cos(q_pin1) + (cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))/2
    let m_11_1 = m_l_halved * (cos_q_pin1_doubled - m_11_1_of_place_4);
    // M_11_2 = -sin(q + q_pin1)
    let m_11_2 = -sin_q_plus_q_pin1;
    // M_11_3 = cos(q + q_pin1)
    let m_11_3 = cos_q_plus_q_pin1;
    // M_11_8 = sin(q_pin1)
    let m_11_8 = sin_q_pin1;
    // M_11_9 = -cos(q_pin1)
    let m_11_9 = minus_cos_q_pin1;
    // M_12_1 = m*l^2*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(12*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))
    let m_12_1 = -l_m_l_by_12 * m_11_1_of_place_4;
    // M_12_2 = -l*sin(q + q_pin1)/2
    let m_12_2 = -sin_q_plus_q_pin1 * l_halved;
    // M_12_3 = l*cos(q + q_pin1)/2
    let m_12_3 = cos_q_plus_q_pin1 * l_halved;
    // M_12_8 = -l*sin(q_pin1)/2
    let m_12_8 = -l_halved * sin_q_pin1;
    // M_12_9 = l*cos(q_pin1)/2
    let m_12_9 = l_halved * cos_q_pin1;
    // M_13_1 = m*l*sin(q_pin1)*sin(q_pin2)/sin(q - q_ground1 + q_pin1)
    let m_13_1 = sin_q_pin1_sin_angle_inv * sin_q_pin2_m_l;
    // M_13_4 = cos(q_ground1 + q_pin2)
    let m_13_4 = m_13_4_of_place;
    // M_13_5 = sin(q_ground1 + q_pin2)
    let m_13_5 = m_13_5_of_place;
    // M_13_6 = -cos(q_pin2)
    let m_13_6 = minus_cos_q_pin2;
    // M_13_7 = -sin(q_pin2)
    let m_13_7 = -sin_q_pin2;
    // M_14_1 = m*l*sin(q_pin1)*(1 + 2*cos(q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(2*sin(q - q_ground1 + q_pin1))
    let m_14_1 = m_5_1_of_place_2 * cos_q_pin2.mul_add(S::int(2), m_14_1_of_place_5);
    // M_14_4 = -sin(q_ground1 + q_pin2)
    let m_14_4 = -m_13_5_of_place;
    // M_14_5 = cos(q_ground1 + q_pin2)
    let m_14_5 = m_13_4_of_place;
    // M_14_6 = sin(q_pin2)
    let m_14_6 = sin_q_pin2;
    // M_14_7 = -cos(q_pin2)
    let m_14_7 = minus_cos_q_pin2;
    // M_15_1 = m*l^2*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(12*sin(q - q_ground1 + q_pin1))
    let m_15_1 = m_6_1_of_place * m_14_1_of_place_5;
    // M_15_4 = -l*sin(q_ground1 + q_pin2)/2
    let m_15_4 = -m_13_5_of_place * l_halved;
    // M_15_5 = l*cos(q_ground1 + q_pin2)/2
    let m_15_5 = m_13_4_of_place * l_halved;
    // M_15_6 = -l*sin(q_pin2)/2
    let m_15_6 = -l_halved * sin_q_pin2;
    // M_15_7 = l*cos(q_pin2)/2
    let m_15_7 = l_halved * cos_q_pin2;
    // f_1 = m*l*u^2/2 - m*g*sin(q)
    let f_1 = (-m_g).mul_add(sin_q, m_l_halved * u_2_sq);
    // f_2 = -m*g*cos(q)
    let f_2 = -m_g * cos_q;
    // f_4 = m*l*u^2*sin(q_pin1)^2/(2*sin(q - q_ground1 + q_pin1)^2) - m*g*sin(q_ground1)
    let f_4 = (-m_g).mul_add(sin_q_ground1, m_l_halved * f_4_of_u_2_sq);
    // f_5 = -m*(2*g*cos(q_ground1) + l*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) +
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 1))/sin(q - q_ground1 + q_pin1)^2)/2
    let f_5 = -m_halved * f_5_of_place_3.mul_add(l_u_2_sin_angle_inv_sq, g_doubled * cos_q_ground1);
    // f_6 = -m*l^2*u^2*(cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1))) + sin(q_pin1)*cos(q - q_ground1 + q_pin1)*((sin(q_pin1) + cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1) -
    //   1))/(12*sin(q - q_ground1 + q_pin1)^2)
    let f_6 = -f_5_of_place_3 * f_6_of_u_2;
    // f_7 = m*l*u^2*sin(q_pin1)^2*sin(q_pin2)^2/(2*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2
    //   + q_pin2)^2) - m*g*sin(q_ground2)
    let f_7 = (-m_g).mul_add(sin_q_ground2, m_l_halved * f_7_of_u_2 * f_7_of_u_2);
    // f_8 = -m*(2*g*cos(q_ground2) + l*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)))/2
    let f_8 = -m_halved * l_u_2_sin_angle_inv_sq.mul_add(f_8_of_place_2, g_doubled * cos_q_ground2);
    // f_9 = -m*l^2*u^2*(cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1))) +
    //   sin(q_pin1)*(sin(q_pin1)*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) +
    //   sin(q_pin2)*(sin(q_pin1)*(1/tan(q - q_ground1 + q_pin1) + ((sin(q_pin2) +
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2) - 1)/tan(q_ground1 - q_ground2 +
    //   q_pin2)) - cos(q - q_ground1 + q_pin1)*(1 + (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)))))/(12*sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2))
    let f_9 = -f_6_of_u_2 * f_8_of_place_2;
    // f_10 = m*l*u^2*cos(q_pin1) - m*g*sin(q + q_pin1) + m*l*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(2*(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))
    let f_10 = m_l * u_2_sq * cos_q_pin1 - sin_q_plus_q_pin1 * m_g
        - m_l_halved * minus_m_11_1_of_place * u_2_m_11_1_of_place_3 * (u_2 + f_10_of_u_2);
    // f_11 = m*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(u*cos(q)*sin(q_ground1) -
    //   u*sin(q)*cos(q_ground1) - u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) +
    //   cos(q_pin1)*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/2 - m*g*cos(q + q_pin1) -
    //   m*l*u^2*sin(q_pin1)
    let f_11 = l * m_halved * u_2_m_11_1_of_place_3
        * (f_11_of_u_2
            + m_11_1_of_place_4
                * ((-(m_11_1_of_place_2 * u_2_sin_angle_inv))
                    .mul_add(
                        f_5_of_place_2,
                        minus_m_11_1_of_place * f_4_of_u_2 * minus_f_5_of_place,
                    ) - m_11_1_of_place * u_2_minus_f_4_of_u_2 * sin_q_pin1
                    - f_11_of_u_2 * cos_q_pin1)) - cos_q_plus_q_pin1 * m_g
        - sin_q_pin1_m_l * u_2_sq;
    // f_12 = m*l^2*u^2*(sin(q)*(sin(q_ground1)*sin(q_pin1)^2 + cos(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) +
    //   cos(q_ground1)*(sin(q_ground1)*(1 + cos(q_pin1)) - sin(q_pin1)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1)))))) - sin(q_pin1)^2 - cos(q)*(cos(q_ground1)*(2 - 5*sin(q_pin1)^2
    //   + 2*cos(q_pin1) + cos(q)*(3*sin(q_pin1)*(2*cos(q)*sin(q_pin1) + sin(q)*(1 + 2*cos(q_pin1))) -
    //   3*cos(q)*(1 + cos(q_pin1)) - 4*cos(q_ground1)*(sin(q_pin1)*(sin(q)*(2*sin(q_ground1)*sin(q_pin1) +
    //   cos(q_ground1)*(1 + 2*cos(q_pin1))) + cos(q)*(2*cos(q_ground1)*sin(q_pin1) - sin(q_ground1)*(1 +
    //   2*cos(q_pin1)))) - sin(q)*sin(q_ground1) - cos(q)*cos(q_ground1) -
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))) - 3*cos(q_ground1)*(cos(q_ground1)*(1
    //   + cos(q_pin1)) + sin(q_pin1)*(sin(q_ground1)*(1 + 2*cos(q_pin1)) - 2*cos(q_ground1)*sin(q_pin1)))) +
    //   sin(q_ground1)*(2*sin(q_pin1)*cos(q_pin1) - cos(q)*(sin(q)*(1 + cos(q_pin1)) +
    //   sin(q_pin1)*(cos(q)*(1 + 2*cos(q_pin1)) -
    //   2*sin(q)*sin(q_pin1))))))/(12*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^3)
    let f_12 = l_m_l_by_12 * m_11_1_of_place_3 * u_2_m_11_1_of_place_3 * u_2_m_11_1_of_place_3
        * (sin_q
            * (cos_q_ground1
                * (cos_q_ground1
                    * (-f_12_of_place)
                        .mul_add(sin_q_pin1, f_12_of_q_pin1_2 * sin_q_ground1)
                    + f_12_of_q_pin1_3) + sin_q_pin1_sq * sin_q_ground1) - sin_q_pin1_sq
            - cos_q
                * (cos_q_ground1
                    * (S::int(2) + cos_q_pin1_doubled
                        + S::int(3) * cos_q_ground1
                            * (-f_12_of_q_pin1_2)
                                .mul_add(cos_q_ground1, f_12_of_place_2 * sin_q_pin1)
                        + cos_q
                            * (-S::int(4) * cos_q_ground1
                                * (sin_q_pin1
                                    * f_12_of_place_2.mul_add(cos_q, f_12_of_place * sin_q)
                                    - m_11_1_of_place_2 * f_12_of_q_pin1_2)
                                + S::int(3) * f_12_of_q_2_q_pin1) - S::int(5) * sin_q_pin1_sq)
                    + sin_q_ground1
                        * (f_12_of_q_pin1_3
                            - cos_q
                                * (sin_q_pin1
                                    * (-sin_q_pin1_doubled)
                                        .mul_add(sin_q, f_12_of_q_pin1 * cos_q)
                                    + f_12_of_q_pin1_2 * sin_q))));
    // f_13 = m*l*u^2*sin(q_pin1)^2*cos(q_pin2)/sin(q - q_ground1 + q_pin1)^2 - m*g*sin(q_ground1 + q_pin2)
    //   + m*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(2*sin(q - q_ground1 + q_pin1)) -
    //   m*sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))
    let f_13 = (-m_13_5_of_place).mul_add(m_g, m_l * f_4_of_u_2_sq * cos_q_pin2)
        + m_l_halved * f_13_of_u_2 * f_13_of_u_2 - m_l_f_13_of_u_2_2 * sin_q_pin2;
    // f_14 = m*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1) - l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1))
    //   - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 - l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))/2 - m*g*cos(q_ground1 + q_pin2) -
    //   m*l*u^2*sin(q_pin1)^2*sin(q_pin2)/sin(q - q_ground1 + q_pin1)^2 -
    //   m*cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))
    let f_14 = (-sin_q_pin2_m_l).mul_add(f_4_of_u_2_sq, -m_13_4_of_place * m_g)
        - m_l_f_13_of_u_2_2 * cos_q_pin2 - l * m_halved * f_14_of_u_2;
    // f_15 = m*l^2*u^2*cos(q_pin1)*(cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(12*sin(q - q_ground1 + q_pin1)^2) + m*l^2*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(12*sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))
    //   + m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 -
    //   q_ground2 + q_pin2)) + (cos(q_ground2)*(u*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   cos(q_ground1 + q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))) -
    //   u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1) + sin(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
    //   u*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_ground2)*(u*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + sin(q_ground1 +
    //   q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(12*sin(q - q_ground1 + q_pin1))
    let f_15 = -l_m_l_by_12 * f_14_of_u_2;
    let zero = S::int(0);
    (
        [
            zero, zero, zero, zero, zero, zero, zero, m_1_8, zero, zero, zero, zero, zero, m_1_14,
            m_1_15, m_2_1, zero, zero, zero, zero, zero, zero, zero, m_2_9, zero, zero, zero, zero,
            m_2_14, m_2_15, m_3_1, zero, zero, zero, zero, zero, zero, zero, m_3_9, zero, zero,
            zero, zero, m_3_14, m_3_15, zero, m_4_2, m_4_3, zero, zero, m_4_6, zero, zero, zero,
            zero, zero, m_4_12, m_4_13, zero, zero, m_5_1, m_5_2, m_5_3, zero, zero, zero, m_5_7,
            zero, zero, zero, zero, m_5_12, m_5_13, zero, zero, m_6_1, m_6_2, m_6_3, zero, zero,
            zero, m_6_7, zero, zero, zero, zero, m_6_12, m_6_13, zero, zero, zero, zero, zero,
            m_7_4, m_7_5, zero, zero, zero, zero, m_7_10, m_7_11, zero, zero, zero, zero, m_8_1,
            zero, zero, m_8_4, m_8_5, zero, zero, zero, zero, m_8_10, m_8_11, zero, zero, zero,
            zero, m_9_1, zero, zero, m_9_4, m_9_5, zero, zero, zero, zero, m_9_10, m_9_11, zero,
            zero, zero, zero, m_10_1, m_10_2, m_10_3, zero, zero, zero, zero, m_10_8, m_10_9, zero,
            zero, zero, zero, zero, zero, m_11_1, m_11_2, m_11_3, zero, zero, zero, zero, m_11_8,
            m_11_9, zero, zero, zero, zero, zero, zero, m_12_1, m_12_2, m_12_3, zero, zero, zero,
            zero, m_12_8, m_12_9, zero, zero, zero, zero, zero, zero, m_13_1, zero, zero, m_13_4,
            m_13_5, m_13_6, m_13_7, zero, zero, zero, zero, zero, zero, zero, zero, m_14_1, zero,
            zero, m_14_4, m_14_5, m_14_6, m_14_7, zero, zero, zero, zero, zero, zero, zero, zero,
            m_15_1, zero, zero, m_15_4, m_15_5, m_15_6, m_15_7, zero, zero, zero, zero, zero, zero,
            zero, zero,
        ],
        [
            f_1, f_2, zero, f_4, f_5, f_6, f_7, f_8, f_9, f_10, f_11, f_12, f_13, f_14, f_15,
        ],
    )
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 183 convolutions and 392 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 6]],
    history: &mut [Factors<S, 184>],
) {
    let Parameters { m, l, g } = *p;
    let [q_2_0, q_ground1_0, q_ground2_0, q_pin1_0, q_pin2_0, u_2_0] = series[0];
    // Shared terms.
    let m_l_sq = m * l * l;
    let m_g = m * g;
    let m_l_3 = m * l;
    // Constant in time.
    // minus_l = -l
    let minus_l = -l;
    // weight = 2*g
    let weight = S::int(2) * g;
    // weight_2 = 2*l
    let weight_2 = S::int(2) * l;
    // m_l = m*l
    let m_l = m_l_3;
    // weight_3 = 2*m*g
    let weight_3 = S::int(2) * m_g;
    // minus_2_m_l = -2*m*l
    let minus_2_m_l = -S::int(2) * m_l_3;
    // minus_m_l = -m*l
    let minus_m_l = -m_l_3;
    // minus_2_m_g = -2*m*g
    let minus_2_m_g = -S::int(2) * m_g;
    // weight_4 = 2*m*l
    let weight_4 = S::int(2) * m_l_3;
    // minus_2_m = -2*m
    let minus_2_m = -S::int(2) * m;
    // weight_5 = 2*m
    let weight_5 = S::int(2) * m;
    // m_l_2 = m*l^2
    let m_l_2 = m_l_sq;
    // minus_m_l_2 = -m*l^2
    let minus_m_l_2 = -m_l_sq;
    // weight_6 = 6*m*l*g
    let weight_6 = S::int(6) * m * l * g;
    // weight_7 = 3*m*l
    let weight_7 = S::int(3) * m_l_3;
    // weight_8 = 6*l
    let weight_8 = S::int(6) * l;
    // minus_6_l = -6*l
    let minus_6_l = -S::int(6) * l;
    // weight_9 = 3*l
    let weight_9 = S::int(3) * l;
    // minus_1_by_4_m_l_2 = -1/(4*m*l^2)
    let minus_1_by_4_m_l_2 = -S::ratio(1, 4) / (m * l * l);
    // Order 0.
    let (sin_q_pin1_0, cos_q_pin1_0) = q_pin1_0.sin_cos();
    let (sin_q_pin2_0, cos_q_pin2_0) = q_pin2_0.sin_cos();
    let (sin_q_0, cos_q_0) = q_2_0.sin_cos();
    let (sin_q_ground1_0, cos_q_ground1_0) = q_ground1_0.sin_cos();
    let d1_of_place_0 = q_2_0 + q_pin1_0 - q_ground1_0;
    let (sin_angle_0, cos_angle_0) = d1_of_place_0.sin_cos();
    let over_sin_angle = S::int(1) / sin_angle_0;
    let (sin_q_ground2_0, cos_q_ground2_0) = q_ground2_0.sin_cos();
    let q_ground1_plus_q_pin2_0 = q_ground1_0 + q_pin2_0;
    let (sin_q_ground1_plus_q_pin2_0, cos_q_ground1_plus_q_pin2_0) = q_ground1_plus_q_pin2_0
        .sin_cos();
    let d1_of_place_2_0 = q_ground1_0 + q_pin2_0 - q_ground2_0;
    let (sin_angle_2_0, cos_angle_2_0) = d1_of_place_2_0.sin_cos();
    let over_sin_angle_2 = S::int(1) / sin_angle_2_0;
    let d1_of_place_3_0 = sin_q_ground1_0 + sin_q_ground1_plus_q_pin2_0;
    let d1_of_place_4_0 = cos_q_ground1_0 + cos_q_ground1_plus_q_pin2_0;
    let sin_q_sin_q_ground1_0 = sin_q_0 * sin_q_ground1_0;
    let cos_q_cos_q_ground1_0 = cos_q_0 * cos_q_ground1_0;
    let d1_of_place_5_0 = sin_q_sin_q_ground1_0 + cos_q_cos_q_ground1_0;
    let d1_of_place_6_0 = sin_q_pin1_0 * d1_of_place_5_0;
    let sin_q_cos_q_ground1_0 = sin_q_0 * cos_q_ground1_0;
    let cos_q_sin_q_ground1_0 = cos_q_0 * sin_q_ground1_0;
    let d1_of_place_7_0 = sin_q_cos_q_ground1_0 - cos_q_sin_q_ground1_0;
    let d1_of_place_8_0 = cos_q_pin1_0 * d1_of_place_7_0;
    let d1_of_place_9_0 = d1_of_place_6_0 + d1_of_place_8_0;
    let over_d1_of_place_9 = S::int(1) / d1_of_place_9_0;
    let d1_of_place_10_0 = sin_q_ground2_0 * cos_q_ground1_plus_q_pin2_0;
    let d1_of_place_11_0 = cos_q_ground2_0 * d1_of_place_3_0;
    let d1_of_place_12_0 = cos_q_ground2_0 * over_sin_angle_2;
    let d1_of_place_13_0 = sin_q_ground1_plus_q_pin2_0 * d1_of_place_12_0;
    let d1_of_place_14_0 = cos_q_sin_q_ground1_0 * over_d1_of_place_9;
    let d1_of_place_15_0 = cos_q_sin_q_ground1_0
        .mul_add(-S::int(2), sin_q_cos_q_ground1_0);
    let d1_of_place_16_0 = cos_q_ground1_plus_q_pin2_0
        .mul_add(S::int(2), cos_q_ground1_0);
    let d1_of_place_17_0 = sin_q_ground2_0 * d1_of_place_16_0;
    let d1_of_place_18_0 = S::int(2) * d1_of_place_11_0 - d1_of_place_17_0;
    let d1_of_place_19_0 = cos_q_ground1_0 * d1_of_place_18_0;
    let d1_of_place_20_0 = d1_of_place_11_0.mul_add(-S::int(2), d1_of_place_10_0);
    let d1_of_place_21_0 = cos_q_ground1_plus_q_pin2_0 * d1_of_place_20_0;
    let d1_of_place_22_0 = d1_of_place_19_0 - d1_of_place_21_0;
    let d1_of_place_23_0 = sin_q_ground1_plus_q_pin2_0
        .mul_add(S::int(2), sin_q_ground1_0);
    let d1_of_place_24_0 = d1_of_place_22_0 * over_sin_angle_2;
    let d1_of_place_25_0 = cos_q_pin2_0 * d1_of_place_4_0;
    let d1_of_place_26_0 = d1_of_place_25_0
        .mul_add(
            S::int(3),
            cos_q_ground1_plus_q_pin2_0.mul_add(S::int(2), S::int(2) * cos_q_ground1_0),
        ) - d1_of_place_24_0;
    let d1_of_place_27_0 = sin_q_ground2_0 * d1_of_place_26_0;
    let d1_of_place_28_0 = d1_of_place_23_0 * d1_of_place_12_0;
    let d1_of_place_29_0 = cos_q_pin2_0.mul_add(S::int(3), S::int(2)) - d1_of_place_28_0;
    let d1_of_place_30_0 = sin_q_ground1_0 * d1_of_place_29_0;
    let d1_of_place_31_0 = cos_q_pin2_0.mul_add(S::int(3), S::int(2)) - d1_of_place_13_0;
    let d1_of_place_32_0 = sin_q_ground1_plus_q_pin2_0 * d1_of_place_31_0;
    let d1_of_place_33_0 = d1_of_place_30_0 + d1_of_place_32_0;
    let d1_of_place_34_0 = cos_q_ground2_0 * d1_of_place_33_0;
    let d1_of_place_35_0 = sin_q_pin2_0 * over_sin_angle_2;
    let d1_of_place_36_0 = sin_q_pin2_0 * d1_of_place_35_0;
    let d1_of_place_37_0 = d1_of_place_36_0 - d1_of_place_34_0 + d1_of_place_27_0;
    let d1_of_place_38_0 = d1_of_place_37_0 * over_sin_angle_2;
    let d1_of_place_39_0 = cos_q_pin2_0.mul_add(S::int(3), S::int(5)) + d1_of_place_38_0;
    let sin_q_pin1_sin_angle_inv_0 = sin_q_pin1_0 * over_sin_angle;
    let d1_of_place_40_0 = sin_q_pin1_sin_angle_inv_0 * sin_q_pin1_sin_angle_inv_0;
    let d1_of_place_41_0 = d1_of_place_39_0 * d1_of_place_40_0;
    let d1_of_place_42_0 = d1_of_place_15_0 * over_d1_of_place_9;
    let d1_of_place_43_0 = S::int(3) * cos_q_pin1_0 - d1_of_place_42_0;
    let d1_of_place_44_0 = d1_of_place_43_0 * sin_q_cos_q_ground1_0;
    let d1_of_place_45_0 = S::int(3) * cos_q_pin1_0 + d1_of_place_14_0;
    let d1_of_place_46_0 = d1_of_place_45_0 * cos_q_sin_q_ground1_0;
    let d1_of_place_47_0 = d1_of_place_44_0 - d1_of_place_46_0;
    let d1_of_place_48_0 = d1_of_place_47_0 * over_d1_of_place_9;
    let d1_of_place_49_0 = S::int(4) - d1_of_place_48_0 + d1_of_place_41_0;
    let over_d1_of_place_49 = S::int(1) / d1_of_place_49_0;
    let q_2_plus_q_pin1_0 = q_2_0 + q_pin1_0;
    let (sin_q_plus_q_pin1_0, cos_q_plus_q_pin1_0) = q_2_plus_q_pin1_0.sin_cos();
    let u_dot_of_q_pin1_0 = S::int(1) + cos_q_pin1_0;
    let u_dot_of_q_2_q_pin1_0 = cos_q_0 * u_dot_of_q_pin1_0;
    let sin_q_pin1_sin_q_0 = sin_q_pin1_0 * sin_q_0;
    let u_dot_of_q_2_q_pin1_2_0 = sin_q_0 * u_dot_of_q_pin1_0;
    let sin_q_pin1_cos_q_0 = sin_q_pin1_0 * cos_q_0;
    let u_dot_of_q_2_q_pin1_3_0 = sin_q_0 + sin_q_plus_q_pin1_0;
    let u_dot_of_q_2_q_pin1_4_0 = cos_q_0 + cos_q_plus_q_pin1_0;
    let u_dot_of_place_0 = cos_q_ground1_0 * u_dot_of_q_pin1_0;
    let sin_q_pin1_sin_q_ground1_0 = sin_q_pin1_0 * sin_q_ground1_0;
    let u_dot_of_place_2_0 = sin_q_ground1_0 * u_dot_of_q_pin1_0;
    let sin_q_pin1_cos_q_ground1_0 = sin_q_pin1_0 * cos_q_ground1_0;
    let u_dot_of_place_3_0 = sin_q_ground1_0 * u_dot_of_q_2_q_pin1_4_0;
    let u_dot_of_place_4_0 = cos_q_ground1_0 * u_dot_of_q_2_q_pin1_3_0;
    let u_dot_of_place_5_0 = u_dot_of_place_3_0 - u_dot_of_place_4_0;
    let u_dot_of_place_6_0 = sin_q_ground2_0 * d1_of_place_4_0;
    let u_dot_of_place_7_0 = u_dot_of_place_6_0 - d1_of_place_11_0;
    let u_2_sin_angle_inv_0 = u_2_0 * over_sin_angle;
    let q_ground1_dot_2_0 = sin_q_pin1_0 * u_2_sin_angle_inv_0;
    let q_ground2_dot_2_0 = q_ground1_dot_2_0 * d1_of_place_35_0;
    let u_dot_of_place_8_0 = u_dot_of_place_5_0 * over_sin_angle;
    let q_pin1_dot_2_0 = u_dot_of_place_5_0 * u_2_sin_angle_inv_0;
    let u_dot_of_place_9_0 = u_dot_of_place_7_0 * over_sin_angle_2;
    let q_pin2_dot_2_0 = q_ground1_dot_2_0 * u_dot_of_place_9_0;
    let u_dot_of_u_2_0 = u_2_0 + q_pin1_dot_2_0;
    let u_dot_of_place_10_0 = S::int(1) + u_dot_of_place_8_0;
    let u_dot_of_u_2_2_0 = q_ground1_dot_2_0 + q_pin2_dot_2_0;
    let u_dot_of_place_11_0 = S::int(1) + u_dot_of_place_9_0;
    let u_dot_of_u_2_3_0 = u_2_0 - q_ground1_dot_2_0 + q_pin1_dot_2_0;
    let u_dot_of_place_12_0 = cos_q_pin1_0 * u_dot_of_place_5_0;
    let u_2_sq_sin_angle_inv2_0 = u_2_sin_angle_inv_0 * u_2_sin_angle_inv_0;
    let u_dot_of_u_2_4_0 = u_dot_of_place_12_0 * u_2_sq_sin_angle_inv2_0;
    let u_dot_of_u_2_5_0 = q_ground1_dot_2_0 * over_sin_angle;
    let u_dot_of_u_2_6_0 = cos_angle_0 * u_dot_of_u_2_3_0;
    let u_dot_of_u_2_7_0 = u_dot_of_u_2_5_0 * u_dot_of_u_2_6_0;
    let u_dot_of_u_2_8_0 = q_ground1_dot_2_0 - q_ground2_dot_2_0 + q_pin2_dot_2_0;
    let u_dot_of_u_2_9_0 = cos_q_ground1_0 * q_ground1_dot_2_0;
    let u_dot_of_u_2_10_0 = sin_q_ground1_0 * q_ground1_dot_2_0;
    let u_2_cos_q_sin_q_ground1_0 = u_2_0 * cos_q_sin_q_ground1_0;
    let u_dot_of_u_2_11_0 = q_ground1_dot_2_0 * sin_q_cos_q_ground1_0;
    let u_2_sin_q_cos_q_ground1_0 = u_2_0 * sin_q_cos_q_ground1_0;
    let u_dot_of_u_2_12_0 = q_ground1_dot_2_0 * cos_q_sin_q_ground1_0;
    let u_dot_of_u_2_13_0 = u_2_cos_q_sin_q_ground1_0 - u_2_sin_q_cos_q_ground1_0
        + u_dot_of_u_2_11_0 - u_dot_of_u_2_12_0;
    let u_dot_of_u_2_14_0 = d1_of_place_5_0 * u_2_sin_angle_inv_0;
    let u_dot_of_u_2_15_0 = u_dot_of_place_12_0 * u_dot_of_u_2_14_0;
    let u_dot_of_u_2_16_0 = sin_q_pin1_0 * u_dot_of_u_2_13_0;
    let u_2_cos_q_cos_q_ground1_0 = u_2_0 * cos_q_cos_q_ground1_0;
    let u_dot_of_u_2_17_0 = q_ground1_dot_2_0 * sin_q_sin_q_ground1_0;
    let u_2_sin_q_sin_q_ground1_0 = u_2_0 * sin_q_sin_q_ground1_0;
    let u_dot_of_u_2_18_0 = q_ground1_dot_2_0 * cos_q_cos_q_ground1_0;
    let u_dot_of_u_2_19_0 = u_2_cos_q_cos_q_ground1_0 + u_2_sin_q_sin_q_ground1_0
        - u_dot_of_u_2_17_0 - u_dot_of_u_2_18_0;
    let u_dot_of_place_13_0 = d1_of_place_7_0 * u_dot_of_place_5_0;
    let u_dot_of_u_2_20_0 = q_ground1_dot_2_0 * u_dot_of_place_13_0;
    let u_dot_of_u_2_21_0 = cos_q_pin1_0 * u_dot_of_u_2_19_0;
    let u_dot_of_u_2_22_0 = u_dot_of_u_2_15_0 - u_dot_of_u_2_20_0 + u_dot_of_u_2_16_0
        + u_dot_of_u_2_21_0;
    let u_dot_of_u_2_23_0 = u_2_0 * over_d1_of_place_9;
    let u_dot_of_u_2_24_0 = u_dot_of_u_2_19_0 * u_dot_of_u_2_23_0;
    let u_dot_of_place_14_0 = d1_of_place_7_0 * over_d1_of_place_9;
    let u_dot_of_u_2_25_0 = u_dot_of_u_2_23_0 * u_dot_of_place_14_0;
    let u_dot_of_u_2_26_0 = u_dot_of_u_2_22_0 * u_dot_of_u_2_25_0;
    let u_dot_of_u_2_27_0 = d1_of_place_7_0 * u_dot_of_u_2_0;
    let u_dot_of_u_2_28_0 = u_dot_of_u_2_23_0 * u_dot_of_u_2_27_0;
    let u_dot_of_u_2_29_0 = cos_q_ground1_plus_q_pin2_0 * u_dot_of_u_2_2_0;
    let u_dot_of_u_2_30_0 = sin_q_ground1_plus_q_pin2_0 * u_dot_of_u_2_2_0;
    let u_dot_of_u_2_31_0 = u_dot_of_u_2_9_0 + u_dot_of_u_2_29_0;
    let u_dot_of_place_15_0 = cos_q_ground2_0 * d1_of_place_4_0;
    let u_dot_of_u_2_32_0 = q_ground2_dot_2_0 * u_dot_of_place_15_0;
    let u_dot_of_u_2_33_0 = u_dot_of_u_2_10_0 + u_dot_of_u_2_30_0;
    let u_dot_of_u_2_34_0 = sin_q_ground2_0 * u_dot_of_u_2_33_0;
    let u_dot_of_place_16_0 = sin_q_ground2_0 * d1_of_place_3_0;
    let u_dot_of_u_2_35_0 = q_ground2_dot_2_0 * u_dot_of_place_16_0;
    let u_dot_of_u_2_36_0 = cos_q_ground2_0 * u_dot_of_u_2_31_0;
    let u_dot_of_u_2_37_0 = u_dot_of_u_2_32_0 + u_dot_of_u_2_35_0 - u_dot_of_u_2_34_0
        - u_dot_of_u_2_36_0;
    let u_dot_of_place_17_0 = cos_angle_2_0 * over_sin_angle_2;
    let u_dot_of_place_18_0 = u_dot_of_place_9_0 * u_dot_of_place_17_0;
    let u_dot_of_u_2_38_0 = u_dot_of_u_2_8_0 * u_dot_of_place_18_0;
    let u_dot_of_u_2_39_0 = u_dot_of_u_2_37_0 * over_sin_angle_2;
    let u_dot_of_u_2_40_0 = u_dot_of_place_11_0 * u_dot_of_u_2_4_0;
    let u_dot_of_u_2_41_0 = u_dot_of_place_11_0 * u_dot_of_u_2_7_0;
    let u_dot_of_u_2_42_0 = u_dot_of_u_2_38_0 - u_dot_of_u_2_39_0;
    let u_dot_of_u_2_43_0 = u_dot_of_u_2_42_0 * q_ground1_dot_2_0;
    let u_dot_of_u_2_44_0 = u_dot_of_place_11_0 * q_ground1_dot_2_0;
    let u_dot_of_u_2_45_0 = u_dot_of_u_2_2_0 * u_dot_of_u_2_44_0;
    let u_dot_of_u_2_46_0 = u_dot_of_u_2_7_0.mul_add(minus_l, l * u_dot_of_u_2_4_0);
    let u_dot_of_place_19_0 = sin_q_pin1_0 + u_dot_of_place_4_0 - u_dot_of_place_3_0;
    let u_dot_of_place_20_0 = u_dot_of_place_19_0 * over_sin_angle;
    let u_dot_of_place_21_0 = -S::int(1) + u_dot_of_place_20_0;
    let sin_q_pin1_cos_angle_0 = sin_q_pin1_0 * cos_angle_0;
    let u_dot_of_place_22_0 = u_dot_of_place_21_0 * sin_q_pin1_cos_angle_0;
    let u_dot_of_place_23_0 = u_dot_of_place_12_0 + u_dot_of_place_22_0;
    let u_dot_of_u_2_47_0 = u_dot_of_place_23_0 * u_2_sq_sin_angle_inv2_0;
    let u_dot_of_u_2_48_0 = u_dot_of_u_2_47_0.mul_add(l, weight * cos_q_ground1_0);
    let u_dot_of_place_24_0 = sin_q_pin2_0 + d1_of_place_11_0 - u_dot_of_place_6_0;
    let u_dot_of_place_25_0 = u_dot_of_place_24_0 * over_sin_angle_2;
    let u_dot_of_place_26_0 = -S::int(1) + u_dot_of_place_25_0;
    let u_dot_of_place_27_0 = u_dot_of_place_26_0 * u_dot_of_place_17_0;
    let sin_angle_inv_cos_angle_0 = cos_angle_0 * over_sin_angle;
    let u_dot_of_place_28_0 = sin_angle_inv_cos_angle_0 + u_dot_of_place_27_0;
    let u_dot_of_place_29_0 = sin_q_pin1_0 * u_dot_of_place_28_0;
    let u_dot_of_place_30_0 = cos_angle_0 * u_dot_of_place_10_0;
    let u_dot_of_place_31_0 = -u_dot_of_place_30_0 + u_dot_of_place_29_0;
    let u_dot_of_place_32_0 = sin_q_pin2_0 * u_dot_of_place_31_0;
    let sin_q_pin1_cos_q_pin2_0 = sin_q_pin1_0 * cos_q_pin2_0;
    let u_dot_of_place_33_0 = u_dot_of_place_9_0 * sin_q_pin1_cos_q_pin2_0;
    let u_dot_of_place_34_0 = u_dot_of_place_33_0 + u_dot_of_place_32_0;
    let u_dot_of_place_35_0 = sin_q_pin1_0 * u_dot_of_place_34_0;
    let u_dot_of_place_36_0 = sin_q_pin2_0 * u_dot_of_place_12_0;
    let u_dot_of_place_37_0 = u_dot_of_place_36_0 + u_dot_of_place_35_0;
    let u_dot_of_place_38_0 = u_dot_of_place_37_0 * over_sin_angle_2;
    let u_dot_of_u_2_49_0 = u_2_sq_sin_angle_inv2_0 * u_dot_of_place_38_0;
    let u_dot_of_u_2_50_0 = u_dot_of_u_2_49_0.mul_add(l, weight * cos_q_ground2_0);
    let u_2_sq_0 = u_2_0 * u_2_0;
    let u_2_sq_cos_q_pin1_0 = cos_q_pin1_0 * u_2_sq_0;
    let u_dot_of_place_39_0 = cos_q_pin1_0 * d1_of_place_5_0;
    let u_2_sq_sin_q_pin1_0 = sin_q_pin1_0 * u_2_sq_0;
    let u_dot_of_q_pin1_2_0 = cos_q_pin1_0.mul_add(S::int(2), S::int(1));
    let u_dot_of_place_40_0 = cos_q_ground1_0 * u_dot_of_q_pin1_2_0;
    let u_dot_of_place_41_0 = S::int(2) * sin_q_pin1_sin_q_ground1_0 + u_dot_of_place_40_0;
    let u_dot_of_place_42_0 = sin_q_0 * u_dot_of_place_41_0;
    let u_dot_of_place_43_0 = sin_q_ground1_0 * u_dot_of_q_pin1_2_0;
    let u_dot_of_place_44_0 = S::int(2) * sin_q_pin1_cos_q_ground1_0 - u_dot_of_place_43_0;
    let u_dot_of_place_45_0 = cos_q_0 * u_dot_of_place_44_0;
    let u_dot_of_place_46_0 = u_dot_of_place_42_0 + u_dot_of_place_45_0;
    let u_dot_of_place_47_0 = sin_q_pin1_0 * u_dot_of_place_46_0;
    let u_dot_of_place_48_0 = sin_q_sin_q_ground1_0 + cos_q_cos_q_ground1_0
        + u_dot_of_place_39_0 - u_dot_of_place_47_0;
    let u_dot_of_place_49_0 = cos_q_ground1_0 * u_dot_of_place_48_0;
    let u_dot_of_q_2_q_pin1_5_0 = sin_q_0 * u_dot_of_q_pin1_2_0;
    let u_dot_of_q_2_q_pin1_6_0 = S::int(2) * sin_q_pin1_cos_q_0 + u_dot_of_q_2_q_pin1_5_0;
    let u_dot_of_q_2_q_pin1_7_0 = sin_q_pin1_0 * u_dot_of_q_2_q_pin1_6_0;
    let u_dot_of_place_50_0 = u_dot_of_place_49_0
        .mul_add(
            -S::int(4),
            u_dot_of_q_2_q_pin1_7_0
                .mul_add(-S::int(3), S::int(3) * u_dot_of_q_2_q_pin1_0),
        );
    let u_dot_of_place_51_0 = cos_q_0 * u_dot_of_place_50_0;
    let u_dot_of_place_52_0 = sin_q_pin1_0 * u_dot_of_place_44_0;
    let u_dot_of_place_53_0 = u_dot_of_place_0 - u_dot_of_place_52_0;
    let u_dot_of_place_54_0 = cos_q_ground1_0 * u_dot_of_place_53_0;
    let sin_q_pin1_sq_0 = sin_q_pin1_0 * sin_q_pin1_0;
    let u_dot_of_place_55_0 = u_dot_of_place_54_0
        .mul_add(
            -S::int(3),
            sin_q_pin1_sq_0
                .mul_add(-S::int(5), cos_q_pin1_0.mul_add(S::int(2), S::int(2))),
        ) - u_dot_of_place_51_0;
    let u_dot_of_place_56_0 = cos_q_ground1_0 * u_dot_of_place_55_0;
    let u_dot_of_q_2_q_pin1_8_0 = cos_q_0 * u_dot_of_q_pin1_2_0;
    let u_dot_of_q_2_q_pin1_9_0 = S::int(2) * sin_q_pin1_sin_q_0 - u_dot_of_q_2_q_pin1_8_0;
    let u_dot_of_q_2_q_pin1_10_0 = sin_q_pin1_0 * u_dot_of_q_2_q_pin1_9_0;
    let u_dot_of_q_2_q_pin1_11_0 = u_dot_of_q_2_q_pin1_2_0 - u_dot_of_q_2_q_pin1_10_0;
    let u_dot_of_q_2_q_pin1_12_0 = cos_q_0 * u_dot_of_q_2_q_pin1_11_0;
    let sin_q_pin1_cos_q_pin1_0 = sin_q_pin1_0 * cos_q_pin1_0;
    let u_dot_of_q_2_q_pin1_13_0 = -S::int(2) * sin_q_pin1_cos_q_pin1_0 + u_dot_of_q_2_q_pin1_12_0;
    let u_dot_of_place_57_0 = sin_q_ground1_0 * u_dot_of_q_2_q_pin1_13_0;
    let u_dot_of_place_58_0 = -u_dot_of_place_57_0 + u_dot_of_place_56_0;
    let u_dot_of_place_59_0 = cos_q_0 * u_dot_of_place_58_0;
    let u_dot_of_place_60_0 = sin_q_pin1_0 * u_dot_of_place_41_0;
    let u_dot_of_place_61_0 = u_dot_of_place_2_0 - u_dot_of_place_60_0;
    let u_dot_of_place_62_0 = cos_q_ground1_0 * u_dot_of_place_61_0;
    let u_dot_of_place_63_0 = S::int(2) * sin_q_pin1_cos_q_pin1_0 + u_dot_of_place_62_0;
    let u_dot_of_place_64_0 = cos_q_ground1_0 * u_dot_of_place_63_0;
    let u_dot_of_place_65_0 = sin_q_pin1_0 * sin_q_pin1_sin_q_ground1_0;
    let u_dot_of_place_66_0 = u_dot_of_place_65_0 + u_dot_of_place_64_0;
    let u_dot_of_place_67_0 = sin_q_0 * u_dot_of_place_66_0;
    let u_dot_of_place_68_0 = sin_q_pin1_sq_0 - u_dot_of_place_67_0 + u_dot_of_place_59_0;
    let u_dot_of_u_2_51_0 = q_ground1_dot_2_0 * q_ground1_dot_2_0;
    let u_dot_of_u_2_52_0 = cos_q_pin2_0 * u_dot_of_u_2_51_0;
    let u_dot_of_u_2_53_0 = sin_q_pin2_0 * u_dot_of_u_2_46_0;
    let u_dot_of_u_2_54_0 = sin_q_pin2_0 * u_dot_of_u_2_51_0;
    let u_dot_of_u_2_55_0 = cos_q_pin2_0 * u_dot_of_u_2_46_0;
    let u_dot_of_place_69_0 = cos_q_pin2_0.mul_add(S::int(2), S::int(1)) + u_dot_of_place_9_0;
    let u_dot_of_place_70_0 = u_dot_of_place_14_0
        .mul_add(minus_l, weight_2 * cos_q_pin1_0);
    let u_dot_of_u_2_56_0 = u_dot_of_u_2_48_0 * sin_q_pin1_sin_angle_inv_0;
    let u_dot_of_u_2_57_0 = u_2_sin_angle_inv_0 * u_dot_of_u_2_5_0;
    let u_dot_of_u_2_58_0 = u_dot_of_place_23_0 * u_dot_of_u_2_57_0;
    let u_dot_of_place_71_0 = d1_of_place_35_0 * sin_q_pin1_sin_angle_inv_0;
    let u_dot_of_u_2_59_0 = u_dot_of_u_2_50_0 * u_dot_of_place_71_0;
    let u_dot_of_u_2_60_0 = d1_of_place_35_0 * u_dot_of_u_2_57_0;
    let u_dot_of_u_2_61_0 = u_dot_of_place_38_0 * u_dot_of_u_2_60_0;
    let u_dot_of_u_2_62_0 = u_dot_of_u_2_28_0
        .mul_add(
            m_l,
            u_2_sq_cos_q_pin1_0.mul_add(minus_2_m_l, weight_3 * sin_q_plus_q_pin1_0),
        );
    let u_dot_of_u_2_63_0 = sin_q_pin1_0 * u_dot_of_u_2_62_0;
    let u_dot_of_u_2_64_0 = u_dot_of_u_2_26_0
        .mul_add(
            minus_m_l,
            u_dot_of_u_2_24_0
                .mul_add(
                    m_l,
                    u_2_sq_sin_q_pin1_0
                        .mul_add(minus_2_m_l, minus_2_m_g * cos_q_plus_q_pin1_0),
                ),
        );
    let u_dot_of_u_2_65_0 = u_dot_of_place_70_0 * u_dot_of_u_2_64_0;
    let u_dot_of_place_72_0 = d1_of_place_9_0 * d1_of_place_9_0;
    let u_dot_of_place_73_0 = u_dot_of_place_72_0 * u_dot_of_place_72_0;
    let over_u_dot_of_place_73 = S::int(1) / u_dot_of_place_73_0;
    let u_dot_of_u_2_66_0 = d1_of_place_7_0 * u_2_sq_0;
    let u_dot_of_u_2_67_0 = u_dot_of_u_2_66_0 * over_u_dot_of_place_73;
    let u_dot_of_u_2_68_0 = u_dot_of_place_68_0 * u_dot_of_u_2_67_0;
    let u_dot_of_u_2_69_0 = u_dot_of_u_2_53_0
        .mul_add(
            minus_2_m,
            u_dot_of_u_2_45_0
                .mul_add(
                    m_l,
                    u_dot_of_u_2_52_0
                        .mul_add(weight_4, minus_2_m_g * sin_q_ground1_plus_q_pin2_0),
                ),
        );
    let u_dot_of_place_74_0 = sin_q_pin2_0 * sin_q_pin1_sin_angle_inv_0;
    let u_dot_of_u_2_70_0 = u_dot_of_u_2_69_0 * u_dot_of_place_74_0;
    let u_dot_of_u_2_71_0 = u_dot_of_u_2_43_0
        .mul_add(
            minus_m_l,
            u_dot_of_u_2_55_0
                .mul_add(
                    weight_5,
                    u_dot_of_u_2_41_0
                        .mul_add(
                            minus_m_l,
                            u_dot_of_u_2_40_0
                                .mul_add(
                                    m_l,
                                    u_dot_of_u_2_54_0
                                        .mul_add(weight_4, weight_3 * cos_q_ground1_plus_q_pin2_0),
                                ),
                        ),
                ),
        );
    let u_dot_of_place_75_0 = u_dot_of_place_69_0 * sin_q_pin1_sin_angle_inv_0;
    let u_dot_of_u_2_72_0 = u_dot_of_u_2_71_0 * u_dot_of_place_75_0;
    let u_dot_of_u_2_73_0 = u_dot_of_u_2_43_0
        .mul_add(
            minus_m_l_2,
            u_dot_of_u_2_41_0.mul_add(minus_m_l_2, m_l_2 * u_dot_of_u_2_40_0),
        );
    let u_dot_of_place_76_0 = u_dot_of_place_11_0 * sin_q_pin1_sin_angle_inv_0;
    let u_dot_of_u_2_74_0 = u_dot_of_u_2_73_0 * u_dot_of_place_76_0;
    let u_dot_of_u_2_75_0 = u_dot_of_u_2_59_0
        .mul_add(
            weight_7,
            u_dot_of_u_2_72_0
                .mul_add(
                    weight_9,
                    u_dot_of_u_2_68_0
                        .mul_add(
                            minus_m_l_2,
                            u_dot_of_u_2_61_0
                                .mul_add(
                                    m_l_2,
                                    u_dot_of_u_2_70_0
                                        .mul_add(
                                            minus_6_l,
                                            u_dot_of_u_2_65_0
                                                .mul_add(
                                                    -S::int(3),
                                                    u_dot_of_u_2_56_0
                                                        .mul_add(
                                                            weight_7,
                                                            u_dot_of_u_2_63_0
                                                                .mul_add(
                                                                    weight_8,
                                                                    u_dot_of_u_2_58_0.mul_add(m_l_2, weight_6 * cos_q_0),
                                                                ),
                                                        ),
                                                ),
                                        ),
                                ),
                        ),
                ) + u_dot_of_u_2_74_0,
        );
    let u_dot_of_u_2_76_0 = u_dot_of_u_2_75_0 * over_d1_of_place_49;
    // Order 1: the rates, and what follows from them.
    let q_2_1 = u_2_0;
    let q_ground1_1 = q_ground1_dot_2_0;
    let q_ground2_1 = q_ground2_dot_2_0;
    let q_pin1_1 = q_pin1_dot_2_0;
    let q_pin2_1 = q_pin2_dot_2_0;
    let u_2_1 = minus_1_by_4_m_l_2 * u_dot_of_u_2_76_0;
    if series.len() > 1 {
        series[1] = [q_2_1, q_ground1_1, q_ground2_1, q_pin1_1, q_pin2_1, u_2_1];
    }
    let sin_q_pin1_1 = q_pin1_1 * cos_q_pin1_0;
    let cos_q_pin1_1 = -q_pin1_1 * sin_q_pin1_0;
    let sin_q_pin2_1 = q_pin2_1 * cos_q_pin2_0;
    let cos_q_pin2_1 = -q_pin2_1 * sin_q_pin2_0;
    let sin_q_1 = q_2_1 * cos_q_0;
    let cos_q_1 = -q_2_1 * sin_q_0;
    let sin_q_ground1_1 = q_ground1_1 * cos_q_ground1_0;
    let cos_q_ground1_1 = -q_ground1_1 * sin_q_ground1_0;
    let d1_of_place_1 = q_2_1 + q_pin1_1 - q_ground1_1;
    let sin_angle_1 = d1_of_place_1 * cos_angle_0;
    let cos_angle_1 = -d1_of_place_1 * sin_angle_0;
    let sin_q_ground2_1 = q_ground2_1 * cos_q_ground2_0;
    let cos_q_ground2_1 = -q_ground2_1 * sin_q_ground2_0;
    let q_ground1_plus_q_pin2_1 = q_ground1_1 + q_pin2_1;
    let sin_q_ground1_plus_q_pin2_1 = q_ground1_plus_q_pin2_1 * cos_q_ground1_plus_q_pin2_0;
    let cos_q_ground1_plus_q_pin2_1 = -q_ground1_plus_q_pin2_1 * sin_q_ground1_plus_q_pin2_0;
    let d1_of_place_2_1 = q_ground1_1 + q_pin2_1 - q_ground2_1;
    let sin_angle_2_1 = d1_of_place_2_1 * cos_angle_2_0;
    let cos_angle_2_1 = -d1_of_place_2_1 * sin_angle_2_0;
    let d1_of_place_3_1 = sin_q_ground1_1 + sin_q_ground1_plus_q_pin2_1;
    let d1_of_place_4_1 = cos_q_ground1_1 + cos_q_ground1_plus_q_pin2_1;
    let sin_q_sin_q_ground1_1 = sin_q_ground1_1
        .mul_add(sin_q_0, sin_q_1 * sin_q_ground1_0);
    let cos_q_cos_q_ground1_1 = cos_q_ground1_1
        .mul_add(cos_q_0, cos_q_1 * cos_q_ground1_0);
    let d1_of_place_5_1 = sin_q_sin_q_ground1_1 + cos_q_cos_q_ground1_1;
    let d1_of_place_6_1 = d1_of_place_5_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * d1_of_place_5_0);
    let sin_q_cos_q_ground1_1 = cos_q_ground1_1
        .mul_add(sin_q_0, sin_q_1 * cos_q_ground1_0);
    let cos_q_sin_q_ground1_1 = sin_q_ground1_1
        .mul_add(cos_q_0, cos_q_1 * sin_q_ground1_0);
    let d1_of_place_7_1 = sin_q_cos_q_ground1_1 - cos_q_sin_q_ground1_1;
    let d1_of_place_8_1 = d1_of_place_7_1
        .mul_add(cos_q_pin1_0, cos_q_pin1_1 * d1_of_place_7_0);
    let d1_of_place_9_1 = d1_of_place_6_1 + d1_of_place_8_1;
    let d1_of_place_10_1 = cos_q_ground1_plus_q_pin2_1
        .mul_add(sin_q_ground2_0, sin_q_ground2_1 * cos_q_ground1_plus_q_pin2_0);
    let d1_of_place_11_1 = d1_of_place_3_1
        .mul_add(cos_q_ground2_0, cos_q_ground2_1 * d1_of_place_3_0);
    let d1_of_place_12_1 = sin_angle_2_1
        .mul_add(
            -(d1_of_place_12_0 * over_sin_angle_2),
            cos_q_ground2_1 * over_sin_angle_2,
        );
    let d1_of_place_13_1 = d1_of_place_12_1
        .mul_add(
            sin_q_ground1_plus_q_pin2_0,
            sin_q_ground1_plus_q_pin2_1 * d1_of_place_12_0,
        );
    let d1_of_place_14_1 = d1_of_place_9_1
        .mul_add(
            -(d1_of_place_14_0 * over_d1_of_place_9),
            cos_q_sin_q_ground1_1 * over_d1_of_place_9,
        );
    let d1_of_place_15_1 = cos_q_sin_q_ground1_1
        .mul_add(-S::int(2), sin_q_cos_q_ground1_1);
    let d1_of_place_16_1 = cos_q_ground1_plus_q_pin2_1
        .mul_add(S::int(2), cos_q_ground1_1);
    let d1_of_place_17_1 = d1_of_place_16_1
        .mul_add(sin_q_ground2_0, sin_q_ground2_1 * d1_of_place_16_0);
    let d1_of_place_18_1 = S::int(2) * d1_of_place_11_1 - d1_of_place_17_1;
    let d1_of_place_19_1 = d1_of_place_18_1
        .mul_add(cos_q_ground1_0, cos_q_ground1_1 * d1_of_place_18_0);
    let d1_of_place_20_1 = d1_of_place_11_1.mul_add(-S::int(2), d1_of_place_10_1);
    let d1_of_place_21_1 = d1_of_place_20_1
        .mul_add(
            cos_q_ground1_plus_q_pin2_0,
            cos_q_ground1_plus_q_pin2_1 * d1_of_place_20_0,
        );
    let d1_of_place_22_1 = d1_of_place_19_1 - d1_of_place_21_1;
    let d1_of_place_23_1 = sin_q_ground1_plus_q_pin2_1
        .mul_add(S::int(2), sin_q_ground1_1);
    let d1_of_place_24_1 = sin_angle_2_1
        .mul_add(
            -(d1_of_place_24_0 * over_sin_angle_2),
            d1_of_place_22_1 * over_sin_angle_2,
        );
    let d1_of_place_25_1 = d1_of_place_4_1
        .mul_add(cos_q_pin2_0, cos_q_pin2_1 * d1_of_place_4_0);
    let d1_of_place_26_1 = d1_of_place_25_1
        .mul_add(
            S::int(3),
            cos_q_ground1_plus_q_pin2_1.mul_add(S::int(2), S::int(2) * cos_q_ground1_1),
        ) - d1_of_place_24_1;
    let d1_of_place_27_1 = d1_of_place_26_1
        .mul_add(sin_q_ground2_0, sin_q_ground2_1 * d1_of_place_26_0);
    let d1_of_place_28_1 = d1_of_place_12_1
        .mul_add(d1_of_place_23_0, d1_of_place_23_1 * d1_of_place_12_0);
    let d1_of_place_29_1 = S::int(3) * cos_q_pin2_1 - d1_of_place_28_1;
    let d1_of_place_30_1 = d1_of_place_29_1
        .mul_add(sin_q_ground1_0, sin_q_ground1_1 * d1_of_place_29_0);
    let d1_of_place_31_1 = S::int(3) * cos_q_pin2_1 - d1_of_place_13_1;
    let d1_of_place_32_1 = d1_of_place_31_1
        .mul_add(
            sin_q_ground1_plus_q_pin2_0,
            sin_q_ground1_plus_q_pin2_1 * d1_of_place_31_0,
        );
    let d1_of_place_33_1 = d1_of_place_30_1 + d1_of_place_32_1;
    let d1_of_place_34_1 = d1_of_place_33_1
        .mul_add(cos_q_ground2_0, cos_q_ground2_1 * d1_of_place_33_0);
    let d1_of_place_35_1 = sin_angle_2_1
        .mul_add(
            -(d1_of_place_35_0 * over_sin_angle_2),
            sin_q_pin2_1 * over_sin_angle_2,
        );
    let d1_of_place_36_1 = d1_of_place_35_1
        .mul_add(sin_q_pin2_0, sin_q_pin2_1 * d1_of_place_35_0);
    let d1_of_place_37_1 = d1_of_place_36_1 - d1_of_place_34_1 + d1_of_place_27_1;
    let d1_of_place_38_1 = sin_angle_2_1
        .mul_add(
            -(d1_of_place_38_0 * over_sin_angle_2),
            d1_of_place_37_1 * over_sin_angle_2,
        );
    let d1_of_place_39_1 = S::int(3) * cos_q_pin2_1 + d1_of_place_38_1;
    let sin_q_pin1_sin_angle_inv_1 = sin_angle_1
        .mul_add(
            -(sin_q_pin1_sin_angle_inv_0 * over_sin_angle),
            sin_q_pin1_1 * over_sin_angle,
        );
    let d1_of_place_40_1 = sin_q_pin1_sin_angle_inv_1
        * (sin_q_pin1_sin_angle_inv_0 + sin_q_pin1_sin_angle_inv_0);
    let d1_of_place_41_1 = d1_of_place_39_1
        .mul_add(d1_of_place_40_0, d1_of_place_40_1 * d1_of_place_39_0);
    let d1_of_place_42_1 = d1_of_place_9_1
        .mul_add(
            -(d1_of_place_42_0 * over_d1_of_place_9),
            d1_of_place_15_1 * over_d1_of_place_9,
        );
    let d1_of_place_43_1 = S::int(3) * cos_q_pin1_1 - d1_of_place_42_1;
    let d1_of_place_44_1 = d1_of_place_43_1
        .mul_add(sin_q_cos_q_ground1_0, sin_q_cos_q_ground1_1 * d1_of_place_43_0);
    let d1_of_place_45_1 = S::int(3) * cos_q_pin1_1 + d1_of_place_14_1;
    let d1_of_place_46_1 = d1_of_place_45_1
        .mul_add(cos_q_sin_q_ground1_0, cos_q_sin_q_ground1_1 * d1_of_place_45_0);
    let d1_of_place_47_1 = d1_of_place_44_1 - d1_of_place_46_1;
    let d1_of_place_48_1 = d1_of_place_9_1
        .mul_add(
            -(d1_of_place_48_0 * over_d1_of_place_9),
            d1_of_place_47_1 * over_d1_of_place_9,
        );
    let d1_of_place_49_1 = -d1_of_place_48_1 + d1_of_place_41_1;
    let q_2_plus_q_pin1_1 = q_2_1 + q_pin1_1;
    let sin_q_plus_q_pin1_1 = q_2_plus_q_pin1_1 * cos_q_plus_q_pin1_0;
    let cos_q_plus_q_pin1_1 = -q_2_plus_q_pin1_1 * sin_q_plus_q_pin1_0;
    let u_dot_of_q_pin1_1 = cos_q_pin1_1;
    let u_dot_of_q_2_q_pin1_1 = u_dot_of_q_pin1_1
        .mul_add(cos_q_0, cos_q_1 * u_dot_of_q_pin1_0);
    let sin_q_pin1_sin_q_1 = sin_q_1.mul_add(sin_q_pin1_0, sin_q_pin1_1 * sin_q_0);
    let u_dot_of_q_2_q_pin1_2_1 = u_dot_of_q_pin1_1
        .mul_add(sin_q_0, sin_q_1 * u_dot_of_q_pin1_0);
    let sin_q_pin1_cos_q_1 = cos_q_1.mul_add(sin_q_pin1_0, sin_q_pin1_1 * cos_q_0);
    let u_dot_of_q_2_q_pin1_3_1 = sin_q_1 + sin_q_plus_q_pin1_1;
    let u_dot_of_q_2_q_pin1_4_1 = cos_q_1 + cos_q_plus_q_pin1_1;
    let u_dot_of_place_1 = u_dot_of_q_pin1_1
        .mul_add(cos_q_ground1_0, cos_q_ground1_1 * u_dot_of_q_pin1_0);
    let sin_q_pin1_sin_q_ground1_1 = sin_q_ground1_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * sin_q_ground1_0);
    let u_dot_of_place_2_1 = u_dot_of_q_pin1_1
        .mul_add(sin_q_ground1_0, sin_q_ground1_1 * u_dot_of_q_pin1_0);
    let sin_q_pin1_cos_q_ground1_1 = cos_q_ground1_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * cos_q_ground1_0);
    let u_dot_of_place_3_1 = u_dot_of_q_2_q_pin1_4_1
        .mul_add(sin_q_ground1_0, sin_q_ground1_1 * u_dot_of_q_2_q_pin1_4_0);
    let u_dot_of_place_4_1 = u_dot_of_q_2_q_pin1_3_1
        .mul_add(cos_q_ground1_0, cos_q_ground1_1 * u_dot_of_q_2_q_pin1_3_0);
    let u_dot_of_place_5_1 = u_dot_of_place_3_1 - u_dot_of_place_4_1;
    let u_dot_of_place_6_1 = d1_of_place_4_1
        .mul_add(sin_q_ground2_0, sin_q_ground2_1 * d1_of_place_4_0);
    let u_dot_of_place_7_1 = u_dot_of_place_6_1 - d1_of_place_11_1;
    let u_2_sin_angle_inv_1 = sin_angle_1
        .mul_add(-(u_2_sin_angle_inv_0 * over_sin_angle), u_2_1 * over_sin_angle);
    let q_ground1_dot_2_1 = u_2_sin_angle_inv_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * u_2_sin_angle_inv_0);
    let q_ground2_dot_2_1 = q_ground1_dot_2_1
        .mul_add(d1_of_place_35_0, d1_of_place_35_1 * q_ground1_dot_2_0);
    let u_dot_of_place_8_1 = sin_angle_1
        .mul_add(
            -(u_dot_of_place_8_0 * over_sin_angle),
            u_dot_of_place_5_1 * over_sin_angle,
        );
    let q_pin1_dot_2_1 = u_dot_of_place_5_1
        .mul_add(u_2_sin_angle_inv_0, u_2_sin_angle_inv_1 * u_dot_of_place_5_0);
    let u_dot_of_place_9_1 = sin_angle_2_1
        .mul_add(
            -(u_dot_of_place_9_0 * over_sin_angle_2),
            u_dot_of_place_7_1 * over_sin_angle_2,
        );
    let q_pin2_dot_2_1 = u_dot_of_place_9_1
        .mul_add(q_ground1_dot_2_0, q_ground1_dot_2_1 * u_dot_of_place_9_0);
    let u_dot_of_u_2_1 = u_2_1 + q_pin1_dot_2_1;
    let u_dot_of_place_10_1 = u_dot_of_place_8_1;
    let u_dot_of_u_2_2_1 = q_ground1_dot_2_1 + q_pin2_dot_2_1;
    let u_dot_of_place_11_1 = u_dot_of_place_9_1;
    let u_dot_of_u_2_3_1 = u_2_1 - q_ground1_dot_2_1 + q_pin1_dot_2_1;
    let u_dot_of_place_12_1 = u_dot_of_place_5_1
        .mul_add(cos_q_pin1_0, cos_q_pin1_1 * u_dot_of_place_5_0);
    let u_2_sq_sin_angle_inv2_1 = u_2_sin_angle_inv_1 * (u_2_sin_angle_inv_0 + u_2_sin_angle_inv_0);
    let u_dot_of_u_2_4_1 = u_dot_of_place_12_1
        .mul_add(u_2_sq_sin_angle_inv2_0, u_2_sq_sin_angle_inv2_1 * u_dot_of_place_12_0);
    let u_dot_of_u_2_5_1 = sin_angle_1
        .mul_add(
            -(u_dot_of_u_2_5_0 * over_sin_angle),
            q_ground1_dot_2_1 * over_sin_angle,
        );
    let u_dot_of_u_2_6_1 = u_dot_of_u_2_3_1
        .mul_add(cos_angle_0, cos_angle_1 * u_dot_of_u_2_3_0);
    let u_dot_of_u_2_7_1 = u_dot_of_u_2_6_1
        .mul_add(u_dot_of_u_2_5_0, u_dot_of_u_2_5_1 * u_dot_of_u_2_6_0);
    let u_dot_of_u_2_8_1 = q_ground1_dot_2_1 - q_ground2_dot_2_1 + q_pin2_dot_2_1;
    let u_dot_of_u_2_9_1 = q_ground1_dot_2_1
        .mul_add(cos_q_ground1_0, cos_q_ground1_1 * q_ground1_dot_2_0);
    let u_dot_of_u_2_10_1 = q_ground1_dot_2_1
        .mul_add(sin_q_ground1_0, sin_q_ground1_1 * q_ground1_dot_2_0);
    let u_2_cos_q_sin_q_ground1_1 = cos_q_sin_q_ground1_1
        .mul_add(u_2_0, u_2_1 * cos_q_sin_q_ground1_0);
    let u_dot_of_u_2_11_1 = q_ground1_dot_2_1
        .mul_add(sin_q_cos_q_ground1_0, sin_q_cos_q_ground1_1 * q_ground1_dot_2_0);
    let u_2_sin_q_cos_q_ground1_1 = sin_q_cos_q_ground1_1
        .mul_add(u_2_0, u_2_1 * sin_q_cos_q_ground1_0);
    let u_dot_of_u_2_12_1 = q_ground1_dot_2_1
        .mul_add(cos_q_sin_q_ground1_0, cos_q_sin_q_ground1_1 * q_ground1_dot_2_0);
    let u_dot_of_u_2_13_1 = u_2_cos_q_sin_q_ground1_1 - u_2_sin_q_cos_q_ground1_1
        + u_dot_of_u_2_11_1 - u_dot_of_u_2_12_1;
    let u_dot_of_u_2_14_1 = u_2_sin_angle_inv_1
        .mul_add(d1_of_place_5_0, d1_of_place_5_1 * u_2_sin_angle_inv_0);
    let u_dot_of_u_2_15_1 = u_dot_of_place_12_1
        .mul_add(u_dot_of_u_2_14_0, u_dot_of_u_2_14_1 * u_dot_of_place_12_0);
    let u_dot_of_u_2_16_1 = u_dot_of_u_2_13_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * u_dot_of_u_2_13_0);
    let u_2_cos_q_cos_q_ground1_1 = cos_q_cos_q_ground1_1
        .mul_add(u_2_0, u_2_1 * cos_q_cos_q_ground1_0);
    let u_dot_of_u_2_17_1 = q_ground1_dot_2_1
        .mul_add(sin_q_sin_q_ground1_0, sin_q_sin_q_ground1_1 * q_ground1_dot_2_0);
    let u_2_sin_q_sin_q_ground1_1 = sin_q_sin_q_ground1_1
        .mul_add(u_2_0, u_2_1 * sin_q_sin_q_ground1_0);
    let u_dot_of_u_2_18_1 = q_ground1_dot_2_1
        .mul_add(cos_q_cos_q_ground1_0, cos_q_cos_q_ground1_1 * q_ground1_dot_2_0);
    let u_dot_of_u_2_19_1 = u_2_cos_q_cos_q_ground1_1 + u_2_sin_q_sin_q_ground1_1
        - u_dot_of_u_2_17_1 - u_dot_of_u_2_18_1;
    let u_dot_of_place_13_1 = u_dot_of_place_5_1
        .mul_add(d1_of_place_7_0, d1_of_place_7_1 * u_dot_of_place_5_0);
    let u_dot_of_u_2_20_1 = u_dot_of_place_13_1
        .mul_add(q_ground1_dot_2_0, q_ground1_dot_2_1 * u_dot_of_place_13_0);
    let u_dot_of_u_2_21_1 = u_dot_of_u_2_19_1
        .mul_add(cos_q_pin1_0, cos_q_pin1_1 * u_dot_of_u_2_19_0);
    let u_dot_of_u_2_22_1 = u_dot_of_u_2_15_1 - u_dot_of_u_2_20_1 + u_dot_of_u_2_16_1
        + u_dot_of_u_2_21_1;
    let u_dot_of_u_2_23_1 = d1_of_place_9_1
        .mul_add(-(u_dot_of_u_2_23_0 * over_d1_of_place_9), u_2_1 * over_d1_of_place_9);
    let u_dot_of_u_2_24_1 = u_dot_of_u_2_23_1
        .mul_add(u_dot_of_u_2_19_0, u_dot_of_u_2_19_1 * u_dot_of_u_2_23_0);
    let u_dot_of_place_14_1 = d1_of_place_9_1
        .mul_add(
            -(u_dot_of_place_14_0 * over_d1_of_place_9),
            d1_of_place_7_1 * over_d1_of_place_9,
        );
    let u_dot_of_u_2_25_1 = u_dot_of_place_14_1
        .mul_add(u_dot_of_u_2_23_0, u_dot_of_u_2_23_1 * u_dot_of_place_14_0);
    let u_dot_of_u_2_26_1 = u_dot_of_u_2_22_1
        .mul_add(u_dot_of_u_2_25_0, u_dot_of_u_2_25_1 * u_dot_of_u_2_22_0);
    let u_dot_of_u_2_27_1 = u_dot_of_u_2_1
        .mul_add(d1_of_place_7_0, d1_of_place_7_1 * u_dot_of_u_2_0);
    let u_dot_of_u_2_28_1 = u_dot_of_u_2_27_1
        .mul_add(u_dot_of_u_2_23_0, u_dot_of_u_2_23_1 * u_dot_of_u_2_27_0);
    let u_dot_of_u_2_29_1 = u_dot_of_u_2_2_1
        .mul_add(
            cos_q_ground1_plus_q_pin2_0,
            cos_q_ground1_plus_q_pin2_1 * u_dot_of_u_2_2_0,
        );
    let u_dot_of_u_2_30_1 = u_dot_of_u_2_2_1
        .mul_add(
            sin_q_ground1_plus_q_pin2_0,
            sin_q_ground1_plus_q_pin2_1 * u_dot_of_u_2_2_0,
        );
    let u_dot_of_u_2_31_1 = u_dot_of_u_2_9_1 + u_dot_of_u_2_29_1;
    let u_dot_of_place_15_1 = d1_of_place_4_1
        .mul_add(cos_q_ground2_0, cos_q_ground2_1 * d1_of_place_4_0);
    let u_dot_of_u_2_32_1 = q_ground2_dot_2_1
        .mul_add(u_dot_of_place_15_0, u_dot_of_place_15_1 * q_ground2_dot_2_0);
    let u_dot_of_u_2_33_1 = u_dot_of_u_2_10_1 + u_dot_of_u_2_30_1;
    let u_dot_of_u_2_34_1 = u_dot_of_u_2_33_1
        .mul_add(sin_q_ground2_0, sin_q_ground2_1 * u_dot_of_u_2_33_0);
    let u_dot_of_place_16_1 = d1_of_place_3_1
        .mul_add(sin_q_ground2_0, sin_q_ground2_1 * d1_of_place_3_0);
    let u_dot_of_u_2_35_1 = q_ground2_dot_2_1
        .mul_add(u_dot_of_place_16_0, u_dot_of_place_16_1 * q_ground2_dot_2_0);
    let u_dot_of_u_2_36_1 = u_dot_of_u_2_31_1
        .mul_add(cos_q_ground2_0, cos_q_ground2_1 * u_dot_of_u_2_31_0);
    let u_dot_of_u_2_37_1 = u_dot_of_u_2_32_1 + u_dot_of_u_2_35_1 - u_dot_of_u_2_34_1
        - u_dot_of_u_2_36_1;
    let u_dot_of_place_17_1 = sin_angle_2_1
        .mul_add(
            -(u_dot_of_place_17_0 * over_sin_angle_2),
            cos_angle_2_1 * over_sin_angle_2,
        );
    let u_dot_of_place_18_1 = u_dot_of_place_9_1
        .mul_add(u_dot_of_place_17_0, u_dot_of_place_17_1 * u_dot_of_place_9_0);
    let u_dot_of_u_2_38_1 = u_dot_of_u_2_8_1
        .mul_add(u_dot_of_place_18_0, u_dot_of_place_18_1 * u_dot_of_u_2_8_0);
    let u_dot_of_u_2_39_1 = sin_angle_2_1
        .mul_add(
            -(u_dot_of_u_2_39_0 * over_sin_angle_2),
            u_dot_of_u_2_37_1 * over_sin_angle_2,
        );
    let u_dot_of_u_2_40_1 = u_dot_of_u_2_4_1
        .mul_add(u_dot_of_place_11_0, u_dot_of_place_11_1 * u_dot_of_u_2_4_0);
    let u_dot_of_u_2_41_1 = u_dot_of_u_2_7_1
        .mul_add(u_dot_of_place_11_0, u_dot_of_place_11_1 * u_dot_of_u_2_7_0);
    let u_dot_of_u_2_42_1 = u_dot_of_u_2_38_1 - u_dot_of_u_2_39_1;
    let u_dot_of_u_2_43_1 = u_dot_of_u_2_42_1
        .mul_add(q_ground1_dot_2_0, q_ground1_dot_2_1 * u_dot_of_u_2_42_0);
    let u_dot_of_u_2_44_1 = u_dot_of_place_11_1
        .mul_add(q_ground1_dot_2_0, q_ground1_dot_2_1 * u_dot_of_place_11_0);
    let u_dot_of_u_2_45_1 = u_dot_of_u_2_44_1
        .mul_add(u_dot_of_u_2_2_0, u_dot_of_u_2_2_1 * u_dot_of_u_2_44_0);
    let u_dot_of_u_2_46_1 = u_dot_of_u_2_7_1.mul_add(minus_l, l * u_dot_of_u_2_4_1);
    let u_dot_of_place_19_1 = sin_q_pin1_1 + u_dot_of_place_4_1 - u_dot_of_place_3_1;
    let u_dot_of_place_20_1 = sin_angle_1
        .mul_add(
            -(u_dot_of_place_20_0 * over_sin_angle),
            u_dot_of_place_19_1 * over_sin_angle,
        );
    let u_dot_of_place_21_1 = u_dot_of_place_20_1;
    let sin_q_pin1_cos_angle_1 = cos_angle_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * cos_angle_0);
    let u_dot_of_place_22_1 = u_dot_of_place_21_1
        .mul_add(sin_q_pin1_cos_angle_0, sin_q_pin1_cos_angle_1 * u_dot_of_place_21_0);
    let u_dot_of_place_23_1 = u_dot_of_place_12_1 + u_dot_of_place_22_1;
    let u_dot_of_u_2_47_1 = u_dot_of_place_23_1
        .mul_add(u_2_sq_sin_angle_inv2_0, u_2_sq_sin_angle_inv2_1 * u_dot_of_place_23_0);
    let u_dot_of_u_2_48_1 = u_dot_of_u_2_47_1.mul_add(l, weight * cos_q_ground1_1);
    let u_dot_of_place_24_1 = sin_q_pin2_1 + d1_of_place_11_1 - u_dot_of_place_6_1;
    let u_dot_of_place_25_1 = sin_angle_2_1
        .mul_add(
            -(u_dot_of_place_25_0 * over_sin_angle_2),
            u_dot_of_place_24_1 * over_sin_angle_2,
        );
    let u_dot_of_place_26_1 = u_dot_of_place_25_1;
    let u_dot_of_place_27_1 = u_dot_of_place_26_1
        .mul_add(u_dot_of_place_17_0, u_dot_of_place_17_1 * u_dot_of_place_26_0);
    let sin_angle_inv_cos_angle_1 = sin_angle_1
        .mul_add(
            -(sin_angle_inv_cos_angle_0 * over_sin_angle),
            cos_angle_1 * over_sin_angle,
        );
    let u_dot_of_place_28_1 = sin_angle_inv_cos_angle_1 + u_dot_of_place_27_1;
    let u_dot_of_place_29_1 = u_dot_of_place_28_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * u_dot_of_place_28_0);
    let u_dot_of_place_30_1 = u_dot_of_place_10_1
        .mul_add(cos_angle_0, cos_angle_1 * u_dot_of_place_10_0);
    let u_dot_of_place_31_1 = -u_dot_of_place_30_1 + u_dot_of_place_29_1;
    let u_dot_of_place_32_1 = u_dot_of_place_31_1
        .mul_add(sin_q_pin2_0, sin_q_pin2_1 * u_dot_of_place_31_0);
    let sin_q_pin1_cos_q_pin2_1 = cos_q_pin2_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * cos_q_pin2_0);
    let u_dot_of_place_33_1 = u_dot_of_place_9_1
        .mul_add(sin_q_pin1_cos_q_pin2_0, sin_q_pin1_cos_q_pin2_1 * u_dot_of_place_9_0);
    let u_dot_of_place_34_1 = u_dot_of_place_33_1 + u_dot_of_place_32_1;
    let u_dot_of_place_35_1 = u_dot_of_place_34_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * u_dot_of_place_34_0);
    let u_dot_of_place_36_1 = u_dot_of_place_12_1
        .mul_add(sin_q_pin2_0, sin_q_pin2_1 * u_dot_of_place_12_0);
    let u_dot_of_place_37_1 = u_dot_of_place_36_1 + u_dot_of_place_35_1;
    let u_dot_of_place_38_1 = sin_angle_2_1
        .mul_add(
            -(u_dot_of_place_38_0 * over_sin_angle_2),
            u_dot_of_place_37_1 * over_sin_angle_2,
        );
    let u_dot_of_u_2_49_1 = u_dot_of_place_38_1
        .mul_add(u_2_sq_sin_angle_inv2_0, u_2_sq_sin_angle_inv2_1 * u_dot_of_place_38_0);
    let u_dot_of_u_2_50_1 = u_dot_of_u_2_49_1.mul_add(l, weight * cos_q_ground2_1);
    let u_2_sq_1 = u_2_1 * (u_2_0 + u_2_0);
    let u_2_sq_cos_q_pin1_1 = u_2_sq_1.mul_add(cos_q_pin1_0, cos_q_pin1_1 * u_2_sq_0);
    let u_dot_of_place_39_1 = d1_of_place_5_1
        .mul_add(cos_q_pin1_0, cos_q_pin1_1 * d1_of_place_5_0);
    let u_2_sq_sin_q_pin1_1 = u_2_sq_1.mul_add(sin_q_pin1_0, sin_q_pin1_1 * u_2_sq_0);
    let u_dot_of_q_pin1_2_1 = S::int(2) * cos_q_pin1_1;
    let u_dot_of_place_40_1 = u_dot_of_q_pin1_2_1
        .mul_add(cos_q_ground1_0, cos_q_ground1_1 * u_dot_of_q_pin1_2_0);
    let u_dot_of_place_41_1 = S::int(2) * sin_q_pin1_sin_q_ground1_1 + u_dot_of_place_40_1;
    let u_dot_of_place_42_1 = u_dot_of_place_41_1
        .mul_add(sin_q_0, sin_q_1 * u_dot_of_place_41_0);
    let u_dot_of_place_43_1 = u_dot_of_q_pin1_2_1
        .mul_add(sin_q_ground1_0, sin_q_ground1_1 * u_dot_of_q_pin1_2_0);
    let u_dot_of_place_44_1 = S::int(2) * sin_q_pin1_cos_q_ground1_1 - u_dot_of_place_43_1;
    let u_dot_of_place_45_1 = u_dot_of_place_44_1
        .mul_add(cos_q_0, cos_q_1 * u_dot_of_place_44_0);
    let u_dot_of_place_46_1 = u_dot_of_place_42_1 + u_dot_of_place_45_1;
    let u_dot_of_place_47_1 = u_dot_of_place_46_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * u_dot_of_place_46_0);
    let u_dot_of_place_48_1 = sin_q_sin_q_ground1_1 + cos_q_cos_q_ground1_1
        + u_dot_of_place_39_1 - u_dot_of_place_47_1;
    let u_dot_of_place_49_1 = u_dot_of_place_48_1
        .mul_add(cos_q_ground1_0, cos_q_ground1_1 * u_dot_of_place_48_0);
    let u_dot_of_q_2_q_pin1_5_1 = u_dot_of_q_pin1_2_1
        .mul_add(sin_q_0, sin_q_1 * u_dot_of_q_pin1_2_0);
    let u_dot_of_q_2_q_pin1_6_1 = S::int(2) * sin_q_pin1_cos_q_1 + u_dot_of_q_2_q_pin1_5_1;
    let u_dot_of_q_2_q_pin1_7_1 = u_dot_of_q_2_q_pin1_6_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * u_dot_of_q_2_q_pin1_6_0);
    let u_dot_of_place_50_1 = u_dot_of_place_49_1
        .mul_add(
            -S::int(4),
            u_dot_of_q_2_q_pin1_7_1
                .mul_add(-S::int(3), S::int(3) * u_dot_of_q_2_q_pin1_1),
        );
    let u_dot_of_place_51_1 = u_dot_of_place_50_1
        .mul_add(cos_q_0, cos_q_1 * u_dot_of_place_50_0);
    let u_dot_of_place_52_1 = u_dot_of_place_44_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * u_dot_of_place_44_0);
    let u_dot_of_place_53_1 = u_dot_of_place_1 - u_dot_of_place_52_1;
    let u_dot_of_place_54_1 = u_dot_of_place_53_1
        .mul_add(cos_q_ground1_0, cos_q_ground1_1 * u_dot_of_place_53_0);
    let sin_q_pin1_sq_1 = sin_q_pin1_1 * (sin_q_pin1_0 + sin_q_pin1_0);
    let u_dot_of_place_55_1 = u_dot_of_place_54_1
        .mul_add(
            -S::int(3),
            sin_q_pin1_sq_1.mul_add(-S::int(5), S::int(2) * cos_q_pin1_1),
        ) - u_dot_of_place_51_1;
    let u_dot_of_place_56_1 = u_dot_of_place_55_1
        .mul_add(cos_q_ground1_0, cos_q_ground1_1 * u_dot_of_place_55_0);
    let u_dot_of_q_2_q_pin1_8_1 = u_dot_of_q_pin1_2_1
        .mul_add(cos_q_0, cos_q_1 * u_dot_of_q_pin1_2_0);
    let u_dot_of_q_2_q_pin1_9_1 = S::int(2) * sin_q_pin1_sin_q_1 - u_dot_of_q_2_q_pin1_8_1;
    let u_dot_of_q_2_q_pin1_10_1 = u_dot_of_q_2_q_pin1_9_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * u_dot_of_q_2_q_pin1_9_0);
    let u_dot_of_q_2_q_pin1_11_1 = u_dot_of_q_2_q_pin1_2_1 - u_dot_of_q_2_q_pin1_10_1;
    let u_dot_of_q_2_q_pin1_12_1 = u_dot_of_q_2_q_pin1_11_1
        .mul_add(cos_q_0, cos_q_1 * u_dot_of_q_2_q_pin1_11_0);
    let sin_q_pin1_cos_q_pin1_1 = cos_q_pin1_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * cos_q_pin1_0);
    let u_dot_of_q_2_q_pin1_13_1 = -S::int(2) * sin_q_pin1_cos_q_pin1_1 + u_dot_of_q_2_q_pin1_12_1;
    let u_dot_of_place_57_1 = u_dot_of_q_2_q_pin1_13_1
        .mul_add(sin_q_ground1_0, sin_q_ground1_1 * u_dot_of_q_2_q_pin1_13_0);
    let u_dot_of_place_58_1 = -u_dot_of_place_57_1 + u_dot_of_place_56_1;
    let u_dot_of_place_59_1 = u_dot_of_place_58_1
        .mul_add(cos_q_0, cos_q_1 * u_dot_of_place_58_0);
    let u_dot_of_place_60_1 = u_dot_of_place_41_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * u_dot_of_place_41_0);
    let u_dot_of_place_61_1 = u_dot_of_place_2_1 - u_dot_of_place_60_1;
    let u_dot_of_place_62_1 = u_dot_of_place_61_1
        .mul_add(cos_q_ground1_0, cos_q_ground1_1 * u_dot_of_place_61_0);
    let u_dot_of_place_63_1 = S::int(2) * sin_q_pin1_cos_q_pin1_1 + u_dot_of_place_62_1;
    let u_dot_of_place_64_1 = u_dot_of_place_63_1
        .mul_add(cos_q_ground1_0, cos_q_ground1_1 * u_dot_of_place_63_0);
    let u_dot_of_place_65_1 = sin_q_pin1_sin_q_ground1_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * sin_q_pin1_sin_q_ground1_0);
    let u_dot_of_place_66_1 = u_dot_of_place_65_1 + u_dot_of_place_64_1;
    let u_dot_of_place_67_1 = u_dot_of_place_66_1
        .mul_add(sin_q_0, sin_q_1 * u_dot_of_place_66_0);
    let u_dot_of_place_68_1 = sin_q_pin1_sq_1 - u_dot_of_place_67_1 + u_dot_of_place_59_1;
    let u_dot_of_u_2_51_1 = q_ground1_dot_2_1 * (q_ground1_dot_2_0 + q_ground1_dot_2_0);
    let u_dot_of_u_2_52_1 = u_dot_of_u_2_51_1
        .mul_add(cos_q_pin2_0, cos_q_pin2_1 * u_dot_of_u_2_51_0);
    let u_dot_of_u_2_53_1 = u_dot_of_u_2_46_1
        .mul_add(sin_q_pin2_0, sin_q_pin2_1 * u_dot_of_u_2_46_0);
    let u_dot_of_u_2_54_1 = u_dot_of_u_2_51_1
        .mul_add(sin_q_pin2_0, sin_q_pin2_1 * u_dot_of_u_2_51_0);
    let u_dot_of_u_2_55_1 = u_dot_of_u_2_46_1
        .mul_add(cos_q_pin2_0, cos_q_pin2_1 * u_dot_of_u_2_46_0);
    let u_dot_of_place_69_1 = S::int(2) * cos_q_pin2_1 + u_dot_of_place_9_1;
    let u_dot_of_place_70_1 = u_dot_of_place_14_1
        .mul_add(minus_l, weight_2 * cos_q_pin1_1);
    let u_dot_of_u_2_56_1 = u_dot_of_u_2_48_1
        .mul_add(
            sin_q_pin1_sin_angle_inv_0,
            sin_q_pin1_sin_angle_inv_1 * u_dot_of_u_2_48_0,
        );
    let u_dot_of_u_2_57_1 = u_dot_of_u_2_5_1
        .mul_add(u_2_sin_angle_inv_0, u_2_sin_angle_inv_1 * u_dot_of_u_2_5_0);
    let u_dot_of_u_2_58_1 = u_dot_of_place_23_1
        .mul_add(u_dot_of_u_2_57_0, u_dot_of_u_2_57_1 * u_dot_of_place_23_0);
    let u_dot_of_place_71_1 = sin_q_pin1_sin_angle_inv_1
        .mul_add(d1_of_place_35_0, d1_of_place_35_1 * sin_q_pin1_sin_angle_inv_0);
    let u_dot_of_u_2_59_1 = u_dot_of_u_2_50_1
        .mul_add(u_dot_of_place_71_0, u_dot_of_place_71_1 * u_dot_of_u_2_50_0);
    let u_dot_of_u_2_60_1 = u_dot_of_u_2_57_1
        .mul_add(d1_of_place_35_0, d1_of_place_35_1 * u_dot_of_u_2_57_0);
    let u_dot_of_u_2_61_1 = u_dot_of_place_38_1
        .mul_add(u_dot_of_u_2_60_0, u_dot_of_u_2_60_1 * u_dot_of_place_38_0);
    let u_dot_of_u_2_62_1 = u_dot_of_u_2_28_1
        .mul_add(
            m_l,
            u_2_sq_cos_q_pin1_1.mul_add(minus_2_m_l, weight_3 * sin_q_plus_q_pin1_1),
        );
    let u_dot_of_u_2_63_1 = u_dot_of_u_2_62_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * u_dot_of_u_2_62_0);
    let u_dot_of_u_2_64_1 = u_dot_of_u_2_26_1
        .mul_add(
            minus_m_l,
            u_dot_of_u_2_24_1
                .mul_add(
                    m_l,
                    u_2_sq_sin_q_pin1_1
                        .mul_add(minus_2_m_l, minus_2_m_g * cos_q_plus_q_pin1_1),
                ),
        );
    let u_dot_of_u_2_65_1 = u_dot_of_u_2_64_1
        .mul_add(u_dot_of_place_70_0, u_dot_of_place_70_1 * u_dot_of_u_2_64_0);
    let u_dot_of_place_72_1 = d1_of_place_9_1 * (d1_of_place_9_0 + d1_of_place_9_0);
    let u_dot_of_place_73_1 = u_dot_of_place_72_1 * (u_dot_of_place_72_0 + u_dot_of_place_72_0);
    let u_dot_of_u_2_66_1 = d1_of_place_7_1
        .mul_add(u_2_sq_0, u_2_sq_1 * d1_of_place_7_0);
    let u_dot_of_u_2_67_1 = u_dot_of_place_73_1
        .mul_add(
            -(u_dot_of_u_2_67_0 * over_u_dot_of_place_73),
            u_dot_of_u_2_66_1 * over_u_dot_of_place_73,
        );
    let u_dot_of_u_2_68_1 = u_dot_of_place_68_1
        .mul_add(u_dot_of_u_2_67_0, u_dot_of_u_2_67_1 * u_dot_of_place_68_0);
    let u_dot_of_u_2_69_1 = u_dot_of_u_2_53_1
        .mul_add(
            minus_2_m,
            u_dot_of_u_2_45_1
                .mul_add(
                    m_l,
                    u_dot_of_u_2_52_1
                        .mul_add(weight_4, minus_2_m_g * sin_q_ground1_plus_q_pin2_1),
                ),
        );
    let u_dot_of_place_74_1 = sin_q_pin1_sin_angle_inv_1
        .mul_add(sin_q_pin2_0, sin_q_pin2_1 * sin_q_pin1_sin_angle_inv_0);
    let u_dot_of_u_2_70_1 = u_dot_of_u_2_69_1
        .mul_add(u_dot_of_place_74_0, u_dot_of_place_74_1 * u_dot_of_u_2_69_0);
    let u_dot_of_u_2_71_1 = u_dot_of_u_2_43_1
        .mul_add(
            minus_m_l,
            u_dot_of_u_2_55_1
                .mul_add(
                    weight_5,
                    u_dot_of_u_2_41_1
                        .mul_add(
                            minus_m_l,
                            u_dot_of_u_2_40_1
                                .mul_add(
                                    m_l,
                                    u_dot_of_u_2_54_1
                                        .mul_add(weight_4, weight_3 * cos_q_ground1_plus_q_pin2_1),
                                ),
                        ),
                ),
        );
    let u_dot_of_place_75_1 = u_dot_of_place_69_1
        .mul_add(
            sin_q_pin1_sin_angle_inv_0,
            sin_q_pin1_sin_angle_inv_1 * u_dot_of_place_69_0,
        );
    let u_dot_of_u_2_72_1 = u_dot_of_u_2_71_1
        .mul_add(u_dot_of_place_75_0, u_dot_of_place_75_1 * u_dot_of_u_2_71_0);
    let u_dot_of_u_2_73_1 = u_dot_of_u_2_43_1
        .mul_add(
            minus_m_l_2,
            u_dot_of_u_2_41_1.mul_add(minus_m_l_2, m_l_2 * u_dot_of_u_2_40_1),
        );
    let u_dot_of_place_76_1 = u_dot_of_place_11_1
        .mul_add(
            sin_q_pin1_sin_angle_inv_0,
            sin_q_pin1_sin_angle_inv_1 * u_dot_of_place_11_0,
        );
    let u_dot_of_u_2_74_1 = u_dot_of_u_2_73_1
        .mul_add(u_dot_of_place_76_0, u_dot_of_place_76_1 * u_dot_of_u_2_73_0);
    let u_dot_of_u_2_75_1 = u_dot_of_u_2_59_1
        .mul_add(
            weight_7,
            u_dot_of_u_2_72_1
                .mul_add(
                    weight_9,
                    u_dot_of_u_2_68_1
                        .mul_add(
                            minus_m_l_2,
                            u_dot_of_u_2_61_1
                                .mul_add(
                                    m_l_2,
                                    u_dot_of_u_2_70_1
                                        .mul_add(
                                            minus_6_l,
                                            u_dot_of_u_2_65_1
                                                .mul_add(
                                                    -S::int(3),
                                                    u_dot_of_u_2_56_1
                                                        .mul_add(
                                                            weight_7,
                                                            u_dot_of_u_2_63_1
                                                                .mul_add(
                                                                    weight_8,
                                                                    u_dot_of_u_2_58_1.mul_add(m_l_2, weight_6 * cos_q_1),
                                                                ),
                                                        ),
                                                ),
                                        ),
                                ),
                        ),
                ) + u_dot_of_u_2_74_1,
        );
    let u_dot_of_u_2_76_1 = d1_of_place_49_1
        .mul_add(
            -(u_dot_of_u_2_76_0 * over_d1_of_place_49),
            u_dot_of_u_2_75_1 * over_d1_of_place_49,
        );
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                q_pin1_1, q_pin1_1, q_pin2_1, q_pin2_1, q_2_1, q_2_1, q_ground1_1, q_ground1_1,
                d1_of_place_1, d1_of_place_1, q_ground2_1, q_ground2_1, q_ground1_plus_q_pin2_1,
                q_ground1_plus_q_pin2_1, d1_of_place_2_1, d1_of_place_2_1, sin_q_1, cos_q_1,
                sin_q_pin1_1, sin_q_1, cos_q_1, cos_q_pin1_1, sin_q_ground2_1, cos_q_ground2_1,
                sin_angle_2_1, sin_q_ground1_plus_q_pin2_1, d1_of_place_9_1, sin_q_ground2_1,
                cos_q_ground1_1, cos_q_ground1_plus_q_pin2_1, sin_angle_2_1, cos_q_pin2_1,
                sin_q_ground2_1, d1_of_place_23_1, sin_q_ground1_1, sin_q_ground1_plus_q_pin2_1,
                cos_q_ground2_1, sin_angle_2_1, sin_q_pin2_1, sin_angle_2_1, sin_angle_1,
                sin_q_pin1_sin_angle_inv_1, d1_of_place_39_1, d1_of_place_9_1, d1_of_place_43_1,
                d1_of_place_45_1, d1_of_place_9_1, q_2_plus_q_pin1_1, q_2_plus_q_pin1_1, cos_q_1,
                sin_q_pin1_1, sin_q_1, sin_q_pin1_1, cos_q_ground1_1, sin_q_pin1_1, sin_q_ground1_1,
                sin_q_pin1_1, sin_q_ground1_1, cos_q_ground1_1, sin_q_ground2_1, sin_angle_1,
                sin_q_pin1_1, q_ground1_dot_2_1, sin_angle_1, u_dot_of_place_5_1, sin_angle_2_1,
                q_ground1_dot_2_1, cos_q_pin1_1, u_2_sin_angle_inv_1, u_dot_of_place_12_1,
                sin_angle_1, cos_angle_1, u_dot_of_u_2_5_1, cos_q_ground1_1, sin_q_ground1_1, u_2_1,
                q_ground1_dot_2_1, u_2_1, q_ground1_dot_2_1, d1_of_place_5_1, u_dot_of_place_12_1,
                sin_q_pin1_1, u_2_1, q_ground1_dot_2_1, u_2_1, q_ground1_dot_2_1, d1_of_place_7_1,
                q_ground1_dot_2_1, cos_q_pin1_1, d1_of_place_9_1, u_dot_of_u_2_19_1,
                d1_of_place_9_1, u_dot_of_u_2_23_1, u_dot_of_u_2_22_1, d1_of_place_7_1,
                u_dot_of_u_2_23_1, cos_q_ground1_plus_q_pin2_1, sin_q_ground1_plus_q_pin2_1,
                cos_q_ground2_1, q_ground2_dot_2_1, sin_q_ground2_1, sin_q_ground2_1,
                q_ground2_dot_2_1, cos_q_ground2_1, sin_angle_2_1, u_dot_of_place_9_1,
                u_dot_of_u_2_8_1, sin_angle_2_1, u_dot_of_place_11_1, u_dot_of_place_11_1,
                u_dot_of_u_2_42_1, u_dot_of_place_11_1, u_dot_of_u_2_2_1, sin_angle_1, sin_q_pin1_1,
                u_dot_of_place_21_1, u_dot_of_place_23_1, sin_angle_2_1, u_dot_of_place_26_1,
                sin_angle_1, sin_q_pin1_1, cos_angle_1, sin_q_pin2_1, sin_q_pin1_1,
                u_dot_of_place_9_1, sin_q_pin1_1, sin_q_pin2_1, sin_angle_2_1,
                u_2_sq_sin_angle_inv2_1, u_2_1, cos_q_pin1_1, cos_q_pin1_1, sin_q_pin1_1,
                cos_q_ground1_1, sin_q_1, sin_q_ground1_1, cos_q_1, sin_q_pin1_1, cos_q_ground1_1,
                sin_q_1, sin_q_pin1_1, cos_q_1, sin_q_pin1_1, cos_q_ground1_1, sin_q_pin1_1,
                cos_q_ground1_1, cos_q_1, sin_q_pin1_1, cos_q_1, sin_q_pin1_1, sin_q_ground1_1,
                cos_q_1, sin_q_pin1_1, cos_q_ground1_1, cos_q_ground1_1, sin_q_pin1_1, sin_q_1,
                q_ground1_dot_2_1, cos_q_pin2_1, sin_q_pin2_1, sin_q_pin2_1, cos_q_pin2_1,
                u_dot_of_u_2_48_1, u_2_sin_angle_inv_1, u_dot_of_place_23_1, d1_of_place_35_1,
                u_dot_of_u_2_50_1, d1_of_place_35_1, u_dot_of_place_38_1, sin_q_pin1_1,
                u_dot_of_place_70_1, d1_of_place_9_1, u_dot_of_place_72_1, d1_of_place_7_1,
                u_dot_of_place_73_1, u_dot_of_place_68_1, sin_q_pin2_1, u_dot_of_u_2_69_1,
                u_dot_of_place_69_1, u_dot_of_u_2_71_1, u_dot_of_place_11_1, u_dot_of_u_2_73_1,
                d1_of_place_49_1,
            ]),
            padded([
                cos_q_pin1_1, sin_q_pin1_1, cos_q_pin2_1, sin_q_pin2_1, cos_q_1, sin_q_1,
                cos_q_ground1_1, sin_q_ground1_1, cos_angle_1, sin_angle_1, cos_q_ground2_1,
                sin_q_ground2_1, cos_q_ground1_plus_q_pin2_1, sin_q_ground1_plus_q_pin2_1,
                cos_angle_2_1, sin_angle_2_1, sin_q_ground1_1, cos_q_ground1_1, d1_of_place_5_1,
                cos_q_ground1_1, sin_q_ground1_1, d1_of_place_7_1, cos_q_ground1_plus_q_pin2_1,
                d1_of_place_3_1, d1_of_place_12_1, d1_of_place_12_1, d1_of_place_14_1,
                d1_of_place_16_1, d1_of_place_18_1, d1_of_place_20_1, d1_of_place_24_1,
                d1_of_place_4_1, d1_of_place_26_1, d1_of_place_12_1, d1_of_place_29_1,
                d1_of_place_31_1, d1_of_place_33_1, d1_of_place_35_1, d1_of_place_35_1,
                d1_of_place_38_1, sin_q_pin1_sin_angle_inv_1, sin_q_pin1_sin_angle_inv_1,
                d1_of_place_40_1, d1_of_place_42_1, sin_q_cos_q_ground1_1, cos_q_sin_q_ground1_1,
                d1_of_place_48_1, cos_q_plus_q_pin1_1, sin_q_plus_q_pin1_1, u_dot_of_q_pin1_1,
                sin_q_1, u_dot_of_q_pin1_1, cos_q_1, u_dot_of_q_pin1_1, sin_q_ground1_1,
                u_dot_of_q_pin1_1, cos_q_ground1_1, u_dot_of_q_2_q_pin1_4_1,
                u_dot_of_q_2_q_pin1_3_1, d1_of_place_4_1, u_2_sin_angle_inv_1, u_2_sin_angle_inv_1,
                d1_of_place_35_1, u_dot_of_place_8_1, u_2_sin_angle_inv_1, u_dot_of_place_9_1,
                u_dot_of_place_9_1, u_dot_of_place_5_1, u_2_sin_angle_inv_1,
                u_2_sq_sin_angle_inv2_1, u_dot_of_u_2_5_1, u_dot_of_u_2_3_1, u_dot_of_u_2_6_1,
                q_ground1_dot_2_1, q_ground1_dot_2_1, cos_q_sin_q_ground1_1, sin_q_cos_q_ground1_1,
                sin_q_cos_q_ground1_1, cos_q_sin_q_ground1_1, u_2_sin_angle_inv_1,
                u_dot_of_u_2_14_1, u_dot_of_u_2_13_1, cos_q_cos_q_ground1_1, sin_q_sin_q_ground1_1,
                sin_q_sin_q_ground1_1, cos_q_cos_q_ground1_1, u_dot_of_place_5_1,
                u_dot_of_place_13_1, u_dot_of_u_2_19_1, u_dot_of_u_2_23_1, u_dot_of_u_2_23_1,
                u_dot_of_place_14_1, u_dot_of_place_14_1, u_dot_of_u_2_25_1, u_dot_of_u_2_1,
                u_dot_of_u_2_27_1, u_dot_of_u_2_2_1, u_dot_of_u_2_2_1, d1_of_place_4_1,
                u_dot_of_place_15_1, u_dot_of_u_2_33_1, d1_of_place_3_1, u_dot_of_place_16_1,
                u_dot_of_u_2_31_1, u_dot_of_place_17_1, u_dot_of_place_17_1, u_dot_of_place_18_1,
                u_dot_of_u_2_39_1, u_dot_of_u_2_4_1, u_dot_of_u_2_7_1, q_ground1_dot_2_1,
                q_ground1_dot_2_1, u_dot_of_u_2_44_1, u_dot_of_place_20_1, cos_angle_1,
                sin_q_pin1_cos_angle_1, u_2_sq_sin_angle_inv2_1, u_dot_of_place_25_1,
                u_dot_of_place_17_1, sin_angle_inv_cos_angle_1, u_dot_of_place_28_1,
                u_dot_of_place_10_1, u_dot_of_place_31_1, cos_q_pin2_1, sin_q_pin1_cos_q_pin2_1,
                u_dot_of_place_34_1, u_dot_of_place_12_1, u_dot_of_place_38_1, u_dot_of_place_38_1,
                u_2_1, u_2_sq_1, d1_of_place_5_1, u_2_sq_1, u_dot_of_q_pin1_2_1,
                u_dot_of_place_41_1, u_dot_of_q_pin1_2_1, u_dot_of_place_44_1, u_dot_of_place_46_1,
                u_dot_of_place_48_1, u_dot_of_q_pin1_2_1, u_dot_of_q_2_q_pin1_6_1,
                u_dot_of_place_50_1, u_dot_of_place_44_1, u_dot_of_place_53_1, sin_q_pin1_1,
                u_dot_of_place_55_1, u_dot_of_q_pin1_2_1, u_dot_of_q_2_q_pin1_9_1,
                u_dot_of_q_2_q_pin1_11_1, cos_q_pin1_1, u_dot_of_q_2_q_pin1_13_1,
                u_dot_of_place_58_1, u_dot_of_place_41_1, u_dot_of_place_61_1, u_dot_of_place_63_1,
                sin_q_pin1_sin_q_ground1_1, u_dot_of_place_66_1, q_ground1_dot_2_1,
                u_dot_of_u_2_51_1, u_dot_of_u_2_46_1, u_dot_of_u_2_51_1, u_dot_of_u_2_46_1,
                sin_q_pin1_sin_angle_inv_1, u_dot_of_u_2_5_1, u_dot_of_u_2_57_1,
                sin_q_pin1_sin_angle_inv_1, u_dot_of_place_71_1, u_dot_of_u_2_57_1,
                u_dot_of_u_2_60_1, u_dot_of_u_2_62_1, u_dot_of_u_2_64_1, d1_of_place_9_1,
                u_dot_of_place_72_1, u_2_sq_1, u_dot_of_u_2_67_1, u_dot_of_u_2_67_1,
                sin_q_pin1_sin_angle_inv_1, u_dot_of_place_74_1, sin_q_pin1_sin_angle_inv_1,
                u_dot_of_place_75_1, sin_q_pin1_sin_angle_inv_1, u_dot_of_place_76_1,
                u_dot_of_u_2_76_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q_2_last = q_2_1;
    let mut q_ground1_last = q_ground1_1;
    let mut q_ground2_last = q_ground2_1;
    let mut q_pin1_last = q_pin1_1;
    let mut q_pin2_last = q_pin2_1;
    let mut u_2_last = u_2_1;
    let mut sin_q_pin1_last = sin_q_pin1_1;
    let mut cos_q_pin1_last = cos_q_pin1_1;
    let mut sin_q_pin2_last = sin_q_pin2_1;
    let mut cos_q_pin2_last = cos_q_pin2_1;
    let mut sin_q_last = sin_q_1;
    let mut cos_q_last = cos_q_1;
    let mut sin_q_ground1_last = sin_q_ground1_1;
    let mut cos_q_ground1_last = cos_q_ground1_1;
    let mut d1_of_place_last = d1_of_place_1;
    let mut sin_angle_last = sin_angle_1;
    let mut cos_angle_last = cos_angle_1;
    let mut sin_q_ground2_last = sin_q_ground2_1;
    let mut cos_q_ground2_last = cos_q_ground2_1;
    let mut q_ground1_plus_q_pin2_last = q_ground1_plus_q_pin2_1;
    let mut sin_q_ground1_plus_q_pin2_last = sin_q_ground1_plus_q_pin2_1;
    let mut cos_q_ground1_plus_q_pin2_last = cos_q_ground1_plus_q_pin2_1;
    let mut d1_of_place_2_last = d1_of_place_2_1;
    let mut sin_angle_2_last = sin_angle_2_1;
    let mut cos_angle_2_last = cos_angle_2_1;
    let mut d1_of_place_3_last = d1_of_place_3_1;
    let mut d1_of_place_4_last = d1_of_place_4_1;
    let mut sin_q_sin_q_ground1_last = sin_q_sin_q_ground1_1;
    let mut cos_q_cos_q_ground1_last = cos_q_cos_q_ground1_1;
    let mut d1_of_place_5_last = d1_of_place_5_1;
    let mut sin_q_cos_q_ground1_last = sin_q_cos_q_ground1_1;
    let mut cos_q_sin_q_ground1_last = cos_q_sin_q_ground1_1;
    let mut d1_of_place_7_last = d1_of_place_7_1;
    let mut d1_of_place_9_last = d1_of_place_9_1;
    let mut d1_of_place_12_last = d1_of_place_12_1;
    let mut d1_of_place_14_last = d1_of_place_14_1;
    let mut d1_of_place_16_last = d1_of_place_16_1;
    let mut d1_of_place_18_last = d1_of_place_18_1;
    let mut d1_of_place_20_last = d1_of_place_20_1;
    let mut d1_of_place_23_last = d1_of_place_23_1;
    let mut d1_of_place_24_last = d1_of_place_24_1;
    let mut d1_of_place_26_last = d1_of_place_26_1;
    let mut d1_of_place_29_last = d1_of_place_29_1;
    let mut d1_of_place_31_last = d1_of_place_31_1;
    let mut d1_of_place_33_last = d1_of_place_33_1;
    let mut d1_of_place_35_last = d1_of_place_35_1;
    let mut d1_of_place_38_last = d1_of_place_38_1;
    let mut d1_of_place_39_last = d1_of_place_39_1;
    let mut sin_q_pin1_sin_angle_inv_last = sin_q_pin1_sin_angle_inv_1;
    let mut d1_of_place_40_last = d1_of_place_40_1;
    let mut d1_of_place_42_last = d1_of_place_42_1;
    let mut d1_of_place_43_last = d1_of_place_43_1;
    let mut d1_of_place_45_last = d1_of_place_45_1;
    let mut d1_of_place_48_last = d1_of_place_48_1;
    let mut d1_of_place_49_last = d1_of_place_49_1;
    let mut q_2_plus_q_pin1_last = q_2_plus_q_pin1_1;
    let mut sin_q_plus_q_pin1_last = sin_q_plus_q_pin1_1;
    let mut cos_q_plus_q_pin1_last = cos_q_plus_q_pin1_1;
    let mut u_dot_of_q_pin1_last = u_dot_of_q_pin1_1;
    let mut u_dot_of_q_2_q_pin1_3_last = u_dot_of_q_2_q_pin1_3_1;
    let mut u_dot_of_q_2_q_pin1_4_last = u_dot_of_q_2_q_pin1_4_1;
    let mut sin_q_pin1_sin_q_ground1_last = sin_q_pin1_sin_q_ground1_1;
    let mut u_dot_of_place_5_last = u_dot_of_place_5_1;
    let mut u_2_sin_angle_inv_last = u_2_sin_angle_inv_1;
    let mut q_ground1_dot_2_last = q_ground1_dot_2_1;
    let mut q_ground2_dot_2_last = q_ground2_dot_2_1;
    let mut u_dot_of_place_8_last = u_dot_of_place_8_1;
    let mut u_dot_of_place_9_last = u_dot_of_place_9_1;
    let mut u_dot_of_u_2_last = u_dot_of_u_2_1;
    let mut u_dot_of_place_10_last = u_dot_of_place_10_1;
    let mut u_dot_of_u_2_2_last = u_dot_of_u_2_2_1;
    let mut u_dot_of_place_11_last = u_dot_of_place_11_1;
    let mut u_dot_of_u_2_3_last = u_dot_of_u_2_3_1;
    let mut u_dot_of_place_12_last = u_dot_of_place_12_1;
    let mut u_2_sq_sin_angle_inv2_last = u_2_sq_sin_angle_inv2_1;
    let mut u_dot_of_u_2_4_last = u_dot_of_u_2_4_1;
    let mut u_dot_of_u_2_5_last = u_dot_of_u_2_5_1;
    let mut u_dot_of_u_2_6_last = u_dot_of_u_2_6_1;
    let mut u_dot_of_u_2_7_last = u_dot_of_u_2_7_1;
    let mut u_dot_of_u_2_8_last = u_dot_of_u_2_8_1;
    let mut u_dot_of_u_2_13_last = u_dot_of_u_2_13_1;
    let mut u_dot_of_u_2_14_last = u_dot_of_u_2_14_1;
    let mut u_dot_of_u_2_19_last = u_dot_of_u_2_19_1;
    let mut u_dot_of_place_13_last = u_dot_of_place_13_1;
    let mut u_dot_of_u_2_22_last = u_dot_of_u_2_22_1;
    let mut u_dot_of_u_2_23_last = u_dot_of_u_2_23_1;
    let mut u_dot_of_place_14_last = u_dot_of_place_14_1;
    let mut u_dot_of_u_2_25_last = u_dot_of_u_2_25_1;
    let mut u_dot_of_u_2_27_last = u_dot_of_u_2_27_1;
    let mut u_dot_of_u_2_31_last = u_dot_of_u_2_31_1;
    let mut u_dot_of_place_15_last = u_dot_of_place_15_1;
    let mut u_dot_of_u_2_33_last = u_dot_of_u_2_33_1;
    let mut u_dot_of_place_16_last = u_dot_of_place_16_1;
    let mut u_dot_of_place_17_last = u_dot_of_place_17_1;
    let mut u_dot_of_place_18_last = u_dot_of_place_18_1;
    let mut u_dot_of_u_2_39_last = u_dot_of_u_2_39_1;
    let mut u_dot_of_u_2_42_last = u_dot_of_u_2_42_1;
    let mut u_dot_of_u_2_44_last = u_dot_of_u_2_44_1;
    let mut u_dot_of_u_2_46_last = u_dot_of_u_2_46_1;
    let mut u_dot_of_place_20_last = u_dot_of_place_20_1;
    let mut u_dot_of_place_21_last = u_dot_of_place_21_1;
    let mut sin_q_pin1_cos_angle_last = sin_q_pin1_cos_angle_1;
    let mut u_dot_of_place_23_last = u_dot_of_place_23_1;
    let mut u_dot_of_u_2_48_last = u_dot_of_u_2_48_1;
    let mut u_dot_of_place_25_last = u_dot_of_place_25_1;
    let mut u_dot_of_place_26_last = u_dot_of_place_26_1;
    let mut sin_angle_inv_cos_angle_last = sin_angle_inv_cos_angle_1;
    let mut u_dot_of_place_28_last = u_dot_of_place_28_1;
    let mut u_dot_of_place_31_last = u_dot_of_place_31_1;
    let mut sin_q_pin1_cos_q_pin2_last = sin_q_pin1_cos_q_pin2_1;
    let mut u_dot_of_place_34_last = u_dot_of_place_34_1;
    let mut u_dot_of_place_38_last = u_dot_of_place_38_1;
    let mut u_dot_of_u_2_50_last = u_dot_of_u_2_50_1;
    let mut u_2_sq_last = u_2_sq_1;
    let mut u_dot_of_q_pin1_2_last = u_dot_of_q_pin1_2_1;
    let mut u_dot_of_place_41_last = u_dot_of_place_41_1;
    let mut u_dot_of_place_44_last = u_dot_of_place_44_1;
    let mut u_dot_of_place_46_last = u_dot_of_place_46_1;
    let mut u_dot_of_place_48_last = u_dot_of_place_48_1;
    let mut u_dot_of_q_2_q_pin1_6_last = u_dot_of_q_2_q_pin1_6_1;
    let mut u_dot_of_place_50_last = u_dot_of_place_50_1;
    let mut u_dot_of_place_53_last = u_dot_of_place_53_1;
    let mut u_dot_of_place_55_last = u_dot_of_place_55_1;
    let mut u_dot_of_q_2_q_pin1_9_last = u_dot_of_q_2_q_pin1_9_1;
    let mut u_dot_of_q_2_q_pin1_11_last = u_dot_of_q_2_q_pin1_11_1;
    let mut u_dot_of_q_2_q_pin1_13_last = u_dot_of_q_2_q_pin1_13_1;
    let mut u_dot_of_place_58_last = u_dot_of_place_58_1;
    let mut u_dot_of_place_61_last = u_dot_of_place_61_1;
    let mut u_dot_of_place_63_last = u_dot_of_place_63_1;
    let mut u_dot_of_place_66_last = u_dot_of_place_66_1;
    let mut u_dot_of_place_68_last = u_dot_of_place_68_1;
    let mut u_dot_of_u_2_51_last = u_dot_of_u_2_51_1;
    let mut u_dot_of_place_69_last = u_dot_of_place_69_1;
    let mut u_dot_of_place_70_last = u_dot_of_place_70_1;
    let mut u_dot_of_u_2_57_last = u_dot_of_u_2_57_1;
    let mut u_dot_of_place_71_last = u_dot_of_place_71_1;
    let mut u_dot_of_u_2_60_last = u_dot_of_u_2_60_1;
    let mut u_dot_of_u_2_62_last = u_dot_of_u_2_62_1;
    let mut u_dot_of_u_2_64_last = u_dot_of_u_2_64_1;
    let mut u_dot_of_place_72_last = u_dot_of_place_72_1;
    let mut u_dot_of_place_73_last = u_dot_of_place_73_1;
    let mut u_dot_of_u_2_67_last = u_dot_of_u_2_67_1;
    let mut u_dot_of_u_2_69_last = u_dot_of_u_2_69_1;
    let mut u_dot_of_place_74_last = u_dot_of_place_74_1;
    let mut u_dot_of_u_2_71_last = u_dot_of_u_2_71_1;
    let mut u_dot_of_place_75_last = u_dot_of_place_75_1;
    let mut u_dot_of_u_2_73_last = u_dot_of_u_2_73_1;
    let mut u_dot_of_place_76_last = u_dot_of_place_76_1;
    let mut u_dot_of_u_2_76_last = u_dot_of_u_2_76_1;
    let mut next = [S::int(0); 184];
    // Rates at order k - 1.
    let mut q_2_rate = u_2_1;
    let mut q_ground1_rate = q_ground1_dot_2_1;
    let mut q_ground2_rate = q_ground2_dot_2_1;
    let mut q_pin1_rate = q_pin1_dot_2_1;
    let mut q_pin2_rate = q_pin2_dot_2_1;
    let mut u_2_rate = minus_1_by_4_m_l_2 * u_dot_of_u_2_76_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q_2 = q_2_rate * over_k;
        let q_ground1 = q_ground1_rate * over_k;
        let q_ground2 = q_ground2_rate * over_k;
        let q_pin1 = q_pin1_rate * over_k;
        let q_pin2 = q_pin2_rate * over_k;
        let u_2 = u_2_rate * over_k;
        series[order] = [q_2, q_ground1, q_ground2, q_pin1, q_pin2, u_2];
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
                q_pin1_1
                    .mul_add(
                        cos_q_pin1_last,
                        (count_last * q_pin1_last).mul_add(cos_q_pin1_1, next[0]),
                    ),
                q_pin1_1
                    .mul_add(
                        sin_q_pin1_last,
                        (count_last * q_pin1_last).mul_add(sin_q_pin1_1, next[1]),
                    ),
                q_pin2_1
                    .mul_add(
                        cos_q_pin2_last,
                        (count_last * q_pin2_last).mul_add(cos_q_pin2_1, next[2]),
                    ),
                q_pin2_1
                    .mul_add(
                        sin_q_pin2_last,
                        (count_last * q_pin2_last).mul_add(sin_q_pin2_1, next[3]),
                    ),
                q_2_1
                    .mul_add(
                        cos_q_last,
                        (count_last * q_2_last).mul_add(cos_q_1, next[4]),
                    ),
                q_2_1
                    .mul_add(
                        sin_q_last,
                        (count_last * q_2_last).mul_add(sin_q_1, next[5]),
                    ),
                q_ground1_1
                    .mul_add(
                        cos_q_ground1_last,
                        (count_last * q_ground1_last).mul_add(cos_q_ground1_1, next[6]),
                    ),
                q_ground1_1
                    .mul_add(
                        sin_q_ground1_last,
                        (count_last * q_ground1_last).mul_add(sin_q_ground1_1, next[7]),
                    ),
                d1_of_place_1
                    .mul_add(
                        cos_angle_last,
                        (count_last * d1_of_place_last).mul_add(cos_angle_1, next[8]),
                    ),
                d1_of_place_1
                    .mul_add(
                        sin_angle_last,
                        (count_last * d1_of_place_last).mul_add(sin_angle_1, next[9]),
                    ),
                q_ground2_1
                    .mul_add(
                        cos_q_ground2_last,
                        (count_last * q_ground2_last).mul_add(cos_q_ground2_1, next[10]),
                    ),
                q_ground2_1
                    .mul_add(
                        sin_q_ground2_last,
                        (count_last * q_ground2_last).mul_add(sin_q_ground2_1, next[11]),
                    ),
                q_ground1_plus_q_pin2_1
                    .mul_add(
                        cos_q_ground1_plus_q_pin2_last,
                        (count_last * q_ground1_plus_q_pin2_last)
                            .mul_add(cos_q_ground1_plus_q_pin2_1, next[12]),
                    ),
                q_ground1_plus_q_pin2_1
                    .mul_add(
                        sin_q_ground1_plus_q_pin2_last,
                        (count_last * q_ground1_plus_q_pin2_last)
                            .mul_add(sin_q_ground1_plus_q_pin2_1, next[13]),
                    ),
                d1_of_place_2_1
                    .mul_add(
                        cos_angle_2_last,
                        (count_last * d1_of_place_2_last)
                            .mul_add(cos_angle_2_1, next[14]),
                    ),
                d1_of_place_2_1
                    .mul_add(
                        sin_angle_2_last,
                        (count_last * d1_of_place_2_last)
                            .mul_add(sin_angle_2_1, next[15]),
                    ),
                sin_q_1
                    .mul_add(
                        sin_q_ground1_last,
                        sin_q_last.mul_add(sin_q_ground1_1, next[16]),
                    ),
                cos_q_1
                    .mul_add(
                        cos_q_ground1_last,
                        cos_q_last.mul_add(cos_q_ground1_1, next[17]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        d1_of_place_5_last,
                        sin_q_pin1_last.mul_add(d1_of_place_5_1, next[18]),
                    ),
                sin_q_1
                    .mul_add(
                        cos_q_ground1_last,
                        sin_q_last.mul_add(cos_q_ground1_1, next[19]),
                    ),
                cos_q_1
                    .mul_add(
                        sin_q_ground1_last,
                        cos_q_last.mul_add(sin_q_ground1_1, next[20]),
                    ),
                cos_q_pin1_1
                    .mul_add(
                        d1_of_place_7_last,
                        cos_q_pin1_last.mul_add(d1_of_place_7_1, next[21]),
                    ),
                sin_q_ground2_1
                    .mul_add(
                        cos_q_ground1_plus_q_pin2_last,
                        sin_q_ground2_last.mul_add(cos_q_ground1_plus_q_pin2_1, next[22]),
                    ),
                cos_q_ground2_1
                    .mul_add(
                        d1_of_place_3_last,
                        cos_q_ground2_last.mul_add(d1_of_place_3_1, next[23]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        d1_of_place_12_last,
                        sin_angle_2_last.mul_add(d1_of_place_12_1, next[24]),
                    ),
                sin_q_ground1_plus_q_pin2_1
                    .mul_add(
                        d1_of_place_12_last,
                        sin_q_ground1_plus_q_pin2_last
                            .mul_add(d1_of_place_12_1, next[25]),
                    ),
                d1_of_place_9_1
                    .mul_add(
                        d1_of_place_14_last,
                        d1_of_place_9_last.mul_add(d1_of_place_14_1, next[26]),
                    ),
                sin_q_ground2_1
                    .mul_add(
                        d1_of_place_16_last,
                        sin_q_ground2_last.mul_add(d1_of_place_16_1, next[27]),
                    ),
                cos_q_ground1_1
                    .mul_add(
                        d1_of_place_18_last,
                        cos_q_ground1_last.mul_add(d1_of_place_18_1, next[28]),
                    ),
                cos_q_ground1_plus_q_pin2_1
                    .mul_add(
                        d1_of_place_20_last,
                        cos_q_ground1_plus_q_pin2_last
                            .mul_add(d1_of_place_20_1, next[29]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        d1_of_place_24_last,
                        sin_angle_2_last.mul_add(d1_of_place_24_1, next[30]),
                    ),
                cos_q_pin2_1
                    .mul_add(
                        d1_of_place_4_last,
                        cos_q_pin2_last.mul_add(d1_of_place_4_1, next[31]),
                    ),
                sin_q_ground2_1
                    .mul_add(
                        d1_of_place_26_last,
                        sin_q_ground2_last.mul_add(d1_of_place_26_1, next[32]),
                    ),
                d1_of_place_23_1
                    .mul_add(
                        d1_of_place_12_last,
                        d1_of_place_23_last.mul_add(d1_of_place_12_1, next[33]),
                    ),
                sin_q_ground1_1
                    .mul_add(
                        d1_of_place_29_last,
                        sin_q_ground1_last.mul_add(d1_of_place_29_1, next[34]),
                    ),
                sin_q_ground1_plus_q_pin2_1
                    .mul_add(
                        d1_of_place_31_last,
                        sin_q_ground1_plus_q_pin2_last
                            .mul_add(d1_of_place_31_1, next[35]),
                    ),
                cos_q_ground2_1
                    .mul_add(
                        d1_of_place_33_last,
                        cos_q_ground2_last.mul_add(d1_of_place_33_1, next[36]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        d1_of_place_35_last,
                        sin_angle_2_last.mul_add(d1_of_place_35_1, next[37]),
                    ),
                sin_q_pin2_1
                    .mul_add(
                        d1_of_place_35_last,
                        sin_q_pin2_last.mul_add(d1_of_place_35_1, next[38]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        d1_of_place_38_last,
                        sin_angle_2_last.mul_add(d1_of_place_38_1, next[39]),
                    ),
                sin_angle_1
                    .mul_add(
                        sin_q_pin1_sin_angle_inv_last,
                        sin_angle_last.mul_add(sin_q_pin1_sin_angle_inv_1, next[40]),
                    ),
                (sin_q_pin1_sin_angle_inv_1 + sin_q_pin1_sin_angle_inv_1)
                    .mul_add(sin_q_pin1_sin_angle_inv_last, next[41]),
                d1_of_place_39_1
                    .mul_add(
                        d1_of_place_40_last,
                        d1_of_place_39_last.mul_add(d1_of_place_40_1, next[42]),
                    ),
                d1_of_place_9_1
                    .mul_add(
                        d1_of_place_42_last,
                        d1_of_place_9_last.mul_add(d1_of_place_42_1, next[43]),
                    ),
                d1_of_place_43_1
                    .mul_add(
                        sin_q_cos_q_ground1_last,
                        d1_of_place_43_last.mul_add(sin_q_cos_q_ground1_1, next[44]),
                    ),
                d1_of_place_45_1
                    .mul_add(
                        cos_q_sin_q_ground1_last,
                        d1_of_place_45_last.mul_add(cos_q_sin_q_ground1_1, next[45]),
                    ),
                d1_of_place_9_1
                    .mul_add(
                        d1_of_place_48_last,
                        d1_of_place_9_last.mul_add(d1_of_place_48_1, next[46]),
                    ),
                q_2_plus_q_pin1_1
                    .mul_add(
                        cos_q_plus_q_pin1_last,
                        (count_last * q_2_plus_q_pin1_last)
                            .mul_add(cos_q_plus_q_pin1_1, next[47]),
                    ),
                q_2_plus_q_pin1_1
                    .mul_add(
                        sin_q_plus_q_pin1_last,
                        (count_last * q_2_plus_q_pin1_last)
                            .mul_add(sin_q_plus_q_pin1_1, next[48]),
                    ),
                cos_q_1
                    .mul_add(
                        u_dot_of_q_pin1_last,
                        cos_q_last.mul_add(u_dot_of_q_pin1_1, next[49]),
                    ),
                sin_q_pin1_1
                    .mul_add(sin_q_last, sin_q_pin1_last.mul_add(sin_q_1, next[50])),
                sin_q_1
                    .mul_add(
                        u_dot_of_q_pin1_last,
                        sin_q_last.mul_add(u_dot_of_q_pin1_1, next[51]),
                    ),
                sin_q_pin1_1
                    .mul_add(cos_q_last, sin_q_pin1_last.mul_add(cos_q_1, next[52])),
                cos_q_ground1_1
                    .mul_add(
                        u_dot_of_q_pin1_last,
                        cos_q_ground1_last.mul_add(u_dot_of_q_pin1_1, next[53]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        sin_q_ground1_last,
                        sin_q_pin1_last.mul_add(sin_q_ground1_1, next[54]),
                    ),
                sin_q_ground1_1
                    .mul_add(
                        u_dot_of_q_pin1_last,
                        sin_q_ground1_last.mul_add(u_dot_of_q_pin1_1, next[55]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        cos_q_ground1_last,
                        sin_q_pin1_last.mul_add(cos_q_ground1_1, next[56]),
                    ),
                sin_q_ground1_1
                    .mul_add(
                        u_dot_of_q_2_q_pin1_4_last,
                        sin_q_ground1_last.mul_add(u_dot_of_q_2_q_pin1_4_1, next[57]),
                    ),
                cos_q_ground1_1
                    .mul_add(
                        u_dot_of_q_2_q_pin1_3_last,
                        cos_q_ground1_last.mul_add(u_dot_of_q_2_q_pin1_3_1, next[58]),
                    ),
                sin_q_ground2_1
                    .mul_add(
                        d1_of_place_4_last,
                        sin_q_ground2_last.mul_add(d1_of_place_4_1, next[59]),
                    ),
                sin_angle_1
                    .mul_add(
                        u_2_sin_angle_inv_last,
                        sin_angle_last.mul_add(u_2_sin_angle_inv_1, next[60]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        u_2_sin_angle_inv_last,
                        sin_q_pin1_last.mul_add(u_2_sin_angle_inv_1, next[61]),
                    ),
                q_ground1_dot_2_1
                    .mul_add(
                        d1_of_place_35_last,
                        q_ground1_dot_2_last.mul_add(d1_of_place_35_1, next[62]),
                    ),
                sin_angle_1
                    .mul_add(
                        u_dot_of_place_8_last,
                        sin_angle_last.mul_add(u_dot_of_place_8_1, next[63]),
                    ),
                u_dot_of_place_5_1
                    .mul_add(
                        u_2_sin_angle_inv_last,
                        u_dot_of_place_5_last.mul_add(u_2_sin_angle_inv_1, next[64]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        u_dot_of_place_9_last,
                        sin_angle_2_last.mul_add(u_dot_of_place_9_1, next[65]),
                    ),
                q_ground1_dot_2_1
                    .mul_add(
                        u_dot_of_place_9_last,
                        q_ground1_dot_2_last.mul_add(u_dot_of_place_9_1, next[66]),
                    ),
                cos_q_pin1_1
                    .mul_add(
                        u_dot_of_place_5_last,
                        cos_q_pin1_last.mul_add(u_dot_of_place_5_1, next[67]),
                    ),
                (u_2_sin_angle_inv_1 + u_2_sin_angle_inv_1)
                    .mul_add(u_2_sin_angle_inv_last, next[68]),
                u_dot_of_place_12_1
                    .mul_add(
                        u_2_sq_sin_angle_inv2_last,
                        u_dot_of_place_12_last.mul_add(u_2_sq_sin_angle_inv2_1, next[69]),
                    ),
                sin_angle_1
                    .mul_add(
                        u_dot_of_u_2_5_last,
                        sin_angle_last.mul_add(u_dot_of_u_2_5_1, next[70]),
                    ),
                cos_angle_1
                    .mul_add(
                        u_dot_of_u_2_3_last,
                        cos_angle_last.mul_add(u_dot_of_u_2_3_1, next[71]),
                    ),
                u_dot_of_u_2_5_1
                    .mul_add(
                        u_dot_of_u_2_6_last,
                        u_dot_of_u_2_5_last.mul_add(u_dot_of_u_2_6_1, next[72]),
                    ),
                cos_q_ground1_1
                    .mul_add(
                        q_ground1_dot_2_last,
                        cos_q_ground1_last.mul_add(q_ground1_dot_2_1, next[73]),
                    ),
                sin_q_ground1_1
                    .mul_add(
                        q_ground1_dot_2_last,
                        sin_q_ground1_last.mul_add(q_ground1_dot_2_1, next[74]),
                    ),
                u_2_1
                    .mul_add(
                        cos_q_sin_q_ground1_last,
                        u_2_last.mul_add(cos_q_sin_q_ground1_1, next[75]),
                    ),
                q_ground1_dot_2_1
                    .mul_add(
                        sin_q_cos_q_ground1_last,
                        q_ground1_dot_2_last.mul_add(sin_q_cos_q_ground1_1, next[76]),
                    ),
                u_2_1
                    .mul_add(
                        sin_q_cos_q_ground1_last,
                        u_2_last.mul_add(sin_q_cos_q_ground1_1, next[77]),
                    ),
                q_ground1_dot_2_1
                    .mul_add(
                        cos_q_sin_q_ground1_last,
                        q_ground1_dot_2_last.mul_add(cos_q_sin_q_ground1_1, next[78]),
                    ),
                d1_of_place_5_1
                    .mul_add(
                        u_2_sin_angle_inv_last,
                        d1_of_place_5_last.mul_add(u_2_sin_angle_inv_1, next[79]),
                    ),
                u_dot_of_place_12_1
                    .mul_add(
                        u_dot_of_u_2_14_last,
                        u_dot_of_place_12_last.mul_add(u_dot_of_u_2_14_1, next[80]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        u_dot_of_u_2_13_last,
                        sin_q_pin1_last.mul_add(u_dot_of_u_2_13_1, next[81]),
                    ),
                u_2_1
                    .mul_add(
                        cos_q_cos_q_ground1_last,
                        u_2_last.mul_add(cos_q_cos_q_ground1_1, next[82]),
                    ),
                q_ground1_dot_2_1
                    .mul_add(
                        sin_q_sin_q_ground1_last,
                        q_ground1_dot_2_last.mul_add(sin_q_sin_q_ground1_1, next[83]),
                    ),
                u_2_1
                    .mul_add(
                        sin_q_sin_q_ground1_last,
                        u_2_last.mul_add(sin_q_sin_q_ground1_1, next[84]),
                    ),
                q_ground1_dot_2_1
                    .mul_add(
                        cos_q_cos_q_ground1_last,
                        q_ground1_dot_2_last.mul_add(cos_q_cos_q_ground1_1, next[85]),
                    ),
                d1_of_place_7_1
                    .mul_add(
                        u_dot_of_place_5_last,
                        d1_of_place_7_last.mul_add(u_dot_of_place_5_1, next[86]),
                    ),
                q_ground1_dot_2_1
                    .mul_add(
                        u_dot_of_place_13_last,
                        q_ground1_dot_2_last.mul_add(u_dot_of_place_13_1, next[87]),
                    ),
                cos_q_pin1_1
                    .mul_add(
                        u_dot_of_u_2_19_last,
                        cos_q_pin1_last.mul_add(u_dot_of_u_2_19_1, next[88]),
                    ),
                d1_of_place_9_1
                    .mul_add(
                        u_dot_of_u_2_23_last,
                        d1_of_place_9_last.mul_add(u_dot_of_u_2_23_1, next[89]),
                    ),
                u_dot_of_u_2_19_1
                    .mul_add(
                        u_dot_of_u_2_23_last,
                        u_dot_of_u_2_19_last.mul_add(u_dot_of_u_2_23_1, next[90]),
                    ),
                d1_of_place_9_1
                    .mul_add(
                        u_dot_of_place_14_last,
                        d1_of_place_9_last.mul_add(u_dot_of_place_14_1, next[91]),
                    ),
                u_dot_of_u_2_23_1
                    .mul_add(
                        u_dot_of_place_14_last,
                        u_dot_of_u_2_23_last.mul_add(u_dot_of_place_14_1, next[92]),
                    ),
                u_dot_of_u_2_22_1
                    .mul_add(
                        u_dot_of_u_2_25_last,
                        u_dot_of_u_2_22_last.mul_add(u_dot_of_u_2_25_1, next[93]),
                    ),
                d1_of_place_7_1
                    .mul_add(
                        u_dot_of_u_2_last,
                        d1_of_place_7_last.mul_add(u_dot_of_u_2_1, next[94]),
                    ),
                u_dot_of_u_2_23_1
                    .mul_add(
                        u_dot_of_u_2_27_last,
                        u_dot_of_u_2_23_last.mul_add(u_dot_of_u_2_27_1, next[95]),
                    ),
                cos_q_ground1_plus_q_pin2_1
                    .mul_add(
                        u_dot_of_u_2_2_last,
                        cos_q_ground1_plus_q_pin2_last
                            .mul_add(u_dot_of_u_2_2_1, next[96]),
                    ),
                sin_q_ground1_plus_q_pin2_1
                    .mul_add(
                        u_dot_of_u_2_2_last,
                        sin_q_ground1_plus_q_pin2_last
                            .mul_add(u_dot_of_u_2_2_1, next[97]),
                    ),
                cos_q_ground2_1
                    .mul_add(
                        d1_of_place_4_last,
                        cos_q_ground2_last.mul_add(d1_of_place_4_1, next[98]),
                    ),
                q_ground2_dot_2_1
                    .mul_add(
                        u_dot_of_place_15_last,
                        q_ground2_dot_2_last.mul_add(u_dot_of_place_15_1, next[99]),
                    ),
                sin_q_ground2_1
                    .mul_add(
                        u_dot_of_u_2_33_last,
                        sin_q_ground2_last.mul_add(u_dot_of_u_2_33_1, next[100]),
                    ),
                sin_q_ground2_1
                    .mul_add(
                        d1_of_place_3_last,
                        sin_q_ground2_last.mul_add(d1_of_place_3_1, next[101]),
                    ),
                q_ground2_dot_2_1
                    .mul_add(
                        u_dot_of_place_16_last,
                        q_ground2_dot_2_last.mul_add(u_dot_of_place_16_1, next[102]),
                    ),
                cos_q_ground2_1
                    .mul_add(
                        u_dot_of_u_2_31_last,
                        cos_q_ground2_last.mul_add(u_dot_of_u_2_31_1, next[103]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        u_dot_of_place_17_last,
                        sin_angle_2_last.mul_add(u_dot_of_place_17_1, next[104]),
                    ),
                u_dot_of_place_9_1
                    .mul_add(
                        u_dot_of_place_17_last,
                        u_dot_of_place_9_last.mul_add(u_dot_of_place_17_1, next[105]),
                    ),
                u_dot_of_u_2_8_1
                    .mul_add(
                        u_dot_of_place_18_last,
                        u_dot_of_u_2_8_last.mul_add(u_dot_of_place_18_1, next[106]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        u_dot_of_u_2_39_last,
                        sin_angle_2_last.mul_add(u_dot_of_u_2_39_1, next[107]),
                    ),
                u_dot_of_place_11_1
                    .mul_add(
                        u_dot_of_u_2_4_last,
                        u_dot_of_place_11_last.mul_add(u_dot_of_u_2_4_1, next[108]),
                    ),
                u_dot_of_place_11_1
                    .mul_add(
                        u_dot_of_u_2_7_last,
                        u_dot_of_place_11_last.mul_add(u_dot_of_u_2_7_1, next[109]),
                    ),
                u_dot_of_u_2_42_1
                    .mul_add(
                        q_ground1_dot_2_last,
                        u_dot_of_u_2_42_last.mul_add(q_ground1_dot_2_1, next[110]),
                    ),
                u_dot_of_place_11_1
                    .mul_add(
                        q_ground1_dot_2_last,
                        u_dot_of_place_11_last.mul_add(q_ground1_dot_2_1, next[111]),
                    ),
                u_dot_of_u_2_2_1
                    .mul_add(
                        u_dot_of_u_2_44_last,
                        u_dot_of_u_2_2_last.mul_add(u_dot_of_u_2_44_1, next[112]),
                    ),
                sin_angle_1
                    .mul_add(
                        u_dot_of_place_20_last,
                        sin_angle_last.mul_add(u_dot_of_place_20_1, next[113]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        cos_angle_last,
                        sin_q_pin1_last.mul_add(cos_angle_1, next[114]),
                    ),
                u_dot_of_place_21_1
                    .mul_add(
                        sin_q_pin1_cos_angle_last,
                        u_dot_of_place_21_last.mul_add(sin_q_pin1_cos_angle_1, next[115]),
                    ),
                u_dot_of_place_23_1
                    .mul_add(
                        u_2_sq_sin_angle_inv2_last,
                        u_dot_of_place_23_last
                            .mul_add(u_2_sq_sin_angle_inv2_1, next[116]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        u_dot_of_place_25_last,
                        sin_angle_2_last.mul_add(u_dot_of_place_25_1, next[117]),
                    ),
                u_dot_of_place_26_1
                    .mul_add(
                        u_dot_of_place_17_last,
                        u_dot_of_place_26_last.mul_add(u_dot_of_place_17_1, next[118]),
                    ),
                sin_angle_1
                    .mul_add(
                        sin_angle_inv_cos_angle_last,
                        sin_angle_last.mul_add(sin_angle_inv_cos_angle_1, next[119]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        u_dot_of_place_28_last,
                        sin_q_pin1_last.mul_add(u_dot_of_place_28_1, next[120]),
                    ),
                cos_angle_1
                    .mul_add(
                        u_dot_of_place_10_last,
                        cos_angle_last.mul_add(u_dot_of_place_10_1, next[121]),
                    ),
                sin_q_pin2_1
                    .mul_add(
                        u_dot_of_place_31_last,
                        sin_q_pin2_last.mul_add(u_dot_of_place_31_1, next[122]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        cos_q_pin2_last,
                        sin_q_pin1_last.mul_add(cos_q_pin2_1, next[123]),
                    ),
                u_dot_of_place_9_1
                    .mul_add(
                        sin_q_pin1_cos_q_pin2_last,
                        u_dot_of_place_9_last.mul_add(sin_q_pin1_cos_q_pin2_1, next[124]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        u_dot_of_place_34_last,
                        sin_q_pin1_last.mul_add(u_dot_of_place_34_1, next[125]),
                    ),
                sin_q_pin2_1
                    .mul_add(
                        u_dot_of_place_12_last,
                        sin_q_pin2_last.mul_add(u_dot_of_place_12_1, next[126]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        u_dot_of_place_38_last,
                        sin_angle_2_last.mul_add(u_dot_of_place_38_1, next[127]),
                    ),
                u_2_sq_sin_angle_inv2_1
                    .mul_add(
                        u_dot_of_place_38_last,
                        u_2_sq_sin_angle_inv2_last
                            .mul_add(u_dot_of_place_38_1, next[128]),
                    ),
                (u_2_1 + u_2_1).mul_add(u_2_last, next[129]),
                cos_q_pin1_1
                    .mul_add(u_2_sq_last, cos_q_pin1_last.mul_add(u_2_sq_1, next[130])),
                cos_q_pin1_1
                    .mul_add(
                        d1_of_place_5_last,
                        cos_q_pin1_last.mul_add(d1_of_place_5_1, next[131]),
                    ),
                sin_q_pin1_1
                    .mul_add(u_2_sq_last, sin_q_pin1_last.mul_add(u_2_sq_1, next[132])),
                cos_q_ground1_1
                    .mul_add(
                        u_dot_of_q_pin1_2_last,
                        cos_q_ground1_last.mul_add(u_dot_of_q_pin1_2_1, next[133]),
                    ),
                sin_q_1
                    .mul_add(
                        u_dot_of_place_41_last,
                        sin_q_last.mul_add(u_dot_of_place_41_1, next[134]),
                    ),
                sin_q_ground1_1
                    .mul_add(
                        u_dot_of_q_pin1_2_last,
                        sin_q_ground1_last.mul_add(u_dot_of_q_pin1_2_1, next[135]),
                    ),
                cos_q_1
                    .mul_add(
                        u_dot_of_place_44_last,
                        cos_q_last.mul_add(u_dot_of_place_44_1, next[136]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        u_dot_of_place_46_last,
                        sin_q_pin1_last.mul_add(u_dot_of_place_46_1, next[137]),
                    ),
                cos_q_ground1_1
                    .mul_add(
                        u_dot_of_place_48_last,
                        cos_q_ground1_last.mul_add(u_dot_of_place_48_1, next[138]),
                    ),
                sin_q_1
                    .mul_add(
                        u_dot_of_q_pin1_2_last,
                        sin_q_last.mul_add(u_dot_of_q_pin1_2_1, next[139]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        u_dot_of_q_2_q_pin1_6_last,
                        sin_q_pin1_last.mul_add(u_dot_of_q_2_q_pin1_6_1, next[140]),
                    ),
                cos_q_1
                    .mul_add(
                        u_dot_of_place_50_last,
                        cos_q_last.mul_add(u_dot_of_place_50_1, next[141]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        u_dot_of_place_44_last,
                        sin_q_pin1_last.mul_add(u_dot_of_place_44_1, next[142]),
                    ),
                cos_q_ground1_1
                    .mul_add(
                        u_dot_of_place_53_last,
                        cos_q_ground1_last.mul_add(u_dot_of_place_53_1, next[143]),
                    ),
                (sin_q_pin1_1 + sin_q_pin1_1).mul_add(sin_q_pin1_last, next[144]),
                cos_q_ground1_1
                    .mul_add(
                        u_dot_of_place_55_last,
                        cos_q_ground1_last.mul_add(u_dot_of_place_55_1, next[145]),
                    ),
                cos_q_1
                    .mul_add(
                        u_dot_of_q_pin1_2_last,
                        cos_q_last.mul_add(u_dot_of_q_pin1_2_1, next[146]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        u_dot_of_q_2_q_pin1_9_last,
                        sin_q_pin1_last.mul_add(u_dot_of_q_2_q_pin1_9_1, next[147]),
                    ),
                cos_q_1
                    .mul_add(
                        u_dot_of_q_2_q_pin1_11_last,
                        cos_q_last.mul_add(u_dot_of_q_2_q_pin1_11_1, next[148]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        cos_q_pin1_last,
                        sin_q_pin1_last.mul_add(cos_q_pin1_1, next[149]),
                    ),
                sin_q_ground1_1
                    .mul_add(
                        u_dot_of_q_2_q_pin1_13_last,
                        sin_q_ground1_last.mul_add(u_dot_of_q_2_q_pin1_13_1, next[150]),
                    ),
                cos_q_1
                    .mul_add(
                        u_dot_of_place_58_last,
                        cos_q_last.mul_add(u_dot_of_place_58_1, next[151]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        u_dot_of_place_41_last,
                        sin_q_pin1_last.mul_add(u_dot_of_place_41_1, next[152]),
                    ),
                cos_q_ground1_1
                    .mul_add(
                        u_dot_of_place_61_last,
                        cos_q_ground1_last.mul_add(u_dot_of_place_61_1, next[153]),
                    ),
                cos_q_ground1_1
                    .mul_add(
                        u_dot_of_place_63_last,
                        cos_q_ground1_last.mul_add(u_dot_of_place_63_1, next[154]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        sin_q_pin1_sin_q_ground1_last,
                        sin_q_pin1_last.mul_add(sin_q_pin1_sin_q_ground1_1, next[155]),
                    ),
                sin_q_1
                    .mul_add(
                        u_dot_of_place_66_last,
                        sin_q_last.mul_add(u_dot_of_place_66_1, next[156]),
                    ),
                (q_ground1_dot_2_1 + q_ground1_dot_2_1)
                    .mul_add(q_ground1_dot_2_last, next[157]),
                cos_q_pin2_1
                    .mul_add(
                        u_dot_of_u_2_51_last,
                        cos_q_pin2_last.mul_add(u_dot_of_u_2_51_1, next[158]),
                    ),
                sin_q_pin2_1
                    .mul_add(
                        u_dot_of_u_2_46_last,
                        sin_q_pin2_last.mul_add(u_dot_of_u_2_46_1, next[159]),
                    ),
                sin_q_pin2_1
                    .mul_add(
                        u_dot_of_u_2_51_last,
                        sin_q_pin2_last.mul_add(u_dot_of_u_2_51_1, next[160]),
                    ),
                cos_q_pin2_1
                    .mul_add(
                        u_dot_of_u_2_46_last,
                        cos_q_pin2_last.mul_add(u_dot_of_u_2_46_1, next[161]),
                    ),
                u_dot_of_u_2_48_1
                    .mul_add(
                        sin_q_pin1_sin_angle_inv_last,
                        u_dot_of_u_2_48_last
                            .mul_add(sin_q_pin1_sin_angle_inv_1, next[162]),
                    ),
                u_2_sin_angle_inv_1
                    .mul_add(
                        u_dot_of_u_2_5_last,
                        u_2_sin_angle_inv_last.mul_add(u_dot_of_u_2_5_1, next[163]),
                    ),
                u_dot_of_place_23_1
                    .mul_add(
                        u_dot_of_u_2_57_last,
                        u_dot_of_place_23_last.mul_add(u_dot_of_u_2_57_1, next[164]),
                    ),
                d1_of_place_35_1
                    .mul_add(
                        sin_q_pin1_sin_angle_inv_last,
                        d1_of_place_35_last
                            .mul_add(sin_q_pin1_sin_angle_inv_1, next[165]),
                    ),
                u_dot_of_u_2_50_1
                    .mul_add(
                        u_dot_of_place_71_last,
                        u_dot_of_u_2_50_last.mul_add(u_dot_of_place_71_1, next[166]),
                    ),
                d1_of_place_35_1
                    .mul_add(
                        u_dot_of_u_2_57_last,
                        d1_of_place_35_last.mul_add(u_dot_of_u_2_57_1, next[167]),
                    ),
                u_dot_of_place_38_1
                    .mul_add(
                        u_dot_of_u_2_60_last,
                        u_dot_of_place_38_last.mul_add(u_dot_of_u_2_60_1, next[168]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        u_dot_of_u_2_62_last,
                        sin_q_pin1_last.mul_add(u_dot_of_u_2_62_1, next[169]),
                    ),
                u_dot_of_place_70_1
                    .mul_add(
                        u_dot_of_u_2_64_last,
                        u_dot_of_place_70_last.mul_add(u_dot_of_u_2_64_1, next[170]),
                    ),
                (d1_of_place_9_1 + d1_of_place_9_1)
                    .mul_add(d1_of_place_9_last, next[171]),
                (u_dot_of_place_72_1 + u_dot_of_place_72_1)
                    .mul_add(u_dot_of_place_72_last, next[172]),
                d1_of_place_7_1
                    .mul_add(
                        u_2_sq_last,
                        d1_of_place_7_last.mul_add(u_2_sq_1, next[173]),
                    ),
                u_dot_of_place_73_1
                    .mul_add(
                        u_dot_of_u_2_67_last,
                        u_dot_of_place_73_last.mul_add(u_dot_of_u_2_67_1, next[174]),
                    ),
                u_dot_of_place_68_1
                    .mul_add(
                        u_dot_of_u_2_67_last,
                        u_dot_of_place_68_last.mul_add(u_dot_of_u_2_67_1, next[175]),
                    ),
                sin_q_pin2_1
                    .mul_add(
                        sin_q_pin1_sin_angle_inv_last,
                        sin_q_pin2_last.mul_add(sin_q_pin1_sin_angle_inv_1, next[176]),
                    ),
                u_dot_of_u_2_69_1
                    .mul_add(
                        u_dot_of_place_74_last,
                        u_dot_of_u_2_69_last.mul_add(u_dot_of_place_74_1, next[177]),
                    ),
                u_dot_of_place_69_1
                    .mul_add(
                        sin_q_pin1_sin_angle_inv_last,
                        u_dot_of_place_69_last
                            .mul_add(sin_q_pin1_sin_angle_inv_1, next[178]),
                    ),
                u_dot_of_u_2_71_1
                    .mul_add(
                        u_dot_of_place_75_last,
                        u_dot_of_u_2_71_last.mul_add(u_dot_of_place_75_1, next[179]),
                    ),
                u_dot_of_place_11_1
                    .mul_add(
                        sin_q_pin1_sin_angle_inv_last,
                        u_dot_of_place_11_last
                            .mul_add(sin_q_pin1_sin_angle_inv_1, next[180]),
                    ),
                u_dot_of_u_2_73_1
                    .mul_add(
                        u_dot_of_place_76_last,
                        u_dot_of_u_2_73_last.mul_add(u_dot_of_place_76_1, next[181]),
                    ),
                d1_of_place_49_1
                    .mul_add(
                        u_dot_of_u_2_76_last,
                        d1_of_place_49_last.mul_add(u_dot_of_u_2_76_1, next[182]),
                    ),
            ])
        };
        // sin_q_pin1 = sin(q_pin1)
        let sin_q_pin1 = q_pin1.mul_add(cos_q_pin1_0, sums[0] * over_k);
        // cos_q_pin1 = cos(q_pin1)
        let cos_q_pin1 = -q_pin1.mul_add(sin_q_pin1_0, sums[1] * over_k);
        // sin_q_pin2 = sin(q_pin2)
        let sin_q_pin2 = q_pin2.mul_add(cos_q_pin2_0, sums[2] * over_k);
        // cos_q_pin2 = cos(q_pin2)
        let cos_q_pin2 = -q_pin2.mul_add(sin_q_pin2_0, sums[3] * over_k);
        // sin_q = sin(q_2)
        let sin_q = q_2.mul_add(cos_q_0, sums[4] * over_k);
        // cos_q = cos(q_2)
        let cos_q = -q_2.mul_add(sin_q_0, sums[5] * over_k);
        // sin_q_ground1 = sin(q_ground1)
        let sin_q_ground1 = q_ground1.mul_add(cos_q_ground1_0, sums[6] * over_k);
        // cos_q_ground1 = cos(q_ground1)
        let cos_q_ground1 = -q_ground1.mul_add(sin_q_ground1_0, sums[7] * over_k);
        // d1_of_place = q_2 - q_ground1 + q_pin1
        let d1_of_place = q_2 + q_pin1 - q_ground1;
        // sin_angle = sin(d1_of_place)
        let sin_angle = d1_of_place.mul_add(cos_angle_0, sums[8] * over_k);
        // cos_angle = cos(d1_of_place)
        let cos_angle = -d1_of_place.mul_add(sin_angle_0, sums[9] * over_k);
        // sin_q_ground2 = sin(q_ground2)
        let sin_q_ground2 = q_ground2.mul_add(cos_q_ground2_0, sums[10] * over_k);
        // cos_q_ground2 = cos(q_ground2)
        let cos_q_ground2 = -q_ground2.mul_add(sin_q_ground2_0, sums[11] * over_k);
        // q_ground1_plus_q_pin2 = q_ground1 + q_pin2
        let q_ground1_plus_q_pin2 = q_ground1 + q_pin2;
        // sin_q_ground1_plus_q_pin2 = sin(q_ground1_plus_q_pin2)
        let sin_q_ground1_plus_q_pin2 = q_ground1_plus_q_pin2
            .mul_add(cos_q_ground1_plus_q_pin2_0, sums[12] * over_k);
        // cos_q_ground1_plus_q_pin2 = cos(q_ground1_plus_q_pin2)
        let cos_q_ground1_plus_q_pin2 = -q_ground1_plus_q_pin2
            .mul_add(sin_q_ground1_plus_q_pin2_0, sums[13] * over_k);
        // d1_of_place_2 = q_ground1 - q_ground2 + q_pin2
        let d1_of_place_2 = q_ground1 + q_pin2 - q_ground2;
        // sin_angle_2 = sin(d1_of_place_2)
        let sin_angle_2 = d1_of_place_2.mul_add(cos_angle_2_0, sums[14] * over_k);
        // cos_angle_2 = cos(d1_of_place_2)
        let cos_angle_2 = -d1_of_place_2.mul_add(sin_angle_2_0, sums[15] * over_k);
        // d1_of_place_3 = sin_q_ground1 + sin_q_ground1_plus_q_pin2
        let d1_of_place_3 = sin_q_ground1 + sin_q_ground1_plus_q_pin2;
        // d1_of_place_4 = cos_q_ground1 + cos_q_ground1_plus_q_pin2
        let d1_of_place_4 = cos_q_ground1 + cos_q_ground1_plus_q_pin2;
        // sin_q_sin_q_ground1 = sin_q*sin_q_ground1
        let sin_q_sin_q_ground1 = sin_q_ground1
            .mul_add(sin_q_0, sin_q.mul_add(sin_q_ground1_0, sums[16]));
        // cos_q_cos_q_ground1 = cos_q*cos_q_ground1
        let cos_q_cos_q_ground1 = cos_q_ground1
            .mul_add(cos_q_0, cos_q.mul_add(cos_q_ground1_0, sums[17]));
        // d1_of_place_5 = sin_q_sin_q_ground1 + cos_q_cos_q_ground1
        let d1_of_place_5 = sin_q_sin_q_ground1 + cos_q_cos_q_ground1;
        // d1_of_place_6 = sin_q_pin1*d1_of_place_5
        let d1_of_place_6 = d1_of_place_5
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(d1_of_place_5_0, sums[18]));
        // sin_q_cos_q_ground1 = sin_q*cos_q_ground1
        let sin_q_cos_q_ground1 = cos_q_ground1
            .mul_add(sin_q_0, sin_q.mul_add(cos_q_ground1_0, sums[19]));
        // cos_q_sin_q_ground1 = cos_q*sin_q_ground1
        let cos_q_sin_q_ground1 = sin_q_ground1
            .mul_add(cos_q_0, cos_q.mul_add(sin_q_ground1_0, sums[20]));
        // d1_of_place_7 = sin_q_cos_q_ground1 - cos_q_sin_q_ground1
        let d1_of_place_7 = sin_q_cos_q_ground1 - cos_q_sin_q_ground1;
        // d1_of_place_8 = cos_q_pin1*d1_of_place_7
        let d1_of_place_8 = d1_of_place_7
            .mul_add(cos_q_pin1_0, cos_q_pin1.mul_add(d1_of_place_7_0, sums[21]));
        // d1_of_place_9 = d1_of_place_6 + d1_of_place_8
        let d1_of_place_9 = d1_of_place_6 + d1_of_place_8;
        // d1_of_place_10 = sin_q_ground2*cos_q_ground1_plus_q_pin2
        let d1_of_place_10 = cos_q_ground1_plus_q_pin2
            .mul_add(
                sin_q_ground2_0,
                sin_q_ground2.mul_add(cos_q_ground1_plus_q_pin2_0, sums[22]),
            );
        // d1_of_place_11 = cos_q_ground2*d1_of_place_3
        let d1_of_place_11 = d1_of_place_3
            .mul_add(cos_q_ground2_0, cos_q_ground2.mul_add(d1_of_place_3_0, sums[23]));
        // d1_of_place_12 = cos_q_ground2/sin_angle_2
        let d1_of_place_12 = sin_angle_2
            .mul_add(
                -(d1_of_place_12_0 * over_sin_angle_2),
                (cos_q_ground2 - sums[24]) * over_sin_angle_2,
            );
        // d1_of_place_13 = sin_q_ground1_plus_q_pin2*d1_of_place_12
        let d1_of_place_13 = d1_of_place_12
            .mul_add(
                sin_q_ground1_plus_q_pin2_0,
                sin_q_ground1_plus_q_pin2.mul_add(d1_of_place_12_0, sums[25]),
            );
        // d1_of_place_14 = cos_q_sin_q_ground1/d1_of_place_9
        let d1_of_place_14 = d1_of_place_9
            .mul_add(
                -(d1_of_place_14_0 * over_d1_of_place_9),
                (cos_q_sin_q_ground1 - sums[26]) * over_d1_of_place_9,
            );
        // d1_of_place_15 = sin_q_cos_q_ground1 - 2*cos_q_sin_q_ground1
        let d1_of_place_15 = cos_q_sin_q_ground1
            .mul_add(-S::int(2), sin_q_cos_q_ground1);
        // d1_of_place_16 = cos_q_ground1 + 2*cos_q_ground1_plus_q_pin2
        let d1_of_place_16 = cos_q_ground1_plus_q_pin2.mul_add(S::int(2), cos_q_ground1);
        // d1_of_place_17 = sin_q_ground2*d1_of_place_16
        let d1_of_place_17 = d1_of_place_16
            .mul_add(sin_q_ground2_0, sin_q_ground2.mul_add(d1_of_place_16_0, sums[27]));
        // d1_of_place_18 = 2*d1_of_place_11 - d1_of_place_17
        let d1_of_place_18 = S::int(2) * d1_of_place_11 - d1_of_place_17;
        // d1_of_place_19 = cos_q_ground1*d1_of_place_18
        let d1_of_place_19 = d1_of_place_18
            .mul_add(cos_q_ground1_0, cos_q_ground1.mul_add(d1_of_place_18_0, sums[28]));
        // d1_of_place_20 = d1_of_place_10 - 2*d1_of_place_11
        let d1_of_place_20 = d1_of_place_11.mul_add(-S::int(2), d1_of_place_10);
        // d1_of_place_21 = cos_q_ground1_plus_q_pin2*d1_of_place_20
        let d1_of_place_21 = d1_of_place_20
            .mul_add(
                cos_q_ground1_plus_q_pin2_0,
                cos_q_ground1_plus_q_pin2.mul_add(d1_of_place_20_0, sums[29]),
            );
        // d1_of_place_22 = d1_of_place_19 - d1_of_place_21
        let d1_of_place_22 = d1_of_place_19 - d1_of_place_21;
        // d1_of_place_23 = sin_q_ground1 + 2*sin_q_ground1_plus_q_pin2
        let d1_of_place_23 = sin_q_ground1_plus_q_pin2.mul_add(S::int(2), sin_q_ground1);
        // d1_of_place_24 = d1_of_place_22/sin_angle_2
        let d1_of_place_24 = d1_of_place_22
            .mul_add(
                over_sin_angle_2,
                -(sin_angle_2.mul_add(d1_of_place_24_0, sums[30]) * over_sin_angle_2),
            );
        // d1_of_place_25 = cos_q_pin2*d1_of_place_4
        let d1_of_place_25 = d1_of_place_4
            .mul_add(cos_q_pin2_0, cos_q_pin2.mul_add(d1_of_place_4_0, sums[31]));
        // d1_of_place_26 = 2*cos_q_ground1 + 2*cos_q_ground1_plus_q_pin2 - d1_of_place_24 +
        //   3*d1_of_place_25
        let d1_of_place_26 = d1_of_place_25
            .mul_add(
                S::int(3),
                cos_q_ground1_plus_q_pin2.mul_add(S::int(2), S::int(2) * cos_q_ground1),
            ) - d1_of_place_24;
        // d1_of_place_27 = sin_q_ground2*d1_of_place_26
        let d1_of_place_27 = d1_of_place_26
            .mul_add(sin_q_ground2_0, sin_q_ground2.mul_add(d1_of_place_26_0, sums[32]));
        // d1_of_place_28 = d1_of_place_23*d1_of_place_12
        let d1_of_place_28 = d1_of_place_12
            .mul_add(
                d1_of_place_23_0,
                d1_of_place_23.mul_add(d1_of_place_12_0, sums[33]),
            );
        // d1_of_place_29 = 2 + 3*cos_q_pin2 - d1_of_place_28
        let d1_of_place_29 = S::int(3) * cos_q_pin2 - d1_of_place_28;
        // d1_of_place_30 = sin_q_ground1*d1_of_place_29
        let d1_of_place_30 = d1_of_place_29
            .mul_add(sin_q_ground1_0, sin_q_ground1.mul_add(d1_of_place_29_0, sums[34]));
        // d1_of_place_31 = 2 + 3*cos_q_pin2 - d1_of_place_13
        let d1_of_place_31 = S::int(3) * cos_q_pin2 - d1_of_place_13;
        // d1_of_place_32 = sin_q_ground1_plus_q_pin2*d1_of_place_31
        let d1_of_place_32 = d1_of_place_31
            .mul_add(
                sin_q_ground1_plus_q_pin2_0,
                sin_q_ground1_plus_q_pin2.mul_add(d1_of_place_31_0, sums[35]),
            );
        // d1_of_place_33 = d1_of_place_30 + d1_of_place_32
        let d1_of_place_33 = d1_of_place_30 + d1_of_place_32;
        // d1_of_place_34 = cos_q_ground2*d1_of_place_33
        let d1_of_place_34 = d1_of_place_33
            .mul_add(cos_q_ground2_0, cos_q_ground2.mul_add(d1_of_place_33_0, sums[36]));
        // d1_of_place_35 = sin_q_pin2/sin_angle_2
        let d1_of_place_35 = sin_angle_2
            .mul_add(
                -(d1_of_place_35_0 * over_sin_angle_2),
                (sin_q_pin2 - sums[37]) * over_sin_angle_2,
            );
        // d1_of_place_36 = sin_q_pin2*d1_of_place_35
        let d1_of_place_36 = d1_of_place_35
            .mul_add(sin_q_pin2_0, sin_q_pin2.mul_add(d1_of_place_35_0, sums[38]));
        // d1_of_place_37 = d1_of_place_27 - d1_of_place_34 + d1_of_place_36
        let d1_of_place_37 = d1_of_place_36 - d1_of_place_34 + d1_of_place_27;
        // d1_of_place_38 = d1_of_place_37/sin_angle_2
        let d1_of_place_38 = d1_of_place_37
            .mul_add(
                over_sin_angle_2,
                -(sin_angle_2.mul_add(d1_of_place_38_0, sums[39]) * over_sin_angle_2),
            );
        // d1_of_place_39 = 5 + 3*cos_q_pin2 + d1_of_place_38
        let d1_of_place_39 = S::int(3) * cos_q_pin2 + d1_of_place_38;
        // sin_q_pin1_sin_angle_inv = sin_q_pin1/sin_angle
        let sin_q_pin1_sin_angle_inv = sin_angle
            .mul_add(
                -(sin_q_pin1_sin_angle_inv_0 * over_sin_angle),
                (sin_q_pin1 - sums[40]) * over_sin_angle,
            );
        // d1_of_place_40 = sin_q_pin1_sin_angle_inv*sin_q_pin1_sin_angle_inv
        let d1_of_place_40 = sin_q_pin1_sin_angle_inv
            .mul_add(sin_q_pin1_sin_angle_inv_0 + sin_q_pin1_sin_angle_inv_0, sums[41]);
        // d1_of_place_41 = d1_of_place_39*d1_of_place_40
        let d1_of_place_41 = d1_of_place_39
            .mul_add(
                d1_of_place_40_0,
                d1_of_place_40.mul_add(d1_of_place_39_0, sums[42]),
            );
        // d1_of_place_42 = d1_of_place_15/d1_of_place_9
        let d1_of_place_42 = d1_of_place_9
            .mul_add(
                -(d1_of_place_42_0 * over_d1_of_place_9),
                (d1_of_place_15 - sums[43]) * over_d1_of_place_9,
            );
        // d1_of_place_43 = 3*cos_q_pin1 - d1_of_place_42
        let d1_of_place_43 = S::int(3) * cos_q_pin1 - d1_of_place_42;
        // d1_of_place_44 = d1_of_place_43*sin_q_cos_q_ground1
        let d1_of_place_44 = d1_of_place_43
            .mul_add(
                sin_q_cos_q_ground1_0,
                sin_q_cos_q_ground1.mul_add(d1_of_place_43_0, sums[44]),
            );
        // d1_of_place_45 = 3*cos_q_pin1 + d1_of_place_14
        let d1_of_place_45 = S::int(3) * cos_q_pin1 + d1_of_place_14;
        // d1_of_place_46 = d1_of_place_45*cos_q_sin_q_ground1
        let d1_of_place_46 = d1_of_place_45
            .mul_add(
                cos_q_sin_q_ground1_0,
                cos_q_sin_q_ground1.mul_add(d1_of_place_45_0, sums[45]),
            );
        // d1_of_place_47 = d1_of_place_44 - d1_of_place_46
        let d1_of_place_47 = d1_of_place_44 - d1_of_place_46;
        // d1_of_place_48 = d1_of_place_47/d1_of_place_9
        let d1_of_place_48 = d1_of_place_47
            .mul_add(
                over_d1_of_place_9,
                -(d1_of_place_9.mul_add(d1_of_place_48_0, sums[46]) * over_d1_of_place_9),
            );
        // d1_of_place_49 = 4 + d1_of_place_41 - d1_of_place_48
        let d1_of_place_49 = -d1_of_place_48 + d1_of_place_41;
        // q_2_plus_q_pin1 = q_2 + q_pin1
        let q_2_plus_q_pin1 = q_2 + q_pin1;
        // sin_q_plus_q_pin1 = sin(q_2_plus_q_pin1)
        let sin_q_plus_q_pin1 = q_2_plus_q_pin1
            .mul_add(cos_q_plus_q_pin1_0, sums[47] * over_k);
        // cos_q_plus_q_pin1 = cos(q_2_plus_q_pin1)
        let cos_q_plus_q_pin1 = -q_2_plus_q_pin1
            .mul_add(sin_q_plus_q_pin1_0, sums[48] * over_k);
        // u_dot_of_q_pin1 = 1 + cos_q_pin1
        let u_dot_of_q_pin1 = cos_q_pin1;
        // u_dot_of_q_2_q_pin1 = cos_q*u_dot_of_q_pin1
        let u_dot_of_q_2_q_pin1 = u_dot_of_q_pin1
            .mul_add(cos_q_0, cos_q.mul_add(u_dot_of_q_pin1_0, sums[49]));
        // sin_q_pin1_sin_q = sin_q_pin1*sin_q
        let sin_q_pin1_sin_q = sin_q
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(sin_q_0, sums[50]));
        // u_dot_of_q_2_q_pin1_2 = sin_q*u_dot_of_q_pin1
        let u_dot_of_q_2_q_pin1_2 = u_dot_of_q_pin1
            .mul_add(sin_q_0, sin_q.mul_add(u_dot_of_q_pin1_0, sums[51]));
        // sin_q_pin1_cos_q = sin_q_pin1*cos_q
        let sin_q_pin1_cos_q = cos_q
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(cos_q_0, sums[52]));
        // u_dot_of_q_2_q_pin1_3 = sin_q + sin_q_plus_q_pin1
        let u_dot_of_q_2_q_pin1_3 = sin_q + sin_q_plus_q_pin1;
        // u_dot_of_q_2_q_pin1_4 = cos_q + cos_q_plus_q_pin1
        let u_dot_of_q_2_q_pin1_4 = cos_q + cos_q_plus_q_pin1;
        // u_dot_of_place = cos_q_ground1*u_dot_of_q_pin1
        let u_dot_of_place = u_dot_of_q_pin1
            .mul_add(
                cos_q_ground1_0,
                cos_q_ground1.mul_add(u_dot_of_q_pin1_0, sums[53]),
            );
        // sin_q_pin1_sin_q_ground1 = sin_q_pin1*sin_q_ground1
        let sin_q_pin1_sin_q_ground1 = sin_q_ground1
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(sin_q_ground1_0, sums[54]));
        // u_dot_of_place_2 = sin_q_ground1*u_dot_of_q_pin1
        let u_dot_of_place_2 = u_dot_of_q_pin1
            .mul_add(
                sin_q_ground1_0,
                sin_q_ground1.mul_add(u_dot_of_q_pin1_0, sums[55]),
            );
        // sin_q_pin1_cos_q_ground1 = sin_q_pin1*cos_q_ground1
        let sin_q_pin1_cos_q_ground1 = cos_q_ground1
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(cos_q_ground1_0, sums[56]));
        // u_dot_of_place_3 = sin_q_ground1*u_dot_of_q_2_q_pin1_4
        let u_dot_of_place_3 = u_dot_of_q_2_q_pin1_4
            .mul_add(
                sin_q_ground1_0,
                sin_q_ground1.mul_add(u_dot_of_q_2_q_pin1_4_0, sums[57]),
            );
        // u_dot_of_place_4 = cos_q_ground1*u_dot_of_q_2_q_pin1_3
        let u_dot_of_place_4 = u_dot_of_q_2_q_pin1_3
            .mul_add(
                cos_q_ground1_0,
                cos_q_ground1.mul_add(u_dot_of_q_2_q_pin1_3_0, sums[58]),
            );
        // u_dot_of_place_5 = u_dot_of_place_3 - u_dot_of_place_4
        let u_dot_of_place_5 = u_dot_of_place_3 - u_dot_of_place_4;
        // u_dot_of_place_6 = sin_q_ground2*d1_of_place_4
        let u_dot_of_place_6 = d1_of_place_4
            .mul_add(sin_q_ground2_0, sin_q_ground2.mul_add(d1_of_place_4_0, sums[59]));
        // u_dot_of_place_7 = u_dot_of_place_6 - d1_of_place_11
        let u_dot_of_place_7 = u_dot_of_place_6 - d1_of_place_11;
        // u_2_sin_angle_inv = u_2/sin_angle
        let u_2_sin_angle_inv = sin_angle
            .mul_add(
                -(u_2_sin_angle_inv_0 * over_sin_angle),
                (u_2 - sums[60]) * over_sin_angle,
            );
        // q_ground1_dot_2 = sin_q_pin1*u_2_sin_angle_inv
        let q_ground1_dot_2 = u_2_sin_angle_inv
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(u_2_sin_angle_inv_0, sums[61]));
        // q_ground2_dot_2 = q_ground1_dot_2*d1_of_place_35
        let q_ground2_dot_2 = q_ground1_dot_2
            .mul_add(
                d1_of_place_35_0,
                d1_of_place_35.mul_add(q_ground1_dot_2_0, sums[62]),
            );
        // u_dot_of_place_8 = u_dot_of_place_5/sin_angle
        let u_dot_of_place_8 = u_dot_of_place_5
            .mul_add(
                over_sin_angle,
                -(sin_angle.mul_add(u_dot_of_place_8_0, sums[63]) * over_sin_angle),
            );
        // q_pin1_dot_2 = u_dot_of_place_5*u_2_sin_angle_inv
        let q_pin1_dot_2 = u_dot_of_place_5
            .mul_add(
                u_2_sin_angle_inv_0,
                u_2_sin_angle_inv.mul_add(u_dot_of_place_5_0, sums[64]),
            );
        // u_dot_of_place_9 = u_dot_of_place_7/sin_angle_2
        let u_dot_of_place_9 = u_dot_of_place_7
            .mul_add(
                over_sin_angle_2,
                -(sin_angle_2.mul_add(u_dot_of_place_9_0, sums[65]) * over_sin_angle_2),
            );
        // q_pin2_dot_2 = q_ground1_dot_2*u_dot_of_place_9
        let q_pin2_dot_2 = u_dot_of_place_9
            .mul_add(
                q_ground1_dot_2_0,
                q_ground1_dot_2.mul_add(u_dot_of_place_9_0, sums[66]),
            );
        // u_dot_of_u_2 = u_2 + q_pin1_dot_2
        let u_dot_of_u_2 = u_2 + q_pin1_dot_2;
        // u_dot_of_place_10 = 1 + u_dot_of_place_8
        let u_dot_of_place_10 = u_dot_of_place_8;
        // u_dot_of_u_2_2 = q_ground1_dot_2 + q_pin2_dot_2
        let u_dot_of_u_2_2 = q_ground1_dot_2 + q_pin2_dot_2;
        // u_dot_of_place_11 = 1 + u_dot_of_place_9
        let u_dot_of_place_11 = u_dot_of_place_9;
        // u_dot_of_u_2_3 = u_2 - q_ground1_dot_2 + q_pin1_dot_2
        let u_dot_of_u_2_3 = u_2 - q_ground1_dot_2 + q_pin1_dot_2;
        // u_dot_of_place_12 = cos_q_pin1*u_dot_of_place_5
        let u_dot_of_place_12 = u_dot_of_place_5
            .mul_add(cos_q_pin1_0, cos_q_pin1.mul_add(u_dot_of_place_5_0, sums[67]));
        // u_2_sq_sin_angle_inv2 = u_2_sin_angle_inv*u_2_sin_angle_inv
        let u_2_sq_sin_angle_inv2 = u_2_sin_angle_inv
            .mul_add(u_2_sin_angle_inv_0 + u_2_sin_angle_inv_0, sums[68]);
        // u_dot_of_u_2_4 = u_dot_of_place_12*u_2_sq_sin_angle_inv2
        let u_dot_of_u_2_4 = u_dot_of_place_12
            .mul_add(
                u_2_sq_sin_angle_inv2_0,
                u_2_sq_sin_angle_inv2.mul_add(u_dot_of_place_12_0, sums[69]),
            );
        // u_dot_of_u_2_5 = q_ground1_dot_2/sin_angle
        let u_dot_of_u_2_5 = q_ground1_dot_2
            .mul_add(
                over_sin_angle,
                -(sin_angle.mul_add(u_dot_of_u_2_5_0, sums[70]) * over_sin_angle),
            );
        // u_dot_of_u_2_6 = cos_angle*u_dot_of_u_2_3
        let u_dot_of_u_2_6 = u_dot_of_u_2_3
            .mul_add(cos_angle_0, cos_angle.mul_add(u_dot_of_u_2_3_0, sums[71]));
        // u_dot_of_u_2_7 = u_dot_of_u_2_5*u_dot_of_u_2_6
        let u_dot_of_u_2_7 = u_dot_of_u_2_6
            .mul_add(
                u_dot_of_u_2_5_0,
                u_dot_of_u_2_5.mul_add(u_dot_of_u_2_6_0, sums[72]),
            );
        // u_dot_of_u_2_8 = q_ground1_dot_2 - q_ground2_dot_2 + q_pin2_dot_2
        let u_dot_of_u_2_8 = q_ground1_dot_2 - q_ground2_dot_2 + q_pin2_dot_2;
        // u_dot_of_u_2_9 = cos_q_ground1*q_ground1_dot_2
        let u_dot_of_u_2_9 = q_ground1_dot_2
            .mul_add(
                cos_q_ground1_0,
                cos_q_ground1.mul_add(q_ground1_dot_2_0, sums[73]),
            );
        // u_dot_of_u_2_10 = sin_q_ground1*q_ground1_dot_2
        let u_dot_of_u_2_10 = q_ground1_dot_2
            .mul_add(
                sin_q_ground1_0,
                sin_q_ground1.mul_add(q_ground1_dot_2_0, sums[74]),
            );
        // u_2_cos_q_sin_q_ground1 = u_2*cos_q_sin_q_ground1
        let u_2_cos_q_sin_q_ground1 = cos_q_sin_q_ground1
            .mul_add(u_2_0, u_2.mul_add(cos_q_sin_q_ground1_0, sums[75]));
        // u_dot_of_u_2_11 = q_ground1_dot_2*sin_q_cos_q_ground1
        let u_dot_of_u_2_11 = q_ground1_dot_2
            .mul_add(
                sin_q_cos_q_ground1_0,
                sin_q_cos_q_ground1.mul_add(q_ground1_dot_2_0, sums[76]),
            );
        // u_2_sin_q_cos_q_ground1 = u_2*sin_q_cos_q_ground1
        let u_2_sin_q_cos_q_ground1 = sin_q_cos_q_ground1
            .mul_add(u_2_0, u_2.mul_add(sin_q_cos_q_ground1_0, sums[77]));
        // u_dot_of_u_2_12 = q_ground1_dot_2*cos_q_sin_q_ground1
        let u_dot_of_u_2_12 = q_ground1_dot_2
            .mul_add(
                cos_q_sin_q_ground1_0,
                cos_q_sin_q_ground1.mul_add(q_ground1_dot_2_0, sums[78]),
            );
        // u_dot_of_u_2_13 = u_2_cos_q_sin_q_ground1 + u_dot_of_u_2_11 - u_2_sin_q_cos_q_ground1 -
        //   u_dot_of_u_2_12
        let u_dot_of_u_2_13 = u_2_cos_q_sin_q_ground1 - u_2_sin_q_cos_q_ground1
            + u_dot_of_u_2_11 - u_dot_of_u_2_12;
        // u_dot_of_u_2_14 = d1_of_place_5*u_2_sin_angle_inv
        let u_dot_of_u_2_14 = u_2_sin_angle_inv
            .mul_add(
                d1_of_place_5_0,
                d1_of_place_5.mul_add(u_2_sin_angle_inv_0, sums[79]),
            );
        // u_dot_of_u_2_15 = u_dot_of_place_12*u_dot_of_u_2_14
        let u_dot_of_u_2_15 = u_dot_of_place_12
            .mul_add(
                u_dot_of_u_2_14_0,
                u_dot_of_u_2_14.mul_add(u_dot_of_place_12_0, sums[80]),
            );
        // u_dot_of_u_2_16 = sin_q_pin1*u_dot_of_u_2_13
        let u_dot_of_u_2_16 = u_dot_of_u_2_13
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(u_dot_of_u_2_13_0, sums[81]));
        // u_2_cos_q_cos_q_ground1 = u_2*cos_q_cos_q_ground1
        let u_2_cos_q_cos_q_ground1 = cos_q_cos_q_ground1
            .mul_add(u_2_0, u_2.mul_add(cos_q_cos_q_ground1_0, sums[82]));
        // u_dot_of_u_2_17 = q_ground1_dot_2*sin_q_sin_q_ground1
        let u_dot_of_u_2_17 = q_ground1_dot_2
            .mul_add(
                sin_q_sin_q_ground1_0,
                sin_q_sin_q_ground1.mul_add(q_ground1_dot_2_0, sums[83]),
            );
        // u_2_sin_q_sin_q_ground1 = u_2*sin_q_sin_q_ground1
        let u_2_sin_q_sin_q_ground1 = sin_q_sin_q_ground1
            .mul_add(u_2_0, u_2.mul_add(sin_q_sin_q_ground1_0, sums[84]));
        // u_dot_of_u_2_18 = q_ground1_dot_2*cos_q_cos_q_ground1
        let u_dot_of_u_2_18 = q_ground1_dot_2
            .mul_add(
                cos_q_cos_q_ground1_0,
                cos_q_cos_q_ground1.mul_add(q_ground1_dot_2_0, sums[85]),
            );
        // u_dot_of_u_2_19 = u_2_cos_q_cos_q_ground1 - u_dot_of_u_2_17 + u_2_sin_q_sin_q_ground1 -
        //   u_dot_of_u_2_18
        let u_dot_of_u_2_19 = u_2_cos_q_cos_q_ground1 + u_2_sin_q_sin_q_ground1
            - u_dot_of_u_2_17 - u_dot_of_u_2_18;
        // u_dot_of_place_13 = d1_of_place_7*u_dot_of_place_5
        let u_dot_of_place_13 = u_dot_of_place_5
            .mul_add(
                d1_of_place_7_0,
                d1_of_place_7.mul_add(u_dot_of_place_5_0, sums[86]),
            );
        // u_dot_of_u_2_20 = q_ground1_dot_2*u_dot_of_place_13
        let u_dot_of_u_2_20 = u_dot_of_place_13
            .mul_add(
                q_ground1_dot_2_0,
                q_ground1_dot_2.mul_add(u_dot_of_place_13_0, sums[87]),
            );
        // u_dot_of_u_2_21 = cos_q_pin1*u_dot_of_u_2_19
        let u_dot_of_u_2_21 = u_dot_of_u_2_19
            .mul_add(cos_q_pin1_0, cos_q_pin1.mul_add(u_dot_of_u_2_19_0, sums[88]));
        // u_dot_of_u_2_22 = u_dot_of_u_2_15 + u_dot_of_u_2_16 - u_dot_of_u_2_20 + u_dot_of_u_2_21
        let u_dot_of_u_2_22 = u_dot_of_u_2_15 - u_dot_of_u_2_20 + u_dot_of_u_2_16 + u_dot_of_u_2_21;
        // u_dot_of_u_2_23 = u_2/d1_of_place_9
        let u_dot_of_u_2_23 = d1_of_place_9
            .mul_add(
                -(u_dot_of_u_2_23_0 * over_d1_of_place_9),
                (u_2 - sums[89]) * over_d1_of_place_9,
            );
        // u_dot_of_u_2_24 = u_dot_of_u_2_19*u_dot_of_u_2_23
        let u_dot_of_u_2_24 = u_dot_of_u_2_23
            .mul_add(
                u_dot_of_u_2_19_0,
                u_dot_of_u_2_19.mul_add(u_dot_of_u_2_23_0, sums[90]),
            );
        // u_dot_of_place_14 = d1_of_place_7/d1_of_place_9
        let u_dot_of_place_14 = d1_of_place_9
            .mul_add(
                -(u_dot_of_place_14_0 * over_d1_of_place_9),
                (d1_of_place_7 - sums[91]) * over_d1_of_place_9,
            );
        // u_dot_of_u_2_25 = u_dot_of_u_2_23*u_dot_of_place_14
        let u_dot_of_u_2_25 = u_dot_of_place_14
            .mul_add(
                u_dot_of_u_2_23_0,
                u_dot_of_u_2_23.mul_add(u_dot_of_place_14_0, sums[92]),
            );
        // u_dot_of_u_2_26 = u_dot_of_u_2_22*u_dot_of_u_2_25
        let u_dot_of_u_2_26 = u_dot_of_u_2_22
            .mul_add(
                u_dot_of_u_2_25_0,
                u_dot_of_u_2_25.mul_add(u_dot_of_u_2_22_0, sums[93]),
            );
        // u_dot_of_u_2_27 = d1_of_place_7*u_dot_of_u_2
        let u_dot_of_u_2_27 = u_dot_of_u_2
            .mul_add(d1_of_place_7_0, d1_of_place_7.mul_add(u_dot_of_u_2_0, sums[94]));
        // u_dot_of_u_2_28 = u_dot_of_u_2_23*u_dot_of_u_2_27
        let u_dot_of_u_2_28 = u_dot_of_u_2_27
            .mul_add(
                u_dot_of_u_2_23_0,
                u_dot_of_u_2_23.mul_add(u_dot_of_u_2_27_0, sums[95]),
            );
        // u_dot_of_u_2_29 = cos_q_ground1_plus_q_pin2*u_dot_of_u_2_2
        let u_dot_of_u_2_29 = u_dot_of_u_2_2
            .mul_add(
                cos_q_ground1_plus_q_pin2_0,
                cos_q_ground1_plus_q_pin2.mul_add(u_dot_of_u_2_2_0, sums[96]),
            );
        // u_dot_of_u_2_30 = sin_q_ground1_plus_q_pin2*u_dot_of_u_2_2
        let u_dot_of_u_2_30 = u_dot_of_u_2_2
            .mul_add(
                sin_q_ground1_plus_q_pin2_0,
                sin_q_ground1_plus_q_pin2.mul_add(u_dot_of_u_2_2_0, sums[97]),
            );
        // u_dot_of_u_2_31 = u_dot_of_u_2_9 + u_dot_of_u_2_29
        let u_dot_of_u_2_31 = u_dot_of_u_2_9 + u_dot_of_u_2_29;
        // u_dot_of_place_15 = cos_q_ground2*d1_of_place_4
        let u_dot_of_place_15 = d1_of_place_4
            .mul_add(cos_q_ground2_0, cos_q_ground2.mul_add(d1_of_place_4_0, sums[98]));
        // u_dot_of_u_2_32 = q_ground2_dot_2*u_dot_of_place_15
        let u_dot_of_u_2_32 = q_ground2_dot_2
            .mul_add(
                u_dot_of_place_15_0,
                u_dot_of_place_15.mul_add(q_ground2_dot_2_0, sums[99]),
            );
        // u_dot_of_u_2_33 = u_dot_of_u_2_10 + u_dot_of_u_2_30
        let u_dot_of_u_2_33 = u_dot_of_u_2_10 + u_dot_of_u_2_30;
        // u_dot_of_u_2_34 = sin_q_ground2*u_dot_of_u_2_33
        let u_dot_of_u_2_34 = u_dot_of_u_2_33
            .mul_add(
                sin_q_ground2_0,
                sin_q_ground2.mul_add(u_dot_of_u_2_33_0, sums[100]),
            );
        // u_dot_of_place_16 = sin_q_ground2*d1_of_place_3
        let u_dot_of_place_16 = d1_of_place_3
            .mul_add(sin_q_ground2_0, sin_q_ground2.mul_add(d1_of_place_3_0, sums[101]));
        // u_dot_of_u_2_35 = q_ground2_dot_2*u_dot_of_place_16
        let u_dot_of_u_2_35 = q_ground2_dot_2
            .mul_add(
                u_dot_of_place_16_0,
                u_dot_of_place_16.mul_add(q_ground2_dot_2_0, sums[102]),
            );
        // u_dot_of_u_2_36 = cos_q_ground2*u_dot_of_u_2_31
        let u_dot_of_u_2_36 = u_dot_of_u_2_31
            .mul_add(
                cos_q_ground2_0,
                cos_q_ground2.mul_add(u_dot_of_u_2_31_0, sums[103]),
            );
        // u_dot_of_u_2_37 = u_dot_of_u_2_32 - u_dot_of_u_2_34 + u_dot_of_u_2_35 - u_dot_of_u_2_36
        let u_dot_of_u_2_37 = u_dot_of_u_2_32 + u_dot_of_u_2_35 - u_dot_of_u_2_34 - u_dot_of_u_2_36;
        // u_dot_of_place_17 = cos_angle_2/sin_angle_2
        let u_dot_of_place_17 = sin_angle_2
            .mul_add(
                -(u_dot_of_place_17_0 * over_sin_angle_2),
                (cos_angle_2 - sums[104]) * over_sin_angle_2,
            );
        // u_dot_of_place_18 = u_dot_of_place_9*u_dot_of_place_17
        let u_dot_of_place_18 = u_dot_of_place_9
            .mul_add(
                u_dot_of_place_17_0,
                u_dot_of_place_17.mul_add(u_dot_of_place_9_0, sums[105]),
            );
        // u_dot_of_u_2_38 = u_dot_of_u_2_8*u_dot_of_place_18
        let u_dot_of_u_2_38 = u_dot_of_u_2_8
            .mul_add(
                u_dot_of_place_18_0,
                u_dot_of_place_18.mul_add(u_dot_of_u_2_8_0, sums[106]),
            );
        // u_dot_of_u_2_39 = u_dot_of_u_2_37/sin_angle_2
        let u_dot_of_u_2_39 = u_dot_of_u_2_37
            .mul_add(
                over_sin_angle_2,
                -(sin_angle_2.mul_add(u_dot_of_u_2_39_0, sums[107]) * over_sin_angle_2),
            );
        // u_dot_of_u_2_40 = u_dot_of_place_11*u_dot_of_u_2_4
        let u_dot_of_u_2_40 = u_dot_of_u_2_4
            .mul_add(
                u_dot_of_place_11_0,
                u_dot_of_place_11.mul_add(u_dot_of_u_2_4_0, sums[108]),
            );
        // u_dot_of_u_2_41 = u_dot_of_place_11*u_dot_of_u_2_7
        let u_dot_of_u_2_41 = u_dot_of_u_2_7
            .mul_add(
                u_dot_of_place_11_0,
                u_dot_of_place_11.mul_add(u_dot_of_u_2_7_0, sums[109]),
            );
        // u_dot_of_u_2_42 = u_dot_of_u_2_38 - u_dot_of_u_2_39
        let u_dot_of_u_2_42 = u_dot_of_u_2_38 - u_dot_of_u_2_39;
        // u_dot_of_u_2_43 = u_dot_of_u_2_42*q_ground1_dot_2
        let u_dot_of_u_2_43 = u_dot_of_u_2_42
            .mul_add(
                q_ground1_dot_2_0,
                q_ground1_dot_2.mul_add(u_dot_of_u_2_42_0, sums[110]),
            );
        // u_dot_of_u_2_44 = u_dot_of_place_11*q_ground1_dot_2
        let u_dot_of_u_2_44 = u_dot_of_place_11
            .mul_add(
                q_ground1_dot_2_0,
                q_ground1_dot_2.mul_add(u_dot_of_place_11_0, sums[111]),
            );
        // u_dot_of_u_2_45 = u_dot_of_u_2_2*u_dot_of_u_2_44
        let u_dot_of_u_2_45 = u_dot_of_u_2_44
            .mul_add(
                u_dot_of_u_2_2_0,
                u_dot_of_u_2_2.mul_add(u_dot_of_u_2_44_0, sums[112]),
            );
        // u_dot_of_u_2_46 = l*u_dot_of_u_2_4 + minus_l*u_dot_of_u_2_7
        let u_dot_of_u_2_46 = u_dot_of_u_2_7.mul_add(minus_l, l * u_dot_of_u_2_4);
        // u_dot_of_place_19 = sin_q_pin1 - u_dot_of_place_3 + u_dot_of_place_4
        let u_dot_of_place_19 = sin_q_pin1 + u_dot_of_place_4 - u_dot_of_place_3;
        // u_dot_of_place_20 = u_dot_of_place_19/sin_angle
        let u_dot_of_place_20 = u_dot_of_place_19
            .mul_add(
                over_sin_angle,
                -(sin_angle.mul_add(u_dot_of_place_20_0, sums[113]) * over_sin_angle),
            );
        // u_dot_of_place_21 = -1 + u_dot_of_place_20
        let u_dot_of_place_21 = u_dot_of_place_20;
        // sin_q_pin1_cos_angle = sin_q_pin1*cos_angle
        let sin_q_pin1_cos_angle = cos_angle
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(cos_angle_0, sums[114]));
        // u_dot_of_place_22 = u_dot_of_place_21*sin_q_pin1_cos_angle
        let u_dot_of_place_22 = u_dot_of_place_21
            .mul_add(
                sin_q_pin1_cos_angle_0,
                sin_q_pin1_cos_angle.mul_add(u_dot_of_place_21_0, sums[115]),
            );
        // u_dot_of_place_23 = u_dot_of_place_22 + u_dot_of_place_12
        let u_dot_of_place_23 = u_dot_of_place_12 + u_dot_of_place_22;
        // u_dot_of_u_2_47 = u_dot_of_place_23*u_2_sq_sin_angle_inv2
        let u_dot_of_u_2_47 = u_dot_of_place_23
            .mul_add(
                u_2_sq_sin_angle_inv2_0,
                u_2_sq_sin_angle_inv2.mul_add(u_dot_of_place_23_0, sums[116]),
            );
        // u_dot_of_u_2_48 = l*u_dot_of_u_2_47 + weight*cos_q_ground1
        let u_dot_of_u_2_48 = u_dot_of_u_2_47.mul_add(l, weight * cos_q_ground1);
        // u_dot_of_place_24 = sin_q_pin2 - u_dot_of_place_6 + d1_of_place_11
        let u_dot_of_place_24 = sin_q_pin2 + d1_of_place_11 - u_dot_of_place_6;
        // u_dot_of_place_25 = u_dot_of_place_24/sin_angle_2
        let u_dot_of_place_25 = u_dot_of_place_24
            .mul_add(
                over_sin_angle_2,
                -(sin_angle_2.mul_add(u_dot_of_place_25_0, sums[117]) * over_sin_angle_2),
            );
        // u_dot_of_place_26 = -1 + u_dot_of_place_25
        let u_dot_of_place_26 = u_dot_of_place_25;
        // u_dot_of_place_27 = u_dot_of_place_26*u_dot_of_place_17
        let u_dot_of_place_27 = u_dot_of_place_26
            .mul_add(
                u_dot_of_place_17_0,
                u_dot_of_place_17.mul_add(u_dot_of_place_26_0, sums[118]),
            );
        // sin_angle_inv_cos_angle = cos_angle/sin_angle
        let sin_angle_inv_cos_angle = sin_angle
            .mul_add(
                -(sin_angle_inv_cos_angle_0 * over_sin_angle),
                (cos_angle - sums[119]) * over_sin_angle,
            );
        // u_dot_of_place_28 = u_dot_of_place_27 + sin_angle_inv_cos_angle
        let u_dot_of_place_28 = sin_angle_inv_cos_angle + u_dot_of_place_27;
        // u_dot_of_place_29 = sin_q_pin1*u_dot_of_place_28
        let u_dot_of_place_29 = u_dot_of_place_28
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(u_dot_of_place_28_0, sums[120]));
        // u_dot_of_place_30 = cos_angle*u_dot_of_place_10
        let u_dot_of_place_30 = u_dot_of_place_10
            .mul_add(cos_angle_0, cos_angle.mul_add(u_dot_of_place_10_0, sums[121]));
        // u_dot_of_place_31 = u_dot_of_place_29 - u_dot_of_place_30
        let u_dot_of_place_31 = -u_dot_of_place_30 + u_dot_of_place_29;
        // u_dot_of_place_32 = sin_q_pin2*u_dot_of_place_31
        let u_dot_of_place_32 = u_dot_of_place_31
            .mul_add(sin_q_pin2_0, sin_q_pin2.mul_add(u_dot_of_place_31_0, sums[122]));
        // sin_q_pin1_cos_q_pin2 = sin_q_pin1*cos_q_pin2
        let sin_q_pin1_cos_q_pin2 = cos_q_pin2
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(cos_q_pin2_0, sums[123]));
        // u_dot_of_place_33 = u_dot_of_place_9*sin_q_pin1_cos_q_pin2
        let u_dot_of_place_33 = u_dot_of_place_9
            .mul_add(
                sin_q_pin1_cos_q_pin2_0,
                sin_q_pin1_cos_q_pin2.mul_add(u_dot_of_place_9_0, sums[124]),
            );
        // u_dot_of_place_34 = u_dot_of_place_32 + u_dot_of_place_33
        let u_dot_of_place_34 = u_dot_of_place_33 + u_dot_of_place_32;
        // u_dot_of_place_35 = sin_q_pin1*u_dot_of_place_34
        let u_dot_of_place_35 = u_dot_of_place_34
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(u_dot_of_place_34_0, sums[125]));
        // u_dot_of_place_36 = sin_q_pin2*u_dot_of_place_12
        let u_dot_of_place_36 = u_dot_of_place_12
            .mul_add(sin_q_pin2_0, sin_q_pin2.mul_add(u_dot_of_place_12_0, sums[126]));
        // u_dot_of_place_37 = u_dot_of_place_35 + u_dot_of_place_36
        let u_dot_of_place_37 = u_dot_of_place_36 + u_dot_of_place_35;
        // u_dot_of_place_38 = u_dot_of_place_37/sin_angle_2
        let u_dot_of_place_38 = u_dot_of_place_37
            .mul_add(
                over_sin_angle_2,
                -(sin_angle_2.mul_add(u_dot_of_place_38_0, sums[127]) * over_sin_angle_2),
            );
        // u_dot_of_u_2_49 = u_2_sq_sin_angle_inv2*u_dot_of_place_38
        let u_dot_of_u_2_49 = u_dot_of_place_38
            .mul_add(
                u_2_sq_sin_angle_inv2_0,
                u_2_sq_sin_angle_inv2.mul_add(u_dot_of_place_38_0, sums[128]),
            );
        // u_dot_of_u_2_50 = l*u_dot_of_u_2_49 + weight*cos_q_ground2
        let u_dot_of_u_2_50 = u_dot_of_u_2_49.mul_add(l, weight * cos_q_ground2);
        // u_2_sq = u_2*u_2
        let u_2_sq = u_2.mul_add(u_2_0 + u_2_0, sums[129]);
        // u_2_sq_cos_q_pin1 = cos_q_pin1*u_2_sq
        let u_2_sq_cos_q_pin1 = u_2_sq
            .mul_add(cos_q_pin1_0, cos_q_pin1.mul_add(u_2_sq_0, sums[130]));
        // u_dot_of_place_39 = cos_q_pin1*d1_of_place_5
        let u_dot_of_place_39 = d1_of_place_5
            .mul_add(cos_q_pin1_0, cos_q_pin1.mul_add(d1_of_place_5_0, sums[131]));
        // u_2_sq_sin_q_pin1 = sin_q_pin1*u_2_sq
        let u_2_sq_sin_q_pin1 = u_2_sq
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(u_2_sq_0, sums[132]));
        // u_dot_of_q_pin1_2 = 1 + 2*cos_q_pin1
        let u_dot_of_q_pin1_2 = S::int(2) * cos_q_pin1;
        // u_dot_of_place_40 = cos_q_ground1*u_dot_of_q_pin1_2
        let u_dot_of_place_40 = u_dot_of_q_pin1_2
            .mul_add(
                cos_q_ground1_0,
                cos_q_ground1.mul_add(u_dot_of_q_pin1_2_0, sums[133]),
            );
        // u_dot_of_place_41 = 2*sin_q_pin1_sin_q_ground1 + u_dot_of_place_40
        let u_dot_of_place_41 = S::int(2) * sin_q_pin1_sin_q_ground1 + u_dot_of_place_40;
        // u_dot_of_place_42 = sin_q*u_dot_of_place_41
        let u_dot_of_place_42 = u_dot_of_place_41
            .mul_add(sin_q_0, sin_q.mul_add(u_dot_of_place_41_0, sums[134]));
        // u_dot_of_place_43 = sin_q_ground1*u_dot_of_q_pin1_2
        let u_dot_of_place_43 = u_dot_of_q_pin1_2
            .mul_add(
                sin_q_ground1_0,
                sin_q_ground1.mul_add(u_dot_of_q_pin1_2_0, sums[135]),
            );
        // u_dot_of_place_44 = 2*sin_q_pin1_cos_q_ground1 - u_dot_of_place_43
        let u_dot_of_place_44 = S::int(2) * sin_q_pin1_cos_q_ground1 - u_dot_of_place_43;
        // u_dot_of_place_45 = cos_q*u_dot_of_place_44
        let u_dot_of_place_45 = u_dot_of_place_44
            .mul_add(cos_q_0, cos_q.mul_add(u_dot_of_place_44_0, sums[136]));
        // u_dot_of_place_46 = u_dot_of_place_42 + u_dot_of_place_45
        let u_dot_of_place_46 = u_dot_of_place_42 + u_dot_of_place_45;
        // u_dot_of_place_47 = sin_q_pin1*u_dot_of_place_46
        let u_dot_of_place_47 = u_dot_of_place_46
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(u_dot_of_place_46_0, sums[137]));
        // u_dot_of_place_48 = sin_q_sin_q_ground1 + cos_q_cos_q_ground1 + u_dot_of_place_39 -
        //   u_dot_of_place_47
        let u_dot_of_place_48 = sin_q_sin_q_ground1 + cos_q_cos_q_ground1
            + u_dot_of_place_39 - u_dot_of_place_47;
        // u_dot_of_place_49 = cos_q_ground1*u_dot_of_place_48
        let u_dot_of_place_49 = u_dot_of_place_48
            .mul_add(
                cos_q_ground1_0,
                cos_q_ground1.mul_add(u_dot_of_place_48_0, sums[138]),
            );
        // u_dot_of_q_2_q_pin1_5 = sin_q*u_dot_of_q_pin1_2
        let u_dot_of_q_2_q_pin1_5 = u_dot_of_q_pin1_2
            .mul_add(sin_q_0, sin_q.mul_add(u_dot_of_q_pin1_2_0, sums[139]));
        // u_dot_of_q_2_q_pin1_6 = 2*sin_q_pin1_cos_q + u_dot_of_q_2_q_pin1_5
        let u_dot_of_q_2_q_pin1_6 = S::int(2) * sin_q_pin1_cos_q + u_dot_of_q_2_q_pin1_5;
        // u_dot_of_q_2_q_pin1_7 = sin_q_pin1*u_dot_of_q_2_q_pin1_6
        let u_dot_of_q_2_q_pin1_7 = u_dot_of_q_2_q_pin1_6
            .mul_add(
                sin_q_pin1_0,
                sin_q_pin1.mul_add(u_dot_of_q_2_q_pin1_6_0, sums[140]),
            );
        // u_dot_of_place_50 = 3*u_dot_of_q_2_q_pin1 - 4*u_dot_of_place_49 - 3*u_dot_of_q_2_q_pin1_7
        let u_dot_of_place_50 = u_dot_of_place_49
            .mul_add(
                -S::int(4),
                u_dot_of_q_2_q_pin1_7
                    .mul_add(-S::int(3), S::int(3) * u_dot_of_q_2_q_pin1),
            );
        // u_dot_of_place_51 = cos_q*u_dot_of_place_50
        let u_dot_of_place_51 = u_dot_of_place_50
            .mul_add(cos_q_0, cos_q.mul_add(u_dot_of_place_50_0, sums[141]));
        // u_dot_of_place_52 = sin_q_pin1*u_dot_of_place_44
        let u_dot_of_place_52 = u_dot_of_place_44
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(u_dot_of_place_44_0, sums[142]));
        // u_dot_of_place_53 = u_dot_of_place - u_dot_of_place_52
        let u_dot_of_place_53 = u_dot_of_place - u_dot_of_place_52;
        // u_dot_of_place_54 = cos_q_ground1*u_dot_of_place_53
        let u_dot_of_place_54 = u_dot_of_place_53
            .mul_add(
                cos_q_ground1_0,
                cos_q_ground1.mul_add(u_dot_of_place_53_0, sums[143]),
            );
        // sin_q_pin1_sq = sin_q_pin1*sin_q_pin1
        let sin_q_pin1_sq = sin_q_pin1.mul_add(sin_q_pin1_0 + sin_q_pin1_0, sums[144]);
        // u_dot_of_place_55 = 2 + 2*cos_q_pin1 - u_dot_of_place_51 - 3*u_dot_of_place_54 - 5*sin_q_pin1_sq
        let u_dot_of_place_55 = u_dot_of_place_54
            .mul_add(
                -S::int(3),
                sin_q_pin1_sq.mul_add(-S::int(5), S::int(2) * cos_q_pin1),
            ) - u_dot_of_place_51;
        // u_dot_of_place_56 = cos_q_ground1*u_dot_of_place_55
        let u_dot_of_place_56 = u_dot_of_place_55
            .mul_add(
                cos_q_ground1_0,
                cos_q_ground1.mul_add(u_dot_of_place_55_0, sums[145]),
            );
        // u_dot_of_q_2_q_pin1_8 = cos_q*u_dot_of_q_pin1_2
        let u_dot_of_q_2_q_pin1_8 = u_dot_of_q_pin1_2
            .mul_add(cos_q_0, cos_q.mul_add(u_dot_of_q_pin1_2_0, sums[146]));
        // u_dot_of_q_2_q_pin1_9 = 2*sin_q_pin1_sin_q - u_dot_of_q_2_q_pin1_8
        let u_dot_of_q_2_q_pin1_9 = S::int(2) * sin_q_pin1_sin_q - u_dot_of_q_2_q_pin1_8;
        // u_dot_of_q_2_q_pin1_10 = sin_q_pin1*u_dot_of_q_2_q_pin1_9
        let u_dot_of_q_2_q_pin1_10 = u_dot_of_q_2_q_pin1_9
            .mul_add(
                sin_q_pin1_0,
                sin_q_pin1.mul_add(u_dot_of_q_2_q_pin1_9_0, sums[147]),
            );
        // u_dot_of_q_2_q_pin1_11 = u_dot_of_q_2_q_pin1_2 - u_dot_of_q_2_q_pin1_10
        let u_dot_of_q_2_q_pin1_11 = u_dot_of_q_2_q_pin1_2 - u_dot_of_q_2_q_pin1_10;
        // u_dot_of_q_2_q_pin1_12 = cos_q*u_dot_of_q_2_q_pin1_11
        let u_dot_of_q_2_q_pin1_12 = u_dot_of_q_2_q_pin1_11
            .mul_add(cos_q_0, cos_q.mul_add(u_dot_of_q_2_q_pin1_11_0, sums[148]));
        // sin_q_pin1_cos_q_pin1 = sin_q_pin1*cos_q_pin1
        let sin_q_pin1_cos_q_pin1 = cos_q_pin1
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(cos_q_pin1_0, sums[149]));
        // u_dot_of_q_2_q_pin1_13 = u_dot_of_q_2_q_pin1_12 - 2*sin_q_pin1_cos_q_pin1
        let u_dot_of_q_2_q_pin1_13 = -S::int(2) * sin_q_pin1_cos_q_pin1 + u_dot_of_q_2_q_pin1_12;
        // u_dot_of_place_57 = sin_q_ground1*u_dot_of_q_2_q_pin1_13
        let u_dot_of_place_57 = u_dot_of_q_2_q_pin1_13
            .mul_add(
                sin_q_ground1_0,
                sin_q_ground1.mul_add(u_dot_of_q_2_q_pin1_13_0, sums[150]),
            );
        // u_dot_of_place_58 = u_dot_of_place_56 - u_dot_of_place_57
        let u_dot_of_place_58 = -u_dot_of_place_57 + u_dot_of_place_56;
        // u_dot_of_place_59 = cos_q*u_dot_of_place_58
        let u_dot_of_place_59 = u_dot_of_place_58
            .mul_add(cos_q_0, cos_q.mul_add(u_dot_of_place_58_0, sums[151]));
        // u_dot_of_place_60 = sin_q_pin1*u_dot_of_place_41
        let u_dot_of_place_60 = u_dot_of_place_41
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(u_dot_of_place_41_0, sums[152]));
        // u_dot_of_place_61 = u_dot_of_place_2 - u_dot_of_place_60
        let u_dot_of_place_61 = u_dot_of_place_2 - u_dot_of_place_60;
        // u_dot_of_place_62 = cos_q_ground1*u_dot_of_place_61
        let u_dot_of_place_62 = u_dot_of_place_61
            .mul_add(
                cos_q_ground1_0,
                cos_q_ground1.mul_add(u_dot_of_place_61_0, sums[153]),
            );
        // u_dot_of_place_63 = 2*sin_q_pin1_cos_q_pin1 + u_dot_of_place_62
        let u_dot_of_place_63 = S::int(2) * sin_q_pin1_cos_q_pin1 + u_dot_of_place_62;
        // u_dot_of_place_64 = cos_q_ground1*u_dot_of_place_63
        let u_dot_of_place_64 = u_dot_of_place_63
            .mul_add(
                cos_q_ground1_0,
                cos_q_ground1.mul_add(u_dot_of_place_63_0, sums[154]),
            );
        // u_dot_of_place_65 = sin_q_pin1*sin_q_pin1_sin_q_ground1
        let u_dot_of_place_65 = sin_q_pin1_sin_q_ground1
            .mul_add(
                sin_q_pin1_0,
                sin_q_pin1.mul_add(sin_q_pin1_sin_q_ground1_0, sums[155]),
            );
        // u_dot_of_place_66 = u_dot_of_place_64 + u_dot_of_place_65
        let u_dot_of_place_66 = u_dot_of_place_65 + u_dot_of_place_64;
        // u_dot_of_place_67 = sin_q*u_dot_of_place_66
        let u_dot_of_place_67 = u_dot_of_place_66
            .mul_add(sin_q_0, sin_q.mul_add(u_dot_of_place_66_0, sums[156]));
        // u_dot_of_place_68 = sin_q_pin1_sq + u_dot_of_place_59 - u_dot_of_place_67
        let u_dot_of_place_68 = sin_q_pin1_sq - u_dot_of_place_67 + u_dot_of_place_59;
        // u_dot_of_u_2_51 = q_ground1_dot_2*q_ground1_dot_2
        let u_dot_of_u_2_51 = q_ground1_dot_2
            .mul_add(q_ground1_dot_2_0 + q_ground1_dot_2_0, sums[157]);
        // u_dot_of_u_2_52 = cos_q_pin2*u_dot_of_u_2_51
        let u_dot_of_u_2_52 = u_dot_of_u_2_51
            .mul_add(cos_q_pin2_0, cos_q_pin2.mul_add(u_dot_of_u_2_51_0, sums[158]));
        // u_dot_of_u_2_53 = sin_q_pin2*u_dot_of_u_2_46
        let u_dot_of_u_2_53 = u_dot_of_u_2_46
            .mul_add(sin_q_pin2_0, sin_q_pin2.mul_add(u_dot_of_u_2_46_0, sums[159]));
        // u_dot_of_u_2_54 = sin_q_pin2*u_dot_of_u_2_51
        let u_dot_of_u_2_54 = u_dot_of_u_2_51
            .mul_add(sin_q_pin2_0, sin_q_pin2.mul_add(u_dot_of_u_2_51_0, sums[160]));
        // u_dot_of_u_2_55 = cos_q_pin2*u_dot_of_u_2_46
        let u_dot_of_u_2_55 = u_dot_of_u_2_46
            .mul_add(cos_q_pin2_0, cos_q_pin2.mul_add(u_dot_of_u_2_46_0, sums[161]));
        // u_dot_of_place_69 = 1 + 2*cos_q_pin2 + u_dot_of_place_9
        let u_dot_of_place_69 = S::int(2) * cos_q_pin2 + u_dot_of_place_9;
        // u_dot_of_place_70 = weight_2*cos_q_pin1 + minus_l*u_dot_of_place_14
        let u_dot_of_place_70 = u_dot_of_place_14
            .mul_add(minus_l, weight_2 * cos_q_pin1);
        // u_dot_of_u_2_56 = u_dot_of_u_2_48*sin_q_pin1_sin_angle_inv
        let u_dot_of_u_2_56 = u_dot_of_u_2_48
            .mul_add(
                sin_q_pin1_sin_angle_inv_0,
                sin_q_pin1_sin_angle_inv.mul_add(u_dot_of_u_2_48_0, sums[162]),
            );
        // u_dot_of_u_2_57 = u_2_sin_angle_inv*u_dot_of_u_2_5
        let u_dot_of_u_2_57 = u_dot_of_u_2_5
            .mul_add(
                u_2_sin_angle_inv_0,
                u_2_sin_angle_inv.mul_add(u_dot_of_u_2_5_0, sums[163]),
            );
        // u_dot_of_u_2_58 = u_dot_of_place_23*u_dot_of_u_2_57
        let u_dot_of_u_2_58 = u_dot_of_place_23
            .mul_add(
                u_dot_of_u_2_57_0,
                u_dot_of_u_2_57.mul_add(u_dot_of_place_23_0, sums[164]),
            );
        // u_dot_of_place_71 = d1_of_place_35*sin_q_pin1_sin_angle_inv
        let u_dot_of_place_71 = sin_q_pin1_sin_angle_inv
            .mul_add(
                d1_of_place_35_0,
                d1_of_place_35.mul_add(sin_q_pin1_sin_angle_inv_0, sums[165]),
            );
        // u_dot_of_u_2_59 = u_dot_of_u_2_50*u_dot_of_place_71
        let u_dot_of_u_2_59 = u_dot_of_u_2_50
            .mul_add(
                u_dot_of_place_71_0,
                u_dot_of_place_71.mul_add(u_dot_of_u_2_50_0, sums[166]),
            );
        // u_dot_of_u_2_60 = d1_of_place_35*u_dot_of_u_2_57
        let u_dot_of_u_2_60 = u_dot_of_u_2_57
            .mul_add(
                d1_of_place_35_0,
                d1_of_place_35.mul_add(u_dot_of_u_2_57_0, sums[167]),
            );
        // u_dot_of_u_2_61 = u_dot_of_place_38*u_dot_of_u_2_60
        let u_dot_of_u_2_61 = u_dot_of_place_38
            .mul_add(
                u_dot_of_u_2_60_0,
                u_dot_of_u_2_60.mul_add(u_dot_of_place_38_0, sums[168]),
            );
        // u_dot_of_u_2_62 = m_l*u_dot_of_u_2_28 + weight_3*sin_q_plus_q_pin1 +
        //   minus_2_m_l*u_2_sq_cos_q_pin1
        let u_dot_of_u_2_62 = u_dot_of_u_2_28
            .mul_add(
                m_l,
                u_2_sq_cos_q_pin1.mul_add(minus_2_m_l, weight_3 * sin_q_plus_q_pin1),
            );
        // u_dot_of_u_2_63 = sin_q_pin1*u_dot_of_u_2_62
        let u_dot_of_u_2_63 = u_dot_of_u_2_62
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(u_dot_of_u_2_62_0, sums[169]));
        // u_dot_of_u_2_64 = m_l*u_dot_of_u_2_24 + minus_m_l*u_dot_of_u_2_26 +
        //   minus_2_m_g*cos_q_plus_q_pin1 + minus_2_m_l*u_2_sq_sin_q_pin1
        let u_dot_of_u_2_64 = u_dot_of_u_2_26
            .mul_add(
                minus_m_l,
                u_dot_of_u_2_24
                    .mul_add(
                        m_l,
                        u_2_sq_sin_q_pin1
                            .mul_add(minus_2_m_l, minus_2_m_g * cos_q_plus_q_pin1),
                    ),
            );
        // u_dot_of_u_2_65 = u_dot_of_place_70*u_dot_of_u_2_64
        let u_dot_of_u_2_65 = u_dot_of_u_2_64
            .mul_add(
                u_dot_of_place_70_0,
                u_dot_of_place_70.mul_add(u_dot_of_u_2_64_0, sums[170]),
            );
        // u_dot_of_place_72 = d1_of_place_9*d1_of_place_9
        let u_dot_of_place_72 = d1_of_place_9
            .mul_add(d1_of_place_9_0 + d1_of_place_9_0, sums[171]);
        // u_dot_of_place_73 = u_dot_of_place_72*u_dot_of_place_72
        let u_dot_of_place_73 = u_dot_of_place_72
            .mul_add(u_dot_of_place_72_0 + u_dot_of_place_72_0, sums[172]);
        // u_dot_of_u_2_66 = d1_of_place_7*u_2_sq
        let u_dot_of_u_2_66 = d1_of_place_7
            .mul_add(u_2_sq_0, u_2_sq.mul_add(d1_of_place_7_0, sums[173]));
        // u_dot_of_u_2_67 = u_dot_of_u_2_66/u_dot_of_place_73
        let u_dot_of_u_2_67 = u_dot_of_place_73
            .mul_add(
                -(u_dot_of_u_2_67_0 * over_u_dot_of_place_73),
                (u_dot_of_u_2_66 - sums[174]) * over_u_dot_of_place_73,
            );
        // u_dot_of_u_2_68 = u_dot_of_place_68*u_dot_of_u_2_67
        let u_dot_of_u_2_68 = u_dot_of_place_68
            .mul_add(
                u_dot_of_u_2_67_0,
                u_dot_of_u_2_67.mul_add(u_dot_of_place_68_0, sums[175]),
            );
        // u_dot_of_u_2_69 = m_l*u_dot_of_u_2_45 + minus_2_m_g*sin_q_ground1_plus_q_pin2 +
        //   weight_4*u_dot_of_u_2_52 + minus_2_m*u_dot_of_u_2_53
        let u_dot_of_u_2_69 = u_dot_of_u_2_53
            .mul_add(
                minus_2_m,
                u_dot_of_u_2_45
                    .mul_add(
                        m_l,
                        u_dot_of_u_2_52
                            .mul_add(weight_4, minus_2_m_g * sin_q_ground1_plus_q_pin2),
                    ),
            );
        // u_dot_of_place_74 = sin_q_pin2*sin_q_pin1_sin_angle_inv
        let u_dot_of_place_74 = sin_q_pin1_sin_angle_inv
            .mul_add(
                sin_q_pin2_0,
                sin_q_pin2.mul_add(sin_q_pin1_sin_angle_inv_0, sums[176]),
            );
        // u_dot_of_u_2_70 = u_dot_of_u_2_69*u_dot_of_place_74
        let u_dot_of_u_2_70 = u_dot_of_u_2_69
            .mul_add(
                u_dot_of_place_74_0,
                u_dot_of_place_74.mul_add(u_dot_of_u_2_69_0, sums[177]),
            );
        // u_dot_of_u_2_71 = m_l*u_dot_of_u_2_40 + minus_m_l*u_dot_of_u_2_41 + minus_m_l*u_dot_of_u_2_43 +
        //   weight_3*cos_q_ground1_plus_q_pin2 + weight_4*u_dot_of_u_2_54 + weight_5*u_dot_of_u_2_55
        let u_dot_of_u_2_71 = u_dot_of_u_2_43
            .mul_add(
                minus_m_l,
                u_dot_of_u_2_55
                    .mul_add(
                        weight_5,
                        u_dot_of_u_2_41
                            .mul_add(
                                minus_m_l,
                                u_dot_of_u_2_40
                                    .mul_add(
                                        m_l,
                                        u_dot_of_u_2_54
                                            .mul_add(weight_4, weight_3 * cos_q_ground1_plus_q_pin2),
                                    ),
                            ),
                    ),
            );
        // u_dot_of_place_75 = u_dot_of_place_69*sin_q_pin1_sin_angle_inv
        let u_dot_of_place_75 = u_dot_of_place_69
            .mul_add(
                sin_q_pin1_sin_angle_inv_0,
                sin_q_pin1_sin_angle_inv.mul_add(u_dot_of_place_69_0, sums[178]),
            );
        // u_dot_of_u_2_72 = u_dot_of_u_2_71*u_dot_of_place_75
        let u_dot_of_u_2_72 = u_dot_of_u_2_71
            .mul_add(
                u_dot_of_place_75_0,
                u_dot_of_place_75.mul_add(u_dot_of_u_2_71_0, sums[179]),
            );
        // u_dot_of_u_2_73 = m_l_2*u_dot_of_u_2_40 + minus_m_l_2*u_dot_of_u_2_41 +
        //   minus_m_l_2*u_dot_of_u_2_43
        let u_dot_of_u_2_73 = u_dot_of_u_2_43
            .mul_add(
                minus_m_l_2,
                u_dot_of_u_2_41.mul_add(minus_m_l_2, m_l_2 * u_dot_of_u_2_40),
            );
        // u_dot_of_place_76 = u_dot_of_place_11*sin_q_pin1_sin_angle_inv
        let u_dot_of_place_76 = u_dot_of_place_11
            .mul_add(
                sin_q_pin1_sin_angle_inv_0,
                sin_q_pin1_sin_angle_inv.mul_add(u_dot_of_place_11_0, sums[180]),
            );
        // u_dot_of_u_2_74 = u_dot_of_u_2_73*u_dot_of_place_76
        let u_dot_of_u_2_74 = u_dot_of_u_2_73
            .mul_add(
                u_dot_of_place_76_0,
                u_dot_of_place_76.mul_add(u_dot_of_u_2_73_0, sums[181]),
            );
        // u_dot_of_u_2_75 = weight_6*cos_q + weight_7*u_dot_of_u_2_56 + m_l_2*u_dot_of_u_2_58 +
        //   weight_7*u_dot_of_u_2_59 + m_l_2*u_dot_of_u_2_61 + weight_8*u_dot_of_u_2_63 - 3*u_dot_of_u_2_65
        //   + minus_m_l_2*u_dot_of_u_2_68 + minus_6_l*u_dot_of_u_2_70 + weight_9*u_dot_of_u_2_72 +
        //   u_dot_of_u_2_74
        let u_dot_of_u_2_75 = u_dot_of_u_2_59
            .mul_add(
                weight_7,
                u_dot_of_u_2_72
                    .mul_add(
                        weight_9,
                        u_dot_of_u_2_68
                            .mul_add(
                                minus_m_l_2,
                                u_dot_of_u_2_61
                                    .mul_add(
                                        m_l_2,
                                        u_dot_of_u_2_70
                                            .mul_add(
                                                minus_6_l,
                                                u_dot_of_u_2_65
                                                    .mul_add(
                                                        -S::int(3),
                                                        u_dot_of_u_2_56
                                                            .mul_add(
                                                                weight_7,
                                                                u_dot_of_u_2_63
                                                                    .mul_add(
                                                                        weight_8,
                                                                        u_dot_of_u_2_58.mul_add(m_l_2, weight_6 * cos_q),
                                                                    ),
                                                            ),
                                                    ),
                                            ),
                                    ),
                            ),
                    ) + u_dot_of_u_2_74,
            );
        // u_dot_of_u_2_76 = u_dot_of_u_2_75/d1_of_place_49
        let u_dot_of_u_2_76 = u_dot_of_u_2_75
            .mul_add(
                over_d1_of_place_49,
                -(d1_of_place_49.mul_add(u_dot_of_u_2_76_0, sums[182]) * over_d1_of_place_49),
            );
        q_2_rate = u_2;
        q_ground1_rate = q_ground1_dot_2;
        q_ground2_rate = q_ground2_dot_2;
        q_pin1_rate = q_pin1_dot_2;
        q_pin2_rate = q_pin2_dot_2;
        u_2_rate = minus_1_by_4_m_l_2 * u_dot_of_u_2_76;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * q_pin1,
                count * q_pin1,
                count * q_pin2,
                count * q_pin2,
                count * q_2,
                count * q_2,
                count * q_ground1,
                count * q_ground1,
                count * d1_of_place,
                count * d1_of_place,
                count * q_ground2,
                count * q_ground2,
                count * q_ground1_plus_q_pin2,
                count * q_ground1_plus_q_pin2,
                count * d1_of_place_2,
                count * d1_of_place_2,
                sin_q, cos_q, sin_q_pin1, sin_q, cos_q, cos_q_pin1, sin_q_ground2, cos_q_ground2,
                sin_angle_2, sin_q_ground1_plus_q_pin2, d1_of_place_9, sin_q_ground2, cos_q_ground1,
                cos_q_ground1_plus_q_pin2, sin_angle_2, cos_q_pin2, sin_q_ground2, d1_of_place_23,
                sin_q_ground1, sin_q_ground1_plus_q_pin2, cos_q_ground2, sin_angle_2, sin_q_pin2,
                sin_angle_2, sin_angle, sin_q_pin1_sin_angle_inv, d1_of_place_39, d1_of_place_9,
                d1_of_place_43, d1_of_place_45, d1_of_place_9,
                count * q_2_plus_q_pin1,
                count * q_2_plus_q_pin1,
                cos_q, sin_q_pin1, sin_q, sin_q_pin1, cos_q_ground1, sin_q_pin1, sin_q_ground1,
                sin_q_pin1, sin_q_ground1, cos_q_ground1, sin_q_ground2, sin_angle, sin_q_pin1,
                q_ground1_dot_2, sin_angle, u_dot_of_place_5, sin_angle_2, q_ground1_dot_2,
                cos_q_pin1, u_2_sin_angle_inv, u_dot_of_place_12, sin_angle, cos_angle,
                u_dot_of_u_2_5, cos_q_ground1, sin_q_ground1, u_2, q_ground1_dot_2, u_2,
                q_ground1_dot_2, d1_of_place_5, u_dot_of_place_12, sin_q_pin1, u_2, q_ground1_dot_2,
                u_2, q_ground1_dot_2, d1_of_place_7, q_ground1_dot_2, cos_q_pin1, d1_of_place_9,
                u_dot_of_u_2_19, d1_of_place_9, u_dot_of_u_2_23, u_dot_of_u_2_22, d1_of_place_7,
                u_dot_of_u_2_23, cos_q_ground1_plus_q_pin2, sin_q_ground1_plus_q_pin2,
                cos_q_ground2, q_ground2_dot_2, sin_q_ground2, sin_q_ground2, q_ground2_dot_2,
                cos_q_ground2, sin_angle_2, u_dot_of_place_9, u_dot_of_u_2_8, sin_angle_2,
                u_dot_of_place_11, u_dot_of_place_11, u_dot_of_u_2_42, u_dot_of_place_11,
                u_dot_of_u_2_2, sin_angle, sin_q_pin1, u_dot_of_place_21, u_dot_of_place_23,
                sin_angle_2, u_dot_of_place_26, sin_angle, sin_q_pin1, cos_angle, sin_q_pin2,
                sin_q_pin1, u_dot_of_place_9, sin_q_pin1, sin_q_pin2, sin_angle_2,
                u_2_sq_sin_angle_inv2, u_2, cos_q_pin1, cos_q_pin1, sin_q_pin1, cos_q_ground1,
                sin_q, sin_q_ground1, cos_q, sin_q_pin1, cos_q_ground1, sin_q, sin_q_pin1, cos_q,
                sin_q_pin1, cos_q_ground1, sin_q_pin1, cos_q_ground1, cos_q, sin_q_pin1, cos_q,
                sin_q_pin1, sin_q_ground1, cos_q, sin_q_pin1, cos_q_ground1, cos_q_ground1,
                sin_q_pin1, sin_q, q_ground1_dot_2, cos_q_pin2, sin_q_pin2, sin_q_pin2, cos_q_pin2,
                u_dot_of_u_2_48, u_2_sin_angle_inv, u_dot_of_place_23, d1_of_place_35,
                u_dot_of_u_2_50, d1_of_place_35, u_dot_of_place_38, sin_q_pin1, u_dot_of_place_70,
                d1_of_place_9, u_dot_of_place_72, d1_of_place_7, u_dot_of_place_73,
                u_dot_of_place_68, sin_q_pin2, u_dot_of_u_2_69, u_dot_of_place_69, u_dot_of_u_2_71,
                u_dot_of_place_11, u_dot_of_u_2_73, d1_of_place_49,
            ]),
            padded([
                cos_q_pin1, sin_q_pin1, cos_q_pin2, sin_q_pin2, cos_q, sin_q, cos_q_ground1,
                sin_q_ground1, cos_angle, sin_angle, cos_q_ground2, sin_q_ground2,
                cos_q_ground1_plus_q_pin2, sin_q_ground1_plus_q_pin2, cos_angle_2, sin_angle_2,
                sin_q_ground1, cos_q_ground1, d1_of_place_5, cos_q_ground1, sin_q_ground1,
                d1_of_place_7, cos_q_ground1_plus_q_pin2, d1_of_place_3, d1_of_place_12,
                d1_of_place_12, d1_of_place_14, d1_of_place_16, d1_of_place_18, d1_of_place_20,
                d1_of_place_24, d1_of_place_4, d1_of_place_26, d1_of_place_12, d1_of_place_29,
                d1_of_place_31, d1_of_place_33, d1_of_place_35, d1_of_place_35, d1_of_place_38,
                sin_q_pin1_sin_angle_inv, sin_q_pin1_sin_angle_inv, d1_of_place_40, d1_of_place_42,
                sin_q_cos_q_ground1, cos_q_sin_q_ground1, d1_of_place_48, cos_q_plus_q_pin1,
                sin_q_plus_q_pin1, u_dot_of_q_pin1, sin_q, u_dot_of_q_pin1, cos_q, u_dot_of_q_pin1,
                sin_q_ground1, u_dot_of_q_pin1, cos_q_ground1, u_dot_of_q_2_q_pin1_4,
                u_dot_of_q_2_q_pin1_3, d1_of_place_4, u_2_sin_angle_inv, u_2_sin_angle_inv,
                d1_of_place_35, u_dot_of_place_8, u_2_sin_angle_inv, u_dot_of_place_9,
                u_dot_of_place_9, u_dot_of_place_5, u_2_sin_angle_inv, u_2_sq_sin_angle_inv2,
                u_dot_of_u_2_5, u_dot_of_u_2_3, u_dot_of_u_2_6, q_ground1_dot_2, q_ground1_dot_2,
                cos_q_sin_q_ground1, sin_q_cos_q_ground1, sin_q_cos_q_ground1, cos_q_sin_q_ground1,
                u_2_sin_angle_inv, u_dot_of_u_2_14, u_dot_of_u_2_13, cos_q_cos_q_ground1,
                sin_q_sin_q_ground1, sin_q_sin_q_ground1, cos_q_cos_q_ground1, u_dot_of_place_5,
                u_dot_of_place_13, u_dot_of_u_2_19, u_dot_of_u_2_23, u_dot_of_u_2_23,
                u_dot_of_place_14, u_dot_of_place_14, u_dot_of_u_2_25, u_dot_of_u_2,
                u_dot_of_u_2_27, u_dot_of_u_2_2, u_dot_of_u_2_2, d1_of_place_4, u_dot_of_place_15,
                u_dot_of_u_2_33, d1_of_place_3, u_dot_of_place_16, u_dot_of_u_2_31,
                u_dot_of_place_17, u_dot_of_place_17, u_dot_of_place_18, u_dot_of_u_2_39,
                u_dot_of_u_2_4, u_dot_of_u_2_7, q_ground1_dot_2, q_ground1_dot_2, u_dot_of_u_2_44,
                u_dot_of_place_20, cos_angle, sin_q_pin1_cos_angle, u_2_sq_sin_angle_inv2,
                u_dot_of_place_25, u_dot_of_place_17, sin_angle_inv_cos_angle, u_dot_of_place_28,
                u_dot_of_place_10, u_dot_of_place_31, cos_q_pin2, sin_q_pin1_cos_q_pin2,
                u_dot_of_place_34, u_dot_of_place_12, u_dot_of_place_38, u_dot_of_place_38, u_2,
                u_2_sq, d1_of_place_5, u_2_sq, u_dot_of_q_pin1_2, u_dot_of_place_41,
                u_dot_of_q_pin1_2, u_dot_of_place_44, u_dot_of_place_46, u_dot_of_place_48,
                u_dot_of_q_pin1_2, u_dot_of_q_2_q_pin1_6, u_dot_of_place_50, u_dot_of_place_44,
                u_dot_of_place_53, sin_q_pin1, u_dot_of_place_55, u_dot_of_q_pin1_2,
                u_dot_of_q_2_q_pin1_9, u_dot_of_q_2_q_pin1_11, cos_q_pin1, u_dot_of_q_2_q_pin1_13,
                u_dot_of_place_58, u_dot_of_place_41, u_dot_of_place_61, u_dot_of_place_63,
                sin_q_pin1_sin_q_ground1, u_dot_of_place_66, q_ground1_dot_2, u_dot_of_u_2_51,
                u_dot_of_u_2_46, u_dot_of_u_2_51, u_dot_of_u_2_46, sin_q_pin1_sin_angle_inv,
                u_dot_of_u_2_5, u_dot_of_u_2_57, sin_q_pin1_sin_angle_inv, u_dot_of_place_71,
                u_dot_of_u_2_57, u_dot_of_u_2_60, u_dot_of_u_2_62, u_dot_of_u_2_64, d1_of_place_9,
                u_dot_of_place_72, u_2_sq, u_dot_of_u_2_67, u_dot_of_u_2_67,
                sin_q_pin1_sin_angle_inv, u_dot_of_place_74, sin_q_pin1_sin_angle_inv,
                u_dot_of_place_75, sin_q_pin1_sin_angle_inv, u_dot_of_place_76, u_dot_of_u_2_76,
            ]),
        ];
        count_last = count;
        q_2_last = q_2;
        q_ground1_last = q_ground1;
        q_ground2_last = q_ground2;
        q_pin1_last = q_pin1;
        q_pin2_last = q_pin2;
        u_2_last = u_2;
        sin_q_pin1_last = sin_q_pin1;
        cos_q_pin1_last = cos_q_pin1;
        sin_q_pin2_last = sin_q_pin2;
        cos_q_pin2_last = cos_q_pin2;
        sin_q_last = sin_q;
        cos_q_last = cos_q;
        sin_q_ground1_last = sin_q_ground1;
        cos_q_ground1_last = cos_q_ground1;
        d1_of_place_last = d1_of_place;
        sin_angle_last = sin_angle;
        cos_angle_last = cos_angle;
        sin_q_ground2_last = sin_q_ground2;
        cos_q_ground2_last = cos_q_ground2;
        q_ground1_plus_q_pin2_last = q_ground1_plus_q_pin2;
        sin_q_ground1_plus_q_pin2_last = sin_q_ground1_plus_q_pin2;
        cos_q_ground1_plus_q_pin2_last = cos_q_ground1_plus_q_pin2;
        d1_of_place_2_last = d1_of_place_2;
        sin_angle_2_last = sin_angle_2;
        cos_angle_2_last = cos_angle_2;
        d1_of_place_3_last = d1_of_place_3;
        d1_of_place_4_last = d1_of_place_4;
        sin_q_sin_q_ground1_last = sin_q_sin_q_ground1;
        cos_q_cos_q_ground1_last = cos_q_cos_q_ground1;
        d1_of_place_5_last = d1_of_place_5;
        sin_q_cos_q_ground1_last = sin_q_cos_q_ground1;
        cos_q_sin_q_ground1_last = cos_q_sin_q_ground1;
        d1_of_place_7_last = d1_of_place_7;
        d1_of_place_9_last = d1_of_place_9;
        d1_of_place_12_last = d1_of_place_12;
        d1_of_place_14_last = d1_of_place_14;
        d1_of_place_16_last = d1_of_place_16;
        d1_of_place_18_last = d1_of_place_18;
        d1_of_place_20_last = d1_of_place_20;
        d1_of_place_23_last = d1_of_place_23;
        d1_of_place_24_last = d1_of_place_24;
        d1_of_place_26_last = d1_of_place_26;
        d1_of_place_29_last = d1_of_place_29;
        d1_of_place_31_last = d1_of_place_31;
        d1_of_place_33_last = d1_of_place_33;
        d1_of_place_35_last = d1_of_place_35;
        d1_of_place_38_last = d1_of_place_38;
        d1_of_place_39_last = d1_of_place_39;
        sin_q_pin1_sin_angle_inv_last = sin_q_pin1_sin_angle_inv;
        d1_of_place_40_last = d1_of_place_40;
        d1_of_place_42_last = d1_of_place_42;
        d1_of_place_43_last = d1_of_place_43;
        d1_of_place_45_last = d1_of_place_45;
        d1_of_place_48_last = d1_of_place_48;
        d1_of_place_49_last = d1_of_place_49;
        q_2_plus_q_pin1_last = q_2_plus_q_pin1;
        sin_q_plus_q_pin1_last = sin_q_plus_q_pin1;
        cos_q_plus_q_pin1_last = cos_q_plus_q_pin1;
        u_dot_of_q_pin1_last = u_dot_of_q_pin1;
        u_dot_of_q_2_q_pin1_3_last = u_dot_of_q_2_q_pin1_3;
        u_dot_of_q_2_q_pin1_4_last = u_dot_of_q_2_q_pin1_4;
        sin_q_pin1_sin_q_ground1_last = sin_q_pin1_sin_q_ground1;
        u_dot_of_place_5_last = u_dot_of_place_5;
        u_2_sin_angle_inv_last = u_2_sin_angle_inv;
        q_ground1_dot_2_last = q_ground1_dot_2;
        q_ground2_dot_2_last = q_ground2_dot_2;
        u_dot_of_place_8_last = u_dot_of_place_8;
        u_dot_of_place_9_last = u_dot_of_place_9;
        u_dot_of_u_2_last = u_dot_of_u_2;
        u_dot_of_place_10_last = u_dot_of_place_10;
        u_dot_of_u_2_2_last = u_dot_of_u_2_2;
        u_dot_of_place_11_last = u_dot_of_place_11;
        u_dot_of_u_2_3_last = u_dot_of_u_2_3;
        u_dot_of_place_12_last = u_dot_of_place_12;
        u_2_sq_sin_angle_inv2_last = u_2_sq_sin_angle_inv2;
        u_dot_of_u_2_4_last = u_dot_of_u_2_4;
        u_dot_of_u_2_5_last = u_dot_of_u_2_5;
        u_dot_of_u_2_6_last = u_dot_of_u_2_6;
        u_dot_of_u_2_7_last = u_dot_of_u_2_7;
        u_dot_of_u_2_8_last = u_dot_of_u_2_8;
        u_dot_of_u_2_13_last = u_dot_of_u_2_13;
        u_dot_of_u_2_14_last = u_dot_of_u_2_14;
        u_dot_of_u_2_19_last = u_dot_of_u_2_19;
        u_dot_of_place_13_last = u_dot_of_place_13;
        u_dot_of_u_2_22_last = u_dot_of_u_2_22;
        u_dot_of_u_2_23_last = u_dot_of_u_2_23;
        u_dot_of_place_14_last = u_dot_of_place_14;
        u_dot_of_u_2_25_last = u_dot_of_u_2_25;
        u_dot_of_u_2_27_last = u_dot_of_u_2_27;
        u_dot_of_u_2_31_last = u_dot_of_u_2_31;
        u_dot_of_place_15_last = u_dot_of_place_15;
        u_dot_of_u_2_33_last = u_dot_of_u_2_33;
        u_dot_of_place_16_last = u_dot_of_place_16;
        u_dot_of_place_17_last = u_dot_of_place_17;
        u_dot_of_place_18_last = u_dot_of_place_18;
        u_dot_of_u_2_39_last = u_dot_of_u_2_39;
        u_dot_of_u_2_42_last = u_dot_of_u_2_42;
        u_dot_of_u_2_44_last = u_dot_of_u_2_44;
        u_dot_of_u_2_46_last = u_dot_of_u_2_46;
        u_dot_of_place_20_last = u_dot_of_place_20;
        u_dot_of_place_21_last = u_dot_of_place_21;
        sin_q_pin1_cos_angle_last = sin_q_pin1_cos_angle;
        u_dot_of_place_23_last = u_dot_of_place_23;
        u_dot_of_u_2_48_last = u_dot_of_u_2_48;
        u_dot_of_place_25_last = u_dot_of_place_25;
        u_dot_of_place_26_last = u_dot_of_place_26;
        sin_angle_inv_cos_angle_last = sin_angle_inv_cos_angle;
        u_dot_of_place_28_last = u_dot_of_place_28;
        u_dot_of_place_31_last = u_dot_of_place_31;
        sin_q_pin1_cos_q_pin2_last = sin_q_pin1_cos_q_pin2;
        u_dot_of_place_34_last = u_dot_of_place_34;
        u_dot_of_place_38_last = u_dot_of_place_38;
        u_dot_of_u_2_50_last = u_dot_of_u_2_50;
        u_2_sq_last = u_2_sq;
        u_dot_of_q_pin1_2_last = u_dot_of_q_pin1_2;
        u_dot_of_place_41_last = u_dot_of_place_41;
        u_dot_of_place_44_last = u_dot_of_place_44;
        u_dot_of_place_46_last = u_dot_of_place_46;
        u_dot_of_place_48_last = u_dot_of_place_48;
        u_dot_of_q_2_q_pin1_6_last = u_dot_of_q_2_q_pin1_6;
        u_dot_of_place_50_last = u_dot_of_place_50;
        u_dot_of_place_53_last = u_dot_of_place_53;
        u_dot_of_place_55_last = u_dot_of_place_55;
        u_dot_of_q_2_q_pin1_9_last = u_dot_of_q_2_q_pin1_9;
        u_dot_of_q_2_q_pin1_11_last = u_dot_of_q_2_q_pin1_11;
        u_dot_of_q_2_q_pin1_13_last = u_dot_of_q_2_q_pin1_13;
        u_dot_of_place_58_last = u_dot_of_place_58;
        u_dot_of_place_61_last = u_dot_of_place_61;
        u_dot_of_place_63_last = u_dot_of_place_63;
        u_dot_of_place_66_last = u_dot_of_place_66;
        u_dot_of_place_68_last = u_dot_of_place_68;
        u_dot_of_u_2_51_last = u_dot_of_u_2_51;
        u_dot_of_place_69_last = u_dot_of_place_69;
        u_dot_of_place_70_last = u_dot_of_place_70;
        u_dot_of_u_2_57_last = u_dot_of_u_2_57;
        u_dot_of_place_71_last = u_dot_of_place_71;
        u_dot_of_u_2_60_last = u_dot_of_u_2_60;
        u_dot_of_u_2_62_last = u_dot_of_u_2_62;
        u_dot_of_u_2_64_last = u_dot_of_u_2_64;
        u_dot_of_place_72_last = u_dot_of_place_72;
        u_dot_of_place_73_last = u_dot_of_place_73;
        u_dot_of_u_2_67_last = u_dot_of_u_2_67;
        u_dot_of_u_2_69_last = u_dot_of_u_2_69;
        u_dot_of_place_74_last = u_dot_of_place_74;
        u_dot_of_u_2_71_last = u_dot_of_u_2_71;
        u_dot_of_place_75_last = u_dot_of_place_75;
        u_dot_of_u_2_73_last = u_dot_of_u_2_73;
        u_dot_of_place_76_last = u_dot_of_place_76;
        u_dot_of_u_2_76_last = u_dot_of_u_2_76;
    }
}

/// Newton–Euler equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEuler;

impl<S: Scalar> System<S> for NewtonEuler {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 3,
            coordinates: 5,
            variables: 1,
            speeds: 1,
            reactions: 14,
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
    fn linear_system(
        &self,
        p: &[S],
        q: &[S],
        v: &[S],
        matrix: &mut [S],
        forcing: &mut [S],
    ) {
        let (of_matrix, of_forcing) = linear_system(
            &Parameters::from_slice(p),
            array(q),
            array(v),
        );
        matrix.copy_from_slice(&of_matrix);
        forcing.copy_from_slice(&of_forcing);
    }
    fn output_count(&self) -> usize {
        6
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
        368 * order + SLACK
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
    fn divisor_count(&self) -> usize {
        3
    }
    fn divisor_name(&self, at: usize) -> &str {
        [
            "sin(q - q_ground1 + q_pin1)",
            "sin(q_ground1 - q_ground2 + q_pin2)",
            "divisor 3 of the accelerations",
        ][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn constraint_count(&self) -> usize {
        4
    }
    fn constraint_name(&self, at: usize) -> &str {
        ["close1_1", "close1_2", "close2_1", "close2_2"][at]
    }
    fn constraints(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &constraints(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn constraint_slopes(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &constraint_slopes(&Parameters::from_slice(p), array(q), array(v)),
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
