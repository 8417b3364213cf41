//! Four-bar linkage: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/four_bar/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u1.
///
/// 18 operations, 3 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    _u: &[S; 1],
) -> [[S; 1]; 1] {
    let Parameters { a, ma, mb, mc, .. } = *p;
    let [q1, q2, q3] = *q;
    // Sines and cosines.
    let (sin_q2_minus_q3, _) = (q2 - q3).sin_cos();
    // Shared terms.
    let sin_q2_minus_q3_inv = S::int(1) / sin_q2_minus_q3;
    let (sin_q1_minus_q3, _) = (q1 - q3).sin_cos();
    let m11_of_q1_q2_q3 = sin_q2_minus_q3_inv * sin_q1_minus_q3;
    // q1 - q2
    let q1_minus_q2 = q1 - q2;
    let (sin_q1_minus_q2, cos_q1_minus_q2) = q1_minus_q2.sin_cos();
    let m11_of_q1_q2_q3_2 = sin_q2_minus_q3_inv * sin_q1_minus_q2;
    // Entries that are not zero; upper triangle.
    // M11 = a^2*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 -
    //   q3)/sin(q2 - q3))/sin(q2 - q3)))/3
    let m11 = S::ratio(1, 3) * a * a
        * (ma
            + mb
                * (S::int(3)
                    - m11_of_q1_q2_q3 * cos_q1_minus_q2.mul_add(S::int(3), -m11_of_q1_q2_q3))
            + mc * m11_of_q1_q2_q3_2 * m11_of_q1_q2_q3_2);
    [[m11]]
}

