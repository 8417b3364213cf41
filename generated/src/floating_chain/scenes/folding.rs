//! Chain of three rods floating in a plane: Folding.
//!
//! Generated from `models/floating_chain/scenes/folding.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: x, y, theta1, theta2, theta3, u1, u2, u3, u4, u5.
//! States: theta2_from_theta1, theta3_from_theta1, u4_from_u3, u5_from_u3. Quadratures: theta1.
//! p_x = m*(6*u1 - l*(2*u3*sin(theta1) + 3*u4*sin(theta2) + u5*sin(theta3)))/2: momentum p_x = ∂L/∂x'.
//! p_y = m*(6*u2 + l*(2*u3*cos(theta1) + 3*u4*cos(theta2) + u5*cos(theta3)))/2: momentum p_y = ∂L/∂y'.
//! H_n3_scaled = m*l^2*(u3*(3 + 3*cos(theta1 - theta2) + cos(theta1 - theta3)) + u4*(7 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + 3*cos(theta1 - theta2)*(1 + cos(theta1 - theta3))) + u5*(3 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + cos(theta1 - theta3)*(1 + 3*cos(theta1 - theta2)))): 12 times the angular momentum about n3 through the mass centre.
//! centre_x = m*(6*x + l*(2*cos(theta1) + 3*cos(theta2) + cos(theta3)))/2: m*(6*x + l*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 + theta3_from_theta1)))/2 at the start.
//! centre_y = m*(6*y + l*(2*sin(theta1) + 3*sin(theta2) + sin(theta3)))/2: m*(6*y + l*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 + theta3_from_theta1)))/2 at the start.
//! H_n3_scaled_per_m_per_l_squared = u3*(3 + 3*cos(theta1 - theta2) + cos(theta1 - theta3)) + u4*(7 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + 3*cos(theta1 - theta2)*(1 + cos(theta1 - theta3))) + u5*(3 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + cos(theta1 - theta3)*(1 + 3*cos(theta1 - theta2))): H_n3_scaled/(m*l^2).
//! l_by_6 = l/6: l/6.
//! p_y_per_m_by_3 = u2 + l*(2*u3*cos(theta1) + 3*u4*cos(theta2) + u5*cos(theta3))/6: p_y/(3*m).
//! p_x_per_m_by_3 = u1 - l*(2*u3*sin(theta1) + 3*u4*sin(theta2) + u5*sin(theta3))/6: p_x/(3*m).
//! m_l_squared_by_12 = m*l^2/12: m*l^2/12.
//! Cost: accelerations 295 operations, 2 sines and cosines; derivative 295 operations, 2 sines and cosines.
//! Singular where 13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) = 0.

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{CompiledScene, CompiledSystem, Lengths, Scalar, System};

/// The parameters, in the order of the model file.
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
            m: p[0],
            l: p[1],
            p_x: p[2],
            p_y: p[3],
            H_n3_scaled: p[4],
            centre_x: p[5],
            centre_y: p[6],
            H_n3_scaled_per_m_per_l_squared: p[7],
            l_by_6: p[8],
            p_y_per_m_by_3: p[9],
            p_x_per_m_by_3: p[10],
            m_l_squared_by_12: p[11],
        }
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 12] = [
    "m",
    "l",
    "p_x",
    "p_y",
    "H_n3_scaled",
    "centre_x",
    "centre_y",
    "H_n3_scaled_per_m_per_l_squared",
    "l_by_6",
    "p_y_per_m_by_3",
    "p_x_per_m_by_3",
    "m_l_squared_by_12",
];

