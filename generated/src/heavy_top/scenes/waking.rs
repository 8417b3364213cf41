//! Symmetric heavy top about a fixed point: Awake.
//!
//! Generated from `models/heavy_top/scenes/waking.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: q1, q2, q3, u1, u2, u3.
//! States: q1, q2, u1, u2. Quadratures: q3.
//! p_q3 = 21*u3/1000: momentum p_q3 = ∂L/∂q3'.
//! Parameters that the scene fixes: m = 1.3, l = 0.22, I1 = 0.095, I3 = 0.021, g = 9.81.
//! Cost: accelerations 14 operations, 2 sines and cosines; derivative 13 operations, 2 sines and cosines.
//! Singular where cos(q2) = 0.

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{CompiledScene, CompiledSystem, Scalar, System};

/// The parameters, in the order of the model file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// momentum p_q3 = ∂L/∂q3', 1
    pub p_q3: S,
}

impl<S: Scalar> Parameters<S> {
    /// From values in the order of [`PARAMETERS`].
    ///
    /// # Panics
    /// If `p` has fewer values than there are parameters.
    #[must_use]
    #[inline(always)]
    pub fn from_slice(p: &[S]) -> Self {
        Self { p_q3: p[0] }
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 1] = ["p_q3"];

/// Names of the outputs.
pub const OUTPUTS: [&str; 6] = ["q1", "q2", "q3", "u1", "u2", "u3"];

/// The accelerations (u1', u2'), solved for when this code was generated.
///
/// 14 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [S; 2] {
    let Parameters { p_q3 } = *p;
    let [q1, q2, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step.
    // u3 = 1000*p_q3/21
    let u3 = S::ratio(1000, 21) * p_q3;
    // Shared terms.
    // tan(q2)
    let t2 = s2 / c2;
    // 21*u3 - 95*u1*tan(q2)
    let u2_dot_part = (-(u1 * t2)).mul_add(S::int(95), S::int(21) * u3);
    // u2_dot_part/95; used 2 times
    let u2_dot_part_scaled = S::ratio(1, 95) * u2_dot_part;
    // Elimination, step by step.
    // u2' = 140283*cos(q1)*sin(q2)/4750 - u1^2*tan(q2) + 21*u1*u3/95
    let u2_dot = u1.mul_add(u2_dot_part_scaled, S::ratio(140283, 4750) * c1 * s2);
    // u1' = 140283*sin(q1)/4750 + u1*u2*tan(q2) - 21*u2*u3/95
    let u1_dot = (-u2).mul_add(u2_dot_part_scaled, S::ratio(140283, 4750) * s1);
    [u1_dot, u2_dot]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 13 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 2],
) -> ([S; 3], [S; 2]) {
    let Parameters { p_q3 } = *p;
    let [q1, q2, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step.
    // u3 = 1000*p_q3/21
    let u3 = S::ratio(1000, 21) * p_q3;
    // Shared terms.
    // u1/cos(q2); used 2 times
    let u1_c2_inv = u1 / c2;
    // u1_c2_inv*sin(q2); used 2 times
    let s2_u1_c2_inv = u1_c2_inv * s2;
    // 21*u3/95
    let u3_scaled = S::ratio(21, 95) * u3;
    // s2_u1_c2_inv - u3_scaled; used 2 times
    let u2_dot_part = s2_u1_c2_inv - u3_scaled;
    // Elimination, step by step.
    // u2' = 140283*cos(q1)*sin(q2)/4750 - u1^2*tan(q2) + 21*u1*u3/95
    let u2_dot = (-u1).mul_add(u2_dot_part, S::ratio(140283, 4750) * c1 * s2);
    // u1' = 140283*sin(q1)/4750 + u1*u2*tan(q2) - 21*u2*u3/95
    let u1_dot = u2.mul_add(u2_dot_part, S::ratio(140283, 4750) * s1);
    // Values.
    // q1' = u1/cos(q2)
    let q1_dot_value = u1_c2_inv;
    // q2' = u2
    let q2_dot_value = u2;
    // q3' = u3 - u1*tan(q2)
    let q3_dot_value = u3 - s2_u1_c2_inv;
    ([q1_dot_value, q2_dot_value, q3_dot_value], [u1_dot, u2_dot])
}

/// Jacobian of the derivative by the state; columns q1, q2, q3, u1, u2.
///
/// 22 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [[S; 5]; 5] {
    let Parameters { p_q3 } = *p;
    let [q1, q2, _] = *q;
    let [u1, u2] = *u;
    let zero = S::int(0);
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step.
    // u3 = 1000*p_q3/21
    let u3 = S::ratio(1000, 21) * p_q3;
    // u2_dot_by_q1 = -140283*sin(q1)*sin(q2)/4750
    let u2_dot_by_q1 = -S::ratio(140283, 4750) * s1 * s2;
    // Shared terms.
    // 1/cos(q2); used 4 times
    let c2_inv = S::int(1) / c2;
    // u1*c2_inv; used 4 times
    let u1_c2_inv = u1 * c2_inv;
    // 140283*cos(q1)/4750; used 2 times
    let c1_scaled = S::ratio(140283, 4750) * c1;
    // Elimination, step by step.
    // u2_dot_by_q2 = 140283*cos(q1)*cos(q2)/4750 - u1^2/cos(q2)^2
    let u2_dot_by_q2 = (-u1_c2_inv).mul_add(u1_c2_inv, c1_scaled * c2);
    // Shared terms.
    // c2_inv*u1_c2_inv; used 2 times
    let c2_inv_u1_c2_inv = c2_inv * u1_c2_inv;
    // Elimination, step by step.
    // u1_dot_by_q2 = u1*u2/cos(q2)^2
    let u1_dot_by_q2 = u2 * c2_inv_u1_c2_inv;
    // Shared terms.
    // 21*u3/95; used 2 times
    let u3_scaled = S::ratio(21, 95) * u3;
    // u1_c2_inv*sin(q2); used 2 times
    let s2_u1_c2_inv = u1_c2_inv * s2;
    // Elimination, step by step.
    // u2_dot_by_u1 = 21*u3/95 - 2*u1*tan(q2)
    let u2_dot_by_u1 = (-s2_u1_c2_inv).mul_add(S::int(2), u3_scaled);
    // Shared terms.
    // c2_inv*sin(q2); used 3 times
    let s2_c2_inv = c2_inv * s2;
    // Elimination, step by step.
    // u1_dot_by_u1 = u2*tan(q2)
    let u1_dot_by_u1 = u2 * s2_c2_inv;
    // u1_dot_by_u2 = u1*tan(q2) - 21*u3/95
    let u1_dot_by_u2 = s2_u1_c2_inv - u3_scaled;
    // Entries that are not zero.
    // d(q1')/d(q2) = u1*tan(q2)/cos(q2)
    let q1_dot_by_q2_value = u1_c2_inv * s2_c2_inv;
    // d(q1')/d(u1) = 1/cos(q2)
    let q1_dot_by_u1_value = c2_inv;
    // d(q2')/d(u2) = 1
    let q2_dot_by_u2_value = S::int(1);
    // d(q3')/d(q2) = -u1/cos(q2)^2
    let q3_dot_by_q2_value = -c2_inv_u1_c2_inv;
    // d(q3')/d(u1) = -tan(q2)
    let q3_dot_by_u1_value = -s2_c2_inv;
    // d(u1')/d(q1) = 140283*cos(q1)/4750
    let u1_dot_by_q1_value = c1_scaled;
    [
        [zero, q1_dot_by_q2_value, zero, q1_dot_by_u1_value, zero],
        [zero, zero, zero, zero, q2_dot_by_u2_value],
        [zero, q3_dot_by_q2_value, zero, q3_dot_by_u1_value, zero],
        [u1_dot_by_q1_value, u1_dot_by_q2, zero, u1_dot_by_u1, u1_dot_by_u2],
        [u2_dot_by_q1, u2_dot_by_q2, zero, u2_dot_by_u1, zero],
    ]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [S; 3] {
    let Parameters { p_q3 } = *p;
    let [_, q2, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step.
    // u3 = 1000*p_q3/21
    let u3 = S::ratio(1000, 21) * p_q3;
    // Shared terms.
    // u1/cos(q2); used 2 times
    let u1_c2_inv = u1 / c2;
    // Values.
    // q1' = u1/cos(q2)
    let q1_dot_value = u1_c2_inv;
    // q2' = u2
    let q2_dot_value = u2;
    // q3' = u3 - u1*tan(q2)
    let q3_dot_value = (-u1_c2_inv).mul_add(s2, u3);
    [q1_dot_value, q2_dot_value, q3_dot_value]
}

/// Kinetic energy T.
///
/// 4 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(_p: &Parameters<S>, _q: &[S; 3], u: &[S; 2]) -> S {
    let [u1, u2] = *u;
    // Shared terms.
    // u1^2 + u2^2
    let u1_2_plus_u2_2 = u2.mul_add(u2, u1 * u1);
    // Values.
    // T = 19*u1^2/400 + 19*u2^2/400
    let energy = S::ratio(19, 400) * u1_2_plus_u2_2;
    energy
}

/// Potential energy V of gravity, with the kinetic energy of what the momenta determine.
///
/// 6 operations, 2 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3]) -> S {
    let Parameters { p_q3 } = *p;
    let [q1, q2, _] = *q;
    // Sines and cosines.
    let (_, c2) = q2.sin_cos();
    let (_, c1) = q1.sin_cos();
    // Elimination, step by step.
    // u3 = 1000*p_q3/21
    let u3 = S::ratio(1000, 21) * p_q3;
    // Values.
    // V = 140283*cos(q1)*cos(q2)/50000 + 21*u3^2/2000
    let energy = S::ratio(140283, 50000) * c1 * c2 + S::ratio(21, 2000) * u3 * u3;
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 1 operation.
#[must_use]
pub fn outputs<S: Scalar>(p: &Parameters<S>, _t: S, q: &[S; 3], u: &[S; 2]) -> [S; 6] {
    let Parameters { p_q3 } = *p;
    let [q1, q2, q3] = *q;
    let [u1, u2] = *u;
    // Elimination, step by step.
    // u3 = 1000*p_q3/21
    let u3 = S::ratio(1000, 21) * p_q3;
    // Values.
    // q1 = q1
    let q1_value = q1;
    // q2 = q2
    let q2_value = q2;
    // q3 = q3
    let q3_value = q3;
    // u1 = u1
    let u1_value = u1;
    // u2 = u2
    let u2_value = u2;
    [q1_value, q2_value, q3_value, u1_value, u2_value, u3]
}

/// The energy, then its derivatives by the state.
///
/// 18 operations, 2 sines and cosines.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [S; 6] {
    let Parameters { p_q3 } = *p;
    let [q1, q2, _] = *q;
    let [u1, u2] = *u;
    let zero = S::int(0);
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step.
    // u3 = 1000*p_q3/21
    let u3 = S::ratio(1000, 21) * p_q3;
    // Shared terms.
    // 140283*cos(q2)/50000; used 2 times
    let c2_scaled = S::ratio(140283, 50000) * c2;
    // u1^2 + u2^2
    let u1_2_plus_u2_2 = u2.mul_add(u2, u1 * u1);
    // Values.
    // T + V = 140283*cos(q1)*cos(q2)/50000 + 19*u1^2/400 + 19*u2^2/400 + 21*u3^2/2000
    let energy = c2_scaled.mul_add(c1, S::ratio(21, 2000) * u3 * u3)
        + S::ratio(19, 400) * u1_2_plus_u2_2;
    // d(T + V)/d(q1) = -140283*sin(q1)*cos(q2)/50000
    let energy_by_q1 = -c2_scaled * s1;
    // d(T + V)/d(q2) = -140283*cos(q1)*sin(q2)/50000
    let energy_by_q2 = -S::ratio(140283, 50000) * c1 * s2;
    // d(T + V)/d(u1) = 19*u1/200
    let energy_by_u1 = S::ratio(19, 200) * u1;
    // d(T + V)/d(u2) = 19*u2/200
    let energy_by_u2 = S::ratio(19, 200) * u2;
    [energy, energy_by_q1, energy_by_q2, zero, energy_by_u1, energy_by_u2]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 9 convolutions and 12 linear operations an order.
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 5]],
    history: &mut [Factors<S, 16>],
) {
    let Parameters { p_q3 } = *p;
    let [q1_0, q2_0, _, u1_0, u2_0] = series[0];
    // Constant in time.
    // weight = 1000*p_q3
    let weight = S::int(1000) * p_q3;
    // weight_2 = 1000*p_q3/21
    let weight_2 = S::ratio(1000, 21) * p_q3;
    // Order 0.
    let (s2_0, c2_0) = q2_0.sin_cos();
    let over_c2 = S::int(1) / c2_0;
    // q1_dot_2 = u1/c2
    let q1_dot_2_0 = u1_0 * over_c2;
    // u1_tan_q2 = s2*q1_dot_2
    let u1_tan_q2_0 = s2_0 * q1_dot_2_0;
    let (s1_0, c1_0) = q1_0.sin_cos();
    // cos_q1_sin_q2 = s2*c1
    let cos_q1_sin_q2_0 = s2_0 * c1_0;
    // u2_dot_part = weight - 95*u1_tan_q2
    let u2_dot_part_0 = u1_tan_q2_0.mul_add(-S::int(95), weight);
    // u2_dot_part_2 = u1*u2_dot_part
    let u2_dot_part_2_0 = u1_0 * u2_dot_part_0;
    // u2_dot_2 = 140283/4750*cos_q1_sin_q2 + 1/95*u2_dot_part_2
    let u2_dot_2_0 = u2_dot_part_2_0
        .mul_add(S::ratio(1, 95), S::ratio(140283, 4750) * cos_q1_sin_q2_0);
    // u1_dot_part = u2*u2_dot_part
    let u1_dot_part_0 = u2_0 * u2_dot_part_0;
    // u1_dot_2 = 140283/4750*s1 - 1/95*u1_dot_part
    let u1_dot_2_0 = u1_dot_part_0
        .mul_add(-S::ratio(1, 95), S::ratio(140283, 4750) * s1_0);
    // q3_dot_2 = weight_2 - u1_tan_q2
    let q3_dot_2_0 = weight_2 - u1_tan_q2_0;
    // Order 1: the rates, and what follows from them.
    let q1_1 = q1_dot_2_0;
    let q2_1 = u2_0;
    let q3_1 = q3_dot_2_0;
    let u1_1 = u1_dot_2_0;
    let u2_1 = u2_dot_2_0;
    if series.len() > 1 {
        series[1] = [q1_1, q2_1, q3_1, u1_1, u2_1];
    }
    let s2_1 = q2_1 * c2_0;
    let c2_1 = -q2_1 * s2_0;
    let q1_dot_2_1 = c2_1.mul_add(-(q1_dot_2_0 * over_c2), u1_1 * over_c2);
    let u1_tan_q2_1 = q1_dot_2_1.mul_add(s2_0, s2_1 * q1_dot_2_0);
    let s1_1 = q1_1 * c1_0;
    let c1_1 = -q1_1 * s1_0;
    let cos_q1_sin_q2_1 = c1_1.mul_add(s2_0, s2_1 * c1_0);
    let u2_dot_part_1 = -S::int(95) * u1_tan_q2_1;
    let u2_dot_part_2_1 = u2_dot_part_1.mul_add(u1_0, u1_1 * u2_dot_part_0);
    let u2_dot_2_1 = u2_dot_part_2_1
        .mul_add(S::ratio(1, 95), S::ratio(140283, 4750) * cos_q1_sin_q2_1);
    let u1_dot_part_1 = u2_dot_part_1.mul_add(u2_0, u2_1 * u2_dot_part_0);
    let u1_dot_2_1 = u1_dot_part_1
        .mul_add(-S::ratio(1, 95), S::ratio(140283, 4750) * s1_1);
    let q3_dot_2_1 = -u1_tan_q2_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([q2_1, q2_1, c2_1, s2_1, q1_1, q1_1, s2_1, u1_1, u2_1]),
            padded([
                c2_1,
                s2_1,
                q1_dot_2_1,
                q1_dot_2_1,
                c1_1,
                s1_1,
                c1_1,
                u2_dot_part_1,
                u2_dot_part_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q1_last = q1_1;
    let mut q2_last = q2_1;
    let mut u1_last = u1_1;
    let mut u2_last = u2_1;
    let mut s2_last = s2_1;
    let mut c2_last = c2_1;
    let mut q1_dot_2_last = q1_dot_2_1;
    let mut s1_last = s1_1;
    let mut c1_last = c1_1;
    let mut u2_dot_part_last = u2_dot_part_1;
    let mut next = [S::int(0); 16];
    // Rates at order k - 1.
    let mut q1_rate = q1_dot_2_1;
    let mut q2_rate = u2_1;
    let mut q3_rate = q3_dot_2_1;
    let mut u1_rate = u1_dot_2_1;
    let mut u2_rate = u2_dot_2_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q1 = q1_rate * over_k;
        let q2 = q2_rate * over_k;
        let q3 = q3_rate * over_k;
        let u1 = u1_rate * over_k;
        let u2 = u2_rate * over_k;
        series[order] = [q1, q2, q3, u1, u2];
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
                c2_1.mul_add(q1_dot_2_last, c2_last.mul_add(q1_dot_2_1, next[2])),
                s2_1.mul_add(q1_dot_2_last, s2_last.mul_add(q1_dot_2_1, next[3])),
                q1_1.mul_add(c1_last, (count_last * q1_last).mul_add(c1_1, next[4])),
                q1_1.mul_add(s1_last, (count_last * q1_last).mul_add(s1_1, next[5])),
                s2_1.mul_add(c1_last, s2_last.mul_add(c1_1, next[6])),
                u1_1.mul_add(u2_dot_part_last, u1_last.mul_add(u2_dot_part_1, next[7])),
                u2_1.mul_add(u2_dot_part_last, u2_last.mul_add(u2_dot_part_1, next[8])),
            ])
        };
        // s2 = sin(q2)
        let s2 = q2.mul_add(c2_0, sums[0] * over_k);
        // c2 = cos(q2)
        let c2 = -q2.mul_add(s2_0, sums[1] * over_k);
        // q1_dot_2 = u1/c2
        let q1_dot_2 = c2.mul_add(-(q1_dot_2_0 * over_c2), (u1 - sums[2]) * over_c2);
        // u1_tan_q2 = s2*q1_dot_2
        let u1_tan_q2 = q1_dot_2.mul_add(s2_0, s2.mul_add(q1_dot_2_0, sums[3]));
        // s1 = sin(q1)
        let s1 = q1.mul_add(c1_0, sums[4] * over_k);
        // c1 = cos(q1)
        let c1 = -q1.mul_add(s1_0, sums[5] * over_k);
        // cos_q1_sin_q2 = s2*c1
        let cos_q1_sin_q2 = c1.mul_add(s2_0, s2.mul_add(c1_0, sums[6]));
        // u2_dot_part = weight - 95*u1_tan_q2
        let u2_dot_part = -S::int(95) * u1_tan_q2;
        // u2_dot_part_2 = u1*u2_dot_part
        let u2_dot_part_2 = u2_dot_part
            .mul_add(u1_0, u1.mul_add(u2_dot_part_0, sums[7]));
        // u2_dot_2 = 140283/4750*cos_q1_sin_q2 + 1/95*u2_dot_part_2
        let u2_dot_2 = u2_dot_part_2
            .mul_add(S::ratio(1, 95), S::ratio(140283, 4750) * cos_q1_sin_q2);
        // u1_dot_part = u2*u2_dot_part
        let u1_dot_part = u2_dot_part.mul_add(u2_0, u2.mul_add(u2_dot_part_0, sums[8]));
        // u1_dot_2 = 140283/4750*s1 - 1/95*u1_dot_part
        let u1_dot_2 = u1_dot_part
            .mul_add(-S::ratio(1, 95), S::ratio(140283, 4750) * s1);
        // q3_dot_2 = weight_2 - u1_tan_q2
        let q3_dot_2 = -u1_tan_q2;
        q1_rate = q1_dot_2;
        q2_rate = u2;
        q3_rate = q3_dot_2;
        u1_rate = u1_dot_2;
        u2_rate = u2_dot_2;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([count * q2, count * q2, c2, s2, count * q1, count * q1, s2, u1, u2]),
            padded([c2, s2, q1_dot_2, q1_dot_2, c1, s1, c1, u2_dot_part, u2_dot_part]),
        ];
        count_last = count;
        q1_last = q1;
        q2_last = q2;
        u1_last = u1;
        u2_last = u2;
        s2_last = s2;
        c2_last = c2;
        q1_dot_2_last = q1_dot_2;
        s1_last = s1;
        c1_last = c1;
        u2_dot_part_last = u2_dot_part;
    }
}

/// Reduced equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Reduced;

impl<S: Scalar> System<S> for Reduced {
    fn parameters(&self) -> usize {
        1
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
        6
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
        32 * order + SLACK
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
    name: "waking",
    key: "7a1449b8118f56da",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: None,
    },
};
