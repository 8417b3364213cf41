//! Pendulum on a driven pivot: Too slow, and it falls.
//!
//! Generated from `models/driven_pendulum/scenes/falling.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::{
    CompiledScene, CompiledSystem, Derivative, Dual, InLanes, Lengths, Scalar, System,
    by_columns,
};

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

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 1],
    direction: &[S; 3],
) -> [S; 3] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[2 + i],
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
    name: "falling",
    key: "3f414438ad4e6036",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: Some(InLanes::of_rates(&Derivative(Reduced))),
    },
};
