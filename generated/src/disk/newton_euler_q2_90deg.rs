//! Thin disk sliding on a frictionless plane: Newton–Euler equations in q2-90°, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/disk/model.toml`. Do not edit; run `tripos regenerate`.
//! 5 coordinates, 5 speeds, 3 parameters, 1 reaction. Unknowns: (u1', u2', u3', u4', u5', N).
//! Cost: mass_matrix 16 operations, 2 sines and cosines; forcing 29 operations, 1 sine and cosine; accelerations 38 operations, 2 sines and cosines.
//! The kinematic equations are singular where -sin(q2_minus_90deg) = 0.
//! The accelerations divide by sin(q2_minus_90deg), by R, by 4*sin(q2_minus_90deg)^2 - 5.

use super::Parameters;
use tripos_traits::series::{Factors, SLACK, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows disk force b1, disk force b2, disk force b3, disk moment b1, disk moment b2, disk moment b3.
///
/// 16 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 5],
) -> [[S; 6]; 6] {
    let Parameters { M, R, .. } = *p;
    let [q1, q2_minus_90deg, _, _, _] = *q;
    let zero = S::int(0);
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Shared terms.
    // M*R; used 3 times
    let m_r = M * R;
    // M*cos(q1); used 3 times
    let m_c1 = M * c1;
    // M*sin(q1); used 3 times
    let m_s1 = M * s1;
    // R*m_r; used 2 times
    let r_m_r = R * m_r;
    // r_m_r/4; used 2 times
    let r_m_r_scaled = S::ratio(1, 4) * r_m_r;
    // tan(q2_minus_90deg)
    let tan_q2_minus_90deg = sin_q2_minus_90deg / cos_q2_minus_90deg;
    // Entries that are not zero.
    // M12 = M*R/tan(q2_minus_90deg)
    let m12 = m_r / tan_q2_minus_90deg;
    // M14 = M*cos(q1)
    let m14 = m_c1;
    // M15 = M*sin(q1)
    let m15 = m_s1;
    // M24 = -M*sin(q1)*cos(q2_minus_90deg)
    let m24 = -m_s1 * cos_q2_minus_90deg;
    // M25 = M*cos(q1)*cos(q2_minus_90deg)
    let m25 = m_c1 * cos_q2_minus_90deg;
    // M26 = sin(q2_minus_90deg)
    let m26 = sin_q2_minus_90deg;
    // M31 = M*R
    let m31 = m_r;
    // M34 = -M*sin(q1)*sin(q2_minus_90deg)
    let m34 = -m_s1 * sin_q2_minus_90deg;
    // M35 = M*cos(q1)*sin(q2_minus_90deg)
    let m35 = m_c1 * sin_q2_minus_90deg;
    // M36 = -cos(q2_minus_90deg)
    let m36 = -cos_q2_minus_90deg;
    // M41 = M*R^2/4
    let m41 = r_m_r_scaled;
    // M46 = R*cos(q2_minus_90deg)
    let m46 = R * cos_q2_minus_90deg;
    // M52 = M*R^2/4
    let m52 = r_m_r_scaled;
    // M63 = M*R^2/2
    let m63 = S::ratio(1, 2) * r_m_r;
    [
        [zero, m12, zero, m14, m15, zero],
        [zero, zero, zero, m24, m25, m26],
        [m31, zero, zero, m34, m35, m36],
        [m41, zero, zero, zero, zero, m46],
        [zero, m52, zero, zero, zero, zero],
        [zero, zero, m63, zero, zero, zero],
    ]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5', N).
///
/// 29 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> [S; 6] {
    let Parameters { M, R, g } = *p;
    let [_, q2_minus_90deg, _, _, _] = *q;
    let [u1, u2, u3, _, _] = *u;
    let zero = S::int(0);
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    // Shared terms.
    // M*R; used 2 times
    let m_r = M * R;
    // u2*m_r; used 4 times
    let u2_m_r = u2 * m_r;
    // 1/sin(q2_minus_90deg); used 3 times
    let f1_part = S::int(1) / sin_q2_minus_90deg;
    // M*g; used 2 times
    let m_g = M * g;
    // u1*m_r; used 2 times
    let u1_m_r = u1 * m_r;
    // u2*f1_part; used 2 times
    let u2_f1_part = u2 * f1_part;
    // u2_f1_part*cos(q2_minus_90deg); used 2 times
    let f3_part = u2_f1_part * cos_q2_minus_90deg;
    // R*(2*u3 + f3_part)/4; used 2 times
    let f4_part = S::ratio(1, 4) * R * u3.mul_add(S::int(2), f3_part);
    // Values.
    // f1 = -M*R*u1*u2*(2 + 1/tan(q2_minus_90deg)^2)
    let f1 = -u1 * u2_m_r * f1_part.mul_add(f1_part, S::int(1));
    // f2 = M*(g*sin(q2_minus_90deg) + R*(u1^2 + u2^2/tan(q2_minus_90deg)^2))
    let f2 = m_g * sin_q2_minus_90deg + u1 * u1_m_r
        + u2_m_r * f1_part.mul_add(u2_f1_part, -u2);
    // f3 = M*cos(q2_minus_90deg)*(R*u2^2/sin(q2_minus_90deg) - g)
    let f3 = (-m_g).mul_add(cos_q2_minus_90deg, u2_m_r * f3_part);
    // f4 = -M*R^2*u2*(2*u3 + u2/tan(q2_minus_90deg))/4
    let f4 = -u2_m_r * f4_part;
    // f5 = M*R^2*u1*(2*u3 + u2/tan(q2_minus_90deg))/4
    let f5 = u1_m_r * f4_part;
    [f1, f2, f3, f4, f5, zero]
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
    let zero = S::int(0);
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    // u1^2; used 2 times
    let u1_sq = u1 * u1;
    // 1/sin(q2_minus_90deg); used 2 times
    let u1_dot_part = S::int(1) / sin_q2_minus_90deg;
    // u2*u1_dot_part; used 3 times
    let u2_u1_dot_part = u2 * u1_dot_part;
    // 2*u3 + u2_u1_dot_part*cos(q2_minus_90deg); used 2 times
    let u1_dot_part_2 = u2_u1_dot_part.mul_add(cos_q2_minus_90deg, S::int(2) * u3);
    // Elimination, step by step.
    // u1' = (2*u2*u3 + cos(q2_minus_90deg)*(4*g/R + 4*u1^2*sin(q2_minus_90deg) +
    //   u2^2/sin(q2_minus_90deg)))/(4*sin(q2_minus_90deg)^2 - 5)
    let u1_dot = (S::int(4) * cos_q2_minus_90deg
        * u1_sq.mul_add(sin_q2_minus_90deg, g / R) + u2 * u1_dot_part_2)
        / (S::int(4) * sin_q2_minus_90deg * sin_q2_minus_90deg - S::int(5));
    // u2' = u1*(2*u3 + u2/tan(q2_minus_90deg))
    let u2_dot = u1 * u1_dot_part_2;
    // Shared terms.
    // u1*u2 + u1_dot_part*(u2'*cos(q2_minus_90deg) + u1*u2_u1_dot_part); used 2 times
    let u5_dot_part = u1_dot_part
        * u1.mul_add(u2_u1_dot_part, u2_dot * cos_q2_minus_90deg) + u1 * u2;
    // R*sin(q1); used 2 times
    let r_s1 = R * s1;
    // u1'*sin(q2_minus_90deg) - cos(q2_minus_90deg)*(u1_sq + u2_u1_dot_part^2); used 2 times
    let u5_dot_part_2 = -cos_q2_minus_90deg
        * u2_u1_dot_part.mul_add(u2_u1_dot_part, u1_sq) + u1_dot * sin_q2_minus_90deg;
    // R*cos(q1); used 2 times
    let r_c1 = R * c1;
    // Elimination, step by step.
    // u5' = -R*(u2'*sin(q1)/tan(q2_minus_90deg) + u1*(u2*sin(q1)*(1 + 1/sin(q2_minus_90deg)^2) -
    //   u1*cos(q1)*cos(q2_minus_90deg)) + cos(q1)*(u1'*sin(q2_minus_90deg) -
    //   u2^2/(sin(q2_minus_90deg)*tan(q2_minus_90deg))))
    let u5_dot = (-u5_dot_part_2).mul_add(r_c1, -u5_dot_part * r_s1);
    // u4' = -R*(u2'*cos(q1)/tan(q2_minus_90deg) + u1*(u1*sin(q1)*cos(q2_minus_90deg) + u2*cos(q1)*(1 +
    //   1/sin(q2_minus_90deg)^2)) + sin(q1)*(u2^2/(sin(q2_minus_90deg)*tan(q2_minus_90deg)) -
    //   u1'*sin(q2_minus_90deg)))
    let u4_dot = (-u5_dot_part).mul_add(r_c1, r_s1 * u5_dot_part_2);
    [u1_dot, u2_dot, zero, u4_dot, u5_dot]
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
    let zero = S::int(0);
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    // u1^2; used 2 times
    let u1_sq = u1 * u1;
    // 1/sin(q2_minus_90deg); used 2 times
    let u1_dot_part = S::int(1) / sin_q2_minus_90deg;
    // u2*u1_dot_part; used 4 times
    let u2_u1_dot_part = u2 * u1_dot_part;
    // u2_u1_dot_part*cos(q2_minus_90deg); used 2 times
    let u1_dot_part_2 = u2_u1_dot_part * cos_q2_minus_90deg;
    // 2*u3 + u1_dot_part_2; used 2 times
    let u1_dot_part_3 = u3.mul_add(S::int(2), u1_dot_part_2);
    // Elimination, step by step.
    // u1' = (2*u2*u3 + cos(q2_minus_90deg)*(4*g/R + 4*u1^2*sin(q2_minus_90deg) +
    //   u2^2/sin(q2_minus_90deg)))/(4*sin(q2_minus_90deg)^2 - 5)
    let u1_dot = (S::int(4) * cos_q2_minus_90deg
        * u1_sq.mul_add(sin_q2_minus_90deg, g / R) + u2 * u1_dot_part_3)
        / (S::int(4) * sin_q2_minus_90deg * sin_q2_minus_90deg - S::int(5));
    // u2' = u1*(2*u3 + u2/tan(q2_minus_90deg))
    let u2_dot = u1 * u1_dot_part_3;
    // Shared terms.
    // u1*u2 + u1_dot_part*(u2'*cos(q2_minus_90deg) + u1*u2_u1_dot_part); used 2 times
    let u5_dot_part = u1_dot_part
        * u1.mul_add(u2_u1_dot_part, u2_dot * cos_q2_minus_90deg) + u1 * u2;
    // R*sin(q1); used 2 times
    let r_s1 = R * s1;
    // u1'*sin(q2_minus_90deg) - cos(q2_minus_90deg)*(u1_sq + u2_u1_dot_part^2); used 2 times
    let u5_dot_part_2 = -cos_q2_minus_90deg
        * u2_u1_dot_part.mul_add(u2_u1_dot_part, u1_sq) + u1_dot * sin_q2_minus_90deg;
    // R*cos(q1); used 2 times
    let r_c1 = R * c1;
    // Elimination, step by step.
    // u5' = -R*(u2'*sin(q1)/tan(q2_minus_90deg) + u1*(u2*sin(q1)*(1 + 1/sin(q2_minus_90deg)^2) -
    //   u1*cos(q1)*cos(q2_minus_90deg)) + cos(q1)*(u1'*sin(q2_minus_90deg) -
    //   u2^2/(sin(q2_minus_90deg)*tan(q2_minus_90deg))))
    let u5_dot = (-u5_dot_part_2).mul_add(r_c1, -u5_dot_part * r_s1);
    // u4' = -R*(u2'*cos(q1)/tan(q2_minus_90deg) + u1*(u1*sin(q1)*cos(q2_minus_90deg) + u2*cos(q1)*(1 +
    //   1/sin(q2_minus_90deg)^2)) + sin(q1)*(u2^2/(sin(q2_minus_90deg)*tan(q2_minus_90deg)) -
    //   u1'*sin(q2_minus_90deg)))
    let u4_dot = (-u5_dot_part).mul_add(r_c1, r_s1 * u5_dot_part_2);
    // Values.
    // q1' = -u2/sin(q2_minus_90deg)
    let q1_dot_value = -u2_u1_dot_part;
    // q2' = -u1
    let q2_dot_value = -u1;
    // q3' = u3 + u2/tan(q2_minus_90deg)
    let q3_dot_value = u3 + u1_dot_part_2;
    // q4' = u4
    let q4_dot_value = u4;
    // q5' = u5
    let q5_dot_value = u5;
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
    let zero = S::int(0);
    // Sines and cosines.
    let (sin_q2_minus_90deg, cos_q2_minus_90deg) = q2_minus_90deg.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    // 4*sin(q2_minus_90deg); used 2 times
    let sin_q2_minus_90deg_scaled = S::int(4) * sin_q2_minus_90deg;
    // 1/(sin_q2_minus_90deg_scaled*sin(q2_minus_90deg) - 5); used 4 times
    let u1_dot_part = S::int(1)
        / sin_q2_minus_90deg_scaled.mul_add(sin_q2_minus_90deg, -S::int(5));
    // u2*u1_dot_part; used 3 times
    let u2_u1_dot_part = u2 * u1_dot_part;
    // 2*u3; used 3 times
    let u3_scaled = S::int(2) * u3;
    // u1_dot_part*cos(q2_minus_90deg); used 6 times
    let u1_dot_part_2 = u1_dot_part * cos_q2_minus_90deg;
    // 1/sin(q2_minus_90deg); used 9 times
    let u1_dot_part_3 = S::int(1) / sin_q2_minus_90deg;
    // u2*u1_dot_part_3; used 8 times
    let u2_u1_dot_part_3 = u2 * u1_dot_part_3;
    // u2*u2_u1_dot_part_3; used 2 times
    let u2_u2_u1_dot_part_3 = u2 * u2_u1_dot_part_3;
    // u1*sin(q2_minus_90deg); used 2 times
    let u1_dot_part_4 = u1 * sin_q2_minus_90deg;
    // g/R + u1*u1_dot_part_4; used 2 times
    let u1_dot_part_5 = u1.mul_add(u1_dot_part_4, g / R);
    // 4*u1_dot_part_2; used 2 times
    let u1_dot_part_2_scaled = S::int(4) * u1_dot_part_2;
    // Elimination, step by step.
    // u1' = (2*u2*u3 + cos(q2_minus_90deg)*(4*g/R + 4*u1^2*sin(q2_minus_90deg) +
    //   u2^2/sin(q2_minus_90deg)))/(4*sin(q2_minus_90deg)^2 - 5)
    let u1_dot = u1_dot_part_2.mul_add(u2_u2_u1_dot_part_3, u2_u1_dot_part * u3_scaled)
        + u1_dot_part_5 * u1_dot_part_2_scaled;
    // Shared terms.
    // 2*u1; used 4 times
    let u1_scaled = S::int(2) * u1;
    // u1*cos(q2_minus_90deg); used 3 times
    let u2_dot_part = u1 * cos_q2_minus_90deg;
    // Elimination, step by step.
    // u2' = u1*(2*u3 + u2/tan(q2_minus_90deg))
    let u2_dot = u2_u1_dot_part_3.mul_add(u2_dot_part, u3 * u1_scaled);
    // Shared terms.
    // R*u1_dot_part_3; used 5 times
    let r_u1_dot_part_3 = R * u1_dot_part_3;
    // r_u1_dot_part_3*cos(q2_minus_90deg); used 7 times
    let u5_dot_by_q1_part = r_u1_dot_part_3 * cos_q2_minus_90deg;
    // R + u1_dot_part_3*r_u1_dot_part_3; used 2 times
    let u5_dot_by_q1_part_2 = u1_dot_part_3.mul_add(r_u1_dot_part_3, R);
    // u1*u5_dot_by_q1_part_2; used 2 times
    let u5_dot_by_q1_part_3 = u1 * u5_dot_by_q1_part_2;
    // u2'*u5_dot_by_q1_part + u2*u5_dot_by_q1_part_3; used 2 times
    let u5_dot_by_q1_part_4 = u2
        .mul_add(u5_dot_by_q1_part_3, u2_dot * u5_dot_by_q1_part);
    // R*sin(q2_minus_90deg); used 6 times
    let r_sin_q2_minus_90deg = R * sin_q2_minus_90deg;
    // u1*u2_dot_part; used 2 times
    let u1_u2_dot_part = u1 * u2_dot_part;
    // u2_u2_u1_dot_part_3*u5_dot_by_q1_part + R*u1_u2_dot_part
    let u5_dot_by_q1_part_5 = R
        .mul_add(u1_u2_dot_part, u2_u2_u1_dot_part_3 * u5_dot_by_q1_part);
    // u1'*r_sin_q2_minus_90deg - u5_dot_by_q1_part_5; used 2 times
    let u5_dot_by_q1_part_6 = u1_dot.mul_add(r_sin_q2_minus_90deg, -u5_dot_by_q1_part_5);
    // Elimination, step by step.
    // u5_dot_by_q1 = -R*(u2'*cos(q1)/tan(q2_minus_90deg) + u1*(u1*sin(q1)*cos(q2_minus_90deg) +
    //   u2*cos(q1)*(1 + 1/sin(q2_minus_90deg)^2)) + sin(q1)*(u2^2/(sin(q2_minus_90deg)*tan(q2_minus_90deg))
    //   - u1'*sin(q2_minus_90deg)))
    let u5_dot_by_q1 = (-u5_dot_by_q1_part_4).mul_add(c1, u5_dot_by_q1_part_6 * s1);
    // u4_dot_by_q1 = R*(u2'*sin(q1)/tan(q2_minus_90deg) + u1*(u2*sin(q1)*(1 + 1/sin(q2_minus_90deg)^2) -
    //   u1*cos(q1)*cos(q2_minus_90deg)) + cos(q1)*(u1'*sin(q2_minus_90deg) -
    //   u2^2/(sin(q2_minus_90deg)*tan(q2_minus_90deg))))
    let u4_dot_by_q1 = u5_dot_by_q1_part_6.mul_add(c1, u5_dot_by_q1_part_4 * s1);
    // Shared terms.
    // u2_u1_dot_part_3*cos(q2_minus_90deg); used 3 times
    let u1_dot_by_q2_minus_90deg_part = u2_u1_dot_part_3 * cos_q2_minus_90deg;
    // u2^2; used 2 times
    let u2_sq = u2 * u2;
    // 8*u1_dot_part_2; used 2 times
    let u1_dot_part_2_scaled_2 = S::int(8) * u1_dot_part_2;
    // Elimination, step by step.
    // u1_dot_by_q2_minus_90deg = (u2^2 + 4*sin(q2_minus_90deg)*(g/R + u1^2*sin(q2_minus_90deg)) -
    //   cos(q2_minus_90deg)*(16*u2*u3*sin(q2_minus_90deg)/(5 - 4*sin(q2_minus_90deg)^2) +
    //   cos(q2_minus_90deg)*(4*u1^2 - u2^2/sin(q2_minus_90deg)^2 + 8*(u2^2 + 4*sin(q2_minus_90deg)*(g/R +
    //   u1^2*sin(q2_minus_90deg)))/(5 - 4*sin(q2_minus_90deg)^2))))/(5 - 4*sin(q2_minus_90deg)^2)
    let u1_dot_by_q2_minus_90deg = -u1_dot_part_2
        * u2_u1_dot_part_3
            .mul_add(
                u1_dot_by_q2_minus_90deg_part,
                S::int(16) * u3 * u2_u1_dot_part * sin_q2_minus_90deg,
            ) + u1_dot_part_2_scaled * u1_u2_dot_part
        - sin_q2_minus_90deg_scaled.mul_add(u1_dot_part_5, u2_sq)
            * u1_dot_part_2.mul_add(u1_dot_part_2_scaled_2, u1_dot_part);
    // Shared terms.
    // u1_dot_part_3*u2_u1_dot_part_3; used 2 times
    let u2_dot_by_q2_minus_90deg_part = u1_dot_part_3 * u2_u1_dot_part_3;
    // Elimination, step by step.
    // u2_dot_by_q2_minus_90deg = -u1*u2/sin(q2_minus_90deg)^2
    let u2_dot_by_q2_minus_90deg = -u1 * u2_dot_by_q2_minus_90deg_part;
    // Shared terms.
    // u1_scaled*u5_dot_by_q1_part; used 3 times
    let u5_dot_by_q2_minus_90deg_part = u1_scaled * u5_dot_by_q1_part;
    // u1_dot_part_3*(u2'*r_u1_dot_part_3 + u2_u1_dot_part_3*u5_dot_by_q2_minus_90deg_part) -
    //   u2_dot_by_q2_minus_90deg*u5_dot_by_q1_part; used 2 times
    let u5_dot_by_q2_minus_90deg_part_2 = u1_dot_part_3
        * u2_u1_dot_part_3
            .mul_add(u5_dot_by_q2_minus_90deg_part, u2_dot * r_u1_dot_part_3)
        - u2_dot_by_q2_minus_90deg * u5_dot_by_q1_part;
    // 2*u2_u1_dot_part_3; used 3 times
    let u2_u1_dot_part_3_scaled = S::int(2) * u2_u1_dot_part_3;
    // R*cos(q2_minus_90deg); used 2 times
    let r_cos_q2_minus_90deg = R * cos_q2_minus_90deg;
    // u2_u1_dot_part_3*r_u1_dot_part_3*u2_u1_dot_part_3_scaled + u1'*r_cos_q2_minus_90deg
    let u5_dot_by_q2_minus_90deg_part_3 = u1_dot
        .mul_add(
            r_cos_q2_minus_90deg,
            u2_u1_dot_part_3 * r_u1_dot_part_3 * u2_u1_dot_part_3_scaled,
        );
    // u1^2*r_sin_q2_minus_90deg - r_u1_dot_part_3*u2_sq
    let u5_dot_by_q2_minus_90deg_part_4 = (-r_u1_dot_part_3)
        .mul_add(u2_sq, u1 * u1 * r_sin_q2_minus_90deg);
    // u1_dot_by_q2_minus_90deg*r_sin_q2_minus_90deg + u5_dot_by_q2_minus_90deg_part_3
    let u5_dot_by_q2_minus_90deg_part_5 = u1_dot_by_q2_minus_90deg
        .mul_add(r_sin_q2_minus_90deg, u5_dot_by_q2_minus_90deg_part_3);
    // u5_dot_by_q2_minus_90deg_part_4 + u5_dot_by_q2_minus_90deg_part_5; used 2 times
    let u5_dot_by_q2_minus_90deg_part_6 = u5_dot_by_q2_minus_90deg_part_4
        + u5_dot_by_q2_minus_90deg_part_5;
    // Elimination, step by step.
    // u5_dot_by_q2_minus_90deg = -R*(cos(q1)*(u1'*cos(q2_minus_90deg) + u2^2*(2/sin(q2_minus_90deg)^2 -
    //   1)/sin(q2_minus_90deg) + sin(q2_minus_90deg)*(u1^2 + u1_dot_by_q2_minus_90deg)) +
    //   sin(q1)*(u2_dot_by_q2_minus_90deg*cos(q2_minus_90deg) - (u2' +
    //   2*u1*u2/tan(q2_minus_90deg))/sin(q2_minus_90deg))/sin(q2_minus_90deg))
    let u5_dot_by_q2_minus_90deg = (-u5_dot_by_q2_minus_90deg_part_6)
        .mul_add(c1, u5_dot_by_q2_minus_90deg_part_2 * s1);
    // u4_dot_by_q2_minus_90deg = R*(sin(q1)*(u1'*cos(q2_minus_90deg) + u2^2*(2/sin(q2_minus_90deg)^2 -
    //   1)/sin(q2_minus_90deg) + sin(q2_minus_90deg)*(u1^2 + u1_dot_by_q2_minus_90deg)) + cos(q1)*((u2' +
    //   2*u1*u2/tan(q2_minus_90deg))/sin(q2_minus_90deg) -
    //   u2_dot_by_q2_minus_90deg*cos(q2_minus_90deg))/sin(q2_minus_90deg))
    let u4_dot_by_q2_minus_90deg = u5_dot_by_q2_minus_90deg_part_6
        .mul_add(s1, u5_dot_by_q2_minus_90deg_part_2 * c1);
    // u1_dot_by_u1 = 8*u1*sin(q2_minus_90deg)*cos(q2_minus_90deg)/(4*sin(q2_minus_90deg)^2 - 5)
    let u1_dot_by_u1 = u1_dot_part_4 * u1_dot_part_2_scaled_2;
    // u2_dot_by_u1 = 2*u3 + u2/tan(q2_minus_90deg)
    let u2_dot_by_u1 = u3_scaled + u1_dot_by_q2_minus_90deg_part;
    // Shared terms.
    // u1_scaled*r_cos_q2_minus_90deg - u1_dot_by_u1*r_sin_q2_minus_90deg; used 2 times
    let u5_dot_by_u1_part = (-u1_dot_by_u1)
        .mul_add(r_sin_q2_minus_90deg, u1_scaled * r_cos_q2_minus_90deg);
    // u2_dot_by_u1*u5_dot_by_q1_part + u2*u5_dot_by_q1_part_2; used 2 times
    let u5_dot_by_u1_part_2 = u2
        .mul_add(u5_dot_by_q1_part_2, u2_dot_by_u1 * u5_dot_by_q1_part);
    // Elimination, step by step.
    // u5_dot_by_u1 = -R*(cos(q1)*(u1_dot_by_u1*sin(q2_minus_90deg) - 2*u1*cos(q2_minus_90deg)) +
    //   sin(q1)*(u2*(1 + 1/sin(q2_minus_90deg)^2) + u2_dot_by_u1/tan(q2_minus_90deg)))
    let u5_dot_by_u1 = (-u5_dot_by_u1_part_2).mul_add(s1, u5_dot_by_u1_part * c1);
    // u4_dot_by_u1 = -R*(sin(q1)*(2*u1*cos(q2_minus_90deg) - u1_dot_by_u1*sin(q2_minus_90deg)) +
    //   cos(q1)*(u2*(1 + 1/sin(q2_minus_90deg)^2) + u2_dot_by_u1/tan(q2_minus_90deg)))
    let u4_dot_by_u1 = (-u5_dot_by_u1_part_2).mul_add(c1, -u5_dot_by_u1_part * s1);
    // u1_dot_by_u2 = 2*(u3 + u2/tan(q2_minus_90deg))/(4*sin(q2_minus_90deg)^2 - 5)
    let u1_dot_by_u2 = u1_dot_part_2
        .mul_add(u2_u1_dot_part_3_scaled, u1_dot_part * u3_scaled);
    // u2_dot_by_u2 = u1/tan(q2_minus_90deg)
    let u2_dot_by_u2 = u1_dot_part_3 * u2_dot_part;
    // Shared terms.
    // u1_dot_by_u2*r_sin_q2_minus_90deg - u5_dot_by_q1_part*u2_u1_dot_part_3_scaled; used 2 times
    let u5_dot_by_u2_part = (-u5_dot_by_q1_part)
        .mul_add(u2_u1_dot_part_3_scaled, u1_dot_by_u2 * r_sin_q2_minus_90deg);
    // u2_dot_by_u2*u5_dot_by_q1_part + u5_dot_by_q1_part_3; used 2 times
    let u5_dot_by_u2_part_2 = u2_dot_by_u2
        .mul_add(u5_dot_by_q1_part, u5_dot_by_q1_part_3);
    // Elimination, step by step.
    // u5_dot_by_u2 = R*(cos(q1)*(2*u2/(sin(q2_minus_90deg)*tan(q2_minus_90deg)) -
    //   u1_dot_by_u2*sin(q2_minus_90deg)) - sin(q1)*(u1*(1 + 1/sin(q2_minus_90deg)^2) +
    //   u2_dot_by_u2/tan(q2_minus_90deg)))
    let u5_dot_by_u2 = (-u5_dot_by_u2_part_2).mul_add(s1, -u5_dot_by_u2_part * c1);
    // u4_dot_by_u2 = -R*(sin(q1)*(2*u2/(sin(q2_minus_90deg)*tan(q2_minus_90deg)) -
    //   u1_dot_by_u2*sin(q2_minus_90deg)) + cos(q1)*(u1*(1 + 1/sin(q2_minus_90deg)^2) +
    //   u2_dot_by_u2/tan(q2_minus_90deg)))
    let u4_dot_by_u2 = (-u5_dot_by_u2_part_2).mul_add(c1, u5_dot_by_u2_part * s1);
    // u1_dot_by_u3 = 2*u2/(4*sin(q2_minus_90deg)^2 - 5)
    let u1_dot_by_u3 = S::int(2) * u2_u1_dot_part;
    // Shared terms.
    // u1_dot_by_u3*r_sin_q2_minus_90deg; used 2 times
    let u5_dot_by_u3_part = u1_dot_by_u3 * r_sin_q2_minus_90deg;
    // Elimination, step by step.
    // u5_dot_by_u3 = -R*(2*u1*sin(q1)/tan(q2_minus_90deg) + u1_dot_by_u3*cos(q1)*sin(q2_minus_90deg))
    let u5_dot_by_u3 = (-u5_dot_by_u3_part)
        .mul_add(c1, -u5_dot_by_q2_minus_90deg_part * s1);
    // u4_dot_by_u3 = R*(u1_dot_by_u3*sin(q1)*sin(q2_minus_90deg) - 2*u1*cos(q1)/tan(q2_minus_90deg))
    let u4_dot_by_u3 = (-u5_dot_by_q2_minus_90deg_part)
        .mul_add(c1, u5_dot_by_u3_part * s1);
    // Entries that are not zero.
    // d(q1')/d(q2_minus_90deg) = u2/(sin(q2_minus_90deg)*tan(q2_minus_90deg))
    let q1_dot_by_q2_minus_90deg_value = u1_dot_part_3 * u1_dot_by_q2_minus_90deg_part;
    // d(q1')/d(u2) = -1/sin(q2_minus_90deg)
    let q1_dot_by_u2_value = -u1_dot_part_3;
    // d(q2')/d(u1) = -1
    let q2_dot_by_u1_value = -S::int(1);
    // d(q3')/d(q2_minus_90deg) = -u2/sin(q2_minus_90deg)^2
    let q3_dot_by_q2_minus_90deg_value = -u2_dot_by_q2_minus_90deg_part;
    // d(q3')/d(u2) = 1/tan(q2_minus_90deg)
    let q3_dot_by_u2_value = u1_dot_part_3 * cos_q2_minus_90deg;
    // d(q3')/d(u3) = 1
    let q3_dot_by_u3_value = S::int(1);
    // d(q4')/d(u4) = 1
    let q4_dot_by_u4_value = S::int(1);
    // d(q5')/d(u5) = 1
    let q5_dot_by_u5_value = S::int(1);
    // d(u2')/d(u3) = 2*u1
    let u2_dot_by_u3_value = u1_scaled;
    [
        [
            zero,
            q1_dot_by_q2_minus_90deg_value,
            zero,
            zero,
            zero,
            zero,
            q1_dot_by_u2_value,
            zero,
            zero,
            zero,
        ],
        [zero, zero, zero, zero, zero, q2_dot_by_u1_value, zero, zero, zero, zero],
        [
            zero,
            q3_dot_by_q2_minus_90deg_value,
            zero,
            zero,
            zero,
            zero,
            q3_dot_by_u2_value,
            q3_dot_by_u3_value,
            zero,
            zero,
        ],
        [zero, zero, zero, zero, zero, zero, zero, zero, q4_dot_by_u4_value, zero],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, q5_dot_by_u5_value],
        [
            zero,
            u1_dot_by_q2_minus_90deg,
            zero,
            zero,
            zero,
            u1_dot_by_u1,
            u1_dot_by_u2,
            u1_dot_by_u3,
            zero,
            zero,
        ],
        [
            zero,
            u2_dot_by_q2_minus_90deg,
            zero,
            zero,
            zero,
            u2_dot_by_u1,
            u2_dot_by_u2,
            u2_dot_by_u3_value,
            zero,
            zero,
        ],
        [zero, zero, zero, zero, zero, zero, zero, zero, zero, zero],
        [
            u4_dot_by_q1,
            u4_dot_by_q2_minus_90deg,
            zero,
            zero,
            zero,
            u4_dot_by_u1,
            u4_dot_by_u2,
            u4_dot_by_u3,
            zero,
            zero,
        ],
        [
            u5_dot_by_q1,
            u5_dot_by_q2_minus_90deg,
            zero,
            zero,
            zero,
            u5_dot_by_u1,
            u5_dot_by_u2,
            u5_dot_by_u3,
            zero,
            zero,
        ],
    ]
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
    // u2/sin(q2_minus_90deg); used 2 times
    let q1_dot_value_part = u2 / sin_q2_minus_90deg;
    // Values.
    // q1' = -u2/sin(q2_minus_90deg)
    let q1_dot_value = -q1_dot_value_part;
    // q2' = -u1
    let q2_dot_value = -u1;
    // q3' = u3 + u2/tan(q2_minus_90deg)
    let q3_dot_value = q1_dot_value_part.mul_add(cos_q2_minus_90deg, u3);
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
    // M*R; used 2 times
    let m_r = M * R;
    // 1/sin(q2_minus_90deg); used 2 times
    let energy_part = S::int(1) / sin_q2_minus_90deg;
    // 5*u1^2 + u2^2*(4*energy_part^2 - 3)
    let energy_part_2 = S::int(5) * u1 * u1
        + u2 * u2 * (S::int(4) * energy_part * energy_part - S::int(3));
    // Values.
    // T = M*(4*u4^2 + 4*u5^2 + R*(8*u1*sin(q2_minus_90deg)*(u5*cos(q1) - u4*sin(q1)) + 8*u2*(u4*cos(q1) +
    //   u5*sin(q1))/tan(q2_minus_90deg) + R*(5*u1^2 + 2*u3^2 + u2^2*(1 + 4/tan(q2_minus_90deg)^2))))/8
    let energy = S::ratio(1, 2) * M * u5.mul_add(u5, u4 * u4)
        + m_r
            * (u2 * energy_part * cos_q2_minus_90deg * u5.mul_add(s1, u4 * c1)
                - u1 * sin_q2_minus_90deg * (-u5).mul_add(c1, u4 * s1))
        + S::ratio(1, 8) * R * m_r * (S::int(2) * u3 * u3 + energy_part_2);
    energy
}

