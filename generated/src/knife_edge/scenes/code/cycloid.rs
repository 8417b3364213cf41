//! Knife edge on an incline: A blade that turns does not run down.
//!
//! Generated from `models/knife_edge/scenes/cycloid.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{CompiledScene, CompiledSystem, Lengths, Scalar, System};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// inclination of the plane, 1
    pub alpha: S,
    /// acceleration of free fall, m/s^2
    pub g: S,
    /// generalized speed, constant with the momentum p_phi = ∂L/∂phi', 1/s
    pub w: S,
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
            alpha: p[0], g: p[1], w: p[2],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 3] {
        let Self { alpha, g, w, .. } = self;
        [alpha, g, w]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 3] = ["alpha", "g", "w"];

/// Names of the outputs.
pub const OUTPUTS: [&str; 5] = ["x", "y", "phi", "u", "w"];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 0 operations.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    _q: &[S; 3],
    u: &[S; 2],
) -> [S; 3] {
    let super::super::super::Parameters { alpha, g, .. } = *p;
    let [_, w] = *u;
    // Values.
    // alpha
    let alpha_value = alpha;
    // g
    let g_value = g;
    // w
    let w_value = w;
    [alpha_value, g_value, w_value]
}

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// 0 operations.
#[must_use]
pub fn start<S: Scalar>(
    _p: &super::super::super::Parameters<S>,
    q: &[S; 3],
    u: &[S; 2],
) -> ([S; 3], [S; 1]) {
    let [x, y, phi] = *q;
    let [u_2, _] = *u;
    // Values.
    // phi
    let phi_value = phi;
    // y
    let y_value = y;
    // x
    let x_value = x;
    // u
    let u_value = u_2;
    ([phi_value, y_value, x_value], [u_value])
}

/// The accelerations (u'), solved for when this code was generated.
///
/// 2 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 3], _u: &[S; 1]) -> [S; 1] {
    let Parameters { alpha, g, .. } = *p;
    let [phi, _, _] = *q;
    // Sines and cosines.
    let (_, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u' = g*sin(alpha)*cos(phi)
    let u_dot = g * sin_alpha * cos_phi;
    [u_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 2 operations, 1 sine and cosine.
#[must_use]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [S; 3] {
    let Parameters { w, .. } = *p;
    let [phi, _, _] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Values.
    // phi' = w
    let phi_dot_value = w;
    // y' = u*sin(phi)
    let y_dot_value = u_2 * sin_phi;
    // x' = u*cos(phi)
    let x_dot_value = u_2 * cos_phi;
    [phi_dot_value, y_dot_value, x_dot_value]
}

/// Kinetic energy T.
///
/// 2 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(_p: &Parameters<S>, _q: &[S; 3], u: &[S; 1]) -> S {
    let [u_2] = *u;
    // Values.
    // T = u^2/2
    let energy = S::ratio(1, 2) * u_2 * u_2;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3]) -> S {
    let Parameters { alpha, g, w } = *p;
    let [_, _, x] = *q;
    // Sines and cosines.
    let (sin_alpha, _) = alpha.sin_cos();
    // Values.
    // V = w^2/4 - g*x*sin(alpha)
    let energy = (-(g * x)).mul_add(sin_alpha, S::ratio(1, 4) * w * w);
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 0 operations.
#[must_use]
pub fn outputs<S: Scalar>(p: &Parameters<S>, _t: S, q: &[S; 3], u: &[S; 1]) -> [S; 5] {
    let Parameters { w, .. } = *p;
    let [phi, y, x] = *q;
    let [u_2] = *u;
    // Values.
    // x
    let x_value = x;
    // y
    let y_value = y;
    // phi
    let phi_value = phi;
    // u
    let u_value = u_2;
    // w
    let w_value = w;
    [x_value, y_value, phi_value, u_value, w_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 4 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 1],
) -> ([S; 3], [S; 1]) {
    let Parameters { alpha, g, w } = *p;
    let [phi, _, _] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u' = g*sin(alpha)*cos(phi)
    let u_dot = g * sin_alpha * cos_phi;
    // Values.
    // phi' = w
    let phi_dot_value = w;
    // y' = u*sin(phi)
    let y_dot_value = u_2 * sin_phi;
    // x' = u*cos(phi)
    let x_dot_value = u_2 * cos_phi;
    ([phi_dot_value, y_dot_value, x_dot_value], [u_dot])
}

/// Jacobian of the derivative by the state; columns phi, y, x, u.
///
/// 6 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [[S; 4]; 4] {
    let Parameters { alpha, g, .. } = *p;
    let [phi, _, _] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u_dot_by_phi = -g*sin(alpha)*sin(phi)
    let u_dot_by_phi = -g * sin_alpha * sin_phi;
    // Entries that are not zero.
    // d(y')/d(phi) = u*cos(phi)
    let y_dot_by_phi_value = u_2 * cos_phi;
    // d(y')/d(u) = sin(phi)
    let y_dot_by_u_value = sin_phi;
    // d(x')/d(phi) = -u*sin(phi)
    let x_dot_by_phi_value = -u_2 * sin_phi;
    // d(x')/d(u) = cos(phi)
    let x_dot_by_u_value = cos_phi;
    let zero = S::int(0);
    [
        [zero, zero, zero, zero],
        [y_dot_by_phi_value, zero, zero, y_dot_by_u_value],
        [x_dot_by_phi_value, zero, zero, x_dot_by_u_value],
        [u_dot_by_phi, zero, zero, zero],
    ]
}

