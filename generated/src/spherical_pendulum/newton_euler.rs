//! Spherical pendulum: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/spherical_pendulum/model.toml`. Do not edit; run `tripos regenerate`.
//! 2 coordinates, 2 speeds, 3 parameters, 1 reaction. Unknowns: (u1', u2', rod).
//! Cost: mass_matrix 11 operations, 2 sines and cosines; forcing 20 operations, 2 sines and cosines; accelerations 8 operations, 1 sine and cosine.
//! The kinematic equations are singular where sin(theta) = 0.
//! The accelerations divide by sin(theta), by l.

use super::Parameters;
use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows bob force n1, bob force n2, bob force n3.
///
/// 11 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _u: &[S; 2],
) -> [[S; 3]; 3] {
    let Parameters { m, l, .. } = *p;
    let [theta, phi] = *q;
    let zero = S::int(0);
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Shared terms.
    // m*l; used 4 times
    let m_l = m * l;
    // m_l*cos(theta); used 2 times
    let cos_theta_m_l = m_l * cos_theta;
    // Entries that are not zero.
    // M11 = m*l*cos(theta)*cos(phi)
    let m11 = cos_theta_m_l * cos_phi;
    // M12 = -m*l*sin(phi)
    let m12 = -m_l * sin_phi;
    // M13 = sin(theta)*cos(phi)
    let m13 = sin_theta * cos_phi;
    // M21 = m*l*cos(theta)*sin(phi)
    let m21 = cos_theta_m_l * sin_phi;
    // M22 = m*l*cos(phi)
    let m22 = m_l * cos_phi;
    // M23 = sin(theta)*sin(phi)
    let m23 = sin_theta * sin_phi;
    // M31 = m*l*sin(theta)
    let m31 = m_l * sin_theta;
    // M33 = -cos(theta)
    let m33 = -cos_theta;
    [[m11, m12, m13], [m21, m22, m23], [m31, zero, m33]]
}

/// Right-hand side of the linear system; unknowns (u1', u2', rod).
///
/// 20 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 3] {
    let Parameters { m, l, g } = *p;
    let [theta, phi] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    let (sin_phi, cos_phi) = phi.sin_cos();
    // Shared terms.
    // u2/sin(theta); used 2 times
    let u2_sin_theta_inv = u2 / sin_theta;
    // m*l; used 2 times
    let m_l = m * l;
    // m_l*(u1^2*sin(theta) + u2*u2_sin_theta_inv); used 2 times
    let f1_part = m_l * u2.mul_add(u2_sin_theta_inv, u1 * u1 * sin_theta);
    // u1*m_l*cos(theta); used 2 times
    let u1_cos_theta_m_l = u1 * m_l * cos_theta;
    // u2_sin_theta_inv*u1_cos_theta_m_l; used 2 times
    let f1_part_2 = u2_sin_theta_inv * u1_cos_theta_m_l;
    // Values.
    // f1 = m*l*(u2^2*cos(phi)/sin(theta) + u1*(u1*sin(theta)*cos(phi) + u2*sin(phi)/tan(theta)))
    let f1 = f1_part_2.mul_add(sin_phi, f1_part * cos_phi);
    // f2 = m*l*(u2^2*sin(phi)/sin(theta) + u1*(u1*sin(theta)*sin(phi) - u2*cos(phi)/tan(theta)))
    let f2 = (-f1_part_2).mul_add(cos_phi, f1_part * sin_phi);
    // f3 = -m*(g + l*u1^2*cos(theta))
    let f3 = (-u1).mul_add(u1_cos_theta_m_l, -m * g);
    [f1, f2, f3]
}

