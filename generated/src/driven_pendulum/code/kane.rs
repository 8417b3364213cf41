//! Pendulum on a driven pivot: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/driven_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u.
///
/// 2 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 2],
    _u: &[S; 1],
) -> [[S; 1]; 1] {
    let Parameters { m, l, .. } = *p;
    // Entries that are not zero; upper triangle.
    // M11 = m*l^2
    let m11 = m * l * l;
    [[m11]]
}

/// Right-hand side of the linear system; unknowns (u').
///
/// 8 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 1]) -> [S; 1] {
    let Parameters { m, l, g, a, w } = *p;
    let [q_2, t] = *q;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    let (sin_w_t, _) = (w * t).sin_cos();
    // Values.
    // f1 = m*l*sin(q)*(a*w^2*sin(w*t) - g)
    let f1 = m * l * sin_q * (a * w * w * sin_w_t - g);
    [f1]
}

/// The accelerations (u'), solved for when this code was generated.
///
/// 7 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 1]) -> [S; 1] {
    let Parameters { l, g, a, w, .. } = *p;
    let [q_2, t] = *q;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    let (sin_w_t, _) = (w * t).sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u' = sin(q)*(a*w^2*sin(w*t) - g)/l
    let u_dot = sin_q * (a * w * w * sin_w_t - g) / l;
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
/// 12 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> S {
    let Parameters { m, l, a, w, .. } = *p;
    let [q_2, t] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    let (_, cos_w_t) = (w * t).sin_cos();
    // Shared terms.
    let a_w_cos_w_t = a * w * cos_w_t;
    let l_u_2 = l * u_2;
    // Values.
    // T = m*(a^2*w^2*cos(w*t)^2 + l*u*(2*a*w*sin(q)*cos(w*t) + l*u))/2
    let energy = S::ratio(1, 2) * m
        * (l_u_2 * (a_w_cos_w_t * sin_q).mul_add(S::int(2), l_u_2) + a_w_cos_w_t * a_w_cos_w_t);
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 6 operations, 2 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2]) -> S {
    let Parameters { m, l, g, a, w } = *p;
    let [q_2, t] = *q;
    // Sines and cosines.
    let (_, cos_q) = q_2.sin_cos();
    let (sin_w_t, _) = (w * t).sin_cos();
    // Values.
    // V = m*g*(a*sin(w*t) - l*cos(q))
    let energy = m * g * (-l).mul_add(cos_q, a * sin_w_t);
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 7 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 1],
) -> ([S; 2], [S; 1]) {
    let Parameters { l, g, a, w, .. } = *p;
    let [q_2, t] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    let (sin_w_t, _) = (w * t).sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u' = sin(q)*(a*w^2*sin(w*t) - g)/l
    let u_dot = sin_q * (a * w * w * sin_w_t - g) / l;
    // Values.
    // q' = u
    let q_dot_value = u_2;
    // t' = 1
    let t_dot_value = S::int(1);
    ([q_dot_value, t_dot_value], [u_dot])
}

/// Inverse dynamics: the generalized forces along (u) that must act beside the loads of the model for the accelerations to be (u').
///
/// 10 operations, 2 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _u: &[S; 1],
    v_dot: &[S; 1],
) -> [S; 1] {
    let Parameters { m, l, g, a, w } = *p;
    let [q_2, t] = *q;
    let [u_dot] = *v_dot;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    let (sin_w_t, _) = (w * t).sin_cos();
    // Values.
    // tau1 = m*l*sin(q)*(g - a*w^2*sin(w*t)) + m*l^2*u'
    let tau1 = m * l * (sin_q * (g - a * w * w * sin_w_t) + l * u_dot);
    [tau1]
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

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
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
