//! Pendulum: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows theta.
///
/// 2 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 1],
    _q_dot: &[S; 1],
) -> [[S; 1]; 1] {
    let Parameters { m, l, .. } = *p;
    // Entries that are not zero; upper triangle.
    // M11 = m*l^2
    let m11 = m * l * l;
    [[m11]]
}

/// Right-hand side of the linear system; unknowns (theta'').
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 1], _q_dot: &[S; 1]) -> [S; 1] {
    let Parameters { m, l, g } = *p;
    let [theta] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // f1 = -m*l*g*sin(theta)
    let f1 = -m * l * g * sin_theta;
    [f1]
}

/// The accelerations (theta''), solved for when this code was generated.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 1],
    _q_dot: &[S; 1],
) -> [S; 1] {
    let Parameters { l, g, .. } = *p;
    let [theta] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // theta'' = -g*sin(theta)/l
    let theta_ddot = -g * sin_theta / l;
    [theta_ddot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 1],
    q_dot: &[S; 1],
) -> [S; 1] {
    let [theta_dot] = *q_dot;
    // Values.
    // theta'
    let theta_dot_value = theta_dot;
    [theta_dot_value]
}

/// Kinetic energy T.
///
/// 4 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 1], q_dot: &[S; 1]) -> S {
    let Parameters { m, l, .. } = *p;
    let [theta_dot] = *q_dot;
    // Shared terms.
    let l_theta_dot = l * theta_dot;
    // Values.
    // T = m*l^2*theta'^2/2
    let energy = S::ratio(1, 2) * m * l_theta_dot * l_theta_dot;
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 0 operations.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 1],
    q_dot: &[S; 1],
) -> [S; 1] {
    let [theta_dot] = *q_dot;
    // Values.
    // omega = theta'
    let omega_value = theta_dot;
    [omega_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 0 operations.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 1],
    _q_dot: &[S; 1],
    v_dot: &[S; 1],
) -> [S; 1] {
    let [theta_ddot] = *v_dot;
    // Values.
    // omega' = theta''
    let omega_dot_value = theta_ddot;
    [omega_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 0 operations.
#[must_use]
pub fn motion_variables<S: Scalar>(
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

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 1],
    q_dot: &[S; 1],
) -> ([S; 1], [S; 1]) {
    let Parameters { l, g, .. } = *p;
    let [theta] = *q;
    let [theta_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // theta'' = -g*sin(theta)/l
    let theta_ddot = -g * sin_theta / l;
    // Values.
    // theta'
    let theta_dot_value = theta_dot;
    ([theta_dot_value], [theta_ddot])
}

/// Inverse dynamics: the generalized forces along (theta') that must act beside the loads of the model for the accelerations to be (theta'').
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 1],
    _q_dot: &[S; 1],
    v_dot: &[S; 1],
) -> [S; 1] {
    let Parameters { m, l, g } = *p;
    let [theta] = *q;
    let [theta_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // tau1 = m*l*g*sin(theta) + m*l^2*theta''
    let tau1 = m * l * l.mul_add(theta_ddot, g * sin_theta);
    [tau1]
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
    let Parameters { l, g, .. } = *p;
    let [theta_0, theta_dot_0] = series[0];
    // Constant in time.
    // minus_g_by_l = -g/l
    let minus_g_by_l = -g / l;
    // Order 0.
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    // Order 1: the rates, and what follows from them.
    let theta_1 = theta_dot_0;
    let theta_dot_1 = minus_g_by_l * sin_theta_0;
    if series.len() > 1 {
        series[1] = [theta_1, theta_dot_1];
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
    let mut theta_rate = theta_dot_1;
    let mut theta_dot_rate = minus_g_by_l * sin_theta_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let theta = theta_rate * over_k;
        let theta_dot = theta_dot_rate * over_k;
        series[order] = [theta, theta_dot];
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
        theta_rate = theta_dot;
        theta_dot_rate = minus_g_by_l * sin_theta;
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
    q_dot: &[S; 1],
    direction: &[S; 2],
) -> [S; 2] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: q_dot[i],
        slope: direction[1 + i],
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
