//! Chaotic pendulum: a swinging rod with a plate turning about it: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/chaotic_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{coordinate_rates, kinetic_energy, potential_energy};

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

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

/// Jacobian of the derivative by the state; columns theta, phi, omega, alpha.
///
/// 49 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [[S; 4]; 4] {
    let Parameters { mA, mB, lA, lB, IAxx, IBxx, IByy, IBzz, g } = *p;
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let cos_phi_sq = cos_phi * cos_phi;
    let ma_la = mA * lA;
    let mb_lb = mB * lB;
    // 1/(IAxx + IByy*cos_phi_sq + IBxx*(1 - cos_phi_sq) + lA*ma_la + lB*mb_lb)
    let omega_dot_by_theta_of_place = S::int(1)
        / (IAxx + IByy * cos_phi_sq + IBxx * (S::int(1) - cos_phi_sq) + lA * ma_la + lB * mb_lb);
    // g*(ma_la + mb_lb)
    let omega_dot_by_theta_of_place_2 = g * (ma_la + mb_lb);
    // omega_dot_by_theta = -g*cos(theta)*(mA*lA + mB*lB)/(mA*lA^2 + mB*lB^2 + IAxx + IByy*cos(phi)^2 +
    //   IBxx*(1 - cos(phi)^2))
    let omega_dot_by_theta = -omega_dot_by_theta_of_place * omega_dot_by_theta_of_place_2
        * cos_theta;
    let omega_dot_by_phi_of_place = S::int(2) * omega_dot_by_theta_of_place;
    // IByy - IBxx
    let minus_ibxx_plus_ibyy = IByy - IBxx;
    // -minus_ibxx_plus_ibyy
    let omega_dot_by_phi_of_ibxx_ibyy = -minus_ibxx_plus_ibyy;
    let omega_dot_by_phi_of_omega = omega * omega_dot_by_phi_of_ibxx_ibyy;
    let omega_dot_by_phi_of_omega_alpha = alpha * omega_dot_by_phi_of_omega;
    let sin_phi_cos_phi = sin_phi * cos_phi;
    let sin_phi_cos_phi_doubled = S::int(2) * sin_phi_cos_phi;
    // omega_dot_by_phi_of_omega_alpha*(cos_phi_sq - sin(phi)^2)
    let omega_dot_by_phi_of_omega_alpha_2 = omega_dot_by_phi_of_omega_alpha
        * (-sin_phi).mul_add(sin_phi, cos_phi_sq);
    // omega_dot_by_phi = 2*(IBxx*sin(phi)*cos(phi) - IByy*sin(phi)*cos(phi))*(g*sin(theta)*(mA*lA + mB*lB)
    //   + 2*omega*alpha*sin(phi)*cos(phi)*(IBxx - IByy))/(mA*lA^2 + mB*lB^2 + IAxx + IByy*cos(phi)^2 +
    //   IBxx*(1 - cos(phi)^2))^2 - 2*(omega*alpha*sin(phi)^2*(IByy - IBxx) + omega*alpha*cos(phi)^2*(IBxx -
    //   IByy))/(mA*lA^2 + mB*lB^2 + IAxx + IByy*cos(phi)^2 + IBxx*(1 - cos(phi)^2))
    let omega_dot_by_phi = -omega_dot_by_phi_of_place
        * (omega_dot_by_theta_of_place * minus_ibxx_plus_ibyy * sin_phi_cos_phi
            * omega_dot_by_phi_of_omega_alpha
                .mul_add(
                    sin_phi_cos_phi_doubled,
                    omega_dot_by_theta_of_place_2 * sin_theta,
                ) + omega_dot_by_phi_of_omega_alpha_2);
    let alpha_dot_by_phi_of_omega = omega_dot_by_phi_of_omega / IBzz;
    // alpha_dot_by_phi = omega^2*(IBxx - IByy)*(2*cos(phi)^2 - 1)/IBzz
    let alpha_dot_by_phi = omega * alpha_dot_by_phi_of_omega
        * cos_phi_sq.mul_add(S::int(2), -S::int(1));
    let omega_dot_by_omega_of_place = omega_dot_by_phi_of_place * sin_phi_cos_phi;
    // omega_dot_by_omega = 2*alpha*sin(phi)*cos(phi)*(IByy - IBxx)/(mA*lA^2 + mB*lB^2 + IAxx +
    //   IByy*cos(phi)^2 + IBxx*(1 - cos(phi)^2))
    let omega_dot_by_omega = -alpha * omega_dot_by_phi_of_ibxx_ibyy * omega_dot_by_omega_of_place;
    // alpha_dot_by_omega = 2*omega*sin(phi)*cos(phi)*(IBxx - IByy)/IBzz
    let alpha_dot_by_omega = sin_phi_cos_phi_doubled * alpha_dot_by_phi_of_omega;
    // omega_dot_by_alpha = 2*omega*sin(phi)*cos(phi)*(IByy - IBxx)/(mA*lA^2 + mB*lB^2 + IAxx +
    //   IByy*cos(phi)^2 + IBxx*(1 - cos(phi)^2))
    let omega_dot_by_alpha = -omega_dot_by_phi_of_omega * omega_dot_by_omega_of_place;
    // Entries that are not zero.
    // d(theta')/d(omega) = 1
    let theta_dot_by_omega_value = S::int(1);
    // d(phi')/d(alpha) = 1
    let phi_dot_by_alpha_value = S::int(1);
    let zero = S::int(0);
    [
        [zero, zero, theta_dot_by_omega_value, zero],
        [zero, zero, zero, phi_dot_by_alpha_value],
        [omega_dot_by_theta, omega_dot_by_phi, omega_dot_by_omega, omega_dot_by_alpha],
        [zero, alpha_dot_by_phi, alpha_dot_by_omega, zero],
    ]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 10 convolutions and 6 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 4]],
    history: &mut [Factors<S, 16>],
) {
    let Parameters { mA, mB, lA, lB, IAxx, IBxx, IByy, IBzz, g } = *p;
    let [theta_0, phi_0, omega_0, alpha_0] = series[0];
    // Constant in time.
    // weight = mA*lA^2 + mB*lB^2 + IAxx + IBxx
    let weight = mA * lA * lA + mB * lB * lB + IAxx + IBxx;
    // ibyy_minus_ibxx = IByy - IBxx
    let ibyy_minus_ibxx = IByy - IBxx;
    // g_ma_la_plus_mb_lb = g*(mA*lA + mB*lB)
    let g_ma_la_plus_mb_lb = g * mB.mul_add(lB, mA * lA);
    // weight_2 = 2*IBxx - 2*IByy
    let weight_2 = (-IByy).mul_add(S::int(2), S::int(2) * IBxx);
    // ibxx_minus_ibyy_by_ibzz = (IBxx - IByy)/IBzz
    let ibxx_minus_ibyy_by_ibzz = (IBxx - IByy) / IBzz;
    // Order 0.
    let (sin_phi_0, cos_phi_0) = phi_0.sin_cos();
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    let cos_phi_sq_0 = cos_phi_0 * cos_phi_0;
    let omega_dot_of_place_0 = cos_phi_sq_0.mul_add(ibyy_minus_ibxx, weight);
    let over_omega_dot_of_place = S::int(1) / omega_dot_of_place_0;
    let omega_sin_phi_0 = omega_0 * sin_phi_0;
    let omega_sin_phi_cos_phi_0 = cos_phi_0 * omega_sin_phi_0;
    let omega_dot_of_omega_alpha_0 = alpha_0 * omega_sin_phi_cos_phi_0;
    let omega_dot_of_omega_alpha_2_0 = omega_dot_of_omega_alpha_0
        .mul_add(weight_2, g_ma_la_plus_mb_lb * sin_theta_0);
    let omega_dot_of_omega_alpha_3_0 = omega_dot_of_omega_alpha_2_0 * over_omega_dot_of_place;
    let omega_sq_sin_phi_cos_phi_0 = omega_0 * omega_sin_phi_cos_phi_0;
    // Order 1: the rates, and what follows from them.
    let theta_1 = omega_0;
    let phi_1 = alpha_0;
    let omega_1 = -omega_dot_of_omega_alpha_3_0;
    let alpha_1 = ibxx_minus_ibyy_by_ibzz * omega_sq_sin_phi_cos_phi_0;
    if series.len() > 1 {
        series[1] = [theta_1, phi_1, omega_1, alpha_1];
    }
    let sin_phi_1 = phi_1 * cos_phi_0;
    let cos_phi_1 = -phi_1 * sin_phi_0;
    let sin_theta_1 = theta_1 * cos_theta_0;
    let cos_theta_1 = -theta_1 * sin_theta_0;
    let cos_phi_sq_1 = cos_phi_1 * (cos_phi_0 + cos_phi_0);
    let omega_dot_of_place_1 = ibyy_minus_ibxx * cos_phi_sq_1;
    let omega_sin_phi_1 = sin_phi_1.mul_add(omega_0, omega_1 * sin_phi_0);
    let omega_sin_phi_cos_phi_1 = omega_sin_phi_1
        .mul_add(cos_phi_0, cos_phi_1 * omega_sin_phi_0);
    let omega_dot_of_omega_alpha_1 = omega_sin_phi_cos_phi_1
        .mul_add(alpha_0, alpha_1 * omega_sin_phi_cos_phi_0);
    let omega_dot_of_omega_alpha_2_1 = omega_dot_of_omega_alpha_1
        .mul_add(weight_2, g_ma_la_plus_mb_lb * sin_theta_1);
    let omega_dot_of_omega_alpha_3_1 = omega_dot_of_place_1
        .mul_add(
            -(omega_dot_of_omega_alpha_3_0 * over_omega_dot_of_place),
            omega_dot_of_omega_alpha_2_1 * over_omega_dot_of_place,
        );
    let omega_sq_sin_phi_cos_phi_1 = omega_sin_phi_cos_phi_1
        .mul_add(omega_0, omega_1 * omega_sin_phi_cos_phi_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                phi_1, phi_1, theta_1, theta_1, cos_phi_1, omega_1, cos_phi_1, alpha_1,
                omega_dot_of_place_1, omega_1,
            ]),
            padded([
                cos_phi_1, sin_phi_1, cos_theta_1, sin_theta_1, cos_phi_1, sin_phi_1,
                omega_sin_phi_1, omega_sin_phi_cos_phi_1, omega_dot_of_omega_alpha_3_1,
                omega_sin_phi_cos_phi_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta_last = theta_1;
    let mut phi_last = phi_1;
    let mut omega_last = omega_1;
    let mut alpha_last = alpha_1;
    let mut sin_phi_last = sin_phi_1;
    let mut cos_phi_last = cos_phi_1;
    let mut sin_theta_last = sin_theta_1;
    let mut cos_theta_last = cos_theta_1;
    let mut omega_dot_of_place_last = omega_dot_of_place_1;
    let mut omega_sin_phi_last = omega_sin_phi_1;
    let mut omega_sin_phi_cos_phi_last = omega_sin_phi_cos_phi_1;
    let mut omega_dot_of_omega_alpha_3_last = omega_dot_of_omega_alpha_3_1;
    let mut next = [S::int(0); 16];
    // Rates at order k - 1.
    let mut theta_rate = omega_1;
    let mut phi_rate = alpha_1;
    let mut omega_rate = -omega_dot_of_omega_alpha_3_1;
    let mut alpha_rate = ibxx_minus_ibyy_by_ibzz * omega_sq_sin_phi_cos_phi_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let theta = theta_rate * over_k;
        let phi = phi_rate * over_k;
        let omega = omega_rate * over_k;
        let alpha = alpha_rate * over_k;
        series[order] = [theta, phi, omega, alpha];
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
                theta_1
                    .mul_add(
                        cos_theta_last,
                        (count_last * theta_last).mul_add(cos_theta_1, next[2]),
                    ),
                theta_1
                    .mul_add(
                        sin_theta_last,
                        (count_last * theta_last).mul_add(sin_theta_1, next[3]),
                    ),
                (cos_phi_1 + cos_phi_1).mul_add(cos_phi_last, next[4]),
                omega_1.mul_add(sin_phi_last, omega_last.mul_add(sin_phi_1, next[5])),
                cos_phi_1
                    .mul_add(
                        omega_sin_phi_last,
                        cos_phi_last.mul_add(omega_sin_phi_1, next[6]),
                    ),
                alpha_1
                    .mul_add(
                        omega_sin_phi_cos_phi_last,
                        alpha_last.mul_add(omega_sin_phi_cos_phi_1, next[7]),
                    ),
                omega_dot_of_place_1
                    .mul_add(
                        omega_dot_of_omega_alpha_3_last,
                        omega_dot_of_place_last
                            .mul_add(omega_dot_of_omega_alpha_3_1, next[8]),
                    ),
                omega_1
                    .mul_add(
                        omega_sin_phi_cos_phi_last,
                        omega_last.mul_add(omega_sin_phi_cos_phi_1, next[9]),
                    ),
            ])
        };
        // sin_phi = sin(phi)
        let sin_phi = phi.mul_add(cos_phi_0, sums[0] * over_k);
        // cos_phi = cos(phi)
        let cos_phi = -phi.mul_add(sin_phi_0, sums[1] * over_k);
        // sin_theta = sin(theta)
        let sin_theta = theta.mul_add(cos_theta_0, sums[2] * over_k);
        // cos_theta = cos(theta)
        let cos_theta = -theta.mul_add(sin_theta_0, sums[3] * over_k);
        // cos_phi_sq = cos_phi*cos_phi
        let cos_phi_sq = cos_phi.mul_add(cos_phi_0 + cos_phi_0, sums[4]);
        // omega_dot_of_place = weight + ibyy_minus_ibxx*cos_phi_sq
        let omega_dot_of_place = ibyy_minus_ibxx * cos_phi_sq;
        // omega_sin_phi = omega*sin_phi
        let omega_sin_phi = sin_phi.mul_add(omega_0, omega.mul_add(sin_phi_0, sums[5]));
        // omega_sin_phi_cos_phi = cos_phi*omega_sin_phi
        let omega_sin_phi_cos_phi = omega_sin_phi
            .mul_add(cos_phi_0, cos_phi.mul_add(omega_sin_phi_0, sums[6]));
        // omega_dot_of_omega_alpha = alpha*omega_sin_phi_cos_phi
        let omega_dot_of_omega_alpha = omega_sin_phi_cos_phi
            .mul_add(alpha_0, alpha.mul_add(omega_sin_phi_cos_phi_0, sums[7]));
        // omega_dot_of_omega_alpha_2 = g_ma_la_plus_mb_lb*sin_theta + weight_2*omega_dot_of_omega_alpha
        let omega_dot_of_omega_alpha_2 = omega_dot_of_omega_alpha
            .mul_add(weight_2, g_ma_la_plus_mb_lb * sin_theta);
        // omega_dot_of_omega_alpha_3 = omega_dot_of_omega_alpha_2/omega_dot_of_place
        let omega_dot_of_omega_alpha_3 = omega_dot_of_omega_alpha_2
            .mul_add(
                over_omega_dot_of_place,
                -(omega_dot_of_place.mul_add(omega_dot_of_omega_alpha_3_0, sums[8])
                    * over_omega_dot_of_place),
            );
        // omega_sq_sin_phi_cos_phi = omega*omega_sin_phi_cos_phi
        let omega_sq_sin_phi_cos_phi = omega_sin_phi_cos_phi
            .mul_add(omega_0, omega.mul_add(omega_sin_phi_cos_phi_0, sums[9]));
        theta_rate = omega;
        phi_rate = alpha;
        omega_rate = -omega_dot_of_omega_alpha_3;
        alpha_rate = ibxx_minus_ibyy_by_ibzz * omega_sq_sin_phi_cos_phi;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * phi,
                count * phi,
                count * theta,
                count * theta,
                cos_phi, omega, cos_phi, alpha, omega_dot_of_place, omega,
            ]),
            padded([
                cos_phi, sin_phi, cos_theta, sin_theta, cos_phi, sin_phi, omega_sin_phi,
                omega_sin_phi_cos_phi, omega_dot_of_omega_alpha_3, omega_sin_phi_cos_phi,
            ]),
        ];
        count_last = count;
        theta_last = theta;
        phi_last = phi;
        omega_last = omega;
        alpha_last = alpha;
        sin_phi_last = sin_phi;
        cos_phi_last = cos_phi;
        sin_theta_last = sin_theta;
        cos_theta_last = cos_theta;
        omega_dot_of_place_last = omega_dot_of_place;
        omega_sin_phi_last = omega_sin_phi;
        omega_sin_phi_cos_phi_last = omega_sin_phi_cos_phi;
        omega_dot_of_omega_alpha_3_last = omega_dot_of_omega_alpha_3;
    }
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
    slice.try_into().expect("a slice of the length that System states")
}
