//! Furuta pendulum: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/furuta/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows theta1, theta2.
///
/// 14 operations, 1 sine and cosine.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _q_dot: &[S; 2],
) -> [[S; 2]; 2] {
    let Parameters { L1, l1, m1, J1, l2, m2, J2, .. } = *p;
    let [_, theta2] = *q;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Shared terms.
    // l2^2*m2 + J2
    let j2_plus_l2_sq_m2 = l2 * l2 * m2 + J2;
    let l1_m2 = L1 * m2;
    // Entries that are not zero; upper triangle.
    // M11 = l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(L1^2 + l2^2*sin(theta2)^2)
    let m11 = L1
        .mul_add(l1_m2, l1 * l1 * m1 + J1 + j2_plus_l2_sq_m2 * sin_theta2 * sin_theta2);
    // M12 = L1*l2*m2*cos(theta2)
    let m12 = l2 * l1_m2 * cos_theta2;
    // M22 = l2^2*m2 + J2
    let m22 = j2_plus_l2_sq_m2;
    [[m11, m12], [m12, m22]]
}

/// Right-hand side of the linear system; unknowns (theta1'', theta2'').
///
/// 20 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> [S; 2] {
    let Parameters { L1, l2, m2, J2, b1, b2, g, tau, .. } = *p;
    let [_, theta2] = *q;
    let [theta1_dot, theta2_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Shared terms.
    let l2_m2 = l2 * m2;
    // theta1'*cos(theta2)*(J2 + l2*l2_m2)
    let f1_of_theta1_dot = theta1_dot * cos_theta2 * l2.mul_add(l2_m2, J2);
    // Values.
    // f1 = tau + L1*l2*m2*theta2'^2*sin(theta2) - theta1'*(b1 + 2*theta2'*sin(theta2)*cos(theta2)*(l2^2*m2
    //   + J2))
    let f1 = tau - b1 * theta1_dot
        + theta2_dot * sin_theta2 * (-f1_of_theta1_dot).mul_add(S::int(2), L1 * theta2_dot * l2_m2);
    // f2 = sin(theta2)*(J2*theta1'^2*cos(theta2) - l2*m2*(g - l2*theta1'^2*cos(theta2))) - b2*theta2'
    let f2 = sin_theta2 * (-g).mul_add(l2_m2, theta1_dot * f1_of_theta1_dot) - b2 * theta2_dot;
    [f1, f2]
}

/// The accelerations (theta1'', theta2''), solved for when this code was generated.
///
/// 47 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { L1, l1, m1, J1, l2, m2, J2, b1, b2, g, tau } = *p;
    let [_, theta2] = *q;
    let [theta1_dot, theta2_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let l2_m2 = l2 * m2;
    let l2_l2_m2 = l2 * l2_m2;
    // J2 + l2_l2_m2
    let j2_plus_l2_l2_m2 = J2 + l2_l2_m2;
    let j2_plus_l2_l2_m2_inv = S::int(1) / j2_plus_l2_l2_m2;
    let theta1_ddot_of_place = j2_plus_l2_l2_m2_inv * cos_theta2;
    let l2_sin_theta2 = l2 * sin_theta2;
    let theta1_ddot_of_place_2 = j2_plus_l2_l2_m2 * cos_theta2;
    // b2*theta2' + sin(theta2)*(g*l2_m2 - theta1'^2*theta1_ddot_of_place_2)
    let theta1_ddot_of_motion = sin_theta2
        * g.mul_add(l2_m2, -theta1_dot * theta1_dot * theta1_ddot_of_place_2) + b2 * theta2_dot;
    let theta2_dot_sin_theta2 = theta2_dot * sin_theta2;
    let l1_l2_m2 = L1 * l2_m2;
    // theta1'*(b1 + 2*theta1_ddot_of_place_2*theta2_dot_sin_theta2) - tau
    let theta1_ddot_of_motion_2 = theta1_dot
        * (theta1_ddot_of_place_2 * theta2_dot_sin_theta2).mul_add(S::int(2), b1) - tau;
    // theta1'' = (tau + L1*l2*m2*theta2'^2*sin(theta2) - theta1'*(b1 +
    //   2*theta2'*sin(theta2)*cos(theta2)*(l2^2*m2 + J2)) + L1*l2*m2*cos(theta2)*(sin(theta2)*(l2*m2*(g -
    //   l2*theta1'^2*cos(theta2)) - J2*theta1'^2*cos(theta2)) + b2*theta2')/(l2^2*m2 + J2))/(l1^2*m1 + J1 +
    //   J2*sin(theta2)^2 + m2*(l2^2*sin(theta2)^2 + L1^2*(1 - l2^2*m2*cos(theta2)^2/(l2^2*m2 + J2))))
    let theta1_ddot = (l1_l2_m2
        * theta2_dot
            .mul_add(theta2_dot_sin_theta2, theta1_ddot_of_place * theta1_ddot_of_motion)
        - theta1_ddot_of_motion_2)
        / (l1 * l1 * m1 + J1 + J2 * sin_theta2 * sin_theta2
            + m2
                * (-L1 * L1 * (l2_l2_m2 * theta1_ddot_of_place).mul_add(cos_theta2, -S::int(1))
                    + l2_sin_theta2 * l2_sin_theta2));
    // theta2'' = (J2*theta1'^2*sin(theta2)*cos(theta2) - b2*theta2' - l2*m2*(sin(theta2)*(g -
    //   l2*theta1'^2*cos(theta2)) + L1*theta1''*cos(theta2)))/(l2^2*m2 + J2)
    let theta2_ddot = (-(theta1_ddot * theta1_ddot_of_place))
        .mul_add(l1_l2_m2, -j2_plus_l2_l2_m2_inv * theta1_ddot_of_motion);
    [theta1_ddot, theta2_ddot]
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
    let [theta1_dot, theta2_dot] = *q_dot;
    // Values.
    // theta1'
    let theta1_dot_value = theta1_dot;
    // theta2'
    let theta2_dot_value = theta2_dot;
    [theta1_dot_value, theta2_dot_value]
}

