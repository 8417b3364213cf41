//! Thin disk sliding on a frictionless plane: Lagrange's equations as printed (lagrange-final), E(q) q'' = A(q, q').
//!
//! Generated from `models/disk/publication.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::lagrange::{coordinate_rates, generalized_speeds};

pub use super::kane::potential_energy;

use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system E(q) q'' = A(q, q'); rows row 1, row 2, row 3, row 4, row 5.
///
/// 28 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 5],
    _q_dot: &[S; 5],
) -> [[S; 5]; 5] {
    let Parameters { R, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Entries that are not zero.
    // M11 = R^2*(6 - 5*cos(q2)^2)/2
    let m11 = S::ratio(1, 2) * R * R * (S::int(6) - S::int(5) * c2 * c2);
    // M13 = R*sin(q2)/2
    let m13 = S::ratio(1, 2) * R * s2;
    // M14 = -cos(q1)*sin(q2)
    let m14 = -c1 * s2;
    // M15 = -sin(q1)*sin(q2)
    let m15 = -s1 * s2;
    // M22 = 5*R^2/4
    let m22 = S::ratio(5, 4) * R * R;
    // M24 = -sin(q1)*cos(q2)
    let m24 = -s1 * c2;
    // M25 = cos(q1)*cos(q2)
    let m25 = c1 * c2;
    // M31 = sin(q2)
    let m31 = s2;
    // M33 = 1
    let m33 = S::int(1);
    // M41 = R*cos(q1)*sin(q2)
    let m41 = R * c1 * s2;
    // M42 = R*sin(q1)*cos(q2)
    let m42 = R * s1 * c2;
    // M44 = -1
    let m44 = -S::int(1);
    // M51 = R*sin(q1)*sin(q2)
    let m51 = R * s1 * s2;
    // M52 = -R*cos(q1)*cos(q2)
    let m52 = -R * c1 * c2;
    // M55 = -1
    let m55 = -S::int(1);
    let zero = S::int(0);
    [
        [m11, zero, m13, m14, m15],
        [zero, m22, zero, m24, m25],
        [m31, zero, m33, zero, zero],
        [m41, m42, zero, m44, zero],
        [m51, m52, zero, zero, m55],
    ]
}

/// Right-hand side of the linear system; unknowns (q1'', q2'', q3'', q4'', q5'').
///
/// 57 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> [S; 5] {
    let Parameters { R, g, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, _, _] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Values.
    // f1 = -5*R*q1'*q2'*sin(q2)*cos(q2)/2 - R*q2'*q3'*cos(q2)/2
    let f1 = -S::ratio(5, 2) * R * q1_dot * q2_dot * s2 * c2
        - S::ratio(1, 2) * R * q2_dot * q3_dot * c2;
    // f2 = g*sin(q2) + 5*R*q1'^2*sin(q2)*cos(q2)/4 + R*q1'*q3'*cos(q2)/2
    let f2 = g.mul_add(s2, S::ratio(5, 4) * R * q1_dot * q1_dot * s2 * c2)
        + S::ratio(1, 2) * R * q1_dot * q3_dot * c2;
    // f3 = -q1'*q2'*cos(q2)
    let f3 = -q1_dot * q2_dot * c2;
    // f4 = R*q1'^2*sin(q1)*sin(q2) + R*q2'^2*sin(q1)*sin(q2) - 2*R*q1'*q2'*cos(q1)*cos(q2)
    let f4 = (-(R * q1_dot * q2_dot * c1 * c2))
        .mul_add(
            S::int(2),
            R * q1_dot * q1_dot * s1 * s2 + R * q2_dot * q2_dot * s1 * s2,
        );
    // f5 = -R*q1'^2*cos(q1)*cos(q2) - R*q2'^2*cos(q1)*sin(q2) - 2*R*q1'*q2'*sin(q1)*cos(q2)
    let f5 = (-(R * q1_dot * q2_dot * s1 * c2))
        .mul_add(
            S::int(2),
            -R * q1_dot * q1_dot * c1 * c2 - R * q2_dot * q2_dot * c1 * s2,
        );
    [f1, f2, f3, f4, f5]
}