/// Right-hand side of the linear system; unknowns (u1').
///
/// 66 operations, 4 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [S; 1] {
    let Parameters { a, b, c, ma, mb, mc, g, .. } = *p;
    let [q1, q2, q3] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // q2 - q3
    let q2_minus_q3 = q2 - q3;
    let (sin_q2_minus_q3, cos_q2_minus_q3) = q2_minus_q3.sin_cos();
    let sin_q2_minus_q3_inv = S::int(1) / sin_q2_minus_q3;
    let a_sin_q2_minus_q3_inv = a * sin_q2_minus_q3_inv;
    // sin(q1)*cos(q2) - cos(q1)*sin(q2)
    let sin_q1_minus_q2 = (-c1).mul_add(s2, s1 * c2);
    let mc_sin_q1_minus_q2 = mc * sin_q1_minus_q2;
    // sin(q1)*cos(q3) - cos(q1)*sin(q3)
    let sin_q1_minus_q3 = (-c1).mul_add(s3, s1 * c3);
    let mb_sin_q1_minus_q3 = mb * sin_q1_minus_q3;
    let u1_a_sin_q2_minus_q3_inv = u1 * a_sin_q2_minus_q3_inv;
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let cos_q1_minus_q2 = c1.mul_add(c2, s1 * s2);
    let b_inv_sin_q1_minus_q3 = sin_q1_minus_q3 / b;
    // 1 + a_sin_q2_minus_q3_inv*b_inv_sin_q1_minus_q3
    let f1_of_a_b_q1_q2_q3 = a_sin_q2_minus_q3_inv
        .mul_add(b_inv_sin_q1_minus_q3, S::int(1));
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let cos_q1_minus_q3 = c1.mul_add(c3, s1 * s3);
    let f1_of_q2_q3 = S::int(2) * sin_q2_minus_q3_inv;
    // sin(q1 - q3)*f1_of_q2_q3 - 3*cos(q1 - q2)
    let f1_of_q1_q2_q3 = (-cos_q1_minus_q2)
        .mul_add(S::int(3), sin_q1_minus_q3 * f1_of_q2_q3);
    let c_inv_sin_q1_minus_q2 = sin_q1_minus_q2 / c;
    // a*mb*(3*u1*sin(q1 - q3)*sin(q1 - q2)*f1_of_a_b_q1_q2_q3 + cos(q1 - q3)*f1_of_q1_q2_q3*(u1 +
    //   u1_a_sin_q2_minus_q3_inv*c_inv_sin_q1_minus_q2)) +
    //   a_sin_q2_minus_q3_inv*u1_a_sin_q2_minus_q3_inv*cos(q2 - q3)*(sin(q1 -
    //   q2)*mc_sin_q1_minus_q2*f1_of_q2_q3 + mb_sin_q1_minus_q3*f1_of_q1_q2_q3)*(b_inv_sin_q1_minus_q3 -
    //   c_inv_sin_q1_minus_q2)
    let f1_of_u1 = a * mb
        * (cos_q1_minus_q3 * f1_of_q1_q2_q3
            * u1_a_sin_q2_minus_q3_inv.mul_add(c_inv_sin_q1_minus_q2, u1)
            + S::int(3) * u1 * sin_q1_minus_q3 * sin_q1_minus_q2 * f1_of_a_b_q1_q2_q3)
        + a_sin_q2_minus_q3_inv * u1_a_sin_q2_minus_q3_inv * cos_q2_minus_q3
            * mb_sin_q1_minus_q3
                .mul_add(
                    f1_of_q1_q2_q3,
                    sin_q1_minus_q2 * mc_sin_q1_minus_q2 * f1_of_q2_q3,
                ) * (b_inv_sin_q1_minus_q3 - c_inv_sin_q1_minus_q2);
    // Values.
    // f1 = a*((3*g*(mb*cos(q2)*sin(q1 - q3) + mc*sin(q1 - q2)*cos(q3)) + a*u1^2*((a*((2*mc*sin(q1 -
    //   q2)^3/(c*tan(q2 - q3)) + sin(q1 - q3)*(mb*(cos(q2 - q3)*(sin(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 -
    //   q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 - q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1
    //   - q2)*cos(q1 - q3)/c) - 2*mc*sin(q1 - q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b))/sin(q2 -
    //   q3) + 3*mb*sin(q1 - q2)*(cos(q1 - q2)*cos(q1 - q3)/c - sin(q1 - q3)^2/b)) - 2*mc*sin(q1 - q2)*cos(q1
    //   - q2) - 2*mb*sin(q1 - q3)*cos(q1 - q3))/sin(q2 - q3) + 3*mb*(cos(q1 - q2)*cos(q1 - q3) - sin(q1 -
    //   q2)*sin(q1 - q3))))/sin(q2 - q3) - 3*g*cos(q1)*(ma + 2*mb))/6
    let f1 = S::ratio(1, 2) * g
        * (a_sin_q2_minus_q3_inv * mb_sin_q1_minus_q3.mul_add(c2, mc_sin_q1_minus_q2 * c3)
            - a * c1 * mb.mul_add(S::int(2), ma))
        - S::ratio(1, 6) * u1_a_sin_q2_minus_q3_inv
            * (cos_q1_minus_q2 * mc_sin_q1_minus_q2 * u1_a_sin_q2_minus_q3_inv * f1_of_a_b_q1_q2_q3)
                .mul_add(S::int(2), f1_of_u1);
    [f1]
}

