//! Symmetric rigid body free of forces: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/free_body/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows v1, v2, v3, w1, w2, w3.
///
/// 0 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 6],
    _u: &[S; 6],
) -> [[S; 6]; 6] {
    let Parameters { m, I1, I3 } = *p;
    // Entries that are not zero; upper triangle.
    // M11 = m
    let m11 = m;
    // M22 = m
    let m22 = m;
    // M33 = m
    let m33 = m;
    // M44 = I1
    let m44 = I1;
    // M55 = I1
    let m55 = I1;
    // M66 = I3
    let m66 = I3;
    let zero = S::int(0);
    [
        [m11, zero, zero, zero, zero, zero],
        [zero, m22, zero, zero, zero, zero],
        [zero, zero, m33, zero, zero, zero],
        [zero, zero, zero, m44, zero, zero],
        [zero, zero, zero, zero, m55, zero],
        [zero, zero, zero, zero, zero, m66],
    ]
}

/// Right-hand side of the linear system; unknowns (v1', v2', v3', w1', w2', w3').
///
/// 8 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 6], u: &[S; 6]) -> [S; 6] {
    let Parameters { I1, I3, .. } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [_, _, _, w1, w2, w3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let tan_theta = sin_theta / cos_theta;
    // I3*w3 - I1*w2/tan(theta)
    let f4_of_w2_w3 = I3.mul_add(w3, -I1 * w2 / tan_theta);
    // Values.
    // f4 = w2*(I1*w2/tan(theta) - I3*w3)
    let f4 = -w2 * f4_of_w2_w3;
    // f5 = w1*(I3*w3 - I1*w2/tan(theta))
    let f5 = w1 * f4_of_w2_w3;
    let zero = S::int(0);
    [zero, zero, zero, f4, f5, zero]
}