/// Potential energy V of gravity.
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

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 24 convolutions and 38 linear operations an order.
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
    // u1_dot_part = sin_q2_minus_90deg*sin_q2_minus_90deg
    let u1_dot_part_0 = sin_q2_minus_90deg_0 * sin_q2_minus_90deg_0;
    // u1_dot_part_2 = -5 + 4*u1_dot_part
    let u1_dot_part_2_0 = u1_dot_part_0.mul_add(S::int(4), -S::int(5));
    let over_u1_dot_part_2 = S::int(1) / u1_dot_part_2_0;
    // u1_dot_part_3 = u2/sin_q2_minus_90deg
    let u1_dot_part_3_0 = u2_0 * over_sin_q2_minus_90deg;
    // u1_dot_part_4 = u2*u1_dot_part_3
    let u1_dot_part_4_0 = u2_0 * u1_dot_part_3_0;
    // u1_p2 = u1*u1
    let u1_p2_0 = u1_0 * u1_0;
    // u1_dot_part_5 = sin_q2_minus_90deg*u1_p2
    let u1_dot_part_5_0 = sin_q2_minus_90deg_0 * u1_p2_0;
    // u1_dot_part_6 = weight + u1_dot_part_4 + 4*u1_dot_part_5
    let u1_dot_part_6_0 = u1_dot_part_5_0.mul_add(S::int(4), weight) + u1_dot_part_4_0;
    // u1_dot_part_7 = cos_q2_minus_90deg*u1_dot_part_6
    let u1_dot_part_7_0 = cos_q2_minus_90deg_0 * u1_dot_part_6_0;
    // u1_dot_part_8 = weight_2*u2 + u1_dot_part_7
    let u1_dot_part_8_0 = weight_2 * u2_0 + u1_dot_part_7_0;
    // u1_dot_2 = u1_dot_part_8/u1_dot_part_2
    let u1_dot_2_0 = u1_dot_part_8_0 * over_u1_dot_part_2;
    // u2_dot_part = cos_q2_minus_90deg*u1_dot_part_3
    let u2_dot_part_0 = cos_q2_minus_90deg_0 * u1_dot_part_3_0;
    // u2_dot_part_2 = weight_2 + u2_dot_part
    let u2_dot_part_2_0 = weight_2 + u2_dot_part_0;
    // u2_dot_2 = u1*u2_dot_part_2
    let u2_dot_2_0 = u1_0 * u2_dot_part_2_0;
    let (s1_0, c1_0) = q1_0.sin_cos();
    // u5_dot_part = u1_dot_2*sin_q2_minus_90deg
    let u5_dot_part_0 = u1_dot_2_0 * sin_q2_minus_90deg_0;
    // u5_dot_part_2 = u1_dot_part_3*u1_dot_part_3
    let u5_dot_part_2_0 = u1_dot_part_3_0 * u1_dot_part_3_0;
    // u1_u2 = u1*u2
    let u1_u2_0 = u1_0 * u2_0;
    // u5_dot_part_3 = u1*u1_dot_part_3
    let u5_dot_part_3_0 = u1_0 * u1_dot_part_3_0;
    // u5_dot_part_4 = u2_dot_2*cos_q2_minus_90deg
    let u5_dot_part_4_0 = u2_dot_2_0 * cos_q2_minus_90deg_0;
    // u5_dot_part_5 = u5_dot_part_3 + u5_dot_part_4
    let u5_dot_part_5_0 = u5_dot_part_3_0 + u5_dot_part_4_0;
    // u5_dot_part_6 = u5_dot_part_5/sin_q2_minus_90deg
    let u5_dot_part_6_0 = u5_dot_part_5_0 * over_sin_q2_minus_90deg;
    // u5_dot_part_7 = u1_u2 + u5_dot_part_6
    let u5_dot_part_7_0 = u1_u2_0 + u5_dot_part_6_0;
    // u5_dot_part_8 = s1*u5_dot_part_7
    let u5_dot_part_8_0 = s1_0 * u5_dot_part_7_0;
    // u5_dot_part_9 = u1_p2 + u5_dot_part_2
    let u5_dot_part_9_0 = u1_p2_0 + u5_dot_part_2_0;
    // u5_dot_part_10 = cos_q2_minus_90deg*u5_dot_part_9
    let u5_dot_part_10_0 = cos_q2_minus_90deg_0 * u5_dot_part_9_0;
    // u5_dot_part_11 = u5_dot_part - u5_dot_part_10
    let u5_dot_part_11_0 = -u5_dot_part_10_0 + u5_dot_part_0;
    // u5_dot_part_12 = c1*u5_dot_part_11
    let u5_dot_part_12_0 = c1_0 * u5_dot_part_11_0;
    // u5_dot_part_13 = u5_dot_part_8 + u5_dot_part_12
    let u5_dot_part_13_0 = u5_dot_part_8_0 + u5_dot_part_12_0;
    // u4_dot_part = s1*u5_dot_part_11
    let u4_dot_part_0 = s1_0 * u5_dot_part_11_0;
    // u4_dot_part_2 = c1*u5_dot_part_7
    let u4_dot_part_2_0 = c1_0 * u5_dot_part_7_0;
    // u4_dot_part_3 = u4_dot_part - u4_dot_part_2
    let u4_dot_part_3_0 = u4_dot_part_0 - u4_dot_part_2_0;
    // q3_dot_2 = u3 + u2_dot_part
    let q3_dot_2_0 = u3 + u2_dot_part_0;
    // Order 1: the rates, and what follows from them.
    let q1_1 = -u1_dot_part_3_0;
    let q2_minus_90deg_1 = -u1_0;
    let q3_1 = q3_dot_2_0;
    let q4_1 = u4_0;
    let q5_1 = u5_0;
    let u1_1 = u1_dot_2_0;
    let u2_1 = u2_dot_2_0;
    let u4_1 = R * u4_dot_part_3_0;
    let u5_1 = minus_r * u5_dot_part_13_0;
    if series.len() > 1 {
        series[1] = [
            q1_1,
            q2_minus_90deg_1,
            q3_1,
            q4_1,
            q5_1,
            u1_1,
            u2_1,
            S::int(0),
            u4_1,
            u5_1,
        ];
    }
    let sin_q2_minus_90deg_1 = q2_minus_90deg_1 * cos_q2_minus_90deg_0;
    let cos_q2_minus_90deg_1 = -q2_minus_90deg_1 * sin_q2_minus_90deg_0;
    let u1_dot_part_1 = sin_q2_minus_90deg_1
        * (sin_q2_minus_90deg_0 + sin_q2_minus_90deg_0);
    let u1_dot_part_2_1 = S::int(4) * u1_dot_part_1;
    let u1_dot_part_3_1 = sin_q2_minus_90deg_1
        .mul_add(
            -(u1_dot_part_3_0 * over_sin_q2_minus_90deg),
            u2_1 * over_sin_q2_minus_90deg,
        );
    let u1_dot_part_4_1 = u1_dot_part_3_1.mul_add(u2_0, u2_1 * u1_dot_part_3_0);
    let u1_p2_1 = u1_1 * (u1_0 + u1_0);
    let u1_dot_part_5_1 = u1_p2_1
        .mul_add(sin_q2_minus_90deg_0, sin_q2_minus_90deg_1 * u1_p2_0);
    let u1_dot_part_6_1 = S::int(4) * u1_dot_part_5_1 + u1_dot_part_4_1;
    let u1_dot_part_7_1 = u1_dot_part_6_1
        .mul_add(cos_q2_minus_90deg_0, cos_q2_minus_90deg_1 * u1_dot_part_6_0);
    let u1_dot_part_8_1 = weight_2 * u2_1 + u1_dot_part_7_1;
    let u1_dot_2_1 = u1_dot_part_2_1
        .mul_add(
            -(u1_dot_2_0 * over_u1_dot_part_2),
            u1_dot_part_8_1 * over_u1_dot_part_2,
        );
    let u2_dot_part_1 = u1_dot_part_3_1
        .mul_add(cos_q2_minus_90deg_0, cos_q2_minus_90deg_1 * u1_dot_part_3_0);
    let u2_dot_part_2_1 = u2_dot_part_1;
    let u2_dot_2_1 = u2_dot_part_2_1.mul_add(u1_0, u1_1 * u2_dot_part_2_0);
    let s1_1 = q1_1 * c1_0;
    let c1_1 = -q1_1 * s1_0;
    let u5_dot_part_1 = u1_dot_2_1
        .mul_add(sin_q2_minus_90deg_0, sin_q2_minus_90deg_1 * u1_dot_2_0);
    let u5_dot_part_2_1 = u1_dot_part_3_1 * (u1_dot_part_3_0 + u1_dot_part_3_0);
    let u1_u2_1 = u2_1.mul_add(u1_0, u1_1 * u2_0);
    let u5_dot_part_3_1 = u1_dot_part_3_1.mul_add(u1_0, u1_1 * u1_dot_part_3_0);
    let u5_dot_part_4_1 = u2_dot_2_1
        .mul_add(cos_q2_minus_90deg_0, cos_q2_minus_90deg_1 * u2_dot_2_0);
    let u5_dot_part_5_1 = u5_dot_part_3_1 + u5_dot_part_4_1;
    let u5_dot_part_6_1 = sin_q2_minus_90deg_1
        .mul_add(
            -(u5_dot_part_6_0 * over_sin_q2_minus_90deg),
            u5_dot_part_5_1 * over_sin_q2_minus_90deg,
        );
    let u5_dot_part_7_1 = u1_u2_1 + u5_dot_part_6_1;
    let u5_dot_part_8_1 = u5_dot_part_7_1.mul_add(s1_0, s1_1 * u5_dot_part_7_0);
    let u5_dot_part_9_1 = u1_p2_1 + u5_dot_part_2_1;
    let u5_dot_part_10_1 = u5_dot_part_9_1
        .mul_add(cos_q2_minus_90deg_0, cos_q2_minus_90deg_1 * u5_dot_part_9_0);
    let u5_dot_part_11_1 = -u5_dot_part_10_1 + u5_dot_part_1;
    let u5_dot_part_12_1 = u5_dot_part_11_1.mul_add(c1_0, c1_1 * u5_dot_part_11_0);
    let u5_dot_part_13_1 = u5_dot_part_8_1 + u5_dot_part_12_1;
    let u4_dot_part_1 = u5_dot_part_11_1.mul_add(s1_0, s1_1 * u5_dot_part_11_0);
    let u4_dot_part_2_1 = u5_dot_part_7_1.mul_add(c1_0, c1_1 * u5_dot_part_7_0);
    let u4_dot_part_3_1 = u4_dot_part_1 - u4_dot_part_2_1;
    let q3_dot_2_1 = u2_dot_part_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            [
                q2_minus_90deg_1,
                q2_minus_90deg_1,
                sin_q2_minus_90deg_1,
                sin_q2_minus_90deg_1,
                u2_1,
                u1_1,
                sin_q2_minus_90deg_1,
                cos_q2_minus_90deg_1,
                u1_dot_part_2_1,
                cos_q2_minus_90deg_1,
                u1_1,
                q1_1,
                q1_1,
                u1_dot_2_1,
                u1_dot_part_3_1,
                u1_1,
                u1_1,
                u2_dot_2_1,
                sin_q2_minus_90deg_1,
                s1_1,
                cos_q2_minus_90deg_1,
                c1_1,
                s1_1,
                c1_1,
            ],
            [
                cos_q2_minus_90deg_1,
                sin_q2_minus_90deg_1,
                sin_q2_minus_90deg_1,
                u1_dot_part_3_1,
                u1_dot_part_3_1,
                u1_1,
                u1_p2_1,
                u1_dot_part_6_1,
                u1_dot_2_1,
                u1_dot_part_3_1,
                u2_dot_part_2_1,
                c1_1,
                s1_1,
                sin_q2_minus_90deg_1,
                u1_dot_part_3_1,
                u2_1,
                u1_dot_part_3_1,
                cos_q2_minus_90deg_1,
                u5_dot_part_6_1,
                u5_dot_part_7_1,
                u5_dot_part_9_1,
                u5_dot_part_11_1,
                u5_dot_part_11_1,
                u5_dot_part_7_1,
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
    let mut u1_dot_part_2_last = u1_dot_part_2_1;
    let mut u1_dot_part_3_last = u1_dot_part_3_1;
    let mut u1_p2_last = u1_p2_1;
    let mut u1_dot_part_6_last = u1_dot_part_6_1;
    let mut u1_dot_2_last = u1_dot_2_1;
    let mut u2_dot_part_2_last = u2_dot_part_2_1;
    let mut u2_dot_2_last = u2_dot_2_1;
    let mut s1_last = s1_1;
    let mut c1_last = c1_1;
    let mut u5_dot_part_6_last = u5_dot_part_6_1;
    let mut u5_dot_part_7_last = u5_dot_part_7_1;
    let mut u5_dot_part_9_last = u5_dot_part_9_1;
    let mut u5_dot_part_11_last = u5_dot_part_11_1;
    let mut next = [S::int(0); 24];
    // Rates at order k - 1.
    let mut q1_rate = -u1_dot_part_3_1;
    let mut q2_minus_90deg_rate = -u1_1;
    let mut q3_rate = q3_dot_2_1;
    let mut q4_rate = u4_1;
    let mut q5_rate = u5_1;
    let mut u1_rate = u1_dot_2_1;
    let mut u2_rate = u2_dot_2_1;
    let mut u4_rate = R * u4_dot_part_3_1;
    let mut u5_rate = minus_r * u5_dot_part_13_1;
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
                        u1_dot_part_3_last,
                        sin_q2_minus_90deg_last.mul_add(u1_dot_part_3_1, next[3]),
                    ),
                u2_1
                    .mul_add(
                        u1_dot_part_3_last,
                        u2_last.mul_add(u1_dot_part_3_1, next[4]),
                    ),
                (u1_1 + u1_1).mul_add(u1_last, next[5]),
                sin_q2_minus_90deg_1
                    .mul_add(
                        u1_p2_last,
                        sin_q2_minus_90deg_last.mul_add(u1_p2_1, next[6]),
                    ),
                cos_q2_minus_90deg_1
                    .mul_add(
                        u1_dot_part_6_last,
                        cos_q2_minus_90deg_last.mul_add(u1_dot_part_6_1, next[7]),
                    ),
                u1_dot_part_2_1
                    .mul_add(
                        u1_dot_2_last,
                        u1_dot_part_2_last.mul_add(u1_dot_2_1, next[8]),
                    ),
                cos_q2_minus_90deg_1
                    .mul_add(
                        u1_dot_part_3_last,
                        cos_q2_minus_90deg_last.mul_add(u1_dot_part_3_1, next[9]),
                    ),
                u1_1
                    .mul_add(
                        u2_dot_part_2_last,
                        u1_last.mul_add(u2_dot_part_2_1, next[10]),
                    ),
                q1_1.mul_add(c1_last, (count_last * q1_last).mul_add(c1_1, next[11])),
                q1_1.mul_add(s1_last, (count_last * q1_last).mul_add(s1_1, next[12])),
                u1_dot_2_1
                    .mul_add(
                        sin_q2_minus_90deg_last,
                        u1_dot_2_last.mul_add(sin_q2_minus_90deg_1, next[13]),
                    ),
                (u1_dot_part_3_1 + u1_dot_part_3_1)
                    .mul_add(u1_dot_part_3_last, next[14]),
                u1_1.mul_add(u2_last, u1_last.mul_add(u2_1, next[15])),
                u1_1
                    .mul_add(
                        u1_dot_part_3_last,
                        u1_last.mul_add(u1_dot_part_3_1, next[16]),
                    ),
                u2_dot_2_1
                    .mul_add(
                        cos_q2_minus_90deg_last,
                        u2_dot_2_last.mul_add(cos_q2_minus_90deg_1, next[17]),
                    ),
                sin_q2_minus_90deg_1
                    .mul_add(
                        u5_dot_part_6_last,
                        sin_q2_minus_90deg_last.mul_add(u5_dot_part_6_1, next[18]),
                    ),
                s1_1
                    .mul_add(
                        u5_dot_part_7_last,
                        s1_last.mul_add(u5_dot_part_7_1, next[19]),
                    ),
                cos_q2_minus_90deg_1
                    .mul_add(
                        u5_dot_part_9_last,
                        cos_q2_minus_90deg_last.mul_add(u5_dot_part_9_1, next[20]),
                    ),
                c1_1
                    .mul_add(
                        u5_dot_part_11_last,
                        c1_last.mul_add(u5_dot_part_11_1, next[21]),
                    ),
                s1_1
                    .mul_add(
                        u5_dot_part_11_last,
                        s1_last.mul_add(u5_dot_part_11_1, next[22]),
                    ),
                c1_1
                    .mul_add(
                        u5_dot_part_7_last,
                        c1_last.mul_add(u5_dot_part_7_1, next[23]),
                    ),
            ]
        };
        // sin_q2_minus_90deg = sin(q2_minus_90deg)
        let sin_q2_minus_90deg = q2_minus_90deg
            .mul_add(cos_q2_minus_90deg_0, sums[0] * over_k);
        // cos_q2_minus_90deg = cos(q2_minus_90deg)
        let cos_q2_minus_90deg = -q2_minus_90deg
            .mul_add(sin_q2_minus_90deg_0, sums[1] * over_k);
        // u1_dot_part = sin_q2_minus_90deg*sin_q2_minus_90deg
        let u1_dot_part = sin_q2_minus_90deg
            .mul_add(sin_q2_minus_90deg_0 + sin_q2_minus_90deg_0, sums[2]);
        // u1_dot_part_2 = -5 + 4*u1_dot_part
        let u1_dot_part_2 = S::int(4) * u1_dot_part;
        // u1_dot_part_3 = u2/sin_q2_minus_90deg
        let u1_dot_part_3 = sin_q2_minus_90deg
            .mul_add(
                -(u1_dot_part_3_0 * over_sin_q2_minus_90deg),
                (u2 - sums[3]) * over_sin_q2_minus_90deg,
            );
        // u1_dot_part_4 = u2*u1_dot_part_3
        let u1_dot_part_4 = u1_dot_part_3
            .mul_add(u2_0, u2.mul_add(u1_dot_part_3_0, sums[4]));
        // u1_p2 = u1*u1
        let u1_p2 = u1.mul_add(u1_0 + u1_0, sums[5]);
        // u1_dot_part_5 = sin_q2_minus_90deg*u1_p2
        let u1_dot_part_5 = u1_p2
            .mul_add(sin_q2_minus_90deg_0, sin_q2_minus_90deg.mul_add(u1_p2_0, sums[6]));
        // u1_dot_part_6 = weight + u1_dot_part_4 + 4*u1_dot_part_5
        let u1_dot_part_6 = S::int(4) * u1_dot_part_5 + u1_dot_part_4;
        // u1_dot_part_7 = cos_q2_minus_90deg*u1_dot_part_6
        let u1_dot_part_7 = u1_dot_part_6
            .mul_add(
                cos_q2_minus_90deg_0,
                cos_q2_minus_90deg.mul_add(u1_dot_part_6_0, sums[7]),
            );
        // u1_dot_part_8 = weight_2*u2 + u1_dot_part_7
        let u1_dot_part_8 = weight_2 * u2 + u1_dot_part_7;
        // u1_dot_2 = u1_dot_part_8/u1_dot_part_2
        let u1_dot_2 = u1_dot_part_8
            .mul_add(
                over_u1_dot_part_2,
                -(u1_dot_part_2.mul_add(u1_dot_2_0, sums[8]) * over_u1_dot_part_2),
            );
        // u2_dot_part = cos_q2_minus_90deg*u1_dot_part_3
        let u2_dot_part = u1_dot_part_3
            .mul_add(
                cos_q2_minus_90deg_0,
                cos_q2_minus_90deg.mul_add(u1_dot_part_3_0, sums[9]),
            );
        // u2_dot_part_2 = weight_2 + u2_dot_part
        let u2_dot_part_2 = u2_dot_part;
        // u2_dot_2 = u1*u2_dot_part_2
        let u2_dot_2 = u2_dot_part_2
            .mul_add(u1_0, u1.mul_add(u2_dot_part_2_0, sums[10]));
        // s1 = sin(q1)
        let s1 = q1.mul_add(c1_0, sums[11] * over_k);
        // c1 = cos(q1)
        let c1 = -q1.mul_add(s1_0, sums[12] * over_k);
        // u5_dot_part = u1_dot_2*sin_q2_minus_90deg
        let u5_dot_part = u1_dot_2
            .mul_add(
                sin_q2_minus_90deg_0,
                sin_q2_minus_90deg.mul_add(u1_dot_2_0, sums[13]),
            );
        // u5_dot_part_2 = u1_dot_part_3*u1_dot_part_3
        let u5_dot_part_2 = u1_dot_part_3
            .mul_add(u1_dot_part_3_0 + u1_dot_part_3_0, sums[14]);
        // u1_u2 = u1*u2
        let u1_u2 = u2.mul_add(u1_0, u1.mul_add(u2_0, sums[15]));
        // u5_dot_part_3 = u1*u1_dot_part_3
        let u5_dot_part_3 = u1_dot_part_3
            .mul_add(u1_0, u1.mul_add(u1_dot_part_3_0, sums[16]));
        // u5_dot_part_4 = u2_dot_2*cos_q2_minus_90deg
        let u5_dot_part_4 = u2_dot_2
            .mul_add(
                cos_q2_minus_90deg_0,
                cos_q2_minus_90deg.mul_add(u2_dot_2_0, sums[17]),
            );
        // u5_dot_part_5 = u5_dot_part_3 + u5_dot_part_4
        let u5_dot_part_5 = u5_dot_part_3 + u5_dot_part_4;
        // u5_dot_part_6 = u5_dot_part_5/sin_q2_minus_90deg
        let u5_dot_part_6 = u5_dot_part_5
            .mul_add(
                over_sin_q2_minus_90deg,
                -(sin_q2_minus_90deg.mul_add(u5_dot_part_6_0, sums[18])
                    * over_sin_q2_minus_90deg),
            );
        // u5_dot_part_7 = u1_u2 + u5_dot_part_6
        let u5_dot_part_7 = u1_u2 + u5_dot_part_6;
        // u5_dot_part_8 = s1*u5_dot_part_7
        let u5_dot_part_8 = u5_dot_part_7
            .mul_add(s1_0, s1.mul_add(u5_dot_part_7_0, sums[19]));
        // u5_dot_part_9 = u1_p2 + u5_dot_part_2
        let u5_dot_part_9 = u1_p2 + u5_dot_part_2;
        // u5_dot_part_10 = cos_q2_minus_90deg*u5_dot_part_9
        let u5_dot_part_10 = u5_dot_part_9
            .mul_add(
                cos_q2_minus_90deg_0,
                cos_q2_minus_90deg.mul_add(u5_dot_part_9_0, sums[20]),
            );
        // u5_dot_part_11 = u5_dot_part - u5_dot_part_10
        let u5_dot_part_11 = -u5_dot_part_10 + u5_dot_part;
        // u5_dot_part_12 = c1*u5_dot_part_11
        let u5_dot_part_12 = u5_dot_part_11
            .mul_add(c1_0, c1.mul_add(u5_dot_part_11_0, sums[21]));
        // u5_dot_part_13 = u5_dot_part_8 + u5_dot_part_12
        let u5_dot_part_13 = u5_dot_part_8 + u5_dot_part_12;
        // u4_dot_part = s1*u5_dot_part_11
        let u4_dot_part = u5_dot_part_11
            .mul_add(s1_0, s1.mul_add(u5_dot_part_11_0, sums[22]));
        // u4_dot_part_2 = c1*u5_dot_part_7
        let u4_dot_part_2 = u5_dot_part_7
            .mul_add(c1_0, c1.mul_add(u5_dot_part_7_0, sums[23]));
        // u4_dot_part_3 = u4_dot_part - u4_dot_part_2
        let u4_dot_part_3 = u4_dot_part - u4_dot_part_2;
        // q3_dot_2 = u3 + u2_dot_part
        let q3_dot_2 = u2_dot_part;
        q1_rate = -u1_dot_part_3;
        q2_minus_90deg_rate = -u1;
        q3_rate = q3_dot_2;
        q4_rate = u4;
        q5_rate = u5;
        u1_rate = u1_dot_2;
        u2_rate = u2_dot_2;
        u4_rate = R * u4_dot_part_3;
        u5_rate = minus_r * u5_dot_part_13;
        // Factors of the convolutions: left, right.
        history[order] = [
            [
                count * q2_minus_90deg,
                count * q2_minus_90deg,
                sin_q2_minus_90deg,
                sin_q2_minus_90deg,
                u2,
                u1,
                sin_q2_minus_90deg,
                cos_q2_minus_90deg,
                u1_dot_part_2,
                cos_q2_minus_90deg,
                u1,
                count * q1,
                count * q1,
                u1_dot_2,
                u1_dot_part_3,
                u1,
                u1,
                u2_dot_2,
                sin_q2_minus_90deg,
                s1,
                cos_q2_minus_90deg,
                c1,
                s1,
                c1,
            ],
            [
                cos_q2_minus_90deg,
                sin_q2_minus_90deg,
                sin_q2_minus_90deg,
                u1_dot_part_3,
                u1_dot_part_3,
                u1,
                u1_p2,
                u1_dot_part_6,
                u1_dot_2,
                u1_dot_part_3,
                u2_dot_part_2,
                c1,
                s1,
                sin_q2_minus_90deg,
                u1_dot_part_3,
                u2,
                u1_dot_part_3,
                cos_q2_minus_90deg,
                u5_dot_part_6,
                u5_dot_part_7,
                u5_dot_part_9,
                u5_dot_part_11,
                u5_dot_part_11,
                u5_dot_part_7,
            ],
        ];
        count_last = count;
        q1_last = q1;
        q2_minus_90deg_last = q2_minus_90deg;
        u1_last = u1;
        u2_last = u2;
        sin_q2_minus_90deg_last = sin_q2_minus_90deg;
        cos_q2_minus_90deg_last = cos_q2_minus_90deg;
        u1_dot_part_2_last = u1_dot_part_2;
        u1_dot_part_3_last = u1_dot_part_3;
        u1_p2_last = u1_p2;
        u1_dot_part_6_last = u1_dot_part_6;
        u1_dot_2_last = u1_dot_2;
        u2_dot_part_2_last = u2_dot_part_2;
        u2_dot_2_last = u2_dot_2;
        s1_last = s1;
        c1_last = c1;
        u5_dot_part_6_last = u5_dot_part_6;
        u5_dot_part_7_last = u5_dot_part_7;
        u5_dot_part_9_last = u5_dot_part_9;
        u5_dot_part_11_last = u5_dot_part_11;
    }
}

/// Newton–Euler equations in q2-90° of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEulerQ290deg;

impl<S: Scalar> System<S> for NewtonEulerQ290deg {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 3,
            coordinates: 5,
            variables: 5,
            speeds: 5,
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