/// Kinetic energy T.
///
/// 24 operations, 1 sine and cosine.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> S {
    let Parameters { L1, l1, m1, J1, l2, m2, J2, .. } = *p;
    let [_, theta2] = *q;
    let [theta1_dot, theta2_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Shared terms.
    // l2^2*m2 + J2
    let j2_plus_l2_sq_m2 = l2 * l2 * m2 + J2;
    let theta1_dot_sq_halved = S::ratio(1, 2) * theta1_dot * theta1_dot;
    // l1^2*m1 + J1
    let j1_plus_l1_sq_m1 = l1 * l1 * m1 + J1;
    // Values.
    // T = theta1'^2*(l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(L1^2 + l2^2*sin(theta2)^2))/2 +
    //   theta2'^2*(l2^2*m2 + J2)/2 + L1*l2*m2*theta1'*theta2'*cos(theta2)
    let energy = S::ratio(1, 2) * theta2_dot * theta2_dot * j2_plus_l2_sq_m2
        + L1 * m2 * L1.mul_add(theta1_dot_sq_halved, l2 * theta1_dot * theta2_dot * cos_theta2)
        + theta1_dot_sq_halved * (j2_plus_l2_sq_m2 * sin_theta2 * sin_theta2 + j1_plus_l1_sq_m1);
    energy
}

/// The power of the loads that have no potential: the rate of T + V.
///
/// 6 operations.
#[must_use]
pub fn power<S: Scalar>(p: &Parameters<S>, _q: &[S; 2], q_dot: &[S; 2]) -> S {
    let Parameters { b1, b2, .. } = *p;
    let [theta1_dot, theta2_dot] = *q_dot;
    // Values.
    // d(T + V)/dt = -b1*theta1'^2 - b2*theta2'^2
    let rate = -b1 * theta1_dot * theta1_dot - b2 * theta2_dot * theta2_dot;
    rate
}

