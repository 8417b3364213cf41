//! Four-bar linkage: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/four_bar/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{
    constraint_slopes, constraints, coordinate_rates, divisors, kinetic_energy,
    potential_energy,
};

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

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
