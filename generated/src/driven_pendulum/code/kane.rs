//! Pendulum on a driven pivot: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/driven_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u.
///
/// 2 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 2],
    _u: &[S; 1],
) -> [[S; 1]; 1] {
    let Parameters { m, l, .. } = *p;
    // Entries that are not zero; upper triangle.
    // M11 = m*l^2
    let m11 = m * l * l;
    [[m11]]
}

/// Right-hand side of the linear system; unknowns (u').
///
/// 8 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 1]) -> [S; 1] {
    let Parameters { m, l, g, a, w } = *p;
    let [q_2, t] = *q;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    let (sin_w_t, _) = (w * t).sin_cos();
    // Values.
    // f1 = m*l*sin(q)*(a*w^2*sin(w*t) - g)
    let f1 = m * l * sin_q * (a * w * w * sin_w_t - g);
    [f1]
}

/// The accelerations (u'), solved for when this code was generated.
///
/// 7 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 1]) -> [S; 1] {
    let Parameters { l, g, a, w, .. } = *p;
    let [q_2, t] = *q;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    let (sin_w_t, _) = (w * t).sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u' = sin(q)*(a*w^2*sin(w*t) - g)/l
    let u_dot = sin_q * (a * w * w * sin_w_t - g) / l;
    [u_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    u: &[S; 1],
) -> [S; 2] {
    let [u_2] = *u;
    // Values.
    // q' = u
    let q_dot_value = u_2;
    // t' = 1
    let t_dot_value = S::int(1);
    [q_dot_value, t_dot_value]
}

/// Kinetic energy T.
///
/// 12 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> S {
    let Parameters { m, l, a, w, .. } = *p;
    let [q_2, t] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    let (_, cos_w_t) = (w * t).sin_cos();
    // Shared terms.
    let a_w_cos_w_t = a * w * cos_w_t;
    let l_u_2 = l * u_2;
    // Values.
    // T = m*(a^2*w^2*cos(w*t)^2 + l*u*(2*a*w*sin(q)*cos(w*t) + l*u))/2
    let energy = S::ratio(1, 2) * m
        * (l_u_2 * (a_w_cos_w_t * sin_q).mul_add(S::int(2), l_u_2) + a_w_cos_w_t * a_w_cos_w_t);
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 6 operations, 2 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2]) -> S {
    let Parameters { m, l, g, a, w } = *p;
    let [q_2, t] = *q;
    // Sines and cosines.
    let (_, cos_q) = q_2.sin_cos();
    let (sin_w_t, _) = (w * t).sin_cos();
    // Values.
    // V = m*g*(a*sin(w*t) - l*cos(q))
    let energy = m * g * (-l).mul_add(cos_q, a * sin_w_t);
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 7 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 1],
) -> ([S; 2], [S; 1]) {
    let Parameters { l, g, a, w, .. } = *p;
    let [q_2, t] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    let (sin_w_t, _) = (w * t).sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u' = sin(q)*(a*w^2*sin(w*t) - g)/l
    let u_dot = sin_q * (a * w * w * sin_w_t - g) / l;
    // Values.
    // q' = u
    let q_dot_value = u_2;
    // t' = 1
    let t_dot_value = S::int(1);
    ([q_dot_value, t_dot_value], [u_dot])
}

/// Jacobian of the derivative by the state; columns q, t, u.
///
/// 12 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 1]) -> [[S; 3]; 3] {
    let Parameters { l, g, a, w, .. } = *p;
    let [q_2, t] = *q;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let a_w_sq = a * w * w;
    let l_inv = S::int(1) / l;
    let w_t = w * t;
    let (sin_w_t, cos_w_t) = w_t.sin_cos();
    // u_dot_by_q = cos(q)*(a*w^2*sin(w*t) - g)/l
    let u_dot_by_q = l_inv * cos_q * a_w_sq.mul_add(sin_w_t, -g);
    // u_dot_by_t = a*w^3*sin(q)*cos(w*t)/l
    let u_dot_by_t = w * a_w_sq * l_inv * sin_q * cos_w_t;
    // Entries that are not zero.
    // d(q')/d(u) = 1
    let q_dot_by_u_value = S::int(1);
    let zero = S::int(0);
    [[zero, zero, q_dot_by_u_value], [zero, zero, zero], [u_dot_by_q, u_dot_by_t, zero]]
}

