//! Thin disk sliding on a frictionless plane: Newton–Euler equations as printed (listing-5.6), M(q) u' = f(q, u).
//!
//! Generated from `models/disk/publication.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::printed_kane_final::{coordinate_rates, kinetic_energy};

pub use super::kane::potential_energy;

use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system M(q) u' = f(q, u); rows row 1, row 2, row 3, row 4, row 5.
///
/// 0 operations.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 5],
    _u: &[S; 5],
) -> [[S; 5]; 5] {
    // Entries that are not zero.
    // M11 = 1
    let m11 = S::int(1);
    // M22 = 1
    let m22 = S::int(1);
    // M33 = 1
    let m33 = S::int(1);
    // M44 = 1
    let m44 = S::int(1);
    // M55 = 1
    let m55 = S::int(1);
    let zero = S::int(0);
    [
        [m11, zero, zero, zero, zero],
        [zero, m22, zero, zero, zero],
        [zero, zero, m33, zero, zero],
        [zero, zero, zero, m44, zero],
        [zero, zero, zero, zero, m55],
    ]
}

/// Right-hand side of the linear system; unknowns (u1', u2', u3', u4', u5').
///
/// 191 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> [S; 5] {
    let Parameters { R, g, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let [u1, u2, u3, _, _] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    // 5*sin(q2)^2 + cos(q2)^2
    let c2_sq_plus_s2_sq_times_5 = c2.mul_add(c2, S::int(5) * s2 * s2);
    let t2 = s2 / c2;
    // Values.
    // f1 = (4*R*u1^2*sin(q2)*cos(q2) - 4*g*sin(q2)^3 - 4*g*sin(q2)*cos(q2)^2 + 2*R*u2^2*sin(q2)*cos(q2) +
    //   2*R*u2^2*sin(q2)^2*tan(q2) - 3*R*u2*u3*sin(q2)^2 - 3*R*u2*u3*cos(q2)^2)/(R*(5*sin(q2)^2 +
    //   cos(q2)^2))
    let f1 = (S::int(4) * R * u1 * u1 * s2 * c2 - S::int(4) * g * s2 * s2 * s2
        - S::int(4) * g * s2 * c2 * c2 + S::int(2) * R * u2 * u2 * s2 * c2
        + S::int(2) * R * u2 * u2 * s2 * s2 * t2 - S::int(3) * R * u2 * u3 * s2 * s2
        - S::int(3) * R * u2 * u3 * c2 * c2) / (R * c2_sq_plus_s2_sq_times_5);
    // f2 = 3*u1*u3 - 2*u1*u2*tan(q2)
    let f2 = (-(u1 * u2 * t2)).mul_add(S::int(2), S::int(3) * u1 * u3);
    // f4 = (4*g*sin(q1)*sin(q2)*cos(q2) - 5*R*u1^2*sin(q1)*sin(q2) - 3*R*u2^2*sin(q1)*sin(q2) -
    //   5*R*u2^2*sin(q1)*sin(q2)*tan(q2)^2 - 13*R*u1*u2*cos(q1)*sin(q2)^2 - 2*R*u1*u2*cos(q1)*cos(q2)^2 -
    //   15*R*u1*u2*cos(q1)*sin(q2)^2*tan(q2)^2 + 3*R*u1*u3*cos(q1)*sin(q2)*cos(q2) +
    //   15*R*u1*u3*cos(q1)*sin(q2)^2*tan(q2) + 3*R*u2*u3*sin(q1)*cos(q2))/(5*sin(q2)^2 + cos(q2)^2)
    let f4 = ((g * s1 * s2 * c2).mul_add(S::int(4), -S::int(5) * R * u1 * u1 * s1 * s2)
        - S::int(3) * R * u2 * u2 * s1 * s2 - S::int(5) * R * u2 * u2 * s1 * s2 * t2 * t2
        - S::int(13) * R * u1 * u2 * c1 * s2 * s2 - S::int(2) * R * u1 * u2 * c1 * c2 * c2
        - S::int(15) * R * u1 * u2 * c1 * s2 * s2 * t2 * t2 + S::int(3) * R * u1 * u3 * c1 * s2 * c2
        + S::int(15) * R * u1 * u3 * c1 * s2 * s2 * t2
        + S::int(3) * R * u2 * u3 * s1 * c2) / c2_sq_plus_s2_sq_times_5;
    // f5 = (5*R*u1^2*cos(q1)*sin(q2) - 4*g*cos(q1)*sin(q2)*cos(q2) + 3*R*u2^2*cos(q1)*sin(q2) +
    //   5*R*u2^2*cos(q1)*sin(q2)*tan(q2)^2 - 13*R*u1*u2*sin(q1)*sin(q2)^2 - 2*R*u1*u2*sin(q1)*cos(q2)^2 -
    //   15*R*u1*u2*sin(q1)*sin(q2)^2*tan(q2)^2 + 3*R*u1*u3*sin(q1)*sin(q2)*cos(q2) +
    //   15*R*u1*u3*sin(q1)*sin(q2)^2*tan(q2) - 3*R*u2*u3*cos(q1)*cos(q2))/(5*sin(q2)^2 + cos(q2)^2)
    let f5 = ((-(g * c1 * s2 * c2)).mul_add(S::int(4), S::int(5) * R * u1 * u1 * c1 * s2)
        + S::int(3) * R * u2 * u2 * c1 * s2 + S::int(5) * R * u2 * u2 * c1 * s2 * t2 * t2
        - S::int(13) * R * u1 * u2 * s1 * s2 * s2 - S::int(2) * R * u1 * u2 * s1 * c2 * c2
        - S::int(15) * R * u1 * u2 * s1 * s2 * s2 * t2 * t2 + S::int(3) * R * u1 * u3 * s1 * s2 * c2
        + S::int(15) * R * u1 * u3 * s1 * s2 * s2 * t2
        - S::int(3) * R * u2 * u3 * c1 * c2) / c2_sq_plus_s2_sq_times_5;
    let zero = S::int(0);
    [f1, f2, zero, f4, f5]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 4 operations, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 5], _u: &[S; 5]) -> [S; 2] {
    let [_, q2, _, _, _] = *q;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Values.
    // divisor1 = cos(q2)
    let divisor1 = c2;
    // divisor2 = 5*sin(q2)^2 + cos(q2)^2
    let divisor2 = c2.mul_add(c2, S::int(5) * s2 * s2);
    [divisor1, divisor2]
}

/// Newton–Euler equations as printed (listing-5.6) of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct PrintedListing56;

impl<S: Scalar> System<S> for PrintedListing56 {
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
        2
    }
    fn divisor_name(&self, at: usize) -> &str {
        ["cos(q2)", "5*sin(q2)^2 + cos(q2)^2"][at]
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
