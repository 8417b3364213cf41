//! Chaotic pendulum: a swinging rod with a plate turning about it: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/chaotic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows theta, phi.
///
/// 11 operations, 1 sine and cosine.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _q_dot: &[S; 2],
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

/// Right-hand side of the linear system; unknowns (theta'', phi'').
///
/// 14 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> [S; 2] {
    let Parameters { mA, mB, lA, lB, IBxx, IByy, g, .. } = *p;
    let [theta, phi] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, _) = theta.sin_cos();
    // Shared terms.
    // theta'*sin(phi)*cos(phi)*(IBxx - IByy)
    let f1_of_theta_dot = theta_dot * sin_phi * cos_phi * (IBxx - IByy);
    // Values.
    // f1 = 2*theta'*phi'*sin(phi)*cos(phi)*(IByy - IBxx) - g*sin(theta)*(mA*lA + mB*lB)
    let f1 = -g * sin_theta * mB.mul_add(lB, mA * lA) - S::int(2) * phi_dot * f1_of_theta_dot;
    // f2 = theta'^2*sin(phi)*cos(phi)*(IBxx - IByy)
    let f2 = theta_dot * f1_of_theta_dot;
    [f1, f2]
}

/// The accelerations (theta'', phi''), solved for when this code was generated.
///
/// 26 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { mA, mB, lA, lB, IAxx, IBxx, IByy, IBzz, g } = *p;
    let [theta, phi] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, _) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let ma_la = mA * lA;
    let mb_lb = mB * lB;
    // theta'*sin(phi)*cos(phi)*(IBxx - IByy)
    let theta_ddot_of_theta_dot = theta_dot * sin_phi * cos_phi * (IBxx - IByy);
    // theta'' = -(g*sin(theta)*(mA*lA + mB*lB) + 2*theta'*phi'*sin(phi)*cos(phi)*(IBxx - IByy))/(mA*lA^2 +
    //   mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2)
    let theta_ddot = -(g * sin_theta * (ma_la + mb_lb)
        + S::int(2) * phi_dot * theta_ddot_of_theta_dot)
        / (lA.mul_add(ma_la, IAxx + IBxx * sin_phi * sin_phi + IByy * cos_phi * cos_phi)
            + lB * mb_lb);
    // phi'' = theta'^2*sin(phi)*cos(phi)*(IBxx - IByy)/IBzz
    let phi_ddot = theta_dot * theta_ddot_of_theta_dot / IBzz;
    [theta_ddot, phi_ddot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let [theta_dot, phi_dot] = *q_dot;
    // Values.
    // theta'
    let theta_dot_value = theta_dot;
    // phi'
    let phi_dot_value = phi_dot;
    [theta_dot_value, phi_dot_value]
}

