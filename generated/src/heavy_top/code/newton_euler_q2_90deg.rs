//! Symmetric heavy top about a fixed point: Newton–Euler equations in q2-90°, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/heavy_top/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane_q2_90deg::{
    accelerations, coordinate_rates, derivative, divisors, jacobian, kinetic_energy,
    potential_energy,
};

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows top force b1, top force b2, top force b3, top moment b1, top moment b2, top moment b3.
///
/// 23 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    _u: &[S; 3],
) -> [[S; 6]; 6] {
    let Parameters { m, l, I1, I3, .. } = *p;
    let [q1, q2_minus_90deg, _] = *q;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Shared terms.
    let m_l = m * l;
    let s1_cos_q2_minus_90deg = s1 * cos_q2_minus_90deg;
    let c1_cos_q2_minus_90deg = c1 * cos_q2_minus_90deg;
    // l*m_l - I1
    let minus_i1_plus_l_m_l = l.mul_add(m_l, -I1);
    // -minus_i1_plus_l_m_l
    let m41_of_m_l_i1 = -minus_i1_plus_l_m_l;
    // Entries that are not zero.
    // M12 = m*l
    let m12 = m_l;
    // M14 = sin(q2_minus_90deg)
    let m14 = sin_q2_minus_90deg;
    // M15 = -sin(q1)*cos(q2_minus_90deg)
    let m15 = -s1_cos_q2_minus_90deg;
    // M16 = cos(q1)*cos(q2_minus_90deg)
    let m16 = c1_cos_q2_minus_90deg;
    // M21 = -m*l
    let m21 = -m_l;
    // M25 = -cos(q1)
    let m25 = -c1;
    // M26 = -sin(q1)
    let m26 = -s1;
    // M34 = -cos(q2_minus_90deg)
    let m34 = -cos_q2_minus_90deg;
    // M35 = -sin(q1)*sin(q2_minus_90deg)
    let m35 = -s1 * sin_q2_minus_90deg;
    // M36 = cos(q1)*sin(q2_minus_90deg)
    let m36 = c1 * sin_q2_minus_90deg;
    // M41 = I1 - m*l^2
    let m41 = m41_of_m_l_i1;
    // M45 = -l*cos(q1)
    let m45 = -l * c1;
    // M46 = -l*sin(q1)
    let m46 = -l * s1;
    // M52 = I1 - m*l^2
    let m52 = m41_of_m_l_i1;
    // M54 = -l*sin(q2_minus_90deg)
    let m54 = -l * sin_q2_minus_90deg;
    // M55 = l*sin(q1)*cos(q2_minus_90deg)
    let m55 = l * s1_cos_q2_minus_90deg;
    // M56 = -l*cos(q1)*cos(q2_minus_90deg)
    let m56 = -l * c1_cos_q2_minus_90deg;
    // M63 = I3
    let m63 = I3;
    let zero = S::int(0);
    [
        [zero, m12, zero, m14, m15, m16],
        [m21, zero, zero, zero, m25, m26],
        [zero, zero, zero, m34, m35, m36],
        [m41, zero, zero, zero, m45, m46],
        [zero, m52, zero, m54, m55, m56],
        [zero, zero, m63, zero, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3', hold1, hold2, hold3).
///
/// 29 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 3]) -> [S; 6] {
    let Parameters { m, l, I1, I3, g } = *p;
    let [q1, q2_minus_90deg, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Shared terms.
    let g_c1 = g * c1;
    let f1_of_u1 = u1 / sin_q2_minus_90deg;
    let l_f1_of_u1 = l * f1_of_u1;
    // I3*u3 + f1_of_u1*cos(q2_minus_90deg)*(I1 - m*l^2)
    let f4_of_u1_u3 = f1_of_u1 * cos_q2_minus_90deg * (I1 - m * l * l) + I3 * u3;
    // Values.
    // f1 = m*cos(q2_minus_90deg)*(g*cos(q1) + l*u1^2/sin(q2_minus_90deg))
    let f1 = m * cos_q2_minus_90deg * u1.mul_add(l_f1_of_u1, g_c1);
    // f2 = m*(l*u1*u2/tan(q2_minus_90deg) - g*sin(q1))
    let f2 = m * (-g).mul_add(s1, u2 * l_f1_of_u1 * cos_q2_minus_90deg);
    // f3 = m*(l*(u1^2 + u2^2) + g*cos(q1)*sin(q2_minus_90deg))
    let f3 = m * (l * u2.mul_add(u2, u1 * u1) + g_c1 * sin_q2_minus_90deg);
    // f4 = -u2*(I3*u3 + u1*(I1 - m*l^2)/tan(q2_minus_90deg))
    let f4 = -u2 * f4_of_u1_u3;
    // f5 = u1*(I3*u3 + u1*(I1 - m*l^2)/tan(q2_minus_90deg))
    let f5 = u1 * f4_of_u1_u3;
    let zero = S::int(0);
    [f1, f2, f3, f4, f5, zero]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 9 convolutions and 12 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 6]],
    history: &mut [Factors<S, 16>],
) {
    let Parameters { m, l, I1, I3, g } = *p;
    let [q1_0, q2_minus_90deg_0, _, u1_0, u2_0, u3] = series[0];
    // Shared terms.
    let i1_inv = S::int(1) / I1;
    let m_l_g_2 = m * l * g;
    // Constant in time.
    // i3_u3 = I3*u3
    let i3_u3 = I3 * u3;
    // m_l_g = m*l*g
    let m_l_g = m_l_g_2;
    // minus_m_l_g = -m*l*g
    let minus_m_l_g = -m_l_g_2;
    // minus_1_by_i1 = -1/I1
    let minus_1_by_i1 = -i1_inv;
    // weight = 1/I1
    let weight = i1_inv;
    // Order 0.
    let (s1_0, c1_0) = q1_0.sin_cos();
    let (sin_q2_minus_90deg_0, cos_q2_minus_90deg_0) = q2_minus_90deg_0.sin_cos();
    let over_sin_q2_minus_90deg = S::int(1) / sin_q2_minus_90deg_0;
    let u2_dot_of_u1_0 = u1_0 * over_sin_q2_minus_90deg;
    let u2_dot_of_u1_2_0 = cos_q2_minus_90deg_0 * u2_dot_of_u1_0;
    let u2_dot_of_u1_u3_0 = u2_dot_of_u1_2_0.mul_add(I1, i3_u3);
    let u2_dot_of_u1_u3_2_0 = u1_0 * u2_dot_of_u1_u3_0;
    let c1_cos_q2_minus_90deg_0 = c1_0 * cos_q2_minus_90deg_0;
    let u2_dot_of_u1_u3_3_0 = m_l_g * c1_cos_q2_minus_90deg_0 + u2_dot_of_u1_u3_2_0;
    let u1_dot_of_u1_u2_u3_0 = u2_0 * u2_dot_of_u1_u3_0;
    let u1_dot_of_u1_u2_u3_2_0 = minus_m_l_g * s1_0 + u1_dot_of_u1_u2_u3_0;
    let q3_dot_2_0 = u3 + u2_dot_of_u1_2_0;
    // Order 1: the rates, and what follows from them.
    let q1_1 = -u2_dot_of_u1_0;
    let q2_minus_90deg_1 = u2_0;
    let q3_1 = q3_dot_2_0;
    let u1_1 = minus_1_by_i1 * u1_dot_of_u1_u2_u3_2_0;
    let u2_1 = weight * u2_dot_of_u1_u3_3_0;
    if series.len() > 1 {
        series[1] = [q1_1, q2_minus_90deg_1, q3_1, u1_1, u2_1, S::int(0)];
    }
    let s1_1 = q1_1 * c1_0;
    let c1_1 = -q1_1 * s1_0;
    let sin_q2_minus_90deg_1 = q2_minus_90deg_1 * cos_q2_minus_90deg_0;
    let cos_q2_minus_90deg_1 = -q2_minus_90deg_1 * sin_q2_minus_90deg_0;
    let u2_dot_of_u1_1 = sin_q2_minus_90deg_1
        .mul_add(
            -(u2_dot_of_u1_0 * over_sin_q2_minus_90deg),
            u1_1 * over_sin_q2_minus_90deg,
        );
    let u2_dot_of_u1_2_1 = u2_dot_of_u1_1
        .mul_add(cos_q2_minus_90deg_0, cos_q2_minus_90deg_1 * u2_dot_of_u1_0);
    let u2_dot_of_u1_u3_1 = I1 * u2_dot_of_u1_2_1;
    let u2_dot_of_u1_u3_2_1 = u2_dot_of_u1_u3_1.mul_add(u1_0, u1_1 * u2_dot_of_u1_u3_0);
    let c1_cos_q2_minus_90deg_1 = cos_q2_minus_90deg_1
        .mul_add(c1_0, c1_1 * cos_q2_minus_90deg_0);
    let u2_dot_of_u1_u3_3_1 = m_l_g * c1_cos_q2_minus_90deg_1 + u2_dot_of_u1_u3_2_1;
    let u1_dot_of_u1_u2_u3_1 = u2_dot_of_u1_u3_1.mul_add(u2_0, u2_1 * u2_dot_of_u1_u3_0);
    let u1_dot_of_u1_u2_u3_2_1 = minus_m_l_g * s1_1 + u1_dot_of_u1_u2_u3_1;
    let q3_dot_2_1 = u2_dot_of_u1_2_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                q1_1, q1_1, q2_minus_90deg_1, q2_minus_90deg_1, sin_q2_minus_90deg_1,
                cos_q2_minus_90deg_1, u1_1, c1_1, u2_1,
            ]),
            padded([
                c1_1, s1_1, cos_q2_minus_90deg_1, sin_q2_minus_90deg_1, u2_dot_of_u1_1,
                u2_dot_of_u1_1, u2_dot_of_u1_u3_1, cos_q2_minus_90deg_1, u2_dot_of_u1_u3_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q1_last = q1_1;
    let mut q2_minus_90deg_last = q2_minus_90deg_1;
    let mut u1_last = u1_1;
    let mut u2_last = u2_1;
    let mut s1_last = s1_1;
    let mut c1_last = c1_1;
    let mut sin_q2_minus_90deg_last = sin_q2_minus_90deg_1;
    let mut cos_q2_minus_90deg_last = cos_q2_minus_90deg_1;
    let mut u2_dot_of_u1_last = u2_dot_of_u1_1;
    let mut u2_dot_of_u1_u3_last = u2_dot_of_u1_u3_1;
    let mut next = [S::int(0); 16];
    // Rates at order k - 1.
    let mut q1_rate = -u2_dot_of_u1_1;
    let mut q2_minus_90deg_rate = u2_1;
    let mut q3_rate = q3_dot_2_1;
    let mut u1_rate = minus_1_by_i1 * u1_dot_of_u1_u2_u3_2_1;
    let mut u2_rate = weight * u2_dot_of_u1_u3_3_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q1 = q1_rate * over_k;
        let q2_minus_90deg = q2_minus_90deg_rate * over_k;
        let q3 = q3_rate * over_k;
        let u1 = u1_rate * over_k;
        let u2 = u2_rate * over_k;
        series[order] = [q1, q2_minus_90deg, q3, u1, u2, S::int(0)];
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
                q1_1.mul_add(c1_last, (count_last * q1_last).mul_add(c1_1, next[0])),
                q1_1.mul_add(s1_last, (count_last * q1_last).mul_add(s1_1, next[1])),
                q2_minus_90deg_1
                    .mul_add(
                        cos_q2_minus_90deg_last,
                        (count_last * q2_minus_90deg_last)
                            .mul_add(cos_q2_minus_90deg_1, next[2]),
                    ),
                q2_minus_90deg_1
                    .mul_add(
                        sin_q2_minus_90deg_last,
                        (count_last * q2_minus_90deg_last)
                            .mul_add(sin_q2_minus_90deg_1, next[3]),
                    ),
                sin_q2_minus_90deg_1
                    .mul_add(
                        u2_dot_of_u1_last,
                        sin_q2_minus_90deg_last.mul_add(u2_dot_of_u1_1, next[4]),
                    ),
                cos_q2_minus_90deg_1
                    .mul_add(
                        u2_dot_of_u1_last,
                        cos_q2_minus_90deg_last.mul_add(u2_dot_of_u1_1, next[5]),
                    ),
                u1_1
                    .mul_add(
                        u2_dot_of_u1_u3_last,
                        u1_last.mul_add(u2_dot_of_u1_u3_1, next[6]),
                    ),
                c1_1
                    .mul_add(
                        cos_q2_minus_90deg_last,
                        c1_last.mul_add(cos_q2_minus_90deg_1, next[7]),
                    ),
                u2_1
                    .mul_add(
                        u2_dot_of_u1_u3_last,
                        u2_last.mul_add(u2_dot_of_u1_u3_1, next[8]),
                    ),
            ])
        };
        // s1 = sin(q1)
        let s1 = q1.mul_add(c1_0, sums[0] * over_k);
        // c1 = cos(q1)
        let c1 = -q1.mul_add(s1_0, sums[1] * over_k);
        // sin_q2_minus_90deg = sin(q2_minus_90deg)
        let sin_q2_minus_90deg = q2_minus_90deg
            .mul_add(cos_q2_minus_90deg_0, sums[2] * over_k);
        // cos_q2_minus_90deg = cos(q2_minus_90deg)
        let cos_q2_minus_90deg = -q2_minus_90deg
            .mul_add(sin_q2_minus_90deg_0, sums[3] * over_k);
        // u2_dot_of_u1 = u1/sin_q2_minus_90deg
        let u2_dot_of_u1 = sin_q2_minus_90deg
            .mul_add(
                -(u2_dot_of_u1_0 * over_sin_q2_minus_90deg),
                (u1 - sums[4]) * over_sin_q2_minus_90deg,
            );
        // u2_dot_of_u1_2 = cos_q2_minus_90deg*u2_dot_of_u1
        let u2_dot_of_u1_2 = u2_dot_of_u1
            .mul_add(
                cos_q2_minus_90deg_0,
                cos_q2_minus_90deg.mul_add(u2_dot_of_u1_0, sums[5]),
            );
        // u2_dot_of_u1_u3 = i3_u3 + I1*u2_dot_of_u1_2
        let u2_dot_of_u1_u3 = I1 * u2_dot_of_u1_2;
        // u2_dot_of_u1_u3_2 = u1*u2_dot_of_u1_u3
        let u2_dot_of_u1_u3_2 = u2_dot_of_u1_u3
            .mul_add(u1_0, u1.mul_add(u2_dot_of_u1_u3_0, sums[6]));
        // c1_cos_q2_minus_90deg = c1*cos_q2_minus_90deg
        let c1_cos_q2_minus_90deg = cos_q2_minus_90deg
            .mul_add(c1_0, c1.mul_add(cos_q2_minus_90deg_0, sums[7]));
        // u2_dot_of_u1_u3_3 = u2_dot_of_u1_u3_2 + m_l_g*c1_cos_q2_minus_90deg
        let u2_dot_of_u1_u3_3 = m_l_g * c1_cos_q2_minus_90deg + u2_dot_of_u1_u3_2;
        // u1_dot_of_u1_u2_u3 = u2*u2_dot_of_u1_u3
        let u1_dot_of_u1_u2_u3 = u2_dot_of_u1_u3
            .mul_add(u2_0, u2.mul_add(u2_dot_of_u1_u3_0, sums[8]));
        // u1_dot_of_u1_u2_u3_2 = u1_dot_of_u1_u2_u3 + minus_m_l_g*s1
        let u1_dot_of_u1_u2_u3_2 = minus_m_l_g * s1 + u1_dot_of_u1_u2_u3;
        // q3_dot_2 = u3 + u2_dot_of_u1_2
        let q3_dot_2 = u2_dot_of_u1_2;
        q1_rate = -u2_dot_of_u1;
        q2_minus_90deg_rate = u2;
        q3_rate = q3_dot_2;
        u1_rate = minus_1_by_i1 * u1_dot_of_u1_u2_u3_2;
        u2_rate = weight * u2_dot_of_u1_u3_3;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * q1,
                count * q1,
                count * q2_minus_90deg,
                count * q2_minus_90deg,
                sin_q2_minus_90deg, cos_q2_minus_90deg, u1, c1, u2,
            ]),
            padded([
                c1, s1, cos_q2_minus_90deg, sin_q2_minus_90deg, u2_dot_of_u1, u2_dot_of_u1,
                u2_dot_of_u1_u3, cos_q2_minus_90deg, u2_dot_of_u1_u3,
            ]),
        ];
        count_last = count;
        q1_last = q1;
        q2_minus_90deg_last = q2_minus_90deg;
        u1_last = u1;
        u2_last = u2;
        s1_last = s1;
        c1_last = c1;
        sin_q2_minus_90deg_last = sin_q2_minus_90deg;
        cos_q2_minus_90deg_last = cos_q2_minus_90deg;
        u2_dot_of_u1_last = u2_dot_of_u1;
        u2_dot_of_u1_u3_last = u2_dot_of_u1_u3;
    }
}

/// Newton–Euler equations in q2-90° of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEulerQ290deg;

impl<S: Scalar> System<S> for NewtonEulerQ290deg {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 5,
            coordinates: 3,
            variables: 3,
            speeds: 3,
            reactions: 3,
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
