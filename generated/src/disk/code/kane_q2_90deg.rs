//! Thin disk sliding on a frictionless plane: Kane's method in q2-90°, M(q) u' = f(q, u).
//!
//! Generated from `models/disk/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::series::{Factors, SLACK, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1, u2, u3, u4, u5.
///
/// 17 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 5],
) -> [[S; 5]; 5] {
    let Parameters { M, R, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Shared terms.
    let m_r = M * R;
    let r_m_r = R * m_r;
    let s1_m_r = m_r * s1;
    let c1_m_r = m_r * c1;
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    let m24_of_place = sin_q2_minus_90deg_inv * cos_q2_minus_90deg;
    // Entries that are not zero; upper triangle.
    // M11 = 5*M*R^2/4
    let m11 = S::ratio(5, 4) * r_m_r;
    // M14 = -M*R*sin(q1)*sin(q2_minus_90deg)
    let m14 = -s1_m_r * sin_q2_minus_90deg;
    // M15 = M*R*cos(q1)*sin(q2_minus_90deg)
    let m15 = c1_m_r * sin_q2_minus_90deg;
    // M22 = M*R^2*(1 + 4/tan(q2_minus_90deg)^2)/4
    let m22 = r_m_r * sin_q2_minus_90deg_inv * sin_q2_minus_90deg_inv - S::ratio(3, 4) * r_m_r;
    // M24 = M*R*cos(q1)/tan(q2_minus_90deg)
    let m24 = c1_m_r * m24_of_place;
    // M25 = M*R*sin(q1)/tan(q2_minus_90deg)
    let m25 = s1_m_r * m24_of_place;
    // M33 = M*R^2/2
    let m33 = S::ratio(1, 2) * r_m_r;
    // M44 = M
    let m44 = M;
    // M55 = M
    let m55 = M;
    let zero = S::int(0);
    [
        [m11, zero, zero, m14, m15],
        [zero, m22, zero, m24, m25],
        [zero, zero, m33, zero, zero],
        [m14, m24, zero, m44, zero],
        [m15, m25, zero, zero, m55],
    ]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5').
///
/// 36 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> [S; 5] {
    let Parameters { M, R, g } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3, _, _] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let m_r = M * R;
    let cos_q2_minus_90deg_m_r = m_r * cos_q2_minus_90deg;
    let u2_m_r = u2 * m_r;
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    let f1_of_u2 = u2 * sin_q2_minus_90deg_inv;
    // 3*f1_of_u2*cos(q2_minus_90deg) - 2*u3
    let f1_of_u2_u3 = (-u3)
        .mul_add(S::int(2), S::int(3) * f1_of_u2 * cos_q2_minus_90deg);
    let f1_of_u2_u3_by_4 = S::ratio(1, 4) * f1_of_u2_u3;
    let f2_of_place = sin_q2_minus_90deg_inv * sin_q2_minus_90deg_inv;
    // cos_q2_minus_90deg_m_r*(u1^2 + f1_of_u2^2)
    let f4_of_u1_u2 = cos_q2_minus_90deg_m_r * f1_of_u2.mul_add(f1_of_u2, u1 * u1);
    // u1*u2_m_r*(1 + f2_of_place)
    let f4_of_u1_u2_2 = u1 * u2_m_r * (S::int(1) + f2_of_place);
    // Values.
    // f1 = -M*R*(4*g*cos(q2_minus_90deg) + R*u2*(2*u3 - 3*u2/tan(q2_minus_90deg)))/4
    let f1 = (-g).mul_add(cos_q2_minus_90deg_m_r, R * u2_m_r * f1_of_u2_u3_by_4);
    // f2 = M*R^2*u1*(2*u3 - u2*(7 + 4/tan(q2_minus_90deg)^2)/tan(q2_minus_90deg))/4
    let f2 = -R * u1
        * (cos_q2_minus_90deg_m_r * f1_of_u2)
            .mul_add(f2_of_place, m_r * f1_of_u2_u3_by_4);
    // f4 = -M*R*(u2^2*sin(q1)/(sin(q2_minus_90deg)*tan(q2_minus_90deg)) +
    //   u1*(u1*sin(q1)*cos(q2_minus_90deg) + u2*cos(q1)*(1 + 1/sin(q2_minus_90deg)^2)))
    let f4 = (-f4_of_u1_u2_2).mul_add(c1, -f4_of_u1_u2 * s1);
    // f5 = M*R*(u2^2*cos(q1)/(sin(q2_minus_90deg)*tan(q2_minus_90deg)) - u1*(u2*sin(q1)*(1 +
    //   1/sin(q2_minus_90deg)^2) - u1*cos(q1)*cos(q2_minus_90deg)))
    let f5 = (-f4_of_u1_u2_2).mul_add(s1, f4_of_u1_u2 * c1);
    let zero = S::int(0);
    [f1, f2, zero, f4, f5]
}

/// The accelerations (u1', u2', u3', u4', u5'), solved for when this code was generated.
///
/// 38 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> [S; 5] {
    let Parameters { R, g, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3, _, _] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let u1_sq = u1 * u1;
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    let u1_dot_of_u2 = u2 * sin_q2_minus_90deg_inv;
    // 2*u3 + u1_dot_of_u2*cos(q2_minus_90deg)
    let u1_dot_of_u2_u3 = u1_dot_of_u2.mul_add(cos_q2_minus_90deg, S::int(2) * u3);
    // u1' = (2*u2*u3 + cos(q2_minus_90deg)*(4*g/R + 4*u1^2*sin(q2_minus_90deg) +
    //   u2^2/sin(q2_minus_90deg)))/(4*sin(q2_minus_90deg)^2 - 5)
    let u1_dot = (S::int(4) * cos_q2_minus_90deg
        * u1_sq.mul_add(sin_q2_minus_90deg, g / R) + u2 * u1_dot_of_u2_u3)
        / (S::int(4) * sin_q2_minus_90deg * sin_q2_minus_90deg - S::int(5));
    // u2' = u1*(2*u3 + u2/tan(q2_minus_90deg))
    let u2_dot = u1 * u1_dot_of_u2_u3;
    // u1*u2 + sin_q2_minus_90deg_inv*(u2'*cos(q2_minus_90deg) + u1*u1_dot_of_u2)
    let u5_dot_of_u1_u2_u2_dot = sin_q2_minus_90deg_inv
        * u1.mul_add(u1_dot_of_u2, u2_dot * cos_q2_minus_90deg) + u1 * u2;
    let r_s1 = R * s1;
    // u1'*sin(q2_minus_90deg) - cos(q2_minus_90deg)*(u1_sq + u1_dot_of_u2^2)
    let u5_dot_of_u1_u2_u1_dot = -cos_q2_minus_90deg
        * u1_dot_of_u2.mul_add(u1_dot_of_u2, u1_sq) + u1_dot * sin_q2_minus_90deg;
    let r_c1 = R * c1;
    // u5' = -R*(u2'*sin(q1)/tan(q2_minus_90deg) + u1*(u2*sin(q1)*(1 + 1/sin(q2_minus_90deg)^2) -
    //   u1*cos(q1)*cos(q2_minus_90deg)) + cos(q1)*(u1'*sin(q2_minus_90deg) -
    //   u2^2/(sin(q2_minus_90deg)*tan(q2_minus_90deg))))
    let u5_dot = (-u5_dot_of_u1_u2_u1_dot).mul_add(r_c1, -u5_dot_of_u1_u2_u2_dot * r_s1);
    // u4' = -R*(u2'*cos(q1)/tan(q2_minus_90deg) + u1*(u1*sin(q1)*cos(q2_minus_90deg) + u2*cos(q1)*(1 +
    //   1/sin(q2_minus_90deg)^2)) + sin(q1)*(u2^2/(sin(q2_minus_90deg)*tan(q2_minus_90deg)) -
    //   u1'*sin(q2_minus_90deg)))
    let u4_dot = (-u5_dot_of_u1_u2_u2_dot).mul_add(r_c1, r_s1 * u5_dot_of_u1_u2_u1_dot);
    let zero = S::int(0);
    [u1_dot, u2_dot, zero, u4_dot, u5_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 5],
) -> [S; 5] {
    let [_, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3, u4, u5] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Shared terms.
    let q1_dot_value_of_u2 = u2 / sin_q2_minus_90deg;
    // Values.
    // q1' = -u2/sin(q2_minus_90deg)
    let q1_dot_value = -q1_dot_value_of_u2;
    // q2' = -u1
    let q2_dot_value = -u1;
    // q3' = u3 + u2/tan(q2_minus_90deg)
    let q3_dot_value = q1_dot_value_of_u2.mul_add(cos_q2_minus_90deg, u3);
    // q4' = u4
    let q4_dot_value = u4;
    // q5' = u5
    let q5_dot_value = u5;
    [q1_dot_value, q2_dot_value, q3_dot_value, q4_dot_value, q5_dot_value]
}

