//! Symmetric heavy top about a fixed point: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/heavy_top/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows q1, q2, q3.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    _q_dot: &[S; 3],
) -> [[S; 3]; 3] {
    let Parameters { I1, I3, .. } = *p;
    let [_, q2, _] = *q;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    let i3_s2 = I3 * s2;
    // Entries that are not zero; upper triangle.
    // M11 = I3*sin(q2)^2 + I1*cos(q2)^2
    let m11 = i3_s2.mul_add(s2, I1 * c2 * c2);
    // M13 = I3*sin(q2)
    let m13 = i3_s2;
    // M22 = I1
    let m22 = I1;
    // M33 = I3
    let m33 = I3;
    let zero = S::int(0);
    [[m11, zero, m13], [zero, m22, zero], [m13, zero, m33]]
}

/// Right-hand side of the linear system; unknowns (q1'', q2'', q3'').
///
/// 23 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], q_dot: &[S; 3]) -> [S; 3] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [q1, q2, _] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let q1_dot_c2 = q1_dot * c2;
    // q1_dot_c2*sin(q2)*(I3 - I1)
    let f1_of_q1_dot = q1_dot_c2 * s2 * (I3 - I1);
    let i3_q2_dot = I3 * q2_dot;
    let m_l_g = m * l * g;
    // Values.
    // f1 = cos(q2)*(m*l*g*sin(q1) - q2'*(I3*(2*q1'*sin(q2) + q3') - 2*I1*q1'*sin(q2)))
    let f1 = c2 * (-q3_dot).mul_add(i3_q2_dot, m_l_g * s1) - S::int(2) * q2_dot * f1_of_q1_dot;
    // f2 = m*l*g*cos(q1)*sin(q2) + q1'*cos(q2)*(I3*(q1'*sin(q2) + q3') - I1*q1'*sin(q2))
    let f2 = q1_dot.mul_add(f1_of_q1_dot, I3 * q3_dot * q1_dot_c2) + m_l_g * c1 * s2;
    // f3 = -I3*q1'*q2'*cos(q2)
    let f3 = -q1_dot_c2 * i3_q2_dot;
    [f1, f2, f3]
}

/// The accelerations (q1'', q2'', q3''), solved for when this code was generated.
///
/// 25 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 3] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [q1, q2, _] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let q1_dot_s2 = q1_dot * s2;
    // I3*(q3' + q1_dot_s2)
    let q1_ddot_of_motion = I3 * (q3_dot + q1_dot_s2);
    let i1_q1_dot_s2 = I1 * q1_dot_s2;
    let m_l_g = m * l * g;
    let i1_inv = S::int(1) / I1;
    // q1'' = (m*l*g*sin(q1) + q2'*(2*I1*q1'*sin(q2) - I3*(q1'*sin(q2) + q3')))/(I1*cos(q2))
    let q1_ddot = i1_inv
        * (-q2_dot * (-i1_q1_dot_s2).mul_add(S::int(2), q1_ddot_of_motion) + m_l_g * s1) / c2;
    let q1_dot_c2 = q1_dot * c2;
    // q3'' = -q1'*q2'*cos(q2) - q1''*sin(q2)
    let q3_ddot = (-q2_dot).mul_add(q1_dot_c2, -q1_ddot * s2);
    // q2'' = (m*l*g*cos(q1)*sin(q2) + q1'*cos(q2)*(I3*(q1'*sin(q2) + q3') - I1*q1'*sin(q2)))/I1
    let q2_ddot = i1_inv * (q1_dot_c2 * (q1_ddot_of_motion - i1_q1_dot_s2) + m_l_g * c1 * s2);
    [q1_ddot, q2_ddot, q3_ddot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 3] {
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Values.
    // q1'
    let q1_dot_value = q1_dot;
    // q2'
    let q2_dot_value = q2_dot;
    // q3'
    let q3_dot_value = q3_dot;
    [q1_dot_value, q2_dot_value, q3_dot_value]
}

