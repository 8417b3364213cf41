//! Three-link pendulum on a cart: Three links fall over while the cart is pushed.
//!
//! Generated from `models/cart_pendulum_3/scenes/fall.toml`. Do not edit; run `tripos regenerate`.

use tripos_traits::{
    CompiledScene, CompiledSystem, Derivative, Dual, InLanes, Lengths, Scalar, System,
    by_columns,
};

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

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    u: &[S; 4],
    direction: &[S; 8],
) -> [S; 8] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[4 + i],
    });
    let (of_q, of_v) = derivative(&p, &q, &v);
    let mut slopes = of_q.into_iter().chain(of_v).map(|rate| rate.slope);
    core::array::from_fn(|_| {
        slopes.next().expect("a slope for each component of the state")
    })
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

/// What a program needs to find these equations and to trust them.
pub const SCENE: CompiledScene = CompiledScene {
    name: "fall",
    key: "7876eff3d59e7a8e",
    system: CompiledSystem {
        name: "reduced",
        double: &Reduced,
        extended: &Reduced,
        lanes: Some(InLanes::of_rates(&Derivative(Reduced))),
    },
};
