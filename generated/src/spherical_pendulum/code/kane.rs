//! Spherical pendulum: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/spherical_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1, u2.
///
/// 2 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 2],
    _u: &[S; 2],
) -> [[S; 2]; 2] {
    let Parameters { m, l, .. } = *p;
    // Shared terms.
    let m_l_sq = m * l * l;
    // Entries that are not zero; upper triangle.
    // M11 = m*l^2
    let m11 = m_l_sq;
    // M22 = m*l^2
    let m22 = m_l_sq;
    let zero = S::int(0);
    [[m11, zero], [zero, m22]]
}

/// Right-hand side of the linear system; unknowns (u1', u2').
///
/// 11 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 2] {
    let Parameters { m, l, g } = *p;
    let [theta, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let tan_theta = sin_theta / cos_theta;
    let f1_of_u2 = l * u2 / tan_theta;
    let m_l = m * l;
    // Values.
    // f1 = m*l*(l*u2^2/tan(theta) - g*sin(theta))
    let f1 = m_l * (-g).mul_add(sin_theta, u2 * f1_of_u2);
    // f2 = -m*l^2*u1*u2/tan(theta)
    let f2 = -u1 * f1_of_u2 * m_l;
    [f1, f2]
}

/// The accelerations (u1', u2'), solved for when this code was generated.
///
/// 8 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 2] {
    let Parameters { l, g, .. } = *p;
    let [theta, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let tan_theta = sin_theta / cos_theta;
    let u2_dot_of_u2 = u2 / tan_theta;
    // u2' = -u1*u2/tan(theta)
    let u2_dot = -u1 * u2_dot_of_u2;
    // u1' = u2^2/tan(theta) - g*sin(theta)/l
    let u1_dot = u2.mul_add(u2_dot_of_u2, -g * sin_theta / l);
    [u1_dot, u2_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 1 operation, 1 sine and cosine.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
) -> [S; 2] {
    let [theta, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // theta' = u1
    let theta_dot_value = u1;
    // phi' = u2/sin(theta)
    let phi_dot_value = u2 / sin_theta;
    [theta_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 7 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 2], u: &[S; 2]) -> S {
    let Parameters { m, l, .. } = *p;
    let [u1, u2] = *u;
    // Values.
    // T = m*l^2*u1^2/2 + m*l^2*u2^2/2
    let energy = S::ratio(1, 2) * m * l * l * u2.mul_add(u2, u1 * u1);
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2]) -> S {
    let Parameters { m, l, g } = *p;
    let [theta, _] = *q;
    // Sines and cosines.
    let (_, cos_theta) = theta.sin_cos();
    // Values.
    // V = m*l*g*(1 - cos(theta))
    let energy = m * l * g * (S::int(1) - cos_theta);
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 8 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let Parameters { l, g, .. } = *p;
    let [theta, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let u2_sin_theta_inv = u2 / sin_theta;
    let u2_dot_of_u2 = u2_sin_theta_inv * cos_theta;
    // u2' = -u1*u2/tan(theta)
    let u2_dot = -u1 * u2_dot_of_u2;
    // u1' = u2^2/tan(theta) - g*sin(theta)/l
    let u1_dot = u2.mul_add(u2_dot_of_u2, -g * sin_theta / l);
    // Values.
    // theta' = u1
    let theta_dot_value = u1;
    // phi' = u2/sin(theta)
    let phi_dot_value = u2_sin_theta_inv;
    ([theta_dot_value, phi_dot_value], [u1_dot, u2_dot])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 2], _u: &[S; 2]) -> [S; 1] {
    let [theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // divisor1 = sin(theta)
    let divisor1 = sin_theta;
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (u1, u2) that must act beside the loads of the model for the accelerations to be (u1', u2').
///
/// 14 operations, 1 sine and cosine.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { m, l, g } = *p;
    let [theta, _] = *q;
    let [u1, u2] = *u;
    let [u1_dot, u2_dot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let m_l = m * l;
    let tan_theta = sin_theta / cos_theta;
    let tau1_of_u2 = u2 / tan_theta;
    // l*u2*tau1_of_u2 - g*sin(theta)
    let tau1_of_u2_2 = (-g).mul_add(sin_theta, l * u2 * tau1_of_u2);
    // Values.
    // tau1 = m*l*(g*sin(theta) - l*u2^2/tan(theta)) + m*l^2*u1'
    let tau1 = m_l * l.mul_add(u1_dot, -tau1_of_u2_2);
    // tau2 = m*l^2*u1*u2/tan(theta) + m*l^2*u2'
    let tau2 = l * m_l * u1.mul_add(tau1_of_u2, u2_dot);
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
            parameters: 3,
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
