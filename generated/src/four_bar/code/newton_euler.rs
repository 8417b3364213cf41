//! Four-bar linkage: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/four_bar/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{
    constraint_slopes, constraints, coordinate_rates, divisors, kinetic_energy,
    potential_energy,
};

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows crank force a1, crank force a2, crank moment a3, coupler force b1, coupler force b2, coupler moment b3, rocker force c1, rocker force c2, rocker moment c3.
///
/// 49 operations, 4 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 3],
    _u: &[S; 1],
) -> [[S; 9]; 9] {
    let Parameters { a, b, c, ma, mb, mc, .. } = *p;
    let [q1, q2, q3] = *q;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    let a_halved = S::ratio(1, 2) * a;
    let a_by_12 = S::ratio(1, 12) * a;
    let s1_a_halved = a_halved * s1;
    let c1_a_halved = a_halved * c1;
    // cos(q1)*sin(q2) - sin(q1)*cos(q2)
    let c1_s2_minus_c2_s1 = (-s1).mul_add(c2, c1 * s2);
    let (sin_q2_minus_q3, _) = (q2 - q3).sin_cos();
    let sin_q2_minus_q3_inv = S::int(1) / sin_q2_minus_q3;
    // sin_q2_minus_q3_inv*(cos(q1)*sin(q3) - sin(q1)*cos(q3))
    let m51_of_q1_q2_q3 = sin_q2_minus_q3_inv * (-s1).mul_add(c3, c1 * s3);
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let c1_c2_plus_s1_s2 = c1.mul_add(c2, s1 * s2);
    let b_halved = S::ratio(1, 2) * b;
    let s2_b_halved = b_halved * s2;
    let c2_b_halved = b_halved * c2;
    let m81_of_mc_q1_q2_q3 = mc * c1_s2_minus_c2_s1 * sin_q2_minus_q3_inv;
    let c_halved = S::ratio(1, 2) * c;
    let s3_c_halved = c_halved * s3;
    let c3_c_halved = c_halved * c3;
    // -sin(q3)
    let minus_s3 = -s3;
    // -sin(q2)
    let minus_s2 = -s2;
    // -sin(q1)
    let minus_s1 = -s1;
    // -cos(q1)
    let minus_c1 = -c1;
    // -cos(q2)
    let minus_c2 = -c2;
    // -cos(q3)
    let minus_c3 = -c3;
    // -s1_a_halved
    let minus_s1_a_halved = -s1_a_halved;
    // -s3_c_halved
    let minus_s3_c_halved = -s3_c_halved;
    // Entries that are not zero.
    // M12 = -cos(q1)
    let m12 = minus_c1;
    // M13 = -sin(q1)
    let m13 = minus_s1;
    // M14 = cos(q1)
    let m14 = c1;
    // M15 = sin(q1)
    let m15 = s1;
    // M21 = a*ma/2
    let m21 = ma * a_halved;
    // M22 = sin(q1)
    let m22 = s1;
    // M23 = -cos(q1)
    let m23 = minus_c1;
    // M24 = -sin(q1)
    let m24 = minus_s1;
    // M25 = cos(q1)
    let m25 = c1;
    // M31 = a^2*ma/12
    let m31 = a * ma * a_by_12;
    // M32 = -a*sin(q1)/2
    let m32 = minus_s1_a_halved;
    // M33 = a*cos(q1)/2
    let m33 = c1_a_halved;
    // M34 = -a*sin(q1)/2
    let m34 = minus_s1_a_halved;
    // M35 = a*cos(q1)/2
    let m35 = c1_a_halved;
    // M41 = -a*mb*sin(q1 - q2)
    let m41 = a * mb * c1_s2_minus_c2_s1;
    // M44 = -cos(q2)
    let m44 = minus_c2;
    // M45 = -sin(q2)
    let m45 = minus_s2;
    // M46 = -cos(q2)
    let m46 = minus_c2;
    // M47 = -sin(q2)
    let m47 = minus_s2;
    // M51 = a*mb*(2*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/2
    let m51 = mb * a_halved * c1_c2_plus_s1_s2.mul_add(S::int(2), m51_of_q1_q2_q3);
    // M54 = sin(q2)
    let m54 = s2;
    // M55 = -cos(q2)
    let m55 = minus_c2;
    // M56 = sin(q2)
    let m56 = s2;
    // M57 = -cos(q2)
    let m57 = minus_c2;
    // M61 = -a*b*mb*sin(q1 - q3)/(12*sin(q2 - q3))
    let m61 = b * mb * a_by_12 * m51_of_q1_q2_q3;
    // M64 = -b*sin(q2)/2
    let m64 = -s2_b_halved;
    // M65 = b*cos(q2)/2
    let m65 = c2_b_halved;
    // M66 = b*sin(q2)/2
    let m66 = s2_b_halved;
    // M67 = -b*cos(q2)/2
    let m67 = -c2_b_halved;
    // M76 = cos(q3)
    let m76 = c3;
    // M77 = sin(q3)
    let m77 = s3;
    // M78 = -cos(q3)
    let m78 = minus_c3;
    // M79 = -sin(q3)
    let m79 = minus_s3;
    // M81 = -a*mc*sin(q1 - q2)/(2*sin(q2 - q3))
    let m81 = a_halved * m81_of_mc_q1_q2_q3;
    // M86 = -sin(q3)
    let m86 = minus_s3;
    // M87 = cos(q3)
    let m87 = c3;
    // M88 = sin(q3)
    let m88 = s3;
    // M89 = -cos(q3)
    let m89 = minus_c3;
    // M91 = -a*c*mc*sin(q1 - q2)/(12*sin(q2 - q3))
    let m91 = c * a_by_12 * m81_of_mc_q1_q2_q3;
    // M96 = -c*sin(q3)/2
    let m96 = minus_s3_c_halved;
    // M97 = c*cos(q3)/2
    let m97 = c3_c_halved;
    // M98 = -c*sin(q3)/2
    let m98 = minus_s3_c_halved;
    // M99 = c*cos(q3)/2
    let m99 = c3_c_halved;
    let zero = S::int(0);
    [
        [zero, m12, m13, m14, m15, zero, zero, zero, zero],
        [m21, m22, m23, m24, m25, zero, zero, zero, zero],
        [m31, m32, m33, m34, m35, zero, zero, zero, zero],
        [m41, zero, zero, m44, m45, m46, m47, zero, zero],
        [m51, zero, zero, m54, m55, m56, m57, zero, zero],
        [m61, zero, zero, m64, m65, m66, m67, zero, zero],
        [zero, zero, zero, zero, zero, m76, m77, m78, m79],
        [m81, zero, zero, zero, zero, m86, m87, m88, m89],
        [m91, zero, zero, zero, zero, m96, m97, m98, m99],
    ]
}

/// Right-hand side of the linear system; unknowns (u1', pin_ox, pin_oy, pin_px, pin_py, pin_qx, pin_qy, pin_dx, pin_dy).
///
/// 84 operations, 4 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [S; 9] {
    let Parameters { a, b, c, ma, mb, mc, g, .. } = *p;
    let [q1, q2, q3] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s3, c3) = q3.sin_cos();
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    let a_u1 = a * u1;
    let u1_a_u1 = u1 * a_u1;
    let ma_g = ma * g;
    let mb_g = mb * g;
    // sin(q1)*cos(q3) - cos(q1)*sin(q3)
    let sin_q1_minus_q3 = (-c1).mul_add(s3, s1 * c3);
    let b_inv_sin_q1_minus_q3 = sin_q1_minus_q3 / b;
    // q2 - q3
    let q2_minus_q3 = q2 - q3;
    let (sin_q2_minus_q3, cos_q2_minus_q3) = q2_minus_q3.sin_cos();
    let sin_q2_minus_q3_inv = S::int(1) / sin_q2_minus_q3;
    let a_u1_sin_q2_minus_q3_inv = a_u1 * sin_q2_minus_q3_inv;
    let f4_of_u1 = a_u1_sin_q2_minus_q3_inv * a_u1_sin_q2_minus_q3_inv;
    let f4_of_u1_halved = S::ratio(1, 2) * f4_of_u1;
    let mb_sin_q1_minus_q3 = mb * sin_q1_minus_q3;
    let f4_of_u1_2 = f4_of_u1_halved * mb_sin_q1_minus_q3;
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let cos_q1_minus_q2 = c1.mul_add(c2, s1 * s2);
    let mb_u1_a_u1 = mb * u1_a_u1;
    // sin(q1)*cos(q2) - cos(q1)*sin(q2)
    let sin_q1_minus_q2 = (-c1).mul_add(s2, s1 * c2);
    let c_inv_sin_q1_minus_q2 = sin_q1_minus_q2 / c;
    let f5_of_q2_q3 = sin_q2_minus_q3_inv * cos_q2_minus_q3;
    // f5_of_q2_q3*(b_inv_sin_q1_minus_q3 - c_inv_sin_q1_minus_q2)
    let f5_of_b_c_q1_q2_q3 = f5_of_q2_q3 * (b_inv_sin_q1_minus_q3 - c_inv_sin_q1_minus_q2);
    let f5_of_u1 = S::ratio(1, 2) * a_u1_sin_q2_minus_q3_inv;
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let cos_q1_minus_q3 = c1.mul_add(c3, s1 * s3);
    // mb*cos(q1 - q3)*(u1 + a_u1_sin_q2_minus_q3_inv*c_inv_sin_q1_minus_q2)
    let f5_of_u1_2 = mb * cos_q1_minus_q3
        * a_u1_sin_q2_minus_q3_inv.mul_add(c_inv_sin_q1_minus_q2, u1);
    let f6_of_u1 = S::ratio(1, 12) * a_u1_sin_q2_minus_q3_inv;
    let f6_of_u1_2 = S::ratio(1, 12) * f4_of_u1 * f5_of_q2_q3;
    let mc_g = mc * g;
    let mc_sin_q1_minus_q2 = mc * sin_q1_minus_q2;
    let f7_of_u1 = f4_of_u1_halved * mc_sin_q1_minus_q2;
    // mc*cos(q1 - q2)*(u1 + b_inv_sin_q1_minus_q3*a_u1_sin_q2_minus_q3_inv)
    let f8_of_u1 = mc * cos_q1_minus_q2
        * b_inv_sin_q1_minus_q3.mul_add(a_u1_sin_q2_minus_q3_inv, u1);
    // Values.
    // f1 = a*ma*u1^2/2 - ma*g*sin(q1)
    let f1 = (-ma_g).mul_add(s1, S::ratio(1, 2) * ma * u1_a_u1);
    // f2 = -ma*g*cos(q1)
    let f2 = -ma_g * c1;
    // f4 = mb*(a*u1^2*(2*cos(q1 - q2) + a*sin(q1 - q3)^2/(b*sin(q2 - q3)^2)) - 2*g*sin(q2))/2
    let f4 = (-mb_g).mul_add(s2, b_inv_sin_q1_minus_q3 * f4_of_u1_2) + cos_q1_minus_q2 * mb_u1_a_u1;
    // f5 = mb*(a*u1^2*(2*sin(q1 - q2) + (cos(q1 - q3) + a*(sin(q1 - q3)^2/(b*tan(q2 - q3)) + sin(q1 -
    //   q2)*(sin(q1 - q3)/tan(q3 - q2) + cos(q1 - q3))/c)/sin(q2 - q3))/sin(q2 - q3)) - 2*g*cos(q2))/2
    let f5 = (-mb_g).mul_add(c2, sin_q1_minus_q2 * mb_u1_a_u1)
        + f4_of_u1_2 * f5_of_b_c_q1_q2_q3 + f5_of_u1 * f5_of_u1_2;
    // f6 = a*mb*u1^2*(b*cos(q1 - q3) + a*(sin(q1 - q3)^2/tan(q2 - q3) + b*sin(q1 - q2)*(sin(q1 -
    //   q3)/tan(q3 - q2) + cos(q1 - q3))/c)/sin(q2 - q3))/(12*sin(q2 - q3))
    let f6 = mb_sin_q1_minus_q3 * f6_of_u1_2 * (-b).mul_add(c_inv_sin_q1_minus_q2, sin_q1_minus_q3)
        + b * f5_of_u1_2 * f6_of_u1;
    // f7 = a^2*mc*u1^2*sin(q1 - q2)^2/(2*c*sin(q2 - q3)^2) - mc*g*sin(q3)
    let f7 = (-mc_g).mul_add(s3, c_inv_sin_q1_minus_q2 * f7_of_u1);
    // f8 = mc*(a*u1^2*(cos(q1 - q2) + a*(sin(q1 - q2)^2/(c*tan(q3 - q2)) + sin(q1 - q3)*(cos(q1 - q2) +
    //   sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3))/sin(q2 - q3) - 2*g*cos(q3))/2
    let f8 = (-mc_g).mul_add(c3, f5_of_b_c_q1_q2_q3 * f7_of_u1) + f5_of_u1 * f8_of_u1;
    // f9 = a*mc*u1^2*(c*cos(q1 - q2) + a*(sin(q1 - q2)^2/tan(q3 - q2) + c*sin(q1 - q3)*(cos(q1 - q2) +
    //   sin(q1 - q2)/tan(q2 - q3))/b)/sin(q2 - q3))/(12*sin(q2 - q3))
    let f9 = f6_of_u1_2 * mc_sin_q1_minus_q2
        * c.mul_add(b_inv_sin_q1_minus_q3, -sin_q1_minus_q2) + c * f6_of_u1 * f8_of_u1;
    let zero = S::int(0);
    [f1, f2, zero, f4, f5, f6, f7, f8, f9]
}

