//! Slider-crank: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/slider_crank/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

/// Matrix of the linear system M(q) u' = f(q, u); symmetric, rows u.
///
/// 26 operations, 3 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _u: &[S; 1],
) -> [[S; 1]; 1] {
    let Parameters { r, l, b, I, mr, Ir, mp, .. } = *p;
    let [q_2, p_2] = *q;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (_, cos_p) = p_2.sin_cos();
    // Shared terms.
    let l_inv = S::int(1) / l;
    let b_mr = b * mr;
    // q + p
    let q_2_plus_p_2 = q_2 + p_2;
    let (sin_q_plus_p, cos_q_plus_p) = q_2_plus_p_2.sin_cos();
    let cos_q_cos_q_plus_p_inv = cos_q / cos_q_plus_p;
    // Entries that are not zero; upper triangle.
    // M11 = I + r^2*(mr + mp*sin(q)^2 + cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - 2*b*mr*cos(p))/l +
    //   mp*sin(q + p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q + p))
    let m11 = I
        + r * r
            * (mr + mp * sin_q * sin_q
                + cos_q_cos_q_plus_p_inv
                    * (l_inv
                        * (l_inv * cos_q_cos_q_plus_p_inv * b.mul_add(b_mr, Ir)
                            - S::int(2) * b_mr * cos_p)
                        + mp * sin_q_plus_p
                            * (-sin_q)
                                .mul_add(
                                    S::int(2),
                                    cos_q_cos_q_plus_p_inv * sin_q_plus_p,
                                )));
    [[m11]]
}

/// Right-hand side of the linear system; unknowns (u').
///
/// 56 operations, 3 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> [S; 1] {
    let Parameters { r, l, b, mr, Ir, mp, g, .. } = *p;
    let [q_2, p_2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_p, cos_p) = p_2.sin_cos();
    // Shared terms.
    // q + p
    let q_2_plus_p_2 = q_2 + p_2;
    let (sin_q_plus_p, cos_q_plus_p) = q_2_plus_p_2.sin_cos();
    let cos_q_plus_p_inv = S::int(1) / cos_q_plus_p;
    let r_u_2 = r * u_2;
    let cos_q_plus_p_inv_r_u_2 = cos_q_plus_p_inv * r_u_2;
    let l_inv = S::int(1) / l;
    let r_cos_q = r * cos_q;
    let cos_q_plus_p_inv_r_cos_q = cos_q_plus_p_inv * r_cos_q;
    let cos_q_sin_q_plus_p = cos_q * sin_q_plus_p;
    // sin(q) + cos_q_plus_p_inv*l_inv*cos_q_plus_p_inv_r_cos_q*cos_q_sin_q_plus_p
    let f1_of_r_l_q_2_p_2 = (cos_q_plus_p_inv * l_inv * cos_q_plus_p_inv_r_cos_q)
        .mul_add(cos_q_sin_q_plus_p, sin_q);
    let f1_of_u_2 = cos_q_plus_p_inv_r_u_2 * l_inv;
    let b_mr = b * mr;
    // Values.
    // f1 = r*((r*u^2*(cos(q)*((b*mr*sin(p) + (sin(q)*(b^2*mr + Ir)/l + r*cos(q)*(b*mr*sin(p)/l + (sin(q +
    //   p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) - mp*sin(q))/cos(q
    //   + p)))/cos(q + p))/l + mp*(cos(q)*sin(q + p) + sin(q)/cos(q + p))) - sin(q)*(mp*sin(q)*sin(q + p) +
    //   b*mr*cos(p)/l)) - g*cos(q)*sin(q + p)*(b*mr/l + mp))/cos(q + p) + sin(q)*(mr*g + mp*(g -
    //   2*r*u^2*cos(q))))
    let f1 = g
        * (r * sin_q * (mr + mp)
            - cos_q_plus_p_inv_r_cos_q * sin_q_plus_p * l_inv.mul_add(b_mr, mp))
        - r_u_2
            * (mp
                * (S::int(2) * cos_q
                    * (-cos_q_plus_p_inv_r_u_2)
                        .mul_add(cos_q_sin_q_plus_p, r_u_2 * sin_q)
                    + cos_q_plus_p_inv_r_u_2 * sin_q_plus_p)
                + f1_of_u_2 * b_mr * (-cos_q).mul_add(sin_p, f1_of_r_l_q_2_p_2 * cos_p))
        + cos_q
            * (mp * cos_q_plus_p_inv_r_u_2
                * (-(cos_q_plus_p_inv_r_cos_q * f1_of_u_2))
                    .mul_add(sin_q, cos_q_plus_p_inv_r_u_2 * f1_of_r_l_q_2_p_2)
                + f1_of_u_2 * f1_of_u_2
                    * (b_mr * b.mul_add(f1_of_r_l_q_2_p_2, r_cos_q * sin_p)
                        + Ir * f1_of_r_l_q_2_p_2));
    [f1]
}

