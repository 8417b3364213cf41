//! Thin disk sliding on a frictionless plane: Kane's method as printed (listing-5.4), M(q) u' = f(q, u).
//!
//! Generated from `models/disk/publication.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::printed_kane_final::{coordinate_rates, kinetic_energy, mass_matrix};

pub use super::kane::{divisors, potential_energy};

use tripos_traits::{Lengths, Scalar, System};

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
    // f5 = R*u1*u2*sin(q1)*(2 + tan(q2)^2) - R*u1^2*cos(q1)*sin(q2) - 2*R*u2*cos(q1)*sin(q2)*(1 +
    //   tan(q2)^2)
    let f5 = (R * u1 * u2 * s1).mul_add(f4_of_q2, -R * u1 * u1 * c1 * s2)
        - S::int(2) * R * u2 * c1 * s2 * f4_of_q2_2;
    let zero = S::int(0);
    [f1, f2, zero, f4, f5]
}

/// Kane's method as printed (listing-5.4) of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct PrintedListing54;

impl<S: Scalar> System<S> for PrintedListing54 {
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
