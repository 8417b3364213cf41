//! Knife edge on an incline: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/knife_edge/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u, w.
///
/// 0 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 3],
    _u: &[S; 2],
) -> [[S; 2]; 2] {
    let Parameters { m, J, .. } = *p;
    // Entries that are not zero; upper triangle.
    // M11 = m
    let m11 = m;
    // M22 = J
    let m22 = J;
    let zero = S::int(0);
    [[m11, zero], [zero, m22]]
}

/// Right-hand side of the linear system; unknowns (u', w').
///
/// 3 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], _u: &[S; 2]) -> [S; 2] {
    let Parameters { m, alpha, g, .. } = *p;
    let [_, _, phi] = *q;
    // Sines and cosines.
    let (_, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Values.
    // f1 = m*g*sin(alpha)*cos(phi)
    let f1 = m * g * sin_alpha * cos_phi;
    let zero = S::int(0);
    [f1, zero]
}

/// The accelerations (u', w'), solved for when this code was generated.
///
/// 2 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 3], _u: &[S; 2]) -> [S; 2] {
    let Parameters { alpha, g, .. } = *p;
    let [_, _, phi] = *q;
    // Sines and cosines.
    let (_, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u' = g*sin(alpha)*cos(phi)
    let u_dot = g * sin_alpha * cos_phi;
    let zero = S::int(0);
    [u_dot, zero]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 2 operations, 1 sine and cosine.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
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

/// Kinetic energy T.
///
/// 6 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 3], u: &[S; 2]) -> S {
    let Parameters { m, J, .. } = *p;
    let [u_2, w] = *u;
    // Shared terms.
    // m*u^2 + J*w^2
    let m_u_2_sq_plus_j_w_sq = m * u_2 * u_2 + J * w * w;
    // Values.
    // T = m*u^2/2 + J*w^2/2
    let energy = S::ratio(1, 2) * m_u_2_sq_plus_j_w_sq;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3]) -> S {
    let Parameters { m, alpha, g, .. } = *p;
    let [x, _, _] = *q;
    // Sines and cosines.
    let (sin_alpha, _) = alpha.sin_cos();
    // Values.
    // V = -m*g*x*sin(alpha)
    let energy = -m * g * x * sin_alpha;
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 4 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 2],
) -> ([S; 3], [S; 2]) {
    let Parameters { alpha, g, .. } = *p;
    let [_, _, phi] = *q;
    let [u_2, w] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u' = g*sin(alpha)*cos(phi)
    let u_dot = g * sin_alpha * cos_phi;
    // Values.
    // x' = u*cos(phi)
    let x_dot_value = u_2 * cos_phi;
    // y' = u*sin(phi)
    let y_dot_value = u_2 * sin_phi;
    // phi' = w
    let phi_dot_value = w;
    let zero = S::int(0);
    ([x_dot_value, y_dot_value, phi_dot_value], [u_dot, zero])
}

/// Jacobian of the derivative by the state; columns x, y, phi, u, w.
///
/// 6 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [[S; 5]; 5] {
    let Parameters { alpha, g, .. } = *p;
    let [_, _, phi] = *q;
    let [u_2, _] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u_dot_by_phi = -g*sin(alpha)*sin(phi)
    let u_dot_by_phi = -g * sin_alpha * sin_phi;
    // Entries that are not zero.
    // d(x')/d(phi) = -u*sin(phi)
    let x_dot_by_phi_value = -u_2 * sin_phi;
    // d(x')/d(u) = cos(phi)
    let x_dot_by_u_value = cos_phi;
    // d(y')/d(phi) = u*cos(phi)
    let y_dot_by_phi_value = u_2 * cos_phi;
    // d(y')/d(u) = sin(phi)
    let y_dot_by_u_value = sin_phi;
    // d(phi')/d(w) = 1
    let phi_dot_by_w_value = S::int(1);
    let zero = S::int(0);
    [
        [zero, zero, x_dot_by_phi_value, x_dot_by_u_value, zero],
        [zero, zero, y_dot_by_phi_value, y_dot_by_u_value, zero],
        [zero, zero, zero, zero, phi_dot_by_w_value],
        [zero, zero, u_dot_by_phi, zero, zero],
        [zero, zero, zero, zero, zero],
    ]
}

