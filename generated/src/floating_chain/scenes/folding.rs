//! Chain of three rods floating in a plane: Folding.
//!
//! Generated from `models/floating_chain/scenes/folding.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: x, y, theta1, theta2, theta3, u1, u2, u3, u4, u5.
//! States: theta2_from_theta1, theta3_from_theta1, u4_from_u3, u5_from_u3. Quadratures: theta1.
//! p_x = 21*u1/10 - 7*u3*sin(theta1)/25 - 21*u4*sin(theta2)/50 - 7*u5*sin(theta3)/50: momentum p_x = ∂L/∂x'.
//! p_y = 21*u2/10 + 7*u3*cos(theta1)/25 + 21*u4*cos(theta2)/50 + 7*u5*cos(theta3)/50: momentum p_y = ∂L/∂y'.
//! H_n3 = 7*u3*(3 + 3*cos(theta1 - theta2) + cos(theta1 - theta3))/750 + 7*u4*(7 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + 3*cos(theta1 - theta2)*(1 + cos(theta1 - theta3)))/750 + 7*u5*(3 + 3*sin(theta1 - theta2)*sin(theta1 - theta3) + cos(theta1 - theta3)*(1 + 3*cos(theta1 - theta2)))/750: angular momentum about n3 through the mass centre.
//! centre_x = 21*x/10 + 7*cos(theta1)/25 + 21*cos(theta2)/50 + 7*cos(theta3)/50: 21*x/10 + 7*cos(theta1)/25 + 21*cos(theta1 + theta2_from_theta1)/50 + 7*cos(theta1 + theta3_from_theta1)/50 at the start.
//! centre_y = 21*y/10 + 7*sin(theta1)/25 + 21*sin(theta2)/50 + 7*sin(theta3)/50: 21*y/10 + 7*sin(theta1)/25 + 21*sin(theta1 + theta2_from_theta1)/50 + 7*sin(theta1 + theta3_from_theta1)/50 at the start.
//! Parameters that the scene fixes: m = 0.7, l = 0.4.
//! Cost: accelerations 235 operations, 3 sines and cosines; derivative 235 operations, 3 sines and cosines.
//! Singular where 91/750 + 7*sin(theta2_from_theta1)*sin(theta3_from_theta1)/125 + 7*cos(theta3_from_theta1)/375 + 7*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))/125 = 0.

use tripos_traits::series::{Factors, SLACK, pair_sums, rows};
use tripos_traits::{CompiledScene, CompiledSystem, Scalar, System};

