//! Cart with spring: Released from a drawn spring.
//!
//! Generated from `models/cart_with_spring/scenes/released.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::{
    CompiledScene, CompiledSystem, Derivative, Dual, InLanes, Lengths, Scalar, System,
    by_columns,
};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// stiffness of the spring, kg/s^2
    pub k: S,
    /// length of the spring without load, m
    pub l: S,
    /// damping, kg/s
    pub c: S,
}

impl<S: Scalar> Parameters<S> {
    /// From values in the order of [`PARAMETERS`].
    ///
    /// # Panics
    /// If `p` has fewer values than there are parameters.
    #[must_use]
    #[inline(always)]
    pub fn from_slice(p: &[S]) -> Self {
        Self { k: p[0], l: p[1], c: p[2] }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 3] {
        let Self { k, l, c, .. } = self;
        [k, l, c]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 3] = ["k", "l", "c"];

/// Names of the outputs.
pub const OUTPUTS: [&str; 2] = ["x", "v"];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 0 operations.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    _q: &[S; 1],
    _u: &[S; 1],
) -> [S; 3] {
    let super::super::super::Parameters { k, l, c, .. } = *p;
    // Values.
    // k
    let k_value = k;
    // l
    let l_value = l;
    // c
    let c_value = c;
    [k_value, l_value, c_value]
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
    let [x] = *q;
    let [v] = *u;
    // Values.
    // x
    let x_value = x;
    // v
    let v_value = v;
    ([x_value], [v_value])
}

/// The accelerations (v'), solved for when this code was generated.
///
/// 8 operations, 1 other function.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 1], u: &[S; 1]) -> [S; 1] {
    let Parameters { k, l, c } = *p;
    let [x] = *q;
    let [v] = *u;
    // Elimination, step by step, each after the terms that it shares.
    // k*(l*sqrt(x^2)/x - x) - c*v
    let v_dot_2_of_v = k * (l * (x * x).sqrt() / x - x) - c * v;
    // v' = 2*sqrt(x^2)*(k*(l - sqrt(x^2)) - c*v*sqrt(x^2)/x)/(3*x)
    let v_dot_2 = S::ratio(2, 3) * v_dot_2_of_v;
    [v_dot_2]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 1],
    u: &[S; 1],
) -> [S; 1] {
    let [v] = *u;
    // Values.
    // x' = v
    let x_dot_value = v;
    [x_dot_value]
}

/// Kinetic energy T.
///
/// 0 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(_p: &Parameters<S>, _q: &[S; 1], _u: &[S; 1]) -> S {
    let zero = S::int(0);
    zero
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 0 operations.
#[must_use]
pub fn potential_energy<S: Scalar>(_p: &Parameters<S>, _q: &[S; 1]) -> S {
    let zero = S::int(0);
    zero
}

/// What the scene asks for, a time t after the start.
///
/// 0 operations.
#[must_use]
pub fn outputs<S: Scalar>(_p: &Parameters<S>, _t: S, q: &[S; 1], u: &[S; 1]) -> [S; 2] {
    let [x] = *q;
    let [v] = *u;
    // Values.
    // x
    let x_value = x;
    // v
    let v_value = v;
    [x_value, v_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 8 operations, 1 other function.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 1],
    u: &[S; 1],
) -> ([S; 1], [S; 1]) {
    let Parameters { k, l, c } = *p;
    let [x] = *q;
    let [v] = *u;
    // Elimination, step by step, each after the terms that it shares.
    // k*(l*sqrt(x^2)/x - x) - c*v
    let v_dot_2_of_v = k * (l * (x * x).sqrt() / x - x) - c * v;
    // v' = 2*sqrt(x^2)*(k*(l - sqrt(x^2)) - c*v*sqrt(x^2)/x)/(3*x)
    let v_dot_2 = S::ratio(2, 3) * v_dot_2_of_v;
    // Values.
    // x' = v
    let x_dot_value = v;
    ([x_dot_value], [v_dot_2])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 1], _u: &[S; 1]) -> [S; 1] {
    let [x] = *q;
    // Values.
    // divisor1 = x
    let divisor1 = x;
    [divisor1]
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
    fn divisor_count(&self) -> usize {
        1
    }
    fn divisor_name(&self, at: usize) -> &str {
        ["x"][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
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
    name: "released",
    key: "0a7d86097d08cbb7",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: Some(InLanes::of_rates(&Derivative(Reduced))),
    },
};
