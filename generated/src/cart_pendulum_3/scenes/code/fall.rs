//! Three-link pendulum on a cart: Three links fall over while the cart is pushed.
//!
//! Generated from `models/cart_pendulum_3/scenes/fall.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{CompiledScene, CompiledSystem, Lengths, Scalar, System};

/// The parameters, in the order of the model file.
#[allow(non_snake_case)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters<S> {
    /// mass of the cart, kg
    pub m0: S,
    /// mass at the end of link 1, kg
    pub m1: S,
    /// mass at the end of link 2, kg
    pub m2: S,
    /// mass at the end of link 3, kg
    pub m3: S,
    /// length of link 1, m
    pub l0: S,
    /// length of link 2, m
    pub l1: S,
    /// length of link 3, m
    pub l2: S,
    /// acceleration of free fall, m/s^2
    pub g: S,
    /// m3*l2, kg*m
    pub m3_l2: S,
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
            m0: p[0], m1: p[1], m2: p[2], m3: p[3], l0: p[4], l1: p[5], l2: p[6], g: p[7],
            m3_l2: p[8],
        }
    }
    /// The values, in the order of [`PARAMETERS`].
    #[must_use]
    #[inline]
    pub fn to_array(self) -> [S; 9] {
        let Self { m0, m1, m2, m3, l0, l1, l2, g, m3_l2, .. } = self;
        [m0, m1, m2, m3, l0, l1, l2, g, m3_l2]
    }
}

/// Names of the parameters: those that stay free, then what the start of a motion fixes.
pub const PARAMETERS: [&str; 9] = [
    "m0", "m1", "m2", "m3", "l0", "l1", "l2", "g", "m3_l2",
];

/// Names of the outputs.
pub const OUTPUTS: [&str; 8] = ["q0", "q1", "q2", "q3", "u0", "u1", "u2", "u3"];

/// The parameters of these equations, in the order of `PARAMETERS`, for the motion of the whole model that starts so.
///
/// 1 operation.
#[must_use]
pub fn constants<S: Scalar>(
    p: &super::super::super::Parameters<S>,
    _q: &[S; 4],
    _u: &[S; 4],
) -> [S; 9] {
    let super::super::super::Parameters { m0, m1, m2, m3, l0, l1, l2, g, .. } = *p;
    // Values.
    // m0
    let m0_value = m0;
    // m1
    let m1_value = m1;
    // m2
    let m2_value = m2;
    // m3
    let m3_value = m3;
    // l0
    let l0_value = l0;
    // l1
    let l1_value = l1;
    // l2
    let l2_value = l2;
    // g
    let g_value = g;
    // m3_l2 = m3*l2
    let m3_l2_value = m3 * l2;
    [
        m0_value, m1_value, m2_value, m3_value, l0_value, l1_value, l2_value, g_value, m3_l2_value,
    ]
}

/// The coordinates and the motion variables of these equations, at this start of the whole model.
///
/// 0 operations.
#[must_use]
pub fn start<S: Scalar>(
    _p: &super::super::super::Parameters<S>,
    q: &[S; 4],
    u: &[S; 4],
) -> ([S; 4], [S; 4]) {
    let [q0, q1, q2, q3] = *q;
    let [u0, u1, u2, u3] = *u;
    // Values.
    // q1
    let q1_value = q1;
    // q2
    let q2_value = q2;
    // q3
    let q3_value = q3;
    // q0
    let q0_value = q0;
    // u1
    let u1_value = u1;
    // u2
    let u2_value = u2;
    // u3
    let u3_value = u3;
    // u0
    let u0_value = u0;
    ([q1_value, q2_value, q3_value, q0_value], [u1_value, u2_value, u3_value, u0_value])
}

/// The accelerations (u1', u2', u3', u0'), solved for when this code was generated.
///
/// 129 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [S; 4] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, m3_l2 } = *p;
    let [q1, q2, q3, _] = *q;
    let [u1, u2, u3, _] = *u;
    // Sines and cosines.
    let (s3_2, c3) = q3.sin_cos();
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let m3_l2_2 = m3 * l2;
    // d1 = m3*l2^2
    let d1 = l2 * m3_l2_2;
    let d1_inv = S::int(1) / d1;
    // l2_ = -m3_l2*cos(q3)/d1
    let l2_ = -m3_l2 * d1_inv * c3;
    // m2 + m3
    let m2_plus_m3 = m2 + m3;
    // m1 + m2_plus_m3
    let m1_plus_m2_plus_m3 = m1 + m2_plus_m3;
    let l2__m3_l2 = l2_ * m3_l2;
    // s3 = m0 + m1 + m2 + m3 + l2_*m3_l2*cos(q3)
    let s3 = l2__m3_l2.mul_add(c3, m0 + m1_plus_m2_plus_m3);
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let cos_q1_minus_q3 = c1.mul_add(c3, s1 * s3_2);
    let l0_cos_q1_minus_q3 = l0 * cos_q1_minus_q3;
    let l0_m1_plus_m2_plus_m3 = l0 * m1_plus_m2_plus_m3;
    // s4 = -l0*(cos(q1)*(m1 + m2 + m3) + l2_*m3_l2*cos(q1 - q3))
    let s4 = (-l0_m1_plus_m2_plus_m3).mul_add(c1, -l2__m3_l2 * l0_cos_q1_minus_q3);
    let l1_m2_plus_m3 = l1 * m2_plus_m3;
    // sin(q2)*sin(q3) + cos(q2)*cos(q3)
    let cos_q2_minus_q3 = c2.mul_add(c3, s2 * s3_2);
    let l1_cos_q2_minus_q3 = l1 * cos_q2_minus_q3;
    // s5 = -l1*(cos(q2)*(m2 + m3) + l2_*m3_l2*cos(q2 - q3))
    let s5 = (-l2__m3_l2).mul_add(l1_cos_q2_minus_q3, -l1_m2_plus_m3 * c2);
    let u1_sq = u1 * u1;
    // sin(q1)*cos(q3) - cos(q1)*sin(q3)
    let sin_q1_minus_q3 = (-c1).mul_add(s3_2, s1 * c3);
    let l0_sin_q1_minus_q3 = l0 * sin_q1_minus_q3;
    let u2_sq = u2 * u2;
    // sin(q2)*cos(q3) - cos(q2)*sin(q3)
    let sin_q2_minus_q3 = (-c2).mul_add(s3_2, s2 * c3);
    let l1_sin_q2_minus_q3 = l1 * sin_q2_minus_q3;
    // u1_sq*l0_sin_q1_minus_q3 + u2_sq*l1_sin_q2_minus_q3
    let r6_of_u1_u2 = u2_sq.mul_add(l1_sin_q2_minus_q3, u1_sq * l0_sin_q1_minus_q3);
    // g*sin(q3) + r6_of_u1_u2
    let g_s3_2_plus_r6_of_u1_u2 = g.mul_add(s3_2, r6_of_u1_u2);
    let u3_sq_m3_l2 = u3 * u3 * m3_l2;
    let s2_l1_m2_plus_m3 = l1_m2_plus_m3 * s2;
    let s1_l0_m1_plus_m2_plus_m3 = l0_m1_plus_m2_plus_m3 * s1;
    // r6 = 11/4 - l0*u1^2*sin(q1)*(m1 + m2 + m3) - l1*u2^2*sin(q2)*(m2 + m3) - m3_l2*(u3^2*sin(q3) +
    //   l2_*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r6 = (-l2__m3_l2).mul_add(g_s3_2_plus_r6_of_u1_u2, S::ratio(11, 4))
        - u3_sq_m3_l2 * s3_2 - u2_sq * s2_l1_m2_plus_m3 - u1_sq * s1_l0_m1_plus_m2_plus_m3;
    let m3_l2_2_d1_inv = m3_l2_2 * d1_inv;
    // l7 = m3*l0*l2*cos(q1 - q3)/d1
    let l7 = l0_cos_q1_minus_q3 * m3_l2_2_d1_inv;
    let l7_m3_l2 = l7 * m3_l2;
    // s8 = l0*(l0*(m1 + m2 + m3) - l7*m3_l2*cos(q1 - q3))
    let s8 = (-l0_cos_q1_minus_q3).mul_add(l7_m3_l2, l0 * l0_m1_plus_m2_plus_m3);
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let cos_q1_minus_q2 = c1.mul_add(c2, s1 * s2);
    let l0_l1_m2_plus_m3 = l0 * l1_m2_plus_m3;
    // s9 = l1*(l0*cos(q1 - q2)*(m2 + m3) - l7*m3_l2*cos(q2 - q3))
    let s9 = (-l1_cos_q2_minus_q3).mul_add(l7_m3_l2, cos_q1_minus_q2 * l0_l1_m2_plus_m3);
    // sin(q1)*cos(q2) - cos(q1)*sin(q2)
    let sin_q1_minus_q2 = (-c1).mul_add(s2, s1 * c2);
    let r10_of_place = sin_q1_minus_q2 * l0_l1_m2_plus_m3;
    // r10 = l0*(g*sin(q1)*(m1 + m2 + m3) - l1*u2^2*sin(q1 - q2)*(m2 + m3)) - m3_l2*(l0*u3^2*sin(q1 - q3) +
    //   l7*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r10 = (-l0_sin_q1_minus_q3).mul_add(u3_sq_m3_l2, g * s1_l0_m1_plus_m2_plus_m3)
        - g_s3_2_plus_r6_of_u1_u2 * l7_m3_l2 - u2_sq * r10_of_place;
    // l11 = m3*l1*l2*cos(q2 - q3)/d1
    let l11 = l1_cos_q2_minus_q3 * m3_l2_2_d1_inv;
    let l11_m3_l2 = l11 * m3_l2;
    // s12 = l1*(l1*(m2 + m3) - l11*m3_l2*cos(q2 - q3))
    let s12 = (-l1_cos_q2_minus_q3).mul_add(l11_m3_l2, l1 * l1_m2_plus_m3);
    // r13 = l1*(m2 + m3)*(g*sin(q2) + l0*u1^2*sin(q1 - q2)) - m3_l2*(l1*u3^2*sin(q2 - q3) + l11*(g*sin(q3)
    //   + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r13 = (-l1_sin_q2_minus_q3).mul_add(u3_sq_m3_l2, g * s2_l1_m2_plus_m3)
        + u1_sq * r10_of_place - g_s3_2_plus_r6_of_u1_u2 * l11_m3_l2;
    let s3_inv = S::int(1) / s3;
    // l14 = s4/s3
    let l14 = s4 * s3_inv;
    // s15 = s8 - s4*l14
    let s15 = (-s4).mul_add(l14, s8);
    // s16 = s9 - s5*l14
    let s16 = (-s5).mul_add(l14, s9);
    // r17 = r10 - r6*l14
    let r17 = (-r6).mul_add(l14, r10);
    // l18 = s5/s3
    let l18 = s5 * s3_inv;
    // s19 = s12 - s5*l18
    let s19 = (-s5).mul_add(l18, s12);
    // r20 = r13 - r6*l18
    let r20 = (-r6).mul_add(l18, r13);
    let s15_inv = S::int(1) / s15;
    // l21 = s16/s15
    let l21 = s16 * s15_inv;
    // s22 = s19 - s16*l21
    let s22 = (-s16).mul_add(l21, s19);
    // r23 = r20 - r17*l21
    let r23 = (-r17).mul_add(l21, r20);
    // u2' = r23/s22
    let u2_dot = r23 / s22;
    // s15_inv*(u2'*s16 - r17)
    let u0_dot_of_u2_dot = s15_inv * u2_dot.mul_add(s16, -r17);
    // s4*u0_dot_of_u2_dot - u2'*s5
    let u0_dot_of_u2_dot_2 = (-u2_dot).mul_add(s5, s4 * u0_dot_of_u2_dot);
    // u0' = (r6 - s5*r23/s22 + s4*(s16*r23/s22 - r17)/s15)/s3
    let u0_dot = s3_inv * (r6 + u0_dot_of_u2_dot_2);
    // u3' = m3*l2*(g*sin(q3) + cos(q3)*(r6 - s5*r23/s22 + s4*(s16*r23/s22 - r17)/s15)/s3 + l0*(u1^2*sin(q1
    //   - q3) + cos(q1 - q3)*(s16*r23/s22 - r17)/s15) + l1*(u2^2*sin(q2 - q3) - r23*cos(q2 - q3)/s22))/d1
    let u3_dot = m3_l2_2_d1_inv * u0_dot.mul_add(c3, g_s3_2_plus_r6_of_u1_u2)
        - u2_dot * l11 + l7 * u0_dot_of_u2_dot;
    // u1' = (r17 - s16*r23/s22)/s15
    let u1_dot = -u0_dot_of_u2_dot;
    [u1_dot, u2_dot, u3_dot, u0_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 4],
    u: &[S; 4],
) -> [S; 4] {
    let [u1, u2, u3, u0] = *u;
    // Values.
    // q1' = u1
    let q1_dot_value = u1;
    // q2' = u2
    let q2_dot_value = u2;
    // q3' = u3
    let q3_dot_value = u3;
    // q0' = u0
    let q0_dot_value = u0;
    [q1_dot_value, q2_dot_value, q3_dot_value, q0_dot_value]
}

/// Kinetic energy T.
///
/// 39 operations, 3 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> S {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, .. } = *p;
    let [q1, q2, q3, _] = *q;
    let [u1, u2, u3, u0] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3_2, c3) = q3.sin_cos();
    // Shared terms.
    // m2 + m3
    let m2_plus_m3 = m2 + m3;
    // m1 + m2_plus_m3
    let m1_plus_m2_plus_m3 = m1 + m2_plus_m3;
    let l0_u1 = l0 * u1;
    let c1_l0_u1 = l0_u1 * c1;
    // u0 - c1_l0_u1
    let u0_minus_c1_l0_u1 = u0 - c1_l0_u1;
    let s1_l0_u1 = l0_u1 * s1;
    let l1_u2 = l1 * u2;
    let m2_plus_m3_l1_u2 = m2_plus_m3 * l1_u2;
    let l2_u3 = l2 * u3;
    let m3_l2_u3 = m3 * l2_u3;
    // u0_minus_c1_l0_u1*cos(q3) - l1_u2*(sin(q2)*sin(q3) + cos(q2)*cos(q3))
    let energy_of_u0_u1_u2 = -l1_u2 * c2.mul_add(c3, s2 * s3_2) + u0_minus_c1_l0_u1 * c3;
    // m1_plus_m2_plus_m3*l0_u1^2 + l2_u3*m3_l2_u3
    let energy_of_u1_u3 = l2_u3.mul_add(m3_l2_u3, m1_plus_m2_plus_m3 * l0_u1 * l0_u1);
    // u0^2*(m0 + m1_plus_m2_plus_m3) + l1_u2*m2_plus_m3_l1_u2
    let energy_of_u0_u2 = u0 * u0 * (m0 + m1_plus_m2_plus_m3) + l1_u2 * m2_plus_m3_l1_u2;
    // energy_of_u1_u3 + energy_of_u0_u2
    let energy_of_u0_u1_u2_u3 = energy_of_u1_u3 + energy_of_u0_u2;
    // Values.
    // T = u0^2*(m0 + m1 + m2 + m3)/2 + l0*u1*((m1 + m2 + m3)*(l0*u1 - 2*u0*cos(q1)) + 2*l1*u2*cos(q1 -
    //   q2)*(m2 + m3))/2 + l1*u2*(m2 + m3)*(l1*u2 - 2*u0*cos(q2))/2 + m3*l2*u3*(2*l0*u1*cos(q1 - q3) -
    //   2*u0*cos(q3) + 2*l1*u2*cos(q2 - q3) + l2*u3)/2
    let energy = m2_plus_m3_l1_u2 * (-u0_minus_c1_l0_u1).mul_add(c2, s1_l0_u1 * s2)
        - u0 * m1_plus_m2_plus_m3 * c1_l0_u1
        + m3_l2_u3 * s1_l0_u1.mul_add(s3_2, -energy_of_u0_u1_u2)
        + S::ratio(1, 2) * energy_of_u0_u1_u2_u3;
    energy
}

/// Potential energy V, with the kinetic energy of what the momenta determine.
///
/// 13 operations, 3 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 4]) -> S {
    let Parameters { m1, m2, m3, l0, l1, l2, g, .. } = *p;
    let [q1, q2, q3, q0] = *q;
    // Sines and cosines.
    let (_, c1) = q1.sin_cos();
    let (_, c2) = q2.sin_cos();
    let (_, c3) = q3.sin_cos();
    // Shared terms.
    // m2 + m3
    let m2_plus_m3 = m2 + m3;
    // Values.
    // V = g*(l0*cos(q1)*(m1 + m2 + m3) + l1*cos(q2)*(m2 + m3) + m3*l2*cos(q3)) - 11*q0/4
    let energy = g * (m3 * l2 * c3 + l1 * m2_plus_m3 * c2 + l0 * c1 * (m1 + m2_plus_m3))
        - S::ratio(11, 4) * q0;
    energy
}

