//! N-window four-bar: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/window_linkage/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{
    constraint_slopes, constraints, coordinate_rates, divisors, kinetic_energy,
    potential_energy,
};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

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

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 1],
    direction: &[S; 6],
) -> [S; 6] {
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
    slice.try_into().expect("a slice of the length that `System` requires")
}