/// Kinetic energy T.
///
/// 60 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 5], q_dot: &[S; 5]) -> S {
    let Parameters { M, R, .. } = *p;
    let [q1, q2, _, _, _] = *q;
    let [q1_dot, q2_dot, q3_dot, q4_dot, q5_dot] = *q_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    let (s1, c1) = q1.sin_cos();
    // Values.
    // T = M*R^2*q1'^2*(6 - 5*cos(q2)^2)/8 + 5*M*R^2*q2'^2/8 + M*R^2*q3'^2/4 + M*R^2*q1'*q3'*sin(q2)/2 +
    //   M*q4'^2/2 - M*R*q1'*q4'*cos(q1)*sin(q2) - M*R*q2'*q4'*sin(q1)*cos(q2) + M*q5'^2/2 -
    //   M*R*q1'*q5'*sin(q1)*sin(q2) + M*R*q2'*q5'*cos(q1)*cos(q2)
    let energy = S::ratio(1, 8) * M * R * R * q1_dot * q1_dot * (S::int(6) - S::int(5) * c2 * c2)
        + S::ratio(5, 8) * M * R * R * q2_dot * q2_dot
        + S::ratio(1, 4) * M * R * R * q3_dot * q3_dot
        + S::ratio(1, 2) * M * R * R * q1_dot * q3_dot * s2
        + S::ratio(1, 2) * M * q4_dot * q4_dot - M * R * q1_dot * q4_dot * c1 * s2
        - M * R * q2_dot * q4_dot * s1 * c2 + S::ratio(1, 2) * M * q5_dot * q5_dot
        - M * R * q1_dot * q5_dot * s1 * s2 + M * R * q2_dot * q5_dot * c1 * c2;
    energy
}

/// Their time derivatives u', from q, q' and q''.
///
/// 10 operations, 1 sine and cosine.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    q: &[S; 5],
    q_dot: &[S; 5],
    v_dot: &[S; 5],
) -> [S; 5] {
    let [_, q2, _, _, _] = *q;
    let [q1_dot, q2_dot, _, _, _] = *q_dot;
    let [q1_ddot, q2_ddot, q3_ddot, q4_ddot, q5_ddot] = *v_dot;
    // Sines and cosines.
    let (s2, c2) = q2.sin_cos();
    // Values.
    // u1' = -q2''
    let u1_dot_value = -q2_ddot;
    // u2' = q1''*cos(q2) - q1'*q2'*sin(q2)
    let u2_dot_value = (-(q1_dot * q2_dot)).mul_add(s2, q1_ddot * c2);
    // u3' = q1'*q2'*cos(q2) + q1''*sin(q2) + q3''
    let u3_dot_value = q1_ddot.mul_add(s2, q1_dot * q2_dot * c2) + q3_ddot;
    // u4' = q4''
    let u4_dot_value = q4_ddot;
    // u5' = q5''
    let u5_dot_value = q5_ddot;
    [u1_dot_value, u2_dot_value, u3_dot_value, u4_dot_value, u5_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 5 operations, 1 sine and cosine.
#[must_use]
pub fn motion_variables<S: Scalar>(
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

/// Lagrange's equations as printed (lagrange-final) of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct PrintedLagrangeFinal;

impl<S: Scalar> System<S> for PrintedLagrangeFinal {
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
    fn generalized_speeds(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &generalized_speeds(&Parameters::from_slice(p), array(q), array(v)),
        );
    }
    fn generalized_speed_rates(
        &self,
        p: &[S],
        q: &[S],
        v: &[S],
        v_dot: &[S],
        out: &mut [S],
    ) {
        out.copy_from_slice(
            &generalized_speed_rates(
                &Parameters::from_slice(p),
                array(q),
                array(v),
                array(v_dot),
            ),
        );
    }
    fn motion_variables(&self, p: &[S], q: &[S], u: &[S], out: &mut [S]) {
        out.copy_from_slice(
            &motion_variables(&Parameters::from_slice(p), array(q), array(u)),
        );
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
