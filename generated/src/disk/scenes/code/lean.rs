//! Thin disk sliding on a frictionless plane: The lean alone, to t = 10 s.
//!
//! Generated from `models/disk/scenes/lean.toml`. Do not edit; run `tripos regenerate`.

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
    /// 4 times the angular momentum about a3 through the mass centre, kg*m^2/s
    pub H_a3_scaled: S,
    /// 2*u3, 1/s
    pub u3_times_2: S,
    /// 4*g, m/s^2
    pub g_times_4: S,
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
            g: p[0], u3: p[1], H_a3_scaled: p[2], u3_times_2: p[3], g_times_4: p[4],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 5] {
        let Self { g, u3, H_a3_scaled, u3_times_2, g_times_4, .. } = self;
        [g, u3, H_a3_scaled, u3_times_2, g_times_4]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 5] = ["g", "u3", "H_a3_scaled", "u3_times_2", "g_times_4"];

/// Names of the outputs.
pub const OUTPUTS: [&str; 2] = ["q2", "u1"];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    q: &[S; 5],
    u: &[S; 5],
) -> [S; 5] {
    let super::super::super::Parameters { g, .. } = *p;
    let [_, q2, _, _, _] = *q;
    let [_, u2, u3, _, _] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    let u3_doubled = S::int(2) * u3;
    // Values.
    // g
    let g_value = g;
    // u3
    let u3_value = u3;
    // H_a3_scaled = u2*cos(q2) + 2*u3*sin(q2)
    let H_a3_scaled_value = u3_doubled.mul_add(s2, u2 * c2);
    // u3_times_2 = 2*u3
    let u3_times_2_value = u3_doubled;
    // g_times_4 = 4*g
    let g_times_4_value = S::int(4) * g;
    [g_value, u3_value, H_a3_scaled_value, u3_times_2_value, g_times_4_value]
}

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// 0 operations.
#[must_use]
pub fn start<S: Scalar>(
    _p: &super::super::super::Parameters<S>,
    q: &[S; 5],
    u: &[S; 5],
) -> ([S; 1], [S; 1]) {
    let [_, q2, _, _, _] = *q;
    let [u1, _, _, _, _] = *u;
    // Values.
    // q2
    let q2_value = q2;
    // u1
    let u1_value = u1;
    ([q2_value], [u1_value])
}

/// The accelerations (u1'), solved for when this code was generated.
///
/// 17 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 1], u: &[S; 1]) -> [S; 1] {
    let Parameters { H_a3_scaled, u3_times_2, g_times_4, .. } = *p;
    let [q2] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let c2_inv = S::int(1) / c2;
    // u2 = (H_a3_scaled - u3_times_2*sin(q2))/cos(q2)
    let u2 = c2_inv * (-u3_times_2).mul_add(s2, H_a3_scaled);
    let c2_times_4 = S::int(4) * c2;
    // u1' = (sin(q2)*(4*u1^2*cos(q2) + u2^2/cos(q2) - g_times_4) - u2*u3_times_2)/(5 - 4*cos(q2)^2)
    let u1_dot = (s2 * (g_times_4 - u2 * u2 * c2_inv - u1 * u1 * c2_times_4)
        + u2 * u3_times_2) / c2_times_4.mul_add(c2, -S::int(5));
    [u1_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 1 operation.
#[must_use]
#[inline(always)]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 1],
    u: &[S; 1],
) -> [S; 1] {
    let [u1] = *u;
    // Values.
    // q2' = -u1
    let q2_dot_value = -u1;
    [q2_dot_value]
}

