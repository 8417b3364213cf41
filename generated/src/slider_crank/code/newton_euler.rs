//! Slider-crank: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/slider_crank/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{
    constraint_slopes, constraints, coordinate_rates, divisors, kinetic_energy,
    potential_energy,
};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows crank force crank_frame1, crank force crank_frame2, crank moment crank_frame3, rod force rod_frame1, rod force rod_frame2, rod moment rod_frame3, piston force piston_frame1, piston force piston_frame2.
///
/// 33 operations, 3 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _u: &[S; 1],
) -> [[S; 8]; 8] {
    let Parameters { r, l, b, I, mr, Ir, mp, .. } = *p;
    let [q_2, p_2] = *q;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_p, cos_p) = p_2.sin_cos();
    // Shared terms.
    // q + p
    let q_2_plus_p_2 = q_2 + p_2;
    let (sin_q_plus_p, cos_q_plus_p) = q_2_plus_p_2.sin_cos();
    let cos_q_cos_q_plus_p_inv = cos_q / cos_q_plus_p;
    let m41_of_l_q_2_p_2 = cos_q_cos_q_plus_p_inv / l;
    let r_mr = r * mr;
    // l - b
    let l_minus_b = l - b;
    // -cos(q)
    let minus_cos_q = -cos_q;
    // -cos(p)
    let minus_cos_p = -cos_p;
    // Entries that are not zero.
    // M14 = 1
    let m14 = S::int(1);
    // M17 = -cos(q)
    let m17 = minus_cos_q;
    // M18 = -sin(q)
    let m18 = -sin_q;
    // M25 = 1
    let m25 = S::int(1);
    // M27 = sin(q)
    let m27 = sin_q;
    // M28 = -cos(q)
    let m28 = minus_cos_q;
    // M31 = I
    let m31 = I;
    // M34 = -r
    let m34 = -r;
    // M41 = r*mr*(b*cos(q)/(l*cos(q + p)) - cos(p))
    let m41 = r_mr * b.mul_add(m41_of_l_q_2_p_2, -cos_p);
    // M42 = cos(q + p)
    let m42 = cos_q_plus_p;
    // M43 = sin(q + p)
    let m43 = sin_q_plus_p;
    // M44 = -cos(p)
    let m44 = minus_cos_p;
    // M45 = -sin(p)
    let m45 = -sin_p;
    // M51 = r*mr*sin(p)
    let m51 = r_mr * sin_p;
    // M52 = -sin(q + p)
    let m52 = -sin_q_plus_p;
    // M53 = cos(q + p)
    let m53 = cos_q_plus_p;
    // M54 = sin(p)
    let m54 = sin_p;
    // M55 = -cos(p)
    let m55 = minus_cos_p;
    // M61 = -r*Ir*cos(q)/(l*cos(q + p))
    let m61 = -r * Ir * m41_of_l_q_2_p_2;
    // M62 = cos(q + p)*(b - l)
    let m62 = -l_minus_b * cos_q_plus_p;
    // M63 = sin(q + p)*(b - l)
    let m63 = -l_minus_b * sin_q_plus_p;
    // M64 = -b*cos(p)
    let m64 = -b * cos_p;
    // M65 = -b*sin(p)
    let m65 = -b * sin_p;
    // M72 = -1
    let m72 = -S::int(1);
    // M76 = -1
    let m76 = -S::int(1);
    // M81 = r*mp*(cos(q)*tan(q + p) - sin(q))
    let m81 = r * mp * cos_q_cos_q_plus_p_inv.mul_add(sin_q_plus_p, -sin_q);
    // M83 = -1
    let m83 = -S::int(1);
    let zero = S::int(0);
    [
        [zero, zero, zero, m14, zero, zero, m17, m18],
        [zero, zero, zero, zero, m25, zero, m27, m28],
        [m31, zero, zero, m34, zero, zero, zero, zero],
        [m41, m42, m43, m44, m45, zero, zero, zero],
        [m51, m52, m53, m54, m55, zero, zero, zero],
        [m61, m62, m63, m64, m65, zero, zero, zero],
        [zero, m72, zero, zero, zero, m76, zero, zero],
        [m81, zero, m83, zero, zero, zero, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (u', wrist_force1, wrist_force2, rod_force_crank_frame1, rod_force_crank_frame2, piston_force_n1, crank_force_n1, crank_force_n2).
///
/// 42 operations, 3 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> [S; 8] {
    let Parameters { r, l, b, mr, Ir, mp, mc, g, .. } = *p;
    let [q_2, p_2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_p, cos_p) = p_2.sin_cos();
    // Shared terms.
    let mc_g = mc * g;
    // q + p
    let q_2_plus_p_2 = q_2 + p_2;
    let (sin_q_plus_p, cos_q_plus_p) = q_2_plus_p_2.sin_cos();
    let cos_q_plus_p_inv = S::int(1) / cos_q_plus_p;
    let l_inv_cos_q_plus_p_inv = cos_q_plus_p_inv / l;
    let f4_of_l_q_2_p_2 = l_inv_cos_q_plus_p_inv * cos_q;
    let r_f4_of_l_q_2_p_2 = r * f4_of_l_q_2_p_2;
    let f4_of_q_2_p_2 = cos_q_plus_p_inv * sin_q_plus_p;
    // l_inv_cos_q_plus_p_inv*(sin(q) + r_f4_of_l_q_2_p_2*f4_of_q_2_p_2*cos(q))
    let f4_of_r_l_q_2_p_2 = l_inv_cos_q_plus_p_inv
        * (r_f4_of_l_q_2_p_2 * f4_of_q_2_p_2).mul_add(cos_q, sin_q);
    let r_u_2_sq = r * u_2 * u_2;
    // Values.
    // f1 = -mc*g*sin(q)
    let f1 = -mc_g * sin_q;
    // f2 = -mc*g*cos(q)
    let f2 = -mc_g * cos_q;
    // f4 = mr*(r*u^2*(sin(p) + b*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q + p)))/(l*cos(q + p))) - g*sin(q
    //   + p))
    let f4 = mr * (r_u_2_sq * b.mul_add(f4_of_r_l_q_2_p_2, sin_p) - g * sin_q_plus_p);
    // f5 = mr*(r*u^2*(cos(p) + r*b*cos(q)^2/(l^2*cos(q + p)^2)) - g*cos(q + p))
    let f5 = mr
        * (r_u_2_sq * (b * f4_of_l_q_2_p_2).mul_add(r_f4_of_l_q_2_p_2, cos_p) - g * cos_q_plus_p);
    // f6 = -r*Ir*u^2*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q + p)))/(l*cos(q + p))
    let f6 = -Ir * f4_of_r_l_q_2_p_2 * r_u_2_sq;
    // f8 = mp*(r*u^2*(sin(q)*tan(q + p) + cos(q)*(1 + r*cos(q)/(l*cos(q + p)^3))) - g)
    let f8 = mp
        * (r_u_2_sq
            * (cos_q * (S::int(1) + cos_q_plus_p_inv * cos_q_plus_p_inv * r_f4_of_l_q_2_p_2)
                + f4_of_q_2_p_2 * sin_q) - g);
    let zero = S::int(0);
    [f1, f2, zero, f4, f5, f6, zero, f8]
}

/// The accelerations (u'), solved for when this code was generated.
///
/// 69 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> [S; 1] {
    let Parameters { r, l, b, I, mr, Ir, mp, g, .. } = *p;
    let [q_2, p_2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_p, cos_p) = p_2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let l_inv = S::int(1) / l;
    let b_mr = b * mr;
    // q + p
    let q_2_plus_p_2 = q_2 + p_2;
    let (sin_q_plus_p, cos_q_plus_p) = q_2_plus_p_2.sin_cos();
    let cos_q_plus_p_inv = S::int(1) / cos_q_plus_p;
    let cos_q_cos_q_plus_p_inv = cos_q_plus_p_inv * cos_q;
    let u_dot_of_l_q_2_p_2 = l_inv * cos_q_cos_q_plus_p_inv;
    let u_dot_of_q_2_p_2 = cos_q_cos_q_plus_p_inv * sin_q_plus_p;
    // mp*(u_dot_of_q_2_p_2 - sin(q))
    let u_dot_of_mp_q_2_p_2 = mp * (u_dot_of_q_2_p_2 - sin_q);
    // cos_q_plus_p_inv*(sin(q) + r*u_dot_of_l_q_2_p_2*u_dot_of_q_2_p_2)
    let u_dot_of_r_l_q_2_p_2 = cos_q_plus_p_inv
        * (r * u_dot_of_l_q_2_p_2).mul_add(u_dot_of_q_2_p_2, sin_q);
    // b*u_dot_of_l_q_2_p_2 - cos(p)
    let u_dot_of_l_b_q_2_p_2 = b.mul_add(u_dot_of_l_q_2_p_2, -cos_p);
    let r_u_2 = r * u_2;
    let r_u_2_sq = r_u_2 * r_u_2;
    let r_g = r * g;
    // mr*r_g*(sin(p)*cos(q + p) + u_dot_of_l_b_q_2_p_2*sin(q + p)) + u_dot_of_mp_q_2_p_2*(r_g -
    //   r_u_2_sq*(cos(q) + cos_q_plus_p_inv*sin(q)*sin(q + p)))
    let u_dot_of_u_2 = mr * r_g * u_dot_of_l_b_q_2_p_2.mul_add(sin_q_plus_p, sin_p * cos_q_plus_p)
        + u_dot_of_mp_q_2_p_2
            * (r_g - r_u_2_sq * (cos_q_plus_p_inv * sin_q).mul_add(sin_q_plus_p, cos_q));
    // u' = r*(g*(mp*sin(q) + mr*(sin(q + p)*cos(p) - sin(p)*cos(q + p))) - r*mp*u^2*sin(q)*cos(q) +
    //   (r*u^2*(cos(q)*((b*mr*sin(p) + (sin(q)*(b^2*mr + Ir)/l + r*cos(q)*(b*mr*sin(p)/l + (sin(q +
    //   p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) - mp*sin(q))/cos(q
    //   + p)))/cos(q + p))/l + mp*sin(q + p)*(cos(q) + sin(q)*tan(q + p))) - sin(q)*(mp*sin(q)*sin(q + p) +
    //   b*mr*cos(p)/l)) - g*cos(q)*sin(q + p)*(b*mr/l + mp))/cos(q + p))/(I + r^2*(mr + mp*sin(q)^2 +
    //   cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - 2*b*mr*cos(p))/l + mp*sin(q + p)*(cos(q)*tan(q + p) -
    //   2*sin(q)))/cos(q + p)))
    let u_dot = (l_inv * r_u_2_sq
        * (cos_q_cos_q_plus_p_inv
            * (r * cos_q_cos_q_plus_p_inv
                * cos_q_plus_p_inv.mul_add(u_dot_of_mp_q_2_p_2, l_inv * b_mr * sin_p)
                + Ir * l_inv * u_dot_of_r_l_q_2_p_2)
            + b_mr
                * u_dot_of_r_l_q_2_p_2
                    .mul_add(u_dot_of_l_b_q_2_p_2, cos_q_cos_q_plus_p_inv * sin_p)) - u_dot_of_u_2)
        / (I
            + r * r
                * (mr + mp * sin_q * sin_q
                    - cos_q_cos_q_plus_p_inv
                        * (l_inv
                            * (-u_dot_of_l_q_2_p_2 * b.mul_add(b_mr, Ir) + S::int(2) * b_mr * cos_p)
                            + mp * sin_q_plus_p * sin_q.mul_add(S::int(2), -u_dot_of_q_2_p_2))));
    [u_dot]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 69 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 1],
) -> ([S; 2], [S; 1]) {
    let Parameters { r, l, b, I, mr, Ir, mp, g, .. } = *p;
    let [q_2, p_2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_p, cos_p) = p_2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let l_inv = S::int(1) / l;
    let b_mr = b * mr;
    // q + p
    let q_2_plus_p_2 = q_2 + p_2;
    let (sin_q_plus_p, cos_q_plus_p) = q_2_plus_p_2.sin_cos();
    let cos_q_plus_p_inv = S::int(1) / cos_q_plus_p;
    let cos_q_cos_q_plus_p_inv = cos_q_plus_p_inv * cos_q;
    let u_dot_of_l_q_2_p_2 = l_inv * cos_q_cos_q_plus_p_inv;
    let u_dot_of_q_2_p_2 = cos_q_cos_q_plus_p_inv * sin_q_plus_p;
    // 1/(I + r^2*(mr + mp*sin(q)^2 + cos_q_cos_q_plus_p_inv*(l_inv*(u_dot_of_l_q_2_p_2*(Ir + b*b_mr) -
    //   2*b_mr*cos(p)) + mp*sin(q + p)*(u_dot_of_q_2_p_2 - 2*sin(q)))))
    let u_dot_of_place = S::int(1)
        / (I
            + r * r
                * (mr + mp * sin_q * sin_q
                    + cos_q_cos_q_plus_p_inv
                        * (l_inv
                            * (u_dot_of_l_q_2_p_2 * b.mul_add(b_mr, Ir) - S::int(2) * b_mr * cos_p)
                            + mp * sin_q_plus_p * (-sin_q).mul_add(S::int(2), u_dot_of_q_2_p_2))));
    // b*u_dot_of_l_q_2_p_2 - cos(p)
    let u_dot_of_l_b_q_2_p_2 = b.mul_add(u_dot_of_l_q_2_p_2, -cos_p);
    // mp*(u_dot_of_q_2_p_2 - sin(q))
    let u_dot_of_mp_q_2_p_2 = mp * (u_dot_of_q_2_p_2 - sin_q);
    let r_u_2 = r * u_2;
    let r_u_dot_of_l_q_2_p_2 = r * u_dot_of_l_q_2_p_2;
    // l_inv*cos_q_plus_p_inv*(Ir*u_dot_of_l_q_2_p_2 + b_mr*u_dot_of_l_b_q_2_p_2)*(sin(q) +
    //   u_dot_of_q_2_p_2*r_u_dot_of_l_q_2_p_2) + b_mr*u_dot_of_l_q_2_p_2*sin(p)*(1 + r_u_dot_of_l_q_2_p_2)
    let u_dot_of_place_2 = l_inv * cos_q_plus_p_inv
        * b_mr.mul_add(u_dot_of_l_b_q_2_p_2, Ir * u_dot_of_l_q_2_p_2)
        * u_dot_of_q_2_p_2.mul_add(r_u_dot_of_l_q_2_p_2, sin_q)
        + b_mr * u_dot_of_l_q_2_p_2 * sin_p * (S::int(1) + r_u_dot_of_l_q_2_p_2);
    // u' = r*(g*(mp*sin(q) + mr*(sin(q + p)*cos(p) - sin(p)*cos(q + p))) - r*mp*u^2*sin(q)*cos(q) +
    //   (r*u^2*(cos(q)*((b*mr*sin(p) + (sin(q)*(b^2*mr + Ir)/l + r*cos(q)*(b*mr*sin(p)/l + (sin(q +
    //   p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) - mp*sin(q))/cos(q
    //   + p)))/cos(q + p))/l + mp*sin(q + p)*(cos(q) + sin(q)*tan(q + p))) - sin(q)*(mp*sin(q)*sin(q + p) +
    //   b*mr*cos(p)/l)) - g*cos(q)*sin(q + p)*(b*mr/l + mp))/cos(q + p))/(I + r^2*(mr + mp*sin(q)^2 +
    //   cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - 2*b*mr*cos(p))/l + mp*sin(q + p)*(cos(q)*tan(q + p) -
    //   2*sin(q)))/cos(q + p)))
    let u_dot = u_dot_of_place * r_u_2 * r_u_2
        * (u_dot_of_mp_q_2_p_2
            * (cos_q
                + cos_q_plus_p_inv
                    * cos_q_cos_q_plus_p_inv
                        .mul_add(r_u_dot_of_l_q_2_p_2, sin_q * sin_q_plus_p)) + u_dot_of_place_2)
        - r * g * u_dot_of_place
            * (mr * u_dot_of_l_b_q_2_p_2.mul_add(sin_q_plus_p, sin_p * cos_q_plus_p)
                + u_dot_of_mp_q_2_p_2);
    // Values.
    // q' = u
    let q_dot_value = u_2;
    // p' = -u*(1 + r*cos(q)/(l*cos(q + p)))
    let p_dot_value = (-u_dot_of_l_q_2_p_2).mul_add(r_u_2, -u_2);
    ([q_dot_value, p_dot_value], [u_dot])
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 1],
    direction: &[S; 3],
) -> [S; 3] {
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
            parameters: 9,
            coordinates: 2,
            variables: 1,
            speeds: 1,
            reactions: 7,
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
        3
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
        ["cos(q + p)"][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn constraint_count(&self) -> usize {
        1
    }
    fn constraint_name(&self, at: usize) -> &str {
        ["wrist_1"][at]
    }
    fn constraints(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &constraints(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn constraint_slopes(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &constraint_slopes(&Parameters::from_slice(p), array(q), array(v)),
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