/// The parameters, in the order of the model file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// momentum p_x = ∂L/∂x', 1
    pub p_x: S,
    /// momentum p_y = ∂L/∂y', 1
    pub p_y: S,
    /// angular momentum about n3 through the mass centre, 1
    pub H_n3: S,
    /// 21*x/10 + 7*cos(theta1)/25 + 21*cos(theta1 + theta2_from_theta1)/50 + 7*cos(theta1 + theta3_from_theta1)/50 at the start, kg*m
    pub centre_x: S,
    /// 21*y/10 + 7*sin(theta1)/25 + 21*sin(theta1 + theta2_from_theta1)/50 + 7*sin(theta1 + theta3_from_theta1)/50 at the start, kg*m
    pub centre_y: S,
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
            p_x: p[0],
            p_y: p[1],
            H_n3: p[2],
            centre_x: p[3],
            centre_y: p[4],
        }
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 5] = ["p_x", "p_y", "H_n3", "centre_x", "centre_y"];

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
/// 235 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [S; 2] {
    let Parameters { H_n3, .. } = *p;
    let [theta2_from_theta1, theta3_from_theta1, theta1] = *q;
    let [u4_from_u3, u5_from_u3] = *u;
    // Sines and cosines.
    let (sin_theta3_from_theta1, cos_theta3_from_theta1) = theta3_from_theta1.sin_cos();
    let (sin_theta2_from_theta1, cos_theta2_from_theta1) = theta2_from_theta1.sin_cos();
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    // Shared terms.
    // 1 + cos(theta3_from_theta1); used 3 times
    let u3_part = S::int(1) + cos_theta3_from_theta1;
    // 3*cos(theta2_from_theta1); used 11 times
    let u3_part_2 = S::int(3) * cos_theta2_from_theta1;
    // sin(theta2_from_theta1)*sin(theta3_from_theta1); used 6 times
    let u3_part_3 = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // 3*u3_part_3; used 4 times
    let u3_part_3_scaled = S::int(3) * u3_part_3;
    // 7 + u3_part*u3_part_2 + u3_part_3_scaled; used 2 times
    let u3_part_4 = u3_part.mul_add(u3_part_2, S::int(7)) + u3_part_3_scaled;
    // u5_from_u3*(3 + cos(theta3_from_theta1)*(1 + u3_part_2) + u3_part_3_scaled) + u4_from_u3*u3_part_4
    let u3_part_5 = u5_from_u3
        * (S::int(3) + cos_theta3_from_theta1 * (S::int(1) + u3_part_2)
            + u3_part_3_scaled) + u4_from_u3 * u3_part_4;
    // 6*cos(theta2_from_theta1); used 4 times
    let u3_part_6 = S::int(6) * cos_theta2_from_theta1;
    // 2*cos(theta3_from_theta1); used 3 times
    let u3_part_7 = S::int(2) * cos_theta3_from_theta1;
    // 6*u3_part_3; used 2 times
    let u3_part_3_scaled_2 = S::int(6) * u3_part_3;
    // 13 + u3_part*u3_part_6 + u3_part_7 + u3_part_3_scaled_2; used 2 times
    let u3_part_8 = u3_part.mul_add(u3_part_6, S::int(13)) + u3_part_7
        + u3_part_3_scaled_2;
    // 1/u3_part_8; used 4 times
    let u3_part_8_inv = S::int(1) / u3_part_8;
    // Elimination, step by step.
    // u3 = (750*H_n3 - 7*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 7*u5_from_u3*(3 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1))))/(7*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))
    let u3 = S::ratio(1, 7) * u3_part_8_inv
        * (-u3_part_5).mul_add(S::int(7), S::int(750) * H_n3);
    // Shared terms.
    // u3 + u5_from_u3; used 5 times
    let r1__part = u3 + u5_from_u3;
    // u4_from_u3 + r1__part; used 2 times
    let r1__part_2 = u4_from_u3 + r1__part;
    // u4_from_u3 + 2*r1__part + u3_part_6*r1__part_2; used 2 times
    let r1__part_3 = r1__part.mul_add(S::int(2), u4_from_u3) + u3_part_6 * r1__part_2;
    // 3 + cos(theta2_from_theta1); used 2 times
    let r1__part_4 = S::int(3) + cos_theta2_from_theta1;
    // 6*u5_from_u3; used 3 times
    let u5_from_u3_scaled = S::int(6) * u5_from_u3;
    // 3*sin(theta2_from_theta1); used 6 times
    let r1__part_5 = S::int(3) * sin_theta2_from_theta1;
    // 10 + u3_part_2; used 2 times
    let r1__part_6 = S::int(10) + u3_part_2;
    // u4_from_u3^2; used 7 times
    let u4_from_u3_sq = u4_from_u3 * u4_from_u3;
    // u5_from_u3^2; used 7 times
    let u5_from_u3_sq = u5_from_u3 * u5_from_u3;
    // u4_from_u3_sq + u5_from_u3_sq; used 2 times
    let r1__part_7 = u4_from_u3_sq + u5_from_u3_sq;
    // u4_from_u3_sq + 2*u5_from_u3_sq + u3_part_6*r1__part_7; used 2 times
    let r1__part_8 = u5_from_u3_sq.mul_add(S::int(2), u4_from_u3_sq)
        + u3_part_6 * r1__part_7;
    // 3*u4_from_u3_sq; used 2 times
    let u4_from_u3_sq_scaled = S::int(3) * u4_from_u3_sq;
    // 3*u5_from_u3_sq; used 2 times
    let u5_from_u3_sq_scaled = S::int(3) * u5_from_u3_sq;
    // u5_from_u3_sq + u4_from_u3_sq_scaled; used 2 times
    let r1__part_9 = u5_from_u3_sq + u4_from_u3_sq_scaled;
    // 9*cos(theta3_from_theta1); used 2 times
    let r1__part_10 = S::int(9) * cos_theta3_from_theta1;
    // 9*u3_part_3 - 12 + u3_part_2*(u3_part_3_scaled - 3 - u3_part_2 + cos(theta3_from_theta1)*(2 +
    //   cos(theta3_from_theta1) + u3_part_2*(1 + u3_part_7) + u3_part_3_scaled_2)) +
    //   cos(theta3_from_theta1)*(u3_part_3_scaled - 7 - r1__part_10); used 2 times
    let r1__part_11 = -S::int(12) + S::int(9) * u3_part_3
        + u3_part_2
            * (u3_part_3_scaled - S::int(3) - u3_part_2
                + cos_theta3_from_theta1
                    * (S::int(2) + cos_theta3_from_theta1
                        + u3_part_2 * (S::int(1) + u3_part_7) + u3_part_3_scaled_2))
        + cos_theta3_from_theta1 * (u3_part_3_scaled - S::int(7) - r1__part_10);
    // cos(theta1)*sin(theta2_from_theta1) + sin(theta1)*cos(theta2_from_theta1)
    let r1__part_12 = sin_theta1
        .mul_add(cos_theta2_from_theta1, cos_theta1 * sin_theta2_from_theta1);
    // 3*sin(theta1 + theta2_from_theta1); used 3 times
    let r1__part_12_scaled = S::int(3) * r1__part_12;
    // cos(theta1)*sin(theta3_from_theta1) + sin(theta1)*cos(theta3_from_theta1); used 2 times
    let r1__part_13 = sin_theta1
        .mul_add(cos_theta3_from_theta1, cos_theta1 * sin_theta3_from_theta1);
    // u3_part_4*u3_part_8_inv; used 3 times
    let r1__part_14 = u3_part_4 * u3_part_8_inv;
    // cos(theta1)*cos(theta3_from_theta1) - sin(theta1)*sin(theta3_from_theta1); used 2 times
    let r1__part_15 = (-sin_theta1)
        .mul_add(sin_theta3_from_theta1, cos_theta1 * cos_theta3_from_theta1);
    // r1__part^2; used 3 times
    let r1__part_sq = r1__part * r1__part;
    // cos(theta1)*cos(theta2_from_theta1) - sin(theta1)*sin(theta2_from_theta1)
    let r1__part_16 = (-sin_theta1)
        .mul_add(sin_theta2_from_theta1, cos_theta1 * cos_theta2_from_theta1);
    // 3*cos(theta1 + theta2_from_theta1); used 3 times
    let r1__part_16_scaled = S::int(3) * r1__part_16;
    // u3 + u4_from_u3
    let r1__part_17 = u3 + u4_from_u3;
    // r1__part_17^2; used 2 times
    let r1__part_17_sq = r1__part_17 * r1__part_17;
    // 2*u3; used 2 times
    let u3_scaled = S::int(2) * u3;
    // u3*u3_scaled; used 2 times
    let u3_u3_scaled = u3 * u3_scaled;
    // sin(theta2_from_theta1)*cos(theta3_from_theta1) - cos(theta2_from_theta1)*sin(theta3_from_theta1);
    //   used 2 times
    let r1__part_18 = (-cos_theta2_from_theta1)
        .mul_add(
            sin_theta3_from_theta1,
            sin_theta2_from_theta1 * cos_theta3_from_theta1,
        );
    // 2*sin(theta2_from_theta1 - theta3_from_theta1); used 2 times
    let r1__part_18_scaled = S::int(2) * r1__part_18;
    // u3^2*r1__part_5 + r1__part_14*(r1__part_5*u4_from_u3_sq + u5_from_u3_sq*sin(theta3_from_theta1) +
    //   r1__part_18_scaled*(u4_from_u3_sq - u5_from_u3_sq) + u3_scaled*(u5_from_u3*sin(theta3_from_theta1) +
    //   u4_from_u3*r1__part_5 + r1__part_18_scaled*(u4_from_u3 - u5_from_u3)))
    let r1__part_19 = u3 * u3 * r1__part_5
        + r1__part_14
            * (r1__part_5 * u4_from_u3_sq + u5_from_u3_sq * sin_theta3_from_theta1
                + r1__part_18_scaled * (u4_from_u3_sq - u5_from_u3_sq)
                + u3_scaled
                    * (u5_from_u3 * sin_theta3_from_theta1 + u4_from_u3 * r1__part_5
                        + r1__part_18_scaled * (u4_from_u3 - u5_from_u3)));
    // 6*sin(theta2_from_theta1 - theta3_from_theta1)*r1__part_sq + (r1__part_14*(2*sin(theta1) +
    //   sin(theta1 + theta3_from_theta1) + r1__part_12_scaled) - r1__part_12_scaled)*(cos(theta1 +
    //   theta3_from_theta1)*r1__part_sq + r1__part_16_scaled*r1__part_17_sq + u3_u3_scaled*cos(theta1))
    let r1__part_20 = (r1__part_14
        * (sin_theta1.mul_add(S::int(2), r1__part_13) + r1__part_12_scaled)
        - r1__part_12_scaled)
        * (r1__part_16_scaled.mul_add(r1__part_17_sq, r1__part_15 * r1__part_sq)
            + u3_u3_scaled * cos_theta1) + S::int(6) * r1__part_18 * r1__part_sq;
    // (r1__part_16_scaled - r1__part_14*(2*cos(theta1) + cos(theta1 + theta3_from_theta1) +
    //   r1__part_16_scaled))*(sin(theta1 + theta3_from_theta1)*r1__part_sq +
    //   r1__part_12_scaled*r1__part_17_sq + u3_u3_scaled*sin(theta1)) + 3*r1__part_19
    let r1__part_21 = (r1__part_16_scaled
        - r1__part_14
            * (cos_theta1.mul_add(S::int(2), r1__part_15) + r1__part_16_scaled))
        * (r1__part_12_scaled.mul_add(r1__part_17_sq, r1__part_13 * r1__part_sq)
            + u3_u3_scaled * sin_theta1) + S::int(3) * r1__part_19;
    // r1__part_20 + r1__part_21; used 2 times
    let r1__part_22 = r1__part_20 + r1__part_21;
    // 18*cos(theta2_from_theta1); used 2 times
    let r1__part_23 = S::int(18) * cos_theta2_from_theta1;
    // 33 - u3_part_3*r1__part_23 + cos(theta3_from_theta1)*(14 + r1__part_10 -
    //   r1__part_23*(u3_part*cos(theta2_from_theta1) + u3_part_3)); used 2 times
    let r1__part_24 = S::int(33) - u3_part_3 * r1__part_23
        + cos_theta3_from_theta1
            * (S::int(14) + r1__part_10
                - r1__part_23 * u3_part.mul_add(cos_theta2_from_theta1, u3_part_3));
    // 1/r1__part_24; used 2 times
    let r1__part_24_inv = S::int(1) / r1__part_24;
    // u3_part_8_inv*(u3*(cos(theta3_from_theta1)*(2*sin(theta3_from_theta1)*(9*u4_from_u3 + 8*r1__part -
    //   u3_part_2*r1__part_3) + r1__part_5*(u3*(13 + u3_part_6) + u3_part_7*r1__part_3 +
    //   6*u4_from_u3*r1__part_4 + u5_from_u3_scaled)) - 6*sin(theta2_from_theta1)*(3*u4_from_u3 + r1__part +
    //   u3_part_2*r1__part_2) - sin(theta3_from_theta1)*(13*u3 + 18*u4_from_u3 + u5_from_u3_scaled +
    //   u3_part_2*(3*u3*(5 + 2*cos(theta2_from_theta1)) + u5_from_u3_scaled + 2*u4_from_u3*r1__part_6))) +
    //   cos(theta3_from_theta1)*(sin(theta3_from_theta1)*(9*u4_from_u3_sq + 8*u5_from_u3_sq -
    //   u3_part_2*r1__part_8) + r1__part_5*(r1__part_8*cos(theta3_from_theta1) +
    //   r1__part_4*u4_from_u3_sq_scaled + u5_from_u3_sq_scaled)) -
    //   3*sin(theta3_from_theta1)*(cos(theta2_from_theta1)*(r1__part_6*u4_from_u3_sq + u5_from_u3_sq_scaled)
    //   + r1__part_9) - r1__part_5*(u3_part_2*r1__part_7 + r1__part_9)) +
    //   r1__part_11*r1__part_22*r1__part_24_inv
    let r1__part_25 = u3_part_8_inv
        * (u3
            * (cos_theta3_from_theta1
                * (S::int(2) * sin_theta3_from_theta1
                    * (r1__part.mul_add(S::int(8), S::int(9) * u4_from_u3)
                        - u3_part_2 * r1__part_3)
                    + r1__part_5
                        * (u3 * (S::int(13) + u3_part_6) + u3_part_7 * r1__part_3
                            + S::int(6) * u4_from_u3 * r1__part_4 + u5_from_u3_scaled))
                - S::int(6) * sin_theta2_from_theta1
                    * (u4_from_u3.mul_add(S::int(3), r1__part) + u3_part_2 * r1__part_2)
                - sin_theta3_from_theta1
                    * (S::int(13) * u3 + S::int(18) * u4_from_u3 + u5_from_u3_scaled
                        + u3_part_2
                            * (S::int(3) * u3
                                * cos_theta2_from_theta1.mul_add(S::int(2), S::int(5))
                                + u5_from_u3_scaled + S::int(2) * u4_from_u3 * r1__part_6)))
            + cos_theta3_from_theta1
                * (sin_theta3_from_theta1
                    * (u5_from_u3_sq.mul_add(S::int(8), S::int(9) * u4_from_u3_sq)
                        - u3_part_2 * r1__part_8)
                    + r1__part_5
                        * (r1__part_4
                            .mul_add(
                                u4_from_u3_sq_scaled,
                                r1__part_8 * cos_theta3_from_theta1,
                            ) + u5_from_u3_sq_scaled))
            - S::int(3) * sin_theta3_from_theta1
                * (cos_theta2_from_theta1
                    * r1__part_6.mul_add(u4_from_u3_sq, u5_from_u3_sq_scaled)
                    + r1__part_9)
            - r1__part_5 * u3_part_2.mul_add(r1__part_7, r1__part_9))
        + r1__part_11 * r1__part_22 * r1__part_24_inv;
    // Elimination, step by step.
    // r1_ = 7*(u3*(cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(u3*(13 + 6*cos(theta2_from_theta1))
    //   + 6*u4_from_u3*(3 + cos(theta2_from_theta1)) + 6*u5_from_u3 + 2*cos(theta3_from_theta1)*(2*u3 +
    //   u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   2*sin(theta3_from_theta1)*(8*u3 + 9*u4_from_u3 + 8*u5_from_u3 - 3*cos(theta2_from_theta1)*(2*u3 +
    //   u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3)))) -
    //   sin(theta3_from_theta1)*(13*u3 + 18*u4_from_u3 + 6*u5_from_u3 + 3*cos(theta2_from_theta1)*(3*u3*(5 +
    //   2*cos(theta2_from_theta1)) + 2*u4_from_u3*(10 + 3*cos(theta2_from_theta1)) + 6*u5_from_u3)) -
    //   6*sin(theta2_from_theta1)*(u3 + 3*u4_from_u3 + u5_from_u3 + 3*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(3*u4_from_u3^2*(3 +
    //   cos(theta2_from_theta1)) + 3*u5_from_u3^2 + cos(theta3_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) + sin(theta3_from_theta1)*(9*u4_from_u3^2
    //   + 8*u5_from_u3^2 - 3*cos(theta2_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) -
    //   3*sin(theta3_from_theta1)*(3*u4_from_u3^2 + u5_from_u3^2 + cos(theta2_from_theta1)*(u4_from_u3^2*(10
    //   + 3*cos(theta2_from_theta1)) + 3*u5_from_u3^2)) - 3*sin(theta2_from_theta1)*(3*u4_from_u3^2 +
    //   u5_from_u3^2 + 3*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/(750*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))) +
    //   7*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(9*u3^2*sin(theta2_from_theta1) + 6*sin(theta2_from_theta1 -
    //   theta3_from_theta1)*(u3 + u5_from_u3)^2 + 3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + ((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(2*u3^2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1)*(u3 + u4_from_u3)^2
    //   + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) + (3*cos(theta1 + theta2_from_theta1) - (7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))*(2*u3^2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1)*(u3 +
    //   u4_from_u3)^2 + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2))/(750*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))))
    let r1_ = S::ratio(7, 750) * r1__part_25;
    // Shared terms.
    // cos(theta2_from_theta1)*cos(theta3_from_theta1) + u3_part_3
    let u5_from_u3_dot_part = cos_theta2_from_theta1
        .mul_add(cos_theta3_from_theta1, u3_part_3);
    // Elimination, step by step.
    // u5_from_u3' = 375*r1_*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(14*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot = S::ratio(375, 14) * r1_ * r1__part_24
        / (S::int(9)
            + cos_theta3_from_theta1
                * (-(u5_from_u3_dot_part * cos_theta2_from_theta1))
                    .mul_add(S::int(9), S::int(5) * cos_theta3_from_theta1));
    // u4_from_u3' = (13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(9*u3^2*sin(theta2_from_theta1) +
    //   6*sin(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3)^2 + 3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + ((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(2*u3^2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1)*(u3 + u4_from_u3)^2
    //   + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) + (3*cos(theta1 + theta2_from_theta1) - (7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))*(2*u3^2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1)*(u3 +
    //   u4_from_u3)^2 + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) +
    //   u5_from_u3'*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))/(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1)
    //   - 33 - cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))
    let u4_from_u3_dot = -u3_part_8 * r1__part_24_inv
        * (u5_from_u3_dot * u3_part_8_inv).mul_add(r1__part_11, r1__part_22);
    [u4_from_u3_dot, u5_from_u3_dot]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 235 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 2],
) -> ([S; 3], [S; 2]) {
    let Parameters { H_n3, .. } = *p;
    let [theta2_from_theta1, theta3_from_theta1, theta1] = *q;
    let [u4_from_u3, u5_from_u3] = *u;
    // Sines and cosines.
    let (sin_theta3_from_theta1, cos_theta3_from_theta1) = theta3_from_theta1.sin_cos();
    let (sin_theta2_from_theta1, cos_theta2_from_theta1) = theta2_from_theta1.sin_cos();
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    // Shared terms.
    // 1 + cos(theta3_from_theta1); used 3 times
    let u3_part = S::int(1) + cos_theta3_from_theta1;
    // 3*cos(theta2_from_theta1); used 11 times
    let u3_part_2 = S::int(3) * cos_theta2_from_theta1;
    // sin(theta2_from_theta1)*sin(theta3_from_theta1); used 6 times
    let u3_part_3 = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // 3*u3_part_3; used 4 times
    let u3_part_3_scaled = S::int(3) * u3_part_3;
    // 7 + u3_part*u3_part_2 + u3_part_3_scaled; used 2 times
    let u3_part_4 = u3_part.mul_add(u3_part_2, S::int(7)) + u3_part_3_scaled;
    // u5_from_u3*(3 + cos(theta3_from_theta1)*(1 + u3_part_2) + u3_part_3_scaled) + u4_from_u3*u3_part_4
    let u3_part_5 = u5_from_u3
        * (S::int(3) + cos_theta3_from_theta1 * (S::int(1) + u3_part_2)
            + u3_part_3_scaled) + u4_from_u3 * u3_part_4;
    // 6*cos(theta2_from_theta1); used 4 times
    let u3_part_6 = S::int(6) * cos_theta2_from_theta1;
    // 2*cos(theta3_from_theta1); used 3 times
    let u3_part_7 = S::int(2) * cos_theta3_from_theta1;
    // 6*u3_part_3; used 2 times
    let u3_part_3_scaled_2 = S::int(6) * u3_part_3;
    // 13 + u3_part*u3_part_6 + u3_part_7 + u3_part_3_scaled_2; used 2 times
    let u3_part_8 = u3_part.mul_add(u3_part_6, S::int(13)) + u3_part_7
        + u3_part_3_scaled_2;
    // 1/u3_part_8; used 4 times
    let u3_part_8_inv = S::int(1) / u3_part_8;
    // Elimination, step by step.
    // u3 = (750*H_n3 - 7*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 7*u5_from_u3*(3 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1))))/(7*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))
    let u3 = S::ratio(1, 7) * u3_part_8_inv
        * (-u3_part_5).mul_add(S::int(7), S::int(750) * H_n3);
    // Shared terms.
    // u3 + u5_from_u3; used 5 times
    let r1__part = u3 + u5_from_u3;
    // u4_from_u3 + r1__part; used 2 times
    let r1__part_2 = u4_from_u3 + r1__part;
    // u4_from_u3 + 2*r1__part + u3_part_6*r1__part_2; used 2 times
    let r1__part_3 = r1__part.mul_add(S::int(2), u4_from_u3) + u3_part_6 * r1__part_2;
    // 3 + cos(theta2_from_theta1); used 2 times
    let r1__part_4 = S::int(3) + cos_theta2_from_theta1;
    // 6*u5_from_u3; used 3 times
    let u5_from_u3_scaled = S::int(6) * u5_from_u3;
    // 3*sin(theta2_from_theta1); used 6 times
    let r1__part_5 = S::int(3) * sin_theta2_from_theta1;
    // 10 + u3_part_2; used 2 times
    let r1__part_6 = S::int(10) + u3_part_2;
    // u4_from_u3^2; used 7 times
    let u4_from_u3_sq = u4_from_u3 * u4_from_u3;
    // u5_from_u3^2; used 7 times
    let u5_from_u3_sq = u5_from_u3 * u5_from_u3;
    // u4_from_u3_sq + u5_from_u3_sq; used 2 times
    let r1__part_7 = u4_from_u3_sq + u5_from_u3_sq;
    // u4_from_u3_sq + 2*u5_from_u3_sq + u3_part_6*r1__part_7; used 2 times
    let r1__part_8 = u5_from_u3_sq.mul_add(S::int(2), u4_from_u3_sq)
        + u3_part_6 * r1__part_7;
    // 3*u4_from_u3_sq; used 2 times
    let u4_from_u3_sq_scaled = S::int(3) * u4_from_u3_sq;
    // 3*u5_from_u3_sq; used 2 times
    let u5_from_u3_sq_scaled = S::int(3) * u5_from_u3_sq;
    // u5_from_u3_sq + u4_from_u3_sq_scaled; used 2 times
    let r1__part_9 = u5_from_u3_sq + u4_from_u3_sq_scaled;
    // 9*cos(theta3_from_theta1); used 2 times
    let r1__part_10 = S::int(9) * cos_theta3_from_theta1;
    // 9*u3_part_3 - 12 + u3_part_2*(u3_part_3_scaled - 3 - u3_part_2 + cos(theta3_from_theta1)*(2 +
    //   cos(theta3_from_theta1) + u3_part_2*(1 + u3_part_7) + u3_part_3_scaled_2)) +
    //   cos(theta3_from_theta1)*(u3_part_3_scaled - 7 - r1__part_10); used 2 times
    let r1__part_11 = -S::int(12) + S::int(9) * u3_part_3
        + u3_part_2
            * (u3_part_3_scaled - S::int(3) - u3_part_2
                + cos_theta3_from_theta1
                    * (S::int(2) + cos_theta3_from_theta1
                        + u3_part_2 * (S::int(1) + u3_part_7) + u3_part_3_scaled_2))
        + cos_theta3_from_theta1 * (u3_part_3_scaled - S::int(7) - r1__part_10);
    // cos(theta1)*sin(theta2_from_theta1) + sin(theta1)*cos(theta2_from_theta1)
    let r1__part_12 = sin_theta1
        .mul_add(cos_theta2_from_theta1, cos_theta1 * sin_theta2_from_theta1);
    // 3*sin(theta1 + theta2_from_theta1); used 3 times
    let r1__part_12_scaled = S::int(3) * r1__part_12;
    // cos(theta1)*sin(theta3_from_theta1) + sin(theta1)*cos(theta3_from_theta1); used 2 times
    let r1__part_13 = sin_theta1
        .mul_add(cos_theta3_from_theta1, cos_theta1 * sin_theta3_from_theta1);
    // u3_part_4*u3_part_8_inv; used 3 times
    let r1__part_14 = u3_part_4 * u3_part_8_inv;
    // cos(theta1)*cos(theta3_from_theta1) - sin(theta1)*sin(theta3_from_theta1); used 2 times
    let r1__part_15 = (-sin_theta1)
        .mul_add(sin_theta3_from_theta1, cos_theta1 * cos_theta3_from_theta1);
    // r1__part^2; used 3 times
    let r1__part_sq = r1__part * r1__part;
    // cos(theta1)*cos(theta2_from_theta1) - sin(theta1)*sin(theta2_from_theta1)
    let r1__part_16 = (-sin_theta1)
        .mul_add(sin_theta2_from_theta1, cos_theta1 * cos_theta2_from_theta1);
    // 3*cos(theta1 + theta2_from_theta1); used 3 times
    let r1__part_16_scaled = S::int(3) * r1__part_16;
    // u3 + u4_from_u3
    let r1__part_17 = u3 + u4_from_u3;
    // r1__part_17^2; used 2 times
    let r1__part_17_sq = r1__part_17 * r1__part_17;
    // 2*u3; used 2 times
    let u3_scaled = S::int(2) * u3;
    // u3*u3_scaled; used 2 times
    let u3_u3_scaled = u3 * u3_scaled;
    // sin(theta2_from_theta1)*cos(theta3_from_theta1) - cos(theta2_from_theta1)*sin(theta3_from_theta1);
    //   used 2 times
    let r1__part_18 = (-cos_theta2_from_theta1)
        .mul_add(
            sin_theta3_from_theta1,
            sin_theta2_from_theta1 * cos_theta3_from_theta1,
        );
    // 2*sin(theta2_from_theta1 - theta3_from_theta1); used 2 times
    let r1__part_18_scaled = S::int(2) * r1__part_18;
    // u3^2*r1__part_5 + r1__part_14*(r1__part_5*u4_from_u3_sq + u5_from_u3_sq*sin(theta3_from_theta1) +
    //   r1__part_18_scaled*(u4_from_u3_sq - u5_from_u3_sq) + u3_scaled*(u5_from_u3*sin(theta3_from_theta1) +
    //   u4_from_u3*r1__part_5 + r1__part_18_scaled*(u4_from_u3 - u5_from_u3)))
    let r1__part_19 = u3 * u3 * r1__part_5
        + r1__part_14
            * (r1__part_5 * u4_from_u3_sq + u5_from_u3_sq * sin_theta3_from_theta1
                + r1__part_18_scaled * (u4_from_u3_sq - u5_from_u3_sq)
                + u3_scaled
                    * (u5_from_u3 * sin_theta3_from_theta1 + u4_from_u3 * r1__part_5
                        + r1__part_18_scaled * (u4_from_u3 - u5_from_u3)));
    // 6*sin(theta2_from_theta1 - theta3_from_theta1)*r1__part_sq + (r1__part_14*(2*sin(theta1) +
    //   sin(theta1 + theta3_from_theta1) + r1__part_12_scaled) - r1__part_12_scaled)*(cos(theta1 +
    //   theta3_from_theta1)*r1__part_sq + r1__part_16_scaled*r1__part_17_sq + u3_u3_scaled*cos(theta1))
    let r1__part_20 = (r1__part_14
        * (sin_theta1.mul_add(S::int(2), r1__part_13) + r1__part_12_scaled)
        - r1__part_12_scaled)
        * (r1__part_16_scaled.mul_add(r1__part_17_sq, r1__part_15 * r1__part_sq)
            + u3_u3_scaled * cos_theta1) + S::int(6) * r1__part_18 * r1__part_sq;
    // (r1__part_16_scaled - r1__part_14*(2*cos(theta1) + cos(theta1 + theta3_from_theta1) +
    //   r1__part_16_scaled))*(sin(theta1 + theta3_from_theta1)*r1__part_sq +
    //   r1__part_12_scaled*r1__part_17_sq + u3_u3_scaled*sin(theta1)) + 3*r1__part_19
    let r1__part_21 = (r1__part_16_scaled
        - r1__part_14
            * (cos_theta1.mul_add(S::int(2), r1__part_15) + r1__part_16_scaled))
        * (r1__part_12_scaled.mul_add(r1__part_17_sq, r1__part_13 * r1__part_sq)
            + u3_u3_scaled * sin_theta1) + S::int(3) * r1__part_19;
    // r1__part_20 + r1__part_21; used 2 times
    let r1__part_22 = r1__part_20 + r1__part_21;
    // 18*cos(theta2_from_theta1); used 2 times
    let r1__part_23 = S::int(18) * cos_theta2_from_theta1;
    // 33 - u3_part_3*r1__part_23 + cos(theta3_from_theta1)*(14 + r1__part_10 -
    //   r1__part_23*(u3_part*cos(theta2_from_theta1) + u3_part_3)); used 2 times
    let r1__part_24 = S::int(33) - u3_part_3 * r1__part_23
        + cos_theta3_from_theta1
            * (S::int(14) + r1__part_10
                - r1__part_23 * u3_part.mul_add(cos_theta2_from_theta1, u3_part_3));
    // 1/r1__part_24; used 2 times
    let r1__part_24_inv = S::int(1) / r1__part_24;
    // u3_part_8_inv*(u3*(cos(theta3_from_theta1)*(2*sin(theta3_from_theta1)*(9*u4_from_u3 + 8*r1__part -
    //   u3_part_2*r1__part_3) + r1__part_5*(u3*(13 + u3_part_6) + u3_part_7*r1__part_3 +
    //   6*u4_from_u3*r1__part_4 + u5_from_u3_scaled)) - 6*sin(theta2_from_theta1)*(3*u4_from_u3 + r1__part +
    //   u3_part_2*r1__part_2) - sin(theta3_from_theta1)*(13*u3 + 18*u4_from_u3 + u5_from_u3_scaled +
    //   u3_part_2*(3*u3*(5 + 2*cos(theta2_from_theta1)) + u5_from_u3_scaled + 2*u4_from_u3*r1__part_6))) +
    //   cos(theta3_from_theta1)*(sin(theta3_from_theta1)*(9*u4_from_u3_sq + 8*u5_from_u3_sq -
    //   u3_part_2*r1__part_8) + r1__part_5*(r1__part_8*cos(theta3_from_theta1) +
    //   r1__part_4*u4_from_u3_sq_scaled + u5_from_u3_sq_scaled)) -
    //   3*sin(theta3_from_theta1)*(cos(theta2_from_theta1)*(r1__part_6*u4_from_u3_sq + u5_from_u3_sq_scaled)
    //   + r1__part_9) - r1__part_5*(u3_part_2*r1__part_7 + r1__part_9)) +
    //   r1__part_11*r1__part_22*r1__part_24_inv
    let r1__part_25 = u3_part_8_inv
        * (u3
            * (cos_theta3_from_theta1
                * (S::int(2) * sin_theta3_from_theta1
                    * (r1__part.mul_add(S::int(8), S::int(9) * u4_from_u3)
                        - u3_part_2 * r1__part_3)
                    + r1__part_5
                        * (u3 * (S::int(13) + u3_part_6) + u3_part_7 * r1__part_3
                            + S::int(6) * u4_from_u3 * r1__part_4 + u5_from_u3_scaled))
                - S::int(6) * sin_theta2_from_theta1
                    * (u4_from_u3.mul_add(S::int(3), r1__part) + u3_part_2 * r1__part_2)
                - sin_theta3_from_theta1
                    * (S::int(13) * u3 + S::int(18) * u4_from_u3 + u5_from_u3_scaled
                        + u3_part_2
                            * (S::int(3) * u3
                                * cos_theta2_from_theta1.mul_add(S::int(2), S::int(5))
                                + u5_from_u3_scaled + S::int(2) * u4_from_u3 * r1__part_6)))
            + cos_theta3_from_theta1
                * (sin_theta3_from_theta1
                    * (u5_from_u3_sq.mul_add(S::int(8), S::int(9) * u4_from_u3_sq)
                        - u3_part_2 * r1__part_8)
                    + r1__part_5
                        * (r1__part_4
                            .mul_add(
                                u4_from_u3_sq_scaled,
                                r1__part_8 * cos_theta3_from_theta1,
                            ) + u5_from_u3_sq_scaled))
            - S::int(3) * sin_theta3_from_theta1
                * (cos_theta2_from_theta1
                    * r1__part_6.mul_add(u4_from_u3_sq, u5_from_u3_sq_scaled)
                    + r1__part_9)
            - r1__part_5 * u3_part_2.mul_add(r1__part_7, r1__part_9))
        + r1__part_11 * r1__part_22 * r1__part_24_inv;
    // Elimination, step by step.
    // r1_ = 7*(u3*(cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(u3*(13 + 6*cos(theta2_from_theta1))
    //   + 6*u4_from_u3*(3 + cos(theta2_from_theta1)) + 6*u5_from_u3 + 2*cos(theta3_from_theta1)*(2*u3 +
    //   u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   2*sin(theta3_from_theta1)*(8*u3 + 9*u4_from_u3 + 8*u5_from_u3 - 3*cos(theta2_from_theta1)*(2*u3 +
    //   u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3)))) -
    //   sin(theta3_from_theta1)*(13*u3 + 18*u4_from_u3 + 6*u5_from_u3 + 3*cos(theta2_from_theta1)*(3*u3*(5 +
    //   2*cos(theta2_from_theta1)) + 2*u4_from_u3*(10 + 3*cos(theta2_from_theta1)) + 6*u5_from_u3)) -
    //   6*sin(theta2_from_theta1)*(u3 + 3*u4_from_u3 + u5_from_u3 + 3*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(3*u4_from_u3^2*(3 +
    //   cos(theta2_from_theta1)) + 3*u5_from_u3^2 + cos(theta3_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) + sin(theta3_from_theta1)*(9*u4_from_u3^2
    //   + 8*u5_from_u3^2 - 3*cos(theta2_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) -
    //   3*sin(theta3_from_theta1)*(3*u4_from_u3^2 + u5_from_u3^2 + cos(theta2_from_theta1)*(u4_from_u3^2*(10
    //   + 3*cos(theta2_from_theta1)) + 3*u5_from_u3^2)) - 3*sin(theta2_from_theta1)*(3*u4_from_u3^2 +
    //   u5_from_u3^2 + 3*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/(750*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))) +
    //   7*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(9*u3^2*sin(theta2_from_theta1) + 6*sin(theta2_from_theta1 -
    //   theta3_from_theta1)*(u3 + u5_from_u3)^2 + 3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + ((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(2*u3^2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1)*(u3 + u4_from_u3)^2
    //   + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) + (3*cos(theta1 + theta2_from_theta1) - (7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))*(2*u3^2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1)*(u3 +
    //   u4_from_u3)^2 + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2))/(750*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))))
    let r1_ = S::ratio(7, 750) * r1__part_25;
    // Shared terms.
    // cos(theta2_from_theta1)*cos(theta3_from_theta1) + u3_part_3
    let u5_from_u3_dot_part = cos_theta2_from_theta1
        .mul_add(cos_theta3_from_theta1, u3_part_3);
    // Elimination, step by step.
    // u5_from_u3' = 375*r1_*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(14*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot = S::ratio(375, 14) * r1_ * r1__part_24
        / (S::int(9)
            + cos_theta3_from_theta1
                * (-(u5_from_u3_dot_part * cos_theta2_from_theta1))
                    .mul_add(S::int(9), S::int(5) * cos_theta3_from_theta1));
    // u4_from_u3' = (13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(9*u3^2*sin(theta2_from_theta1) +
    //   6*sin(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3)^2 + 3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + ((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(2*u3^2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1)*(u3 + u4_from_u3)^2
    //   + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) + (3*cos(theta1 + theta2_from_theta1) - (7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))*(2*u3^2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1)*(u3 +
    //   u4_from_u3)^2 + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) +
    //   u5_from_u3'*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))/(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1)
    //   - 33 - cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))
    let u4_from_u3_dot = -u3_part_8 * r1__part_24_inv
        * (u5_from_u3_dot * u3_part_8_inv).mul_add(r1__part_11, r1__part_22);
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
/// 848 operations, 3 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [[S; 5]; 5] {
    let Parameters { H_n3, .. } = *p;
    let [theta2_from_theta1, theta3_from_theta1, theta1] = *q;
    let [u4_from_u3, u5_from_u3] = *u;
    let zero = S::int(0);
    // Sines and cosines.
    let (sin_theta3_from_theta1, cos_theta3_from_theta1) = theta3_from_theta1.sin_cos();
    let (sin_theta2_from_theta1, cos_theta2_from_theta1) = theta2_from_theta1.sin_cos();
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    // Shared terms.
    // 1 + cos(theta3_from_theta1); used 5 times
    let u3_part = S::int(1) + cos_theta3_from_theta1;
    // 3*cos(theta2_from_theta1); used 29 times
    let u3_part_2 = S::int(3) * cos_theta2_from_theta1;
    // 3*sin(theta2_from_theta1); used 21 times
    let u3_part_3 = S::int(3) * sin_theta2_from_theta1;
    // u3_part_3*sin(theta3_from_theta1); used 5 times
    let u3_part_4 = u3_part_3 * sin_theta3_from_theta1;
    // 7 + u3_part*u3_part_2 + u3_part_4; used 2 times
    let u3_part_5 = u3_part.mul_add(u3_part_2, S::int(7)) + u3_part_4;
    // 7*u4_from_u3; used 7 times
    let u4_from_u3_scaled = S::int(7) * u4_from_u3;
    // 1 + u3_part_2; used 6 times
    let u3_part_6 = S::int(1) + u3_part_2;
    // 3 + u3_part_4 + u3_part_6*cos(theta3_from_theta1); used 2 times
    let u3_part_7 = u3_part_6.mul_add(cos_theta3_from_theta1, S::int(3) + u3_part_4);
    // 7*u5_from_u3; used 4 times
    let u5_from_u3_scaled = S::int(7) * u5_from_u3;
    // 6*cos(theta2_from_theta1); used 13 times
    let u3_part_8 = S::int(6) * cos_theta2_from_theta1;
    // 2*cos(theta3_from_theta1); used 11 times
    let u3_part_9 = S::int(2) * cos_theta3_from_theta1;
    // 6*sin(theta2_from_theta1); used 11 times
    let u3_part_10 = S::int(6) * sin_theta2_from_theta1;
    // u3_part_10*sin(theta3_from_theta1); used 2 times
    let u3_part_11 = u3_part_10 * sin_theta3_from_theta1;
    // 13 + u3_part*u3_part_8 + u3_part_9 + u3_part_11; used 2 times
    let u3_part_12 = u3_part.mul_add(u3_part_8, S::int(13)) + u3_part_9 + u3_part_11;
    // 1/u3_part_12; used 9 times
    let u3_part_12_inv = S::int(1) / u3_part_12;
    // Elimination, step by step.
    // u3 = (750*H_n3 - 7*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 7*u5_from_u3*(3 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1))))/(7*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))
    let u3 = S::ratio(1, 7) * u3_part_12_inv
        * ((-u3_part_5).mul_add(u4_from_u3_scaled, S::int(750) * H_n3)
            - u3_part_7 * u5_from_u3_scaled);
    // Shared terms.
    // 13 + u3_part_8; used 5 times
    let r1__part = S::int(13) + u3_part_8;
    // 3 + cos(theta2_from_theta1); used 3 times
    let r1__part_2 = S::int(3) + cos_theta2_from_theta1;
    // u3 + u4_from_u3; used 13 times
    let r1__part_3 = u3 + u4_from_u3;
    // u5_from_u3 + r1__part_3; used 3 times
    let r1__part_4 = u5_from_u3 + r1__part_3;
    // 2*u3; used 7 times
    let u3_scaled = S::int(2) * u3;
    // u4_from_u3 + u3_scaled; used 4 times
    let r1__part_5 = u4_from_u3 + u3_scaled;
    // 2*u5_from_u3 + u3_part_8*r1__part_4 + r1__part_5; used 4 times
    let r1__part_6 = u3_part_8.mul_add(r1__part_4, S::int(2) * u5_from_u3) + r1__part_5;
    // 6*u5_from_u3; used 3 times
    let u5_from_u3_scaled_2 = S::int(6) * u5_from_u3;
    // u3*r1__part + 6*u4_from_u3*r1__part_2 + u3_part_9*r1__part_6 + u5_from_u3_scaled_2; used 2 times
    let r1__part_7 = (u4_from_u3 * r1__part_2).mul_add(S::int(6), u3 * r1__part)
        + u3_part_9 * r1__part_6 + u5_from_u3_scaled_2;
    // u3 + u5_from_u3; used 8 times
    let r1__part_8 = u3 + u5_from_u3;
    // 9*u4_from_u3 - u3_part_2*r1__part_6 + 8*r1__part_8; used 2 times
    let r1__part_9 = (-u3_part_2).mul_add(r1__part_6, S::int(9) * u4_from_u3)
        + S::int(8) * r1__part_8;
    // 2*sin(theta3_from_theta1); used 6 times
    let r1__part_10 = S::int(2) * sin_theta3_from_theta1;
    // u3_part_3*r1__part_7 + r1__part_9*r1__part_10; used 2 times
    let r1__part_11 = r1__part_9.mul_add(r1__part_10, u3_part_3 * r1__part_7);
    // 2*cos(theta2_from_theta1); used 3 times
    let r1__part_12 = S::int(2) * cos_theta2_from_theta1;
    // 5 + r1__part_12; used 4 times
    let r1__part_13 = S::int(5) + r1__part_12;
    // 3*r1__part_13; used 2 times
    let r1__part_13_scaled = S::int(3) * r1__part_13;
    // 10 + u3_part_2; used 2 times
    let r1__part_14 = S::int(10) + u3_part_2;
    // u4_from_u3*r1__part_14; used 2 times
    let r1__part_15 = u4_from_u3 * r1__part_14;
    // u5_from_u3_scaled_2 + u3*r1__part_13_scaled + 2*r1__part_15; used 2 times
    let r1__part_16 = u3.mul_add(r1__part_13_scaled, u5_from_u3_scaled_2)
        + S::int(2) * r1__part_15;
    // 13*u3; used 2 times
    let u3_scaled_2 = S::int(13) * u3;
    // 18*u4_from_u3 + u5_from_u3_scaled_2 + u3_part_2*r1__part_16 + u3_scaled_2; used 2 times
    let r1__part_17 = u4_from_u3.mul_add(S::int(18), u5_from_u3_scaled_2)
        + u3_part_2 * r1__part_16 + u3_scaled_2;
    // 3*u4_from_u3; used 4 times
    let u4_from_u3_scaled_2 = S::int(3) * u4_from_u3;
    // u3_part_2*r1__part_4 + r1__part_8 + u4_from_u3_scaled_2; used 2 times
    let r1__part_18 = u3_part_2.mul_add(r1__part_4, r1__part_8) + u4_from_u3_scaled_2;
    // r1__part_11*cos(theta3_from_theta1) - r1__part_17*sin(theta3_from_theta1) - u3_part_10*r1__part_18;
    //   used 5 times
    let r1__part_19 = (-r1__part_17)
        .mul_add(sin_theta3_from_theta1, r1__part_11 * cos_theta3_from_theta1)
        - u3_part_10 * r1__part_18;
    // u4_from_u3^2; used 9 times
    let u4_from_u3_sq = u4_from_u3 * u4_from_u3;
    // u5_from_u3^2; used 8 times
    let u5_from_u3_sq = u5_from_u3 * u5_from_u3;
    // u4_from_u3_sq + u5_from_u3_sq; used 3 times
    let r1__part_20 = u4_from_u3_sq + u5_from_u3_sq;
    // u4_from_u3_sq + 2*u5_from_u3_sq + u3_part_8*r1__part_20; used 4 times
    let r1__part_21 = u5_from_u3_sq.mul_add(S::int(2), u4_from_u3_sq)
        + u3_part_8 * r1__part_20;
    // 9*u4_from_u3_sq + 8*u5_from_u3_sq - u3_part_2*r1__part_21; used 2 times
    let r1__part_22 = u5_from_u3_sq.mul_add(S::int(8), S::int(9) * u4_from_u3_sq)
        - u3_part_2 * r1__part_21;
    // 3*u4_from_u3_sq; used 2 times
    let u4_from_u3_sq_scaled = S::int(3) * u4_from_u3_sq;
    // 3*u5_from_u3_sq; used 2 times
    let u5_from_u3_sq_scaled = S::int(3) * u5_from_u3_sq;
    // r1__part_21*cos(theta3_from_theta1) + r1__part_2*u4_from_u3_sq_scaled + u5_from_u3_sq_scaled; used 2
    //   times
    let r1__part_23 = r1__part_2
        .mul_add(u4_from_u3_sq_scaled, r1__part_21 * cos_theta3_from_theta1)
        + u5_from_u3_sq_scaled;
    // r1__part_22*sin(theta3_from_theta1) + u3_part_3*r1__part_23; used 2 times
    let r1__part_24 = u3_part_3
        .mul_add(r1__part_23, r1__part_22 * sin_theta3_from_theta1);
    // u5_from_u3_sq + u4_from_u3_sq_scaled; used 2 times
    let r1__part_25 = u5_from_u3_sq + u4_from_u3_sq_scaled;
    // u3_part_2*r1__part_20 + r1__part_25; used 2 times
    let r1__part_26 = u3_part_2.mul_add(r1__part_20, r1__part_25);
    // r1__part_14*u4_from_u3_sq + u5_from_u3_sq_scaled; used 2 times
    let r1__part_27 = r1__part_14.mul_add(u4_from_u3_sq, u5_from_u3_sq_scaled);
    // r1__part_25 + r1__part_27*cos(theta2_from_theta1); used 2 times
    let r1__part_28 = r1__part_27.mul_add(cos_theta2_from_theta1, r1__part_25);
    // 3*sin(theta3_from_theta1); used 3 times
    let r1__part_29 = S::int(3) * sin_theta3_from_theta1;
    // u3*r1__part_19 + r1__part_24*cos(theta3_from_theta1) - u3_part_3*r1__part_26 -
    //   r1__part_28*r1__part_29; used 2 times
    let r1__part_30 = r1__part_24.mul_add(cos_theta3_from_theta1, u3 * r1__part_19)
        - u3_part_3 * r1__part_26 - r1__part_28 * r1__part_29;
    // 7*u3_part_12_inv/750; used 5 times
    let u3_part_12_inv_scaled = S::ratio(7, 750) * u3_part_12_inv;
    // cos(theta1)*cos(theta3_from_theta1) - sin(theta1)*sin(theta3_from_theta1); used 5 times
    let r1__part_31 = (-sin_theta1)
        .mul_add(sin_theta3_from_theta1, cos_theta1 * cos_theta3_from_theta1);
    // cos(theta1)*cos(theta2_from_theta1) - sin(theta1)*sin(theta2_from_theta1); used 3 times
    let r1__part_32 = (-sin_theta1)
        .mul_add(sin_theta2_from_theta1, cos_theta1 * cos_theta2_from_theta1);
    // 3*cos(theta1 + theta2_from_theta1); used 3 times
    let r1__part_32_scaled = S::int(3) * r1__part_32;
    // 2*cos(theta1) + cos(theta1 + theta3_from_theta1) + r1__part_32_scaled; used 3 times
    let r1__part_33 = cos_theta1.mul_add(S::int(2), r1__part_31) + r1__part_32_scaled;
    // u3_part_5*u3_part_12_inv; used 10 times
    let r1__part_34 = u3_part_5 * u3_part_12_inv;
    // r1__part_32_scaled - r1__part_33*r1__part_34; used 5 times
    let r1__part_35 = (-r1__part_33).mul_add(r1__part_34, r1__part_32_scaled);
    // u3_scaled*sin(theta1); used 3 times
    let sin_theta1_u3_scaled = u3_scaled * sin_theta1;
    // cos(theta1)*sin(theta3_from_theta1) + sin(theta1)*cos(theta3_from_theta1); used 5 times
    let r1__part_36 = sin_theta1
        .mul_add(cos_theta3_from_theta1, cos_theta1 * sin_theta3_from_theta1);
    // r1__part_8^2; used 3 times
    let r1__part_8_sq = r1__part_8 * r1__part_8;
    // sin(theta1 + theta3_from_theta1)*r1__part_8_sq; used 2 times
    let r1__part_37 = r1__part_36 * r1__part_8_sq;
    // cos(theta1)*sin(theta2_from_theta1) + sin(theta1)*cos(theta2_from_theta1); used 3 times
    let r1__part_38 = sin_theta1
        .mul_add(cos_theta2_from_theta1, cos_theta1 * sin_theta2_from_theta1);
    // 3*r1__part_3; used 2 times
    let r1__part_3_scaled = S::int(3) * r1__part_3;
    // sin(theta1 + theta2_from_theta1)*r1__part_3_scaled; used 3 times
    let r1__part_39 = r1__part_38 * r1__part_3_scaled;
    // r1__part_3*r1__part_39; used 2 times
    let r1__part_40 = r1__part_3 * r1__part_39;
    // u3*sin_theta1_u3_scaled + r1__part_37 + r1__part_40; used 3 times
    let r1__part_41 = u3.mul_add(sin_theta1_u3_scaled, r1__part_37) + r1__part_40;
    // u4_from_u3 - u5_from_u3; used 2 times
    let r1__part_42 = u4_from_u3 - u5_from_u3;
    // cos(theta2_from_theta1)*sin(theta3_from_theta1); used 7 times
    let r1__part_43 = cos_theta2_from_theta1 * sin_theta3_from_theta1;
    // sin(theta2_from_theta1)*cos(theta3_from_theta1); used 3 times
    let r1__part_44 = sin_theta2_from_theta1 * cos_theta3_from_theta1;
    // r1__part_43 - r1__part_44; used 5 times
    let r1__part_45 = r1__part_43 - r1__part_44;
    // -r1__part_45; used 3 times
    let r1__part_45_scaled = -r1__part_45;
    // 2*sin(theta2_from_theta1 - theta3_from_theta1); used 5 times
    let r1__part_45_scaled_scaled = S::int(2) * r1__part_45_scaled;
    // u5_from_u3*sin(theta3_from_theta1) + u4_from_u3*u3_part_3 + r1__part_42*r1__part_45_scaled_scaled;
    //   used 5 times
    let r1__part_46 = u4_from_u3.mul_add(u3_part_3, u5_from_u3 * sin_theta3_from_theta1)
        + r1__part_42 * r1__part_45_scaled_scaled;
    // u4_from_u3_sq - u5_from_u3_sq; used 2 times
    let r1__part_47 = u4_from_u3_sq - u5_from_u3_sq;
    // u3_part_3*u4_from_u3_sq + u5_from_u3_sq*sin(theta3_from_theta1) + u3_scaled*r1__part_46 +
    //   r1__part_45_scaled_scaled*r1__part_47; used 3 times
    let r1__part_48 = u5_from_u3_sq
        .mul_add(sin_theta3_from_theta1, u3_part_3 * u4_from_u3_sq)
        + u3_scaled * r1__part_46 + r1__part_45_scaled_scaled * r1__part_47;
    // 3*r1__part_34; used 5 times
    let r1__part_34_scaled = S::int(3) * r1__part_34;
    // 6*r1__part_8_sq; used 2 times
    let r1__part_8_sq_scaled = S::int(6) * r1__part_8_sq;
    // 3*sin(theta1 + theta2_from_theta1); used 3 times
    let r1__part_38_scaled = S::int(3) * r1__part_38;
    // 2*sin(theta1) + sin(theta1 + theta3_from_theta1) + r1__part_38_scaled; used 3 times
    let r1__part_49 = sin_theta1.mul_add(S::int(2), r1__part_36) + r1__part_38_scaled;
    // r1__part_38_scaled - r1__part_34*r1__part_49; used 5 times
    let r1__part_50 = (-r1__part_34).mul_add(r1__part_49, r1__part_38_scaled);
    // u3_scaled*cos(theta1); used 3 times
    let cos_theta1_u3_scaled = u3_scaled * cos_theta1;
    // cos(theta1 + theta3_from_theta1)*r1__part_8_sq; used 2 times
    let r1__part_51 = r1__part_31 * r1__part_8_sq;
    // cos(theta1 + theta2_from_theta1)*r1__part_3_scaled; used 3 times
    let r1__part_52 = r1__part_32 * r1__part_3_scaled;
    // r1__part_3*r1__part_52; used 2 times
    let r1__part_53 = r1__part_3 * r1__part_52;
    // u3*cos_theta1_u3_scaled + r1__part_51 + r1__part_53; used 3 times
    let r1__part_54 = u3.mul_add(cos_theta1_u3_scaled, r1__part_51) + r1__part_53;
    // 9*sin(theta2_from_theta1); used 6 times
    let r1__part_55 = S::int(9) * sin_theta2_from_theta1;
    // u3^2; used 2 times
    let u3_sq = u3 * u3;
    // r1__part_55*u3_sq - r1__part_50*r1__part_54
    let r1__part_56 = (-r1__part_50).mul_add(r1__part_54, r1__part_55 * u3_sq);
    // r1__part_35*r1__part_41 + r1__part_48*r1__part_34_scaled
    let r1__part_57 = r1__part_48.mul_add(r1__part_34_scaled, r1__part_35 * r1__part_41);
    // sin(theta2_from_theta1 - theta3_from_theta1)*r1__part_8_sq_scaled + r1__part_56
    let r1__part_58 = r1__part_45_scaled.mul_add(r1__part_8_sq_scaled, r1__part_56);
    // r1__part_57 + r1__part_58; used 3 times
    let r1__part_59 = r1__part_57 + r1__part_58;
    // 9*cos(theta3_from_theta1); used 3 times
    let r1__part_60 = S::int(9) * cos_theta3_from_theta1;
    // 7 + r1__part_60; used 2 times
    let r1__part_61 = S::int(7) + r1__part_60;
    // r1__part_61 - u3_part_4; used 2 times
    let r1__part_62 = r1__part_61 - u3_part_4;
    // 1 + u3_part_9; used 3 times
    let r1__part_63 = S::int(1) + u3_part_9;
    // 2 + u3_part_2*r1__part_63
    let r1__part_64 = u3_part_2.mul_add(r1__part_63, S::int(2));
    // cos(theta3_from_theta1) + r1__part_64; used 2 times
    let r1__part_65 = cos_theta3_from_theta1 + r1__part_64;
    // u3_part_11 + r1__part_65; used 2 times
    let r1__part_66 = u3_part_11 + r1__part_65;
    // 3 + u3_part_2 - u3_part_4 - r1__part_66*cos(theta3_from_theta1); used 2 times
    let r1__part_67 = (-r1__part_66)
        .mul_add(cos_theta3_from_theta1, S::int(3) + u3_part_2 - u3_part_4);
    // r1__part_55*sin(theta3_from_theta1) - 12 - r1__part_62*cos(theta3_from_theta1) -
    //   u3_part_2*r1__part_67; used 3 times
    let r1__part_68 = r1__part_55.mul_add(sin_theta3_from_theta1, -S::int(12))
        - r1__part_62 * cos_theta3_from_theta1 - u3_part_2 * r1__part_67;
    // sin(theta2_from_theta1)*sin(theta3_from_theta1); used 3 times
    let r1__part_69 = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // u3_part*cos(theta2_from_theta1) + r1__part_69; used 2 times
    let r1__part_70 = u3_part.mul_add(cos_theta2_from_theta1, r1__part_69);
    // 18*cos(theta2_from_theta1); used 2 times
    let r1__part_71 = S::int(18) * cos_theta2_from_theta1;
    // 14 + r1__part_60 - r1__part_70*r1__part_71; used 2 times
    let r1__part_72 = (-r1__part_70).mul_add(r1__part_71, S::int(14) + r1__part_60);
    // 18*sin(theta2_from_theta1); used 3 times
    let r1__part_73 = S::int(18) * sin_theta2_from_theta1;
    // 33 + r1__part_72*cos(theta3_from_theta1) - r1__part_43*r1__part_73; used 2 times
    let r1__part_74 = r1__part_72.mul_add(cos_theta3_from_theta1, S::int(33))
        - r1__part_43 * r1__part_73;
    // 1/r1__part_74; used 5 times
    let r1__part_74_inv = S::int(1) / r1__part_74;
    // r1__part_68*r1__part_74_inv; used 3 times
    let r1__part_75 = r1__part_68 * r1__part_74_inv;
    // 7*r1__part_75/750; used 3 times
    let r1__part_75_scaled = S::ratio(7, 750) * r1__part_75;
    // Elimination, step by step.
    // r1_ = 7*(u3*(cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(u3*(13 + 6*cos(theta2_from_theta1))
    //   + 6*u4_from_u3*(3 + cos(theta2_from_theta1)) + 6*u5_from_u3 + 2*cos(theta3_from_theta1)*(2*u3 +
    //   u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3))) +
    //   2*sin(theta3_from_theta1)*(8*u3 + 9*u4_from_u3 + 8*u5_from_u3 - 3*cos(theta2_from_theta1)*(2*u3 +
    //   u4_from_u3 + 2*u5_from_u3 + 6*cos(theta2_from_theta1)*(u3 + u4_from_u3 + u5_from_u3)))) -
    //   sin(theta3_from_theta1)*(13*u3 + 18*u4_from_u3 + 6*u5_from_u3 + 3*cos(theta2_from_theta1)*(3*u3*(5 +
    //   2*cos(theta2_from_theta1)) + 2*u4_from_u3*(10 + 3*cos(theta2_from_theta1)) + 6*u5_from_u3)) -
    //   6*sin(theta2_from_theta1)*(u3 + 3*u4_from_u3 + u5_from_u3 + 3*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u5_from_u3))) + cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(3*u4_from_u3^2*(3 +
    //   cos(theta2_from_theta1)) + 3*u5_from_u3^2 + cos(theta3_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2))) + sin(theta3_from_theta1)*(9*u4_from_u3^2
    //   + 8*u5_from_u3^2 - 3*cos(theta2_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
    //   6*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))) -
    //   3*sin(theta3_from_theta1)*(3*u4_from_u3^2 + u5_from_u3^2 + cos(theta2_from_theta1)*(u4_from_u3^2*(10
    //   + 3*cos(theta2_from_theta1)) + 3*u5_from_u3^2)) - 3*sin(theta2_from_theta1)*(3*u4_from_u3^2 +
    //   u5_from_u3^2 + 3*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/(750*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))) +
    //   7*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(9*u3^2*sin(theta2_from_theta1) + 6*sin(theta2_from_theta1 -
    //   theta3_from_theta1)*(u3 + u5_from_u3)^2 + 3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + ((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(2*u3^2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1)*(u3 + u4_from_u3)^2
    //   + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) + (3*cos(theta1 + theta2_from_theta1) - (7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))*(2*u3^2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1)*(u3 +
    //   u4_from_u3)^2 + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2))/(750*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))))
    let r1_ = r1__part_59
        .mul_add(r1__part_75_scaled, r1__part_30 * u3_part_12_inv_scaled);
    // Shared terms.
    // cos(theta2_from_theta1)*cos(theta3_from_theta1) + r1__part_69; used 4 times
    let u5_from_u3_dot_part = cos_theta2_from_theta1
        .mul_add(cos_theta3_from_theta1, r1__part_69);
    // 9*cos(theta2_from_theta1); used 6 times
    let u5_from_u3_dot_part_2 = S::int(9) * cos_theta2_from_theta1;
    // 5*cos(theta3_from_theta1) - cos(theta2_from_theta1 - theta3_from_theta1)*u5_from_u3_dot_part_2; used
    //   2 times
    let u5_from_u3_dot_part_3 = (-u5_from_u3_dot_part)
        .mul_add(u5_from_u3_dot_part_2, S::int(5) * cos_theta3_from_theta1);
    // 1/(9 + u5_from_u3_dot_part_3*cos(theta3_from_theta1)); used 2 times
    let u5_from_u3_dot_part_4 = S::int(1)
        / u5_from_u3_dot_part_3.mul_add(cos_theta3_from_theta1, S::int(9));
    // r1__part_74*u5_from_u3_dot_part_4; used 2 times
    let u5_from_u3_dot_part_5 = r1__part_74 * u5_from_u3_dot_part_4;
    // 375*u5_from_u3_dot_part_5/14; used 5 times
    let u5_from_u3_dot_part_6 = S::ratio(375, 14) * u5_from_u3_dot_part_5;
    // Elimination, step by step.
    // u5_from_u3' = 375*r1_*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(14*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot = r1_ * u5_from_u3_dot_part_6;
    // Shared terms.
    // 1500*H_n3; used 3 times
    let h_n3_scaled = S::int(1500) * H_n3;
    // 42*u5_from_u3; used 2 times
    let u5_from_u3_scaled_3 = S::int(42) * u5_from_u3;
    // u4_from_u3_scaled - h_n3_scaled; used 2 times
    let u3_by_theta2_from_theta1_part = u4_from_u3_scaled - h_n3_scaled;
    // 49*u5_from_u3 + h_n3_scaled; used 2 times
    let u3_by_theta2_from_theta1_part_2 = u5_from_u3.mul_add(S::int(49), h_n3_scaled);
    // u3_part_12_inv^2; used 4 times
    let u3_part_12_inv_sq = u3_part_12_inv * u3_part_12_inv;
    // Elimination, step by step.
    // u3_by_theta2_from_theta1 = -3*(sin(theta2_from_theta1)*(7*u4_from_u3 + 42*u5_from_u3 - 1500*H_n3 -
    //   cos(theta3_from_theta1)*(7*u4_from_u3*(1 + 2*cos(theta3_from_theta1)) + 35*u5_from_u3 + 1500*H_n3))
    //   + sin(theta3_from_theta1)*(42*u5_from_u3 +
    //   cos(theta2_from_theta1)*(7*u4_from_u3*(2*cos(theta3_from_theta1) - 1) + 49*u5_from_u3 +
    //   1500*H_n3)))/(7*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1)
    //   + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2)
    let u3_by_theta2_from_theta1 = -S::ratio(3, 7) * u3_part_12_inv_sq
        * (sin_theta2_from_theta1
            * (u5_from_u3_scaled_3
                - cos_theta3_from_theta1
                    * (u4_from_u3_scaled.mul_add(r1__part_63, S::int(35) * u5_from_u3)
                        + h_n3_scaled) + u3_by_theta2_from_theta1_part)
            + sin_theta3_from_theta1
                * (u5_from_u3_scaled_3
                    + cos_theta2_from_theta1
                        * (u4_from_u3_scaled * (u3_part_9 - S::int(1))
                            + u3_by_theta2_from_theta1_part_2)));
    // Shared terms.
    // u3_by_theta2_from_theta1*u3_part_6 - u3_part_3*r1__part_4; used 3 times
    let r1__by_theta2_from_theta1_part = (-u3_part_3)
        .mul_add(r1__part_4, u3_by_theta2_from_theta1 * u3_part_6);
    // 4*cos(theta3_from_theta1); used 3 times
    let r1__by_theta2_from_theta1_part_2 = S::int(4) * cos_theta3_from_theta1;
    // 2*r1__part_3; used 3 times
    let r1__part_3_scaled_2 = S::int(2) * r1__part_3;
    // u4_from_u3_sq*sin(theta2_from_theta1); used 2 times
    let r1__by_theta2_from_theta1_part_3 = u4_from_u3_sq * sin_theta2_from_theta1;
    // r1__part_20*sin(theta2_from_theta1); used 3 times
    let r1__by_theta2_from_theta1_part_4 = r1__part_20 * sin_theta2_from_theta1;
    // 3*cos(theta3_from_theta1); used 3 times
    let r1__by_theta2_from_theta1_part_5 = S::int(3) * cos_theta3_from_theta1;
    // cos(theta1 + theta3_from_theta1)*r1__part_8 + cos_theta1_u3_scaled; used 2 times
    let r1__by_theta2_from_theta1_part_6 = r1__part_31
        .mul_add(r1__part_8, cos_theta1_u3_scaled);
    // r1__part_3*r1__part_32_scaled + r1__by_theta2_from_theta1_part_6; used 2 times
    let r1__by_theta2_from_theta1_part_7 = r1__part_3
        .mul_add(r1__part_32_scaled, r1__by_theta2_from_theta1_part_6);
    // 2*u3_by_theta2_from_theta1; used 3 times
    let r1__by_theta2_from_theta1_part_8 = S::int(2) * u3_by_theta2_from_theta1;
    // u3*u3_part_3 + r1__part_8*r1__part_45_scaled_scaled; used 2 times
    let r1__by_theta2_from_theta1_part_9 = r1__part_8
        .mul_add(r1__part_45_scaled_scaled, u3 * u3_part_3);
    // 6*r1__by_theta2_from_theta1_part_9; used 2 times
    let r1__by_theta2_from_theta1_part_10 = S::int(6) * r1__by_theta2_from_theta1_part_9;
    // sin(theta1 + theta3_from_theta1)*r1__part_8 + sin_theta1_u3_scaled; used 2 times
    let r1__by_theta2_from_theta1_part_11 = r1__part_36
        .mul_add(r1__part_8, sin_theta1_u3_scaled);
    // r1__part_3*r1__part_38_scaled + r1__by_theta2_from_theta1_part_11; used 2 times
    let r1__by_theta2_from_theta1_part_12 = r1__part_3
        .mul_add(r1__part_38_scaled, r1__by_theta2_from_theta1_part_11);
    // r1__part_43 - u3_part*sin(theta2_from_theta1); used 4 times
    let r1__by_theta2_from_theta1_part_13 = (-u3_part)
        .mul_add(sin_theta2_from_theta1, r1__part_43);
    // u3_part_12_inv*r1__by_theta2_from_theta1_part_13*(1 - 2*r1__part_34); used 3 times
    let r1__by_theta2_from_theta1_part_14 = u3_part_12_inv
        * r1__by_theta2_from_theta1_part_13
        * (-r1__part_34).mul_add(S::int(2), S::int(1));
    // u3_sq*cos(theta2_from_theta1) + r1__part_48*r1__by_theta2_from_theta1_part_14
    let r1__by_theta2_from_theta1_part_15 = r1__part_48
        .mul_add(r1__by_theta2_from_theta1_part_14, u3_sq * cos_theta2_from_theta1);
    // r1__part_50*(r1__by_theta2_from_theta1_part_7*r1__by_theta2_from_theta1_part_8 - r1__part_40) -
    //   u3_by_theta2_from_theta1*r1__by_theta2_from_theta1_part_10
    let r1__by_theta2_from_theta1_part_16 = r1__part_50
        * r1__by_theta2_from_theta1_part_7
            .mul_add(r1__by_theta2_from_theta1_part_8, -r1__part_40)
        - u3_by_theta2_from_theta1 * r1__by_theta2_from_theta1_part_10;
    // r1__part_35*(r1__part_53 + r1__by_theta2_from_theta1_part_8*r1__by_theta2_from_theta1_part_12) +
    //   9*r1__by_theta2_from_theta1_part_15
    let r1__by_theta2_from_theta1_part_17 = r1__part_35
        * r1__by_theta2_from_theta1_part_8
            .mul_add(r1__by_theta2_from_theta1_part_12, r1__part_53)
        + S::int(9) * r1__by_theta2_from_theta1_part_15;
    // 2*cos(theta2_from_theta1 - theta3_from_theta1); used 2 times
    let u5_from_u3_dot_part_scaled = S::int(2) * u5_from_u3_dot_part;
    // r1__part_42*u5_from_u3_dot_part_scaled; used 2 times
    let r1__by_theta2_from_theta1_part_18 = r1__part_42 * u5_from_u3_dot_part_scaled;
    // r1__part_47*u5_from_u3_dot_part_scaled; used 2 times
    let r1__by_theta2_from_theta1_part_19 = r1__part_47 * u5_from_u3_dot_part_scaled;
    // 1 - r1__part_34; used 2 times
    let r1__by_theta2_from_theta1_part_20 = S::int(1) - r1__part_34;
    // r1__part_41*(r1__part_33*r1__by_theta2_from_theta1_part_14 + sin(theta1 +
    //   theta2_from_theta1)*r1__by_theta2_from_theta1_part_20) + r1__part_54*(cos(theta1 +
    //   theta2_from_theta1)*r1__by_theta2_from_theta1_part_20 -
    //   r1__part_49*r1__by_theta2_from_theta1_part_14)
    let r1__by_theta2_from_theta1_part_21 = r1__part_41
        * r1__part_38
            .mul_add(
                r1__by_theta2_from_theta1_part_20,
                r1__part_33 * r1__by_theta2_from_theta1_part_14,
            )
        + r1__part_54
            * (-r1__part_49)
                .mul_add(
                    r1__by_theta2_from_theta1_part_14,
                    r1__part_32 * r1__by_theta2_from_theta1_part_20,
                );
    // cos(theta2_from_theta1 - theta3_from_theta1)*r1__part_8_sq_scaled; used 2 times
    let r1__by_theta2_from_theta1_part_22 = u5_from_u3_dot_part * r1__part_8_sq_scaled;
    // r1__part_34_scaled*(u3_part_2*u4_from_u3_sq + r1__part_46*r1__by_theta2_from_theta1_part_8 +
    //   u3_scaled*(u4_from_u3*u3_part_2 + r1__by_theta2_from_theta1_part_18) +
    //   r1__by_theta2_from_theta1_part_19) - 3*r1__by_theta2_from_theta1_part_21
    let r1__by_theta2_from_theta1_part_23 = r1__part_34_scaled
        * (u3_part_2 * u4_from_u3_sq + r1__part_46 * r1__by_theta2_from_theta1_part_8
            + u3_scaled
                * u4_from_u3.mul_add(u3_part_2, r1__by_theta2_from_theta1_part_18)
            + r1__by_theta2_from_theta1_part_19)
        - S::int(3) * r1__by_theta2_from_theta1_part_21;
    // r1__by_theta2_from_theta1_part_16 - r1__by_theta2_from_theta1_part_17
    let r1__by_theta2_from_theta1_part_24 = r1__by_theta2_from_theta1_part_16
        - r1__by_theta2_from_theta1_part_17;
    // r1__by_theta2_from_theta1_part_22 + r1__by_theta2_from_theta1_part_23
    let r1__by_theta2_from_theta1_part_25 = r1__by_theta2_from_theta1_part_22
        + r1__by_theta2_from_theta1_part_23;
    // r1__by_theta2_from_theta1_part_24 - r1__by_theta2_from_theta1_part_25; used 2 times
    let r1__by_theta2_from_theta1_part_26 = r1__by_theta2_from_theta1_part_24
        - r1__by_theta2_from_theta1_part_25;
    // r1__part_59*r1__part_74_inv; used 3 times
    let r1__by_theta2_from_theta1_part_27 = r1__part_59 * r1__part_74_inv;
    // r1__part_69*sin(theta2_from_theta1) - r1__part_43*cos(theta2_from_theta1) +
    //   cos(theta3_from_theta1)*(r1__part_70*sin(theta2_from_theta1) -
    //   r1__by_theta2_from_theta1_part_13*cos(theta2_from_theta1)); used 3 times
    let r1__by_theta2_from_theta1_part_28 = r1__part_69 * sin_theta2_from_theta1
        - r1__part_43 * cos_theta2_from_theta1
        + cos_theta3_from_theta1
            * (-r1__by_theta2_from_theta1_part_13)
                .mul_add(cos_theta2_from_theta1, r1__part_70 * sin_theta2_from_theta1);
    // sin(theta2_from_theta1) + r1__part_43 + cos(theta3_from_theta1)*(2*r1__part_43 -
    //   r1__part_63*sin(theta2_from_theta1))
    let r1__by_theta2_from_theta1_part_29 = sin_theta2_from_theta1 + r1__part_43
        + cos_theta3_from_theta1
            * (-r1__part_63).mul_add(sin_theta2_from_theta1, S::int(2) * r1__part_43);
    // r1__part_43*cos(theta3_from_theta1) + r1__part_67*sin(theta2_from_theta1) +
    //   u3_part_2*(sin(theta3_from_theta1) + r1__by_theta2_from_theta1_part_29); used 2 times
    let r1__by_theta2_from_theta1_part_30 = r1__part_43 * cos_theta3_from_theta1
        + r1__part_67 * sin_theta2_from_theta1
        + u3_part_2 * (sin_theta3_from_theta1 + r1__by_theta2_from_theta1_part_29);
    // r1__part_30*u3_part_12_inv_sq; used 2 times
    let r1__by_theta2_from_theta1_part_31 = r1__part_30 * u3_part_12_inv_sq;
    // Elimination, step by step.
    // r1__by_theta2_from_theta1 = 7*(sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) -
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
    //   u5_from_u3^2 + 3*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/(125*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2) + 21*(12 -
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
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))))*(9*u3^2*sin(theta2_from_theta1) +
    //   6*sin(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3)^2 + 3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + ((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(2*u3^2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1)*(u3 + u4_from_u3)^2
    //   + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) + (3*cos(theta1 + theta2_from_theta1) - (7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))*(2*u3^2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1)*(u3 +
    //   u4_from_u3)^2 + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2))/(125*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))^2) +
    //   7*(3*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1)*cos(theta3_from_theta1) + sin(theta2_from_theta1)*(3
    //   + 3*cos(theta2_from_theta1) - 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   cos(theta3_from_theta1)*(2 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   3*cos(theta2_from_theta1)*(sin(theta2_from_theta1) + cos(theta2_from_theta1)*sin(theta3_from_theta1)
    //   + cos(theta3_from_theta1)*(2*cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))))*(9*u3^2*sin(theta2_from_theta1) +
    //   6*sin(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3)^2 + 3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + ((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(2*u3^2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1)*(u3 + u4_from_u3)^2
    //   + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) + (3*cos(theta1 + theta2_from_theta1) - (7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))*(2*u3^2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1)*(u3 +
    //   u4_from_u3)^2 + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2))/(250*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))) +
    //   7*(9*sin(theta2_from_theta1)^2*(u4_from_u3^2 + u5_from_u3^2) -
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
    //   2*u3*sin(theta2_from_theta1) - 2*u4_from_u3*sin(theta2_from_theta1)))))/(750*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))) +
    //   7*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(9*u3^2*cos(theta2_from_theta1) + 6*cos(theta2_from_theta1 -
    //   theta3_from_theta1)*(u3 + u5_from_u3)^2 + 9*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + 18*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2 + 3*(cos(theta1 + theta2_from_theta1)*(7
    //   + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - cos(theta1 +
    //   theta2_from_theta1) - (2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))*(sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 2*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))*(cos(theta2_from_theta1)*sin(theta3_from_theta1) - sin(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))^2)*(2*u3^2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1)*(u3 +
    //   u4_from_u3)^2 + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) + 3*(sin(theta1 +
    //   theta2_from_theta1)*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - sin(theta1 + theta2_from_theta1) -
    //   (2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))*(cos(theta2_from_theta1)*sin(theta3_from_theta1) - sin(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 2*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))*(sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2)*(2*u3^2*sin(theta1) + 3*sin(theta1 +
    //   theta2_from_theta1)*(u3 + u4_from_u3)^2 + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) +
    //   18*u3*u3_by_theta2_from_theta1*sin(theta2_from_theta1) +
    //   12*u3_by_theta2_from_theta1*sin(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3) + 3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(3*u4_from_u3^2*cos(theta2_from_theta1) + 2*cos(theta2_from_theta1 -
    //   theta3_from_theta1)*(u4_from_u3^2 - u5_from_u3^2) + 2*u3*(3*u4_from_u3*cos(theta2_from_theta1) +
    //   2*cos(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)) +
    //   2*u3_by_theta2_from_theta1*(3*u4_from_u3*sin(theta2_from_theta1) +
    //   u5_from_u3*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 -
    //   u5_from_u3)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + (3*sin(theta1 + theta2_from_theta1) - (7
    //   + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))*(3*sin(theta1
    //   + theta2_from_theta1)*(u3 + u4_from_u3)^2 - 4*u3*u3_by_theta2_from_theta1*cos(theta1) -
    //   6*u3_by_theta2_from_theta1*cos(theta1 + theta2_from_theta1)*(u3 + u4_from_u3) -
    //   2*u3_by_theta2_from_theta1*cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)) + (3*cos(theta1 +
    //   theta2_from_theta1) - (7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 +
    //   theta2_from_theta1) + cos(theta1 + theta3_from_theta1))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))*(3*cos(theta1 + theta2_from_theta1)*(u3 +
    //   u4_from_u3)^2 + 4*u3*u3_by_theta2_from_theta1*sin(theta1) + 6*u3_by_theta2_from_theta1*sin(theta1 +
    //   theta2_from_theta1)*(u3 + u4_from_u3) + 2*u3_by_theta2_from_theta1*sin(theta1 +
    //   theta3_from_theta1)*(u3 + u5_from_u3)))/(750*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))))
    let r1__by_theta2_from_theta1 = u3_part_12_inv_scaled
        * (u3_by_theta2_from_theta1 * r1__part_19 - u3_part_2 * r1__part_26
            + u3
                * (cos_theta3_from_theta1
                    * (r1__part_10
                        * (u3_part_3
                            .mul_add(r1__part_6, S::int(8) * u3_by_theta2_from_theta1)
                            - u3_part_8 * r1__by_theta2_from_theta1_part)
                        + u3_part_2 * r1__part_7
                        + u3_part_3
                            * ((-u3_part_10)
                                .mul_add(r1__part_3, u3_by_theta2_from_theta1 * r1__part)
                                + r1__by_theta2_from_theta1_part
                                    * r1__by_theta2_from_theta1_part_2))
                    - u3_part_8 * r1__part_18
                    - u3_part_10 * r1__by_theta2_from_theta1_part
                    + sin_theta3_from_theta1
                        * (u3_part_3 * r1__part_16
                            - S::int(13) * u3_by_theta2_from_theta1
                            - u5_from_u3_dot_part_2
                                * (-r1__part_3_scaled_2)
                                    .mul_add(
                                        sin_theta2_from_theta1,
                                        u3_by_theta2_from_theta1 * r1__part_13,
                                    )))
            + r1__part_29
                * u3_part_2
                    .mul_add(
                        r1__by_theta2_from_theta1_part_3,
                        r1__part_27 * sin_theta2_from_theta1,
                    ) + r1__part_55 * r1__by_theta2_from_theta1_part_4
            + r1__by_theta2_from_theta1_part_5
                * (sin_theta3_from_theta1
                    * u3_part_8
                        .mul_add(
                            r1__by_theta2_from_theta1_part_4,
                            r1__part_21 * sin_theta2_from_theta1,
                        ) + r1__part_23 * cos_theta2_from_theta1
                    - u3_part_3
                        * u3_part_9
                            .mul_add(
                                r1__by_theta2_from_theta1_part_4,
                                r1__by_theta2_from_theta1_part_3,
                            ))) - r1__part_75_scaled * r1__by_theta2_from_theta1_part_26
        + S::ratio(7, 250) * r1__by_theta2_from_theta1_part_27
            * (-(r1__part_75 * r1__by_theta2_from_theta1_part_28))
                .mul_add(S::int(6), r1__by_theta2_from_theta1_part_30)
        - S::ratio(7, 125) * r1__by_theta2_from_theta1_part_13
            * r1__by_theta2_from_theta1_part_31;
    // Shared terms.
    // r1_*u5_from_u3_dot_part_4; used 3 times
    let u5_from_u3_dot_by_theta2_from_theta1_part = r1_ * u5_from_u3_dot_part_4;
    // Elimination, step by step.
    // u5_from_u3_dot_by_theta2_from_theta1 =
    //   3375*r1_*cos(theta3_from_theta1)*(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1)
    //   - 33 - cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))))*(cos(theta2_from_theta1)*(sin(theta2_from_theta1)*cos(theta3_from_theta1)
    //   - cos(theta2_from_theta1)*sin(theta3_from_theta1)) +
    //   sin(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))/(14*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1))))^2) +
    //   3375*r1_*(sin(theta2_from_theta1)^2*sin(theta3_from_theta1) -
    //   cos(theta2_from_theta1)^2*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   cos(theta2_from_theta1)*(sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))))/(7*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1))))) + 375*r1__by_theta2_from_theta1*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(14*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot_by_theta2_from_theta1 = S::ratio(3375, 14)
        * u5_from_u3_dot_by_theta2_from_theta1_part
        * (u5_from_u3_dot_part_5 * cos_theta3_from_theta1
            * (-u5_from_u3_dot_part)
                .mul_add(sin_theta2_from_theta1, r1__part_45 * cos_theta2_from_theta1)
            + S::int(2) * r1__by_theta2_from_theta1_part_28)
        + r1__by_theta2_from_theta1 * u5_from_u3_dot_part_6;
    // Shared terms.
    // u3_part_12_inv*r1__part_68; used 4 times
    let u4_from_u3_dot_by_theta2_from_theta1_part = u3_part_12_inv * r1__part_68;
    // u5_from_u3'*u3_part_12_inv; used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_2 = u5_from_u3_dot * u3_part_12_inv;
    // 6*r1__by_theta2_from_theta1_part_13; used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_3 = S::int(6)
        * r1__by_theta2_from_theta1_part_13;
    // u5_from_u3'*r1__part_68*u3_part_12_inv_sq; used 2 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_4 = u5_from_u3_dot * r1__part_68
        * u3_part_12_inv_sq;
    // u3_part_12*r1__part_74_inv; used 4 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_5 = u3_part_12 * r1__part_74_inv;
    // r1__part_74_inv*(r1__part_59 + u5_from_u3'*u4_from_u3_dot_by_theta2_from_theta1_part); used 3 times
    let u4_from_u3_dot_by_theta2_from_theta1_part_6 = r1__part_74_inv
        * u5_from_u3_dot.mul_add(u4_from_u3_dot_by_theta2_from_theta1_part, r1__part_59);
    // u4_from_u3_dot_by_theta2_from_theta1_part_5*u4_from_u3_dot_by_theta2_from_theta1_part_6; used 2
    //   times
    let u4_from_u3_dot_by_theta2_from_theta1_part_7 = u4_from_u3_dot_by_theta2_from_theta1_part_5
        * u4_from_u3_dot_by_theta2_from_theta1_part_6;
    // Elimination, step by step.
    // u4_from_u3_dot_by_theta2_from_theta1 = 6*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(9*u3^2*sin(theta2_from_theta1) +
    //   6*sin(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3)^2 + 3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + ((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(2*u3^2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1)*(u3 + u4_from_u3)^2
    //   + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) + (3*cos(theta1 + theta2_from_theta1) - (7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))*(2*u3^2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1)*(u3 +
    //   u4_from_u3)^2 + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) +
    //   u5_from_u3'*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))/(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1)
    //   - 33 - cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))) + 18*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(sin(theta2_from_theta1)^2*sin(theta3_from_theta1) -
    //   cos(theta2_from_theta1)^2*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   cos(theta2_from_theta1)*(sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))))*(9*u3^2*sin(theta2_from_theta1) +
    //   6*sin(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3)^2 + 3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + ((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(2*u3^2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1)*(u3 + u4_from_u3)^2
    //   + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) + (3*cos(theta1 + theta2_from_theta1) - (7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))*(2*u3^2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1)*(u3 +
    //   u4_from_u3)^2 + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) +
    //   u5_from_u3'*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))/(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))^2 + (13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(9*u3^2*cos(theta2_from_theta1) +
    //   6*cos(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3)^2 +
    //   9*(cos(theta2_from_theta1)*sin(theta3_from_theta1) - sin(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + 18*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2 + 3*(cos(theta1 + theta2_from_theta1)*(7
    //   + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - cos(theta1 +
    //   theta2_from_theta1) - (2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))*(sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 2*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))*(cos(theta2_from_theta1)*sin(theta3_from_theta1) - sin(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))^2)*(2*u3^2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1)*(u3 +
    //   u4_from_u3)^2 + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) + 3*(sin(theta1 +
    //   theta2_from_theta1)*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - sin(theta1 + theta2_from_theta1) -
    //   (2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))*(cos(theta2_from_theta1)*sin(theta3_from_theta1) - sin(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 2*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))*(sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2)*(2*u3^2*sin(theta1) + 3*sin(theta1 +
    //   theta2_from_theta1)*(u3 + u4_from_u3)^2 + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) +
    //   6*u5_from_u3'*(12 - 9*sin(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) -
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2 +
    //   3*u5_from_u3'*(3*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1)*cos(theta3_from_theta1) + sin(theta2_from_theta1)*(3
    //   + 3*cos(theta2_from_theta1) - 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   cos(theta3_from_theta1)*(2 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   3*cos(theta2_from_theta1)*(sin(theta2_from_theta1) + cos(theta2_from_theta1)*sin(theta3_from_theta1)
    //   + cos(theta3_from_theta1)*(2*cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   18*u3*u3_by_theta2_from_theta1*sin(theta2_from_theta1) +
    //   12*u3_by_theta2_from_theta1*sin(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3) + 3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(3*u4_from_u3^2*cos(theta2_from_theta1) + 2*cos(theta2_from_theta1 -
    //   theta3_from_theta1)*(u4_from_u3^2 - u5_from_u3^2) + 2*u3*(3*u4_from_u3*cos(theta2_from_theta1) +
    //   2*cos(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)) +
    //   2*u3_by_theta2_from_theta1*(3*u4_from_u3*sin(theta2_from_theta1) +
    //   u5_from_u3*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 -
    //   u5_from_u3)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + (3*sin(theta1 + theta2_from_theta1) - (7
    //   + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))*(3*sin(theta1
    //   + theta2_from_theta1)*(u3 + u4_from_u3)^2 - 4*u3*u3_by_theta2_from_theta1*cos(theta1) -
    //   6*u3_by_theta2_from_theta1*cos(theta1 + theta2_from_theta1)*(u3 + u4_from_u3) -
    //   2*u3_by_theta2_from_theta1*cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)) + (3*cos(theta1 +
    //   theta2_from_theta1) - (7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 +
    //   theta2_from_theta1) + cos(theta1 + theta3_from_theta1))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))*(3*cos(theta1 + theta2_from_theta1)*(u3 +
    //   u4_from_u3)^2 + 4*u3*u3_by_theta2_from_theta1*sin(theta1) + 6*u3_by_theta2_from_theta1*sin(theta1 +
    //   theta2_from_theta1)*(u3 + u4_from_u3) + 2*u3_by_theta2_from_theta1*sin(theta1 +
    //   theta3_from_theta1)*(u3 + u5_from_u3)) +
    //   u5_from_u3_dot_by_theta2_from_theta1*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))/(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1)
    //   - 33 - cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))
    let u4_from_u3_dot_by_theta2_from_theta1 = u4_from_u3_dot_by_theta2_from_theta1_part_5
        * ((-u5_from_u3_dot_by_theta2_from_theta1)
            .mul_add(
                u4_from_u3_dot_by_theta2_from_theta1_part,
                r1__by_theta2_from_theta1_part_26,
            )
            - S::int(3) * r1__by_theta2_from_theta1_part_30
                * u4_from_u3_dot_by_theta2_from_theta1_part_2
            + u4_from_u3_dot_by_theta2_from_theta1_part_3
                * u4_from_u3_dot_by_theta2_from_theta1_part_4)
        - u4_from_u3_dot_by_theta2_from_theta1_part_3
            * u4_from_u3_dot_by_theta2_from_theta1_part_6
        + S::int(18) * r1__by_theta2_from_theta1_part_28
            * u4_from_u3_dot_by_theta2_from_theta1_part_7;
    // Shared terms.
    // 7 + u3_part_8; used 2 times
    let u3_by_theta3_from_theta1_part = S::int(7) + u3_part_8;
    // Elimination, step by step.
    // u3_by_theta3_from_theta1 = -(sin(theta3_from_theta1)*(98*u4_from_u3 - 49*u5_from_u3 - 1500*H_n3 +
    //   9*cos(theta2_from_theta1)*(7*u4_from_u3 - 7*u5_from_u3*(3 + 2*cos(theta2_from_theta1)) - 500*H_n3))
    //   + 3*sin(theta2_from_theta1)*(14*u4_from_u3 + cos(theta3_from_theta1)*(7*u5_from_u3*(7 +
    //   6*cos(theta2_from_theta1)) - 7*u4_from_u3 + 1500*H_n3)))/(7*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2)
    let u3_by_theta3_from_theta1 = -S::ratio(1, 7) * u3_part_12_inv_sq
        * (sin_theta3_from_theta1
            * (u5_from_u3_dot_part_2
                * (u4_from_u3_scaled - S::int(500) * H_n3
                    - u5_from_u3_scaled * (S::int(3) + r1__part_12))
                + S::int(98) * u4_from_u3 - u3_by_theta2_from_theta1_part_2)
            + u3_part_3
                * (cos_theta3_from_theta1
                    * u5_from_u3_scaled
                        .mul_add(
                            u3_by_theta3_from_theta1_part,
                            -u3_by_theta2_from_theta1_part,
                        ) + S::int(14) * u4_from_u3));
    // Shared terms.
    // u3_by_theta3_from_theta1*u3_part_6; used 3 times
    let r1__by_theta3_from_theta1_part = u3_by_theta3_from_theta1 * u3_part_6;
    // 4*sin(theta3_from_theta1); used 2 times
    let r1__by_theta3_from_theta1_part_2 = S::int(4) * sin_theta3_from_theta1;
    // u3_part_3*(r1__part_6*r1__part_10 - u3_by_theta3_from_theta1*r1__part -
    //   r1__by_theta2_from_theta1_part_2*r1__by_theta3_from_theta1_part) - u3_part_9*r1__part_9 +
    //   r1__by_theta3_from_theta1_part_2*(u3_part_2*r1__by_theta3_from_theta1_part -
    //   4*u3_by_theta3_from_theta1)
    let r1__by_theta3_from_theta1_part_3 = u3_part_3
        * ((-u3_by_theta3_from_theta1).mul_add(r1__part, r1__part_6 * r1__part_10)
            - r1__by_theta2_from_theta1_part_2 * r1__by_theta3_from_theta1_part)
        - u3_part_9 * r1__part_9
        + r1__by_theta3_from_theta1_part_2
            * (-u3_by_theta3_from_theta1)
                .mul_add(S::int(4), u3_part_2 * r1__by_theta3_from_theta1_part);
    // 1 + u3_part_8; used 2 times
    let r1__by_theta3_from_theta1_part_4 = S::int(1) + u3_part_8;
    // u3_part_3*cos(theta3_from_theta1); used 2 times
    let r1__by_theta3_from_theta1_part_5 = u3_part_3 * cos_theta3_from_theta1;
    // r1__part_55*cos(theta3_from_theta1) + r1__part_62*sin(theta3_from_theta1) +
    //   r1__by_theta2_from_theta1_part_5*(r1__part_29 + r1__part_44) +
    //   u3_part_2*(cos(theta3_from_theta1)*(u3_part_10*cos(theta3_from_theta1) -
    //   r1__by_theta3_from_theta1_part_4*sin(theta3_from_theta1)) - r1__part_66*sin(theta3_from_theta1) +
    //   r1__by_theta3_from_theta1_part_5); used 2 times
    let r1__by_theta3_from_theta1_part_6 = r1__part_55 * cos_theta3_from_theta1
        + r1__part_62 * sin_theta3_from_theta1
        + r1__by_theta2_from_theta1_part_5 * (r1__part_29 + r1__part_44)
        + u3_part_2
            * (cos_theta3_from_theta1
                * (-r1__by_theta3_from_theta1_part_4)
                    .mul_add(sin_theta3_from_theta1, u3_part_10 * cos_theta3_from_theta1)
                - r1__part_66 * sin_theta3_from_theta1
                + r1__by_theta3_from_theta1_part_5);
    // u3_part_6*sin(theta3_from_theta1) - r1__by_theta3_from_theta1_part_5; used 2 times
    let r1__by_theta3_from_theta1_part_7 = u3_part_6
        .mul_add(sin_theta3_from_theta1, -r1__by_theta3_from_theta1_part_5);
    // r1__part_60*(sin(theta3_from_theta1) - r1__part_12*r1__part_45) + r1__part_44*r1__part_71 +
    //   r1__part_72*sin(theta3_from_theta1); used 3 times
    let r1__by_theta3_from_theta1_part_8 = r1__part_60
        * (-r1__part_12).mul_add(r1__part_45, sin_theta3_from_theta1)
        + r1__part_44 * r1__part_71 + r1__part_72 * sin_theta3_from_theta1;
    // 2*u3_by_theta3_from_theta1; used 3 times
    let r1__by_theta3_from_theta1_part_9 = S::int(2) * u3_by_theta3_from_theta1;
    // 2*r1__by_theta3_from_theta1_part_7; used 3 times
    let r1__by_theta3_from_theta1_part_10 = S::int(2) * r1__by_theta3_from_theta1_part_7;
    // u3_part_12_inv*(3*r1__part_45 - r1__part_34*r1__by_theta3_from_theta1_part_10); used 3 times
    let r1__by_theta3_from_theta1_part_11 = u3_part_12_inv
        * (-r1__part_34)
            .mul_add(r1__by_theta3_from_theta1_part_10, S::int(3) * r1__part_45);
    // r1__part_50*(r1__by_theta2_from_theta1_part_7*r1__by_theta3_from_theta1_part_9 - r1__part_37) -
    //   u3_by_theta3_from_theta1*r1__by_theta2_from_theta1_part_10
    let r1__by_theta3_from_theta1_part_12 = r1__part_50
        * r1__by_theta2_from_theta1_part_7
            .mul_add(r1__by_theta3_from_theta1_part_9, -r1__part_37)
        - u3_by_theta3_from_theta1 * r1__by_theta2_from_theta1_part_10;
    // r1__part_35*(r1__part_51 + r1__by_theta2_from_theta1_part_12*r1__by_theta3_from_theta1_part_9) +
    //   r1__part_41*(sin(theta1 + theta3_from_theta1)*r1__part_34 +
    //   r1__part_33*r1__by_theta3_from_theta1_part_11)
    let r1__by_theta3_from_theta1_part_13 = r1__part_35
        * r1__by_theta2_from_theta1_part_12
            .mul_add(r1__by_theta3_from_theta1_part_9, r1__part_51)
        + r1__part_41
            * r1__part_33
                .mul_add(r1__by_theta3_from_theta1_part_11, r1__part_36 * r1__part_34);
    // 3*r1__part_48*r1__by_theta3_from_theta1_part_11 +
    //   r1__part_54*(r1__part_49*r1__by_theta3_from_theta1_part_11 - cos(theta1 +
    //   theta3_from_theta1)*r1__part_34)
    let r1__by_theta3_from_theta1_part_14 = r1__part_54
        * (-r1__part_31)
            .mul_add(r1__part_34, r1__part_49 * r1__by_theta3_from_theta1_part_11)
        + S::int(3) * r1__part_48 * r1__by_theta3_from_theta1_part_11;
    // r1__part_34_scaled*(u5_from_u3_sq*cos(theta3_from_theta1) -
    //   u3_scaled*(r1__by_theta2_from_theta1_part_18 - u5_from_u3*cos(theta3_from_theta1)) -
    //   r1__by_theta2_from_theta1_part_19 + r1__part_46*r1__by_theta3_from_theta1_part_9) -
    //   r1__by_theta3_from_theta1_part_14
    let r1__by_theta3_from_theta1_part_15 = r1__part_34_scaled
        * (-u3_scaled
            * (-u5_from_u3)
                .mul_add(cos_theta3_from_theta1, r1__by_theta2_from_theta1_part_18)
            + u5_from_u3_sq * cos_theta3_from_theta1 - r1__by_theta2_from_theta1_part_19
            + r1__part_46 * r1__by_theta3_from_theta1_part_9)
        - r1__by_theta3_from_theta1_part_14;
    // r1__by_theta3_from_theta1_part_12 - r1__by_theta3_from_theta1_part_13
    let r1__by_theta3_from_theta1_part_16 = r1__by_theta3_from_theta1_part_12
        - r1__by_theta3_from_theta1_part_13;
    // r1__by_theta2_from_theta1_part_22 - r1__by_theta3_from_theta1_part_15
    let r1__by_theta3_from_theta1_part_17 = r1__by_theta2_from_theta1_part_22
        - r1__by_theta3_from_theta1_part_15;
    // r1__by_theta3_from_theta1_part_16 + r1__by_theta3_from_theta1_part_17; used 2 times
    let r1__by_theta3_from_theta1_part_18 = r1__by_theta3_from_theta1_part_16
        + r1__by_theta3_from_theta1_part_17;
    // -r1__by_theta3_from_theta1_part_18
    let r1__by_theta3_from_theta1_part_19 = -r1__by_theta3_from_theta1_part_18;
    // Elimination, step by step.
    // r1__by_theta3_from_theta1 = 7*(sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*sin(theta3_from_theta1) -
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
    //   u5_from_u3^2 + 3*cos(theta2_from_theta1)*(u4_from_u3^2 + u5_from_u3^2)))/(375*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2) +
    //   7*(9*sin(theta2_from_theta1)*cos(theta3_from_theta1) + sin(theta3_from_theta1)*(7 -
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 9*cos(theta3_from_theta1)) +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*cos(theta3_from_theta1) -
    //   sin(theta3_from_theta1)*(2 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1))) +
    //   cos(theta3_from_theta1)*(6*sin(theta2_from_theta1)*cos(theta3_from_theta1) - sin(theta3_from_theta1)
    //   - 6*cos(theta2_from_theta1)*sin(theta3_from_theta1))) +
    //   3*cos(theta3_from_theta1)*(3*sin(theta3_from_theta1) +
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1)))*(9*u3^2*sin(theta2_from_theta1) +
    //   6*sin(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3)^2 + 3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + ((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(2*u3^2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1)*(u3 + u4_from_u3)^2
    //   + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) + (3*cos(theta1 + theta2_from_theta1) - (7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))*(2*u3^2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1)*(u3 +
    //   u4_from_u3)^2 + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2))/(750*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))) +
    //   7*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
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
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))))*(9*u3^2*sin(theta2_from_theta1) +
    //   6*sin(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3)^2 + 3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + ((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(2*u3^2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1)*(u3 + u4_from_u3)^2
    //   + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) + (3*cos(theta1 + theta2_from_theta1) - (7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))*(2*u3^2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1)*(u3 +
    //   u4_from_u3)^2 + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2))/(750*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))^2) -
    //   7*(sin(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(3*u4_from_u3^2*(3 + cos(theta2_from_theta1))
    //   + 3*u5_from_u3^2 + cos(theta3_from_theta1)*(u4_from_u3^2 + 2*u5_from_u3^2 +
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
    //   9*u3_by_theta3_from_theta1*cos(theta2_from_theta1)*(5 + 2*cos(theta2_from_theta1)))))/(750*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))) +
    //   7*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(6*cos(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3)^2 +
    //   9*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + 6*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(3*sin(theta2_from_theta1)*cos(theta3_from_theta1) -
    //   sin(theta3_from_theta1) -
    //   3*cos(theta2_from_theta1)*sin(theta3_from_theta1))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2 + (3*(2*sin(theta1) + 3*sin(theta1 +
    //   theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - cos(theta1 + theta3_from_theta1)*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + 2*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))*(3*sin(theta2_from_theta1)*cos(theta3_from_theta1) - sin(theta3_from_theta1) -
    //   3*cos(theta2_from_theta1)*sin(theta3_from_theta1))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2)*(2*u3^2*cos(theta1) + 3*cos(theta1 +
    //   theta2_from_theta1)*(u3 + u4_from_u3)^2 + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) -
    //   (sin(theta1 + theta3_from_theta1)*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + 3*(2*cos(theta1) + 3*cos(theta1 +
    //   theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + 2*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))*(3*sin(theta2_from_theta1)*cos(theta3_from_theta1) - sin(theta3_from_theta1) -
    //   3*cos(theta2_from_theta1)*sin(theta3_from_theta1))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2)*(2*u3^2*sin(theta1) + 3*sin(theta1 +
    //   theta2_from_theta1)*(u3 + u4_from_u3)^2 + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) -
    //   18*u3*u3_by_theta3_from_theta1*sin(theta2_from_theta1) -
    //   12*u3_by_theta3_from_theta1*sin(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3) - 3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(u5_from_u3^2*cos(theta3_from_theta1) + 2*cos(theta2_from_theta1 -
    //   theta3_from_theta1)*(u5_from_u3^2 - u4_from_u3^2) + 2*u3*(u5_from_u3*cos(theta3_from_theta1) +
    //   2*cos(theta2_from_theta1 - theta3_from_theta1)*(u5_from_u3 - u4_from_u3)) +
    //   2*u3_by_theta3_from_theta1*(3*u4_from_u3*sin(theta2_from_theta1) +
    //   u5_from_u3*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 -
    //   u5_from_u3)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + ((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2 -
    //   4*u3*u3_by_theta3_from_theta1*cos(theta1) - 6*u3_by_theta3_from_theta1*cos(theta1 +
    //   theta2_from_theta1)*(u3 + u4_from_u3) - 2*u3_by_theta3_from_theta1*cos(theta1 +
    //   theta3_from_theta1)*(u3 + u5_from_u3)) + ((7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 +
    //   theta2_from_theta1) + cos(theta1 + theta3_from_theta1))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*cos(theta1 +
    //   theta2_from_theta1))*(cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2 +
    //   4*u3*u3_by_theta3_from_theta1*sin(theta1) + 6*u3_by_theta3_from_theta1*sin(theta1 +
    //   theta2_from_theta1)*(u3 + u4_from_u3) + 2*u3_by_theta3_from_theta1*sin(theta1 +
    //   theta3_from_theta1)*(u3 +
    //   u5_from_u3)))/(750*(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) - 33
    //   - cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))))
    let r1__by_theta3_from_theta1 = u3_part_12_inv_scaled
        * (-cos_theta3_from_theta1
            * (-r1__part_22).mul_add(cos_theta3_from_theta1, u3_part_4 * r1__part_21)
            + u3_by_theta3_from_theta1 * r1__part_19
            - r1__part_24 * sin_theta3_from_theta1
            - r1__part_28 * r1__by_theta2_from_theta1_part_5
            - u3
                * (sin_theta3_from_theta1
                    * (r1__part_11
                        + u3_by_theta3_from_theta1
                            * r1__part_13.mul_add(u5_from_u3_dot_part_2, S::int(13)))
                    + u3_part_10 * r1__by_theta3_from_theta1_part
                    + cos_theta3_from_theta1
                        * (r1__part_17 + r1__by_theta3_from_theta1_part_3)))
        + S::ratio(7, 750) * r1__by_theta2_from_theta1_part_27
            * r1__by_theta3_from_theta1_part_6
        + S::ratio(7, 375) * r1__by_theta2_from_theta1_part_31
            * r1__by_theta3_from_theta1_part_7
        + r1__part_75_scaled
            * r1__by_theta2_from_theta1_part_27
                .mul_add(
                    r1__by_theta3_from_theta1_part_8,
                    r1__by_theta3_from_theta1_part_19,
                );
    // u5_from_u3_dot_by_theta3_from_theta1 = 375*r1_*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))))*(sin(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1))) +
    //   cos(theta3_from_theta1)*(5*sin(theta3_from_theta1) +
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*cos(theta3_from_theta1) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))))/(14*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1))))^2) -
    //   375*r1_*(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*cos(theta3_from_theta1) +
    //   sin(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))) +
    //   9*cos(theta3_from_theta1)*(sin(theta3_from_theta1) +
    //   2*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*cos(theta3_from_theta1) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))))/(14*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1))))) + 375*r1__by_theta3_from_theta1*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(14*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot_by_theta3_from_theta1 = u5_from_u3_dot_part_6
        * (r1__by_theta3_from_theta1
            + u5_from_u3_dot_by_theta2_from_theta1_part
                * (cos_theta3_from_theta1
                    * (-r1__part_45)
                        .mul_add(
                            u5_from_u3_dot_part_2,
                            S::int(5) * sin_theta3_from_theta1,
                        ) + u5_from_u3_dot_part_3 * sin_theta3_from_theta1))
        - S::ratio(375, 14) * u5_from_u3_dot_by_theta2_from_theta1_part
            * r1__by_theta3_from_theta1_part_8;
    // u4_from_u3_dot_by_theta3_from_theta1 = 2*(sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   3*sin(theta2_from_theta1)*cos(theta3_from_theta1))*(9*u3^2*sin(theta2_from_theta1) +
    //   6*sin(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3)^2 + 3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + ((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(2*u3^2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1)*(u3 + u4_from_u3)^2
    //   + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) + (3*cos(theta1 + theta2_from_theta1) - (7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))*(2*u3^2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1)*(u3 +
    //   u4_from_u3)^2 + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) +
    //   u5_from_u3'*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))/(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))) - (13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*cos(theta3_from_theta1)
    //   + sin(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))) +
    //   9*cos(theta3_from_theta1)*(sin(theta3_from_theta1) +
    //   2*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*cos(theta3_from_theta1) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))))*(9*u3^2*sin(theta2_from_theta1) +
    //   6*sin(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3)^2 + 3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + ((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(2*u3^2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1)*(u3 + u4_from_u3)^2
    //   + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) + (3*cos(theta1 + theta2_from_theta1) - (7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))*(2*u3^2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1)*(u3 +
    //   u4_from_u3)^2 + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) +
    //   u5_from_u3'*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))/(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))^2 + (13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(6*cos(theta2_from_theta1 -
    //   theta3_from_theta1)*(u3 + u5_from_u3)^2 + 9*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + 6*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(3*sin(theta2_from_theta1)*cos(theta3_from_theta1) -
    //   sin(theta3_from_theta1) -
    //   3*cos(theta2_from_theta1)*sin(theta3_from_theta1))*(3*u4_from_u3^2*sin(theta2_from_theta1) +
    //   u5_from_u3^2*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3^2
    //   - u5_from_u3^2) + 2*u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2 + (3*(2*sin(theta1) + 3*sin(theta1 +
    //   theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - cos(theta1 + theta3_from_theta1)*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + 2*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))*(3*sin(theta2_from_theta1)*cos(theta3_from_theta1) - sin(theta3_from_theta1) -
    //   3*cos(theta2_from_theta1)*sin(theta3_from_theta1))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2)*(2*u3^2*cos(theta1) + 3*cos(theta1 +
    //   theta2_from_theta1)*(u3 + u4_from_u3)^2 + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) -
    //   (sin(theta1 + theta3_from_theta1)*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + 3*(2*cos(theta1) + 3*cos(theta1 +
    //   theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + 2*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))*(3*sin(theta2_from_theta1)*cos(theta3_from_theta1) - sin(theta3_from_theta1) -
    //   3*cos(theta2_from_theta1)*sin(theta3_from_theta1))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2)*(2*u3^2*sin(theta1) + 3*sin(theta1 +
    //   theta2_from_theta1)*(u3 + u4_from_u3)^2 + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2) +
    //   2*u5_from_u3'*(12 - 9*sin(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) -
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   3*sin(theta2_from_theta1)*cos(theta3_from_theta1))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2 -
    //   u5_from_u3'*(9*sin(theta2_from_theta1)*cos(theta3_from_theta1) + sin(theta3_from_theta1)*(7 -
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 9*cos(theta3_from_theta1)) +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*cos(theta3_from_theta1) -
    //   sin(theta3_from_theta1)*(2 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1))) +
    //   cos(theta3_from_theta1)*(6*sin(theta2_from_theta1)*cos(theta3_from_theta1) - sin(theta3_from_theta1)
    //   - 6*cos(theta2_from_theta1)*sin(theta3_from_theta1))) +
    //   3*cos(theta3_from_theta1)*(3*sin(theta3_from_theta1) +
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) -
    //   18*u3*u3_by_theta3_from_theta1*sin(theta2_from_theta1) -
    //   12*u3_by_theta3_from_theta1*sin(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3) - 3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(u5_from_u3^2*cos(theta3_from_theta1) + 2*cos(theta2_from_theta1 -
    //   theta3_from_theta1)*(u5_from_u3^2 - u4_from_u3^2) + 2*u3*(u5_from_u3*cos(theta3_from_theta1) +
    //   2*cos(theta2_from_theta1 - theta3_from_theta1)*(u5_from_u3 - u4_from_u3)) +
    //   2*u3_by_theta3_from_theta1*(3*u4_from_u3*sin(theta2_from_theta1) +
    //   u5_from_u3*sin(theta3_from_theta1) + 2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 -
    //   u5_from_u3)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + ((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2 -
    //   4*u3*u3_by_theta3_from_theta1*cos(theta1) - 6*u3_by_theta3_from_theta1*cos(theta1 +
    //   theta2_from_theta1)*(u3 + u4_from_u3) - 2*u3_by_theta3_from_theta1*cos(theta1 +
    //   theta3_from_theta1)*(u3 + u5_from_u3)) + ((7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 +
    //   theta2_from_theta1) + cos(theta1 + theta3_from_theta1))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*cos(theta1 +
    //   theta2_from_theta1))*(cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)^2 +
    //   4*u3*u3_by_theta3_from_theta1*sin(theta1) + 6*u3_by_theta3_from_theta1*sin(theta1 +
    //   theta2_from_theta1)*(u3 + u4_from_u3) + 2*u3_by_theta3_from_theta1*sin(theta1 +
    //   theta3_from_theta1)*(u3 + u5_from_u3)) + u5_from_u3_dot_by_theta3_from_theta1*(12 -
    //   9*sin(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) -
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))/(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))
    let u4_from_u3_dot_by_theta3_from_theta1 = u4_from_u3_dot_by_theta2_from_theta1_part_6
        * r1__by_theta3_from_theta1_part_10
        - u4_from_u3_dot_by_theta2_from_theta1_part_7 * r1__by_theta3_from_theta1_part_8
        + u4_from_u3_dot_by_theta2_from_theta1_part_5
            * ((-u5_from_u3_dot_by_theta3_from_theta1)
                .mul_add(
                    u4_from_u3_dot_by_theta2_from_theta1_part,
                    r1__by_theta3_from_theta1_part_18,
                )
                - u4_from_u3_dot_by_theta2_from_theta1_part_2
                    * r1__by_theta3_from_theta1_part_6
                - u4_from_u3_dot_by_theta2_from_theta1_part_4
                    * r1__by_theta3_from_theta1_part_10);
    // u3_by_u4_from_u3 = -(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3_by_u4_from_u3 = -r1__part_34;
    // Shared terms.
    // u4_from_u3*r1__by_theta3_from_theta1_part_4; used 2 times
    let r1__by_u4_from_u3_part = u4_from_u3 * r1__by_theta3_from_theta1_part_4;
    // 1 + u3_by_u4_from_u3; used 4 times
    let r1__by_u4_from_u3_part_2 = S::int(1) + u3_by_u4_from_u3;
    // 2*u3_by_u4_from_u3; used 4 times
    let u3_by_u4_from_u3_scaled = S::int(2) * u3_by_u4_from_u3;
    // 1 + u3_part_8*r1__by_u4_from_u3_part_2 + u3_by_u4_from_u3_scaled; used 2 times
    let r1__by_u4_from_u3_part_3 = u3_part_8.mul_add(r1__by_u4_from_u3_part_2, S::int(1))
        + u3_by_u4_from_u3_scaled;
    // 1 + cos(theta2_from_theta1); used 2 times
    let r1__by_u4_from_u3_part_4 = S::int(1) + cos_theta2_from_theta1;
    // 6*sin(theta3_from_theta1); used 2 times
    let r1__by_u4_from_u3_part_5 = S::int(6) * sin_theta3_from_theta1;
    // 7*r1__part_75/375; used 2 times
    let r1__part_75_scaled_2 = S::ratio(7, 375) * r1__part_75;
    // Elimination, step by step.
    // r1__by_u4_from_u3 = 7*(6*cos(theta3_from_theta1)*(sin(theta2_from_theta1)*(3*u4_from_u3*(3 +
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
    //   u3_by_u4_from_u3))))/(750*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))) +
    //   7*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(9*u3*u3_by_u4_from_u3*sin(theta2_from_theta1) +
    //   6*u3_by_u4_from_u3*sin(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3) + ((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(2*u3*u3_by_u4_from_u3*cos(theta1) + u3_by_u4_from_u3*cos(theta1 +
    //   theta3_from_theta1)*(u3 + u5_from_u3) + 3*cos(theta1 + theta2_from_theta1)*(u3 + u4_from_u3)*(1 +
    //   u3_by_u4_from_u3)) + (3*cos(theta1 + theta2_from_theta1) - (7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))*(2*u3*u3_by_u4_from_u3*sin(theta1) + u3_by_u4_from_u3*sin(theta1 +
    //   theta3_from_theta1)*(u3 + u5_from_u3) + 3*sin(theta1 + theta2_from_theta1)*(u3 + u4_from_u3)*(1 +
    //   u3_by_u4_from_u3)) + 3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(u3*(3*sin(theta2_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)) + 3*u4_from_u3*sin(theta2_from_theta1) +
    //   2*u4_from_u3*sin(theta2_from_theta1 - theta3_from_theta1) +
    //   u3_by_u4_from_u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))/(375*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))))
    let r1__by_u4_from_u3 = u3_part_12_inv_scaled
        * (S::int(6) * cos_theta3_from_theta1
            * (sin_theta2_from_theta1
                * r1__by_u4_from_u3_part
                    .mul_add(cos_theta3_from_theta1, r1__part_2 * u4_from_u3_scaled_2)
                + sin_theta3_from_theta1
                    * (-r1__by_u4_from_u3_part)
                        .mul_add(cos_theta2_from_theta1, u4_from_u3_scaled_2))
            + u3_by_u4_from_u3 * r1__part_19
            + u3
                * (cos_theta3_from_theta1
                    * (u3_part_3
                        * (u3_by_u4_from_u3.mul_add(r1__part, S::int(18) + u3_part_8)
                            + u3_part_9 * r1__by_u4_from_u3_part_3)
                        + r1__part_10
                            * (u3_by_u4_from_u3.mul_add(S::int(8), S::int(9))
                                - u3_part_2 * r1__by_u4_from_u3_part_3))
                    - sin_theta3_from_theta1
                        * (S::int(18) + S::int(13) * u3_by_u4_from_u3
                            + u3_part_2
                                * u3_by_u4_from_u3
                                    .mul_add(r1__part_13_scaled, S::int(20) + u3_part_8))
                    - u3_part_10
                        * u3_part_2
                            .mul_add(
                                r1__by_u4_from_u3_part_2,
                                S::int(3) + u3_by_u4_from_u3,
                            )) - u4_from_u3 * r1__part_73 * r1__by_u4_from_u3_part_4
            - r1__by_u4_from_u3_part_5
                * r1__part_15.mul_add(cos_theta2_from_theta1, u4_from_u3_scaled_2))
        + r1__part_75_scaled_2
            * (r1__part_34_scaled
                * (r1__part_3 * (u3_part_3 + r1__part_45_scaled_scaled)
                    + u3_by_u4_from_u3 * r1__part_46)
                - r1__part_50
                    * r1__part_52
                        .mul_add(
                            r1__by_u4_from_u3_part_2,
                            u3_by_u4_from_u3 * r1__by_theta2_from_theta1_part_6,
                        )
                + S::int(3) * u3_by_u4_from_u3 * r1__by_theta2_from_theta1_part_9
                + r1__part_35
                    * r1__part_39
                        .mul_add(
                            r1__by_u4_from_u3_part_2,
                            u3_by_u4_from_u3 * r1__by_theta2_from_theta1_part_11,
                        ));
    // u5_from_u3_dot_by_u4_from_u3 = 375*r1__by_u4_from_u3*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(14*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot_by_u4_from_u3 = r1__by_u4_from_u3 * u5_from_u3_dot_part_6;
    // Shared terms.
    // u5_from_u3 + r1__part_5; used 2 times
    let u4_from_u3_dot_by_u4_from_u3_part = u5_from_u3 + r1__part_5;
    // r1__part_3 + u3_by_u4_from_u3*u4_from_u3_dot_by_u4_from_u3_part; used 2 times
    let u4_from_u3_dot_by_u4_from_u3_part_2 = u3_by_u4_from_u3
        .mul_add(u4_from_u3_dot_by_u4_from_u3_part, r1__part_3);
    // u5_from_u3 + 2*r1__part_5; used 2 times
    let u4_from_u3_dot_by_u4_from_u3_part_3 = r1__part_5.mul_add(S::int(2), u5_from_u3);
    // u5_from_u3_dot_by_u4_from_u3*sin(theta3_from_theta1); used 2 times
    let u4_from_u3_dot_by_u4_from_u3_part_4 = u5_from_u3_dot_by_u4_from_u3
        * sin_theta3_from_theta1;
    // u4_from_u3_scaled + u3_scaled_2; used 2 times
    let u4_from_u3_dot_by_u4_from_u3_part_5 = u4_from_u3_scaled + u3_scaled_2;
    // Elimination, step by step.
    // u4_from_u3_dot_by_u4_from_u3 = (6*sin(theta2_from_theta1)*(7*u3 + 7*u4_from_u3 +
    //   u3_by_u4_from_u3*(13*u3 + 7*u4_from_u3 + u5_from_u3*(1 - 3*cos(theta2_from_theta1)))) -
    //   3*u5_from_u3_dot_by_u4_from_u3*(4 + 3*cos(theta2_from_theta1)*(1 + cos(theta2_from_theta1))) +
    //   cos(theta3_from_theta1)*(18*sin(theta3_from_theta1)*(u3 + u4_from_u3 + u3_by_u4_from_u3*(2*u3 +
    //   u4_from_u3 + u5_from_u3)) - u5_from_u3_dot_by_u4_from_u3*(7 + 9*cos(theta3_from_theta1)) +
    //   3*cos(theta2_from_theta1)*(u5_from_u3_dot_by_u4_from_u3*(2 + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1))) -
    //   2*sin(theta3_from_theta1)*(u3_by_u4_from_u3*(2*u3 + u5_from_u3) + 6*cos(theta2_from_theta1)*(u3 +
    //   u4_from_u3 + u3_by_u4_from_u3*(2*u3 + u4_from_u3 + u5_from_u3))) +
    //   6*sin(theta2_from_theta1)*(2*u3*(1 + cos(theta3_from_theta1)) + 2*u4_from_u3*(1 +
    //   cos(theta3_from_theta1)) + u3_by_u4_from_u3*(4*u3 + 2*u4_from_u3 + u5_from_u3 +
    //   2*cos(theta3_from_theta1)*(2*u3 + u4_from_u3 + u5_from_u3)) +
    //   u5_from_u3_dot_by_u4_from_u3*sin(theta3_from_theta1))) + 3*sin(theta2_from_theta1)*(14*u3 +
    //   14*u4_from_u3 + 2*u3_by_u4_from_u3*(u3*(15 + 2*cos(theta3_from_theta1)) + 7*u4_from_u3 +
    //   u5_from_u3*(6 + cos(theta3_from_theta1))) + u5_from_u3_dot_by_u4_from_u3*sin(theta3_from_theta1))) +
    //   sin(theta3_from_theta1)*(18*u3 + 18*u4_from_u3 + 2*u3_by_u4_from_u3*(18*u3 + 9*u4_from_u3 +
    //   7*u5_from_u3) + 9*u5_from_u3_dot_by_u4_from_u3*sin(theta2_from_theta1) +
    //   3*cos(theta2_from_theta1)*(3*u5_from_u3_dot_by_u4_from_u3*sin(theta2_from_theta1) - 2*u3*(7 +
    //   6*cos(theta2_from_theta1)) - 2*u4_from_u3*(7 + 6*cos(theta2_from_theta1)) -
    //   2*u3_by_u4_from_u3*(13*u3 + 7*u4_from_u3 + 5*u5_from_u3 + 3*cos(theta2_from_theta1)*(4*u3 +
    //   2*u4_from_u3 +
    //   u5_from_u3)))))/(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) - 33 -
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))
    let u4_from_u3_dot_by_u4_from_u3 = r1__part_74_inv
        * (S::int(3) * u5_from_u3_dot_by_u4_from_u3
            * u3_part_2.mul_add(r1__by_u4_from_u3_part_4, S::int(4))
            - cos_theta3_from_theta1
                * (S::int(18) * u4_from_u3_dot_by_u4_from_u3_part_2
                    * sin_theta3_from_theta1 - u5_from_u3_dot_by_u4_from_u3 * r1__part_61
                    + u3_part_2
                        * (-r1__part_10
                            * (u3_by_u4_from_u3 * (u5_from_u3 + u3_scaled)
                                + u3_part_8 * u4_from_u3_dot_by_u4_from_u3_part_2)
                            + u5_from_u3_dot_by_u4_from_u3 * r1__part_65
                            + u3_part_10
                                * (u3_by_u4_from_u3
                                    * u3_part_9
                                        .mul_add(
                                            u4_from_u3_dot_by_u4_from_u3_part,
                                            u4_from_u3_dot_by_u4_from_u3_part_3,
                                        ) + u3_part * r1__part_3_scaled_2
                                    + u4_from_u3_dot_by_u4_from_u3_part_4))
                    + u3_part_3
                        * (u3_by_u4_from_u3_scaled
                            * (u5_from_u3 * (S::int(6) + cos_theta3_from_theta1)
                                + u4_from_u3_scaled + u3 * (S::int(15) + u3_part_9))
                            + S::int(14) * r1__part_3
                            + u4_from_u3_dot_by_u4_from_u3_part_4))
            - sin_theta3_from_theta1
                * (S::int(18) * r1__part_3 + u5_from_u3_dot_by_u4_from_u3 * r1__part_55
                    + u3_by_u4_from_u3_scaled
                        * r1__part_5.mul_add(S::int(9), u5_from_u3_scaled)
                    + u3_part_2
                        * (u5_from_u3_dot_by_u4_from_u3 * u3_part_3
                            - r1__part_3_scaled_2 * u3_by_theta3_from_theta1_part
                            - u3_by_u4_from_u3_scaled
                                * (u3_part_2
                                    .mul_add(
                                        u4_from_u3_dot_by_u4_from_u3_part_3,
                                        S::int(5) * u5_from_u3,
                                    ) + u4_from_u3_dot_by_u4_from_u3_part_5)))
            - u3_part_10
                * (u3_by_u4_from_u3
                    * (u5_from_u3 * (S::int(1) - u3_part_2)
                        + u4_from_u3_dot_by_u4_from_u3_part_5)
                    + S::int(7) * r1__part_3));
    // u3_by_u5_from_u3 = -(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))
    let u3_by_u5_from_u3 = -u3_part_7 * u3_part_12_inv;
    // Shared terms.
    // 1 + u3_by_u5_from_u3; used 3 times
    let r1__by_u5_from_u3_part = S::int(1) + u3_by_u5_from_u3;
    // u3_part_6*r1__by_u5_from_u3_part; used 3 times
    let r1__by_u5_from_u3_part_2 = u3_part_6 * r1__by_u5_from_u3_part;
    // u5_from_u3*u3_part_6; used 3 times
    let u5_from_u3_u3_part_6 = u5_from_u3 * u3_part_6;
    // r1__part_8*(sin(theta3_from_theta1) - r1__part_45_scaled_scaled) + u3_by_u5_from_u3*r1__part_46;
    //   used 2 times
    let r1__by_u5_from_u3_part_3 = r1__part_8
        * (sin_theta3_from_theta1 - r1__part_45_scaled_scaled)
        + u3_by_u5_from_u3 * r1__part_46;
    // r1__part_8*r1__by_u5_from_u3_part; used 3 times
    let r1__by_u5_from_u3_part_4 = r1__part_8 * r1__by_u5_from_u3_part;
    // 6*sin(theta2_from_theta1 - theta3_from_theta1)*r1__by_u5_from_u3_part_4 -
    //   r1__part_50*(u3_by_u5_from_u3*(cos_theta1_u3_scaled + r1__part_52) + cos(theta1 +
    //   theta3_from_theta1)*r1__by_u5_from_u3_part_4)
    let r1__by_u5_from_u3_part_5 = -r1__part_50
        * (u3_by_u5_from_u3 * (cos_theta1_u3_scaled + r1__part_52)
            + r1__part_31 * r1__by_u5_from_u3_part_4)
        + S::int(6) * r1__part_45_scaled * r1__by_u5_from_u3_part_4;
    // r1__part_35*(u3_by_u5_from_u3*(sin_theta1_u3_scaled + r1__part_39) + sin(theta1 +
    //   theta3_from_theta1)*r1__by_u5_from_u3_part_4) + r1__by_u5_from_u3_part_5; used 2 times
    let r1__by_u5_from_u3_part_6 = r1__part_35
        * (u3_by_u5_from_u3 * (sin_theta1_u3_scaled + r1__part_39)
            + r1__part_36 * r1__by_u5_from_u3_part_4) + r1__by_u5_from_u3_part_5;
    // u3*u3_by_u5_from_u3; used 2 times
    let u3_u3_by_u5_from_u3 = u3 * u3_by_u5_from_u3;
    // Elimination, step by step.
    // r1__by_u5_from_u3 = 7*(2*cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*(3*u5_from_u3 +
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
    //   + 9*cos(theta2_from_theta1)*(2 + u3_by_u5_from_u3*(5 + 2*cos(theta2_from_theta1))))))/(750*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))) +
    //   7*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))*(9*u3*u3_by_u5_from_u3*sin(theta2_from_theta1) +
    //   6*sin(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3)*(1 + u3_by_u5_from_u3) + ((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(2*u3*u3_by_u5_from_u3*cos(theta1) + 3*u3_by_u5_from_u3*cos(theta1 +
    //   theta2_from_theta1)*(u3 + u4_from_u3) + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)*(1 +
    //   u3_by_u5_from_u3)) + (3*cos(theta1 + theta2_from_theta1) - (7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))*(2*u3*u3_by_u5_from_u3*sin(theta1) + 3*u3_by_u5_from_u3*sin(theta1 +
    //   theta2_from_theta1)*(u3 + u4_from_u3) + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)*(1 +
    //   u3_by_u5_from_u3)) + 3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(u3*(sin(theta3_from_theta1) -
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)) + u5_from_u3*sin(theta3_from_theta1) -
    //   2*u5_from_u3*sin(theta2_from_theta1 - theta3_from_theta1) +
    //   u3_by_u5_from_u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))/(375*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))))
    let r1__by_u5_from_u3 = u3_part_12_inv_scaled
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
                            ))
                - sin_theta3_from_theta1
                    * (S::int(6) + S::int(13) * u3_by_u5_from_u3
                        + u5_from_u3_dot_part_2
                            * u3_by_u5_from_u3.mul_add(r1__part_13, S::int(2)))
                - u3_part_10 * r1__by_u5_from_u3_part_2) + u3_by_u5_from_u3 * r1__part_19
            - u5_from_u3_u3_part_6 * (u3_part_10 + r1__by_u4_from_u3_part_5)
            + u3_part_9
                * (u3_part_3
                    * u3_part_9.mul_add(u5_from_u3_u3_part_6, S::int(3) * u5_from_u3)
                    + r1__part_10
                        * (-u3_part_2)
                            .mul_add(u5_from_u3_u3_part_6, S::int(4) * u5_from_u3)))
        + r1__part_75_scaled_2
            * (r1__part_34_scaled
                .mul_add(r1__by_u5_from_u3_part_3, r1__by_u5_from_u3_part_6)
                + r1__part_55 * u3_u3_by_u5_from_u3);
    // u5_from_u3_dot_by_u5_from_u3 = 375*r1__by_u5_from_u3*(33 -
    //   18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/(14*(9 +
    //   cos(theta3_from_theta1)*(5*cos(theta3_from_theta1) -
    //   9*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))))
    let u5_from_u3_dot_by_u5_from_u3 = r1__by_u5_from_u3 * u5_from_u3_dot_part_6;
    // u4_from_u3_dot_by_u5_from_u3 = (13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(18*u3*u3_by_u5_from_u3*sin(theta2_from_theta1) +
    //   12*sin(theta2_from_theta1 - theta3_from_theta1)*(u3 + u5_from_u3)*(1 + u3_by_u5_from_u3) + 2*((7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 3*sin(theta1
    //   + theta2_from_theta1))*(2*u3*u3_by_u5_from_u3*cos(theta1) + 3*u3_by_u5_from_u3*cos(theta1 +
    //   theta2_from_theta1)*(u3 + u4_from_u3) + cos(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)*(1 +
    //   u3_by_u5_from_u3)) + 2*(3*cos(theta1 + theta2_from_theta1) - (7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))*(2*u3*u3_by_u5_from_u3*sin(theta1) + 3*u3_by_u5_from_u3*sin(theta1 +
    //   theta2_from_theta1)*(u3 + u4_from_u3) + sin(theta1 + theta3_from_theta1)*(u3 + u5_from_u3)*(1 +
    //   u3_by_u5_from_u3)) + 6*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(u3*(sin(theta3_from_theta1) -
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)) + u5_from_u3*sin(theta3_from_theta1) -
    //   2*u5_from_u3*sin(theta2_from_theta1 - theta3_from_theta1) +
    //   u3_by_u5_from_u3*(3*u4_from_u3*sin(theta2_from_theta1) + u5_from_u3*sin(theta3_from_theta1) +
    //   2*sin(theta2_from_theta1 - theta3_from_theta1)*(u4_from_u3 - u5_from_u3)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   u5_from_u3_dot_by_u5_from_u3*(9*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 12 +
    //   3*cos(theta2_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 3 -
    //   3*cos(theta2_from_theta1) + cos(theta3_from_theta1)*(2 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + 2*cos(theta3_from_theta1)))) +
    //   cos(theta3_from_theta1)*(3*sin(theta2_from_theta1)*sin(theta3_from_theta1) - 7 -
    //   9*cos(theta3_from_theta1)))/(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))))/(18*sin(theta2_from_theta1)*cos(theta2_from_theta1)*sin(theta3_from_theta1)
    //   - 33 - cos(theta3_from_theta1)*(14 + 9*cos(theta3_from_theta1) -
    //   18*cos(theta2_from_theta1)*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))
    let u4_from_u3_dot_by_u5_from_u3 = -u4_from_u3_dot_by_theta2_from_theta1_part_5
        * ((r1__part_34 * r1__by_u5_from_u3_part_3)
            .mul_add(
                S::int(6),
                u5_from_u3_dot_by_u5_from_u3 * u4_from_u3_dot_by_theta2_from_theta1_part,
            ) + S::int(2) * r1__by_u5_from_u3_part_6
            + r1__part_73 * u3_u3_by_u5_from_u3);
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
/// 24 operations, 2 sines and cosines.
#[must_use]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [S; 3] {
    let Parameters { H_n3, .. } = *p;
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
    // u5_from_u3*(3 + cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1)) + 3*u3_part) + u4_from_u3*(7
    //   + 3*u3_part_2)
    let u3_part_3 = u5_from_u3
        * (S::int(3)
            + cos_theta3_from_theta1
                * cos_theta2_from_theta1.mul_add(S::int(3), S::int(1))
            + S::int(3) * u3_part)
        + u4_from_u3 * u3_part_2.mul_add(S::int(3), S::int(7));
    // Elimination, step by step.
    // u3 = (750*H_n3 - 7*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 7*u5_from_u3*(3 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1))))/(7*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))
    let u3 = S::ratio(1, 7) * (-u3_part_3).mul_add(S::int(7), S::int(750) * H_n3)
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
/// 45 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> S {
    let Parameters { H_n3, .. } = *p;
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
    // u3 = (750*H_n3 - 7*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 7*u5_from_u3*(3 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1))))/(7*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))
    let u3 = S::ratio(1, 7) * u3_part_4_inv
        * (-u3_part_3).mul_add(S::int(7), S::int(750) * H_n3);
    // Shared terms.
    // u4_from_u3*(7*u4_from_u3 + 6*u5_from_u3*(cos(theta2_from_theta1)*cos(theta3_from_theta1) + u3_part))
    //   + u3*(2*u3_part_3 + u3*u3_part_4)
    let energy_part = u4_from_u3
        * (S::int(6) * u5_from_u3
            * cos_theta2_from_theta1.mul_add(cos_theta3_from_theta1, u3_part)
            + S::int(7) * u4_from_u3)
        + u3 * u3.mul_add(u3_part_4, S::int(2) * u3_part_3);
    // Values.
    // T = 7*u5_from_u3^2/500 + 7*u3*(u3*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   2*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + 2*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/1500 + 7*u4_from_u3*(7*u4_from_u3 +
    //   6*u5_from_u3*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))/1500 - 375*H_n3^2/(7*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))
    let energy = S::ratio(7, 500) * u5_from_u3 * u5_from_u3
        - S::ratio(375, 7) * H_n3 * H_n3 * u3_part_4_inv
        + S::ratio(7, 1500) * energy_part;
    energy
}