/// Kinetic energy T.
///
/// 18 operations, 1 sine and cosine.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> S {
    let Parameters { mA, mB, lA, lB, IAxx, IBxx, IByy, IBzz, .. } = *p;
    let [_, phi] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Shared terms.
    // theta'^2*(mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2) + IBzz*phi'^2
    let energy_of_motion = theta_dot * theta_dot
        * (mA * lA * lA + mB * lB * lB + IAxx + IBxx * sin_phi * sin_phi
            + IByy * cos_phi * cos_phi) + IBzz * phi_dot * phi_dot;
    // Values.
    // T = theta'^2*(mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2)/2 + IBzz*phi'^2/2
    let energy = S::ratio(1, 2) * energy_of_motion;
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 0 operations.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let [theta_dot, phi_dot] = *q_dot;
    // Values.
    // omega = theta'
    let omega_value = theta_dot;
    // alpha = phi'
    let alpha_value = phi_dot;
    [omega_value, alpha_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 0 operations.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    _q_dot: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let [theta_ddot, phi_ddot] = *v_dot;
    // Values.
    // omega' = theta''
    let omega_dot_value = theta_ddot;
    // alpha' = phi''
    let alpha_dot_value = phi_ddot;
    [omega_dot_value, alpha_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 0 operations.
#[must_use]
pub fn motion_variables<S: Scalar>(
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

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 26 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let Parameters { mA, mB, lA, lB, IAxx, IBxx, IByy, IBzz, g } = *p;
    let [theta, phi] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, _) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let ma_la = mA * lA;
    let mb_lb = mB * lB;
    // theta'*sin(phi)*cos(phi)*(IBxx - IByy)
    let theta_ddot_of_theta_dot = theta_dot * sin_phi * cos_phi * (IBxx - IByy);
    // theta'' = -(g*sin(theta)*(mA*lA + mB*lB) + 2*theta'*phi'*sin(phi)*cos(phi)*(IBxx - IByy))/(mA*lA^2 +
    //   mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2)
    let theta_ddot = -(g * sin_theta * (ma_la + mb_lb)
        + S::int(2) * phi_dot * theta_ddot_of_theta_dot)
        / (lA.mul_add(ma_la, IAxx + IBxx * sin_phi * sin_phi + IByy * cos_phi * cos_phi)
            + lB * mb_lb);
    // phi'' = theta'^2*sin(phi)*cos(phi)*(IBxx - IByy)/IBzz
    let phi_ddot = theta_dot * theta_ddot_of_theta_dot / IBzz;
    // Values.
    // theta'
    let theta_dot_value = theta_dot;
    // phi'
    let phi_dot_value = phi_dot;
    ([theta_dot_value, phi_dot_value], [theta_ddot, phi_ddot])
}

/// Inverse dynamics: the generalized forces along (theta', phi') that must act beside the loads of the model for the accelerations to be (theta'', phi'').
///
/// 25 operations, 2 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { mA, mB, lA, lB, IAxx, IBxx, IByy, IBzz, g } = *p;
    let [theta, phi] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    let [theta_ddot, phi_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, _) = theta.sin_cos();
    // Shared terms.
    let ma_la = mA * lA;
    let mb_lb = mB * lB;
    let theta_dot_sin_phi = theta_dot * sin_phi;
    // cos(phi)*(IBxx - IByy)
    let tau1_of_place = cos_phi * (IBxx - IByy);
    // IAxx + IBxx
    let iaxx_plus_ibxx = IAxx + IBxx;
    // lA*ma_la + lB*mb_lb
    let la_ma_la_plus_lb_mb_lb = lB.mul_add(mb_lb, lA * ma_la);
    // Values.
    // tau1 = g*sin(theta)*(mA*lA + mB*lB) + 2*theta'*phi'*sin(phi)*cos(phi)*(IBxx - IByy) +
    //   theta''*(mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2)
    let tau1 = g * sin_theta * (ma_la + mb_lb)
        + tau1_of_place * (-theta_ddot).mul_add(cos_phi, S::int(2) * phi_dot * theta_dot_sin_phi)
        + theta_ddot * (iaxx_plus_ibxx + la_ma_la_plus_lb_mb_lb);
    // tau2 = theta'^2*sin(phi)*cos(phi)*(IByy - IBxx) + IBzz*phi''
    let tau2 = (-(theta_dot * theta_dot_sin_phi))
        .mul_add(tau1_of_place, IBzz * phi_ddot);
    [tau1, tau2]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
    direction: &[S; 4],
) -> [S; 4] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: q_dot[i],
        slope: direction[2 + i],
    });
    let (of_q, of_v) = derivative(&p, &q, &v);
    let mut slopes = of_q.into_iter().chain(of_v).map(|rate| rate.slope);
    core::array::from_fn(|_| {
        slopes.next().expect("a slope for each component of the state")
    })
}

/// Lagrange's equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Lagrange;

impl<S: Scalar> System<S> for Lagrange {
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
    fn generalized_speeds(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &generalized_speeds(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn generalized_speed_rates(
        &self,
        p: &[S],
        q: &[S],
        v: &[S],
        v_dot: &[S],
        out: &mut [S],
    ) {
        out.copy_from_slice(
            &generalized_speed_rates(
                &Parameters::from_slice(p),
                array(q),
                array(v),
                array(v_dot),
            ),
        );
    }
    fn motion_variables(&self, p: &[S], q: &[S], u: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &motion_variables(&Parameters::from_slice(p), array(q), array(u)),
        );
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
