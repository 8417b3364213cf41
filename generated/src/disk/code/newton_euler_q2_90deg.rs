//! Thin disk sliding on a frictionless plane: Newton–Euler equations in q2-90°, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/disk/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane_q2_90deg::{
    accelerations, coordinate_rates, derivative, divisors, jacobian, kinetic_energy,
    potential_energy, taylor,
};

use tripos_traits::series::{SLACK, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows disk force b1, disk force b2, disk force b3, disk moment b1, disk moment b2, disk moment b3.
///
/// 16 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 5],
) -> [[S; 6]; 6] {
    let Parameters { M, R, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Shared terms.
    let m_r = M * R;
    let m_c1 = M * c1;
    let m_s1 = M * s1;
    let r_m_r = R * m_r;
    let r_m_r_by_4 = S::ratio(1, 4) * r_m_r;
    let tan_q2_minus_90deg = sin_q2_minus_90deg / cos_q2_minus_90deg;
    // Entries that are not zero.
    // M12 = M*R/tan(q2_minus_90deg)
    let m12 = m_r / tan_q2_minus_90deg;
    // M14 = M*cos(q1)
    let m14 = m_c1;
    // M15 = M*sin(q1)
    let m15 = m_s1;
    // M24 = -M*sin(q1)*cos(q2_minus_90deg)
    let m24 = -m_s1 * cos_q2_minus_90deg;
    // M25 = M*cos(q1)*cos(q2_minus_90deg)
    let m25 = m_c1 * cos_q2_minus_90deg;
    // M26 = sin(q2_minus_90deg)
    let m26 = sin_q2_minus_90deg;
    // M31 = M*R
    let m31 = m_r;
    // M34 = -M*sin(q1)*sin(q2_minus_90deg)
    let m34 = -m_s1 * sin_q2_minus_90deg;
    // M35 = M*cos(q1)*sin(q2_minus_90deg)
    let m35 = m_c1 * sin_q2_minus_90deg;
    // M36 = -cos(q2_minus_90deg)
    let m36 = -cos_q2_minus_90deg;
    // M41 = M*R^2/4
    let m41 = r_m_r_by_4;
    // M46 = R*cos(q2_minus_90deg)
    let m46 = R * cos_q2_minus_90deg;
    // M52 = M*R^2/4
    let m52 = r_m_r_by_4;
    // M63 = M*R^2/2
    let m63 = S::ratio(1, 2) * r_m_r;
    let zero = S::int(0);
    [
        [zero, m12, zero, m14, m15, zero],
        [zero, zero, zero, m24, m25, m26],
        [m31, zero, zero, m34, m35, m36],
        [m41, zero, zero, zero, zero, m46],
        [zero, m52, zero, zero, zero, zero],
        [zero, zero, m63, zero, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5', N).
///
/// 29 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> [S; 6] {
    let Parameters { M, R, g } = *p;
    let [_, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3, _, _] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Shared terms.
    let m_r = M * R;
    let u2_m_r = u2 * m_r;
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    let m_g = M * g;
    let u1_m_r = u1 * m_r;
    let f2_of_u2 = u2 * sin_q2_minus_90deg_inv;
    let f3_of_u2 = f2_of_u2 * cos_q2_minus_90deg;
    // R*(2*u3 + f3_of_u2)/4
    let f4_of_u2_u3 = S::ratio(1, 4) * R * u3.mul_add(S::int(2), f3_of_u2);
    // Values.
    // f1 = -M*R*u1*u2*(2 + 1/tan(q2_minus_90deg)^2)
    let f1 = -u1 * u2_m_r * sin_q2_minus_90deg_inv.mul_add(sin_q2_minus_90deg_inv, S::int(1));
    // f2 = M*(g*sin(q2_minus_90deg) + R*(u1^2 + u2^2/tan(q2_minus_90deg)^2))
    let f2 = m_g * sin_q2_minus_90deg + u1 * u1_m_r
        + u2_m_r * sin_q2_minus_90deg_inv.mul_add(f2_of_u2, -u2);
    // f3 = M*cos(q2_minus_90deg)*(R*u2^2/sin(q2_minus_90deg) - g)
    let f3 = (-m_g).mul_add(cos_q2_minus_90deg, u2_m_r * f3_of_u2);
    // f4 = -M*R^2*u2*(2*u3 + u2/tan(q2_minus_90deg))/4
    let f4 = -u2_m_r * f4_of_u2_u3;
    // f5 = M*R^2*u1*(2*u3 + u2/tan(q2_minus_90deg))/4
    let f5 = u1_m_r * f4_of_u2_u3;
    let zero = S::int(0);
    [f1, f2, f3, f4, f5, zero]
}

/// Newton–Euler equations in q2-90° of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEulerQ290deg;

impl<S: Scalar> System<S> for NewtonEulerQ290deg {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 3,
            coordinates: 5,
            variables: 5,
            speeds: 5,
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
        10
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
        out.copy_from_slice(
            jacobian(&Parameters::from_slice(p), array(q), array(v)).as_flattened(),
        );
    }
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, order: usize) -> usize {
        48 * order + SLACK
    }
    fn taylor(&self, p: &[S], order: usize, x: &mut [S], work: &mut [S]) {
        S::dispatch(
            #[inline(always)]
            || {
                let x = &mut x.as_chunks_mut().0[..=order];
                taylor(&Parameters::from_slice(p), x, rows(work));
            },
        );
    }
    fn divisor_count(&self) -> usize {
        1
    }
    fn divisor_name(&self, at: usize) -> &str {
        ["sin(q2_minus_90deg)"][at]
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