/// The accelerations (u1', u2'), solved for when this code was generated.
///
/// 8 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [S; 2] {
    let Parameters { l, g, .. } = *p;
    let [theta, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    // tan(theta)
    let tan_theta = sin_theta / cos_theta;
    // u2/tan(theta); used 2 times
    let u2_by_tan_theta = u2 / tan_theta;
    // Elimination, step by step.
    // u2' = -u1*u2/tan(theta)
    let u2_dot = -u1 * u2_by_tan_theta;
    // u1' = u2^2/tan(theta) - g*sin(theta)/l
    let u1_dot = u2.mul_add(u2_by_tan_theta, -g * sin_theta / l);
    [u1_dot, u2_dot]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 8 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let Parameters { l, g, .. } = *p;
    let [theta, _] = *q;
    let [u1, u2] = *u;
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    // u2/sin(theta); used 2 times
    let u2_sin_theta_inv = u2 / sin_theta;
    // u2_sin_theta_inv*cos(theta); used 2 times
    let u2_dot_part = u2_sin_theta_inv * cos_theta;
    // Elimination, step by step.
    // u2' = -u1*u2/tan(theta)
    let u2_dot = -u1 * u2_dot_part;
    // u1' = u2^2/tan(theta) - g*sin(theta)/l
    let u1_dot = u2.mul_add(u2_dot_part, -g * sin_theta / l);
    // Values.
    // theta' = u1
    let theta_dot_value = u1;
    // phi' = u2/sin(theta)
    let phi_dot_value = u2_sin_theta_inv;
    ([theta_dot_value, phi_dot_value], [u1_dot, u2_dot])
}

/// Jacobian of the derivative by the state; columns theta, phi, u1, u2.
///
/// 16 operations, 1 sine and cosine.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 2]) -> [[S; 4]; 4] {
    let Parameters { l, g, .. } = *p;
    let [theta, _] = *q;
    let [u1, u2] = *u;
    let zero = S::int(0);
    // Sines and cosines.
    let (sin_theta, cos_theta) = theta.sin_cos();
    // Shared terms.
    // 1/sin(theta); used 4 times
    let sin_theta_inv = S::int(1) / sin_theta;
    // u2*sin_theta_inv; used 3 times
    let u2_sin_theta_inv = u2 * sin_theta_inv;
    // u1*sin_theta_inv; used 2 times
    let u1_sin_theta_inv = u1 * sin_theta_inv;
    // Elimination, step by step.
    // u2_dot_by_theta = u1*u2/sin(theta)^2
    let u2_dot_by_theta = u2_sin_theta_inv * u1_sin_theta_inv;
    // u1_dot_by_theta = -g*cos(theta)/l - u2^2/sin(theta)^2
    let u1_dot_by_theta = (-u2_sin_theta_inv)
        .mul_add(u2_sin_theta_inv, -g * cos_theta / l);
    // Shared terms.
    // u2_sin_theta_inv*cos(theta); used 3 times
    let u2_dot_by_u1_part = u2_sin_theta_inv * cos_theta;
    // Elimination, step by step.
    // u2_dot_by_u1 = -u2/tan(theta)
    let u2_dot_by_u1 = -u2_dot_by_u1_part;
    // u2_dot_by_u2 = -u1/tan(theta)
    let u2_dot_by_u2 = -u1_sin_theta_inv * cos_theta;
    // u1_dot_by_u2 = 2*u2/tan(theta)
    let u1_dot_by_u2 = S::int(2) * u2_dot_by_u1_part;
    // Entries that are not zero.
    // d(theta')/d(u1) = 1
    let theta_dot_by_u1_value = S::int(1);
    // d(phi')/d(theta) = -u2/(sin(theta)*tan(theta))
    let phi_dot_by_theta_value = -sin_theta_inv * u2_dot_by_u1_part;
    // d(phi')/d(u2) = 1/sin(theta)
    let phi_dot_by_u2_value = sin_theta_inv;
    [
        [zero, zero, theta_dot_by_u1_value, zero],
        [phi_dot_by_theta_value, zero, zero, phi_dot_by_u2_value],
        [u1_dot_by_theta, zero, zero, u1_dot_by_u2],
        [u2_dot_by_theta, zero, u2_dot_by_u1, u2_dot_by_u2],
    ]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 1 operation, 1 sine and cosine.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
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

