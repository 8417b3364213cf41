//! Symmetric rigid body free of forces: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/free_body/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows v1, v2, v3, w1, w2, w3.
///
/// 0 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 6],
    _u: &[S; 6],
) -> [[S; 6]; 6] {
    let Parameters { m, I1, I3 } = *p;
    // Entries that are not zero; upper triangle.
    // M11 = m
    let m11 = m;
    // M22 = m
    let m22 = m;
    // M33 = m
    let m33 = m;
    // M44 = I1
    let m44 = I1;
    // M55 = I1
    let m55 = I1;
    // M66 = I3
    let m66 = I3;
    let zero = S::int(0);
    [
        [m11, zero, zero, zero, zero, zero],
        [zero, m22, zero, zero, zero, zero],
        [zero, zero, m33, zero, zero, zero],
        [zero, zero, zero, m44, zero, zero],
        [zero, zero, zero, zero, m55, zero],
        [zero, zero, zero, zero, zero, m66],
    ]
}

/// Right-hand side of the linear system; unknowns (v1', v2', v3', w1', w2', w3').
///
/// 8 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 6], u: &[S; 6]) -> [S; 6] {
    let Parameters { I1, I3, .. } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [_, _, _, w1, w2, w3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let tan_theta = sin_theta / cos_theta;
    // I3*w3 - I1*w2/tan(theta)
    let f4_of_w2_w3 = I3.mul_add(w3, -I1 * w2 / tan_theta);
    // Values.
    // f4 = w2*(I1*w2/tan(theta) - I3*w3)
    let f4 = -w2 * f4_of_w2_w3;
    // f5 = w1*(I3*w3 - I1*w2/tan(theta))
    let f5 = w1 * f4_of_w2_w3;
    let zero = S::int(0);
    [zero, zero, zero, f4, f5, zero]
}

