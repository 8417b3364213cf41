//! Symmetric rigid body free of forces: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/free_body/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows x, y, z, psi, theta, phi.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    _q_dot: &[S; 6],
) -> [[S; 6]; 6] {
    let Parameters { m, I1, I3 } = *p;
    let [_, _, _, _, theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let i3_cos_theta = I3 * cos_theta;
    // Entries that are not zero; upper triangle.
    // M11 = m
    let m11 = m;
    // M22 = m
    let m22 = m;
    // M33 = m
    let m33 = m;
    // M44 = I1*sin(theta)^2 + I3*cos(theta)^2
    let m44 = i3_cos_theta.mul_add(cos_theta, I1 * sin_theta * sin_theta);
    // M46 = I3*cos(theta)
    let m46 = i3_cos_theta;
    // M55 = I1
    let m55 = I1;
    // M66 = I3
    let m66 = I3;
    let zero = S::int(0);
    [
        [m11, zero, zero, zero, zero, zero],
        [zero, m22, zero, zero, zero, zero],
        [zero, zero, m33, zero, zero, zero],
        [zero, zero, zero, m44, zero, m46],
        [zero, zero, zero, zero, m55, zero],
        [zero, zero, zero, m46, zero, m66],
    ]
}

/// Right-hand side of the linear system; unknowns (x'', y'', z'', psi'', theta'', phi'').
///
/// 16 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 6], q_dot: &[S; 6]) -> [S; 6] {
    let Parameters { I1, I3, .. } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [_, _, _, psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let psi_dot_cos_theta = psi_dot * cos_theta;
    let f4_of_psi_dot = S::int(2) * psi_dot_cos_theta;
    let theta_dot_sin_theta = theta_dot * sin_theta;
    // Values.
    // f4 = theta'*sin(theta)*(I3*(2*psi'*cos(theta) + phi') - 2*I1*psi'*cos(theta))
    let f4 = theta_dot_sin_theta * (I3 * (phi_dot + f4_of_psi_dot) - I1 * f4_of_psi_dot);
    // f5 = psi'*sin(theta)*(I1*psi'*cos(theta) - I3*(psi'*cos(theta) + phi'))
    let f5 = psi_dot * sin_theta * (-I3 * (phi_dot + psi_dot_cos_theta) + I1 * psi_dot_cos_theta);
    // f6 = I3*psi'*theta'*sin(theta)
    let f6 = I3 * psi_dot * theta_dot_sin_theta;
    let zero = S::int(0);
    [zero, zero, zero, f4, f5, f6]
}

/// The accelerations (x'', y'', z'', psi'', theta'', phi''), solved for when this code was generated.
///
/// 14 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    q_dot: &[S; 6],
) -> [S; 6] {
    let Parameters { I1, I3, .. } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [_, _, _, psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let psi_dot_cos_theta = psi_dot * cos_theta;
    // I3*(phi' + psi_dot_cos_theta)/I1
    let psi_ddot_of_motion = I3 * (phi_dot + psi_dot_cos_theta) / I1;
    // psi'' = theta'*(I3*(psi'*cos(theta) + phi')/I1 - 2*psi'*cos(theta))/sin(theta)
    let psi_ddot = theta_dot
        * (-psi_dot_cos_theta).mul_add(S::int(2), psi_ddot_of_motion) / sin_theta;
    let psi_dot_sin_theta = psi_dot * sin_theta;
    // phi'' = psi'*theta'*sin(theta) - psi''*cos(theta)
    let phi_ddot = (-psi_ddot).mul_add(cos_theta, theta_dot * psi_dot_sin_theta);
    // theta'' = psi'*sin(theta)*(psi'*cos(theta) - I3*(psi'*cos(theta) + phi')/I1)
    let theta_ddot = psi_dot_sin_theta * (psi_dot_cos_theta - psi_ddot_of_motion);
    let zero = S::int(0);
    [zero, zero, zero, psi_ddot, theta_ddot, phi_ddot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 6],
    q_dot: &[S; 6],
) -> [S; 6] {
    let [x_dot, y_dot, z_dot, psi_dot, theta_dot, phi_dot] = *q_dot;
    // Values.
    // x'
    let x_dot_value = x_dot;
    // y'
    let y_dot_value = y_dot;
    // z'
    let z_dot_value = z_dot;
    // psi'
    let psi_dot_value = psi_dot;
    // theta'
    let theta_dot_value = theta_dot;
    // phi'
    let phi_dot_value = phi_dot;
    [
        x_dot_value, y_dot_value, z_dot_value, psi_dot_value, theta_dot_value, phi_dot_value,
    ]
}

/// Kinetic energy T.
///
/// 24 operations, 1 sine and cosine.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 6], q_dot: &[S; 6]) -> S {
    let Parameters { m, I1, I3 } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [x_dot, y_dot, z_dot, psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (_, cos_theta) = theta.sin_cos();
    // Shared terms.
    let i3_phi_dot = I3 * phi_dot;
    // x'^2 + y'^2
    let x_dot_sq_plus_y_dot_sq = y_dot.mul_add(y_dot, x_dot * x_dot);
    // psi'^2*(I1 + cos(theta)^2*(I3 - I1)) + I1*theta'^2
    let energy_of_motion = psi_dot * psi_dot * (I1 + cos_theta * cos_theta * (I3 - I1))
        + I1 * theta_dot * theta_dot;
    // phi'*i3_phi_dot + energy_of_motion
    let energy_of_motion_2 = phi_dot.mul_add(i3_phi_dot, energy_of_motion);
    // Values.
    // T = m*x'^2/2 + m*y'^2/2 + m*z'^2/2 + psi'^2*(I1*sin(theta)^2 + I3*cos(theta)^2)/2 + I1*theta'^2/2 +
    //   I3*phi'^2/2 + I3*psi'*phi'*cos(theta)
    let energy = S::ratio(1, 2) * m * z_dot.mul_add(z_dot, x_dot_sq_plus_y_dot_sq)
        + psi_dot * i3_phi_dot * cos_theta + S::ratio(1, 2) * energy_of_motion_2;
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 6],
    q_dot: &[S; 6],
) -> [S; 6] {
    let [_, _, _, _, theta, _] = *q;
    let [x_dot, y_dot, z_dot, psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Values.
    // v1 = x'
    let v1_value = x_dot;
    // v2 = y'
    let v2_value = y_dot;
    // v3 = z'
    let v3_value = z_dot;
    // w1 = theta'
    let w1_value = theta_dot;
    // w2 = psi'*sin(theta)
    let w2_value = psi_dot * sin_theta;
    // w3 = psi'*cos(theta) + phi'
    let w3_value = psi_dot.mul_add(cos_theta, phi_dot);
    [v1_value, v2_value, v3_value, w1_value, w2_value, w3_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 8 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 6],
    q_dot: &[S; 6],
    v_dot: &[S; 6],
) -> [S; 6] {
    let [_, _, _, _, theta, _] = *q;
    let [_, _, _, psi_dot, theta_dot, _] = *q_dot;
    let [x_ddot, y_ddot, z_ddot, psi_ddot, theta_ddot, phi_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let psi_dot_theta_dot = psi_dot * theta_dot;
    // Values.
    // v1' = x''
    let v1_dot_value = x_ddot;
    // v2' = y''
    let v2_dot_value = y_ddot;
    // v3' = z''
    let v3_dot_value = z_ddot;
    // w1' = theta''
    let w1_dot_value = theta_ddot;
    // w2' = psi'*theta'*cos(theta) + psi''*sin(theta)
    let w2_dot_value = psi_dot_theta_dot.mul_add(cos_theta, psi_ddot * sin_theta);
    // w3' = psi''*cos(theta) - psi'*theta'*sin(theta) + phi''
    let w3_dot_value = psi_ddot.mul_add(cos_theta, phi_ddot) - psi_dot_theta_dot * sin_theta;
    [v1_dot_value, v2_dot_value, v3_dot_value, w1_dot_value, w2_dot_value, w3_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn motion_variables<S: Scalar>(
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

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 14 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    q_dot: &[S; 6],
) -> ([S; 6], [S; 6]) {
    let Parameters { I1, I3, .. } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [x_dot, y_dot, z_dot, psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let psi_dot_cos_theta = psi_dot * cos_theta;
    // I3*(phi' + psi_dot_cos_theta)/I1
    let psi_ddot_of_motion = I3 * (phi_dot + psi_dot_cos_theta) / I1;
    // psi'' = theta'*(I3*(psi'*cos(theta) + phi')/I1 - 2*psi'*cos(theta))/sin(theta)
    let psi_ddot = theta_dot
        * (-psi_dot_cos_theta).mul_add(S::int(2), psi_ddot_of_motion) / sin_theta;
    let psi_dot_sin_theta = psi_dot * sin_theta;
    // phi'' = psi'*theta'*sin(theta) - psi''*cos(theta)
    let phi_ddot = (-psi_ddot).mul_add(cos_theta, theta_dot * psi_dot_sin_theta);
    // theta'' = psi'*sin(theta)*(psi'*cos(theta) - I3*(psi'*cos(theta) + phi')/I1)
    let theta_ddot = psi_dot_sin_theta * (psi_dot_cos_theta - psi_ddot_of_motion);
    // Values.
    // x'
    let x_dot_value = x_dot;
    // y'
    let y_dot_value = y_dot;
    // z'
    let z_dot_value = z_dot;
    // psi'
    let psi_dot_value = psi_dot;
    // theta'
    let theta_dot_value = theta_dot;
    // phi'
    let phi_dot_value = phi_dot;
    let zero = S::int(0);
    (
        [
            x_dot_value, y_dot_value, z_dot_value, psi_dot_value, theta_dot_value, phi_dot_value,
        ],
        [zero, zero, zero, psi_ddot, theta_ddot, phi_ddot],
    )
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 6], _q_dot: &[S; 6]) -> [S; 1] {
    let [_, _, _, _, theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // divisor1 = sin(theta)
    let divisor1 = sin_theta;
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (x', y', z', psi', theta', phi') that must act beside the loads of the model for the accelerations to be (x'', y'', z'', psi'', theta'', phi'').
///
/// 29 operations, 1 sine and cosine.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    q_dot: &[S; 6],
    v_dot: &[S; 6],
) -> [S; 6] {
    let Parameters { m, I1, I3 } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [_, _, _, psi_dot, theta_dot, phi_dot] = *q_dot;
    let [x_ddot, y_ddot, z_ddot, psi_ddot, theta_ddot, phi_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    // I3*(psi''*cos(theta) + phi'')
    let tau4_of_motion = I3 * psi_ddot.mul_add(cos_theta, phi_ddot);
    let i3_theta_dot = I3 * theta_dot;
    let psi_dot_sin_theta = psi_dot * sin_theta;
    // psi_dot_sin_theta*cos(theta)*(I3 - I1)
    let tau4_of_psi_dot = psi_dot_sin_theta * cos_theta * (I3 - I1);
    // Values.
    // tau1 = m*x''
    let tau1 = m * x_ddot;
    // tau2 = m*y''
    let tau2 = m * y_ddot;
    // tau3 = m*z''
    let tau3 = m * z_ddot;
    // tau4 = theta'*sin(theta)*(2*I1*psi'*cos(theta) - I3*(2*psi'*cos(theta) + phi')) +
    //   psi''*(I1*sin(theta)^2 + I3*cos(theta)^2) + I3*phi''*cos(theta)
    let tau4 = sin_theta * (-phi_dot).mul_add(i3_theta_dot, I1 * psi_ddot * sin_theta)
        + tau4_of_motion * cos_theta - S::int(2) * theta_dot * tau4_of_psi_dot;
    // tau5 = psi'*sin(theta)*(I3*(psi'*cos(theta) + phi') - I1*psi'*cos(theta)) + I1*theta''
    let tau5 = (I3 * phi_dot).mul_add(psi_dot_sin_theta, I1 * theta_ddot)
        + psi_dot * tau4_of_psi_dot;
    // tau6 = I3*psi''*cos(theta) - I3*psi'*theta'*sin(theta) + I3*phi''
    let tau6 = (-i3_theta_dot).mul_add(psi_dot_sin_theta, tau4_of_motion);
    [tau1, tau2, tau3, tau4, tau5, tau6]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    q_dot: &[S; 6],
    direction: &[S; 12],
) -> [S; 12] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: q_dot[i],
        slope: direction[6 + i],
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