/// The accelerations (u'), solved for when this code was generated.
///
/// 65 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> [S; 1] {
    let Parameters { r, l, b, I, mr, Ir, mp, g, .. } = *p;
    let [q_2, p_2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_p, cos_p) = p_2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let l_inv = S::int(1) / l;
    let b_mr = b * mr;
    // q + p
    let q_2_plus_p_2 = q_2 + p_2;
    let (sin_q_plus_p, cos_q_plus_p) = q_2_plus_p_2.sin_cos();
    let cos_q_plus_p_inv = S::int(1) / cos_q_plus_p;
    let cos_q_cos_q_plus_p_inv = cos_q_plus_p_inv * cos_q;
    let u_dot_of_l_q_2_p_2 = l_inv * cos_q_cos_q_plus_p_inv;
    // u_dot_of_l_q_2_p_2*(Ir + b*b_mr)
    let u_dot_of_place = u_dot_of_l_q_2_p_2 * b.mul_add(b_mr, Ir);
    let cos_p_b_mr = b_mr * cos_p;
    let u_dot_of_q_2_p_2 = cos_q_cos_q_plus_p_inv * sin_q_plus_p;
    // mp*(2*sin(q) - u_dot_of_q_2_p_2)
    let u_dot_of_mp_q_2_p_2 = mp * sin_q.mul_add(S::int(2), -u_dot_of_q_2_p_2);
    // 1/(I + r^2*(mr + mp*sin(q)^2 + cos_q_cos_q_plus_p_inv*(l_inv*(u_dot_of_place - 2*cos_p_b_mr) -
    //   u_dot_of_mp_q_2_p_2*sin(q + p))))
    let u_dot_of_place_2 = S::int(1)
        / (I
            + r * r
                * (mr + mp * sin_q * sin_q
                    + cos_q_cos_q_plus_p_inv
                        * (l_inv * (-cos_p_b_mr).mul_add(S::int(2), u_dot_of_place)
                            - u_dot_of_mp_q_2_p_2 * sin_q_plus_p)));
    let b_mr_u_dot_of_l_q_2_p_2 = b_mr * u_dot_of_l_q_2_p_2;
    let r_u_2 = r * u_2;
    let u_dot_of_u_2 = u_dot_of_place_2 * r_u_2 * r_u_2;
    let r_u_dot_of_l_q_2_p_2 = r * u_dot_of_l_q_2_p_2;
    // sin(q) + u_dot_of_q_2_p_2*r_u_dot_of_l_q_2_p_2
    let u_dot_of_r_l_q_2_p_2 = u_dot_of_q_2_p_2.mul_add(r_u_dot_of_l_q_2_p_2, sin_q);
    // u' = r*((r*u^2*(cos(q)*((b*mr*sin(p) + (sin(q)*(b^2*mr + Ir)/l + r*cos(q)*(b*mr*sin(p)/l + (sin(q +
    //   p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) - mp*sin(q))/cos(q
    //   + p)))/cos(q + p))/l + mp*(cos(q)*sin(q + p) + sin(q)/cos(q + p))) - sin(q)*(mp*sin(q)*sin(q + p) +
    //   b*mr*cos(p)/l)) - g*cos(q)*sin(q + p)*(b*mr/l + mp))/cos(q + p) + sin(q)*(mr*g + mp*(g -
    //   2*r*u^2*cos(q))))/(I + r^2*(mr + mp*sin(q)^2 + cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) -
    //   2*b*mr*cos(p))/l + mp*sin(q + p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q + p)))
    let u_dot = r * g * u_dot_of_place_2
        * (sin_q * (mr + mp)
            - sin_q_plus_p * mp.mul_add(cos_q_cos_q_plus_p_inv, b_mr_u_dot_of_l_q_2_p_2))
        + u_dot_of_u_2
            * (b_mr_u_dot_of_l_q_2_p_2 * sin_p * (S::int(1) + r_u_dot_of_l_q_2_p_2)
                - u_dot_of_mp_q_2_p_2 * cos_q)
        + cos_q_plus_p_inv * u_dot_of_u_2
            * (l_inv * u_dot_of_r_l_q_2_p_2 * (u_dot_of_place - cos_p_b_mr)
                + mp
                    * (-sin_q
                        * cos_q_cos_q_plus_p_inv
                            .mul_add(r_u_dot_of_l_q_2_p_2, sin_q * sin_q_plus_p)
                        + cos_q_cos_q_plus_p_inv * u_dot_of_r_l_q_2_p_2));
    [u_dot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 7 operations, 2 sines and cosines.
#[must_use]
pub fn coordinate_rates<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> [S; 2] {
    let Parameters { r, l, .. } = *p;
    let [q_2, p_2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (_, cos_q) = q_2.sin_cos();
    let (_, cos_q_plus_p) = (q_2 + p_2).sin_cos();
    // Values.
    // q' = u
    let q_dot_value = u_2;
    // p' = -u*(1 + r*cos(q)/(l*cos(q + p)))
    let p_dot_value = -u_2 * (S::int(1) + r * cos_q / (l * cos_q_plus_p));
    [q_dot_value, p_dot_value]
}

/// Kinetic energy T.
///
/// 29 operations, 3 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> S {
    let Parameters { r, l, b, I, mr, Ir, mp, .. } = *p;
    let [q_2, p_2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (_, cos_p) = p_2.sin_cos();
    // Shared terms.
    let l_inv = S::int(1) / l;
    let b_mr = b * mr;
    // q + p
    let q_2_plus_p_2 = q_2 + p_2;
    let (sin_q_plus_p, cos_q_plus_p) = q_2_plus_p_2.sin_cos();
    let cos_q_cos_q_plus_p_inv = cos_q / cos_q_plus_p;
    // Values.
    // T = u^2*(I + r^2*(mr + mp*sin(q)^2 + cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - 2*b*mr*cos(p))/l
    //   + mp*sin(q + p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q + p)))/2
    let energy = S::ratio(1, 2) * u_2 * u_2
        * (I
            + r * r
                * (mr + mp * sin_q * sin_q
                    + cos_q_cos_q_plus_p_inv
                        * (l_inv
                            * (l_inv * cos_q_cos_q_plus_p_inv * b.mul_add(b_mr, Ir)
                                - S::int(2) * b_mr * cos_p)
                            + mp * sin_q_plus_p
                                * (-sin_q)
                                    .mul_add(
                                        S::int(2),
                                        cos_q_cos_q_plus_p_inv * sin_q_plus_p,
                                    ))));
    energy
}

/// Potential energy V: of gravity, and of the applied loads that have a potential.
///
/// 10 operations, 2 sines and cosines.
#[must_use]
pub fn potential_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2]) -> S {
    let Parameters { r, l, b, mr, mp, g, .. } = *p;
    let [q_2, p_2] = *q;
    // Sines and cosines.
    let (_, cos_q) = q_2.sin_cos();
    let (_, cos_q_plus_p) = (q_2 + p_2).sin_cos();
    // Values.
    // V = g*(r*cos(q)*(mr + mp) + cos(q + p)*(b*mr + l*mp))
    let energy = g * (r * cos_q * (mr + mp) + cos_q_plus_p * l.mul_add(mp, b * mr));
    energy
}

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 68 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 1],
) -> ([S; 2], [S; 1]) {
    let Parameters { r, l, b, I, mr, Ir, mp, g, .. } = *p;
    let [q_2, p_2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_p, cos_p) = p_2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let l_inv = S::int(1) / l;
    let b_mr = b * mr;
    // q + p
    let q_2_plus_p_2 = q_2 + p_2;
    let (sin_q_plus_p, cos_q_plus_p) = q_2_plus_p_2.sin_cos();
    let cos_q_plus_p_inv = S::int(1) / cos_q_plus_p;
    let cos_q_cos_q_plus_p_inv = cos_q_plus_p_inv * cos_q;
    let u_dot_of_l_q_2_p_2 = l_inv * cos_q_cos_q_plus_p_inv;
    // u_dot_of_l_q_2_p_2*(Ir + b*b_mr)
    let u_dot_of_place = u_dot_of_l_q_2_p_2 * b.mul_add(b_mr, Ir);
    let cos_p_b_mr = b_mr * cos_p;
    let u_dot_of_q_2_p_2 = cos_q_cos_q_plus_p_inv * sin_q_plus_p;
    // 2*sin(q) - u_dot_of_q_2_p_2
    let u_dot_of_q_2_p_2_2 = sin_q.mul_add(S::int(2), -u_dot_of_q_2_p_2);
    // 1/(I + r^2*(mr + mp*sin(q)^2 + cos_q_cos_q_plus_p_inv*(l_inv*(u_dot_of_place - 2*cos_p_b_mr) -
    //   mp*u_dot_of_q_2_p_2_2*sin(q + p))))
    let u_dot_of_place_2 = S::int(1)
        / (I
            + r * r
                * (mr + mp * sin_q * sin_q
                    + cos_q_cos_q_plus_p_inv
                        * (l_inv * (-cos_p_b_mr).mul_add(S::int(2), u_dot_of_place)
                            - mp * u_dot_of_q_2_p_2_2 * sin_q_plus_p)));
    let b_mr_u_dot_of_l_q_2_p_2 = b_mr * u_dot_of_l_q_2_p_2;
    let r_u_2 = r * u_2;
    let r_u_dot_of_l_q_2_p_2 = r * u_dot_of_l_q_2_p_2;
    // sin(q) + u_dot_of_q_2_p_2*r_u_dot_of_l_q_2_p_2
    let u_dot_of_r_l_q_2_p_2 = u_dot_of_q_2_p_2.mul_add(r_u_dot_of_l_q_2_p_2, sin_q);
    // l_inv*cos_q_plus_p_inv*u_dot_of_r_l_q_2_p_2*(u_dot_of_place - cos_p_b_mr) -
    //   mp*(u_dot_of_q_2_p_2_2*cos(q) + cos_q_plus_p_inv*(sin(q)*(sin(q)*sin(q + p) +
    //   cos_q_cos_q_plus_p_inv*r_u_dot_of_l_q_2_p_2) - cos_q_cos_q_plus_p_inv*u_dot_of_r_l_q_2_p_2))
    let u_dot_of_place_3 = l_inv * cos_q_plus_p_inv * u_dot_of_r_l_q_2_p_2
        * (u_dot_of_place - cos_p_b_mr)
        - mp
            * (cos_q_plus_p_inv
                * (sin_q
                    * cos_q_cos_q_plus_p_inv
                        .mul_add(r_u_dot_of_l_q_2_p_2, sin_q * sin_q_plus_p)
                    - cos_q_cos_q_plus_p_inv * u_dot_of_r_l_q_2_p_2) + u_dot_of_q_2_p_2_2 * cos_q);
    // u' = r*((r*u^2*(cos(q)*((b*mr*sin(p) + (sin(q)*(b^2*mr + Ir)/l + r*cos(q)*(b*mr*sin(p)/l + (sin(q +
    //   p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) - mp*sin(q))/cos(q
    //   + p)))/cos(q + p))/l + mp*(cos(q)*sin(q + p) + sin(q)/cos(q + p))) - sin(q)*(mp*sin(q)*sin(q + p) +
    //   b*mr*cos(p)/l)) - g*cos(q)*sin(q + p)*(b*mr/l + mp))/cos(q + p) + sin(q)*(mr*g + mp*(g -
    //   2*r*u^2*cos(q))))/(I + r^2*(mr + mp*sin(q)^2 + cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) -
    //   2*b*mr*cos(p))/l + mp*sin(q + p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q + p)))
    let u_dot = r * g * u_dot_of_place_2
        * (sin_q * (mr + mp)
            - sin_q_plus_p * mp.mul_add(cos_q_cos_q_plus_p_inv, b_mr_u_dot_of_l_q_2_p_2))
        + u_dot_of_place_2 * r_u_2 * r_u_2
            * (b_mr_u_dot_of_l_q_2_p_2 * sin_p * (S::int(1) + r_u_dot_of_l_q_2_p_2)
                + u_dot_of_place_3);
    // Values.
    // q' = u
    let q_dot_value = u_2;
    // p' = -u*(1 + r*cos(q)/(l*cos(q + p)))
    let p_dot_value = (-u_dot_of_l_q_2_p_2).mul_add(r_u_2, -u_2);
    ([q_dot_value, p_dot_value], [u_dot])
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 1 operation, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 2], _u: &[S; 1]) -> [S; 1] {
    let [q_2, p_2] = *q;
    // Sines and cosines.
    let (_, cos_q_plus_p) = (q_2 + p_2).sin_cos();
    // Values.
    // divisor1 = cos(q + p)
    let divisor1 = cos_q_plus_p;
    [divisor1]
}