/// What the scene asks for, a time t after the start.
///
/// 0 operations.
#[must_use]
pub fn outputs<S: Scalar>(_p: &Parameters<S>, _t: S, q: &[S; 4], u: &[S; 4]) -> [S; 8] {
    let [q1, q2, q3, q0] = *q;
    let [u1, u2, u3, u0] = *u;
    // Values.
    // q0
    let q0_value = q0;
    // q1
    let q1_value = q1;
    // q2
    let q2_value = q2;
    // q3
    let q3_value = q3;
    // u0
    let u0_value = u0;
    // u1
    let u1_value = u1;
    // u2
    let u2_value = u2;
    // u3
    let u3_value = u3;
    [q0_value, q1_value, q2_value, q3_value, u0_value, u1_value, u2_value, u3_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 129 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    u: &[S; 4],
) -> ([S; 4], [S; 4]) {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, m3_l2 } = *p;
    let [q1, q2, q3, _] = *q;
    let [u1, u2, u3, u0] = *u;
    // Sines and cosines.
    let (s3_2, c3) = q3.sin_cos();
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let m3_l2_2 = m3 * l2;
    // d1 = m3*l2^2
    let d1 = l2 * m3_l2_2;
    let d1_inv = S::int(1) / d1;
    // l2_ = -m3_l2*cos(q3)/d1
    let l2_ = -m3_l2 * d1_inv * c3;
    // m2 + m3
    let m2_plus_m3 = m2 + m3;
    // m1 + m2_plus_m3
    let m1_plus_m2_plus_m3 = m1 + m2_plus_m3;
    let l2__m3_l2 = l2_ * m3_l2;
    // s3 = m0 + m1 + m2 + m3 + l2_*m3_l2*cos(q3)
    let s3 = l2__m3_l2.mul_add(c3, m0 + m1_plus_m2_plus_m3);
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let cos_q1_minus_q3 = c1.mul_add(c3, s1 * s3_2);
    let l0_cos_q1_minus_q3 = l0 * cos_q1_minus_q3;
    let l0_m1_plus_m2_plus_m3 = l0 * m1_plus_m2_plus_m3;
    // s4 = -l0*(cos(q1)*(m1 + m2 + m3) + l2_*m3_l2*cos(q1 - q3))
    let s4 = (-l0_m1_plus_m2_plus_m3).mul_add(c1, -l2__m3_l2 * l0_cos_q1_minus_q3);
    let l1_m2_plus_m3 = l1 * m2_plus_m3;
    // sin(q2)*sin(q3) + cos(q2)*cos(q3)
    let cos_q2_minus_q3 = c2.mul_add(c3, s2 * s3_2);
    let l1_cos_q2_minus_q3 = l1 * cos_q2_minus_q3;
    // s5 = -l1*(cos(q2)*(m2 + m3) + l2_*m3_l2*cos(q2 - q3))
    let s5 = (-l2__m3_l2).mul_add(l1_cos_q2_minus_q3, -l1_m2_plus_m3 * c2);
    let u1_sq = u1 * u1;
    // sin(q1)*cos(q3) - cos(q1)*sin(q3)
    let sin_q1_minus_q3 = (-c1).mul_add(s3_2, s1 * c3);
    let l0_sin_q1_minus_q3 = l0 * sin_q1_minus_q3;
    let u2_sq = u2 * u2;
    // sin(q2)*cos(q3) - cos(q2)*sin(q3)
    let sin_q2_minus_q3 = (-c2).mul_add(s3_2, s2 * c3);
    let l1_sin_q2_minus_q3 = l1 * sin_q2_minus_q3;
    // u1_sq*l0_sin_q1_minus_q3 + u2_sq*l1_sin_q2_minus_q3
    let r6_of_u1_u2 = u2_sq.mul_add(l1_sin_q2_minus_q3, u1_sq * l0_sin_q1_minus_q3);
    // g*sin(q3) + r6_of_u1_u2
    let g_s3_2_plus_r6_of_u1_u2 = g.mul_add(s3_2, r6_of_u1_u2);
    let u3_sq_m3_l2 = u3 * u3 * m3_l2;
    let s2_l1_m2_plus_m3 = l1_m2_plus_m3 * s2;
    let s1_l0_m1_plus_m2_plus_m3 = l0_m1_plus_m2_plus_m3 * s1;
    // r6 = 11/4 - l0*u1^2*sin(q1)*(m1 + m2 + m3) - l1*u2^2*sin(q2)*(m2 + m3) - m3_l2*(u3^2*sin(q3) +
    //   l2_*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r6 = (-l2__m3_l2).mul_add(g_s3_2_plus_r6_of_u1_u2, S::ratio(11, 4))
        - u3_sq_m3_l2 * s3_2 - u2_sq * s2_l1_m2_plus_m3 - u1_sq * s1_l0_m1_plus_m2_plus_m3;
    let m3_l2_2_d1_inv = m3_l2_2 * d1_inv;
    // l7 = m3*l0*l2*cos(q1 - q3)/d1
    let l7 = l0_cos_q1_minus_q3 * m3_l2_2_d1_inv;
    let l7_m3_l2 = l7 * m3_l2;
    // s8 = l0*(l0*(m1 + m2 + m3) - l7*m3_l2*cos(q1 - q3))
    let s8 = (-l0_cos_q1_minus_q3).mul_add(l7_m3_l2, l0 * l0_m1_plus_m2_plus_m3);
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let cos_q1_minus_q2 = c1.mul_add(c2, s1 * s2);
    let l0_l1_m2_plus_m3 = l0 * l1_m2_plus_m3;
    // s9 = l1*(l0*cos(q1 - q2)*(m2 + m3) - l7*m3_l2*cos(q2 - q3))
    let s9 = (-l1_cos_q2_minus_q3).mul_add(l7_m3_l2, cos_q1_minus_q2 * l0_l1_m2_plus_m3);
    // sin(q1)*cos(q2) - cos(q1)*sin(q2)
    let sin_q1_minus_q2 = (-c1).mul_add(s2, s1 * c2);
    let r10_of_place = sin_q1_minus_q2 * l0_l1_m2_plus_m3;
    // r10 = l0*(g*sin(q1)*(m1 + m2 + m3) - l1*u2^2*sin(q1 - q2)*(m2 + m3)) - m3_l2*(l0*u3^2*sin(q1 - q3) +
    //   l7*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r10 = (-l0_sin_q1_minus_q3).mul_add(u3_sq_m3_l2, g * s1_l0_m1_plus_m2_plus_m3)
        - g_s3_2_plus_r6_of_u1_u2 * l7_m3_l2 - u2_sq * r10_of_place;
    // l11 = m3*l1*l2*cos(q2 - q3)/d1
    let l11 = l1_cos_q2_minus_q3 * m3_l2_2_d1_inv;
    let l11_m3_l2 = l11 * m3_l2;
    // s12 = l1*(l1*(m2 + m3) - l11*m3_l2*cos(q2 - q3))
    let s12 = (-l1_cos_q2_minus_q3).mul_add(l11_m3_l2, l1 * l1_m2_plus_m3);
    // r13 = l1*(m2 + m3)*(g*sin(q2) + l0*u1^2*sin(q1 - q2)) - m3_l2*(l1*u3^2*sin(q2 - q3) + l11*(g*sin(q3)
    //   + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r13 = (-l1_sin_q2_minus_q3).mul_add(u3_sq_m3_l2, g * s2_l1_m2_plus_m3)
        + u1_sq * r10_of_place - g_s3_2_plus_r6_of_u1_u2 * l11_m3_l2;
    let s3_inv = S::int(1) / s3;
    // l14 = s4/s3
    let l14 = s4 * s3_inv;
    // s15 = s8 - s4*l14
    let s15 = (-s4).mul_add(l14, s8);
    // s16 = s9 - s5*l14
    let s16 = (-s5).mul_add(l14, s9);
    // r17 = r10 - r6*l14
    let r17 = (-r6).mul_add(l14, r10);
    // l18 = s5/s3
    let l18 = s5 * s3_inv;
    // s19 = s12 - s5*l18
    let s19 = (-s5).mul_add(l18, s12);
    // r20 = r13 - r6*l18
    let r20 = (-r6).mul_add(l18, r13);
    let s15_inv = S::int(1) / s15;
    // l21 = s16/s15
    let l21 = s16 * s15_inv;
    // s22 = s19 - s16*l21
    let s22 = (-s16).mul_add(l21, s19);
    // r23 = r20 - r17*l21
    let r23 = (-r17).mul_add(l21, r20);
    // u2' = r23/s22
    let u2_dot = r23 / s22;
    // s15_inv*(u2'*s16 - r17)
    let u0_dot_of_u2_dot = s15_inv * u2_dot.mul_add(s16, -r17);
    // s4*u0_dot_of_u2_dot - u2'*s5
    let u0_dot_of_u2_dot_2 = (-u2_dot).mul_add(s5, s4 * u0_dot_of_u2_dot);
    // u0' = (r6 - s5*r23/s22 + s4*(s16*r23/s22 - r17)/s15)/s3
    let u0_dot = s3_inv * (r6 + u0_dot_of_u2_dot_2);
    // u3' = m3*l2*(g*sin(q3) + cos(q3)*(r6 - s5*r23/s22 + s4*(s16*r23/s22 - r17)/s15)/s3 + l0*(u1^2*sin(q1
    //   - q3) + cos(q1 - q3)*(s16*r23/s22 - r17)/s15) + l1*(u2^2*sin(q2 - q3) - r23*cos(q2 - q3)/s22))/d1
    let u3_dot = m3_l2_2_d1_inv * u0_dot.mul_add(c3, g_s3_2_plus_r6_of_u1_u2)
        - u2_dot * l11 + l7 * u0_dot_of_u2_dot;
    // u1' = (r17 - s16*r23/s22)/s15
    let u1_dot = -u0_dot_of_u2_dot;
    // Values.
    // q1' = u1
    let q1_dot_value = u1;
    // q2' = u2
    let q2_dot_value = u2;
    // q3' = u3
    let q3_dot_value = u3;
    // q0' = u0
    let q0_dot_value = u0;
    (
        [q1_dot_value, q2_dot_value, q3_dot_value, q0_dot_value],
        [u1_dot, u2_dot, u3_dot, u0_dot],
    )
}