/// Kinetic energy T.
///
/// 6 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn kinetic_energy<S: Scalar>(_p: &Parameters<S>, q: &[S; 1], u: &[S; 1]) -> S {
    let [q2] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (_, c2) = q2.sin_cos();
    // Values.
    // T = u1^2*(5 - 4*cos(q2)^2)/8
    let energy = S::ratio(1, 8) * u1 * u1 * (S::int(5) - S::int(4) * c2 * c2);
    energy
}

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// 11 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 1]) -> S {
    let Parameters { g, u3, H_a3_scaled, u3_times_2, .. } = *p;
    let [q2] = *q;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u2 = (H_a3_scaled - u3_times_2*sin(q2))/cos(q2)
    let u2 = (-u3_times_2).mul_add(s2, H_a3_scaled) / c2;
    // Values.
    // V = g*(cos(q2) - 1) + u2^2/8 + u3^2/4
    let energy = g * (c2 - S::int(1)) + S::ratio(1, 8) * u2 * u2 + S::ratio(1, 4) * u3 * u3;
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 0 operations.
#[must_use]
pub fn outputs<S: Scalar>(_p: &Parameters<S>, _t: S, q: &[S; 1], u: &[S; 1]) -> [S; 2] {
    let [q2] = *q;
    let [u1] = *u;
    // Values.
    // q2
    let q2_value = q2;
    // u1
    let u1_value = u1;
    [q2_value, u1_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 18 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 1],
    u: &[S; 1],
) -> ([S; 1], [S; 1]) {
    let Parameters { H_a3_scaled, u3_times_2, g_times_4, .. } = *p;
    let [q2] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let c2_inv = S::int(1) / c2;
    // u2 = (H_a3_scaled - u3_times_2*sin(q2))/cos(q2)
    let u2 = c2_inv * (-u3_times_2).mul_add(s2, H_a3_scaled);
    let c2_times_4 = S::int(4) * c2;
    // u1' = (sin(q2)*(4*u1^2*cos(q2) + u2^2/cos(q2) - g_times_4) - u2*u3_times_2)/(5 - 4*cos(q2)^2)
    let u1_dot = (s2 * (g_times_4 - u2 * u2 * c2_inv - u1 * u1 * c2_times_4)
        + u2 * u3_times_2) / c2_times_4.mul_add(c2, -S::int(5));
    // Values.
    // q2' = -u1
    let q2_dot_value = -u1;
    ([q2_dot_value], [u1_dot])
}

/// Jacobian of the derivative by the state; columns q2, u1.
///
/// 42 operations, 1 sine and cosine.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 1], u: &[S; 1]) -> [[S; 2]; 2] {
    let Parameters { H_a3_scaled, u3_times_2, g_times_4, .. } = *p;
    let [q2] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let c2_inv = S::int(1) / c2;
    // u2 = (H_a3_scaled - u3_times_2*sin(q2))/cos(q2)
    let u2 = c2_inv * (-u3_times_2).mul_add(s2, H_a3_scaled);
    let c2_inv_sq = c2_inv * c2_inv;
    // u2_by_q2 = (H_a3_scaled*sin(q2) - u3_times_2)/cos(q2)^2
    let u2_by_q2 = c2_inv_sq * H_a3_scaled.mul_add(s2, -u3_times_2);
    let c2_times_4 = S::int(4) * c2;
    // 1/(c2_times_4*cos(q2) - 5)
    let u1_dot_by_q2_of_q2 = S::int(1) / c2_times_4.mul_add(c2, -S::int(5));
    let u1_sq = u1 * u1;
    let u2_sq = u2 * u2;
    // cos(q2)*(c2_times_4*u1_sq - g_times_4) + u2_sq
    let u1_dot_by_q2_of_u1 = c2 * c2_times_4.mul_add(u1_sq, -g_times_4) + u2_sq;
    let u1_dot_by_q2_of_q2_2 = S::int(8) * u1_dot_by_q2_of_q2;
    // u1_dot_by_q2 = (u2^2 + cos(q2)*(4*u1^2*cos(q2) - g_times_4) - u3_times_2*u2_by_q2 +
    //   sin(q2)*(2*u2*(4*u3_times_2*cos(q2)/(5 - 4*cos(q2)^2) + u2_by_q2/cos(q2)) - sin(q2)*(4*u1^2 -
    //   u2^2/cos(q2)^2 + 8*(u2^2 + cos(q2)*(4*u1^2*cos(q2) - g_times_4))/(5 - 4*cos(q2)^2))))/(5 -
    //   4*cos(q2)^2)
    let u1_dot_by_q2 = u1_dot_by_q2_of_q2
        * (-u1_dot_by_q2_of_u1 + u3_times_2 * u2_by_q2
            + s2
                * (S::int(2) * u2
                    * (-u2_by_q2)
                        .mul_add(c2_inv, u3_times_2 * c2_times_4 * u1_dot_by_q2_of_q2)
                    + s2
                        * ((-c2_inv_sq).mul_add(u2_sq, S::int(4) * u1_sq)
                            - u1_dot_by_q2_of_u1 * u1_dot_by_q2_of_q2_2)));
    // u1_dot_by_u1 = 8*u1*sin(q2)*cos(q2)/(5 - 4*cos(q2)^2)
    let u1_dot_by_u1 = -u1 * u1_dot_by_q2_of_q2_2 * s2 * c2;
    // Entries that are not zero.
    // d(q2')/d(u1) = -1
    let q2_dot_by_u1_value = -S::int(1);
    let zero = S::int(0);
    [[zero, q2_dot_by_u1_value], [u1_dot_by_q2, u1_dot_by_u1]]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 1], _u: &[S; 1]) -> [S; 1] {
    let [q2] = *q;
    // Sines and cosines.
    let (_, c2) = q2.sin_cos();
    // Values.
    // divisor1 = cos(q2)
    let divisor1 = c2;
    [divisor1]
}