/// Potential energy V of gravity, with the kinetic energy of what the momenta determine.
///
/// 16 operations, 2 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3]) -> S {
    let Parameters { p_x, p_y, H_n3, .. } = *p;
    let [theta2_from_theta1, theta3_from_theta1, _] = *q;
    // Sines and cosines.
    let (sin_theta2_from_theta1, cos_theta2_from_theta1) = theta2_from_theta1.sin_cos();
    let (sin_theta3_from_theta1, cos_theta3_from_theta1) = theta3_from_theta1.sin_cos();
    // Shared terms.
    // sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))
    let energy_part = cos_theta2_from_theta1 * (S::int(1) + cos_theta3_from_theta1)
        + sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // p_x^2 + p_y^2
    let p_x_2_plus_p_y_2 = p_y.mul_add(p_y, p_x * p_x);
    // Values.
    // V = 5*p_x^2/21 + 5*p_y^2/21 + 375*H_n3^2/(7*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1)
    //   + 2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))
    let energy = S::ratio(375, 7) * H_n3 * H_n3
        / (cos_theta3_from_theta1.mul_add(S::int(2), S::int(13))
            + S::int(6) * energy_part) + S::ratio(5, 21) * p_x_2_plus_p_y_2;
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 74 operations, 3 sines and cosines.
#[must_use]
pub fn outputs<S: Scalar>(p: &Parameters<S>, t: S, q: &[S; 3], u: &[S; 2]) -> [S; 10] {
    let Parameters { p_x, p_y, H_n3, centre_x, centre_y } = *p;
    let [theta2_from_theta1, theta3_from_theta1, theta1] = *q;
    let [u4_from_u3, u5_from_u3] = *u;
    // Sines and cosines.
    let (sin_theta2_from_theta1, cos_theta2_from_theta1) = theta2_from_theta1.sin_cos();
    let (sin_theta3_from_theta1, cos_theta3_from_theta1) = theta3_from_theta1.sin_cos();
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    // Shared terms.
    // sin(theta2_from_theta1)*sin(theta3_from_theta1); used 2 times
    let u3_part = sin_theta2_from_theta1 * sin_theta3_from_theta1;
    // cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)) + u3_part
    let u3_part_2 = cos_theta2_from_theta1 * (S::int(1) + cos_theta3_from_theta1)
        + u3_part;
    // 1/(13 + 2*cos(theta3_from_theta1) + 6*u3_part_2); used 3 times
    let u3_part_3 = S::int(1)
        / (cos_theta3_from_theta1.mul_add(S::int(2), S::int(13))
            + S::int(6) * u3_part_2);
    // u4_from_u3*cos(theta2_from_theta1) + u5_from_u3
    let u3_part_4 = u4_from_u3.mul_add(cos_theta2_from_theta1, u5_from_u3);
    // Elimination, step by step.
    // u3 = (750*H_n3 - 7*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 7*u5_from_u3*(3 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1))))/(7*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))
    let u3 = S::ratio(750, 7) * H_n3 * u3_part_3
        - u3_part_3 * u5_from_u3.mul_add(cos_theta3_from_theta1, S::int(7) * u4_from_u3)
        - S::int(3) * u3_part_3
            * ((u4_from_u3 + u5_from_u3)
                * cos_theta2_from_theta1.mul_add(cos_theta3_from_theta1, u3_part)
                + u3_part_4);
    // Shared terms.
    // 2*cos(theta1)/15; used 2 times
    let cos_theta1_scaled = S::ratio(2, 15) * cos_theta1;
    // 10*p_y/21; used 2 times
    let p_y_scaled = S::ratio(10, 21) * p_y;
    // u3 + u4_from_u3; used 3 times
    let u2_part = u3 + u4_from_u3;
    // cos(theta1)*cos(theta2_from_theta1) - sin(theta1)*sin(theta2_from_theta1)
    let u2_part_2 = (-sin_theta1)
        .mul_add(sin_theta2_from_theta1, cos_theta1 * cos_theta2_from_theta1);
    // cos(theta1 + theta2_from_theta1)/5; used 2 times
    let u2_part_2_scaled = S::ratio(1, 5) * u2_part_2;
    // u3 + u5_from_u3; used 3 times
    let u2_part_3 = u3 + u5_from_u3;
    // cos(theta1)*cos(theta3_from_theta1) - sin(theta1)*sin(theta3_from_theta1)
    let u2_part_4 = (-sin_theta1)
        .mul_add(sin_theta3_from_theta1, cos_theta1 * cos_theta3_from_theta1);
    // cos(theta1 + theta3_from_theta1)/15; used 2 times
    let u2_part_4_scaled = S::ratio(1, 15) * u2_part_4;
    // Elimination, step by step.
    // u2 = 10*p_y/21 - u3*(2*cos(theta1) + 3*cos(theta1 + theta2_from_theta1) + cos(theta1 +
    //   theta3_from_theta1))/15 - u4_from_u3*cos(theta1 + theta2_from_theta1)/5 - u5_from_u3*cos(theta1 +
    //   theta3_from_theta1)/15
    let u2 = (-u3).mul_add(cos_theta1_scaled, p_y_scaled) - u2_part * u2_part_2_scaled
        - u2_part_3 * u2_part_4_scaled;
    // Shared terms.
    // 2*sin(theta1)/15; used 2 times
    let sin_theta1_scaled = S::ratio(2, 15) * sin_theta1;
    // 10*p_x/21; used 2 times
    let p_x_scaled = S::ratio(10, 21) * p_x;
    // cos(theta1)*sin(theta2_from_theta1) + sin(theta1)*cos(theta2_from_theta1)
    let u1_part = sin_theta1
        .mul_add(cos_theta2_from_theta1, cos_theta1 * sin_theta2_from_theta1);
    // sin(theta1 + theta2_from_theta1)/5; used 2 times
    let u1_part_scaled = S::ratio(1, 5) * u1_part;
    // cos(theta1)*sin(theta3_from_theta1) + sin(theta1)*cos(theta3_from_theta1)
    let u1_part_2 = sin_theta1
        .mul_add(cos_theta3_from_theta1, cos_theta1 * sin_theta3_from_theta1);
    // sin(theta1 + theta3_from_theta1)/15; used 2 times
    let u1_part_2_scaled = S::ratio(1, 15) * u1_part_2;
    // Elimination, step by step.
    // u1 = u3*(2*sin(theta1) + 3*sin(theta1 + theta2_from_theta1) + sin(theta1 + theta3_from_theta1))/15 +
    //   u4_from_u3*sin(theta1 + theta2_from_theta1)/5 + u5_from_u3*sin(theta1 + theta3_from_theta1)/15 +
    //   10*p_x/21
    let u1 = u3.mul_add(sin_theta1_scaled, p_x_scaled) + u2_part * u1_part_scaled
        + u2_part_3 * u1_part_2_scaled;
    // Values.
    // x = 10*p_x*t/21 - 2*cos(theta1)/15 - cos(theta1 + theta2_from_theta1)/5 - cos(theta1 +
    //   theta3_from_theta1)/15 + 10*centre_x/21
    let x_value = t
        .mul_add(
            p_x_scaled,
            S::ratio(10, 21) * centre_x - cos_theta1_scaled - u2_part_2_scaled
                - u2_part_4_scaled,
        );
    // y = 10*p_y*t/21 - 2*sin(theta1)/15 - sin(theta1 + theta2_from_theta1)/5 - sin(theta1 +
    //   theta3_from_theta1)/15 + 10*centre_y/21
    let y_value = t.mul_add(p_y_scaled, S::ratio(10, 21) * centre_y) - sin_theta1_scaled
        - u1_part_scaled - u1_part_2_scaled;
    // theta1 = theta1
    let theta1_value = theta1;
    // theta2 = theta1 + theta2_from_theta1
    let theta2_value = theta1 + theta2_from_theta1;
    // theta3 = theta1 + theta3_from_theta1
    let theta3_value = theta1 + theta3_from_theta1;
    // u4 = u3 + u4_from_u3
    let u4_value = u2_part;
    // u5 = u3 + u5_from_u3
    let u5_value = u2_part_3;
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
/// 111 operations, 2 sines and cosines.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [S; 6] {
    let Parameters { p_x, p_y, H_n3, .. } = *p;
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
    // 1/u3_part_8; used 4 times
    let u3_part_8_inv = S::int(1) / u3_part_8;
    // u3_part_8_inv*(7*u3_part_7 - 750*H_n3); used 2 times
    let u3_part_9 = u3_part_8_inv * (-H_n3).mul_add(S::int(750), S::int(7) * u3_part_7);
    // Elimination, step by step.
    // u3 = (750*H_n3 - 7*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 7*u5_from_u3*(3 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1))))/(7*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))
    let u3 = -S::ratio(1, 7) * u3_part_9;
    // Shared terms.
    // cos(theta2_from_theta1)*cos(theta3_from_theta1) + u3_part_2; used 3 times
    let energy_part = cos_theta2_from_theta1.mul_add(cos_theta3_from_theta1, u3_part_2);
    // 2*u3_part_7 + u3*u3_part_8; used 4 times
    let energy_part_2 = u3.mul_add(u3_part_8, S::int(2) * u3_part_7);
    // u4_from_u3*(7*u4_from_u3 + 6*u5_from_u3*energy_part) + u3*energy_part_2
    let energy_part_3 = u4_from_u3
        * (u5_from_u3 * energy_part).mul_add(S::int(6), S::int(7) * u4_from_u3)
        + u3 * energy_part_2;
    // p_x^2 + p_y^2
    let p_x_2_plus_p_y_2 = p_y.mul_add(p_y, p_x * p_x);
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
    // 7*u3_part_8_inv; used 2 times
    let u3_part_8_inv_scaled = S::int(7) * u3_part_8_inv;
    // 2*u3_part_8_inv*u3_part_9; used 2 times
    let energy_by_theta2_from_theta1_part_7 = S::int(2) * u3_part_8_inv * u3_part_9;
    // energy_by_theta2_from_theta1_part_5*energy_by_theta2_from_theta1_part_7 -
    //   energy_by_theta2_from_theta1_part_6*u3_part_8_inv_scaled; used 2 times
    let energy_by_theta2_from_theta1_part_8 = (-energy_by_theta2_from_theta1_part_6)
        .mul_add(
            u3_part_8_inv_scaled,
            energy_by_theta2_from_theta1_part_5 * energy_by_theta2_from_theta1_part_7,
        );
    // 14*u3; used 2 times
    let u3_scaled = S::int(14) * u3;
    // 7*u5_from_u3/250; used 3 times
    let u5_from_u3_scaled = S::ratio(7, 250) * u5_from_u3;
    // u4_from_u3*energy_by_theta2_from_theta1_part_4; used 2 times
    let energy_by_theta2_from_theta1_part_9 = u4_from_u3
        * energy_by_theta2_from_theta1_part_4;
    // u5_from_u3_scaled*energy_by_theta2_from_theta1_part_9; used 2 times
    let energy_by_theta2_from_theta1_part_10 = u5_from_u3_scaled
        * energy_by_theta2_from_theta1_part_9;
    // energy_part_2*energy_by_theta2_from_theta1_part_8 + u3*(14*energy_by_theta2_from_theta1_part_6 +
    //   u3_part_8*energy_by_theta2_from_theta1_part_8 + energy_by_theta2_from_theta1_part_5*u3_scaled)
    let energy_by_theta2_from_theta1_part_11 = u3
        * (u3_part_8
            .mul_add(
                energy_by_theta2_from_theta1_part_8,
                S::int(14) * energy_by_theta2_from_theta1_part_6,
            ) + energy_by_theta2_from_theta1_part_5 * u3_scaled)
        + energy_part_2 * energy_by_theta2_from_theta1_part_8;
    // u5_from_u3*(u3_part_5*sin(theta3_from_theta1) - 3*energy_by_theta2_from_theta1_part_2) +
    //   3*energy_by_theta2_from_theta1_part_9; used 2 times
    let energy_by_theta3_from_theta1_part = u5_from_u3
        * (-energy_by_theta2_from_theta1_part_2)
            .mul_add(S::int(3), u3_part_5 * sin_theta3_from_theta1)
        + S::int(3) * energy_by_theta2_from_theta1_part_9;
    // sin(theta3_from_theta1) - 3*energy_by_theta2_from_theta1_part_3; used 2 times
    let energy_by_theta3_from_theta1_part_2 = (-energy_by_theta2_from_theta1_part_3)
        .mul_add(S::int(3), sin_theta3_from_theta1);
    // energy_by_theta2_from_theta1_part_7*energy_by_theta3_from_theta1_part_2 -
    //   u3_part_8_inv_scaled*energy_by_theta3_from_theta1_part; used 2 times
    let energy_by_theta3_from_theta1_part_3 = (-u3_part_8_inv_scaled)
        .mul_add(
            energy_by_theta3_from_theta1_part,
            energy_by_theta2_from_theta1_part_7 * energy_by_theta3_from_theta1_part_2,
        );
    // energy_part_2*energy_by_theta3_from_theta1_part_3 + u3*(14*energy_by_theta3_from_theta1_part +
    //   u3_scaled*energy_by_theta3_from_theta1_part_2 + u3_part_8*energy_by_theta3_from_theta1_part_3)
    let energy_by_theta3_from_theta1_part_4 = u3
        * (u3_scaled
            .mul_add(
                energy_by_theta3_from_theta1_part_2,
                S::int(14) * energy_by_theta3_from_theta1_part,
            ) + u3_part_8 * energy_by_theta3_from_theta1_part_3)
        + energy_part_2 * energy_by_theta3_from_theta1_part_3;
    // u3_part_8_inv*energy_part_2 - u3
    let energy_by_u4_from_u3_part = u3_part_8_inv.mul_add(energy_part_2, -u3);
    // 7*energy_by_u4_from_u3_part/1500; used 2 times
    let energy_by_u4_from_u3_part_2 = S::ratio(7, 1500) * energy_by_u4_from_u3_part;
    // Values.
    // T + V = 7*u5_from_u3^2/500 + 7*u3*(u3*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   2*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + 2*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/1500 + 7*u4_from_u3*(7*u4_from_u3 +
    //   6*u5_from_u3*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1)))/1500 + 5*p_x^2/21 + 5*p_y^2/21
    let energy = S::ratio(7, 500) * u5_from_u3 * u5_from_u3
        + S::ratio(7, 1500) * energy_part_3 + S::ratio(5, 21) * p_x_2_plus_p_y_2;
    // d(T + V)/d(theta2_from_theta1) =
    //   7*u4_from_u3*u5_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1))/250 + (u3*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + 2*u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + 2*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1))))*(2*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(7*u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + 7*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))) - 750*H_n3)/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2 -
    //   7*(u4_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) - sin(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + u5_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))/500 +
    //   u3*(14*u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) - sin(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + 14*u4_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   14*u5_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1)) + (13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(2*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(7*u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + 7*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))) - 750*H_n3)/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2 -
    //   7*(u4_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) - sin(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + u5_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/500
    let energy_by_theta2_from_theta1 = energy_by_theta2_from_theta1_part_10
        + S::ratio(1, 500) * energy_by_theta2_from_theta1_part_11;
    // d(T + V)/d(theta3_from_theta1) =
    //   7*u4_from_u3*u5_from_u3*(sin(theta2_from_theta1)*cos(theta3_from_theta1) -
    //   cos(theta2_from_theta1)*sin(theta3_from_theta1))/250 + (u3*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) + 2*u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + 2*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1))))*(7*(3*u4_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1)) + u5_from_u3*(sin(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1)) - 3*sin(theta2_from_theta1)*cos(theta3_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) - 2*(sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   3*sin(theta2_from_theta1)*cos(theta3_from_theta1))*(7*u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + 7*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))) - 750*H_n3)/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2)/1500 -
    //   u3*(14*u3*(sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   3*sin(theta2_from_theta1)*cos(theta3_from_theta1)) +
    //   42*u4_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1)) + 14*u5_from_u3*(sin(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1)) - 3*sin(theta2_from_theta1)*cos(theta3_from_theta1)) + (13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))*(2*(sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   3*sin(theta2_from_theta1)*cos(theta3_from_theta1))*(7*u4_from_u3*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + 7*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))) - 750*H_n3)/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))^2 -
    //   7*(3*u4_from_u3*(cos(theta2_from_theta1)*sin(theta3_from_theta1) -
    //   sin(theta2_from_theta1)*cos(theta3_from_theta1)) + u5_from_u3*(sin(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1)) - 3*sin(theta2_from_theta1)*cos(theta3_from_theta1)))/(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))))/1500
    let energy_by_theta3_from_theta1 = -energy_by_theta2_from_theta1_part_10
        - S::ratio(1, 1500) * energy_by_theta3_from_theta1_part_4;
    // d(T + V)/d(u4_from_u3) = 7*u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   3*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1)))/1500 + 49*u4_from_u3/750 +
    //   7*u5_from_u3*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1))/250 - 7*(7 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1)))*(u3*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   2*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + 2*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(1500*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))
    let energy_by_u4_from_u3 = energy_part
        .mul_add(u5_from_u3_scaled, S::ratio(49, 750) * u4_from_u3)
        - u3_part_4 * energy_by_u4_from_u3_part_2;
    // d(T + V)/d(u5_from_u3) = 7*u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1)))/1500 +
    //   7*u4_from_u3*(sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta2_from_theta1)*cos(theta3_from_theta1))/250 + 7*u5_from_u3/250 - 7*(3 +
    //   3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + cos(theta3_from_theta1)*(1 +
    //   3*cos(theta2_from_theta1)))*(u3*(13 + 6*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   2*cos(theta3_from_theta1) + 6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))) +
    //   2*u4_from_u3*(7 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 3*cos(theta2_from_theta1)*(1 +
    //   cos(theta3_from_theta1))) + 2*u5_from_u3*(3 + 3*sin(theta2_from_theta1)*sin(theta3_from_theta1) +
    //   cos(theta3_from_theta1)*(1 + 3*cos(theta2_from_theta1))))/(1500*(13 +
    //   6*sin(theta2_from_theta1)*sin(theta3_from_theta1) + 2*cos(theta3_from_theta1) +
    //   6*cos(theta2_from_theta1)*(1 + cos(theta3_from_theta1))))
    let energy_by_u5_from_u3 = (-u3_part_6)
        .mul_add(
            energy_by_u4_from_u3_part_2,
            S::ratio(7, 250) * u4_from_u3 * energy_part + u5_from_u3_scaled,
        );
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
/// 88 convolutions and 288 linear operations an order.
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 5]],
    history: &mut [Factors<S, 88>],
) {
    let Parameters { H_n3, .. } = *p;
    let [theta2_from_theta1_0, theta3_from_theta1_0, theta1_0, u4_from_u3_0, u5_from_u3_0,
    ] = series[0];
    // Constant in time.
    // minus_750_h_n3 = -750*H_n3
    let minus_750_h_n3 = -S::int(750) * H_n3;
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
    // u3_part_11 = minus_750_h_n3 + 7*u3_part_9 + 7*u3_part_10
    let u3_part_11_0 = u3_part_10_0
        .mul_add(S::int(7), u3_part_9_0.mul_add(S::int(7), minus_750_h_n3));
    // u3_part_12 = u3_part_11/u3_part_8
    let u3_part_12_0 = u3_part_11_0 * over_u3_part_8;
    let (sin_theta1_0, cos_theta1_0) = theta1_0.sin_cos();
    // r1__part = u3_part_12*u3_part_12
    let r1__part_0 = u3_part_12_0 * u3_part_12_0;
    // r1__part_2 = cos_theta1*r1__part
    let r1__part_2_0 = cos_theta1_0 * r1__part_0;
    // r1__part_3 = sin_theta1*r1__part
    let r1__part_3_0 = sin_theta1_0 * r1__part_0;
    // r1__part_4 = theta1 + theta2_from_theta1
    let r1__part_4_0 = theta1_0 + theta2_from_theta1_0;
    // r1__part_5 = theta1 + theta3_from_theta1
    let r1__part_5_0 = theta1_0 + theta3_from_theta1_0;
    let (sin_angle_0, cos_angle_0) = r1__part_4_0.sin_cos();
    let (sin_angle_2_0, cos_angle_2_0) = r1__part_5_0.sin_cos();
    // r1__part_6 = theta2_from_theta1 - theta3_from_theta1
    let r1__part_6_0 = theta2_from_theta1_0 - theta3_from_theta1_0;
    let (sin_angle_3_0, cos_angle_3_0) = r1__part_6_0.sin_cos();
    // r1__part_7 = sin_theta2_from_theta1*r1__part
    let r1__part_7_0 = sin_theta2_from_theta1_0 * r1__part_0;
    // r1__part_8 = 2*sin_theta1 + 3*sin_angle + sin_angle_2
    let r1__part_8_0 = sin_angle_0.mul_add(S::int(3), S::int(2) * sin_theta1_0)
        + sin_angle_2_0;
    // r1__part_9 = 2*cos_theta1 + 3*cos_angle + cos_angle_2
    let r1__part_9_0 = cos_angle_0.mul_add(S::int(3), S::int(2) * cos_theta1_0)
        + cos_angle_2_0;
    // u3_plus_u4_from_u3 = -1/7*u3_part_12 + u4_from_u3
    let u3_plus_u4_from_u3_0 = u3_part_12_0.mul_add(-S::ratio(1, 7), u4_from_u3_0);
    // u3_plus_u5_from_u3 = -1/7*u3_part_12 + u5_from_u3
    let u3_plus_u5_from_u3_0 = u3_part_12_0.mul_add(-S::ratio(1, 7), u5_from_u3_0);
    // r1__part_10 = u3_plus_u4_from_u3*u3_plus_u4_from_u3
    let r1__part_10_0 = u3_plus_u4_from_u3_0 * u3_plus_u4_from_u3_0;
    // r1__part_11 = cos_angle*r1__part_10
    let r1__part_11_0 = cos_angle_0 * r1__part_10_0;
    // r1__part_12 = u3_plus_u5_from_u3*u3_plus_u5_from_u3
    let r1__part_12_0 = u3_plus_u5_from_u3_0 * u3_plus_u5_from_u3_0;
    // r1__part_13 = cos_angle_2*r1__part_12
    let r1__part_13_0 = cos_angle_2_0 * r1__part_12_0;
    // r1__part_14 = sin_theta2_from_theta1*u4_from_u3
    let r1__part_14_0 = sin_theta2_from_theta1_0 * u4_from_u3_0;
    // r1__part_15 = sin_theta3_from_theta1*u5_from_u3
    let r1__part_15_0 = sin_theta3_from_theta1_0 * u5_from_u3_0;
    // u4_from_u3_p2 = u4_from_u3*u4_from_u3
    let u4_from_u3_p2_0 = u4_from_u3_0 * u4_from_u3_0;
    // r1__part_16 = sin_theta2_from_theta1*u4_from_u3_p2
    let r1__part_16_0 = sin_theta2_from_theta1_0 * u4_from_u3_p2_0;
    // r1__part_17 = u5_from_u3*r1__part_15
    let r1__part_17_0 = u5_from_u3_0 * r1__part_15_0;
    // r1__part_18 = sin_angle*r1__part_10
    let r1__part_18_0 = sin_angle_0 * r1__part_10_0;
    // r1__part_19 = sin_angle_2*r1__part_12
    let r1__part_19_0 = sin_angle_2_0 * r1__part_12_0;
    // r1__part_20 = sin_angle_3*r1__part_12
    let r1__part_20_0 = sin_angle_3_0 * r1__part_12_0;
    // r1__part_21 = u4_from_u3 - u5_from_u3
    let r1__part_21_0 = u4_from_u3_0 - u5_from_u3_0;
    // u5_from_u3_p2 = u5_from_u3*u5_from_u3
    let u5_from_u3_p2_0 = u5_from_u3_0 * u5_from_u3_0;
    // r1__part_22 = u4_from_u3_p2 - u5_from_u3_p2
    let r1__part_22_0 = u4_from_u3_p2_0 - u5_from_u3_p2_0;
    // r1__part_23 = sin_angle_3*r1__part_21
    let r1__part_23_0 = sin_angle_3_0 * r1__part_21_0;
    // r1__part_24 = 3*r1__part_14 + r1__part_15 + 2*r1__part_23
    let r1__part_24_0 = r1__part_23_0
        .mul_add(S::int(2), S::int(3) * r1__part_14_0 + r1__part_15_0);
    // r1__part_25 = u3_part_12*r1__part_24
    let r1__part_25_0 = u3_part_12_0 * r1__part_24_0;
    // r1__part_26 = sin_angle_3*r1__part_22
    let r1__part_26_0 = sin_angle_3_0 * r1__part_22_0;
    // r1__part_27 = 3*r1__part_16 + r1__part_17 - 2/7*r1__part_25 + 2*r1__part_26
    let r1__part_27_0 = r1__part_25_0
        .mul_add(
            -S::ratio(2, 7),
            r1__part_26_0.mul_add(S::int(2), S::int(3) * r1__part_16_0) + r1__part_17_0,
        );
    // r1__part_28 = -1/7*u3_part_12 + u4_from_u3 + u5_from_u3
    let r1__part_28_0 = u3_part_12_0
        .mul_add(-S::ratio(1, 7), u4_from_u3_0 + u5_from_u3_0);
    // r1__part_29 = u3_part_4/u3_part_8
    let r1__part_29_0 = u3_part_4_0 * over_u3_part_8;
    // r1__part_30 = r1__part_9*r1__part_29
    let r1__part_30_0 = r1__part_9_0 * r1__part_29_0;
    // r1__part_31 = r1__part_8*r1__part_29
    let r1__part_31_0 = r1__part_8_0 * r1__part_29_0;
    // r1__part_32 = 5 + 2*cos_theta2_from_theta1
    let r1__part_32_0 = cos_theta2_from_theta1_0.mul_add(S::int(2), S::int(5));
    // r1__part_33 = u3_part_12*r1__part_32
    let r1__part_33_0 = u3_part_12_0 * r1__part_32_0;
    // r1__part_34 = u4_from_u3_p2 + u5_from_u3_p2
    let r1__part_34_0 = u4_from_u3_p2_0 + u5_from_u3_p2_0;
    // r1__part_35 = 3*sin_angle - r1__part_31
    let r1__part_35_0 = S::int(3) * sin_angle_0 - r1__part_31_0;
    // r1__part_36 = 3*cos_angle - r1__part_30
    let r1__part_36_0 = S::int(3) * cos_angle_0 - r1__part_30_0;
    // r1__part_37 = u3_part_2 + u3_part_3
    let r1__part_37_0 = u3_part_3_0 + u3_part_2_0;
    // r1__part_38 = cos_theta2_from_theta1*r1__part_37
    let r1__part_38_0 = cos_theta2_from_theta1_0 * r1__part_37_0;
    // r1__part_39 = 14 + 9*cos_theta3_from_theta1 - 18*r1__part_38
    let r1__part_39_0 = r1__part_38_0
        .mul_add(-S::int(18), cos_theta3_from_theta1_0.mul_add(S::int(9), S::int(14)));
    // r1__part_40 = cos_theta3_from_theta1*r1__part_39
    let r1__part_40_0 = cos_theta3_from_theta1_0 * r1__part_39_0;
    // r1__part_41 = cos_theta2_from_theta1*u3_part_3
    let r1__part_41_0 = cos_theta2_from_theta1_0 * u3_part_3_0;
    // r1__part_42 = 33 + r1__part_40 - 18*r1__part_41
    let r1__part_42_0 = r1__part_41_0.mul_add(-S::int(18), S::int(33)) + r1__part_40_0;
    let over_r1__part_42 = S::int(1) / r1__part_42_0;
    // r1__part_43 = 1 + 2*cos_theta3_from_theta1
    let r1__part_43_0 = cos_theta3_from_theta1_0.mul_add(S::int(2), S::int(1));
    // r1__part_44 = cos_theta2_from_theta1*r1__part_43
    let r1__part_44_0 = cos_theta2_from_theta1_0 * r1__part_43_0;
    // r1__part_45 = 2 + cos_theta3_from_theta1 + 6*u3_part_3 + 3*r1__part_44
    let r1__part_45_0 = r1__part_44_0
        .mul_add(
            S::int(3),
            u3_part_3_0.mul_add(S::int(6), S::int(2) + cos_theta3_from_theta1_0),
        );
    // r1__part_46 = cos_theta3_from_theta1*r1__part_45
    let r1__part_46_0 = cos_theta3_from_theta1_0 * r1__part_45_0;
    // r1__part_47 = 3 + 3*cos_theta2_from_theta1 - 3*u3_part_3 - r1__part_46
    let r1__part_47_0 = u3_part_3_0
        .mul_add(-S::int(3), cos_theta2_from_theta1_0.mul_add(S::int(3), S::int(3)))
        - r1__part_46_0;
    // r1__part_48 = cos_theta2_from_theta1*r1__part_47
    let r1__part_48_0 = cos_theta2_from_theta1_0 * r1__part_47_0;
    // r1__part_49 = 7 + 9*cos_theta3_from_theta1 - 3*u3_part_3
    let r1__part_49_0 = u3_part_3_0
        .mul_add(-S::int(3), cos_theta3_from_theta1_0.mul_add(S::int(9), S::int(7)));
    // r1__part_50 = cos_theta3_from_theta1*r1__part_49
    let r1__part_50_0 = cos_theta3_from_theta1_0 * r1__part_49_0;
    // r1__part_51 = -12 + 9*u3_part_3 - 3*r1__part_48 - r1__part_50
    let r1__part_51_0 = r1__part_48_0
        .mul_add(
            -S::int(3),
            u3_part_3_0.mul_add(S::int(9), -S::int(12)) - r1__part_50_0,
        );
    // r1__part_52 = 2/49*r1__part_2 + 3*r1__part_11 + r1__part_13
    let r1__part_52_0 = r1__part_11_0.mul_add(S::int(3), S::ratio(2, 49) * r1__part_2_0)
        + r1__part_13_0;
    // r1__part_53 = r1__part_35*r1__part_52
    let r1__part_53_0 = r1__part_35_0 * r1__part_52_0;
    // r1__part_54 = 2/49*r1__part_3 + 3*r1__part_18 + r1__part_19
    let r1__part_54_0 = r1__part_18_0.mul_add(S::int(3), S::ratio(2, 49) * r1__part_3_0)
        + r1__part_19_0;
    // r1__part_55 = r1__part_36*r1__part_54
    let r1__part_55_0 = r1__part_36_0 * r1__part_54_0;
    // r1__part_56 = r1__part_27*r1__part_29
    let r1__part_56_0 = r1__part_27_0 * r1__part_29_0;
    // r1__part_57 = cos_theta2_from_theta1*r1__part_28
    let r1__part_57_0 = cos_theta2_from_theta1_0 * r1__part_28_0;
    // r1__part_58 = -2/7*u3_part_12 + u4_from_u3 + 2*u5_from_u3 + 6*r1__part_57
    let r1__part_58_0 = r1__part_57_0
        .mul_add(
            S::int(6),
            u3_part_12_0
                .mul_add(-S::ratio(2, 7), u5_from_u3_0.mul_add(S::int(2), u4_from_u3_0)),
        );
    // r1__part_59 = cos_theta3_from_theta1*r1__part_58
    let r1__part_59_0 = cos_theta3_from_theta1_0 * r1__part_58_0;
    // r1__part_60 = 13 + 6*cos_theta2_from_theta1
    let r1__part_60_0 = cos_theta2_from_theta1_0.mul_add(S::int(6), S::int(13));
    // r1__part_61 = u3_part_12*r1__part_60
    let r1__part_61_0 = u3_part_12_0 * r1__part_60_0;
    // r1__part_62 = 3 + cos_theta2_from_theta1
    let r1__part_62_0 = S::int(3) + cos_theta2_from_theta1_0;
    // r1__part_63 = u4_from_u3*r1__part_62
    let r1__part_63_0 = u4_from_u3_0 * r1__part_62_0;
    // r1__part_64 = 6*u5_from_u3 + 2*r1__part_59 - 1/7*r1__part_61 + 6*r1__part_63
    let r1__part_64_0 = r1__part_59_0
        .mul_add(
            S::int(2),
            r1__part_61_0
                .mul_add(
                    -S::ratio(1, 7),
                    r1__part_63_0.mul_add(S::int(6), S::int(6) * u5_from_u3_0),
                ),
        );
    // r1__part_65 = sin_theta2_from_theta1*r1__part_64
    let r1__part_65_0 = sin_theta2_from_theta1_0 * r1__part_64_0;
    // r1__part_66 = cos_theta2_from_theta1*r1__part_58
    let r1__part_66_0 = cos_theta2_from_theta1_0 * r1__part_58_0;
    // r1__part_67 = -8/7*u3_part_12 + 9*u4_from_u3 + 8*u5_from_u3 - 3*r1__part_66
    let r1__part_67_0 = r1__part_66_0
        .mul_add(
            -S::int(3),
            u3_part_12_0
                .mul_add(
                    -S::ratio(8, 7),
                    u5_from_u3_0.mul_add(S::int(8), S::int(9) * u4_from_u3_0),
                ),
        );
    // r1__part_68 = sin_theta3_from_theta1*r1__part_67
    let r1__part_68_0 = sin_theta3_from_theta1_0 * r1__part_67_0;
    // r1__part_69 = 3*r1__part_65 + 2*r1__part_68
    let r1__part_69_0 = r1__part_68_0.mul_add(S::int(2), S::int(3) * r1__part_65_0);
    // r1__part_70 = cos_theta3_from_theta1*r1__part_69
    let r1__part_70_0 = cos_theta3_from_theta1_0 * r1__part_69_0;
    // r1__part_71 = 10 + 3*cos_theta2_from_theta1
    let r1__part_71_0 = cos_theta2_from_theta1_0.mul_add(S::int(3), S::int(10));
    // r1__part_72 = u4_from_u3*r1__part_71
    let r1__part_72_0 = u4_from_u3_0 * r1__part_71_0;
    // r1__part_73 = 6*u5_from_u3 - 3/7*r1__part_33 + 2*r1__part_72
    let r1__part_73_0 = r1__part_33_0
        .mul_add(
            -S::ratio(3, 7),
            r1__part_72_0.mul_add(S::int(2), S::int(6) * u5_from_u3_0),
        );
    // r1__part_74 = cos_theta2_from_theta1*r1__part_73
    let r1__part_74_0 = cos_theta2_from_theta1_0 * r1__part_73_0;
    // r1__part_75 = -13/7*u3_part_12 + 18*u4_from_u3 + 6*u5_from_u3 + 3*r1__part_74
    let r1__part_75_0 = r1__part_74_0
        .mul_add(
            S::int(3),
            u3_part_12_0
                .mul_add(
                    -S::ratio(13, 7),
                    u5_from_u3_0.mul_add(S::int(6), S::int(18) * u4_from_u3_0),
                ),
        );
    // r1__part_76 = sin_theta3_from_theta1*r1__part_75
    let r1__part_76_0 = sin_theta3_from_theta1_0 * r1__part_75_0;
    // r1__part_77 = -1/7*u3_part_12 + 3*u4_from_u3 + u5_from_u3 + 3*r1__part_57
    let r1__part_77_0 = r1__part_57_0
        .mul_add(
            S::int(3),
            u3_part_12_0
                .mul_add(-S::ratio(1, 7), S::int(3) * u4_from_u3_0 + u5_from_u3_0),
        );
    // r1__part_78 = sin_theta2_from_theta1*r1__part_77
    let r1__part_78_0 = sin_theta2_from_theta1_0 * r1__part_77_0;
    // r1__part_79 = r1__part_70 - r1__part_76 - 6*r1__part_78
    let r1__part_79_0 = -S::int(6) * r1__part_78_0 - r1__part_76_0 + r1__part_70_0;
    // r1__part_80 = u3_part_12*r1__part_79
    let r1__part_80_0 = u3_part_12_0 * r1__part_79_0;
    // r1__part_81 = cos_theta2_from_theta1*r1__part_34
    let r1__part_81_0 = cos_theta2_from_theta1_0 * r1__part_34_0;
    // r1__part_82 = u4_from_u3_p2 + 2*u5_from_u3_p2 + 6*r1__part_81
    let r1__part_82_0 = r1__part_81_0
        .mul_add(S::int(6), u5_from_u3_p2_0.mul_add(S::int(2), u4_from_u3_p2_0));
    // r1__part_83 = cos_theta3_from_theta1*r1__part_82
    let r1__part_83_0 = cos_theta3_from_theta1_0 * r1__part_82_0;
    // r1__part_84 = r1__part_62*u4_from_u3_p2
    let r1__part_84_0 = r1__part_62_0 * u4_from_u3_p2_0;
    // r1__part_85 = 3*u5_from_u3_p2 + r1__part_83 + 3*r1__part_84
    let r1__part_85_0 = r1__part_84_0.mul_add(S::int(3), S::int(3) * u5_from_u3_p2_0)
        + r1__part_83_0;
    // r1__part_86 = sin_theta2_from_theta1*r1__part_85
    let r1__part_86_0 = sin_theta2_from_theta1_0 * r1__part_85_0;
    // r1__part_87 = cos_theta2_from_theta1*r1__part_82
    let r1__part_87_0 = cos_theta2_from_theta1_0 * r1__part_82_0;
    // r1__part_88 = 9*u4_from_u3_p2 + 8*u5_from_u3_p2 - 3*r1__part_87
    let r1__part_88_0 = r1__part_87_0
        .mul_add(
            -S::int(3),
            u5_from_u3_p2_0.mul_add(S::int(8), S::int(9) * u4_from_u3_p2_0),
        );
    // r1__part_89 = sin_theta3_from_theta1*r1__part_88
    let r1__part_89_0 = sin_theta3_from_theta1_0 * r1__part_88_0;
    // r1__part_90 = 3*r1__part_86 + r1__part_89
    let r1__part_90_0 = S::int(3) * r1__part_86_0 + r1__part_89_0;
    // r1__part_91 = cos_theta3_from_theta1*r1__part_90
    let r1__part_91_0 = cos_theta3_from_theta1_0 * r1__part_90_0;
    // r1__part_92 = r1__part_71*u4_from_u3_p2
    let r1__part_92_0 = r1__part_71_0 * u4_from_u3_p2_0;
    // r1__part_93 = 3*u5_from_u3_p2 + r1__part_92
    let r1__part_93_0 = S::int(3) * u5_from_u3_p2_0 + r1__part_92_0;
    // r1__part_94 = cos_theta2_from_theta1*r1__part_93
    let r1__part_94_0 = cos_theta2_from_theta1_0 * r1__part_93_0;
    // r1__part_95 = 3*u4_from_u3_p2 + u5_from_u3_p2 + r1__part_94
    let r1__part_95_0 = S::int(3) * u4_from_u3_p2_0 + u5_from_u3_p2_0 + r1__part_94_0;
    // r1__part_96 = sin_theta3_from_theta1*r1__part_95
    let r1__part_96_0 = sin_theta3_from_theta1_0 * r1__part_95_0;
    // r1__part_97 = 3*u4_from_u3_p2 + u5_from_u3_p2 + 3*r1__part_81
    let r1__part_97_0 = r1__part_81_0
        .mul_add(S::int(3), S::int(3) * u4_from_u3_p2_0 + u5_from_u3_p2_0);
    // r1__part_98 = sin_theta2_from_theta1*r1__part_97
    let r1__part_98_0 = sin_theta2_from_theta1_0 * r1__part_97_0;
    // r1__part_99 = -1/7*r1__part_80 + r1__part_91 - 3*r1__part_96 - 3*r1__part_98
    let r1__part_99_0 = r1__part_80_0
        .mul_add(
            -S::ratio(1, 7),
            r1__part_96_0.mul_add(-S::int(3), -S::int(3) * r1__part_98_0) + r1__part_91_0,
        );
    // r1__part_100 = r1__part_99/u3_part_8
    let r1__part_100_0 = r1__part_99_0 * over_u3_part_8;
    // r1__part_101 = 9/49*r1__part_7 + 6*r1__part_20 - r1__part_53 + r1__part_55 + 3*r1__part_56
    let r1__part_101_0 = r1__part_56_0
        .mul_add(
            S::int(3),
            r1__part_20_0.mul_add(S::int(6), S::ratio(9, 49) * r1__part_7_0),
        ) + r1__part_55_0 - r1__part_53_0;
    // r1__part_102 = r1__part_51/r1__part_42
    let r1__part_102_0 = r1__part_51_0 * over_r1__part_42;
    // r1__part_103 = r1__part_101*r1__part_102
    let r1__part_103_0 = r1__part_101_0 * r1__part_102_0;
    // r1__part_104 = 7/750*r1__part_100 + 7/750*r1__part_103
    let r1__part_104_0 = r1__part_100_0
        .mul_add(S::ratio(7, 750), S::ratio(7, 750) * r1__part_103_0);
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
    // u5_from_u3_dot_part_7 = r1__part_42/u5_from_u3_dot_part_6
    let u5_from_u3_dot_part_7_0 = r1__part_42_0 * over_u5_from_u3_dot_part_6;
    // u5_from_u3_dot_part_8 = r1__part_104*u5_from_u3_dot_part_7
    let u5_from_u3_dot_part_8_0 = r1__part_104_0 * u5_from_u3_dot_part_7_0;
    // u4_from_u3_dot_part = r1__part_51/u3_part_8
    let u4_from_u3_dot_part_0 = r1__part_51_0 * over_u3_part_8;
    // u4_from_u3_dot_part_2 = u5_from_u3_dot_part_8*u4_from_u3_dot_part
    let u4_from_u3_dot_part_2_0 = u5_from_u3_dot_part_8_0 * u4_from_u3_dot_part_0;
    // u4_from_u3_dot_part_3 = 9/49*r1__part_7 + 6*r1__part_20 - r1__part_53 + r1__part_55 + 3*r1__part_56
    //   + 375/14*u4_from_u3_dot_part_2
    let u4_from_u3_dot_part_3_0 = u4_from_u3_dot_part_2_0
        .mul_add(
            S::ratio(375, 14),
            r1__part_56_0
                .mul_add(
                    S::int(3),
                    r1__part_20_0.mul_add(S::int(6), S::ratio(9, 49) * r1__part_7_0),
                ) + r1__part_55_0 - r1__part_53_0,
        );
    // u4_from_u3_dot_part_4 = u3_part_8/r1__part_42
    let u4_from_u3_dot_part_4_0 = u3_part_8_0 * over_r1__part_42;
    // u4_from_u3_dot_part_5 = u4_from_u3_dot_part_3*u4_from_u3_dot_part_4
    let u4_from_u3_dot_part_5_0 = u4_from_u3_dot_part_3_0 * u4_from_u3_dot_part_4_0;
    // Order 1: the rates, and what follows from them.
    let theta2_from_theta1_1 = u4_from_u3_0;
    let theta3_from_theta1_1 = u5_from_u3_0;
    let theta1_1 = -S::ratio(1, 7) * u3_part_12_0;
    let u4_from_u3_1 = -u4_from_u3_dot_part_5_0;
    let u5_from_u3_1 = S::ratio(375, 14) * u5_from_u3_dot_part_8_0;
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
    let u3_part_11_1 = u3_part_10_1.mul_add(S::int(7), S::int(7) * u3_part_9_1);
    let u3_part_12_1 = u3_part_8_1
        .mul_add(-(u3_part_12_0 * over_u3_part_8), u3_part_11_1 * over_u3_part_8);
    let sin_theta1_1 = theta1_1 * cos_theta1_0;
    let cos_theta1_1 = -theta1_1 * sin_theta1_0;
    let r1__part_1 = u3_part_12_1 * (u3_part_12_0 + u3_part_12_0);
    let r1__part_2_1 = r1__part_1.mul_add(cos_theta1_0, cos_theta1_1 * r1__part_0);
    let r1__part_3_1 = r1__part_1.mul_add(sin_theta1_0, sin_theta1_1 * r1__part_0);
    let r1__part_4_1 = theta1_1 + theta2_from_theta1_1;
    let r1__part_5_1 = theta1_1 + theta3_from_theta1_1;
    let sin_angle_1 = r1__part_4_1 * cos_angle_0;
    let cos_angle_1 = -r1__part_4_1 * sin_angle_0;
    let sin_angle_2_1 = r1__part_5_1 * cos_angle_2_0;
    let cos_angle_2_1 = -r1__part_5_1 * sin_angle_2_0;
    let r1__part_6_1 = theta2_from_theta1_1 - theta3_from_theta1_1;
    let sin_angle_3_1 = r1__part_6_1 * cos_angle_3_0;
    let cos_angle_3_1 = -r1__part_6_1 * sin_angle_3_0;
    let r1__part_7_1 = r1__part_1
        .mul_add(sin_theta2_from_theta1_0, sin_theta2_from_theta1_1 * r1__part_0);
    let r1__part_8_1 = sin_angle_1.mul_add(S::int(3), S::int(2) * sin_theta1_1)
        + sin_angle_2_1;
    let r1__part_9_1 = cos_angle_1.mul_add(S::int(3), S::int(2) * cos_theta1_1)
        + cos_angle_2_1;
    let u3_plus_u4_from_u3_1 = u3_part_12_1.mul_add(-S::ratio(1, 7), u4_from_u3_1);
    let u3_plus_u5_from_u3_1 = u3_part_12_1.mul_add(-S::ratio(1, 7), u5_from_u3_1);
    let r1__part_10_1 = u3_plus_u4_from_u3_1
        * (u3_plus_u4_from_u3_0 + u3_plus_u4_from_u3_0);
    let r1__part_11_1 = r1__part_10_1.mul_add(cos_angle_0, cos_angle_1 * r1__part_10_0);
    let r1__part_12_1 = u3_plus_u5_from_u3_1
        * (u3_plus_u5_from_u3_0 + u3_plus_u5_from_u3_0);
    let r1__part_13_1 = r1__part_12_1
        .mul_add(cos_angle_2_0, cos_angle_2_1 * r1__part_12_0);
    let r1__part_14_1 = sin_theta2_from_theta1_1
        .mul_add(u4_from_u3_0, u4_from_u3_1 * sin_theta2_from_theta1_0);
    let r1__part_15_1 = sin_theta3_from_theta1_1
        .mul_add(u5_from_u3_0, u5_from_u3_1 * sin_theta3_from_theta1_0);
    let u4_from_u3_p2_1 = u4_from_u3_1 * (u4_from_u3_0 + u4_from_u3_0);
    let r1__part_16_1 = u4_from_u3_p2_1
        .mul_add(sin_theta2_from_theta1_0, sin_theta2_from_theta1_1 * u4_from_u3_p2_0);
    let r1__part_17_1 = r1__part_15_1
        .mul_add(u5_from_u3_0, u5_from_u3_1 * r1__part_15_0);
    let r1__part_18_1 = r1__part_10_1.mul_add(sin_angle_0, sin_angle_1 * r1__part_10_0);
    let r1__part_19_1 = r1__part_12_1
        .mul_add(sin_angle_2_0, sin_angle_2_1 * r1__part_12_0);
    let r1__part_20_1 = r1__part_12_1
        .mul_add(sin_angle_3_0, sin_angle_3_1 * r1__part_12_0);
    let r1__part_21_1 = u4_from_u3_1 - u5_from_u3_1;
    let u5_from_u3_p2_1 = u5_from_u3_1 * (u5_from_u3_0 + u5_from_u3_0);
    let r1__part_22_1 = u4_from_u3_p2_1 - u5_from_u3_p2_1;
    let r1__part_23_1 = sin_angle_3_1
        .mul_add(r1__part_21_0, r1__part_21_1 * sin_angle_3_0);
    let r1__part_24_1 = r1__part_23_1
        .mul_add(S::int(2), S::int(3) * r1__part_14_1 + r1__part_15_1);
    let r1__part_25_1 = u3_part_12_1
        .mul_add(r1__part_24_0, r1__part_24_1 * u3_part_12_0);
    let r1__part_26_1 = r1__part_22_1
        .mul_add(sin_angle_3_0, sin_angle_3_1 * r1__part_22_0);
    let r1__part_27_1 = r1__part_25_1
        .mul_add(
            -S::ratio(2, 7),
            r1__part_26_1.mul_add(S::int(2), S::int(3) * r1__part_16_1) + r1__part_17_1,
        );
    let r1__part_28_1 = u3_part_12_1
        .mul_add(-S::ratio(1, 7), u4_from_u3_1 + u5_from_u3_1);
    let r1__part_29_1 = u3_part_8_1
        .mul_add(-(r1__part_29_0 * over_u3_part_8), u3_part_4_1 * over_u3_part_8);
    let r1__part_30_1 = r1__part_29_1
        .mul_add(r1__part_9_0, r1__part_9_1 * r1__part_29_0);
    let r1__part_31_1 = r1__part_29_1
        .mul_add(r1__part_8_0, r1__part_8_1 * r1__part_29_0);
    let r1__part_32_1 = S::int(2) * cos_theta2_from_theta1_1;
    let r1__part_33_1 = u3_part_12_1
        .mul_add(r1__part_32_0, r1__part_32_1 * u3_part_12_0);
    let r1__part_34_1 = u4_from_u3_p2_1 + u5_from_u3_p2_1;
    let r1__part_35_1 = S::int(3) * sin_angle_1 - r1__part_31_1;
    let r1__part_36_1 = S::int(3) * cos_angle_1 - r1__part_30_1;
    let r1__part_37_1 = u3_part_3_1 + u3_part_2_1;
    let r1__part_38_1 = r1__part_37_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_37_0);
    let r1__part_39_1 = r1__part_38_1
        .mul_add(-S::int(18), S::int(9) * cos_theta3_from_theta1_1);
    let r1__part_40_1 = r1__part_39_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_39_0);
    let r1__part_41_1 = u3_part_3_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * u3_part_3_0);
    let r1__part_42_1 = -S::int(18) * r1__part_41_1 + r1__part_40_1;
    let r1__part_43_1 = S::int(2) * cos_theta3_from_theta1_1;
    let r1__part_44_1 = r1__part_43_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_43_0);
    let r1__part_45_1 = r1__part_44_1
        .mul_add(S::int(3), u3_part_3_1.mul_add(S::int(6), cos_theta3_from_theta1_1));
    let r1__part_46_1 = r1__part_45_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_45_0);
    let r1__part_47_1 = u3_part_3_1
        .mul_add(-S::int(3), S::int(3) * cos_theta2_from_theta1_1) - r1__part_46_1;
    let r1__part_48_1 = r1__part_47_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_47_0);
    let r1__part_49_1 = u3_part_3_1
        .mul_add(-S::int(3), S::int(9) * cos_theta3_from_theta1_1);
    let r1__part_50_1 = r1__part_49_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_49_0);
    let r1__part_51_1 = r1__part_48_1
        .mul_add(-S::int(3), S::int(9) * u3_part_3_1 - r1__part_50_1);
    let r1__part_52_1 = r1__part_11_1.mul_add(S::int(3), S::ratio(2, 49) * r1__part_2_1)
        + r1__part_13_1;
    let r1__part_53_1 = r1__part_52_1
        .mul_add(r1__part_35_0, r1__part_35_1 * r1__part_52_0);
    let r1__part_54_1 = r1__part_18_1.mul_add(S::int(3), S::ratio(2, 49) * r1__part_3_1)
        + r1__part_19_1;
    let r1__part_55_1 = r1__part_54_1
        .mul_add(r1__part_36_0, r1__part_36_1 * r1__part_54_0);
    let r1__part_56_1 = r1__part_27_1
        .mul_add(r1__part_29_0, r1__part_29_1 * r1__part_27_0);
    let r1__part_57_1 = r1__part_28_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_28_0);
    let r1__part_58_1 = r1__part_57_1
        .mul_add(
            S::int(6),
            u3_part_12_1
                .mul_add(-S::ratio(2, 7), u5_from_u3_1.mul_add(S::int(2), u4_from_u3_1)),
        );
    let r1__part_59_1 = r1__part_58_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_58_0);
    let r1__part_60_1 = S::int(6) * cos_theta2_from_theta1_1;
    let r1__part_61_1 = u3_part_12_1
        .mul_add(r1__part_60_0, r1__part_60_1 * u3_part_12_0);
    let r1__part_62_1 = cos_theta2_from_theta1_1;
    let r1__part_63_1 = r1__part_62_1
        .mul_add(u4_from_u3_0, u4_from_u3_1 * r1__part_62_0);
    let r1__part_64_1 = r1__part_59_1
        .mul_add(
            S::int(2),
            r1__part_61_1
                .mul_add(
                    -S::ratio(1, 7),
                    r1__part_63_1.mul_add(S::int(6), S::int(6) * u5_from_u3_1),
                ),
        );
    let r1__part_65_1 = r1__part_64_1
        .mul_add(sin_theta2_from_theta1_0, sin_theta2_from_theta1_1 * r1__part_64_0);
    let r1__part_66_1 = r1__part_58_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_58_0);
    let r1__part_67_1 = r1__part_66_1
        .mul_add(
            -S::int(3),
            u3_part_12_1
                .mul_add(
                    -S::ratio(8, 7),
                    u5_from_u3_1.mul_add(S::int(8), S::int(9) * u4_from_u3_1),
                ),
        );
    let r1__part_68_1 = r1__part_67_1
        .mul_add(sin_theta3_from_theta1_0, sin_theta3_from_theta1_1 * r1__part_67_0);
    let r1__part_69_1 = r1__part_68_1.mul_add(S::int(2), S::int(3) * r1__part_65_1);
    let r1__part_70_1 = r1__part_69_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_69_0);
    let r1__part_71_1 = S::int(3) * cos_theta2_from_theta1_1;
    let r1__part_72_1 = r1__part_71_1
        .mul_add(u4_from_u3_0, u4_from_u3_1 * r1__part_71_0);
    let r1__part_73_1 = r1__part_33_1
        .mul_add(
            -S::ratio(3, 7),
            r1__part_72_1.mul_add(S::int(2), S::int(6) * u5_from_u3_1),
        );
    let r1__part_74_1 = r1__part_73_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_73_0);
    let r1__part_75_1 = r1__part_74_1
        .mul_add(
            S::int(3),
            u3_part_12_1
                .mul_add(
                    -S::ratio(13, 7),
                    u5_from_u3_1.mul_add(S::int(6), S::int(18) * u4_from_u3_1),
                ),
        );
    let r1__part_76_1 = r1__part_75_1
        .mul_add(sin_theta3_from_theta1_0, sin_theta3_from_theta1_1 * r1__part_75_0);
    let r1__part_77_1 = r1__part_57_1
        .mul_add(
            S::int(3),
            u3_part_12_1
                .mul_add(-S::ratio(1, 7), S::int(3) * u4_from_u3_1 + u5_from_u3_1),
        );
    let r1__part_78_1 = r1__part_77_1
        .mul_add(sin_theta2_from_theta1_0, sin_theta2_from_theta1_1 * r1__part_77_0);
    let r1__part_79_1 = -S::int(6) * r1__part_78_1 - r1__part_76_1 + r1__part_70_1;
    let r1__part_80_1 = r1__part_79_1
        .mul_add(u3_part_12_0, u3_part_12_1 * r1__part_79_0);
    let r1__part_81_1 = r1__part_34_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_34_0);
    let r1__part_82_1 = r1__part_81_1
        .mul_add(S::int(6), u5_from_u3_p2_1.mul_add(S::int(2), u4_from_u3_p2_1));
    let r1__part_83_1 = r1__part_82_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_82_0);
    let r1__part_84_1 = r1__part_62_1
        .mul_add(u4_from_u3_p2_0, u4_from_u3_p2_1 * r1__part_62_0);
    let r1__part_85_1 = r1__part_84_1.mul_add(S::int(3), S::int(3) * u5_from_u3_p2_1)
        + r1__part_83_1;
    let r1__part_86_1 = r1__part_85_1
        .mul_add(sin_theta2_from_theta1_0, sin_theta2_from_theta1_1 * r1__part_85_0);
    let r1__part_87_1 = r1__part_82_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_82_0);
    let r1__part_88_1 = r1__part_87_1
        .mul_add(
            -S::int(3),
            u5_from_u3_p2_1.mul_add(S::int(8), S::int(9) * u4_from_u3_p2_1),
        );
    let r1__part_89_1 = r1__part_88_1
        .mul_add(sin_theta3_from_theta1_0, sin_theta3_from_theta1_1 * r1__part_88_0);
    let r1__part_90_1 = S::int(3) * r1__part_86_1 + r1__part_89_1;
    let r1__part_91_1 = r1__part_90_1
        .mul_add(cos_theta3_from_theta1_0, cos_theta3_from_theta1_1 * r1__part_90_0);
    let r1__part_92_1 = r1__part_71_1
        .mul_add(u4_from_u3_p2_0, u4_from_u3_p2_1 * r1__part_71_0);
    let r1__part_93_1 = S::int(3) * u5_from_u3_p2_1 + r1__part_92_1;
    let r1__part_94_1 = r1__part_93_1
        .mul_add(cos_theta2_from_theta1_0, cos_theta2_from_theta1_1 * r1__part_93_0);
    let r1__part_95_1 = S::int(3) * u4_from_u3_p2_1 + u5_from_u3_p2_1 + r1__part_94_1;
    let r1__part_96_1 = r1__part_95_1
        .mul_add(sin_theta3_from_theta1_0, sin_theta3_from_theta1_1 * r1__part_95_0);
    let r1__part_97_1 = r1__part_81_1
        .mul_add(S::int(3), S::int(3) * u4_from_u3_p2_1 + u5_from_u3_p2_1);
    let r1__part_98_1 = r1__part_97_1
        .mul_add(sin_theta2_from_theta1_0, sin_theta2_from_theta1_1 * r1__part_97_0);
    let r1__part_99_1 = r1__part_80_1
        .mul_add(
            -S::ratio(1, 7),
            r1__part_96_1.mul_add(-S::int(3), -S::int(3) * r1__part_98_1) + r1__part_91_1,
        );
    let r1__part_100_1 = u3_part_8_1
        .mul_add(-(r1__part_100_0 * over_u3_part_8), r1__part_99_1 * over_u3_part_8);
    let r1__part_101_1 = r1__part_56_1
        .mul_add(
            S::int(3),
            r1__part_20_1.mul_add(S::int(6), S::ratio(9, 49) * r1__part_7_1),
        ) + r1__part_55_1 - r1__part_53_1;
    let r1__part_102_1 = r1__part_42_1
        .mul_add(-(r1__part_102_0 * over_r1__part_42), r1__part_51_1 * over_r1__part_42);
    let r1__part_103_1 = r1__part_101_1
        .mul_add(r1__part_102_0, r1__part_102_1 * r1__part_101_0);
    let r1__part_104_1 = r1__part_100_1
        .mul_add(S::ratio(7, 750), S::ratio(7, 750) * r1__part_103_1);
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
            r1__part_42_1 * over_u5_from_u3_dot_part_6,
        );
    let u5_from_u3_dot_part_8_1 = r1__part_104_1
        .mul_add(u5_from_u3_dot_part_7_0, u5_from_u3_dot_part_7_1 * r1__part_104_0);
    let u4_from_u3_dot_part_1 = u3_part_8_1
        .mul_add(
            -(u4_from_u3_dot_part_0 * over_u3_part_8),
            r1__part_51_1 * over_u3_part_8,
        );
    let u4_from_u3_dot_part_2_1 = u5_from_u3_dot_part_8_1
        .mul_add(u4_from_u3_dot_part_0, u4_from_u3_dot_part_1 * u5_from_u3_dot_part_8_0);
    let u4_from_u3_dot_part_3_1 = u4_from_u3_dot_part_2_1
        .mul_add(
            S::ratio(375, 14),
            r1__part_56_1
                .mul_add(
                    S::int(3),
                    r1__part_20_1.mul_add(S::int(6), S::ratio(9, 49) * r1__part_7_1),
                ) + r1__part_55_1 - r1__part_53_1,
        );
    let u4_from_u3_dot_part_4_1 = r1__part_42_1
        .mul_add(
            -(u4_from_u3_dot_part_4_0 * over_r1__part_42),
            u3_part_8_1 * over_r1__part_42,
        );
    let u4_from_u3_dot_part_5_1 = u4_from_u3_dot_part_3_1
        .mul_add(
            u4_from_u3_dot_part_4_0,
            u4_from_u3_dot_part_4_1 * u4_from_u3_dot_part_3_0,
        );
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            [
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
                theta1_1,
                theta1_1,
                u3_part_12_1,
                cos_theta1_1,
                sin_theta1_1,
                r1__part_4_1,
                r1__part_4_1,
                r1__part_5_1,
                r1__part_5_1,
                r1__part_6_1,
                r1__part_6_1,
                sin_theta2_from_theta1_1,
                u3_plus_u4_from_u3_1,
                cos_angle_1,
                u3_plus_u5_from_u3_1,
                cos_angle_2_1,
                sin_theta2_from_theta1_1,
                sin_theta3_from_theta1_1,
                u4_from_u3_1,
                sin_theta2_from_theta1_1,
                u5_from_u3_1,
                sin_angle_1,
                sin_angle_2_1,
                sin_angle_3_1,
                u5_from_u3_1,
                sin_angle_3_1,
                u3_part_12_1,
                sin_angle_3_1,
                u3_part_8_1,
                r1__part_9_1,
                r1__part_8_1,
                u3_part_12_1,
                cos_theta2_from_theta1_1,
                cos_theta3_from_theta1_1,
                cos_theta2_from_theta1_1,
                cos_theta2_from_theta1_1,
                cos_theta3_from_theta1_1,
                cos_theta2_from_theta1_1,
                cos_theta3_from_theta1_1,
                r1__part_35_1,
                r1__part_36_1,
                r1__part_27_1,
                cos_theta2_from_theta1_1,
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
                r1__part_62_1,
                sin_theta2_from_theta1_1,
                cos_theta2_from_theta1_1,
                sin_theta3_from_theta1_1,
                cos_theta3_from_theta1_1,
                r1__part_71_1,
                cos_theta2_from_theta1_1,
                sin_theta3_from_theta1_1,
                sin_theta2_from_theta1_1,
                u3_part_8_1,
                r1__part_42_1,
                r1__part_101_1,
                cos_theta2_from_theta1_1,
                cos_theta2_from_theta1_1,
                cos_theta3_from_theta1_1,
                u5_from_u3_dot_part_6_1,
                r1__part_104_1,
                u3_part_8_1,
                u5_from_u3_dot_part_8_1,
                r1__part_42_1,
                u4_from_u3_dot_part_3_1,
            ],
            [
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
                cos_theta1_1,
                sin_theta1_1,
                u3_part_12_1,
                r1__part_1,
                r1__part_1,
                cos_angle_1,
                sin_angle_1,
                cos_angle_2_1,
                sin_angle_2_1,
                cos_angle_3_1,
                sin_angle_3_1,
                r1__part_1,
                u3_plus_u4_from_u3_1,
                r1__part_10_1,
                u3_plus_u5_from_u3_1,
                r1__part_12_1,
                u4_from_u3_1,
                u5_from_u3_1,
                u4_from_u3_1,
                u4_from_u3_p2_1,
                r1__part_15_1,
                r1__part_10_1,
                r1__part_12_1,
                r1__part_12_1,
                u5_from_u3_1,
                r1__part_21_1,
                r1__part_24_1,
                r1__part_22_1,
                r1__part_29_1,
                r1__part_29_1,
                r1__part_29_1,
                r1__part_32_1,
                r1__part_37_1,
                r1__part_39_1,
                u3_part_3_1,
                r1__part_43_1,
                r1__part_45_1,
                r1__part_47_1,
                r1__part_49_1,
                r1__part_52_1,
                r1__part_54_1,
                r1__part_29_1,
                r1__part_28_1,
                r1__part_58_1,
                r1__part_60_1,
                r1__part_62_1,
                r1__part_64_1,
                r1__part_58_1,
                r1__part_67_1,
                r1__part_69_1,
                r1__part_71_1,
                r1__part_73_1,
                r1__part_75_1,
                r1__part_77_1,
                r1__part_79_1,
                r1__part_34_1,
                r1__part_82_1,
                u4_from_u3_p2_1,
                r1__part_85_1,
                r1__part_82_1,
                r1__part_88_1,
                r1__part_90_1,
                u4_from_u3_p2_1,
                r1__part_93_1,
                r1__part_95_1,
                r1__part_97_1,
                r1__part_100_1,
                r1__part_102_1,
                r1__part_102_1,
                cos_theta3_from_theta1_1,
                u5_from_u3_dot_part_2_1,
                u5_from_u3_dot_part_4_1,
                u5_from_u3_dot_part_7_1,
                u5_from_u3_dot_part_7_1,
                u4_from_u3_dot_part_1,
                u4_from_u3_dot_part_1,
                u4_from_u3_dot_part_4_1,
                u4_from_u3_dot_part_4_1,
            ],
        ];
    }
    let mut count_last = S::int(1);
    let mut theta2_from_theta1_last = theta2_from_theta1_1;
    let mut theta3_from_theta1_last = theta3_from_theta1_1;
    let mut theta1_last = theta1_1;
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
    let mut sin_theta1_last = sin_theta1_1;
    let mut cos_theta1_last = cos_theta1_1;
    let mut r1__part_last = r1__part_1;
    let mut r1__part_4_last = r1__part_4_1;
    let mut r1__part_5_last = r1__part_5_1;
    let mut sin_angle_last = sin_angle_1;
    let mut cos_angle_last = cos_angle_1;
    let mut sin_angle_2_last = sin_angle_2_1;
    let mut cos_angle_2_last = cos_angle_2_1;
    let mut r1__part_6_last = r1__part_6_1;
    let mut sin_angle_3_last = sin_angle_3_1;
    let mut cos_angle_3_last = cos_angle_3_1;
    let mut r1__part_8_last = r1__part_8_1;
    let mut r1__part_9_last = r1__part_9_1;
    let mut u3_plus_u4_from_u3_last = u3_plus_u4_from_u3_1;
    let mut u3_plus_u5_from_u3_last = u3_plus_u5_from_u3_1;
    let mut r1__part_10_last = r1__part_10_1;
    let mut r1__part_12_last = r1__part_12_1;
    let mut r1__part_15_last = r1__part_15_1;
    let mut u4_from_u3_p2_last = u4_from_u3_p2_1;
    let mut r1__part_21_last = r1__part_21_1;
    let mut r1__part_22_last = r1__part_22_1;
    let mut r1__part_24_last = r1__part_24_1;
    let mut r1__part_27_last = r1__part_27_1;
    let mut r1__part_28_last = r1__part_28_1;
    let mut r1__part_29_last = r1__part_29_1;
    let mut r1__part_32_last = r1__part_32_1;
    let mut r1__part_34_last = r1__part_34_1;
    let mut r1__part_35_last = r1__part_35_1;
    let mut r1__part_36_last = r1__part_36_1;
    let mut r1__part_37_last = r1__part_37_1;
    let mut r1__part_39_last = r1__part_39_1;
    let mut r1__part_42_last = r1__part_42_1;
    let mut r1__part_43_last = r1__part_43_1;
    let mut r1__part_45_last = r1__part_45_1;
    let mut r1__part_47_last = r1__part_47_1;
    let mut r1__part_49_last = r1__part_49_1;
    let mut r1__part_52_last = r1__part_52_1;
    let mut r1__part_54_last = r1__part_54_1;
    let mut r1__part_58_last = r1__part_58_1;
    let mut r1__part_60_last = r1__part_60_1;
    let mut r1__part_62_last = r1__part_62_1;
    let mut r1__part_64_last = r1__part_64_1;
    let mut r1__part_67_last = r1__part_67_1;
    let mut r1__part_69_last = r1__part_69_1;
    let mut r1__part_71_last = r1__part_71_1;
    let mut r1__part_73_last = r1__part_73_1;
    let mut r1__part_75_last = r1__part_75_1;
    let mut r1__part_77_last = r1__part_77_1;
    let mut r1__part_79_last = r1__part_79_1;
    let mut r1__part_82_last = r1__part_82_1;
    let mut r1__part_85_last = r1__part_85_1;
    let mut r1__part_88_last = r1__part_88_1;
    let mut r1__part_90_last = r1__part_90_1;
    let mut r1__part_93_last = r1__part_93_1;
    let mut r1__part_95_last = r1__part_95_1;
    let mut r1__part_97_last = r1__part_97_1;
    let mut r1__part_100_last = r1__part_100_1;
    let mut r1__part_101_last = r1__part_101_1;
    let mut r1__part_102_last = r1__part_102_1;
    let mut r1__part_104_last = r1__part_104_1;
    let mut u5_from_u3_dot_part_2_last = u5_from_u3_dot_part_2_1;
    let mut u5_from_u3_dot_part_4_last = u5_from_u3_dot_part_4_1;
    let mut u5_from_u3_dot_part_6_last = u5_from_u3_dot_part_6_1;
    let mut u5_from_u3_dot_part_7_last = u5_from_u3_dot_part_7_1;
    let mut u5_from_u3_dot_part_8_last = u5_from_u3_dot_part_8_1;
    let mut u4_from_u3_dot_part_last = u4_from_u3_dot_part_1;
    let mut u4_from_u3_dot_part_3_last = u4_from_u3_dot_part_3_1;
    let mut u4_from_u3_dot_part_4_last = u4_from_u3_dot_part_4_1;
    let mut next = [S::int(0); 88];
    // Rates at order k - 1.
    let mut theta2_from_theta1_rate = u4_from_u3_1;
    let mut theta3_from_theta1_rate = u5_from_u3_1;
    let mut theta1_rate = -S::ratio(1, 7) * u3_part_12_1;
    let mut u4_from_u3_rate = -u4_from_u3_dot_part_5_1;
    let mut u5_from_u3_rate = S::ratio(375, 14) * u5_from_u3_dot_part_8_1;
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
            [
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
                theta1_1
                    .mul_add(
                        cos_theta1_last,
                        (count_last * theta1_last).mul_add(cos_theta1_1, next[10]),
                    ),
                theta1_1
                    .mul_add(
                        sin_theta1_last,
                        (count_last * theta1_last).mul_add(sin_theta1_1, next[11]),
                    ),
                (u3_part_12_1 + u3_part_12_1).mul_add(u3_part_12_last, next[12]),
                cos_theta1_1
                    .mul_add(
                        r1__part_last,
                        cos_theta1_last.mul_add(r1__part_1, next[13]),
                    ),
                sin_theta1_1
                    .mul_add(
                        r1__part_last,
                        sin_theta1_last.mul_add(r1__part_1, next[14]),
                    ),
                r1__part_4_1
                    .mul_add(
                        cos_angle_last,
                        (count_last * r1__part_4_last).mul_add(cos_angle_1, next[15]),
                    ),
                r1__part_4_1
                    .mul_add(
                        sin_angle_last,
                        (count_last * r1__part_4_last).mul_add(sin_angle_1, next[16]),
                    ),
                r1__part_5_1
                    .mul_add(
                        cos_angle_2_last,
                        (count_last * r1__part_5_last).mul_add(cos_angle_2_1, next[17]),
                    ),
                r1__part_5_1
                    .mul_add(
                        sin_angle_2_last,
                        (count_last * r1__part_5_last).mul_add(sin_angle_2_1, next[18]),
                    ),
                r1__part_6_1
                    .mul_add(
                        cos_angle_3_last,
                        (count_last * r1__part_6_last).mul_add(cos_angle_3_1, next[19]),
                    ),
                r1__part_6_1
                    .mul_add(
                        sin_angle_3_last,
                        (count_last * r1__part_6_last).mul_add(sin_angle_3_1, next[20]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__part_last,
                        sin_theta2_from_theta1_last.mul_add(r1__part_1, next[21]),
                    ),
                (u3_plus_u4_from_u3_1 + u3_plus_u4_from_u3_1)
                    .mul_add(u3_plus_u4_from_u3_last, next[22]),
                cos_angle_1
                    .mul_add(
                        r1__part_10_last,
                        cos_angle_last.mul_add(r1__part_10_1, next[23]),
                    ),
                (u3_plus_u5_from_u3_1 + u3_plus_u5_from_u3_1)
                    .mul_add(u3_plus_u5_from_u3_last, next[24]),
                cos_angle_2_1
                    .mul_add(
                        r1__part_12_last,
                        cos_angle_2_last.mul_add(r1__part_12_1, next[25]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_last,
                        sin_theta2_from_theta1_last.mul_add(u4_from_u3_1, next[26]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        u5_from_u3_last,
                        sin_theta3_from_theta1_last.mul_add(u5_from_u3_1, next[27]),
                    ),
                (u4_from_u3_1 + u4_from_u3_1).mul_add(u4_from_u3_last, next[28]),
                sin_theta2_from_theta1_1
                    .mul_add(
                        u4_from_u3_p2_last,
                        sin_theta2_from_theta1_last.mul_add(u4_from_u3_p2_1, next[29]),
                    ),
                u5_from_u3_1
                    .mul_add(
                        r1__part_15_last,
                        u5_from_u3_last.mul_add(r1__part_15_1, next[30]),
                    ),
                sin_angle_1
                    .mul_add(
                        r1__part_10_last,
                        sin_angle_last.mul_add(r1__part_10_1, next[31]),
                    ),
                sin_angle_2_1
                    .mul_add(
                        r1__part_12_last,
                        sin_angle_2_last.mul_add(r1__part_12_1, next[32]),
                    ),
                sin_angle_3_1
                    .mul_add(
                        r1__part_12_last,
                        sin_angle_3_last.mul_add(r1__part_12_1, next[33]),
                    ),
                (u5_from_u3_1 + u5_from_u3_1).mul_add(u5_from_u3_last, next[34]),
                sin_angle_3_1
                    .mul_add(
                        r1__part_21_last,
                        sin_angle_3_last.mul_add(r1__part_21_1, next[35]),
                    ),
                u3_part_12_1
                    .mul_add(
                        r1__part_24_last,
                        u3_part_12_last.mul_add(r1__part_24_1, next[36]),
                    ),
                sin_angle_3_1
                    .mul_add(
                        r1__part_22_last,
                        sin_angle_3_last.mul_add(r1__part_22_1, next[37]),
                    ),
                u3_part_8_1
                    .mul_add(
                        r1__part_29_last,
                        u3_part_8_last.mul_add(r1__part_29_1, next[38]),
                    ),
                r1__part_9_1
                    .mul_add(
                        r1__part_29_last,
                        r1__part_9_last.mul_add(r1__part_29_1, next[39]),
                    ),
                r1__part_8_1
                    .mul_add(
                        r1__part_29_last,
                        r1__part_8_last.mul_add(r1__part_29_1, next[40]),
                    ),
                u3_part_12_1
                    .mul_add(
                        r1__part_32_last,
                        u3_part_12_last.mul_add(r1__part_32_1, next[41]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_37_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_37_1, next[42]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_39_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_39_1, next[43]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        u3_part_3_last,
                        cos_theta2_from_theta1_last.mul_add(u3_part_3_1, next[44]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_43_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_43_1, next[45]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_45_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_45_1, next[46]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_47_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_47_1, next[47]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_49_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_49_1, next[48]),
                    ),
                r1__part_35_1
                    .mul_add(
                        r1__part_52_last,
                        r1__part_35_last.mul_add(r1__part_52_1, next[49]),
                    ),
                r1__part_36_1
                    .mul_add(
                        r1__part_54_last,
                        r1__part_36_last.mul_add(r1__part_54_1, next[50]),
                    ),
                r1__part_27_1
                    .mul_add(
                        r1__part_29_last,
                        r1__part_27_last.mul_add(r1__part_29_1, next[51]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_28_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_28_1, next[52]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_58_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_58_1, next[53]),
                    ),
                u3_part_12_1
                    .mul_add(
                        r1__part_60_last,
                        u3_part_12_last.mul_add(r1__part_60_1, next[54]),
                    ),
                u4_from_u3_1
                    .mul_add(
                        r1__part_62_last,
                        u4_from_u3_last.mul_add(r1__part_62_1, next[55]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__part_64_last,
                        sin_theta2_from_theta1_last.mul_add(r1__part_64_1, next[56]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_58_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_58_1, next[57]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__part_67_last,
                        sin_theta3_from_theta1_last.mul_add(r1__part_67_1, next[58]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_69_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_69_1, next[59]),
                    ),
                u4_from_u3_1
                    .mul_add(
                        r1__part_71_last,
                        u4_from_u3_last.mul_add(r1__part_71_1, next[60]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_73_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_73_1, next[61]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__part_75_last,
                        sin_theta3_from_theta1_last.mul_add(r1__part_75_1, next[62]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__part_77_last,
                        sin_theta2_from_theta1_last.mul_add(r1__part_77_1, next[63]),
                    ),
                u3_part_12_1
                    .mul_add(
                        r1__part_79_last,
                        u3_part_12_last.mul_add(r1__part_79_1, next[64]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_34_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_34_1, next[65]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_82_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_82_1, next[66]),
                    ),
                r1__part_62_1
                    .mul_add(
                        u4_from_u3_p2_last,
                        r1__part_62_last.mul_add(u4_from_u3_p2_1, next[67]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__part_85_last,
                        sin_theta2_from_theta1_last.mul_add(r1__part_85_1, next[68]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_82_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_82_1, next[69]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__part_88_last,
                        sin_theta3_from_theta1_last.mul_add(r1__part_88_1, next[70]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        r1__part_90_last,
                        cos_theta3_from_theta1_last.mul_add(r1__part_90_1, next[71]),
                    ),
                r1__part_71_1
                    .mul_add(
                        u4_from_u3_p2_last,
                        r1__part_71_last.mul_add(u4_from_u3_p2_1, next[72]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        r1__part_93_last,
                        cos_theta2_from_theta1_last.mul_add(r1__part_93_1, next[73]),
                    ),
                sin_theta3_from_theta1_1
                    .mul_add(
                        r1__part_95_last,
                        sin_theta3_from_theta1_last.mul_add(r1__part_95_1, next[74]),
                    ),
                sin_theta2_from_theta1_1
                    .mul_add(
                        r1__part_97_last,
                        sin_theta2_from_theta1_last.mul_add(r1__part_97_1, next[75]),
                    ),
                u3_part_8_1
                    .mul_add(
                        r1__part_100_last,
                        u3_part_8_last.mul_add(r1__part_100_1, next[76]),
                    ),
                r1__part_42_1
                    .mul_add(
                        r1__part_102_last,
                        r1__part_42_last.mul_add(r1__part_102_1, next[77]),
                    ),
                r1__part_101_1
                    .mul_add(
                        r1__part_102_last,
                        r1__part_101_last.mul_add(r1__part_102_1, next[78]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        cos_theta3_from_theta1_last,
                        cos_theta2_from_theta1_last
                            .mul_add(cos_theta3_from_theta1_1, next[79]),
                    ),
                cos_theta2_from_theta1_1
                    .mul_add(
                        u5_from_u3_dot_part_2_last,
                        cos_theta2_from_theta1_last
                            .mul_add(u5_from_u3_dot_part_2_1, next[80]),
                    ),
                cos_theta3_from_theta1_1
                    .mul_add(
                        u5_from_u3_dot_part_4_last,
                        cos_theta3_from_theta1_last
                            .mul_add(u5_from_u3_dot_part_4_1, next[81]),
                    ),
                u5_from_u3_dot_part_6_1
                    .mul_add(
                        u5_from_u3_dot_part_7_last,
                        u5_from_u3_dot_part_6_last
                            .mul_add(u5_from_u3_dot_part_7_1, next[82]),
                    ),
                r1__part_104_1
                    .mul_add(
                        u5_from_u3_dot_part_7_last,
                        r1__part_104_last.mul_add(u5_from_u3_dot_part_7_1, next[83]),
                    ),
                u3_part_8_1
                    .mul_add(
                        u4_from_u3_dot_part_last,
                        u3_part_8_last.mul_add(u4_from_u3_dot_part_1, next[84]),
                    ),
                u5_from_u3_dot_part_8_1
                    .mul_add(
                        u4_from_u3_dot_part_last,
                        u5_from_u3_dot_part_8_last
                            .mul_add(u4_from_u3_dot_part_1, next[85]),
                    ),
                r1__part_42_1
                    .mul_add(
                        u4_from_u3_dot_part_4_last,
                        r1__part_42_last.mul_add(u4_from_u3_dot_part_4_1, next[86]),
                    ),
                u4_from_u3_dot_part_3_1
                    .mul_add(
                        u4_from_u3_dot_part_4_last,
                        u4_from_u3_dot_part_3_last
                            .mul_add(u4_from_u3_dot_part_4_1, next[87]),
                    ),
            ]
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
        // u3_part_11 = minus_750_h_n3 + 7*u3_part_9 + 7*u3_part_10
        let u3_part_11 = u3_part_10.mul_add(S::int(7), S::int(7) * u3_part_9);
        // u3_part_12 = u3_part_11/u3_part_8
        let u3_part_12 = u3_part_11
            .mul_add(
                over_u3_part_8,
                -(u3_part_8.mul_add(u3_part_12_0, sums[9]) * over_u3_part_8),
            );
        // sin_theta1 = sin(theta1)
        let sin_theta1 = theta1.mul_add(cos_theta1_0, sums[10] * over_k);
        // cos_theta1 = cos(theta1)
        let cos_theta1 = -theta1.mul_add(sin_theta1_0, sums[11] * over_k);
        // r1__part = u3_part_12*u3_part_12
        let r1__part = u3_part_12.mul_add(u3_part_12_0 + u3_part_12_0, sums[12]);
        // r1__part_2 = cos_theta1*r1__part
        let r1__part_2 = r1__part
            .mul_add(cos_theta1_0, cos_theta1.mul_add(r1__part_0, sums[13]));
        // r1__part_3 = sin_theta1*r1__part
        let r1__part_3 = r1__part
            .mul_add(sin_theta1_0, sin_theta1.mul_add(r1__part_0, sums[14]));
        // r1__part_4 = theta1 + theta2_from_theta1
        let r1__part_4 = theta1 + theta2_from_theta1;
        // r1__part_5 = theta1 + theta3_from_theta1
        let r1__part_5 = theta1 + theta3_from_theta1;
        // sin_angle = sin(r1__part_4)
        let sin_angle = r1__part_4.mul_add(cos_angle_0, sums[15] * over_k);
        // cos_angle = cos(r1__part_4)
        let cos_angle = -r1__part_4.mul_add(sin_angle_0, sums[16] * over_k);
        // sin_angle_2 = sin(r1__part_5)
        let sin_angle_2 = r1__part_5.mul_add(cos_angle_2_0, sums[17] * over_k);
        // cos_angle_2 = cos(r1__part_5)
        let cos_angle_2 = -r1__part_5.mul_add(sin_angle_2_0, sums[18] * over_k);
        // r1__part_6 = theta2_from_theta1 - theta3_from_theta1
        let r1__part_6 = theta2_from_theta1 - theta3_from_theta1;
        // sin_angle_3 = sin(r1__part_6)
        let sin_angle_3 = r1__part_6.mul_add(cos_angle_3_0, sums[19] * over_k);
        // cos_angle_3 = cos(r1__part_6)
        let cos_angle_3 = -r1__part_6.mul_add(sin_angle_3_0, sums[20] * over_k);
        // r1__part_7 = sin_theta2_from_theta1*r1__part
        let r1__part_7 = r1__part
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__part_0, sums[21]),
            );
        // r1__part_8 = 2*sin_theta1 + 3*sin_angle + sin_angle_2
        let r1__part_8 = sin_angle.mul_add(S::int(3), S::int(2) * sin_theta1)
            + sin_angle_2;
        // r1__part_9 = 2*cos_theta1 + 3*cos_angle + cos_angle_2
        let r1__part_9 = cos_angle.mul_add(S::int(3), S::int(2) * cos_theta1)
            + cos_angle_2;
        // u3_plus_u4_from_u3 = -1/7*u3_part_12 + u4_from_u3
        let u3_plus_u4_from_u3 = u3_part_12.mul_add(-S::ratio(1, 7), u4_from_u3);
        // u3_plus_u5_from_u3 = -1/7*u3_part_12 + u5_from_u3
        let u3_plus_u5_from_u3 = u3_part_12.mul_add(-S::ratio(1, 7), u5_from_u3);
        // r1__part_10 = u3_plus_u4_from_u3*u3_plus_u4_from_u3
        let r1__part_10 = u3_plus_u4_from_u3
            .mul_add(u3_plus_u4_from_u3_0 + u3_plus_u4_from_u3_0, sums[22]);
        // r1__part_11 = cos_angle*r1__part_10
        let r1__part_11 = r1__part_10
            .mul_add(cos_angle_0, cos_angle.mul_add(r1__part_10_0, sums[23]));
        // r1__part_12 = u3_plus_u5_from_u3*u3_plus_u5_from_u3
        let r1__part_12 = u3_plus_u5_from_u3
            .mul_add(u3_plus_u5_from_u3_0 + u3_plus_u5_from_u3_0, sums[24]);
        // r1__part_13 = cos_angle_2*r1__part_12
        let r1__part_13 = r1__part_12
            .mul_add(cos_angle_2_0, cos_angle_2.mul_add(r1__part_12_0, sums[25]));
        // r1__part_14 = sin_theta2_from_theta1*u4_from_u3
        let r1__part_14 = sin_theta2_from_theta1
            .mul_add(
                u4_from_u3_0,
                u4_from_u3.mul_add(sin_theta2_from_theta1_0, sums[26]),
            );
        // r1__part_15 = sin_theta3_from_theta1*u5_from_u3
        let r1__part_15 = sin_theta3_from_theta1
            .mul_add(
                u5_from_u3_0,
                u5_from_u3.mul_add(sin_theta3_from_theta1_0, sums[27]),
            );
        // u4_from_u3_p2 = u4_from_u3*u4_from_u3
        let u4_from_u3_p2 = u4_from_u3.mul_add(u4_from_u3_0 + u4_from_u3_0, sums[28]);
        // r1__part_16 = sin_theta2_from_theta1*u4_from_u3_p2
        let r1__part_16 = u4_from_u3_p2
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(u4_from_u3_p2_0, sums[29]),
            );
        // r1__part_17 = u5_from_u3*r1__part_15
        let r1__part_17 = r1__part_15
            .mul_add(u5_from_u3_0, u5_from_u3.mul_add(r1__part_15_0, sums[30]));
        // r1__part_18 = sin_angle*r1__part_10
        let r1__part_18 = r1__part_10
            .mul_add(sin_angle_0, sin_angle.mul_add(r1__part_10_0, sums[31]));
        // r1__part_19 = sin_angle_2*r1__part_12
        let r1__part_19 = r1__part_12
            .mul_add(sin_angle_2_0, sin_angle_2.mul_add(r1__part_12_0, sums[32]));
        // r1__part_20 = sin_angle_3*r1__part_12
        let r1__part_20 = r1__part_12
            .mul_add(sin_angle_3_0, sin_angle_3.mul_add(r1__part_12_0, sums[33]));
        // r1__part_21 = u4_from_u3 - u5_from_u3
        let r1__part_21 = u4_from_u3 - u5_from_u3;
        // u5_from_u3_p2 = u5_from_u3*u5_from_u3
        let u5_from_u3_p2 = u5_from_u3.mul_add(u5_from_u3_0 + u5_from_u3_0, sums[34]);
        // r1__part_22 = u4_from_u3_p2 - u5_from_u3_p2
        let r1__part_22 = u4_from_u3_p2 - u5_from_u3_p2;
        // r1__part_23 = sin_angle_3*r1__part_21
        let r1__part_23 = sin_angle_3
            .mul_add(r1__part_21_0, r1__part_21.mul_add(sin_angle_3_0, sums[35]));
        // r1__part_24 = 3*r1__part_14 + r1__part_15 + 2*r1__part_23
        let r1__part_24 = r1__part_23
            .mul_add(S::int(2), S::int(3) * r1__part_14 + r1__part_15);
        // r1__part_25 = u3_part_12*r1__part_24
        let r1__part_25 = u3_part_12
            .mul_add(r1__part_24_0, r1__part_24.mul_add(u3_part_12_0, sums[36]));
        // r1__part_26 = sin_angle_3*r1__part_22
        let r1__part_26 = r1__part_22
            .mul_add(sin_angle_3_0, sin_angle_3.mul_add(r1__part_22_0, sums[37]));
        // r1__part_27 = 3*r1__part_16 + r1__part_17 - 2/7*r1__part_25 + 2*r1__part_26
        let r1__part_27 = r1__part_25
            .mul_add(
                -S::ratio(2, 7),
                r1__part_26.mul_add(S::int(2), S::int(3) * r1__part_16) + r1__part_17,
            );
        // r1__part_28 = -1/7*u3_part_12 + u4_from_u3 + u5_from_u3
        let r1__part_28 = u3_part_12.mul_add(-S::ratio(1, 7), u4_from_u3 + u5_from_u3);
        // r1__part_29 = u3_part_4/u3_part_8
        let r1__part_29 = u3_part_8
            .mul_add(
                -(r1__part_29_0 * over_u3_part_8),
                (u3_part_4 - sums[38]) * over_u3_part_8,
            );
        // r1__part_30 = r1__part_9*r1__part_29
        let r1__part_30 = r1__part_29
            .mul_add(r1__part_9_0, r1__part_9.mul_add(r1__part_29_0, sums[39]));
        // r1__part_31 = r1__part_8*r1__part_29
        let r1__part_31 = r1__part_29
            .mul_add(r1__part_8_0, r1__part_8.mul_add(r1__part_29_0, sums[40]));
        // r1__part_32 = 5 + 2*cos_theta2_from_theta1
        let r1__part_32 = S::int(2) * cos_theta2_from_theta1;
        // r1__part_33 = u3_part_12*r1__part_32
        let r1__part_33 = u3_part_12
            .mul_add(r1__part_32_0, r1__part_32.mul_add(u3_part_12_0, sums[41]));
        // r1__part_34 = u4_from_u3_p2 + u5_from_u3_p2
        let r1__part_34 = u4_from_u3_p2 + u5_from_u3_p2;
        // r1__part_35 = 3*sin_angle - r1__part_31
        let r1__part_35 = S::int(3) * sin_angle - r1__part_31;
        // r1__part_36 = 3*cos_angle - r1__part_30
        let r1__part_36 = S::int(3) * cos_angle - r1__part_30;
        // r1__part_37 = u3_part_2 + u3_part_3
        let r1__part_37 = u3_part_3 + u3_part_2;
        // r1__part_38 = cos_theta2_from_theta1*r1__part_37
        let r1__part_38 = r1__part_37
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_37_0, sums[42]),
            );
        // r1__part_39 = 14 + 9*cos_theta3_from_theta1 - 18*r1__part_38
        let r1__part_39 = r1__part_38
            .mul_add(-S::int(18), S::int(9) * cos_theta3_from_theta1);
        // r1__part_40 = cos_theta3_from_theta1*r1__part_39
        let r1__part_40 = r1__part_39
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_39_0, sums[43]),
            );
        // r1__part_41 = cos_theta2_from_theta1*u3_part_3
        let r1__part_41 = u3_part_3
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u3_part_3_0, sums[44]),
            );
        // r1__part_42 = 33 + r1__part_40 - 18*r1__part_41
        let r1__part_42 = -S::int(18) * r1__part_41 + r1__part_40;
        // r1__part_43 = 1 + 2*cos_theta3_from_theta1
        let r1__part_43 = S::int(2) * cos_theta3_from_theta1;
        // r1__part_44 = cos_theta2_from_theta1*r1__part_43
        let r1__part_44 = r1__part_43
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_43_0, sums[45]),
            );
        // r1__part_45 = 2 + cos_theta3_from_theta1 + 6*u3_part_3 + 3*r1__part_44
        let r1__part_45 = r1__part_44
            .mul_add(S::int(3), u3_part_3.mul_add(S::int(6), cos_theta3_from_theta1));
        // r1__part_46 = cos_theta3_from_theta1*r1__part_45
        let r1__part_46 = r1__part_45
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_45_0, sums[46]),
            );
        // r1__part_47 = 3 + 3*cos_theta2_from_theta1 - 3*u3_part_3 - r1__part_46
        let r1__part_47 = u3_part_3
            .mul_add(-S::int(3), S::int(3) * cos_theta2_from_theta1) - r1__part_46;
        // r1__part_48 = cos_theta2_from_theta1*r1__part_47
        let r1__part_48 = r1__part_47
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_47_0, sums[47]),
            );
        // r1__part_49 = 7 + 9*cos_theta3_from_theta1 - 3*u3_part_3
        let r1__part_49 = u3_part_3
            .mul_add(-S::int(3), S::int(9) * cos_theta3_from_theta1);
        // r1__part_50 = cos_theta3_from_theta1*r1__part_49
        let r1__part_50 = r1__part_49
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_49_0, sums[48]),
            );
        // r1__part_51 = -12 + 9*u3_part_3 - 3*r1__part_48 - r1__part_50
        let r1__part_51 = r1__part_48
            .mul_add(-S::int(3), S::int(9) * u3_part_3 - r1__part_50);
        // r1__part_52 = 2/49*r1__part_2 + 3*r1__part_11 + r1__part_13
        let r1__part_52 = r1__part_11.mul_add(S::int(3), S::ratio(2, 49) * r1__part_2)
            + r1__part_13;
        // r1__part_53 = r1__part_35*r1__part_52
        let r1__part_53 = r1__part_52
            .mul_add(r1__part_35_0, r1__part_35.mul_add(r1__part_52_0, sums[49]));
        // r1__part_54 = 2/49*r1__part_3 + 3*r1__part_18 + r1__part_19
        let r1__part_54 = r1__part_18.mul_add(S::int(3), S::ratio(2, 49) * r1__part_3)
            + r1__part_19;
        // r1__part_55 = r1__part_36*r1__part_54
        let r1__part_55 = r1__part_54
            .mul_add(r1__part_36_0, r1__part_36.mul_add(r1__part_54_0, sums[50]));
        // r1__part_56 = r1__part_27*r1__part_29
        let r1__part_56 = r1__part_27
            .mul_add(r1__part_29_0, r1__part_29.mul_add(r1__part_27_0, sums[51]));
        // r1__part_57 = cos_theta2_from_theta1*r1__part_28
        let r1__part_57 = r1__part_28
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_28_0, sums[52]),
            );
        // r1__part_58 = -2/7*u3_part_12 + u4_from_u3 + 2*u5_from_u3 + 6*r1__part_57
        let r1__part_58 = r1__part_57
            .mul_add(
                S::int(6),
                u3_part_12
                    .mul_add(-S::ratio(2, 7), u5_from_u3.mul_add(S::int(2), u4_from_u3)),
            );
        // r1__part_59 = cos_theta3_from_theta1*r1__part_58
        let r1__part_59 = r1__part_58
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_58_0, sums[53]),
            );
        // r1__part_60 = 13 + 6*cos_theta2_from_theta1
        let r1__part_60 = S::int(6) * cos_theta2_from_theta1;
        // r1__part_61 = u3_part_12*r1__part_60
        let r1__part_61 = u3_part_12
            .mul_add(r1__part_60_0, r1__part_60.mul_add(u3_part_12_0, sums[54]));
        // r1__part_62 = 3 + cos_theta2_from_theta1
        let r1__part_62 = cos_theta2_from_theta1;
        // r1__part_63 = u4_from_u3*r1__part_62
        let r1__part_63 = r1__part_62
            .mul_add(u4_from_u3_0, u4_from_u3.mul_add(r1__part_62_0, sums[55]));
        // r1__part_64 = 6*u5_from_u3 + 2*r1__part_59 - 1/7*r1__part_61 + 6*r1__part_63
        let r1__part_64 = r1__part_59
            .mul_add(
                S::int(2),
                r1__part_61
                    .mul_add(
                        -S::ratio(1, 7),
                        r1__part_63.mul_add(S::int(6), S::int(6) * u5_from_u3),
                    ),
            );
        // r1__part_65 = sin_theta2_from_theta1*r1__part_64
        let r1__part_65 = r1__part_64
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__part_64_0, sums[56]),
            );
        // r1__part_66 = cos_theta2_from_theta1*r1__part_58
        let r1__part_66 = r1__part_58
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_58_0, sums[57]),
            );
        // r1__part_67 = -8/7*u3_part_12 + 9*u4_from_u3 + 8*u5_from_u3 - 3*r1__part_66
        let r1__part_67 = r1__part_66
            .mul_add(
                -S::int(3),
                u3_part_12
                    .mul_add(
                        -S::ratio(8, 7),
                        u5_from_u3.mul_add(S::int(8), S::int(9) * u4_from_u3),
                    ),
            );
        // r1__part_68 = sin_theta3_from_theta1*r1__part_67
        let r1__part_68 = r1__part_67
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__part_67_0, sums[58]),
            );
        // r1__part_69 = 3*r1__part_65 + 2*r1__part_68
        let r1__part_69 = r1__part_68.mul_add(S::int(2), S::int(3) * r1__part_65);
        // r1__part_70 = cos_theta3_from_theta1*r1__part_69
        let r1__part_70 = r1__part_69
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_69_0, sums[59]),
            );
        // r1__part_71 = 10 + 3*cos_theta2_from_theta1
        let r1__part_71 = S::int(3) * cos_theta2_from_theta1;
        // r1__part_72 = u4_from_u3*r1__part_71
        let r1__part_72 = r1__part_71
            .mul_add(u4_from_u3_0, u4_from_u3.mul_add(r1__part_71_0, sums[60]));
        // r1__part_73 = 6*u5_from_u3 - 3/7*r1__part_33 + 2*r1__part_72
        let r1__part_73 = r1__part_33
            .mul_add(
                -S::ratio(3, 7),
                r1__part_72.mul_add(S::int(2), S::int(6) * u5_from_u3),
            );
        // r1__part_74 = cos_theta2_from_theta1*r1__part_73
        let r1__part_74 = r1__part_73
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_73_0, sums[61]),
            );
        // r1__part_75 = -13/7*u3_part_12 + 18*u4_from_u3 + 6*u5_from_u3 + 3*r1__part_74
        let r1__part_75 = r1__part_74
            .mul_add(
                S::int(3),
                u3_part_12
                    .mul_add(
                        -S::ratio(13, 7),
                        u5_from_u3.mul_add(S::int(6), S::int(18) * u4_from_u3),
                    ),
            );
        // r1__part_76 = sin_theta3_from_theta1*r1__part_75
        let r1__part_76 = r1__part_75
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__part_75_0, sums[62]),
            );
        // r1__part_77 = -1/7*u3_part_12 + 3*u4_from_u3 + u5_from_u3 + 3*r1__part_57
        let r1__part_77 = r1__part_57
            .mul_add(
                S::int(3),
                u3_part_12.mul_add(-S::ratio(1, 7), S::int(3) * u4_from_u3 + u5_from_u3),
            );
        // r1__part_78 = sin_theta2_from_theta1*r1__part_77
        let r1__part_78 = r1__part_77
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__part_77_0, sums[63]),
            );
        // r1__part_79 = r1__part_70 - r1__part_76 - 6*r1__part_78
        let r1__part_79 = -S::int(6) * r1__part_78 - r1__part_76 + r1__part_70;
        // r1__part_80 = u3_part_12*r1__part_79
        let r1__part_80 = r1__part_79
            .mul_add(u3_part_12_0, u3_part_12.mul_add(r1__part_79_0, sums[64]));
        // r1__part_81 = cos_theta2_from_theta1*r1__part_34
        let r1__part_81 = r1__part_34
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_34_0, sums[65]),
            );
        // r1__part_82 = u4_from_u3_p2 + 2*u5_from_u3_p2 + 6*r1__part_81
        let r1__part_82 = r1__part_81
            .mul_add(S::int(6), u5_from_u3_p2.mul_add(S::int(2), u4_from_u3_p2));
        // r1__part_83 = cos_theta3_from_theta1*r1__part_82
        let r1__part_83 = r1__part_82
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_82_0, sums[66]),
            );
        // r1__part_84 = r1__part_62*u4_from_u3_p2
        let r1__part_84 = r1__part_62
            .mul_add(u4_from_u3_p2_0, u4_from_u3_p2.mul_add(r1__part_62_0, sums[67]));
        // r1__part_85 = 3*u5_from_u3_p2 + r1__part_83 + 3*r1__part_84
        let r1__part_85 = r1__part_84.mul_add(S::int(3), S::int(3) * u5_from_u3_p2)
            + r1__part_83;
        // r1__part_86 = sin_theta2_from_theta1*r1__part_85
        let r1__part_86 = r1__part_85
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__part_85_0, sums[68]),
            );
        // r1__part_87 = cos_theta2_from_theta1*r1__part_82
        let r1__part_87 = r1__part_82
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_82_0, sums[69]),
            );
        // r1__part_88 = 9*u4_from_u3_p2 + 8*u5_from_u3_p2 - 3*r1__part_87
        let r1__part_88 = r1__part_87
            .mul_add(
                -S::int(3),
                u5_from_u3_p2.mul_add(S::int(8), S::int(9) * u4_from_u3_p2),
            );
        // r1__part_89 = sin_theta3_from_theta1*r1__part_88
        let r1__part_89 = r1__part_88
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__part_88_0, sums[70]),
            );
        // r1__part_90 = 3*r1__part_86 + r1__part_89
        let r1__part_90 = S::int(3) * r1__part_86 + r1__part_89;
        // r1__part_91 = cos_theta3_from_theta1*r1__part_90
        let r1__part_91 = r1__part_90
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(r1__part_90_0, sums[71]),
            );
        // r1__part_92 = r1__part_71*u4_from_u3_p2
        let r1__part_92 = r1__part_71
            .mul_add(u4_from_u3_p2_0, u4_from_u3_p2.mul_add(r1__part_71_0, sums[72]));
        // r1__part_93 = 3*u5_from_u3_p2 + r1__part_92
        let r1__part_93 = S::int(3) * u5_from_u3_p2 + r1__part_92;
        // r1__part_94 = cos_theta2_from_theta1*r1__part_93
        let r1__part_94 = r1__part_93
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(r1__part_93_0, sums[73]),
            );
        // r1__part_95 = 3*u4_from_u3_p2 + u5_from_u3_p2 + r1__part_94
        let r1__part_95 = S::int(3) * u4_from_u3_p2 + u5_from_u3_p2 + r1__part_94;
        // r1__part_96 = sin_theta3_from_theta1*r1__part_95
        let r1__part_96 = r1__part_95
            .mul_add(
                sin_theta3_from_theta1_0,
                sin_theta3_from_theta1.mul_add(r1__part_95_0, sums[74]),
            );
        // r1__part_97 = 3*u4_from_u3_p2 + u5_from_u3_p2 + 3*r1__part_81
        let r1__part_97 = r1__part_81
            .mul_add(S::int(3), S::int(3) * u4_from_u3_p2 + u5_from_u3_p2);
        // r1__part_98 = sin_theta2_from_theta1*r1__part_97
        let r1__part_98 = r1__part_97
            .mul_add(
                sin_theta2_from_theta1_0,
                sin_theta2_from_theta1.mul_add(r1__part_97_0, sums[75]),
            );
        // r1__part_99 = -1/7*r1__part_80 + r1__part_91 - 3*r1__part_96 - 3*r1__part_98
        let r1__part_99 = r1__part_80
            .mul_add(
                -S::ratio(1, 7),
                r1__part_96.mul_add(-S::int(3), -S::int(3) * r1__part_98) + r1__part_91,
            );
        // r1__part_100 = r1__part_99/u3_part_8
        let r1__part_100 = r1__part_99
            .mul_add(
                over_u3_part_8,
                -(u3_part_8.mul_add(r1__part_100_0, sums[76]) * over_u3_part_8),
            );
        // r1__part_101 = 9/49*r1__part_7 + 6*r1__part_20 - r1__part_53 + r1__part_55 + 3*r1__part_56
        let r1__part_101 = r1__part_56
            .mul_add(
                S::int(3),
                r1__part_20.mul_add(S::int(6), S::ratio(9, 49) * r1__part_7),
            ) + r1__part_55 - r1__part_53;
        // r1__part_102 = r1__part_51/r1__part_42
        let r1__part_102 = r1__part_42
            .mul_add(
                -(r1__part_102_0 * over_r1__part_42),
                (r1__part_51 - sums[77]) * over_r1__part_42,
            );
        // r1__part_103 = r1__part_101*r1__part_102
        let r1__part_103 = r1__part_101
            .mul_add(r1__part_102_0, r1__part_102.mul_add(r1__part_101_0, sums[78]));
        // r1__part_104 = 7/750*r1__part_100 + 7/750*r1__part_103
        let r1__part_104 = r1__part_100
            .mul_add(S::ratio(7, 750), S::ratio(7, 750) * r1__part_103);
        // u5_from_u3_dot_part = cos_theta2_from_theta1*cos_theta3_from_theta1
        let u5_from_u3_dot_part = cos_theta3_from_theta1
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(cos_theta3_from_theta1_0, sums[79]),
            );
        // u5_from_u3_dot_part_2 = u3_part_3 + u5_from_u3_dot_part
        let u5_from_u3_dot_part_2 = u3_part_3 + u5_from_u3_dot_part;
        // u5_from_u3_dot_part_3 = cos_theta2_from_theta1*u5_from_u3_dot_part_2
        let u5_from_u3_dot_part_3 = u5_from_u3_dot_part_2
            .mul_add(
                cos_theta2_from_theta1_0,
                cos_theta2_from_theta1.mul_add(u5_from_u3_dot_part_2_0, sums[80]),
            );
        // u5_from_u3_dot_part_4 = 5*cos_theta3_from_theta1 - 9*u5_from_u3_dot_part_3
        let u5_from_u3_dot_part_4 = u5_from_u3_dot_part_3
            .mul_add(-S::int(9), S::int(5) * cos_theta3_from_theta1);
        // u5_from_u3_dot_part_5 = cos_theta3_from_theta1*u5_from_u3_dot_part_4
        let u5_from_u3_dot_part_5 = u5_from_u3_dot_part_4
            .mul_add(
                cos_theta3_from_theta1_0,
                cos_theta3_from_theta1.mul_add(u5_from_u3_dot_part_4_0, sums[81]),
            );
        // u5_from_u3_dot_part_6 = 9 + u5_from_u3_dot_part_5
        let u5_from_u3_dot_part_6 = u5_from_u3_dot_part_5;
        // u5_from_u3_dot_part_7 = r1__part_42/u5_from_u3_dot_part_6
        let u5_from_u3_dot_part_7 = r1__part_42
            .mul_add(
                over_u5_from_u3_dot_part_6,
                -(u5_from_u3_dot_part_6.mul_add(u5_from_u3_dot_part_7_0, sums[82])
                    * over_u5_from_u3_dot_part_6),
            );
        // u5_from_u3_dot_part_8 = r1__part_104*u5_from_u3_dot_part_7
        let u5_from_u3_dot_part_8 = r1__part_104
            .mul_add(
                u5_from_u3_dot_part_7_0,
                u5_from_u3_dot_part_7.mul_add(r1__part_104_0, sums[83]),
            );
        // u4_from_u3_dot_part = r1__part_51/u3_part_8
        let u4_from_u3_dot_part = r1__part_51
            .mul_add(
                over_u3_part_8,
                -(u3_part_8.mul_add(u4_from_u3_dot_part_0, sums[84]) * over_u3_part_8),
            );
        // u4_from_u3_dot_part_2 = u5_from_u3_dot_part_8*u4_from_u3_dot_part
        let u4_from_u3_dot_part_2 = u5_from_u3_dot_part_8
            .mul_add(
                u4_from_u3_dot_part_0,
                u4_from_u3_dot_part.mul_add(u5_from_u3_dot_part_8_0, sums[85]),
            );
        // u4_from_u3_dot_part_3 = 9/49*r1__part_7 + 6*r1__part_20 - r1__part_53 + r1__part_55 +
        //   3*r1__part_56 + 375/14*u4_from_u3_dot_part_2
        let u4_from_u3_dot_part_3 = u4_from_u3_dot_part_2
            .mul_add(
                S::ratio(375, 14),
                r1__part_56
                    .mul_add(
                        S::int(3),
                        r1__part_20.mul_add(S::int(6), S::ratio(9, 49) * r1__part_7),
                    ) + r1__part_55 - r1__part_53,
            );
        // u4_from_u3_dot_part_4 = u3_part_8/r1__part_42
        let u4_from_u3_dot_part_4 = r1__part_42
            .mul_add(
                -(u4_from_u3_dot_part_4_0 * over_r1__part_42),
                (u3_part_8 - sums[86]) * over_r1__part_42,
            );
        // u4_from_u3_dot_part_5 = u4_from_u3_dot_part_3*u4_from_u3_dot_part_4
        let u4_from_u3_dot_part_5 = u4_from_u3_dot_part_3
            .mul_add(
                u4_from_u3_dot_part_4_0,
                u4_from_u3_dot_part_4.mul_add(u4_from_u3_dot_part_3_0, sums[87]),
            );
        theta2_from_theta1_rate = u4_from_u3;
        theta3_from_theta1_rate = u5_from_u3;
        theta1_rate = -S::ratio(1, 7) * u3_part_12;
        u4_from_u3_rate = -u4_from_u3_dot_part_5;
        u5_from_u3_rate = S::ratio(375, 14) * u5_from_u3_dot_part_8;
        // Factors of the convolutions: left, right.
        history[order] = [
            [
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
                count * theta1,
                count * theta1,
                u3_part_12,
                cos_theta1,
                sin_theta1,
                count * r1__part_4,
                count * r1__part_4,
                count * r1__part_5,
                count * r1__part_5,
                count * r1__part_6,
                count * r1__part_6,
                sin_theta2_from_theta1,
                u3_plus_u4_from_u3,
                cos_angle,
                u3_plus_u5_from_u3,
                cos_angle_2,
                sin_theta2_from_theta1,
                sin_theta3_from_theta1,
                u4_from_u3,
                sin_theta2_from_theta1,
                u5_from_u3,
                sin_angle,
                sin_angle_2,
                sin_angle_3,
                u5_from_u3,
                sin_angle_3,
                u3_part_12,
                sin_angle_3,
                u3_part_8,
                r1__part_9,
                r1__part_8,
                u3_part_12,
                cos_theta2_from_theta1,
                cos_theta3_from_theta1,
                cos_theta2_from_theta1,
                cos_theta2_from_theta1,
                cos_theta3_from_theta1,
                cos_theta2_from_theta1,
                cos_theta3_from_theta1,
                r1__part_35,
                r1__part_36,
                r1__part_27,
                cos_theta2_from_theta1,
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
                r1__part_62,
                sin_theta2_from_theta1,
                cos_theta2_from_theta1,
                sin_theta3_from_theta1,
                cos_theta3_from_theta1,
                r1__part_71,
                cos_theta2_from_theta1,
                sin_theta3_from_theta1,
                sin_theta2_from_theta1,
                u3_part_8,
                r1__part_42,
                r1__part_101,
                cos_theta2_from_theta1,
                cos_theta2_from_theta1,
                cos_theta3_from_theta1,
                u5_from_u3_dot_part_6,
                r1__part_104,
                u3_part_8,
                u5_from_u3_dot_part_8,
                r1__part_42,
                u4_from_u3_dot_part_3,
            ],
            [
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
                cos_theta1,
                sin_theta1,
                u3_part_12,
                r1__part,
                r1__part,
                cos_angle,
                sin_angle,
                cos_angle_2,
                sin_angle_2,
                cos_angle_3,
                sin_angle_3,
                r1__part,
                u3_plus_u4_from_u3,
                r1__part_10,
                u3_plus_u5_from_u3,
                r1__part_12,
                u4_from_u3,
                u5_from_u3,
                u4_from_u3,
                u4_from_u3_p2,
                r1__part_15,
                r1__part_10,
                r1__part_12,
                r1__part_12,
                u5_from_u3,
                r1__part_21,
                r1__part_24,
                r1__part_22,
                r1__part_29,
                r1__part_29,
                r1__part_29,
                r1__part_32,
                r1__part_37,
                r1__part_39,
                u3_part_3,
                r1__part_43,
                r1__part_45,
                r1__part_47,
                r1__part_49,
                r1__part_52,
                r1__part_54,
                r1__part_29,
                r1__part_28,
                r1__part_58,
                r1__part_60,
                r1__part_62,
                r1__part_64,
                r1__part_58,
                r1__part_67,
                r1__part_69,
                r1__part_71,
                r1__part_73,
                r1__part_75,
                r1__part_77,
                r1__part_79,
                r1__part_34,
                r1__part_82,
                u4_from_u3_p2,
                r1__part_85,
                r1__part_82,
                r1__part_88,
                r1__part_90,
                u4_from_u3_p2,
                r1__part_93,
                r1__part_95,
                r1__part_97,
                r1__part_100,
                r1__part_102,
                r1__part_102,
                cos_theta3_from_theta1,
                u5_from_u3_dot_part_2,
                u5_from_u3_dot_part_4,
                u5_from_u3_dot_part_7,
                u5_from_u3_dot_part_7,
                u4_from_u3_dot_part,
                u4_from_u3_dot_part,
                u4_from_u3_dot_part_4,
                u4_from_u3_dot_part_4,
            ],
        ];
        count_last = count;
        theta2_from_theta1_last = theta2_from_theta1;
        theta3_from_theta1_last = theta3_from_theta1;
        theta1_last = theta1;
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
        sin_theta1_last = sin_theta1;
        cos_theta1_last = cos_theta1;
        r1__part_last = r1__part;
        r1__part_4_last = r1__part_4;
        r1__part_5_last = r1__part_5;
        sin_angle_last = sin_angle;
        cos_angle_last = cos_angle;
        sin_angle_2_last = sin_angle_2;
        cos_angle_2_last = cos_angle_2;
        r1__part_6_last = r1__part_6;
        sin_angle_3_last = sin_angle_3;
        cos_angle_3_last = cos_angle_3;
        r1__part_8_last = r1__part_8;
        r1__part_9_last = r1__part_9;
        u3_plus_u4_from_u3_last = u3_plus_u4_from_u3;
        u3_plus_u5_from_u3_last = u3_plus_u5_from_u3;
        r1__part_10_last = r1__part_10;
        r1__part_12_last = r1__part_12;
        r1__part_15_last = r1__part_15;
        u4_from_u3_p2_last = u4_from_u3_p2;
        r1__part_21_last = r1__part_21;
        r1__part_22_last = r1__part_22;
        r1__part_24_last = r1__part_24;
        r1__part_27_last = r1__part_27;
        r1__part_28_last = r1__part_28;
        r1__part_29_last = r1__part_29;
        r1__part_32_last = r1__part_32;
        r1__part_34_last = r1__part_34;
        r1__part_35_last = r1__part_35;
        r1__part_36_last = r1__part_36;
        r1__part_37_last = r1__part_37;
        r1__part_39_last = r1__part_39;
        r1__part_42_last = r1__part_42;
        r1__part_43_last = r1__part_43;
        r1__part_45_last = r1__part_45;
        r1__part_47_last = r1__part_47;
        r1__part_49_last = r1__part_49;
        r1__part_52_last = r1__part_52;
        r1__part_54_last = r1__part_54;
        r1__part_58_last = r1__part_58;
        r1__part_60_last = r1__part_60;
        r1__part_62_last = r1__part_62;
        r1__part_64_last = r1__part_64;
        r1__part_67_last = r1__part_67;
        r1__part_69_last = r1__part_69;
        r1__part_71_last = r1__part_71;
        r1__part_73_last = r1__part_73;
        r1__part_75_last = r1__part_75;
        r1__part_77_last = r1__part_77;
        r1__part_79_last = r1__part_79;
        r1__part_82_last = r1__part_82;
        r1__part_85_last = r1__part_85;
        r1__part_88_last = r1__part_88;
        r1__part_90_last = r1__part_90;
        r1__part_93_last = r1__part_93;
        r1__part_95_last = r1__part_95;
        r1__part_97_last = r1__part_97;
        r1__part_100_last = r1__part_100;
        r1__part_101_last = r1__part_101;
        r1__part_102_last = r1__part_102;
        r1__part_104_last = r1__part_104;
        u5_from_u3_dot_part_2_last = u5_from_u3_dot_part_2;
        u5_from_u3_dot_part_4_last = u5_from_u3_dot_part_4;
        u5_from_u3_dot_part_6_last = u5_from_u3_dot_part_6;
        u5_from_u3_dot_part_7_last = u5_from_u3_dot_part_7;
        u5_from_u3_dot_part_8_last = u5_from_u3_dot_part_8;
        u4_from_u3_dot_part_last = u4_from_u3_dot_part;
        u4_from_u3_dot_part_3_last = u4_from_u3_dot_part_3;
        u4_from_u3_dot_part_4_last = u4_from_u3_dot_part_4;
    }
}

/// Reduced equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Reduced;

impl<S: Scalar> System<S> for Reduced {
    fn parameters(&self) -> usize {
        5
    }
    fn coordinates(&self) -> usize {
        3
    }
    fn speeds(&self) -> usize {
        2
    }
    fn reactions(&self) -> usize {
        0
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
        176 * order + SLACK
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
    key: "f29ceaad3cad5f1e",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: None,
    },
};