/// Kinetic energy T.
///
/// 36 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> S {
    let Parameters { M, R, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3, u4, u5] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let m_r = M * R;
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    // 5*u1^2 + u2^2*(4*sin_q2_minus_90deg_inv^2 - 3)
    let energy_of_u1_u2 = S::int(5) * u1 * u1
        + u2 * u2 * (S::int(4) * sin_q2_minus_90deg_inv * sin_q2_minus_90deg_inv - S::int(3));
    // Values.
    // T = M*(4*u4^2 + 4*u5^2 + R*(8*u1*sin(q2_minus_90deg)*(u5*cos(q1) - u4*sin(q1)) + 8*u2*(u4*cos(q1) +
    //   u5*sin(q1))/tan(q2_minus_90deg) + R*(5*u1^2 + 2*u3^2 + u2^2*(1 + 4/tan(q2_minus_90deg)^2))))/8
    let energy = S::ratio(1, 2) * M * u5.mul_add(u5, u4 * u4)
        + m_r
            * (u2 * sin_q2_minus_90deg_inv * cos_q2_minus_90deg * u5.mul_add(s1, u4 * c1)
                - u1 * sin_q2_minus_90deg * (-u5).mul_add(c1, u4 * s1))
        + S::ratio(1, 8) * R * m_r * (S::int(2) * u3 * u3 + energy_of_u1_u2);
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5]) -> S {
    let Parameters { M, R, g } = *p;
    let [_, q2_minus_90deg, _, _, _] = *q;
    // Sines and cosines.
    let (sin_q2_minus_90deg, _) = q2_minus_90deg.sin_cos();
    // Values.
    // V = -M*R*g*(1 + sin(q2_minus_90deg))
    let energy = -M * R * g * (S::int(1) + sin_q2_minus_90deg);
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 41 operations, 2 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 5],
) -> ([S; 5], [S; 5]) {
    let Parameters { R, g, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3, u4, u5] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let u1_sq = u1 * u1;
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    let u1_dot_of_u2 = u2 * sin_q2_minus_90deg_inv;
    let u1_dot_of_u2_2 = u1_dot_of_u2 * cos_q2_minus_90deg;
    // 2*u3 + u1_dot_of_u2_2
    let u1_dot_of_u2_u3 = u3.mul_add(S::int(2), u1_dot_of_u2_2);
    // u1' = (2*u2*u3 + cos(q2_minus_90deg)*(4*g/R + 4*u1^2*sin(q2_minus_90deg) +
    //   u2^2/sin(q2_minus_90deg)))/(4*sin(q2_minus_90deg)^2 - 5)
    let u1_dot = (S::int(4) * cos_q2_minus_90deg
        * u1_sq.mul_add(sin_q2_minus_90deg, g / R) + u2 * u1_dot_of_u2_u3)
        / (S::int(4) * sin_q2_minus_90deg * sin_q2_minus_90deg - S::int(5));
    // u2' = u1*(2*u3 + u2/tan(q2_minus_90deg))
    let u2_dot = u1 * u1_dot_of_u2_u3;
    // u1*u2 + sin_q2_minus_90deg_inv*(u2'*cos(q2_minus_90deg) + u1*u1_dot_of_u2)
    let u5_dot_of_u1_u2_u2_dot = sin_q2_minus_90deg_inv
        * u1.mul_add(u1_dot_of_u2, u2_dot * cos_q2_minus_90deg) + u1 * u2;
    let r_s1 = R * s1;
    // u1'*sin(q2_minus_90deg) - cos(q2_minus_90deg)*(u1_sq + u1_dot_of_u2^2)
    let u5_dot_of_u1_u2_u1_dot = -cos_q2_minus_90deg
        * u1_dot_of_u2.mul_add(u1_dot_of_u2, u1_sq) + u1_dot * sin_q2_minus_90deg;
    let r_c1 = R * c1;
    // u5' = -R*(u2'*sin(q1)/tan(q2_minus_90deg) + u1*(u2*sin(q1)*(1 + 1/sin(q2_minus_90deg)^2) -
    //   u1*cos(q1)*cos(q2_minus_90deg)) + cos(q1)*(u1'*sin(q2_minus_90deg) -
    //   u2^2/(sin(q2_minus_90deg)*tan(q2_minus_90deg))))
    let u5_dot = (-u5_dot_of_u1_u2_u1_dot).mul_add(r_c1, -u5_dot_of_u1_u2_u2_dot * r_s1);
    // u4' = -R*(u2'*cos(q1)/tan(q2_minus_90deg) + u1*(u1*sin(q1)*cos(q2_minus_90deg) + u2*cos(q1)*(1 +
    //   1/sin(q2_minus_90deg)^2)) + sin(q1)*(u2^2/(sin(q2_minus_90deg)*tan(q2_minus_90deg)) -
    //   u1'*sin(q2_minus_90deg)))
    let u4_dot = (-u5_dot_of_u1_u2_u2_dot).mul_add(r_c1, r_s1 * u5_dot_of_u1_u2_u1_dot);
    // Values.
    // q1' = -u2/sin(q2_minus_90deg)
    let q1_dot_value = -u1_dot_of_u2;
    // q2' = -u1
    let q2_dot_value = -u1;
    // q3' = u3 + u2/tan(q2_minus_90deg)
    let q3_dot_value = u3 + u1_dot_of_u2_2;
    // q4' = u4
    let q4_dot_value = u4;
    // q5' = u5
    let q5_dot_value = u5;
    let zero = S::int(0);
    (
        [q1_dot_value, q2_dot_value, q3_dot_value, q4_dot_value, q5_dot_value],
        [u1_dot, u2_dot, zero, u4_dot, u5_dot],
    )
}