/// Names of the outputs.
pub const OUTPUTS: [&str; 10] = [
    "x",
    "y",
    "theta1",
    "theta2",
    "theta3",
    "u1",
    "u2",
    "u3",
    "u4",
    "u5",
];

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
    // Shared terms.
    // 1 + cos(theta3_from_theta1); used 3 times
    let u3_part = S::int(1) + cos_theta3_from_theta1;
    // 3*cos(theta2_from_theta1); used 20 times
    let u3_part_2 = S::int(3) * cos_theta2_from_theta1;
    // 3*sin(theta2_from_theta1); used 12 times
    let u3_part_3 = S::int(3) * sin_theta2_from_theta1;
    // u3_part_3*sin(theta3_from_theta1); used 4 times
    let u3_part_4 = u3_part_3 * sin_theta3_from_theta1;
    // 6*cos(theta2_from_theta1); used 6 times
    let u3_part_5 = S::int(6) * cos_theta2_from_theta1;
    // 2*cos(theta3_from_theta1); used 5 times
    let u3_part_6 = S::int(2) * cos_theta3_from_theta1;
    // sin(theta2_from_theta1)*sin(theta3_from_theta1); used 5 times
    let u3_part_7 = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // 6*u3_part_7; used 2 times
    let u3_part_7_scaled = S::int(6) * u3_part_7;
    // 1/(13 + u3_part*u3_part_5 + u3_part_6 + u3_part_7_scaled); used 2 times
    let u3_part_8 = S::int(1)
        / (u3_part.mul_add(u3_part_5, S::int(13)) + u3_part_6 + u3_part_7_scaled);
    // Elimination, step by step.
    // u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3 = u3_part_8
        * (H_n3_scaled_per_m_per_l_squared
            - u4_from_u3 * (u3_part.mul_add(u3_part_2, S::int(7)) + u3_part_4)
            - u5_from_u3
                * (S::int(3) + cos_theta3_from_theta1 * (S::int(1) + u3_part_2)
                    + u3_part_4));
    // Shared terms.
    // 3 + cos(theta2_from_theta1); used 2 times
    let r1__part = S::int(3) + cos_theta2_from_theta1;
    // u3 + u5_from_u3; used 4 times
    let r1__part_2 = u3 + u5_from_u3;
    // u3 + u4_from_u3; used 3 times
    let r1__part_3 = u3 + u4_from_u3;
    // u5_from_u3 + r1__part_3; used 5 times
    let r1__part_4 = u5_from_u3 + r1__part_3;
    // u3_part_5*r1__part_4; used 2 times
    let u3_part_5_r1__part_4 = u3_part_5 * r1__part_4;
    // u4_from_u3 + 2*r1__part_2 + u3_part_5_r1__part_4; used 2 times
    let r1__part_5 = r1__part_2.mul_add(S::int(2), u4_from_u3) + u3_part_5_r1__part_4;
    // 6*u5_from_u3; used 3 times
    let u5_from_u3_scaled = S::int(6) * u5_from_u3;
    // 2*sin(theta3_from_theta1); used 4 times
    let r1__part_6 = S::int(2) * sin_theta3_from_theta1;
    // 10 + u3_part_2; used 2 times
    let r1__part_7 = S::int(10) + u3_part_2;
    // 13*u3; used 2 times
    let u3_scaled = S::int(13) * u3;
    // u5_from_u3^2; used 15 times
    let u5_from_u3_sq = u5_from_u3 * u5_from_u3;
    // u4_from_u3^2; used 8 times
    let u4_from_u3_sq = u4_from_u3 * u4_from_u3;
    // u5_from_u3_sq + u4_from_u3_sq; used 5 times
    let r1__part_8 = u5_from_u3_sq + u4_from_u3_sq;
    // 2*u5_from_u3_sq + u4_from_u3_sq + u3_part_5*r1__part_8; used 2 times
    let r1__part_9 = u5_from_u3_sq.mul_add(S::int(2), u4_from_u3_sq)
        + u3_part_5 * r1__part_8;
    // 9*u4_from_u3_sq; used 2 times
    let u4_from_u3_sq_scaled = S::int(9) * u4_from_u3_sq;
    // 3*u4_from_u3_sq; used 2 times
    let u4_from_u3_sq_scaled_2 = S::int(3) * u4_from_u3_sq;
    // 3*u5_from_u3_sq; used 2 times
    let u5_from_u3_sq_scaled = S::int(3) * u5_from_u3_sq;
    // u5_from_u3_sq + u4_from_u3_sq_scaled_2; used 2 times
    let r1__part_10 = u5_from_u3_sq + u4_from_u3_sq_scaled_2;
    // 9*cos(theta3_from_theta1); used 2 times
    let r1__part_11 = S::int(9) * cos_theta3_from_theta1;
    // 7 + r1__part_11; used 2 times
    let r1__part_12 = S::int(7) + r1__part_11;
    // 1 + u3_part_6; used 2 times
    let r1__part_13 = S::int(1) + u3_part_6;
    // 2 + cos(theta3_from_theta1); used 2 times
    let r1__part_14 = S::int(2) + cos_theta3_from_theta1;
    // u5_from_u3 + 2*r1__part_3; used 2 times
    let r1__part_15 = r1__part_3.mul_add(S::int(2), u5_from_u3);
    // u3_part_6*r1__part_4 + r1__part_15; used 2 times
    let r1__part_16 = u3_part_6.mul_add(r1__part_4, r1__part_15);
    // 6 + cos(theta3_from_theta1); used 2 times
    let r1__part_17 = S::int(6) + cos_theta3_from_theta1;
    // 2*u5_from_u3; used 2 times
    let u5_from_u3_scaled_2 = S::int(2) * u5_from_u3;
    // 14*u4_from_u3; used 2 times
    let u4_from_u3_scaled = S::int(14) * u4_from_u3;
    // u3*(15 + u3_part_6) + r1__part_17*u5_from_u3_scaled_2
    let r1__part_18 = u3 * (S::int(15) + u3_part_6) + r1__part_17 * u5_from_u3_scaled_2;
    // u4_from_u3_scaled + r1__part_18; used 2 times
    let r1__part_19 = u4_from_u3_scaled + r1__part_18;
    // r1__part_2 + u3_part_5_r1__part_4; used 2 times
    let r1__part_20 = r1__part_2 + u3_part_5_r1__part_4;
    // u3_scaled + u4_from_u3_scaled; used 2 times
    let r1__part_21 = u3_scaled + u4_from_u3_scaled;
    // 10*u5_from_u3 + u3_part_5*r1__part_15 + r1__part_21; used 2 times
    let r1__part_22 = u3_part_5.mul_add(r1__part_15, S::int(10) * u5_from_u3)
        + r1__part_21;
    // 7*u5_from_u3 + 9*r1__part_3; used 2 times
    let r1__part_23 = r1__part_3.mul_add(S::int(9), S::int(7) * u5_from_u3);
    // u3_part_2 - 1; used 2 times
    let r1__part_24 = u3_part_2 - S::int(1);
    // r1__part_21 - u5_from_u3_scaled_2*r1__part_24; used 2 times
    let r1__part_25 = (-u5_from_u3_scaled_2).mul_add(r1__part_24, r1__part_21);
    // u4_from_u3_sq + r1__part_8*cos(theta3_from_theta1); used 2 times
    let r1__part_26 = r1__part_8.mul_add(cos_theta3_from_theta1, u4_from_u3_sq);
    // 7*u5_from_u3_sq; used 2 times
    let u5_from_u3_sq_scaled_2 = S::int(7) * u5_from_u3_sq;
    // u5_from_u3_sq + 2*r1__part_26; used 3 times
    let r1__part_27 = r1__part_26.mul_add(S::int(2), u5_from_u3_sq);
    // 7*u4_from_u3_sq; used 5 times
    let u4_from_u3_sq_scaled_3 = S::int(7) * u4_from_u3_sq;
    // u5_from_u3_sq*r1__part_17 + u4_from_u3_sq_scaled_3; used 2 times
    let r1__part_28 = u5_from_u3_sq.mul_add(r1__part_17, u4_from_u3_sq_scaled_3);
    // 18*cos(theta2_from_theta1); used 2 times
    let r1__part_29 = S::int(18) * cos_theta2_from_theta1;
    // 33 - u3_part_7*r1__part_29 + cos(theta3_from_theta1)*(14 + r1__part_11 -
    //   r1__part_29*(u3_part*cos(theta2_from_theta1) + u3_part_7)); used 2 times
    let r1__part_30 = S::int(33) - u3_part_7 * r1__part_29
        + cos_theta3_from_theta1
            * (S::int(14) + r1__part_11
                - r1__part_29 * u3_part.mul_add(cos_theta2_from_theta1, u3_part_7));
    // 1/r1__part_30; used 2 times
    let r1__part_30_inv = S::int(1) / r1__part_30;
    // u3*(cos(theta3_from_theta1)*(u3_part_3*(u3*(13 + u3_part_5) + 6*u4_from_u3*r1__part +
    //   u3_part_6*r1__part_5 + u5_from_u3_scaled) + r1__part_6*(9*u4_from_u3 + 8*r1__part_2 -
    //   u3_part_2*r1__part_5)) - 6*sin(theta2_from_theta1)*(3*u4_from_u3 + r1__part_2 +
    //   u3_part_2*r1__part_4) - sin(theta3_from_theta1)*(18*u4_from_u3 + u5_from_u3_scaled +
    //   u3_part_2*(3*u3*(5 + 2*cos(theta2_from_theta1)) + u5_from_u3_scaled + 2*u4_from_u3*r1__part_7) +
    //   u3_scaled)) + cos(theta3_from_theta1)*(sin(theta3_from_theta1)*(8*u5_from_u3_sq -
    //   u3_part_2*r1__part_9 + u4_from_u3_sq_scaled) + u3_part_3*(r1__part_9*cos(theta3_from_theta1) +
    //   r1__part*u4_from_u3_sq_scaled_2 + u5_from_u3_sq_scaled)) -
    //   3*sin(theta3_from_theta1)*(cos(theta2_from_theta1)*(r1__part_7*u4_from_u3_sq + u5_from_u3_sq_scaled)
    //   + r1__part_10) - u3_part_3*(u3_part_2*r1__part_8 + r1__part_10)
    let r1__part_31 = u3
        * (cos_theta3_from_theta1
            * (u3_part_3
                * (u3 * (S::int(13) + u3_part_5) + S::int(6) * u4_from_u3 * r1__part
                    + u3_part_6 * r1__part_5 + u5_from_u3_scaled)
                + r1__part_6
                    * (r1__part_2.mul_add(S::int(8), S::int(9) * u4_from_u3)
                        - u3_part_2 * r1__part_5))
            - S::int(6) * sin_theta2_from_theta1
                * (u4_from_u3.mul_add(S::int(3), r1__part_2) + u3_part_2 * r1__part_4)
            - sin_theta3_from_theta1
                * (u5_from_u3_scaled + S::int(18) * u4_from_u3
                    + u3_part_2
                        * (S::int(3) * u3
                            * cos_theta2_from_theta1.mul_add(S::int(2), S::int(5))
                            + u5_from_u3_scaled + S::int(2) * u4_from_u3 * r1__part_7)
                    + u3_scaled))
        + cos_theta3_from_theta1
            * (sin_theta3_from_theta1
                * ((-u3_part_2).mul_add(r1__part_9, S::int(8) * u5_from_u3_sq)
                    + u4_from_u3_sq_scaled)
                + u3_part_3
                    * (r1__part
                        .mul_add(
                            u4_from_u3_sq_scaled_2,
                            r1__part_9 * cos_theta3_from_theta1,
                        ) + u5_from_u3_sq_scaled))
        - S::int(3) * sin_theta3_from_theta1
            * (cos_theta2_from_theta1
                * r1__part_7.mul_add(u4_from_u3_sq, u5_from_u3_sq_scaled) + r1__part_10)
        - u3_part_3 * u3_part_2.mul_add(r1__part_8, r1__part_10);
    // Elimination, step by step.
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
    let r1_ = m_l_squared_by_12 * u3_part_8
        * (r1__part_30_inv
            * (-S::int(12) + S::int(9) * u3_part_7
                + cos_theta3_from_theta1 * (u3_part_4 - r1__part_12)
                + u3_part_2
                    * (u3_part_4 - S::int(3) - u3_part_2
                        + cos_theta3_from_theta1
                            * (u3_part_2.mul_add(r1__part_13, u3_part_7_scaled)
                                + r1__part_14)))
            * (u3
                * (S::int(3) * cos_theta3_from_theta1
                    * (sin_theta2_from_theta1
                        * u3_part_5.mul_add(r1__part_16, r1__part_19)
                        + r1__part_6
                            * (-r1__part_20)
                                .mul_add(cos_theta2_from_theta1, S::int(3) * r1__part_4))
                    + sin_theta3_from_theta1
                        * (-u3_part_2).mul_add(r1__part_22, S::int(2) * r1__part_23)
                    + u3_part_3 * r1__part_25)
                + sin_theta3_from_theta1
                    * r1__part_26.mul_add(S::int(9), u5_from_u3_sq_scaled_2)
                - u3_part_2
                    * (u3_part_3
                        * (-r1__part_27).mul_add(cos_theta3_from_theta1, u5_from_u3_sq)
                        + sin_theta3_from_theta1
                            * (u5_from_u3_sq * (S::int(5) + cos_theta3_from_theta1)
                                + u3_part_2 * r1__part_27 + u4_from_u3_sq_scaled_3))
                + u3_part_3
                    * r1__part_28
                        .mul_add(
                            cos_theta3_from_theta1,
                            u5_from_u3_sq + u4_from_u3_sq_scaled_3,
                        )) + r1__part_31);
    // u5_from_u3' = r1_*(33 - 18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(4*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot = S::ratio(1, 4) * r1_ * r1__part_30
        / (m_l_squared_by_12
            * (S::int(9)
                + cos_theta3_from_theta1
                    * (-S::int(9) * cos_theta2_from_theta1
                        * cos_theta2_from_theta1
                            .mul_add(cos_theta3_from_theta1, u3_part_7)
                        + S::int(5) * cos_theta3_from_theta1)));
    // Shared terms.
    // 2*u3; used 3 times
    let u3_scaled_2 = S::int(2) * u3;
    // Elimination, step by step.
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
    let u4_from_u3_dot = r1__part_30_inv
        * (S::int(3) * u5_from_u3_dot
            * (S::int(4) + u3_part_2 * (S::int(1) + cos_theta2_from_theta1))
            - u3_part_3
                * ((-u5_from_u3_sq).mul_add(r1__part_24, u3 * r1__part_25)
                    + u4_from_u3_sq_scaled_3)
            - cos_theta3_from_theta1
                * (u3_part_3
                    * (u3.mul_add(r1__part_19, u5_from_u3_dot * sin_theta3_from_theta1)
                        + r1__part_28) - u5_from_u3_dot * r1__part_12
                    + S::int(9) * sin_theta3_from_theta1
                        * r1__part_4.mul_add(u3_scaled_2, r1__part_8)
                    + u3_part_2
                        * (u3_part_2
                            * (-r1__part_6)
                                .mul_add(r1__part_8, u5_from_u3_dot * r1__part_13)
                            - u5_from_u3_sq * sin_theta3_from_theta1
                            + u5_from_u3_dot * r1__part_14
                            + u3_part_3 * u5_from_u3_dot.mul_add(r1__part_6, r1__part_27)
                            + u3_scaled_2
                                * (-r1__part_20)
                                    .mul_add(sin_theta3_from_theta1, u3_part_3 * r1__part_16)))
            - sin_theta3_from_theta1
                * (u4_from_u3_sq_scaled
                    + S::int(9) * u5_from_u3_dot * sin_theta2_from_theta1
                    + u5_from_u3_sq_scaled_2
                    + u3_part_2
                        * (u5_from_u3_dot * u3_part_3 - S::int(5) * u5_from_u3_sq
                            - u3_part_2 * u4_from_u3_sq.mul_add(S::int(2), u5_from_u3_sq)
                            - u3 * r1__part_22 - u4_from_u3_sq_scaled_3)
                    + r1__part_23 * u3_scaled_2));
    [u4_from_u3_dot, u5_from_u3_dot]
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
    // Shared terms.
    // 1 + cos(theta3_from_theta1); used 3 times
    let u3_part = S::int(1) + cos_theta3_from_theta1;
    // 3*cos(theta2_from_theta1); used 20 times
    let u3_part_2 = S::int(3) * cos_theta2_from_theta1;
    // 3*sin(theta2_from_theta1); used 12 times
    let u3_part_3 = S::int(3) * sin_theta2_from_theta1;
    // u3_part_3*sin(theta3_from_theta1); used 4 times
    let u3_part_4 = u3_part_3 * sin_theta3_from_theta1;
    // 6*cos(theta2_from_theta1); used 6 times
    let u3_part_5 = S::int(6) * cos_theta2_from_theta1;
    // 2*cos(theta3_from_theta1); used 5 times
    let u3_part_6 = S::int(2) * cos_theta3_from_theta1;
    // sin(theta2_from_theta1)*sin(theta3_from_theta1); used 5 times
    let u3_part_7 = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // 6*u3_part_7; used 2 times
    let u3_part_7_scaled = S::int(6) * u3_part_7;
    // 1/(13 + u3_part*u3_part_5 + u3_part_6 + u3_part_7_scaled); used 2 times
    let u3_part_8 = S::int(1)
        / (u3_part.mul_add(u3_part_5, S::int(13)) + u3_part_6 + u3_part_7_scaled);
    // Elimination, step by step.
    // u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3 = u3_part_8
        * (H_n3_scaled_per_m_per_l_squared
            - u4_from_u3 * (u3_part.mul_add(u3_part_2, S::int(7)) + u3_part_4)
            - u5_from_u3
                * (S::int(3) + cos_theta3_from_theta1 * (S::int(1) + u3_part_2)
                    + u3_part_4));
    // Shared terms.
    // 3 + cos(theta2_from_theta1); used 2 times
    let r1__part = S::int(3) + cos_theta2_from_theta1;
    // u3 + u5_from_u3; used 4 times
    let r1__part_2 = u3 + u5_from_u3;
    // u3 + u4_from_u3; used 3 times
    let r1__part_3 = u3 + u4_from_u3;
    // u5_from_u3 + r1__part_3; used 5 times
    let r1__part_4 = u5_from_u3 + r1__part_3;
    // u3_part_5*r1__part_4; used 2 times
    let u3_part_5_r1__part_4 = u3_part_5 * r1__part_4;
    // u4_from_u3 + 2*r1__part_2 + u3_part_5_r1__part_4; used 2 times
    let r1__part_5 = r1__part_2.mul_add(S::int(2), u4_from_u3) + u3_part_5_r1__part_4;
    // 6*u5_from_u3; used 3 times
    let u5_from_u3_scaled = S::int(6) * u5_from_u3;
    // 2*sin(theta3_from_theta1); used 4 times
    let r1__part_6 = S::int(2) * sin_theta3_from_theta1;
    // 10 + u3_part_2; used 2 times
    let r1__part_7 = S::int(10) + u3_part_2;
    // 13*u3; used 2 times
    let u3_scaled = S::int(13) * u3;
    // u5_from_u3^2; used 15 times
    let u5_from_u3_sq = u5_from_u3 * u5_from_u3;
    // u4_from_u3^2; used 8 times
    let u4_from_u3_sq = u4_from_u3 * u4_from_u3;
    // u5_from_u3_sq + u4_from_u3_sq; used 5 times
    let r1__part_8 = u5_from_u3_sq + u4_from_u3_sq;
    // 2*u5_from_u3_sq + u4_from_u3_sq + u3_part_5*r1__part_8; used 2 times
    let r1__part_9 = u5_from_u3_sq.mul_add(S::int(2), u4_from_u3_sq)
        + u3_part_5 * r1__part_8;
    // 9*u4_from_u3_sq; used 2 times
    let u4_from_u3_sq_scaled = S::int(9) * u4_from_u3_sq;
    // 3*u4_from_u3_sq; used 2 times
    let u4_from_u3_sq_scaled_2 = S::int(3) * u4_from_u3_sq;
    // 3*u5_from_u3_sq; used 2 times
    let u5_from_u3_sq_scaled = S::int(3) * u5_from_u3_sq;
    // u5_from_u3_sq + u4_from_u3_sq_scaled_2; used 2 times
    let r1__part_10 = u5_from_u3_sq + u4_from_u3_sq_scaled_2;
    // 9*cos(theta3_from_theta1); used 2 times
    let r1__part_11 = S::int(9) * cos_theta3_from_theta1;
    // 7 + r1__part_11; used 2 times
    let r1__part_12 = S::int(7) + r1__part_11;
    // 1 + u3_part_6; used 2 times
    let r1__part_13 = S::int(1) + u3_part_6;
    // 2 + cos(theta3_from_theta1); used 2 times
    let r1__part_14 = S::int(2) + cos_theta3_from_theta1;
    // u5_from_u3 + 2*r1__part_3; used 2 times
    let r1__part_15 = r1__part_3.mul_add(S::int(2), u5_from_u3);
    // u3_part_6*r1__part_4 + r1__part_15; used 2 times
    let r1__part_16 = u3_part_6.mul_add(r1__part_4, r1__part_15);
    // 6 + cos(theta3_from_theta1); used 2 times
    let r1__part_17 = S::int(6) + cos_theta3_from_theta1;
    // 2*u5_from_u3; used 2 times
    let u5_from_u3_scaled_2 = S::int(2) * u5_from_u3;
    // 14*u4_from_u3; used 2 times
    let u4_from_u3_scaled = S::int(14) * u4_from_u3;
    // u3*(15 + u3_part_6) + r1__part_17*u5_from_u3_scaled_2
    let r1__part_18 = u3 * (S::int(15) + u3_part_6) + r1__part_17 * u5_from_u3_scaled_2;
    // u4_from_u3_scaled + r1__part_18; used 2 times
    let r1__part_19 = u4_from_u3_scaled + r1__part_18;
    // r1__part_2 + u3_part_5_r1__part_4; used 2 times
    let r1__part_20 = r1__part_2 + u3_part_5_r1__part_4;
    // u3_scaled + u4_from_u3_scaled; used 2 times
    let r1__part_21 = u3_scaled + u4_from_u3_scaled;
    // 10*u5_from_u3 + u3_part_5*r1__part_15 + r1__part_21; used 2 times
    let r1__part_22 = u3_part_5.mul_add(r1__part_15, S::int(10) * u5_from_u3)
        + r1__part_21;
    // 7*u5_from_u3 + 9*r1__part_3; used 2 times
    let r1__part_23 = r1__part_3.mul_add(S::int(9), S::int(7) * u5_from_u3);
    // u3_part_2 - 1; used 2 times
    let r1__part_24 = u3_part_2 - S::int(1);
    // r1__part_21 - u5_from_u3_scaled_2*r1__part_24; used 2 times
    let r1__part_25 = (-u5_from_u3_scaled_2).mul_add(r1__part_24, r1__part_21);
    // u4_from_u3_sq + r1__part_8*cos(theta3_from_theta1); used 2 times
    let r1__part_26 = r1__part_8.mul_add(cos_theta3_from_theta1, u4_from_u3_sq);
    // 7*u5_from_u3_sq; used 2 times
    let u5_from_u3_sq_scaled_2 = S::int(7) * u5_from_u3_sq;
    // u5_from_u3_sq + 2*r1__part_26; used 3 times
    let r1__part_27 = r1__part_26.mul_add(S::int(2), u5_from_u3_sq);
    // 7*u4_from_u3_sq; used 5 times
    let u4_from_u3_sq_scaled_3 = S::int(7) * u4_from_u3_sq;
    // u5_from_u3_sq*r1__part_17 + u4_from_u3_sq_scaled_3; used 2 times
    let r1__part_28 = u5_from_u3_sq.mul_add(r1__part_17, u4_from_u3_sq_scaled_3);
    // 18*cos(theta2_from_theta1); used 2 times
    let r1__part_29 = S::int(18) * cos_theta2_from_theta1;
    // 33 - u3_part_7*r1__part_29 + cos(theta3_from_theta1)*(14 + r1__part_11 -
    //   r1__part_29*(u3_part*cos(theta2_from_theta1) + u3_part_7)); used 2 times
    let r1__part_30 = S::int(33) - u3_part_7 * r1__part_29
        + cos_theta3_from_theta1
            * (S::int(14) + r1__part_11
                - r1__part_29 * u3_part.mul_add(cos_theta2_from_theta1, u3_part_7));
    // 1/r1__part_30; used 2 times
    let r1__part_30_inv = S::int(1) / r1__part_30;
    // u3*(cos(theta3_from_theta1)*(u3_part_3*(u3*(13 + u3_part_5) + 6*u4_from_u3*r1__part +
    //   u3_part_6*r1__part_5 + u5_from_u3_scaled) + r1__part_6*(9*u4_from_u3 + 8*r1__part_2 -
    //   u3_part_2*r1__part_5)) - 6*sin(theta2_from_theta1)*(3*u4_from_u3 + r1__part_2 +
    //   u3_part_2*r1__part_4) - sin(theta3_from_theta1)*(18*u4_from_u3 + u5_from_u3_scaled +
    //   u3_part_2*(3*u3*(5 + 2*cos(theta2_from_theta1)) + u5_from_u3_scaled + 2*u4_from_u3*r1__part_7) +
    //   u3_scaled)) + cos(theta3_from_theta1)*(sin(theta3_from_theta1)*(8*u5_from_u3_sq -
    //   u3_part_2*r1__part_9 + u4_from_u3_sq_scaled) + u3_part_3*(r1__part_9*cos(theta3_from_theta1) +
    //   r1__part*u4_from_u3_sq_scaled_2 + u5_from_u3_sq_scaled)) -
    //   3*sin(theta3_from_theta1)*(cos(theta2_from_theta1)*(r1__part_7*u4_from_u3_sq + u5_from_u3_sq_scaled)
    //   + r1__part_10) - u3_part_3*(u3_part_2*r1__part_8 + r1__part_10)
    let r1__part_31 = u3
        * (cos_theta3_from_theta1
            * (u3_part_3
                * (u3 * (S::int(13) + u3_part_5) + S::int(6) * u4_from_u3 * r1__part
                    + u3_part_6 * r1__part_5 + u5_from_u3_scaled)
                + r1__part_6
                    * (r1__part_2.mul_add(S::int(8), S::int(9) * u4_from_u3)
                        - u3_part_2 * r1__part_5))
            - S::int(6) * sin_theta2_from_theta1
                * (u4_from_u3.mul_add(S::int(3), r1__part_2) + u3_part_2 * r1__part_4)
            - sin_theta3_from_theta1
                * (u5_from_u3_scaled + S::int(18) * u4_from_u3
                    + u3_part_2
                        * (S::int(3) * u3
                            * cos_theta2_from_theta1.mul_add(S::int(2), S::int(5))
                            + u5_from_u3_scaled + S::int(2) * u4_from_u3 * r1__part_7)
                    + u3_scaled))
        + cos_theta3_from_theta1
            * (sin_theta3_from_theta1
                * ((-u3_part_2).mul_add(r1__part_9, S::int(8) * u5_from_u3_sq)
                    + u4_from_u3_sq_scaled)
                + u3_part_3
                    * (r1__part
                        .mul_add(
                            u4_from_u3_sq_scaled_2,
                            r1__part_9 * cos_theta3_from_theta1,
                        ) + u5_from_u3_sq_scaled))
        - S::int(3) * sin_theta3_from_theta1
            * (cos_theta2_from_theta1
                * r1__part_7.mul_add(u4_from_u3_sq, u5_from_u3_sq_scaled) + r1__part_10)
        - u3_part_3 * u3_part_2.mul_add(r1__part_8, r1__part_10);
    // Elimination, step by step.
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
    let r1_ = m_l_squared_by_12 * u3_part_8
        * (r1__part_30_inv
            * (-S::int(12) + S::int(9) * u3_part_7
                + cos_theta3_from_theta1 * (u3_part_4 - r1__part_12)
                + u3_part_2
                    * (u3_part_4 - S::int(3) - u3_part_2
                        + cos_theta3_from_theta1
                            * (u3_part_2.mul_add(r1__part_13, u3_part_7_scaled)
                                + r1__part_14)))
            * (u3
                * (S::int(3) * cos_theta3_from_theta1
                    * (sin_theta2_from_theta1
                        * u3_part_5.mul_add(r1__part_16, r1__part_19)
                        + r1__part_6
                            * (-r1__part_20)
                                .mul_add(cos_theta2_from_theta1, S::int(3) * r1__part_4))
                    + sin_theta3_from_theta1
                        * (-u3_part_2).mul_add(r1__part_22, S::int(2) * r1__part_23)
                    + u3_part_3 * r1__part_25)
                + sin_theta3_from_theta1
                    * r1__part_26.mul_add(S::int(9), u5_from_u3_sq_scaled_2)
                - u3_part_2
                    * (u3_part_3
                        * (-r1__part_27).mul_add(cos_theta3_from_theta1, u5_from_u3_sq)
                        + sin_theta3_from_theta1
                            * (u5_from_u3_sq * (S::int(5) + cos_theta3_from_theta1)
                                + u3_part_2 * r1__part_27 + u4_from_u3_sq_scaled_3))
                + u3_part_3
                    * r1__part_28
                        .mul_add(
                            cos_theta3_from_theta1,
                            u5_from_u3_sq + u4_from_u3_sq_scaled_3,
                        )) + r1__part_31);
    // u5_from_u3' = r1_*(33 - 18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(4*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot = S::ratio(1, 4) * r1_ * r1__part_30
        / (m_l_squared_by_12
            * (S::int(9)
                + cos_theta3_from_theta1
                    * (-S::int(9) * cos_theta2_from_theta1
                        * cos_theta2_from_theta1
                            .mul_add(cos_theta3_from_theta1, u3_part_7)
                        + S::int(5) * cos_theta3_from_theta1)));
    // Shared terms.
    // 2*u3; used 3 times
    let u3_scaled_2 = S::int(2) * u3;
    // Elimination, step by step.
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
    let u4_from_u3_dot = r1__part_30_inv
        * (S::int(3) * u5_from_u3_dot
            * (S::int(4) + u3_part_2 * (S::int(1) + cos_theta2_from_theta1))
            - u3_part_3
                * ((-u5_from_u3_sq).mul_add(r1__part_24, u3 * r1__part_25)
                    + u4_from_u3_sq_scaled_3)
            - cos_theta3_from_theta1
                * (u3_part_3
                    * (u3.mul_add(r1__part_19, u5_from_u3_dot * sin_theta3_from_theta1)
                        + r1__part_28) - u5_from_u3_dot * r1__part_12
                    + S::int(9) * sin_theta3_from_theta1
                        * r1__part_4.mul_add(u3_scaled_2, r1__part_8)
                    + u3_part_2
                        * (u3_part_2
                            * (-r1__part_6)
                                .mul_add(r1__part_8, u5_from_u3_dot * r1__part_13)
                            - u5_from_u3_sq * sin_theta3_from_theta1
                            + u5_from_u3_dot * r1__part_14
                            + u3_part_3 * u5_from_u3_dot.mul_add(r1__part_6, r1__part_27)
                            + u3_scaled_2
                                * (-r1__part_20)
                                    .mul_add(sin_theta3_from_theta1, u3_part_3 * r1__part_16)))
            - sin_theta3_from_theta1
                * (u4_from_u3_sq_scaled
                    + S::int(9) * u5_from_u3_dot * sin_theta2_from_theta1
                    + u5_from_u3_sq_scaled_2
                    + u3_part_2
                        * (u5_from_u3_dot * u3_part_3 - S::int(5) * u5_from_u3_sq
                            - u3_part_2 * u4_from_u3_sq.mul_add(S::int(2), u5_from_u3_sq)
                            - u3 * r1__part_22 - u4_from_u3_sq_scaled_3)
                    + r1__part_23 * u3_scaled_2));
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
    let zero = S::int(0);
    // Sines and cosines.
    let (sin_theta3_from_theta1, cos_theta3_from_theta1) = theta3_from_theta1.sin_cos();
    let (sin_theta2_from_theta1, cos_theta2_from_theta1) = theta2_from_theta1.sin_cos();
    // Shared terms.
    // 1 + cos(theta3_from_theta1); used 9 times
    let u3_part = S::int(1) + cos_theta3_from_theta1;
    // 3*cos(theta2_from_theta1); used 51 times
    let u3_part_2 = S::int(3) * cos_theta2_from_theta1;
    // 3*sin(theta2_from_theta1); used 41 times
    let u3_part_3 = S::int(3) * sin_theta2_from_theta1;
    // u3_part_3*sin(theta3_from_theta1); used 5 times
    let u3_part_4 = u3_part_3 * sin_theta3_from_theta1;
    // 7 + u3_part*u3_part_2 + u3_part_4; used 2 times
    let u3_part_5 = u3_part.mul_add(u3_part_2, S::int(7)) + u3_part_4;
    // 1 + u3_part_2; used 6 times
    let u3_part_6 = S::int(1) + u3_part_2;
    // 3 + u3_part_4 + u3_part_6*cos(theta3_from_theta1); used 2 times
    let u3_part_7 = u3_part_6.mul_add(cos_theta3_from_theta1, S::int(3) + u3_part_4);
    // 6*cos(theta2_from_theta1); used 23 times
    let u3_part_8 = S::int(6) * cos_theta2_from_theta1;
    // 2*cos(theta3_from_theta1); used 15 times
    let u3_part_9 = S::int(2) * cos_theta3_from_theta1;
    // 6*sin(theta2_from_theta1); used 21 times
    let u3_part_10 = S::int(6) * sin_theta2_from_theta1;
    // u3_part_10*sin(theta3_from_theta1); used 2 times
    let u3_part_11 = u3_part_10 * sin_theta3_from_theta1;
    // 1/(13 + u3_part*u3_part_8 + u3_part_9 + u3_part_11); used 6 times
    let u3_part_12 = S::int(1)
        / (u3_part.mul_add(u3_part_8, S::int(13)) + u3_part_9 + u3_part_11);
    // Elimination, step by step.
    // u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3 = u3_part_12
        * ((-u4_from_u3).mul_add(u3_part_5, H_n3_scaled_per_m_per_l_squared)
            - u5_from_u3 * u3_part_7);
    // Shared terms.
    // 13 + u3_part_8; used 5 times
    let r1__part = S::int(13) + u3_part_8;
    // 3 + cos(theta2_from_theta1); used 3 times
    let r1__part_2 = S::int(3) + cos_theta2_from_theta1;
    // u3 + u5_from_u3; used 8 times
    let r1__part_3 = u3 + u5_from_u3;
    // 2*r1__part_3; used 3 times
    let r1__part_3_scaled = S::int(2) * r1__part_3;
    // u3 + u4_from_u3; used 9 times
    let r1__part_4 = u3 + u4_from_u3;
    // u5_from_u3 + r1__part_4; used 8 times
    let r1__part_5 = u5_from_u3 + r1__part_4;
    // u3_part_8*r1__part_5; used 2 times
    let u3_part_8_r1__part_5 = u3_part_8 * r1__part_5;
    // u4_from_u3 + r1__part_3_scaled + u3_part_8_r1__part_5; used 4 times
    let r1__part_6 = u4_from_u3 + r1__part_3_scaled + u3_part_8_r1__part_5;
    // 6*u5_from_u3; used 5 times
    let u5_from_u3_scaled = S::int(6) * u5_from_u3;
    // u3*r1__part + 6*u4_from_u3*r1__part_2 + u3_part_9*r1__part_6 + u5_from_u3_scaled; used 2 times
    let r1__part_7 = (u4_from_u3 * r1__part_2).mul_add(S::int(6), u3 * r1__part)
        + u3_part_9 * r1__part_6 + u5_from_u3_scaled;
    // 9*u4_from_u3 + 8*r1__part_3 - u3_part_2*r1__part_6; used 2 times
    let r1__part_8 = r1__part_3.mul_add(S::int(8), S::int(9) * u4_from_u3)
        - u3_part_2 * r1__part_6;
    // 2*sin(theta3_from_theta1); used 17 times
    let r1__part_9 = S::int(2) * sin_theta3_from_theta1;
    // u3_part_3*r1__part_7 + r1__part_8*r1__part_9; used 2 times
    let r1__part_10 = r1__part_8.mul_add(r1__part_9, u3_part_3 * r1__part_7);
    // 2*cos(theta2_from_theta1); used 3 times
    let r1__part_11 = S::int(2) * cos_theta2_from_theta1;
    // 5 + r1__part_11; used 5 times
    let r1__part_12 = S::int(5) + r1__part_11;
    // 3*u3; used 3 times
    let u3_scaled = S::int(3) * u3;
    // 10 + u3_part_2; used 3 times
    let r1__part_13 = S::int(10) + u3_part_2;
    // 2*u4_from_u3; used 2 times
    let u4_from_u3_scaled = S::int(2) * u4_from_u3;
    // u5_from_u3_scaled + r1__part_12*u3_scaled + r1__part_13*u4_from_u3_scaled; used 2 times
    let r1__part_14 = r1__part_12.mul_add(u3_scaled, u5_from_u3_scaled)
        + r1__part_13 * u4_from_u3_scaled;
    // 13*u3; used 4 times
    let u3_scaled_2 = S::int(13) * u3;
    // 18*u4_from_u3 + u5_from_u3_scaled + u3_part_2*r1__part_14 + u3_scaled_2; used 2 times
    let r1__part_15 = u4_from_u3.mul_add(S::int(18), u5_from_u3_scaled)
        + u3_part_2 * r1__part_14 + u3_scaled_2;
    // 3*u4_from_u3; used 5 times
    let u4_from_u3_scaled_2 = S::int(3) * u4_from_u3;
    // r1__part_3 + u3_part_2*r1__part_5 + u4_from_u3_scaled_2; used 2 times
    let r1__part_16 = u3_part_2.mul_add(r1__part_5, r1__part_3) + u4_from_u3_scaled_2;
    // r1__part_10*cos(theta3_from_theta1) - r1__part_15*sin(theta3_from_theta1) - u3_part_10*r1__part_16;
    //   used 5 times
    let r1__part_17 = (-r1__part_15)
        .mul_add(sin_theta3_from_theta1, r1__part_10 * cos_theta3_from_theta1)
        - u3_part_10 * r1__part_16;
    // u5_from_u3^2; used 16 times
    let u5_from_u3_sq = u5_from_u3 * u5_from_u3;
    // u4_from_u3^2; used 8 times
    let u4_from_u3_sq = u4_from_u3 * u4_from_u3;
    // u5_from_u3_sq + u4_from_u3_sq; used 8 times
    let r1__part_18 = u5_from_u3_sq + u4_from_u3_sq;
    // 2*u5_from_u3_sq + u4_from_u3_sq + u3_part_8*r1__part_18; used 4 times
    let r1__part_19 = u5_from_u3_sq.mul_add(S::int(2), u4_from_u3_sq)
        + u3_part_8 * r1__part_18;
    // 9*u4_from_u3_sq; used 2 times
    let u4_from_u3_sq_scaled = S::int(9) * u4_from_u3_sq;
    // 8*u5_from_u3_sq - u3_part_2*r1__part_19 + u4_from_u3_sq_scaled; used 2 times
    let r1__part_20 = (-u3_part_2).mul_add(r1__part_19, S::int(8) * u5_from_u3_sq)
        + u4_from_u3_sq_scaled;
    // 3*u4_from_u3_sq; used 2 times
    let u4_from_u3_sq_scaled_2 = S::int(3) * u4_from_u3_sq;
    // 3*u5_from_u3_sq; used 2 times
    let u5_from_u3_sq_scaled = S::int(3) * u5_from_u3_sq;
    // r1__part_19*cos(theta3_from_theta1) + r1__part_2*u4_from_u3_sq_scaled_2 + u5_from_u3_sq_scaled; used
    //   2 times
    let r1__part_21 = r1__part_2
        .mul_add(u4_from_u3_sq_scaled_2, r1__part_19 * cos_theta3_from_theta1)
        + u5_from_u3_sq_scaled;
    // r1__part_20*sin(theta3_from_theta1) + u3_part_3*r1__part_21; used 2 times
    let r1__part_22 = u3_part_3
        .mul_add(r1__part_21, r1__part_20 * sin_theta3_from_theta1);
    // u5_from_u3_sq + u4_from_u3_sq_scaled_2; used 2 times
    let r1__part_23 = u5_from_u3_sq + u4_from_u3_sq_scaled_2;
    // u3_part_2*r1__part_18 + r1__part_23; used 2 times
    let r1__part_24 = u3_part_2.mul_add(r1__part_18, r1__part_23);
    // r1__part_13*u4_from_u3_sq + u5_from_u3_sq_scaled; used 2 times
    let r1__part_25 = r1__part_13.mul_add(u4_from_u3_sq, u5_from_u3_sq_scaled);
    // r1__part_23 + r1__part_25*cos(theta2_from_theta1); used 2 times
    let r1__part_26 = r1__part_25.mul_add(cos_theta2_from_theta1, r1__part_23);
    // 3*sin(theta3_from_theta1); used 4 times
    let r1__part_27 = S::int(3) * sin_theta3_from_theta1;
    // 9*cos(theta3_from_theta1); used 7 times
    let r1__part_28 = S::int(9) * cos_theta3_from_theta1;
    // 7 + r1__part_28; used 6 times
    let r1__part_29 = S::int(7) + r1__part_28;
    // r1__part_29 - u3_part_4; used 2 times
    let r1__part_30 = r1__part_29 - u3_part_4;
    // 1 + u3_part_9; used 7 times
    let r1__part_31 = S::int(1) + u3_part_9;
    // u3_part_2*r1__part_31; used 2 times
    let r1__part_32 = u3_part_2 * r1__part_31;
    // 2 + cos(theta3_from_theta1); used 4 times
    let r1__part_33 = S::int(2) + cos_theta3_from_theta1;
    // u3_part_11 + r1__part_32
    let r1__part_34 = u3_part_11 + r1__part_32;
    // r1__part_33 + r1__part_34; used 3 times
    let r1__part_35 = r1__part_33 + r1__part_34;
    // 3 + u3_part_2 - u3_part_4 - r1__part_35*cos(theta3_from_theta1); used 2 times
    let r1__part_36 = (-r1__part_35)
        .mul_add(cos_theta3_from_theta1, S::int(3) + u3_part_2 - u3_part_4);
    // 9*sin(theta2_from_theta1); used 7 times
    let r1__part_37 = S::int(9) * sin_theta2_from_theta1;
    // r1__part_37*sin(theta3_from_theta1) - 12 - r1__part_30*cos(theta3_from_theta1) -
    //   u3_part_2*r1__part_36; used 2 times
    let r1__part_38 = r1__part_37.mul_add(sin_theta3_from_theta1, -S::int(12))
        - r1__part_30 * cos_theta3_from_theta1 - u3_part_2 * r1__part_36;
    // 2*r1__part_4; used 4 times
    let r1__part_4_scaled = S::int(2) * r1__part_4;
    // u5_from_u3 + r1__part_4_scaled; used 3 times
    let r1__part_39 = u5_from_u3 + r1__part_4_scaled;
    // 14*u4_from_u3; used 2 times
    let u4_from_u3_scaled_3 = S::int(14) * u4_from_u3;
    // u3_scaled_2 + u4_from_u3_scaled_3; used 2 times
    let r1__part_40 = u3_scaled_2 + u4_from_u3_scaled_3;
    // 10*u5_from_u3 + u3_part_8*r1__part_39 + r1__part_40; used 5 times
    let r1__part_41 = u3_part_8.mul_add(r1__part_39, S::int(10) * u5_from_u3)
        + r1__part_40;
    // 18*r1__part_4; used 2 times
    let r1__part_4_scaled_2 = S::int(18) * r1__part_4;
    // 14*u5_from_u3 - u3_part_2*r1__part_41 + r1__part_4_scaled_2; used 2 times
    let r1__part_42 = (-u3_part_2).mul_add(r1__part_41, S::int(14) * u5_from_u3)
        + r1__part_4_scaled_2;
    // 1 - u3_part_2; used 3 times
    let r1__part_43 = S::int(1) - u3_part_2;
    // -r1__part_43; used 2 times
    let r1__part_43_scaled = -r1__part_43;
    // u5_from_u3*r1__part_43_scaled; used 2 times
    let r1__part_44 = u5_from_u3 * r1__part_43_scaled;
    // r1__part_40 - 2*r1__part_44; used 5 times
    let r1__part_45 = (-r1__part_44).mul_add(S::int(2), r1__part_40);
    // u3_part_9*r1__part_5 + r1__part_39; used 4 times
    let r1__part_46 = u3_part_9.mul_add(r1__part_5, r1__part_39);
    // 7*u4_from_u3; used 4 times
    let u4_from_u3_scaled_4 = S::int(7) * u4_from_u3;
    // 6 + cos(theta3_from_theta1); used 3 times
    let r1__part_47 = S::int(6) + cos_theta3_from_theta1;
    // u5_from_u3*r1__part_47; used 2 times
    let r1__part_48 = u5_from_u3 * r1__part_47;
    // u4_from_u3_scaled_4 + r1__part_48; used 2 times
    let r1__part_49 = u4_from_u3_scaled_4 + r1__part_48;
    // 15 + u3_part_9; used 5 times
    let r1__part_50 = S::int(15) + u3_part_9;
    // u3*r1__part_50; used 3 times
    let u3_r1__part_50 = u3 * r1__part_50;
    // 2*r1__part_49 + u3_r1__part_50; used 4 times
    let r1__part_51 = r1__part_49.mul_add(S::int(2), u3_r1__part_50);
    // u3_part_8*r1__part_46 + r1__part_51; used 2 times
    let r1__part_52 = u3_part_8.mul_add(r1__part_46, r1__part_51);
    // r1__part_3 + u3_part_8_r1__part_5; used 4 times
    let r1__part_53 = r1__part_3 + u3_part_8_r1__part_5;
    // 3*u5_from_u3; used 3 times
    let u5_from_u3_scaled_2 = S::int(3) * u5_from_u3;
    // 3*r1__part_4 - r1__part_53*cos(theta2_from_theta1) + u5_from_u3_scaled_2; used 2 times
    let r1__part_54 = (-r1__part_53)
        .mul_add(cos_theta2_from_theta1, S::int(3) * r1__part_4) + u5_from_u3_scaled_2;
    // r1__part_52*sin(theta2_from_theta1) + r1__part_9*r1__part_54; used 2 times
    let r1__part_55 = r1__part_9
        .mul_add(r1__part_54, r1__part_52 * sin_theta2_from_theta1);
    // 3*cos(theta3_from_theta1); used 6 times
    let r1__part_56 = S::int(3) * cos_theta3_from_theta1;
    // r1__part_42*sin(theta3_from_theta1) + u3_part_3*r1__part_45 + r1__part_55*r1__part_56; used 5 times
    let r1__part_57 = u3_part_3
        .mul_add(r1__part_45, r1__part_42 * sin_theta3_from_theta1)
        + r1__part_55 * r1__part_56;
    // 7*u5_from_u3_sq + u4_from_u3_sq_scaled; used 2 times
    let r1__part_58 = u5_from_u3_sq.mul_add(S::int(7), u4_from_u3_sq_scaled);
    // r1__part_18*r1__part_28 + r1__part_58; used 2 times
    let r1__part_59 = r1__part_18.mul_add(r1__part_28, r1__part_58);
    // u5_from_u3_sq + 2*u4_from_u3_sq; used 4 times
    let r1__part_60 = u4_from_u3_sq.mul_add(S::int(2), u5_from_u3_sq);
    // u3_part_9*r1__part_18; used 4 times
    let r1__part_61 = u3_part_9 * r1__part_18;
    // r1__part_60 + r1__part_61; used 4 times
    let r1__part_62 = r1__part_60 + r1__part_61;
    // 5 + cos(theta3_from_theta1); used 2 times
    let r1__part_63 = S::int(5) + cos_theta3_from_theta1;
    // 7*u4_from_u3_sq; used 5 times
    let u4_from_u3_sq_scaled_3 = S::int(7) * u4_from_u3_sq;
    // u3_part_2*r1__part_62 + u5_from_u3_sq*r1__part_63 + u4_from_u3_sq_scaled_3; used 2 times
    let r1__part_64 = u5_from_u3_sq.mul_add(r1__part_63, u3_part_2 * r1__part_62)
        + u4_from_u3_sq_scaled_3;
    // u5_from_u3_sq - r1__part_62*cos(theta3_from_theta1); used 2 times
    let r1__part_65 = (-r1__part_62).mul_add(cos_theta3_from_theta1, u5_from_u3_sq);
    // r1__part_64*sin(theta3_from_theta1) + u3_part_3*r1__part_65; used 2 times
    let r1__part_66 = u3_part_3
        .mul_add(r1__part_65, r1__part_64 * sin_theta3_from_theta1);
    // u5_from_u3_sq*r1__part_47 + u4_from_u3_sq_scaled_3; used 3 times
    let r1__part_67 = u5_from_u3_sq.mul_add(r1__part_47, u4_from_u3_sq_scaled_3);
    // u5_from_u3_sq + u4_from_u3_sq_scaled_3 + r1__part_67*cos(theta3_from_theta1); used 2 times
    let r1__part_68 = r1__part_67
        .mul_add(cos_theta3_from_theta1, u5_from_u3_sq + u4_from_u3_sq_scaled_3);
    // u3*r1__part_57 + r1__part_59*sin(theta3_from_theta1) - u3_part_2*r1__part_66 +
    //   u3_part_3*r1__part_68; used 2 times
    let r1__part_69 = r1__part_59.mul_add(sin_theta3_from_theta1, u3 * r1__part_57)
        - u3_part_2 * r1__part_66 + u3_part_3 * r1__part_68;
    // sin(theta2_from_theta1)*sin(theta3_from_theta1); used 4 times
    let r1__part_70 = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // u3_part*cos(theta2_from_theta1) + r1__part_70; used 2 times
    let r1__part_71 = u3_part.mul_add(cos_theta2_from_theta1, r1__part_70);
    // 14 + r1__part_28 - 18*r1__part_71*cos(theta2_from_theta1); used 2 times
    let r1__part_72 = (-(r1__part_71 * cos_theta2_from_theta1))
        .mul_add(S::int(18), S::int(14) + r1__part_28);
    // cos(theta2_from_theta1)*sin(theta3_from_theta1); used 6 times
    let r1__part_73 = cos_theta2_from_theta1 * sin_theta3_from_theta1;
    // 18*sin(theta2_from_theta1); used 3 times
    let r1__part_74 = S::int(18) * sin_theta2_from_theta1;
    // 33 + r1__part_72*cos(theta3_from_theta1) - r1__part_73*r1__part_74; used 2 times
    let r1__part_75 = r1__part_72.mul_add(cos_theta3_from_theta1, S::int(33))
        - r1__part_73 * r1__part_74;
    // 1/r1__part_75; used 7 times
    let r1__part_75_inv = S::int(1) / r1__part_75;
    // r1__part_69*r1__part_75_inv; used 2 times
    let r1__part_76 = r1__part_69 * r1__part_75_inv;
    // u3*r1__part_17 + r1__part_22*cos(theta3_from_theta1) - u3_part_3*r1__part_24 -
    //   r1__part_26*r1__part_27
    let r1__part_77 = r1__part_22.mul_add(cos_theta3_from_theta1, u3 * r1__part_17)
        - u3_part_3 * r1__part_24 - r1__part_26 * r1__part_27;
    // m_l_squared_by_12*u3_part_12; used 6 times
    let r1__part_78 = m_l_squared_by_12 * u3_part_12;
    // Elimination, step by step.
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
    let r1_ = r1__part_78 * r1__part_38.mul_add(r1__part_76, r1__part_77);
    // Shared terms.
    // cos(theta2_from_theta1)*cos(theta3_from_theta1); used 2 times
    let u5_from_u3_dot_part = cos_theta2_from_theta1 * cos_theta3_from_theta1;
    // r1__part_70 + u5_from_u3_dot_part; used 2 times
    let u5_from_u3_dot_part_2 = r1__part_70 + u5_from_u3_dot_part;
    // 9*cos(theta2_from_theta1); used 7 times
    let u5_from_u3_dot_part_3 = S::int(9) * cos_theta2_from_theta1;
    // 5*cos(theta3_from_theta1) - u5_from_u3_dot_part_2*u5_from_u3_dot_part_3; used 2 times
    let u5_from_u3_dot_part_4 = (-u5_from_u3_dot_part_2)
        .mul_add(u5_from_u3_dot_part_3, S::int(5) * cos_theta3_from_theta1);
    // 1/(9 + u5_from_u3_dot_part_4*cos(theta3_from_theta1)); used 2 times
    let u5_from_u3_dot_part_5 = S::int(1)
        / u5_from_u3_dot_part_4.mul_add(cos_theta3_from_theta1, S::int(9));
    // u5_from_u3_dot_part_5/m_l_squared_by_12; used 2 times
    let u5_from_u3_dot_part_6 = u5_from_u3_dot_part_5 / m_l_squared_by_12;
    // r1__part_75*u5_from_u3_dot_part_6; used 2 times
    let u5_from_u3_dot_part_7 = r1__part_75 * u5_from_u3_dot_part_6;
    // u5_from_u3_dot_part_7/4; used 5 times
    let u5_from_u3_dot_part_8 = S::ratio(1, 4) * u5_from_u3_dot_part_7;
    // Elimination, step by step.
    // u5_from_u3' = r1_*(33 - 18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(4*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot = r1_ * u5_from_u3_dot_part_8;
    // Shared terms.
    // 2*H_n3_scaled_per_m_per_l_squared; used 4 times
    let u3_by_theta2_from_theta1_part = S::int(2) * H_n3_scaled_per_m_per_l_squared;
    // 5*u5_from_u3; used 2 times
    let u5_from_u3_scaled_3 = S::int(5) * u5_from_u3;
    // u4_from_u3 - u3_by_theta2_from_theta1_part; used 2 times
    let u3_by_theta2_from_theta1_part_2 = u4_from_u3 - u3_by_theta2_from_theta1_part;
    // 7*u5_from_u3; used 4 times
    let u5_from_u3_scaled_4 = S::int(7) * u5_from_u3;
    // u3_by_theta2_from_theta1_part + u5_from_u3_scaled_4; used 2 times
    let u3_by_theta2_from_theta1_part_3 = u3_by_theta2_from_theta1_part
        + u5_from_u3_scaled_4;
    // u3_part_12^2; used 2 times
    let u3_part_12_sq = u3_part_12 * u3_part_12;
    // Elimination, step by step.
    // u3_by_theta2_from_theta1 = -3*(sin(theta2_from_theta1)*(u4_from_u3 + 6*u5_from_u3 -
    //   2*H_n3_scaled_per_m_per_l_squared - cos(theta3_from_theta1)*(u4_from_u3*(1 +
    //   2*cos(theta3_from_theta1)) + 5*u5_from_u3 + 2*H_n3_scaled_per_m_per_l_squared)) +
    //   sin(theta3_from_theta1)*(6*u5_from_u3 +
    //   cos(theta2_from_theta1)*(u4_from_u3*(2*cos(theta3_from_theta1) - 1) + 7*u5_from_u3 +
    //   2*H_n3_scaled_per_m_per_l_squared)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2
    let u3_by_theta2_from_theta1 = -S::int(3) * u3_part_12_sq
        * (sin_theta2_from_theta1
            * (u5_from_u3_scaled
                - cos_theta3_from_theta1
                    * (u4_from_u3.mul_add(r1__part_31, u3_by_theta2_from_theta1_part)
                        + u5_from_u3_scaled_3) + u3_by_theta2_from_theta1_part_2)
            + sin_theta3_from_theta1
                * (u5_from_u3_scaled
                    + cos_theta2_from_theta1
                        * (u4_from_u3 * (u3_part_9 - S::int(1))
                            + u3_by_theta2_from_theta1_part_3)));
    // Shared terms.
    // u3_part_3*r1__part_5 - u3_by_theta2_from_theta1*u3_part_6; used 3 times
    let r1__by_theta2_from_theta1_part = (-u3_by_theta2_from_theta1)
        .mul_add(u3_part_6, u3_part_3 * r1__part_5);
    // 4*cos(theta3_from_theta1); used 3 times
    let r1__by_theta2_from_theta1_part_2 = S::int(4) * cos_theta3_from_theta1;
    // 13*u3_by_theta2_from_theta1; used 2 times
    let r1__by_theta2_from_theta1_part_3 = S::int(13) * u3_by_theta2_from_theta1;
    // r1__part_18*sin(theta2_from_theta1); used 2 times
    let r1__by_theta2_from_theta1_part_4 = r1__part_18 * sin_theta2_from_theta1;
    // u4_from_u3_sq*sin(theta2_from_theta1); used 2 times
    let r1__by_theta2_from_theta1_part_5 = u4_from_u3_sq * sin_theta2_from_theta1;
    // u3_by_theta2_from_theta1*u3_part; used 2 times
    let r1__by_theta2_from_theta1_part_6 = u3_by_theta2_from_theta1 * u3_part;
    // 12*cos(theta2_from_theta1); used 5 times
    let r1__by_theta2_from_theta1_part_7 = S::int(12) * cos_theta2_from_theta1;
    // 1 + u3_part_8; used 5 times
    let r1__by_theta2_from_theta1_part_8 = S::int(1) + u3_part_8;
    // u3_part_10*r1__part_5 - u3_by_theta2_from_theta1*r1__by_theta2_from_theta1_part_8; used 2 times
    let r1__by_theta2_from_theta1_part_9 = (-u3_by_theta2_from_theta1)
        .mul_add(r1__by_theta2_from_theta1_part_8, u3_part_10 * r1__part_5);
    // 13 + r1__by_theta2_from_theta1_part_7; used 2 times
    let r1__by_theta2_from_theta1_part_10 = S::int(13)
        + r1__by_theta2_from_theta1_part_7;
    // u3_by_theta2_from_theta1*r1__by_theta2_from_theta1_part_10 - u3_part_10*r1__part_39; used 2 times
    let r1__by_theta2_from_theta1_part_11 = (-u3_part_10)
        .mul_add(
            r1__part_39,
            u3_by_theta2_from_theta1 * r1__by_theta2_from_theta1_part_10,
        );
    // u5_from_u3*u3_part_10 + r1__by_theta2_from_theta1_part_3; used 2 times
    let r1__by_theta2_from_theta1_part_12 = u5_from_u3
        .mul_add(u3_part_10, r1__by_theta2_from_theta1_part_3);
    // r1__part_75_inv*r1__part_78; used 2 times
    let r1__by_theta2_from_theta1_part_13 = r1__part_75_inv * r1__part_78;
    // r1__part_38*r1__by_theta2_from_theta1_part_13; used 5 times
    let r1__by_theta2_from_theta1_part_14 = r1__part_38
        * r1__by_theta2_from_theta1_part_13;
    // sin(theta2_from_theta1) + cos(theta3_from_theta1)*(r1__part_9*cos(theta2_from_theta1) -
    //   r1__part_31*sin(theta2_from_theta1)) + r1__part_73
    let r1__by_theta2_from_theta1_part_15 = sin_theta2_from_theta1
        + cos_theta3_from_theta1
            * (-r1__part_31)
                .mul_add(sin_theta2_from_theta1, r1__part_9 * cos_theta2_from_theta1)
        + r1__part_73;
    // r1__part_69*r1__by_theta2_from_theta1_part_13; used 2 times
    let r1__by_theta2_from_theta1_part_16 = r1__part_69
        * r1__by_theta2_from_theta1_part_13;
    // r1__part_73 - u3_part*sin(theta2_from_theta1); used 2 times
    let r1__by_theta2_from_theta1_part_17 = (-u3_part)
        .mul_add(sin_theta2_from_theta1, r1__part_73);
    // r1__part_70*sin(theta2_from_theta1) - r1__part_73*cos(theta2_from_theta1) +
    //   cos(theta3_from_theta1)*(r1__part_71*sin(theta2_from_theta1) -
    //   r1__by_theta2_from_theta1_part_17*cos(theta2_from_theta1)); used 2 times
    let r1__by_theta2_from_theta1_part_18 = r1__part_70 * sin_theta2_from_theta1
        - r1__part_73 * cos_theta2_from_theta1
        + cos_theta3_from_theta1
            * (-r1__by_theta2_from_theta1_part_17)
                .mul_add(cos_theta2_from_theta1, r1__part_71 * sin_theta2_from_theta1);
    // 18*r1__by_theta2_from_theta1_part_18; used 2 times
    let r1__by_theta2_from_theta1_part_19 = S::int(18)
        * r1__by_theta2_from_theta1_part_18;
    // r1__part_76*r1__by_theta2_from_theta1_part_14; used 2 times
    let r1__by_theta2_from_theta1_part_20 = r1__part_76
        * r1__by_theta2_from_theta1_part_14;
    // r1_*u3_part_12; used 2 times
    let r1__u3_part_12 = r1_ * u3_part_12;
    // Elimination, step by step.
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
    let r1__by_theta2_from_theta1 = r1__part_78
        * (u3_by_theta2_from_theta1 * r1__part_17 - u3_part_2 * r1__part_24
            + u3
                * (u3_part_10 * r1__by_theta2_from_theta1_part - u3_part_8 * r1__part_16
                    + cos_theta3_from_theta1
                        * (r1__part_9
                            * (u3_part_3
                                .mul_add(r1__part_6, S::int(8) * u3_by_theta2_from_theta1)
                                + u3_part_8 * r1__by_theta2_from_theta1_part)
                            + u3_part_2 * r1__part_7
                            + u3_part_3
                                * ((-u3_part_10)
                                    .mul_add(r1__part_4, u3_by_theta2_from_theta1 * r1__part)
                                    - r1__by_theta2_from_theta1_part
                                        * r1__by_theta2_from_theta1_part_2))
                    + sin_theta3_from_theta1
                        * (-u5_from_u3_dot_part_3
                            * (-r1__part_4_scaled)
                                .mul_add(
                                    sin_theta2_from_theta1,
                                    u3_by_theta2_from_theta1 * r1__part_12,
                                ) + u3_part_3 * r1__part_14
                            - r1__by_theta2_from_theta1_part_3))
            + r1__part_37 * r1__by_theta2_from_theta1_part_4
            + r1__part_56
                * (sin_theta3_from_theta1
                    * u3_part_8
                        .mul_add(
                            r1__by_theta2_from_theta1_part_4,
                            r1__part_19 * sin_theta2_from_theta1,
                        ) + r1__part_21 * cos_theta2_from_theta1
                    - u3_part_3
                        * r1__part_61
                            .mul_add(
                                sin_theta2_from_theta1,
                                r1__by_theta2_from_theta1_part_5,
                            ))
            + r1__part_27
                * u3_part_2
                    .mul_add(
                        r1__by_theta2_from_theta1_part_5,
                        r1__part_25 * sin_theta2_from_theta1,
                    ))
        + r1__by_theta2_from_theta1_part_14
            * (u3_by_theta2_from_theta1 * r1__part_57 + u3_part_3 * r1__part_66
                + u3_part_2 * r1__part_68
                + u5_from_u3_dot_part_3
                    * (-r1__part_65)
                        .mul_add(cos_theta2_from_theta1, r1__part_62 * r1__part_70)
                + u3_scaled
                    * (cos_theta3_from_theta1
                        * (sin_theta2_from_theta1
                            * ((-u3_part_10)
                                .mul_add(
                                    r1__part_46,
                                    u3_by_theta2_from_theta1 * r1__part_50,
                                )
                                + r1__by_theta2_from_theta1_part_6
                                    * r1__by_theta2_from_theta1_part_7)
                            + r1__part_52 * cos_theta2_from_theta1
                            + r1__part_9
                                * (r1__part_53
                                    .mul_add(
                                        sin_theta2_from_theta1,
                                        S::int(3) * u3_by_theta2_from_theta1,
                                    )
                                    + r1__by_theta2_from_theta1_part_9
                                        * cos_theta2_from_theta1))
                        + r1__part_45 * cos_theta2_from_theta1
                        + sin_theta3_from_theta1
                            * (r1__part_41
                                .mul_add(
                                    sin_theta2_from_theta1,
                                    S::int(6) * u3_by_theta2_from_theta1,
                                )
                                - r1__by_theta2_from_theta1_part_11
                                    * cos_theta2_from_theta1)
                        + r1__by_theta2_from_theta1_part_12 * sin_theta2_from_theta1))
        + S::int(3) * r1__by_theta2_from_theta1_part_16
            * (r1__part_36 * sin_theta2_from_theta1
                + r1__part_73 * cos_theta3_from_theta1
                + u3_part_2
                    * (sin_theta3_from_theta1 + r1__by_theta2_from_theta1_part_15))
        - r1__by_theta2_from_theta1_part_19 * r1__by_theta2_from_theta1_part_20
        - S::int(6) * r1__by_theta2_from_theta1_part_17 * r1__u3_part_12;
    // Shared terms.
    // sin(theta2_from_theta1)*cos(theta3_from_theta1); used 2 times
    let u5_from_u3_dot_by_theta2_from_theta1_part = sin_theta2_from_theta1
        * cos_theta3_from_theta1;
    // r1__part_73 - u5_from_u3_dot_by_theta2_from_theta1_part; used 3 times
    let u5_from_u3_dot_by_theta2_from_theta1_part_2 = r1__part_73
        - u5_from_u3_dot_by_theta2_from_theta1_part;
    // r1_*u5_from_u3_dot_part_5; used 2 times
    let u5_from_u3_dot_by_theta2_from_theta1_part_3 = r1_ * u5_from_u3_dot_part_5;
    // r1_*u5_from_u3_dot_part_6; used 2 times
    let u5_from_u3_dot_by_theta2_from_theta1_part_4 = r1_ * u5_from_u3_dot_part_6;
    // Elimination, step by step.
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
    let u5_from_u3_dot_by_theta2_from_theta1 = S::ratio(9, 4) * u5_from_u3_dot_part_7
        * u5_from_u3_dot_by_theta2_from_theta1_part_3 * cos_theta3_from_theta1
        * (-u5_from_u3_dot_part_2)
            .mul_add(
                sin_theta2_from_theta1,
                u5_from_u3_dot_by_theta2_from_theta1_part_2 * cos_theta2_from_theta1,
            ) + r1__by_theta2_from_theta1 * u5_from_u3_dot_part_8
        + S::ratio(9, 2) * r1__by_theta2_from_theta1_part_18
            * u5_from_u3_dot_by_theta2_from_theta1_part_4;
    // Shared terms.
    // u3 + r1__part_5; used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part = u3 + r1__part_5;
    // 18*sin(theta3_from_theta1); used 5 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_2 = S::int(18)
        * sin_theta3_from_theta1;
    // u5_from_u3'*sin(theta3_from_theta1); used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_3 = u5_from_u3_dot
        * sin_theta3_from_theta1;
    // u3*r1__part_51 + r1__part_67 + u4_from_u3_dot_by_theta2_from_theta1_part_3; used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_4 = u3
        .mul_add(r1__part_51, r1__part_67) + u4_from_u3_dot_by_theta2_from_theta1_part_3;
    // u5_from_u3'*r1__part_9 + r1__part_61; used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_5 = u5_from_u3_dot
        .mul_add(r1__part_9, r1__part_61);
    // r1__part_60 + u4_from_u3_dot_by_theta2_from_theta1_part_5; used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_6 = r1__part_60
        + u4_from_u3_dot_by_theta2_from_theta1_part_5;
    // r1__part_9*r1__part_18 - u5_from_u3'*r1__part_31; used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_7 = (-u5_from_u3_dot)
        .mul_add(r1__part_31, r1__part_9 * r1__part_18);
    // 2*u3; used 7 times
    let u3_scaled_3 = S::int(2) * u3;
    // u3_part_3*r1__part_46 - r1__part_53*sin(theta3_from_theta1); used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_8 = (-r1__part_53)
        .mul_add(sin_theta3_from_theta1, u3_part_3 * r1__part_46);
    // 2*u4_from_u3_dot_by_theta2_from_theta1_part_8; used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_9 = S::int(2)
        * u4_from_u3_dot_by_theta2_from_theta1_part_8;
    // u5_from_u3_dot_by_theta2_from_theta1*r1__part_35 +
    //   u3_part_2*u4_from_u3_dot_by_theta2_from_theta1_part_6 +
    //   u3_part_3*u4_from_u3_dot_by_theta2_from_theta1_part_7 + u3_scaled_3*(u3_part_2*r1__part_46 +
    //   u3_part_10*r1__by_theta2_from_theta1_part_6 +
    //   r1__by_theta2_from_theta1_part_9*sin(theta3_from_theta1)) +
    //   u3_by_theta2_from_theta1*u4_from_u3_dot_by_theta2_from_theta1_part_9
    let u4_from_u3_dot_by_theta2_from_theta1_part_10 = u5_from_u3_dot_by_theta2_from_theta1
        * r1__part_35 + u3_part_2 * u4_from_u3_dot_by_theta2_from_theta1_part_6
        + u3_part_3 * u4_from_u3_dot_by_theta2_from_theta1_part_7
        + u3_scaled_3
            * (u3_part_10
                .mul_add(r1__by_theta2_from_theta1_part_6, u3_part_2 * r1__part_46)
                + r1__by_theta2_from_theta1_part_9 * sin_theta3_from_theta1)
        + u3_by_theta2_from_theta1 * u4_from_u3_dot_by_theta2_from_theta1_part_9;
    // u5_from_u3_sq*sin(theta3_from_theta1); used 4 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_11 = u5_from_u3_sq
        * sin_theta3_from_theta1;
    // u3_part_2*u4_from_u3_dot_by_theta2_from_theta1_part_7 - u5_from_u3'*r1__part_33 -
    //   u3_part_3*u4_from_u3_dot_by_theta2_from_theta1_part_6 -
    //   u3_scaled_3*u4_from_u3_dot_by_theta2_from_theta1_part_8 +
    //   u4_from_u3_dot_by_theta2_from_theta1_part_11; used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_12 = (-u5_from_u3_dot)
        .mul_add(r1__part_33, u3_part_2 * u4_from_u3_dot_by_theta2_from_theta1_part_7)
        - u3_part_3 * u4_from_u3_dot_by_theta2_from_theta1_part_6
        - u3_scaled_3 * u4_from_u3_dot_by_theta2_from_theta1_part_8
        + u4_from_u3_dot_by_theta2_from_theta1_part_11;
    // u5_from_u3_dot_by_theta2_from_theta1*sin(theta3_from_theta1) +
    //   u3_by_theta2_from_theta1*(u3_r1__part_50 + r1__part_51)
    let u4_from_u3_dot_by_theta2_from_theta1_part_13 = u3_by_theta2_from_theta1
        * (u3_r1__part_50 + r1__part_51)
        + u5_from_u3_dot_by_theta2_from_theta1 * sin_theta3_from_theta1;
    // 5*u5_from_u3_sq - u5_from_u3'*u3_part_3 + u3*r1__part_41 + u3_part_2*r1__part_60 +
    //   u4_from_u3_sq_scaled_3; used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_14 = (-u5_from_u3_dot)
        .mul_add(u3_part_3, S::int(5) * u5_from_u3_sq) + u3 * r1__part_41
        + u3_part_2 * r1__part_60 + u4_from_u3_sq_scaled_3;
    // 9*r1__part_4 + u5_from_u3_scaled_4; used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_15 = r1__part_4
        .mul_add(S::int(9), u5_from_u3_scaled_4);
    // 9*u3 + u4_from_u3_dot_by_theta2_from_theta1_part_15
    let u4_from_u3_dot_by_theta2_from_theta1_part_16 = u3
        .mul_add(S::int(9), u4_from_u3_dot_by_theta2_from_theta1_part_15);
    // 2*u4_from_u3_dot_by_theta2_from_theta1_part_16; used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_17 = S::int(2)
        * u4_from_u3_dot_by_theta2_from_theta1_part_16;
    // 1 + cos(theta2_from_theta1); used 3 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_18 = S::int(1)
        + cos_theta2_from_theta1;
    // u3*r1__part_45 - u5_from_u3_sq*r1__part_43_scaled + u4_from_u3_sq_scaled_3; used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_19 = (-u5_from_u3_sq)
        .mul_add(r1__part_43_scaled, u3 * r1__part_45) + u4_from_u3_sq_scaled_3;
    // 4 + u3_part_2*u4_from_u3_dot_by_theta2_from_theta1_part_18
    let u4_from_u3_dot_by_theta2_from_theta1_part_20 = u3_part_2
        .mul_add(u4_from_u3_dot_by_theta2_from_theta1_part_18, S::int(4));
    // 3*u4_from_u3_dot_by_theta2_from_theta1_part_20; used 5 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_21 = S::int(3)
        * u4_from_u3_dot_by_theta2_from_theta1_part_20;
    // r1__part_18 + r1__part_5*u3_scaled_3; used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_22 = r1__part_5
        .mul_add(u3_scaled_3, r1__part_18);
    // 9*sin(theta3_from_theta1); used 3 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_23 = S::int(9)
        * sin_theta3_from_theta1;
    // u3_part_3*u4_from_u3_dot_by_theta2_from_theta1_part_4 - u5_from_u3'*r1__part_29 -
    //   u3_part_2*u4_from_u3_dot_by_theta2_from_theta1_part_12 +
    //   u4_from_u3_dot_by_theta2_from_theta1_part_22*u4_from_u3_dot_by_theta2_from_theta1_part_23; used 2
    //   times
    let u4_from_u3_dot_by_theta2_from_theta1_part_24 = (-u5_from_u3_dot)
        .mul_add(r1__part_29, u3_part_3 * u4_from_u3_dot_by_theta2_from_theta1_part_4)
        - u3_part_2 * u4_from_u3_dot_by_theta2_from_theta1_part_12
        + u4_from_u3_dot_by_theta2_from_theta1_part_22
            * u4_from_u3_dot_by_theta2_from_theta1_part_23;
    // u5_from_u3'*r1__part_37 + r1__part_58 - u3_part_2*u4_from_u3_dot_by_theta2_from_theta1_part_14 +
    //   u3_scaled_3*u4_from_u3_dot_by_theta2_from_theta1_part_15; used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_25 = u5_from_u3_dot
        .mul_add(r1__part_37, r1__part_58)
        - u3_part_2 * u4_from_u3_dot_by_theta2_from_theta1_part_14
        + u3_scaled_3 * u4_from_u3_dot_by_theta2_from_theta1_part_15;
    // r1__part_75_inv^2*(u3_part_3*u4_from_u3_dot_by_theta2_from_theta1_part_19 -
    //   u5_from_u3'*u4_from_u3_dot_by_theta2_from_theta1_part_21 +
    //   u4_from_u3_dot_by_theta2_from_theta1_part_24*cos(theta3_from_theta1) +
    //   u4_from_u3_dot_by_theta2_from_theta1_part_25*sin(theta3_from_theta1)); used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_26 = r1__part_75_inv * r1__part_75_inv
        * ((-u5_from_u3_dot)
            .mul_add(
                u4_from_u3_dot_by_theta2_from_theta1_part_21,
                u3_part_3 * u4_from_u3_dot_by_theta2_from_theta1_part_19,
            ) + u4_from_u3_dot_by_theta2_from_theta1_part_24 * cos_theta3_from_theta1
            + u4_from_u3_dot_by_theta2_from_theta1_part_25 * sin_theta3_from_theta1);
    // Elimination, step by step.
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
    let u4_from_u3_dot_by_theta2_from_theta1 = r1__part_75_inv
        * (cos_theta3_from_theta1
            * (u5_from_u3_dot_by_theta2_from_theta1 * r1__part_29
                - u3_by_theta2_from_theta1 * u4_from_u3_dot_by_theta2_from_theta1_part
                    * u4_from_u3_dot_by_theta2_from_theta1_part_2
                - u3_part_2
                    * (u4_from_u3_dot_by_theta2_from_theta1_part_4
                        + u4_from_u3_dot_by_theta2_from_theta1_part_10)
                - u3_part_3
                    * (u4_from_u3_dot_by_theta2_from_theta1_part_12
                        + u4_from_u3_dot_by_theta2_from_theta1_part_13))
            - u3_part_3
                * (u3_by_theta2_from_theta1
                    .mul_add(r1__part_45, u3_part_3 * u5_from_u3_sq)
                    + u3 * r1__by_theta2_from_theta1_part_12)
            + sin_theta3_from_theta1
                * (u3_part_2
                    * (u3_by_theta2_from_theta1 * r1__part_41
                        - u5_from_u3_dot * u3_part_2
                        - u3_part_3
                            * (u5_from_u3_dot_by_theta2_from_theta1 + r1__part_60)
                        + u3 * r1__by_theta2_from_theta1_part_11)
                    - u5_from_u3_dot_by_theta2_from_theta1 * r1__part_37
                    - u5_from_u3_dot * u5_from_u3_dot_part_3
                    - u3_part_3 * u4_from_u3_dot_by_theta2_from_theta1_part_14
                    - u3_by_theta2_from_theta1
                        * u4_from_u3_dot_by_theta2_from_theta1_part_17)
            - S::int(9) * u5_from_u3_dot * sin_theta2_from_theta1
                * (cos_theta2_from_theta1 + u4_from_u3_dot_by_theta2_from_theta1_part_18)
            - u3_part_2 * u4_from_u3_dot_by_theta2_from_theta1_part_19
            + u5_from_u3_dot_by_theta2_from_theta1
                * u4_from_u3_dot_by_theta2_from_theta1_part_21)
        + r1__by_theta2_from_theta1_part_19
            * u4_from_u3_dot_by_theta2_from_theta1_part_26;
    // Shared terms.
    // 7 + u3_part_8; used 2 times
    let u3_by_theta3_from_theta1_part = S::int(7) + u3_part_8;
    // Elimination, step by step.
    // u3_by_theta3_from_theta1 = -(sin(theta3_from_theta1)*(14*u4_from_u3 - 7*u5_from_u3 -
    //   2*H_n3_scaled_per_m_per_l_squared + 3*cos(theta2_from_theta1)*(3*u4_from_u3 - 3*u5_from_u3*(3 +
    //   2*cos(theta2_from_theta1)) - 2*H_n3_scaled_per_m_per_l_squared)) +
    //   3*sin(theta2_from_theta1)*(2*u4_from_u3 + cos(theta3_from_theta1)*(u5_from_u3*(7 +
    //   6*cos(theta2_from_theta1)) - u4_from_u3 + 2*H_n3_scaled_per_m_per_l_squared)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2
    let u3_by_theta3_from_theta1 = -u3_part_12_sq
        * (sin_theta3_from_theta1
            * (u4_from_u3_scaled_3
                + u3_part_2
                    * (u4_from_u3_scaled_2
                        - u5_from_u3_scaled_2 * (S::int(3) + r1__part_11)
                        - u3_by_theta2_from_theta1_part)
                - u3_by_theta2_from_theta1_part_3)
            + u3_part_3
                * (u4_from_u3_scaled
                    + cos_theta3_from_theta1
                        * u5_from_u3
                            .mul_add(
                                u3_by_theta3_from_theta1_part,
                                -u3_by_theta2_from_theta1_part_2,
                            )));
    // Shared terms.
    // u3_by_theta3_from_theta1*u3_part_6; used 3 times
    let r1__by_theta3_from_theta1_part = u3_by_theta3_from_theta1 * u3_part_6;
    // 4*sin(theta3_from_theta1); used 2 times
    let r1__by_theta3_from_theta1_part_2 = S::int(4) * sin_theta3_from_theta1;
    // u3_part_3*(r1__part_6*r1__part_9 - u3_by_theta3_from_theta1*r1__part -
    //   r1__by_theta2_from_theta1_part_2*r1__by_theta3_from_theta1_part) - u3_part_9*r1__part_8 +
    //   r1__by_theta3_from_theta1_part_2*(u3_part_2*r1__by_theta3_from_theta1_part -
    //   4*u3_by_theta3_from_theta1)
    let r1__by_theta3_from_theta1_part_3 = u3_part_3
        * ((-u3_by_theta3_from_theta1).mul_add(r1__part, r1__part_6 * r1__part_9)
            - r1__by_theta2_from_theta1_part_2 * r1__by_theta3_from_theta1_part)
        - u3_part_9 * r1__part_8
        + r1__by_theta3_from_theta1_part_2
            * (-u3_by_theta3_from_theta1)
                .mul_add(S::int(4), u3_part_2 * r1__by_theta3_from_theta1_part);
    // r1__part_5*sin(theta3_from_theta1) - u3_by_theta3_from_theta1*u3_part; used 2 times
    let r1__by_theta3_from_theta1_part_4 = (-u3_by_theta3_from_theta1)
        .mul_add(u3_part, r1__part_5 * sin_theta3_from_theta1);
    // u3_by_theta3_from_theta1*r1__part_50 - r1__part_3*r1__part_9; used 2 times
    let r1__by_theta3_from_theta1_part_5 = (-r1__part_3)
        .mul_add(r1__part_9, u3_by_theta3_from_theta1 * r1__part_50);
    // u3_by_theta3_from_theta1*r1__by_theta2_from_theta1_part_8; used 2 times
    let r1__by_theta3_from_theta1_part_6 = u3_by_theta3_from_theta1
        * r1__by_theta2_from_theta1_part_8;
    // u3_by_theta3_from_theta1*r1__by_theta2_from_theta1_part_10; used 2 times
    let r1__by_theta3_from_theta1_part_7 = u3_by_theta3_from_theta1
        * r1__by_theta2_from_theta1_part_10;
    // 6*u3_by_theta3_from_theta1 - r1__by_theta3_from_theta1_part_7*cos(theta2_from_theta1)
    let r1__by_theta3_from_theta1_part_8 = (-r1__by_theta3_from_theta1_part_7)
        .mul_add(cos_theta2_from_theta1, S::int(6) * u3_by_theta3_from_theta1);
    // r1__part_18*sin(theta3_from_theta1); used 3 times
    let r1__by_theta3_from_theta1_part_9 = r1__part_18 * sin_theta3_from_theta1;
    // u3_part_10*cos(theta3_from_theta1); used 2 times
    let r1__by_theta3_from_theta1_part_10 = u3_part_10 * cos_theta3_from_theta1;
    // u3_part_3*cos(theta3_from_theta1); used 2 times
    let r1__by_theta3_from_theta1_part_11 = u3_part_3 * cos_theta3_from_theta1;
    // r1__part_72*sin(theta3_from_theta1) + r1__part_74*u5_from_u3_dot_part +
    //   r1__part_28*(sin(theta3_from_theta1) - r1__part_11*u5_from_u3_dot_by_theta2_from_theta1_part_2);
    //   used 3 times
    let r1__by_theta3_from_theta1_part_12 = r1__part_72 * sin_theta3_from_theta1
        + r1__part_74 * u5_from_u3_dot_part
        + r1__part_28
            * (-r1__part_11)
                .mul_add(
                    u5_from_u3_dot_by_theta2_from_theta1_part_2,
                    sin_theta3_from_theta1,
                );
    // Elimination, step by step.
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
    let r1__by_theta3_from_theta1 = r1__part_78
        * (-cos_theta3_from_theta1
            * (-r1__part_20).mul_add(cos_theta3_from_theta1, u3_part_4 * r1__part_19)
            + u3_by_theta3_from_theta1 * r1__part_17
            - r1__part_22 * sin_theta3_from_theta1 - r1__part_26 * r1__part_56
            - u3
                * (sin_theta3_from_theta1
                    * (r1__part_10
                        + u3_by_theta3_from_theta1
                            * r1__part_12.mul_add(u5_from_u3_dot_part_3, S::int(13)))
                    + u3_part_10 * r1__by_theta3_from_theta1_part
                    + cos_theta3_from_theta1
                        * (r1__part_15 + r1__by_theta3_from_theta1_part_3)))
        + r1__by_theta2_from_theta1_part_14
            * (u3_by_theta3_from_theta1 * r1__part_57
                + r1__part_59 * cos_theta3_from_theta1
                - u3_part_3
                    * u4_from_u3_dot_by_theta2_from_theta1_part_11
                        .mul_add(
                            cos_theta3_from_theta1,
                            r1__part_67 * sin_theta3_from_theta1,
                        )
                + u3
                    * (S::int(39) * u3_by_theta3_from_theta1 * sin_theta2_from_theta1
                        + r1__part_42 * cos_theta3_from_theta1
                        + r1__part_56
                            * (sin_theta2_from_theta1
                                * (-r1__by_theta2_from_theta1_part_7)
                                    .mul_add(
                                        r1__by_theta3_from_theta1_part_4,
                                        r1__by_theta3_from_theta1_part_5,
                                    ) + u3_part_9 * r1__part_54
                                + r1__part_9
                                    * (-r1__by_theta3_from_theta1_part_6)
                                        .mul_add(
                                            cos_theta2_from_theta1,
                                            S::int(3) * u3_by_theta3_from_theta1,
                                        ))
                        + r1__part_27 * (r1__by_theta3_from_theta1_part_8 - r1__part_55))
                - u4_from_u3_dot_by_theta2_from_theta1_part_23
                    * r1__by_theta3_from_theta1_part_9
                + u3_part_2
                    * (sin_theta3_from_theta1
                        * u3_part_8
                            .mul_add(
                                r1__by_theta3_from_theta1_part_9,
                                u4_from_u3_dot_by_theta2_from_theta1_part_11,
                            )
                        - u3_part_3 * sin_theta3_from_theta1
                            * (r1__part_61 + r1__part_62)
                        - r1__part_64 * cos_theta3_from_theta1))
        + r1__by_theta2_from_theta1_part_16
            * (r1__part_28 * sin_theta2_from_theta1
                + r1__part_30 * sin_theta3_from_theta1
                + r1__part_56 * (r1__part_27 + u5_from_u3_dot_by_theta2_from_theta1_part)
                + u3_part_2
                    * (cos_theta3_from_theta1
                        * (-r1__by_theta2_from_theta1_part_8)
                            .mul_add(
                                sin_theta3_from_theta1,
                                r1__by_theta3_from_theta1_part_10,
                            ) - r1__part_35 * sin_theta3_from_theta1
                        + r1__by_theta3_from_theta1_part_11))
        + S::int(2) * r1__u3_part_12
            * u3_part_6
                .mul_add(sin_theta3_from_theta1, -r1__by_theta3_from_theta1_part_11)
        + r1__by_theta2_from_theta1_part_20 * r1__by_theta3_from_theta1_part_12;
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
    let u5_from_u3_dot_by_theta3_from_theta1 = u5_from_u3_dot_part_8
        * (r1__by_theta3_from_theta1
            + u5_from_u3_dot_by_theta2_from_theta1_part_3
                * (cos_theta3_from_theta1
                    * (-u5_from_u3_dot_part_3)
                        .mul_add(
                            u5_from_u3_dot_by_theta2_from_theta1_part_2,
                            S::int(5) * sin_theta3_from_theta1,
                        ) + u5_from_u3_dot_part_4 * sin_theta3_from_theta1))
        - S::ratio(1, 4) * u5_from_u3_dot_by_theta2_from_theta1_part_4
            * r1__by_theta3_from_theta1_part_12;
    // Shared terms.
    // u5_from_u3'*cos(theta3_from_theta1) + u5_from_u3_dot_by_theta3_from_theta1*sin(theta3_from_theta1);
    //   used 2 times
    let u4_from_u3_dot_by_theta3_from_theta1_part = u5_from_u3_dot_by_theta3_from_theta1
        .mul_add(sin_theta3_from_theta1, u5_from_u3_dot * cos_theta3_from_theta1);
    // u3_by_theta3_from_theta1*u4_from_u3_dot_by_theta2_from_theta1_part*u4_from_u3_dot_by_theta2_from_theta1_part_2
    //   - u5_from_u3_dot_by_theta3_from_theta1*r1__part_29 +
    //   r1__part_28*u4_from_u3_dot_by_theta2_from_theta1_part_22 +
    //   u5_from_u3'*u4_from_u3_dot_by_theta2_from_theta1_part_23 +
    //   u3_part_2*(u5_from_u3_dot_by_theta3_from_theta1*r1__part_33 - u5_from_u3_sq*cos(theta3_from_theta1)
    //   - u4_from_u3_dot_by_theta2_from_theta1_part_3 -
    //   u3_part_2*(u4_from_u3_dot_by_theta2_from_theta1_part_5 -
    //   u5_from_u3_dot_by_theta3_from_theta1*r1__part_31) +
    //   u3_by_theta3_from_theta1*u4_from_u3_dot_by_theta2_from_theta1_part_9 -
    //   u3_scaled_3*(r1__part_53*cos(theta3_from_theta1) + u3_part_10*r1__by_theta3_from_theta1_part_4 +
    //   r1__by_theta3_from_theta1_part_6*sin(theta3_from_theta1)) -
    //   u3_part_10*(r1__by_theta3_from_theta1_part_9 - u4_from_u3_dot_by_theta3_from_theta1_part)) +
    //   u3_part_3*(u3_by_theta3_from_theta1*r1__part_51 - u4_from_u3_dot_by_theta2_from_theta1_part_11 +
    //   u3*r1__by_theta3_from_theta1_part_5 + u4_from_u3_dot_by_theta3_from_theta1_part)
    let u4_from_u3_dot_by_theta3_from_theta1_part_2 = u3_by_theta3_from_theta1
        * u4_from_u3_dot_by_theta2_from_theta1_part
        * u4_from_u3_dot_by_theta2_from_theta1_part_2
        - u5_from_u3_dot_by_theta3_from_theta1 * r1__part_29
        + r1__part_28 * u4_from_u3_dot_by_theta2_from_theta1_part_22
        + u5_from_u3_dot * u4_from_u3_dot_by_theta2_from_theta1_part_23
        + u3_part_2
            * (u5_from_u3_dot_by_theta3_from_theta1 * r1__part_33
                - u5_from_u3_sq * cos_theta3_from_theta1
                - u4_from_u3_dot_by_theta2_from_theta1_part_3
                - u3_part_2
                    * (-u5_from_u3_dot_by_theta3_from_theta1)
                        .mul_add(
                            r1__part_31,
                            u4_from_u3_dot_by_theta2_from_theta1_part_5,
                        )
                + u3_by_theta3_from_theta1 * u4_from_u3_dot_by_theta2_from_theta1_part_9
                - u3_scaled_3
                    * (u3_part_10
                        .mul_add(
                            r1__by_theta3_from_theta1_part_4,
                            r1__part_53 * cos_theta3_from_theta1,
                        ) + r1__by_theta3_from_theta1_part_6 * sin_theta3_from_theta1)
                - u3_part_10
                    * (r1__by_theta3_from_theta1_part_9
                        - u4_from_u3_dot_by_theta3_from_theta1_part))
        + u3_part_3
            * (u3_by_theta3_from_theta1
                .mul_add(r1__part_51, -u4_from_u3_dot_by_theta2_from_theta1_part_11)
                + u3 * r1__by_theta3_from_theta1_part_5
                + u4_from_u3_dot_by_theta3_from_theta1_part);
    // u5_from_u3_dot_by_theta3_from_theta1*r1__part_37 +
    //   u3_by_theta3_from_theta1*u4_from_u3_dot_by_theta2_from_theta1_part_17 +
    //   u3_part_2*(u5_from_u3_dot_by_theta3_from_theta1*u3_part_3 - u3_by_theta3_from_theta1*r1__part_41 -
    //   u3*r1__by_theta3_from_theta1_part_7)
    let u4_from_u3_dot_by_theta3_from_theta1_part_3 = u5_from_u3_dot_by_theta3_from_theta1
        * r1__part_37
        + u3_by_theta3_from_theta1 * u4_from_u3_dot_by_theta2_from_theta1_part_17
        + u3_part_2
            * ((-u3_by_theta3_from_theta1)
                .mul_add(r1__part_41, u5_from_u3_dot_by_theta3_from_theta1 * u3_part_3)
                - u3 * r1__by_theta3_from_theta1_part_7);
    // Elimination, step by step.
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
    let u4_from_u3_dot_by_theta3_from_theta1 = r1__part_75_inv
        * (-u3_by_theta3_from_theta1 * u3_part_3 * (u3_scaled_2 + r1__part_45)
            + u5_from_u3_dot_by_theta3_from_theta1
                * u4_from_u3_dot_by_theta2_from_theta1_part_21
            - cos_theta3_from_theta1
                * (u4_from_u3_dot_by_theta2_from_theta1_part_25
                    + u4_from_u3_dot_by_theta3_from_theta1_part_2)
            - sin_theta3_from_theta1
                * (u4_from_u3_dot_by_theta3_from_theta1_part_3
                    - u4_from_u3_dot_by_theta2_from_theta1_part_24))
        - u4_from_u3_dot_by_theta2_from_theta1_part_26
            * r1__by_theta3_from_theta1_part_12;
    // u3_by_u4_from_u3 = -(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3_by_u4_from_u3 = -u3_part_5 * u3_part_12;
    // Shared terms.
    // u4_from_u3*r1__by_theta2_from_theta1_part_8; used 2 times
    let r1__by_u4_from_u3_part = u4_from_u3 * r1__by_theta2_from_theta1_part_8;
    // 2*u3_by_u4_from_u3; used 4 times
    let u3_by_u4_from_u3_scaled = S::int(2) * u3_by_u4_from_u3;
    // 1 + u3_by_u4_from_u3; used 6 times
    let r1__by_u4_from_u3_part_2 = S::int(1) + u3_by_u4_from_u3;
    // u3_part_8*r1__by_u4_from_u3_part_2; used 2 times
    let r1__by_u4_from_u3_part_3 = u3_part_8 * r1__by_u4_from_u3_part_2;
    // 1 + u3_by_u4_from_u3_scaled + r1__by_u4_from_u3_part_3; used 2 times
    let r1__by_u4_from_u3_part_4 = S::int(1) + u3_by_u4_from_u3_scaled
        + r1__by_u4_from_u3_part_3;
    // 13*u3_by_u4_from_u3; used 2 times
    let u3_by_u4_from_u3_scaled_2 = S::int(13) * u3_by_u4_from_u3;
    // 6*sin(theta3_from_theta1); used 2 times
    let r1__by_u4_from_u3_part_5 = S::int(6) * sin_theta3_from_theta1;
    // u4_from_u3*u3_part; used 3 times
    let u4_from_u3_u3_part = u4_from_u3 * u3_part;
    // 14 + u3_by_u4_from_u3_scaled_2; used 2 times
    let r1__by_u4_from_u3_part_6 = S::int(14) + u3_by_u4_from_u3_scaled_2;
    // Elimination, step by step.
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
    let r1__by_u4_from_u3 = r1__part_78
        * (u3_by_u4_from_u3 * r1__part_17
            - u4_from_u3 * r1__part_74 * u4_from_u3_dot_by_theta2_from_theta1_part_18
            + S::int(6) * cos_theta3_from_theta1
                * (sin_theta2_from_theta1
                    * r1__by_u4_from_u3_part
                        .mul_add(
                            cos_theta3_from_theta1,
                            r1__part_2 * u4_from_u3_scaled_2,
                        )
                    + sin_theta3_from_theta1
                        * (-r1__by_u4_from_u3_part)
                            .mul_add(cos_theta2_from_theta1, u4_from_u3_scaled_2))
            + u3
                * (cos_theta3_from_theta1
                    * (u3_part_3
                        * (u3_by_u4_from_u3.mul_add(r1__part, S::int(18) + u3_part_8)
                            + u3_part_9 * r1__by_u4_from_u3_part_4)
                        + r1__part_9
                            * (u3_by_u4_from_u3.mul_add(S::int(8), S::int(9))
                                - u3_part_2 * r1__by_u4_from_u3_part_4))
                    - u3_part_10
                        * u3_part_2
                            .mul_add(
                                r1__by_u4_from_u3_part_2,
                                S::int(3) + u3_by_u4_from_u3,
                            )
                    - sin_theta3_from_theta1
                        * (S::int(18)
                            + u3_part_2
                                * (u3_by_u4_from_u3 * r1__part_12)
                                    .mul_add(S::int(3), S::int(20) + u3_part_8)
                            + u3_by_u4_from_u3_scaled_2))
            - r1__by_u4_from_u3_part_5
                * (u4_from_u3 * r1__part_13)
                    .mul_add(cos_theta2_from_theta1, u4_from_u3_scaled_2))
        + r1__by_theta2_from_theta1_part_14
            * (u4_from_u3_u3_part
                * sin_theta2_from_theta1
                    .mul_add(S::int(42), u4_from_u3_dot_by_theta2_from_theta1_part_2)
                + u3_by_u4_from_u3 * r1__part_57
                + u3_part_8
                    * (-sin_theta3_from_theta1
                        * u3_part_8.mul_add(u4_from_u3_u3_part, u4_from_u3_scaled_4)
                        + r1__by_theta3_from_theta1_part_10 * u4_from_u3_u3_part)
                + u3_scaled
                    * (cos_theta3_from_theta1
                        * (sin_theta2_from_theta1
                            * (u3_by_u4_from_u3.mul_add(r1__part_50, S::int(14))
                                + u3_part * r1__by_theta2_from_theta1_part_7
                                    * r1__by_u4_from_u3_part_2)
                            + r1__part_9
                                * (-cos_theta2_from_theta1
                                    * (u3_by_u4_from_u3 + r1__by_u4_from_u3_part_3)
                                    + S::int(3) * r1__by_u4_from_u3_part_2))
                        + r1__by_u4_from_u3_part_6 * sin_theta2_from_theta1
                        + sin_theta3_from_theta1
                            * (-cos_theta2_from_theta1
                                * r1__by_theta2_from_theta1_part_7
                                    .mul_add(r1__by_u4_from_u3_part_2, r1__by_u4_from_u3_part_6)
                                + S::int(6) * r1__by_u4_from_u3_part_2)));
    // u5_from_u3_dot_by_u4_from_u3 = r1__by_u4_from_u3*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(4*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot_by_u4_from_u3 = r1__by_u4_from_u3 * u5_from_u3_dot_part_8;
    // Shared terms.
    // r1__part_32 + r1__part_33; used 2 times
    let u4_from_u3_dot_by_u4_from_u3_part = r1__part_32 + r1__part_33;
    // u4_from_u3 + u3_scaled_3; used 3 times
    let u4_from_u3_dot_by_u4_from_u3_part_2 = u4_from_u3 + u3_scaled_3;
    // u5_from_u3 + u4_from_u3_dot_by_u4_from_u3_part_2; used 3 times
    let u4_from_u3_dot_by_u4_from_u3_part_3 = u5_from_u3
        + u4_from_u3_dot_by_u4_from_u3_part_2;
    // u5_from_u3 + 2*u4_from_u3_dot_by_u4_from_u3_part_2; used 2 times
    let u4_from_u3_dot_by_u4_from_u3_part_4 = u4_from_u3_dot_by_u4_from_u3_part_2
        .mul_add(S::int(2), u5_from_u3);
    // u3_part_9*u4_from_u3_dot_by_u4_from_u3_part_3 + u4_from_u3_dot_by_u4_from_u3_part_4; used 2 times
    let u4_from_u3_dot_by_u4_from_u3_part_5 = u3_part_9
        .mul_add(
            u4_from_u3_dot_by_u4_from_u3_part_3,
            u4_from_u3_dot_by_u4_from_u3_part_4,
        );
    // u5_from_u3_dot_by_u4_from_u3*sin(theta3_from_theta1); used 2 times
    let u4_from_u3_dot_by_u4_from_u3_part_6 = u5_from_u3_dot_by_u4_from_u3
        * sin_theta3_from_theta1;
    // r1__part_4 + u3_by_u4_from_u3*u4_from_u3_dot_by_u4_from_u3_part_3; used 2 times
    let u4_from_u3_dot_by_u4_from_u3_part_7 = u3_by_u4_from_u3
        .mul_add(u4_from_u3_dot_by_u4_from_u3_part_3, r1__part_4);
    // r1__part_49 + u3_r1__part_50; used 2 times
    let u4_from_u3_dot_by_u4_from_u3_part_8 = r1__part_49 + u3_r1__part_50;
    // u3_scaled_2 + u4_from_u3_scaled_4; used 2 times
    let u4_from_u3_dot_by_u4_from_u3_part_9 = u3_scaled_2 + u4_from_u3_scaled_4;
    // u5_from_u3_scaled_3 + u3_part_2*u4_from_u3_dot_by_u4_from_u3_part_4 +
    //   u4_from_u3_dot_by_u4_from_u3_part_9; used 2 times
    let u4_from_u3_dot_by_u4_from_u3_part_10 = u3_part_2
        .mul_add(u4_from_u3_dot_by_u4_from_u3_part_4, u5_from_u3_scaled_3)
        + u4_from_u3_dot_by_u4_from_u3_part_9;
    // u5_from_u3_scaled_4 + 9*u4_from_u3_dot_by_u4_from_u3_part_2; used 2 times
    let u4_from_u3_dot_by_u4_from_u3_part_11 = u4_from_u3_dot_by_u4_from_u3_part_2
        .mul_add(S::int(9), u5_from_u3_scaled_4);
    // Elimination, step by step.
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
    let u4_from_u3_dot_by_u4_from_u3 = r1__part_75_inv
        * (cos_theta3_from_theta1
            * (u5_from_u3_dot_by_u4_from_u3 * r1__part_29
                - u4_from_u3_dot_by_theta2_from_theta1_part_2
                    * u4_from_u3_dot_by_u4_from_u3_part_7
                + u3_part_2
                    * (r1__part_9
                        * (u3_by_u4_from_u3 * (u5_from_u3 + u3_scaled_3)
                            + u3_part_8 * u4_from_u3_dot_by_u4_from_u3_part_7)
                        - u5_from_u3_dot_by_u4_from_u3
                            * u4_from_u3_dot_by_u4_from_u3_part
                        - u3_part_10
                            * (u3_by_u4_from_u3
                                .mul_add(
                                    u4_from_u3_dot_by_u4_from_u3_part_5,
                                    u3_part * r1__part_4_scaled,
                                ) + u4_from_u3_dot_by_u4_from_u3_part_6))
                - u3_part_3
                    * (r1__part_4
                        .mul_add(S::int(14), u4_from_u3_dot_by_u4_from_u3_part_6)
                        + u3_by_u4_from_u3_scaled * u4_from_u3_dot_by_u4_from_u3_part_8))
            + u5_from_u3_dot_by_u4_from_u3 * u4_from_u3_dot_by_theta2_from_theta1_part_21
            - u3_part_10
                * (u3_by_u4_from_u3 * (u4_from_u3_dot_by_u4_from_u3_part_9 - r1__part_44)
                    + S::int(7) * r1__part_4)
            - sin_theta3_from_theta1
                * (r1__part_4_scaled_2 + u5_from_u3_dot_by_u4_from_u3 * r1__part_37
                    + u3_part_2
                        * ((-r1__part_4_scaled)
                            .mul_add(
                                u3_by_theta3_from_theta1_part,
                                u5_from_u3_dot_by_u4_from_u3 * u3_part_3,
                            )
                            - u3_by_u4_from_u3_scaled
                                * u4_from_u3_dot_by_u4_from_u3_part_10)
                    + u3_by_u4_from_u3_scaled * u4_from_u3_dot_by_u4_from_u3_part_11));
    // u3_by_u5_from_u3 = -(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3_by_u5_from_u3 = -u3_part_7 * u3_part_12;
    // Shared terms.
    // 1 + u3_by_u5_from_u3; used 7 times
    let r1__by_u5_from_u3_part = S::int(1) + u3_by_u5_from_u3;
    // u3_part_6*r1__by_u5_from_u3_part; used 3 times
    let r1__by_u5_from_u3_part_2 = u3_part_6 * r1__by_u5_from_u3_part;
    // 13*u3_by_u5_from_u3; used 4 times
    let u3_by_u5_from_u3_scaled = S::int(13) * u3_by_u5_from_u3;
    // u5_from_u3*u3_part_6; used 3 times
    let u5_from_u3_u3_part_6 = u5_from_u3 * u3_part_6;
    // 2*u3_by_u5_from_u3; used 4 times
    let u3_by_u5_from_u3_scaled_2 = S::int(2) * u3_by_u5_from_u3;
    // 1 + u3_by_u5_from_u3_scaled_2; used 3 times
    let r1__by_u5_from_u3_part_3 = S::int(1) + u3_by_u5_from_u3_scaled_2;
    // u5_from_u3*r1__part_31; used 2 times
    let r1__by_u5_from_u3_part_4 = u5_from_u3 * r1__part_31;
    // Elimination, step by step.
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
    let r1__by_u5_from_u3 = r1__part_78
        * (u3
            * (cos_theta3_from_theta1
                * (u3_part_3
                    * (u3_by_u5_from_u3.mul_add(r1__part, S::int(6))
                        + r1__by_theta2_from_theta1_part_2 * r1__by_u5_from_u3_part_2)
                    + r1__by_theta3_from_theta1_part_2
                        * (-u3_part_2)
                            .mul_add(
                                r1__by_u5_from_u3_part_2,
                                S::int(4) * r1__by_u5_from_u3_part,
                            )) - u3_part_10 * r1__by_u5_from_u3_part_2
                - sin_theta3_from_theta1
                    * (S::int(6)
                        + u5_from_u3_dot_part_3
                            * u3_by_u5_from_u3.mul_add(r1__part_12, S::int(2))
                        + u3_by_u5_from_u3_scaled)) + u3_by_u5_from_u3 * r1__part_17
            - u5_from_u3_u3_part_6 * (u3_part_10 + r1__by_u4_from_u3_part_5)
            + u3_part_9
                * (u3_part_3
                    * u3_part_9.mul_add(u5_from_u3_u3_part_6, u5_from_u3_scaled_2)
                    + r1__part_9
                        * (-u3_part_2)
                            .mul_add(u5_from_u3_u3_part_6, S::int(4) * u5_from_u3)))
        + r1__by_theta2_from_theta1_part_14
            * (u3_part_10 * r1__part_48.mul_add(cos_theta3_from_theta1, u5_from_u3)
                + u3_by_u5_from_u3 * r1__part_57
                + r1__part_9 * u5_from_u3.mul_add(r1__part_28, u5_from_u3_scaled_4)
                + u3
                    * (u3_part_3 * (S::int(2) - u3_part_8 + u3_by_u5_from_u3_scaled)
                        + sin_theta3_from_theta1
                            * (S::int(14) + S::int(18) * u3_by_u5_from_u3
                                - u3_part_2
                                    * u3_part_8
                                        .mul_add(
                                            r1__by_u5_from_u3_part_3,
                                            S::int(10) + u3_by_u5_from_u3_scaled,
                                        ))
                        + r1__part_56
                            * (r1__part_9
                                * (-(r1__by_theta2_from_theta1_part_8
                                    * r1__by_u5_from_u3_part))
                                    .mul_add(
                                        cos_theta2_from_theta1,
                                        S::int(3) * r1__by_u5_from_u3_part,
                                    )
                                + sin_theta2_from_theta1
                                    * (S::int(12) + u3_part_9 + u3_by_u5_from_u3 * r1__part_50
                                        + u3_part_8
                                            * u3_part_9
                                                .mul_add(
                                                    r1__by_u5_from_u3_part,
                                                    r1__by_u5_from_u3_part_3,
                                                ))))
                - u3_part_8
                    * (sin_theta3_from_theta1
                        * u3_part_2
                            .mul_add(r1__by_u5_from_u3_part_4, u5_from_u3 * r1__part_63)
                        + u3_part_3
                            * (-r1__by_u5_from_u3_part_4)
                                .mul_add(cos_theta3_from_theta1, u5_from_u3)));
    // u5_from_u3_dot_by_u5_from_u3 = r1__by_u5_from_u3*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(4*m_l_squared_by_12*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot_by_u5_from_u3 = r1__by_u5_from_u3 * u5_from_u3_dot_part_8;
    // Shared terms.
    // u5_from_u3_dot_by_u5_from_u3*sin(theta3_from_theta1); used 2 times
    let u4_from_u3_dot_by_u5_from_u3_part = u5_from_u3_dot_by_u5_from_u3
        * sin_theta3_from_theta1;
    // r1__part_3 + u3_by_u5_from_u3*u4_from_u3_dot_by_u4_from_u3_part_3; used 2 times
    let u4_from_u3_dot_by_u5_from_u3_part_2 = u3_by_u5_from_u3
        .mul_add(u4_from_u3_dot_by_u4_from_u3_part_3, r1__part_3);
    // Elimination, step by step.
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
    let u4_from_u3_dot_by_u5_from_u3 = r1__part_75_inv
        * (-u3_part_10
            * (u3_by_u5_from_u3 * u4_from_u3_scaled_4
                + u5_from_u3 * r1__part_43 * r1__by_u5_from_u3_part
                + u3 * (r1__part_43 + u3_by_u5_from_u3_scaled))
            + u5_from_u3_dot_by_u5_from_u3 * u4_from_u3_dot_by_theta2_from_theta1_part_21
            - sin_theta3_from_theta1
                * (S::int(14) * r1__part_3 + u5_from_u3_dot_by_u5_from_u3 * r1__part_37
                    + u4_from_u3_dot_by_u4_from_u3_part_11 * u3_by_u5_from_u3_scaled_2
                    + u3_part_2
                        * (-r1__part_3_scaled * (S::int(5) + u3_part_2)
                            + u5_from_u3_dot_by_u5_from_u3 * u3_part_3
                            - u4_from_u3_dot_by_u4_from_u3_part_10
                                * u3_by_u5_from_u3_scaled_2))
            + cos_theta3_from_theta1
                * (-u3_part_3
                    * (u4_from_u3_dot_by_u4_from_u3_part_8
                        .mul_add(
                            u3_by_u5_from_u3_scaled_2,
                            r1__part_3_scaled * r1__part_47,
                        ) + u4_from_u3_dot_by_u5_from_u3_part)
                    + u5_from_u3_dot_by_u5_from_u3 * r1__part_29
                    - u4_from_u3_dot_by_theta2_from_theta1_part_2
                        * u4_from_u3_dot_by_u5_from_u3_part_2
                    + u3_part_2
                        * (r1__part_9
                            * (u3
                                .mul_add(
                                    r1__by_u5_from_u3_part_3,
                                    u5_from_u3 * r1__by_u5_from_u3_part,
                                ) + u3_part_8 * u4_from_u3_dot_by_u5_from_u3_part_2)
                            - u5_from_u3_dot_by_u5_from_u3
                                * u4_from_u3_dot_by_u4_from_u3_part
                            - u3_part_10
                                * (u3_by_u5_from_u3
                                    .mul_add(
                                        u4_from_u3_dot_by_u4_from_u3_part_5,
                                        r1__part_3 * r1__part_31,
                                    ) + u4_from_u3_dot_by_u5_from_u3_part))));
    // Entries that are not zero.
    // d(theta2_from_theta1')/d(u4_from_u3) = 1
    let theta2_from_theta1_dot_by_u4_from_u3_value = S::int(1);
    // d(theta3_from_theta1')/d(u5_from_u3) = 1
    let theta3_from_theta1_dot_by_u5_from_u3_value = S::int(1);
    [
        [zero, zero, zero, theta2_from_theta1_dot_by_u4_from_u3_value, zero],
        [zero, zero, zero, zero, theta3_from_theta1_dot_by_u5_from_u3_value],
        [
            u3_by_theta2_from_theta1,
            u3_by_theta3_from_theta1,
            zero,
            u3_by_u4_from_u3,
            u3_by_u5_from_u3,
        ],
        [
            u4_from_u3_dot_by_theta2_from_theta1,
            u4_from_u3_dot_by_theta3_from_theta1,
            zero,
            u4_from_u3_dot_by_u4_from_u3,
            u4_from_u3_dot_by_u5_from_u3,
        ],
        [
            u5_from_u3_dot_by_theta2_from_theta1,
            u5_from_u3_dot_by_theta3_from_theta1,
            zero,
            u5_from_u3_dot_by_u4_from_u3,
            u5_from_u3_dot_by_u5_from_u3,
        ],
    ]
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
    // Shared terms.
    // sin(theta2_from_theta1)*sin(theta3_from_theta1); used 2 times
    let u3_part = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) + u3_part; used 2 times
    let u3_part_2 = cos_theta2_from_theta1 * (S::int(1) + cos_theta3_from_theta1)
        + u3_part;
    // Elimination, step by step.
    // u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3 = (H_n3_scaled_per_m_per_l_squared
        - u5_from_u3
            * (S::int(3)
                + cos_theta3_from_theta1
                    * cos_theta2_from_theta1.mul_add(S::int(3), S::int(1))
                + S::int(3) * u3_part)
        - u4_from_u3 * u3_part_2.mul_add(S::int(3), S::int(7)))
        / (cos_theta3_from_theta1.mul_add(S::int(2), S::int(13))
            + S::int(6) * u3_part_2);
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
    // Shared terms.
    // sin(theta2_from_theta1)*sin(theta3_from_theta1); used 3 times
    let u3_part = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) + u3_part; used 2 times
    let u3_part_2 = cos_theta2_from_theta1 * (S::int(1) + cos_theta3_from_theta1)
        + u3_part;
    // u5_from_u3*(3 + cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1)) + 3*u3_part) + u4_from_u3*(7
    //   + 3*u3_part_2); used 2 times
    let u3_part_3 = u5_from_u3
        * (S::int(3)
            + cos_theta3_from_theta1
                * cos_theta2_from_theta1.mul_add(S::int(3), S::int(1))
            + S::int(3) * u3_part)
        + u4_from_u3 * u3_part_2.mul_add(S::int(3), S::int(7));
    // 13 + 2*cos(theta3_from_theta1) + 6*u3_part_2; used 2 times
    let u3_part_4 = cos_theta3_from_theta1.mul_add(S::int(2), S::int(13))
        + S::int(6) * u3_part_2;
    // 1/u3_part_4; used 2 times
    let u3_part_4_inv = S::int(1) / u3_part_4;
    // Elimination, step by step.
    // u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3 = u3_part_4_inv * (H_n3_scaled_per_m_per_l_squared - u3_part_3);
    // Shared terms.
    // H_n3_scaled/l
    let l_inv_h_n3_scaled = H_n3_scaled / l;
    // u3_part_4_inv*l_inv_h_n3_scaled^2/m - m*l^2*(3*u5_from_u3^2 + u4_from_u3*(7*u4_from_u3 +
    //   6*u5_from_u3*(cos(theta2_from_theta1)*cos(theta3_from_theta1) + u3_part)) + u3*(2*u3_part_3 +
    //   u3*u3_part_4))
    let energy_part = u3_part_4_inv * l_inv_h_n3_scaled * l_inv_h_n3_scaled / m
        - m * l * l
            * (S::int(3) * u5_from_u3 * u5_from_u3
                + u4_from_u3
                    * (S::int(6) * u5_from_u3
                        * cos_theta2_from_theta1.mul_add(cos_theta3_from_theta1, u3_part)
                        + S::int(7) * u4_from_u3)
                + u3 * u3.mul_add(u3_part_4, S::int(2) * u3_part_3));
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
    let energy = -S::ratio(1, 24) * energy_part;
    energy
}

