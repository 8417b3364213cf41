//! Three-link pendulum on a cart: Newton–Euler equations, A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/cart_pendulum_3/model.toml`. Do not edit; run `tripos regenerate`.
//! 4 coordinates, 4 speeds, 9 parameters, 4 reactions. Unknowns: (u0', u1', u2', u3', rail, T1, T2, T3).
//! Cost: mass_matrix 43 operations, 3 sines and cosines; forcing 41 operations, 3 sines and cosines.
//! The kinematic equations are singular nowhere.

use super::Parameters;
use tripos_traits::{Scalar, System};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows cart force n1, cart force n2, bob1 force n1, bob1 force n2, bob2 force n1, bob2 force n2, bob3 force n1, bob3 force n2.
///
/// 43 operations, 3 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 4],
    _u: &[S; 4],
) -> [[S; 8]; 8] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, .. } = *p;
    let [_, q1, q2, q3] = *q;
    let zero = S::int(0);
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Entries that are not zero.
    // M11 = m0
    let m11 = m0;
    // M16 = -sin(q1)
    let m16 = -s1;
    // M25 = -1
    let m25 = -S::int(1);
    // M26 = cos(q1)
    let m26 = c1;
    // M31 = m1
    let m31 = m1;
    // M32 = -m1*l0*cos(q1)
    let m32 = -m1 * l0 * c1;
    // M36 = sin(q1)
    let m36 = s1;
    // M37 = -sin(q2)
    let m37 = -s2;
    // M42 = -m1*l0*sin(q1)
    let m42 = -m1 * l0 * s1;
    // M46 = -cos(q1)
    let m46 = -c1;
    // M47 = cos(q2)
    let m47 = c2;
    // M51 = m2
    let m51 = m2;
    // M52 = -m2*l0*cos(q1)
    let m52 = -m2 * l0 * c1;
    // M53 = -m2*l1*cos(q2)
    let m53 = -m2 * l1 * c2;
    // M57 = sin(q2)
    let m57 = s2;
    // M58 = -sin(q3)
    let m58 = -s3;
    // M62 = -m2*l0*sin(q1)
    let m62 = -m2 * l0 * s1;
    // M63 = -m2*l1*sin(q2)
    let m63 = -m2 * l1 * s2;
    // M67 = -cos(q2)
    let m67 = -c2;
    // M68 = cos(q3)
    let m68 = c3;
    // M71 = m3
    let m71 = m3;
    // M72 = -m3*l0*cos(q1)
    let m72 = -m3 * l0 * c1;
    // M73 = -m3*l1*cos(q2)
    let m73 = -m3 * l1 * c2;
    // M74 = -m3*l2*cos(q3)
    let m74 = -m3 * l2 * c3;
    // M78 = sin(q3)
    let m78 = s3;
    // M82 = -m3*l0*sin(q1)
    let m82 = -m3 * l0 * s1;
    // M83 = -m3*l1*sin(q2)
    let m83 = -m3 * l1 * s2;
    // M84 = -m3*l2*sin(q3)
    let m84 = -m3 * l2 * s3;
    // M88 = -cos(q3)
    let m88 = -c3;
    [
        [m11, zero, zero, zero, zero, m16, zero, zero],
        [zero, zero, zero, zero, m25, m26, zero, zero],
        [m31, m32, zero, zero, zero, m36, m37, zero],
        [zero, m42, zero, zero, zero, m46, m47, zero],
        [m51, m52, m53, zero, zero, zero, m57, m58],
        [zero, m62, m63, zero, zero, zero, m67, m68],
        [m71, m72, m73, m74, zero, zero, zero, m78],
        [zero, m82, m83, m84, zero, zero, zero, m88],
    ]
}

/// Right-hand side of the linear system; unknowns (u0', u1', u2', u3', rail, T1, T2, T3).
///
/// 41 operations, 3 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 4], u: &[S; 4]) -> [S; 8] {
    let Parameters { m0, m1, m2, m3, l0, l1, l2, g, F } = *p;
    let [_, q1, q2, q3] = *q;
    let [_, u1, u2, u3] = *u;
    // Sines and cosines.
    let (s1, c1) = q1.sin_cos();
    let (s2, c2) = q2.sin_cos();
    let (s3, c3) = q3.sin_cos();
    // Shared terms.
    // l0*u1^2*cos(q1); used 3 times
    let l0_u1_sq_c1 = l0 * u1 * u1 * c1;
    // l0*u1^2*sin(q1); used 2 times
    let l0_u1_sq_s1 = l0 * u1 * u1 * s1;
    // l1*u2^2*sin(q2); used 2 times
    let l1_u2_sq_s2 = l1 * u2 * u2 * s2;
    // l1*u2^2*cos(q2); used 2 times
    let l1_u2_sq_c2 = l1 * u2 * u2 * c2;
    // Values.
    // f1 = F
    let f1 = F;
    // f2 = -m0*g
    let f2 = -m0 * g;
    // f3 = -m1*l0*u1^2*sin(q1)
    let f3 = -m1 * l0 * u1 * u1 * s1;
    // f4 = m1*(l0*u1^2*cos(q1) - g)
    let f4 = m1 * (l0_u1_sq_c1 - g);
    // f5 = -m2*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2))
    let f5 = -m2 * (l0_u1_sq_s1 + l1_u2_sq_s2);
    // f6 = m2*(l0*u1^2*cos(q1) - g + l1*u2^2*cos(q2))
    let f6 = m2 * (l0_u1_sq_c1 - g + l1_u2_sq_c2);
    // f7 = -m3*(l0*u1^2*sin(q1) + l1*u2^2*sin(q2) + l2*u3^2*sin(q3))
    let f7 = -m3 * (l0_u1_sq_s1 + l1_u2_sq_s2 + l2 * u3 * u3 * s3);
    // f8 = m3*(l0*u1^2*cos(q1) - g + l1*u2^2*cos(q2) + l2*u3^2*cos(q3))
    let f8 = m3 * (l0_u1_sq_c1 - g + l1_u2_sq_c2 + l2 * u3 * u3 * c3);
    [f1, f2, f3, f4, f5, f6, f7, f8]
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
    let (_, cos_q1_minus_q2) = (q1 - q2).sin_cos();
    let (_, cos_q1_minus_q3) = (q1 - q3).sin_cos();
    let (_, cos_q2_minus_q3) = (q2 - q3).sin_cos();
    // Shared terms.
    // m1 + m2 + m3; used 2 times
    let energy_part = m1 + m2 + m3;
    // m2 + m3; used 3 times
    let m2_plus_m3 = m2 + m3;
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

/// Newton–Euler equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct NewtonEuler;

impl<S: Scalar> System<S> for NewtonEuler {
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
        4
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
