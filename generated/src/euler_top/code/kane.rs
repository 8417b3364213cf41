//! Symmetric heavy top in Euler's angles: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/euler_top/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1, u2, u3.
///
/// 0 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 3],
    _u: &[S; 3],
) -> [[S; 3]; 3] {
    let Parameters { I1, I3, .. } = *p;
    // Entries that are not zero; upper triangle.
    // M11 = I1
    let m11 = I1;
    // M22 = I1
    let m22 = I1;
    // M33 = I3
    let m33 = I3;
    let zero = S::int(0);
    [[m11, zero, zero], [zero, m22, zero], [zero, zero, m33]]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3').
///
/// 11 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 3]) -> [S; 3] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [_, theta, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let tan_theta = sin_theta / cos_theta;
    // I3*u3 - I1*u2/tan(theta)
    let f1_of_u2_u3 = I3.mul_add(u3, -I1 * u2 / tan_theta);
    // Values.
    // f1 = m*l*g*sin(theta) + u2*(I1*u2/tan(theta) - I3*u3)
    let f1 = (-u2).mul_add(f1_of_u2_u3, m * l * g * sin_theta);
    // f2 = u1*(I3*u3 - I1*u2/tan(theta))
    let f2 = u1 * f1_of_u2_u3;
    let zero = S::int(0);
    [f1, f2, zero]
}