/// The accelerations (u1'), solved for when this code was generated.
///
/// 83 operations, 4 sines and cosines.
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
    let u1_sin_q2_minus_q3_inv = u1 * sin_q2_minus_q3_inv;
    let b_inv = S::int(1) / b;
    // 1 + a*u1_dot_of_q1_q2_q3*b_inv
    let u1_dot_of_a_b_q1_q2_q3 = (a * u1_dot_of_q1_q2_q3).mul_add(b_inv, S::int(1));
    let c_inv_sin_q1_minus_q2 = sin_q1_minus_q2 / c;
    // cos(q2 - q3)*(sin(q1 - q3)*b_inv - c_inv_sin_q1_minus_q2)
    let u1_dot_of_b_c_q1_q2_q3 = cos_q2_minus_q3
        * sin_q1_minus_q3.mul_add(b_inv, -c_inv_sin_q1_minus_q2);
    let u1_dot_of_u1 = sin_q1_minus_q2 * u1_sin_q2_minus_q3_inv;
    let mb_u1_dot_of_place = mb * u1_dot_of_place;
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let cos_q1_minus_q3 = c1.mul_add(c3, s1 * s3);
    let a_inv_g = g / a;
    // u1_dot_of_place*a_inv_g*(ma*cos(q1) - mc_u1_dot_of_q1_q2_q3_2*cos(q3)) +
    //   mb_u1_dot_of_place*(u1*sin(q1 - q3)*u1_dot_of_a_b_q1_q2_q3*u1_dot_of_u1 -
    //   u1_dot_of_q1_q2_q3*a_inv_g*cos(q2))
    let u1_dot_of_u1_2 = u1_dot_of_place * a_inv_g * (-mc_u1_dot_of_q1_q2_q3_2).mul_add(c3, ma * c1)
        + mb_u1_dot_of_place
            * (-(u1_dot_of_q1_q2_q3 * a_inv_g))
                .mul_add(
                    c2,
                    u1 * sin_q1_minus_q3 * u1_dot_of_a_b_q1_q2_q3 * u1_dot_of_u1,
                );
    // u1' = ((3*g*(mb*cos(q2)*sin(q1 - q3) + mc*sin(q1 - q2)*cos(q3)) + a*u1^2*((a*((2*mc*sin(q1 -
    //   q2)^3/(c*tan(q2 - q3)) + sin(q1 - q3)*(mb*(cos(q2 - q3)*(sin(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 -
    //   q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 - q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1
    //   - q2)*cos(q1 - q3)/c) - 2*mc*sin(q1 - q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b))/sin(q2 -
    //   q3) + 3*mb*sin(q1 - q2)*(cos(q1 - q2)*cos(q1 - q3)/c - sin(q1 - q3)^2/b)) - 2*mc*sin(q1 - q2)*cos(q1
    //   - q2) - 2*mb*sin(q1 - q3)*cos(q1 - q3))/sin(q2 - q3) + 3*mb*(cos(q1 - q2)*cos(q1 - q3) - sin(q1 -
    //   q2)*sin(q1 - q3))))/sin(q2 - q3) - 3*g*(ma*cos(q1) + 2*mb*(cos(q2)*cos(q1 - q2) - sin(q2)*sin(q1 -
    //   q2))))/(2*a*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 -
    //   q3)/sin(q2 - q3))/sin(q2 - q3))))
    let u1_dot = -mc * u1_dot_of_place * u1_sin_q2_minus_q3_inv * u1_dot_of_u1
        * (a * sin_q2_minus_q3_inv * u1_dot_of_q1_q2_q3_2)
            .mul_add(u1_dot_of_b_c_q1_q2_q3, cos_q1_minus_q2 * u1_dot_of_a_b_q1_q2_q3)
        - S::ratio(1, 2) * mb_u1_dot_of_place
            * (u1_sin_q2_minus_q3_inv
                * u1_dot_of_q1_q2_q3.mul_add(S::int(2), -cos_q1_minus_q2_times_3)
                * (a * u1_sin_q2_minus_q3_inv
                    * u1_dot_of_q1_q2_q3
                        .mul_add(
                            u1_dot_of_b_c_q1_q2_q3,
                            cos_q1_minus_q3 * c_inv_sin_q1_minus_q2,
                        ) + u1 * cos_q1_minus_q3)
                + S::int(6) * a_inv_g * (-sin_q1_minus_q2).mul_add(s2, cos_q1_minus_q2 * c2))
        - S::ratio(3, 2) * u1_dot_of_u1_2;
    [u1_dot]
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 87 operations, 4 sines and cosines.
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
    let u1_sin_q2_minus_q3_inv = u1 * sin_q2_minus_q3_inv;
    let b_inv = S::int(1) / b;
    // 1 + a*u1_dot_of_q1_q2_q3*b_inv
    let u1_dot_of_a_b_q1_q2_q3 = (a * u1_dot_of_q1_q2_q3).mul_add(b_inv, S::int(1));
    let c_inv_sin_q1_minus_q2 = sin_q1_minus_q2 / c;
    let sin_q1_minus_q3_b_inv = sin_q1_minus_q3 * b_inv;
    // cos(q2 - q3)*(sin_q1_minus_q3_b_inv - c_inv_sin_q1_minus_q2)
    let u1_dot_of_b_c_q1_q2_q3 = cos_q2_minus_q3 * (sin_q1_minus_q3_b_inv - c_inv_sin_q1_minus_q2);
    let u1_dot_of_u1 = sin_q1_minus_q2 * u1_sin_q2_minus_q3_inv;
    let mb_u1_dot_of_place = mb * u1_dot_of_place;
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let cos_q1_minus_q3 = c1.mul_add(c3, s1 * s3);
    let a_u1_sin_q2_minus_q3_inv = a * u1_sin_q2_minus_q3_inv;
    let a_inv_g = g / a;
    // u1_dot_of_place*a_inv_g*(ma*cos(q1) - mc_u1_dot_of_q1_q2_q3_2*cos(q3)) +
    //   mb_u1_dot_of_place*(u1*sin(q1 - q3)*u1_dot_of_a_b_q1_q2_q3*u1_dot_of_u1 -
    //   u1_dot_of_q1_q2_q3*a_inv_g*cos(q2))
    let u1_dot_of_u1_2 = u1_dot_of_place * a_inv_g * (-mc_u1_dot_of_q1_q2_q3_2).mul_add(c3, ma * c1)
        + mb_u1_dot_of_place
            * (-(u1_dot_of_q1_q2_q3 * a_inv_g))
                .mul_add(
                    c2,
                    u1 * sin_q1_minus_q3 * u1_dot_of_a_b_q1_q2_q3 * u1_dot_of_u1,
                );
    // u1' = ((3*g*(mb*cos(q2)*sin(q1 - q3) + mc*sin(q1 - q2)*cos(q3)) + a*u1^2*((a*((2*mc*sin(q1 -
    //   q2)^3/(c*tan(q2 - q3)) + sin(q1 - q3)*(mb*(cos(q2 - q3)*(sin(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 -
    //   q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 - q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1
    //   - q2)*cos(q1 - q3)/c) - 2*mc*sin(q1 - q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b))/sin(q2 -
    //   q3) + 3*mb*sin(q1 - q2)*(cos(q1 - q2)*cos(q1 - q3)/c - sin(q1 - q3)^2/b)) - 2*mc*sin(q1 - q2)*cos(q1
    //   - q2) - 2*mb*sin(q1 - q3)*cos(q1 - q3))/sin(q2 - q3) + 3*mb*(cos(q1 - q2)*cos(q1 - q3) - sin(q1 -
    //   q2)*sin(q1 - q3))))/sin(q2 - q3) - 3*g*(ma*cos(q1) + 2*mb*(cos(q2)*cos(q1 - q2) - sin(q2)*sin(q1 -
    //   q2))))/(2*a*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 -
    //   q3)/sin(q2 - q3))/sin(q2 - q3))))
    let u1_dot = -mc * u1_dot_of_place * u1_sin_q2_minus_q3_inv * u1_dot_of_u1
        * (a * sin_q2_minus_q3_inv * u1_dot_of_q1_q2_q3_2)
            .mul_add(u1_dot_of_b_c_q1_q2_q3, cos_q1_minus_q2 * u1_dot_of_a_b_q1_q2_q3)
        - S::ratio(1, 2) * mb_u1_dot_of_place
            * (u1_sin_q2_minus_q3_inv
                * u1_dot_of_q1_q2_q3.mul_add(S::int(2), -cos_q1_minus_q2_times_3)
                * (a_u1_sin_q2_minus_q3_inv
                    * u1_dot_of_q1_q2_q3
                        .mul_add(
                            u1_dot_of_b_c_q1_q2_q3,
                            cos_q1_minus_q3 * c_inv_sin_q1_minus_q2,
                        ) + u1 * cos_q1_minus_q3)
                + S::int(6) * a_inv_g * (-sin_q1_minus_q2).mul_add(s2, cos_q1_minus_q2 * c2))
        - S::ratio(3, 2) * u1_dot_of_u1_2;
    // Values.
    // q1' = u1
    let q1_dot_value = u1;
    // q2' = -a*u1*sin(q1 - q3)/(b*sin(q2 - q3))
    let q2_dot_value = -sin_q1_minus_q3_b_inv * a_u1_sin_q2_minus_q3_inv;
    // q3' = -a*u1*sin(q1 - q2)/(c*sin(q2 - q3))
    let q3_dot_value = -c_inv_sin_q1_minus_q2 * a_u1_sin_q2_minus_q3_inv;
    ([q1_dot_value, q2_dot_value, q3_dot_value], [u1_dot])
}

