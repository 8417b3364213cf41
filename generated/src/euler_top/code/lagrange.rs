//! Symmetric heavy top in Euler's angles: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/euler_top/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows psi, theta, phi.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    _q_dot: &[S; 3],
) -> [[S; 3]; 3] {
    let Parameters { I1, I3, .. } = *p;
    let [_, theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let i3_cos_theta = I3 * cos_theta;
    // Entries that are not zero; upper triangle.
    // M11 = I1*sin(theta)^2 + I3*cos(theta)^2
    let m11 = i3_cos_theta.mul_add(cos_theta, I1 * sin_theta * sin_theta);
    // M13 = I3*cos(theta)
    let m13 = i3_cos_theta;
    // M22 = I1
    let m22 = I1;
    // M33 = I3
    let m33 = I3;
    let zero = S::int(0);
    [[m11, zero, m13], [zero, m22, zero], [m13, zero, m33]]
}

/// Right-hand side of the linear system; unknowns (psi'', theta'', phi'').
///
/// 19 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], q_dot: &[S; 3]) -> [S; 3] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [_, theta, _] = *q;
    let [psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let psi_dot_cos_theta = psi_dot * cos_theta;
    let f1_of_psi_dot = S::int(2) * psi_dot_cos_theta;
    let theta_dot_sin_theta = theta_dot * sin_theta;
    // Values.
    // f1 = theta'*sin(theta)*(I3*(2*psi'*cos(theta) + phi') - 2*I1*psi'*cos(theta))
    let f1 = theta_dot_sin_theta * (I3 * (phi_dot + f1_of_psi_dot) - I1 * f1_of_psi_dot);
    // f2 = sin(theta)*(m*l*g - psi'*(I3*(psi'*cos(theta) + phi') - I1*psi'*cos(theta)))
    let f2 = sin_theta
        * (psi_dot * (-I3 * (phi_dot + psi_dot_cos_theta) + I1 * psi_dot_cos_theta) + m * l * g);
    // f3 = I3*psi'*theta'*sin(theta)
    let f3 = I3 * psi_dot * theta_dot_sin_theta;
    [f1, f2, f3]
}

/// The accelerations (psi'', theta'', phi''), solved for when this code was generated.
///
/// 20 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 3] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [_, theta, _] = *q;
    let [psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let psi_dot_cos_theta = psi_dot * cos_theta;
    let i1_inv = S::int(1) / I1;
    // I3*i1_inv*(phi' + psi_dot_cos_theta)
    let psi_ddot_of_motion = I3 * i1_inv * (phi_dot + psi_dot_cos_theta);
    // psi'' = theta'*(I3*(psi'*cos(theta) + phi')/I1 - 2*psi'*cos(theta))/sin(theta)
    let psi_ddot = theta_dot
        * (-psi_dot_cos_theta).mul_add(S::int(2), psi_ddot_of_motion) / sin_theta;
    let psi_dot_sin_theta = psi_dot * sin_theta;
    // phi'' = psi'*theta'*sin(theta) - psi''*cos(theta)
    let phi_ddot = (-psi_ddot).mul_add(cos_theta, theta_dot * psi_dot_sin_theta);
    // theta'' = sin(theta)*(m*l*g - psi'*(I3*(psi'*cos(theta) + phi') - I1*psi'*cos(theta)))/I1
    let theta_ddot = psi_dot_sin_theta * (psi_dot_cos_theta - psi_ddot_of_motion)
        + m * l * g * i1_inv * sin_theta;
    [psi_ddot, theta_ddot, phi_ddot]
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
    let [psi_dot, theta_dot, phi_dot] = *q_dot;
    // Values.
    // psi'
    let psi_dot_value = psi_dot;
    // theta'
    let theta_dot_value = theta_dot;
    // phi'
    let phi_dot_value = phi_dot;
    [psi_dot_value, theta_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 16 operations, 1 sine and cosine.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3], q_dot: &[S; 3]) -> S {
    let Parameters { I1, I3, .. } = *p;
    let [_, theta, _] = *q;
    let [psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (_, cos_theta) = theta.sin_cos();
    // Shared terms.
    let i3_phi_dot = I3 * phi_dot;
    // psi'^2*(I1 + cos(theta)^2*(I3 - I1)) + I1*theta'^2
    let energy_of_motion = psi_dot * psi_dot * (I1 + cos_theta * cos_theta * (I3 - I1))
        + I1 * theta_dot * theta_dot;
    // phi'*i3_phi_dot + energy_of_motion
    let energy_of_motion_2 = phi_dot.mul_add(i3_phi_dot, energy_of_motion);
    // Values.
    // T = psi'^2*(I1*sin(theta)^2 + I3*cos(theta)^2)/2 + I1*theta'^2/2 + I3*phi'^2/2 +
    //   I3*psi'*phi'*cos(theta)
    let energy = (psi_dot * i3_phi_dot)
        .mul_add(cos_theta, S::ratio(1, 2) * energy_of_motion_2);
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
) -> [S; 3] {
    let [_, theta, _] = *q;
    let [psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Values.
    // u1 = theta'
    let u1_value = theta_dot;
    // u2 = psi'*sin(theta)
    let u2_value = psi_dot * sin_theta;
    // u3 = psi'*cos(theta) + phi'
    let u3_value = psi_dot.mul_add(cos_theta, phi_dot);
    [u1_value, u2_value, u3_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 8 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
    v_dot: &[S; 3],
) -> [S; 3] {
    let [_, theta, _] = *q;
    let [psi_dot, theta_dot, _] = *q_dot;
    let [psi_ddot, theta_ddot, phi_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let psi_dot_theta_dot = psi_dot * theta_dot;
    // Values.
    // u1' = theta''
    let u1_dot_value = theta_ddot;
    // u2' = psi'*theta'*cos(theta) + psi''*sin(theta)
    let u2_dot_value = psi_dot_theta_dot.mul_add(cos_theta, psi_ddot * sin_theta);
    // u3' = psi''*cos(theta) - psi'*theta'*sin(theta) + phi''
    let u3_dot_value = psi_ddot.mul_add(cos_theta, phi_ddot) - psi_dot_theta_dot * sin_theta;
    [u1_dot_value, u2_dot_value, u3_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn motion_variables<S: Scalar>(
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

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 20 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> ([S; 3], [S; 3]) {
    let Parameters { m, l, I1, I3, g } = *p;
    let [_, theta, _] = *q;
    let [psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let psi_dot_cos_theta = psi_dot * cos_theta;
    let i1_inv = S::int(1) / I1;
    // I3*i1_inv*(phi' + psi_dot_cos_theta)
    let psi_ddot_of_motion = I3 * i1_inv * (phi_dot + psi_dot_cos_theta);
    // psi'' = theta'*(I3*(psi'*cos(theta) + phi')/I1 - 2*psi'*cos(theta))/sin(theta)
    let psi_ddot = theta_dot
        * (-psi_dot_cos_theta).mul_add(S::int(2), psi_ddot_of_motion) / sin_theta;
    let psi_dot_sin_theta = psi_dot * sin_theta;
    // phi'' = psi'*theta'*sin(theta) - psi''*cos(theta)
    let phi_ddot = (-psi_ddot).mul_add(cos_theta, theta_dot * psi_dot_sin_theta);
    // theta'' = sin(theta)*(m*l*g - psi'*(I3*(psi'*cos(theta) + phi') - I1*psi'*cos(theta)))/I1
    let theta_ddot = psi_dot_sin_theta * (psi_dot_cos_theta - psi_ddot_of_motion)
        + m * l * g * i1_inv * sin_theta;
    // Values.
    // psi'
    let psi_dot_value = psi_dot;
    // theta'
    let theta_dot_value = theta_dot;
    // phi'
    let phi_dot_value = phi_dot;
    ([psi_dot_value, theta_dot_value, phi_dot_value], [psi_ddot, theta_ddot, phi_ddot])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 3], _q_dot: &[S; 3]) -> [S; 1] {
    let [_, theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // divisor1 = sin(theta)
    let divisor1 = sin_theta;
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (psi', theta', phi') that must act beside the loads of the model for the accelerations to be (psi'', theta'', phi'').
///
/// 30 operations, 1 sine and cosine.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
    v_dot: &[S; 3],
) -> [S; 3] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [_, theta, _] = *q;
    let [psi_dot, theta_dot, phi_dot] = *q_dot;
    let [psi_ddot, theta_ddot, phi_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    // I3*(psi''*cos(theta) + phi'')
    let tau1_of_motion = I3 * psi_ddot.mul_add(cos_theta, phi_ddot);
    let i3_theta_dot = I3 * theta_dot;
    let psi_dot_sin_theta = psi_dot * sin_theta;
    // psi_dot_sin_theta*cos(theta)*(I3 - I1)
    let tau1_of_psi_dot = psi_dot_sin_theta * cos_theta * (I3 - I1);
    // Values.
    // tau1 = theta'*sin(theta)*(2*I1*psi'*cos(theta) - I3*(2*psi'*cos(theta) + phi')) +
    //   psi''*(I1*sin(theta)^2 + I3*cos(theta)^2) + I3*phi''*cos(theta)
    let tau1 = sin_theta * (-phi_dot).mul_add(i3_theta_dot, I1 * psi_ddot * sin_theta)
        + tau1_of_motion * cos_theta - S::int(2) * theta_dot * tau1_of_psi_dot;
    // tau2 = sin(theta)*(psi'*(I3*(psi'*cos(theta) + phi') - I1*psi'*cos(theta)) - m*l*g) + I1*theta''
    let tau2 = (-(m * l * g)).mul_add(sin_theta, I1 * theta_ddot)
        + I3 * phi_dot * psi_dot_sin_theta + psi_dot * tau1_of_psi_dot;
    // tau3 = I3*psi''*cos(theta) - I3*psi'*theta'*sin(theta) + I3*phi''
    let tau3 = (-i3_theta_dot).mul_add(psi_dot_sin_theta, tau1_of_motion);
    [tau1, tau2, tau3]
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
