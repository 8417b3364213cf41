//! Spherical pendulum: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/spherical_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{
    accelerations, coordinate_rates, derivative, divisors, kinetic_energy,
    potential_energy,
};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows bob force n1, bob force n2, bob force n3.
///
/// 11 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _u: &[S; 2],
) -> [[S; 3]; 3] {
    let Parameters { m, l, .. } = *p;
    let [theta, phi] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Shared terms.
    let m_l = m * l;
    let cos_theta_m_l = m_l * cos_theta;
    // Entries that are not zero.
    // M11 = m*l*cos(theta)*cos(phi)
    let m11 = cos_theta_m_l * cos_phi;
    // M12 = -m*l*sin(phi)
    let m12 = -m_l * sin_phi;
    // M13 = sin(theta)*cos(phi)
    let m13 = sin_theta * cos_phi;
    // M21 = m*l*cos(theta)*sin(phi)
    let m21 = cos_theta_m_l * sin_phi;
    // M22 = m*l*cos(phi)
    let m22 = m_l * cos_phi;
    // M23 = sin(theta)*sin(phi)
    let m23 = sin_theta * sin_phi;
    // M31 = m*l*sin(theta)
    let m31 = m_l * sin_theta;
    // M33 = -cos(theta)
    let m33 = -cos_theta;
    let zero = S::int(0);
    [[m11, m12, m13], [m21, m22, m23], [m31, zero, m33]]
}

/// Right-hand side of the linear system; unknowns (u1', u2', rod).
///
/// 20 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 3] {
    let Parameters { m, l, g } = *p;
    let [theta, phi] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Shared terms.
    let u2_sin_theta_inv = u2 / sin_theta;
    let m_l = m * l;
    // m_l*(u1^2*sin(theta) + u2*u2_sin_theta_inv)
    let f1_of_u1_u2 = m_l * u2.mul_add(u2_sin_theta_inv, u1 * u1 * sin_theta);
    let u1_cos_theta_m_l = u1 * m_l * cos_theta;
    let f1_of_u1_u2_2 = u2_sin_theta_inv * u1_cos_theta_m_l;
    // Values.
    // f1 = m*l*(u2^2*cos(phi)/sin(theta) + u1*(u1*sin(theta)*cos(phi) + u2*sin(phi)/tan(theta)))
    let f1 = f1_of_u1_u2_2.mul_add(sin_phi, f1_of_u1_u2 * cos_phi);
    // f2 = m*l*(u2^2*sin(phi)/sin(theta) + u1*(u1*sin(theta)*sin(phi) - u2*cos(phi)/tan(theta)))
    let f2 = (-f1_of_u1_u2_2).mul_add(cos_phi, f1_of_u1_u2 * sin_phi);
    // f3 = -m*(g + l*u1^2*cos(theta))
    let f3 = (-u1).mul_add(u1_cos_theta_m_l, -m * g);
    [f1, f2, f3]
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
            parameters: 3,
            coordinates: 2,
            variables: 2,
            speeds: 2,
            reactions: 1,
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