/// The accelerations (u1'), solved for when this code was generated.
///
/// 77 operations, 4 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [S; 1] {
    let Parameters { a, b, c, ma, mb, mc, g, .. } = *p;
    let [q1, q2, q3] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s3, c3) = q3.sin_cos();
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // sin(q1)*cos(q3) - cos(q1)*sin(q3)
    let sin_q1_minus_q3 = (-c1).mul_add(s3, s1 * c3);
    // q2 - q3
    let q2_minus_q3 = q2 - q3;
    let (sin_q2_minus_q3, cos_q2_minus_q3) = q2_minus_q3.sin_cos();
    let sin_q2_minus_q3_inv = S::int(1) / sin_q2_minus_q3;
    let u1_dot_of_q1_q2_q3 = sin_q1_minus_q3 * sin_q2_minus_q3_inv;
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let cos_q1_minus_q2 = c1.mul_add(c2, s1 * s2);
    let cos_q1_minus_q2_times_3 = S::int(3) * cos_q1_minus_q2;
    // sin(q1)*cos(q2) - cos(q1)*sin(q2)
    let sin_q1_minus_q2 = (-c1).mul_add(s2, s1 * c2);
    let u1_dot_of_q1_q2_q3_2 = sin_q1_minus_q2 * sin_q2_minus_q3_inv;
    let mc_u1_dot_of_q1_q2_q3_2 = mc * u1_dot_of_q1_q2_q3_2;
    // 1/(ma + mb*(3 + u1_dot_of_q1_q2_q3*(u1_dot_of_q1_q2_q3 - cos_q1_minus_q2_times_3)) +
    //   u1_dot_of_q1_q2_q3_2*mc_u1_dot_of_q1_q2_q3_2)
    let u1_dot_of_place = S::int(1)
        / (ma
            + mb
                * (S::int(3)
                    + u1_dot_of_q1_q2_q3 * (u1_dot_of_q1_q2_q3 - cos_q1_minus_q2_times_3))
            + u1_dot_of_q1_q2_q3_2 * mc_u1_dot_of_q1_q2_q3_2);
    // mb*u1_dot_of_q1_q2_q3*cos(q2) + mc_u1_dot_of_q1_q2_q3_2*cos(q3)
    let u1_dot_of_place_2 = mc_u1_dot_of_q1_q2_q3_2
        .mul_add(c3, mb * u1_dot_of_q1_q2_q3 * c2);
    let u1_sin_q2_minus_q3_inv = u1 * sin_q2_minus_q3_inv;
    let b_inv = S::int(1) / b;
    // 1 + a*u1_dot_of_q1_q2_q3*b_inv
    let u1_dot_of_a_b_q1_q2_q3 = (a * u1_dot_of_q1_q2_q3).mul_add(b_inv, S::int(1));
    let c_inv_sin_q1_minus_q2 = sin_q1_minus_q2 / c;
    // cos(q2 - q3)*(sin(q1 - q3)*b_inv - c_inv_sin_q1_minus_q2)
    let u1_dot_of_b_c_q1_q2_q3 = cos_q2_minus_q3
        * sin_q1_minus_q3.mul_add(b_inv, -c_inv_sin_q1_minus_q2);
    let u1_dot_of_u1 = u1_dot_of_place * u1_sin_q2_minus_q3_inv;
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let cos_q1_minus_q3 = c1.mul_add(c3, s1 * s3);
    // u1' = ((3*g*(mb*cos(q2)*sin(q1 - q3) + mc*sin(q1 - q2)*cos(q3)) + a*u1^2*((a*((2*mc*sin(q1 -
    //   q2)^3/(c*tan(q2 - q3)) + sin(q1 - q3)*(mb*(cos(q2 - q3)*(sin(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 -
    //   q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 - q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1
    //   - q2)*cos(q1 - q3)/c) - 2*mc*sin(q1 - q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b))/sin(q2 -
    //   q3) + 3*mb*sin(q1 - q2)*(cos(q1 - q2)*cos(q1 - q3)/c - sin(q1 - q3)^2/b)) - 2*mc*sin(q1 - q2)*cos(q1
    //   - q2) - 2*mb*sin(q1 - q3)*cos(q1 - q3))/sin(q2 - q3) + 3*mb*(cos(q1 - q2)*cos(q1 - q3) - sin(q1 -
    //   q2)*sin(q1 - q3))))/sin(q2 - q3) - 3*g*cos(q1)*(ma + 2*mb))/(2*a*(ma + mc*sin(q1 - q2)^2/sin(q2 -
    //   q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3))))
    let u1_dot = S::ratio(3, 2) * g * u1_dot_of_place
        * (u1_dot_of_place_2 - c1 * mb.mul_add(S::int(2), ma)) / a
        - mc * sin_q1_minus_q2 * u1_sin_q2_minus_q3_inv * u1_dot_of_u1
            * (a * sin_q2_minus_q3_inv * u1_dot_of_q1_q2_q3_2)
                .mul_add(
                    u1_dot_of_b_c_q1_q2_q3,
                    cos_q1_minus_q2 * u1_dot_of_a_b_q1_q2_q3,
                )
        - S::ratio(1, 2) * mb * u1_dot_of_u1
            * (u1_dot_of_q1_q2_q3.mul_add(S::int(2), -cos_q1_minus_q2_times_3)
                * (a * u1_sin_q2_minus_q3_inv
                    * u1_dot_of_q1_q2_q3
                        .mul_add(
                            u1_dot_of_b_c_q1_q2_q3,
                            cos_q1_minus_q3 * c_inv_sin_q1_minus_q2,
                        ) + u1 * cos_q1_minus_q3)
                + S::int(3) * u1 * sin_q1_minus_q3 * sin_q1_minus_q2 * u1_dot_of_a_b_q1_q2_q3);
    [u1_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 13 operations, 3 sines and cosines.
#[must_use]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [S; 3] {
    let Parameters { a, b, c, .. } = *p;
    let [q1, q2, q3] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_q2_minus_q3, _) = (q2 - q3).sin_cos();
    let (sin_q1_minus_q3, _) = (q1 - q3).sin_cos();
    let (sin_q1_minus_q2, _) = (q1 - q2).sin_cos();
    // Values.
    // q1' = u1
    let q1_dot_value = u1;
    // q2' = -a*u1*sin(q1 - q3)/(b*sin(q2 - q3))
    let q2_dot_value = -a * u1 * sin_q1_minus_q3 / (b * sin_q2_minus_q3);
    // q3' = -a*u1*sin(q1 - q2)/(c*sin(q2 - q3))
    let q3_dot_value = -a * u1 * sin_q1_minus_q2 / (c * sin_q2_minus_q3);
    [q1_dot_value, q2_dot_value, q3_dot_value]
}

