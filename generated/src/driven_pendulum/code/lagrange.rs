//! Pendulum on a driven pivot: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/driven_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows q, t, constraint t.
///
/// 10 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _q_dot: &[S; 2],
) -> [[S; 3]; 3] {
    let Parameters { m, l, a, w, .. } = *p;
    let [q_2, t] = *q;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    // Shared terms.
    let m_l = m * l;
    let (_, cos_w_t) = (w * t).sin_cos();
    let a_w_cos_w_t = a * w * cos_w_t;
    let sin_q_m_l_a_w_cos_w_t = m_l * a_w_cos_w_t * sin_q;
    // Entries that are not zero.
    // M11 = m*l^2
    let m11 = l * m_l;
    // M12 = m*l*a*w*sin(q)*cos(w*t)
    let m12 = sin_q_m_l_a_w_cos_w_t;
    // M21 = m*l*a*w*sin(q)*cos(w*t)
    let m21 = sin_q_m_l_a_w_cos_w_t;
    // M22 = m*a^2*w^2*cos(w*t)^2
    let m22 = m * a_w_cos_w_t * a_w_cos_w_t;
    // M23 = -1
    let m23 = -S::int(1);
    // M32 = 1
    let m32 = S::int(1);
    let zero = S::int(0);
    [[m11, m12, zero], [m21, m22, m23], [zero, m32, zero]]
}

/// Right-hand side of the linear system; unknowns (q'', t'', lambda_t).
///
/// 17 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> [S; 3] {
    let Parameters { m, l, g, a, w } = *p;
    let [q_2, t] = *q;
    let [q_dot_2, t_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    // Shared terms.
    let a_w = a * w;
    let w_t = w * t;
    let (sin_w_t, cos_w_t) = w_t.sin_cos();
    // w*t'^2*a_w*sin(w*t) - g
    let f1_of_t_dot = w * t_dot * t_dot * a_w * sin_w_t - g;
    // Values.
    // f1 = m*l*sin(q)*(a*w^2*t'^2*sin(w*t) - g)
    let f1 = m * l * f1_of_t_dot * sin_q;
    // f2 = m*a*w*cos(w*t)*(a*w^2*t'^2*sin(w*t) - g - l*q'^2*cos(q))
    let f2 = m * a_w * cos_w_t * (f1_of_t_dot - l * q_dot_2 * q_dot_2 * cos_q);
    let zero = S::int(0);
    [f1, f2, zero]
}

/// The accelerations (q'', t''), solved for when this code was generated.
///
/// 8 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { l, g, a, w, .. } = *p;
    let [q_2, t] = *q;
    let [_, t_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let w_t_dot = w * t_dot;
    let (sin_w_t, _) = (w * t).sin_cos();
    // u' = sin(q)*(a*w^2*t'^2*sin(w*t) - g)/l
    let u_dot = sin_q * (a * w_t_dot * w_t_dot * sin_w_t - g) / l;
    // q'' = u'
    let q_ddot = u_dot;
    let zero = S::int(0);
    [q_ddot, zero]
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
    let [q_dot_2, t_dot] = *q_dot;
    // Values.
    // q'
    let q_dot_value = q_dot_2;
    // t'
    let t_dot_value = t_dot;
    [q_dot_value, t_dot_value]
}

