//! Symmetric heavy top about a fixed point: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/heavy_top/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows q1, q2, q3.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    _q_dot: &[S; 3],
) -> [[S; 3]; 3] {
    let Parameters { I1, I3, .. } = *p;
    let [_, q2, _] = *q;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    let i3_s2 = I3 * s2;
    // Entries that are not zero; upper triangle.
    // M11 = I3*sin(q2)^2 + I1*cos(q2)^2
    let m11 = i3_s2.mul_add(s2, I1 * c2 * c2);
    // M13 = I3*sin(q2)
    let m13 = i3_s2;
    // M22 = I1
    let m22 = I1;
    // M33 = I3
    let m33 = I3;
    let zero = S::int(0);
    [[m11, zero, m13], [zero, m22, zero], [m13, zero, m33]]
}

/// Right-hand side of the linear system; unknowns (q1'', q2'', q3'').
///
/// 23 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], q_dot: &[S; 3]) -> [S; 3] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [q1, q2, _] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let q1_dot_c2 = q1_dot * c2;
    // q1_dot_c2*sin(q2)*(I3 - I1)
    let f1_of_q1_dot = q1_dot_c2 * s2 * (I3 - I1);
    let i3_q2_dot = I3 * q2_dot;
    let m_l_g = m * l * g;
    // Values.
    // f1 = cos(q2)*(m*l*g*sin(q1) - q2'*(I3*(2*q1'*sin(q2) + q3') - 2*I1*q1'*sin(q2)))
    let f1 = c2 * (-q3_dot).mul_add(i3_q2_dot, m_l_g * s1) - S::int(2) * q2_dot * f1_of_q1_dot;
    // f2 = m*l*g*cos(q1)*sin(q2) + q1'*cos(q2)*(I3*(q1'*sin(q2) + q3') - I1*q1'*sin(q2))
    let f2 = q1_dot.mul_add(f1_of_q1_dot, I3 * q3_dot * q1_dot_c2) + m_l_g * c1 * s2;
    // f3 = -I3*q1'*q2'*cos(q2)
    let f3 = -q1_dot_c2 * i3_q2_dot;
    [f1, f2, f3]
}

/// The accelerations (q1'', q2'', q3''), solved for when this code was generated.
///
/// 25 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 3] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [q1, q2, _] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let q1_dot_s2 = q1_dot * s2;
    // I3*(q3' + q1_dot_s2)
    let q1_ddot_of_motion = I3 * (q3_dot + q1_dot_s2);
    let i1_q1_dot_s2 = I1 * q1_dot_s2;
    let m_l_g = m * l * g;
    let i1_inv = S::int(1) / I1;
    // q1'' = (m*l*g*sin(q1) + q2'*(2*I1*q1'*sin(q2) - I3*(q1'*sin(q2) + q3')))/(I1*cos(q2))
    let q1_ddot = i1_inv
        * (-q2_dot * (-i1_q1_dot_s2).mul_add(S::int(2), q1_ddot_of_motion) + m_l_g * s1) / c2;
    let q1_dot_c2 = q1_dot * c2;
    // q3'' = -q1'*q2'*cos(q2) - q1''*sin(q2)
    let q3_ddot = (-q2_dot).mul_add(q1_dot_c2, -q1_ddot * s2);
    // q2'' = (m*l*g*cos(q1)*sin(q2) + q1'*cos(q2)*(I3*(q1'*sin(q2) + q3') - I1*q1'*sin(q2)))/I1
    let q2_ddot = i1_inv * (q1_dot_c2 * (q1_ddot_of_motion - i1_q1_dot_s2) + m_l_g * c1 * s2);
    [q1_ddot, q2_ddot, q3_ddot]
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
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Values.
    // q1'
    let q1_dot_value = q1_dot;
    // q2'
    let q2_dot_value = q2_dot;
    // q3'
    let q3_dot_value = q3_dot;
    [q1_dot_value, q2_dot_value, q3_dot_value]
}