/// Kinetic energy T.
///
/// 7 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 2], u: &[S; 2]) -> S {
    let Parameters { m, l, .. } = *p;
    let [u1, u2] = *u;
    // Values.
    // T = m*l^2*u1^2/2 + m*l^2*u2^2/2
    let energy = S::ratio(1, 2) * m * l * l * u2.mul_add(u2, u1 * u1);
    energy
}

/// Potential energy V of gravity.
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2]) -> S {
    let Parameters { m, l, g } = *p;
    let [theta, _] = *q;
    // Sines and cosines.
    let (_, cos_theta) = theta.sin_cos();
    // Values.
    // V = m*l*g*(1 - cos(theta))
    let energy = m * l * g * (S::int(1) - cos_theta);
    energy
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 6 convolutions and 4 linear operations an order.
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 4]],
    history: &mut [Factors<S, 8>],
) {
    let Parameters { l, g, .. } = *p;
    let [theta_0, _, u1_0, u2_0] = series[0];
    // Constant in time.
    // minus_g_by_l = -g/l
    let minus_g_by_l = -g / l;
    // Order 0.
    let (sin_theta_0, cos_theta_0) = theta_0.sin_cos();
    let over_sin_theta = S::int(1) / sin_theta_0;
    // phi_dot_2 = u2/sin_theta
    let phi_dot_2_0 = u2_0 * over_sin_theta;
    // u2_by_tan_theta = cos_theta*phi_dot_2
    let u2_by_tan_theta_0 = cos_theta_0 * phi_dot_2_0;
    // u1_u2_by_tan_theta = u1*u2_by_tan_theta
    let u1_u2_by_tan_theta_0 = u1_0 * u2_by_tan_theta_0;
    // u2_p2_by_tan_theta = u2*u2_by_tan_theta
    let u2_p2_by_tan_theta_0 = u2_0 * u2_by_tan_theta_0;
    // u1_dot_2 = minus_g_by_l*sin_theta + u2_p2_by_tan_theta
    let u1_dot_2_0 = minus_g_by_l * sin_theta_0 + u2_p2_by_tan_theta_0;
    // Order 1: the rates, and what follows from them.
    let theta_1 = u1_0;
    let phi_1 = phi_dot_2_0;
    let u1_1 = u1_dot_2_0;
    let u2_1 = -u1_u2_by_tan_theta_0;
    if series.len() > 1 {
        series[1] = [theta_1, phi_1, u1_1, u2_1];
    }
    let sin_theta_1 = theta_1 * cos_theta_0;
    let cos_theta_1 = -theta_1 * sin_theta_0;
    let phi_dot_2_1 = sin_theta_1
        .mul_add(-(phi_dot_2_0 * over_sin_theta), u2_1 * over_sin_theta);
    let u2_by_tan_theta_1 = phi_dot_2_1.mul_add(cos_theta_0, cos_theta_1 * phi_dot_2_0);
    let u1_u2_by_tan_theta_1 = u2_by_tan_theta_1.mul_add(u1_0, u1_1 * u2_by_tan_theta_0);
    let u2_p2_by_tan_theta_1 = u2_by_tan_theta_1.mul_add(u2_0, u2_1 * u2_by_tan_theta_0);
    let u1_dot_2_1 = minus_g_by_l * sin_theta_1 + u2_p2_by_tan_theta_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([theta_1, theta_1, sin_theta_1, cos_theta_1, u1_1, u2_1]),
            padded([
                cos_theta_1,
                sin_theta_1,
                phi_dot_2_1,
                phi_dot_2_1,
                u2_by_tan_theta_1,
                u2_by_tan_theta_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut theta_last = theta_1;
    let mut u1_last = u1_1;
    let mut u2_last = u2_1;
    let mut sin_theta_last = sin_theta_1;
    let mut cos_theta_last = cos_theta_1;
    let mut phi_dot_2_last = phi_dot_2_1;
    let mut u2_by_tan_theta_last = u2_by_tan_theta_1;
    let mut next = [S::int(0); 8];
    // Rates at order k - 1.
    let mut theta_rate = u1_1;
    let mut phi_rate = phi_dot_2_1;
    let mut u1_rate = u1_dot_2_1;
    let mut u2_rate = -u1_u2_by_tan_theta_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let theta = theta_rate * over_k;
        let phi = phi_rate * over_k;
        let u1 = u1_rate * over_k;
        let u2 = u2_rate * over_k;
        series[order] = [theta, phi, u1, u2];
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
                sin_theta_1
                    .mul_add(
                        phi_dot_2_last,
                        sin_theta_last.mul_add(phi_dot_2_1, next[2]),
                    ),
                cos_theta_1
                    .mul_add(
                        phi_dot_2_last,
                        cos_theta_last.mul_add(phi_dot_2_1, next[3]),
                    ),
                u1_1
                    .mul_add(
                        u2_by_tan_theta_last,
                        u1_last.mul_add(u2_by_tan_theta_1, next[4]),
                    ),
                u2_1
                    .mul_add(
                        u2_by_tan_theta_last,
                        u2_last.mul_add(u2_by_tan_theta_1, next[5]),
                    ),
            ])
        };
        // sin_theta = sin(theta)
        let sin_theta = theta.mul_add(cos_theta_0, sums[0] * over_k);
        // cos_theta = cos(theta)
        let cos_theta = -theta.mul_add(sin_theta_0, sums[1] * over_k);
        // phi_dot_2 = u2/sin_theta
        let phi_dot_2 = sin_theta
            .mul_add(-(phi_dot_2_0 * over_sin_theta), (u2 - sums[2]) * over_sin_theta);
        // u2_by_tan_theta = cos_theta*phi_dot_2
        let u2_by_tan_theta = phi_dot_2
            .mul_add(cos_theta_0, cos_theta.mul_add(phi_dot_2_0, sums[3]));
        // u1_u2_by_tan_theta = u1*u2_by_tan_theta
        let u1_u2_by_tan_theta = u2_by_tan_theta
            .mul_add(u1_0, u1.mul_add(u2_by_tan_theta_0, sums[4]));
        // u2_p2_by_tan_theta = u2*u2_by_tan_theta
        let u2_p2_by_tan_theta = u2_by_tan_theta
            .mul_add(u2_0, u2.mul_add(u2_by_tan_theta_0, sums[5]));
        // u1_dot_2 = minus_g_by_l*sin_theta + u2_p2_by_tan_theta
        let u1_dot_2 = minus_g_by_l * sin_theta + u2_p2_by_tan_theta;
        theta_rate = u1;
        phi_rate = phi_dot_2;
        u1_rate = u1_dot_2;
        u2_rate = -u1_u2_by_tan_theta;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([count * theta, count * theta, sin_theta, cos_theta, u1, u2]),
            padded([
                cos_theta,
                sin_theta,
                phi_dot_2,
                phi_dot_2,
                u2_by_tan_theta,
                u2_by_tan_theta,
            ]),
        ];
        count_last = count;
        theta_last = theta;
        u1_last = u1;
        u2_last = u2;
        sin_theta_last = sin_theta;
        cos_theta_last = cos_theta;
        phi_dot_2_last = phi_dot_2;
        u2_by_tan_theta_last = u2_by_tan_theta;
    }
}

/// Newton–Euler equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEuler;

impl<S: Scalar> System<S> for NewtonEuler {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 3,
            coordinates: 2,
            variables: 2,
            speeds: 2,
            reactions: 1,
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
        16 * order + SLACK
    }
    fn taylor(&self, p: &[S], order: usize, x: &mut [S], work: &mut [S]) {
        let x = &mut x.as_chunks_mut().0[..=order];
        taylor(&Parameters::from_slice(p), x, rows(work));
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
