//! Chaotic pendulum: a swinging rod with a plate turning about it: Swing with a turning plate.
//!
//! Generated from `models/chaotic_pendulum/scenes/swing.toml`. Do not edit; run `tripos regenerate`.
//! Outputs: theta, phi, omega, alpha.
//! States: theta, phi, omega, alpha. Quadratures: none.
//! Parameters that the scene fixes: mA = 0.8, mB = 1.5, lA = 0.4, lB = 0.9, IAxx = 0.011, IBxx = 0.02, IByy = 0.05, IBzz = 0.065, g = 9.81.
//! Cost: accelerations 14 operations, 2 sines and cosines; derivative 14 operations, 2 sines and cosines.
//! Singular nowhere.

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{CompiledScene, CompiledSystem, Scalar, System};

/// The parameters, in the order of the model file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// A model without parameters.
    pub none: core::marker::PhantomData<S>,
}

impl<S: Scalar> Parameters<S> {
    /// From values in the order of [`PARAMETERS`].
    ///
    /// # Panics
    /// If `p` has fewer values than there are parameters.
    #[must_use]
    #[inline(always)]
    pub fn from_slice(_p: &[S]) -> Self {
        Self {
            none: core::marker::PhantomData,
        }
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 0] = [];

/// Names of the outputs.
pub const OUTPUTS: [&str; 4] = ["theta", "phi", "omega", "alpha"];

/// The accelerations (omega', alpha'), solved for when this code was generated.
///
/// 14 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(_p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 2] {
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, _) = theta.sin_cos();
    // Shared terms.
    // omega*sin(phi)*cos(phi); used 2 times
    let omega_dot_part = omega * sin_phi * cos_phi;
    // Elimination, step by step.
    // omega' = (200*omega*alpha*sin(phi)*cos(phi) - 54609*sin(theta))/(20*(229 + 5*cos(phi)^2))
    let omega_dot = S::ratio(1, 20)
        * (-sin_theta).mul_add(S::int(54609), S::int(200) * alpha * omega_dot_part)
        / (S::int(229) + S::int(5) * cos_phi * cos_phi);
    // alpha' = -6*omega^2*sin(phi)*cos(phi)/13
    let alpha_dot = -S::ratio(6, 13) * omega * omega_dot_part;
    [omega_dot, alpha_dot]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 14 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, _) = theta.sin_cos();
    // Shared terms.
    // omega*sin(phi)*cos(phi); used 2 times
    let omega_dot_part = omega * sin_phi * cos_phi;
    // Elimination, step by step.
    // omega' = (200*omega*alpha*sin(phi)*cos(phi) - 54609*sin(theta))/(20*(229 + 5*cos(phi)^2))
    let omega_dot = S::ratio(1, 20)
        * (-sin_theta).mul_add(S::int(54609), S::int(200) * alpha * omega_dot_part)
        / (S::int(229) + S::int(5) * cos_phi * cos_phi);
    // alpha' = -6*omega^2*sin(phi)*cos(phi)/13
    let alpha_dot = -S::ratio(6, 13) * omega * omega_dot_part;
    // Values.
    // theta' = omega
    let theta_dot_value = omega;
    // phi' = alpha
    let phi_dot_value = alpha;
    ([theta_dot_value, phi_dot_value], [omega_dot, alpha_dot])
}