/// Jacobian of the derivative by the state; columns q1, q2_minus_90deg, q3, q4, q5, u1, u2, u3, u4, u5.
///
/// 137 operations, 2 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> [[S; 10]; 10] {
    let Parameters { R, g, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3, _, _] = *u;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let u1_dot_of_place = S::int(4) * sin_q2_minus_90deg;
    // 1/(u1_dot_of_place*sin(q2_minus_90deg) - 5)
    let u1_dot_of_place_2 = S::int(1) / u1_dot_of_place.mul_add(sin_q2_minus_90deg, -S::int(5));
    let u2_u1_dot_of_place_2 = u2 * u1_dot_of_place_2;
    let u3_doubled = S::int(2) * u3;
    let u1_dot_of_place_3 = u1_dot_of_place_2 * cos_q2_minus_90deg;
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    let u1_dot_of_u2 = u2 * sin_q2_minus_90deg_inv;
    let u2_u1_dot_of_u2 = u2 * u1_dot_of_u2;
    let u1_sin_q2_minus_90deg = u1 * sin_q2_minus_90deg;
    // g/R + u1*u1_sin_q2_minus_90deg
    let u1_dot_of_u1 = u1.mul_add(u1_sin_q2_minus_90deg, g / R);
    let u1_dot_of_place_4 = S::int(4) * u1_dot_of_place_3;
    // u1' = (2*u2*u3 + cos(q2_minus_90deg)*(4*g/R + 4*u1^2*sin(q2_minus_90deg) +
    //   u2^2/sin(q2_minus_90deg)))/(4*sin(q2_minus_90deg)^2 - 5)
    let u1_dot = u1_dot_of_place_3
        .mul_add(u2_u1_dot_of_u2, u2_u1_dot_of_place_2 * u3_doubled)
        + u1_dot_of_u1 * u1_dot_of_place_4;
    let u1_doubled = S::int(2) * u1;
    let u1_cos_q2_minus_90deg = u1 * cos_q2_minus_90deg;
    // u2' = u1*(2*u3 + u2/tan(q2_minus_90deg))
    let u2_dot = u1_dot_of_u2.mul_add(u1_cos_q2_minus_90deg, u3 * u1_doubled);
    let r_sin_q2_minus_90deg_inv = R * sin_q2_minus_90deg_inv;
    let u5_dot_by_q1_of_place = r_sin_q2_minus_90deg_inv * cos_q2_minus_90deg;
    // R + sin_q2_minus_90deg_inv*r_sin_q2_minus_90deg_inv
    let u5_dot_by_q1_of_place_2 = sin_q2_minus_90deg_inv
        .mul_add(r_sin_q2_minus_90deg_inv, R);
    let u5_dot_by_q1_of_u1 = u1 * u5_dot_by_q1_of_place_2;
    // u2'*u5_dot_by_q1_of_place + u2*u5_dot_by_q1_of_u1
    let u5_dot_by_q1_of_u1_u2_u2_dot = u2
        .mul_add(u5_dot_by_q1_of_u1, u2_dot * u5_dot_by_q1_of_place);
    let r_sin_q2_minus_90deg = R * sin_q2_minus_90deg;
    let u1_u1_cos_q2_minus_90deg = u1 * u1_cos_q2_minus_90deg;
    // u2_u1_dot_of_u2*u5_dot_by_q1_of_place + R*u1_u1_cos_q2_minus_90deg
    let u5_dot_by_q1_of_u1_u2 = R
        .mul_add(u1_u1_cos_q2_minus_90deg, u2_u1_dot_of_u2 * u5_dot_by_q1_of_place);
    // u1'*r_sin_q2_minus_90deg - u5_dot_by_q1_of_u1_u2
    let u5_dot_by_q1_of_u1_u2_u1_dot = u1_dot
        .mul_add(r_sin_q2_minus_90deg, -u5_dot_by_q1_of_u1_u2);
    // u5_dot_by_q1 = -R*(u2'*cos(q1)/tan(q2_minus_90deg) + u1*(u1*sin(q1)*cos(q2_minus_90deg) +
    //   u2*cos(q1)*(1 + 1/sin(q2_minus_90deg)^2)) + sin(q1)*(u2^2/(sin(q2_minus_90deg)*tan(q2_minus_90deg))
    //   - u1'*sin(q2_minus_90deg)))
    let u5_dot_by_q1 = (-u5_dot_by_q1_of_u1_u2_u2_dot)
        .mul_add(c1, u5_dot_by_q1_of_u1_u2_u1_dot * s1);
    // u4_dot_by_q1 = R*(u2'*sin(q1)/tan(q2_minus_90deg) + u1*(u2*sin(q1)*(1 + 1/sin(q2_minus_90deg)^2) -
    //   u1*cos(q1)*cos(q2_minus_90deg)) + cos(q1)*(u1'*sin(q2_minus_90deg) -
    //   u2^2/(sin(q2_minus_90deg)*tan(q2_minus_90deg))))
    let u4_dot_by_q1 = u5_dot_by_q1_of_u1_u2_u1_dot
        .mul_add(c1, u5_dot_by_q1_of_u1_u2_u2_dot * s1);
    let u1_dot_by_q2_minus_90deg_of_u2 = u1_dot_of_u2 * cos_q2_minus_90deg;
    let u2_sq = u2 * u2;
    let u1_dot_by_q2_minus_90deg_of_place = S::int(8) * u1_dot_of_place_3;
    // u1_dot_by_q2_minus_90deg = (u2^2 + 4*sin(q2_minus_90deg)*(g/R + u1^2*sin(q2_minus_90deg)) -
    //   cos(q2_minus_90deg)*(16*u2*u3*sin(q2_minus_90deg)/(5 - 4*sin(q2_minus_90deg)^2) +
    //   cos(q2_minus_90deg)*(4*u1^2 - u2^2/sin(q2_minus_90deg)^2 + 8*(u2^2 + 4*sin(q2_minus_90deg)*(g/R +
    //   u1^2*sin(q2_minus_90deg)))/(5 - 4*sin(q2_minus_90deg)^2))))/(5 - 4*sin(q2_minus_90deg)^2)
    let u1_dot_by_q2_minus_90deg = -u1_dot_of_place_3
        * u1_dot_of_u2
            .mul_add(
                u1_dot_by_q2_minus_90deg_of_u2,
                S::int(16) * u3 * u2_u1_dot_of_place_2 * sin_q2_minus_90deg,
            ) + u1_dot_of_place_4 * u1_u1_cos_q2_minus_90deg
        - u1_dot_of_place.mul_add(u1_dot_of_u1, u2_sq)
            * u1_dot_of_place_3
                .mul_add(u1_dot_by_q2_minus_90deg_of_place, u1_dot_of_place_2);
    let u2_dot_by_q2_minus_90deg_of_u2 = sin_q2_minus_90deg_inv * u1_dot_of_u2;
    // u2_dot_by_q2_minus_90deg = -u1*u2/sin(q2_minus_90deg)^2
    let u2_dot_by_q2_minus_90deg = -u1 * u2_dot_by_q2_minus_90deg_of_u2;
    let u5_dot_by_q2_minus_90deg_of_u1 = u1_doubled * u5_dot_by_q1_of_place;
    // sin_q2_minus_90deg_inv*(u2'*r_sin_q2_minus_90deg_inv + u1_dot_of_u2*u5_dot_by_q2_minus_90deg_of_u1)
    //   - u2_dot_by_q2_minus_90deg*u5_dot_by_q1_of_place
    let u5_dot_by_q2_minus_90deg_of_u1_u2_u2_dot = sin_q2_minus_90deg_inv
        * u1_dot_of_u2
            .mul_add(u5_dot_by_q2_minus_90deg_of_u1, u2_dot * r_sin_q2_minus_90deg_inv)
        - u2_dot_by_q2_minus_90deg * u5_dot_by_q1_of_place;
    let u1_dot_of_u2_doubled = S::int(2) * u1_dot_of_u2;
    let r_cos_q2_minus_90deg = R * cos_q2_minus_90deg;
    // u1_dot_of_u2*r_sin_q2_minus_90deg_inv*u1_dot_of_u2_doubled + u1'*r_cos_q2_minus_90deg
    let u5_dot_by_q2_minus_90deg_of_u2_u1_dot = u1_dot
        .mul_add(
            r_cos_q2_minus_90deg,
            u1_dot_of_u2 * r_sin_q2_minus_90deg_inv * u1_dot_of_u2_doubled,
        );
    // u1^2*r_sin_q2_minus_90deg - r_sin_q2_minus_90deg_inv*u2_sq
    let u5_dot_by_q2_minus_90deg_of_u1_u2 = (-r_sin_q2_minus_90deg_inv)
        .mul_add(u2_sq, u1 * u1 * r_sin_q2_minus_90deg);
    // u1_dot_by_q2_minus_90deg*r_sin_q2_minus_90deg + u5_dot_by_q2_minus_90deg_of_u2_u1_dot
    let u5_dot_by_q2_minus_90deg_of_u2_u1_dot_2 = u1_dot_by_q2_minus_90deg
        .mul_add(r_sin_q2_minus_90deg, u5_dot_by_q2_minus_90deg_of_u2_u1_dot);
    // u5_dot_by_q2_minus_90deg_of_u1_u2 + u5_dot_by_q2_minus_90deg_of_u2_u1_dot_2
    let u5_dot_by_q2_minus_90deg_of_u1_u2_u1_dot = u5_dot_by_q2_minus_90deg_of_u1_u2
        + u5_dot_by_q2_minus_90deg_of_u2_u1_dot_2;
    // u5_dot_by_q2_minus_90deg = -R*(cos(q1)*(u1'*cos(q2_minus_90deg) + u2^2*(2/sin(q2_minus_90deg)^2 -
    //   1)/sin(q2_minus_90deg) + sin(q2_minus_90deg)*(u1^2 + u1_dot_by_q2_minus_90deg)) +
    //   sin(q1)*(u2_dot_by_q2_minus_90deg*cos(q2_minus_90deg) - (u2' +
    //   2*u1*u2/tan(q2_minus_90deg))/sin(q2_minus_90deg))/sin(q2_minus_90deg))
    let u5_dot_by_q2_minus_90deg = (-u5_dot_by_q2_minus_90deg_of_u1_u2_u1_dot)
        .mul_add(c1, u5_dot_by_q2_minus_90deg_of_u1_u2_u2_dot * s1);
    // u4_dot_by_q2_minus_90deg = R*(sin(q1)*(u1'*cos(q2_minus_90deg) + u2^2*(2/sin(q2_minus_90deg)^2 -
    //   1)/sin(q2_minus_90deg) + sin(q2_minus_90deg)*(u1^2 + u1_dot_by_q2_minus_90deg)) + cos(q1)*((u2' +
    //   2*u1*u2/tan(q2_minus_90deg))/sin(q2_minus_90deg) -
    //   u2_dot_by_q2_minus_90deg*cos(q2_minus_90deg))/sin(q2_minus_90deg))
    let u4_dot_by_q2_minus_90deg = u5_dot_by_q2_minus_90deg_of_u1_u2_u1_dot
        .mul_add(s1, u5_dot_by_q2_minus_90deg_of_u1_u2_u2_dot * c1);
    // u1_dot_by_u1 = 8*u1*sin(q2_minus_90deg)*cos(q2_minus_90deg)/(4*sin(q2_minus_90deg)^2 - 5)
    let u1_dot_by_u1 = u1_sin_q2_minus_90deg * u1_dot_by_q2_minus_90deg_of_place;
    // u2_dot_by_u1 = 2*u3 + u2/tan(q2_minus_90deg)
    let u2_dot_by_u1 = u3_doubled + u1_dot_by_q2_minus_90deg_of_u2;
    // u1_doubled*r_cos_q2_minus_90deg - u1_dot_by_u1*r_sin_q2_minus_90deg
    let u5_dot_by_u1_of_u1 = (-u1_dot_by_u1)
        .mul_add(r_sin_q2_minus_90deg, u1_doubled * r_cos_q2_minus_90deg);
    // u2_dot_by_u1*u5_dot_by_q1_of_place + u2*u5_dot_by_q1_of_place_2
    let u5_dot_by_u1_of_u2 = u2
        .mul_add(u5_dot_by_q1_of_place_2, u2_dot_by_u1 * u5_dot_by_q1_of_place);
    // u5_dot_by_u1 = -R*(cos(q1)*(u1_dot_by_u1*sin(q2_minus_90deg) - 2*u1*cos(q2_minus_90deg)) +
    //   sin(q1)*(u2*(1 + 1/sin(q2_minus_90deg)^2) + u2_dot_by_u1/tan(q2_minus_90deg)))
    let u5_dot_by_u1 = (-u5_dot_by_u1_of_u2).mul_add(s1, u5_dot_by_u1_of_u1 * c1);
    // u4_dot_by_u1 = -R*(sin(q1)*(2*u1*cos(q2_minus_90deg) - u1_dot_by_u1*sin(q2_minus_90deg)) +
    //   cos(q1)*(u2*(1 + 1/sin(q2_minus_90deg)^2) + u2_dot_by_u1/tan(q2_minus_90deg)))
    let u4_dot_by_u1 = (-u5_dot_by_u1_of_u2).mul_add(c1, -u5_dot_by_u1_of_u1 * s1);
    // u1_dot_by_u2 = 2*(u3 + u2/tan(q2_minus_90deg))/(4*sin(q2_minus_90deg)^2 - 5)
    let u1_dot_by_u2 = u1_dot_of_place_3
        .mul_add(u1_dot_of_u2_doubled, u1_dot_of_place_2 * u3_doubled);
    // u2_dot_by_u2 = u1/tan(q2_minus_90deg)
    let u2_dot_by_u2 = sin_q2_minus_90deg_inv * u1_cos_q2_minus_90deg;
    // u1_dot_by_u2*r_sin_q2_minus_90deg - u5_dot_by_q1_of_place*u1_dot_of_u2_doubled
    let u5_dot_by_u2_of_u2 = (-u5_dot_by_q1_of_place)
        .mul_add(u1_dot_of_u2_doubled, u1_dot_by_u2 * r_sin_q2_minus_90deg);
    // u2_dot_by_u2*u5_dot_by_q1_of_place + u5_dot_by_q1_of_u1
    let u5_dot_by_u2_of_u1 = u2_dot_by_u2
        .mul_add(u5_dot_by_q1_of_place, u5_dot_by_q1_of_u1);
    // u5_dot_by_u2 = R*(cos(q1)*(2*u2/(sin(q2_minus_90deg)*tan(q2_minus_90deg)) -
    //   u1_dot_by_u2*sin(q2_minus_90deg)) - sin(q1)*(u1*(1 + 1/sin(q2_minus_90deg)^2) +
    //   u2_dot_by_u2/tan(q2_minus_90deg)))
    let u5_dot_by_u2 = (-u5_dot_by_u2_of_u1).mul_add(s1, -u5_dot_by_u2_of_u2 * c1);
    // u4_dot_by_u2 = -R*(sin(q1)*(2*u2/(sin(q2_minus_90deg)*tan(q2_minus_90deg)) -
    //   u1_dot_by_u2*sin(q2_minus_90deg)) + cos(q1)*(u1*(1 + 1/sin(q2_minus_90deg)^2) +
    //   u2_dot_by_u2/tan(q2_minus_90deg)))
    let u4_dot_by_u2 = (-u5_dot_by_u2_of_u1).mul_add(c1, u5_dot_by_u2_of_u2 * s1);
    // u1_dot_by_u3 = 2*u2/(4*sin(q2_minus_90deg)^2 - 5)
    let u1_dot_by_u3 = S::int(2) * u2_u1_dot_of_place_2;
    let u5_dot_by_u3_of_place = u1_dot_by_u3 * r_sin_q2_minus_90deg;
    // u5_dot_by_u3 = -R*(2*u1*sin(q1)/tan(q2_minus_90deg) + u1_dot_by_u3*cos(q1)*sin(q2_minus_90deg))
    let u5_dot_by_u3 = (-u5_dot_by_u3_of_place)
        .mul_add(c1, -u5_dot_by_q2_minus_90deg_of_u1 * s1);
    // u4_dot_by_u3 = R*(u1_dot_by_u3*sin(q1)*sin(q2_minus_90deg) - 2*u1*cos(q1)/tan(q2_minus_90deg))
    let u4_dot_by_u3 = (-u5_dot_by_q2_minus_90deg_of_u1)
        .mul_add(c1, u5_dot_by_u3_of_place * s1);
    // Entries that are not zero.
    // d(q1')/d(q2_minus_90deg) = u2/(sin(q2_minus_90deg)*tan(q2_minus_90deg))
    let q1_dot_by_q2_minus_90deg_value = sin_q2_minus_90deg_inv * u1_dot_by_q2_minus_90deg_of_u2;
    // d(q1')/d(u2) = -1/sin(q2_minus_90deg)
    let q1_dot_by_u2_value = -sin_q2_minus_90deg_inv;
    // d(q2')/d(u1) = -1
    let q2_dot_by_u1_value = -S::int(1);
    // d(q3')/d(q2_minus_90deg) = -u2/sin(q2_minus_90deg)^2
    let q3_dot_by_q2_minus_90deg_value = -u2_dot_by_q2_minus_90deg_of_u2;
    // d(q3')/d(u2) = 1/tan(q2_minus_90deg)
    let q3_dot_by_u2_value = sin_q2_minus_90deg_inv * cos_q2_minus_90deg;
    // d(q3')/d(u3) = 1
    let q3_dot_by_u3_value = S::int(1);
    // d(q4')/d(u4) = 1
    let q4_dot_by_u4_value = S::int(1);
    // d(q5')/d(u5) = 1
    let q5_dot_by_u5_value = S::int(1);
    // d(u2')/d(u3) = 2*u1
    let u2_dot_by_u3_value = u1_doubled;
    let zero = S::int(0);
    [
        [
            zero, q1_dot_by_q2_minus_90deg_value, zero, zero, zero, zero, q1_dot_by_u2_value, zero,
            zero, zero,
        ],
        [zero, zero, zero, zero, zero, q2_dot_by_u1_value, zero, zero, zero, zero],
        [
            zero, q3_dot_by_q2_minus_90deg_value, zero, zero, zero, zero, q3_dot_by_u2_value,
            q3_dot_by_u3_value, zero, zero,
        ],
        [zero, zero, zero, zero, zero, zero, zero, zero, q4_dot_by_u4_value, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, q5_dot_by_u5_value],
        [
            zero, u1_dot_by_q2_minus_90deg, zero, zero, zero, u1_dot_by_u1, u1_dot_by_u2,
            u1_dot_by_u3, zero, zero,
        ],
        [
            zero, u2_dot_by_q2_minus_90deg, zero, zero, zero, u2_dot_by_u1, u2_dot_by_u2,
            u2_dot_by_u3_value, zero, zero,
        ],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, zero],
        [
            u4_dot_by_q1, u4_dot_by_q2_minus_90deg, zero, zero, zero, u4_dot_by_u1, u4_dot_by_u2,
            u4_dot_by_u3, zero, zero,
        ],
        [
            u5_dot_by_q1, u5_dot_by_q2_minus_90deg, zero, zero, zero, u5_dot_by_u1, u5_dot_by_u2,
            u5_dot_by_u3, zero, zero,
        ],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 0 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 5], _u: &[S; 5]) -> [S; 1] {
    let [_, q2_minus_90deg, _, _, _] = *q;
    // Sines and cosines.
    let (sin_q2_minus_90deg, _) = q2_minus_90deg.sin_cos();
    // Values.
    // divisor1 = sin(q2_minus_90deg)
    let divisor1 = sin_q2_minus_90deg;
    [divisor1]
}