/// Kinetic energy T.
///
/// 16 operations, 1 sine and cosine.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3], q_dot: &[S; 3]) -> S {
    let Parameters { I1, I3, .. } = *p;
    let [_, q2, _] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    let i3_q3_dot = I3 * q3_dot;
    // q1'^2*(I3 + cos(q2)^2*(I1 - I3)) + I1*q2'^2
    let energy_of_motion = q1_dot * q1_dot * (I3 + c2 * c2 * (I1 - I3)) + I1 * q2_dot * q2_dot;
    // q3'*i3_q3_dot + energy_of_motion
    let energy_of_motion_2 = q3_dot.mul_add(i3_q3_dot, energy_of_motion);
    // Values.
    // T = q1'^2*(I3*sin(q2)^2 + I1*cos(q2)^2)/2 + I1*q2'^2/2 + I3*q3'^2/2 + I3*q1'*q3'*sin(q2)
    let energy = (q1_dot * i3_q3_dot).mul_add(s2, S::ratio(1, 2) * energy_of_motion_2);
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> [S; 3] {
    let [_, q2, _] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Values.
    // u1 = q1'*cos(q2)
    let u1_value = q1_dot * c2;
    // u2 = q2'
    let u2_value = q2_dot;
    // u3 = q1'*sin(q2) + q3'
    let u3_value = q1_dot.mul_add(s2, q3_dot);
    [u1_value, u2_value, u3_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 8 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
    v_dot: &[S; 3],
) -> [S; 3] {
    let [_, q2, _] = *q;
    let [q1_dot, q2_dot, _] = *q_dot;
    let [q1_ddot, q2_ddot, q3_ddot] = *v_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    let q1_dot_q2_dot = q1_dot * q2_dot;
    // Values.
    // u1' = q1''*cos(q2) - q1'*q2'*sin(q2)
    let u1_dot_value = (-q1_dot_q2_dot).mul_add(s2, q1_ddot * c2);
    // u2' = q2''
    let u2_dot_value = q2_ddot;
    // u3' = q1'*q2'*cos(q2) + q1''*sin(q2) + q3''
    let u3_dot_value = q1_ddot.mul_add(s2, q3_ddot) + q1_dot_q2_dot * c2;
    [u1_dot_value, u2_dot_value, u3_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn motion_variables<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 3],
) -> [S; 3] {
    let [_, q2, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
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

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 25 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> ([S; 3], [S; 3]) {
    let Parameters { m, l, I1, I3, g } = *p;
    let [q1, q2, _] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let q1_dot_s2 = q1_dot * s2;
    // I3*(q3' + q1_dot_s2)
    let q1_ddot_of_motion = I3 * (q3_dot + q1_dot_s2);
    let i1_q1_dot_s2 = I1 * q1_dot_s2;
    let m_l_g = m * l * g;
    let i1_inv = S::int(1) / I1;
    // q1'' = (m*l*g*sin(q1) + q2'*(2*I1*q1'*sin(q2) - I3*(q1'*sin(q2) + q3')))/(I1*cos(q2))
    let q1_ddot = i1_inv
        * (-q2_dot * (-i1_q1_dot_s2).mul_add(S::int(2), q1_ddot_of_motion) + m_l_g * s1) / c2;
    let q1_dot_c2 = q1_dot * c2;
    // q3'' = -q1'*q2'*cos(q2) - q1''*sin(q2)
    let q3_ddot = (-q2_dot).mul_add(q1_dot_c2, -q1_ddot * s2);
    // q2'' = (m*l*g*cos(q1)*sin(q2) + q1'*cos(q2)*(I3*(q1'*sin(q2) + q3') - I1*q1'*sin(q2)))/I1
    let q2_ddot = i1_inv * (q1_dot_c2 * (q1_ddot_of_motion - i1_q1_dot_s2) + m_l_g * c1 * s2);
    // Values.
    // q1'
    let q1_dot_value = q1_dot;
    // q2'
    let q2_dot_value = q2_dot;
    // q3'
    let q3_dot_value = q3_dot;
    ([q1_dot_value, q2_dot_value, q3_dot_value], [q1_ddot, q2_ddot, q3_ddot])
}

/// Jacobian of the derivative by the state; columns q1, q2, q3, q1', q2', q3'.
///
/// 64 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
) -> [[S; 6]; 6] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [q1, q2, _] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let c2_inv = S::int(1) / c2;
    let q2_dot_c2_inv = q2_dot * c2_inv;
    let i1_inv = S::int(1) / I1;
    let i3_i1_inv = I3 * i1_inv;
    let q3_dot_i3_i1_inv = q3_dot * i3_i1_inv;
    let q1_dot_s2 = q1_dot * s2;
    let q1_dot_s2_doubled = S::int(2) * q1_dot_s2;
    // q3_dot_i3_i1_inv - q1_dot_s2_doubled
    let q1_ddot_of_motion = q3_dot_i3_i1_inv - q1_dot_s2_doubled;
    // i3_i1_inv*q1_dot_s2 + q1_ddot_of_motion
    let q1_ddot_of_motion_2 = i3_i1_inv.mul_add(q1_dot_s2, q1_ddot_of_motion);
    let m_l_g_i1_inv = m * l * g * i1_inv;
    let c2_inv_m_l_g_i1_inv = c2_inv * m_l_g_i1_inv;
    // q1'' = (m*l*g*sin(q1) + q2'*(2*I1*q1'*sin(q2) - I3*(q1'*sin(q2) + q3')))/(I1*cos(q2))
    let q1_ddot = (-q2_dot_c2_inv)
        .mul_add(q1_ddot_of_motion_2, c2_inv_m_l_g_i1_inv * s1);
    // q1_ddot_by_q1 = m*l*g*cos(q1)/(I1*cos(q2))
    let q1_ddot_by_q1 = c2_inv_m_l_g_i1_inv * c1;
    let s2_s1 = s1 * s2;
    // q2_ddot_by_q1 = -m*l*g*sin(q1)*sin(q2)/I1
    let q2_ddot_by_q1 = -m_l_g_i1_inv * s2_s1;
    // 2 - i3_i1_inv
    let q1_ddot_by_q2_of_i1_i3 = S::int(2) - i3_i1_inv;
    // q1_ddot_by_q2 = (2*q1'*q2' + (m*l*g*sin(q1)*sin(q2) - I3*q2'*(q1' + q3'*sin(q2)))/I1)/cos(q2)^2
    let q1_ddot_by_q2 = c2_inv
        * (q2_dot_c2_inv * (-q3_dot_i3_i1_inv).mul_add(s2, q1_dot * q1_ddot_by_q2_of_i1_i3)
            + c2_inv_m_l_g_i1_inv * s2_s1);
    // q3_ddot_by_q2 = sin(q2)*(q1'*q2' - q1_ddot_by_q2) - q1''*cos(q2)
    let q3_ddot_by_q2 = (-q1_ddot).mul_add(c2, q2_dot * q1_dot_s2) - q1_ddot_by_q2 * s2;
    // i3_i1_inv*q1_dot_s2_doubled + q1_ddot_of_motion
    let q2_ddot_by_q2_of_motion = i3_i1_inv
        .mul_add(q1_dot_s2_doubled, q1_ddot_of_motion);
    let q1_dot_sq = q1_dot * q1_dot;
    // q2_ddot_by_q2 = m*l*g*cos(q1)*cos(q2)/I1 - q1'*(q1'*(cos(q2)^2 - sin(q2)^2 + I3*(sin(q2)^2 -
    //   cos(q2)^2)/I1) + I3*q3'*sin(q2)/I1)
    let q2_ddot_by_q2 = (-q1_dot_s2)
        .mul_add(q2_ddot_by_q2_of_motion, m_l_g_i1_inv * c1 * c2) - q1_dot_sq
        + i3_i1_inv * q1_dot_sq;
    // q1_ddot_by_q1_dot = q2'*tan(q2)*(2 - I3/I1)
    let q1_ddot_by_q1_dot = q2_dot_c2_inv * q1_ddot_by_q2_of_i1_i3 * s2;
    // q3_ddot_by_q1_dot = -q2'*cos(q2) - q1_ddot_by_q1_dot*sin(q2)
    let q3_ddot_by_q1_dot = (-q1_ddot_by_q1_dot).mul_add(s2, -q2_dot * c2);
    // q2_ddot_by_q1_dot = cos(q2)*(I3*(2*q1'*sin(q2) + q3')/I1 - 2*q1'*sin(q2))
    let q2_ddot_by_q1_dot = q2_ddot_by_q2_of_motion * c2;
    // q1_ddot_by_q2_dot = (2*q1'*sin(q2) - I3*(q1'*sin(q2) + q3')/I1)/cos(q2)
    let q1_ddot_by_q2_dot = -c2_inv * q1_ddot_of_motion_2;
    let q1_dot_c2 = q1_dot * c2;
    // q3_ddot_by_q2_dot = -q1'*cos(q2) - q1_ddot_by_q2_dot*sin(q2)
    let q3_ddot_by_q2_dot = (-q1_ddot_by_q2_dot).mul_add(s2, -q1_dot_c2);
    // q1_ddot_by_q3_dot = -I3*q2'/(I1*cos(q2))
    let q1_ddot_by_q3_dot = -q2_dot_c2_inv * i3_i1_inv;
    // q2_ddot_by_q3_dot = I3*q1'*cos(q2)/I1
    let q2_ddot_by_q3_dot = i3_i1_inv * q1_dot_c2;
    // Entries that are not zero.
    // d(q1')/d(q1') = 1
    let q1_dot_by_q1_dot_value = S::int(1);
    // d(q2')/d(q2') = 1
    let q2_dot_by_q2_dot_value = S::int(1);
    // d(q3')/d(q3') = 1
    let q3_dot_by_q3_dot_value = S::int(1);
    // d(q3'')/d(q1) = -q1_ddot_by_q1*sin(q2)
    let q3_ddot_by_q1_value = -q1_ddot_by_q1 * s2;
    // d(q3'')/d(q3') = -q1_ddot_by_q3_dot*sin(q2)
    let q3_ddot_by_q3_dot_value = -q1_ddot_by_q3_dot * s2;
    let zero = S::int(0);
    [
        [zero, zero, zero, q1_dot_by_q1_dot_value, zero, zero],
        [zero, zero, zero, zero, q2_dot_by_q2_dot_value, zero],
        [zero, zero, zero, zero, zero, q3_dot_by_q3_dot_value],
        [
            q1_ddot_by_q1, q1_ddot_by_q2, zero, q1_ddot_by_q1_dot, q1_ddot_by_q2_dot,
            q1_ddot_by_q3_dot,
        ],
        [q2_ddot_by_q1, q2_ddot_by_q2, zero, q2_ddot_by_q1_dot, zero, q2_ddot_by_q3_dot],
        [
            q3_ddot_by_q1_value, q3_ddot_by_q2, zero, q3_ddot_by_q1_dot, q3_ddot_by_q2_dot,
            q3_ddot_by_q3_dot_value,
        ],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 3], _q_dot: &[S; 3]) -> [S; 1] {
    let [_, q2, _] = *q;
    // Sines and cosines.
    let (_, c2) = q2.sin_cos();
    // Values.
    // divisor1 = cos(q2)
    let divisor1 = c2;
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (q1', q2', q3') that must act beside the loads of the model for the accelerations to be (q1'', q2'', q3'').
///
/// 33 operations, 2 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    q_dot: &[S; 3],
    v_dot: &[S; 3],
) -> [S; 3] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [q1, q2, _] = *q;
    let [q1_dot, q2_dot, q3_dot] = *q_dot;
    let [q1_ddot, q2_ddot, q3_ddot] = *v_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    // I3*(q1''*sin(q2) + q3'')
    let tau1_of_motion = I3 * q1_ddot.mul_add(s2, q3_ddot);
    let q1_dot_c2 = q1_dot * c2;
    // q1_dot_c2*sin(q2)*(I3 - I1)
    let tau1_of_q1_dot = q1_dot_c2 * s2 * (I3 - I1);
    let m_l_g = m * l * g;
    let i3_q2_dot = I3 * q2_dot;
    // I1*q1''*cos(q2) + q3'*i3_q2_dot
    let tau1_of_motion_2 = q3_dot.mul_add(i3_q2_dot, I1 * q1_ddot * c2);
    // Values.
    // tau1 = cos(q2)*(q2'*(I3*(2*q1'*sin(q2) + q3') - 2*I1*q1'*sin(q2)) - m*l*g*sin(q1)) +
    //   q1''*(I3*sin(q2)^2 + I1*cos(q2)^2) + I3*q3''*sin(q2)
    let tau1 = tau1_of_motion * s2 + S::int(2) * q2_dot * tau1_of_q1_dot
        + c2 * (-m_l_g).mul_add(s1, tau1_of_motion_2);
    // tau2 = q1'*cos(q2)*(I1*q1'*sin(q2) - I3*(q1'*sin(q2) + q3')) - m*l*g*cos(q1)*sin(q2) + I1*q2''
    let tau2 = (-(I3 * q3_dot)).mul_add(q1_dot_c2, I1 * q2_ddot)
        - q1_dot * tau1_of_q1_dot - m_l_g * c1 * s2;
    // tau3 = I3*q1'*q2'*cos(q2) + I3*q1''*sin(q2) + I3*q3''
    let tau3 = q1_dot_c2.mul_add(i3_q2_dot, tau1_of_motion);
    [tau1, tau2, tau3]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 12 convolutions and 20 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 6]],
    history: &mut [Factors<S, 16>],
) {
    let Parameters { m, l, I1, I3, g } = *p;
    let [q1_0, q2_0, _, q1_dot_0, q2_dot_0, q3_dot_0] = series[0];
    // Shared terms.
    let i1_inv_i3 = I3 / I1;
    // Constant in time.
    // i3_by_i1 = I3/I1
    let i3_by_i1 = i1_inv_i3;
    // i3_by_i1_minus_2 = I3/I1 - 2
    let i3_by_i1_minus_2 = i1_inv_i3 - S::int(2);
    // m_l_g_by_i1 = m*l*g/I1
    let m_l_g_by_i1 = m * l * g / I1;
    // i3_by_i1_minus_1 = I3/I1 - 1
    let i3_by_i1_minus_1 = i1_inv_i3 - S::int(1);
    // Order 0.
    let (s2_0, c2_0) = q2_0.sin_cos();
    let over_c2 = S::int(1) / c2_0;
    let (s1_0, c1_0) = q1_0.sin_cos();
    let q1_dot_s2_0 = q1_dot_0 * s2_0;
    let q1_ddot_of_motion_0 = q1_dot_s2_0.mul_add(i3_by_i1_minus_2, i3_by_i1 * q3_dot_0);
    let q1_ddot_of_motion_2_0 = q2_dot_0 * q1_ddot_of_motion_0;
    let q1_ddot_of_motion_3_0 = m_l_g_by_i1 * s1_0 - q1_ddot_of_motion_2_0;
    let q1_dot_dot_0 = q1_ddot_of_motion_3_0 * over_c2;
    let q3_ddot_of_motion_0 = s2_0 * q1_dot_dot_0;
    let q1_dot_c2_0 = q1_dot_0 * c2_0;
    let q1_dot_q2_dot_c2_0 = q2_dot_0 * q1_dot_c2_0;
    let q3_dot_dot_0 = -q1_dot_q2_dot_c2_0 - q3_ddot_of_motion_0;
    let s2_c1_0 = s2_0 * c1_0;
    let q2_ddot_of_motion_0 = q1_dot_s2_0.mul_add(i3_by_i1_minus_1, i3_by_i1 * q3_dot_0);
    let q2_ddot_of_motion_2_0 = q2_ddot_of_motion_0 * q1_dot_c2_0;
    let q2_dot_dot_0 = m_l_g_by_i1 * s2_c1_0 + q2_ddot_of_motion_2_0;
    // Order 1: the rates, and what follows from them.
    let q1_1 = q1_dot_0;
    let q2_1 = q2_dot_0;
    let q3_1 = q3_dot_0;
    let q1_dot_1 = q1_dot_dot_0;
    let q2_dot_1 = q2_dot_dot_0;
    let q3_dot_1 = q3_dot_dot_0;
    if series.len() > 1 {
        series[1] = [q1_1, q2_1, q3_1, q1_dot_1, q2_dot_1, q3_dot_1];
    }
    let s2_1 = q2_1 * c2_0;
    let c2_1 = -q2_1 * s2_0;
    let s1_1 = q1_1 * c1_0;
    let c1_1 = -q1_1 * s1_0;
    let q1_dot_s2_1 = s2_1.mul_add(q1_dot_0, q1_dot_1 * s2_0);
    let q1_ddot_of_motion_1 = q1_dot_s2_1.mul_add(i3_by_i1_minus_2, i3_by_i1 * q3_dot_1);
    let q1_ddot_of_motion_2_1 = q1_ddot_of_motion_1
        .mul_add(q2_dot_0, q2_dot_1 * q1_ddot_of_motion_0);
    let q1_ddot_of_motion_3_1 = m_l_g_by_i1 * s1_1 - q1_ddot_of_motion_2_1;
    let q1_dot_dot_1 = c2_1
        .mul_add(-(q1_dot_dot_0 * over_c2), q1_ddot_of_motion_3_1 * over_c2);
    let q3_ddot_of_motion_1 = q1_dot_dot_1.mul_add(s2_0, s2_1 * q1_dot_dot_0);
    let q1_dot_c2_1 = c2_1.mul_add(q1_dot_0, q1_dot_1 * c2_0);
    let q1_dot_q2_dot_c2_1 = q1_dot_c2_1.mul_add(q2_dot_0, q2_dot_1 * q1_dot_c2_0);
    let q3_dot_dot_1 = -q1_dot_q2_dot_c2_1 - q3_ddot_of_motion_1;
    let s2_c1_1 = c1_1.mul_add(s2_0, s2_1 * c1_0);
    let q2_ddot_of_motion_1 = q1_dot_s2_1.mul_add(i3_by_i1_minus_1, i3_by_i1 * q3_dot_1);
    let q2_ddot_of_motion_2_1 = q2_ddot_of_motion_1
        .mul_add(q1_dot_c2_0, q1_dot_c2_1 * q2_ddot_of_motion_0);
    let q2_dot_dot_1 = m_l_g_by_i1 * s2_c1_1 + q2_ddot_of_motion_2_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                q2_1, q2_1, q1_1, q1_1, q1_dot_1, q2_dot_1, c2_1, s2_1, q1_dot_1, q2_dot_1, s2_1,
                q2_ddot_of_motion_1,
            ]),
            padded([
                c2_1, s2_1, c1_1, s1_1, s2_1, q1_ddot_of_motion_1, q1_dot_dot_1, q1_dot_dot_1, c2_1,
                q1_dot_c2_1, c1_1, q1_dot_c2_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q1_last = q1_1;
    let mut q2_last = q2_1;
    let mut q1_dot_last = q1_dot_1;
    let mut q2_dot_last = q2_dot_1;
    let mut s2_last = s2_1;
    let mut c2_last = c2_1;
    let mut s1_last = s1_1;
    let mut c1_last = c1_1;
    let mut q1_ddot_of_motion_last = q1_ddot_of_motion_1;
    let mut q1_dot_dot_last = q1_dot_dot_1;
    let mut q1_dot_c2_last = q1_dot_c2_1;
    let mut q2_ddot_of_motion_last = q2_ddot_of_motion_1;
    let mut next = [S::int(0); 16];
    // Rates at order k - 1.
    let mut q1_rate = q1_dot_1;
    let mut q2_rate = q2_dot_1;
    let mut q3_rate = q3_dot_1;
    let mut q1_dot_rate = q1_dot_dot_1;
    let mut q2_dot_rate = q2_dot_dot_1;
    let mut q3_dot_rate = q3_dot_dot_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q1 = q1_rate * over_k;
        let q2 = q2_rate * over_k;
        let q3 = q3_rate * over_k;
        let q1_dot = q1_dot_rate * over_k;
        let q2_dot = q2_dot_rate * over_k;
        let q3_dot = q3_dot_rate * over_k;
        series[order] = [q1, q2, q3, q1_dot, q2_dot, q3_dot];
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
                q1_dot_1.mul_add(s2_last, q1_dot_last.mul_add(s2_1, next[4])),
                q2_dot_1
                    .mul_add(
                        q1_ddot_of_motion_last,
                        q2_dot_last.mul_add(q1_ddot_of_motion_1, next[5]),
                    ),
                c2_1.mul_add(q1_dot_dot_last, c2_last.mul_add(q1_dot_dot_1, next[6])),
                s2_1.mul_add(q1_dot_dot_last, s2_last.mul_add(q1_dot_dot_1, next[7])),
                q1_dot_1.mul_add(c2_last, q1_dot_last.mul_add(c2_1, next[8])),
                q2_dot_1
                    .mul_add(q1_dot_c2_last, q2_dot_last.mul_add(q1_dot_c2_1, next[9])),
                s2_1.mul_add(c1_last, s2_last.mul_add(c1_1, next[10])),
                q2_ddot_of_motion_1
                    .mul_add(
                        q1_dot_c2_last,
                        q2_ddot_of_motion_last.mul_add(q1_dot_c2_1, next[11]),
                    ),
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
        // q1_dot_s2 = q1_dot*s2
        let q1_dot_s2 = s2.mul_add(q1_dot_0, q1_dot.mul_add(s2_0, sums[4]));
        // q1_ddot_of_motion = i3_by_i1*q3_dot + i3_by_i1_minus_2*q1_dot_s2
        let q1_ddot_of_motion = q1_dot_s2.mul_add(i3_by_i1_minus_2, i3_by_i1 * q3_dot);
        // q1_ddot_of_motion_2 = q2_dot*q1_ddot_of_motion
        let q1_ddot_of_motion_2 = q1_ddot_of_motion
            .mul_add(q2_dot_0, q2_dot.mul_add(q1_ddot_of_motion_0, sums[5]));
        // q1_ddot_of_motion_3 = m_l_g_by_i1*s1 - q1_ddot_of_motion_2
        let q1_ddot_of_motion_3 = m_l_g_by_i1 * s1 - q1_ddot_of_motion_2;
        // q1_dot_dot = q1_ddot_of_motion_3/c2
        let q1_dot_dot = q1_ddot_of_motion_3
            .mul_add(over_c2, -(c2.mul_add(q1_dot_dot_0, sums[6]) * over_c2));
        // q3_ddot_of_motion = s2*q1_dot_dot
        let q3_ddot_of_motion = q1_dot_dot
            .mul_add(s2_0, s2.mul_add(q1_dot_dot_0, sums[7]));
        // q1_dot_c2 = q1_dot*c2
        let q1_dot_c2 = c2.mul_add(q1_dot_0, q1_dot.mul_add(c2_0, sums[8]));
        // q1_dot_q2_dot_c2 = q2_dot*q1_dot_c2
        let q1_dot_q2_dot_c2 = q1_dot_c2
            .mul_add(q2_dot_0, q2_dot.mul_add(q1_dot_c2_0, sums[9]));
        // q3_dot_dot = -q3_ddot_of_motion - q1_dot_q2_dot_c2
        let q3_dot_dot = -q1_dot_q2_dot_c2 - q3_ddot_of_motion;
        // s2_c1 = s2*c1
        let s2_c1 = c1.mul_add(s2_0, s2.mul_add(c1_0, sums[10]));
        // q2_ddot_of_motion = i3_by_i1*q3_dot + i3_by_i1_minus_1*q1_dot_s2
        let q2_ddot_of_motion = q1_dot_s2.mul_add(i3_by_i1_minus_1, i3_by_i1 * q3_dot);
        // q2_ddot_of_motion_2 = q2_ddot_of_motion*q1_dot_c2
        let q2_ddot_of_motion_2 = q2_ddot_of_motion
            .mul_add(q1_dot_c2_0, q1_dot_c2.mul_add(q2_ddot_of_motion_0, sums[11]));
        // q2_dot_dot = m_l_g_by_i1*s2_c1 + q2_ddot_of_motion_2
        let q2_dot_dot = m_l_g_by_i1 * s2_c1 + q2_ddot_of_motion_2;
        q1_rate = q1_dot;
        q2_rate = q2_dot;
        q3_rate = q3_dot;
        q1_dot_rate = q1_dot_dot;
        q2_dot_rate = q2_dot_dot;
        q3_dot_rate = q3_dot_dot;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * q2,
                count * q2,
                count * q1,
                count * q1,
                q1_dot, q2_dot, c2, s2, q1_dot, q2_dot, s2, q2_ddot_of_motion,
            ]),
            padded([
                c2, s2, c1, s1, s2, q1_ddot_of_motion, q1_dot_dot, q1_dot_dot, c2, q1_dot_c2, c1,
                q1_dot_c2,
            ]),
        ];
        count_last = count;
        q1_last = q1;
        q2_last = q2;
        q1_dot_last = q1_dot;
        q2_dot_last = q2_dot;
        s2_last = s2;
        c2_last = c2;
        s1_last = s1;
        c1_last = c1;
        q1_ddot_of_motion_last = q1_ddot_of_motion;
        q1_dot_dot_last = q1_dot_dot;
        q1_dot_c2_last = q1_dot_c2;
        q2_ddot_of_motion_last = q2_ddot_of_motion;
    }
}

/// Lagrange's equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Lagrange;

impl<S: Scalar> System<S> for Lagrange {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 5,
            coordinates: 3,
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
        6
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
        ["cos(q2)"][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
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