/// The energy, then its derivatives by the state.
///
/// 30 operations, 1 sine and cosine.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 1], u: &[S; 1]) -> [S; 3] {
    let Parameters { g, u3, H_a3_scaled, u3_times_2, .. } = *p;
    let [q2] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let c2_inv = S::int(1) / c2;
    // u2 = (H_a3_scaled - u3_times_2*sin(q2))/cos(q2)
    let u2 = c2_inv * (-u3_times_2).mul_add(s2, H_a3_scaled);
    // u1*(4*cos(q2)^2 - 5)
    let energy_of_u1 = u1 * (S::int(4) * c2 * c2 - S::int(5));
    // u2^2 - u1*energy_of_u1
    let energy_of_u1_2 = (-u1).mul_add(energy_of_u1, u2 * u2);
    // Values.
    // T + V = g*(cos(q2) - 1) + u1^2*(5 - 4*cos(q2)^2)/8 + u2^2/8 + u3^2/4
    let energy = g * (c2 - S::int(1)) + S::ratio(1, 4) * u3 * u3 + S::ratio(1, 8) * energy_of_u1_2;
    // d(T + V)/d(q2) = u1^2*sin(q2)*cos(q2) - g*sin(q2) - u2*(u3_times_2 + tan(q2)*(u3_times_2*sin(q2) -
    //   H_a3_scaled)/cos(q2))/4
    let energy_by_q2 = s2 * (u1 * u1 * c2 - g)
        + S::ratio(1, 4) * u2 * (u2 * c2_inv).mul_add(s2, -u3_times_2);
    // d(T + V)/d(u1) = u1*(5 - 4*cos(q2)^2)/4
    let energy_by_u1 = -S::ratio(1, 4) * energy_of_u1;
    [energy, energy_by_q2, energy_by_u1]
}

/// The angles z whose sin z/z the slope of the potential needs.
///
/// 3 operations.
#[must_use]
#[inline(always)]
pub fn half_differences<S: Scalar>(_p: &Parameters<S>, q: &[S; 2]) -> [S; 1] {
    let [q2_from, q2_to] = *q;
    // Values.
    // z1 = q2_to/2 - q2_from/2
    let z1 = S::ratio(1, 2) * q2_to - S::ratio(1, 2) * q2_from;
    [z1]
}