/// Inverse dynamics: the generalized forces along (u1, u2, u3, u4, u5) that must act beside the loads of the model for the accelerations to be (u1', u2', u3', u4', u5').
///
/// 64 operations, 2 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    u: &[S; 5],
    v_dot: &[S; 5],
) -> [S; 5] {
    let Parameters { M, R, g } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3, _, _] = *u;
    let [u1_dot, u2_dot, u3_dot, u4_dot, u5_dot] = *v_dot;
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let m_r = M * R;
    let r_m_r = R * m_r;
    let cos_q2_minus_90deg_m_r = m_r * cos_q2_minus_90deg;
    let sin_q2_minus_90deg_inv = S::int(1) / sin_q2_minus_90deg;
    let tau1_of_u2 = u2 * sin_q2_minus_90deg_inv;
    // 3*tau1_of_u2*cos(q2_minus_90deg) - 2*u3
    let tau1_of_u2_u3 = (-u3)
        .mul_add(S::int(2), S::int(3) * tau1_of_u2 * cos_q2_minus_90deg);
    let r_m_r_tau1_of_u2_u3_by_4 = S::ratio(1, 4) * r_m_r * tau1_of_u2_u3;
    let u1_tau1_of_u2 = u1 * tau1_of_u2;
    // u1'*sin(q2_minus_90deg) - cos(q2_minus_90deg)*(u1^2 + tau1_of_u2^2)
    let tau4_of_u1_u2_u1_dot = -cos_q2_minus_90deg
        * tau1_of_u2.mul_add(tau1_of_u2, u1 * u1) + u1_dot * sin_q2_minus_90deg;
    let s1_m_r = m_r * s1;
    // u1*u2 + sin_q2_minus_90deg_inv*(u2'*cos(q2_minus_90deg) + u1_tau1_of_u2)
    let tau4_of_u1_u2_u2_dot = sin_q2_minus_90deg_inv
        * u2_dot.mul_add(cos_q2_minus_90deg, u1_tau1_of_u2) + u1 * u2;
    let c1_m_r = m_r * c1;
    // Values.
    // tau1 = 5*M*R^2*u1'/4 - M*R*u4'*sin(q1)*sin(q2_minus_90deg) + M*R*u5'*cos(q1)*sin(q2_minus_90deg) +
    //   M*R*(4*g*cos(q2_minus_90deg) + R*u2*(2*u3 - 3*u2/tan(q2_minus_90deg)))/4
    let tau1 = m_r * sin_q2_minus_90deg * (-u4_dot).mul_add(s1, u5_dot * c1)
        + S::ratio(5, 4) * u1_dot * r_m_r + g * cos_q2_minus_90deg_m_r
        - u2 * r_m_r_tau1_of_u2_u3_by_4;
    // tau2 = M*R*u4'*cos(q1)/tan(q2_minus_90deg) + M*R*u5'*sin(q1)/tan(q2_minus_90deg) + M*R^2*u1*(u2*(7 +
    //   4/tan(q2_minus_90deg)^2)/tan(q2_minus_90deg) - 2*u3)/4 + M*R^2*u2'*(1 + 4/tan(q2_minus_90deg)^2)/4
    let tau2 = -S::ratio(3, 4) * u2_dot * r_m_r + u1 * r_m_r_tau1_of_u2_u3_by_4
        + sin_q2_minus_90deg_inv
            * (cos_q2_minus_90deg_m_r * u5_dot.mul_add(s1, u4_dot * c1)
                + r_m_r * sin_q2_minus_90deg_inv
                    * u1_tau1_of_u2.mul_add(cos_q2_minus_90deg, u2_dot));
    // tau3 = M*R^2*u3'/2
    let tau3 = S::ratio(1, 2) * u3_dot * r_m_r;
    // tau4 = M*u4' - M*R*u1'*sin(q1)*sin(q2_minus_90deg) + M*R*u2'*cos(q1)/tan(q2_minus_90deg) +
    //   M*R*(u2^2*sin(q1)/(sin(q2_minus_90deg)*tan(q2_minus_90deg)) + u1*(u1*sin(q1)*cos(q2_minus_90deg) +
    //   u2*cos(q1)*(1 + 1/sin(q2_minus_90deg)^2)))
    let tau4 = (-tau4_of_u1_u2_u1_dot).mul_add(s1_m_r, M * u4_dot) + tau4_of_u1_u2_u2_dot * c1_m_r;
    // tau5 = M*u5' + M*R*u1'*cos(q1)*sin(q2_minus_90deg) + M*R*u2'*sin(q1)/tan(q2_minus_90deg) +
    //   M*R*(u1*(u2*sin(q1)*(1 + 1/sin(q2_minus_90deg)^2) - u1*cos(q1)*cos(q2_minus_90deg)) -
    //   u2^2*cos(q1)/(sin(q2_minus_90deg)*tan(q2_minus_90deg)))
    let tau5 = s1_m_r.mul_add(tau4_of_u1_u2_u2_dot, M * u5_dot) + tau4_of_u1_u2_u1_dot * c1_m_r;
    [tau1, tau2, tau3, tau4, tau5]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 24 convolutions and 38 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 10]],
    history: &mut [Factors<S, 24>],
) {
    let Parameters { R, g, .. } = *p;
    let [q1_0, q2_minus_90deg_0, _, _, _, u1_0, u2_0, u3, u4_0, u5_0] = series[0];
    // Constant in time.
    // weight = 4*g/R
    let weight = S::int(4) * g / R;
    // weight_2 = 2*u3
    let weight_2 = S::int(2) * u3;
    // minus_r = -R
    let minus_r = -R;
    // Order 0.
    let (sin_q2_minus_90deg_0, cos_q2_minus_90deg_0) = q2_minus_90deg_0.sin_cos();
    let over_sin_q2_minus_90deg = S::int(1) / sin_q2_minus_90deg_0;
    let sin_q2_minus_90deg_sq_0 = sin_q2_minus_90deg_0 * sin_q2_minus_90deg_0;
    let u1_dot_of_place_0 = sin_q2_minus_90deg_sq_0.mul_add(S::int(4), -S::int(5));
    let over_u1_dot_of_place = S::int(1) / u1_dot_of_place_0;
    let u1_dot_of_u2_0 = u2_0 * over_sin_q2_minus_90deg;
    let u1_dot_of_u2_2_0 = u2_0 * u1_dot_of_u2_0;
    let u1_sq_0 = u1_0 * u1_0;
    let u1_sq_sin_q2_minus_90deg_0 = sin_q2_minus_90deg_0 * u1_sq_0;
    let u1_dot_of_u1_u2_0 = u1_sq_sin_q2_minus_90deg_0.mul_add(S::int(4), weight)
        + u1_dot_of_u2_2_0;
    let u1_dot_of_u1_u2_2_0 = cos_q2_minus_90deg_0 * u1_dot_of_u1_u2_0;
    let u1_dot_of_u1_u2_u3_0 = weight_2 * u2_0 + u1_dot_of_u1_u2_2_0;
    let u1_dot_2_0 = u1_dot_of_u1_u2_u3_0 * over_u1_dot_of_place;
    let u2_dot_of_u2_0 = cos_q2_minus_90deg_0 * u1_dot_of_u2_0;
    let u2_dot_of_u2_u3_0 = weight_2 + u2_dot_of_u2_0;
    let u2_dot_2_0 = u1_0 * u2_dot_of_u2_u3_0;
    let (s1_0, c1_0) = q1_0.sin_cos();
    let u5_dot_of_u1_u2_u3_0 = u1_dot_2_0 * sin_q2_minus_90deg_0;
    let u5_dot_of_u2_0 = u1_dot_of_u2_0 * u1_dot_of_u2_0;
    let u1_u2_0 = u1_0 * u2_0;
    let u5_dot_of_u1_u2_0 = u1_0 * u1_dot_of_u2_0;
    let u5_dot_of_u1_u2_u3_2_0 = u2_dot_2_0 * cos_q2_minus_90deg_0;
    let u5_dot_of_u1_u2_u2_dot_0 = u5_dot_of_u1_u2_0 + u5_dot_of_u1_u2_u3_2_0;
    let u5_dot_of_u1_u2_u2_dot_2_0 = u5_dot_of_u1_u2_u2_dot_0 * over_sin_q2_minus_90deg;
    let u5_dot_of_u1_u2_u2_dot_3_0 = u1_u2_0 + u5_dot_of_u1_u2_u2_dot_2_0;
    let u5_dot_of_u1_u2_u2_dot_4_0 = s1_0 * u5_dot_of_u1_u2_u2_dot_3_0;
    let u5_dot_of_u1_u2_2_0 = u1_sq_0 + u5_dot_of_u2_0;
    let u5_dot_of_u1_u2_3_0 = cos_q2_minus_90deg_0 * u5_dot_of_u1_u2_2_0;
    let u5_dot_of_u1_u2_u1_dot_0 = -u5_dot_of_u1_u2_3_0 + u5_dot_of_u1_u2_u3_0;
    let u5_dot_of_u1_u2_u1_dot_2_0 = c1_0 * u5_dot_of_u1_u2_u1_dot_0;
    let u5_dot_of_motion_0 = u5_dot_of_u1_u2_u2_dot_4_0 + u5_dot_of_u1_u2_u1_dot_2_0;
    let u4_dot_of_u1_u2_u1_dot_0 = s1_0 * u5_dot_of_u1_u2_u1_dot_0;
    let u4_dot_of_u1_u2_u2_dot_0 = c1_0 * u5_dot_of_u1_u2_u2_dot_3_0;
    let u4_dot_of_motion_0 = u4_dot_of_u1_u2_u1_dot_0 - u4_dot_of_u1_u2_u2_dot_0;
    let q3_dot_2_0 = u3 + u2_dot_of_u2_0;
    // Order 1: the rates, and what follows from them.
    let q1_1 = -u1_dot_of_u2_0;
    let q2_minus_90deg_1 = -u1_0;
    let q3_1 = q3_dot_2_0;
    let q4_1 = u4_0;
    let q5_1 = u5_0;
    let u1_1 = u1_dot_2_0;
    let u2_1 = u2_dot_2_0;
    let u4_1 = R * u4_dot_of_motion_0;
    let u5_1 = minus_r * u5_dot_of_motion_0;
    if series.len() > 1 {
        series[1] = [
            q1_1, q2_minus_90deg_1, q3_1, q4_1, q5_1, u1_1, u2_1,
            S::int(0),
            u4_1, u5_1,
        ];
    }
    let sin_q2_minus_90deg_1 = q2_minus_90deg_1 * cos_q2_minus_90deg_0;
    let cos_q2_minus_90deg_1 = -q2_minus_90deg_1 * sin_q2_minus_90deg_0;
    let sin_q2_minus_90deg_sq_1 = sin_q2_minus_90deg_1
        * (sin_q2_minus_90deg_0 + sin_q2_minus_90deg_0);
    let u1_dot_of_place_1 = S::int(4) * sin_q2_minus_90deg_sq_1;
    let u1_dot_of_u2_1 = sin_q2_minus_90deg_1
        .mul_add(
            -(u1_dot_of_u2_0 * over_sin_q2_minus_90deg),
            u2_1 * over_sin_q2_minus_90deg,
        );
    let u1_dot_of_u2_2_1 = u1_dot_of_u2_1.mul_add(u2_0, u2_1 * u1_dot_of_u2_0);
    let u1_sq_1 = u1_1 * (u1_0 + u1_0);
    let u1_sq_sin_q2_minus_90deg_1 = u1_sq_1
        .mul_add(sin_q2_minus_90deg_0, sin_q2_minus_90deg_1 * u1_sq_0);
    let u1_dot_of_u1_u2_1 = S::int(4) * u1_sq_sin_q2_minus_90deg_1 + u1_dot_of_u2_2_1;
    let u1_dot_of_u1_u2_2_1 = u1_dot_of_u1_u2_1
        .mul_add(cos_q2_minus_90deg_0, cos_q2_minus_90deg_1 * u1_dot_of_u1_u2_0);
    let u1_dot_of_u1_u2_u3_1 = weight_2 * u2_1 + u1_dot_of_u1_u2_2_1;
    let u1_dot_2_1 = u1_dot_of_place_1
        .mul_add(
            -(u1_dot_2_0 * over_u1_dot_of_place),
            u1_dot_of_u1_u2_u3_1 * over_u1_dot_of_place,
        );
    let u2_dot_of_u2_1 = u1_dot_of_u2_1
        .mul_add(cos_q2_minus_90deg_0, cos_q2_minus_90deg_1 * u1_dot_of_u2_0);
    let u2_dot_of_u2_u3_1 = u2_dot_of_u2_1;
    let u2_dot_2_1 = u2_dot_of_u2_u3_1.mul_add(u1_0, u1_1 * u2_dot_of_u2_u3_0);
    let s1_1 = q1_1 * c1_0;
    let c1_1 = -q1_1 * s1_0;
    let u5_dot_of_u1_u2_u3_1 = u1_dot_2_1
        .mul_add(sin_q2_minus_90deg_0, sin_q2_minus_90deg_1 * u1_dot_2_0);
    let u5_dot_of_u2_1 = u1_dot_of_u2_1 * (u1_dot_of_u2_0 + u1_dot_of_u2_0);
    let u1_u2_1 = u2_1.mul_add(u1_0, u1_1 * u2_0);
    let u5_dot_of_u1_u2_1 = u1_dot_of_u2_1.mul_add(u1_0, u1_1 * u1_dot_of_u2_0);
    let u5_dot_of_u1_u2_u3_2_1 = u2_dot_2_1
        .mul_add(cos_q2_minus_90deg_0, cos_q2_minus_90deg_1 * u2_dot_2_0);
    let u5_dot_of_u1_u2_u2_dot_1 = u5_dot_of_u1_u2_1 + u5_dot_of_u1_u2_u3_2_1;
    let u5_dot_of_u1_u2_u2_dot_2_1 = sin_q2_minus_90deg_1
        .mul_add(
            -(u5_dot_of_u1_u2_u2_dot_2_0 * over_sin_q2_minus_90deg),
            u5_dot_of_u1_u2_u2_dot_1 * over_sin_q2_minus_90deg,
        );
    let u5_dot_of_u1_u2_u2_dot_3_1 = u1_u2_1 + u5_dot_of_u1_u2_u2_dot_2_1;
    let u5_dot_of_u1_u2_u2_dot_4_1 = u5_dot_of_u1_u2_u2_dot_3_1
        .mul_add(s1_0, s1_1 * u5_dot_of_u1_u2_u2_dot_3_0);
    let u5_dot_of_u1_u2_2_1 = u1_sq_1 + u5_dot_of_u2_1;
    let u5_dot_of_u1_u2_3_1 = u5_dot_of_u1_u2_2_1
        .mul_add(cos_q2_minus_90deg_0, cos_q2_minus_90deg_1 * u5_dot_of_u1_u2_2_0);
    let u5_dot_of_u1_u2_u1_dot_1 = -u5_dot_of_u1_u2_3_1 + u5_dot_of_u1_u2_u3_1;
    let u5_dot_of_u1_u2_u1_dot_2_1 = u5_dot_of_u1_u2_u1_dot_1
        .mul_add(c1_0, c1_1 * u5_dot_of_u1_u2_u1_dot_0);
    let u5_dot_of_motion_1 = u5_dot_of_u1_u2_u2_dot_4_1 + u5_dot_of_u1_u2_u1_dot_2_1;
    let u4_dot_of_u1_u2_u1_dot_1 = u5_dot_of_u1_u2_u1_dot_1
        .mul_add(s1_0, s1_1 * u5_dot_of_u1_u2_u1_dot_0);
    let u4_dot_of_u1_u2_u2_dot_1 = u5_dot_of_u1_u2_u2_dot_3_1
        .mul_add(c1_0, c1_1 * u5_dot_of_u1_u2_u2_dot_3_0);
    let u4_dot_of_motion_1 = u4_dot_of_u1_u2_u1_dot_1 - u4_dot_of_u1_u2_u2_dot_1;
    let q3_dot_2_1 = u2_dot_of_u2_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            [
                q2_minus_90deg_1, q2_minus_90deg_1, sin_q2_minus_90deg_1, sin_q2_minus_90deg_1,
                u2_1, u1_1, sin_q2_minus_90deg_1, cos_q2_minus_90deg_1, u1_dot_of_place_1,
                cos_q2_minus_90deg_1, u1_1, q1_1, q1_1, u1_dot_2_1, u1_dot_of_u2_1, u1_1, u1_1,
                u2_dot_2_1, sin_q2_minus_90deg_1, s1_1, cos_q2_minus_90deg_1, c1_1, s1_1, c1_1,
            ],
            [
                cos_q2_minus_90deg_1, sin_q2_minus_90deg_1, sin_q2_minus_90deg_1, u1_dot_of_u2_1,
                u1_dot_of_u2_1, u1_1, u1_sq_1, u1_dot_of_u1_u2_1, u1_dot_2_1, u1_dot_of_u2_1,
                u2_dot_of_u2_u3_1, c1_1, s1_1, sin_q2_minus_90deg_1, u1_dot_of_u2_1, u2_1,
                u1_dot_of_u2_1, cos_q2_minus_90deg_1, u5_dot_of_u1_u2_u2_dot_2_1,
                u5_dot_of_u1_u2_u2_dot_3_1, u5_dot_of_u1_u2_2_1, u5_dot_of_u1_u2_u1_dot_1,
                u5_dot_of_u1_u2_u1_dot_1, u5_dot_of_u1_u2_u2_dot_3_1,
            ],
        ];
    }
    let mut count_last = S::int(1);
    let mut q1_last = q1_1;
    let mut q2_minus_90deg_last = q2_minus_90deg_1;
    let mut u1_last = u1_1;
    let mut u2_last = u2_1;
    let mut sin_q2_minus_90deg_last = sin_q2_minus_90deg_1;
    let mut cos_q2_minus_90deg_last = cos_q2_minus_90deg_1;
    let mut u1_dot_of_place_last = u1_dot_of_place_1;
    let mut u1_dot_of_u2_last = u1_dot_of_u2_1;
    let mut u1_sq_last = u1_sq_1;
    let mut u1_dot_of_u1_u2_last = u1_dot_of_u1_u2_1;
    let mut u1_dot_2_last = u1_dot_2_1;
    let mut u2_dot_of_u2_u3_last = u2_dot_of_u2_u3_1;
    let mut u2_dot_2_last = u2_dot_2_1;
    let mut s1_last = s1_1;
    let mut c1_last = c1_1;
    let mut u5_dot_of_u1_u2_u2_dot_2_last = u5_dot_of_u1_u2_u2_dot_2_1;
    let mut u5_dot_of_u1_u2_u2_dot_3_last = u5_dot_of_u1_u2_u2_dot_3_1;
    let mut u5_dot_of_u1_u2_2_last = u5_dot_of_u1_u2_2_1;
    let mut u5_dot_of_u1_u2_u1_dot_last = u5_dot_of_u1_u2_u1_dot_1;
    let mut next = [S::int(0); 24];
    // Rates at order k - 1.
    let mut q1_rate = -u1_dot_of_u2_1;
    let mut q2_minus_90deg_rate = -u1_1;
    let mut q3_rate = q3_dot_2_1;
    let mut q4_rate = u4_1;
    let mut q5_rate = u5_1;
    let mut u1_rate = u1_dot_2_1;
    let mut u2_rate = u2_dot_2_1;
    let mut u4_rate = R * u4_dot_of_motion_1;
    let mut u5_rate = minus_r * u5_dot_of_motion_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q1 = q1_rate * over_k;
        let q2_minus_90deg = q2_minus_90deg_rate * over_k;
        let q3 = q3_rate * over_k;
        let q4 = q4_rate * over_k;
        let q5 = q5_rate * over_k;
        let u1 = u1_rate * over_k;
        let u2 = u2_rate * over_k;
        let u4 = u4_rate * over_k;
        let u5 = u5_rate * over_k;
        series[order] = [q1, q2_minus_90deg, q3, q4, q5, u1, u2, S::int(0), u4, u5];
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
            [
                q2_minus_90deg_1
                    .mul_add(
                        cos_q2_minus_90deg_last,
                        (count_last * q2_minus_90deg_last)
                            .mul_add(cos_q2_minus_90deg_1, next[0]),
                    ),
                q2_minus_90deg_1
                    .mul_add(
                        sin_q2_minus_90deg_last,
                        (count_last * q2_minus_90deg_last)
                            .mul_add(sin_q2_minus_90deg_1, next[1]),
                    ),
                (sin_q2_minus_90deg_1 + sin_q2_minus_90deg_1)
                    .mul_add(sin_q2_minus_90deg_last, next[2]),
                sin_q2_minus_90deg_1
                    .mul_add(
                        u1_dot_of_u2_last,
                        sin_q2_minus_90deg_last.mul_add(u1_dot_of_u2_1, next[3]),
                    ),
                u2_1
                    .mul_add(
                        u1_dot_of_u2_last,
                        u2_last.mul_add(u1_dot_of_u2_1, next[4]),
                    ),
                (u1_1 + u1_1).mul_add(u1_last, next[5]),
                sin_q2_minus_90deg_1
                    .mul_add(
                        u1_sq_last,
                        sin_q2_minus_90deg_last.mul_add(u1_sq_1, next[6]),
                    ),
                cos_q2_minus_90deg_1
                    .mul_add(
                        u1_dot_of_u1_u2_last,
                        cos_q2_minus_90deg_last.mul_add(u1_dot_of_u1_u2_1, next[7]),
                    ),
                u1_dot_of_place_1
                    .mul_add(
                        u1_dot_2_last,
                        u1_dot_of_place_last.mul_add(u1_dot_2_1, next[8]),
                    ),
                cos_q2_minus_90deg_1
                    .mul_add(
                        u1_dot_of_u2_last,
                        cos_q2_minus_90deg_last.mul_add(u1_dot_of_u2_1, next[9]),
                    ),
                u1_1
                    .mul_add(
                        u2_dot_of_u2_u3_last,
                        u1_last.mul_add(u2_dot_of_u2_u3_1, next[10]),
                    ),
                q1_1.mul_add(c1_last, (count_last * q1_last).mul_add(c1_1, next[11])),
                q1_1.mul_add(s1_last, (count_last * q1_last).mul_add(s1_1, next[12])),
                u1_dot_2_1
                    .mul_add(
                        sin_q2_minus_90deg_last,
                        u1_dot_2_last.mul_add(sin_q2_minus_90deg_1, next[13]),
                    ),
                (u1_dot_of_u2_1 + u1_dot_of_u2_1).mul_add(u1_dot_of_u2_last, next[14]),
                u1_1.mul_add(u2_last, u1_last.mul_add(u2_1, next[15])),
                u1_1
                    .mul_add(
                        u1_dot_of_u2_last,
                        u1_last.mul_add(u1_dot_of_u2_1, next[16]),
                    ),
                u2_dot_2_1
                    .mul_add(
                        cos_q2_minus_90deg_last,
                        u2_dot_2_last.mul_add(cos_q2_minus_90deg_1, next[17]),
                    ),
                sin_q2_minus_90deg_1
                    .mul_add(
                        u5_dot_of_u1_u2_u2_dot_2_last,
                        sin_q2_minus_90deg_last
                            .mul_add(u5_dot_of_u1_u2_u2_dot_2_1, next[18]),
                    ),
                s1_1
                    .mul_add(
                        u5_dot_of_u1_u2_u2_dot_3_last,
                        s1_last.mul_add(u5_dot_of_u1_u2_u2_dot_3_1, next[19]),
                    ),
                cos_q2_minus_90deg_1
                    .mul_add(
                        u5_dot_of_u1_u2_2_last,
                        cos_q2_minus_90deg_last.mul_add(u5_dot_of_u1_u2_2_1, next[20]),
                    ),
                c1_1
                    .mul_add(
                        u5_dot_of_u1_u2_u1_dot_last,
                        c1_last.mul_add(u5_dot_of_u1_u2_u1_dot_1, next[21]),
                    ),
                s1_1
                    .mul_add(
                        u5_dot_of_u1_u2_u1_dot_last,
                        s1_last.mul_add(u5_dot_of_u1_u2_u1_dot_1, next[22]),
                    ),
                c1_1
                    .mul_add(
                        u5_dot_of_u1_u2_u2_dot_3_last,
                        c1_last.mul_add(u5_dot_of_u1_u2_u2_dot_3_1, next[23]),
                    ),
            ]
        };
        // sin_q2_minus_90deg = sin(q2_minus_90deg)
        let sin_q2_minus_90deg = q2_minus_90deg
            .mul_add(cos_q2_minus_90deg_0, sums[0] * over_k);
        // cos_q2_minus_90deg = cos(q2_minus_90deg)
        let cos_q2_minus_90deg = -q2_minus_90deg
            .mul_add(sin_q2_minus_90deg_0, sums[1] * over_k);
        // sin_q2_minus_90deg_sq = sin_q2_minus_90deg*sin_q2_minus_90deg
        let sin_q2_minus_90deg_sq = sin_q2_minus_90deg
            .mul_add(sin_q2_minus_90deg_0 + sin_q2_minus_90deg_0, sums[2]);
        // u1_dot_of_place = -5 + 4*sin_q2_minus_90deg_sq
        let u1_dot_of_place = S::int(4) * sin_q2_minus_90deg_sq;
        // u1_dot_of_u2 = u2/sin_q2_minus_90deg
        let u1_dot_of_u2 = sin_q2_minus_90deg
            .mul_add(
                -(u1_dot_of_u2_0 * over_sin_q2_minus_90deg),
                (u2 - sums[3]) * over_sin_q2_minus_90deg,
            );
        // u1_dot_of_u2_2 = u2*u1_dot_of_u2
        let u1_dot_of_u2_2 = u1_dot_of_u2
            .mul_add(u2_0, u2.mul_add(u1_dot_of_u2_0, sums[4]));
        // u1_sq = u1*u1
        let u1_sq = u1.mul_add(u1_0 + u1_0, sums[5]);
        // u1_sq_sin_q2_minus_90deg = sin_q2_minus_90deg*u1_sq
        let u1_sq_sin_q2_minus_90deg = u1_sq
            .mul_add(sin_q2_minus_90deg_0, sin_q2_minus_90deg.mul_add(u1_sq_0, sums[6]));
        // u1_dot_of_u1_u2 = weight + u1_dot_of_u2_2 + 4*u1_sq_sin_q2_minus_90deg
        let u1_dot_of_u1_u2 = S::int(4) * u1_sq_sin_q2_minus_90deg + u1_dot_of_u2_2;
        // u1_dot_of_u1_u2_2 = cos_q2_minus_90deg*u1_dot_of_u1_u2
        let u1_dot_of_u1_u2_2 = u1_dot_of_u1_u2
            .mul_add(
                cos_q2_minus_90deg_0,
                cos_q2_minus_90deg.mul_add(u1_dot_of_u1_u2_0, sums[7]),
            );
        // u1_dot_of_u1_u2_u3 = weight_2*u2 + u1_dot_of_u1_u2_2
        let u1_dot_of_u1_u2_u3 = weight_2 * u2 + u1_dot_of_u1_u2_2;
        // u1_dot_2 = u1_dot_of_u1_u2_u3/u1_dot_of_place
        let u1_dot_2 = u1_dot_of_u1_u2_u3
            .mul_add(
                over_u1_dot_of_place,
                -(u1_dot_of_place.mul_add(u1_dot_2_0, sums[8]) * over_u1_dot_of_place),
            );
        // u2_dot_of_u2 = cos_q2_minus_90deg*u1_dot_of_u2
        let u2_dot_of_u2 = u1_dot_of_u2
            .mul_add(
                cos_q2_minus_90deg_0,
                cos_q2_minus_90deg.mul_add(u1_dot_of_u2_0, sums[9]),
            );
        // u2_dot_of_u2_u3 = weight_2 + u2_dot_of_u2
        let u2_dot_of_u2_u3 = u2_dot_of_u2;
        // u2_dot_2 = u1*u2_dot_of_u2_u3
        let u2_dot_2 = u2_dot_of_u2_u3
            .mul_add(u1_0, u1.mul_add(u2_dot_of_u2_u3_0, sums[10]));
        // s1 = sin(q1)
        let s1 = q1.mul_add(c1_0, sums[11] * over_k);
        // c1 = cos(q1)
        let c1 = -q1.mul_add(s1_0, sums[12] * over_k);
        // u5_dot_of_u1_u2_u3 = u1_dot_2*sin_q2_minus_90deg
        let u5_dot_of_u1_u2_u3 = u1_dot_2
            .mul_add(
                sin_q2_minus_90deg_0,
                sin_q2_minus_90deg.mul_add(u1_dot_2_0, sums[13]),
            );
        // u5_dot_of_u2 = u1_dot_of_u2*u1_dot_of_u2
        let u5_dot_of_u2 = u1_dot_of_u2
            .mul_add(u1_dot_of_u2_0 + u1_dot_of_u2_0, sums[14]);
        // u1_u2 = u1*u2
        let u1_u2 = u2.mul_add(u1_0, u1.mul_add(u2_0, sums[15]));
        // u5_dot_of_u1_u2 = u1*u1_dot_of_u2
        let u5_dot_of_u1_u2 = u1_dot_of_u2
            .mul_add(u1_0, u1.mul_add(u1_dot_of_u2_0, sums[16]));
        // u5_dot_of_u1_u2_u3_2 = u2_dot_2*cos_q2_minus_90deg
        let u5_dot_of_u1_u2_u3_2 = u2_dot_2
            .mul_add(
                cos_q2_minus_90deg_0,
                cos_q2_minus_90deg.mul_add(u2_dot_2_0, sums[17]),
            );
        // u5_dot_of_u1_u2_u2_dot = u5_dot_of_u1_u2 + u5_dot_of_u1_u2_u3_2
        let u5_dot_of_u1_u2_u2_dot = u5_dot_of_u1_u2 + u5_dot_of_u1_u2_u3_2;
        // u5_dot_of_u1_u2_u2_dot_2 = u5_dot_of_u1_u2_u2_dot/sin_q2_minus_90deg
        let u5_dot_of_u1_u2_u2_dot_2 = u5_dot_of_u1_u2_u2_dot
            .mul_add(
                over_sin_q2_minus_90deg,
                -(sin_q2_minus_90deg.mul_add(u5_dot_of_u1_u2_u2_dot_2_0, sums[18])
                    * over_sin_q2_minus_90deg),
            );
        // u5_dot_of_u1_u2_u2_dot_3 = u1_u2 + u5_dot_of_u1_u2_u2_dot_2
        let u5_dot_of_u1_u2_u2_dot_3 = u1_u2 + u5_dot_of_u1_u2_u2_dot_2;
        // u5_dot_of_u1_u2_u2_dot_4 = s1*u5_dot_of_u1_u2_u2_dot_3
        let u5_dot_of_u1_u2_u2_dot_4 = u5_dot_of_u1_u2_u2_dot_3
            .mul_add(s1_0, s1.mul_add(u5_dot_of_u1_u2_u2_dot_3_0, sums[19]));
        // u5_dot_of_u1_u2_2 = u1_sq + u5_dot_of_u2
        let u5_dot_of_u1_u2_2 = u1_sq + u5_dot_of_u2;
        // u5_dot_of_u1_u2_3 = cos_q2_minus_90deg*u5_dot_of_u1_u2_2
        let u5_dot_of_u1_u2_3 = u5_dot_of_u1_u2_2
            .mul_add(
                cos_q2_minus_90deg_0,
                cos_q2_minus_90deg.mul_add(u5_dot_of_u1_u2_2_0, sums[20]),
            );
        // u5_dot_of_u1_u2_u1_dot = u5_dot_of_u1_u2_u3 - u5_dot_of_u1_u2_3
        let u5_dot_of_u1_u2_u1_dot = -u5_dot_of_u1_u2_3 + u5_dot_of_u1_u2_u3;
        // u5_dot_of_u1_u2_u1_dot_2 = c1*u5_dot_of_u1_u2_u1_dot
        let u5_dot_of_u1_u2_u1_dot_2 = u5_dot_of_u1_u2_u1_dot
            .mul_add(c1_0, c1.mul_add(u5_dot_of_u1_u2_u1_dot_0, sums[21]));
        // u5_dot_of_motion = u5_dot_of_u1_u2_u2_dot_4 + u5_dot_of_u1_u2_u1_dot_2
        let u5_dot_of_motion = u5_dot_of_u1_u2_u2_dot_4 + u5_dot_of_u1_u2_u1_dot_2;
        // u4_dot_of_u1_u2_u1_dot = s1*u5_dot_of_u1_u2_u1_dot
        let u4_dot_of_u1_u2_u1_dot = u5_dot_of_u1_u2_u1_dot
            .mul_add(s1_0, s1.mul_add(u5_dot_of_u1_u2_u1_dot_0, sums[22]));
        // u4_dot_of_u1_u2_u2_dot = c1*u5_dot_of_u1_u2_u2_dot_3
        let u4_dot_of_u1_u2_u2_dot = u5_dot_of_u1_u2_u2_dot_3
            .mul_add(c1_0, c1.mul_add(u5_dot_of_u1_u2_u2_dot_3_0, sums[23]));
        // u4_dot_of_motion = u4_dot_of_u1_u2_u1_dot - u4_dot_of_u1_u2_u2_dot
        let u4_dot_of_motion = u4_dot_of_u1_u2_u1_dot - u4_dot_of_u1_u2_u2_dot;
        // q3_dot_2 = u3 + u2_dot_of_u2
        let q3_dot_2 = u2_dot_of_u2;
        q1_rate = -u1_dot_of_u2;
        q2_minus_90deg_rate = -u1;
        q3_rate = q3_dot_2;
        q4_rate = u4;
        q5_rate = u5;
        u1_rate = u1_dot_2;
        u2_rate = u2_dot_2;
        u4_rate = R * u4_dot_of_motion;
        u5_rate = minus_r * u5_dot_of_motion;
        // Factors of the convolutions: left, right.
        history[order] = [
            [
                count * q2_minus_90deg,
                count * q2_minus_90deg,
                sin_q2_minus_90deg, sin_q2_minus_90deg, u2, u1, sin_q2_minus_90deg,
                cos_q2_minus_90deg, u1_dot_of_place, cos_q2_minus_90deg, u1,
                count * q1,
                count * q1,
                u1_dot_2, u1_dot_of_u2, u1, u1, u2_dot_2, sin_q2_minus_90deg, s1,
                cos_q2_minus_90deg, c1, s1, c1,
            ],
            [
                cos_q2_minus_90deg, sin_q2_minus_90deg, sin_q2_minus_90deg, u1_dot_of_u2,
                u1_dot_of_u2, u1, u1_sq, u1_dot_of_u1_u2, u1_dot_2, u1_dot_of_u2, u2_dot_of_u2_u3,
                c1, s1, sin_q2_minus_90deg, u1_dot_of_u2, u2, u1_dot_of_u2, cos_q2_minus_90deg,
                u5_dot_of_u1_u2_u2_dot_2, u5_dot_of_u1_u2_u2_dot_3, u5_dot_of_u1_u2_2,
                u5_dot_of_u1_u2_u1_dot, u5_dot_of_u1_u2_u1_dot, u5_dot_of_u1_u2_u2_dot_3,
            ],
        ];
        count_last = count;
        q1_last = q1;
        q2_minus_90deg_last = q2_minus_90deg;
        u1_last = u1;
        u2_last = u2;
        sin_q2_minus_90deg_last = sin_q2_minus_90deg;
        cos_q2_minus_90deg_last = cos_q2_minus_90deg;
        u1_dot_of_place_last = u1_dot_of_place;
        u1_dot_of_u2_last = u1_dot_of_u2;
        u1_sq_last = u1_sq;
        u1_dot_of_u1_u2_last = u1_dot_of_u1_u2;
        u1_dot_2_last = u1_dot_2;
        u2_dot_of_u2_u3_last = u2_dot_of_u2_u3;
        u2_dot_2_last = u2_dot_2;
        s1_last = s1;
        c1_last = c1;
        u5_dot_of_u1_u2_u2_dot_2_last = u5_dot_of_u1_u2_u2_dot_2;
        u5_dot_of_u1_u2_u2_dot_3_last = u5_dot_of_u1_u2_u2_dot_3;
        u5_dot_of_u1_u2_2_last = u5_dot_of_u1_u2_2;
        u5_dot_of_u1_u2_u1_dot_last = u5_dot_of_u1_u2_u1_dot;
    }
}

/// Kane's method in q2-90° of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct KaneQ290deg;

impl<S: Scalar> System<S> for KaneQ290deg {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 3,
            coordinates: 5,
            variables: 5,
            speeds: 5,
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
        10
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
        48 * order + SLACK
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
    slice.try_into().expect("a slice of the length that `System` requires")
}
