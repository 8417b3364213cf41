//! Cart with spring: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/cart_with_spring/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows v.
///
/// 0 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 1],
    _u: &[S; 1],
) -> [[S; 1]; 1] {
    let Parameters { m, .. } = *p;
    // Entries that are not zero; upper triangle.
    // M11 = m
    let m11 = m;
    [[m11]]
}

/// Right-hand side of the linear system; unknowns (v').
///
/// 7 operations, 1 other function.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 1], u: &[S; 1]) -> [S; 1] {
    let Parameters { k, l, c, .. } = *p;
    let [x] = *q;
    let [v] = *u;
    // Values.
    // f1 = sqrt(x^2)*(k*(l - sqrt(x^2)) - c*v*sqrt(x^2)/x)/x
    let f1 = k * (l * (x * x).sqrt() / x - x) - c * v;
    [f1]
}

/// The accelerations (v'), solved for when this code was generated.
///
/// 9 operations, 1 other function.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 1], u: &[S; 1]) -> [S; 1] {
    let Parameters { m, k, l, c } = *p;
    let [x] = *q;
    let [v] = *u;
    // Elimination, step by step, each after the terms that it shares.
    let v_dot_2_of_x = (x * x).sqrt();
    let v_dot_2_of_x_2 = v_dot_2_of_x / x;
    // v' = sqrt(x^2)*(k*(l - sqrt(x^2)) - c*v*sqrt(x^2)/x)/(m*x)
    let v_dot_2 = v_dot_2_of_x_2 * (k * (l - v_dot_2_of_x) - c * v * v_dot_2_of_x_2) / m;
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
/// 3 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 1], u: &[S; 1]) -> S {
    let Parameters { m, .. } = *p;
    let [v] = *u;
    // Values.
    // T = m*v^2/2
    let energy = S::ratio(1, 2) * m * v * v;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 5 operations, 1 other function.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 1]) -> S {
    let Parameters { k, l, .. } = *p;
    let [x] = *q;
    // Values.
    // V = k*(l - sqrt(x^2))^2/2
    let energy = S::ratio(1, 2) * k * (l - (x * x).sqrt()).powi(2);
    energy
}

/// The power of the loads that have no potential: the rate of T + V.
///
/// 3 operations.
#[must_use]
pub fn power<S: Scalar>(p: &Parameters<S>, _q: &[S; 1], u: &[S; 1]) -> S {
    let Parameters { c, .. } = *p;
    let [v] = *u;
    // Values.
    // d(T + V)/dt = -c*v^2
    let rate = -c * v * v;
    rate
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 9 operations, 1 other function.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 1],
    u: &[S; 1],
) -> ([S; 1], [S; 1]) {
    let Parameters { m, k, l, c } = *p;
    let [x] = *q;
    let [v] = *u;
    // Elimination, step by step, each after the terms that it shares.
    let v_dot_2_of_x = (x * x).sqrt();
    let v_dot_2_of_x_2 = v_dot_2_of_x / x;
    // v' = sqrt(x^2)*(k*(l - sqrt(x^2)) - c*v*sqrt(x^2)/x)/(m*x)
    let v_dot_2 = v_dot_2_of_x_2 * (k * (l - v_dot_2_of_x) - c * v * v_dot_2_of_x_2) / m;
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

/// Inverse dynamics: the generalized forces along (v) that must act beside the loads of the model for the accelerations to be (v').
///
/// 9 operations, 1 other function.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 1],
    u: &[S; 1],
    v_dot: &[S; 1],
) -> [S; 1] {
    let Parameters { m, k, l, c } = *p;
    let [x] = *q;
    let [v] = *u;
    let [v_dot_2] = *v_dot;
    // Values.
    // tau1 = sqrt(x^2)*(c*v*sqrt(x^2)/x - k*(l - sqrt(x^2)))/x + m*v'
    let tau1 = k * (x - l * (x * x).sqrt() / x) + c * v + m * v_dot_2;
    [tau1]
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

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 4,
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
    fn has_power(&self) -> bool {
        true
    }
    fn power(&self, p: &[S], q: &[S], v: &[S]) -> S {
        power(&Parameters::from_slice(p), array(q), array(v))
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
