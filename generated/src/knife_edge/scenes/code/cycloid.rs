//! Knife edge on an incline: A blade that turns does not run down.
//!
//! Generated from `models/knife_edge/scenes/cycloid.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::{
    CompiledScene, CompiledSystem, Derivative, Dual, InLanes, Lengths, Scalar, System,
    by_columns,
};

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

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 1],
    direction: &[S; 4],
) -> [S; 4] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[3 + i],
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
    slice.try_into().expect("a slice of the length that `System` requires")
}

/// What a program needs to find these equations and to trust them.
pub const SCENE: CompiledScene = CompiledScene {
    name: "cycloid",
    key: "9f22e36920eaaa6d",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: Some(InLanes::of_rates(&Derivative(Reduced))),
    },
};
