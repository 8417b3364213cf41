//! Symmetric heavy top about a fixed point: Looping.
//!
//! Generated from `models/heavy_top/scenes/looping.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{CompiledScene, CompiledSystem, Lengths, Scalar, System};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// mass, kg
    pub m: S,
    /// fixed point to the mass centre, m
    pub l: S,
    /// across the axis, about the fixed point, kg*m^2
    pub I1: S,
    /// about the axis, kg*m^2
    pub I3: S,
    /// acceleration of free fall, m/s^2
    pub g: S,
    /// momentum p_q3 = ∂L/∂q3', kg*m^2/s
    pub p_q3: S,
    /// m*l*g, kg*m^2/s^2
    pub m_l_g: S,
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
            m: p[0], l: p[1], I1: p[2], I3: p[3], g: p[4], p_q3: p[5], m_l_g: p[6],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 7] {
        let Self { m, l, I1, I3, g, p_q3, m_l_g, .. } = self;
        [m, l, I1, I3, g, p_q3, m_l_g]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 7] = ["m", "l", "I1", "I3", "g", "p_q3", "m_l_g"];

/// Names of the outputs.
pub const OUTPUTS: [&str; 6] = ["q1", "q2", "q3", "u1", "u2", "u3"];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 3 operations.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    _q: &[S; 3],
    u: &[S; 3],
) -> [S; 7] {
    let super::super::super::Parameters { m, l, I1, I3, g } = *p;
    let [_, _, u3] = *u;
    // Values.
    // m
    let m_value = m;
    // l
    let l_value = l;
    // I1
    let I1_value = I1;
    // I3
    let I3_value = I3;
    // g
    let g_value = g;
    // p_q3 = I3*u3
    let p_q3_value = I3 * u3;
    // m_l_g = m*l*g
    let m_l_g_value = m * l * g;
    [m_value, l_value, I1_value, I3_value, g_value, p_q3_value, m_l_g_value]
}

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// 0 operations.
#[must_use]
pub fn start<S: Scalar>(
    _p: &super::super::super::Parameters<S>,
    q: &[S; 3],
    u: &[S; 3],
) -> ([S; 3], [S; 2]) {
    let [q1, q2, q3] = *q;
    let [u1, u2, _] = *u;
    // Values.
    // q1
    let q1_value = q1;
    // q2
    let q2_value = q2;
    // q3
    let q3_value = q3;
    // u1
    let u1_value = u1;
    // u2
    let u2_value = u2;
    ([q1_value, q2_value, q3_value], [u1_value, u2_value])
}

