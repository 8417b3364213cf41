//! Thin disc rolling on a plane: Newton–Euler equations in q2-90°, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/rolling_disc/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane_q2_90deg::{
    accelerations, coordinate_rates, derivative, divisors, kinetic_energy,
    potential_energy,
};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows disc force l1, disc force l2, disc force l3, disc moment l1, disc moment l2, disc moment l3.
///
/// 21 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 3],
) -> [[S; 6]; 6] {
    let Parameters { r, m, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Shared terms.
    let r_m = r * m;
    let s1_sin_q2_minus_90deg = s1 * sin_q2_minus_90deg;
    let c1_sin_q2_minus_90deg = c1 * sin_q2_minus_90deg;
    let r_r_m = r * r_m;
    let r_r_m_by_4 = S::ratio(1, 4) * r_r_m;
    // Entries that are not zero.
    // M12 = r*m
    let m12 = r_m;
    // M14 = -cos(q1)
    let m14 = -c1;
    // M15 = -sin(q1)
    let m15 = -s1;
    // M21 = -r*m
    let m21 = -r_m;
    // M24 = -sin(q1)*sin(q2_minus_90deg)
    let m24 = -s1_sin_q2_minus_90deg;
    // M25 = cos(q1)*sin(q2_minus_90deg)
    let m25 = c1_sin_q2_minus_90deg;
    // M26 = -cos(q2_minus_90deg)
    let m26 = -cos_q2_minus_90deg;
    // M34 = -sin(q1)*cos(q2_minus_90deg)
    let m34 = -s1 * cos_q2_minus_90deg;
    // M35 = cos(q1)*cos(q2_minus_90deg)
    let m35 = c1 * cos_q2_minus_90deg;
    // M36 = sin(q2_minus_90deg)
    let m36 = sin_q2_minus_90deg;
    // M41 = r^2*m/4
    let m41 = r_r_m_by_4;
    // M44 = -r*sin(q1)*sin(q2_minus_90deg)
    let m44 = -r * s1_sin_q2_minus_90deg;
    // M45 = r*cos(q1)*sin(q2_minus_90deg)
    let m45 = r * c1_sin_q2_minus_90deg;
    // M46 = -r*cos(q2_minus_90deg)
    let m46 = -r * cos_q2_minus_90deg;
    // M52 = r^2*m/2
    let m52 = S::ratio(1, 2) * r_r_m;
    // M54 = r*cos(q1)
    let m54 = r * c1;
    // M55 = r*sin(q1)
    let m55 = r * s1;
    // M63 = r^2*m/4
    let m63 = r_r_m_by_4;
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

/// Right-hand side of the linear system; unknowns (u1', u2', u3', friction_x, friction_y, normal).
///
/// 25 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 3]) -> [S; 6] {
    let Parameters { r, m, g } = *p;
    let [_, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Shared terms.
    let r_m = r * m;
    let u3_r_m = u3 * r_m;
    let m_g = m * g;
    let u2_u3_r_m = u2 * u3_r_m;
    let u1_r_m = u1 * r_m;
    let tan_q2_minus_90deg = sin_q2_minus_90deg / cos_q2_minus_90deg;
    let f3_of_place = S::int(1) / tan_q2_minus_90deg;
    // r*(2*u2 + u3*f3_of_place)/4
    let f4_of_u2_u3 = S::ratio(1, 4) * r * u3.mul_add(f3_of_place, S::int(2) * u2);
    // Values.
    // f1 = -r*m*u1*u3
    let f1 = -u1 * u3_r_m;
    // f2 = -m*(r*u2*u3 + g*cos(q2_minus_90deg))
    let f2 = (-m_g).mul_add(cos_q2_minus_90deg, -u2_u3_r_m);
    // f3 = m*(g*sin(q2_minus_90deg) + r*(u1^2 - u2*u3/tan(q2_minus_90deg)))
    let f3 = u1.mul_add(u1_r_m, m_g * sin_q2_minus_90deg) - u2_u3_r_m * f3_of_place;
    // f4 = r^2*m*u3*(2*u2 + u3/tan(q2_minus_90deg))/4
    let f4 = u3_r_m * f4_of_u2_u3;
    // f6 = -r^2*m*u1*(2*u2 + u3/tan(q2_minus_90deg))/4
    let f6 = -u1_r_m * f4_of_u2_u3;
    let zero = S::int(0);
    [f1, f2, f3, f4, zero, f6]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 3],
    direction: &[S; 8],
) -> [S; 8] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[5 + i],
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
            parameters: 3,
            coordinates: 5,
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
        8
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