/// The slope of the potential energy between two places `q`, without cancellation; `u` holds sin z/z.
///
/// 29 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn potential_slope<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> S {
    let Parameters { g, u3, H_a3_scaled, .. } = *p;
    let [q2_from, q2_to] = *q;
    let [sinc1] = *u;
    // Sines and cosines.
    let (sin_q2_from, cos_q2_from) = q2_from.sin_cos();
    let (sin_q2_to, cos_q2_to) = q2_to.sin_cos();
    // Shared terms.
    // q2_from/2 + q2_to/2
    let slope_of_place = S::ratio(1, 2) * q2_from + S::ratio(1, 2) * q2_to;
    let (sin_angle, cos_angle) = slope_of_place.sin_cos();
    let u3_sin_q2_to = u3 * sin_q2_to;
    // Values.
    // (V(b) - V(a))/(b - a) = sinc1*sin(q2_from/2 + q2_to/2)*(cos(q2_from) + cos(q2_to))*(H_a3_scaled -
    //   2*u3*sin(q2_to))^2/(8*cos(q2_from)^2*cos(q2_to)^2) - g*sinc1*sin(q2_from/2 + q2_to/2) +
    //   u3*sinc1*cos(q2_from/2 + q2_to/2)*(u3*sin(q2_from) - H_a3_scaled + u3*sin(q2_to))/(2*cos(q2_from)^2)
    let slope = S::ratio(1, 8) * sinc1 * sin_angle * (cos_q2_from + cos_q2_to)
        * (-u3_sin_q2_to).mul_add(S::int(2), H_a3_scaled).powi(2)
        / (cos_q2_from * cos_q2_from * cos_q2_to * cos_q2_to) - g * sinc1 * sin_angle
        + S::ratio(1, 2) * u3 * sinc1 * cos_angle
            * (u3.mul_add(sin_q2_from, -H_a3_scaled) + u3_sin_q2_to) / (cos_q2_from * cos_q2_from);
    slope
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 10 convolutions and 12 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 2]],
    history: &mut [Factors<S, 16>],
) {
    let Parameters { H_a3_scaled, u3_times_2, g_times_4, .. } = *p;
    let [q2_0, u1_0] = series[0];
    // Constant in time.
    // minus_u3_times_2 = -u3_times_2
    let minus_u3_times_2 = -u3_times_2;
    // minus_g_times_4 = -g_times_4
    let minus_g_times_4 = -g_times_4;
    // Order 0.
    let (s2_0, c2_0) = q2_0.sin_cos();
    let over_c2 = S::int(1) / c2_0;
    let u2_of_place_0 = s2_0.mul_add(minus_u3_times_2, H_a3_scaled);
    let u2_of_place_2_0 = u2_of_place_0 * over_c2;
    let c2_sq_0 = c2_0 * c2_0;
    let u1_sq_0 = u1_0 * u1_0;
    let u1_sq_c2_0 = c2_0 * u1_sq_0;
    let u1_dot_of_place_0 = u2_of_place_2_0 * over_c2;
    let u1_dot_of_place_2_0 = u2_of_place_2_0 * u1_dot_of_place_0;
    let u1_dot_of_q2_0 = c2_sq_0.mul_add(S::int(4), -S::int(5));
    let over_u1_dot_of_q2 = S::int(1) / u1_dot_of_q2_0;
    let u1_dot_of_u1_0 = u1_sq_c2_0.mul_add(S::int(4), minus_g_times_4) + u1_dot_of_place_2_0;
    let u1_dot_of_u1_2_0 = s2_0 * u1_dot_of_u1_0;
    let u1_dot_of_u1_3_0 = minus_u3_times_2 * u2_of_place_2_0 + u1_dot_of_u1_2_0;
    let u1_dot_of_u1_4_0 = u1_dot_of_u1_3_0 * over_u1_dot_of_q2;
    // Order 1: the rates, and what follows from them.
    let q2_1 = -u1_0;
    let u1_1 = -u1_dot_of_u1_4_0;
    if series.len() > 1 {
        series[1] = [q2_1, u1_1];
    }
    let s2_1 = q2_1 * c2_0;
    let c2_1 = -q2_1 * s2_0;
    let u2_of_place_1 = minus_u3_times_2 * s2_1;
    let u2_of_place_2_1 = c2_1
        .mul_add(-(u2_of_place_2_0 * over_c2), u2_of_place_1 * over_c2);
    let c2_sq_1 = c2_1 * (c2_0 + c2_0);
    let u1_sq_1 = u1_1 * (u1_0 + u1_0);
    let u1_sq_c2_1 = u1_sq_1.mul_add(c2_0, c2_1 * u1_sq_0);
    let u1_dot_of_place_1 = c2_1
        .mul_add(-(u1_dot_of_place_0 * over_c2), u2_of_place_2_1 * over_c2);
    let u1_dot_of_place_2_1 = u1_dot_of_place_1
        .mul_add(u2_of_place_2_0, u2_of_place_2_1 * u1_dot_of_place_0);
    let u1_dot_of_q2_1 = S::int(4) * c2_sq_1;
    let u1_dot_of_u1_1 = S::int(4) * u1_sq_c2_1 + u1_dot_of_place_2_1;
    let u1_dot_of_u1_2_1 = u1_dot_of_u1_1.mul_add(s2_0, s2_1 * u1_dot_of_u1_0);
    let u1_dot_of_u1_3_1 = minus_u3_times_2 * u2_of_place_2_1 + u1_dot_of_u1_2_1;
    let u1_dot_of_u1_4_1 = u1_dot_of_q2_1
        .mul_add(
            -(u1_dot_of_u1_4_0 * over_u1_dot_of_q2),
            u1_dot_of_u1_3_1 * over_u1_dot_of_q2,
        );
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                q2_1, q2_1, c2_1, c2_1, u1_1, c2_1, c2_1, u2_of_place_2_1, s2_1, u1_dot_of_q2_1,
            ]),
            padded([
                c2_1, s2_1, u2_of_place_2_1, c2_1, u1_1, u1_sq_1, u1_dot_of_place_1,
                u1_dot_of_place_1, u1_dot_of_u1_1, u1_dot_of_u1_4_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q2_last = q2_1;
    let mut u1_last = u1_1;
    let mut s2_last = s2_1;
    let mut c2_last = c2_1;
    let mut u2_of_place_2_last = u2_of_place_2_1;
    let mut u1_sq_last = u1_sq_1;
    let mut u1_dot_of_place_last = u1_dot_of_place_1;
    let mut u1_dot_of_q2_last = u1_dot_of_q2_1;
    let mut u1_dot_of_u1_last = u1_dot_of_u1_1;
    let mut u1_dot_of_u1_4_last = u1_dot_of_u1_4_1;
    let mut next = [S::int(0); 16];
    // Rates at order k - 1.
    let mut q2_rate = -u1_1;
    let mut u1_rate = -u1_dot_of_u1_4_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q2 = q2_rate * over_k;
        let u1 = u1_rate * over_k;
        series[order] = [q2, u1];
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
                q2_1.mul_add(c2_last, (count_last * q2_last).mul_add(c2_1, next[0])),
                q2_1.mul_add(s2_last, (count_last * q2_last).mul_add(s2_1, next[1])),
                c2_1
                    .mul_add(
                        u2_of_place_2_last,
                        c2_last.mul_add(u2_of_place_2_1, next[2]),
                    ),
                (c2_1 + c2_1).mul_add(c2_last, next[3]),
                (u1_1 + u1_1).mul_add(u1_last, next[4]),
                c2_1.mul_add(u1_sq_last, c2_last.mul_add(u1_sq_1, next[5])),
                c2_1
                    .mul_add(
                        u1_dot_of_place_last,
                        c2_last.mul_add(u1_dot_of_place_1, next[6]),
                    ),
                u2_of_place_2_1
                    .mul_add(
                        u1_dot_of_place_last,
                        u2_of_place_2_last.mul_add(u1_dot_of_place_1, next[7]),
                    ),
                s2_1
                    .mul_add(
                        u1_dot_of_u1_last,
                        s2_last.mul_add(u1_dot_of_u1_1, next[8]),
                    ),
                u1_dot_of_q2_1
                    .mul_add(
                        u1_dot_of_u1_4_last,
                        u1_dot_of_q2_last.mul_add(u1_dot_of_u1_4_1, next[9]),
                    ),
            ])
        };
        // s2 = sin(q2)
        let s2 = q2.mul_add(c2_0, sums[0] * over_k);
        // c2 = cos(q2)
        let c2 = -q2.mul_add(s2_0, sums[1] * over_k);
        // u2_of_place = H_a3_scaled + minus_u3_times_2*s2
        let u2_of_place = minus_u3_times_2 * s2;
        // u2_of_place_2 = u2_of_place/c2
        let u2_of_place_2 = u2_of_place
            .mul_add(over_c2, -(c2.mul_add(u2_of_place_2_0, sums[2]) * over_c2));
        // c2_sq = c2*c2
        let c2_sq = c2.mul_add(c2_0 + c2_0, sums[3]);
        // u1_sq = u1*u1
        let u1_sq = u1.mul_add(u1_0 + u1_0, sums[4]);
        // u1_sq_c2 = c2*u1_sq
        let u1_sq_c2 = u1_sq.mul_add(c2_0, c2.mul_add(u1_sq_0, sums[5]));
        // u1_dot_of_place = u2_of_place_2/c2
        let u1_dot_of_place = u2_of_place_2
            .mul_add(over_c2, -(c2.mul_add(u1_dot_of_place_0, sums[6]) * over_c2));
        // u1_dot_of_place_2 = u2_of_place_2*u1_dot_of_place
        let u1_dot_of_place_2 = u1_dot_of_place
            .mul_add(u2_of_place_2_0, u2_of_place_2.mul_add(u1_dot_of_place_0, sums[7]));
        // u1_dot_of_q2 = -5 + 4*c2_sq
        let u1_dot_of_q2 = S::int(4) * c2_sq;
        // u1_dot_of_u1 = minus_g_times_4 + 4*u1_sq_c2 + u1_dot_of_place_2
        let u1_dot_of_u1 = S::int(4) * u1_sq_c2 + u1_dot_of_place_2;
        // u1_dot_of_u1_2 = s2*u1_dot_of_u1
        let u1_dot_of_u1_2 = u1_dot_of_u1
            .mul_add(s2_0, s2.mul_add(u1_dot_of_u1_0, sums[8]));
        // u1_dot_of_u1_3 = u1_dot_of_u1_2 + minus_u3_times_2*u2_of_place_2
        let u1_dot_of_u1_3 = minus_u3_times_2 * u2_of_place_2 + u1_dot_of_u1_2;
        // u1_dot_of_u1_4 = u1_dot_of_u1_3/u1_dot_of_q2
        let u1_dot_of_u1_4 = u1_dot_of_u1_3
            .mul_add(
                over_u1_dot_of_q2,
                -(u1_dot_of_q2.mul_add(u1_dot_of_u1_4_0, sums[9]) * over_u1_dot_of_q2),
            );
        q2_rate = -u1;
        u1_rate = -u1_dot_of_u1_4;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * q2,
                count * q2,
                c2, c2, u1, c2, c2, u2_of_place_2, s2, u1_dot_of_q2,
            ]),
            padded([
                c2, s2, u2_of_place_2, c2, u1, u1_sq, u1_dot_of_place, u1_dot_of_place,
                u1_dot_of_u1, u1_dot_of_u1_4,
            ]),
        ];
        count_last = count;
        q2_last = q2;
        u1_last = u1;
        s2_last = s2;
        c2_last = c2;
        u2_of_place_2_last = u2_of_place_2;
        u1_sq_last = u1_sq;
        u1_dot_of_place_last = u1_dot_of_place;
        u1_dot_of_q2_last = u1_dot_of_q2;
        u1_dot_of_u1_last = u1_dot_of_u1;
        u1_dot_of_u1_4_last = u1_dot_of_u1_4;
    }
}

/// Reduced equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Reduced;

impl<S: Scalar> System<S> for Reduced {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 5,
            coordinates: 1,
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
        2
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
        Some(core::f64::consts::TAU)
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
        ["cos(q2)"][at]
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
    name: "lean",
    key: "5e319e0cc5e9e6d5",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: Some(InLanes::of_rates(&Derivative(Reduced))),
    },
};
