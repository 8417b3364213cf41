//! Thin disk sliding on a frictionless plane: The flat fall.
//!
//! Generated from `models/disk/scenes/flat-fall.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{
    AtPoints, CompiledScene, CompiledSystem, Derivative, InLanes, Lengths, Scalar, System,
};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// acceleration of free fall, m/s^2
    pub g: S,
    /// generalized speed, constant with the momentum p_q3 = ∂L/∂q3', 1/s
    pub u3: S,
    /// momentum p_q4 = ∂L/∂q4', kg*m/s
    pub p_q4: S,
    /// momentum p_q5 = ∂L/∂q5', kg*m/s
    pub p_q5: S,
    /// -4 times the angular momentum about a3 through the mass centre, what is left of it on the singular surface, kg*m^2/s
    pub H_a3_there_scaled: S,
    /// q4 - sin(q1)*cos(q2_minus_90deg) at the start, kg*m
    pub centre_q4: S,
    /// q5 + cos(q1)*cos(q2_minus_90deg) at the start, kg*m
    pub centre_q5: S,
    /// 4*u3, 1/s
    pub u3_times_4: S,
    /// 4*g, m/s^2
    pub g_times_4: S,
    /// 2*u3, 1/s
    pub u3_times_2: S,
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
            g: p[0], u3: p[1], p_q4: p[2], p_q5: p[3], H_a3_there_scaled: p[4], centre_q4: p[5],
            centre_q5: p[6], u3_times_4: p[7], g_times_4: p[8], u3_times_2: p[9],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 10] {
        let Self {
            g, u3, p_q4, p_q5, H_a3_there_scaled, centre_q4, centre_q5, u3_times_4, g_times_4,
            u3_times_2,
            ..
        } = self;
        [
            g, u3, p_q4, p_q5, H_a3_there_scaled, centre_q4, centre_q5, u3_times_4, g_times_4,
            u3_times_2,
        ]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 10] = [
    "g", "u3", "p_q4", "p_q5", "H_a3_there_scaled", "centre_q4", "centre_q5", "u3_times_4",
    "g_times_4", "u3_times_2",
];

/// Names of the outputs.
pub const OUTPUTS: [&str; 10] = [
    "q1", "q2", "q3", "q4", "q5", "u1", "u2", "u3", "u4", "u5",
];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 21 operations, 2 sines and cosines.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    q: &[S; 5],
    u: &[S; 5],
) -> [S; 10] {
    let super::super::super::Parameters { g, .. } = *p;
    let [q1, q2, _, q4, q5] = *q;
    let [u1, u2, u3, u4, u5] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let u1_c2 = u1 * c2;
    let u2_c2_inv = u2 / c2;
    let s2_c1 = c1 * s2;
    let s2_s1 = s1 * s2;
    let u3_doubled = S::int(2) * u3;
    // Values.
    // g
    let g_value = g;
    // u3
    let u3_value = u3;
    // p_q4 = u1*sin(q1)*cos(q2) - u2*cos(q1)*tan(q2) + u4
    let p_q4_value = u1_c2.mul_add(s1, u4) - u2_c2_inv * s2_c1;
    // p_q5 = u5 - u1*cos(q1)*cos(q2) - u2*sin(q1)*tan(q2)
    let p_q5_value = (-u1_c2).mul_add(c1, u5) - u2_c2_inv * s2_s1;
    // H_a3_there_scaled = 2*u3*(1 - sin(q2)) - u2*cos(q2)
    let H_a3_there_scaled_value = u3_doubled * (S::int(1) - s2) - u2 * c2;
    // centre_q4 = q4 - sin(q1)*sin(q2)
    let centre_q4_value = q4 - s2_s1;
    // centre_q5 = cos(q1)*sin(q2) + q5
    let centre_q5_value = q5 + s2_c1;
    // u3_times_4 = 4*u3
    let u3_times_4_value = S::int(4) * u3;
    // g_times_4 = 4*g
    let g_times_4_value = S::int(4) * g;
    // u3_times_2 = 2*u3
    let u3_times_2_value = u3_doubled;
    [
        g_value, u3_value, p_q4_value, p_q5_value, H_a3_there_scaled_value, centre_q4_value,
        centre_q5_value, u3_times_4_value, g_times_4_value, u3_times_2_value,
    ]
}

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// 2 operations.
#[must_use]
pub fn start<S: Scalar>(
    _p: &super::super::super::Parameters<S>,
    q: &[S; 5],
    u: &[S; 5],
) -> ([S; 3], [S; 1]) {
    let [q1, q2, q3, _, _] = *q;
    let [u1, _, _, _, _] = *u;
    // Values.
    // q2_minus_90deg = q2 - pi/2
    let q2_minus_90deg_value = q2 - S::ratio(1, 2) * S::pi();
    // q3
    let q3_value = q3;
    // q1
    let q1_value = q1;
    // u1
    let u1_value = u1;
    ([q2_minus_90deg_value, q3_value, q1_value], [u1_value])
}

