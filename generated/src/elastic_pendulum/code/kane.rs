//! Elastic pendulum: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/elastic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u, v.
///
/// 0 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 2],
    _u: &[S; 2],
) -> [[S; 2]; 2] {
    let Parameters { m, .. } = *p;
    // Entries that are not zero; upper triangle.
    // M11 = m
    let m11 = m;
    // M22 = m
    let m22 = m;
    let zero = S::int(0);
    [[m11, zero], [zero, m22]]
}

/// Right-hand side of the linear system; unknowns (u', v').
///
/// 11 operations, 1 other function.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 2]) -> [S; 2] {
    let Parameters { m, k, l, g } = *p;
    let [x, y] = *q;
    // Shared terms.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    let f1_of_x_y = x_sq_plus_y_sq.sqrt();
    // k*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(x^2 + y^2)
    let f1_of_k_l_x_y = k * f1_of_x_y * (l - f1_of_x_y) / x_sq_plus_y_sq;
    // Values.
    // f1 = k*x*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(x^2 + y^2)
    let f1 = x * f1_of_k_l_x_y;
    // f2 = k*y*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(x^2 + y^2) - m*g
    let f2 = (-m).mul_add(g, y * f1_of_k_l_x_y);
    [f1, f2]
}

/// The accelerations (u', v'), solved for when this code was generated.
///
/// 11 operations, 1 other function.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 2]) -> [S; 2] {
    let Parameters { m, k, l, g } = *p;
    let [x, y] = *q;
    // Elimination, step by step, each after the terms that it shares.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    let v_dot_2_of_x_y = x_sq_plus_y_sq.sqrt();
    // k*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2))
    let v_dot_2_of_m_k_l_x_y = k * v_dot_2_of_x_y * (l - v_dot_2_of_x_y) / (m * x_sq_plus_y_sq);
    // v' = k*y*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2)) - g
    let v_dot_2 = y.mul_add(v_dot_2_of_m_k_l_x_y, -g);
    // u' = k*x*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2))
    let u_dot = x * v_dot_2_of_m_k_l_x_y;
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
/// 5 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 2], u: &[S; 2]) -> S {
    let Parameters { m, .. } = *p;
    let [u_2, v] = *u;
    // Values.
    // T = m*u^2/2 + m*v^2/2
    let energy = S::ratio(1, 2) * m * v.mul_add(v, u_2 * u_2);
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 10 operations, 1 other function.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2]) -> S {
    let Parameters { m, k, l, g } = *p;
    let [x, y] = *q;
    // Values.
    // V = m*g*y + k*(l - sqrt(x^2 + y^2))^2/2
    let energy = S::ratio(1, 2) * k * (l - y.mul_add(y, x * x).sqrt()).powi(2) + m * g * y;
    energy
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
    let Parameters { m, k, l, g } = *p;
    let [x, y] = *q;
    let [u_2, v] = *u;
    // Elimination, step by step, each after the terms that it shares.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    let v_dot_2_of_x_y = x_sq_plus_y_sq.sqrt();
    // k*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2))
    let v_dot_2_of_m_k_l_x_y = k * v_dot_2_of_x_y * (l - v_dot_2_of_x_y) / (m * x_sq_plus_y_sq);
    // v' = k*y*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2)) - g
    let v_dot_2 = y.mul_add(v_dot_2_of_m_k_l_x_y, -g);
    // u' = k*x*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2))
    let u_dot = x * v_dot_2_of_m_k_l_x_y;
    // Values.
    // x' = u
    let x_dot_value = u_2;
    // y' = v
    let y_dot_value = v;
    ([x_dot_value, y_dot_value], [u_dot, v_dot_2])
}