/// What is zero where the constraints hold, each in its own unit.
///
/// 4 operations, 2 sines and cosines.
#[must_use]
pub fn constraints<S: Scalar>(p: &Parameters<S>, q: &[S; 2], _u: &[S; 1]) -> [S; 1] {
    let Parameters { r, l, .. } = *p;
    let [q_2, p_2] = *q;
    // Sines and cosines.
    let (sin_q, _) = q_2.sin_cos();
    let (sin_q_plus_p, _) = (q_2 + p_2).sin_cos();
    // Values.
    // wrist_1 = r*sin(q) + l*sin(q + p)
    let residual1 = l.mul_add(sin_q_plus_p, r * sin_q);
    [residual1]
}

/// Slopes of the constraints, one after the other, along q, p, u.
///
/// 4 operations, 2 sines and cosines.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _u: &[S; 1],
) -> [S; 3] {
    let Parameters { r, l, .. } = *p;
    let [q_2, p_2] = *q;
    // Sines and cosines.
    let (_, cos_q) = q_2.sin_cos();
    let (_, cos_q_plus_p) = (q_2 + p_2).sin_cos();
    // Shared terms.
    let l_cos_q_plus_p = l * cos_q_plus_p;
    // Values.
    // d(wrist_1)/d(q) = r*cos(q) + l*cos(q + p)
    let residual1_by_q = r.mul_add(cos_q, l_cos_q_plus_p);
    // d(wrist_1)/d(p) = l*cos(q + p)
    let residual1_by_p = l_cos_q_plus_p;
    let zero = S::int(0);
    [residual1_by_q, residual1_by_p, zero]
}

