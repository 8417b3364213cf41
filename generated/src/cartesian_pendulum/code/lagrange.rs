//! Pendulum in Cartesian coordinates: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/cartesian_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, pair_sums, rows};
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows x, y, constraint rod.
///
/// 4 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _q_dot: &[S; 2],
) -> [[S; 3]; 3] {
    let Parameters { m, .. } = *p;
    let [x, y] = *q;
    // Shared terms.
    let x_doubled = S::int(2) * x;
    let y_doubled = S::int(2) * y;
    // Entries that are not zero.
    // M11 = m
    let m11 = m;
    // M13 = -2*x
    let m13 = -x_doubled;
    // M22 = m
    let m22 = m;
    // M23 = -2*y
    let m23 = -y_doubled;
    // M31 = 2*x
    let m31 = x_doubled;
    // M32 = 2*y
    let m32 = y_doubled;
    let zero = S::int(0);
    [[m11, zero, m13], [zero, m22, m23], [m31, m32, zero]]
}

/// Right-hand side of the linear system; unknowns (x'', y'', lambda_rod).
///
/// 7 operations.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, _q: &[S; 2], q_dot: &[S; 2]) -> [S; 3] {
    let Parameters { m, g, .. } = *p;
    let [x_dot, y_dot] = *q_dot;
    // Shared terms.
    // x'^2 + y'^2
    let x_dot_sq_plus_y_dot_sq = y_dot.mul_add(y_dot, x_dot * x_dot);
    // Values.
    // f2 = -m*g
    let f2 = -m * g;
    // f3 = -2*x'^2 - 2*y'^2
    let f3 = -S::int(2) * x_dot_sq_plus_y_dot_sq;
    let zero = S::int(0);
    [zero, f2, f3]
}

