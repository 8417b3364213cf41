//! Elastic pendulum: Bouncing turns into swinging.
//!
//! Generated from `models/elastic_pendulum/scenes/bouncing.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{CompiledScene, CompiledSystem, Lengths, Scalar, System};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// stiffness of the spring; 3 m g/l makes it resonant, kg/s^2
    pub k: S,
    /// acceleration of free fall, m/s^2
    pub g: S,
}

impl<S: Scalar> Parameters<S> {
    /// From values in the order of [`PARAMETERS`].
    ///
    /// # Panics
    /// If `p` has fewer values than there are parameters.
    #[must_use]
    #[inline(always)]
    pub fn from_slice(p: &[S]) -> Self {
        Self { k: p[0], g: p[1] }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 2] {
        let Self { k, g, .. } = self;
        [k, g]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 2] = ["k", "g"];

/// Names of the outputs.
pub const OUTPUTS: [&str; 4] = ["x", "y", "u", "v"];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 0 operations.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    _q: &[S; 2],
    _u: &[S; 2],
) -> [S; 2] {
    let super::super::super::Parameters { k, g, .. } = *p;
    // Values.
    // k
    let k_value = k;
    // g
    let g_value = g;
    [k_value, g_value]
}

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// 0 operations.
#[must_use]
pub fn start<S: Scalar>(
    _p: &super::super::super::Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let [x, y] = *q;
    let [u_2, v] = *u;
    // Values.
    // x
    let x_value = x;
    // y
    let y_value = y;
    // u
    let u_value = u_2;
    // v
    let v_value = v;
    ([x_value, y_value], [u_value, v_value])
}

/// The accelerations (u', v'), solved for when this code was generated.
///
/// 11 operations, 1 other function.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 2]) -> [S; 2] {
    let Parameters { k, g } = *p;
    let [x, y] = *q;
    // Elimination, step by step, each after the terms that it shares.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    // k*(1 - sqrt(x^2 + y^2)/(x^2 + y^2))
    let v_dot_2_of_k_x_y = k * (S::int(1) - x_sq_plus_y_sq.sqrt() / x_sq_plus_y_sq);
    // v' = k*y*sqrt(x^2 + y^2)*(1 - sqrt(x^2 + y^2))/(x^2 + y^2) - g
    let v_dot_2 = (-y).mul_add(v_dot_2_of_k_x_y, -g);
    // u' = k*x*sqrt(x^2 + y^2)*(1 - sqrt(x^2 + y^2))/(x^2 + y^2)
    let u_dot = -x * v_dot_2_of_k_x_y;
    [u_dot, v_dot_2]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    u: &[S; 2],
) -> [S; 2] {
    let [u_2, v] = *u;
    // Values.
    // x' = u
    let x_dot_value = u_2;
    // y' = v
    let y_dot_value = v;
    [x_dot_value, y_dot_value]
}

