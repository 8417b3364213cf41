//! Symmetric heavy top in Euler's angles: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/euler_top/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{coordinate_rates, divisors, kinetic_energy, potential_energy};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows top force b1, top force b2, top force b3, top moment b1, top moment b2, top moment b3.
///
/// 22 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    _u: &[S; 3],
) -> [[S; 6]; 6] {
    let Parameters { m, l, I1, I3, .. } = *p;
    let [psi, theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_psi, cos_psi) = psi.sin_cos();
    // Shared terms.
    let m_l = m * l;
    let cos_theta_sin_psi = sin_psi * cos_theta;
    let cos_theta_cos_psi = cos_psi * cos_theta;
    // l*m_l - I1
    let minus_i1_plus_l_m_l = l.mul_add(m_l, -I1);
    // -minus_i1_plus_l_m_l
    let m41_of_m_l_i1 = -minus_i1_plus_l_m_l;
    // Entries that are not zero.
    // M12 = m*l
    let m12 = m_l;
    // M14 = -cos(psi)
    let m14 = -cos_psi;
    // M15 = -sin(psi)
    let m15 = -sin_psi;
    // M21 = -m*l
    let m21 = -m_l;
    // M24 = sin(psi)*cos(theta)
    let m24 = cos_theta_sin_psi;
    // M25 = -cos(psi)*cos(theta)
    let m25 = -cos_theta_cos_psi;
    // M26 = -sin(theta)
    let m26 = -sin_theta;
    // M34 = -sin(psi)*sin(theta)
    let m34 = -sin_psi * sin_theta;
    // M35 = cos(psi)*sin(theta)
    let m35 = cos_psi * sin_theta;
    // M36 = -cos(theta)
    let m36 = -cos_theta;
    // M41 = I1 - m*l^2
    let m41 = m41_of_m_l_i1;
    // M44 = l*sin(psi)*cos(theta)
    let m44 = l * cos_theta_sin_psi;
    // M45 = -l*cos(psi)*cos(theta)
    let m45 = -l * cos_theta_cos_psi;
    // M46 = -l*sin(theta)
    let m46 = -l * sin_theta;
    // M52 = I1 - m*l^2
    let m52 = m41_of_m_l_i1;
    // M54 = l*cos(psi)
    let m54 = l * cos_psi;
    // M55 = l*sin(psi)
    let m55 = l * sin_psi;
    // M63 = I3
    let m63 = I3;
    let zero = S::int(0);
    [
        [zero, m12, zero, m14, m15, zero],
        [m21, zero, zero, m24, m25, m26],
        [zero, zero, zero, m34, m35, m36],
        [m41, zero, zero, m44, m45, m46],
        [zero, m52, zero, m54, m55, zero],
        [zero, zero, m63, zero, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3', hold1, hold2, hold3).
///
/// 25 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 3]) -> [S; 6] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [_, theta, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let m_l = m * l;
    let tan_theta = sin_theta / cos_theta;
    let f1_of_u2 = u2 / tan_theta;
    let m_l_f1_of_u2 = m_l * f1_of_u2;
    let m_g = m * g;
    // I3*u3 + f1_of_u2*(l*m_l - I1)
    let f4_of_u2_u3 = f1_of_u2 * l.mul_add(m_l, -I1) + I3 * u3;
    // Values.
    // f1 = -m*l*u1*u2/tan(theta)
    let f1 = -u1 * m_l_f1_of_u2;
    // f2 = -m*(g*sin(theta) + l*u2^2/tan(theta))
    let f2 = (-m_g).mul_add(sin_theta, -u2 * m_l_f1_of_u2);
    // f3 = m*(l*(u1^2 + u2^2) - g*cos(theta))
    let f3 = m_l * u2.mul_add(u2, u1 * u1) - m_g * cos_theta;
    // f4 = -u2*(u2*(m*l^2 - I1)/tan(theta) + I3*u3)
    let f4 = -u2 * f4_of_u2_u3;
    // f5 = u1*(u2*(m*l^2 - I1)/tan(theta) + I3*u3)
    let f5 = u1 * f4_of_u2_u3;
    let zero = S::int(0);
    [f1, f2, f3, f4, f5, zero]
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
    // u1' = (m*l*g*sin(theta) - u2*(I3*u3 - I1*u2/tan(theta)))/I1
    let u1_dot = (-u2).mul_add(u2_dot_of_u2_u3, m * l * g * i1_inv * sin_theta);
    let zero = S::int(0);
    [u1_dot, u2_dot, zero]
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
    // u1' = (m*l*g*sin(theta) - u2*(I3*u3 - I1*u2/tan(theta)))/I1
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

/// Newton–Euler equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEuler;

impl<S: Scalar> System<S> for NewtonEuler {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 5,
            coordinates: 3,
            variables: 3,
            speeds: 3,
            reactions: 3,
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
