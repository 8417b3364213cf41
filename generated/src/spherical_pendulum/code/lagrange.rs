//! Spherical pendulum: Lagrange's equations, E(q) q'' = A(q, q').
//!
//! Generated from `models/spherical_pendulum/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system E(q) q'' = A(q, q'); symmetric, rows theta, phi.
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _q_dot: &[S; 2],
) -> [[S; 2]; 2] {
    let Parameters { m, l, .. } = *p;
    let [theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Shared terms.
    let m_l_sq = m * l * l;
    // Entries that are not zero; upper triangle.
    // M11 = m*l^2
    let m11 = m_l_sq;
    // M22 = m*l^2*sin(theta)^2
    let m22 = m_l_sq * sin_theta * sin_theta;
    let zero = S::int(0);
    [[m11, zero], [zero, m22]]
}

/// Right-hand side of the linear system; unknowns (theta'', phi'').
///
/// 11 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> [S; 2] {
    let Parameters { m, l, g } = *p;
    let [theta, _] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let l_phi_dot_cos_theta = l * phi_dot * cos_theta;
    let m_l_sin_theta = m * l * sin_theta;
    // Values.
    // f1 = m*l*sin(theta)*(l*phi'^2*cos(theta) - g)
    let f1 = m_l_sin_theta * phi_dot.mul_add(l_phi_dot_cos_theta, -g);
    // f2 = -2*m*l^2*theta'*phi'*sin(theta)*cos(theta)
    let f2 = -S::int(2) * theta_dot * l_phi_dot_cos_theta * m_l_sin_theta;
    [f1, f2]
}