/// The energy, then its derivatives by the state.
///
/// 9 operations, 1 sine and cosine.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [S; 5] {
    let Parameters { alpha, g, w } = *p;
    let [_, _, x] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_alpha, _) = alpha.sin_cos();
    // Shared terms.
    let g_sin_alpha = g * sin_alpha;
    // Values.
    // T + V = u^2/2 - g*x*sin(alpha) + w^2/4
    let energy = (-x)
        .mul_add(g_sin_alpha, S::ratio(1, 2) * u_2 * u_2 + S::ratio(1, 4) * w * w);
    // d(T + V)/d(x) = -g*sin(alpha)
    let energy_by_x = -g_sin_alpha;
    // d(T + V)/d(u) = u
    let energy_by_u = u_2;
    let zero = S::int(0);
    [energy, zero, zero, energy_by_x, energy_by_u]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 4 convolutions and 0 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 4]],
    history: &mut [Factors<S, 8>],
) {
    let Parameters { alpha, g, w } = *p;
    let [phi_0, _, _, u_2_0] = series[0];
    // Sines and cosines.
    let (sin_alpha, _) = alpha.sin_cos();
    // Constant in time.
    // g_sin_alpha = g*sin(alpha)
    let g_sin_alpha = g * sin_alpha;
    // Order 0.
    let (sin_phi_0, cos_phi_0) = phi_0.sin_cos();
    let y_dot_2_0 = u_2_0 * sin_phi_0;
    let x_dot_2_0 = u_2_0 * cos_phi_0;
    // Order 1: the rates, and what follows from them.
    let phi_1 = w;
    let y_1 = y_dot_2_0;
    let x_1 = x_dot_2_0;
    let u_2_1 = g_sin_alpha * cos_phi_0;
    if series.len() > 1 {
        series[1] = [phi_1, y_1, x_1, u_2_1];
    }
    let sin_phi_1 = phi_1 * cos_phi_0;
    let cos_phi_1 = -phi_1 * sin_phi_0;
    let y_dot_2_1 = sin_phi_1.mul_add(u_2_0, u_2_1 * sin_phi_0);
    let x_dot_2_1 = cos_phi_1.mul_add(u_2_0, u_2_1 * cos_phi_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([phi_1, phi_1, u_2_1, u_2_1]),
            padded([cos_phi_1, sin_phi_1, sin_phi_1, cos_phi_1]),
        ];
    }
    let mut count_last = S::int(1);
    let mut phi_last = phi_1;
    let mut u_2_last = u_2_1;
    let mut sin_phi_last = sin_phi_1;
    let mut cos_phi_last = cos_phi_1;
    let mut next = [S::int(0); 8];
    // Rates at order k - 1.
    let mut phi_rate = S::int(0);
    let mut y_rate = y_dot_2_1;
    let mut x_rate = x_dot_2_1;
    let mut u_2_rate = g_sin_alpha * cos_phi_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let phi = phi_rate * over_k;
        let y = y_rate * over_k;
        let x = x_rate * over_k;
        let u_2 = u_2_rate * over_k;
        series[order] = [phi, y, x, u_2];
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
                u_2_1.mul_add(sin_phi_last, u_2_last.mul_add(sin_phi_1, next[2])),
                u_2_1.mul_add(cos_phi_last, u_2_last.mul_add(cos_phi_1, next[3])),
            ])
        };
        // sin_phi = sin(phi)
        let sin_phi = phi.mul_add(cos_phi_0, sums[0] * over_k);
        // cos_phi = cos(phi)
        let cos_phi = -phi.mul_add(sin_phi_0, sums[1] * over_k);
        // y_dot_2 = u_2*sin_phi
        let y_dot_2 = sin_phi.mul_add(u_2_0, u_2.mul_add(sin_phi_0, sums[2]));
        // x_dot_2 = u_2*cos_phi
        let x_dot_2 = cos_phi.mul_add(u_2_0, u_2.mul_add(cos_phi_0, sums[3]));
        phi_rate = S::int(0);
        y_rate = y_dot_2;
        x_rate = x_dot_2;
        u_2_rate = g_sin_alpha * cos_phi;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([count * phi, count * phi, u_2, u_2]),
            padded([cos_phi, sin_phi, sin_phi, cos_phi]),
        ];
        count_last = count;
        phi_last = phi;
        u_2_last = u_2;
        sin_phi_last = sin_phi;
        cos_phi_last = cos_phi;
    }
}

/// Reduced equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Reduced;

impl<S: Scalar> System<S> for Reduced {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 3,
            coordinates: 3,
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
        5
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
    name: "cycloid",
    key: "9f22e36920eaaa6d",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: None,
    },
};