/// Jacobian of the derivative by the state; columns theta, phi, omega, alpha.
///
/// 31 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(_p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [[S; 4]; 4] {
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    let zero = S::int(0);
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    // cos(phi)^2; used 3 times
    let cos_phi_sq = cos_phi * cos_phi;
    // 1/(229 + 5*cos_phi_sq); used 3 times
    let omega_dot_by_theta_part = S::int(1) / cos_phi_sq.mul_add(S::int(5), S::int(229));
    // Elimination, step by step.
    // omega_dot_by_theta = -54609*cos(theta)/(20*(229 + 5*cos(phi)^2))
    let omega_dot_by_theta = -S::ratio(54609, 20) * omega_dot_by_theta_part * cos_theta;
    // Shared terms.
    // sin(phi)*cos(phi); used 3 times
    let sin_phi_cos_phi = sin_phi * cos_phi;
    // Elimination, step by step.
    // omega_dot_by_phi = (20*omega*alpha*(463*cos(phi)^2 - 229) -
    //   54609*sin(theta)*sin(phi)*cos(phi))/(2*(229 + 5*cos(phi)^2)^2)
    let omega_dot_by_phi = S::ratio(1, 2) * omega_dot_by_theta_part
        * omega_dot_by_theta_part
        * (S::int(20) * omega * alpha * cos_phi_sq.mul_add(S::int(463), -S::int(229))
            - S::int(54609) * sin_phi_cos_phi * sin_theta);
    // alpha_dot_by_phi = 6*omega^2*(1 - 2*cos(phi)^2)/13
    let alpha_dot_by_phi = S::ratio(6, 13) * omega * omega
        * (-cos_phi_sq).mul_add(S::int(2), S::int(1));
    // Shared terms.
    // 10*omega_dot_by_theta_part; used 2 times
    let omega_dot_by_omega_part = S::int(10) * omega_dot_by_theta_part;
    // Elimination, step by step.
    // omega_dot_by_omega = 10*alpha*sin(phi)*cos(phi)/(229 + 5*cos(phi)^2)
    let omega_dot_by_omega = alpha * sin_phi_cos_phi * omega_dot_by_omega_part;
    // Shared terms.
    // omega*sin_phi_cos_phi; used 2 times
    let alpha_dot_by_omega_part = omega * sin_phi_cos_phi;
    // Elimination, step by step.
    // alpha_dot_by_omega = -12*omega*sin(phi)*cos(phi)/13
    let alpha_dot_by_omega = -S::ratio(12, 13) * alpha_dot_by_omega_part;
    // omega_dot_by_alpha = 10*omega*sin(phi)*cos(phi)/(229 + 5*cos(phi)^2)
    let omega_dot_by_alpha = omega_dot_by_omega_part * alpha_dot_by_omega_part;
    // Entries that are not zero.
    // d(theta')/d(omega) = 1
    let theta_dot_by_omega_value = S::int(1);
    // d(phi')/d(alpha) = 1
    let phi_dot_by_alpha_value = S::int(1);
    [
        [zero, zero, theta_dot_by_omega_value, zero],
        [zero, zero, zero, phi_dot_by_alpha_value],
        [omega_dot_by_theta, omega_dot_by_phi, omega_dot_by_omega, omega_dot_by_alpha],
        [zero, alpha_dot_by_phi, alpha_dot_by_omega, zero],
    ]
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
    let [omega, alpha] = *u;
    // Values.
    // theta' = omega
    let theta_dot_value = omega;
    // phi' = alpha
    let phi_dot_value = alpha;
    [theta_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 9 operations, 1 sine and cosine.
#[must_use]
pub fn kinetic_energy<S: Scalar>(_p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> S {
    let [_, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (_, cos_phi) = phi.sin_cos();
    // Values.
    // T = 3*omega^2*(229 + 5*cos(phi)^2)/1000 + 13*alpha^2/400
    let energy = S::ratio(3, 1000) * omega * omega
        * (S::int(229) + S::int(5) * cos_phi * cos_phi)
        + S::ratio(13, 400) * alpha * alpha;
    energy
}

/// Potential energy V of gravity.
///
/// 2 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(_p: &Parameters<S>, q: &[S; 2]) -> S {
    let [theta, _] = *q;
    // Sines and cosines.
    let (_, cos_theta) = theta.sin_cos();
    // Values.
    // V = -163827*cos(theta)/10000
    let energy = -S::ratio(163827, 10000) * cos_theta;
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 0 operations.
#[must_use]
pub fn outputs<S: Scalar>(_p: &Parameters<S>, _t: S, q: &[S; 2], u: &[S; 2]) -> [S; 4] {
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Values.
    // theta = theta
    let theta_value = theta;
    // phi = phi
    let phi_value = phi;
    // omega = omega
    let omega_value = omega;
    // alpha = alpha
    let alpha_value = alpha;
    [theta_value, phi_value, omega_value, alpha_value]
}

/// The energy, then its derivatives by the state.
///
/// 19 operations, 2 sines and cosines.
#[must_use]
pub fn energy_gradient<S: Scalar>(_p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 5] {
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    // omega*(229 + 5*cos(phi)^2); used 2 times
    let energy_part = omega * (S::int(229) + S::int(5) * cos_phi * cos_phi);
    // Values.
    // T + V = 3*omega^2*(229 + 5*cos(phi)^2)/1000 - 163827*cos(theta)/10000 + 13*alpha^2/400
    let energy = S::ratio(13, 400) * alpha * alpha - S::ratio(163827, 10000) * cos_theta
        + S::ratio(3, 1000) * omega * energy_part;
    // d(T + V)/d(theta) = 163827*sin(theta)/10000
    let energy_by_theta = S::ratio(163827, 10000) * sin_theta;
    // d(T + V)/d(phi) = -3*omega^2*sin(phi)*cos(phi)/100
    let energy_by_phi = -S::ratio(3, 100) * omega * omega * sin_phi * cos_phi;
    // d(T + V)/d(omega) = 3*omega*(229 + 5*cos(phi)^2)/500
    let energy_by_omega = S::ratio(3, 500) * energy_part;
    // d(T + V)/d(alpha) = 13*alpha/200
    let energy_by_alpha = S::ratio(13, 200) * alpha;
    [energy, energy_by_theta, energy_by_phi, energy_by_omega, energy_by_alpha]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 10 convolutions and 6 linear operations an order.
pub fn taylor<S: Scalar>(
    _p: &Parameters<S>,
    series: &mut [[S; 4]],
    history: &mut [Factors<S, 16>],
) {
    let [theta_0, phi_0, omega_0, alpha_0] = series[0];
    // Order 0.
    let (sin_phi_0, cos_phi_0) = phi_0.sin_cos();
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    // omega_sin_phi = omega*sin_phi
    let omega_sin_phi_0 = omega_0 * sin_phi_0;
    // omega_dot_part = cos_phi*omega_sin_phi
    let omega_dot_part_0 = cos_phi_0 * omega_sin_phi_0;
    // omega_dot_part_2 = alpha*omega_dot_part
    let omega_dot_part_2_0 = alpha_0 * omega_dot_part_0;
    // cos_phi_p2 = cos_phi*cos_phi
    let cos_phi_p2_0 = cos_phi_0 * cos_phi_0;
    // omega_dot_part_3 = 229 + 5*cos_phi_p2
    let omega_dot_part_3_0 = cos_phi_p2_0.mul_add(S::int(5), S::int(229));
    let over_omega_dot_part_3 = S::int(1) / omega_dot_part_3_0;
    // omega_dot_part_4 = 54609*sin_theta - 200*omega_dot_part_2
    let omega_dot_part_4_0 = omega_dot_part_2_0
        .mul_add(-S::int(200), S::int(54609) * sin_theta_0);
    // omega_dot_part_5 = omega_dot_part_4/omega_dot_part_3
    let omega_dot_part_5_0 = omega_dot_part_4_0 * over_omega_dot_part_3;
    // alpha_dot_part = omega*omega_dot_part
    let alpha_dot_part_0 = omega_0 * omega_dot_part_0;
    // Order 1: the rates, and what follows from them.
    let theta_1 = omega_0;
    let phi_1 = alpha_0;
    let omega_1 = -S::ratio(1, 20) * omega_dot_part_5_0;
    let alpha_1 = -S::ratio(6, 13) * alpha_dot_part_0;
    if series.len() > 1 {
        series[1] = [theta_1, phi_1, omega_1, alpha_1];
    }
    let sin_phi_1 = phi_1 * cos_phi_0;
    let cos_phi_1 = -phi_1 * sin_phi_0;
    let sin_theta_1 = theta_1 * cos_theta_0;
    let cos_theta_1 = -theta_1 * sin_theta_0;
    let omega_sin_phi_1 = sin_phi_1.mul_add(omega_0, omega_1 * sin_phi_0);
    let omega_dot_part_1 = omega_sin_phi_1
        .mul_add(cos_phi_0, cos_phi_1 * omega_sin_phi_0);
    let omega_dot_part_2_1 = omega_dot_part_1
        .mul_add(alpha_0, alpha_1 * omega_dot_part_0);
    let cos_phi_p2_1 = cos_phi_1 * (cos_phi_0 + cos_phi_0);
    let omega_dot_part_3_1 = S::int(5) * cos_phi_p2_1;
    let omega_dot_part_4_1 = omega_dot_part_2_1
        .mul_add(-S::int(200), S::int(54609) * sin_theta_1);
    let omega_dot_part_5_1 = omega_dot_part_3_1
        .mul_add(
            -(omega_dot_part_5_0 * over_omega_dot_part_3),
            omega_dot_part_4_1 * over_omega_dot_part_3,
        );
    let alpha_dot_part_1 = omega_dot_part_1.mul_add(omega_0, omega_1 * omega_dot_part_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                phi_1,
                phi_1,
                theta_1,
                theta_1,
                omega_1,
                cos_phi_1,
                alpha_1,
                cos_phi_1,
                omega_dot_part_3_1,
                omega_1,
            ]),
            padded([
                cos_phi_1,
                sin_phi_1,
                cos_theta_1,
                sin_theta_1,
                sin_phi_1,
                omega_sin_phi_1,
                omega_dot_part_1,
                cos_phi_1,
                omega_dot_part_5_1,
                omega_dot_part_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta_last = theta_1;
    let mut phi_last = phi_1;
    let mut omega_last = omega_1;
    let mut alpha_last = alpha_1;
    let mut sin_phi_last = sin_phi_1;
    let mut cos_phi_last = cos_phi_1;
    let mut sin_theta_last = sin_theta_1;
    let mut cos_theta_last = cos_theta_1;
    let mut omega_sin_phi_last = omega_sin_phi_1;
    let mut omega_dot_part_last = omega_dot_part_1;
    let mut omega_dot_part_3_last = omega_dot_part_3_1;
    let mut omega_dot_part_5_last = omega_dot_part_5_1;
    let mut next = [S::int(0); 16];
    // Rates at order k - 1.
    let mut theta_rate = omega_1;
    let mut phi_rate = alpha_1;
    let mut omega_rate = -S::ratio(1, 20) * omega_dot_part_5_1;
    let mut alpha_rate = -S::ratio(6, 13) * alpha_dot_part_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let theta = theta_rate * over_k;
        let phi = phi_rate * over_k;
        let omega = omega_rate * over_k;
        let alpha = alpha_rate * over_k;
        series[order] = [theta, phi, omega, alpha];
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
                theta_1
                    .mul_add(
                        cos_theta_last,
                        (count_last * theta_last).mul_add(cos_theta_1, next[2]),
                    ),
                theta_1
                    .mul_add(
                        sin_theta_last,
                        (count_last * theta_last).mul_add(sin_theta_1, next[3]),
                    ),
                omega_1.mul_add(sin_phi_last, omega_last.mul_add(sin_phi_1, next[4])),
                cos_phi_1
                    .mul_add(
                        omega_sin_phi_last,
                        cos_phi_last.mul_add(omega_sin_phi_1, next[5]),
                    ),
                alpha_1
                    .mul_add(
                        omega_dot_part_last,
                        alpha_last.mul_add(omega_dot_part_1, next[6]),
                    ),
                (cos_phi_1 + cos_phi_1).mul_add(cos_phi_last, next[7]),
                omega_dot_part_3_1
                    .mul_add(
                        omega_dot_part_5_last,
                        omega_dot_part_3_last.mul_add(omega_dot_part_5_1, next[8]),
                    ),
                omega_1
                    .mul_add(
                        omega_dot_part_last,
                        omega_last.mul_add(omega_dot_part_1, next[9]),
                    ),
            ])
        };
        // sin_phi = sin(phi)
        let sin_phi = phi.mul_add(cos_phi_0, sums[0] * over_k);
        // cos_phi = cos(phi)
        let cos_phi = -phi.mul_add(sin_phi_0, sums[1] * over_k);
        // sin_theta = sin(theta)
        let sin_theta = theta.mul_add(cos_theta_0, sums[2] * over_k);
        // cos_theta = cos(theta)
        let cos_theta = -theta.mul_add(sin_theta_0, sums[3] * over_k);
        // omega_sin_phi = omega*sin_phi
        let omega_sin_phi = sin_phi.mul_add(omega_0, omega.mul_add(sin_phi_0, sums[4]));
        // omega_dot_part = cos_phi*omega_sin_phi
        let omega_dot_part = omega_sin_phi
            .mul_add(cos_phi_0, cos_phi.mul_add(omega_sin_phi_0, sums[5]));
        // omega_dot_part_2 = alpha*omega_dot_part
        let omega_dot_part_2 = omega_dot_part
            .mul_add(alpha_0, alpha.mul_add(omega_dot_part_0, sums[6]));
        // cos_phi_p2 = cos_phi*cos_phi
        let cos_phi_p2 = cos_phi.mul_add(cos_phi_0 + cos_phi_0, sums[7]);
        // omega_dot_part_3 = 229 + 5*cos_phi_p2
        let omega_dot_part_3 = S::int(5) * cos_phi_p2;
        // omega_dot_part_4 = 54609*sin_theta - 200*omega_dot_part_2
        let omega_dot_part_4 = omega_dot_part_2
            .mul_add(-S::int(200), S::int(54609) * sin_theta);
        // omega_dot_part_5 = omega_dot_part_4/omega_dot_part_3
        let omega_dot_part_5 = omega_dot_part_4
            .mul_add(
                over_omega_dot_part_3,
                -(omega_dot_part_3.mul_add(omega_dot_part_5_0, sums[8])
                    * over_omega_dot_part_3),
            );
        // alpha_dot_part = omega*omega_dot_part
        let alpha_dot_part = omega_dot_part
            .mul_add(omega_0, omega.mul_add(omega_dot_part_0, sums[9]));
        theta_rate = omega;
        phi_rate = alpha;
        omega_rate = -S::ratio(1, 20) * omega_dot_part_5;
        alpha_rate = -S::ratio(6, 13) * alpha_dot_part;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * phi,
                count * phi,
                count * theta,
                count * theta,
                omega,
                cos_phi,
                alpha,
                cos_phi,
                omega_dot_part_3,
                omega,
            ]),
            padded([
                cos_phi,
                sin_phi,
                cos_theta,
                sin_theta,
                sin_phi,
                omega_sin_phi,
                omega_dot_part,
                cos_phi,
                omega_dot_part_5,
                omega_dot_part,
            ]),
        ];
        count_last = count;
        theta_last = theta;
        phi_last = phi;
        omega_last = omega;
        alpha_last = alpha;
        sin_phi_last = sin_phi;
        cos_phi_last = cos_phi;
        sin_theta_last = sin_theta;
        cos_theta_last = cos_theta;
        omega_sin_phi_last = omega_sin_phi;
        omega_dot_part_last = omega_dot_part;
        omega_dot_part_3_last = omega_dot_part_3;
        omega_dot_part_5_last = omega_dot_part_5;
    }
}

/// Reduced equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Reduced;

impl<S: Scalar> System<S> for Reduced {
    fn parameters(&self) -> usize {
        0
    }
    fn coordinates(&self) -> usize {
        2
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
        4
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
    name: "swing",
    key: "a1d9eec417bfde62",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: None,
    },
};