/// Kinetic energy T.
///
/// 13 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> S {
    let Parameters { m, l, a, w, .. } = *p;
    let [q_2, t] = *q;
    let [q_dot_2, t_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    // Shared terms.
    let l_q_dot_2 = l * q_dot_2;
    let (_, cos_w_t) = (w * t).sin_cos();
    let a_w_t_dot_cos_w_t = a * w * t_dot * cos_w_t;
    // Values.
    // T = m*l^2*q'^2/2 + m*a^2*w^2*t'^2*cos(w*t)^2/2 + m*l*a*w*q'*t'*sin(q)*cos(w*t)
    let energy = S::ratio(1, 2) * m
        * (a_w_t_dot_cos_w_t * (l_q_dot_2 * sin_q).mul_add(S::int(2), a_w_t_dot_cos_w_t)
            + l_q_dot_2 * l_q_dot_2);
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
) -> [S; 1] {
    let [q_dot_2, _] = *q_dot;
    // Values.
    // u = q'
    let u_value = q_dot_2;
    [u_value]
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
) -> [S; 1] {
    let [q_ddot, _] = *v_dot;
    // Values.
    // u' = q''
    let u_dot_value = q_ddot;
    [u_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 0 operations.
#[must_use]
pub fn motion_variables<S: Scalar>(
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

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 8 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let Parameters { l, g, a, w, .. } = *p;
    let [q_2, t] = *q;
    let [q_dot_2, t_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let w_t_dot = w * t_dot;
    let (sin_w_t, _) = (w * t).sin_cos();
    // u' = sin(q)*(a*w^2*t'^2*sin(w*t) - g)/l
    let u_dot = sin_q * (a * w_t_dot * w_t_dot * sin_w_t - g) / l;
    // q'' = u'
    let q_ddot = u_dot;
    // Values.
    // q'
    let q_dot_value = q_dot_2;
    // t'
    let t_dot_value = t_dot;
    let zero = S::int(0);
    ([q_dot_value, t_dot_value], [q_ddot, zero])
}

/// Jacobian of the derivative by the state; columns q, t, q', t'.
///
/// 16 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [[S; 4]; 4] {
    let Parameters { l, g, a, w, .. } = *p;
    let [q_2, t] = *q;
    let [_, t_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let w_t_dot = w * t_dot;
    let a_w_t_dot = a * w_t_dot;
    let w_t = w * t;
    let (sin_w_t, cos_w_t) = w_t.sin_cos();
    let sin_w_t_a_w_t_dot = a_w_t_dot * sin_w_t;
    let l_inv = S::int(1) / l;
    // u_dot_by_q = cos(q)*(a*w^2*t'^2*sin(w*t) - g)/l
    let u_dot_by_q = l_inv * cos_q * w_t_dot.mul_add(sin_w_t_a_w_t_dot, -g);
    let w_sin_q_l_inv = w * l_inv * sin_q;
    // u_dot_by_t = a*w^3*t'^2*sin(q)*cos(w*t)/l
    let u_dot_by_t = w_t_dot * a_w_t_dot * w_sin_q_l_inv * cos_w_t;
    // u_dot_by_t_dot = 2*a*w^2*t'*sin(q)*sin(w*t)/l
    let u_dot_by_t_dot = S::int(2) * sin_w_t_a_w_t_dot * w_sin_q_l_inv;
    // Entries that are not zero.
    // d(q')/d(q') = 1
    let q_dot_by_q_dot_value = S::int(1);
    // d(t')/d(t') = 1
    let t_dot_by_t_dot_value = S::int(1);
    let zero = S::int(0);
    [
        [zero, zero, q_dot_by_q_dot_value, zero],
        [zero, zero, zero, t_dot_by_t_dot_value],
        [u_dot_by_q, u_dot_by_t, zero, u_dot_by_t_dot],
        [zero, zero, zero, zero],
    ]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 5 convolutions and 4 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 4]],
    history: &mut [Factors<S, 8>],
) {
    let Parameters { l, g, a, w, .. } = *p;
    let [q_2_0, t_0, q_dot_2_0, t_dot] = series[0];
    // Constant in time.
    // minus_a_w_2_t_2 = -a*w^2*t'^2
    let minus_a_w_2_t_2 = -a * w * w * t_dot * t_dot;
    // minus_1_by_l = -1/l
    let minus_1_by_l = -S::int(1) / l;
    // Order 0.
    let w_t_0 = w * t_0;
    let (sin_w_t_0, cos_w_t_0) = w_t_0.sin_cos();
    let (sin_q_0, cos_q_0) = q_2_0.sin_cos();
    let u_dot_of_t_dot_0 = sin_w_t_0.mul_add(minus_a_w_2_t_2, g);
    let u_dot_of_t_dot_2_0 = sin_q_0 * u_dot_of_t_dot_0;
    // Order 1: the rates, and what follows from them.
    let q_2_1 = q_dot_2_0;
    let t_1 = t_dot;
    let q_dot_2_1 = minus_1_by_l * u_dot_of_t_dot_2_0;
    if series.len() > 1 {
        series[1] = [q_2_1, t_1, q_dot_2_1, S::int(0)];
    }
    let w_t_1 = w * t_1;
    let sin_w_t_1 = w_t_1 * cos_w_t_0;
    let cos_w_t_1 = -w_t_1 * sin_w_t_0;
    let sin_q_1 = q_2_1 * cos_q_0;
    let cos_q_1 = -q_2_1 * sin_q_0;
    let u_dot_of_t_dot_1 = minus_a_w_2_t_2 * sin_w_t_1;
    let u_dot_of_t_dot_2_1 = u_dot_of_t_dot_1
        .mul_add(sin_q_0, sin_q_1 * u_dot_of_t_dot_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([w_t_1, w_t_1, q_2_1, q_2_1, sin_q_1]),
            padded([cos_w_t_1, sin_w_t_1, cos_q_1, sin_q_1, u_dot_of_t_dot_1]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q_2_last = q_2_1;
    let mut w_t_last = w_t_1;
    let mut sin_w_t_last = sin_w_t_1;
    let mut cos_w_t_last = cos_w_t_1;
    let mut sin_q_last = sin_q_1;
    let mut cos_q_last = cos_q_1;
    let mut u_dot_of_t_dot_last = u_dot_of_t_dot_1;
    let mut next = [S::int(0); 8];
    // Rates at order k - 1.
    let mut q_2_rate = q_dot_2_1;
    let mut t_rate = S::int(0);
    let mut q_dot_2_rate = minus_1_by_l * u_dot_of_t_dot_2_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q_2 = q_2_rate * over_k;
        let t = t_rate * over_k;
        let q_dot_2 = q_dot_2_rate * over_k;
        series[order] = [q_2, t, q_dot_2, S::int(0)];
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
                        u_dot_of_t_dot_last,
                        sin_q_last.mul_add(u_dot_of_t_dot_1, next[4]),
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
        // u_dot_of_t_dot = g + minus_a_w_2_t_2*sin_w_t
        let u_dot_of_t_dot = minus_a_w_2_t_2 * sin_w_t;
        // u_dot_of_t_dot_2 = sin_q*u_dot_of_t_dot
        let u_dot_of_t_dot_2 = u_dot_of_t_dot
            .mul_add(sin_q_0, sin_q.mul_add(u_dot_of_t_dot_0, sums[4]));
        q_2_rate = q_dot_2;
        t_rate = S::int(0);
        q_dot_2_rate = minus_1_by_l * u_dot_of_t_dot_2;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([count * w_t, count * w_t, count * q_2, count * q_2, sin_q]),
            padded([cos_w_t, sin_w_t, cos_q, sin_q, u_dot_of_t_dot]),
        ];
        count_last = count;
        q_2_last = q_2;
        w_t_last = w_t;
        sin_w_t_last = sin_w_t;
        cos_w_t_last = cos_w_t;
        sin_q_last = sin_q;
        cos_q_last = cos_q;
        u_dot_of_t_dot_last = u_dot_of_t_dot;
    }
}

/// Lagrange's equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Lagrange;

impl<S: Scalar> System<S> for Lagrange {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 5,
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
