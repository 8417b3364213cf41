//! N-window four-bar: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/window_linkage/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u.
///
/// 47 operations, 7 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 1],
) -> [[S; 1]; 1] {
    let Parameters { m, l, .. } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    // Sines and cosines.
    let (sin_q_pin2, cos_q_pin2) = q_pin2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    // Shared terms.
    // 1 + cos(q_pin2)
    let m11_of_q_pin2 = S::int(1) + cos_q_pin2;
    let (sin_angle, _) = (q_ground1 - q_ground2 + q_pin2).sin_cos();
    let sin_angle_inv = S::int(1) / sin_angle;
    // 1 - sin_angle_inv*(cos(q_ground2)*(cos(q_ground1)*sin(q_pin2) + m11_of_q_pin2*sin(q_ground1)) +
    //   sin(q_ground2)*(sin(q_ground1)*sin(q_pin2) - m11_of_q_pin2*cos(q_ground1)))
    let m11_of_place = S::int(1)
        - sin_angle_inv
            * (cos_q_ground2 * m11_of_q_pin2.mul_add(sin_q_ground1, cos_q_ground1 * sin_q_pin2)
                + sin_q_ground2
                    * (-m11_of_q_pin2)
                        .mul_add(cos_q_ground1, sin_q_ground1 * sin_q_pin2));
    let sin_q_pin2_sin_angle_inv = sin_angle_inv * sin_q_pin2;
    // m11_of_place^2 + sin_q_pin2_sin_angle_inv^2
    let m11_of_place_2 = sin_q_pin2_sin_angle_inv
        .mul_add(sin_q_pin2_sin_angle_inv, m11_of_place * m11_of_place);
    // 4 + m11_of_place_2
    let m11_of_place_3 = S::int(4) + m11_of_place_2;
    let (sin_angle_2, _) = (q_2 - q_ground1 + q_pin1).sin_cos();
    let m11_of_place_4 = sin_q_pin1 / sin_angle_2;
    // sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)
    let m11_of_place_5 = (-cos_q).mul_add(sin_q_ground1, sin_q * cos_q_ground1);
    // m11_of_place_5/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   m11_of_place_5*cos(q_pin1))
    let m11_of_place_6 = m11_of_place_5
        / (sin_q_pin1 * cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1)
            + m11_of_place_5 * cos_q_pin1);
    // m11_of_place_4^2*(3*m11_of_place*cos(q_pin2) + m11_of_place_3) + m11_of_place_6*(m11_of_place_6 -
    //   3*cos(q_pin1))
    let m11_of_place_7 = m11_of_place_4 * m11_of_place_4
        * (m11_of_place * cos_q_pin2).mul_add(S::int(3), m11_of_place_3)
        + m11_of_place_6 * (-cos_q_pin1).mul_add(S::int(3), m11_of_place_6);
    // Entries that are not zero; upper triangle.
    // M11 = 4*m*l^2/3 + 4*m*l^2*sin(q_pin1)^2/(3*sin(q - q_ground1 + q_pin1)^2) +
    //   m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))^2/(3*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(3*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/(3*sin(q - q_ground1 + q_pin1)^2) + m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2
    let m11 = S::ratio(1, 3) * m * l * l * (S::int(4) + m11_of_place_7);
    [[m11]]
}

/// Right-hand side of the linear system; unknowns (u').
///
/// 176 operations, 7 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 1]) -> [S; 1] {
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
    let m_l = m * l;
    // q - q_ground1 + q_pin1
    let f1_of_place = q_2 - q_ground1 + q_pin1;
    let (sin_angle, cos_angle) = f1_of_place.sin_cos();
    let sin_angle_inv = S::int(1) / sin_angle;
    let sin_q_pin1_sin_angle_inv = sin_angle_inv * sin_q_pin1;
    let f1_of_place_2 = m_l * sin_q_pin1_sin_angle_inv;
    let u_2_sin_angle_inv = u_2 * sin_angle_inv;
    // sin(q)*sin(q_pin1) - cos(q)*cos(q_pin1)
    let f1_of_q_2_q_pin1 = (-cos_q).mul_add(cos_q_pin1, sin_q * sin_q_pin1);
    // sin(q_ground1)*(cos(q) - f1_of_q_2_q_pin1) - cos(q_ground1)*(sin(q) + cos(q)*sin(q_pin1) +
    //   sin(q)*cos(q_pin1))
    let f1_of_place_3 = sin_q_ground1 * (cos_q - f1_of_q_2_q_pin1)
        - cos_q_ground1 * (cos_q.mul_add(sin_q_pin1, sin_q) + sin_q * cos_q_pin1);
    let f1_of_u_2 = u_2 * sin_q_pin1_sin_angle_inv;
    // u - f1_of_u_2
    let u_2_minus_f1_of_u_2 = u_2 - f1_of_u_2;
    let f1_of_u_2_2 = u_2_sin_angle_inv * f1_of_place_3;
    // sin_angle_inv*u_2_sin_angle_inv*(u*f1_of_place_3*cos(q_pin1) - sin(q_pin1)*cos(q - q_ground1 +
    //   q_pin1)*(u_2_minus_f1_of_u_2 + f1_of_u_2_2))
    let f1_of_u_2_3 = sin_angle_inv * u_2_sin_angle_inv
        * (-sin_q_pin1 * cos_angle * (u_2_minus_f1_of_u_2 + f1_of_u_2_2)
            + u_2 * f1_of_place_3 * cos_q_pin1);
    let l_f1_of_u_2_3 = l * f1_of_u_2_3;
    // sin(q_ground1)*sin(q_pin2) - cos(q_ground1)*cos(q_pin2)
    let f1_of_place_4 = (-cos_q_ground1).mul_add(cos_q_pin2, sin_q_ground1 * sin_q_pin2);
    // cos(q_ground1) - f1_of_place_4
    let f1_of_place_5 = cos_q_ground1 - f1_of_place_4;
    // cos(q_ground1)*sin(q_pin2) + sin(q_ground1)*cos(q_pin2)
    let f1_of_place_6 = sin_q_ground1.mul_add(cos_q_pin2, cos_q_ground1 * sin_q_pin2);
    // sin(q_ground1) + f1_of_place_6
    let f1_of_place_7 = sin_q_ground1 + f1_of_place_6;
    // q_ground1 - q_ground2 + q_pin2
    let f1_of_place_8 = q_ground1 - q_ground2 + q_pin2;
    let (sin_angle_2, cos_angle_2) = f1_of_place_8.sin_cos();
    let sin_angle_2_inv = S::int(1) / sin_angle_2;
    // sin_angle_2_inv*(f1_of_place_5*sin(q_ground2) - f1_of_place_7*cos(q_ground2))
    let f1_of_place_9 = sin_angle_2_inv
        * (-f1_of_place_7).mul_add(cos_q_ground2, f1_of_place_5 * sin_q_ground2);
    // 1 + f1_of_place_9
    let f1_of_place_10 = S::int(1) + f1_of_place_9;
    let f1_of_u_2_f1_of_place_10 = f1_of_u_2 * f1_of_place_10;
    let f1_of_place_11 = sin_angle_2_inv * sin_q_pin2;
    let f1_of_u_2_f1_of_place_11 = f1_of_u_2 * f1_of_place_11;
    // cos(q_ground1 - q_ground2 + q_pin2)*(f1_of_u_2_f1_of_place_10 - f1_of_u_2_f1_of_place_11)
    let f1_of_u_2_4 = cos_angle_2 * (f1_of_u_2_f1_of_place_10 - f1_of_u_2_f1_of_place_11);
    // cos(q_ground2)*(f1_of_place_4*f1_of_u_2_f1_of_place_10 - f1_of_u_2*cos(q_ground1)) -
    //   sin(q_ground2)*(f1_of_u_2*sin(q_ground1) + f1_of_place_6*f1_of_u_2_f1_of_place_10) +
    //   f1_of_u_2_f1_of_place_11*(f1_of_place_5*cos(q_ground2) + f1_of_place_7*sin(q_ground2))
    let f1_of_u_2_5 = cos_q_ground2
        * (-f1_of_u_2).mul_add(cos_q_ground1, f1_of_place_4 * f1_of_u_2_f1_of_place_10)
        - sin_q_ground2 * f1_of_place_6.mul_add(f1_of_u_2_f1_of_place_10, f1_of_u_2 * sin_q_ground1)
        + f1_of_u_2_f1_of_place_11
            * f1_of_place_7.mul_add(sin_q_ground2, f1_of_place_5 * cos_q_ground2);
    // f1_of_u_2_3*f1_of_place_10 + f1_of_u_2*sin_angle_2_inv*(f1_of_u_2_5 - f1_of_place_9*f1_of_u_2_4)
    let f1_of_u_2_6 = f1_of_u_2 * sin_angle_2_inv
        * (-f1_of_place_9).mul_add(f1_of_u_2_4, f1_of_u_2_5) + f1_of_u_2_3 * f1_of_place_10;
    let l_f1_of_u_2_6 = l * f1_of_u_2_6;
    let f1_of_u_2_sq = f1_of_u_2 * f1_of_u_2;
    // f1_of_u_2_3*sin(q_pin2) + f1_of_place_9*f1_of_u_2_sq*cos(q_pin2)
    let f1_of_u_2_7 = (f1_of_place_9 * f1_of_u_2_sq)
        .mul_add(cos_q_pin2, f1_of_u_2_3 * sin_q_pin2);
    // sin_angle_2_inv*(f1_of_u_2_f1_of_place_11*f1_of_u_2_4 - f1_of_u_2_7)
    let f1_of_u_2_8 = sin_angle_2_inv * f1_of_u_2_f1_of_place_11.mul_add(f1_of_u_2_4, -f1_of_u_2_7);
    // f1_of_place_10*l_f1_of_u_2_6 - l*f1_of_place_11*f1_of_u_2_8
    let f1_of_u_2_9 = (-(l * f1_of_place_11))
        .mul_add(f1_of_u_2_8, f1_of_place_10 * l_f1_of_u_2_6);
    let l_m_l = l * m_l;
    // f1_of_u_2_3*l_m_l + f1_of_place_10*f1_of_u_2_6*l_m_l
    let f1_of_u_2_10 = (f1_of_place_10 * f1_of_u_2_6)
        .mul_add(l_m_l, f1_of_u_2_3 * l_m_l);
    // sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)
    let f1_of_place_12 = (-cos_q).mul_add(sin_q_ground1, sin_q * cos_q_ground1);
    // sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)
    let f1_of_place_13 = cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1);
    // 1/(f1_of_place_12*cos(q_pin1) + f1_of_place_13*sin(q_pin1))
    let f1_of_place_14 = S::int(1)
        / f1_of_place_13.mul_add(sin_q_pin1, f1_of_place_12 * cos_q_pin1);
    let f1_of_place_15 = f1_of_place_12 * f1_of_place_14;
    let f1_of_u_2_11 = u_2_minus_f1_of_u_2 * f1_of_place_13;
    // -u*f1_of_place_14*(f1_of_u_2_11 + f1_of_place_15*(f1_of_place_3*f1_of_u_2*f1_of_place_12 +
    //   u_2_minus_f1_of_u_2*f1_of_place_12*sin(q_pin1) - cos(q_pin1)*(f1_of_u_2_2*f1_of_place_13 +
    //   f1_of_u_2_11)))
    let f1_of_u_2_12 = -u_2 * f1_of_place_14
        * (f1_of_u_2_11
            + f1_of_place_15
                * (f1_of_place_3 * f1_of_u_2 * f1_of_place_12
                    + u_2_minus_f1_of_u_2 * f1_of_place_12 * sin_q_pin1
                    - cos_q_pin1 * f1_of_u_2_2.mul_add(f1_of_place_13, f1_of_u_2_11)));
    // -l*f1_of_u_2_12
    let minus_l_f1_of_u_2_12 = -l * f1_of_u_2_12;
    // -l_m_l*f1_of_u_2_12
    let minus_l_m_l_f1_of_u_2_12 = -l_m_l * f1_of_u_2_12;
    let f1_of_u_2_13 = u_2 * f1_of_place_15 * sin_q_pin1;
    let l_sin_q_pin2 = l * sin_q_pin2;
    // f1_of_u_2_f1_of_place_10^2*l_sin_q_pin2 - l_f1_of_u_2_6*cos(q_pin2)
    let f1_of_u_2_14 = (-l_f1_of_u_2_6)
        .mul_add(
            cos_q_pin2,
            f1_of_u_2_f1_of_place_10 * f1_of_u_2_f1_of_place_10 * l_sin_q_pin2,
        );
    // m_l*(l*f1_of_u_2_13*(u + f1_of_u_2_2) - minus_l_f1_of_u_2_12*cos(q_pin1)) +
    //   m*l*sin_q_pin1_sin_angle_inv*f1_of_place_10*(l_f1_of_u_2_3*cos(q_pin2) + f1_of_u_2_sq*l_sin_q_pin2)
    let f1_of_u_2_15 = m_l
        * (l * f1_of_u_2_13 * (u_2 + f1_of_u_2_2) - minus_l_f1_of_u_2_12 * cos_q_pin1)
        + m * l * sin_q_pin1_sin_angle_inv * f1_of_place_10
            * f1_of_u_2_sq.mul_add(l_sin_q_pin2, l_f1_of_u_2_3 * cos_q_pin2);
    // f1_of_place_2*(g*(f1_of_place_4*f1_of_place_10 - f1_of_place_11*cos(q_ground2)) + f1_of_u_2_14) -
    //   f1_of_u_2_15
    let f1_of_u_2_16 = f1_of_place_2
        * (g * (-f1_of_place_11).mul_add(cos_q_ground2, f1_of_place_4 * f1_of_place_10)
            + f1_of_u_2_14) - f1_of_u_2_15;
    // sin_q_pin1_sin_angle_inv*(f1_of_u_2_10 - f1_of_place_11*f1_of_u_2_8*l_m_l) +
    //   f1_of_place_15*(3*m_l*(2*g*f1_of_q_2_q_pin1 + minus_l_f1_of_u_2_12) + minus_l_m_l_f1_of_u_2_12)
    let f1_of_u_2_17 = sin_q_pin1_sin_angle_inv
        * (-(f1_of_place_11 * f1_of_u_2_8)).mul_add(l_m_l, f1_of_u_2_10)
        + f1_of_place_15
            * (S::int(3) * m_l * (g * f1_of_q_2_q_pin1).mul_add(S::int(2), minus_l_f1_of_u_2_12)
                + minus_l_m_l_f1_of_u_2_12);
    // u*l_m_l*f1_of_u_2_13 + f1_of_u_2_16
    let f1_of_u_2_18 = (u_2 * l_m_l).mul_add(f1_of_u_2_13, f1_of_u_2_16);
    // Values.
    // f1 = m*l*g*cos(q + q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))/(2*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) - 3*m*l*g*cos(q)/2 -
    //   3*m*l*g*cos(q_ground1)*sin(q_pin1)/(2*sin(q - q_ground1 + q_pin1)) -
    //   m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(2*sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) - m*l*g*sin(q_pin1)*cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/(2*sin(q - q_ground1 + q_pin1)) +
    //   m*l^2*u^2*sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))/(2*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) -
    //   5*m*l*sin(q_pin1)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/(4*sin(q - q_ground1 + q_pin1)) -
    //   sin(q_pin1)*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/(12*sin(q - q_ground1 + q_pin1)) -
    //   m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(4*sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) -
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(12*sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)))^2)/(4*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + (cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(m*l^2*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)))^2)/(12*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + m*l*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))/(4*sin(q - q_ground1 + q_pin1)) + sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
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
    //   q_pin1)))/(12*sin(q - q_ground1 + q_pin1)) + m*l*(cos(q_pin1)*(l*u*(u*sin(q)*sin(q_ground1) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) -
    //   l*u*sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))/2 +
    //   m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/(2*sin(q - q_ground1 + q_pin1)) -
    //   m*(l^2*u^2*sin(q_pin1)^3*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))
    //   - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + l*sin(q_pin1)*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/2
    let f1 = S::ratio(1, 2) * f1_of_u_2_18
        - S::ratio(3, 2) * g * f1_of_place_2.mul_add(cos_q_ground1, m_l * cos_q)
        - S::ratio(1, 4) * f1_of_place_2 * l_f1_of_u_2_3.mul_add(S::int(5), f1_of_u_2_9)
        - S::ratio(1, 12) * f1_of_u_2_17;
    [f1]
}

/// The accelerations (u'), solved for when this code was generated.
///
/// 190 operations, 7 sines and cosines.
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
    let m_l = m * l;
    let l_m_l = l * m_l;
    // sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)
    let u_dot_of_place = cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1);
    // q - q_ground1 + q_pin1
    let u_dot_of_place_2 = q_2 - q_ground1 + q_pin1;
    let (sin_angle, cos_angle) = u_dot_of_place_2.sin_cos();
    let sin_angle_inv = S::int(1) / sin_angle;
    let sin_q_pin1_sin_angle_inv = sin_angle_inv * sin_q_pin1;
    let u_dot_of_u_2 = u_2 * sin_q_pin1_sin_angle_inv;
    // u - u_dot_of_u_2
    let u_2_minus_u_dot_of_u_2 = u_2 - u_dot_of_u_2;
    let u_dot_of_u_2_2 = u_dot_of_place * u_2_minus_u_dot_of_u_2;
    // sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)
    let u_dot_of_place_3 = (-cos_q).mul_add(sin_q_ground1, sin_q * cos_q_ground1);
    // sin(q)*sin(q_pin1) - cos(q)*cos(q_pin1)
    let u_dot_of_q_2_q_pin1 = (-cos_q).mul_add(cos_q_pin1, sin_q * sin_q_pin1);
    // sin(q_ground1)*(cos(q) - u_dot_of_q_2_q_pin1) - cos(q_ground1)*(sin(q) + cos(q)*sin(q_pin1) +
    //   sin(q)*cos(q_pin1))
    let u_dot_of_place_4 = sin_q_ground1 * (cos_q - u_dot_of_q_2_q_pin1)
        - cos_q_ground1 * (cos_q.mul_add(sin_q_pin1, sin_q) + sin_q * cos_q_pin1);
    let u_2_sin_angle_inv = u_2 * sin_angle_inv;
    let u_dot_of_u_2_3 = u_dot_of_place_4 * u_2_sin_angle_inv;
    // 1/(u_dot_of_place*sin(q_pin1) + u_dot_of_place_3*cos(q_pin1))
    let u_dot_of_place_5 = S::int(1)
        / u_dot_of_place_3.mul_add(cos_q_pin1, u_dot_of_place * sin_q_pin1);
    let u_dot_of_place_6 = u_dot_of_place_3 * u_dot_of_place_5;
    // u*u_dot_of_place_5*(u_dot_of_u_2_2 +
    //   u_dot_of_place_6*(u_2_minus_u_dot_of_u_2*u_dot_of_place_3*sin(q_pin1) +
    //   u_dot_of_u_2*u_dot_of_place_3*u_dot_of_place_4 - cos(q_pin1)*(u_dot_of_u_2_2 +
    //   u_dot_of_place*u_dot_of_u_2_3)))
    let u_dot_of_u_2_4 = u_2 * u_dot_of_place_5
        * (u_dot_of_u_2_2
            + u_dot_of_place_6
                * (u_2_minus_u_dot_of_u_2 * u_dot_of_place_3 * sin_q_pin1
                    + u_dot_of_u_2 * u_dot_of_place_3 * u_dot_of_place_4
                    - cos_q_pin1 * u_dot_of_place.mul_add(u_dot_of_u_2_3, u_dot_of_u_2_2)));
    // q_ground1 - q_ground2 + q_pin2
    let u_dot_of_place_7 = q_ground1 - q_ground2 + q_pin2;
    let (sin_angle_2, cos_angle_2) = u_dot_of_place_7.sin_cos();
    let sin_angle_2_inv = S::int(1) / sin_angle_2;
    // sin(q_ground1)*sin(q_pin2) - cos(q_ground1)*cos(q_pin2)
    let u_dot_of_place_8 = (-cos_q_ground1)
        .mul_add(cos_q_pin2, sin_q_ground1 * sin_q_pin2);
    // cos(q_ground1) - u_dot_of_place_8
    let u_dot_of_place_9 = cos_q_ground1 - u_dot_of_place_8;
    // cos(q_ground1)*sin(q_pin2) + sin(q_ground1)*cos(q_pin2)
    let u_dot_of_place_10 = sin_q_ground1
        .mul_add(cos_q_pin2, cos_q_ground1 * sin_q_pin2);
    // sin(q_ground1) + u_dot_of_place_10
    let u_dot_of_place_11 = sin_q_ground1 + u_dot_of_place_10;
    // sin_angle_2_inv*(u_dot_of_place_9*sin(q_ground2) - u_dot_of_place_11*cos(q_ground2))
    let u_dot_of_place_12 = sin_angle_2_inv
        * (-u_dot_of_place_11).mul_add(cos_q_ground2, u_dot_of_place_9 * sin_q_ground2);
    // 1 + u_dot_of_place_12
    let u_dot_of_place_13 = S::int(1) + u_dot_of_place_12;
    let u_dot_of_u_2_5 = u_dot_of_u_2 * u_dot_of_place_13;
    let u_dot_of_place_14 = sin_angle_2_inv * sin_q_pin2;
    let u_dot_of_u_2_6 = u_dot_of_u_2 * u_dot_of_place_14;
    // cos(q_ground1 - q_ground2 + q_pin2)*(u_dot_of_u_2_5 - u_dot_of_u_2_6)
    let u_dot_of_u_2_7 = cos_angle_2 * (u_dot_of_u_2_5 - u_dot_of_u_2_6);
    // cos(q_ground2)*(u_dot_of_place_8*u_dot_of_u_2_5 - u_dot_of_u_2*cos(q_ground1)) -
    //   sin(q_ground2)*(u_dot_of_u_2*sin(q_ground1) + u_dot_of_place_10*u_dot_of_u_2_5) +
    //   u_dot_of_u_2_6*(u_dot_of_place_9*cos(q_ground2) + u_dot_of_place_11*sin(q_ground2))
    let u_dot_of_u_2_8 = cos_q_ground2
        * (-u_dot_of_u_2).mul_add(cos_q_ground1, u_dot_of_place_8 * u_dot_of_u_2_5)
        - sin_q_ground2 * u_dot_of_place_10.mul_add(u_dot_of_u_2_5, u_dot_of_u_2 * sin_q_ground1)
        + u_dot_of_u_2_6
            * u_dot_of_place_11.mul_add(sin_q_ground2, u_dot_of_place_9 * cos_q_ground2);
    // sin_angle_inv*u_2_sin_angle_inv*(u*u_dot_of_place_4*cos(q_pin1) - sin(q_pin1)*cos(q - q_ground1 +
    //   q_pin1)*(u_2_minus_u_dot_of_u_2 + u_dot_of_u_2_3))
    let u_dot_of_u_2_9 = sin_angle_inv * u_2_sin_angle_inv
        * (-sin_q_pin1 * cos_angle * (u_2_minus_u_dot_of_u_2 + u_dot_of_u_2_3)
            + u_2 * u_dot_of_place_4 * cos_q_pin1);
    // u_dot_of_u_2*sin_angle_2_inv*(u_dot_of_u_2_8 - u_dot_of_place_12*u_dot_of_u_2_7) +
    //   u_dot_of_place_13*u_dot_of_u_2_9
    let u_dot_of_u_2_10 = u_dot_of_u_2 * sin_angle_2_inv
        * (-u_dot_of_place_12).mul_add(u_dot_of_u_2_7, u_dot_of_u_2_8)
        + u_dot_of_place_13 * u_dot_of_u_2_9;
    let u_dot_of_place_15 = sin_q_pin1_sin_angle_inv * u_dot_of_place_13;
    let l_u_dot_of_u_2_9 = l * u_dot_of_u_2_9;
    let m_l_times_3 = S::int(3) * m_l;
    let l_u_dot_of_u_2_4 = l * u_dot_of_u_2_4;
    let l_u_dot_of_u_2_10 = l * u_dot_of_u_2_10;
    let u_dot_of_place_16 = sin_q_pin1_sin_angle_inv * u_dot_of_place_14;
    // u_dot_of_u_2^2*u_dot_of_place_12*cos(q_pin2) + u_dot_of_u_2_9*sin(q_pin2)
    let u_dot_of_u_2_11 = u_dot_of_u_2_9
        .mul_add(
            sin_q_pin2,
            u_dot_of_u_2 * u_dot_of_u_2 * u_dot_of_place_12 * cos_q_pin2,
        );
    // sin_angle_2_inv*(u_dot_of_u_2_6*u_dot_of_u_2_7 - u_dot_of_u_2_11)
    let u_dot_of_u_2_12 = sin_angle_2_inv
        * u_dot_of_u_2_6.mul_add(u_dot_of_u_2_7, -u_dot_of_u_2_11);
    // -l_m_l*u_dot_of_u_2_12
    let u_dot_of_u_2_13 = -l_m_l * u_dot_of_u_2_12;
    // u_dot_of_q_2_q_pin1*u_dot_of_place_6 - u_dot_of_place_8*u_dot_of_place_15
    let u_dot_of_place_17 = (-u_dot_of_place_8)
        .mul_add(u_dot_of_place_15, u_dot_of_q_2_q_pin1 * u_dot_of_place_6);
    // cos(q) + sin_q_pin1_sin_angle_inv*cos(q_ground1)
    let u_dot_of_place_18 = sin_q_pin1_sin_angle_inv.mul_add(cos_q_ground1, cos_q);
    // u_dot_of_place_16*cos(q_ground2) + u_dot_of_place_17
    let u_dot_of_place_19 = u_dot_of_place_16.mul_add(cos_q_ground2, u_dot_of_place_17);
    let l_m_l_u_dot_of_place_6 = l_m_l * u_dot_of_place_6;
    let u_2_sin_q_pin1 = u_2 * sin_q_pin1;
    let u_dot_of_place_20 = u_dot_of_place_15 * cos_q_pin2;
    let l_u_dot_of_u_2 = l * u_dot_of_u_2;
    let u_dot_of_u_2_14 = l_u_dot_of_u_2 * sin_q_pin2;
    // l*u_dot_of_place_6*u_2_sin_q_pin1*(u + u_dot_of_u_2_3) - l_u_dot_of_u_2_4*cos(q_pin1)
    let u_dot_of_u_2_15 = l * u_dot_of_place_6 * u_2_sin_q_pin1 * (u_2 + u_dot_of_u_2_3)
        - l_u_dot_of_u_2_4 * cos_q_pin1;
    // m*(l*l_u_dot_of_u_2_9*u_dot_of_place_20 + u_dot_of_place_15*l_u_dot_of_u_2*u_dot_of_u_2_14) +
    //   m_l*(sin_q_pin1_sin_angle_inv*(l_u_dot_of_u_2_10*cos(q_pin2) -
    //   u_dot_of_place_13*u_dot_of_u_2_5*u_dot_of_u_2_14) + u_dot_of_u_2_15)
    let u_dot_of_u_2_16 = m
        * (u_dot_of_place_15 * l_u_dot_of_u_2)
            .mul_add(u_dot_of_u_2_14, l * l_u_dot_of_u_2_9 * u_dot_of_place_20)
        + m_l
            * (sin_q_pin1_sin_angle_inv
                * (-(u_dot_of_place_13 * u_dot_of_u_2_5))
                    .mul_add(u_dot_of_u_2_14, l_u_dot_of_u_2_10 * cos_q_pin2) + u_dot_of_u_2_15);
    // u*l_m_l_u_dot_of_place_6*u_2_sin_q_pin1 - u_dot_of_u_2_16
    let u_dot_of_u_2_17 = (u_2 * l_m_l_u_dot_of_place_6)
        .mul_add(u_2_sin_q_pin1, -u_dot_of_u_2_16);
    // g*m_l*(3*u_dot_of_place_18 + u_dot_of_place_19) - u_dot_of_u_2_17
    let u_dot_of_u_2_18 = g * m_l
        * u_dot_of_place_18.mul_add(S::int(3), u_dot_of_place_19) - u_dot_of_u_2_17;
    // 4 + u_dot_of_place_15^2
    let u_dot_of_place_21 = u_dot_of_place_15.mul_add(u_dot_of_place_15, S::int(4));
    // u_dot_of_place_16^2 + sin_q_pin1_sin_angle_inv*(4*sin_q_pin1_sin_angle_inv + 3*u_dot_of_place_20)
    let u_dot_of_place_22 = sin_q_pin1_sin_angle_inv
        * u_dot_of_place_20.mul_add(S::int(3), S::int(4) * sin_q_pin1_sin_angle_inv)
        + u_dot_of_place_16 * u_dot_of_place_16;
    // u' = (6*m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) - 18*m*l*g*cos(q) -
    //   18*m*l*g*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - 6*m*l*g*cos(q +
    //   q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   6*m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) - 6*m*l*g*sin(q_pin1)*cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1) -
    //   6*m*l^2*u^2*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   15*m*l*sin(q_pin1)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) -
    //   sin(q_pin1)*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) -
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) -
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) - 3*m*l*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   (sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(m*l^2*u*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   3*m*l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1)
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) - sin(q_pin1)*(1 +
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   6*m*l*(l*u*sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   cos(q_pin1)*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)) -
    //   6*m*(l^2*u^2*sin(q_pin1)^3*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + l*sin(q_pin1)*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)))/(4*(4*m*l^2 + 4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 +
    //   q_pin1)^2 + 3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2))
    let u_dot = S::ratio(1, 4)
        * (l_m_l * u_dot_of_place_6 * u_dot_of_u_2_4 + l_m_l * u_dot_of_u_2_10 * u_dot_of_place_15
            + sin_q_pin1_sin_angle_inv
                * (m_l * l_u_dot_of_u_2_9).mul_add(S::int(15), l_m_l * u_dot_of_u_2_9)
            + m_l_times_3
                * u_dot_of_place_15
                    .mul_add(l_u_dot_of_u_2_10, u_dot_of_place_6 * l_u_dot_of_u_2_4)
            + u_dot_of_place_16 * (-(l * m_l_times_3)).mul_add(u_dot_of_u_2_12, u_dot_of_u_2_13)
            + S::int(6) * u_dot_of_u_2_18)
        / (l_m_l_u_dot_of_place_6 * cos_q_pin1.mul_add(S::int(3), -u_dot_of_place_6)
            - l_m_l * (u_dot_of_place_21 + u_dot_of_place_22));
    [u_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 30 operations, 7 sines and cosines.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 1],
) -> [S; 5] {
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q_pin2, cos_q_pin2) = q_pin2.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    let (sin_angle, _) = (q_2 - q_ground1 + q_pin1).sin_cos();
    // Shared terms.
    let u_2_sin_angle_inv = u_2 / sin_angle;
    let q_ground1_dot_value_of_u_2 = u_2_sin_angle_inv * sin_q_pin1;
    let (sin_angle_2, _) = (q_ground1 - q_ground2 + q_pin2).sin_cos();
    let q_ground2_dot_value_of_u_2 = q_ground1_dot_value_of_u_2 / sin_angle_2;
    let q_ground2_dot_value_of_u_2_2 = q_ground2_dot_value_of_u_2 * sin_q_pin2;
    // Values.
    // q' = u
    let q_dot_value = u_2;
    // q_ground1' = u*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    let q_ground1_dot_value = q_ground1_dot_value_of_u_2;
    // q_ground2' = u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2))
    let q_ground2_dot_value = q_ground2_dot_value_of_u_2_2;
    // q_pin1' = u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)
    let q_pin1_dot_value = u_2_sin_angle_inv
        * (-sin_q).mul_add(cos_q_ground1, cos_q * sin_q_ground1) * (S::int(1) + cos_q_pin1)
        - q_ground1_dot_value_of_u_2 * cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1);
    // q_pin2' = u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_dot_value = q_ground2_dot_value_of_u_2
        * (-sin_q_ground1).mul_add(cos_q_ground2, cos_q_ground1 * sin_q_ground2)
        * (S::int(1) + cos_q_pin2)
        - q_ground2_dot_value_of_u_2_2
            * cos_q_ground1.mul_add(cos_q_ground2, sin_q_ground1 * sin_q_ground2);
    [
        q_dot_value, q_ground1_dot_value, q_ground2_dot_value, q_pin1_dot_value, q_pin2_dot_value,
    ]
}

/// Kinetic energy T.
///
/// 48 operations, 7 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 1]) -> S {
    let Parameters { m, l, .. } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q_pin2, cos_q_pin2) = q_pin2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    // Shared terms.
    // 1 + cos(q_pin2)
    let energy_of_q_pin2 = S::int(1) + cos_q_pin2;
    let (sin_angle, _) = (q_ground1 - q_ground2 + q_pin2).sin_cos();
    let sin_angle_inv = S::int(1) / sin_angle;
    // 1 - sin_angle_inv*(cos(q_ground2)*(cos(q_ground1)*sin(q_pin2) + energy_of_q_pin2*sin(q_ground1)) +
    //   sin(q_ground2)*(sin(q_ground1)*sin(q_pin2) - energy_of_q_pin2*cos(q_ground1)))
    let energy_of_place = S::int(1)
        - sin_angle_inv
            * (cos_q_ground2 * energy_of_q_pin2.mul_add(sin_q_ground1, cos_q_ground1 * sin_q_pin2)
                + sin_q_ground2
                    * (-energy_of_q_pin2)
                        .mul_add(cos_q_ground1, sin_q_ground1 * sin_q_pin2));
    let sin_q_pin2_sin_angle_inv = sin_angle_inv * sin_q_pin2;
    // 4 + sin_q_pin2_sin_angle_inv^2
    let energy_of_place_2 = sin_q_pin2_sin_angle_inv
        .mul_add(sin_q_pin2_sin_angle_inv, S::int(4));
    let (sin_angle_2, _) = (q_2 - q_ground1 + q_pin1).sin_cos();
    let energy_of_place_3 = sin_q_pin1 / sin_angle_2;
    // sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)
    let energy_of_place_4 = (-cos_q).mul_add(sin_q_ground1, sin_q * cos_q_ground1);
    // energy_of_place_4/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   energy_of_place_4*cos(q_pin1))
    let energy_of_place_5 = energy_of_place_4
        / (sin_q_pin1 * cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1)
            + energy_of_place_4 * cos_q_pin1);
    // 4 + energy_of_place_3^2*(energy_of_place*(3*cos(q_pin2) + energy_of_place) + energy_of_place_2)
    let energy_of_place_6 = S::int(4)
        + energy_of_place_3 * energy_of_place_3
            * (energy_of_place * cos_q_pin2.mul_add(S::int(3), energy_of_place)
                + energy_of_place_2);
    // Values.
    // T = u^2*(4*m*l^2 + 4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 + q_pin1)^2 +
    //   3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2)/6
    let energy = S::ratio(1, 6) * m * l * l * u_2 * u_2
        * (energy_of_place_5 * (-cos_q_pin1).mul_add(S::int(3), energy_of_place_5)
            + energy_of_place_6);
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 11 operations, 5 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5]) -> S {
    let Parameters { m, l, g } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    let (sin_q_ground1, _) = q_ground1.sin_cos();
    let (sin_q_ground2, _) = q_ground2.sin_cos();
    // Shared terms.
    // sin(q) + sin(q_ground1)
    let sin_q_plus_sin_q_ground1 = sin_q + sin_q_ground1;
    let (sin_q_plus_q_pin1, _) = (q_2 + q_pin1).sin_cos();
    let (sin_q_ground1_plus_q_pin2, _) = (q_ground1 + q_pin2).sin_cos();
    // Values.
    // V = m*l*g*(3*sin(q) + 3*sin(q_ground1) + sin(q_ground2) + sin(q + q_pin1) + sin(q_ground1 +
    //   q_pin2))/2
    let energy = S::ratio(1, 2) * m * l * g
        * sin_q_plus_sin_q_ground1
            .mul_add(
                S::int(3),
                sin_q_ground2 + sin_q_plus_q_pin1 + sin_q_ground1_plus_q_pin2,
            );
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 190 operations, 7 sines and cosines.
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
    let m_l = m * l;
    let l_m_l = l * m_l;
    // sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)
    let u_dot_of_place = cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1);
    // q - q_ground1 + q_pin1
    let u_dot_of_place_2 = q_2 - q_ground1 + q_pin1;
    let (sin_angle, cos_angle) = u_dot_of_place_2.sin_cos();
    let sin_angle_inv = S::int(1) / sin_angle;
    let sin_q_pin1_sin_angle_inv = sin_angle_inv * sin_q_pin1;
    let u_dot_of_u_2 = u_2 * sin_q_pin1_sin_angle_inv;
    // u - u_dot_of_u_2
    let u_2_minus_u_dot_of_u_2 = u_2 - u_dot_of_u_2;
    let u_dot_of_u_2_2 = u_dot_of_place * u_2_minus_u_dot_of_u_2;
    // sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)
    let u_dot_of_place_3 = (-cos_q).mul_add(sin_q_ground1, sin_q * cos_q_ground1);
    // sin(q)*sin(q_pin1) - cos(q)*cos(q_pin1)
    let u_dot_of_q_2_q_pin1 = (-cos_q).mul_add(cos_q_pin1, sin_q * sin_q_pin1);
    // sin(q_ground1)*(cos(q) - u_dot_of_q_2_q_pin1) - cos(q_ground1)*(sin(q) + cos(q)*sin(q_pin1) +
    //   sin(q)*cos(q_pin1))
    let u_dot_of_place_4 = sin_q_ground1 * (cos_q - u_dot_of_q_2_q_pin1)
        - cos_q_ground1 * (cos_q.mul_add(sin_q_pin1, sin_q) + sin_q * cos_q_pin1);
    let u_2_sin_angle_inv = u_2 * sin_angle_inv;
    let u_dot_of_u_2_3 = u_dot_of_place_4 * u_2_sin_angle_inv;
    // 1/(u_dot_of_place*sin(q_pin1) + u_dot_of_place_3*cos(q_pin1))
    let u_dot_of_place_5 = S::int(1)
        / u_dot_of_place_3.mul_add(cos_q_pin1, u_dot_of_place * sin_q_pin1);
    let u_dot_of_place_6 = u_dot_of_place_3 * u_dot_of_place_5;
    // u*u_dot_of_place_5*(u_dot_of_u_2_2 +
    //   u_dot_of_place_6*(u_2_minus_u_dot_of_u_2*u_dot_of_place_3*sin(q_pin1) +
    //   u_dot_of_u_2*u_dot_of_place_3*u_dot_of_place_4 - cos(q_pin1)*(u_dot_of_u_2_2 +
    //   u_dot_of_place*u_dot_of_u_2_3)))
    let u_dot_of_u_2_4 = u_2 * u_dot_of_place_5
        * (u_dot_of_u_2_2
            + u_dot_of_place_6
                * (u_2_minus_u_dot_of_u_2 * u_dot_of_place_3 * sin_q_pin1
                    + u_dot_of_u_2 * u_dot_of_place_3 * u_dot_of_place_4
                    - cos_q_pin1 * u_dot_of_place.mul_add(u_dot_of_u_2_3, u_dot_of_u_2_2)));
    // q_ground1 - q_ground2 + q_pin2
    let u_dot_of_place_7 = q_ground1 - q_ground2 + q_pin2;
    let (sin_angle_2, cos_angle_2) = u_dot_of_place_7.sin_cos();
    let sin_angle_2_inv = S::int(1) / sin_angle_2;
    // sin(q_ground1)*sin(q_pin2) - cos(q_ground1)*cos(q_pin2)
    let u_dot_of_place_8 = (-cos_q_ground1)
        .mul_add(cos_q_pin2, sin_q_ground1 * sin_q_pin2);
    // cos(q_ground1) - u_dot_of_place_8
    let u_dot_of_place_9 = cos_q_ground1 - u_dot_of_place_8;
    // cos(q_ground1)*sin(q_pin2) + sin(q_ground1)*cos(q_pin2)
    let u_dot_of_place_10 = sin_q_ground1
        .mul_add(cos_q_pin2, cos_q_ground1 * sin_q_pin2);
    // sin(q_ground1) + u_dot_of_place_10
    let u_dot_of_place_11 = sin_q_ground1 + u_dot_of_place_10;
    // sin_angle_2_inv*(u_dot_of_place_9*sin(q_ground2) - u_dot_of_place_11*cos(q_ground2))
    let u_dot_of_place_12 = sin_angle_2_inv
        * (-u_dot_of_place_11).mul_add(cos_q_ground2, u_dot_of_place_9 * sin_q_ground2);
    let u_dot_of_u_2_5 = u_dot_of_u_2 * u_dot_of_place_12;
    // u_dot_of_u_2 + u_dot_of_u_2_5
    let u_dot_of_u_2_6 = u_dot_of_u_2 + u_dot_of_u_2_5;
    let u_dot_of_place_13 = sin_angle_2_inv * sin_q_pin2;
    let u_dot_of_u_2_7 = u_dot_of_u_2 * u_dot_of_place_13;
    // cos(q_ground1 - q_ground2 + q_pin2)*(u_dot_of_u_2_6 - u_dot_of_u_2_7)
    let u_dot_of_u_2_8 = cos_angle_2 * (u_dot_of_u_2_6 - u_dot_of_u_2_7);
    // cos(q_ground2)*(u_dot_of_place_8*u_dot_of_u_2_6 - u_dot_of_u_2*cos(q_ground1)) -
    //   sin(q_ground2)*(u_dot_of_u_2*sin(q_ground1) + u_dot_of_place_10*u_dot_of_u_2_6) +
    //   u_dot_of_u_2_7*(u_dot_of_place_9*cos(q_ground2) + u_dot_of_place_11*sin(q_ground2))
    let u_dot_of_u_2_9 = cos_q_ground2
        * (-u_dot_of_u_2).mul_add(cos_q_ground1, u_dot_of_place_8 * u_dot_of_u_2_6)
        - sin_q_ground2 * u_dot_of_place_10.mul_add(u_dot_of_u_2_6, u_dot_of_u_2 * sin_q_ground1)
        + u_dot_of_u_2_7
            * u_dot_of_place_11.mul_add(sin_q_ground2, u_dot_of_place_9 * cos_q_ground2);
    // 1 + u_dot_of_place_12
    let u_dot_of_place_14 = S::int(1) + u_dot_of_place_12;
    // sin_angle_inv*u_2_sin_angle_inv*(u*u_dot_of_place_4*cos(q_pin1) - sin(q_pin1)*cos(q - q_ground1 +
    //   q_pin1)*(u_2_minus_u_dot_of_u_2 + u_dot_of_u_2_3))
    let u_dot_of_u_2_10 = sin_angle_inv * u_2_sin_angle_inv
        * (-sin_q_pin1 * cos_angle * (u_2_minus_u_dot_of_u_2 + u_dot_of_u_2_3)
            + u_2 * u_dot_of_place_4 * cos_q_pin1);
    // u_dot_of_u_2*sin_angle_2_inv*(u_dot_of_u_2_9 - u_dot_of_place_12*u_dot_of_u_2_8) +
    //   u_dot_of_place_14*u_dot_of_u_2_10
    let u_dot_of_u_2_11 = u_dot_of_u_2 * sin_angle_2_inv
        * (-u_dot_of_place_12).mul_add(u_dot_of_u_2_8, u_dot_of_u_2_9)
        + u_dot_of_place_14 * u_dot_of_u_2_10;
    let u_dot_of_place_15 = sin_q_pin1_sin_angle_inv * u_dot_of_place_14;
    let l_u_dot_of_u_2_10 = l * u_dot_of_u_2_10;
    let m_l_times_3 = S::int(3) * m_l;
    let l_u_dot_of_u_2_4 = l * u_dot_of_u_2_4;
    let l_u_dot_of_u_2_11 = l * u_dot_of_u_2_11;
    let u_dot_of_place_16 = sin_q_pin1_sin_angle_inv * u_dot_of_place_13;
    // u_dot_of_u_2*u_dot_of_u_2_5*cos(q_pin2) + u_dot_of_u_2_10*sin(q_pin2)
    let u_dot_of_u_2_12 = u_dot_of_u_2_10
        .mul_add(sin_q_pin2, u_dot_of_u_2 * u_dot_of_u_2_5 * cos_q_pin2);
    // sin_angle_2_inv*(u_dot_of_u_2_7*u_dot_of_u_2_8 - u_dot_of_u_2_12)
    let u_dot_of_u_2_13 = sin_angle_2_inv
        * u_dot_of_u_2_7.mul_add(u_dot_of_u_2_8, -u_dot_of_u_2_12);
    // -l_m_l*u_dot_of_u_2_13
    let u_dot_of_u_2_14 = -l_m_l * u_dot_of_u_2_13;
    // u_dot_of_q_2_q_pin1*u_dot_of_place_6 - u_dot_of_place_8*u_dot_of_place_15
    let u_dot_of_place_17 = (-u_dot_of_place_8)
        .mul_add(u_dot_of_place_15, u_dot_of_q_2_q_pin1 * u_dot_of_place_6);
    // cos(q) + sin_q_pin1_sin_angle_inv*cos(q_ground1)
    let u_dot_of_place_18 = sin_q_pin1_sin_angle_inv.mul_add(cos_q_ground1, cos_q);
    // u_dot_of_place_16*cos(q_ground2) + u_dot_of_place_17
    let u_dot_of_place_19 = u_dot_of_place_16.mul_add(cos_q_ground2, u_dot_of_place_17);
    let l_m_l_u_dot_of_place_6 = l_m_l * u_dot_of_place_6;
    let u_2_sin_q_pin1 = u_2 * sin_q_pin1;
    let u_dot_of_place_20 = u_dot_of_place_15 * cos_q_pin2;
    let l_u_dot_of_u_2 = l * u_dot_of_u_2;
    let u_dot_of_u_2_15 = l_u_dot_of_u_2 * sin_q_pin2;
    // l*u_dot_of_place_6*u_2_sin_q_pin1*(u + u_dot_of_u_2_3) - l_u_dot_of_u_2_4*cos(q_pin1)
    let u_dot_of_u_2_16 = l * u_dot_of_place_6 * u_2_sin_q_pin1 * (u_2 + u_dot_of_u_2_3)
        - l_u_dot_of_u_2_4 * cos_q_pin1;
    // m*(l*l_u_dot_of_u_2_10*u_dot_of_place_20 + u_dot_of_place_15*l_u_dot_of_u_2*u_dot_of_u_2_15) +
    //   m_l*(sin_q_pin1_sin_angle_inv*(l_u_dot_of_u_2_11*cos(q_pin2) -
    //   u_dot_of_u_2_6*u_dot_of_place_14*u_dot_of_u_2_15) + u_dot_of_u_2_16)
    let u_dot_of_u_2_17 = m
        * (u_dot_of_place_15 * l_u_dot_of_u_2)
            .mul_add(u_dot_of_u_2_15, l * l_u_dot_of_u_2_10 * u_dot_of_place_20)
        + m_l
            * (sin_q_pin1_sin_angle_inv
                * (-(u_dot_of_u_2_6 * u_dot_of_place_14))
                    .mul_add(u_dot_of_u_2_15, l_u_dot_of_u_2_11 * cos_q_pin2) + u_dot_of_u_2_16);
    // u*l_m_l_u_dot_of_place_6*u_2_sin_q_pin1 - u_dot_of_u_2_17
    let u_dot_of_u_2_18 = (u_2 * l_m_l_u_dot_of_place_6)
        .mul_add(u_2_sin_q_pin1, -u_dot_of_u_2_17);
    // g*m_l*(3*u_dot_of_place_18 + u_dot_of_place_19) - u_dot_of_u_2_18
    let u_dot_of_u_2_19 = g * m_l
        * u_dot_of_place_18.mul_add(S::int(3), u_dot_of_place_19) - u_dot_of_u_2_18;
    // 4 + u_dot_of_place_15^2
    let u_dot_of_place_21 = u_dot_of_place_15.mul_add(u_dot_of_place_15, S::int(4));
    // u_dot_of_place_16^2 + sin_q_pin1_sin_angle_inv*(4*sin_q_pin1_sin_angle_inv + 3*u_dot_of_place_20)
    let u_dot_of_place_22 = sin_q_pin1_sin_angle_inv
        * u_dot_of_place_20.mul_add(S::int(3), S::int(4) * sin_q_pin1_sin_angle_inv)
        + u_dot_of_place_16 * u_dot_of_place_16;
    // u' = (6*m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) - 18*m*l*g*cos(q) -
    //   18*m*l*g*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - 6*m*l*g*cos(q +
    //   q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   6*m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) - 6*m*l*g*sin(q_pin1)*cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1) -
    //   6*m*l^2*u^2*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   15*m*l*sin(q_pin1)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) -
    //   sin(q_pin1)*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) -
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) -
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) - 3*m*l*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   (sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(m*l^2*u*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   3*m*l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1)
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) - sin(q_pin1)*(1 +
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   6*m*l*(l*u*sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   cos(q_pin1)*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)) -
    //   6*m*(l^2*u^2*sin(q_pin1)^3*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + l*sin(q_pin1)*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)))/(4*(4*m*l^2 + 4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 +
    //   q_pin1)^2 + 3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2))
    let u_dot = S::ratio(1, 4)
        * (l_m_l * u_dot_of_place_6 * u_dot_of_u_2_4 + l_m_l * u_dot_of_u_2_11 * u_dot_of_place_15
            + sin_q_pin1_sin_angle_inv
                * (m_l * l_u_dot_of_u_2_10).mul_add(S::int(15), l_m_l * u_dot_of_u_2_10)
            + m_l_times_3
                * u_dot_of_place_15
                    .mul_add(l_u_dot_of_u_2_11, u_dot_of_place_6 * l_u_dot_of_u_2_4)
            + u_dot_of_place_16 * (-(l * m_l_times_3)).mul_add(u_dot_of_u_2_13, u_dot_of_u_2_14)
            + S::int(6) * u_dot_of_u_2_19)
        / (l_m_l_u_dot_of_place_6 * cos_q_pin1.mul_add(S::int(3), -u_dot_of_place_6)
            - l_m_l * (u_dot_of_place_21 + u_dot_of_place_22));
    // Values.
    // q' = u
    let q_dot_value = u_2;
    // q_ground1' = u*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    let q_ground1_dot_value = u_dot_of_u_2;
    // q_ground2' = u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2))
    let q_ground2_dot_value = u_dot_of_u_2_7;
    // q_pin1' = u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)
    let q_pin1_dot_value = u_dot_of_u_2_3;
    // q_pin2' = u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_dot_value = u_dot_of_u_2_5;
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
/// 974 operations, 7 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 1]) -> [[S; 6]; 6] {
    let Parameters { m, l, g } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q_pin2, cos_q_pin2) = q_pin2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // q_ground1 - q_ground2 + q_pin2
    let u_dot_by_q_of_place = q_ground1 - q_ground2 + q_pin2;
    let (sin_angle, cos_angle) = u_dot_by_q_of_place.sin_cos();
    let sin_angle_inv = S::int(1) / sin_angle;
    let sin_q_pin2_cos_q_ground1 = cos_q_ground1 * sin_q_pin2;
    // sin(q_ground1)*cos(q_pin2) + sin_q_pin2_cos_q_ground1
    let u_dot_by_q_of_place_2 = sin_q_ground1
        .mul_add(cos_q_pin2, sin_q_pin2_cos_q_ground1);
    // q - q_ground1 + q_pin1
    let u_dot_by_q_of_place_3 = q_2 - q_ground1 + q_pin1;
    let (sin_angle_2, cos_angle_2) = u_dot_by_q_of_place_3.sin_cos();
    let sin_angle_2_inv = S::int(1) / sin_angle_2;
    let u_dot_by_q_of_place_4 = sin_angle_2_inv * cos_angle_2;
    // 1 + cos(q_pin2)
    let u_dot_by_q_of_q_pin2 = S::int(1) + cos_q_pin2;
    let sin_q_pin2_sin_q_ground1 = sin_q_ground1 * sin_q_pin2;
    // u_dot_by_q_of_q_pin2*cos(q_ground1) - sin_q_pin2_sin_q_ground1
    let u_dot_by_q_of_place_5 = u_dot_by_q_of_q_pin2
        .mul_add(cos_q_ground1, -sin_q_pin2_sin_q_ground1);
    // sin_q_pin2_cos_q_ground1 + u_dot_by_q_of_q_pin2*sin(q_ground1)
    let u_dot_by_q_of_place_6 = u_dot_by_q_of_q_pin2
        .mul_add(sin_q_ground1, sin_q_pin2_cos_q_ground1);
    // u_dot_by_q_of_place_5*sin(q_ground2) - u_dot_by_q_of_place_6*cos(q_ground2)
    let u_dot_by_q_of_place_7 = (-u_dot_by_q_of_place_6)
        .mul_add(cos_q_ground2, u_dot_by_q_of_place_5 * sin_q_ground2);
    let u_dot_by_q_of_place_8 = sin_angle_2_inv * sin_q_pin1;
    let u_dot_by_q_of_u_2 = u_2 * u_dot_by_q_of_place_8;
    let u_dot_by_q_of_u_2_2 = sin_angle_inv * u_dot_by_q_of_u_2;
    let u_dot_by_q_of_u_2_3 = u_dot_by_q_of_place_7 * u_dot_by_q_of_u_2_2;
    let u_dot_by_q_of_u_2_4 = u_dot_by_q_of_place_4 * u_dot_by_q_of_u_2;
    // u_dot_by_q_of_place_4*u_dot_by_q_of_u_2_3 + u_dot_by_q_of_u_2_4
    let u_dot_by_q_of_u_2_5 = u_dot_by_q_of_place_4
        .mul_add(u_dot_by_q_of_u_2_3, u_dot_by_q_of_u_2_4);
    let u_dot_by_q_of_u_2_6 = u_dot_by_q_of_u_2_4 * sin_q_ground1;
    // sin_q_pin2_sin_q_ground1 - cos(q_ground1)*cos(q_pin2)
    let u_dot_by_q_of_place_9 = (-cos_q_ground1)
        .mul_add(cos_q_pin2, sin_q_pin2_sin_q_ground1);
    let u_dot_by_q_of_u_2_7 = u_dot_by_q_of_u_2_4 * cos_q_ground1;
    // u_dot_by_q_of_place_5*cos(q_ground2) + u_dot_by_q_of_place_6*sin(q_ground2)
    let u_dot_by_q_of_place_10 = u_dot_by_q_of_place_6
        .mul_add(sin_q_ground2, u_dot_by_q_of_place_5 * cos_q_ground2);
    let u_dot_by_q_of_u_2_8 = u_dot_by_q_of_u_2_2 * sin_q_pin2;
    let u_dot_by_q_of_u_2_9 = u_dot_by_q_of_place_4 * u_dot_by_q_of_u_2_8;
    // u_dot_by_q_of_u_2_5 - u_dot_by_q_of_u_2_9
    let u_dot_by_q_of_u_2_10 = u_dot_by_q_of_u_2_5 - u_dot_by_q_of_u_2_9;
    let cos_angle_sin_angle_inv = sin_angle_inv * cos_angle;
    let u_dot_by_q_of_place_11 = sin_angle_inv * u_dot_by_q_of_place_7;
    let u_dot_by_q_of_place_12 = cos_angle_sin_angle_inv * u_dot_by_q_of_place_11;
    // sin_angle_inv*(sin(q_ground2)*(u_dot_by_q_of_place_2*u_dot_by_q_of_u_2_5 + u_dot_by_q_of_u_2_6) +
    //   cos(q_ground2)*(u_dot_by_q_of_u_2_7 - u_dot_by_q_of_u_2_5*u_dot_by_q_of_place_9) -
    //   u_dot_by_q_of_place_10*u_dot_by_q_of_u_2_9) + u_dot_by_q_of_u_2_10*u_dot_by_q_of_place_12
    let u_dot_by_q_of_u_2_11 = sin_angle_inv
        * (sin_q_ground2 * u_dot_by_q_of_place_2.mul_add(u_dot_by_q_of_u_2_5, u_dot_by_q_of_u_2_6)
            + cos_q_ground2
                * (-u_dot_by_q_of_u_2_5)
                    .mul_add(u_dot_by_q_of_place_9, u_dot_by_q_of_u_2_7)
            - u_dot_by_q_of_place_10 * u_dot_by_q_of_u_2_9)
        + u_dot_by_q_of_u_2_10 * u_dot_by_q_of_place_12;
    let m_l = m * l;
    let l_m_l = l * m_l;
    let u_dot_by_q_of_u_2_l_m_l = u_dot_by_q_of_u_2 * l_m_l;
    // 1 + u_dot_by_q_of_place_11
    let u_dot_by_q_of_place_13 = S::int(1) + u_dot_by_q_of_place_11;
    // sin(q)*sin(q_pin1) - cos(q)*cos(q_pin1)
    let u_dot_by_q_of_q_2_q_pin1 = (-cos_q).mul_add(cos_q_pin1, sin_q * sin_q_pin1);
    // cos(q) - u_dot_by_q_of_q_2_q_pin1
    let u_dot_by_q_of_q_2_q_pin1_2 = cos_q - u_dot_by_q_of_q_2_q_pin1;
    // cos(q)*sin(q_pin1) + sin(q)*cos(q_pin1)
    let u_dot_by_q_of_q_2_q_pin1_3 = sin_q.mul_add(cos_q_pin1, cos_q * sin_q_pin1);
    // sin(q) + u_dot_by_q_of_q_2_q_pin1_3
    let u_dot_by_q_of_q_2_q_pin1_4 = sin_q + u_dot_by_q_of_q_2_q_pin1_3;
    // u_dot_by_q_of_q_2_q_pin1_2*sin(q_ground1) - u_dot_by_q_of_q_2_q_pin1_4*cos(q_ground1)
    let u_dot_by_q_of_place_14 = (-u_dot_by_q_of_q_2_q_pin1_4)
        .mul_add(cos_q_ground1, u_dot_by_q_of_q_2_q_pin1_2 * sin_q_ground1);
    let u_2_sin_angle_2_inv = u_2 * sin_angle_2_inv;
    let u_dot_by_q_of_u_2_12 = u_dot_by_q_of_place_14 * u_2_sin_angle_2_inv;
    // u - u_dot_by_q_of_u_2
    let u_dot_by_q_of_u_2_13 = u_2 - u_dot_by_q_of_u_2;
    // u_dot_by_q_of_u_2_12 + u_dot_by_q_of_u_2_13
    let u_dot_by_q_of_u_2_14 = u_dot_by_q_of_u_2_12 + u_dot_by_q_of_u_2_13;
    // u_dot_by_q_of_q_2_q_pin1_2*cos(q_ground1) + u_dot_by_q_of_q_2_q_pin1_4*sin(q_ground1)
    let u_dot_by_q_of_place_15 = u_dot_by_q_of_q_2_q_pin1_4
        .mul_add(sin_q_ground1, u_dot_by_q_of_q_2_q_pin1_2 * cos_q_ground1);
    let u_dot_by_q_of_u_2_15 = u_dot_by_q_of_place_4 * u_dot_by_q_of_u_2_12;
    // u_2_sin_angle_2_inv*u_dot_by_q_of_place_15 + u_dot_by_q_of_u_2_15
    let u_dot_by_q_of_u_2_16 = u_2_sin_angle_2_inv
        .mul_add(u_dot_by_q_of_place_15, u_dot_by_q_of_u_2_15);
    // u_dot_by_q_of_u_2_14 + u_dot_by_q_of_place_4*(u_dot_by_q_of_u_2_16 - u_dot_by_q_of_u_2_4)
    let u_dot_by_q_of_u_2_17 = u_dot_by_q_of_u_2_14
        + u_dot_by_q_of_place_4 * (u_dot_by_q_of_u_2_16 - u_dot_by_q_of_u_2_4);
    // u_dot_by_q_of_u_2 + u_dot_by_q_of_u_2_3
    let u_dot_by_q_of_u_2_18 = u_dot_by_q_of_u_2 + u_dot_by_q_of_u_2_3;
    let u_dot_by_q_of_u_2_19 = u_dot_by_q_of_place_2 * u_dot_by_q_of_u_2_18;
    // u_dot_by_q_of_u_2*sin(q_ground1) + u_dot_by_q_of_u_2_19
    let u_dot_by_q_of_u_2_20 = u_dot_by_q_of_u_2
        .mul_add(sin_q_ground1, u_dot_by_q_of_u_2_19);
    let u_dot_by_q_of_u_2_21 = u_dot_by_q_of_place_9 * u_dot_by_q_of_u_2_18;
    // u_dot_by_q_of_u_2*cos(q_ground1) - u_dot_by_q_of_u_2_21
    let u_dot_by_q_of_u_2_22 = u_dot_by_q_of_u_2
        .mul_add(cos_q_ground1, -u_dot_by_q_of_u_2_21);
    // sin_angle_inv*(u_dot_by_q_of_place_10*u_dot_by_q_of_u_2_8 - u_dot_by_q_of_u_2_20*sin(q_ground2) -
    //   u_dot_by_q_of_u_2_22*cos(q_ground2))
    let u_dot_by_q_of_u_2_23 = sin_angle_inv
        * ((-u_dot_by_q_of_u_2_20)
            .mul_add(sin_q_ground2, u_dot_by_q_of_place_10 * u_dot_by_q_of_u_2_8)
            - u_dot_by_q_of_u_2_22 * cos_q_ground2);
    // u_dot_by_q_of_u_2_18 - u_dot_by_q_of_u_2_8
    let u_dot_by_q_of_u_2_24 = u_dot_by_q_of_u_2_18 - u_dot_by_q_of_u_2_8;
    let u_dot_by_q_of_u_2_25 = u_dot_by_q_of_place_12 * u_dot_by_q_of_u_2_24;
    // u_dot_by_q_of_u_2_25 - u_dot_by_q_of_u_2_23
    let u_dot_by_q_of_u_2_26 = u_dot_by_q_of_u_2_25 - u_dot_by_q_of_u_2_23;
    // u_dot_by_q_of_place_13*u_dot_by_q_of_u_2_17 + u_dot_by_q_of_place_4*u_dot_by_q_of_u_2_26
    let u_dot_by_q_of_u_2_27 = u_dot_by_q_of_place_4
        .mul_add(u_dot_by_q_of_u_2_26, u_dot_by_q_of_place_13 * u_dot_by_q_of_u_2_17);
    let u_dot_by_q_of_u_2_28 = u_2_sin_angle_2_inv * cos_q_pin1;
    let u_dot_by_q_of_place_16 = u_dot_by_q_of_place_8 * cos_angle_2;
    let u_dot_by_q_of_u_2_29 = u_dot_by_q_of_u_2_12 * cos_q_pin1;
    // u_dot_by_q_of_u_2_29 - u_dot_by_q_of_u_2_14*u_dot_by_q_of_place_16
    let u_dot_by_q_of_u_2_30 = (-u_dot_by_q_of_u_2_14)
        .mul_add(u_dot_by_q_of_place_16, u_dot_by_q_of_u_2_29);
    let u_dot_by_q_of_place_17 = S::int(2) * u_dot_by_q_of_place_4;
    let u_dot_by_q_of_u_2_31 = u_dot_by_q_of_u_2_30 * u_dot_by_q_of_place_17;
    // u_2_sin_angle_2_inv*(u_dot_by_q_of_place_15*u_dot_by_q_of_u_2_28 + u_dot_by_q_of_u_2_31)
    let u_dot_by_q_of_u_2_32 = u_2_sin_angle_2_inv
        * u_dot_by_q_of_place_15.mul_add(u_dot_by_q_of_u_2_28, u_dot_by_q_of_u_2_31);
    let u_dot_by_q_of_place_18 = l_m_l * u_dot_by_q_of_place_13;
    // u_dot_by_q_of_u_2_32*u_dot_by_q_of_place_18 - u_dot_by_q_of_u_2_l_m_l*u_dot_by_q_of_u_2_27
    let u_dot_by_q_of_u_2_33 = (-u_dot_by_q_of_u_2_l_m_l)
        .mul_add(u_dot_by_q_of_u_2_27, u_dot_by_q_of_u_2_32 * u_dot_by_q_of_place_18);
    let u_dot_by_q_of_place_19 = u_dot_by_q_of_place_8 * u_dot_by_q_of_place_13;
    let sin_q_pin2_sin_angle_inv = sin_angle_inv * sin_q_pin2;
    let u_dot_by_q_of_place_20 = sin_q_pin2_sin_angle_inv * cos_angle;
    let u_dot_by_q_of_u_2_34 = u_dot_by_q_of_u_2_24 * u_dot_by_q_of_place_20;
    let u_dot_by_q_of_u_2_35 = u_dot_by_q_of_u_2_3 * cos_q_pin2;
    // 2*u_dot_by_q_of_u_2_35 - u_dot_by_q_of_u_2_34
    let u_dot_by_q_of_u_2_36 = u_dot_by_q_of_u_2_35
        .mul_add(S::int(2), -u_dot_by_q_of_u_2_34);
    let u_dot_by_q_of_u_2_37 = u_dot_by_q_of_place_4 * u_dot_by_q_of_u_2_2;
    // u_dot_by_q_of_u_2_32*sin_q_pin2_sin_angle_inv + u_dot_by_q_of_u_2_36*u_dot_by_q_of_u_2_37
    let u_dot_by_q_of_u_2_38 = u_dot_by_q_of_u_2_36
        .mul_add(u_dot_by_q_of_u_2_37, u_dot_by_q_of_u_2_32 * sin_q_pin2_sin_angle_inv);
    // u_dot_by_q_of_u_2_8*u_dot_by_q_of_u_2_17 - u_dot_by_q_of_u_2_38
    let u_dot_by_q_of_u_2_39 = u_dot_by_q_of_u_2_8
        .mul_add(u_dot_by_q_of_u_2_17, -u_dot_by_q_of_u_2_38);
    let u_dot_by_q_of_u_2_40 = u_dot_by_q_of_u_2_2 * u_dot_by_q_of_place_20;
    let u_dot_by_q_of_u_2_41 = l_m_l * u_dot_by_q_of_u_2_40;
    let u_dot_by_q_of_place_21 = u_dot_by_q_of_place_8 * sin_q_pin2_sin_angle_inv;
    let l_u_dot_by_q_of_u_2 = l * u_dot_by_q_of_u_2;
    let l_u_dot_by_q_of_place_13 = l * u_dot_by_q_of_place_13;
    // u_dot_by_q_of_u_2_32*l_u_dot_by_q_of_place_13 - u_dot_by_q_of_u_2_27*l_u_dot_by_q_of_u_2
    let u_dot_by_q_of_u_2_42 = (-u_dot_by_q_of_u_2_27)
        .mul_add(l_u_dot_by_q_of_u_2, u_dot_by_q_of_u_2_32 * l_u_dot_by_q_of_place_13);
    // u_dot_by_q_of_u_2_42 - u_dot_by_q_of_u_2_11*l_u_dot_by_q_of_u_2
    let u_dot_by_q_of_u_2_43 = (-u_dot_by_q_of_u_2_11)
        .mul_add(l_u_dot_by_q_of_u_2, u_dot_by_q_of_u_2_42);
    let u_dot_by_q_of_u_2_44 = l_u_dot_by_q_of_u_2 * sin_q_pin2;
    let u_dot_by_q_of_u_2_45 = u_dot_by_q_of_place_13 * u_dot_by_q_of_u_2_44;
    let u_dot_by_q_of_u_2_46 = u_dot_by_q_of_u_2_18 * u_dot_by_q_of_u_2_45;
    let u_dot_by_q_of_u_2_47 = u_dot_by_q_of_place_4 * u_dot_by_q_of_u_2_46;
    let u_dot_by_q_of_place_22 = u_dot_by_q_of_place_8 * m_l;
    let u_dot_by_q_of_place_23 = S::int(6) * u_dot_by_q_of_place_22;
    let u_dot_by_q_of_u_2_48 = l_u_dot_by_q_of_u_2 * u_dot_by_q_of_u_2_44;
    let u_dot_by_q_of_u_2_49 = u_2_sin_angle_2_inv * u_dot_by_q_of_u_2_30;
    let l_u_dot_by_q_of_u_2_49 = l * u_dot_by_q_of_u_2_49;
    let u_dot_by_q_of_u_2_50 = l * l_u_dot_by_q_of_u_2_49 * cos_q_pin2;
    // 3*u_dot_by_q_of_u_2_48 + u_dot_by_q_of_u_2_50
    let u_dot_by_q_of_u_2_51 = u_dot_by_q_of_u_2_48
        .mul_add(S::int(3), u_dot_by_q_of_u_2_50);
    // l*u_dot_by_q_of_u_2_32 - u_dot_by_q_of_u_2_17*l_u_dot_by_q_of_u_2
    let u_dot_by_q_of_u_2_52 = (-u_dot_by_q_of_u_2_17)
        .mul_add(l_u_dot_by_q_of_u_2, l * u_dot_by_q_of_u_2_32);
    let l_u_dot_by_q_of_place_19 = l * u_dot_by_q_of_place_19;
    let u_dot_by_q_of_place_24 = l_u_dot_by_q_of_place_19 * cos_q_pin2;
    // u_dot_by_q_of_place_4*u_dot_by_q_of_place_19*u_dot_by_q_of_u_2_51 +
    //   u_dot_by_q_of_u_2_52*u_dot_by_q_of_place_24
    let u_dot_by_q_of_u_2_53 = u_dot_by_q_of_u_2_52
        .mul_add(
            u_dot_by_q_of_place_24,
            u_dot_by_q_of_place_4 * u_dot_by_q_of_place_19 * u_dot_by_q_of_u_2_51,
        );
    let m_times_6 = S::int(6) * m;
    let u_dot_by_q_of_place_25 = S::int(3) * u_dot_by_q_of_place_22;
    let u_dot_by_q_of_place_26 = u_dot_by_q_of_place_13 * u_dot_by_q_of_place_25;
    let l_u_dot_by_q_of_u_2_40 = l * u_dot_by_q_of_u_2_40;
    let u_dot_by_q_of_place_27 = sin_q_pin2_sin_angle_inv * u_dot_by_q_of_place_25;
    let g_times_18 = S::int(18) * g;
    let m_l_g_times_18 = m_l * g_times_18;
    // sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)
    let u_dot_by_q_of_place_28 = (-cos_q).mul_add(sin_q_ground1, sin_q * cos_q_ground1);
    // sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)
    let u_dot_by_q_of_place_29 = cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1);
    let u_dot_by_q_of_place_30 = u_dot_by_q_of_place_28 * cos_q_pin1;
    // 1/(u_dot_by_q_of_place_29*sin(q_pin1) + u_dot_by_q_of_place_30)
    let u_dot_by_q_of_place_31 = S::int(1)
        / u_dot_by_q_of_place_29.mul_add(sin_q_pin1, u_dot_by_q_of_place_30);
    let u_dot_by_q_of_place_32 = u_dot_by_q_of_place_28 * u_dot_by_q_of_place_31;
    let m_l_times_6 = S::int(6) * m_l;
    let u_dot_by_q_of_place_33 = g * u_dot_by_q_of_q_2_q_pin1_3 * u_dot_by_q_of_place_32
        * m_l_times_6;
    let u_dot_by_q_of_u_2_54 = l_m_l * u_dot_by_q_of_u_2_49;
    // u_dot_by_q_of_place_13*u_dot_by_q_of_u_2_54 - u_dot_by_q_of_u_2_l_m_l*u_dot_by_q_of_u_2_26
    let u_dot_by_q_of_u_2_55 = (-u_dot_by_q_of_u_2_l_m_l)
        .mul_add(u_dot_by_q_of_u_2_26, u_dot_by_q_of_place_13 * u_dot_by_q_of_u_2_54);
    // u_dot_by_q_of_u_2_2*(u_dot_by_q_of_u_2_35 - u_dot_by_q_of_u_2_34)
    let u_dot_by_q_of_u_2_56 = u_dot_by_q_of_u_2_2 * (u_dot_by_q_of_u_2_35 - u_dot_by_q_of_u_2_34);
    // sin_q_pin2_sin_angle_inv*u_dot_by_q_of_u_2_54 + l_m_l*u_dot_by_q_of_u_2_56
    let u_dot_by_q_of_u_2_57 = l_m_l
        .mul_add(u_dot_by_q_of_u_2_56, sin_q_pin2_sin_angle_inv * u_dot_by_q_of_u_2_54);
    let g_doubled = S::int(2) * g;
    // sin_q_pin2_sin_angle_inv*l_u_dot_by_q_of_u_2_49 + l*u_dot_by_q_of_u_2_56
    let u_dot_by_q_of_u_2_58 = l
        .mul_add(
            u_dot_by_q_of_u_2_56,
            sin_q_pin2_sin_angle_inv * l_u_dot_by_q_of_u_2_49,
        );
    // g_doubled*cos(q_ground2) + u_dot_by_q_of_u_2_58
    let u_dot_by_q_of_u_2_59 = g_doubled.mul_add(cos_q_ground2, u_dot_by_q_of_u_2_58);
    // u_dot_by_q_of_place_8*u_dot_by_q_of_u_2_57 + u_dot_by_q_of_place_25*u_dot_by_q_of_u_2_59
    let u_dot_by_q_of_u_2_60 = u_dot_by_q_of_place_25
        .mul_add(u_dot_by_q_of_u_2_59, u_dot_by_q_of_place_8 * u_dot_by_q_of_u_2_57);
    // u_dot_by_q_of_place_13*l_u_dot_by_q_of_u_2_49 - u_dot_by_q_of_u_2_26*l_u_dot_by_q_of_u_2
    let u_dot_by_q_of_u_2_61 = (-u_dot_by_q_of_u_2_26)
        .mul_add(l_u_dot_by_q_of_u_2, u_dot_by_q_of_place_13 * l_u_dot_by_q_of_u_2_49);
    // u_dot_by_q_of_place_9*g_doubled - u_dot_by_q_of_u_2_61
    let u_dot_by_q_of_u_2_62 = u_dot_by_q_of_place_9
        .mul_add(g_doubled, -u_dot_by_q_of_u_2_61);
    // 6*g*cos(q_ground1) - u_dot_by_q_of_place_13*u_dot_by_q_of_u_2_62
    let u_dot_by_q_of_u_2_63 = (-u_dot_by_q_of_place_13)
        .mul_add(u_dot_by_q_of_u_2_62, S::int(6) * g * cos_q_ground1);
    // u_dot_by_q_of_u_2_46 - u_dot_by_q_of_u_2_61*cos(q_pin2)
    let u_dot_by_q_of_u_2_64 = (-u_dot_by_q_of_u_2_61)
        .mul_add(cos_q_pin2, u_dot_by_q_of_u_2_46);
    // 5*l_u_dot_by_q_of_u_2_49 - 2*u_dot_by_q_of_u_2_64
    let u_dot_by_q_of_u_2_65 = (-u_dot_by_q_of_u_2_64)
        .mul_add(S::int(2), S::int(5) * l_u_dot_by_q_of_u_2_49);
    // u_dot_by_q_of_place_8*u_dot_by_q_of_u_2_54 + u_dot_by_q_of_place_25*u_dot_by_q_of_u_2_65
    let u_dot_by_q_of_u_2_66 = u_dot_by_q_of_place_25
        .mul_add(u_dot_by_q_of_u_2_65, u_dot_by_q_of_place_8 * u_dot_by_q_of_u_2_54);
    // u_dot_by_q_of_place_19*u_dot_by_q_of_u_2_55 + sin_q_pin2_sin_angle_inv*u_dot_by_q_of_u_2_60
    let u_dot_by_q_of_u_2_67 = sin_q_pin2_sin_angle_inv
        .mul_add(u_dot_by_q_of_u_2_60, u_dot_by_q_of_place_19 * u_dot_by_q_of_u_2_55);
    // u_dot_by_q_of_place_25*u_dot_by_q_of_u_2_63 + u_dot_by_q_of_u_2_66
    let u_dot_by_q_of_u_2_68 = u_dot_by_q_of_place_25
        .mul_add(u_dot_by_q_of_u_2_63, u_dot_by_q_of_u_2_66);
    // u_dot_by_q_of_u_2_67 + u_dot_by_q_of_u_2_68
    let u_dot_by_q_of_u_2_69 = u_dot_by_q_of_u_2_67 + u_dot_by_q_of_u_2_68;
    let u_dot_by_q_of_u_2_70 = u_dot_by_q_of_u_2_13 * u_dot_by_q_of_place_28;
    // u_dot_by_q_of_u_2_4*u_dot_by_q_of_place_29 - u_dot_by_q_of_u_2_70
    let u_dot_by_q_of_u_2_71 = u_dot_by_q_of_u_2_4
        .mul_add(u_dot_by_q_of_place_29, -u_dot_by_q_of_u_2_70);
    let u_dot_by_q_of_u_2_72 = u_2 * u_dot_by_q_of_place_31;
    let u_dot_by_q_of_u_2_73 = u_dot_by_q_of_place_31 * u_dot_by_q_of_u_2_72;
    // -u_dot_by_q_of_u_2_70
    let u_dot_by_q_of_u_2_74 = -u_dot_by_q_of_u_2_70;
    let u_dot_by_q_of_u_2_75 = u_dot_by_q_of_u_2_13 * u_dot_by_q_of_place_29;
    let u_dot_by_q_of_place_34 = u_dot_by_q_of_place_29 * cos_q_pin1;
    let u_dot_by_q_of_u_2_76 = u_dot_by_q_of_u_2 * u_dot_by_q_of_place_28;
    // u_dot_by_q_of_u_2_74*sin(q_pin1) + u_dot_by_q_of_u_2_75*cos(q_pin1) +
    //   u_dot_by_q_of_u_2_12*u_dot_by_q_of_place_34 - u_dot_by_q_of_place_14*u_dot_by_q_of_u_2_76
    let u_dot_by_q_of_u_2_77 = u_dot_by_q_of_u_2_75
        .mul_add(cos_q_pin1, u_dot_by_q_of_u_2_74 * sin_q_pin1)
        + u_dot_by_q_of_u_2_12 * u_dot_by_q_of_place_34
        - u_dot_by_q_of_place_14 * u_dot_by_q_of_u_2_76;
    // u_dot_by_q_of_place_34 - u_dot_by_q_of_place_28*sin(q_pin1)
    let u_dot_by_q_of_place_35 = (-u_dot_by_q_of_place_28)
        .mul_add(sin_q_pin1, u_dot_by_q_of_place_34);
    let u_dot_by_q_of_place_36 = S::int(2) * u_dot_by_q_of_place_32;
    // u_dot_by_q_of_place_35*(u_dot_by_q_of_u_2_75 - u_dot_by_q_of_u_2_77*u_dot_by_q_of_place_36)
    let u_dot_by_q_of_u_2_78 = u_dot_by_q_of_place_35
        * (-u_dot_by_q_of_u_2_77).mul_add(u_dot_by_q_of_place_36, u_dot_by_q_of_u_2_75);
    // u_dot_by_q_of_u_2_71*u_dot_by_q_of_u_2_72 -
    //   u_dot_by_q_of_u_2_73*(u_dot_by_q_of_place_29*u_dot_by_q_of_u_2_77 + u_dot_by_q_of_u_2_78)
    let u_dot_by_q_of_u_2_79 = -u_dot_by_q_of_u_2_73
        * u_dot_by_q_of_place_29.mul_add(u_dot_by_q_of_u_2_77, u_dot_by_q_of_u_2_78)
        + u_dot_by_q_of_u_2_71 * u_dot_by_q_of_u_2_72;
    // cos(q_pin1) - u_dot_by_q_of_place_16
    let u_dot_by_q_of_place_37 = cos_q_pin1 - u_dot_by_q_of_place_16;
    let u_dot_by_q_of_u_2_80 = u_2_sin_angle_2_inv * u_dot_by_q_of_place_37;
    let u_dot_by_q_of_u_2_81 = u_dot_by_q_of_place_28 * u_dot_by_q_of_u_2_80;
    // u_dot_by_q_of_place_14*(u_dot_by_q_of_u_2*u_dot_by_q_of_place_29 + u_dot_by_q_of_u_2_81)
    let u_dot_by_q_of_u_2_82 = u_dot_by_q_of_place_14
        * u_dot_by_q_of_u_2.mul_add(u_dot_by_q_of_place_29, u_dot_by_q_of_u_2_81);
    // sin(q_pin1)*(u_dot_by_q_of_u_2_4*u_dot_by_q_of_place_28 + u_dot_by_q_of_u_2_75) -
    //   u_dot_by_q_of_u_2_71*cos(q_pin1) + u_dot_by_q_of_u_2_16*u_dot_by_q_of_place_34 -
    //   u_dot_by_q_of_place_15*u_dot_by_q_of_u_2_76 + u_dot_by_q_of_u_2_82
    let u_dot_by_q_of_u_2_83 = sin_q_pin1
        * u_dot_by_q_of_u_2_4.mul_add(u_dot_by_q_of_place_28, u_dot_by_q_of_u_2_75)
        - u_dot_by_q_of_u_2_71 * cos_q_pin1 + u_dot_by_q_of_u_2_16 * u_dot_by_q_of_place_34
        - u_dot_by_q_of_place_15 * u_dot_by_q_of_u_2_76 + u_dot_by_q_of_u_2_82;
    let l_u_dot_by_q_of_place_32 = l * u_dot_by_q_of_place_32;
    let u_dot_by_q_of_u_2_84 = u_dot_by_q_of_u_2_72 * l_u_dot_by_q_of_place_32;
    // -l*u_dot_by_q_of_u_2_79 - u_dot_by_q_of_u_2_83*u_dot_by_q_of_u_2_84
    let u_dot_by_q_of_u_2_85 = (-u_dot_by_q_of_u_2_83)
        .mul_add(u_dot_by_q_of_u_2_84, -l * u_dot_by_q_of_u_2_79);
    let m_l_times_3 = S::int(3) * m_l;
    let u_dot_by_q_of_place_38 = u_dot_by_q_of_place_32 * m_l_times_3;
    let u_dot_by_q_of_place_39 = S::int(15) * u_dot_by_q_of_place_22;
    // u_dot_by_q_of_u_2_85*u_dot_by_q_of_place_38 + u_dot_by_q_of_u_2_52*u_dot_by_q_of_place_39
    let u_dot_by_q_of_u_2_86 = u_dot_by_q_of_u_2_52
        .mul_add(u_dot_by_q_of_place_39, u_dot_by_q_of_u_2_85 * u_dot_by_q_of_place_38);
    let u_dot_by_q_of_place_40 = l_m_l * u_dot_by_q_of_place_32;
    let u_dot_by_q_of_u_2_87 = u_dot_by_q_of_u_2_72 * u_dot_by_q_of_place_40;
    let u_2_sin_q_pin1 = u_2 * sin_q_pin1;
    let u_dot_by_q_of_u_2_88 = l_u_dot_by_q_of_place_32 * u_2_sin_q_pin1;
    // u + u_dot_by_q_of_u_2_12
    let u_dot_by_q_of_u_2_89 = u_2 + u_dot_by_q_of_u_2_12;
    let u_dot_by_q_of_place_41 = u_dot_by_q_of_place_32 * u_dot_by_q_of_place_35;
    // u_dot_by_q_of_place_29 - u_dot_by_q_of_place_41
    let u_dot_by_q_of_place_42 = u_dot_by_q_of_place_29 - u_dot_by_q_of_place_41;
    let l_u_dot_by_q_of_u_2_72 = l * u_dot_by_q_of_u_2_72;
    // u_dot_by_q_of_u_2_75 - u_dot_by_q_of_place_32*u_dot_by_q_of_u_2_77
    let u_dot_by_q_of_u_2_90 = (-u_dot_by_q_of_place_32)
        .mul_add(u_dot_by_q_of_u_2_77, u_dot_by_q_of_u_2_75);
    let u_dot_by_q_of_u_2_91 = l_m_l * u_dot_by_q_of_u_2_72 * u_dot_by_q_of_u_2_90;
    let u_dot_by_q_of_u_2_92 = l_u_dot_by_q_of_u_2_72 * u_dot_by_q_of_u_2_90;
    // u_dot_by_q_of_q_2_q_pin1*g_doubled + u_dot_by_q_of_u_2_92
    let u_dot_by_q_of_u_2_93 = u_dot_by_q_of_q_2_q_pin1
        .mul_add(g_doubled, u_dot_by_q_of_u_2_92);
    let l_m_l_doubled = S::int(2) * l_m_l;
    // u_dot_by_q_of_u_2_72*u_2_sin_q_pin1*l_m_l_doubled - m_l*u_dot_by_q_of_place_31*u_dot_by_q_of_u_2_93
    let u_dot_by_q_of_u_2_94 = (-(m_l * u_dot_by_q_of_place_31))
        .mul_add(
            u_dot_by_q_of_u_2_93,
            u_dot_by_q_of_u_2_72 * u_2_sin_q_pin1 * l_m_l_doubled,
        );
    // u_dot_by_q_of_place_31*u_dot_by_q_of_u_2_91 - 3*u_dot_by_q_of_u_2_94
    let u_dot_by_q_of_u_2_95 = (-u_dot_by_q_of_u_2_94)
        .mul_add(S::int(3), u_dot_by_q_of_place_31 * u_dot_by_q_of_u_2_91);
    // u_dot_by_q_of_place_8*(l_m_l*u_dot_by_q_of_u_2_32 - u_dot_by_q_of_u_2_l_m_l*u_dot_by_q_of_u_2_17) -
    //   u_dot_by_q_of_place_32*(l_m_l*u_dot_by_q_of_u_2_79 + u_dot_by_q_of_u_2_83*u_dot_by_q_of_u_2_87)
    let u_dot_by_q_of_u_2_96 = u_dot_by_q_of_place_8
        * (-u_dot_by_q_of_u_2_l_m_l)
            .mul_add(u_dot_by_q_of_u_2_17, l_m_l * u_dot_by_q_of_u_2_32)
        - u_dot_by_q_of_place_32
            * u_dot_by_q_of_u_2_83
                .mul_add(u_dot_by_q_of_u_2_87, l_m_l * u_dot_by_q_of_u_2_79);
    // m_l_times_6*(u_dot_by_q_of_u_2_85*cos(q_pin1) - u_dot_by_q_of_u_2_16*u_dot_by_q_of_u_2_88 +
    //   u_dot_by_q_of_u_2_89*u_dot_by_q_of_place_42*l_u_dot_by_q_of_u_2_72*sin(q_pin1)) +
    //   u_dot_by_q_of_place_42*u_dot_by_q_of_u_2_95
    let u_dot_by_q_of_u_2_97 = m_l_times_6
        * ((-u_dot_by_q_of_u_2_16)
            .mul_add(u_dot_by_q_of_u_2_88, u_dot_by_q_of_u_2_85 * cos_q_pin1)
            + u_dot_by_q_of_u_2_89 * u_dot_by_q_of_place_42 * l_u_dot_by_q_of_u_2_72
                * sin_q_pin1) + u_dot_by_q_of_place_42 * u_dot_by_q_of_u_2_95;
    // u_dot_by_q_of_place_4*u_dot_by_q_of_u_2_69 + u_dot_by_q_of_u_2_86
    let u_dot_by_q_of_u_2_98 = u_dot_by_q_of_place_4
        .mul_add(u_dot_by_q_of_u_2_69, u_dot_by_q_of_u_2_86);
    // u_dot_by_q_of_u_2_96 - u_dot_by_q_of_u_2_97
    let u_dot_by_q_of_u_2_99 = u_dot_by_q_of_u_2_96 - u_dot_by_q_of_u_2_97;
    // u_dot_by_q_of_u_2_98 + u_dot_by_q_of_u_2_99
    let u_dot_by_q_of_u_2_100 = u_dot_by_q_of_u_2_98 + u_dot_by_q_of_u_2_99;
    let cos_q_pin2_times_3 = S::int(3) * cos_q_pin2;
    // sin_q_pin2_sin_angle_inv*u_dot_by_q_of_place_21 + u_dot_by_q_of_place_19*cos_q_pin2_times_3
    let u_dot_by_q_of_place_43 = u_dot_by_q_of_place_19
        .mul_add(cos_q_pin2_times_3, sin_q_pin2_sin_angle_inv * u_dot_by_q_of_place_21);
    let u_dot_by_q_of_place_44 = u_dot_by_q_of_place_8 * l_m_l;
    // l_m_l*u_dot_by_q_of_place_19^2 + 4*u_dot_by_q_of_place_8*u_dot_by_q_of_place_44
    let u_dot_by_q_of_place_45 = (u_dot_by_q_of_place_8 * u_dot_by_q_of_place_44)
        .mul_add(S::int(4), l_m_l * u_dot_by_q_of_place_19 * u_dot_by_q_of_place_19);
    // u_dot_by_q_of_place_43*u_dot_by_q_of_place_44 + u_dot_by_q_of_place_45
    let u_dot_by_q_of_place_46 = u_dot_by_q_of_place_43
        .mul_add(u_dot_by_q_of_place_44, u_dot_by_q_of_place_45);
    let cos_q_pin1_times_3 = S::int(3) * cos_q_pin1;
    // 1/(4*l_m_l + u_dot_by_q_of_place_46 + u_dot_by_q_of_place_40*(u_dot_by_q_of_place_32 -
    //   cos_q_pin1_times_3))
    let u_dot_by_q_of_place_47 = S::int(1)
        / (u_dot_by_q_of_place_46 + S::int(4) * l_m_l
            + u_dot_by_q_of_place_40 * (u_dot_by_q_of_place_32 - cos_q_pin1_times_3));
    let u_dot_by_q_of_place_48 = S::ratio(1, 4) * u_dot_by_q_of_place_47;
    // u_dot_by_q_of_place_31*(cos_q_pin1_times_3 - u_dot_by_q_of_place_36)
    let u_dot_by_q_of_place_49 = u_dot_by_q_of_place_31
        * (cos_q_pin1_times_3 - u_dot_by_q_of_place_36);
    // u_dot_by_q_of_place_17*u_dot_by_q_of_place_46 + l_m_l*u_dot_by_q_of_place_42*u_dot_by_q_of_place_49
    let u_dot_by_q_of_place_50 = (l_m_l * u_dot_by_q_of_place_42)
        .mul_add(
            u_dot_by_q_of_place_49,
            u_dot_by_q_of_place_17 * u_dot_by_q_of_place_46,
        );
    // u_dot_by_q_of_u_2_48 + u_dot_by_q_of_u_2_50
    let u_dot_by_q_of_u_2_101 = u_dot_by_q_of_u_2_48 + u_dot_by_q_of_u_2_50;
    let u_dot_by_q_of_u_2_102 = l_u_dot_by_q_of_place_32 * u_dot_by_q_of_u_2_89;
    let u_2_times_6 = S::int(6) * u_2;
    let u_dot_by_q_of_u_2_103 = u_dot_by_q_of_place_40 * u_2_sin_q_pin1;
    // u_dot_by_q_of_place_47*u_dot_by_q_of_place_48*(m_l_g_times_18*cos(q) + u_dot_by_q_of_u_2_69 +
    //   u_dot_by_q_of_place_32*u_dot_by_q_of_u_2_91 + u_dot_by_q_of_place_38*u_dot_by_q_of_u_2_93 +
    //   u_dot_by_q_of_place_19*m_times_6*u_dot_by_q_of_u_2_101 +
    //   m_l_times_6*(u_2_sin_q_pin1*u_dot_by_q_of_u_2_102 - u_dot_by_q_of_u_2_92*cos(q_pin1)) -
    //   u_2_times_6*u_dot_by_q_of_u_2_103)
    let u_dot_by_q_of_u_2_104 = u_dot_by_q_of_place_47 * u_dot_by_q_of_place_48
        * (u_dot_by_q_of_u_2_69 + m_l_g_times_18 * cos_q
            + u_dot_by_q_of_place_32 * u_dot_by_q_of_u_2_91
            + u_dot_by_q_of_place_38 * u_dot_by_q_of_u_2_93
            + u_dot_by_q_of_place_19 * m_times_6 * u_dot_by_q_of_u_2_101
            + m_l_times_6
                * (-u_dot_by_q_of_u_2_92)
                    .mul_add(cos_q_pin1, u_2_sin_q_pin1 * u_dot_by_q_of_u_2_102)
            - u_2_times_6 * u_dot_by_q_of_u_2_103);
    // u_dot_by_q = (8*m*l^2*sin(q_pin1)^2/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) +
    //   3*m*l^2*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + 2*m*l^2*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   2*m*l^2*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))^2*(sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^3 +
    //   2*m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2*tan(q - q_ground1 + q_pin1)) + 2*m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))^2/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 +
    //   q_pin1)) + 6*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 +
    //   q_pin1)))*(6*m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) - 18*m*l*g*cos(q) -
    //   18*m*l*g*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - 6*m*l*g*cos(q +
    //   q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   6*m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) - 6*m*l*g*sin(q_pin1)*cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1) -
    //   6*m*l^2*u^2*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   15*m*l*sin(q_pin1)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) -
    //   sin(q_pin1)*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) -
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) -
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) - 3*m*l*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   (sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(m*l^2*u*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   3*m*l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1)
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) - sin(q_pin1)*(1 +
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   6*m*l*(l*u*sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   cos(q_pin1)*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)) -
    //   6*m*(l^2*u^2*sin(q_pin1)^3*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + l*sin(q_pin1)*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)))/(4*(4*m*l^2 + 4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 +
    //   q_pin1)^2 + 3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2)^2) +
    //   (18*m*l*g*sin(q) + 18*m*l*g*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) + 6*m*l*g*sin(q + q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + 6*m*l*g*cos(q +
    //   q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   6*m*l*g*cos(q + q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   6*m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) + 6*m*l*g*sin(q_pin1)*cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) + 6*m*l^2*u^2*sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   6*m*l^2*u^2*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   15*m*l*sin(q_pin1)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   sin(q_pin1)*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) - 3*m*l*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   3*m*l*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 -
    //   (sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(m*l^2*u*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   (sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))*(m*l^2*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   3*m*l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1)
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
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
    //   6*m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1
    //   + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)) + 15*m*l*sin(q_pin1)*(2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
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
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1) + sin(q_pin1)*(2*m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 +
    //   q_pin1)) + m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q)
    //   + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   2*m*l^2*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) + m*l^2*u*sin(q_pin1)*(u*sin(q_pin1)/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1) + 3*m*l*sin(q_pin1)*sin(q_pin2)*(2*l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   2*l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q - q_ground1 + q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u -
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   2*l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u -
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q -
    //   q_ground1 + q_pin1)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q - q_pin1)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))
    //   + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))
    //   + u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q - q_pin1)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1
    //   + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_pin1)*sin(q_pin2)*(2*m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2
    //   + q_pin2)) + 2*m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u -
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   2*m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u -
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q -
    //   q_ground1 + q_pin1)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    //   - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q - q_pin1)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - u*(sin(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q - q_pin1)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1
    //   + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + 3*m*l*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(l*u*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
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
    //   sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^3 + l*u*(u*sin(q)*cos(q_ground1) -
    //   u*cos(q)*sin(q_ground1) + u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(sin(q)*sin(q_ground1) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   6*m*l*(l*u*sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(u +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   l*u*sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1)
    //   - sin(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   l*u*sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1
    //   + q_pin1)) + u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   cos(q_pin1)*(l*u*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
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
    //   sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^3 + l*u*(u*sin(q)*cos(q_ground1) -
    //   u*cos(q)*sin(q_ground1) + u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(sin(q)*sin(q_ground1) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)) + (sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(m*l^2*u*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*u*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 + 2*m*l^2*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^3 + m*l^2*u*(u*sin(q)*cos(q_ground1) -
    //   u*cos(q)*sin(q_ground1) + u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(sin(q)*sin(q_ground1) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   3*m*l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   6*m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1
    //   + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) + l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1) + cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1) - 2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) -
    //   l*u^2*cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 - l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q -
    //   q_ground1 + q_pin1) - 2*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) -
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
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))))/sin(q - q_ground1 +
    //   q_pin1) + 6*m*(3*l^2*u^2*sin(q_pin1)^3*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/(sin(q - q_ground1 + q_pin1)^3*tan(q - q_ground1 + q_pin1)) +
    //   l*sin(q_pin1)*cos(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + l*sin(q_pin1)*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) +
    //   l*u^2*cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    //   - u - u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   2*l*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) + l*u*sin(q_pin1)*(u*sin(q_pin1)/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1)) + sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
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
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1))/(4*(4*m*l^2 +
    //   4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2))
    let u_dot_by_q = u_dot_by_q_of_place_48
        * (-u_dot_by_q_of_place_19
            * u_dot_by_q_of_u_2_11
                .mul_add(u_dot_by_q_of_u_2_l_m_l, -u_dot_by_q_of_u_2_33)
            + u_dot_by_q_of_u_2_53 * m_times_6
            - u_dot_by_q_of_place_21
                * u_dot_by_q_of_u_2_10
                    .mul_add(u_dot_by_q_of_u_2_41, l_m_l * u_dot_by_q_of_u_2_39)
            - u_dot_by_q_of_place_23
                * ((-u_dot_by_q_of_u_2_43)
                    .mul_add(cos_q_pin2, u_dot_by_q_of_u_2_5 * u_dot_by_q_of_u_2_45)
                    + u_dot_by_q_of_u_2_47) + u_dot_by_q_of_u_2_43 * u_dot_by_q_of_place_26
            - u_dot_by_q_of_place_27
                * u_dot_by_q_of_u_2_10
                    .mul_add(l_u_dot_by_q_of_u_2_40, l * u_dot_by_q_of_u_2_39)
            + m_l_g_times_18 * sin_q - u_dot_by_q_of_place_33 + u_dot_by_q_of_u_2_100)
        - u_dot_by_q_of_place_50 * u_dot_by_q_of_u_2_104;
    let u_dot_by_q_ground1_of_u_2 = u_dot_by_q_of_u_2_2 * u_dot_by_q_of_place_10;
    let u_dot_by_q_ground1_of_u_2_2 = u_dot_by_q_of_u_2_3 * cos_angle_sin_angle_inv;
    // u_dot_by_q_ground1_of_u_2 + u_dot_by_q_ground1_of_u_2_2
    let u_dot_by_q_ground1_of_u_2_3 = u_dot_by_q_ground1_of_u_2 + u_dot_by_q_ground1_of_u_2_2;
    // u_dot_by_q_of_u_2_5 - u_dot_by_q_ground1_of_u_2_3
    let u_dot_by_q_ground1_of_u_2_4 = u_dot_by_q_of_u_2_5 - u_dot_by_q_ground1_of_u_2_3;
    // u_dot_by_q_of_u_2_40 - u_dot_by_q_of_u_2_9
    let u_dot_by_q_ground1_of_u_2_5 = u_dot_by_q_of_u_2_40 - u_dot_by_q_of_u_2_9;
    let u_dot_by_q_ground1_of_u_2_6 = u_dot_by_q_of_place_7 * u_dot_by_q_of_u_2_8;
    // u_dot_by_q_ground1_of_u_2_4 + u_dot_by_q_ground1_of_u_2_5
    let u_dot_by_q_ground1_of_u_2_7 = u_dot_by_q_ground1_of_u_2_4 + u_dot_by_q_ground1_of_u_2_5;
    // u_dot_by_q_of_place_11*u_dot_by_q_of_u_2_24 + cos_angle_sin_angle_inv*(2*u_dot_by_q_of_u_2_25 -
    //   u_dot_by_q_of_u_2_23)
    let u_dot_by_q_ground1_of_u_2_8 = cos_angle_sin_angle_inv
        * u_dot_by_q_of_u_2_25.mul_add(S::int(2), -u_dot_by_q_of_u_2_23)
        + u_dot_by_q_of_place_11 * u_dot_by_q_of_u_2_24;
    let u_dot_by_q_ground1_of_u_2_9 = cos_angle_sin_angle_inv * u_dot_by_q_of_u_2_24;
    let u_dot_by_q_ground1_of_place = sin_angle_inv * u_dot_by_q_of_place_10;
    // u_dot_by_q_ground1_of_u_2_8 + u_dot_by_q_ground1_of_u_2_9*u_dot_by_q_ground1_of_place
    let u_dot_by_q_ground1_of_u_2_10 = u_dot_by_q_ground1_of_u_2_9
        .mul_add(u_dot_by_q_ground1_of_place, u_dot_by_q_ground1_of_u_2_8);
    // sin_angle_inv*(cos(q_ground2)*(u_dot_by_q_of_u_2_20 - u_dot_by_q_of_u_2_7 +
    //   u_dot_by_q_of_place_9*u_dot_by_q_ground1_of_u_2_4) - sin(q_ground2)*(u_dot_by_q_of_u_2_6 +
    //   u_dot_by_q_of_u_2_22 + u_dot_by_q_of_place_2*u_dot_by_q_ground1_of_u_2_4) -
    //   u_dot_by_q_of_place_10*u_dot_by_q_ground1_of_u_2_5 + u_dot_by_q_ground1_of_u_2_6) -
    //   u_dot_by_q_of_place_12*u_dot_by_q_ground1_of_u_2_7 + u_dot_by_q_ground1_of_u_2_10
    let u_dot_by_q_ground1_of_u_2_11 = sin_angle_inv
        * (cos_q_ground2
            * u_dot_by_q_of_place_9
                .mul_add(
                    u_dot_by_q_ground1_of_u_2_4,
                    u_dot_by_q_of_u_2_20 - u_dot_by_q_of_u_2_7,
                )
            - sin_q_ground2
                * u_dot_by_q_of_place_2
                    .mul_add(
                        u_dot_by_q_ground1_of_u_2_4,
                        u_dot_by_q_of_u_2_6 + u_dot_by_q_of_u_2_22,
                    ) - u_dot_by_q_of_place_10 * u_dot_by_q_ground1_of_u_2_5
            + u_dot_by_q_ground1_of_u_2_6) - u_dot_by_q_of_place_12 * u_dot_by_q_ground1_of_u_2_7
        + u_dot_by_q_ground1_of_u_2_10;
    // u_dot_by_q_of_place_12 + u_dot_by_q_ground1_of_place
    let u_dot_by_q_ground1_of_place_2 = u_dot_by_q_of_place_12 + u_dot_by_q_ground1_of_place;
    let u_dot_by_q_ground1_of_u_2_12 = u_dot_by_q_of_u_2_54 * u_dot_by_q_ground1_of_place_2;
    // u_dot_by_q_of_u_2_8*u_dot_by_q_of_u_2_24 - 2*cos_angle_sin_angle_inv*u_dot_by_q_of_u_2_56
    let u_dot_by_q_ground1_of_u_2_13 = (-(cos_angle_sin_angle_inv * u_dot_by_q_of_u_2_56))
        .mul_add(S::int(2), u_dot_by_q_of_u_2_8 * u_dot_by_q_of_u_2_24);
    let u_dot_by_q_ground1_of_place_3 = cos_angle_sin_angle_inv * sin_q_pin2_sin_angle_inv;
    let u_dot_by_q_ground1_of_u_2_14 = u_dot_by_q_of_u_2_2 * cos_q_pin2;
    // u_dot_by_q_of_u_2_49*u_dot_by_q_ground1_of_place_3 +
    //   u_dot_by_q_ground1_of_u_2*u_dot_by_q_ground1_of_u_2_14
    let u_dot_by_q_ground1_of_u_2_15 = u_dot_by_q_ground1_of_u_2
        .mul_add(
            u_dot_by_q_ground1_of_u_2_14,
            u_dot_by_q_of_u_2_49 * u_dot_by_q_ground1_of_place_3,
        );
    // u_dot_by_q_ground1_of_u_2_13 - u_dot_by_q_ground1_of_u_2_15
    let u_dot_by_q_ground1_of_u_2_16 = u_dot_by_q_ground1_of_u_2_13 - u_dot_by_q_ground1_of_u_2_15;
    // u_dot_by_q_of_u_2_39 - u_dot_by_q_ground1_of_u_2_16
    let u_dot_by_q_ground1_of_u_2_17 = u_dot_by_q_of_u_2_39 - u_dot_by_q_ground1_of_u_2_16;
    let u_dot_by_q_ground1_of_u_2_18 = l_u_dot_by_q_of_u_2_49 * u_dot_by_q_ground1_of_place_2;
    // u_dot_by_q_of_u_2_42 + l_u_dot_by_q_of_u_2*u_dot_by_q_ground1_of_u_2_11 -
    //   u_dot_by_q_ground1_of_u_2_18
    let u_dot_by_q_ground1_of_u_2_19 = l_u_dot_by_q_of_u_2
        .mul_add(u_dot_by_q_ground1_of_u_2_11, u_dot_by_q_of_u_2_42) - u_dot_by_q_ground1_of_u_2_18;
    let u_dot_by_q_ground1_of_u_2_20 = u_dot_by_q_of_u_2_18 * u_dot_by_q_of_u_2_44;
    let u_dot_by_q_ground1_of_u_2_21 = u_dot_by_q_ground1_of_place_2 * u_dot_by_q_ground1_of_u_2_20;
    let u_dot_by_q_ground1_of_u_2_22 = u_dot_by_q_of_place_8 * u_dot_by_q_of_u_2_101;
    let u_dot_by_q_ground1_of_u_2_23 = u_dot_by_q_ground1_of_place_2 * u_dot_by_q_ground1_of_u_2_22;
    // u_dot_by_q_of_place_8*u_dot_by_q_of_u_2_55 - u_dot_by_q_of_place_25*u_dot_by_q_of_u_2_62
    let u_dot_by_q_ground1_of_u_2_24 = (-u_dot_by_q_of_place_25)
        .mul_add(u_dot_by_q_of_u_2_62, u_dot_by_q_of_place_8 * u_dot_by_q_of_u_2_55);
    // u_dot_by_q_of_u_2_60*u_dot_by_q_ground1_of_place_3 +
    //   u_dot_by_q_ground1_of_place_2*u_dot_by_q_ground1_of_u_2_24
    let u_dot_by_q_ground1_of_u_2_25 = u_dot_by_q_ground1_of_place_2
        .mul_add(
            u_dot_by_q_ground1_of_u_2_24,
            u_dot_by_q_of_u_2_60 * u_dot_by_q_ground1_of_place_3,
        );
    let g_u_dot_by_q_of_place_23 = g * u_dot_by_q_of_place_23;
    let u_dot_by_q_ground1_of_place_4 = u_dot_by_q_of_place_2 * u_dot_by_q_of_place_13
        * g_u_dot_by_q_of_place_23;
    // 2*u_dot_by_q_of_place_19 + u_dot_by_q_of_place_8*cos_q_pin2_times_3
    let u_dot_by_q_ground1_of_place_5 = u_dot_by_q_of_place_8
        .mul_add(cos_q_pin2_times_3, S::int(2) * u_dot_by_q_of_place_19);
    let u_dot_by_q_ground1_of_place_6 = S::int(2) * u_dot_by_q_of_place_21;
    // u_dot_by_q_of_place_44*(u_dot_by_q_ground1_of_place_2*u_dot_by_q_ground1_of_place_5 +
    //   u_dot_by_q_ground1_of_place_3*u_dot_by_q_ground1_of_place_6)
    let u_dot_by_q_ground1_of_place_7 = u_dot_by_q_of_place_44
        * u_dot_by_q_ground1_of_place_3
            .mul_add(
                u_dot_by_q_ground1_of_place_6,
                u_dot_by_q_ground1_of_place_2 * u_dot_by_q_ground1_of_place_5,
            );
    // u_dot_by_q_ground1 = (8*m*l^2*sin(q_pin1)^2/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 +
    //   q_pin1)) + 3*m*l^2*cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + 2*m*l^2*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   2*m*l^2*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))^2*(sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^3 +
    //   2*m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2*tan(q - q_ground1 + q_pin1)) + 2*m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   2*m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) +
    //   6*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) -
    //   3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 - 2*m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2)*(18*m*l*g*cos(q) + 18*m*l*g*cos(q_ground1)*sin(q_pin1)/sin(q
    //   - q_ground1 + q_pin1) + 6*m*l*g*cos(q + q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   6*m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 6*m*l*g*sin(q_pin1)*cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1) +
    //   6*m*l^2*u^2*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   15*m*l*sin(q_pin1)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) +
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 3*m*l*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   (sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(m*l^2*u*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   3*m*l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1)
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(1 +
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   6*m*l*(l*u*sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   cos(q_pin1)*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)) -
    //   6*m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1
    //   + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) +
    //   6*m*(l^2*u^2*sin(q_pin1)^3*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + l*sin(q_pin1)*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)))/(4*(4*m*l^2 + 4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 +
    //   q_pin1)^2 + 3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2)^2) +
    //   (18*m*l*g*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   18*m*l*g*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   6*m*l*g*cos(q + q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) - 6*m*l*g*cos(q +
    //   q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 -
    //   6*m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) -
    //   6*m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) + 6*m*l*g*sin(q_pin1)*sin(q_ground1 +
    //   q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1) - 6*m*l*g*sin(q_pin1)*cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) + 6*m*l*g*sin(q_pin1)*cos(q_ground1 + q_pin2)*((sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1) -
    //   6*m*l^2*u^2*sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   6*m*l^2*u^2*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 -
    //   15*m*l*sin(q_pin1)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   sin(q_pin1)*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) -
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) -
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) + 3*m*l*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   3*m*l*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   (sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(m*l^2*u*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   (sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))*(m*l^2*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 -
    //   3*m*l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1)
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   3*m*l*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) - sin(q_pin1)*(1 +
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
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) - 6*m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)) - 15*m*l*sin(q_pin1)*(2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
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
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1) - sin(q_pin1)*(2*m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 +
    //   q_pin1)) + m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q)
    //   + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   2*m*l^2*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) + m*l^2*u*sin(q_pin1)*(u*sin(q_pin1)/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1) - 3*m*l*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(l*u*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
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
    //   sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^3 + l*u*(u*sin(q)*cos(q_ground1) -
    //   u*cos(q)*sin(q_ground1) + u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(sin(q)*sin(q_ground1) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   6*m*l*(l*u*sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(u +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   l*u*sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1)
    //   - sin(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   l*u*sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1
    //   + q_pin1)) + u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   cos(q_pin1)*(l*u*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
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
    //   sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^3 + l*u*(u*sin(q)*cos(q_ground1) -
    //   u*cos(q)*sin(q_ground1) + u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(sin(q)*sin(q_ground1) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)) - (sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(m*l^2*u*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*u*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 + 2*m*l^2*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^3 + m*l^2*u*(u*sin(q)*cos(q_ground1) -
    //   u*cos(q)*sin(q_ground1) + u*cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(sin(q)*sin(q_ground1) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(2*l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) + cos(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 -
    //   q_ground1 - q_pin2)) + 2*l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q - q_ground1 + q_pin1)) +
    //   2*l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q
    //   - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 2*l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u
    //   - u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q -
    //   q_ground1 + q_pin1)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    //   + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)) + 2*l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q
    //   - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q - q_pin1)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))
    //   + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - u*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))
    //   + u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q - q_pin1)) + u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) -
    //   sin(q_pin1)*sin(q_pin2)*(2*m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(sin(q) + sin(q + q_pin1)) +
    //   cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2
    //   + q_pin2)) + m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) +
    //   2*m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q - q_ground1 + q_pin1)) +
    //   2*m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u -
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   2*m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u -
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q -
    //   q_ground1 + q_pin1)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u - u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q - q_ground1 + q_pin1)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)) + 2*m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)^2) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q - q_pin1)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - u*(sin(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)) + cos(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) + u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q - q_pin1)) + u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) - 3*m*l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) +
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
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) - sin(q_pin1)*(1 +
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
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   6*m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) -
    //   l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) - l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   cos(q_pin2)*(2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) +
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
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*…/(sin(q - … + …)*…*tan(…)) -
    //   …*…*…/(…*…*tan(…)) - …*…*…/(…*…))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) + …/…)/sin(q - q_ground1 + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1) - 6*…*…)/(4*(4*m*l^2 + 4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 + q_pin1)^2 +
    //   3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2))
    let u_dot_by_q_ground1 = u_dot_by_q_of_place_48
        * (-u_dot_by_q_of_u_2_100 + u_dot_by_q_of_place_22 * g_times_18 * sin_q_ground1
            - u_dot_by_q_of_place_19
                * (u_dot_by_q_of_u_2_l_m_l
                    .mul_add(u_dot_by_q_ground1_of_u_2_11, u_dot_by_q_of_u_2_33)
                    - u_dot_by_q_ground1_of_u_2_12)
            + u_dot_by_q_of_place_21
                * l_m_l
                    .mul_add(
                        u_dot_by_q_ground1_of_u_2_17,
                        u_dot_by_q_of_u_2_41 * u_dot_by_q_ground1_of_u_2_7,
                    )
            + u_dot_by_q_of_place_27
                * l
                    .mul_add(
                        u_dot_by_q_ground1_of_u_2_17,
                        l_u_dot_by_q_of_u_2_40 * u_dot_by_q_ground1_of_u_2_7,
                    ) - u_dot_by_q_of_place_26 * u_dot_by_q_ground1_of_u_2_19
            - u_dot_by_q_of_place_23
                * (u_dot_by_q_ground1_of_u_2_19
                    .mul_add(cos_q_pin2, -u_dot_by_q_of_u_2_47)
                    - u_dot_by_q_of_u_2_45 * u_dot_by_q_ground1_of_u_2_4
                    + u_dot_by_q_ground1_of_u_2_21)
            - m_times_6 * (u_dot_by_q_of_u_2_53 - u_dot_by_q_ground1_of_u_2_23)
            + u_dot_by_q_ground1_of_u_2_25 + u_dot_by_q_ground1_of_place_4)
        + u_dot_by_q_of_u_2_104 * (u_dot_by_q_of_place_50 - u_dot_by_q_ground1_of_place_7);
    // u_dot_by_q_of_place_2*sin(q_ground2) - u_dot_by_q_of_place_9*cos(q_ground2)
    let u_dot_by_q_ground2_of_place = (-u_dot_by_q_of_place_9)
        .mul_add(cos_q_ground2, u_dot_by_q_of_place_2 * sin_q_ground2);
    // u_dot_by_q_of_u_2_40 - u_dot_by_q_ground1_of_u_2_3
    let u_dot_by_q_ground2_of_u_2 = u_dot_by_q_of_u_2_40 - u_dot_by_q_ground1_of_u_2_3;
    // u_dot_by_q_ground1_of_u_2_10 + sin_angle_inv*(u_dot_by_q_of_u_2_20*cos(q_ground2) -
    //   u_dot_by_q_of_u_2_22*sin(q_ground2) - u_dot_by_q_of_place_10*u_dot_by_q_of_u_2_40 +
    //   u_dot_by_q_ground1_of_u_2_6 + u_dot_by_q_ground1_of_u_2_3*u_dot_by_q_ground2_of_place) -
    //   u_dot_by_q_of_place_12*u_dot_by_q_ground2_of_u_2
    let u_dot_by_q_ground2_of_u_2_2 = u_dot_by_q_ground1_of_u_2_10
        + sin_angle_inv
            * ((-u_dot_by_q_of_u_2_22)
                .mul_add(sin_q_ground2, u_dot_by_q_of_u_2_20 * cos_q_ground2)
                - u_dot_by_q_of_place_10 * u_dot_by_q_of_u_2_40 + u_dot_by_q_ground1_of_u_2_6
                + u_dot_by_q_ground1_of_u_2_3 * u_dot_by_q_ground2_of_place)
        - u_dot_by_q_of_place_12 * u_dot_by_q_ground2_of_u_2;
    // u_dot_by_q_ground1_of_u_2_18 - l_u_dot_by_q_of_u_2*u_dot_by_q_ground2_of_u_2_2
    let u_dot_by_q_ground2_of_u_2_3 = (-l_u_dot_by_q_of_u_2)
        .mul_add(u_dot_by_q_ground2_of_u_2_2, u_dot_by_q_ground1_of_u_2_18);
    // u_dot_by_q_ground2 = (2*m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + 2*m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2)*(18*m*l*g*cos(q) + 18*m*l*g*cos(q_ground1)*sin(q_pin1)/sin(q
    //   - q_ground1 + q_pin1) + 6*m*l*g*cos(q + q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   6*m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 6*m*l*g*sin(q_pin1)*cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1) +
    //   6*m*l^2*u^2*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   15*m*l*sin(q_pin1)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) +
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 3*m*l*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   (sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(m*l^2*u*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   3*m*l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1)
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(1 +
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   6*m*l*(l*u*sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   cos(q_pin1)*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)) -
    //   6*m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1
    //   + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) +
    //   6*m*(l^2*u^2*sin(q_pin1)^3*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + l*sin(q_pin1)*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)))/(4*(4*m*l^2 + 4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 +
    //   q_pin1)^2 + 3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2)^2) +
    //   (6*m*l*g*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) - 6*m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   6*m*l*g*sin(q_pin1)*cos(q_ground1 + q_pin2)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1) -
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   3*m*l*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1)
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) -
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   2*l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)*tan(q_ground1 - q_ground2 +
    //   q_pin2)) + l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)) + 2*l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)^2) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) -
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   2*m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)*tan(q_ground1 - q_ground2 +
    //   q_pin2)) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)) + 2*m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)^2) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) - 3*m*l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
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
    //   q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 -
    //   q_ground1 - q_pin2)) + (u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q -
    //   q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) - sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*((sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 +
    //   m*l^2*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
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
    //   q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 -
    //   q_ground1 - q_pin2)) + (u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q -
    //   q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   6*m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 -
    //   q_ground1 - q_pin2)) + (u*sin(q_ground2)*sin(q_pin1)*sin(q_pin2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) -
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
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q -
    //   q_ground1 + q_pin1) - l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) -
    //   6*m*(l^2*u^2*sin(q_pin1)^3*sin(q_pin2)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) + cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + l*sin(q_pin1)*cos(q_pin2)*((sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)))/(sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   (sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) + cos(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)))/(4*(4*m*l^2 + 4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 +
    //   q_pin1)^2 + 3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2))
    let u_dot_by_q_ground2 = u_dot_by_q_of_place_48
        * (sin_q_pin2_sin_angle_inv * g_u_dot_by_q_of_place_23 * sin_q_ground2
            - m_times_6 * u_dot_by_q_ground1_of_u_2_23 - u_dot_by_q_ground1_of_u_2_25
            - u_dot_by_q_of_place_21
                * (-l_m_l)
                    .mul_add(
                        u_dot_by_q_ground1_of_u_2_16,
                        u_dot_by_q_of_u_2_41 * u_dot_by_q_ground2_of_u_2,
                    )
            - u_dot_by_q_of_place_27
                * (-l)
                    .mul_add(
                        u_dot_by_q_ground1_of_u_2_16,
                        l_u_dot_by_q_of_u_2_40 * u_dot_by_q_ground2_of_u_2,
                    )
            - u_dot_by_q_of_place_19
                * (-u_dot_by_q_of_u_2_l_m_l)
                    .mul_add(u_dot_by_q_ground2_of_u_2_2, u_dot_by_q_ground1_of_u_2_12)
            - u_dot_by_q_of_place_26 * u_dot_by_q_ground2_of_u_2_3
            - u_dot_by_q_of_place_23
                * ((-u_dot_by_q_of_u_2_45)
                    .mul_add(
                        u_dot_by_q_ground1_of_u_2_3,
                        u_dot_by_q_ground2_of_u_2_3 * cos_q_pin2,
                    ) - u_dot_by_q_ground1_of_u_2_21))
        + u_dot_by_q_of_u_2_104 * u_dot_by_q_ground1_of_place_7;
    // u_dot_by_q_of_q_2_q_pin1*cos(q_ground1) - u_dot_by_q_of_q_2_q_pin1_3*sin(q_ground1)
    let u_dot_by_q_pin1_of_place = (-u_dot_by_q_of_q_2_q_pin1_3)
        .mul_add(sin_q_ground1, u_dot_by_q_of_q_2_q_pin1 * cos_q_ground1);
    // u_2_sin_angle_2_inv*u_dot_by_q_pin1_of_place - u_dot_by_q_of_u_2_15
    let u_dot_by_q_pin1_of_u_2 = u_2_sin_angle_2_inv
        .mul_add(u_dot_by_q_pin1_of_place, -u_dot_by_q_of_u_2_15);
    // u_dot_by_q_of_u_2_12 + u_dot_by_q_of_place_4*(u_dot_by_q_pin1_of_u_2 - u_dot_by_q_of_u_2_80)
    let u_dot_by_q_pin1_of_u_2_2 = u_dot_by_q_of_u_2_12
        + u_dot_by_q_of_place_4 * (u_dot_by_q_pin1_of_u_2 - u_dot_by_q_of_u_2_80);
    // u_dot_by_q_of_u_2_14 - u_dot_by_q_pin1_of_u_2_2
    let u_dot_by_q_pin1_of_u_2_3 = u_dot_by_q_of_u_2_14 - u_dot_by_q_pin1_of_u_2_2;
    let u_dot_by_q_pin1_of_u_2_4 = u_dot_by_q_of_place_4 * u_dot_by_q_of_u_2_14;
    // u_dot_by_q_of_u_2_28*u_dot_by_q_pin1_of_place - u_dot_by_q_of_u_2_31
    let u_dot_by_q_pin1_of_u_2_5 = u_dot_by_q_of_u_2_28
        .mul_add(u_dot_by_q_pin1_of_place, -u_dot_by_q_of_u_2_31);
    // u_2_sin_angle_2_inv*(u_dot_by_q_pin1_of_u_2_4*cos(q_pin1) - u_dot_by_q_pin1_of_u_2_5)
    let u_dot_by_q_pin1_of_u_2_6 = u_2_sin_angle_2_inv
        * u_dot_by_q_pin1_of_u_2_4.mul_add(cos_q_pin1, -u_dot_by_q_pin1_of_u_2_5);
    // -u_dot_by_q_of_place_29*u_dot_by_q_of_u_2_80
    let u_dot_by_q_pin1_of_u_2_7 = -u_dot_by_q_of_place_29 * u_dot_by_q_of_u_2_80;
    // u_dot_by_q_of_u_2_73*u_dot_by_q_of_u_2_78 - u_dot_by_q_of_u_2_72*u_dot_by_q_pin1_of_u_2_7
    let u_dot_by_q_pin1_of_u_2_8 = (-u_dot_by_q_of_u_2_72)
        .mul_add(u_dot_by_q_pin1_of_u_2_7, u_dot_by_q_of_u_2_73 * u_dot_by_q_of_u_2_78);
    // -u_dot_by_q_of_u_2_81
    let u_dot_by_q_pin1_of_u_2_9 = -u_dot_by_q_of_u_2_81;
    // u_dot_by_q_of_place_34*u_dot_by_q_pin1_of_u_2 - u_dot_by_q_of_u_2_82 -
    //   u_dot_by_q_of_u_2_76*u_dot_by_q_pin1_of_place + cos(q_pin1)*(u_dot_by_q_of_u_2_74 +
    //   u_dot_by_q_pin1_of_u_2_7) - sin(q_pin1)*(u_dot_by_q_of_u_2_75 + u_dot_by_q_pin1_of_u_2_9)
    let u_dot_by_q_pin1_of_u_2_10 = -u_dot_by_q_of_u_2_82
        + u_dot_by_q_of_place_34 * u_dot_by_q_pin1_of_u_2
        - u_dot_by_q_of_u_2_76 * u_dot_by_q_pin1_of_place
        + cos_q_pin1 * (u_dot_by_q_of_u_2_74 + u_dot_by_q_pin1_of_u_2_7)
        - sin_q_pin1 * (u_dot_by_q_of_u_2_75 + u_dot_by_q_pin1_of_u_2_9);
    // u_dot_by_q_of_u_2_26*u_dot_by_q_of_u_2_80 + u_dot_by_q_of_place_13*u_dot_by_q_pin1_of_u_2_6
    let u_dot_by_q_pin1_of_u_2_11 = u_dot_by_q_of_place_13
        .mul_add(u_dot_by_q_pin1_of_u_2_6, u_dot_by_q_of_u_2_26 * u_dot_by_q_of_u_2_80);
    let u_dot_by_q_pin1_of_u_2_12 = u_dot_by_q_of_place_13 * u_dot_by_q_of_u_2_80;
    // -u_dot_by_q_pin1_of_u_2_12
    let u_dot_by_q_pin1_of_u_2_13 = -u_dot_by_q_pin1_of_u_2_12;
    let u_dot_by_q_pin1_of_u_2_14 = sin_q_pin2_sin_angle_inv * u_dot_by_q_of_u_2_80;
    // u_dot_by_q_pin1_of_u_2_14 - u_dot_by_q_pin1_of_u_2_12
    let u_dot_by_q_pin1_of_u_2_15 = u_dot_by_q_pin1_of_u_2_14 - u_dot_by_q_pin1_of_u_2_12;
    // sin_angle_inv*(sin(q_ground2)*(u_dot_by_q_of_place_2*u_dot_by_q_pin1_of_u_2_13 -
    //   u_dot_by_q_of_u_2_80*sin(q_ground1)) - cos(q_ground2)*(u_dot_by_q_of_u_2_80*cos(q_ground1) +
    //   u_dot_by_q_of_place_9*u_dot_by_q_pin1_of_u_2_13) + u_dot_by_q_of_place_10*u_dot_by_q_pin1_of_u_2_14)
    //   + u_dot_by_q_of_place_12*u_dot_by_q_pin1_of_u_2_15
    let u_dot_by_q_pin1_of_u_2_16 = sin_angle_inv
        * (sin_q_ground2
            * (-u_dot_by_q_of_u_2_80)
                .mul_add(
                    sin_q_ground1,
                    u_dot_by_q_of_place_2 * u_dot_by_q_pin1_of_u_2_13,
                )
            - cos_q_ground2
                * u_dot_by_q_of_place_9
                    .mul_add(
                        u_dot_by_q_pin1_of_u_2_13,
                        u_dot_by_q_of_u_2_80 * cos_q_ground1,
                    ) + u_dot_by_q_of_place_10 * u_dot_by_q_pin1_of_u_2_14)
        + u_dot_by_q_of_place_12 * u_dot_by_q_pin1_of_u_2_15;
    // u_dot_by_q_of_place_13*u_dot_by_q_pin1_of_u_2_3 + u_dot_by_q_pin1_of_u_2_16
    let u_dot_by_q_pin1_of_u_2_17 = u_dot_by_q_of_place_13
        .mul_add(u_dot_by_q_pin1_of_u_2_3, u_dot_by_q_pin1_of_u_2_16);
    let u_dot_by_q_pin1_of_u_2_18 = sin_angle_inv * u_dot_by_q_of_u_2_36;
    // u_dot_by_q_of_u_2_80*u_dot_by_q_pin1_of_u_2_18 - sin_q_pin2_sin_angle_inv*u_dot_by_q_pin1_of_u_2_6
    let u_dot_by_q_pin1_of_u_2_19 = (-sin_q_pin2_sin_angle_inv)
        .mul_add(
            u_dot_by_q_pin1_of_u_2_6,
            u_dot_by_q_of_u_2_80 * u_dot_by_q_pin1_of_u_2_18,
        );
    // u_dot_by_q_of_u_2_8*u_dot_by_q_pin1_of_u_2_3 + u_dot_by_q_pin1_of_u_2_19
    let u_dot_by_q_pin1_of_u_2_20 = u_dot_by_q_of_u_2_8
        .mul_add(u_dot_by_q_pin1_of_u_2_3, u_dot_by_q_pin1_of_u_2_19);
    // l*u_dot_by_q_pin1_of_u_2_11 - l_u_dot_by_q_of_u_2*u_dot_by_q_pin1_of_u_2_17
    let u_dot_by_q_pin1_of_u_2_21 = (-l_u_dot_by_q_of_u_2)
        .mul_add(u_dot_by_q_pin1_of_u_2_17, l * u_dot_by_q_pin1_of_u_2_11);
    let u_dot_by_q_pin1_of_u_2_22 = u_dot_by_q_of_u_2_18 * sin_q_pin2;
    let u_dot_by_q_pin1_of_place_2 = sin_angle_2_inv * u_dot_by_q_of_place_37;
    // l*u_dot_by_q_pin1_of_u_2_6 - l_u_dot_by_q_of_u_2*u_dot_by_q_pin1_of_u_2_3
    let u_dot_by_q_pin1_of_u_2_23 = (-l_u_dot_by_q_of_u_2)
        .mul_add(u_dot_by_q_pin1_of_u_2_3, l * u_dot_by_q_pin1_of_u_2_6);
    // l*u_dot_by_q_pin1_of_u_2_8 + u_dot_by_q_of_u_2_84*u_dot_by_q_pin1_of_u_2_10
    let u_dot_by_q_pin1_of_u_2_24 = u_dot_by_q_of_u_2_84
        .mul_add(u_dot_by_q_pin1_of_u_2_10, l * u_dot_by_q_pin1_of_u_2_8);
    let u_2_cos_q_pin1 = u_2 * cos_q_pin1;
    let u_dot_by_q_pin1_of_u_2_25 = u_dot_by_q_of_u_2_102 * sin_q_pin1;
    // sin_q_pin2_sin_angle_inv*u_dot_by_q_of_u_2_59 + u_dot_by_q_of_u_2_63
    let u_dot_by_q_pin1_of_u_2_26 = sin_q_pin2_sin_angle_inv
        .mul_add(u_dot_by_q_of_u_2_59, u_dot_by_q_of_u_2_63);
    // u_dot_by_q_of_u_2_54 + u_dot_by_q_of_place_13*u_dot_by_q_of_u_2_55
    let u_dot_by_q_pin1_of_u_2_27 = u_dot_by_q_of_place_13
        .mul_add(u_dot_by_q_of_u_2_55, u_dot_by_q_of_u_2_54);
    // sin_q_pin2_sin_angle_inv*u_dot_by_q_of_u_2_57 + m_l_times_3*(u_dot_by_q_of_u_2_65 +
    //   u_dot_by_q_pin1_of_u_2_26)
    let u_dot_by_q_pin1_of_u_2_28 = m_l_times_3 * (u_dot_by_q_of_u_2_65 + u_dot_by_q_pin1_of_u_2_26)
        + sin_q_pin2_sin_angle_inv * u_dot_by_q_of_u_2_57;
    // u_dot_by_q_pin1 = (8*m*l^2*sin(q_pin1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1)^2 -
    //   8*m*l^2*sin(q_pin1)^2/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) -
    //   3*m*l^2*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 -
    //   2*m*l^2*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))^2*(sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^3 +
    //   2*m*l^2*sin(q_pin1)*cos(q_pin1)*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)^2) - 2*m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q - q_ground1 + q_pin1)) +
    //   2*m*l^2*sin(q_pin1)*cos(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 - 2*m*l^2*sin(q_pin1)^2*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))^2/(sin(q - q_ground1 +
    //   q_pin1)^2*tan(q - q_ground1 + q_pin1)) + 6*m*l^2*sin(q_pin1)*cos(q_pin1)*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 -
    //   6*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)))*(18*m*l*g*cos(q) +
    //   18*m*l*g*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + 6*m*l*g*cos(q +
    //   q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   6*m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 6*m*l*g*sin(q_pin1)*cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1) +
    //   6*m*l^2*u^2*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   15*m*l*sin(q_pin1)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) +
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 3*m*l*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   (sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(m*l^2*u*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   3*m*l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1)
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(1 +
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   6*m*l*(l*u*sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   cos(q_pin1)*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)) -
    //   6*m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1
    //   + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) +
    //   6*m*(l^2*u^2*sin(q_pin1)^3*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + l*sin(q_pin1)*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)))/(4*(4*m*l^2 + 4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 +
    //   q_pin1)^2 + 3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2)^2) +
    //   (18*m*l*g*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   18*m*l*g*cos(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + 6*m*l*g*sin(q +
    //   q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   6*m*l*g*cos(q + q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 -
    //   6*m*l*g*cos(q_ground2)*cos(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 6*m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) -
    //   6*m*l*g*cos(q_pin1)*cos(q_ground1 + q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1) + 6*m*l*g*sin(q_pin1)*cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) + 6*m*l^2*u^2*cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   6*m*l^2*u^2*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 -
    //   15*m*l*cos(q_pin1)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   15*m*l*sin(q_pin1)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   cos(q_pin1)*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   3*m*l*cos(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) -
    //   cos(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) +
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) + 3*m*l*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(l*u*(u*sin(q)*sin(q_ground1) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   (sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)))*(m*l^2*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   3*m*l*cos(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) + 3*m*l*sin(q_pin1)*(1
    //   + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1)
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
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
    //   6*m*l*cos(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1
    //   + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) +
    //   6*m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1
    //   + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)) + 15*m*l*sin(q_pin1)*(l*u^2*sin(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
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
    //   q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*(m*l^2*u^2*sin(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 +
    //   2*m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q -
    //   q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u -
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) + 2*m*l^2*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)^2) + m*l^2*u*cos(q_pin1)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - u*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 2*l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q - q_ground1 + q_pin1)) + l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*sin(q +
    //   q_pin1) + cos(q_ground1)*cos(q + q_pin1))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)) + 2*l*u^2*sin(q_pin1)*cos(q_pin1)*cos(q_pin2)*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) +
    //   2*l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q - q_ground1 + q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u -
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   2*l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u -
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q -
    //   q_ground1 + q_pin1)^2) + l*u*cos(q_pin1)*sin(q_pin2)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    //   + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q -
    //   q_ground1 + q_pin1)) + l*u*cos(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q - q_pin1)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))
    //   - u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - u*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 +
    //   q_pin1)) + l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1
    //   + q_pin1)) - u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*sin(q_pin2)/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*sin(q_pin2)/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   u*cos(q_pin1)*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q
    //   - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*sin(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 2*m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q +
    //   q_pin1))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   2*m*l^2*u^2*sin(q_pin1)*cos(q_pin1)*cos(q_pin2)*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 +
    //   q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) +
    //   2*m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q - q_ground1 + q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u -
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   2*m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u -
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q -
    //   q_ground1 + q_pin1)^2) + m*l^2*u*cos(q_pin1)*sin(q_pin2)*(u - u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q - q_ground1 + q_pin1)) + m*l^2*u*cos(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q - q_pin1)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)) - u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1))
    //   - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)) - u*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 +
    //   q_pin1)) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) - u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*sin(q_pin2)/(sin(q
    //   - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*sin(q_pin2)/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   u*cos(q_pin1)*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q
    //   - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + 3*m*l*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(l*u*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   2*l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*sin(q_ground1) +
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
    //   l*u*(u*sin(q)*sin(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   u*cos(q)*cos(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(sin(q)*sin(q_ground1) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   6*m*l*(l*u*cos(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   l*u*sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1)
    //   - sin(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 -
    //   sin(q_pin1)*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) +
    //   l*u*sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1
    //   + q_pin1)) + u*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   cos(q_pin1)*(l*u*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   2*l*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*sin(q_ground1) +
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
    //   l*u*(u*sin(q)*sin(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   u*cos(q)*cos(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(sin(q)*sin(q_ground1) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)) + (sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(m*l^2*u*(sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)))*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   2*m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*sin(q_ground1) +
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
    //   m*l^2*u*(u*sin(q)*sin(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   u*cos(q)*cos(q_ground1)*cos(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 +
    //   q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*u*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(sin(q)*sin(q_ground1) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   3*m*l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*sin(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   6*m*l*sin(q_pin1)*(l*u*cos(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1
    //   + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) -
    //   l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1)) - l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + u*cos(q_pin1)*(cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)) - sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q - q_ground1 + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1) - cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1) - l*u^2*sin(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 - 2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))/(sin(q - q_ground1 + q_pin1)^2*tan(q - q_ground1 + q_pin1)) -
    //   l*u^2*cos(q_pin1)*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2 -
    //   l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1
    //   + q_pin1) - 2*l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) - l*u*cos(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) +
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
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/(sin(q - q_ground1 +
    //   q_pin1)*tan(q - q_ground1 + q_pin1)) - u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - u*(sin(q_ground1)*sin(q + q_pin1) +
    //   cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q -
    //   q_ground1 + q_pin1))))/sin(q - q_ground1 + q_pin1) + 6*m*(3*l^2*u^2*sin(q_pin1)^3*sin(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/(sin(q - q_ground1 + q_pin1)^3*tan(q
    //   - q_ground1 + q_pin1)) - 3*l^2*u^2*sin(q_pin1)^2*cos(q_pin1)*sin(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^3 -
    //   l*cos(q_pin1)*cos(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + l*sin(q_pin1)*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + l*sin(q_pin1)*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*sin(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + 2*l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*tan(q -
    //   q_ground1 + q_pin1)) + l*u^2*cos(q_pin1)*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q +
    //   q_pin1))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    //   - u - u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   2*l*u*sin(q_pin1)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) - u - u*(sin(q_ground1)*(cos(q) + cos(q
    //   + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)^2) + l*u*cos(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   l*u*sin(q_pin1)*(u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) -
    //   u*cos(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    //   - u*(sin(q_ground1)*sin(q + q_pin1) + cos(q_ground1)*cos(q + q_pin1))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1)) +
    //   sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
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
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1))/(4*(4*m*l^2 +
    //   4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2))
    let u_dot_by_q_pin1 = u_dot_by_q_of_u_2_104
        * (u_dot_by_q_of_place_40
            * u_dot_by_q_of_place_35
                .mul_add(u_dot_by_q_of_place_49, S::int(3) * sin_q_pin1)
            + u_dot_by_q_pin1_of_place_2
                * (l_m_l_doubled
                    * u_dot_by_q_of_place_13
                        .mul_add(u_dot_by_q_of_place_19, u_dot_by_q_of_place_43)
                    + S::int(8) * u_dot_by_q_of_place_44))
        + u_dot_by_q_of_place_48
            * (-u_dot_by_q_of_place_33 + u_dot_by_q_of_place_41 * u_dot_by_q_of_u_2_95
                - u_dot_by_q_of_place_8
                    * (-l_m_l)
                        .mul_add(
                            u_dot_by_q_pin1_of_u_2_6,
                            u_dot_by_q_of_u_2_l_m_l * u_dot_by_q_pin1_of_u_2_3,
                        )
                + u_dot_by_q_of_place_32
                    * u_dot_by_q_of_u_2_87
                        .mul_add(
                            u_dot_by_q_pin1_of_u_2_10,
                            l_m_l * u_dot_by_q_pin1_of_u_2_8,
                        )
                - u_dot_by_q_of_place_19
                    * (-l_m_l)
                        .mul_add(
                            u_dot_by_q_pin1_of_u_2_11,
                            u_dot_by_q_of_u_2_l_m_l * u_dot_by_q_pin1_of_u_2_17,
                        )
                - u_dot_by_q_of_place_21
                    * l_m_l
                        .mul_add(
                            u_dot_by_q_pin1_of_u_2_20,
                            u_dot_by_q_of_u_2_41 * u_dot_by_q_pin1_of_u_2_15,
                        )
                - u_dot_by_q_of_place_27
                    * l
                        .mul_add(
                            u_dot_by_q_pin1_of_u_2_20,
                            l_u_dot_by_q_of_u_2_40 * u_dot_by_q_pin1_of_u_2_15,
                        ) + u_dot_by_q_of_place_26 * u_dot_by_q_pin1_of_u_2_21
                - u_dot_by_q_of_place_23
                    * ((-u_dot_by_q_pin1_of_u_2_21)
                        .mul_add(
                            cos_q_pin2,
                            u_dot_by_q_of_u_2_45 * u_dot_by_q_pin1_of_u_2_13,
                        )
                        - l_u_dot_by_q_of_place_13 * u_dot_by_q_of_u_2_80
                            * u_dot_by_q_pin1_of_u_2_22)
                + u_dot_by_q_of_place_39 * u_dot_by_q_pin1_of_u_2_23
                - m_times_6
                    * (-u_dot_by_q_of_place_24)
                        .mul_add(
                            u_dot_by_q_pin1_of_u_2_23,
                            u_dot_by_q_of_place_13 * u_dot_by_q_of_u_2_51
                                * u_dot_by_q_pin1_of_place_2,
                        ) + u_dot_by_q_of_place_38 * u_dot_by_q_pin1_of_u_2_24
                + u_dot_by_q_of_place_40 * u_2_times_6 * u_2_cos_q_pin1
                - m_l_times_6
                    * (u_dot_by_q_of_u_2_88
                        .mul_add(
                            u_dot_by_q_pin1_of_u_2,
                            u_dot_by_q_of_u_2_92 * sin_q_pin1,
                        ) + u_dot_by_q_pin1_of_u_2_24 * cos_q_pin1
                        + u_dot_by_q_of_u_2_102 * u_2_cos_q_pin1
                        - u_dot_by_q_of_u_2_72 * u_dot_by_q_of_place_35 * u_dot_by_q_pin1_of_u_2_25)
                - u_dot_by_q_pin1_of_place_2
                    * (u_dot_by_q_pin1_of_u_2_27 + u_dot_by_q_pin1_of_u_2_28));
    // -u_dot_by_q_ground2_of_place
    let u_dot_by_q_pin2_of_place = -u_dot_by_q_ground2_of_place;
    let u_dot_by_q_pin2_of_u_2 = u_dot_by_q_of_u_2_2 * u_dot_by_q_pin2_of_place;
    // u_dot_by_q_pin2_of_u_2 - u_dot_by_q_ground1_of_u_2_2
    let u_dot_by_q_pin2_of_u_2_2 = u_dot_by_q_pin2_of_u_2 - u_dot_by_q_ground1_of_u_2_2;
    // -u_dot_by_q_pin2_of_u_2_2
    let u_dot_by_q_pin2_of_u_2_3 = -u_dot_by_q_pin2_of_u_2_2;
    // cos(q_pin2) - u_dot_by_q_of_place_20
    let u_dot_by_q_pin2_of_place_2 = cos_q_pin2 - u_dot_by_q_of_place_20;
    let u_dot_by_q_pin2_of_u_2_4 = u_dot_by_q_of_u_2_2 * u_dot_by_q_pin2_of_place_2;
    // u_dot_by_q_pin2_of_u_2_2 - u_dot_by_q_pin2_of_u_2_4
    let u_dot_by_q_pin2_of_u_2_5 = u_dot_by_q_pin2_of_u_2_2 - u_dot_by_q_pin2_of_u_2_4;
    let u_dot_by_q_pin2_of_place_3 = sin_angle_inv * u_dot_by_q_pin2_of_place;
    // u_dot_by_q_ground1_of_u_2_8 + sin_angle_inv*(sin(q_ground2)*(u_dot_by_q_of_u_2_21 +
    //   u_dot_by_q_of_place_2*u_dot_by_q_pin2_of_u_2_3) -
    //   u_dot_by_q_of_u_2_8*(u_dot_by_q_of_place_2*cos(q_ground2) + u_dot_by_q_of_place_9*sin(q_ground2)) +
    //   cos(q_ground2)*(u_dot_by_q_of_u_2_19 - u_dot_by_q_of_place_9*u_dot_by_q_pin2_of_u_2_3) +
    //   u_dot_by_q_ground1_of_u_2*u_dot_by_q_pin2_of_place_2) -
    //   u_dot_by_q_of_place_12*u_dot_by_q_pin2_of_u_2_5 -
    //   u_dot_by_q_ground1_of_u_2_9*u_dot_by_q_pin2_of_place_3
    let u_dot_by_q_pin2_of_u_2_6 = u_dot_by_q_ground1_of_u_2_8
        + sin_angle_inv
            * (sin_q_ground2
                * u_dot_by_q_of_place_2
                    .mul_add(u_dot_by_q_pin2_of_u_2_3, u_dot_by_q_of_u_2_21)
                - u_dot_by_q_of_u_2_8
                    * u_dot_by_q_of_place_9
                        .mul_add(sin_q_ground2, u_dot_by_q_of_place_2 * cos_q_ground2)
                + cos_q_ground2
                    * (-u_dot_by_q_of_place_9)
                        .mul_add(u_dot_by_q_pin2_of_u_2_3, u_dot_by_q_of_u_2_19)
                + u_dot_by_q_ground1_of_u_2 * u_dot_by_q_pin2_of_place_2)
        - u_dot_by_q_of_place_12 * u_dot_by_q_pin2_of_u_2_5
        - u_dot_by_q_ground1_of_u_2_9 * u_dot_by_q_pin2_of_place_3;
    // u_dot_by_q_of_place_12 - u_dot_by_q_pin2_of_place_3
    let u_dot_by_q_pin2_of_place_4 = u_dot_by_q_of_place_12 - u_dot_by_q_pin2_of_place_3;
    let u_dot_by_q_pin2_of_place_5 = sin_angle_inv * u_dot_by_q_pin2_of_place_2;
    // u_dot_by_q_ground1_of_u_2_14*(u_dot_by_q_ground1_of_u_2_9 - u_dot_by_q_pin2_of_u_2) -
    //   u_dot_by_q_of_u_2_49*u_dot_by_q_pin2_of_place_5
    let u_dot_by_q_pin2_of_u_2_7 = u_dot_by_q_ground1_of_u_2_14
        * (u_dot_by_q_ground1_of_u_2_9 - u_dot_by_q_pin2_of_u_2)
        - u_dot_by_q_of_u_2_49 * u_dot_by_q_pin2_of_place_5;
    // u_dot_by_q_of_u_2_3*u_dot_by_q_of_u_2_8 - u_dot_by_q_ground1_of_u_2_13
    let u_dot_by_q_pin2_of_u_2_8 = u_dot_by_q_of_u_2_3
        .mul_add(u_dot_by_q_of_u_2_8, -u_dot_by_q_ground1_of_u_2_13);
    // u_dot_by_q_pin2_of_u_2_7 + u_dot_by_q_pin2_of_u_2_8
    let u_dot_by_q_pin2_of_u_2_9 = u_dot_by_q_pin2_of_u_2_7 + u_dot_by_q_pin2_of_u_2_8;
    // l_u_dot_by_q_of_u_2_49*u_dot_by_q_pin2_of_place_4 - l_u_dot_by_q_of_u_2*u_dot_by_q_pin2_of_u_2_6
    let u_dot_by_q_pin2_of_u_2_10 = (-l_u_dot_by_q_of_u_2)
        .mul_add(
            u_dot_by_q_pin2_of_u_2_6,
            l_u_dot_by_q_of_u_2_49 * u_dot_by_q_pin2_of_place_4,
        );
    let u_dot_by_q_pin2_of_u_2_11 = l_u_dot_by_q_of_u_2 * cos_q_pin2;
    // 3*u_dot_by_q_of_place_19*sin(q_pin2) + u_dot_by_q_ground1_of_place_5*u_dot_by_q_pin2_of_place_4
    let u_dot_by_q_pin2_of_place_6 = u_dot_by_q_ground1_of_place_5
        .mul_add(
            u_dot_by_q_pin2_of_place_4,
            S::int(3) * u_dot_by_q_of_place_19 * sin_q_pin2,
        );
    // u_dot_by_q_pin2 = (2*m*l^2*sin(q_pin1)^2*sin(q_pin2)*cos(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) - 2*m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   3*m*l^2*sin(q_pin1)^2*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 -
    //   3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 +
    //   q_pin1)^2 - 2*m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 +
    //   q_pin1)^2)*(18*m*l*g*cos(q) + 18*m*l*g*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   6*m*l*g*cos(q + q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   6*m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 6*m*l*g*sin(q_pin1)*cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1) +
    //   6*m*l^2*u^2*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   15*m*l*sin(q_pin1)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) +
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 3*m*l*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   (sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(m*l^2*u*(u*sin(q)*sin(q_ground1) +
    //   u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   3*m*l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1)
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(1 +
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   6*m*l*(l*u*sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   cos(q_pin1)*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)) -
    //   6*m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1
    //   + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/sin(q - q_ground1 + q_pin1) +
    //   6*m*(l^2*u^2*sin(q_pin1)^3*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + l*sin(q_pin1)*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)))/(4*(4*m*l^2 + 4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 +
    //   q_pin1)^2 + 3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2)^2) +
    //   (6*m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   6*m*l*g*cos(q_ground2)*sin(q_pin1)*cos(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + 6*m*l*g*sin(q_pin1)*sin(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1) +
    //   6*m*l*g*sin(q_pin1)*cos(q_ground1 + q_pin2)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 +
    //   q_pin1) - 3*m*l*sin(q_pin1)*cos(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) +
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   sin(q_pin1)*cos(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) +
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   3*m*l*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1)
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) +
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
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*cos(q_pin2)*(cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   l*u^2*sin(q_pin1)^2*sin(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) +
    //   2*l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + l*u*sin(q_pin1)*cos(q_pin2)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q -
    //   q_ground1 + q_pin1)) + l*u*sin(q_pin1)*sin(q_pin2)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1
    //   - q - q_pin1)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)) + 2*l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*cos(q_pin2)*(u*sin(q_pin1)/sin(q
    //   - q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) - u*sin(q_pin1)*cos(q_pin2)/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*cos(q_pin2)*(cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1))
    //   - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   m*l^2*u^2*sin(q_pin1)^2*sin(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) +
    //   2*m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*u*sin(q_pin1)*cos(q_pin2)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q -
    //   q_ground1 + q_pin1)) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u - u*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q - q_pin1)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)) + 2*m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)^2) +
    //   m*l^2*u*sin(q_pin1)*cos(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) -
    //   u*sin(q_pin1)*cos(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) -
    //   u*sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1
    //   + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) + 3*m*l*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 +
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
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) +
    //   6*m*l*sin(q_pin1)*(l*u*sin(q_pin1)*cos(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1
    //   + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) -
    //   l*u*sin(q_pin1)*sin(q_pin2)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2))*(u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1)
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1)) - l*u*sin(q_pin1)*sin(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) + cos(q_ground2)*cos(q_ground1 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 +
    //   q_pin1) + cos(q_pin2)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 +
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
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)))/sin(q - q_ground1 + q_pin1) +
    //   6*m*(l^2*u^2*sin(q_pin1)^3*sin(q_pin2)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
    //   q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 +
    //   q_pin1)^3 - l^2*u^2*sin(q_pin1)^3*cos(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + l*sin(q_pin1)*sin(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + l*sin(q_pin1)*cos(q_pin2)*((sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1
    //   - q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2)) + (sin(q_ground2)*sin(q_ground1 + q_pin2)
    //   + cos(q_ground2)*cos(q_ground1 + q_pin2))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)) + sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q_ground1 - q_ground2 +
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
    //   q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1))/(4*(4*m*l^2 +
    //   4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2))
    let u_dot_by_q_pin2 = u_dot_by_q_of_place_48
        * (u_dot_by_q_ground1_of_place_4 + u_dot_by_q_ground1_of_u_2_24 * u_dot_by_q_pin2_of_place_4
            + u_dot_by_q_of_place_19
                * (-u_dot_by_q_of_u_2_l_m_l)
                    .mul_add(
                        u_dot_by_q_pin2_of_u_2_6,
                        u_dot_by_q_of_u_2_54 * u_dot_by_q_pin2_of_place_4,
                    ) - u_dot_by_q_of_u_2_60 * u_dot_by_q_pin2_of_place_5
            + u_dot_by_q_of_place_21
                * l_m_l
                    .mul_add(
                        u_dot_by_q_pin2_of_u_2_9,
                        u_dot_by_q_of_u_2_41 * u_dot_by_q_pin2_of_u_2_5,
                    )
            + u_dot_by_q_of_place_27
                * l
                    .mul_add(
                        u_dot_by_q_pin2_of_u_2_9,
                        l_u_dot_by_q_of_u_2_40 * u_dot_by_q_pin2_of_u_2_5,
                    ) + u_dot_by_q_of_place_26 * u_dot_by_q_pin2_of_u_2_10
            + u_dot_by_q_of_place_23
                * ((-u_dot_by_q_of_u_2_45)
                    .mul_add(u_dot_by_q_pin2_of_u_2_3, u_dot_by_q_of_u_2_61 * sin_q_pin2)
                    - u_dot_by_q_ground1_of_u_2_20 * u_dot_by_q_pin2_of_place_4
                    + u_dot_by_q_pin2_of_u_2_10 * cos_q_pin2
                    + u_dot_by_q_of_place_13 * u_dot_by_q_of_u_2_18 * u_dot_by_q_pin2_of_u_2_11)
            + m_times_6
                * (u_dot_by_q_ground1_of_u_2_22
                    .mul_add(
                        u_dot_by_q_pin2_of_place_4,
                        l_u_dot_by_q_of_u_2_49 * l_u_dot_by_q_of_place_19 * sin_q_pin2,
                    )
                    - u_dot_by_q_of_place_19 * l_u_dot_by_q_of_u_2 * u_dot_by_q_pin2_of_u_2_11))
        + u_dot_by_q_of_place_44 * u_dot_by_q_of_u_2_104
            * u_dot_by_q_ground1_of_place_6
                .mul_add(u_dot_by_q_pin2_of_place_5, -u_dot_by_q_pin2_of_place_6);
    // 2*sin_angle_2_inv*u_dot_by_q_of_u_2_29 - u_dot_by_q_of_place_8*u_dot_by_q_pin1_of_u_2_4
    let u_dot_by_u_of_u_2 = (-u_dot_by_q_of_place_8)
        .mul_add(
            u_dot_by_q_pin1_of_u_2_4,
            S::int(2) * sin_angle_2_inv * u_dot_by_q_of_u_2_29,
        );
    let u_dot_by_u_of_place = sin_angle_2_inv * u_dot_by_q_of_place_14;
    // 1 - u_dot_by_q_of_place_8
    let u_dot_by_u_of_place_2 = S::int(1) - u_dot_by_q_of_place_8;
    // -u_dot_by_u_of_place - u_dot_by_u_of_place_2
    let u_dot_by_u_of_place_3 = -u_dot_by_u_of_place - u_dot_by_u_of_place_2;
    let u_dot_by_u_of_place_4 = u_dot_by_q_of_place_4 * u_dot_by_u_of_place_3;
    let u_dot_by_u_of_place_5 = u_dot_by_q_of_place_29 * u_dot_by_u_of_place_2;
    // u_dot_by_q_of_place_31*u_dot_by_q_of_u_2_90 + u_dot_by_q_of_u_2_72*u_dot_by_u_of_place_5
    let u_dot_by_u_of_u_2_2 = u_dot_by_q_of_u_2_72
        .mul_add(u_dot_by_u_of_place_5, u_dot_by_q_of_place_31 * u_dot_by_q_of_u_2_90);
    // u_dot_by_q_of_place_8*u_dot_by_q_of_place_14*u_dot_by_q_of_place_28 -
    //   u_dot_by_q_of_place_34*u_dot_by_u_of_place +
    //   u_dot_by_q_of_place_28*u_dot_by_u_of_place_2*sin(q_pin1) - u_dot_by_u_of_place_5*cos(q_pin1)
    let u_dot_by_u_of_place_6 = (-u_dot_by_q_of_place_34)
        .mul_add(
            u_dot_by_u_of_place,
            u_dot_by_q_of_place_8 * u_dot_by_q_of_place_14 * u_dot_by_q_of_place_28,
        ) + u_dot_by_q_of_place_28 * u_dot_by_u_of_place_2 * sin_q_pin1
        - u_dot_by_u_of_place_5 * cos_q_pin1;
    // u_dot_by_q_of_place_19 - u_dot_by_q_of_place_21
    let u_dot_by_u_of_place_7 = u_dot_by_q_of_place_19 - u_dot_by_q_of_place_21;
    // sin_angle_inv*(sin(q_ground2)*(u_dot_by_q_of_place_8*sin(q_ground1) +
    //   u_dot_by_q_of_place_2*u_dot_by_q_of_place_19) + cos(q_ground2)*(u_dot_by_q_of_place_8*cos(q_ground1)
    //   - u_dot_by_q_of_place_9*u_dot_by_q_of_place_19) - u_dot_by_q_of_place_10*u_dot_by_q_of_place_21) +
    //   u_dot_by_q_of_place_12*u_dot_by_u_of_place_7
    let u_dot_by_u_of_place_8 = sin_angle_inv
        * (sin_q_ground2
            * u_dot_by_q_of_place_2
                .mul_add(u_dot_by_q_of_place_19, u_dot_by_q_of_place_8 * sin_q_ground1)
            + cos_q_ground2
                * (-u_dot_by_q_of_place_9)
                    .mul_add(
                        u_dot_by_q_of_place_19,
                        u_dot_by_q_of_place_8 * cos_q_ground1,
                    ) - u_dot_by_q_of_place_10 * u_dot_by_q_of_place_21)
        + u_dot_by_q_of_place_12 * u_dot_by_u_of_place_7;
    // u_dot_by_q_of_place_13*u_dot_by_u_of_place_4 - u_dot_by_u_of_place_8
    let u_dot_by_u_of_place_9 = u_dot_by_q_of_place_13
        .mul_add(u_dot_by_u_of_place_4, -u_dot_by_u_of_place_8);
    // sin_q_pin2_sin_angle_inv*u_dot_by_u_of_u_2 + u_dot_by_q_of_u_2_9*u_dot_by_u_of_place_3
    let u_dot_by_u_of_u_2_3 = u_dot_by_q_of_u_2_9
        .mul_add(u_dot_by_u_of_place_3, sin_q_pin2_sin_angle_inv * u_dot_by_u_of_u_2);
    let l_u_dot_by_q_of_place_8 = l * u_dot_by_q_of_place_8;
    // l_u_dot_by_q_of_place_13*u_dot_by_u_of_u_2 + l_u_dot_by_q_of_u_2*u_dot_by_u_of_place_9 -
    //   u_dot_by_q_of_u_2_26*l_u_dot_by_q_of_place_8
    let u_dot_by_u_of_u_2_4 = l_u_dot_by_q_of_u_2
        .mul_add(u_dot_by_u_of_place_9, l_u_dot_by_q_of_place_13 * u_dot_by_u_of_u_2)
        - u_dot_by_q_of_u_2_26 * l_u_dot_by_q_of_place_8;
    // l*u_dot_by_u_of_u_2 + l_u_dot_by_q_of_u_2*u_dot_by_u_of_place_4
    let u_dot_by_u_of_u_2_5 = l_u_dot_by_q_of_u_2
        .mul_add(u_dot_by_u_of_place_4, l * u_dot_by_u_of_u_2);
    // l*u_dot_by_u_of_u_2_2 + u_dot_by_q_of_u_2_84*u_dot_by_u_of_place_6
    let u_dot_by_u_of_u_2_6 = u_dot_by_q_of_u_2_84
        .mul_add(u_dot_by_u_of_place_6, l * u_dot_by_u_of_u_2_2);
    // u_dot_by_u = (6*m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   l*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1) - 2*l*u*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 - l*u*sin(q_pin1)*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   1 + (cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) - l*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1
    //   + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) +
    //   l*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   12*m*l^2*u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   15*m*l*sin(q_pin1)*(2*l*u*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 +
    //   l*u*sin(q_pin1)*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) - 1 + (cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + l*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) - sin(q_pin1)*(2*m*l^2*u*cos(q_pin1)*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 +
    //   m*l^2*u*sin(q_pin1)*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) - 1 + (cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) + m*l^2*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) -
    //   3*m*l*sin(q_pin1)*sin(q_pin2)*(2*l*u*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u*sin(q_pin1)*sin(q_pin2)*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) - 1 +
    //   (cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q -
    //   q_ground1 + q_pin1)) + 2*l*u*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) + l*sin(q_pin1)*sin(q_pin2)*(u - u*sin(q_pin1)/sin(q
    //   - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) + l*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) - u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) -
    //   sin(q_pin1)*sin(q_pin2)*(2*m*l^2*u*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) - 1
    //   + (cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q + q_pin1)))/sin(q -
    //   q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q -
    //   q_ground1 + q_pin1)) + 2*m*l^2*u*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)) + m*l^2*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) - 3*m*l*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(l*u*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1) -
    //   sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   (sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(m*l^2*u*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1) - sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + cos(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1))*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1) + sin(q_pin1)*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) +
    //   sin(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)) + cos(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1) - sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) - u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q
    //   - q_ground1 + q_pin1) - u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   3*m*l*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*l*u*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) - sin(q_pin1)*(1 +
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/sin(q - q_ground1 + q_pin1) -
    //   6*m*l*(l*u*sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(1 + (sin(q_ground1)*(cos(q)
    //   + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + l*sin(q_pin1)*(sin(q)*cos(q_ground1)
    //   - cos(q)*sin(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q)
    //   + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) +
    //   cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   cos(q_pin1)*(l*u*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1) -
    //   sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2)) -
    //   6*m*(2*l^2*u*sin(q_pin1)^3*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + l*sin(q_pin1)*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(2*l*u*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(sin(q_pin1)/sin(q - q_ground1 +
    //   q_pin1) - 1 + (cos(q_ground1)*(sin(q) + sin(q + q_pin1)) - sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1)) +
    //   l*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))/sin(q - q_ground1 + q_pin1)))/(4*(4*m*l^2 +
    //   4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2))
    let u_dot_by_u = u_dot_by_q_of_place_48
        * (-u_dot_by_q_of_place_8
            * u_dot_by_q_of_u_2_l_m_l
                .mul_add(u_dot_by_u_of_place_4, l_m_l * u_dot_by_u_of_u_2)
            + S::int(12) * u_dot_by_q_of_u_2_103
            - u_dot_by_q_of_place_32
                * u_dot_by_q_of_u_2_87
                    .mul_add(u_dot_by_u_of_place_6, l_m_l * u_dot_by_u_of_u_2_2)
            + u_dot_by_q_of_place_19
                * ((-u_dot_by_q_of_place_18)
                    .mul_add(
                        u_dot_by_u_of_u_2,
                        u_dot_by_q_of_u_2_26 * u_dot_by_q_of_place_44,
                    ) - u_dot_by_q_of_u_2_l_m_l * u_dot_by_u_of_place_9)
            + u_dot_by_q_of_place_21
                * ((-u_dot_by_q_of_place_44)
                    .mul_add(
                        u_dot_by_q_pin1_of_u_2_18,
                        u_dot_by_q_of_u_2_41 * u_dot_by_u_of_place_7,
                    ) - l_m_l * u_dot_by_u_of_u_2_3)
            + u_dot_by_q_of_place_27
                * ((-l)
                    .mul_add(
                        u_dot_by_u_of_u_2_3,
                        l_u_dot_by_q_of_u_2_40 * u_dot_by_u_of_place_7,
                    ) - u_dot_by_q_pin1_of_u_2_18 * l_u_dot_by_q_of_place_8)
            - u_dot_by_q_of_place_26 * u_dot_by_u_of_u_2_4
            + u_dot_by_q_of_place_23
                * ((-u_dot_by_u_of_u_2_4)
                    .mul_add(cos_q_pin2, u_dot_by_q_of_place_19 * u_dot_by_q_of_u_2_45)
                    + l_u_dot_by_q_of_place_19 * u_dot_by_q_pin1_of_u_2_22)
            - u_dot_by_q_of_place_39 * u_dot_by_u_of_u_2_5
            - m_times_6
                * u_dot_by_q_of_place_24
                    .mul_add(
                        u_dot_by_u_of_u_2_5,
                        S::int(2) * u_dot_by_q_of_place_8 * u_dot_by_q_of_u_2_44
                            * l_u_dot_by_q_of_place_19,
                    ) - u_dot_by_q_of_place_38 * u_dot_by_u_of_u_2_6
            + m_l_times_6
                * (-u_dot_by_q_pin1_of_u_2_25 + u_dot_by_u_of_u_2_6 * cos_q_pin1
                    - u_dot_by_q_of_u_2_88 * (S::int(1) + u_dot_by_u_of_place)));
    let q_pin1_dot_by_q_value_of_u_2 = u_dot_by_q_of_u_2_73 * sin_q_pin1;
    // sin(q_ground1)*sin(q_ground2) + cos(q_ground1)*cos(q_ground2)
    let q_pin2_dot_by_q_value_of_place = cos_q_ground1
        .mul_add(cos_q_ground2, sin_q_ground1 * sin_q_ground2);
    // sin(q_ground1)*cos(q_ground2) - cos(q_ground1)*sin(q_ground2)
    let q_pin2_dot_by_q_value_of_place_2 = (-cos_q_ground1)
        .mul_add(sin_q_ground2, sin_q_ground1 * cos_q_ground2);
    let q_pin2_dot_by_q_value_of_place_3 = u_dot_by_q_of_q_pin2 * q_pin2_dot_by_q_value_of_place_2;
    // u_dot_by_q_of_u_2_9*q_pin2_dot_by_q_value_of_place +
    //   u_dot_by_q_of_u_2_37*q_pin2_dot_by_q_value_of_place_3
    let q_pin2_dot_by_q_value_of_u_2 = u_dot_by_q_of_u_2_37
        .mul_add(
            q_pin2_dot_by_q_value_of_place_3,
            u_dot_by_q_of_u_2_9 * q_pin2_dot_by_q_value_of_place,
        );
    // u_dot_by_q_of_u_2_8*q_pin2_dot_by_q_value_of_place_2 +
    //   u_dot_by_q_of_u_2_2*(cos_angle_sin_angle_inv*q_pin2_dot_by_q_value_of_place_3 -
    //   u_dot_by_q_pin2_of_place_2*q_pin2_dot_by_q_value_of_place)
    let q_pin2_dot_by_q_ground1_value_of_u_2 = u_dot_by_q_of_u_2_2
        * (-u_dot_by_q_pin2_of_place_2)
            .mul_add(
                q_pin2_dot_by_q_value_of_place,
                cos_angle_sin_angle_inv * q_pin2_dot_by_q_value_of_place_3,
            ) + u_dot_by_q_of_u_2_8 * q_pin2_dot_by_q_value_of_place_2;
    // q_pin2_dot_by_q_ground1_value_of_u_2 - u_dot_by_q_of_u_2_2*q_pin2_dot_by_q_value_of_place
    let q_pin2_dot_by_q_ground1_value_of_u_2_2 = (-u_dot_by_q_of_u_2_2)
        .mul_add(q_pin2_dot_by_q_value_of_place, q_pin2_dot_by_q_ground1_value_of_u_2);
    let q_pin2_dot_by_q_pin1_value_of_place = sin_angle_inv * q_pin2_dot_by_q_value_of_place_3;
    // Entries that are not zero.
    // d(q')/d(u) = 1
    let q_dot_by_u_value = S::int(1);
    // d(q_ground1')/d(q) = u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))
    let q_ground1_dot_by_q_value = -u_dot_by_q_of_u_2_4;
    // d(q_ground1')/d(q_ground1) = u*sin(q_pin1)/(sin(q - q_ground1 + q_pin1)*tan(q - q_ground1 + q_pin1))
    let q_ground1_dot_by_q_ground1_value = u_dot_by_q_of_u_2_4;
    // d(q_ground1')/d(q_pin1) = u*(cos(q_pin1) + sin(q_pin1)/tan(q_ground1 - q - q_pin1))/sin(q -
    //   q_ground1 + q_pin1)
    let q_ground1_dot_by_q_pin1_value = u_dot_by_q_of_u_2_80;
    // d(q_ground1')/d(u) = sin(q_pin1)/sin(q - q_ground1 + q_pin1)
    let q_ground1_dot_by_u_value = u_dot_by_q_of_place_8;
    // d(q_ground2')/d(q) = u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1))
    let q_ground2_dot_by_q_value = -u_dot_by_q_of_u_2_9;
    // d(q_ground2')/d(q_ground1) = u*sin(q_pin1)*sin(q_pin2)*(1/tan(q - q_ground1 + q_pin1) +
    //   1/tan(q_ground2 - q_ground1 - q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 +
    //   q_pin2))
    let q_ground2_dot_by_q_ground1_value = -u_dot_by_q_ground1_of_u_2_5;
    // d(q_ground2')/d(q_ground2) = u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)*tan(q_ground1 - q_ground2 + q_pin2))
    let q_ground2_dot_by_q_ground2_value = u_dot_by_q_of_u_2_40;
    // d(q_ground2')/d(q_pin1) = u*sin(q_pin2)*(cos(q_pin1) + sin(q_pin1)/tan(q_ground1 - q -
    //   q_pin1))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_ground2_dot_by_q_pin1_value = u_dot_by_q_pin1_of_u_2_14;
    // d(q_ground2')/d(q_pin2) = u*sin(q_pin1)*(cos(q_pin2) + sin(q_pin2)/tan(q_ground2 - q_ground1 -
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_ground2_dot_by_q_pin2_value = u_dot_by_q_pin2_of_u_2_4;
    // d(q_ground2')/d(u) = sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2))
    let q_ground2_dot_by_u_value = u_dot_by_q_of_place_21;
    // d(q_pin1')/d(q) = -u*sin(q_pin1)/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2
    let q_pin1_dot_by_q_value = -q_pin1_dot_by_q_value_of_u_2;
    // d(q_pin1')/d(q_ground1) = u*sin(q_pin1)/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1))
    //   + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2
    let q_pin1_dot_by_q_ground1_value = q_pin1_dot_by_q_value_of_u_2;
    // d(q_pin1')/d(q_pin1) = -u*(cos(q)*(cos(q)*sin(q_pin1) + sin(q)*cos(q_pin1) -
    //   2*cos(q_ground1)*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) +
    //   cos(q_ground1)*(cos(q_ground1)*sin(q_pin1) -
    //   sin(q_ground1)*cos(q_pin1)))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2
    let q_pin1_dot_by_q_pin1_value = cos_q_ground1
        * (cos_q_pin1
            * (u_dot_by_q_of_u_2_72 * u_dot_by_q_of_place_36)
                .mul_add(cos_q, u_dot_by_q_of_u_2_73 * sin_q_ground1)
            + q_pin1_dot_by_q_value_of_u_2
                * (u_dot_by_q_of_place_29 * cos_q).mul_add(S::int(2), -cos_q_ground1))
        - u_dot_by_q_of_q_2_q_pin1_3 * u_dot_by_q_of_u_2_73 * cos_q;
    // d(q_pin1')/d(u) = (sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q +
    //   q_pin1)))/sin(q - q_ground1 + q_pin1)
    let q_pin1_dot_by_u_value = -sin_angle_2_inv * (u_dot_by_q_of_place_28 + u_dot_by_q_of_place_30)
        - u_dot_by_q_of_place_8 * u_dot_by_q_of_place_29;
    // d(q_pin2')/d(q) = u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1))
    let q_pin2_dot_by_q_value = q_pin2_dot_by_q_value_of_u_2;
    // d(q_pin2')/d(q_ground1) = -u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2) -
    //   cos(q_ground1)*(1/tan(q - q_ground1 + q_pin1) + 1/tan(q_ground2 - q_ground1 - q_pin2)) -
    //   cos(q_ground1 + q_pin2)*(1/tan(q - q_ground1 + q_pin1) + 1/tan(q_ground2 - q_ground1 - q_pin2))) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2) + sin(q_ground1)*(1/tan(q - q_ground1 +
    //   q_pin1) + 1/tan(q_ground2 - q_ground1 - q_pin2)) + sin(q_ground1 + q_pin2)*(1/tan(q - q_ground1 +
    //   q_pin1) + 1/tan(q_ground2 - q_ground1 - q_pin2))))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2))
    let q_pin2_dot_by_q_ground1_value = q_pin2_dot_by_q_ground1_value_of_u_2_2
        - q_pin2_dot_by_q_value_of_u_2;
    // d(q_pin2')/d(q_ground2) = u*sin(q_pin1)*(sin(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2) +
    //   (cos(q_ground1) + cos(q_ground1 + q_pin2))/tan(q_ground1 - q_ground2 + q_pin2)) +
    //   cos(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2) + (sin(q_ground1) + sin(q_ground1 +
    //   q_pin2))/tan(q_ground2 - q_ground1 - q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2))
    let q_pin2_dot_by_q_ground2_value = -q_pin2_dot_by_q_ground1_value_of_u_2_2;
    // d(q_pin2')/d(q_pin1) = -u*(cos(q_pin1)*(cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)) -
    //   sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))) +
    //   sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/tan(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_dot_by_q_pin1_value = (-u_dot_by_q_of_u_2_80)
        .mul_add(
            q_pin2_dot_by_q_pin1_value_of_place,
            -u_dot_by_q_pin1_of_u_2_14 * q_pin2_dot_by_q_value_of_place,
        );
    // d(q_pin2')/d(q_pin2) = -u*sin(q_pin1)*(sin(q_ground2)*sin(q_ground1 + q_pin2) +
    //   cos(q_ground2)*cos(q_ground1 + q_pin2) + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))
    //   - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/tan(q_ground1 - q_ground2 +
    //   q_pin2))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_dot_by_q_pin2_value = q_pin2_dot_by_q_ground1_value_of_u_2;
    // d(q_pin2')/d(u) = sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2))
    let q_pin2_dot_by_u_value = (-u_dot_by_q_of_place_8)
        .mul_add(
            q_pin2_dot_by_q_pin1_value_of_place,
            -u_dot_by_q_of_place_21 * q_pin2_dot_by_q_value_of_place,
        );
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

/// Matrix of the linear system M(q) u' = f(q, u) row by row, and its right-hand side, which share terms.
///
/// 194 operations, 7 sines and cosines.
#[must_use]
pub fn linear_system<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 1],
) -> ([S; 1], [S; 1]) {
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
    let m_l = m * l;
    let l_m_l = l * m_l;
    // q - q_ground1 + q_pin1
    let m11_of_place = q_2 - q_ground1 + q_pin1;
    let (sin_angle, cos_angle) = m11_of_place.sin_cos();
    let sin_angle_inv = S::int(1) / sin_angle;
    let sin_q_pin1_sin_angle_inv = sin_angle_inv * sin_q_pin1;
    // sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)
    let m11_of_place_2 = (-cos_q).mul_add(sin_q_ground1, sin_q * cos_q_ground1);
    // sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)
    let m11_of_place_3 = cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1);
    // 1/(m11_of_place_2*cos(q_pin1) + m11_of_place_3*sin(q_pin1))
    let m11_of_place_4 = S::int(1)
        / m11_of_place_3.mul_add(sin_q_pin1, m11_of_place_2 * cos_q_pin1);
    let m11_of_place_5 = m11_of_place_2 * m11_of_place_4;
    let l_m_l_m11_of_place_5 = l_m_l * m11_of_place_5;
    // sin(q_ground1)*sin(q_pin2) - cos(q_ground1)*cos(q_pin2)
    let m11_of_place_6 = (-cos_q_ground1)
        .mul_add(cos_q_pin2, sin_q_ground1 * sin_q_pin2);
    // cos(q_ground1) - m11_of_place_6
    let m11_of_place_7 = cos_q_ground1 - m11_of_place_6;
    // cos(q_ground1)*sin(q_pin2) + sin(q_ground1)*cos(q_pin2)
    let m11_of_place_8 = sin_q_ground1.mul_add(cos_q_pin2, cos_q_ground1 * sin_q_pin2);
    // sin(q_ground1) + m11_of_place_8
    let m11_of_place_9 = sin_q_ground1 + m11_of_place_8;
    // q_ground1 - q_ground2 + q_pin2
    let m11_of_place_10 = q_ground1 - q_ground2 + q_pin2;
    let (sin_angle_2, cos_angle_2) = m11_of_place_10.sin_cos();
    let sin_angle_2_inv = S::int(1) / sin_angle_2;
    // sin_angle_2_inv*(m11_of_place_7*sin(q_ground2) - m11_of_place_9*cos(q_ground2))
    let m11_of_place_11 = sin_angle_2_inv
        * (-m11_of_place_9).mul_add(cos_q_ground2, m11_of_place_7 * sin_q_ground2);
    // 1 + m11_of_place_11
    let m11_of_place_12 = S::int(1) + m11_of_place_11;
    let m11_of_place_13 = sin_q_pin1_sin_angle_inv * m11_of_place_12;
    let m11_of_place_14 = m11_of_place_13 * cos_q_pin2;
    let m11_of_place_15 = sin_angle_2_inv * sin_q_pin2;
    let m11_of_place_16 = sin_q_pin1_sin_angle_inv * m11_of_place_15;
    // m11_of_place_5^2 + m11_of_place_13^2
    let m11_of_place_17 = m11_of_place_13
        .mul_add(m11_of_place_13, m11_of_place_5 * m11_of_place_5);
    let f1_of_u_2 = u_2 * sin_q_pin1_sin_angle_inv;
    let u_2_sin_angle_inv = u_2 * sin_angle_inv;
    // u - f1_of_u_2
    let u_2_minus_f1_of_u_2 = u_2 - f1_of_u_2;
    // sin(q)*sin(q_pin1) - cos(q)*cos(q_pin1)
    let f1_of_q_2_q_pin1 = (-cos_q).mul_add(cos_q_pin1, sin_q * sin_q_pin1);
    // sin(q_ground1)*(cos(q) - f1_of_q_2_q_pin1) - cos(q_ground1)*(sin(q) + cos(q)*sin(q_pin1) +
    //   sin(q)*cos(q_pin1))
    let f1_of_place = sin_q_ground1 * (cos_q - f1_of_q_2_q_pin1)
        - cos_q_ground1 * (cos_q.mul_add(sin_q_pin1, sin_q) + sin_q * cos_q_pin1);
    let f1_of_u_2_2 = u_2_sin_angle_inv * f1_of_place;
    // sin_angle_inv*u_2_sin_angle_inv*(sin(q_pin1)*cos(q - q_ground1 + q_pin1)*(u_2_minus_f1_of_u_2 +
    //   f1_of_u_2_2) - u*f1_of_place*cos(q_pin1))
    let f1_of_u_2_3 = sin_angle_inv * u_2_sin_angle_inv
        * (sin_q_pin1 * cos_angle * (u_2_minus_f1_of_u_2 + f1_of_u_2_2)
            - u_2 * f1_of_place * cos_q_pin1);
    let f1_of_u_2_4 = m11_of_place_15 * f1_of_u_2;
    let f1_of_u_2_5 = m11_of_place_12 * f1_of_u_2;
    // cos(q_ground1 - q_ground2 + q_pin2)*(f1_of_u_2_5 - f1_of_u_2_4)
    let f1_of_u_2_6 = cos_angle_2 * (f1_of_u_2_5 - f1_of_u_2_4);
    // f1_of_u_2_3*sin(q_pin2) - m11_of_place_11*f1_of_u_2^2*cos(q_pin2)
    let f1_of_u_2_7 = f1_of_u_2_3
        .mul_add(sin_q_pin2, -m11_of_place_11 * f1_of_u_2 * f1_of_u_2 * cos_q_pin2);
    // sin_angle_2_inv*(f1_of_u_2_4*f1_of_u_2_6 + f1_of_u_2_7)
    let f1_of_u_2_8 = sin_angle_2_inv * f1_of_u_2_4.mul_add(f1_of_u_2_6, f1_of_u_2_7);
    let f1_of_u_2_9 = m11_of_place_3 * u_2_minus_f1_of_u_2;
    // u*m11_of_place_4*(f1_of_u_2_9 + m11_of_place_5*(m11_of_place_2*u_2_minus_f1_of_u_2*sin(q_pin1) +
    //   m11_of_place_2*f1_of_u_2*f1_of_place - cos(q_pin1)*(m11_of_place_3*f1_of_u_2_2 + f1_of_u_2_9)))
    let f1_of_u_2_10 = u_2 * m11_of_place_4
        * (f1_of_u_2_9
            + m11_of_place_5
                * (m11_of_place_2 * u_2_minus_f1_of_u_2 * sin_q_pin1
                    + m11_of_place_2 * f1_of_u_2 * f1_of_place
                    - cos_q_pin1 * m11_of_place_3.mul_add(f1_of_u_2_2, f1_of_u_2_9)));
    let l_f1_of_u_2_10 = l * f1_of_u_2_10;
    // f1_of_u_2_4*(m11_of_place_7*cos(q_ground2) + m11_of_place_9*sin(q_ground2)) -
    //   sin(q_ground2)*(f1_of_u_2*sin(q_ground1) + m11_of_place_8*f1_of_u_2_5) +
    //   cos(q_ground2)*(m11_of_place_6*f1_of_u_2_5 - f1_of_u_2*cos(q_ground1))
    let f1_of_u_2_11 = f1_of_u_2_4
        * m11_of_place_9.mul_add(sin_q_ground2, m11_of_place_7 * cos_q_ground2)
        - sin_q_ground2 * m11_of_place_8.mul_add(f1_of_u_2_5, f1_of_u_2 * sin_q_ground1)
        + cos_q_ground2 * (-f1_of_u_2).mul_add(cos_q_ground1, m11_of_place_6 * f1_of_u_2_5);
    // m11_of_place_12*f1_of_u_2_3 + sin_angle_2_inv*f1_of_u_2*(m11_of_place_11*f1_of_u_2_6 - f1_of_u_2_11)
    let f1_of_u_2_12 = sin_angle_2_inv * f1_of_u_2
        * m11_of_place_11.mul_add(f1_of_u_2_6, -f1_of_u_2_11) + m11_of_place_12 * f1_of_u_2_3;
    // -l*f1_of_u_2_12
    let minus_l_f1_of_u_2_12 = -l * f1_of_u_2_12;
    // m11_of_place_5*l_f1_of_u_2_10 + m11_of_place_13*minus_l_f1_of_u_2_12
    let f1_of_u_2_13 = m11_of_place_13
        .mul_add(minus_l_f1_of_u_2_12, m11_of_place_5 * l_f1_of_u_2_10);
    // -l*f1_of_u_2_3
    let minus_l_f1_of_u_2_3 = -l * f1_of_u_2_3;
    // -l_m_l*f1_of_u_2_3
    let minus_l_m_l_f1_of_u_2_3 = -l_m_l * f1_of_u_2_3;
    // l_m_l*m11_of_place_5*f1_of_u_2_10 - l_m_l*m11_of_place_13*f1_of_u_2_12
    let f1_of_u_2_14 = (-(l_m_l * m11_of_place_13))
        .mul_add(f1_of_u_2_12, l_m_l * m11_of_place_5 * f1_of_u_2_10);
    // sin_q_pin1_sin_angle_inv*(15*m_l*minus_l_f1_of_u_2_3 + minus_l_m_l_f1_of_u_2_3) -
    //   l_m_l*m11_of_place_16*f1_of_u_2_8
    let f1_of_u_2_15 = sin_q_pin1_sin_angle_inv
        * (m_l * minus_l_f1_of_u_2_3).mul_add(S::int(15), minus_l_m_l_f1_of_u_2_3)
        - l_m_l * m11_of_place_16 * f1_of_u_2_8;
    // m11_of_place_5*f1_of_q_2_q_pin1 - m11_of_place_6*m11_of_place_13
    let f1_of_place_2 = (-m11_of_place_6)
        .mul_add(m11_of_place_13, m11_of_place_5 * f1_of_q_2_q_pin1);
    // cos(q) + sin_q_pin1_sin_angle_inv*cos(q_ground1)
    let f1_of_place_3 = sin_q_pin1_sin_angle_inv.mul_add(cos_q_ground1, cos_q);
    // m11_of_place_16*cos(q_ground2) + f1_of_place_2
    let f1_of_place_4 = m11_of_place_16.mul_add(cos_q_ground2, f1_of_place_2);
    let u_2_sin_q_pin1 = u_2 * sin_q_pin1;
    let l_f1_of_u_2 = l * f1_of_u_2;
    let sin_q_pin2_l_f1_of_u_2 = l_f1_of_u_2 * sin_q_pin2;
    // l*m11_of_place_5*u_2_sin_q_pin1*(u + f1_of_u_2_2) - l_f1_of_u_2_10*cos(q_pin1)
    let f1_of_u_2_16 = l * m11_of_place_5 * u_2_sin_q_pin1 * (u_2 + f1_of_u_2_2)
        - l_f1_of_u_2_10 * cos_q_pin1;
    // m*(l*m11_of_place_14*minus_l_f1_of_u_2_3 + m11_of_place_13*l_f1_of_u_2*sin_q_pin2_l_f1_of_u_2) +
    //   m_l*(sin_q_pin1_sin_angle_inv*(minus_l_f1_of_u_2_12*cos(q_pin2) -
    //   m11_of_place_12*f1_of_u_2_5*sin_q_pin2_l_f1_of_u_2) + f1_of_u_2_16)
    let f1_of_u_2_17 = m
        * (m11_of_place_13 * l_f1_of_u_2)
            .mul_add(sin_q_pin2_l_f1_of_u_2, l * m11_of_place_14 * minus_l_f1_of_u_2_3)
        + m_l
            * (sin_q_pin1_sin_angle_inv
                * (-(m11_of_place_12 * f1_of_u_2_5))
                    .mul_add(sin_q_pin2_l_f1_of_u_2, minus_l_f1_of_u_2_12 * cos_q_pin2)
                + f1_of_u_2_16);
    // u*l_m_l_m11_of_place_5*u_2_sin_q_pin1 - f1_of_u_2_17
    let f1_of_u_2_18 = (u_2 * l_m_l_m11_of_place_5)
        .mul_add(u_2_sin_q_pin1, -f1_of_u_2_17);
    // f1_of_u_2_14 + f1_of_u_2_15
    let f1_of_u_2_19 = f1_of_u_2_14 + f1_of_u_2_15;
    // g*m_l*(3*f1_of_place_3 + f1_of_place_4) - f1_of_u_2_18
    let f1_of_u_2_20 = g * m_l * f1_of_place_3.mul_add(S::int(3), f1_of_place_4) - f1_of_u_2_18;
    // Values.
    // M11 = 4*m*l^2/3 + 4*m*l^2*sin(q_pin1)^2/(3*sin(q - q_ground1 + q_pin1)^2) +
    //   m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))^2/(3*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(3*sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/(3*sin(q - q_ground1 + q_pin1)^2) + m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2
    let m11 = S::ratio(4, 3) * l_m_l
        * sin_q_pin1_sin_angle_inv.mul_add(sin_q_pin1_sin_angle_inv, S::int(1))
        - l_m_l_m11_of_place_5 * cos_q_pin1 + l_m_l * sin_q_pin1_sin_angle_inv * m11_of_place_14
        + S::ratio(1, 3) * l_m_l * m11_of_place_16.mul_add(m11_of_place_16, m11_of_place_17);
    // f1 = m*l*g*cos(q + q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))/(2*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) - 3*m*l*g*cos(q)/2 -
    //   3*m*l*g*cos(q_ground1)*sin(q_pin1)/(2*sin(q - q_ground1 + q_pin1)) -
    //   m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(2*sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) - m*l*g*sin(q_pin1)*cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/(2*sin(q - q_ground1 + q_pin1)) +
    //   m*l^2*u^2*sin(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))/(2*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) -
    //   5*m*l*sin(q_pin1)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/(4*sin(q - q_ground1 + q_pin1)) -
    //   sin(q_pin1)*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/(12*sin(q - q_ground1 + q_pin1)) -
    //   m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(4*sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) -
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(12*sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)))^2)/(4*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + (cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))*(m*l^2*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)))^2)/(12*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + m*l*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)))/(4*sin(q - q_ground1 + q_pin1)) + sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
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
    //   q_pin1)))/(12*sin(q - q_ground1 + q_pin1)) + m*l*(cos(q_pin1)*(l*u*(u*sin(q)*sin(q_ground1) +
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2) -
    //   l*u*sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))))/2 +
    //   m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/(2*sin(q - q_ground1 + q_pin1)) -
    //   m*(l^2*u^2*sin(q_pin1)^3*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))
    //   - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + l*sin(q_pin1)*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/2
    let f1 = S::ratio(1, 4) * m_l * (l * m11_of_place_16).mul_add(f1_of_u_2_8, -f1_of_u_2_13)
        - S::ratio(1, 12) * f1_of_u_2_19 - S::ratio(1, 2) * f1_of_u_2_20;
    ([m11], [f1])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 13 operations, 5 sines and cosines.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 5], _u: &[S; 1]) -> [S; 3] {
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    // Sines and cosines.
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_angle, _) = (q_2 - q_ground1 + q_pin1).sin_cos();
    let (sin_angle_2, _) = (q_ground1 - q_ground2 + q_pin2).sin_cos();
    // Values.
    // divisor1 = sin(q - q_ground1 + q_pin1)
    let divisor1 = sin_angle;
    // divisor2 = sin(q_ground1 - q_ground2 + q_pin2)
    let divisor2 = sin_angle_2;
    // divisor3 = sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))
    let divisor3 = sin_q_pin1 * cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1)
        + cos_q_pin1 * (-cos_q).mul_add(sin_q_ground1, sin_q * cos_q_ground1);
    [divisor1, divisor2, divisor3]
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 16 operations, 5 sines and cosines.
#[must_use]
pub fn constraints<S: Scalar>(p: &Parameters<S>, q: &[S; 5], _u: &[S; 1]) -> [S; 4] {
    let Parameters { l, .. } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    // Shared terms.
    // q + q_pin1
    let q_2_plus_q_pin1 = q_2 + q_pin1;
    let (sin_q_plus_q_pin1, cos_q_plus_q_pin1) = q_2_plus_q_pin1.sin_cos();
    // q_ground1 + q_pin2
    let q_ground1_plus_q_pin2 = q_ground1 + q_pin2;
    let (sin_q_ground1_plus_q_pin2, cos_q_ground1_plus_q_pin2) = q_ground1_plus_q_pin2
        .sin_cos();
    // Values.
    // close1_1 = l*(1 - cos(q) + cos(q_ground1) - cos(q + q_pin1))
    let residual1 = l * (S::int(1) - cos_q + cos_q_ground1 - cos_q_plus_q_pin1);
    // close1_2 = l*(sin(q_ground1) - sin(q) - sin(q + q_pin1))
    let residual2 = l * (sin_q_ground1 - sin_q - sin_q_plus_q_pin1);
    // close2_1 = l*(1 - cos(q_ground1) + cos(q_ground2) - cos(q_ground1 + q_pin2))
    let residual3 = l * (S::int(1) - cos_q_ground1 + cos_q_ground2 - cos_q_ground1_plus_q_pin2);
    // close2_2 = l*(sin(q_ground2) - sin(q_ground1) - sin(q_ground1 + q_pin2))
    let residual4 = l * (sin_q_ground2 - sin_q_ground1 - sin_q_ground1_plus_q_pin2);
    [residual1, residual2, residual3, residual4]
}

/// Slopes of the constraints, one after the other, along q, q_ground1, q_ground2, q_pin1, q_pin2, u.
///
/// 22 operations, 5 sines and cosines.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 1],
) -> [S; 24] {
    let Parameters { l, .. } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    // Sines and cosines.
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    // Shared terms.
    // q + q_pin1
    let q_2_plus_q_pin1 = q_2 + q_pin1;
    let (sin_q_plus_q_pin1, cos_q_plus_q_pin1) = q_2_plus_q_pin1.sin_cos();
    let l_sin_q_plus_q_pin1 = l * sin_q_plus_q_pin1;
    let l_sin_q_ground1 = l * sin_q_ground1;
    let l_cos_q_plus_q_pin1 = l * cos_q_plus_q_pin1;
    let l_cos_q_ground1 = l * cos_q_ground1;
    // q_ground1 + q_pin2
    let q_ground1_plus_q_pin2 = q_ground1 + q_pin2;
    let (sin_q_ground1_plus_q_pin2, cos_q_ground1_plus_q_pin2) = q_ground1_plus_q_pin2
        .sin_cos();
    let residual3_by_q_ground1_of_place = l * sin_q_ground1_plus_q_pin2;
    let residual4_by_q_ground1_of_place = l * cos_q_ground1_plus_q_pin2;
    // Values.
    // d(close1_1)/d(q) = l*(sin(q) + sin(q + q_pin1))
    let residual1_by_q = l.mul_add(sin_q, l_sin_q_plus_q_pin1);
    // d(close1_1)/d(q_ground1) = -l*sin(q_ground1)
    let residual1_by_q_ground1 = -l_sin_q_ground1;
    // d(close1_1)/d(q_pin1) = l*sin(q + q_pin1)
    let residual1_by_q_pin1 = l_sin_q_plus_q_pin1;
    // d(close1_2)/d(q) = -l*(cos(q) + cos(q + q_pin1))
    let residual2_by_q = (-l).mul_add(cos_q, -l_cos_q_plus_q_pin1);
    // d(close1_2)/d(q_ground1) = l*cos(q_ground1)
    let residual2_by_q_ground1 = l_cos_q_ground1;
    // d(close1_2)/d(q_pin1) = -l*cos(q + q_pin1)
    let residual2_by_q_pin1 = -l_cos_q_plus_q_pin1;
    // d(close2_1)/d(q_ground1) = l*(sin(q_ground1) + sin(q_ground1 + q_pin2))
    let residual3_by_q_ground1 = l_sin_q_ground1 + residual3_by_q_ground1_of_place;
    // d(close2_1)/d(q_ground2) = -l*sin(q_ground2)
    let residual3_by_q_ground2 = -l * sin_q_ground2;
    // d(close2_1)/d(q_pin2) = l*sin(q_ground1 + q_pin2)
    let residual3_by_q_pin2 = residual3_by_q_ground1_of_place;
    // d(close2_2)/d(q_ground1) = -l*(cos(q_ground1) + cos(q_ground1 + q_pin2))
    let residual4_by_q_ground1 = -l_cos_q_ground1 - residual4_by_q_ground1_of_place;
    // d(close2_2)/d(q_ground2) = l*cos(q_ground2)
    let residual4_by_q_ground2 = l * cos_q_ground2;
    // d(close2_2)/d(q_pin2) = -l*cos(q_ground1 + q_pin2)
    let residual4_by_q_pin2 = -residual4_by_q_ground1_of_place;
    let zero = S::int(0);
    [
        residual1_by_q, residual1_by_q_ground1, zero, residual1_by_q_pin1, zero, zero,
        residual2_by_q, residual2_by_q_ground1, zero, residual2_by_q_pin1, zero, zero, zero,
        residual3_by_q_ground1, residual3_by_q_ground2, zero, residual3_by_q_pin2, zero, zero,
        residual4_by_q_ground1, residual4_by_q_ground2, zero, residual4_by_q_pin2, zero,
    ]
}

/// Inverse dynamics: the generalized forces along (u) that must act beside the loads of the model for the accelerations to be (u').
///
/// 191 operations, 7 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 1],
    v_dot: &[S; 1],
) -> [S; 1] {
    let Parameters { m, l, g } = *p;
    let [q_2, q_ground1, q_ground2, q_pin1, q_pin2] = *q;
    let [u_2] = *u;
    let [u_dot] = *v_dot;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_q_ground1, cos_q_ground1) = q_ground1.sin_cos();
    let (sin_q_pin1, cos_q_pin1) = q_pin1.sin_cos();
    let (sin_q_pin2, cos_q_pin2) = q_pin2.sin_cos();
    let (sin_q_ground2, cos_q_ground2) = q_ground2.sin_cos();
    // Shared terms.
    let m_l = m * l;
    let l_m_l = l * m_l;
    // sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)
    let tau1_of_place = (-cos_q).mul_add(sin_q_ground1, sin_q * cos_q_ground1);
    // sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)
    let tau1_of_place_2 = cos_q.mul_add(cos_q_ground1, sin_q * sin_q_ground1);
    // 1/(tau1_of_place*cos(q_pin1) + tau1_of_place_2*sin(q_pin1))
    let tau1_of_place_3 = S::int(1)
        / tau1_of_place_2.mul_add(sin_q_pin1, tau1_of_place * cos_q_pin1);
    let tau1_of_place_4 = tau1_of_place * tau1_of_place_3;
    let l_m_l_tau1_of_place_4 = l_m_l * tau1_of_place_4;
    // sin(q_ground1)*sin(q_pin2) - cos(q_ground1)*cos(q_pin2)
    let tau1_of_place_5 = (-cos_q_ground1)
        .mul_add(cos_q_pin2, sin_q_ground1 * sin_q_pin2);
    // cos(q_ground1) - tau1_of_place_5
    let tau1_of_place_6 = cos_q_ground1 - tau1_of_place_5;
    // cos(q_ground1)*sin(q_pin2) + sin(q_ground1)*cos(q_pin2)
    let tau1_of_place_7 = sin_q_ground1.mul_add(cos_q_pin2, cos_q_ground1 * sin_q_pin2);
    // sin(q_ground1) + tau1_of_place_7
    let tau1_of_place_8 = sin_q_ground1 + tau1_of_place_7;
    // q_ground1 - q_ground2 + q_pin2
    let tau1_of_place_9 = q_ground1 - q_ground2 + q_pin2;
    let (sin_angle, cos_angle) = tau1_of_place_9.sin_cos();
    let sin_angle_inv = S::int(1) / sin_angle;
    // sin_angle_inv*(tau1_of_place_6*sin(q_ground2) - tau1_of_place_8*cos(q_ground2))
    let tau1_of_place_10 = sin_angle_inv
        * (-tau1_of_place_8).mul_add(cos_q_ground2, tau1_of_place_6 * sin_q_ground2);
    // 1 + tau1_of_place_10
    let tau1_of_place_11 = S::int(1) + tau1_of_place_10;
    // q - q_ground1 + q_pin1
    let tau1_of_place_12 = q_2 - q_ground1 + q_pin1;
    let (sin_angle_2, cos_angle_2) = tau1_of_place_12.sin_cos();
    let sin_angle_2_inv = S::int(1) / sin_angle_2;
    let tau1_of_place_13 = sin_angle_2_inv * sin_q_pin1;
    let tau1_of_place_14 = tau1_of_place_11 * tau1_of_place_13;
    let tau1_of_place_15 = tau1_of_place_14 * cos_q_pin2;
    let sin_q_pin2_sin_angle_inv = sin_angle_inv * sin_q_pin2;
    let tau1_of_place_16 = tau1_of_place_13 * sin_q_pin2_sin_angle_inv;
    // 4 + tau1_of_place_14^2
    let tau1_of_place_17 = tau1_of_place_14.mul_add(tau1_of_place_14, S::int(4));
    // tau1_of_place_13*(4*tau1_of_place_13 + 3*tau1_of_place_15) + tau1_of_place_16^2
    let tau1_of_place_18 = tau1_of_place_13
        * tau1_of_place_15.mul_add(S::int(3), S::int(4) * tau1_of_place_13)
        + tau1_of_place_16 * tau1_of_place_16;
    let u_2_tau1_of_place_13 = u_2 * tau1_of_place_13;
    let u_2_sin_angle_2_inv = u_2 * sin_angle_2_inv;
    // sin(q)*sin(q_pin1) - cos(q)*cos(q_pin1)
    let tau1_of_q_2_q_pin1 = (-cos_q).mul_add(cos_q_pin1, sin_q * sin_q_pin1);
    // sin(q_ground1)*(cos(q) - tau1_of_q_2_q_pin1) - cos(q_ground1)*(sin(q) + cos(q)*sin(q_pin1) +
    //   sin(q)*cos(q_pin1))
    let tau1_of_place_19 = sin_q_ground1 * (cos_q - tau1_of_q_2_q_pin1)
        - cos_q_ground1 * (cos_q.mul_add(sin_q_pin1, sin_q) + sin_q * cos_q_pin1);
    // u - u_2_tau1_of_place_13
    let tau1_of_u_2 = u_2 - u_2_tau1_of_place_13;
    let tau1_of_u_2_2 = u_2_sin_angle_2_inv * tau1_of_place_19;
    // sin_angle_2_inv*u_2_sin_angle_2_inv*(u*tau1_of_place_19*cos(q_pin1) - sin(q_pin1)*cos(q - q_ground1
    //   + q_pin1)*(tau1_of_u_2 + tau1_of_u_2_2))
    let tau1_of_u_2_3 = sin_angle_2_inv * u_2_sin_angle_2_inv
        * (-sin_q_pin1 * cos_angle_2 * (tau1_of_u_2 + tau1_of_u_2_2)
            + u_2 * tau1_of_place_19 * cos_q_pin1);
    let tau1_of_u_2_4 = sin_q_pin2_sin_angle_inv * u_2_tau1_of_place_13;
    let tau1_of_u_2_5 = tau1_of_place_11 * u_2_tau1_of_place_13;
    // cos(q_ground1 - q_ground2 + q_pin2)*(tau1_of_u_2_5 - tau1_of_u_2_4)
    let tau1_of_u_2_6 = cos_angle * (tau1_of_u_2_5 - tau1_of_u_2_4);
    // tau1_of_place_10*u_2_tau1_of_place_13^2*cos(q_pin2) + tau1_of_u_2_3*sin(q_pin2)
    let tau1_of_u_2_7 = tau1_of_u_2_3
        .mul_add(
            sin_q_pin2,
            tau1_of_place_10 * u_2_tau1_of_place_13 * u_2_tau1_of_place_13 * cos_q_pin2,
        );
    // sin_angle_inv*(tau1_of_u_2_4*tau1_of_u_2_6 - tau1_of_u_2_7)
    let tau1_of_u_2_8 = sin_angle_inv * tau1_of_u_2_4.mul_add(tau1_of_u_2_6, -tau1_of_u_2_7);
    let tau1_of_u_2_9 = tau1_of_place_2 * tau1_of_u_2;
    // u*tau1_of_place_3*(tau1_of_u_2_9 +
    //   tau1_of_place_4*(tau1_of_place*u_2_tau1_of_place_13*tau1_of_place_19 +
    //   tau1_of_place*tau1_of_u_2*sin(q_pin1) - cos(q_pin1)*(tau1_of_place_2*tau1_of_u_2_2 +
    //   tau1_of_u_2_9)))
    let tau1_of_u_2_10 = u_2 * tau1_of_place_3
        * (tau1_of_u_2_9
            + tau1_of_place_4
                * (tau1_of_place * u_2_tau1_of_place_13 * tau1_of_place_19
                    + tau1_of_place * tau1_of_u_2 * sin_q_pin1
                    - cos_q_pin1 * tau1_of_place_2.mul_add(tau1_of_u_2_2, tau1_of_u_2_9)));
    let l_tau1_of_u_2_10 = l * tau1_of_u_2_10;
    // tau1_of_u_2_4*(tau1_of_place_6*cos(q_ground2) + tau1_of_place_8*sin(q_ground2)) -
    //   sin(q_ground2)*(u_2_tau1_of_place_13*sin(q_ground1) + tau1_of_place_7*tau1_of_u_2_5) +
    //   cos(q_ground2)*(tau1_of_place_5*tau1_of_u_2_5 - u_2_tau1_of_place_13*cos(q_ground1))
    let tau1_of_u_2_11 = tau1_of_u_2_4
        * tau1_of_place_8.mul_add(sin_q_ground2, tau1_of_place_6 * cos_q_ground2)
        - sin_q_ground2
            * tau1_of_place_7
                .mul_add(tau1_of_u_2_5, u_2_tau1_of_place_13 * sin_q_ground1)
        + cos_q_ground2
            * (-u_2_tau1_of_place_13)
                .mul_add(cos_q_ground1, tau1_of_place_5 * tau1_of_u_2_5);
    // tau1_of_place_11*tau1_of_u_2_3 + sin_angle_inv*u_2_tau1_of_place_13*(tau1_of_u_2_11 -
    //   tau1_of_place_10*tau1_of_u_2_6)
    let tau1_of_u_2_12 = sin_angle_inv * u_2_tau1_of_place_13
        * (-tau1_of_place_10).mul_add(tau1_of_u_2_6, tau1_of_u_2_11)
        + tau1_of_place_11 * tau1_of_u_2_3;
    let l_tau1_of_u_2_12 = l * tau1_of_u_2_12;
    // tau1_of_place_4*l_tau1_of_u_2_10 + tau1_of_place_14*l_tau1_of_u_2_12
    let tau1_of_u_2_13 = tau1_of_place_14
        .mul_add(l_tau1_of_u_2_12, tau1_of_place_4 * l_tau1_of_u_2_10);
    let l_tau1_of_u_2_3 = l * tau1_of_u_2_3;
    // l_m_l*tau1_of_place_4*tau1_of_u_2_10 + l_m_l*tau1_of_place_14*tau1_of_u_2_12
    let tau1_of_u_2_14 = (l_m_l * tau1_of_place_14)
        .mul_add(tau1_of_u_2_12, l_m_l * tau1_of_place_4 * tau1_of_u_2_10);
    // tau1_of_place_13*(l_m_l*tau1_of_u_2_3 + 15*m_l*l_tau1_of_u_2_3) -
    //   l_m_l*tau1_of_place_16*tau1_of_u_2_8
    let tau1_of_u_2_15 = tau1_of_place_13
        * (m_l * l_tau1_of_u_2_3).mul_add(S::int(15), l_m_l * tau1_of_u_2_3)
        - l_m_l * tau1_of_place_16 * tau1_of_u_2_8;
    // tau1_of_place_4*tau1_of_q_2_q_pin1 - tau1_of_place_5*tau1_of_place_14
    let tau1_of_place_20 = (-tau1_of_place_5)
        .mul_add(tau1_of_place_14, tau1_of_place_4 * tau1_of_q_2_q_pin1);
    // cos(q) + tau1_of_place_13*cos(q_ground1)
    let tau1_of_place_21 = tau1_of_place_13.mul_add(cos_q_ground1, cos_q);
    // tau1_of_place_16*cos(q_ground2) + tau1_of_place_20
    let tau1_of_place_22 = tau1_of_place_16.mul_add(cos_q_ground2, tau1_of_place_20);
    let u_2_sin_q_pin1 = u_2 * sin_q_pin1;
    let l_u_2_tau1_of_place_13 = l * u_2_tau1_of_place_13;
    let tau1_of_u_2_16 = l_u_2_tau1_of_place_13 * sin_q_pin2;
    // l*tau1_of_place_4*u_2_sin_q_pin1*(u + tau1_of_u_2_2) - l_tau1_of_u_2_10*cos(q_pin1)
    let tau1_of_u_2_17 = l * tau1_of_place_4 * u_2_sin_q_pin1 * (u_2 + tau1_of_u_2_2)
        - l_tau1_of_u_2_10 * cos_q_pin1;
    // m*(l*tau1_of_place_15*l_tau1_of_u_2_3 + tau1_of_place_14*l_u_2_tau1_of_place_13*tau1_of_u_2_16) +
    //   m_l*(tau1_of_place_13*(l_tau1_of_u_2_12*cos(q_pin2) - tau1_of_place_11*tau1_of_u_2_5*tau1_of_u_2_16)
    //   + tau1_of_u_2_17)
    let tau1_of_u_2_18 = m
        * (tau1_of_place_14 * l_u_2_tau1_of_place_13)
            .mul_add(tau1_of_u_2_16, l * tau1_of_place_15 * l_tau1_of_u_2_3)
        + m_l
            * (tau1_of_place_13
                * (-(tau1_of_place_11 * tau1_of_u_2_5))
                    .mul_add(tau1_of_u_2_16, l_tau1_of_u_2_12 * cos_q_pin2) + tau1_of_u_2_17);
    // u*l_m_l_tau1_of_place_4*u_2_sin_q_pin1 - tau1_of_u_2_18
    let tau1_of_u_2_19 = (u_2 * l_m_l_tau1_of_place_4)
        .mul_add(u_2_sin_q_pin1, -tau1_of_u_2_18);
    // tau1_of_u_2_14 + tau1_of_u_2_15
    let tau1_of_u_2_20 = tau1_of_u_2_14 + tau1_of_u_2_15;
    // g*m_l*(3*tau1_of_place_21 + tau1_of_place_22) - tau1_of_u_2_19
    let tau1_of_u_2_21 = g * m_l * tau1_of_place_21.mul_add(S::int(3), tau1_of_place_22)
        - tau1_of_u_2_19;
    // Values.
    // tau1 = 3*m*l*g*cos(q)/2 + 3*m*l*g*cos(q_ground1)*sin(q_pin1)/(2*sin(q - q_ground1 + q_pin1)) +
    //   m*l*g*cos(q + q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(2*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) +
    //   m*l*g*cos(q_ground2)*sin(q_pin1)*sin(q_pin2)/(2*sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l*g*sin(q_pin1)*cos(q_ground1 + q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/(2*sin(q - q_ground1 + q_pin1)) +
    //   m*l^2*u^2*sin(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(2*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) +
    //   5*m*l*sin(q_pin1)*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/(4*sin(q - q_ground1 + q_pin1)) +
    //   sin(q_pin1)*(m*l^2*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + m*l^2*u*sin(q_pin1)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*tan(q_ground1 - q - q_pin1)))/(12*sin(q - q_ground1 + q_pin1)) +
    //   m*l*sin(q_pin1)*sin(q_pin2)*(l*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + l*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + l*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   l*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(4*sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) +
    //   sin(q_pin1)*sin(q_pin2)*(m*l^2*u^2*cos(q_pin1)*sin(q_pin2)*(sin(q_ground1)*(cos(q) + cos(q +
    //   q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l^2*u^2*sin(q_pin1)^2*cos(q_pin2)*(sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 + q_pin2)^2) + m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u -
    //   u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) -
    //   cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)*tan(q_ground1 - q - q_pin1)) +
    //   m*l^2*u*sin(q_pin1)*sin(q_pin2)*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*sin(q_pin1)*sin(q_pin2)/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)) +
    //   u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q - q_ground1 +
    //   q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/(sin(q - q_ground1 + q_pin1)*sin(q_ground1 - q_ground2
    //   + q_pin2)*tan(q_ground2 - q_ground1 - q_pin2)))/(12*sin(q - q_ground1 + q_pin1)*sin(q_ground1 -
    //   q_ground2 + q_pin2)) + m*l*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)))^2)/(4*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + (sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))*(m*l^2*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
    //   u*sin(q)*sin(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1) -
    //   u*cos(q)*cos(q_ground1)*sin(q_pin1)/sin(q - q_ground1 + q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1)
    //   + cos(q)*cos(q_ground1)) + cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) +
    //   m*l^2*u*(cos(q)*sin(q_ground1) - sin(q)*cos(q_ground1))*(u*sin(q_pin1)*(cos(q)*sin(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1)))^2)/(12*(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))) + m*l*sin(q_pin1)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(1 + (sin(q_ground2)*(cos(q_ground1) +
    //   cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1
    //   - q_ground2 + q_pin2))*(u - u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) +
    //   cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q -
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1)) - l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1)
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/(4*sin(q - q_ground1 + q_pin1)) + sin(q_pin1)*(1 +
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
    //   q_pin2))/sin(q - q_ground1 + q_pin1))/(12*sin(q - q_ground1 + q_pin1)) +
    //   m*l*(l*u*sin(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))*(u + u*(sin(q_ground1)*(cos(q)
    //   + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q + q_pin1)))/sin(q - q_ground1 +
    //   q_pin1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) -
    //   cos(q_pin1)*(l*u*(u*sin(q)*sin(q_ground1) + u*cos(q)*cos(q_ground1) -
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
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2))/2 -
    //   m*l*sin(q_pin1)*(l*u*sin(q_pin1)*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 +
    //   q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(u*sin(q_pin1)/sin(q - q_ground1 + q_pin1) + u*sin(q_pin1)*(sin(q_ground2)*(cos(q_ground1)
    //   + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/(sin(q -
    //   q_ground1 + q_pin1)*sin(q_ground1 - q_ground2 + q_pin2)))/sin(q - q_ground1 + q_pin1) +
    //   cos(q_pin2)*(l*u*sin(q_pin1)*((sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
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
    //   q_ground1 + q_pin1)*tan(q_ground1 - q - q_pin1))))/(2*sin(q - q_ground1 + q_pin1)) +
    //   m*(l^2*u^2*sin(q_pin1)^3*sin(q_pin2)*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2))
    //   - cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))/sin(q - q_ground1 + q_pin1)^3 + l*sin(q_pin1)*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))*(l*u^2*cos(q_pin1)*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) +
    //   sin(q + q_pin1)))/sin(q - q_ground1 + q_pin1)^2 + l*u*sin(q_pin1)*(u - u*sin(q_pin1)/sin(q -
    //   q_ground1 + q_pin1) + u*(sin(q_ground1)*(cos(q) + cos(q + q_pin1)) - cos(q_ground1)*(sin(q) + sin(q
    //   + q_pin1)))/sin(q - q_ground1 + q_pin1))/(sin(q - q_ground1 + q_pin1)*tan(q_ground1 - q -
    //   q_pin1)))/sin(q - q_ground1 + q_pin1))/2 + u'*(4*m*l^2 + 4*m*l^2*sin(q_pin1)^2/sin(q - q_ground1 +
    //   q_pin1)^2 + 3*m*l^2*cos(q_pin1)*(cos(q)*sin(q_ground1) -
    //   sin(q)*cos(q_ground1))/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1))) + m*l^2*(sin(q)*cos(q_ground1) -
    //   cos(q)*sin(q_ground1))^2/(sin(q_pin1)*(sin(q)*sin(q_ground1) + cos(q)*cos(q_ground1)) +
    //   cos(q_pin1)*(sin(q)*cos(q_ground1) - cos(q)*sin(q_ground1)))^2 +
    //   m*l^2*sin(q_pin1)^2*sin(q_pin2)^2/(sin(q - q_ground1 + q_pin1)^2*sin(q_ground1 - q_ground2 +
    //   q_pin2)^2) + m*l^2*sin(q_pin1)^2*(1 + (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) -
    //   cos(q_ground2)*(sin(q_ground1) + sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 +
    //   q_pin2))^2/sin(q - q_ground1 + q_pin1)^2 + 3*m*l^2*sin(q_pin1)^2*cos(q_pin2)*(1 +
    //   (sin(q_ground2)*(cos(q_ground1) + cos(q_ground1 + q_pin2)) - cos(q_ground2)*(sin(q_ground1) +
    //   sin(q_ground1 + q_pin2)))/sin(q_ground1 - q_ground2 + q_pin2))/sin(q - q_ground1 + q_pin1)^2)/3
    let tau1 = S::ratio(1, 3) * u_dot
        * (l_m_l * (tau1_of_place_17 + tau1_of_place_18)
            - l_m_l_tau1_of_place_4 * cos_q_pin1.mul_add(S::int(3), -tau1_of_place_4))
        + S::ratio(1, 4) * m_l * (-(l * tau1_of_place_16)).mul_add(tau1_of_u_2_8, tau1_of_u_2_13)
        + S::ratio(1, 12) * tau1_of_u_2_20 + S::ratio(1, 2) * tau1_of_u_2_21;
    [tau1]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 117 convolutions and 220 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 6]],
    history: &mut [Factors<S, 120>],
) {
    let Parameters { m, l, g } = *p;
    let [q_2_0, q_ground1_0, q_ground2_0, q_pin1_0, q_pin2_0, u_2_0] = series[0];
    // Shared terms.
    let m_l_sq = m * l * l;
    let m_l_g = m * l * g;
    let m_l = m * l;
    // Constant in time.
    // minus_l = -l
    let minus_l = -l;
    // m_l_2 = m*l^2
    let m_l_2 = m_l_sq;
    // minus_m_l_2 = -m*l^2
    let minus_m_l_2 = -m_l_sq;
    // weight = 4*m*l^2
    let weight = S::int(4) * m_l_sq;
    // minus_3_m_l_2 = -3*m*l^2
    let minus_3_m_l_2 = -S::int(3) * m_l_sq;
    // weight_2 = 3*m*l^2
    let weight_2 = S::int(3) * m_l_sq;
    // weight_3 = 18*m*l*g
    let weight_3 = S::int(18) * m_l_g;
    // weight_4 = 6*m*l*g
    let weight_4 = S::int(6) * m_l_g;
    // minus_6_m_l_g = -6*m*l*g
    let minus_6_m_l_g = -S::int(6) * m_l_g;
    // weight_5 = 15*m*l
    let weight_5 = S::int(15) * m_l;
    // weight_6 = 3*m*l
    let weight_6 = S::int(3) * m_l;
    // weight_7 = 6*m*l^2
    let weight_7 = S::int(6) * m_l_sq;
    // minus_6_m_l = -6*m*l
    let minus_6_m_l = -S::int(6) * m_l;
    // minus_6_m_l_2 = -6*m*l^2
    let minus_6_m_l_2 = -S::int(6) * m_l_sq;
    // weight_8 = 6*m*l
    let weight_8 = S::int(6) * m_l;
    // Order 0.
    let (sin_q_pin1_0, cos_q_pin1_0) = q_pin1_0.sin_cos();
    let (sin_q_pin2_0, cos_q_pin2_0) = q_pin2_0.sin_cos();
    let (sin_q_0, cos_q_0) = q_2_0.sin_cos();
    let (sin_q_ground1_0, cos_q_ground1_0) = q_ground1_0.sin_cos();
    let q_2_plus_q_pin1_0 = q_2_0 + q_pin1_0;
    let (sin_q_plus_q_pin1_0, cos_q_plus_q_pin1_0) = q_2_plus_q_pin1_0.sin_cos();
    let u_dot_of_place_0 = q_2_0 + q_pin1_0 - q_ground1_0;
    let (sin_angle_0, cos_angle_0) = u_dot_of_place_0.sin_cos();
    let over_sin_angle = S::int(1) / sin_angle_0;
    let (sin_q_ground2_0, cos_q_ground2_0) = q_ground2_0.sin_cos();
    let q_ground1_plus_q_pin2_0 = q_ground1_0 + q_pin2_0;
    let (sin_q_ground1_plus_q_pin2_0, cos_q_ground1_plus_q_pin2_0) = q_ground1_plus_q_pin2_0
        .sin_cos();
    let u_dot_of_place_2_0 = q_ground1_0 + q_pin2_0 - q_ground2_0;
    let (sin_angle_2_0, cos_angle_2_0) = u_dot_of_place_2_0.sin_cos();
    let over_sin_angle_2 = S::int(1) / sin_angle_2_0;
    let u_dot_of_q_2_q_pin1_0 = sin_q_0 + sin_q_plus_q_pin1_0;
    let u_dot_of_q_2_q_pin1_2_0 = cos_q_0 + cos_q_plus_q_pin1_0;
    let u_dot_of_place_3_0 = sin_q_ground1_0 + sin_q_ground1_plus_q_pin2_0;
    let u_dot_of_place_4_0 = cos_q_ground1_0 + cos_q_ground1_plus_q_pin2_0;
    let sin_q_sin_q_ground1_0 = sin_q_0 * sin_q_ground1_0;
    let cos_q_cos_q_ground1_0 = cos_q_0 * cos_q_ground1_0;
    let u_dot_of_place_5_0 = sin_q_sin_q_ground1_0 + cos_q_cos_q_ground1_0;
    let u_dot_of_place_6_0 = sin_q_pin1_0 * u_dot_of_place_5_0;
    let sin_q_cos_q_ground1_0 = sin_q_0 * cos_q_ground1_0;
    let cos_q_sin_q_ground1_0 = cos_q_0 * sin_q_ground1_0;
    let u_dot_of_place_7_0 = sin_q_cos_q_ground1_0 - cos_q_sin_q_ground1_0;
    let u_dot_of_place_8_0 = cos_q_pin1_0 * u_dot_of_place_7_0;
    let u_dot_of_place_9_0 = u_dot_of_place_6_0 + u_dot_of_place_8_0;
    let over_u_dot_of_place_9 = S::int(1) / u_dot_of_place_9_0;
    let u_dot_of_place_10_0 = sin_q_ground1_0 * u_dot_of_q_2_q_pin1_2_0;
    let u_dot_of_place_11_0 = cos_q_ground1_0 * u_dot_of_q_2_q_pin1_0;
    let u_dot_of_place_12_0 = u_dot_of_place_10_0 - u_dot_of_place_11_0;
    let u_dot_of_place_13_0 = sin_q_ground2_0 * u_dot_of_place_4_0;
    let u_dot_of_place_14_0 = cos_q_ground2_0 * u_dot_of_place_3_0;
    let u_dot_of_place_15_0 = u_dot_of_place_13_0 - u_dot_of_place_14_0;
    let sin_q_pin1_sin_angle_inv_0 = sin_q_pin1_0 * over_sin_angle;
    let q_ground1_dot_2_0 = u_2_0 * sin_q_pin1_sin_angle_inv_0;
    let u_dot_of_place_16_0 = sin_q_pin2_0 * over_sin_angle_2;
    let q_ground2_dot_2_0 = q_ground1_dot_2_0 * u_dot_of_place_16_0;
    let u_2_sin_angle_inv_0 = u_2_0 * over_sin_angle;
    let q_pin1_dot_2_0 = u_dot_of_place_12_0 * u_2_sin_angle_inv_0;
    let u_dot_of_place_17_0 = u_dot_of_place_15_0 * over_sin_angle_2;
    let q_pin2_dot_2_0 = q_ground1_dot_2_0 * u_dot_of_place_17_0;
    let u_dot_of_u_2_0 = u_2_0 + q_pin1_dot_2_0;
    let u_dot_of_u_2_2_0 = q_ground1_dot_2_0 + q_pin2_dot_2_0;
    let u_dot_of_place_18_0 = S::int(1) + u_dot_of_place_17_0;
    let u_dot_of_place_19_0 = cos_q_ground1_0 * sin_q_pin1_sin_angle_inv_0;
    let u_dot_of_place_20_0 = sin_q_pin1_sin_angle_inv_0 * u_dot_of_place_16_0;
    let u_dot_of_place_21_0 = cos_q_ground2_0 * u_dot_of_place_20_0;
    let u_dot_of_place_22_0 = u_dot_of_place_7_0 * over_u_dot_of_place_9;
    let u_dot_of_place_23_0 = cos_q_plus_q_pin1_0 * u_dot_of_place_22_0;
    let u_dot_of_place_24_0 = u_dot_of_place_18_0 * sin_q_pin1_sin_angle_inv_0;
    let u_dot_of_place_25_0 = cos_q_ground1_plus_q_pin2_0 * u_dot_of_place_24_0;
    let u_dot_of_u_2_3_0 = u_2_0 - q_ground1_dot_2_0 + q_pin1_dot_2_0;
    let u_dot_of_u_2_4_0 = cos_q_pin1_0 * q_pin1_dot_2_0;
    let u_dot_of_u_2_5_0 = u_2_sin_angle_inv_0 * u_dot_of_u_2_4_0;
    let sin_angle_inv_cos_angle_0 = cos_angle_0 * over_sin_angle;
    let u_dot_of_u_2_6_0 = u_dot_of_u_2_3_0 * sin_angle_inv_cos_angle_0;
    let u_dot_of_u_2_7_0 = q_ground1_dot_2_0 * u_dot_of_u_2_6_0;
    let u_dot_of_u_2_8_0 = u_dot_of_u_2_7_0.mul_add(minus_l, l * u_dot_of_u_2_5_0);
    let u_dot_of_u_2_9_0 = u_dot_of_u_2_7_0
        .mul_add(minus_m_l_2, m_l_2 * u_dot_of_u_2_5_0);
    let u_dot_of_u_2_10_0 = q_ground1_dot_2_0 - q_ground2_dot_2_0 + q_pin2_dot_2_0;
    let u_dot_of_u_2_11_0 = u_dot_of_place_16_0 * u_dot_of_u_2_5_0;
    let u_dot_of_place_26_0 = cos_q_pin2_0 * over_sin_angle_2;
    let u_dot_of_u_2_12_0 = q_ground1_dot_2_0 * q_pin2_dot_2_0;
    let u_dot_of_u_2_13_0 = u_dot_of_place_26_0 * u_dot_of_u_2_12_0;
    let u_dot_of_u_2_14_0 = q_ground2_dot_2_0 * u_dot_of_u_2_6_0;
    let u_dot_of_place_27_0 = cos_angle_2_0 * over_sin_angle_2;
    let u_dot_of_u_2_15_0 = u_dot_of_u_2_10_0 * u_dot_of_place_27_0;
    let u_dot_of_u_2_16_0 = q_ground2_dot_2_0 * u_dot_of_u_2_15_0;
    let u_dot_of_u_2_17_0 = u_dot_of_u_2_16_0
        .mul_add(
            minus_l,
            u_dot_of_u_2_13_0
                .mul_add(l, u_dot_of_u_2_11_0.mul_add(l, minus_l * u_dot_of_u_2_14_0)),
        );
    let u_dot_of_u_2_18_0 = u_dot_of_u_2_16_0
        .mul_add(
            minus_m_l_2,
            u_dot_of_u_2_13_0
                .mul_add(
                    m_l_2,
                    u_dot_of_u_2_11_0.mul_add(m_l_2, minus_m_l_2 * u_dot_of_u_2_14_0),
                ),
        );
    let u_dot_of_u_2_19_0 = cos_q_ground1_0 * q_ground1_dot_2_0;
    let u_dot_of_u_2_20_0 = sin_q_ground1_0 * q_ground1_dot_2_0;
    let u_2_cos_q_sin_q_ground1_0 = u_2_0 * cos_q_sin_q_ground1_0;
    let u_dot_of_u_2_21_0 = q_ground1_dot_2_0 * sin_q_cos_q_ground1_0;
    let u_2_sin_q_cos_q_ground1_0 = u_2_0 * sin_q_cos_q_ground1_0;
    let u_dot_of_u_2_22_0 = q_ground1_dot_2_0 * cos_q_sin_q_ground1_0;
    let u_dot_of_u_2_23_0 = u_2_cos_q_sin_q_ground1_0 - u_2_sin_q_cos_q_ground1_0
        + u_dot_of_u_2_21_0 - u_dot_of_u_2_22_0;
    let u_dot_of_u_2_24_0 = u_dot_of_place_5_0 * u_dot_of_u_2_4_0;
    let u_dot_of_u_2_25_0 = sin_q_pin1_0 * u_dot_of_u_2_23_0;
    let u_2_cos_q_cos_q_ground1_0 = u_2_0 * cos_q_cos_q_ground1_0;
    let u_dot_of_u_2_26_0 = q_ground1_dot_2_0 * sin_q_sin_q_ground1_0;
    let u_2_sin_q_sin_q_ground1_0 = u_2_0 * sin_q_sin_q_ground1_0;
    let u_dot_of_u_2_27_0 = q_ground1_dot_2_0 * cos_q_cos_q_ground1_0;
    let u_dot_of_u_2_28_0 = u_2_cos_q_cos_q_ground1_0 + u_2_sin_q_sin_q_ground1_0
        - u_dot_of_u_2_26_0 - u_dot_of_u_2_27_0;
    let u_dot_of_place_28_0 = u_dot_of_place_7_0 * u_dot_of_place_12_0;
    let u_dot_of_u_2_29_0 = q_ground1_dot_2_0 * u_dot_of_place_28_0;
    let u_dot_of_u_2_30_0 = cos_q_pin1_0 * u_dot_of_u_2_28_0;
    let u_dot_of_u_2_31_0 = -u_dot_of_u_2_29_0 + u_dot_of_u_2_25_0 + u_dot_of_u_2_30_0
        + u_dot_of_u_2_24_0;
    let u_dot_of_u_2_32_0 = u_2_0 * over_u_dot_of_place_9;
    let u_dot_of_u_2_33_0 = u_dot_of_u_2_28_0 * u_dot_of_u_2_32_0;
    let u_dot_of_u_2_34_0 = u_dot_of_u_2_31_0 * u_dot_of_place_22_0;
    let u_dot_of_u_2_35_0 = u_dot_of_u_2_32_0 * u_dot_of_u_2_34_0;
    let u_dot_of_u_2_36_0 = u_dot_of_u_2_35_0.mul_add(minus_l, l * u_dot_of_u_2_33_0);
    let u_dot_of_u_2_37_0 = u_dot_of_u_2_35_0
        .mul_add(minus_m_l_2, m_l_2 * u_dot_of_u_2_33_0);
    let u_dot_of_u_2_38_0 = cos_q_ground1_plus_q_pin2_0 * u_dot_of_u_2_2_0;
    let u_dot_of_u_2_39_0 = sin_q_ground1_plus_q_pin2_0 * u_dot_of_u_2_2_0;
    let u_dot_of_u_2_40_0 = u_dot_of_u_2_19_0 + u_dot_of_u_2_38_0;
    let u_dot_of_place_29_0 = cos_q_ground2_0 * u_dot_of_place_4_0;
    let u_dot_of_u_2_41_0 = q_ground2_dot_2_0 * u_dot_of_place_29_0;
    let u_dot_of_u_2_42_0 = u_dot_of_u_2_20_0 + u_dot_of_u_2_39_0;
    let u_dot_of_u_2_43_0 = sin_q_ground2_0 * u_dot_of_u_2_42_0;
    let u_dot_of_place_30_0 = sin_q_ground2_0 * u_dot_of_place_3_0;
    let u_dot_of_u_2_44_0 = q_ground2_dot_2_0 * u_dot_of_place_30_0;
    let u_dot_of_u_2_45_0 = cos_q_ground2_0 * u_dot_of_u_2_40_0;
    let u_dot_of_u_2_46_0 = u_dot_of_u_2_41_0 + u_dot_of_u_2_44_0 - u_dot_of_u_2_43_0
        - u_dot_of_u_2_45_0;
    let u_dot_of_u_2_47_0 = u_dot_of_place_17_0 * u_dot_of_u_2_15_0;
    let u_dot_of_u_2_48_0 = u_dot_of_u_2_46_0 * over_sin_angle_2;
    let u_dot_of_u_2_49_0 = u_dot_of_place_18_0 * u_dot_of_u_2_5_0;
    let u_dot_of_u_2_50_0 = u_dot_of_place_18_0 * u_dot_of_u_2_7_0;
    let u_dot_of_u_2_51_0 = u_dot_of_u_2_47_0 - u_dot_of_u_2_48_0;
    let u_dot_of_u_2_52_0 = u_dot_of_u_2_51_0 * q_ground1_dot_2_0;
    let u_dot_of_u_2_53_0 = u_dot_of_u_2_52_0
        .mul_add(minus_l, u_dot_of_u_2_50_0.mul_add(minus_l, l * u_dot_of_u_2_49_0));
    let u_dot_of_u_2_54_0 = u_dot_of_u_2_52_0
        .mul_add(
            minus_m_l_2,
            u_dot_of_u_2_50_0.mul_add(minus_m_l_2, m_l_2 * u_dot_of_u_2_49_0),
        );
    let u_dot_of_place_31_0 = sin_q_pin1_sin_angle_inv_0 * sin_q_pin1_sin_angle_inv_0;
    let u_dot_of_place_32_0 = u_dot_of_place_20_0 * u_dot_of_place_20_0;
    let u_dot_of_place_33_0 = cos_q_pin1_0 * u_dot_of_place_22_0;
    let u_dot_of_place_34_0 = u_dot_of_place_22_0 * u_dot_of_place_22_0;
    let u_dot_of_place_35_0 = cos_q_pin2_0 * u_dot_of_place_24_0;
    let u_dot_of_place_36_0 = sin_q_pin1_sin_angle_inv_0 * u_dot_of_place_35_0;
    let u_dot_of_place_37_0 = u_dot_of_place_24_0 * u_dot_of_place_24_0;
    let u_dot_of_u_2_55_0 = u_dot_of_u_2_8_0 * sin_q_pin1_sin_angle_inv_0;
    let u_dot_of_u_2_56_0 = u_dot_of_u_2_9_0 * sin_q_pin1_sin_angle_inv_0;
    let u_dot_of_u_2_57_0 = u_dot_of_u_2_17_0 * u_dot_of_place_20_0;
    let u_dot_of_u_2_58_0 = u_dot_of_u_2_18_0 * u_dot_of_place_20_0;
    let u_2_sin_q_pin1_0 = u_2_0 * sin_q_pin1_0;
    let u_dot_of_u_2_59_0 = u_dot_of_place_22_0 * u_2_sin_q_pin1_0;
    let u_dot_of_u_2_60_0 = u_dot_of_u_2_0 * u_dot_of_u_2_59_0;
    let u_dot_of_u_2_61_0 = cos_q_pin1_0 * u_dot_of_u_2_36_0;
    let u_dot_of_u_2_62_0 = u_2_0 * u_dot_of_u_2_59_0;
    let u_dot_of_u_2_63_0 = u_dot_of_u_2_36_0 * u_dot_of_place_22_0;
    let u_dot_of_u_2_64_0 = u_dot_of_u_2_37_0 * u_dot_of_place_22_0;
    let u_dot_of_u_2_65_0 = sin_q_pin2_0 * q_ground1_dot_2_0;
    let u_dot_of_u_2_66_0 = u_dot_of_place_18_0 * u_dot_of_u_2_65_0;
    let u_dot_of_u_2_67_0 = u_dot_of_u_2_2_0 * u_dot_of_u_2_66_0;
    let u_dot_of_u_2_68_0 = cos_q_pin2_0 * u_dot_of_u_2_53_0;
    let u_dot_of_u_2_69_0 = l * u_dot_of_u_2_67_0 - u_dot_of_u_2_68_0;
    let u_dot_of_u_2_70_0 = u_dot_of_u_2_69_0 * sin_q_pin1_sin_angle_inv_0;
    let u_dot_of_u_2_71_0 = q_ground1_dot_2_0 * u_dot_of_u_2_65_0;
    let u_dot_of_u_2_72_0 = u_dot_of_place_24_0 * u_dot_of_u_2_71_0;
    let u_dot_of_u_2_73_0 = u_dot_of_u_2_8_0 * u_dot_of_place_35_0;
    let u_dot_of_u_2_74_0 = u_dot_of_u_2_53_0 * u_dot_of_place_24_0;
    let u_dot_of_u_2_75_0 = u_dot_of_u_2_54_0 * u_dot_of_place_24_0;
    let u_dot_of_place_38_0 = u_dot_of_place_36_0
        .mul_add(
            weight_2,
            u_dot_of_place_37_0
                .mul_add(
                    m_l_2,
                    u_dot_of_place_34_0
                        .mul_add(
                            m_l_2,
                            u_dot_of_place_33_0
                                .mul_add(
                                    minus_3_m_l_2,
                                    u_dot_of_place_32_0
                                        .mul_add(m_l_2, u_dot_of_place_31_0.mul_add(weight, weight)),
                                ),
                        ),
                ),
        );
    let over_u_dot_of_place_38 = S::int(1) / u_dot_of_place_38_0;
    let u_dot_of_u_2_76_0 = u_dot_of_u_2_70_0
        .mul_add(
            minus_6_m_l,
            u_dot_of_u_2_74_0
                .mul_add(
                    weight_6,
                    u_dot_of_u_2_63_0
                        .mul_add(
                            weight_6,
                            u_dot_of_u_2_61_0
                                .mul_add(
                                    minus_6_m_l,
                                    u_dot_of_u_2_57_0
                                        .mul_add(
                                            weight_6,
                                            u_dot_of_u_2_73_0
                                                .mul_add(
                                                    weight_8,
                                                    u_dot_of_u_2_55_0
                                                        .mul_add(
                                                            weight_5,
                                                            u_dot_of_u_2_72_0
                                                                .mul_add(
                                                                    weight_7,
                                                                    u_dot_of_u_2_62_0
                                                                        .mul_add(
                                                                            minus_6_m_l_2,
                                                                            u_dot_of_u_2_60_0
                                                                                .mul_add(
                                                                                    weight_7,
                                                                                    u_dot_of_place_25_0
                                                                                        .mul_add(
                                                                                            weight_4,
                                                                                            u_dot_of_place_23_0
                                                                                                .mul_add(
                                                                                                    minus_6_m_l_g,
                                                                                                    u_dot_of_place_21_0
                                                                                                        .mul_add(
                                                                                                            weight_4,
                                                                                                            u_dot_of_place_19_0.mul_add(weight_3, weight_3 * cos_q_0),
                                                                                                        ),
                                                                                                ),
                                                                                        ),
                                                                                ),
                                                                        ),
                                                                ),
                                                        ) + u_dot_of_u_2_56_0,
                                                ),
                                        ) + u_dot_of_u_2_58_0,
                                ),
                        ) + u_dot_of_u_2_64_0,
                ) + u_dot_of_u_2_75_0,
        );
    let u_dot_of_u_2_77_0 = u_dot_of_u_2_76_0 * over_u_dot_of_place_38;
    // Order 1: the rates, and what follows from them.
    let q_2_1 = u_2_0;
    let q_ground1_1 = q_ground1_dot_2_0;
    let q_ground2_1 = q_ground2_dot_2_0;
    let q_pin1_1 = q_pin1_dot_2_0;
    let q_pin2_1 = q_pin2_dot_2_0;
    let u_2_1 = -S::ratio(1, 4) * u_dot_of_u_2_77_0;
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
    let q_2_plus_q_pin1_1 = q_2_1 + q_pin1_1;
    let sin_q_plus_q_pin1_1 = q_2_plus_q_pin1_1 * cos_q_plus_q_pin1_0;
    let cos_q_plus_q_pin1_1 = -q_2_plus_q_pin1_1 * sin_q_plus_q_pin1_0;
    let u_dot_of_place_1 = q_2_1 + q_pin1_1 - q_ground1_1;
    let sin_angle_1 = u_dot_of_place_1 * cos_angle_0;
    let cos_angle_1 = -u_dot_of_place_1 * sin_angle_0;
    let sin_q_ground2_1 = q_ground2_1 * cos_q_ground2_0;
    let cos_q_ground2_1 = -q_ground2_1 * sin_q_ground2_0;
    let q_ground1_plus_q_pin2_1 = q_ground1_1 + q_pin2_1;
    let sin_q_ground1_plus_q_pin2_1 = q_ground1_plus_q_pin2_1 * cos_q_ground1_plus_q_pin2_0;
    let cos_q_ground1_plus_q_pin2_1 = -q_ground1_plus_q_pin2_1 * sin_q_ground1_plus_q_pin2_0;
    let u_dot_of_place_2_1 = q_ground1_1 + q_pin2_1 - q_ground2_1;
    let sin_angle_2_1 = u_dot_of_place_2_1 * cos_angle_2_0;
    let cos_angle_2_1 = -u_dot_of_place_2_1 * sin_angle_2_0;
    let u_dot_of_q_2_q_pin1_1 = sin_q_1 + sin_q_plus_q_pin1_1;
    let u_dot_of_q_2_q_pin1_2_1 = cos_q_1 + cos_q_plus_q_pin1_1;
    let u_dot_of_place_3_1 = sin_q_ground1_1 + sin_q_ground1_plus_q_pin2_1;
    let u_dot_of_place_4_1 = cos_q_ground1_1 + cos_q_ground1_plus_q_pin2_1;
    let sin_q_sin_q_ground1_1 = sin_q_ground1_1
        .mul_add(sin_q_0, sin_q_1 * sin_q_ground1_0);
    let cos_q_cos_q_ground1_1 = cos_q_ground1_1
        .mul_add(cos_q_0, cos_q_1 * cos_q_ground1_0);
    let u_dot_of_place_5_1 = sin_q_sin_q_ground1_1 + cos_q_cos_q_ground1_1;
    let u_dot_of_place_6_1 = u_dot_of_place_5_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * u_dot_of_place_5_0);
    let sin_q_cos_q_ground1_1 = cos_q_ground1_1
        .mul_add(sin_q_0, sin_q_1 * cos_q_ground1_0);
    let cos_q_sin_q_ground1_1 = sin_q_ground1_1
        .mul_add(cos_q_0, cos_q_1 * sin_q_ground1_0);
    let u_dot_of_place_7_1 = sin_q_cos_q_ground1_1 - cos_q_sin_q_ground1_1;
    let u_dot_of_place_8_1 = u_dot_of_place_7_1
        .mul_add(cos_q_pin1_0, cos_q_pin1_1 * u_dot_of_place_7_0);
    let u_dot_of_place_9_1 = u_dot_of_place_6_1 + u_dot_of_place_8_1;
    let u_dot_of_place_10_1 = u_dot_of_q_2_q_pin1_2_1
        .mul_add(sin_q_ground1_0, sin_q_ground1_1 * u_dot_of_q_2_q_pin1_2_0);
    let u_dot_of_place_11_1 = u_dot_of_q_2_q_pin1_1
        .mul_add(cos_q_ground1_0, cos_q_ground1_1 * u_dot_of_q_2_q_pin1_0);
    let u_dot_of_place_12_1 = u_dot_of_place_10_1 - u_dot_of_place_11_1;
    let u_dot_of_place_13_1 = u_dot_of_place_4_1
        .mul_add(sin_q_ground2_0, sin_q_ground2_1 * u_dot_of_place_4_0);
    let u_dot_of_place_14_1 = u_dot_of_place_3_1
        .mul_add(cos_q_ground2_0, cos_q_ground2_1 * u_dot_of_place_3_0);
    let u_dot_of_place_15_1 = u_dot_of_place_13_1 - u_dot_of_place_14_1;
    let sin_q_pin1_sin_angle_inv_1 = sin_angle_1
        .mul_add(
            -(sin_q_pin1_sin_angle_inv_0 * over_sin_angle),
            sin_q_pin1_1 * over_sin_angle,
        );
    let q_ground1_dot_2_1 = sin_q_pin1_sin_angle_inv_1
        .mul_add(u_2_0, u_2_1 * sin_q_pin1_sin_angle_inv_0);
    let u_dot_of_place_16_1 = sin_angle_2_1
        .mul_add(
            -(u_dot_of_place_16_0 * over_sin_angle_2),
            sin_q_pin2_1 * over_sin_angle_2,
        );
    let q_ground2_dot_2_1 = q_ground1_dot_2_1
        .mul_add(u_dot_of_place_16_0, u_dot_of_place_16_1 * q_ground1_dot_2_0);
    let u_2_sin_angle_inv_1 = sin_angle_1
        .mul_add(-(u_2_sin_angle_inv_0 * over_sin_angle), u_2_1 * over_sin_angle);
    let q_pin1_dot_2_1 = u_dot_of_place_12_1
        .mul_add(u_2_sin_angle_inv_0, u_2_sin_angle_inv_1 * u_dot_of_place_12_0);
    let u_dot_of_place_17_1 = sin_angle_2_1
        .mul_add(
            -(u_dot_of_place_17_0 * over_sin_angle_2),
            u_dot_of_place_15_1 * over_sin_angle_2,
        );
    let q_pin2_dot_2_1 = u_dot_of_place_17_1
        .mul_add(q_ground1_dot_2_0, q_ground1_dot_2_1 * u_dot_of_place_17_0);
    let u_dot_of_u_2_1 = u_2_1 + q_pin1_dot_2_1;
    let u_dot_of_u_2_2_1 = q_ground1_dot_2_1 + q_pin2_dot_2_1;
    let u_dot_of_place_18_1 = u_dot_of_place_17_1;
    let u_dot_of_place_19_1 = sin_q_pin1_sin_angle_inv_1
        .mul_add(cos_q_ground1_0, cos_q_ground1_1 * sin_q_pin1_sin_angle_inv_0);
    let u_dot_of_place_20_1 = u_dot_of_place_16_1
        .mul_add(
            sin_q_pin1_sin_angle_inv_0,
            sin_q_pin1_sin_angle_inv_1 * u_dot_of_place_16_0,
        );
    let u_dot_of_place_21_1 = u_dot_of_place_20_1
        .mul_add(cos_q_ground2_0, cos_q_ground2_1 * u_dot_of_place_20_0);
    let u_dot_of_place_22_1 = u_dot_of_place_9_1
        .mul_add(
            -(u_dot_of_place_22_0 * over_u_dot_of_place_9),
            u_dot_of_place_7_1 * over_u_dot_of_place_9,
        );
    let u_dot_of_place_23_1 = u_dot_of_place_22_1
        .mul_add(cos_q_plus_q_pin1_0, cos_q_plus_q_pin1_1 * u_dot_of_place_22_0);
    let u_dot_of_place_24_1 = u_dot_of_place_18_1
        .mul_add(
            sin_q_pin1_sin_angle_inv_0,
            sin_q_pin1_sin_angle_inv_1 * u_dot_of_place_18_0,
        );
    let u_dot_of_place_25_1 = u_dot_of_place_24_1
        .mul_add(
            cos_q_ground1_plus_q_pin2_0,
            cos_q_ground1_plus_q_pin2_1 * u_dot_of_place_24_0,
        );
    let u_dot_of_u_2_3_1 = u_2_1 - q_ground1_dot_2_1 + q_pin1_dot_2_1;
    let u_dot_of_u_2_4_1 = q_pin1_dot_2_1
        .mul_add(cos_q_pin1_0, cos_q_pin1_1 * q_pin1_dot_2_0);
    let u_dot_of_u_2_5_1 = u_dot_of_u_2_4_1
        .mul_add(u_2_sin_angle_inv_0, u_2_sin_angle_inv_1 * u_dot_of_u_2_4_0);
    let sin_angle_inv_cos_angle_1 = sin_angle_1
        .mul_add(
            -(sin_angle_inv_cos_angle_0 * over_sin_angle),
            cos_angle_1 * over_sin_angle,
        );
    let u_dot_of_u_2_6_1 = u_dot_of_u_2_3_1
        .mul_add(
            sin_angle_inv_cos_angle_0,
            sin_angle_inv_cos_angle_1 * u_dot_of_u_2_3_0,
        );
    let u_dot_of_u_2_7_1 = u_dot_of_u_2_6_1
        .mul_add(q_ground1_dot_2_0, q_ground1_dot_2_1 * u_dot_of_u_2_6_0);
    let u_dot_of_u_2_8_1 = u_dot_of_u_2_7_1.mul_add(minus_l, l * u_dot_of_u_2_5_1);
    let u_dot_of_u_2_9_1 = u_dot_of_u_2_7_1
        .mul_add(minus_m_l_2, m_l_2 * u_dot_of_u_2_5_1);
    let u_dot_of_u_2_10_1 = q_ground1_dot_2_1 - q_ground2_dot_2_1 + q_pin2_dot_2_1;
    let u_dot_of_u_2_11_1 = u_dot_of_u_2_5_1
        .mul_add(u_dot_of_place_16_0, u_dot_of_place_16_1 * u_dot_of_u_2_5_0);
    let u_dot_of_place_26_1 = sin_angle_2_1
        .mul_add(
            -(u_dot_of_place_26_0 * over_sin_angle_2),
            cos_q_pin2_1 * over_sin_angle_2,
        );
    let u_dot_of_u_2_12_1 = q_pin2_dot_2_1
        .mul_add(q_ground1_dot_2_0, q_ground1_dot_2_1 * q_pin2_dot_2_0);
    let u_dot_of_u_2_13_1 = u_dot_of_u_2_12_1
        .mul_add(u_dot_of_place_26_0, u_dot_of_place_26_1 * u_dot_of_u_2_12_0);
    let u_dot_of_u_2_14_1 = u_dot_of_u_2_6_1
        .mul_add(q_ground2_dot_2_0, q_ground2_dot_2_1 * u_dot_of_u_2_6_0);
    let u_dot_of_place_27_1 = sin_angle_2_1
        .mul_add(
            -(u_dot_of_place_27_0 * over_sin_angle_2),
            cos_angle_2_1 * over_sin_angle_2,
        );
    let u_dot_of_u_2_15_1 = u_dot_of_u_2_10_1
        .mul_add(u_dot_of_place_27_0, u_dot_of_place_27_1 * u_dot_of_u_2_10_0);
    let u_dot_of_u_2_16_1 = u_dot_of_u_2_15_1
        .mul_add(q_ground2_dot_2_0, q_ground2_dot_2_1 * u_dot_of_u_2_15_0);
    let u_dot_of_u_2_17_1 = u_dot_of_u_2_16_1
        .mul_add(
            minus_l,
            u_dot_of_u_2_13_1
                .mul_add(l, u_dot_of_u_2_11_1.mul_add(l, minus_l * u_dot_of_u_2_14_1)),
        );
    let u_dot_of_u_2_18_1 = u_dot_of_u_2_16_1
        .mul_add(
            minus_m_l_2,
            u_dot_of_u_2_13_1
                .mul_add(
                    m_l_2,
                    u_dot_of_u_2_11_1.mul_add(m_l_2, minus_m_l_2 * u_dot_of_u_2_14_1),
                ),
        );
    let u_dot_of_u_2_19_1 = q_ground1_dot_2_1
        .mul_add(cos_q_ground1_0, cos_q_ground1_1 * q_ground1_dot_2_0);
    let u_dot_of_u_2_20_1 = q_ground1_dot_2_1
        .mul_add(sin_q_ground1_0, sin_q_ground1_1 * q_ground1_dot_2_0);
    let u_2_cos_q_sin_q_ground1_1 = cos_q_sin_q_ground1_1
        .mul_add(u_2_0, u_2_1 * cos_q_sin_q_ground1_0);
    let u_dot_of_u_2_21_1 = q_ground1_dot_2_1
        .mul_add(sin_q_cos_q_ground1_0, sin_q_cos_q_ground1_1 * q_ground1_dot_2_0);
    let u_2_sin_q_cos_q_ground1_1 = sin_q_cos_q_ground1_1
        .mul_add(u_2_0, u_2_1 * sin_q_cos_q_ground1_0);
    let u_dot_of_u_2_22_1 = q_ground1_dot_2_1
        .mul_add(cos_q_sin_q_ground1_0, cos_q_sin_q_ground1_1 * q_ground1_dot_2_0);
    let u_dot_of_u_2_23_1 = u_2_cos_q_sin_q_ground1_1 - u_2_sin_q_cos_q_ground1_1
        + u_dot_of_u_2_21_1 - u_dot_of_u_2_22_1;
    let u_dot_of_u_2_24_1 = u_dot_of_u_2_4_1
        .mul_add(u_dot_of_place_5_0, u_dot_of_place_5_1 * u_dot_of_u_2_4_0);
    let u_dot_of_u_2_25_1 = u_dot_of_u_2_23_1
        .mul_add(sin_q_pin1_0, sin_q_pin1_1 * u_dot_of_u_2_23_0);
    let u_2_cos_q_cos_q_ground1_1 = cos_q_cos_q_ground1_1
        .mul_add(u_2_0, u_2_1 * cos_q_cos_q_ground1_0);
    let u_dot_of_u_2_26_1 = q_ground1_dot_2_1
        .mul_add(sin_q_sin_q_ground1_0, sin_q_sin_q_ground1_1 * q_ground1_dot_2_0);
    let u_2_sin_q_sin_q_ground1_1 = sin_q_sin_q_ground1_1
        .mul_add(u_2_0, u_2_1 * sin_q_sin_q_ground1_0);
    let u_dot_of_u_2_27_1 = q_ground1_dot_2_1
        .mul_add(cos_q_cos_q_ground1_0, cos_q_cos_q_ground1_1 * q_ground1_dot_2_0);
    let u_dot_of_u_2_28_1 = u_2_cos_q_cos_q_ground1_1 + u_2_sin_q_sin_q_ground1_1
        - u_dot_of_u_2_26_1 - u_dot_of_u_2_27_1;
    let u_dot_of_place_28_1 = u_dot_of_place_12_1
        .mul_add(u_dot_of_place_7_0, u_dot_of_place_7_1 * u_dot_of_place_12_0);
    let u_dot_of_u_2_29_1 = u_dot_of_place_28_1
        .mul_add(q_ground1_dot_2_0, q_ground1_dot_2_1 * u_dot_of_place_28_0);
    let u_dot_of_u_2_30_1 = u_dot_of_u_2_28_1
        .mul_add(cos_q_pin1_0, cos_q_pin1_1 * u_dot_of_u_2_28_0);
    let u_dot_of_u_2_31_1 = -u_dot_of_u_2_29_1 + u_dot_of_u_2_25_1 + u_dot_of_u_2_30_1
        + u_dot_of_u_2_24_1;
    let u_dot_of_u_2_32_1 = u_dot_of_place_9_1
        .mul_add(
            -(u_dot_of_u_2_32_0 * over_u_dot_of_place_9),
            u_2_1 * over_u_dot_of_place_9,
        );
    let u_dot_of_u_2_33_1 = u_dot_of_u_2_32_1
        .mul_add(u_dot_of_u_2_28_0, u_dot_of_u_2_28_1 * u_dot_of_u_2_32_0);
    let u_dot_of_u_2_34_1 = u_dot_of_u_2_31_1
        .mul_add(u_dot_of_place_22_0, u_dot_of_place_22_1 * u_dot_of_u_2_31_0);
    let u_dot_of_u_2_35_1 = u_dot_of_u_2_34_1
        .mul_add(u_dot_of_u_2_32_0, u_dot_of_u_2_32_1 * u_dot_of_u_2_34_0);
    let u_dot_of_u_2_36_1 = u_dot_of_u_2_35_1.mul_add(minus_l, l * u_dot_of_u_2_33_1);
    let u_dot_of_u_2_37_1 = u_dot_of_u_2_35_1
        .mul_add(minus_m_l_2, m_l_2 * u_dot_of_u_2_33_1);
    let u_dot_of_u_2_38_1 = u_dot_of_u_2_2_1
        .mul_add(
            cos_q_ground1_plus_q_pin2_0,
            cos_q_ground1_plus_q_pin2_1 * u_dot_of_u_2_2_0,
        );
    let u_dot_of_u_2_39_1 = u_dot_of_u_2_2_1
        .mul_add(
            sin_q_ground1_plus_q_pin2_0,
            sin_q_ground1_plus_q_pin2_1 * u_dot_of_u_2_2_0,
        );
    let u_dot_of_u_2_40_1 = u_dot_of_u_2_19_1 + u_dot_of_u_2_38_1;
    let u_dot_of_place_29_1 = u_dot_of_place_4_1
        .mul_add(cos_q_ground2_0, cos_q_ground2_1 * u_dot_of_place_4_0);
    let u_dot_of_u_2_41_1 = q_ground2_dot_2_1
        .mul_add(u_dot_of_place_29_0, u_dot_of_place_29_1 * q_ground2_dot_2_0);
    let u_dot_of_u_2_42_1 = u_dot_of_u_2_20_1 + u_dot_of_u_2_39_1;
    let u_dot_of_u_2_43_1 = u_dot_of_u_2_42_1
        .mul_add(sin_q_ground2_0, sin_q_ground2_1 * u_dot_of_u_2_42_0);
    let u_dot_of_place_30_1 = u_dot_of_place_3_1
        .mul_add(sin_q_ground2_0, sin_q_ground2_1 * u_dot_of_place_3_0);
    let u_dot_of_u_2_44_1 = q_ground2_dot_2_1
        .mul_add(u_dot_of_place_30_0, u_dot_of_place_30_1 * q_ground2_dot_2_0);
    let u_dot_of_u_2_45_1 = u_dot_of_u_2_40_1
        .mul_add(cos_q_ground2_0, cos_q_ground2_1 * u_dot_of_u_2_40_0);
    let u_dot_of_u_2_46_1 = u_dot_of_u_2_41_1 + u_dot_of_u_2_44_1 - u_dot_of_u_2_43_1
        - u_dot_of_u_2_45_1;
    let u_dot_of_u_2_47_1 = u_dot_of_u_2_15_1
        .mul_add(u_dot_of_place_17_0, u_dot_of_place_17_1 * u_dot_of_u_2_15_0);
    let u_dot_of_u_2_48_1 = sin_angle_2_1
        .mul_add(
            -(u_dot_of_u_2_48_0 * over_sin_angle_2),
            u_dot_of_u_2_46_1 * over_sin_angle_2,
        );
    let u_dot_of_u_2_49_1 = u_dot_of_u_2_5_1
        .mul_add(u_dot_of_place_18_0, u_dot_of_place_18_1 * u_dot_of_u_2_5_0);
    let u_dot_of_u_2_50_1 = u_dot_of_u_2_7_1
        .mul_add(u_dot_of_place_18_0, u_dot_of_place_18_1 * u_dot_of_u_2_7_0);
    let u_dot_of_u_2_51_1 = u_dot_of_u_2_47_1 - u_dot_of_u_2_48_1;
    let u_dot_of_u_2_52_1 = u_dot_of_u_2_51_1
        .mul_add(q_ground1_dot_2_0, q_ground1_dot_2_1 * u_dot_of_u_2_51_0);
    let u_dot_of_u_2_53_1 = u_dot_of_u_2_52_1
        .mul_add(minus_l, u_dot_of_u_2_50_1.mul_add(minus_l, l * u_dot_of_u_2_49_1));
    let u_dot_of_u_2_54_1 = u_dot_of_u_2_52_1
        .mul_add(
            minus_m_l_2,
            u_dot_of_u_2_50_1.mul_add(minus_m_l_2, m_l_2 * u_dot_of_u_2_49_1),
        );
    let u_dot_of_place_31_1 = sin_q_pin1_sin_angle_inv_1
        * (sin_q_pin1_sin_angle_inv_0 + sin_q_pin1_sin_angle_inv_0);
    let u_dot_of_place_32_1 = u_dot_of_place_20_1 * (u_dot_of_place_20_0 + u_dot_of_place_20_0);
    let u_dot_of_place_33_1 = u_dot_of_place_22_1
        .mul_add(cos_q_pin1_0, cos_q_pin1_1 * u_dot_of_place_22_0);
    let u_dot_of_place_34_1 = u_dot_of_place_22_1 * (u_dot_of_place_22_0 + u_dot_of_place_22_0);
    let u_dot_of_place_35_1 = u_dot_of_place_24_1
        .mul_add(cos_q_pin2_0, cos_q_pin2_1 * u_dot_of_place_24_0);
    let u_dot_of_place_36_1 = u_dot_of_place_35_1
        .mul_add(
            sin_q_pin1_sin_angle_inv_0,
            sin_q_pin1_sin_angle_inv_1 * u_dot_of_place_35_0,
        );
    let u_dot_of_place_37_1 = u_dot_of_place_24_1 * (u_dot_of_place_24_0 + u_dot_of_place_24_0);
    let u_dot_of_u_2_55_1 = u_dot_of_u_2_8_1
        .mul_add(
            sin_q_pin1_sin_angle_inv_0,
            sin_q_pin1_sin_angle_inv_1 * u_dot_of_u_2_8_0,
        );
    let u_dot_of_u_2_56_1 = u_dot_of_u_2_9_1
        .mul_add(
            sin_q_pin1_sin_angle_inv_0,
            sin_q_pin1_sin_angle_inv_1 * u_dot_of_u_2_9_0,
        );
    let u_dot_of_u_2_57_1 = u_dot_of_u_2_17_1
        .mul_add(u_dot_of_place_20_0, u_dot_of_place_20_1 * u_dot_of_u_2_17_0);
    let u_dot_of_u_2_58_1 = u_dot_of_u_2_18_1
        .mul_add(u_dot_of_place_20_0, u_dot_of_place_20_1 * u_dot_of_u_2_18_0);
    let u_2_sin_q_pin1_1 = sin_q_pin1_1.mul_add(u_2_0, u_2_1 * sin_q_pin1_0);
    let u_dot_of_u_2_59_1 = u_dot_of_place_22_1
        .mul_add(u_2_sin_q_pin1_0, u_2_sin_q_pin1_1 * u_dot_of_place_22_0);
    let u_dot_of_u_2_60_1 = u_dot_of_u_2_59_1
        .mul_add(u_dot_of_u_2_0, u_dot_of_u_2_1 * u_dot_of_u_2_59_0);
    let u_dot_of_u_2_61_1 = u_dot_of_u_2_36_1
        .mul_add(cos_q_pin1_0, cos_q_pin1_1 * u_dot_of_u_2_36_0);
    let u_dot_of_u_2_62_1 = u_dot_of_u_2_59_1.mul_add(u_2_0, u_2_1 * u_dot_of_u_2_59_0);
    let u_dot_of_u_2_63_1 = u_dot_of_u_2_36_1
        .mul_add(u_dot_of_place_22_0, u_dot_of_place_22_1 * u_dot_of_u_2_36_0);
    let u_dot_of_u_2_64_1 = u_dot_of_u_2_37_1
        .mul_add(u_dot_of_place_22_0, u_dot_of_place_22_1 * u_dot_of_u_2_37_0);
    let u_dot_of_u_2_65_1 = q_ground1_dot_2_1
        .mul_add(sin_q_pin2_0, sin_q_pin2_1 * q_ground1_dot_2_0);
    let u_dot_of_u_2_66_1 = u_dot_of_place_18_1
        .mul_add(u_dot_of_u_2_65_0, u_dot_of_u_2_65_1 * u_dot_of_place_18_0);
    let u_dot_of_u_2_67_1 = u_dot_of_u_2_66_1
        .mul_add(u_dot_of_u_2_2_0, u_dot_of_u_2_2_1 * u_dot_of_u_2_66_0);
    let u_dot_of_u_2_68_1 = u_dot_of_u_2_53_1
        .mul_add(cos_q_pin2_0, cos_q_pin2_1 * u_dot_of_u_2_53_0);
    let u_dot_of_u_2_69_1 = l * u_dot_of_u_2_67_1 - u_dot_of_u_2_68_1;
    let u_dot_of_u_2_70_1 = u_dot_of_u_2_69_1
        .mul_add(
            sin_q_pin1_sin_angle_inv_0,
            sin_q_pin1_sin_angle_inv_1 * u_dot_of_u_2_69_0,
        );
    let u_dot_of_u_2_71_1 = u_dot_of_u_2_65_1
        .mul_add(q_ground1_dot_2_0, q_ground1_dot_2_1 * u_dot_of_u_2_65_0);
    let u_dot_of_u_2_72_1 = u_dot_of_place_24_1
        .mul_add(u_dot_of_u_2_71_0, u_dot_of_u_2_71_1 * u_dot_of_place_24_0);
    let u_dot_of_u_2_73_1 = u_dot_of_u_2_8_1
        .mul_add(u_dot_of_place_35_0, u_dot_of_place_35_1 * u_dot_of_u_2_8_0);
    let u_dot_of_u_2_74_1 = u_dot_of_u_2_53_1
        .mul_add(u_dot_of_place_24_0, u_dot_of_place_24_1 * u_dot_of_u_2_53_0);
    let u_dot_of_u_2_75_1 = u_dot_of_u_2_54_1
        .mul_add(u_dot_of_place_24_0, u_dot_of_place_24_1 * u_dot_of_u_2_54_0);
    let u_dot_of_place_38_1 = u_dot_of_place_36_1
        .mul_add(
            weight_2,
            u_dot_of_place_37_1
                .mul_add(
                    m_l_2,
                    u_dot_of_place_34_1
                        .mul_add(
                            m_l_2,
                            u_dot_of_place_33_1
                                .mul_add(
                                    minus_3_m_l_2,
                                    u_dot_of_place_32_1
                                        .mul_add(m_l_2, weight * u_dot_of_place_31_1),
                                ),
                        ),
                ),
        );
    let u_dot_of_u_2_76_1 = u_dot_of_u_2_70_1
        .mul_add(
            minus_6_m_l,
            u_dot_of_u_2_74_1
                .mul_add(
                    weight_6,
                    u_dot_of_u_2_63_1
                        .mul_add(
                            weight_6,
                            u_dot_of_u_2_61_1
                                .mul_add(
                                    minus_6_m_l,
                                    u_dot_of_u_2_57_1
                                        .mul_add(
                                            weight_6,
                                            u_dot_of_u_2_73_1
                                                .mul_add(
                                                    weight_8,
                                                    u_dot_of_u_2_55_1
                                                        .mul_add(
                                                            weight_5,
                                                            u_dot_of_u_2_72_1
                                                                .mul_add(
                                                                    weight_7,
                                                                    u_dot_of_u_2_62_1
                                                                        .mul_add(
                                                                            minus_6_m_l_2,
                                                                            u_dot_of_u_2_60_1
                                                                                .mul_add(
                                                                                    weight_7,
                                                                                    u_dot_of_place_25_1
                                                                                        .mul_add(
                                                                                            weight_4,
                                                                                            u_dot_of_place_23_1
                                                                                                .mul_add(
                                                                                                    minus_6_m_l_g,
                                                                                                    u_dot_of_place_21_1
                                                                                                        .mul_add(
                                                                                                            weight_4,
                                                                                                            u_dot_of_place_19_1.mul_add(weight_3, weight_3 * cos_q_1),
                                                                                                        ),
                                                                                                ),
                                                                                        ),
                                                                                ),
                                                                        ),
                                                                ),
                                                        ) + u_dot_of_u_2_56_1,
                                                ),
                                        ) + u_dot_of_u_2_58_1,
                                ),
                        ) + u_dot_of_u_2_64_1,
                ) + u_dot_of_u_2_75_1,
        );
    let u_dot_of_u_2_77_1 = u_dot_of_place_38_1
        .mul_add(
            -(u_dot_of_u_2_77_0 * over_u_dot_of_place_38),
            u_dot_of_u_2_76_1 * over_u_dot_of_place_38,
        );
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                q_pin1_1, q_pin1_1, q_pin2_1, q_pin2_1, q_2_1, q_2_1, q_ground1_1, q_ground1_1,
                q_2_plus_q_pin1_1, q_2_plus_q_pin1_1, u_dot_of_place_1, u_dot_of_place_1,
                q_ground2_1, q_ground2_1, q_ground1_plus_q_pin2_1, q_ground1_plus_q_pin2_1,
                u_dot_of_place_2_1, u_dot_of_place_2_1, sin_q_1, cos_q_1, sin_q_pin1_1, sin_q_1,
                cos_q_1, cos_q_pin1_1, sin_q_ground1_1, cos_q_ground1_1, sin_q_ground2_1,
                cos_q_ground2_1, sin_angle_1, u_2_1, sin_angle_2_1, q_ground1_dot_2_1, sin_angle_1,
                u_dot_of_place_12_1, sin_angle_2_1, q_ground1_dot_2_1, cos_q_ground1_1,
                sin_q_pin1_sin_angle_inv_1, cos_q_ground2_1, u_dot_of_place_9_1,
                cos_q_plus_q_pin1_1, u_dot_of_place_18_1, cos_q_ground1_plus_q_pin2_1, cos_q_pin1_1,
                u_2_sin_angle_inv_1, sin_angle_1, u_dot_of_u_2_3_1, q_ground1_dot_2_1,
                u_dot_of_place_16_1, sin_angle_2_1, q_ground1_dot_2_1, u_dot_of_place_26_1,
                q_ground2_dot_2_1, sin_angle_2_1, u_dot_of_u_2_10_1, q_ground2_dot_2_1,
                cos_q_ground1_1, sin_q_ground1_1, u_2_1, q_ground1_dot_2_1, u_2_1,
                q_ground1_dot_2_1, u_dot_of_place_5_1, sin_q_pin1_1, u_2_1, q_ground1_dot_2_1,
                u_2_1, q_ground1_dot_2_1, u_dot_of_place_7_1, q_ground1_dot_2_1, cos_q_pin1_1,
                u_dot_of_place_9_1, u_dot_of_u_2_28_1, u_dot_of_u_2_31_1, u_dot_of_u_2_32_1,
                cos_q_ground1_plus_q_pin2_1, sin_q_ground1_plus_q_pin2_1, cos_q_ground2_1,
                q_ground2_dot_2_1, sin_q_ground2_1, sin_q_ground2_1, q_ground2_dot_2_1,
                cos_q_ground2_1, u_dot_of_place_17_1, sin_angle_2_1, u_dot_of_place_18_1,
                u_dot_of_place_18_1, u_dot_of_u_2_51_1, sin_q_pin1_sin_angle_inv_1,
                u_dot_of_place_20_1, cos_q_pin1_1, u_dot_of_place_22_1, cos_q_pin2_1,
                sin_q_pin1_sin_angle_inv_1, u_dot_of_place_24_1, u_dot_of_u_2_8_1, u_dot_of_u_2_9_1,
                u_dot_of_u_2_17_1, u_dot_of_u_2_18_1, u_2_1, u_dot_of_place_22_1, u_dot_of_u_2_1,
                cos_q_pin1_1, u_2_1, u_dot_of_u_2_36_1, u_dot_of_u_2_37_1, sin_q_pin2_1,
                u_dot_of_place_18_1, u_dot_of_u_2_2_1, cos_q_pin2_1, u_dot_of_u_2_69_1,
                q_ground1_dot_2_1, u_dot_of_place_24_1, u_dot_of_u_2_8_1, u_dot_of_u_2_53_1,
                u_dot_of_u_2_54_1, u_dot_of_place_38_1,
            ]),
            padded([
                cos_q_pin1_1, sin_q_pin1_1, cos_q_pin2_1, sin_q_pin2_1, cos_q_1, sin_q_1,
                cos_q_ground1_1, sin_q_ground1_1, cos_q_plus_q_pin1_1, sin_q_plus_q_pin1_1,
                cos_angle_1, sin_angle_1, cos_q_ground2_1, sin_q_ground2_1,
                cos_q_ground1_plus_q_pin2_1, sin_q_ground1_plus_q_pin2_1, cos_angle_2_1,
                sin_angle_2_1, sin_q_ground1_1, cos_q_ground1_1, u_dot_of_place_5_1,
                cos_q_ground1_1, sin_q_ground1_1, u_dot_of_place_7_1, u_dot_of_q_2_q_pin1_2_1,
                u_dot_of_q_2_q_pin1_1, u_dot_of_place_4_1, u_dot_of_place_3_1,
                sin_q_pin1_sin_angle_inv_1, sin_q_pin1_sin_angle_inv_1, u_dot_of_place_16_1,
                u_dot_of_place_16_1, u_2_sin_angle_inv_1, u_2_sin_angle_inv_1, u_dot_of_place_17_1,
                u_dot_of_place_17_1, sin_q_pin1_sin_angle_inv_1, u_dot_of_place_16_1,
                u_dot_of_place_20_1, u_dot_of_place_22_1, u_dot_of_place_22_1,
                sin_q_pin1_sin_angle_inv_1, u_dot_of_place_24_1, q_pin1_dot_2_1, u_dot_of_u_2_4_1,
                sin_angle_inv_cos_angle_1, sin_angle_inv_cos_angle_1, u_dot_of_u_2_6_1,
                u_dot_of_u_2_5_1, u_dot_of_place_26_1, q_pin2_dot_2_1, u_dot_of_u_2_12_1,
                u_dot_of_u_2_6_1, u_dot_of_place_27_1, u_dot_of_place_27_1, u_dot_of_u_2_15_1,
                q_ground1_dot_2_1, q_ground1_dot_2_1, cos_q_sin_q_ground1_1, sin_q_cos_q_ground1_1,
                sin_q_cos_q_ground1_1, cos_q_sin_q_ground1_1, u_dot_of_u_2_4_1, u_dot_of_u_2_23_1,
                cos_q_cos_q_ground1_1, sin_q_sin_q_ground1_1, sin_q_sin_q_ground1_1,
                cos_q_cos_q_ground1_1, u_dot_of_place_12_1, u_dot_of_place_28_1, u_dot_of_u_2_28_1,
                u_dot_of_u_2_32_1, u_dot_of_u_2_32_1, u_dot_of_place_22_1, u_dot_of_u_2_34_1,
                u_dot_of_u_2_2_1, u_dot_of_u_2_2_1, u_dot_of_place_4_1, u_dot_of_place_29_1,
                u_dot_of_u_2_42_1, u_dot_of_place_3_1, u_dot_of_place_30_1, u_dot_of_u_2_40_1,
                u_dot_of_u_2_15_1, u_dot_of_u_2_48_1, u_dot_of_u_2_5_1, u_dot_of_u_2_7_1,
                q_ground1_dot_2_1, sin_q_pin1_sin_angle_inv_1, u_dot_of_place_20_1,
                u_dot_of_place_22_1, u_dot_of_place_22_1, u_dot_of_place_24_1, u_dot_of_place_35_1,
                u_dot_of_place_24_1, sin_q_pin1_sin_angle_inv_1, sin_q_pin1_sin_angle_inv_1,
                u_dot_of_place_20_1, u_dot_of_place_20_1, sin_q_pin1_1, u_2_sin_q_pin1_1,
                u_dot_of_u_2_59_1, u_dot_of_u_2_36_1, u_dot_of_u_2_59_1, u_dot_of_place_22_1,
                u_dot_of_place_22_1, q_ground1_dot_2_1, u_dot_of_u_2_65_1, u_dot_of_u_2_66_1,
                u_dot_of_u_2_53_1, sin_q_pin1_sin_angle_inv_1, u_dot_of_u_2_65_1, u_dot_of_u_2_71_1,
                u_dot_of_place_35_1, u_dot_of_place_24_1, u_dot_of_place_24_1, u_dot_of_u_2_77_1,
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
    let mut q_2_plus_q_pin1_last = q_2_plus_q_pin1_1;
    let mut sin_q_plus_q_pin1_last = sin_q_plus_q_pin1_1;
    let mut cos_q_plus_q_pin1_last = cos_q_plus_q_pin1_1;
    let mut u_dot_of_place_last = u_dot_of_place_1;
    let mut sin_angle_last = sin_angle_1;
    let mut cos_angle_last = cos_angle_1;
    let mut sin_q_ground2_last = sin_q_ground2_1;
    let mut cos_q_ground2_last = cos_q_ground2_1;
    let mut q_ground1_plus_q_pin2_last = q_ground1_plus_q_pin2_1;
    let mut sin_q_ground1_plus_q_pin2_last = sin_q_ground1_plus_q_pin2_1;
    let mut cos_q_ground1_plus_q_pin2_last = cos_q_ground1_plus_q_pin2_1;
    let mut u_dot_of_place_2_last = u_dot_of_place_2_1;
    let mut sin_angle_2_last = sin_angle_2_1;
    let mut cos_angle_2_last = cos_angle_2_1;
    let mut u_dot_of_q_2_q_pin1_last = u_dot_of_q_2_q_pin1_1;
    let mut u_dot_of_q_2_q_pin1_2_last = u_dot_of_q_2_q_pin1_2_1;
    let mut u_dot_of_place_3_last = u_dot_of_place_3_1;
    let mut u_dot_of_place_4_last = u_dot_of_place_4_1;
    let mut sin_q_sin_q_ground1_last = sin_q_sin_q_ground1_1;
    let mut cos_q_cos_q_ground1_last = cos_q_cos_q_ground1_1;
    let mut u_dot_of_place_5_last = u_dot_of_place_5_1;
    let mut sin_q_cos_q_ground1_last = sin_q_cos_q_ground1_1;
    let mut cos_q_sin_q_ground1_last = cos_q_sin_q_ground1_1;
    let mut u_dot_of_place_7_last = u_dot_of_place_7_1;
    let mut u_dot_of_place_9_last = u_dot_of_place_9_1;
    let mut u_dot_of_place_12_last = u_dot_of_place_12_1;
    let mut sin_q_pin1_sin_angle_inv_last = sin_q_pin1_sin_angle_inv_1;
    let mut q_ground1_dot_2_last = q_ground1_dot_2_1;
    let mut u_dot_of_place_16_last = u_dot_of_place_16_1;
    let mut q_ground2_dot_2_last = q_ground2_dot_2_1;
    let mut u_2_sin_angle_inv_last = u_2_sin_angle_inv_1;
    let mut q_pin1_dot_2_last = q_pin1_dot_2_1;
    let mut u_dot_of_place_17_last = u_dot_of_place_17_1;
    let mut q_pin2_dot_2_last = q_pin2_dot_2_1;
    let mut u_dot_of_u_2_last = u_dot_of_u_2_1;
    let mut u_dot_of_u_2_2_last = u_dot_of_u_2_2_1;
    let mut u_dot_of_place_18_last = u_dot_of_place_18_1;
    let mut u_dot_of_place_20_last = u_dot_of_place_20_1;
    let mut u_dot_of_place_22_last = u_dot_of_place_22_1;
    let mut u_dot_of_place_24_last = u_dot_of_place_24_1;
    let mut u_dot_of_u_2_3_last = u_dot_of_u_2_3_1;
    let mut u_dot_of_u_2_4_last = u_dot_of_u_2_4_1;
    let mut u_dot_of_u_2_5_last = u_dot_of_u_2_5_1;
    let mut sin_angle_inv_cos_angle_last = sin_angle_inv_cos_angle_1;
    let mut u_dot_of_u_2_6_last = u_dot_of_u_2_6_1;
    let mut u_dot_of_u_2_7_last = u_dot_of_u_2_7_1;
    let mut u_dot_of_u_2_8_last = u_dot_of_u_2_8_1;
    let mut u_dot_of_u_2_9_last = u_dot_of_u_2_9_1;
    let mut u_dot_of_u_2_10_last = u_dot_of_u_2_10_1;
    let mut u_dot_of_place_26_last = u_dot_of_place_26_1;
    let mut u_dot_of_u_2_12_last = u_dot_of_u_2_12_1;
    let mut u_dot_of_place_27_last = u_dot_of_place_27_1;
    let mut u_dot_of_u_2_15_last = u_dot_of_u_2_15_1;
    let mut u_dot_of_u_2_17_last = u_dot_of_u_2_17_1;
    let mut u_dot_of_u_2_18_last = u_dot_of_u_2_18_1;
    let mut u_dot_of_u_2_23_last = u_dot_of_u_2_23_1;
    let mut u_dot_of_u_2_28_last = u_dot_of_u_2_28_1;
    let mut u_dot_of_place_28_last = u_dot_of_place_28_1;
    let mut u_dot_of_u_2_31_last = u_dot_of_u_2_31_1;
    let mut u_dot_of_u_2_32_last = u_dot_of_u_2_32_1;
    let mut u_dot_of_u_2_34_last = u_dot_of_u_2_34_1;
    let mut u_dot_of_u_2_36_last = u_dot_of_u_2_36_1;
    let mut u_dot_of_u_2_37_last = u_dot_of_u_2_37_1;
    let mut u_dot_of_u_2_40_last = u_dot_of_u_2_40_1;
    let mut u_dot_of_place_29_last = u_dot_of_place_29_1;
    let mut u_dot_of_u_2_42_last = u_dot_of_u_2_42_1;
    let mut u_dot_of_place_30_last = u_dot_of_place_30_1;
    let mut u_dot_of_u_2_48_last = u_dot_of_u_2_48_1;
    let mut u_dot_of_u_2_51_last = u_dot_of_u_2_51_1;
    let mut u_dot_of_u_2_53_last = u_dot_of_u_2_53_1;
    let mut u_dot_of_u_2_54_last = u_dot_of_u_2_54_1;
    let mut u_dot_of_place_35_last = u_dot_of_place_35_1;
    let mut u_2_sin_q_pin1_last = u_2_sin_q_pin1_1;
    let mut u_dot_of_u_2_59_last = u_dot_of_u_2_59_1;
    let mut u_dot_of_u_2_65_last = u_dot_of_u_2_65_1;
    let mut u_dot_of_u_2_66_last = u_dot_of_u_2_66_1;
    let mut u_dot_of_u_2_69_last = u_dot_of_u_2_69_1;
    let mut u_dot_of_u_2_71_last = u_dot_of_u_2_71_1;
    let mut u_dot_of_place_38_last = u_dot_of_place_38_1;
    let mut u_dot_of_u_2_77_last = u_dot_of_u_2_77_1;
    let mut next = [S::int(0); 120];
    // Rates at order k - 1.
    let mut q_2_rate = u_2_1;
    let mut q_ground1_rate = q_ground1_dot_2_1;
    let mut q_ground2_rate = q_ground2_dot_2_1;
    let mut q_pin1_rate = q_pin1_dot_2_1;
    let mut q_pin2_rate = q_pin2_dot_2_1;
    let mut u_2_rate = -S::ratio(1, 4) * u_dot_of_u_2_77_1;
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
                q_2_plus_q_pin1_1
                    .mul_add(
                        cos_q_plus_q_pin1_last,
                        (count_last * q_2_plus_q_pin1_last)
                            .mul_add(cos_q_plus_q_pin1_1, next[8]),
                    ),
                q_2_plus_q_pin1_1
                    .mul_add(
                        sin_q_plus_q_pin1_last,
                        (count_last * q_2_plus_q_pin1_last)
                            .mul_add(sin_q_plus_q_pin1_1, next[9]),
                    ),
                u_dot_of_place_1
                    .mul_add(
                        cos_angle_last,
                        (count_last * u_dot_of_place_last).mul_add(cos_angle_1, next[10]),
                    ),
                u_dot_of_place_1
                    .mul_add(
                        sin_angle_last,
                        (count_last * u_dot_of_place_last).mul_add(sin_angle_1, next[11]),
                    ),
                q_ground2_1
                    .mul_add(
                        cos_q_ground2_last,
                        (count_last * q_ground2_last).mul_add(cos_q_ground2_1, next[12]),
                    ),
                q_ground2_1
                    .mul_add(
                        sin_q_ground2_last,
                        (count_last * q_ground2_last).mul_add(sin_q_ground2_1, next[13]),
                    ),
                q_ground1_plus_q_pin2_1
                    .mul_add(
                        cos_q_ground1_plus_q_pin2_last,
                        (count_last * q_ground1_plus_q_pin2_last)
                            .mul_add(cos_q_ground1_plus_q_pin2_1, next[14]),
                    ),
                q_ground1_plus_q_pin2_1
                    .mul_add(
                        sin_q_ground1_plus_q_pin2_last,
                        (count_last * q_ground1_plus_q_pin2_last)
                            .mul_add(sin_q_ground1_plus_q_pin2_1, next[15]),
                    ),
                u_dot_of_place_2_1
                    .mul_add(
                        cos_angle_2_last,
                        (count_last * u_dot_of_place_2_last)
                            .mul_add(cos_angle_2_1, next[16]),
                    ),
                u_dot_of_place_2_1
                    .mul_add(
                        sin_angle_2_last,
                        (count_last * u_dot_of_place_2_last)
                            .mul_add(sin_angle_2_1, next[17]),
                    ),
                sin_q_1
                    .mul_add(
                        sin_q_ground1_last,
                        sin_q_last.mul_add(sin_q_ground1_1, next[18]),
                    ),
                cos_q_1
                    .mul_add(
                        cos_q_ground1_last,
                        cos_q_last.mul_add(cos_q_ground1_1, next[19]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        u_dot_of_place_5_last,
                        sin_q_pin1_last.mul_add(u_dot_of_place_5_1, next[20]),
                    ),
                sin_q_1
                    .mul_add(
                        cos_q_ground1_last,
                        sin_q_last.mul_add(cos_q_ground1_1, next[21]),
                    ),
                cos_q_1
                    .mul_add(
                        sin_q_ground1_last,
                        cos_q_last.mul_add(sin_q_ground1_1, next[22]),
                    ),
                cos_q_pin1_1
                    .mul_add(
                        u_dot_of_place_7_last,
                        cos_q_pin1_last.mul_add(u_dot_of_place_7_1, next[23]),
                    ),
                sin_q_ground1_1
                    .mul_add(
                        u_dot_of_q_2_q_pin1_2_last,
                        sin_q_ground1_last.mul_add(u_dot_of_q_2_q_pin1_2_1, next[24]),
                    ),
                cos_q_ground1_1
                    .mul_add(
                        u_dot_of_q_2_q_pin1_last,
                        cos_q_ground1_last.mul_add(u_dot_of_q_2_q_pin1_1, next[25]),
                    ),
                sin_q_ground2_1
                    .mul_add(
                        u_dot_of_place_4_last,
                        sin_q_ground2_last.mul_add(u_dot_of_place_4_1, next[26]),
                    ),
                cos_q_ground2_1
                    .mul_add(
                        u_dot_of_place_3_last,
                        cos_q_ground2_last.mul_add(u_dot_of_place_3_1, next[27]),
                    ),
                sin_angle_1
                    .mul_add(
                        sin_q_pin1_sin_angle_inv_last,
                        sin_angle_last.mul_add(sin_q_pin1_sin_angle_inv_1, next[28]),
                    ),
                u_2_1
                    .mul_add(
                        sin_q_pin1_sin_angle_inv_last,
                        u_2_last.mul_add(sin_q_pin1_sin_angle_inv_1, next[29]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        u_dot_of_place_16_last,
                        sin_angle_2_last.mul_add(u_dot_of_place_16_1, next[30]),
                    ),
                q_ground1_dot_2_1
                    .mul_add(
                        u_dot_of_place_16_last,
                        q_ground1_dot_2_last.mul_add(u_dot_of_place_16_1, next[31]),
                    ),
                sin_angle_1
                    .mul_add(
                        u_2_sin_angle_inv_last,
                        sin_angle_last.mul_add(u_2_sin_angle_inv_1, next[32]),
                    ),
                u_dot_of_place_12_1
                    .mul_add(
                        u_2_sin_angle_inv_last,
                        u_dot_of_place_12_last.mul_add(u_2_sin_angle_inv_1, next[33]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        u_dot_of_place_17_last,
                        sin_angle_2_last.mul_add(u_dot_of_place_17_1, next[34]),
                    ),
                q_ground1_dot_2_1
                    .mul_add(
                        u_dot_of_place_17_last,
                        q_ground1_dot_2_last.mul_add(u_dot_of_place_17_1, next[35]),
                    ),
                cos_q_ground1_1
                    .mul_add(
                        sin_q_pin1_sin_angle_inv_last,
                        cos_q_ground1_last.mul_add(sin_q_pin1_sin_angle_inv_1, next[36]),
                    ),
                sin_q_pin1_sin_angle_inv_1
                    .mul_add(
                        u_dot_of_place_16_last,
                        sin_q_pin1_sin_angle_inv_last
                            .mul_add(u_dot_of_place_16_1, next[37]),
                    ),
                cos_q_ground2_1
                    .mul_add(
                        u_dot_of_place_20_last,
                        cos_q_ground2_last.mul_add(u_dot_of_place_20_1, next[38]),
                    ),
                u_dot_of_place_9_1
                    .mul_add(
                        u_dot_of_place_22_last,
                        u_dot_of_place_9_last.mul_add(u_dot_of_place_22_1, next[39]),
                    ),
                cos_q_plus_q_pin1_1
                    .mul_add(
                        u_dot_of_place_22_last,
                        cos_q_plus_q_pin1_last.mul_add(u_dot_of_place_22_1, next[40]),
                    ),
                u_dot_of_place_18_1
                    .mul_add(
                        sin_q_pin1_sin_angle_inv_last,
                        u_dot_of_place_18_last
                            .mul_add(sin_q_pin1_sin_angle_inv_1, next[41]),
                    ),
                cos_q_ground1_plus_q_pin2_1
                    .mul_add(
                        u_dot_of_place_24_last,
                        cos_q_ground1_plus_q_pin2_last
                            .mul_add(u_dot_of_place_24_1, next[42]),
                    ),
                cos_q_pin1_1
                    .mul_add(
                        q_pin1_dot_2_last,
                        cos_q_pin1_last.mul_add(q_pin1_dot_2_1, next[43]),
                    ),
                u_2_sin_angle_inv_1
                    .mul_add(
                        u_dot_of_u_2_4_last,
                        u_2_sin_angle_inv_last.mul_add(u_dot_of_u_2_4_1, next[44]),
                    ),
                sin_angle_1
                    .mul_add(
                        sin_angle_inv_cos_angle_last,
                        sin_angle_last.mul_add(sin_angle_inv_cos_angle_1, next[45]),
                    ),
                u_dot_of_u_2_3_1
                    .mul_add(
                        sin_angle_inv_cos_angle_last,
                        u_dot_of_u_2_3_last.mul_add(sin_angle_inv_cos_angle_1, next[46]),
                    ),
                q_ground1_dot_2_1
                    .mul_add(
                        u_dot_of_u_2_6_last,
                        q_ground1_dot_2_last.mul_add(u_dot_of_u_2_6_1, next[47]),
                    ),
                u_dot_of_place_16_1
                    .mul_add(
                        u_dot_of_u_2_5_last,
                        u_dot_of_place_16_last.mul_add(u_dot_of_u_2_5_1, next[48]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        u_dot_of_place_26_last,
                        sin_angle_2_last.mul_add(u_dot_of_place_26_1, next[49]),
                    ),
                q_ground1_dot_2_1
                    .mul_add(
                        q_pin2_dot_2_last,
                        q_ground1_dot_2_last.mul_add(q_pin2_dot_2_1, next[50]),
                    ),
                u_dot_of_place_26_1
                    .mul_add(
                        u_dot_of_u_2_12_last,
                        u_dot_of_place_26_last.mul_add(u_dot_of_u_2_12_1, next[51]),
                    ),
                q_ground2_dot_2_1
                    .mul_add(
                        u_dot_of_u_2_6_last,
                        q_ground2_dot_2_last.mul_add(u_dot_of_u_2_6_1, next[52]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        u_dot_of_place_27_last,
                        sin_angle_2_last.mul_add(u_dot_of_place_27_1, next[53]),
                    ),
                u_dot_of_u_2_10_1
                    .mul_add(
                        u_dot_of_place_27_last,
                        u_dot_of_u_2_10_last.mul_add(u_dot_of_place_27_1, next[54]),
                    ),
                q_ground2_dot_2_1
                    .mul_add(
                        u_dot_of_u_2_15_last,
                        q_ground2_dot_2_last.mul_add(u_dot_of_u_2_15_1, next[55]),
                    ),
                cos_q_ground1_1
                    .mul_add(
                        q_ground1_dot_2_last,
                        cos_q_ground1_last.mul_add(q_ground1_dot_2_1, next[56]),
                    ),
                sin_q_ground1_1
                    .mul_add(
                        q_ground1_dot_2_last,
                        sin_q_ground1_last.mul_add(q_ground1_dot_2_1, next[57]),
                    ),
                u_2_1
                    .mul_add(
                        cos_q_sin_q_ground1_last,
                        u_2_last.mul_add(cos_q_sin_q_ground1_1, next[58]),
                    ),
                q_ground1_dot_2_1
                    .mul_add(
                        sin_q_cos_q_ground1_last,
                        q_ground1_dot_2_last.mul_add(sin_q_cos_q_ground1_1, next[59]),
                    ),
                u_2_1
                    .mul_add(
                        sin_q_cos_q_ground1_last,
                        u_2_last.mul_add(sin_q_cos_q_ground1_1, next[60]),
                    ),
                q_ground1_dot_2_1
                    .mul_add(
                        cos_q_sin_q_ground1_last,
                        q_ground1_dot_2_last.mul_add(cos_q_sin_q_ground1_1, next[61]),
                    ),
                u_dot_of_place_5_1
                    .mul_add(
                        u_dot_of_u_2_4_last,
                        u_dot_of_place_5_last.mul_add(u_dot_of_u_2_4_1, next[62]),
                    ),
                sin_q_pin1_1
                    .mul_add(
                        u_dot_of_u_2_23_last,
                        sin_q_pin1_last.mul_add(u_dot_of_u_2_23_1, next[63]),
                    ),
                u_2_1
                    .mul_add(
                        cos_q_cos_q_ground1_last,
                        u_2_last.mul_add(cos_q_cos_q_ground1_1, next[64]),
                    ),
                q_ground1_dot_2_1
                    .mul_add(
                        sin_q_sin_q_ground1_last,
                        q_ground1_dot_2_last.mul_add(sin_q_sin_q_ground1_1, next[65]),
                    ),
                u_2_1
                    .mul_add(
                        sin_q_sin_q_ground1_last,
                        u_2_last.mul_add(sin_q_sin_q_ground1_1, next[66]),
                    ),
                q_ground1_dot_2_1
                    .mul_add(
                        cos_q_cos_q_ground1_last,
                        q_ground1_dot_2_last.mul_add(cos_q_cos_q_ground1_1, next[67]),
                    ),
                u_dot_of_place_7_1
                    .mul_add(
                        u_dot_of_place_12_last,
                        u_dot_of_place_7_last.mul_add(u_dot_of_place_12_1, next[68]),
                    ),
                q_ground1_dot_2_1
                    .mul_add(
                        u_dot_of_place_28_last,
                        q_ground1_dot_2_last.mul_add(u_dot_of_place_28_1, next[69]),
                    ),
                cos_q_pin1_1
                    .mul_add(
                        u_dot_of_u_2_28_last,
                        cos_q_pin1_last.mul_add(u_dot_of_u_2_28_1, next[70]),
                    ),
                u_dot_of_place_9_1
                    .mul_add(
                        u_dot_of_u_2_32_last,
                        u_dot_of_place_9_last.mul_add(u_dot_of_u_2_32_1, next[71]),
                    ),
                u_dot_of_u_2_28_1
                    .mul_add(
                        u_dot_of_u_2_32_last,
                        u_dot_of_u_2_28_last.mul_add(u_dot_of_u_2_32_1, next[72]),
                    ),
                u_dot_of_u_2_31_1
                    .mul_add(
                        u_dot_of_place_22_last,
                        u_dot_of_u_2_31_last.mul_add(u_dot_of_place_22_1, next[73]),
                    ),
                u_dot_of_u_2_32_1
                    .mul_add(
                        u_dot_of_u_2_34_last,
                        u_dot_of_u_2_32_last.mul_add(u_dot_of_u_2_34_1, next[74]),
                    ),
                cos_q_ground1_plus_q_pin2_1
                    .mul_add(
                        u_dot_of_u_2_2_last,
                        cos_q_ground1_plus_q_pin2_last
                            .mul_add(u_dot_of_u_2_2_1, next[75]),
                    ),
                sin_q_ground1_plus_q_pin2_1
                    .mul_add(
                        u_dot_of_u_2_2_last,
                        sin_q_ground1_plus_q_pin2_last
                            .mul_add(u_dot_of_u_2_2_1, next[76]),
                    ),
                cos_q_ground2_1
                    .mul_add(
                        u_dot_of_place_4_last,
                        cos_q_ground2_last.mul_add(u_dot_of_place_4_1, next[77]),
                    ),
                q_ground2_dot_2_1
                    .mul_add(
                        u_dot_of_place_29_last,
                        q_ground2_dot_2_last.mul_add(u_dot_of_place_29_1, next[78]),
                    ),
                sin_q_ground2_1
                    .mul_add(
                        u_dot_of_u_2_42_last,
                        sin_q_ground2_last.mul_add(u_dot_of_u_2_42_1, next[79]),
                    ),
                sin_q_ground2_1
                    .mul_add(
                        u_dot_of_place_3_last,
                        sin_q_ground2_last.mul_add(u_dot_of_place_3_1, next[80]),
                    ),
                q_ground2_dot_2_1
                    .mul_add(
                        u_dot_of_place_30_last,
                        q_ground2_dot_2_last.mul_add(u_dot_of_place_30_1, next[81]),
                    ),
                cos_q_ground2_1
                    .mul_add(
                        u_dot_of_u_2_40_last,
                        cos_q_ground2_last.mul_add(u_dot_of_u_2_40_1, next[82]),
                    ),
                u_dot_of_place_17_1
                    .mul_add(
                        u_dot_of_u_2_15_last,
                        u_dot_of_place_17_last.mul_add(u_dot_of_u_2_15_1, next[83]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        u_dot_of_u_2_48_last,
                        sin_angle_2_last.mul_add(u_dot_of_u_2_48_1, next[84]),
                    ),
                u_dot_of_place_18_1
                    .mul_add(
                        u_dot_of_u_2_5_last,
                        u_dot_of_place_18_last.mul_add(u_dot_of_u_2_5_1, next[85]),
                    ),
                u_dot_of_place_18_1
                    .mul_add(
                        u_dot_of_u_2_7_last,
                        u_dot_of_place_18_last.mul_add(u_dot_of_u_2_7_1, next[86]),
                    ),
                u_dot_of_u_2_51_1
                    .mul_add(
                        q_ground1_dot_2_last,
                        u_dot_of_u_2_51_last.mul_add(q_ground1_dot_2_1, next[87]),
                    ),
                (sin_q_pin1_sin_angle_inv_1 + sin_q_pin1_sin_angle_inv_1)
                    .mul_add(sin_q_pin1_sin_angle_inv_last, next[88]),
                (u_dot_of_place_20_1 + u_dot_of_place_20_1)
                    .mul_add(u_dot_of_place_20_last, next[89]),
                cos_q_pin1_1
                    .mul_add(
                        u_dot_of_place_22_last,
                        cos_q_pin1_last.mul_add(u_dot_of_place_22_1, next[90]),
                    ),
                (u_dot_of_place_22_1 + u_dot_of_place_22_1)
                    .mul_add(u_dot_of_place_22_last, next[91]),
                cos_q_pin2_1
                    .mul_add(
                        u_dot_of_place_24_last,
                        cos_q_pin2_last.mul_add(u_dot_of_place_24_1, next[92]),
                    ),
                sin_q_pin1_sin_angle_inv_1
                    .mul_add(
                        u_dot_of_place_35_last,
                        sin_q_pin1_sin_angle_inv_last
                            .mul_add(u_dot_of_place_35_1, next[93]),
                    ),
                (u_dot_of_place_24_1 + u_dot_of_place_24_1)
                    .mul_add(u_dot_of_place_24_last, next[94]),
                u_dot_of_u_2_8_1
                    .mul_add(
                        sin_q_pin1_sin_angle_inv_last,
                        u_dot_of_u_2_8_last.mul_add(sin_q_pin1_sin_angle_inv_1, next[95]),
                    ),
                u_dot_of_u_2_9_1
                    .mul_add(
                        sin_q_pin1_sin_angle_inv_last,
                        u_dot_of_u_2_9_last.mul_add(sin_q_pin1_sin_angle_inv_1, next[96]),
                    ),
                u_dot_of_u_2_17_1
                    .mul_add(
                        u_dot_of_place_20_last,
                        u_dot_of_u_2_17_last.mul_add(u_dot_of_place_20_1, next[97]),
                    ),
                u_dot_of_u_2_18_1
                    .mul_add(
                        u_dot_of_place_20_last,
                        u_dot_of_u_2_18_last.mul_add(u_dot_of_place_20_1, next[98]),
                    ),
                u_2_1.mul_add(sin_q_pin1_last, u_2_last.mul_add(sin_q_pin1_1, next[99])),
                u_dot_of_place_22_1
                    .mul_add(
                        u_2_sin_q_pin1_last,
                        u_dot_of_place_22_last.mul_add(u_2_sin_q_pin1_1, next[100]),
                    ),
                u_dot_of_u_2_1
                    .mul_add(
                        u_dot_of_u_2_59_last,
                        u_dot_of_u_2_last.mul_add(u_dot_of_u_2_59_1, next[101]),
                    ),
                cos_q_pin1_1
                    .mul_add(
                        u_dot_of_u_2_36_last,
                        cos_q_pin1_last.mul_add(u_dot_of_u_2_36_1, next[102]),
                    ),
                u_2_1
                    .mul_add(
                        u_dot_of_u_2_59_last,
                        u_2_last.mul_add(u_dot_of_u_2_59_1, next[103]),
                    ),
                u_dot_of_u_2_36_1
                    .mul_add(
                        u_dot_of_place_22_last,
                        u_dot_of_u_2_36_last.mul_add(u_dot_of_place_22_1, next[104]),
                    ),
                u_dot_of_u_2_37_1
                    .mul_add(
                        u_dot_of_place_22_last,
                        u_dot_of_u_2_37_last.mul_add(u_dot_of_place_22_1, next[105]),
                    ),
                sin_q_pin2_1
                    .mul_add(
                        q_ground1_dot_2_last,
                        sin_q_pin2_last.mul_add(q_ground1_dot_2_1, next[106]),
                    ),
                u_dot_of_place_18_1
                    .mul_add(
                        u_dot_of_u_2_65_last,
                        u_dot_of_place_18_last.mul_add(u_dot_of_u_2_65_1, next[107]),
                    ),
                u_dot_of_u_2_2_1
                    .mul_add(
                        u_dot_of_u_2_66_last,
                        u_dot_of_u_2_2_last.mul_add(u_dot_of_u_2_66_1, next[108]),
                    ),
                cos_q_pin2_1
                    .mul_add(
                        u_dot_of_u_2_53_last,
                        cos_q_pin2_last.mul_add(u_dot_of_u_2_53_1, next[109]),
                    ),
                u_dot_of_u_2_69_1
                    .mul_add(
                        sin_q_pin1_sin_angle_inv_last,
                        u_dot_of_u_2_69_last
                            .mul_add(sin_q_pin1_sin_angle_inv_1, next[110]),
                    ),
                q_ground1_dot_2_1
                    .mul_add(
                        u_dot_of_u_2_65_last,
                        q_ground1_dot_2_last.mul_add(u_dot_of_u_2_65_1, next[111]),
                    ),
                u_dot_of_place_24_1
                    .mul_add(
                        u_dot_of_u_2_71_last,
                        u_dot_of_place_24_last.mul_add(u_dot_of_u_2_71_1, next[112]),
                    ),
                u_dot_of_u_2_8_1
                    .mul_add(
                        u_dot_of_place_35_last,
                        u_dot_of_u_2_8_last.mul_add(u_dot_of_place_35_1, next[113]),
                    ),
                u_dot_of_u_2_53_1
                    .mul_add(
                        u_dot_of_place_24_last,
                        u_dot_of_u_2_53_last.mul_add(u_dot_of_place_24_1, next[114]),
                    ),
                u_dot_of_u_2_54_1
                    .mul_add(
                        u_dot_of_place_24_last,
                        u_dot_of_u_2_54_last.mul_add(u_dot_of_place_24_1, next[115]),
                    ),
                u_dot_of_place_38_1
                    .mul_add(
                        u_dot_of_u_2_77_last,
                        u_dot_of_place_38_last.mul_add(u_dot_of_u_2_77_1, next[116]),
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
        // q_2_plus_q_pin1 = q_2 + q_pin1
        let q_2_plus_q_pin1 = q_2 + q_pin1;
        // sin_q_plus_q_pin1 = sin(q_2_plus_q_pin1)
        let sin_q_plus_q_pin1 = q_2_plus_q_pin1
            .mul_add(cos_q_plus_q_pin1_0, sums[8] * over_k);
        // cos_q_plus_q_pin1 = cos(q_2_plus_q_pin1)
        let cos_q_plus_q_pin1 = -q_2_plus_q_pin1
            .mul_add(sin_q_plus_q_pin1_0, sums[9] * over_k);
        // u_dot_of_place = q_2 - q_ground1 + q_pin1
        let u_dot_of_place = q_2 + q_pin1 - q_ground1;
        // sin_angle = sin(u_dot_of_place)
        let sin_angle = u_dot_of_place.mul_add(cos_angle_0, sums[10] * over_k);
        // cos_angle = cos(u_dot_of_place)
        let cos_angle = -u_dot_of_place.mul_add(sin_angle_0, sums[11] * over_k);
        // sin_q_ground2 = sin(q_ground2)
        let sin_q_ground2 = q_ground2.mul_add(cos_q_ground2_0, sums[12] * over_k);
        // cos_q_ground2 = cos(q_ground2)
        let cos_q_ground2 = -q_ground2.mul_add(sin_q_ground2_0, sums[13] * over_k);
        // q_ground1_plus_q_pin2 = q_ground1 + q_pin2
        let q_ground1_plus_q_pin2 = q_ground1 + q_pin2;
        // sin_q_ground1_plus_q_pin2 = sin(q_ground1_plus_q_pin2)
        let sin_q_ground1_plus_q_pin2 = q_ground1_plus_q_pin2
            .mul_add(cos_q_ground1_plus_q_pin2_0, sums[14] * over_k);
        // cos_q_ground1_plus_q_pin2 = cos(q_ground1_plus_q_pin2)
        let cos_q_ground1_plus_q_pin2 = -q_ground1_plus_q_pin2
            .mul_add(sin_q_ground1_plus_q_pin2_0, sums[15] * over_k);
        // u_dot_of_place_2 = q_ground1 - q_ground2 + q_pin2
        let u_dot_of_place_2 = q_ground1 + q_pin2 - q_ground2;
        // sin_angle_2 = sin(u_dot_of_place_2)
        let sin_angle_2 = u_dot_of_place_2.mul_add(cos_angle_2_0, sums[16] * over_k);
        // cos_angle_2 = cos(u_dot_of_place_2)
        let cos_angle_2 = -u_dot_of_place_2.mul_add(sin_angle_2_0, sums[17] * over_k);
        // u_dot_of_q_2_q_pin1 = sin_q + sin_q_plus_q_pin1
        let u_dot_of_q_2_q_pin1 = sin_q + sin_q_plus_q_pin1;
        // u_dot_of_q_2_q_pin1_2 = cos_q + cos_q_plus_q_pin1
        let u_dot_of_q_2_q_pin1_2 = cos_q + cos_q_plus_q_pin1;
        // u_dot_of_place_3 = sin_q_ground1 + sin_q_ground1_plus_q_pin2
        let u_dot_of_place_3 = sin_q_ground1 + sin_q_ground1_plus_q_pin2;
        // u_dot_of_place_4 = cos_q_ground1 + cos_q_ground1_plus_q_pin2
        let u_dot_of_place_4 = cos_q_ground1 + cos_q_ground1_plus_q_pin2;
        // sin_q_sin_q_ground1 = sin_q*sin_q_ground1
        let sin_q_sin_q_ground1 = sin_q_ground1
            .mul_add(sin_q_0, sin_q.mul_add(sin_q_ground1_0, sums[18]));
        // cos_q_cos_q_ground1 = cos_q*cos_q_ground1
        let cos_q_cos_q_ground1 = cos_q_ground1
            .mul_add(cos_q_0, cos_q.mul_add(cos_q_ground1_0, sums[19]));
        // u_dot_of_place_5 = sin_q_sin_q_ground1 + cos_q_cos_q_ground1
        let u_dot_of_place_5 = sin_q_sin_q_ground1 + cos_q_cos_q_ground1;
        // u_dot_of_place_6 = sin_q_pin1*u_dot_of_place_5
        let u_dot_of_place_6 = u_dot_of_place_5
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(u_dot_of_place_5_0, sums[20]));
        // sin_q_cos_q_ground1 = sin_q*cos_q_ground1
        let sin_q_cos_q_ground1 = cos_q_ground1
            .mul_add(sin_q_0, sin_q.mul_add(cos_q_ground1_0, sums[21]));
        // cos_q_sin_q_ground1 = cos_q*sin_q_ground1
        let cos_q_sin_q_ground1 = sin_q_ground1
            .mul_add(cos_q_0, cos_q.mul_add(sin_q_ground1_0, sums[22]));
        // u_dot_of_place_7 = sin_q_cos_q_ground1 - cos_q_sin_q_ground1
        let u_dot_of_place_7 = sin_q_cos_q_ground1 - cos_q_sin_q_ground1;
        // u_dot_of_place_8 = cos_q_pin1*u_dot_of_place_7
        let u_dot_of_place_8 = u_dot_of_place_7
            .mul_add(cos_q_pin1_0, cos_q_pin1.mul_add(u_dot_of_place_7_0, sums[23]));
        // u_dot_of_place_9 = u_dot_of_place_6 + u_dot_of_place_8
        let u_dot_of_place_9 = u_dot_of_place_6 + u_dot_of_place_8;
        // u_dot_of_place_10 = sin_q_ground1*u_dot_of_q_2_q_pin1_2
        let u_dot_of_place_10 = u_dot_of_q_2_q_pin1_2
            .mul_add(
                sin_q_ground1_0,
                sin_q_ground1.mul_add(u_dot_of_q_2_q_pin1_2_0, sums[24]),
            );
        // u_dot_of_place_11 = cos_q_ground1*u_dot_of_q_2_q_pin1
        let u_dot_of_place_11 = u_dot_of_q_2_q_pin1
            .mul_add(
                cos_q_ground1_0,
                cos_q_ground1.mul_add(u_dot_of_q_2_q_pin1_0, sums[25]),
            );
        // u_dot_of_place_12 = u_dot_of_place_10 - u_dot_of_place_11
        let u_dot_of_place_12 = u_dot_of_place_10 - u_dot_of_place_11;
        // u_dot_of_place_13 = sin_q_ground2*u_dot_of_place_4
        let u_dot_of_place_13 = u_dot_of_place_4
            .mul_add(
                sin_q_ground2_0,
                sin_q_ground2.mul_add(u_dot_of_place_4_0, sums[26]),
            );
        // u_dot_of_place_14 = cos_q_ground2*u_dot_of_place_3
        let u_dot_of_place_14 = u_dot_of_place_3
            .mul_add(
                cos_q_ground2_0,
                cos_q_ground2.mul_add(u_dot_of_place_3_0, sums[27]),
            );
        // u_dot_of_place_15 = u_dot_of_place_13 - u_dot_of_place_14
        let u_dot_of_place_15 = u_dot_of_place_13 - u_dot_of_place_14;
        // sin_q_pin1_sin_angle_inv = sin_q_pin1/sin_angle
        let sin_q_pin1_sin_angle_inv = sin_angle
            .mul_add(
                -(sin_q_pin1_sin_angle_inv_0 * over_sin_angle),
                (sin_q_pin1 - sums[28]) * over_sin_angle,
            );
        // q_ground1_dot_2 = u_2*sin_q_pin1_sin_angle_inv
        let q_ground1_dot_2 = sin_q_pin1_sin_angle_inv
            .mul_add(u_2_0, u_2.mul_add(sin_q_pin1_sin_angle_inv_0, sums[29]));
        // u_dot_of_place_16 = sin_q_pin2/sin_angle_2
        let u_dot_of_place_16 = sin_angle_2
            .mul_add(
                -(u_dot_of_place_16_0 * over_sin_angle_2),
                (sin_q_pin2 - sums[30]) * over_sin_angle_2,
            );
        // q_ground2_dot_2 = q_ground1_dot_2*u_dot_of_place_16
        let q_ground2_dot_2 = q_ground1_dot_2
            .mul_add(
                u_dot_of_place_16_0,
                u_dot_of_place_16.mul_add(q_ground1_dot_2_0, sums[31]),
            );
        // u_2_sin_angle_inv = u_2/sin_angle
        let u_2_sin_angle_inv = sin_angle
            .mul_add(
                -(u_2_sin_angle_inv_0 * over_sin_angle),
                (u_2 - sums[32]) * over_sin_angle,
            );
        // q_pin1_dot_2 = u_dot_of_place_12*u_2_sin_angle_inv
        let q_pin1_dot_2 = u_dot_of_place_12
            .mul_add(
                u_2_sin_angle_inv_0,
                u_2_sin_angle_inv.mul_add(u_dot_of_place_12_0, sums[33]),
            );
        // u_dot_of_place_17 = u_dot_of_place_15/sin_angle_2
        let u_dot_of_place_17 = u_dot_of_place_15
            .mul_add(
                over_sin_angle_2,
                -(sin_angle_2.mul_add(u_dot_of_place_17_0, sums[34]) * over_sin_angle_2),
            );
        // q_pin2_dot_2 = q_ground1_dot_2*u_dot_of_place_17
        let q_pin2_dot_2 = u_dot_of_place_17
            .mul_add(
                q_ground1_dot_2_0,
                q_ground1_dot_2.mul_add(u_dot_of_place_17_0, sums[35]),
            );
        // u_dot_of_u_2 = u_2 + q_pin1_dot_2
        let u_dot_of_u_2 = u_2 + q_pin1_dot_2;
        // u_dot_of_u_2_2 = q_ground1_dot_2 + q_pin2_dot_2
        let u_dot_of_u_2_2 = q_ground1_dot_2 + q_pin2_dot_2;
        // u_dot_of_place_18 = 1 + u_dot_of_place_17
        let u_dot_of_place_18 = u_dot_of_place_17;
        // u_dot_of_place_19 = cos_q_ground1*sin_q_pin1_sin_angle_inv
        let u_dot_of_place_19 = sin_q_pin1_sin_angle_inv
            .mul_add(
                cos_q_ground1_0,
                cos_q_ground1.mul_add(sin_q_pin1_sin_angle_inv_0, sums[36]),
            );
        // u_dot_of_place_20 = sin_q_pin1_sin_angle_inv*u_dot_of_place_16
        let u_dot_of_place_20 = u_dot_of_place_16
            .mul_add(
                sin_q_pin1_sin_angle_inv_0,
                sin_q_pin1_sin_angle_inv.mul_add(u_dot_of_place_16_0, sums[37]),
            );
        // u_dot_of_place_21 = cos_q_ground2*u_dot_of_place_20
        let u_dot_of_place_21 = u_dot_of_place_20
            .mul_add(
                cos_q_ground2_0,
                cos_q_ground2.mul_add(u_dot_of_place_20_0, sums[38]),
            );
        // u_dot_of_place_22 = u_dot_of_place_7/u_dot_of_place_9
        let u_dot_of_place_22 = u_dot_of_place_9
            .mul_add(
                -(u_dot_of_place_22_0 * over_u_dot_of_place_9),
                (u_dot_of_place_7 - sums[39]) * over_u_dot_of_place_9,
            );
        // u_dot_of_place_23 = cos_q_plus_q_pin1*u_dot_of_place_22
        let u_dot_of_place_23 = u_dot_of_place_22
            .mul_add(
                cos_q_plus_q_pin1_0,
                cos_q_plus_q_pin1.mul_add(u_dot_of_place_22_0, sums[40]),
            );
        // u_dot_of_place_24 = u_dot_of_place_18*sin_q_pin1_sin_angle_inv
        let u_dot_of_place_24 = u_dot_of_place_18
            .mul_add(
                sin_q_pin1_sin_angle_inv_0,
                sin_q_pin1_sin_angle_inv.mul_add(u_dot_of_place_18_0, sums[41]),
            );
        // u_dot_of_place_25 = cos_q_ground1_plus_q_pin2*u_dot_of_place_24
        let u_dot_of_place_25 = u_dot_of_place_24
            .mul_add(
                cos_q_ground1_plus_q_pin2_0,
                cos_q_ground1_plus_q_pin2.mul_add(u_dot_of_place_24_0, sums[42]),
            );
        // u_dot_of_u_2_3 = u_2 - q_ground1_dot_2 + q_pin1_dot_2
        let u_dot_of_u_2_3 = u_2 - q_ground1_dot_2 + q_pin1_dot_2;
        // u_dot_of_u_2_4 = cos_q_pin1*q_pin1_dot_2
        let u_dot_of_u_2_4 = q_pin1_dot_2
            .mul_add(cos_q_pin1_0, cos_q_pin1.mul_add(q_pin1_dot_2_0, sums[43]));
        // u_dot_of_u_2_5 = u_2_sin_angle_inv*u_dot_of_u_2_4
        let u_dot_of_u_2_5 = u_dot_of_u_2_4
            .mul_add(
                u_2_sin_angle_inv_0,
                u_2_sin_angle_inv.mul_add(u_dot_of_u_2_4_0, sums[44]),
            );
        // sin_angle_inv_cos_angle = cos_angle/sin_angle
        let sin_angle_inv_cos_angle = sin_angle
            .mul_add(
                -(sin_angle_inv_cos_angle_0 * over_sin_angle),
                (cos_angle - sums[45]) * over_sin_angle,
            );
        // u_dot_of_u_2_6 = u_dot_of_u_2_3*sin_angle_inv_cos_angle
        let u_dot_of_u_2_6 = u_dot_of_u_2_3
            .mul_add(
                sin_angle_inv_cos_angle_0,
                sin_angle_inv_cos_angle.mul_add(u_dot_of_u_2_3_0, sums[46]),
            );
        // u_dot_of_u_2_7 = q_ground1_dot_2*u_dot_of_u_2_6
        let u_dot_of_u_2_7 = u_dot_of_u_2_6
            .mul_add(
                q_ground1_dot_2_0,
                q_ground1_dot_2.mul_add(u_dot_of_u_2_6_0, sums[47]),
            );
        // u_dot_of_u_2_8 = l*u_dot_of_u_2_5 + minus_l*u_dot_of_u_2_7
        let u_dot_of_u_2_8 = u_dot_of_u_2_7.mul_add(minus_l, l * u_dot_of_u_2_5);
        // u_dot_of_u_2_9 = m_l_2*u_dot_of_u_2_5 + minus_m_l_2*u_dot_of_u_2_7
        let u_dot_of_u_2_9 = u_dot_of_u_2_7.mul_add(minus_m_l_2, m_l_2 * u_dot_of_u_2_5);
        // u_dot_of_u_2_10 = q_ground1_dot_2 - q_ground2_dot_2 + q_pin2_dot_2
        let u_dot_of_u_2_10 = q_ground1_dot_2 - q_ground2_dot_2 + q_pin2_dot_2;
        // u_dot_of_u_2_11 = u_dot_of_place_16*u_dot_of_u_2_5
        let u_dot_of_u_2_11 = u_dot_of_u_2_5
            .mul_add(
                u_dot_of_place_16_0,
                u_dot_of_place_16.mul_add(u_dot_of_u_2_5_0, sums[48]),
            );
        // u_dot_of_place_26 = cos_q_pin2/sin_angle_2
        let u_dot_of_place_26 = sin_angle_2
            .mul_add(
                -(u_dot_of_place_26_0 * over_sin_angle_2),
                (cos_q_pin2 - sums[49]) * over_sin_angle_2,
            );
        // u_dot_of_u_2_12 = q_ground1_dot_2*q_pin2_dot_2
        let u_dot_of_u_2_12 = q_pin2_dot_2
            .mul_add(
                q_ground1_dot_2_0,
                q_ground1_dot_2.mul_add(q_pin2_dot_2_0, sums[50]),
            );
        // u_dot_of_u_2_13 = u_dot_of_place_26*u_dot_of_u_2_12
        let u_dot_of_u_2_13 = u_dot_of_u_2_12
            .mul_add(
                u_dot_of_place_26_0,
                u_dot_of_place_26.mul_add(u_dot_of_u_2_12_0, sums[51]),
            );
        // u_dot_of_u_2_14 = q_ground2_dot_2*u_dot_of_u_2_6
        let u_dot_of_u_2_14 = u_dot_of_u_2_6
            .mul_add(
                q_ground2_dot_2_0,
                q_ground2_dot_2.mul_add(u_dot_of_u_2_6_0, sums[52]),
            );
        // u_dot_of_place_27 = cos_angle_2/sin_angle_2
        let u_dot_of_place_27 = sin_angle_2
            .mul_add(
                -(u_dot_of_place_27_0 * over_sin_angle_2),
                (cos_angle_2 - sums[53]) * over_sin_angle_2,
            );
        // u_dot_of_u_2_15 = u_dot_of_u_2_10*u_dot_of_place_27
        let u_dot_of_u_2_15 = u_dot_of_u_2_10
            .mul_add(
                u_dot_of_place_27_0,
                u_dot_of_place_27.mul_add(u_dot_of_u_2_10_0, sums[54]),
            );
        // u_dot_of_u_2_16 = q_ground2_dot_2*u_dot_of_u_2_15
        let u_dot_of_u_2_16 = u_dot_of_u_2_15
            .mul_add(
                q_ground2_dot_2_0,
                q_ground2_dot_2.mul_add(u_dot_of_u_2_15_0, sums[55]),
            );
        // u_dot_of_u_2_17 = l*u_dot_of_u_2_11 + l*u_dot_of_u_2_13 + minus_l*u_dot_of_u_2_14 +
        //   minus_l*u_dot_of_u_2_16
        let u_dot_of_u_2_17 = u_dot_of_u_2_16
            .mul_add(
                minus_l,
                u_dot_of_u_2_13
                    .mul_add(l, u_dot_of_u_2_11.mul_add(l, minus_l * u_dot_of_u_2_14)),
            );
        // u_dot_of_u_2_18 = m_l_2*u_dot_of_u_2_11 + m_l_2*u_dot_of_u_2_13 + minus_m_l_2*u_dot_of_u_2_14 +
        //   minus_m_l_2*u_dot_of_u_2_16
        let u_dot_of_u_2_18 = u_dot_of_u_2_16
            .mul_add(
                minus_m_l_2,
                u_dot_of_u_2_13
                    .mul_add(
                        m_l_2,
                        u_dot_of_u_2_11.mul_add(m_l_2, minus_m_l_2 * u_dot_of_u_2_14),
                    ),
            );
        // u_dot_of_u_2_19 = cos_q_ground1*q_ground1_dot_2
        let u_dot_of_u_2_19 = q_ground1_dot_2
            .mul_add(
                cos_q_ground1_0,
                cos_q_ground1.mul_add(q_ground1_dot_2_0, sums[56]),
            );
        // u_dot_of_u_2_20 = sin_q_ground1*q_ground1_dot_2
        let u_dot_of_u_2_20 = q_ground1_dot_2
            .mul_add(
                sin_q_ground1_0,
                sin_q_ground1.mul_add(q_ground1_dot_2_0, sums[57]),
            );
        // u_2_cos_q_sin_q_ground1 = u_2*cos_q_sin_q_ground1
        let u_2_cos_q_sin_q_ground1 = cos_q_sin_q_ground1
            .mul_add(u_2_0, u_2.mul_add(cos_q_sin_q_ground1_0, sums[58]));
        // u_dot_of_u_2_21 = q_ground1_dot_2*sin_q_cos_q_ground1
        let u_dot_of_u_2_21 = q_ground1_dot_2
            .mul_add(
                sin_q_cos_q_ground1_0,
                sin_q_cos_q_ground1.mul_add(q_ground1_dot_2_0, sums[59]),
            );
        // u_2_sin_q_cos_q_ground1 = u_2*sin_q_cos_q_ground1
        let u_2_sin_q_cos_q_ground1 = sin_q_cos_q_ground1
            .mul_add(u_2_0, u_2.mul_add(sin_q_cos_q_ground1_0, sums[60]));
        // u_dot_of_u_2_22 = q_ground1_dot_2*cos_q_sin_q_ground1
        let u_dot_of_u_2_22 = q_ground1_dot_2
            .mul_add(
                cos_q_sin_q_ground1_0,
                cos_q_sin_q_ground1.mul_add(q_ground1_dot_2_0, sums[61]),
            );
        // u_dot_of_u_2_23 = u_2_cos_q_sin_q_ground1 + u_dot_of_u_2_21 - u_2_sin_q_cos_q_ground1 -
        //   u_dot_of_u_2_22
        let u_dot_of_u_2_23 = u_2_cos_q_sin_q_ground1 - u_2_sin_q_cos_q_ground1
            + u_dot_of_u_2_21 - u_dot_of_u_2_22;
        // u_dot_of_u_2_24 = u_dot_of_place_5*u_dot_of_u_2_4
        let u_dot_of_u_2_24 = u_dot_of_u_2_4
            .mul_add(
                u_dot_of_place_5_0,
                u_dot_of_place_5.mul_add(u_dot_of_u_2_4_0, sums[62]),
            );
        // u_dot_of_u_2_25 = sin_q_pin1*u_dot_of_u_2_23
        let u_dot_of_u_2_25 = u_dot_of_u_2_23
            .mul_add(sin_q_pin1_0, sin_q_pin1.mul_add(u_dot_of_u_2_23_0, sums[63]));
        // u_2_cos_q_cos_q_ground1 = u_2*cos_q_cos_q_ground1
        let u_2_cos_q_cos_q_ground1 = cos_q_cos_q_ground1
            .mul_add(u_2_0, u_2.mul_add(cos_q_cos_q_ground1_0, sums[64]));
        // u_dot_of_u_2_26 = q_ground1_dot_2*sin_q_sin_q_ground1
        let u_dot_of_u_2_26 = q_ground1_dot_2
            .mul_add(
                sin_q_sin_q_ground1_0,
                sin_q_sin_q_ground1.mul_add(q_ground1_dot_2_0, sums[65]),
            );
        // u_2_sin_q_sin_q_ground1 = u_2*sin_q_sin_q_ground1
        let u_2_sin_q_sin_q_ground1 = sin_q_sin_q_ground1
            .mul_add(u_2_0, u_2.mul_add(sin_q_sin_q_ground1_0, sums[66]));
        // u_dot_of_u_2_27 = q_ground1_dot_2*cos_q_cos_q_ground1
        let u_dot_of_u_2_27 = q_ground1_dot_2
            .mul_add(
                cos_q_cos_q_ground1_0,
                cos_q_cos_q_ground1.mul_add(q_ground1_dot_2_0, sums[67]),
            );
        // u_dot_of_u_2_28 = u_2_cos_q_cos_q_ground1 - u_dot_of_u_2_26 + u_2_sin_q_sin_q_ground1 -
        //   u_dot_of_u_2_27
        let u_dot_of_u_2_28 = u_2_cos_q_cos_q_ground1 + u_2_sin_q_sin_q_ground1
            - u_dot_of_u_2_26 - u_dot_of_u_2_27;
        // u_dot_of_place_28 = u_dot_of_place_7*u_dot_of_place_12
        let u_dot_of_place_28 = u_dot_of_place_12
            .mul_add(
                u_dot_of_place_7_0,
                u_dot_of_place_7.mul_add(u_dot_of_place_12_0, sums[68]),
            );
        // u_dot_of_u_2_29 = q_ground1_dot_2*u_dot_of_place_28
        let u_dot_of_u_2_29 = u_dot_of_place_28
            .mul_add(
                q_ground1_dot_2_0,
                q_ground1_dot_2.mul_add(u_dot_of_place_28_0, sums[69]),
            );
        // u_dot_of_u_2_30 = cos_q_pin1*u_dot_of_u_2_28
        let u_dot_of_u_2_30 = u_dot_of_u_2_28
            .mul_add(cos_q_pin1_0, cos_q_pin1.mul_add(u_dot_of_u_2_28_0, sums[70]));
        // u_dot_of_u_2_31 = u_dot_of_u_2_24 + u_dot_of_u_2_25 - u_dot_of_u_2_29 + u_dot_of_u_2_30
        let u_dot_of_u_2_31 = -u_dot_of_u_2_29 + u_dot_of_u_2_25 + u_dot_of_u_2_30
            + u_dot_of_u_2_24;
        // u_dot_of_u_2_32 = u_2/u_dot_of_place_9
        let u_dot_of_u_2_32 = u_dot_of_place_9
            .mul_add(
                -(u_dot_of_u_2_32_0 * over_u_dot_of_place_9),
                (u_2 - sums[71]) * over_u_dot_of_place_9,
            );
        // u_dot_of_u_2_33 = u_dot_of_u_2_28*u_dot_of_u_2_32
        let u_dot_of_u_2_33 = u_dot_of_u_2_32
            .mul_add(
                u_dot_of_u_2_28_0,
                u_dot_of_u_2_28.mul_add(u_dot_of_u_2_32_0, sums[72]),
            );
        // u_dot_of_u_2_34 = u_dot_of_u_2_31*u_dot_of_place_22
        let u_dot_of_u_2_34 = u_dot_of_u_2_31
            .mul_add(
                u_dot_of_place_22_0,
                u_dot_of_place_22.mul_add(u_dot_of_u_2_31_0, sums[73]),
            );
        // u_dot_of_u_2_35 = u_dot_of_u_2_32*u_dot_of_u_2_34
        let u_dot_of_u_2_35 = u_dot_of_u_2_34
            .mul_add(
                u_dot_of_u_2_32_0,
                u_dot_of_u_2_32.mul_add(u_dot_of_u_2_34_0, sums[74]),
            );
        // u_dot_of_u_2_36 = l*u_dot_of_u_2_33 + minus_l*u_dot_of_u_2_35
        let u_dot_of_u_2_36 = u_dot_of_u_2_35.mul_add(minus_l, l * u_dot_of_u_2_33);
        // u_dot_of_u_2_37 = m_l_2*u_dot_of_u_2_33 + minus_m_l_2*u_dot_of_u_2_35
        let u_dot_of_u_2_37 = u_dot_of_u_2_35
            .mul_add(minus_m_l_2, m_l_2 * u_dot_of_u_2_33);
        // u_dot_of_u_2_38 = cos_q_ground1_plus_q_pin2*u_dot_of_u_2_2
        let u_dot_of_u_2_38 = u_dot_of_u_2_2
            .mul_add(
                cos_q_ground1_plus_q_pin2_0,
                cos_q_ground1_plus_q_pin2.mul_add(u_dot_of_u_2_2_0, sums[75]),
            );
        // u_dot_of_u_2_39 = sin_q_ground1_plus_q_pin2*u_dot_of_u_2_2
        let u_dot_of_u_2_39 = u_dot_of_u_2_2
            .mul_add(
                sin_q_ground1_plus_q_pin2_0,
                sin_q_ground1_plus_q_pin2.mul_add(u_dot_of_u_2_2_0, sums[76]),
            );
        // u_dot_of_u_2_40 = u_dot_of_u_2_19 + u_dot_of_u_2_38
        let u_dot_of_u_2_40 = u_dot_of_u_2_19 + u_dot_of_u_2_38;
        // u_dot_of_place_29 = cos_q_ground2*u_dot_of_place_4
        let u_dot_of_place_29 = u_dot_of_place_4
            .mul_add(
                cos_q_ground2_0,
                cos_q_ground2.mul_add(u_dot_of_place_4_0, sums[77]),
            );
        // u_dot_of_u_2_41 = q_ground2_dot_2*u_dot_of_place_29
        let u_dot_of_u_2_41 = q_ground2_dot_2
            .mul_add(
                u_dot_of_place_29_0,
                u_dot_of_place_29.mul_add(q_ground2_dot_2_0, sums[78]),
            );
        // u_dot_of_u_2_42 = u_dot_of_u_2_20 + u_dot_of_u_2_39
        let u_dot_of_u_2_42 = u_dot_of_u_2_20 + u_dot_of_u_2_39;
        // u_dot_of_u_2_43 = sin_q_ground2*u_dot_of_u_2_42
        let u_dot_of_u_2_43 = u_dot_of_u_2_42
            .mul_add(
                sin_q_ground2_0,
                sin_q_ground2.mul_add(u_dot_of_u_2_42_0, sums[79]),
            );
        // u_dot_of_place_30 = sin_q_ground2*u_dot_of_place_3
        let u_dot_of_place_30 = u_dot_of_place_3
            .mul_add(
                sin_q_ground2_0,
                sin_q_ground2.mul_add(u_dot_of_place_3_0, sums[80]),
            );
        // u_dot_of_u_2_44 = q_ground2_dot_2*u_dot_of_place_30
        let u_dot_of_u_2_44 = q_ground2_dot_2
            .mul_add(
                u_dot_of_place_30_0,
                u_dot_of_place_30.mul_add(q_ground2_dot_2_0, sums[81]),
            );
        // u_dot_of_u_2_45 = cos_q_ground2*u_dot_of_u_2_40
        let u_dot_of_u_2_45 = u_dot_of_u_2_40
            .mul_add(
                cos_q_ground2_0,
                cos_q_ground2.mul_add(u_dot_of_u_2_40_0, sums[82]),
            );
        // u_dot_of_u_2_46 = u_dot_of_u_2_41 - u_dot_of_u_2_43 + u_dot_of_u_2_44 - u_dot_of_u_2_45
        let u_dot_of_u_2_46 = u_dot_of_u_2_41 + u_dot_of_u_2_44 - u_dot_of_u_2_43 - u_dot_of_u_2_45;
        // u_dot_of_u_2_47 = u_dot_of_place_17*u_dot_of_u_2_15
        let u_dot_of_u_2_47 = u_dot_of_u_2_15
            .mul_add(
                u_dot_of_place_17_0,
                u_dot_of_place_17.mul_add(u_dot_of_u_2_15_0, sums[83]),
            );
        // u_dot_of_u_2_48 = u_dot_of_u_2_46/sin_angle_2
        let u_dot_of_u_2_48 = u_dot_of_u_2_46
            .mul_add(
                over_sin_angle_2,
                -(sin_angle_2.mul_add(u_dot_of_u_2_48_0, sums[84]) * over_sin_angle_2),
            );
        // u_dot_of_u_2_49 = u_dot_of_place_18*u_dot_of_u_2_5
        let u_dot_of_u_2_49 = u_dot_of_u_2_5
            .mul_add(
                u_dot_of_place_18_0,
                u_dot_of_place_18.mul_add(u_dot_of_u_2_5_0, sums[85]),
            );
        // u_dot_of_u_2_50 = u_dot_of_place_18*u_dot_of_u_2_7
        let u_dot_of_u_2_50 = u_dot_of_u_2_7
            .mul_add(
                u_dot_of_place_18_0,
                u_dot_of_place_18.mul_add(u_dot_of_u_2_7_0, sums[86]),
            );
        // u_dot_of_u_2_51 = u_dot_of_u_2_47 - u_dot_of_u_2_48
        let u_dot_of_u_2_51 = u_dot_of_u_2_47 - u_dot_of_u_2_48;
        // u_dot_of_u_2_52 = u_dot_of_u_2_51*q_ground1_dot_2
        let u_dot_of_u_2_52 = u_dot_of_u_2_51
            .mul_add(
                q_ground1_dot_2_0,
                q_ground1_dot_2.mul_add(u_dot_of_u_2_51_0, sums[87]),
            );
        // u_dot_of_u_2_53 = l*u_dot_of_u_2_49 + minus_l*u_dot_of_u_2_50 + minus_l*u_dot_of_u_2_52
        let u_dot_of_u_2_53 = u_dot_of_u_2_52
            .mul_add(minus_l, u_dot_of_u_2_50.mul_add(minus_l, l * u_dot_of_u_2_49));
        // u_dot_of_u_2_54 = m_l_2*u_dot_of_u_2_49 + minus_m_l_2*u_dot_of_u_2_50 +
        //   minus_m_l_2*u_dot_of_u_2_52
        let u_dot_of_u_2_54 = u_dot_of_u_2_52
            .mul_add(
                minus_m_l_2,
                u_dot_of_u_2_50.mul_add(minus_m_l_2, m_l_2 * u_dot_of_u_2_49),
            );
        // u_dot_of_place_31 = sin_q_pin1_sin_angle_inv*sin_q_pin1_sin_angle_inv
        let u_dot_of_place_31 = sin_q_pin1_sin_angle_inv
            .mul_add(sin_q_pin1_sin_angle_inv_0 + sin_q_pin1_sin_angle_inv_0, sums[88]);
        // u_dot_of_place_32 = u_dot_of_place_20*u_dot_of_place_20
        let u_dot_of_place_32 = u_dot_of_place_20
            .mul_add(u_dot_of_place_20_0 + u_dot_of_place_20_0, sums[89]);
        // u_dot_of_place_33 = cos_q_pin1*u_dot_of_place_22
        let u_dot_of_place_33 = u_dot_of_place_22
            .mul_add(cos_q_pin1_0, cos_q_pin1.mul_add(u_dot_of_place_22_0, sums[90]));
        // u_dot_of_place_34 = u_dot_of_place_22*u_dot_of_place_22
        let u_dot_of_place_34 = u_dot_of_place_22
            .mul_add(u_dot_of_place_22_0 + u_dot_of_place_22_0, sums[91]);
        // u_dot_of_place_35 = cos_q_pin2*u_dot_of_place_24
        let u_dot_of_place_35 = u_dot_of_place_24
            .mul_add(cos_q_pin2_0, cos_q_pin2.mul_add(u_dot_of_place_24_0, sums[92]));
        // u_dot_of_place_36 = sin_q_pin1_sin_angle_inv*u_dot_of_place_35
        let u_dot_of_place_36 = u_dot_of_place_35
            .mul_add(
                sin_q_pin1_sin_angle_inv_0,
                sin_q_pin1_sin_angle_inv.mul_add(u_dot_of_place_35_0, sums[93]),
            );
        // u_dot_of_place_37 = u_dot_of_place_24*u_dot_of_place_24
        let u_dot_of_place_37 = u_dot_of_place_24
            .mul_add(u_dot_of_place_24_0 + u_dot_of_place_24_0, sums[94]);
        // u_dot_of_u_2_55 = u_dot_of_u_2_8*sin_q_pin1_sin_angle_inv
        let u_dot_of_u_2_55 = u_dot_of_u_2_8
            .mul_add(
                sin_q_pin1_sin_angle_inv_0,
                sin_q_pin1_sin_angle_inv.mul_add(u_dot_of_u_2_8_0, sums[95]),
            );
        // u_dot_of_u_2_56 = u_dot_of_u_2_9*sin_q_pin1_sin_angle_inv
        let u_dot_of_u_2_56 = u_dot_of_u_2_9
            .mul_add(
                sin_q_pin1_sin_angle_inv_0,
                sin_q_pin1_sin_angle_inv.mul_add(u_dot_of_u_2_9_0, sums[96]),
            );
        // u_dot_of_u_2_57 = u_dot_of_u_2_17*u_dot_of_place_20
        let u_dot_of_u_2_57 = u_dot_of_u_2_17
            .mul_add(
                u_dot_of_place_20_0,
                u_dot_of_place_20.mul_add(u_dot_of_u_2_17_0, sums[97]),
            );
        // u_dot_of_u_2_58 = u_dot_of_u_2_18*u_dot_of_place_20
        let u_dot_of_u_2_58 = u_dot_of_u_2_18
            .mul_add(
                u_dot_of_place_20_0,
                u_dot_of_place_20.mul_add(u_dot_of_u_2_18_0, sums[98]),
            );
        // u_2_sin_q_pin1 = u_2*sin_q_pin1
        let u_2_sin_q_pin1 = sin_q_pin1
            .mul_add(u_2_0, u_2.mul_add(sin_q_pin1_0, sums[99]));
        // u_dot_of_u_2_59 = u_dot_of_place_22*u_2_sin_q_pin1
        let u_dot_of_u_2_59 = u_dot_of_place_22
            .mul_add(
                u_2_sin_q_pin1_0,
                u_2_sin_q_pin1.mul_add(u_dot_of_place_22_0, sums[100]),
            );
        // u_dot_of_u_2_60 = u_dot_of_u_2*u_dot_of_u_2_59
        let u_dot_of_u_2_60 = u_dot_of_u_2_59
            .mul_add(u_dot_of_u_2_0, u_dot_of_u_2.mul_add(u_dot_of_u_2_59_0, sums[101]));
        // u_dot_of_u_2_61 = cos_q_pin1*u_dot_of_u_2_36
        let u_dot_of_u_2_61 = u_dot_of_u_2_36
            .mul_add(cos_q_pin1_0, cos_q_pin1.mul_add(u_dot_of_u_2_36_0, sums[102]));
        // u_dot_of_u_2_62 = u_2*u_dot_of_u_2_59
        let u_dot_of_u_2_62 = u_dot_of_u_2_59
            .mul_add(u_2_0, u_2.mul_add(u_dot_of_u_2_59_0, sums[103]));
        // u_dot_of_u_2_63 = u_dot_of_u_2_36*u_dot_of_place_22
        let u_dot_of_u_2_63 = u_dot_of_u_2_36
            .mul_add(
                u_dot_of_place_22_0,
                u_dot_of_place_22.mul_add(u_dot_of_u_2_36_0, sums[104]),
            );
        // u_dot_of_u_2_64 = u_dot_of_u_2_37*u_dot_of_place_22
        let u_dot_of_u_2_64 = u_dot_of_u_2_37
            .mul_add(
                u_dot_of_place_22_0,
                u_dot_of_place_22.mul_add(u_dot_of_u_2_37_0, sums[105]),
            );
        // u_dot_of_u_2_65 = sin_q_pin2*q_ground1_dot_2
        let u_dot_of_u_2_65 = q_ground1_dot_2
            .mul_add(sin_q_pin2_0, sin_q_pin2.mul_add(q_ground1_dot_2_0, sums[106]));
        // u_dot_of_u_2_66 = u_dot_of_place_18*u_dot_of_u_2_65
        let u_dot_of_u_2_66 = u_dot_of_place_18
            .mul_add(
                u_dot_of_u_2_65_0,
                u_dot_of_u_2_65.mul_add(u_dot_of_place_18_0, sums[107]),
            );
        // u_dot_of_u_2_67 = u_dot_of_u_2_2*u_dot_of_u_2_66
        let u_dot_of_u_2_67 = u_dot_of_u_2_66
            .mul_add(
                u_dot_of_u_2_2_0,
                u_dot_of_u_2_2.mul_add(u_dot_of_u_2_66_0, sums[108]),
            );
        // u_dot_of_u_2_68 = cos_q_pin2*u_dot_of_u_2_53
        let u_dot_of_u_2_68 = u_dot_of_u_2_53
            .mul_add(cos_q_pin2_0, cos_q_pin2.mul_add(u_dot_of_u_2_53_0, sums[109]));
        // u_dot_of_u_2_69 = l*u_dot_of_u_2_67 - u_dot_of_u_2_68
        let u_dot_of_u_2_69 = l * u_dot_of_u_2_67 - u_dot_of_u_2_68;
        // u_dot_of_u_2_70 = u_dot_of_u_2_69*sin_q_pin1_sin_angle_inv
        let u_dot_of_u_2_70 = u_dot_of_u_2_69
            .mul_add(
                sin_q_pin1_sin_angle_inv_0,
                sin_q_pin1_sin_angle_inv.mul_add(u_dot_of_u_2_69_0, sums[110]),
            );
        // u_dot_of_u_2_71 = q_ground1_dot_2*u_dot_of_u_2_65
        let u_dot_of_u_2_71 = u_dot_of_u_2_65
            .mul_add(
                q_ground1_dot_2_0,
                q_ground1_dot_2.mul_add(u_dot_of_u_2_65_0, sums[111]),
            );
        // u_dot_of_u_2_72 = u_dot_of_place_24*u_dot_of_u_2_71
        let u_dot_of_u_2_72 = u_dot_of_place_24
            .mul_add(
                u_dot_of_u_2_71_0,
                u_dot_of_u_2_71.mul_add(u_dot_of_place_24_0, sums[112]),
            );
        // u_dot_of_u_2_73 = u_dot_of_u_2_8*u_dot_of_place_35
        let u_dot_of_u_2_73 = u_dot_of_u_2_8
            .mul_add(
                u_dot_of_place_35_0,
                u_dot_of_place_35.mul_add(u_dot_of_u_2_8_0, sums[113]),
            );
        // u_dot_of_u_2_74 = u_dot_of_u_2_53*u_dot_of_place_24
        let u_dot_of_u_2_74 = u_dot_of_u_2_53
            .mul_add(
                u_dot_of_place_24_0,
                u_dot_of_place_24.mul_add(u_dot_of_u_2_53_0, sums[114]),
            );
        // u_dot_of_u_2_75 = u_dot_of_u_2_54*u_dot_of_place_24
        let u_dot_of_u_2_75 = u_dot_of_u_2_54
            .mul_add(
                u_dot_of_place_24_0,
                u_dot_of_place_24.mul_add(u_dot_of_u_2_54_0, sums[115]),
            );
        // u_dot_of_place_38 = weight + weight*u_dot_of_place_31 + m_l_2*u_dot_of_place_32 +
        //   minus_3_m_l_2*u_dot_of_place_33 + m_l_2*u_dot_of_place_34 + weight_2*u_dot_of_place_36 +
        //   m_l_2*u_dot_of_place_37
        let u_dot_of_place_38 = u_dot_of_place_36
            .mul_add(
                weight_2,
                u_dot_of_place_37
                    .mul_add(
                        m_l_2,
                        u_dot_of_place_34
                            .mul_add(
                                m_l_2,
                                u_dot_of_place_33
                                    .mul_add(
                                        minus_3_m_l_2,
                                        u_dot_of_place_32.mul_add(m_l_2, weight * u_dot_of_place_31),
                                    ),
                            ),
                    ),
            );
        // u_dot_of_u_2_76 = weight_3*cos_q + weight_3*u_dot_of_place_19 + weight_4*u_dot_of_place_21 +
        //   minus_6_m_l_g*u_dot_of_place_23 + weight_4*u_dot_of_place_25 + weight_5*u_dot_of_u_2_55 +
        //   u_dot_of_u_2_56 + weight_6*u_dot_of_u_2_57 + u_dot_of_u_2_58 + weight_7*u_dot_of_u_2_60 +
        //   minus_6_m_l*u_dot_of_u_2_61 + minus_6_m_l_2*u_dot_of_u_2_62 + weight_6*u_dot_of_u_2_63 +
        //   u_dot_of_u_2_64 + minus_6_m_l*u_dot_of_u_2_70 + weight_7*u_dot_of_u_2_72 +
        //   weight_8*u_dot_of_u_2_73 + weight_6*u_dot_of_u_2_74 + u_dot_of_u_2_75
        let u_dot_of_u_2_76 = u_dot_of_u_2_70
            .mul_add(
                minus_6_m_l,
                u_dot_of_u_2_74
                    .mul_add(
                        weight_6,
                        u_dot_of_u_2_63
                            .mul_add(
                                weight_6,
                                u_dot_of_u_2_61
                                    .mul_add(
                                        minus_6_m_l,
                                        u_dot_of_u_2_57
                                            .mul_add(
                                                weight_6,
                                                u_dot_of_u_2_73
                                                    .mul_add(
                                                        weight_8,
                                                        u_dot_of_u_2_55
                                                            .mul_add(
                                                                weight_5,
                                                                u_dot_of_u_2_72
                                                                    .mul_add(
                                                                        weight_7,
                                                                        u_dot_of_u_2_62
                                                                            .mul_add(
                                                                                minus_6_m_l_2,
                                                                                u_dot_of_u_2_60
                                                                                    .mul_add(
                                                                                        weight_7,
                                                                                        u_dot_of_place_25
                                                                                            .mul_add(
                                                                                                weight_4,
                                                                                                u_dot_of_place_23
                                                                                                    .mul_add(
                                                                                                        minus_6_m_l_g,
                                                                                                        u_dot_of_place_21
                                                                                                            .mul_add(
                                                                                                                weight_4,
                                                                                                                u_dot_of_place_19.mul_add(weight_3, weight_3 * cos_q),
                                                                                                            ),
                                                                                                    ),
                                                                                            ),
                                                                                    ),
                                                                            ),
                                                                    ),
                                                            ) + u_dot_of_u_2_56,
                                                    ),
                                            ) + u_dot_of_u_2_58,
                                    ),
                            ) + u_dot_of_u_2_64,
                    ) + u_dot_of_u_2_75,
            );
        // u_dot_of_u_2_77 = u_dot_of_u_2_76/u_dot_of_place_38
        let u_dot_of_u_2_77 = u_dot_of_u_2_76
            .mul_add(
                over_u_dot_of_place_38,
                -(u_dot_of_place_38.mul_add(u_dot_of_u_2_77_0, sums[116]) * over_u_dot_of_place_38),
            );
        q_2_rate = u_2;
        q_ground1_rate = q_ground1_dot_2;
        q_ground2_rate = q_ground2_dot_2;
        q_pin1_rate = q_pin1_dot_2;
        q_pin2_rate = q_pin2_dot_2;
        u_2_rate = -S::ratio(1, 4) * u_dot_of_u_2_77;
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
                count * q_2_plus_q_pin1,
                count * q_2_plus_q_pin1,
                count * u_dot_of_place,
                count * u_dot_of_place,
                count * q_ground2,
                count * q_ground2,
                count * q_ground1_plus_q_pin2,
                count * q_ground1_plus_q_pin2,
                count * u_dot_of_place_2,
                count * u_dot_of_place_2,
                sin_q, cos_q, sin_q_pin1, sin_q, cos_q, cos_q_pin1, sin_q_ground1, cos_q_ground1,
                sin_q_ground2, cos_q_ground2, sin_angle, u_2, sin_angle_2, q_ground1_dot_2,
                sin_angle, u_dot_of_place_12, sin_angle_2, q_ground1_dot_2, cos_q_ground1,
                sin_q_pin1_sin_angle_inv, cos_q_ground2, u_dot_of_place_9, cos_q_plus_q_pin1,
                u_dot_of_place_18, cos_q_ground1_plus_q_pin2, cos_q_pin1, u_2_sin_angle_inv,
                sin_angle, u_dot_of_u_2_3, q_ground1_dot_2, u_dot_of_place_16, sin_angle_2,
                q_ground1_dot_2, u_dot_of_place_26, q_ground2_dot_2, sin_angle_2, u_dot_of_u_2_10,
                q_ground2_dot_2, cos_q_ground1, sin_q_ground1, u_2, q_ground1_dot_2, u_2,
                q_ground1_dot_2, u_dot_of_place_5, sin_q_pin1, u_2, q_ground1_dot_2, u_2,
                q_ground1_dot_2, u_dot_of_place_7, q_ground1_dot_2, cos_q_pin1, u_dot_of_place_9,
                u_dot_of_u_2_28, u_dot_of_u_2_31, u_dot_of_u_2_32, cos_q_ground1_plus_q_pin2,
                sin_q_ground1_plus_q_pin2, cos_q_ground2, q_ground2_dot_2, sin_q_ground2,
                sin_q_ground2, q_ground2_dot_2, cos_q_ground2, u_dot_of_place_17, sin_angle_2,
                u_dot_of_place_18, u_dot_of_place_18, u_dot_of_u_2_51, sin_q_pin1_sin_angle_inv,
                u_dot_of_place_20, cos_q_pin1, u_dot_of_place_22, cos_q_pin2,
                sin_q_pin1_sin_angle_inv, u_dot_of_place_24, u_dot_of_u_2_8, u_dot_of_u_2_9,
                u_dot_of_u_2_17, u_dot_of_u_2_18, u_2, u_dot_of_place_22, u_dot_of_u_2, cos_q_pin1,
                u_2, u_dot_of_u_2_36, u_dot_of_u_2_37, sin_q_pin2, u_dot_of_place_18,
                u_dot_of_u_2_2, cos_q_pin2, u_dot_of_u_2_69, q_ground1_dot_2, u_dot_of_place_24,
                u_dot_of_u_2_8, u_dot_of_u_2_53, u_dot_of_u_2_54, u_dot_of_place_38,
            ]),
            padded([
                cos_q_pin1, sin_q_pin1, cos_q_pin2, sin_q_pin2, cos_q, sin_q, cos_q_ground1,
                sin_q_ground1, cos_q_plus_q_pin1, sin_q_plus_q_pin1, cos_angle, sin_angle,
                cos_q_ground2, sin_q_ground2, cos_q_ground1_plus_q_pin2, sin_q_ground1_plus_q_pin2,
                cos_angle_2, sin_angle_2, sin_q_ground1, cos_q_ground1, u_dot_of_place_5,
                cos_q_ground1, sin_q_ground1, u_dot_of_place_7, u_dot_of_q_2_q_pin1_2,
                u_dot_of_q_2_q_pin1, u_dot_of_place_4, u_dot_of_place_3, sin_q_pin1_sin_angle_inv,
                sin_q_pin1_sin_angle_inv, u_dot_of_place_16, u_dot_of_place_16, u_2_sin_angle_inv,
                u_2_sin_angle_inv, u_dot_of_place_17, u_dot_of_place_17, sin_q_pin1_sin_angle_inv,
                u_dot_of_place_16, u_dot_of_place_20, u_dot_of_place_22, u_dot_of_place_22,
                sin_q_pin1_sin_angle_inv, u_dot_of_place_24, q_pin1_dot_2, u_dot_of_u_2_4,
                sin_angle_inv_cos_angle, sin_angle_inv_cos_angle, u_dot_of_u_2_6, u_dot_of_u_2_5,
                u_dot_of_place_26, q_pin2_dot_2, u_dot_of_u_2_12, u_dot_of_u_2_6, u_dot_of_place_27,
                u_dot_of_place_27, u_dot_of_u_2_15, q_ground1_dot_2, q_ground1_dot_2,
                cos_q_sin_q_ground1, sin_q_cos_q_ground1, sin_q_cos_q_ground1, cos_q_sin_q_ground1,
                u_dot_of_u_2_4, u_dot_of_u_2_23, cos_q_cos_q_ground1, sin_q_sin_q_ground1,
                sin_q_sin_q_ground1, cos_q_cos_q_ground1, u_dot_of_place_12, u_dot_of_place_28,
                u_dot_of_u_2_28, u_dot_of_u_2_32, u_dot_of_u_2_32, u_dot_of_place_22,
                u_dot_of_u_2_34, u_dot_of_u_2_2, u_dot_of_u_2_2, u_dot_of_place_4,
                u_dot_of_place_29, u_dot_of_u_2_42, u_dot_of_place_3, u_dot_of_place_30,
                u_dot_of_u_2_40, u_dot_of_u_2_15, u_dot_of_u_2_48, u_dot_of_u_2_5, u_dot_of_u_2_7,
                q_ground1_dot_2, sin_q_pin1_sin_angle_inv, u_dot_of_place_20, u_dot_of_place_22,
                u_dot_of_place_22, u_dot_of_place_24, u_dot_of_place_35, u_dot_of_place_24,
                sin_q_pin1_sin_angle_inv, sin_q_pin1_sin_angle_inv, u_dot_of_place_20,
                u_dot_of_place_20, sin_q_pin1, u_2_sin_q_pin1, u_dot_of_u_2_59, u_dot_of_u_2_36,
                u_dot_of_u_2_59, u_dot_of_place_22, u_dot_of_place_22, q_ground1_dot_2,
                u_dot_of_u_2_65, u_dot_of_u_2_66, u_dot_of_u_2_53, sin_q_pin1_sin_angle_inv,
                u_dot_of_u_2_65, u_dot_of_u_2_71, u_dot_of_place_35, u_dot_of_place_24,
                u_dot_of_place_24, u_dot_of_u_2_77,
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
        q_2_plus_q_pin1_last = q_2_plus_q_pin1;
        sin_q_plus_q_pin1_last = sin_q_plus_q_pin1;
        cos_q_plus_q_pin1_last = cos_q_plus_q_pin1;
        u_dot_of_place_last = u_dot_of_place;
        sin_angle_last = sin_angle;
        cos_angle_last = cos_angle;
        sin_q_ground2_last = sin_q_ground2;
        cos_q_ground2_last = cos_q_ground2;
        q_ground1_plus_q_pin2_last = q_ground1_plus_q_pin2;
        sin_q_ground1_plus_q_pin2_last = sin_q_ground1_plus_q_pin2;
        cos_q_ground1_plus_q_pin2_last = cos_q_ground1_plus_q_pin2;
        u_dot_of_place_2_last = u_dot_of_place_2;
        sin_angle_2_last = sin_angle_2;
        cos_angle_2_last = cos_angle_2;
        u_dot_of_q_2_q_pin1_last = u_dot_of_q_2_q_pin1;
        u_dot_of_q_2_q_pin1_2_last = u_dot_of_q_2_q_pin1_2;
        u_dot_of_place_3_last = u_dot_of_place_3;
        u_dot_of_place_4_last = u_dot_of_place_4;
        sin_q_sin_q_ground1_last = sin_q_sin_q_ground1;
        cos_q_cos_q_ground1_last = cos_q_cos_q_ground1;
        u_dot_of_place_5_last = u_dot_of_place_5;
        sin_q_cos_q_ground1_last = sin_q_cos_q_ground1;
        cos_q_sin_q_ground1_last = cos_q_sin_q_ground1;
        u_dot_of_place_7_last = u_dot_of_place_7;
        u_dot_of_place_9_last = u_dot_of_place_9;
        u_dot_of_place_12_last = u_dot_of_place_12;
        sin_q_pin1_sin_angle_inv_last = sin_q_pin1_sin_angle_inv;
        q_ground1_dot_2_last = q_ground1_dot_2;
        u_dot_of_place_16_last = u_dot_of_place_16;
        q_ground2_dot_2_last = q_ground2_dot_2;
        u_2_sin_angle_inv_last = u_2_sin_angle_inv;
        q_pin1_dot_2_last = q_pin1_dot_2;
        u_dot_of_place_17_last = u_dot_of_place_17;
        q_pin2_dot_2_last = q_pin2_dot_2;
        u_dot_of_u_2_last = u_dot_of_u_2;
        u_dot_of_u_2_2_last = u_dot_of_u_2_2;
        u_dot_of_place_18_last = u_dot_of_place_18;
        u_dot_of_place_20_last = u_dot_of_place_20;
        u_dot_of_place_22_last = u_dot_of_place_22;
        u_dot_of_place_24_last = u_dot_of_place_24;
        u_dot_of_u_2_3_last = u_dot_of_u_2_3;
        u_dot_of_u_2_4_last = u_dot_of_u_2_4;
        u_dot_of_u_2_5_last = u_dot_of_u_2_5;
        sin_angle_inv_cos_angle_last = sin_angle_inv_cos_angle;
        u_dot_of_u_2_6_last = u_dot_of_u_2_6;
        u_dot_of_u_2_7_last = u_dot_of_u_2_7;
        u_dot_of_u_2_8_last = u_dot_of_u_2_8;
        u_dot_of_u_2_9_last = u_dot_of_u_2_9;
        u_dot_of_u_2_10_last = u_dot_of_u_2_10;
        u_dot_of_place_26_last = u_dot_of_place_26;
        u_dot_of_u_2_12_last = u_dot_of_u_2_12;
        u_dot_of_place_27_last = u_dot_of_place_27;
        u_dot_of_u_2_15_last = u_dot_of_u_2_15;
        u_dot_of_u_2_17_last = u_dot_of_u_2_17;
        u_dot_of_u_2_18_last = u_dot_of_u_2_18;
        u_dot_of_u_2_23_last = u_dot_of_u_2_23;
        u_dot_of_u_2_28_last = u_dot_of_u_2_28;
        u_dot_of_place_28_last = u_dot_of_place_28;
        u_dot_of_u_2_31_last = u_dot_of_u_2_31;
        u_dot_of_u_2_32_last = u_dot_of_u_2_32;
        u_dot_of_u_2_34_last = u_dot_of_u_2_34;
        u_dot_of_u_2_36_last = u_dot_of_u_2_36;
        u_dot_of_u_2_37_last = u_dot_of_u_2_37;
        u_dot_of_u_2_40_last = u_dot_of_u_2_40;
        u_dot_of_place_29_last = u_dot_of_place_29;
        u_dot_of_u_2_42_last = u_dot_of_u_2_42;
        u_dot_of_place_30_last = u_dot_of_place_30;
        u_dot_of_u_2_48_last = u_dot_of_u_2_48;
        u_dot_of_u_2_51_last = u_dot_of_u_2_51;
        u_dot_of_u_2_53_last = u_dot_of_u_2_53;
        u_dot_of_u_2_54_last = u_dot_of_u_2_54;
        u_dot_of_place_35_last = u_dot_of_place_35;
        u_2_sin_q_pin1_last = u_2_sin_q_pin1;
        u_dot_of_u_2_59_last = u_dot_of_u_2_59;
        u_dot_of_u_2_65_last = u_dot_of_u_2_65;
        u_dot_of_u_2_66_last = u_dot_of_u_2_66;
        u_dot_of_u_2_69_last = u_dot_of_u_2_69;
        u_dot_of_u_2_71_last = u_dot_of_u_2_71;
        u_dot_of_place_38_last = u_dot_of_place_38;
        u_dot_of_u_2_77_last = u_dot_of_u_2_77;
    }
}

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 3,
            coordinates: 5,
            variables: 1,
            speeds: 1,
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
        240 * order + SLACK
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