/// The accelerations (u1'), solved for when this code was generated.
///
/// 19 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [S; 1] {
    let Parameters { H_a3_there_scaled, u3_times_4, g_times_4, u3_times_2, .. } = *p;
    let [q2_minus_90deg, _, _] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    let (sin_q2_minus_90deg_by_2, _) = (S::ratio(1, 2) * q2_minus_90deg).sin_cos();
    // u2 = (H_a3_there_scaled - u3_times_4*sin(q2_minus_90deg/2)^2)/sin(q2_minus_90deg)
    let u2 = sin_q2_minus_90deg_inv
        * (H_a3_there_scaled - u3_times_4 * sin_q2_minus_90deg_by_2 * sin_q2_minus_90deg_by_2);
    let u1_dot_of_place = S::int(4) * sin_q2_minus_90deg;
    // u1' = (cos(q2_minus_90deg)*(4*u1^2*sin(q2_minus_90deg) + u2^2/sin(q2_minus_90deg) + g_times_4) +
    //   u2*u3_times_2)/(4*sin(q2_minus_90deg)^2 - 5)
    let u1_dot = (cos_q2_minus_90deg
        * (g_times_4 + u2 * u2 * sin_q2_minus_90deg_inv + u1 * u1 * u1_dot_of_place)
        + u2 * u3_times_2) / u1_dot_of_place.mul_add(sin_q2_minus_90deg, -S::int(5));
    [u1_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 11 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [S; 3] {
    let Parameters { u3, H_a3_there_scaled, u3_times_4, .. } = *p;
    let [q2_minus_90deg, _, _] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    let (sin_q2_minus_90deg_by_2, _) = (S::ratio(1, 2) * q2_minus_90deg).sin_cos();
    // u2 = (H_a3_there_scaled - u3_times_4*sin(q2_minus_90deg/2)^2)/sin(q2_minus_90deg)
    let u2 = sin_q2_minus_90deg_inv
        * (H_a3_there_scaled - u3_times_4 * sin_q2_minus_90deg_by_2 * sin_q2_minus_90deg_by_2);
    let q3_dot_value_of_place = u2 * sin_q2_minus_90deg_inv;
    // Values.
    // q2_minus_90deg' = -u1
    let q2_minus_90deg_dot_value = -u1;
    // q3' = u3 + u2/tan(q2_minus_90deg)
    let q3_dot_value = q3_dot_value_of_place.mul_add(cos_q2_minus_90deg, u3);
    // q1' = -u2/sin(q2_minus_90deg)
    let q1_dot_value = -q3_dot_value_of_place;
    [q2_minus_90deg_dot_value, q3_dot_value, q1_dot_value]
}

/// Kinetic energy T.
///
/// 6 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn kinetic_energy<S: Scalar>(_p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> S {
    let [q2_minus_90deg, _, _] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, _) = q2_minus_90deg.sin_cos();
    // Values.
    // T = u1^2*(5 - 4*sin(q2_minus_90deg)^2)/8
    let energy = S::ratio(1, 8) * u1 * u1
        * (S::int(5) - S::int(4) * sin_q2_minus_90deg * sin_q2_minus_90deg);
    energy
}

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// 18 operations, 2 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3]) -> S {
    let Parameters { g, u3, p_q4, p_q5, H_a3_there_scaled, u3_times_4, .. } = *p;
    let [q2_minus_90deg, _, _] = *q;
    // Sines and cosines.
    let (sin_q2_minus_90deg, _) = q2_minus_90deg.sin_cos();
    let (sin_q2_minus_90deg_by_2, _) = (S::ratio(1, 2) * q2_minus_90deg).sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u2 = (H_a3_there_scaled - u3_times_4*sin(q2_minus_90deg/2)^2)/sin(q2_minus_90deg)
    let u2 = (H_a3_there_scaled - u3_times_4 * sin_q2_minus_90deg_by_2 * sin_q2_minus_90deg_by_2)
        / sin_q2_minus_90deg;
    // p_q4^2 + p_q5^2
    let p_q4_sq_plus_p_q5_sq = p_q5.mul_add(p_q5, p_q4 * p_q4);
    // Values.
    // V = u2^2/8 + u3^2/4 - g*(1 + sin(q2_minus_90deg)) + p_q4^2/2 + p_q5^2/2
    let energy = S::ratio(1, 8) * u2 * u2 + S::ratio(1, 4) * u3 * u3
        - g * (S::int(1) + sin_q2_minus_90deg) + S::ratio(1, 2) * p_q4_sq_plus_p_q5_sq;
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 26 operations, 3 sines and cosines.
#[must_use]
pub fn outputs<S: Scalar>(p: &Parameters<S>, t: S, q: &[S; 3], u: &[S; 1]) -> [S; 10] {
    let Parameters {
        u3, p_q4, p_q5, H_a3_there_scaled, centre_q4, centre_q5, u3_times_4,
        ..
    } = *p;
    let [q2_minus_90deg, q3, q1] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    let (sin_q2_minus_90deg_by_2, _) = (S::ratio(1, 2) * q2_minus_90deg).sin_cos();
    // u2 = (H_a3_there_scaled - u3_times_4*sin(q2_minus_90deg/2)^2)/sin(q2_minus_90deg)
    let u2 = sin_q2_minus_90deg_inv
        * (H_a3_there_scaled - u3_times_4 * sin_q2_minus_90deg_by_2 * sin_q2_minus_90deg_by_2);
    let u1_sin_q2_minus_90deg = u1 * sin_q2_minus_90deg;
    let u5_of_place = u2 * sin_q2_minus_90deg_inv;
    let s1_cos_q2_minus_90deg = s1 * cos_q2_minus_90deg;
    // u5 = p_q5 - u1*cos(q1)*sin(q2_minus_90deg) - u2*sin(q1)/tan(q2_minus_90deg)
    let u5 = (-u1_sin_q2_minus_90deg).mul_add(c1, p_q5) - u5_of_place * s1_cos_q2_minus_90deg;
    let c1_cos_q2_minus_90deg = c1 * cos_q2_minus_90deg;
    // u4 = u1*sin(q1)*sin(q2_minus_90deg) - u2*cos(q1)/tan(q2_minus_90deg) + p_q4
    let u4 = u1_sin_q2_minus_90deg.mul_add(s1, p_q4) - u5_of_place * c1_cos_q2_minus_90deg;
    // Values.
    // q1
    let q1_value = q1;
    // q2 = pi/2 + q2_minus_90deg
    let q2_value = S::ratio(1, 2) * S::pi() + q2_minus_90deg;
    // q3
    let q3_value = q3;
    // q4 = sin(q1)*cos(q2_minus_90deg) + p_q4*t + centre_q4
    let q4_value = p_q4.mul_add(t, centre_q4) + s1_cos_q2_minus_90deg;
    // q5 = p_q5*t - cos(q1)*cos(q2_minus_90deg) + centre_q5
    let q5_value = p_q5.mul_add(t, centre_q5) - c1_cos_q2_minus_90deg;
    // u1
    let u1_value = u1;
    // u3
    let u3_value = u3;
    [q1_value, q2_value, q3_value, q4_value, q5_value, u1_value, u2, u3_value, u4, u5]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 23 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 1],
) -> ([S; 3], [S; 1]) {
    let Parameters { u3, H_a3_there_scaled, u3_times_4, g_times_4, u3_times_2, .. } = *p;
    let [q2_minus_90deg, _, _] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    let (sin_q2_minus_90deg_by_2, _) = (S::ratio(1, 2) * q2_minus_90deg).sin_cos();
    // u2 = (H_a3_there_scaled - u3_times_4*sin(q2_minus_90deg/2)^2)/sin(q2_minus_90deg)
    let u2 = sin_q2_minus_90deg_inv
        * (H_a3_there_scaled - u3_times_4 * sin_q2_minus_90deg_by_2 * sin_q2_minus_90deg_by_2);
    let u1_dot_of_place = u2 * sin_q2_minus_90deg_inv;
    let u1_dot_of_place_2 = S::int(4) * sin_q2_minus_90deg;
    // u1' = (cos(q2_minus_90deg)*(4*u1^2*sin(q2_minus_90deg) + u2^2/sin(q2_minus_90deg) + g_times_4) +
    //   u2*u3_times_2)/(4*sin(q2_minus_90deg)^2 - 5)
    let u1_dot = (cos_q2_minus_90deg
        * (u2.mul_add(u1_dot_of_place, g_times_4) + u1 * u1 * u1_dot_of_place_2)
        + u2 * u3_times_2) / u1_dot_of_place_2.mul_add(sin_q2_minus_90deg, -S::int(5));
    // Values.
    // q2_minus_90deg' = -u1
    let q2_minus_90deg_dot_value = -u1;
    // q3' = u3 + u2/tan(q2_minus_90deg)
    let q3_dot_value = u1_dot_of_place.mul_add(cos_q2_minus_90deg, u3);
    // q1' = -u2/sin(q2_minus_90deg)
    let q1_dot_value = -u1_dot_of_place;
    ([q2_minus_90deg_dot_value, q3_dot_value, q1_dot_value], [u1_dot])
}