/// The accelerations (v1', v2', v3', w1', w2', w3'), solved for when this code was generated.
///
/// 8 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 6], u: &[S; 6]) -> [S; 6] {
    let Parameters { I1, I3, .. } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [_, _, _, w1, w2, w3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let tan_theta = sin_theta / cos_theta;
    // w2/tan(theta) - I3*w3/I1
    let w2_dot_of_w2_w3 = w2 / tan_theta - I3 * w3 / I1;
    // w2' = w1*(I3*w3/I1 - w2/tan(theta))
    let w2_dot = -w1 * w2_dot_of_w2_w3;
    // w1' = w2*(w2/tan(theta) - I3*w3/I1)
    let w1_dot = w2 * w2_dot_of_w2_w3;
    let zero = S::int(0);
    [zero, zero, zero, w1_dot, w2_dot, zero]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 6],
    u: &[S; 6],
) -> [S; 6] {
    let [_, _, _, _, theta, _] = *q;
    let [v1, v2, v3, w1, w2, w3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let w2_sin_theta_inv = w2 / sin_theta;
    // Values.
    // x' = v1
    let x_dot_value = v1;
    // y' = v2
    let y_dot_value = v2;
    // z' = v3
    let z_dot_value = v3;
    // psi' = w2/sin(theta)
    let psi_dot_value = w2_sin_theta_inv;
    // theta' = w1
    let theta_dot_value = w1;
    // phi' = w3 - w2/tan(theta)
    let phi_dot_value = (-w2_sin_theta_inv).mul_add(cos_theta, w3);
    [
        x_dot_value, y_dot_value, z_dot_value, psi_dot_value, theta_dot_value, phi_dot_value,
    ]
}

/// Kinetic energy T.
///
/// 16 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 6], u: &[S; 6]) -> S {
    let Parameters { m, I1, I3 } = *p;
    let [v1, v2, v3, w1, w2, w3] = *u;
    // Shared terms.
    // v1^2 + v2^2
    let v1_sq_plus_v2_sq = v2.mul_add(v2, v1 * v1);
    // I1*(w1^2 + w2^2) + I3*w3^2
    let energy_of_w1_w2_w3 = I1 * w2.mul_add(w2, w1 * w1) + I3 * w3 * w3;
    // Values.
    // T = m*v1^2/2 + m*v2^2/2 + m*v3^2/2 + I1*w1^2/2 + I1*w2^2/2 + I3*w3^2/2
    let energy = S::ratio(1, 2) * m * v3.mul_add(v3, v1_sq_plus_v2_sq)
        + S::ratio(1, 2) * energy_of_w1_w2_w3;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 0 operations.
#[must_use]
pub fn potential_energy<S: Scalar>(_p: &Parameters<S>, _q: &[S; 6]) -> S {
    let zero = S::int(0);
    zero
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 9 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    u: &[S; 6],
) -> ([S; 6], [S; 6]) {
    let Parameters { I1, I3, .. } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [v1, v2, v3, w1, w2, w3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let w2_sin_theta_inv = w2 / sin_theta;
    let w2_dot_of_w2 = w2_sin_theta_inv * cos_theta;
    // w2_dot_of_w2 - I3*w3/I1
    let w2_dot_of_w2_w3 = w2_dot_of_w2 - I3 * w3 / I1;
    // w2' = w1*(I3*w3/I1 - w2/tan(theta))
    let w2_dot = -w1 * w2_dot_of_w2_w3;
    // w1' = w2*(w2/tan(theta) - I3*w3/I1)
    let w1_dot = w2 * w2_dot_of_w2_w3;
    // Values.
    // x' = v1
    let x_dot_value = v1;
    // y' = v2
    let y_dot_value = v2;
    // z' = v3
    let z_dot_value = v3;
    // psi' = w2/sin(theta)
    let psi_dot_value = w2_sin_theta_inv;
    // theta' = w1
    let theta_dot_value = w1;
    // phi' = w3 - w2/tan(theta)
    let phi_dot_value = w3 - w2_dot_of_w2;
    let zero = S::int(0);
    (
        [
            x_dot_value, y_dot_value, z_dot_value, psi_dot_value, theta_dot_value, phi_dot_value,
        ],
        [zero, zero, zero, w1_dot, w2_dot, zero],
    )
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 6], _u: &[S; 6]) -> [S; 1] {
    let [_, _, _, _, theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // divisor1 = sin(theta)
    let divisor1 = sin_theta;
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (v1, v2, v3, w1, w2, w3) that must act beside the loads of the model for the accelerations to be (v1', v2', v3', w1', w2', w3').
///
/// 15 operations, 1 sine and cosine.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    u: &[S; 6],
    v_dot: &[S; 6],
) -> [S; 6] {
    let Parameters { m, I1, I3 } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [_, _, _, w1, w2, w3] = *u;
    let [v1_dot, v2_dot, v3_dot, w1_dot, w2_dot, w3_dot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let tan_theta = sin_theta / cos_theta;
    // I3*w3 - I1*w2/tan(theta)
    let tau4_of_w2_w3 = I3.mul_add(w3, -I1 * w2 / tan_theta);
    // Values.
    // tau1 = m*v1'
    let tau1 = m * v1_dot;
    // tau2 = m*v2'
    let tau2 = m * v2_dot;
    // tau3 = m*v3'
    let tau3 = m * v3_dot;
    // tau4 = w2*(I3*w3 - I1*w2/tan(theta)) + I1*w1'
    let tau4 = I1.mul_add(w1_dot, w2 * tau4_of_w2_w3);
    // tau5 = w1*(I1*w2/tan(theta) - I3*w3) + I1*w2'
    let tau5 = (-w1).mul_add(tau4_of_w2_w3, I1 * w2_dot);
    // tau6 = I3*w3'
    let tau6 = I3 * w3_dot;
    [tau1, tau2, tau3, tau4, tau5, tau6]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    u: &[S; 6],
    direction: &[S; 12],
) -> [S; 12] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[6 + i],
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
            parameters: 3,
            coordinates: 6,
            variables: 6,
            speeds: 6,
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
        12
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
        ["sin(theta)"][at]
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
