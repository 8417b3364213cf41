//! Elastic pendulum: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/elastic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows x, y.
///
/// 0 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 2],
    _q_dot: &[S; 2],
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

/// Right-hand side of the linear system; unknowns (x'', y'').
///
/// 11 operations, 1 other function.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _q_dot: &[S; 2]) -> [S; 2] {
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

/// The accelerations (x'', y''), solved for when this code was generated.
///
/// 11 operations, 1 other function.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _q_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { m, k, l, g } = *p;
    let [x, y] = *q;
    // Elimination, step by step, each after the terms that it shares.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    let y_ddot_of_x_y = x_sq_plus_y_sq.sqrt();
    // k*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2))
    let y_ddot_of_m_k_l_x_y = k * y_ddot_of_x_y * (l - y_ddot_of_x_y) / (m * x_sq_plus_y_sq);
    // y'' = k*y*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2)) - g
    let y_ddot = y.mul_add(y_ddot_of_m_k_l_x_y, -g);
    // x'' = k*x*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2))
    let x_ddot = x * y_ddot_of_m_k_l_x_y;
    [x_ddot, y_ddot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let [x_dot, y_dot] = *q_dot;
    // Values.
    // x'
    let x_dot_value = x_dot;
    // y'
    let y_dot_value = y_dot;
    [x_dot_value, y_dot_value]
}

