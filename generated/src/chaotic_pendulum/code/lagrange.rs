//! Chaotic pendulum: a swinging rod with a plate turning about it: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/chaotic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

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

/// Jacobian of the derivative by the state; columns theta, phi, theta', phi'.
///
/// 51 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [[S; 4]; 4] {
    let Parameters { mA, mB, lA, lB, IAxx, IBxx, IByy, IBzz, g } = *p;
    let [theta, phi] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let cos_phi_sq = cos_phi * cos_phi;
    let ma_la = mA * lA;
    let mb_lb = mB * lB;
    // lA*ma_la + lB*mb_lb
    let la_ma_la_plus_lb_mb_lb = lB.mul_add(mb_lb, lA * ma_la);
    // IAxx + IByy*cos_phi_sq
    let theta_ddot_by_theta_of_place = IByy.mul_add(cos_phi_sq, IAxx);
    // la_ma_la_plus_lb_mb_lb + theta_ddot_by_theta_of_place
    let theta_ddot_by_theta_of_place_2 = la_ma_la_plus_lb_mb_lb + theta_ddot_by_theta_of_place;
    // g*(ma_la + mb_lb)
    let theta_ddot_by_theta_of_place_3 = g * (ma_la + mb_lb);
    // theta_ddot_by_theta = -g*cos(theta)*(mA*lA + mB*lB)/(mA*lA^2 + mB*lB^2 + IAxx + IByy*cos(phi)^2 +
    //   IBxx*(1 - cos(phi)^2))
    let theta_ddot_by_theta = -theta_ddot_by_theta_of_place_3 * cos_theta
        / (IBxx * (S::int(1) - cos_phi_sq) + theta_ddot_by_theta_of_place_2);
    let sin_phi_sq = sin_phi * sin_phi;
    // 1/(theta_ddot_by_theta_of_place_2 + IBxx*sin_phi_sq)
    let theta_ddot_by_phi_of_place = S::int(1)
        / IBxx.mul_add(sin_phi_sq, theta_ddot_by_theta_of_place_2);
    let theta_ddot_by_phi_of_place_2 = S::int(2) * theta_ddot_by_phi_of_place;
    let sin_phi_cos_phi = sin_phi * cos_phi;
    // IByy - IBxx
    let minus_ibxx_plus_ibyy = IByy - IBxx;
    // -minus_ibxx_plus_ibyy
    let theta_ddot_by_phi_of_ibxx_ibyy = -minus_ibxx_plus_ibyy;
    let theta_ddot_by_phi_of_theta_dot = theta_dot * theta_ddot_by_phi_of_ibxx_ibyy;
    let theta_ddot_by_phi_of_motion = phi_dot * theta_ddot_by_phi_of_theta_dot;
    let sin_phi_cos_phi_doubled = S::int(2) * sin_phi_cos_phi;
    // theta_ddot_by_phi = 2*(IBxx*sin(phi)*cos(phi) - IByy*sin(phi)*cos(phi))*(g*sin(theta)*(mA*lA +
    //   mB*lB) + 2*theta'*phi'*sin(phi)*cos(phi)*(IBxx - IByy))/(mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2
    //   + IByy*cos(phi)^2)^2 - 2*(theta'*phi'*sin(phi)^2*(IByy - IBxx) + theta'*phi'*cos(phi)^2*(IBxx -
    //   IByy))/(mA*lA^2 + mB*lB^2 + IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2)
    let theta_ddot_by_phi = -theta_ddot_by_phi_of_place_2
        * (theta_ddot_by_phi_of_motion * (cos_phi_sq - sin_phi_sq)
            + theta_ddot_by_phi_of_place * sin_phi_cos_phi * minus_ibxx_plus_ibyy
                * theta_ddot_by_phi_of_motion
                    .mul_add(
                        sin_phi_cos_phi_doubled,
                        theta_ddot_by_theta_of_place_3 * sin_theta,
                    ));
    let phi_ddot_by_phi_of_theta_dot = theta_ddot_by_phi_of_theta_dot / IBzz;
    // phi_ddot_by_phi = theta'^2*(IBxx - IByy)*(2*cos(phi)^2 - 1)/IBzz
    let phi_ddot_by_phi = theta_dot * phi_ddot_by_phi_of_theta_dot
        * cos_phi_sq.mul_add(S::int(2), -S::int(1));
    let theta_ddot_by_theta_dot_of_place = theta_ddot_by_phi_of_place_2 * sin_phi_cos_phi;
    // theta_ddot_by_theta_dot = 2*phi'*sin(phi)*cos(phi)*(IByy - IBxx)/(mA*lA^2 + mB*lB^2 + IAxx +
    //   IBxx*sin(phi)^2 + IByy*cos(phi)^2)
    let theta_ddot_by_theta_dot = -phi_dot * theta_ddot_by_phi_of_ibxx_ibyy
        * theta_ddot_by_theta_dot_of_place;
    // phi_ddot_by_theta_dot = 2*theta'*sin(phi)*cos(phi)*(IBxx - IByy)/IBzz
    let phi_ddot_by_theta_dot = sin_phi_cos_phi_doubled * phi_ddot_by_phi_of_theta_dot;
    // theta_ddot_by_phi_dot = 2*theta'*sin(phi)*cos(phi)*(IByy - IBxx)/(mA*lA^2 + mB*lB^2 + IAxx +
    //   IBxx*sin(phi)^2 + IByy*cos(phi)^2)
    let theta_ddot_by_phi_dot = -theta_ddot_by_phi_of_theta_dot * theta_ddot_by_theta_dot_of_place;
    // Entries that are not zero.
    // d(theta')/d(theta') = 1
    let theta_dot_by_theta_dot_value = S::int(1);
    // d(phi')/d(phi') = 1
    let phi_dot_by_phi_dot_value = S::int(1);
    let zero = S::int(0);
    [
        [zero, zero, theta_dot_by_theta_dot_value, zero],
        [zero, zero, zero, phi_dot_by_phi_dot_value],
        [
            theta_ddot_by_theta, theta_ddot_by_phi, theta_ddot_by_theta_dot, theta_ddot_by_phi_dot,
        ],
        [zero, phi_ddot_by_phi, phi_ddot_by_theta_dot, zero],
    ]
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

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 11 convolutions and 8 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 4]],
    history: &mut [Factors<S, 16>],
) {
    let Parameters { mA, mB, lA, lB, IAxx, IBxx, IByy, IBzz, g } = *p;
    let [theta_0, phi_0, theta_dot_0, phi_dot_0] = series[0];
    // Constant in time.
    // weight = mA*lA^2 + mB*lB^2 + IAxx
    let weight = mA * lA * lA + mB * lB * lB + IAxx;
    // g_ma_la_plus_mb_lb = g*(mA*lA + mB*lB)
    let g_ma_la_plus_mb_lb = g * mB.mul_add(lB, mA * lA);
    // weight_2 = 2*IBxx - 2*IByy
    let weight_2 = (-IByy).mul_add(S::int(2), S::int(2) * IBxx);
    // ibxx_minus_ibyy_by_ibzz = (IBxx - IByy)/IBzz
    let ibxx_minus_ibyy_by_ibzz = (IBxx - IByy) / IBzz;
    // Order 0.
    let (sin_phi_0, cos_phi_0) = phi_0.sin_cos();
    let sin_phi_sq_0 = sin_phi_0 * sin_phi_0;
    let cos_phi_sq_0 = cos_phi_0 * cos_phi_0;
    let theta_ddot_of_place_0 = cos_phi_sq_0
        .mul_add(IByy, sin_phi_sq_0.mul_add(IBxx, weight));
    let over_theta_ddot_of_place = S::int(1) / theta_ddot_of_place_0;
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    let theta_dot_sin_phi_0 = theta_dot_0 * sin_phi_0;
    let theta_ddot_of_theta_dot_0 = cos_phi_0 * theta_dot_sin_phi_0;
    let theta_ddot_of_motion_0 = phi_dot_0 * theta_ddot_of_theta_dot_0;
    let theta_ddot_of_motion_2_0 = theta_ddot_of_motion_0
        .mul_add(weight_2, g_ma_la_plus_mb_lb * sin_theta_0);
    let theta_ddot_of_motion_3_0 = theta_ddot_of_motion_2_0 * over_theta_ddot_of_place;
    let phi_ddot_of_theta_dot_0 = theta_dot_0 * theta_ddot_of_theta_dot_0;
    // Order 1: the rates, and what follows from them.
    let theta_1 = theta_dot_0;
    let phi_1 = phi_dot_0;
    let theta_dot_1 = -theta_ddot_of_motion_3_0;
    let phi_dot_1 = ibxx_minus_ibyy_by_ibzz * phi_ddot_of_theta_dot_0;
    if series.len() > 1 {
        series[1] = [theta_1, phi_1, theta_dot_1, phi_dot_1];
    }
    let sin_phi_1 = phi_1 * cos_phi_0;
    let cos_phi_1 = -phi_1 * sin_phi_0;
    let sin_phi_sq_1 = sin_phi_1 * (sin_phi_0 + sin_phi_0);
    let cos_phi_sq_1 = cos_phi_1 * (cos_phi_0 + cos_phi_0);
    let theta_ddot_of_place_1 = cos_phi_sq_1.mul_add(IByy, IBxx * sin_phi_sq_1);
    let sin_theta_1 = theta_1 * cos_theta_0;
    let cos_theta_1 = -theta_1 * sin_theta_0;
    let theta_dot_sin_phi_1 = sin_phi_1.mul_add(theta_dot_0, theta_dot_1 * sin_phi_0);
    let theta_ddot_of_theta_dot_1 = theta_dot_sin_phi_1
        .mul_add(cos_phi_0, cos_phi_1 * theta_dot_sin_phi_0);
    let theta_ddot_of_motion_1 = theta_ddot_of_theta_dot_1
        .mul_add(phi_dot_0, phi_dot_1 * theta_ddot_of_theta_dot_0);
    let theta_ddot_of_motion_2_1 = theta_ddot_of_motion_1
        .mul_add(weight_2, g_ma_la_plus_mb_lb * sin_theta_1);
    let theta_ddot_of_motion_3_1 = theta_ddot_of_place_1
        .mul_add(
            -(theta_ddot_of_motion_3_0 * over_theta_ddot_of_place),
            theta_ddot_of_motion_2_1 * over_theta_ddot_of_place,
        );
    let phi_ddot_of_theta_dot_1 = theta_ddot_of_theta_dot_1
        .mul_add(theta_dot_0, theta_dot_1 * theta_ddot_of_theta_dot_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                phi_1, phi_1, sin_phi_1, cos_phi_1, theta_1, theta_1, theta_dot_1, cos_phi_1,
                phi_dot_1, theta_ddot_of_place_1, theta_dot_1,
            ]),
            padded([
                cos_phi_1, sin_phi_1, sin_phi_1, cos_phi_1, cos_theta_1, sin_theta_1, sin_phi_1,
                theta_dot_sin_phi_1, theta_ddot_of_theta_dot_1, theta_ddot_of_motion_3_1,
                theta_ddot_of_theta_dot_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta_last = theta_1;
    let mut phi_last = phi_1;
    let mut theta_dot_last = theta_dot_1;
    let mut phi_dot_last = phi_dot_1;
    let mut sin_phi_last = sin_phi_1;
    let mut cos_phi_last = cos_phi_1;
    let mut theta_ddot_of_place_last = theta_ddot_of_place_1;
    let mut sin_theta_last = sin_theta_1;
    let mut cos_theta_last = cos_theta_1;
    let mut theta_dot_sin_phi_last = theta_dot_sin_phi_1;
    let mut theta_ddot_of_theta_dot_last = theta_ddot_of_theta_dot_1;
    let mut theta_ddot_of_motion_3_last = theta_ddot_of_motion_3_1;
    let mut next = [S::int(0); 16];
    // Rates at order k - 1.
    let mut theta_rate = theta_dot_1;
    let mut phi_rate = phi_dot_1;
    let mut theta_dot_rate = -theta_ddot_of_motion_3_1;
    let mut phi_dot_rate = ibxx_minus_ibyy_by_ibzz * phi_ddot_of_theta_dot_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let theta = theta_rate * over_k;
        let phi = phi_rate * over_k;
        let theta_dot = theta_dot_rate * over_k;
        let phi_dot = phi_dot_rate * over_k;
        series[order] = [theta, phi, theta_dot, phi_dot];
        if order + 1 == series.len() {
            break;
        }
        let count = S::int(order as i64);
        let sums = if order % 2 == 0 {
            // All convolutions of order k, and of order k + 1 but for the terms with coefficients of order
            //   k.
            let pair = pair_sums(&history[..order]);
            next = pair[1];
            pair[0]
        } else {
            // Those terms, which also have coefficients of order 1.
            padded([
                phi_1
                    .mul_add(
                        cos_phi_last,
                        (count_last * phi_last).mul_add(cos_phi_1, next[0]),
                    ),
                phi_1
                    .mul_add(
                        sin_phi_last,
                        (count_last * phi_last).mul_add(sin_phi_1, next[1]),
                    ),
                (sin_phi_1 + sin_phi_1).mul_add(sin_phi_last, next[2]),
                (cos_phi_1 + cos_phi_1).mul_add(cos_phi_last, next[3]),
                theta_1
                    .mul_add(
                        cos_theta_last,
                        (count_last * theta_last).mul_add(cos_theta_1, next[4]),
                    ),
                theta_1
                    .mul_add(
                        sin_theta_last,
                        (count_last * theta_last).mul_add(sin_theta_1, next[5]),
                    ),
                theta_dot_1
                    .mul_add(sin_phi_last, theta_dot_last.mul_add(sin_phi_1, next[6])),
                cos_phi_1
                    .mul_add(
                        theta_dot_sin_phi_last,
                        cos_phi_last.mul_add(theta_dot_sin_phi_1, next[7]),
                    ),
                phi_dot_1
                    .mul_add(
                        theta_ddot_of_theta_dot_last,
                        phi_dot_last.mul_add(theta_ddot_of_theta_dot_1, next[8]),
                    ),
                theta_ddot_of_place_1
                    .mul_add(
                        theta_ddot_of_motion_3_last,
                        theta_ddot_of_place_last
                            .mul_add(theta_ddot_of_motion_3_1, next[9]),
                    ),
                theta_dot_1
                    .mul_add(
                        theta_ddot_of_theta_dot_last,
                        theta_dot_last.mul_add(theta_ddot_of_theta_dot_1, next[10]),
                    ),
            ])
        };
        // sin_phi = sin(phi)
        let sin_phi = phi.mul_add(cos_phi_0, sums[0] * over_k);
        // cos_phi = cos(phi)
        let cos_phi = -phi.mul_add(sin_phi_0, sums[1] * over_k);
        // sin_phi_sq = sin_phi*sin_phi
        let sin_phi_sq = sin_phi.mul_add(sin_phi_0 + sin_phi_0, sums[2]);
        // cos_phi_sq = cos_phi*cos_phi
        let cos_phi_sq = cos_phi.mul_add(cos_phi_0 + cos_phi_0, sums[3]);
        // theta_ddot_of_place = weight + IBxx*sin_phi_sq + IByy*cos_phi_sq
        let theta_ddot_of_place = cos_phi_sq.mul_add(IByy, IBxx * sin_phi_sq);
        // sin_theta = sin(theta)
        let sin_theta = theta.mul_add(cos_theta_0, sums[4] * over_k);
        // cos_theta = cos(theta)
        let cos_theta = -theta.mul_add(sin_theta_0, sums[5] * over_k);
        // theta_dot_sin_phi = theta_dot*sin_phi
        let theta_dot_sin_phi = sin_phi
            .mul_add(theta_dot_0, theta_dot.mul_add(sin_phi_0, sums[6]));
        // theta_ddot_of_theta_dot = cos_phi*theta_dot_sin_phi
        let theta_ddot_of_theta_dot = theta_dot_sin_phi
            .mul_add(cos_phi_0, cos_phi.mul_add(theta_dot_sin_phi_0, sums[7]));
        // theta_ddot_of_motion = phi_dot*theta_ddot_of_theta_dot
        let theta_ddot_of_motion = theta_ddot_of_theta_dot
            .mul_add(phi_dot_0, phi_dot.mul_add(theta_ddot_of_theta_dot_0, sums[8]));
        // theta_ddot_of_motion_2 = g_ma_la_plus_mb_lb*sin_theta + weight_2*theta_ddot_of_motion
        let theta_ddot_of_motion_2 = theta_ddot_of_motion
            .mul_add(weight_2, g_ma_la_plus_mb_lb * sin_theta);
        // theta_ddot_of_motion_3 = theta_ddot_of_motion_2/theta_ddot_of_place
        let theta_ddot_of_motion_3 = theta_ddot_of_motion_2
            .mul_add(
                over_theta_ddot_of_place,
                -(theta_ddot_of_place.mul_add(theta_ddot_of_motion_3_0, sums[9])
                    * over_theta_ddot_of_place),
            );
        // phi_ddot_of_theta_dot = theta_dot*theta_ddot_of_theta_dot
        let phi_ddot_of_theta_dot = theta_ddot_of_theta_dot
            .mul_add(
                theta_dot_0,
                theta_dot.mul_add(theta_ddot_of_theta_dot_0, sums[10]),
            );
        theta_rate = theta_dot;
        phi_rate = phi_dot;
        theta_dot_rate = -theta_ddot_of_motion_3;
        phi_dot_rate = ibxx_minus_ibyy_by_ibzz * phi_ddot_of_theta_dot;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * phi,
                count * phi,
                sin_phi, cos_phi,
                count * theta,
                count * theta,
                theta_dot, cos_phi, phi_dot, theta_ddot_of_place, theta_dot,
            ]),
            padded([
                cos_phi, sin_phi, sin_phi, cos_phi, cos_theta, sin_theta, sin_phi,
                theta_dot_sin_phi, theta_ddot_of_theta_dot, theta_ddot_of_motion_3,
                theta_ddot_of_theta_dot,
            ]),
        ];
        count_last = count;
        theta_last = theta;
        phi_last = phi;
        theta_dot_last = theta_dot;
        phi_dot_last = phi_dot;
        sin_phi_last = sin_phi;
        cos_phi_last = cos_phi;
        theta_ddot_of_place_last = theta_ddot_of_place;
        sin_theta_last = sin_theta;
        cos_theta_last = cos_theta;
        theta_dot_sin_phi_last = theta_dot_sin_phi;
        theta_ddot_of_theta_dot_last = theta_ddot_of_theta_dot;
        theta_ddot_of_motion_3_last = theta_ddot_of_motion_3;
    }
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
        out.copy_from_slice(
            jacobian(&Parameters::from_slice(p), array(q), array(v)).as_flattened(),
        );
    }
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, order: usize) -> usize {
        32 * order + SLACK
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
    slice.try_into().expect("a slice of the length that System states")
}
