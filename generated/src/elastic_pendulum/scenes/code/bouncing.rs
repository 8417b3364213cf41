//! Elastic pendulum: Bouncing turns into swinging.
//!
//! Generated from `models/elastic_pendulum/scenes/bouncing.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::{
    CompiledScene, CompiledSystem, Derivative, Dual, InLanes, Lengths, Scalar, System,
    by_columns,
};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// stiffness of the spring; 3 m g/l makes it resonant, kg/s^2
    pub k: S,
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
        Self { k: p[0], g: p[1] }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 2] {
        let Self { k, g, .. } = self;
        [k, g]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 2] = ["k", "g"];

/// Names of the outputs.
pub const OUTPUTS: [&str; 4] = ["x", "y", "u", "v"];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 0 operations.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    _q: &[S; 2],
    _u: &[S; 2],
) -> [S; 2] {
    let super::super::super::Parameters { k, g, .. } = *p;
    // Values.
    // k
    let k_value = k;
    // g
    let g_value = g;
    [k_value, g_value]
}

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// 0 operations.
#[must_use]
pub fn start<S: Scalar>(
    _p: &super::super::super::Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let [x, y] = *q;
    let [u_2, v] = *u;
    // Values.
    // x
    let x_value = x;
    // y
    let y_value = y;
    // u
    let u_value = u_2;
    // v
    let v_value = v;
    ([x_value, y_value], [u_value, v_value])
}

/// The accelerations (u', v'), solved for when this code was generated.
///
/// 11 operations, 1 other function.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 2]) -> [S; 2] {
    let Parameters { k, g } = *p;
    let [x, y] = *q;
    // Elimination, step by step, each after the terms that it shares.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    // k*(1 - sqrt(x^2 + y^2)/(x^2 + y^2))
    let v_dot_2_of_k_x_y = k * (S::int(1) - x_sq_plus_y_sq.sqrt() / x_sq_plus_y_sq);
    // v' = k*y*sqrt(x^2 + y^2)*(1 - sqrt(x^2 + y^2))/(x^2 + y^2) - g
    let v_dot_2 = (-y).mul_add(v_dot_2_of_k_x_y, -g);
    // u' = k*x*sqrt(x^2 + y^2)*(1 - sqrt(x^2 + y^2))/(x^2 + y^2)
    let u_dot = -x * v_dot_2_of_k_x_y;
    [u_dot, v_dot_2]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    u: &[S; 2],
) -> [S; 2] {
    let [u_2, v] = *u;
    // Values.
    // x' = u
    let x_dot_value = u_2;
    // y' = v
    let y_dot_value = v;
    [x_dot_value, y_dot_value]
}

/// Kinetic energy T.
///
/// 4 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(_p: &Parameters<S>, _q: &[S; 2], u: &[S; 2]) -> S {
    let [u_2, v] = *u;
    // Shared terms.
    // u^2 + v^2
    let u_2_sq_plus_v_sq = v.mul_add(v, u_2 * u_2);
    // Values.
    // T = u^2/2 + v^2/2
    let energy = S::ratio(1, 2) * u_2_sq_plus_v_sq;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 9 operations, 1 other function.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2]) -> S {
    let Parameters { k, g } = *p;
    let [x, y] = *q;
    // Values.
    // V = g*y + k*(sqrt(x^2 + y^2) - 1)^2/2
    let energy = S::ratio(1, 2) * k * (y.mul_add(y, x * x).sqrt() - S::int(1)).powi(2) + g * y;
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 0 operations.
#[must_use]
pub fn outputs<S: Scalar>(_p: &Parameters<S>, _t: S, q: &[S; 2], u: &[S; 2]) -> [S; 4] {
    let [x, y] = *q;
    let [u_2, v] = *u;
    // Values.
    // x
    let x_value = x;
    // y
    let y_value = y;
    // u
    let u_value = u_2;
    // v
    let v_value = v;
    [x_value, y_value, u_value, v_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 11 operations, 1 other function.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let Parameters { k, g } = *p;
    let [x, y] = *q;
    let [u_2, v] = *u;
    // Elimination, step by step, each after the terms that it shares.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    // k*(1 - sqrt(x^2 + y^2)/(x^2 + y^2))
    let v_dot_2_of_k_x_y = k * (S::int(1) - x_sq_plus_y_sq.sqrt() / x_sq_plus_y_sq);
    // v' = k*y*sqrt(x^2 + y^2)*(1 - sqrt(x^2 + y^2))/(x^2 + y^2) - g
    let v_dot_2 = (-y).mul_add(v_dot_2_of_k_x_y, -g);
    // u' = k*x*sqrt(x^2 + y^2)*(1 - sqrt(x^2 + y^2))/(x^2 + y^2)
    let u_dot = -x * v_dot_2_of_k_x_y;
    // Values.
    // x' = u
    let x_dot_value = u_2;
    // y' = v
    let y_dot_value = v;
    ([x_dot_value, y_dot_value], [u_dot, v_dot_2])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 3 operations.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 2], _u: &[S; 2]) -> [S; 1] {
    let [x, y] = *q;
    // Values.
    // divisor1 = x^2 + y^2
    let divisor1 = y.mul_add(y, x * x);
    [divisor1]
}

/// The energy, then its derivatives by the state.
///
/// 18 operations, 1 other function.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 5] {
    let Parameters { k, g } = *p;
    let [x, y] = *q;
    let [u_2, v] = *u;
    // Shared terms.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    let energy_of_x_y = x_sq_plus_y_sq.sqrt();
    // sqrt(x^2 + y^2) - 1
    let energy_of_x_y_2 = energy_of_x_y - S::int(1);
    let k_energy_of_x_y_2 = k * energy_of_x_y_2;
    // u^2 + v^2
    let u_2_sq_plus_v_sq = v.mul_add(v, u_2 * u_2);
    // energy_of_x_y_2*k_energy_of_x_y_2 + u_2_sq_plus_v_sq
    let energy_of_u_2_v = energy_of_x_y_2.mul_add(k_energy_of_x_y_2, u_2_sq_plus_v_sq);
    let energy_by_x_of_k_x_y = k_energy_of_x_y_2 * energy_of_x_y / x_sq_plus_y_sq;
    // Values.
    // T + V = g*y + k*(sqrt(x^2 + y^2) - 1)^2/2 + u^2/2 + v^2/2
    let energy = g.mul_add(y, S::ratio(1, 2) * energy_of_u_2_v);
    // d(T + V)/d(x) = k*x*sqrt(x^2 + y^2)*(sqrt(x^2 + y^2) - 1)/(x^2 + y^2)
    let energy_by_x = x * energy_by_x_of_k_x_y;
    // d(T + V)/d(y) = g + k*y*sqrt(x^2 + y^2)*(sqrt(x^2 + y^2) - 1)/(x^2 + y^2)
    let energy_by_y = y.mul_add(energy_by_x_of_k_x_y, g);
    // d(T + V)/d(u) = u
    let energy_by_u = u_2;
    // d(T + V)/d(v) = v
    let energy_by_v = v;
    [energy, energy_by_x, energy_by_y, energy_by_u, energy_by_v]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
    direction: &[S; 4],
) -> [S; 4] {
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
            parameters: 2,
            coordinates: 2,
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
    fn output_count(&self) -> usize {
        4
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
    fn divisor_count(&self) -> usize {
        1
    }
    fn divisor_name(&self, at: usize) -> &str {
        ["x^2 + y^2"][at]
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
    name: "bouncing",
    key: "90f627c539702d95",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: Some(InLanes::of_rates(&Derivative(Reduced))),
    },
};