/// Kinetic energy T.
///
/// 4 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(_p: &Parameters<S>, _q: &[S; 2], u: &[S; 2]) -> S {
    let [u_2, v] = *u;
    // Shared terms.
    // u^2 + v^2
    let u_2_sq_plus_v_sq = v.mul_add(v, u_2 * u_2);
    // Values.
    // T = u^2/2 + v^2/2
    let energy = S::ratio(1, 2) * u_2_sq_plus_v_sq;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 9 operations, 1 other function.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2]) -> S {
    let Parameters { k, g } = *p;
    let [x, y] = *q;
    // Values.
    // V = g*y + k*(sqrt(x^2 + y^2) - 1)^2/2
    let energy = S::ratio(1, 2) * k * (y.mul_add(y, x * x).sqrt() - S::int(1)).powi(2) + g * y;
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 0 operations.
#[must_use]
pub fn outputs<S: Scalar>(_p: &Parameters<S>, _t: S, q: &[S; 2], u: &[S; 2]) -> [S; 4] {
    let [x, y] = *q;
    let [u_2, v] = *u;
    // Values.
    // x
    let x_value = x;
    // y
    let y_value = y;
    // u
    let u_value = u_2;
    // v
    let v_value = v;
    [x_value, y_value, u_value, v_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 11 operations, 1 other function.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let Parameters { k, g } = *p;
    let [x, y] = *q;
    let [u_2, v] = *u;
    // Elimination, step by step, each after the terms that it shares.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    // k*(1 - sqrt(x^2 + y^2)/(x^2 + y^2))
    let v_dot_2_of_k_x_y = k * (S::int(1) - x_sq_plus_y_sq.sqrt() / x_sq_plus_y_sq);
    // v' = k*y*sqrt(x^2 + y^2)*(1 - sqrt(x^2 + y^2))/(x^2 + y^2) - g
    let v_dot_2 = (-y).mul_add(v_dot_2_of_k_x_y, -g);
    // u' = k*x*sqrt(x^2 + y^2)*(1 - sqrt(x^2 + y^2))/(x^2 + y^2)
    let u_dot = -x * v_dot_2_of_k_x_y;
    // Values.
    // x' = u
    let x_dot_value = u_2;
    // y' = v
    let y_dot_value = v;
    ([x_dot_value, y_dot_value], [u_dot, v_dot_2])
}

/// Jacobian of the derivative by the state; columns x, y, u, v.
///
/// 19 operations, 1 other function.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 2]) -> [[S; 4]; 4] {
    let Parameters { k, .. } = *p;
    let [x, y] = *q;
    // Elimination, step by step, each after the terms that it shares.
    let y_sq = y * y;
    let x_sq = x * x;
    // x^2 + y_sq
    let x_sq_plus_y_sq = x_sq + y_sq;
    let x_sq_plus_y_sq_inv = S::int(1) / x_sq_plus_y_sq;
    let k_x_sq_plus_y_sq_inv = k * x_sq_plus_y_sq_inv;
    // k_x_sq_plus_y_sq_inv*sqrt(x^2 + y^2)
    let v_dot_by_x_of_k_x_y_y_sq = k_x_sq_plus_y_sq_inv * (x_sq + y_sq).sqrt();
    let v_dot_by_x_of_k_x_y_y_sq_2 = x_sq_plus_y_sq_inv * v_dot_by_x_of_k_x_y_y_sq;
    let v_dot_by_x_of_k_x_y_y_sq_3 = x * v_dot_by_x_of_k_x_y_y_sq_2;
    let v_dot_by_x_of_k_x_y_y_sq_4 = y * v_dot_by_x_of_k_x_y_y_sq_3;
    // -v_dot_by_x_of_k_x_y_y_sq_4
    let v_dot_by_x_of_k_x_y_y_sq_5 = -v_dot_by_x_of_k_x_y_y_sq_4;
    // v_dot_by_x = -k*x*y*sqrt(x^2 + y^2)/(x^2 + y^2)^2
    let v_dot_by_x = v_dot_by_x_of_k_x_y_y_sq_5;
    // x_sq_plus_y_sq*k_x_sq_plus_y_sq_inv - v_dot_by_x_of_k_x_y_y_sq
    let u_dot_by_x_of_k_x_y_y_sq = x_sq_plus_y_sq
        .mul_add(k_x_sq_plus_y_sq_inv, -v_dot_by_x_of_k_x_y_y_sq);
    // u_dot_by_x = k*(sqrt(x^2 + y^2) - x^2 - y^2 - x^2*sqrt(x^2 + y^2)/(x^2 + y^2))/(x^2 + y^2)
    let u_dot_by_x = (-x).mul_add(v_dot_by_x_of_k_x_y_y_sq_3, -u_dot_by_x_of_k_x_y_y_sq);
    // v_dot_by_y = k*(sqrt(x^2 + y^2) - x^2 - y^2 - y^2*sqrt(x^2 + y^2)/(x^2 + y^2))/(x^2 + y^2)
    let v_dot_by_y = (-y_sq)
        .mul_add(v_dot_by_x_of_k_x_y_y_sq_2, -u_dot_by_x_of_k_x_y_y_sq);
    // u_dot_by_y = -k*x*y*sqrt(x^2 + y^2)/(x^2 + y^2)^2
    let u_dot_by_y = v_dot_by_x_of_k_x_y_y_sq_5;
    // Entries that are not zero.
    // d(x')/d(u) = 1
    let x_dot_by_u_value = S::int(1);
    // d(y')/d(v) = 1
    let y_dot_by_v_value = S::int(1);
    let zero = S::int(0);
    [
        [zero, zero, x_dot_by_u_value, zero],
        [zero, zero, zero, y_dot_by_v_value],
        [u_dot_by_x, u_dot_by_y, zero, zero],
        [v_dot_by_x, v_dot_by_y, zero, zero],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 3 operations.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 2], _u: &[S; 2]) -> [S; 1] {
    let [x, y] = *q;
    // Values.
    // divisor1 = x^2 + y^2
    let divisor1 = y.mul_add(y, x * x);
    [divisor1]
}

/// The energy, then its derivatives by the state.
///
/// 18 operations, 1 other function.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 5] {
    let Parameters { k, g } = *p;
    let [x, y] = *q;
    let [u_2, v] = *u;
    // Shared terms.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    let energy_of_x_y = x_sq_plus_y_sq.sqrt();
    // sqrt(x^2 + y^2) - 1
    let energy_of_x_y_2 = energy_of_x_y - S::int(1);
    let k_energy_of_x_y_2 = k * energy_of_x_y_2;
    // u^2 + v^2
    let u_2_sq_plus_v_sq = v.mul_add(v, u_2 * u_2);
    // energy_of_x_y_2*k_energy_of_x_y_2 + u_2_sq_plus_v_sq
    let energy_of_u_2_v = energy_of_x_y_2.mul_add(k_energy_of_x_y_2, u_2_sq_plus_v_sq);
    let energy_by_x_of_k_x_y = k_energy_of_x_y_2 * energy_of_x_y / x_sq_plus_y_sq;
    // Values.
    // T + V = g*y + k*(sqrt(x^2 + y^2) - 1)^2/2 + u^2/2 + v^2/2
    let energy = g.mul_add(y, S::ratio(1, 2) * energy_of_u_2_v);
    // d(T + V)/d(x) = k*x*sqrt(x^2 + y^2)*(sqrt(x^2 + y^2) - 1)/(x^2 + y^2)
    let energy_by_x = x * energy_by_x_of_k_x_y;
    // d(T + V)/d(y) = g + k*y*sqrt(x^2 + y^2)*(sqrt(x^2 + y^2) - 1)/(x^2 + y^2)
    let energy_by_y = y.mul_add(energy_by_x_of_k_x_y, g);
    // d(T + V)/d(u) = u
    let energy_by_u = u_2;
    // d(T + V)/d(v) = v
    let energy_by_v = v;
    [energy, energy_by_x, energy_by_y, energy_by_u, energy_by_v]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 7 convolutions and 8 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 4]],
    history: &mut [Factors<S, 8>],
) {
    let Parameters { k, g } = *p;
    let [x_0, y_0, u_2_0, v_0] = series[0];
    // Constant in time.
    // minus_g = -g
    let minus_g = -g;
    // minus_k = -k
    let minus_k = -k;
    // Order 0.
    let x_sq_0 = x_0 * x_0;
    let y_sq_0 = y_0 * y_0;
    let x_sq_plus_y_sq_0 = x_sq_0 + y_sq_0;
    let over_x_sq_plus_y_sq = S::int(1) / x_sq_plus_y_sq_0;
    let v_dot_2_of_x_y_0 = x_sq_plus_y_sq_0.sqrt();
    let over_twice_v_dot_2_of_x_y = S::int(1) / (v_dot_2_of_x_y_0 + v_dot_2_of_x_y_0);
    let v_dot_2_of_x_y_2_0 = -S::int(1) + v_dot_2_of_x_y_0;
    let v_dot_2_of_x_y_3_0 = v_dot_2_of_x_y_0 * over_x_sq_plus_y_sq;
    let v_dot_2_of_x_y_4_0 = v_dot_2_of_x_y_2_0 * v_dot_2_of_x_y_3_0;
    let v_dot_2_of_x_y_5_0 = y_0 * v_dot_2_of_x_y_4_0;
    let v_dot_3_0 = v_dot_2_of_x_y_5_0.mul_add(minus_k, minus_g);
    let u_dot_of_x_y_0 = x_0 * v_dot_2_of_x_y_4_0;
    // Order 1: the rates, and what follows from them.
    let x_1 = u_2_0;
    let y_1 = v_0;
    let u_2_1 = minus_k * u_dot_of_x_y_0;
    let v_1 = v_dot_3_0;
    if series.len() > 1 {
        series[1] = [x_1, y_1, u_2_1, v_1];
    }
    let x_sq_1 = x_1 * (x_0 + x_0);
    let y_sq_1 = y_1 * (y_0 + y_0);
    let x_sq_plus_y_sq_1 = x_sq_1 + y_sq_1;
    let v_dot_2_of_x_y_1 = x_sq_plus_y_sq_1 * over_twice_v_dot_2_of_x_y;
    let v_dot_2_of_x_y_2_1 = v_dot_2_of_x_y_1;
    let v_dot_2_of_x_y_3_1 = x_sq_plus_y_sq_1
        .mul_add(
            -(v_dot_2_of_x_y_3_0 * over_x_sq_plus_y_sq),
            v_dot_2_of_x_y_1 * over_x_sq_plus_y_sq,
        );
    let v_dot_2_of_x_y_4_1 = v_dot_2_of_x_y_3_1
        .mul_add(v_dot_2_of_x_y_2_0, v_dot_2_of_x_y_2_1 * v_dot_2_of_x_y_3_0);
    let v_dot_2_of_x_y_5_1 = v_dot_2_of_x_y_4_1.mul_add(y_0, y_1 * v_dot_2_of_x_y_4_0);
    let v_dot_3_1 = minus_k * v_dot_2_of_x_y_5_1;
    let u_dot_of_x_y_1 = v_dot_2_of_x_y_4_1.mul_add(x_0, x_1 * v_dot_2_of_x_y_4_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                x_1, y_1, v_dot_2_of_x_y_1, x_sq_plus_y_sq_1, v_dot_2_of_x_y_2_1, y_1, x_1,
            ]),
            padded([
                x_1, y_1, v_dot_2_of_x_y_1, v_dot_2_of_x_y_3_1, v_dot_2_of_x_y_3_1,
                v_dot_2_of_x_y_4_1, v_dot_2_of_x_y_4_1,
            ]),
        ];
    }
    let mut x_last = x_1;
    let mut y_last = y_1;
    let mut x_sq_plus_y_sq_last = x_sq_plus_y_sq_1;
    let mut v_dot_2_of_x_y_last = v_dot_2_of_x_y_1;
    let mut v_dot_2_of_x_y_2_last = v_dot_2_of_x_y_2_1;
    let mut v_dot_2_of_x_y_3_last = v_dot_2_of_x_y_3_1;
    let mut v_dot_2_of_x_y_4_last = v_dot_2_of_x_y_4_1;
    let mut next = [S::int(0); 8];
    // Rates at order k - 1.
    let mut x_rate = u_2_1;
    let mut y_rate = v_1;
    let mut u_2_rate = minus_k * u_dot_of_x_y_1;
    let mut v_rate = v_dot_3_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let x = x_rate * over_k;
        let y = y_rate * over_k;
        let u_2 = u_2_rate * over_k;
        let v = v_rate * over_k;
        series[order] = [x, y, u_2, v];
        if order + 1 == series.len() {
            break;
        }
        let sums = if order % 2 == 0 {
            // All convolutions of order k, and of order k + 1 but for the terms with coefficients of order
            //   k.
            let pair = pair_sums(&history[..order]);
            next = pair[1];
            pair[0]
        } else {
            // Those terms, which also have coefficients of order 1.
            padded([
                (x_1 + x_1).mul_add(x_last, next[0]),
                (y_1 + y_1).mul_add(y_last, next[1]),
                (v_dot_2_of_x_y_1 + v_dot_2_of_x_y_1)
                    .mul_add(v_dot_2_of_x_y_last, next[2]),
                x_sq_plus_y_sq_1
                    .mul_add(
                        v_dot_2_of_x_y_3_last,
                        x_sq_plus_y_sq_last.mul_add(v_dot_2_of_x_y_3_1, next[3]),
                    ),
                v_dot_2_of_x_y_2_1
                    .mul_add(
                        v_dot_2_of_x_y_3_last,
                        v_dot_2_of_x_y_2_last.mul_add(v_dot_2_of_x_y_3_1, next[4]),
                    ),
                y_1
                    .mul_add(
                        v_dot_2_of_x_y_4_last,
                        y_last.mul_add(v_dot_2_of_x_y_4_1, next[5]),
                    ),
                x_1
                    .mul_add(
                        v_dot_2_of_x_y_4_last,
                        x_last.mul_add(v_dot_2_of_x_y_4_1, next[6]),
                    ),
            ])
        };
        // x_sq = x*x
        let x_sq = x.mul_add(x_0 + x_0, sums[0]);
        // y_sq = y*y
        let y_sq = y.mul_add(y_0 + y_0, sums[1]);
        // x_sq_plus_y_sq = x_sq + y_sq
        let x_sq_plus_y_sq = x_sq + y_sq;
        // v_dot_2_of_x_y = sqrt(x_sq_plus_y_sq)
        let v_dot_2_of_x_y = (x_sq_plus_y_sq - sums[2]) * over_twice_v_dot_2_of_x_y;
        // v_dot_2_of_x_y_2 = -1 + v_dot_2_of_x_y
        let v_dot_2_of_x_y_2 = v_dot_2_of_x_y;
        // v_dot_2_of_x_y_3 = v_dot_2_of_x_y/x_sq_plus_y_sq
        let v_dot_2_of_x_y_3 = v_dot_2_of_x_y
            .mul_add(
                over_x_sq_plus_y_sq,
                -(x_sq_plus_y_sq.mul_add(v_dot_2_of_x_y_3_0, sums[3]) * over_x_sq_plus_y_sq),
            );
        // v_dot_2_of_x_y_4 = v_dot_2_of_x_y_2*v_dot_2_of_x_y_3
        let v_dot_2_of_x_y_4 = v_dot_2_of_x_y_3
            .mul_add(
                v_dot_2_of_x_y_2_0,
                v_dot_2_of_x_y_2.mul_add(v_dot_2_of_x_y_3_0, sums[4]),
            );
        // v_dot_2_of_x_y_5 = y*v_dot_2_of_x_y_4
        let v_dot_2_of_x_y_5 = v_dot_2_of_x_y_4
            .mul_add(y_0, y.mul_add(v_dot_2_of_x_y_4_0, sums[5]));
        // v_dot_3 = minus_g + minus_k*v_dot_2_of_x_y_5
        let v_dot_3 = minus_k * v_dot_2_of_x_y_5;
        // u_dot_of_x_y = x*v_dot_2_of_x_y_4
        let u_dot_of_x_y = v_dot_2_of_x_y_4
            .mul_add(x_0, x.mul_add(v_dot_2_of_x_y_4_0, sums[6]));
        x_rate = u_2;
        y_rate = v;
        u_2_rate = minus_k * u_dot_of_x_y;
        v_rate = v_dot_3;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([x, y, v_dot_2_of_x_y, x_sq_plus_y_sq, v_dot_2_of_x_y_2, y, x]),
            padded([
                x, y, v_dot_2_of_x_y, v_dot_2_of_x_y_3, v_dot_2_of_x_y_3, v_dot_2_of_x_y_4,
                v_dot_2_of_x_y_4,
            ]),
        ];
        x_last = x;
        y_last = y;
        x_sq_plus_y_sq_last = x_sq_plus_y_sq;
        v_dot_2_of_x_y_last = v_dot_2_of_x_y;
        v_dot_2_of_x_y_2_last = v_dot_2_of_x_y_2;
        v_dot_2_of_x_y_3_last = v_dot_2_of_x_y_3;
        v_dot_2_of_x_y_4_last = v_dot_2_of_x_y_4;
    }
}

/// Reduced equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Reduced;

impl<S: Scalar> System<S> for Reduced {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 2,
            coordinates: 2,
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
        4
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
        16 * order + SLACK
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
        ["x^2 + y^2"][at]
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
    name: "bouncing",
    key: "90f627c539702d95",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: None,
    },
};