/// The accelerations (u1', u2'), solved for when this code was generated.
///
/// 15 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [S; 2] {
    let Parameters { I1, I3, p_q3, m_l_g, .. } = *p;
    let [q1, q2, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u3 = p_q3/I3
    let u3 = p_q3 / I3;
    let i1_inv = S::int(1) / I1;
    let t2 = s2 / c2;
    // I3*u3*i1_inv - u1*tan(q2)
    let u2_dot_of_u1 = (-u1).mul_add(t2, I3 * u3 * i1_inv);
    let m_l_g_i1_inv = m_l_g * i1_inv;
    // u2' = (u1*(I3*u3 - I1*u1*tan(q2)) + m_l_g*cos(q1)*sin(q2))/I1
    let u2_dot = (m_l_g_i1_inv * c1).mul_add(s2, u1 * u2_dot_of_u1);
    // u1' = (m_l_g*sin(q1) - u2*(I3*u3 - I1*u1*tan(q2)))/I1
    let u1_dot = (-u2).mul_add(u2_dot_of_u1, m_l_g_i1_inv * s1);
    [u1_dot, u2_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [S; 3] {
    let Parameters { I3, p_q3, .. } = *p;
    let [_, q2, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u3 = p_q3/I3
    let u3 = p_q3 / I3;
    let u1_c2_inv = u1 / c2;
    // Values.
    // q1' = u1/cos(q2)
    let q1_dot_value = u1_c2_inv;
    // q2' = u2
    let q2_dot_value = u2;
    // q3' = u3 - u1*tan(q2)
    let q3_dot_value = (-u1_c2_inv).mul_add(s2, u3);
    [q1_dot_value, q2_dot_value, q3_dot_value]
}

/// Kinetic energy T.
///
/// 5 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 3], u: &[S; 2]) -> S {
    let Parameters { I1, .. } = *p;
    let [u1, u2] = *u;
    // Values.
    // T = I1*(u1^2 + u2^2)/2
    let energy = S::ratio(1, 2) * I1 * u2.mul_add(u2, u1 * u1);
    energy
}

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// 9 operations, 2 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3]) -> S {
    let Parameters { m, l, I3, g, p_q3, .. } = *p;
    let [q1, q2, _] = *q;
    // Sines and cosines.
    let (_, c2) = q2.sin_cos();
    let (_, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u3 = p_q3/I3
    let u3 = p_q3 / I3;
    // Values.
    // V = m*l*g*cos(q1)*cos(q2) + I3*u3^2/2
    let energy = (m * l * g * c1).mul_add(c2, S::ratio(1, 2) * I3 * u3 * u3);
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 1 operation.
#[must_use]
pub fn outputs<S: Scalar>(p: &Parameters<S>, _t: S, q: &[S; 3], u: &[S; 2]) -> [S; 6] {
    let Parameters { I3, p_q3, .. } = *p;
    let [q1, q2, q3] = *q;
    let [u1, u2] = *u;
    // Elimination, step by step, each after the terms that it shares.
    // u3 = p_q3/I3
    let u3 = p_q3 / I3;
    // Values.
    // q1
    let q1_value = q1;
    // q2
    let q2_value = q2;
    // q3
    let q3_value = q3;
    // u1
    let u1_value = u1;
    // u2
    let u2_value = u2;
    [q1_value, q2_value, q3_value, u1_value, u2_value, u3]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 16 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 2],
) -> ([S; 3], [S; 2]) {
    let Parameters { I1, I3, p_q3, m_l_g, .. } = *p;
    let [q1, q2, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u3 = p_q3/I3
    let u3 = p_q3 / I3;
    let i1_inv = S::int(1) / I1;
    let u1_c2_inv = u1 / c2;
    let s2_u1_c2_inv = u1_c2_inv * s2;
    // I3*u3*i1_inv - s2_u1_c2_inv
    let u2_dot_of_u1 = (I3 * u3).mul_add(i1_inv, -s2_u1_c2_inv);
    let m_l_g_i1_inv = m_l_g * i1_inv;
    // u2' = (u1*(I3*u3 - I1*u1*tan(q2)) + m_l_g*cos(q1)*sin(q2))/I1
    let u2_dot = (m_l_g_i1_inv * c1).mul_add(s2, u1 * u2_dot_of_u1);
    // u1' = (m_l_g*sin(q1) - u2*(I3*u3 - I1*u1*tan(q2)))/I1
    let u1_dot = (-u2).mul_add(u2_dot_of_u1, m_l_g_i1_inv * s1);
    // Values.
    // q1' = u1/cos(q2)
    let q1_dot_value = u1_c2_inv;
    // q2' = u2
    let q2_dot_value = u2;
    // q3' = u3 - u1*tan(q2)
    let q3_dot_value = u3 - s2_u1_c2_inv;
    ([q1_dot_value, q2_dot_value, q3_dot_value], [u1_dot, u2_dot])
}

/// Jacobian of the derivative by the state; columns q1, q2, q3, u1, u2.
///
/// 25 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [[S; 5]; 5] {
    let Parameters { I1, I3, p_q3, m_l_g, .. } = *p;
    let [q1, q2, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u3 = p_q3/I3
    let u3 = p_q3 / I3;
    let i1_inv = S::int(1) / I1;
    let m_l_g_i1_inv = m_l_g * i1_inv;
    // u2_dot_by_q1 = -m_l_g*sin(q1)*sin(q2)/I1
    let u2_dot_by_q1 = -m_l_g_i1_inv * s1 * s2;
    // u1_dot_by_q1 = m_l_g*cos(q1)/I1
    let u1_dot_by_q1 = m_l_g_i1_inv * c1;
    let c2_inv = S::int(1) / c2;
    let u1_c2_inv = u1 * c2_inv;
    // u2_dot_by_q2 = m_l_g*cos(q1)*cos(q2)/I1 - u1^2/cos(q2)^2
    let u2_dot_by_q2 = (-u1_c2_inv).mul_add(u1_c2_inv, u1_dot_by_q1 * c2);
    let c2_inv_u1_c2_inv = c2_inv * u1_c2_inv;
    // u1_dot_by_q2 = u1*u2/cos(q2)^2
    let u1_dot_by_q2 = u2 * c2_inv_u1_c2_inv;
    let s2_u1_c2_inv = u1_c2_inv * s2;
    let i3_u3_i1_inv = I3 * u3 * i1_inv;
    // u2_dot_by_u1 = I3*u3/I1 - 2*u1*tan(q2)
    let u2_dot_by_u1 = (-s2_u1_c2_inv).mul_add(S::int(2), i3_u3_i1_inv);
    let s2_c2_inv = c2_inv * s2;
    // u1_dot_by_u1 = u2*tan(q2)
    let u1_dot_by_u1 = u2 * s2_c2_inv;
    // u1_dot_by_u2 = u1*tan(q2) - I3*u3/I1
    let u1_dot_by_u2 = s2_u1_c2_inv - i3_u3_i1_inv;
    // Entries that are not zero.
    // d(q1')/d(q2) = u1*tan(q2)/cos(q2)
    let q1_dot_by_q2_value = u1_c2_inv * s2_c2_inv;
    // d(q1')/d(u1) = 1/cos(q2)
    let q1_dot_by_u1_value = c2_inv;
    // d(q2')/d(u2) = 1
    let q2_dot_by_u2_value = S::int(1);
    // d(q3')/d(q2) = -u1/cos(q2)^2
    let q3_dot_by_q2_value = -c2_inv_u1_c2_inv;
    // d(q3')/d(u1) = -tan(q2)
    let q3_dot_by_u1_value = -s2_c2_inv;
    let zero = S::int(0);
    [
        [zero, q1_dot_by_q2_value, zero, q1_dot_by_u1_value, zero],
        [zero, zero, zero, zero, q2_dot_by_u2_value],
        [zero, q3_dot_by_q2_value, zero, q3_dot_by_u1_value, zero],
        [u1_dot_by_q1, u1_dot_by_q2, zero, u1_dot_by_u1, u1_dot_by_u2],
        [u2_dot_by_q1, u2_dot_by_q2, zero, u2_dot_by_u1, zero],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 3], _u: &[S; 2]) -> [S; 1] {
    let [_, q2, _] = *q;
    // Sines and cosines.
    let (_, c2) = q2.sin_cos();
    // Values.
    // divisor1 = cos(q2)
    let divisor1 = c2;
    [divisor1]
}

/// The energy, then its derivatives by the state.
///
/// 21 operations, 2 sines and cosines.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 2]) -> [S; 6] {
    let Parameters { m, l, I1, I3, g, p_q3, .. } = *p;
    let [q1, q2, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // u3 = p_q3/I3
    let u3 = p_q3 / I3;
    let m_l_g_2 = m * l * g;
    let c2_m_l_g_2 = m_l_g_2 * c2;
    // I1*(u1^2 + u2^2) + I3*u3^2
    let energy_of_u1_u2 = I1 * u2.mul_add(u2, u1 * u1) + I3 * u3 * u3;
    // Values.
    // T + V = m*l*g*cos(q1)*cos(q2) + I1*(u1^2 + u2^2)/2 + I3*u3^2/2
    let energy = c2_m_l_g_2.mul_add(c1, S::ratio(1, 2) * energy_of_u1_u2);
    // d(T + V)/d(q1) = -m*l*g*sin(q1)*cos(q2)
    let energy_by_q1 = -c2_m_l_g_2 * s1;
    // d(T + V)/d(q2) = -m*l*g*cos(q1)*sin(q2)
    let energy_by_q2 = -m_l_g_2 * c1 * s2;
    // d(T + V)/d(u1) = I1*u1
    let energy_by_u1 = I1 * u1;
    // d(T + V)/d(u2) = I1*u2
    let energy_by_u2 = I1 * u2;
    let zero = S::int(0);
    [energy, energy_by_q1, energy_by_q2, zero, energy_by_u1, energy_by_u2]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 9 convolutions and 12 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 5]],
    history: &mut [Factors<S, 16>],
) {
    let Parameters { I1, I3, p_q3, m_l_g, .. } = *p;
    let [q1_0, q2_0, _, u1_0, u2_0] = series[0];
    // Shared terms.
    let i1_inv = S::int(1) / I1;
    // Constant in time.
    // minus_i1 = -I1
    let minus_i1 = -I1;
    // minus_m_l_g = -m_l_g
    let minus_m_l_g = -m_l_g;
    // p_q3_by_i3 = p_q3/I3
    let p_q3_by_i3 = p_q3 / I3;
    // minus_1_by_i1 = -1/I1
    let minus_1_by_i1 = -i1_inv;
    // weight = 1/I1
    let weight = i1_inv;
    // Order 0.
    let (s2_0, c2_0) = q2_0.sin_cos();
    let over_c2 = S::int(1) / c2_0;
    let (s1_0, c1_0) = q1_0.sin_cos();
    let q1_dot_2_0 = u1_0 * over_c2;
    let u1_c2_inv_s2_0 = s2_0 * q1_dot_2_0;
    let u2_dot_of_u1_0 = u1_c2_inv_s2_0.mul_add(minus_i1, p_q3);
    let u2_dot_of_u1_2_0 = u1_0 * u2_dot_of_u1_0;
    let s2_c1_0 = s2_0 * c1_0;
    let u2_dot_of_u1_3_0 = m_l_g * s2_c1_0 + u2_dot_of_u1_2_0;
    let u1_dot_of_u1_u2_0 = u2_0 * u2_dot_of_u1_0;
    let u1_dot_of_u1_u2_2_0 = minus_m_l_g * s1_0 + u1_dot_of_u1_u2_0;
    let q3_dot_2_0 = p_q3_by_i3 - u1_c2_inv_s2_0;
    // Order 1: the rates, and what follows from them.
    let q1_1 = q1_dot_2_0;
    let q2_1 = u2_0;
    let q3_1 = q3_dot_2_0;
    let u1_1 = minus_1_by_i1 * u1_dot_of_u1_u2_2_0;
    let u2_1 = weight * u2_dot_of_u1_3_0;
    if series.len() > 1 {
        series[1] = [q1_1, q2_1, q3_1, u1_1, u2_1];
    }
    let s2_1 = q2_1 * c2_0;
    let c2_1 = -q2_1 * s2_0;
    let s1_1 = q1_1 * c1_0;
    let c1_1 = -q1_1 * s1_0;
    let q1_dot_2_1 = c2_1.mul_add(-(q1_dot_2_0 * over_c2), u1_1 * over_c2);
    let u1_c2_inv_s2_1 = q1_dot_2_1.mul_add(s2_0, s2_1 * q1_dot_2_0);
    let u2_dot_of_u1_1 = minus_i1 * u1_c2_inv_s2_1;
    let u2_dot_of_u1_2_1 = u2_dot_of_u1_1.mul_add(u1_0, u1_1 * u2_dot_of_u1_0);
    let s2_c1_1 = c1_1.mul_add(s2_0, s2_1 * c1_0);
    let u2_dot_of_u1_3_1 = m_l_g * s2_c1_1 + u2_dot_of_u1_2_1;
    let u1_dot_of_u1_u2_1 = u2_dot_of_u1_1.mul_add(u2_0, u2_1 * u2_dot_of_u1_0);
    let u1_dot_of_u1_u2_2_1 = minus_m_l_g * s1_1 + u1_dot_of_u1_u2_1;
    let q3_dot_2_1 = -u1_c2_inv_s2_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([q2_1, q2_1, q1_1, q1_1, c2_1, s2_1, u1_1, s2_1, u2_1]),
            padded([
                c2_1, s2_1, c1_1, s1_1, q1_dot_2_1, q1_dot_2_1, u2_dot_of_u1_1, c1_1,
                u2_dot_of_u1_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q1_last = q1_1;
    let mut q2_last = q2_1;
    let mut u1_last = u1_1;
    let mut u2_last = u2_1;
    let mut s2_last = s2_1;
    let mut c2_last = c2_1;
    let mut s1_last = s1_1;
    let mut c1_last = c1_1;
    let mut q1_dot_2_last = q1_dot_2_1;
    let mut u2_dot_of_u1_last = u2_dot_of_u1_1;
    let mut next = [S::int(0); 16];
    // Rates at order k - 1.
    let mut q1_rate = q1_dot_2_1;
    let mut q2_rate = u2_1;
    let mut q3_rate = q3_dot_2_1;
    let mut u1_rate = minus_1_by_i1 * u1_dot_of_u1_u2_2_1;
    let mut u2_rate = weight * u2_dot_of_u1_3_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q1 = q1_rate * over_k;
        let q2 = q2_rate * over_k;
        let q3 = q3_rate * over_k;
        let u1 = u1_rate * over_k;
        let u2 = u2_rate * over_k;
        series[order] = [q1, q2, q3, u1, u2];
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
                q2_1.mul_add(c2_last, (count_last * q2_last).mul_add(c2_1, next[0])),
                q2_1.mul_add(s2_last, (count_last * q2_last).mul_add(s2_1, next[1])),
                q1_1.mul_add(c1_last, (count_last * q1_last).mul_add(c1_1, next[2])),
                q1_1.mul_add(s1_last, (count_last * q1_last).mul_add(s1_1, next[3])),
                c2_1.mul_add(q1_dot_2_last, c2_last.mul_add(q1_dot_2_1, next[4])),
                s2_1.mul_add(q1_dot_2_last, s2_last.mul_add(q1_dot_2_1, next[5])),
                u1_1
                    .mul_add(
                        u2_dot_of_u1_last,
                        u1_last.mul_add(u2_dot_of_u1_1, next[6]),
                    ),
                s2_1.mul_add(c1_last, s2_last.mul_add(c1_1, next[7])),
                u2_1.mul_add(u2_dot_of_u1_last, u2_last.mul_add(u2_dot_of_u1_1, next[8])),
            ])
        };
        // s2 = sin(q2)
        let s2 = q2.mul_add(c2_0, sums[0] * over_k);
        // c2 = cos(q2)
        let c2 = -q2.mul_add(s2_0, sums[1] * over_k);
        // s1 = sin(q1)
        let s1 = q1.mul_add(c1_0, sums[2] * over_k);
        // c1 = cos(q1)
        let c1 = -q1.mul_add(s1_0, sums[3] * over_k);
        // q1_dot_2 = u1/c2
        let q1_dot_2 = c2.mul_add(-(q1_dot_2_0 * over_c2), (u1 - sums[4]) * over_c2);
        // u1_c2_inv_s2 = s2*q1_dot_2
        let u1_c2_inv_s2 = q1_dot_2.mul_add(s2_0, s2.mul_add(q1_dot_2_0, sums[5]));
        // u2_dot_of_u1 = p_q3 + minus_i1*u1_c2_inv_s2
        let u2_dot_of_u1 = minus_i1 * u1_c2_inv_s2;
        // u2_dot_of_u1_2 = u1*u2_dot_of_u1
        let u2_dot_of_u1_2 = u2_dot_of_u1
            .mul_add(u1_0, u1.mul_add(u2_dot_of_u1_0, sums[6]));
        // s2_c1 = s2*c1
        let s2_c1 = c1.mul_add(s2_0, s2.mul_add(c1_0, sums[7]));
        // u2_dot_of_u1_3 = u2_dot_of_u1_2 + m_l_g*s2_c1
        let u2_dot_of_u1_3 = m_l_g * s2_c1 + u2_dot_of_u1_2;
        // u1_dot_of_u1_u2 = u2*u2_dot_of_u1
        let u1_dot_of_u1_u2 = u2_dot_of_u1
            .mul_add(u2_0, u2.mul_add(u2_dot_of_u1_0, sums[8]));
        // u1_dot_of_u1_u2_2 = u1_dot_of_u1_u2 + minus_m_l_g*s1
        let u1_dot_of_u1_u2_2 = minus_m_l_g * s1 + u1_dot_of_u1_u2;
        // q3_dot_2 = p_q3_by_i3 - u1_c2_inv_s2
        let q3_dot_2 = -u1_c2_inv_s2;
        q1_rate = q1_dot_2;
        q2_rate = u2;
        q3_rate = q3_dot_2;
        u1_rate = minus_1_by_i1 * u1_dot_of_u1_u2_2;
        u2_rate = weight * u2_dot_of_u1_3;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([count * q2, count * q2, count * q1, count * q1, c2, s2, u1, s2, u2]),
            padded([c2, s2, c1, s1, q1_dot_2, q1_dot_2, u2_dot_of_u1, c1, u2_dot_of_u1]),
        ];
        count_last = count;
        q1_last = q1;
        q2_last = q2;
        u1_last = u1;
        u2_last = u2;
        s2_last = s2;
        c2_last = c2;
        s1_last = s1;
        c1_last = c1;
        q1_dot_2_last = q1_dot_2;
        u2_dot_of_u1_last = u2_dot_of_u1;
    }
}

/// Reduced equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Reduced;

impl<S: Scalar> System<S> for Reduced {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 7,
            coordinates: 3,
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
        6
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
    fn divisor_count(&self) -> usize {
        1
    }
    fn divisor_name(&self, at: usize) -> &str {
        ["cos(q2)"][at]
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

/// What a program needs to find these equations and to trust them.
pub const SCENE: CompiledScene = CompiledScene {
    name: "looping",
    key: "36b00938617f9a76",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: None,
    },
};
