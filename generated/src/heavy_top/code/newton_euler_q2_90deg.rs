//! Symmetric heavy top about a fixed point: Newton–Euler equations in q2-90°, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/heavy_top/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane_q2_90deg::{
    accelerations, coordinate_rates, derivative, divisors, kinetic_energy,
    potential_energy,
};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows top force b1, top force b2, top force b3, top moment b1, top moment b2, top moment b3.
///
/// 23 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    _u: &[S; 3],
) -> [[S; 6]; 6] {
    let Parameters { m, l, I1, I3, .. } = *p;
    let [q1, q2_minus_90deg, _] = *q;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Shared terms.
    let m_l = m * l;
    let s1_cos_q2_minus_90deg = s1 * cos_q2_minus_90deg;
    let c1_cos_q2_minus_90deg = c1 * cos_q2_minus_90deg;
    // l*m_l - I1
    let minus_i1_plus_l_m_l = l.mul_add(m_l, -I1);
    // -minus_i1_plus_l_m_l
    let m41_of_m_l_i1 = -minus_i1_plus_l_m_l;
    // Entries that are not zero.
    // M12 = m*l
    let m12 = m_l;
    // M14 = sin(q2_minus_90deg)
    let m14 = sin_q2_minus_90deg;
    // M15 = -sin(q1)*cos(q2_minus_90deg)
    let m15 = -s1_cos_q2_minus_90deg;
    // M16 = cos(q1)*cos(q2_minus_90deg)
    let m16 = c1_cos_q2_minus_90deg;
    // M21 = -m*l
    let m21 = -m_l;
    // M25 = -cos(q1)
    let m25 = -c1;
    // M26 = -sin(q1)
    let m26 = -s1;
    // M34 = -cos(q2_minus_90deg)
    let m34 = -cos_q2_minus_90deg;
    // M35 = -sin(q1)*sin(q2_minus_90deg)
    let m35 = -s1 * sin_q2_minus_90deg;
    // M36 = cos(q1)*sin(q2_minus_90deg)
    let m36 = c1 * sin_q2_minus_90deg;
    // M41 = I1 - m*l^2
    let m41 = m41_of_m_l_i1;
    // M45 = -l*cos(q1)
    let m45 = -l * c1;
    // M46 = -l*sin(q1)
    let m46 = -l * s1;
    // M52 = I1 - m*l^2
    let m52 = m41_of_m_l_i1;
    // M54 = -l*sin(q2_minus_90deg)
    let m54 = -l * sin_q2_minus_90deg;
    // M55 = l*sin(q1)*cos(q2_minus_90deg)
    let m55 = l * s1_cos_q2_minus_90deg;
    // M56 = -l*cos(q1)*cos(q2_minus_90deg)
    let m56 = -l * c1_cos_q2_minus_90deg;
    // M63 = I3
    let m63 = I3;
    let zero = S::int(0);
    [
        [zero, m12, zero, m14, m15, m16],
        [m21, zero, zero, zero, m25, m26],
        [zero, zero, zero, m34, m35, m36],
        [m41, zero, zero, zero, m45, m46],
        [zero, m52, zero, m54, m55, m56],
        [zero, zero, m63, zero, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3', hold1, hold2, hold3).
///
/// 29 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 3]) -> [S; 6] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [q1, q2_minus_90deg, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Shared terms.
    let g_c1 = g * c1;
    let f1_of_u1 = u1 / sin_q2_minus_90deg;
    let l_f1_of_u1 = l * f1_of_u1;
    // I3*u3 + f1_of_u1*cos(q2_minus_90deg)*(I1 - m*l^2)
    let f4_of_u1_u3 = f1_of_u1 * cos_q2_minus_90deg * (I1 - m * l * l) + I3 * u3;
    // Values.
    // f1 = m*cos(q2_minus_90deg)*(g*cos(q1) + l*u1^2/sin(q2_minus_90deg))
    let f1 = m * cos_q2_minus_90deg * u1.mul_add(l_f1_of_u1, g_c1);
    // f2 = m*(l*u1*u2/tan(q2_minus_90deg) - g*sin(q1))
    let f2 = m * (-g).mul_add(s1, u2 * l_f1_of_u1 * cos_q2_minus_90deg);
    // f3 = m*(l*(u1^2 + u2^2) + g*cos(q1)*sin(q2_minus_90deg))
    let f3 = m * (l * u2.mul_add(u2, u1 * u1) + g_c1 * sin_q2_minus_90deg);
    // f4 = -u2*(I3*u3 + u1*(I1 - m*l^2)/tan(q2_minus_90deg))
    let f4 = -u2 * f4_of_u1_u3;
    // f5 = u1*(I3*u3 + u1*(I1 - m*l^2)/tan(q2_minus_90deg))
    let f5 = u1 * f4_of_u1_u3;
    let zero = S::int(0);
    [f1, f2, f3, f4, f5, zero]
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

/// Newton–Euler equations in q2-90° of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEulerQ290deg;

impl<S: Scalar> System<S> for NewtonEulerQ290deg {
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