/// Inverse dynamics: the generalized forces along (u, w) that must act beside the loads of the model for the accelerations to be (u', w').
///
/// 5 operations, 2 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    _u: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { m, J, alpha, g } = *p;
    let [_, _, phi] = *q;
    let [u_dot, w_dot] = *v_dot;
    // Sines and cosines.
    let (_, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Values.
    // tau1 = m*u' - m*g*sin(alpha)*cos(phi)
    let tau1 = m * (-(g * sin_alpha)).mul_add(cos_phi, u_dot);
    // tau2 = J*w'
    let tau2 = J * w_dot;
    [tau1, tau2]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 4 convolutions and 0 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 5]],
    history: &mut [Factors<S, 8>],
) {
    let Parameters { alpha, g, .. } = *p;
    let [_, _, phi_0, u_2_0, w] = series[0];
    // Sines and cosines.
    let (sin_alpha, _) = alpha.sin_cos();
    // Constant in time.
    // g_sin_alpha = g*sin(alpha)
    let g_sin_alpha = g * sin_alpha;
    // Order 0.
    let (sin_phi_0, cos_phi_0) = phi_0.sin_cos();
    let x_dot_2_0 = u_2_0 * cos_phi_0;
    let y_dot_2_0 = u_2_0 * sin_phi_0;
    // Order 1: the rates, and what follows from them.
    let x_1 = x_dot_2_0;
    let y_1 = y_dot_2_0;
    let phi_1 = w;
    let u_2_1 = g_sin_alpha * cos_phi_0;
    if series.len() > 1 {
        series[1] = [x_1, y_1, phi_1, u_2_1, S::int(0)];
    }
    let sin_phi_1 = phi_1 * cos_phi_0;
    let cos_phi_1 = -phi_1 * sin_phi_0;
    let x_dot_2_1 = cos_phi_1.mul_add(u_2_0, u_2_1 * cos_phi_0);
    let y_dot_2_1 = sin_phi_1.mul_add(u_2_0, u_2_1 * sin_phi_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([phi_1, phi_1, u_2_1, u_2_1]),
            padded([cos_phi_1, sin_phi_1, cos_phi_1, sin_phi_1]),
        ];
    }
    let mut count_last = S::int(1);
    let mut phi_last = phi_1;
    let mut u_2_last = u_2_1;
    let mut sin_phi_last = sin_phi_1;
    let mut cos_phi_last = cos_phi_1;
    let mut next = [S::int(0); 8];
    // Rates at order k - 1.
    let mut x_rate = x_dot_2_1;
    let mut y_rate = y_dot_2_1;
    let mut phi_rate = S::int(0);
    let mut u_2_rate = g_sin_alpha * cos_phi_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let x = x_rate * over_k;
        let y = y_rate * over_k;
        let phi = phi_rate * over_k;
        let u_2 = u_2_rate * over_k;
        series[order] = [x, y, phi, u_2, S::int(0)];
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
                u_2_1.mul_add(cos_phi_last, u_2_last.mul_add(cos_phi_1, next[2])),
                u_2_1.mul_add(sin_phi_last, u_2_last.mul_add(sin_phi_1, next[3])),
            ])
        };
        // sin_phi = sin(phi)
        let sin_phi = phi.mul_add(cos_phi_0, sums[0] * over_k);
        // cos_phi = cos(phi)
        let cos_phi = -phi.mul_add(sin_phi_0, sums[1] * over_k);
        // x_dot_2 = u_2*cos_phi
        let x_dot_2 = cos_phi.mul_add(u_2_0, u_2.mul_add(cos_phi_0, sums[2]));
        // y_dot_2 = u_2*sin_phi
        let y_dot_2 = sin_phi.mul_add(u_2_0, u_2.mul_add(sin_phi_0, sums[3]));
        x_rate = x_dot_2;
        y_rate = y_dot_2;
        phi_rate = S::int(0);
        u_2_rate = g_sin_alpha * cos_phi;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([count * phi, count * phi, u_2, u_2]),
            padded([cos_phi, sin_phi, cos_phi, sin_phi]),
        ];
        count_last = count;
        phi_last = phi;
        u_2_last = u_2;
        sin_phi_last = sin_phi;
        cos_phi_last = cos_phi;
    }
}

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 4,
            coordinates: 3,
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