/// Jacobian of the derivative by the state; columns q2_minus_90deg, q3, q1, u1.
///
/// 56 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [[S; 4]; 4] {
    let Parameters { H_a3_there_scaled, u3_times_4, g_times_4, u3_times_2, .. } = *p;
    let [q2_minus_90deg, _, _] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let q2_minus_90deg_halved = S::ratio(1, 2) * q2_minus_90deg;
    let (sin_q2_minus_90deg_by_2, cos_q2_minus_90deg_by_2) = q2_minus_90deg_halved
        .sin_cos();
    let u2_of_place = sin_q2_minus_90deg_by_2 * sin_q2_minus_90deg_by_2;
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    // u2 = (H_a3_there_scaled - u3_times_4*sin(q2_minus_90deg/2)^2)/sin(q2_minus_90deg)
    let u2 = sin_q2_minus_90deg_inv * (-u3_times_4).mul_add(u2_of_place, H_a3_there_scaled);
    let u2_by_q2_minus_90deg_of_place = S::int(1)
        / (sin_q2_minus_90deg_by_2 * cos_q2_minus_90deg_by_2);
    // u2_by_q2_minus_90deg = -(H_a3_there_scaled + sin(q2_minus_90deg/2)^2*(u3_times_4 -
    //   2*H_a3_there_scaled))/(4*sin(q2_minus_90deg/2)^2*cos(q2_minus_90deg/2)^2)
    let u2_by_q2_minus_90deg = -S::ratio(1, 4) * u2_by_q2_minus_90deg_of_place
        * u2_by_q2_minus_90deg_of_place
        * (H_a3_there_scaled + u2_of_place * (-H_a3_there_scaled).mul_add(S::int(2), u3_times_4));
    let u1_dot_by_q2_minus_90deg_of_place = S::int(4) * sin_q2_minus_90deg;
    // 1/(u1_dot_by_q2_minus_90deg_of_place*sin(q2_minus_90deg) - 5)
    let u1_dot_by_q2_minus_90deg_of_place_2 = S::int(1)
        / u1_dot_by_q2_minus_90deg_of_place.mul_add(sin_q2_minus_90deg, -S::int(5));
    let u1_dot_by_q2_minus_90deg_of_place_3 = u2 * sin_q2_minus_90deg_inv;
    let u1_sq = u1 * u1;
    // u2^2 + sin(q2_minus_90deg)*(g_times_4 + u1_dot_by_q2_minus_90deg_of_place*u1_sq)
    let u1_dot_by_q2_minus_90deg_of_u1 = sin_q2_minus_90deg
        * u1_dot_by_q2_minus_90deg_of_place.mul_add(u1_sq, g_times_4) + u2 * u2;
    let u1_dot_by_q2_minus_90deg_of_place_4 = S::int(8) * u1_dot_by_q2_minus_90deg_of_place_2;
    // u1_dot_by_q2_minus_90deg = (u2^2 + sin(q2_minus_90deg)*(4*u1^2*sin(q2_minus_90deg) + g_times_4) -
    //   u3_times_2*u2_by_q2_minus_90deg - cos(q2_minus_90deg)*(cos(q2_minus_90deg)*(4*u1^2 -
    //   u2^2/sin(q2_minus_90deg)^2 + 8*(u2^2 + sin(q2_minus_90deg)*(4*u1^2*sin(q2_minus_90deg) +
    //   g_times_4))/(5 - 4*sin(q2_minus_90deg)^2)) + 2*u2*(4*u3_times_2*sin(q2_minus_90deg)/(5 -
    //   4*sin(q2_minus_90deg)^2) + u2_by_q2_minus_90deg/sin(q2_minus_90deg))))/(5 - 4*sin(q2_minus_90deg)^2)
    let u1_dot_by_q2_minus_90deg = u1_dot_by_q2_minus_90deg_of_place_2
        * (-u1_dot_by_q2_minus_90deg_of_u1 + u3_times_2 * u2_by_q2_minus_90deg
            + cos_q2_minus_90deg
                * (S::int(2) * u2
                    * (-(u3_times_2 * u1_dot_by_q2_minus_90deg_of_place))
                        .mul_add(
                            u1_dot_by_q2_minus_90deg_of_place_2,
                            u2_by_q2_minus_90deg * sin_q2_minus_90deg_inv,
                        )
                    + cos_q2_minus_90deg
                        * ((-u1_dot_by_q2_minus_90deg_of_place_3)
                            .mul_add(
                                u1_dot_by_q2_minus_90deg_of_place_3,
                                S::int(4) * u1_sq,
                            )
                            - u1_dot_by_q2_minus_90deg_of_u1
                                * u1_dot_by_q2_minus_90deg_of_place_4)));
    // u1_dot_by_u1 = 8*u1*sin(q2_minus_90deg)*cos(q2_minus_90deg)/(4*sin(q2_minus_90deg)^2 - 5)
    let u1_dot_by_u1 = u1 * u1_dot_by_q2_minus_90deg_of_place_4 * sin_q2_minus_90deg
        * cos_q2_minus_90deg;
    // Entries that are not zero.
    // d(q2_minus_90deg')/d(u1) = -1
    let q2_minus_90deg_dot_by_u1_value = -S::int(1);
    // d(q3')/d(q2_minus_90deg) = (u2_by_q2_minus_90deg*cos(q2_minus_90deg) -
    //   u2/sin(q2_minus_90deg))/sin(q2_minus_90deg)
    let q3_dot_by_q2_minus_90deg_value = sin_q2_minus_90deg_inv
        * u2_by_q2_minus_90deg
            .mul_add(cos_q2_minus_90deg, -u1_dot_by_q2_minus_90deg_of_place_3);
    // d(q1')/d(q2_minus_90deg) = (u2/tan(q2_minus_90deg) - u2_by_q2_minus_90deg)/sin(q2_minus_90deg)
    let q1_dot_by_q2_minus_90deg_value = sin_q2_minus_90deg_inv
        * u1_dot_by_q2_minus_90deg_of_place_3
            .mul_add(cos_q2_minus_90deg, -u2_by_q2_minus_90deg);
    let zero = S::int(0);
    [
        [zero, zero, zero, q2_minus_90deg_dot_by_u1_value],
        [q3_dot_by_q2_minus_90deg_value, zero, zero, zero],
        [q1_dot_by_q2_minus_90deg_value, zero, zero, zero],
        [u1_dot_by_q2_minus_90deg, zero, zero, u1_dot_by_u1],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 3], _u: &[S; 1]) -> [S; 1] {
    let [q2_minus_90deg, _, _] = *q;
    // Sines and cosines.
    let (sin_q2_minus_90deg, _) = q2_minus_90deg.sin_cos();
    // Values.
    // divisor1 = sin(q2_minus_90deg)
    let divisor1 = sin_q2_minus_90deg;
    [divisor1]
}