/// Jacobian of the derivative by the state; columns q1, q2, q3, u1.
///
/// 310 operations, 4 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 3], u: &[S; 1]) -> [[S; 4]; 4] {
    let Parameters { a, b, c, ma, mb, mc, g, .. } = *p;
    let [q1, q2, q3] = *q;
    let [u1] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // q2 - q3
    let q2_minus_q3 = q2 - q3;
    let (sin_q2_minus_q3, cos_q2_minus_q3) = q2_minus_q3.sin_cos();
    let sin_q2_minus_q3_inv = S::int(1) / sin_q2_minus_q3;
    // sin(q1)*sin(q2) + cos(q1)*cos(q2)
    let c1_c2_plus_s1_s2 = c1.mul_add(c2, s1 * s2);
    let mc_c1_c2_plus_s1_s2 = mc * c1_c2_plus_s1_s2;
    let c3_mc_c1_c2_plus_s1_s2 = mc_c1_c2_plus_s1_s2 * c3;
    // sin(q1)*sin(q3) + cos(q1)*cos(q3)
    let c1_c3_plus_s1_s3 = c1.mul_add(c3, s1 * s3);
    let mb_c1_c3_plus_s1_s3 = mb * c1_c3_plus_s1_s3;
    let c2_mb_c1_c3_plus_s1_s3 = mb_c1_c3_plus_s1_s3 * c2;
    let g_times_3 = S::int(3) * g;
    // cos(q1)*sin(q3) - sin(q1)*cos(q3)
    let c1_s3_minus_c3_s1 = (-s1).mul_add(c3, c1 * s3);
    let b_inv = S::int(1) / b;
    // cos(q1)*sin(q2) - sin(q1)*cos(q2)
    let c1_s2_minus_c2_s1 = (-s1).mul_add(c2, c1 * s2);
    let u1_dot_by_q1_of_q1_q2 = S::int(3) * c1_s2_minus_c2_s1;
    let c1_c3_plus_s1_s3_doubled = S::int(2) * c1_c3_plus_s1_s3;
    let c_inv = S::int(1) / c;
    let c1_c2_plus_s1_s2_c_inv = c1_c2_plus_s1_s2 * c_inv;
    let u1_dot_by_q1_of_q2_q3 = S::int(2) * sin_q2_minus_q3_inv;
    let c1_c2_plus_s1_s2_times_3 = S::int(3) * c1_c2_plus_s1_s2;
    let c1_s2_minus_c2_s1_c_inv = c1_s2_minus_c2_s1 * c_inv;
    let u1_dot_by_q1_of_c_q1_q2 = u1_dot_by_q1_of_q1_q2 * c1_s2_minus_c2_s1_c_inv;
    // u1_dot_by_q1_of_c_q1_q2 - c1_c2_plus_s1_s2_c_inv*c1_c2_plus_s1_s2_times_3
    let u1_dot_by_q1_of_c_q1_q2_2 = (-c1_c2_plus_s1_s2_c_inv)
        .mul_add(c1_c2_plus_s1_s2_times_3, u1_dot_by_q1_of_c_q1_q2);
    let u1_dot_by_q1_of_q1_q3 = S::int(2) * c1_s3_minus_c3_s1;
    // b_inv*(c1_c2_plus_s1_s2_times_3 + sin_q2_minus_q3_inv*u1_dot_by_q1_of_q1_q3) -
    //   u1_dot_by_q1_of_q2_q3*c1_s2_minus_c2_s1_c_inv
    let u1_dot_by_q1_of_b_c_q1_q2_q3 = b_inv
        * sin_q2_minus_q3_inv.mul_add(u1_dot_by_q1_of_q1_q3, c1_c2_plus_s1_s2_times_3)
        - u1_dot_by_q1_of_q2_q3 * c1_s2_minus_c2_s1_c_inv;
    let u1_dot_by_q1_of_b_c_q1_q2_q3_2 = c1_c3_plus_s1_s3 * u1_dot_by_q1_of_b_c_q1_q2_q3;
    let u1_dot_by_q1_of_c_q1_q2_q3 = c1_s2_minus_c2_s1_c_inv * u1_dot_by_q1_of_q1_q3;
    let u1_dot_by_q1_of_c_q1_q2_q3_2 = c1_c3_plus_s1_s3_doubled * c1_c2_plus_s1_s2_c_inv;
    let u1_dot_by_q1_of_q2_q3_2 = sin_q2_minus_q3_inv * cos_q2_minus_q3;
    let u1_dot_by_q1_of_q1_q2_q3 = c1_c2_plus_s1_s2 * u1_dot_by_q1_of_q2_q3_2;
    let mc_c1_s2_minus_c2_s1 = mc * c1_s2_minus_c2_s1;
    let u1_dot_by_q1_of_mc_q1_q2 = S::int(2) * mc_c1_s2_minus_c2_s1;
    let u1_dot_by_q1_of_b_mc_q1_q2 = b_inv * u1_dot_by_q1_of_mc_q1_q2;
    let u1_dot_by_q1_of_mc_q1_q2_2 = S::int(2) * mc_c1_c2_plus_s1_s2;
    // c1_s2_minus_c2_s1*u1_dot_by_q1_of_q2_q3_2 - c1_c2_plus_s1_s2
    let u1_dot_by_q1_of_q1_q2_q3_2 = c1_s2_minus_c2_s1
        .mul_add(u1_dot_by_q1_of_q2_q3_2, -c1_c2_plus_s1_s2);
    // -u1_dot_by_q1_of_q1_q2_q3_2
    let u1_dot_by_q1_of_q1_q2_q3_3 = -u1_dot_by_q1_of_q1_q2_q3_2;
    let u1_dot_by_q1_of_place = b_inv * u1_dot_by_q1_of_mc_q1_q2_2 * u1_dot_by_q1_of_q1_q2_q3_3;
    // c1_s3_minus_c3_s1*u1_dot_by_q1_of_b_c_q1_q2_q3 - c1_c2_plus_s1_s2_times_3*c1_s2_minus_c2_s1_c_inv
    let u1_dot_by_q1_of_b_c_q1_q2_q3_3 = (-c1_c2_plus_s1_s2_times_3)
        .mul_add(
            c1_s2_minus_c2_s1_c_inv,
            c1_s3_minus_c3_s1 * u1_dot_by_q1_of_b_c_q1_q2_q3,
        );
    // mb*(u1_dot_by_q1_of_b_c_q1_q2_q3_3*cos(q2 - q3) - c1_c3_plus_s1_s3_doubled*c1_s2_minus_c2_s1_c_inv)
    //   - u1_dot_by_q1_of_b_mc_q1_q2*u1_dot_by_q1_of_q1_q2_q3_3
    let u1_dot_by_q1_of_place_2 = mb
        * (-c1_c3_plus_s1_s3_doubled)
            .mul_add(
                c1_s2_minus_c2_s1_c_inv,
                u1_dot_by_q1_of_b_c_q1_q2_q3_3 * cos_q2_minus_q3,
            ) - u1_dot_by_q1_of_b_mc_q1_q2 * u1_dot_by_q1_of_q1_q2_q3_3;
    let u1_dot_by_q1_of_place_3 = c1_c3_plus_s1_s3 * u1_dot_by_q1_of_place_2;
    let u1_dot_by_q1_of_place_4 = S::int(6) * c1_s2_minus_c2_s1_c_inv
        * u1_dot_by_q1_of_q1_q2_q3 * mc_c1_s2_minus_c2_s1;
    // c1_s3_minus_c3_s1*c1_c2_plus_s1_s2_c_inv + c1_c3_plus_s1_s3*b_inv*u1_dot_by_q1_of_q1_q3
    let u1_dot_by_q1_of_b_c_q1_q2_q3_4 = (c1_c3_plus_s1_s3 * b_inv)
        .mul_add(u1_dot_by_q1_of_q1_q3, c1_s3_minus_c3_s1 * c1_c2_plus_s1_s2_c_inv);
    let mb_u1_dot_by_q1_of_q1_q2 = mb * u1_dot_by_q1_of_q1_q2;
    // mb*(c1_s3_minus_c3_s1^2*b_inv - c1_c3_plus_s1_s3*c1_c2_plus_s1_s2_c_inv)
    let u1_dot_by_q1_of_place_5 = mb
        * (-c1_c3_plus_s1_s3)
            .mul_add(
                c1_c2_plus_s1_s2_c_inv,
                c1_s3_minus_c3_s1 * c1_s3_minus_c3_s1 * b_inv,
            );
    let u1_dot_by_q1_of_place_6 = c1_c2_plus_s1_s2_times_3 * u1_dot_by_q1_of_place_5;
    let u1_dot_by_q1_of_mc_q1_q2_3 = c1_s2_minus_c2_s1 * u1_dot_by_q1_of_mc_q1_q2;
    // c1_c2_plus_s1_s2*u1_dot_by_q1_of_mc_q1_q2_2 - u1_dot_by_q1_of_mc_q1_q2_3
    let u1_dot_by_q1_of_mc_q1_q2_4 = c1_c2_plus_s1_s2
        .mul_add(u1_dot_by_q1_of_mc_q1_q2_2, -u1_dot_by_q1_of_mc_q1_q2_3);
    // mb*(c1_s3_minus_c3_s1*u1_dot_by_q1_of_q1_q3 - c1_c3_plus_s1_s3*c1_c3_plus_s1_s3_doubled)
    let u1_dot_by_q1_of_mb_q1_q3 = mb
        * (-c1_c3_plus_s1_s3)
            .mul_add(
                c1_c3_plus_s1_s3_doubled,
                c1_s3_minus_c3_s1 * u1_dot_by_q1_of_q1_q3,
            );
    // c1_c2_plus_s1_s2*c1_s3_minus_c3_s1 + c1_c3_plus_s1_s3*c1_s2_minus_c2_s1
    let u1_dot_by_q1_of_q1_q2_q3_4 = c1_c3_plus_s1_s3
        .mul_add(c1_s2_minus_c2_s1, c1_c2_plus_s1_s2 * c1_s3_minus_c3_s1);
    let a_u1 = a * u1;
    let u1_a_u1 = u1 * a_u1;
    let mb_doubled = S::int(2) * mb;
    let u1_dot_by_q1_of_q1_q2_q3_5 = sin_q2_minus_q3_inv * c1_s3_minus_c3_s1;
    // c1_c2_plus_s1_s2_times_3 + u1_dot_by_q1_of_q1_q2_q3_5
    let u1_dot_by_q1_of_q1_q2_q3_6 = c1_c2_plus_s1_s2_times_3 + u1_dot_by_q1_of_q1_q2_q3_5;
    let sin_q2_minus_q3_inv_sq = sin_q2_minus_q3_inv * sin_q2_minus_q3_inv;
    // 1/(ma + mb*(3 + u1_dot_by_q1_of_q1_q2_q3_5*u1_dot_by_q1_of_q1_q2_q3_6) +
    //   c1_s2_minus_c2_s1*mc_c1_s2_minus_c2_s1*sin_q2_minus_q3_inv_sq)
    let u1_dot_by_q1_of_place_7 = S::int(1)
        / (ma
            + mb
                * u1_dot_by_q1_of_q1_q2_q3_5
                    .mul_add(u1_dot_by_q1_of_q1_q2_q3_6, S::int(3))
            + c1_s2_minus_c2_s1 * mc_c1_s2_minus_c2_s1 * sin_q2_minus_q3_inv_sq);
    let u1_dot_by_q1_of_place_8 = S::ratio(1, 2) * u1_dot_by_q1_of_place_7 / a;
    let u1_dot_by_q1_of_q1_q2_q3_7 = sin_q2_minus_q3_inv * c1_c3_plus_s1_s3;
    let u1_dot_by_q1_of_mc_q1_q2_5 = c1_c2_plus_s1_s2 * u1_dot_by_q1_of_mc_q1_q2;
    let mb_c1_s3_minus_c3_s1 = mb * c1_s3_minus_c3_s1;
    let u1_dot_by_q1_of_c_mc_q1_q2 = c1_s2_minus_c2_s1_c_inv * u1_dot_by_q1_of_mc_q1_q2_3;
    // c1_s3_minus_c3_s1*u1_dot_by_q1_of_place_2 - u1_dot_by_q1_of_q2_q3_2*u1_dot_by_q1_of_c_mc_q1_q2
    let u1_dot_by_q1_of_place_9 = (-u1_dot_by_q1_of_q2_q3_2)
        .mul_add(
            u1_dot_by_q1_of_c_mc_q1_q2,
            c1_s3_minus_c3_s1 * u1_dot_by_q1_of_place_2,
        );
    // mb_c1_c3_plus_s1_s3*u1_dot_by_q1_of_q1_q3 + u1_dot_by_q1_of_mc_q1_q2_5 +
    //   a*(u1_dot_by_q1_of_q1_q2*u1_dot_by_q1_of_place_5 + sin_q2_minus_q3_inv*u1_dot_by_q1_of_place_9)
    let u1_dot_by_q1_of_place_10 = u1_dot_by_q1_of_mc_q1_q2_5
        + mb_c1_c3_plus_s1_s3 * u1_dot_by_q1_of_q1_q3
        + a
            * sin_q2_minus_q3_inv
                .mul_add(
                    u1_dot_by_q1_of_place_9,
                    u1_dot_by_q1_of_q1_q2 * u1_dot_by_q1_of_place_5,
                );
    let mb_times_3 = S::int(3) * mb;
    // sin_q2_minus_q3_inv*u1_dot_by_q1_of_place_10 + mb_times_3*(c1_c2_plus_s1_s2*c1_c3_plus_s1_s3 -
    //   c1_s3_minus_c3_s1*c1_s2_minus_c2_s1)
    let u1_dot_by_q1_of_place_11 = mb_times_3
        * (-c1_s3_minus_c3_s1)
            .mul_add(c1_s2_minus_c2_s1, c1_c2_plus_s1_s2 * c1_c3_plus_s1_s3)
        + sin_q2_minus_q3_inv * u1_dot_by_q1_of_place_10;
    // u1_a_u1*u1_dot_by_q1_of_place_11 - g_times_3*(mc_c1_s2_minus_c2_s1*cos(q3) +
    //   mb_c1_s3_minus_c3_s1*cos(q2))
    let u1_dot_by_q1_of_u1 = -g_times_3
        * mb_c1_s3_minus_c3_s1.mul_add(c2, mc_c1_s2_minus_c2_s1 * c3)
        + u1_a_u1 * u1_dot_by_q1_of_place_11;
    // u1_dot_by_q1_of_place_7*u1_dot_by_q1_of_place_8*(sin_q2_minus_q3_inv*u1_dot_by_q1_of_u1 -
    //   g_times_3*(ma*cos(q1) + mb_doubled*(c1_c2_plus_s1_s2*cos(q2) + c1_s2_minus_c2_s1*sin(q2))))
    let u1_dot_by_q1_of_u1_2 = u1_dot_by_q1_of_place_7 * u1_dot_by_q1_of_place_8
        * (-g_times_3
            * (mb_doubled * c1_s2_minus_c2_s1.mul_add(s2, c1_c2_plus_s1_s2 * c2)
                + ma * c1) + sin_q2_minus_q3_inv * u1_dot_by_q1_of_u1);
    // u1_dot_by_q1 = (mb*(cos(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3) - sin(q1
    //   - q3)*(3*sin(q1 - q2) + cos(q1 - q3)/sin(q2 - q3))/sin(q2 - q3)) - 2*mc*sin(q1 - q2)*cos(q1 -
    //   q2)/sin(q2 - q3)^2)*((3*g*(mb*cos(q2)*sin(q1 - q3) + mc*sin(q1 - q2)*cos(q3)) +
    //   a*u1^2*((a*((2*mc*sin(q1 - q2)^3/(c*tan(q2 - q3)) + sin(q1 - q3)*(mb*(cos(q2 - q3)*(sin(q1 -
    //   q3)*(2*sin(q1 - q2)/(c*sin(q2 - q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 - q3))/b) - 3*sin(q1
    //   - q2)*cos(q1 - q2)/c) - 2*sin(q1 - q2)*cos(q1 - q3)/c) - 2*mc*sin(q1 - q2)*(cos(q1 - q2) + sin(q1 -
    //   q2)/tan(q2 - q3))/b))/sin(q2 - q3) + 3*mb*sin(q1 - q2)*(cos(q1 - q2)*cos(q1 - q3)/c - sin(q1 -
    //   q3)^2/b)) - 2*mc*sin(q1 - q2)*cos(q1 - q2) - 2*mb*sin(q1 - q3)*cos(q1 - q3))/sin(q2 - q3) +
    //   3*mb*(cos(q1 - q2)*cos(q1 - q3) - sin(q1 - q2)*sin(q1 - q3))))/sin(q2 - q3) - 3*g*(ma*cos(q1) +
    //   2*mb*(cos(q2)*cos(q1 - q2) - sin(q2)*sin(q1 - q2))))/(2*a*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 +
    //   mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3)))^2) +
    //   (3*g*(ma*sin(q1) + 2*mb*(sin(q1 - q2)*cos(q2) + sin(q2)*cos(q1 - q2))) + (3*g*(mc*cos(q1 -
    //   q2)*cos(q3) + mb*cos(q2)*cos(q1 - q3)) + a*u1^2*((2*mc*sin(q1 - q2)^2 - 2*mc*cos(q1 - q2)^2 +
    //   2*mb*sin(q1 - q3)^2 - 2*mb*cos(q1 - q3)^2 + a*(3*mb*cos(q1 - q2)*(cos(q1 - q2)*cos(q1 - q3)/c -
    //   sin(q1 - q3)^2/b) + (6*mc*sin(q1 - q2)^2*cos(q1 - q2)/(c*tan(q2 - q3)) + cos(q1 - q3)*(mb*(cos(q2 -
    //   q3)*(sin(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 - q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 -
    //   q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1 - q2)*cos(q1 - q3)/c) - 2*mc*sin(q1 -
    //   q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b) + sin(q1 - q3)*(2*mc*sin(q1 - q2)*(sin(q1 - q2) +
    //   cos(q1 - q2)/tan(q3 - q2))/b - 2*mc*cos(q1 - q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b -
    //   mb*(2*cos(q1 - q2)*cos(q1 - q3)/c - 2*sin(q1 - q2)*sin(q1 - q3)/c + cos(q2 - q3)*(3*cos(q1 - q2)^2/c
    //   - 3*sin(q1 - q2)^2/c - cos(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 - q3)) + (3*cos(q1 - q2) - 2*sin(q1 -
    //   q3)/sin(q2 - q3))/b) - sin(q1 - q3)*(2*cos(q1 - q2)/(c*sin(q2 - q3)) - (3*sin(q1 - q2) + 2*cos(q1 -
    //   q3)/sin(q2 - q3))/b)))))/sin(q2 - q3) - 3*mb*sin(q1 - q2)*(cos(q1 - q2)*sin(q1 - q3)/c + sin(q1 -
    //   q2)*cos(q1 - q3)/c + 2*sin(q1 - q3)*cos(q1 - q3)/b)))/sin(q2 - q3) - 6*mb*(cos(q1 - q2)*sin(q1 - q3)
    //   + sin(q1 - q2)*cos(q1 - q3))))/sin(q2 - q3))/(2*a*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 -
    //   sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3))))
    let u1_dot_by_q1 = u1_dot_by_q1_of_place_8
        * (sin_q2_minus_q3_inv
            * (g_times_3 * (c3_mc_c1_c2_plus_s1_s2 + c2_mb_c1_c3_plus_s1_s3)
                + u1_a_u1
                    * (-sin_q2_minus_q3_inv
                        * (a
                            * (sin_q2_minus_q3_inv
                                * (c1_s3_minus_c3_s1
                                    * (u1_dot_by_q1_of_b_mc_q1_q2
                                        * (c1_s2_minus_c2_s1 + u1_dot_by_q1_of_q1_q2_q3)
                                        - mb
                                            * (u1_dot_by_q1_of_c_q1_q2_q3_2
                                                - cos_q2_minus_q3
                                                    * (u1_dot_by_q1_of_c_q1_q2_2
                                                        - c1_s3_minus_c3_s1
                                                            * (b_inv
                                                                * (-sin_q2_minus_q3_inv)
                                                                    .mul_add(c1_c3_plus_s1_s3_doubled, u1_dot_by_q1_of_q1_q2)
                                                                + c1_c2_plus_s1_s2_c_inv * u1_dot_by_q1_of_q2_q3)
                                                        + u1_dot_by_q1_of_b_c_q1_q2_q3_2)
                                                - u1_dot_by_q1_of_c_q1_q2_q3) - u1_dot_by_q1_of_place)
                                    + u1_dot_by_q1_of_place_3 - u1_dot_by_q1_of_place_4)
                                + mb_u1_dot_by_q1_of_q1_q2
                                    * c1_c3_plus_s1_s3
                                        .mul_add(
                                            c1_s2_minus_c2_s1_c_inv, u1_dot_by_q1_of_b_c_q1_q2_q3_4,
                                        ) + u1_dot_by_q1_of_place_6) + u1_dot_by_q1_of_mc_q1_q2_4
                            - u1_dot_by_q1_of_mb_q1_q3)
                        + S::int(6) * mb * u1_dot_by_q1_of_q1_q2_q3_4))
            + g_times_3
                * (mb_doubled * (-c1_s2_minus_c2_s1).mul_add(c2, c1_c2_plus_s1_s2 * s2) + ma * s1))
        + u1_dot_by_q1_of_u1_2
            * (-mb
                * (u1_dot_by_q1_of_q1_q2_q3_5 * (u1_dot_by_q1_of_q1_q2 - u1_dot_by_q1_of_q1_q2_q3_7)
                    - u1_dot_by_q1_of_q1_q2_q3_6 * u1_dot_by_q1_of_q1_q2_q3_7)
                + sin_q2_minus_q3_inv_sq * u1_dot_by_q1_of_mc_q1_q2_5);
    let u1_dot_by_q2_of_q2_q3 = sin_q2_minus_q3_inv * u1_dot_by_q1_of_q2_q3_2;
    let u1_dot_by_q2_of_c_q1_q2_q3 = c_inv * u1_dot_by_q1_of_q1_q2_q3_2;
    let u1_dot_by_q2_of_b_c_q1_q2_q3 = u1_dot_by_q1_of_b_c_q1_q2_q3_3 * sin_q2_minus_q3;
    // 1 + u1_dot_by_q1_of_q2_q3_2^2
    let u1_dot_by_q2_of_q2_q3_2 = u1_dot_by_q1_of_q2_q3_2
        .mul_add(u1_dot_by_q1_of_q2_q3_2, S::int(1));
    let u1_dot_by_q2_of_place = u1_dot_by_q1_of_c_mc_q1_q2 * u1_dot_by_q2_of_q2_q3_2;
    let u1_dot_by_q2_of_place_2 = u1_dot_by_q1_of_place_9 * u1_dot_by_q2_of_q2_q3;
    let u1_dot_by_q2_of_place_3 = u1_dot_by_q1_of_place_10 * u1_dot_by_q2_of_q2_q3;
    let u1_dot_by_q2_of_mb_q1_q2_q3 = u1_dot_by_q1_of_q1_q2_q3_4 * mb_times_3;
    let u1_dot_by_q2_of_u1 = u1_dot_by_q1_of_u1 * u1_dot_by_q2_of_q2_q3;
    let u1_dot_by_q2_of_q1_q2_q3 = c1_s3_minus_c3_s1 * u1_dot_by_q2_of_q2_q3;
    // u1_dot_by_q2 = (2*mc*sin(q1 - q2)*cos(q1 - q2)/sin(q2 - q3)^2 + 2*mc*sin(q1 - q2)^2/(sin(q2 -
    //   q3)^2*tan(q2 - q3)) + mb*(sin(q1 - q3)*(3*sin(q1 - q2) + sin(q1 - q3)/(sin(q2 - q3)*tan(q2 -
    //   q3)))/sin(q2 - q3) - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/(sin(q2 - q3)*tan(q2
    //   - q3))))*((3*g*(mb*cos(q2)*sin(q1 - q3) + mc*sin(q1 - q2)*cos(q3)) + a*u1^2*((a*((2*mc*sin(q1 -
    //   q2)^3/(c*tan(q2 - q3)) + sin(q1 - q3)*(mb*(cos(q2 - q3)*(sin(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 -
    //   q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 - q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1
    //   - q2)*cos(q1 - q3)/c) - 2*mc*sin(q1 - q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b))/sin(q2 -
    //   q3) + 3*mb*sin(q1 - q2)*(cos(q1 - q2)*cos(q1 - q3)/c - sin(q1 - q3)^2/b)) - 2*mc*sin(q1 - q2)*cos(q1
    //   - q2) - 2*mb*sin(q1 - q3)*cos(q1 - q3))/sin(q2 - q3) + 3*mb*(cos(q1 - q2)*cos(q1 - q3) - sin(q1 -
    //   q2)*sin(q1 - q3))))/sin(q2 - q3) - 3*g*(ma*cos(q1) + 2*mb*(cos(q2)*cos(q1 - q2) - sin(q2)*sin(q1 -
    //   q2))))/(2*a*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 -
    //   q3)/sin(q2 - q3))/sin(q2 - q3)))^2) - ((3*g*(mb*cos(q2)*sin(q1 - q3) + mc*sin(q1 - q2)*cos(q3)) +
    //   a*u1^2*((a*((2*mc*sin(q1 - q2)^3/(c*tan(q2 - q3)) + sin(q1 - q3)*(mb*(cos(q2 - q3)*(sin(q1 -
    //   q3)*(2*sin(q1 - q2)/(c*sin(q2 - q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 - q3))/b) - 3*sin(q1
    //   - q2)*cos(q1 - q2)/c) - 2*sin(q1 - q2)*cos(q1 - q3)/c) - 2*mc*sin(q1 - q2)*(cos(q1 - q2) + sin(q1 -
    //   q2)/tan(q2 - q3))/b))/sin(q2 - q3) + 3*mb*sin(q1 - q2)*(cos(q1 - q2)*cos(q1 - q3)/c - sin(q1 -
    //   q3)^2/b)) - 2*mc*sin(q1 - q2)*cos(q1 - q2) - 2*mb*sin(q1 - q3)*cos(q1 - q3))/sin(q2 - q3) +
    //   3*mb*(cos(q1 - q2)*cos(q1 - q3) - sin(q1 - q2)*sin(q1 - q3))))/(sin(q2 - q3)*tan(q2 - q3)) +
    //   (3*g*(mb*sin(q2)*sin(q1 - q3) + mc*cos(q1 - q2)*cos(q3)) - a*u1^2*((a*((2*mc*sin(q1 -
    //   q2)^3/(c*tan(q2 - q3)) + sin(q1 - q3)*(mb*(cos(q2 - q3)*(sin(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 -
    //   q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 - q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1
    //   - q2)*cos(q1 - q3)/c) - 2*mc*sin(q1 - q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b))/sin(q2 -
    //   q3) + 3*mb*sin(q1 - q2)*(cos(q1 - q2)*cos(q1 - q3)/c - sin(q1 - q3)^2/b)) - 2*mc*sin(q1 - q2)*cos(q1
    //   - q2) - 2*mb*sin(q1 - q3)*cos(q1 - q3))/(sin(q2 - q3)*tan(q3 - q2)) + 3*mb*(cos(q1 - q2)*sin(q1 -
    //   q3) + sin(q1 - q2)*cos(q1 - q3)) + (2*mc*cos(q1 - q2)^2 - 2*mc*sin(q1 - q2)^2 + a*(3*mb*sin(q1 -
    //   q2)^2*cos(q1 - q3)/c + (2*mc*sin(q1 - q2)^3/(c*tan(q2 - q3)) + sin(q1 - q3)*(mb*(cos(q2 -
    //   q3)*(sin(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 - q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 -
    //   q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1 - q2)*cos(q1 - q3)/c) - 2*mc*sin(q1 -
    //   q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b))/(sin(q2 - q3)*tan(q3 - q2)) + 3*mb*cos(q1 -
    //   q2)*(sin(q1 - q3)^2/b - cos(q1 - q2)*cos(q1 - q3)/c) + (sin(q1 - q3)*(2*mc*cos(q1 - q2)*(cos(q1 -
    //   q2) + sin(q1 - q2)/tan(q2 - q3))/b + mb*(2*cos(q1 - q2)*cos(q1 - q3)/c + sin(q2 - q3)*(3*sin(q1 -
    //   q2)*cos(q1 - q2)/c - sin(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 - q3)) + (3*cos(q1 - q2) - 2*sin(q1 -
    //   q3)/sin(q2 - q3))/b)) + cos(q2 - q3)*(3*cos(q1 - q2)^2/c - 3*sin(q1 - q2)^2/c + sin(q1 -
    //   q3)*((3*sin(q1 - q2) + 2*sin(q1 - q3)/(sin(q2 - q3)*tan(q2 - q3)))/b - 2*cos(q1 - q2)/(c*sin(q2 -
    //   q3)) - 2*sin(q1 - q2)/(c*sin(q2 - q3)*tan(q2 - q3))))) + 2*mc*sin(q1 - q2)*(sin(q1 - q2)/tan(q2 -
    //   q3)^2 + cos(q1 - q2)/tan(q2 - q3))/b) - 2*mc*sin(q1 - q2)^3/c - 2*mc*sin(q1 - q2)^3/(c*tan(q2 -
    //   q3)^2) - 6*mc*sin(q1 - q2)^2*cos(q1 - q2)/(c*tan(q2 - q3)))/sin(q2 - q3)))/sin(q2 - q3)))/sin(q2 -
    //   q3))/(2*a*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 -
    //   q3)/sin(q2 - q3))/sin(q2 - q3))))
    let u1_dot_by_q2 = u1_dot_by_q1_of_u1_2
        * (mb
            * (u1_dot_by_q1_of_q1_q2_q3_5 * (u1_dot_by_q1_of_q1_q2 + u1_dot_by_q2_of_q1_q2_q3)
                + u1_dot_by_q1_of_q1_q2_q3_6 * u1_dot_by_q2_of_q1_q2_q3)
            + u1_dot_by_q1_of_mc_q1_q2 * u1_dot_by_q1_of_q1_q2_q3_2 * sin_q2_minus_q3_inv_sq)
        - u1_dot_by_q1_of_place_8
            * (sin_q2_minus_q3_inv
                * (g_times_3 * (-mb_c1_s3_minus_c3_s1).mul_add(s2, c3_mc_c1_c2_plus_s1_s2)
                    + u1_a_u1
                        * (u1_dot_by_q2_of_place_3
                            - sin_q2_minus_q3_inv
                                * (u1_dot_by_q1_of_mc_q1_q2_4
                                    + a
                                        * (u1_dot_by_q1_of_place_6
                                            + mb_c1_c3_plus_s1_s3 * u1_dot_by_q1_of_c_q1_q2
                                            + sin_q2_minus_q3_inv
                                                * (u1_dot_by_q2_of_place - u1_dot_by_q1_of_place_4
                                                    - c1_s3_minus_c3_s1
                                                        * (u1_dot_by_q1_of_place
                                                            + u1_dot_by_q1_of_q2_q3_2 * u1_dot_by_q1_of_b_mc_q1_q2
                                                                * u1_dot_by_q1_of_q1_q2_q3_2
                                                            + mb
                                                                * (u1_dot_by_q1_of_c_q1_q2_q3_2
                                                                    - cos_q2_minus_q3
                                                                        * (u1_dot_by_q1_of_c_q1_q2_2
                                                                            + c1_s3_minus_c3_s1
                                                                                * (-b_inv
                                                                                    * u1_dot_by_q1_of_q1_q3
                                                                                        .mul_add(u1_dot_by_q2_of_q2_q3, u1_dot_by_q1_of_q1_q2)
                                                                                    + u1_dot_by_q1_of_q2_q3 * u1_dot_by_q2_of_c_q1_q2_q3))
                                                                    + u1_dot_by_q2_of_b_c_q1_q2_q3)))
                                            - u1_dot_by_q2_of_place_2)) + u1_dot_by_q2_of_mb_q1_q2_q3))
                + u1_dot_by_q2_of_u1);
    // u1_dot_by_q1_of_q1_q2_q3_7 + u1_dot_by_q2_of_q1_q2_q3
    let u1_dot_by_q3_of_q1_q2_q3 = u1_dot_by_q1_of_q1_q2_q3_7 + u1_dot_by_q2_of_q1_q2_q3;
    let u1_dot_by_q3_of_c_q1_q2_q3 = c1_s2_minus_c2_s1_c_inv * u1_dot_by_q2_of_q2_q3;
    // u1_dot_by_q3 = (2*mc*sin(q1 - q2)^2/(sin(q2 - q3)^2*tan(q2 - q3)) + mb*(sin(q1 - q3)*(3*cos(q1 - q2)
    //   - sin(q1 - q3)/sin(q2 - q3))/(sin(q2 - q3)*tan(q3 - q2)) + cos(q1 - q3)*(3*cos(q1 - q2) - sin(q1 -
    //   q3)/sin(q2 - q3))/sin(q2 - q3) - sin(q1 - q3)*(sin(q1 - q3)/(sin(q2 - q3)*tan(q3 - q2)) + cos(q1 -
    //   q3)/sin(q2 - q3))/sin(q2 - q3)))*(3*g*(ma*cos(q1) + 2*mb*(cos(q2)*cos(q1 - q2) - sin(q2)*sin(q1 -
    //   q2))) - (3*g*(mb*cos(q2)*sin(q1 - q3) + mc*sin(q1 - q2)*cos(q3)) + a*u1^2*((a*((2*mc*sin(q1 -
    //   q2)^3/(c*tan(q2 - q3)) + sin(q1 - q3)*(mb*(cos(q2 - q3)*(sin(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 -
    //   q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 - q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1
    //   - q2)*cos(q1 - q3)/c) - 2*mc*sin(q1 - q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b))/sin(q2 -
    //   q3) + 3*mb*sin(q1 - q2)*(cos(q1 - q2)*cos(q1 - q3)/c - sin(q1 - q3)^2/b)) - 2*mc*sin(q1 - q2)*cos(q1
    //   - q2) - 2*mb*sin(q1 - q3)*cos(q1 - q3))/sin(q2 - q3) + 3*mb*(cos(q1 - q2)*cos(q1 - q3) - sin(q1 -
    //   q2)*sin(q1 - q3))))/sin(q2 - q3))/(2*a*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 -
    //   q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3)))^2) + ((3*g*(mb*cos(q2)*sin(q1 - q3)
    //   + mc*sin(q1 - q2)*cos(q3)) + a*u1^2*((a*((2*mc*sin(q1 - q2)^3/(c*tan(q2 - q3)) + sin(q1 -
    //   q3)*(mb*(cos(q2 - q3)*(sin(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 - q3)) + (3*cos(q1 - q2) - 2*sin(q1 -
    //   q3)/sin(q2 - q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1 - q2)*cos(q1 - q3)/c) - 2*mc*sin(q1
    //   - q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b))/sin(q2 - q3) + 3*mb*sin(q1 - q2)*(cos(q1 -
    //   q2)*cos(q1 - q3)/c - sin(q1 - q3)^2/b)) - 2*mc*sin(q1 - q2)*cos(q1 - q2) - 2*mb*sin(q1 - q3)*cos(q1
    //   - q3))/sin(q2 - q3) + 3*mb*(cos(q1 - q2)*cos(q1 - q3) - sin(q1 - q2)*sin(q1 - q3))))/(sin(q2 -
    //   q3)*tan(q2 - q3)) + (a*u1^2*((a*((2*mc*sin(q1 - q2)^3/(c*tan(q2 - q3)) + sin(q1 - q3)*(mb*(cos(q2 -
    //   q3)*(sin(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 - q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 -
    //   q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1 - q2)*cos(q1 - q3)/c) - 2*mc*sin(q1 -
    //   q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b))/sin(q2 - q3) + 3*mb*sin(q1 - q2)*(cos(q1 -
    //   q2)*cos(q1 - q3)/c - sin(q1 - q3)^2/b)) - 2*mc*sin(q1 - q2)*cos(q1 - q2) - 2*mb*sin(q1 - q3)*cos(q1
    //   - q3))/(sin(q2 - q3)*tan(q2 - q3)) + 3*mb*(cos(q1 - q2)*sin(q1 - q3) + sin(q1 - q2)*cos(q1 - q3)) +
    //   (2*mb*cos(q1 - q3)^2 - 2*mb*sin(q1 - q3)^2 + a*((2*mc*sin(q1 - q2)^3/(c*tan(q2 - q3)) + sin(q1 -
    //   q3)*(mb*(cos(q2 - q3)*(sin(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 - q3)) + (3*cos(q1 - q2) - 2*sin(q1 -
    //   q3)/sin(q2 - q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1 - q2)*cos(q1 - q3)/c) - 2*mc*sin(q1
    //   - q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b))/(sin(q2 - q3)*tan(q2 - q3)) + (2*mc*sin(q1 -
    //   q2)^3/c - cos(q1 - q3)*(mb*(cos(q2 - q3)*(sin(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 - q3)) + (3*cos(q1
    //   - q2) - 2*sin(q1 - q3)/sin(q2 - q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1 - q2)*cos(q1 -
    //   q3)/c) - 2*mc*sin(q1 - q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b) + 2*mc*sin(q1 -
    //   q2)^3/(c*tan(q2 - q3)^2) - sin(q1 - q3)*(2*mc*sin(q1 - q2)*(sin(q1 - q2) + sin(q1 - q2)/tan(q2 -
    //   q3)^2)/b + mb*(2*sin(q1 - q2)*sin(q1 - q3)/c + sin(q2 - q3)*(3*sin(q1 - q2)*cos(q1 - q2)/c - sin(q1
    //   - q3)*(2*sin(q1 - q2)/(c*sin(q2 - q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 - q3))/b)) + cos(q2
    //   - q3)*(cos(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 - q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 -
    //   q3))/b) - 2*sin(q1 - q3)*(sin(q1 - q2)/(c*sin(q2 - q3)*tan(q2 - q3)) + (sin(q1 - q3)/(sin(q2 -
    //   q3)*tan(q3 - q2)) + cos(q1 - q3)/sin(q2 - q3))/b)))))/sin(q2 - q3) + 3*mb*sin(q1 - q2)*(cos(q1 -
    //   q2)*sin(q1 - q3)/c + 2*sin(q1 - q3)*cos(q1 - q3)/b)))/sin(q2 - q3)) - 3*g*(mc*sin(q1 - q2)*sin(q3) +
    //   mb*cos(q2)*cos(q1 - q3)))/sin(q2 - q3))/(2*a*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1
    //   - q3)*(3*cos(q1 - q2) - sin(q1 - q3)/sin(q2 - q3))/sin(q2 - q3))))
    let u1_dot_by_q3 = u1_dot_by_q1_of_place_8
        * (u1_dot_by_q2_of_u1
            - sin_q2_minus_q3_inv
                * (g_times_3 * (-mc_c1_s2_minus_c2_s1).mul_add(s3, c2_mb_c1_c3_plus_s1_s3)
                    + u1_a_u1
                        * (u1_dot_by_q2_of_mb_q1_q2_q3 - u1_dot_by_q2_of_place_3
                            - sin_q2_minus_q3_inv
                                * (a
                                    * (u1_dot_by_q2_of_place_2
                                        + u1_dot_by_q1_of_b_c_q1_q2_q3_4 * mb_u1_dot_by_q1_of_q1_q2
                                        + sin_q2_minus_q3_inv
                                            * (u1_dot_by_q1_of_place_3 - u1_dot_by_q2_of_place
                                                + c1_s3_minus_c3_s1
                                                    * (mb
                                                        * (u1_dot_by_q1_of_c_q1_q2_q3 + u1_dot_by_q2_of_b_c_q1_q2_q3
                                                            + cos_q2_minus_q3
                                                                * (u1_dot_by_q1_of_b_c_q1_q2_q3_2
                                                                    + u1_dot_by_q1_of_q1_q3
                                                                        * b_inv
                                                                            .mul_add(
                                                                                u1_dot_by_q3_of_q1_q2_q3,
                                                                                -u1_dot_by_q3_of_c_q1_q2_q3,
                                                                            )))
                                                        + c1_s2_minus_c2_s1 * u1_dot_by_q1_of_b_mc_q1_q2
                                                            * u1_dot_by_q2_of_q2_q3_2))) - u1_dot_by_q1_of_mb_q1_q3))))
        - u1_dot_by_q1_of_u1_2
            * (mb * u1_dot_by_q3_of_q1_q2_q3
                * (u1_dot_by_q1_of_q1_q2_q3_5 + u1_dot_by_q1_of_q1_q2_q3_6)
                + sin_q2_minus_q3_inv * u1_dot_by_q1_of_mc_q1_q2_3 * u1_dot_by_q2_of_q2_q3);
    // u1_dot_by_u1 = u1*((a*((2*mc*sin(q1 - q2)^3/(c*tan(q2 - q3)) + sin(q1 - q3)*(mb*(cos(q2 -
    //   q3)*(sin(q1 - q3)*(2*sin(q1 - q2)/(c*sin(q2 - q3)) + (3*cos(q1 - q2) - 2*sin(q1 - q3)/sin(q2 -
    //   q3))/b) - 3*sin(q1 - q2)*cos(q1 - q2)/c) - 2*sin(q1 - q2)*cos(q1 - q3)/c) - 2*mc*sin(q1 -
    //   q2)*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/b))/sin(q2 - q3) + 3*mb*sin(q1 - q2)*(cos(q1 -
    //   q2)*cos(q1 - q3)/c - sin(q1 - q3)^2/b)) - 2*mc*sin(q1 - q2)*cos(q1 - q2) - 2*mb*sin(q1 - q3)*cos(q1
    //   - q3))/sin(q2 - q3) + 3*mb*(cos(q1 - q2)*cos(q1 - q3) - sin(q1 - q2)*sin(q1 - q3)))/(sin(q2 -
    //   q3)*(ma + mc*sin(q1 - q2)^2/sin(q2 - q3)^2 + mb*(3 - sin(q1 - q3)*(3*cos(q1 - q2) - sin(q1 -
    //   q3)/sin(q2 - q3))/sin(q2 - q3))))
    let u1_dot_by_u1 = u1 * sin_q2_minus_q3_inv * u1_dot_by_q1_of_place_7
        * u1_dot_by_q1_of_place_11;
    let b_inv_a_u1 = b_inv * a_u1;
    let sin_q2_minus_q3_inv_a_u1 = sin_q2_minus_q3_inv * a_u1;
    // Entries that are not zero.
    // d(q1')/d(u1) = 1
    let q1_dot_by_u1_value = S::int(1);
    // d(q2')/d(q1) = -a*u1*cos(q1 - q3)/(b*sin(q2 - q3))
    let q2_dot_by_q1_value = -u1_dot_by_q1_of_q1_q2_q3_7 * b_inv_a_u1;
    // d(q2')/d(q2) = a*u1*sin(q1 - q3)/(b*sin(q2 - q3)*tan(q2 - q3))
    let q2_dot_by_q2_value = -u1_dot_by_q2_of_q1_q2_q3 * b_inv_a_u1;
    // d(q2')/d(q3) = a*u1*(sin(q1 - q3)/tan(q3 - q2) + cos(q1 - q3))/(b*sin(q2 - q3))
    let q2_dot_by_q3_value = u1_dot_by_q3_of_q1_q2_q3 * b_inv_a_u1;
    // d(q2')/d(u1) = -a*sin(q1 - q3)/(b*sin(q2 - q3))
    let q2_dot_by_u1_value = a * b_inv * u1_dot_by_q1_of_q1_q2_q3_5;
    // d(q3')/d(q1) = -a*u1*cos(q1 - q2)/(c*sin(q2 - q3))
    let q3_dot_by_q1_value = -c1_c2_plus_s1_s2_c_inv * sin_q2_minus_q3_inv_a_u1;
    // d(q3')/d(q2) = a*u1*(cos(q1 - q2) + sin(q1 - q2)/tan(q2 - q3))/(c*sin(q2 - q3))
    let q3_dot_by_q2_value = -u1_dot_by_q2_of_c_q1_q2_q3 * sin_q2_minus_q3_inv_a_u1;
    // d(q3')/d(q3) = a*u1*sin(q1 - q2)/(c*sin(q2 - q3)*tan(q3 - q2))
    let q3_dot_by_q3_value = a_u1 * u1_dot_by_q3_of_c_q1_q2_q3;
    // d(q3')/d(u1) = -a*sin(q1 - q2)/(c*sin(q2 - q3))
    let q3_dot_by_u1_value = a * sin_q2_minus_q3_inv * c1_s2_minus_c2_s1_c_inv;
    let zero = S::int(0);
    [
        [zero, zero, zero, q1_dot_by_u1_value],
        [q2_dot_by_q1_value, q2_dot_by_q2_value, q2_dot_by_q3_value, q2_dot_by_u1_value],
        [q3_dot_by_q1_value, q3_dot_by_q2_value, q3_dot_by_q3_value, q3_dot_by_u1_value],
        [u1_dot_by_q1, u1_dot_by_q2, u1_dot_by_q3, u1_dot_by_u1],
    ]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 39 convolutions and 78 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 4]],
    history: &mut [Factors<S, 40>],
) {
    let Parameters { a, b, c, ma, mb, mc, g, .. } = *p;
    let [q1_0, q2_0, q3_0, u1_0] = series[0];
    // Shared terms.
    let b_inv_mc = mc / b;
    let c_inv_mb = mb / c;
    let a_inv_mb_g = mb * g / a;
    // Constant in time.
    // ma_plus_3_mb = ma + 3*mb
    let ma_plus_3_mb = mb.mul_add(S::int(3), ma);
    // minus_mb = -mb
    let minus_mb = -mb;
    // weight = 2*mc
    let weight = S::int(2) * mc;
    // minus_3_a_mb_by_c = -3*a*mb/c
    let minus_3_a_mb_by_c = -S::int(3) * a * mb / c;
    // mc_by_b = mc/b
    let mc_by_b = b_inv_mc;
    // minus_mb_by_c = -mb/c
    let minus_mb_by_c = -c_inv_mb;
    // weight_2 = 3*mb/c
    let weight_2 = S::int(3) * c_inv_mb;
    // weight_3 = 2*mc/b
    let weight_3 = S::int(2) * b_inv_mc;
    // weight_4 = 2*mb/c
    let weight_4 = S::int(2) * c_inv_mb;
    // minus_mb_by_b = -mb/b
    let minus_mb_by_b = -mb / b;
    // weight_5 = 2*mb
    let weight_5 = S::int(2) * mb;
    // weight_6 = 3*a*mb/b
    let weight_6 = S::int(3) * a * mb / b;
    // minus_2_a_mc_by_c = -2*a*mc/c
    let minus_2_a_mc_by_c = -S::int(2) * a * mc / c;
    // weight_7 = 3*mb
    let weight_7 = S::int(3) * mb;
    // minus_3_mb = -3*mb
    let minus_3_mb = -S::int(3) * mb;
    // weight_8 = 3*mc*g/a
    let weight_8 = S::int(3) * mc * g / a;
    // weight_9 = 3*mb*g/a
    let weight_9 = S::int(3) * a_inv_mb_g;
    // weight_10 = 3*ma*g/a
    let weight_10 = S::int(3) * ma * g / a;
    // weight_11 = 6*mb*g/a
    let weight_11 = S::int(6) * a_inv_mb_g;
    // minus_6_mb_g_by_a = -6*mb*g/a
    let minus_6_mb_g_by_a = -S::int(6) * a_inv_mb_g;
    // minus_a_by_b = -a/b
    let minus_a_by_b = -a / b;
    // minus_a_by_c = -a/c
    let minus_a_by_c = -a / c;
    // Order 0.
    let (s1_0, c1_0) = q1_0.sin_cos();
    let (s2_0, c2_0) = q2_0.sin_cos();
    let (s3_0, c3_0) = q3_0.sin_cos();
    let q2_minus_q3_0 = q2_0 - q3_0;
    let (sin_q2_minus_q3_0, cos_q2_minus_q3_0) = q2_minus_q3_0.sin_cos();
    let over_sin_q2_minus_q3 = S::int(1) / sin_q2_minus_q3_0;
    let q1_minus_q3_0 = q1_0 - q3_0;
    let (sin_q1_minus_q3_0, cos_q1_minus_q3_0) = q1_minus_q3_0.sin_cos();
    let q1_minus_q2_0 = q1_0 - q2_0;
    let (sin_q1_minus_q2_0, cos_q1_minus_q2_0) = q1_minus_q2_0.sin_cos();
    let u1_dot_of_q1_q2_q3_0 = sin_q1_minus_q3_0 * over_sin_q2_minus_q3;
    let u1_dot_of_q1_q2_q3_2_0 = S::int(3) * cos_q1_minus_q2_0 - u1_dot_of_q1_q2_q3_0;
    let u1_dot_of_q1_q2_q3_3_0 = u1_dot_of_q1_q2_q3_2_0 * u1_dot_of_q1_q2_q3_0;
    let u1_dot_of_q1_q2_q3_4_0 = sin_q1_minus_q2_0 * over_sin_q2_minus_q3;
    let u1_dot_of_q1_q2_q3_5_0 = u1_dot_of_q1_q2_q3_4_0 * u1_dot_of_q1_q2_q3_4_0;
    let u1_dot_of_place_0 = u1_dot_of_q1_q2_q3_3_0
        .mul_add(minus_mb, u1_dot_of_q1_q2_q3_5_0.mul_add(mc, ma_plus_3_mb));
    let over_u1_dot_of_place = S::int(1) / u1_dot_of_place_0;
    let u1_dot_of_q1_q2_q3_6_0 = u1_dot_of_q1_q2_q3_0
        .mul_add(-S::int(2), S::int(3) * cos_q1_minus_q2_0);
    let c2_cos_q1_minus_q2_0 = c2_0 * cos_q1_minus_q2_0;
    let s2_sin_q1_minus_q2_0 = s2_0 * sin_q1_minus_q2_0;
    let u1_dot_of_q1_q2_q3_7_0 = cos_q1_minus_q3_0 * cos_q1_minus_q2_0;
    let u1_dot_of_place_2_0 = cos_q1_minus_q3_0.mul_add(minus_3_a_mb_by_c, weight);
    let c3_sin_q1_minus_q2_0 = c3_0 * sin_q1_minus_q2_0;
    let u1_dot_of_q1_q2_q3_8_0 = sin_q1_minus_q3_0 * sin_q1_minus_q2_0;
    let u1_dot_of_place_3_0 = sin_q1_minus_q3_0
        .mul_add(minus_mb_by_c, mc_by_b * sin_q1_minus_q2_0);
    let u1_dot_of_place_4_0 = u1_dot_of_place_3_0 * over_sin_q2_minus_q3;
    let u1_dot_of_place_5_0 = u1_dot_of_place_4_0
        .mul_add(S::int(2), weight_2 * cos_q1_minus_q2_0);
    let u1_dot_of_place_6_0 = cos_q2_minus_q3_0 * u1_dot_of_place_5_0;
    let u1_dot_of_place_7_0 = cos_q1_minus_q3_0
        .mul_add(weight_4, weight_3 * cos_q1_minus_q2_0) + u1_dot_of_place_6_0;
    let u1_dot_of_place_8_0 = sin_q1_minus_q2_0 * u1_dot_of_place_7_0;
    let u1_dot_of_q1_q2_q3_9_0 = sin_q1_minus_q3_0 * cos_q2_minus_q3_0;
    let u1_dot_of_q1_q2_q3_10_0 = u1_dot_of_q1_q2_q3_6_0 * u1_dot_of_q1_q2_q3_9_0;
    let u1_dot_of_place_9_0 = minus_mb_by_b * u1_dot_of_q1_q2_q3_10_0 + u1_dot_of_place_8_0;
    let u1_dot_of_place_10_0 = u1_dot_of_place_9_0 * over_sin_q2_minus_q3;
    let u1_dot_of_place_11_0 = u1_dot_of_place_10_0
        .mul_add(
            a,
            u1_dot_of_q1_q2_q3_8_0.mul_add(weight_6, weight_5 * cos_q1_minus_q3_0),
        );
    let u1_dot_of_place_12_0 = sin_q1_minus_q3_0 * u1_dot_of_place_11_0;
    let u1_dot_of_place_13_0 = cos_q1_minus_q2_0 * u1_dot_of_place_2_0;
    let u1_dot_of_q1_q2_q3_11_0 = cos_q2_minus_q3_0 * u1_dot_of_q1_q2_q3_5_0;
    let u1_dot_of_place_14_0 = u1_dot_of_q1_q2_q3_11_0
        .mul_add(minus_2_a_mc_by_c, u1_dot_of_place_13_0);
    let u1_dot_of_place_15_0 = sin_q1_minus_q2_0 * u1_dot_of_place_14_0;
    let u1_dot_of_place_16_0 = u1_dot_of_place_15_0 + u1_dot_of_place_12_0;
    let u1_dot_of_place_17_0 = u1_dot_of_place_16_0 * over_sin_q2_minus_q3;
    let u1_dot_of_place_18_0 = u1_dot_of_q1_q2_q3_8_0
        .mul_add(minus_3_mb, weight_7 * u1_dot_of_q1_q2_q3_7_0) - u1_dot_of_place_17_0;
    let u1_sq_0 = u1_0 * u1_0;
    let u1_dot_of_u1_0 = u1_dot_of_place_18_0 * u1_sq_0;
    let c2_sin_q1_minus_q3_0 = c2_0 * sin_q1_minus_q3_0;
    let u1_dot_of_u1_2_0 = c2_sin_q1_minus_q3_0
        .mul_add(weight_9, weight_8 * c3_sin_q1_minus_q2_0) + u1_dot_of_u1_0;
    let u1_dot_of_u1_3_0 = u1_dot_of_u1_2_0 * over_sin_q2_minus_q3;
    let u1_dot_of_u1_4_0 = s2_sin_q1_minus_q2_0
        .mul_add(
            minus_6_mb_g_by_a,
            c2_cos_q1_minus_q2_0.mul_add(weight_11, weight_10 * c1_0),
        ) - u1_dot_of_u1_3_0;
    let u1_dot_of_u1_5_0 = u1_dot_of_u1_4_0 * over_u1_dot_of_place;
    let q2_of_u1_0 = u1_0 * u1_dot_of_q1_q2_q3_0;
    let q3_of_u1_0 = u1_0 * u1_dot_of_q1_q2_q3_4_0;
    // Order 1: the rates, and what follows from them.
    let q1_1 = u1_0;
    let q2_1 = minus_a_by_b * q2_of_u1_0;
    let q3_1 = minus_a_by_c * q3_of_u1_0;
    let u1_1 = -S::ratio(1, 2) * u1_dot_of_u1_5_0;
    if series.len() > 1 {
        series[1] = [q1_1, q2_1, q3_1, u1_1];
    }
    let s1_1 = q1_1 * c1_0;
    let c1_1 = -q1_1 * s1_0;
    let s2_1 = q2_1 * c2_0;
    let c2_1 = -q2_1 * s2_0;
    let s3_1 = q3_1 * c3_0;
    let c3_1 = -q3_1 * s3_0;
    let q2_minus_q3_1 = q2_1 - q3_1;
    let sin_q2_minus_q3_1 = q2_minus_q3_1 * cos_q2_minus_q3_0;
    let cos_q2_minus_q3_1 = -q2_minus_q3_1 * sin_q2_minus_q3_0;
    let q1_minus_q3_1 = q1_1 - q3_1;
    let sin_q1_minus_q3_1 = q1_minus_q3_1 * cos_q1_minus_q3_0;
    let cos_q1_minus_q3_1 = -q1_minus_q3_1 * sin_q1_minus_q3_0;
    let q1_minus_q2_1 = q1_1 - q2_1;
    let sin_q1_minus_q2_1 = q1_minus_q2_1 * cos_q1_minus_q2_0;
    let cos_q1_minus_q2_1 = -q1_minus_q2_1 * sin_q1_minus_q2_0;
    let u1_dot_of_q1_q2_q3_1 = sin_q2_minus_q3_1
        .mul_add(
            -(u1_dot_of_q1_q2_q3_0 * over_sin_q2_minus_q3),
            sin_q1_minus_q3_1 * over_sin_q2_minus_q3,
        );
    let u1_dot_of_q1_q2_q3_2_1 = S::int(3) * cos_q1_minus_q2_1 - u1_dot_of_q1_q2_q3_1;
    let u1_dot_of_q1_q2_q3_3_1 = u1_dot_of_q1_q2_q3_2_1
        .mul_add(u1_dot_of_q1_q2_q3_0, u1_dot_of_q1_q2_q3_1 * u1_dot_of_q1_q2_q3_2_0);
    let u1_dot_of_q1_q2_q3_4_1 = sin_q2_minus_q3_1
        .mul_add(
            -(u1_dot_of_q1_q2_q3_4_0 * over_sin_q2_minus_q3),
            sin_q1_minus_q2_1 * over_sin_q2_minus_q3,
        );
    let u1_dot_of_q1_q2_q3_5_1 = u1_dot_of_q1_q2_q3_4_1
        * (u1_dot_of_q1_q2_q3_4_0 + u1_dot_of_q1_q2_q3_4_0);
    let u1_dot_of_place_1 = u1_dot_of_q1_q2_q3_3_1
        .mul_add(minus_mb, mc * u1_dot_of_q1_q2_q3_5_1);
    let u1_dot_of_q1_q2_q3_6_1 = u1_dot_of_q1_q2_q3_1
        .mul_add(-S::int(2), S::int(3) * cos_q1_minus_q2_1);
    let c2_cos_q1_minus_q2_1 = cos_q1_minus_q2_1.mul_add(c2_0, c2_1 * cos_q1_minus_q2_0);
    let s2_sin_q1_minus_q2_1 = sin_q1_minus_q2_1.mul_add(s2_0, s2_1 * sin_q1_minus_q2_0);
    let u1_dot_of_q1_q2_q3_7_1 = cos_q1_minus_q2_1
        .mul_add(cos_q1_minus_q3_0, cos_q1_minus_q3_1 * cos_q1_minus_q2_0);
    let u1_dot_of_place_2_1 = minus_3_a_mb_by_c * cos_q1_minus_q3_1;
    let c3_sin_q1_minus_q2_1 = sin_q1_minus_q2_1.mul_add(c3_0, c3_1 * sin_q1_minus_q2_0);
    let u1_dot_of_q1_q2_q3_8_1 = sin_q1_minus_q2_1
        .mul_add(sin_q1_minus_q3_0, sin_q1_minus_q3_1 * sin_q1_minus_q2_0);
    let u1_dot_of_place_3_1 = sin_q1_minus_q3_1
        .mul_add(minus_mb_by_c, mc_by_b * sin_q1_minus_q2_1);
    let u1_dot_of_place_4_1 = sin_q2_minus_q3_1
        .mul_add(
            -(u1_dot_of_place_4_0 * over_sin_q2_minus_q3),
            u1_dot_of_place_3_1 * over_sin_q2_minus_q3,
        );
    let u1_dot_of_place_5_1 = u1_dot_of_place_4_1
        .mul_add(S::int(2), weight_2 * cos_q1_minus_q2_1);
    let u1_dot_of_place_6_1 = u1_dot_of_place_5_1
        .mul_add(cos_q2_minus_q3_0, cos_q2_minus_q3_1 * u1_dot_of_place_5_0);
    let u1_dot_of_place_7_1 = cos_q1_minus_q3_1
        .mul_add(weight_4, weight_3 * cos_q1_minus_q2_1) + u1_dot_of_place_6_1;
    let u1_dot_of_place_8_1 = u1_dot_of_place_7_1
        .mul_add(sin_q1_minus_q2_0, sin_q1_minus_q2_1 * u1_dot_of_place_7_0);
    let u1_dot_of_q1_q2_q3_9_1 = cos_q2_minus_q3_1
        .mul_add(sin_q1_minus_q3_0, sin_q1_minus_q3_1 * cos_q2_minus_q3_0);
    let u1_dot_of_q1_q2_q3_10_1 = u1_dot_of_q1_q2_q3_6_1
        .mul_add(
            u1_dot_of_q1_q2_q3_9_0,
            u1_dot_of_q1_q2_q3_9_1 * u1_dot_of_q1_q2_q3_6_0,
        );
    let u1_dot_of_place_9_1 = minus_mb_by_b * u1_dot_of_q1_q2_q3_10_1 + u1_dot_of_place_8_1;
    let u1_dot_of_place_10_1 = sin_q2_minus_q3_1
        .mul_add(
            -(u1_dot_of_place_10_0 * over_sin_q2_minus_q3),
            u1_dot_of_place_9_1 * over_sin_q2_minus_q3,
        );
    let u1_dot_of_place_11_1 = u1_dot_of_place_10_1
        .mul_add(
            a,
            u1_dot_of_q1_q2_q3_8_1.mul_add(weight_6, weight_5 * cos_q1_minus_q3_1),
        );
    let u1_dot_of_place_12_1 = u1_dot_of_place_11_1
        .mul_add(sin_q1_minus_q3_0, sin_q1_minus_q3_1 * u1_dot_of_place_11_0);
    let u1_dot_of_place_13_1 = u1_dot_of_place_2_1
        .mul_add(cos_q1_minus_q2_0, cos_q1_minus_q2_1 * u1_dot_of_place_2_0);
    let u1_dot_of_q1_q2_q3_11_1 = u1_dot_of_q1_q2_q3_5_1
        .mul_add(cos_q2_minus_q3_0, cos_q2_minus_q3_1 * u1_dot_of_q1_q2_q3_5_0);
    let u1_dot_of_place_14_1 = u1_dot_of_q1_q2_q3_11_1
        .mul_add(minus_2_a_mc_by_c, u1_dot_of_place_13_1);
    let u1_dot_of_place_15_1 = u1_dot_of_place_14_1
        .mul_add(sin_q1_minus_q2_0, sin_q1_minus_q2_1 * u1_dot_of_place_14_0);
    let u1_dot_of_place_16_1 = u1_dot_of_place_15_1 + u1_dot_of_place_12_1;
    let u1_dot_of_place_17_1 = sin_q2_minus_q3_1
        .mul_add(
            -(u1_dot_of_place_17_0 * over_sin_q2_minus_q3),
            u1_dot_of_place_16_1 * over_sin_q2_minus_q3,
        );
    let u1_dot_of_place_18_1 = u1_dot_of_q1_q2_q3_8_1
        .mul_add(minus_3_mb, weight_7 * u1_dot_of_q1_q2_q3_7_1) - u1_dot_of_place_17_1;
    let u1_sq_1 = u1_1 * (u1_0 + u1_0);
    let u1_dot_of_u1_1 = u1_dot_of_place_18_1
        .mul_add(u1_sq_0, u1_sq_1 * u1_dot_of_place_18_0);
    let c2_sin_q1_minus_q3_1 = sin_q1_minus_q3_1.mul_add(c2_0, c2_1 * sin_q1_minus_q3_0);
    let u1_dot_of_u1_2_1 = c2_sin_q1_minus_q3_1
        .mul_add(weight_9, weight_8 * c3_sin_q1_minus_q2_1) + u1_dot_of_u1_1;
    let u1_dot_of_u1_3_1 = sin_q2_minus_q3_1
        .mul_add(
            -(u1_dot_of_u1_3_0 * over_sin_q2_minus_q3),
            u1_dot_of_u1_2_1 * over_sin_q2_minus_q3,
        );
    let u1_dot_of_u1_4_1 = s2_sin_q1_minus_q2_1
        .mul_add(
            minus_6_mb_g_by_a,
            c2_cos_q1_minus_q2_1.mul_add(weight_11, weight_10 * c1_1),
        ) - u1_dot_of_u1_3_1;
    let u1_dot_of_u1_5_1 = u1_dot_of_place_1
        .mul_add(
            -(u1_dot_of_u1_5_0 * over_u1_dot_of_place),
            u1_dot_of_u1_4_1 * over_u1_dot_of_place,
        );
    let q2_of_u1_1 = u1_dot_of_q1_q2_q3_1.mul_add(u1_0, u1_1 * u1_dot_of_q1_q2_q3_0);
    let q3_of_u1_1 = u1_dot_of_q1_q2_q3_4_1.mul_add(u1_0, u1_1 * u1_dot_of_q1_q2_q3_4_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                q1_1, q1_1, q2_1, q2_1, q3_1, q3_1, q2_minus_q3_1, q2_minus_q3_1, q1_minus_q3_1,
                q1_minus_q3_1, q1_minus_q2_1, q1_minus_q2_1, sin_q2_minus_q3_1,
                u1_dot_of_q1_q2_q3_2_1, sin_q2_minus_q3_1, u1_dot_of_q1_q2_q3_4_1, c2_1, s2_1,
                cos_q1_minus_q3_1, c3_1, sin_q1_minus_q3_1, sin_q2_minus_q3_1, cos_q2_minus_q3_1,
                sin_q1_minus_q2_1, sin_q1_minus_q3_1, u1_dot_of_q1_q2_q3_6_1, sin_q2_minus_q3_1,
                sin_q1_minus_q3_1, cos_q1_minus_q2_1, cos_q2_minus_q3_1, sin_q1_minus_q2_1,
                sin_q2_minus_q3_1, u1_1, u1_dot_of_place_18_1, c2_1, sin_q2_minus_q3_1,
                u1_dot_of_place_1, u1_1, u1_1,
            ]),
            padded([
                c1_1, s1_1, c2_1, s2_1, c3_1, s3_1, cos_q2_minus_q3_1, sin_q2_minus_q3_1,
                cos_q1_minus_q3_1, sin_q1_minus_q3_1, cos_q1_minus_q2_1, sin_q1_minus_q2_1,
                u1_dot_of_q1_q2_q3_1, u1_dot_of_q1_q2_q3_1, u1_dot_of_q1_q2_q3_4_1,
                u1_dot_of_q1_q2_q3_4_1, cos_q1_minus_q2_1, sin_q1_minus_q2_1, cos_q1_minus_q2_1,
                sin_q1_minus_q2_1, sin_q1_minus_q2_1, u1_dot_of_place_4_1, u1_dot_of_place_5_1,
                u1_dot_of_place_7_1, cos_q2_minus_q3_1, u1_dot_of_q1_q2_q3_9_1,
                u1_dot_of_place_10_1, u1_dot_of_place_11_1, u1_dot_of_place_2_1,
                u1_dot_of_q1_q2_q3_5_1, u1_dot_of_place_14_1, u1_dot_of_place_17_1, u1_1, u1_sq_1,
                sin_q1_minus_q3_1, u1_dot_of_u1_3_1, u1_dot_of_u1_5_1, u1_dot_of_q1_q2_q3_1,
                u1_dot_of_q1_q2_q3_4_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q1_last = q1_1;
    let mut q2_last = q2_1;
    let mut q3_last = q3_1;
    let mut u1_last = u1_1;
    let mut s1_last = s1_1;
    let mut c1_last = c1_1;
    let mut s2_last = s2_1;
    let mut c2_last = c2_1;
    let mut s3_last = s3_1;
    let mut c3_last = c3_1;
    let mut q2_minus_q3_last = q2_minus_q3_1;
    let mut sin_q2_minus_q3_last = sin_q2_minus_q3_1;
    let mut cos_q2_minus_q3_last = cos_q2_minus_q3_1;
    let mut q1_minus_q3_last = q1_minus_q3_1;
    let mut sin_q1_minus_q3_last = sin_q1_minus_q3_1;
    let mut cos_q1_minus_q3_last = cos_q1_minus_q3_1;
    let mut q1_minus_q2_last = q1_minus_q2_1;
    let mut sin_q1_minus_q2_last = sin_q1_minus_q2_1;
    let mut cos_q1_minus_q2_last = cos_q1_minus_q2_1;
    let mut u1_dot_of_q1_q2_q3_last = u1_dot_of_q1_q2_q3_1;
    let mut u1_dot_of_q1_q2_q3_2_last = u1_dot_of_q1_q2_q3_2_1;
    let mut u1_dot_of_q1_q2_q3_4_last = u1_dot_of_q1_q2_q3_4_1;
    let mut u1_dot_of_q1_q2_q3_5_last = u1_dot_of_q1_q2_q3_5_1;
    let mut u1_dot_of_place_last = u1_dot_of_place_1;
    let mut u1_dot_of_q1_q2_q3_6_last = u1_dot_of_q1_q2_q3_6_1;
    let mut u1_dot_of_place_2_last = u1_dot_of_place_2_1;
    let mut u1_dot_of_place_4_last = u1_dot_of_place_4_1;
    let mut u1_dot_of_place_5_last = u1_dot_of_place_5_1;
    let mut u1_dot_of_place_7_last = u1_dot_of_place_7_1;
    let mut u1_dot_of_q1_q2_q3_9_last = u1_dot_of_q1_q2_q3_9_1;
    let mut u1_dot_of_place_10_last = u1_dot_of_place_10_1;
    let mut u1_dot_of_place_11_last = u1_dot_of_place_11_1;
    let mut u1_dot_of_place_14_last = u1_dot_of_place_14_1;
    let mut u1_dot_of_place_17_last = u1_dot_of_place_17_1;
    let mut u1_dot_of_place_18_last = u1_dot_of_place_18_1;
    let mut u1_sq_last = u1_sq_1;
    let mut u1_dot_of_u1_3_last = u1_dot_of_u1_3_1;
    let mut u1_dot_of_u1_5_last = u1_dot_of_u1_5_1;
    let mut next = [S::int(0); 40];
    // Rates at order k - 1.
    let mut q1_rate = u1_1;
    let mut q2_rate = minus_a_by_b * q2_of_u1_1;
    let mut q3_rate = minus_a_by_c * q3_of_u1_1;
    let mut u1_rate = -S::ratio(1, 2) * u1_dot_of_u1_5_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q1 = q1_rate * over_k;
        let q2 = q2_rate * over_k;
        let q3 = q3_rate * over_k;
        let u1 = u1_rate * over_k;
        series[order] = [q1, q2, q3, u1];
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
                q2_1.mul_add(c2_last, (count_last * q2_last).mul_add(c2_1, next[2])),
                q2_1.mul_add(s2_last, (count_last * q2_last).mul_add(s2_1, next[3])),
                q3_1.mul_add(c3_last, (count_last * q3_last).mul_add(c3_1, next[4])),
                q3_1.mul_add(s3_last, (count_last * q3_last).mul_add(s3_1, next[5])),
                q2_minus_q3_1
                    .mul_add(
                        cos_q2_minus_q3_last,
                        (count_last * q2_minus_q3_last)
                            .mul_add(cos_q2_minus_q3_1, next[6]),
                    ),
                q2_minus_q3_1
                    .mul_add(
                        sin_q2_minus_q3_last,
                        (count_last * q2_minus_q3_last)
                            .mul_add(sin_q2_minus_q3_1, next[7]),
                    ),
                q1_minus_q3_1
                    .mul_add(
                        cos_q1_minus_q3_last,
                        (count_last * q1_minus_q3_last)
                            .mul_add(cos_q1_minus_q3_1, next[8]),
                    ),
                q1_minus_q3_1
                    .mul_add(
                        sin_q1_minus_q3_last,
                        (count_last * q1_minus_q3_last)
                            .mul_add(sin_q1_minus_q3_1, next[9]),
                    ),
                q1_minus_q2_1
                    .mul_add(
                        cos_q1_minus_q2_last,
                        (count_last * q1_minus_q2_last)
                            .mul_add(cos_q1_minus_q2_1, next[10]),
                    ),
                q1_minus_q2_1
                    .mul_add(
                        sin_q1_minus_q2_last,
                        (count_last * q1_minus_q2_last)
                            .mul_add(sin_q1_minus_q2_1, next[11]),
                    ),
                sin_q2_minus_q3_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_last,
                        sin_q2_minus_q3_last.mul_add(u1_dot_of_q1_q2_q3_1, next[12]),
                    ),
                u1_dot_of_q1_q2_q3_2_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_last,
                        u1_dot_of_q1_q2_q3_2_last.mul_add(u1_dot_of_q1_q2_q3_1, next[13]),
                    ),
                sin_q2_minus_q3_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_4_last,
                        sin_q2_minus_q3_last.mul_add(u1_dot_of_q1_q2_q3_4_1, next[14]),
                    ),
                (u1_dot_of_q1_q2_q3_4_1 + u1_dot_of_q1_q2_q3_4_1)
                    .mul_add(u1_dot_of_q1_q2_q3_4_last, next[15]),
                c2_1
                    .mul_add(
                        cos_q1_minus_q2_last,
                        c2_last.mul_add(cos_q1_minus_q2_1, next[16]),
                    ),
                s2_1
                    .mul_add(
                        sin_q1_minus_q2_last,
                        s2_last.mul_add(sin_q1_minus_q2_1, next[17]),
                    ),
                cos_q1_minus_q3_1
                    .mul_add(
                        cos_q1_minus_q2_last,
                        cos_q1_minus_q3_last.mul_add(cos_q1_minus_q2_1, next[18]),
                    ),
                c3_1
                    .mul_add(
                        sin_q1_minus_q2_last,
                        c3_last.mul_add(sin_q1_minus_q2_1, next[19]),
                    ),
                sin_q1_minus_q3_1
                    .mul_add(
                        sin_q1_minus_q2_last,
                        sin_q1_minus_q3_last.mul_add(sin_q1_minus_q2_1, next[20]),
                    ),
                sin_q2_minus_q3_1
                    .mul_add(
                        u1_dot_of_place_4_last,
                        sin_q2_minus_q3_last.mul_add(u1_dot_of_place_4_1, next[21]),
                    ),
                cos_q2_minus_q3_1
                    .mul_add(
                        u1_dot_of_place_5_last,
                        cos_q2_minus_q3_last.mul_add(u1_dot_of_place_5_1, next[22]),
                    ),
                sin_q1_minus_q2_1
                    .mul_add(
                        u1_dot_of_place_7_last,
                        sin_q1_minus_q2_last.mul_add(u1_dot_of_place_7_1, next[23]),
                    ),
                sin_q1_minus_q3_1
                    .mul_add(
                        cos_q2_minus_q3_last,
                        sin_q1_minus_q3_last.mul_add(cos_q2_minus_q3_1, next[24]),
                    ),
                u1_dot_of_q1_q2_q3_6_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_9_last,
                        u1_dot_of_q1_q2_q3_6_last
                            .mul_add(u1_dot_of_q1_q2_q3_9_1, next[25]),
                    ),
                sin_q2_minus_q3_1
                    .mul_add(
                        u1_dot_of_place_10_last,
                        sin_q2_minus_q3_last.mul_add(u1_dot_of_place_10_1, next[26]),
                    ),
                sin_q1_minus_q3_1
                    .mul_add(
                        u1_dot_of_place_11_last,
                        sin_q1_minus_q3_last.mul_add(u1_dot_of_place_11_1, next[27]),
                    ),
                cos_q1_minus_q2_1
                    .mul_add(
                        u1_dot_of_place_2_last,
                        cos_q1_minus_q2_last.mul_add(u1_dot_of_place_2_1, next[28]),
                    ),
                cos_q2_minus_q3_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_5_last,
                        cos_q2_minus_q3_last.mul_add(u1_dot_of_q1_q2_q3_5_1, next[29]),
                    ),
                sin_q1_minus_q2_1
                    .mul_add(
                        u1_dot_of_place_14_last,
                        sin_q1_minus_q2_last.mul_add(u1_dot_of_place_14_1, next[30]),
                    ),
                sin_q2_minus_q3_1
                    .mul_add(
                        u1_dot_of_place_17_last,
                        sin_q2_minus_q3_last.mul_add(u1_dot_of_place_17_1, next[31]),
                    ),
                (u1_1 + u1_1).mul_add(u1_last, next[32]),
                u1_dot_of_place_18_1
                    .mul_add(
                        u1_sq_last,
                        u1_dot_of_place_18_last.mul_add(u1_sq_1, next[33]),
                    ),
                c2_1
                    .mul_add(
                        sin_q1_minus_q3_last,
                        c2_last.mul_add(sin_q1_minus_q3_1, next[34]),
                    ),
                sin_q2_minus_q3_1
                    .mul_add(
                        u1_dot_of_u1_3_last,
                        sin_q2_minus_q3_last.mul_add(u1_dot_of_u1_3_1, next[35]),
                    ),
                u1_dot_of_place_1
                    .mul_add(
                        u1_dot_of_u1_5_last,
                        u1_dot_of_place_last.mul_add(u1_dot_of_u1_5_1, next[36]),
                    ),
                u1_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_last,
                        u1_last.mul_add(u1_dot_of_q1_q2_q3_1, next[37]),
                    ),
                u1_1
                    .mul_add(
                        u1_dot_of_q1_q2_q3_4_last,
                        u1_last.mul_add(u1_dot_of_q1_q2_q3_4_1, next[38]),
                    ),
            ])
        };
        // s1 = sin(q1)
        let s1 = q1.mul_add(c1_0, sums[0] * over_k);
        // c1 = cos(q1)
        let c1 = -q1.mul_add(s1_0, sums[1] * over_k);
        // s2 = sin(q2)
        let s2 = q2.mul_add(c2_0, sums[2] * over_k);
        // c2 = cos(q2)
        let c2 = -q2.mul_add(s2_0, sums[3] * over_k);
        // s3 = sin(q3)
        let s3 = q3.mul_add(c3_0, sums[4] * over_k);
        // c3 = cos(q3)
        let c3 = -q3.mul_add(s3_0, sums[5] * over_k);
        // q2_minus_q3 = q2 - q3
        let q2_minus_q3 = q2 - q3;
        // sin_q2_minus_q3 = sin(q2_minus_q3)
        let sin_q2_minus_q3 = q2_minus_q3.mul_add(cos_q2_minus_q3_0, sums[6] * over_k);
        // cos_q2_minus_q3 = cos(q2_minus_q3)
        let cos_q2_minus_q3 = -q2_minus_q3.mul_add(sin_q2_minus_q3_0, sums[7] * over_k);
        // q1_minus_q3 = q1 - q3
        let q1_minus_q3 = q1 - q3;
        // sin_q1_minus_q3 = sin(q1_minus_q3)
        let sin_q1_minus_q3 = q1_minus_q3.mul_add(cos_q1_minus_q3_0, sums[8] * over_k);
        // cos_q1_minus_q3 = cos(q1_minus_q3)
        let cos_q1_minus_q3 = -q1_minus_q3.mul_add(sin_q1_minus_q3_0, sums[9] * over_k);
        // q1_minus_q2 = q1 - q2
        let q1_minus_q2 = q1 - q2;
        // sin_q1_minus_q2 = sin(q1_minus_q2)
        let sin_q1_minus_q2 = q1_minus_q2.mul_add(cos_q1_minus_q2_0, sums[10] * over_k);
        // cos_q1_minus_q2 = cos(q1_minus_q2)
        let cos_q1_minus_q2 = -q1_minus_q2.mul_add(sin_q1_minus_q2_0, sums[11] * over_k);
        // u1_dot_of_q1_q2_q3 = sin_q1_minus_q3/sin_q2_minus_q3
        let u1_dot_of_q1_q2_q3 = sin_q2_minus_q3
            .mul_add(
                -(u1_dot_of_q1_q2_q3_0 * over_sin_q2_minus_q3),
                (sin_q1_minus_q3 - sums[12]) * over_sin_q2_minus_q3,
            );
        // u1_dot_of_q1_q2_q3_2 = 3*cos_q1_minus_q2 - u1_dot_of_q1_q2_q3
        let u1_dot_of_q1_q2_q3_2 = S::int(3) * cos_q1_minus_q2 - u1_dot_of_q1_q2_q3;
        // u1_dot_of_q1_q2_q3_3 = u1_dot_of_q1_q2_q3_2*u1_dot_of_q1_q2_q3
        let u1_dot_of_q1_q2_q3_3 = u1_dot_of_q1_q2_q3_2
            .mul_add(
                u1_dot_of_q1_q2_q3_0,
                u1_dot_of_q1_q2_q3.mul_add(u1_dot_of_q1_q2_q3_2_0, sums[13]),
            );
        // u1_dot_of_q1_q2_q3_4 = sin_q1_minus_q2/sin_q2_minus_q3
        let u1_dot_of_q1_q2_q3_4 = sin_q2_minus_q3
            .mul_add(
                -(u1_dot_of_q1_q2_q3_4_0 * over_sin_q2_minus_q3),
                (sin_q1_minus_q2 - sums[14]) * over_sin_q2_minus_q3,
            );
        // u1_dot_of_q1_q2_q3_5 = u1_dot_of_q1_q2_q3_4*u1_dot_of_q1_q2_q3_4
        let u1_dot_of_q1_q2_q3_5 = u1_dot_of_q1_q2_q3_4
            .mul_add(u1_dot_of_q1_q2_q3_4_0 + u1_dot_of_q1_q2_q3_4_0, sums[15]);
        // u1_dot_of_place = ma_plus_3_mb + minus_mb*u1_dot_of_q1_q2_q3_3 + mc*u1_dot_of_q1_q2_q3_5
        let u1_dot_of_place = u1_dot_of_q1_q2_q3_3
            .mul_add(minus_mb, mc * u1_dot_of_q1_q2_q3_5);
        // u1_dot_of_q1_q2_q3_6 = 3*cos_q1_minus_q2 - 2*u1_dot_of_q1_q2_q3
        let u1_dot_of_q1_q2_q3_6 = u1_dot_of_q1_q2_q3
            .mul_add(-S::int(2), S::int(3) * cos_q1_minus_q2);
        // c2_cos_q1_minus_q2 = c2*cos_q1_minus_q2
        let c2_cos_q1_minus_q2 = cos_q1_minus_q2
            .mul_add(c2_0, c2.mul_add(cos_q1_minus_q2_0, sums[16]));
        // s2_sin_q1_minus_q2 = s2*sin_q1_minus_q2
        let s2_sin_q1_minus_q2 = sin_q1_minus_q2
            .mul_add(s2_0, s2.mul_add(sin_q1_minus_q2_0, sums[17]));
        // u1_dot_of_q1_q2_q3_7 = cos_q1_minus_q3*cos_q1_minus_q2
        let u1_dot_of_q1_q2_q3_7 = cos_q1_minus_q2
            .mul_add(
                cos_q1_minus_q3_0,
                cos_q1_minus_q3.mul_add(cos_q1_minus_q2_0, sums[18]),
            );
        // u1_dot_of_place_2 = weight + minus_3_a_mb_by_c*cos_q1_minus_q3
        let u1_dot_of_place_2 = minus_3_a_mb_by_c * cos_q1_minus_q3;
        // c3_sin_q1_minus_q2 = c3*sin_q1_minus_q2
        let c3_sin_q1_minus_q2 = sin_q1_minus_q2
            .mul_add(c3_0, c3.mul_add(sin_q1_minus_q2_0, sums[19]));
        // u1_dot_of_q1_q2_q3_8 = sin_q1_minus_q3*sin_q1_minus_q2
        let u1_dot_of_q1_q2_q3_8 = sin_q1_minus_q2
            .mul_add(
                sin_q1_minus_q3_0,
                sin_q1_minus_q3.mul_add(sin_q1_minus_q2_0, sums[20]),
            );
        // u1_dot_of_place_3 = mc_by_b*sin_q1_minus_q2 + minus_mb_by_c*sin_q1_minus_q3
        let u1_dot_of_place_3 = sin_q1_minus_q3
            .mul_add(minus_mb_by_c, mc_by_b * sin_q1_minus_q2);
        // u1_dot_of_place_4 = u1_dot_of_place_3/sin_q2_minus_q3
        let u1_dot_of_place_4 = u1_dot_of_place_3
            .mul_add(
                over_sin_q2_minus_q3,
                -(sin_q2_minus_q3.mul_add(u1_dot_of_place_4_0, sums[21]) * over_sin_q2_minus_q3),
            );
        // u1_dot_of_place_5 = weight_2*cos_q1_minus_q2 + 2*u1_dot_of_place_4
        let u1_dot_of_place_5 = u1_dot_of_place_4
            .mul_add(S::int(2), weight_2 * cos_q1_minus_q2);
        // u1_dot_of_place_6 = cos_q2_minus_q3*u1_dot_of_place_5
        let u1_dot_of_place_6 = u1_dot_of_place_5
            .mul_add(
                cos_q2_minus_q3_0,
                cos_q2_minus_q3.mul_add(u1_dot_of_place_5_0, sums[22]),
            );
        // u1_dot_of_place_7 = weight_3*cos_q1_minus_q2 + weight_4*cos_q1_minus_q3 + u1_dot_of_place_6
        let u1_dot_of_place_7 = cos_q1_minus_q3
            .mul_add(weight_4, weight_3 * cos_q1_minus_q2) + u1_dot_of_place_6;
        // u1_dot_of_place_8 = sin_q1_minus_q2*u1_dot_of_place_7
        let u1_dot_of_place_8 = u1_dot_of_place_7
            .mul_add(
                sin_q1_minus_q2_0,
                sin_q1_minus_q2.mul_add(u1_dot_of_place_7_0, sums[23]),
            );
        // u1_dot_of_q1_q2_q3_9 = sin_q1_minus_q3*cos_q2_minus_q3
        let u1_dot_of_q1_q2_q3_9 = cos_q2_minus_q3
            .mul_add(
                sin_q1_minus_q3_0,
                sin_q1_minus_q3.mul_add(cos_q2_minus_q3_0, sums[24]),
            );
        // u1_dot_of_q1_q2_q3_10 = u1_dot_of_q1_q2_q3_6*u1_dot_of_q1_q2_q3_9
        let u1_dot_of_q1_q2_q3_10 = u1_dot_of_q1_q2_q3_6
            .mul_add(
                u1_dot_of_q1_q2_q3_9_0,
                u1_dot_of_q1_q2_q3_9.mul_add(u1_dot_of_q1_q2_q3_6_0, sums[25]),
            );
        // u1_dot_of_place_9 = u1_dot_of_place_8 + minus_mb_by_b*u1_dot_of_q1_q2_q3_10
        let u1_dot_of_place_9 = minus_mb_by_b * u1_dot_of_q1_q2_q3_10 + u1_dot_of_place_8;
        // u1_dot_of_place_10 = u1_dot_of_place_9/sin_q2_minus_q3
        let u1_dot_of_place_10 = u1_dot_of_place_9
            .mul_add(
                over_sin_q2_minus_q3,
                -(sin_q2_minus_q3.mul_add(u1_dot_of_place_10_0, sums[26]) * over_sin_q2_minus_q3),
            );
        // u1_dot_of_place_11 = weight_5*cos_q1_minus_q3 + a*u1_dot_of_place_10 +
        //   weight_6*u1_dot_of_q1_q2_q3_8
        let u1_dot_of_place_11 = u1_dot_of_place_10
            .mul_add(
                a,
                u1_dot_of_q1_q2_q3_8.mul_add(weight_6, weight_5 * cos_q1_minus_q3),
            );
        // u1_dot_of_place_12 = sin_q1_minus_q3*u1_dot_of_place_11
        let u1_dot_of_place_12 = u1_dot_of_place_11
            .mul_add(
                sin_q1_minus_q3_0,
                sin_q1_minus_q3.mul_add(u1_dot_of_place_11_0, sums[27]),
            );
        // u1_dot_of_place_13 = cos_q1_minus_q2*u1_dot_of_place_2
        let u1_dot_of_place_13 = u1_dot_of_place_2
            .mul_add(
                cos_q1_minus_q2_0,
                cos_q1_minus_q2.mul_add(u1_dot_of_place_2_0, sums[28]),
            );
        // u1_dot_of_q1_q2_q3_11 = cos_q2_minus_q3*u1_dot_of_q1_q2_q3_5
        let u1_dot_of_q1_q2_q3_11 = u1_dot_of_q1_q2_q3_5
            .mul_add(
                cos_q2_minus_q3_0,
                cos_q2_minus_q3.mul_add(u1_dot_of_q1_q2_q3_5_0, sums[29]),
            );
        // u1_dot_of_place_14 = u1_dot_of_place_13 + minus_2_a_mc_by_c*u1_dot_of_q1_q2_q3_11
        let u1_dot_of_place_14 = u1_dot_of_q1_q2_q3_11
            .mul_add(minus_2_a_mc_by_c, u1_dot_of_place_13);
        // u1_dot_of_place_15 = sin_q1_minus_q2*u1_dot_of_place_14
        let u1_dot_of_place_15 = u1_dot_of_place_14
            .mul_add(
                sin_q1_minus_q2_0,
                sin_q1_minus_q2.mul_add(u1_dot_of_place_14_0, sums[30]),
            );
        // u1_dot_of_place_16 = u1_dot_of_place_12 + u1_dot_of_place_15
        let u1_dot_of_place_16 = u1_dot_of_place_15 + u1_dot_of_place_12;
        // u1_dot_of_place_17 = u1_dot_of_place_16/sin_q2_minus_q3
        let u1_dot_of_place_17 = u1_dot_of_place_16
            .mul_add(
                over_sin_q2_minus_q3,
                -(sin_q2_minus_q3.mul_add(u1_dot_of_place_17_0, sums[31]) * over_sin_q2_minus_q3),
            );
        // u1_dot_of_place_18 = weight_7*u1_dot_of_q1_q2_q3_7 + minus_3_mb*u1_dot_of_q1_q2_q3_8 -
        //   u1_dot_of_place_17
        let u1_dot_of_place_18 = u1_dot_of_q1_q2_q3_8
            .mul_add(minus_3_mb, weight_7 * u1_dot_of_q1_q2_q3_7) - u1_dot_of_place_17;
        // u1_sq = u1*u1
        let u1_sq = u1.mul_add(u1_0 + u1_0, sums[32]);
        // u1_dot_of_u1 = u1_dot_of_place_18*u1_sq
        let u1_dot_of_u1 = u1_dot_of_place_18
            .mul_add(u1_sq_0, u1_sq.mul_add(u1_dot_of_place_18_0, sums[33]));
        // c2_sin_q1_minus_q3 = c2*sin_q1_minus_q3
        let c2_sin_q1_minus_q3 = sin_q1_minus_q3
            .mul_add(c2_0, c2.mul_add(sin_q1_minus_q3_0, sums[34]));
        // u1_dot_of_u1_2 = weight_8*c3_sin_q1_minus_q2 + u1_dot_of_u1 + weight_9*c2_sin_q1_minus_q3
        let u1_dot_of_u1_2 = c2_sin_q1_minus_q3
            .mul_add(weight_9, weight_8 * c3_sin_q1_minus_q2) + u1_dot_of_u1;
        // u1_dot_of_u1_3 = u1_dot_of_u1_2/sin_q2_minus_q3
        let u1_dot_of_u1_3 = u1_dot_of_u1_2
            .mul_add(
                over_sin_q2_minus_q3,
                -(sin_q2_minus_q3.mul_add(u1_dot_of_u1_3_0, sums[35]) * over_sin_q2_minus_q3),
            );
        // u1_dot_of_u1_4 = weight_10*c1 + weight_11*c2_cos_q1_minus_q2 +
        //   minus_6_mb_g_by_a*s2_sin_q1_minus_q2 - u1_dot_of_u1_3
        let u1_dot_of_u1_4 = s2_sin_q1_minus_q2
            .mul_add(
                minus_6_mb_g_by_a,
                c2_cos_q1_minus_q2.mul_add(weight_11, weight_10 * c1),
            ) - u1_dot_of_u1_3;
        // u1_dot_of_u1_5 = u1_dot_of_u1_4/u1_dot_of_place
        let u1_dot_of_u1_5 = u1_dot_of_u1_4
            .mul_add(
                over_u1_dot_of_place,
                -(u1_dot_of_place.mul_add(u1_dot_of_u1_5_0, sums[36]) * over_u1_dot_of_place),
            );
        // q2_of_u1 = u1*u1_dot_of_q1_q2_q3
        let q2_of_u1 = u1_dot_of_q1_q2_q3
            .mul_add(u1_0, u1.mul_add(u1_dot_of_q1_q2_q3_0, sums[37]));
        // q3_of_u1 = u1*u1_dot_of_q1_q2_q3_4
        let q3_of_u1 = u1_dot_of_q1_q2_q3_4
            .mul_add(u1_0, u1.mul_add(u1_dot_of_q1_q2_q3_4_0, sums[38]));
        q1_rate = u1;
        q2_rate = minus_a_by_b * q2_of_u1;
        q3_rate = minus_a_by_c * q3_of_u1;
        u1_rate = -S::ratio(1, 2) * u1_dot_of_u1_5;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * q1,
                count * q1,
                count * q2,
                count * q2,
                count * q3,
                count * q3,
                count * q2_minus_q3,
                count * q2_minus_q3,
                count * q1_minus_q3,
                count * q1_minus_q3,
                count * q1_minus_q2,
                count * q1_minus_q2,
                sin_q2_minus_q3, u1_dot_of_q1_q2_q3_2, sin_q2_minus_q3, u1_dot_of_q1_q2_q3_4, c2,
                s2, cos_q1_minus_q3, c3, sin_q1_minus_q3, sin_q2_minus_q3, cos_q2_minus_q3,
                sin_q1_minus_q2, sin_q1_minus_q3, u1_dot_of_q1_q2_q3_6, sin_q2_minus_q3,
                sin_q1_minus_q3, cos_q1_minus_q2, cos_q2_minus_q3, sin_q1_minus_q2, sin_q2_minus_q3,
                u1, u1_dot_of_place_18, c2, sin_q2_minus_q3, u1_dot_of_place, u1, u1,
            ]),
            padded([
                c1, s1, c2, s2, c3, s3, cos_q2_minus_q3, sin_q2_minus_q3, cos_q1_minus_q3,
                sin_q1_minus_q3, cos_q1_minus_q2, sin_q1_minus_q2, u1_dot_of_q1_q2_q3,
                u1_dot_of_q1_q2_q3, u1_dot_of_q1_q2_q3_4, u1_dot_of_q1_q2_q3_4, cos_q1_minus_q2,
                sin_q1_minus_q2, cos_q1_minus_q2, sin_q1_minus_q2, sin_q1_minus_q2,
                u1_dot_of_place_4, u1_dot_of_place_5, u1_dot_of_place_7, cos_q2_minus_q3,
                u1_dot_of_q1_q2_q3_9, u1_dot_of_place_10, u1_dot_of_place_11, u1_dot_of_place_2,
                u1_dot_of_q1_q2_q3_5, u1_dot_of_place_14, u1_dot_of_place_17, u1, u1_sq,
                sin_q1_minus_q3, u1_dot_of_u1_3, u1_dot_of_u1_5, u1_dot_of_q1_q2_q3,
                u1_dot_of_q1_q2_q3_4,
            ]),
        ];
        count_last = count;
        q1_last = q1;
        q2_last = q2;
        q3_last = q3;
        u1_last = u1;
        s1_last = s1;
        c1_last = c1;
        s2_last = s2;
        c2_last = c2;
        s3_last = s3;
        c3_last = c3;
        q2_minus_q3_last = q2_minus_q3;
        sin_q2_minus_q3_last = sin_q2_minus_q3;
        cos_q2_minus_q3_last = cos_q2_minus_q3;
        q1_minus_q3_last = q1_minus_q3;
        sin_q1_minus_q3_last = sin_q1_minus_q3;
        cos_q1_minus_q3_last = cos_q1_minus_q3;
        q1_minus_q2_last = q1_minus_q2;
        sin_q1_minus_q2_last = sin_q1_minus_q2;
        cos_q1_minus_q2_last = cos_q1_minus_q2;
        u1_dot_of_q1_q2_q3_last = u1_dot_of_q1_q2_q3;
        u1_dot_of_q1_q2_q3_2_last = u1_dot_of_q1_q2_q3_2;
        u1_dot_of_q1_q2_q3_4_last = u1_dot_of_q1_q2_q3_4;
        u1_dot_of_q1_q2_q3_5_last = u1_dot_of_q1_q2_q3_5;
        u1_dot_of_place_last = u1_dot_of_place;
        u1_dot_of_q1_q2_q3_6_last = u1_dot_of_q1_q2_q3_6;
        u1_dot_of_place_2_last = u1_dot_of_place_2;
        u1_dot_of_place_4_last = u1_dot_of_place_4;
        u1_dot_of_place_5_last = u1_dot_of_place_5;
        u1_dot_of_place_7_last = u1_dot_of_place_7;
        u1_dot_of_q1_q2_q3_9_last = u1_dot_of_q1_q2_q3_9;
        u1_dot_of_place_10_last = u1_dot_of_place_10;
        u1_dot_of_place_11_last = u1_dot_of_place_11;
        u1_dot_of_place_14_last = u1_dot_of_place_14;
        u1_dot_of_place_17_last = u1_dot_of_place_17;
        u1_dot_of_place_18_last = u1_dot_of_place_18;
        u1_sq_last = u1_sq;
        u1_dot_of_u1_3_last = u1_dot_of_u1_3;
        u1_dot_of_u1_5_last = u1_dot_of_u1_5;
    }
}

/// Newton–Euler equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEuler;

impl<S: Scalar> System<S> for NewtonEuler {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 8,
            coordinates: 3,
            variables: 1,
            speeds: 1,
            reactions: 8,
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
        80 * order + SLACK
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
    slice.try_into().expect("a slice of the length that System states")
}
