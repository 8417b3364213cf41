//! Spherical pendulum: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/spherical_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1, u2.
///
/// 2 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 2],
    _u: &[S; 2],
) -> [[S; 2]; 2] {
    let Parameters { m, l, .. } = *p;
    // Shared terms.
    let m_l_sq = m * l * l;
    // Entries that are not zero; upper triangle.
    // M11 = m*l^2
    let m11 = m_l_sq;
    // M22 = m*l^2
    let m22 = m_l_sq;
    let zero = S::int(0);
    [[m11, zero], [zero, m22]]
}

/// Right-hand side of the linear system; unknowns (u1', u2').
///
/// 11 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 2] {
    let Parameters { m, l, g } = *p;
    let [theta, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let tan_theta = sin_theta / cos_theta;
    let f1_of_u2 = l * u2 / tan_theta;
    let m_l = m * l;
    // Values.
    // f1 = m*l*(l*u2^2/tan(theta) - g*sin(theta))
    let f1 = m_l * (-g).mul_add(sin_theta, u2 * f1_of_u2);
    // f2 = -m*l^2*u1*u2/tan(theta)
    let f2 = -u1 * f1_of_u2 * m_l;
    [f1, f2]
}

/// The accelerations (u1', u2'), solved for when this code was generated.
///
/// 8 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 2] {
    let Parameters { l, g, .. } = *p;
    let [theta, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let tan_theta = sin_theta / cos_theta;
    let u2_dot_of_u2 = u2 / tan_theta;
    // u2' = -u1*u2/tan(theta)
    let u2_dot = -u1 * u2_dot_of_u2;
    // u1' = u2^2/tan(theta) - g*sin(theta)/l
    let u1_dot = u2.mul_add(u2_dot_of_u2, -g * sin_theta / l);
    [u1_dot, u2_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 1 operation, 1 sine and cosine.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
) -> [S; 2] {
    let [theta, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // theta' = u1
    let theta_dot_value = u1;
    // phi' = u2/sin(theta)
    let phi_dot_value = u2 / sin_theta;
    [theta_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 7 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 2], u: &[S; 2]) -> S {
    let Parameters { m, l, .. } = *p;
    let [u1, u2] = *u;
    // Values.
    // T = m*l^2*u1^2/2 + m*l^2*u2^2/2
    let energy = S::ratio(1, 2) * m * l * l * u2.mul_add(u2, u1 * u1);
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2]) -> S {
    let Parameters { m, l, g } = *p;
    let [theta, _] = *q;
    // Sines and cosines.
    let (_, cos_theta) = theta.sin_cos();
    // Values.
    // V = m*l*g*(1 - cos(theta))
    let energy = m * l * g * (S::int(1) - cos_theta);
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 8 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let Parameters { l, g, .. } = *p;
    let [theta, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let u2_sin_theta_inv = u2 / sin_theta;
    let u2_dot_of_u2 = u2_sin_theta_inv * cos_theta;
    // u2' = -u1*u2/tan(theta)
    let u2_dot = -u1 * u2_dot_of_u2;
    // u1' = u2^2/tan(theta) - g*sin(theta)/l
    let u1_dot = u2.mul_add(u2_dot_of_u2, -g * sin_theta / l);
    // Values.
    // theta' = u1
    let theta_dot_value = u1;
    // phi' = u2/sin(theta)
    let phi_dot_value = u2_sin_theta_inv;
    ([theta_dot_value, phi_dot_value], [u1_dot, u2_dot])
}

/// Jacobian of the derivative by the state; columns theta, phi, u1, u2.
///
/// 16 operations, 1 sine and cosine.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [[S; 4]; 4] {
    let Parameters { l, g, .. } = *p;
    let [theta, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_theta_inv = S::int(1) / sin_theta;
    let u2_sin_theta_inv = u2 * sin_theta_inv;
    let u1_sin_theta_inv = u1 * sin_theta_inv;
    // u2_dot_by_theta = u1*u2/sin(theta)^2
    let u2_dot_by_theta = u2_sin_theta_inv * u1_sin_theta_inv;
    // u1_dot_by_theta = -g*cos(theta)/l - u2^2/sin(theta)^2
    let u1_dot_by_theta = (-u2_sin_theta_inv)
        .mul_add(u2_sin_theta_inv, -g * cos_theta / l);
    let u2_dot_by_u1_of_u2 = u2_sin_theta_inv * cos_theta;
    // u2_dot_by_u1 = -u2/tan(theta)
    let u2_dot_by_u1 = -u2_dot_by_u1_of_u2;
    // u2_dot_by_u2 = -u1/tan(theta)
    let u2_dot_by_u2 = -u1_sin_theta_inv * cos_theta;
    // u1_dot_by_u2 = 2*u2/tan(theta)
    let u1_dot_by_u2 = S::int(2) * u2_dot_by_u1_of_u2;
    // Entries that are not zero.
    // d(theta')/d(u1) = 1
    let theta_dot_by_u1_value = S::int(1);
    // d(phi')/d(theta) = -u2/(sin(theta)*tan(theta))
    let phi_dot_by_theta_value = -sin_theta_inv * u2_dot_by_u1_of_u2;
    // d(phi')/d(u2) = 1/sin(theta)
    let phi_dot_by_u2_value = sin_theta_inv;
    let zero = S::int(0);
    [
        [zero, zero, theta_dot_by_u1_value, zero],
        [phi_dot_by_theta_value, zero, zero, phi_dot_by_u2_value],
        [u1_dot_by_theta, zero, zero, u1_dot_by_u2],
        [u2_dot_by_theta, zero, u2_dot_by_u1, u2_dot_by_u2],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 2], _u: &[S; 2]) -> [S; 1] {
    let [theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // divisor1 = sin(theta)
    let divisor1 = sin_theta;
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (u1, u2) that must act beside the loads of the model for the accelerations to be (u1', u2').
///
/// 14 operations, 1 sine and cosine.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { m, l, g } = *p;
    let [theta, _] = *q;
    let [u1, u2] = *u;
    let [u1_dot, u2_dot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let m_l = m * l;
    let tan_theta = sin_theta / cos_theta;
    let tau1_of_u2 = u2 / tan_theta;
    // l*u2*tau1_of_u2 - g*sin(theta)
    let tau1_of_u2_2 = (-g).mul_add(sin_theta, l * u2 * tau1_of_u2);
    // Values.
    // tau1 = m*l*(g*sin(theta) - l*u2^2/tan(theta)) + m*l^2*u1'
    let tau1 = m_l * l.mul_add(u1_dot, -tau1_of_u2_2);
    // tau2 = m*l^2*u1*u2/tan(theta) + m*l^2*u2'
    let tau2 = l * m_l * u1.mul_add(tau1_of_u2, u2_dot);
    [tau1, tau2]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 6 convolutions and 4 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 4]],
    history: &mut [Factors<S, 8>],
) {
    let Parameters { l, g, .. } = *p;
    let [theta_0, _, u1_0, u2_0] = series[0];
    // Constant in time.
    // minus_g_by_l = -g/l
    let minus_g_by_l = -g / l;
    // Order 0.
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    let over_sin_theta = S::int(1) / sin_theta_0;
    let phi_dot_2_0 = u2_0 * over_sin_theta;
    let u2_dot_of_u2_0 = cos_theta_0 * phi_dot_2_0;
    let u2_dot_of_u1_u2_0 = u1_0 * u2_dot_of_u2_0;
    let u1_dot_of_u2_0 = u2_0 * u2_dot_of_u2_0;
    let u1_dot_2_0 = minus_g_by_l * sin_theta_0 + u1_dot_of_u2_0;
    // Order 1: the rates, and what follows from them.
    let theta_1 = u1_0;
    let phi_1 = phi_dot_2_0;
    let u1_1 = u1_dot_2_0;
    let u2_1 = -u2_dot_of_u1_u2_0;
    if series.len() > 1 {
        series[1] = [theta_1, phi_1, u1_1, u2_1];
    }
    let sin_theta_1 = theta_1 * cos_theta_0;
    let cos_theta_1 = -theta_1 * sin_theta_0;
    let phi_dot_2_1 = sin_theta_1
        .mul_add(-(phi_dot_2_0 * over_sin_theta), u2_1 * over_sin_theta);
    let u2_dot_of_u2_1 = phi_dot_2_1.mul_add(cos_theta_0, cos_theta_1 * phi_dot_2_0);
    let u2_dot_of_u1_u2_1 = u2_dot_of_u2_1.mul_add(u1_0, u1_1 * u2_dot_of_u2_0);
    let u1_dot_of_u2_1 = u2_dot_of_u2_1.mul_add(u2_0, u2_1 * u2_dot_of_u2_0);
    let u1_dot_2_1 = minus_g_by_l * sin_theta_1 + u1_dot_of_u2_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([theta_1, theta_1, sin_theta_1, cos_theta_1, u1_1, u2_1]),
            padded([
                cos_theta_1, sin_theta_1, phi_dot_2_1, phi_dot_2_1, u2_dot_of_u2_1, u2_dot_of_u2_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta_last = theta_1;
    let mut u1_last = u1_1;
    let mut u2_last = u2_1;
    let mut sin_theta_last = sin_theta_1;
    let mut cos_theta_last = cos_theta_1;
    let mut phi_dot_2_last = phi_dot_2_1;
    let mut u2_dot_of_u2_last = u2_dot_of_u2_1;
    let mut next = [S::int(0); 8];
    // Rates at order k - 1.
    let mut theta_rate = u1_1;
    let mut phi_rate = phi_dot_2_1;
    let mut u1_rate = u1_dot_2_1;
    let mut u2_rate = -u2_dot_of_u1_u2_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let theta = theta_rate * over_k;
        let phi = phi_rate * over_k;
        let u1 = u1_rate * over_k;
        let u2 = u2_rate * over_k;
        series[order] = [theta, phi, u1, u2];
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
                        phi_dot_2_last,
                        sin_theta_last.mul_add(phi_dot_2_1, next[2]),
                    ),
                cos_theta_1
                    .mul_add(
                        phi_dot_2_last,
                        cos_theta_last.mul_add(phi_dot_2_1, next[3]),
                    ),
                u1_1
                    .mul_add(
                        u2_dot_of_u2_last,
                        u1_last.mul_add(u2_dot_of_u2_1, next[4]),
                    ),
                u2_1.mul_add(u2_dot_of_u2_last, u2_last.mul_add(u2_dot_of_u2_1, next[5])),
            ])
        };
        // sin_theta = sin(theta)
        let sin_theta = theta.mul_add(cos_theta_0, sums[0] * over_k);
        // cos_theta = cos(theta)
        let cos_theta = -theta.mul_add(sin_theta_0, sums[1] * over_k);
        // phi_dot_2 = u2/sin_theta
        let phi_dot_2 = sin_theta
            .mul_add(-(phi_dot_2_0 * over_sin_theta), (u2 - sums[2]) * over_sin_theta);
        // u2_dot_of_u2 = cos_theta*phi_dot_2
        let u2_dot_of_u2 = phi_dot_2
            .mul_add(cos_theta_0, cos_theta.mul_add(phi_dot_2_0, sums[3]));
        // u2_dot_of_u1_u2 = u1*u2_dot_of_u2
        let u2_dot_of_u1_u2 = u2_dot_of_u2
            .mul_add(u1_0, u1.mul_add(u2_dot_of_u2_0, sums[4]));
        // u1_dot_of_u2 = u2*u2_dot_of_u2
        let u1_dot_of_u2 = u2_dot_of_u2
            .mul_add(u2_0, u2.mul_add(u2_dot_of_u2_0, sums[5]));
        // u1_dot_2 = minus_g_by_l*sin_theta + u1_dot_of_u2
        let u1_dot_2 = minus_g_by_l * sin_theta + u1_dot_of_u2;
        theta_rate = u1;
        phi_rate = phi_dot_2;
        u1_rate = u1_dot_2;
        u2_rate = -u2_dot_of_u1_u2;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([count * theta, count * theta, sin_theta, cos_theta, u1, u2]),
            padded([
                cos_theta, sin_theta, phi_dot_2, phi_dot_2, u2_dot_of_u2, u2_dot_of_u2,
            ]),
        ];
        count_last = count;
        theta_last = theta;
        u1_last = u1;
        u2_last = u2;
        sin_theta_last = sin_theta;
        cos_theta_last = cos_theta;
        phi_dot_2_last = phi_dot_2;
        u2_dot_of_u2_last = u2_dot_of_u2;
    }
}

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 3,
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
