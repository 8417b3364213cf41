//! Thin disk sliding on a frictionless plane: Kane's method as printed (kane-final), M(q) u' = f(q, u).
//!
//! Generated from `models/disk/publication.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::{divisors, potential_energy};

use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system M(q) u' = f(q, u); rows row 1, row 2, row 3, row 4, row 5.
///
/// 27 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 5],
) -> [[S; 5]; 5] {
    let Parameters { R, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let t2 = s2 / c2;
    // Entries that are not zero.
    // M11 = 5*R
    let m11 = S::int(5) * R;
    // M14 = 4*sin(q1)*cos(q2)
    let m14 = S::int(4) * s1 * c2;
    // M15 = -4*cos(q1)*cos(q2)
    let m15 = -S::int(4) * c1 * c2;
    // M22 = R*(1 + 4*tan(q2)^2)
    let m22 = R * (S::int(1) + S::int(4) * t2 * t2);
    // M24 = -4*cos(q1)*tan(q2)
    let m24 = -S::int(4) * c1 * t2;
    // M25 = -4*sin(q1)*tan(q2)
    let m25 = -S::int(4) * s1 * t2;
    // M33 = 1
    let m33 = S::int(1);
    // M41 = R*sin(q1)*cos(q2)
    let m41 = R * s1 * c2;
    // M42 = -R*cos(q1)*tan(q2)
    let m42 = -R * c1 * t2;
    // M44 = 1
    let m44 = S::int(1);
    // M51 = R*cos(q1)*cos(q2)
    let m51 = R * c1 * c2;
    // M52 = R*sin(q1)*tan(q2)
    let m52 = R * s1 * t2;
    // M55 = -1
    let m55 = -S::int(1);
    let zero = S::int(0);
    [
        [m11, zero, zero, m14, m15],
        [zero, m22, zero, m24, m25],
        [zero, zero, m33, zero, zero],
        [m41, m42, zero, m44, zero],
        [m51, m52, zero, zero, m55],
    ]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5').
///
/// 57 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> [S; 5] {
    let Parameters { R, g, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let [u1, u2, u3, _, _] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let t2 = s2 / c2;
    let c2_inv2_s2_sq = t2 * t2;
    // 2 + tan(q2)^2
    let f4_of_q2 = S::int(2) + c2_inv2_s2_sq;
    // 1 + tan(q2)^2
    let f4_of_q2_2 = S::int(1) + c2_inv2_s2_sq;
    // Values.
    // f1 = -4*g*sin(q2) - R*u2^2*tan(q2) - 3*R*u2*u3
    let f1 = (-(g * s2)).mul_add(S::int(4), -R * u2 * u2 * t2) - S::int(3) * R * u2 * u3;
    // f2 = 2*R*u1*u2*tan(q2)*(3 + 2*tan(q2)^2) + 3*R*u1*u3
    let f2 = S::int(2) * R * u1 * u2 * t2 * c2_inv2_s2_sq.mul_add(S::int(2), S::int(3))
        + S::int(3) * R * u1 * u3;
    // f4 = -R*u1^2*sin(q1)*sin(q2) - R*u2^2*sin(q1)*sin(q2)*(1 + tan(q2)^2) - R*u1*u2*cos(q1)*(2 +
    //   tan(q2)^2)
    let f4 = (-(R * u1 * u2 * c1))
        .mul_add(f4_of_q2, -R * u1 * u1 * s1 * s2 - R * u2 * u2 * s1 * s2 * f4_of_q2_2);
    // f5 = R*u1*u2*sin(q1)*(2 + tan(q2)^2) - R*u1^2*cos(q1)*sin(q2) - R*u2^2*cos(q1)*sin(q2)*(1 +
    //   tan(q2)^2)
    let f5 = (R * u1 * u2 * s1).mul_add(f4_of_q2, -R * u1 * u1 * c1 * s2)
        - R * u2 * u2 * c1 * s2 * f4_of_q2_2;
    let zero = S::int(0);
    [f1, f2, zero, f4, f5]
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
    let [_, q2, _, _, _] = *q;
    let [u1, u2, u3, u4, u5] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    let t2 = s2 / c2;
    // Values.
    // q1' = u2/cos(q2)
    let q1_dot_value = u2 / c2;
    // q2' = -u1
    let q2_dot_value = -u1;
    // q3' = u3 - u2*tan(q2)
    let q3_dot_value = (-u2).mul_add(t2, u3);
    // q4' = u4
    let q4_dot_value = u4;
    // q5' = u5
    let q5_dot_value = u5;
    [q1_dot_value, q2_dot_value, q3_dot_value, q4_dot_value, q5_dot_value]
}

/// Kinetic energy T.
///
/// 54 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> S {
    let Parameters { M, R, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let [u1, u2, u3, u4, u5] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let t2 = s2 / c2;
    // Values.
    // T = 5*M*R^2*u1^2/8 + M*R^2*u2^2*(1 + 4*tan(q2)^2)/8 + M*R^2*u3^2/4 + M*u4^2/2 +
    //   M*R*u1*u4*sin(q1)*cos(q2) - M*R*u2*u4*cos(q1)*tan(q2) + M*u5^2/2 - M*R*u1*u5*cos(q1)*cos(q2) -
    //   M*R*u2*u5*sin(q1)*tan(q2)
    let energy = S::ratio(5, 8) * M * R * R * u1 * u1
        + S::ratio(1, 8) * M * R * R * u2 * u2 * (S::int(1) + S::int(4) * t2 * t2)
        + S::ratio(1, 4) * M * R * R * u3 * u3 + S::ratio(1, 2) * M * u4 * u4
        + M * R * u1 * u4 * s1 * c2 - M * R * u2 * u4 * c1 * t2
        + S::ratio(1, 2) * M * u5 * u5 - M * R * u1 * u5 * c1 * c2 - M * R * u2 * u5 * s1 * t2;
    energy
}

/// Kane's method as printed (kane-final) of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct PrintedKaneFinal;

impl<S: Scalar> System<S> for PrintedKaneFinal {
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