/// The accelerations (u1', u2', u3'), solved for when this code was generated.
///
/// 13 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 3]) -> [S; 3] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [_, theta, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let i1_inv = S::int(1) / I1;
    let tan_theta = sin_theta / cos_theta;
    // I3*u3*i1_inv - u2/tan(theta)
    let u2_dot_of_u2_u3 = (I3 * u3).mul_add(i1_inv, -u2 / tan_theta);
    // u2' = u1*(I3*u3/I1 - u2/tan(theta))
    let u2_dot = u1 * u2_dot_of_u2_u3;
    // u1' = (m*l*g*sin(theta) + u2*(I1*u2/tan(theta) - I3*u3))/I1
    let u1_dot = (-u2).mul_add(u2_dot_of_u2_u3, m * l * g * i1_inv * sin_theta);
    let zero = S::int(0);
    [u1_dot, u2_dot, zero]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 3],
) -> [S; 3] {
    let [_, theta, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let u2_sin_theta_inv = u2 / sin_theta;
    // Values.
    // psi' = u2/sin(theta)
    let psi_dot_value = u2_sin_theta_inv;
    // theta' = u1
    let theta_dot_value = u1;
    // phi' = u3 - u2/tan(theta)
    let phi_dot_value = (-u2_sin_theta_inv).mul_add(cos_theta, u3);
    [psi_dot_value, theta_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 8 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 3], u: &[S; 3]) -> S {
    let Parameters { I1, I3, .. } = *p;
    let [u1, u2, u3] = *u;
    // Shared terms.
    // I1*(u1^2 + u2^2) + I3*u3^2
    let energy_of_u1_u2_u3 = I1 * u2.mul_add(u2, u1 * u1) + I3 * u3 * u3;
    // Values.
    // T = I1*u1^2/2 + I1*u2^2/2 + I3*u3^2/2
    let energy = S::ratio(1, 2) * energy_of_u1_u2_u3;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3]) -> S {
    let Parameters { m, l, g, .. } = *p;
    let [_, theta, _] = *q;
    // Sines and cosines.
    let (_, cos_theta) = theta.sin_cos();
    // Values.
    // V = m*l*g*cos(theta)
    let energy = m * l * g * cos_theta;
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 14 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 3],
) -> ([S; 3], [S; 3]) {
    let Parameters { m, l, I1, I3, g } = *p;
    let [_, theta, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let i1_inv = S::int(1) / I1;
    let u2_sin_theta_inv = u2 / sin_theta;
    let u2_dot_of_u2 = u2_sin_theta_inv * cos_theta;
    // I3*u3*i1_inv - u2_dot_of_u2
    let u2_dot_of_u2_u3 = (I3 * u3).mul_add(i1_inv, -u2_dot_of_u2);
    // u2' = u1*(I3*u3/I1 - u2/tan(theta))
    let u2_dot = u1 * u2_dot_of_u2_u3;
    // u1' = (m*l*g*sin(theta) + u2*(I1*u2/tan(theta) - I3*u3))/I1
    let u1_dot = (-u2).mul_add(u2_dot_of_u2_u3, m * l * g * i1_inv * sin_theta);
    // Values.
    // psi' = u2/sin(theta)
    let psi_dot_value = u2_sin_theta_inv;
    // theta' = u1
    let theta_dot_value = u1;
    // phi' = u3 - u2/tan(theta)
    let phi_dot_value = u3 - u2_dot_of_u2;
    let zero = S::int(0);
    ([psi_dot_value, theta_dot_value, phi_dot_value], [u1_dot, u2_dot, zero])
}

/// Jacobian of the derivative by the state; columns psi, theta, phi, u1, u2, u3.
///
/// 26 operations, 1 sine and cosine.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 3]) -> [[S; 6]; 6] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [_, theta, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_theta_inv = S::int(1) / sin_theta;
    let u2_sin_theta_inv = u2 * sin_theta_inv;
    let u2_dot_by_theta_of_u2 = sin_theta_inv * u2_sin_theta_inv;
    // u2_dot_by_theta = u1*u2/sin(theta)^2
    let u2_dot_by_theta = u1 * u2_dot_by_theta_of_u2;
    let i1_inv = S::int(1) / I1;
    // u1_dot_by_theta = m*l*g*cos(theta)/I1 - u2^2/sin(theta)^2
    let u1_dot_by_theta = (-u2_sin_theta_inv)
        .mul_add(u2_sin_theta_inv, m * l * g * i1_inv * cos_theta);
    let u2_dot_by_u1_of_u2 = u2_sin_theta_inv * cos_theta;
    let i3_i1_inv = I3 * i1_inv;
    let u3_i3_i1_inv = u3 * i3_i1_inv;
    // u2_dot_by_u1 = I3*u3/I1 - u2/tan(theta)
    let u2_dot_by_u1 = u3_i3_i1_inv - u2_dot_by_u1_of_u2;
    let cos_theta_sin_theta_inv = sin_theta_inv * cos_theta;
    // u2_dot_by_u2 = -u1/tan(theta)
    let u2_dot_by_u2 = -u1 * cos_theta_sin_theta_inv;
    // u1_dot_by_u2 = 2*u2/tan(theta) - I3*u3/I1
    let u1_dot_by_u2 = u2_dot_by_u1_of_u2.mul_add(S::int(2), -u3_i3_i1_inv);
    // Entries that are not zero.
    // d(psi')/d(theta) = -u2/(sin(theta)*tan(theta))
    let psi_dot_by_theta_value = -u2_sin_theta_inv * cos_theta_sin_theta_inv;
    // d(psi')/d(u2) = 1/sin(theta)
    let psi_dot_by_u2_value = sin_theta_inv;
    // d(theta')/d(u1) = 1
    let theta_dot_by_u1_value = S::int(1);
    // d(phi')/d(theta) = u2/sin(theta)^2
    let phi_dot_by_theta_value = u2_dot_by_theta_of_u2;
    // d(phi')/d(u2) = -1/tan(theta)
    let phi_dot_by_u2_value = -cos_theta_sin_theta_inv;
    // d(phi')/d(u3) = 1
    let phi_dot_by_u3_value = S::int(1);
    // d(u1')/d(u3) = -I3*u2/I1
    let u1_dot_by_u3_value = -u2 * i3_i1_inv;
    // d(u2')/d(u3) = I3*u1/I1
    let u2_dot_by_u3_value = u1 * i3_i1_inv;
    let zero = S::int(0);
    [
        [zero, psi_dot_by_theta_value, zero, zero, psi_dot_by_u2_value, zero],
        [zero, zero, zero, theta_dot_by_u1_value, zero, zero],
        [
            zero, phi_dot_by_theta_value, zero, zero, phi_dot_by_u2_value, phi_dot_by_u3_value,
        ],
        [zero, u1_dot_by_theta, zero, zero, u1_dot_by_u2, u1_dot_by_u3_value],
        [zero, u2_dot_by_theta, zero, u2_dot_by_u1, u2_dot_by_u2, u2_dot_by_u3_value],
        [zero, zero, zero, zero, zero, zero],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 3], _u: &[S; 3]) -> [S; 1] {
    let [_, theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // divisor1 = sin(theta)
    let divisor1 = sin_theta;
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (u1, u2, u3) that must act beside the loads of the model for the accelerations to be (u1', u2', u3').
///
/// 16 operations, 1 sine and cosine.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 3],
    v_dot: &[S; 3],
) -> [S; 3] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [_, theta, _] = *q;
    let [u1, u2, u3] = *u;
    let [u1_dot, u2_dot, u3_dot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let tan_theta = sin_theta / cos_theta;
    // I3*u3 - I1*u2/tan(theta)
    let tau1_of_u2_u3 = I3.mul_add(u3, -I1 * u2 / tan_theta);
    // Values.
    // tau1 = u2*(I3*u3 - I1*u2/tan(theta)) - m*l*g*sin(theta) + I1*u1'
    let tau1 = (-(m * l * g)).mul_add(sin_theta, u2 * tau1_of_u2_u3) + I1 * u1_dot;
    // tau2 = u1*(I1*u2/tan(theta) - I3*u3) + I1*u2'
    let tau2 = (-u1).mul_add(tau1_of_u2_u3, I1 * u2_dot);
    // tau3 = I3*u3'
    let tau3 = I3 * u3_dot;
    [tau1, tau2, tau3]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 6 convolutions and 8 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 6]],
    history: &mut [Factors<S, 8>],
) {
    let Parameters { m, l, I1, I3, g } = *p;
    let [_, theta_0, _, u1_0, u2_0, u3] = series[0];
    // Constant in time.
    // minus_i3_u3_by_i1 = -I3*u3/I1
    let minus_i3_u3_by_i1 = -I3 * u3 / I1;
    // m_l_g_by_i1 = m*l*g/I1
    let m_l_g_by_i1 = m * l * g / I1;
    // Order 0.
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    let over_sin_theta = S::int(1) / sin_theta_0;
    let psi_dot_2_0 = u2_0 * over_sin_theta;
    let u2_dot_of_u2_0 = cos_theta_0 * psi_dot_2_0;
    let u2_dot_of_u2_u3_0 = minus_i3_u3_by_i1 + u2_dot_of_u2_0;
    let u2_dot_of_u1_u2_u3_0 = u1_0 * u2_dot_of_u2_u3_0;
    let u1_dot_of_u2_u3_0 = u2_0 * u2_dot_of_u2_u3_0;
    let u1_dot_2_0 = m_l_g_by_i1 * sin_theta_0 + u1_dot_of_u2_u3_0;
    let phi_dot_2_0 = u3 - u2_dot_of_u2_0;
    // Order 1: the rates, and what follows from them.
    let psi_1 = psi_dot_2_0;
    let theta_1 = u1_0;
    let phi_1 = phi_dot_2_0;
    let u1_1 = u1_dot_2_0;
    let u2_1 = -u2_dot_of_u1_u2_u3_0;
    if series.len() > 1 {
        series[1] = [psi_1, theta_1, phi_1, u1_1, u2_1, S::int(0)];
    }
    let sin_theta_1 = theta_1 * cos_theta_0;
    let cos_theta_1 = -theta_1 * sin_theta_0;
    let psi_dot_2_1 = sin_theta_1
        .mul_add(-(psi_dot_2_0 * over_sin_theta), u2_1 * over_sin_theta);
    let u2_dot_of_u2_1 = psi_dot_2_1.mul_add(cos_theta_0, cos_theta_1 * psi_dot_2_0);
    let u2_dot_of_u2_u3_1 = u2_dot_of_u2_1;
    let u2_dot_of_u1_u2_u3_1 = u2_dot_of_u2_u3_1.mul_add(u1_0, u1_1 * u2_dot_of_u2_u3_0);
    let u1_dot_of_u2_u3_1 = u2_dot_of_u2_u3_1.mul_add(u2_0, u2_1 * u2_dot_of_u2_u3_0);
    let u1_dot_2_1 = m_l_g_by_i1 * sin_theta_1 + u1_dot_of_u2_u3_1;
    let phi_dot_2_1 = -u2_dot_of_u2_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([theta_1, theta_1, sin_theta_1, cos_theta_1, u1_1, u2_1]),
            padded([
                cos_theta_1, sin_theta_1, psi_dot_2_1, psi_dot_2_1, u2_dot_of_u2_u3_1,
                u2_dot_of_u2_u3_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta_last = theta_1;
    let mut u1_last = u1_1;
    let mut u2_last = u2_1;
    let mut sin_theta_last = sin_theta_1;
    let mut cos_theta_last = cos_theta_1;
    let mut psi_dot_2_last = psi_dot_2_1;
    let mut u2_dot_of_u2_u3_last = u2_dot_of_u2_u3_1;
    let mut next = [S::int(0); 8];
    // Rates at order k - 1.
    let mut psi_rate = psi_dot_2_1;
    let mut theta_rate = u1_1;
    let mut phi_rate = phi_dot_2_1;
    let mut u1_rate = u1_dot_2_1;
    let mut u2_rate = -u2_dot_of_u1_u2_u3_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let psi = psi_rate * over_k;
        let theta = theta_rate * over_k;
        let phi = phi_rate * over_k;
        let u1 = u1_rate * over_k;
        let u2 = u2_rate * over_k;
        series[order] = [psi, theta, phi, u1, u2, S::int(0)];
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
                u1_1
                    .mul_add(
                        u2_dot_of_u2_u3_last,
                        u1_last.mul_add(u2_dot_of_u2_u3_1, next[4]),
                    ),
                u2_1
                    .mul_add(
                        u2_dot_of_u2_u3_last,
                        u2_last.mul_add(u2_dot_of_u2_u3_1, next[5]),
                    ),
            ])
        };
        // sin_theta = sin(theta)
        let sin_theta = theta.mul_add(cos_theta_0, sums[0] * over_k);
        // cos_theta = cos(theta)
        let cos_theta = -theta.mul_add(sin_theta_0, sums[1] * over_k);
        // psi_dot_2 = u2/sin_theta
        let psi_dot_2 = sin_theta
            .mul_add(-(psi_dot_2_0 * over_sin_theta), (u2 - sums[2]) * over_sin_theta);
        // u2_dot_of_u2 = cos_theta*psi_dot_2
        let u2_dot_of_u2 = psi_dot_2
            .mul_add(cos_theta_0, cos_theta.mul_add(psi_dot_2_0, sums[3]));
        // u2_dot_of_u2_u3 = minus_i3_u3_by_i1 + u2_dot_of_u2
        let u2_dot_of_u2_u3 = u2_dot_of_u2;
        // u2_dot_of_u1_u2_u3 = u1*u2_dot_of_u2_u3
        let u2_dot_of_u1_u2_u3 = u2_dot_of_u2_u3
            .mul_add(u1_0, u1.mul_add(u2_dot_of_u2_u3_0, sums[4]));
        // u1_dot_of_u2_u3 = u2*u2_dot_of_u2_u3
        let u1_dot_of_u2_u3 = u2_dot_of_u2_u3
            .mul_add(u2_0, u2.mul_add(u2_dot_of_u2_u3_0, sums[5]));
        // u1_dot_2 = m_l_g_by_i1*sin_theta + u1_dot_of_u2_u3
        let u1_dot_2 = m_l_g_by_i1 * sin_theta + u1_dot_of_u2_u3;
        // phi_dot_2 = u3 - u2_dot_of_u2
        let phi_dot_2 = -u2_dot_of_u2;
        psi_rate = psi_dot_2;
        theta_rate = u1;
        phi_rate = phi_dot_2;
        u1_rate = u1_dot_2;
        u2_rate = -u2_dot_of_u1_u2_u3;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([count * theta, count * theta, sin_theta, cos_theta, u1, u2]),
            padded([
                cos_theta, sin_theta, psi_dot_2, psi_dot_2, u2_dot_of_u2_u3, u2_dot_of_u2_u3,
            ]),
        ];
        count_last = count;
        theta_last = theta;
        u1_last = u1;
        u2_last = u2;
        sin_theta_last = sin_theta;
        cos_theta_last = cos_theta;
        psi_dot_2_last = psi_dot_2;
        u2_dot_of_u2_u3_last = u2_dot_of_u2_u3;
    }
}

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 5,
            coordinates: 3,
            variables: 3,
            speeds: 3,
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
        6
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