/// Potential energy V of gravity, with the kinetic energy of what the momenta determine.
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
                    * (S::int(13)
                        + S::int(6) * sin_theta2_from_theta1 * sin_theta3_from_theta1
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
        m,
        l,
        p_x,
        p_y,
        centre_x,
        centre_y,
        H_n3_scaled_per_m_per_l_squared,
        l_by_6,
        p_y_per_m_by_3,
        p_x_per_m_by_3,
        ..
    } = *p;
    let [theta2_from_theta1, theta3_from_theta1, theta1] = *q;
    let [u4_from_u3, u5_from_u3] = *u;
    // Sines and cosines.
    let (sin_theta2_from_theta1, cos_theta2_from_theta1) = theta2_from_theta1.sin_cos();
    let (sin_theta3_from_theta1, cos_theta3_from_theta1) = theta3_from_theta1.sin_cos();
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    // Shared terms.
    // sin(theta2_from_theta1)*sin(theta3_from_theta1); used 2 times
    let u3_part = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) + u3_part; used 2 times
    let u3_part_2 = cos_theta2_from_theta1 * (S::int(1) + cos_theta3_from_theta1)
        + u3_part;
    // Elimination, step by step.
    // u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3 = (H_n3_scaled_per_m_per_l_squared
        - u5_from_u3
            * (S::int(3)
                + cos_theta3_from_theta1
                    * cos_theta2_from_theta1.mul_add(S::int(3), S::int(1))
                + S::int(3) * u3_part)
        - u4_from_u3 * u3_part_2.mul_add(S::int(3), S::int(7)))
        / (cos_theta3_from_theta1.mul_add(S::int(2), S::int(13))
            + S::int(6) * u3_part_2);
    // Shared terms.
    // cos(theta1)*cos(theta3_from_theta1) - sin(theta1)*sin(theta3_from_theta1); used 2 times
    let u2_part = (-sin_theta1)
        .mul_add(sin_theta3_from_theta1, cos_theta1 * cos_theta3_from_theta1);
    // cos(theta1)*cos(theta2_from_theta1) - sin(theta1)*sin(theta2_from_theta1)
    let u2_part_2 = (-sin_theta1)
        .mul_add(sin_theta2_from_theta1, cos_theta1 * cos_theta2_from_theta1);
    // 3*cos(theta1 + theta2_from_theta1); used 2 times
    let u2_part_2_scaled = S::int(3) * u2_part_2;
    // 2*cos(theta1) + cos(theta1 + theta3_from_theta1) + u2_part_2_scaled; used 2 times
    let u2_part_3 = cos_theta1.mul_add(S::int(2), u2_part) + u2_part_2_scaled;
    // Elimination, step by step.
    // u2 = p_y_per_m_by_3 - l_by_6*(u3*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1)) + 3*u4_from_u3*cos(theta1 + theta2_from_theta1) + u5_from_u3*cos(theta1 +
    //   theta3_from_theta1))
    let u2 = p_y_per_m_by_3
        - l_by_6
            * (u4_from_u3.mul_add(u2_part_2_scaled, u5_from_u3 * u2_part)
                + u3 * u2_part_3);
    // Shared terms.
    // cos(theta1)*sin(theta3_from_theta1) + sin(theta1)*cos(theta3_from_theta1); used 2 times
    let u1_part = sin_theta1
        .mul_add(cos_theta3_from_theta1, cos_theta1 * sin_theta3_from_theta1);
    // cos(theta1)*sin(theta2_from_theta1) + sin(theta1)*cos(theta2_from_theta1)
    let u1_part_2 = sin_theta1
        .mul_add(cos_theta2_from_theta1, cos_theta1 * sin_theta2_from_theta1);
    // 3*sin(theta1 + theta2_from_theta1); used 2 times
    let u1_part_2_scaled = S::int(3) * u1_part_2;
    // 2*sin(theta1) + sin(theta1 + theta3_from_theta1) + u1_part_2_scaled; used 2 times
    let u1_part_3 = sin_theta1.mul_add(S::int(2), u1_part) + u1_part_2_scaled;
    // Elimination, step by step.
    // u1 = l_by_6*(u3*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1)) + 3*u4_from_u3*sin(theta1 + theta2_from_theta1) + u5_from_u3*sin(theta1 +
    //   theta3_from_theta1)) + p_x_per_m_by_3
    let u1 = p_x_per_m_by_3
        + l_by_6
            * (u4_from_u3.mul_add(u1_part_2_scaled, u5_from_u3 * u1_part)
                + u3 * u1_part_3);
    // Shared terms.
    // 1/(3*m); used 2 times
    let m_inv_scaled = S::ratio(1, 3) / m;
    // l/6; used 2 times
    let l_scaled = S::ratio(1, 6) * l;
    // Values.
    // x = (p_x*t + centre_x)/(3*m) - l*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/6
    let x_value = m_inv_scaled * p_x.mul_add(t, centre_x) - u2_part_3 * l_scaled;
    // y = (p_y*t + centre_y)/(3*m) - l*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/6
    let y_value = m_inv_scaled * p_y.mul_add(t, centre_y) - u1_part_3 * l_scaled;
    // theta1 = theta1
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
        x_value,
        y_value,
        theta1_value,
        theta2_value,
        theta3_value,
        u1,
        u2,
        u3,
        u4_value,
        u5_value,
    ]
}