/// Inverse dynamics: the generalized forces along (u) that must act beside the loads of the model for the accelerations to be (u').
///
/// 10 operations, 2 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _u: &[S; 1],
    v_dot: &[S; 1],
) -> [S; 1] {
    let Parameters { m, l, g, a, w } = *p;
    let [q_2, t] = *q;
    let [u_dot] = *v_dot;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    let (sin_w_t, _) = (w * t).sin_cos();
    // Values.
    // tau1 = m*l*sin(q)*(g - a*w^2*sin(w*t)) + m*l^2*u'
    let tau1 = m * l * (sin_q * (g - a * w * w * sin_w_t) + l * u_dot);
    [tau1]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 5 convolutions and 4 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 3]],
    history: &mut [Factors<S, 8>],
) {
    let Parameters { l, g, a, w, .. } = *p;
    let [q_2_0, t_0, u_2_0] = series[0];
    // Constant in time.
    // minus_a_w_2 = -a*w^2
    let minus_a_w_2 = -a * w * w;
    // minus_1_by_l = -1/l
    let minus_1_by_l = -S::int(1) / l;
    // Order 0.
    let w_t_0 = w * t_0;
    let (sin_w_t_0, cos_w_t_0) = w_t_0.sin_cos();
    let (sin_q_0, cos_q_0) = q_2_0.sin_cos();
    let g_minus_a_w_sq_sin_w_t_0 = sin_w_t_0.mul_add(minus_a_w_2, g);
    let u_dot_of_g_a_w_q_2_t_0 = sin_q_0 * g_minus_a_w_sq_sin_w_t_0;
    // Order 1: the rates, and what follows from them.
    let q_2_1 = u_2_0;
    let t_1 = S::int(1);
    let u_2_1 = minus_1_by_l * u_dot_of_g_a_w_q_2_t_0;
    if series.len() > 1 {
        series[1] = [q_2_1, t_1, u_2_1];
    }
    let w_t_1 = w * t_1;
    let sin_w_t_1 = w_t_1 * cos_w_t_0;
    let cos_w_t_1 = -w_t_1 * sin_w_t_0;
    let sin_q_1 = q_2_1 * cos_q_0;
    let cos_q_1 = -q_2_1 * sin_q_0;
    let g_minus_a_w_sq_sin_w_t_1 = minus_a_w_2 * sin_w_t_1;
    let u_dot_of_g_a_w_q_2_t_1 = g_minus_a_w_sq_sin_w_t_1
        .mul_add(sin_q_0, sin_q_1 * g_minus_a_w_sq_sin_w_t_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([w_t_1, w_t_1, q_2_1, q_2_1, sin_q_1]),
            padded([cos_w_t_1, sin_w_t_1, cos_q_1, sin_q_1, g_minus_a_w_sq_sin_w_t_1]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q_2_last = q_2_1;
    let mut w_t_last = w_t_1;
    let mut sin_w_t_last = sin_w_t_1;
    let mut cos_w_t_last = cos_w_t_1;
    let mut sin_q_last = sin_q_1;
    let mut cos_q_last = cos_q_1;
    let mut g_minus_a_w_sq_sin_w_t_last = g_minus_a_w_sq_sin_w_t_1;
    let mut next = [S::int(0); 8];
    // Rates at order k - 1.
    let mut q_2_rate = u_2_1;
    let mut t_rate = S::int(0);
    let mut u_2_rate = minus_1_by_l * u_dot_of_g_a_w_q_2_t_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q_2 = q_2_rate * over_k;
        let t = t_rate * over_k;
        let u_2 = u_2_rate * over_k;
        series[order] = [q_2, t, u_2];
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
                w_t_1
                    .mul_add(
                        cos_w_t_last,
                        (count_last * w_t_last).mul_add(cos_w_t_1, next[0]),
                    ),
                w_t_1
                    .mul_add(
                        sin_w_t_last,
                        (count_last * w_t_last).mul_add(sin_w_t_1, next[1]),
                    ),
                q_2_1
                    .mul_add(
                        cos_q_last,
                        (count_last * q_2_last).mul_add(cos_q_1, next[2]),
                    ),
                q_2_1
                    .mul_add(
                        sin_q_last,
                        (count_last * q_2_last).mul_add(sin_q_1, next[3]),
                    ),
                sin_q_1
                    .mul_add(
                        g_minus_a_w_sq_sin_w_t_last,
                        sin_q_last.mul_add(g_minus_a_w_sq_sin_w_t_1, next[4]),
                    ),
            ])
        };
        // w_t = w*t
        let w_t = w * t;
        // sin_w_t = sin(w_t)
        let sin_w_t = w_t.mul_add(cos_w_t_0, sums[0] * over_k);
        // cos_w_t = cos(w_t)
        let cos_w_t = -w_t.mul_add(sin_w_t_0, sums[1] * over_k);
        // sin_q = sin(q_2)
        let sin_q = q_2.mul_add(cos_q_0, sums[2] * over_k);
        // cos_q = cos(q_2)
        let cos_q = -q_2.mul_add(sin_q_0, sums[3] * over_k);
        // g_minus_a_w_sq_sin_w_t = g + minus_a_w_2*sin_w_t
        let g_minus_a_w_sq_sin_w_t = minus_a_w_2 * sin_w_t;
        // u_dot_of_g_a_w_q_2_t = sin_q*g_minus_a_w_sq_sin_w_t
        let u_dot_of_g_a_w_q_2_t = g_minus_a_w_sq_sin_w_t
            .mul_add(sin_q_0, sin_q.mul_add(g_minus_a_w_sq_sin_w_t_0, sums[4]));
        q_2_rate = u_2;
        t_rate = S::int(0);
        u_2_rate = minus_1_by_l * u_dot_of_g_a_w_q_2_t;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([count * w_t, count * w_t, count * q_2, count * q_2, sin_q]),
            padded([cos_w_t, sin_w_t, cos_q, sin_q, g_minus_a_w_sq_sin_w_t]),
        ];
        count_last = count;
        q_2_last = q_2;
        w_t_last = w_t;
        sin_w_t_last = sin_w_t;
        cos_w_t_last = cos_w_t;
        sin_q_last = sin_q;
        cos_q_last = cos_q;
        g_minus_a_w_sq_sin_w_t_last = g_minus_a_w_sq_sin_w_t;
    }
}

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 5,
            coordinates: 2,
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