/// The energy, then its derivatives by the state.
///
/// 39 operations, 2 sines and cosines.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [S; 5] {
    let Parameters { g, u3, p_q4, p_q5, H_a3_there_scaled, u3_times_4, .. } = *p;
    let [q2_minus_90deg, _, _] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let q2_minus_90deg_halved = S::ratio(1, 2) * q2_minus_90deg;
    let (sin_q2_minus_90deg_by_2, cos_q2_minus_90deg_by_2) = q2_minus_90deg_halved
        .sin_cos();
    let u2_of_place = u3_times_4 * sin_q2_minus_90deg_by_2;
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    // u2 = (H_a3_there_scaled - u3_times_4*sin(q2_minus_90deg/2)^2)/sin(q2_minus_90deg)
    let u2 = sin_q2_minus_90deg_inv
        * (-u2_of_place).mul_add(sin_q2_minus_90deg_by_2, H_a3_there_scaled);
    // u1*(4*sin(q2_minus_90deg)^2 - 5)
    let energy_of_u1 = u1 * (S::int(4) * sin_q2_minus_90deg * sin_q2_minus_90deg - S::int(5));
    // p_q4^2 + p_q5^2
    let p_q4_sq_plus_p_q5_sq = p_q5.mul_add(p_q5, p_q4 * p_q4);
    // u2^2 - u1*energy_of_u1
    let energy_of_u1_2 = (-u1).mul_add(energy_of_u1, u2 * u2);
    // Values.
    // T + V = u2^2/8 + u3^2/4 - g*(1 + sin(q2_minus_90deg)) + u1^2*(5 - 4*sin(q2_minus_90deg)^2)/8 +
    //   p_q4^2/2 + p_q5^2/2
    let energy = S::ratio(1, 4) * u3 * u3 - g * (S::int(1) + sin_q2_minus_90deg)
        + S::ratio(1, 2) * p_q4_sq_plus_p_q5_sq + S::ratio(1, 8) * energy_of_u1_2;
    // d(T + V)/d(q2_minus_90deg) = -g*cos(q2_minus_90deg) - u1^2*sin(q2_minus_90deg)*cos(q2_minus_90deg) -
    //   u2*(u3_times_4*sin(q2_minus_90deg/2)*cos(q2_minus_90deg/2)/sin(q2_minus_90deg) + (H_a3_there_scaled
    //   - u3_times_4*sin(q2_minus_90deg/2)^2)/(sin(q2_minus_90deg)*tan(q2_minus_90deg)))/4
    let energy_by_q2_minus_90deg = -cos_q2_minus_90deg * (g + u1 * u1 * sin_q2_minus_90deg)
        - S::ratio(1, 4) * u2 * sin_q2_minus_90deg_inv
            * u2_of_place.mul_add(cos_q2_minus_90deg_by_2, u2 * cos_q2_minus_90deg);
    // d(T + V)/d(u1) = u1*(5 - 4*sin(q2_minus_90deg)^2)/4
    let energy_by_u1 = -S::ratio(1, 4) * energy_of_u1;
    let zero = S::int(0);
    [energy, energy_by_q2_minus_90deg, zero, zero, energy_by_u1]
}

