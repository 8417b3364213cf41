//! Chain of three rods floating in a plane: Folding.
//!
//! Generated from `models/floating_chain/scenes/folding.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{CompiledScene, CompiledSystem, Lengths, Scalar, System};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// mass of each rod, kg
    pub m: S,
    /// length of each rod, m
    pub l: S,
    /// momentum p_x = ∂L/∂x', kg*m/s
    pub p_x: S,
    /// momentum p_y = ∂L/∂y', kg*m/s
    pub p_y: S,
    /// 12 times the angular momentum about n3 through the mass centre, kg*m^2/s
    pub H_n3_scaled: S,
    /// m*(6*x + l*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 + theta3_from_theta1)))/2 at the start, kg*m
    pub centre_x: S,
    /// m*(6*y + l*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 + theta3_from_theta1)))/2 at the start, kg*m
    pub centre_y: S,
    /// H_n3_scaled/(m*l^2), 1
    pub H_n3_scaled_per_m_per_l_squared: S,
    /// l/6, m
    pub l_by_6: S,
    /// p_y/(3*m), 1
    pub p_y_per_m_by_3: S,
    /// p_x/(3*m), 1
    pub p_x_per_m_by_3: S,
    /// m*l^2/12, kg*m^2
    pub m_l_squared_by_12: S,
}

impl<S: Scalar> Parameters<S> {
    /// From values in the order of [`PARAMETERS`].
    ///
    /// # Panics
    /// If `p` has fewer values than there are parameters.
    #[must_use]
    #[inline(always)]
    pub fn from_slice(p: &[S]) -> Self {
        Self {
            m: p[0], l: p[1], p_x: p[2], p_y: p[3], H_n3_scaled: p[4], centre_x: p[5],
            centre_y: p[6], H_n3_scaled_per_m_per_l_squared: p[7], l_by_6: p[8],
            p_y_per_m_by_3: p[9], p_x_per_m_by_3: p[10], m_l_squared_by_12: p[11],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 12] {
        let Self {
            m, l, p_x, p_y, H_n3_scaled, centre_x, centre_y, H_n3_scaled_per_m_per_l_squared,
            l_by_6, p_y_per_m_by_3, p_x_per_m_by_3, m_l_squared_by_12,
            ..
        } = self;
        [
            m, l, p_x, p_y, H_n3_scaled, centre_x, centre_y, H_n3_scaled_per_m_per_l_squared,
            l_by_6, p_y_per_m_by_3, p_x_per_m_by_3, m_l_squared_by_12,
        ]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 12] = [
    "m", "l", "p_x", "p_y", "H_n3_scaled", "centre_x", "centre_y",
    "H_n3_scaled_per_m_per_l_squared", "l_by_6", "p_y_per_m_by_3", "p_x_per_m_by_3",
    "m_l_squared_by_12",
];

/// Names of the outputs.
pub const OUTPUTS: [&str; 10] = [
    "x", "y", "theta1", "theta2", "theta3", "u1", "u2", "u3", "u4", "u5",
];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 66 operations, 3 sines and cosines.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    q: &[S; 5],
    u: &[S; 5],
) -> [S; 12] {
    let super::super::super::Parameters { m, l } = *p;
    let [x, y, theta1, theta2, theta3] = *q;
    let [u1, u2, u3, u4, u5] = *u;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    let (sin_theta3, cos_theta3) = theta3.sin_cos();
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    // Shared terms.
    let m_times_3 = S::int(3) * m;
    let u4_times_3 = S::int(3) * u4;
    let u3_doubled = S::int(2) * u3;
    // u5*sin(theta3) + u4_times_3*sin(theta2)
    let p_x_value_of_place = u4_times_3.mul_add(sin_theta2, u5 * sin_theta3);
    // u3_doubled*sin(theta1) + p_x_value_of_place
    let p_x_value_of_place_2 = u3_doubled.mul_add(sin_theta1, p_x_value_of_place);
    let m_l = m * l;
    let m_l_halved = S::ratio(1, 2) * m_l;
    // u5*cos(theta3) + u4_times_3*cos(theta2)
    let p_y_value_of_place = u4_times_3.mul_add(cos_theta2, u5 * cos_theta3);
    // u3_doubled*cos(theta1) + p_y_value_of_place
    let p_y_value_of_place_2 = u3_doubled.mul_add(cos_theta1, p_y_value_of_place);
    // u3 + u5
    let u3_plus_u5 = u3 + u5;
    // (sin(theta1)*sin(theta2) + cos(theta1)*cos(theta2))*(u3 + u4) + (sin(theta2)*sin(theta3) +
    //   cos(theta2)*cos(theta3))*(u4 + u5)
    let H_n3_scaled_value_of_place = cos_theta1
        .mul_add(cos_theta2, sin_theta1 * sin_theta2) * (u3 + u4)
        + cos_theta2.mul_add(cos_theta3, sin_theta2 * sin_theta3) * (u4 + u5);
    // 7*u4 + 3*u3_plus_u5
    let H_n3_scaled_value_of_u3_u4_u5 = u3_plus_u5.mul_add(S::int(3), S::int(7) * u4);
    // u3_plus_u5*(sin(theta1)*sin(theta3) + cos(theta1)*cos(theta3)) + 3*H_n3_scaled_value_of_place
    let H_n3_scaled_value_of_place_2 = u3_plus_u5
        * cos_theta1.mul_add(cos_theta3, sin_theta1 * sin_theta3)
        + S::int(3) * H_n3_scaled_value_of_place;
    // H_n3_scaled_value_of_u3_u4_u5 + H_n3_scaled_value_of_place_2
    let H_n3_scaled_value_of_place_3 = H_n3_scaled_value_of_u3_u4_u5 + H_n3_scaled_value_of_place_2;
    let l_m_l = l * m_l;
    let m_l_times_3_by_2 = S::ratio(3, 2) * m_l;
    let l_by_6_2 = S::ratio(1, 6) * l;
    // Values.
    // m
    let m_value = m;
    // l
    let l_value = l;
    // p_x = m*(6*u1 - l*(2*u3*sin(theta1) + 3*u4*sin(theta2) + u5*sin(theta3)))/2
    let p_x_value = (-p_x_value_of_place_2).mul_add(m_l_halved, u1 * m_times_3);
    // p_y = m*(6*u2 + l*(2*u3*cos(theta1) + 3*u4*cos(theta2) + u5*cos(theta3)))/2
    let p_y_value = m_l_halved.mul_add(p_y_value_of_place_2, u2 * m_times_3);
    // H_n3_scaled = m*l^2*(u3*(3 + 3*cos(theta1 - theta2) + cos(theta1 - theta3)) + u4*(7 + 3*sin(theta1 -
    //   theta2)*sin(theta1 - theta3) + 3*cos(theta1 - theta2)*(1 + cos(theta1 - theta3))) + u5*(3 +
    //   3*sin(theta1 - theta2)*sin(theta1 - theta3) + cos(theta1 - theta3)*(1 + 3*cos(theta1 - theta2))))
    let H_n3_scaled_value = H_n3_scaled_value_of_place_3 * l_m_l;
    // centre_x = m*(6*x + l*(2*cos(theta1) + 3*cos(theta2) + cos(theta3)))/2
    let centre_x_value = m_l.mul_add(cos_theta1, x * m_times_3) + m_l_halved * cos_theta3
        + m_l_times_3_by_2 * cos_theta2;
    // centre_y = m*(6*y + l*(2*sin(theta1) + 3*sin(theta2) + sin(theta3)))/2
    let centre_y_value = m_l.mul_add(sin_theta1, y * m_times_3) + m_l_halved * sin_theta3
        + m_l_times_3_by_2 * sin_theta2;
    // H_n3_scaled_per_m_per_l_squared = u3*(3 + 3*cos(theta1 - theta2) + cos(theta1 - theta3)) + u4*(7 +
    //   3*sin(theta1 - theta2)*sin(theta1 - theta3) + 3*cos(theta1 - theta2)*(1 + cos(theta1 - theta3))) +
    //   u5*(3 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + cos(theta1 - theta3)*(1 + 3*cos(theta1 -
    //   theta2)))
    let H_n3_scaled_per_m_per_l_squared_value = H_n3_scaled_value_of_place_3;
    // l_by_6 = l/6
    let l_by_6_value = l_by_6_2;
    // p_y_per_m_by_3 = u2 + l*(2*u3*cos(theta1) + 3*u4*cos(theta2) + u5*cos(theta3))/6
    let p_y_per_m_by_3_value = p_y_value_of_place_2.mul_add(l_by_6_2, u2);
    // p_x_per_m_by_3 = u1 - l*(2*u3*sin(theta1) + 3*u4*sin(theta2) + u5*sin(theta3))/6
    let p_x_per_m_by_3_value = (-p_x_value_of_place_2).mul_add(l_by_6_2, u1);
    // m_l_squared_by_12 = m*l^2/12
    let m_l_squared_by_12_value = S::ratio(1, 12) * l_m_l;
    [
        m_value, l_value, p_x_value, p_y_value, H_n3_scaled_value, centre_x_value, centre_y_value,
        H_n3_scaled_per_m_per_l_squared_value, l_by_6_value, p_y_per_m_by_3_value,
        p_x_per_m_by_3_value, m_l_squared_by_12_value,
    ]
}

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// 4 operations.
#[must_use]
pub fn start<S: Scalar>(
    _p: &super::super::super::Parameters<S>,
    q: &[S; 5],
    u: &[S; 5],
) -> ([S; 3], [S; 2]) {
    let [_, _, theta1, theta2, theta3] = *q;
    let [_, _, u3, u4, u5] = *u;
    // Values.
    // theta2_from_theta1 = theta2 - theta1
    let theta2_from_theta1_value = theta2 - theta1;
    // theta3_from_theta1 = theta3 - theta1
    let theta3_from_theta1_value = theta3 - theta1;
    // theta1
    let theta1_value = theta1;
    // u4_from_u3 = u4 - u3
    let u4_from_u3_value = u4 - u3;
    // u5_from_u3 = u5 - u3
    let u5_from_u3_value = u5 - u3;
    (
        [theta2_from_theta1_value, theta3_from_theta1_value, theta1_value],
        [u4_from_u3_value, u5_from_u3_value],
    )
}

/// The accelerations (u4_from_u3', u5_from_u3'), solved for when this code was generated.
///
/// 295 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [S; 2] {
    let Parameters { H_n3_scaled_per_m_per_l_squared, m_l_squared_by_12, .. } = *p;
    let [theta2_from_theta1, theta3_from_theta1, _] = *q;
    let [u4_from_u3, u5_from_u3] = *u;
    // Sines and cosines.
    let (sin_theta3_from_theta1, cos_theta3_from_theta1) = theta3_from_theta1.sin_cos();
    let (sin_theta2_from_theta1, cos_theta2_from_theta1) = theta2_from_theta1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // 1 + cos(theta3_from_theta1)
    let u3_of_place = S::int(1) + cos_theta3_from_theta1;
    let u3_of_place_2 = S::int(3) * cos_theta2_from_theta1;
    let u3_of_place_3 = S::int(3) * sin_theta2_from_theta1;
    let u3_of_place_4 = u3_of_place_3 * sin_theta3_from_theta1;
    let u3_of_place_5 = S::int(6) * cos_theta2_from_theta1;
    let u3_of_place_6 = S::int(2) * cos_theta3_from_theta1;
    let u3_of_place_7 = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    let u3_of_place_7_times_6 = S::int(6) * u3_of_place_7;
    // 1/(13 + u3_of_place*u3_of_place_5 + u3_of_place_6 + u3_of_place_7_times_6)
    let u3_of_place_8 = S::int(1)
        / (u3_of_place.mul_add(u3_of_place_5, S::int(13)) + u3_of_place_6 + u3_of_place_7_times_6);
    // u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3 = u3_of_place_8
        * (H_n3_scaled_per_m_per_l_squared
            - u4_from_u3 * (u3_of_place.mul_add(u3_of_place_2, S::int(7)) + u3_of_place_4)
            - u5_from_u3
                * (S::int(3) + cos_theta3_from_theta1 * (S::int(1) + u3_of_place_2)
                    + u3_of_place_4));
    // 3 + cos(theta2_from_theta1)
    let r1__of_place = S::int(3) + cos_theta2_from_theta1;
    // u3 + u5_from_u3
    let u3_plus_u5_from_u3 = u3 + u5_from_u3;
    // u3 + u4_from_u3
    let u3_plus_u4_from_u3 = u3 + u4_from_u3;
    // u5_from_u3 + u3_plus_u4_from_u3
    let r1__of_motion = u5_from_u3 + u3_plus_u4_from_u3;
    let r1__of_motion_2 = u3_of_place_5 * r1__of_motion;
    // u4_from_u3 + 2*u3_plus_u5_from_u3 + r1__of_motion_2
    let r1__of_motion_3 = u3_plus_u5_from_u3.mul_add(S::int(2), u4_from_u3) + r1__of_motion_2;
    let u5_from_u3_times_6 = S::int(6) * u5_from_u3;
    let r1__of_place_2 = S::int(2) * sin_theta3_from_theta1;
    // 10 + u3_of_place_2
    let r1__of_place_3 = S::int(10) + u3_of_place_2;
    let u3_times_13 = S::int(13) * u3;
    let u5_from_u3_sq = u5_from_u3 * u5_from_u3;
    let u4_from_u3_sq = u4_from_u3 * u4_from_u3;
    // u5_from_u3_sq + u4_from_u3_sq
    let r1__of_motion_4 = u5_from_u3_sq + u4_from_u3_sq;
    // 2*u5_from_u3_sq + u4_from_u3_sq + u3_of_place_5*r1__of_motion_4
    let r1__of_motion_5 = u5_from_u3_sq.mul_add(S::int(2), u4_from_u3_sq)
        + u3_of_place_5 * r1__of_motion_4;
    let u4_from_u3_sq_times_9 = S::int(9) * u4_from_u3_sq;
    let u4_from_u3_sq_times_3 = S::int(3) * u4_from_u3_sq;
    let u5_from_u3_sq_times_3 = S::int(3) * u5_from_u3_sq;
    // u5_from_u3_sq + u4_from_u3_sq_times_3
    let r1__of_motion_6 = u5_from_u3_sq + u4_from_u3_sq_times_3;
    let r1__of_place_4 = S::int(9) * cos_theta3_from_theta1;
    // 7 + r1__of_place_4
    let r1__of_place_5 = S::int(7) + r1__of_place_4;
    // 1 + u3_of_place_6
    let r1__of_place_6 = S::int(1) + u3_of_place_6;
    // 2 + cos(theta3_from_theta1)
    let r1__of_place_7 = S::int(2) + cos_theta3_from_theta1;
    // u5_from_u3 + 2*u3_plus_u4_from_u3
    let r1__of_motion_7 = u3_plus_u4_from_u3.mul_add(S::int(2), u5_from_u3);
    // u3_of_place_6*r1__of_motion + r1__of_motion_7
    let r1__of_motion_8 = u3_of_place_6.mul_add(r1__of_motion, r1__of_motion_7);
    // 6 + cos(theta3_from_theta1)
    let r1__of_place_8 = S::int(6) + cos_theta3_from_theta1;
    let u5_from_u3_doubled = S::int(2) * u5_from_u3;
    let u4_from_u3_times_14 = S::int(14) * u4_from_u3;
    // u3*(15 + u3_of_place_6) + r1__of_place_8*u5_from_u3_doubled
    let r1__of_u5_from_u3 = u3 * (S::int(15) + u3_of_place_6) + r1__of_place_8 * u5_from_u3_doubled;
    // u4_from_u3_times_14 + r1__of_u5_from_u3
    let r1__of_motion_9 = u4_from_u3_times_14 + r1__of_u5_from_u3;
    // u3_plus_u5_from_u3 + r1__of_motion_2
    let r1__of_motion_10 = u3_plus_u5_from_u3 + r1__of_motion_2;
    // u3_times_13 + u4_from_u3_times_14
    let r1__of_u4_from_u3 = u3_times_13 + u4_from_u3_times_14;
    // 10*u5_from_u3 + u3_of_place_5*r1__of_motion_7 + r1__of_u4_from_u3
    let r1__of_motion_11 = u3_of_place_5
        .mul_add(r1__of_motion_7, S::int(10) * u5_from_u3) + r1__of_u4_from_u3;
    // 7*u5_from_u3 + 9*u3_plus_u4_from_u3
    let r1__of_motion_12 = u3_plus_u4_from_u3.mul_add(S::int(9), S::int(7) * u5_from_u3);
    // u3_of_place_2 - 1
    let r1__of_place_9 = u3_of_place_2 - S::int(1);
    // r1__of_u4_from_u3 - u5_from_u3_doubled*r1__of_place_9
    let r1__of_motion_13 = (-u5_from_u3_doubled)
        .mul_add(r1__of_place_9, r1__of_u4_from_u3);
    // u4_from_u3_sq + r1__of_motion_4*cos(theta3_from_theta1)
    let r1__of_motion_14 = r1__of_motion_4
        .mul_add(cos_theta3_from_theta1, u4_from_u3_sq);
    let u5_from_u3_sq_times_7 = S::int(7) * u5_from_u3_sq;
    // u5_from_u3_sq + 2*r1__of_motion_14
    let r1__of_motion_15 = r1__of_motion_14.mul_add(S::int(2), u5_from_u3_sq);
    let u4_from_u3_sq_times_7 = S::int(7) * u4_from_u3_sq;
    // u5_from_u3_sq*r1__of_place_8 + u4_from_u3_sq_times_7
    let r1__of_motion_16 = u5_from_u3_sq.mul_add(r1__of_place_8, u4_from_u3_sq_times_7);
    let r1__of_place_10 = S::int(18) * cos_theta2_from_theta1;
    // 33 - u3_of_place_7*r1__of_place_10 + cos(theta3_from_theta1)*(14 + r1__of_place_4 -
    //   r1__of_place_10*(u3_of_place*cos(theta2_from_theta1) + u3_of_place_7))
    let r1__of_place_11 = S::int(33) - u3_of_place_7 * r1__of_place_10
        + cos_theta3_from_theta1
            * (S::int(14) + r1__of_place_4
                - r1__of_place_10 * u3_of_place.mul_add(cos_theta2_from_theta1, u3_of_place_7));
    let r1__of_place_11_inv = S::int(1) / r1__of_place_11;
    // u3*(cos(theta3_from_theta1)*(u3_of_place_3*(u3*(13 + u3_of_place_5) + 6*u4_from_u3*r1__of_place +
    //   u3_of_place_6*r1__of_motion_3 + u5_from_u3_times_6) + r1__of_place_2*(9*u4_from_u3 +
    //   8*u3_plus_u5_from_u3 - u3_of_place_2*r1__of_motion_3)) - 6*sin(theta2_from_theta1)*(3*u4_from_u3 +
    //   u3_plus_u5_from_u3 + u3_of_place_2*r1__of_motion) - sin(theta3_from_theta1)*(18*u4_from_u3 +
    //   u5_from_u3_times_6 + u3_of_place_2*(3*u3*(5 + 2*cos(theta2_from_theta1)) + u5_from_u3_times_6 +
    //   2*u4_from_u3*r1__of_place_3) + u3_times_13)) +
    //   cos(theta3_from_theta1)*(sin(theta3_from_theta1)*(8*u5_from_u3_sq - u3_of_place_2*r1__of_motion_5 +
    //   u4_from_u3_sq_times_9) + u3_of_place_3*(r1__of_motion_5*cos(theta3_from_theta1) +
    //   r1__of_place*u4_from_u3_sq_times_3 + u5_from_u3_sq_times_3)) -
    //   3*sin(theta3_from_theta1)*(cos(theta2_from_theta1)*(r1__of_place_3*u4_from_u3_sq +
    //   u5_from_u3_sq_times_3) + r1__of_motion_6) - u3_of_place_3*(u3_of_place_2*r1__of_motion_4 +
    //   r1__of_motion_6)
    let r1__of_motion_17 = u3
        * (cos_theta3_from_theta1
            * (u3_of_place_3
                * (u3 * (S::int(13) + u3_of_place_5) + S::int(6) * u4_from_u3 * r1__of_place
                    + u3_of_place_6 * r1__of_motion_3 + u5_from_u3_times_6)
                + r1__of_place_2
                    * (u3_plus_u5_from_u3.mul_add(S::int(8), S::int(9) * u4_from_u3)
                        - u3_of_place_2 * r1__of_motion_3))
            - S::int(6) * sin_theta2_from_theta1
                * (u4_from_u3.mul_add(S::int(3), u3_plus_u5_from_u3)
                    + u3_of_place_2 * r1__of_motion)
            - sin_theta3_from_theta1
                * (u5_from_u3_times_6 + S::int(18) * u4_from_u3
                    + u3_of_place_2
                        * (S::int(3) * u3 * cos_theta2_from_theta1.mul_add(S::int(2), S::int(5))
                            + u5_from_u3_times_6
                            + S::int(2) * u4_from_u3 * r1__of_place_3) + u3_times_13))
        + cos_theta3_from_theta1
            * (sin_theta3_from_theta1
                * ((-u3_of_place_2).mul_add(r1__of_motion_5, S::int(8) * u5_from_u3_sq)
                    + u4_from_u3_sq_times_9)
                + u3_of_place_3
                    * (r1__of_place
                        .mul_add(
                            u4_from_u3_sq_times_3,
                            r1__of_motion_5 * cos_theta3_from_theta1,
                        ) + u5_from_u3_sq_times_3))
        - S::int(3) * sin_theta3_from_theta1
            * (cos_theta2_from_theta1 * r1__of_place_3.mul_add(u4_from_u3_sq, u5_from_u3_sq_times_3)
                + r1__of_motion_6)
        - u3_of_place_3 * u3_of_place_2.mul_add(r1__of_motion_4, r1__of_motion_6);
    // r1_ = m_l_squared_by_12*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(u3*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15 +
    //   2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6 + cos(theta3_from_theta1)) +
    //   6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(3*u3 + 3*u4_from_u3 + 3*u5_from_u3 -
    //   cos(theta2_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 +
    //   u5_from_u3)))) + sin(theta3_from_theta1)*(18*u3 + 18*u4_from_u3 + 14*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3))) + 3*sin(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
    //   3*cos(theta2_from_theta1)))) - 3*cos(theta2_from_theta1)*(sin(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(5 + cos(theta3_from_theta1)) + 3*cos(theta2_from_theta1)*(2*u4_from_u3^2 +
    //   u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) +
    //   3*sin(theta2_from_theta1)*(u5_from_u3^2 - cos(theta3_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 +
    //   2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) +
    //   3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2 + cos(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(6 + cos(theta3_from_theta1)))) + sin(theta3_from_theta1)*(9*u4_from_u3^2 +
    //   7*u5_from_u3^2 + 9*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/((13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))) +
    //   m_l_squared_by_12*(u3*(cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(u3*(13 +
    //   6*cos(theta2_from_theta1)) + 6*u4_from_u3*(3 + cos(theta2_from_theta1)) + 6*u5_from_u3 +
    //   2*cos(theta3_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(8*u3 + 9*u4_from_u3 + 8*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3)))) - sin(theta3_from_theta1)*(13*u3 + 18*u4_from_u3 + 6*u5_from_u3 +
    //   3*cos(theta2_from_theta1)*(3*u3*(5 + 2*cos(theta2_from_theta1)) + 2*u4_from_u3*(10 +
    //   3*cos(theta2_from_theta1)) + 6*u5_from_u3)) - 6*sin(theta2_from_theta1)*(u3 + 3*u4_from_u3 +
    //   u5_from_u3 + 3*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(3*u4_from_u3^2*(3 + cos(theta2_from_theta1)) +
    //   3*u5_from_u3^2 + cos(theta3_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) + sin(theta3_from_theta1)*(9*u4_from_u3^2
    //   + 8*u5_from_u3^2 - 3*cos(theta2_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) -
    //   3*sin(theta3_from_theta1)*(3*u4_from_u3^2 + u5_from_u3^2 + cos(theta2_from_theta1)*(u4_from_u3^2*(10
    //   + 3*cos(theta2_from_theta1)) + 3*u5_from_u3^2)) - 3*sin(theta2_from_theta1)*(3*u4_from_u3^2 +
    //   u5_from_u3^2 + 3*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let r1_ = m_l_squared_by_12 * u3_of_place_8
        * (r1__of_place_11_inv
            * (-S::int(12) + S::int(9) * u3_of_place_7
                + cos_theta3_from_theta1 * (u3_of_place_4 - r1__of_place_5)
                + u3_of_place_2
                    * (u3_of_place_4 - S::int(3) - u3_of_place_2
                        + cos_theta3_from_theta1
                            * (u3_of_place_2
                                .mul_add(r1__of_place_6, u3_of_place_7_times_6) + r1__of_place_7)))
            * (u3
                * (S::int(3) * cos_theta3_from_theta1
                    * (sin_theta2_from_theta1
                        * u3_of_place_5.mul_add(r1__of_motion_8, r1__of_motion_9)
                        + r1__of_place_2
                            * (-r1__of_motion_10)
                                .mul_add(cos_theta2_from_theta1, S::int(3) * r1__of_motion))
                    + sin_theta3_from_theta1
                        * (-u3_of_place_2)
                            .mul_add(r1__of_motion_11, S::int(2) * r1__of_motion_12)
                    + u3_of_place_3 * r1__of_motion_13)
                + sin_theta3_from_theta1
                    * r1__of_motion_14.mul_add(S::int(9), u5_from_u3_sq_times_7)
                - u3_of_place_2
                    * (u3_of_place_3
                        * (-r1__of_motion_15)
                            .mul_add(cos_theta3_from_theta1, u5_from_u3_sq)
                        + sin_theta3_from_theta1
                            * (u5_from_u3_sq * (S::int(5) + cos_theta3_from_theta1)
                                + u3_of_place_2 * r1__of_motion_15 + u4_from_u3_sq_times_7))
                + u3_of_place_3
                    * r1__of_motion_16
                        .mul_add(
                            cos_theta3_from_theta1,
                            u5_from_u3_sq + u4_from_u3_sq_times_7,
                        )) + r1__of_motion_17);
    // u5_from_u3' = r1_*(33 - 18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(4*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot = S::ratio(1, 4) * r1_ * r1__of_place_11
        / (m_l_squared_by_12
            * (S::int(9)
                + cos_theta3_from_theta1
                    * (-S::int(9) * cos_theta2_from_theta1
                        * cos_theta2_from_theta1
                            .mul_add(cos_theta3_from_theta1, u3_of_place_7)
                        + S::int(5) * cos_theta3_from_theta1)));
    let u3_doubled = S::int(2) * u3;
    // u4_from_u3' = (3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2*(1 -
    //   3*cos(theta2_from_theta1)) + u3*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
    //   3*cos(theta2_from_theta1)))) - 3*u5_from_u3'*(4 + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta2_from_theta1))) + cos(theta3_from_theta1)*(9*sin(theta3_from_theta1)*(u4_from_u3^2 +
    //   u5_from_u3^2 + 2*u3*(u3 + u4_from_u3 + u5_from_u3)) - u5_from_u3'*(7 + 9*cos(theta3_from_theta1)) +
    //   3*cos(theta2_from_theta1)*(u5_from_u3'*(2 + cos(theta3_from_theta1)) -
    //   u5_from_u3^2*sin(theta3_from_theta1) - 2*u3*(sin(theta3_from_theta1)*(u3 + u5_from_u3 +
    //   6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3)) - 3*sin(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   3*sin(theta2_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 +
    //   u5_from_u3^2) + 2*u5_from_u3'*sin(theta3_from_theta1)) -
    //   3*cos(theta2_from_theta1)*(2*sin(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2) - u5_from_u3'*(1
    //   + 2*cos(theta3_from_theta1)))) + 3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2*(6 +
    //   cos(theta3_from_theta1)) + u3*(u3*(15 + 2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6
    //   + cos(theta3_from_theta1))) + u5_from_u3'*sin(theta3_from_theta1))) +
    //   sin(theta3_from_theta1)*(9*u4_from_u3^2 + 7*u5_from_u3^2 + 2*u3*(9*u3 + 9*u4_from_u3 + 7*u5_from_u3)
    //   + 9*u5_from_u3'*sin(theta2_from_theta1) +
    //   3*cos(theta2_from_theta1)*(3*u5_from_u3'*sin(theta2_from_theta1) - 7*u4_from_u3^2 - 5*u5_from_u3^2 -
    //   u3*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 +
    //   u5_from_u3)) - 3*cos(theta2_from_theta1)*(2*u4_from_u3^2 +
    //   u5_from_u3^2))))/(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) - 33 -
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))
    let u4_from_u3_dot = r1__of_place_11_inv
        * (S::int(3) * u5_from_u3_dot
            * (S::int(4) + u3_of_place_2 * (S::int(1) + cos_theta2_from_theta1))
            - u3_of_place_3
                * ((-u5_from_u3_sq).mul_add(r1__of_place_9, u3 * r1__of_motion_13)
                    + u4_from_u3_sq_times_7)
            - cos_theta3_from_theta1
                * (u3_of_place_3
                    * (u3
                        .mul_add(
                            r1__of_motion_9,
                            u5_from_u3_dot * sin_theta3_from_theta1,
                        ) + r1__of_motion_16) - u5_from_u3_dot * r1__of_place_5
                    + S::int(9) * sin_theta3_from_theta1
                        * r1__of_motion.mul_add(u3_doubled, r1__of_motion_4)
                    + u3_of_place_2
                        * (u3_of_place_2
                            * (-r1__of_place_2)
                                .mul_add(r1__of_motion_4, u5_from_u3_dot * r1__of_place_6)
                            - u5_from_u3_sq * sin_theta3_from_theta1
                            + u5_from_u3_dot * r1__of_place_7
                            + u3_of_place_3
                                * u5_from_u3_dot.mul_add(r1__of_place_2, r1__of_motion_15)
                            + u3_doubled
                                * (-r1__of_motion_10)
                                    .mul_add(
                                        sin_theta3_from_theta1,
                                        u3_of_place_3 * r1__of_motion_8,
                                    )))
            - sin_theta3_from_theta1
                * (u4_from_u3_sq_times_9 + S::int(9) * u5_from_u3_dot * sin_theta2_from_theta1
                    + u5_from_u3_sq_times_7
                    + u3_of_place_2
                        * (u5_from_u3_dot * u3_of_place_3 - S::int(5) * u5_from_u3_sq
                            - u3_of_place_2 * u4_from_u3_sq.mul_add(S::int(2), u5_from_u3_sq)
                            - u3 * r1__of_motion_11 - u4_from_u3_sq_times_7)
                    + r1__of_motion_12 * u3_doubled));
    [u4_from_u3_dot, u5_from_u3_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 21 operations, 2 sines and cosines.
#[must_use]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [S; 3] {
    let Parameters { H_n3_scaled_per_m_per_l_squared, .. } = *p;
    let [theta2_from_theta1, theta3_from_theta1, _] = *q;
    let [u4_from_u3, u5_from_u3] = *u;
    // Sines and cosines.
    let (sin_theta2_from_theta1, cos_theta2_from_theta1) = theta2_from_theta1.sin_cos();
    let (sin_theta3_from_theta1, cos_theta3_from_theta1) = theta3_from_theta1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let u3_of_place = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) + u3_of_place
    let u3_of_place_2 = cos_theta2_from_theta1 * (S::int(1) + cos_theta3_from_theta1) + u3_of_place;
    // u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3 = (H_n3_scaled_per_m_per_l_squared
        - u5_from_u3
            * (S::int(3)
                + cos_theta3_from_theta1 * cos_theta2_from_theta1.mul_add(S::int(3), S::int(1))
                + S::int(3) * u3_of_place)
        - u4_from_u3 * u3_of_place_2.mul_add(S::int(3), S::int(7)))
        / (cos_theta3_from_theta1.mul_add(S::int(2), S::int(13)) + S::int(6) * u3_of_place_2);
    // Values.
    // theta2_from_theta1' = u4_from_u3
    let theta2_from_theta1_dot_value = u4_from_u3;
    // theta3_from_theta1' = u5_from_u3
    let theta3_from_theta1_dot_value = u5_from_u3;
    [theta2_from_theta1_dot_value, theta3_from_theta1_dot_value, u3]
}

/// Kinetic energy T.
///
/// 47 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> S {
    let Parameters { m, l, H_n3_scaled, H_n3_scaled_per_m_per_l_squared, .. } = *p;
    let [theta2_from_theta1, theta3_from_theta1, _] = *q;
    let [u4_from_u3, u5_from_u3] = *u;
    // Sines and cosines.
    let (sin_theta2_from_theta1, cos_theta2_from_theta1) = theta2_from_theta1.sin_cos();
    let (sin_theta3_from_theta1, cos_theta3_from_theta1) = theta3_from_theta1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let u3_of_place = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) + u3_of_place
    let u3_of_place_2 = cos_theta2_from_theta1 * (S::int(1) + cos_theta3_from_theta1) + u3_of_place;
    // u5_from_u3*(3 + cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1)) + 3*u3_of_place) +
    //   u4_from_u3*(7 + 3*u3_of_place_2)
    let u3_of_motion = u5_from_u3
        * (S::int(3)
            + cos_theta3_from_theta1 * cos_theta2_from_theta1.mul_add(S::int(3), S::int(1))
            + S::int(3) * u3_of_place) + u4_from_u3 * u3_of_place_2.mul_add(S::int(3), S::int(7));
    // 13 + 2*cos(theta3_from_theta1) + 6*u3_of_place_2
    let u3_of_place_3 = cos_theta3_from_theta1.mul_add(S::int(2), S::int(13))
        + S::int(6) * u3_of_place_2;
    let u3_of_place_3_inv = S::int(1) / u3_of_place_3;
    // u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3 = u3_of_place_3_inv * (H_n3_scaled_per_m_per_l_squared - u3_of_motion);
    let l_inv_h_n3_scaled = H_n3_scaled / l;
    // u3_of_place_3_inv*l_inv_h_n3_scaled^2/m - m*l^2*(3*u5_from_u3^2 + u4_from_u3*(7*u4_from_u3 +
    //   6*u5_from_u3*(cos(theta2_from_theta1)*cos(theta3_from_theta1) + u3_of_place)) + u3*(2*u3_of_motion +
    //   u3*u3_of_place_3))
    let energy_of_motion = u3_of_place_3_inv * l_inv_h_n3_scaled * l_inv_h_n3_scaled / m
        - m * l * l
            * (S::int(3) * u5_from_u3 * u5_from_u3
                + u4_from_u3
                    * (S::int(6) * u5_from_u3
                        * cos_theta2_from_theta1
                            .mul_add(cos_theta3_from_theta1, u3_of_place) + S::int(7) * u4_from_u3)
                + u3 * u3.mul_add(u3_of_place_3, S::int(2) * u3_of_motion));
    // Values.
    // T = m*l^2*(3*u5_from_u3^2 + u3*(u3*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   2*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + 2*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1)))) + u4_from_u3*(7*u4_from_u3 +
    //   6*u5_from_u3*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1))))/24 - H_n3_scaled^2/(24*m*l^2*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))
    let energy = -S::ratio(1, 24) * energy_of_motion;
    energy
}

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// 21 operations, 2 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3]) -> S {
    let Parameters { m, l, p_x, p_y, H_n3_scaled, .. } = *p;
    let [theta2_from_theta1, theta3_from_theta1, _] = *q;
    // Sines and cosines.
    let (sin_theta2_from_theta1, cos_theta2_from_theta1) = theta2_from_theta1.sin_cos();
    let (sin_theta3_from_theta1, cos_theta3_from_theta1) = theta3_from_theta1.sin_cos();
    // Values.
    // V = (4*p_x^2 + 4*p_y^2 + H_n3_scaled^2/(l^2*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1)
    //   + 2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(24*m)
    let energy = S::ratio(1, 24)
        * (S::int(4) * p_x * p_x + S::int(4) * p_y * p_y
            + H_n3_scaled * H_n3_scaled
                / (l * l
                    * (S::int(13) + S::int(6) * sin_theta2_from_theta1 * sin_theta3_from_theta1
                        + S::int(2) * cos_theta3_from_theta1
                        + S::int(6) * cos_theta2_from_theta1
                            * (S::int(1) + cos_theta3_from_theta1)))) / m;
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 71 operations, 3 sines and cosines.
#[must_use]
pub fn outputs<S: Scalar>(p: &Parameters<S>, t: S, q: &[S; 3], u: &[S; 2]) -> [S; 10] {
    let Parameters {
        m, l, p_x, p_y, centre_x, centre_y, H_n3_scaled_per_m_per_l_squared, l_by_6, p_y_per_m_by_3,
        p_x_per_m_by_3,
        ..
    } = *p;
    let [theta2_from_theta1, theta3_from_theta1, theta1] = *q;
    let [u4_from_u3, u5_from_u3] = *u;
    // Sines and cosines.
    let (sin_theta2_from_theta1, cos_theta2_from_theta1) = theta2_from_theta1.sin_cos();
    let (sin_theta3_from_theta1, cos_theta3_from_theta1) = theta3_from_theta1.sin_cos();
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let u3_of_place = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) + u3_of_place
    let u3_of_place_2 = cos_theta2_from_theta1 * (S::int(1) + cos_theta3_from_theta1) + u3_of_place;
    // u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3 = (H_n3_scaled_per_m_per_l_squared
        - u5_from_u3
            * (S::int(3)
                + cos_theta3_from_theta1 * cos_theta2_from_theta1.mul_add(S::int(3), S::int(1))
                + S::int(3) * u3_of_place)
        - u4_from_u3 * u3_of_place_2.mul_add(S::int(3), S::int(7)))
        / (cos_theta3_from_theta1.mul_add(S::int(2), S::int(13)) + S::int(6) * u3_of_place_2);
    // cos(theta1)*cos(theta3_from_theta1) - sin(theta1)*sin(theta3_from_theta1)
    let u2_of_place = (-sin_theta1)
        .mul_add(sin_theta3_from_theta1, cos_theta1 * cos_theta3_from_theta1);
    // cos(theta1)*cos(theta2_from_theta1) - sin(theta1)*sin(theta2_from_theta1)
    let u2_of_place_2 = (-sin_theta1)
        .mul_add(sin_theta2_from_theta1, cos_theta1 * cos_theta2_from_theta1);
    let u2_of_place_2_times_3 = S::int(3) * u2_of_place_2;
    // 2*cos(theta1) + cos(theta1 + theta3_from_theta1) + u2_of_place_2_times_3
    let u2_of_place_3 = cos_theta1.mul_add(S::int(2), u2_of_place) + u2_of_place_2_times_3;
    // u2 = p_y_per_m_by_3 - l_by_6*(u3*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1)) + 3*u4_from_u3*cos(theta1 + theta2_from_theta1) + u5_from_u3*cos(theta1 +
    //   theta3_from_theta1))
    let u2 = p_y_per_m_by_3
        - l_by_6
            * (u4_from_u3.mul_add(u2_of_place_2_times_3, u5_from_u3 * u2_of_place)
                + u3 * u2_of_place_3);
    // cos(theta1)*sin(theta3_from_theta1) + sin(theta1)*cos(theta3_from_theta1)
    let u1_of_place = sin_theta1
        .mul_add(cos_theta3_from_theta1, cos_theta1 * sin_theta3_from_theta1);
    // cos(theta1)*sin(theta2_from_theta1) + sin(theta1)*cos(theta2_from_theta1)
    let u1_of_place_2 = sin_theta1
        .mul_add(cos_theta2_from_theta1, cos_theta1 * sin_theta2_from_theta1);
    let u1_of_place_2_times_3 = S::int(3) * u1_of_place_2;
    // 2*sin(theta1) + sin(theta1 + theta3_from_theta1) + u1_of_place_2_times_3
    let u1_of_place_3 = sin_theta1.mul_add(S::int(2), u1_of_place) + u1_of_place_2_times_3;
    // u1 = l_by_6*(u3*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1)) + 3*u4_from_u3*sin(theta1 + theta2_from_theta1) + u5_from_u3*sin(theta1 +
    //   theta3_from_theta1)) + p_x_per_m_by_3
    let u1 = p_x_per_m_by_3
        + l_by_6
            * (u4_from_u3.mul_add(u1_of_place_2_times_3, u5_from_u3 * u1_of_place)
                + u3 * u1_of_place_3);
    let m_inv_by_3 = S::ratio(1, 3) / m;
    let l_by_6_2 = S::ratio(1, 6) * l;
    // Values.
    // x = (p_x*t + centre_x)/(3*m) - l*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/6
    let x_value = m_inv_by_3 * p_x.mul_add(t, centre_x) - u2_of_place_3 * l_by_6_2;
    // y = (p_y*t + centre_y)/(3*m) - l*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/6
    let y_value = m_inv_by_3 * p_y.mul_add(t, centre_y) - u1_of_place_3 * l_by_6_2;
    // theta1
    let theta1_value = theta1;
    // theta2 = theta1 + theta2_from_theta1
    let theta2_value = theta1 + theta2_from_theta1;
    // theta3 = theta1 + theta3_from_theta1
    let theta3_value = theta1 + theta3_from_theta1;
    // u4 = u3 + u4_from_u3
    let u4_value = u3 + u4_from_u3;
    // u5 = u3 + u5_from_u3
    let u5_value = u3 + u5_from_u3;
    [
        x_value, y_value, theta1_value, theta2_value, theta3_value, u1, u2, u3, u4_value, u5_value,
    ]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 295 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 2],
) -> ([S; 3], [S; 2]) {
    let Parameters { H_n3_scaled_per_m_per_l_squared, m_l_squared_by_12, .. } = *p;
    let [theta2_from_theta1, theta3_from_theta1, _] = *q;
    let [u4_from_u3, u5_from_u3] = *u;
    // Sines and cosines.
    let (sin_theta3_from_theta1, cos_theta3_from_theta1) = theta3_from_theta1.sin_cos();
    let (sin_theta2_from_theta1, cos_theta2_from_theta1) = theta2_from_theta1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // 1 + cos(theta3_from_theta1)
    let u3_of_place = S::int(1) + cos_theta3_from_theta1;
    let u3_of_place_2 = S::int(3) * cos_theta2_from_theta1;
    let u3_of_place_3 = S::int(3) * sin_theta2_from_theta1;
    let u3_of_place_4 = u3_of_place_3 * sin_theta3_from_theta1;
    let u3_of_place_5 = S::int(6) * cos_theta2_from_theta1;
    let u3_of_place_6 = S::int(2) * cos_theta3_from_theta1;
    let u3_of_place_7 = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    let u3_of_place_7_times_6 = S::int(6) * u3_of_place_7;
    // 1/(13 + u3_of_place*u3_of_place_5 + u3_of_place_6 + u3_of_place_7_times_6)
    let u3_of_place_8 = S::int(1)
        / (u3_of_place.mul_add(u3_of_place_5, S::int(13)) + u3_of_place_6 + u3_of_place_7_times_6);
    // u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3 = u3_of_place_8
        * (H_n3_scaled_per_m_per_l_squared
            - u4_from_u3 * (u3_of_place.mul_add(u3_of_place_2, S::int(7)) + u3_of_place_4)
            - u5_from_u3
                * (S::int(3) + cos_theta3_from_theta1 * (S::int(1) + u3_of_place_2)
                    + u3_of_place_4));
    // 3 + cos(theta2_from_theta1)
    let r1__of_place = S::int(3) + cos_theta2_from_theta1;
    // u3 + u5_from_u3
    let u3_plus_u5_from_u3 = u3 + u5_from_u3;
    // u3 + u4_from_u3
    let u3_plus_u4_from_u3 = u3 + u4_from_u3;
    // u5_from_u3 + u3_plus_u4_from_u3
    let r1__of_motion = u5_from_u3 + u3_plus_u4_from_u3;
    let r1__of_motion_2 = u3_of_place_5 * r1__of_motion;
    // u4_from_u3 + 2*u3_plus_u5_from_u3 + r1__of_motion_2
    let r1__of_motion_3 = u3_plus_u5_from_u3.mul_add(S::int(2), u4_from_u3) + r1__of_motion_2;
    let u5_from_u3_times_6 = S::int(6) * u5_from_u3;
    let r1__of_place_2 = S::int(2) * sin_theta3_from_theta1;
    // 10 + u3_of_place_2
    let r1__of_place_3 = S::int(10) + u3_of_place_2;
    let u3_times_13 = S::int(13) * u3;
    let u5_from_u3_sq = u5_from_u3 * u5_from_u3;
    let u4_from_u3_sq = u4_from_u3 * u4_from_u3;
    // u5_from_u3_sq + u4_from_u3_sq
    let r1__of_motion_4 = u5_from_u3_sq + u4_from_u3_sq;
    // 2*u5_from_u3_sq + u4_from_u3_sq + u3_of_place_5*r1__of_motion_4
    let r1__of_motion_5 = u5_from_u3_sq.mul_add(S::int(2), u4_from_u3_sq)
        + u3_of_place_5 * r1__of_motion_4;
    let u4_from_u3_sq_times_9 = S::int(9) * u4_from_u3_sq;
    let u4_from_u3_sq_times_3 = S::int(3) * u4_from_u3_sq;
    let u5_from_u3_sq_times_3 = S::int(3) * u5_from_u3_sq;
    // u5_from_u3_sq + u4_from_u3_sq_times_3
    let r1__of_motion_6 = u5_from_u3_sq + u4_from_u3_sq_times_3;
    let r1__of_place_4 = S::int(9) * cos_theta3_from_theta1;
    // 7 + r1__of_place_4
    let r1__of_place_5 = S::int(7) + r1__of_place_4;
    // 1 + u3_of_place_6
    let r1__of_place_6 = S::int(1) + u3_of_place_6;
    // 2 + cos(theta3_from_theta1)
    let r1__of_place_7 = S::int(2) + cos_theta3_from_theta1;
    // u5_from_u3 + 2*u3_plus_u4_from_u3
    let r1__of_motion_7 = u3_plus_u4_from_u3.mul_add(S::int(2), u5_from_u3);
    // u3_of_place_6*r1__of_motion + r1__of_motion_7
    let r1__of_motion_8 = u3_of_place_6.mul_add(r1__of_motion, r1__of_motion_7);
    // 6 + cos(theta3_from_theta1)
    let r1__of_place_8 = S::int(6) + cos_theta3_from_theta1;
    let u5_from_u3_doubled = S::int(2) * u5_from_u3;
    let u4_from_u3_times_14 = S::int(14) * u4_from_u3;
    // u3*(15 + u3_of_place_6) + r1__of_place_8*u5_from_u3_doubled
    let r1__of_u5_from_u3 = u3 * (S::int(15) + u3_of_place_6) + r1__of_place_8 * u5_from_u3_doubled;
    // u4_from_u3_times_14 + r1__of_u5_from_u3
    let r1__of_motion_9 = u4_from_u3_times_14 + r1__of_u5_from_u3;
    // u3_plus_u5_from_u3 + r1__of_motion_2
    let r1__of_motion_10 = u3_plus_u5_from_u3 + r1__of_motion_2;
    // u3_times_13 + u4_from_u3_times_14
    let r1__of_u4_from_u3 = u3_times_13 + u4_from_u3_times_14;
    // 10*u5_from_u3 + u3_of_place_5*r1__of_motion_7 + r1__of_u4_from_u3
    let r1__of_motion_11 = u3_of_place_5
        .mul_add(r1__of_motion_7, S::int(10) * u5_from_u3) + r1__of_u4_from_u3;
    // 7*u5_from_u3 + 9*u3_plus_u4_from_u3
    let r1__of_motion_12 = u3_plus_u4_from_u3.mul_add(S::int(9), S::int(7) * u5_from_u3);
    // u3_of_place_2 - 1
    let r1__of_place_9 = u3_of_place_2 - S::int(1);
    // r1__of_u4_from_u3 - u5_from_u3_doubled*r1__of_place_9
    let r1__of_motion_13 = (-u5_from_u3_doubled)
        .mul_add(r1__of_place_9, r1__of_u4_from_u3);
    // u4_from_u3_sq + r1__of_motion_4*cos(theta3_from_theta1)
    let r1__of_motion_14 = r1__of_motion_4
        .mul_add(cos_theta3_from_theta1, u4_from_u3_sq);
    let u5_from_u3_sq_times_7 = S::int(7) * u5_from_u3_sq;
    // u5_from_u3_sq + 2*r1__of_motion_14
    let r1__of_motion_15 = r1__of_motion_14.mul_add(S::int(2), u5_from_u3_sq);
    let u4_from_u3_sq_times_7 = S::int(7) * u4_from_u3_sq;
    // u5_from_u3_sq*r1__of_place_8 + u4_from_u3_sq_times_7
    let r1__of_motion_16 = u5_from_u3_sq.mul_add(r1__of_place_8, u4_from_u3_sq_times_7);
    let r1__of_place_10 = S::int(18) * cos_theta2_from_theta1;
    // 33 - u3_of_place_7*r1__of_place_10 + cos(theta3_from_theta1)*(14 + r1__of_place_4 -
    //   r1__of_place_10*(u3_of_place*cos(theta2_from_theta1) + u3_of_place_7))
    let r1__of_place_11 = S::int(33) - u3_of_place_7 * r1__of_place_10
        + cos_theta3_from_theta1
            * (S::int(14) + r1__of_place_4
                - r1__of_place_10 * u3_of_place.mul_add(cos_theta2_from_theta1, u3_of_place_7));
    let r1__of_place_11_inv = S::int(1) / r1__of_place_11;
    // u3*(cos(theta3_from_theta1)*(u3_of_place_3*(u3*(13 + u3_of_place_5) + 6*u4_from_u3*r1__of_place +
    //   u3_of_place_6*r1__of_motion_3 + u5_from_u3_times_6) + r1__of_place_2*(9*u4_from_u3 +
    //   8*u3_plus_u5_from_u3 - u3_of_place_2*r1__of_motion_3)) - 6*sin(theta2_from_theta1)*(3*u4_from_u3 +
    //   u3_plus_u5_from_u3 + u3_of_place_2*r1__of_motion) - sin(theta3_from_theta1)*(18*u4_from_u3 +
    //   u5_from_u3_times_6 + u3_of_place_2*(3*u3*(5 + 2*cos(theta2_from_theta1)) + u5_from_u3_times_6 +
    //   2*u4_from_u3*r1__of_place_3) + u3_times_13)) +
    //   cos(theta3_from_theta1)*(sin(theta3_from_theta1)*(8*u5_from_u3_sq - u3_of_place_2*r1__of_motion_5 +
    //   u4_from_u3_sq_times_9) + u3_of_place_3*(r1__of_motion_5*cos(theta3_from_theta1) +
    //   r1__of_place*u4_from_u3_sq_times_3 + u5_from_u3_sq_times_3)) -
    //   3*sin(theta3_from_theta1)*(cos(theta2_from_theta1)*(r1__of_place_3*u4_from_u3_sq +
    //   u5_from_u3_sq_times_3) + r1__of_motion_6) - u3_of_place_3*(u3_of_place_2*r1__of_motion_4 +
    //   r1__of_motion_6)
    let r1__of_motion_17 = u3
        * (cos_theta3_from_theta1
            * (u3_of_place_3
                * (u3 * (S::int(13) + u3_of_place_5) + S::int(6) * u4_from_u3 * r1__of_place
                    + u3_of_place_6 * r1__of_motion_3 + u5_from_u3_times_6)
                + r1__of_place_2
                    * (u3_plus_u5_from_u3.mul_add(S::int(8), S::int(9) * u4_from_u3)
                        - u3_of_place_2 * r1__of_motion_3))
            - S::int(6) * sin_theta2_from_theta1
                * (u4_from_u3.mul_add(S::int(3), u3_plus_u5_from_u3)
                    + u3_of_place_2 * r1__of_motion)
            - sin_theta3_from_theta1
                * (u5_from_u3_times_6 + S::int(18) * u4_from_u3
                    + u3_of_place_2
                        * (S::int(3) * u3 * cos_theta2_from_theta1.mul_add(S::int(2), S::int(5))
                            + u5_from_u3_times_6
                            + S::int(2) * u4_from_u3 * r1__of_place_3) + u3_times_13))
        + cos_theta3_from_theta1
            * (sin_theta3_from_theta1
                * ((-u3_of_place_2).mul_add(r1__of_motion_5, S::int(8) * u5_from_u3_sq)
                    + u4_from_u3_sq_times_9)
                + u3_of_place_3
                    * (r1__of_place
                        .mul_add(
                            u4_from_u3_sq_times_3,
                            r1__of_motion_5 * cos_theta3_from_theta1,
                        ) + u5_from_u3_sq_times_3))
        - S::int(3) * sin_theta3_from_theta1
            * (cos_theta2_from_theta1 * r1__of_place_3.mul_add(u4_from_u3_sq, u5_from_u3_sq_times_3)
                + r1__of_motion_6)
        - u3_of_place_3 * u3_of_place_2.mul_add(r1__of_motion_4, r1__of_motion_6);
    // r1_ = m_l_squared_by_12*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(u3*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15 +
    //   2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6 + cos(theta3_from_theta1)) +
    //   6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(3*u3 + 3*u4_from_u3 + 3*u5_from_u3 -
    //   cos(theta2_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 +
    //   u5_from_u3)))) + sin(theta3_from_theta1)*(18*u3 + 18*u4_from_u3 + 14*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3))) + 3*sin(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
    //   3*cos(theta2_from_theta1)))) - 3*cos(theta2_from_theta1)*(sin(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(5 + cos(theta3_from_theta1)) + 3*cos(theta2_from_theta1)*(2*u4_from_u3^2 +
    //   u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) +
    //   3*sin(theta2_from_theta1)*(u5_from_u3^2 - cos(theta3_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 +
    //   2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) +
    //   3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2 + cos(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(6 + cos(theta3_from_theta1)))) + sin(theta3_from_theta1)*(9*u4_from_u3^2 +
    //   7*u5_from_u3^2 + 9*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/((13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))) +
    //   m_l_squared_by_12*(u3*(cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(u3*(13 +
    //   6*cos(theta2_from_theta1)) + 6*u4_from_u3*(3 + cos(theta2_from_theta1)) + 6*u5_from_u3 +
    //   2*cos(theta3_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(8*u3 + 9*u4_from_u3 + 8*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3)))) - sin(theta3_from_theta1)*(13*u3 + 18*u4_from_u3 + 6*u5_from_u3 +
    //   3*cos(theta2_from_theta1)*(3*u3*(5 + 2*cos(theta2_from_theta1)) + 2*u4_from_u3*(10 +
    //   3*cos(theta2_from_theta1)) + 6*u5_from_u3)) - 6*sin(theta2_from_theta1)*(u3 + 3*u4_from_u3 +
    //   u5_from_u3 + 3*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(3*u4_from_u3^2*(3 + cos(theta2_from_theta1)) +
    //   3*u5_from_u3^2 + cos(theta3_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) + sin(theta3_from_theta1)*(9*u4_from_u3^2
    //   + 8*u5_from_u3^2 - 3*cos(theta2_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) -
    //   3*sin(theta3_from_theta1)*(3*u4_from_u3^2 + u5_from_u3^2 + cos(theta2_from_theta1)*(u4_from_u3^2*(10
    //   + 3*cos(theta2_from_theta1)) + 3*u5_from_u3^2)) - 3*sin(theta2_from_theta1)*(3*u4_from_u3^2 +
    //   u5_from_u3^2 + 3*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let r1_ = m_l_squared_by_12 * u3_of_place_8
        * (r1__of_place_11_inv
            * (-S::int(12) + S::int(9) * u3_of_place_7
                + cos_theta3_from_theta1 * (u3_of_place_4 - r1__of_place_5)
                + u3_of_place_2
                    * (u3_of_place_4 - S::int(3) - u3_of_place_2
                        + cos_theta3_from_theta1
                            * (u3_of_place_2
                                .mul_add(r1__of_place_6, u3_of_place_7_times_6) + r1__of_place_7)))
            * (u3
                * (S::int(3) * cos_theta3_from_theta1
                    * (sin_theta2_from_theta1
                        * u3_of_place_5.mul_add(r1__of_motion_8, r1__of_motion_9)
                        + r1__of_place_2
                            * (-r1__of_motion_10)
                                .mul_add(cos_theta2_from_theta1, S::int(3) * r1__of_motion))
                    + sin_theta3_from_theta1
                        * (-u3_of_place_2)
                            .mul_add(r1__of_motion_11, S::int(2) * r1__of_motion_12)
                    + u3_of_place_3 * r1__of_motion_13)
                + sin_theta3_from_theta1
                    * r1__of_motion_14.mul_add(S::int(9), u5_from_u3_sq_times_7)
                - u3_of_place_2
                    * (u3_of_place_3
                        * (-r1__of_motion_15)
                            .mul_add(cos_theta3_from_theta1, u5_from_u3_sq)
                        + sin_theta3_from_theta1
                            * (u5_from_u3_sq * (S::int(5) + cos_theta3_from_theta1)
                                + u3_of_place_2 * r1__of_motion_15 + u4_from_u3_sq_times_7))
                + u3_of_place_3
                    * r1__of_motion_16
                        .mul_add(
                            cos_theta3_from_theta1,
                            u5_from_u3_sq + u4_from_u3_sq_times_7,
                        )) + r1__of_motion_17);
    // u5_from_u3' = r1_*(33 - 18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(4*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot = S::ratio(1, 4) * r1_ * r1__of_place_11
        / (m_l_squared_by_12
            * (S::int(9)
                + cos_theta3_from_theta1
                    * (-S::int(9) * cos_theta2_from_theta1
                        * cos_theta2_from_theta1
                            .mul_add(cos_theta3_from_theta1, u3_of_place_7)
                        + S::int(5) * cos_theta3_from_theta1)));
    let u3_doubled = S::int(2) * u3;
    // u4_from_u3' = (3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2*(1 -
    //   3*cos(theta2_from_theta1)) + u3*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
    //   3*cos(theta2_from_theta1)))) - 3*u5_from_u3'*(4 + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta2_from_theta1))) + cos(theta3_from_theta1)*(9*sin(theta3_from_theta1)*(u4_from_u3^2 +
    //   u5_from_u3^2 + 2*u3*(u3 + u4_from_u3 + u5_from_u3)) - u5_from_u3'*(7 + 9*cos(theta3_from_theta1)) +
    //   3*cos(theta2_from_theta1)*(u5_from_u3'*(2 + cos(theta3_from_theta1)) -
    //   u5_from_u3^2*sin(theta3_from_theta1) - 2*u3*(sin(theta3_from_theta1)*(u3 + u5_from_u3 +
    //   6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3)) - 3*sin(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   3*sin(theta2_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 +
    //   u5_from_u3^2) + 2*u5_from_u3'*sin(theta3_from_theta1)) -
    //   3*cos(theta2_from_theta1)*(2*sin(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2) - u5_from_u3'*(1
    //   + 2*cos(theta3_from_theta1)))) + 3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2*(6 +
    //   cos(theta3_from_theta1)) + u3*(u3*(15 + 2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6
    //   + cos(theta3_from_theta1))) + u5_from_u3'*sin(theta3_from_theta1))) +
    //   sin(theta3_from_theta1)*(9*u4_from_u3^2 + 7*u5_from_u3^2 + 2*u3*(9*u3 + 9*u4_from_u3 + 7*u5_from_u3)
    //   + 9*u5_from_u3'*sin(theta2_from_theta1) +
    //   3*cos(theta2_from_theta1)*(3*u5_from_u3'*sin(theta2_from_theta1) - 7*u4_from_u3^2 - 5*u5_from_u3^2 -
    //   u3*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 +
    //   u5_from_u3)) - 3*cos(theta2_from_theta1)*(2*u4_from_u3^2 +
    //   u5_from_u3^2))))/(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) - 33 -
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))
    let u4_from_u3_dot = r1__of_place_11_inv
        * (S::int(3) * u5_from_u3_dot
            * (S::int(4) + u3_of_place_2 * (S::int(1) + cos_theta2_from_theta1))
            - u3_of_place_3
                * ((-u5_from_u3_sq).mul_add(r1__of_place_9, u3 * r1__of_motion_13)
                    + u4_from_u3_sq_times_7)
            - cos_theta3_from_theta1
                * (u3_of_place_3
                    * (u3
                        .mul_add(
                            r1__of_motion_9,
                            u5_from_u3_dot * sin_theta3_from_theta1,
                        ) + r1__of_motion_16) - u5_from_u3_dot * r1__of_place_5
                    + S::int(9) * sin_theta3_from_theta1
                        * r1__of_motion.mul_add(u3_doubled, r1__of_motion_4)
                    + u3_of_place_2
                        * (u3_of_place_2
                            * (-r1__of_place_2)
                                .mul_add(r1__of_motion_4, u5_from_u3_dot * r1__of_place_6)
                            - u5_from_u3_sq * sin_theta3_from_theta1
                            + u5_from_u3_dot * r1__of_place_7
                            + u3_of_place_3
                                * u5_from_u3_dot.mul_add(r1__of_place_2, r1__of_motion_15)
                            + u3_doubled
                                * (-r1__of_motion_10)
                                    .mul_add(
                                        sin_theta3_from_theta1,
                                        u3_of_place_3 * r1__of_motion_8,
                                    )))
            - sin_theta3_from_theta1
                * (u4_from_u3_sq_times_9 + S::int(9) * u5_from_u3_dot * sin_theta2_from_theta1
                    + u5_from_u3_sq_times_7
                    + u3_of_place_2
                        * (u5_from_u3_dot * u3_of_place_3 - S::int(5) * u5_from_u3_sq
                            - u3_of_place_2 * u4_from_u3_sq.mul_add(S::int(2), u5_from_u3_sq)
                            - u3 * r1__of_motion_11 - u4_from_u3_sq_times_7)
                    + r1__of_motion_12 * u3_doubled));
    // Values.
    // theta2_from_theta1' = u4_from_u3
    let theta2_from_theta1_dot_value = u4_from_u3;
    // theta3_from_theta1' = u5_from_u3
    let theta3_from_theta1_dot_value = u5_from_u3;
    (
        [theta2_from_theta1_dot_value, theta3_from_theta1_dot_value, u3],
        [u4_from_u3_dot, u5_from_u3_dot],
    )
}

/// Jacobian of the derivative by the state; columns theta2_from_theta1, theta3_from_theta1, theta1, u4_from_u3, u5_from_u3.
///
/// 1104 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [[S; 5]; 5] {
    let Parameters { H_n3_scaled_per_m_per_l_squared, m_l_squared_by_12, .. } = *p;
    let [theta2_from_theta1, theta3_from_theta1, _] = *q;
    let [u4_from_u3, u5_from_u3] = *u;
    // Sines and cosines.
    let (sin_theta3_from_theta1, cos_theta3_from_theta1) = theta3_from_theta1.sin_cos();
    let (sin_theta2_from_theta1, cos_theta2_from_theta1) = theta2_from_theta1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // 1 + cos(theta3_from_theta1)
    let u3_of_place = S::int(1) + cos_theta3_from_theta1;
    let u3_of_place_2 = S::int(3) * cos_theta2_from_theta1;
    let u3_of_place_3 = S::int(3) * sin_theta2_from_theta1;
    let u3_of_place_4 = u3_of_place_3 * sin_theta3_from_theta1;
    // 7 + u3_of_place*u3_of_place_2 + u3_of_place_4
    let u3_of_place_5 = u3_of_place.mul_add(u3_of_place_2, S::int(7)) + u3_of_place_4;
    // 1 + u3_of_place_2
    let u3_of_place_6 = S::int(1) + u3_of_place_2;
    // 3 + u3_of_place_4 + u3_of_place_6*cos(theta3_from_theta1)
    let u3_of_place_7 = u3_of_place_6
        .mul_add(cos_theta3_from_theta1, S::int(3) + u3_of_place_4);
    let u3_of_place_8 = S::int(6) * cos_theta2_from_theta1;
    let u3_of_place_9 = S::int(2) * cos_theta3_from_theta1;
    let u3_of_place_10 = S::int(6) * sin_theta2_from_theta1;
    let u3_of_place_11 = u3_of_place_10 * sin_theta3_from_theta1;
    // 1/(13 + u3_of_place*u3_of_place_8 + u3_of_place_9 + u3_of_place_11)
    let u3_of_place_12 = S::int(1)
        / (u3_of_place.mul_add(u3_of_place_8, S::int(13)) + u3_of_place_9 + u3_of_place_11);
    // u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3 = u3_of_place_12
        * ((-u4_from_u3).mul_add(u3_of_place_5, H_n3_scaled_per_m_per_l_squared)
            - u5_from_u3 * u3_of_place_7);
    // 13 + u3_of_place_8
    let r1__of_place = S::int(13) + u3_of_place_8;
    // 3 + cos(theta2_from_theta1)
    let r1__of_place_2 = S::int(3) + cos_theta2_from_theta1;
    // u3 + u5_from_u3
    let u3_plus_u5_from_u3 = u3 + u5_from_u3;
    let r1__of_u5_from_u3 = S::int(2) * u3_plus_u5_from_u3;
    // u3 + u4_from_u3
    let u3_plus_u4_from_u3 = u3 + u4_from_u3;
    // u5_from_u3 + u3_plus_u4_from_u3
    let r1__of_motion = u5_from_u3 + u3_plus_u4_from_u3;
    let r1__of_motion_2 = u3_of_place_8 * r1__of_motion;
    // u4_from_u3 + r1__of_u5_from_u3 + r1__of_motion_2
    let r1__of_motion_3 = u4_from_u3 + r1__of_u5_from_u3 + r1__of_motion_2;
    let u5_from_u3_times_6 = S::int(6) * u5_from_u3;
    // u3*r1__of_place + 6*u4_from_u3*r1__of_place_2 + u3_of_place_9*r1__of_motion_3 + u5_from_u3_times_6
    let r1__of_motion_4 = (u4_from_u3 * r1__of_place_2)
        .mul_add(S::int(6), u3 * r1__of_place) + u3_of_place_9 * r1__of_motion_3
        + u5_from_u3_times_6;
    // 9*u4_from_u3 + 8*u3_plus_u5_from_u3 - u3_of_place_2*r1__of_motion_3
    let r1__of_motion_5 = u3_plus_u5_from_u3.mul_add(S::int(8), S::int(9) * u4_from_u3)
        - u3_of_place_2 * r1__of_motion_3;
    let r1__of_place_3 = S::int(2) * sin_theta3_from_theta1;
    // u3_of_place_3*r1__of_motion_4 + r1__of_motion_5*r1__of_place_3
    let r1__of_motion_6 = r1__of_motion_5
        .mul_add(r1__of_place_3, u3_of_place_3 * r1__of_motion_4);
    let r1__of_place_4 = S::int(2) * cos_theta2_from_theta1;
    // 5 + r1__of_place_4
    let r1__of_place_5 = S::int(5) + r1__of_place_4;
    let u3_times_3 = S::int(3) * u3;
    // 10 + u3_of_place_2
    let r1__of_place_6 = S::int(10) + u3_of_place_2;
    let u4_from_u3_doubled = S::int(2) * u4_from_u3;
    // u5_from_u3_times_6 + r1__of_place_5*u3_times_3 + r1__of_place_6*u4_from_u3_doubled
    let r1__of_motion_7 = r1__of_place_5.mul_add(u3_times_3, u5_from_u3_times_6)
        + r1__of_place_6 * u4_from_u3_doubled;
    let u3_times_13 = S::int(13) * u3;
    // 18*u4_from_u3 + u5_from_u3_times_6 + u3_of_place_2*r1__of_motion_7 + u3_times_13
    let r1__of_motion_8 = u4_from_u3.mul_add(S::int(18), u5_from_u3_times_6)
        + u3_of_place_2 * r1__of_motion_7 + u3_times_13;
    let u4_from_u3_times_3 = S::int(3) * u4_from_u3;
    // u3_plus_u5_from_u3 + u3_of_place_2*r1__of_motion + u4_from_u3_times_3
    let r1__of_motion_9 = u3_of_place_2.mul_add(r1__of_motion, u3_plus_u5_from_u3)
        + u4_from_u3_times_3;
    // r1__of_motion_6*cos(theta3_from_theta1) - r1__of_motion_8*sin(theta3_from_theta1) -
    //   u3_of_place_10*r1__of_motion_9
    let r1__of_motion_10 = (-r1__of_motion_8)
        .mul_add(sin_theta3_from_theta1, r1__of_motion_6 * cos_theta3_from_theta1)
        - u3_of_place_10 * r1__of_motion_9;
    let u5_from_u3_sq = u5_from_u3 * u5_from_u3;
    let u4_from_u3_sq = u4_from_u3 * u4_from_u3;
    // u5_from_u3_sq + u4_from_u3_sq
    let r1__of_motion_11 = u5_from_u3_sq + u4_from_u3_sq;
    // 2*u5_from_u3_sq + u4_from_u3_sq + u3_of_place_8*r1__of_motion_11
    let r1__of_motion_12 = u5_from_u3_sq.mul_add(S::int(2), u4_from_u3_sq)
        + u3_of_place_8 * r1__of_motion_11;
    let u4_from_u3_sq_times_9 = S::int(9) * u4_from_u3_sq;
    // 8*u5_from_u3_sq - u3_of_place_2*r1__of_motion_12 + u4_from_u3_sq_times_9
    let r1__of_motion_13 = (-u3_of_place_2)
        .mul_add(r1__of_motion_12, S::int(8) * u5_from_u3_sq) + u4_from_u3_sq_times_9;
    let u4_from_u3_sq_times_3 = S::int(3) * u4_from_u3_sq;
    let u5_from_u3_sq_times_3 = S::int(3) * u5_from_u3_sq;
    // r1__of_motion_12*cos(theta3_from_theta1) + r1__of_place_2*u4_from_u3_sq_times_3 +
    //   u5_from_u3_sq_times_3
    let r1__of_motion_14 = r1__of_place_2
        .mul_add(u4_from_u3_sq_times_3, r1__of_motion_12 * cos_theta3_from_theta1)
        + u5_from_u3_sq_times_3;
    // r1__of_motion_13*sin(theta3_from_theta1) + u3_of_place_3*r1__of_motion_14
    let r1__of_motion_15 = u3_of_place_3
        .mul_add(r1__of_motion_14, r1__of_motion_13 * sin_theta3_from_theta1);
    // u5_from_u3_sq + u4_from_u3_sq_times_3
    let r1__of_motion_16 = u5_from_u3_sq + u4_from_u3_sq_times_3;
    // u3_of_place_2*r1__of_motion_11 + r1__of_motion_16
    let r1__of_motion_17 = u3_of_place_2.mul_add(r1__of_motion_11, r1__of_motion_16);
    // r1__of_place_6*u4_from_u3_sq + u5_from_u3_sq_times_3
    let r1__of_motion_18 = r1__of_place_6.mul_add(u4_from_u3_sq, u5_from_u3_sq_times_3);
    // r1__of_motion_16 + r1__of_motion_18*cos(theta2_from_theta1)
    let r1__of_motion_19 = r1__of_motion_18
        .mul_add(cos_theta2_from_theta1, r1__of_motion_16);
    let r1__of_place_7 = S::int(3) * sin_theta3_from_theta1;
    let r1__of_place_8 = S::int(9) * cos_theta3_from_theta1;
    // 7 + r1__of_place_8
    let r1__of_place_9 = S::int(7) + r1__of_place_8;
    // r1__of_place_9 - u3_of_place_4
    let r1__of_place_10 = r1__of_place_9 - u3_of_place_4;
    // 1 + u3_of_place_9
    let r1__of_place_11 = S::int(1) + u3_of_place_9;
    let r1__of_place_12 = u3_of_place_2 * r1__of_place_11;
    // 2 + cos(theta3_from_theta1)
    let r1__of_place_13 = S::int(2) + cos_theta3_from_theta1;
    // u3_of_place_11 + r1__of_place_12
    let r1__of_place_14 = u3_of_place_11 + r1__of_place_12;
    // r1__of_place_13 + r1__of_place_14
    let r1__of_place_15 = r1__of_place_13 + r1__of_place_14;
    // 3 + u3_of_place_2 - u3_of_place_4 - r1__of_place_15*cos(theta3_from_theta1)
    let r1__of_place_16 = (-r1__of_place_15)
        .mul_add(cos_theta3_from_theta1, S::int(3) + u3_of_place_2 - u3_of_place_4);
    let r1__of_place_17 = S::int(9) * sin_theta2_from_theta1;
    // r1__of_place_17*sin(theta3_from_theta1) - 12 - r1__of_place_10*cos(theta3_from_theta1) -
    //   u3_of_place_2*r1__of_place_16
    let r1__of_place_18 = r1__of_place_17.mul_add(sin_theta3_from_theta1, -S::int(12))
        - r1__of_place_10 * cos_theta3_from_theta1 - u3_of_place_2 * r1__of_place_16;
    let r1__of_u4_from_u3 = S::int(2) * u3_plus_u4_from_u3;
    // u5_from_u3 + r1__of_u4_from_u3
    let r1__of_motion_20 = u5_from_u3 + r1__of_u4_from_u3;
    let u4_from_u3_times_14 = S::int(14) * u4_from_u3;
    // u3_times_13 + u4_from_u3_times_14
    let r1__of_u4_from_u3_2 = u3_times_13 + u4_from_u3_times_14;
    // 10*u5_from_u3 + u3_of_place_8*r1__of_motion_20 + r1__of_u4_from_u3_2
    let r1__of_motion_21 = u3_of_place_8
        .mul_add(r1__of_motion_20, S::int(10) * u5_from_u3) + r1__of_u4_from_u3_2;
    let r1__of_u4_from_u3_3 = S::int(18) * u3_plus_u4_from_u3;
    // 14*u5_from_u3 - u3_of_place_2*r1__of_motion_21 + r1__of_u4_from_u3_3
    let r1__of_motion_22 = (-u3_of_place_2)
        .mul_add(r1__of_motion_21, S::int(14) * u5_from_u3) + r1__of_u4_from_u3_3;
    // 1 - u3_of_place_2
    let r1__of_place_19 = S::int(1) - u3_of_place_2;
    // -r1__of_place_19
    let minus_r1__of_place_19 = -r1__of_place_19;
    let r1__of_u5_from_u3_2 = u5_from_u3 * minus_r1__of_place_19;
    // r1__of_u4_from_u3_2 - 2*r1__of_u5_from_u3_2
    let r1__of_motion_23 = (-r1__of_u5_from_u3_2)
        .mul_add(S::int(2), r1__of_u4_from_u3_2);
    // u3_of_place_9*r1__of_motion + r1__of_motion_20
    let r1__of_motion_24 = u3_of_place_9.mul_add(r1__of_motion, r1__of_motion_20);
    let u4_from_u3_times_7 = S::int(7) * u4_from_u3;
    // 6 + cos(theta3_from_theta1)
    let r1__of_place_20 = S::int(6) + cos_theta3_from_theta1;
    let r1__of_u5_from_u3_3 = u5_from_u3 * r1__of_place_20;
    // u4_from_u3_times_7 + r1__of_u5_from_u3_3
    let r1__of_motion_25 = u4_from_u3_times_7 + r1__of_u5_from_u3_3;
    // 15 + u3_of_place_9
    let r1__of_place_21 = S::int(15) + u3_of_place_9;
    let u3_r1__of_place_21 = u3 * r1__of_place_21;
    // 2*r1__of_motion_25 + u3_r1__of_place_21
    let r1__of_motion_26 = r1__of_motion_25.mul_add(S::int(2), u3_r1__of_place_21);
    // u3_of_place_8*r1__of_motion_24 + r1__of_motion_26
    let r1__of_motion_27 = u3_of_place_8.mul_add(r1__of_motion_24, r1__of_motion_26);
    // u3_plus_u5_from_u3 + r1__of_motion_2
    let r1__of_motion_28 = u3_plus_u5_from_u3 + r1__of_motion_2;
    let u5_from_u3_times_3 = S::int(3) * u5_from_u3;
    // 3*u3_plus_u4_from_u3 - r1__of_motion_28*cos(theta2_from_theta1) + u5_from_u3_times_3
    let r1__of_motion_29 = (-r1__of_motion_28)
        .mul_add(cos_theta2_from_theta1, S::int(3) * u3_plus_u4_from_u3) + u5_from_u3_times_3;
    // r1__of_motion_27*sin(theta2_from_theta1) + r1__of_place_3*r1__of_motion_29
    let r1__of_motion_30 = r1__of_place_3
        .mul_add(r1__of_motion_29, r1__of_motion_27 * sin_theta2_from_theta1);
    let r1__of_place_22 = S::int(3) * cos_theta3_from_theta1;
    // r1__of_motion_22*sin(theta3_from_theta1) + u3_of_place_3*r1__of_motion_23 +
    //   r1__of_motion_30*r1__of_place_22
    let r1__of_motion_31 = u3_of_place_3
        .mul_add(r1__of_motion_23, r1__of_motion_22 * sin_theta3_from_theta1)
        + r1__of_motion_30 * r1__of_place_22;
    // 7*u5_from_u3_sq + u4_from_u3_sq_times_9
    let r1__of_motion_32 = u5_from_u3_sq.mul_add(S::int(7), u4_from_u3_sq_times_9);
    // r1__of_motion_11*r1__of_place_8 + r1__of_motion_32
    let r1__of_motion_33 = r1__of_motion_11.mul_add(r1__of_place_8, r1__of_motion_32);
    // u5_from_u3_sq + 2*u4_from_u3_sq
    let r1__of_motion_34 = u4_from_u3_sq.mul_add(S::int(2), u5_from_u3_sq);
    let r1__of_motion_35 = u3_of_place_9 * r1__of_motion_11;
    // r1__of_motion_34 + r1__of_motion_35
    let r1__of_motion_36 = r1__of_motion_34 + r1__of_motion_35;
    // 5 + cos(theta3_from_theta1)
    let r1__of_place_23 = S::int(5) + cos_theta3_from_theta1;
    let u4_from_u3_sq_times_7 = S::int(7) * u4_from_u3_sq;
    // u3_of_place_2*r1__of_motion_36 + u5_from_u3_sq*r1__of_place_23 + u4_from_u3_sq_times_7
    let r1__of_motion_37 = u5_from_u3_sq
        .mul_add(r1__of_place_23, u3_of_place_2 * r1__of_motion_36) + u4_from_u3_sq_times_7;
    // u5_from_u3_sq - r1__of_motion_36*cos(theta3_from_theta1)
    let r1__of_motion_38 = (-r1__of_motion_36)
        .mul_add(cos_theta3_from_theta1, u5_from_u3_sq);
    // r1__of_motion_37*sin(theta3_from_theta1) + u3_of_place_3*r1__of_motion_38
    let r1__of_motion_39 = u3_of_place_3
        .mul_add(r1__of_motion_38, r1__of_motion_37 * sin_theta3_from_theta1);
    // u5_from_u3_sq*r1__of_place_20 + u4_from_u3_sq_times_7
    let r1__of_motion_40 = u5_from_u3_sq.mul_add(r1__of_place_20, u4_from_u3_sq_times_7);
    // u5_from_u3_sq + u4_from_u3_sq_times_7 + r1__of_motion_40*cos(theta3_from_theta1)
    let r1__of_motion_41 = r1__of_motion_40
        .mul_add(cos_theta3_from_theta1, u5_from_u3_sq + u4_from_u3_sq_times_7);
    // u3*r1__of_motion_31 + r1__of_motion_33*sin(theta3_from_theta1) - u3_of_place_2*r1__of_motion_39 +
    //   u3_of_place_3*r1__of_motion_41
    let r1__of_motion_42 = r1__of_motion_33
        .mul_add(sin_theta3_from_theta1, u3 * r1__of_motion_31)
        - u3_of_place_2 * r1__of_motion_39 + u3_of_place_3 * r1__of_motion_41;
    let r1__of_place_24 = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // u3_of_place*cos(theta2_from_theta1) + r1__of_place_24
    let r1__of_place_25 = u3_of_place.mul_add(cos_theta2_from_theta1, r1__of_place_24);
    // 14 + r1__of_place_8 - 18*r1__of_place_25*cos(theta2_from_theta1)
    let r1__of_place_26 = (-(r1__of_place_25 * cos_theta2_from_theta1))
        .mul_add(S::int(18), S::int(14) + r1__of_place_8);
    let r1__of_place_27 = cos_theta2_from_theta1 * sin_theta3_from_theta1;
    let r1__of_place_28 = S::int(18) * sin_theta2_from_theta1;
    // 33 + r1__of_place_26*cos(theta3_from_theta1) - r1__of_place_27*r1__of_place_28
    let r1__of_place_29 = r1__of_place_26.mul_add(cos_theta3_from_theta1, S::int(33))
        - r1__of_place_27 * r1__of_place_28;
    let r1__of_place_29_inv = S::int(1) / r1__of_place_29;
    let r1__of_motion_43 = r1__of_motion_42 * r1__of_place_29_inv;
    // u3*r1__of_motion_10 + r1__of_motion_15*cos(theta3_from_theta1) - u3_of_place_3*r1__of_motion_17 -
    //   r1__of_motion_19*r1__of_place_7
    let r1__of_motion_44 = r1__of_motion_15
        .mul_add(cos_theta3_from_theta1, u3 * r1__of_motion_10)
        - u3_of_place_3 * r1__of_motion_17 - r1__of_motion_19 * r1__of_place_7;
    let r1__of_place_30 = m_l_squared_by_12 * u3_of_place_12;
    // r1_ = m_l_squared_by_12*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(u3*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15 +
    //   2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6 + cos(theta3_from_theta1)) +
    //   6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(3*u3 + 3*u4_from_u3 + 3*u5_from_u3 -
    //   cos(theta2_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 +
    //   u5_from_u3)))) + sin(theta3_from_theta1)*(18*u3 + 18*u4_from_u3 + 14*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3))) + 3*sin(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
    //   3*cos(theta2_from_theta1)))) - 3*cos(theta2_from_theta1)*(sin(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(5 + cos(theta3_from_theta1)) + 3*cos(theta2_from_theta1)*(2*u4_from_u3^2 +
    //   u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) +
    //   3*sin(theta2_from_theta1)*(u5_from_u3^2 - cos(theta3_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 +
    //   2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) +
    //   3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2 + cos(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(6 + cos(theta3_from_theta1)))) + sin(theta3_from_theta1)*(9*u4_from_u3^2 +
    //   7*u5_from_u3^2 + 9*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/((13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))) +
    //   m_l_squared_by_12*(u3*(cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(u3*(13 +
    //   6*cos(theta2_from_theta1)) + 6*u4_from_u3*(3 + cos(theta2_from_theta1)) + 6*u5_from_u3 +
    //   2*cos(theta3_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(8*u3 + 9*u4_from_u3 + 8*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3)))) - sin(theta3_from_theta1)*(13*u3 + 18*u4_from_u3 + 6*u5_from_u3 +
    //   3*cos(theta2_from_theta1)*(3*u3*(5 + 2*cos(theta2_from_theta1)) + 2*u4_from_u3*(10 +
    //   3*cos(theta2_from_theta1)) + 6*u5_from_u3)) - 6*sin(theta2_from_theta1)*(u3 + 3*u4_from_u3 +
    //   u5_from_u3 + 3*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(3*u4_from_u3^2*(3 + cos(theta2_from_theta1)) +
    //   3*u5_from_u3^2 + cos(theta3_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) + sin(theta3_from_theta1)*(9*u4_from_u3^2
    //   + 8*u5_from_u3^2 - 3*cos(theta2_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) -
    //   3*sin(theta3_from_theta1)*(3*u4_from_u3^2 + u5_from_u3^2 + cos(theta2_from_theta1)*(u4_from_u3^2*(10
    //   + 3*cos(theta2_from_theta1)) + 3*u5_from_u3^2)) - 3*sin(theta2_from_theta1)*(3*u4_from_u3^2 +
    //   u5_from_u3^2 + 3*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let r1_ = r1__of_place_30 * r1__of_place_18.mul_add(r1__of_motion_43, r1__of_motion_44);
    let u5_from_u3_dot_of_place = cos_theta2_from_theta1 * cos_theta3_from_theta1;
    // r1__of_place_24 + u5_from_u3_dot_of_place
    let u5_from_u3_dot_of_place_2 = r1__of_place_24 + u5_from_u3_dot_of_place;
    let u5_from_u3_dot_of_place_3 = S::int(9) * cos_theta2_from_theta1;
    // 5*cos(theta3_from_theta1) - u5_from_u3_dot_of_place_2*u5_from_u3_dot_of_place_3
    let u5_from_u3_dot_of_place_4 = (-u5_from_u3_dot_of_place_2)
        .mul_add(u5_from_u3_dot_of_place_3, S::int(5) * cos_theta3_from_theta1);
    // 1/(9 + u5_from_u3_dot_of_place_4*cos(theta3_from_theta1))
    let u5_from_u3_dot_of_place_5 = S::int(1)
        / u5_from_u3_dot_of_place_4.mul_add(cos_theta3_from_theta1, S::int(9));
    let u5_from_u3_dot_of_place_6 = u5_from_u3_dot_of_place_5 / m_l_squared_by_12;
    let u5_from_u3_dot_of_place_7 = r1__of_place_29 * u5_from_u3_dot_of_place_6;
    let u5_from_u3_dot_of_place_8 = S::ratio(1, 4) * u5_from_u3_dot_of_place_7;
    // u5_from_u3' = r1_*(33 - 18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(4*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot = r1_ * u5_from_u3_dot_of_place_8;
    let u3_by_theta2_from_theta1_of_place = S::int(2) * H_n3_scaled_per_m_per_l_squared;
    let u5_from_u3_times_5 = S::int(5) * u5_from_u3;
    // u4_from_u3 - u3_by_theta2_from_theta1_of_place
    let u3_by_theta2_from_theta1_of_u4_from_u3 = u4_from_u3 - u3_by_theta2_from_theta1_of_place;
    let u5_from_u3_times_7 = S::int(7) * u5_from_u3;
    // u3_by_theta2_from_theta1_of_place + u5_from_u3_times_7
    let u3_by_theta2_from_theta1_of_u5_from_u3 = u3_by_theta2_from_theta1_of_place
        + u5_from_u3_times_7;
    let u3_of_place_12_sq = u3_of_place_12 * u3_of_place_12;
    // u3_by_theta2_from_theta1 = -3*(sin(theta2_from_theta1)*(u4_from_u3 + 6*u5_from_u3 -
    //   2*H_n3_scaled_per_m_per_l_squared - cos(theta3_from_theta1)*(u4_from_u3*(1 +
    //   2*cos(theta3_from_theta1)) + 5*u5_from_u3 + 2*H_n3_scaled_per_m_per_l_squared)) +
    //   sin(theta3_from_theta1)*(6*u5_from_u3 +
    //   cos(theta2_from_theta1)*(u4_from_u3*(2*cos(theta3_from_theta1) - 1) + 7*u5_from_u3 +
    //   2*H_n3_scaled_per_m_per_l_squared)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2
    let u3_by_theta2_from_theta1 = -S::int(3) * u3_of_place_12_sq
        * (sin_theta2_from_theta1
            * (u5_from_u3_times_6
                - cos_theta3_from_theta1
                    * (u4_from_u3
                        .mul_add(r1__of_place_11, u3_by_theta2_from_theta1_of_place)
                        + u5_from_u3_times_5) + u3_by_theta2_from_theta1_of_u4_from_u3)
            + sin_theta3_from_theta1
                * (u5_from_u3_times_6
                    + cos_theta2_from_theta1
                        * (u4_from_u3 * (u3_of_place_9 - S::int(1))
                            + u3_by_theta2_from_theta1_of_u5_from_u3)));
    // u3_of_place_3*r1__of_motion - u3_by_theta2_from_theta1*u3_of_place_6
    let r1__by_theta2_from_theta1_of_motion = (-u3_by_theta2_from_theta1)
        .mul_add(u3_of_place_6, u3_of_place_3 * r1__of_motion);
    let r1__by_theta2_from_theta1_of_place = S::int(4) * cos_theta3_from_theta1;
    let r1__by_theta2_from_theta1_of_place_2 = S::int(13) * u3_by_theta2_from_theta1;
    let r1__by_theta2_from_theta1_of_motion_2 = r1__of_motion_11 * sin_theta2_from_theta1;
    let r1__by_theta2_from_theta1_of_u4_from_u3 = u4_from_u3_sq * sin_theta2_from_theta1;
    let r1__by_theta2_from_theta1_of_place_3 = u3_by_theta2_from_theta1 * u3_of_place;
    let r1__by_theta2_from_theta1_of_place_4 = S::int(12) * cos_theta2_from_theta1;
    // 1 + u3_of_place_8
    let r1__by_theta2_from_theta1_of_place_5 = S::int(1) + u3_of_place_8;
    // u3_of_place_10*r1__of_motion - u3_by_theta2_from_theta1*r1__by_theta2_from_theta1_of_place_5
    let r1__by_theta2_from_theta1_of_motion_3 = (-u3_by_theta2_from_theta1)
        .mul_add(r1__by_theta2_from_theta1_of_place_5, u3_of_place_10 * r1__of_motion);
    // 13 + r1__by_theta2_from_theta1_of_place_4
    let r1__by_theta2_from_theta1_of_place_6 = S::int(13) + r1__by_theta2_from_theta1_of_place_4;
    // u3_by_theta2_from_theta1*r1__by_theta2_from_theta1_of_place_6 - u3_of_place_10*r1__of_motion_20
    let r1__by_theta2_from_theta1_of_motion_4 = (-u3_of_place_10)
        .mul_add(
            r1__of_motion_20,
            u3_by_theta2_from_theta1 * r1__by_theta2_from_theta1_of_place_6,
        );
    // u5_from_u3*u3_of_place_10 + r1__by_theta2_from_theta1_of_place_2
    let r1__by_theta2_from_theta1_of_u5_from_u3 = u5_from_u3
        .mul_add(u3_of_place_10, r1__by_theta2_from_theta1_of_place_2);
    let r1__by_theta2_from_theta1_of_place_7 = r1__of_place_29_inv * r1__of_place_30;
    let r1__by_theta2_from_theta1_of_place_8 = r1__of_place_18
        * r1__by_theta2_from_theta1_of_place_7;
    // sin(theta2_from_theta1) + cos(theta3_from_theta1)*(r1__of_place_3*cos(theta2_from_theta1) -
    //   r1__of_place_11*sin(theta2_from_theta1)) + r1__of_place_27
    let r1__by_theta2_from_theta1_of_place_9 = sin_theta2_from_theta1
        + cos_theta3_from_theta1
            * (-r1__of_place_11)
                .mul_add(sin_theta2_from_theta1, r1__of_place_3 * cos_theta2_from_theta1)
        + r1__of_place_27;
    let r1__by_theta2_from_theta1_of_motion_5 = r1__of_motion_42
        * r1__by_theta2_from_theta1_of_place_7;
    // r1__of_place_27 - u3_of_place*sin(theta2_from_theta1)
    let r1__by_theta2_from_theta1_of_place_10 = (-u3_of_place)
        .mul_add(sin_theta2_from_theta1, r1__of_place_27);
    // r1__of_place_24*sin(theta2_from_theta1) - r1__of_place_27*cos(theta2_from_theta1) +
    //   cos(theta3_from_theta1)*(r1__of_place_25*sin(theta2_from_theta1) -
    //   r1__by_theta2_from_theta1_of_place_10*cos(theta2_from_theta1))
    let r1__by_theta2_from_theta1_of_place_11 = r1__of_place_24 * sin_theta2_from_theta1
        - r1__of_place_27 * cos_theta2_from_theta1
        + cos_theta3_from_theta1
            * (-r1__by_theta2_from_theta1_of_place_10)
                .mul_add(
                    cos_theta2_from_theta1,
                    r1__of_place_25 * sin_theta2_from_theta1,
                );
    let r1__by_theta2_from_theta1_of_place_12 = S::int(18) * r1__by_theta2_from_theta1_of_place_11;
    let r1__by_theta2_from_theta1_of_motion_6 = r1__of_motion_43
        * r1__by_theta2_from_theta1_of_place_8;
    let r1__u3_of_place_12 = r1_ * u3_of_place_12;
    // r1__by_theta2_from_theta1 = 6*m_l_squared_by_12*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   12 + 3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(u3*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15 +
    //   2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6 + cos(theta3_from_theta1)) +
    //   6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(3*u3 + 3*u4_from_u3 + 3*u5_from_u3 -
    //   cos(theta2_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 +
    //   u5_from_u3)))) + sin(theta3_from_theta1)*(18*u3 + 18*u4_from_u3 + 14*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3))) + 3*sin(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
    //   3*cos(theta2_from_theta1)))) - 3*cos(theta2_from_theta1)*(sin(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(5 + cos(theta3_from_theta1)) + 3*cos(theta2_from_theta1)*(2*u4_from_u3^2 +
    //   u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) +
    //   3*sin(theta2_from_theta1)*(u5_from_u3^2 - cos(theta3_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 +
    //   2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) +
    //   3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2 + cos(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(6 + cos(theta3_from_theta1)))) + sin(theta3_from_theta1)*(9*u4_from_u3^2 +
    //   7*u5_from_u3^2 + 9*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/((13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))^2*(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1)
    //   - 33 - cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))) + 18*m_l_squared_by_12*(12 -
    //   9*sin(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) -
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(sin(theta2_from_theta1)^2*sin(theta3_from_theta1) -
    //   cos(theta2_from_theta1)^2*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   cos(theta2_from_theta1)*(sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))))*(u3*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15
    //   + 2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6 + cos(theta3_from_theta1)) +
    //   6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(3*u3 + 3*u4_from_u3 + 3*u5_from_u3 -
    //   cos(theta2_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 +
    //   u5_from_u3)))) + sin(theta3_from_theta1)*(18*u3 + 18*u4_from_u3 + 14*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3))) + 3*sin(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
    //   3*cos(theta2_from_theta1)))) - 3*cos(theta2_from_theta1)*(sin(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(5 + cos(theta3_from_theta1)) + 3*cos(theta2_from_theta1)*(2*u4_from_u3^2 +
    //   u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) +
    //   3*sin(theta2_from_theta1)*(u5_from_u3^2 - cos(theta3_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 +
    //   2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) +
    //   3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2 + cos(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(6 + cos(theta3_from_theta1)))) + sin(theta3_from_theta1)*(9*u4_from_u3^2 +
    //   7*u5_from_u3^2 + 9*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/((13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))^2) +
    //   3*m_l_squared_by_12*(3*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1)*cos(theta3_from_theta1) + sin(theta2_from_theta1)*(3
    //   + 3*cos(theta2_from_theta1) - 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   cos(theta3_from_theta1)*(2 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   3*cos(theta2_from_theta1)*(sin(theta2_from_theta1) + cos(theta2_from_theta1)*sin(theta3_from_theta1)
    //   + cos(theta3_from_theta1)*(2*cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*(1 +
    //   2*cos(theta3_from_theta1)))))*(u3*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15 +
    //   2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6 + cos(theta3_from_theta1)) +
    //   6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(3*u3 + 3*u4_from_u3 + 3*u5_from_u3 -
    //   cos(theta2_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 +
    //   u5_from_u3)))) + sin(theta3_from_theta1)*(18*u3 + 18*u4_from_u3 + 14*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3))) + 3*sin(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
    //   3*cos(theta2_from_theta1)))) - 3*cos(theta2_from_theta1)*(sin(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(5 + cos(theta3_from_theta1)) + 3*cos(theta2_from_theta1)*(2*u4_from_u3^2 +
    //   u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) +
    //   3*sin(theta2_from_theta1)*(u5_from_u3^2 - cos(theta3_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 +
    //   2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) +
    //   3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2 + cos(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(6 + cos(theta3_from_theta1)))) + sin(theta3_from_theta1)*(9*u4_from_u3^2 +
    //   7*u5_from_u3^2 + 9*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/((13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))) +
    //   6*m_l_squared_by_12*(sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))*(u3*(cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(u3*(13
    //   + 6*cos(theta2_from_theta1)) + 6*u4_from_u3*(3 + cos(theta2_from_theta1)) + 6*u5_from_u3 +
    //   2*cos(theta3_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(8*u3 + 9*u4_from_u3 + 8*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3)))) - sin(theta3_from_theta1)*(13*u3 + 18*u4_from_u3 + 6*u5_from_u3 +
    //   3*cos(theta2_from_theta1)*(3*u3*(5 + 2*cos(theta2_from_theta1)) + 2*u4_from_u3*(10 +
    //   3*cos(theta2_from_theta1)) + 6*u5_from_u3)) - 6*sin(theta2_from_theta1)*(u3 + 3*u4_from_u3 +
    //   u5_from_u3 + 3*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(3*u4_from_u3^2*(3 + cos(theta2_from_theta1)) +
    //   3*u5_from_u3^2 + cos(theta3_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) + sin(theta3_from_theta1)*(9*u4_from_u3^2
    //   + 8*u5_from_u3^2 - 3*cos(theta2_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) -
    //   3*sin(theta3_from_theta1)*(3*u4_from_u3^2 + u5_from_u3^2 + cos(theta2_from_theta1)*(u4_from_u3^2*(10
    //   + 3*cos(theta2_from_theta1)) + 3*u5_from_u3^2)) - 3*sin(theta2_from_theta1)*(3*u4_from_u3^2 +
    //   u5_from_u3^2 + 3*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2 +
    //   m_l_squared_by_12*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(3*sin(theta2_from_theta1)*(sin(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(5 + cos(theta3_from_theta1)) + 3*cos(theta2_from_theta1)*(2*u4_from_u3^2 +
    //   u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) +
    //   3*sin(theta2_from_theta1)*(u5_from_u3^2 - cos(theta3_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 +
    //   2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) +
    //   3*cos(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2 + cos(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(6 + cos(theta3_from_theta1)))) +
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1)*(2*u4_from_u3^2 +
    //   u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)) +
    //   cos(theta2_from_theta1)*(cos(theta3_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 +
    //   2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)) - u5_from_u3^2)) +
    //   u3_by_theta2_from_theta1*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15 +
    //   2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6 + cos(theta3_from_theta1)) +
    //   6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(3*u3 + 3*u4_from_u3 + 3*u5_from_u3 -
    //   cos(theta2_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 +
    //   u5_from_u3)))) + sin(theta3_from_theta1)*(18*u3 + 18*u4_from_u3 + 14*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3))) + 3*sin(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
    //   3*cos(theta2_from_theta1)))) + 3*u3*(cos(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 +
    //   2*u5_from_u3*(1 - 3*cos(theta2_from_theta1))) +
    //   cos(theta3_from_theta1)*(cos(theta2_from_theta1)*(u3*(15 + 2*cos(theta3_from_theta1)) +
    //   14*u4_from_u3 + 2*u5_from_u3*(6 + cos(theta3_from_theta1)) + 6*cos(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   sin(theta2_from_theta1)*(u3_by_theta2_from_theta1*(15 + 2*cos(theta3_from_theta1)) -
    //   6*sin(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3)) + 12*cos(theta2_from_theta1)*(u3_by_theta2_from_theta1 +
    //   u3_by_theta2_from_theta1*cos(theta3_from_theta1))) +
    //   2*sin(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3
    //   + u4_from_u3 + u5_from_u3)) + 3*u3_by_theta2_from_theta1 +
    //   cos(theta2_from_theta1)*(6*sin(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3) -
    //   u3_by_theta2_from_theta1 - 6*u3_by_theta2_from_theta1*cos(theta2_from_theta1)))) +
    //   sin(theta3_from_theta1)*(sin(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 +
    //   6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3)) + 6*u3_by_theta2_from_theta1 +
    //   cos(theta2_from_theta1)*(6*sin(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3) -
    //   13*u3_by_theta2_from_theta1 - 12*u3_by_theta2_from_theta1*cos(theta2_from_theta1))) +
    //   sin(theta2_from_theta1)*(6*u5_from_u3*sin(theta2_from_theta1) + 13*u3_by_theta2_from_theta1)))/((13
    //   + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))) +
    //   m_l_squared_by_12*(9*sin(theta2_from_theta1)^2*(u4_from_u3^2 + u5_from_u3^2) -
    //   3*cos(theta2_from_theta1)*(3*u4_from_u3^2 + u5_from_u3^2 + 3*cos(theta2_from_theta1)*(u4_from_u3^2 +
    //   u5_from_u3^2)) + 3*cos(theta3_from_theta1)*(cos(theta2_from_theta1)*(3*u4_from_u3^2*(3 +
    //   cos(theta2_from_theta1)) + 3*u5_from_u3^2 + cos(theta3_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) -
    //   3*sin(theta2_from_theta1)*(u4_from_u3^2*sin(theta2_from_theta1) +
    //   2*sin(theta2_from_theta1)*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)) +
    //   sin(theta3_from_theta1)*(6*sin(theta2_from_theta1)*cos(theta2_from_theta1)*(u4_from_u3^2 +
    //   u5_from_u3^2) + sin(theta2_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) +
    //   3*sin(theta3_from_theta1)*(3*u4_from_u3^2*sin(theta2_from_theta1)*cos(theta2_from_theta1) +
    //   sin(theta2_from_theta1)*(u4_from_u3^2*(10 + 3*cos(theta2_from_theta1)) + 3*u5_from_u3^2)) +
    //   u3_by_theta2_from_theta1*(cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(u3*(13 +
    //   6*cos(theta2_from_theta1)) + 6*u4_from_u3*(3 + cos(theta2_from_theta1)) + 6*u5_from_u3 +
    //   2*cos(theta3_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(8*u3 + 9*u4_from_u3 + 8*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3)))) - sin(theta3_from_theta1)*(13*u3 + 18*u4_from_u3 + 6*u5_from_u3 +
    //   3*cos(theta2_from_theta1)*(3*u3*(5 + 2*cos(theta2_from_theta1)) + 2*u4_from_u3*(10 +
    //   3*cos(theta2_from_theta1)) + 6*u5_from_u3)) - 6*sin(theta2_from_theta1)*(u3 + 3*u4_from_u3 +
    //   u5_from_u3 + 3*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   u3*(6*sin(theta2_from_theta1)*(3*sin(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3) -
    //   u3_by_theta2_from_theta1 - 3*u3_by_theta2_from_theta1*cos(theta2_from_theta1)) -
    //   6*cos(theta2_from_theta1)*(u3 + 3*u4_from_u3 + u5_from_u3 + 3*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3)) + cos(theta3_from_theta1)*(3*cos(theta2_from_theta1)*(u3*(13 +
    //   6*cos(theta2_from_theta1)) + 6*u4_from_u3*(3 + cos(theta2_from_theta1)) + 6*u5_from_u3 +
    //   2*cos(theta3_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 3*sin(theta2_from_theta1)*(u3_by_theta2_from_theta1*(13 +
    //   6*cos(theta2_from_theta1)) - 6*u3*sin(theta2_from_theta1) - 6*u4_from_u3*sin(theta2_from_theta1) -
    //   4*cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3) -
    //   u3_by_theta2_from_theta1 - 3*u3_by_theta2_from_theta1*cos(theta2_from_theta1))) +
    //   2*sin(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 +
    //   6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3)) + 8*u3_by_theta2_from_theta1 +
    //   6*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3) -
    //   u3_by_theta2_from_theta1 - 3*u3_by_theta2_from_theta1*cos(theta2_from_theta1)))) +
    //   sin(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(3*u3*(5 + 2*cos(theta2_from_theta1)) +
    //   2*u4_from_u3*(10 + 3*cos(theta2_from_theta1)) + 6*u5_from_u3) - 13*u3_by_theta2_from_theta1 -
    //   9*cos(theta2_from_theta1)*(u3_by_theta2_from_theta1*(5 + 2*cos(theta2_from_theta1)) -
    //   2*u3*sin(theta2_from_theta1) - 2*u4_from_u3*sin(theta2_from_theta1)))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let r1__by_theta2_from_theta1 = r1__of_place_30
        * (u3_by_theta2_from_theta1 * r1__of_motion_10 - u3_of_place_2 * r1__of_motion_17
            + u3
                * (u3_of_place_10 * r1__by_theta2_from_theta1_of_motion
                    - u3_of_place_8 * r1__of_motion_9
                    + cos_theta3_from_theta1
                        * (r1__of_place_3
                            * (u3_of_place_3
                                .mul_add(
                                    r1__of_motion_3,
                                    S::int(8) * u3_by_theta2_from_theta1,
                                ) + u3_of_place_8 * r1__by_theta2_from_theta1_of_motion)
                            + u3_of_place_2 * r1__of_motion_4
                            + u3_of_place_3
                                * ((-u3_of_place_10)
                                    .mul_add(
                                        u3_plus_u4_from_u3,
                                        u3_by_theta2_from_theta1 * r1__of_place,
                                    )
                                    - r1__by_theta2_from_theta1_of_motion
                                        * r1__by_theta2_from_theta1_of_place))
                    + sin_theta3_from_theta1
                        * (-u5_from_u3_dot_of_place_3
                            * (-r1__of_u4_from_u3)
                                .mul_add(
                                    sin_theta2_from_theta1,
                                    u3_by_theta2_from_theta1 * r1__of_place_5,
                                ) + u3_of_place_3 * r1__of_motion_7
                            - r1__by_theta2_from_theta1_of_place_2))
            + r1__of_place_17 * r1__by_theta2_from_theta1_of_motion_2
            + r1__of_place_22
                * (sin_theta3_from_theta1
                    * u3_of_place_8
                        .mul_add(
                            r1__by_theta2_from_theta1_of_motion_2,
                            r1__of_motion_12 * sin_theta2_from_theta1,
                        ) + r1__of_motion_14 * cos_theta2_from_theta1
                    - u3_of_place_3
                        * r1__of_motion_35
                            .mul_add(
                                sin_theta2_from_theta1, r1__by_theta2_from_theta1_of_u4_from_u3,
                            ))
            + r1__of_place_7
                * u3_of_place_2
                    .mul_add(
                        r1__by_theta2_from_theta1_of_u4_from_u3,
                        r1__of_motion_18 * sin_theta2_from_theta1,
                    ))
        + r1__by_theta2_from_theta1_of_place_8
            * (u3_by_theta2_from_theta1 * r1__of_motion_31
                + u3_of_place_3 * r1__of_motion_39 + u3_of_place_2 * r1__of_motion_41
                + u5_from_u3_dot_of_place_3
                    * (-r1__of_motion_38)
                        .mul_add(
                            cos_theta2_from_theta1,
                            r1__of_motion_36 * r1__of_place_24,
                        )
                + u3_times_3
                    * (cos_theta3_from_theta1
                        * (sin_theta2_from_theta1
                            * ((-u3_of_place_10)
                                .mul_add(
                                    r1__of_motion_24,
                                    u3_by_theta2_from_theta1 * r1__of_place_21,
                                )
                                + r1__by_theta2_from_theta1_of_place_3
                                    * r1__by_theta2_from_theta1_of_place_4)
                            + r1__of_motion_27 * cos_theta2_from_theta1
                            + r1__of_place_3
                                * (r1__of_motion_28
                                    .mul_add(
                                        sin_theta2_from_theta1,
                                        S::int(3) * u3_by_theta2_from_theta1,
                                    )
                                    + r1__by_theta2_from_theta1_of_motion_3
                                        * cos_theta2_from_theta1))
                        + r1__of_motion_23 * cos_theta2_from_theta1
                        + sin_theta3_from_theta1
                            * (r1__of_motion_21
                                .mul_add(
                                    sin_theta2_from_theta1,
                                    S::int(6) * u3_by_theta2_from_theta1,
                                )
                                - r1__by_theta2_from_theta1_of_motion_4 * cos_theta2_from_theta1)
                        + r1__by_theta2_from_theta1_of_u5_from_u3 * sin_theta2_from_theta1))
        + S::int(3) * r1__by_theta2_from_theta1_of_motion_5
            * (r1__of_place_16 * sin_theta2_from_theta1 + r1__of_place_27 * cos_theta3_from_theta1
                + u3_of_place_2 * (sin_theta3_from_theta1 + r1__by_theta2_from_theta1_of_place_9))
        - r1__by_theta2_from_theta1_of_place_12 * r1__by_theta2_from_theta1_of_motion_6
        - S::int(6) * r1__by_theta2_from_theta1_of_place_10 * r1__u3_of_place_12;
    let u5_from_u3_dot_by_theta2_from_theta1_of_place = sin_theta2_from_theta1
        * cos_theta3_from_theta1;
    // r1__of_place_27 - u5_from_u3_dot_by_theta2_from_theta1_of_place
    let u5_from_u3_dot_by_theta2_from_theta1_of_place_2 = r1__of_place_27
        - u5_from_u3_dot_by_theta2_from_theta1_of_place;
    let u5_from_u3_dot_by_theta2_from_theta1_of_place_3 = r1_ * u5_from_u3_dot_of_place_5;
    let u5_from_u3_dot_by_theta2_from_theta1_of_place_4 = r1_ * u5_from_u3_dot_of_place_6;
    // u5_from_u3_dot_by_theta2_from_theta1 =
    //   9*r1_*cos(theta3_from_theta1)*(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1)
    //   - 33 - cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))))*(cos(theta2_from_theta1)*(sin(theta2_from_theta1)*cos(theta3_from_theta1)
    //   - cos(theta2_from_theta1)*sin(theta3_from_theta1)) +
    //   sin(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))/(4*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1))))^2) +
    //   9*r1_*(sin(theta2_from_theta1)^2*sin(theta3_from_theta1) -
    //   cos(theta2_from_theta1)^2*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   cos(theta2_from_theta1)*(sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))))/(2*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1))))) + r1__by_theta2_from_theta1*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(4*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot_by_theta2_from_theta1 = S::ratio(9, 4) * u5_from_u3_dot_of_place_7
        * u5_from_u3_dot_by_theta2_from_theta1_of_place_3 * cos_theta3_from_theta1
        * (-u5_from_u3_dot_of_place_2)
            .mul_add(
                sin_theta2_from_theta1,
                u5_from_u3_dot_by_theta2_from_theta1_of_place_2 * cos_theta2_from_theta1,
            ) + r1__by_theta2_from_theta1 * u5_from_u3_dot_of_place_8
        + S::ratio(9, 2) * r1__by_theta2_from_theta1_of_place_11
            * u5_from_u3_dot_by_theta2_from_theta1_of_place_4;
    // u3 + r1__of_motion
    let u3_plus_r1__of_motion = u3 + r1__of_motion;
    let u4_from_u3_dot_by_theta2_from_theta1_of_place = S::int(18) * sin_theta3_from_theta1;
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion = u5_from_u3_dot * sin_theta3_from_theta1;
    // u3*r1__of_motion_26 + r1__of_motion_40 + u4_from_u3_dot_by_theta2_from_theta1_of_motion
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_2 = u3
        .mul_add(r1__of_motion_26, r1__of_motion_40)
        + u4_from_u3_dot_by_theta2_from_theta1_of_motion;
    // u5_from_u3'*r1__of_place_3 + r1__of_motion_35
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_3 = u5_from_u3_dot
        .mul_add(r1__of_place_3, r1__of_motion_35);
    // r1__of_motion_34 + u4_from_u3_dot_by_theta2_from_theta1_of_motion_3
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_4 = r1__of_motion_34
        + u4_from_u3_dot_by_theta2_from_theta1_of_motion_3;
    // r1__of_place_3*r1__of_motion_11 - u5_from_u3'*r1__of_place_11
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_5 = (-u5_from_u3_dot)
        .mul_add(r1__of_place_11, r1__of_place_3 * r1__of_motion_11);
    let u3_doubled = S::int(2) * u3;
    // u3_of_place_3*r1__of_motion_24 - r1__of_motion_28*sin(theta3_from_theta1)
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_6 = (-r1__of_motion_28)
        .mul_add(sin_theta3_from_theta1, u3_of_place_3 * r1__of_motion_24);
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_7 = S::int(2)
        * u4_from_u3_dot_by_theta2_from_theta1_of_motion_6;
    // u5_from_u3_dot_by_theta2_from_theta1*r1__of_place_15 +
    //   u3_of_place_2*u4_from_u3_dot_by_theta2_from_theta1_of_motion_4 +
    //   u3_of_place_3*u4_from_u3_dot_by_theta2_from_theta1_of_motion_5 +
    //   u3_doubled*(u3_of_place_2*r1__of_motion_24 + u3_of_place_10*r1__by_theta2_from_theta1_of_place_3 +
    //   r1__by_theta2_from_theta1_of_motion_3*sin(theta3_from_theta1)) +
    //   u3_by_theta2_from_theta1*u4_from_u3_dot_by_theta2_from_theta1_of_motion_7
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_8 = u5_from_u3_dot_by_theta2_from_theta1
        * r1__of_place_15 + u3_of_place_2 * u4_from_u3_dot_by_theta2_from_theta1_of_motion_4
        + u3_of_place_3 * u4_from_u3_dot_by_theta2_from_theta1_of_motion_5
        + u3_doubled
            * (u3_of_place_10
                .mul_add(
                    r1__by_theta2_from_theta1_of_place_3,
                    u3_of_place_2 * r1__of_motion_24,
                ) + r1__by_theta2_from_theta1_of_motion_3 * sin_theta3_from_theta1)
        + u3_by_theta2_from_theta1 * u4_from_u3_dot_by_theta2_from_theta1_of_motion_7;
    let u4_from_u3_dot_by_theta2_from_theta1_of_u5_from_u3 = u5_from_u3_sq * sin_theta3_from_theta1;
    // u3_of_place_2*u4_from_u3_dot_by_theta2_from_theta1_of_motion_5 - u5_from_u3'*r1__of_place_13 -
    //   u3_of_place_3*u4_from_u3_dot_by_theta2_from_theta1_of_motion_4 -
    //   u3_doubled*u4_from_u3_dot_by_theta2_from_theta1_of_motion_6 +
    //   u4_from_u3_dot_by_theta2_from_theta1_of_u5_from_u3
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_9 = (-u5_from_u3_dot)
        .mul_add(
            r1__of_place_13,
            u3_of_place_2 * u4_from_u3_dot_by_theta2_from_theta1_of_motion_5,
        ) - u3_of_place_3 * u4_from_u3_dot_by_theta2_from_theta1_of_motion_4
        - u3_doubled * u4_from_u3_dot_by_theta2_from_theta1_of_motion_6
        + u4_from_u3_dot_by_theta2_from_theta1_of_u5_from_u3;
    // u5_from_u3_dot_by_theta2_from_theta1*sin(theta3_from_theta1) +
    //   u3_by_theta2_from_theta1*(u3_r1__of_place_21 + r1__of_motion_26)
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_10 = u3_by_theta2_from_theta1
        * (u3_r1__of_place_21 + r1__of_motion_26)
        + u5_from_u3_dot_by_theta2_from_theta1 * sin_theta3_from_theta1;
    // 5*u5_from_u3_sq - u5_from_u3'*u3_of_place_3 + u3*r1__of_motion_21 + u3_of_place_2*r1__of_motion_34 +
    //   u4_from_u3_sq_times_7
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_11 = (-u5_from_u3_dot)
        .mul_add(u3_of_place_3, S::int(5) * u5_from_u3_sq) + u3 * r1__of_motion_21
        + u3_of_place_2 * r1__of_motion_34 + u4_from_u3_sq_times_7;
    // 9*u3_plus_u4_from_u3 + u5_from_u3_times_7
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_12 = u3_plus_u4_from_u3
        .mul_add(S::int(9), u5_from_u3_times_7);
    // 9*u3 + u4_from_u3_dot_by_theta2_from_theta1_of_motion_12
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_13 = u3
        .mul_add(S::int(9), u4_from_u3_dot_by_theta2_from_theta1_of_motion_12);
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_14 = S::int(2)
        * u4_from_u3_dot_by_theta2_from_theta1_of_motion_13;
    // 1 + cos(theta2_from_theta1)
    let u4_from_u3_dot_by_theta2_from_theta1_of_place_2 = S::int(1) + cos_theta2_from_theta1;
    // u3*r1__of_motion_23 - u5_from_u3_sq*minus_r1__of_place_19 + u4_from_u3_sq_times_7
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_15 = (-u5_from_u3_sq)
        .mul_add(minus_r1__of_place_19, u3 * r1__of_motion_23) + u4_from_u3_sq_times_7;
    // 4 + u3_of_place_2*u4_from_u3_dot_by_theta2_from_theta1_of_place_2
    let u4_from_u3_dot_by_theta2_from_theta1_of_place_3 = u3_of_place_2
        .mul_add(u4_from_u3_dot_by_theta2_from_theta1_of_place_2, S::int(4));
    let u4_from_u3_dot_by_theta2_from_theta1_of_place_4 = S::int(3)
        * u4_from_u3_dot_by_theta2_from_theta1_of_place_3;
    // r1__of_motion_11 + r1__of_motion*u3_doubled
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_16 = r1__of_motion
        .mul_add(u3_doubled, r1__of_motion_11);
    let u4_from_u3_dot_by_theta2_from_theta1_of_place_5 = S::int(9) * sin_theta3_from_theta1;
    // u3_of_place_3*u4_from_u3_dot_by_theta2_from_theta1_of_motion_2 - u5_from_u3'*r1__of_place_9 -
    //   u3_of_place_2*u4_from_u3_dot_by_theta2_from_theta1_of_motion_9 +
    //   u4_from_u3_dot_by_theta2_from_theta1_of_motion_16*u4_from_u3_dot_by_theta2_from_theta1_of_place_5
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_17 = (-u5_from_u3_dot)
        .mul_add(
            r1__of_place_9,
            u3_of_place_3 * u4_from_u3_dot_by_theta2_from_theta1_of_motion_2,
        ) - u3_of_place_2 * u4_from_u3_dot_by_theta2_from_theta1_of_motion_9
        + u4_from_u3_dot_by_theta2_from_theta1_of_motion_16
            * u4_from_u3_dot_by_theta2_from_theta1_of_place_5;
    // u5_from_u3'*r1__of_place_17 + r1__of_motion_32 -
    //   u3_of_place_2*u4_from_u3_dot_by_theta2_from_theta1_of_motion_11 +
    //   u3_doubled*u4_from_u3_dot_by_theta2_from_theta1_of_motion_12
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_18 = u5_from_u3_dot
        .mul_add(r1__of_place_17, r1__of_motion_32)
        - u3_of_place_2 * u4_from_u3_dot_by_theta2_from_theta1_of_motion_11
        + u3_doubled * u4_from_u3_dot_by_theta2_from_theta1_of_motion_12;
    // r1__of_place_29_inv^2*(u3_of_place_3*u4_from_u3_dot_by_theta2_from_theta1_of_motion_15 -
    //   u5_from_u3'*u4_from_u3_dot_by_theta2_from_theta1_of_place_4 +
    //   u4_from_u3_dot_by_theta2_from_theta1_of_motion_17*cos(theta3_from_theta1) +
    //   u4_from_u3_dot_by_theta2_from_theta1_of_motion_18*sin(theta3_from_theta1))
    let u4_from_u3_dot_by_theta2_from_theta1_of_motion_19 = r1__of_place_29_inv
        * r1__of_place_29_inv
        * ((-u5_from_u3_dot)
            .mul_add(
                u4_from_u3_dot_by_theta2_from_theta1_of_place_4,
                u3_of_place_3 * u4_from_u3_dot_by_theta2_from_theta1_of_motion_15,
            ) + u4_from_u3_dot_by_theta2_from_theta1_of_motion_17 * cos_theta3_from_theta1
            + u4_from_u3_dot_by_theta2_from_theta1_of_motion_18 * sin_theta3_from_theta1);
    // u4_from_u3_dot_by_theta2_from_theta1 = 18*(sin(theta2_from_theta1)^2*sin(theta3_from_theta1) -
    //   cos(theta2_from_theta1)^2*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   cos(theta2_from_theta1)*(sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))))*(3*sin(theta2_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(1 - 3*cos(theta2_from_theta1)) + u3*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
    //   3*cos(theta2_from_theta1)))) - 3*u5_from_u3'*(4 + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta2_from_theta1))) + cos(theta3_from_theta1)*(9*sin(theta3_from_theta1)*(u4_from_u3^2 +
    //   u5_from_u3^2 + 2*u3*(u3 + u4_from_u3 + u5_from_u3)) - u5_from_u3'*(7 + 9*cos(theta3_from_theta1)) +
    //   3*cos(theta2_from_theta1)*(u5_from_u3'*(2 + cos(theta3_from_theta1)) -
    //   u5_from_u3^2*sin(theta3_from_theta1) - 2*u3*(sin(theta3_from_theta1)*(u3 + u5_from_u3 +
    //   6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3)) - 3*sin(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   3*sin(theta2_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 +
    //   u5_from_u3^2) + 2*u5_from_u3'*sin(theta3_from_theta1)) -
    //   3*cos(theta2_from_theta1)*(2*sin(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2) - u5_from_u3'*(1
    //   + 2*cos(theta3_from_theta1)))) + 3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2*(6 +
    //   cos(theta3_from_theta1)) + u3*(u3*(15 + 2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6
    //   + cos(theta3_from_theta1))) + u5_from_u3'*sin(theta3_from_theta1))) +
    //   sin(theta3_from_theta1)*(9*u4_from_u3^2 + 7*u5_from_u3^2 + 2*u3*(9*u3 + 9*u4_from_u3 + 7*u5_from_u3)
    //   + 9*u5_from_u3'*sin(theta2_from_theta1) +
    //   3*cos(theta2_from_theta1)*(3*u5_from_u3'*sin(theta2_from_theta1) - 7*u4_from_u3^2 - 5*u5_from_u3^2 -
    //   u3*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 +
    //   u5_from_u3)) - 3*cos(theta2_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2))))/(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))^2 +
    //   (3*cos(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2*(1 - 3*cos(theta2_from_theta1)) +
    //   u3*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 - 3*cos(theta2_from_theta1)))) +
    //   9*u5_from_u3'*(sin(theta2_from_theta1)*cos(theta2_from_theta1) + sin(theta2_from_theta1)*(1 +
    //   cos(theta2_from_theta1))) + 3*sin(theta2_from_theta1)*(3*u5_from_u3^2*sin(theta2_from_theta1) +
    //   u3_by_theta2_from_theta1*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 - 3*cos(theta2_from_theta1))) +
    //   u3*(6*u5_from_u3*sin(theta2_from_theta1) + 13*u3_by_theta2_from_theta1)) -
    //   3*u5_from_u3_dot_by_theta2_from_theta1*(4 + 3*cos(theta2_from_theta1)*(1 + cos(theta2_from_theta1)))
    //   + cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(u5_from_u3^2*sin(theta3_from_theta1) +
    //   2*u3*(sin(theta3_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 +
    //   u5_from_u3)) - 3*sin(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 +
    //   2*cos(theta3_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) - u5_from_u3'*(2 +
    //   cos(theta3_from_theta1)) - 3*sin(theta2_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 +
    //   2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2) + 2*u5_from_u3'*sin(theta3_from_theta1)) +
    //   3*cos(theta2_from_theta1)*(2*sin(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2) - u5_from_u3'*(1
    //   + 2*cos(theta3_from_theta1)))) + 3*cos(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2*(6 +
    //   cos(theta3_from_theta1)) + u3*(u3*(15 + 2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6
    //   + cos(theta3_from_theta1))) + u5_from_u3'*sin(theta3_from_theta1)) +
    //   18*sin(theta3_from_theta1)*(u3*u3_by_theta2_from_theta1 + u3_by_theta2_from_theta1*(u3 + u4_from_u3
    //   + u5_from_u3)) - u5_from_u3_dot_by_theta2_from_theta1*(7 + 9*cos(theta3_from_theta1)) +
    //   3*cos(theta2_from_theta1)*(3*cos(theta2_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 +
    //   2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2) + 2*u5_from_u3'*sin(theta3_from_theta1)) +
    //   3*sin(theta2_from_theta1)*(2*sin(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2) - u5_from_u3'*(1
    //   + 2*cos(theta3_from_theta1))) + 2*u3_by_theta2_from_theta1*(3*sin(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 + u4_from_u3 + u5_from_u3)) -
    //   sin(theta3_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 +
    //   u5_from_u3))) + 2*u3*(3*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 +
    //   2*cos(theta3_from_theta1)*(u3 + u4_from_u3 + u5_from_u3)) +
    //   6*sin(theta2_from_theta1)*(u3_by_theta2_from_theta1 +
    //   u3_by_theta2_from_theta1*cos(theta3_from_theta1)) +
    //   sin(theta3_from_theta1)*(6*sin(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3) -
    //   u3_by_theta2_from_theta1 - 6*u3_by_theta2_from_theta1*cos(theta2_from_theta1))) +
    //   6*u5_from_u3_dot_by_theta2_from_theta1*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   u5_from_u3_dot_by_theta2_from_theta1*(2 + cos(theta3_from_theta1)) +
    //   3*u5_from_u3_dot_by_theta2_from_theta1*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1))) +
    //   3*sin(theta2_from_theta1)*(u3*u3_by_theta2_from_theta1*(15 + 2*cos(theta3_from_theta1)) +
    //   u3_by_theta2_from_theta1*(u3*(15 + 2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6 +
    //   cos(theta3_from_theta1))) + u5_from_u3_dot_by_theta2_from_theta1*sin(theta3_from_theta1))) +
    //   sin(theta3_from_theta1)*(9*u5_from_u3'*cos(theta2_from_theta1) +
    //   3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + 5*u5_from_u3^2 + u3*(13*u3 + 14*u4_from_u3 +
    //   10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3)) +
    //   3*cos(theta2_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2) - 3*u5_from_u3'*sin(theta2_from_theta1)) +
    //   18*u3*u3_by_theta2_from_theta1 + 2*u3_by_theta2_from_theta1*(9*u3 + 9*u4_from_u3 + 7*u5_from_u3) +
    //   9*u5_from_u3_dot_by_theta2_from_theta1*sin(theta2_from_theta1) +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2) +
    //   3*u5_from_u3'*cos(theta2_from_theta1) - u3_by_theta2_from_theta1*(13*u3 + 14*u4_from_u3 +
    //   10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3)) +
    //   u3*(6*sin(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3) - 13*u3_by_theta2_from_theta1 -
    //   12*u3_by_theta2_from_theta1*cos(theta2_from_theta1)) +
    //   3*u5_from_u3_dot_by_theta2_from_theta1*sin(theta2_from_theta1))))/(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1)
    //   - 33 - cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))
    let u4_from_u3_dot_by_theta2_from_theta1 = r1__of_place_29_inv
        * (cos_theta3_from_theta1
            * (u5_from_u3_dot_by_theta2_from_theta1 * r1__of_place_9
                - u3_by_theta2_from_theta1 * u3_plus_r1__of_motion
                    * u4_from_u3_dot_by_theta2_from_theta1_of_place
                - u3_of_place_2
                    * (u4_from_u3_dot_by_theta2_from_theta1_of_motion_2
                        + u4_from_u3_dot_by_theta2_from_theta1_of_motion_8)
                - u3_of_place_3
                    * (u4_from_u3_dot_by_theta2_from_theta1_of_motion_9
                        + u4_from_u3_dot_by_theta2_from_theta1_of_motion_10))
            - u3_of_place_3
                * (u3_by_theta2_from_theta1
                    .mul_add(r1__of_motion_23, u3_of_place_3 * u5_from_u3_sq)
                    + u3 * r1__by_theta2_from_theta1_of_u5_from_u3)
            + sin_theta3_from_theta1
                * (u3_of_place_2
                    * (u3_by_theta2_from_theta1 * r1__of_motion_21 - u5_from_u3_dot * u3_of_place_2
                        - u3_of_place_3 * (u5_from_u3_dot_by_theta2_from_theta1 + r1__of_motion_34)
                        + u3 * r1__by_theta2_from_theta1_of_motion_4)
                    - u5_from_u3_dot_by_theta2_from_theta1 * r1__of_place_17
                    - u5_from_u3_dot * u5_from_u3_dot_of_place_3
                    - u3_of_place_3 * u4_from_u3_dot_by_theta2_from_theta1_of_motion_11
                    - u3_by_theta2_from_theta1 * u4_from_u3_dot_by_theta2_from_theta1_of_motion_14)
            - S::int(9) * u5_from_u3_dot * sin_theta2_from_theta1
                * (cos_theta2_from_theta1 + u4_from_u3_dot_by_theta2_from_theta1_of_place_2)
            - u3_of_place_2 * u4_from_u3_dot_by_theta2_from_theta1_of_motion_15
            + u5_from_u3_dot_by_theta2_from_theta1
                * u4_from_u3_dot_by_theta2_from_theta1_of_place_4)
        + r1__by_theta2_from_theta1_of_place_12 * u4_from_u3_dot_by_theta2_from_theta1_of_motion_19;
    // 7 + u3_of_place_8
    let u3_by_theta3_from_theta1_of_place = S::int(7) + u3_of_place_8;
    // u3_by_theta3_from_theta1 = -(sin(theta3_from_theta1)*(14*u4_from_u3 - 7*u5_from_u3 -
    //   2*H_n3_scaled_per_m_per_l_squared + 3*cos(theta2_from_theta1)*(3*u4_from_u3 - 3*u5_from_u3*(3 +
    //   2*cos(theta2_from_theta1)) - 2*H_n3_scaled_per_m_per_l_squared)) +
    //   3*sin(theta2_from_theta1)*(2*u4_from_u3 + cos(theta3_from_theta1)*(u5_from_u3*(7 +
    //   6*cos(theta2_from_theta1)) - u4_from_u3 + 2*H_n3_scaled_per_m_per_l_squared)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2
    let u3_by_theta3_from_theta1 = -u3_of_place_12_sq
        * (sin_theta3_from_theta1
            * (u4_from_u3_times_14
                + u3_of_place_2
                    * (u4_from_u3_times_3 - u5_from_u3_times_3 * (S::int(3) + r1__of_place_4)
                        - u3_by_theta2_from_theta1_of_place)
                - u3_by_theta2_from_theta1_of_u5_from_u3)
            + u3_of_place_3
                * (u4_from_u3_doubled
                    + cos_theta3_from_theta1
                        * u5_from_u3
                            .mul_add(
                                u3_by_theta3_from_theta1_of_place,
                                -u3_by_theta2_from_theta1_of_u4_from_u3,
                            )));
    let r1__by_theta3_from_theta1_of_place = u3_by_theta3_from_theta1 * u3_of_place_6;
    let r1__by_theta3_from_theta1_of_place_2 = S::int(4) * sin_theta3_from_theta1;
    // u3_of_place_3*(r1__of_motion_3*r1__of_place_3 - u3_by_theta3_from_theta1*r1__of_place -
    //   r1__by_theta2_from_theta1_of_place*r1__by_theta3_from_theta1_of_place) -
    //   u3_of_place_9*r1__of_motion_5 +
    //   r1__by_theta3_from_theta1_of_place_2*(u3_of_place_2*r1__by_theta3_from_theta1_of_place -
    //   4*u3_by_theta3_from_theta1)
    let r1__by_theta3_from_theta1_of_motion = u3_of_place_3
        * ((-u3_by_theta3_from_theta1)
            .mul_add(r1__of_place, r1__of_motion_3 * r1__of_place_3)
            - r1__by_theta2_from_theta1_of_place * r1__by_theta3_from_theta1_of_place)
        - u3_of_place_9 * r1__of_motion_5
        + r1__by_theta3_from_theta1_of_place_2
            * (-u3_by_theta3_from_theta1)
                .mul_add(S::int(4), u3_of_place_2 * r1__by_theta3_from_theta1_of_place);
    // r1__of_motion*sin(theta3_from_theta1) - u3_by_theta3_from_theta1*u3_of_place
    let r1__by_theta3_from_theta1_of_motion_2 = (-u3_by_theta3_from_theta1)
        .mul_add(u3_of_place, r1__of_motion * sin_theta3_from_theta1);
    // u3_by_theta3_from_theta1*r1__of_place_21 - u3_plus_u5_from_u3*r1__of_place_3
    let r1__by_theta3_from_theta1_of_u5_from_u3 = (-u3_plus_u5_from_u3)
        .mul_add(r1__of_place_3, u3_by_theta3_from_theta1 * r1__of_place_21);
    let r1__by_theta3_from_theta1_of_place_3 = u3_by_theta3_from_theta1
        * r1__by_theta2_from_theta1_of_place_5;
    let r1__by_theta3_from_theta1_of_place_4 = u3_by_theta3_from_theta1
        * r1__by_theta2_from_theta1_of_place_6;
    // 6*u3_by_theta3_from_theta1 - r1__by_theta3_from_theta1_of_place_4*cos(theta2_from_theta1)
    let r1__by_theta3_from_theta1_of_place_5 = (-r1__by_theta3_from_theta1_of_place_4)
        .mul_add(cos_theta2_from_theta1, S::int(6) * u3_by_theta3_from_theta1);
    let r1__by_theta3_from_theta1_of_motion_3 = r1__of_motion_11 * sin_theta3_from_theta1;
    let r1__by_theta3_from_theta1_of_place_6 = u3_of_place_10 * cos_theta3_from_theta1;
    let r1__by_theta3_from_theta1_of_place_7 = u3_of_place_3 * cos_theta3_from_theta1;
    // r1__of_place_26*sin(theta3_from_theta1) + r1__of_place_28*u5_from_u3_dot_of_place +
    //   r1__of_place_8*(sin(theta3_from_theta1) -
    //   r1__of_place_4*u5_from_u3_dot_by_theta2_from_theta1_of_place_2)
    let r1__by_theta3_from_theta1_of_place_8 = r1__of_place_26 * sin_theta3_from_theta1
        + r1__of_place_28 * u5_from_u3_dot_of_place
        + r1__of_place_8
            * (-r1__of_place_4)
                .mul_add(
                    u5_from_u3_dot_by_theta2_from_theta1_of_place_2, sin_theta3_from_theta1,
                );
    // r1__by_theta3_from_theta1 = 2*m_l_squared_by_12*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   12 + 3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   3*sin(theta2_from_theta1)*cos(theta3_from_theta1))*(u3*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15
    //   + 2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6 + cos(theta3_from_theta1)) +
    //   6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(3*u3 + 3*u4_from_u3 + 3*u5_from_u3 -
    //   cos(theta2_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 +
    //   u5_from_u3)))) + sin(theta3_from_theta1)*(18*u3 + 18*u4_from_u3 + 14*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3))) + 3*sin(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
    //   3*cos(theta2_from_theta1)))) - 3*cos(theta2_from_theta1)*(sin(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(5 + cos(theta3_from_theta1)) + 3*cos(theta2_from_theta1)*(2*u4_from_u3^2 +
    //   u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) +
    //   3*sin(theta2_from_theta1)*(u5_from_u3^2 - cos(theta3_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 +
    //   2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) +
    //   3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2 + cos(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(6 + cos(theta3_from_theta1)))) + sin(theta3_from_theta1)*(9*u4_from_u3^2 +
    //   7*u5_from_u3^2 + 9*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/((13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))) +
    //   m_l_squared_by_12*(9*sin(theta2_from_theta1)*cos(theta3_from_theta1) + sin(theta3_from_theta1)*(7 -
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 9*cos(theta3_from_theta1)) +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*cos(theta3_from_theta1) -
    //   sin(theta3_from_theta1)*(2 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1))) +
    //   cos(theta3_from_theta1)*(6*sin(theta2_from_theta1)*cos(theta3_from_theta1) - sin(theta3_from_theta1)
    //   - 6*cos(theta2_from_theta1)*sin(theta3_from_theta1))) +
    //   3*cos(theta3_from_theta1)*(3*sin(theta3_from_theta1) +
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1)))*(u3*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15
    //   + 2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6 + cos(theta3_from_theta1)) +
    //   6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(3*u3 + 3*u4_from_u3 + 3*u5_from_u3 -
    //   cos(theta2_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 +
    //   u5_from_u3)))) + sin(theta3_from_theta1)*(18*u3 + 18*u4_from_u3 + 14*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3))) + 3*sin(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
    //   3*cos(theta2_from_theta1)))) - 3*cos(theta2_from_theta1)*(sin(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(5 + cos(theta3_from_theta1)) + 3*cos(theta2_from_theta1)*(2*u4_from_u3^2 +
    //   u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) +
    //   3*sin(theta2_from_theta1)*(u5_from_u3^2 - cos(theta3_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 +
    //   2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) +
    //   3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2 + cos(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(6 + cos(theta3_from_theta1)))) + sin(theta3_from_theta1)*(9*u4_from_u3^2 +
    //   7*u5_from_u3^2 + 9*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/((13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))) +
    //   m_l_squared_by_12*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*cos(theta3_from_theta1)
    //   + sin(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))) +
    //   9*cos(theta3_from_theta1)*(sin(theta3_from_theta1) +
    //   2*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*cos(theta3_from_theta1) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))))*(u3*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15
    //   + 2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6 + cos(theta3_from_theta1)) +
    //   6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(3*u3 + 3*u4_from_u3 + 3*u5_from_u3 -
    //   cos(theta2_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 +
    //   u5_from_u3)))) + sin(theta3_from_theta1)*(18*u3 + 18*u4_from_u3 + 14*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3))) + 3*sin(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
    //   3*cos(theta2_from_theta1)))) - 3*cos(theta2_from_theta1)*(sin(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(5 + cos(theta3_from_theta1)) + 3*cos(theta2_from_theta1)*(2*u4_from_u3^2 +
    //   u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) +
    //   3*sin(theta2_from_theta1)*(u5_from_u3^2 - cos(theta3_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 +
    //   2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) +
    //   3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2 + cos(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(6 + cos(theta3_from_theta1)))) + sin(theta3_from_theta1)*(9*u4_from_u3^2 +
    //   7*u5_from_u3^2 + 9*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/((13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))^2) +
    //   2*m_l_squared_by_12*(sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   3*sin(theta2_from_theta1)*cos(theta3_from_theta1))*(u3*(cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(u3*(13
    //   + 6*cos(theta2_from_theta1)) + 6*u4_from_u3*(3 + cos(theta2_from_theta1)) + 6*u5_from_u3 +
    //   2*cos(theta3_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(8*u3 + 9*u4_from_u3 + 8*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3)))) - sin(theta3_from_theta1)*(13*u3 + 18*u4_from_u3 + 6*u5_from_u3 +
    //   3*cos(theta2_from_theta1)*(3*u3*(5 + 2*cos(theta2_from_theta1)) + 2*u4_from_u3*(10 +
    //   3*cos(theta2_from_theta1)) + 6*u5_from_u3)) - 6*sin(theta2_from_theta1)*(u3 + 3*u4_from_u3 +
    //   u5_from_u3 + 3*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(3*u4_from_u3^2*(3 + cos(theta2_from_theta1)) +
    //   3*u5_from_u3^2 + cos(theta3_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) + sin(theta3_from_theta1)*(9*u4_from_u3^2
    //   + 8*u5_from_u3^2 - 3*cos(theta2_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) -
    //   3*sin(theta3_from_theta1)*(3*u4_from_u3^2 + u5_from_u3^2 + cos(theta2_from_theta1)*(u4_from_u3^2*(10
    //   + 3*cos(theta2_from_theta1)) + 3*u5_from_u3^2)) - 3*sin(theta2_from_theta1)*(3*u4_from_u3^2 +
    //   u5_from_u3^2 + 3*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2 -
    //   m_l_squared_by_12*(sin(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(3*u4_from_u3^2*(3 +
    //   cos(theta2_from_theta1)) + 3*u5_from_u3^2 + cos(theta3_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) + sin(theta3_from_theta1)*(9*u4_from_u3^2
    //   + 8*u5_from_u3^2 - 3*cos(theta2_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) +
    //   3*cos(theta3_from_theta1)*(3*u4_from_u3^2 + u5_from_u3^2 + cos(theta2_from_theta1)*(u4_from_u3^2*(10
    //   + 3*cos(theta2_from_theta1)) + 3*u5_from_u3^2)) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1)*(u4_from_u3^2 +
    //   2*u5_from_u3^2 + 6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)) +
    //   cos(theta3_from_theta1)*(3*cos(theta2_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)) - 9*u4_from_u3^2 - 8*u5_from_u3^2)) +
    //   u3_by_theta3_from_theta1*(sin(theta3_from_theta1)*(13*u3 + 18*u4_from_u3 + 6*u5_from_u3 +
    //   3*cos(theta2_from_theta1)*(3*u3*(5 + 2*cos(theta2_from_theta1)) + 2*u4_from_u3*(10 +
    //   3*cos(theta2_from_theta1)) + 6*u5_from_u3)) -
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(u3*(13 + 6*cos(theta2_from_theta1)) +
    //   6*u4_from_u3*(3 + cos(theta2_from_theta1)) + 6*u5_from_u3 + 2*cos(theta3_from_theta1)*(2*u3 +
    //   u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   2*sin(theta3_from_theta1)*(8*u3 + 9*u4_from_u3 + 8*u5_from_u3 - 3*cos(theta2_from_theta1)*(2*u3 +
    //   u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3)))) +
    //   6*sin(theta2_from_theta1)*(u3 + 3*u4_from_u3 + u5_from_u3 + 3*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + u3*(sin(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(u3*(13 +
    //   6*cos(theta2_from_theta1)) + 6*u4_from_u3*(3 + cos(theta2_from_theta1)) + 6*u5_from_u3 +
    //   2*cos(theta3_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(8*u3 + 9*u4_from_u3 + 8*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3)))) + cos(theta3_from_theta1)*(13*u3 + 18*u4_from_u3 + 6*u5_from_u3 +
    //   3*cos(theta2_from_theta1)*(3*u3*(5 + 2*cos(theta2_from_theta1)) + 2*u4_from_u3*(10 +
    //   3*cos(theta2_from_theta1)) + 6*u5_from_u3)) + 6*sin(theta2_from_theta1)*(u3_by_theta3_from_theta1 +
    //   3*u3_by_theta3_from_theta1*cos(theta2_from_theta1)) +
    //   cos(theta3_from_theta1)*(2*cos(theta3_from_theta1)*(3*cos(theta2_from_theta1)*(2*u3 + u4_from_u3 +
    //   2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3)) - 8*u3 - 9*u4_from_u3 -
    //   8*u5_from_u3) + 3*sin(theta2_from_theta1)*(2*sin(theta3_from_theta1)*(2*u3 + u4_from_u3 +
    //   2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3)) -
    //   u3_by_theta3_from_theta1*(13 + 6*cos(theta2_from_theta1)) -
    //   4*cos(theta3_from_theta1)*(u3_by_theta3_from_theta1 +
    //   3*u3_by_theta3_from_theta1*cos(theta2_from_theta1))) +
    //   4*sin(theta3_from_theta1)*(3*cos(theta2_from_theta1)*(u3_by_theta3_from_theta1 +
    //   3*u3_by_theta3_from_theta1*cos(theta2_from_theta1)) - 4*u3_by_theta3_from_theta1)) +
    //   sin(theta3_from_theta1)*(13*u3_by_theta3_from_theta1 +
    //   9*u3_by_theta3_from_theta1*cos(theta2_from_theta1)*(5 + 2*cos(theta2_from_theta1)))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   m_l_squared_by_12*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(9*sin(theta3_from_theta1)^2*(u4_from_u3^2 + u5_from_u3^2) -
    //   cos(theta3_from_theta1)*(9*u4_from_u3^2 + 7*u5_from_u3^2 + 9*cos(theta3_from_theta1)*(u4_from_u3^2 +
    //   u5_from_u3^2)) + 3*cos(theta2_from_theta1)*(cos(theta3_from_theta1)*(7*u4_from_u3^2 +
    //   u5_from_u3^2*(5 + cos(theta3_from_theta1)) + 3*cos(theta2_from_theta1)*(2*u4_from_u3^2 +
    //   u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) -
    //   sin(theta3_from_theta1)*(u5_from_u3^2*sin(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*sin(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)) +
    //   3*sin(theta2_from_theta1)*(2*sin(theta3_from_theta1)*cos(theta3_from_theta1)*(u4_from_u3^2 +
    //   u5_from_u3^2) + sin(theta3_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 +
    //   2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) +
    //   3*sin(theta2_from_theta1)*(u5_from_u3^2*sin(theta3_from_theta1)*cos(theta3_from_theta1) +
    //   sin(theta3_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2*(6 + cos(theta3_from_theta1)))) -
    //   u3_by_theta3_from_theta1*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15 +
    //   2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6 + cos(theta3_from_theta1)) +
    //   6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(3*u3 + 3*u4_from_u3 + 3*u5_from_u3 -
    //   cos(theta2_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 +
    //   u5_from_u3)))) + sin(theta3_from_theta1)*(18*u3 + 18*u4_from_u3 + 14*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3))) + 3*sin(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
    //   3*cos(theta2_from_theta1)))) + u3*(3*sin(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15 +
    //   2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6 + cos(theta3_from_theta1)) +
    //   6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(3*u3 + 3*u4_from_u3 + 3*u5_from_u3 -
    //   cos(theta2_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 +
    //   u5_from_u3)))) + cos(theta3_from_theta1)*(3*cos(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 +
    //   10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3)) - 18*u3 -
    //   18*u4_from_u3 - 14*u5_from_u3) - 39*u3_by_theta3_from_theta1*sin(theta2_from_theta1) +
    //   3*cos(theta3_from_theta1)*(2*cos(theta3_from_theta1)*(cos(theta2_from_theta1)*(u3 + u5_from_u3 +
    //   6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3)) - 3*u3 - 3*u4_from_u3 - 3*u5_from_u3) +
    //   sin(theta2_from_theta1)*(2*u3*sin(theta3_from_theta1) + 2*u5_from_u3*sin(theta3_from_theta1) -
    //   u3_by_theta3_from_theta1*(15 + 2*cos(theta3_from_theta1)) +
    //   12*cos(theta2_from_theta1)*(sin(theta3_from_theta1)*(u3 + u4_from_u3 + u5_from_u3) -
    //   u3_by_theta3_from_theta1 - u3_by_theta3_from_theta1*cos(theta3_from_theta1))) +
    //   2*sin(theta3_from_theta1)*(cos(theta2_from_theta1)*(u3_by_theta3_from_theta1 +
    //   6*u3_by_theta3_from_theta1*cos(theta2_from_theta1)) - 3*u3_by_theta3_from_theta1)) +
    //   3*sin(theta3_from_theta1)*(cos(theta2_from_theta1)*(13*u3_by_theta3_from_theta1 +
    //   12*u3_by_theta3_from_theta1*cos(theta2_from_theta1)) - 6*u3_by_theta3_from_theta1)))/((13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1)
    //   - 33 - cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))))
    let r1__by_theta3_from_theta1 = r1__of_place_30
        * (-cos_theta3_from_theta1
            * (-r1__of_motion_13)
                .mul_add(cos_theta3_from_theta1, u3_of_place_4 * r1__of_motion_12)
            + u3_by_theta3_from_theta1 * r1__of_motion_10
            - r1__of_motion_15 * sin_theta3_from_theta1 - r1__of_motion_19 * r1__of_place_22
            - u3
                * (sin_theta3_from_theta1
                    * (r1__of_motion_6
                        + u3_by_theta3_from_theta1
                            * r1__of_place_5
                                .mul_add(u5_from_u3_dot_of_place_3, S::int(13)))
                    + u3_of_place_10 * r1__by_theta3_from_theta1_of_place
                    + cos_theta3_from_theta1
                        * (r1__of_motion_8 + r1__by_theta3_from_theta1_of_motion)))
        + r1__by_theta2_from_theta1_of_place_8
            * (u3_by_theta3_from_theta1 * r1__of_motion_31
                + r1__of_motion_33 * cos_theta3_from_theta1
                - u3_of_place_3
                    * u4_from_u3_dot_by_theta2_from_theta1_of_u5_from_u3
                        .mul_add(
                            cos_theta3_from_theta1,
                            r1__of_motion_40 * sin_theta3_from_theta1,
                        )
                + u3
                    * (S::int(39) * u3_by_theta3_from_theta1 * sin_theta2_from_theta1
                        + r1__of_motion_22 * cos_theta3_from_theta1
                        + r1__of_place_22
                            * (sin_theta2_from_theta1
                                * (-r1__by_theta2_from_theta1_of_place_4)
                                    .mul_add(
                                        r1__by_theta3_from_theta1_of_motion_2,
                                        r1__by_theta3_from_theta1_of_u5_from_u3,
                                    ) + u3_of_place_9 * r1__of_motion_29
                                + r1__of_place_3
                                    * (-r1__by_theta3_from_theta1_of_place_3)
                                        .mul_add(
                                            cos_theta2_from_theta1,
                                            S::int(3) * u3_by_theta3_from_theta1,
                                        ))
                        + r1__of_place_7
                            * (r1__by_theta3_from_theta1_of_place_5 - r1__of_motion_30))
                - u4_from_u3_dot_by_theta2_from_theta1_of_place_5
                    * r1__by_theta3_from_theta1_of_motion_3
                + u3_of_place_2
                    * (sin_theta3_from_theta1
                        * u3_of_place_8
                            .mul_add(
                                r1__by_theta3_from_theta1_of_motion_3,
                                u4_from_u3_dot_by_theta2_from_theta1_of_u5_from_u3,
                            )
                        - u3_of_place_3 * sin_theta3_from_theta1
                            * (r1__of_motion_35 + r1__of_motion_36)
                        - r1__of_motion_37 * cos_theta3_from_theta1))
        + r1__by_theta2_from_theta1_of_motion_5
            * (r1__of_place_8 * sin_theta2_from_theta1 + r1__of_place_10 * sin_theta3_from_theta1
                + r1__of_place_22 * (r1__of_place_7 + u5_from_u3_dot_by_theta2_from_theta1_of_place)
                + u3_of_place_2
                    * (cos_theta3_from_theta1
                        * (-r1__by_theta2_from_theta1_of_place_5)
                            .mul_add(
                                sin_theta3_from_theta1, r1__by_theta3_from_theta1_of_place_6,
                            ) - r1__of_place_15 * sin_theta3_from_theta1
                        + r1__by_theta3_from_theta1_of_place_7))
        + S::int(2) * r1__u3_of_place_12
            * u3_of_place_6
                .mul_add(sin_theta3_from_theta1, -r1__by_theta3_from_theta1_of_place_7)
        + r1__by_theta2_from_theta1_of_motion_6 * r1__by_theta3_from_theta1_of_place_8;
    // u5_from_u3_dot_by_theta3_from_theta1 = r1_*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))))*(sin(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1))) +
    //   cos(theta3_from_theta1)*(5*sin(theta3_from_theta1) +
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*cos(theta3_from_theta1) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))))/(4*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1))))^2) -
    //   r1_*(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*cos(theta3_from_theta1) +
    //   sin(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))) +
    //   9*cos(theta3_from_theta1)*(sin(theta3_from_theta1) +
    //   2*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*cos(theta3_from_theta1) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))))/(4*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1))))) + r1__by_theta3_from_theta1*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(4*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot_by_theta3_from_theta1 = u5_from_u3_dot_of_place_8
        * (r1__by_theta3_from_theta1
            + u5_from_u3_dot_by_theta2_from_theta1_of_place_3
                * (cos_theta3_from_theta1
                    * (-u5_from_u3_dot_of_place_3)
                        .mul_add(
                            u5_from_u3_dot_by_theta2_from_theta1_of_place_2,
                            S::int(5) * sin_theta3_from_theta1,
                        ) + u5_from_u3_dot_of_place_4 * sin_theta3_from_theta1))
        - S::ratio(1, 4) * u5_from_u3_dot_by_theta2_from_theta1_of_place_4
            * r1__by_theta3_from_theta1_of_place_8;
    // u5_from_u3'*cos(theta3_from_theta1) + u5_from_u3_dot_by_theta3_from_theta1*sin(theta3_from_theta1)
    let u4_from_u3_dot_by_theta3_from_theta1_of_motion = u5_from_u3_dot_by_theta3_from_theta1
        .mul_add(sin_theta3_from_theta1, u5_from_u3_dot * cos_theta3_from_theta1);
    // u3_by_theta3_from_theta1*u3_plus_r1__of_motion*u4_from_u3_dot_by_theta2_from_theta1_of_place -
    //   u5_from_u3_dot_by_theta3_from_theta1*r1__of_place_9 +
    //   r1__of_place_8*u4_from_u3_dot_by_theta2_from_theta1_of_motion_16 +
    //   u5_from_u3'*u4_from_u3_dot_by_theta2_from_theta1_of_place_5 +
    //   u3_of_place_2*(u5_from_u3_dot_by_theta3_from_theta1*r1__of_place_13 -
    //   u5_from_u3_sq*cos(theta3_from_theta1) - u4_from_u3_dot_by_theta2_from_theta1_of_motion -
    //   u3_of_place_2*(u4_from_u3_dot_by_theta2_from_theta1_of_motion_3 -
    //   u5_from_u3_dot_by_theta3_from_theta1*r1__of_place_11) +
    //   u3_by_theta3_from_theta1*u4_from_u3_dot_by_theta2_from_theta1_of_motion_7 -
    //   u3_doubled*(r1__of_motion_28*cos(theta3_from_theta1) +
    //   u3_of_place_10*r1__by_theta3_from_theta1_of_motion_2 +
    //   r1__by_theta3_from_theta1_of_place_3*sin(theta3_from_theta1)) -
    //   u3_of_place_10*(r1__by_theta3_from_theta1_of_motion_3 -
    //   u4_from_u3_dot_by_theta3_from_theta1_of_motion)) +
    //   u3_of_place_3*(u3_by_theta3_from_theta1*r1__of_motion_26 -
    //   u4_from_u3_dot_by_theta2_from_theta1_of_u5_from_u3 + u3*r1__by_theta3_from_theta1_of_u5_from_u3 +
    //   u4_from_u3_dot_by_theta3_from_theta1_of_motion)
    let u4_from_u3_dot_by_theta3_from_theta1_of_motion_2 = u3_by_theta3_from_theta1
        * u3_plus_r1__of_motion * u4_from_u3_dot_by_theta2_from_theta1_of_place
        - u5_from_u3_dot_by_theta3_from_theta1 * r1__of_place_9
        + r1__of_place_8 * u4_from_u3_dot_by_theta2_from_theta1_of_motion_16
        + u5_from_u3_dot * u4_from_u3_dot_by_theta2_from_theta1_of_place_5
        + u3_of_place_2
            * (u5_from_u3_dot_by_theta3_from_theta1 * r1__of_place_13
                - u5_from_u3_sq * cos_theta3_from_theta1
                - u4_from_u3_dot_by_theta2_from_theta1_of_motion
                - u3_of_place_2
                    * (-u5_from_u3_dot_by_theta3_from_theta1)
                        .mul_add(
                            r1__of_place_11, u4_from_u3_dot_by_theta2_from_theta1_of_motion_3,
                        )
                + u3_by_theta3_from_theta1 * u4_from_u3_dot_by_theta2_from_theta1_of_motion_7
                - u3_doubled
                    * (u3_of_place_10
                        .mul_add(
                            r1__by_theta3_from_theta1_of_motion_2,
                            r1__of_motion_28 * cos_theta3_from_theta1,
                        ) + r1__by_theta3_from_theta1_of_place_3 * sin_theta3_from_theta1)
                - u3_of_place_10
                    * (r1__by_theta3_from_theta1_of_motion_3
                        - u4_from_u3_dot_by_theta3_from_theta1_of_motion))
        + u3_of_place_3
            * (u3_by_theta3_from_theta1
                .mul_add(
                    r1__of_motion_26, -u4_from_u3_dot_by_theta2_from_theta1_of_u5_from_u3,
                ) + u3 * r1__by_theta3_from_theta1_of_u5_from_u3
                + u4_from_u3_dot_by_theta3_from_theta1_of_motion);
    // u5_from_u3_dot_by_theta3_from_theta1*r1__of_place_17 +
    //   u3_by_theta3_from_theta1*u4_from_u3_dot_by_theta2_from_theta1_of_motion_14 +
    //   u3_of_place_2*(u5_from_u3_dot_by_theta3_from_theta1*u3_of_place_3 -
    //   u3_by_theta3_from_theta1*r1__of_motion_21 - u3*r1__by_theta3_from_theta1_of_place_4)
    let u4_from_u3_dot_by_theta3_from_theta1_of_motion_3 = u5_from_u3_dot_by_theta3_from_theta1
        * r1__of_place_17
        + u3_by_theta3_from_theta1 * u4_from_u3_dot_by_theta2_from_theta1_of_motion_14
        + u3_of_place_2
            * ((-u3_by_theta3_from_theta1)
                .mul_add(
                    r1__of_motion_21,
                    u5_from_u3_dot_by_theta3_from_theta1 * u3_of_place_3,
                ) - u3 * r1__by_theta3_from_theta1_of_place_4);
    // u4_from_u3_dot_by_theta3_from_theta1 =
    //   (18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*cos(theta3_from_theta1) +
    //   sin(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))) +
    //   9*cos(theta3_from_theta1)*(sin(theta3_from_theta1) +
    //   2*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*cos(theta3_from_theta1) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))))*(3*u5_from_u3'*(4 + 3*cos(theta2_from_theta1)*(1
    //   + cos(theta2_from_theta1))) - 3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2*(1 -
    //   3*cos(theta2_from_theta1)) + u3*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
    //   3*cos(theta2_from_theta1)))) - cos(theta3_from_theta1)*(9*sin(theta3_from_theta1)*(u4_from_u3^2 +
    //   u5_from_u3^2 + 2*u3*(u3 + u4_from_u3 + u5_from_u3)) - u5_from_u3'*(7 + 9*cos(theta3_from_theta1)) +
    //   3*cos(theta2_from_theta1)*(u5_from_u3'*(2 + cos(theta3_from_theta1)) -
    //   u5_from_u3^2*sin(theta3_from_theta1) - 2*u3*(sin(theta3_from_theta1)*(u3 + u5_from_u3 +
    //   6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3)) - 3*sin(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   3*sin(theta2_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 +
    //   u5_from_u3^2) + 2*u5_from_u3'*sin(theta3_from_theta1)) -
    //   3*cos(theta2_from_theta1)*(2*sin(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2) - u5_from_u3'*(1
    //   + 2*cos(theta3_from_theta1)))) + 3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2*(6 +
    //   cos(theta3_from_theta1)) + u3*(u3*(15 + 2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6
    //   + cos(theta3_from_theta1))) + u5_from_u3'*sin(theta3_from_theta1))) -
    //   sin(theta3_from_theta1)*(9*u4_from_u3^2 + 7*u5_from_u3^2 + 2*u3*(9*u3 + 9*u4_from_u3 + 7*u5_from_u3)
    //   + 9*u5_from_u3'*sin(theta2_from_theta1) +
    //   3*cos(theta2_from_theta1)*(3*u5_from_u3'*sin(theta2_from_theta1) - 7*u4_from_u3^2 - 5*u5_from_u3^2 -
    //   u3*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 +
    //   u5_from_u3)) - 3*cos(theta2_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2))))/(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))^2 +
    //   (sin(theta3_from_theta1)*(9*sin(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2 + 2*u3*(u3 +
    //   u4_from_u3 + u5_from_u3)) - u5_from_u3'*(7 + 9*cos(theta3_from_theta1)) +
    //   3*cos(theta2_from_theta1)*(u5_from_u3'*(2 + cos(theta3_from_theta1)) -
    //   u5_from_u3^2*sin(theta3_from_theta1) - 2*u3*(sin(theta3_from_theta1)*(u3 + u5_from_u3 +
    //   6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3)) - 3*sin(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   3*sin(theta2_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2 + 2*cos(theta3_from_theta1)*(u4_from_u3^2 +
    //   u5_from_u3^2) + 2*u5_from_u3'*sin(theta3_from_theta1)) -
    //   3*cos(theta2_from_theta1)*(2*sin(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2) - u5_from_u3'*(1
    //   + 2*cos(theta3_from_theta1)))) + 3*sin(theta2_from_theta1)*(7*u4_from_u3^2 + u5_from_u3^2*(6 +
    //   cos(theta3_from_theta1)) + u3*(u3*(15 + 2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6
    //   + cos(theta3_from_theta1))) + u5_from_u3'*sin(theta3_from_theta1))) -
    //   cos(theta3_from_theta1)*(9*u4_from_u3^2 + 7*u5_from_u3^2 + 2*u3*(9*u3 + 9*u4_from_u3 + 7*u5_from_u3)
    //   + 9*u5_from_u3'*sin(theta2_from_theta1) +
    //   3*cos(theta2_from_theta1)*(3*u5_from_u3'*sin(theta2_from_theta1) - 7*u4_from_u3^2 - 5*u5_from_u3^2 -
    //   u3*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 +
    //   u5_from_u3)) - 3*cos(theta2_from_theta1)*(2*u4_from_u3^2 + u5_from_u3^2))) -
    //   3*sin(theta2_from_theta1)*(13*u3*u3_by_theta3_from_theta1 + u3_by_theta3_from_theta1*(13*u3 +
    //   14*u4_from_u3 + 2*u5_from_u3*(1 - 3*cos(theta2_from_theta1)))) +
    //   3*u5_from_u3_dot_by_theta3_from_theta1*(4 + 3*cos(theta2_from_theta1)*(1 + cos(theta2_from_theta1)))
    //   + cos(theta3_from_theta1)*(u5_from_u3_dot_by_theta3_from_theta1*(7 + 9*cos(theta3_from_theta1)) -
    //   9*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2 + 2*u3*(u3 + u4_from_u3 + u5_from_u3)) -
    //   9*u5_from_u3'*sin(theta3_from_theta1) - 18*sin(theta3_from_theta1)*(u3*u3_by_theta3_from_theta1 +
    //   u3_by_theta3_from_theta1*(u3 + u4_from_u3 + u5_from_u3)) -
    //   3*cos(theta2_from_theta1)*(u5_from_u3_dot_by_theta3_from_theta1*(2 + cos(theta3_from_theta1)) -
    //   u5_from_u3^2*cos(theta3_from_theta1) - u5_from_u3'*sin(theta3_from_theta1) -
    //   2*u3_by_theta3_from_theta1*(sin(theta3_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3
    //   + u4_from_u3 + u5_from_u3)) - 3*sin(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 +
    //   2*cos(theta3_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) - 2*u3*(cos(theta3_from_theta1)*(u3 +
    //   u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3)) +
    //   6*sin(theta2_from_theta1)*(sin(theta3_from_theta1)*(u3 + u4_from_u3 + u5_from_u3) -
    //   u3_by_theta3_from_theta1 - u3_by_theta3_from_theta1*cos(theta3_from_theta1)) +
    //   sin(theta3_from_theta1)*(u3_by_theta3_from_theta1 +
    //   6*u3_by_theta3_from_theta1*cos(theta2_from_theta1))) -
    //   6*sin(theta2_from_theta1)*(sin(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2) -
    //   u5_from_u3'*cos(theta3_from_theta1) - u5_from_u3_dot_by_theta3_from_theta1*sin(theta3_from_theta1))
    //   - 3*cos(theta2_from_theta1)*(2*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2) +
    //   2*u5_from_u3'*sin(theta3_from_theta1) - u5_from_u3_dot_by_theta3_from_theta1*(1 +
    //   2*cos(theta3_from_theta1)))) - 3*sin(theta2_from_theta1)*(u5_from_u3'*cos(theta3_from_theta1) -
    //   u5_from_u3^2*sin(theta3_from_theta1) + u3_by_theta3_from_theta1*(u3*(15 + 2*cos(theta3_from_theta1))
    //   + 14*u4_from_u3 + 2*u5_from_u3*(6 + cos(theta3_from_theta1))) - u3*(2*u3*sin(theta3_from_theta1) +
    //   2*u5_from_u3*sin(theta3_from_theta1) - u3_by_theta3_from_theta1*(15 + 2*cos(theta3_from_theta1))) +
    //   u5_from_u3_dot_by_theta3_from_theta1*sin(theta3_from_theta1))) -
    //   sin(theta3_from_theta1)*(18*u3*u3_by_theta3_from_theta1 + 2*u3_by_theta3_from_theta1*(9*u3 +
    //   9*u4_from_u3 + 7*u5_from_u3) + 9*u5_from_u3_dot_by_theta3_from_theta1*sin(theta2_from_theta1) +
    //   3*cos(theta2_from_theta1)*(3*u5_from_u3_dot_by_theta3_from_theta1*sin(theta2_from_theta1) -
    //   u3_by_theta3_from_theta1*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3)) - u3*(13*u3_by_theta3_from_theta1 +
    //   12*u3_by_theta3_from_theta1*cos(theta2_from_theta1)))))/(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))
    let u4_from_u3_dot_by_theta3_from_theta1 = r1__of_place_29_inv
        * (-u3_by_theta3_from_theta1 * u3_of_place_3 * (u3_times_13 + r1__of_motion_23)
            + u5_from_u3_dot_by_theta3_from_theta1 * u4_from_u3_dot_by_theta2_from_theta1_of_place_4
            - cos_theta3_from_theta1
                * (u4_from_u3_dot_by_theta2_from_theta1_of_motion_18
                    + u4_from_u3_dot_by_theta3_from_theta1_of_motion_2)
            - sin_theta3_from_theta1
                * (u4_from_u3_dot_by_theta3_from_theta1_of_motion_3
                    - u4_from_u3_dot_by_theta2_from_theta1_of_motion_17))
        - u4_from_u3_dot_by_theta2_from_theta1_of_motion_19 * r1__by_theta3_from_theta1_of_place_8;
    // u3_by_u4_from_u3 = -(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3_by_u4_from_u3 = -u3_of_place_5 * u3_of_place_12;
    let r1__by_u4_from_u3_of_u4_from_u3 = u4_from_u3 * r1__by_theta2_from_theta1_of_place_5;
    let u3_by_u4_from_u3_doubled = S::int(2) * u3_by_u4_from_u3;
    // 1 + u3_by_u4_from_u3
    let r1__by_u4_from_u3_of_place = S::int(1) + u3_by_u4_from_u3;
    let r1__by_u4_from_u3_of_place_2 = u3_of_place_8 * r1__by_u4_from_u3_of_place;
    // 1 + u3_by_u4_from_u3_doubled + r1__by_u4_from_u3_of_place_2
    let r1__by_u4_from_u3_of_place_3 = S::int(1) + u3_by_u4_from_u3_doubled
        + r1__by_u4_from_u3_of_place_2;
    let r1__by_u4_from_u3_of_place_4 = S::int(13) * u3_by_u4_from_u3;
    let r1__by_u4_from_u3_of_place_5 = S::int(6) * sin_theta3_from_theta1;
    let u4_from_u3_u3_of_place = u4_from_u3 * u3_of_place;
    // 14 + r1__by_u4_from_u3_of_place_4
    let r1__by_u4_from_u3_of_place_6 = S::int(14) + r1__by_u4_from_u3_of_place_4;
    // r1__by_u4_from_u3 =
    //   m_l_squared_by_12*(6*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(3*u4_from_u3*(3 +
    //   cos(theta2_from_theta1)) + cos(theta3_from_theta1)*(u4_from_u3 +
    //   6*u4_from_u3*cos(theta2_from_theta1))) + sin(theta3_from_theta1)*(3*u4_from_u3 -
    //   cos(theta2_from_theta1)*(u4_from_u3 + 6*u4_from_u3*cos(theta2_from_theta1)))) -
    //   6*sin(theta3_from_theta1)*(3*u4_from_u3 + u4_from_u3*cos(theta2_from_theta1)*(10 +
    //   3*cos(theta2_from_theta1))) - 18*sin(theta2_from_theta1)*(u4_from_u3 +
    //   u4_from_u3*cos(theta2_from_theta1)) +
    //   u3_by_u4_from_u3*(cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(u3*(13 +
    //   6*cos(theta2_from_theta1)) + 6*u4_from_u3*(3 + cos(theta2_from_theta1)) + 6*u5_from_u3 +
    //   2*cos(theta3_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(8*u3 + 9*u4_from_u3 + 8*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3)))) - sin(theta3_from_theta1)*(13*u3 + 18*u4_from_u3 + 6*u5_from_u3 +
    //   3*cos(theta2_from_theta1)*(3*u3*(5 + 2*cos(theta2_from_theta1)) + 2*u4_from_u3*(10 +
    //   3*cos(theta2_from_theta1)) + 6*u5_from_u3)) - 6*sin(theta2_from_theta1)*(u3 + 3*u4_from_u3 +
    //   u5_from_u3 + 3*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   u3*(cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(18 + 6*cos(theta2_from_theta1) +
    //   u3_by_u4_from_u3*(13 + 6*cos(theta2_from_theta1)) + 2*cos(theta3_from_theta1)*(1 +
    //   2*u3_by_u4_from_u3 + 6*cos(theta2_from_theta1)*(1 + u3_by_u4_from_u3))) +
    //   2*sin(theta3_from_theta1)*(9 + 8*u3_by_u4_from_u3 - 3*cos(theta2_from_theta1)*(1 +
    //   2*u3_by_u4_from_u3 + 6*cos(theta2_from_theta1)*(1 + u3_by_u4_from_u3)))) -
    //   sin(theta3_from_theta1)*(18 + 13*u3_by_u4_from_u3 + 3*cos(theta2_from_theta1)*(20 +
    //   6*cos(theta2_from_theta1) + 3*u3_by_u4_from_u3*(5 + 2*cos(theta2_from_theta1)))) -
    //   6*sin(theta2_from_theta1)*(3 + u3_by_u4_from_u3 + 3*cos(theta2_from_theta1)*(1 +
    //   u3_by_u4_from_u3))))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   m_l_squared_by_12*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(6*cos(theta2_from_theta1)*(sin(theta3_from_theta1)*(7*u4_from_u3 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3 + u4_from_u3*cos(theta3_from_theta1))) -
    //   6*sin(theta2_from_theta1)*cos(theta3_from_theta1)*(u4_from_u3 + u4_from_u3*cos(theta3_from_theta1)))
    //   - 42*sin(theta2_from_theta1)*(u4_from_u3 + u4_from_u3*cos(theta3_from_theta1)) -
    //   18*sin(theta3_from_theta1)*(u4_from_u3 + u4_from_u3*cos(theta3_from_theta1)) -
    //   u3_by_u4_from_u3*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15 +
    //   2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6 + cos(theta3_from_theta1)) +
    //   6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(3*u3 + 3*u4_from_u3 + 3*u5_from_u3 -
    //   cos(theta2_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 +
    //   u5_from_u3)))) + sin(theta3_from_theta1)*(18*u3 + 18*u4_from_u3 + 14*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3))) + 3*sin(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
    //   3*cos(theta2_from_theta1)))) - 3*u3*(cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(14 +
    //   u3_by_u4_from_u3*(15 + 2*cos(theta3_from_theta1)) + 12*cos(theta2_from_theta1)*(1 + u3_by_u4_from_u3
    //   + cos(theta3_from_theta1)*(1 + u3_by_u4_from_u3))) + 2*sin(theta3_from_theta1)*(3 +
    //   3*u3_by_u4_from_u3 - cos(theta2_from_theta1)*(u3_by_u4_from_u3 + 6*cos(theta2_from_theta1)*(1 +
    //   u3_by_u4_from_u3)))) + sin(theta3_from_theta1)*(6 + 6*u3_by_u4_from_u3 - cos(theta2_from_theta1)*(14
    //   + 13*u3_by_u4_from_u3 + 12*cos(theta2_from_theta1)*(1 + u3_by_u4_from_u3))) +
    //   sin(theta2_from_theta1)*(14 + 13*u3_by_u4_from_u3)))/((13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1)
    //   - 33 - cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))))
    let r1__by_u4_from_u3 = r1__of_place_30
        * (u3_by_u4_from_u3 * r1__of_motion_10
            - u4_from_u3 * r1__of_place_28 * u4_from_u3_dot_by_theta2_from_theta1_of_place_2
            + S::int(6) * cos_theta3_from_theta1
                * (sin_theta2_from_theta1
                    * r1__by_u4_from_u3_of_u4_from_u3
                        .mul_add(
                            cos_theta3_from_theta1,
                            r1__of_place_2 * u4_from_u3_times_3,
                        )
                    + sin_theta3_from_theta1
                        * (-r1__by_u4_from_u3_of_u4_from_u3)
                            .mul_add(cos_theta2_from_theta1, u4_from_u3_times_3))
            + u3
                * (cos_theta3_from_theta1
                    * (u3_of_place_3
                        * (u3_by_u4_from_u3
                            .mul_add(r1__of_place, S::int(18) + u3_of_place_8)
                            + u3_of_place_9 * r1__by_u4_from_u3_of_place_3)
                        + r1__of_place_3
                            * (u3_by_u4_from_u3.mul_add(S::int(8), S::int(9))
                                - u3_of_place_2 * r1__by_u4_from_u3_of_place_3))
                    - u3_of_place_10
                        * u3_of_place_2
                            .mul_add(
                                r1__by_u4_from_u3_of_place,
                                S::int(3) + u3_by_u4_from_u3,
                            )
                    - sin_theta3_from_theta1
                        * (S::int(18)
                            + u3_of_place_2
                                * (u3_by_u4_from_u3 * r1__of_place_5)
                                    .mul_add(S::int(3), S::int(20) + u3_of_place_8)
                            + r1__by_u4_from_u3_of_place_4))
            - r1__by_u4_from_u3_of_place_5
                * (u4_from_u3 * r1__of_place_6)
                    .mul_add(cos_theta2_from_theta1, u4_from_u3_times_3))
        + r1__by_theta2_from_theta1_of_place_8
            * (u4_from_u3_u3_of_place
                * sin_theta2_from_theta1
                    .mul_add(S::int(42), u4_from_u3_dot_by_theta2_from_theta1_of_place)
                + u3_by_u4_from_u3 * r1__of_motion_31
                + u3_of_place_8
                    * (-sin_theta3_from_theta1
                        * u3_of_place_8
                            .mul_add(u4_from_u3_u3_of_place, u4_from_u3_times_7)
                        + r1__by_theta3_from_theta1_of_place_6 * u4_from_u3_u3_of_place)
                + u3_times_3
                    * (cos_theta3_from_theta1
                        * (sin_theta2_from_theta1
                            * (u3_by_u4_from_u3.mul_add(r1__of_place_21, S::int(14))
                                + u3_of_place * r1__by_theta2_from_theta1_of_place_4
                                    * r1__by_u4_from_u3_of_place)
                            + r1__of_place_3
                                * (-cos_theta2_from_theta1
                                    * (u3_by_u4_from_u3 + r1__by_u4_from_u3_of_place_2)
                                    + S::int(3) * r1__by_u4_from_u3_of_place))
                        + r1__by_u4_from_u3_of_place_6 * sin_theta2_from_theta1
                        + sin_theta3_from_theta1
                            * (-cos_theta2_from_theta1
                                * r1__by_theta2_from_theta1_of_place_4
                                    .mul_add(
                                        r1__by_u4_from_u3_of_place, r1__by_u4_from_u3_of_place_6,
                                    ) + S::int(6) * r1__by_u4_from_u3_of_place)));
    // u5_from_u3_dot_by_u4_from_u3 = r1__by_u4_from_u3*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(4*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot_by_u4_from_u3 = r1__by_u4_from_u3 * u5_from_u3_dot_of_place_8;
    // r1__of_place_12 + r1__of_place_13
    let u4_from_u3_dot_by_u4_from_u3_of_place = r1__of_place_12 + r1__of_place_13;
    // u4_from_u3 + u3_doubled
    let u4_from_u3_dot_by_u4_from_u3_of_u4_from_u3 = u4_from_u3 + u3_doubled;
    // u5_from_u3 + u4_from_u3_dot_by_u4_from_u3_of_u4_from_u3
    let u4_from_u3_dot_by_u4_from_u3_of_motion = u5_from_u3
        + u4_from_u3_dot_by_u4_from_u3_of_u4_from_u3;
    // u5_from_u3 + 2*u4_from_u3_dot_by_u4_from_u3_of_u4_from_u3
    let u4_from_u3_dot_by_u4_from_u3_of_motion_2 = u4_from_u3_dot_by_u4_from_u3_of_u4_from_u3
        .mul_add(S::int(2), u5_from_u3);
    // u3_of_place_9*u4_from_u3_dot_by_u4_from_u3_of_motion + u4_from_u3_dot_by_u4_from_u3_of_motion_2
    let u4_from_u3_dot_by_u4_from_u3_of_motion_3 = u3_of_place_9
        .mul_add(
            u4_from_u3_dot_by_u4_from_u3_of_motion, u4_from_u3_dot_by_u4_from_u3_of_motion_2,
        );
    let u4_from_u3_dot_by_u4_from_u3_of_place_2 = u5_from_u3_dot_by_u4_from_u3
        * sin_theta3_from_theta1;
    // u3_plus_u4_from_u3 + u3_by_u4_from_u3*u4_from_u3_dot_by_u4_from_u3_of_motion
    let u4_from_u3_dot_by_u4_from_u3_of_motion_4 = u3_by_u4_from_u3
        .mul_add(u4_from_u3_dot_by_u4_from_u3_of_motion, u3_plus_u4_from_u3);
    // r1__of_motion_25 + u3_r1__of_place_21
    let u4_from_u3_dot_by_u4_from_u3_of_motion_5 = r1__of_motion_25 + u3_r1__of_place_21;
    // u3_times_13 + u4_from_u3_times_7
    let u4_from_u3_dot_by_u4_from_u3_of_u4_from_u3_2 = u3_times_13 + u4_from_u3_times_7;
    // u5_from_u3_times_5 + u3_of_place_2*u4_from_u3_dot_by_u4_from_u3_of_motion_2 +
    //   u4_from_u3_dot_by_u4_from_u3_of_u4_from_u3_2
    let u4_from_u3_dot_by_u4_from_u3_of_motion_6 = u3_of_place_2
        .mul_add(u4_from_u3_dot_by_u4_from_u3_of_motion_2, u5_from_u3_times_5)
        + u4_from_u3_dot_by_u4_from_u3_of_u4_from_u3_2;
    // u5_from_u3_times_7 + 9*u4_from_u3_dot_by_u4_from_u3_of_u4_from_u3
    let u4_from_u3_dot_by_u4_from_u3_of_motion_7 = u4_from_u3_dot_by_u4_from_u3_of_u4_from_u3
        .mul_add(S::int(9), u5_from_u3_times_7);
    // u4_from_u3_dot_by_u4_from_u3 = (3*u5_from_u3_dot_by_u4_from_u3*(4 + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta2_from_theta1))) - 6*sin(theta2_from_theta1)*(7*u3 + 7*u4_from_u3 + u3_by_u4_from_u3*(13*u3
    //   + 7*u4_from_u3 + u5_from_u3*(1 - 3*cos(theta2_from_theta1)))) +
    //   cos(theta3_from_theta1)*(u5_from_u3_dot_by_u4_from_u3*(7 + 9*cos(theta3_from_theta1)) -
    //   18*sin(theta3_from_theta1)*(u3 + u4_from_u3 + u3_by_u4_from_u3*(2*u3 + u4_from_u3 + u5_from_u3)) +
    //   3*cos(theta2_from_theta1)*(2*sin(theta3_from_theta1)*(u3_by_u4_from_u3*(2*u3 + u5_from_u3) +
    //   6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u3_by_u4_from_u3*(2*u3 + u4_from_u3 + u5_from_u3))) -
    //   u5_from_u3_dot_by_u4_from_u3*(2 + cos(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   2*cos(theta3_from_theta1))) - 6*sin(theta2_from_theta1)*(2*u3*(1 + cos(theta3_from_theta1)) +
    //   2*u4_from_u3*(1 + cos(theta3_from_theta1)) + u3_by_u4_from_u3*(4*u3 + 2*u4_from_u3 + u5_from_u3 +
    //   2*cos(theta3_from_theta1)*(2*u3 + u4_from_u3 + u5_from_u3)) +
    //   u5_from_u3_dot_by_u4_from_u3*sin(theta3_from_theta1))) - 3*sin(theta2_from_theta1)*(14*u3 +
    //   14*u4_from_u3 + 2*u3_by_u4_from_u3*(u3*(15 + 2*cos(theta3_from_theta1)) + 7*u4_from_u3 +
    //   u5_from_u3*(6 + cos(theta3_from_theta1))) + u5_from_u3_dot_by_u4_from_u3*sin(theta3_from_theta1))) -
    //   sin(theta3_from_theta1)*(18*u3 + 18*u4_from_u3 + 2*u3_by_u4_from_u3*(18*u3 + 9*u4_from_u3 +
    //   7*u5_from_u3) + 9*u5_from_u3_dot_by_u4_from_u3*sin(theta2_from_theta1) +
    //   3*cos(theta2_from_theta1)*(3*u5_from_u3_dot_by_u4_from_u3*sin(theta2_from_theta1) - 2*u3*(7 +
    //   6*cos(theta2_from_theta1)) - 2*u4_from_u3*(7 + 6*cos(theta2_from_theta1)) -
    //   2*u3_by_u4_from_u3*(13*u3 + 7*u4_from_u3 + 5*u5_from_u3 + 3*cos(theta2_from_theta1)*(4*u3 +
    //   2*u4_from_u3 + u5_from_u3)))))/(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))
    let u4_from_u3_dot_by_u4_from_u3 = r1__of_place_29_inv
        * (cos_theta3_from_theta1
            * (u5_from_u3_dot_by_u4_from_u3 * r1__of_place_9
                - u4_from_u3_dot_by_theta2_from_theta1_of_place
                    * u4_from_u3_dot_by_u4_from_u3_of_motion_4
                + u3_of_place_2
                    * (r1__of_place_3
                        * (u3_by_u4_from_u3 * (u5_from_u3 + u3_doubled)
                            + u3_of_place_8 * u4_from_u3_dot_by_u4_from_u3_of_motion_4)
                        - u5_from_u3_dot_by_u4_from_u3 * u4_from_u3_dot_by_u4_from_u3_of_place
                        - u3_of_place_10
                            * (u3_by_u4_from_u3
                                .mul_add(
                                    u4_from_u3_dot_by_u4_from_u3_of_motion_3,
                                    u3_of_place * r1__of_u4_from_u3,
                                ) + u4_from_u3_dot_by_u4_from_u3_of_place_2))
                - u3_of_place_3
                    * (u3_plus_u4_from_u3
                        .mul_add(S::int(14), u4_from_u3_dot_by_u4_from_u3_of_place_2)
                        + u3_by_u4_from_u3_doubled * u4_from_u3_dot_by_u4_from_u3_of_motion_5))
            + u5_from_u3_dot_by_u4_from_u3 * u4_from_u3_dot_by_theta2_from_theta1_of_place_4
            - u3_of_place_10
                * (u3_by_u4_from_u3
                    * (u4_from_u3_dot_by_u4_from_u3_of_u4_from_u3_2
                        - r1__of_u5_from_u3_2) + S::int(7) * u3_plus_u4_from_u3)
            - sin_theta3_from_theta1
                * (r1__of_u4_from_u3_3 + u5_from_u3_dot_by_u4_from_u3 * r1__of_place_17
                    + u3_of_place_2
                        * ((-r1__of_u4_from_u3)
                            .mul_add(
                                u3_by_theta3_from_theta1_of_place,
                                u5_from_u3_dot_by_u4_from_u3 * u3_of_place_3,
                            )
                            - u3_by_u4_from_u3_doubled * u4_from_u3_dot_by_u4_from_u3_of_motion_6)
                    + u3_by_u4_from_u3_doubled * u4_from_u3_dot_by_u4_from_u3_of_motion_7));
    // u3_by_u5_from_u3 = -(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3_by_u5_from_u3 = -u3_of_place_7 * u3_of_place_12;
    // 1 + u3_by_u5_from_u3
    let r1__by_u5_from_u3_of_place = S::int(1) + u3_by_u5_from_u3;
    let r1__by_u5_from_u3_of_place_2 = u3_of_place_6 * r1__by_u5_from_u3_of_place;
    let r1__by_u5_from_u3_of_place_3 = S::int(13) * u3_by_u5_from_u3;
    let u5_from_u3_u3_of_place_6 = u5_from_u3 * u3_of_place_6;
    let u3_by_u5_from_u3_doubled = S::int(2) * u3_by_u5_from_u3;
    // 1 + u3_by_u5_from_u3_doubled
    let r1__by_u5_from_u3_of_place_4 = S::int(1) + u3_by_u5_from_u3_doubled;
    let r1__by_u5_from_u3_of_u5_from_u3 = u5_from_u3 * r1__of_place_11;
    // r1__by_u5_from_u3 =
    //   m_l_squared_by_12*(2*cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(3*u5_from_u3 +
    //   2*cos(theta3_from_theta1)*(u5_from_u3 + 3*u5_from_u3*cos(theta2_from_theta1))) +
    //   2*sin(theta3_from_theta1)*(4*u5_from_u3 - 3*cos(theta2_from_theta1)*(u5_from_u3 +
    //   3*u5_from_u3*cos(theta2_from_theta1)))) - 6*sin(theta2_from_theta1)*(u5_from_u3 +
    //   3*u5_from_u3*cos(theta2_from_theta1)) - 6*sin(theta3_from_theta1)*(u5_from_u3 +
    //   3*u5_from_u3*cos(theta2_from_theta1)) +
    //   u3_by_u5_from_u3*(cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(u3*(13 +
    //   6*cos(theta2_from_theta1)) + 6*u4_from_u3*(3 + cos(theta2_from_theta1)) + 6*u5_from_u3 +
    //   2*cos(theta3_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(8*u3 + 9*u4_from_u3 + 8*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(2*u3 + u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3)))) - sin(theta3_from_theta1)*(13*u3 + 18*u4_from_u3 + 6*u5_from_u3 +
    //   3*cos(theta2_from_theta1)*(3*u3*(5 + 2*cos(theta2_from_theta1)) + 2*u4_from_u3*(10 +
    //   3*cos(theta2_from_theta1)) + 6*u5_from_u3)) - 6*sin(theta2_from_theta1)*(u3 + 3*u4_from_u3 +
    //   u5_from_u3 + 3*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   u3*(cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(6 + u3_by_u5_from_u3*(13 +
    //   6*cos(theta2_from_theta1)) + 4*cos(theta3_from_theta1)*(1 + u3_by_u5_from_u3 +
    //   3*cos(theta2_from_theta1)*(1 + u3_by_u5_from_u3))) + 4*sin(theta3_from_theta1)*(4 +
    //   4*u3_by_u5_from_u3 - 3*cos(theta2_from_theta1)*(1 + u3_by_u5_from_u3 + 3*cos(theta2_from_theta1)*(1
    //   + u3_by_u5_from_u3)))) - 6*sin(theta2_from_theta1)*(1 + u3_by_u5_from_u3 +
    //   3*cos(theta2_from_theta1)*(1 + u3_by_u5_from_u3)) - sin(theta3_from_theta1)*(6 + 13*u3_by_u5_from_u3
    //   + 9*cos(theta2_from_theta1)*(2 + u3_by_u5_from_u3*(5 + 2*cos(theta2_from_theta1))))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   m_l_squared_by_12*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(6*cos(theta2_from_theta1)*(sin(theta3_from_theta1)*(u5_from_u3*(5 +
    //   cos(theta3_from_theta1)) + 3*cos(theta2_from_theta1)*(u5_from_u3 +
    //   2*u5_from_u3*cos(theta3_from_theta1))) + 3*sin(theta2_from_theta1)*(u5_from_u3 -
    //   cos(theta3_from_theta1)*(u5_from_u3 + 2*u5_from_u3*cos(theta3_from_theta1)))) -
    //   6*sin(theta2_from_theta1)*(u5_from_u3 + u5_from_u3*cos(theta3_from_theta1)*(6 +
    //   cos(theta3_from_theta1))) - 2*sin(theta3_from_theta1)*(7*u5_from_u3 +
    //   9*u5_from_u3*cos(theta3_from_theta1)) -
    //   u3_by_u5_from_u3*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15 +
    //   2*cos(theta3_from_theta1)) + 14*u4_from_u3 + 2*u5_from_u3*(6 + cos(theta3_from_theta1)) +
    //   6*cos(theta2_from_theta1)*(2*u3 + 2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + 2*sin(theta3_from_theta1)*(3*u3 + 3*u4_from_u3 + 3*u5_from_u3 -
    //   cos(theta2_from_theta1)*(u3 + u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 +
    //   u5_from_u3)))) + sin(theta3_from_theta1)*(18*u3 + 18*u4_from_u3 + 14*u5_from_u3 -
    //   3*cos(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 10*u5_from_u3 + 6*cos(theta2_from_theta1)*(2*u3 +
    //   2*u4_from_u3 + u5_from_u3))) + 3*sin(theta2_from_theta1)*(13*u3 + 14*u4_from_u3 + 2*u5_from_u3*(1 -
    //   3*cos(theta2_from_theta1)))) - u3*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(12 +
    //   2*cos(theta3_from_theta1) + u3_by_u5_from_u3*(15 + 2*cos(theta3_from_theta1)) +
    //   6*cos(theta2_from_theta1)*(1 + 2*u3_by_u5_from_u3 + 2*cos(theta3_from_theta1)*(1 +
    //   u3_by_u5_from_u3))) + 2*sin(theta3_from_theta1)*(3 + 3*u3_by_u5_from_u3 - cos(theta2_from_theta1)*(1
    //   + u3_by_u5_from_u3 + 6*cos(theta2_from_theta1)*(1 + u3_by_u5_from_u3)))) +
    //   sin(theta3_from_theta1)*(14 + 18*u3_by_u5_from_u3 - 3*cos(theta2_from_theta1)*(10 +
    //   13*u3_by_u5_from_u3 + 6*cos(theta2_from_theta1)*(1 + 2*u3_by_u5_from_u3))) +
    //   3*sin(theta2_from_theta1)*(2 - 6*cos(theta2_from_theta1) + 13*u3_by_u5_from_u3)))/((13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1)
    //   - 33 - cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))))
    let r1__by_u5_from_u3 = r1__of_place_30
        * (u3
            * (cos_theta3_from_theta1
                * (u3_of_place_3
                    * (u3_by_u5_from_u3.mul_add(r1__of_place, S::int(6))
                        + r1__by_theta2_from_theta1_of_place * r1__by_u5_from_u3_of_place_2)
                    + r1__by_theta3_from_theta1_of_place_2
                        * (-u3_of_place_2)
                            .mul_add(
                                r1__by_u5_from_u3_of_place_2,
                                S::int(4) * r1__by_u5_from_u3_of_place,
                            )) - u3_of_place_10 * r1__by_u5_from_u3_of_place_2
                - sin_theta3_from_theta1
                    * (S::int(6)
                        + u5_from_u3_dot_of_place_3
                            * u3_by_u5_from_u3.mul_add(r1__of_place_5, S::int(2))
                        + r1__by_u5_from_u3_of_place_3)) + u3_by_u5_from_u3 * r1__of_motion_10
            - u5_from_u3_u3_of_place_6 * (u3_of_place_10 + r1__by_u4_from_u3_of_place_5)
            + u3_of_place_9
                * (u3_of_place_3
                    * u3_of_place_9.mul_add(u5_from_u3_u3_of_place_6, u5_from_u3_times_3)
                    + r1__of_place_3
                        * (-u3_of_place_2)
                            .mul_add(u5_from_u3_u3_of_place_6, S::int(4) * u5_from_u3)))
        + r1__by_theta2_from_theta1_of_place_8
            * (u3_of_place_10 * r1__of_u5_from_u3_3.mul_add(cos_theta3_from_theta1, u5_from_u3)
                + u3_by_u5_from_u3 * r1__of_motion_31
                + r1__of_place_3 * u5_from_u3.mul_add(r1__of_place_8, u5_from_u3_times_7)
                + u3
                    * (u3_of_place_3 * (S::int(2) - u3_of_place_8 + r1__by_u5_from_u3_of_place_3)
                        + sin_theta3_from_theta1
                            * (S::int(14) + S::int(18) * u3_by_u5_from_u3
                                - u3_of_place_2
                                    * u3_of_place_8
                                        .mul_add(
                                            r1__by_u5_from_u3_of_place_4,
                                            S::int(10) + r1__by_u5_from_u3_of_place_3,
                                        ))
                        + r1__of_place_22
                            * (r1__of_place_3
                                * (-(r1__by_theta2_from_theta1_of_place_5
                                    * r1__by_u5_from_u3_of_place))
                                    .mul_add(
                                        cos_theta2_from_theta1,
                                        S::int(3) * r1__by_u5_from_u3_of_place,
                                    )
                                + sin_theta2_from_theta1
                                    * (S::int(12) + u3_of_place_9
                                        + u3_by_u5_from_u3 * r1__of_place_21
                                        + u3_of_place_8
                                            * u3_of_place_9
                                                .mul_add(
                                                    r1__by_u5_from_u3_of_place,
                                                    r1__by_u5_from_u3_of_place_4,
                                                ))))
                - u3_of_place_8
                    * (sin_theta3_from_theta1
                        * u3_of_place_2
                            .mul_add(
                                r1__by_u5_from_u3_of_u5_from_u3,
                                u5_from_u3 * r1__of_place_23,
                            )
                        + u3_of_place_3
                            * (-r1__by_u5_from_u3_of_u5_from_u3)
                                .mul_add(cos_theta3_from_theta1, u5_from_u3)));
    // u5_from_u3_dot_by_u5_from_u3 = r1__by_u5_from_u3*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(4*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot_by_u5_from_u3 = r1__by_u5_from_u3 * u5_from_u3_dot_of_place_8;
    let u4_from_u3_dot_by_u5_from_u3_of_place = u5_from_u3_dot_by_u5_from_u3
        * sin_theta3_from_theta1;
    // u3_plus_u5_from_u3 + u3_by_u5_from_u3*u4_from_u3_dot_by_u4_from_u3_of_motion
    let u4_from_u3_dot_by_u5_from_u3_of_motion = u3_by_u5_from_u3
        .mul_add(u4_from_u3_dot_by_u4_from_u3_of_motion, u3_plus_u5_from_u3);
    // u4_from_u3_dot_by_u5_from_u3 = (3*u5_from_u3_dot_by_u5_from_u3*(4 + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta2_from_theta1))) - 6*sin(theta2_from_theta1)*(7*u4_from_u3*u3_by_u5_from_u3 + u5_from_u3*(1
    //   + u3_by_u5_from_u3 - 3*cos(theta2_from_theta1)*(1 + u3_by_u5_from_u3)) + u3*(1 -
    //   3*cos(theta2_from_theta1) + 13*u3_by_u5_from_u3)) +
    //   cos(theta3_from_theta1)*(u5_from_u3_dot_by_u5_from_u3*(7 + 9*cos(theta3_from_theta1)) -
    //   18*sin(theta3_from_theta1)*(u3 + u5_from_u3 + u3_by_u5_from_u3*(2*u3 + u4_from_u3 + u5_from_u3)) +
    //   3*cos(theta2_from_theta1)*(2*sin(theta3_from_theta1)*(u5_from_u3*(1 + u3_by_u5_from_u3) + u3*(1 +
    //   2*u3_by_u5_from_u3) + 6*cos(theta2_from_theta1)*(u3 + u5_from_u3 + u3_by_u5_from_u3*(2*u3 +
    //   u4_from_u3 + u5_from_u3))) - u5_from_u3_dot_by_u5_from_u3*(2 + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1))) - 6*sin(theta2_from_theta1)*(u3*(1 +
    //   2*cos(theta3_from_theta1)) + u5_from_u3*(1 + 2*cos(theta3_from_theta1)) + u3_by_u5_from_u3*(4*u3 +
    //   2*u4_from_u3 + u5_from_u3 + 2*cos(theta3_from_theta1)*(2*u3 + u4_from_u3 + u5_from_u3)) +
    //   u5_from_u3_dot_by_u5_from_u3*sin(theta3_from_theta1))) - 3*sin(theta2_from_theta1)*(2*u3*(6 +
    //   cos(theta3_from_theta1)) + 2*u5_from_u3*(6 + cos(theta3_from_theta1)) + 2*u3_by_u5_from_u3*(u3*(15 +
    //   2*cos(theta3_from_theta1)) + 7*u4_from_u3 + u5_from_u3*(6 + cos(theta3_from_theta1))) +
    //   u5_from_u3_dot_by_u5_from_u3*sin(theta3_from_theta1))) - sin(theta3_from_theta1)*(14*u3 +
    //   14*u5_from_u3 + 2*u3_by_u5_from_u3*(18*u3 + 9*u4_from_u3 + 7*u5_from_u3) +
    //   9*u5_from_u3_dot_by_u5_from_u3*sin(theta2_from_theta1) +
    //   3*cos(theta2_from_theta1)*(3*u5_from_u3_dot_by_u5_from_u3*sin(theta2_from_theta1) - 2*u3*(5 +
    //   3*cos(theta2_from_theta1)) - 2*u5_from_u3*(5 + 3*cos(theta2_from_theta1)) -
    //   2*u3_by_u5_from_u3*(13*u3 + 7*u4_from_u3 + 5*u5_from_u3 + 3*cos(theta2_from_theta1)*(4*u3 +
    //   2*u4_from_u3 + u5_from_u3)))))/(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))
    let u4_from_u3_dot_by_u5_from_u3 = r1__of_place_29_inv
        * (-u3_of_place_10
            * (u3_by_u5_from_u3 * u4_from_u3_times_7
                + u5_from_u3 * r1__of_place_19 * r1__by_u5_from_u3_of_place
                + u3 * (r1__of_place_19 + r1__by_u5_from_u3_of_place_3))
            + u5_from_u3_dot_by_u5_from_u3 * u4_from_u3_dot_by_theta2_from_theta1_of_place_4
            - sin_theta3_from_theta1
                * (S::int(14) * u3_plus_u5_from_u3 + u5_from_u3_dot_by_u5_from_u3 * r1__of_place_17
                    + u4_from_u3_dot_by_u4_from_u3_of_motion_7 * u3_by_u5_from_u3_doubled
                    + u3_of_place_2
                        * (-r1__of_u5_from_u3 * (S::int(5) + u3_of_place_2)
                            + u5_from_u3_dot_by_u5_from_u3 * u3_of_place_3
                            - u4_from_u3_dot_by_u4_from_u3_of_motion_6 * u3_by_u5_from_u3_doubled))
            + cos_theta3_from_theta1
                * (-u3_of_place_3
                    * (u4_from_u3_dot_by_u4_from_u3_of_motion_5
                        .mul_add(
                            u3_by_u5_from_u3_doubled,
                            r1__of_u5_from_u3 * r1__of_place_20,
                        ) + u4_from_u3_dot_by_u5_from_u3_of_place)
                    + u5_from_u3_dot_by_u5_from_u3 * r1__of_place_9
                    - u4_from_u3_dot_by_theta2_from_theta1_of_place
                        * u4_from_u3_dot_by_u5_from_u3_of_motion
                    + u3_of_place_2
                        * (r1__of_place_3
                            * (u3
                                .mul_add(
                                    r1__by_u5_from_u3_of_place_4,
                                    u5_from_u3 * r1__by_u5_from_u3_of_place,
                                ) + u3_of_place_8 * u4_from_u3_dot_by_u5_from_u3_of_motion)
                            - u5_from_u3_dot_by_u5_from_u3 * u4_from_u3_dot_by_u4_from_u3_of_place
                            - u3_of_place_10
                                * (u3_by_u5_from_u3
                                    .mul_add(
                                        u4_from_u3_dot_by_u4_from_u3_of_motion_3,
                                        u3_plus_u5_from_u3 * r1__of_place_11,
                                    ) + u4_from_u3_dot_by_u5_from_u3_of_place))));
    // Entries that are not zero.
    // d(theta2_from_theta1')/d(u4_from_u3) = 1
    let theta2_from_theta1_dot_by_u4_from_u3_value = S::int(1);
    // d(theta3_from_theta1')/d(u5_from_u3) = 1
    let theta3_from_theta1_dot_by_u5_from_u3_value = S::int(1);
    let zero = S::int(0);
    [
        [zero, zero, zero, theta2_from_theta1_dot_by_u4_from_u3_value, zero],
        [zero, zero, zero, zero, theta3_from_theta1_dot_by_u5_from_u3_value],
        [
            u3_by_theta2_from_theta1, u3_by_theta3_from_theta1, zero, u3_by_u4_from_u3,
            u3_by_u5_from_u3,
        ],
        [
            u4_from_u3_dot_by_theta2_from_theta1, u4_from_u3_dot_by_theta3_from_theta1, zero,
            u4_from_u3_dot_by_u4_from_u3, u4_from_u3_dot_by_u5_from_u3,
        ],
        [
            u5_from_u3_dot_by_theta2_from_theta1, u5_from_u3_dot_by_theta3_from_theta1, zero,
            u5_from_u3_dot_by_u4_from_u3, u5_from_u3_dot_by_u5_from_u3,
        ],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 8 operations, 2 sines and cosines.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 3], _u: &[S; 2]) -> [S; 1] {
    let [theta2_from_theta1, theta3_from_theta1, _] = *q;
    // Sines and cosines.
    let (sin_theta2_from_theta1, cos_theta2_from_theta1) = theta2_from_theta1.sin_cos();
    let (sin_theta3_from_theta1, cos_theta3_from_theta1) = theta3_from_theta1.sin_cos();
    // Shared terms.
    // sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))
    let divisor1_of_place = cos_theta2_from_theta1 * (S::int(1) + cos_theta3_from_theta1)
        + sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // Values.
    // divisor1 = 13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))
    let divisor1 = cos_theta3_from_theta1.mul_add(S::int(2), S::int(13))
        + S::int(6) * divisor1_of_place;
    [divisor1]
}

/// The energy, then its derivatives by the state.
///
/// 118 operations, 2 sines and cosines.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [S; 6] {
    let Parameters {
        m, l, p_x, p_y, H_n3_scaled, H_n3_scaled_per_m_per_l_squared,
        ..
    } = *p;
    let [theta2_from_theta1, theta3_from_theta1, _] = *q;
    let [u4_from_u3, u5_from_u3] = *u;
    // Sines and cosines.
    let (sin_theta3_from_theta1, cos_theta3_from_theta1) = theta3_from_theta1.sin_cos();
    let (sin_theta2_from_theta1, cos_theta2_from_theta1) = theta2_from_theta1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // 1 + cos(theta3_from_theta1)
    let u3_of_place = S::int(1) + cos_theta3_from_theta1;
    let u3_of_place_2 = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // u3_of_place*cos(theta2_from_theta1) + u3_of_place_2
    let u3_of_place_3 = u3_of_place.mul_add(cos_theta2_from_theta1, u3_of_place_2);
    // 7 + 3*u3_of_place_3
    let u3_of_place_4 = u3_of_place_3.mul_add(S::int(3), S::int(7));
    // 1 + 3*cos(theta2_from_theta1)
    let u3_of_place_5 = cos_theta2_from_theta1.mul_add(S::int(3), S::int(1));
    // 3 + 3*u3_of_place_2 + u3_of_place_5*cos(theta3_from_theta1)
    let u3_of_place_6 = u3_of_place_2.mul_add(S::int(3), S::int(3))
        + u3_of_place_5 * cos_theta3_from_theta1;
    // u4_from_u3*u3_of_place_4 + u5_from_u3*u3_of_place_6
    let u3_of_motion = u5_from_u3.mul_add(u3_of_place_6, u4_from_u3 * u3_of_place_4);
    // 13 + 2*cos(theta3_from_theta1) + 6*u3_of_place_3
    let u3_of_place_7 = cos_theta3_from_theta1.mul_add(S::int(2), S::int(13))
        + S::int(6) * u3_of_place_3;
    let u3_of_place_7_inv = S::int(1) / u3_of_place_7;
    // u3_of_place_7_inv*(u3_of_motion - H_n3_scaled_per_m_per_l_squared)
    let u3_of_motion_2 = u3_of_place_7_inv * (u3_of_motion - H_n3_scaled_per_m_per_l_squared);
    // u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3 = -u3_of_motion_2;
    // 2*u3_of_motion + u3*u3_of_place_7
    let energy_of_motion = u3.mul_add(u3_of_place_7, S::int(2) * u3_of_motion);
    // cos(theta2_from_theta1)*cos(theta3_from_theta1) + u3_of_place_2
    let energy_of_place = cos_theta2_from_theta1
        .mul_add(cos_theta3_from_theta1, u3_of_place_2);
    let u5_from_u3_times_6 = S::int(6) * u5_from_u3;
    let energy_of_u5_from_u3 = energy_of_place * u5_from_u3_times_6;
    let m_l_sq = m * l * l;
    let m_l_sq_by_24 = S::ratio(1, 24) * m_l_sq;
    let l_inv_h_n3_scaled = H_n3_scaled / l;
    let energy_of_place_2 = u3_of_place_7_inv * l_inv_h_n3_scaled * l_inv_h_n3_scaled;
    // p_x^2 + p_y^2
    let p_x_sq_plus_p_y_sq = p_y.mul_add(p_y, p_x * p_x);
    // energy_of_place_2 + 4*p_x_sq_plus_p_y_sq
    let energy_of_place_3 = p_x_sq_plus_p_y_sq.mul_add(S::int(4), energy_of_place_2);
    let energy_by_theta2_from_theta1_of_place = cos_theta2_from_theta1 * sin_theta3_from_theta1;
    let energy_by_theta2_from_theta1_of_place_2 = sin_theta2_from_theta1 * cos_theta3_from_theta1;
    // energy_by_theta2_from_theta1_of_place_2 - energy_by_theta2_from_theta1_of_place
    let energy_by_theta2_from_theta1_of_place_3 = energy_by_theta2_from_theta1_of_place_2
        - energy_by_theta2_from_theta1_of_place;
    // -energy_by_theta2_from_theta1_of_place_3
    let energy_by_theta2_from_theta1_of_place_4 = -energy_by_theta2_from_theta1_of_place_3;
    // energy_by_theta2_from_theta1_of_place - u3_of_place*sin(theta2_from_theta1)
    let energy_by_theta2_from_theta1_of_place_5 = (-u3_of_place)
        .mul_add(sin_theta2_from_theta1, energy_by_theta2_from_theta1_of_place);
    // u5_from_u3*energy_by_theta2_from_theta1_of_place_4 +
    //   u4_from_u3*energy_by_theta2_from_theta1_of_place_5
    let energy_by_theta2_from_theta1_of_motion = u4_from_u3
        .mul_add(
            energy_by_theta2_from_theta1_of_place_5,
            u5_from_u3 * energy_by_theta2_from_theta1_of_place_4,
        );
    let energy_by_theta2_from_theta1_of_motion_2 = S::int(2) * u3_of_place_7_inv * u3_of_motion_2;
    // u3_of_place_7_inv*energy_by_theta2_from_theta1_of_motion -
    //   energy_by_theta2_from_theta1_of_place_5*energy_by_theta2_from_theta1_of_motion_2
    let energy_by_theta2_from_theta1_of_motion_3 = (-energy_by_theta2_from_theta1_of_place_5)
        .mul_add(
            energy_by_theta2_from_theta1_of_motion_2,
            u3_of_place_7_inv * energy_by_theta2_from_theta1_of_motion,
        );
    let u3_doubled = S::int(2) * u3;
    let energy_by_theta2_from_theta1_of_u4_from_u3 = u4_from_u3
        * energy_by_theta2_from_theta1_of_place_4;
    // u5_from_u3*(u3_of_place_5*sin(theta3_from_theta1) - 3*energy_by_theta2_from_theta1_of_place_2) +
    //   3*energy_by_theta2_from_theta1_of_u4_from_u3
    let energy_by_theta3_from_theta1_of_motion = u5_from_u3
        * (-energy_by_theta2_from_theta1_of_place_2)
            .mul_add(S::int(3), u3_of_place_5 * sin_theta3_from_theta1)
        + S::int(3) * energy_by_theta2_from_theta1_of_u4_from_u3;
    // sin(theta3_from_theta1) - 3*energy_by_theta2_from_theta1_of_place_3
    let energy_by_theta3_from_theta1_of_place = (-energy_by_theta2_from_theta1_of_place_3)
        .mul_add(S::int(3), sin_theta3_from_theta1);
    // u3_of_place_7_inv*energy_by_theta3_from_theta1_of_motion -
    //   energy_by_theta2_from_theta1_of_motion_2*energy_by_theta3_from_theta1_of_place
    let energy_by_theta3_from_theta1_of_motion_2 = (-energy_by_theta2_from_theta1_of_motion_2)
        .mul_add(
            energy_by_theta3_from_theta1_of_place,
            u3_of_place_7_inv * energy_by_theta3_from_theta1_of_motion,
        );
    // u3_of_place_7_inv*energy_of_motion - u3
    let energy_by_u4_from_u3_of_motion = u3_of_place_7_inv
        .mul_add(energy_of_motion, -u3);
    // Values.
    // T + V = m*l^2*(3*u5_from_u3^2 + u3*(u3*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   2*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + 2*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1)))) + u4_from_u3*(7*u4_from_u3 +
    //   6*u5_from_u3*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1))))/24 - H_n3_scaled^2/(24*m*l^2*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))) + (4*p_x^2 + 4*p_y^2 +
    //   H_n3_scaled^2/(l^2*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(24*m)
    let energy = m_l_sq_by_24
        * (S::int(3) * u5_from_u3 * u5_from_u3 + u3 * energy_of_motion
            + u4_from_u3 * u4_from_u3.mul_add(S::int(7), energy_of_u5_from_u3))
        + S::ratio(1, 24) * (energy_of_place_3 - energy_of_place_2) / m;
    // d(T + V)/d(theta2_from_theta1) =
    //   -m*l^2*(2*u4_from_u3*u5_from_u3*(sin(theta2_from_theta1)*cos(theta3_from_theta1) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1)) + (u3*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + 2*u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + 2*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1))))*((u4_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   u5_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + 2*(sin(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)) - cos(theta2_from_theta1)*sin(theta3_from_theta1))*(u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))) - H_n3_scaled_per_m_per_l_squared)/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2) + u3*((13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*((u4_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   u5_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + 2*(sin(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)) - cos(theta2_from_theta1)*sin(theta3_from_theta1))*(u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))) - H_n3_scaled_per_m_per_l_squared)/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2) -
    //   2*u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) - sin(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) - 2*u4_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) -
    //   2*u5_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1))))/8
    let energy_by_theta2_from_theta1 = S::ratio(1, 8) * m_l_sq
        * (S::int(2) * u5_from_u3 * energy_by_theta2_from_theta1_of_u4_from_u3
            - energy_of_motion * energy_by_theta2_from_theta1_of_motion_3
            - u3
                * ((-energy_by_theta2_from_theta1_of_motion)
                    .mul_add(
                        S::int(2),
                        u3_of_place_7 * energy_by_theta2_from_theta1_of_motion_3,
                    ) - energy_by_theta2_from_theta1_of_place_5 * u3_doubled));
    // d(T + V)/d(theta3_from_theta1) = m*l^2*((u3*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1)
    //   + 2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   2*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + 2*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1))))*((3*u4_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1)) + u5_from_u3*(sin(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1)) - 3*sin(theta2_from_theta1)*cos(theta3_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   2*(3*sin(theta2_from_theta1)*cos(theta3_from_theta1) - sin(theta3_from_theta1) -
    //   3*cos(theta2_from_theta1)*sin(theta3_from_theta1))*(u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))) - H_n3_scaled_per_m_per_l_squared)/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2) -
    //   6*u4_from_u3*u5_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1)) - u3*(2*u3*(sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   3*sin(theta2_from_theta1)*cos(theta3_from_theta1)) +
    //   6*u4_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1)) + 2*u5_from_u3*(sin(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1)) - 3*sin(theta2_from_theta1)*cos(theta3_from_theta1)) - (13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*((3*u4_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1)) + u5_from_u3*(sin(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1)) - 3*sin(theta2_from_theta1)*cos(theta3_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   2*(3*sin(theta2_from_theta1)*cos(theta3_from_theta1) - sin(theta3_from_theta1) -
    //   3*cos(theta2_from_theta1)*sin(theta3_from_theta1))*(u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))) - H_n3_scaled_per_m_per_l_squared)/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2)))/24
    let energy_by_theta3_from_theta1 = m_l_sq_by_24
        * (energy_of_motion * energy_by_theta3_from_theta1_of_motion_2
            - u5_from_u3_times_6 * energy_by_theta2_from_theta1_of_u4_from_u3
            + u3
                * ((-energy_by_theta3_from_theta1_of_motion)
                    .mul_add(
                        S::int(2),
                        u3_of_place_7 * energy_by_theta3_from_theta1_of_motion_2,
                    ) - u3_doubled * energy_by_theta3_from_theta1_of_place));
    // d(T + V)/d(u4_from_u3) = m*l^2*(u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + 14*u4_from_u3 +
    //   6*u5_from_u3*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)) - (7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(u3*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   2*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + 2*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))/24
    let energy_by_u4_from_u3 = m_l_sq_by_24
        * (u4_from_u3.mul_add(S::int(14), energy_of_u5_from_u3)
            - u3_of_place_4 * energy_by_u4_from_u3_of_motion);
    // d(T + V)/d(u5_from_u3) = m*l^2*(u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))) +
    //   6*u4_from_u3*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)) + 6*u5_from_u3 - (3 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1)))*(u3*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   2*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + 2*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))/24
    let energy_by_u5_from_u3 = m_l_sq_by_24
        * ((u4_from_u3 * energy_of_place).mul_add(S::int(6), u5_from_u3_times_6)
            - u3_of_place_6 * energy_by_u4_from_u3_of_motion);
    let zero = S::int(0);
    [
        energy, energy_by_theta2_from_theta1, energy_by_theta3_from_theta1, zero,
        energy_by_u4_from_u3, energy_by_u5_from_u3,
    ]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 105 convolutions and 422 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 5]],
    history: &mut [Factors<S, 112>],
) {
    let Parameters { H_n3_scaled_per_m_per_l_squared, m_l_squared_by_12, .. } = *p;
    let [theta2_from_theta1_0, theta3_from_theta1_0, _, u4_from_u3_0, u5_from_u3_0] = series[0];
    // Shared terms.
    let m_l_squared_by_12_inv = S::int(1) / m_l_squared_by_12;
    // Constant in time.
    // weight = -H_n3_scaled_per_m_per_l_squared
    let weight = -H_n3_scaled_per_m_per_l_squared;
    // weight_2 = -3/(4*m_l_squared_by_12)
    let weight_2 = -S::ratio(3, 4) * m_l_squared_by_12_inv;
    // weight_3 = 9/(4*m_l_squared_by_12)
    let weight_3 = S::ratio(9, 4) * m_l_squared_by_12_inv;
    // weight_4 = 1/(2*m_l_squared_by_12)
    let weight_4 = S::ratio(1, 2) * m_l_squared_by_12_inv;
    // weight_5 = 1/(4*m_l_squared_by_12)
    let weight_5 = S::ratio(1, 4) * m_l_squared_by_12_inv;
    // weight_6 = -1/(4*m_l_squared_by_12)
    let weight_6 = -S::ratio(1, 4) * m_l_squared_by_12_inv;
    // Order 0.
    let (sin_theta2_from_theta1_0, cos_theta2_from_theta1_0) = theta2_from_theta1_0
        .sin_cos();
    let (sin_theta3_from_theta1_0, cos_theta3_from_theta1_0) = theta3_from_theta1_0
        .sin_cos();
    let u3_of_place_0 = S::int(1) + cos_theta3_from_theta1_0;
    let u3_of_place_2_0 = cos_theta2_from_theta1_0 * u3_of_place_0;
    let u3_of_place_3_0 = sin_theta2_from_theta1_0 * sin_theta3_from_theta1_0;
    let u3_of_place_4_0 = u3_of_place_2_0
        .mul_add(S::int(3), u3_of_place_3_0.mul_add(S::int(3), S::int(7)));
    let u3_of_place_5_0 = cos_theta2_from_theta1_0.mul_add(S::int(3), S::int(1));
    let u3_of_place_6_0 = cos_theta3_from_theta1_0 * u3_of_place_5_0;
    let u3_of_place_7_0 = u3_of_place_3_0.mul_add(S::int(3), S::int(3)) + u3_of_place_6_0;
    let u3_of_place_8_0 = u3_of_place_2_0
        .mul_add(
            S::int(6),
            u3_of_place_3_0
                .mul_add(
                    S::int(6),
                    cos_theta3_from_theta1_0.mul_add(S::int(2), S::int(13)),
                ),
        );
    let over_u3_of_place_8 = S::int(1) / u3_of_place_8_0;
    let u3_of_u4_from_u3_0 = u3_of_place_4_0 * u4_from_u3_0;
    let u3_of_u5_from_u3_0 = u3_of_place_7_0 * u5_from_u3_0;
    let u3_of_motion_0 = weight + u3_of_u4_from_u3_0 + u3_of_u5_from_u3_0;
    let u3_of_motion_2_0 = u3_of_motion_0 * over_u3_of_place_8;
    let u4_from_u3_sq_0 = u4_from_u3_0 * u4_from_u3_0;
    let u5_from_u3_sq_0 = u5_from_u3_0 * u5_from_u3_0;
    let r1__of_place_0 = cos_theta2_from_theta1_0.mul_add(S::int(2), S::int(5));
    let r1__of_motion_0 = u3_of_motion_2_0 * r1__of_place_0;
    let r1__of_motion_2_0 = u4_from_u3_sq_0 + u5_from_u3_sq_0;
    let r1__of_motion_3_0 = u4_from_u3_0 + u5_from_u3_0 - u3_of_motion_2_0;
    let r1__of_motion_4_0 = cos_theta3_from_theta1_0 * r1__of_motion_3_0;
    let r1__of_motion_5_0 = cos_theta3_from_theta1_0 * r1__of_motion_2_0;
    let r1__of_place_2_0 = u3_of_place_3_0 + u3_of_place_2_0;
    let r1__of_place_3_0 = cos_theta2_from_theta1_0 * r1__of_place_2_0;
    let r1__of_place_4_0 = r1__of_place_3_0
        .mul_add(-S::int(18), cos_theta3_from_theta1_0.mul_add(S::int(9), S::int(14)));
    let r1__of_place_5_0 = cos_theta3_from_theta1_0 * r1__of_place_4_0;
    let r1__of_place_6_0 = cos_theta2_from_theta1_0 * u3_of_place_3_0;
    let r1__of_place_7_0 = r1__of_place_6_0.mul_add(-S::int(18), S::int(33)) + r1__of_place_5_0;
    let over_r1__of_place_7 = S::int(1) / r1__of_place_7_0;
    let r1__of_place_8_0 = cos_theta3_from_theta1_0.mul_add(S::int(2), S::int(1));
    let r1__of_place_9_0 = cos_theta2_from_theta1_0 * r1__of_place_8_0;
    let r1__of_place_10_0 = r1__of_place_9_0
        .mul_add(
            S::int(3),
            u3_of_place_3_0.mul_add(S::int(6), S::int(2) + cos_theta3_from_theta1_0),
        );
    let r1__of_place_11_0 = cos_theta3_from_theta1_0 * r1__of_place_10_0;
    let r1__of_place_12_0 = u3_of_place_3_0
        .mul_add(-S::int(3), cos_theta2_from_theta1_0.mul_add(S::int(3), S::int(3)))
        - r1__of_place_11_0;
    let r1__of_place_13_0 = cos_theta2_from_theta1_0 * r1__of_place_12_0;
    let r1__of_place_14_0 = u3_of_place_3_0
        .mul_add(-S::int(3), cos_theta3_from_theta1_0.mul_add(S::int(9), S::int(7)));
    let r1__of_place_15_0 = cos_theta3_from_theta1_0 * r1__of_place_14_0;
    let r1__of_place_16_0 = r1__of_place_13_0
        .mul_add(
            -S::int(3),
            u3_of_place_3_0.mul_add(S::int(9), -S::int(12)) - r1__of_place_15_0,
        );
    let r1__of_motion_6_0 = u3_of_motion_2_0
        .mul_add(-S::int(2), S::int(2) * u4_from_u3_0 + u5_from_u3_0);
    let r1__of_motion_7_0 = r1__of_motion_4_0
        .mul_add(
            S::int(2),
            u3_of_motion_2_0.mul_add(-S::int(2), S::int(2) * u4_from_u3_0 + u5_from_u3_0),
        );
    let r1__of_motion_8_0 = cos_theta2_from_theta1_0 * r1__of_motion_7_0;
    let r1__of_place_17_0 = cos_theta3_from_theta1_0.mul_add(S::int(2), S::int(15));
    let r1__of_motion_9_0 = u3_of_motion_2_0 * r1__of_place_17_0;
    let r1__of_place_18_0 = S::int(6) + cos_theta3_from_theta1_0;
    let r1__of_u5_from_u3_0 = u5_from_u3_0 * r1__of_place_18_0;
    let r1__of_motion_10_0 = r1__of_motion_8_0
        .mul_add(
            S::int(6),
            r1__of_u5_from_u3_0.mul_add(S::int(2), S::int(14) * u4_from_u3_0) - r1__of_motion_9_0,
        );
    let r1__of_motion_11_0 = sin_theta2_from_theta1_0 * r1__of_motion_10_0;
    let r1__of_motion_12_0 = cos_theta2_from_theta1_0 * r1__of_motion_3_0;
    let r1__of_motion_13_0 = r1__of_motion_12_0
        .mul_add(S::int(6), u5_from_u3_0 - u3_of_motion_2_0);
    let r1__of_motion_14_0 = cos_theta2_from_theta1_0 * r1__of_motion_13_0;
    let r1__of_motion_15_0 = u3_of_motion_2_0
        .mul_add(-S::int(3), u5_from_u3_0.mul_add(S::int(3), S::int(3) * u4_from_u3_0))
        - r1__of_motion_14_0;
    let r1__of_motion_16_0 = sin_theta3_from_theta1_0 * r1__of_motion_15_0;
    let r1__of_motion_17_0 = r1__of_motion_16_0.mul_add(S::int(2), r1__of_motion_11_0);
    let r1__of_motion_18_0 = cos_theta3_from_theta1_0 * r1__of_motion_17_0;
    let r1__of_motion_19_0 = cos_theta2_from_theta1_0 * r1__of_motion_6_0;
    let r1__of_motion_20_0 = r1__of_motion_19_0
        .mul_add(
            S::int(6),
            u3_of_motion_2_0
                .mul_add(
                    -S::int(13),
                    u5_from_u3_0.mul_add(S::int(10), S::int(14) * u4_from_u3_0),
                ),
        );
    let r1__of_motion_21_0 = cos_theta2_from_theta1_0 * r1__of_motion_20_0;
    let r1__of_motion_22_0 = r1__of_motion_21_0
        .mul_add(
            -S::int(3),
            u3_of_motion_2_0
                .mul_add(
                    -S::int(18),
                    u5_from_u3_0.mul_add(S::int(14), S::int(18) * u4_from_u3_0),
                ),
        );
    let r1__of_motion_23_0 = sin_theta3_from_theta1_0 * r1__of_motion_22_0;
    let r1__of_place_19_0 = cos_theta2_from_theta1_0.mul_add(S::int(3), -S::int(1));
    let r1__of_u5_from_u3_2_0 = u5_from_u3_0 * r1__of_place_19_0;
    let r1__of_motion_24_0 = u3_of_motion_2_0
        .mul_add(
            -S::int(13),
            r1__of_u5_from_u3_2_0.mul_add(-S::int(2), S::int(14) * u4_from_u3_0),
        );
    let r1__of_motion_25_0 = sin_theta2_from_theta1_0 * r1__of_motion_24_0;
    let r1__of_motion_26_0 = r1__of_motion_18_0
        .mul_add(S::int(3), S::int(3) * r1__of_motion_25_0 + r1__of_motion_23_0);
    let r1__of_motion_27_0 = u3_of_motion_2_0 * r1__of_motion_26_0;
    let r1__of_motion_28_0 = r1__of_motion_5_0
        .mul_add(S::int(2), S::int(2) * u4_from_u3_sq_0 + u5_from_u3_sq_0);
    let r1__of_motion_29_0 = cos_theta2_from_theta1_0 * r1__of_motion_28_0;
    let r1__of_place_20_0 = S::int(5) + cos_theta3_from_theta1_0;
    let r1__of_u5_from_u3_3_0 = r1__of_place_20_0 * u5_from_u3_sq_0;
    let r1__of_motion_30_0 = r1__of_motion_29_0
        .mul_add(S::int(3), S::int(7) * u4_from_u3_sq_0 + r1__of_u5_from_u3_3_0);
    let r1__of_motion_31_0 = sin_theta3_from_theta1_0 * r1__of_motion_30_0;
    let r1__of_motion_32_0 = cos_theta3_from_theta1_0 * r1__of_motion_28_0;
    let r1__of_motion_33_0 = u5_from_u3_sq_0 - r1__of_motion_32_0;
    let r1__of_motion_34_0 = sin_theta2_from_theta1_0 * r1__of_motion_33_0;
    let r1__of_motion_35_0 = r1__of_motion_34_0.mul_add(S::int(3), r1__of_motion_31_0);
    let r1__of_motion_36_0 = cos_theta2_from_theta1_0 * r1__of_motion_35_0;
    let r1__of_u5_from_u3_4_0 = r1__of_place_18_0 * u5_from_u3_sq_0;
    let r1__of_motion_37_0 = S::int(7) * u4_from_u3_sq_0 + r1__of_u5_from_u3_4_0;
    let r1__of_motion_38_0 = cos_theta3_from_theta1_0 * r1__of_motion_37_0;
    let r1__of_motion_39_0 = S::int(7) * u4_from_u3_sq_0 + u5_from_u3_sq_0 + r1__of_motion_38_0;
    let r1__of_motion_40_0 = sin_theta2_from_theta1_0 * r1__of_motion_39_0;
    let r1__of_motion_41_0 = r1__of_motion_5_0
        .mul_add(
            S::int(9),
            u5_from_u3_sq_0.mul_add(S::int(7), S::int(9) * u4_from_u3_sq_0),
        );
    let r1__of_motion_42_0 = sin_theta3_from_theta1_0 * r1__of_motion_41_0;
    let r1__of_motion_43_0 = r1__of_motion_36_0
        .mul_add(-S::int(3), r1__of_motion_40_0.mul_add(S::int(3), r1__of_motion_42_0))
        - r1__of_motion_27_0;
    let r1__of_motion_44_0 = r1__of_motion_12_0
        .mul_add(
            S::int(6),
            u3_of_motion_2_0
                .mul_add(-S::int(2), u5_from_u3_0.mul_add(S::int(2), u4_from_u3_0)),
        );
    let r1__of_motion_45_0 = cos_theta3_from_theta1_0 * r1__of_motion_44_0;
    let r1__of_place_21_0 = cos_theta2_from_theta1_0.mul_add(S::int(6), S::int(13));
    let r1__of_motion_46_0 = u3_of_motion_2_0 * r1__of_place_21_0;
    let r1__of_place_22_0 = S::int(3) + cos_theta2_from_theta1_0;
    let r1__of_u4_from_u3_0 = u4_from_u3_0 * r1__of_place_22_0;
    let r1__of_motion_47_0 = r1__of_motion_45_0
        .mul_add(
            S::int(2),
            r1__of_u4_from_u3_0.mul_add(S::int(6), S::int(6) * u5_from_u3_0) - r1__of_motion_46_0,
        );
    let r1__of_motion_48_0 = sin_theta2_from_theta1_0 * r1__of_motion_47_0;
    let r1__of_motion_49_0 = cos_theta2_from_theta1_0 * r1__of_motion_44_0;
    let r1__of_motion_50_0 = r1__of_motion_49_0
        .mul_add(
            -S::int(3),
            u3_of_motion_2_0
                .mul_add(
                    -S::int(8),
                    u5_from_u3_0.mul_add(S::int(8), S::int(9) * u4_from_u3_0),
                ),
        );
    let r1__of_motion_51_0 = sin_theta3_from_theta1_0 * r1__of_motion_50_0;
    let r1__of_motion_52_0 = r1__of_motion_51_0
        .mul_add(S::int(2), S::int(3) * r1__of_motion_48_0);
    let r1__of_motion_53_0 = cos_theta3_from_theta1_0 * r1__of_motion_52_0;
    let r1__of_place_23_0 = cos_theta2_from_theta1_0.mul_add(S::int(3), S::int(10));
    let r1__of_u4_from_u3_2_0 = u4_from_u3_0 * r1__of_place_23_0;
    let r1__of_motion_54_0 = r1__of_motion_0
        .mul_add(
            -S::int(3),
            r1__of_u4_from_u3_2_0.mul_add(S::int(2), S::int(6) * u5_from_u3_0),
        );
    let r1__of_motion_55_0 = cos_theta2_from_theta1_0 * r1__of_motion_54_0;
    let r1__of_motion_56_0 = r1__of_motion_55_0
        .mul_add(
            S::int(3),
            u3_of_motion_2_0
                .mul_add(
                    -S::int(13),
                    u5_from_u3_0.mul_add(S::int(6), S::int(18) * u4_from_u3_0),
                ),
        );
    let r1__of_motion_57_0 = sin_theta3_from_theta1_0 * r1__of_motion_56_0;
    let r1__of_motion_58_0 = r1__of_motion_12_0
        .mul_add(S::int(3), S::int(3) * u4_from_u3_0 + u5_from_u3_0 - u3_of_motion_2_0);
    let r1__of_motion_59_0 = sin_theta2_from_theta1_0 * r1__of_motion_58_0;
    let r1__of_motion_60_0 = -S::int(6) * r1__of_motion_59_0 - r1__of_motion_57_0
        + r1__of_motion_53_0;
    let r1__of_motion_61_0 = u3_of_motion_2_0 * r1__of_motion_60_0;
    let r1__of_motion_62_0 = cos_theta2_from_theta1_0 * r1__of_motion_2_0;
    let r1__of_motion_63_0 = r1__of_motion_62_0
        .mul_add(S::int(6), u5_from_u3_sq_0.mul_add(S::int(2), u4_from_u3_sq_0));
    let r1__of_motion_64_0 = cos_theta3_from_theta1_0 * r1__of_motion_63_0;
    let r1__of_u4_from_u3_3_0 = r1__of_place_22_0 * u4_from_u3_sq_0;
    let r1__of_motion_65_0 = r1__of_u4_from_u3_3_0
        .mul_add(S::int(3), S::int(3) * u5_from_u3_sq_0) + r1__of_motion_64_0;
    let r1__of_motion_66_0 = sin_theta2_from_theta1_0 * r1__of_motion_65_0;
    let r1__of_motion_67_0 = cos_theta2_from_theta1_0 * r1__of_motion_63_0;
    let r1__of_motion_68_0 = r1__of_motion_67_0
        .mul_add(
            -S::int(3),
            u5_from_u3_sq_0.mul_add(S::int(8), S::int(9) * u4_from_u3_sq_0),
        );
    let r1__of_motion_69_0 = sin_theta3_from_theta1_0 * r1__of_motion_68_0;
    let r1__of_motion_70_0 = S::int(3) * r1__of_motion_66_0 + r1__of_motion_69_0;
    let r1__of_motion_71_0 = cos_theta3_from_theta1_0 * r1__of_motion_70_0;
    let r1__of_u4_from_u3_4_0 = r1__of_place_23_0 * u4_from_u3_sq_0;
    let r1__of_motion_72_0 = S::int(3) * u5_from_u3_sq_0 + r1__of_u4_from_u3_4_0;
    let r1__of_motion_73_0 = cos_theta2_from_theta1_0 * r1__of_motion_72_0;
    let r1__of_motion_74_0 = S::int(3) * u4_from_u3_sq_0 + u5_from_u3_sq_0 + r1__of_motion_73_0;
    let r1__of_motion_75_0 = sin_theta3_from_theta1_0 * r1__of_motion_74_0;
    let r1__of_motion_76_0 = r1__of_motion_62_0
        .mul_add(S::int(3), S::int(3) * u4_from_u3_sq_0 + u5_from_u3_sq_0);
    let r1__of_motion_77_0 = sin_theta2_from_theta1_0 * r1__of_motion_76_0;
    let r1__of_motion_78_0 = r1__of_motion_75_0
        .mul_add(-S::int(3), -S::int(3) * r1__of_motion_77_0) + r1__of_motion_71_0
        - r1__of_motion_61_0;
    let r1__of_motion_79_0 = r1__of_motion_78_0 * over_u3_of_place_8;
    let r1__of_place_24_0 = r1__of_place_16_0 * over_u3_of_place_8;
    let r1__of_place_25_0 = r1__of_place_24_0 * over_r1__of_place_7;
    let r1__of_motion_80_0 = r1__of_motion_43_0 * r1__of_place_25_0;
    let r1__of_motion_81_0 = r1__of_motion_80_0
        .mul_add(m_l_squared_by_12, m_l_squared_by_12 * r1__of_motion_79_0);
    let u5_from_u3_dot_of_place_0 = cos_theta2_from_theta1_0 * cos_theta3_from_theta1_0;
    let u5_from_u3_dot_of_place_2_0 = u3_of_place_3_0 + u5_from_u3_dot_of_place_0;
    let u5_from_u3_dot_of_place_3_0 = cos_theta2_from_theta1_0 * u5_from_u3_dot_of_place_2_0;
    let u5_from_u3_dot_of_place_4_0 = u5_from_u3_dot_of_place_3_0
        .mul_add(-S::int(9), S::int(5) * cos_theta3_from_theta1_0);
    let u5_from_u3_dot_of_place_5_0 = cos_theta3_from_theta1_0 * u5_from_u3_dot_of_place_4_0;
    let u5_from_u3_dot_of_place_6_0 = S::int(9) + u5_from_u3_dot_of_place_5_0;
    let over_u5_from_u3_dot_of_place_6 = S::int(1) / u5_from_u3_dot_of_place_6_0;
    let u5_from_u3_dot_of_place_7_0 = r1__of_place_7_0 * over_u5_from_u3_dot_of_place_6;
    let u5_from_u3_dot_of_motion_0 = r1__of_motion_81_0 * u5_from_u3_dot_of_place_7_0;
    let u3_plus_u5_from_u3_0 = u5_from_u3_0 - u3_of_motion_2_0;
    let u4_from_u3_dot_of_u5_from_u3_0 = cos_theta3_from_theta1_0 * u3_plus_u5_from_u3_0;
    let u4_from_u3_dot_of_place_0 = S::int(1) + cos_theta2_from_theta1_0;
    let u4_from_u3_dot_of_motion_0 = sin_theta3_from_theta1_0 * u5_from_u3_dot_of_motion_0;
    let u4_from_u3_dot_of_motion_2_0 = u3_of_motion_2_0 * r1__of_motion_3_0;
    let u4_from_u3_dot_of_motion_3_0 = u4_from_u3_dot_of_motion_2_0
        .mul_add(-S::int(2), u4_from_u3_sq_0 + u5_from_u3_sq_0);
    let u4_from_u3_dot_of_motion_4_0 = sin_theta3_from_theta1_0 * u4_from_u3_dot_of_motion_3_0;
    let u4_from_u3_dot_of_motion_5_0 = u3_of_motion_2_0 * u3_plus_u5_from_u3_0;
    let u4_from_u3_dot_of_motion_6_0 = u3_of_motion_2_0
        .mul_add(-S::int(9), u5_from_u3_0.mul_add(S::int(7), S::int(9) * u4_from_u3_0));
    let u4_from_u3_dot_of_motion_7_0 = S::int(2) * u4_from_u3_sq_0 + u5_from_u3_sq_0;
    let u4_from_u3_dot_of_motion_8_0 = sin_theta2_from_theta1_0 * u5_from_u3_dot_of_motion_0;
    let u4_from_u3_dot_of_motion_9_0 = cos_theta2_from_theta1_0 * u4_from_u3_dot_of_motion_7_0;
    let u4_from_u3_dot_of_motion_10_0 = u3_of_motion_2_0 * u4_from_u3_dot_of_motion_6_0;
    let u4_from_u3_dot_of_place_2_0 = cos_theta3_from_theta1_0
        .mul_add(S::int(9), S::int(7));
    let u4_from_u3_dot_of_motion_11_0 = u5_from_u3_dot_of_motion_0 * u4_from_u3_dot_of_place_2_0;
    let u4_from_u3_dot_of_motion_12_0 = u3_of_motion_2_0 * r1__of_motion_20_0;
    let u4_from_u3_dot_of_motion_13_0 = u4_from_u3_dot_of_motion_8_0
        .mul_add(
            weight_2,
            u4_from_u3_dot_of_motion_9_0
                .mul_add(
                    S::int(3),
                    u5_from_u3_sq_0.mul_add(S::int(5), S::int(7) * u4_from_u3_sq_0),
                ) - u4_from_u3_dot_of_motion_12_0,
        );
    let u4_from_u3_dot_of_motion_14_0 = cos_theta2_from_theta1_0 * u4_from_u3_dot_of_motion_13_0;
    let u4_from_u3_dot_of_motion_15_0 = u4_from_u3_dot_of_motion_14_0
        .mul_add(
            -S::int(3),
            u4_from_u3_dot_of_motion_8_0
                .mul_add(
                    weight_3,
                    u4_from_u3_dot_of_motion_10_0
                        .mul_add(
                            -S::int(2),
                            u5_from_u3_sq_0
                                .mul_add(S::int(7), S::int(9) * u4_from_u3_sq_0),
                        ),
                ),
        );
    let u4_from_u3_dot_of_motion_16_0 = sin_theta3_from_theta1_0 * u4_from_u3_dot_of_motion_15_0;
    let u4_from_u3_dot_of_motion_17_0 = u3_of_motion_2_0 * r1__of_motion_24_0;
    let u4_from_u3_dot_of_u5_from_u3_2_0 = r1__of_place_19_0 * u5_from_u3_sq_0;
    let u4_from_u3_dot_of_motion_18_0 = S::int(7) * u4_from_u3_sq_0
        - u4_from_u3_dot_of_u5_from_u3_2_0 - u4_from_u3_dot_of_motion_17_0;
    let u4_from_u3_dot_of_motion_19_0 = sin_theta2_from_theta1_0 * u4_from_u3_dot_of_motion_18_0;
    let u4_from_u3_dot_of_place_3_0 = cos_theta2_from_theta1_0 * u4_from_u3_dot_of_place_0;
    let u4_from_u3_dot_of_place_4_0 = u4_from_u3_dot_of_place_3_0
        .mul_add(S::int(3), S::int(4));
    let u4_from_u3_dot_of_motion_20_0 = u5_from_u3_dot_of_motion_0 * u4_from_u3_dot_of_place_4_0;
    let u4_from_u3_dot_of_motion_21_0 = u3_of_motion_2_0 * r1__of_motion_7_0;
    let u4_from_u3_dot_of_place_5_0 = r1__of_place_9_0
        .mul_add(S::int(3), S::int(2) + cos_theta3_from_theta1_0);
    let u4_from_u3_dot_of_motion_22_0 = cos_theta2_from_theta1_0 * u4_from_u3_dot_of_motion_3_0;
    let u4_from_u3_dot_of_motion_23_0 = u4_from_u3_dot_of_motion_0
        .mul_add(
            weight_4,
            u4_from_u3_dot_of_motion_21_0
                .mul_add(
                    -S::int(2),
                    r1__of_motion_5_0
                        .mul_add(
                            S::int(2),
                            S::int(2) * u4_from_u3_sq_0 + u5_from_u3_sq_0,
                        ),
                ),
        );
    let u4_from_u3_dot_of_motion_24_0 = sin_theta2_from_theta1_0 * u4_from_u3_dot_of_motion_23_0;
    let u4_from_u3_dot_of_motion_25_0 = u4_from_u3_dot_of_motion_22_0
        .mul_add(
            S::int(6),
            u4_from_u3_dot_of_motion_5_0.mul_add(-S::int(2), u5_from_u3_sq_0),
        );
    let u4_from_u3_dot_of_motion_26_0 = sin_theta3_from_theta1_0 * u4_from_u3_dot_of_motion_25_0;
    let u4_from_u3_dot_of_motion_27_0 = u5_from_u3_dot_of_motion_0 * u4_from_u3_dot_of_place_5_0;
    let u4_from_u3_dot_of_motion_28_0 = u4_from_u3_dot_of_motion_24_0
        .mul_add(
            S::int(3),
            u4_from_u3_dot_of_motion_27_0
                .mul_add(weight_5, -u4_from_u3_dot_of_motion_26_0),
        );
    let u4_from_u3_dot_of_motion_29_0 = cos_theta2_from_theta1_0 * u4_from_u3_dot_of_motion_28_0;
    let u4_from_u3_dot_of_motion_30_0 = u4_from_u3_dot_of_u5_from_u3_0
        .mul_add(
            S::int(2),
            u3_of_motion_2_0
                .mul_add(
                    -S::int(15),
                    u5_from_u3_0.mul_add(S::int(12), S::int(14) * u4_from_u3_0),
                ),
        );
    let u4_from_u3_dot_of_motion_31_0 = u3_of_motion_2_0 * u4_from_u3_dot_of_motion_30_0;
    let u4_from_u3_dot_of_motion_32_0 = u4_from_u3_dot_of_motion_0
        .mul_add(
            weight_5,
            S::int(7) * u4_from_u3_sq_0 + r1__of_u5_from_u3_4_0 - u4_from_u3_dot_of_motion_31_0,
        );
    let u4_from_u3_dot_of_motion_33_0 = sin_theta2_from_theta1_0 * u4_from_u3_dot_of_motion_32_0;
    let u4_from_u3_dot_of_motion_34_0 = u4_from_u3_dot_of_motion_29_0
        .mul_add(
            S::int(3),
            u4_from_u3_dot_of_motion_33_0
                .mul_add(
                    S::int(3),
                    u4_from_u3_dot_of_motion_11_0
                        .mul_add(weight_6, S::int(9) * u4_from_u3_dot_of_motion_4_0),
                ),
        );
    let u4_from_u3_dot_of_motion_35_0 = cos_theta3_from_theta1_0 * u4_from_u3_dot_of_motion_34_0;
    let u4_from_u3_dot_of_motion_36_0 = u4_from_u3_dot_of_motion_20_0
        .mul_add(weight_2, S::int(3) * u4_from_u3_dot_of_motion_19_0)
        + u4_from_u3_dot_of_motion_16_0 + u4_from_u3_dot_of_motion_35_0;
    let u4_from_u3_dot_of_motion_37_0 = u4_from_u3_dot_of_motion_36_0 * over_r1__of_place_7;
    // Order 1: the rates, and what follows from them.
    let theta2_from_theta1_1 = u4_from_u3_0;
    let theta3_from_theta1_1 = u5_from_u3_0;
    let theta1_1 = -u3_of_motion_2_0;
    let u4_from_u3_1 = -u4_from_u3_dot_of_motion_37_0;
    let u5_from_u3_1 = weight_5 * u5_from_u3_dot_of_motion_0;
    if series.len() > 1 {
        series[1] = [
            theta2_from_theta1_1, theta3_from_theta1_1, theta1_1, u4_from_u3_1, u5_from_u3_1,
        ];
    }
    let sin_theta2_from_theta1_1 = theta2_from_theta1_1 * cos_theta2_from_theta1_0;
    let cos_theta2_from_theta1_1 = -theta2_from_theta1_1 * sin_theta2_from_theta1_0;
    let sin_theta3_from_theta1_1 = theta3_from_theta1_1 * cos_theta3_from_theta1_0;
    let cos_theta3_from_theta1_1 = -theta3_from_theta1_1 * sin_theta3_from_theta1_0;
    let u3_of_place_1 = cos_theta3_from_theta1_1;
    let u3_of_place_2_1 = u3_of_place_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * u3_of_place_0);
    let u3_of_place_3_1 = sin_theta3_from_theta1_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * sin_theta3_from_theta1_0,
        );
    let u3_of_place_4_1 = u3_of_place_2_1
        .mul_add(S::int(3), S::int(3) * u3_of_place_3_1);
    let u3_of_place_5_1 = S::int(3) * cos_theta2_from_theta1_1;
    let u3_of_place_6_1 = u3_of_place_5_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * u3_of_place_5_0);
    let u3_of_place_7_1 = S::int(3) * u3_of_place_3_1 + u3_of_place_6_1;
    let u3_of_place_8_1 = u3_of_place_2_1
        .mul_add(
            S::int(6),
            u3_of_place_3_1.mul_add(S::int(6), S::int(2) * cos_theta3_from_theta1_1),
        );
    let u3_of_u4_from_u3_1 = u3_of_place_4_1
        .mul_add(u4_from_u3_0, u4_from_u3_1 * u3_of_place_4_0);
    let u3_of_u5_from_u3_1 = u3_of_place_7_1
        .mul_add(u5_from_u3_0, u5_from_u3_1 * u3_of_place_7_0);
    let u3_of_motion_1 = u3_of_u4_from_u3_1 + u3_of_u5_from_u3_1;
    let u3_of_motion_2_1 = u3_of_place_8_1
        .mul_add(
            -(u3_of_motion_2_0 * over_u3_of_place_8),
            u3_of_motion_1 * over_u3_of_place_8,
        );
    let u4_from_u3_sq_1 = u4_from_u3_1 * (u4_from_u3_0 + u4_from_u3_0);
    let u5_from_u3_sq_1 = u5_from_u3_1 * (u5_from_u3_0 + u5_from_u3_0);
    let r1__of_place_1 = S::int(2) * cos_theta2_from_theta1_1;
    let r1__of_motion_1 = u3_of_motion_2_1
        .mul_add(r1__of_place_0, r1__of_place_1 * u3_of_motion_2_0);
    let r1__of_motion_2_1 = u4_from_u3_sq_1 + u5_from_u3_sq_1;
    let r1__of_motion_3_1 = u4_from_u3_1 + u5_from_u3_1 - u3_of_motion_2_1;
    let r1__of_motion_4_1 = r1__of_motion_3_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__of_motion_3_0);
    let r1__of_motion_5_1 = r1__of_motion_2_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__of_motion_2_0);
    let r1__of_place_2_1 = u3_of_place_3_1 + u3_of_place_2_1;
    let r1__of_place_3_1 = r1__of_place_2_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__of_place_2_0);
    let r1__of_place_4_1 = r1__of_place_3_1
        .mul_add(-S::int(18), S::int(9) * cos_theta3_from_theta1_1);
    let r1__of_place_5_1 = r1__of_place_4_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__of_place_4_0);
    let r1__of_place_6_1 = u3_of_place_3_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * u3_of_place_3_0);
    let r1__of_place_7_1 = -S::int(18) * r1__of_place_6_1 + r1__of_place_5_1;
    let r1__of_place_8_1 = S::int(2) * cos_theta3_from_theta1_1;
    let r1__of_place_9_1 = r1__of_place_8_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__of_place_8_0);
    let r1__of_place_10_1 = r1__of_place_9_1
        .mul_add(
            S::int(3),
            u3_of_place_3_1.mul_add(S::int(6), cos_theta3_from_theta1_1),
        );
    let r1__of_place_11_1 = r1__of_place_10_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__of_place_10_0);
    let r1__of_place_12_1 = u3_of_place_3_1
        .mul_add(-S::int(3), S::int(3) * cos_theta2_from_theta1_1) - r1__of_place_11_1;
    let r1__of_place_13_1 = r1__of_place_12_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__of_place_12_0);
    let r1__of_place_14_1 = u3_of_place_3_1
        .mul_add(-S::int(3), S::int(9) * cos_theta3_from_theta1_1);
    let r1__of_place_15_1 = r1__of_place_14_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__of_place_14_0);
    let r1__of_place_16_1 = r1__of_place_13_1
        .mul_add(-S::int(3), S::int(9) * u3_of_place_3_1 - r1__of_place_15_1);
    let r1__of_motion_6_1 = u3_of_motion_2_1
        .mul_add(-S::int(2), S::int(2) * u4_from_u3_1 + u5_from_u3_1);
    let r1__of_motion_7_1 = r1__of_motion_4_1
        .mul_add(
            S::int(2),
            u3_of_motion_2_1.mul_add(-S::int(2), S::int(2) * u4_from_u3_1 + u5_from_u3_1),
        );
    let r1__of_motion_8_1 = r1__of_motion_7_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__of_motion_7_0);
    let r1__of_place_17_1 = S::int(2) * cos_theta3_from_theta1_1;
    let r1__of_motion_9_1 = u3_of_motion_2_1
        .mul_add(r1__of_place_17_0, r1__of_place_17_1 * u3_of_motion_2_0);
    let r1__of_place_18_1 = cos_theta3_from_theta1_1;
    let r1__of_u5_from_u3_1 = r1__of_place_18_1
        .mul_add(u5_from_u3_0, u5_from_u3_1 * r1__of_place_18_0);
    let r1__of_motion_10_1 = r1__of_motion_8_1
        .mul_add(
            S::int(6),
            r1__of_u5_from_u3_1.mul_add(S::int(2), S::int(14) * u4_from_u3_1) - r1__of_motion_9_1,
        );
    let r1__of_motion_11_1 = r1__of_motion_10_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * r1__of_motion_10_0,
        );
    let r1__of_motion_12_1 = r1__of_motion_3_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__of_motion_3_0);
    let r1__of_motion_13_1 = r1__of_motion_12_1
        .mul_add(S::int(6), u5_from_u3_1 - u3_of_motion_2_1);
    let r1__of_motion_14_1 = r1__of_motion_13_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * r1__of_motion_13_0,
        );
    let r1__of_motion_15_1 = u3_of_motion_2_1
        .mul_add(-S::int(3), u5_from_u3_1.mul_add(S::int(3), S::int(3) * u4_from_u3_1))
        - r1__of_motion_14_1;
    let r1__of_motion_16_1 = r1__of_motion_15_1
        .mul_add(
            sin_theta3_from_theta1_0,
            sin_theta3_from_theta1_1 * r1__of_motion_15_0,
        );
    let r1__of_motion_17_1 = r1__of_motion_16_1.mul_add(S::int(2), r1__of_motion_11_1);
    let r1__of_motion_18_1 = r1__of_motion_17_1
        .mul_add(
            cos_theta3_from_theta1_0,
            cos_theta3_from_theta1_1 * r1__of_motion_17_0,
        );
    let r1__of_motion_19_1 = r1__of_motion_6_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__of_motion_6_0);
    let r1__of_motion_20_1 = r1__of_motion_19_1
        .mul_add(
            S::int(6),
            u3_of_motion_2_1
                .mul_add(
                    -S::int(13),
                    u5_from_u3_1.mul_add(S::int(10), S::int(14) * u4_from_u3_1),
                ),
        );
    let r1__of_motion_21_1 = r1__of_motion_20_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * r1__of_motion_20_0,
        );
    let r1__of_motion_22_1 = r1__of_motion_21_1
        .mul_add(
            -S::int(3),
            u3_of_motion_2_1
                .mul_add(
                    -S::int(18),
                    u5_from_u3_1.mul_add(S::int(14), S::int(18) * u4_from_u3_1),
                ),
        );
    let r1__of_motion_23_1 = r1__of_motion_22_1
        .mul_add(
            sin_theta3_from_theta1_0,
            sin_theta3_from_theta1_1 * r1__of_motion_22_0,
        );
    let r1__of_place_19_1 = S::int(3) * cos_theta2_from_theta1_1;
    let r1__of_u5_from_u3_2_1 = r1__of_place_19_1
        .mul_add(u5_from_u3_0, u5_from_u3_1 * r1__of_place_19_0);
    let r1__of_motion_24_1 = u3_of_motion_2_1
        .mul_add(
            -S::int(13),
            r1__of_u5_from_u3_2_1.mul_add(-S::int(2), S::int(14) * u4_from_u3_1),
        );
    let r1__of_motion_25_1 = r1__of_motion_24_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * r1__of_motion_24_0,
        );
    let r1__of_motion_26_1 = r1__of_motion_18_1
        .mul_add(S::int(3), S::int(3) * r1__of_motion_25_1 + r1__of_motion_23_1);
    let r1__of_motion_27_1 = r1__of_motion_26_1
        .mul_add(u3_of_motion_2_0, u3_of_motion_2_1 * r1__of_motion_26_0);
    let r1__of_motion_28_1 = r1__of_motion_5_1
        .mul_add(S::int(2), S::int(2) * u4_from_u3_sq_1 + u5_from_u3_sq_1);
    let r1__of_motion_29_1 = r1__of_motion_28_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * r1__of_motion_28_0,
        );
    let r1__of_place_20_1 = cos_theta3_from_theta1_1;
    let r1__of_u5_from_u3_3_1 = r1__of_place_20_1
        .mul_add(u5_from_u3_sq_0, u5_from_u3_sq_1 * r1__of_place_20_0);
    let r1__of_motion_30_1 = r1__of_motion_29_1
        .mul_add(S::int(3), S::int(7) * u4_from_u3_sq_1 + r1__of_u5_from_u3_3_1);
    let r1__of_motion_31_1 = r1__of_motion_30_1
        .mul_add(
            sin_theta3_from_theta1_0,
            sin_theta3_from_theta1_1 * r1__of_motion_30_0,
        );
    let r1__of_motion_32_1 = r1__of_motion_28_1
        .mul_add(
            cos_theta3_from_theta1_0,
            cos_theta3_from_theta1_1 * r1__of_motion_28_0,
        );
    let r1__of_motion_33_1 = u5_from_u3_sq_1 - r1__of_motion_32_1;
    let r1__of_motion_34_1 = r1__of_motion_33_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * r1__of_motion_33_0,
        );
    let r1__of_motion_35_1 = r1__of_motion_34_1.mul_add(S::int(3), r1__of_motion_31_1);
    let r1__of_motion_36_1 = r1__of_motion_35_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * r1__of_motion_35_0,
        );
    let r1__of_u5_from_u3_4_1 = r1__of_place_18_1
        .mul_add(u5_from_u3_sq_0, u5_from_u3_sq_1 * r1__of_place_18_0);
    let r1__of_motion_37_1 = S::int(7) * u4_from_u3_sq_1 + r1__of_u5_from_u3_4_1;
    let r1__of_motion_38_1 = r1__of_motion_37_1
        .mul_add(
            cos_theta3_from_theta1_0,
            cos_theta3_from_theta1_1 * r1__of_motion_37_0,
        );
    let r1__of_motion_39_1 = S::int(7) * u4_from_u3_sq_1 + u5_from_u3_sq_1 + r1__of_motion_38_1;
    let r1__of_motion_40_1 = r1__of_motion_39_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * r1__of_motion_39_0,
        );
    let r1__of_motion_41_1 = r1__of_motion_5_1
        .mul_add(
            S::int(9),
            u5_from_u3_sq_1.mul_add(S::int(7), S::int(9) * u4_from_u3_sq_1),
        );
    let r1__of_motion_42_1 = r1__of_motion_41_1
        .mul_add(
            sin_theta3_from_theta1_0,
            sin_theta3_from_theta1_1 * r1__of_motion_41_0,
        );
    let r1__of_motion_43_1 = r1__of_motion_36_1
        .mul_add(-S::int(3), r1__of_motion_40_1.mul_add(S::int(3), r1__of_motion_42_1))
        - r1__of_motion_27_1;
    let r1__of_motion_44_1 = r1__of_motion_12_1
        .mul_add(
            S::int(6),
            u3_of_motion_2_1
                .mul_add(-S::int(2), u5_from_u3_1.mul_add(S::int(2), u4_from_u3_1)),
        );
    let r1__of_motion_45_1 = r1__of_motion_44_1
        .mul_add(
            cos_theta3_from_theta1_0,
            cos_theta3_from_theta1_1 * r1__of_motion_44_0,
        );
    let r1__of_place_21_1 = S::int(6) * cos_theta2_from_theta1_1;
    let r1__of_motion_46_1 = u3_of_motion_2_1
        .mul_add(r1__of_place_21_0, r1__of_place_21_1 * u3_of_motion_2_0);
    let r1__of_place_22_1 = cos_theta2_from_theta1_1;
    let r1__of_u4_from_u3_1 = r1__of_place_22_1
        .mul_add(u4_from_u3_0, u4_from_u3_1 * r1__of_place_22_0);
    let r1__of_motion_47_1 = r1__of_motion_45_1
        .mul_add(
            S::int(2),
            r1__of_u4_from_u3_1.mul_add(S::int(6), S::int(6) * u5_from_u3_1) - r1__of_motion_46_1,
        );
    let r1__of_motion_48_1 = r1__of_motion_47_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * r1__of_motion_47_0,
        );
    let r1__of_motion_49_1 = r1__of_motion_44_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * r1__of_motion_44_0,
        );
    let r1__of_motion_50_1 = r1__of_motion_49_1
        .mul_add(
            -S::int(3),
            u3_of_motion_2_1
                .mul_add(
                    -S::int(8),
                    u5_from_u3_1.mul_add(S::int(8), S::int(9) * u4_from_u3_1),
                ),
        );
    let r1__of_motion_51_1 = r1__of_motion_50_1
        .mul_add(
            sin_theta3_from_theta1_0,
            sin_theta3_from_theta1_1 * r1__of_motion_50_0,
        );
    let r1__of_motion_52_1 = r1__of_motion_51_1
        .mul_add(S::int(2), S::int(3) * r1__of_motion_48_1);
    let r1__of_motion_53_1 = r1__of_motion_52_1
        .mul_add(
            cos_theta3_from_theta1_0,
            cos_theta3_from_theta1_1 * r1__of_motion_52_0,
        );
    let r1__of_place_23_1 = S::int(3) * cos_theta2_from_theta1_1;
    let r1__of_u4_from_u3_2_1 = r1__of_place_23_1
        .mul_add(u4_from_u3_0, u4_from_u3_1 * r1__of_place_23_0);
    let r1__of_motion_54_1 = r1__of_motion_1
        .mul_add(
            -S::int(3),
            r1__of_u4_from_u3_2_1.mul_add(S::int(2), S::int(6) * u5_from_u3_1),
        );
    let r1__of_motion_55_1 = r1__of_motion_54_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * r1__of_motion_54_0,
        );
    let r1__of_motion_56_1 = r1__of_motion_55_1
        .mul_add(
            S::int(3),
            u3_of_motion_2_1
                .mul_add(
                    -S::int(13),
                    u5_from_u3_1.mul_add(S::int(6), S::int(18) * u4_from_u3_1),
                ),
        );
    let r1__of_motion_57_1 = r1__of_motion_56_1
        .mul_add(
            sin_theta3_from_theta1_0,
            sin_theta3_from_theta1_1 * r1__of_motion_56_0,
        );
    let r1__of_motion_58_1 = r1__of_motion_12_1
        .mul_add(S::int(3), S::int(3) * u4_from_u3_1 + u5_from_u3_1 - u3_of_motion_2_1);
    let r1__of_motion_59_1 = r1__of_motion_58_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * r1__of_motion_58_0,
        );
    let r1__of_motion_60_1 = -S::int(6) * r1__of_motion_59_1 - r1__of_motion_57_1
        + r1__of_motion_53_1;
    let r1__of_motion_61_1 = r1__of_motion_60_1
        .mul_add(u3_of_motion_2_0, u3_of_motion_2_1 * r1__of_motion_60_0);
    let r1__of_motion_62_1 = r1__of_motion_2_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__of_motion_2_0);
    let r1__of_motion_63_1 = r1__of_motion_62_1
        .mul_add(S::int(6), u5_from_u3_sq_1.mul_add(S::int(2), u4_from_u3_sq_1));
    let r1__of_motion_64_1 = r1__of_motion_63_1
        .mul_add(
            cos_theta3_from_theta1_0,
            cos_theta3_from_theta1_1 * r1__of_motion_63_0,
        );
    let r1__of_u4_from_u3_3_1 = r1__of_place_22_1
        .mul_add(u4_from_u3_sq_0, u4_from_u3_sq_1 * r1__of_place_22_0);
    let r1__of_motion_65_1 = r1__of_u4_from_u3_3_1
        .mul_add(S::int(3), S::int(3) * u5_from_u3_sq_1) + r1__of_motion_64_1;
    let r1__of_motion_66_1 = r1__of_motion_65_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * r1__of_motion_65_0,
        );
    let r1__of_motion_67_1 = r1__of_motion_63_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * r1__of_motion_63_0,
        );
    let r1__of_motion_68_1 = r1__of_motion_67_1
        .mul_add(
            -S::int(3),
            u5_from_u3_sq_1.mul_add(S::int(8), S::int(9) * u4_from_u3_sq_1),
        );
    let r1__of_motion_69_1 = r1__of_motion_68_1
        .mul_add(
            sin_theta3_from_theta1_0,
            sin_theta3_from_theta1_1 * r1__of_motion_68_0,
        );
    let r1__of_motion_70_1 = S::int(3) * r1__of_motion_66_1 + r1__of_motion_69_1;
    let r1__of_motion_71_1 = r1__of_motion_70_1
        .mul_add(
            cos_theta3_from_theta1_0,
            cos_theta3_from_theta1_1 * r1__of_motion_70_0,
        );
    let r1__of_u4_from_u3_4_1 = r1__of_place_23_1
        .mul_add(u4_from_u3_sq_0, u4_from_u3_sq_1 * r1__of_place_23_0);
    let r1__of_motion_72_1 = S::int(3) * u5_from_u3_sq_1 + r1__of_u4_from_u3_4_1;
    let r1__of_motion_73_1 = r1__of_motion_72_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * r1__of_motion_72_0,
        );
    let r1__of_motion_74_1 = S::int(3) * u4_from_u3_sq_1 + u5_from_u3_sq_1 + r1__of_motion_73_1;
    let r1__of_motion_75_1 = r1__of_motion_74_1
        .mul_add(
            sin_theta3_from_theta1_0,
            sin_theta3_from_theta1_1 * r1__of_motion_74_0,
        );
    let r1__of_motion_76_1 = r1__of_motion_62_1
        .mul_add(S::int(3), S::int(3) * u4_from_u3_sq_1 + u5_from_u3_sq_1);
    let r1__of_motion_77_1 = r1__of_motion_76_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * r1__of_motion_76_0,
        );
    let r1__of_motion_78_1 = r1__of_motion_75_1
        .mul_add(-S::int(3), -S::int(3) * r1__of_motion_77_1) + r1__of_motion_71_1
        - r1__of_motion_61_1;
    let r1__of_motion_79_1 = u3_of_place_8_1
        .mul_add(
            -(r1__of_motion_79_0 * over_u3_of_place_8),
            r1__of_motion_78_1 * over_u3_of_place_8,
        );
    let r1__of_place_24_1 = u3_of_place_8_1
        .mul_add(
            -(r1__of_place_24_0 * over_u3_of_place_8),
            r1__of_place_16_1 * over_u3_of_place_8,
        );
    let r1__of_place_25_1 = r1__of_place_7_1
        .mul_add(
            -(r1__of_place_25_0 * over_r1__of_place_7),
            r1__of_place_24_1 * over_r1__of_place_7,
        );
    let r1__of_motion_80_1 = r1__of_motion_43_1
        .mul_add(r1__of_place_25_0, r1__of_place_25_1 * r1__of_motion_43_0);
    let r1__of_motion_81_1 = r1__of_motion_80_1
        .mul_add(m_l_squared_by_12, m_l_squared_by_12 * r1__of_motion_79_1);
    let u5_from_u3_dot_of_place_1 = cos_theta3_from_theta1_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * cos_theta3_from_theta1_0,
        );
    let u5_from_u3_dot_of_place_2_1 = u3_of_place_3_1 + u5_from_u3_dot_of_place_1;
    let u5_from_u3_dot_of_place_3_1 = u5_from_u3_dot_of_place_2_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * u5_from_u3_dot_of_place_2_0,
        );
    let u5_from_u3_dot_of_place_4_1 = u5_from_u3_dot_of_place_3_1
        .mul_add(-S::int(9), S::int(5) * cos_theta3_from_theta1_1);
    let u5_from_u3_dot_of_place_5_1 = u5_from_u3_dot_of_place_4_1
        .mul_add(
            cos_theta3_from_theta1_0,
            cos_theta3_from_theta1_1 * u5_from_u3_dot_of_place_4_0,
        );
    let u5_from_u3_dot_of_place_6_1 = u5_from_u3_dot_of_place_5_1;
    let u5_from_u3_dot_of_place_7_1 = u5_from_u3_dot_of_place_6_1
        .mul_add(
            -(u5_from_u3_dot_of_place_7_0 * over_u5_from_u3_dot_of_place_6),
            r1__of_place_7_1 * over_u5_from_u3_dot_of_place_6,
        );
    let u5_from_u3_dot_of_motion_1 = r1__of_motion_81_1
        .mul_add(
            u5_from_u3_dot_of_place_7_0,
            u5_from_u3_dot_of_place_7_1 * r1__of_motion_81_0,
        );
    let u3_plus_u5_from_u3_1 = u5_from_u3_1 - u3_of_motion_2_1;
    let u4_from_u3_dot_of_u5_from_u3_1 = u3_plus_u5_from_u3_1
        .mul_add(
            cos_theta3_from_theta1_0,
            cos_theta3_from_theta1_1 * u3_plus_u5_from_u3_0,
        );
    let u4_from_u3_dot_of_place_1 = cos_theta2_from_theta1_1;
    let u4_from_u3_dot_of_motion_1 = u5_from_u3_dot_of_motion_1
        .mul_add(
            sin_theta3_from_theta1_0,
            sin_theta3_from_theta1_1 * u5_from_u3_dot_of_motion_0,
        );
    let u4_from_u3_dot_of_motion_2_1 = r1__of_motion_3_1
        .mul_add(u3_of_motion_2_0, u3_of_motion_2_1 * r1__of_motion_3_0);
    let u4_from_u3_dot_of_motion_3_1 = u4_from_u3_dot_of_motion_2_1
        .mul_add(-S::int(2), u4_from_u3_sq_1 + u5_from_u3_sq_1);
    let u4_from_u3_dot_of_motion_4_1 = u4_from_u3_dot_of_motion_3_1
        .mul_add(
            sin_theta3_from_theta1_0,
            sin_theta3_from_theta1_1 * u4_from_u3_dot_of_motion_3_0,
        );
    let u4_from_u3_dot_of_motion_5_1 = u3_plus_u5_from_u3_1
        .mul_add(u3_of_motion_2_0, u3_of_motion_2_1 * u3_plus_u5_from_u3_0);
    let u4_from_u3_dot_of_motion_6_1 = u3_of_motion_2_1
        .mul_add(-S::int(9), u5_from_u3_1.mul_add(S::int(7), S::int(9) * u4_from_u3_1));
    let u4_from_u3_dot_of_motion_7_1 = S::int(2) * u4_from_u3_sq_1 + u5_from_u3_sq_1;
    let u4_from_u3_dot_of_motion_8_1 = u5_from_u3_dot_of_motion_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * u5_from_u3_dot_of_motion_0,
        );
    let u4_from_u3_dot_of_motion_9_1 = u4_from_u3_dot_of_motion_7_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * u4_from_u3_dot_of_motion_7_0,
        );
    let u4_from_u3_dot_of_motion_10_1 = u4_from_u3_dot_of_motion_6_1
        .mul_add(u3_of_motion_2_0, u3_of_motion_2_1 * u4_from_u3_dot_of_motion_6_0);
    let u4_from_u3_dot_of_place_2_1 = S::int(9) * cos_theta3_from_theta1_1;
    let u4_from_u3_dot_of_motion_11_1 = u5_from_u3_dot_of_motion_1
        .mul_add(
            u4_from_u3_dot_of_place_2_0,
            u4_from_u3_dot_of_place_2_1 * u5_from_u3_dot_of_motion_0,
        );
    let u4_from_u3_dot_of_motion_12_1 = r1__of_motion_20_1
        .mul_add(u3_of_motion_2_0, u3_of_motion_2_1 * r1__of_motion_20_0);
    let u4_from_u3_dot_of_motion_13_1 = u4_from_u3_dot_of_motion_8_1
        .mul_add(
            weight_2,
            u4_from_u3_dot_of_motion_9_1
                .mul_add(
                    S::int(3),
                    u5_from_u3_sq_1.mul_add(S::int(5), S::int(7) * u4_from_u3_sq_1),
                ) - u4_from_u3_dot_of_motion_12_1,
        );
    let u4_from_u3_dot_of_motion_14_1 = u4_from_u3_dot_of_motion_13_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * u4_from_u3_dot_of_motion_13_0,
        );
    let u4_from_u3_dot_of_motion_15_1 = u4_from_u3_dot_of_motion_14_1
        .mul_add(
            -S::int(3),
            u4_from_u3_dot_of_motion_8_1
                .mul_add(
                    weight_3,
                    u4_from_u3_dot_of_motion_10_1
                        .mul_add(
                            -S::int(2),
                            u5_from_u3_sq_1
                                .mul_add(S::int(7), S::int(9) * u4_from_u3_sq_1),
                        ),
                ),
        );
    let u4_from_u3_dot_of_motion_16_1 = u4_from_u3_dot_of_motion_15_1
        .mul_add(
            sin_theta3_from_theta1_0,
            sin_theta3_from_theta1_1 * u4_from_u3_dot_of_motion_15_0,
        );
    let u4_from_u3_dot_of_motion_17_1 = r1__of_motion_24_1
        .mul_add(u3_of_motion_2_0, u3_of_motion_2_1 * r1__of_motion_24_0);
    let u4_from_u3_dot_of_u5_from_u3_2_1 = r1__of_place_19_1
        .mul_add(u5_from_u3_sq_0, u5_from_u3_sq_1 * r1__of_place_19_0);
    let u4_from_u3_dot_of_motion_18_1 = S::int(7) * u4_from_u3_sq_1
        - u4_from_u3_dot_of_u5_from_u3_2_1 - u4_from_u3_dot_of_motion_17_1;
    let u4_from_u3_dot_of_motion_19_1 = u4_from_u3_dot_of_motion_18_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * u4_from_u3_dot_of_motion_18_0,
        );
    let u4_from_u3_dot_of_place_3_1 = u4_from_u3_dot_of_place_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * u4_from_u3_dot_of_place_0,
        );
    let u4_from_u3_dot_of_place_4_1 = S::int(3) * u4_from_u3_dot_of_place_3_1;
    let u4_from_u3_dot_of_motion_20_1 = u5_from_u3_dot_of_motion_1
        .mul_add(
            u4_from_u3_dot_of_place_4_0,
            u4_from_u3_dot_of_place_4_1 * u5_from_u3_dot_of_motion_0,
        );
    let u4_from_u3_dot_of_motion_21_1 = r1__of_motion_7_1
        .mul_add(u3_of_motion_2_0, u3_of_motion_2_1 * r1__of_motion_7_0);
    let u4_from_u3_dot_of_place_5_1 = r1__of_place_9_1
        .mul_add(S::int(3), cos_theta3_from_theta1_1);
    let u4_from_u3_dot_of_motion_22_1 = u4_from_u3_dot_of_motion_3_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * u4_from_u3_dot_of_motion_3_0,
        );
    let u4_from_u3_dot_of_motion_23_1 = u4_from_u3_dot_of_motion_1
        .mul_add(
            weight_4,
            u4_from_u3_dot_of_motion_21_1
                .mul_add(
                    -S::int(2),
                    r1__of_motion_5_1
                        .mul_add(
                            S::int(2),
                            S::int(2) * u4_from_u3_sq_1 + u5_from_u3_sq_1,
                        ),
                ),
        );
    let u4_from_u3_dot_of_motion_24_1 = u4_from_u3_dot_of_motion_23_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * u4_from_u3_dot_of_motion_23_0,
        );
    let u4_from_u3_dot_of_motion_25_1 = u4_from_u3_dot_of_motion_22_1
        .mul_add(
            S::int(6),
            u4_from_u3_dot_of_motion_5_1.mul_add(-S::int(2), u5_from_u3_sq_1),
        );
    let u4_from_u3_dot_of_motion_26_1 = u4_from_u3_dot_of_motion_25_1
        .mul_add(
            sin_theta3_from_theta1_0,
            sin_theta3_from_theta1_1 * u4_from_u3_dot_of_motion_25_0,
        );
    let u4_from_u3_dot_of_motion_27_1 = u5_from_u3_dot_of_motion_1
        .mul_add(
            u4_from_u3_dot_of_place_5_0,
            u4_from_u3_dot_of_place_5_1 * u5_from_u3_dot_of_motion_0,
        );
    let u4_from_u3_dot_of_motion_28_1 = u4_from_u3_dot_of_motion_24_1
        .mul_add(
            S::int(3),
            u4_from_u3_dot_of_motion_27_1
                .mul_add(weight_5, -u4_from_u3_dot_of_motion_26_1),
        );
    let u4_from_u3_dot_of_motion_29_1 = u4_from_u3_dot_of_motion_28_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * u4_from_u3_dot_of_motion_28_0,
        );
    let u4_from_u3_dot_of_motion_30_1 = u4_from_u3_dot_of_u5_from_u3_1
        .mul_add(
            S::int(2),
            u3_of_motion_2_1
                .mul_add(
                    -S::int(15),
                    u5_from_u3_1.mul_add(S::int(12), S::int(14) * u4_from_u3_1),
                ),
        );
    let u4_from_u3_dot_of_motion_31_1 = u4_from_u3_dot_of_motion_30_1
        .mul_add(u3_of_motion_2_0, u3_of_motion_2_1 * u4_from_u3_dot_of_motion_30_0);
    let u4_from_u3_dot_of_motion_32_1 = u4_from_u3_dot_of_motion_1
        .mul_add(
            weight_5,
            S::int(7) * u4_from_u3_sq_1 + r1__of_u5_from_u3_4_1 - u4_from_u3_dot_of_motion_31_1,
        );
    let u4_from_u3_dot_of_motion_33_1 = u4_from_u3_dot_of_motion_32_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * u4_from_u3_dot_of_motion_32_0,
        );
    let u4_from_u3_dot_of_motion_34_1 = u4_from_u3_dot_of_motion_29_1
        .mul_add(
            S::int(3),
            u4_from_u3_dot_of_motion_33_1
                .mul_add(
                    S::int(3),
                    u4_from_u3_dot_of_motion_11_1
                        .mul_add(weight_6, S::int(9) * u4_from_u3_dot_of_motion_4_1),
                ),
        );
    let u4_from_u3_dot_of_motion_35_1 = u4_from_u3_dot_of_motion_34_1
        .mul_add(
            cos_theta3_from_theta1_0,
            cos_theta3_from_theta1_1 * u4_from_u3_dot_of_motion_34_0,
        );
    let u4_from_u3_dot_of_motion_36_1 = u4_from_u3_dot_of_motion_20_1
        .mul_add(weight_2, S::int(3) * u4_from_u3_dot_of_motion_19_1)
        + u4_from_u3_dot_of_motion_16_1 + u4_from_u3_dot_of_motion_35_1;
    let u4_from_u3_dot_of_motion_37_1 = r1__of_place_7_1
        .mul_add(
            -(u4_from_u3_dot_of_motion_37_0 * over_r1__of_place_7),
            u4_from_u3_dot_of_motion_36_1 * over_r1__of_place_7,
        );
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                theta2_from_theta1_1, theta2_from_theta1_1, theta3_from_theta1_1,
                theta3_from_theta1_1, cos_theta2_from_theta1_1, sin_theta2_from_theta1_1,
                cos_theta3_from_theta1_1, u3_of_place_4_1, u3_of_place_7_1, u3_of_place_8_1,
                u4_from_u3_1, u5_from_u3_1, u3_of_motion_2_1, cos_theta3_from_theta1_1,
                cos_theta3_from_theta1_1, cos_theta2_from_theta1_1, cos_theta3_from_theta1_1,
                cos_theta2_from_theta1_1, cos_theta2_from_theta1_1, cos_theta3_from_theta1_1,
                cos_theta2_from_theta1_1, cos_theta3_from_theta1_1, cos_theta2_from_theta1_1,
                u3_of_motion_2_1, u5_from_u3_1, sin_theta2_from_theta1_1, cos_theta2_from_theta1_1,
                cos_theta2_from_theta1_1, sin_theta3_from_theta1_1, cos_theta3_from_theta1_1,
                cos_theta2_from_theta1_1, cos_theta2_from_theta1_1, sin_theta3_from_theta1_1,
                u5_from_u3_1, sin_theta2_from_theta1_1, u3_of_motion_2_1, cos_theta2_from_theta1_1,
                r1__of_place_20_1, sin_theta3_from_theta1_1, cos_theta3_from_theta1_1,
                sin_theta2_from_theta1_1, cos_theta2_from_theta1_1, r1__of_place_18_1,
                cos_theta3_from_theta1_1, sin_theta2_from_theta1_1, sin_theta3_from_theta1_1,
                cos_theta3_from_theta1_1, u3_of_motion_2_1, u4_from_u3_1, sin_theta2_from_theta1_1,
                cos_theta2_from_theta1_1, sin_theta3_from_theta1_1, cos_theta3_from_theta1_1,
                u4_from_u3_1, cos_theta2_from_theta1_1, sin_theta3_from_theta1_1,
                sin_theta2_from_theta1_1, u3_of_motion_2_1, cos_theta2_from_theta1_1,
                cos_theta3_from_theta1_1, r1__of_place_22_1, sin_theta2_from_theta1_1,
                cos_theta2_from_theta1_1, sin_theta3_from_theta1_1, cos_theta3_from_theta1_1,
                r1__of_place_23_1, cos_theta2_from_theta1_1, sin_theta3_from_theta1_1,
                sin_theta2_from_theta1_1, u3_of_place_8_1, u3_of_place_8_1, r1__of_place_7_1,
                r1__of_motion_43_1, cos_theta2_from_theta1_1, cos_theta2_from_theta1_1,
                cos_theta3_from_theta1_1, u5_from_u3_dot_of_place_6_1, r1__of_motion_81_1,
                cos_theta3_from_theta1_1, sin_theta3_from_theta1_1, u3_of_motion_2_1,
                sin_theta3_from_theta1_1, u3_of_motion_2_1, sin_theta2_from_theta1_1,
                cos_theta2_from_theta1_1, u3_of_motion_2_1, u5_from_u3_dot_of_motion_1,
                u3_of_motion_2_1, cos_theta2_from_theta1_1, sin_theta3_from_theta1_1,
                u3_of_motion_2_1, r1__of_place_19_1, sin_theta2_from_theta1_1,
                cos_theta2_from_theta1_1, u5_from_u3_dot_of_motion_1, u3_of_motion_2_1,
                cos_theta2_from_theta1_1, sin_theta2_from_theta1_1, sin_theta3_from_theta1_1,
                u5_from_u3_dot_of_motion_1, cos_theta2_from_theta1_1, u3_of_motion_2_1,
                sin_theta2_from_theta1_1, cos_theta3_from_theta1_1, r1__of_place_7_1,
            ]),
            padded([
                cos_theta2_from_theta1_1, sin_theta2_from_theta1_1, cos_theta3_from_theta1_1,
                sin_theta3_from_theta1_1, u3_of_place_1, sin_theta3_from_theta1_1, u3_of_place_5_1,
                u4_from_u3_1, u5_from_u3_1, u3_of_motion_2_1, u4_from_u3_1, u5_from_u3_1,
                r1__of_place_1, r1__of_motion_3_1, r1__of_motion_2_1, r1__of_place_2_1,
                r1__of_place_4_1, u3_of_place_3_1, r1__of_place_8_1, r1__of_place_10_1,
                r1__of_place_12_1, r1__of_place_14_1, r1__of_motion_7_1, r1__of_place_17_1,
                r1__of_place_18_1, r1__of_motion_10_1, r1__of_motion_3_1, r1__of_motion_13_1,
                r1__of_motion_15_1, r1__of_motion_17_1, r1__of_motion_6_1, r1__of_motion_20_1,
                r1__of_motion_22_1, r1__of_place_19_1, r1__of_motion_24_1, r1__of_motion_26_1,
                r1__of_motion_28_1, u5_from_u3_sq_1, r1__of_motion_30_1, r1__of_motion_28_1,
                r1__of_motion_33_1, r1__of_motion_35_1, u5_from_u3_sq_1, r1__of_motion_37_1,
                r1__of_motion_39_1, r1__of_motion_41_1, r1__of_motion_44_1, r1__of_place_21_1,
                r1__of_place_22_1, r1__of_motion_47_1, r1__of_motion_44_1, r1__of_motion_50_1,
                r1__of_motion_52_1, r1__of_place_23_1, r1__of_motion_54_1, r1__of_motion_56_1,
                r1__of_motion_58_1, r1__of_motion_60_1, r1__of_motion_2_1, r1__of_motion_63_1,
                u4_from_u3_sq_1, r1__of_motion_65_1, r1__of_motion_63_1, r1__of_motion_68_1,
                r1__of_motion_70_1, u4_from_u3_sq_1, r1__of_motion_72_1, r1__of_motion_74_1,
                r1__of_motion_76_1, r1__of_motion_79_1, r1__of_place_24_1, r1__of_place_25_1,
                r1__of_place_25_1, cos_theta3_from_theta1_1, u5_from_u3_dot_of_place_2_1,
                u5_from_u3_dot_of_place_4_1, u5_from_u3_dot_of_place_7_1,
                u5_from_u3_dot_of_place_7_1, u3_plus_u5_from_u3_1, u5_from_u3_dot_of_motion_1,
                r1__of_motion_3_1, u4_from_u3_dot_of_motion_3_1, u3_plus_u5_from_u3_1,
                u5_from_u3_dot_of_motion_1, u4_from_u3_dot_of_motion_7_1,
                u4_from_u3_dot_of_motion_6_1, u4_from_u3_dot_of_place_2_1, r1__of_motion_20_1,
                u4_from_u3_dot_of_motion_13_1, u4_from_u3_dot_of_motion_15_1, r1__of_motion_24_1,
                u5_from_u3_sq_1, u4_from_u3_dot_of_motion_18_1, u4_from_u3_dot_of_place_1,
                u4_from_u3_dot_of_place_4_1, r1__of_motion_7_1, u4_from_u3_dot_of_motion_3_1,
                u4_from_u3_dot_of_motion_23_1, u4_from_u3_dot_of_motion_25_1,
                u4_from_u3_dot_of_place_5_1, u4_from_u3_dot_of_motion_28_1,
                u4_from_u3_dot_of_motion_30_1, u4_from_u3_dot_of_motion_32_1,
                u4_from_u3_dot_of_motion_34_1, u4_from_u3_dot_of_motion_37_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta2_from_theta1_last = theta2_from_theta1_1;
    let mut theta3_from_theta1_last = theta3_from_theta1_1;
    let mut u4_from_u3_last = u4_from_u3_1;
    let mut u5_from_u3_last = u5_from_u3_1;
    let mut sin_theta2_from_theta1_last = sin_theta2_from_theta1_1;
    let mut cos_theta2_from_theta1_last = cos_theta2_from_theta1_1;
    let mut sin_theta3_from_theta1_last = sin_theta3_from_theta1_1;
    let mut cos_theta3_from_theta1_last = cos_theta3_from_theta1_1;
    let mut u3_of_place_last = u3_of_place_1;
    let mut u3_of_place_3_last = u3_of_place_3_1;
    let mut u3_of_place_4_last = u3_of_place_4_1;
    let mut u3_of_place_5_last = u3_of_place_5_1;
    let mut u3_of_place_7_last = u3_of_place_7_1;
    let mut u3_of_place_8_last = u3_of_place_8_1;
    let mut u3_of_motion_2_last = u3_of_motion_2_1;
    let mut u4_from_u3_sq_last = u4_from_u3_sq_1;
    let mut u5_from_u3_sq_last = u5_from_u3_sq_1;
    let mut r1__of_place_last = r1__of_place_1;
    let mut r1__of_motion_2_last = r1__of_motion_2_1;
    let mut r1__of_motion_3_last = r1__of_motion_3_1;
    let mut r1__of_place_2_last = r1__of_place_2_1;
    let mut r1__of_place_4_last = r1__of_place_4_1;
    let mut r1__of_place_7_last = r1__of_place_7_1;
    let mut r1__of_place_8_last = r1__of_place_8_1;
    let mut r1__of_place_10_last = r1__of_place_10_1;
    let mut r1__of_place_12_last = r1__of_place_12_1;
    let mut r1__of_place_14_last = r1__of_place_14_1;
    let mut r1__of_motion_6_last = r1__of_motion_6_1;
    let mut r1__of_motion_7_last = r1__of_motion_7_1;
    let mut r1__of_place_17_last = r1__of_place_17_1;
    let mut r1__of_place_18_last = r1__of_place_18_1;
    let mut r1__of_motion_10_last = r1__of_motion_10_1;
    let mut r1__of_motion_13_last = r1__of_motion_13_1;
    let mut r1__of_motion_15_last = r1__of_motion_15_1;
    let mut r1__of_motion_17_last = r1__of_motion_17_1;
    let mut r1__of_motion_20_last = r1__of_motion_20_1;
    let mut r1__of_motion_22_last = r1__of_motion_22_1;
    let mut r1__of_place_19_last = r1__of_place_19_1;
    let mut r1__of_motion_24_last = r1__of_motion_24_1;
    let mut r1__of_motion_26_last = r1__of_motion_26_1;
    let mut r1__of_motion_28_last = r1__of_motion_28_1;
    let mut r1__of_place_20_last = r1__of_place_20_1;
    let mut r1__of_motion_30_last = r1__of_motion_30_1;
    let mut r1__of_motion_33_last = r1__of_motion_33_1;
    let mut r1__of_motion_35_last = r1__of_motion_35_1;
    let mut r1__of_motion_37_last = r1__of_motion_37_1;
    let mut r1__of_motion_39_last = r1__of_motion_39_1;
    let mut r1__of_motion_41_last = r1__of_motion_41_1;
    let mut r1__of_motion_43_last = r1__of_motion_43_1;
    let mut r1__of_motion_44_last = r1__of_motion_44_1;
    let mut r1__of_place_21_last = r1__of_place_21_1;
    let mut r1__of_place_22_last = r1__of_place_22_1;
    let mut r1__of_motion_47_last = r1__of_motion_47_1;
    let mut r1__of_motion_50_last = r1__of_motion_50_1;
    let mut r1__of_motion_52_last = r1__of_motion_52_1;
    let mut r1__of_place_23_last = r1__of_place_23_1;
    let mut r1__of_motion_54_last = r1__of_motion_54_1;
    let mut r1__of_motion_56_last = r1__of_motion_56_1;
    let mut r1__of_motion_58_last = r1__of_motion_58_1;
    let mut r1__of_motion_60_last = r1__of_motion_60_1;
    let mut r1__of_motion_63_last = r1__of_motion_63_1;
    let mut r1__of_motion_65_last = r1__of_motion_65_1;
    let mut r1__of_motion_68_last = r1__of_motion_68_1;
    let mut r1__of_motion_70_last = r1__of_motion_70_1;
    let mut r1__of_motion_72_last = r1__of_motion_72_1;
    let mut r1__of_motion_74_last = r1__of_motion_74_1;
    let mut r1__of_motion_76_last = r1__of_motion_76_1;
    let mut r1__of_motion_79_last = r1__of_motion_79_1;
    let mut r1__of_place_24_last = r1__of_place_24_1;
    let mut r1__of_place_25_last = r1__of_place_25_1;
    let mut r1__of_motion_81_last = r1__of_motion_81_1;
    let mut u5_from_u3_dot_of_place_2_last = u5_from_u3_dot_of_place_2_1;
    let mut u5_from_u3_dot_of_place_4_last = u5_from_u3_dot_of_place_4_1;
    let mut u5_from_u3_dot_of_place_6_last = u5_from_u3_dot_of_place_6_1;
    let mut u5_from_u3_dot_of_place_7_last = u5_from_u3_dot_of_place_7_1;
    let mut u5_from_u3_dot_of_motion_last = u5_from_u3_dot_of_motion_1;
    let mut u3_plus_u5_from_u3_last = u3_plus_u5_from_u3_1;
    let mut u4_from_u3_dot_of_place_last = u4_from_u3_dot_of_place_1;
    let mut u4_from_u3_dot_of_motion_3_last = u4_from_u3_dot_of_motion_3_1;
    let mut u4_from_u3_dot_of_motion_6_last = u4_from_u3_dot_of_motion_6_1;
    let mut u4_from_u3_dot_of_motion_7_last = u4_from_u3_dot_of_motion_7_1;
    let mut u4_from_u3_dot_of_place_2_last = u4_from_u3_dot_of_place_2_1;
    let mut u4_from_u3_dot_of_motion_13_last = u4_from_u3_dot_of_motion_13_1;
    let mut u4_from_u3_dot_of_motion_15_last = u4_from_u3_dot_of_motion_15_1;
    let mut u4_from_u3_dot_of_motion_18_last = u4_from_u3_dot_of_motion_18_1;
    let mut u4_from_u3_dot_of_place_4_last = u4_from_u3_dot_of_place_4_1;
    let mut u4_from_u3_dot_of_place_5_last = u4_from_u3_dot_of_place_5_1;
    let mut u4_from_u3_dot_of_motion_23_last = u4_from_u3_dot_of_motion_23_1;
    let mut u4_from_u3_dot_of_motion_25_last = u4_from_u3_dot_of_motion_25_1;
    let mut u4_from_u3_dot_of_motion_28_last = u4_from_u3_dot_of_motion_28_1;
    let mut u4_from_u3_dot_of_motion_30_last = u4_from_u3_dot_of_motion_30_1;
    let mut u4_from_u3_dot_of_motion_32_last = u4_from_u3_dot_of_motion_32_1;
    let mut u4_from_u3_dot_of_motion_34_last = u4_from_u3_dot_of_motion_34_1;
    let mut u4_from_u3_dot_of_motion_37_last = u4_from_u3_dot_of_motion_37_1;
    let mut next = [S::int(0); 112];
    // Rates at order k - 1.
    let mut theta2_from_theta1_rate = u4_from_u3_1;
    let mut theta3_from_theta1_rate = u5_from_u3_1;
    let mut theta1_rate = -u3_of_motion_2_1;
    let mut u4_from_u3_rate = -u4_from_u3_dot_of_motion_37_1;
    let mut u5_from_u3_rate = weight_5 * u5_from_u3_dot_of_motion_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let theta2_from_theta1 = theta2_from_theta1_rate * over_k;
        let theta3_from_theta1 = theta3_from_theta1_rate * over_k;
        let theta1 = theta1_rate * over_k;
        let u4_from_u3 = u4_from_u3_rate * over_k;
        let u5_from_u3 = u5_from_u3_rate * over_k;
        series[order] = [
            theta2_from_theta1, theta3_from_theta1, theta1, u4_from_u3, u5_from_u3,
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
                theta2_from_theta1_1
                    .mul_add(
                        cos_theta2_from_theta1_last,
                        (count_last * theta2_from_theta1_last)
                            .mul_add(cos_theta2_from_theta1_1, next[0]),
                    ),
                theta2_from_theta1_1
                    .mul_add(
                        sin_theta2_from_theta1_last,
                        (count_last * theta2_from_theta1_last)
                            .mul_add(sin_theta2_from_theta1_1, next[1]),
                    ),
                theta3_from_theta1_1
                    .mul_add(
                        cos_theta3_from_theta1_last,
                        (count_last * theta3_from_theta1_last)
                            .mul_add(cos_theta3_from_theta1_1, next[2]),
                    ),
                theta3_from_theta1_1
                    .mul_add(
                        sin_theta3_from_theta1_last,
                        (count_last * theta3_from_theta1_last)
                            .mul_add(sin_theta3_from_theta1_1, next[3]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        u3_of_place_last,
                        cos_theta2_from_theta1_last.mul_add(u3_of_place_1, next[4]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        sin_theta3_from_theta1_last,
                        sin_theta2_from_theta1_last
                            .mul_add(sin_theta3_from_theta1_1, next[5]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        u3_of_place_5_last,
                        cos_theta3_from_theta1_last.mul_add(u3_of_place_5_1, next[6]),
                    ),
                u3_of_place_4_1
                    .mul_add(
                        u4_from_u3_last,
                        u3_of_place_4_last.mul_add(u4_from_u3_1, next[7]),
                    ),
                u3_of_place_7_1
                    .mul_add(
                        u5_from_u3_last,
                        u3_of_place_7_last.mul_add(u5_from_u3_1, next[8]),
                    ),
                u3_of_place_8_1
                    .mul_add(
                        u3_of_motion_2_last,
                        u3_of_place_8_last.mul_add(u3_of_motion_2_1, next[9]),
                    ),
                (u4_from_u3_1 + u4_from_u3_1).mul_add(u4_from_u3_last, next[10]),
                (u5_from_u3_1 + u5_from_u3_1).mul_add(u5_from_u3_last, next[11]),
                u3_of_motion_2_1
                    .mul_add(
                        r1__of_place_last,
                        u3_of_motion_2_last.mul_add(r1__of_place_1, next[12]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__of_motion_3_last,
                        cos_theta3_from_theta1_last.mul_add(r1__of_motion_3_1, next[13]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__of_motion_2_last,
                        cos_theta3_from_theta1_last.mul_add(r1__of_motion_2_1, next[14]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__of_place_2_last,
                        cos_theta2_from_theta1_last.mul_add(r1__of_place_2_1, next[15]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__of_place_4_last,
                        cos_theta3_from_theta1_last.mul_add(r1__of_place_4_1, next[16]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        u3_of_place_3_last,
                        cos_theta2_from_theta1_last.mul_add(u3_of_place_3_1, next[17]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__of_place_8_last,
                        cos_theta2_from_theta1_last.mul_add(r1__of_place_8_1, next[18]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__of_place_10_last,
                        cos_theta3_from_theta1_last.mul_add(r1__of_place_10_1, next[19]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__of_place_12_last,
                        cos_theta2_from_theta1_last.mul_add(r1__of_place_12_1, next[20]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__of_place_14_last,
                        cos_theta3_from_theta1_last.mul_add(r1__of_place_14_1, next[21]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_7_last,
                        cos_theta2_from_theta1_last.mul_add(r1__of_motion_7_1, next[22]),
                    ),
                u3_of_motion_2_1
                    .mul_add(
                        r1__of_place_17_last,
                        u3_of_motion_2_last.mul_add(r1__of_place_17_1, next[23]),
                    ),
                u5_from_u3_1
                    .mul_add(
                        r1__of_place_18_last,
                        u5_from_u3_last.mul_add(r1__of_place_18_1, next[24]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_10_last,
                        sin_theta2_from_theta1_last.mul_add(r1__of_motion_10_1, next[25]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_3_last,
                        cos_theta2_from_theta1_last.mul_add(r1__of_motion_3_1, next[26]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_13_last,
                        cos_theta2_from_theta1_last.mul_add(r1__of_motion_13_1, next[27]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__of_motion_15_last,
                        sin_theta3_from_theta1_last.mul_add(r1__of_motion_15_1, next[28]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__of_motion_17_last,
                        cos_theta3_from_theta1_last.mul_add(r1__of_motion_17_1, next[29]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_6_last,
                        cos_theta2_from_theta1_last.mul_add(r1__of_motion_6_1, next[30]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_20_last,
                        cos_theta2_from_theta1_last.mul_add(r1__of_motion_20_1, next[31]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__of_motion_22_last,
                        sin_theta3_from_theta1_last.mul_add(r1__of_motion_22_1, next[32]),
                    ),
                u5_from_u3_1
                    .mul_add(
                        r1__of_place_19_last,
                        u5_from_u3_last.mul_add(r1__of_place_19_1, next[33]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_24_last,
                        sin_theta2_from_theta1_last.mul_add(r1__of_motion_24_1, next[34]),
                    ),
                u3_of_motion_2_1
                    .mul_add(
                        r1__of_motion_26_last,
                        u3_of_motion_2_last.mul_add(r1__of_motion_26_1, next[35]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_28_last,
                        cos_theta2_from_theta1_last.mul_add(r1__of_motion_28_1, next[36]),
                    ),
                r1__of_place_20_1
                    .mul_add(
                        u5_from_u3_sq_last,
                        r1__of_place_20_last.mul_add(u5_from_u3_sq_1, next[37]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__of_motion_30_last,
                        sin_theta3_from_theta1_last.mul_add(r1__of_motion_30_1, next[38]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__of_motion_28_last,
                        cos_theta3_from_theta1_last.mul_add(r1__of_motion_28_1, next[39]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_33_last,
                        sin_theta2_from_theta1_last.mul_add(r1__of_motion_33_1, next[40]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_35_last,
                        cos_theta2_from_theta1_last.mul_add(r1__of_motion_35_1, next[41]),
                    ),
                r1__of_place_18_1
                    .mul_add(
                        u5_from_u3_sq_last,
                        r1__of_place_18_last.mul_add(u5_from_u3_sq_1, next[42]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__of_motion_37_last,
                        cos_theta3_from_theta1_last.mul_add(r1__of_motion_37_1, next[43]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_39_last,
                        sin_theta2_from_theta1_last.mul_add(r1__of_motion_39_1, next[44]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__of_motion_41_last,
                        sin_theta3_from_theta1_last.mul_add(r1__of_motion_41_1, next[45]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__of_motion_44_last,
                        cos_theta3_from_theta1_last.mul_add(r1__of_motion_44_1, next[46]),
                    ),
                u3_of_motion_2_1
                    .mul_add(
                        r1__of_place_21_last,
                        u3_of_motion_2_last.mul_add(r1__of_place_21_1, next[47]),
                    ),
                u4_from_u3_1
                    .mul_add(
                        r1__of_place_22_last,
                        u4_from_u3_last.mul_add(r1__of_place_22_1, next[48]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_47_last,
                        sin_theta2_from_theta1_last.mul_add(r1__of_motion_47_1, next[49]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_44_last,
                        cos_theta2_from_theta1_last.mul_add(r1__of_motion_44_1, next[50]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__of_motion_50_last,
                        sin_theta3_from_theta1_last.mul_add(r1__of_motion_50_1, next[51]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__of_motion_52_last,
                        cos_theta3_from_theta1_last.mul_add(r1__of_motion_52_1, next[52]),
                    ),
                u4_from_u3_1
                    .mul_add(
                        r1__of_place_23_last,
                        u4_from_u3_last.mul_add(r1__of_place_23_1, next[53]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_54_last,
                        cos_theta2_from_theta1_last.mul_add(r1__of_motion_54_1, next[54]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__of_motion_56_last,
                        sin_theta3_from_theta1_last.mul_add(r1__of_motion_56_1, next[55]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_58_last,
                        sin_theta2_from_theta1_last.mul_add(r1__of_motion_58_1, next[56]),
                    ),
                u3_of_motion_2_1
                    .mul_add(
                        r1__of_motion_60_last,
                        u3_of_motion_2_last.mul_add(r1__of_motion_60_1, next[57]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_2_last,
                        cos_theta2_from_theta1_last.mul_add(r1__of_motion_2_1, next[58]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__of_motion_63_last,
                        cos_theta3_from_theta1_last.mul_add(r1__of_motion_63_1, next[59]),
                    ),
                r1__of_place_22_1
                    .mul_add(
                        u4_from_u3_sq_last,
                        r1__of_place_22_last.mul_add(u4_from_u3_sq_1, next[60]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_65_last,
                        sin_theta2_from_theta1_last.mul_add(r1__of_motion_65_1, next[61]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_63_last,
                        cos_theta2_from_theta1_last.mul_add(r1__of_motion_63_1, next[62]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__of_motion_68_last,
                        sin_theta3_from_theta1_last.mul_add(r1__of_motion_68_1, next[63]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__of_motion_70_last,
                        cos_theta3_from_theta1_last.mul_add(r1__of_motion_70_1, next[64]),
                    ),
                r1__of_place_23_1
                    .mul_add(
                        u4_from_u3_sq_last,
                        r1__of_place_23_last.mul_add(u4_from_u3_sq_1, next[65]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_72_last,
                        cos_theta2_from_theta1_last.mul_add(r1__of_motion_72_1, next[66]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__of_motion_74_last,
                        sin_theta3_from_theta1_last.mul_add(r1__of_motion_74_1, next[67]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__of_motion_76_last,
                        sin_theta2_from_theta1_last.mul_add(r1__of_motion_76_1, next[68]),
                    ),
                u3_of_place_8_1
                    .mul_add(
                        r1__of_motion_79_last,
                        u3_of_place_8_last.mul_add(r1__of_motion_79_1, next[69]),
                    ),
                u3_of_place_8_1
                    .mul_add(
                        r1__of_place_24_last,
                        u3_of_place_8_last.mul_add(r1__of_place_24_1, next[70]),
                    ),
                r1__of_place_7_1
                    .mul_add(
                        r1__of_place_25_last,
                        r1__of_place_7_last.mul_add(r1__of_place_25_1, next[71]),
                    ),
                r1__of_motion_43_1
                    .mul_add(
                        r1__of_place_25_last,
                        r1__of_motion_43_last.mul_add(r1__of_place_25_1, next[72]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        cos_theta3_from_theta1_last,
                        cos_theta2_from_theta1_last
                            .mul_add(cos_theta3_from_theta1_1, next[73]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        u5_from_u3_dot_of_place_2_last,
                        cos_theta2_from_theta1_last
                            .mul_add(u5_from_u3_dot_of_place_2_1, next[74]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        u5_from_u3_dot_of_place_4_last,
                        cos_theta3_from_theta1_last
                            .mul_add(u5_from_u3_dot_of_place_4_1, next[75]),
                    ),
                u5_from_u3_dot_of_place_6_1
                    .mul_add(
                        u5_from_u3_dot_of_place_7_last,
                        u5_from_u3_dot_of_place_6_last
                            .mul_add(u5_from_u3_dot_of_place_7_1, next[76]),
                    ),
                r1__of_motion_81_1
                    .mul_add(
                        u5_from_u3_dot_of_place_7_last,
                        r1__of_motion_81_last
                            .mul_add(u5_from_u3_dot_of_place_7_1, next[77]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        u3_plus_u5_from_u3_last,
                        cos_theta3_from_theta1_last
                            .mul_add(u3_plus_u5_from_u3_1, next[78]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        u5_from_u3_dot_of_motion_last,
                        sin_theta3_from_theta1_last
                            .mul_add(u5_from_u3_dot_of_motion_1, next[79]),
                    ),
                u3_of_motion_2_1
                    .mul_add(
                        r1__of_motion_3_last,
                        u3_of_motion_2_last.mul_add(r1__of_motion_3_1, next[80]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_of_motion_3_last,
                        sin_theta3_from_theta1_last
                            .mul_add(u4_from_u3_dot_of_motion_3_1, next[81]),
                    ),
                u3_of_motion_2_1
                    .mul_add(
                        u3_plus_u5_from_u3_last,
                        u3_of_motion_2_last.mul_add(u3_plus_u5_from_u3_1, next[82]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        u5_from_u3_dot_of_motion_last,
                        sin_theta2_from_theta1_last
                            .mul_add(u5_from_u3_dot_of_motion_1, next[83]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_of_motion_7_last,
                        cos_theta2_from_theta1_last
                            .mul_add(u4_from_u3_dot_of_motion_7_1, next[84]),
                    ),
                u3_of_motion_2_1
                    .mul_add(
                        u4_from_u3_dot_of_motion_6_last,
                        u3_of_motion_2_last
                            .mul_add(u4_from_u3_dot_of_motion_6_1, next[85]),
                    ),
                u5_from_u3_dot_of_motion_1
                    .mul_add(
                        u4_from_u3_dot_of_place_2_last,
                        u5_from_u3_dot_of_motion_last
                            .mul_add(u4_from_u3_dot_of_place_2_1, next[86]),
                    ),
                u3_of_motion_2_1
                    .mul_add(
                        r1__of_motion_20_last,
                        u3_of_motion_2_last.mul_add(r1__of_motion_20_1, next[87]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_of_motion_13_last,
                        cos_theta2_from_theta1_last
                            .mul_add(u4_from_u3_dot_of_motion_13_1, next[88]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_of_motion_15_last,
                        sin_theta3_from_theta1_last
                            .mul_add(u4_from_u3_dot_of_motion_15_1, next[89]),
                    ),
                u3_of_motion_2_1
                    .mul_add(
                        r1__of_motion_24_last,
                        u3_of_motion_2_last.mul_add(r1__of_motion_24_1, next[90]),
                    ),
                r1__of_place_19_1
                    .mul_add(
                        u5_from_u3_sq_last,
                        r1__of_place_19_last.mul_add(u5_from_u3_sq_1, next[91]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_of_motion_18_last,
                        sin_theta2_from_theta1_last
                            .mul_add(u4_from_u3_dot_of_motion_18_1, next[92]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_of_place_last,
                        cos_theta2_from_theta1_last
                            .mul_add(u4_from_u3_dot_of_place_1, next[93]),
                    ),
                u5_from_u3_dot_of_motion_1
                    .mul_add(
                        u4_from_u3_dot_of_place_4_last,
                        u5_from_u3_dot_of_motion_last
                            .mul_add(u4_from_u3_dot_of_place_4_1, next[94]),
                    ),
                u3_of_motion_2_1
                    .mul_add(
                        r1__of_motion_7_last,
                        u3_of_motion_2_last.mul_add(r1__of_motion_7_1, next[95]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_of_motion_3_last,
                        cos_theta2_from_theta1_last
                            .mul_add(u4_from_u3_dot_of_motion_3_1, next[96]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_of_motion_23_last,
                        sin_theta2_from_theta1_last
                            .mul_add(u4_from_u3_dot_of_motion_23_1, next[97]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_of_motion_25_last,
                        sin_theta3_from_theta1_last
                            .mul_add(u4_from_u3_dot_of_motion_25_1, next[98]),
                    ),
                u5_from_u3_dot_of_motion_1
                    .mul_add(
                        u4_from_u3_dot_of_place_5_last,
                        u5_from_u3_dot_of_motion_last
                            .mul_add(u4_from_u3_dot_of_place_5_1, next[99]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_of_motion_28_last,
                        cos_theta2_from_theta1_last
                            .mul_add(u4_from_u3_dot_of_motion_28_1, next[100]),
                    ),
                u3_of_motion_2_1
                    .mul_add(
                        u4_from_u3_dot_of_motion_30_last,
                        u3_of_motion_2_last
                            .mul_add(u4_from_u3_dot_of_motion_30_1, next[101]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_of_motion_32_last,
                        sin_theta2_from_theta1_last
                            .mul_add(u4_from_u3_dot_of_motion_32_1, next[102]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_of_motion_34_last,
                        cos_theta3_from_theta1_last
                            .mul_add(u4_from_u3_dot_of_motion_34_1, next[103]),
                    ),
                r1__of_place_7_1
                    .mul_add(
                        u4_from_u3_dot_of_motion_37_last,
                        r1__of_place_7_last
                            .mul_add(u4_from_u3_dot_of_motion_37_1, next[104]),
                    ),
            ])
        };
        // sin_theta2_from_theta1 = sin(theta2_from_theta1)
        let sin_theta2_from_theta1 = theta2_from_theta1
            .mul_add(cos_theta2_from_theta1_0, sums[0] * over_k);
        // cos_theta2_from_theta1 = cos(theta2_from_theta1)
        let cos_theta2_from_theta1 = -theta2_from_theta1
            .mul_add(sin_theta2_from_theta1_0, sums[1] * over_k);
        // sin_theta3_from_theta1 = sin(theta3_from_theta1)
        let sin_theta3_from_theta1 = theta3_from_theta1
            .mul_add(cos_theta3_from_theta1_0, sums[2] * over_k);
        // cos_theta3_from_theta1 = cos(theta3_from_theta1)
        let cos_theta3_from_theta1 = -theta3_from_theta1
            .mul_add(sin_theta3_from_theta1_0, sums[3] * over_k);
        // u3_of_place = 1 + cos_theta3_from_theta1
        let u3_of_place = cos_theta3_from_theta1;
        // u3_of_place_2 = cos_theta2_from_theta1*u3_of_place
        let u3_of_place_2 = u3_of_place
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u3_of_place_0, sums[4]),
            );
        // u3_of_place_3 = sin_theta2_from_theta1*sin_theta3_from_theta1
        let u3_of_place_3 = sin_theta3_from_theta1
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(sin_theta3_from_theta1_0, sums[5]),
            );
        // u3_of_place_4 = 7 + 3*u3_of_place_2 + 3*u3_of_place_3
        let u3_of_place_4 = u3_of_place_2.mul_add(S::int(3), S::int(3) * u3_of_place_3);
        // u3_of_place_5 = 1 + 3*cos_theta2_from_theta1
        let u3_of_place_5 = S::int(3) * cos_theta2_from_theta1;
        // u3_of_place_6 = cos_theta3_from_theta1*u3_of_place_5
        let u3_of_place_6 = u3_of_place_5
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(u3_of_place_5_0, sums[6]),
            );
        // u3_of_place_7 = 3 + 3*u3_of_place_3 + u3_of_place_6
        let u3_of_place_7 = S::int(3) * u3_of_place_3 + u3_of_place_6;
        // u3_of_place_8 = 13 + 2*cos_theta3_from_theta1 + 6*u3_of_place_2 + 6*u3_of_place_3
        let u3_of_place_8 = u3_of_place_2
            .mul_add(
                S::int(6),
                u3_of_place_3.mul_add(S::int(6), S::int(2) * cos_theta3_from_theta1),
            );
        // u3_of_u4_from_u3 = u3_of_place_4*u4_from_u3
        let u3_of_u4_from_u3 = u3_of_place_4
            .mul_add(u4_from_u3_0, u4_from_u3.mul_add(u3_of_place_4_0, sums[7]));
        // u3_of_u5_from_u3 = u3_of_place_7*u5_from_u3
        let u3_of_u5_from_u3 = u3_of_place_7
            .mul_add(u5_from_u3_0, u5_from_u3.mul_add(u3_of_place_7_0, sums[8]));
        // u3_of_motion = weight + u3_of_u4_from_u3 + u3_of_u5_from_u3
        let u3_of_motion = u3_of_u4_from_u3 + u3_of_u5_from_u3;
        // u3_of_motion_2 = u3_of_motion/u3_of_place_8
        let u3_of_motion_2 = u3_of_motion
            .mul_add(
                over_u3_of_place_8,
                -(u3_of_place_8.mul_add(u3_of_motion_2_0, sums[9]) * over_u3_of_place_8),
            );
        // u4_from_u3_sq = u4_from_u3*u4_from_u3
        let u4_from_u3_sq = u4_from_u3.mul_add(u4_from_u3_0 + u4_from_u3_0, sums[10]);
        // u5_from_u3_sq = u5_from_u3*u5_from_u3
        let u5_from_u3_sq = u5_from_u3.mul_add(u5_from_u3_0 + u5_from_u3_0, sums[11]);
        // r1__of_place = 5 + 2*cos_theta2_from_theta1
        let r1__of_place = S::int(2) * cos_theta2_from_theta1;
        // r1__of_motion = u3_of_motion_2*r1__of_place
        let r1__of_motion = u3_of_motion_2
            .mul_add(r1__of_place_0, r1__of_place.mul_add(u3_of_motion_2_0, sums[12]));
        // r1__of_motion_2 = u4_from_u3_sq + u5_from_u3_sq
        let r1__of_motion_2 = u4_from_u3_sq + u5_from_u3_sq;
        // r1__of_motion_3 = -u3_of_motion_2 + u4_from_u3 + u5_from_u3
        let r1__of_motion_3 = u4_from_u3 + u5_from_u3 - u3_of_motion_2;
        // r1__of_motion_4 = cos_theta3_from_theta1*r1__of_motion_3
        let r1__of_motion_4 = r1__of_motion_3
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__of_motion_3_0, sums[13]),
            );
        // r1__of_motion_5 = cos_theta3_from_theta1*r1__of_motion_2
        let r1__of_motion_5 = r1__of_motion_2
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__of_motion_2_0, sums[14]),
            );
        // r1__of_place_2 = u3_of_place_2 + u3_of_place_3
        let r1__of_place_2 = u3_of_place_3 + u3_of_place_2;
        // r1__of_place_3 = cos_theta2_from_theta1*r1__of_place_2
        let r1__of_place_3 = r1__of_place_2
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__of_place_2_0, sums[15]),
            );
        // r1__of_place_4 = 14 + 9*cos_theta3_from_theta1 - 18*r1__of_place_3
        let r1__of_place_4 = r1__of_place_3
            .mul_add(-S::int(18), S::int(9) * cos_theta3_from_theta1);
        // r1__of_place_5 = cos_theta3_from_theta1*r1__of_place_4
        let r1__of_place_5 = r1__of_place_4
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__of_place_4_0, sums[16]),
            );
        // r1__of_place_6 = cos_theta2_from_theta1*u3_of_place_3
        let r1__of_place_6 = u3_of_place_3
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u3_of_place_3_0, sums[17]),
            );
        // r1__of_place_7 = 33 + r1__of_place_5 - 18*r1__of_place_6
        let r1__of_place_7 = -S::int(18) * r1__of_place_6 + r1__of_place_5;
        // r1__of_place_8 = 1 + 2*cos_theta3_from_theta1
        let r1__of_place_8 = S::int(2) * cos_theta3_from_theta1;
        // r1__of_place_9 = cos_theta2_from_theta1*r1__of_place_8
        let r1__of_place_9 = r1__of_place_8
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__of_place_8_0, sums[18]),
            );
        // r1__of_place_10 = 2 + cos_theta3_from_theta1 + 6*u3_of_place_3 + 3*r1__of_place_9
        let r1__of_place_10 = r1__of_place_9
            .mul_add(
                S::int(3),
                u3_of_place_3.mul_add(S::int(6), cos_theta3_from_theta1),
            );
        // r1__of_place_11 = cos_theta3_from_theta1*r1__of_place_10
        let r1__of_place_11 = r1__of_place_10
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__of_place_10_0, sums[19]),
            );
        // r1__of_place_12 = 3 + 3*cos_theta2_from_theta1 - 3*u3_of_place_3 - r1__of_place_11
        let r1__of_place_12 = u3_of_place_3
            .mul_add(-S::int(3), S::int(3) * cos_theta2_from_theta1) - r1__of_place_11;
        // r1__of_place_13 = cos_theta2_from_theta1*r1__of_place_12
        let r1__of_place_13 = r1__of_place_12
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__of_place_12_0, sums[20]),
            );
        // r1__of_place_14 = 7 + 9*cos_theta3_from_theta1 - 3*u3_of_place_3
        let r1__of_place_14 = u3_of_place_3
            .mul_add(-S::int(3), S::int(9) * cos_theta3_from_theta1);
        // r1__of_place_15 = cos_theta3_from_theta1*r1__of_place_14
        let r1__of_place_15 = r1__of_place_14
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__of_place_14_0, sums[21]),
            );
        // r1__of_place_16 = -12 + 9*u3_of_place_3 - 3*r1__of_place_13 - r1__of_place_15
        let r1__of_place_16 = r1__of_place_13
            .mul_add(-S::int(3), S::int(9) * u3_of_place_3 - r1__of_place_15);
        // r1__of_motion_6 = -2*u3_of_motion_2 + 2*u4_from_u3 + u5_from_u3
        let r1__of_motion_6 = u3_of_motion_2
            .mul_add(-S::int(2), S::int(2) * u4_from_u3 + u5_from_u3);
        // r1__of_motion_7 = -2*u3_of_motion_2 + 2*u4_from_u3 + u5_from_u3 + 2*r1__of_motion_4
        let r1__of_motion_7 = r1__of_motion_4
            .mul_add(
                S::int(2),
                u3_of_motion_2.mul_add(-S::int(2), S::int(2) * u4_from_u3 + u5_from_u3),
            );
        // r1__of_motion_8 = cos_theta2_from_theta1*r1__of_motion_7
        let r1__of_motion_8 = r1__of_motion_7
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__of_motion_7_0, sums[22]),
            );
        // r1__of_place_17 = 15 + 2*cos_theta3_from_theta1
        let r1__of_place_17 = S::int(2) * cos_theta3_from_theta1;
        // r1__of_motion_9 = u3_of_motion_2*r1__of_place_17
        let r1__of_motion_9 = u3_of_motion_2
            .mul_add(
                r1__of_place_17_0,
                r1__of_place_17.mul_add(u3_of_motion_2_0, sums[23]),
            );
        // r1__of_place_18 = 6 + cos_theta3_from_theta1
        let r1__of_place_18 = cos_theta3_from_theta1;
        // r1__of_u5_from_u3 = u5_from_u3*r1__of_place_18
        let r1__of_u5_from_u3 = r1__of_place_18
            .mul_add(u5_from_u3_0, u5_from_u3.mul_add(r1__of_place_18_0, sums[24]));
        // r1__of_motion_10 = 14*u4_from_u3 + 6*r1__of_motion_8 - r1__of_motion_9 + 2*r1__of_u5_from_u3
        let r1__of_motion_10 = r1__of_motion_8
            .mul_add(
                S::int(6),
                r1__of_u5_from_u3.mul_add(S::int(2), S::int(14) * u4_from_u3) - r1__of_motion_9,
            );
        // r1__of_motion_11 = sin_theta2_from_theta1*r1__of_motion_10
        let r1__of_motion_11 = r1__of_motion_10
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__of_motion_10_0, sums[25]),
            );
        // r1__of_motion_12 = cos_theta2_from_theta1*r1__of_motion_3
        let r1__of_motion_12 = r1__of_motion_3
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__of_motion_3_0, sums[26]),
            );
        // r1__of_motion_13 = -u3_of_motion_2 + u5_from_u3 + 6*r1__of_motion_12
        let r1__of_motion_13 = r1__of_motion_12
            .mul_add(S::int(6), u5_from_u3 - u3_of_motion_2);
        // r1__of_motion_14 = cos_theta2_from_theta1*r1__of_motion_13
        let r1__of_motion_14 = r1__of_motion_13
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__of_motion_13_0, sums[27]),
            );
        // r1__of_motion_15 = -3*u3_of_motion_2 + 3*u4_from_u3 + 3*u5_from_u3 - r1__of_motion_14
        let r1__of_motion_15 = u3_of_motion_2
            .mul_add(-S::int(3), u5_from_u3.mul_add(S::int(3), S::int(3) * u4_from_u3))
            - r1__of_motion_14;
        // r1__of_motion_16 = sin_theta3_from_theta1*r1__of_motion_15
        let r1__of_motion_16 = r1__of_motion_15
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__of_motion_15_0, sums[28]),
            );
        // r1__of_motion_17 = r1__of_motion_11 + 2*r1__of_motion_16
        let r1__of_motion_17 = r1__of_motion_16.mul_add(S::int(2), r1__of_motion_11);
        // r1__of_motion_18 = cos_theta3_from_theta1*r1__of_motion_17
        let r1__of_motion_18 = r1__of_motion_17
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__of_motion_17_0, sums[29]),
            );
        // r1__of_motion_19 = cos_theta2_from_theta1*r1__of_motion_6
        let r1__of_motion_19 = r1__of_motion_6
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__of_motion_6_0, sums[30]),
            );
        // r1__of_motion_20 = -13*u3_of_motion_2 + 14*u4_from_u3 + 10*u5_from_u3 + 6*r1__of_motion_19
        let r1__of_motion_20 = r1__of_motion_19
            .mul_add(
                S::int(6),
                u3_of_motion_2
                    .mul_add(
                        -S::int(13),
                        u5_from_u3.mul_add(S::int(10), S::int(14) * u4_from_u3),
                    ),
            );
        // r1__of_motion_21 = cos_theta2_from_theta1*r1__of_motion_20
        let r1__of_motion_21 = r1__of_motion_20
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__of_motion_20_0, sums[31]),
            );
        // r1__of_motion_22 = -18*u3_of_motion_2 + 18*u4_from_u3 + 14*u5_from_u3 - 3*r1__of_motion_21
        let r1__of_motion_22 = r1__of_motion_21
            .mul_add(
                -S::int(3),
                u3_of_motion_2
                    .mul_add(
                        -S::int(18),
                        u5_from_u3.mul_add(S::int(14), S::int(18) * u4_from_u3),
                    ),
            );
        // r1__of_motion_23 = sin_theta3_from_theta1*r1__of_motion_22
        let r1__of_motion_23 = r1__of_motion_22
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__of_motion_22_0, sums[32]),
            );
        // r1__of_place_19 = -1 + 3*cos_theta2_from_theta1
        let r1__of_place_19 = S::int(3) * cos_theta2_from_theta1;
        // r1__of_u5_from_u3_2 = u5_from_u3*r1__of_place_19
        let r1__of_u5_from_u3_2 = r1__of_place_19
            .mul_add(u5_from_u3_0, u5_from_u3.mul_add(r1__of_place_19_0, sums[33]));
        // r1__of_motion_24 = -13*u3_of_motion_2 + 14*u4_from_u3 - 2*r1__of_u5_from_u3_2
        let r1__of_motion_24 = u3_of_motion_2
            .mul_add(
                -S::int(13),
                r1__of_u5_from_u3_2.mul_add(-S::int(2), S::int(14) * u4_from_u3),
            );
        // r1__of_motion_25 = sin_theta2_from_theta1*r1__of_motion_24
        let r1__of_motion_25 = r1__of_motion_24
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__of_motion_24_0, sums[34]),
            );
        // r1__of_motion_26 = 3*r1__of_motion_18 + r1__of_motion_23 + 3*r1__of_motion_25
        let r1__of_motion_26 = r1__of_motion_18
            .mul_add(S::int(3), S::int(3) * r1__of_motion_25 + r1__of_motion_23);
        // r1__of_motion_27 = u3_of_motion_2*r1__of_motion_26
        let r1__of_motion_27 = r1__of_motion_26
            .mul_add(
                u3_of_motion_2_0,
                u3_of_motion_2.mul_add(r1__of_motion_26_0, sums[35]),
            );
        // r1__of_motion_28 = 2*u4_from_u3_sq + u5_from_u3_sq + 2*r1__of_motion_5
        let r1__of_motion_28 = r1__of_motion_5
            .mul_add(S::int(2), S::int(2) * u4_from_u3_sq + u5_from_u3_sq);
        // r1__of_motion_29 = cos_theta2_from_theta1*r1__of_motion_28
        let r1__of_motion_29 = r1__of_motion_28
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__of_motion_28_0, sums[36]),
            );
        // r1__of_place_20 = 5 + cos_theta3_from_theta1
        let r1__of_place_20 = cos_theta3_from_theta1;
        // r1__of_u5_from_u3_3 = r1__of_place_20*u5_from_u3_sq
        let r1__of_u5_from_u3_3 = r1__of_place_20
            .mul_add(
                u5_from_u3_sq_0,
                u5_from_u3_sq.mul_add(r1__of_place_20_0, sums[37]),
            );
        // r1__of_motion_30 = 7*u4_from_u3_sq + 3*r1__of_motion_29 + r1__of_u5_from_u3_3
        let r1__of_motion_30 = r1__of_motion_29
            .mul_add(S::int(3), S::int(7) * u4_from_u3_sq + r1__of_u5_from_u3_3);
        // r1__of_motion_31 = sin_theta3_from_theta1*r1__of_motion_30
        let r1__of_motion_31 = r1__of_motion_30
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__of_motion_30_0, sums[38]),
            );
        // r1__of_motion_32 = cos_theta3_from_theta1*r1__of_motion_28
        let r1__of_motion_32 = r1__of_motion_28
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__of_motion_28_0, sums[39]),
            );
        // r1__of_motion_33 = u5_from_u3_sq - r1__of_motion_32
        let r1__of_motion_33 = u5_from_u3_sq - r1__of_motion_32;
        // r1__of_motion_34 = sin_theta2_from_theta1*r1__of_motion_33
        let r1__of_motion_34 = r1__of_motion_33
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__of_motion_33_0, sums[40]),
            );
        // r1__of_motion_35 = r1__of_motion_31 + 3*r1__of_motion_34
        let r1__of_motion_35 = r1__of_motion_34.mul_add(S::int(3), r1__of_motion_31);
        // r1__of_motion_36 = cos_theta2_from_theta1*r1__of_motion_35
        let r1__of_motion_36 = r1__of_motion_35
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__of_motion_35_0, sums[41]),
            );
        // r1__of_u5_from_u3_4 = r1__of_place_18*u5_from_u3_sq
        let r1__of_u5_from_u3_4 = r1__of_place_18
            .mul_add(
                u5_from_u3_sq_0,
                u5_from_u3_sq.mul_add(r1__of_place_18_0, sums[42]),
            );
        // r1__of_motion_37 = 7*u4_from_u3_sq + r1__of_u5_from_u3_4
        let r1__of_motion_37 = S::int(7) * u4_from_u3_sq + r1__of_u5_from_u3_4;
        // r1__of_motion_38 = cos_theta3_from_theta1*r1__of_motion_37
        let r1__of_motion_38 = r1__of_motion_37
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__of_motion_37_0, sums[43]),
            );
        // r1__of_motion_39 = 7*u4_from_u3_sq + u5_from_u3_sq + r1__of_motion_38
        let r1__of_motion_39 = S::int(7) * u4_from_u3_sq + u5_from_u3_sq + r1__of_motion_38;
        // r1__of_motion_40 = sin_theta2_from_theta1*r1__of_motion_39
        let r1__of_motion_40 = r1__of_motion_39
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__of_motion_39_0, sums[44]),
            );
        // r1__of_motion_41 = 9*u4_from_u3_sq + 7*u5_from_u3_sq + 9*r1__of_motion_5
        let r1__of_motion_41 = r1__of_motion_5
            .mul_add(
                S::int(9),
                u5_from_u3_sq.mul_add(S::int(7), S::int(9) * u4_from_u3_sq),
            );
        // r1__of_motion_42 = sin_theta3_from_theta1*r1__of_motion_41
        let r1__of_motion_42 = r1__of_motion_41
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__of_motion_41_0, sums[45]),
            );
        // r1__of_motion_43 = -r1__of_motion_27 - 3*r1__of_motion_36 + 3*r1__of_motion_40 +
        //   r1__of_motion_42
        let r1__of_motion_43 = r1__of_motion_36
            .mul_add(-S::int(3), r1__of_motion_40.mul_add(S::int(3), r1__of_motion_42))
            - r1__of_motion_27;
        // r1__of_motion_44 = -2*u3_of_motion_2 + u4_from_u3 + 2*u5_from_u3 + 6*r1__of_motion_12
        let r1__of_motion_44 = r1__of_motion_12
            .mul_add(
                S::int(6),
                u3_of_motion_2
                    .mul_add(-S::int(2), u5_from_u3.mul_add(S::int(2), u4_from_u3)),
            );
        // r1__of_motion_45 = cos_theta3_from_theta1*r1__of_motion_44
        let r1__of_motion_45 = r1__of_motion_44
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__of_motion_44_0, sums[46]),
            );
        // r1__of_place_21 = 13 + 6*cos_theta2_from_theta1
        let r1__of_place_21 = S::int(6) * cos_theta2_from_theta1;
        // r1__of_motion_46 = u3_of_motion_2*r1__of_place_21
        let r1__of_motion_46 = u3_of_motion_2
            .mul_add(
                r1__of_place_21_0,
                r1__of_place_21.mul_add(u3_of_motion_2_0, sums[47]),
            );
        // r1__of_place_22 = 3 + cos_theta2_from_theta1
        let r1__of_place_22 = cos_theta2_from_theta1;
        // r1__of_u4_from_u3 = u4_from_u3*r1__of_place_22
        let r1__of_u4_from_u3 = r1__of_place_22
            .mul_add(u4_from_u3_0, u4_from_u3.mul_add(r1__of_place_22_0, sums[48]));
        // r1__of_motion_47 = 6*u5_from_u3 + 2*r1__of_motion_45 - r1__of_motion_46 + 6*r1__of_u4_from_u3
        let r1__of_motion_47 = r1__of_motion_45
            .mul_add(
                S::int(2),
                r1__of_u4_from_u3.mul_add(S::int(6), S::int(6) * u5_from_u3) - r1__of_motion_46,
            );
        // r1__of_motion_48 = sin_theta2_from_theta1*r1__of_motion_47
        let r1__of_motion_48 = r1__of_motion_47
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__of_motion_47_0, sums[49]),
            );
        // r1__of_motion_49 = cos_theta2_from_theta1*r1__of_motion_44
        let r1__of_motion_49 = r1__of_motion_44
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__of_motion_44_0, sums[50]),
            );
        // r1__of_motion_50 = -8*u3_of_motion_2 + 9*u4_from_u3 + 8*u5_from_u3 - 3*r1__of_motion_49
        let r1__of_motion_50 = r1__of_motion_49
            .mul_add(
                -S::int(3),
                u3_of_motion_2
                    .mul_add(
                        -S::int(8),
                        u5_from_u3.mul_add(S::int(8), S::int(9) * u4_from_u3),
                    ),
            );
        // r1__of_motion_51 = sin_theta3_from_theta1*r1__of_motion_50
        let r1__of_motion_51 = r1__of_motion_50
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__of_motion_50_0, sums[51]),
            );
        // r1__of_motion_52 = 3*r1__of_motion_48 + 2*r1__of_motion_51
        let r1__of_motion_52 = r1__of_motion_51
            .mul_add(S::int(2), S::int(3) * r1__of_motion_48);
        // r1__of_motion_53 = cos_theta3_from_theta1*r1__of_motion_52
        let r1__of_motion_53 = r1__of_motion_52
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__of_motion_52_0, sums[52]),
            );
        // r1__of_place_23 = 10 + 3*cos_theta2_from_theta1
        let r1__of_place_23 = S::int(3) * cos_theta2_from_theta1;
        // r1__of_u4_from_u3_2 = u4_from_u3*r1__of_place_23
        let r1__of_u4_from_u3_2 = r1__of_place_23
            .mul_add(u4_from_u3_0, u4_from_u3.mul_add(r1__of_place_23_0, sums[53]));
        // r1__of_motion_54 = 6*u5_from_u3 - 3*r1__of_motion + 2*r1__of_u4_from_u3_2
        let r1__of_motion_54 = r1__of_motion
            .mul_add(
                -S::int(3),
                r1__of_u4_from_u3_2.mul_add(S::int(2), S::int(6) * u5_from_u3),
            );
        // r1__of_motion_55 = cos_theta2_from_theta1*r1__of_motion_54
        let r1__of_motion_55 = r1__of_motion_54
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__of_motion_54_0, sums[54]),
            );
        // r1__of_motion_56 = -13*u3_of_motion_2 + 18*u4_from_u3 + 6*u5_from_u3 + 3*r1__of_motion_55
        let r1__of_motion_56 = r1__of_motion_55
            .mul_add(
                S::int(3),
                u3_of_motion_2
                    .mul_add(
                        -S::int(13),
                        u5_from_u3.mul_add(S::int(6), S::int(18) * u4_from_u3),
                    ),
            );
        // r1__of_motion_57 = sin_theta3_from_theta1*r1__of_motion_56
        let r1__of_motion_57 = r1__of_motion_56
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__of_motion_56_0, sums[55]),
            );
        // r1__of_motion_58 = -u3_of_motion_2 + 3*u4_from_u3 + u5_from_u3 + 3*r1__of_motion_12
        let r1__of_motion_58 = r1__of_motion_12
            .mul_add(S::int(3), S::int(3) * u4_from_u3 + u5_from_u3 - u3_of_motion_2);
        // r1__of_motion_59 = sin_theta2_from_theta1*r1__of_motion_58
        let r1__of_motion_59 = r1__of_motion_58
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__of_motion_58_0, sums[56]),
            );
        // r1__of_motion_60 = r1__of_motion_53 - r1__of_motion_57 - 6*r1__of_motion_59
        let r1__of_motion_60 = -S::int(6) * r1__of_motion_59 - r1__of_motion_57 + r1__of_motion_53;
        // r1__of_motion_61 = u3_of_motion_2*r1__of_motion_60
        let r1__of_motion_61 = r1__of_motion_60
            .mul_add(
                u3_of_motion_2_0,
                u3_of_motion_2.mul_add(r1__of_motion_60_0, sums[57]),
            );
        // r1__of_motion_62 = cos_theta2_from_theta1*r1__of_motion_2
        let r1__of_motion_62 = r1__of_motion_2
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__of_motion_2_0, sums[58]),
            );
        // r1__of_motion_63 = u4_from_u3_sq + 2*u5_from_u3_sq + 6*r1__of_motion_62
        let r1__of_motion_63 = r1__of_motion_62
            .mul_add(S::int(6), u5_from_u3_sq.mul_add(S::int(2), u4_from_u3_sq));
        // r1__of_motion_64 = cos_theta3_from_theta1*r1__of_motion_63
        let r1__of_motion_64 = r1__of_motion_63
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__of_motion_63_0, sums[59]),
            );
        // r1__of_u4_from_u3_3 = r1__of_place_22*u4_from_u3_sq
        let r1__of_u4_from_u3_3 = r1__of_place_22
            .mul_add(
                u4_from_u3_sq_0,
                u4_from_u3_sq.mul_add(r1__of_place_22_0, sums[60]),
            );
        // r1__of_motion_65 = 3*u5_from_u3_sq + r1__of_motion_64 + 3*r1__of_u4_from_u3_3
        let r1__of_motion_65 = r1__of_u4_from_u3_3
            .mul_add(S::int(3), S::int(3) * u5_from_u3_sq) + r1__of_motion_64;
        // r1__of_motion_66 = sin_theta2_from_theta1*r1__of_motion_65
        let r1__of_motion_66 = r1__of_motion_65
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__of_motion_65_0, sums[61]),
            );
        // r1__of_motion_67 = cos_theta2_from_theta1*r1__of_motion_63
        let r1__of_motion_67 = r1__of_motion_63
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__of_motion_63_0, sums[62]),
            );
        // r1__of_motion_68 = 9*u4_from_u3_sq + 8*u5_from_u3_sq - 3*r1__of_motion_67
        let r1__of_motion_68 = r1__of_motion_67
            .mul_add(
                -S::int(3),
                u5_from_u3_sq.mul_add(S::int(8), S::int(9) * u4_from_u3_sq),
            );
        // r1__of_motion_69 = sin_theta3_from_theta1*r1__of_motion_68
        let r1__of_motion_69 = r1__of_motion_68
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__of_motion_68_0, sums[63]),
            );
        // r1__of_motion_70 = 3*r1__of_motion_66 + r1__of_motion_69
        let r1__of_motion_70 = S::int(3) * r1__of_motion_66 + r1__of_motion_69;
        // r1__of_motion_71 = cos_theta3_from_theta1*r1__of_motion_70
        let r1__of_motion_71 = r1__of_motion_70
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__of_motion_70_0, sums[64]),
            );
        // r1__of_u4_from_u3_4 = r1__of_place_23*u4_from_u3_sq
        let r1__of_u4_from_u3_4 = r1__of_place_23
            .mul_add(
                u4_from_u3_sq_0,
                u4_from_u3_sq.mul_add(r1__of_place_23_0, sums[65]),
            );
        // r1__of_motion_72 = 3*u5_from_u3_sq + r1__of_u4_from_u3_4
        let r1__of_motion_72 = S::int(3) * u5_from_u3_sq + r1__of_u4_from_u3_4;
        // r1__of_motion_73 = cos_theta2_from_theta1*r1__of_motion_72
        let r1__of_motion_73 = r1__of_motion_72
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__of_motion_72_0, sums[66]),
            );
        // r1__of_motion_74 = 3*u4_from_u3_sq + u5_from_u3_sq + r1__of_motion_73
        let r1__of_motion_74 = S::int(3) * u4_from_u3_sq + u5_from_u3_sq + r1__of_motion_73;
        // r1__of_motion_75 = sin_theta3_from_theta1*r1__of_motion_74
        let r1__of_motion_75 = r1__of_motion_74
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__of_motion_74_0, sums[67]),
            );
        // r1__of_motion_76 = 3*u4_from_u3_sq + u5_from_u3_sq + 3*r1__of_motion_62
        let r1__of_motion_76 = r1__of_motion_62
            .mul_add(S::int(3), S::int(3) * u4_from_u3_sq + u5_from_u3_sq);
        // r1__of_motion_77 = sin_theta2_from_theta1*r1__of_motion_76
        let r1__of_motion_77 = r1__of_motion_76
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__of_motion_76_0, sums[68]),
            );
        // r1__of_motion_78 = -r1__of_motion_61 + r1__of_motion_71 - 3*r1__of_motion_75 -
        //   3*r1__of_motion_77
        let r1__of_motion_78 = r1__of_motion_75
            .mul_add(-S::int(3), -S::int(3) * r1__of_motion_77) + r1__of_motion_71
            - r1__of_motion_61;
        // r1__of_motion_79 = r1__of_motion_78/u3_of_place_8
        let r1__of_motion_79 = r1__of_motion_78
            .mul_add(
                over_u3_of_place_8,
                -(u3_of_place_8.mul_add(r1__of_motion_79_0, sums[69]) * over_u3_of_place_8),
            );
        // r1__of_place_24 = r1__of_place_16/u3_of_place_8
        let r1__of_place_24 = r1__of_place_16
            .mul_add(
                over_u3_of_place_8,
                -(u3_of_place_8.mul_add(r1__of_place_24_0, sums[70]) * over_u3_of_place_8),
            );
        // r1__of_place_25 = r1__of_place_24/r1__of_place_7
        let r1__of_place_25 = r1__of_place_24
            .mul_add(
                over_r1__of_place_7,
                -(r1__of_place_7.mul_add(r1__of_place_25_0, sums[71]) * over_r1__of_place_7),
            );
        // r1__of_motion_80 = r1__of_motion_43*r1__of_place_25
        let r1__of_motion_80 = r1__of_motion_43
            .mul_add(
                r1__of_place_25_0,
                r1__of_place_25.mul_add(r1__of_motion_43_0, sums[72]),
            );
        // r1__of_motion_81 = m_l_squared_by_12*r1__of_motion_79 + m_l_squared_by_12*r1__of_motion_80
        let r1__of_motion_81 = r1__of_motion_80
            .mul_add(m_l_squared_by_12, m_l_squared_by_12 * r1__of_motion_79);
        // u5_from_u3_dot_of_place = cos_theta2_from_theta1*cos_theta3_from_theta1
        let u5_from_u3_dot_of_place = cos_theta3_from_theta1
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(cos_theta3_from_theta1_0, sums[73]),
            );
        // u5_from_u3_dot_of_place_2 = u3_of_place_3 + u5_from_u3_dot_of_place
        let u5_from_u3_dot_of_place_2 = u3_of_place_3 + u5_from_u3_dot_of_place;
        // u5_from_u3_dot_of_place_3 = cos_theta2_from_theta1*u5_from_u3_dot_of_place_2
        let u5_from_u3_dot_of_place_3 = u5_from_u3_dot_of_place_2
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u5_from_u3_dot_of_place_2_0, sums[74]),
            );
        // u5_from_u3_dot_of_place_4 = 5*cos_theta3_from_theta1 - 9*u5_from_u3_dot_of_place_3
        let u5_from_u3_dot_of_place_4 = u5_from_u3_dot_of_place_3
            .mul_add(-S::int(9), S::int(5) * cos_theta3_from_theta1);
        // u5_from_u3_dot_of_place_5 = cos_theta3_from_theta1*u5_from_u3_dot_of_place_4
        let u5_from_u3_dot_of_place_5 = u5_from_u3_dot_of_place_4
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(u5_from_u3_dot_of_place_4_0, sums[75]),
            );
        // u5_from_u3_dot_of_place_6 = 9 + u5_from_u3_dot_of_place_5
        let u5_from_u3_dot_of_place_6 = u5_from_u3_dot_of_place_5;
        // u5_from_u3_dot_of_place_7 = r1__of_place_7/u5_from_u3_dot_of_place_6
        let u5_from_u3_dot_of_place_7 = r1__of_place_7
            .mul_add(
                over_u5_from_u3_dot_of_place_6,
                -(u5_from_u3_dot_of_place_6
                    .mul_add(u5_from_u3_dot_of_place_7_0, sums[76])
                    * over_u5_from_u3_dot_of_place_6),
            );
        // u5_from_u3_dot_of_motion = r1__of_motion_81*u5_from_u3_dot_of_place_7
        let u5_from_u3_dot_of_motion = r1__of_motion_81
            .mul_add(
                u5_from_u3_dot_of_place_7_0,
                u5_from_u3_dot_of_place_7.mul_add(r1__of_motion_81_0, sums[77]),
            );
        // u3_plus_u5_from_u3 = -u3_of_motion_2 + u5_from_u3
        let u3_plus_u5_from_u3 = u5_from_u3 - u3_of_motion_2;
        // u4_from_u3_dot_of_u5_from_u3 = cos_theta3_from_theta1*u3_plus_u5_from_u3
        let u4_from_u3_dot_of_u5_from_u3 = u3_plus_u5_from_u3
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(u3_plus_u5_from_u3_0, sums[78]),
            );
        // u4_from_u3_dot_of_place = 1 + cos_theta2_from_theta1
        let u4_from_u3_dot_of_place = cos_theta2_from_theta1;
        // u4_from_u3_dot_of_motion = sin_theta3_from_theta1*u5_from_u3_dot_of_motion
        let u4_from_u3_dot_of_motion = u5_from_u3_dot_of_motion
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(u5_from_u3_dot_of_motion_0, sums[79]),
            );
        // u4_from_u3_dot_of_motion_2 = u3_of_motion_2*r1__of_motion_3
        let u4_from_u3_dot_of_motion_2 = r1__of_motion_3
            .mul_add(
                u3_of_motion_2_0,
                u3_of_motion_2.mul_add(r1__of_motion_3_0, sums[80]),
            );
        // u4_from_u3_dot_of_motion_3 = u4_from_u3_sq + u5_from_u3_sq - 2*u4_from_u3_dot_of_motion_2
        let u4_from_u3_dot_of_motion_3 = u4_from_u3_dot_of_motion_2
            .mul_add(-S::int(2), u4_from_u3_sq + u5_from_u3_sq);
        // u4_from_u3_dot_of_motion_4 = sin_theta3_from_theta1*u4_from_u3_dot_of_motion_3
        let u4_from_u3_dot_of_motion_4 = u4_from_u3_dot_of_motion_3
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(u4_from_u3_dot_of_motion_3_0, sums[81]),
            );
        // u4_from_u3_dot_of_motion_5 = u3_of_motion_2*u3_plus_u5_from_u3
        let u4_from_u3_dot_of_motion_5 = u3_plus_u5_from_u3
            .mul_add(
                u3_of_motion_2_0,
                u3_of_motion_2.mul_add(u3_plus_u5_from_u3_0, sums[82]),
            );
        // u4_from_u3_dot_of_motion_6 = -9*u3_of_motion_2 + 9*u4_from_u3 + 7*u5_from_u3
        let u4_from_u3_dot_of_motion_6 = u3_of_motion_2
            .mul_add(-S::int(9), u5_from_u3.mul_add(S::int(7), S::int(9) * u4_from_u3));
        // u4_from_u3_dot_of_motion_7 = 2*u4_from_u3_sq + u5_from_u3_sq
        let u4_from_u3_dot_of_motion_7 = S::int(2) * u4_from_u3_sq + u5_from_u3_sq;
        // u4_from_u3_dot_of_motion_8 = sin_theta2_from_theta1*u5_from_u3_dot_of_motion
        let u4_from_u3_dot_of_motion_8 = u5_from_u3_dot_of_motion
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(u5_from_u3_dot_of_motion_0, sums[83]),
            );
        // u4_from_u3_dot_of_motion_9 = cos_theta2_from_theta1*u4_from_u3_dot_of_motion_7
        let u4_from_u3_dot_of_motion_9 = u4_from_u3_dot_of_motion_7
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u4_from_u3_dot_of_motion_7_0, sums[84]),
            );
        // u4_from_u3_dot_of_motion_10 = u3_of_motion_2*u4_from_u3_dot_of_motion_6
        let u4_from_u3_dot_of_motion_10 = u4_from_u3_dot_of_motion_6
            .mul_add(
                u3_of_motion_2_0,
                u3_of_motion_2.mul_add(u4_from_u3_dot_of_motion_6_0, sums[85]),
            );
        // u4_from_u3_dot_of_place_2 = 7 + 9*cos_theta3_from_theta1
        let u4_from_u3_dot_of_place_2 = S::int(9) * cos_theta3_from_theta1;
        // u4_from_u3_dot_of_motion_11 = u5_from_u3_dot_of_motion*u4_from_u3_dot_of_place_2
        let u4_from_u3_dot_of_motion_11 = u5_from_u3_dot_of_motion
            .mul_add(
                u4_from_u3_dot_of_place_2_0,
                u4_from_u3_dot_of_place_2.mul_add(u5_from_u3_dot_of_motion_0, sums[86]),
            );
        // u4_from_u3_dot_of_motion_12 = u3_of_motion_2*r1__of_motion_20
        let u4_from_u3_dot_of_motion_12 = r1__of_motion_20
            .mul_add(
                u3_of_motion_2_0,
                u3_of_motion_2.mul_add(r1__of_motion_20_0, sums[87]),
            );
        // u4_from_u3_dot_of_motion_13 = 7*u4_from_u3_sq + 5*u5_from_u3_sq +
        //   weight_2*u4_from_u3_dot_of_motion_8 + 3*u4_from_u3_dot_of_motion_9 - u4_from_u3_dot_of_motion_12
        let u4_from_u3_dot_of_motion_13 = u4_from_u3_dot_of_motion_8
            .mul_add(
                weight_2,
                u4_from_u3_dot_of_motion_9
                    .mul_add(
                        S::int(3),
                        u5_from_u3_sq.mul_add(S::int(5), S::int(7) * u4_from_u3_sq),
                    ) - u4_from_u3_dot_of_motion_12,
            );
        // u4_from_u3_dot_of_motion_14 = cos_theta2_from_theta1*u4_from_u3_dot_of_motion_13
        let u4_from_u3_dot_of_motion_14 = u4_from_u3_dot_of_motion_13
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u4_from_u3_dot_of_motion_13_0, sums[88]),
            );
        // u4_from_u3_dot_of_motion_15 = 9*u4_from_u3_sq + 7*u5_from_u3_sq +
        //   weight_3*u4_from_u3_dot_of_motion_8 - 2*u4_from_u3_dot_of_motion_10 -
        //   3*u4_from_u3_dot_of_motion_14
        let u4_from_u3_dot_of_motion_15 = u4_from_u3_dot_of_motion_14
            .mul_add(
                -S::int(3),
                u4_from_u3_dot_of_motion_8
                    .mul_add(
                        weight_3,
                        u4_from_u3_dot_of_motion_10
                            .mul_add(
                                -S::int(2),
                                u5_from_u3_sq.mul_add(S::int(7), S::int(9) * u4_from_u3_sq),
                            ),
                    ),
            );
        // u4_from_u3_dot_of_motion_16 = sin_theta3_from_theta1*u4_from_u3_dot_of_motion_15
        let u4_from_u3_dot_of_motion_16 = u4_from_u3_dot_of_motion_15
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(u4_from_u3_dot_of_motion_15_0, sums[89]),
            );
        // u4_from_u3_dot_of_motion_17 = u3_of_motion_2*r1__of_motion_24
        let u4_from_u3_dot_of_motion_17 = r1__of_motion_24
            .mul_add(
                u3_of_motion_2_0,
                u3_of_motion_2.mul_add(r1__of_motion_24_0, sums[90]),
            );
        // u4_from_u3_dot_of_u5_from_u3_2 = r1__of_place_19*u5_from_u3_sq
        let u4_from_u3_dot_of_u5_from_u3_2 = r1__of_place_19
            .mul_add(
                u5_from_u3_sq_0,
                u5_from_u3_sq.mul_add(r1__of_place_19_0, sums[91]),
            );
        // u4_from_u3_dot_of_motion_18 = 7*u4_from_u3_sq - u4_from_u3_dot_of_motion_17 -
        //   u4_from_u3_dot_of_u5_from_u3_2
        let u4_from_u3_dot_of_motion_18 = S::int(7) * u4_from_u3_sq
            - u4_from_u3_dot_of_u5_from_u3_2 - u4_from_u3_dot_of_motion_17;
        // u4_from_u3_dot_of_motion_19 = sin_theta2_from_theta1*u4_from_u3_dot_of_motion_18
        let u4_from_u3_dot_of_motion_19 = u4_from_u3_dot_of_motion_18
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(u4_from_u3_dot_of_motion_18_0, sums[92]),
            );
        // u4_from_u3_dot_of_place_3 = cos_theta2_from_theta1*u4_from_u3_dot_of_place
        let u4_from_u3_dot_of_place_3 = u4_from_u3_dot_of_place
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u4_from_u3_dot_of_place_0, sums[93]),
            );
        // u4_from_u3_dot_of_place_4 = 4 + 3*u4_from_u3_dot_of_place_3
        let u4_from_u3_dot_of_place_4 = S::int(3) * u4_from_u3_dot_of_place_3;
        // u4_from_u3_dot_of_motion_20 = u5_from_u3_dot_of_motion*u4_from_u3_dot_of_place_4
        let u4_from_u3_dot_of_motion_20 = u5_from_u3_dot_of_motion
            .mul_add(
                u4_from_u3_dot_of_place_4_0,
                u4_from_u3_dot_of_place_4.mul_add(u5_from_u3_dot_of_motion_0, sums[94]),
            );
        // u4_from_u3_dot_of_motion_21 = u3_of_motion_2*r1__of_motion_7
        let u4_from_u3_dot_of_motion_21 = r1__of_motion_7
            .mul_add(
                u3_of_motion_2_0,
                u3_of_motion_2.mul_add(r1__of_motion_7_0, sums[95]),
            );
        // u4_from_u3_dot_of_place_5 = 2 + cos_theta3_from_theta1 + 3*r1__of_place_9
        let u4_from_u3_dot_of_place_5 = r1__of_place_9
            .mul_add(S::int(3), cos_theta3_from_theta1);
        // u4_from_u3_dot_of_motion_22 = cos_theta2_from_theta1*u4_from_u3_dot_of_motion_3
        let u4_from_u3_dot_of_motion_22 = u4_from_u3_dot_of_motion_3
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u4_from_u3_dot_of_motion_3_0, sums[96]),
            );
        // u4_from_u3_dot_of_motion_23 = 2*u4_from_u3_sq + u5_from_u3_sq +
        //   weight_4*u4_from_u3_dot_of_motion + 2*r1__of_motion_5 - 2*u4_from_u3_dot_of_motion_21
        let u4_from_u3_dot_of_motion_23 = u4_from_u3_dot_of_motion
            .mul_add(
                weight_4,
                u4_from_u3_dot_of_motion_21
                    .mul_add(
                        -S::int(2),
                        r1__of_motion_5
                            .mul_add(
                                S::int(2),
                                S::int(2) * u4_from_u3_sq + u5_from_u3_sq,
                            ),
                    ),
            );
        // u4_from_u3_dot_of_motion_24 = sin_theta2_from_theta1*u4_from_u3_dot_of_motion_23
        let u4_from_u3_dot_of_motion_24 = u4_from_u3_dot_of_motion_23
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(u4_from_u3_dot_of_motion_23_0, sums[97]),
            );
        // u4_from_u3_dot_of_motion_25 = u5_from_u3_sq - 2*u4_from_u3_dot_of_motion_5 +
        //   6*u4_from_u3_dot_of_motion_22
        let u4_from_u3_dot_of_motion_25 = u4_from_u3_dot_of_motion_22
            .mul_add(
                S::int(6),
                u4_from_u3_dot_of_motion_5.mul_add(-S::int(2), u5_from_u3_sq),
            );
        // u4_from_u3_dot_of_motion_26 = sin_theta3_from_theta1*u4_from_u3_dot_of_motion_25
        let u4_from_u3_dot_of_motion_26 = u4_from_u3_dot_of_motion_25
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(u4_from_u3_dot_of_motion_25_0, sums[98]),
            );
        // u4_from_u3_dot_of_motion_27 = u5_from_u3_dot_of_motion*u4_from_u3_dot_of_place_5
        let u4_from_u3_dot_of_motion_27 = u5_from_u3_dot_of_motion
            .mul_add(
                u4_from_u3_dot_of_place_5_0,
                u4_from_u3_dot_of_place_5.mul_add(u5_from_u3_dot_of_motion_0, sums[99]),
            );
        // u4_from_u3_dot_of_motion_28 = 3*u4_from_u3_dot_of_motion_24 - u4_from_u3_dot_of_motion_26 +
        //   weight_5*u4_from_u3_dot_of_motion_27
        let u4_from_u3_dot_of_motion_28 = u4_from_u3_dot_of_motion_24
            .mul_add(
                S::int(3),
                u4_from_u3_dot_of_motion_27
                    .mul_add(weight_5, -u4_from_u3_dot_of_motion_26),
            );
        // u4_from_u3_dot_of_motion_29 = cos_theta2_from_theta1*u4_from_u3_dot_of_motion_28
        let u4_from_u3_dot_of_motion_29 = u4_from_u3_dot_of_motion_28
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u4_from_u3_dot_of_motion_28_0, sums[100]),
            );
        // u4_from_u3_dot_of_motion_30 = -15*u3_of_motion_2 + 14*u4_from_u3 + 12*u5_from_u3 +
        //   2*u4_from_u3_dot_of_u5_from_u3
        let u4_from_u3_dot_of_motion_30 = u4_from_u3_dot_of_u5_from_u3
            .mul_add(
                S::int(2),
                u3_of_motion_2
                    .mul_add(
                        -S::int(15),
                        u5_from_u3.mul_add(S::int(12), S::int(14) * u4_from_u3),
                    ),
            );
        // u4_from_u3_dot_of_motion_31 = u3_of_motion_2*u4_from_u3_dot_of_motion_30
        let u4_from_u3_dot_of_motion_31 = u4_from_u3_dot_of_motion_30
            .mul_add(
                u3_of_motion_2_0,
                u3_of_motion_2.mul_add(u4_from_u3_dot_of_motion_30_0, sums[101]),
            );
        // u4_from_u3_dot_of_motion_32 = 7*u4_from_u3_sq + weight_5*u4_from_u3_dot_of_motion +
        //   r1__of_u5_from_u3_4 - u4_from_u3_dot_of_motion_31
        let u4_from_u3_dot_of_motion_32 = u4_from_u3_dot_of_motion
            .mul_add(
                weight_5,
                S::int(7) * u4_from_u3_sq + r1__of_u5_from_u3_4 - u4_from_u3_dot_of_motion_31,
            );
        // u4_from_u3_dot_of_motion_33 = sin_theta2_from_theta1*u4_from_u3_dot_of_motion_32
        let u4_from_u3_dot_of_motion_33 = u4_from_u3_dot_of_motion_32
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(u4_from_u3_dot_of_motion_32_0, sums[102]),
            );
        // u4_from_u3_dot_of_motion_34 = 9*u4_from_u3_dot_of_motion_4 +
        //   weight_6*u4_from_u3_dot_of_motion_11 + 3*u4_from_u3_dot_of_motion_29 +
        //   3*u4_from_u3_dot_of_motion_33
        let u4_from_u3_dot_of_motion_34 = u4_from_u3_dot_of_motion_29
            .mul_add(
                S::int(3),
                u4_from_u3_dot_of_motion_33
                    .mul_add(
                        S::int(3),
                        u4_from_u3_dot_of_motion_11
                            .mul_add(weight_6, S::int(9) * u4_from_u3_dot_of_motion_4),
                    ),
            );
        // u4_from_u3_dot_of_motion_35 = cos_theta3_from_theta1*u4_from_u3_dot_of_motion_34
        let u4_from_u3_dot_of_motion_35 = u4_from_u3_dot_of_motion_34
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(u4_from_u3_dot_of_motion_34_0, sums[103]),
            );
        // u4_from_u3_dot_of_motion_36 = u4_from_u3_dot_of_motion_16 + 3*u4_from_u3_dot_of_motion_19 +
        //   weight_2*u4_from_u3_dot_of_motion_20 + u4_from_u3_dot_of_motion_35
        let u4_from_u3_dot_of_motion_36 = u4_from_u3_dot_of_motion_20
            .mul_add(weight_2, S::int(3) * u4_from_u3_dot_of_motion_19)
            + u4_from_u3_dot_of_motion_16 + u4_from_u3_dot_of_motion_35;
        // u4_from_u3_dot_of_motion_37 = u4_from_u3_dot_of_motion_36/r1__of_place_7
        let u4_from_u3_dot_of_motion_37 = u4_from_u3_dot_of_motion_36
            .mul_add(
                over_r1__of_place_7,
                -(r1__of_place_7.mul_add(u4_from_u3_dot_of_motion_37_0, sums[104])
                    * over_r1__of_place_7),
            );
        theta2_from_theta1_rate = u4_from_u3;
        theta3_from_theta1_rate = u5_from_u3;
        theta1_rate = -u3_of_motion_2;
        u4_from_u3_rate = -u4_from_u3_dot_of_motion_37;
        u5_from_u3_rate = weight_5 * u5_from_u3_dot_of_motion;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * theta2_from_theta1,
                count * theta2_from_theta1,
                count * theta3_from_theta1,
                count * theta3_from_theta1,
                cos_theta2_from_theta1, sin_theta2_from_theta1, cos_theta3_from_theta1,
                u3_of_place_4, u3_of_place_7, u3_of_place_8, u4_from_u3, u5_from_u3, u3_of_motion_2,
                cos_theta3_from_theta1, cos_theta3_from_theta1, cos_theta2_from_theta1,
                cos_theta3_from_theta1, cos_theta2_from_theta1, cos_theta2_from_theta1,
                cos_theta3_from_theta1, cos_theta2_from_theta1, cos_theta3_from_theta1,
                cos_theta2_from_theta1, u3_of_motion_2, u5_from_u3, sin_theta2_from_theta1,
                cos_theta2_from_theta1, cos_theta2_from_theta1, sin_theta3_from_theta1,
                cos_theta3_from_theta1, cos_theta2_from_theta1, cos_theta2_from_theta1,
                sin_theta3_from_theta1, u5_from_u3, sin_theta2_from_theta1, u3_of_motion_2,
                cos_theta2_from_theta1, r1__of_place_20, sin_theta3_from_theta1,
                cos_theta3_from_theta1, sin_theta2_from_theta1, cos_theta2_from_theta1,
                r1__of_place_18, cos_theta3_from_theta1, sin_theta2_from_theta1,
                sin_theta3_from_theta1, cos_theta3_from_theta1, u3_of_motion_2, u4_from_u3,
                sin_theta2_from_theta1, cos_theta2_from_theta1, sin_theta3_from_theta1,
                cos_theta3_from_theta1, u4_from_u3, cos_theta2_from_theta1, sin_theta3_from_theta1,
                sin_theta2_from_theta1, u3_of_motion_2, cos_theta2_from_theta1,
                cos_theta3_from_theta1, r1__of_place_22, sin_theta2_from_theta1,
                cos_theta2_from_theta1, sin_theta3_from_theta1, cos_theta3_from_theta1,
                r1__of_place_23, cos_theta2_from_theta1, sin_theta3_from_theta1,
                sin_theta2_from_theta1, u3_of_place_8, u3_of_place_8, r1__of_place_7,
                r1__of_motion_43, cos_theta2_from_theta1, cos_theta2_from_theta1,
                cos_theta3_from_theta1, u5_from_u3_dot_of_place_6, r1__of_motion_81,
                cos_theta3_from_theta1, sin_theta3_from_theta1, u3_of_motion_2,
                sin_theta3_from_theta1, u3_of_motion_2, sin_theta2_from_theta1,
                cos_theta2_from_theta1, u3_of_motion_2, u5_from_u3_dot_of_motion, u3_of_motion_2,
                cos_theta2_from_theta1, sin_theta3_from_theta1, u3_of_motion_2, r1__of_place_19,
                sin_theta2_from_theta1, cos_theta2_from_theta1, u5_from_u3_dot_of_motion,
                u3_of_motion_2, cos_theta2_from_theta1, sin_theta2_from_theta1,
                sin_theta3_from_theta1, u5_from_u3_dot_of_motion, cos_theta2_from_theta1,
                u3_of_motion_2, sin_theta2_from_theta1, cos_theta3_from_theta1, r1__of_place_7,
            ]),
            padded([
                cos_theta2_from_theta1, sin_theta2_from_theta1, cos_theta3_from_theta1,
                sin_theta3_from_theta1, u3_of_place, sin_theta3_from_theta1, u3_of_place_5,
                u4_from_u3, u5_from_u3, u3_of_motion_2, u4_from_u3, u5_from_u3, r1__of_place,
                r1__of_motion_3, r1__of_motion_2, r1__of_place_2, r1__of_place_4, u3_of_place_3,
                r1__of_place_8, r1__of_place_10, r1__of_place_12, r1__of_place_14, r1__of_motion_7,
                r1__of_place_17, r1__of_place_18, r1__of_motion_10, r1__of_motion_3,
                r1__of_motion_13, r1__of_motion_15, r1__of_motion_17, r1__of_motion_6,
                r1__of_motion_20, r1__of_motion_22, r1__of_place_19, r1__of_motion_24,
                r1__of_motion_26, r1__of_motion_28, u5_from_u3_sq, r1__of_motion_30,
                r1__of_motion_28, r1__of_motion_33, r1__of_motion_35, u5_from_u3_sq,
                r1__of_motion_37, r1__of_motion_39, r1__of_motion_41, r1__of_motion_44,
                r1__of_place_21, r1__of_place_22, r1__of_motion_47, r1__of_motion_44,
                r1__of_motion_50, r1__of_motion_52, r1__of_place_23, r1__of_motion_54,
                r1__of_motion_56, r1__of_motion_58, r1__of_motion_60, r1__of_motion_2,
                r1__of_motion_63, u4_from_u3_sq, r1__of_motion_65, r1__of_motion_63,
                r1__of_motion_68, r1__of_motion_70, u4_from_u3_sq, r1__of_motion_72,
                r1__of_motion_74, r1__of_motion_76, r1__of_motion_79, r1__of_place_24,
                r1__of_place_25, r1__of_place_25, cos_theta3_from_theta1, u5_from_u3_dot_of_place_2,
                u5_from_u3_dot_of_place_4, u5_from_u3_dot_of_place_7, u5_from_u3_dot_of_place_7,
                u3_plus_u5_from_u3, u5_from_u3_dot_of_motion, r1__of_motion_3,
                u4_from_u3_dot_of_motion_3, u3_plus_u5_from_u3, u5_from_u3_dot_of_motion,
                u4_from_u3_dot_of_motion_7, u4_from_u3_dot_of_motion_6, u4_from_u3_dot_of_place_2,
                r1__of_motion_20, u4_from_u3_dot_of_motion_13, u4_from_u3_dot_of_motion_15,
                r1__of_motion_24, u5_from_u3_sq, u4_from_u3_dot_of_motion_18,
                u4_from_u3_dot_of_place, u4_from_u3_dot_of_place_4, r1__of_motion_7,
                u4_from_u3_dot_of_motion_3, u4_from_u3_dot_of_motion_23,
                u4_from_u3_dot_of_motion_25, u4_from_u3_dot_of_place_5, u4_from_u3_dot_of_motion_28,
                u4_from_u3_dot_of_motion_30, u4_from_u3_dot_of_motion_32,
                u4_from_u3_dot_of_motion_34, u4_from_u3_dot_of_motion_37,
            ]),
        ];
        count_last = count;
        theta2_from_theta1_last = theta2_from_theta1;
        theta3_from_theta1_last = theta3_from_theta1;
        u4_from_u3_last = u4_from_u3;
        u5_from_u3_last = u5_from_u3;
        sin_theta2_from_theta1_last = sin_theta2_from_theta1;
        cos_theta2_from_theta1_last = cos_theta2_from_theta1;
        sin_theta3_from_theta1_last = sin_theta3_from_theta1;
        cos_theta3_from_theta1_last = cos_theta3_from_theta1;
        u3_of_place_last = u3_of_place;
        u3_of_place_3_last = u3_of_place_3;
        u3_of_place_4_last = u3_of_place_4;
        u3_of_place_5_last = u3_of_place_5;
        u3_of_place_7_last = u3_of_place_7;
        u3_of_place_8_last = u3_of_place_8;
        u3_of_motion_2_last = u3_of_motion_2;
        u4_from_u3_sq_last = u4_from_u3_sq;
        u5_from_u3_sq_last = u5_from_u3_sq;
        r1__of_place_last = r1__of_place;
        r1__of_motion_2_last = r1__of_motion_2;
        r1__of_motion_3_last = r1__of_motion_3;
        r1__of_place_2_last = r1__of_place_2;
        r1__of_place_4_last = r1__of_place_4;
        r1__of_place_7_last = r1__of_place_7;
        r1__of_place_8_last = r1__of_place_8;
        r1__of_place_10_last = r1__of_place_10;
        r1__of_place_12_last = r1__of_place_12;
        r1__of_place_14_last = r1__of_place_14;
        r1__of_motion_6_last = r1__of_motion_6;
        r1__of_motion_7_last = r1__of_motion_7;
        r1__of_place_17_last = r1__of_place_17;
        r1__of_place_18_last = r1__of_place_18;
        r1__of_motion_10_last = r1__of_motion_10;
        r1__of_motion_13_last = r1__of_motion_13;
        r1__of_motion_15_last = r1__of_motion_15;
        r1__of_motion_17_last = r1__of_motion_17;
        r1__of_motion_20_last = r1__of_motion_20;
        r1__of_motion_22_last = r1__of_motion_22;
        r1__of_place_19_last = r1__of_place_19;
        r1__of_motion_24_last = r1__of_motion_24;
        r1__of_motion_26_last = r1__of_motion_26;
        r1__of_motion_28_last = r1__of_motion_28;
        r1__of_place_20_last = r1__of_place_20;
        r1__of_motion_30_last = r1__of_motion_30;
        r1__of_motion_33_last = r1__of_motion_33;
        r1__of_motion_35_last = r1__of_motion_35;
        r1__of_motion_37_last = r1__of_motion_37;
        r1__of_motion_39_last = r1__of_motion_39;
        r1__of_motion_41_last = r1__of_motion_41;
        r1__of_motion_43_last = r1__of_motion_43;
        r1__of_motion_44_last = r1__of_motion_44;
        r1__of_place_21_last = r1__of_place_21;
        r1__of_place_22_last = r1__of_place_22;
        r1__of_motion_47_last = r1__of_motion_47;
        r1__of_motion_50_last = r1__of_motion_50;
        r1__of_motion_52_last = r1__of_motion_52;
        r1__of_place_23_last = r1__of_place_23;
        r1__of_motion_54_last = r1__of_motion_54;
        r1__of_motion_56_last = r1__of_motion_56;
        r1__of_motion_58_last = r1__of_motion_58;
        r1__of_motion_60_last = r1__of_motion_60;
        r1__of_motion_63_last = r1__of_motion_63;
        r1__of_motion_65_last = r1__of_motion_65;
        r1__of_motion_68_last = r1__of_motion_68;
        r1__of_motion_70_last = r1__of_motion_70;
        r1__of_motion_72_last = r1__of_motion_72;
        r1__of_motion_74_last = r1__of_motion_74;
        r1__of_motion_76_last = r1__of_motion_76;
        r1__of_motion_79_last = r1__of_motion_79;
        r1__of_place_24_last = r1__of_place_24;
        r1__of_place_25_last = r1__of_place_25;
        r1__of_motion_81_last = r1__of_motion_81;
        u5_from_u3_dot_of_place_2_last = u5_from_u3_dot_of_place_2;
        u5_from_u3_dot_of_place_4_last = u5_from_u3_dot_of_place_4;
        u5_from_u3_dot_of_place_6_last = u5_from_u3_dot_of_place_6;
        u5_from_u3_dot_of_place_7_last = u5_from_u3_dot_of_place_7;
        u5_from_u3_dot_of_motion_last = u5_from_u3_dot_of_motion;
        u3_plus_u5_from_u3_last = u3_plus_u5_from_u3;
        u4_from_u3_dot_of_place_last = u4_from_u3_dot_of_place;
        u4_from_u3_dot_of_motion_3_last = u4_from_u3_dot_of_motion_3;
        u4_from_u3_dot_of_motion_6_last = u4_from_u3_dot_of_motion_6;
        u4_from_u3_dot_of_motion_7_last = u4_from_u3_dot_of_motion_7;
        u4_from_u3_dot_of_place_2_last = u4_from_u3_dot_of_place_2;
        u4_from_u3_dot_of_motion_13_last = u4_from_u3_dot_of_motion_13;
        u4_from_u3_dot_of_motion_15_last = u4_from_u3_dot_of_motion_15;
        u4_from_u3_dot_of_motion_18_last = u4_from_u3_dot_of_motion_18;
        u4_from_u3_dot_of_place_4_last = u4_from_u3_dot_of_place_4;
        u4_from_u3_dot_of_place_5_last = u4_from_u3_dot_of_place_5;
        u4_from_u3_dot_of_motion_23_last = u4_from_u3_dot_of_motion_23;
        u4_from_u3_dot_of_motion_25_last = u4_from_u3_dot_of_motion_25;
        u4_from_u3_dot_of_motion_28_last = u4_from_u3_dot_of_motion_28;
        u4_from_u3_dot_of_motion_30_last = u4_from_u3_dot_of_motion_30;
        u4_from_u3_dot_of_motion_32_last = u4_from_u3_dot_of_motion_32;
        u4_from_u3_dot_of_motion_34_last = u4_from_u3_dot_of_motion_34;
        u4_from_u3_dot_of_motion_37_last = u4_from_u3_dot_of_motion_37;
    }
}

/// Reduced equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Reduced;

impl<S: Scalar> System<S> for Reduced {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 12,
            coordinates: 3,
            variables: 2,
            speeds: 2,
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
    fn output_count(&self) -> usize {
        10
    }
    fn outputs(&self, p: &[S], t: S, q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&outputs(&Parameters::from_slice(p), t, array(q), array(v)));
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
    fn has_energy_gradient(&self) -> bool {
        true
    }
    fn energy_gradient(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) -> S {
        let [energy, gradient @ ..] = energy_gradient(
            &Parameters::from_slice(p),
            array(q),
            array(v),
        );
        out.copy_from_slice(&gradient);
        energy
    }
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, order: usize) -> usize {
        224 * order + SLACK
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
        1
    }
    fn divisor_name(&self, at: usize) -> &str {
        ["divisor 1 of the accelerations"][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
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

/// What a program needs to find these equations and to trust them.
pub const SCENE: CompiledScene = CompiledScene {
    name: "folding",
    key: "2af0f3bf0c76edd2",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: None,
    },
};