/// Kinetic energy T.
///
/// 5 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 2], q_dot: &[S; 2]) -> S {
    let Parameters { m, .. } = *p;
    let [x_dot, y_dot] = *q_dot;
    // Values.
    // T = m*x'^2/2 + m*y'^2/2
    let energy = S::ratio(1, 2) * m * y_dot.mul_add(y_dot, x_dot * x_dot);
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 0 operations.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let [x_dot, y_dot] = *q_dot;
    // Values.
    // u = x'
    let u_value = x_dot;
    // v = y'
    let v_value = y_dot;
    [u_value, v_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 0 operations.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    _q_dot: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let [x_ddot, y_ddot] = *v_dot;
    // Values.
    // u' = x''
    let u_dot_value = x_ddot;
    // v' = y''
    let v_dot_value = y_ddot;
    [u_dot_value, v_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 0 operations.
#[must_use]
pub fn motion_variables<S: Scalar>(
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

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 11 operations, 1 other function.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let Parameters { m, k, l, g } = *p;
    let [x, y] = *q;
    let [x_dot, y_dot] = *q_dot;
    // Elimination, step by step, each after the terms that it shares.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    let y_ddot_of_x_y = x_sq_plus_y_sq.sqrt();
    // k*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2))
    let y_ddot_of_m_k_l_x_y = k * y_ddot_of_x_y * (l - y_ddot_of_x_y) / (m * x_sq_plus_y_sq);
    // y'' = k*y*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2)) - g
    let y_ddot = y.mul_add(y_ddot_of_m_k_l_x_y, -g);
    // x'' = k*x*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2))
    let x_ddot = x * y_ddot_of_m_k_l_x_y;
    // Values.
    // x'
    let x_dot_value = x_dot;
    // y'
    let y_dot_value = y_dot;
    ([x_dot_value, y_dot_value], [x_ddot, y_ddot])
}

/// Jacobian of the derivative by the state; columns x, y, x', y'.
///
/// 20 operations, 1 other function.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _q_dot: &[S; 2],
) -> [[S; 4]; 4] {
    let Parameters { m, k, l, .. } = *p;
    let [x, y] = *q;
    // Elimination, step by step, each after the terms that it shares.
    let y_sq = y * y;
    let x_sq = x * x;
    // 1/(x^2 + y_sq)
    let over_x_sq_plus_y_sq = S::int(1) / (x_sq + y_sq);
    let m_inv_k = k / m;
    // l*over_x_sq_plus_y_sq*m_inv_k*sqrt(x^2 + y^2)
    let y_ddot_by_x_of_place = l * over_x_sq_plus_y_sq * m_inv_k * (x_sq + y_sq).sqrt();
    let y_ddot_by_x_of_place_2 = over_x_sq_plus_y_sq * y_ddot_by_x_of_place;
    let x_y_ddot_by_x_of_place_2 = x * y_ddot_by_x_of_place_2;
    let y_ddot_by_x_of_place_3 = y * x_y_ddot_by_x_of_place_2;
    // -y_ddot_by_x_of_place_3
    let y_ddot_by_x_of_place_4 = -y_ddot_by_x_of_place_3;
    // y_ddot_by_x = -k*l*x*y*sqrt(x^2 + y^2)/(m*(x^2 + y^2)^2)
    let y_ddot_by_x = y_ddot_by_x_of_place_4;
    // m_inv_k - y_ddot_by_x_of_place
    let x_ddot_by_x_of_place = m_inv_k - y_ddot_by_x_of_place;
    // x_ddot_by_x = -k*(x^2 + sqrt(x^2 + y^2)*(l*(x^2/(x^2 + y^2) - 1) + sqrt(x^2 + y^2)*(1 - x^2/(x^2 +
    //   y^2))))/(m*(x^2 + y^2))
    let x_ddot_by_x = (-x).mul_add(x_y_ddot_by_x_of_place_2, -x_ddot_by_x_of_place);
    // y_ddot_by_y = -k*(y^2 + sqrt(x^2 + y^2)*(l*(y^2/(x^2 + y^2) - 1) + sqrt(x^2 + y^2)*(1 - y^2/(x^2 +
    //   y^2))))/(m*(x^2 + y^2))
    let y_ddot_by_y = (-y_sq).mul_add(y_ddot_by_x_of_place_2, -x_ddot_by_x_of_place);
    // x_ddot_by_y = -k*l*x*y*sqrt(x^2 + y^2)/(m*(x^2 + y^2)^2)
    let x_ddot_by_y = y_ddot_by_x_of_place_4;
    // Entries that are not zero.
    // d(x')/d(x') = 1
    let x_dot_by_x_dot_value = S::int(1);
    // d(y')/d(y') = 1
    let y_dot_by_y_dot_value = S::int(1);
    let zero = S::int(0);
    [
        [zero, zero, x_dot_by_x_dot_value, zero],
        [zero, zero, zero, y_dot_by_y_dot_value],
        [x_ddot_by_x, x_ddot_by_y, zero, zero],
        [y_ddot_by_x, y_ddot_by_y, zero, zero],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 3 operations.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 2], _q_dot: &[S; 2]) -> [S; 1] {
    let [x, y] = *q;
    // Values.
    // divisor1 = x^2 + y^2
    let divisor1 = y.mul_add(y, x * x);
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (x', y') that must act beside the loads of the model for the accelerations to be (x'', y'').
///
/// 14 operations, 1 other function.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _q_dot: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { m, k, l, g } = *p;
    let [x, y] = *q;
    let [x_ddot, y_ddot] = *v_dot;
    // Shared terms.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    let tau1_of_x_y = x_sq_plus_y_sq.sqrt();
    // k*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(x^2 + y^2)
    let tau1_of_k_l_x_y = k * tau1_of_x_y * (l - tau1_of_x_y) / x_sq_plus_y_sq;
    // Values.
    // tau1 = k*x*sqrt(x^2 + y^2)*(sqrt(x^2 + y^2) - l)/(x^2 + y^2) + m*x''
    let tau1 = (-x).mul_add(tau1_of_k_l_x_y, m * x_ddot);
    // tau2 = m*g + k*y*sqrt(x^2 + y^2)*(sqrt(x^2 + y^2) - l)/(x^2 + y^2) + m*y''
    let tau2 = m * (g + y_ddot) - y * tau1_of_k_l_x_y;
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
    let [x_0, y_0, x_dot_0, y_dot_0] = series[0];
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
    let y_ddot_of_x_y_0 = x_sq_plus_y_sq_0.sqrt();
    let over_twice_y_ddot_of_x_y = S::int(1) / (y_ddot_of_x_y_0 + y_ddot_of_x_y_0);
    let y_ddot_of_l_x_y_0 = l - y_ddot_of_x_y_0;
    let y_ddot_of_x_y_2_0 = y_ddot_of_x_y_0 * over_x_sq_plus_y_sq;
    let y_ddot_of_l_x_y_2_0 = y_ddot_of_l_x_y_0 * y_ddot_of_x_y_2_0;
    let y_ddot_of_l_x_y_3_0 = y_0 * y_ddot_of_l_x_y_2_0;
    let y_dot_dot_0 = y_ddot_of_l_x_y_3_0.mul_add(k_by_m, minus_g);
    let x_ddot_of_l_x_y_0 = x_0 * y_ddot_of_l_x_y_2_0;
    // Order 1: the rates, and what follows from them.
    let x_1 = x_dot_0;
    let y_1 = y_dot_0;
    let x_dot_1 = k_by_m * x_ddot_of_l_x_y_0;
    let y_dot_1 = y_dot_dot_0;
    if series.len() > 1 {
        series[1] = [x_1, y_1, x_dot_1, y_dot_1];
    }
    let x_sq_1 = x_1 * (x_0 + x_0);
    let y_sq_1 = y_1 * (y_0 + y_0);
    let x_sq_plus_y_sq_1 = x_sq_1 + y_sq_1;
    let y_ddot_of_x_y_1 = x_sq_plus_y_sq_1 * over_twice_y_ddot_of_x_y;
    let y_ddot_of_l_x_y_1 = -y_ddot_of_x_y_1;
    let y_ddot_of_x_y_2_1 = x_sq_plus_y_sq_1
        .mul_add(
            -(y_ddot_of_x_y_2_0 * over_x_sq_plus_y_sq),
            y_ddot_of_x_y_1 * over_x_sq_plus_y_sq,
        );
    let y_ddot_of_l_x_y_2_1 = y_ddot_of_x_y_2_1
        .mul_add(y_ddot_of_l_x_y_0, y_ddot_of_l_x_y_1 * y_ddot_of_x_y_2_0);
    let y_ddot_of_l_x_y_3_1 = y_ddot_of_l_x_y_2_1
        .mul_add(y_0, y_1 * y_ddot_of_l_x_y_2_0);
    let y_dot_dot_1 = k_by_m * y_ddot_of_l_x_y_3_1;
    let x_ddot_of_l_x_y_1 = y_ddot_of_l_x_y_2_1.mul_add(x_0, x_1 * y_ddot_of_l_x_y_2_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                x_1, y_1, y_ddot_of_x_y_1, x_sq_plus_y_sq_1, y_ddot_of_l_x_y_1, y_1, x_1,
            ]),
            padded([
                x_1, y_1, y_ddot_of_x_y_1, y_ddot_of_x_y_2_1, y_ddot_of_x_y_2_1,
                y_ddot_of_l_x_y_2_1, y_ddot_of_l_x_y_2_1,
            ]),
        ];
    }
    let mut x_last = x_1;
    let mut y_last = y_1;
    let mut x_sq_plus_y_sq_last = x_sq_plus_y_sq_1;
    let mut y_ddot_of_x_y_last = y_ddot_of_x_y_1;
    let mut y_ddot_of_l_x_y_last = y_ddot_of_l_x_y_1;
    let mut y_ddot_of_x_y_2_last = y_ddot_of_x_y_2_1;
    let mut y_ddot_of_l_x_y_2_last = y_ddot_of_l_x_y_2_1;
    let mut next = [S::int(0); 8];
    // Rates at order k - 1.
    let mut x_rate = x_dot_1;
    let mut y_rate = y_dot_1;
    let mut x_dot_rate = k_by_m * x_ddot_of_l_x_y_1;
    let mut y_dot_rate = y_dot_dot_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let x = x_rate * over_k;
        let y = y_rate * over_k;
        let x_dot = x_dot_rate * over_k;
        let y_dot = y_dot_rate * over_k;
        series[order] = [x, y, x_dot, y_dot];
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
                (y_ddot_of_x_y_1 + y_ddot_of_x_y_1).mul_add(y_ddot_of_x_y_last, next[2]),
                x_sq_plus_y_sq_1
                    .mul_add(
                        y_ddot_of_x_y_2_last,
                        x_sq_plus_y_sq_last.mul_add(y_ddot_of_x_y_2_1, next[3]),
                    ),
                y_ddot_of_l_x_y_1
                    .mul_add(
                        y_ddot_of_x_y_2_last,
                        y_ddot_of_l_x_y_last.mul_add(y_ddot_of_x_y_2_1, next[4]),
                    ),
                y_1
                    .mul_add(
                        y_ddot_of_l_x_y_2_last,
                        y_last.mul_add(y_ddot_of_l_x_y_2_1, next[5]),
                    ),
                x_1
                    .mul_add(
                        y_ddot_of_l_x_y_2_last,
                        x_last.mul_add(y_ddot_of_l_x_y_2_1, next[6]),
                    ),
            ])
        };
        // x_sq = x*x
        let x_sq = x.mul_add(x_0 + x_0, sums[0]);
        // y_sq = y*y
        let y_sq = y.mul_add(y_0 + y_0, sums[1]);
        // x_sq_plus_y_sq = x_sq + y_sq
        let x_sq_plus_y_sq = x_sq + y_sq;
        // y_ddot_of_x_y = sqrt(x_sq_plus_y_sq)
        let y_ddot_of_x_y = (x_sq_plus_y_sq - sums[2]) * over_twice_y_ddot_of_x_y;
        // y_ddot_of_l_x_y = l - y_ddot_of_x_y
        let y_ddot_of_l_x_y = -y_ddot_of_x_y;
        // y_ddot_of_x_y_2 = y_ddot_of_x_y/x_sq_plus_y_sq
        let y_ddot_of_x_y_2 = y_ddot_of_x_y
            .mul_add(
                over_x_sq_plus_y_sq,
                -(x_sq_plus_y_sq.mul_add(y_ddot_of_x_y_2_0, sums[3]) * over_x_sq_plus_y_sq),
            );
        // y_ddot_of_l_x_y_2 = y_ddot_of_l_x_y*y_ddot_of_x_y_2
        let y_ddot_of_l_x_y_2 = y_ddot_of_x_y_2
            .mul_add(
                y_ddot_of_l_x_y_0,
                y_ddot_of_l_x_y.mul_add(y_ddot_of_x_y_2_0, sums[4]),
            );
        // y_ddot_of_l_x_y_3 = y*y_ddot_of_l_x_y_2
        let y_ddot_of_l_x_y_3 = y_ddot_of_l_x_y_2
            .mul_add(y_0, y.mul_add(y_ddot_of_l_x_y_2_0, sums[5]));
        // y_dot_dot = minus_g + k_by_m*y_ddot_of_l_x_y_3
        let y_dot_dot = k_by_m * y_ddot_of_l_x_y_3;
        // x_ddot_of_l_x_y = x*y_ddot_of_l_x_y_2
        let x_ddot_of_l_x_y = y_ddot_of_l_x_y_2
            .mul_add(x_0, x.mul_add(y_ddot_of_l_x_y_2_0, sums[6]));
        x_rate = x_dot;
        y_rate = y_dot;
        x_dot_rate = k_by_m * x_ddot_of_l_x_y;
        y_dot_rate = y_dot_dot;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([x, y, y_ddot_of_x_y, x_sq_plus_y_sq, y_ddot_of_l_x_y, y, x]),
            padded([
                x, y, y_ddot_of_x_y, y_ddot_of_x_y_2, y_ddot_of_x_y_2, y_ddot_of_l_x_y_2,
                y_ddot_of_l_x_y_2,
            ]),
        ];
        x_last = x;
        y_last = y;
        x_sq_plus_y_sq_last = x_sq_plus_y_sq;
        y_ddot_of_x_y_last = y_ddot_of_x_y;
        y_ddot_of_l_x_y_last = y_ddot_of_l_x_y;
        y_ddot_of_x_y_2_last = y_ddot_of_x_y_2;
        y_ddot_of_l_x_y_2_last = y_ddot_of_l_x_y_2;
    }
}

/// Lagrange's equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Lagrange;

impl<S: Scalar> System<S> for Lagrange {
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
    fn generalized_speeds(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &generalized_speeds(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn generalized_speed_rates(
        &self,
        p: &[S],
        q: &[S],
        v: &[S],
        v_dot: &[S],
        out: &mut [S],
    ) {
        out.copy_from_slice(
            &generalized_speed_rates(
                &Parameters::from_slice(p),
                array(q),
                array(v),
                array(v_dot),
            ),
        );
    }
    fn motion_variables(&self, p: &[S], q: &[S], u: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &motion_variables(&Parameters::from_slice(p), array(q), array(u)),
        );
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
