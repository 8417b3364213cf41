//! N-window four-bar: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/window_linkage/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

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
