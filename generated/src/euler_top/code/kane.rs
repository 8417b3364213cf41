//! Symmetric heavy top in Euler's angles: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/euler_top/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1, u2, u3.
///
/// 0 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 3],
    _u: &[S; 3],
) -> [[S; 3]; 3] {
    let Parameters { I1, I3, .. } = *p;
    // Entries that are not zero; upper triangle.
    // M11 = I1
    let m11 = I1;
    // M22 = I1
    let m22 = I1;
    // M33 = I3
    let m33 = I3;
    let zero = S::int(0);
    [[m11, zero, zero], [zero, m22, zero], [zero, zero, m33]]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3').
///
/// 11 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 3]) -> [S; 3] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [_, theta, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let tan_theta = sin_theta / cos_theta;
    // I3*u3 - I1*u2/tan(theta)
    let f1_of_u2_u3 = I3.mul_add(u3, -I1 * u2 / tan_theta);
    // Values.
    // f1 = m*l*g*sin(theta) + u2*(I1*u2/tan(theta) - I3*u3)
    let f1 = (-u2).mul_add(f1_of_u2_u3, m * l * g * sin_theta);
    // f2 = u1*(I3*u3 - I1*u2/tan(theta))
    let f2 = u1 * f1_of_u2_u3;
    let zero = S::int(0);
    [f1, f2, zero]
}

/// The accelerations (u1', u2', u3'), solved for when this code was generated.
///
/// 13 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 3]) -> [S; 3] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [_, theta, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let i1_inv = S::int(1) / I1;
    let tan_theta = sin_theta / cos_theta;
    // I3*u3*i1_inv - u2/tan(theta)
    let u2_dot_of_u2_u3 = (I3 * u3).mul_add(i1_inv, -u2 / tan_theta);
    // u2' = u1*(I3*u3/I1 - u2/tan(theta))
    let u2_dot = u1 * u2_dot_of_u2_u3;
    // u1' = (m*l*g*sin(theta) + u2*(I1*u2/tan(theta) - I3*u3))/I1
    let u1_dot = (-u2).mul_add(u2_dot_of_u2_u3, m * l * g * i1_inv * sin_theta);
    let zero = S::int(0);
    [u1_dot, u2_dot, zero]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 3],
) -> [S; 3] {
    let [_, theta, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let u2_sin_theta_inv = u2 / sin_theta;
    // Values.
    // psi' = u2/sin(theta)
    let psi_dot_value = u2_sin_theta_inv;
    // theta' = u1
    let theta_dot_value = u1;
    // phi' = u3 - u2/tan(theta)
    let phi_dot_value = (-u2_sin_theta_inv).mul_add(cos_theta, u3);
    [psi_dot_value, theta_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 8 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 3], u: &[S; 3]) -> S {
    let Parameters { I1, I3, .. } = *p;
    let [u1, u2, u3] = *u;
    // Shared terms.
    // I1*(u1^2 + u2^2) + I3*u3^2
    let energy_of_u1_u2_u3 = I1 * u2.mul_add(u2, u1 * u1) + I3 * u3 * u3;
    // Values.
    // T = I1*u1^2/2 + I1*u2^2/2 + I3*u3^2/2
    let energy = S::ratio(1, 2) * energy_of_u1_u2_u3;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3]) -> S {
    let Parameters { m, l, g, .. } = *p;
    let [_, theta, _] = *q;
    // Sines and cosines.
    let (_, cos_theta) = theta.sin_cos();
    // Values.
    // V = m*l*g*cos(theta)
    let energy = m * l * g * cos_theta;
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 14 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 3],
) -> ([S; 3], [S; 3]) {
    let Parameters { m, l, I1, I3, g } = *p;
    let [_, theta, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let i1_inv = S::int(1) / I1;
    let u2_sin_theta_inv = u2 / sin_theta;
    let u2_dot_of_u2 = u2_sin_theta_inv * cos_theta;
    // I3*u3*i1_inv - u2_dot_of_u2
    let u2_dot_of_u2_u3 = (I3 * u3).mul_add(i1_inv, -u2_dot_of_u2);
    // u2' = u1*(I3*u3/I1 - u2/tan(theta))
    let u2_dot = u1 * u2_dot_of_u2_u3;
    // u1' = (m*l*g*sin(theta) + u2*(I1*u2/tan(theta) - I3*u3))/I1
    let u1_dot = (-u2).mul_add(u2_dot_of_u2_u3, m * l * g * i1_inv * sin_theta);
    // Values.
    // psi' = u2/sin(theta)
    let psi_dot_value = u2_sin_theta_inv;
    // theta' = u1
    let theta_dot_value = u1;
    // phi' = u3 - u2/tan(theta)
    let phi_dot_value = u3 - u2_dot_of_u2;
    let zero = S::int(0);
    ([psi_dot_value, theta_dot_value, phi_dot_value], [u1_dot, u2_dot, zero])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 3], _u: &[S; 3]) -> [S; 1] {
    let [_, theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // divisor1 = sin(theta)
    let divisor1 = sin_theta;
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (u1, u2, u3) that must act beside the loads of the model for the accelerations to be (u1', u2', u3').
///
/// 16 operations, 1 sine and cosine.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 3],
    v_dot: &[S; 3],
) -> [S; 3] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [_, theta, _] = *q;
    let [u1, u2, u3] = *u;
    let [u1_dot, u2_dot, u3_dot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let tan_theta = sin_theta / cos_theta;
    // I3*u3 - I1*u2/tan(theta)
    let tau1_of_u2_u3 = I3.mul_add(u3, -I1 * u2 / tan_theta);
    // Values.
    // tau1 = u2*(I3*u3 - I1*u2/tan(theta)) - m*l*g*sin(theta) + I1*u1'
    let tau1 = (-(m * l * g)).mul_add(sin_theta, u2 * tau1_of_u2_u3) + I1 * u1_dot;
    // tau2 = u1*(I1*u2/tan(theta) - I3*u3) + I1*u2'
    let tau2 = (-u1).mul_add(tau1_of_u2_u3, I1 * u2_dot);
    // tau3 = I3*u3'
    let tau3 = I3 * u3_dot;
    [tau1, tau2, tau3]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 3],
    direction: &[S; 6],
) -> [S; 6] {
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
            parameters: 5,
            coordinates: 3,
            variables: 3,
            speeds: 3,
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
        6
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