/// Kinetic energy T.
///
/// 19 operations, 3 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> S {
    let Parameters { a, ma, mb, mc, .. } = *p;
    let [q1, q2, q3] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (sin_q2_minus_q3, _) = (q2 - q3).sin_cos();
    // Shared terms.
    let sin_q2_minus_q3_inv = S::int(1) / sin_q2_minus_q3;
    let (sin_q1_minus_q3, _) = (q1 - q3).sin_cos();
    let energy_of_q1_q2_q3 = sin_q2_minus_q3_inv * sin_q1_minus_q3;
    // q1 - q2
    let q1_minus_q2 = q1 - q2;
    let (sin_q1_minus_q2, cos_q1_minus_q2) = q1_minus_q2.sin_cos();
    let energy_of_q1_q2_q3_2 = sin_q2_minus_q3_inv * sin_q1_minus_q2;
    let a_u1 = a * u1;
    // Values.
    // T = a^2*u1^2*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1
    //   - q3)/sin(q2 - q3))/sin(q2 - q3)))/6
    let energy = S::ratio(1, 6) * a_u1 * a_u1
        * (ma
            + mb
                * (S::int(3)
                    - energy_of_q1_q2_q3 * cos_q1_minus_q2.mul_add(S::int(3), -energy_of_q1_q2_q3))
            + mc * energy_of_q1_q2_q3_2 * energy_of_q1_q2_q3_2);
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 12 operations, 3 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 3]) -> S {
    let Parameters { a, b, c, ma, mb, mc, g, .. } = *p;
    let [q1, q2, q3] = *q;
    // Sines and cosines.
    let (s1, _) = q1.sin_cos();
    let (s2, _) = q2.sin_cos();
    let (s3, _) = q3.sin_cos();
    // Values.
    // V = g*(a*sin(q1)*(ma + 2*mb) + b*mb*sin(q2) + c*mc*sin(q3))/2
    let energy = S::ratio(1, 2) * g
        * (a * s1 * mb.mul_add(S::int(2), ma) + b * mb * s2 + c * mc * s3);
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 81 operations, 4 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 1],
) -> ([S; 3], [S; 1]) {
    let Parameters { a, b, c, ma, mb, mc, g, .. } = *p;
    let [q1, q2, q3] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s3, c3) = q3.sin_cos();
    let (s2, c2) = q2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // sin(q1)*cos(q3) - cos(q1)*sin(q3)
    let sin_q1_minus_q3 = (-c1).mul_add(s3, s1 * c3);
    // q2 - q3
    let q2_minus_q3 = q2 - q3;
    let (sin_q2_minus_q3, cos_q2_minus_q3) = q2_minus_q3.sin_cos();
    let sin_q2_minus_q3_inv = S::int(1) / sin_q2_minus_q3;
    let u1_dot_of_q1_q2_q3 = sin_q1_minus_q3 * sin_q2_minus_q3_inv;
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let cos_q1_minus_q2 = c1.mul_add(c2, s1 * s2);
    let cos_q1_minus_q2_times_3 = S::int(3) * cos_q1_minus_q2;
    // sin(q1)*cos(q2) - cos(q1)*sin(q2)
    let sin_q1_minus_q2 = (-c1).mul_add(s2, s1 * c2);
    let u1_dot_of_q1_q2_q3_2 = sin_q1_minus_q2 * sin_q2_minus_q3_inv;
    let mc_u1_dot_of_q1_q2_q3_2 = mc * u1_dot_of_q1_q2_q3_2;
    // 1/(ma + mb*(3 + u1_dot_of_q1_q2_q3*(u1_dot_of_q1_q2_q3 - cos_q1_minus_q2_times_3)) +
    //   u1_dot_of_q1_q2_q3_2*mc_u1_dot_of_q1_q2_q3_2)
    let u1_dot_of_place = S::int(1)
        / (ma
            + mb
                * (S::int(3)
                    + u1_dot_of_q1_q2_q3 * (u1_dot_of_q1_q2_q3 - cos_q1_minus_q2_times_3))
            + u1_dot_of_q1_q2_q3_2 * mc_u1_dot_of_q1_q2_q3_2);
    // mb*u1_dot_of_q1_q2_q3*cos(q2) + mc_u1_dot_of_q1_q2_q3_2*cos(q3)
    let u1_dot_of_place_2 = mc_u1_dot_of_q1_q2_q3_2
        .mul_add(c3, mb * u1_dot_of_q1_q2_q3 * c2);
    let u1_sin_q2_minus_q3_inv = u1 * sin_q2_minus_q3_inv;
    let b_inv = S::int(1) / b;
    // 1 + a*u1_dot_of_q1_q2_q3*b_inv
    let u1_dot_of_a_b_q1_q2_q3 = (a * u1_dot_of_q1_q2_q3).mul_add(b_inv, S::int(1));
    let c_inv_sin_q1_minus_q2 = sin_q1_minus_q2 / c;
    let sin_q1_minus_q3_b_inv = sin_q1_minus_q3 * b_inv;
    // cos(q2 - q3)*(sin_q1_minus_q3_b_inv - c_inv_sin_q1_minus_q2)
    let u1_dot_of_b_c_q1_q2_q3 = cos_q2_minus_q3 * (sin_q1_minus_q3_b_inv - c_inv_sin_q1_minus_q2);
    let u1_dot_of_u1 = u1_dot_of_place * u1_sin_q2_minus_q3_inv;
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let cos_q1_minus_q3 = c1.mul_add(c3, s1 * s3);
    let a_u1_sin_q2_minus_q3_inv = a * u1_sin_q2_minus_q3_inv;
    // u1' = ((3*g*(mb*cos(q2)*sin(q1 - q3) + mc*sin(q1 - q2)*cos(q3)) + a*u1^2*((a*((2*mc*sin(q1 -
    //   q2)^3/(c*tan(q2 - q3)) + sin(q1 - q3)*(mb*(cos(q2 - q3)*(sin(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 -
    //   q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 - q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1
    //   - q2)*cos(q1 - q3)/c) - 2*mc*sin(q1 - q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b))/sin(q2 -
    //   q3) + 3*mb*sin(q1 - q2)*(cos(q1 - q2)*cos(q1 - q3)/c - sin(q1 - q3)^2/b)) - 2*mc*sin(q1 - q2)*cos(q1
    //   - q2) - 2*mb*sin(q1 - q3)*cos(q1 - q3))/sin(q2 - q3) + 3*mb*(cos(q1 - q2)*cos(q1 - q3) - sin(q1 -
    //   q2)*sin(q1 - q3))))/sin(q2 - q3) - 3*g*cos(q1)*(ma + 2*mb))/(2*a*(ma + mc*sin(q1 - q2)^2/sin(q2 -
    //   q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3))))
    let u1_dot = S::ratio(3, 2) * g * u1_dot_of_place
        * (u1_dot_of_place_2 - c1 * mb.mul_add(S::int(2), ma)) / a
        - mc * sin_q1_minus_q2 * u1_sin_q2_minus_q3_inv * u1_dot_of_u1
            * (a * sin_q2_minus_q3_inv * u1_dot_of_q1_q2_q3_2)
                .mul_add(
                    u1_dot_of_b_c_q1_q2_q3,
                    cos_q1_minus_q2 * u1_dot_of_a_b_q1_q2_q3,
                )
        - S::ratio(1, 2) * mb * u1_dot_of_u1
            * (u1_dot_of_q1_q2_q3.mul_add(S::int(2), -cos_q1_minus_q2_times_3)
                * (a_u1_sin_q2_minus_q3_inv
                    * u1_dot_of_q1_q2_q3
                        .mul_add(
                            u1_dot_of_b_c_q1_q2_q3,
                            cos_q1_minus_q3 * c_inv_sin_q1_minus_q2,
                        ) + u1 * cos_q1_minus_q3)
                + S::int(3) * u1 * sin_q1_minus_q3 * sin_q1_minus_q2 * u1_dot_of_a_b_q1_q2_q3);
    // Values.
    // q1' = u1
    let q1_dot_value = u1;
    // q2' = -a*u1*sin(q1 - q3)/(b*sin(q2 - q3))
    let q2_dot_value = -sin_q1_minus_q3_b_inv * a_u1_sin_q2_minus_q3_inv;
    // q3' = -a*u1*sin(q1 - q2)/(c*sin(q2 - q3))
    let q3_dot_value = -c_inv_sin_q1_minus_q2 * a_u1_sin_q2_minus_q3_inv;
    ([q1_dot_value, q2_dot_value, q3_dot_value], [u1_dot])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 1 operation, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 3], _u: &[S; 1]) -> [S; 1] {
    let [_, q2, q3] = *q;
    // Sines and cosines.
    let (sin_q2_minus_q3, _) = (q2 - q3).sin_cos();
    // Values.
    // divisor1 = sin(q2 - q3)
    let divisor1 = sin_q2_minus_q3;
    [divisor1]
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 11 operations, 3 sines and cosines.
#[must_use]
pub fn constraints<S: Scalar>(p: &Parameters<S>, q: &[S; 3], _u: &[S; 1]) -> [S; 2] {
    let Parameters { a, b, c, d, .. } = *p;
    let [q1, q2, q3] = *q;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Values.
    // loop_x = a*cos(q1) - d + b*cos(q2) - c*cos(q3)
    let residual1 = a.mul_add(c1, -d) + b * c2 - c * c3;
    // loop_y = a*sin(q1) + b*sin(q2) - c*sin(q3)
    let residual2 = b.mul_add(s2, a * s1) - c * s3;
    [residual1, residual2]
}

/// Slopes of the constraints, one after the other, along q1, q2, q3, u1.
///
/// 9 operations, 3 sines and cosines.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    _u: &[S; 1],
) -> [S; 8] {
    let Parameters { a, b, c, .. } = *p;
    let [q1, q2, q3] = *q;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Values.
    // d(loop_x)/d(q1) = -a*sin(q1)
    let residual1_by_q1 = -a * s1;
    // d(loop_x)/d(q2) = -b*sin(q2)
    let residual1_by_q2 = -b * s2;
    // d(loop_x)/d(q3) = c*sin(q3)
    let residual1_by_q3 = c * s3;
    // d(loop_y)/d(q1) = a*cos(q1)
    let residual2_by_q1 = a * c1;
    // d(loop_y)/d(q2) = b*cos(q2)
    let residual2_by_q2 = b * c2;
    // d(loop_y)/d(q3) = -c*cos(q3)
    let residual2_by_q3 = -c * c3;
    let zero = S::int(0);
    [
        residual1_by_q1, residual1_by_q2, residual1_by_q3, zero, residual2_by_q1, residual2_by_q2,
        residual2_by_q3, zero,
    ]
}

