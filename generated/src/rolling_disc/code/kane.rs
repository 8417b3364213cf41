//! Thin disc rolling on a plane: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/rolling_disc/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1, u2, u3.
///
/// 5 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    _q: &[S; 5],
    _u: &[S; 3],
) -> [[S; 3]; 3] {
    let Parameters { r, m, .. } = *p;
    // Shared terms.
    let r_sq_m = r * r * m;
    // Entries that are not zero; upper triangle.
    // M11 = 5*r^2*m/4
    let m11 = S::ratio(5, 4) * r_sq_m;
    // M22 = 3*r^2*m/2
    let m22 = S::ratio(3, 2) * r_sq_m;
    // M33 = r^2*m/4
    let m33 = S::ratio(1, 4) * r_sq_m;
    let zero = S::int(0);
    [[m11, zero, zero], [zero, m22, zero], [zero, zero, m33]]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3').
///
/// 20 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 3]) -> [S; 3] {
    let Parameters { r, m, g } = *p;
    let [_, q2, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    let t2 = s2 / c2;
    let u3_s2_c2_inv = u3 * t2;
    let r_u3 = r * u3;
    let r_m = r * m;
    let r_m_by_4 = S::ratio(1, 4) * r_m;
    // Values.
    // f1 = r*m*(4*g*sin(q2) + r*u3*(6*u2 - u3*tan(q2)))/4
    let f1 = r_m_by_4 * (r_u3 * u2.mul_add(S::int(6), -u3_s2_c2_inv) + S::int(4) * g * s2);
    // f2 = -r^2*m*u1*u3
    let f2 = -u1 * r_u3 * r_m;
    // f3 = r^2*m*u1*(u3*tan(q2) - 2*u2)/4
    let f3 = r * u1 * r_m_by_4 * (-u2).mul_add(S::int(2), u3_s2_c2_inv);
    [f1, f2, f3]
}

/// The accelerations (u1', u2', u3'), solved for when this code was generated.
///
/// 16 operations, 1 sine and cosine.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 3]) -> [S; 3] {
    let Parameters { r, g, .. } = *p;
    let [_, q2, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let t2 = s2 / c2;
    let u3_s2_c2_inv = u3 * t2;
    // u3' = u1*(u3*tan(q2) - 2*u2)
    let u3_dot = u1 * (-u2).mul_add(S::int(2), u3_s2_c2_inv);
    // u2' = -2*u1*u3/3
    let u2_dot = -S::ratio(2, 3) * u1 * u3;
    // u1' = 4*g*sin(q2)/(5*r) + u3*(6*u2 - u3*tan(q2))/5
    let u1_dot = S::ratio(4, 5) * g * s2 / r
        + S::ratio(1, 5) * u3 * u2.mul_add(S::int(6), -u3_s2_c2_inv);
    [u1_dot, u2_dot, u3_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 8 operations, 2 sines and cosines.
#[must_use]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 3]) -> [S; 5] {
    let Parameters { r, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let u3_c2_inv = u3 / c2;
    // u3_c2_inv*sin(q2) - u2
    let q3_dot_value_of_u2_u3 = u3_c2_inv.mul_add(s2, -u2);
    // -r*q3_dot_value_of_u2_u3
    let x_dot_value_of_u2_u3 = -r * q3_dot_value_of_u2_u3;
    // Values.
    // q1' = u3/cos(q2)
    let q1_dot_value = u3_c2_inv;
    // q2' = u1
    let q2_dot_value = u1;
    // q3' = u2 - u3*tan(q2)
    let q3_dot_value = -q3_dot_value_of_u2_u3;
    // x' = r*cos(q1)*(u2 - u3*tan(q2))
    let x_dot_value = x_dot_value_of_u2_u3 * c1;
    // y' = r*sin(q1)*(u2 - u3*tan(q2))
    let y_dot_value = x_dot_value_of_u2_u3 * s1;
    [q1_dot_value, q2_dot_value, q3_dot_value, x_dot_value, y_dot_value]
}

/// Kinetic energy T.
///
/// 11 operations.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, _q: &[S; 5], u: &[S; 3]) -> S {
    let Parameters { r, m, .. } = *p;
    let [u1, u2, u3] = *u;
    // Shared terms.
    // 5*u1^2 + u3^2
    let u3_sq_plus_u1_sq_times_5 = u3.mul_add(u3, S::int(5) * u1 * u1);
    // Values.
    // T = 5*r^2*m*u1^2/8 + 3*r^2*m*u2^2/4 + r^2*m*u3^2/8
    let energy = S::ratio(1, 8) * r * r * m * (S::int(6) * u2 * u2 + u3_sq_plus_u1_sq_times_5);
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 3 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5]) -> S {
    let Parameters { r, m, g } = *p;
    let [_, q2, _, _, _] = *q;
    // Sines and cosines.
    let (_, c2) = q2.sin_cos();
    // Values.
    // V = r*m*g*cos(q2)
    let energy = r * m * g * c2;
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 20 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 3],
) -> ([S; 5], [S; 3]) {
    let Parameters { r, g, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let u3_c2_inv = u3 / c2;
    let s2_u3_c2_inv = u3_c2_inv * s2;
    // u3' = u1*(u3*tan(q2) - 2*u2)
    let u3_dot = u1 * (-u2).mul_add(S::int(2), s2_u3_c2_inv);
    // u2' = -2*u1*u3/3
    let u2_dot = -S::ratio(2, 3) * u1 * u3;
    // u1' = 4*g*sin(q2)/(5*r) + u3*(6*u2 - u3*tan(q2))/5
    let u1_dot = S::ratio(4, 5) * g * s2 / r
        + S::ratio(1, 5) * u3 * u2.mul_add(S::int(6), -s2_u3_c2_inv);
    // u2 - s2_u3_c2_inv
    let u2_minus_s2_u3_c2_inv = u2 - s2_u3_c2_inv;
    let r_u2_minus_s2_u3_c2_inv = r * u2_minus_s2_u3_c2_inv;
    // Values.
    // q1' = u3/cos(q2)
    let q1_dot_value = u3_c2_inv;
    // q2' = u1
    let q2_dot_value = u1;
    // q3' = u2 - u3*tan(q2)
    let q3_dot_value = u2_minus_s2_u3_c2_inv;
    // x' = r*cos(q1)*(u2 - u3*tan(q2))
    let x_dot_value = r_u2_minus_s2_u3_c2_inv * c1;
    // y' = r*sin(q1)*(u2 - u3*tan(q2))
    let y_dot_value = r_u2_minus_s2_u3_c2_inv * s1;
    (
        [q1_dot_value, q2_dot_value, q3_dot_value, x_dot_value, y_dot_value],
        [u1_dot, u2_dot, u3_dot],
    )
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 5], _u: &[S; 3]) -> [S; 1] {
    let [_, q2, _, _, _] = *q;
    // Sines and cosines.
    let (_, c2) = q2.sin_cos();
    // Values.
    // divisor1 = cos(q2)
    let divisor1 = c2;
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
    let [_, q2, _, _, _] = *q;
    let [u1, u2, u3] = *u;
    let [u1_dot, u2_dot, u3_dot] = *v_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    let t2 = s2 / c2;
    let u3_s2_c2_inv = u3 * t2;
    let r_m = r * m;
    let r_r_m = r * r_m;
    // Values.
    // tau1 = 5*r^2*m*u1'/4 - r*m*(4*g*sin(q2) + r*u3*(6*u2 - u3*tan(q2)))/4
    let tau1 = S::ratio(5, 4) * u1_dot * r_r_m
        - S::ratio(1, 4) * r_m
            * (r * u3 * u2.mul_add(S::int(6), -u3_s2_c2_inv) + S::int(4) * g * s2);
    // tau2 = r^2*m*u1*u3 + 3*r^2*m*u2'/2
    let tau2 = (u1 * u3).mul_add(r_r_m, S::ratio(3, 2) * u2_dot * r_r_m);
    // tau3 = r^2*m*u1*(2*u2 - u3*tan(q2))/4 + r^2*m*u3'/4
    let tau3 = S::ratio(1, 4) * r_r_m * (u3_dot + u1 * u2.mul_add(S::int(2), -u3_s2_c2_inv));
    [tau1, tau2, tau3]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 3],
    direction: &[S; 8],
) -> [S; 8] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[5 + i],
    });
    let (of_q, of_v) = derivative(&p, &q, &v);
    let mut slopes = of_q.into_iter().chain(of_v).map(|rate| rate.slope);
    core::array::from_fn(|_| {
        slopes.next().expect("a slope for each component of the state")
    })
}

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
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
    slice.try_into().expect("a slice of the length that `System` requires")
}
