//! Thin disc rolling on a plane: Kane's method in q2-90°, M(q) u' = f(q, u).
//!
//! Generated from `models/rolling_disc/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::mass_matrix;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Right-hand side of the linear system; unknowns (u1', u2', u3').
///
/// 21 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 3]) -> [S; 3] {
    let Parameters { r, m, g } = *p;
    let [_, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Shared terms.
    let tan_q2_minus_90deg = sin_q2_minus_90deg / cos_q2_minus_90deg;
    let f1_of_u3 = u3 / tan_q2_minus_90deg;
    let r_u3 = r * u3;
    let r_m = r * m;
    let r_m_by_4 = S::ratio(1, 4) * r_m;
    // Values.
    // f1 = r*m*(4*g*cos(q2_minus_90deg) + r*u3*(6*u2 + u3/tan(q2_minus_90deg)))/4
    let f1 = r_m_by_4
        * (r_u3 * u2.mul_add(S::int(6), f1_of_u3) + S::int(4) * g * cos_q2_minus_90deg);
    // f2 = -r^2*m*u1*u3
    let f2 = -u1 * r_u3 * r_m;
    // f3 = -r^2*m*u1*(2*u2 + u3/tan(q2_minus_90deg))/4
    let f3 = -r * u1 * r_m_by_4 * u2.mul_add(S::int(2), f1_of_u3);
    [f1, f2, f3]
}

