//! Symmetric rigid body free of forces: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/free_body/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows x, y, z, psi, theta, phi.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    _q_dot: &[S; 6],
) -> [[S; 6]; 6] {
    let Parameters { m, I1, I3 } = *p;
    let [_, _, _, _, theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let i3_cos_theta = I3 * cos_theta;
    // Entries that are not zero; upper triangle.
    // M11 = m
    let m11 = m;
    // M22 = m
    let m22 = m;
    // M33 = m
    let m33 = m;
    // M44 = I1*sin(theta)^2 + I3*cos(theta)^2
    let m44 = i3_cos_theta.mul_add(cos_theta, I1 * sin_theta * sin_theta);
    // M46 = I3*cos(theta)
    let m46 = i3_cos_theta;
    // M55 = I1
    let m55 = I1;
    // M66 = I3
    let m66 = I3;
    let zero = S::int(0);
    [
        [m11, zero, zero, zero, zero, zero],
        [zero, m22, zero, zero, zero, zero],
        [zero, zero, m33, zero, zero, zero],
        [zero, zero, zero, m44, zero, m46],
        [zero, zero, zero, zero, m55, zero],
        [zero, zero, zero, m46, zero, m66],
    ]
}

/// Right-hand side of the linear system; unknowns (x'', y'', z'', psi'', theta'', phi'').
///
/// 16 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 6], q_dot: &[S; 6]) -> [S; 6] {
    let Parameters { I1, I3, .. } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [_, _, _, psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let psi_dot_cos_theta = psi_dot * cos_theta;
    let f4_of_psi_dot = S::int(2) * psi_dot_cos_theta;
    let theta_dot_sin_theta = theta_dot * sin_theta;
    // Values.
    // f4 = theta'*sin(theta)*(I3*(2*psi'*cos(theta) + phi') - 2*I1*psi'*cos(theta))
    let f4 = theta_dot_sin_theta * (I3 * (phi_dot + f4_of_psi_dot) - I1 * f4_of_psi_dot);
    // f5 = psi'*sin(theta)*(I1*psi'*cos(theta) - I3*(psi'*cos(theta) + phi'))
    let f5 = psi_dot * sin_theta * (-I3 * (phi_dot + psi_dot_cos_theta) + I1 * psi_dot_cos_theta);
    // f6 = I3*psi'*theta'*sin(theta)
    let f6 = I3 * psi_dot * theta_dot_sin_theta;
    let zero = S::int(0);
    [zero, zero, zero, f4, f5, f6]
}

/// The accelerations (x'', y'', z'', psi'', theta'', phi''), solved for when this code was generated.
///
/// 14 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    q_dot: &[S; 6],
) -> [S; 6] {
    let Parameters { I1, I3, .. } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [_, _, _, psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let psi_dot_cos_theta = psi_dot * cos_theta;
    // I3*(phi' + psi_dot_cos_theta)/I1
    let psi_ddot_of_motion = I3 * (phi_dot + psi_dot_cos_theta) / I1;
    // psi'' = theta'*(I3*(psi'*cos(theta) + phi')/I1 - 2*psi'*cos(theta))/sin(theta)
    let psi_ddot = theta_dot
        * (-psi_dot_cos_theta).mul_add(S::int(2), psi_ddot_of_motion) / sin_theta;
    let psi_dot_sin_theta = psi_dot * sin_theta;
    // phi'' = psi'*theta'*sin(theta) - psi''*cos(theta)
    let phi_ddot = (-psi_ddot).mul_add(cos_theta, theta_dot * psi_dot_sin_theta);
    // theta'' = psi'*sin(theta)*(psi'*cos(theta) - I3*(psi'*cos(theta) + phi')/I1)
    let theta_ddot = psi_dot_sin_theta * (psi_dot_cos_theta - psi_ddot_of_motion);
    let zero = S::int(0);
    [zero, zero, zero, psi_ddot, theta_ddot, phi_ddot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 6],
    q_dot: &[S; 6],
) -> [S; 6] {
    let [x_dot, y_dot, z_dot, psi_dot, theta_dot, phi_dot] = *q_dot;
    // Values.
    // x'
    let x_dot_value = x_dot;
    // y'
    let y_dot_value = y_dot;
    // z'
    let z_dot_value = z_dot;
    // psi'
    let psi_dot_value = psi_dot;
    // theta'
    let theta_dot_value = theta_dot;
    // phi'
    let phi_dot_value = phi_dot;
    [
        x_dot_value, y_dot_value, z_dot_value, psi_dot_value, theta_dot_value, phi_dot_value,
    ]
}

/// Kinetic energy T.
///
/// 24 operations, 1 sine and cosine.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 6], q_dot: &[S; 6]) -> S {
    let Parameters { m, I1, I3 } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [x_dot, y_dot, z_dot, psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (_, cos_theta) = theta.sin_cos();
    // Shared terms.
    let i3_phi_dot = I3 * phi_dot;
    // x'^2 + y'^2
    let x_dot_sq_plus_y_dot_sq = y_dot.mul_add(y_dot, x_dot * x_dot);
    // psi'^2*(I1 + cos(theta)^2*(I3 - I1)) + I1*theta'^2
    let energy_of_motion = psi_dot * psi_dot * (I1 + cos_theta * cos_theta * (I3 - I1))
        + I1 * theta_dot * theta_dot;
    // phi'*i3_phi_dot + energy_of_motion
    let energy_of_motion_2 = phi_dot.mul_add(i3_phi_dot, energy_of_motion);
    // Values.
    // T = m*x'^2/2 + m*y'^2/2 + m*z'^2/2 + psi'^2*(I1*sin(theta)^2 + I3*cos(theta)^2)/2 + I1*theta'^2/2 +
    //   I3*phi'^2/2 + I3*psi'*phi'*cos(theta)
    let energy = S::ratio(1, 2) * m * z_dot.mul_add(z_dot, x_dot_sq_plus_y_dot_sq)
        + psi_dot * i3_phi_dot * cos_theta + S::ratio(1, 2) * energy_of_motion_2;
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 6],
    q_dot: &[S; 6],
) -> [S; 6] {
    let [_, _, _, _, theta, _] = *q;
    let [x_dot, y_dot, z_dot, psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Values.
    // v1 = x'
    let v1_value = x_dot;
    // v2 = y'
    let v2_value = y_dot;
    // v3 = z'
    let v3_value = z_dot;
    // w1 = theta'
    let w1_value = theta_dot;
    // w2 = psi'*sin(theta)
    let w2_value = psi_dot * sin_theta;
    // w3 = psi'*cos(theta) + phi'
    let w3_value = psi_dot.mul_add(cos_theta, phi_dot);
    [v1_value, v2_value, v3_value, w1_value, w2_value, w3_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 8 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 6],
    q_dot: &[S; 6],
    v_dot: &[S; 6],
) -> [S; 6] {
    let [_, _, _, _, theta, _] = *q;
    let [_, _, _, psi_dot, theta_dot, _] = *q_dot;
    let [x_ddot, y_ddot, z_ddot, psi_ddot, theta_ddot, phi_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let psi_dot_theta_dot = psi_dot * theta_dot;
    // Values.
    // v1' = x''
    let v1_dot_value = x_ddot;
    // v2' = y''
    let v2_dot_value = y_ddot;
    // v3' = z''
    let v3_dot_value = z_ddot;
    // w1' = theta''
    let w1_dot_value = theta_ddot;
    // w2' = psi'*theta'*cos(theta) + psi''*sin(theta)
    let w2_dot_value = psi_dot_theta_dot.mul_add(cos_theta, psi_ddot * sin_theta);
    // w3' = psi''*cos(theta) - psi'*theta'*sin(theta) + phi''
    let w3_dot_value = psi_ddot.mul_add(cos_theta, phi_ddot) - psi_dot_theta_dot * sin_theta;
    [v1_dot_value, v2_dot_value, v3_dot_value, w1_dot_value, w2_dot_value, w3_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn motion_variables<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 6],
    u: &[S; 6],
) -> [S; 6] {
    let [_, _, _, _, theta, _] = *q;
    let [v1, v2, v3, w1, w2, w3] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let w2_sin_theta_inv = w2 / sin_theta;
    // Values.
    // x' = v1
    let x_dot_value = v1;
    // y' = v2
    let y_dot_value = v2;
    // z' = v3
    let z_dot_value = v3;
    // psi' = w2/sin(theta)
    let psi_dot_value = w2_sin_theta_inv;
    // theta' = w1
    let theta_dot_value = w1;
    // phi' = w3 - w2/tan(theta)
    let phi_dot_value = (-w2_sin_theta_inv).mul_add(cos_theta, w3);
    [
        x_dot_value, y_dot_value, z_dot_value, psi_dot_value, theta_dot_value, phi_dot_value,
    ]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 14 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    q_dot: &[S; 6],
) -> ([S; 6], [S; 6]) {
    let Parameters { I1, I3, .. } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [x_dot, y_dot, z_dot, psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let psi_dot_cos_theta = psi_dot * cos_theta;
    // I3*(phi' + psi_dot_cos_theta)/I1
    let psi_ddot_of_motion = I3 * (phi_dot + psi_dot_cos_theta) / I1;
    // psi'' = theta'*(I3*(psi'*cos(theta) + phi')/I1 - 2*psi'*cos(theta))/sin(theta)
    let psi_ddot = theta_dot
        * (-psi_dot_cos_theta).mul_add(S::int(2), psi_ddot_of_motion) / sin_theta;
    let psi_dot_sin_theta = psi_dot * sin_theta;
    // phi'' = psi'*theta'*sin(theta) - psi''*cos(theta)
    let phi_ddot = (-psi_ddot).mul_add(cos_theta, theta_dot * psi_dot_sin_theta);
    // theta'' = psi'*sin(theta)*(psi'*cos(theta) - I3*(psi'*cos(theta) + phi')/I1)
    let theta_ddot = psi_dot_sin_theta * (psi_dot_cos_theta - psi_ddot_of_motion);
    // Values.
    // x'
    let x_dot_value = x_dot;
    // y'
    let y_dot_value = y_dot;
    // z'
    let z_dot_value = z_dot;
    // psi'
    let psi_dot_value = psi_dot;
    // theta'
    let theta_dot_value = theta_dot;
    // phi'
    let phi_dot_value = phi_dot;
    let zero = S::int(0);
    (
        [
            x_dot_value, y_dot_value, z_dot_value, psi_dot_value, theta_dot_value, phi_dot_value,
        ],
        [zero, zero, zero, psi_ddot, theta_ddot, phi_ddot],
    )
}

/// Jacobian of the derivative by the state; columns x, y, z, psi, theta, phi, x', y', z', psi', theta', phi'.
///
/// 45 operations, 1 sine and cosine.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    q_dot: &[S; 6],
) -> [[S; 12]; 12] {
    let Parameters { I1, I3, .. } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [_, _, _, psi_dot, theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_theta_inv = S::int(1) / sin_theta;
    let theta_dot_sin_theta_inv = theta_dot * sin_theta_inv;
    let i1_inv_i3 = I3 / I1;
    let phi_dot_i1_inv_i3 = phi_dot * i1_inv_i3;
    let psi_dot_cos_theta = psi_dot * cos_theta;
    let psi_ddot_of_psi_dot = S::int(2) * psi_dot_cos_theta;
    // phi_dot_i1_inv_i3 - psi_ddot_of_psi_dot
    let psi_ddot_of_motion = phi_dot_i1_inv_i3 - psi_ddot_of_psi_dot;
    // i1_inv_i3*psi_dot_cos_theta + psi_ddot_of_motion
    let psi_ddot_of_motion_2 = i1_inv_i3.mul_add(psi_dot_cos_theta, psi_ddot_of_motion);
    // psi'' = theta'*(I3*(psi'*cos(theta) + phi')/I1 - 2*psi'*cos(theta))/sin(theta)
    let psi_ddot = theta_dot_sin_theta_inv * psi_ddot_of_motion_2;
    // 2 - i1_inv_i3
    let psi_ddot_by_theta_of_i1_i3 = S::int(2) - i1_inv_i3;
    // psi_ddot_by_theta = theta'*(2*psi' - I3*(psi' + phi'*cos(theta))/I1)/sin(theta)^2
    let psi_ddot_by_theta = sin_theta_inv * theta_dot_sin_theta_inv
        * (-phi_dot_i1_inv_i3).mul_add(cos_theta, psi_dot * psi_ddot_by_theta_of_i1_i3);
    // phi_ddot_by_theta = psi''*sin(theta) + cos(theta)*(psi'*theta' - psi_ddot_by_theta)
    let phi_ddot_by_theta = (-psi_ddot_by_theta).mul_add(cos_theta, psi_ddot * sin_theta)
        + theta_dot * psi_dot_cos_theta;
    // i1_inv_i3*psi_ddot_of_psi_dot + psi_ddot_of_motion
    let theta_ddot_by_theta_of_motion = i1_inv_i3
        .mul_add(psi_ddot_of_psi_dot, psi_ddot_of_motion);
    let psi_dot_sq = psi_dot * psi_dot;
    // theta_ddot_by_theta = -psi'*(psi'*(1 - 2*cos(theta)^2 - I3*(1 - 2*cos(theta)^2)/I1) +
    //   I3*phi'*cos(theta)/I1)
    let theta_ddot_by_theta = (-psi_dot_cos_theta)
        .mul_add(theta_ddot_by_theta_of_motion, i1_inv_i3 * psi_dot_sq) - psi_dot_sq;
    // psi_ddot_by_psi_dot = theta'*(I3/I1 - 2)/tan(theta)
    let psi_ddot_by_psi_dot = -theta_dot_sin_theta_inv * psi_ddot_by_theta_of_i1_i3 * cos_theta;
    // phi_ddot_by_psi_dot = theta'*sin(theta) - psi_ddot_by_psi_dot*cos(theta)
    let phi_ddot_by_psi_dot = (-psi_ddot_by_psi_dot)
        .mul_add(cos_theta, theta_dot * sin_theta);
    // theta_ddot_by_psi_dot = sin(theta)*(2*psi'*cos(theta) - I3*(2*psi'*cos(theta) + phi')/I1)
    let theta_ddot_by_psi_dot = -theta_ddot_by_theta_of_motion * sin_theta;
    // psi_ddot_by_theta_dot = (I3*(psi'*cos(theta) + phi')/I1 - 2*psi'*cos(theta))/sin(theta)
    let psi_ddot_by_theta_dot = sin_theta_inv * psi_ddot_of_motion_2;
    let psi_dot_sin_theta = psi_dot * sin_theta;
    // phi_ddot_by_theta_dot = psi'*sin(theta) - psi_ddot_by_theta_dot*cos(theta)
    let phi_ddot_by_theta_dot = (-psi_ddot_by_theta_dot)
        .mul_add(cos_theta, psi_dot_sin_theta);
    // psi_ddot_by_phi_dot = I3*theta'/(I1*sin(theta))
    let psi_ddot_by_phi_dot = theta_dot_sin_theta_inv * i1_inv_i3;
    // theta_ddot_by_phi_dot = -I3*psi'*sin(theta)/I1
    let theta_ddot_by_phi_dot = -i1_inv_i3 * psi_dot_sin_theta;
    // Entries that are not zero.
    // d(x')/d(x') = 1
    let x_dot_by_x_dot_value = S::int(1);
    // d(y')/d(y') = 1
    let y_dot_by_y_dot_value = S::int(1);
    // d(z')/d(z') = 1
    let z_dot_by_z_dot_value = S::int(1);
    // d(psi')/d(psi') = 1
    let psi_dot_by_psi_dot_value = S::int(1);
    // d(theta')/d(theta') = 1
    let theta_dot_by_theta_dot_value = S::int(1);
    // d(phi')/d(phi') = 1
    let phi_dot_by_phi_dot_value = S::int(1);
    // d(phi'')/d(phi') = -psi_ddot_by_phi_dot*cos(theta)
    let phi_ddot_by_phi_dot_value = -psi_ddot_by_phi_dot * cos_theta;
    let zero = S::int(0);
    [
        [
            zero, zero, zero, zero, zero, zero, x_dot_by_x_dot_value, zero, zero, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, y_dot_by_y_dot_value, zero, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, z_dot_by_z_dot_value, zero, zero, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, psi_dot_by_psi_dot_value, zero,
            zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            theta_dot_by_theta_dot_value, zero,
        ],
        [
            zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero,
            phi_dot_by_phi_dot_value,
        ],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero],
        [
            zero, zero, zero, zero, psi_ddot_by_theta, zero, zero, zero, zero, psi_ddot_by_psi_dot,
            psi_ddot_by_theta_dot, psi_ddot_by_phi_dot,
        ],
        [
            zero, zero, zero, zero, theta_ddot_by_theta, zero, zero, zero, zero,
            theta_ddot_by_psi_dot, zero, theta_ddot_by_phi_dot,
        ],
        [
            zero, zero, zero, zero, phi_ddot_by_theta, zero, zero, zero, zero, phi_ddot_by_psi_dot,
            phi_ddot_by_theta_dot, phi_ddot_by_phi_dot_value,
        ],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 6], _q_dot: &[S; 6]) -> [S; 1] {
    let [_, _, _, _, theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // divisor1 = sin(theta)
    let divisor1 = sin_theta;
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (x', y', z', psi', theta', phi') that must act beside the loads of the model for the accelerations to be (x'', y'', z'', psi'', theta'', phi'').
///
/// 29 operations, 1 sine and cosine.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 6],
    q_dot: &[S; 6],
    v_dot: &[S; 6],
) -> [S; 6] {
    let Parameters { m, I1, I3 } = *p;
    let [_, _, _, _, theta, _] = *q;
    let [_, _, _, psi_dot, theta_dot, phi_dot] = *q_dot;
    let [x_ddot, y_ddot, z_ddot, psi_ddot, theta_ddot, phi_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    // I3*(psi''*cos(theta) + phi'')
    let tau4_of_motion = I3 * psi_ddot.mul_add(cos_theta, phi_ddot);
    let i3_theta_dot = I3 * theta_dot;
    let psi_dot_sin_theta = psi_dot * sin_theta;
    // psi_dot_sin_theta*cos(theta)*(I3 - I1)
    let tau4_of_psi_dot = psi_dot_sin_theta * cos_theta * (I3 - I1);
    // Values.
    // tau1 = m*x''
    let tau1 = m * x_ddot;
    // tau2 = m*y''
    let tau2 = m * y_ddot;
    // tau3 = m*z''
    let tau3 = m * z_ddot;
    // tau4 = theta'*sin(theta)*(2*I1*psi'*cos(theta) - I3*(2*psi'*cos(theta) + phi')) +
    //   psi''*(I1*sin(theta)^2 + I3*cos(theta)^2) + I3*phi''*cos(theta)
    let tau4 = sin_theta * (-phi_dot).mul_add(i3_theta_dot, I1 * psi_ddot * sin_theta)
        + tau4_of_motion * cos_theta - S::int(2) * theta_dot * tau4_of_psi_dot;
    // tau5 = psi'*sin(theta)*(I3*(psi'*cos(theta) + phi') - I1*psi'*cos(theta)) + I1*theta''
    let tau5 = (I3 * phi_dot).mul_add(psi_dot_sin_theta, I1 * theta_ddot)
        + psi_dot * tau4_of_psi_dot;
    // tau6 = I3*psi''*cos(theta) - I3*psi'*theta'*sin(theta) + I3*phi''
    let tau6 = (-i3_theta_dot).mul_add(psi_dot_sin_theta, tau4_of_motion);
    [tau1, tau2, tau3, tau4, tau5, tau6]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 9 convolutions and 12 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 12]],
    history: &mut [Factors<S, 16>],
) {
    let Parameters { I1, I3, .. } = *p;
    let [_, _, _, _, theta_0, _, x_dot, y_dot, z_dot, psi_dot_0, theta_dot_0, phi_dot_0,
    ] = series[0];
    // Shared terms.
    let i1_inv_i3 = I3 / I1;
    // Constant in time.
    // i3_by_i1 = I3/I1
    let i3_by_i1 = i1_inv_i3;
    // i3_by_i1_minus_2 = I3/I1 - 2
    let i3_by_i1_minus_2 = i1_inv_i3 - S::int(2);
    // i3_by_i1_minus_1 = I3/I1 - 1
    let i3_by_i1_minus_1 = i1_inv_i3 - S::int(1);
    // Order 0.
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    let over_sin_theta = S::int(1) / sin_theta_0;
    let psi_dot_cos_theta_0 = psi_dot_0 * cos_theta_0;
    let psi_ddot_of_motion_0 = psi_dot_cos_theta_0
        .mul_add(i3_by_i1_minus_2, i3_by_i1 * phi_dot_0);
    let theta_dot_sin_theta_inv_0 = theta_dot_0 * over_sin_theta;
    let psi_dot_dot_0 = psi_ddot_of_motion_0 * theta_dot_sin_theta_inv_0;
    let phi_ddot_of_motion_0 = cos_theta_0 * psi_dot_dot_0;
    let psi_dot_sin_theta_0 = psi_dot_0 * sin_theta_0;
    let phi_ddot_of_motion_2_0 = theta_dot_0 * psi_dot_sin_theta_0;
    let phi_dot_dot_0 = phi_ddot_of_motion_2_0 - phi_ddot_of_motion_0;
    let theta_ddot_of_motion_0 = psi_dot_cos_theta_0
        .mul_add(i3_by_i1_minus_1, i3_by_i1 * phi_dot_0);
    let theta_ddot_of_motion_2_0 = theta_ddot_of_motion_0 * psi_dot_sin_theta_0;
    // Order 1: the rates, and what follows from them.
    let x_1 = x_dot;
    let y_1 = y_dot;
    let z_1 = z_dot;
    let psi_1 = psi_dot_0;
    let theta_1 = theta_dot_0;
    let phi_1 = phi_dot_0;
    let psi_dot_1 = psi_dot_dot_0;
    let theta_dot_1 = -theta_ddot_of_motion_2_0;
    let phi_dot_1 = phi_dot_dot_0;
    if series.len() > 1 {
        series[1] = [
            x_1, y_1, z_1, psi_1, theta_1, phi_1,
            S::int(0),
            S::int(0),
            S::int(0),
            psi_dot_1, theta_dot_1, phi_dot_1,
        ];
    }
    let sin_theta_1 = theta_1 * cos_theta_0;
    let cos_theta_1 = -theta_1 * sin_theta_0;
    let psi_dot_cos_theta_1 = cos_theta_1.mul_add(psi_dot_0, psi_dot_1 * cos_theta_0);
    let psi_ddot_of_motion_1 = psi_dot_cos_theta_1
        .mul_add(i3_by_i1_minus_2, i3_by_i1 * phi_dot_1);
    let theta_dot_sin_theta_inv_1 = sin_theta_1
        .mul_add(
            -(theta_dot_sin_theta_inv_0 * over_sin_theta),
            theta_dot_1 * over_sin_theta,
        );
    let psi_dot_dot_1 = psi_ddot_of_motion_1
        .mul_add(
            theta_dot_sin_theta_inv_0,
            theta_dot_sin_theta_inv_1 * psi_ddot_of_motion_0,
        );
    let phi_ddot_of_motion_1 = psi_dot_dot_1
        .mul_add(cos_theta_0, cos_theta_1 * psi_dot_dot_0);
    let psi_dot_sin_theta_1 = sin_theta_1.mul_add(psi_dot_0, psi_dot_1 * sin_theta_0);
    let phi_ddot_of_motion_2_1 = psi_dot_sin_theta_1
        .mul_add(theta_dot_0, theta_dot_1 * psi_dot_sin_theta_0);
    let phi_dot_dot_1 = phi_ddot_of_motion_2_1 - phi_ddot_of_motion_1;
    let theta_ddot_of_motion_1 = psi_dot_cos_theta_1
        .mul_add(i3_by_i1_minus_1, i3_by_i1 * phi_dot_1);
    let theta_ddot_of_motion_2_1 = theta_ddot_of_motion_1
        .mul_add(psi_dot_sin_theta_0, psi_dot_sin_theta_1 * theta_ddot_of_motion_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                theta_1, theta_1, psi_dot_1, sin_theta_1, psi_ddot_of_motion_1, cos_theta_1,
                psi_dot_1, theta_dot_1, theta_ddot_of_motion_1,
            ]),
            padded([
                cos_theta_1, sin_theta_1, cos_theta_1, theta_dot_sin_theta_inv_1,
                theta_dot_sin_theta_inv_1, psi_dot_dot_1, sin_theta_1, psi_dot_sin_theta_1,
                psi_dot_sin_theta_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta_last = theta_1;
    let mut psi_dot_last = psi_dot_1;
    let mut theta_dot_last = theta_dot_1;
    let mut sin_theta_last = sin_theta_1;
    let mut cos_theta_last = cos_theta_1;
    let mut psi_ddot_of_motion_last = psi_ddot_of_motion_1;
    let mut theta_dot_sin_theta_inv_last = theta_dot_sin_theta_inv_1;
    let mut psi_dot_dot_last = psi_dot_dot_1;
    let mut psi_dot_sin_theta_last = psi_dot_sin_theta_1;
    let mut theta_ddot_of_motion_last = theta_ddot_of_motion_1;
    let mut next = [S::int(0); 16];
    // Rates at order k - 1.
    let mut x_rate = S::int(0);
    let mut y_rate = S::int(0);
    let mut z_rate = S::int(0);
    let mut psi_rate = psi_dot_1;
    let mut theta_rate = theta_dot_1;
    let mut phi_rate = phi_dot_1;
    let mut psi_dot_rate = psi_dot_dot_1;
    let mut theta_dot_rate = -theta_ddot_of_motion_2_1;
    let mut phi_dot_rate = phi_dot_dot_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let x = x_rate * over_k;
        let y = y_rate * over_k;
        let z = z_rate * over_k;
        let psi = psi_rate * over_k;
        let theta = theta_rate * over_k;
        let phi = phi_rate * over_k;
        let psi_dot = psi_dot_rate * over_k;
        let theta_dot = theta_dot_rate * over_k;
        let phi_dot = phi_dot_rate * over_k;
        series[order] = [
            x, y, z, psi, theta, phi,
            S::int(0),
            S::int(0),
            S::int(0),
            psi_dot, theta_dot, phi_dot,
        ];
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
                theta_1
                    .mul_add(
                        cos_theta_last,
                        (count_last * theta_last).mul_add(cos_theta_1, next[0]),
                    ),
                theta_1
                    .mul_add(
                        sin_theta_last,
                        (count_last * theta_last).mul_add(sin_theta_1, next[1]),
                    ),
                psi_dot_1
                    .mul_add(cos_theta_last, psi_dot_last.mul_add(cos_theta_1, next[2])),
                sin_theta_1
                    .mul_add(
                        theta_dot_sin_theta_inv_last,
                        sin_theta_last.mul_add(theta_dot_sin_theta_inv_1, next[3]),
                    ),
                psi_ddot_of_motion_1
                    .mul_add(
                        theta_dot_sin_theta_inv_last,
                        psi_ddot_of_motion_last
                            .mul_add(theta_dot_sin_theta_inv_1, next[4]),
                    ),
                cos_theta_1
                    .mul_add(
                        psi_dot_dot_last,
                        cos_theta_last.mul_add(psi_dot_dot_1, next[5]),
                    ),
                psi_dot_1
                    .mul_add(sin_theta_last, psi_dot_last.mul_add(sin_theta_1, next[6])),
                theta_dot_1
                    .mul_add(
                        psi_dot_sin_theta_last,
                        theta_dot_last.mul_add(psi_dot_sin_theta_1, next[7]),
                    ),
                theta_ddot_of_motion_1
                    .mul_add(
                        psi_dot_sin_theta_last,
                        theta_ddot_of_motion_last.mul_add(psi_dot_sin_theta_1, next[8]),
                    ),
            ])
        };
        // sin_theta = sin(theta)
        let sin_theta = theta.mul_add(cos_theta_0, sums[0] * over_k);
        // cos_theta = cos(theta)
        let cos_theta = -theta.mul_add(sin_theta_0, sums[1] * over_k);
        // psi_dot_cos_theta = psi_dot*cos_theta
        let psi_dot_cos_theta = cos_theta
            .mul_add(psi_dot_0, psi_dot.mul_add(cos_theta_0, sums[2]));
        // psi_ddot_of_motion = i3_by_i1*phi_dot + i3_by_i1_minus_2*psi_dot_cos_theta
        let psi_ddot_of_motion = psi_dot_cos_theta
            .mul_add(i3_by_i1_minus_2, i3_by_i1 * phi_dot);
        // theta_dot_sin_theta_inv = theta_dot/sin_theta
        let theta_dot_sin_theta_inv = sin_theta
            .mul_add(
                -(theta_dot_sin_theta_inv_0 * over_sin_theta),
                (theta_dot - sums[3]) * over_sin_theta,
            );
        // psi_dot_dot = psi_ddot_of_motion*theta_dot_sin_theta_inv
        let psi_dot_dot = psi_ddot_of_motion
            .mul_add(
                theta_dot_sin_theta_inv_0,
                theta_dot_sin_theta_inv.mul_add(psi_ddot_of_motion_0, sums[4]),
            );
        // phi_ddot_of_motion = cos_theta*psi_dot_dot
        let phi_ddot_of_motion = psi_dot_dot
            .mul_add(cos_theta_0, cos_theta.mul_add(psi_dot_dot_0, sums[5]));
        // psi_dot_sin_theta = psi_dot*sin_theta
        let psi_dot_sin_theta = sin_theta
            .mul_add(psi_dot_0, psi_dot.mul_add(sin_theta_0, sums[6]));
        // phi_ddot_of_motion_2 = theta_dot*psi_dot_sin_theta
        let phi_ddot_of_motion_2 = psi_dot_sin_theta
            .mul_add(theta_dot_0, theta_dot.mul_add(psi_dot_sin_theta_0, sums[7]));
        // phi_dot_dot = -phi_ddot_of_motion + phi_ddot_of_motion_2
        let phi_dot_dot = phi_ddot_of_motion_2 - phi_ddot_of_motion;
        // theta_ddot_of_motion = i3_by_i1*phi_dot + i3_by_i1_minus_1*psi_dot_cos_theta
        let theta_ddot_of_motion = psi_dot_cos_theta
            .mul_add(i3_by_i1_minus_1, i3_by_i1 * phi_dot);
        // theta_ddot_of_motion_2 = theta_ddot_of_motion*psi_dot_sin_theta
        let theta_ddot_of_motion_2 = theta_ddot_of_motion
            .mul_add(
                psi_dot_sin_theta_0,
                psi_dot_sin_theta.mul_add(theta_ddot_of_motion_0, sums[8]),
            );
        x_rate = S::int(0);
        y_rate = S::int(0);
        z_rate = S::int(0);
        psi_rate = psi_dot;
        theta_rate = theta_dot;
        phi_rate = phi_dot;
        psi_dot_rate = psi_dot_dot;
        theta_dot_rate = -theta_ddot_of_motion_2;
        phi_dot_rate = phi_dot_dot;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * theta,
                count * theta,
                psi_dot, sin_theta, psi_ddot_of_motion, cos_theta, psi_dot, theta_dot,
                theta_ddot_of_motion,
            ]),
            padded([
                cos_theta, sin_theta, cos_theta, theta_dot_sin_theta_inv, theta_dot_sin_theta_inv,
                psi_dot_dot, sin_theta, psi_dot_sin_theta, psi_dot_sin_theta,
            ]),
        ];
        count_last = count;
        theta_last = theta;
        psi_dot_last = psi_dot;
        theta_dot_last = theta_dot;
        sin_theta_last = sin_theta;
        cos_theta_last = cos_theta;
        psi_ddot_of_motion_last = psi_ddot_of_motion;
        theta_dot_sin_theta_inv_last = theta_dot_sin_theta_inv;
        psi_dot_dot_last = psi_dot_dot;
        psi_dot_sin_theta_last = psi_dot_sin_theta;
        theta_ddot_of_motion_last = theta_ddot_of_motion;
    }
}

/// Lagrange's equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Lagrange;

impl<S: Scalar> System<S> for Lagrange {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 3,
            coordinates: 6,
            variables: 6,
            speeds: 6,
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
        12
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
        ["sin(theta)"][at]
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
