//! Three-link pendulum on a cart: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/cart_pendulum_3/model.toml`. Do not edit; run `tripos regenerate`.
//! 4 coordinates, 4 speeds, 9 parameters. Unknowns: (u0', u1', u2', u3').
//! Cost: mass_matrix 33 operations, 6 sines and cosines; forcing 66 operations, 6 sines and cosines.
//! The kinematic equations are singular nowhere.

use super::Parameters;
use tripos_traits::{Scalar, System};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u0, u1, u2, u3.
///
/// 33 operations, 6 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    _u: &[S; 4],
) -> [[S; 4]; 4] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, .. } = *p;
    let [_, q1, q2, q3] = *q;
    // Sines and cosines.
    let (_, c1) = q1.sin_cos();
    let (_, c2) = q2.sin_cos();
    let (_, c3) = q3.sin_cos();
    // Shared terms.
    // m1 + m2 + m3; used 2 times
    let m12_part = m1 + m2 + m3;
    // m2 + m3; used 3 times
    let m2_plus_m3 = m2 + m3;
    // Sines and cosines.
    let (_, cos_q1_minus_q2) = (q1 - q2).sin_cos();
    let (_, cos_q1_minus_q3) = (q1 - q3).sin_cos();
    let (_, cos_q2_minus_q3) = (q2 - q3).sin_cos();
    // Entries that are not zero; upper triangle.
    // M11 = m0 + m1 + m2 + m3
    let m11 = m0 + m1 + m2 + m3;
    // M12 = -l0*cos(q1)*(m1 + m2 + m3)
    let m12 = -l0 * c1 * m12_part;
    // M13 = -l1*cos(q2)*(m2 + m3)
    let m13 = -l1 * c2 * m2_plus_m3;
    // M14 = -m3*l2*cos(q3)
    let m14 = -m3 * l2 * c3;
    // M22 = l0^2*(m1 + m2 + m3)
    let m22 = l0 * l0 * m12_part;
    // M23 = l0*l1*cos(q1 - q2)*(m2 + m3)
    let m23 = l0 * l1 * cos_q1_minus_q2 * m2_plus_m3;
    // M24 = m3*l0*l2*cos(q1 - q3)
    let m24 = m3 * l0 * l2 * cos_q1_minus_q3;
    // M33 = l1^2*(m2 + m3)
    let m33 = l1 * l1 * m2_plus_m3;
    // M34 = m3*l1*l2*cos(q2 - q3)
    let m34 = m3 * l1 * l2 * cos_q2_minus_q3;
    // M44 = m3*l2^2
    let m44 = m3 * l2 * l2;
    [
        [m11, m12, m13, m14],
        [m12, m22, m23, m24],
        [m13, m23, m33, m34],
        [m14, m24, m34, m44],
    ]
}

/// Right-hand side of the linear system; unknowns (u0', u1', u2', u3').
///
/// 66 operations, 6 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [S; 4] {
    let Parameters { m1, m2, m3, l0, l1, l2, g, F, .. } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, u1, u2, u3] = *u;
    // Sines and cosines.
    let (s1, _) = q1.sin_cos();
    let (s2, _) = q2.sin_cos();
    let (s3, _) = q3.sin_cos();
    let (sin_q1_minus_q2, _) = (q1 - q2).sin_cos();
    let (sin_q1_minus_q3, _) = (q1 - q3).sin_cos();
    let (sin_q2_minus_q3, _) = (q2 - q3).sin_cos();
    // Shared terms.
    // l0*u1^2*sin(q1); used 2 times
    let l0_u1_sq_s1 = l0 * u1 * u1 * s1;
    // l1*u2^2*sin(q2); used 2 times
    let l1_u2_sq_s2 = l1 * u2 * u2 * s2;
    // l1*u2^2*sin(q1 - q2); used 2 times
    let f2_part = l1 * u2 * u2 * sin_q1_minus_q2;
    // g*sin(q1); used 2 times
    let g_s1 = g * s1;
    // g*sin(q2); used 2 times
    let g_s2 = g * s2;
    // l0*u1^2*sin(q1 - q2); used 2 times
    let f3_part = l0 * u1 * u1 * sin_q1_minus_q2;
    // Values.
    // f1 = F - m1*l0*u1^2*sin(q1) - m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2)) - m3*(l0*u1^2*sin(q1) +
    //   l1*u2^2*sin(q2) + l2*u3^2*sin(q3))
    let f1 = F - m1 * l0 * u1 * u1 * s1 - m2 * (l0_u1_sq_s1 + l1_u2_sq_s2)
        - m3 * (l0_u1_sq_s1 + l1_u2_sq_s2 + l2 * u3 * u3 * s3);
    // f2 = l0*(m1*g*sin(q1) + m2*(g*sin(q1) - l1*u2^2*sin(q1 - q2)) + m3*(g*sin(q1) - l1*u2^2*sin(q1 - q2)
    //   - l2*u3^2*sin(q1 - q3)))
    let f2 = l0
        * (m1 * g * s1 + m2 * (g_s1 - f2_part)
            + m3 * (g_s1 - f2_part - l2 * u3 * u3 * sin_q1_minus_q3));
    // f3 = l1*(m2*(g*sin(q2) + l0*u1^2*sin(q1 - q2)) + m3*(g*sin(q2) + l0*u1^2*sin(q1 - q2) -
    //   l2*u3^2*sin(q2 - q3)))
    let f3 = l1
        * (m2 * (g_s2 + f3_part)
            + m3 * (g_s2 + f3_part - l2 * u3 * u3 * sin_q2_minus_q3));
    // f4 = m3*l2*(g*sin(q3) + l0*u1^2*sin(q1 - q3) + l1*u2^2*sin(q2 - q3))
    let f4 = m3 * l2
        * (g * s3 + l0 * u1 * u1 * sin_q1_minus_q3 + l1 * u2 * u2 * sin_q2_minus_q3);
    [f1, f2, f3, f4]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 4],
    u: &[S; 4],
) -> [S; 4] {
    let [u0, u1, u2, u3] = *u;
    // Values.
    // q0' = u0
    let q0_dot_value = u0;
    // q1' = u1
    let q1_dot_value = u1;
    // q2' = u2
    let q2_dot_value = u2;
    // q3' = u3
    let q3_dot_value = u3;
    [q0_dot_value, q1_dot_value, q2_dot_value, q3_dot_value]
}

