//! Knife edge on an incline: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/knife_edge/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows x, y, phi, constraint edge.
///
/// 2 operations, 1 sine and cosine.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    _q_dot: &[S; 3],
) -> [[S; 4]; 4] {
    let Parameters { m, J, .. } = *p;
    let [_, _, phi] = *q;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Entries that are not zero.
    // M11 = m
    let m11 = m;
    // M14 = sin(phi)
    let m14 = sin_phi;
    // M22 = m
    let m22 = m;
    // M24 = -cos(phi)
    let m24 = -cos_phi;
    // M33 = J
    let m33 = J;
    // M41 = -sin(phi)
    let m41 = -sin_phi;
    // M42 = cos(phi)
    let m42 = cos_phi;
    let zero = S::int(0);
    [
        [m11, zero, zero, m14],
        [zero, m22, zero, m24],
        [zero, zero, m33, zero],
        [m41, m42, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (x'', y'', phi'', lambda_edge).
///
/// 6 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], q_dot: &[S; 3]) -> [S; 4] {
    let Parameters { m, alpha, g, .. } = *p;
    let [_, _, phi] = *q;
    let [x_dot, y_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Values.
    // f1 = m*g*sin(alpha)
    let f1 = m * g * sin_alpha;
    // f4 = phi'*(x'*cos(phi) + y'*sin(phi))
    let f4 = phi_dot * y_dot.mul_add(sin_phi, x_dot * cos_phi);
    let zero = S::int(0);
    [f1, zero, zero, f4]
}

/// The accelerations (x'', y'', phi''), solved for when this code was generated.
///
/// 12 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 3] {
    let Parameters { alpha, g, .. } = *p;
    let [_, _, phi] = *q;
    let [x_dot, y_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w' = 0
    let w_dot = S::int(0);
    // u' = g*sin(alpha)*cos(phi)
    let u_dot = g * sin_alpha * cos_phi;
    // phi'*(x'*cos(phi) + y'*sin(phi))
    let x_ddot_of_motion = phi_dot * y_dot.mul_add(sin_phi, x_dot * cos_phi);
    // x'' = u'*cos(phi) - phi'*sin(phi)*(x'*cos(phi) + y'*sin(phi))
    let x_ddot = (-x_ddot_of_motion).mul_add(sin_phi, u_dot * cos_phi);
    // y'' = phi'*cos(phi)*(x'*cos(phi) + y'*sin(phi)) + u'*sin(phi)
    let y_ddot = x_ddot_of_motion.mul_add(cos_phi, u_dot * sin_phi);
    // phi'' = w'
    let phi_ddot = w_dot;
    [x_ddot, y_ddot, phi_ddot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 3] {
    let [x_dot, y_dot, phi_dot] = *q_dot;
    // Values.
    // x'
    let x_dot_value = x_dot;
    // y'
    let y_dot_value = y_dot;
    // phi'
    let phi_dot_value = phi_dot;
    [x_dot_value, y_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 8 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 3], q_dot: &[S; 3]) -> S {
    let Parameters { m, J, .. } = *p;
    let [x_dot, y_dot, phi_dot] = *q_dot;
    // Shared terms.
    // m*(x'^2 + y'^2) + J*phi'^2
    let energy_of_motion = m * y_dot.mul_add(y_dot, x_dot * x_dot) + J * phi_dot * phi_dot;
    // Values.
    // T = m*x'^2/2 + m*y'^2/2 + J*phi'^2/2
    let energy = S::ratio(1, 2) * energy_of_motion;
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 2] {
    let [_, _, phi] = *q;
    let [x_dot, y_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Values.
    // u = x'*cos(phi) + y'*sin(phi)
    let u_value = y_dot.mul_add(sin_phi, x_dot * cos_phi);
    // w = phi'
    let w_value = phi_dot;
    [u_value, w_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 7 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
    v_dot: &[S; 3],
) -> [S; 2] {
    let [_, _, phi] = *q;
    let [x_dot, y_dot, phi_dot] = *q_dot;
    let [x_ddot, y_ddot, phi_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Values.
    // u' = phi'*(y'*cos(phi) - x'*sin(phi)) + x''*cos(phi) + y''*sin(phi)
    let u_dot_value = cos_phi * y_dot.mul_add(phi_dot, x_ddot)
        + sin_phi * (-x_dot).mul_add(phi_dot, y_ddot);
    // w' = phi''
    let w_dot_value = phi_ddot;
    [u_dot_value, w_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 2 operations, 1 sine and cosine.
#[must_use]
pub fn motion_variables<S: Scalar>(
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

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 12 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> ([S; 3], [S; 3]) {
    let Parameters { alpha, g, .. } = *p;
    let [_, _, phi] = *q;
    let [x_dot, y_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_alpha, _) = alpha.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // w' = 0
    let w_dot = S::int(0);
    // u' = g*sin(alpha)*cos(phi)
    let u_dot = g * sin_alpha * cos_phi;
    // phi'*(x'*cos(phi) + y'*sin(phi))
    let x_ddot_of_motion = phi_dot * y_dot.mul_add(sin_phi, x_dot * cos_phi);
    // x'' = u'*cos(phi) - phi'*sin(phi)*(x'*cos(phi) + y'*sin(phi))
    let x_ddot = (-x_ddot_of_motion).mul_add(sin_phi, u_dot * cos_phi);
    // y'' = phi'*cos(phi)*(x'*cos(phi) + y'*sin(phi)) + u'*sin(phi)
    let y_ddot = x_ddot_of_motion.mul_add(cos_phi, u_dot * sin_phi);
    // phi'' = w'
    let phi_ddot = w_dot;
    // Values.
    // x'
    let x_dot_value = x_dot;
    // y'
    let y_dot_value = y_dot;
    // phi'
    let phi_dot_value = phi_dot;
    ([x_dot_value, y_dot_value, phi_dot_value], [x_ddot, y_ddot, phi_ddot])
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn constraints<S: Scalar>(_p: &Parameters<S>, q: &[S; 3], q_dot: &[S; 3]) -> [S; 1] {
    let [_, _, phi] = *q;
    let [x_dot, y_dot, _] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Values.
    // edge = y'*cos(phi) - x'*sin(phi)
    let residual1 = (-x_dot).mul_add(sin_phi, y_dot * cos_phi);
    [residual1]
}

/// Slopes of the constraints, one after the other, along x, y, phi, x', y', phi'.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 6] {
    let [_, _, phi] = *q;
    let [x_dot, y_dot, _] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Values.
    // d(edge)/d(phi) = -x'*cos(phi) - y'*sin(phi)
    let residual1_by_phi = (-y_dot).mul_add(sin_phi, -x_dot * cos_phi);
    // d(edge)/d(x') = -sin(phi)
    let residual1_by_x_dot = -sin_phi;
    // d(edge)/d(y') = cos(phi)
    let residual1_by_y_dot = cos_phi;
    let zero = S::int(0);
    [zero, zero, residual1_by_phi, residual1_by_x_dot, residual1_by_y_dot, zero]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
    direction: &[S; 6],
) -> [S; 6] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: q_dot[i],
        slope: direction[3 + i],
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
            parameters: 4,
            coordinates: 3,
            variables: 3,
            speeds: 2,
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
    fn constraint_count(&self) -> usize {
        1
    }
    fn constraint_name(&self, at: usize) -> &str {
        ["edge"][at]
    }
    fn constraints(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &constraints(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn constraint_slopes(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &constraint_slopes(&Parameters::from_slice(p), array(q), array(v)),
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
