//! Pendulum: Over the top.
//!
//! Generated from `models/pendulum/scenes/over.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{
    AtPoints, CompiledScene, CompiledSystem, Derivative, Dual, InLanes, Lengths, Scalar,
    System, by_columns,
};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
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
        Self { g: p[0] }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 1] {
        let Self { g, .. } = self;
        [g]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 1] = ["g"];

/// Names of the outputs.
pub const OUTPUTS: [&str; 2] = ["theta", "omega"];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 0 operations.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    _q: &[S; 1],
    _u: &[S; 1],
) -> [S; 1] {
    let super::super::super::Parameters { g, .. } = *p;
    // Values.
    // g
    let g_value = g;
    [g_value]
}

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// 0 operations.
#[must_use]
pub fn start<S: Scalar>(
    _p: &super::super::super::Parameters<S>,
    q: &[S; 1],
    u: &[S; 1],
) -> ([S; 1], [S; 1]) {
    let [theta] = *q;
    let [omega] = *u;
    // Values.
    // theta
    let theta_value = theta;
    // omega
    let omega_value = omega;
    ([theta_value], [omega_value])
}

/// The accelerations (omega'), solved for when this code was generated.
///
/// 2 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 1], _u: &[S; 1]) -> [S; 1] {
    let Parameters { g } = *p;
    let [theta] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // omega' = -g*sin(theta)
    let omega_dot = -g * sin_theta;
    [omega_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
#[inline(always)]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 1],
    u: &[S; 1],
) -> [S; 1] {
    let [omega] = *u;
    // Values.
    // theta' = omega
    let theta_dot_value = omega;
    [theta_dot_value]
}

/// Kinetic energy T.
///
/// 2 operations.
#[must_use]
#[inline(always)]
pub fn kinetic_energy<S: Scalar>(_p: &Parameters<S>, _q: &[S; 1], u: &[S; 1]) -> S {
    let [omega] = *u;
    // Values.
    // T = omega^2/2
    let energy = S::ratio(1, 2) * omega * omega;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 2 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 1]) -> S {
    let Parameters { g } = *p;
    let [theta] = *q;
    // Sines and cosines.
    let (_, cos_theta) = theta.sin_cos();
    // Values.
    // V = g*(1 - cos(theta))
    let energy = g * (S::int(1) - cos_theta);
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 0 operations.
#[must_use]
pub fn outputs<S: Scalar>(_p: &Parameters<S>, _t: S, q: &[S; 1], u: &[S; 1]) -> [S; 2] {
    let [theta] = *q;
    let [omega] = *u;
    // Values.
    // theta
    let theta_value = theta;
    // omega
    let omega_value = omega;
    [theta_value, omega_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 2 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 1],
    u: &[S; 1],
) -> ([S; 1], [S; 1]) {
    let Parameters { g } = *p;
    let [theta] = *q;
    let [omega] = *u;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // omega' = -g*sin(theta)
    let omega_dot = -g * sin_theta;
    // Values.
    // theta' = omega
    let theta_dot_value = omega;
    ([theta_dot_value], [omega_dot])
}

/// The energy, then its derivatives by the state.
///
/// 6 operations, 1 sine and cosine.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 1], u: &[S; 1]) -> [S; 3] {
    let Parameters { g } = *p;
    let [theta] = *q;
    let [omega] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Values.
    // T + V = g*(1 - cos(theta)) + omega^2/2
    let energy = g * (S::int(1) - cos_theta) + S::ratio(1, 2) * omega * omega;
    // d(T + V)/d(theta) = g*sin(theta)
    let energy_by_theta = g * sin_theta;
    // d(T + V)/d(omega) = omega
    let energy_by_omega = omega;
    [energy, energy_by_theta, energy_by_omega]
}

/// The angles z whose sin z/z the slope of the potential needs.
///
/// 3 operations.
#[must_use]
#[inline(always)]
pub fn half_differences<S: Scalar>(_p: &Parameters<S>, q: &[S; 2]) -> [S; 1] {
    let [theta_from, theta_to] = *q;
    // Values.
    // z1 = theta_to/2 - theta_from/2
    let z1 = S::ratio(1, 2) * theta_to - S::ratio(1, 2) * theta_from;
    [z1]
}

