//! Knife edge on an incline: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/knife_edge/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows x, y, phi, constraint edge.
///
/// 2 operations, 1 sine and cosine.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    _q_dot: &[S; 3],
) -> [[S; 4]; 4] {
    let Parameters { m, J, .. } = *p;
    let [_, _, phi] = *q;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Entries that are not zero.
    // M11 = m
    let m11 = m;
    // M14 = sin(phi)
    let m14 = sin_phi;
    // M22 = m
    let m22 = m;
    // M24 = -cos(phi)
    let m24 = -cos_phi;
    // M33 = J
    let m33 = J;
    // M41 = -sin(phi)
    let m41 = -sin_phi;
    // M42 = cos(phi)
    let m42 = cos_phi;
    let zero = S::int(0);
    [
        [m11, zero, zero, m14],
        [zero, m22, zero, m24],
        [zero, zero, m33, zero],
        [m41, m42, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (x'', y'', phi'', lambda_edge).
///
/// 6 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], q_dot: &[S; 3]) -> [S; 4] {
    let Parameters { m, alpha, g, .. } = *p;
    let [_, _, phi] = *q;
    let [x_dot, y_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Values.
    // f1 = m*g*sin(alpha)
    let f1 = m * g * sin_alpha;
    // f4 = phi'*(x'*cos(phi) + y'*sin(phi))
    let f4 = phi_dot * y_dot.mul_add(sin_phi, x_dot * cos_phi);
    let zero = S::int(0);
    [f1, zero, zero, f4]
}

/// The accelerations (x'', y'', phi''), solved for when this code was generated.
///
/// 12 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 3] {
    let Parameters { alpha, g, .. } = *p;
    let [_, _, phi] = *q;
    let [x_dot, y_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w' = 0
    let w_dot = S::int(0);
    // u' = g*sin(alpha)*cos(phi)
    let u_dot = g * sin_alpha * cos_phi;
    // phi'*(x'*cos(phi) + y'*sin(phi))
    let x_ddot_of_motion = phi_dot * y_dot.mul_add(sin_phi, x_dot * cos_phi);
    // x'' = u'*cos(phi) - phi'*sin(phi)*(x'*cos(phi) + y'*sin(phi))
    let x_ddot = (-x_ddot_of_motion).mul_add(sin_phi, u_dot * cos_phi);
    // y'' = phi'*cos(phi)*(x'*cos(phi) + y'*sin(phi)) + u'*sin(phi)
    let y_ddot = x_ddot_of_motion.mul_add(cos_phi, u_dot * sin_phi);
    // phi'' = w'
    let phi_ddot = w_dot;
    [x_ddot, y_ddot, phi_ddot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 3] {
    let [x_dot, y_dot, phi_dot] = *q_dot;
    // Values.
    // x'
    let x_dot_value = x_dot;
    // y'
    let y_dot_value = y_dot;
    // phi'
    let phi_dot_value = phi_dot;
    [x_dot_value, y_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 8 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 3], q_dot: &[S; 3]) -> S {
    let Parameters { m, J, .. } = *p;
    let [x_dot, y_dot, phi_dot] = *q_dot;
    // Shared terms.
    // m*(x'^2 + y'^2) + J*phi'^2
    let energy_of_motion = m * y_dot.mul_add(y_dot, x_dot * x_dot) + J * phi_dot * phi_dot;
    // Values.
    // T = m*x'^2/2 + m*y'^2/2 + J*phi'^2/2
    let energy = S::ratio(1, 2) * energy_of_motion;
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 2] {
    let [_, _, phi] = *q;
    let [x_dot, y_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Values.
    // u = x'*cos(phi) + y'*sin(phi)
    let u_value = y_dot.mul_add(sin_phi, x_dot * cos_phi);
    // w = phi'
    let w_value = phi_dot;
    [u_value, w_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 7 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
    v_dot: &[S; 3],
) -> [S; 2] {
    let [_, _, phi] = *q;
    let [x_dot, y_dot, phi_dot] = *q_dot;
    let [x_ddot, y_ddot, phi_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Values.
    // u' = phi'*(y'*cos(phi) - x'*sin(phi)) + x''*cos(phi) + y''*sin(phi)
    let u_dot_value = cos_phi * y_dot.mul_add(phi_dot, x_ddot)
        + sin_phi * (-x_dot).mul_add(phi_dot, y_ddot);
    // w' = phi''
    let w_dot_value = phi_ddot;
    [u_dot_value, w_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 2 operations, 1 sine and cosine.
#[must_use]
pub fn motion_variables<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 2],
) -> [S; 3] {
    let [_, _, phi] = *q;
    let [u_2, w] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Values.
    // x' = u*cos(phi)
    let x_dot_value = u_2 * cos_phi;
    // y' = u*sin(phi)
    let y_dot_value = u_2 * sin_phi;
    // phi' = w
    let phi_dot_value = w;
    [x_dot_value, y_dot_value, phi_dot_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 12 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> ([S; 3], [S; 3]) {
    let Parameters { alpha, g, .. } = *p;
    let [_, _, phi] = *q;
    let [x_dot, y_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w' = 0
    let w_dot = S::int(0);
    // u' = g*sin(alpha)*cos(phi)
    let u_dot = g * sin_alpha * cos_phi;
    // phi'*(x'*cos(phi) + y'*sin(phi))
    let x_ddot_of_motion = phi_dot * y_dot.mul_add(sin_phi, x_dot * cos_phi);
    // x'' = u'*cos(phi) - phi'*sin(phi)*(x'*cos(phi) + y'*sin(phi))
    let x_ddot = (-x_ddot_of_motion).mul_add(sin_phi, u_dot * cos_phi);
    // y'' = phi'*cos(phi)*(x'*cos(phi) + y'*sin(phi)) + u'*sin(phi)
    let y_ddot = x_ddot_of_motion.mul_add(cos_phi, u_dot * sin_phi);
    // phi'' = w'
    let phi_ddot = w_dot;
    // Values.
    // x'
    let x_dot_value = x_dot;
    // y'
    let y_dot_value = y_dot;
    // phi'
    let phi_dot_value = phi_dot;
    ([x_dot_value, y_dot_value, phi_dot_value], [x_ddot, y_ddot, phi_ddot])
}

/// Jacobian of the derivative by the state; columns x, y, phi, x', y', phi'.
///
/// 33 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> [[S; 6]; 6] {
    let Parameters { alpha, g, .. } = *p;
    let [_, _, phi] = *q;
    let [x_dot, y_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_alpha, _) = alpha.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let g_sin_alpha = g * sin_alpha;
    // u' = g*sin(alpha)*cos(phi)
    let u_dot = g_sin_alpha * cos_phi;
    // u_dot_by_phi = -g*sin(alpha)*sin(phi)
    let u_dot_by_phi = -g_sin_alpha * sin_phi;
    // x'*cos(phi) + y'*sin(phi)
    let x_ddot_by_phi_of_x_dot_y_dot = y_dot.mul_add(sin_phi, x_dot * cos_phi);
    let phi_dot_cos_phi = phi_dot * cos_phi;
    let phi_dot_cos_phi_doubled = S::int(2) * phi_dot_cos_phi;
    // x_ddot_by_phi = phi'*(x'*(sin(phi)^2 - cos(phi)^2) - 2*y'*sin(phi)*cos(phi)) - u'*sin(phi) +
    //   u_dot_by_phi*cos(phi)
    let x_ddot_by_phi = (-u_dot).mul_add(sin_phi, x_dot * phi_dot) + u_dot_by_phi * cos_phi
        - x_ddot_by_phi_of_x_dot_y_dot * phi_dot_cos_phi_doubled;
    // y'*cos(phi) - x'*sin(phi)
    let y_ddot_by_phi_of_x_dot_y_dot = (-x_dot).mul_add(sin_phi, y_dot * cos_phi);
    // y_ddot_by_phi = u'*cos(phi) - phi'*(2*x'*sin(phi)*cos(phi) + y'*(sin(phi)^2 - cos(phi)^2)) +
    //   u_dot_by_phi*sin(phi)
    let y_ddot_by_phi = (-y_dot).mul_add(phi_dot, u_dot * cos_phi) + u_dot_by_phi * sin_phi
        + phi_dot_cos_phi_doubled * y_ddot_by_phi_of_x_dot_y_dot;
    // y_ddot_by_y_dot = phi'*sin(phi)*cos(phi)
    let y_ddot_by_y_dot = phi_dot_cos_phi * sin_phi;
    // x_ddot_by_x_dot = -phi'*sin(phi)*cos(phi)
    let x_ddot_by_x_dot = -y_ddot_by_y_dot;
    // x_ddot_by_phi_dot = -sin(phi)*(x'*cos(phi) + y'*sin(phi))
    let x_ddot_by_phi_dot = y_ddot_by_phi_of_x_dot_y_dot.mul_add(cos_phi, -y_dot);
    // y_ddot_by_phi_dot = cos(phi)*(x'*cos(phi) + y'*sin(phi))
    let y_ddot_by_phi_dot = x_ddot_by_phi_of_x_dot_y_dot * cos_phi;
    let cos_phi_phi_dot_cos_phi = phi_dot_cos_phi * cos_phi;
    // Entries that are not zero.
    // d(x')/d(x') = 1
    let x_dot_by_x_dot_value = S::int(1);
    // d(y')/d(y') = 1
    let y_dot_by_y_dot_value = S::int(1);
    // d(phi')/d(phi') = 1
    let phi_dot_by_phi_dot_value = S::int(1);
    // d(x'')/d(y') = -phi'*sin(phi)^2
    let x_ddot_by_y_dot_value = cos_phi_phi_dot_cos_phi - phi_dot;
    // d(y'')/d(x') = phi'*cos(phi)^2
    let y_ddot_by_x_dot_value = cos_phi_phi_dot_cos_phi;
    let zero = S::int(0);
    [
        [zero, zero, zero, x_dot_by_x_dot_value, zero, zero],
        [zero, zero, zero, zero, y_dot_by_y_dot_value, zero],
        [zero, zero, zero, zero, zero, phi_dot_by_phi_dot_value],
        [
            zero, zero, x_ddot_by_phi, x_ddot_by_x_dot, x_ddot_by_y_dot_value, x_ddot_by_phi_dot,
        ],
        [
            zero, zero, y_ddot_by_phi, y_ddot_by_x_dot_value, y_ddot_by_y_dot, y_ddot_by_phi_dot,
        ],
        [zero, zero, zero, zero, zero, zero],
    ]
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn constraints<S: Scalar>(_p: &Parameters<S>, q: &[S; 3], q_dot: &[S; 3]) -> [S; 1] {
    let [_, _, phi] = *q;
    let [x_dot, y_dot, _] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Values.
    // edge = y'*cos(phi) - x'*sin(phi)
    let residual1 = (-x_dot).mul_add(sin_phi, y_dot * cos_phi);
    [residual1]
}

/// Slopes of the constraints, one after the other, along x, y, phi, x', y', phi'.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 6] {
    let [_, _, phi] = *q;
    let [x_dot, y_dot, _] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Values.
    // d(edge)/d(phi) = -x'*cos(phi) - y'*sin(phi)
    let residual1_by_phi = (-y_dot).mul_add(sin_phi, -x_dot * cos_phi);
    // d(edge)/d(x') = -sin(phi)
    let residual1_by_x_dot = -sin_phi;
    // d(edge)/d(y') = cos(phi)
    let residual1_by_y_dot = cos_phi;
    let zero = S::int(0);
    [zero, zero, residual1_by_phi, residual1_by_x_dot, residual1_by_y_dot, zero]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 9 convolutions and 12 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 6]],
    history: &mut [Factors<S, 16>],
) {
    let Parameters { alpha, g, .. } = *p;
    let [_, _, phi_0, x_dot_0, y_dot_0, phi_dot_0] = series[0];
    // Sines and cosines.
    let (sin_alpha, _) = alpha.sin_cos();
    // Constant in time.
    // g_sin_alpha = g*sin(alpha)
    let g_sin_alpha = g * sin_alpha;
    // Order 0.
    let (sin_phi_0, cos_phi_0) = phi_0.sin_cos();
    let x_dot_cos_phi_0 = x_dot_0 * cos_phi_0;
    let y_dot_sin_phi_0 = y_dot_0 * sin_phi_0;
    let x_ddot_of_x_dot_y_dot_0 = x_dot_cos_phi_0 + y_dot_sin_phi_0;
    let x_ddot_of_motion_0 = phi_dot_0 * x_ddot_of_x_dot_y_dot_0;
    let x_ddot_of_motion_2_0 = sin_phi_0 * x_ddot_of_motion_0;
    let cos_phi_sq_0 = cos_phi_0 * cos_phi_0;
    let x_dot_dot_0 = g_sin_alpha * cos_phi_sq_0 - x_ddot_of_motion_2_0;
    let y_ddot_of_motion_0 = cos_phi_0 * x_ddot_of_motion_0;
    let cos_phi_sin_phi_0 = sin_phi_0 * cos_phi_0;
    let y_dot_dot_0 = g_sin_alpha * cos_phi_sin_phi_0 + y_ddot_of_motion_0;
    // Order 1: the rates, and what follows from them.
    let x_1 = x_dot_0;
    let y_1 = y_dot_0;
    let phi_1 = phi_dot_0;
    let x_dot_1 = x_dot_dot_0;
    let y_dot_1 = y_dot_dot_0;
    let phi_dot_1 = S::int(0);
    if series.len() > 1 {
        series[1] = [x_1, y_1, phi_1, x_dot_1, y_dot_1, phi_dot_1];
    }
    let sin_phi_1 = phi_1 * cos_phi_0;
    let cos_phi_1 = -phi_1 * sin_phi_0;
    let x_dot_cos_phi_1 = cos_phi_1.mul_add(x_dot_0, x_dot_1 * cos_phi_0);
    let y_dot_sin_phi_1 = sin_phi_1.mul_add(y_dot_0, y_dot_1 * sin_phi_0);
    let x_ddot_of_x_dot_y_dot_1 = x_dot_cos_phi_1 + y_dot_sin_phi_1;
    let x_ddot_of_motion_1 = x_ddot_of_x_dot_y_dot_1
        .mul_add(phi_dot_0, phi_dot_1 * x_ddot_of_x_dot_y_dot_0);
    let x_ddot_of_motion_2_1 = x_ddot_of_motion_1
        .mul_add(sin_phi_0, sin_phi_1 * x_ddot_of_motion_0);
    let cos_phi_sq_1 = cos_phi_1 * (cos_phi_0 + cos_phi_0);
    let x_dot_dot_1 = g_sin_alpha * cos_phi_sq_1 - x_ddot_of_motion_2_1;
    let y_ddot_of_motion_1 = x_ddot_of_motion_1
        .mul_add(cos_phi_0, cos_phi_1 * x_ddot_of_motion_0);
    let cos_phi_sin_phi_1 = cos_phi_1.mul_add(sin_phi_0, sin_phi_1 * cos_phi_0);
    let y_dot_dot_1 = g_sin_alpha * cos_phi_sin_phi_1 + y_ddot_of_motion_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                phi_1, phi_1, x_dot_1, y_dot_1, phi_dot_1, sin_phi_1, cos_phi_1, cos_phi_1,
                sin_phi_1,
            ]),
            padded([
                cos_phi_1, sin_phi_1, cos_phi_1, sin_phi_1, x_ddot_of_x_dot_y_dot_1,
                x_ddot_of_motion_1, cos_phi_1, x_ddot_of_motion_1, cos_phi_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut phi_last = phi_1;
    let mut x_dot_last = x_dot_1;
    let mut y_dot_last = y_dot_1;
    let mut phi_dot_last = phi_dot_1;
    let mut sin_phi_last = sin_phi_1;
    let mut cos_phi_last = cos_phi_1;
    let mut x_ddot_of_x_dot_y_dot_last = x_ddot_of_x_dot_y_dot_1;
    let mut x_ddot_of_motion_last = x_ddot_of_motion_1;
    let mut next = [S::int(0); 16];
    // Rates at order k - 1.
    let mut x_rate = x_dot_1;
    let mut y_rate = y_dot_1;
    let mut phi_rate = phi_dot_1;
    let mut x_dot_rate = x_dot_dot_1;
    let mut y_dot_rate = y_dot_dot_1;
    let mut phi_dot_rate = S::int(0);
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let x = x_rate * over_k;
        let y = y_rate * over_k;
        let phi = phi_rate * over_k;
        let x_dot = x_dot_rate * over_k;
        let y_dot = y_dot_rate * over_k;
        let phi_dot = phi_dot_rate * over_k;
        series[order] = [x, y, phi, x_dot, y_dot, phi_dot];
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
                phi_1
                    .mul_add(
                        cos_phi_last,
                        (count_last * phi_last).mul_add(cos_phi_1, next[0]),
                    ),
                phi_1
                    .mul_add(
                        sin_phi_last,
                        (count_last * phi_last).mul_add(sin_phi_1, next[1]),
                    ),
                x_dot_1.mul_add(cos_phi_last, x_dot_last.mul_add(cos_phi_1, next[2])),
                y_dot_1.mul_add(sin_phi_last, y_dot_last.mul_add(sin_phi_1, next[3])),
                phi_dot_1
                    .mul_add(
                        x_ddot_of_x_dot_y_dot_last,
                        phi_dot_last.mul_add(x_ddot_of_x_dot_y_dot_1, next[4]),
                    ),
                sin_phi_1
                    .mul_add(
                        x_ddot_of_motion_last,
                        sin_phi_last.mul_add(x_ddot_of_motion_1, next[5]),
                    ),
                (cos_phi_1 + cos_phi_1).mul_add(cos_phi_last, next[6]),
                cos_phi_1
                    .mul_add(
                        x_ddot_of_motion_last,
                        cos_phi_last.mul_add(x_ddot_of_motion_1, next[7]),
                    ),
                sin_phi_1.mul_add(cos_phi_last, sin_phi_last.mul_add(cos_phi_1, next[8])),
            ])
        };
        // sin_phi = sin(phi)
        let sin_phi = phi.mul_add(cos_phi_0, sums[0] * over_k);
        // cos_phi = cos(phi)
        let cos_phi = -phi.mul_add(sin_phi_0, sums[1] * over_k);
        // x_dot_cos_phi = x_dot*cos_phi
        let x_dot_cos_phi = cos_phi.mul_add(x_dot_0, x_dot.mul_add(cos_phi_0, sums[2]));
        // y_dot_sin_phi = y_dot*sin_phi
        let y_dot_sin_phi = sin_phi.mul_add(y_dot_0, y_dot.mul_add(sin_phi_0, sums[3]));
        // x_ddot_of_x_dot_y_dot = x_dot_cos_phi + y_dot_sin_phi
        let x_ddot_of_x_dot_y_dot = x_dot_cos_phi + y_dot_sin_phi;
        // x_ddot_of_motion = phi_dot*x_ddot_of_x_dot_y_dot
        let x_ddot_of_motion = x_ddot_of_x_dot_y_dot
            .mul_add(phi_dot_0, phi_dot.mul_add(x_ddot_of_x_dot_y_dot_0, sums[4]));
        // x_ddot_of_motion_2 = sin_phi*x_ddot_of_motion
        let x_ddot_of_motion_2 = x_ddot_of_motion
            .mul_add(sin_phi_0, sin_phi.mul_add(x_ddot_of_motion_0, sums[5]));
        // cos_phi_sq = cos_phi*cos_phi
        let cos_phi_sq = cos_phi.mul_add(cos_phi_0 + cos_phi_0, sums[6]);
        // x_dot_dot = -x_ddot_of_motion_2 + g_sin_alpha*cos_phi_sq
        let x_dot_dot = g_sin_alpha * cos_phi_sq - x_ddot_of_motion_2;
        // y_ddot_of_motion = cos_phi*x_ddot_of_motion
        let y_ddot_of_motion = x_ddot_of_motion
            .mul_add(cos_phi_0, cos_phi.mul_add(x_ddot_of_motion_0, sums[7]));
        // cos_phi_sin_phi = sin_phi*cos_phi
        let cos_phi_sin_phi = cos_phi
            .mul_add(sin_phi_0, sin_phi.mul_add(cos_phi_0, sums[8]));
        // y_dot_dot = y_ddot_of_motion + g_sin_alpha*cos_phi_sin_phi
        let y_dot_dot = g_sin_alpha * cos_phi_sin_phi + y_ddot_of_motion;
        x_rate = x_dot;
        y_rate = y_dot;
        phi_rate = phi_dot;
        x_dot_rate = x_dot_dot;
        y_dot_rate = y_dot_dot;
        phi_dot_rate = S::int(0);
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * phi,
                count * phi,
                x_dot, y_dot, phi_dot, sin_phi, cos_phi, cos_phi, sin_phi,
            ]),
            padded([
                cos_phi, sin_phi, cos_phi, sin_phi, x_ddot_of_x_dot_y_dot, x_ddot_of_motion,
                cos_phi, x_ddot_of_motion, cos_phi,
            ]),
        ];
        count_last = count;
        phi_last = phi;
        x_dot_last = x_dot;
        y_dot_last = y_dot;
        phi_dot_last = phi_dot;
        sin_phi_last = sin_phi;
        cos_phi_last = cos_phi;
        x_ddot_of_x_dot_y_dot_last = x_ddot_of_x_dot_y_dot;
        x_ddot_of_motion_last = x_ddot_of_motion;
    }
}

/// Lagrange's equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Lagrange;

impl<S: Scalar> System<S> for Lagrange {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 4,
            coordinates: 3,
            variables: 3,
            speeds: 2,
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
        5
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
    fn constraint_count(&self) -> usize {
        1
    }
    fn constraint_name(&self, at: usize) -> &str {
        ["edge"][at]
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
    slice.try_into().expect("a slice of the length that System states")
}
