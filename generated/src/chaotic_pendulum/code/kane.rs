//! Chaotic pendulum: a swinging rod with a plate turning about it: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/chaotic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows omega, alpha.
///
/// 11 operations, 1 sine and cosine.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _u: &[S; 2],
) -> [[S; 2]; 2] {
    let Parameters { mA, mB, lA, lB, IAxx, IBxx, IByy, IBzz, .. } = *p;
    let [_, phi] = *q;
    // Sines and cosines.
    let (_, cos_phi) = phi.sin_cos();
    // Entries that are not zero; upper triangle.
    // M11 = mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2
    let m11 = mA * lA * lA + mB * lB * lB + IAxx + IBxx + cos_phi * cos_phi * (IByy - IBxx);
    // M22 = IBzz
    let m22 = IBzz;
    let zero = S::int(0);
    [[m11, zero], [zero, m22]]
}

/// Right-hand side of the linear system; unknowns (omega', alpha').
///
/// 14 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 2] {
    let Parameters { mA, mB, lA, lB, IBxx, IByy, g, .. } = *p;
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, _) = theta.sin_cos();
    // Shared terms.
    // omega*sin(phi)*cos(phi)*(IBxx - IByy)
    let f1_of_omega = omega * sin_phi * cos_phi * (IBxx - IByy);
    // Values.
    // f1 = 2*omega*alpha*sin(phi)*cos(phi)*(IByy - IBxx) - g*sin(theta)*(mA*lA + mB*lB)
    let f1 = -g * sin_theta * mB.mul_add(lB, mA * lA) - S::int(2) * alpha * f1_of_omega;
    // f2 = omega^2*sin(phi)*cos(phi)*(IBxx - IByy)
    let f2 = omega * f1_of_omega;
    [f1, f2]
}

/// The accelerations (omega', alpha'), solved for when this code was generated.
///
/// 26 operations, 2 sines and cosines.
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
    let ma_la = mA * lA;
    let mb_lb = mB * lB;
    // omega*sin(phi)*cos(phi)*(IBxx - IByy)
    let omega_dot_of_omega = omega * sin_phi * cos_phi * (IBxx - IByy);
    // omega' = -(g*sin(theta)*(mA*lA + mB*lB) + 2*omega*alpha*sin(phi)*cos(phi)*(IBxx - IByy))/(mA*lA^2 +
    //   mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2)
    let omega_dot = -(g * sin_theta * (ma_la + mb_lb) + S::int(2) * alpha * omega_dot_of_omega)
        / (lA.mul_add(ma_la, IAxx + IBxx * sin_phi * sin_phi + IByy * cos_phi * cos_phi)
            + lB * mb_lb);
    // alpha' = omega^2*sin(phi)*cos(phi)*(IBxx - IByy)/IBzz
    let alpha_dot = omega * omega_dot_of_omega / IBzz;
    [omega_dot, alpha_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    u: &[S; 2],
) -> [S; 2] {
    let [omega, alpha] = *u;
    // Values.
    // theta' = omega
    let theta_dot_value = omega;
    // phi' = alpha
    let phi_dot_value = alpha;
    [theta_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 18 operations, 1 sine and cosine.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> S {
    let Parameters { mA, mB, lA, lB, IAxx, IBxx, IByy, IBzz, .. } = *p;
    let [_, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Shared terms.
    // omega^2*(mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2) + IBzz*alpha^2
    let energy_of_omega_alpha = omega * omega
        * (mA * lA * lA + mB * lB * lB + IAxx + IBxx * sin_phi * sin_phi
            + IByy * cos_phi * cos_phi) + IBzz * alpha * alpha;
    // Values.
    // T = omega^2*(mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2)/2 + IBzz*alpha^2/2
    let energy = S::ratio(1, 2) * energy_of_omega_alpha;
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 6 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2]) -> S {
    let Parameters { mA, mB, lA, lB, g, .. } = *p;
    let [theta, _] = *q;
    // Sines and cosines.
    let (_, cos_theta) = theta.sin_cos();
    // Values.
    // V = -g*cos(theta)*(mA*lA + mB*lB)
    let energy = -g * cos_theta * mB.mul_add(lB, mA * lA);
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 26 operations, 2 sines and cosines.
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
    let ma_la = mA * lA;
    let mb_lb = mB * lB;
    // omega*sin(phi)*cos(phi)*(IBxx - IByy)
    let omega_dot_of_omega = omega * sin_phi * cos_phi * (IBxx - IByy);
    // omega' = -(g*sin(theta)*(mA*lA + mB*lB) + 2*omega*alpha*sin(phi)*cos(phi)*(IBxx - IByy))/(mA*lA^2 +
    //   mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2)
    let omega_dot = -(g * sin_theta * (ma_la + mb_lb) + S::int(2) * alpha * omega_dot_of_omega)
        / (lA.mul_add(ma_la, IAxx + IBxx * sin_phi * sin_phi + IByy * cos_phi * cos_phi)
            + lB * mb_lb);
    // alpha' = omega^2*sin(phi)*cos(phi)*(IBxx - IByy)/IBzz
    let alpha_dot = omega * omega_dot_of_omega / IBzz;
    // Values.
    // theta' = omega
    let theta_dot_value = omega;
    // phi' = alpha
    let phi_dot_value = alpha;
    ([theta_dot_value, phi_dot_value], [omega_dot, alpha_dot])
}

/// Inverse dynamics: the generalized forces along (omega, alpha) that must act beside the loads of the model for the accelerations to be (omega', alpha').
///
/// 25 operations, 2 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { mA, mB, lA, lB, IAxx, IBxx, IByy, IBzz, g } = *p;
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    let [omega_dot, alpha_dot] = *v_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, _) = theta.sin_cos();
    // Shared terms.
    let ma_la = mA * lA;
    let mb_lb = mB * lB;
    let omega_sin_phi = omega * sin_phi;
    // cos(phi)*(IBxx - IByy)
    let tau1_of_place = cos_phi * (IBxx - IByy);
    // IAxx + IBxx
    let iaxx_plus_ibxx = IAxx + IBxx;
    // lA*ma_la + lB*mb_lb
    let la_ma_la_plus_lb_mb_lb = lB.mul_add(mb_lb, lA * ma_la);
    // Values.
    // tau1 = g*sin(theta)*(mA*lA + mB*lB) + 2*omega*alpha*sin(phi)*cos(phi)*(IBxx - IByy) +
    //   omega'*(mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2)
    let tau1 = g * sin_theta * (ma_la + mb_lb)
        + tau1_of_place * (-omega_dot).mul_add(cos_phi, S::int(2) * alpha * omega_sin_phi)
        + omega_dot * (iaxx_plus_ibxx + la_ma_la_plus_lb_mb_lb);
    // tau2 = omega^2*sin(phi)*cos(phi)*(IByy - IBxx) + IBzz*alpha'
    let tau2 = (-(omega * omega_sin_phi)).mul_add(tau1_of_place, IBzz * alpha_dot);
    [tau1, tau2]
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

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 9,
            coordinates: 2,
            variables: 2,
            speeds: 2,
            reactions: 0,
        }
    }
    fn symmetric(&self) -> bool {
        true
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
