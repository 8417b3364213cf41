//! Symmetric rigid body free of forces: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/free_body/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{
    accelerations, coordinate_rates, derivative, divisors, forcing, kinetic_energy,
    potential_energy,
};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows body force b1, body force b2, body force b3, body moment b1, body moment b2, body moment b3.
///
/// 10 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    _u: &[S; 6],
) -> [[S; 6]; 6] {
    let Parameters { m, I1, I3 } = *p;
    let [_, _, _, psi, theta, _] = *q;
    // Sines and cosines.
    let (sin_psi, cos_psi) = psi.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let m_cos_psi = m * cos_psi;
    let m_sin_psi = m * sin_psi;
    // Entries that are not zero.
    // M11 = m*cos(psi)
    let m11 = m_cos_psi;
    // M12 = m*sin(psi)
    let m12 = m_sin_psi;
    // M21 = -m*sin(psi)*cos(theta)
    let m21 = -m_sin_psi * cos_theta;
    // M22 = m*cos(psi)*cos(theta)
    let m22 = m_cos_psi * cos_theta;
    // M23 = m*sin(theta)
    let m23 = m * sin_theta;
    // M31 = m*sin(psi)*sin(theta)
    let m31 = m_sin_psi * sin_theta;
    // M32 = -m*cos(psi)*sin(theta)
    let m32 = -m_cos_psi * sin_theta;
    // M33 = m*cos(theta)
    let m33 = m * cos_theta;
    // M44 = I1
    let m44 = I1;
    // M55 = I1
    let m55 = I1;
    // M66 = I3
    let m66 = I3;
    let zero = S::int(0);
    [
        [m11, m12, zero, zero, zero, zero],
        [m21, m22, m23, zero, zero, zero],
        [m31, m32, m33, zero, zero, zero],
        [zero, zero, zero, m44, zero, zero],
        [zero, zero, zero, zero, m55, zero],
        [zero, zero, zero, zero, zero, m66],
    ]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    u: &[S; 6],
    direction: &[S; 12],
) -> [S; 12] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[6 + i],
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
            coordinates: 6,
            variables: 6,
            speeds: 6,
            reactions: 0,
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
