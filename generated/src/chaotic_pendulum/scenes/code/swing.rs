//! Chaotic pendulum: a swinging rod with a plate turning about it: Swing with a turning plate.
//!
//! Generated from `models/chaotic_pendulum/scenes/swing.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{CompiledScene, CompiledSystem, Lengths, Scalar, System};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// mass of the rod, kg
    pub mA: S,
    /// pin to the centre of the rod, m
    pub lA: S,
    /// pin to the centre of the plate, m
    pub lB: S,
    /// rod, across its axis, kg*m^2
    pub IAxx: S,
    /// plate, about its first axis, kg*m^2
    pub IBxx: S,
    /// plate, about its second axis, kg*m^2
    pub IByy: S,
    /// plate, about the rod, kg*m^2
    pub IBzz: S,
    /// acceleration of free fall, m/s^2
    pub g: S,
    /// 3*lB, m
    pub lB_times_3: S,
    /// 2*mA*lA, kg*m
    pub mA_lA_times_2: S,
    /// g/2, m/s^2
    pub g_by_2: S,
    /// mA*lA^2, kg*m^2
    pub mA_lA_squared: S,
    /// 3*lB^2/2, m^2
    pub lB_squared_times_3_by_2: S,
}

impl<S: Scalar> Parameters<S> {
    /// From values in the order of [`PARAMETERS`].
    ///
    /// # Panics
    /// If `p` has fewer values than there are parameters.
    #[must_use]
    #[inline(always)]
    pub fn from_slice(p: &[S]) -> Self {
        Self {
            mA: p[0], lA: p[1], lB: p[2], IAxx: p[3], IBxx: p[4], IByy: p[5], IBzz: p[6], g: p[7],
            lB_times_3: p[8], mA_lA_times_2: p[9], g_by_2: p[10], mA_lA_squared: p[11],
            lB_squared_times_3_by_2: p[12],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 13] {
        let Self {
            mA, lA, lB, IAxx, IBxx, IByy, IBzz, g, lB_times_3, mA_lA_times_2, g_by_2, mA_lA_squared,
            lB_squared_times_3_by_2,
            ..
        } = self;
        [
            mA, lA, lB, IAxx, IBxx, IByy, IBzz, g, lB_times_3, mA_lA_times_2, g_by_2, mA_lA_squared,
            lB_squared_times_3_by_2,
        ]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 13] = [
    "mA", "lA", "lB", "IAxx", "IBxx", "IByy", "IBzz", "g", "lB_times_3", "mA_lA_times_2", "g_by_2",
    "mA_lA_squared", "lB_squared_times_3_by_2",
];

/// Names of the outputs.
pub const OUTPUTS: [&str; 4] = ["theta", "phi", "omega", "alpha"];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 7 operations.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    _q: &[S; 2],
    _u: &[S; 2],
) -> [S; 13] {
    let super::super::super::Parameters { mA, lA, lB, IAxx, IBxx, IByy, IBzz, g, .. } = *p;
    // Shared terms.
    let ma_la = mA * lA;
    // Values.
    // mA
    let mA_value = mA;
    // lA
    let lA_value = lA;
    // lB
    let lB_value = lB;
    // IAxx
    let IAxx_value = IAxx;
    // IBxx
    let IBxx_value = IBxx;
    // IByy
    let IByy_value = IByy;
    // IBzz
    let IBzz_value = IBzz;
    // g
    let g_value = g;
    // lB_times_3 = 3*lB
    let lB_times_3_value = S::int(3) * lB;
    // mA_lA_times_2 = 2*mA*lA
    let mA_lA_times_2_value = S::int(2) * ma_la;
    // g_by_2 = g/2
    let g_by_2_value = S::ratio(1, 2) * g;
    // mA_lA_squared = mA*lA^2
    let mA_lA_squared_value = lA * ma_la;
    // lB_squared_times_3_by_2 = 3*lB^2/2
    let lB_squared_times_3_by_2_value = S::ratio(3, 2) * lB * lB;
    [
        mA_value, lA_value, lB_value, IAxx_value, IBxx_value, IByy_value, IBzz_value, g_value,
        lB_times_3_value, mA_lA_times_2_value, g_by_2_value, mA_lA_squared_value,
        lB_squared_times_3_by_2_value,
    ]
}

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// 0 operations.
#[must_use]
pub fn start<S: Scalar>(
    _p: &super::super::super::Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Values.
    // theta
    let theta_value = theta;
    // phi
    let phi_value = phi;
    // omega
    let omega_value = omega;
    // alpha
    let alpha_value = alpha;
    ([theta_value, phi_value], [omega_value, alpha_value])
}

/// The accelerations (omega', alpha'), solved for when this code was generated.
///
/// 22 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 2] {
    let Parameters {
        IAxx, IBxx, IByy, IBzz, lB_times_3, mA_lA_times_2, g_by_2, mA_lA_squared,
        lB_squared_times_3_by_2,
        ..
    } = *p;
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, _) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // omega*sin(phi)*cos(phi)*(IBxx - IByy)
    let omega_dot_of_omega = omega * sin_phi * cos_phi * (IBxx - IByy);
    // omega' = -(2*omega*alpha*sin(phi)*cos(phi)*(IBxx - IByy) + g_by_2*sin(theta)*(lB_times_3 +
    //   mA_lA_times_2))/(IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2 + mA_lA_squared + lB_squared_times_3_by_2)
    let omega_dot = -(g_by_2 * sin_theta * (lB_times_3 + mA_lA_times_2)
        + S::int(2) * alpha * omega_dot_of_omega)
        / (IAxx + IBxx * sin_phi * sin_phi + IByy * cos_phi * cos_phi + mA_lA_squared
            + lB_squared_times_3_by_2);
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
/// 19 operations, 1 sine and cosine.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> S {
    let Parameters { mA, lA, lB, IAxx, IBxx, IByy, IBzz, .. } = *p;
    let [_, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (_, cos_phi) = phi.sin_cos();
    // Shared terms.
    let omega_sq = omega * omega;
    // mA*lA^2 + IAxx
    let iaxx_plus_ma_la_sq = mA * lA * lA + IAxx;
    // IBxx + cos(phi)^2*(IByy - IBxx)
    let energy_of_place = IBxx + cos_phi * cos_phi * (IByy - IBxx);
    // Values.
    // T = omega^2*(2*mA*lA^2 + 3*lB^2 + 2*IAxx + 2*IBxx*sin(phi)^2 + 2*IByy*cos(phi)^2)/4 + IBzz*alpha^2/2
    let energy = S::ratio(1, 2) * IBzz * alpha * alpha + S::ratio(3, 4) * lB * lB * omega_sq
        + S::ratio(1, 2) * omega_sq * (iaxx_plus_ma_la_sq + energy_of_place);
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 7 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2]) -> S {
    let Parameters { mA, lA, lB, g, .. } = *p;
    let [theta, _] = *q;
    // Sines and cosines.
    let (_, cos_theta) = theta.sin_cos();
    // Shared terms.
    let g_cos_theta = g * cos_theta;
    // Values.
    // V = -g*cos(theta)*(2*mA*lA + 3*lB)/2
    let energy = (-(mA * lA)).mul_add(g_cos_theta, -S::ratio(3, 2) * lB * g_cos_theta);
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 0 operations.
#[must_use]
pub fn outputs<S: Scalar>(_p: &Parameters<S>, _t: S, q: &[S; 2], u: &[S; 2]) -> [S; 4] {
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Values.
    // theta
    let theta_value = theta;
    // phi
    let phi_value = phi;
    // omega
    let omega_value = omega;
    // alpha
    let alpha_value = alpha;
    [theta_value, phi_value, omega_value, alpha_value]
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
    let Parameters {
        IAxx, IBxx, IByy, IBzz, lB_times_3, mA_lA_times_2, g_by_2, mA_lA_squared,
        lB_squared_times_3_by_2,
        ..
    } = *p;
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, _) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // omega*sin(phi)*cos(phi)*(IBxx - IByy)
    let omega_dot_of_omega = omega * sin_phi * cos_phi * (IBxx - IByy);
    // omega' = -(2*omega*alpha*sin(phi)*cos(phi)*(IBxx - IByy) + g_by_2*sin(theta)*(lB_times_3 +
    //   mA_lA_times_2))/(IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2 + mA_lA_squared + lB_squared_times_3_by_2)
    let omega_dot = -(g_by_2 * sin_theta * (lB_times_3 + mA_lA_times_2)
        + S::int(2) * alpha * omega_dot_of_omega)
        / (IAxx + IBxx * sin_phi * sin_phi + IByy * cos_phi * cos_phi + mA_lA_squared
            + lB_squared_times_3_by_2);
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
/// 42 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [[S; 4]; 4] {
    let Parameters {
        IAxx, IBxx, IByy, IBzz, lB_times_3, mA_lA_times_2, g_by_2, mA_lA_squared,
        lB_squared_times_3_by_2,
        ..
    } = *p;
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let cos_phi_sq = cos_phi * cos_phi;
    let sin_phi_sq = sin_phi * sin_phi;
    // 1/(IAxx + mA_lA_squared + lB_squared_times_3_by_2 + IByy*cos_phi_sq + IBxx*sin_phi_sq)
    let omega_dot_by_theta_of_place = S::int(1)
        / (IByy.mul_add(cos_phi_sq, IAxx + mA_lA_squared + lB_squared_times_3_by_2)
            + IBxx * sin_phi_sq);
    // g_by_2*(lB_times_3 + mA_lA_times_2)
    let omega_dot_by_theta_of_place_2 = g_by_2 * (lB_times_3 + mA_lA_times_2);
    // omega_dot_by_theta = -g_by_2*cos(theta)*(lB_times_3 + mA_lA_times_2)/(IAxx + IBxx*sin(phi)^2 +
    //   IByy*cos(phi)^2 + mA_lA_squared + lB_squared_times_3_by_2)
    let omega_dot_by_theta = -omega_dot_by_theta_of_place * omega_dot_by_theta_of_place_2
        * cos_theta;
    let omega_dot_by_phi_of_place = S::int(2) * omega_dot_by_theta_of_place;
    // IBxx - IByy
    let ibxx_minus_ibyy = IBxx - IByy;
    let sin_phi_cos_phi = sin_phi * cos_phi;
    let omega_dot_by_phi_of_place_2 = ibxx_minus_ibyy * sin_phi_cos_phi;
    let omega_ibxx_minus_ibyy = omega * ibxx_minus_ibyy;
    let omega_dot_by_phi_of_omega_alpha = alpha * omega_ibxx_minus_ibyy;
    let sin_phi_cos_phi_doubled = S::int(2) * sin_phi_cos_phi;
    // omega_dot_by_phi = 2*(IBxx*sin(phi)*cos(phi) -
    //   IByy*sin(phi)*cos(phi))*(2*omega*alpha*sin(phi)*cos(phi)*(IBxx - IByy) +
    //   g_by_2*sin(theta)*(lB_times_3 + mA_lA_times_2))/(IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2 +
    //   mA_lA_squared + lB_squared_times_3_by_2)^2 - 2*(omega*alpha*sin(phi)^2*(IByy - IBxx) +
    //   omega*alpha*cos(phi)^2*(IBxx - IByy))/(IAxx + IBxx*sin(phi)^2 + IByy*cos(phi)^2 + mA_lA_squared +
    //   lB_squared_times_3_by_2)
    let omega_dot_by_phi = omega_dot_by_phi_of_place
        * (omega_dot_by_theta_of_place * omega_dot_by_phi_of_place_2
            * omega_dot_by_phi_of_omega_alpha
                .mul_add(
                    sin_phi_cos_phi_doubled,
                    omega_dot_by_theta_of_place_2 * sin_theta,
                ) - omega_dot_by_phi_of_omega_alpha * (cos_phi_sq - sin_phi_sq));
    let alpha_dot_by_phi_of_omega = omega_ibxx_minus_ibyy / IBzz;
    // alpha_dot_by_phi = omega^2*(IBxx - IByy)*(2*cos(phi)^2 - 1)/IBzz
    let alpha_dot_by_phi = omega * alpha_dot_by_phi_of_omega
        * cos_phi_sq.mul_add(S::int(2), -S::int(1));
    // omega_dot_by_omega = 2*alpha*sin(phi)*cos(phi)*(IByy - IBxx)/(IAxx + IBxx*sin(phi)^2 +
    //   IByy*cos(phi)^2 + mA_lA_squared + lB_squared_times_3_by_2)
    let omega_dot_by_omega = -alpha * omega_dot_by_phi_of_place * omega_dot_by_phi_of_place_2;
    // alpha_dot_by_omega = 2*omega*sin(phi)*cos(phi)*(IBxx - IByy)/IBzz
    let alpha_dot_by_omega = sin_phi_cos_phi_doubled * alpha_dot_by_phi_of_omega;
    // omega_dot_by_alpha = 2*omega*sin(phi)*cos(phi)*(IByy - IBxx)/(IAxx + IBxx*sin(phi)^2 +
    //   IByy*cos(phi)^2 + mA_lA_squared + lB_squared_times_3_by_2)
    let omega_dot_by_alpha = -omega_dot_by_phi_of_place * sin_phi_cos_phi * omega_ibxx_minus_ibyy;
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

/// The energy, then its derivatives by the state.
///
/// 30 operations, 2 sines and cosines.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 5] {
    let Parameters { mA, lA, lB, IAxx, IBxx, IByy, IBzz, g, .. } = *p;
    let [theta, phi] = *q;
    let [omega, alpha] = *u;
    // Sines and cosines.
    let (sin_phi, cos_phi) = phi.sin_cos();
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let ibzz_alpha = IBzz * alpha;
    let ma_la = mA * lA;
    // sin(phi)*(IBxx - IByy)
    let energy_of_place = sin_phi * (IBxx - IByy);
    // lA*ma_la + energy_of_place*sin(phi)
    let energy_of_place_2 = energy_of_place.mul_add(sin_phi, lA * ma_la);
    // IAxx + IByy
    let iaxx_plus_ibyy = IAxx + IByy;
    let lb_times_3 = S::int(3) * lB;
    // energy_of_place_2 + iaxx_plus_ibyy
    let energy_of_place_3 = energy_of_place_2 + iaxx_plus_ibyy;
    // lB*lb_times_3 + 2*energy_of_place_3
    let energy_of_place_4 = energy_of_place_3.mul_add(S::int(2), lB * lb_times_3);
    let omega_sq = omega * omega;
    // g*(2*ma_la + lb_times_3)/2
    let energy_of_ma_la_lb_g = S::ratio(1, 2) * g * ma_la.mul_add(S::int(2), lb_times_3);
    // Values.
    // T + V = omega^2*(2*mA*lA^2 + 3*lB^2 + 2*IAxx + 2*IBxx*sin(phi)^2 + 2*IByy*cos(phi)^2)/4 -
    //   g*cos(theta)*(2*mA*lA + 3*lB)/2 + IBzz*alpha^2/2
    let energy = (-energy_of_ma_la_lb_g)
        .mul_add(
            cos_theta,
            S::ratio(1, 2) * alpha * ibzz_alpha + S::ratio(1, 4) * energy_of_place_4 * omega_sq,
        );
    // d(T + V)/d(theta) = g*sin(theta)*(2*mA*lA + 3*lB)/2
    let energy_by_theta = energy_of_ma_la_lb_g * sin_theta;
    // d(T + V)/d(phi) = omega^2*sin(phi)*cos(phi)*(IBxx - IByy)
    let energy_by_phi = energy_of_place * omega_sq * cos_phi;
    // d(T + V)/d(omega) = omega*(2*mA*lA^2 + 3*lB^2 + 2*IAxx + 2*IBxx*sin(phi)^2 + 2*IByy*cos(phi)^2)/2
    let energy_by_omega = S::ratio(1, 2) * omega * energy_of_place_4;
    // d(T + V)/d(alpha) = IBzz*alpha
    let energy_by_alpha = ibzz_alpha;
    [energy, energy_by_theta, energy_by_phi, energy_by_omega, energy_by_alpha]
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
    let Parameters {
        IAxx, IBxx, IByy, IBzz, lB_times_3, mA_lA_times_2, g_by_2, mA_lA_squared,
        lB_squared_times_3_by_2,
        ..
    } = *p;
    let [theta_0, phi_0, omega_0, alpha_0] = series[0];
    // Constant in time.
    // weight = IAxx + mA_lA_squared + lB_squared_times_3_by_2
    let weight = IAxx + mA_lA_squared + lB_squared_times_3_by_2;
    // weight_2 = 2*IBxx - 2*IByy
    let weight_2 = (-IByy).mul_add(S::int(2), S::int(2) * IBxx);
    // weight_3 = g_by_2*(lB_times_3 + mA_lA_times_2)
    let weight_3 = g_by_2 * (lB_times_3 + mA_lA_times_2);
    // ibxx_minus_ibyy_by_ibzz = (IBxx - IByy)/IBzz
    let ibxx_minus_ibyy_by_ibzz = (IBxx - IByy) / IBzz;
    // Order 0.
    let (sin_phi_0, cos_phi_0) = phi_0.sin_cos();
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    let sin_phi_sq_0 = sin_phi_0 * sin_phi_0;
    let cos_phi_sq_0 = cos_phi_0 * cos_phi_0;
    let omega_sin_phi_0 = omega_0 * sin_phi_0;
    let omega_sin_phi_cos_phi_0 = cos_phi_0 * omega_sin_phi_0;
    let omega_dot_of_omega_alpha_0 = alpha_0 * omega_sin_phi_cos_phi_0;
    let omega_dot_of_place_0 = cos_phi_sq_0
        .mul_add(IByy, sin_phi_sq_0.mul_add(IBxx, weight));
    let over_omega_dot_of_place = S::int(1) / omega_dot_of_place_0;
    let omega_dot_of_omega_alpha_2_0 = omega_dot_of_omega_alpha_0
        .mul_add(weight_2, weight_3 * sin_theta_0);
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
    let sin_phi_sq_1 = sin_phi_1 * (sin_phi_0 + sin_phi_0);
    let cos_phi_sq_1 = cos_phi_1 * (cos_phi_0 + cos_phi_0);
    let omega_sin_phi_1 = sin_phi_1.mul_add(omega_0, omega_1 * sin_phi_0);
    let omega_sin_phi_cos_phi_1 = omega_sin_phi_1
        .mul_add(cos_phi_0, cos_phi_1 * omega_sin_phi_0);
    let omega_dot_of_omega_alpha_1 = omega_sin_phi_cos_phi_1
        .mul_add(alpha_0, alpha_1 * omega_sin_phi_cos_phi_0);
    let omega_dot_of_place_1 = cos_phi_sq_1.mul_add(IByy, IBxx * sin_phi_sq_1);
    let omega_dot_of_omega_alpha_2_1 = omega_dot_of_omega_alpha_1
        .mul_add(weight_2, weight_3 * sin_theta_1);
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
                phi_1, phi_1, theta_1, theta_1, sin_phi_1, cos_phi_1, omega_1, cos_phi_1, alpha_1,
                omega_dot_of_place_1, omega_1,
            ]),
            padded([
                cos_phi_1, sin_phi_1, cos_theta_1, sin_theta_1, sin_phi_1, cos_phi_1, sin_phi_1,
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
    let mut omega_sin_phi_last = omega_sin_phi_1;
    let mut omega_sin_phi_cos_phi_last = omega_sin_phi_cos_phi_1;
    let mut omega_dot_of_place_last = omega_dot_of_place_1;
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
                (sin_phi_1 + sin_phi_1).mul_add(sin_phi_last, next[4]),
                (cos_phi_1 + cos_phi_1).mul_add(cos_phi_last, next[5]),
                omega_1.mul_add(sin_phi_last, omega_last.mul_add(sin_phi_1, next[6])),
                cos_phi_1
                    .mul_add(
                        omega_sin_phi_last,
                        cos_phi_last.mul_add(omega_sin_phi_1, next[7]),
                    ),
                alpha_1
                    .mul_add(
                        omega_sin_phi_cos_phi_last,
                        alpha_last.mul_add(omega_sin_phi_cos_phi_1, next[8]),
                    ),
                omega_dot_of_place_1
                    .mul_add(
                        omega_dot_of_omega_alpha_3_last,
                        omega_dot_of_place_last
                            .mul_add(omega_dot_of_omega_alpha_3_1, next[9]),
                    ),
                omega_1
                    .mul_add(
                        omega_sin_phi_cos_phi_last,
                        omega_last.mul_add(omega_sin_phi_cos_phi_1, next[10]),
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
        // sin_phi_sq = sin_phi*sin_phi
        let sin_phi_sq = sin_phi.mul_add(sin_phi_0 + sin_phi_0, sums[4]);
        // cos_phi_sq = cos_phi*cos_phi
        let cos_phi_sq = cos_phi.mul_add(cos_phi_0 + cos_phi_0, sums[5]);
        // omega_sin_phi = omega*sin_phi
        let omega_sin_phi = sin_phi.mul_add(omega_0, omega.mul_add(sin_phi_0, sums[6]));
        // omega_sin_phi_cos_phi = cos_phi*omega_sin_phi
        let omega_sin_phi_cos_phi = omega_sin_phi
            .mul_add(cos_phi_0, cos_phi.mul_add(omega_sin_phi_0, sums[7]));
        // omega_dot_of_omega_alpha = alpha*omega_sin_phi_cos_phi
        let omega_dot_of_omega_alpha = omega_sin_phi_cos_phi
            .mul_add(alpha_0, alpha.mul_add(omega_sin_phi_cos_phi_0, sums[8]));
        // omega_dot_of_place = weight + IBxx*sin_phi_sq + IByy*cos_phi_sq
        let omega_dot_of_place = cos_phi_sq.mul_add(IByy, IBxx * sin_phi_sq);
        // omega_dot_of_omega_alpha_2 = weight_2*omega_dot_of_omega_alpha + weight_3*sin_theta
        let omega_dot_of_omega_alpha_2 = omega_dot_of_omega_alpha
            .mul_add(weight_2, weight_3 * sin_theta);
        // omega_dot_of_omega_alpha_3 = omega_dot_of_omega_alpha_2/omega_dot_of_place
        let omega_dot_of_omega_alpha_3 = omega_dot_of_omega_alpha_2
            .mul_add(
                over_omega_dot_of_place,
                -(omega_dot_of_place.mul_add(omega_dot_of_omega_alpha_3_0, sums[9])
                    * over_omega_dot_of_place),
            );
        // omega_sq_sin_phi_cos_phi = omega*omega_sin_phi_cos_phi
        let omega_sq_sin_phi_cos_phi = omega_sin_phi_cos_phi
            .mul_add(omega_0, omega.mul_add(omega_sin_phi_cos_phi_0, sums[10]));
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
                sin_phi, cos_phi, omega, cos_phi, alpha, omega_dot_of_place, omega,
            ]),
            padded([
                cos_phi, sin_phi, cos_theta, sin_theta, sin_phi, cos_phi, sin_phi, omega_sin_phi,
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
        omega_sin_phi_last = omega_sin_phi;
        omega_sin_phi_cos_phi_last = omega_sin_phi_cos_phi;
        omega_dot_of_place_last = omega_dot_of_place;
        omega_dot_of_omega_alpha_3_last = omega_dot_of_omega_alpha_3;
    }
}

/// Reduced equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Reduced;

impl<S: Scalar> System<S> for Reduced {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 13,
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
    fn output_count(&self) -> usize {
        4
    }
    fn outputs(&self, p: &[S], t: S, q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&outputs(&Parameters::from_slice(p), t, array(q), array(v)));
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
    fn has_energy_gradient(&self) -> bool {
        true
    }
    fn energy_gradient(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) -> S {
        let [energy, gradient @ ..] = energy_gradient(
            &Parameters::from_slice(p),
            array(q),
            array(v),
        );
        out.copy_from_slice(&gradient);
        energy
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

/// What a program needs to find these equations and to trust them.
pub const SCENE: CompiledScene = CompiledScene {
    name: "swing",
    key: "0d77bdd328746538",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: None,
    },
};
