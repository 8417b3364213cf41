//! Pendulum on a driven pivot: Too slow, and it falls.
//!
//! Generated from `models/driven_pendulum/scenes/falling.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{CompiledScene, CompiledSystem, Lengths, Scalar, System};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// mass of the bob, kg
    pub m: S,
    /// acceleration of free fall, m/s^2
    pub g: S,
    /// amplitude of the pivot, m
    pub a: S,
    /// frequency of the pivot, 1/s
    pub w: S,
    /// a*w^2, m/s^2
    pub a_w_squared: S,
}

impl<S: Scalar> Parameters<S> {
    /// From values in the order of [`PARAMETERS`].
    ///
    /// # Panics
    /// If `p` has fewer values than there are parameters.
    #[must_use]
    #[inline(always)]
    pub fn from_slice(p: &[S]) -> Self {
        Self {
            m: p[0], g: p[1], a: p[2], w: p[3], a_w_squared: p[4],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 5] {
        let Self { m, g, a, w, a_w_squared, .. } = self;
        [m, g, a, w, a_w_squared]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 5] = ["m", "g", "a", "w", "a_w_squared"];

/// Names of the outputs.
pub const OUTPUTS: [&str; 3] = ["q", "t", "u"];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 2 operations.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    _q: &[S; 2],
    _u: &[S; 1],
) -> [S; 5] {
    let super::super::super::Parameters { m, g, a, w, .. } = *p;
    // Values.
    // m
    let m_value = m;
    // g
    let g_value = g;
    // a
    let a_value = a;
    // w
    let w_value = w;
    // a_w_squared = a*w^2
    let a_w_squared_value = a * w * w;
    [m_value, g_value, a_value, w_value, a_w_squared_value]
}

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// 0 operations.
#[must_use]
pub fn start<S: Scalar>(
    _p: &super::super::super::Parameters<S>,
    q: &[S; 2],
    u: &[S; 1],
) -> ([S; 2], [S; 1]) {
    let [q_2, t] = *q;
    let [u_2] = *u;
    // Values.
    // q
    let q_value = q_2;
    // t
    let t_value = t;
    // u
    let u_value = u_2;
    ([q_value, t_value], [u_value])
}

/// The accelerations (u'), solved for when this code was generated.
///
/// 5 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 1]) -> [S; 1] {
    let Parameters { g, w, a_w_squared, .. } = *p;
    let [q_2, t] = *q;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    let (sin_w_t, _) = (w * t).sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u' = 2*sin(q)*(a_w_squared*sin(w*t) - g)
    let u_dot = S::int(2) * sin_q * a_w_squared.mul_add(sin_w_t, -g);
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
/// 0 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(_p: &Parameters<S>, _q: &[S; 2], _u: &[S; 1]) -> S {
    let zero = S::int(0);
    zero
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 0 operations.
#[must_use]
pub fn potential_energy<S: Scalar>(_p: &Parameters<S>, _q: &[S; 2]) -> S {
    let zero = S::int(0);
    zero
}

/// What the scene asks for, a time t after the start.
///
/// 0 operations.
#[must_use]
pub fn outputs<S: Scalar>(_p: &Parameters<S>, _t: S, q: &[S; 2], u: &[S; 1]) -> [S; 3] {
    let [q_2, t] = *q;
    let [u_2] = *u;
    // Values.
    // q
    let q_value = q_2;
    // t
    let t_value = t;
    // u
    let u_value = u_2;
    [q_value, t_value, u_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 5 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 1],
) -> ([S; 2], [S; 1]) {
    let Parameters { g, w, a_w_squared, .. } = *p;
    let [q_2, t] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    let (sin_w_t, _) = (w * t).sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u' = 2*sin(q)*(a_w_squared*sin(w*t) - g)
    let u_dot = S::int(2) * sin_q * a_w_squared.mul_add(sin_w_t, -g);
    // Values.
    // q' = u
    let q_dot_value = u_2;
    // t' = 1
    let t_dot_value = S::int(1);
    ([q_dot_value, t_dot_value], [u_dot])
}

/// Jacobian of the derivative by the state; columns q, t, u.
///
/// 9 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 1]) -> [[S; 3]; 3] {
    let Parameters { g, w, a_w_squared, .. } = *p;
    let [q_2, t] = *q;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let w_t = w * t;
    let (sin_w_t, cos_w_t) = w_t.sin_cos();
    // u_dot_by_q = 2*cos(q)*(a_w_squared*sin(w*t) - g)
    let u_dot_by_q = S::int(2) * cos_q * a_w_squared.mul_add(sin_w_t, -g);
    // u_dot_by_t = 2*w*a_w_squared*sin(q)*cos(w*t)
    let u_dot_by_t = S::int(2) * w * a_w_squared * sin_q * cos_w_t;
    // Entries that are not zero.
    // d(q')/d(u) = 1
    let q_dot_by_u_value = S::int(1);
    let zero = S::int(0);
    [[zero, zero, q_dot_by_u_value], [zero, zero, zero], [u_dot_by_q, u_dot_by_t, zero]]
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
    let Parameters { g, w, a_w_squared, .. } = *p;
    let [q_2_0, t_0, u_2_0] = series[0];
    // Constant in time.
    // minus_a_w_squared = -a_w_squared
    let minus_a_w_squared = -a_w_squared;
    // Order 0.
    let w_t_0 = w * t_0;
    let (sin_w_t_0, cos_w_t_0) = w_t_0.sin_cos();
    let (sin_q_0, cos_q_0) = q_2_0.sin_cos();
    let u_dot_of_place_0 = sin_w_t_0.mul_add(minus_a_w_squared, g);
    let u_dot_of_place_2_0 = sin_q_0 * u_dot_of_place_0;
    // Order 1: the rates, and what follows from them.
    let q_2_1 = u_2_0;
    let t_1 = S::int(1);
    let u_2_1 = -S::int(2) * u_dot_of_place_2_0;
    if series.len() > 1 {
        series[1] = [q_2_1, t_1, u_2_1];
    }
    let w_t_1 = w * t_1;
    let sin_w_t_1 = w_t_1 * cos_w_t_0;
    let cos_w_t_1 = -w_t_1 * sin_w_t_0;
    let sin_q_1 = q_2_1 * cos_q_0;
    let cos_q_1 = -q_2_1 * sin_q_0;
    let u_dot_of_place_1 = minus_a_w_squared * sin_w_t_1;
    let u_dot_of_place_2_1 = u_dot_of_place_1
        .mul_add(sin_q_0, sin_q_1 * u_dot_of_place_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([w_t_1, w_t_1, q_2_1, q_2_1, sin_q_1]),
            padded([cos_w_t_1, sin_w_t_1, cos_q_1, sin_q_1, u_dot_of_place_1]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q_2_last = q_2_1;
    let mut w_t_last = w_t_1;
    let mut sin_w_t_last = sin_w_t_1;
    let mut cos_w_t_last = cos_w_t_1;
    let mut sin_q_last = sin_q_1;
    let mut cos_q_last = cos_q_1;
    let mut u_dot_of_place_last = u_dot_of_place_1;
    let mut next = [S::int(0); 8];
    // Rates at order k - 1.
    let mut q_2_rate = u_2_1;
    let mut t_rate = S::int(0);
    let mut u_2_rate = -S::int(2) * u_dot_of_place_2_1;
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
                        u_dot_of_place_last,
                        sin_q_last.mul_add(u_dot_of_place_1, next[4]),
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
        // u_dot_of_place = g + minus_a_w_squared*sin_w_t
        let u_dot_of_place = minus_a_w_squared * sin_w_t;
        // u_dot_of_place_2 = sin_q*u_dot_of_place
        let u_dot_of_place_2 = u_dot_of_place
            .mul_add(sin_q_0, sin_q.mul_add(u_dot_of_place_0, sums[4]));
        q_2_rate = u_2;
        t_rate = S::int(0);
        u_2_rate = -S::int(2) * u_dot_of_place_2;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([count * w_t, count * w_t, count * q_2, count * q_2, sin_q]),
            padded([cos_w_t, sin_w_t, cos_q, sin_q, u_dot_of_place]),
        ];
        count_last = count;
        q_2_last = q_2;
        w_t_last = w_t;
        sin_w_t_last = sin_w_t;
        cos_w_t_last = cos_w_t;
        sin_q_last = sin_q;
        cos_q_last = cos_q;
        u_dot_of_place_last = u_dot_of_place;
    }
}

/// Reduced equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Reduced;

impl<S: Scalar> System<S> for Reduced {
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
    fn output_count(&self) -> usize {
        3
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

/// What a program needs to find these equations and to trust them.
pub const SCENE: CompiledScene = CompiledScene {
    name: "falling",
    key: "3f414438ad4e6036",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: None,
    },
};