/// Kinetic energy T.
///
/// 16 operations, 1 sine and cosine.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3], q_dot: &[S; 3]) -> S {
    let Parameters { I1, I3, .. } = *p;
    let [_, q2, _] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    let i3_q3_dot = I3 * q3_dot;
    // q1'^2*(I3 + cos(q2)^2*(I1 - I3)) + I1*q2'^2
    let energy_of_motion = q1_dot * q1_dot * (I3 + c2 * c2 * (I1 - I3)) + I1 * q2_dot * q2_dot;
    // q3'*i3_q3_dot + energy_of_motion
    let energy_of_motion_2 = q3_dot.mul_add(i3_q3_dot, energy_of_motion);
    // Values.
    // T = q1'^2*(I3*sin(q2)^2 + I1*cos(q2)^2)/2 + I1*q2'^2/2 + I3*q3'^2/2 + I3*q1'*q3'*sin(q2)
    let energy = (q1_dot * i3_q3_dot).mul_add(s2, S::ratio(1, 2) * energy_of_motion_2);
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
    let [_, q2, _] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Values.
    // u1 = q1'*cos(q2)
    let u1_value = q1_dot * c2;
    // u2 = q2'
    let u2_value = q2_dot;
    // u3 = q1'*sin(q2) + q3'
    let u3_value = q1_dot.mul_add(s2, q3_dot);
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
    let [_, q2, _] = *q;
    let [q1_dot, q2_dot, _] = *q_dot;
    let [q1_ddot, q2_ddot, q3_ddot] = *v_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    let q1_dot_q2_dot = q1_dot * q2_dot;
    // Values.
    // u1' = q1''*cos(q2) - q1'*q2'*sin(q2)
    let u1_dot_value = (-q1_dot_q2_dot).mul_add(s2, q1_ddot * c2);
    // u2' = q2''
    let u2_dot_value = q2_ddot;
    // u3' = q1'*q2'*cos(q2) + q1''*sin(q2) + q3''
    let u3_dot_value = q1_ddot.mul_add(s2, q3_ddot) + q1_dot_q2_dot * c2;
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
    let [_, q2, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    let u1_c2_inv = u1 / c2;
    // Values.
    // q1' = u1/cos(q2)
    let q1_dot_value = u1_c2_inv;
    // q2' = u2
    let q2_dot_value = u2;
    // q3' = u3 - u1*tan(q2)
    let q3_dot_value = (-u1_c2_inv).mul_add(s2, u3);
    [q1_dot_value, q2_dot_value, q3_dot_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 25 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> ([S; 3], [S; 3]) {
    let Parameters { m, l, I1, I3, g } = *p;
    let [q1, q2, _] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let q1_dot_s2 = q1_dot * s2;
    // I3*(q3' + q1_dot_s2)
    let q1_ddot_of_motion = I3 * (q3_dot + q1_dot_s2);
    let i1_q1_dot_s2 = I1 * q1_dot_s2;
    let m_l_g = m * l * g;
    let i1_inv = S::int(1) / I1;
    // q1'' = (m*l*g*sin(q1) + q2'*(2*I1*q1'*sin(q2) - I3*(q1'*sin(q2) + q3')))/(I1*cos(q2))
    let q1_ddot = i1_inv
        * (-q2_dot * (-i1_q1_dot_s2).mul_add(S::int(2), q1_ddot_of_motion) + m_l_g * s1) / c2;
    let q1_dot_c2 = q1_dot * c2;
    // q3'' = -q1'*q2'*cos(q2) - q1''*sin(q2)
    let q3_ddot = (-q2_dot).mul_add(q1_dot_c2, -q1_ddot * s2);
    // q2'' = (m*l*g*cos(q1)*sin(q2) + q1'*cos(q2)*(I3*(q1'*sin(q2) + q3') - I1*q1'*sin(q2)))/I1
    let q2_ddot = i1_inv * (q1_dot_c2 * (q1_ddot_of_motion - i1_q1_dot_s2) + m_l_g * c1 * s2);
    // Values.
    // q1'
    let q1_dot_value = q1_dot;
    // q2'
    let q2_dot_value = q2_dot;
    // q3'
    let q3_dot_value = q3_dot;
    ([q1_dot_value, q2_dot_value, q3_dot_value], [q1_ddot, q2_ddot, q3_ddot])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 3], _q_dot: &[S; 3]) -> [S; 1] {
    let [_, q2, _] = *q;
    // Sines and cosines.
    let (_, c2) = q2.sin_cos();
    // Values.
    // divisor1 = cos(q2)
    let divisor1 = c2;
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (q1', q2', q3') that must act beside the loads of the model for the accelerations to be (q1'', q2'', q3'').
///
/// 33 operations, 2 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
    v_dot: &[S; 3],
) -> [S; 3] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [q1, q2, _] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    let [q1_ddot, q2_ddot, q3_ddot] = *v_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    // I3*(q1''*sin(q2) + q3'')
    let tau1_of_motion = I3 * q1_ddot.mul_add(s2, q3_ddot);
    let q1_dot_c2 = q1_dot * c2;
    // q1_dot_c2*sin(q2)*(I3 - I1)
    let tau1_of_q1_dot = q1_dot_c2 * s2 * (I3 - I1);
    let m_l_g = m * l * g;
    let i3_q2_dot = I3 * q2_dot;
    // I1*q1''*cos(q2) + q3'*i3_q2_dot
    let tau1_of_motion_2 = q3_dot.mul_add(i3_q2_dot, I1 * q1_ddot * c2);
    // Values.
    // tau1 = cos(q2)*(q2'*(I3*(2*q1'*sin(q2) + q3') - 2*I1*q1'*sin(q2)) - m*l*g*sin(q1)) +
    //   q1''*(I3*sin(q2)^2 + I1*cos(q2)^2) + I3*q3''*sin(q2)
    let tau1 = tau1_of_motion * s2 + S::int(2) * q2_dot * tau1_of_q1_dot
        + c2 * (-m_l_g).mul_add(s1, tau1_of_motion_2);
    // tau2 = q1'*cos(q2)*(I1*q1'*sin(q2) - I3*(q1'*sin(q2) + q3')) - m*l*g*cos(q1)*sin(q2) + I1*q2''
    let tau2 = (-(I3 * q3_dot)).mul_add(q1_dot_c2, I1 * q2_ddot)
        - q1_dot * tau1_of_q1_dot - m_l_g * c1 * s2;
    // tau3 = I3*q1'*q2'*cos(q2) + I3*q1''*sin(q2) + I3*q3''
    let tau3 = q1_dot_c2.mul_add(i3_q2_dot, tau1_of_motion);
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
        ["cos(q2)"][at]
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