/// Jacobian of the derivative by the state; columns x, y, u, v.
///
/// 20 operations, 1 other function.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 2]) -> [[S; 4]; 4] {
    let Parameters { m, k, l, .. } = *p;
    let [x, y] = *q;
    // Elimination, step by step, each after the terms that it shares.
    let y_sq = y * y;
    let x_sq = x * x;
    // 1/(x^2 + y_sq)
    let over_x_sq_plus_y_sq = S::int(1) / (x_sq + y_sq);
    let m_inv_k = k / m;
    // l*over_x_sq_plus_y_sq*m_inv_k*sqrt(x^2 + y^2)
    let v_dot_by_x_of_place = l * over_x_sq_plus_y_sq * m_inv_k * (x_sq + y_sq).sqrt();
    let v_dot_by_x_of_place_2 = over_x_sq_plus_y_sq * v_dot_by_x_of_place;
    let x_v_dot_by_x_of_place_2 = x * v_dot_by_x_of_place_2;
    let v_dot_by_x_of_place_3 = y * x_v_dot_by_x_of_place_2;
    // -v_dot_by_x_of_place_3
    let v_dot_by_x_of_place_4 = -v_dot_by_x_of_place_3;
    // v_dot_by_x = -k*l*x*y*sqrt(x^2 + y^2)/(m*(x^2 + y^2)^2)
    let v_dot_by_x = v_dot_by_x_of_place_4;
    // m_inv_k - v_dot_by_x_of_place
    let u_dot_by_x_of_place = m_inv_k - v_dot_by_x_of_place;
    // u_dot_by_x = -k*(x^2 + sqrt(x^2 + y^2)*(l*(x^2/(x^2 + y^2) - 1) + sqrt(x^2 + y^2)*(1 - x^2/(x^2 +
    //   y^2))))/(m*(x^2 + y^2))
    let u_dot_by_x = (-x).mul_add(x_v_dot_by_x_of_place_2, -u_dot_by_x_of_place);
    // v_dot_by_y = -k*(y^2 + sqrt(x^2 + y^2)*(l*(y^2/(x^2 + y^2) - 1) + sqrt(x^2 + y^2)*(1 - y^2/(x^2 +
    //   y^2))))/(m*(x^2 + y^2))
    let v_dot_by_y = (-y_sq).mul_add(v_dot_by_x_of_place_2, -u_dot_by_x_of_place);
    // u_dot_by_y = -k*l*x*y*sqrt(x^2 + y^2)/(m*(x^2 + y^2)^2)
    let u_dot_by_y = v_dot_by_x_of_place_4;
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