/// The accelerations (v1', v2', v3', w1', w2', w3'), solved for when this code was generated.
///
/// 8 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 6], u: &[S; 6]) -> [S; 6] {
    let Parameters { I1, I3, .. } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [_, _, _, w1, w2, w3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let tan_theta = sin_theta / cos_theta;
    // w2/tan(theta) - I3*w3/I1
    let w2_dot_of_w2_w3 = w2 / tan_theta - I3 * w3 / I1;
    // w2' = w1*(I3*w3/I1 - w2/tan(theta))
    let w2_dot = -w1 * w2_dot_of_w2_w3;
    // w1' = w2*(w2/tan(theta) - I3*w3/I1)
    let w1_dot = w2 * w2_dot_of_w2_w3;
    let zero = S::int(0);
    [zero, zero, zero, w1_dot, w2_dot, zero]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 6],
    u: &[S; 6],
) -> [S; 6] {
    let [_, _, _, _, theta, _] = *q;
    let [v1, v2, v3, w1, w2, w3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let w2_sin_theta_inv = w2 / sin_theta;
    // Values.
    // x' = v1
    let x_dot_value = v1;
    // y' = v2
    let y_dot_value = v2;
    // z' = v3
    let z_dot_value = v3;
    // psi' = w2/sin(theta)
    let psi_dot_value = w2_sin_theta_inv;
    // theta' = w1
    let theta_dot_value = w1;
    // phi' = w3 - w2/tan(theta)
    let phi_dot_value = (-w2_sin_theta_inv).mul_add(cos_theta, w3);
    [
        x_dot_value, y_dot_value, z_dot_value, psi_dot_value, theta_dot_value, phi_dot_value,
    ]
}

/// Kinetic energy T.
///
/// 16 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 6], u: &[S; 6]) -> S {
    let Parameters { m, I1, I3 } = *p;
    let [v1, v2, v3, w1, w2, w3] = *u;
    // Shared terms.
    // v1^2 + v2^2
    let v1_sq_plus_v2_sq = v2.mul_add(v2, v1 * v1);
    // I1*(w1^2 + w2^2) + I3*w3^2
    let energy_of_w1_w2_w3 = I1 * w2.mul_add(w2, w1 * w1) + I3 * w3 * w3;
    // Values.
    // T = m*v1^2/2 + m*v2^2/2 + m*v3^2/2 + I1*w1^2/2 + I1*w2^2/2 + I3*w3^2/2
    let energy = S::ratio(1, 2) * m * v3.mul_add(v3, v1_sq_plus_v2_sq)
        + S::ratio(1, 2) * energy_of_w1_w2_w3;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 0 operations.
#[must_use]
pub fn potential_energy<S: Scalar>(_p: &Parameters<S>, _q: &[S; 6]) -> S {
    let zero = S::int(0);
    zero
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 9 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    u: &[S; 6],
) -> ([S; 6], [S; 6]) {
    let Parameters { I1, I3, .. } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [v1, v2, v3, w1, w2, w3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let w2_sin_theta_inv = w2 / sin_theta;
    let w2_dot_of_w2 = w2_sin_theta_inv * cos_theta;
    // w2_dot_of_w2 - I3*w3/I1
    let w2_dot_of_w2_w3 = w2_dot_of_w2 - I3 * w3 / I1;
    // w2' = w1*(I3*w3/I1 - w2/tan(theta))
    let w2_dot = -w1 * w2_dot_of_w2_w3;
    // w1' = w2*(w2/tan(theta) - I3*w3/I1)
    let w1_dot = w2 * w2_dot_of_w2_w3;
    // Values.
    // x' = v1
    let x_dot_value = v1;
    // y' = v2
    let y_dot_value = v2;
    // z' = v3
    let z_dot_value = v3;
    // psi' = w2/sin(theta)
    let psi_dot_value = w2_sin_theta_inv;
    // theta' = w1
    let theta_dot_value = w1;
    // phi' = w3 - w2/tan(theta)
    let phi_dot_value = w3 - w2_dot_of_w2;
    let zero = S::int(0);
    (
        [
            x_dot_value, y_dot_value, z_dot_value, psi_dot_value, theta_dot_value, phi_dot_value,
        ],
        [zero, zero, zero, w1_dot, w2_dot, zero],
    )
}

/// Jacobian of the derivative by the state; columns x, y, z, psi, theta, phi, v1, v2, v3, w1, w2, w3.
///
/// 21 operations, 1 sine and cosine.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 6], u: &[S; 6]) -> [[S; 12]; 12] {
    let Parameters { I1, I3, .. } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [_, _, _, w1, w2, w3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_theta_inv = S::int(1) / sin_theta;
    let w2_sin_theta_inv = w2 * sin_theta_inv;
    let w2_dot_by_theta_of_w2 = sin_theta_inv * w2_sin_theta_inv;
    // w2_dot_by_theta = w1*w2/sin(theta)^2
    let w2_dot_by_theta = w1 * w2_dot_by_theta_of_w2;
    // w1_dot_by_theta = -w2^2/sin(theta)^2
    let w1_dot_by_theta = -w2_sin_theta_inv * w2_sin_theta_inv;
    let w2_dot_by_w1_of_w2 = w2_sin_theta_inv * cos_theta;
    let i1_inv_i3 = I3 / I1;
    let w3_i1_inv_i3 = w3 * i1_inv_i3;
    // w2_dot_by_w1 = I3*w3/I1 - w2/tan(theta)
    let w2_dot_by_w1 = w3_i1_inv_i3 - w2_dot_by_w1_of_w2;
    let cos_theta_sin_theta_inv = sin_theta_inv * cos_theta;
    // w2_dot_by_w2 = -w1/tan(theta)
    let w2_dot_by_w2 = -w1 * cos_theta_sin_theta_inv;
    // w1_dot_by_w2 = 2*w2/tan(theta) - I3*w3/I1
    let w1_dot_by_w2 = w2_dot_by_w1_of_w2.mul_add(S::int(2), -w3_i1_inv_i3);
    // Entries that are not zero.
    // d(x')/d(v1) = 1
    let x_dot_by_v1_value = S::int(1);
    // d(y')/d(v2) = 1
    let y_dot_by_v2_value = S::int(1);
    // d(z')/d(v3) = 1
    let z_dot_by_v3_value = S::int(1);
    // d(psi')/d(theta) = -w2/(sin(theta)*tan(theta))
    let psi_dot_by_theta_value = -w2_sin_theta_inv * cos_theta_sin_theta_inv;
    // d(psi')/d(w2) = 1/sin(theta)
    let psi_dot_by_w2_value = sin_theta_inv;
    // d(theta')/d(w1) = 1
    let theta_dot_by_w1_value = S::int(1);
    // d(phi')/d(theta) = w2/sin(theta)^2
    let phi_dot_by_theta_value = w2_dot_by_theta_of_w2;
    // d(phi')/d(w2) = -1/tan(theta)
    let phi_dot_by_w2_value = -cos_theta_sin_theta_inv;
    // d(phi')/d(w3) = 1
    let phi_dot_by_w3_value = S::int(1);
    // d(w1')/d(w3) = -I3*w2/I1
    let w1_dot_by_w3_value = -w2 * i1_inv_i3;
    // d(w2')/d(w3) = I3*w1/I1
    let w2_dot_by_w3_value = w1 * i1_inv_i3;
    let zero = S::int(0);
    [
        [
            zero, zero, zero, zero, zero, zero, x_dot_by_v1_value, zero, zero, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, y_dot_by_v2_value, zero, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, z_dot_by_v3_value, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, psi_dot_by_theta_value, zero, zero, zero, zero, zero,
            psi_dot_by_w2_value, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, theta_dot_by_w1_value, zero, zero,
        ],
        [
            zero, zero, zero, zero, phi_dot_by_theta_value, zero, zero, zero, zero, zero,
            phi_dot_by_w2_value, phi_dot_by_w3_value,
        ],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero],
        [
            zero, zero, zero, zero, w1_dot_by_theta, zero, zero, zero, zero, zero, w1_dot_by_w2,
            w1_dot_by_w3_value,
        ],
        [
            zero, zero, zero, zero, w2_dot_by_theta, zero, zero, zero, zero, w2_dot_by_w1,
            w2_dot_by_w2, w2_dot_by_w3_value,
        ],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 6], _u: &[S; 6]) -> [S; 1] {
    let [_, _, _, _, theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // divisor1 = sin(theta)
    let divisor1 = sin_theta;
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (v1, v2, v3, w1, w2, w3) that must act beside the loads of the model for the accelerations to be (v1', v2', v3', w1', w2', w3').
///
/// 15 operations, 1 sine and cosine.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    u: &[S; 6],
    v_dot: &[S; 6],
) -> [S; 6] {
    let Parameters { m, I1, I3 } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [_, _, _, w1, w2, w3] = *u;
    let [v1_dot, v2_dot, v3_dot, w1_dot, w2_dot, w3_dot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let tan_theta = sin_theta / cos_theta;
    // I3*w3 - I1*w2/tan(theta)
    let tau4_of_w2_w3 = I3.mul_add(w3, -I1 * w2 / tan_theta);
    // Values.
    // tau1 = m*v1'
    let tau1 = m * v1_dot;
    // tau2 = m*v2'
    let tau2 = m * v2_dot;
    // tau3 = m*v3'
    let tau3 = m * v3_dot;
    // tau4 = w2*(I3*w3 - I1*w2/tan(theta)) + I1*w1'
    let tau4 = I1.mul_add(w1_dot, w2 * tau4_of_w2_w3);
    // tau5 = w1*(I1*w2/tan(theta) - I3*w3) + I1*w2'
    let tau5 = (-w1).mul_add(tau4_of_w2_w3, I1 * w2_dot);
    // tau6 = I3*w3'
    let tau6 = I3 * w3_dot;
    [tau1, tau2, tau3, tau4, tau5, tau6]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 6 convolutions and 4 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 12]],
    history: &mut [Factors<S, 8>],
) {
    let Parameters { I1, I3, .. } = *p;
    let [_, _, _, _, theta_0, _, v1, v2, v3, w1_0, w2_0, w3] = series[0];
    // Constant in time.
    // minus_i3_w3_by_i1 = -I3*w3/I1
    let minus_i3_w3_by_i1 = -I3 * w3 / I1;
    // Order 0.
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    let over_sin_theta = S::int(1) / sin_theta_0;
    let psi_dot_2_0 = w2_0 * over_sin_theta;
    let w2_dot_of_w2_0 = cos_theta_0 * psi_dot_2_0;
    let w2_dot_of_w2_w3_0 = minus_i3_w3_by_i1 + w2_dot_of_w2_0;
    let w2_dot_of_w1_w2_w3_0 = w1_0 * w2_dot_of_w2_w3_0;
    let w1_dot_2_0 = w2_0 * w2_dot_of_w2_w3_0;
    let phi_dot_2_0 = w3 - w2_dot_of_w2_0;
    // Order 1: the rates, and what follows from them.
    let x_1 = v1;
    let y_1 = v2;
    let z_1 = v3;
    let psi_1 = psi_dot_2_0;
    let theta_1 = w1_0;
    let phi_1 = phi_dot_2_0;
    let w1_1 = w1_dot_2_0;
    let w2_1 = -w2_dot_of_w1_w2_w3_0;
    if series.len() > 1 {
        series[1] = [
            x_1, y_1, z_1, psi_1, theta_1, phi_1,
            S::int(0),
            S::int(0),
            S::int(0),
            w1_1, w2_1,
            S::int(0),
        ];
    }
    let sin_theta_1 = theta_1 * cos_theta_0;
    let cos_theta_1 = -theta_1 * sin_theta_0;
    let psi_dot_2_1 = sin_theta_1
        .mul_add(-(psi_dot_2_0 * over_sin_theta), w2_1 * over_sin_theta);
    let w2_dot_of_w2_1 = psi_dot_2_1.mul_add(cos_theta_0, cos_theta_1 * psi_dot_2_0);
    let w2_dot_of_w2_w3_1 = w2_dot_of_w2_1;
    let w2_dot_of_w1_w2_w3_1 = w2_dot_of_w2_w3_1.mul_add(w1_0, w1_1 * w2_dot_of_w2_w3_0);
    let w1_dot_2_1 = w2_dot_of_w2_w3_1.mul_add(w2_0, w2_1 * w2_dot_of_w2_w3_0);
    let phi_dot_2_1 = -w2_dot_of_w2_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([theta_1, theta_1, sin_theta_1, cos_theta_1, w1_1, w2_1]),
            padded([
                cos_theta_1, sin_theta_1, psi_dot_2_1, psi_dot_2_1, w2_dot_of_w2_w3_1,
                w2_dot_of_w2_w3_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta_last = theta_1;
    let mut w1_last = w1_1;
    let mut w2_last = w2_1;
    let mut sin_theta_last = sin_theta_1;
    let mut cos_theta_last = cos_theta_1;
    let mut psi_dot_2_last = psi_dot_2_1;
    let mut w2_dot_of_w2_w3_last = w2_dot_of_w2_w3_1;
    let mut next = [S::int(0); 8];
    // Rates at order k - 1.
    let mut x_rate = S::int(0);
    let mut y_rate = S::int(0);
    let mut z_rate = S::int(0);
    let mut psi_rate = psi_dot_2_1;
    let mut theta_rate = w1_1;
    let mut phi_rate = phi_dot_2_1;
    let mut w1_rate = w1_dot_2_1;
    let mut w2_rate = -w2_dot_of_w1_w2_w3_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let x = x_rate * over_k;
        let y = y_rate * over_k;
        let z = z_rate * over_k;
        let psi = psi_rate * over_k;
        let theta = theta_rate * over_k;
        let phi = phi_rate * over_k;
        let w1 = w1_rate * over_k;
        let w2 = w2_rate * over_k;
        series[order] = [
            x, y, z, psi, theta, phi,
            S::int(0),
            S::int(0),
            S::int(0),
            w1, w2,
            S::int(0),
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
            padded([
                theta_1
                    .mul_add(
                        cos_theta_last,
                        (count_last * theta_last).mul_add(cos_theta_1, next[0]),
                    ),
                theta_1
                    .mul_add(
                        sin_theta_last,
                        (count_last * theta_last).mul_add(sin_theta_1, next[1]),
                    ),
                sin_theta_1
                    .mul_add(
                        psi_dot_2_last,
                        sin_theta_last.mul_add(psi_dot_2_1, next[2]),
                    ),
                cos_theta_1
                    .mul_add(
                        psi_dot_2_last,
                        cos_theta_last.mul_add(psi_dot_2_1, next[3]),
                    ),
                w1_1
                    .mul_add(
                        w2_dot_of_w2_w3_last,
                        w1_last.mul_add(w2_dot_of_w2_w3_1, next[4]),
                    ),
                w2_1
                    .mul_add(
                        w2_dot_of_w2_w3_last,
                        w2_last.mul_add(w2_dot_of_w2_w3_1, next[5]),
                    ),
            ])
        };
        // sin_theta = sin(theta)
        let sin_theta = theta.mul_add(cos_theta_0, sums[0] * over_k);
        // cos_theta = cos(theta)
        let cos_theta = -theta.mul_add(sin_theta_0, sums[1] * over_k);
        // psi_dot_2 = w2/sin_theta
        let psi_dot_2 = sin_theta
            .mul_add(-(psi_dot_2_0 * over_sin_theta), (w2 - sums[2]) * over_sin_theta);
        // w2_dot_of_w2 = cos_theta*psi_dot_2
        let w2_dot_of_w2 = psi_dot_2
            .mul_add(cos_theta_0, cos_theta.mul_add(psi_dot_2_0, sums[3]));
        // w2_dot_of_w2_w3 = minus_i3_w3_by_i1 + w2_dot_of_w2
        let w2_dot_of_w2_w3 = w2_dot_of_w2;
        // w2_dot_of_w1_w2_w3 = w1*w2_dot_of_w2_w3
        let w2_dot_of_w1_w2_w3 = w2_dot_of_w2_w3
            .mul_add(w1_0, w1.mul_add(w2_dot_of_w2_w3_0, sums[4]));
        // w1_dot_2 = w2*w2_dot_of_w2_w3
        let w1_dot_2 = w2_dot_of_w2_w3
            .mul_add(w2_0, w2.mul_add(w2_dot_of_w2_w3_0, sums[5]));
        // phi_dot_2 = w3 - w2_dot_of_w2
        let phi_dot_2 = -w2_dot_of_w2;
        x_rate = S::int(0);
        y_rate = S::int(0);
        z_rate = S::int(0);
        psi_rate = psi_dot_2;
        theta_rate = w1;
        phi_rate = phi_dot_2;
        w1_rate = w1_dot_2;
        w2_rate = -w2_dot_of_w1_w2_w3;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([count * theta, count * theta, sin_theta, cos_theta, w1, w2]),
            padded([
                cos_theta, sin_theta, psi_dot_2, psi_dot_2, w2_dot_of_w2_w3, w2_dot_of_w2_w3,
            ]),
        ];
        count_last = count;
        theta_last = theta;
        w1_last = w1;
        w2_last = w2;
        sin_theta_last = sin_theta;
        cos_theta_last = cos_theta;
        psi_dot_2_last = psi_dot_2;
        w2_dot_of_w2_w3_last = w2_dot_of_w2_w3;
    }
}

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 3,
            coordinates: 6,
            variables: 6,
            speeds: 6,
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
        12
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
        ["sin(theta)"][at]
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
