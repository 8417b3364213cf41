//! Chain of three rods floating in a plane: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/floating_chain/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{
    accelerations, coordinate_rates, derivative, kinetic_energy, potential_energy,
};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows rod1 force a1, rod1 force a2, rod1 moment a3, rod2 force b1, rod2 force b2, rod2 moment b3, rod3 force c1, rod3 force c2, rod3 moment c3.
///
/// 50 operations, 3 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 5],
) -> [[S; 9]; 9] {
    let Parameters { m, l } = *p;
    let [_, _, theta1, theta2, theta3] = *q;
    // Sines and cosines.
    let (sin_theta1, cos_theta1) = theta1.sin_cos();
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    let (sin_theta3, cos_theta3) = theta3.sin_cos();
    // Shared terms.
    let m_cos_theta1 = m * cos_theta1;
    let m_sin_theta1 = m * sin_theta1;
    let m_l = m * l;
    let l_m_l_by_12 = S::ratio(1, 12) * l * m_l;
    let l_halved = S::ratio(1, 2) * l;
    let m_cos_theta2 = m * cos_theta2;
    let m_sin_theta2 = m * sin_theta2;
    let m_l_halved = m * l_halved;
    let sin_theta1_m_l_halved = m_l_halved * sin_theta1;
    let cos_theta1_m_l_halved = m_l_halved * cos_theta1;
    let sin_theta2_l_halved = l_halved * sin_theta2;
    let cos_theta2_l_halved = l_halved * cos_theta2;
    let m_cos_theta3 = m * cos_theta3;
    let m_sin_theta3 = m * sin_theta3;
    // -sin(theta2)
    let minus_sin_theta2 = -sin_theta2;
    // -cos(theta2)
    let minus_cos_theta2 = -cos_theta2;
    // -cos(theta3)
    let minus_cos_theta3 = -cos_theta3;
    // -sin_theta2_l_halved
    let m66_of_l_theta2 = -sin_theta2_l_halved;
    // Entries that are not zero.
    // M11 = m*cos(theta1)
    let m11 = m_cos_theta1;
    // M12 = m*sin(theta1)
    let m12 = m_sin_theta1;
    // M16 = cos(theta1)
    let m16 = cos_theta1;
    // M17 = sin(theta1)
    let m17 = sin_theta1;
    // M21 = -m*sin(theta1)
    let m21 = -m_sin_theta1;
    // M22 = m*cos(theta1)
    let m22 = m_cos_theta1;
    // M26 = -sin(theta1)
    let m26 = -sin_theta1;
    // M27 = cos(theta1)
    let m27 = cos_theta1;
    // M33 = m*l^2/12
    let m33 = l_m_l_by_12;
    // M36 = -l*sin(theta1)/2
    let m36 = -l_halved * sin_theta1;
    // M37 = l*cos(theta1)/2
    let m37 = l_halved * cos_theta1;
    // M41 = m*cos(theta2)
    let m41 = m_cos_theta2;
    // M42 = m*sin(theta2)
    let m42 = m_sin_theta2;
    // M43 = -m*l*sin(theta1 - theta2)/2
    let m43 = (-sin_theta1_m_l_halved)
        .mul_add(cos_theta2, cos_theta1_m_l_halved * sin_theta2);
    // M46 = -cos(theta2)
    let m46 = minus_cos_theta2;
    // M47 = -sin(theta2)
    let m47 = minus_sin_theta2;
    // M48 = cos(theta2)
    let m48 = cos_theta2;
    // M49 = sin(theta2)
    let m49 = sin_theta2;
    // M51 = -m*sin(theta2)
    let m51 = -m_sin_theta2;
    // M52 = m*cos(theta2)
    let m52 = m_cos_theta2;
    // M53 = m*l*cos(theta1 - theta2)/2
    let m53 = cos_theta1_m_l_halved
        .mul_add(cos_theta2, sin_theta1_m_l_halved * sin_theta2);
    // M54 = m*l/2
    let m54 = m_l_halved;
    // M56 = sin(theta2)
    let m56 = sin_theta2;
    // M57 = -cos(theta2)
    let m57 = minus_cos_theta2;
    // M58 = -sin(theta2)
    let m58 = minus_sin_theta2;
    // M59 = cos(theta2)
    let m59 = cos_theta2;
    // M64 = m*l^2/12
    let m64 = l_m_l_by_12;
    // M66 = -l*sin(theta2)/2
    let m66 = m66_of_l_theta2;
    // M67 = l*cos(theta2)/2
    let m67 = cos_theta2_l_halved;
    // M68 = -l*sin(theta2)/2
    let m68 = m66_of_l_theta2;
    // M69 = l*cos(theta2)/2
    let m69 = cos_theta2_l_halved;
    // M71 = m*cos(theta3)
    let m71 = m_cos_theta3;
    // M72 = m*sin(theta3)
    let m72 = m_sin_theta3;
    // M73 = -m*l*sin(theta1 - theta3)/2
    let m73 = (-sin_theta1_m_l_halved)
        .mul_add(cos_theta3, cos_theta1_m_l_halved * sin_theta3);
    // M74 = -m*l*sin(theta2 - theta3)
    let m74 = m_l * (-sin_theta2).mul_add(cos_theta3, cos_theta2 * sin_theta3);
    // M78 = -cos(theta3)
    let m78 = minus_cos_theta3;
    // M79 = -sin(theta3)
    let m79 = -sin_theta3;
    // M81 = -m*sin(theta3)
    let m81 = -m_sin_theta3;
    // M82 = m*cos(theta3)
    let m82 = m_cos_theta3;
    // M83 = m*l*cos(theta1 - theta3)/2
    let m83 = cos_theta1_m_l_halved
        .mul_add(cos_theta3, sin_theta1_m_l_halved * sin_theta3);
    // M84 = m*l*cos(theta2 - theta3)
    let m84 = m_l * cos_theta2.mul_add(cos_theta3, sin_theta2 * sin_theta3);
    // M85 = m*l/2
    let m85 = m_l_halved;
    // M88 = sin(theta3)
    let m88 = sin_theta3;
    // M89 = -cos(theta3)
    let m89 = minus_cos_theta3;
    // M95 = m*l^2/12
    let m95 = l_m_l_by_12;
    // M98 = -l*sin(theta3)/2
    let m98 = -l_halved * sin_theta3;
    // M99 = l*cos(theta3)/2
    let m99 = l_halved * cos_theta3;
    let zero = S::int(0);
    [
        [m11, m12, zero, zero, zero, m16, m17, zero, zero],
        [m21, m22, zero, zero, zero, m26, m27, zero, zero],
        [zero, zero, m33, zero, zero, m36, m37, zero, zero],
        [m41, m42, m43, zero, zero, m46, m47, m48, m49],
        [m51, m52, m53, m54, zero, m56, m57, m58, m59],
        [zero, zero, zero, m64, zero, m66, m67, m68, m69],
        [m71, m72, m73, m74, zero, zero, zero, m78, m79],
        [m81, m82, m83, m84, m85, zero, zero, m88, m89],
        [zero, zero, zero, zero, m95, zero, zero, m98, m99],
    ]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5', pin1_x, pin1_y, pin2_x, pin2_y).
///
/// 26 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> [S; 9] {
    let Parameters { m, l } = *p;
    let [_, _, theta1, theta2, theta3] = *q;
    let [_, _, u3, u4, u5] = *u;
    // Shared terms.
    let m_l = m * l;
    let m_l_halved = S::ratio(1, 2) * m_l;
    let u4_sq = u4 * u4;
    let u3_sq = u3 * u3;
    let m_l_halved_u3_sq = m_l_halved * u3_sq;
    // theta1 - theta2
    let theta1_minus_theta2 = theta1 - theta2;
    // Sines and cosines.
    let (sin_theta1_minus_theta2, cos_theta1_minus_theta2) = theta1_minus_theta2
        .sin_cos();
    // 2*u4_sq*cos(theta1 - theta2) + u3_sq
    let f7_of_u3_u4 = (u4_sq * cos_theta1_minus_theta2).mul_add(S::int(2), u3_sq);
    let f7_of_u4 = m_l * u4_sq * sin_theta1_minus_theta2;
    // theta1 - theta3
    let theta1_minus_theta3 = theta1 - theta3;
    let (sin_theta1_minus_theta3, cos_theta1_minus_theta3) = theta1_minus_theta3
        .sin_cos();
    // Values.
    // f4 = m*l*(u3^2*cos(theta1 - theta2) + u4^2)/2
    let f4 = m_l_halved_u3_sq.mul_add(cos_theta1_minus_theta2, m_l_halved * u4_sq);
    // f5 = m*l*u3^2*sin(theta1 - theta2)/2
    let f5 = m_l_halved_u3_sq * sin_theta1_minus_theta2;
    // f7 = m*l*(u3^2*cos(theta1 - theta3) + 2*u4^2*cos(theta2 - theta3) + u5^2)/2
    let f7 = m_l_halved * f7_of_u3_u4.mul_add(cos_theta1_minus_theta3, u5 * u5)
        + f7_of_u4 * sin_theta1_minus_theta3;
    // f8 = m*l*(u3^2*sin(theta1 - theta3) + 2*u4^2*sin(theta2 - theta3))/2
    let f8 = (-f7_of_u4)
        .mul_add(
            cos_theta1_minus_theta3,
            m_l_halved * f7_of_u3_u4 * sin_theta1_minus_theta3,
        );
    let zero = S::int(0);
    [zero, zero, zero, f4, f5, zero, f7, f8, zero]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 5],
    direction: &[S; 10],
) -> [S; 10] {
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

/// Newton–Euler equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEuler;

impl<S: Scalar> System<S> for NewtonEuler {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 2,
            coordinates: 5,
            variables: 5,
            speeds: 5,
            reactions: 4,
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
