//! Elastic pendulum: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/elastic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u, v.
///
/// 0 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 2],
    _u: &[S; 2],
) -> [[S; 2]; 2] {
    let Parameters { m, .. } = *p;
    // Entries that are not zero; upper triangle.
    // M11 = m
    let m11 = m;
    // M22 = m
    let m22 = m;
    let zero = S::int(0);
    [[m11, zero], [zero, m22]]
}

/// Right-hand side of the linear system; unknowns (u', v').
///
/// 11 operations, 1 other function.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 2]) -> [S; 2] {
    let Parameters { m, k, l, g } = *p;
    let [x, y] = *q;
    // Shared terms.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    let f1_of_x_y = x_sq_plus_y_sq.sqrt();
    // k*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(x^2 + y^2)
    let f1_of_k_l_x_y = k * f1_of_x_y * (l - f1_of_x_y) / x_sq_plus_y_sq;
    // Values.
    // f1 = k*x*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(x^2 + y^2)
    let f1 = x * f1_of_k_l_x_y;
    // f2 = k*y*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(x^2 + y^2) - m*g
    let f2 = (-m).mul_add(g, y * f1_of_k_l_x_y);
    [f1, f2]
}

/// The accelerations (u', v'), solved for when this code was generated.
///
/// 11 operations, 1 other function.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 2]) -> [S; 2] {
    let Parameters { m, k, l, g } = *p;
    let [x, y] = *q;
    // Elimination, step by step, each after the terms that it shares.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    let v_dot_2_of_x_y = x_sq_plus_y_sq.sqrt();
    // k*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2))
    let v_dot_2_of_m_k_l_x_y = k * v_dot_2_of_x_y * (l - v_dot_2_of_x_y) / (m * x_sq_plus_y_sq);
    // v' = k*y*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2)) - g
    let v_dot_2 = y.mul_add(v_dot_2_of_m_k_l_x_y, -g);
    // u' = k*x*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2))
    let u_dot = x * v_dot_2_of_m_k_l_x_y;
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
/// 5 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 2], u: &[S; 2]) -> S {
    let Parameters { m, .. } = *p;
    let [u_2, v] = *u;
    // Values.
    // T = m*u^2/2 + m*v^2/2
    let energy = S::ratio(1, 2) * m * v.mul_add(v, u_2 * u_2);
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 10 operations, 1 other function.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2]) -> S {
    let Parameters { m, k, l, g } = *p;
    let [x, y] = *q;
    // Values.
    // V = m*g*y + k*(l - sqrt(x^2 + y^2))^2/2
    let energy = S::ratio(1, 2) * k * (l - y.mul_add(y, x * x).sqrt()).powi(2) + m * g * y;
    energy
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
    let Parameters { m, k, l, g } = *p;
    let [x, y] = *q;
    let [u_2, v] = *u;
    // Elimination, step by step, each after the terms that it shares.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    let v_dot_2_of_x_y = x_sq_plus_y_sq.sqrt();
    // k*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2))
    let v_dot_2_of_m_k_l_x_y = k * v_dot_2_of_x_y * (l - v_dot_2_of_x_y) / (m * x_sq_plus_y_sq);
    // v' = k*y*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2)) - g
    let v_dot_2 = y.mul_add(v_dot_2_of_m_k_l_x_y, -g);
    // u' = k*x*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(m*(x^2 + y^2))
    let u_dot = x * v_dot_2_of_m_k_l_x_y;
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

/// Inverse dynamics: the generalized forces along (u, v) that must act beside the loads of the model for the accelerations to be (u', v').
///
/// 14 operations, 1 other function.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _u: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { m, k, l, g } = *p;
    let [x, y] = *q;
    let [u_dot, v_dot_2] = *v_dot;
    // Shared terms.
    // x^2 + y^2
    let x_sq_plus_y_sq = y.mul_add(y, x * x);
    let tau1_of_x_y = x_sq_plus_y_sq.sqrt();
    // k*sqrt(x^2 + y^2)*(l - sqrt(x^2 + y^2))/(x^2 + y^2)
    let tau1_of_k_l_x_y = k * tau1_of_x_y * (l - tau1_of_x_y) / x_sq_plus_y_sq;
    // Values.
    // tau1 = k*x*sqrt(x^2 + y^2)*(sqrt(x^2 + y^2) - l)/(x^2 + y^2) + m*u'
    let tau1 = (-x).mul_add(tau1_of_k_l_x_y, m * u_dot);
    // tau2 = m*g + k*y*sqrt(x^2 + y^2)*(sqrt(x^2 + y^2) - l)/(x^2 + y^2) + m*v'
    let tau2 = m * (g + v_dot_2) - y * tau1_of_k_l_x_y;
    [tau1, tau2]
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

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 4,
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
    fn mass_matrix(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            mass_matrix(&Parameters::from_slice(p), array(q), array(v)).as_flattened(),
        );
    }
    fn forcing(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&forcing(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn output_count(&self) -> usize {
        4
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
