//! Chaotic pendulum: a swinging rod with a plate turning about it: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/chaotic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{coordinate_rates, kinetic_energy, potential_energy};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows rod force a1, rod force a2, rod force a3, rod moment a1, rod moment a2, rod moment a3, plate force b1, plate force b2, plate force b3, plate moment b1, plate moment b2, plate moment b3.
///
/// 18 operations, 1 sine and cosine.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _u: &[S; 2],
) -> [[S; 12]; 12] {
    let Parameters { mA, mB, lA, lB, IAxx, IBxx, IByy, IBzz, .. } = *p;
    let [_, phi] = *q;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Shared terms.
    // lA - lB
    let la_minus_lb = lA - lB;
    let mb_lb = mB * lB;
    // -sin(phi)
    let minus_sin_phi = -sin_phi;
    // -cos(phi)
    let minus_cos_phi = -cos_phi;
    // Entries that are not zero.
    // M_1_1 = mA*lA
    let m_1_1 = mA * lA;
    // M_1_3 = -1
    let m_1_3 = -S::int(1);
    // M_1_8 = 1
    let m_1_8 = S::int(1);
    // M_2_4 = -1
    let m_2_4 = -S::int(1);
    // M_2_9 = 1
    let m_2_9 = S::int(1);
    // M_3_5 = -1
    let m_3_5 = -S::int(1);
    // M_3_10 = 1
    let m_3_10 = S::int(1);
    // M_4_4 = -lA
    let m_4_4 = -lA;
    // M_4_6 = -1
    let m_4_6 = -S::int(1);
    // M_4_9 = lA - lB
    let m_4_9 = la_minus_lb;
    // M_4_11 = 1
    let m_4_11 = S::int(1);
    // M_5_1 = IAxx
    let m_5_1 = IAxx;
    // M_5_3 = lA
    let m_5_3 = lA;
    // M_5_8 = lB - lA
    let m_5_8 = -la_minus_lb;
    // M_5_12 = 1
    let m_5_12 = S::int(1);
    // M_6_7 = -1
    let m_6_7 = -S::int(1);
    // M_7_1 = mB*lB*cos(phi)
    let m_7_1 = mb_lb * cos_phi;
    // M_7_8 = -cos(phi)
    let m_7_8 = minus_cos_phi;
    // M_7_9 = -sin(phi)
    let m_7_9 = minus_sin_phi;
    // M_8_1 = -mB*lB*sin(phi)
    let m_8_1 = -mb_lb * sin_phi;
    // M_8_8 = sin(phi)
    let m_8_8 = sin_phi;
    // M_8_9 = -cos(phi)
    let m_8_9 = minus_cos_phi;
    // M_9_10 = -1
    let m_9_10 = -S::int(1);
    // M_10_1 = IBxx*sin(phi)
    let m_10_1 = IBxx * sin_phi;
    // M_10_11 = -cos(phi)
    let m_10_11 = minus_cos_phi;
    // M_10_12 = -sin(phi)
    let m_10_12 = minus_sin_phi;
    // M_11_1 = IByy*cos(phi)
    let m_11_1 = IByy * cos_phi;
    // M_11_11 = sin(phi)
    let m_11_11 = sin_phi;
    // M_11_12 = -cos(phi)
    let m_11_12 = minus_cos_phi;
    // M_12_2 = IBzz
    let m_12_2 = IBzz;
    let zero = S::int(0);
    [
        [m_1_1, zero, m_1_3, zero, zero, zero, zero, m_1_8, zero, zero, zero, zero],
        [zero, zero, zero, m_2_4, zero, zero, zero, zero, m_2_9, zero, zero, zero],
        [zero, zero, zero, zero, m_3_5, zero, zero, zero, zero, m_3_10, zero, zero],
        [zero, zero, zero, m_4_4, zero, m_4_6, zero, zero, m_4_9, zero, m_4_11, zero],
        [m_5_1, zero, m_5_3, zero, zero, zero, zero, m_5_8, zero, zero, zero, m_5_12],
        [zero, zero, zero, zero, zero, zero, m_6_7, zero, zero, zero, zero, zero],
        [m_7_1, zero, zero, zero, zero, zero, zero, m_7_8, m_7_9, zero, zero, zero],
        [m_8_1, zero, zero, zero, zero, zero, zero, m_8_8, m_8_9, zero, zero, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, m_9_10, zero, zero],
        [m_10_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_10_11, m_10_12],
        [m_11_1, zero, zero, zero, zero, zero, zero, zero, zero, zero, m_11_11, m_11_12],
        [zero, m_12_2, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (omega', alpha', pin1, pin2, pin3, pin_torque1, pin_torque3, bearing1, bearing2, bearing3, bearing_torque1, bearing_torque2).
///
/// 27 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 12] {
    let Parameters { mA, mB, lA, lB, IBxx, IByy, IBzz, g, .. } = *p;
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Shared terms.
    let g_sin_theta = g * sin_theta;
    let omega_sq = omega * omega;
    let g_cos_theta = g * cos_theta;
    let mb_g_sin_theta = mB * g_sin_theta;
    // IBxx - IByy
    let ibxx_minus_ibyy = IBxx - IByy;
    let omega_alpha = omega * alpha;
    // Values.
    // f_1 = -mA*g*sin(theta)
    let f_1 = -mA * g_sin_theta;
    // f_3 = mA*(g*cos(theta) + lA*omega^2)
    let f_3 = mA * lA.mul_add(omega_sq, g_cos_theta);
    // f_7 = -mB*g*sin(theta)*cos(phi)
    let f_7 = -mb_g_sin_theta * cos_phi;
    // f_8 = mB*g*sin(theta)*sin(phi)
    let f_8 = mb_g_sin_theta * sin_phi;
    // f_9 = mB*(g*cos(theta) + lB*omega^2)
    let f_9 = mB * lB.mul_add(omega_sq, g_cos_theta);
    // f_10 = omega*alpha*cos(phi)*(IByy - IBxx - IBzz)
    let f_10 = -omega_alpha * cos_phi * (IBzz + ibxx_minus_ibyy);
    // f_11 = omega*alpha*sin(phi)*(IByy - IBxx + IBzz)
    let f_11 = omega_alpha * sin_phi * (IBzz - ibxx_minus_ibyy);
    // f_12 = omega^2*sin(phi)*cos(phi)*(IBxx - IByy)
    let f_12 = omega_sq * ibxx_minus_ibyy * sin_phi * cos_phi;
    let zero = S::int(0);
    [f_1, zero, f_3, zero, zero, zero, f_7, f_8, f_9, f_10, f_11, f_12]
}

/// The accelerations (omega', alpha'), solved for when this code was generated.
///
/// 22 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 2] {
    let Parameters { mA, mB, lA, lB, IAxx, IBxx, IByy, IBzz, g } = *p;
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, _) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // cos(phi)*(IBxx - IByy)
    let omega_dot_of_place = cos_phi * (IBxx - IByy);
    let ma_la = mA * lA;
    let mb_lb = mB * lB;
    let omega_dot_of_omega = omega * omega_dot_of_place * sin_phi;
    // omega' = -(g*sin(theta)*(mA*lA + mB*lB) + 2*omega*alpha*sin(phi)*cos(phi)*(IBxx - IByy))/(mA*lA^2 +
    //   mB*lB^2 + IAxx + IByy*cos(phi)^2 + IBxx*(1 - cos(phi)^2))
    let omega_dot = (g * sin_theta * (ma_la + mb_lb) + S::int(2) * alpha * omega_dot_of_omega)
        / (omega_dot_of_place.mul_add(cos_phi, -IAxx) - IBxx - lA * ma_la - lB * mb_lb);
    // alpha' = omega^2*sin(phi)*cos(phi)*(IBxx - IByy)/IBzz
    let alpha_dot = omega * omega_dot_of_omega / IBzz;
    [omega_dot, alpha_dot]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 22 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let Parameters { mA, mB, lA, lB, IAxx, IBxx, IByy, IBzz, g } = *p;
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, _) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // cos(phi)*(IBxx - IByy)
    let omega_dot_of_place = cos_phi * (IBxx - IByy);
    let ma_la = mA * lA;
    let mb_lb = mB * lB;
    let omega_dot_of_omega = omega * omega_dot_of_place * sin_phi;
    // omega' = -(g*sin(theta)*(mA*lA + mB*lB) + 2*omega*alpha*sin(phi)*cos(phi)*(IBxx - IByy))/(mA*lA^2 +
    //   mB*lB^2 + IAxx + IByy*cos(phi)^2 + IBxx*(1 - cos(phi)^2))
    let omega_dot = (g * sin_theta * (ma_la + mb_lb) + S::int(2) * alpha * omega_dot_of_omega)
        / (omega_dot_of_place.mul_add(cos_phi, -IAxx) - IBxx - lA * ma_la - lB * mb_lb);
    // alpha' = omega^2*sin(phi)*cos(phi)*(IBxx - IByy)/IBzz
    let alpha_dot = omega * omega_dot_of_omega / IBzz;
    // Values.
    // theta' = omega
    let theta_dot_value = omega;
    // phi' = alpha
    let phi_dot_value = alpha;
    ([theta_dot_value, phi_dot_value], [omega_dot, alpha_dot])
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
            parameters: 9,
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