/// The slope of the potential energy between two places `q`, without cancellation; `u` holds sin z/z.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn potential_slope<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> S {
    let Parameters { g } = *p;
    let [theta_from, theta_to] = *q;
    let [sinc1] = *u;
    // Sines and cosines.
    let (sin_angle, _) = (S::ratio(1, 2) * theta_from + S::ratio(1, 2) * theta_to)
        .sin_cos();
    // Values.
    // (V(b) - V(a))/(b - a) = g*sinc1*sin(theta_from/2 + theta_to/2)
    let slope = g * sinc1 * sin_angle;
    slope
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 2 convolutions and 0 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 2]],
    history: &mut [Factors<S, 8>],
) {
    let Parameters { g } = *p;
    let [theta_0, omega_0] = series[0];
    // Constant in time.
    // minus_g = -g
    let minus_g = -g;
    // Order 0.
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    // Order 1: the rates, and what follows from them.
    let theta_1 = omega_0;
    let omega_1 = minus_g * sin_theta_0;
    if series.len() > 1 {
        series[1] = [theta_1, omega_1];
    }
    let sin_theta_1 = theta_1 * cos_theta_0;
    let cos_theta_1 = -theta_1 * sin_theta_0;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [padded([theta_1, theta_1]), padded([cos_theta_1, sin_theta_1])];
    }
    let mut count_last = S::int(1);
    let mut theta_last = theta_1;
    let mut sin_theta_last = sin_theta_1;
    let mut cos_theta_last = cos_theta_1;
    let mut next = [S::int(0); 8];
    // Rates at order k - 1.
    let mut theta_rate = omega_1;
    let mut omega_rate = minus_g * sin_theta_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let theta = theta_rate * over_k;
        let omega = omega_rate * over_k;
        series[order] = [theta, omega];
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
            ])
        };
        // sin_theta = sin(theta)
        let sin_theta = theta.mul_add(cos_theta_0, sums[0] * over_k);
        // cos_theta = cos(theta)
        let cos_theta = -theta.mul_add(sin_theta_0, sums[1] * over_k);
        theta_rate = omega;
        omega_rate = minus_g * sin_theta;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([count * theta, count * theta]),
            padded([cos_theta, sin_theta]),
        ];
        count_last = count;
        theta_last = theta;
        sin_theta_last = sin_theta;
        cos_theta_last = cos_theta;
    }
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 1],
    u: &[S; 1],
    direction: &[S; 2],
) -> [S; 2] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[1 + i],
    });
    let (of_q, of_v) = derivative(&p, &q, &v);
    let mut slopes = of_q.into_iter().chain(of_v).map(|rate| rate.slope);
    core::array::from_fn(|_| {
        slopes.next().expect("a slope for each component of the state")
    })
}

/// Reduced equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Reduced;

impl<S: Scalar> System<S> for Reduced {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 1,
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
        S::dispatch(
            #[inline(always)]
            || {
                out
                    .copy_from_slice(
                        &coordinate_rates(&Parameters::from_slice(p), array(q), array(v)),
                    )
            },
        );
    }
    fn output_count(&self) -> usize {
        2
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
    fn has_potential_slope(&self) -> bool {
        true
    }
    fn potential_slope(&self, p: &[S], a: S, b: S) -> S {
        S::dispatch(
            #[inline(always)]
            || {
                let p = Parameters::from_slice(p);
                let mut sincs = half_differences(&p, &[a, b]);
                sincs.iter_mut().for_each(|z| *z = z.sinc());
                potential_slope(&p, &[a, b], &sincs)
            },
        )
    }
    fn coordinate_period(&self) -> Option<f64> {
        Some(core::f64::consts::TAU)
    }
    fn at_points(&self) -> Option<AtPoints<'_>> {
        Some(AtPoints::of(&Derivative(Reduced)))
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
        S::dispatch(
            #[inline(always)]
            || kinetic_energy(&Parameters::from_slice(p), array(q), array(v)),
        )
    }
    fn potential_energy(&self, p: &[S], q: &[S]) -> S {
        potential_energy(&Parameters::from_slice(p), array(q))
    }
}

#[inline(always)]
fn array<S, const N: usize>(slice: &[S]) -> &[S; N] {
    slice.try_into().expect("a slice of the length that `System` requires")
}

/// What a program needs to find these equations and to trust them.
pub const SCENE: CompiledScene = CompiledScene {
    name: "over",
    key: "895b4379691782c2",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: Some(
            InLanes::of_rates(&Derivative(Reduced)).with_series(&Derivative(Reduced)),
        ),
    },
};