/// The generalized speeds u, from q and q'.
///
/// 0 operations.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let [theta1_dot, theta2_dot] = *q_dot;
    // Values.
    // u_theta1 = theta1'
    let u_theta1_value = theta1_dot;
    // u_theta2 = theta2'
    let u_theta2_value = theta2_dot;
    [u_theta1_value, u_theta2_value]
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
) -> [S; 2] {
    let [theta1_ddot, theta2_ddot] = *v_dot;
    // Values.
    // u_theta1' = theta1''
    let u_theta1_dot_value = theta1_ddot;
    // u_theta2' = theta2''
    let u_theta2_dot_value = theta2_ddot;
    [u_theta1_dot_value, u_theta2_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 0 operations.
#[must_use]
pub fn motion_variables<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    u: &[S; 2],
) -> [S; 2] {
    let [u_theta1, u_theta2] = *u;
    // Values.
    // theta1' = u_theta1
    let theta1_dot_value = u_theta1;
    // theta2' = u_theta2
    let theta2_dot_value = u_theta2;
    [theta1_dot_value, theta2_dot_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 47 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let Parameters { L1, l1, m1, J1, l2, m2, J2, b1, b2, g, tau } = *p;
    let [_, theta2] = *q;
    let [theta1_dot, theta2_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let l2_m2 = l2 * m2;
    let l2_l2_m2 = l2 * l2_m2;
    // J2 + l2_l2_m2
    let j2_plus_l2_l2_m2 = J2 + l2_l2_m2;
    let j2_plus_l2_l2_m2_inv = S::int(1) / j2_plus_l2_l2_m2;
    let theta1_ddot_of_place = j2_plus_l2_l2_m2_inv * cos_theta2;
    let l2_sin_theta2 = l2 * sin_theta2;
    let theta1_ddot_of_place_2 = j2_plus_l2_l2_m2 * cos_theta2;
    // b2*theta2' + sin(theta2)*(g*l2_m2 - theta1'^2*theta1_ddot_of_place_2)
    let theta1_ddot_of_motion = sin_theta2
        * g.mul_add(l2_m2, -theta1_dot * theta1_dot * theta1_ddot_of_place_2) + b2 * theta2_dot;
    let theta2_dot_sin_theta2 = theta2_dot * sin_theta2;
    let l1_l2_m2 = L1 * l2_m2;
    // theta1'*(b1 + 2*theta1_ddot_of_place_2*theta2_dot_sin_theta2) - tau
    let theta1_ddot_of_motion_2 = theta1_dot
        * (theta1_ddot_of_place_2 * theta2_dot_sin_theta2).mul_add(S::int(2), b1) - tau;
    // theta1'' = (tau + L1*l2*m2*theta2'^2*sin(theta2) - theta1'*(b1 +
    //   2*theta2'*sin(theta2)*cos(theta2)*(l2^2*m2 + J2)) + L1*l2*m2*cos(theta2)*(sin(theta2)*(l2*m2*(g -
    //   l2*theta1'^2*cos(theta2)) - J2*theta1'^2*cos(theta2)) + b2*theta2')/(l2^2*m2 + J2))/(l1^2*m1 + J1 +
    //   J2*sin(theta2)^2 + m2*(l2^2*sin(theta2)^2 + L1^2*(1 - l2^2*m2*cos(theta2)^2/(l2^2*m2 + J2))))
    let theta1_ddot = (l1_l2_m2
        * theta2_dot
            .mul_add(theta2_dot_sin_theta2, theta1_ddot_of_place * theta1_ddot_of_motion)
        - theta1_ddot_of_motion_2)
        / (l1 * l1 * m1 + J1 + J2 * sin_theta2 * sin_theta2
            + m2
                * (-L1 * L1 * (l2_l2_m2 * theta1_ddot_of_place).mul_add(cos_theta2, -S::int(1))
                    + l2_sin_theta2 * l2_sin_theta2));
    // theta2'' = (J2*theta1'^2*sin(theta2)*cos(theta2) - b2*theta2' - l2*m2*(sin(theta2)*(g -
    //   l2*theta1'^2*cos(theta2)) + L1*theta1''*cos(theta2)))/(l2^2*m2 + J2)
    let theta2_ddot = (-(theta1_ddot * theta1_ddot_of_place))
        .mul_add(l1_l2_m2, -j2_plus_l2_l2_m2_inv * theta1_ddot_of_motion);
    // Values.
    // theta1'
    let theta1_dot_value = theta1_dot;
    // theta2'
    let theta2_dot_value = theta2_dot;
    ([theta1_dot_value, theta2_dot_value], [theta1_ddot, theta2_ddot])
}

/// Inverse dynamics: the generalized forces along (theta1', theta2') that must act beside the loads of the model for the accelerations to be (theta1'', theta2'').
///
/// 39 operations, 1 sine and cosine.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { L1, l1, m1, J1, l2, m2, J2, b1, b2, g, tau } = *p;
    let [_, theta2] = *q;
    let [theta1_dot, theta2_dot] = *q_dot;
    let [theta1_ddot, theta2_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Shared terms.
    let theta1_dot_cos_theta2 = theta1_dot * cos_theta2;
    let l2_m2 = l2 * m2;
    // J2 + l2*l2_m2
    let j2_plus_l2_l2_m2 = l2.mul_add(l2_m2, J2);
    let tau1_of_place = j2_plus_l2_l2_m2 * sin_theta2;
    let l1_theta1_ddot = L1 * theta1_ddot;
    // Values.
    // tau1 = theta1'*(b1 + 2*theta2'*sin(theta2)*cos(theta2)*(l2^2*m2 + J2)) - tau -
    //   L1*l2*m2*theta2'^2*sin(theta2) + theta1''*(l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(L1^2 +
    //   l2^2*sin(theta2)^2)) + L1*l2*m2*theta2''*cos(theta2)
    let tau1 = -tau + b1 * theta1_dot + theta1_ddot * (l1 * l1 * m1 + J1)
        + tau1_of_place
            * (theta2_dot * theta1_dot_cos_theta2)
                .mul_add(S::int(2), theta1_ddot * sin_theta2)
        + L1
            * (l2_m2 * theta2_ddot.mul_add(cos_theta2, -theta2_dot * theta2_dot * sin_theta2)
                + m2 * l1_theta1_ddot);
    // tau2 = sin(theta2)*(l2*m2*(g - l2*theta1'^2*cos(theta2)) - J2*theta1'^2*cos(theta2)) + b2*theta2' +
    //   L1*l2*m2*theta1''*cos(theta2) + theta2''*(l2^2*m2 + J2)
    let tau2 = b2 * theta2_dot + theta2_ddot * j2_plus_l2_l2_m2
        - theta1_dot * theta1_dot_cos_theta2 * tau1_of_place
        + l2_m2 * l1_theta1_ddot.mul_add(cos_theta2, g * sin_theta2);
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
            parameters: 11,
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
    fn has_power(&self) -> bool {
        true
    }
    fn power(&self, p: &[S], q: &[S], v: &[S]) -> S {
        power(&Parameters::from_slice(p), array(q), array(v))
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