/// The accelerations (x'', y''), solved for when this code was generated.
///
/// 42 operations.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { l, g, .. } = *p;
    let [x, y] = *q;
    let [x_dot, y_dot] = *q_dot;
    // Elimination, step by step, each after the terms that it shares.
    // 1/(x^2 + y^2)
    let over_x_sq_plus_y_sq = S::int(1) / y.mul_add(y, x * x);
    let y_over_x_sq_plus_y_sq = y * over_x_sq_plus_y_sq;
    // ratio_x_v = l*y/(x^2 + y^2)
    let ratio_x_v = l * y_over_x_sq_plus_y_sq;
    let x_over_x_sq_plus_y_sq = x * over_x_sq_plus_y_sq;
    // ratio_y_v = l*x/(x^2 + y^2)
    let ratio_y_v = l * x_over_x_sq_plus_y_sq;
    // x*y' - y*x'
    let x_y_dot_minus_y_x_dot = (-y).mul_add(x_dot, x * y_dot);
    let ratio_x_v_2_of_x_dot_y_dot = over_x_sq_plus_y_sq * x_y_dot_minus_y_x_dot;
    // x*ratio_x_v - y*ratio_y_v
    let ratio_x_v_2_of_place = (-y).mul_add(ratio_y_v, x * ratio_x_v);
    let ratio_x_v_2_of_x_dot_y_dot_2 = S::int(2) * ratio_x_v_2_of_x_dot_y_dot
        * ratio_x_v_2_of_place;
    // ratio_x_v_2 = ratio_y_v*(x*y' - y*x')/(x^2 + y^2) + 2*l*y*(x*ratio_x_v*(x*y' - y*x')/l +
    //   y*ratio_y_v*(y*x' - x*y')/l)/(x^2 + y^2)^2
    let ratio_x_v_2 = y_over_x_sq_plus_y_sq
        .mul_add(ratio_x_v_2_of_x_dot_y_dot_2, ratio_y_v * ratio_x_v_2_of_x_dot_y_dot);
    // ratio_y_v_2 = ratio_x_v*(x*y' - y*x')/(x^2 + y^2) - 2*l*x*(x*ratio_x_v*(x*y' - y*x')/l +
    //   y*ratio_y_v*(y*x' - x*y')/l)/(x^2 + y^2)^2
    let ratio_y_v_2 = (-x_over_x_sq_plus_y_sq)
        .mul_add(ratio_x_v_2_of_x_dot_y_dot_2, ratio_x_v * ratio_x_v_2_of_x_dot_y_dot);
    let v_dot_2_of_x_dot_y_dot = x_y_dot_minus_y_x_dot / l;
    // v' = (ratio_x_v*ratio_x_v_2*(y*x' - x*y') + ratio_y_v*(ratio_y_v_2*(x*y' - y*x') -
    //   l*g))/(l*(ratio_x_v^2 + ratio_y_v^2))
    let v_dot_2 = -(v_dot_2_of_x_dot_y_dot
        * (-ratio_y_v).mul_add(ratio_y_v_2, ratio_x_v * ratio_x_v_2) + g * ratio_y_v)
        / ratio_y_v.mul_add(ratio_y_v, ratio_x_v * ratio_x_v);
    // x'' = ratio_x_v_2*(y*x' - x*y')/l - v'*ratio_x_v
    let x_ddot = (-ratio_x_v_2).mul_add(v_dot_2_of_x_dot_y_dot, -v_dot_2 * ratio_x_v);
    // y'' = v'*ratio_y_v + ratio_y_v_2*(y*x' - x*y')/l
    let y_ddot = (-ratio_y_v_2).mul_add(v_dot_2_of_x_dot_y_dot, v_dot_2 * ratio_y_v);
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
/// 4 operations.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 1] {
    let Parameters { l, .. } = *p;
    let [x, y] = *q;
    let [x_dot, y_dot] = *q_dot;
    // Values.
    // v = (x*y' - y*x')/l
    let v_value = (-y).mul_add(x_dot, x * y_dot) / l;
    [v_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 4 operations.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _q_dot: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 1] {
    let Parameters { l, .. } = *p;
    let [x, y] = *q;
    let [x_ddot, y_ddot] = *v_dot;
    // Values.
    // v' = (x*y'' - y*x'')/l
    let v_dot_value = (-y).mul_add(x_ddot, x * y_ddot) / l;
    [v_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 9 operations.
#[must_use]
pub fn motion_variables<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> [S; 2] {
    let Parameters { l, .. } = *p;
    let [x, y] = *q;
    let [v] = *u;
    // Elimination, step by step, each after the terms that it shares.
    // l/(x^2 + y^2)
    let l_over_x_sq_plus_y_sq = l / y.mul_add(y, x * x);
    // ratio_x_v = l*y/(x^2 + y^2)
    let ratio_x_v = y * l_over_x_sq_plus_y_sq;
    // ratio_y_v = l*x/(x^2 + y^2)
    let ratio_y_v = x * l_over_x_sq_plus_y_sq;
    // Values.
    // x' = -v*ratio_x_v
    let x_dot_value = -v * ratio_x_v;
    // y' = v*ratio_y_v
    let y_dot_value = v * ratio_y_v;
    [x_dot_value, y_dot_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 42 operations.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let Parameters { l, g, .. } = *p;
    let [x, y] = *q;
    let [x_dot, y_dot] = *q_dot;
    // Elimination, step by step, each after the terms that it shares.
    // 1/(x^2 + y^2)
    let over_x_sq_plus_y_sq = S::int(1) / y.mul_add(y, x * x);
    let y_over_x_sq_plus_y_sq = y * over_x_sq_plus_y_sq;
    // ratio_x_v = l*y/(x^2 + y^2)
    let ratio_x_v = l * y_over_x_sq_plus_y_sq;
    let x_over_x_sq_plus_y_sq = x * over_x_sq_plus_y_sq;
    // ratio_y_v = l*x/(x^2 + y^2)
    let ratio_y_v = l * x_over_x_sq_plus_y_sq;
    // x*y' - y*x'
    let x_y_dot_minus_y_x_dot = (-y).mul_add(x_dot, x * y_dot);
    let ratio_x_v_2_of_x_dot_y_dot = over_x_sq_plus_y_sq * x_y_dot_minus_y_x_dot;
    // x*ratio_x_v - y*ratio_y_v
    let ratio_x_v_2_of_place = (-y).mul_add(ratio_y_v, x * ratio_x_v);
    let ratio_x_v_2_of_x_dot_y_dot_2 = S::int(2) * ratio_x_v_2_of_x_dot_y_dot
        * ratio_x_v_2_of_place;
    // ratio_x_v_2 = ratio_y_v*(x*y' - y*x')/(x^2 + y^2) + 2*l*y*(x*ratio_x_v*(x*y' - y*x')/l +
    //   y*ratio_y_v*(y*x' - x*y')/l)/(x^2 + y^2)^2
    let ratio_x_v_2 = y_over_x_sq_plus_y_sq
        .mul_add(ratio_x_v_2_of_x_dot_y_dot_2, ratio_y_v * ratio_x_v_2_of_x_dot_y_dot);
    // ratio_y_v_2 = ratio_x_v*(x*y' - y*x')/(x^2 + y^2) - 2*l*x*(x*ratio_x_v*(x*y' - y*x')/l +
    //   y*ratio_y_v*(y*x' - x*y')/l)/(x^2 + y^2)^2
    let ratio_y_v_2 = (-x_over_x_sq_plus_y_sq)
        .mul_add(ratio_x_v_2_of_x_dot_y_dot_2, ratio_x_v * ratio_x_v_2_of_x_dot_y_dot);
    let v_dot_2_of_x_dot_y_dot = x_y_dot_minus_y_x_dot / l;
    // v' = (ratio_x_v*ratio_x_v_2*(y*x' - x*y') + ratio_y_v*(ratio_y_v_2*(x*y' - y*x') -
    //   l*g))/(l*(ratio_x_v^2 + ratio_y_v^2))
    let v_dot_2 = -(v_dot_2_of_x_dot_y_dot
        * (-ratio_y_v).mul_add(ratio_y_v_2, ratio_x_v * ratio_x_v_2) + g * ratio_y_v)
        / ratio_y_v.mul_add(ratio_y_v, ratio_x_v * ratio_x_v);
    // x'' = ratio_x_v_2*(y*x' - x*y')/l - v'*ratio_x_v
    let x_ddot = (-ratio_x_v_2).mul_add(v_dot_2_of_x_dot_y_dot, -v_dot_2 * ratio_x_v);
    // y'' = v'*ratio_y_v + ratio_y_v_2*(y*x' - x*y')/l
    let y_ddot = (-ratio_y_v_2).mul_add(v_dot_2_of_x_dot_y_dot, v_dot_2 * ratio_y_v);
    // Values.
    // x'
    let x_dot_value = x_dot;
    // y'
    let y_dot_value = y_dot;
    ([x_dot_value, y_dot_value], [x_ddot, y_ddot])
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

/// What is zero where the constraints hold, each in its own unit.
///
/// 9 operations.
#[must_use]
pub fn constraints<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> [S; 2] {
    let Parameters { l, .. } = *p;
    let [x, y] = *q;
    let [x_dot, y_dot] = *q_dot;
    // Shared terms.
    // x*x' + y*y'
    let x_x_dot_plus_y_y_dot = y.mul_add(y_dot, x * x_dot);
    // Values.
    // rod = x^2 - l^2 + y^2
    let residual1 = (-l).mul_add(l, x * x) + y * y;
    // rod' = 2*x*x' + 2*y*y'
    let residual2 = S::int(2) * x_x_dot_plus_y_y_dot;
    [residual1, residual2]
}

/// Slopes of the constraints, one after the other, along x, y, x', y'.
///
/// 4 operations.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 8] {
    let [x, y] = *q;
    let [x_dot, y_dot] = *q_dot;
    // Shared terms.
    let y_doubled = S::int(2) * y;
    let x_doubled = S::int(2) * x;
    // Values.
    // d(rod)/d(x) = 2*x
    let residual1_by_x = x_doubled;
    // d(rod)/d(y) = 2*y
    let residual1_by_y = y_doubled;
    // d(rod')/d(x) = 2*x'
    let residual2_by_x = S::int(2) * x_dot;
    // d(rod')/d(y) = 2*y'
    let residual2_by_y = S::int(2) * y_dot;
    // d(rod')/d(x') = 2*x
    let residual2_by_x_dot = x_doubled;
    // d(rod')/d(y') = 2*y
    let residual2_by_y_dot = y_doubled;
    let zero = S::int(0);
    [
        residual1_by_x, residual1_by_y, zero, zero, residual2_by_x, residual2_by_y,
        residual2_by_x_dot, residual2_by_y_dot,
    ]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 24 convolutions and 38 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 4]],
    history: &mut [Factors<S, 24>],
) {
    let Parameters { l, g, .. } = *p;
    let [x_0, y_0, x_dot_0, y_dot_0] = series[0];
    // Constant in time.
    // weight = 2*l
    let weight = S::int(2) * l;
    // minus_2_l = -2*l
    let minus_2_l = -S::int(2) * l;
    // l_2 = l^2
    let l_2 = l * l;
    // minus_l_g = -l*g
    let minus_l_g = -l * g;
    // minus_l = -l
    let minus_l = -l;
    // minus_1_by_l = -1/l
    let minus_1_by_l = -S::int(1) / l;
    // Order 0.
    let x_sq_0 = x_0 * x_0;
    let y_sq_0 = y_0 * y_0;
    let x_sq_plus_y_sq_0 = x_sq_0 + y_sq_0;
    let over_x_sq_plus_y_sq = S::int(1) / x_sq_plus_y_sq_0;
    let y_over_x_sq_plus_y_sq_0 = y_0 * over_x_sq_plus_y_sq;
    let x_over_x_sq_plus_y_sq_0 = x_0 * over_x_sq_plus_y_sq;
    let x_y_dot_0 = x_0 * y_dot_0;
    let y_x_dot_0 = y_0 * x_dot_0;
    let x_y_dot_minus_y_x_dot_0 = x_y_dot_0 - y_x_dot_0;
    let ratio_x_v_2_of_x_dot_y_dot_0 = x_y_dot_minus_y_x_dot_0 * y_over_x_sq_plus_y_sq_0;
    let ratio_x_v_2_of_x_dot_y_dot_2_0 = x_0 * ratio_x_v_2_of_x_dot_y_dot_0;
    let ratio_x_v_2_of_x_dot_y_dot_3_0 = x_y_dot_minus_y_x_dot_0 * x_over_x_sq_plus_y_sq_0;
    let ratio_x_v_2_of_x_dot_y_dot_4_0 = y_0 * ratio_x_v_2_of_x_dot_y_dot_3_0;
    let ratio_x_v_2_of_x_dot_y_dot_5_0 = ratio_x_v_2_of_x_dot_y_dot_3_0 * over_x_sq_plus_y_sq;
    let ratio_x_v_2_of_x_dot_y_dot_6_0 = ratio_x_v_2_of_x_dot_y_dot_2_0
        - ratio_x_v_2_of_x_dot_y_dot_4_0;
    let ratio_x_v_2_of_x_dot_y_dot_7_0 = ratio_x_v_2_of_x_dot_y_dot_6_0 * over_x_sq_plus_y_sq;
    let ratio_x_v_2_of_x_dot_y_dot_8_0 = y_over_x_sq_plus_y_sq_0 * ratio_x_v_2_of_x_dot_y_dot_7_0;
    let ratio_x_v_2_of_x_dot_y_dot_9_0 = ratio_x_v_2_of_x_dot_y_dot_8_0
        .mul_add(weight, l * ratio_x_v_2_of_x_dot_y_dot_5_0);
    let ratio_y_v_2_of_x_dot_y_dot_0 = ratio_x_v_2_of_x_dot_y_dot_0 * over_x_sq_plus_y_sq;
    let ratio_y_v_2_of_x_dot_y_dot_2_0 = x_over_x_sq_plus_y_sq_0 * ratio_x_v_2_of_x_dot_y_dot_7_0;
    let ratio_y_v_2_of_x_dot_y_dot_3_0 = ratio_y_v_2_of_x_dot_y_dot_2_0
        .mul_add(minus_2_l, l * ratio_y_v_2_of_x_dot_y_dot_0);
    let v_dot_2_of_x_y_0 = y_over_x_sq_plus_y_sq_0 * y_over_x_sq_plus_y_sq_0;
    let v_dot_2_of_x_y_2_0 = x_over_x_sq_plus_y_sq_0 * x_over_x_sq_plus_y_sq_0;
    let v_dot_2_of_place_0 = v_dot_2_of_x_y_2_0.mul_add(l_2, l_2 * v_dot_2_of_x_y_0);
    let over_v_dot_2_of_place = S::int(1) / v_dot_2_of_place_0;
    let v_dot_2_of_x_dot_y_dot_0 = x_y_dot_minus_y_x_dot_0 * ratio_y_v_2_of_x_dot_y_dot_3_0;
    let v_dot_2_of_x_dot_y_dot_2_0 = minus_l_g + v_dot_2_of_x_dot_y_dot_0;
    let v_dot_2_of_x_dot_y_dot_3_0 = x_over_x_sq_plus_y_sq_0 * v_dot_2_of_x_dot_y_dot_2_0;
    let v_dot_2_of_x_dot_y_dot_4_0 = ratio_x_v_2_of_x_dot_y_dot_9_0 * ratio_x_v_2_of_x_dot_y_dot_0;
    let v_dot_2_of_x_dot_y_dot_5_0 = v_dot_2_of_x_dot_y_dot_3_0
        .mul_add(l, minus_l * v_dot_2_of_x_dot_y_dot_4_0);
    let v_dot_2_of_x_dot_y_dot_6_0 = v_dot_2_of_x_dot_y_dot_5_0 * over_v_dot_2_of_place;
    let x_ddot_of_x_dot_y_dot_0 = x_y_dot_minus_y_x_dot_0 * ratio_x_v_2_of_x_dot_y_dot_9_0;
    let x_ddot_of_x_dot_y_dot_2_0 = v_dot_2_of_x_dot_y_dot_6_0 * y_over_x_sq_plus_y_sq_0;
    let x_dot_dot_0 = minus_1_by_l * x_ddot_of_x_dot_y_dot_0 - x_ddot_of_x_dot_y_dot_2_0;
    let y_ddot_of_x_dot_y_dot_0 = v_dot_2_of_x_dot_y_dot_6_0 * x_over_x_sq_plus_y_sq_0;
    let y_dot_dot_0 = minus_1_by_l * v_dot_2_of_x_dot_y_dot_0 + y_ddot_of_x_dot_y_dot_0;
    // Order 1: the rates, and what follows from them.
    let x_1 = x_dot_0;
    let y_1 = y_dot_0;
    let x_dot_1 = x_dot_dot_0;
    let y_dot_1 = y_dot_dot_0;
    if series.len() > 1 {
        series[1] = [x_1, y_1, x_dot_1, y_dot_1];
    }
    let x_sq_1 = x_1 * (x_0 + x_0);
    let y_sq_1 = y_1 * (y_0 + y_0);
    let x_sq_plus_y_sq_1 = x_sq_1 + y_sq_1;
    let y_over_x_sq_plus_y_sq_1 = x_sq_plus_y_sq_1
        .mul_add(
            -(y_over_x_sq_plus_y_sq_0 * over_x_sq_plus_y_sq),
            y_1 * over_x_sq_plus_y_sq,
        );
    let x_over_x_sq_plus_y_sq_1 = x_sq_plus_y_sq_1
        .mul_add(
            -(x_over_x_sq_plus_y_sq_0 * over_x_sq_plus_y_sq),
            x_1 * over_x_sq_plus_y_sq,
        );
    let x_y_dot_1 = y_dot_1.mul_add(x_0, x_1 * y_dot_0);
    let y_x_dot_1 = x_dot_1.mul_add(y_0, y_1 * x_dot_0);
    let x_y_dot_minus_y_x_dot_1 = x_y_dot_1 - y_x_dot_1;
    let ratio_x_v_2_of_x_dot_y_dot_1 = y_over_x_sq_plus_y_sq_1
        .mul_add(
            x_y_dot_minus_y_x_dot_0,
            x_y_dot_minus_y_x_dot_1 * y_over_x_sq_plus_y_sq_0,
        );
    let ratio_x_v_2_of_x_dot_y_dot_2_1 = ratio_x_v_2_of_x_dot_y_dot_1
        .mul_add(x_0, x_1 * ratio_x_v_2_of_x_dot_y_dot_0);
    let ratio_x_v_2_of_x_dot_y_dot_3_1 = x_over_x_sq_plus_y_sq_1
        .mul_add(
            x_y_dot_minus_y_x_dot_0,
            x_y_dot_minus_y_x_dot_1 * x_over_x_sq_plus_y_sq_0,
        );
    let ratio_x_v_2_of_x_dot_y_dot_4_1 = ratio_x_v_2_of_x_dot_y_dot_3_1
        .mul_add(y_0, y_1 * ratio_x_v_2_of_x_dot_y_dot_3_0);
    let ratio_x_v_2_of_x_dot_y_dot_5_1 = x_sq_plus_y_sq_1
        .mul_add(
            -(ratio_x_v_2_of_x_dot_y_dot_5_0 * over_x_sq_plus_y_sq),
            ratio_x_v_2_of_x_dot_y_dot_3_1 * over_x_sq_plus_y_sq,
        );
    let ratio_x_v_2_of_x_dot_y_dot_6_1 = ratio_x_v_2_of_x_dot_y_dot_2_1
        - ratio_x_v_2_of_x_dot_y_dot_4_1;
    let ratio_x_v_2_of_x_dot_y_dot_7_1 = x_sq_plus_y_sq_1
        .mul_add(
            -(ratio_x_v_2_of_x_dot_y_dot_7_0 * over_x_sq_plus_y_sq),
            ratio_x_v_2_of_x_dot_y_dot_6_1 * over_x_sq_plus_y_sq,
        );
    let ratio_x_v_2_of_x_dot_y_dot_8_1 = ratio_x_v_2_of_x_dot_y_dot_7_1
        .mul_add(
            y_over_x_sq_plus_y_sq_0,
            y_over_x_sq_plus_y_sq_1 * ratio_x_v_2_of_x_dot_y_dot_7_0,
        );
    let ratio_x_v_2_of_x_dot_y_dot_9_1 = ratio_x_v_2_of_x_dot_y_dot_8_1
        .mul_add(weight, l * ratio_x_v_2_of_x_dot_y_dot_5_1);
    let ratio_y_v_2_of_x_dot_y_dot_1 = x_sq_plus_y_sq_1
        .mul_add(
            -(ratio_y_v_2_of_x_dot_y_dot_0 * over_x_sq_plus_y_sq),
            ratio_x_v_2_of_x_dot_y_dot_1 * over_x_sq_plus_y_sq,
        );
    let ratio_y_v_2_of_x_dot_y_dot_2_1 = ratio_x_v_2_of_x_dot_y_dot_7_1
        .mul_add(
            x_over_x_sq_plus_y_sq_0,
            x_over_x_sq_plus_y_sq_1 * ratio_x_v_2_of_x_dot_y_dot_7_0,
        );
    let ratio_y_v_2_of_x_dot_y_dot_3_1 = ratio_y_v_2_of_x_dot_y_dot_2_1
        .mul_add(minus_2_l, l * ratio_y_v_2_of_x_dot_y_dot_1);
    let v_dot_2_of_x_y_1 = y_over_x_sq_plus_y_sq_1
        * (y_over_x_sq_plus_y_sq_0 + y_over_x_sq_plus_y_sq_0);
    let v_dot_2_of_x_y_2_1 = x_over_x_sq_plus_y_sq_1
        * (x_over_x_sq_plus_y_sq_0 + x_over_x_sq_plus_y_sq_0);
    let v_dot_2_of_place_1 = v_dot_2_of_x_y_2_1.mul_add(l_2, l_2 * v_dot_2_of_x_y_1);
    let v_dot_2_of_x_dot_y_dot_1 = ratio_y_v_2_of_x_dot_y_dot_3_1
        .mul_add(
            x_y_dot_minus_y_x_dot_0,
            x_y_dot_minus_y_x_dot_1 * ratio_y_v_2_of_x_dot_y_dot_3_0,
        );
    let v_dot_2_of_x_dot_y_dot_2_1 = v_dot_2_of_x_dot_y_dot_1;
    let v_dot_2_of_x_dot_y_dot_3_1 = v_dot_2_of_x_dot_y_dot_2_1
        .mul_add(
            x_over_x_sq_plus_y_sq_0,
            x_over_x_sq_plus_y_sq_1 * v_dot_2_of_x_dot_y_dot_2_0,
        );
    let v_dot_2_of_x_dot_y_dot_4_1 = ratio_x_v_2_of_x_dot_y_dot_9_1
        .mul_add(
            ratio_x_v_2_of_x_dot_y_dot_0,
            ratio_x_v_2_of_x_dot_y_dot_1 * ratio_x_v_2_of_x_dot_y_dot_9_0,
        );
    let v_dot_2_of_x_dot_y_dot_5_1 = v_dot_2_of_x_dot_y_dot_3_1
        .mul_add(l, minus_l * v_dot_2_of_x_dot_y_dot_4_1);
    let v_dot_2_of_x_dot_y_dot_6_1 = v_dot_2_of_place_1
        .mul_add(
            -(v_dot_2_of_x_dot_y_dot_6_0 * over_v_dot_2_of_place),
            v_dot_2_of_x_dot_y_dot_5_1 * over_v_dot_2_of_place,
        );
    let x_ddot_of_x_dot_y_dot_1 = ratio_x_v_2_of_x_dot_y_dot_9_1
        .mul_add(
            x_y_dot_minus_y_x_dot_0,
            x_y_dot_minus_y_x_dot_1 * ratio_x_v_2_of_x_dot_y_dot_9_0,
        );
    let x_ddot_of_x_dot_y_dot_2_1 = v_dot_2_of_x_dot_y_dot_6_1
        .mul_add(
            y_over_x_sq_plus_y_sq_0,
            y_over_x_sq_plus_y_sq_1 * v_dot_2_of_x_dot_y_dot_6_0,
        );
    let x_dot_dot_1 = minus_1_by_l * x_ddot_of_x_dot_y_dot_1 - x_ddot_of_x_dot_y_dot_2_1;
    let y_ddot_of_x_dot_y_dot_1 = v_dot_2_of_x_dot_y_dot_6_1
        .mul_add(
            x_over_x_sq_plus_y_sq_0,
            x_over_x_sq_plus_y_sq_1 * v_dot_2_of_x_dot_y_dot_6_0,
        );
    let y_dot_dot_1 = minus_1_by_l * v_dot_2_of_x_dot_y_dot_1 + y_ddot_of_x_dot_y_dot_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            [
                x_1, y_1, x_sq_plus_y_sq_1, x_sq_plus_y_sq_1, x_1, y_1, x_y_dot_minus_y_x_dot_1,
                x_1, x_y_dot_minus_y_x_dot_1, y_1, x_sq_plus_y_sq_1, x_sq_plus_y_sq_1,
                y_over_x_sq_plus_y_sq_1, x_sq_plus_y_sq_1, x_over_x_sq_plus_y_sq_1,
                y_over_x_sq_plus_y_sq_1, x_over_x_sq_plus_y_sq_1, x_y_dot_minus_y_x_dot_1,
                x_over_x_sq_plus_y_sq_1, ratio_x_v_2_of_x_dot_y_dot_9_1, v_dot_2_of_place_1,
                x_y_dot_minus_y_x_dot_1, v_dot_2_of_x_dot_y_dot_6_1, v_dot_2_of_x_dot_y_dot_6_1,
            ],
            [
                x_1, y_1, y_over_x_sq_plus_y_sq_1, x_over_x_sq_plus_y_sq_1, y_dot_1, x_dot_1,
                y_over_x_sq_plus_y_sq_1, ratio_x_v_2_of_x_dot_y_dot_1, x_over_x_sq_plus_y_sq_1,
                ratio_x_v_2_of_x_dot_y_dot_3_1, ratio_x_v_2_of_x_dot_y_dot_5_1,
                ratio_x_v_2_of_x_dot_y_dot_7_1, ratio_x_v_2_of_x_dot_y_dot_7_1,
                ratio_y_v_2_of_x_dot_y_dot_1, ratio_x_v_2_of_x_dot_y_dot_7_1,
                y_over_x_sq_plus_y_sq_1, x_over_x_sq_plus_y_sq_1, ratio_y_v_2_of_x_dot_y_dot_3_1,
                v_dot_2_of_x_dot_y_dot_2_1, ratio_x_v_2_of_x_dot_y_dot_1,
                v_dot_2_of_x_dot_y_dot_6_1, ratio_x_v_2_of_x_dot_y_dot_9_1, y_over_x_sq_plus_y_sq_1,
                x_over_x_sq_plus_y_sq_1,
            ],
        ];
    }
    let mut x_last = x_1;
    let mut y_last = y_1;
    let mut x_dot_last = x_dot_1;
    let mut y_dot_last = y_dot_1;
    let mut x_sq_plus_y_sq_last = x_sq_plus_y_sq_1;
    let mut y_over_x_sq_plus_y_sq_last = y_over_x_sq_plus_y_sq_1;
    let mut x_over_x_sq_plus_y_sq_last = x_over_x_sq_plus_y_sq_1;
    let mut x_y_dot_minus_y_x_dot_last = x_y_dot_minus_y_x_dot_1;
    let mut ratio_x_v_2_of_x_dot_y_dot_last = ratio_x_v_2_of_x_dot_y_dot_1;
    let mut ratio_x_v_2_of_x_dot_y_dot_3_last = ratio_x_v_2_of_x_dot_y_dot_3_1;
    let mut ratio_x_v_2_of_x_dot_y_dot_5_last = ratio_x_v_2_of_x_dot_y_dot_5_1;
    let mut ratio_x_v_2_of_x_dot_y_dot_7_last = ratio_x_v_2_of_x_dot_y_dot_7_1;
    let mut ratio_x_v_2_of_x_dot_y_dot_9_last = ratio_x_v_2_of_x_dot_y_dot_9_1;
    let mut ratio_y_v_2_of_x_dot_y_dot_last = ratio_y_v_2_of_x_dot_y_dot_1;
    let mut ratio_y_v_2_of_x_dot_y_dot_3_last = ratio_y_v_2_of_x_dot_y_dot_3_1;
    let mut v_dot_2_of_place_last = v_dot_2_of_place_1;
    let mut v_dot_2_of_x_dot_y_dot_2_last = v_dot_2_of_x_dot_y_dot_2_1;
    let mut v_dot_2_of_x_dot_y_dot_6_last = v_dot_2_of_x_dot_y_dot_6_1;
    let mut next = [S::int(0); 24];
    // Rates at order k - 1.
    let mut x_rate = x_dot_1;
    let mut y_rate = y_dot_1;
    let mut x_dot_rate = x_dot_dot_1;
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
            [
                (x_1 + x_1).mul_add(x_last, next[0]),
                (y_1 + y_1).mul_add(y_last, next[1]),
                x_sq_plus_y_sq_1
                    .mul_add(
                        y_over_x_sq_plus_y_sq_last,
                        x_sq_plus_y_sq_last.mul_add(y_over_x_sq_plus_y_sq_1, next[2]),
                    ),
                x_sq_plus_y_sq_1
                    .mul_add(
                        x_over_x_sq_plus_y_sq_last,
                        x_sq_plus_y_sq_last.mul_add(x_over_x_sq_plus_y_sq_1, next[3]),
                    ),
                x_1.mul_add(y_dot_last, x_last.mul_add(y_dot_1, next[4])),
                y_1.mul_add(x_dot_last, y_last.mul_add(x_dot_1, next[5])),
                x_y_dot_minus_y_x_dot_1
                    .mul_add(
                        y_over_x_sq_plus_y_sq_last,
                        x_y_dot_minus_y_x_dot_last
                            .mul_add(y_over_x_sq_plus_y_sq_1, next[6]),
                    ),
                x_1
                    .mul_add(
                        ratio_x_v_2_of_x_dot_y_dot_last,
                        x_last.mul_add(ratio_x_v_2_of_x_dot_y_dot_1, next[7]),
                    ),
                x_y_dot_minus_y_x_dot_1
                    .mul_add(
                        x_over_x_sq_plus_y_sq_last,
                        x_y_dot_minus_y_x_dot_last
                            .mul_add(x_over_x_sq_plus_y_sq_1, next[8]),
                    ),
                y_1
                    .mul_add(
                        ratio_x_v_2_of_x_dot_y_dot_3_last,
                        y_last.mul_add(ratio_x_v_2_of_x_dot_y_dot_3_1, next[9]),
                    ),
                x_sq_plus_y_sq_1
                    .mul_add(
                        ratio_x_v_2_of_x_dot_y_dot_5_last,
                        x_sq_plus_y_sq_last
                            .mul_add(ratio_x_v_2_of_x_dot_y_dot_5_1, next[10]),
                    ),
                x_sq_plus_y_sq_1
                    .mul_add(
                        ratio_x_v_2_of_x_dot_y_dot_7_last,
                        x_sq_plus_y_sq_last
                            .mul_add(ratio_x_v_2_of_x_dot_y_dot_7_1, next[11]),
                    ),
                y_over_x_sq_plus_y_sq_1
                    .mul_add(
                        ratio_x_v_2_of_x_dot_y_dot_7_last,
                        y_over_x_sq_plus_y_sq_last
                            .mul_add(ratio_x_v_2_of_x_dot_y_dot_7_1, next[12]),
                    ),
                x_sq_plus_y_sq_1
                    .mul_add(
                        ratio_y_v_2_of_x_dot_y_dot_last,
                        x_sq_plus_y_sq_last
                            .mul_add(ratio_y_v_2_of_x_dot_y_dot_1, next[13]),
                    ),
                x_over_x_sq_plus_y_sq_1
                    .mul_add(
                        ratio_x_v_2_of_x_dot_y_dot_7_last,
                        x_over_x_sq_plus_y_sq_last
                            .mul_add(ratio_x_v_2_of_x_dot_y_dot_7_1, next[14]),
                    ),
                (y_over_x_sq_plus_y_sq_1 + y_over_x_sq_plus_y_sq_1)
                    .mul_add(y_over_x_sq_plus_y_sq_last, next[15]),
                (x_over_x_sq_plus_y_sq_1 + x_over_x_sq_plus_y_sq_1)
                    .mul_add(x_over_x_sq_plus_y_sq_last, next[16]),
                x_y_dot_minus_y_x_dot_1
                    .mul_add(
                        ratio_y_v_2_of_x_dot_y_dot_3_last,
                        x_y_dot_minus_y_x_dot_last
                            .mul_add(ratio_y_v_2_of_x_dot_y_dot_3_1, next[17]),
                    ),
                x_over_x_sq_plus_y_sq_1
                    .mul_add(
                        v_dot_2_of_x_dot_y_dot_2_last,
                        x_over_x_sq_plus_y_sq_last
                            .mul_add(v_dot_2_of_x_dot_y_dot_2_1, next[18]),
                    ),
                ratio_x_v_2_of_x_dot_y_dot_9_1
                    .mul_add(
                        ratio_x_v_2_of_x_dot_y_dot_last,
                        ratio_x_v_2_of_x_dot_y_dot_9_last
                            .mul_add(ratio_x_v_2_of_x_dot_y_dot_1, next[19]),
                    ),
                v_dot_2_of_place_1
                    .mul_add(
                        v_dot_2_of_x_dot_y_dot_6_last,
                        v_dot_2_of_place_last
                            .mul_add(v_dot_2_of_x_dot_y_dot_6_1, next[20]),
                    ),
                x_y_dot_minus_y_x_dot_1
                    .mul_add(
                        ratio_x_v_2_of_x_dot_y_dot_9_last,
                        x_y_dot_minus_y_x_dot_last
                            .mul_add(ratio_x_v_2_of_x_dot_y_dot_9_1, next[21]),
                    ),
                v_dot_2_of_x_dot_y_dot_6_1
                    .mul_add(
                        y_over_x_sq_plus_y_sq_last,
                        v_dot_2_of_x_dot_y_dot_6_last
                            .mul_add(y_over_x_sq_plus_y_sq_1, next[22]),
                    ),
                v_dot_2_of_x_dot_y_dot_6_1
                    .mul_add(
                        x_over_x_sq_plus_y_sq_last,
                        v_dot_2_of_x_dot_y_dot_6_last
                            .mul_add(x_over_x_sq_plus_y_sq_1, next[23]),
                    ),
            ]
        };
        // x_sq = x*x
        let x_sq = x.mul_add(x_0 + x_0, sums[0]);
        // y_sq = y*y
        let y_sq = y.mul_add(y_0 + y_0, sums[1]);
        // x_sq_plus_y_sq = x_sq + y_sq
        let x_sq_plus_y_sq = x_sq + y_sq;
        // y_over_x_sq_plus_y_sq = y/x_sq_plus_y_sq
        let y_over_x_sq_plus_y_sq = x_sq_plus_y_sq
            .mul_add(
                -(y_over_x_sq_plus_y_sq_0 * over_x_sq_plus_y_sq),
                (y - sums[2]) * over_x_sq_plus_y_sq,
            );
        // x_over_x_sq_plus_y_sq = x/x_sq_plus_y_sq
        let x_over_x_sq_plus_y_sq = x_sq_plus_y_sq
            .mul_add(
                -(x_over_x_sq_plus_y_sq_0 * over_x_sq_plus_y_sq),
                (x - sums[3]) * over_x_sq_plus_y_sq,
            );
        // x_y_dot = x*y_dot
        let x_y_dot = y_dot.mul_add(x_0, x.mul_add(y_dot_0, sums[4]));
        // y_x_dot = y*x_dot
        let y_x_dot = x_dot.mul_add(y_0, y.mul_add(x_dot_0, sums[5]));
        // x_y_dot_minus_y_x_dot = x_y_dot - y_x_dot
        let x_y_dot_minus_y_x_dot = x_y_dot - y_x_dot;
        // ratio_x_v_2_of_x_dot_y_dot = x_y_dot_minus_y_x_dot*y_over_x_sq_plus_y_sq
        let ratio_x_v_2_of_x_dot_y_dot = y_over_x_sq_plus_y_sq
            .mul_add(
                x_y_dot_minus_y_x_dot_0,
                x_y_dot_minus_y_x_dot.mul_add(y_over_x_sq_plus_y_sq_0, sums[6]),
            );
        // ratio_x_v_2_of_x_dot_y_dot_2 = x*ratio_x_v_2_of_x_dot_y_dot
        let ratio_x_v_2_of_x_dot_y_dot_2 = ratio_x_v_2_of_x_dot_y_dot
            .mul_add(x_0, x.mul_add(ratio_x_v_2_of_x_dot_y_dot_0, sums[7]));
        // ratio_x_v_2_of_x_dot_y_dot_3 = x_y_dot_minus_y_x_dot*x_over_x_sq_plus_y_sq
        let ratio_x_v_2_of_x_dot_y_dot_3 = x_over_x_sq_plus_y_sq
            .mul_add(
                x_y_dot_minus_y_x_dot_0,
                x_y_dot_minus_y_x_dot.mul_add(x_over_x_sq_plus_y_sq_0, sums[8]),
            );
        // ratio_x_v_2_of_x_dot_y_dot_4 = y*ratio_x_v_2_of_x_dot_y_dot_3
        let ratio_x_v_2_of_x_dot_y_dot_4 = ratio_x_v_2_of_x_dot_y_dot_3
            .mul_add(y_0, y.mul_add(ratio_x_v_2_of_x_dot_y_dot_3_0, sums[9]));
        // ratio_x_v_2_of_x_dot_y_dot_5 = ratio_x_v_2_of_x_dot_y_dot_3/x_sq_plus_y_sq
        let ratio_x_v_2_of_x_dot_y_dot_5 = ratio_x_v_2_of_x_dot_y_dot_3
            .mul_add(
                over_x_sq_plus_y_sq,
                -(x_sq_plus_y_sq.mul_add(ratio_x_v_2_of_x_dot_y_dot_5_0, sums[10])
                    * over_x_sq_plus_y_sq),
            );
        // ratio_x_v_2_of_x_dot_y_dot_6 = ratio_x_v_2_of_x_dot_y_dot_2 - ratio_x_v_2_of_x_dot_y_dot_4
        let ratio_x_v_2_of_x_dot_y_dot_6 = ratio_x_v_2_of_x_dot_y_dot_2
            - ratio_x_v_2_of_x_dot_y_dot_4;
        // ratio_x_v_2_of_x_dot_y_dot_7 = ratio_x_v_2_of_x_dot_y_dot_6/x_sq_plus_y_sq
        let ratio_x_v_2_of_x_dot_y_dot_7 = ratio_x_v_2_of_x_dot_y_dot_6
            .mul_add(
                over_x_sq_plus_y_sq,
                -(x_sq_plus_y_sq.mul_add(ratio_x_v_2_of_x_dot_y_dot_7_0, sums[11])
                    * over_x_sq_plus_y_sq),
            );
        // ratio_x_v_2_of_x_dot_y_dot_8 = y_over_x_sq_plus_y_sq*ratio_x_v_2_of_x_dot_y_dot_7
        let ratio_x_v_2_of_x_dot_y_dot_8 = ratio_x_v_2_of_x_dot_y_dot_7
            .mul_add(
                y_over_x_sq_plus_y_sq_0,
                y_over_x_sq_plus_y_sq.mul_add(ratio_x_v_2_of_x_dot_y_dot_7_0, sums[12]),
            );
        // ratio_x_v_2_of_x_dot_y_dot_9 = l*ratio_x_v_2_of_x_dot_y_dot_5 +
        //   weight*ratio_x_v_2_of_x_dot_y_dot_8
        let ratio_x_v_2_of_x_dot_y_dot_9 = ratio_x_v_2_of_x_dot_y_dot_8
            .mul_add(weight, l * ratio_x_v_2_of_x_dot_y_dot_5);
        // ratio_y_v_2_of_x_dot_y_dot = ratio_x_v_2_of_x_dot_y_dot/x_sq_plus_y_sq
        let ratio_y_v_2_of_x_dot_y_dot = ratio_x_v_2_of_x_dot_y_dot
            .mul_add(
                over_x_sq_plus_y_sq,
                -(x_sq_plus_y_sq.mul_add(ratio_y_v_2_of_x_dot_y_dot_0, sums[13])
                    * over_x_sq_plus_y_sq),
            );
        // ratio_y_v_2_of_x_dot_y_dot_2 = x_over_x_sq_plus_y_sq*ratio_x_v_2_of_x_dot_y_dot_7
        let ratio_y_v_2_of_x_dot_y_dot_2 = ratio_x_v_2_of_x_dot_y_dot_7
            .mul_add(
                x_over_x_sq_plus_y_sq_0,
                x_over_x_sq_plus_y_sq.mul_add(ratio_x_v_2_of_x_dot_y_dot_7_0, sums[14]),
            );
        // ratio_y_v_2_of_x_dot_y_dot_3 = l*ratio_y_v_2_of_x_dot_y_dot +
        //   minus_2_l*ratio_y_v_2_of_x_dot_y_dot_2
        let ratio_y_v_2_of_x_dot_y_dot_3 = ratio_y_v_2_of_x_dot_y_dot_2
            .mul_add(minus_2_l, l * ratio_y_v_2_of_x_dot_y_dot);
        // v_dot_2_of_x_y = y_over_x_sq_plus_y_sq*y_over_x_sq_plus_y_sq
        let v_dot_2_of_x_y = y_over_x_sq_plus_y_sq
            .mul_add(y_over_x_sq_plus_y_sq_0 + y_over_x_sq_plus_y_sq_0, sums[15]);
        // v_dot_2_of_x_y_2 = x_over_x_sq_plus_y_sq*x_over_x_sq_plus_y_sq
        let v_dot_2_of_x_y_2 = x_over_x_sq_plus_y_sq
            .mul_add(x_over_x_sq_plus_y_sq_0 + x_over_x_sq_plus_y_sq_0, sums[16]);
        // v_dot_2_of_place = l_2*v_dot_2_of_x_y + l_2*v_dot_2_of_x_y_2
        let v_dot_2_of_place = v_dot_2_of_x_y_2.mul_add(l_2, l_2 * v_dot_2_of_x_y);
        // v_dot_2_of_x_dot_y_dot = x_y_dot_minus_y_x_dot*ratio_y_v_2_of_x_dot_y_dot_3
        let v_dot_2_of_x_dot_y_dot = ratio_y_v_2_of_x_dot_y_dot_3
            .mul_add(
                x_y_dot_minus_y_x_dot_0,
                x_y_dot_minus_y_x_dot.mul_add(ratio_y_v_2_of_x_dot_y_dot_3_0, sums[17]),
            );
        // v_dot_2_of_x_dot_y_dot_2 = minus_l_g + v_dot_2_of_x_dot_y_dot
        let v_dot_2_of_x_dot_y_dot_2 = v_dot_2_of_x_dot_y_dot;
        // v_dot_2_of_x_dot_y_dot_3 = x_over_x_sq_plus_y_sq*v_dot_2_of_x_dot_y_dot_2
        let v_dot_2_of_x_dot_y_dot_3 = v_dot_2_of_x_dot_y_dot_2
            .mul_add(
                x_over_x_sq_plus_y_sq_0,
                x_over_x_sq_plus_y_sq.mul_add(v_dot_2_of_x_dot_y_dot_2_0, sums[18]),
            );
        // v_dot_2_of_x_dot_y_dot_4 = ratio_x_v_2_of_x_dot_y_dot_9*ratio_x_v_2_of_x_dot_y_dot
        let v_dot_2_of_x_dot_y_dot_4 = ratio_x_v_2_of_x_dot_y_dot_9
            .mul_add(
                ratio_x_v_2_of_x_dot_y_dot_0,
                ratio_x_v_2_of_x_dot_y_dot
                    .mul_add(ratio_x_v_2_of_x_dot_y_dot_9_0, sums[19]),
            );
        // v_dot_2_of_x_dot_y_dot_5 = l*v_dot_2_of_x_dot_y_dot_3 + minus_l*v_dot_2_of_x_dot_y_dot_4
        let v_dot_2_of_x_dot_y_dot_5 = v_dot_2_of_x_dot_y_dot_3
            .mul_add(l, minus_l * v_dot_2_of_x_dot_y_dot_4);
        // v_dot_2_of_x_dot_y_dot_6 = v_dot_2_of_x_dot_y_dot_5/v_dot_2_of_place
        let v_dot_2_of_x_dot_y_dot_6 = v_dot_2_of_x_dot_y_dot_5
            .mul_add(
                over_v_dot_2_of_place,
                -(v_dot_2_of_place.mul_add(v_dot_2_of_x_dot_y_dot_6_0, sums[20])
                    * over_v_dot_2_of_place),
            );
        // x_ddot_of_x_dot_y_dot = x_y_dot_minus_y_x_dot*ratio_x_v_2_of_x_dot_y_dot_9
        let x_ddot_of_x_dot_y_dot = ratio_x_v_2_of_x_dot_y_dot_9
            .mul_add(
                x_y_dot_minus_y_x_dot_0,
                x_y_dot_minus_y_x_dot.mul_add(ratio_x_v_2_of_x_dot_y_dot_9_0, sums[21]),
            );
        // x_ddot_of_x_dot_y_dot_2 = v_dot_2_of_x_dot_y_dot_6*y_over_x_sq_plus_y_sq
        let x_ddot_of_x_dot_y_dot_2 = v_dot_2_of_x_dot_y_dot_6
            .mul_add(
                y_over_x_sq_plus_y_sq_0,
                y_over_x_sq_plus_y_sq.mul_add(v_dot_2_of_x_dot_y_dot_6_0, sums[22]),
            );
        // x_dot_dot = minus_1_by_l*x_ddot_of_x_dot_y_dot - x_ddot_of_x_dot_y_dot_2
        let x_dot_dot = minus_1_by_l * x_ddot_of_x_dot_y_dot - x_ddot_of_x_dot_y_dot_2;
        // y_ddot_of_x_dot_y_dot = v_dot_2_of_x_dot_y_dot_6*x_over_x_sq_plus_y_sq
        let y_ddot_of_x_dot_y_dot = v_dot_2_of_x_dot_y_dot_6
            .mul_add(
                x_over_x_sq_plus_y_sq_0,
                x_over_x_sq_plus_y_sq.mul_add(v_dot_2_of_x_dot_y_dot_6_0, sums[23]),
            );
        // y_dot_dot = minus_1_by_l*v_dot_2_of_x_dot_y_dot + y_ddot_of_x_dot_y_dot
        let y_dot_dot = minus_1_by_l * v_dot_2_of_x_dot_y_dot + y_ddot_of_x_dot_y_dot;
        x_rate = x_dot;
        y_rate = y_dot;
        x_dot_rate = x_dot_dot;
        y_dot_rate = y_dot_dot;
        // Factors of the convolutions: left, right.
        history[order] = [
            [
                x, y, x_sq_plus_y_sq, x_sq_plus_y_sq, x, y, x_y_dot_minus_y_x_dot, x,
                x_y_dot_minus_y_x_dot, y, x_sq_plus_y_sq, x_sq_plus_y_sq, y_over_x_sq_plus_y_sq,
                x_sq_plus_y_sq, x_over_x_sq_plus_y_sq, y_over_x_sq_plus_y_sq, x_over_x_sq_plus_y_sq,
                x_y_dot_minus_y_x_dot, x_over_x_sq_plus_y_sq, ratio_x_v_2_of_x_dot_y_dot_9,
                v_dot_2_of_place, x_y_dot_minus_y_x_dot, v_dot_2_of_x_dot_y_dot_6,
                v_dot_2_of_x_dot_y_dot_6,
            ],
            [
                x, y, y_over_x_sq_plus_y_sq, x_over_x_sq_plus_y_sq, y_dot, x_dot,
                y_over_x_sq_plus_y_sq, ratio_x_v_2_of_x_dot_y_dot, x_over_x_sq_plus_y_sq,
                ratio_x_v_2_of_x_dot_y_dot_3, ratio_x_v_2_of_x_dot_y_dot_5,
                ratio_x_v_2_of_x_dot_y_dot_7, ratio_x_v_2_of_x_dot_y_dot_7,
                ratio_y_v_2_of_x_dot_y_dot, ratio_x_v_2_of_x_dot_y_dot_7, y_over_x_sq_plus_y_sq,
                x_over_x_sq_plus_y_sq, ratio_y_v_2_of_x_dot_y_dot_3, v_dot_2_of_x_dot_y_dot_2,
                ratio_x_v_2_of_x_dot_y_dot, v_dot_2_of_x_dot_y_dot_6, ratio_x_v_2_of_x_dot_y_dot_9,
                y_over_x_sq_plus_y_sq, x_over_x_sq_plus_y_sq,
            ],
        ];
        x_last = x;
        y_last = y;
        x_dot_last = x_dot;
        y_dot_last = y_dot;
        x_sq_plus_y_sq_last = x_sq_plus_y_sq;
        y_over_x_sq_plus_y_sq_last = y_over_x_sq_plus_y_sq;
        x_over_x_sq_plus_y_sq_last = x_over_x_sq_plus_y_sq;
        x_y_dot_minus_y_x_dot_last = x_y_dot_minus_y_x_dot;
        ratio_x_v_2_of_x_dot_y_dot_last = ratio_x_v_2_of_x_dot_y_dot;
        ratio_x_v_2_of_x_dot_y_dot_3_last = ratio_x_v_2_of_x_dot_y_dot_3;
        ratio_x_v_2_of_x_dot_y_dot_5_last = ratio_x_v_2_of_x_dot_y_dot_5;
        ratio_x_v_2_of_x_dot_y_dot_7_last = ratio_x_v_2_of_x_dot_y_dot_7;
        ratio_x_v_2_of_x_dot_y_dot_9_last = ratio_x_v_2_of_x_dot_y_dot_9;
        ratio_y_v_2_of_x_dot_y_dot_last = ratio_y_v_2_of_x_dot_y_dot;
        ratio_y_v_2_of_x_dot_y_dot_3_last = ratio_y_v_2_of_x_dot_y_dot_3;
        v_dot_2_of_place_last = v_dot_2_of_place;
        v_dot_2_of_x_dot_y_dot_2_last = v_dot_2_of_x_dot_y_dot_2;
        v_dot_2_of_x_dot_y_dot_6_last = v_dot_2_of_x_dot_y_dot_6;
    }
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
    direction: &[S; 4],
) -> [S; 4] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: q_dot[i],
        slope: direction[2 + i],
    });
    let (of_q, of_v) = derivative(&p, &q, &v);
    let mut slopes = of_q.into_iter().chain(of_v).map(|rate| rate.slope);
    core::array::from_fn(|_| {
        slopes.next().expect("a slope for each component of the state")
    })
}

/// Lagrange's equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Lagrange;

impl<S: Scalar> System<S> for Lagrange {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 3,
            coordinates: 2,
            variables: 2,
            speeds: 1,
            reactions: 1,
        }
    }
    fn symmetric(&self) -> bool {
        false
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
        3
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
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, order: usize) -> usize {
        48 * order + SLACK
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
    fn constraint_count(&self) -> usize {
        2
    }
    fn constraint_name(&self, at: usize) -> &str {
        ["rod", "rod'"][at]
    }
    fn constraints(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &constraints(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn constraint_slopes(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &constraint_slopes(&Parameters::from_slice(p), array(q), array(v)),
        );
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
    slice.try_into().expect("a slice of the length that `System` requires")
}
