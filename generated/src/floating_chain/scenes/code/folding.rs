//! Chain of three rods floating in a plane: Folding.
//!
//! Generated from `models/floating_chain/scenes/folding.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::{
    CompiledScene, CompiledSystem, Derivative, Dual, InLanes, Lengths, Scalar, System,
    by_columns,
};

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
/// 237 operations, 2 sines and cosines.
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
    let u3_of_place_3 = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    let u3_of_place_3_times_3 = S::int(3) * u3_of_place_3;
    let u3_of_place_4 = S::int(6) * cos_theta2_from_theta1;
    let u3_of_place_5 = S::int(2) * cos_theta3_from_theta1;
    let u3_of_place_3_times_6 = S::int(6) * u3_of_place_3;
    // 13 + u3_of_place*u3_of_place_4 + u3_of_place_5 + u3_of_place_3_times_6
    let u3_of_place_6 = u3_of_place.mul_add(u3_of_place_4, S::int(13)) + u3_of_place_5
        + u3_of_place_3_times_6;
    let u3_of_place_6_inv = S::int(1) / u3_of_place_6;
    // u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3 = u3_of_place_6_inv
        * (H_n3_scaled_per_m_per_l_squared
            - u4_from_u3 * (u3_of_place.mul_add(u3_of_place_2, S::int(7)) + u3_of_place_3_times_3)
            - u5_from_u3
                * (S::int(3) + cos_theta3_from_theta1 * (S::int(1) + u3_of_place_2)
                    + u3_of_place_3_times_3));
    let r1__of_place = m_l_squared_by_12 * u3_of_place_6_inv;
    // 3 + cos(theta2_from_theta1)
    let r1__of_place_2 = S::int(3) + cos_theta2_from_theta1;
    // u3 + u5_from_u3
    let u3_plus_u5_from_u3 = u3 + u5_from_u3;
    // u3 + u4_from_u3
    let u3_plus_u4_from_u3 = u3 + u4_from_u3;
    // u5_from_u3 + u3_plus_u4_from_u3
    let r1__of_motion = u5_from_u3 + u3_plus_u4_from_u3;
    let r1__of_motion_2 = u3_of_place_4 * r1__of_motion;
    // u4_from_u3 + 2*u3_plus_u5_from_u3 + r1__of_motion_2
    let r1__of_motion_3 = u3_plus_u5_from_u3.mul_add(S::int(2), u4_from_u3) + r1__of_motion_2;
    let u5_from_u3_times_6 = S::int(6) * u5_from_u3;
    let r1__of_place_3 = S::int(3) * sin_theta2_from_theta1;
    let r1__of_place_4 = S::int(2) * sin_theta3_from_theta1;
    // 10 + u3_of_place_2
    let r1__of_place_5 = S::int(10) + u3_of_place_2;
    let u3_times_13 = S::int(13) * u3;
    let u5_from_u3_sq = u5_from_u3 * u5_from_u3;
    let u4_from_u3_sq = u4_from_u3 * u4_from_u3;
    // u5_from_u3_sq + u4_from_u3_sq
    let r1__of_motion_4 = u5_from_u3_sq + u4_from_u3_sq;
    // 2*u5_from_u3_sq + u4_from_u3_sq + u3_of_place_4*r1__of_motion_4
    let r1__of_motion_5 = u5_from_u3_sq.mul_add(S::int(2), u4_from_u3_sq)
        + u3_of_place_4 * r1__of_motion_4;
    let u4_from_u3_sq_times_9 = S::int(9) * u4_from_u3_sq;
    let u4_from_u3_sq_times_3 = S::int(3) * u4_from_u3_sq;
    let u5_from_u3_sq_times_3 = S::int(3) * u5_from_u3_sq;
    // u5_from_u3_sq + u4_from_u3_sq_times_3
    let r1__of_motion_6 = u5_from_u3_sq + u4_from_u3_sq_times_3;
    let r1__of_place_6 = S::int(9) * cos_theta3_from_theta1;
    // 9*u3_of_place_3 - 12 + u3_of_place_2*(u3_of_place_3_times_3 - 3 - u3_of_place_2 +
    //   cos(theta3_from_theta1)*(2 + cos(theta3_from_theta1) + u3_of_place_2*(1 + u3_of_place_5) +
    //   u3_of_place_3_times_6)) + cos(theta3_from_theta1)*(u3_of_place_3_times_3 - 7 - r1__of_place_6)
    let r1__of_place_7 = -S::int(12) + S::int(9) * u3_of_place_3
        + u3_of_place_2
            * (u3_of_place_3_times_3 - S::int(3) - u3_of_place_2
                + cos_theta3_from_theta1
                    * (S::int(2) + cos_theta3_from_theta1
                        + u3_of_place_2 * (S::int(1) + u3_of_place_5) + u3_of_place_3_times_6))
        + cos_theta3_from_theta1 * (u3_of_place_3_times_3 - S::int(7) - r1__of_place_6);
    // u5_from_u3 + 2*u3_plus_u4_from_u3
    let r1__of_motion_7 = u3_plus_u4_from_u3.mul_add(S::int(2), u5_from_u3);
    let u4_from_u3_times_14 = S::int(14) * u4_from_u3;
    // 6 + cos(theta3_from_theta1)
    let r1__of_place_8 = S::int(6) + cos_theta3_from_theta1;
    let u5_from_u3_doubled = S::int(2) * u5_from_u3;
    // u3_times_13 + u4_from_u3_times_14
    let r1__of_u4_from_u3 = u3_times_13 + u4_from_u3_times_14;
    // u5_from_u3_sq + 2*u4_from_u3_sq + u3_of_place_5*r1__of_motion_4
    let r1__of_motion_8 = u4_from_u3_sq.mul_add(S::int(2), u5_from_u3_sq)
        + u3_of_place_5 * r1__of_motion_4;
    let u4_from_u3_sq_times_7 = S::int(7) * u4_from_u3_sq;
    // sin(theta3_from_theta1)*(7*u5_from_u3_sq + u4_from_u3_sq_times_9 + r1__of_motion_4*r1__of_place_6) +
    //   u3*(3*cos(theta3_from_theta1)*(r1__of_place_4*(3*r1__of_motion -
    //   cos(theta2_from_theta1)*(u3_plus_u5_from_u3 + r1__of_motion_2)) + sin(theta2_from_theta1)*(u3*(15 +
    //   u3_of_place_5) + u3_of_place_4*(u3_of_place_5*r1__of_motion + r1__of_motion_7) + u4_from_u3_times_14
    //   + r1__of_place_8*u5_from_u3_doubled)) + sin(theta3_from_theta1)*(14*u5_from_u3 +
    //   18*u3_plus_u4_from_u3 - u3_of_place_2*(10*u5_from_u3 + u3_of_place_4*r1__of_motion_7 +
    //   r1__of_u4_from_u3)) + r1__of_place_3*(u5_from_u3_doubled*(1 - u3_of_place_2) + r1__of_u4_from_u3)) -
    //   u3_of_place_2*(r1__of_place_3*(u5_from_u3_sq - r1__of_motion_8*cos(theta3_from_theta1)) +
    //   sin(theta3_from_theta1)*(u5_from_u3_sq*(5 + cos(theta3_from_theta1)) + u3_of_place_2*r1__of_motion_8
    //   + u4_from_u3_sq_times_7)) + r1__of_place_3*(u5_from_u3_sq + u4_from_u3_sq_times_7 +
    //   cos(theta3_from_theta1)*(u5_from_u3_sq*r1__of_place_8 + u4_from_u3_sq_times_7))
    let r1__of_motion_9 = sin_theta3_from_theta1
        * (u5_from_u3_sq.mul_add(S::int(7), u4_from_u3_sq_times_9)
            + r1__of_motion_4 * r1__of_place_6)
        + u3
            * (S::int(3) * cos_theta3_from_theta1
                * (r1__of_place_4
                    * (-cos_theta2_from_theta1 * (u3_plus_u5_from_u3 + r1__of_motion_2)
                        + S::int(3) * r1__of_motion)
                    + sin_theta2_from_theta1
                        * (u3 * (S::int(15) + u3_of_place_5)
                            + u3_of_place_4 * u3_of_place_5.mul_add(r1__of_motion, r1__of_motion_7)
                            + u4_from_u3_times_14 + r1__of_place_8 * u5_from_u3_doubled))
                + sin_theta3_from_theta1
                    * (S::int(14) * u5_from_u3 + S::int(18) * u3_plus_u4_from_u3
                        - u3_of_place_2
                            * (u3_of_place_4
                                .mul_add(r1__of_motion_7, S::int(10) * u5_from_u3)
                                + r1__of_u4_from_u3))
                + r1__of_place_3
                    * (u5_from_u3_doubled * (S::int(1) - u3_of_place_2) + r1__of_u4_from_u3))
        - u3_of_place_2
            * (r1__of_place_3 * (-r1__of_motion_8).mul_add(cos_theta3_from_theta1, u5_from_u3_sq)
                + sin_theta3_from_theta1
                    * (u5_from_u3_sq * (S::int(5) + cos_theta3_from_theta1)
                        + u3_of_place_2 * r1__of_motion_8 + u4_from_u3_sq_times_7))
        + r1__of_place_3
            * (u5_from_u3_sq + u4_from_u3_sq_times_7
                + cos_theta3_from_theta1
                    * u5_from_u3_sq.mul_add(r1__of_place_8, u4_from_u3_sq_times_7));
    let r1__of_place_9 = S::int(18) * cos_theta2_from_theta1;
    // 33 - u3_of_place_3*r1__of_place_9 + cos(theta3_from_theta1)*(14 + r1__of_place_6 -
    //   r1__of_place_9*(u3_of_place*cos(theta2_from_theta1) + u3_of_place_3))
    let r1__of_place_10 = S::int(33) - u3_of_place_3 * r1__of_place_9
        + cos_theta3_from_theta1
            * (S::int(14) + r1__of_place_6
                - r1__of_place_9 * u3_of_place.mul_add(cos_theta2_from_theta1, u3_of_place_3));
    let r1__of_place_10_inv = S::int(1) / r1__of_place_10;
    // u3*(cos(theta3_from_theta1)*(r1__of_place_3*(u3*(13 + u3_of_place_4) + 6*u4_from_u3*r1__of_place_2 +
    //   u3_of_place_5*r1__of_motion_3 + u5_from_u3_times_6) + r1__of_place_4*(9*u4_from_u3 +
    //   8*u3_plus_u5_from_u3 - u3_of_place_2*r1__of_motion_3)) - 6*sin(theta2_from_theta1)*(3*u4_from_u3 +
    //   u3_plus_u5_from_u3 + u3_of_place_2*r1__of_motion) - sin(theta3_from_theta1)*(18*u4_from_u3 +
    //   u5_from_u3_times_6 + u3_of_place_2*(3*u3*(5 + 2*cos(theta2_from_theta1)) + u5_from_u3_times_6 +
    //   2*u4_from_u3*r1__of_place_5) + u3_times_13)) +
    //   cos(theta3_from_theta1)*(sin(theta3_from_theta1)*(8*u5_from_u3_sq - u3_of_place_2*r1__of_motion_5 +
    //   u4_from_u3_sq_times_9) + r1__of_place_3*(r1__of_motion_5*cos(theta3_from_theta1) +
    //   r1__of_place_2*u4_from_u3_sq_times_3 + u5_from_u3_sq_times_3)) -
    //   3*sin(theta3_from_theta1)*(cos(theta2_from_theta1)*(r1__of_place_5*u4_from_u3_sq +
    //   u5_from_u3_sq_times_3) + r1__of_motion_6) - r1__of_place_3*(u3_of_place_2*r1__of_motion_4 +
    //   r1__of_motion_6)
    let r1__of_motion_10 = u3
        * (cos_theta3_from_theta1
            * (r1__of_place_3
                * (u3 * (S::int(13) + u3_of_place_4) + S::int(6) * u4_from_u3 * r1__of_place_2
                    + u3_of_place_5 * r1__of_motion_3 + u5_from_u3_times_6)
                + r1__of_place_4
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
                            + S::int(2) * u4_from_u3 * r1__of_place_5) + u3_times_13))
        + cos_theta3_from_theta1
            * (sin_theta3_from_theta1
                * ((-u3_of_place_2).mul_add(r1__of_motion_5, S::int(8) * u5_from_u3_sq)
                    + u4_from_u3_sq_times_9)
                + r1__of_place_3
                    * (r1__of_place_2
                        .mul_add(
                            u4_from_u3_sq_times_3,
                            r1__of_motion_5 * cos_theta3_from_theta1,
                        ) + u5_from_u3_sq_times_3))
        - S::int(3) * sin_theta3_from_theta1
            * (cos_theta2_from_theta1 * r1__of_place_5.mul_add(u4_from_u3_sq, u5_from_u3_sq_times_3)
                + r1__of_motion_6)
        - r1__of_place_3 * u3_of_place_2.mul_add(r1__of_motion_4, r1__of_motion_6);
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
    let r1_ = r1__of_place
        * (r1__of_place_7 * r1__of_motion_9)
            .mul_add(r1__of_place_10_inv, r1__of_motion_10);
    let m_l_squared_by_12_inv = S::int(1) / m_l_squared_by_12;
    // u5_from_u3' = r1_*(33 - 18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(4*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot = S::ratio(1, 4) * r1_ * r1__of_place_10 * m_l_squared_by_12_inv
        / (S::int(9)
            + cos_theta3_from_theta1
                * (-S::int(9) * cos_theta2_from_theta1
                    * cos_theta2_from_theta1
                        .mul_add(cos_theta3_from_theta1, u3_of_place_3)
                    + S::int(5) * cos_theta3_from_theta1));
    // u4_from_u3' = (13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(m_l_squared_by_12*(u3*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15
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
    //   7*u5_from_u3^2 + 9*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   u5_from_u3'*m_l_squared_by_12*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))/(m_l_squared_by_12*(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1)
    //   - 33 - cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))))
    let u4_from_u3_dot = -u3_of_place_6 * r1__of_place * r1__of_place_10_inv * m_l_squared_by_12_inv
        * u5_from_u3_dot.mul_add(r1__of_place_7, r1__of_motion_9);
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
/// 237 operations, 2 sines and cosines.
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
    let u3_of_place_3 = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    let u3_of_place_3_times_3 = S::int(3) * u3_of_place_3;
    let u3_of_place_4 = S::int(6) * cos_theta2_from_theta1;
    let u3_of_place_5 = S::int(2) * cos_theta3_from_theta1;
    let u3_of_place_3_times_6 = S::int(6) * u3_of_place_3;
    // 13 + u3_of_place*u3_of_place_4 + u3_of_place_5 + u3_of_place_3_times_6
    let u3_of_place_6 = u3_of_place.mul_add(u3_of_place_4, S::int(13)) + u3_of_place_5
        + u3_of_place_3_times_6;
    let u3_of_place_6_inv = S::int(1) / u3_of_place_6;
    // u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3 = u3_of_place_6_inv
        * (H_n3_scaled_per_m_per_l_squared
            - u4_from_u3 * (u3_of_place.mul_add(u3_of_place_2, S::int(7)) + u3_of_place_3_times_3)
            - u5_from_u3
                * (S::int(3) + cos_theta3_from_theta1 * (S::int(1) + u3_of_place_2)
                    + u3_of_place_3_times_3));
    let r1__of_place = m_l_squared_by_12 * u3_of_place_6_inv;
    // 3 + cos(theta2_from_theta1)
    let r1__of_place_2 = S::int(3) + cos_theta2_from_theta1;
    // u3 + u5_from_u3
    let u3_plus_u5_from_u3 = u3 + u5_from_u3;
    // u3 + u4_from_u3
    let u3_plus_u4_from_u3 = u3 + u4_from_u3;
    // u5_from_u3 + u3_plus_u4_from_u3
    let r1__of_motion = u5_from_u3 + u3_plus_u4_from_u3;
    let r1__of_motion_2 = u3_of_place_4 * r1__of_motion;
    // u4_from_u3 + 2*u3_plus_u5_from_u3 + r1__of_motion_2
    let r1__of_motion_3 = u3_plus_u5_from_u3.mul_add(S::int(2), u4_from_u3) + r1__of_motion_2;
    let u5_from_u3_times_6 = S::int(6) * u5_from_u3;
    let r1__of_place_3 = S::int(3) * sin_theta2_from_theta1;
    let r1__of_place_4 = S::int(2) * sin_theta3_from_theta1;
    // 10 + u3_of_place_2
    let r1__of_place_5 = S::int(10) + u3_of_place_2;
    let u3_times_13 = S::int(13) * u3;
    let u5_from_u3_sq = u5_from_u3 * u5_from_u3;
    let u4_from_u3_sq = u4_from_u3 * u4_from_u3;
    // u5_from_u3_sq + u4_from_u3_sq
    let r1__of_motion_4 = u5_from_u3_sq + u4_from_u3_sq;
    // 2*u5_from_u3_sq + u4_from_u3_sq + u3_of_place_4*r1__of_motion_4
    let r1__of_motion_5 = u5_from_u3_sq.mul_add(S::int(2), u4_from_u3_sq)
        + u3_of_place_4 * r1__of_motion_4;
    let u4_from_u3_sq_times_9 = S::int(9) * u4_from_u3_sq;
    let u4_from_u3_sq_times_3 = S::int(3) * u4_from_u3_sq;
    let u5_from_u3_sq_times_3 = S::int(3) * u5_from_u3_sq;
    // u5_from_u3_sq + u4_from_u3_sq_times_3
    let r1__of_motion_6 = u5_from_u3_sq + u4_from_u3_sq_times_3;
    let r1__of_place_6 = S::int(9) * cos_theta3_from_theta1;
    // 9*u3_of_place_3 - 12 + u3_of_place_2*(u3_of_place_3_times_3 - 3 - u3_of_place_2 +
    //   cos(theta3_from_theta1)*(2 + cos(theta3_from_theta1) + u3_of_place_2*(1 + u3_of_place_5) +
    //   u3_of_place_3_times_6)) + cos(theta3_from_theta1)*(u3_of_place_3_times_3 - 7 - r1__of_place_6)
    let r1__of_place_7 = -S::int(12) + S::int(9) * u3_of_place_3
        + u3_of_place_2
            * (u3_of_place_3_times_3 - S::int(3) - u3_of_place_2
                + cos_theta3_from_theta1
                    * (S::int(2) + cos_theta3_from_theta1
                        + u3_of_place_2 * (S::int(1) + u3_of_place_5) + u3_of_place_3_times_6))
        + cos_theta3_from_theta1 * (u3_of_place_3_times_3 - S::int(7) - r1__of_place_6);
    // u5_from_u3 + 2*u3_plus_u4_from_u3
    let r1__of_motion_7 = u3_plus_u4_from_u3.mul_add(S::int(2), u5_from_u3);
    let u4_from_u3_times_14 = S::int(14) * u4_from_u3;
    // 6 + cos(theta3_from_theta1)
    let r1__of_place_8 = S::int(6) + cos_theta3_from_theta1;
    let u5_from_u3_doubled = S::int(2) * u5_from_u3;
    // u3_times_13 + u4_from_u3_times_14
    let r1__of_u4_from_u3 = u3_times_13 + u4_from_u3_times_14;
    // u5_from_u3_sq + 2*u4_from_u3_sq + u3_of_place_5*r1__of_motion_4
    let r1__of_motion_8 = u4_from_u3_sq.mul_add(S::int(2), u5_from_u3_sq)
        + u3_of_place_5 * r1__of_motion_4;
    let u4_from_u3_sq_times_7 = S::int(7) * u4_from_u3_sq;
    // sin(theta3_from_theta1)*(7*u5_from_u3_sq + u4_from_u3_sq_times_9 + r1__of_motion_4*r1__of_place_6) +
    //   u3*(3*cos(theta3_from_theta1)*(r1__of_place_4*(3*r1__of_motion -
    //   cos(theta2_from_theta1)*(u3_plus_u5_from_u3 + r1__of_motion_2)) + sin(theta2_from_theta1)*(u3*(15 +
    //   u3_of_place_5) + u3_of_place_4*(u3_of_place_5*r1__of_motion + r1__of_motion_7) + u4_from_u3_times_14
    //   + r1__of_place_8*u5_from_u3_doubled)) + sin(theta3_from_theta1)*(14*u5_from_u3 +
    //   18*u3_plus_u4_from_u3 - u3_of_place_2*(10*u5_from_u3 + u3_of_place_4*r1__of_motion_7 +
    //   r1__of_u4_from_u3)) + r1__of_place_3*(u5_from_u3_doubled*(1 - u3_of_place_2) + r1__of_u4_from_u3)) -
    //   u3_of_place_2*(r1__of_place_3*(u5_from_u3_sq - r1__of_motion_8*cos(theta3_from_theta1)) +
    //   sin(theta3_from_theta1)*(u5_from_u3_sq*(5 + cos(theta3_from_theta1)) + u3_of_place_2*r1__of_motion_8
    //   + u4_from_u3_sq_times_7)) + r1__of_place_3*(u5_from_u3_sq + u4_from_u3_sq_times_7 +
    //   cos(theta3_from_theta1)*(u5_from_u3_sq*r1__of_place_8 + u4_from_u3_sq_times_7))
    let r1__of_motion_9 = sin_theta3_from_theta1
        * (u5_from_u3_sq.mul_add(S::int(7), u4_from_u3_sq_times_9)
            + r1__of_motion_4 * r1__of_place_6)
        + u3
            * (S::int(3) * cos_theta3_from_theta1
                * (r1__of_place_4
                    * (-cos_theta2_from_theta1 * (u3_plus_u5_from_u3 + r1__of_motion_2)
                        + S::int(3) * r1__of_motion)
                    + sin_theta2_from_theta1
                        * (u3 * (S::int(15) + u3_of_place_5)
                            + u3_of_place_4 * u3_of_place_5.mul_add(r1__of_motion, r1__of_motion_7)
                            + u4_from_u3_times_14 + r1__of_place_8 * u5_from_u3_doubled))
                + sin_theta3_from_theta1
                    * (S::int(14) * u5_from_u3 + S::int(18) * u3_plus_u4_from_u3
                        - u3_of_place_2
                            * (u3_of_place_4
                                .mul_add(r1__of_motion_7, S::int(10) * u5_from_u3)
                                + r1__of_u4_from_u3))
                + r1__of_place_3
                    * (u5_from_u3_doubled * (S::int(1) - u3_of_place_2) + r1__of_u4_from_u3))
        - u3_of_place_2
            * (r1__of_place_3 * (-r1__of_motion_8).mul_add(cos_theta3_from_theta1, u5_from_u3_sq)
                + sin_theta3_from_theta1
                    * (u5_from_u3_sq * (S::int(5) + cos_theta3_from_theta1)
                        + u3_of_place_2 * r1__of_motion_8 + u4_from_u3_sq_times_7))
        + r1__of_place_3
            * (u5_from_u3_sq + u4_from_u3_sq_times_7
                + cos_theta3_from_theta1
                    * u5_from_u3_sq.mul_add(r1__of_place_8, u4_from_u3_sq_times_7));
    let r1__of_place_9 = S::int(18) * cos_theta2_from_theta1;
    // 33 - u3_of_place_3*r1__of_place_9 + cos(theta3_from_theta1)*(14 + r1__of_place_6 -
    //   r1__of_place_9*(u3_of_place*cos(theta2_from_theta1) + u3_of_place_3))
    let r1__of_place_10 = S::int(33) - u3_of_place_3 * r1__of_place_9
        + cos_theta3_from_theta1
            * (S::int(14) + r1__of_place_6
                - r1__of_place_9 * u3_of_place.mul_add(cos_theta2_from_theta1, u3_of_place_3));
    let r1__of_place_10_inv = S::int(1) / r1__of_place_10;
    // u3*(cos(theta3_from_theta1)*(r1__of_place_3*(u3*(13 + u3_of_place_4) + 6*u4_from_u3*r1__of_place_2 +
    //   u3_of_place_5*r1__of_motion_3 + u5_from_u3_times_6) + r1__of_place_4*(9*u4_from_u3 +
    //   8*u3_plus_u5_from_u3 - u3_of_place_2*r1__of_motion_3)) - 6*sin(theta2_from_theta1)*(3*u4_from_u3 +
    //   u3_plus_u5_from_u3 + u3_of_place_2*r1__of_motion) - sin(theta3_from_theta1)*(18*u4_from_u3 +
    //   u5_from_u3_times_6 + u3_of_place_2*(3*u3*(5 + 2*cos(theta2_from_theta1)) + u5_from_u3_times_6 +
    //   2*u4_from_u3*r1__of_place_5) + u3_times_13)) +
    //   cos(theta3_from_theta1)*(sin(theta3_from_theta1)*(8*u5_from_u3_sq - u3_of_place_2*r1__of_motion_5 +
    //   u4_from_u3_sq_times_9) + r1__of_place_3*(r1__of_motion_5*cos(theta3_from_theta1) +
    //   r1__of_place_2*u4_from_u3_sq_times_3 + u5_from_u3_sq_times_3)) -
    //   3*sin(theta3_from_theta1)*(cos(theta2_from_theta1)*(r1__of_place_5*u4_from_u3_sq +
    //   u5_from_u3_sq_times_3) + r1__of_motion_6) - r1__of_place_3*(u3_of_place_2*r1__of_motion_4 +
    //   r1__of_motion_6)
    let r1__of_motion_10 = u3
        * (cos_theta3_from_theta1
            * (r1__of_place_3
                * (u3 * (S::int(13) + u3_of_place_4) + S::int(6) * u4_from_u3 * r1__of_place_2
                    + u3_of_place_5 * r1__of_motion_3 + u5_from_u3_times_6)
                + r1__of_place_4
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
                            + S::int(2) * u4_from_u3 * r1__of_place_5) + u3_times_13))
        + cos_theta3_from_theta1
            * (sin_theta3_from_theta1
                * ((-u3_of_place_2).mul_add(r1__of_motion_5, S::int(8) * u5_from_u3_sq)
                    + u4_from_u3_sq_times_9)
                + r1__of_place_3
                    * (r1__of_place_2
                        .mul_add(
                            u4_from_u3_sq_times_3,
                            r1__of_motion_5 * cos_theta3_from_theta1,
                        ) + u5_from_u3_sq_times_3))
        - S::int(3) * sin_theta3_from_theta1
            * (cos_theta2_from_theta1 * r1__of_place_5.mul_add(u4_from_u3_sq, u5_from_u3_sq_times_3)
                + r1__of_motion_6)
        - r1__of_place_3 * u3_of_place_2.mul_add(r1__of_motion_4, r1__of_motion_6);
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
    let r1_ = r1__of_place
        * (r1__of_place_7 * r1__of_motion_9)
            .mul_add(r1__of_place_10_inv, r1__of_motion_10);
    let m_l_squared_by_12_inv = S::int(1) / m_l_squared_by_12;
    // u5_from_u3' = r1_*(33 - 18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(4*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot = S::ratio(1, 4) * r1_ * r1__of_place_10 * m_l_squared_by_12_inv
        / (S::int(9)
            + cos_theta3_from_theta1
                * (-S::int(9) * cos_theta2_from_theta1
                    * cos_theta2_from_theta1
                        .mul_add(cos_theta3_from_theta1, u3_of_place_3)
                    + S::int(5) * cos_theta3_from_theta1));
    // u4_from_u3' = (13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(m_l_squared_by_12*(u3*(3*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(u3*(15
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
    //   7*u5_from_u3^2 + 9*cos(theta3_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   u5_from_u3'*m_l_squared_by_12*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))/(m_l_squared_by_12*(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1)
    //   - 33 - cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))))
    let u4_from_u3_dot = -u3_of_place_6 * r1__of_place * r1__of_place_10_inv * m_l_squared_by_12_inv
        * u5_from_u3_dot.mul_add(r1__of_place_7, r1__of_motion_9);
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

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 2],
    direction: &[S; 5],
) -> [S; 5] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[3 + i],
    });
    let (of_q, of_v) = derivative(&p, &q, &v);
    let mut slopes = of_q.into_iter().chain(of_v).map(|rate| rate.slope);
    core::array::from_fn(|_| {
        slopes.next().expect("a slope for each component of the state")
    })
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
    slice.try_into().expect("a slice of the length that `System` requires")
}

/// What a program needs to find these equations and to trust them.
pub const SCENE: CompiledScene = CompiledScene {
    name: "folding",
    key: "2af0f3bf0c76edd2",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: Some(InLanes::of_rates(&Derivative(Reduced))),
    },
};
