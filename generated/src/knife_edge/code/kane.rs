//! Knife edge on an incline: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/knife_edge/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u, w.
///
/// 0 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 3],
    _u: &[S; 2],
) -> [[S; 2]; 2] {
    let Parameters { m, J, .. } = *p;
    // Entries that are not zero; upper triangle.
    // M11 = m
    let m11 = m;
    // M22 = J
    let m22 = J;
    let zero = S::int(0);
    [[m11, zero], [zero, m22]]
}

/// Right-hand side of the linear system; unknowns (u', w').
///
/// 3 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], _u: &[S; 2]) -> [S; 2] {
    let Parameters { m, alpha, g, .. } = *p;
    let [_, _, phi] = *q;
    // Sines and cosines.
    let (_, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Values.
    // f1 = m*g*sin(alpha)*cos(phi)
    let f1 = m * g * sin_alpha * cos_phi;
    let zero = S::int(0);
    [f1, zero]
}

/// The accelerations (u', w'), solved for when this code was generated.
///
/// 2 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 3], _u: &[S; 2]) -> [S; 2] {
    let Parameters { alpha, g, .. } = *p;
    let [_, _, phi] = *q;
    // Sines and cosines.
    let (_, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u' = g*sin(alpha)*cos(phi)
    let u_dot = g * sin_alpha * cos_phi;
    let zero = S::int(0);
    [u_dot, zero]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 2 operations, 1 sine and cosine.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 2],
) -> [S; 3] {
    let [_, _, phi] = *q;
    let [u_2, w] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Values.
    // x' = u*cos(phi)
    let x_dot_value = u_2 * cos_phi;
    // y' = u*sin(phi)
    let y_dot_value = u_2 * sin_phi;
    // phi' = w
    let phi_dot_value = w;
    [x_dot_value, y_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 6 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 3], u: &[S; 2]) -> S {
    let Parameters { m, J, .. } = *p;
    let [u_2, w] = *u;
    // Shared terms.
    // m*u^2 + J*w^2
    let m_u_2_sq_plus_j_w_sq = m * u_2 * u_2 + J * w * w;
    // Values.
    // T = m*u^2/2 + J*w^2/2
    let energy = S::ratio(1, 2) * m_u_2_sq_plus_j_w_sq;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3]) -> S {
    let Parameters { m, alpha, g, .. } = *p;
    let [x, _, _] = *q;
    // Sines and cosines.
    let (sin_alpha, _) = alpha.sin_cos();
    // Values.
    // V = -m*g*x*sin(alpha)
    let energy = -m * g * x * sin_alpha;
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 4 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 2],
) -> ([S; 3], [S; 2]) {
    let Parameters { alpha, g, .. } = *p;
    let [_, _, phi] = *q;
    let [u_2, w] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u' = g*sin(alpha)*cos(phi)
    let u_dot = g * sin_alpha * cos_phi;
    // Values.
    // x' = u*cos(phi)
    let x_dot_value = u_2 * cos_phi;
    // y' = u*sin(phi)
    let y_dot_value = u_2 * sin_phi;
    // phi' = w
    let phi_dot_value = w;
    let zero = S::int(0);
    ([x_dot_value, y_dot_value, phi_dot_value], [u_dot, zero])
}

/// Inverse dynamics: the generalized forces along (u, w) that must act beside the loads of the model for the accelerations to be (u', w').
///
/// 5 operations, 2 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    _u: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { m, J, alpha, g } = *p;
    let [_, _, phi] = *q;
    let [u_dot, w_dot] = *v_dot;
    // Sines and cosines.
    let (_, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Values.
    // tau1 = m*u' - m*g*sin(alpha)*cos(phi)
    let tau1 = m * (-(g * sin_alpha)).mul_add(cos_phi, u_dot);
    // tau2 = J*w'
    let tau2 = J * w_dot;
    [tau1, tau2]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 2],
    direction: &[S; 5],
) -> [S; 5] {
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

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 4,
            coordinates: 3,
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
        5
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
