//! Pendulum on a driven pivot: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/driven_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows q, t, constraint t.
///
/// 10 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _q_dot: &[S; 2],
) -> [[S; 3]; 3] {
    let Parameters { m, l, a, w, .. } = *p;
    let [q_2, t] = *q;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    // Shared terms.
    let m_l = m * l;
    let (_, cos_w_t) = (w * t).sin_cos();
    let a_w_cos_w_t = a * w * cos_w_t;
    let sin_q_m_l_a_w_cos_w_t = m_l * a_w_cos_w_t * sin_q;
    // Entries that are not zero.
    // M11 = m*l^2
    let m11 = l * m_l;
    // M12 = m*l*a*w*sin(q)*cos(w*t)
    let m12 = sin_q_m_l_a_w_cos_w_t;
    // M21 = m*l*a*w*sin(q)*cos(w*t)
    let m21 = sin_q_m_l_a_w_cos_w_t;
    // M22 = m*a^2*w^2*cos(w*t)^2
    let m22 = m * a_w_cos_w_t * a_w_cos_w_t;
    // M23 = -1
    let m23 = -S::int(1);
    // M32 = 1
    let m32 = S::int(1);
    let zero = S::int(0);
    [[m11, m12, zero], [m21, m22, m23], [zero, m32, zero]]
}

/// Right-hand side of the linear system; unknowns (q'', t'', lambda_t).
///
/// 17 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> [S; 3] {
    let Parameters { m, l, g, a, w } = *p;
    let [q_2, t] = *q;
    let [q_dot_2, t_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    // Shared terms.
    let a_w = a * w;
    let w_t = w * t;
    let (sin_w_t, cos_w_t) = w_t.sin_cos();
    // w*t'^2*a_w*sin(w*t) - g
    let f1_of_t_dot = w * t_dot * t_dot * a_w * sin_w_t - g;
    // Values.
    // f1 = m*l*sin(q)*(a*w^2*t'^2*sin(w*t) - g)
    let f1 = m * l * f1_of_t_dot * sin_q;
    // f2 = m*a*w*cos(w*t)*(a*w^2*t'^2*sin(w*t) - g - l*q'^2*cos(q))
    let f2 = m * a_w * cos_w_t * (f1_of_t_dot - l * q_dot_2 * q_dot_2 * cos_q);
    let zero = S::int(0);
    [f1, f2, zero]
}

/// The accelerations (q'', t''), solved for when this code was generated.
///
/// 8 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { l, g, a, w, .. } = *p;
    let [q_2, t] = *q;
    let [_, t_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let w_t_dot = w * t_dot;
    let (sin_w_t, _) = (w * t).sin_cos();
    // u' = sin(q)*(a*w^2*t'^2*sin(w*t) - g)/l
    let u_dot = sin_q * (a * w_t_dot * w_t_dot * sin_w_t - g) / l;
    // q'' = u'
    let q_ddot = u_dot;
    let zero = S::int(0);
    [q_ddot, zero]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let [q_dot_2, t_dot] = *q_dot;
    // Values.
    // q'
    let q_dot_value = q_dot_2;
    // t'
    let t_dot_value = t_dot;
    [q_dot_value, t_dot_value]
}

/// Kinetic energy T.
///
/// 13 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> S {
    let Parameters { m, l, a, w, .. } = *p;
    let [q_2, t] = *q;
    let [q_dot_2, t_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    // Shared terms.
    let l_q_dot_2 = l * q_dot_2;
    let (_, cos_w_t) = (w * t).sin_cos();
    let a_w_t_dot_cos_w_t = a * w * t_dot * cos_w_t;
    // Values.
    // T = m*l^2*q'^2/2 + m*a^2*w^2*t'^2*cos(w*t)^2/2 + m*l*a*w*q'*t'*sin(q)*cos(w*t)
    let energy = S::ratio(1, 2) * m
        * (a_w_t_dot_cos_w_t * (l_q_dot_2 * sin_q).mul_add(S::int(2), a_w_t_dot_cos_w_t)
            + l_q_dot_2 * l_q_dot_2);
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 0 operations.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 1] {
    let [q_dot_2, _] = *q_dot;
    // Values.
    // u = q'
    let u_value = q_dot_2;
    [u_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 0 operations.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    _q_dot: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 1] {
    let [q_ddot, _] = *v_dot;
    // Values.
    // u' = q''
    let u_dot_value = q_ddot;
    [u_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 0 operations.
#[must_use]
pub fn motion_variables<S: Scalar>(
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

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 8 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let Parameters { l, g, a, w, .. } = *p;
    let [q_2, t] = *q;
    let [q_dot_2, t_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let w_t_dot = w * t_dot;
    let (sin_w_t, _) = (w * t).sin_cos();
    // u' = sin(q)*(a*w^2*t'^2*sin(w*t) - g)/l
    let u_dot = sin_q * (a * w_t_dot * w_t_dot * sin_w_t - g) / l;
    // q'' = u'
    let q_ddot = u_dot;
    // Values.
    // q'
    let q_dot_value = q_dot_2;
    // t'
    let t_dot_value = t_dot;
    let zero = S::int(0);
    ([q_dot_value, t_dot_value], [q_ddot, zero])
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
    direction: &[S; 4],
) -> [S; 4] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: q_dot[i],
        slope: direction[2 + i],
    });
    let (of_q, of_v) = derivative(&p, &q, &v);
    let mut slopes = of_q.into_iter().chain(of_v).map(|rate| rate.slope);
    core::array::from_fn(|_| {
        slopes.next().expect("a slope for each component of the state")
    })
}

/// Lagrange's equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Lagrange;

impl<S: Scalar> System<S> for Lagrange {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 5,
            coordinates: 2,
            variables: 2,
            speeds: 1,
            reactions: 1,
        }
    }
    fn symmetric(&self) -> bool {
        false
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
    fn generalized_speeds(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &generalized_speeds(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn generalized_speed_rates(
        &self,
        p: &[S],
        q: &[S],
        v: &[S],
        v_dot: &[S],
        out: &mut [S],
    ) {
        out.copy_from_slice(
            &generalized_speed_rates(
                &Parameters::from_slice(p),
                array(q),
                array(v),
                array(v_dot),
            ),
        );
    }
    fn motion_variables(&self, p: &[S], q: &[S], u: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &motion_variables(&Parameters::from_slice(p), array(q), array(u)),
        );
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
