//! Furuta pendulum: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/furuta/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows theta1, theta2.
///
/// 14 operations, 1 sine and cosine.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _q_dot: &[S; 2],
) -> [[S; 2]; 2] {
    let Parameters { L1, l1, m1, J1, l2, m2, J2, .. } = *p;
    let [_, theta2] = *q;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Shared terms.
    // l2^2*m2 + J2
    let j2_plus_l2_sq_m2 = l2 * l2 * m2 + J2;
    let l1_m2 = L1 * m2;
    // Entries that are not zero; upper triangle.
    // M11 = l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(L1^2 + l2^2*sin(theta2)^2)
    let m11 = L1
        .mul_add(l1_m2, l1 * l1 * m1 + J1 + j2_plus_l2_sq_m2 * sin_theta2 * sin_theta2);
    // M12 = L1*l2*m2*cos(theta2)
    let m12 = l2 * l1_m2 * cos_theta2;
    // M22 = l2^2*m2 + J2
    let m22 = j2_plus_l2_sq_m2;
    [[m11, m12], [m12, m22]]
}

/// Right-hand side of the linear system; unknowns (theta1'', theta2'').
///
/// 20 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> [S; 2] {
    let Parameters { L1, l2, m2, J2, b1, b2, g, tau, .. } = *p;
    let [_, theta2] = *q;
    let [theta1_dot, theta2_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Shared terms.
    let l2_m2 = l2 * m2;
    // theta1'*cos(theta2)*(J2 + l2*l2_m2)
    let f1_of_theta1_dot = theta1_dot * cos_theta2 * l2.mul_add(l2_m2, J2);
    // Values.
    // f1 = tau + L1*l2*m2*theta2'^2*sin(theta2) - theta1'*(b1 + 2*theta2'*sin(theta2)*cos(theta2)*(l2^2*m2
    //   + J2))
    let f1 = tau - b1 * theta1_dot
        + theta2_dot * sin_theta2 * (-f1_of_theta1_dot).mul_add(S::int(2), L1 * theta2_dot * l2_m2);
    // f2 = sin(theta2)*(J2*theta1'^2*cos(theta2) - l2*m2*(g - l2*theta1'^2*cos(theta2))) - b2*theta2'
    let f2 = sin_theta2 * (-g).mul_add(l2_m2, theta1_dot * f1_of_theta1_dot) - b2 * theta2_dot;
    [f1, f2]
}

/// The accelerations (theta1'', theta2''), solved for when this code was generated.
///
/// 47 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { L1, l1, m1, J1, l2, m2, J2, b1, b2, g, tau } = *p;
    let [_, theta2] = *q;
    let [theta1_dot, theta2_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let l2_m2 = l2 * m2;
    let l2_l2_m2 = l2 * l2_m2;
    // J2 + l2_l2_m2
    let j2_plus_l2_l2_m2 = J2 + l2_l2_m2;
    let j2_plus_l2_l2_m2_inv = S::int(1) / j2_plus_l2_l2_m2;
    let theta1_ddot_of_place = j2_plus_l2_l2_m2_inv * cos_theta2;
    let l2_sin_theta2 = l2 * sin_theta2;
    let theta1_ddot_of_place_2 = j2_plus_l2_l2_m2 * cos_theta2;
    // b2*theta2' + sin(theta2)*(g*l2_m2 - theta1'^2*theta1_ddot_of_place_2)
    let theta1_ddot_of_motion = sin_theta2
        * g.mul_add(l2_m2, -theta1_dot * theta1_dot * theta1_ddot_of_place_2) + b2 * theta2_dot;
    let theta2_dot_sin_theta2 = theta2_dot * sin_theta2;
    let l1_l2_m2 = L1 * l2_m2;
    // theta1'*(b1 + 2*theta1_ddot_of_place_2*theta2_dot_sin_theta2) - tau
    let theta1_ddot_of_motion_2 = theta1_dot
        * (theta1_ddot_of_place_2 * theta2_dot_sin_theta2).mul_add(S::int(2), b1) - tau;
    // theta1'' = (tau + L1*l2*m2*theta2'^2*sin(theta2) - theta1'*(b1 +
    //   2*theta2'*sin(theta2)*cos(theta2)*(l2^2*m2 + J2)) + L1*l2*m2*cos(theta2)*(sin(theta2)*(l2*m2*(g -
    //   l2*theta1'^2*cos(theta2)) - J2*theta1'^2*cos(theta2)) + b2*theta2')/(l2^2*m2 + J2))/(l1^2*m1 + J1 +
    //   J2*sin(theta2)^2 + m2*(l2^2*sin(theta2)^2 + L1^2*(1 - l2^2*m2*cos(theta2)^2/(l2^2*m2 + J2))))
    let theta1_ddot = (l1_l2_m2
        * theta2_dot
            .mul_add(theta2_dot_sin_theta2, theta1_ddot_of_place * theta1_ddot_of_motion)
        - theta1_ddot_of_motion_2)
        / (l1 * l1 * m1 + J1 + J2 * sin_theta2 * sin_theta2
            + m2
                * (-L1 * L1 * (l2_l2_m2 * theta1_ddot_of_place).mul_add(cos_theta2, -S::int(1))
                    + l2_sin_theta2 * l2_sin_theta2));
    // theta2'' = (J2*theta1'^2*sin(theta2)*cos(theta2) - b2*theta2' - l2*m2*(sin(theta2)*(g -
    //   l2*theta1'^2*cos(theta2)) + L1*theta1''*cos(theta2)))/(l2^2*m2 + J2)
    let theta2_ddot = (-(theta1_ddot * theta1_ddot_of_place))
        .mul_add(l1_l2_m2, -j2_plus_l2_l2_m2_inv * theta1_ddot_of_motion);
    [theta1_ddot, theta2_ddot]
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
    let [theta1_dot, theta2_dot] = *q_dot;
    // Values.
    // theta1'
    let theta1_dot_value = theta1_dot;
    // theta2'
    let theta2_dot_value = theta2_dot;
    [theta1_dot_value, theta2_dot_value]
}