/// Inverse dynamics: the generalized forces along (u1) that must act beside the loads of the model for the accelerations to be (u1').
///
/// 80 operations, 4 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 1],
    v_dot: &[S; 1],
) -> [S; 1] {
    let Parameters { a, b, c, ma, mb, mc, g, .. } = *p;
    let [q1, q2, q3] = *q;
    let [u1] = *u;
    let [u1_dot] = *v_dot;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s3, c3) = q3.sin_cos();
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    // q2 - q3
    let q2_minus_q3 = q2 - q3;
    let (sin_q2_minus_q3, cos_q2_minus_q3) = q2_minus_q3.sin_cos();
    let sin_q2_minus_q3_inv = S::int(1) / sin_q2_minus_q3;
    let a_sin_q2_minus_q3_inv = a * sin_q2_minus_q3_inv;
    // sin(q1)*cos(q3) - cos(q1)*sin(q3)
    let sin_q1_minus_q3 = (-c1).mul_add(s3, s1 * c3);
    let mb_sin_q1_minus_q3 = mb * sin_q1_minus_q3;
    // sin(q1)*cos(q2) - cos(q1)*sin(q2)
    let sin_q1_minus_q2 = (-c1).mul_add(s2, s1 * c2);
    let mc_sin_q1_minus_q2 = mc * sin_q1_minus_q2;
    let tau1_of_mc_q1_q2 = sin_q1_minus_q2 * mc_sin_q1_minus_q2;
    let a_ma = a * ma;
    let u1_a_sin_q2_minus_q3_inv = u1 * a_sin_q2_minus_q3_inv;
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let cos_q1_minus_q2 = c1.mul_add(c2, s1 * s2);
    let b_inv_sin_q1_minus_q3 = sin_q1_minus_q3 / b;
    // 1 + a_sin_q2_minus_q3_inv*b_inv_sin_q1_minus_q3
    let tau1_of_a_b_q1_q2_q3 = a_sin_q2_minus_q3_inv
        .mul_add(b_inv_sin_q1_minus_q3, S::int(1));
    let c_inv_sin_q1_minus_q2 = sin_q1_minus_q2 / c;
    let tau1_of_q2_q3 = S::int(2) * sin_q2_minus_q3_inv;
    // sin(q1 - q3)*tau1_of_q2_q3 - 3*cos(q1 - q2)
    let tau1_of_q1_q2_q3 = (-cos_q1_minus_q2)
        .mul_add(S::int(3), sin_q1_minus_q3 * tau1_of_q2_q3);
    let a_mb = a * mb;
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let cos_q1_minus_q3 = c1.mul_add(c3, s1 * s3);
    // Values.
    // tau1 = a*(3*g*cos(q1)*(ma + 2*mb) - (3*g*(mb*cos(q2)*sin(q1 - q3) + mc*sin(q1 - q2)*cos(q3)) +
    //   a*u1^2*((a*((2*mc*sin(q1 - q2)^3/(c*tan(q2 - q3)) + sin(q1 - q3)*(mb*(cos(q2 - q3)*(sin(q1 -
    //   q3)*(2*sin(q1 - q2)/(c*sin(q2 - q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 - q3))/b) - 3*sin(q1
    //   - q2)*cos(q1 - q2)/c) - 2*sin(q1 - q2)*cos(q1 - q3)/c) - 2*mc*sin(q1 - q2)*(cos(q1 - q2) + sin(q1 -
    //   q2)/tan(q2 - q3))/b))/sin(q2 - q3) + 3*mb*sin(q1 - q2)*(cos(q1 - q2)*cos(q1 - q3)/c - sin(q1 -
    //   q3)^2/b)) - 2*mc*sin(q1 - q2)*cos(q1 - q2) - 2*mb*sin(q1 - q3)*cos(q1 - q3))/sin(q2 - q3) +
    //   3*mb*(cos(q1 - q2)*cos(q1 - q3) - sin(q1 - q2)*sin(q1 - q3))))/sin(q2 - q3))/6 + a^2*u1'*(ma +
    //   mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 -
    //   q3))/sin(q2 - q3)))/3
    let tau1 = S::ratio(1, 3) * u1_dot
        * (a_sin_q2_minus_q3_inv * a_sin_q2_minus_q3_inv
            * sin_q1_minus_q3.mul_add(mb_sin_q1_minus_q3, tau1_of_mc_q1_q2) + a * a_ma)
        + S::ratio(1, 2) * g
            * (-a_sin_q2_minus_q3_inv
                * mc_sin_q1_minus_q2.mul_add(c3, mb_sin_q1_minus_q3 * c2) + a_ma * c1)
        + a_mb
            * (u1_dot
                * (-(sin_q1_minus_q3 * cos_q1_minus_q2))
                    .mul_add(a_sin_q2_minus_q3_inv, a) + g * c1)
        + S::ratio(1, 6) * u1_a_sin_q2_minus_q3_inv
            * (u1_a_sin_q2_minus_q3_inv
                * (a_sin_q2_minus_q3_inv * cos_q2_minus_q3
                    * (b_inv_sin_q1_minus_q3 - c_inv_sin_q1_minus_q2)
                    * mb_sin_q1_minus_q3
                        .mul_add(tau1_of_q1_q2_q3, tau1_of_mc_q1_q2 * tau1_of_q2_q3)
                    + S::int(2) * cos_q1_minus_q2 * mc_sin_q1_minus_q2 * tau1_of_a_b_q1_q2_q3)
                + a_mb
                    * (cos_q1_minus_q3 * tau1_of_q1_q2_q3
                        * u1_a_sin_q2_minus_q3_inv.mul_add(c_inv_sin_q1_minus_q2, u1)
                        + S::int(3) * u1 * sin_q1_minus_q3 * sin_q1_minus_q2
                            * tau1_of_a_b_q1_q2_q3));
    [tau1]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    u: &[S; 1],
    direction: &[S; 4],
) -> [S; 4] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[3 + i],
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
            parameters: 8,
            coordinates: 3,
            variables: 1,
            speeds: 1,
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
        ["sin(q2 - q3)"][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn constraint_count(&self) -> usize {
        2
    }
    fn constraint_name(&self, at: usize) -> &str {
        ["loop_x", "loop_y"][at]
    }
    fn constraints(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &constraints(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn constraint_slopes(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &constraint_slopes(&Parameters::from_slice(p), array(q), array(v)),
        );
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