/// The accelerations (theta'', phi''), solved for when this code was generated.
///
/// 9 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { l, g, .. } = *p;
    let [theta, _] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let phi_dot_cos_theta = phi_dot * cos_theta;
    // phi'' = -2*theta'*phi'/tan(theta)
    let phi_ddot = -S::int(2) * theta_dot * phi_dot_cos_theta / sin_theta;
    // theta'' = sin(theta)*(phi'^2*cos(theta) - g/l)
    let theta_ddot = sin_theta * phi_dot.mul_add(phi_dot_cos_theta, -g / l);
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
/// 8 operations, 1 sine and cosine.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> S {
    let Parameters { m, l, .. } = *p;
    let [theta, _] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Shared terms.
    let phi_dot_sin_theta = phi_dot * sin_theta;
    // Values.
    // T = m*l^2*theta'^2/2 + m*l^2*phi'^2*sin(theta)^2/2
    let energy = S::ratio(1, 2) * m * l * l
        * phi_dot_sin_theta.mul_add(phi_dot_sin_theta, theta_dot * theta_dot);
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 1 operation, 1 sine and cosine.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let [theta, _] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // u1 = theta'
    let u1_value = theta_dot;
    // u2 = phi'*sin(theta)
    let u2_value = phi_dot * sin_theta;
    [u1_value, u2_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let [theta, _] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    let [theta_ddot, phi_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Values.
    // u1' = theta''
    let u1_dot_value = theta_ddot;
    // u2' = theta'*phi'*cos(theta) + phi''*sin(theta)
    let u2_dot_value = phi_ddot.mul_add(sin_theta, theta_dot * phi_dot * cos_theta);
    [u1_dot_value, u2_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 1 operation, 1 sine and cosine.
#[must_use]
pub fn motion_variables<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
) -> [S; 2] {
    let [theta, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // theta' = u1
    let theta_dot_value = u1;
    // phi' = u2/sin(theta)
    let phi_dot_value = u2 / sin_theta;
    [theta_dot_value, phi_dot_value]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 9 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let Parameters { l, g, .. } = *p;
    let [theta, _] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let phi_dot_cos_theta = phi_dot * cos_theta;
    // phi'' = -2*theta'*phi'/tan(theta)
    let phi_ddot = -S::int(2) * theta_dot * phi_dot_cos_theta / sin_theta;
    // theta'' = sin(theta)*(phi'^2*cos(theta) - g/l)
    let theta_ddot = sin_theta * phi_dot.mul_add(phi_dot_cos_theta, -g / l);
    // Values.
    // theta'
    let theta_dot_value = theta_dot;
    // phi'
    let phi_dot_value = phi_dot;
    ([theta_dot_value, phi_dot_value], [theta_ddot, phi_ddot])
}

/// Jacobian of the derivative by the state; columns theta, phi, theta', phi'.
///
/// 18 operations, 1 sine and cosine.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [[S; 4]; 4] {
    let Parameters { l, g, .. } = *p;
    let [theta, _] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_theta_inv = S::int(1) / sin_theta;
    let phi_dot_doubled = S::int(2) * phi_dot;
    let theta_dot_sin_theta_inv = theta_dot * sin_theta_inv;
    // phi_ddot_by_theta = 2*theta'*phi'/sin(theta)^2
    let phi_ddot_by_theta = sin_theta_inv * phi_dot_doubled * theta_dot_sin_theta_inv;
    let theta_ddot_by_theta_of_phi_dot = phi_dot_doubled * cos_theta;
    // theta_ddot_by_theta = phi'^2*(2*cos(theta)^2 - 1) - g*cos(theta)/l
    let theta_ddot_by_theta = phi_dot * theta_ddot_by_theta_of_phi_dot.mul_add(cos_theta, -phi_dot)
        - g * cos_theta / l;
    // phi_ddot_by_theta_dot = -2*phi'/tan(theta)
    let phi_ddot_by_theta_dot = -sin_theta_inv * theta_ddot_by_theta_of_phi_dot;
    // phi_ddot_by_phi_dot = -2*theta'/tan(theta)
    let phi_ddot_by_phi_dot = -S::int(2) * theta_dot_sin_theta_inv * cos_theta;
    // theta_ddot_by_phi_dot = 2*phi'*sin(theta)*cos(theta)
    let theta_ddot_by_phi_dot = theta_ddot_by_theta_of_phi_dot * sin_theta;
    // Entries that are not zero.
    // d(theta')/d(theta') = 1
    let theta_dot_by_theta_dot_value = S::int(1);
    // d(phi')/d(phi') = 1
    let phi_dot_by_phi_dot_value = S::int(1);
    let zero = S::int(0);
    [
        [zero, zero, theta_dot_by_theta_dot_value, zero],
        [zero, zero, zero, phi_dot_by_phi_dot_value],
        [theta_ddot_by_theta, zero, zero, theta_ddot_by_phi_dot],
        [phi_ddot_by_theta, zero, phi_ddot_by_theta_dot, phi_ddot_by_phi_dot],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 2], _q_dot: &[S; 2]) -> [S; 1] {
    let [theta, _] = *q;
    // Sines and cosines.
    let (sin_theta, _) = theta.sin_cos();
    // Values.
    // divisor1 = sin(theta)
    let divisor1 = sin_theta;
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (theta', phi') that must act beside the loads of the model for the accelerations to be (theta'', phi'').
///
/// 16 operations, 1 sine and cosine.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { m, l, g } = *p;
    let [theta, _] = *q;
    let [theta_dot, phi_dot] = *q_dot;
    let [theta_ddot, phi_ddot] = *v_dot;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    let m_l = m * l;
    let phi_dot_cos_theta = phi_dot * cos_theta;
    // Values.
    // tau1 = m*l*sin(theta)*(g - l*phi'^2*cos(theta)) + m*l^2*theta''
    let tau1 = m_l * (sin_theta * (-(l * phi_dot)).mul_add(phi_dot_cos_theta, g) + l * theta_ddot);
    // tau2 = 2*m*l^2*theta'*phi'*sin(theta)*cos(theta) + m*l^2*phi''*sin(theta)^2
    let tau2 = l * m_l * sin_theta
        * (theta_dot * phi_dot_cos_theta).mul_add(S::int(2), phi_ddot * sin_theta);
    [tau1, tau2]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 7 convolutions and 2 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 4]],
    history: &mut [Factors<S, 8>],
) {
    let Parameters { l, g, .. } = *p;
    let [theta_0, _, theta_dot_0, phi_dot_0] = series[0];
    // Constant in time.
    // g_by_l = g/l
    let g_by_l = g / l;
    // Order 0.
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    let over_sin_theta = S::int(1) / sin_theta_0;
    let phi_dot_cos_theta_0 = phi_dot_0 * cos_theta_0;
    let theta_dot_sin_theta_inv_0 = theta_dot_0 * over_sin_theta;
    let phi_ddot_of_motion_0 = phi_dot_cos_theta_0 * theta_dot_sin_theta_inv_0;
    let phi_dot_sq_cos_theta_0 = phi_dot_0 * phi_dot_cos_theta_0;
    let theta_ddot_of_phi_dot_0 = g_by_l - phi_dot_sq_cos_theta_0;
    let theta_ddot_of_phi_dot_2_0 = sin_theta_0 * theta_ddot_of_phi_dot_0;
    // Order 1: the rates, and what follows from them.
    let theta_1 = theta_dot_0;
    let phi_1 = phi_dot_0;
    let theta_dot_1 = -theta_ddot_of_phi_dot_2_0;
    let phi_dot_1 = -S::int(2) * phi_ddot_of_motion_0;
    if series.len() > 1 {
        series[1] = [theta_1, phi_1, theta_dot_1, phi_dot_1];
    }
    let sin_theta_1 = theta_1 * cos_theta_0;
    let cos_theta_1 = -theta_1 * sin_theta_0;
    let phi_dot_cos_theta_1 = cos_theta_1.mul_add(phi_dot_0, phi_dot_1 * cos_theta_0);
    let theta_dot_sin_theta_inv_1 = sin_theta_1
        .mul_add(
            -(theta_dot_sin_theta_inv_0 * over_sin_theta),
            theta_dot_1 * over_sin_theta,
        );
    let phi_ddot_of_motion_1 = theta_dot_sin_theta_inv_1
        .mul_add(phi_dot_cos_theta_0, phi_dot_cos_theta_1 * theta_dot_sin_theta_inv_0);
    let phi_dot_sq_cos_theta_1 = phi_dot_cos_theta_1
        .mul_add(phi_dot_0, phi_dot_1 * phi_dot_cos_theta_0);
    let theta_ddot_of_phi_dot_1 = -phi_dot_sq_cos_theta_1;
    let theta_ddot_of_phi_dot_2_1 = theta_ddot_of_phi_dot_1
        .mul_add(sin_theta_0, sin_theta_1 * theta_ddot_of_phi_dot_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                theta_1, theta_1, phi_dot_1, sin_theta_1, phi_dot_cos_theta_1, phi_dot_1,
                sin_theta_1,
            ]),
            padded([
                cos_theta_1, sin_theta_1, cos_theta_1, theta_dot_sin_theta_inv_1,
                theta_dot_sin_theta_inv_1, phi_dot_cos_theta_1, theta_ddot_of_phi_dot_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta_last = theta_1;
    let mut phi_dot_last = phi_dot_1;
    let mut sin_theta_last = sin_theta_1;
    let mut cos_theta_last = cos_theta_1;
    let mut phi_dot_cos_theta_last = phi_dot_cos_theta_1;
    let mut theta_dot_sin_theta_inv_last = theta_dot_sin_theta_inv_1;
    let mut theta_ddot_of_phi_dot_last = theta_ddot_of_phi_dot_1;
    let mut next = [S::int(0); 8];
    // Rates at order k - 1.
    let mut theta_rate = theta_dot_1;
    let mut phi_rate = phi_dot_1;
    let mut theta_dot_rate = -theta_ddot_of_phi_dot_2_1;
    let mut phi_dot_rate = -S::int(2) * phi_ddot_of_motion_1;
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
                phi_dot_1
                    .mul_add(cos_theta_last, phi_dot_last.mul_add(cos_theta_1, next[2])),
                sin_theta_1
                    .mul_add(
                        theta_dot_sin_theta_inv_last,
                        sin_theta_last.mul_add(theta_dot_sin_theta_inv_1, next[3]),
                    ),
                phi_dot_cos_theta_1
                    .mul_add(
                        theta_dot_sin_theta_inv_last,
                        phi_dot_cos_theta_last
                            .mul_add(theta_dot_sin_theta_inv_1, next[4]),
                    ),
                phi_dot_1
                    .mul_add(
                        phi_dot_cos_theta_last,
                        phi_dot_last.mul_add(phi_dot_cos_theta_1, next[5]),
                    ),
                sin_theta_1
                    .mul_add(
                        theta_ddot_of_phi_dot_last,
                        sin_theta_last.mul_add(theta_ddot_of_phi_dot_1, next[6]),
                    ),
            ])
        };
        // sin_theta = sin(theta)
        let sin_theta = theta.mul_add(cos_theta_0, sums[0] * over_k);
        // cos_theta = cos(theta)
        let cos_theta = -theta.mul_add(sin_theta_0, sums[1] * over_k);
        // phi_dot_cos_theta = phi_dot*cos_theta
        let phi_dot_cos_theta = cos_theta
            .mul_add(phi_dot_0, phi_dot.mul_add(cos_theta_0, sums[2]));
        // theta_dot_sin_theta_inv = theta_dot/sin_theta
        let theta_dot_sin_theta_inv = sin_theta
            .mul_add(
                -(theta_dot_sin_theta_inv_0 * over_sin_theta),
                (theta_dot - sums[3]) * over_sin_theta,
            );
        // phi_ddot_of_motion = phi_dot_cos_theta*theta_dot_sin_theta_inv
        let phi_ddot_of_motion = theta_dot_sin_theta_inv
            .mul_add(
                phi_dot_cos_theta_0,
                phi_dot_cos_theta.mul_add(theta_dot_sin_theta_inv_0, sums[4]),
            );
        // phi_dot_sq_cos_theta = phi_dot*phi_dot_cos_theta
        let phi_dot_sq_cos_theta = phi_dot_cos_theta
            .mul_add(phi_dot_0, phi_dot.mul_add(phi_dot_cos_theta_0, sums[5]));
        // theta_ddot_of_phi_dot = g_by_l - phi_dot_sq_cos_theta
        let theta_ddot_of_phi_dot = -phi_dot_sq_cos_theta;
        // theta_ddot_of_phi_dot_2 = sin_theta*theta_ddot_of_phi_dot
        let theta_ddot_of_phi_dot_2 = theta_ddot_of_phi_dot
            .mul_add(sin_theta_0, sin_theta.mul_add(theta_ddot_of_phi_dot_0, sums[6]));
        theta_rate = theta_dot;
        phi_rate = phi_dot;
        theta_dot_rate = -theta_ddot_of_phi_dot_2;
        phi_dot_rate = -S::int(2) * phi_ddot_of_motion;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * theta,
                count * theta,
                phi_dot, sin_theta, phi_dot_cos_theta, phi_dot, sin_theta,
            ]),
            padded([
                cos_theta, sin_theta, cos_theta, theta_dot_sin_theta_inv, theta_dot_sin_theta_inv,
                phi_dot_cos_theta, theta_ddot_of_phi_dot,
            ]),
        ];
        count_last = count;
        theta_last = theta;
        phi_dot_last = phi_dot;
        sin_theta_last = sin_theta;
        cos_theta_last = cos_theta;
        phi_dot_cos_theta_last = phi_dot_cos_theta;
        theta_dot_sin_theta_inv_last = theta_dot_sin_theta_inv;
        theta_ddot_of_phi_dot_last = theta_ddot_of_phi_dot;
    }
}

/// Lagrange's equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Lagrange;

impl<S: Scalar> System<S> for Lagrange {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 3,
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
        16 * order + SLACK
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