/// Kinetic energy T.
///
/// 24 operations, 1 sine and cosine.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> S {
    let Parameters { L1, l1, m1, J1, l2, m2, J2, .. } = *p;
    let [_, theta2] = *q;
    let [theta1_dot, theta2_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Shared terms.
    // l2^2*m2 + J2
    let j2_plus_l2_sq_m2 = l2 * l2 * m2 + J2;
    let theta1_dot_sq_halved = S::ratio(1, 2) * theta1_dot * theta1_dot;
    // l1^2*m1 + J1
    let j1_plus_l1_sq_m1 = l1 * l1 * m1 + J1;
    // Values.
    // T = theta1'^2*(l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(L1^2 + l2^2*sin(theta2)^2))/2 +
    //   theta2'^2*(l2^2*m2 + J2)/2 + L1*l2*m2*theta1'*theta2'*cos(theta2)
    let energy = S::ratio(1, 2) * theta2_dot * theta2_dot * j2_plus_l2_sq_m2
        + L1 * m2 * L1.mul_add(theta1_dot_sq_halved, l2 * theta1_dot * theta2_dot * cos_theta2)
        + theta1_dot_sq_halved * (j2_plus_l2_sq_m2 * sin_theta2 * sin_theta2 + j1_plus_l1_sq_m1);
    energy
}