/// The energy, then its derivatives by the state.
///
/// 118 operations, 2 sines and cosines.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [S; 6] {
    let Parameters {
        m,
        l,
        p_x,
        p_y,
        H_n3_scaled,
        H_n3_scaled_per_m_per_l_squared,
        ..
    } = *p;
    let [theta2_from_theta1, theta3_from_theta1, _] = *q;
    let [u4_from_u3, u5_from_u3] = *u;
    let zero = S::int(0);
    // Sines and cosines.
    let (sin_theta3_from_theta1, cos_theta3_from_theta1) = theta3_from_theta1.sin_cos();
    let (sin_theta2_from_theta1, cos_theta2_from_theta1) = theta2_from_theta1.sin_cos();
    // Shared terms.
    // 1 + cos(theta3_from_theta1); used 2 times
    let u3_part = S::int(1) + cos_theta3_from_theta1;
    // sin(theta2_from_theta1)*sin(theta3_from_theta1); used 3 times
    let u3_part_2 = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // u3_part*cos(theta2_from_theta1) + u3_part_2; used 2 times
    let u3_part_3 = u3_part.mul_add(cos_theta2_from_theta1, u3_part_2);
    // 7 + 3*u3_part_3; used 2 times
    let u3_part_4 = u3_part_3.mul_add(S::int(3), S::int(7));
    // 1 + 3*cos(theta2_from_theta1); used 2 times
    let u3_part_5 = cos_theta2_from_theta1.mul_add(S::int(3), S::int(1));
    // 3 + 3*u3_part_2 + u3_part_5*cos(theta3_from_theta1); used 2 times
    let u3_part_6 = u3_part_2.mul_add(S::int(3), S::int(3))
        + u3_part_5 * cos_theta3_from_theta1;
    // u4_from_u3*u3_part_4 + u5_from_u3*u3_part_6; used 2 times
    let u3_part_7 = u5_from_u3.mul_add(u3_part_6, u4_from_u3 * u3_part_4);
    // 13 + 2*cos(theta3_from_theta1) + 6*u3_part_3; used 4 times
    let u3_part_8 = cos_theta3_from_theta1.mul_add(S::int(2), S::int(13))
        + S::int(6) * u3_part_3;
    // 1/u3_part_8; used 6 times
    let u3_part_8_inv = S::int(1) / u3_part_8;
    // u3_part_8_inv*(u3_part_7 - H_n3_scaled_per_m_per_l_squared); used 2 times
    let u3_part_9 = u3_part_8_inv * (u3_part_7 - H_n3_scaled_per_m_per_l_squared);
    // Elimination, step by step.
    // u3 = (H_n3_scaled_per_m_per_l_squared - u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) - u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3 = -u3_part_9;
    // Shared terms.
    // 2*u3_part_7 + u3*u3_part_8; used 4 times
    let energy_part = u3.mul_add(u3_part_8, S::int(2) * u3_part_7);
    // cos(theta2_from_theta1)*cos(theta3_from_theta1) + u3_part_2; used 2 times
    let energy_part_2 = cos_theta2_from_theta1
        .mul_add(cos_theta3_from_theta1, u3_part_2);
    // 6*u5_from_u3; used 3 times
    let u5_from_u3_scaled = S::int(6) * u5_from_u3;
    // energy_part_2*u5_from_u3_scaled; used 2 times
    let energy_part_3 = energy_part_2 * u5_from_u3_scaled;
    // m*l^2; used 2 times
    let m_l_sq = m * l * l;
    // m_l_sq/24; used 4 times
    let m_l_sq_scaled = S::ratio(1, 24) * m_l_sq;
    // H_n3_scaled/l
    let l_inv_h_n3_scaled = H_n3_scaled / l;
    // u3_part_8_inv*l_inv_h_n3_scaled^2; used 2 times
    let energy_part_4 = u3_part_8_inv * l_inv_h_n3_scaled * l_inv_h_n3_scaled;
    // p_x^2 + p_y^2
    let p_x_2_plus_p_y_2 = p_y.mul_add(p_y, p_x * p_x);
    // energy_part_4 + 4*p_x_2_plus_p_y_2
    let energy_part_5 = p_x_2_plus_p_y_2.mul_add(S::int(4), energy_part_4);
    // cos(theta2_from_theta1)*sin(theta3_from_theta1); used 2 times
    let energy_by_theta2_from_theta1_part = cos_theta2_from_theta1
        * sin_theta3_from_theta1;
    // sin(theta2_from_theta1)*cos(theta3_from_theta1); used 2 times
    let energy_by_theta2_from_theta1_part_2 = sin_theta2_from_theta1
        * cos_theta3_from_theta1;
    // energy_by_theta2_from_theta1_part_2 - energy_by_theta2_from_theta1_part; used 2 times
    let energy_by_theta2_from_theta1_part_3 = energy_by_theta2_from_theta1_part_2
        - energy_by_theta2_from_theta1_part;
    // -energy_by_theta2_from_theta1_part_3; used 2 times
    let energy_by_theta2_from_theta1_part_4 = -energy_by_theta2_from_theta1_part_3;
    // energy_by_theta2_from_theta1_part - u3_part*sin(theta2_from_theta1); used 3 times
    let energy_by_theta2_from_theta1_part_5 = (-u3_part)
        .mul_add(sin_theta2_from_theta1, energy_by_theta2_from_theta1_part);
    // u5_from_u3*energy_by_theta2_from_theta1_part_4 + u4_from_u3*energy_by_theta2_from_theta1_part_5;
    //   used 2 times
    let energy_by_theta2_from_theta1_part_6 = u4_from_u3
        .mul_add(
            energy_by_theta2_from_theta1_part_5,
            u5_from_u3 * energy_by_theta2_from_theta1_part_4,
        );
    // 2*u3_part_8_inv*u3_part_9; used 2 times
    let energy_by_theta2_from_theta1_part_7 = S::int(2) * u3_part_8_inv * u3_part_9;
    // u3_part_8_inv*energy_by_theta2_from_theta1_part_6 -
    //   energy_by_theta2_from_theta1_part_5*energy_by_theta2_from_theta1_part_7; used 2 times
    let energy_by_theta2_from_theta1_part_8 = (-energy_by_theta2_from_theta1_part_5)
        .mul_add(
            energy_by_theta2_from_theta1_part_7,
            u3_part_8_inv * energy_by_theta2_from_theta1_part_6,
        );
    // 2*u3; used 2 times
    let u3_scaled = S::int(2) * u3;
    // u4_from_u3*energy_by_theta2_from_theta1_part_4; used 3 times
    let energy_by_theta2_from_theta1_part_9 = u4_from_u3
        * energy_by_theta2_from_theta1_part_4;
    // u5_from_u3*(u3_part_5*sin(theta3_from_theta1) - 3*energy_by_theta2_from_theta1_part_2) +
    //   3*energy_by_theta2_from_theta1_part_9; used 2 times
    let energy_by_theta3_from_theta1_part = u5_from_u3
        * (-energy_by_theta2_from_theta1_part_2)
            .mul_add(S::int(3), u3_part_5 * sin_theta3_from_theta1)
        + S::int(3) * energy_by_theta2_from_theta1_part_9;
    // sin(theta3_from_theta1) - 3*energy_by_theta2_from_theta1_part_3; used 2 times
    let energy_by_theta3_from_theta1_part_2 = (-energy_by_theta2_from_theta1_part_3)
        .mul_add(S::int(3), sin_theta3_from_theta1);
    // u3_part_8_inv*energy_by_theta3_from_theta1_part -
    //   energy_by_theta2_from_theta1_part_7*energy_by_theta3_from_theta1_part_2; used 2 times
    let energy_by_theta3_from_theta1_part_3 = (-energy_by_theta2_from_theta1_part_7)
        .mul_add(
            energy_by_theta3_from_theta1_part_2,
            u3_part_8_inv * energy_by_theta3_from_theta1_part,
        );
    // u3_part_8_inv*energy_part - u3; used 2 times
    let energy_by_u4_from_u3_part = u3_part_8_inv.mul_add(energy_part, -u3);
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
    let energy = m_l_sq_scaled
        * (S::int(3) * u5_from_u3 * u5_from_u3 + u3 * energy_part
            + u4_from_u3 * u4_from_u3.mul_add(S::int(7), energy_part_3))
        + S::ratio(1, 24) * (energy_part_5 - energy_part_4) / m;
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
        * (S::int(2) * u5_from_u3 * energy_by_theta2_from_theta1_part_9
            - energy_part * energy_by_theta2_from_theta1_part_8
            - u3
                * ((-energy_by_theta2_from_theta1_part_6)
                    .mul_add(S::int(2), u3_part_8 * energy_by_theta2_from_theta1_part_8)
                    - energy_by_theta2_from_theta1_part_5 * u3_scaled));
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
    let energy_by_theta3_from_theta1 = m_l_sq_scaled
        * (energy_part * energy_by_theta3_from_theta1_part_3
            - u5_from_u3_scaled * energy_by_theta2_from_theta1_part_9
            + u3
                * ((-energy_by_theta3_from_theta1_part)
                    .mul_add(S::int(2), u3_part_8 * energy_by_theta3_from_theta1_part_3)
                    - u3_scaled * energy_by_theta3_from_theta1_part_2));
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
    let energy_by_u4_from_u3 = m_l_sq_scaled
        * (u4_from_u3.mul_add(S::int(14), energy_part_3)
            - u3_part_4 * energy_by_u4_from_u3_part);
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
    let energy_by_u5_from_u3 = m_l_sq_scaled
        * ((u4_from_u3 * energy_part_2).mul_add(S::int(6), u5_from_u3_scaled)
            - u3_part_6 * energy_by_u4_from_u3_part);
    [
        energy,
        energy_by_theta2_from_theta1,
        energy_by_theta3_from_theta1,
        zero,
        energy_by_u4_from_u3,
        energy_by_u5_from_u3,
    ]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 105 convolutions and 422 linear operations an order.
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 5]],
    history: &mut [Factors<S, 112>],
) {
    let Parameters { H_n3_scaled_per_m_per_l_squared, m_l_squared_by_12, .. } = *p;
    let [theta2_from_theta1_0, theta3_from_theta1_0, _, u4_from_u3_0, u5_from_u3_0] = series[0];
    // Shared terms.
    // 1/m_l_squared_by_12; used 5 times
    let weight_2_part = S::int(1) / m_l_squared_by_12;
    // Constant in time.
    // weight = -H_n3_scaled_per_m_per_l_squared
    let weight = -H_n3_scaled_per_m_per_l_squared;
    // weight_2 = -3/(4*m_l_squared_by_12)
    let weight_2 = -S::ratio(3, 4) * weight_2_part;
    // weight_3 = 9/(4*m_l_squared_by_12)
    let weight_3 = S::ratio(9, 4) * weight_2_part;
    // weight_4 = 1/(2*m_l_squared_by_12)
    let weight_4 = S::ratio(1, 2) * weight_2_part;
    // weight_5 = 1/(4*m_l_squared_by_12)
    let weight_5 = S::ratio(1, 4) * weight_2_part;
    // weight_6 = -1/(4*m_l_squared_by_12)
    let weight_6 = -S::ratio(1, 4) * weight_2_part;
    // Order 0.
    let (sin_theta2_from_theta1_0, cos_theta2_from_theta1_0) = theta2_from_theta1_0
        .sin_cos();
    let (sin_theta3_from_theta1_0, cos_theta3_from_theta1_0) = theta3_from_theta1_0
        .sin_cos();
    // u3_part = 1 + cos_theta3_from_theta1
    let u3_part_0 = S::int(1) + cos_theta3_from_theta1_0;
    // u3_part_2 = cos_theta2_from_theta1*u3_part
    let u3_part_2_0 = cos_theta2_from_theta1_0 * u3_part_0;
    // u3_part_3 = sin_theta2_from_theta1*sin_theta3_from_theta1
    let u3_part_3_0 = sin_theta2_from_theta1_0 * sin_theta3_from_theta1_0;
    // u3_part_4 = 7 + 3*u3_part_2 + 3*u3_part_3
    let u3_part_4_0 = u3_part_2_0
        .mul_add(S::int(3), u3_part_3_0.mul_add(S::int(3), S::int(7)));
    // u3_part_5 = 1 + 3*cos_theta2_from_theta1
    let u3_part_5_0 = cos_theta2_from_theta1_0.mul_add(S::int(3), S::int(1));
    // u3_part_6 = cos_theta3_from_theta1*u3_part_5
    let u3_part_6_0 = cos_theta3_from_theta1_0 * u3_part_5_0;
    // u3_part_7 = 3 + 3*u3_part_3 + u3_part_6
    let u3_part_7_0 = u3_part_3_0.mul_add(S::int(3), S::int(3)) + u3_part_6_0;
    // u3_part_8 = 13 + 2*cos_theta3_from_theta1 + 6*u3_part_2 + 6*u3_part_3
    let u3_part_8_0 = u3_part_2_0
        .mul_add(
            S::int(6),
            u3_part_3_0
                .mul_add(
                    S::int(6),
                    cos_theta3_from_theta1_0.mul_add(S::int(2), S::int(13)),
                ),
        );
    let over_u3_part_8 = S::int(1) / u3_part_8_0;
    // u3_part_9 = u3_part_4*u4_from_u3
    let u3_part_9_0 = u3_part_4_0 * u4_from_u3_0;
    // u3_part_10 = u3_part_7*u5_from_u3
    let u3_part_10_0 = u3_part_7_0 * u5_from_u3_0;
    // u3_part_11 = weight + u3_part_9 + u3_part_10
    let u3_part_11_0 = weight + u3_part_9_0 + u3_part_10_0;
    // u3_part_12 = u3_part_11/u3_part_8
    let u3_part_12_0 = u3_part_11_0 * over_u3_part_8;
    // u4_from_u3_p2 = u4_from_u3*u4_from_u3
    let u4_from_u3_p2_0 = u4_from_u3_0 * u4_from_u3_0;
    // u5_from_u3_p2 = u5_from_u3*u5_from_u3
    let u5_from_u3_p2_0 = u5_from_u3_0 * u5_from_u3_0;
    // r1__part = 5 + 2*cos_theta2_from_theta1
    let r1__part_0 = cos_theta2_from_theta1_0.mul_add(S::int(2), S::int(5));
    // r1__part_2 = u3_part_12*r1__part
    let r1__part_2_0 = u3_part_12_0 * r1__part_0;
    // r1__part_3 = u4_from_u3_p2 + u5_from_u3_p2
    let r1__part_3_0 = u4_from_u3_p2_0 + u5_from_u3_p2_0;
    // r1__part_4 = -u3_part_12 + u4_from_u3 + u5_from_u3
    let r1__part_4_0 = u4_from_u3_0 + u5_from_u3_0 - u3_part_12_0;
    // r1__part_5 = cos_theta3_from_theta1*r1__part_4
    let r1__part_5_0 = cos_theta3_from_theta1_0 * r1__part_4_0;
    // r1__part_6 = cos_theta3_from_theta1*r1__part_3
    let r1__part_6_0 = cos_theta3_from_theta1_0 * r1__part_3_0;
    // r1__part_7 = u3_part_2 + u3_part_3
    let r1__part_7_0 = u3_part_3_0 + u3_part_2_0;
    // r1__part_8 = cos_theta2_from_theta1*r1__part_7
    let r1__part_8_0 = cos_theta2_from_theta1_0 * r1__part_7_0;
    // r1__part_9 = 14 + 9*cos_theta3_from_theta1 - 18*r1__part_8
    let r1__part_9_0 = r1__part_8_0
        .mul_add(-S::int(18), cos_theta3_from_theta1_0.mul_add(S::int(9), S::int(14)));
    // r1__part_10 = cos_theta3_from_theta1*r1__part_9
    let r1__part_10_0 = cos_theta3_from_theta1_0 * r1__part_9_0;
    // r1__part_11 = cos_theta2_from_theta1*u3_part_3
    let r1__part_11_0 = cos_theta2_from_theta1_0 * u3_part_3_0;
    // r1__part_12 = 33 + r1__part_10 - 18*r1__part_11
    let r1__part_12_0 = r1__part_11_0.mul_add(-S::int(18), S::int(33)) + r1__part_10_0;
    let over_r1__part_12 = S::int(1) / r1__part_12_0;
    // r1__part_13 = 1 + 2*cos_theta3_from_theta1
    let r1__part_13_0 = cos_theta3_from_theta1_0.mul_add(S::int(2), S::int(1));
    // r1__part_14 = cos_theta2_from_theta1*r1__part_13
    let r1__part_14_0 = cos_theta2_from_theta1_0 * r1__part_13_0;
    // r1__part_15 = 2 + cos_theta3_from_theta1 + 6*u3_part_3 + 3*r1__part_14
    let r1__part_15_0 = r1__part_14_0
        .mul_add(
            S::int(3),
            u3_part_3_0.mul_add(S::int(6), S::int(2) + cos_theta3_from_theta1_0),
        );
    // r1__part_16 = cos_theta3_from_theta1*r1__part_15
    let r1__part_16_0 = cos_theta3_from_theta1_0 * r1__part_15_0;
    // r1__part_17 = 3 + 3*cos_theta2_from_theta1 - 3*u3_part_3 - r1__part_16
    let r1__part_17_0 = u3_part_3_0
        .mul_add(-S::int(3), cos_theta2_from_theta1_0.mul_add(S::int(3), S::int(3)))
        - r1__part_16_0;
    // r1__part_18 = cos_theta2_from_theta1*r1__part_17
    let r1__part_18_0 = cos_theta2_from_theta1_0 * r1__part_17_0;
    // r1__part_19 = 7 + 9*cos_theta3_from_theta1 - 3*u3_part_3
    let r1__part_19_0 = u3_part_3_0
        .mul_add(-S::int(3), cos_theta3_from_theta1_0.mul_add(S::int(9), S::int(7)));
    // r1__part_20 = cos_theta3_from_theta1*r1__part_19
    let r1__part_20_0 = cos_theta3_from_theta1_0 * r1__part_19_0;
    // r1__part_21 = -12 + 9*u3_part_3 - 3*r1__part_18 - r1__part_20
    let r1__part_21_0 = r1__part_18_0
        .mul_add(
            -S::int(3),
            u3_part_3_0.mul_add(S::int(9), -S::int(12)) - r1__part_20_0,
        );
    // r1__part_22 = -2*u3_part_12 + 2*u4_from_u3 + u5_from_u3
    let r1__part_22_0 = u3_part_12_0
        .mul_add(-S::int(2), S::int(2) * u4_from_u3_0 + u5_from_u3_0);
    // r1__part_23 = -2*u3_part_12 + 2*u4_from_u3 + u5_from_u3 + 2*r1__part_5
    let r1__part_23_0 = r1__part_5_0
        .mul_add(
            S::int(2),
            u3_part_12_0.mul_add(-S::int(2), S::int(2) * u4_from_u3_0 + u5_from_u3_0),
        );
    // r1__part_24 = cos_theta2_from_theta1*r1__part_23
    let r1__part_24_0 = cos_theta2_from_theta1_0 * r1__part_23_0;
    // r1__part_25 = 15 + 2*cos_theta3_from_theta1
    let r1__part_25_0 = cos_theta3_from_theta1_0.mul_add(S::int(2), S::int(15));
    // r1__part_26 = u3_part_12*r1__part_25
    let r1__part_26_0 = u3_part_12_0 * r1__part_25_0;
    // r1__part_27 = 6 + cos_theta3_from_theta1
    let r1__part_27_0 = S::int(6) + cos_theta3_from_theta1_0;
    // r1__part_28 = u5_from_u3*r1__part_27
    let r1__part_28_0 = u5_from_u3_0 * r1__part_27_0;
    // r1__part_29 = 14*u4_from_u3 + 6*r1__part_24 - r1__part_26 + 2*r1__part_28
    let r1__part_29_0 = r1__part_24_0
        .mul_add(
            S::int(6),
            r1__part_28_0.mul_add(S::int(2), S::int(14) * u4_from_u3_0) - r1__part_26_0,
        );
    // r1__part_30 = sin_theta2_from_theta1*r1__part_29
    let r1__part_30_0 = sin_theta2_from_theta1_0 * r1__part_29_0;
    // r1__part_31 = cos_theta2_from_theta1*r1__part_4
    let r1__part_31_0 = cos_theta2_from_theta1_0 * r1__part_4_0;
    // r1__part_32 = -u3_part_12 + u5_from_u3 + 6*r1__part_31
    let r1__part_32_0 = r1__part_31_0.mul_add(S::int(6), u5_from_u3_0 - u3_part_12_0);
    // r1__part_33 = cos_theta2_from_theta1*r1__part_32
    let r1__part_33_0 = cos_theta2_from_theta1_0 * r1__part_32_0;
    // r1__part_34 = -3*u3_part_12 + 3*u4_from_u3 + 3*u5_from_u3 - r1__part_33
    let r1__part_34_0 = u3_part_12_0
        .mul_add(-S::int(3), u5_from_u3_0.mul_add(S::int(3), S::int(3) * u4_from_u3_0))
        - r1__part_33_0;
    // r1__part_35 = sin_theta3_from_theta1*r1__part_34
    let r1__part_35_0 = sin_theta3_from_theta1_0 * r1__part_34_0;
    // r1__part_36 = r1__part_30 + 2*r1__part_35
    let r1__part_36_0 = r1__part_35_0.mul_add(S::int(2), r1__part_30_0);
    // r1__part_37 = cos_theta3_from_theta1*r1__part_36
    let r1__part_37_0 = cos_theta3_from_theta1_0 * r1__part_36_0;
    // r1__part_38 = cos_theta2_from_theta1*r1__part_22
    let r1__part_38_0 = cos_theta2_from_theta1_0 * r1__part_22_0;
    // r1__part_39 = -13*u3_part_12 + 14*u4_from_u3 + 10*u5_from_u3 + 6*r1__part_38
    let r1__part_39_0 = r1__part_38_0
        .mul_add(
            S::int(6),
            u3_part_12_0
                .mul_add(
                    -S::int(13),
                    u5_from_u3_0.mul_add(S::int(10), S::int(14) * u4_from_u3_0),
                ),
        );
    // r1__part_40 = cos_theta2_from_theta1*r1__part_39
    let r1__part_40_0 = cos_theta2_from_theta1_0 * r1__part_39_0;
    // r1__part_41 = -18*u3_part_12 + 18*u4_from_u3 + 14*u5_from_u3 - 3*r1__part_40
    let r1__part_41_0 = r1__part_40_0
        .mul_add(
            -S::int(3),
            u3_part_12_0
                .mul_add(
                    -S::int(18),
                    u5_from_u3_0.mul_add(S::int(14), S::int(18) * u4_from_u3_0),
                ),
        );
    // r1__part_42 = sin_theta3_from_theta1*r1__part_41
    let r1__part_42_0 = sin_theta3_from_theta1_0 * r1__part_41_0;
    // r1__part_43 = -1 + 3*cos_theta2_from_theta1
    let r1__part_43_0 = cos_theta2_from_theta1_0.mul_add(S::int(3), -S::int(1));
    // r1__part_44 = u5_from_u3*r1__part_43
    let r1__part_44_0 = u5_from_u3_0 * r1__part_43_0;
    // r1__part_45 = -13*u3_part_12 + 14*u4_from_u3 - 2*r1__part_44
    let r1__part_45_0 = u3_part_12_0
        .mul_add(
            -S::int(13),
            r1__part_44_0.mul_add(-S::int(2), S::int(14) * u4_from_u3_0),
        );
    // r1__part_46 = sin_theta2_from_theta1*r1__part_45
    let r1__part_46_0 = sin_theta2_from_theta1_0 * r1__part_45_0;
    // r1__part_47 = 3*r1__part_37 + r1__part_42 + 3*r1__part_46
    let r1__part_47_0 = r1__part_37_0
        .mul_add(S::int(3), S::int(3) * r1__part_46_0 + r1__part_42_0);
    // r1__part_48 = u3_part_12*r1__part_47
    let r1__part_48_0 = u3_part_12_0 * r1__part_47_0;
    // r1__part_49 = 2*u4_from_u3_p2 + u5_from_u3_p2 + 2*r1__part_6
    let r1__part_49_0 = r1__part_6_0
        .mul_add(S::int(2), S::int(2) * u4_from_u3_p2_0 + u5_from_u3_p2_0);
    // r1__part_50 = cos_theta2_from_theta1*r1__part_49
    let r1__part_50_0 = cos_theta2_from_theta1_0 * r1__part_49_0;
    // r1__part_51 = 5 + cos_theta3_from_theta1
    let r1__part_51_0 = S::int(5) + cos_theta3_from_theta1_0;
    // r1__part_52 = r1__part_51*u5_from_u3_p2
    let r1__part_52_0 = r1__part_51_0 * u5_from_u3_p2_0;
    // r1__part_53 = 7*u4_from_u3_p2 + 3*r1__part_50 + r1__part_52
    let r1__part_53_0 = r1__part_50_0
        .mul_add(S::int(3), S::int(7) * u4_from_u3_p2_0 + r1__part_52_0);
    // r1__part_54 = sin_theta3_from_theta1*r1__part_53
    let r1__part_54_0 = sin_theta3_from_theta1_0 * r1__part_53_0;
    // r1__part_55 = cos_theta3_from_theta1*r1__part_49
    let r1__part_55_0 = cos_theta3_from_theta1_0 * r1__part_49_0;
    // r1__part_56 = u5_from_u3_p2 - r1__part_55
    let r1__part_56_0 = u5_from_u3_p2_0 - r1__part_55_0;
    // r1__part_57 = sin_theta2_from_theta1*r1__part_56
    let r1__part_57_0 = sin_theta2_from_theta1_0 * r1__part_56_0;
    // r1__part_58 = r1__part_54 + 3*r1__part_57
    let r1__part_58_0 = r1__part_57_0.mul_add(S::int(3), r1__part_54_0);
    // r1__part_59 = cos_theta2_from_theta1*r1__part_58
    let r1__part_59_0 = cos_theta2_from_theta1_0 * r1__part_58_0;
    // r1__part_60 = r1__part_27*u5_from_u3_p2
    let r1__part_60_0 = r1__part_27_0 * u5_from_u3_p2_0;
    // r1__part_61 = 7*u4_from_u3_p2 + r1__part_60
    let r1__part_61_0 = S::int(7) * u4_from_u3_p2_0 + r1__part_60_0;
    // r1__part_62 = cos_theta3_from_theta1*r1__part_61
    let r1__part_62_0 = cos_theta3_from_theta1_0 * r1__part_61_0;
    // r1__part_63 = 7*u4_from_u3_p2 + u5_from_u3_p2 + r1__part_62
    let r1__part_63_0 = S::int(7) * u4_from_u3_p2_0 + u5_from_u3_p2_0 + r1__part_62_0;
    // r1__part_64 = sin_theta2_from_theta1*r1__part_63
    let r1__part_64_0 = sin_theta2_from_theta1_0 * r1__part_63_0;
    // r1__part_65 = 9*u4_from_u3_p2 + 7*u5_from_u3_p2 + 9*r1__part_6
    let r1__part_65_0 = r1__part_6_0
        .mul_add(
            S::int(9),
            u5_from_u3_p2_0.mul_add(S::int(7), S::int(9) * u4_from_u3_p2_0),
        );
    // r1__part_66 = sin_theta3_from_theta1*r1__part_65
    let r1__part_66_0 = sin_theta3_from_theta1_0 * r1__part_65_0;
    // r1__part_67 = -r1__part_48 - 3*r1__part_59 + 3*r1__part_64 + r1__part_66
    let r1__part_67_0 = r1__part_59_0
        .mul_add(-S::int(3), r1__part_64_0.mul_add(S::int(3), r1__part_66_0))
        - r1__part_48_0;
    // r1__part_68 = -2*u3_part_12 + u4_from_u3 + 2*u5_from_u3 + 6*r1__part_31
    let r1__part_68_0 = r1__part_31_0
        .mul_add(
            S::int(6),
            u3_part_12_0
                .mul_add(-S::int(2), u5_from_u3_0.mul_add(S::int(2), u4_from_u3_0)),
        );
    // r1__part_69 = cos_theta3_from_theta1*r1__part_68
    let r1__part_69_0 = cos_theta3_from_theta1_0 * r1__part_68_0;
    // r1__part_70 = 13 + 6*cos_theta2_from_theta1
    let r1__part_70_0 = cos_theta2_from_theta1_0.mul_add(S::int(6), S::int(13));
    // r1__part_71 = u3_part_12*r1__part_70
    let r1__part_71_0 = u3_part_12_0 * r1__part_70_0;
    // r1__part_72 = 3 + cos_theta2_from_theta1
    let r1__part_72_0 = S::int(3) + cos_theta2_from_theta1_0;
    // r1__part_73 = u4_from_u3*r1__part_72
    let r1__part_73_0 = u4_from_u3_0 * r1__part_72_0;
    // r1__part_74 = 6*u5_from_u3 + 2*r1__part_69 - r1__part_71 + 6*r1__part_73
    let r1__part_74_0 = r1__part_69_0
        .mul_add(
            S::int(2),
            r1__part_73_0.mul_add(S::int(6), S::int(6) * u5_from_u3_0) - r1__part_71_0,
        );
    // r1__part_75 = sin_theta2_from_theta1*r1__part_74
    let r1__part_75_0 = sin_theta2_from_theta1_0 * r1__part_74_0;
    // r1__part_76 = cos_theta2_from_theta1*r1__part_68
    let r1__part_76_0 = cos_theta2_from_theta1_0 * r1__part_68_0;
    // r1__part_77 = -8*u3_part_12 + 9*u4_from_u3 + 8*u5_from_u3 - 3*r1__part_76
    let r1__part_77_0 = r1__part_76_0
        .mul_add(
            -S::int(3),
            u3_part_12_0
                .mul_add(
                    -S::int(8),
                    u5_from_u3_0.mul_add(S::int(8), S::int(9) * u4_from_u3_0),
                ),
        );
    // r1__part_78 = sin_theta3_from_theta1*r1__part_77
    let r1__part_78_0 = sin_theta3_from_theta1_0 * r1__part_77_0;
    // r1__part_79 = 3*r1__part_75 + 2*r1__part_78
    let r1__part_79_0 = r1__part_78_0.mul_add(S::int(2), S::int(3) * r1__part_75_0);
    // r1__part_80 = cos_theta3_from_theta1*r1__part_79
    let r1__part_80_0 = cos_theta3_from_theta1_0 * r1__part_79_0;
    // r1__part_81 = 10 + 3*cos_theta2_from_theta1
    let r1__part_81_0 = cos_theta2_from_theta1_0.mul_add(S::int(3), S::int(10));
    // r1__part_82 = u4_from_u3*r1__part_81
    let r1__part_82_0 = u4_from_u3_0 * r1__part_81_0;
    // r1__part_83 = 6*u5_from_u3 - 3*r1__part_2 + 2*r1__part_82
    let r1__part_83_0 = r1__part_2_0
        .mul_add(-S::int(3), r1__part_82_0.mul_add(S::int(2), S::int(6) * u5_from_u3_0));
    // r1__part_84 = cos_theta2_from_theta1*r1__part_83
    let r1__part_84_0 = cos_theta2_from_theta1_0 * r1__part_83_0;
    // r1__part_85 = -13*u3_part_12 + 18*u4_from_u3 + 6*u5_from_u3 + 3*r1__part_84
    let r1__part_85_0 = r1__part_84_0
        .mul_add(
            S::int(3),
            u3_part_12_0
                .mul_add(
                    -S::int(13),
                    u5_from_u3_0.mul_add(S::int(6), S::int(18) * u4_from_u3_0),
                ),
        );
    // r1__part_86 = sin_theta3_from_theta1*r1__part_85
    let r1__part_86_0 = sin_theta3_from_theta1_0 * r1__part_85_0;
    // r1__part_87 = -u3_part_12 + 3*u4_from_u3 + u5_from_u3 + 3*r1__part_31
    let r1__part_87_0 = r1__part_31_0
        .mul_add(S::int(3), S::int(3) * u4_from_u3_0 + u5_from_u3_0 - u3_part_12_0);
    // r1__part_88 = sin_theta2_from_theta1*r1__part_87
    let r1__part_88_0 = sin_theta2_from_theta1_0 * r1__part_87_0;
    // r1__part_89 = r1__part_80 - r1__part_86 - 6*r1__part_88
    let r1__part_89_0 = -S::int(6) * r1__part_88_0 - r1__part_86_0 + r1__part_80_0;
    // r1__part_90 = u3_part_12*r1__part_89
    let r1__part_90_0 = u3_part_12_0 * r1__part_89_0;
    // r1__part_91 = cos_theta2_from_theta1*r1__part_3
    let r1__part_91_0 = cos_theta2_from_theta1_0 * r1__part_3_0;
    // r1__part_92 = u4_from_u3_p2 + 2*u5_from_u3_p2 + 6*r1__part_91
    let r1__part_92_0 = r1__part_91_0
        .mul_add(S::int(6), u5_from_u3_p2_0.mul_add(S::int(2), u4_from_u3_p2_0));
    // r1__part_93 = cos_theta3_from_theta1*r1__part_92
    let r1__part_93_0 = cos_theta3_from_theta1_0 * r1__part_92_0;
    // r1__part_94 = r1__part_72*u4_from_u3_p2
    let r1__part_94_0 = r1__part_72_0 * u4_from_u3_p2_0;
    // r1__part_95 = 3*u5_from_u3_p2 + r1__part_93 + 3*r1__part_94
    let r1__part_95_0 = r1__part_94_0.mul_add(S::int(3), S::int(3) * u5_from_u3_p2_0)
        + r1__part_93_0;
    // r1__part_96 = sin_theta2_from_theta1*r1__part_95
    let r1__part_96_0 = sin_theta2_from_theta1_0 * r1__part_95_0;
    // r1__part_97 = cos_theta2_from_theta1*r1__part_92
    let r1__part_97_0 = cos_theta2_from_theta1_0 * r1__part_92_0;
    // r1__part_98 = 9*u4_from_u3_p2 + 8*u5_from_u3_p2 - 3*r1__part_97
    let r1__part_98_0 = r1__part_97_0
        .mul_add(
            -S::int(3),
            u5_from_u3_p2_0.mul_add(S::int(8), S::int(9) * u4_from_u3_p2_0),
        );
    // r1__part_99 = sin_theta3_from_theta1*r1__part_98
    let r1__part_99_0 = sin_theta3_from_theta1_0 * r1__part_98_0;
    // r1__part_100 = 3*r1__part_96 + r1__part_99
    let r1__part_100_0 = S::int(3) * r1__part_96_0 + r1__part_99_0;
    // r1__part_101 = cos_theta3_from_theta1*r1__part_100
    let r1__part_101_0 = cos_theta3_from_theta1_0 * r1__part_100_0;
    // r1__part_102 = r1__part_81*u4_from_u3_p2
    let r1__part_102_0 = r1__part_81_0 * u4_from_u3_p2_0;
    // r1__part_103 = 3*u5_from_u3_p2 + r1__part_102
    let r1__part_103_0 = S::int(3) * u5_from_u3_p2_0 + r1__part_102_0;
    // r1__part_104 = cos_theta2_from_theta1*r1__part_103
    let r1__part_104_0 = cos_theta2_from_theta1_0 * r1__part_103_0;
    // r1__part_105 = 3*u4_from_u3_p2 + u5_from_u3_p2 + r1__part_104
    let r1__part_105_0 = S::int(3) * u4_from_u3_p2_0 + u5_from_u3_p2_0 + r1__part_104_0;
    // r1__part_106 = sin_theta3_from_theta1*r1__part_105
    let r1__part_106_0 = sin_theta3_from_theta1_0 * r1__part_105_0;
    // r1__part_107 = 3*u4_from_u3_p2 + u5_from_u3_p2 + 3*r1__part_91
    let r1__part_107_0 = r1__part_91_0
        .mul_add(S::int(3), S::int(3) * u4_from_u3_p2_0 + u5_from_u3_p2_0);
    // r1__part_108 = sin_theta2_from_theta1*r1__part_107
    let r1__part_108_0 = sin_theta2_from_theta1_0 * r1__part_107_0;
    // r1__part_109 = -r1__part_90 + r1__part_101 - 3*r1__part_106 - 3*r1__part_108
    let r1__part_109_0 = r1__part_106_0.mul_add(-S::int(3), -S::int(3) * r1__part_108_0)
        + r1__part_101_0 - r1__part_90_0;
    // r1__part_110 = r1__part_109/u3_part_8
    let r1__part_110_0 = r1__part_109_0 * over_u3_part_8;
    // r1__part_111 = r1__part_21/u3_part_8
    let r1__part_111_0 = r1__part_21_0 * over_u3_part_8;
    // r1__part_112 = r1__part_111/r1__part_12
    let r1__part_112_0 = r1__part_111_0 * over_r1__part_12;
    // r1__part_113 = r1__part_67*r1__part_112
    let r1__part_113_0 = r1__part_67_0 * r1__part_112_0;
    // r1__part_114 = m_l_squared_by_12*r1__part_110 + m_l_squared_by_12*r1__part_113
    let r1__part_114_0 = r1__part_113_0
        .mul_add(m_l_squared_by_12, m_l_squared_by_12 * r1__part_110_0);
    // u5_from_u3_dot_part = cos_theta2_from_theta1*cos_theta3_from_theta1
    let u5_from_u3_dot_part_0 = cos_theta2_from_theta1_0 * cos_theta3_from_theta1_0;
    // u5_from_u3_dot_part_2 = u3_part_3 + u5_from_u3_dot_part
    let u5_from_u3_dot_part_2_0 = u3_part_3_0 + u5_from_u3_dot_part_0;
    // u5_from_u3_dot_part_3 = cos_theta2_from_theta1*u5_from_u3_dot_part_2
    let u5_from_u3_dot_part_3_0 = cos_theta2_from_theta1_0 * u5_from_u3_dot_part_2_0;
    // u5_from_u3_dot_part_4 = 5*cos_theta3_from_theta1 - 9*u5_from_u3_dot_part_3
    let u5_from_u3_dot_part_4_0 = u5_from_u3_dot_part_3_0
        .mul_add(-S::int(9), S::int(5) * cos_theta3_from_theta1_0);
    // u5_from_u3_dot_part_5 = cos_theta3_from_theta1*u5_from_u3_dot_part_4
    let u5_from_u3_dot_part_5_0 = cos_theta3_from_theta1_0 * u5_from_u3_dot_part_4_0;
    // u5_from_u3_dot_part_6 = 9 + u5_from_u3_dot_part_5
    let u5_from_u3_dot_part_6_0 = S::int(9) + u5_from_u3_dot_part_5_0;
    let over_u5_from_u3_dot_part_6 = S::int(1) / u5_from_u3_dot_part_6_0;
    // u5_from_u3_dot_part_7 = r1__part_12/u5_from_u3_dot_part_6
    let u5_from_u3_dot_part_7_0 = r1__part_12_0 * over_u5_from_u3_dot_part_6;
    // u5_from_u3_dot_part_8 = r1__part_114*u5_from_u3_dot_part_7
    let u5_from_u3_dot_part_8_0 = r1__part_114_0 * u5_from_u3_dot_part_7_0;
    // u3_plus_u5_from_u3 = -u3_part_12 + u5_from_u3
    let u3_plus_u5_from_u3_0 = u5_from_u3_0 - u3_part_12_0;
    // u4_from_u3_dot_part = cos_theta3_from_theta1*u3_plus_u5_from_u3
    let u4_from_u3_dot_part_0 = cos_theta3_from_theta1_0 * u3_plus_u5_from_u3_0;
    // u4_from_u3_dot_part_2 = 1 + cos_theta2_from_theta1
    let u4_from_u3_dot_part_2_0 = S::int(1) + cos_theta2_from_theta1_0;
    // u4_from_u3_dot_part_3 = u3_part_12*r1__part_4
    let u4_from_u3_dot_part_3_0 = u3_part_12_0 * r1__part_4_0;
    // u4_from_u3_dot_part_4 = u4_from_u3_p2 + u5_from_u3_p2 - 2*u4_from_u3_dot_part_3
    let u4_from_u3_dot_part_4_0 = u4_from_u3_dot_part_3_0
        .mul_add(-S::int(2), u4_from_u3_p2_0 + u5_from_u3_p2_0);
    // u4_from_u3_dot_part_5 = sin_theta3_from_theta1*u4_from_u3_dot_part_4
    let u4_from_u3_dot_part_5_0 = sin_theta3_from_theta1_0 * u4_from_u3_dot_part_4_0;
    // u4_from_u3_dot_part_6 = sin_theta3_from_theta1*u5_from_u3_dot_part_8
    let u4_from_u3_dot_part_6_0 = sin_theta3_from_theta1_0 * u5_from_u3_dot_part_8_0;
    // u4_from_u3_dot_part_7 = u3_part_12*u3_plus_u5_from_u3
    let u4_from_u3_dot_part_7_0 = u3_part_12_0 * u3_plus_u5_from_u3_0;
    // u4_from_u3_dot_part_8 = -9*u3_part_12 + 9*u4_from_u3 + 7*u5_from_u3
    let u4_from_u3_dot_part_8_0 = u3_part_12_0
        .mul_add(-S::int(9), u5_from_u3_0.mul_add(S::int(7), S::int(9) * u4_from_u3_0));
    // u4_from_u3_dot_part_9 = 2*u4_from_u3_p2 + u5_from_u3_p2
    let u4_from_u3_dot_part_9_0 = S::int(2) * u4_from_u3_p2_0 + u5_from_u3_p2_0;
    // u4_from_u3_dot_part_10 = sin_theta2_from_theta1*u5_from_u3_dot_part_8
    let u4_from_u3_dot_part_10_0 = sin_theta2_from_theta1_0 * u5_from_u3_dot_part_8_0;
    // u4_from_u3_dot_part_11 = cos_theta2_from_theta1*u4_from_u3_dot_part_9
    let u4_from_u3_dot_part_11_0 = cos_theta2_from_theta1_0 * u4_from_u3_dot_part_9_0;
    // u4_from_u3_dot_part_12 = u3_part_12*u4_from_u3_dot_part_8
    let u4_from_u3_dot_part_12_0 = u3_part_12_0 * u4_from_u3_dot_part_8_0;
    // u4_from_u3_dot_part_13 = 7 + 9*cos_theta3_from_theta1
    let u4_from_u3_dot_part_13_0 = cos_theta3_from_theta1_0
        .mul_add(S::int(9), S::int(7));
    // u4_from_u3_dot_part_14 = u5_from_u3_dot_part_8*u4_from_u3_dot_part_13
    let u4_from_u3_dot_part_14_0 = u5_from_u3_dot_part_8_0 * u4_from_u3_dot_part_13_0;
    // u4_from_u3_dot_part_15 = u3_part_12*r1__part_39
    let u4_from_u3_dot_part_15_0 = u3_part_12_0 * r1__part_39_0;
    // u4_from_u3_dot_part_16 = 7*u4_from_u3_p2 + 5*u5_from_u3_p2 + weight_2*u4_from_u3_dot_part_10 +
    //   3*u4_from_u3_dot_part_11 - u4_from_u3_dot_part_15
    let u4_from_u3_dot_part_16_0 = u4_from_u3_dot_part_10_0
        .mul_add(
            weight_2,
            u4_from_u3_dot_part_11_0
                .mul_add(
                    S::int(3),
                    u5_from_u3_p2_0.mul_add(S::int(5), S::int(7) * u4_from_u3_p2_0),
                ) - u4_from_u3_dot_part_15_0,
        );
    // u4_from_u3_dot_part_17 = cos_theta2_from_theta1*u4_from_u3_dot_part_16
    let u4_from_u3_dot_part_17_0 = cos_theta2_from_theta1_0 * u4_from_u3_dot_part_16_0;
    // u4_from_u3_dot_part_18 = 9*u4_from_u3_p2 + 7*u5_from_u3_p2 + weight_3*u4_from_u3_dot_part_10 -
    //   2*u4_from_u3_dot_part_12 - 3*u4_from_u3_dot_part_17
    let u4_from_u3_dot_part_18_0 = u4_from_u3_dot_part_17_0
        .mul_add(
            -S::int(3),
            u4_from_u3_dot_part_10_0
                .mul_add(
                    weight_3,
                    u4_from_u3_dot_part_12_0
                        .mul_add(
                            -S::int(2),
                            u5_from_u3_p2_0
                                .mul_add(S::int(7), S::int(9) * u4_from_u3_p2_0),
                        ),
                ),
        );
    // u4_from_u3_dot_part_19 = sin_theta3_from_theta1*u4_from_u3_dot_part_18
    let u4_from_u3_dot_part_19_0 = sin_theta3_from_theta1_0 * u4_from_u3_dot_part_18_0;
    // u4_from_u3_dot_part_20 = u3_part_12*r1__part_45
    let u4_from_u3_dot_part_20_0 = u3_part_12_0 * r1__part_45_0;
    // u4_from_u3_dot_part_21 = r1__part_43*u5_from_u3_p2
    let u4_from_u3_dot_part_21_0 = r1__part_43_0 * u5_from_u3_p2_0;
    // u4_from_u3_dot_part_22 = 7*u4_from_u3_p2 - u4_from_u3_dot_part_20 - u4_from_u3_dot_part_21
    let u4_from_u3_dot_part_22_0 = S::int(7) * u4_from_u3_p2_0 - u4_from_u3_dot_part_21_0
        - u4_from_u3_dot_part_20_0;
    // u4_from_u3_dot_part_23 = sin_theta2_from_theta1*u4_from_u3_dot_part_22
    let u4_from_u3_dot_part_23_0 = sin_theta2_from_theta1_0 * u4_from_u3_dot_part_22_0;
    // u4_from_u3_dot_part_24 = cos_theta2_from_theta1*u4_from_u3_dot_part_2
    let u4_from_u3_dot_part_24_0 = cos_theta2_from_theta1_0 * u4_from_u3_dot_part_2_0;
    // u4_from_u3_dot_part_25 = 4 + 3*u4_from_u3_dot_part_24
    let u4_from_u3_dot_part_25_0 = u4_from_u3_dot_part_24_0
        .mul_add(S::int(3), S::int(4));
    // u4_from_u3_dot_part_26 = u5_from_u3_dot_part_8*u4_from_u3_dot_part_25
    let u4_from_u3_dot_part_26_0 = u5_from_u3_dot_part_8_0 * u4_from_u3_dot_part_25_0;
    // u4_from_u3_dot_part_27 = u3_part_12*r1__part_23
    let u4_from_u3_dot_part_27_0 = u3_part_12_0 * r1__part_23_0;
    // u4_from_u3_dot_part_28 = 2 + cos_theta3_from_theta1 + 3*r1__part_14
    let u4_from_u3_dot_part_28_0 = r1__part_14_0
        .mul_add(S::int(3), S::int(2) + cos_theta3_from_theta1_0);
    // u4_from_u3_dot_part_29 = cos_theta2_from_theta1*u4_from_u3_dot_part_4
    let u4_from_u3_dot_part_29_0 = cos_theta2_from_theta1_0 * u4_from_u3_dot_part_4_0;
    // u4_from_u3_dot_part_30 = 2*u4_from_u3_p2 + u5_from_u3_p2 + 2*r1__part_6 +
    //   weight_4*u4_from_u3_dot_part_6 - 2*u4_from_u3_dot_part_27
    let u4_from_u3_dot_part_30_0 = u4_from_u3_dot_part_6_0
        .mul_add(
            weight_4,
            u4_from_u3_dot_part_27_0
                .mul_add(
                    -S::int(2),
                    r1__part_6_0
                        .mul_add(
                            S::int(2),
                            S::int(2) * u4_from_u3_p2_0 + u5_from_u3_p2_0,
                        ),
                ),
        );
    // u4_from_u3_dot_part_31 = sin_theta2_from_theta1*u4_from_u3_dot_part_30
    let u4_from_u3_dot_part_31_0 = sin_theta2_from_theta1_0 * u4_from_u3_dot_part_30_0;
    // u4_from_u3_dot_part_32 = u5_from_u3_p2 - 2*u4_from_u3_dot_part_7 + 6*u4_from_u3_dot_part_29
    let u4_from_u3_dot_part_32_0 = u4_from_u3_dot_part_29_0
        .mul_add(
            S::int(6),
            u4_from_u3_dot_part_7_0.mul_add(-S::int(2), u5_from_u3_p2_0),
        );
    // u4_from_u3_dot_part_33 = sin_theta3_from_theta1*u4_from_u3_dot_part_32
    let u4_from_u3_dot_part_33_0 = sin_theta3_from_theta1_0 * u4_from_u3_dot_part_32_0;
    // u4_from_u3_dot_part_34 = u5_from_u3_dot_part_8*u4_from_u3_dot_part_28
    let u4_from_u3_dot_part_34_0 = u5_from_u3_dot_part_8_0 * u4_from_u3_dot_part_28_0;
    // u4_from_u3_dot_part_35 = 3*u4_from_u3_dot_part_31 - u4_from_u3_dot_part_33 +
    //   weight_5*u4_from_u3_dot_part_34
    let u4_from_u3_dot_part_35_0 = u4_from_u3_dot_part_31_0
        .mul_add(
            S::int(3),
            u4_from_u3_dot_part_34_0.mul_add(weight_5, -u4_from_u3_dot_part_33_0),
        );
    // u4_from_u3_dot_part_36 = cos_theta2_from_theta1*u4_from_u3_dot_part_35
    let u4_from_u3_dot_part_36_0 = cos_theta2_from_theta1_0 * u4_from_u3_dot_part_35_0;
    // u4_from_u3_dot_part_37 = -15*u3_part_12 + 14*u4_from_u3 + 12*u5_from_u3 + 2*u4_from_u3_dot_part
    let u4_from_u3_dot_part_37_0 = u4_from_u3_dot_part_0
        .mul_add(
            S::int(2),
            u3_part_12_0
                .mul_add(
                    -S::int(15),
                    u5_from_u3_0.mul_add(S::int(12), S::int(14) * u4_from_u3_0),
                ),
        );
    // u4_from_u3_dot_part_38 = u3_part_12*u4_from_u3_dot_part_37
    let u4_from_u3_dot_part_38_0 = u3_part_12_0 * u4_from_u3_dot_part_37_0;
    // u4_from_u3_dot_part_39 = 7*u4_from_u3_p2 + weight_5*u4_from_u3_dot_part_6 + r1__part_60 -
    //   u4_from_u3_dot_part_38
    let u4_from_u3_dot_part_39_0 = u4_from_u3_dot_part_6_0
        .mul_add(
            weight_5,
            S::int(7) * u4_from_u3_p2_0 + r1__part_60_0 - u4_from_u3_dot_part_38_0,
        );
    // u4_from_u3_dot_part_40 = sin_theta2_from_theta1*u4_from_u3_dot_part_39
    let u4_from_u3_dot_part_40_0 = sin_theta2_from_theta1_0 * u4_from_u3_dot_part_39_0;
    // u4_from_u3_dot_part_41 = 9*u4_from_u3_dot_part_5 + weight_6*u4_from_u3_dot_part_14 +
    //   3*u4_from_u3_dot_part_36 + 3*u4_from_u3_dot_part_40
    let u4_from_u3_dot_part_41_0 = u4_from_u3_dot_part_36_0
        .mul_add(
            S::int(3),
            u4_from_u3_dot_part_40_0
                .mul_add(
                    S::int(3),
                    u4_from_u3_dot_part_14_0
                        .mul_add(weight_6, S::int(9) * u4_from_u3_dot_part_5_0),
                ),
        );
    // u4_from_u3_dot_part_42 = cos_theta3_from_theta1*u4_from_u3_dot_part_41
    let u4_from_u3_dot_part_42_0 = cos_theta3_from_theta1_0 * u4_from_u3_dot_part_41_0;
    // u4_from_u3_dot_part_43 = u4_from_u3_dot_part_19 + 3*u4_from_u3_dot_part_23 +
    //   weight_2*u4_from_u3_dot_part_26 + u4_from_u3_dot_part_42
    let u4_from_u3_dot_part_43_0 = u4_from_u3_dot_part_26_0
        .mul_add(weight_2, S::int(3) * u4_from_u3_dot_part_23_0)
        + u4_from_u3_dot_part_19_0 + u4_from_u3_dot_part_42_0;
    // u4_from_u3_dot_part_44 = u4_from_u3_dot_part_43/r1__part_12
    let u4_from_u3_dot_part_44_0 = u4_from_u3_dot_part_43_0 * over_r1__part_12;
    // Order 1: the rates, and what follows from them.
    let theta2_from_theta1_1 = u4_from_u3_0;
    let theta3_from_theta1_1 = u5_from_u3_0;
    let theta1_1 = -u3_part_12_0;
    let u4_from_u3_1 = -u4_from_u3_dot_part_44_0;
    let u5_from_u3_1 = weight_5 * u5_from_u3_dot_part_8_0;
    if series.len() > 1 {
        series[1] = [
            theta2_from_theta1_1,
            theta3_from_theta1_1,
            theta1_1,
            u4_from_u3_1,
            u5_from_u3_1,
        ];
    }
    let sin_theta2_from_theta1_1 = theta2_from_theta1_1 * cos_theta2_from_theta1_0;
    let cos_theta2_from_theta1_1 = -theta2_from_theta1_1 * sin_theta2_from_theta1_0;
    let sin_theta3_from_theta1_1 = theta3_from_theta1_1 * cos_theta3_from_theta1_0;
    let cos_theta3_from_theta1_1 = -theta3_from_theta1_1 * sin_theta3_from_theta1_0;
    let u3_part_1 = cos_theta3_from_theta1_1;
    let u3_part_2_1 = u3_part_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * u3_part_0);
    let u3_part_3_1 = sin_theta3_from_theta1_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * sin_theta3_from_theta1_0,
        );
    let u3_part_4_1 = u3_part_2_1.mul_add(S::int(3), S::int(3) * u3_part_3_1);
    let u3_part_5_1 = S::int(3) * cos_theta2_from_theta1_1;
    let u3_part_6_1 = u3_part_5_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * u3_part_5_0);
    let u3_part_7_1 = S::int(3) * u3_part_3_1 + u3_part_6_1;
    let u3_part_8_1 = u3_part_2_1
        .mul_add(
            S::int(6),
            u3_part_3_1.mul_add(S::int(6), S::int(2) * cos_theta3_from_theta1_1),
        );
    let u3_part_9_1 = u3_part_4_1.mul_add(u4_from_u3_0, u4_from_u3_1 * u3_part_4_0);
    let u3_part_10_1 = u3_part_7_1.mul_add(u5_from_u3_0, u5_from_u3_1 * u3_part_7_0);
    let u3_part_11_1 = u3_part_9_1 + u3_part_10_1;
    let u3_part_12_1 = u3_part_8_1
        .mul_add(-(u3_part_12_0 * over_u3_part_8), u3_part_11_1 * over_u3_part_8);
    let u4_from_u3_p2_1 = u4_from_u3_1 * (u4_from_u3_0 + u4_from_u3_0);
    let u5_from_u3_p2_1 = u5_from_u3_1 * (u5_from_u3_0 + u5_from_u3_0);
    let r1__part_1 = S::int(2) * cos_theta2_from_theta1_1;
    let r1__part_2_1 = u3_part_12_1.mul_add(r1__part_0, r1__part_1 * u3_part_12_0);
    let r1__part_3_1 = u4_from_u3_p2_1 + u5_from_u3_p2_1;
    let r1__part_4_1 = u4_from_u3_1 + u5_from_u3_1 - u3_part_12_1;
    let r1__part_5_1 = r1__part_4_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_4_0);
    let r1__part_6_1 = r1__part_3_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_3_0);
    let r1__part_7_1 = u3_part_3_1 + u3_part_2_1;
    let r1__part_8_1 = r1__part_7_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_7_0);
    let r1__part_9_1 = r1__part_8_1
        .mul_add(-S::int(18), S::int(9) * cos_theta3_from_theta1_1);
    let r1__part_10_1 = r1__part_9_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_9_0);
    let r1__part_11_1 = u3_part_3_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * u3_part_3_0);
    let r1__part_12_1 = -S::int(18) * r1__part_11_1 + r1__part_10_1;
    let r1__part_13_1 = S::int(2) * cos_theta3_from_theta1_1;
    let r1__part_14_1 = r1__part_13_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_13_0);
    let r1__part_15_1 = r1__part_14_1
        .mul_add(S::int(3), u3_part_3_1.mul_add(S::int(6), cos_theta3_from_theta1_1));
    let r1__part_16_1 = r1__part_15_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_15_0);
    let r1__part_17_1 = u3_part_3_1
        .mul_add(-S::int(3), S::int(3) * cos_theta2_from_theta1_1) - r1__part_16_1;
    let r1__part_18_1 = r1__part_17_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_17_0);
    let r1__part_19_1 = u3_part_3_1
        .mul_add(-S::int(3), S::int(9) * cos_theta3_from_theta1_1);
    let r1__part_20_1 = r1__part_19_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_19_0);
    let r1__part_21_1 = r1__part_18_1
        .mul_add(-S::int(3), S::int(9) * u3_part_3_1 - r1__part_20_1);
    let r1__part_22_1 = u3_part_12_1
        .mul_add(-S::int(2), S::int(2) * u4_from_u3_1 + u5_from_u3_1);
    let r1__part_23_1 = r1__part_5_1
        .mul_add(
            S::int(2),
            u3_part_12_1.mul_add(-S::int(2), S::int(2) * u4_from_u3_1 + u5_from_u3_1),
        );
    let r1__part_24_1 = r1__part_23_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_23_0);
    let r1__part_25_1 = S::int(2) * cos_theta3_from_theta1_1;
    let r1__part_26_1 = u3_part_12_1
        .mul_add(r1__part_25_0, r1__part_25_1 * u3_part_12_0);
    let r1__part_27_1 = cos_theta3_from_theta1_1;
    let r1__part_28_1 = r1__part_27_1
        .mul_add(u5_from_u3_0, u5_from_u3_1 * r1__part_27_0);
    let r1__part_29_1 = r1__part_24_1
        .mul_add(
            S::int(6),
            r1__part_28_1.mul_add(S::int(2), S::int(14) * u4_from_u3_1) - r1__part_26_1,
        );
    let r1__part_30_1 = r1__part_29_1
        .mul_add(sin_theta2_from_theta1_0, sin_theta2_from_theta1_1 * r1__part_29_0);
    let r1__part_31_1 = r1__part_4_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_4_0);
    let r1__part_32_1 = r1__part_31_1.mul_add(S::int(6), u5_from_u3_1 - u3_part_12_1);
    let r1__part_33_1 = r1__part_32_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_32_0);
    let r1__part_34_1 = u3_part_12_1
        .mul_add(-S::int(3), u5_from_u3_1.mul_add(S::int(3), S::int(3) * u4_from_u3_1))
        - r1__part_33_1;
    let r1__part_35_1 = r1__part_34_1
        .mul_add(sin_theta3_from_theta1_0, sin_theta3_from_theta1_1 * r1__part_34_0);
    let r1__part_36_1 = r1__part_35_1.mul_add(S::int(2), r1__part_30_1);
    let r1__part_37_1 = r1__part_36_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_36_0);
    let r1__part_38_1 = r1__part_22_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_22_0);
    let r1__part_39_1 = r1__part_38_1
        .mul_add(
            S::int(6),
            u3_part_12_1
                .mul_add(
                    -S::int(13),
                    u5_from_u3_1.mul_add(S::int(10), S::int(14) * u4_from_u3_1),
                ),
        );
    let r1__part_40_1 = r1__part_39_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_39_0);
    let r1__part_41_1 = r1__part_40_1
        .mul_add(
            -S::int(3),
            u3_part_12_1
                .mul_add(
                    -S::int(18),
                    u5_from_u3_1.mul_add(S::int(14), S::int(18) * u4_from_u3_1),
                ),
        );
    let r1__part_42_1 = r1__part_41_1
        .mul_add(sin_theta3_from_theta1_0, sin_theta3_from_theta1_1 * r1__part_41_0);
    let r1__part_43_1 = S::int(3) * cos_theta2_from_theta1_1;
    let r1__part_44_1 = r1__part_43_1
        .mul_add(u5_from_u3_0, u5_from_u3_1 * r1__part_43_0);
    let r1__part_45_1 = u3_part_12_1
        .mul_add(
            -S::int(13),
            r1__part_44_1.mul_add(-S::int(2), S::int(14) * u4_from_u3_1),
        );
    let r1__part_46_1 = r1__part_45_1
        .mul_add(sin_theta2_from_theta1_0, sin_theta2_from_theta1_1 * r1__part_45_0);
    let r1__part_47_1 = r1__part_37_1
        .mul_add(S::int(3), S::int(3) * r1__part_46_1 + r1__part_42_1);
    let r1__part_48_1 = r1__part_47_1
        .mul_add(u3_part_12_0, u3_part_12_1 * r1__part_47_0);
    let r1__part_49_1 = r1__part_6_1
        .mul_add(S::int(2), S::int(2) * u4_from_u3_p2_1 + u5_from_u3_p2_1);
    let r1__part_50_1 = r1__part_49_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_49_0);
    let r1__part_51_1 = cos_theta3_from_theta1_1;
    let r1__part_52_1 = r1__part_51_1
        .mul_add(u5_from_u3_p2_0, u5_from_u3_p2_1 * r1__part_51_0);
    let r1__part_53_1 = r1__part_50_1
        .mul_add(S::int(3), S::int(7) * u4_from_u3_p2_1 + r1__part_52_1);
    let r1__part_54_1 = r1__part_53_1
        .mul_add(sin_theta3_from_theta1_0, sin_theta3_from_theta1_1 * r1__part_53_0);
    let r1__part_55_1 = r1__part_49_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_49_0);
    let r1__part_56_1 = u5_from_u3_p2_1 - r1__part_55_1;
    let r1__part_57_1 = r1__part_56_1
        .mul_add(sin_theta2_from_theta1_0, sin_theta2_from_theta1_1 * r1__part_56_0);
    let r1__part_58_1 = r1__part_57_1.mul_add(S::int(3), r1__part_54_1);
    let r1__part_59_1 = r1__part_58_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_58_0);
    let r1__part_60_1 = r1__part_27_1
        .mul_add(u5_from_u3_p2_0, u5_from_u3_p2_1 * r1__part_27_0);
    let r1__part_61_1 = S::int(7) * u4_from_u3_p2_1 + r1__part_60_1;
    let r1__part_62_1 = r1__part_61_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_61_0);
    let r1__part_63_1 = S::int(7) * u4_from_u3_p2_1 + u5_from_u3_p2_1 + r1__part_62_1;
    let r1__part_64_1 = r1__part_63_1
        .mul_add(sin_theta2_from_theta1_0, sin_theta2_from_theta1_1 * r1__part_63_0);
    let r1__part_65_1 = r1__part_6_1
        .mul_add(
            S::int(9),
            u5_from_u3_p2_1.mul_add(S::int(7), S::int(9) * u4_from_u3_p2_1),
        );
    let r1__part_66_1 = r1__part_65_1
        .mul_add(sin_theta3_from_theta1_0, sin_theta3_from_theta1_1 * r1__part_65_0);
    let r1__part_67_1 = r1__part_59_1
        .mul_add(-S::int(3), r1__part_64_1.mul_add(S::int(3), r1__part_66_1))
        - r1__part_48_1;
    let r1__part_68_1 = r1__part_31_1
        .mul_add(
            S::int(6),
            u3_part_12_1
                .mul_add(-S::int(2), u5_from_u3_1.mul_add(S::int(2), u4_from_u3_1)),
        );
    let r1__part_69_1 = r1__part_68_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_68_0);
    let r1__part_70_1 = S::int(6) * cos_theta2_from_theta1_1;
    let r1__part_71_1 = u3_part_12_1
        .mul_add(r1__part_70_0, r1__part_70_1 * u3_part_12_0);
    let r1__part_72_1 = cos_theta2_from_theta1_1;
    let r1__part_73_1 = r1__part_72_1
        .mul_add(u4_from_u3_0, u4_from_u3_1 * r1__part_72_0);
    let r1__part_74_1 = r1__part_69_1
        .mul_add(
            S::int(2),
            r1__part_73_1.mul_add(S::int(6), S::int(6) * u5_from_u3_1) - r1__part_71_1,
        );
    let r1__part_75_1 = r1__part_74_1
        .mul_add(sin_theta2_from_theta1_0, sin_theta2_from_theta1_1 * r1__part_74_0);
    let r1__part_76_1 = r1__part_68_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_68_0);
    let r1__part_77_1 = r1__part_76_1
        .mul_add(
            -S::int(3),
            u3_part_12_1
                .mul_add(
                    -S::int(8),
                    u5_from_u3_1.mul_add(S::int(8), S::int(9) * u4_from_u3_1),
                ),
        );
    let r1__part_78_1 = r1__part_77_1
        .mul_add(sin_theta3_from_theta1_0, sin_theta3_from_theta1_1 * r1__part_77_0);
    let r1__part_79_1 = r1__part_78_1.mul_add(S::int(2), S::int(3) * r1__part_75_1);
    let r1__part_80_1 = r1__part_79_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_79_0);
    let r1__part_81_1 = S::int(3) * cos_theta2_from_theta1_1;
    let r1__part_82_1 = r1__part_81_1
        .mul_add(u4_from_u3_0, u4_from_u3_1 * r1__part_81_0);
    let r1__part_83_1 = r1__part_2_1
        .mul_add(-S::int(3), r1__part_82_1.mul_add(S::int(2), S::int(6) * u5_from_u3_1));
    let r1__part_84_1 = r1__part_83_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_83_0);
    let r1__part_85_1 = r1__part_84_1
        .mul_add(
            S::int(3),
            u3_part_12_1
                .mul_add(
                    -S::int(13),
                    u5_from_u3_1.mul_add(S::int(6), S::int(18) * u4_from_u3_1),
                ),
        );
    let r1__part_86_1 = r1__part_85_1
        .mul_add(sin_theta3_from_theta1_0, sin_theta3_from_theta1_1 * r1__part_85_0);
    let r1__part_87_1 = r1__part_31_1
        .mul_add(S::int(3), S::int(3) * u4_from_u3_1 + u5_from_u3_1 - u3_part_12_1);
    let r1__part_88_1 = r1__part_87_1
        .mul_add(sin_theta2_from_theta1_0, sin_theta2_from_theta1_1 * r1__part_87_0);
    let r1__part_89_1 = -S::int(6) * r1__part_88_1 - r1__part_86_1 + r1__part_80_1;
    let r1__part_90_1 = r1__part_89_1
        .mul_add(u3_part_12_0, u3_part_12_1 * r1__part_89_0);
    let r1__part_91_1 = r1__part_3_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_3_0);
    let r1__part_92_1 = r1__part_91_1
        .mul_add(S::int(6), u5_from_u3_p2_1.mul_add(S::int(2), u4_from_u3_p2_1));
    let r1__part_93_1 = r1__part_92_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_92_0);
    let r1__part_94_1 = r1__part_72_1
        .mul_add(u4_from_u3_p2_0, u4_from_u3_p2_1 * r1__part_72_0);
    let r1__part_95_1 = r1__part_94_1.mul_add(S::int(3), S::int(3) * u5_from_u3_p2_1)
        + r1__part_93_1;
    let r1__part_96_1 = r1__part_95_1
        .mul_add(sin_theta2_from_theta1_0, sin_theta2_from_theta1_1 * r1__part_95_0);
    let r1__part_97_1 = r1__part_92_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_92_0);
    let r1__part_98_1 = r1__part_97_1
        .mul_add(
            -S::int(3),
            u5_from_u3_p2_1.mul_add(S::int(8), S::int(9) * u4_from_u3_p2_1),
        );
    let r1__part_99_1 = r1__part_98_1
        .mul_add(sin_theta3_from_theta1_0, sin_theta3_from_theta1_1 * r1__part_98_0);
    let r1__part_100_1 = S::int(3) * r1__part_96_1 + r1__part_99_1;
    let r1__part_101_1 = r1__part_100_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_100_0);
    let r1__part_102_1 = r1__part_81_1
        .mul_add(u4_from_u3_p2_0, u4_from_u3_p2_1 * r1__part_81_0);
    let r1__part_103_1 = S::int(3) * u5_from_u3_p2_1 + r1__part_102_1;
    let r1__part_104_1 = r1__part_103_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_103_0);
    let r1__part_105_1 = S::int(3) * u4_from_u3_p2_1 + u5_from_u3_p2_1 + r1__part_104_1;
    let r1__part_106_1 = r1__part_105_1
        .mul_add(sin_theta3_from_theta1_0, sin_theta3_from_theta1_1 * r1__part_105_0);
    let r1__part_107_1 = r1__part_91_1
        .mul_add(S::int(3), S::int(3) * u4_from_u3_p2_1 + u5_from_u3_p2_1);
    let r1__part_108_1 = r1__part_107_1
        .mul_add(sin_theta2_from_theta1_0, sin_theta2_from_theta1_1 * r1__part_107_0);
    let r1__part_109_1 = r1__part_106_1.mul_add(-S::int(3), -S::int(3) * r1__part_108_1)
        + r1__part_101_1 - r1__part_90_1;
    let r1__part_110_1 = u3_part_8_1
        .mul_add(-(r1__part_110_0 * over_u3_part_8), r1__part_109_1 * over_u3_part_8);
    let r1__part_111_1 = u3_part_8_1
        .mul_add(-(r1__part_111_0 * over_u3_part_8), r1__part_21_1 * over_u3_part_8);
    let r1__part_112_1 = r1__part_12_1
        .mul_add(
            -(r1__part_112_0 * over_r1__part_12),
            r1__part_111_1 * over_r1__part_12,
        );
    let r1__part_113_1 = r1__part_67_1
        .mul_add(r1__part_112_0, r1__part_112_1 * r1__part_67_0);
    let r1__part_114_1 = r1__part_113_1
        .mul_add(m_l_squared_by_12, m_l_squared_by_12 * r1__part_110_1);
    let u5_from_u3_dot_part_1 = cos_theta3_from_theta1_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * cos_theta3_from_theta1_0,
        );
    let u5_from_u3_dot_part_2_1 = u3_part_3_1 + u5_from_u3_dot_part_1;
    let u5_from_u3_dot_part_3_1 = u5_from_u3_dot_part_2_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * u5_from_u3_dot_part_2_0,
        );
    let u5_from_u3_dot_part_4_1 = u5_from_u3_dot_part_3_1
        .mul_add(-S::int(9), S::int(5) * cos_theta3_from_theta1_1);
    let u5_from_u3_dot_part_5_1 = u5_from_u3_dot_part_4_1
        .mul_add(
            cos_theta3_from_theta1_0,
            cos_theta3_from_theta1_1 * u5_from_u3_dot_part_4_0,
        );
    let u5_from_u3_dot_part_6_1 = u5_from_u3_dot_part_5_1;
    let u5_from_u3_dot_part_7_1 = u5_from_u3_dot_part_6_1
        .mul_add(
            -(u5_from_u3_dot_part_7_0 * over_u5_from_u3_dot_part_6),
            r1__part_12_1 * over_u5_from_u3_dot_part_6,
        );
    let u5_from_u3_dot_part_8_1 = r1__part_114_1
        .mul_add(u5_from_u3_dot_part_7_0, u5_from_u3_dot_part_7_1 * r1__part_114_0);
    let u3_plus_u5_from_u3_1 = u5_from_u3_1 - u3_part_12_1;
    let u4_from_u3_dot_part_1 = u3_plus_u5_from_u3_1
        .mul_add(
            cos_theta3_from_theta1_0,
            cos_theta3_from_theta1_1 * u3_plus_u5_from_u3_0,
        );
    let u4_from_u3_dot_part_2_1 = cos_theta2_from_theta1_1;
    let u4_from_u3_dot_part_3_1 = r1__part_4_1
        .mul_add(u3_part_12_0, u3_part_12_1 * r1__part_4_0);
    let u4_from_u3_dot_part_4_1 = u4_from_u3_dot_part_3_1
        .mul_add(-S::int(2), u4_from_u3_p2_1 + u5_from_u3_p2_1);
    let u4_from_u3_dot_part_5_1 = u4_from_u3_dot_part_4_1
        .mul_add(
            sin_theta3_from_theta1_0,
            sin_theta3_from_theta1_1 * u4_from_u3_dot_part_4_0,
        );
    let u4_from_u3_dot_part_6_1 = u5_from_u3_dot_part_8_1
        .mul_add(
            sin_theta3_from_theta1_0,
            sin_theta3_from_theta1_1 * u5_from_u3_dot_part_8_0,
        );
    let u4_from_u3_dot_part_7_1 = u3_plus_u5_from_u3_1
        .mul_add(u3_part_12_0, u3_part_12_1 * u3_plus_u5_from_u3_0);
    let u4_from_u3_dot_part_8_1 = u3_part_12_1
        .mul_add(-S::int(9), u5_from_u3_1.mul_add(S::int(7), S::int(9) * u4_from_u3_1));
    let u4_from_u3_dot_part_9_1 = S::int(2) * u4_from_u3_p2_1 + u5_from_u3_p2_1;
    let u4_from_u3_dot_part_10_1 = u5_from_u3_dot_part_8_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * u5_from_u3_dot_part_8_0,
        );
    let u4_from_u3_dot_part_11_1 = u4_from_u3_dot_part_9_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * u4_from_u3_dot_part_9_0,
        );
    let u4_from_u3_dot_part_12_1 = u4_from_u3_dot_part_8_1
        .mul_add(u3_part_12_0, u3_part_12_1 * u4_from_u3_dot_part_8_0);
    let u4_from_u3_dot_part_13_1 = S::int(9) * cos_theta3_from_theta1_1;
    let u4_from_u3_dot_part_14_1 = u5_from_u3_dot_part_8_1
        .mul_add(
            u4_from_u3_dot_part_13_0,
            u4_from_u3_dot_part_13_1 * u5_from_u3_dot_part_8_0,
        );
    let u4_from_u3_dot_part_15_1 = r1__part_39_1
        .mul_add(u3_part_12_0, u3_part_12_1 * r1__part_39_0);
    let u4_from_u3_dot_part_16_1 = u4_from_u3_dot_part_10_1
        .mul_add(
            weight_2,
            u4_from_u3_dot_part_11_1
                .mul_add(
                    S::int(3),
                    u5_from_u3_p2_1.mul_add(S::int(5), S::int(7) * u4_from_u3_p2_1),
                ) - u4_from_u3_dot_part_15_1,
        );
    let u4_from_u3_dot_part_17_1 = u4_from_u3_dot_part_16_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * u4_from_u3_dot_part_16_0,
        );
    let u4_from_u3_dot_part_18_1 = u4_from_u3_dot_part_17_1
        .mul_add(
            -S::int(3),
            u4_from_u3_dot_part_10_1
                .mul_add(
                    weight_3,
                    u4_from_u3_dot_part_12_1
                        .mul_add(
                            -S::int(2),
                            u5_from_u3_p2_1
                                .mul_add(S::int(7), S::int(9) * u4_from_u3_p2_1),
                        ),
                ),
        );
    let u4_from_u3_dot_part_19_1 = u4_from_u3_dot_part_18_1
        .mul_add(
            sin_theta3_from_theta1_0,
            sin_theta3_from_theta1_1 * u4_from_u3_dot_part_18_0,
        );
    let u4_from_u3_dot_part_20_1 = r1__part_45_1
        .mul_add(u3_part_12_0, u3_part_12_1 * r1__part_45_0);
    let u4_from_u3_dot_part_21_1 = r1__part_43_1
        .mul_add(u5_from_u3_p2_0, u5_from_u3_p2_1 * r1__part_43_0);
    let u4_from_u3_dot_part_22_1 = S::int(7) * u4_from_u3_p2_1 - u4_from_u3_dot_part_21_1
        - u4_from_u3_dot_part_20_1;
    let u4_from_u3_dot_part_23_1 = u4_from_u3_dot_part_22_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * u4_from_u3_dot_part_22_0,
        );
    let u4_from_u3_dot_part_24_1 = u4_from_u3_dot_part_2_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * u4_from_u3_dot_part_2_0,
        );
    let u4_from_u3_dot_part_25_1 = S::int(3) * u4_from_u3_dot_part_24_1;
    let u4_from_u3_dot_part_26_1 = u5_from_u3_dot_part_8_1
        .mul_add(
            u4_from_u3_dot_part_25_0,
            u4_from_u3_dot_part_25_1 * u5_from_u3_dot_part_8_0,
        );
    let u4_from_u3_dot_part_27_1 = r1__part_23_1
        .mul_add(u3_part_12_0, u3_part_12_1 * r1__part_23_0);
    let u4_from_u3_dot_part_28_1 = r1__part_14_1
        .mul_add(S::int(3), cos_theta3_from_theta1_1);
    let u4_from_u3_dot_part_29_1 = u4_from_u3_dot_part_4_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * u4_from_u3_dot_part_4_0,
        );
    let u4_from_u3_dot_part_30_1 = u4_from_u3_dot_part_6_1
        .mul_add(
            weight_4,
            u4_from_u3_dot_part_27_1
                .mul_add(
                    -S::int(2),
                    r1__part_6_1
                        .mul_add(
                            S::int(2),
                            S::int(2) * u4_from_u3_p2_1 + u5_from_u3_p2_1,
                        ),
                ),
        );
    let u4_from_u3_dot_part_31_1 = u4_from_u3_dot_part_30_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * u4_from_u3_dot_part_30_0,
        );
    let u4_from_u3_dot_part_32_1 = u4_from_u3_dot_part_29_1
        .mul_add(
            S::int(6),
            u4_from_u3_dot_part_7_1.mul_add(-S::int(2), u5_from_u3_p2_1),
        );
    let u4_from_u3_dot_part_33_1 = u4_from_u3_dot_part_32_1
        .mul_add(
            sin_theta3_from_theta1_0,
            sin_theta3_from_theta1_1 * u4_from_u3_dot_part_32_0,
        );
    let u4_from_u3_dot_part_34_1 = u5_from_u3_dot_part_8_1
        .mul_add(
            u4_from_u3_dot_part_28_0,
            u4_from_u3_dot_part_28_1 * u5_from_u3_dot_part_8_0,
        );
    let u4_from_u3_dot_part_35_1 = u4_from_u3_dot_part_31_1
        .mul_add(
            S::int(3),
            u4_from_u3_dot_part_34_1.mul_add(weight_5, -u4_from_u3_dot_part_33_1),
        );
    let u4_from_u3_dot_part_36_1 = u4_from_u3_dot_part_35_1
        .mul_add(
            cos_theta2_from_theta1_0,
            cos_theta2_from_theta1_1 * u4_from_u3_dot_part_35_0,
        );
    let u4_from_u3_dot_part_37_1 = u4_from_u3_dot_part_1
        .mul_add(
            S::int(2),
            u3_part_12_1
                .mul_add(
                    -S::int(15),
                    u5_from_u3_1.mul_add(S::int(12), S::int(14) * u4_from_u3_1),
                ),
        );
    let u4_from_u3_dot_part_38_1 = u4_from_u3_dot_part_37_1
        .mul_add(u3_part_12_0, u3_part_12_1 * u4_from_u3_dot_part_37_0);
    let u4_from_u3_dot_part_39_1 = u4_from_u3_dot_part_6_1
        .mul_add(
            weight_5,
            S::int(7) * u4_from_u3_p2_1 + r1__part_60_1 - u4_from_u3_dot_part_38_1,
        );
    let u4_from_u3_dot_part_40_1 = u4_from_u3_dot_part_39_1
        .mul_add(
            sin_theta2_from_theta1_0,
            sin_theta2_from_theta1_1 * u4_from_u3_dot_part_39_0,
        );
    let u4_from_u3_dot_part_41_1 = u4_from_u3_dot_part_36_1
        .mul_add(
            S::int(3),
            u4_from_u3_dot_part_40_1
                .mul_add(
                    S::int(3),
                    u4_from_u3_dot_part_14_1
                        .mul_add(weight_6, S::int(9) * u4_from_u3_dot_part_5_1),
                ),
        );
    let u4_from_u3_dot_part_42_1 = u4_from_u3_dot_part_41_1
        .mul_add(
            cos_theta3_from_theta1_0,
            cos_theta3_from_theta1_1 * u4_from_u3_dot_part_41_0,
        );
    let u4_from_u3_dot_part_43_1 = u4_from_u3_dot_part_26_1
        .mul_add(weight_2, S::int(3) * u4_from_u3_dot_part_23_1)
        + u4_from_u3_dot_part_19_1 + u4_from_u3_dot_part_42_1;
    let u4_from_u3_dot_part_44_1 = r1__part_12_1
        .mul_add(
            -(u4_from_u3_dot_part_44_0 * over_r1__part_12),
            u4_from_u3_dot_part_43_1 * over_r1__part_12,
        );
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                theta2_from_theta1_1,
                theta2_from_theta1_1,
                theta3_from_theta1_1,
                theta3_from_theta1_1,
                cos_theta2_from_theta1_1,
                sin_theta2_from_theta1_1,
                cos_theta3_from_theta1_1,
                u3_part_4_1,
                u3_part_7_1,
                u3_part_8_1,
                u4_from_u3_1,
                u5_from_u3_1,
                u3_part_12_1,
                cos_theta3_from_theta1_1,
                cos_theta3_from_theta1_1,
                cos_theta2_from_theta1_1,
                cos_theta3_from_theta1_1,
                cos_theta2_from_theta1_1,
                cos_theta2_from_theta1_1,
                cos_theta3_from_theta1_1,
                cos_theta2_from_theta1_1,
                cos_theta3_from_theta1_1,
                cos_theta2_from_theta1_1,
                u3_part_12_1,
                u5_from_u3_1,
                sin_theta2_from_theta1_1,
                cos_theta2_from_theta1_1,
                cos_theta2_from_theta1_1,
                sin_theta3_from_theta1_1,
                cos_theta3_from_theta1_1,
                cos_theta2_from_theta1_1,
                cos_theta2_from_theta1_1,
                sin_theta3_from_theta1_1,
                u5_from_u3_1,
                sin_theta2_from_theta1_1,
                u3_part_12_1,
                cos_theta2_from_theta1_1,
                r1__part_51_1,
                sin_theta3_from_theta1_1,
                cos_theta3_from_theta1_1,
                sin_theta2_from_theta1_1,
                cos_theta2_from_theta1_1,
                r1__part_27_1,
                cos_theta3_from_theta1_1,
                sin_theta2_from_theta1_1,
                sin_theta3_from_theta1_1,
                cos_theta3_from_theta1_1,
                u3_part_12_1,
                u4_from_u3_1,
                sin_theta2_from_theta1_1,
                cos_theta2_from_theta1_1,
                sin_theta3_from_theta1_1,
                cos_theta3_from_theta1_1,
                u4_from_u3_1,
                cos_theta2_from_theta1_1,
                sin_theta3_from_theta1_1,
                sin_theta2_from_theta1_1,
                u3_part_12_1,
                cos_theta2_from_theta1_1,
                cos_theta3_from_theta1_1,
                r1__part_72_1,
                sin_theta2_from_theta1_1,
                cos_theta2_from_theta1_1,
                sin_theta3_from_theta1_1,
                cos_theta3_from_theta1_1,
                r1__part_81_1,
                cos_theta2_from_theta1_1,
                sin_theta3_from_theta1_1,
                sin_theta2_from_theta1_1,
                u3_part_8_1,
                u3_part_8_1,
                r1__part_12_1,
                r1__part_67_1,
                cos_theta2_from_theta1_1,
                cos_theta2_from_theta1_1,
                cos_theta3_from_theta1_1,
                u5_from_u3_dot_part_6_1,
                r1__part_114_1,
                cos_theta3_from_theta1_1,
                u3_part_12_1,
                sin_theta3_from_theta1_1,
                sin_theta3_from_theta1_1,
                u3_part_12_1,
                sin_theta2_from_theta1_1,
                cos_theta2_from_theta1_1,
                u3_part_12_1,
                u5_from_u3_dot_part_8_1,
                u3_part_12_1,
                cos_theta2_from_theta1_1,
                sin_theta3_from_theta1_1,
                u3_part_12_1,
                r1__part_43_1,
                sin_theta2_from_theta1_1,
                cos_theta2_from_theta1_1,
                u5_from_u3_dot_part_8_1,
                u3_part_12_1,
                cos_theta2_from_theta1_1,
                sin_theta2_from_theta1_1,
                sin_theta3_from_theta1_1,
                u5_from_u3_dot_part_8_1,
                cos_theta2_from_theta1_1,
                u3_part_12_1,
                sin_theta2_from_theta1_1,
                cos_theta3_from_theta1_1,
                r1__part_12_1,
            ]),
            padded([
                cos_theta2_from_theta1_1,
                sin_theta2_from_theta1_1,
                cos_theta3_from_theta1_1,
                sin_theta3_from_theta1_1,
                u3_part_1,
                sin_theta3_from_theta1_1,
                u3_part_5_1,
                u4_from_u3_1,
                u5_from_u3_1,
                u3_part_12_1,
                u4_from_u3_1,
                u5_from_u3_1,
                r1__part_1,
                r1__part_4_1,
                r1__part_3_1,
                r1__part_7_1,
                r1__part_9_1,
                u3_part_3_1,
                r1__part_13_1,
                r1__part_15_1,
                r1__part_17_1,
                r1__part_19_1,
                r1__part_23_1,
                r1__part_25_1,
                r1__part_27_1,
                r1__part_29_1,
                r1__part_4_1,
                r1__part_32_1,
                r1__part_34_1,
                r1__part_36_1,
                r1__part_22_1,
                r1__part_39_1,
                r1__part_41_1,
                r1__part_43_1,
                r1__part_45_1,
                r1__part_47_1,
                r1__part_49_1,
                u5_from_u3_p2_1,
                r1__part_53_1,
                r1__part_49_1,
                r1__part_56_1,
                r1__part_58_1,
                u5_from_u3_p2_1,
                r1__part_61_1,
                r1__part_63_1,
                r1__part_65_1,
                r1__part_68_1,
                r1__part_70_1,
                r1__part_72_1,
                r1__part_74_1,
                r1__part_68_1,
                r1__part_77_1,
                r1__part_79_1,
                r1__part_81_1,
                r1__part_83_1,
                r1__part_85_1,
                r1__part_87_1,
                r1__part_89_1,
                r1__part_3_1,
                r1__part_92_1,
                u4_from_u3_p2_1,
                r1__part_95_1,
                r1__part_92_1,
                r1__part_98_1,
                r1__part_100_1,
                u4_from_u3_p2_1,
                r1__part_103_1,
                r1__part_105_1,
                r1__part_107_1,
                r1__part_110_1,
                r1__part_111_1,
                r1__part_112_1,
                r1__part_112_1,
                cos_theta3_from_theta1_1,
                u5_from_u3_dot_part_2_1,
                u5_from_u3_dot_part_4_1,
                u5_from_u3_dot_part_7_1,
                u5_from_u3_dot_part_7_1,
                u3_plus_u5_from_u3_1,
                r1__part_4_1,
                u4_from_u3_dot_part_4_1,
                u5_from_u3_dot_part_8_1,
                u3_plus_u5_from_u3_1,
                u5_from_u3_dot_part_8_1,
                u4_from_u3_dot_part_9_1,
                u4_from_u3_dot_part_8_1,
                u4_from_u3_dot_part_13_1,
                r1__part_39_1,
                u4_from_u3_dot_part_16_1,
                u4_from_u3_dot_part_18_1,
                r1__part_45_1,
                u5_from_u3_p2_1,
                u4_from_u3_dot_part_22_1,
                u4_from_u3_dot_part_2_1,
                u4_from_u3_dot_part_25_1,
                r1__part_23_1,
                u4_from_u3_dot_part_4_1,
                u4_from_u3_dot_part_30_1,
                u4_from_u3_dot_part_32_1,
                u4_from_u3_dot_part_28_1,
                u4_from_u3_dot_part_35_1,
                u4_from_u3_dot_part_37_1,
                u4_from_u3_dot_part_39_1,
                u4_from_u3_dot_part_41_1,
                u4_from_u3_dot_part_44_1,
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
    let mut u3_part_last = u3_part_1;
    let mut u3_part_3_last = u3_part_3_1;
    let mut u3_part_4_last = u3_part_4_1;
    let mut u3_part_5_last = u3_part_5_1;
    let mut u3_part_7_last = u3_part_7_1;
    let mut u3_part_8_last = u3_part_8_1;
    let mut u3_part_12_last = u3_part_12_1;
    let mut u4_from_u3_p2_last = u4_from_u3_p2_1;
    let mut u5_from_u3_p2_last = u5_from_u3_p2_1;
    let mut r1__part_last = r1__part_1;
    let mut r1__part_3_last = r1__part_3_1;
    let mut r1__part_4_last = r1__part_4_1;
    let mut r1__part_7_last = r1__part_7_1;
    let mut r1__part_9_last = r1__part_9_1;
    let mut r1__part_12_last = r1__part_12_1;
    let mut r1__part_13_last = r1__part_13_1;
    let mut r1__part_15_last = r1__part_15_1;
    let mut r1__part_17_last = r1__part_17_1;
    let mut r1__part_19_last = r1__part_19_1;
    let mut r1__part_22_last = r1__part_22_1;
    let mut r1__part_23_last = r1__part_23_1;
    let mut r1__part_25_last = r1__part_25_1;
    let mut r1__part_27_last = r1__part_27_1;
    let mut r1__part_29_last = r1__part_29_1;
    let mut r1__part_32_last = r1__part_32_1;
    let mut r1__part_34_last = r1__part_34_1;
    let mut r1__part_36_last = r1__part_36_1;
    let mut r1__part_39_last = r1__part_39_1;
    let mut r1__part_41_last = r1__part_41_1;
    let mut r1__part_43_last = r1__part_43_1;
    let mut r1__part_45_last = r1__part_45_1;
    let mut r1__part_47_last = r1__part_47_1;
    let mut r1__part_49_last = r1__part_49_1;
    let mut r1__part_51_last = r1__part_51_1;
    let mut r1__part_53_last = r1__part_53_1;
    let mut r1__part_56_last = r1__part_56_1;
    let mut r1__part_58_last = r1__part_58_1;
    let mut r1__part_61_last = r1__part_61_1;
    let mut r1__part_63_last = r1__part_63_1;
    let mut r1__part_65_last = r1__part_65_1;
    let mut r1__part_67_last = r1__part_67_1;
    let mut r1__part_68_last = r1__part_68_1;
    let mut r1__part_70_last = r1__part_70_1;
    let mut r1__part_72_last = r1__part_72_1;
    let mut r1__part_74_last = r1__part_74_1;
    let mut r1__part_77_last = r1__part_77_1;
    let mut r1__part_79_last = r1__part_79_1;
    let mut r1__part_81_last = r1__part_81_1;
    let mut r1__part_83_last = r1__part_83_1;
    let mut r1__part_85_last = r1__part_85_1;
    let mut r1__part_87_last = r1__part_87_1;
    let mut r1__part_89_last = r1__part_89_1;
    let mut r1__part_92_last = r1__part_92_1;
    let mut r1__part_95_last = r1__part_95_1;
    let mut r1__part_98_last = r1__part_98_1;
    let mut r1__part_100_last = r1__part_100_1;
    let mut r1__part_103_last = r1__part_103_1;
    let mut r1__part_105_last = r1__part_105_1;
    let mut r1__part_107_last = r1__part_107_1;
    let mut r1__part_110_last = r1__part_110_1;
    let mut r1__part_111_last = r1__part_111_1;
    let mut r1__part_112_last = r1__part_112_1;
    let mut r1__part_114_last = r1__part_114_1;
    let mut u5_from_u3_dot_part_2_last = u5_from_u3_dot_part_2_1;
    let mut u5_from_u3_dot_part_4_last = u5_from_u3_dot_part_4_1;
    let mut u5_from_u3_dot_part_6_last = u5_from_u3_dot_part_6_1;
    let mut u5_from_u3_dot_part_7_last = u5_from_u3_dot_part_7_1;
    let mut u5_from_u3_dot_part_8_last = u5_from_u3_dot_part_8_1;
    let mut u3_plus_u5_from_u3_last = u3_plus_u5_from_u3_1;
    let mut u4_from_u3_dot_part_2_last = u4_from_u3_dot_part_2_1;
    let mut u4_from_u3_dot_part_4_last = u4_from_u3_dot_part_4_1;
    let mut u4_from_u3_dot_part_8_last = u4_from_u3_dot_part_8_1;
    let mut u4_from_u3_dot_part_9_last = u4_from_u3_dot_part_9_1;
    let mut u4_from_u3_dot_part_13_last = u4_from_u3_dot_part_13_1;
    let mut u4_from_u3_dot_part_16_last = u4_from_u3_dot_part_16_1;
    let mut u4_from_u3_dot_part_18_last = u4_from_u3_dot_part_18_1;
    let mut u4_from_u3_dot_part_22_last = u4_from_u3_dot_part_22_1;
    let mut u4_from_u3_dot_part_25_last = u4_from_u3_dot_part_25_1;
    let mut u4_from_u3_dot_part_28_last = u4_from_u3_dot_part_28_1;
    let mut u4_from_u3_dot_part_30_last = u4_from_u3_dot_part_30_1;
    let mut u4_from_u3_dot_part_32_last = u4_from_u3_dot_part_32_1;
    let mut u4_from_u3_dot_part_35_last = u4_from_u3_dot_part_35_1;
    let mut u4_from_u3_dot_part_37_last = u4_from_u3_dot_part_37_1;
    let mut u4_from_u3_dot_part_39_last = u4_from_u3_dot_part_39_1;
    let mut u4_from_u3_dot_part_41_last = u4_from_u3_dot_part_41_1;
    let mut u4_from_u3_dot_part_44_last = u4_from_u3_dot_part_44_1;
    let mut next = [S::int(0); 112];
    // Rates at order k - 1.
    let mut theta2_from_theta1_rate = u4_from_u3_1;
    let mut theta3_from_theta1_rate = u5_from_u3_1;
    let mut theta1_rate = -u3_part_12_1;
    let mut u4_from_u3_rate = -u4_from_u3_dot_part_44_1;
    let mut u5_from_u3_rate = weight_5 * u5_from_u3_dot_part_8_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let theta2_from_theta1 = theta2_from_theta1_rate * over_k;
        let theta3_from_theta1 = theta3_from_theta1_rate * over_k;
        let theta1 = theta1_rate * over_k;
        let u4_from_u3 = u4_from_u3_rate * over_k;
        let u5_from_u3 = u5_from_u3_rate * over_k;
        series[order] = [
            theta2_from_theta1,
            theta3_from_theta1,
            theta1,
            u4_from_u3,
            u5_from_u3,
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
                        u3_part_last,
                        cos_theta2_from_theta1_last.mul_add(u3_part_1, next[4]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        sin_theta3_from_theta1_last,
                        sin_theta2_from_theta1_last
                            .mul_add(sin_theta3_from_theta1_1, next[5]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        u3_part_5_last,
                        cos_theta3_from_theta1_last.mul_add(u3_part_5_1, next[6]),
                    ),
                u3_part_4_1
                    .mul_add(
                        u4_from_u3_last,
                        u3_part_4_last.mul_add(u4_from_u3_1, next[7]),
                    ),
                u3_part_7_1
                    .mul_add(
                        u5_from_u3_last,
                        u3_part_7_last.mul_add(u5_from_u3_1, next[8]),
                    ),
                u3_part_8_1
                    .mul_add(
                        u3_part_12_last,
                        u3_part_8_last.mul_add(u3_part_12_1, next[9]),
                    ),
                (u4_from_u3_1 + u4_from_u3_1).mul_add(u4_from_u3_last, next[10]),
                (u5_from_u3_1 + u5_from_u3_1).mul_add(u5_from_u3_last, next[11]),
                u3_part_12_1
                    .mul_add(
                        r1__part_last,
                        u3_part_12_last.mul_add(r1__part_1, next[12]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_4_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_4_1, next[13]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_3_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_3_1, next[14]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_7_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_7_1, next[15]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_9_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_9_1, next[16]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        u3_part_3_last,
                        cos_theta2_from_theta1_last.mul_add(u3_part_3_1, next[17]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_13_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_13_1, next[18]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_15_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_15_1, next[19]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_17_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_17_1, next[20]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_19_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_19_1, next[21]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_23_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_23_1, next[22]),
                    ),
                u3_part_12_1
                    .mul_add(
                        r1__part_25_last,
                        u3_part_12_last.mul_add(r1__part_25_1, next[23]),
                    ),
                u5_from_u3_1
                    .mul_add(
                        r1__part_27_last,
                        u5_from_u3_last.mul_add(r1__part_27_1, next[24]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__part_29_last,
                        sin_theta2_from_theta1_last.mul_add(r1__part_29_1, next[25]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_4_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_4_1, next[26]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_32_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_32_1, next[27]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__part_34_last,
                        sin_theta3_from_theta1_last.mul_add(r1__part_34_1, next[28]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_36_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_36_1, next[29]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_22_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_22_1, next[30]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_39_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_39_1, next[31]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__part_41_last,
                        sin_theta3_from_theta1_last.mul_add(r1__part_41_1, next[32]),
                    ),
                u5_from_u3_1
                    .mul_add(
                        r1__part_43_last,
                        u5_from_u3_last.mul_add(r1__part_43_1, next[33]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__part_45_last,
                        sin_theta2_from_theta1_last.mul_add(r1__part_45_1, next[34]),
                    ),
                u3_part_12_1
                    .mul_add(
                        r1__part_47_last,
                        u3_part_12_last.mul_add(r1__part_47_1, next[35]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_49_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_49_1, next[36]),
                    ),
                r1__part_51_1
                    .mul_add(
                        u5_from_u3_p2_last,
                        r1__part_51_last.mul_add(u5_from_u3_p2_1, next[37]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__part_53_last,
                        sin_theta3_from_theta1_last.mul_add(r1__part_53_1, next[38]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_49_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_49_1, next[39]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__part_56_last,
                        sin_theta2_from_theta1_last.mul_add(r1__part_56_1, next[40]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_58_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_58_1, next[41]),
                    ),
                r1__part_27_1
                    .mul_add(
                        u5_from_u3_p2_last,
                        r1__part_27_last.mul_add(u5_from_u3_p2_1, next[42]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_61_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_61_1, next[43]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__part_63_last,
                        sin_theta2_from_theta1_last.mul_add(r1__part_63_1, next[44]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__part_65_last,
                        sin_theta3_from_theta1_last.mul_add(r1__part_65_1, next[45]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_68_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_68_1, next[46]),
                    ),
                u3_part_12_1
                    .mul_add(
                        r1__part_70_last,
                        u3_part_12_last.mul_add(r1__part_70_1, next[47]),
                    ),
                u4_from_u3_1
                    .mul_add(
                        r1__part_72_last,
                        u4_from_u3_last.mul_add(r1__part_72_1, next[48]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__part_74_last,
                        sin_theta2_from_theta1_last.mul_add(r1__part_74_1, next[49]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_68_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_68_1, next[50]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__part_77_last,
                        sin_theta3_from_theta1_last.mul_add(r1__part_77_1, next[51]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_79_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_79_1, next[52]),
                    ),
                u4_from_u3_1
                    .mul_add(
                        r1__part_81_last,
                        u4_from_u3_last.mul_add(r1__part_81_1, next[53]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_83_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_83_1, next[54]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__part_85_last,
                        sin_theta3_from_theta1_last.mul_add(r1__part_85_1, next[55]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__part_87_last,
                        sin_theta2_from_theta1_last.mul_add(r1__part_87_1, next[56]),
                    ),
                u3_part_12_1
                    .mul_add(
                        r1__part_89_last,
                        u3_part_12_last.mul_add(r1__part_89_1, next[57]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_3_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_3_1, next[58]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_92_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_92_1, next[59]),
                    ),
                r1__part_72_1
                    .mul_add(
                        u4_from_u3_p2_last,
                        r1__part_72_last.mul_add(u4_from_u3_p2_1, next[60]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__part_95_last,
                        sin_theta2_from_theta1_last.mul_add(r1__part_95_1, next[61]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_92_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_92_1, next[62]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__part_98_last,
                        sin_theta3_from_theta1_last.mul_add(r1__part_98_1, next[63]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_100_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_100_1, next[64]),
                    ),
                r1__part_81_1
                    .mul_add(
                        u4_from_u3_p2_last,
                        r1__part_81_last.mul_add(u4_from_u3_p2_1, next[65]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_103_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_103_1, next[66]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__part_105_last,
                        sin_theta3_from_theta1_last.mul_add(r1__part_105_1, next[67]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__part_107_last,
                        sin_theta2_from_theta1_last.mul_add(r1__part_107_1, next[68]),
                    ),
                u3_part_8_1
                    .mul_add(
                        r1__part_110_last,
                        u3_part_8_last.mul_add(r1__part_110_1, next[69]),
                    ),
                u3_part_8_1
                    .mul_add(
                        r1__part_111_last,
                        u3_part_8_last.mul_add(r1__part_111_1, next[70]),
                    ),
                r1__part_12_1
                    .mul_add(
                        r1__part_112_last,
                        r1__part_12_last.mul_add(r1__part_112_1, next[71]),
                    ),
                r1__part_67_1
                    .mul_add(
                        r1__part_112_last,
                        r1__part_67_last.mul_add(r1__part_112_1, next[72]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        cos_theta3_from_theta1_last,
                        cos_theta2_from_theta1_last
                            .mul_add(cos_theta3_from_theta1_1, next[73]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        u5_from_u3_dot_part_2_last,
                        cos_theta2_from_theta1_last
                            .mul_add(u5_from_u3_dot_part_2_1, next[74]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        u5_from_u3_dot_part_4_last,
                        cos_theta3_from_theta1_last
                            .mul_add(u5_from_u3_dot_part_4_1, next[75]),
                    ),
                u5_from_u3_dot_part_6_1
                    .mul_add(
                        u5_from_u3_dot_part_7_last,
                        u5_from_u3_dot_part_6_last
                            .mul_add(u5_from_u3_dot_part_7_1, next[76]),
                    ),
                r1__part_114_1
                    .mul_add(
                        u5_from_u3_dot_part_7_last,
                        r1__part_114_last.mul_add(u5_from_u3_dot_part_7_1, next[77]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        u3_plus_u5_from_u3_last,
                        cos_theta3_from_theta1_last
                            .mul_add(u3_plus_u5_from_u3_1, next[78]),
                    ),
                u3_part_12_1
                    .mul_add(
                        r1__part_4_last,
                        u3_part_12_last.mul_add(r1__part_4_1, next[79]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_part_4_last,
                        sin_theta3_from_theta1_last
                            .mul_add(u4_from_u3_dot_part_4_1, next[80]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        u5_from_u3_dot_part_8_last,
                        sin_theta3_from_theta1_last
                            .mul_add(u5_from_u3_dot_part_8_1, next[81]),
                    ),
                u3_part_12_1
                    .mul_add(
                        u3_plus_u5_from_u3_last,
                        u3_part_12_last.mul_add(u3_plus_u5_from_u3_1, next[82]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        u5_from_u3_dot_part_8_last,
                        sin_theta2_from_theta1_last
                            .mul_add(u5_from_u3_dot_part_8_1, next[83]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_part_9_last,
                        cos_theta2_from_theta1_last
                            .mul_add(u4_from_u3_dot_part_9_1, next[84]),
                    ),
                u3_part_12_1
                    .mul_add(
                        u4_from_u3_dot_part_8_last,
                        u3_part_12_last.mul_add(u4_from_u3_dot_part_8_1, next[85]),
                    ),
                u5_from_u3_dot_part_8_1
                    .mul_add(
                        u4_from_u3_dot_part_13_last,
                        u5_from_u3_dot_part_8_last
                            .mul_add(u4_from_u3_dot_part_13_1, next[86]),
                    ),
                u3_part_12_1
                    .mul_add(
                        r1__part_39_last,
                        u3_part_12_last.mul_add(r1__part_39_1, next[87]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_part_16_last,
                        cos_theta2_from_theta1_last
                            .mul_add(u4_from_u3_dot_part_16_1, next[88]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_part_18_last,
                        sin_theta3_from_theta1_last
                            .mul_add(u4_from_u3_dot_part_18_1, next[89]),
                    ),
                u3_part_12_1
                    .mul_add(
                        r1__part_45_last,
                        u3_part_12_last.mul_add(r1__part_45_1, next[90]),
                    ),
                r1__part_43_1
                    .mul_add(
                        u5_from_u3_p2_last,
                        r1__part_43_last.mul_add(u5_from_u3_p2_1, next[91]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_part_22_last,
                        sin_theta2_from_theta1_last
                            .mul_add(u4_from_u3_dot_part_22_1, next[92]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_part_2_last,
                        cos_theta2_from_theta1_last
                            .mul_add(u4_from_u3_dot_part_2_1, next[93]),
                    ),
                u5_from_u3_dot_part_8_1
                    .mul_add(
                        u4_from_u3_dot_part_25_last,
                        u5_from_u3_dot_part_8_last
                            .mul_add(u4_from_u3_dot_part_25_1, next[94]),
                    ),
                u3_part_12_1
                    .mul_add(
                        r1__part_23_last,
                        u3_part_12_last.mul_add(r1__part_23_1, next[95]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_part_4_last,
                        cos_theta2_from_theta1_last
                            .mul_add(u4_from_u3_dot_part_4_1, next[96]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_part_30_last,
                        sin_theta2_from_theta1_last
                            .mul_add(u4_from_u3_dot_part_30_1, next[97]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_part_32_last,
                        sin_theta3_from_theta1_last
                            .mul_add(u4_from_u3_dot_part_32_1, next[98]),
                    ),
                u5_from_u3_dot_part_8_1
                    .mul_add(
                        u4_from_u3_dot_part_28_last,
                        u5_from_u3_dot_part_8_last
                            .mul_add(u4_from_u3_dot_part_28_1, next[99]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_part_35_last,
                        cos_theta2_from_theta1_last
                            .mul_add(u4_from_u3_dot_part_35_1, next[100]),
                    ),
                u3_part_12_1
                    .mul_add(
                        u4_from_u3_dot_part_37_last,
                        u3_part_12_last.mul_add(u4_from_u3_dot_part_37_1, next[101]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_part_39_last,
                        sin_theta2_from_theta1_last
                            .mul_add(u4_from_u3_dot_part_39_1, next[102]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        u4_from_u3_dot_part_41_last,
                        cos_theta3_from_theta1_last
                            .mul_add(u4_from_u3_dot_part_41_1, next[103]),
                    ),
                r1__part_12_1
                    .mul_add(
                        u4_from_u3_dot_part_44_last,
                        r1__part_12_last.mul_add(u4_from_u3_dot_part_44_1, next[104]),
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
        // u3_part = 1 + cos_theta3_from_theta1
        let u3_part = cos_theta3_from_theta1;
        // u3_part_2 = cos_theta2_from_theta1*u3_part
        let u3_part_2 = u3_part
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u3_part_0, sums[4]),
            );
        // u3_part_3 = sin_theta2_from_theta1*sin_theta3_from_theta1
        let u3_part_3 = sin_theta3_from_theta1
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(sin_theta3_from_theta1_0, sums[5]),
            );
        // u3_part_4 = 7 + 3*u3_part_2 + 3*u3_part_3
        let u3_part_4 = u3_part_2.mul_add(S::int(3), S::int(3) * u3_part_3);
        // u3_part_5 = 1 + 3*cos_theta2_from_theta1
        let u3_part_5 = S::int(3) * cos_theta2_from_theta1;
        // u3_part_6 = cos_theta3_from_theta1*u3_part_5
        let u3_part_6 = u3_part_5
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(u3_part_5_0, sums[6]),
            );
        // u3_part_7 = 3 + 3*u3_part_3 + u3_part_6
        let u3_part_7 = S::int(3) * u3_part_3 + u3_part_6;
        // u3_part_8 = 13 + 2*cos_theta3_from_theta1 + 6*u3_part_2 + 6*u3_part_3
        let u3_part_8 = u3_part_2
            .mul_add(
                S::int(6),
                u3_part_3.mul_add(S::int(6), S::int(2) * cos_theta3_from_theta1),
            );
        // u3_part_9 = u3_part_4*u4_from_u3
        let u3_part_9 = u3_part_4
            .mul_add(u4_from_u3_0, u4_from_u3.mul_add(u3_part_4_0, sums[7]));
        // u3_part_10 = u3_part_7*u5_from_u3
        let u3_part_10 = u3_part_7
            .mul_add(u5_from_u3_0, u5_from_u3.mul_add(u3_part_7_0, sums[8]));
        // u3_part_11 = weight + u3_part_9 + u3_part_10
        let u3_part_11 = u3_part_9 + u3_part_10;
        // u3_part_12 = u3_part_11/u3_part_8
        let u3_part_12 = u3_part_11
            .mul_add(
                over_u3_part_8,
                -(u3_part_8.mul_add(u3_part_12_0, sums[9]) * over_u3_part_8),
            );
        // u4_from_u3_p2 = u4_from_u3*u4_from_u3
        let u4_from_u3_p2 = u4_from_u3.mul_add(u4_from_u3_0 + u4_from_u3_0, sums[10]);
        // u5_from_u3_p2 = u5_from_u3*u5_from_u3
        let u5_from_u3_p2 = u5_from_u3.mul_add(u5_from_u3_0 + u5_from_u3_0, sums[11]);
        // r1__part = 5 + 2*cos_theta2_from_theta1
        let r1__part = S::int(2) * cos_theta2_from_theta1;
        // r1__part_2 = u3_part_12*r1__part
        let r1__part_2 = u3_part_12
            .mul_add(r1__part_0, r1__part.mul_add(u3_part_12_0, sums[12]));
        // r1__part_3 = u4_from_u3_p2 + u5_from_u3_p2
        let r1__part_3 = u4_from_u3_p2 + u5_from_u3_p2;
        // r1__part_4 = -u3_part_12 + u4_from_u3 + u5_from_u3
        let r1__part_4 = u4_from_u3 + u5_from_u3 - u3_part_12;
        // r1__part_5 = cos_theta3_from_theta1*r1__part_4
        let r1__part_5 = r1__part_4
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_4_0, sums[13]),
            );
        // r1__part_6 = cos_theta3_from_theta1*r1__part_3
        let r1__part_6 = r1__part_3
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_3_0, sums[14]),
            );
        // r1__part_7 = u3_part_2 + u3_part_3
        let r1__part_7 = u3_part_3 + u3_part_2;
        // r1__part_8 = cos_theta2_from_theta1*r1__part_7
        let r1__part_8 = r1__part_7
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_7_0, sums[15]),
            );
        // r1__part_9 = 14 + 9*cos_theta3_from_theta1 - 18*r1__part_8
        let r1__part_9 = r1__part_8
            .mul_add(-S::int(18), S::int(9) * cos_theta3_from_theta1);
        // r1__part_10 = cos_theta3_from_theta1*r1__part_9
        let r1__part_10 = r1__part_9
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_9_0, sums[16]),
            );
        // r1__part_11 = cos_theta2_from_theta1*u3_part_3
        let r1__part_11 = u3_part_3
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u3_part_3_0, sums[17]),
            );
        // r1__part_12 = 33 + r1__part_10 - 18*r1__part_11
        let r1__part_12 = -S::int(18) * r1__part_11 + r1__part_10;
        // r1__part_13 = 1 + 2*cos_theta3_from_theta1
        let r1__part_13 = S::int(2) * cos_theta3_from_theta1;
        // r1__part_14 = cos_theta2_from_theta1*r1__part_13
        let r1__part_14 = r1__part_13
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_13_0, sums[18]),
            );
        // r1__part_15 = 2 + cos_theta3_from_theta1 + 6*u3_part_3 + 3*r1__part_14
        let r1__part_15 = r1__part_14
            .mul_add(S::int(3), u3_part_3.mul_add(S::int(6), cos_theta3_from_theta1));
        // r1__part_16 = cos_theta3_from_theta1*r1__part_15
        let r1__part_16 = r1__part_15
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_15_0, sums[19]),
            );
        // r1__part_17 = 3 + 3*cos_theta2_from_theta1 - 3*u3_part_3 - r1__part_16
        let r1__part_17 = u3_part_3
            .mul_add(-S::int(3), S::int(3) * cos_theta2_from_theta1) - r1__part_16;
        // r1__part_18 = cos_theta2_from_theta1*r1__part_17
        let r1__part_18 = r1__part_17
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_17_0, sums[20]),
            );
        // r1__part_19 = 7 + 9*cos_theta3_from_theta1 - 3*u3_part_3
        let r1__part_19 = u3_part_3
            .mul_add(-S::int(3), S::int(9) * cos_theta3_from_theta1);
        // r1__part_20 = cos_theta3_from_theta1*r1__part_19
        let r1__part_20 = r1__part_19
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_19_0, sums[21]),
            );
        // r1__part_21 = -12 + 9*u3_part_3 - 3*r1__part_18 - r1__part_20
        let r1__part_21 = r1__part_18
            .mul_add(-S::int(3), S::int(9) * u3_part_3 - r1__part_20);
        // r1__part_22 = -2*u3_part_12 + 2*u4_from_u3 + u5_from_u3
        let r1__part_22 = u3_part_12
            .mul_add(-S::int(2), S::int(2) * u4_from_u3 + u5_from_u3);
        // r1__part_23 = -2*u3_part_12 + 2*u4_from_u3 + u5_from_u3 + 2*r1__part_5
        let r1__part_23 = r1__part_5
            .mul_add(
                S::int(2),
                u3_part_12.mul_add(-S::int(2), S::int(2) * u4_from_u3 + u5_from_u3),
            );
        // r1__part_24 = cos_theta2_from_theta1*r1__part_23
        let r1__part_24 = r1__part_23
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_23_0, sums[22]),
            );
        // r1__part_25 = 15 + 2*cos_theta3_from_theta1
        let r1__part_25 = S::int(2) * cos_theta3_from_theta1;
        // r1__part_26 = u3_part_12*r1__part_25
        let r1__part_26 = u3_part_12
            .mul_add(r1__part_25_0, r1__part_25.mul_add(u3_part_12_0, sums[23]));
        // r1__part_27 = 6 + cos_theta3_from_theta1
        let r1__part_27 = cos_theta3_from_theta1;
        // r1__part_28 = u5_from_u3*r1__part_27
        let r1__part_28 = r1__part_27
            .mul_add(u5_from_u3_0, u5_from_u3.mul_add(r1__part_27_0, sums[24]));
        // r1__part_29 = 14*u4_from_u3 + 6*r1__part_24 - r1__part_26 + 2*r1__part_28
        let r1__part_29 = r1__part_24
            .mul_add(
                S::int(6),
                r1__part_28.mul_add(S::int(2), S::int(14) * u4_from_u3) - r1__part_26,
            );
        // r1__part_30 = sin_theta2_from_theta1*r1__part_29
        let r1__part_30 = r1__part_29
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__part_29_0, sums[25]),
            );
        // r1__part_31 = cos_theta2_from_theta1*r1__part_4
        let r1__part_31 = r1__part_4
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_4_0, sums[26]),
            );
        // r1__part_32 = -u3_part_12 + u5_from_u3 + 6*r1__part_31
        let r1__part_32 = r1__part_31.mul_add(S::int(6), u5_from_u3 - u3_part_12);
        // r1__part_33 = cos_theta2_from_theta1*r1__part_32
        let r1__part_33 = r1__part_32
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_32_0, sums[27]),
            );
        // r1__part_34 = -3*u3_part_12 + 3*u4_from_u3 + 3*u5_from_u3 - r1__part_33
        let r1__part_34 = u3_part_12
            .mul_add(-S::int(3), u5_from_u3.mul_add(S::int(3), S::int(3) * u4_from_u3))
            - r1__part_33;
        // r1__part_35 = sin_theta3_from_theta1*r1__part_34
        let r1__part_35 = r1__part_34
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__part_34_0, sums[28]),
            );
        // r1__part_36 = r1__part_30 + 2*r1__part_35
        let r1__part_36 = r1__part_35.mul_add(S::int(2), r1__part_30);
        // r1__part_37 = cos_theta3_from_theta1*r1__part_36
        let r1__part_37 = r1__part_36
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_36_0, sums[29]),
            );
        // r1__part_38 = cos_theta2_from_theta1*r1__part_22
        let r1__part_38 = r1__part_22
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_22_0, sums[30]),
            );
        // r1__part_39 = -13*u3_part_12 + 14*u4_from_u3 + 10*u5_from_u3 + 6*r1__part_38
        let r1__part_39 = r1__part_38
            .mul_add(
                S::int(6),
                u3_part_12
                    .mul_add(
                        -S::int(13),
                        u5_from_u3.mul_add(S::int(10), S::int(14) * u4_from_u3),
                    ),
            );
        // r1__part_40 = cos_theta2_from_theta1*r1__part_39
        let r1__part_40 = r1__part_39
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_39_0, sums[31]),
            );
        // r1__part_41 = -18*u3_part_12 + 18*u4_from_u3 + 14*u5_from_u3 - 3*r1__part_40
        let r1__part_41 = r1__part_40
            .mul_add(
                -S::int(3),
                u3_part_12
                    .mul_add(
                        -S::int(18),
                        u5_from_u3.mul_add(S::int(14), S::int(18) * u4_from_u3),
                    ),
            );
        // r1__part_42 = sin_theta3_from_theta1*r1__part_41
        let r1__part_42 = r1__part_41
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__part_41_0, sums[32]),
            );
        // r1__part_43 = -1 + 3*cos_theta2_from_theta1
        let r1__part_43 = S::int(3) * cos_theta2_from_theta1;
        // r1__part_44 = u5_from_u3*r1__part_43
        let r1__part_44 = r1__part_43
            .mul_add(u5_from_u3_0, u5_from_u3.mul_add(r1__part_43_0, sums[33]));
        // r1__part_45 = -13*u3_part_12 + 14*u4_from_u3 - 2*r1__part_44
        let r1__part_45 = u3_part_12
            .mul_add(
                -S::int(13),
                r1__part_44.mul_add(-S::int(2), S::int(14) * u4_from_u3),
            );
        // r1__part_46 = sin_theta2_from_theta1*r1__part_45
        let r1__part_46 = r1__part_45
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__part_45_0, sums[34]),
            );
        // r1__part_47 = 3*r1__part_37 + r1__part_42 + 3*r1__part_46
        let r1__part_47 = r1__part_37
            .mul_add(S::int(3), S::int(3) * r1__part_46 + r1__part_42);
        // r1__part_48 = u3_part_12*r1__part_47
        let r1__part_48 = r1__part_47
            .mul_add(u3_part_12_0, u3_part_12.mul_add(r1__part_47_0, sums[35]));
        // r1__part_49 = 2*u4_from_u3_p2 + u5_from_u3_p2 + 2*r1__part_6
        let r1__part_49 = r1__part_6
            .mul_add(S::int(2), S::int(2) * u4_from_u3_p2 + u5_from_u3_p2);
        // r1__part_50 = cos_theta2_from_theta1*r1__part_49
        let r1__part_50 = r1__part_49
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_49_0, sums[36]),
            );
        // r1__part_51 = 5 + cos_theta3_from_theta1
        let r1__part_51 = cos_theta3_from_theta1;
        // r1__part_52 = r1__part_51*u5_from_u3_p2
        let r1__part_52 = r1__part_51
            .mul_add(u5_from_u3_p2_0, u5_from_u3_p2.mul_add(r1__part_51_0, sums[37]));
        // r1__part_53 = 7*u4_from_u3_p2 + 3*r1__part_50 + r1__part_52
        let r1__part_53 = r1__part_50
            .mul_add(S::int(3), S::int(7) * u4_from_u3_p2 + r1__part_52);
        // r1__part_54 = sin_theta3_from_theta1*r1__part_53
        let r1__part_54 = r1__part_53
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__part_53_0, sums[38]),
            );
        // r1__part_55 = cos_theta3_from_theta1*r1__part_49
        let r1__part_55 = r1__part_49
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_49_0, sums[39]),
            );
        // r1__part_56 = u5_from_u3_p2 - r1__part_55
        let r1__part_56 = u5_from_u3_p2 - r1__part_55;
        // r1__part_57 = sin_theta2_from_theta1*r1__part_56
        let r1__part_57 = r1__part_56
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__part_56_0, sums[40]),
            );
        // r1__part_58 = r1__part_54 + 3*r1__part_57
        let r1__part_58 = r1__part_57.mul_add(S::int(3), r1__part_54);
        // r1__part_59 = cos_theta2_from_theta1*r1__part_58
        let r1__part_59 = r1__part_58
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_58_0, sums[41]),
            );
        // r1__part_60 = r1__part_27*u5_from_u3_p2
        let r1__part_60 = r1__part_27
            .mul_add(u5_from_u3_p2_0, u5_from_u3_p2.mul_add(r1__part_27_0, sums[42]));
        // r1__part_61 = 7*u4_from_u3_p2 + r1__part_60
        let r1__part_61 = S::int(7) * u4_from_u3_p2 + r1__part_60;
        // r1__part_62 = cos_theta3_from_theta1*r1__part_61
        let r1__part_62 = r1__part_61
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_61_0, sums[43]),
            );
        // r1__part_63 = 7*u4_from_u3_p2 + u5_from_u3_p2 + r1__part_62
        let r1__part_63 = S::int(7) * u4_from_u3_p2 + u5_from_u3_p2 + r1__part_62;
        // r1__part_64 = sin_theta2_from_theta1*r1__part_63
        let r1__part_64 = r1__part_63
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__part_63_0, sums[44]),
            );
        // r1__part_65 = 9*u4_from_u3_p2 + 7*u5_from_u3_p2 + 9*r1__part_6
        let r1__part_65 = r1__part_6
            .mul_add(
                S::int(9),
                u5_from_u3_p2.mul_add(S::int(7), S::int(9) * u4_from_u3_p2),
            );
        // r1__part_66 = sin_theta3_from_theta1*r1__part_65
        let r1__part_66 = r1__part_65
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__part_65_0, sums[45]),
            );
        // r1__part_67 = -r1__part_48 - 3*r1__part_59 + 3*r1__part_64 + r1__part_66
        let r1__part_67 = r1__part_59
            .mul_add(-S::int(3), r1__part_64.mul_add(S::int(3), r1__part_66))
            - r1__part_48;
        // r1__part_68 = -2*u3_part_12 + u4_from_u3 + 2*u5_from_u3 + 6*r1__part_31
        let r1__part_68 = r1__part_31
            .mul_add(
                S::int(6),
                u3_part_12.mul_add(-S::int(2), u5_from_u3.mul_add(S::int(2), u4_from_u3)),
            );
        // r1__part_69 = cos_theta3_from_theta1*r1__part_68
        let r1__part_69 = r1__part_68
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_68_0, sums[46]),
            );
        // r1__part_70 = 13 + 6*cos_theta2_from_theta1
        let r1__part_70 = S::int(6) * cos_theta2_from_theta1;
        // r1__part_71 = u3_part_12*r1__part_70
        let r1__part_71 = u3_part_12
            .mul_add(r1__part_70_0, r1__part_70.mul_add(u3_part_12_0, sums[47]));
        // r1__part_72 = 3 + cos_theta2_from_theta1
        let r1__part_72 = cos_theta2_from_theta1;
        // r1__part_73 = u4_from_u3*r1__part_72
        let r1__part_73 = r1__part_72
            .mul_add(u4_from_u3_0, u4_from_u3.mul_add(r1__part_72_0, sums[48]));
        // r1__part_74 = 6*u5_from_u3 + 2*r1__part_69 - r1__part_71 + 6*r1__part_73
        let r1__part_74 = r1__part_69
            .mul_add(
                S::int(2),
                r1__part_73.mul_add(S::int(6), S::int(6) * u5_from_u3) - r1__part_71,
            );
        // r1__part_75 = sin_theta2_from_theta1*r1__part_74
        let r1__part_75 = r1__part_74
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__part_74_0, sums[49]),
            );
        // r1__part_76 = cos_theta2_from_theta1*r1__part_68
        let r1__part_76 = r1__part_68
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_68_0, sums[50]),
            );
        // r1__part_77 = -8*u3_part_12 + 9*u4_from_u3 + 8*u5_from_u3 - 3*r1__part_76
        let r1__part_77 = r1__part_76
            .mul_add(
                -S::int(3),
                u3_part_12
                    .mul_add(
                        -S::int(8),
                        u5_from_u3.mul_add(S::int(8), S::int(9) * u4_from_u3),
                    ),
            );
        // r1__part_78 = sin_theta3_from_theta1*r1__part_77
        let r1__part_78 = r1__part_77
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__part_77_0, sums[51]),
            );
        // r1__part_79 = 3*r1__part_75 + 2*r1__part_78
        let r1__part_79 = r1__part_78.mul_add(S::int(2), S::int(3) * r1__part_75);
        // r1__part_80 = cos_theta3_from_theta1*r1__part_79
        let r1__part_80 = r1__part_79
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_79_0, sums[52]),
            );
        // r1__part_81 = 10 + 3*cos_theta2_from_theta1
        let r1__part_81 = S::int(3) * cos_theta2_from_theta1;
        // r1__part_82 = u4_from_u3*r1__part_81
        let r1__part_82 = r1__part_81
            .mul_add(u4_from_u3_0, u4_from_u3.mul_add(r1__part_81_0, sums[53]));
        // r1__part_83 = 6*u5_from_u3 - 3*r1__part_2 + 2*r1__part_82
        let r1__part_83 = r1__part_2
            .mul_add(-S::int(3), r1__part_82.mul_add(S::int(2), S::int(6) * u5_from_u3));
        // r1__part_84 = cos_theta2_from_theta1*r1__part_83
        let r1__part_84 = r1__part_83
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_83_0, sums[54]),
            );
        // r1__part_85 = -13*u3_part_12 + 18*u4_from_u3 + 6*u5_from_u3 + 3*r1__part_84
        let r1__part_85 = r1__part_84
            .mul_add(
                S::int(3),
                u3_part_12
                    .mul_add(
                        -S::int(13),
                        u5_from_u3.mul_add(S::int(6), S::int(18) * u4_from_u3),
                    ),
            );
        // r1__part_86 = sin_theta3_from_theta1*r1__part_85
        let r1__part_86 = r1__part_85
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__part_85_0, sums[55]),
            );
        // r1__part_87 = -u3_part_12 + 3*u4_from_u3 + u5_from_u3 + 3*r1__part_31
        let r1__part_87 = r1__part_31
            .mul_add(S::int(3), S::int(3) * u4_from_u3 + u5_from_u3 - u3_part_12);
        // r1__part_88 = sin_theta2_from_theta1*r1__part_87
        let r1__part_88 = r1__part_87
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__part_87_0, sums[56]),
            );
        // r1__part_89 = r1__part_80 - r1__part_86 - 6*r1__part_88
        let r1__part_89 = -S::int(6) * r1__part_88 - r1__part_86 + r1__part_80;
        // r1__part_90 = u3_part_12*r1__part_89
        let r1__part_90 = r1__part_89
            .mul_add(u3_part_12_0, u3_part_12.mul_add(r1__part_89_0, sums[57]));
        // r1__part_91 = cos_theta2_from_theta1*r1__part_3
        let r1__part_91 = r1__part_3
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_3_0, sums[58]),
            );
        // r1__part_92 = u4_from_u3_p2 + 2*u5_from_u3_p2 + 6*r1__part_91
        let r1__part_92 = r1__part_91
            .mul_add(S::int(6), u5_from_u3_p2.mul_add(S::int(2), u4_from_u3_p2));
        // r1__part_93 = cos_theta3_from_theta1*r1__part_92
        let r1__part_93 = r1__part_92
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_92_0, sums[59]),
            );
        // r1__part_94 = r1__part_72*u4_from_u3_p2
        let r1__part_94 = r1__part_72
            .mul_add(u4_from_u3_p2_0, u4_from_u3_p2.mul_add(r1__part_72_0, sums[60]));
        // r1__part_95 = 3*u5_from_u3_p2 + r1__part_93 + 3*r1__part_94
        let r1__part_95 = r1__part_94.mul_add(S::int(3), S::int(3) * u5_from_u3_p2)
            + r1__part_93;
        // r1__part_96 = sin_theta2_from_theta1*r1__part_95
        let r1__part_96 = r1__part_95
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__part_95_0, sums[61]),
            );
        // r1__part_97 = cos_theta2_from_theta1*r1__part_92
        let r1__part_97 = r1__part_92
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_92_0, sums[62]),
            );
        // r1__part_98 = 9*u4_from_u3_p2 + 8*u5_from_u3_p2 - 3*r1__part_97
        let r1__part_98 = r1__part_97
            .mul_add(
                -S::int(3),
                u5_from_u3_p2.mul_add(S::int(8), S::int(9) * u4_from_u3_p2),
            );
        // r1__part_99 = sin_theta3_from_theta1*r1__part_98
        let r1__part_99 = r1__part_98
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__part_98_0, sums[63]),
            );
        // r1__part_100 = 3*r1__part_96 + r1__part_99
        let r1__part_100 = S::int(3) * r1__part_96 + r1__part_99;
        // r1__part_101 = cos_theta3_from_theta1*r1__part_100
        let r1__part_101 = r1__part_100
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_100_0, sums[64]),
            );
        // r1__part_102 = r1__part_81*u4_from_u3_p2
        let r1__part_102 = r1__part_81
            .mul_add(u4_from_u3_p2_0, u4_from_u3_p2.mul_add(r1__part_81_0, sums[65]));
        // r1__part_103 = 3*u5_from_u3_p2 + r1__part_102
        let r1__part_103 = S::int(3) * u5_from_u3_p2 + r1__part_102;
        // r1__part_104 = cos_theta2_from_theta1*r1__part_103
        let r1__part_104 = r1__part_103
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_103_0, sums[66]),
            );
        // r1__part_105 = 3*u4_from_u3_p2 + u5_from_u3_p2 + r1__part_104
        let r1__part_105 = S::int(3) * u4_from_u3_p2 + u5_from_u3_p2 + r1__part_104;
        // r1__part_106 = sin_theta3_from_theta1*r1__part_105
        let r1__part_106 = r1__part_105
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__part_105_0, sums[67]),
            );
        // r1__part_107 = 3*u4_from_u3_p2 + u5_from_u3_p2 + 3*r1__part_91
        let r1__part_107 = r1__part_91
            .mul_add(S::int(3), S::int(3) * u4_from_u3_p2 + u5_from_u3_p2);
        // r1__part_108 = sin_theta2_from_theta1*r1__part_107
        let r1__part_108 = r1__part_107
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__part_107_0, sums[68]),
            );
        // r1__part_109 = -r1__part_90 + r1__part_101 - 3*r1__part_106 - 3*r1__part_108
        let r1__part_109 = r1__part_106.mul_add(-S::int(3), -S::int(3) * r1__part_108)
            + r1__part_101 - r1__part_90;
        // r1__part_110 = r1__part_109/u3_part_8
        let r1__part_110 = r1__part_109
            .mul_add(
                over_u3_part_8,
                -(u3_part_8.mul_add(r1__part_110_0, sums[69]) * over_u3_part_8),
            );
        // r1__part_111 = r1__part_21/u3_part_8
        let r1__part_111 = r1__part_21
            .mul_add(
                over_u3_part_8,
                -(u3_part_8.mul_add(r1__part_111_0, sums[70]) * over_u3_part_8),
            );
        // r1__part_112 = r1__part_111/r1__part_12
        let r1__part_112 = r1__part_111
            .mul_add(
                over_r1__part_12,
                -(r1__part_12.mul_add(r1__part_112_0, sums[71]) * over_r1__part_12),
            );
        // r1__part_113 = r1__part_67*r1__part_112
        let r1__part_113 = r1__part_67
            .mul_add(r1__part_112_0, r1__part_112.mul_add(r1__part_67_0, sums[72]));
        // r1__part_114 = m_l_squared_by_12*r1__part_110 + m_l_squared_by_12*r1__part_113
        let r1__part_114 = r1__part_113
            .mul_add(m_l_squared_by_12, m_l_squared_by_12 * r1__part_110);
        // u5_from_u3_dot_part = cos_theta2_from_theta1*cos_theta3_from_theta1
        let u5_from_u3_dot_part = cos_theta3_from_theta1
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(cos_theta3_from_theta1_0, sums[73]),
            );
        // u5_from_u3_dot_part_2 = u3_part_3 + u5_from_u3_dot_part
        let u5_from_u3_dot_part_2 = u3_part_3 + u5_from_u3_dot_part;
        // u5_from_u3_dot_part_3 = cos_theta2_from_theta1*u5_from_u3_dot_part_2
        let u5_from_u3_dot_part_3 = u5_from_u3_dot_part_2
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u5_from_u3_dot_part_2_0, sums[74]),
            );
        // u5_from_u3_dot_part_4 = 5*cos_theta3_from_theta1 - 9*u5_from_u3_dot_part_3
        let u5_from_u3_dot_part_4 = u5_from_u3_dot_part_3
            .mul_add(-S::int(9), S::int(5) * cos_theta3_from_theta1);
        // u5_from_u3_dot_part_5 = cos_theta3_from_theta1*u5_from_u3_dot_part_4
        let u5_from_u3_dot_part_5 = u5_from_u3_dot_part_4
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(u5_from_u3_dot_part_4_0, sums[75]),
            );
        // u5_from_u3_dot_part_6 = 9 + u5_from_u3_dot_part_5
        let u5_from_u3_dot_part_6 = u5_from_u3_dot_part_5;
        // u5_from_u3_dot_part_7 = r1__part_12/u5_from_u3_dot_part_6
        let u5_from_u3_dot_part_7 = r1__part_12
            .mul_add(
                over_u5_from_u3_dot_part_6,
                -(u5_from_u3_dot_part_6.mul_add(u5_from_u3_dot_part_7_0, sums[76])
                    * over_u5_from_u3_dot_part_6),
            );
        // u5_from_u3_dot_part_8 = r1__part_114*u5_from_u3_dot_part_7
        let u5_from_u3_dot_part_8 = r1__part_114
            .mul_add(
                u5_from_u3_dot_part_7_0,
                u5_from_u3_dot_part_7.mul_add(r1__part_114_0, sums[77]),
            );
        // u3_plus_u5_from_u3 = -u3_part_12 + u5_from_u3
        let u3_plus_u5_from_u3 = u5_from_u3 - u3_part_12;
        // u4_from_u3_dot_part = cos_theta3_from_theta1*u3_plus_u5_from_u3
        let u4_from_u3_dot_part = u3_plus_u5_from_u3
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(u3_plus_u5_from_u3_0, sums[78]),
            );
        // u4_from_u3_dot_part_2 = 1 + cos_theta2_from_theta1
        let u4_from_u3_dot_part_2 = cos_theta2_from_theta1;
        // u4_from_u3_dot_part_3 = u3_part_12*r1__part_4
        let u4_from_u3_dot_part_3 = r1__part_4
            .mul_add(u3_part_12_0, u3_part_12.mul_add(r1__part_4_0, sums[79]));
        // u4_from_u3_dot_part_4 = u4_from_u3_p2 + u5_from_u3_p2 - 2*u4_from_u3_dot_part_3
        let u4_from_u3_dot_part_4 = u4_from_u3_dot_part_3
            .mul_add(-S::int(2), u4_from_u3_p2 + u5_from_u3_p2);
        // u4_from_u3_dot_part_5 = sin_theta3_from_theta1*u4_from_u3_dot_part_4
        let u4_from_u3_dot_part_5 = u4_from_u3_dot_part_4
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(u4_from_u3_dot_part_4_0, sums[80]),
            );
        // u4_from_u3_dot_part_6 = sin_theta3_from_theta1*u5_from_u3_dot_part_8
        let u4_from_u3_dot_part_6 = u5_from_u3_dot_part_8
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(u5_from_u3_dot_part_8_0, sums[81]),
            );
        // u4_from_u3_dot_part_7 = u3_part_12*u3_plus_u5_from_u3
        let u4_from_u3_dot_part_7 = u3_plus_u5_from_u3
            .mul_add(u3_part_12_0, u3_part_12.mul_add(u3_plus_u5_from_u3_0, sums[82]));
        // u4_from_u3_dot_part_8 = -9*u3_part_12 + 9*u4_from_u3 + 7*u5_from_u3
        let u4_from_u3_dot_part_8 = u3_part_12
            .mul_add(-S::int(9), u5_from_u3.mul_add(S::int(7), S::int(9) * u4_from_u3));
        // u4_from_u3_dot_part_9 = 2*u4_from_u3_p2 + u5_from_u3_p2
        let u4_from_u3_dot_part_9 = S::int(2) * u4_from_u3_p2 + u5_from_u3_p2;
        // u4_from_u3_dot_part_10 = sin_theta2_from_theta1*u5_from_u3_dot_part_8
        let u4_from_u3_dot_part_10 = u5_from_u3_dot_part_8
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(u5_from_u3_dot_part_8_0, sums[83]),
            );
        // u4_from_u3_dot_part_11 = cos_theta2_from_theta1*u4_from_u3_dot_part_9
        let u4_from_u3_dot_part_11 = u4_from_u3_dot_part_9
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u4_from_u3_dot_part_9_0, sums[84]),
            );
        // u4_from_u3_dot_part_12 = u3_part_12*u4_from_u3_dot_part_8
        let u4_from_u3_dot_part_12 = u4_from_u3_dot_part_8
            .mul_add(
                u3_part_12_0,
                u3_part_12.mul_add(u4_from_u3_dot_part_8_0, sums[85]),
            );
        // u4_from_u3_dot_part_13 = 7 + 9*cos_theta3_from_theta1
        let u4_from_u3_dot_part_13 = S::int(9) * cos_theta3_from_theta1;
        // u4_from_u3_dot_part_14 = u5_from_u3_dot_part_8*u4_from_u3_dot_part_13
        let u4_from_u3_dot_part_14 = u5_from_u3_dot_part_8
            .mul_add(
                u4_from_u3_dot_part_13_0,
                u4_from_u3_dot_part_13.mul_add(u5_from_u3_dot_part_8_0, sums[86]),
            );
        // u4_from_u3_dot_part_15 = u3_part_12*r1__part_39
        let u4_from_u3_dot_part_15 = r1__part_39
            .mul_add(u3_part_12_0, u3_part_12.mul_add(r1__part_39_0, sums[87]));
        // u4_from_u3_dot_part_16 = 7*u4_from_u3_p2 + 5*u5_from_u3_p2 + weight_2*u4_from_u3_dot_part_10 +
        //   3*u4_from_u3_dot_part_11 - u4_from_u3_dot_part_15
        let u4_from_u3_dot_part_16 = u4_from_u3_dot_part_10
            .mul_add(
                weight_2,
                u4_from_u3_dot_part_11
                    .mul_add(
                        S::int(3),
                        u5_from_u3_p2.mul_add(S::int(5), S::int(7) * u4_from_u3_p2),
                    ) - u4_from_u3_dot_part_15,
            );
        // u4_from_u3_dot_part_17 = cos_theta2_from_theta1*u4_from_u3_dot_part_16
        let u4_from_u3_dot_part_17 = u4_from_u3_dot_part_16
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u4_from_u3_dot_part_16_0, sums[88]),
            );
        // u4_from_u3_dot_part_18 = 9*u4_from_u3_p2 + 7*u5_from_u3_p2 + weight_3*u4_from_u3_dot_part_10 -
        //   2*u4_from_u3_dot_part_12 - 3*u4_from_u3_dot_part_17
        let u4_from_u3_dot_part_18 = u4_from_u3_dot_part_17
            .mul_add(
                -S::int(3),
                u4_from_u3_dot_part_10
                    .mul_add(
                        weight_3,
                        u4_from_u3_dot_part_12
                            .mul_add(
                                -S::int(2),
                                u5_from_u3_p2.mul_add(S::int(7), S::int(9) * u4_from_u3_p2),
                            ),
                    ),
            );
        // u4_from_u3_dot_part_19 = sin_theta3_from_theta1*u4_from_u3_dot_part_18
        let u4_from_u3_dot_part_19 = u4_from_u3_dot_part_18
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(u4_from_u3_dot_part_18_0, sums[89]),
            );
        // u4_from_u3_dot_part_20 = u3_part_12*r1__part_45
        let u4_from_u3_dot_part_20 = r1__part_45
            .mul_add(u3_part_12_0, u3_part_12.mul_add(r1__part_45_0, sums[90]));
        // u4_from_u3_dot_part_21 = r1__part_43*u5_from_u3_p2
        let u4_from_u3_dot_part_21 = r1__part_43
            .mul_add(u5_from_u3_p2_0, u5_from_u3_p2.mul_add(r1__part_43_0, sums[91]));
        // u4_from_u3_dot_part_22 = 7*u4_from_u3_p2 - u4_from_u3_dot_part_20 - u4_from_u3_dot_part_21
        let u4_from_u3_dot_part_22 = S::int(7) * u4_from_u3_p2 - u4_from_u3_dot_part_21
            - u4_from_u3_dot_part_20;
        // u4_from_u3_dot_part_23 = sin_theta2_from_theta1*u4_from_u3_dot_part_22
        let u4_from_u3_dot_part_23 = u4_from_u3_dot_part_22
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(u4_from_u3_dot_part_22_0, sums[92]),
            );
        // u4_from_u3_dot_part_24 = cos_theta2_from_theta1*u4_from_u3_dot_part_2
        let u4_from_u3_dot_part_24 = u4_from_u3_dot_part_2
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u4_from_u3_dot_part_2_0, sums[93]),
            );
        // u4_from_u3_dot_part_25 = 4 + 3*u4_from_u3_dot_part_24
        let u4_from_u3_dot_part_25 = S::int(3) * u4_from_u3_dot_part_24;
        // u4_from_u3_dot_part_26 = u5_from_u3_dot_part_8*u4_from_u3_dot_part_25
        let u4_from_u3_dot_part_26 = u5_from_u3_dot_part_8
            .mul_add(
                u4_from_u3_dot_part_25_0,
                u4_from_u3_dot_part_25.mul_add(u5_from_u3_dot_part_8_0, sums[94]),
            );
        // u4_from_u3_dot_part_27 = u3_part_12*r1__part_23
        let u4_from_u3_dot_part_27 = r1__part_23
            .mul_add(u3_part_12_0, u3_part_12.mul_add(r1__part_23_0, sums[95]));
        // u4_from_u3_dot_part_28 = 2 + cos_theta3_from_theta1 + 3*r1__part_14
        let u4_from_u3_dot_part_28 = r1__part_14
            .mul_add(S::int(3), cos_theta3_from_theta1);
        // u4_from_u3_dot_part_29 = cos_theta2_from_theta1*u4_from_u3_dot_part_4
        let u4_from_u3_dot_part_29 = u4_from_u3_dot_part_4
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u4_from_u3_dot_part_4_0, sums[96]),
            );
        // u4_from_u3_dot_part_30 = 2*u4_from_u3_p2 + u5_from_u3_p2 + 2*r1__part_6 +
        //   weight_4*u4_from_u3_dot_part_6 - 2*u4_from_u3_dot_part_27
        let u4_from_u3_dot_part_30 = u4_from_u3_dot_part_6
            .mul_add(
                weight_4,
                u4_from_u3_dot_part_27
                    .mul_add(
                        -S::int(2),
                        r1__part_6
                            .mul_add(
                                S::int(2),
                                S::int(2) * u4_from_u3_p2 + u5_from_u3_p2,
                            ),
                    ),
            );
        // u4_from_u3_dot_part_31 = sin_theta2_from_theta1*u4_from_u3_dot_part_30
        let u4_from_u3_dot_part_31 = u4_from_u3_dot_part_30
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(u4_from_u3_dot_part_30_0, sums[97]),
            );
        // u4_from_u3_dot_part_32 = u5_from_u3_p2 - 2*u4_from_u3_dot_part_7 + 6*u4_from_u3_dot_part_29
        let u4_from_u3_dot_part_32 = u4_from_u3_dot_part_29
            .mul_add(
                S::int(6),
                u4_from_u3_dot_part_7.mul_add(-S::int(2), u5_from_u3_p2),
            );
        // u4_from_u3_dot_part_33 = sin_theta3_from_theta1*u4_from_u3_dot_part_32
        let u4_from_u3_dot_part_33 = u4_from_u3_dot_part_32
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(u4_from_u3_dot_part_32_0, sums[98]),
            );
        // u4_from_u3_dot_part_34 = u5_from_u3_dot_part_8*u4_from_u3_dot_part_28
        let u4_from_u3_dot_part_34 = u5_from_u3_dot_part_8
            .mul_add(
                u4_from_u3_dot_part_28_0,
                u4_from_u3_dot_part_28.mul_add(u5_from_u3_dot_part_8_0, sums[99]),
            );
        // u4_from_u3_dot_part_35 = 3*u4_from_u3_dot_part_31 - u4_from_u3_dot_part_33 +
        //   weight_5*u4_from_u3_dot_part_34
        let u4_from_u3_dot_part_35 = u4_from_u3_dot_part_31
            .mul_add(
                S::int(3),
                u4_from_u3_dot_part_34.mul_add(weight_5, -u4_from_u3_dot_part_33),
            );
        // u4_from_u3_dot_part_36 = cos_theta2_from_theta1*u4_from_u3_dot_part_35
        let u4_from_u3_dot_part_36 = u4_from_u3_dot_part_35
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u4_from_u3_dot_part_35_0, sums[100]),
            );
        // u4_from_u3_dot_part_37 = -15*u3_part_12 + 14*u4_from_u3 + 12*u5_from_u3 + 2*u4_from_u3_dot_part
        let u4_from_u3_dot_part_37 = u4_from_u3_dot_part
            .mul_add(
                S::int(2),
                u3_part_12
                    .mul_add(
                        -S::int(15),
                        u5_from_u3.mul_add(S::int(12), S::int(14) * u4_from_u3),
                    ),
            );
        // u4_from_u3_dot_part_38 = u3_part_12*u4_from_u3_dot_part_37
        let u4_from_u3_dot_part_38 = u4_from_u3_dot_part_37
            .mul_add(
                u3_part_12_0,
                u3_part_12.mul_add(u4_from_u3_dot_part_37_0, sums[101]),
            );
        // u4_from_u3_dot_part_39 = 7*u4_from_u3_p2 + weight_5*u4_from_u3_dot_part_6 + r1__part_60 -
        //   u4_from_u3_dot_part_38
        let u4_from_u3_dot_part_39 = u4_from_u3_dot_part_6
            .mul_add(
                weight_5,
                S::int(7) * u4_from_u3_p2 + r1__part_60 - u4_from_u3_dot_part_38,
            );
        // u4_from_u3_dot_part_40 = sin_theta2_from_theta1*u4_from_u3_dot_part_39
        let u4_from_u3_dot_part_40 = u4_from_u3_dot_part_39
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(u4_from_u3_dot_part_39_0, sums[102]),
            );
        // u4_from_u3_dot_part_41 = 9*u4_from_u3_dot_part_5 + weight_6*u4_from_u3_dot_part_14 +
        //   3*u4_from_u3_dot_part_36 + 3*u4_from_u3_dot_part_40
        let u4_from_u3_dot_part_41 = u4_from_u3_dot_part_36
            .mul_add(
                S::int(3),
                u4_from_u3_dot_part_40
                    .mul_add(
                        S::int(3),
                        u4_from_u3_dot_part_14
                            .mul_add(weight_6, S::int(9) * u4_from_u3_dot_part_5),
                    ),
            );
        // u4_from_u3_dot_part_42 = cos_theta3_from_theta1*u4_from_u3_dot_part_41
        let u4_from_u3_dot_part_42 = u4_from_u3_dot_part_41
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(u4_from_u3_dot_part_41_0, sums[103]),
            );
        // u4_from_u3_dot_part_43 = u4_from_u3_dot_part_19 + 3*u4_from_u3_dot_part_23 +
        //   weight_2*u4_from_u3_dot_part_26 + u4_from_u3_dot_part_42
        let u4_from_u3_dot_part_43 = u4_from_u3_dot_part_26
            .mul_add(weight_2, S::int(3) * u4_from_u3_dot_part_23)
            + u4_from_u3_dot_part_19 + u4_from_u3_dot_part_42;
        // u4_from_u3_dot_part_44 = u4_from_u3_dot_part_43/r1__part_12
        let u4_from_u3_dot_part_44 = u4_from_u3_dot_part_43
            .mul_add(
                over_r1__part_12,
                -(r1__part_12.mul_add(u4_from_u3_dot_part_44_0, sums[104])
                    * over_r1__part_12),
            );
        theta2_from_theta1_rate = u4_from_u3;
        theta3_from_theta1_rate = u5_from_u3;
        theta1_rate = -u3_part_12;
        u4_from_u3_rate = -u4_from_u3_dot_part_44;
        u5_from_u3_rate = weight_5 * u5_from_u3_dot_part_8;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * theta2_from_theta1,
                count * theta2_from_theta1,
                count * theta3_from_theta1,
                count * theta3_from_theta1,
                cos_theta2_from_theta1,
                sin_theta2_from_theta1,
                cos_theta3_from_theta1,
                u3_part_4,
                u3_part_7,
                u3_part_8,
                u4_from_u3,
                u5_from_u3,
                u3_part_12,
                cos_theta3_from_theta1,
                cos_theta3_from_theta1,
                cos_theta2_from_theta1,
                cos_theta3_from_theta1,
                cos_theta2_from_theta1,
                cos_theta2_from_theta1,
                cos_theta3_from_theta1,
                cos_theta2_from_theta1,
                cos_theta3_from_theta1,
                cos_theta2_from_theta1,
                u3_part_12,
                u5_from_u3,
                sin_theta2_from_theta1,
                cos_theta2_from_theta1,
                cos_theta2_from_theta1,
                sin_theta3_from_theta1,
                cos_theta3_from_theta1,
                cos_theta2_from_theta1,
                cos_theta2_from_theta1,
                sin_theta3_from_theta1,
                u5_from_u3,
                sin_theta2_from_theta1,
                u3_part_12,
                cos_theta2_from_theta1,
                r1__part_51,
                sin_theta3_from_theta1,
                cos_theta3_from_theta1,
                sin_theta2_from_theta1,
                cos_theta2_from_theta1,
                r1__part_27,
                cos_theta3_from_theta1,
                sin_theta2_from_theta1,
                sin_theta3_from_theta1,
                cos_theta3_from_theta1,
                u3_part_12,
                u4_from_u3,
                sin_theta2_from_theta1,
                cos_theta2_from_theta1,
                sin_theta3_from_theta1,
                cos_theta3_from_theta1,
                u4_from_u3,
                cos_theta2_from_theta1,
                sin_theta3_from_theta1,
                sin_theta2_from_theta1,
                u3_part_12,
                cos_theta2_from_theta1,
                cos_theta3_from_theta1,
                r1__part_72,
                sin_theta2_from_theta1,
                cos_theta2_from_theta1,
                sin_theta3_from_theta1,
                cos_theta3_from_theta1,
                r1__part_81,
                cos_theta2_from_theta1,
                sin_theta3_from_theta1,
                sin_theta2_from_theta1,
                u3_part_8,
                u3_part_8,
                r1__part_12,
                r1__part_67,
                cos_theta2_from_theta1,
                cos_theta2_from_theta1,
                cos_theta3_from_theta1,
                u5_from_u3_dot_part_6,
                r1__part_114,
                cos_theta3_from_theta1,
                u3_part_12,
                sin_theta3_from_theta1,
                sin_theta3_from_theta1,
                u3_part_12,
                sin_theta2_from_theta1,
                cos_theta2_from_theta1,
                u3_part_12,
                u5_from_u3_dot_part_8,
                u3_part_12,
                cos_theta2_from_theta1,
                sin_theta3_from_theta1,
                u3_part_12,
                r1__part_43,
                sin_theta2_from_theta1,
                cos_theta2_from_theta1,
                u5_from_u3_dot_part_8,
                u3_part_12,
                cos_theta2_from_theta1,
                sin_theta2_from_theta1,
                sin_theta3_from_theta1,
                u5_from_u3_dot_part_8,
                cos_theta2_from_theta1,
                u3_part_12,
                sin_theta2_from_theta1,
                cos_theta3_from_theta1,
                r1__part_12,
            ]),
            padded([
                cos_theta2_from_theta1,
                sin_theta2_from_theta1,
                cos_theta3_from_theta1,
                sin_theta3_from_theta1,
                u3_part,
                sin_theta3_from_theta1,
                u3_part_5,
                u4_from_u3,
                u5_from_u3,
                u3_part_12,
                u4_from_u3,
                u5_from_u3,
                r1__part,
                r1__part_4,
                r1__part_3,
                r1__part_7,
                r1__part_9,
                u3_part_3,
                r1__part_13,
                r1__part_15,
                r1__part_17,
                r1__part_19,
                r1__part_23,
                r1__part_25,
                r1__part_27,
                r1__part_29,
                r1__part_4,
                r1__part_32,
                r1__part_34,
                r1__part_36,
                r1__part_22,
                r1__part_39,
                r1__part_41,
                r1__part_43,
                r1__part_45,
                r1__part_47,
                r1__part_49,
                u5_from_u3_p2,
                r1__part_53,
                r1__part_49,
                r1__part_56,
                r1__part_58,
                u5_from_u3_p2,
                r1__part_61,
                r1__part_63,
                r1__part_65,
                r1__part_68,
                r1__part_70,
                r1__part_72,
                r1__part_74,
                r1__part_68,
                r1__part_77,
                r1__part_79,
                r1__part_81,
                r1__part_83,
                r1__part_85,
                r1__part_87,
                r1__part_89,
                r1__part_3,
                r1__part_92,
                u4_from_u3_p2,
                r1__part_95,
                r1__part_92,
                r1__part_98,
                r1__part_100,
                u4_from_u3_p2,
                r1__part_103,
                r1__part_105,
                r1__part_107,
                r1__part_110,
                r1__part_111,
                r1__part_112,
                r1__part_112,
                cos_theta3_from_theta1,
                u5_from_u3_dot_part_2,
                u5_from_u3_dot_part_4,
                u5_from_u3_dot_part_7,
                u5_from_u3_dot_part_7,
                u3_plus_u5_from_u3,
                r1__part_4,
                u4_from_u3_dot_part_4,
                u5_from_u3_dot_part_8,
                u3_plus_u5_from_u3,
                u5_from_u3_dot_part_8,
                u4_from_u3_dot_part_9,
                u4_from_u3_dot_part_8,
                u4_from_u3_dot_part_13,
                r1__part_39,
                u4_from_u3_dot_part_16,
                u4_from_u3_dot_part_18,
                r1__part_45,
                u5_from_u3_p2,
                u4_from_u3_dot_part_22,
                u4_from_u3_dot_part_2,
                u4_from_u3_dot_part_25,
                r1__part_23,
                u4_from_u3_dot_part_4,
                u4_from_u3_dot_part_30,
                u4_from_u3_dot_part_32,
                u4_from_u3_dot_part_28,
                u4_from_u3_dot_part_35,
                u4_from_u3_dot_part_37,
                u4_from_u3_dot_part_39,
                u4_from_u3_dot_part_41,
                u4_from_u3_dot_part_44,
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
        u3_part_last = u3_part;
        u3_part_3_last = u3_part_3;
        u3_part_4_last = u3_part_4;
        u3_part_5_last = u3_part_5;
        u3_part_7_last = u3_part_7;
        u3_part_8_last = u3_part_8;
        u3_part_12_last = u3_part_12;
        u4_from_u3_p2_last = u4_from_u3_p2;
        u5_from_u3_p2_last = u5_from_u3_p2;
        r1__part_last = r1__part;
        r1__part_3_last = r1__part_3;
        r1__part_4_last = r1__part_4;
        r1__part_7_last = r1__part_7;
        r1__part_9_last = r1__part_9;
        r1__part_12_last = r1__part_12;
        r1__part_13_last = r1__part_13;
        r1__part_15_last = r1__part_15;
        r1__part_17_last = r1__part_17;
        r1__part_19_last = r1__part_19;
        r1__part_22_last = r1__part_22;
        r1__part_23_last = r1__part_23;
        r1__part_25_last = r1__part_25;
        r1__part_27_last = r1__part_27;
        r1__part_29_last = r1__part_29;
        r1__part_32_last = r1__part_32;
        r1__part_34_last = r1__part_34;
        r1__part_36_last = r1__part_36;
        r1__part_39_last = r1__part_39;
        r1__part_41_last = r1__part_41;
        r1__part_43_last = r1__part_43;
        r1__part_45_last = r1__part_45;
        r1__part_47_last = r1__part_47;
        r1__part_49_last = r1__part_49;
        r1__part_51_last = r1__part_51;
        r1__part_53_last = r1__part_53;
        r1__part_56_last = r1__part_56;
        r1__part_58_last = r1__part_58;
        r1__part_61_last = r1__part_61;
        r1__part_63_last = r1__part_63;
        r1__part_65_last = r1__part_65;
        r1__part_67_last = r1__part_67;
        r1__part_68_last = r1__part_68;
        r1__part_70_last = r1__part_70;
        r1__part_72_last = r1__part_72;
        r1__part_74_last = r1__part_74;
        r1__part_77_last = r1__part_77;
        r1__part_79_last = r1__part_79;
        r1__part_81_last = r1__part_81;
        r1__part_83_last = r1__part_83;
        r1__part_85_last = r1__part_85;
        r1__part_87_last = r1__part_87;
        r1__part_89_last = r1__part_89;
        r1__part_92_last = r1__part_92;
        r1__part_95_last = r1__part_95;
        r1__part_98_last = r1__part_98;
        r1__part_100_last = r1__part_100;
        r1__part_103_last = r1__part_103;
        r1__part_105_last = r1__part_105;
        r1__part_107_last = r1__part_107;
        r1__part_110_last = r1__part_110;
        r1__part_111_last = r1__part_111;
        r1__part_112_last = r1__part_112;
        r1__part_114_last = r1__part_114;
        u5_from_u3_dot_part_2_last = u5_from_u3_dot_part_2;
        u5_from_u3_dot_part_4_last = u5_from_u3_dot_part_4;
        u5_from_u3_dot_part_6_last = u5_from_u3_dot_part_6;
        u5_from_u3_dot_part_7_last = u5_from_u3_dot_part_7;
        u5_from_u3_dot_part_8_last = u5_from_u3_dot_part_8;
        u3_plus_u5_from_u3_last = u3_plus_u5_from_u3;
        u4_from_u3_dot_part_2_last = u4_from_u3_dot_part_2;
        u4_from_u3_dot_part_4_last = u4_from_u3_dot_part_4;
        u4_from_u3_dot_part_8_last = u4_from_u3_dot_part_8;
        u4_from_u3_dot_part_9_last = u4_from_u3_dot_part_9;
        u4_from_u3_dot_part_13_last = u4_from_u3_dot_part_13;
        u4_from_u3_dot_part_16_last = u4_from_u3_dot_part_16;
        u4_from_u3_dot_part_18_last = u4_from_u3_dot_part_18;
        u4_from_u3_dot_part_22_last = u4_from_u3_dot_part_22;
        u4_from_u3_dot_part_25_last = u4_from_u3_dot_part_25;
        u4_from_u3_dot_part_28_last = u4_from_u3_dot_part_28;
        u4_from_u3_dot_part_30_last = u4_from_u3_dot_part_30;
        u4_from_u3_dot_part_32_last = u4_from_u3_dot_part_32;
        u4_from_u3_dot_part_35_last = u4_from_u3_dot_part_35;
        u4_from_u3_dot_part_37_last = u4_from_u3_dot_part_37;
        u4_from_u3_dot_part_39_last = u4_from_u3_dot_part_39;
        u4_from_u3_dot_part_41_last = u4_from_u3_dot_part_41;
        u4_from_u3_dot_part_44_last = u4_from_u3_dot_part_44;
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
        let x = &mut x.as_chunks_mut().0[..=order];
        taylor(&Parameters::from_slice(p), x, rows(work));
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
