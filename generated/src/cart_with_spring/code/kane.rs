//! Cart with spring: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/cart_with_spring/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows v.
///
/// 0 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 1],
    _u: &[S; 1],
) -> [[S; 1]; 1] {
    let Parameters { m, .. } = *p;
    // Entries that are not zero; upper triangle.
    // M11 = m
    let m11 = m;
    [[m11]]
}

/// Right-hand side of the linear system; unknowns (v').
///
/// 7 operations, 1 other function.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 1], u: &[S; 1]) -> [S; 1] {
    let Parameters { k, l, c, .. } = *p;
    let [x] = *q;
    let [v] = *u;
    // Values.
    // f1 = sqrt(x^2)*(k*(l - sqrt(x^2)) - c*v*sqrt(x^2)/x)/x
    let f1 = k * (l * (x * x).sqrt() / x - x) - c * v;
    [f1]
}

/// The accelerations (v'), solved for when this code was generated.
///
/// 9 operations, 1 other function.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 1], u: &[S; 1]) -> [S; 1] {
    let Parameters { m, k, l, c } = *p;
    let [x] = *q;
    let [v] = *u;
    // Elimination, step by step, each after the terms that it shares.
    let v_dot_2_of_x = (x * x).sqrt();
    let v_dot_2_of_x_2 = v_dot_2_of_x / x;
    // v' = sqrt(x^2)*(k*(l - sqrt(x^2)) - c*v*sqrt(x^2)/x)/(m*x)
    let v_dot_2 = v_dot_2_of_x_2 * (k * (l - v_dot_2_of_x) - c * v * v_dot_2_of_x_2) / m;
    [v_dot_2]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 1],
    u: &[S; 1],
) -> [S; 1] {
    let [v] = *u;
    // Values.
    // x' = v
    let x_dot_value = v;
    [x_dot_value]
}

/// Kinetic energy T.
///
/// 3 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 1], u: &[S; 1]) -> S {
    let Parameters { m, .. } = *p;
    let [v] = *u;
    // Values.
    // T = m*v^2/2
    let energy = S::ratio(1, 2) * m * v * v;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 5 operations, 1 other function.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 1]) -> S {
    let Parameters { k, l, .. } = *p;
    let [x] = *q;
    // Values.
    // V = k*(l - sqrt(x^2))^2/2
    let energy = S::ratio(1, 2) * k * (l - (x * x).sqrt()).powi(2);
    energy
}

/// The power of the loads that have no potential: the rate of T + V.
///
/// 3 operations.
#[must_use]
pub fn power<S: Scalar>(p: &Parameters<S>, _q: &[S; 1], u: &[S; 1]) -> S {
    let Parameters { c, .. } = *p;
    let [v] = *u;
    // Values.
    // d(T + V)/dt = -c*v^2
    let rate = -c * v * v;
    rate
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 9 operations, 1 other function.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 1],
    u: &[S; 1],
) -> ([S; 1], [S; 1]) {
    let Parameters { m, k, l, c } = *p;
    let [x] = *q;
    let [v] = *u;
    // Elimination, step by step, each after the terms that it shares.
    let v_dot_2_of_x = (x * x).sqrt();
    let v_dot_2_of_x_2 = v_dot_2_of_x / x;
    // v' = sqrt(x^2)*(k*(l - sqrt(x^2)) - c*v*sqrt(x^2)/x)/(m*x)
    let v_dot_2 = v_dot_2_of_x_2 * (k * (l - v_dot_2_of_x) - c * v * v_dot_2_of_x_2) / m;
    // Values.
    // x' = v
    let x_dot_value = v;
    ([x_dot_value], [v_dot_2])
}