/// The power of the loads that have no potential: the rate of T + V.
///
/// 6 operations.
#[must_use]
pub fn power<S: Scalar>(p: &Parameters<S>, _q: &[S; 2], q_dot: &[S; 2]) -> S {
    let Parameters { b1, b2, .. } = *p;
    let [theta1_dot, theta2_dot] = *q_dot;
    // Values.
    // d(T + V)/dt = -b1*theta1'^2 - b2*theta2'^2
    let rate = -b1 * theta1_dot * theta1_dot - b2 * theta2_dot * theta2_dot;
    rate
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
    let [theta1_dot, theta2_dot] = *q_dot;
    // Values.
    // u_theta1 = theta1'
    let u_theta1_value = theta1_dot;
    // u_theta2 = theta2'
    let u_theta2_value = theta2_dot;
    [u_theta1_value, u_theta2_value]
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
    let [theta1_ddot, theta2_ddot] = *v_dot;
    // Values.
    // u_theta1' = theta1''
    let u_theta1_dot_value = theta1_ddot;
    // u_theta2' = theta2''
    let u_theta2_dot_value = theta2_ddot;
    [u_theta1_dot_value, u_theta2_dot_value]
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
    let [u_theta1, u_theta2] = *u;
    // Values.
    // theta1' = u_theta1
    let theta1_dot_value = u_theta1;
    // theta2' = u_theta2
    let theta2_dot_value = u_theta2;
    [theta1_dot_value, theta2_dot_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 47 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let Parameters { L1, l1, m1, J1, l2, m2, J2, b1, b2, g, tau } = *p;
    let [_, theta2] = *q;
    let [theta1_dot, theta2_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let l2_m2 = l2 * m2;
    let l2_l2_m2 = l2 * l2_m2;
    // J2 + l2_l2_m2
    let j2_plus_l2_l2_m2 = J2 + l2_l2_m2;
    let j2_plus_l2_l2_m2_inv = S::int(1) / j2_plus_l2_l2_m2;
    let theta1_ddot_of_place = j2_plus_l2_l2_m2_inv * cos_theta2;
    let l2_sin_theta2 = l2 * sin_theta2;
    let theta1_ddot_of_place_2 = j2_plus_l2_l2_m2 * cos_theta2;
    // b2*theta2' + sin(theta2)*(g*l2_m2 - theta1'^2*theta1_ddot_of_place_2)
    let theta1_ddot_of_motion = sin_theta2
        * g.mul_add(l2_m2, -theta1_dot * theta1_dot * theta1_ddot_of_place_2) + b2 * theta2_dot;
    let theta2_dot_sin_theta2 = theta2_dot * sin_theta2;
    let l1_l2_m2 = L1 * l2_m2;
    // theta1'*(b1 + 2*theta1_ddot_of_place_2*theta2_dot_sin_theta2) - tau
    let theta1_ddot_of_motion_2 = theta1_dot
        * (theta1_ddot_of_place_2 * theta2_dot_sin_theta2).mul_add(S::int(2), b1) - tau;
    // theta1'' = (tau + L1*l2*m2*theta2'^2*sin(theta2) - theta1'*(b1 +
    //   2*theta2'*sin(theta2)*cos(theta2)*(l2^2*m2 + J2)) + L1*l2*m2*cos(theta2)*(sin(theta2)*(l2*m2*(g -
    //   l2*theta1'^2*cos(theta2)) - J2*theta1'^2*cos(theta2)) + b2*theta2')/(l2^2*m2 + J2))/(l1^2*m1 + J1 +
    //   J2*sin(theta2)^2 + m2*(l2^2*sin(theta2)^2 + L1^2*(1 - l2^2*m2*cos(theta2)^2/(l2^2*m2 + J2))))
    let theta1_ddot = (l1_l2_m2
        * theta2_dot
            .mul_add(theta2_dot_sin_theta2, theta1_ddot_of_place * theta1_ddot_of_motion)
        - theta1_ddot_of_motion_2)
        / (l1 * l1 * m1 + J1 + J2 * sin_theta2 * sin_theta2
            + m2
                * (-L1 * L1 * (l2_l2_m2 * theta1_ddot_of_place).mul_add(cos_theta2, -S::int(1))
                    + l2_sin_theta2 * l2_sin_theta2));
    // theta2'' = (J2*theta1'^2*sin(theta2)*cos(theta2) - b2*theta2' - l2*m2*(sin(theta2)*(g -
    //   l2*theta1'^2*cos(theta2)) + L1*theta1''*cos(theta2)))/(l2^2*m2 + J2)
    let theta2_ddot = (-(theta1_ddot * theta1_ddot_of_place))
        .mul_add(l1_l2_m2, -j2_plus_l2_l2_m2_inv * theta1_ddot_of_motion);
    // Values.
    // theta1'
    let theta1_dot_value = theta1_dot;
    // theta2'
    let theta2_dot_value = theta2_dot;
    ([theta1_dot_value, theta2_dot_value], [theta1_ddot, theta2_ddot])
}

/// Jacobian of the derivative by the state; columns theta1, theta2, theta1', theta2'.
///
/// 120 operations, 1 sine and cosine.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [[S; 4]; 4] {
    let Parameters { L1, l1, m1, J1, l2, m2, J2, b1, b2, g, tau } = *p;
    let [_, theta2] = *q;
    let [theta1_dot, theta2_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let l2_m2 = l2 * m2;
    let l2_l2_m2 = l2 * l2_m2;
    // J2 + l2_l2_m2
    let j2_plus_l2_l2_m2 = J2 + l2_l2_m2;
    let j2_plus_l2_l2_m2_inv = S::int(1) / j2_plus_l2_l2_m2;
    let theta1_ddot_of_place = j2_plus_l2_l2_m2_inv * cos_theta2;
    let theta1_ddot_of_place_2 = theta1_ddot_of_place * cos_theta2;
    let sin_theta2_sq = sin_theta2 * sin_theta2;
    // 1/(l1^2*m1 + J1 + J2*sin_theta2_sq + m2*(l2^2*sin_theta2_sq - L1^2*(l2_l2_m2*theta1_ddot_of_place_2
    //   - 1)))
    let theta1_ddot_of_place_3 = S::int(1)
        / (l1 * l1 * m1 + J1 + J2 * sin_theta2_sq
            + m2
                * (l2 * l2 * sin_theta2_sq
                    - L1 * L1 * l2_l2_m2.mul_add(theta1_ddot_of_place_2, -S::int(1))));
    let l1_l2_m2 = L1 * l2_m2;
    let theta2_dot_sq_l1_l2_m2 = theta2_dot * theta2_dot * l1_l2_m2;
    let theta1_ddot_of_place_4 = theta1_ddot_of_place_3 * cos_theta2;
    let g_l2_m2 = g * l2_m2;
    let theta1_ddot_of_l1_l2_m2_j2 = j2_plus_l2_l2_m2_inv * l1_l2_m2;
    // theta1_ddot_of_l1_l2_m2_j2*(b2*theta2' + g_l2_m2*sin(theta2))
    let theta1_ddot_of_theta2_dot = theta1_ddot_of_l1_l2_m2_j2
        * g_l2_m2.mul_add(sin_theta2, b2 * theta2_dot);
    // tau*theta1_ddot_of_place_3 + theta1_ddot_of_place_4*theta1_ddot_of_theta2_dot
    let theta1_ddot_of_theta2_dot_2 = theta1_ddot_of_place_4
        .mul_add(theta1_ddot_of_theta2_dot, tau * theta1_ddot_of_place_3);
    // theta1_ddot_of_place_3*(theta2_dot_sq_l1_l2_m2*sin(theta2) - b1*theta1') +
    //   theta1_ddot_of_theta2_dot_2
    let theta1_ddot_of_motion = theta1_ddot_of_place_3
        * (-b1).mul_add(theta1_dot, theta2_dot_sq_l1_l2_m2 * sin_theta2)
        + theta1_ddot_of_theta2_dot_2;
    let theta1_ddot_of_theta1_dot = theta1_dot * j2_plus_l2_l2_m2;
    let theta1_ddot_of_place_5 = theta1_ddot_of_l1_l2_m2_j2 * cos_theta2;
    let theta2_dot_doubled = S::int(2) * theta2_dot;
    // theta1'*theta1_ddot_of_place_5 + theta2_dot_doubled
    let theta1_ddot_of_motion_2 = theta1_dot
        .mul_add(theta1_ddot_of_place_5, theta2_dot_doubled);
    let theta1_ddot_of_place_6 = theta1_ddot_of_place_4 * sin_theta2;
    let theta1_ddot_of_motion_3 = theta1_ddot_of_motion_2 * theta1_ddot_of_place_6;
    // theta1'' = (tau + L1*l2*m2*theta2'^2*sin(theta2) - theta1'*(b1 +
    //   2*theta2'*sin(theta2)*cos(theta2)*(l2^2*m2 + J2)) + L1*l2*m2*cos(theta2)*(sin(theta2)*(l2*m2*(g -
    //   l2*theta1'^2*cos(theta2)) - J2*theta1'^2*cos(theta2)) + b2*theta2')/(l2^2*m2 + J2))/(l1^2*m1 + J1 +
    //   J2*sin(theta2)^2 + m2*(l2^2*sin(theta2)^2 + L1^2*(1 - l2^2*m2*cos(theta2)^2/(l2^2*m2 + J2))))
    let theta1_ddot = (-theta1_ddot_of_theta1_dot)
        .mul_add(theta1_ddot_of_motion_3, theta1_ddot_of_motion);
    let theta1_ddot_by_theta2_of_place = S::int(2) * theta1_ddot_of_place_6;
    let theta1_ddot_by_theta2_of_place_2 = theta1_ddot_of_place_3 * sin_theta2;
    let theta1_ddot_by_theta2_of_theta1_dot = theta1_ddot_of_theta1_dot
        * theta1_ddot_by_theta2_of_place;
    // theta1_ddot_by_theta2 = 2*(J2*sin(theta2)*cos(theta2) + m2*(l2^2*sin(theta2)*cos(theta2) +
    //   L1^2*l2^2*m2*sin(theta2)*cos(theta2)/(l2^2*m2 + J2)))*(theta1'*(b1 +
    //   2*theta2'*sin(theta2)*cos(theta2)*(l2^2*m2 + J2)) - tau - L1*l2*m2*theta2'^2*sin(theta2) -
    //   L1*l2*m2*cos(theta2)*(sin(theta2)*(l2*m2*(g - l2*theta1'^2*cos(theta2)) - J2*theta1'^2*cos(theta2))
    //   + b2*theta2')/(l2^2*m2 + J2))/(l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(l2^2*sin(theta2)^2 + L1^2*(1 -
    //   l2^2*m2*cos(theta2)^2/(l2^2*m2 + J2))))^2 + (L1*l2*m2*cos(theta2)*(cos(theta2)*(l2*m2*(g -
    //   l2*theta1'^2*cos(theta2)) - J2*theta1'^2*cos(theta2)) + sin(theta2)*(l2^2*m2*theta1'^2*sin(theta2) +
    //   J2*theta1'^2*sin(theta2)))/(l2^2*m2 + J2) + L1*l2*m2*theta2'^2*cos(theta2) -
    //   L1*l2*m2*sin(theta2)*(sin(theta2)*(l2*m2*(g - l2*theta1'^2*cos(theta2)) - J2*theta1'^2*cos(theta2))
    //   + b2*theta2')/(l2^2*m2 + J2) + 2*theta1'*(theta2'*sin(theta2)^2*(l2^2*m2 + J2) -
    //   theta2'*cos(theta2)^2*(l2^2*m2 + J2)))/(l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(l2^2*sin(theta2)^2 +
    //   L1^2*(1 - l2^2*m2*cos(theta2)^2/(l2^2*m2 + J2))))
    let theta1_ddot_by_theta2 = theta1_ddot_of_place_4
        * g_l2_m2.mul_add(theta1_ddot_of_place_5, theta2_dot_sq_l1_l2_m2)
        + theta1_ddot_of_theta1_dot
            * (-(theta1_ddot_of_place_4 * theta1_ddot_of_motion_2))
                .mul_add(
                    cos_theta2,
                    sin_theta2_sq * theta1_ddot_of_place_3 * theta2_dot_doubled,
                )
        - theta1_ddot_of_motion * theta1_ddot_by_theta2_of_place
            * l1_l2_m2.mul_add(theta1_ddot_of_l1_l2_m2_j2, j2_plus_l2_l2_m2)
        + theta1_dot * theta1_ddot_of_motion_3
            * (J2 * J2 * theta1_ddot_by_theta2_of_place
                + l2_l2_m2
                    * l2_l2_m2
                        .mul_add(
                            theta1_ddot_by_theta2_of_place,
                            S::int(4) * J2 * theta1_ddot_of_place_6,
                        )) - theta1_ddot_of_theta2_dot * theta1_ddot_by_theta2_of_place_2
        + theta1_ddot_of_l1_l2_m2_j2 * theta1_ddot_by_theta2_of_theta1_dot
            * l1_l2_m2.mul_add(theta1_ddot_of_motion_3, theta1_dot * sin_theta2);
    // theta2_ddot_by_theta2 = -(J2*theta1'^2*(sin(theta2)^2 - cos(theta2)^2) +
    //   l2*m2*(sin(theta2)*(l2*theta1'^2*sin(theta2) - L1*theta1'') + cos(theta2)*(g -
    //   l2*theta1'^2*cos(theta2) + L1*theta1_ddot_by_theta2)))/(l2^2*m2 + J2)
    let theta2_ddot_by_theta2 = theta1_ddot * theta1_ddot_of_l1_l2_m2_j2 * sin_theta2
        - theta1_ddot_of_place * g_l2_m2
        + theta1_dot * theta1_ddot_of_theta1_dot
            * (-j2_plus_l2_l2_m2_inv).mul_add(sin_theta2_sq, theta1_ddot_of_place_2)
        - theta1_ddot_by_theta2 * theta1_ddot_of_place_5;
    // theta1_ddot_by_theta1_dot = -(b1 + 2*sin(theta2)*cos(theta2)*(J2*theta2' +
    //   l2*m2*(L1*theta1'*cos(theta2) + l2*theta2')))/(l1^2*m1 + J1 + J2*sin(theta2)^2 +
    //   m2*(l2^2*sin(theta2)^2 + L1^2*(1 - l2^2*m2*cos(theta2)^2/(l2^2*m2 + J2))))
    let theta1_ddot_by_theta1_dot = -theta1_ddot_by_theta2_of_place
        * (theta1_dot * l1_l2_m2).mul_add(cos_theta2, theta2_dot * j2_plus_l2_l2_m2)
        - b1 * theta1_ddot_of_place_3;
    // theta2_ddot_by_theta1_dot = cos(theta2)*(2*J2*theta1'*sin(theta2) + l2*m2*(2*l2*theta1'*sin(theta2)
    //   - L1*theta1_ddot_by_theta1_dot))/(l2^2*m2 + J2)
    let theta2_ddot_by_theta1_dot = (-theta1_ddot_by_theta1_dot)
        .mul_add(
            theta1_ddot_of_place_5,
            S::int(2) * theta1_ddot_of_place * theta1_ddot_of_theta1_dot * sin_theta2,
        );
    // theta1_ddot_by_theta2_dot = (L1*l2*m2*b2*cos(theta2)/(l2^2*m2 + J2) -
    //   2*theta1'*sin(theta2)*cos(theta2)*(l2^2*m2 + J2) + 2*L1*l2*m2*theta2'*sin(theta2))/(l1^2*m1 + J1 +
    //   J2*sin(theta2)^2 + m2*(l2^2*sin(theta2)^2 + L1^2*(1 - l2^2*m2*cos(theta2)^2/(l2^2*m2 + J2))))
    let theta1_ddot_by_theta2_dot = (l1_l2_m2 * theta2_dot_doubled)
        .mul_add(
            theta1_ddot_by_theta2_of_place_2,
            b2 * theta1_ddot_of_place_4 * theta1_ddot_of_l1_l2_m2_j2,
        ) - theta1_ddot_by_theta2_of_theta1_dot;
    // theta2_ddot_by_theta2_dot = -(b2 + L1*l2*m2*theta1_ddot_by_theta2_dot*cos(theta2))/(l2^2*m2 + J2)
    let theta2_ddot_by_theta2_dot = (-theta1_ddot_by_theta2_dot)
        .mul_add(theta1_ddot_of_place_5, -b2 * j2_plus_l2_l2_m2_inv);
    // Entries that are not zero.
    // d(theta1')/d(theta1') = 1
    let theta1_dot_by_theta1_dot_value = S::int(1);
    // d(theta2')/d(theta2') = 1
    let theta2_dot_by_theta2_dot_value = S::int(1);
    let zero = S::int(0);
    [
        [zero, zero, theta1_dot_by_theta1_dot_value, zero],
        [zero, zero, zero, theta2_dot_by_theta2_dot_value],
        [
            zero, theta1_ddot_by_theta2, theta1_ddot_by_theta1_dot, theta1_ddot_by_theta2_dot,
        ],
        [
            zero, theta2_ddot_by_theta2, theta2_ddot_by_theta1_dot, theta2_ddot_by_theta2_dot,
        ],
    ]
}

/// Inverse dynamics: the generalized forces along (theta1', theta2') that must act beside the loads of the model for the accelerations to be (theta1'', theta2'').
///
/// 39 operations, 1 sine and cosine.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { L1, l1, m1, J1, l2, m2, J2, b1, b2, g, tau } = *p;
    let [_, theta2] = *q;
    let [theta1_dot, theta2_dot] = *q_dot;
    let [theta1_ddot, theta2_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_theta2, cos_theta2) = theta2.sin_cos();
    // Shared terms.
    let theta1_dot_cos_theta2 = theta1_dot * cos_theta2;
    let l2_m2 = l2 * m2;
    // J2 + l2*l2_m2
    let j2_plus_l2_l2_m2 = l2.mul_add(l2_m2, J2);
    let tau1_of_place = j2_plus_l2_l2_m2 * sin_theta2;
    let l1_theta1_ddot = L1 * theta1_ddot;
    // Values.
    // tau1 = theta1'*(b1 + 2*theta2'*sin(theta2)*cos(theta2)*(l2^2*m2 + J2)) - tau -
    //   L1*l2*m2*theta2'^2*sin(theta2) + theta1''*(l1^2*m1 + J1 + J2*sin(theta2)^2 + m2*(L1^2 +
    //   l2^2*sin(theta2)^2)) + L1*l2*m2*theta2''*cos(theta2)
    let tau1 = -tau + b1 * theta1_dot + theta1_ddot * (l1 * l1 * m1 + J1)
        + tau1_of_place
            * (theta2_dot * theta1_dot_cos_theta2)
                .mul_add(S::int(2), theta1_ddot * sin_theta2)
        + L1
            * (l2_m2 * theta2_ddot.mul_add(cos_theta2, -theta2_dot * theta2_dot * sin_theta2)
                + m2 * l1_theta1_ddot);
    // tau2 = sin(theta2)*(l2*m2*(g - l2*theta1'^2*cos(theta2)) - J2*theta1'^2*cos(theta2)) + b2*theta2' +
    //   L1*l2*m2*theta1''*cos(theta2) + theta2''*(l2^2*m2 + J2)
    let tau2 = b2 * theta2_dot + theta2_ddot * j2_plus_l2_l2_m2
        - theta1_dot * theta1_dot_cos_theta2 * tau1_of_place
        + l2_m2 * l1_theta1_ddot.mul_add(cos_theta2, g * sin_theta2);
    [tau1, tau2]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 14 convolutions and 28 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 4]],
    history: &mut [Factors<S, 16>],
) {
    let Parameters { L1, l1, m1, J1, l2, m2, J2, b1, b2, g, tau } = *p;
    let [_, theta2_0, theta1_dot_0, theta2_dot_0] = series[0];
    // Shared terms.
    let l2_sq_m2 = l2 * l2 * m2;
    // l2^2*m2 + J2
    let j2_plus_l2_sq_m2 = l2_sq_m2 + J2;
    let l1_l2_m2_2 = L1 * l2 * m2;
    // Constant in time.
    // weight = l1^2*m1 + J1 + L1^2*m2
    let weight = l1 * l1 * m1 + J1 + L1 * L1 * m2;
    // l2_2_m2_plus_j2 = l2^2*m2 + J2
    let l2_2_m2_plus_j2 = j2_plus_l2_sq_m2;
    // weight_2 = -L1^2*l2^2*m2^2/(l2^2*m2 + J2)
    let weight_2 = -L1 * L1 * l2 * l2 * m2 * m2 / j2_plus_l2_sq_m2;
    // l1_l2_m2 = L1*l2*m2
    let l1_l2_m2 = l1_l2_m2_2;
    // weight_3 = 2*l2^2*m2 + 2*J2
    let weight_3 = J2.mul_add(S::int(2), S::int(2) * l2_sq_m2);
    // weight_4 = -L1*l2^2*m2^2*g/(l2^2*m2 + J2)
    let weight_4 = -L1 * l2 * l2 * m2 * m2 * g / j2_plus_l2_sq_m2;
    // minus_l1_l2_m2 = -L1*l2*m2
    let minus_l1_l2_m2 = -l1_l2_m2_2;
    // minus_b1 = -b1
    let minus_b1 = -b1;
    // weight_5 = L1*l2*m2*b2/(l2^2*m2 + J2)
    let weight_5 = L1 * l2 * m2 * b2 / j2_plus_l2_sq_m2;
    // minus_l2_m2_g = -l2*m2*g
    let minus_l2_m2_g = -l2 * m2 * g;
    // weight_6 = -1/(l2^2*m2 + J2)
    let weight_6 = -S::int(1) / j2_plus_l2_sq_m2;
    // Order 0.
    let (sin_theta2_0, cos_theta2_0) = theta2_0.sin_cos();
    let sin_theta2_sq_0 = sin_theta2_0 * sin_theta2_0;
    let cos_theta2_sq_0 = cos_theta2_0 * cos_theta2_0;
    let theta1_ddot_of_place_0 = cos_theta2_sq_0
        .mul_add(weight_2, sin_theta2_sq_0.mul_add(l2_2_m2_plus_j2, weight));
    let over_theta1_ddot_of_place = S::int(1) / theta1_ddot_of_place_0;
    let theta2_dot_cos_theta2_0 = theta2_dot_0 * cos_theta2_0;
    let theta1_dot_cos_theta2_0 = theta1_dot_0 * cos_theta2_0;
    let theta1_ddot_of_motion_0 = theta1_dot_cos_theta2_0
        .mul_add(l1_l2_m2, weight_3 * theta2_dot_0);
    let theta1_ddot_of_motion_2_0 = theta1_dot_0 * theta1_ddot_of_motion_0;
    let theta1_ddot_of_motion_3_0 = weight_4 + theta1_ddot_of_motion_2_0;
    let theta1_ddot_of_motion_4_0 = cos_theta2_0 * theta1_ddot_of_motion_3_0;
    let theta2_dot_sq_0 = theta2_dot_0 * theta2_dot_0;
    let theta1_ddot_of_motion_5_0 = minus_l1_l2_m2 * theta2_dot_sq_0 + theta1_ddot_of_motion_4_0;
    let theta1_ddot_of_motion_6_0 = sin_theta2_0 * theta1_ddot_of_motion_5_0;
    let theta1_ddot_of_motion_7_0 = theta2_dot_cos_theta2_0
        .mul_add(weight_5, theta1_dot_0.mul_add(minus_b1, tau)) - theta1_ddot_of_motion_6_0;
    let theta1_dot_dot_0 = theta1_ddot_of_motion_7_0 * over_theta1_ddot_of_place;
    let theta2_ddot_of_motion_0 = theta1_dot_dot_0 * cos_theta2_0;
    let theta1_dot_sq_cos_theta2_0 = theta1_dot_0 * theta1_dot_cos_theta2_0;
    let theta2_ddot_of_theta1_dot_0 = theta1_dot_sq_cos_theta2_0
        .mul_add(l2_2_m2_plus_j2, minus_l2_m2_g);
    let theta2_ddot_of_theta1_dot_2_0 = sin_theta2_0 * theta2_ddot_of_theta1_dot_0;
    let theta2_ddot_of_motion_2_0 = theta2_ddot_of_motion_0
        .mul_add(l1_l2_m2, b2 * theta2_dot_0 - theta2_ddot_of_theta1_dot_2_0);
    // Order 1: the rates, and what follows from them.
    let theta1_1 = theta1_dot_0;
    let theta2_1 = theta2_dot_0;
    let theta1_dot_1 = theta1_dot_dot_0;
    let theta2_dot_1 = weight_6 * theta2_ddot_of_motion_2_0;
    if series.len() > 1 {
        series[1] = [theta1_1, theta2_1, theta1_dot_1, theta2_dot_1];
    }
    let sin_theta2_1 = theta2_1 * cos_theta2_0;
    let cos_theta2_1 = -theta2_1 * sin_theta2_0;
    let sin_theta2_sq_1 = sin_theta2_1 * (sin_theta2_0 + sin_theta2_0);
    let cos_theta2_sq_1 = cos_theta2_1 * (cos_theta2_0 + cos_theta2_0);
    let theta1_ddot_of_place_1 = cos_theta2_sq_1
        .mul_add(weight_2, l2_2_m2_plus_j2 * sin_theta2_sq_1);
    let theta2_dot_cos_theta2_1 = cos_theta2_1
        .mul_add(theta2_dot_0, theta2_dot_1 * cos_theta2_0);
    let theta1_dot_cos_theta2_1 = cos_theta2_1
        .mul_add(theta1_dot_0, theta1_dot_1 * cos_theta2_0);
    let theta1_ddot_of_motion_1 = theta1_dot_cos_theta2_1
        .mul_add(l1_l2_m2, weight_3 * theta2_dot_1);
    let theta1_ddot_of_motion_2_1 = theta1_ddot_of_motion_1
        .mul_add(theta1_dot_0, theta1_dot_1 * theta1_ddot_of_motion_0);
    let theta1_ddot_of_motion_3_1 = theta1_ddot_of_motion_2_1;
    let theta1_ddot_of_motion_4_1 = theta1_ddot_of_motion_3_1
        .mul_add(cos_theta2_0, cos_theta2_1 * theta1_ddot_of_motion_3_0);
    let theta2_dot_sq_1 = theta2_dot_1 * (theta2_dot_0 + theta2_dot_0);
    let theta1_ddot_of_motion_5_1 = minus_l1_l2_m2 * theta2_dot_sq_1 + theta1_ddot_of_motion_4_1;
    let theta1_ddot_of_motion_6_1 = theta1_ddot_of_motion_5_1
        .mul_add(sin_theta2_0, sin_theta2_1 * theta1_ddot_of_motion_5_0);
    let theta1_ddot_of_motion_7_1 = theta2_dot_cos_theta2_1
        .mul_add(weight_5, minus_b1 * theta1_dot_1) - theta1_ddot_of_motion_6_1;
    let theta1_dot_dot_1 = theta1_ddot_of_place_1
        .mul_add(
            -(theta1_dot_dot_0 * over_theta1_ddot_of_place),
            theta1_ddot_of_motion_7_1 * over_theta1_ddot_of_place,
        );
    let theta2_ddot_of_motion_1 = theta1_dot_dot_1
        .mul_add(cos_theta2_0, cos_theta2_1 * theta1_dot_dot_0);
    let theta1_dot_sq_cos_theta2_1 = theta1_dot_cos_theta2_1
        .mul_add(theta1_dot_0, theta1_dot_1 * theta1_dot_cos_theta2_0);
    let theta2_ddot_of_theta1_dot_1 = l2_2_m2_plus_j2 * theta1_dot_sq_cos_theta2_1;
    let theta2_ddot_of_theta1_dot_2_1 = theta2_ddot_of_theta1_dot_1
        .mul_add(sin_theta2_0, sin_theta2_1 * theta2_ddot_of_theta1_dot_0);
    let theta2_ddot_of_motion_2_1 = theta2_ddot_of_motion_1
        .mul_add(l1_l2_m2, b2 * theta2_dot_1 - theta2_ddot_of_theta1_dot_2_1);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                theta2_1, theta2_1, sin_theta2_1, cos_theta2_1, theta2_dot_1, theta1_dot_1,
                theta1_dot_1, cos_theta2_1, theta2_dot_1, sin_theta2_1, theta1_ddot_of_place_1,
                theta1_dot_dot_1, theta1_dot_1, sin_theta2_1,
            ]),
            padded([
                cos_theta2_1, sin_theta2_1, sin_theta2_1, cos_theta2_1, cos_theta2_1, cos_theta2_1,
                theta1_ddot_of_motion_1, theta1_ddot_of_motion_3_1, theta2_dot_1,
                theta1_ddot_of_motion_5_1, theta1_dot_dot_1, cos_theta2_1, theta1_dot_cos_theta2_1,
                theta2_ddot_of_theta1_dot_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta2_last = theta2_1;
    let mut theta1_dot_last = theta1_dot_1;
    let mut theta2_dot_last = theta2_dot_1;
    let mut sin_theta2_last = sin_theta2_1;
    let mut cos_theta2_last = cos_theta2_1;
    let mut theta1_ddot_of_place_last = theta1_ddot_of_place_1;
    let mut theta1_dot_cos_theta2_last = theta1_dot_cos_theta2_1;
    let mut theta1_ddot_of_motion_last = theta1_ddot_of_motion_1;
    let mut theta1_ddot_of_motion_3_last = theta1_ddot_of_motion_3_1;
    let mut theta1_ddot_of_motion_5_last = theta1_ddot_of_motion_5_1;
    let mut theta1_dot_dot_last = theta1_dot_dot_1;
    let mut theta2_ddot_of_theta1_dot_last = theta2_ddot_of_theta1_dot_1;
    let mut next = [S::int(0); 16];
    // Rates at order k - 1.
    let mut theta1_rate = theta1_dot_1;
    let mut theta2_rate = theta2_dot_1;
    let mut theta1_dot_rate = theta1_dot_dot_1;
    let mut theta2_dot_rate = weight_6 * theta2_ddot_of_motion_2_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let theta1 = theta1_rate * over_k;
        let theta2 = theta2_rate * over_k;
        let theta1_dot = theta1_dot_rate * over_k;
        let theta2_dot = theta2_dot_rate * over_k;
        series[order] = [theta1, theta2, theta1_dot, theta2_dot];
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
                theta2_1
                    .mul_add(
                        cos_theta2_last,
                        (count_last * theta2_last).mul_add(cos_theta2_1, next[0]),
                    ),
                theta2_1
                    .mul_add(
                        sin_theta2_last,
                        (count_last * theta2_last).mul_add(sin_theta2_1, next[1]),
                    ),
                (sin_theta2_1 + sin_theta2_1).mul_add(sin_theta2_last, next[2]),
                (cos_theta2_1 + cos_theta2_1).mul_add(cos_theta2_last, next[3]),
                theta2_dot_1
                    .mul_add(
                        cos_theta2_last,
                        theta2_dot_last.mul_add(cos_theta2_1, next[4]),
                    ),
                theta1_dot_1
                    .mul_add(
                        cos_theta2_last,
                        theta1_dot_last.mul_add(cos_theta2_1, next[5]),
                    ),
                theta1_dot_1
                    .mul_add(
                        theta1_ddot_of_motion_last,
                        theta1_dot_last.mul_add(theta1_ddot_of_motion_1, next[6]),
                    ),
                cos_theta2_1
                    .mul_add(
                        theta1_ddot_of_motion_3_last,
                        cos_theta2_last.mul_add(theta1_ddot_of_motion_3_1, next[7]),
                    ),
                (theta2_dot_1 + theta2_dot_1).mul_add(theta2_dot_last, next[8]),
                sin_theta2_1
                    .mul_add(
                        theta1_ddot_of_motion_5_last,
                        sin_theta2_last.mul_add(theta1_ddot_of_motion_5_1, next[9]),
                    ),
                theta1_ddot_of_place_1
                    .mul_add(
                        theta1_dot_dot_last,
                        theta1_ddot_of_place_last.mul_add(theta1_dot_dot_1, next[10]),
                    ),
                theta1_dot_dot_1
                    .mul_add(
                        cos_theta2_last,
                        theta1_dot_dot_last.mul_add(cos_theta2_1, next[11]),
                    ),
                theta1_dot_1
                    .mul_add(
                        theta1_dot_cos_theta2_last,
                        theta1_dot_last.mul_add(theta1_dot_cos_theta2_1, next[12]),
                    ),
                sin_theta2_1
                    .mul_add(
                        theta2_ddot_of_theta1_dot_last,
                        sin_theta2_last.mul_add(theta2_ddot_of_theta1_dot_1, next[13]),
                    ),
            ])
        };
        // sin_theta2 = sin(theta2)
        let sin_theta2 = theta2.mul_add(cos_theta2_0, sums[0] * over_k);
        // cos_theta2 = cos(theta2)
        let cos_theta2 = -theta2.mul_add(sin_theta2_0, sums[1] * over_k);
        // sin_theta2_sq = sin_theta2*sin_theta2
        let sin_theta2_sq = sin_theta2.mul_add(sin_theta2_0 + sin_theta2_0, sums[2]);
        // cos_theta2_sq = cos_theta2*cos_theta2
        let cos_theta2_sq = cos_theta2.mul_add(cos_theta2_0 + cos_theta2_0, sums[3]);
        // theta1_ddot_of_place = weight + l2_2_m2_plus_j2*sin_theta2_sq + weight_2*cos_theta2_sq
        let theta1_ddot_of_place = cos_theta2_sq
            .mul_add(weight_2, l2_2_m2_plus_j2 * sin_theta2_sq);
        // theta2_dot_cos_theta2 = theta2_dot*cos_theta2
        let theta2_dot_cos_theta2 = cos_theta2
            .mul_add(theta2_dot_0, theta2_dot.mul_add(cos_theta2_0, sums[4]));
        // theta1_dot_cos_theta2 = theta1_dot*cos_theta2
        let theta1_dot_cos_theta2 = cos_theta2
            .mul_add(theta1_dot_0, theta1_dot.mul_add(cos_theta2_0, sums[5]));
        // theta1_ddot_of_motion = l1_l2_m2*theta1_dot_cos_theta2 + weight_3*theta2_dot
        let theta1_ddot_of_motion = theta1_dot_cos_theta2
            .mul_add(l1_l2_m2, weight_3 * theta2_dot);
        // theta1_ddot_of_motion_2 = theta1_dot*theta1_ddot_of_motion
        let theta1_ddot_of_motion_2 = theta1_ddot_of_motion
            .mul_add(theta1_dot_0, theta1_dot.mul_add(theta1_ddot_of_motion_0, sums[6]));
        // theta1_ddot_of_motion_3 = weight_4 + theta1_ddot_of_motion_2
        let theta1_ddot_of_motion_3 = theta1_ddot_of_motion_2;
        // theta1_ddot_of_motion_4 = cos_theta2*theta1_ddot_of_motion_3
        let theta1_ddot_of_motion_4 = theta1_ddot_of_motion_3
            .mul_add(
                cos_theta2_0,
                cos_theta2.mul_add(theta1_ddot_of_motion_3_0, sums[7]),
            );
        // theta2_dot_sq = theta2_dot*theta2_dot
        let theta2_dot_sq = theta2_dot.mul_add(theta2_dot_0 + theta2_dot_0, sums[8]);
        // theta1_ddot_of_motion_5 = theta1_ddot_of_motion_4 + minus_l1_l2_m2*theta2_dot_sq
        let theta1_ddot_of_motion_5 = minus_l1_l2_m2 * theta2_dot_sq + theta1_ddot_of_motion_4;
        // theta1_ddot_of_motion_6 = sin_theta2*theta1_ddot_of_motion_5
        let theta1_ddot_of_motion_6 = theta1_ddot_of_motion_5
            .mul_add(
                sin_theta2_0,
                sin_theta2.mul_add(theta1_ddot_of_motion_5_0, sums[9]),
            );
        // theta1_ddot_of_motion_7 = tau + minus_b1*theta1_dot + weight_5*theta2_dot_cos_theta2 -
        //   theta1_ddot_of_motion_6
        let theta1_ddot_of_motion_7 = theta2_dot_cos_theta2
            .mul_add(weight_5, minus_b1 * theta1_dot) - theta1_ddot_of_motion_6;
        // theta1_dot_dot = theta1_ddot_of_motion_7/theta1_ddot_of_place
        let theta1_dot_dot = theta1_ddot_of_motion_7
            .mul_add(
                over_theta1_ddot_of_place,
                -(theta1_ddot_of_place.mul_add(theta1_dot_dot_0, sums[10])
                    * over_theta1_ddot_of_place),
            );
        // theta2_ddot_of_motion = theta1_dot_dot*cos_theta2
        let theta2_ddot_of_motion = theta1_dot_dot
            .mul_add(cos_theta2_0, cos_theta2.mul_add(theta1_dot_dot_0, sums[11]));
        // theta1_dot_sq_cos_theta2 = theta1_dot*theta1_dot_cos_theta2
        let theta1_dot_sq_cos_theta2 = theta1_dot_cos_theta2
            .mul_add(
                theta1_dot_0,
                theta1_dot.mul_add(theta1_dot_cos_theta2_0, sums[12]),
            );
        // theta2_ddot_of_theta1_dot = minus_l2_m2_g + l2_2_m2_plus_j2*theta1_dot_sq_cos_theta2
        let theta2_ddot_of_theta1_dot = l2_2_m2_plus_j2 * theta1_dot_sq_cos_theta2;
        // theta2_ddot_of_theta1_dot_2 = sin_theta2*theta2_ddot_of_theta1_dot
        let theta2_ddot_of_theta1_dot_2 = theta2_ddot_of_theta1_dot
            .mul_add(
                sin_theta2_0,
                sin_theta2.mul_add(theta2_ddot_of_theta1_dot_0, sums[13]),
            );
        // theta2_ddot_of_motion_2 = b2*theta2_dot + l1_l2_m2*theta2_ddot_of_motion -
        //   theta2_ddot_of_theta1_dot_2
        let theta2_ddot_of_motion_2 = theta2_ddot_of_motion
            .mul_add(l1_l2_m2, b2 * theta2_dot - theta2_ddot_of_theta1_dot_2);
        theta1_rate = theta1_dot;
        theta2_rate = theta2_dot;
        theta1_dot_rate = theta1_dot_dot;
        theta2_dot_rate = weight_6 * theta2_ddot_of_motion_2;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * theta2,
                count * theta2,
                sin_theta2, cos_theta2, theta2_dot, theta1_dot, theta1_dot, cos_theta2, theta2_dot,
                sin_theta2, theta1_ddot_of_place, theta1_dot_dot, theta1_dot, sin_theta2,
            ]),
            padded([
                cos_theta2, sin_theta2, sin_theta2, cos_theta2, cos_theta2, cos_theta2,
                theta1_ddot_of_motion, theta1_ddot_of_motion_3, theta2_dot, theta1_ddot_of_motion_5,
                theta1_dot_dot, cos_theta2, theta1_dot_cos_theta2, theta2_ddot_of_theta1_dot,
            ]),
        ];
        count_last = count;
        theta2_last = theta2;
        theta1_dot_last = theta1_dot;
        theta2_dot_last = theta2_dot;
        sin_theta2_last = sin_theta2;
        cos_theta2_last = cos_theta2;
        theta1_ddot_of_place_last = theta1_ddot_of_place;
        theta1_dot_cos_theta2_last = theta1_dot_cos_theta2;
        theta1_ddot_of_motion_last = theta1_ddot_of_motion;
        theta1_ddot_of_motion_3_last = theta1_ddot_of_motion_3;
        theta1_ddot_of_motion_5_last = theta1_ddot_of_motion_5;
        theta1_dot_dot_last = theta1_dot_dot;
        theta2_ddot_of_theta1_dot_last = theta2_ddot_of_theta1_dot;
    }
}

/// Lagrange's equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Lagrange;

impl<S: Scalar> System<S> for Lagrange {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 11,
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
    fn has_power(&self) -> bool {
        true
    }
    fn power(&self, p: &[S], q: &[S], v: &[S]) -> S {
        power(&Parameters::from_slice(p), array(q), array(v))
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
