//! Furuta pendulum: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/furuta/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{
    accelerations, coordinate_rates, derivative, kinetic_energy, potential_energy, power,
};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows arm force a1, arm force a2, arm force a3, arm moment a1, arm moment a2, arm moment a3, pendulum force p1, pendulum force p2, pendulum force p3, pendulum moment p1, pendulum moment p2, pendulum moment p3.
///
/// 24 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _u: &[S; 2],
) -> [[S; 12]; 12] {
    let Parameters { L1, l1, m1, J1, l2, m2, J2, .. } = *p;
    let [theta1, theta2] = *q;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    // Shared terms.
    let l2_m2 = l2 * m2;
    let l1_cos_theta2 = L1 * cos_theta2;
    let l1_sin_theta2 = L1 * sin_theta2;
    // -sin(theta2)
    let minus_sin_theta2 = -sin_theta2;
    // -l1
    let minus_l1 = -l1;
    // -sin(theta1)
    let minus_sin_theta1 = -sin_theta1;
    // -cos(theta1)
    let minus_cos_theta1 = -cos_theta1;
    // -cos(theta2)
    let minus_cos_theta2 = -cos_theta2;
    // Entries that are not zero.
    // M_1_3 = 1
    let m_1_3 = S::int(1);
    // M_1_8 = -cos(theta1)
    let m_1_8 = minus_cos_theta1;
    // M_1_9 = -sin(theta1)
    let m_1_9 = minus_sin_theta1;
    // M_2_1 = l1*m1
    let m_2_1 = l1 * m1;
    // M_2_4 = 1
    let m_2_4 = S::int(1);
    // M_2_8 = sin(theta1)
    let m_2_8 = sin_theta1;
    // M_2_9 = -cos(theta1)
    let m_2_9 = minus_cos_theta1;
    // M_3_5 = 1
    let m_3_5 = S::int(1);
    // M_3_10 = -1
    let m_3_10 = -S::int(1);
    // M_4_11 = -cos(theta1)
    let m_4_11 = minus_cos_theta1;
    // M_4_12 = -sin(theta1)
    let m_4_12 = minus_sin_theta1;
    // M_5_5 = l1
    let m_5_5 = l1;
    // M_5_6 = 1
    let m_5_6 = S::int(1);
    // M_5_10 = -l1
    let m_5_10 = minus_l1;
    // M_5_11 = sin(theta1)
    let m_5_11 = sin_theta1;
    // M_5_12 = -cos(theta1)
    let m_5_12 = minus_cos_theta1;
    // M_6_1 = J1
    let m_6_1 = J1;
    // M_6_4 = -l1
    let m_6_4 = minus_l1;
    // M_6_7 = 1
    let m_6_7 = S::int(1);
    // M_6_8 = -l1*sin(theta1)
    let m_6_8 = -l1 * sin_theta1;
    // M_6_9 = l1*cos(theta1)
    let m_6_9 = l1 * cos_theta1;
    // M_7_1 = -l2*m2*sin(theta2)
    let m_7_1 = -l2_m2 * sin_theta2;
    // M_7_3 = -1
    let m_7_3 = -S::int(1);
    // M_8_1 = L1*m2*cos(theta2)
    let m_8_1 = m2 * l1_cos_theta2;
    // M_8_2 = l2*m2
    let m_8_2 = l2_m2;
    // M_8_4 = -cos(theta2)
    let m_8_4 = minus_cos_theta2;
    // M_8_5 = -sin(theta2)
    let m_8_5 = minus_sin_theta2;
    // M_9_1 = -L1*m2*sin(theta2)
    let m_9_1 = -m2 * l1_sin_theta2;
    // M_9_4 = sin(theta2)
    let m_9_4 = sin_theta2;
    // M_9_5 = -cos(theta2)
    let m_9_5 = minus_cos_theta2;
    // M_10_2 = J2
    let m_10_2 = J2;
    // M_10_4 = l2*cos(theta2)
    let m_10_4 = l2 * cos_theta2;
    // M_10_5 = l2*sin(theta2)
    let m_10_5 = l2 * sin_theta2;
    // M_11_1 = J2*sin(theta2)
    let m_11_1 = J2 * sin_theta2;
    // M_11_3 = -l2
    let m_11_3 = -l2;
    // M_11_4 = L1*sin(theta2)
    let m_11_4 = l1_sin_theta2;
    // M_11_5 = -L1*cos(theta2)
    let m_11_5 = -l1_cos_theta2;
    // M_11_6 = -cos(theta2)
    let m_11_6 = minus_cos_theta2;
    // M_11_7 = -sin(theta2)
    let m_11_7 = minus_sin_theta2;
    // M_12_4 = L1*cos(theta2)
    let m_12_4 = l1_cos_theta2;
    // M_12_5 = L1*sin(theta2)
    let m_12_5 = l1_sin_theta2;
    // M_12_6 = sin(theta2)
    let m_12_6 = sin_theta2;
    // M_12_7 = -cos(theta2)
    let m_12_7 = minus_cos_theta2;
    let zero = S::int(0);
    [
        [zero, zero, m_1_3, zero, zero, zero, zero, m_1_8, m_1_9, zero, zero, zero],
        [m_2_1, zero, zero, m_2_4, zero, zero, zero, m_2_8, m_2_9, zero, zero, zero],
        [zero, zero, zero, zero, m_3_5, zero, zero, zero, zero, m_3_10, zero, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_4_11, m_4_12],
        [zero, zero, zero, zero, m_5_5, m_5_6, zero, zero, zero, m_5_10, m_5_11, m_5_12],
        [m_6_1, zero, zero, m_6_4, zero, zero, m_6_7, m_6_8, m_6_9, zero, zero, zero],
        [m_7_1, zero, m_7_3, zero, zero, zero, zero, zero, zero, zero, zero, zero],
        [m_8_1, m_8_2, zero, m_8_4, m_8_5, zero, zero, zero, zero, zero, zero, zero],
        [m_9_1, zero, zero, m_9_4, m_9_5, zero, zero, zero, zero, zero, zero, zero],
        [zero, m_10_2, zero, m_10_4, m_10_5, zero, zero, zero, zero, zero, zero, zero],
        [
            m_11_1, zero, m_11_3, m_11_4, m_11_5, m_11_6, m_11_7, zero, zero, zero, zero, zero,
        ],
        [zero, zero, zero, m_12_4, m_12_5, m_12_6, m_12_7, zero, zero, zero, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (u_theta1', u_theta2', pendulum_force_a1, pendulum_force_a2, pendulum_force_a3, pendulum_torque_a2, pendulum_torque_a3, arm_force_n1, arm_force_n2, arm_force_n3, arm_torque_n1, arm_torque_n2).
///
/// 31 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 12] {
    let Parameters { L1, l1, m1, l2, m2, J2, b1, b2, g, tau, .. } = *p;
    let [_, theta2] = *q;
    let [u_theta1, u_theta2] = *u;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Shared terms.
    let u_theta1_sq = u_theta1 * u_theta1;
    let b2_u_theta2 = b2 * u_theta2;
    let l2_m2 = l2 * m2;
    let f_7_of_motion = S::int(2) * u_theta1 * u_theta2 * cos_theta2;
    let cos_theta2_u_theta1_sq = u_theta1_sq * cos_theta2;
    // m2*(l2*cos_theta2_u_theta1_sq - g)
    let f_8_of_u_theta1 = m2 * l2.mul_add(cos_theta2_u_theta1_sq, -g);
    // Values.
    // f_1 = l1*m1*u_theta1^2
    let f_1 = l1 * m1 * u_theta1_sq;
    // f_3 = -m1*g
    let f_3 = -m1 * g;
    // f_4 = b2*u_theta2
    let f_4 = b2_u_theta2;
    // f_6 = tau - b1*u_theta1
    let f_6 = (-b1).mul_add(u_theta1, tau);
    // f_7 = m2*u_theta1*(L1*u_theta1 + 2*l2*u_theta2*cos(theta2))
    let f_7 = l2_m2.mul_add(f_7_of_motion, L1 * m2 * u_theta1_sq);
    // f_8 = m2*sin(theta2)*(l2*u_theta1^2*cos(theta2) - g)
    let f_8 = f_8_of_u_theta1 * sin_theta2;
    // f_9 = -m2*(g*cos(theta2) + l2*(u_theta1^2*sin(theta2)^2 + u_theta2^2))
    let f_9 = -l2_m2 * u_theta2.mul_add(u_theta2, u_theta1_sq) + f_8_of_u_theta1 * cos_theta2;
    // f_10 = J2*u_theta1^2*sin(theta2)*cos(theta2) - b2*u_theta2
    let f_10 = (J2 * cos_theta2_u_theta1_sq).mul_add(sin_theta2, -b2_u_theta2);
    // f_11 = -2*J2*u_theta1*u_theta2*cos(theta2)
    let f_11 = -J2 * f_7_of_motion;
    let zero = S::int(0);
    [f_1, zero, f_3, f_4, zero, f_6, f_7, f_8, f_9, f_10, f_11, zero]
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

/// Newton–Euler equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEuler;

impl<S: Scalar> System<S> for NewtonEuler {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 11,
            coordinates: 2,
            variables: 2,
            speeds: 2,
            reactions: 10,
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