/// Kinetic energy T.
///
/// 63 operations, 6 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> S {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, .. } = *p;
    let [_, q1, q2, q3] = *q;
    let [u0, u1, u2, u3] = *u;
    // Sines and cosines.
    let (_, c1) = q1.sin_cos();
    let (_, c2) = q2.sin_cos();
    let (_, c3) = q3.sin_cos();
    // Shared terms.
    // m1 + m2 + m3; used 2 times
    let energy_part = m1 + m2 + m3;
    // m2 + m3; used 3 times
    let m2_plus_m3 = m2 + m3;
    // Sines and cosines.
    let (_, cos_q1_minus_q2) = (q1 - q2).sin_cos();
    let (_, cos_q1_minus_q3) = (q1 - q3).sin_cos();
    let (_, cos_q2_minus_q3) = (q2 - q3).sin_cos();
    // Values.
    // T = u0^2*(m0 + m1 + m2 + m3)/2 + l0^2*u1^2*(m1 + m2 + m3)/2 - l0*u0*u1*cos(q1)*(m1 + m2 + m3) +
    //   l1^2*u2^2*(m2 + m3)/2 - l1*u0*u2*cos(q2)*(m2 + m3) + l0*l1*u1*u2*cos(q1 - q2)*(m2 + m3) +
    //   m3*l2^2*u3^2/2 - m3*l2*u0*u3*cos(q3) + m3*l0*l2*u1*u3*cos(q1 - q3) + m3*l1*l2*u2*u3*cos(q2 - q3)
    let energy = S::ratio(1, 2) * u0 * u0 * (m0 + m1 + m2 + m3)
        + S::ratio(1, 2) * l0 * l0 * u1 * u1 * energy_part
        - l0 * u0 * u1 * c1 * energy_part
        + S::ratio(1, 2) * l1 * l1 * u2 * u2 * m2_plus_m3
        - l1 * u0 * u2 * c2 * m2_plus_m3
        + l0 * l1 * u1 * u2 * cos_q1_minus_q2 * m2_plus_m3
        + S::ratio(1, 2) * m3 * l2 * l2 * u3 * u3 - m3 * l2 * u0 * u3 * c3
        + m3 * l0 * l2 * u1 * u3 * cos_q1_minus_q3
        + m3 * l1 * l2 * u2 * u3 * cos_q2_minus_q3;
    energy
}

/// Potential energy V of gravity.
///
/// 13 operations, 3 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 4]) -> S {
    let Parameters { m1, m2, m3, l0, l1, l2, g, .. } = *p;
    let [_, q1, q2, q3] = *q;
    // Sines and cosines.
    let (_, c1) = q1.sin_cos();
    let (_, c2) = q2.sin_cos();
    let (_, c3) = q3.sin_cos();
    // Shared terms.
    // l0*cos(q1); used 2 times
    let l0_c1 = l0 * c1;
    // l1*cos(q2); used 2 times
    let l1_c2 = l1 * c2;
    // Values.
    // V = g*(m1*l0*cos(q1) + m2*(l0*cos(q1) + l1*cos(q2)) + m3*(l0*cos(q1) + l1*cos(q2) + l2*cos(q3)))
    let energy = g
        * (m1 * l0 * c1 + m2 * (l0_c1 + l1_c2) + m3 * (l0_c1 + l1_c2 + l2 * c3));
    energy
}

/// Kane's method of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Kane;

impl<S: Scalar> System<S> for Kane {
    fn parameters(&self) -> usize {
        9
    }
    fn coordinates(&self) -> usize {
        4
    }
    fn speeds(&self) -> usize {
        4
    }
    fn reactions(&self) -> usize {
        0
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

fn array<S, const N: usize>(slice: &[S]) -> &[S; N] {
    slice.try_into().expect("a slice of the length that System states")
}
