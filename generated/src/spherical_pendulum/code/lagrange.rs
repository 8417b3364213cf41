//! Spherical pendulum: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/spherical_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows theta, phi.
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _q_dot: &[S; 2],
) -> [[S; 2]; 2] {
    let Parameters { m, l, .. } = *p;
    let [theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Shared terms.
    let m_l_sq = m * l * l;
    // Entries that are not zero; upper triangle.
    // M11 = m*l^2
    let m11 = m_l_sq;
    // M22 = m*l^2*sin(theta)^2
    let m22 = m_l_sq * sin_theta * sin_theta;
    let zero = S::int(0);
    [[m11, zero], [zero, m22]]
}

/// Right-hand side of the linear system; unknowns (theta'', phi'').
///
/// 11 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> [S; 2] {
    let Parameters { m, l, g } = *p;
    let [theta, _] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let l_phi_dot_cos_theta = l * phi_dot * cos_theta;
    let m_l_sin_theta = m * l * sin_theta;
    // Values.
    // f1 = m*l*sin(theta)*(l*phi'^2*cos(theta) - g)
    let f1 = m_l_sin_theta * phi_dot.mul_add(l_phi_dot_cos_theta, -g);
    // f2 = -2*m*l^2*theta'*phi'*sin(theta)*cos(theta)
    let f2 = -S::int(2) * theta_dot * l_phi_dot_cos_theta * m_l_sin_theta;
    [f1, f2]
}

/// The accelerations (theta'', phi''), solved for when this code was generated.
///
/// 9 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { l, g, .. } = *p;
    let [theta, _] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let phi_dot_cos_theta = phi_dot * cos_theta;
    // phi'' = -2*theta'*phi'/tan(theta)
    let phi_ddot = -S::int(2) * theta_dot * phi_dot_cos_theta / sin_theta;
    // theta'' = sin(theta)*(phi'^2*cos(theta) - g/l)
    let theta_ddot = sin_theta * phi_dot.mul_add(phi_dot_cos_theta, -g / l);
    [theta_ddot, phi_ddot]
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
    let [theta_dot, phi_dot] = *q_dot;
    // Values.
    // theta'
    let theta_dot_value = theta_dot;
    // phi'
    let phi_dot_value = phi_dot;
    [theta_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 8 operations, 1 sine and cosine.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> S {
    let Parameters { m, l, .. } = *p;
    let [theta, _] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Shared terms.
    let phi_dot_sin_theta = phi_dot * sin_theta;
    // Values.
    // T = m*l^2*theta'^2/2 + m*l^2*phi'^2*sin(theta)^2/2
    let energy = S::ratio(1, 2) * m * l * l
        * phi_dot_sin_theta.mul_add(phi_dot_sin_theta, theta_dot * theta_dot);
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 1 operation, 1 sine and cosine.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let [theta, _] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // u1 = theta'
    let u1_value = theta_dot;
    // u2 = phi'*sin(theta)
    let u2_value = phi_dot * sin_theta;
    [u1_value, u2_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let [theta, _] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    let [theta_ddot, phi_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Values.
    // u1' = theta''
    let u1_dot_value = theta_ddot;
    // u2' = theta'*phi'*cos(theta) + phi''*sin(theta)
    let u2_dot_value = phi_ddot.mul_add(sin_theta, theta_dot * phi_dot * cos_theta);
    [u1_dot_value, u2_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 1 operation, 1 sine and cosine.
#[must_use]
pub fn motion_variables<S: Scalar>(
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

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 9 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let Parameters { l, g, .. } = *p;
    let [theta, _] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let phi_dot_cos_theta = phi_dot * cos_theta;
    // phi'' = -2*theta'*phi'/tan(theta)
    let phi_ddot = -S::int(2) * theta_dot * phi_dot_cos_theta / sin_theta;
    // theta'' = sin(theta)*(phi'^2*cos(theta) - g/l)
    let theta_ddot = sin_theta * phi_dot.mul_add(phi_dot_cos_theta, -g / l);
    // Values.
    // theta'
    let theta_dot_value = theta_dot;
    // phi'
    let phi_dot_value = phi_dot;
    ([theta_dot_value, phi_dot_value], [theta_ddot, phi_ddot])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 2], _q_dot: &[S; 2]) -> [S; 1] {
    let [theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // divisor1 = sin(theta)
    let divisor1 = sin_theta;
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (theta', phi') that must act beside the loads of the model for the accelerations to be (theta'', phi'').
///
/// 16 operations, 1 sine and cosine.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { m, l, g } = *p;
    let [theta, _] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    let [theta_ddot, phi_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let m_l = m * l;
    let phi_dot_cos_theta = phi_dot * cos_theta;
    // Values.
    // tau1 = m*l*sin(theta)*(g - l*phi'^2*cos(theta)) + m*l^2*theta''
    let tau1 = m_l * (sin_theta * (-(l * phi_dot)).mul_add(phi_dot_cos_theta, g) + l * theta_ddot);
    // tau2 = 2*m*l^2*theta'*phi'*sin(theta)*cos(theta) + m*l^2*phi''*sin(theta)^2
    let tau2 = l * m_l * sin_theta
        * (theta_dot * phi_dot_cos_theta).mul_add(S::int(2), phi_ddot * sin_theta);
    [tau1, tau2]
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