/// Jacobian of the derivative by the state; columns x, v.
///
/// 5 operations.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, _q: &[S; 1], _u: &[S; 1]) -> [[S; 2]; 2] {
    let Parameters { m, k, c, .. } = *p;
    // Shared terms.
    let m_inv = S::int(1) / m;
    // Entries that are not zero.
    // d(x')/d(v) = 1
    let x_dot_by_v_value = S::int(1);
    // d(v')/d(x) = -k/m
    let v_dot_by_x_value = -k * m_inv;
    // d(v')/d(v) = -c/m
    let v_dot_by_v_value = -c * m_inv;
    let zero = S::int(0);
    [[zero, x_dot_by_v_value], [v_dot_by_x_value, v_dot_by_v_value]]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 1], _u: &[S; 1]) -> [S; 1] {
    let [x] = *q;
    // Values.
    // divisor1 = x
    let divisor1 = x;
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (v) that must act beside the loads of the model for the accelerations to be (v').
///
/// 9 operations, 1 other function.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 1],
    u: &[S; 1],
    v_dot: &[S; 1],
) -> [S; 1] {
    let Parameters { m, k, l, c } = *p;
    let [x] = *q;
    let [v] = *u;
    let [v_dot_2] = *v_dot;
    // Values.
    // tau1 = sqrt(x^2)*(c*v*sqrt(x^2)/x - k*(l - sqrt(x^2)))/x + m*v'
    let tau1 = k * (x - l * (x * x).sqrt() / x) + c * v + m * v_dot_2;
    [tau1]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 5 convolutions and 4 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 2]],
    history: &mut [Factors<S, 8>],
) {
    let Parameters { m, k, l, c } = *p;
    let [x_0, v_0] = series[0];
    // Constant in time.
    // k_l = k*l
    let k_l = k * l;
    // minus_k = -k
    let minus_k = -k;
    // minus_c = -c
    let minus_c = -c;
    // weight = 1/m
    let weight = S::int(1) / m;
    // Order 0.
    let over_x = S::int(1) / x_0;
    let x_sq_0 = x_0 * x_0;
    let v_dot_2_of_x_0 = x_sq_0.sqrt();
    let over_twice_v_dot_2_of_x = S::int(1) / (v_dot_2_of_x_0 + v_dot_2_of_x_0);
    let v_dot_2_of_x_2_0 = v_dot_2_of_x_0 * over_x;
    let v_dot_2_of_v_0 = v_0 * v_dot_2_of_x_2_0;
    let v_dot_2_of_v_2_0 = v_dot_2_of_v_0
        .mul_add(minus_c, v_dot_2_of_x_0.mul_add(minus_k, k_l));
    let v_dot_2_of_v_3_0 = v_dot_2_of_v_2_0 * v_dot_2_of_x_2_0;
    // Order 1: the rates, and what follows from them.
    let x_1 = v_0;
    let v_1 = weight * v_dot_2_of_v_3_0;
    if series.len() > 1 {
        series[1] = [x_1, v_1];
    }
    let x_sq_1 = x_1 * (x_0 + x_0);
    let v_dot_2_of_x_1 = x_sq_1 * over_twice_v_dot_2_of_x;
    let v_dot_2_of_x_2_1 = x_1
        .mul_add(-(v_dot_2_of_x_2_0 * over_x), v_dot_2_of_x_1 * over_x);
    let v_dot_2_of_v_1 = v_dot_2_of_x_2_1.mul_add(v_0, v_1 * v_dot_2_of_x_2_0);
    let v_dot_2_of_v_2_1 = v_dot_2_of_v_1.mul_add(minus_c, minus_k * v_dot_2_of_x_1);
    let v_dot_2_of_v_3_1 = v_dot_2_of_v_2_1
        .mul_add(v_dot_2_of_x_2_0, v_dot_2_of_x_2_1 * v_dot_2_of_v_2_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([x_1, v_dot_2_of_x_1, x_1, v_1, v_dot_2_of_v_2_1]),
            padded([
                x_1, v_dot_2_of_x_1, v_dot_2_of_x_2_1, v_dot_2_of_x_2_1, v_dot_2_of_x_2_1,
            ]),
        ];
    }
    let mut x_last = x_1;
    let mut v_last = v_1;
    let mut v_dot_2_of_x_last = v_dot_2_of_x_1;
    let mut v_dot_2_of_x_2_last = v_dot_2_of_x_2_1;
    let mut v_dot_2_of_v_2_last = v_dot_2_of_v_2_1;
    let mut next = [S::int(0); 8];
    // Rates at order k - 1.
    let mut x_rate = v_1;
    let mut v_rate = weight * v_dot_2_of_v_3_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let x = x_rate * over_k;
        let v = v_rate * over_k;
        series[order] = [x, v];
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
                (v_dot_2_of_x_1 + v_dot_2_of_x_1).mul_add(v_dot_2_of_x_last, next[1]),
                x_1
                    .mul_add(
                        v_dot_2_of_x_2_last,
                        x_last.mul_add(v_dot_2_of_x_2_1, next[2]),
                    ),
                v_1
                    .mul_add(
                        v_dot_2_of_x_2_last,
                        v_last.mul_add(v_dot_2_of_x_2_1, next[3]),
                    ),
                v_dot_2_of_v_2_1
                    .mul_add(
                        v_dot_2_of_x_2_last,
                        v_dot_2_of_v_2_last.mul_add(v_dot_2_of_x_2_1, next[4]),
                    ),
            ])
        };
        // x_sq = x*x
        let x_sq = x.mul_add(x_0 + x_0, sums[0]);
        // v_dot_2_of_x = sqrt(x_sq)
        let v_dot_2_of_x = (x_sq - sums[1]) * over_twice_v_dot_2_of_x;
        // v_dot_2_of_x_2 = v_dot_2_of_x/x
        let v_dot_2_of_x_2 = v_dot_2_of_x
            .mul_add(over_x, -(x.mul_add(v_dot_2_of_x_2_0, sums[2]) * over_x));
        // v_dot_2_of_v = v*v_dot_2_of_x_2
        let v_dot_2_of_v = v_dot_2_of_x_2
            .mul_add(v_0, v.mul_add(v_dot_2_of_x_2_0, sums[3]));
        // v_dot_2_of_v_2 = k_l + minus_k*v_dot_2_of_x + minus_c*v_dot_2_of_v
        let v_dot_2_of_v_2 = v_dot_2_of_v.mul_add(minus_c, minus_k * v_dot_2_of_x);
        // v_dot_2_of_v_3 = v_dot_2_of_v_2*v_dot_2_of_x_2
        let v_dot_2_of_v_3 = v_dot_2_of_v_2
            .mul_add(
                v_dot_2_of_x_2_0,
                v_dot_2_of_x_2.mul_add(v_dot_2_of_v_2_0, sums[4]),
            );
        x_rate = v;
        v_rate = weight * v_dot_2_of_v_3;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([x, v_dot_2_of_x, x, v, v_dot_2_of_v_2]),
            padded([x, v_dot_2_of_x, v_dot_2_of_x_2, v_dot_2_of_x_2, v_dot_2_of_x_2]),
        ];
        x_last = x;
        v_last = v;
        v_dot_2_of_x_last = v_dot_2_of_x;
        v_dot_2_of_x_2_last = v_dot_2_of_x_2;
        v_dot_2_of_v_2_last = v_dot_2_of_v_2;
    }
}

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 4,
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
    fn output_count(&self) -> usize {
        2
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
    fn has_power(&self) -> bool {
        true
    }
    fn power(&self, p: &[S], q: &[S], v: &[S]) -> S {
        power(&Parameters::from_slice(p), array(q), array(v))
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
        ["x"][at]
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