/// Jacobian of the derivative by the state; columns q1, q2, q3, q0, u1, u2, u3, u0.
///
/// 504 operations, 3 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [[S; 8]; 8] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, m3_l2 } = *p;
    let [q1, q2, q3, _] = *q;
    let [u1, u2, u3, _] = *u;
    // Sines and cosines.
    let (s3_2, c3) = q3.sin_cos();
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let m3_l2_2 = m3 * l2;
    // d1 = m3*l2^2
    let d1 = l2 * m3_l2_2;
    let d1_inv = S::int(1) / d1;
    let c3_m3_l2 = m3_l2 * c3;
    // l2_ = -m3_l2*cos(q3)/d1
    let l2_ = -d1_inv * c3_m3_l2;
    // m2 + m3
    let m2_plus_m3 = m2 + m3;
    // m1 + m2_plus_m3
    let m1_plus_m2_plus_m3 = m1 + m2_plus_m3;
    // s3 = m0 + m1 + m2 + m3 + l2_*m3_l2*cos(q3)
    let s3 = l2_.mul_add(c3_m3_l2, m0) + m1_plus_m2_plus_m3;
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let cos_q1_minus_q3 = c1.mul_add(c3, s1 * s3_2);
    let l0_m3_l2 = l0 * m3_l2;
    let cos_q1_minus_q3_l0_m3_l2 = cos_q1_minus_q3 * l0_m3_l2;
    let l0_m1_plus_m2_plus_m3 = l0 * m1_plus_m2_plus_m3;
    let c1_l0_m1_plus_m2_plus_m3 = l0_m1_plus_m2_plus_m3 * c1;
    // s4 = -l0*(cos(q1)*(m1 + m2 + m3) + l2_*m3_l2*cos(q1 - q3))
    let s4 = (-l2_).mul_add(cos_q1_minus_q3_l0_m3_l2, -c1_l0_m1_plus_m2_plus_m3);
    // sin(q2)*sin(q3) + cos(q2)*cos(q3)
    let cos_q2_minus_q3 = c2.mul_add(c3, s2 * s3_2);
    let l1_m3_l2 = l1 * m3_l2;
    let cos_q2_minus_q3_l1_m3_l2 = cos_q2_minus_q3 * l1_m3_l2;
    let l1_m2_plus_m3 = l1 * m2_plus_m3;
    let c2_l1_m2_plus_m3 = l1_m2_plus_m3 * c2;
    // l2_*cos_q2_minus_q3_l1_m3_l2 + c2_l1_m2_plus_m3
    let s5_of_place = l2_.mul_add(cos_q2_minus_q3_l1_m3_l2, c2_l1_m2_plus_m3);
    // s5 = -l1*(cos(q2)*(m2 + m3) + l2_*m3_l2*cos(q2 - q3))
    let s5 = -s5_of_place;
    // sin(q2)*cos(q3) - cos(q2)*sin(q3)
    let sin_q2_minus_q3 = (-c2).mul_add(s3_2, s2 * c3);
    let u2_sq = u2 * u2;
    // sin(q1)*cos(q3) - cos(q1)*sin(q3)
    let sin_q1_minus_q3 = (-c1).mul_add(s3_2, s1 * c3);
    let l0_u1 = l0 * u1;
    let u1_l0_u1 = u1 * l0_u1;
    // l1*sin(q2 - q3)*u2_sq + sin(q1 - q3)*u1_l0_u1
    let r6_of_u1_u2 = sin_q1_minus_q3.mul_add(u1_l0_u1, l1 * sin_q2_minus_q3 * u2_sq);
    // m3_l2*(g*sin(q3) + r6_of_u1_u2)
    let r6_of_u1_u2_2 = m3_l2 * g.mul_add(s3_2, r6_of_u1_u2);
    let u3_sq = u3 * u3;
    let s3_2_m3_l2 = m3_l2 * s3_2;
    let s2_l1_m2_plus_m3 = l1_m2_plus_m3 * s2;
    let s1_m1_plus_m2_plus_m3 = m1_plus_m2_plus_m3 * s1;
    // r6 = 11/4 - l0*u1^2*sin(q1)*(m1 + m2 + m3) - l1*u2^2*sin(q2)*(m2 + m3) - m3_l2*(u3^2*sin(q3) +
    //   l2_*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r6 = (-l2_).mul_add(r6_of_u1_u2_2, S::ratio(11, 4)) - u3_sq * s3_2_m3_l2
        - u2_sq * s2_l1_m2_plus_m3 - u1_l0_u1 * s1_m1_plus_m2_plus_m3;
    let m3_l2_2_d1_inv = m3_l2_2 * d1_inv;
    let l0_cos_q1_minus_q3 = l0 * cos_q1_minus_q3;
    // l7 = m3*l0*l2*cos(q1 - q3)/d1
    let l7 = m3_l2_2_d1_inv * l0_cos_q1_minus_q3;
    // s8 = l0*(l0*(m1 + m2 + m3) - l7*m3_l2*cos(q1 - q3))
    let s8 = (-l7).mul_add(cos_q1_minus_q3_l0_m3_l2, l0 * l0_m1_plus_m2_plus_m3);
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let cos_q1_minus_q2 = c1.mul_add(c2, s1 * s2);
    let l0_l1_m2_plus_m3 = l0 * l1_m2_plus_m3;
    let s9_of_place = cos_q1_minus_q2 * l0_l1_m2_plus_m3;
    // s9 = l1*(l0*cos(q1 - q2)*(m2 + m3) - l7*m3_l2*cos(q2 - q3))
    let s9 = (-l7).mul_add(cos_q2_minus_q3_l1_m3_l2, s9_of_place);
    let sin_q1_minus_q3_l0_m3_l2 = sin_q1_minus_q3 * l0_m3_l2;
    // sin(q1)*cos(q2) - cos(q1)*sin(q2)
    let sin_q1_minus_q2 = (-c1).mul_add(s2, s1 * c2);
    let r10_of_place = sin_q1_minus_q2 * l0_l1_m2_plus_m3;
    let s1_l0_m1_plus_m2_plus_m3 = l0_m1_plus_m2_plus_m3 * s1;
    // r10 = l0*(g*sin(q1)*(m1 + m2 + m3) - l1*u2^2*sin(q1 - q2)*(m2 + m3)) - m3_l2*(l0*u3^2*sin(q1 - q3) +
    //   l7*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r10 = (-l7).mul_add(r6_of_u1_u2_2, g * s1_l0_m1_plus_m2_plus_m3)
        - u3_sq * sin_q1_minus_q3_l0_m3_l2 - u2_sq * r10_of_place;
    let l1_m3_l2_2_d1_inv = l1 * m3_l2_2_d1_inv;
    // l11 = m3*l1*l2*cos(q2 - q3)/d1
    let l11 = cos_q2_minus_q3 * l1_m3_l2_2_d1_inv;
    let s12_of_place = l11 * cos_q2_minus_q3_l1_m3_l2;
    // s12 = l1*(l1*(m2 + m3) - l11*m3_l2*cos(q2 - q3))
    let s12 = l1.mul_add(l1_m2_plus_m3, -s12_of_place);
    let sin_q2_minus_q3_l1_m3_l2 = sin_q2_minus_q3 * l1_m3_l2;
    let l1_m2_plus_m3_u1_l0_u1 = l1_m2_plus_m3 * u1_l0_u1;
    // r13 = l1*(m2 + m3)*(g*sin(q2) + l0*u1^2*sin(q1 - q2)) - m3_l2*(l1*u3^2*sin(q2 - q3) + l11*(g*sin(q3)
    //   + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r13 = (-l11).mul_add(r6_of_u1_u2_2, g * s2_l1_m2_plus_m3)
        - u3_sq * sin_q2_minus_q3_l1_m3_l2 + sin_q1_minus_q2 * l1_m2_plus_m3_u1_l0_u1;
    let s3_inv = S::int(1) / s3;
    // l14 = s4/s3
    let l14 = s4 * s3_inv;
    // s15 = s8 - s4*l14
    let s15 = (-s4).mul_add(l14, s8);
    // s16 = s9 - s5*l14
    let s16 = (-s5).mul_add(l14, s9);
    // r17 = r10 - r6*l14
    let r17 = (-r6).mul_add(l14, r10);
    // l18 = s5/s3
    let l18 = s5 * s3_inv;
    // s19 = s12 - s5*l18
    let s19 = (-s5).mul_add(l18, s12);
    // r20 = r13 - r6*l18
    let r20 = (-r6).mul_add(l18, r13);
    let s15_inv = S::int(1) / s15;
    // l21 = s16/s15
    let l21 = s16 * s15_inv;
    // s22 = s19 - s16*l21
    let s22 = (-s16).mul_add(l21, s19);
    // r23 = r20 - r17*l21
    let r23 = (-r17).mul_add(l21, r20);
    let s4_by_q1_of_place = l2_ * sin_q1_minus_q3_l0_m3_l2;
    // s4_by_q1 = l0*(sin(q1)*(m1 + m2 + m3) + l2_*m3_l2*sin(q1 - q3))
    let s4_by_q1 = s1_l0_m1_plus_m2_plus_m3 + s4_by_q1_of_place;
    let r6_by_q1_of_u1 = u1 * u1 * cos_q1_minus_q3_l0_m3_l2;
    // r6_by_q1 = -l0*u1^2*(cos(q1)*(m1 + m2 + m3) + l2_*m3_l2*cos(q1 - q3))
    let r6_by_q1 = (-l2_).mul_add(r6_by_q1_of_u1, -m1_plus_m2_plus_m3 * u1_l0_u1 * c1);
    let l0_sin_q1_minus_q3 = l0 * sin_q1_minus_q3;
    // l7_by_q3 = m3*l0*l2*sin(q1 - q3)/d1
    let l7_by_q3 = m3_l2_2_d1_inv * l0_sin_q1_minus_q3;
    // l7_by_q1 = -m3*l0*l2*sin(q1 - q3)/d1
    let l7_by_q1 = -l7_by_q3;
    let s8_by_q1_of_place = l7 * sin_q1_minus_q3_l0_m3_l2;
    // s8_by_q1 = l0*m3_l2*(l7*sin(q1 - q3) - l7_by_q1*cos(q1 - q3))
    let s8_by_q1 = (-l7_by_q1).mul_add(cos_q1_minus_q3_l0_m3_l2, s8_by_q1_of_place);
    // s9_by_q1 = -l1*(l0*sin(q1 - q2)*(m2 + m3) + m3_l2*l7_by_q1*cos(q2 - q3))
    let s9_by_q1 = (-l7_by_q1).mul_add(cos_q2_minus_q3_l1_m3_l2, -r10_of_place);
    let r10_by_q1_of_u3 = cos_q1_minus_q3_l0_m3_l2 * u3_sq;
    // r10_by_q1 = l0*(g*cos(q1)*(m1 + m2 + m3) - l1*u2^2*cos(q1 - q2)*(m2 + m3) - m3_l2*(u3^2*cos(q1 - q3)
    //   + u1^2*(l7*cos(q1 - q3) + l7_by_q1*sin(q1 - q3)))) - m3_l2*l7_by_q1*(g*sin(q3) + l1*u2^2*sin(q2 -
    //   q3))
    let r10_by_q1 = (-l7_by_q1).mul_add(r6_of_u1_u2_2, g * c1_l0_m1_plus_m2_plus_m3)
        - u2_sq * s9_of_place - l7 * r6_by_q1_of_u1 - r10_by_q1_of_u3;
    let r13_by_q1_of_u1 = cos_q1_minus_q2 * l1_m2_plus_m3_u1_l0_u1;
    // r13_by_q1 = l0*u1^2*(l1*cos(q1 - q2)*(m2 + m3) - l11*m3_l2*cos(q1 - q3))
    let r13_by_q1 = (-l11).mul_add(r6_by_q1_of_u1, r13_by_q1_of_u1);
    let l14_s15_inv = l14 * s15_inv;
    let l21_s4_by_q1 = l21 * s4_by_q1;
    // s4*l21 - s5
    let minus_s5_plus_s4_l21 = s4.mul_add(l21, -s5);
    let l21_by_q1_of_s3_s4_s5_l21 = s3_inv * minus_s5_plus_s4_l21;
    // l21*s8_by_q1 - s9_by_q1
    let l21_by_q1_of_place = l21.mul_add(s8_by_q1, -s9_by_q1);
    // l21_by_q1 = (s16*(s4_by_q1*(s4/s3 + l14) - s8_by_q1)/s15 - s5*s4_by_q1/s3 + s9_by_q1)/s15
    let l21_by_q1 = s15_inv * s4_by_q1.mul_add(l21_by_q1_of_s3_s4_s5_l21, -l21_by_q1_of_place)
        + l14_s15_inv * l21_s4_by_q1;
    // s22_by_q1 = l21*(s5*s4_by_q1/s3 - s9_by_q1) - s16*l21_by_q1
    let s22_by_q1 = (-l21).mul_add(s9_by_q1, l18 * l21_s4_by_q1) - s16 * l21_by_q1;
    // l14*l21 - l18
    let minus_l18_plus_l14_l21 = l14.mul_add(l21, -l18);
    let r6_s3_inv = r6 * s3_inv;
    // r23_by_q1 = l21*(r6*s4_by_q1/s3 - r10_by_q1 + l14*r6_by_q1) - l18*r6_by_q1 + r13_by_q1 -
    //   r17*l21_by_q1
    let r23_by_q1 = (-l21).mul_add(r10_by_q1, r13_by_q1) - r17 * l21_by_q1
        + r6_by_q1 * minus_l18_plus_l14_l21 + l21_s4_by_q1 * r6_s3_inv;
    let s22_inv = S::int(1) / s22;
    let r23_s22_inv = r23 * s22_inv;
    // s16*r23_s22_inv - r17
    let u0_dot_by_q1_of_place = s16.mul_add(r23_s22_inv, -r17);
    let u0_dot_by_q1_of_place_2 = s15_inv * u0_dot_by_q1_of_place;
    let r17_s15_inv = r17 * s15_inv;
    // s4*r17_s15_inv - minus_s5_plus_s4_l21*r23_s22_inv
    let u0_dot_by_q1_of_place_3 = (-minus_s5_plus_s4_l21)
        .mul_add(r23_s22_inv, s4 * r17_s15_inv);
    // s3_inv*(r6 - u0_dot_by_q1_of_place_3)
    let u0_dot_by_q1_of_place_4 = s3_inv * (r6 - u0_dot_by_q1_of_place_3);
    // s4_by_q1*u0_dot_by_q1_of_place_4 - s8_by_q1*u0_dot_by_q1_of_place_2
    let u0_dot_by_q1_of_place_5 = (-s8_by_q1)
        .mul_add(u0_dot_by_q1_of_place_2, s4_by_q1 * u0_dot_by_q1_of_place_4);
    // s9_by_q1*r23_s22_inv - r10_by_q1
    let u0_dot_by_q1_of_place_6 = s9_by_q1.mul_add(r23_s22_inv, -r10_by_q1);
    // u0_dot_by_q1_of_place_5 + u0_dot_by_q1_of_place_6
    let u0_dot_by_q1_of_place_7 = u0_dot_by_q1_of_place_5 + u0_dot_by_q1_of_place_6;
    // r6_by_q1 + s4_by_q1*u0_dot_by_q1_of_place_2
    let u0_dot_by_q1_of_place_8 = s4_by_q1.mul_add(u0_dot_by_q1_of_place_2, r6_by_q1);
    // s3_inv*(1 + s4*l14_s15_inv)
    let u0_dot_by_q1_of_place_9 = s3_inv * s4.mul_add(l14_s15_inv, S::int(1));
    // s22_by_q1*r23_s22_inv - r23_by_q1
    let u0_dot_by_q1_of_place_10 = s22_by_q1.mul_add(r23_s22_inv, -r23_by_q1);
    let u0_dot_by_q1_of_place_11 = l21_by_q1_of_s3_s4_s5_l21 * s22_inv;
    // u0_dot_by_q1 = (r6_by_q1 - (s4_by_q1*(r17 - s16*r23/s22) + s4*(r17*(s4_by_q1*(s4/s3 + l14) -
    //   s8_by_q1)/s15 - r6*s4_by_q1/s3 - l14*r6_by_q1 + r10_by_q1 - (r23*(s9_by_q1 - s5*s4_by_q1/s3 -
    //   s16*((s8_by_q1 - s4_by_q1*(s4/s3 + l14))/s15 + s22_by_q1/s22)) + s16*r23_by_q1)/s22))/s15 +
    //   s5*(r23*s22_by_q1/s22 - r23_by_q1)/s22)/s3
    let u0_dot_by_q1 = u0_dot_by_q1_of_place_8
        .mul_add(u0_dot_by_q1_of_place_9, l14_s15_inv * u0_dot_by_q1_of_place_7)
        - u0_dot_by_q1_of_place_10 * u0_dot_by_q1_of_place_11;
    // l14*cos(q3) + l0_cos_q1_minus_q3
    let u3_dot_by_q1_of_l0_q1_q3_l14 = l14.mul_add(c3, l0_cos_q1_minus_q3);
    let m3_l2_2_d1_inv_s15_inv = m3_l2_2_d1_inv * s15_inv;
    let u3_dot_by_q1_of_place = u3_dot_by_q1_of_l0_q1_q3_l14 * m3_l2_2_d1_inv_s15_inv;
    let c3_s3_inv = s3_inv * c3;
    // l14_s15_inv*u3_dot_by_q1_of_l0_q1_q3_l14 + c3_s3_inv
    let u3_dot_by_q1_of_place_2 = l14_s15_inv
        .mul_add(u3_dot_by_q1_of_l0_q1_q3_l14, c3_s3_inv);
    let u3_dot_by_q1_of_place_3 = m3_l2_2_d1_inv * u3_dot_by_q1_of_place_2;
    let l1_cos_q2_minus_q3 = l1 * cos_q2_minus_q3;
    // l18*cos(q3) - l21*u3_dot_by_q1_of_l0_q1_q3_l14
    let u3_dot_by_q1_of_place_4 = (-l21).mul_add(u3_dot_by_q1_of_l0_q1_q3_l14, l18 * c3);
    // m3_l2_2_d1_inv*(l1_cos_q2_minus_q3 + u3_dot_by_q1_of_place_4)
    let u3_dot_by_q1_of_place_5 = m3_l2_2_d1_inv * (l1_cos_q2_minus_q3 + u3_dot_by_q1_of_place_4);
    let u3_dot_by_q1_of_place_6 = s22_inv * u3_dot_by_q1_of_place_5;
    let cos_q1_minus_q3_u1_l0_u1 = cos_q1_minus_q3 * u1_l0_u1;
    let u3_dot_by_q1_of_place_7 = u0_dot_by_q1_of_place * m3_l2_2_d1_inv_s15_inv;
    // u3_dot_by_q1 = m3*l2*(cos(q3)*(s4_by_q1*(s16*r23/s22 - r17)/s15 + r6_by_q1 + s4*(r17 -
    //   s16*r23/s22)*(s8_by_q1 - s4_by_q1*(s4/s3 + l14))/s15^2 + s5*r23*s22_by_q1/s22^2 - s5*r23_by_q1/s22 +
    //   s4*(r6*s4_by_q1/s3 - r23*(s5*s4_by_q1/s3 - s9_by_q1)/s22 + l14*r6_by_q1 - r10_by_q1 -
    //   s16*r23*s22_by_q1/s22^2 + s16*r23_by_q1/s22)/s15)/s3 + l0*(u1^2*cos(q1 - q3) + sin(q1 - q3)*(r17 -
    //   s16*r23/s22)/s15 + cos(q1 - q3)*(r17 - s16*r23/s22)*(s8_by_q1 - s4_by_q1*(s4/s3 + l14))/s15^2 +
    //   cos(q1 - q3)*(r6*s4_by_q1/s3 - r23*(s5*s4_by_q1/s3 - s9_by_q1)/s22 + l14*r6_by_q1 - r10_by_q1 -
    //   s16*r23*s22_by_q1/s22^2 + s16*r23_by_q1/s22)/s15) + l1*(r23*s22_by_q1*cos(q2 - q3)/s22^2 -
    //   r23_by_q1*cos(q2 - q3)/s22))/d1
    let u3_dot_by_q1 = u0_dot_by_q1_of_place_7 * u3_dot_by_q1_of_place
        + r6_by_q1 * u3_dot_by_q1_of_place_3 + u0_dot_by_q1_of_place_10 * u3_dot_by_q1_of_place_6
        + m3_l2_2_d1_inv * cos_q1_minus_q3_u1_l0_u1
        + u3_dot_by_q1_of_place_7 * s4_by_q1.mul_add(u3_dot_by_q1_of_place_2, -l0_sin_q1_minus_q3);
    let l21_s22_inv = l21 * s22_inv;
    // u1_dot_by_q1 = (r17*(s4_by_q1*(s4/s3 + l14) - s8_by_q1)/s15 - r6*s4_by_q1/s3 - l14*r6_by_q1 +
    //   r10_by_q1 - (r23*(s9_by_q1 - s5*s4_by_q1/s3 - s16*((s8_by_q1 - s4_by_q1*(s4/s3 + l14))/s15 +
    //   s22_by_q1/s22)) + s16*r23_by_q1)/s22)/s15
    let u1_dot_by_q1 = (-s15_inv)
        .mul_add(u0_dot_by_q1_of_place_7, u0_dot_by_q1_of_place_10 * l21_s22_inv)
        - l14_s15_inv * u0_dot_by_q1_of_place_8;
    let s5_by_q2_of_place = l2_ * sin_q2_minus_q3_l1_m3_l2;
    // s5_by_q2 = l1*(sin(q2)*(m2 + m3) + l2_*m3_l2*sin(q2 - q3))
    let s5_by_q2 = s2_l1_m2_plus_m3 + s5_by_q2_of_place;
    // r6_by_q2 = -l1*u2^2*(cos(q2)*(m2 + m3) + l2_*m3_l2*cos(q2 - q3))
    let r6_by_q2 = -s5_of_place * u2_sq;
    let s9_by_q2_of_place = l7 * sin_q2_minus_q3_l1_m3_l2;
    // s9_by_q2 = l1*(l0*sin(q1 - q2)*(m2 + m3) + l7*m3_l2*sin(q2 - q3))
    let s9_by_q2 = r10_of_place + s9_by_q2_of_place;
    // r10_by_q2 = l1*u2^2*(l0*cos(q1 - q2)*(m2 + m3) - l7*m3_l2*cos(q2 - q3))
    let r10_by_q2 = s9 * u2_sq;
    // l11_by_q3 = m3*l1*l2*sin(q2 - q3)/d1
    let l11_by_q3 = sin_q2_minus_q3 * l1_m3_l2_2_d1_inv;
    // l11_by_q2 = -m3*l1*l2*sin(q2 - q3)/d1
    let l11_by_q2 = -l11_by_q3;
    let s12_by_q2_of_place = l11 * sin_q2_minus_q3_l1_m3_l2;
    // s12_by_q2 = l1*m3_l2*(l11*sin(q2 - q3) - l11_by_q2*cos(q2 - q3))
    let s12_by_q2 = (-l11_by_q2).mul_add(cos_q2_minus_q3_l1_m3_l2, s12_by_q2_of_place);
    let r13_by_q2_of_u3 = cos_q2_minus_q3_l1_m3_l2 * u3_sq;
    // r13_by_q2 = -m3_l2*l11_by_q2*(g*sin(q3) + l0*u1^2*sin(q1 - q3)) - l1*((m2 + m3)*(l0*u1^2*cos(q1 -
    //   q2) - g*cos(q2)) + m3_l2*(u3^2*cos(q2 - q3) + u2^2*(l11*cos(q2 - q3) + l11_by_q2*sin(q2 - q3))))
    let r13_by_q2 = (-l11_by_q2).mul_add(r6_of_u1_u2_2, g * c2_l1_m2_plus_m3)
        - u2_sq * s12_of_place - r13_by_q1_of_u1 - r13_by_q2_of_u3;
    // l21*s9_by_q2 - s5_by_q2*minus_l18_plus_l14_l21
    let s22_by_q2_of_place = (-s5_by_q2).mul_add(minus_l18_plus_l14_l21, l21 * s9_by_q2);
    // s22_by_q2 = s5_by_q2*(l14*(s16/s15 + l21) - s5/s3 - l18) - s9_by_q2*(s16/s15 + l21) + s12_by_q2
    let s22_by_q2 = (-s22_by_q2_of_place).mul_add(S::int(2), s12_by_q2);
    // r23_by_q2 = r17*(l14*s5_by_q2 - s9_by_q2)/s15 - r6*s5_by_q2/s3 - l18*r6_by_q2 + l21*(l14*r6_by_q2 -
    //   r10_by_q2) + r13_by_q2
    let r23_by_q2 = r13_by_q2 - l21 * r10_by_q2 + r6_by_q2 * minus_l18_plus_l14_l21
        + s5_by_q2 * r17.mul_add(l14_s15_inv, -r6_s3_inv) - s9_by_q2 * r17_s15_inv;
    // s9_by_q2*r23_s22_inv - r10_by_q2
    let u0_dot_by_q2_of_place = s9_by_q2.mul_add(r23_s22_inv, -r10_by_q2);
    // s5_by_q2*r23_s22_inv - r6_by_q2
    let u0_dot_by_q2_of_place_2 = s5_by_q2.mul_add(r23_s22_inv, -r6_by_q2);
    // s22_by_q2*r23_s22_inv - r23_by_q2
    let u0_dot_by_q2_of_place_3 = s22_by_q2.mul_add(r23_s22_inv, -r23_by_q2);
    // u0_dot_by_q2 = (r6_by_q2 + s4*(l14*r6_by_q2 - r10_by_q2)/s15 - (r23*(s5_by_q2 - s5*s22_by_q2/s22 +
    //   s4*(l14*s5_by_q2 - s9_by_q2 + s16*s22_by_q2/s22)/s15) + r23_by_q2*(s5 - s4*s16/s15))/s22)/s3
    let u0_dot_by_q2 = (-u0_dot_by_q1_of_place_9)
        .mul_add(u0_dot_by_q2_of_place_2, l14_s15_inv * u0_dot_by_q2_of_place)
        - u0_dot_by_q1_of_place_11 * u0_dot_by_q2_of_place_3;
    let l11_by_q3_r23_s22_inv = l11_by_q3 * r23_s22_inv;
    // u3_dot_by_q2 = -m3*l2*(l0*cos(q1 - q3)*(r23*(l14*s5_by_q2 - s9_by_q2)/s22 - l14*r6_by_q2 + r10_by_q2
    //   + s16*r23*s22_by_q2/s22^2 - s16*r23_by_q2/s22)/s15 + cos(q3)*(r23*s5_by_q2/s22 - r6_by_q2 -
    //   s5*r23*s22_by_q2/s22^2 + s5*r23_by_q2/s22 - s4*(l14*r6_by_q2 - r23*(l14*s5_by_q2 - s9_by_q2)/s22 -
    //   r10_by_q2 - s16*r23*s22_by_q2/s22^2 + s16*r23_by_q2/s22)/s15)/s3 + l1*(r23_by_q2*cos(q2 - q3)/s22 -
    //   u2^2*cos(q2 - q3) - r23*sin(q2 - q3)/s22 - r23*s22_by_q2*cos(q2 - q3)/s22^2))/d1
    let u3_dot_by_q2 = u3_dot_by_q1_of_place.mul_add(u0_dot_by_q2_of_place, l11 * u2_sq)
        - u3_dot_by_q1_of_place_3 * u0_dot_by_q2_of_place_2
        + u3_dot_by_q1_of_place_6 * u0_dot_by_q2_of_place_3 + l11_by_q3_r23_s22_inv;
    // u1_dot_by_q2 = (r10_by_q2 - l14*r6_by_q2 - (r23*(s9_by_q2 - l14*s5_by_q2 - s16*s22_by_q2/s22) +
    //   s16*r23_by_q2)/s22)/s15
    let u1_dot_by_q2 = (-s15_inv)
        .mul_add(u0_dot_by_q2_of_place, l14_s15_inv * u0_dot_by_q2_of_place_2)
        + l21_s22_inv * u0_dot_by_q2_of_place_3;
    // l2__by_q3 = m3_l2*sin(q3)/d1
    let l2__by_q3 = d1_inv * s3_2_m3_l2;
    // s3_by_q3 = m3_l2*(l2__by_q3*cos(q3) - l2_*sin(q3))
    let s3_by_q3 = (-l2_).mul_add(s3_2_m3_l2, l2__by_q3 * c3_m3_l2);
    // s4_by_q3 = -l0*m3_l2*(l2_*sin(q1 - q3) + l2__by_q3*cos(q1 - q3))
    let s4_by_q3 = (-l2__by_q3).mul_add(cos_q1_minus_q3_l0_m3_l2, -s4_by_q1_of_place);
    // s5_by_q3 = -l1*m3_l2*(l2_*sin(q2 - q3) + l2__by_q3*cos(q2 - q3))
    let s5_by_q3 = (-l2__by_q3).mul_add(cos_q2_minus_q3_l1_m3_l2, -s5_by_q2_of_place);
    // u2_sq*l1_cos_q2_minus_q3 + cos_q1_minus_q3_u1_l0_u1
    let r6_by_q3_of_u1_u2 = u2_sq.mul_add(l1_cos_q2_minus_q3, cos_q1_minus_q3_u1_l0_u1);
    // g*cos(q3) - r6_by_q3_of_u1_u2
    let r6_by_q3_of_u1_u2_2 = g.mul_add(c3, -r6_by_q3_of_u1_u2);
    let r6_by_q3_of_u1_u2_3 = m3_l2 * r6_by_q3_of_u1_u2_2;
    // r6_by_q3 = -m3_l2*(u3^2*cos(q3) + l2_*(g*cos(q3) - l0*u1^2*cos(q1 - q3) - l1*u2^2*cos(q2 - q3)) +
    //   l2__by_q3*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3)))
    let r6_by_q3 = (-c3_m3_l2).mul_add(u3_sq, -l2__by_q3 * r6_of_u1_u2_2)
        - l2_ * r6_by_q3_of_u1_u2_3;
    // s8_by_q3 = -l0*m3_l2*(l7*sin(q1 - q3) + l7_by_q3*cos(q1 - q3))
    let s8_by_q3 = (-l7_by_q3).mul_add(cos_q1_minus_q3_l0_m3_l2, -s8_by_q1_of_place);
    // s9_by_q3 = -l1*m3_l2*(l7*sin(q2 - q3) + l7_by_q3*cos(q2 - q3))
    let s9_by_q3 = (-l7_by_q3).mul_add(cos_q2_minus_q3_l1_m3_l2, -s9_by_q2_of_place);
    // r10_by_q3 = m3_l2*(l0*(u3^2*cos(q1 - q3) + u1^2*(l7*cos(q1 - q3) - l7_by_q3*sin(q1 - q3))) +
    //   l1*u2^2*(l7*cos(q2 - q3) - l7_by_q3*sin(q2 - q3)) - g*(l7*cos(q3) + l7_by_q3*sin(q3)))
    let r10_by_q3 = (-l7_by_q3).mul_add(r6_of_u1_u2_2, r10_by_q1_of_u3) - l7 * r6_by_q3_of_u1_u2_3;
    // s12_by_q3 = -l1*m3_l2*(l11*sin(q2 - q3) + l11_by_q3*cos(q2 - q3))
    let s12_by_q3 = (-l11_by_q3).mul_add(cos_q2_minus_q3_l1_m3_l2, -s12_by_q2_of_place);
    // r13_by_q3 = m3_l2*(l1*(u3^2*cos(q2 - q3) + u2^2*(l11*cos(q2 - q3) - l11_by_q3*sin(q2 - q3))) +
    //   l0*u1^2*(l11*cos(q1 - q3) - l11_by_q3*sin(q1 - q3)) - g*(l11*cos(q3) + l11_by_q3*sin(q3)))
    let r13_by_q3 = (-l11_by_q3).mul_add(r6_of_u1_u2_2, r13_by_q2_of_u3)
        - l11 * r6_by_q3_of_u1_u2_3;
    // l14*s3_by_q3 - s4_by_q3
    let s15_by_q3_of_place = l14.mul_add(s3_by_q3, -s4_by_q3);
    // s15_by_q3 = s4*(s4*s3_by_q3/s3 - s4_by_q3)/s3 - l14*s4_by_q3 + s8_by_q3
    let s15_by_q3 = s8_by_q3 + l14 * (s15_by_q3_of_place - s4_by_q3);
    // l18*s3_by_q3 - s5_by_q3
    let s16_by_q3_of_place = l18.mul_add(s3_by_q3, -s5_by_q3);
    // s16_by_q3 = s5*(s4*s3_by_q3/s3 - s4_by_q3)/s3 - l14*s5_by_q3 + s9_by_q3
    let s16_by_q3 = (-l18).mul_add(s4_by_q3, s9_by_q3) + l14 * s16_by_q3_of_place;
    // r17_by_q3 = r6*(s4*s3_by_q3/s3 - s4_by_q3)/s3 - l14*r6_by_q3 + r10_by_q3
    let r17_by_q3 = (-l14).mul_add(r6_by_q3, r10_by_q3) + r6_s3_inv * s15_by_q3_of_place;
    // s19_by_q3 = s5*(s5*s3_by_q3/s3 - s5_by_q3)/s3 - l18*s5_by_q3 + s12_by_q3
    let s19_by_q3 = s12_by_q3 + l18 * (s16_by_q3_of_place - s5_by_q3);
    // r20_by_q3 = r6*(s5*s3_by_q3/s3 - s5_by_q3)/s3 - l18*r6_by_q3 + r13_by_q3
    let r20_by_q3 = (-l18).mul_add(r6_by_q3, r13_by_q3) + r6_s3_inv * s16_by_q3_of_place;
    // l21*s15_by_q3 - s16_by_q3
    let s22_by_q3_of_place = l21.mul_add(s15_by_q3, -s16_by_q3);
    // s22_by_q3 = s16*(s16*s15_by_q3/s15 - s16_by_q3)/s15 - l21*s16_by_q3 + s19_by_q3
    let s22_by_q3 = s19_by_q3 + l21 * (s22_by_q3_of_place - s16_by_q3);
    // r23_by_q3 = r17*(s16*s15_by_q3/s15 - s16_by_q3)/s15 - l21*r17_by_q3 + r20_by_q3
    let r23_by_q3 = (-l21).mul_add(r17_by_q3, r20_by_q3) + r17_s15_inv * s22_by_q3_of_place;
    // s15_by_q3*u0_dot_by_q1_of_place_2 - s16_by_q3*r23_s22_inv
    let u0_dot_by_q3_of_place = (-s16_by_q3)
        .mul_add(r23_s22_inv, s15_by_q3 * u0_dot_by_q1_of_place_2);
    // r17_by_q3 + u0_dot_by_q3_of_place
    let u0_dot_by_q3_of_place_2 = r17_by_q3 + u0_dot_by_q3_of_place;
    // s22_by_q3*r23_s22_inv - r23_by_q3
    let u0_dot_by_q3_of_place_3 = s22_by_q3.mul_add(r23_s22_inv, -r23_by_q3);
    // s5_by_q3*r23_s22_inv + s3_by_q3*u0_dot_by_q1_of_place_4
    let u0_dot_by_q3_of_place_4 = s3_by_q3
        .mul_add(u0_dot_by_q1_of_place_4, s5_by_q3 * r23_s22_inv);
    // r6_by_q3 - u0_dot_by_q3_of_place_4
    let u0_dot_by_q3_of_place_5 = r6_by_q3 - u0_dot_by_q3_of_place_4;
    // u0_dot_by_q3 = (r6_by_q3 - r6*s3_by_q3/s3 - (s4_by_q3*(r17 - s16*r23/s22) + s4*(r17_by_q3 -
    //   r17*(s3_by_q3/s3 + s15_by_q3/s15) - (r23*s16_by_q3 + s16*(r23_by_q3 - r23*(s3_by_q3/s3 +
    //   s15_by_q3/s15 + s22_by_q3/s22)))/s22))/s15 - (r23*s5_by_q3 + s5*(r23_by_q3 - r23*(s3_by_q3/s3 +
    //   s22_by_q3/s22)))/s22)/s3
    let u0_dot_by_q3 = s3_inv * s4_by_q3.mul_add(u0_dot_by_q1_of_place_2, u0_dot_by_q3_of_place_5)
        - l14_s15_inv * u0_dot_by_q3_of_place_2
        - u0_dot_by_q1_of_place_11 * u0_dot_by_q3_of_place_3;
    // u3_dot_by_q3 = m3*l2*(g*cos(q3) + (sin(q3)*(s5*r23/s22 - r6 - s4*(s16*r23/s22 - r17)/s15) +
    //   cos(q3)*(r6_by_q3 - r6*s3_by_q3/s3 - (s4_by_q3*(r17 - s16*r23/s22) + s4*(r17_by_q3 -
    //   r17*(s3_by_q3/s3 + s15_by_q3/s15) - (r23*s16_by_q3 + s16*(r23_by_q3 - r23*(s3_by_q3/s3 +
    //   s15_by_q3/s15 + s22_by_q3/s22)))/s22))/s15 - (r23*s5_by_q3 + s5*(r23_by_q3 - r23*(s3_by_q3/s3 +
    //   s22_by_q3/s22)))/s22))/s3 - l0*(u1^2*cos(q1 - q3) + (sin(q1 - q3)*(r17 - s16*r23/s22) + cos(q1 -
    //   q3)*(r17_by_q3 - r17*s15_by_q3/s15 - (r23*s16_by_q3 + s16*(r23_by_q3 - r23*(s15_by_q3/s15 +
    //   s22_by_q3/s22)))/s22))/s15) - l1*(r23*sin(q2 - q3)/s22 + cos(q2 - q3)*(u2^2 + (r23_by_q3 -
    //   r23*s22_by_q3/s22)/s22)))/d1
    let u3_dot_by_q3 = -l11_by_q3_r23_s22_inv + l0_sin_q1_minus_q3 * u3_dot_by_q1_of_place_7
        + m3_l2_2_d1_inv * (-u0_dot_by_q1_of_place_4).mul_add(s3_2, r6_by_q3_of_u1_u2_2)
        - u3_dot_by_q1_of_place * u0_dot_by_q3_of_place_2
        + u3_dot_by_q1_of_place_6 * u0_dot_by_q3_of_place_3
        + c3_s3_inv
            * m3_l2_2_d1_inv
                .mul_add(u0_dot_by_q3_of_place_5, s4_by_q3 * u3_dot_by_q1_of_place_7);
    // u1_dot_by_q3 = (r17_by_q3 - r17*s15_by_q3/s15 - (r23*s16_by_q3 + s16*(r23_by_q3 - r23*(s15_by_q3/s15
    //   + s22_by_q3/s22)))/s22)/s15
    let u1_dot_by_q3 = l21_s22_inv
        .mul_add(u0_dot_by_q3_of_place_3, s15_inv * u0_dot_by_q3_of_place_2);
    let r6_by_u1_of_place = S::int(2) * sin_q1_minus_q3_l0_m3_l2;
    let u1_r6_by_u1_of_place = u1 * r6_by_u1_of_place;
    let l0_u1_doubled = S::int(2) * l0_u1;
    // r6_by_u1 = -2*l0*u1*(sin(q1)*(m1 + m2 + m3) + l2_*m3_l2*sin(q1 - q3))
    let r6_by_u1 = (-s1_m1_plus_m2_plus_m3)
        .mul_add(l0_u1_doubled, -l2_ * u1_r6_by_u1_of_place);
    // r10_by_u1 = -2*l0*u1*l7*m3_l2*sin(q1 - q3)
    let r10_by_u1 = -l7 * u1_r6_by_u1_of_place;
    // r13_by_u1 = 2*l0*u1*(l1*sin(q1 - q2)*(m2 + m3) - l11*m3_l2*sin(q1 - q3))
    let r13_by_u1 = (-l11)
        .mul_add(u1_r6_by_u1_of_place, sin_q1_minus_q2 * l1_m2_plus_m3 * l0_u1_doubled);
    // r13_by_u1 + r6_by_u1*minus_l18_plus_l14_l21
    let u2_dot_by_u1_of_place = r6_by_u1.mul_add(minus_l18_plus_l14_l21, r13_by_u1);
    // u2_dot_by_u1 = (l21*(l14*r6_by_u1 - r10_by_u1) - l18*r6_by_u1 + r13_by_u1)/s22
    let u2_dot_by_u1 = (-r10_by_u1)
        .mul_add(l21_s22_inv, s22_inv * u2_dot_by_u1_of_place);
    // u0_dot_by_u1 = (r6_by_u1 + s5*(l18*r6_by_u1 - l21*(l14*r6_by_u1 - r10_by_u1) - r13_by_u1)/s22 +
    //   s4*(l14*r6_by_u1 - r10_by_u1 - s16*(l18*r6_by_u1 - l21*(l14*r6_by_u1 - r10_by_u1) -
    //   r13_by_u1)/s22)/s15)/s3
    let u0_dot_by_u1 = (-r10_by_u1)
        .mul_add(l14_s15_inv, u2_dot_by_u1 * l21_by_q1_of_s3_s4_s5_l21)
        + r6_by_u1 * u0_dot_by_q1_of_place_9;
    // u3_dot_by_u1 = m3*l2*(l1*cos(q2 - q3)*(l18*r6_by_u1 - l21*(l14*r6_by_u1 - r10_by_u1) -
    //   r13_by_u1)/s22 + cos(q3)*(r6_by_u1 + s5*(l18*r6_by_u1 - l21*(l14*r6_by_u1 - r10_by_u1) -
    //   r13_by_u1)/s22 + s4*(l14*r6_by_u1 - r10_by_u1 - s16*(l18*r6_by_u1 - l21*(l14*r6_by_u1 - r10_by_u1) -
    //   r13_by_u1)/s22)/s15)/s3 + l0*(2*u1*sin(q1 - q3) + cos(q1 - q3)*(l14*r6_by_u1 - r10_by_u1 -
    //   s16*(l18*r6_by_u1 - l21*(l14*r6_by_u1 - r10_by_u1) - r13_by_u1)/s22)/s15))/d1
    let u3_dot_by_u1 = (-r10_by_u1)
        .mul_add(u3_dot_by_q1_of_place, r6_by_u1 * u3_dot_by_q1_of_place_3)
        - u2_dot_by_u1 * u3_dot_by_q1_of_place_5 + sin_q1_minus_q3 * m3_l2_2_d1_inv * l0_u1_doubled;
    // s15_inv + l21*l21_s22_inv
    let u1_dot_by_u1_of_s15_l21_s22 = l21.mul_add(l21_s22_inv, s15_inv);
    // u1_dot_by_u1 = (r10_by_u1 - l14*r6_by_u1 + s16*(l18*r6_by_u1 - l21*(l14*r6_by_u1 - r10_by_u1) -
    //   r13_by_u1)/s22)/s15
    let u1_dot_by_u1 = (-r6_by_u1)
        .mul_add(l14_s15_inv, r10_by_u1 * u1_dot_by_u1_of_s15_l21_s22)
        - l21_s22_inv * u2_dot_by_u1_of_place;
    let u2_doubled = S::int(2) * u2;
    // r6_by_u2 = -2*l1*u2*(sin(q2)*(m2 + m3) + l2_*m3_l2*sin(q2 - q3))
    let r6_by_u2 = -s5_by_q2 * u2_doubled;
    // r10_by_u2 = -2*l1*u2*(l0*sin(q1 - q2)*(m2 + m3) + l7*m3_l2*sin(q2 - q3))
    let r10_by_u2 = -s9_by_q2 * u2_doubled;
    // r13_by_u2 = -2*l1*u2*l11*m3_l2*sin(q2 - q3)
    let r13_by_u2 = -s12_by_q2_of_place * u2_doubled;
    // r13_by_u2 + r6_by_u2*minus_l18_plus_l14_l21
    let u2_dot_by_u2_of_place = r6_by_u2.mul_add(minus_l18_plus_l14_l21, r13_by_u2);
    // u2_dot_by_u2 = (l21*(l14*r6_by_u2 - r10_by_u2) - l18*r6_by_u2 + r13_by_u2)/s22
    let u2_dot_by_u2 = (-r10_by_u2)
        .mul_add(l21_s22_inv, s22_inv * u2_dot_by_u2_of_place);
    // u0_dot_by_u2 = (r6_by_u2 + s5*(l18*r6_by_u2 - l21*(l14*r6_by_u2 - r10_by_u2) - r13_by_u2)/s22 +
    //   s4*(l14*r6_by_u2 - r10_by_u2 - s16*(l18*r6_by_u2 - l21*(l14*r6_by_u2 - r10_by_u2) -
    //   r13_by_u2)/s22)/s15)/s3
    let u0_dot_by_u2 = (-r10_by_u2)
        .mul_add(l14_s15_inv, u2_dot_by_u2 * l21_by_q1_of_s3_s4_s5_l21)
        + r6_by_u2 * u0_dot_by_q1_of_place_9;
    // u3_dot_by_u2 = m3*l2*(cos(q3)*(r6_by_u2 + s5*(l18*r6_by_u2 - l21*(l14*r6_by_u2 - r10_by_u2) -
    //   r13_by_u2)/s22 + s4*(l14*r6_by_u2 - r10_by_u2 - s16*(l18*r6_by_u2 - l21*(l14*r6_by_u2 - r10_by_u2) -
    //   r13_by_u2)/s22)/s15)/s3 - l0*cos(q1 - q3)*(r10_by_u2 - l14*r6_by_u2 + s16*(l18*r6_by_u2 -
    //   l21*(l14*r6_by_u2 - r10_by_u2) - r13_by_u2)/s22)/s15 + l1*(2*u2*sin(q2 - q3) + cos(q2 -
    //   q3)*(l18*r6_by_u2 - l21*(l14*r6_by_u2 - r10_by_u2) - r13_by_u2)/s22))/d1
    let u3_dot_by_u2 = (-r10_by_u2)
        .mul_add(u3_dot_by_q1_of_place, r6_by_u2 * u3_dot_by_q1_of_place_3)
        - u2_dot_by_u2 * u3_dot_by_q1_of_place_5 + l11_by_q3 * u2_doubled;
    // u1_dot_by_u2 = (r10_by_u2 - l14*r6_by_u2 + s16*(l18*r6_by_u2 - l21*(l14*r6_by_u2 - r10_by_u2) -
    //   r13_by_u2)/s22)/s15
    let u1_dot_by_u2 = (-r6_by_u2)
        .mul_add(l14_s15_inv, r10_by_u2 * u1_dot_by_u1_of_s15_l21_s22)
        - l21_s22_inv * u2_dot_by_u2_of_place;
    let u3_doubled = S::int(2) * u3;
    // r6_by_u3 = -2*u3*m3_l2*sin(q3)
    let r6_by_u3 = -s3_2_m3_l2 * u3_doubled;
    // r10_by_u3 = -2*l0*u3*m3_l2*sin(q1 - q3)
    let r10_by_u3 = -u3 * r6_by_u1_of_place;
    // r13_by_u3 = -2*l1*u3*m3_l2*sin(q2 - q3)
    let r13_by_u3 = -sin_q2_minus_q3_l1_m3_l2 * u3_doubled;
    // r13_by_u3 + r6_by_u3*minus_l18_plus_l14_l21
    let u2_dot_by_u3_of_place = r6_by_u3.mul_add(minus_l18_plus_l14_l21, r13_by_u3);
    // u2_dot_by_u3 = (l21*(l14*r6_by_u3 - r10_by_u3) - l18*r6_by_u3 + r13_by_u3)/s22
    let u2_dot_by_u3 = (-r10_by_u3)
        .mul_add(l21_s22_inv, s22_inv * u2_dot_by_u3_of_place);
    // u0_dot_by_u3 = (r6_by_u3 + s5*(l18*r6_by_u3 - l21*(l14*r6_by_u3 - r10_by_u3) - r13_by_u3)/s22 +
    //   s4*(l14*r6_by_u3 - r10_by_u3 - s16*(l18*r6_by_u3 - l21*(l14*r6_by_u3 - r10_by_u3) -
    //   r13_by_u3)/s22)/s15)/s3
    let u0_dot_by_u3 = (-r10_by_u3)
        .mul_add(l14_s15_inv, u2_dot_by_u3 * l21_by_q1_of_s3_s4_s5_l21)
        + r6_by_u3 * u0_dot_by_q1_of_place_9;
    // u3_dot_by_u3 = m3*l2*(cos(q3)*(r6_by_u3 + s5*(l18*r6_by_u3 - l21*(l14*r6_by_u3 - r10_by_u3) -
    //   r13_by_u3)/s22 + s4*(l14*r6_by_u3 - r10_by_u3 - s16*(l18*r6_by_u3 - l21*(l14*r6_by_u3 - r10_by_u3) -
    //   r13_by_u3)/s22)/s15)/s3 - l1*cos(q2 - q3)*(l21*(l14*r6_by_u3 - r10_by_u3) - l18*r6_by_u3 +
    //   r13_by_u3)/s22 - l0*cos(q1 - q3)*(r10_by_u3 - l14*r6_by_u3 + s16*(l18*r6_by_u3 - l21*(l14*r6_by_u3 -
    //   r10_by_u3) - r13_by_u3)/s22)/s15)/d1
    let u3_dot_by_u3 = (-r10_by_u3)
        .mul_add(u3_dot_by_q1_of_place, r6_by_u3 * u3_dot_by_q1_of_place_3)
        - u2_dot_by_u3 * u3_dot_by_q1_of_place_5;
    // u1_dot_by_u3 = (r10_by_u3 - l14*r6_by_u3 + s16*(l18*r6_by_u3 - l21*(l14*r6_by_u3 - r10_by_u3) -
    //   r13_by_u3)/s22)/s15
    let u1_dot_by_u3 = (-r6_by_u3)
        .mul_add(l14_s15_inv, r10_by_u3 * u1_dot_by_u1_of_s15_l21_s22)
        - l21_s22_inv * u2_dot_by_u3_of_place;
    // Entries that are not zero.
    // d(q1')/d(u1) = 1
    let q1_dot_by_u1_value = S::int(1);
    // d(q2')/d(u2) = 1
    let q2_dot_by_u2_value = S::int(1);
    // d(q3')/d(u3) = 1
    let q3_dot_by_u3_value = S::int(1);
    // d(q0')/d(u0) = 1
    let q0_dot_by_u0_value = S::int(1);
    // d(u2')/d(q1) = (r23_by_q1 - r23*s22_by_q1/s22)/s22
    let u2_dot_by_q1_value = -s22_inv * u0_dot_by_q1_of_place_10;
    // d(u2')/d(q2) = (r23_by_q2 - r23*s22_by_q2/s22)/s22
    let u2_dot_by_q2_value = -s22_inv * u0_dot_by_q2_of_place_3;
    // d(u2')/d(q3) = (r23_by_q3 - r23*s22_by_q3/s22)/s22
    let u2_dot_by_q3_value = -s22_inv * u0_dot_by_q3_of_place_3;
    let zero = S::int(0);
    [
        [zero, zero, zero, zero, q1_dot_by_u1_value, zero, zero, zero],
        [zero, zero, zero, zero, zero, q2_dot_by_u2_value, zero, zero],
        [zero, zero, zero, zero, zero, zero, q3_dot_by_u3_value, zero],
        [zero, zero, zero, zero, zero, zero, zero, q0_dot_by_u0_value],
        [
            u1_dot_by_q1, u1_dot_by_q2, u1_dot_by_q3, zero, u1_dot_by_u1, u1_dot_by_u2,
            u1_dot_by_u3, zero,
        ],
        [
            u2_dot_by_q1_value, u2_dot_by_q2_value, u2_dot_by_q3_value, zero, u2_dot_by_u1,
            u2_dot_by_u2, u2_dot_by_u3, zero,
        ],
        [
            u3_dot_by_q1, u3_dot_by_q2, u3_dot_by_q3, zero, u3_dot_by_u1, u3_dot_by_u2,
            u3_dot_by_u3, zero,
        ],
        [
            u0_dot_by_q1, u0_dot_by_q2, u0_dot_by_q3, zero, u0_dot_by_u1, u0_dot_by_u2,
            u0_dot_by_u3, zero,
        ],
    ]
}