/// Inverse dynamics: the generalized forces along (u) that must act beside the loads of the model for the accelerations to be (u').
///
/// 70 operations, 3 sines and cosines.
#[must_use]
pub fn inverse_dynamics<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 1],
    v_dot: &[S; 1],
) -> [S; 1] {
    let Parameters { r, l, b, I, mr, Ir, mp, g, .. } = *p;
    let [q_2, p_2] = *q;
    let [u_2] = *u;
    let [u_dot] = *v_dot;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_p, cos_p) = p_2.sin_cos();
    // Shared terms.
    let l_inv = S::int(1) / l;
    // q + p
    let q_2_plus_p_2 = q_2 + p_2;
    let (sin_q_plus_p, cos_q_plus_p) = q_2_plus_p_2.sin_cos();
    let cos_q_plus_p_inv = S::int(1) / cos_q_plus_p;
    let r_cos_q_plus_p_inv = r * cos_q_plus_p_inv;
    let cos_q_r_cos_q_plus_p_inv = r_cos_q_plus_p_inv * cos_q;
    let tau1_of_r_l_q_2_p_2 = l_inv * cos_q_r_cos_q_plus_p_inv;
    let r_mr = r * mr;
    let u_2_sq = u_2 * u_2;
    // sin(q) + cos_q_plus_p_inv*tau1_of_r_l_q_2_p_2*cos(q)*sin(q + p)
    let tau1_of_r_l_q_2_p_2_2 = (cos_q_plus_p_inv * tau1_of_r_l_q_2_p_2 * cos_q)
        .mul_add(sin_q_plus_p, sin_q);
    // tau1_of_r_l_q_2_p_2*(b^2*mr + Ir)
    let tau1_of_place = tau1_of_r_l_q_2_p_2 * (b * b * mr + Ir);
    let r_sin_q = r * sin_q;
    let tau1_of_r_q_2_p_2 = cos_q_r_cos_q_plus_p_inv * sin_q_plus_p;
    // 2*r_sin_q - tau1_of_r_q_2_p_2
    let tau1_of_r_q_2_p_2_2 = r_sin_q.mul_add(S::int(2), -tau1_of_r_q_2_p_2);
    // Values.
    // tau1 = u'*(I + r^2*(mr + mp*sin(q)^2 + cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) -
    //   2*b*mr*cos(p))/l + mp*sin(q + p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q + p))) -
    //   r*((r*u^2*(cos(q)*((b*mr*sin(p) + (sin(q)*(b^2*mr + Ir)/l + r*cos(q)*(b*mr*sin(p)/l + (sin(q +
    //   p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) - mp*sin(q))/cos(q
    //   + p)))/cos(q + p))/l + mp*(cos(q)*sin(q + p) + sin(q)/cos(q + p))) - sin(q)*(mp*sin(q)*sin(q + p) +
    //   b*mr*cos(p)/l)) - g*cos(q)*sin(q + p)*(b*mr/l + mp))/cos(q + p) + sin(q)*(mr*g + mp*(g -
    //   2*r*u^2*cos(q))))
    let tau1 = r_mr * (-g).mul_add(sin_q, r * u_dot)
        + b * tau1_of_r_l_q_2_p_2
            * (-r_mr
                * (u_2_sq * sin_p * (S::int(1) + tau1_of_r_l_q_2_p_2)
                    + S::int(2) * u_dot * cos_p) + mr * g * sin_q_plus_p)
        + u_dot * tau1_of_r_l_q_2_p_2.mul_add(tau1_of_place, I)
        - mp
            * (r_sin_q * (-u_dot).mul_add(r_sin_q, g)
                + tau1_of_r_q_2_p_2 * u_dot.mul_add(tau1_of_r_q_2_p_2_2, -g))
        + u_2_sq
            * (mp
                * (r_cos_q_plus_p_inv
                    * (cos_q_r_cos_q_plus_p_inv
                        * tau1_of_r_l_q_2_p_2.mul_add(sin_q, -tau1_of_r_l_q_2_p_2_2)
                        + r_sin_q * sin_q * sin_q_plus_p) + r * tau1_of_r_q_2_p_2_2 * cos_q)
                - l_inv * r_cos_q_plus_p_inv * tau1_of_r_l_q_2_p_2_2
                    * (-(b * r_mr)).mul_add(cos_p, tau1_of_place));
    [tau1]
}

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    u: &[S; 1],
    direction: &[S; 3],
) -> [S; 3] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: u[i],
        slope: direction[2 + i],
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
            parameters: 9,
            coordinates: 2,
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
        3
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
        ["cos(q + p)"][at]
    }
    fn divisors(&self, p: &[S], q: &[S], v: &[S], out: &mut [S]) {
        out.copy_from_slice(&divisors(&Parameters::from_slice(p), array(q), array(v)));
    }
    fn constraint_count(&self) -> usize {
        1
    }
    fn constraint_name(&self, at: usize) -> &str {
        ["wrist_1"][at]
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