/// The accelerations (u1', u2', u3'), solved for when this code was generated.
///
/// 17 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 3]) -> [S; 3] {
    let Parameters { r, g, .. } = *p;
    let [_, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let tan_q2_minus_90deg = sin_q2_minus_90deg / cos_q2_minus_90deg;
    let u3_dot_of_u3 = u3 / tan_q2_minus_90deg;
    // u3' = -u1*(2*u2 + u3/tan(q2_minus_90deg))
    let u3_dot = -u1 * u2.mul_add(S::int(2), u3_dot_of_u3);
    // u2' = -2*u1*u3/3
    let u2_dot = -S::ratio(2, 3) * u1 * u3;
    // u1' = 4*g*cos(q2_minus_90deg)/(5*r) + u3*(6*u2 + u3/tan(q2_minus_90deg))/5
    let u1_dot = S::ratio(4, 5) * g * cos_q2_minus_90deg / r
        + S::ratio(1, 5) * u3 * u2.mul_add(S::int(6), u3_dot_of_u3);
    [u1_dot, u2_dot, u3_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 7 operations, 2 sines and cosines.
#[must_use]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 3]) -> [S; 5] {
    let Parameters { r, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let q1_dot_value_of_u3 = u3 / sin_q2_minus_90deg;
    // u2 + q1_dot_value_of_u3*cos(q2_minus_90deg)
    let q3_dot_value_of_u2_u3 = q1_dot_value_of_u3.mul_add(cos_q2_minus_90deg, u2);
    let r_q3_dot_value_of_u2_u3 = r * q3_dot_value_of_u2_u3;
    // Values.
    // q1' = -u3/sin(q2_minus_90deg)
    let q1_dot_value = -q1_dot_value_of_u3;
    // q2' = u1
    let q2_dot_value = u1;
    // q3' = u2 + u3/tan(q2_minus_90deg)
    let q3_dot_value = q3_dot_value_of_u2_u3;
    // x' = r*cos(q1)*(u2 + u3/tan(q2_minus_90deg))
    let x_dot_value = r_q3_dot_value_of_u2_u3 * c1;
    // y' = r*sin(q1)*(u2 + u3/tan(q2_minus_90deg))
    let y_dot_value = r_q3_dot_value_of_u2_u3 * s1;
    [q1_dot_value, q2_dot_value, q3_dot_value, x_dot_value, y_dot_value]
}

/// Kinetic energy T.
///
/// 11 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 5], u: &[S; 3]) -> S {
    let Parameters { r, m, .. } = *p;
    let [u1, u2, u3] = *u;
    // Values.
    // T = r^2*m*(5*u1^2 + 6*u2^2 + u3^2)/8
    let energy = S::ratio(1, 8) * r * r * m
        * u3.mul_add(u3, S::int(5) * u1 * u1 + S::int(6) * u2 * u2);
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5]) -> S {
    let Parameters { r, m, g } = *p;
    let [_, q2_minus_90deg, _, _, _] = *q;
    // Sines and cosines.
    let (sin_q2_minus_90deg, _) = q2_minus_90deg.sin_cos();
    // Values.
    // V = -r*m*g*sin(q2_minus_90deg)
    let energy = -r * m * g * sin_q2_minus_90deg;
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 22 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 3],
) -> ([S; 5], [S; 3]) {
    let Parameters { r, g, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let u3_dot_of_u3 = u3 / sin_q2_minus_90deg;
    let u3_dot_of_u3_2 = u3_dot_of_u3 * cos_q2_minus_90deg;
    // u3' = -u1*(2*u2 + u3/tan(q2_minus_90deg))
    let u3_dot = -u1 * u2.mul_add(S::int(2), u3_dot_of_u3_2);
    // u2' = -2*u1*u3/3
    let u2_dot = -S::ratio(2, 3) * u1 * u3;
    // u1' = 4*g*cos(q2_minus_90deg)/(5*r) + u3*(6*u2 + u3/tan(q2_minus_90deg))/5
    let u1_dot = S::ratio(4, 5) * g * cos_q2_minus_90deg / r
        + S::ratio(1, 5) * u3 * u2.mul_add(S::int(6), u3_dot_of_u3_2);
    // u2 + u3_dot_of_u3_2
    let u2_plus_u3_dot_of_u3_2 = u2 + u3_dot_of_u3_2;
    let r_u2_plus_u3_dot_of_u3_2 = r * u2_plus_u3_dot_of_u3_2;
    // Values.
    // q1' = -u3/sin(q2_minus_90deg)
    let q1_dot_value = -u3_dot_of_u3;
    // q2' = u1
    let q2_dot_value = u1;
    // q3' = u2 + u3/tan(q2_minus_90deg)
    let q3_dot_value = u2_plus_u3_dot_of_u3_2;
    // x' = r*cos(q1)*(u2 + u3/tan(q2_minus_90deg))
    let x_dot_value = r_u2_plus_u3_dot_of_u3_2 * c1;
    // y' = r*sin(q1)*(u2 + u3/tan(q2_minus_90deg))
    let y_dot_value = r_u2_plus_u3_dot_of_u3_2 * s1;
    (
        [q1_dot_value, q2_dot_value, q3_dot_value, x_dot_value, y_dot_value],
        [u1_dot, u2_dot, u3_dot],
    )
}

/// Jacobian of the derivative by the state; columns q1, q2_minus_90deg, q3, x, y, u1, u2, u3.
///
/// 43 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 3]) -> [[S; 8]; 8] {
    let Parameters { r, g, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    let u3_dot_by_q2_minus_90deg_of_u3 = u3 * sin_q2_minus_90deg_inv;
    let u3_dot_by_q2_minus_90deg_of_u3_2 = sin_q2_minus_90deg_inv * u3_dot_by_q2_minus_90deg_of_u3;
    // u3_dot_by_q2_minus_90deg = u1*u3/sin(q2_minus_90deg)^2
    let u3_dot_by_q2_minus_90deg = u1 * u3_dot_by_q2_minus_90deg_of_u3_2;
    // u1_dot_by_q2_minus_90deg = -4*g*sin(q2_minus_90deg)/(5*r) - u3^2/(5*sin(q2_minus_90deg)^2)
    let u1_dot_by_q2_minus_90deg = -S::ratio(4, 5) * g * sin_q2_minus_90deg / r
        - S::ratio(1, 5) * u3_dot_by_q2_minus_90deg_of_u3 * u3_dot_by_q2_minus_90deg_of_u3;
    let u3_dot_by_u1_of_u3 = u3_dot_by_q2_minus_90deg_of_u3 * cos_q2_minus_90deg;
    // u3_dot_by_u1 = -2*u2 - u3/tan(q2_minus_90deg)
    let u3_dot_by_u1 = (-u2).mul_add(S::int(2), -u3_dot_by_u1_of_u3);
    let u3_dot_by_u3_of_place = sin_q2_minus_90deg_inv * cos_q2_minus_90deg;
    // u3_dot_by_u3 = -u1/tan(q2_minus_90deg)
    let u3_dot_by_u3 = -u1 * u3_dot_by_u3_of_place;
    // u1_dot_by_u3 = 6*u2/5 + 2*u3/(5*tan(q2_minus_90deg))
    let u1_dot_by_u3 = S::ratio(6, 5) * u2 + S::ratio(2, 5) * u3_dot_by_u1_of_u3;
    // u2 + u3_dot_by_u1_of_u3
    let x_dot_by_q1_value_of_u2_u3 = u2 + u3_dot_by_u1_of_u3;
    let r_s1 = r * s1;
    let r_c1 = r * c1;
    // Entries that are not zero.
    // d(q1')/d(q2_minus_90deg) = u3/(sin(q2_minus_90deg)*tan(q2_minus_90deg))
    let q1_dot_by_q2_minus_90deg_value = u3_dot_by_q2_minus_90deg_of_u3 * u3_dot_by_u3_of_place;
    // d(q1')/d(u3) = -1/sin(q2_minus_90deg)
    let q1_dot_by_u3_value = -sin_q2_minus_90deg_inv;
    // d(q2')/d(u1) = 1
    let q2_dot_by_u1_value = S::int(1);
    // d(q3')/d(q2_minus_90deg) = -u3/sin(q2_minus_90deg)^2
    let q3_dot_by_q2_minus_90deg_value = -u3_dot_by_q2_minus_90deg_of_u3_2;
    // d(q3')/d(u2) = 1
    let q3_dot_by_u2_value = S::int(1);
    // d(q3')/d(u3) = 1/tan(q2_minus_90deg)
    let q3_dot_by_u3_value = u3_dot_by_u3_of_place;
    // d(x')/d(q1) = -r*sin(q1)*(u2 + u3/tan(q2_minus_90deg))
    let x_dot_by_q1_value = -x_dot_by_q1_value_of_u2_u3 * r_s1;
    // d(x')/d(q2_minus_90deg) = -r*u3*cos(q1)/sin(q2_minus_90deg)^2
    let x_dot_by_q2_minus_90deg_value = -u3_dot_by_q2_minus_90deg_of_u3_2 * r_c1;
    // d(x')/d(u2) = r*cos(q1)
    let x_dot_by_u2_value = r_c1;
    // d(x')/d(u3) = r*cos(q1)/tan(q2_minus_90deg)
    let x_dot_by_u3_value = u3_dot_by_u3_of_place * r_c1;
    // d(y')/d(q1) = r*cos(q1)*(u2 + u3/tan(q2_minus_90deg))
    let y_dot_by_q1_value = x_dot_by_q1_value_of_u2_u3 * r_c1;
    // d(y')/d(q2_minus_90deg) = -r*u3*sin(q1)/sin(q2_minus_90deg)^2
    let y_dot_by_q2_minus_90deg_value = -u3_dot_by_q2_minus_90deg_of_u3_2 * r_s1;
    // d(y')/d(u2) = r*sin(q1)
    let y_dot_by_u2_value = r_s1;
    // d(y')/d(u3) = r*sin(q1)/tan(q2_minus_90deg)
    let y_dot_by_u3_value = u3_dot_by_u3_of_place * r_s1;
    // d(u1')/d(u2) = 6*u3/5
    let u1_dot_by_u2_value = S::ratio(6, 5) * u3;
    // d(u2')/d(u1) = -2*u3/3
    let u2_dot_by_u1_value = -S::ratio(2, 3) * u3;
    // d(u2')/d(u3) = -2*u1/3
    let u2_dot_by_u3_value = -S::ratio(2, 3) * u1;
    // d(u3')/d(u2) = -2*u1
    let u3_dot_by_u2_value = -S::int(2) * u1;
    let zero = S::int(0);
    [
        [
            zero, q1_dot_by_q2_minus_90deg_value, zero, zero, zero, zero, zero, q1_dot_by_u3_value,
        ],
        [zero, zero, zero, zero, zero, q2_dot_by_u1_value, zero, zero],
        [
            zero, q3_dot_by_q2_minus_90deg_value, zero, zero, zero, zero, q3_dot_by_u2_value,
            q3_dot_by_u3_value,
        ],
        [
            x_dot_by_q1_value, x_dot_by_q2_minus_90deg_value, zero, zero, zero, zero,
            x_dot_by_u2_value, x_dot_by_u3_value,
        ],
        [
            y_dot_by_q1_value, y_dot_by_q2_minus_90deg_value, zero, zero, zero, zero,
            y_dot_by_u2_value, y_dot_by_u3_value,
        ],
        [
            zero, u1_dot_by_q2_minus_90deg, zero, zero, zero, zero, u1_dot_by_u2_value,
            u1_dot_by_u3,
        ],
        [zero, zero, zero, zero, zero, u2_dot_by_u1_value, zero, u2_dot_by_u3_value],
        [
            zero, u3_dot_by_q2_minus_90deg, zero, zero, zero, u3_dot_by_u1, u3_dot_by_u2_value,
            u3_dot_by_u3,
        ],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 5], _u: &[S; 3]) -> [S; 1] {
    let [_, q2_minus_90deg, _, _, _] = *q;
    // Sines and cosines.
    let (sin_q2_minus_90deg, _) = q2_minus_90deg.sin_cos();
    // Values.
    // divisor1 = sin(q2_minus_90deg)
    let divisor1 = sin_q2_minus_90deg;
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (u1, u2, u3) that must act beside the loads of the model for the accelerations to be (u1', u2', u3').
///
/// 27 operations, 1 sine and cosine.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 3],
    v_dot: &[S; 3],
) -> [S; 3] {
    let Parameters { r, m, g } = *p;
    let [_, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    let [u1_dot, u2_dot, u3_dot] = *v_dot;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Shared terms.
    let tan_q2_minus_90deg = sin_q2_minus_90deg / cos_q2_minus_90deg;
    let tau1_of_u3 = u3 / tan_q2_minus_90deg;
    let r_m = r * m;
    let r_r_m = r * r_m;
    // Values.
    // tau1 = 5*r^2*m*u1'/4 - r*m*(4*g*cos(q2_minus_90deg) + r*u3*(6*u2 + u3/tan(q2_minus_90deg)))/4
    let tau1 = S::ratio(5, 4) * u1_dot * r_r_m
        - S::ratio(1, 4) * r_m
            * (r * u3 * u2.mul_add(S::int(6), tau1_of_u3) + S::int(4) * g * cos_q2_minus_90deg);
    // tau2 = r^2*m*u1*u3 + 3*r^2*m*u2'/2
    let tau2 = (u1 * u3).mul_add(r_r_m, S::ratio(3, 2) * u2_dot * r_r_m);
    // tau3 = r^2*m*u3'/4 + r^2*m*u1*(2*u2 + u3/tan(q2_minus_90deg))/4
    let tau3 = S::ratio(1, 4) * r_r_m * (u3_dot + u1 * u2.mul_add(S::int(2), tau1_of_u3));
    [tau1, tau2, tau3]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 11 convolutions and 16 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 8]],
    history: &mut [Factors<S, 16>],
) {
    let Parameters { r, g, .. } = *p;
    let [q1_0, q2_minus_90deg_0, _, _, _, u1_0, u2_0, u3_0] = series[0];
    // Constant in time.
    // weight = 4*g/(5*r)
    let weight = S::ratio(4, 5) * g / r;
    // Order 0.
    let (sin_q2_minus_90deg_0, cos_q2_minus_90deg_0) = q2_minus_90deg_0.sin_cos();
    let over_sin_q2_minus_90deg = S::int(1) / sin_q2_minus_90deg_0;
    let u3_dot_of_u3_0 = u3_0 * over_sin_q2_minus_90deg;
    let u3_dot_of_u3_2_0 = cos_q2_minus_90deg_0 * u3_dot_of_u3_0;
    let u3_dot_of_u2_u3_0 = S::int(2) * u2_0 + u3_dot_of_u3_2_0;
    let u3_dot_of_u1_u2_u3_0 = u1_0 * u3_dot_of_u2_u3_0;
    let u1_u3_0 = u1_0 * u3_0;
    let u1_dot_of_u2_u3_0 = S::int(6) * u2_0 + u3_dot_of_u3_2_0;
    let u1_dot_of_u2_u3_2_0 = u3_0 * u1_dot_of_u2_u3_0;
    let u1_dot_2_0 = u1_dot_of_u2_u3_2_0
        .mul_add(S::ratio(1, 5), weight * cos_q2_minus_90deg_0);
    let q3_dot_2_0 = u2_0 + u3_dot_of_u3_2_0;
    let (s1_0, c1_0) = q1_0.sin_cos();
    let x_of_u2_u3_0 = c1_0 * q3_dot_2_0;
    let y_of_u2_u3_0 = s1_0 * q3_dot_2_0;
    // Order 1: the rates, and what follows from them.
    let q1_1 = -u3_dot_of_u3_0;
    let q2_minus_90deg_1 = u1_0;
    let q3_1 = q3_dot_2_0;
    let x_1 = r * x_of_u2_u3_0;
    let y_1 = r * y_of_u2_u3_0;
    let u1_1 = u1_dot_2_0;
    let u2_1 = -S::ratio(2, 3) * u1_u3_0;
    let u3_1 = -u3_dot_of_u1_u2_u3_0;
    if series.len() > 1 {
        series[1] = [q1_1, q2_minus_90deg_1, q3_1, x_1, y_1, u1_1, u2_1, u3_1];
    }
    let sin_q2_minus_90deg_1 = q2_minus_90deg_1 * cos_q2_minus_90deg_0;
    let cos_q2_minus_90deg_1 = -q2_minus_90deg_1 * sin_q2_minus_90deg_0;
    let u3_dot_of_u3_1 = sin_q2_minus_90deg_1
        .mul_add(
            -(u3_dot_of_u3_0 * over_sin_q2_minus_90deg),
            u3_1 * over_sin_q2_minus_90deg,
        );
    let u3_dot_of_u3_2_1 = u3_dot_of_u3_1
        .mul_add(cos_q2_minus_90deg_0, cos_q2_minus_90deg_1 * u3_dot_of_u3_0);
    let u3_dot_of_u2_u3_1 = S::int(2) * u2_1 + u3_dot_of_u3_2_1;
    let u3_dot_of_u1_u2_u3_1 = u3_dot_of_u2_u3_1.mul_add(u1_0, u1_1 * u3_dot_of_u2_u3_0);
    let u1_u3_1 = u3_1.mul_add(u1_0, u1_1 * u3_0);
    let u1_dot_of_u2_u3_1 = S::int(6) * u2_1 + u3_dot_of_u3_2_1;
    let u1_dot_of_u2_u3_2_1 = u1_dot_of_u2_u3_1.mul_add(u3_0, u3_1 * u1_dot_of_u2_u3_0);
    let u1_dot_2_1 = u1_dot_of_u2_u3_2_1
        .mul_add(S::ratio(1, 5), weight * cos_q2_minus_90deg_1);
    let q3_dot_2_1 = u2_1 + u3_dot_of_u3_2_1;
    let s1_1 = q1_1 * c1_0;
    let c1_1 = -q1_1 * s1_0;
    let x_of_u2_u3_1 = q3_dot_2_1.mul_add(c1_0, c1_1 * q3_dot_2_0);
    let y_of_u2_u3_1 = q3_dot_2_1.mul_add(s1_0, s1_1 * q3_dot_2_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                q2_minus_90deg_1, q2_minus_90deg_1, sin_q2_minus_90deg_1, cos_q2_minus_90deg_1,
                u1_1, u1_1, u3_1, q1_1, q1_1, c1_1, s1_1,
            ]),
            padded([
                cos_q2_minus_90deg_1, sin_q2_minus_90deg_1, u3_dot_of_u3_1, u3_dot_of_u3_1,
                u3_dot_of_u2_u3_1, u3_1, u1_dot_of_u2_u3_1, c1_1, s1_1, q3_dot_2_1, q3_dot_2_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q1_last = q1_1;
    let mut q2_minus_90deg_last = q2_minus_90deg_1;
    let mut u1_last = u1_1;
    let mut u3_last = u3_1;
    let mut sin_q2_minus_90deg_last = sin_q2_minus_90deg_1;
    let mut cos_q2_minus_90deg_last = cos_q2_minus_90deg_1;
    let mut u3_dot_of_u3_last = u3_dot_of_u3_1;
    let mut u3_dot_of_u2_u3_last = u3_dot_of_u2_u3_1;
    let mut u1_dot_of_u2_u3_last = u1_dot_of_u2_u3_1;
    let mut q3_dot_2_last = q3_dot_2_1;
    let mut s1_last = s1_1;
    let mut c1_last = c1_1;
    let mut next = [S::int(0); 16];
    // Rates at order k - 1.
    let mut q1_rate = -u3_dot_of_u3_1;
    let mut q2_minus_90deg_rate = u1_1;
    let mut q3_rate = q3_dot_2_1;
    let mut x_rate = r * x_of_u2_u3_1;
    let mut y_rate = r * y_of_u2_u3_1;
    let mut u1_rate = u1_dot_2_1;
    let mut u2_rate = -S::ratio(2, 3) * u1_u3_1;
    let mut u3_rate = -u3_dot_of_u1_u2_u3_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q1 = q1_rate * over_k;
        let q2_minus_90deg = q2_minus_90deg_rate * over_k;
        let q3 = q3_rate * over_k;
        let x = x_rate * over_k;
        let y = y_rate * over_k;
        let u1 = u1_rate * over_k;
        let u2 = u2_rate * over_k;
        let u3 = u3_rate * over_k;
        series[order] = [q1, q2_minus_90deg, q3, x, y, u1, u2, u3];
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
                q2_minus_90deg_1
                    .mul_add(
                        cos_q2_minus_90deg_last,
                        (count_last * q2_minus_90deg_last)
                            .mul_add(cos_q2_minus_90deg_1, next[0]),
                    ),
                q2_minus_90deg_1
                    .mul_add(
                        sin_q2_minus_90deg_last,
                        (count_last * q2_minus_90deg_last)
                            .mul_add(sin_q2_minus_90deg_1, next[1]),
                    ),
                sin_q2_minus_90deg_1
                    .mul_add(
                        u3_dot_of_u3_last,
                        sin_q2_minus_90deg_last.mul_add(u3_dot_of_u3_1, next[2]),
                    ),
                cos_q2_minus_90deg_1
                    .mul_add(
                        u3_dot_of_u3_last,
                        cos_q2_minus_90deg_last.mul_add(u3_dot_of_u3_1, next[3]),
                    ),
                u1_1
                    .mul_add(
                        u3_dot_of_u2_u3_last,
                        u1_last.mul_add(u3_dot_of_u2_u3_1, next[4]),
                    ),
                u1_1.mul_add(u3_last, u1_last.mul_add(u3_1, next[5])),
                u3_1
                    .mul_add(
                        u1_dot_of_u2_u3_last,
                        u3_last.mul_add(u1_dot_of_u2_u3_1, next[6]),
                    ),
                q1_1.mul_add(c1_last, (count_last * q1_last).mul_add(c1_1, next[7])),
                q1_1.mul_add(s1_last, (count_last * q1_last).mul_add(s1_1, next[8])),
                c1_1.mul_add(q3_dot_2_last, c1_last.mul_add(q3_dot_2_1, next[9])),
                s1_1.mul_add(q3_dot_2_last, s1_last.mul_add(q3_dot_2_1, next[10])),
            ])
        };
        // sin_q2_minus_90deg = sin(q2_minus_90deg)
        let sin_q2_minus_90deg = q2_minus_90deg
            .mul_add(cos_q2_minus_90deg_0, sums[0] * over_k);
        // cos_q2_minus_90deg = cos(q2_minus_90deg)
        let cos_q2_minus_90deg = -q2_minus_90deg
            .mul_add(sin_q2_minus_90deg_0, sums[1] * over_k);
        // u3_dot_of_u3 = u3/sin_q2_minus_90deg
        let u3_dot_of_u3 = sin_q2_minus_90deg
            .mul_add(
                -(u3_dot_of_u3_0 * over_sin_q2_minus_90deg),
                (u3 - sums[2]) * over_sin_q2_minus_90deg,
            );
        // u3_dot_of_u3_2 = cos_q2_minus_90deg*u3_dot_of_u3
        let u3_dot_of_u3_2 = u3_dot_of_u3
            .mul_add(
                cos_q2_minus_90deg_0,
                cos_q2_minus_90deg.mul_add(u3_dot_of_u3_0, sums[3]),
            );
        // u3_dot_of_u2_u3 = 2*u2 + u3_dot_of_u3_2
        let u3_dot_of_u2_u3 = S::int(2) * u2 + u3_dot_of_u3_2;
        // u3_dot_of_u1_u2_u3 = u1*u3_dot_of_u2_u3
        let u3_dot_of_u1_u2_u3 = u3_dot_of_u2_u3
            .mul_add(u1_0, u1.mul_add(u3_dot_of_u2_u3_0, sums[4]));
        // u1_u3 = u1*u3
        let u1_u3 = u3.mul_add(u1_0, u1.mul_add(u3_0, sums[5]));
        // u1_dot_of_u2_u3 = 6*u2 + u3_dot_of_u3_2
        let u1_dot_of_u2_u3 = S::int(6) * u2 + u3_dot_of_u3_2;
        // u1_dot_of_u2_u3_2 = u3*u1_dot_of_u2_u3
        let u1_dot_of_u2_u3_2 = u1_dot_of_u2_u3
            .mul_add(u3_0, u3.mul_add(u1_dot_of_u2_u3_0, sums[6]));
        // u1_dot_2 = 1/5*u1_dot_of_u2_u3_2 + weight*cos_q2_minus_90deg
        let u1_dot_2 = u1_dot_of_u2_u3_2
            .mul_add(S::ratio(1, 5), weight * cos_q2_minus_90deg);
        // q3_dot_2 = u2 + u3_dot_of_u3_2
        let q3_dot_2 = u2 + u3_dot_of_u3_2;
        // s1 = sin(q1)
        let s1 = q1.mul_add(c1_0, sums[7] * over_k);
        // c1 = cos(q1)
        let c1 = -q1.mul_add(s1_0, sums[8] * over_k);
        // x_of_u2_u3 = c1*q3_dot_2
        let x_of_u2_u3 = q3_dot_2.mul_add(c1_0, c1.mul_add(q3_dot_2_0, sums[9]));
        // y_of_u2_u3 = s1*q3_dot_2
        let y_of_u2_u3 = q3_dot_2.mul_add(s1_0, s1.mul_add(q3_dot_2_0, sums[10]));
        q1_rate = -u3_dot_of_u3;
        q2_minus_90deg_rate = u1;
        q3_rate = q3_dot_2;
        x_rate = r * x_of_u2_u3;
        y_rate = r * y_of_u2_u3;
        u1_rate = u1_dot_2;
        u2_rate = -S::ratio(2, 3) * u1_u3;
        u3_rate = -u3_dot_of_u1_u2_u3;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * q2_minus_90deg,
                count * q2_minus_90deg,
                sin_q2_minus_90deg, cos_q2_minus_90deg, u1, u1, u3,
                count * q1,
                count * q1,
                c1, s1,
            ]),
            padded([
                cos_q2_minus_90deg, sin_q2_minus_90deg, u3_dot_of_u3, u3_dot_of_u3, u3_dot_of_u2_u3,
                u3, u1_dot_of_u2_u3, c1, s1, q3_dot_2, q3_dot_2,
            ]),
        ];
        count_last = count;
        q1_last = q1;
        q2_minus_90deg_last = q2_minus_90deg;
        u1_last = u1;
        u3_last = u3;
        sin_q2_minus_90deg_last = sin_q2_minus_90deg;
        cos_q2_minus_90deg_last = cos_q2_minus_90deg;
        u3_dot_of_u3_last = u3_dot_of_u3;
        u3_dot_of_u2_u3_last = u3_dot_of_u2_u3;
        u1_dot_of_u2_u3_last = u1_dot_of_u2_u3;
        q3_dot_2_last = q3_dot_2;
        s1_last = s1;
        c1_last = c1;
    }
}

/// Kane's method in q2-90° of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct KaneQ290deg;

impl<S: Scalar> System<S> for KaneQ290deg {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 3,
            coordinates: 5,
            variables: 3,
            speeds: 3,
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
    slice.try_into().expect("a slice of the length that System states")
}