/// Inverse dynamics: the generalized forces along (u, v) that must act beside the loads of the model for the accelerations to be (u', v').
///
/// 14 operations, 1 other function.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _u: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { m, k, l, g } = *p;
    let [x, y] = *q;
    let [u_dot, v_dot_2] = *v_dot;
    // Shared terms.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    let tau1_of_x_y = x_sq_plus_y_sq.sqrt();
    // k*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(x^2 + y^2)
    let tau1_of_k_l_x_y = k * tau1_of_x_y * (l - tau1_of_x_y) / x_sq_plus_y_sq;
    // Values.
    // tau1 = k*x*sqrt(x^2 + y^2)*(sqrt(x^2 + y^2) - l)/(x^2 + y^2) + m*u'
    let tau1 = (-x).mul_add(tau1_of_k_l_x_y, m * u_dot);
    // tau2 = m*g + k*y*sqrt(x^2 + y^2)*(sqrt(x^2 + y^2) - l)/(x^2 + y^2) + m*v'
    let tau2 = m * (g + v_dot_2) - y * tau1_of_k_l_x_y;
    [tau1, tau2]
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
    let Parameters { m, k, l, g } = *p;
    let [x_0, y_0, u_2_0, v_0] = series[0];
    // Constant in time.
    // minus_g = -g
    let minus_g = -g;
    // k_by_m = k/m
    let k_by_m = k / m;
    // Order 0.
    let x_sq_0 = x_0 * x_0;
    let y_sq_0 = y_0 * y_0;
    let x_sq_plus_y_sq_0 = x_sq_0 + y_sq_0;
    let over_x_sq_plus_y_sq = S::int(1) / x_sq_plus_y_sq_0;
    let v_dot_2_of_x_y_0 = x_sq_plus_y_sq_0.sqrt();
    let over_twice_v_dot_2_of_x_y = S::int(1) / (v_dot_2_of_x_y_0 + v_dot_2_of_x_y_0);
    let v_dot_2_of_l_x_y_0 = l - v_dot_2_of_x_y_0;
    let v_dot_2_of_x_y_2_0 = v_dot_2_of_x_y_0 * over_x_sq_plus_y_sq;
    let v_dot_2_of_l_x_y_2_0 = v_dot_2_of_l_x_y_0 * v_dot_2_of_x_y_2_0;
    let v_dot_2_of_l_x_y_3_0 = y_0 * v_dot_2_of_l_x_y_2_0;
    let v_dot_3_0 = v_dot_2_of_l_x_y_3_0.mul_add(k_by_m, minus_g);
    let u_dot_of_l_x_y_0 = x_0 * v_dot_2_of_l_x_y_2_0;
    // Order 1: the rates, and what follows from them.
    let x_1 = u_2_0;
    let y_1 = v_0;
    let u_2_1 = k_by_m * u_dot_of_l_x_y_0;
    let v_1 = v_dot_3_0;
    if series.len() > 1 {
        series[1] = [x_1, y_1, u_2_1, v_1];
    }
    let x_sq_1 = x_1 * (x_0 + x_0);
    let y_sq_1 = y_1 * (y_0 + y_0);
    let x_sq_plus_y_sq_1 = x_sq_1 + y_sq_1;
    let v_dot_2_of_x_y_1 = x_sq_plus_y_sq_1 * over_twice_v_dot_2_of_x_y;
    let v_dot_2_of_l_x_y_1 = -v_dot_2_of_x_y_1;
    let v_dot_2_of_x_y_2_1 = x_sq_plus_y_sq_1
        .mul_add(
            -(v_dot_2_of_x_y_2_0 * over_x_sq_plus_y_sq),
            v_dot_2_of_x_y_1 * over_x_sq_plus_y_sq,
        );
    let v_dot_2_of_l_x_y_2_1 = v_dot_2_of_x_y_2_1
        .mul_add(v_dot_2_of_l_x_y_0, v_dot_2_of_l_x_y_1 * v_dot_2_of_x_y_2_0);
    let v_dot_2_of_l_x_y_3_1 = v_dot_2_of_l_x_y_2_1
        .mul_add(y_0, y_1 * v_dot_2_of_l_x_y_2_0);
    let v_dot_3_1 = k_by_m * v_dot_2_of_l_x_y_3_1;
    let u_dot_of_l_x_y_1 = v_dot_2_of_l_x_y_2_1.mul_add(x_0, x_1 * v_dot_2_of_l_x_y_2_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                x_1, y_1, v_dot_2_of_x_y_1, x_sq_plus_y_sq_1, v_dot_2_of_l_x_y_1, y_1, x_1,
            ]),
            padded([
                x_1, y_1, v_dot_2_of_x_y_1, v_dot_2_of_x_y_2_1, v_dot_2_of_x_y_2_1,
                v_dot_2_of_l_x_y_2_1, v_dot_2_of_l_x_y_2_1,
            ]),
        ];
    }
    let mut x_last = x_1;
    let mut y_last = y_1;
    let mut x_sq_plus_y_sq_last = x_sq_plus_y_sq_1;
    let mut v_dot_2_of_x_y_last = v_dot_2_of_x_y_1;
    let mut v_dot_2_of_l_x_y_last = v_dot_2_of_l_x_y_1;
    let mut v_dot_2_of_x_y_2_last = v_dot_2_of_x_y_2_1;
    let mut v_dot_2_of_l_x_y_2_last = v_dot_2_of_l_x_y_2_1;
    let mut next = [S::int(0); 8];
    // Rates at order k - 1.
    let mut x_rate = u_2_1;
    let mut y_rate = v_1;
    let mut u_2_rate = k_by_m * u_dot_of_l_x_y_1;
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
                        v_dot_2_of_x_y_2_last,
                        x_sq_plus_y_sq_last.mul_add(v_dot_2_of_x_y_2_1, next[3]),
                    ),
                v_dot_2_of_l_x_y_1
                    .mul_add(
                        v_dot_2_of_x_y_2_last,
                        v_dot_2_of_l_x_y_last.mul_add(v_dot_2_of_x_y_2_1, next[4]),
                    ),
                y_1
                    .mul_add(
                        v_dot_2_of_l_x_y_2_last,
                        y_last.mul_add(v_dot_2_of_l_x_y_2_1, next[5]),
                    ),
                x_1
                    .mul_add(
                        v_dot_2_of_l_x_y_2_last,
                        x_last.mul_add(v_dot_2_of_l_x_y_2_1, next[6]),
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
        // v_dot_2_of_l_x_y = l - v_dot_2_of_x_y
        let v_dot_2_of_l_x_y = -v_dot_2_of_x_y;
        // v_dot_2_of_x_y_2 = v_dot_2_of_x_y/x_sq_plus_y_sq
        let v_dot_2_of_x_y_2 = v_dot_2_of_x_y
            .mul_add(
                over_x_sq_plus_y_sq,
                -(x_sq_plus_y_sq.mul_add(v_dot_2_of_x_y_2_0, sums[3]) * over_x_sq_plus_y_sq),
            );
        // v_dot_2_of_l_x_y_2 = v_dot_2_of_l_x_y*v_dot_2_of_x_y_2
        let v_dot_2_of_l_x_y_2 = v_dot_2_of_x_y_2
            .mul_add(
                v_dot_2_of_l_x_y_0,
                v_dot_2_of_l_x_y.mul_add(v_dot_2_of_x_y_2_0, sums[4]),
            );
        // v_dot_2_of_l_x_y_3 = y*v_dot_2_of_l_x_y_2
        let v_dot_2_of_l_x_y_3 = v_dot_2_of_l_x_y_2
            .mul_add(y_0, y.mul_add(v_dot_2_of_l_x_y_2_0, sums[5]));
        // v_dot_3 = minus_g + k_by_m*v_dot_2_of_l_x_y_3
        let v_dot_3 = k_by_m * v_dot_2_of_l_x_y_3;
        // u_dot_of_l_x_y = x*v_dot_2_of_l_x_y_2
        let u_dot_of_l_x_y = v_dot_2_of_l_x_y_2
            .mul_add(x_0, x.mul_add(v_dot_2_of_l_x_y_2_0, sums[6]));
        x_rate = u_2;
        y_rate = v;
        u_2_rate = k_by_m * u_dot_of_l_x_y;
        v_rate = v_dot_3;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([x, y, v_dot_2_of_x_y, x_sq_plus_y_sq, v_dot_2_of_l_x_y, y, x]),
            padded([
                x, y, v_dot_2_of_x_y, v_dot_2_of_x_y_2, v_dot_2_of_x_y_2, v_dot_2_of_l_x_y_2,
                v_dot_2_of_l_x_y_2,
            ]),
        ];
        x_last = x;
        y_last = y;
        x_sq_plus_y_sq_last = x_sq_plus_y_sq;
        v_dot_2_of_x_y_last = v_dot_2_of_x_y;
        v_dot_2_of_l_x_y_last = v_dot_2_of_l_x_y;
        v_dot_2_of_x_y_2_last = v_dot_2_of_x_y_2;
        v_dot_2_of_l_x_y_2_last = v_dot_2_of_l_x_y_2;
    }
}

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 4,
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
    fn mass_matrix(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            mass_matrix(&Parameters::from_slice(p), array(q), array(v)).as_flattened(),
        );
    }
    fn forcing(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&forcing(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn output_count(&self) -> usize {
        4
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