/// The angles z whose sin z/z the slope of the potential needs.
///
/// 6 operations.
#[must_use]
#[inline(always)]
pub fn half_differences<S: Scalar>(_p: &Parameters<S>, q: &[S; 2]) -> [S; 2] {
    let [q2_minus_90deg_from, q2_minus_90deg_to] = *q;
    // Values.
    // z1 = q2_minus_90deg_to/2 - q2_minus_90deg_from/2
    let z1 = S::ratio(1, 2) * q2_minus_90deg_to - S::ratio(1, 2) * q2_minus_90deg_from;
    // z2 = q2_minus_90deg_to/4 - q2_minus_90deg_from/4
    let z2 = S::ratio(1, 4) * q2_minus_90deg_to - S::ratio(1, 4) * q2_minus_90deg_from;
    [z1, z2]
}

/// The slope of the potential energy between two places `q`, without cancellation; `u` holds sin z/z.
///
/// 40 operations, 6 sines and cosines.
#[must_use]
#[inline(always)]
pub fn potential_slope<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> S {
    let Parameters { g, u3, H_a3_there_scaled, .. } = *p;
    let [q2_minus_90deg_from, q2_minus_90deg_to] = *q;
    let [sinc1, sinc2] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg_from, _) = q2_minus_90deg_from.sin_cos();
    let (sin_q2_minus_90deg_to, _) = q2_minus_90deg_to.sin_cos();
    let (_, cos_angle) = (S::ratio(1, 2) * q2_minus_90deg_from + S::ratio(1, 2) * q2_minus_90deg_to)
        .sin_cos();
    let (_, cos_angle_2) = (S::ratio(1, 4) * q2_minus_90deg_from
        + S::ratio(1, 4) * q2_minus_90deg_to)
        .sin_cos();
    let (sin_q2_minus_90deg_from_by_2, _) = (S::ratio(1, 2) * q2_minus_90deg_from)
        .sin_cos();
    let (sin_q2_minus_90deg_to_by_2, _) = (S::ratio(1, 2) * q2_minus_90deg_to).sin_cos();
    // Shared terms.
    let slope_of_place = u3 * sin_q2_minus_90deg_to_by_2 * sin_q2_minus_90deg_to_by_2;
    // Values.
    // (V(b) - V(a))/(b - a) = u3*sinc2*cos(q2_minus_90deg_from/4 +
    //   q2_minus_90deg_to/4)*(sin(q2_minus_90deg_from/2) +
    //   sin(q2_minus_90deg_to/2))*(2*u3*sin(q2_minus_90deg_from/2)^2 - H_a3_there_scaled +
    //   2*u3*sin(q2_minus_90deg_to/2)^2)/(2*sin(q2_minus_90deg_from)^2) - g*sinc1*cos(q2_minus_90deg_from/2
    //   + q2_minus_90deg_to/2) - sinc1*cos(q2_minus_90deg_from/2 +
    //   q2_minus_90deg_to/2)*(sin(q2_minus_90deg_from) + sin(q2_minus_90deg_to))*(H_a3_there_scaled -
    //   4*u3*sin(q2_minus_90deg_to/2)^2)^2/(8*sin(q2_minus_90deg_from)^2*sin(q2_minus_90deg_to)^2)
    let slope = S::ratio(1, 2) * u3 * sinc2 * cos_angle_2
        * (sin_q2_minus_90deg_from_by_2 + sin_q2_minus_90deg_to_by_2)
        * slope_of_place
            .mul_add(
                S::int(2),
                S::int(2) * u3 * sin_q2_minus_90deg_from_by_2
                    * sin_q2_minus_90deg_from_by_2 - H_a3_there_scaled,
            ) / (sin_q2_minus_90deg_from * sin_q2_minus_90deg_from) - g * sinc1 * cos_angle
        - S::ratio(1, 8) * sinc1 * cos_angle * (sin_q2_minus_90deg_from + sin_q2_minus_90deg_to)
            * (-slope_of_place).mul_add(S::int(4), H_a3_there_scaled).powi(2)
            / (sin_q2_minus_90deg_from * sin_q2_minus_90deg_from * sin_q2_minus_90deg_to
                * sin_q2_minus_90deg_to);
    slope
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 14 convolutions and 16 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 4]],
    history: &mut [Factors<S, 16>],
) {
    let Parameters { u3, H_a3_there_scaled, u3_times_4, g_times_4, u3_times_2, .. } = *p;
    let [q2_minus_90deg_0, _, _, u1_0] = series[0];
    // Constant in time.
    // minus_u3_times_4 = -u3_times_4
    let minus_u3_times_4 = -u3_times_4;
    // Order 0.
    let (sin_q2_minus_90deg_0, cos_q2_minus_90deg_0) = q2_minus_90deg_0.sin_cos();
    let over_sin_q2_minus_90deg = S::int(1) / sin_q2_minus_90deg_0;
    let q2_minus_90deg_halved_0 = S::ratio(1, 2) * q2_minus_90deg_0;
    let (sin_q2_minus_90deg_by_2_0, cos_q2_minus_90deg_by_2_0) = q2_minus_90deg_halved_0
        .sin_cos();
    let u2_of_place_0 = sin_q2_minus_90deg_by_2_0 * sin_q2_minus_90deg_by_2_0;
    let u2_of_place_2_0 = u2_of_place_0.mul_add(minus_u3_times_4, H_a3_there_scaled);
    let u2_of_place_3_0 = u2_of_place_2_0 * over_sin_q2_minus_90deg;
    let u1_sq_0 = u1_0 * u1_0;
    let u1_sq_sin_q2_minus_90deg_0 = sin_q2_minus_90deg_0 * u1_sq_0;
    let u1_dot_of_place_0 = u2_of_place_3_0 * over_sin_q2_minus_90deg;
    let u1_dot_of_place_2_0 = u2_of_place_3_0 * u1_dot_of_place_0;
    let sin_q2_minus_90deg_sq_0 = sin_q2_minus_90deg_0 * sin_q2_minus_90deg_0;
    let u1_dot_of_place_3_0 = sin_q2_minus_90deg_sq_0.mul_add(S::int(4), -S::int(5));
    let over_u1_dot_of_place_3 = S::int(1) / u1_dot_of_place_3_0;
    let u1_dot_of_u1_0 = u1_sq_sin_q2_minus_90deg_0.mul_add(S::int(4), g_times_4)
        + u1_dot_of_place_2_0;
    let u1_dot_of_u1_2_0 = cos_q2_minus_90deg_0 * u1_dot_of_u1_0;
    let u1_dot_of_u1_3_0 = u3_times_2 * u2_of_place_3_0 + u1_dot_of_u1_2_0;
    let u1_dot_2_0 = u1_dot_of_u1_3_0 * over_u1_dot_of_place_3;
    let q3_of_place_0 = cos_q2_minus_90deg_0 * u1_dot_of_place_0;
    let q3_dot_2_0 = u3 + q3_of_place_0;
    // Order 1: the rates, and what follows from them.
    let q2_minus_90deg_1 = -u1_0;
    let q3_1 = q3_dot_2_0;
    let q1_1 = -u1_dot_of_place_0;
    let u1_1 = u1_dot_2_0;
    if series.len() > 1 {
        series[1] = [q2_minus_90deg_1, q3_1, q1_1, u1_1];
    }
    let sin_q2_minus_90deg_1 = q2_minus_90deg_1 * cos_q2_minus_90deg_0;
    let cos_q2_minus_90deg_1 = -q2_minus_90deg_1 * sin_q2_minus_90deg_0;
    let q2_minus_90deg_halved_1 = S::ratio(1, 2) * q2_minus_90deg_1;
    let sin_q2_minus_90deg_by_2_1 = q2_minus_90deg_halved_1 * cos_q2_minus_90deg_by_2_0;
    let cos_q2_minus_90deg_by_2_1 = -q2_minus_90deg_halved_1 * sin_q2_minus_90deg_by_2_0;
    let u2_of_place_1 = sin_q2_minus_90deg_by_2_1
        * (sin_q2_minus_90deg_by_2_0 + sin_q2_minus_90deg_by_2_0);
    let u2_of_place_2_1 = minus_u3_times_4 * u2_of_place_1;
    let u2_of_place_3_1 = sin_q2_minus_90deg_1
        .mul_add(
            -(u2_of_place_3_0 * over_sin_q2_minus_90deg),
            u2_of_place_2_1 * over_sin_q2_minus_90deg,
        );
    let u1_sq_1 = u1_1 * (u1_0 + u1_0);
    let u1_sq_sin_q2_minus_90deg_1 = u1_sq_1
        .mul_add(sin_q2_minus_90deg_0, sin_q2_minus_90deg_1 * u1_sq_0);
    let u1_dot_of_place_1 = sin_q2_minus_90deg_1
        .mul_add(
            -(u1_dot_of_place_0 * over_sin_q2_minus_90deg),
            u2_of_place_3_1 * over_sin_q2_minus_90deg,
        );
    let u1_dot_of_place_2_1 = u1_dot_of_place_1
        .mul_add(u2_of_place_3_0, u2_of_place_3_1 * u1_dot_of_place_0);
    let sin_q2_minus_90deg_sq_1 = sin_q2_minus_90deg_1
        * (sin_q2_minus_90deg_0 + sin_q2_minus_90deg_0);
    let u1_dot_of_place_3_1 = S::int(4) * sin_q2_minus_90deg_sq_1;
    let u1_dot_of_u1_1 = S::int(4) * u1_sq_sin_q2_minus_90deg_1 + u1_dot_of_place_2_1;
    let u1_dot_of_u1_2_1 = u1_dot_of_u1_1
        .mul_add(cos_q2_minus_90deg_0, cos_q2_minus_90deg_1 * u1_dot_of_u1_0);
    let u1_dot_of_u1_3_1 = u3_times_2 * u2_of_place_3_1 + u1_dot_of_u1_2_1;
    let u1_dot_2_1 = u1_dot_of_place_3_1
        .mul_add(
            -(u1_dot_2_0 * over_u1_dot_of_place_3),
            u1_dot_of_u1_3_1 * over_u1_dot_of_place_3,
        );
    let q3_of_place_1 = u1_dot_of_place_1
        .mul_add(cos_q2_minus_90deg_0, cos_q2_minus_90deg_1 * u1_dot_of_place_0);
    let q3_dot_2_1 = q3_of_place_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                q2_minus_90deg_1, q2_minus_90deg_1, q2_minus_90deg_halved_1,
                q2_minus_90deg_halved_1, sin_q2_minus_90deg_by_2_1, sin_q2_minus_90deg_1, u1_1,
                sin_q2_minus_90deg_1, sin_q2_minus_90deg_1, u2_of_place_3_1, sin_q2_minus_90deg_1,
                cos_q2_minus_90deg_1, u1_dot_of_place_3_1, cos_q2_minus_90deg_1,
            ]),
            padded([
                cos_q2_minus_90deg_1, sin_q2_minus_90deg_1, cos_q2_minus_90deg_by_2_1,
                sin_q2_minus_90deg_by_2_1, sin_q2_minus_90deg_by_2_1, u2_of_place_3_1, u1_1,
                u1_sq_1, u1_dot_of_place_1, u1_dot_of_place_1, sin_q2_minus_90deg_1, u1_dot_of_u1_1,
                u1_dot_2_1, u1_dot_of_place_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q2_minus_90deg_last = q2_minus_90deg_1;
    let mut u1_last = u1_1;
    let mut sin_q2_minus_90deg_last = sin_q2_minus_90deg_1;
    let mut cos_q2_minus_90deg_last = cos_q2_minus_90deg_1;
    let mut q2_minus_90deg_halved_last = q2_minus_90deg_halved_1;
    let mut sin_q2_minus_90deg_by_2_last = sin_q2_minus_90deg_by_2_1;
    let mut cos_q2_minus_90deg_by_2_last = cos_q2_minus_90deg_by_2_1;
    let mut u2_of_place_3_last = u2_of_place_3_1;
    let mut u1_sq_last = u1_sq_1;
    let mut u1_dot_of_place_last = u1_dot_of_place_1;
    let mut u1_dot_of_place_3_last = u1_dot_of_place_3_1;
    let mut u1_dot_of_u1_last = u1_dot_of_u1_1;
    let mut u1_dot_2_last = u1_dot_2_1;
    let mut next = [S::int(0); 16];
    // Rates at order k - 1.
    let mut q2_minus_90deg_rate = -u1_1;
    let mut q3_rate = q3_dot_2_1;
    let mut q1_rate = -u1_dot_of_place_1;
    let mut u1_rate = u1_dot_2_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q2_minus_90deg = q2_minus_90deg_rate * over_k;
        let q3 = q3_rate * over_k;
        let q1 = q1_rate * over_k;
        let u1 = u1_rate * over_k;
        series[order] = [q2_minus_90deg, q3, q1, u1];
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
                q2_minus_90deg_1
                    .mul_add(
                        cos_q2_minus_90deg_last,
                        (count_last * q2_minus_90deg_last)
                            .mul_add(cos_q2_minus_90deg_1, next[0]),
                    ),
                q2_minus_90deg_1
                    .mul_add(
                        sin_q2_minus_90deg_last,
                        (count_last * q2_minus_90deg_last)
                            .mul_add(sin_q2_minus_90deg_1, next[1]),
                    ),
                q2_minus_90deg_halved_1
                    .mul_add(
                        cos_q2_minus_90deg_by_2_last,
                        (count_last * q2_minus_90deg_halved_last)
                            .mul_add(cos_q2_minus_90deg_by_2_1, next[2]),
                    ),
                q2_minus_90deg_halved_1
                    .mul_add(
                        sin_q2_minus_90deg_by_2_last,
                        (count_last * q2_minus_90deg_halved_last)
                            .mul_add(sin_q2_minus_90deg_by_2_1, next[3]),
                    ),
                (sin_q2_minus_90deg_by_2_1 + sin_q2_minus_90deg_by_2_1)
                    .mul_add(sin_q2_minus_90deg_by_2_last, next[4]),
                sin_q2_minus_90deg_1
                    .mul_add(
                        u2_of_place_3_last,
                        sin_q2_minus_90deg_last.mul_add(u2_of_place_3_1, next[5]),
                    ),
                (u1_1 + u1_1).mul_add(u1_last, next[6]),
                sin_q2_minus_90deg_1
                    .mul_add(
                        u1_sq_last,
                        sin_q2_minus_90deg_last.mul_add(u1_sq_1, next[7]),
                    ),
                sin_q2_minus_90deg_1
                    .mul_add(
                        u1_dot_of_place_last,
                        sin_q2_minus_90deg_last.mul_add(u1_dot_of_place_1, next[8]),
                    ),
                u2_of_place_3_1
                    .mul_add(
                        u1_dot_of_place_last,
                        u2_of_place_3_last.mul_add(u1_dot_of_place_1, next[9]),
                    ),
                (sin_q2_minus_90deg_1 + sin_q2_minus_90deg_1)
                    .mul_add(sin_q2_minus_90deg_last, next[10]),
                cos_q2_minus_90deg_1
                    .mul_add(
                        u1_dot_of_u1_last,
                        cos_q2_minus_90deg_last.mul_add(u1_dot_of_u1_1, next[11]),
                    ),
                u1_dot_of_place_3_1
                    .mul_add(
                        u1_dot_2_last,
                        u1_dot_of_place_3_last.mul_add(u1_dot_2_1, next[12]),
                    ),
                cos_q2_minus_90deg_1
                    .mul_add(
                        u1_dot_of_place_last,
                        cos_q2_minus_90deg_last.mul_add(u1_dot_of_place_1, next[13]),
                    ),
            ])
        };
        // sin_q2_minus_90deg = sin(q2_minus_90deg)
        let sin_q2_minus_90deg = q2_minus_90deg
            .mul_add(cos_q2_minus_90deg_0, sums[0] * over_k);
        // cos_q2_minus_90deg = cos(q2_minus_90deg)
        let cos_q2_minus_90deg = -q2_minus_90deg
            .mul_add(sin_q2_minus_90deg_0, sums[1] * over_k);
        // q2_minus_90deg_halved = 1/2*q2_minus_90deg
        let q2_minus_90deg_halved = S::ratio(1, 2) * q2_minus_90deg;
        // sin_q2_minus_90deg_by_2 = sin(q2_minus_90deg_halved)
        let sin_q2_minus_90deg_by_2 = q2_minus_90deg_halved
            .mul_add(cos_q2_minus_90deg_by_2_0, sums[2] * over_k);
        // cos_q2_minus_90deg_by_2 = cos(q2_minus_90deg_halved)
        let cos_q2_minus_90deg_by_2 = -q2_minus_90deg_halved
            .mul_add(sin_q2_minus_90deg_by_2_0, sums[3] * over_k);
        // u2_of_place = sin_q2_minus_90deg_by_2*sin_q2_minus_90deg_by_2
        let u2_of_place = sin_q2_minus_90deg_by_2
            .mul_add(sin_q2_minus_90deg_by_2_0 + sin_q2_minus_90deg_by_2_0, sums[4]);
        // u2_of_place_2 = H_a3_there_scaled + minus_u3_times_4*u2_of_place
        let u2_of_place_2 = minus_u3_times_4 * u2_of_place;
        // u2_of_place_3 = u2_of_place_2/sin_q2_minus_90deg
        let u2_of_place_3 = u2_of_place_2
            .mul_add(
                over_sin_q2_minus_90deg,
                -(sin_q2_minus_90deg.mul_add(u2_of_place_3_0, sums[5]) * over_sin_q2_minus_90deg),
            );
        // u1_sq = u1*u1
        let u1_sq = u1.mul_add(u1_0 + u1_0, sums[6]);
        // u1_sq_sin_q2_minus_90deg = sin_q2_minus_90deg*u1_sq
        let u1_sq_sin_q2_minus_90deg = u1_sq
            .mul_add(sin_q2_minus_90deg_0, sin_q2_minus_90deg.mul_add(u1_sq_0, sums[7]));
        // u1_dot_of_place = u2_of_place_3/sin_q2_minus_90deg
        let u1_dot_of_place = u2_of_place_3
            .mul_add(
                over_sin_q2_minus_90deg,
                -(sin_q2_minus_90deg.mul_add(u1_dot_of_place_0, sums[8]) * over_sin_q2_minus_90deg),
            );
        // u1_dot_of_place_2 = u2_of_place_3*u1_dot_of_place
        let u1_dot_of_place_2 = u1_dot_of_place
            .mul_add(u2_of_place_3_0, u2_of_place_3.mul_add(u1_dot_of_place_0, sums[9]));
        // sin_q2_minus_90deg_sq = sin_q2_minus_90deg*sin_q2_minus_90deg
        let sin_q2_minus_90deg_sq = sin_q2_minus_90deg
            .mul_add(sin_q2_minus_90deg_0 + sin_q2_minus_90deg_0, sums[10]);
        // u1_dot_of_place_3 = -5 + 4*sin_q2_minus_90deg_sq
        let u1_dot_of_place_3 = S::int(4) * sin_q2_minus_90deg_sq;
        // u1_dot_of_u1 = g_times_4 + 4*u1_sq_sin_q2_minus_90deg + u1_dot_of_place_2
        let u1_dot_of_u1 = S::int(4) * u1_sq_sin_q2_minus_90deg + u1_dot_of_place_2;
        // u1_dot_of_u1_2 = cos_q2_minus_90deg*u1_dot_of_u1
        let u1_dot_of_u1_2 = u1_dot_of_u1
            .mul_add(
                cos_q2_minus_90deg_0,
                cos_q2_minus_90deg.mul_add(u1_dot_of_u1_0, sums[11]),
            );
        // u1_dot_of_u1_3 = u1_dot_of_u1_2 + u3_times_2*u2_of_place_3
        let u1_dot_of_u1_3 = u3_times_2 * u2_of_place_3 + u1_dot_of_u1_2;
        // u1_dot_2 = u1_dot_of_u1_3/u1_dot_of_place_3
        let u1_dot_2 = u1_dot_of_u1_3
            .mul_add(
                over_u1_dot_of_place_3,
                -(u1_dot_of_place_3.mul_add(u1_dot_2_0, sums[12]) * over_u1_dot_of_place_3),
            );
        // q3_of_place = cos_q2_minus_90deg*u1_dot_of_place
        let q3_of_place = u1_dot_of_place
            .mul_add(
                cos_q2_minus_90deg_0,
                cos_q2_minus_90deg.mul_add(u1_dot_of_place_0, sums[13]),
            );
        // q3_dot_2 = u3 + q3_of_place
        let q3_dot_2 = q3_of_place;
        q2_minus_90deg_rate = -u1;
        q3_rate = q3_dot_2;
        q1_rate = -u1_dot_of_place;
        u1_rate = u1_dot_2;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * q2_minus_90deg,
                count * q2_minus_90deg,
                count * q2_minus_90deg_halved,
                count * q2_minus_90deg_halved,
                sin_q2_minus_90deg_by_2, sin_q2_minus_90deg, u1, sin_q2_minus_90deg,
                sin_q2_minus_90deg, u2_of_place_3, sin_q2_minus_90deg, cos_q2_minus_90deg,
                u1_dot_of_place_3, cos_q2_minus_90deg,
            ]),
            padded([
                cos_q2_minus_90deg, sin_q2_minus_90deg, cos_q2_minus_90deg_by_2,
                sin_q2_minus_90deg_by_2, sin_q2_minus_90deg_by_2, u2_of_place_3, u1, u1_sq,
                u1_dot_of_place, u1_dot_of_place, sin_q2_minus_90deg, u1_dot_of_u1, u1_dot_2,
                u1_dot_of_place,
            ]),
        ];
        count_last = count;
        q2_minus_90deg_last = q2_minus_90deg;
        u1_last = u1;
        sin_q2_minus_90deg_last = sin_q2_minus_90deg;
        cos_q2_minus_90deg_last = cos_q2_minus_90deg;
        q2_minus_90deg_halved_last = q2_minus_90deg_halved;
        sin_q2_minus_90deg_by_2_last = sin_q2_minus_90deg_by_2;
        cos_q2_minus_90deg_by_2_last = cos_q2_minus_90deg_by_2;
        u2_of_place_3_last = u2_of_place_3;
        u1_sq_last = u1_sq;
        u1_dot_of_place_last = u1_dot_of_place;
        u1_dot_of_place_3_last = u1_dot_of_place_3;
        u1_dot_of_u1_last = u1_dot_of_u1;
        u1_dot_2_last = u1_dot_2;
    }
}