/// The energy, then its derivatives by the state.
///
/// 100 operations, 3 sines and cosines.
#[must_use]
pub fn energy_gradient<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [S; 9] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, .. } = *p;
    let [q1, q2, q3, q0] = *q;
    let [u1, u2, u3, u0] = *u;
    // Sines and cosines.
    let (s3_2, c3) = q3.sin_cos();
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    // m2 + m3
    let m2_plus_m3 = m2 + m3;
    let m3_l2_2 = m3 * l2;
    let u3_m3_l2_2 = u3 * m3_l2_2;
    let c3_u3_m3_l2_2 = u3_m3_l2_2 * c3;
    // c3_u3_m3_l2_2 - u0*m2_plus_m3
    let energy_of_u0_u3 = (-u0).mul_add(m2_plus_m3, c3_u3_m3_l2_2);
    let l0_u1 = l0 * u1;
    let c1_l0_u1 = l0_u1 * c1;
    let l1_u2 = l1 * u2;
    let c2_l1_u2 = l1_u2 * c2;
    // c1_l0_u1 + c2_l1_u2
    let c1_l0_u1_plus_c2_l1_u2 = c1_l0_u1 + c2_l1_u2;
    // u0*u3_m3_l2_2 - g*m3_l2_2
    let energy_of_u0_u3_2 = (-g).mul_add(m3_l2_2, u0 * u3_m3_l2_2);
    let m2_plus_m3_l1_u2 = m2_plus_m3 * l1_u2;
    // m1*u0 - m2_plus_m3_l1_u2*cos(q2)
    let energy_of_u0_u2 = (-m2_plus_m3_l1_u2).mul_add(c2, m1 * u0);
    let s1_l0_u1 = l0_u1 * s1;
    let s3_2_u3_m3_l2_2 = u3_m3_l2_2 * s3_2;
    // m2_plus_m3*s1_l0_u1 + s3_2_u3_m3_l2_2
    let energy_of_u1_u3 = m2_plus_m3.mul_add(s1_l0_u1, s3_2_u3_m3_l2_2);
    let s2_l1_u2 = l1_u2 * s2;
    let l1_c2 = l1 * c2;
    let g_m2_plus_m3 = g * m2_plus_m3;
    // m1 + m2_plus_m3
    let m1_plus_m2_plus_m3 = m1 + m2_plus_m3;
    let l0_m1_plus_m2_plus_m3 = l0 * m1_plus_m2_plus_m3;
    let g_l0_m1_plus_m2_plus_m3 = g * l0_m1_plus_m2_plus_m3;
    let l2_u3_m3_l2_2 = l2 * u3_m3_l2_2;
    // l0_u1^2*m1_plus_m2_plus_m3 + u0^2*(m0 + m1_plus_m2_plus_m3)
    let energy_of_u0_u1 = l0_u1 * l0_u1 * m1_plus_m2_plus_m3 + u0 * u0 * (m0 + m1_plus_m2_plus_m3);
    // l1_u2*m2_plus_m3_l1_u2 + u3*l2_u3_m3_l2_2
    let energy_of_u2_u3 = u3.mul_add(l2_u3_m3_l2_2, l1_u2 * m2_plus_m3_l1_u2);
    // energy_of_u0_u1 + energy_of_u2_u3
    let energy_of_u0_u1_u2_u3 = energy_of_u0_u1 + energy_of_u2_u3;
    // m2_plus_m3_l1_u2*sin(q2) + s3_2_u3_m3_l2_2
    let energy_by_q1_of_u2_u3 = m2_plus_m3_l1_u2.mul_add(s2, s3_2_u3_m3_l2_2);
    // energy_of_u0_u3 - energy_of_u0_u2
    let energy_by_q1_of_u0_u2_u3 = energy_of_u0_u3 - energy_of_u0_u2;
    // energy_of_u0_u3 + m2_plus_m3*c1_l0_u1
    let energy_by_q2_of_u0_u1_u3 = m2_plus_m3.mul_add(c1_l0_u1, energy_of_u0_u3);
    let l1_s2 = l1 * s2;
    // s1_l0_u1 + s2_l1_u2
    let s1_l0_u1_plus_s2_l1_u2 = s1_l0_u1 + s2_l1_u2;
    // Values.
    // T + V = g*(l0*cos(q1)*(m1 + m2 + m3) + l1*cos(q2)*(m2 + m3) + m3*l2*cos(q3)) - 11*q0/4 + u0^2*(m0 +
    //   m1 + m2 + m3)/2 + l0*u1*((m1 + m2 + m3)*(l0*u1 - 2*u0*cos(q1)) + 2*l1*u2*cos(q1 - q2)*(m2 + m3))/2 +
    //   l1*u2*(m2 + m3)*(l1*u2 - 2*u0*cos(q2))/2 + m3*l2*u3*(2*l0*u1*cos(q1 - q3) - 2*u0*cos(q3) +
    //   2*l1*u2*cos(q2 - q3) + l2*u3)/2
    let energy = energy_of_u0_u3.mul_add(c1_l0_u1_plus_c2_l1_u2, -S::ratio(11, 4) * q0)
        - energy_of_u0_u3_2 * c3 - c1_l0_u1 * energy_of_u0_u2
        + s1_l0_u1 * s3_2_u3_m3_l2_2 + energy_of_u1_u3 * s2_l1_u2 + l1_c2 * g_m2_plus_m3
        + g_l0_m1_plus_m2_plus_m3 * c1 + S::ratio(1, 2) * energy_of_u0_u1_u2_u3;
    // d(T + V)/d(q1) = -l0*(g*sin(q1)*(m1 + m2 + m3) + u1*(l1*u2*sin(q1 - q2)*(m2 + m3) - u0*sin(q1)*(m1 +
    //   m2 + m3) + m3*l2*u3*sin(q1 - q3)))
    let energy_by_q1 = (-g_l0_m1_plus_m2_plus_m3)
        .mul_add(s1, c1_l0_u1 * energy_by_q1_of_u2_u3) - s1_l0_u1 * energy_by_q1_of_u0_u2_u3;
    // d(T + V)/d(q2) = -l1*(g*sin(q2)*(m2 + m3) + u2*(m3*l2*u3*sin(q2 - q3) - (m2 + m3)*(u0*sin(q2) +
    //   l0*u1*sin(q1 - q2))))
    let energy_by_q2 = (-s2_l1_u2)
        .mul_add(energy_by_q2_of_u0_u1_u3, c2_l1_u2 * energy_of_u1_u3) - g_m2_plus_m3 * l1_s2;
    // d(T + V)/d(q3) = m3*l2*(u3*(u0*sin(q3) + l0*u1*sin(q1 - q3) + l1*u2*sin(q2 - q3)) - g*sin(q3))
    let energy_by_q3 = (-c1_l0_u1_plus_c2_l1_u2)
        .mul_add(s3_2_u3_m3_l2_2, energy_of_u0_u3_2 * s3_2)
        + c3_u3_m3_l2_2 * s1_l0_u1_plus_s2_l1_u2;
    // d(T + V)/d(q0) = -11/4
    let energy_by_q0 = -S::ratio(11, 4);
    // d(T + V)/d(u1) = l0*((m1 + m2 + m3)*(l0*u1 - u0*cos(q1)) + l1*u2*cos(q1 - q2)*(m2 + m3) +
    //   m3*l2*u3*cos(q1 - q3))
    let energy_by_u1 = l0 * energy_by_q1_of_u0_u2_u3.mul_add(c1, energy_by_q1_of_u2_u3 * s1)
        + l0_u1 * l0_m1_plus_m2_plus_m3;
    // d(T + V)/d(u2) = l1*((m2 + m3)*(l0*u1*cos(q1 - q2) - u0*cos(q2) + l1*u2) + m3*l2*u3*cos(q2 - q3))
    let energy_by_u2 = l1_c2.mul_add(energy_by_q2_of_u0_u1_u3, l1 * m2_plus_m3_l1_u2)
        + energy_of_u1_u3 * l1_s2;
    // d(T + V)/d(u3) = m3*l2*(l0*u1*cos(q1 - q3) - u0*cos(q3) + l1*u2*cos(q2 - q3) + l2*u3)
    let energy_by_u3 = l2_u3_m3_l2_2
        + m3_l2_2 * (-c3 * (u0 - c1_l0_u1_plus_c2_l1_u2) + s1_l0_u1_plus_s2_l1_u2 * s3_2);
    // d(T + V)/d(u0) = u0*(m0 + m1 + m2 + m3) - l0*u1*cos(q1)*(m1 + m2 + m3) - l1*u2*cos(q2)*(m2 + m3) -
    //   m3*l2*u3*cos(q3)
    let energy_by_u0 = (-c1_l0_u1).mul_add(m1_plus_m2_plus_m3, m0 * u0) - energy_by_q1_of_u0_u2_u3;
    [
        energy, energy_by_q1, energy_by_q2, energy_by_q3, energy_by_q0, energy_by_u1, energy_by_u2,
        energy_by_u3, energy_by_u0,
    ]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 52 convolutions and 96 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 8]],
    history: &mut [Factors<S, 56>],
) {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, m3_l2 } = *p;
    let [q1_0, q2_0, q3_0, _, u1_0, u2_0, u3_0, u0_0] = series[0];
    // Shared terms.
    // m1 + m2 + m3
    let m1_plus_m2_plus_m3_2 = m1 + m2 + m3;
    // m2 + m3
    let m2_plus_m3_2 = m2 + m3;
    let m3_inv_l2_inv2_m3_l2_sq = m3_l2 * m3_l2 / (m3 * l2 * l2);
    let l0_l1_m2_plus_m3_of_m2_m3_l0_l1 = l0 * l1 * m2_plus_m3_2;
    // Constant in time.
    // weight = m0 + m1 + m2 + m3
    let weight = m0 + m1 + m2 + m3;
    // minus_m3_l2_2_by_m3_l2_2 = -m3_l2^2/(m3*l2^2)
    let minus_m3_l2_2_by_m3_l2_2 = -m3_inv_l2_inv2_m3_l2_sq;
    // m1_plus_m2_plus_m3 = m1 + m2 + m3
    let m1_plus_m2_plus_m3 = m1_plus_m2_plus_m3_2;
    // m2_plus_m3 = m2 + m3
    let m2_plus_m3 = m2_plus_m3_2;
    // weight_2 = -l0*(m1 + m2 + m3)
    let weight_2 = -l0 * m1_plus_m2_plus_m3_2;
    // minus_l1_m2_plus_m3 = -l1*(m2 + m3)
    let minus_l1_m2_plus_m3 = -l1 * m2_plus_m3_2;
    // minus_m3_l2 = -m3_l2
    let minus_m3_l2 = -m3_l2;
    // m3_l2_2_by_m3_l2_2 = m3_l2^2/(m3*l2^2)
    let m3_l2_2_by_m3_l2_2 = m3_inv_l2_inv2_m3_l2_sq;
    // l0_2_m1_plus_m2_plus_m3 = l0^2*(m1 + m2 + m3)
    let l0_2_m1_plus_m2_plus_m3 = l0 * l0 * m1_plus_m2_plus_m3_2;
    // minus_l0_2_m3_l2_by_l2 = -l0^2*m3_l2/l2
    let minus_l0_2_m3_l2_by_l2 = -l0 * l0 * m3_l2 / l2;
    // minus_l0_2 = -l0^2
    let minus_l0_2 = -l0 * l0;
    // l0_l1_m2_plus_m3 = l0*l1*(m2 + m3)
    let l0_l1_m2_plus_m3 = l0_l1_m2_plus_m3_of_m2_m3_l0_l1;
    // minus_l0_l1_m3_l2_by_l2 = -l0*l1*m3_l2/l2
    let minus_l0_l1_m3_l2_by_l2 = -l0 * l1 * m3_l2 / l2;
    // minus_l0_l1 = -l0*l1
    let minus_l0_l1 = -l0 * l1;
    // minus_l0_l1_m2_plus_m3 = -l0*l1*(m2 + m3)
    let minus_l0_l1_m2_plus_m3 = -l0_l1_m2_plus_m3_of_m2_m3_l0_l1;
    // l0_g_m1_plus_m2_plus_m3 = l0*g*(m1 + m2 + m3)
    let l0_g_m1_plus_m2_plus_m3 = l0 * g * m1_plus_m2_plus_m3_2;
    // minus_l0_m3_l2_by_l2 = -l0*m3_l2/l2
    let minus_l0_m3_l2_by_l2 = -l0 * m3_l2 / l2;
    // minus_l0_m3_l2 = -l0*m3_l2
    let minus_l0_m3_l2 = -l0 * m3_l2;
    // l1_2_m2_plus_m3 = l1^2*(m2 + m3)
    let l1_2_m2_plus_m3 = l1 * l1 * m2_plus_m3_2;
    // minus_l1_2_m3_l2_by_l2 = -l1^2*m3_l2/l2
    let minus_l1_2_m3_l2_by_l2 = -l1 * l1 * m3_l2 / l2;
    // minus_l1_2 = -l1^2
    let minus_l1_2 = -l1 * l1;
    // l1_g_m2_plus_m3 = l1*g*(m2 + m3)
    let l1_g_m2_plus_m3 = l1 * g * m2_plus_m3_2;
    // minus_l1_m3_l2_by_l2 = -l1*m3_l2/l2
    let minus_l1_m3_l2_by_l2 = -l1 * m3_l2 / l2;
    // minus_l1_m3_l2 = -l1*m3_l2
    let minus_l1_m3_l2 = -l1 * m3_l2;
    // minus_l0 = -l0
    let minus_l0 = -l0;
    // minus_l1 = -l1
    let minus_l1 = -l1;
    // weight_3 = 1/l2
    let weight_3 = S::int(1) / l2;
    // Order 0.
    let (s3_2_0, c3_0) = q3_0.sin_cos();
    let c3_sq_0 = c3_0 * c3_0;
    let s3_of_place_0 = c3_sq_0.mul_add(minus_m3_l2_2_by_m3_l2_2, weight);
    let over_s3_of_place = S::int(1) / s3_of_place_0;
    let (s1_0, c1_0) = q1_0.sin_cos();
    let q1_minus_q3_0 = q1_0 - q3_0;
    let (sin_q1_minus_q3_0, cos_q1_minus_q3_0) = q1_minus_q3_0.sin_cos();
    let c3_cos_q1_minus_q3_0 = cos_q1_minus_q3_0 * c3_0;
    let s4_of_place_0 = c3_cos_q1_minus_q3_0
        .mul_add(minus_m3_l2_2_by_m3_l2_2, m1_plus_m2_plus_m3 * c1_0);
    let (s2_0, c2_0) = q2_0.sin_cos();
    let q2_minus_q3_0 = q2_0 - q3_0;
    let (sin_q2_minus_q3_0, cos_q2_minus_q3_0) = q2_minus_q3_0.sin_cos();
    let c3_cos_q2_minus_q3_0 = cos_q2_minus_q3_0 * c3_0;
    let s5_of_place_0 = c3_cos_q2_minus_q3_0
        .mul_add(minus_m3_l2_2_by_m3_l2_2, m2_plus_m3 * c2_0);
    let u1_sq_0 = u1_0 * u1_0;
    let u1_sq_s1_0 = s1_0 * u1_sq_0;
    let u2_sq_0 = u2_0 * u2_0;
    let u2_sq_s2_0 = s2_0 * u2_sq_0;
    let u1_sq_sin_q1_minus_q3_0 = sin_q1_minus_q3_0 * u1_sq_0;
    let u2_sq_sin_q2_minus_q3_0 = sin_q2_minus_q3_0 * u2_sq_0;
    let r6_of_u1_u2_0 = u2_sq_sin_q2_minus_q3_0
        .mul_add(l1, u1_sq_sin_q1_minus_q3_0.mul_add(l0, g * s3_2_0));
    let u3_sq_0 = u3_0 * u3_0;
    let u3_sq_s3_2_0 = s3_2_0 * u3_sq_0;
    let r6_of_u1_u2_2_0 = r6_of_u1_u2_0 * c3_0;
    let r6_of_u1_u2_u3_0 = r6_of_u1_u2_2_0
        .mul_add(
            m3_l2_2_by_m3_l2_2,
            u3_sq_s3_2_0
                .mul_add(
                    minus_m3_l2,
                    u2_sq_s2_0
                        .mul_add(
                            minus_l1_m2_plus_m3,
                            u1_sq_s1_0.mul_add(weight_2, S::ratio(11, 4)),
                        ),
                ),
        );
    let cos_q1_minus_q3_sq_0 = cos_q1_minus_q3_0 * cos_q1_minus_q3_0;
    let q1_minus_q2_0 = q1_0 - q2_0;
    let (sin_q1_minus_q2_0, cos_q1_minus_q2_0) = q1_minus_q2_0.sin_cos();
    let s9_of_q1_q2_q3_0 = cos_q2_minus_q3_0 * cos_q1_minus_q3_0;
    let u2_sq_sin_q1_minus_q2_0 = sin_q1_minus_q2_0 * u2_sq_0;
    let r10_of_u1_u2_0 = r6_of_u1_u2_0 * cos_q1_minus_q3_0;
    let u3_sq_sin_q1_minus_q3_0 = sin_q1_minus_q3_0 * u3_sq_0;
    let cos_q2_minus_q3_sq_0 = cos_q2_minus_q3_0 * cos_q2_minus_q3_0;
    let u1_sq_sin_q1_minus_q2_0 = sin_q1_minus_q2_0 * u1_sq_0;
    let r13_of_u1_u2_0 = r6_of_u1_u2_0 * cos_q2_minus_q3_0;
    let u3_sq_sin_q2_minus_q3_0 = sin_q2_minus_q3_0 * u3_sq_0;
    let l14_of_place_0 = s4_of_place_0 * over_s3_of_place;
    let s15_of_place_0 = s4_of_place_0 * l14_of_place_0;
    let s8_minus_s4_l14_0 = s15_of_place_0
        .mul_add(
            minus_l0_2,
            cos_q1_minus_q3_sq_0.mul_add(minus_l0_2_m3_l2_by_l2, l0_2_m1_plus_m2_plus_m3),
        );
    let over_s8_minus_s4_l14 = S::int(1) / s8_minus_s4_l14_0;
    let s16_of_place_0 = s5_of_place_0 * l14_of_place_0;
    let s9_minus_s5_l14_0 = s16_of_place_0
        .mul_add(
            minus_l0_l1,
            s9_of_q1_q2_q3_0
                .mul_add(minus_l0_l1_m3_l2_by_l2, l0_l1_m2_plus_m3 * cos_q1_minus_q2_0),
        );
    let r17_of_u1_u2_u3_0 = r6_of_u1_u2_u3_0 * l14_of_place_0;
    let r10_minus_r6_l14_0 = r17_of_u1_u2_u3_0
        .mul_add(
            l0,
            r10_of_u1_u2_0
                .mul_add(
                    minus_l0_m3_l2_by_l2,
                    u3_sq_sin_q1_minus_q3_0
                        .mul_add(
                            minus_l0_m3_l2,
                            u2_sq_sin_q1_minus_q2_0
                                .mul_add(
                                    minus_l0_l1_m2_plus_m3,
                                    l0_g_m1_plus_m2_plus_m3 * s1_0,
                                ),
                        ),
                ),
        );
    let l18_of_place_0 = s5_of_place_0 * over_s3_of_place;
    let s19_of_place_0 = s5_of_place_0 * l18_of_place_0;
    let r20_of_u1_u2_u3_0 = r6_of_u1_u2_u3_0 * l18_of_place_0;
    let l21_of_place_0 = s9_minus_s5_l14_0 * over_s8_minus_s4_l14;
    let s22_of_place_0 = s9_minus_s5_l14_0 * l21_of_place_0;
    let s19_minus_s16_l21_0 = s19_of_place_0
        .mul_add(
            minus_l1_2,
            cos_q2_minus_q3_sq_0.mul_add(minus_l1_2_m3_l2_by_l2, l1_2_m2_plus_m3),
        ) - s22_of_place_0;
    let over_s19_minus_s16_l21 = S::int(1) / s19_minus_s16_l21_0;
    let r23_of_place_0 = r10_minus_r6_l14_0 * l21_of_place_0;
    let r20_minus_r17_l21_0 = r20_of_u1_u2_u3_0
        .mul_add(
            l1,
            r13_of_u1_u2_0
                .mul_add(
                    minus_l1_m3_l2_by_l2,
                    u3_sq_sin_q2_minus_q3_0
                        .mul_add(
                            minus_l1_m3_l2,
                            u1_sq_sin_q1_minus_q2_0
                                .mul_add(l0_l1_m2_plus_m3, l1_g_m2_plus_m3 * s2_0),
                        ),
                ),
        ) - r23_of_place_0;
    let u2_dot_2_0 = r20_minus_r17_l21_0 * over_s19_minus_s16_l21;
    let u0_dot_of_place_0 = s9_minus_s5_l14_0 * u2_dot_2_0;
    let u0_dot_of_place_2_0 = r10_minus_r6_l14_0 - u0_dot_of_place_0;
    let u1_dot_2_0 = u0_dot_of_place_2_0 * over_s8_minus_s4_l14;
    let u0_dot_of_place_3_0 = s4_of_place_0 * u1_dot_2_0;
    let u0_dot_of_place_4_0 = s5_of_place_0 * u2_dot_2_0;
    let u0_dot_of_place_5_0 = u0_dot_of_place_3_0
        .mul_add(l0, u0_dot_of_place_4_0.mul_add(l1, r6_of_u1_u2_u3_0));
    let u0_dot_2_0 = u0_dot_of_place_5_0 * over_s3_of_place;
    let u3_dot_of_place_0 = cos_q1_minus_q3_0 * u1_dot_2_0;
    let u3_dot_of_place_2_0 = cos_q2_minus_q3_0 * u2_dot_2_0;
    let u3_dot_of_place_3_0 = c3_0 * u0_dot_2_0;
    let u3_dot_of_u1_u2_0 = u3_dot_of_place_0
        .mul_add(
            minus_l0,
            u3_dot_of_place_2_0
                .mul_add(
                    minus_l1,
                    u2_sq_sin_q2_minus_q3_0
                        .mul_add(l1, u1_sq_sin_q1_minus_q3_0.mul_add(l0, g * s3_2_0)),
                ),
        ) + u3_dot_of_place_3_0;
    // Order 1: the rates, and what follows from them.
    let q1_1 = u1_0;
    let q2_1 = u2_0;
    let q3_1 = u3_0;
    let q0_1 = u0_0;
    let u1_1 = u1_dot_2_0;
    let u2_1 = u2_dot_2_0;
    let u3_1 = weight_3 * u3_dot_of_u1_u2_0;
    let u0_1 = u0_dot_2_0;
    if series.len() > 1 {
        series[1] = [q1_1, q2_1, q3_1, q0_1, u1_1, u2_1, u3_1, u0_1];
    }
    let s3_2_1 = q3_1 * c3_0;
    let c3_1 = -q3_1 * s3_2_0;
    let c3_sq_1 = c3_1 * (c3_0 + c3_0);
    let s3_of_place_1 = minus_m3_l2_2_by_m3_l2_2 * c3_sq_1;
    let s1_1 = q1_1 * c1_0;
    let c1_1 = -q1_1 * s1_0;
    let q1_minus_q3_1 = q1_1 - q3_1;
    let sin_q1_minus_q3_1 = q1_minus_q3_1 * cos_q1_minus_q3_0;
    let cos_q1_minus_q3_1 = -q1_minus_q3_1 * sin_q1_minus_q3_0;
    let c3_cos_q1_minus_q3_1 = cos_q1_minus_q3_1.mul_add(c3_0, c3_1 * cos_q1_minus_q3_0);
    let s4_of_place_1 = c3_cos_q1_minus_q3_1
        .mul_add(minus_m3_l2_2_by_m3_l2_2, m1_plus_m2_plus_m3 * c1_1);
    let s2_1 = q2_1 * c2_0;
    let c2_1 = -q2_1 * s2_0;
    let q2_minus_q3_1 = q2_1 - q3_1;
    let sin_q2_minus_q3_1 = q2_minus_q3_1 * cos_q2_minus_q3_0;
    let cos_q2_minus_q3_1 = -q2_minus_q3_1 * sin_q2_minus_q3_0;
    let c3_cos_q2_minus_q3_1 = cos_q2_minus_q3_1.mul_add(c3_0, c3_1 * cos_q2_minus_q3_0);
    let s5_of_place_1 = c3_cos_q2_minus_q3_1
        .mul_add(minus_m3_l2_2_by_m3_l2_2, m2_plus_m3 * c2_1);
    let u1_sq_1 = u1_1 * (u1_0 + u1_0);
    let u1_sq_s1_1 = u1_sq_1.mul_add(s1_0, s1_1 * u1_sq_0);
    let u2_sq_1 = u2_1 * (u2_0 + u2_0);
    let u2_sq_s2_1 = u2_sq_1.mul_add(s2_0, s2_1 * u2_sq_0);
    let u1_sq_sin_q1_minus_q3_1 = sin_q1_minus_q3_1
        .mul_add(u1_sq_0, u1_sq_1 * sin_q1_minus_q3_0);
    let u2_sq_sin_q2_minus_q3_1 = sin_q2_minus_q3_1
        .mul_add(u2_sq_0, u2_sq_1 * sin_q2_minus_q3_0);
    let r6_of_u1_u2_1 = u2_sq_sin_q2_minus_q3_1
        .mul_add(l1, u1_sq_sin_q1_minus_q3_1.mul_add(l0, g * s3_2_1));
    let u3_sq_1 = u3_1 * (u3_0 + u3_0);
    let u3_sq_s3_2_1 = u3_sq_1.mul_add(s3_2_0, s3_2_1 * u3_sq_0);
    let r6_of_u1_u2_2_1 = r6_of_u1_u2_1.mul_add(c3_0, c3_1 * r6_of_u1_u2_0);
    let r6_of_u1_u2_u3_1 = r6_of_u1_u2_2_1
        .mul_add(
            m3_l2_2_by_m3_l2_2,
            u3_sq_s3_2_1
                .mul_add(
                    minus_m3_l2,
                    u2_sq_s2_1.mul_add(minus_l1_m2_plus_m3, weight_2 * u1_sq_s1_1),
                ),
        );
    let cos_q1_minus_q3_sq_1 = cos_q1_minus_q3_1 * (cos_q1_minus_q3_0 + cos_q1_minus_q3_0);
    let q1_minus_q2_1 = q1_1 - q2_1;
    let sin_q1_minus_q2_1 = q1_minus_q2_1 * cos_q1_minus_q2_0;
    let cos_q1_minus_q2_1 = -q1_minus_q2_1 * sin_q1_minus_q2_0;
    let s9_of_q1_q2_q3_1 = cos_q1_minus_q3_1
        .mul_add(cos_q2_minus_q3_0, cos_q2_minus_q3_1 * cos_q1_minus_q3_0);
    let u2_sq_sin_q1_minus_q2_1 = sin_q1_minus_q2_1
        .mul_add(u2_sq_0, u2_sq_1 * sin_q1_minus_q2_0);
    let r10_of_u1_u2_1 = r6_of_u1_u2_1
        .mul_add(cos_q1_minus_q3_0, cos_q1_minus_q3_1 * r6_of_u1_u2_0);
    let u3_sq_sin_q1_minus_q3_1 = sin_q1_minus_q3_1
        .mul_add(u3_sq_0, u3_sq_1 * sin_q1_minus_q3_0);
    let cos_q2_minus_q3_sq_1 = cos_q2_minus_q3_1 * (cos_q2_minus_q3_0 + cos_q2_minus_q3_0);
    let u1_sq_sin_q1_minus_q2_1 = sin_q1_minus_q2_1
        .mul_add(u1_sq_0, u1_sq_1 * sin_q1_minus_q2_0);
    let r13_of_u1_u2_1 = r6_of_u1_u2_1
        .mul_add(cos_q2_minus_q3_0, cos_q2_minus_q3_1 * r6_of_u1_u2_0);
    let u3_sq_sin_q2_minus_q3_1 = sin_q2_minus_q3_1
        .mul_add(u3_sq_0, u3_sq_1 * sin_q2_minus_q3_0);
    let l14_of_place_1 = s3_of_place_1
        .mul_add(-(l14_of_place_0 * over_s3_of_place), s4_of_place_1 * over_s3_of_place);
    let s15_of_place_1 = l14_of_place_1
        .mul_add(s4_of_place_0, s4_of_place_1 * l14_of_place_0);
    let s8_minus_s4_l14_1 = s15_of_place_1
        .mul_add(minus_l0_2, minus_l0_2_m3_l2_by_l2 * cos_q1_minus_q3_sq_1);
    let s16_of_place_1 = l14_of_place_1
        .mul_add(s5_of_place_0, s5_of_place_1 * l14_of_place_0);
    let s9_minus_s5_l14_1 = s16_of_place_1
        .mul_add(
            minus_l0_l1,
            s9_of_q1_q2_q3_1
                .mul_add(minus_l0_l1_m3_l2_by_l2, l0_l1_m2_plus_m3 * cos_q1_minus_q2_1),
        );
    let r17_of_u1_u2_u3_1 = r6_of_u1_u2_u3_1
        .mul_add(l14_of_place_0, l14_of_place_1 * r6_of_u1_u2_u3_0);
    let r10_minus_r6_l14_1 = r17_of_u1_u2_u3_1
        .mul_add(
            l0,
            r10_of_u1_u2_1
                .mul_add(
                    minus_l0_m3_l2_by_l2,
                    u3_sq_sin_q1_minus_q3_1
                        .mul_add(
                            minus_l0_m3_l2,
                            u2_sq_sin_q1_minus_q2_1
                                .mul_add(
                                    minus_l0_l1_m2_plus_m3,
                                    l0_g_m1_plus_m2_plus_m3 * s1_1,
                                ),
                        ),
                ),
        );
    let l18_of_place_1 = s3_of_place_1
        .mul_add(-(l18_of_place_0 * over_s3_of_place), s5_of_place_1 * over_s3_of_place);
    let s19_of_place_1 = l18_of_place_1
        .mul_add(s5_of_place_0, s5_of_place_1 * l18_of_place_0);
    let r20_of_u1_u2_u3_1 = r6_of_u1_u2_u3_1
        .mul_add(l18_of_place_0, l18_of_place_1 * r6_of_u1_u2_u3_0);
    let l21_of_place_1 = s8_minus_s4_l14_1
        .mul_add(
            -(l21_of_place_0 * over_s8_minus_s4_l14),
            s9_minus_s5_l14_1 * over_s8_minus_s4_l14,
        );
    let s22_of_place_1 = l21_of_place_1
        .mul_add(s9_minus_s5_l14_0, s9_minus_s5_l14_1 * l21_of_place_0);
    let s19_minus_s16_l21_1 = s19_of_place_1
        .mul_add(minus_l1_2, minus_l1_2_m3_l2_by_l2 * cos_q2_minus_q3_sq_1) - s22_of_place_1;
    let r23_of_place_1 = l21_of_place_1
        .mul_add(r10_minus_r6_l14_0, r10_minus_r6_l14_1 * l21_of_place_0);
    let r20_minus_r17_l21_1 = r20_of_u1_u2_u3_1
        .mul_add(
            l1,
            r13_of_u1_u2_1
                .mul_add(
                    minus_l1_m3_l2_by_l2,
                    u3_sq_sin_q2_minus_q3_1
                        .mul_add(
                            minus_l1_m3_l2,
                            u1_sq_sin_q1_minus_q2_1
                                .mul_add(l0_l1_m2_plus_m3, l1_g_m2_plus_m3 * s2_1),
                        ),
                ),
        ) - r23_of_place_1;
    let u2_dot_2_1 = s19_minus_s16_l21_1
        .mul_add(
            -(u2_dot_2_0 * over_s19_minus_s16_l21),
            r20_minus_r17_l21_1 * over_s19_minus_s16_l21,
        );
    let u0_dot_of_place_1 = u2_dot_2_1
        .mul_add(s9_minus_s5_l14_0, s9_minus_s5_l14_1 * u2_dot_2_0);
    let u0_dot_of_place_2_1 = r10_minus_r6_l14_1 - u0_dot_of_place_1;
    let u1_dot_2_1 = s8_minus_s4_l14_1
        .mul_add(
            -(u1_dot_2_0 * over_s8_minus_s4_l14),
            u0_dot_of_place_2_1 * over_s8_minus_s4_l14,
        );
    let u0_dot_of_place_3_1 = u1_dot_2_1
        .mul_add(s4_of_place_0, s4_of_place_1 * u1_dot_2_0);
    let u0_dot_of_place_4_1 = u2_dot_2_1
        .mul_add(s5_of_place_0, s5_of_place_1 * u2_dot_2_0);
    let u0_dot_of_place_5_1 = u0_dot_of_place_3_1
        .mul_add(l0, u0_dot_of_place_4_1.mul_add(l1, r6_of_u1_u2_u3_1));
    let u0_dot_2_1 = s3_of_place_1
        .mul_add(
            -(u0_dot_2_0 * over_s3_of_place),
            u0_dot_of_place_5_1 * over_s3_of_place,
        );
    let u3_dot_of_place_1 = u1_dot_2_1
        .mul_add(cos_q1_minus_q3_0, cos_q1_minus_q3_1 * u1_dot_2_0);
    let u3_dot_of_place_2_1 = u2_dot_2_1
        .mul_add(cos_q2_minus_q3_0, cos_q2_minus_q3_1 * u2_dot_2_0);
    let u3_dot_of_place_3_1 = u0_dot_2_1.mul_add(c3_0, c3_1 * u0_dot_2_0);
    let u3_dot_of_u1_u2_1 = u3_dot_of_place_1
        .mul_add(
            minus_l0,
            u3_dot_of_place_2_1
                .mul_add(
                    minus_l1,
                    u2_sq_sin_q2_minus_q3_1
                        .mul_add(l1, u1_sq_sin_q1_minus_q3_1.mul_add(l0, g * s3_2_1)),
                ),
        ) + u3_dot_of_place_3_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                q3_1, q3_1, c3_1, q1_1, q1_1, q1_minus_q3_1, q1_minus_q3_1, cos_q1_minus_q3_1, q2_1,
                q2_1, q2_minus_q3_1, q2_minus_q3_1, cos_q2_minus_q3_1, u1_1, s1_1, u2_1, s2_1,
                sin_q1_minus_q3_1, sin_q2_minus_q3_1, u3_1, s3_2_1, r6_of_u1_u2_1,
                cos_q1_minus_q3_1, q1_minus_q2_1, q1_minus_q2_1, cos_q2_minus_q3_1,
                sin_q1_minus_q2_1, r6_of_u1_u2_1, sin_q1_minus_q3_1, cos_q2_minus_q3_1,
                sin_q1_minus_q2_1, r6_of_u1_u2_1, sin_q2_minus_q3_1, s3_of_place_1, s4_of_place_1,
                s5_of_place_1, r6_of_u1_u2_u3_1, s3_of_place_1, s5_of_place_1, r6_of_u1_u2_u3_1,
                s8_minus_s4_l14_1, s9_minus_s5_l14_1, r10_minus_r6_l14_1, s19_minus_s16_l21_1,
                s9_minus_s5_l14_1, s8_minus_s4_l14_1, s4_of_place_1, s5_of_place_1, s3_of_place_1,
                cos_q1_minus_q3_1, cos_q2_minus_q3_1, c3_1,
            ]),
            padded([
                c3_1, s3_2_1, c3_1, c1_1, s1_1, cos_q1_minus_q3_1, sin_q1_minus_q3_1, c3_1, c2_1,
                s2_1, cos_q2_minus_q3_1, sin_q2_minus_q3_1, c3_1, u1_1, u1_sq_1, u2_1, u2_sq_1,
                u1_sq_1, u2_sq_1, u3_1, u3_sq_1, c3_1, cos_q1_minus_q3_1, cos_q1_minus_q2_1,
                sin_q1_minus_q2_1, cos_q1_minus_q3_1, u2_sq_1, cos_q1_minus_q3_1, u3_sq_1,
                cos_q2_minus_q3_1, u1_sq_1, cos_q2_minus_q3_1, u3_sq_1, l14_of_place_1,
                l14_of_place_1, l14_of_place_1, l14_of_place_1, l18_of_place_1, l18_of_place_1,
                l18_of_place_1, l21_of_place_1, l21_of_place_1, l21_of_place_1, u2_dot_2_1,
                u2_dot_2_1, u1_dot_2_1, u1_dot_2_1, u2_dot_2_1, u0_dot_2_1, u1_dot_2_1, u2_dot_2_1,
                u0_dot_2_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q1_last = q1_1;
    let mut q2_last = q2_1;
    let mut q3_last = q3_1;
    let mut u1_last = u1_1;
    let mut u2_last = u2_1;
    let mut u3_last = u3_1;
    let mut s3_2_last = s3_2_1;
    let mut c3_last = c3_1;
    let mut s3_of_place_last = s3_of_place_1;
    let mut s1_last = s1_1;
    let mut c1_last = c1_1;
    let mut q1_minus_q3_last = q1_minus_q3_1;
    let mut sin_q1_minus_q3_last = sin_q1_minus_q3_1;
    let mut cos_q1_minus_q3_last = cos_q1_minus_q3_1;
    let mut s4_of_place_last = s4_of_place_1;
    let mut s2_last = s2_1;
    let mut c2_last = c2_1;
    let mut q2_minus_q3_last = q2_minus_q3_1;
    let mut sin_q2_minus_q3_last = sin_q2_minus_q3_1;
    let mut cos_q2_minus_q3_last = cos_q2_minus_q3_1;
    let mut s5_of_place_last = s5_of_place_1;
    let mut u1_sq_last = u1_sq_1;
    let mut u2_sq_last = u2_sq_1;
    let mut r6_of_u1_u2_last = r6_of_u1_u2_1;
    let mut u3_sq_last = u3_sq_1;
    let mut r6_of_u1_u2_u3_last = r6_of_u1_u2_u3_1;
    let mut q1_minus_q2_last = q1_minus_q2_1;
    let mut sin_q1_minus_q2_last = sin_q1_minus_q2_1;
    let mut cos_q1_minus_q2_last = cos_q1_minus_q2_1;
    let mut l14_of_place_last = l14_of_place_1;
    let mut s8_minus_s4_l14_last = s8_minus_s4_l14_1;
    let mut s9_minus_s5_l14_last = s9_minus_s5_l14_1;
    let mut r10_minus_r6_l14_last = r10_minus_r6_l14_1;
    let mut l18_of_place_last = l18_of_place_1;
    let mut l21_of_place_last = l21_of_place_1;
    let mut s19_minus_s16_l21_last = s19_minus_s16_l21_1;
    let mut u2_dot_2_last = u2_dot_2_1;
    let mut u1_dot_2_last = u1_dot_2_1;
    let mut u0_dot_2_last = u0_dot_2_1;
    let mut next = [S::int(0); 56];
    // Rates at order k - 1.
    let mut q1_rate = u1_1;
    let mut q2_rate = u2_1;
    let mut q3_rate = u3_1;
    let mut q0_rate = u0_1;
    let mut u1_rate = u1_dot_2_1;
    let mut u2_rate = u2_dot_2_1;
    let mut u3_rate = weight_3 * u3_dot_of_u1_u2_1;
    let mut u0_rate = u0_dot_2_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q1 = q1_rate * over_k;
        let q2 = q2_rate * over_k;
        let q3 = q3_rate * over_k;
        let q0 = q0_rate * over_k;
        let u1 = u1_rate * over_k;
        let u2 = u2_rate * over_k;
        let u3 = u3_rate * over_k;
        let u0 = u0_rate * over_k;
        series[order] = [q1, q2, q3, q0, u1, u2, u3, u0];
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
                q3_1.mul_add(c3_last, (count_last * q3_last).mul_add(c3_1, next[0])),
                q3_1.mul_add(s3_2_last, (count_last * q3_last).mul_add(s3_2_1, next[1])),
                (c3_1 + c3_1).mul_add(c3_last, next[2]),
                q1_1.mul_add(c1_last, (count_last * q1_last).mul_add(c1_1, next[3])),
                q1_1.mul_add(s1_last, (count_last * q1_last).mul_add(s1_1, next[4])),
                q1_minus_q3_1
                    .mul_add(
                        cos_q1_minus_q3_last,
                        (count_last * q1_minus_q3_last)
                            .mul_add(cos_q1_minus_q3_1, next[5]),
                    ),
                q1_minus_q3_1
                    .mul_add(
                        sin_q1_minus_q3_last,
                        (count_last * q1_minus_q3_last)
                            .mul_add(sin_q1_minus_q3_1, next[6]),
                    ),
                cos_q1_minus_q3_1
                    .mul_add(c3_last, cos_q1_minus_q3_last.mul_add(c3_1, next[7])),
                q2_1.mul_add(c2_last, (count_last * q2_last).mul_add(c2_1, next[8])),
                q2_1.mul_add(s2_last, (count_last * q2_last).mul_add(s2_1, next[9])),
                q2_minus_q3_1
                    .mul_add(
                        cos_q2_minus_q3_last,
                        (count_last * q2_minus_q3_last)
                            .mul_add(cos_q2_minus_q3_1, next[10]),
                    ),
                q2_minus_q3_1
                    .mul_add(
                        sin_q2_minus_q3_last,
                        (count_last * q2_minus_q3_last)
                            .mul_add(sin_q2_minus_q3_1, next[11]),
                    ),
                cos_q2_minus_q3_1
                    .mul_add(c3_last, cos_q2_minus_q3_last.mul_add(c3_1, next[12])),
                (u1_1 + u1_1).mul_add(u1_last, next[13]),
                s1_1.mul_add(u1_sq_last, s1_last.mul_add(u1_sq_1, next[14])),
                (u2_1 + u2_1).mul_add(u2_last, next[15]),
                s2_1.mul_add(u2_sq_last, s2_last.mul_add(u2_sq_1, next[16])),
                sin_q1_minus_q3_1
                    .mul_add(
                        u1_sq_last,
                        sin_q1_minus_q3_last.mul_add(u1_sq_1, next[17]),
                    ),
                sin_q2_minus_q3_1
                    .mul_add(
                        u2_sq_last,
                        sin_q2_minus_q3_last.mul_add(u2_sq_1, next[18]),
                    ),
                (u3_1 + u3_1).mul_add(u3_last, next[19]),
                s3_2_1.mul_add(u3_sq_last, s3_2_last.mul_add(u3_sq_1, next[20])),
                r6_of_u1_u2_1.mul_add(c3_last, r6_of_u1_u2_last.mul_add(c3_1, next[21])),
                (cos_q1_minus_q3_1 + cos_q1_minus_q3_1)
                    .mul_add(cos_q1_minus_q3_last, next[22]),
                q1_minus_q2_1
                    .mul_add(
                        cos_q1_minus_q2_last,
                        (count_last * q1_minus_q2_last)
                            .mul_add(cos_q1_minus_q2_1, next[23]),
                    ),
                q1_minus_q2_1
                    .mul_add(
                        sin_q1_minus_q2_last,
                        (count_last * q1_minus_q2_last)
                            .mul_add(sin_q1_minus_q2_1, next[24]),
                    ),
                cos_q2_minus_q3_1
                    .mul_add(
                        cos_q1_minus_q3_last,
                        cos_q2_minus_q3_last.mul_add(cos_q1_minus_q3_1, next[25]),
                    ),
                sin_q1_minus_q2_1
                    .mul_add(
                        u2_sq_last,
                        sin_q1_minus_q2_last.mul_add(u2_sq_1, next[26]),
                    ),
                r6_of_u1_u2_1
                    .mul_add(
                        cos_q1_minus_q3_last,
                        r6_of_u1_u2_last.mul_add(cos_q1_minus_q3_1, next[27]),
                    ),
                sin_q1_minus_q3_1
                    .mul_add(
                        u3_sq_last,
                        sin_q1_minus_q3_last.mul_add(u3_sq_1, next[28]),
                    ),
                (cos_q2_minus_q3_1 + cos_q2_minus_q3_1)
                    .mul_add(cos_q2_minus_q3_last, next[29]),
                sin_q1_minus_q2_1
                    .mul_add(
                        u1_sq_last,
                        sin_q1_minus_q2_last.mul_add(u1_sq_1, next[30]),
                    ),
                r6_of_u1_u2_1
                    .mul_add(
                        cos_q2_minus_q3_last,
                        r6_of_u1_u2_last.mul_add(cos_q2_minus_q3_1, next[31]),
                    ),
                sin_q2_minus_q3_1
                    .mul_add(
                        u3_sq_last,
                        sin_q2_minus_q3_last.mul_add(u3_sq_1, next[32]),
                    ),
                s3_of_place_1
                    .mul_add(
                        l14_of_place_last,
                        s3_of_place_last.mul_add(l14_of_place_1, next[33]),
                    ),
                s4_of_place_1
                    .mul_add(
                        l14_of_place_last,
                        s4_of_place_last.mul_add(l14_of_place_1, next[34]),
                    ),
                s5_of_place_1
                    .mul_add(
                        l14_of_place_last,
                        s5_of_place_last.mul_add(l14_of_place_1, next[35]),
                    ),
                r6_of_u1_u2_u3_1
                    .mul_add(
                        l14_of_place_last,
                        r6_of_u1_u2_u3_last.mul_add(l14_of_place_1, next[36]),
                    ),
                s3_of_place_1
                    .mul_add(
                        l18_of_place_last,
                        s3_of_place_last.mul_add(l18_of_place_1, next[37]),
                    ),
                s5_of_place_1
                    .mul_add(
                        l18_of_place_last,
                        s5_of_place_last.mul_add(l18_of_place_1, next[38]),
                    ),
                r6_of_u1_u2_u3_1
                    .mul_add(
                        l18_of_place_last,
                        r6_of_u1_u2_u3_last.mul_add(l18_of_place_1, next[39]),
                    ),
                s8_minus_s4_l14_1
                    .mul_add(
                        l21_of_place_last,
                        s8_minus_s4_l14_last.mul_add(l21_of_place_1, next[40]),
                    ),
                s9_minus_s5_l14_1
                    .mul_add(
                        l21_of_place_last,
                        s9_minus_s5_l14_last.mul_add(l21_of_place_1, next[41]),
                    ),
                r10_minus_r6_l14_1
                    .mul_add(
                        l21_of_place_last,
                        r10_minus_r6_l14_last.mul_add(l21_of_place_1, next[42]),
                    ),
                s19_minus_s16_l21_1
                    .mul_add(
                        u2_dot_2_last,
                        s19_minus_s16_l21_last.mul_add(u2_dot_2_1, next[43]),
                    ),
                s9_minus_s5_l14_1
                    .mul_add(
                        u2_dot_2_last,
                        s9_minus_s5_l14_last.mul_add(u2_dot_2_1, next[44]),
                    ),
                s8_minus_s4_l14_1
                    .mul_add(
                        u1_dot_2_last,
                        s8_minus_s4_l14_last.mul_add(u1_dot_2_1, next[45]),
                    ),
                s4_of_place_1
                    .mul_add(
                        u1_dot_2_last,
                        s4_of_place_last.mul_add(u1_dot_2_1, next[46]),
                    ),
                s5_of_place_1
                    .mul_add(
                        u2_dot_2_last,
                        s5_of_place_last.mul_add(u2_dot_2_1, next[47]),
                    ),
                s3_of_place_1
                    .mul_add(
                        u0_dot_2_last,
                        s3_of_place_last.mul_add(u0_dot_2_1, next[48]),
                    ),
                cos_q1_minus_q3_1
                    .mul_add(
                        u1_dot_2_last,
                        cos_q1_minus_q3_last.mul_add(u1_dot_2_1, next[49]),
                    ),
                cos_q2_minus_q3_1
                    .mul_add(
                        u2_dot_2_last,
                        cos_q2_minus_q3_last.mul_add(u2_dot_2_1, next[50]),
                    ),
                c3_1.mul_add(u0_dot_2_last, c3_last.mul_add(u0_dot_2_1, next[51])),
            ])
        };
        // s3_2 = sin(q3)
        let s3_2 = q3.mul_add(c3_0, sums[0] * over_k);
        // c3 = cos(q3)
        let c3 = -q3.mul_add(s3_2_0, sums[1] * over_k);
        // c3_sq = c3*c3
        let c3_sq = c3.mul_add(c3_0 + c3_0, sums[2]);
        // s3_of_place = weight + minus_m3_l2_2_by_m3_l2_2*c3_sq
        let s3_of_place = minus_m3_l2_2_by_m3_l2_2 * c3_sq;
        // s1 = sin(q1)
        let s1 = q1.mul_add(c1_0, sums[3] * over_k);
        // c1 = cos(q1)
        let c1 = -q1.mul_add(s1_0, sums[4] * over_k);
        // q1_minus_q3 = q1 - q3
        let q1_minus_q3 = q1 - q3;
        // sin_q1_minus_q3 = sin(q1_minus_q3)
        let sin_q1_minus_q3 = q1_minus_q3.mul_add(cos_q1_minus_q3_0, sums[5] * over_k);
        // cos_q1_minus_q3 = cos(q1_minus_q3)
        let cos_q1_minus_q3 = -q1_minus_q3.mul_add(sin_q1_minus_q3_0, sums[6] * over_k);
        // c3_cos_q1_minus_q3 = cos_q1_minus_q3*c3
        let c3_cos_q1_minus_q3 = cos_q1_minus_q3
            .mul_add(c3_0, c3.mul_add(cos_q1_minus_q3_0, sums[7]));
        // s4_of_place = m1_plus_m2_plus_m3*c1 + minus_m3_l2_2_by_m3_l2_2*c3_cos_q1_minus_q3
        let s4_of_place = c3_cos_q1_minus_q3
            .mul_add(minus_m3_l2_2_by_m3_l2_2, m1_plus_m2_plus_m3 * c1);
        // s2 = sin(q2)
        let s2 = q2.mul_add(c2_0, sums[8] * over_k);
        // c2 = cos(q2)
        let c2 = -q2.mul_add(s2_0, sums[9] * over_k);
        // q2_minus_q3 = q2 - q3
        let q2_minus_q3 = q2 - q3;
        // sin_q2_minus_q3 = sin(q2_minus_q3)
        let sin_q2_minus_q3 = q2_minus_q3.mul_add(cos_q2_minus_q3_0, sums[10] * over_k);
        // cos_q2_minus_q3 = cos(q2_minus_q3)
        let cos_q2_minus_q3 = -q2_minus_q3.mul_add(sin_q2_minus_q3_0, sums[11] * over_k);
        // c3_cos_q2_minus_q3 = cos_q2_minus_q3*c3
        let c3_cos_q2_minus_q3 = cos_q2_minus_q3
            .mul_add(c3_0, c3.mul_add(cos_q2_minus_q3_0, sums[12]));
        // s5_of_place = m2_plus_m3*c2 + minus_m3_l2_2_by_m3_l2_2*c3_cos_q2_minus_q3
        let s5_of_place = c3_cos_q2_minus_q3
            .mul_add(minus_m3_l2_2_by_m3_l2_2, m2_plus_m3 * c2);
        // u1_sq = u1*u1
        let u1_sq = u1.mul_add(u1_0 + u1_0, sums[13]);
        // u1_sq_s1 = s1*u1_sq
        let u1_sq_s1 = u1_sq.mul_add(s1_0, s1.mul_add(u1_sq_0, sums[14]));
        // u2_sq = u2*u2
        let u2_sq = u2.mul_add(u2_0 + u2_0, sums[15]);
        // u2_sq_s2 = s2*u2_sq
        let u2_sq_s2 = u2_sq.mul_add(s2_0, s2.mul_add(u2_sq_0, sums[16]));
        // u1_sq_sin_q1_minus_q3 = sin_q1_minus_q3*u1_sq
        let u1_sq_sin_q1_minus_q3 = sin_q1_minus_q3
            .mul_add(u1_sq_0, u1_sq.mul_add(sin_q1_minus_q3_0, sums[17]));
        // u2_sq_sin_q2_minus_q3 = sin_q2_minus_q3*u2_sq
        let u2_sq_sin_q2_minus_q3 = sin_q2_minus_q3
            .mul_add(u2_sq_0, u2_sq.mul_add(sin_q2_minus_q3_0, sums[18]));
        // r6_of_u1_u2 = l0*u1_sq_sin_q1_minus_q3 + l1*u2_sq_sin_q2_minus_q3 + g*s3_2
        let r6_of_u1_u2 = u2_sq_sin_q2_minus_q3
            .mul_add(l1, u1_sq_sin_q1_minus_q3.mul_add(l0, g * s3_2));
        // u3_sq = u3*u3
        let u3_sq = u3.mul_add(u3_0 + u3_0, sums[19]);
        // u3_sq_s3_2 = s3_2*u3_sq
        let u3_sq_s3_2 = u3_sq.mul_add(s3_2_0, s3_2.mul_add(u3_sq_0, sums[20]));
        // r6_of_u1_u2_2 = r6_of_u1_u2*c3
        let r6_of_u1_u2_2 = r6_of_u1_u2
            .mul_add(c3_0, c3.mul_add(r6_of_u1_u2_0, sums[21]));
        // r6_of_u1_u2_u3 = 11/4 + weight_2*u1_sq_s1 + minus_l1_m2_plus_m3*u2_sq_s2 +
        //   minus_m3_l2*u3_sq_s3_2 + m3_l2_2_by_m3_l2_2*r6_of_u1_u2_2
        let r6_of_u1_u2_u3 = r6_of_u1_u2_2
            .mul_add(
                m3_l2_2_by_m3_l2_2,
                u3_sq_s3_2
                    .mul_add(
                        minus_m3_l2,
                        u2_sq_s2.mul_add(minus_l1_m2_plus_m3, weight_2 * u1_sq_s1),
                    ),
            );
        // cos_q1_minus_q3_sq = cos_q1_minus_q3*cos_q1_minus_q3
        let cos_q1_minus_q3_sq = cos_q1_minus_q3
            .mul_add(cos_q1_minus_q3_0 + cos_q1_minus_q3_0, sums[22]);
        // q1_minus_q2 = q1 - q2
        let q1_minus_q2 = q1 - q2;
        // sin_q1_minus_q2 = sin(q1_minus_q2)
        let sin_q1_minus_q2 = q1_minus_q2.mul_add(cos_q1_minus_q2_0, sums[23] * over_k);
        // cos_q1_minus_q2 = cos(q1_minus_q2)
        let cos_q1_minus_q2 = -q1_minus_q2.mul_add(sin_q1_minus_q2_0, sums[24] * over_k);
        // s9_of_q1_q2_q3 = cos_q2_minus_q3*cos_q1_minus_q3
        let s9_of_q1_q2_q3 = cos_q1_minus_q3
            .mul_add(
                cos_q2_minus_q3_0,
                cos_q2_minus_q3.mul_add(cos_q1_minus_q3_0, sums[25]),
            );
        // u2_sq_sin_q1_minus_q2 = sin_q1_minus_q2*u2_sq
        let u2_sq_sin_q1_minus_q2 = sin_q1_minus_q2
            .mul_add(u2_sq_0, u2_sq.mul_add(sin_q1_minus_q2_0, sums[26]));
        // r10_of_u1_u2 = r6_of_u1_u2*cos_q1_minus_q3
        let r10_of_u1_u2 = r6_of_u1_u2
            .mul_add(
                cos_q1_minus_q3_0,
                cos_q1_minus_q3.mul_add(r6_of_u1_u2_0, sums[27]),
            );
        // u3_sq_sin_q1_minus_q3 = sin_q1_minus_q3*u3_sq
        let u3_sq_sin_q1_minus_q3 = sin_q1_minus_q3
            .mul_add(u3_sq_0, u3_sq.mul_add(sin_q1_minus_q3_0, sums[28]));
        // cos_q2_minus_q3_sq = cos_q2_minus_q3*cos_q2_minus_q3
        let cos_q2_minus_q3_sq = cos_q2_minus_q3
            .mul_add(cos_q2_minus_q3_0 + cos_q2_minus_q3_0, sums[29]);
        // u1_sq_sin_q1_minus_q2 = sin_q1_minus_q2*u1_sq
        let u1_sq_sin_q1_minus_q2 = sin_q1_minus_q2
            .mul_add(u1_sq_0, u1_sq.mul_add(sin_q1_minus_q2_0, sums[30]));
        // r13_of_u1_u2 = r6_of_u1_u2*cos_q2_minus_q3
        let r13_of_u1_u2 = r6_of_u1_u2
            .mul_add(
                cos_q2_minus_q3_0,
                cos_q2_minus_q3.mul_add(r6_of_u1_u2_0, sums[31]),
            );
        // u3_sq_sin_q2_minus_q3 = sin_q2_minus_q3*u3_sq
        let u3_sq_sin_q2_minus_q3 = sin_q2_minus_q3
            .mul_add(u3_sq_0, u3_sq.mul_add(sin_q2_minus_q3_0, sums[32]));
        // l14_of_place = s4_of_place/s3_of_place
        let l14_of_place = s4_of_place
            .mul_add(
                over_s3_of_place,
                -(s3_of_place.mul_add(l14_of_place_0, sums[33]) * over_s3_of_place),
            );
        // s15_of_place = s4_of_place*l14_of_place
        let s15_of_place = l14_of_place
            .mul_add(s4_of_place_0, s4_of_place.mul_add(l14_of_place_0, sums[34]));
        // s8_minus_s4_l14 = l0_2_m1_plus_m2_plus_m3 + minus_l0_2_m3_l2_by_l2*cos_q1_minus_q3_sq +
        //   minus_l0_2*s15_of_place
        let s8_minus_s4_l14 = s15_of_place
            .mul_add(minus_l0_2, minus_l0_2_m3_l2_by_l2 * cos_q1_minus_q3_sq);
        // s16_of_place = s5_of_place*l14_of_place
        let s16_of_place = l14_of_place
            .mul_add(s5_of_place_0, s5_of_place.mul_add(l14_of_place_0, sums[35]));
        // s9_minus_s5_l14 = l0_l1_m2_plus_m3*cos_q1_minus_q2 + minus_l0_l1_m3_l2_by_l2*s9_of_q1_q2_q3 +
        //   minus_l0_l1*s16_of_place
        let s9_minus_s5_l14 = s16_of_place
            .mul_add(
                minus_l0_l1,
                s9_of_q1_q2_q3
                    .mul_add(minus_l0_l1_m3_l2_by_l2, l0_l1_m2_plus_m3 * cos_q1_minus_q2),
            );
        // r17_of_u1_u2_u3 = r6_of_u1_u2_u3*l14_of_place
        let r17_of_u1_u2_u3 = r6_of_u1_u2_u3
            .mul_add(l14_of_place_0, l14_of_place.mul_add(r6_of_u1_u2_u3_0, sums[36]));
        // r10_minus_r6_l14 = minus_l0_l1_m2_plus_m3*u2_sq_sin_q1_minus_q2 + l0_g_m1_plus_m2_plus_m3*s1 +
        //   minus_l0_m3_l2_by_l2*r10_of_u1_u2 + minus_l0_m3_l2*u3_sq_sin_q1_minus_q3 + l0*r17_of_u1_u2_u3
        let r10_minus_r6_l14 = r17_of_u1_u2_u3
            .mul_add(
                l0,
                r10_of_u1_u2
                    .mul_add(
                        minus_l0_m3_l2_by_l2,
                        u3_sq_sin_q1_minus_q3
                            .mul_add(
                                minus_l0_m3_l2,
                                u2_sq_sin_q1_minus_q2
                                    .mul_add(
                                        minus_l0_l1_m2_plus_m3,
                                        l0_g_m1_plus_m2_plus_m3 * s1,
                                    ),
                            ),
                    ),
            );
        // l18_of_place = s5_of_place/s3_of_place
        let l18_of_place = s5_of_place
            .mul_add(
                over_s3_of_place,
                -(s3_of_place.mul_add(l18_of_place_0, sums[37]) * over_s3_of_place),
            );
        // s19_of_place = s5_of_place*l18_of_place
        let s19_of_place = l18_of_place
            .mul_add(s5_of_place_0, s5_of_place.mul_add(l18_of_place_0, sums[38]));
        // r20_of_u1_u2_u3 = r6_of_u1_u2_u3*l18_of_place
        let r20_of_u1_u2_u3 = r6_of_u1_u2_u3
            .mul_add(l18_of_place_0, l18_of_place.mul_add(r6_of_u1_u2_u3_0, sums[39]));
        // l21_of_place = s9_minus_s5_l14/s8_minus_s4_l14
        let l21_of_place = s8_minus_s4_l14
            .mul_add(
                -(l21_of_place_0 * over_s8_minus_s4_l14),
                (s9_minus_s5_l14 - sums[40]) * over_s8_minus_s4_l14,
            );
        // s22_of_place = s9_minus_s5_l14*l21_of_place
        let s22_of_place = l21_of_place
            .mul_add(
                s9_minus_s5_l14_0,
                s9_minus_s5_l14.mul_add(l21_of_place_0, sums[41]),
            );
        // s19_minus_s16_l21 = l1_2_m2_plus_m3 + minus_l1_2_m3_l2_by_l2*cos_q2_minus_q3_sq +
        //   minus_l1_2*s19_of_place - s22_of_place
        let s19_minus_s16_l21 = s19_of_place
            .mul_add(minus_l1_2, minus_l1_2_m3_l2_by_l2 * cos_q2_minus_q3_sq) - s22_of_place;
        // r23_of_place = r10_minus_r6_l14*l21_of_place
        let r23_of_place = l21_of_place
            .mul_add(
                r10_minus_r6_l14_0,
                r10_minus_r6_l14.mul_add(l21_of_place_0, sums[42]),
            );
        // r20_minus_r17_l21 = l0_l1_m2_plus_m3*u1_sq_sin_q1_minus_q2 + l1_g_m2_plus_m3*s2 +
        //   minus_l1_m3_l2_by_l2*r13_of_u1_u2 + minus_l1_m3_l2*u3_sq_sin_q2_minus_q3 + l1*r20_of_u1_u2_u3 -
        //   r23_of_place
        let r20_minus_r17_l21 = r20_of_u1_u2_u3
            .mul_add(
                l1,
                r13_of_u1_u2
                    .mul_add(
                        minus_l1_m3_l2_by_l2,
                        u3_sq_sin_q2_minus_q3
                            .mul_add(
                                minus_l1_m3_l2,
                                u1_sq_sin_q1_minus_q2
                                    .mul_add(l0_l1_m2_plus_m3, l1_g_m2_plus_m3 * s2),
                            ),
                    ),
            ) - r23_of_place;
        // u2_dot_2 = r20_minus_r17_l21/s19_minus_s16_l21
        let u2_dot_2 = s19_minus_s16_l21
            .mul_add(
                -(u2_dot_2_0 * over_s19_minus_s16_l21),
                (r20_minus_r17_l21 - sums[43]) * over_s19_minus_s16_l21,
            );
        // u0_dot_of_place = s9_minus_s5_l14*u2_dot_2
        let u0_dot_of_place = u2_dot_2
            .mul_add(s9_minus_s5_l14_0, s9_minus_s5_l14.mul_add(u2_dot_2_0, sums[44]));
        // u0_dot_of_place_2 = r10_minus_r6_l14 - u0_dot_of_place
        let u0_dot_of_place_2 = r10_minus_r6_l14 - u0_dot_of_place;
        // u1_dot_2 = u0_dot_of_place_2/s8_minus_s4_l14
        let u1_dot_2 = u0_dot_of_place_2
            .mul_add(
                over_s8_minus_s4_l14,
                -(s8_minus_s4_l14.mul_add(u1_dot_2_0, sums[45]) * over_s8_minus_s4_l14),
            );
        // u0_dot_of_place_3 = s4_of_place*u1_dot_2
        let u0_dot_of_place_3 = u1_dot_2
            .mul_add(s4_of_place_0, s4_of_place.mul_add(u1_dot_2_0, sums[46]));
        // u0_dot_of_place_4 = s5_of_place*u2_dot_2
        let u0_dot_of_place_4 = u2_dot_2
            .mul_add(s5_of_place_0, s5_of_place.mul_add(u2_dot_2_0, sums[47]));
        // u0_dot_of_place_5 = r6_of_u1_u2_u3 + l0*u0_dot_of_place_3 + l1*u0_dot_of_place_4
        let u0_dot_of_place_5 = u0_dot_of_place_3
            .mul_add(l0, u0_dot_of_place_4.mul_add(l1, r6_of_u1_u2_u3));
        // u0_dot_2 = u0_dot_of_place_5/s3_of_place
        let u0_dot_2 = u0_dot_of_place_5
            .mul_add(
                over_s3_of_place,
                -(s3_of_place.mul_add(u0_dot_2_0, sums[48]) * over_s3_of_place),
            );
        // u3_dot_of_place = cos_q1_minus_q3*u1_dot_2
        let u3_dot_of_place = u1_dot_2
            .mul_add(cos_q1_minus_q3_0, cos_q1_minus_q3.mul_add(u1_dot_2_0, sums[49]));
        // u3_dot_of_place_2 = cos_q2_minus_q3*u2_dot_2
        let u3_dot_of_place_2 = u2_dot_2
            .mul_add(cos_q2_minus_q3_0, cos_q2_minus_q3.mul_add(u2_dot_2_0, sums[50]));
        // u3_dot_of_place_3 = c3*u0_dot_2
        let u3_dot_of_place_3 = u0_dot_2.mul_add(c3_0, c3.mul_add(u0_dot_2_0, sums[51]));
        // u3_dot_of_u1_u2 = g*s3_2 + l0*u1_sq_sin_q1_minus_q3 + minus_l0*u3_dot_of_place +
        //   l1*u2_sq_sin_q2_minus_q3 + minus_l1*u3_dot_of_place_2 + u3_dot_of_place_3
        let u3_dot_of_u1_u2 = u3_dot_of_place
            .mul_add(
                minus_l0,
                u3_dot_of_place_2
                    .mul_add(
                        minus_l1,
                        u2_sq_sin_q2_minus_q3
                            .mul_add(l1, u1_sq_sin_q1_minus_q3.mul_add(l0, g * s3_2)),
                    ),
            ) + u3_dot_of_place_3;
        q1_rate = u1;
        q2_rate = u2;
        q3_rate = u3;
        q0_rate = u0;
        u1_rate = u1_dot_2;
        u2_rate = u2_dot_2;
        u3_rate = weight_3 * u3_dot_of_u1_u2;
        u0_rate = u0_dot_2;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * q3,
                count * q3,
                c3,
                count * q1,
                count * q1,
                count * q1_minus_q3,
                count * q1_minus_q3,
                cos_q1_minus_q3,
                count * q2,
                count * q2,
                count * q2_minus_q3,
                count * q2_minus_q3,
                cos_q2_minus_q3, u1, s1, u2, s2, sin_q1_minus_q3, sin_q2_minus_q3, u3, s3_2,
                r6_of_u1_u2, cos_q1_minus_q3,
                count * q1_minus_q2,
                count * q1_minus_q2,
                cos_q2_minus_q3, sin_q1_minus_q2, r6_of_u1_u2, sin_q1_minus_q3, cos_q2_minus_q3,
                sin_q1_minus_q2, r6_of_u1_u2, sin_q2_minus_q3, s3_of_place, s4_of_place,
                s5_of_place, r6_of_u1_u2_u3, s3_of_place, s5_of_place, r6_of_u1_u2_u3,
                s8_minus_s4_l14, s9_minus_s5_l14, r10_minus_r6_l14, s19_minus_s16_l21,
                s9_minus_s5_l14, s8_minus_s4_l14, s4_of_place, s5_of_place, s3_of_place,
                cos_q1_minus_q3, cos_q2_minus_q3, c3,
            ]),
            padded([
                c3, s3_2, c3, c1, s1, cos_q1_minus_q3, sin_q1_minus_q3, c3, c2, s2, cos_q2_minus_q3,
                sin_q2_minus_q3, c3, u1, u1_sq, u2, u2_sq, u1_sq, u2_sq, u3, u3_sq, c3,
                cos_q1_minus_q3, cos_q1_minus_q2, sin_q1_minus_q2, cos_q1_minus_q3, u2_sq,
                cos_q1_minus_q3, u3_sq, cos_q2_minus_q3, u1_sq, cos_q2_minus_q3, u3_sq,
                l14_of_place, l14_of_place, l14_of_place, l14_of_place, l18_of_place, l18_of_place,
                l18_of_place, l21_of_place, l21_of_place, l21_of_place, u2_dot_2, u2_dot_2,
                u1_dot_2, u1_dot_2, u2_dot_2, u0_dot_2, u1_dot_2, u2_dot_2, u0_dot_2,
            ]),
        ];
        count_last = count;
        q1_last = q1;
        q2_last = q2;
        q3_last = q3;
        u1_last = u1;
        u2_last = u2;
        u3_last = u3;
        s3_2_last = s3_2;
        c3_last = c3;
        s3_of_place_last = s3_of_place;
        s1_last = s1;
        c1_last = c1;
        q1_minus_q3_last = q1_minus_q3;
        sin_q1_minus_q3_last = sin_q1_minus_q3;
        cos_q1_minus_q3_last = cos_q1_minus_q3;
        s4_of_place_last = s4_of_place;
        s2_last = s2;
        c2_last = c2;
        q2_minus_q3_last = q2_minus_q3;
        sin_q2_minus_q3_last = sin_q2_minus_q3;
        cos_q2_minus_q3_last = cos_q2_minus_q3;
        s5_of_place_last = s5_of_place;
        u1_sq_last = u1_sq;
        u2_sq_last = u2_sq;
        r6_of_u1_u2_last = r6_of_u1_u2;
        u3_sq_last = u3_sq;
        r6_of_u1_u2_u3_last = r6_of_u1_u2_u3;
        q1_minus_q2_last = q1_minus_q2;
        sin_q1_minus_q2_last = sin_q1_minus_q2;
        cos_q1_minus_q2_last = cos_q1_minus_q2;
        l14_of_place_last = l14_of_place;
        s8_minus_s4_l14_last = s8_minus_s4_l14;
        s9_minus_s5_l14_last = s9_minus_s5_l14;
        r10_minus_r6_l14_last = r10_minus_r6_l14;
        l18_of_place_last = l18_of_place;
        l21_of_place_last = l21_of_place;
        s19_minus_s16_l21_last = s19_minus_s16_l21;
        u2_dot_2_last = u2_dot_2;
        u1_dot_2_last = u1_dot_2;
        u0_dot_2_last = u0_dot_2;
    }
}

/// Reduced equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Reduced;

impl<S: Scalar> System<S> for Reduced {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 9,
            coordinates: 4,
            variables: 4,
            speeds: 4,
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
        8
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
        112 * order + SLACK
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
    name: "fall",
    key: "7876eff3d59e7a8e",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: None,
    },
};
