//! Thin disk sliding on a frictionless plane: Newton–Euler equations as printed (newton-euler-final), A(q, u) (u', reactions) = b(q, u).
//!
//! Generated from `models/disk/publication.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::printed_kane_final::{coordinate_rates, kinetic_energy};

pub use super::kane::{divisors, potential_energy};

use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system A(q, u) (u', reactions) = b(q, u); rows row 1, row 2, row 3, row 4, row 5, row 6.
///
/// 23 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _u: &[S; 5],
) -> [[S; 6]; 6] {
    let Parameters { M, R, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Shared terms.
    let t2 = s2 / c2;
    // Entries that are not zero.
    // M12 = -M*R*tan(q2)
    let m12 = -M * R * t2;
    // M14 = M*cos(q1)
    let m14 = M * c1;
    // M15 = M*sin(q1)
    let m15 = M * s1;
    // M24 = -M*sin(q1)*sin(q2)
    let m24 = -M * s1 * s2;
    // M25 = M*cos(q1)*sin(q2)
    let m25 = M * c1 * s2;
    // M26 = -cos(q2)
    let m26 = -c2;
    // M31 = M*R
    let m31 = M * R;
    // M34 = M*sin(q1)*cos(q2)
    let m34 = M * s1 * c2;
    // M35 = -M*cos(q1)*cos(q2)
    let m35 = -M * c1 * c2;
    // M36 = -sin(q2)
    let m36 = -s2;
    // M41 = M*R^2
    let m41 = M * R * R;
    // M46 = 4*R*sin(q2)
    let m46 = S::int(4) * R * s2;
    // M52 = 1
    let m52 = S::int(1);
    // M63 = 1
    let m63 = S::int(1);
    let zero = S::int(0);
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
/// 52 operations, 1 sine and cosine.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], u: &[S; 5]) -> [S; 6] {
    let Parameters { M, R, g } = *p;
    let [_, q2, _, _, _] = *q;
    let [u1, u2, u3, _, _] = *u;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Shared terms.
    let t2 = s2 / c2;
    // Values.
    // f1 = -M*R*u1*u2*(2 + tan(q2)^2)
    let f1 = -M * R * u1 * u2 * t2.mul_add(t2, S::int(2));
    // f2 = M*R*u1^2 - M*g*cos(q2) + M*R*u2^2*tan(q2)^2
    let f2 = (-(M * g)).mul_add(c2, M * R * u1 * u1) + M * R * u2 * u2 * t2 * t2;
    // f3 = -M*g*sin(q2) - M*R*u2^2*tan(q2)
    let f3 = (-(M * g)).mul_add(s2, -M * R * u2 * u2 * t2);
    // f4 = M*R^2*u2^2*tan(q2) - 2*M*R^2*u2*u3 + M*R^2*u2*(u2*tan(q2) - u3)
    let f4 = M * R * R * u2 * u2 * t2 - S::int(2) * M * R * R * u2 * u3
        + M * R * R * u2 * u2.mul_add(t2, -u3);
    // f5 = 3*u1*u3 - 2*u1*u2*tan(q2)
    let f5 = (-(u1 * u2 * t2)).mul_add(S::int(2), S::int(3) * u1 * u3);
    let zero = S::int(0);
    [f1, f2, f3, f4, f5, zero]
}

/// Newton–Euler equations as printed (newton-euler-final) of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct PrintedNewtonEulerFinal;

impl<S: Scalar> System<S> for PrintedNewtonEulerFinal {
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