/// Reduced equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Reduced;

impl<S: Scalar> System<S> for Reduced {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 10,
            coordinates: 3,
            variables: 1,
            speeds: 1,
            reactions: 0,
        }
    }
    fn symmetric(&self) -> bool {
        true
    }
    fn coordinate_rates(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        S::dispatch(
            #[inline(always)]
            || {
                out
                    .copy_from_slice(
                        &coordinate_rates(&Parameters::from_slice(p), array(q), array(v)),
                    )
            },
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
    fn has_potential_slope(&self) -> bool {
        true
    }
    fn potential_slope(&self, p: &[S], a: S, b: S) -> S {
        S::dispatch(
            #[inline(always)]
            || {
                let p = Parameters::from_slice(p);
                let mut sincs = half_differences(&p, &[a, b]);
                sincs.iter_mut().for_each(|z| *z = z.sinc());
                potential_slope(&p, &[a, b], &sincs)
            },
        )
    }
    fn coordinate_period(&self) -> Option<f64> {
        Some(2.0 * core::f64::consts::TAU)
    }
    fn at_points(&self) -> Option<AtPoints<'_>> {
        Some(AtPoints::of(&Derivative(Reduced)))
    }
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, order: usize) -> usize {
        32 * order + SLACK
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
        ["sin(q2_minus_90deg)"][at]
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
        S::dispatch(
            #[inline(always)]
            || kinetic_energy(&Parameters::from_slice(p), array(q), array(v)),
        )
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
    name: "flat-fall",
    key: "e4dd5b052b92b121",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: Some(
            InLanes::of_rates(&Derivative(Reduced)).with_series(&Derivative(Reduced)),
        ),
    },
};
