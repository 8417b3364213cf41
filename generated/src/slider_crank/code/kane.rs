//! Slider-crank: Kane's method, M(q) u' = f(q, u).
//!
//! Generated from `models/slider_crank/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;
use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

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

/// Jacobian of the derivative by the state; columns q, p, u.
///
/// 205 operations, 3 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> [[S; 3]; 3] {
    let Parameters { r, l, b, I, mr, Ir, mp, g, .. } = *p;
    let [q_2, p_2] = *q;
    let [u_2] = *u;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_p, cos_p) = p_2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    // q + p
    let q_2_plus_p_2 = q_2 + p_2;
    let (sin_q_plus_p, cos_q_plus_p) = q_2_plus_p_2.sin_cos();
    let cos_q_plus_p_inv = S::int(1) / cos_q_plus_p;
    let mp_sin_q = mp * sin_q;
    let l_inv = S::int(1) / l;
    let b_mr = b * mr;
    let cos_p_b_mr = b_mr * cos_p;
    let l_inv_cos_p_b_mr = l_inv * cos_p_b_mr;
    // mp_sin_q*sin(q + p) + l_inv_cos_p_b_mr
    let u_dot_by_q_of_place = mp_sin_q.mul_add(sin_q_plus_p, l_inv_cos_p_b_mr);
    let cos_q_cos_q_plus_p_inv = cos_q_plus_p_inv * cos_q;
    // l_inv*(Ir + b*b_mr)
    let u_dot_by_q_of_l_b_mr_ir = l_inv * b.mul_add(b_mr, Ir);
    let u_dot_by_q_of_place_2 = cos_q_cos_q_plus_p_inv * u_dot_by_q_of_l_b_mr_ir;
    // mp*cos_q_cos_q_plus_p_inv + l_inv*(u_dot_by_q_of_place_2 - cos_p_b_mr)
    let u_dot_by_q_of_place_3 = l_inv * (u_dot_by_q_of_place_2 - cos_p_b_mr)
        + mp * cos_q_cos_q_plus_p_inv;
    // u_dot_by_q_of_place_3*sin(q + p) - mp_sin_q
    let u_dot_by_q_of_place_4 = u_dot_by_q_of_place_3.mul_add(sin_q_plus_p, -mp_sin_q);
    let sin_p_b_mr = b_mr * sin_p;
    let l_inv_sin_p_b_mr = l_inv * sin_p_b_mr;
    // cos_q_plus_p_inv*u_dot_by_q_of_place_4 + l_inv_sin_p_b_mr
    let u_dot_by_q_of_place_5 = cos_q_plus_p_inv
        .mul_add(u_dot_by_q_of_place_4, l_inv_sin_p_b_mr);
    let u_dot_by_q_of_q_2_p_2 = cos_q_plus_p_inv * sin_q_plus_p;
    let u_dot_by_q_of_q_2_p_2_2 = cos_q_cos_q_plus_p_inv * u_dot_by_q_of_q_2_p_2;
    let sin_q_cos_q_plus_p_inv = cos_q_plus_p_inv * sin_q;
    // sin_q_cos_q_plus_p_inv - u_dot_by_q_of_q_2_p_2_2
    let u_dot_by_q_of_q_2_p_2_3 = sin_q_cos_q_plus_p_inv - u_dot_by_q_of_q_2_p_2_2;
    let u_dot_by_q_of_place_6 = l_inv * u_dot_by_q_of_l_b_mr_ir * u_dot_by_q_of_q_2_p_2_3;
    let u_dot_by_q_of_place_7 = u_dot_by_q_of_place_3 * cos_q_plus_p;
    let u_dot_by_q_of_q_2_p_2_4 = cos_q_plus_p_inv * u_dot_by_q_of_q_2_p_2;
    let u_dot_by_q_of_place_8 = u_dot_by_q_of_place_4 * u_dot_by_q_of_q_2_p_2_4;
    let r_cos_q = r * cos_q;
    // u_dot_by_q_of_l_b_mr_ir*sin(q) + u_dot_by_q_of_place_5*r_cos_q
    let u_dot_by_q_of_place_9 = u_dot_by_q_of_place_5
        .mul_add(r_cos_q, u_dot_by_q_of_l_b_mr_ir * sin_q);
    let u_dot_by_q_of_place_10 = u_dot_by_q_of_q_2_p_2_4 * u_dot_by_q_of_place_9;
    let cos_q_cos_q_plus_p = cos_q * cos_q_plus_p;
    // cos_q_cos_q_plus_p - sin(q)*sin(q + p)
    let u_dot_by_q_of_q_2_p_2_5 = (-sin_q).mul_add(sin_q_plus_p, cos_q_cos_q_plus_p);
    let u_dot_by_q_of_q_2_p_2_6 = u_dot_by_q_of_q_2_p_2_4 * sin_q;
    // l_inv*(cos_q_plus_p_inv*(u_dot_by_q_of_l_b_mr_ir*cos(q) - r*u_dot_by_q_of_place_5*sin(q) +
    //   r_cos_q*(cos_q_plus_p_inv*(u_dot_by_q_of_place_7 - mp*cos(q) - sin(q +
    //   p)*(mp*u_dot_by_q_of_q_2_p_2_3 + u_dot_by_q_of_place_6)) + u_dot_by_q_of_place_8)) +
    //   u_dot_by_q_of_place_10) + mp*(cos_q_cos_q_plus_p_inv + u_dot_by_q_of_q_2_p_2_5 +
    //   u_dot_by_q_of_q_2_p_2_6)
    let u_dot_by_q_of_place_11 = l_inv
        * (cos_q_plus_p_inv
            * (u_dot_by_q_of_l_b_mr_ir * cos_q - r * u_dot_by_q_of_place_5 * sin_q
                + r_cos_q
                    * (cos_q_plus_p_inv
                        * (u_dot_by_q_of_place_7 - mp * cos_q
                            - sin_q_plus_p
                                * mp
                                    .mul_add(u_dot_by_q_of_q_2_p_2_3, u_dot_by_q_of_place_6))
                        + u_dot_by_q_of_place_8)) + u_dot_by_q_of_place_10)
        + mp
            * (cos_q_cos_q_plus_p_inv + u_dot_by_q_of_q_2_p_2_5 + u_dot_by_q_of_q_2_p_2_6);
    let cos_q_sin_q_plus_p = cos_q * sin_q_plus_p;
    // l_inv*(sin_p_b_mr + cos_q_plus_p_inv*u_dot_by_q_of_place_9) + mp*(sin_q_cos_q_plus_p_inv +
    //   cos_q_sin_q_plus_p)
    let u_dot_by_q_of_place_12 = l_inv * cos_q_plus_p_inv.mul_add(u_dot_by_q_of_place_9, sin_p_b_mr)
        + mp * (sin_q_cos_q_plus_p_inv + cos_q_sin_q_plus_p);
    let mp_sin_q_plus_p = mp * sin_q_plus_p;
    let cos_q_plus_p_mp_sin_q = mp_sin_q * cos_q_plus_p;
    // mp_sin_q_plus_p*cos(q) + cos_q_plus_p_mp_sin_q
    let u_dot_by_q_of_mp_q_2_p_2 = mp_sin_q_plus_p.mul_add(cos_q, cos_q_plus_p_mp_sin_q);
    let r_u_2 = r * u_2;
    let u_2_r_u_2 = u_2 * r_u_2;
    // g*(mp + l_inv*b_mr)
    let u_dot_by_q_of_l_b_mr_mp_g = g * l_inv.mul_add(b_mr, mp);
    let cos_q_doubled = S::int(2) * cos_q;
    // mr*g + mp*(g - u_2_r_u_2*cos_q_doubled)
    let u_dot_by_q_of_u_2 = mp * (-u_2_r_u_2).mul_add(cos_q_doubled, g) + mr * g;
    let sin_q_doubled = S::int(2) * sin_q;
    // u_dot_by_q_of_place_12*cos(q) - u_dot_by_q_of_place*sin(q)
    let u_dot_by_q_of_place_13 = (-u_dot_by_q_of_place)
        .mul_add(sin_q, u_dot_by_q_of_place_12 * cos_q);
    // u_2_r_u_2*u_dot_by_q_of_place_13 - cos_q_sin_q_plus_p*u_dot_by_q_of_l_b_mr_mp_g
    let u_dot_by_q_of_u_2_2 = (-cos_q_sin_q_plus_p)
        .mul_add(u_dot_by_q_of_l_b_mr_mp_g, u_2_r_u_2 * u_dot_by_q_of_place_13);
    let u_dot_by_q_of_u_2_3 = u_dot_by_q_of_q_2_p_2_4 * u_dot_by_q_of_u_2_2;
    let u_dot_by_q_of_q_2_p_2_7 = u_dot_by_q_of_q_2_p_2 * cos_q;
    // sin_q_doubled - u_dot_by_q_of_q_2_p_2_7
    let u_dot_by_q_of_q_2_p_2_8 = sin_q_doubled - u_dot_by_q_of_q_2_p_2_7;
    // l_inv*(u_dot_by_q_of_place_2 - 2*cos_p_b_mr) - mp_sin_q_plus_p*u_dot_by_q_of_q_2_p_2_8
    let u_dot_by_q_of_place_14 = l_inv * (-cos_p_b_mr).mul_add(S::int(2), u_dot_by_q_of_place_2)
        - mp_sin_q_plus_p * u_dot_by_q_of_q_2_p_2_8;
    // r/(I + r^2*(mr + mp_sin_q*sin(q) + cos_q_cos_q_plus_p_inv*u_dot_by_q_of_place_14))
    let u_dot_by_q_of_place_15 = r
        / (I
            + r * r
                * (mp_sin_q.mul_add(sin_q, mr) + cos_q_cos_q_plus_p_inv * u_dot_by_q_of_place_14));
    let u_dot_by_q_of_q_2_p_2_9 = u_dot_by_q_of_q_2_p_2 * u_dot_by_q_of_q_2_p_2_7;
    let u_dot_by_q_of_mp_q_2_p_2_2 = mp * u_dot_by_q_of_q_2_p_2_8 * cos_q_plus_p;
    let mp_sin_q_cos_q_doubled = mp_sin_q * cos_q_doubled;
    // r*u_dot_by_q_of_place_15^2*(u_dot_by_q_of_u_2*sin(q) + cos_q_plus_p_inv*u_dot_by_q_of_u_2_2)
    let u_dot_by_q_of_u_2_4 = r * u_dot_by_q_of_place_15 * u_dot_by_q_of_place_15
        * cos_q_plus_p_inv.mul_add(u_dot_by_q_of_u_2_2, u_dot_by_q_of_u_2 * sin_q);
    // u_dot_by_q = r^3*(sin(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - 2*b*mr*cos(p))/l + mp*sin(q +
    //   p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q + p) - 2*mp*sin(q)*cos(q) - cos(q)*tan(q +
    //   p)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - 2*b*mr*cos(p))/l + mp*sin(q + p)*(cos(q)*tan(q + p) -
    //   2*sin(q)))/cos(q + p) + cos(q)*(mp*cos(q + p)*(2*sin(q) - cos(q)*tan(q + p)) + (sin(q)*(b^2*mr +
    //   Ir)/(l*cos(q + p)) - cos(q)*tan(q + p)*(b^2*mr + Ir)/(l*cos(q + p)))/l + mp*sin(q + p)*(cos(q) +
    //   sin(q)*tan(q + p) - cos(q)*tan(q + p)^2))/cos(q + p))*((r*u^2*(cos(q)*((b*mr*sin(p) +
    //   (sin(q)*(b^2*mr + Ir)/l + r*cos(q)*(b*mr*sin(p)/l + (sin(q + p)*(mp*cos(q)/cos(q + p) +
    //   (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) - mp*sin(q))/cos(q + p)))/cos(q + p))/l +
    //   mp*(cos(q)*sin(q + p) + sin(q)/cos(q + p))) - sin(q)*(mp*sin(q)*sin(q + p) + b*mr*cos(p)/l)) -
    //   g*cos(q)*sin(q + p)*(b*mr/l + mp))/cos(q + p) + sin(q)*(mr*g + mp*(g - 2*r*u^2*cos(q))))/(I +
    //   r^2*(mr + mp*sin(q)^2 + cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - 2*b*mr*cos(p))/l + mp*sin(q +
    //   p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q + p)))^2 + r*(2*r*mp*u^2*sin(q)^2 + tan(q +
    //   p)*(r*u^2*(cos(q)*((b*mr*sin(p) + (sin(q)*(b^2*mr + Ir)/l + r*cos(q)*(b*mr*sin(p)/l + (sin(q +
    //   p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) - mp*sin(q))/cos(q
    //   + p)))/cos(q + p))/l + mp*(cos(q)*sin(q + p) + sin(q)/cos(q + p))) - sin(q)*(mp*sin(q)*sin(q + p) +
    //   b*mr*cos(p)/l)) - g*cos(q)*sin(q + p)*(b*mr/l + mp))/cos(q + p) + cos(q)*(mr*g + mp*(g -
    //   2*r*u^2*cos(q))) + (g*sin(q)*sin(q + p)*(b*mr/l + mp) - g*cos(q)*cos(q + p)*(b*mr/l + mp) -
    //   r*u^2*(sin(q)*((b*mr*sin(p) + (sin(q)*(b^2*mr + Ir)/l + r*cos(q)*(b*mr*sin(p)/l + (sin(q +
    //   p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) - mp*sin(q))/cos(q
    //   + p)))/cos(q + p))/l + mp*(cos(q)*sin(q + p) + sin(q)/cos(q + p))) + cos(q)*(mp*sin(q)*sin(q + p) +
    //   b*mr*cos(p)/l) - cos(q)*((tan(q + p)*(sin(q)*(b^2*mr + Ir)/l + r*cos(q)*(b*mr*sin(p)/l + (sin(q +
    //   p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) - mp*sin(q))/cos(q
    //   + p)))/cos(q + p) + (cos(q)*(b^2*mr + Ir)/l - r*sin(q)*(b*mr*sin(p)/l + (sin(q + p)*(mp*cos(q)/cos(q
    //   + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) - mp*sin(q))/cos(q + p)) +
    //   r*cos(q)*(tan(q + p)*(sin(q + p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) -
    //   b*mr*cos(p))/l) - mp*sin(q))/cos(q + p) + (cos(q + p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr +
    //   Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) - mp*cos(q) - sin(q + p)*(mp*sin(q)/cos(q + p) -
    //   mp*cos(q)*tan(q + p)/cos(q + p) + (sin(q)*(b^2*mr + Ir)/(l*cos(q + p)) - cos(q)*tan(q + p)*(b^2*mr +
    //   Ir)/(l*cos(q + p)))/l))/cos(q + p)))/cos(q + p))/l + mp*(cos(q)*cos(q + p) - sin(q)*sin(q + p) +
    //   cos(q)/cos(q + p) + sin(q)*tan(q + p)/cos(q + p))) + sin(q)*(mp*cos(q)*sin(q + p) + mp*sin(q)*cos(q
    //   + p))))/cos(q + p))/(I + r^2*(mr + mp*sin(q)^2 + cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) -
    //   2*b*mr*cos(p))/l + mp*sin(q + p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q + p)))
    let u_dot_by_q = u_dot_by_q_of_place_15
        * (-cos_q_plus_p_inv
            * (u_2_r_u_2
                * (cos_q * (u_dot_by_q_of_place - u_dot_by_q_of_place_11)
                    + sin_q * (u_dot_by_q_of_place_12 + u_dot_by_q_of_mp_q_2_p_2))
                + u_dot_by_q_of_q_2_p_2_5 * u_dot_by_q_of_l_b_mr_mp_g)
            + u_dot_by_q_of_u_2 * cos_q + mp_sin_q * u_2_r_u_2 * sin_q_doubled
            + u_dot_by_q_of_u_2_3)
        + u_dot_by_q_of_u_2_4
            * (-mp_sin_q_cos_q_doubled + u_dot_by_q_of_q_2_p_2_3 * u_dot_by_q_of_place_14
                + cos_q_cos_q_plus_p_inv
                    * (u_dot_by_q_of_place_6
                        + mp_sin_q_plus_p
                            * (u_dot_by_q_of_q_2_p_2.mul_add(sin_q, cos_q)
                                - u_dot_by_q_of_q_2_p_2_9) + u_dot_by_q_of_mp_q_2_p_2_2));
    let u_dot_by_p_of_place = u_dot_by_q_of_l_b_mr_ir * u_dot_by_q_of_q_2_p_2_2;
    let r_cos_q_cos_q_plus_p_inv = r * cos_q_cos_q_plus_p_inv;
    // u_dot_by_p = r*(tan(q + p)*(r*u^2*(cos(q)*((b*mr*sin(p) + (sin(q)*(b^2*mr + Ir)/l +
    //   r*cos(q)*(b*mr*sin(p)/l + (sin(q + p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) -
    //   b*mr*cos(p))/l) - mp*sin(q))/cos(q + p)))/cos(q + p))/l + mp*(cos(q)*sin(q + p) + sin(q)/cos(q +
    //   p))) - sin(q)*(mp*sin(q)*sin(q + p) + b*mr*cos(p)/l)) - g*cos(q)*sin(q + p)*(b*mr/l + mp))/cos(q +
    //   p) + (r*u^2*(cos(q)*((b*mr*cos(p) + tan(q + p)*(sin(q)*(b^2*mr + Ir)/l + r*cos(q)*(b*mr*sin(p)/l +
    //   (sin(q + p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) -
    //   mp*sin(q))/cos(q + p)))/cos(q + p) + r*cos(q)*(b*mr*cos(p)/l + tan(q + p)*(sin(q +
    //   p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) - mp*sin(q))/cos(q
    //   + p) + (cos(q + p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) +
    //   sin(q + p)*(mp*cos(q)*tan(q + p)/cos(q + p) + (b*mr*sin(p) + cos(q)*tan(q + p)*(b^2*mr +
    //   Ir)/(l*cos(q + p)))/l))/cos(q + p))/cos(q + p))/l + mp*(cos(q)*cos(q + p) + sin(q)*tan(q + p)/cos(q
    //   + p))) + sin(q)*(b*mr*sin(p)/l - mp*sin(q)*cos(q + p))) - g*cos(q)*cos(q + p)*(b*mr/l + mp))/cos(q +
    //   p))/(I + r^2*(mr + mp*sin(q)^2 + cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - 2*b*mr*cos(p))/l +
    //   mp*sin(q + p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q + p))) - r^3*(cos(q)*tan(q + p)*((cos(q)*(b^2*mr
    //   + Ir)/(l*cos(q + p)) - 2*b*mr*cos(p))/l + mp*sin(q + p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q + p) +
    //   cos(q)*(mp*sin(q + p)*(cos(q) + cos(q)*tan(q + p)^2) - mp*cos(q + p)*(2*sin(q) - cos(q)*tan(q + p))
    //   + (2*b*mr*sin(p) + cos(q)*tan(q + p)*(b^2*mr + Ir)/(l*cos(q + p)))/l)/cos(q +
    //   p))*((r*u^2*(cos(q)*((b*mr*sin(p) + (sin(q)*(b^2*mr + Ir)/l + r*cos(q)*(b*mr*sin(p)/l + (sin(q +
    //   p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) - mp*sin(q))/cos(q
    //   + p)))/cos(q + p))/l + mp*(cos(q)*sin(q + p) + sin(q)/cos(q + p))) - sin(q)*(mp*sin(q)*sin(q + p) +
    //   b*mr*cos(p)/l)) - g*cos(q)*sin(q + p)*(b*mr/l + mp))/cos(q + p) + sin(q)*(mr*g + mp*(g -
    //   2*r*u^2*cos(q))))/(I + r^2*(mr + mp*sin(q)^2 + cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) -
    //   2*b*mr*cos(p))/l + mp*sin(q + p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q + p)))^2
    let u_dot_by_p = u_dot_by_q_of_u_2_4
        * (cos_q_cos_q_plus_p_inv
            * (u_dot_by_q_of_mp_q_2_p_2_2 - mp_sin_q_plus_p * (cos_q + u_dot_by_q_of_q_2_p_2_9)
                - l_inv * sin_p_b_mr.mul_add(S::int(2), u_dot_by_p_of_place))
            - u_dot_by_q_of_q_2_p_2_2 * u_dot_by_q_of_place_14)
        + u_dot_by_q_of_place_15
            * (u_dot_by_q_of_u_2_3
                + cos_q_plus_p_inv
                    * (u_2_r_u_2
                        * (sin_q * (l_inv_sin_p_b_mr - cos_q_plus_p_mp_sin_q)
                            + cos_q
                                * (mp * (cos_q_cos_q_plus_p + u_dot_by_q_of_q_2_p_2_6)
                                    + l_inv
                                        * (cos_p_b_mr + u_dot_by_q_of_place_10
                                            + r_cos_q_cos_q_plus_p_inv
                                                * (l_inv_cos_p_b_mr + u_dot_by_q_of_place_8
                                                    + cos_q_plus_p_inv
                                                        * (u_dot_by_q_of_place_7
                                                            + sin_q_plus_p
                                                                * (l_inv * (sin_p_b_mr + u_dot_by_p_of_place)
                                                                    + mp * u_dot_by_q_of_q_2_p_2_2))))))
                        - cos_q_cos_q_plus_p * u_dot_by_q_of_l_b_mr_mp_g));
    // u_dot_by_u = -2*r^2*u*(2*mp*sin(q)*cos(q) + (sin(q)*(mp*sin(q)*sin(q + p) + b*mr*cos(p)/l) -
    //   cos(q)*((b*mr*sin(p) + (sin(q)*(b^2*mr + Ir)/l + r*cos(q)*(b*mr*sin(p)/l + (sin(q +
    //   p)*(mp*cos(q)/cos(q + p) + (cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - b*mr*cos(p))/l) - mp*sin(q))/cos(q
    //   + p)))/cos(q + p))/l + mp*(cos(q)*sin(q + p) + sin(q)/cos(q + p))))/cos(q + p))/(I + r^2*(mr +
    //   mp*sin(q)^2 + cos(q)*((cos(q)*(b^2*mr + Ir)/(l*cos(q + p)) - 2*b*mr*cos(p))/l + mp*sin(q +
    //   p)*(cos(q)*tan(q + p) - 2*sin(q)))/cos(q + p)))
    let u_dot_by_u = S::int(2) * r_u_2 * u_dot_by_q_of_place_15
        * cos_q_plus_p_inv.mul_add(u_dot_by_q_of_place_13, -mp_sin_q_cos_q_doubled);
    // 1/(sin(q)*sin(p) - cos(q)*cos(p))
    let p_dot_by_q_value_of_q_2_p_2 = S::int(1) / (-cos_q).mul_add(cos_p, sin_q * sin_p);
    let l_inv_r_u_2 = l_inv * r_u_2;
    // Entries that are not zero.
    // d(q')/d(u) = 1
    let q_dot_by_u_value = S::int(1);
    // d(p')/d(q) = -r*u*sin(p)/(l*(sin(q)*sin(p) - cos(q)*cos(p))^2)
    let p_dot_by_q_value = -p_dot_by_q_value_of_q_2_p_2 * p_dot_by_q_value_of_q_2_p_2
        * l_inv_r_u_2 * sin_p;
    // d(p')/d(p) = -r*u*cos(q)*tan(q + p)/(l*cos(q + p))
    let p_dot_by_p_value = -u_dot_by_q_of_q_2_p_2_2 * l_inv_r_u_2;
    // d(p')/d(u) = -1 - r*cos(q)/(l*cos(q + p))
    let p_dot_by_u_value = (-l_inv).mul_add(r_cos_q_cos_q_plus_p_inv, -S::int(1));
    let zero = S::int(0);
    [
        [zero, zero, q_dot_by_u_value],
        [p_dot_by_q_value, p_dot_by_p_value, p_dot_by_u_value],
        [u_dot_by_q, u_dot_by_p, u_dot_by_u],
    ]
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

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 25 convolutions and 60 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 3]],
    history: &mut [Factors<S, 32>],
) {
    let Parameters { r, l, b, I, mr, Ir, mp, g, .. } = *p;
    let [q_2_0, p_2_0, u_2_0] = series[0];
    // Shared terms.
    let l_inv_b_mr = b * mr / l;
    // (b^2*mr + Ir)/l^2
    let b_2_mr_plus_ir_by_l_2_of_l_b_mr_ir = (b * b * mr + Ir) / (l * l);
    // Constant in time.
    // b_2_mr_plus_ir_by_l_2 = (b^2*mr + Ir)/l^2
    let b_2_mr_plus_ir_by_l_2 = b_2_mr_plus_ir_by_l_2_of_l_b_mr_ir;
    // minus_2_b_mr_by_l = -2*b*mr/l
    let minus_2_b_mr_by_l = -S::int(2) * l_inv_b_mr;
    // minus_mp = -mp
    let minus_mp = -mp;
    // i_plus_r_2_mr = I + r^2*mr
    let i_plus_r_2_mr = I + r * r * mr;
    // r_2 = r^2
    let r_2 = r * r;
    // r_2_mp = r^2*mp
    let r_2_mp = r * r * mp;
    // b_mr_by_l = b*mr/l
    let b_mr_by_l = l_inv_b_mr;
    // weight = -(b^2*mr + Ir)/l^2 - mp
    let weight = -b_2_mr_plus_ir_by_l_2_of_l_b_mr_ir - mp;
    // r_by_l = r/l
    let r_by_l = r / l;
    // weight_2 = (b^2*mr + Ir)/l^2 + mp
    let weight_2 = b_2_mr_plus_ir_by_l_2_of_l_b_mr_ir + mp;
    // weight_3 = 2*mp
    let weight_3 = S::int(2) * mp;
    // minus_g_mr_plus_mp = -g*(mr + mp)
    let minus_g_mr_plus_mp = -g * (mr + mp);
    // g_b_mr_by_l_plus_mp = g*(b*mr/l + mp)
    let g_b_mr_by_l_plus_mp = g * (l_inv_b_mr + mp);
    // minus_r = -r
    let minus_r = -r;
    // Order 0.
    let (sin_p_0, cos_p_0) = p_2_0.sin_cos();
    let (sin_q_0, cos_q_0) = q_2_0.sin_cos();
    let q_2_plus_p_2_0 = q_2_0 + p_2_0;
    let (sin_q_plus_p_0, cos_q_plus_p_0) = q_2_plus_p_2_0.sin_cos();
    let over_cos_q_plus_p = S::int(1) / cos_q_plus_p_0;
    let cos_q_cos_q_plus_p_inv_0 = cos_q_0 * over_cos_q_plus_p;
    let u_dot_of_q_2_p_2_0 = sin_q_plus_p_0 * cos_q_cos_q_plus_p_inv_0;
    let u_dot_of_q_2_p_2_2_0 = S::int(2) * sin_q_0 - u_dot_of_q_2_p_2_0;
    let u_dot_of_q_2_p_2_3_0 = sin_q_plus_p_0 * u_dot_of_q_2_p_2_2_0;
    let u_dot_of_place_0 = u_dot_of_q_2_p_2_3_0
        .mul_add(
            minus_mp,
            cos_q_cos_q_plus_p_inv_0
                .mul_add(b_2_mr_plus_ir_by_l_2, minus_2_b_mr_by_l * cos_p_0),
        );
    let u_dot_of_place_2_0 = u_dot_of_place_0 * cos_q_cos_q_plus_p_inv_0;
    let sin_q_sq_0 = sin_q_0 * sin_q_0;
    let u_dot_of_place_3_0 = u_dot_of_place_2_0
        .mul_add(r_2, sin_q_sq_0.mul_add(r_2_mp, i_plus_r_2_mr));
    let over_u_dot_of_place_3 = S::int(1) / u_dot_of_place_3_0;
    let sin_q_sin_q_plus_p_0 = sin_q_0 * sin_q_plus_p_0;
    let u_dot_of_place_4_0 = sin_q_sin_q_plus_p_0.mul_add(mp, b_mr_by_l * cos_p_0);
    let u_dot_of_place_5_0 = sin_q_0 * u_dot_of_place_4_0;
    let sin_q_cos_q_0 = sin_q_0 * cos_q_0;
    let cos_q_sin_q_plus_p_0 = cos_q_0 * sin_q_plus_p_0;
    let u_dot_of_place_6_0 = cos_q_cos_q_plus_p_inv_0
        .mul_add(weight, b_mr_by_l * cos_p_0);
    let u_dot_of_place_7_0 = sin_q_plus_p_0 * u_dot_of_place_6_0;
    let u_dot_of_place_8_0 = mp * sin_q_0 + u_dot_of_place_7_0;
    let u_dot_of_place_9_0 = u_dot_of_place_8_0 * over_cos_q_plus_p;
    let u_dot_of_place_10_0 = b_mr_by_l * sin_p_0 - u_dot_of_place_9_0;
    let u_dot_of_place_11_0 = cos_q_0 * u_dot_of_place_10_0;
    let u_dot_of_place_12_0 = u_dot_of_place_11_0.mul_add(r_by_l, weight_2 * sin_q_0);
    let u_dot_of_place_13_0 = u_dot_of_place_12_0 * over_cos_q_plus_p;
    let u_dot_of_place_14_0 = cos_q_sin_q_plus_p_0.mul_add(mp, b_mr_by_l * sin_p_0)
        + u_dot_of_place_13_0;
    let u_dot_of_place_15_0 = cos_q_0 * u_dot_of_place_14_0;
    let u_dot_of_place_16_0 = u_dot_of_place_5_0 - u_dot_of_place_15_0;
    let u_dot_of_place_17_0 = u_dot_of_place_16_0 * over_cos_q_plus_p;
    let u_dot_of_place_18_0 = weight_3 * sin_q_cos_q_0 + u_dot_of_place_17_0;
    let u_2_sq_0 = u_2_0 * u_2_0;
    let u_dot_of_u_2_0 = u_dot_of_place_18_0 * u_2_sq_0;
    let u_dot_of_u_2_2_0 = u_dot_of_u_2_0
        .mul_add(
            r,
            u_dot_of_q_2_p_2_0.mul_add(g_b_mr_by_l_plus_mp, minus_g_mr_plus_mp * sin_q_0),
        );
    let u_dot_of_u_2_3_0 = u_dot_of_u_2_2_0 * over_u_dot_of_place_3;
    let p_2_of_r_l_q_2_p_2_0 = cos_q_cos_q_plus_p_inv_0.mul_add(r_by_l, S::int(1));
    let p_2_of_u_2_0 = u_2_0 * p_2_of_r_l_q_2_p_2_0;
    // Order 1: the rates, and what follows from them.
    let q_2_1 = u_2_0;
    let p_2_1 = -p_2_of_u_2_0;
    let u_2_1 = minus_r * u_dot_of_u_2_3_0;
    if series.len() > 1 {
        series[1] = [q_2_1, p_2_1, u_2_1];
    }
    let sin_p_1 = p_2_1 * cos_p_0;
    let cos_p_1 = -p_2_1 * sin_p_0;
    let sin_q_1 = q_2_1 * cos_q_0;
    let cos_q_1 = -q_2_1 * sin_q_0;
    let q_2_plus_p_2_1 = q_2_1 + p_2_1;
    let sin_q_plus_p_1 = q_2_plus_p_2_1 * cos_q_plus_p_0;
    let cos_q_plus_p_1 = -q_2_plus_p_2_1 * sin_q_plus_p_0;
    let cos_q_cos_q_plus_p_inv_1 = cos_q_plus_p_1
        .mul_add(
            -(cos_q_cos_q_plus_p_inv_0 * over_cos_q_plus_p),
            cos_q_1 * over_cos_q_plus_p,
        );
    let u_dot_of_q_2_p_2_1 = cos_q_cos_q_plus_p_inv_1
        .mul_add(sin_q_plus_p_0, sin_q_plus_p_1 * cos_q_cos_q_plus_p_inv_0);
    let u_dot_of_q_2_p_2_2_1 = S::int(2) * sin_q_1 - u_dot_of_q_2_p_2_1;
    let u_dot_of_q_2_p_2_3_1 = u_dot_of_q_2_p_2_2_1
        .mul_add(sin_q_plus_p_0, sin_q_plus_p_1 * u_dot_of_q_2_p_2_2_0);
    let u_dot_of_place_1 = u_dot_of_q_2_p_2_3_1
        .mul_add(
            minus_mp,
            cos_q_cos_q_plus_p_inv_1
                .mul_add(b_2_mr_plus_ir_by_l_2, minus_2_b_mr_by_l * cos_p_1),
        );
    let u_dot_of_place_2_1 = u_dot_of_place_1
        .mul_add(cos_q_cos_q_plus_p_inv_0, cos_q_cos_q_plus_p_inv_1 * u_dot_of_place_0);
    let sin_q_sq_1 = sin_q_1 * (sin_q_0 + sin_q_0);
    let u_dot_of_place_3_1 = u_dot_of_place_2_1.mul_add(r_2, r_2_mp * sin_q_sq_1);
    let sin_q_sin_q_plus_p_1 = sin_q_plus_p_1.mul_add(sin_q_0, sin_q_1 * sin_q_plus_p_0);
    let u_dot_of_place_4_1 = sin_q_sin_q_plus_p_1.mul_add(mp, b_mr_by_l * cos_p_1);
    let u_dot_of_place_5_1 = u_dot_of_place_4_1
        .mul_add(sin_q_0, sin_q_1 * u_dot_of_place_4_0);
    let sin_q_cos_q_1 = cos_q_1.mul_add(sin_q_0, sin_q_1 * cos_q_0);
    let cos_q_sin_q_plus_p_1 = sin_q_plus_p_1.mul_add(cos_q_0, cos_q_1 * sin_q_plus_p_0);
    let u_dot_of_place_6_1 = cos_q_cos_q_plus_p_inv_1
        .mul_add(weight, b_mr_by_l * cos_p_1);
    let u_dot_of_place_7_1 = u_dot_of_place_6_1
        .mul_add(sin_q_plus_p_0, sin_q_plus_p_1 * u_dot_of_place_6_0);
    let u_dot_of_place_8_1 = mp * sin_q_1 + u_dot_of_place_7_1;
    let u_dot_of_place_9_1 = cos_q_plus_p_1
        .mul_add(
            -(u_dot_of_place_9_0 * over_cos_q_plus_p),
            u_dot_of_place_8_1 * over_cos_q_plus_p,
        );
    let u_dot_of_place_10_1 = b_mr_by_l * sin_p_1 - u_dot_of_place_9_1;
    let u_dot_of_place_11_1 = u_dot_of_place_10_1
        .mul_add(cos_q_0, cos_q_1 * u_dot_of_place_10_0);
    let u_dot_of_place_12_1 = u_dot_of_place_11_1.mul_add(r_by_l, weight_2 * sin_q_1);
    let u_dot_of_place_13_1 = cos_q_plus_p_1
        .mul_add(
            -(u_dot_of_place_13_0 * over_cos_q_plus_p),
            u_dot_of_place_12_1 * over_cos_q_plus_p,
        );
    let u_dot_of_place_14_1 = cos_q_sin_q_plus_p_1.mul_add(mp, b_mr_by_l * sin_p_1)
        + u_dot_of_place_13_1;
    let u_dot_of_place_15_1 = u_dot_of_place_14_1
        .mul_add(cos_q_0, cos_q_1 * u_dot_of_place_14_0);
    let u_dot_of_place_16_1 = u_dot_of_place_5_1 - u_dot_of_place_15_1;
    let u_dot_of_place_17_1 = cos_q_plus_p_1
        .mul_add(
            -(u_dot_of_place_17_0 * over_cos_q_plus_p),
            u_dot_of_place_16_1 * over_cos_q_plus_p,
        );
    let u_dot_of_place_18_1 = weight_3 * sin_q_cos_q_1 + u_dot_of_place_17_1;
    let u_2_sq_1 = u_2_1 * (u_2_0 + u_2_0);
    let u_dot_of_u_2_1 = u_dot_of_place_18_1
        .mul_add(u_2_sq_0, u_2_sq_1 * u_dot_of_place_18_0);
    let u_dot_of_u_2_2_1 = u_dot_of_u_2_1
        .mul_add(
            r,
            u_dot_of_q_2_p_2_1.mul_add(g_b_mr_by_l_plus_mp, minus_g_mr_plus_mp * sin_q_1),
        );
    let u_dot_of_u_2_3_1 = u_dot_of_place_3_1
        .mul_add(
            -(u_dot_of_u_2_3_0 * over_u_dot_of_place_3),
            u_dot_of_u_2_2_1 * over_u_dot_of_place_3,
        );
    let p_2_of_r_l_q_2_p_2_1 = r_by_l * cos_q_cos_q_plus_p_inv_1;
    let p_2_of_u_2_1 = p_2_of_r_l_q_2_p_2_1.mul_add(u_2_0, u_2_1 * p_2_of_r_l_q_2_p_2_0);
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                p_2_1, p_2_1, q_2_1, q_2_1, q_2_plus_p_2_1, q_2_plus_p_2_1, cos_q_plus_p_1,
                sin_q_plus_p_1, sin_q_plus_p_1, u_dot_of_place_1, sin_q_1, sin_q_1, sin_q_1,
                sin_q_1, cos_q_1, sin_q_plus_p_1, cos_q_plus_p_1, cos_q_1, cos_q_plus_p_1, cos_q_1,
                cos_q_plus_p_1, u_2_1, u_dot_of_place_18_1, u_dot_of_place_3_1, u_2_1,
            ]),
            padded([
                cos_p_1, sin_p_1, cos_q_1, sin_q_1, cos_q_plus_p_1, sin_q_plus_p_1,
                cos_q_cos_q_plus_p_inv_1, cos_q_cos_q_plus_p_inv_1, u_dot_of_q_2_p_2_2_1,
                cos_q_cos_q_plus_p_inv_1, sin_q_1, sin_q_plus_p_1, u_dot_of_place_4_1, cos_q_1,
                sin_q_plus_p_1, u_dot_of_place_6_1, u_dot_of_place_9_1, u_dot_of_place_10_1,
                u_dot_of_place_13_1, u_dot_of_place_14_1, u_dot_of_place_17_1, u_2_1, u_2_sq_1,
                u_dot_of_u_2_3_1, p_2_of_r_l_q_2_p_2_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q_2_last = q_2_1;
    let mut p_2_last = p_2_1;
    let mut u_2_last = u_2_1;
    let mut sin_p_last = sin_p_1;
    let mut cos_p_last = cos_p_1;
    let mut sin_q_last = sin_q_1;
    let mut cos_q_last = cos_q_1;
    let mut q_2_plus_p_2_last = q_2_plus_p_2_1;
    let mut sin_q_plus_p_last = sin_q_plus_p_1;
    let mut cos_q_plus_p_last = cos_q_plus_p_1;
    let mut cos_q_cos_q_plus_p_inv_last = cos_q_cos_q_plus_p_inv_1;
    let mut u_dot_of_q_2_p_2_2_last = u_dot_of_q_2_p_2_2_1;
    let mut u_dot_of_place_last = u_dot_of_place_1;
    let mut u_dot_of_place_3_last = u_dot_of_place_3_1;
    let mut u_dot_of_place_4_last = u_dot_of_place_4_1;
    let mut u_dot_of_place_6_last = u_dot_of_place_6_1;
    let mut u_dot_of_place_9_last = u_dot_of_place_9_1;
    let mut u_dot_of_place_10_last = u_dot_of_place_10_1;
    let mut u_dot_of_place_13_last = u_dot_of_place_13_1;
    let mut u_dot_of_place_14_last = u_dot_of_place_14_1;
    let mut u_dot_of_place_17_last = u_dot_of_place_17_1;
    let mut u_dot_of_place_18_last = u_dot_of_place_18_1;
    let mut u_2_sq_last = u_2_sq_1;
    let mut u_dot_of_u_2_3_last = u_dot_of_u_2_3_1;
    let mut p_2_of_r_l_q_2_p_2_last = p_2_of_r_l_q_2_p_2_1;
    let mut next = [S::int(0); 32];
    // Rates at order k - 1.
    let mut q_2_rate = u_2_1;
    let mut p_2_rate = -p_2_of_u_2_1;
    let mut u_2_rate = minus_r * u_dot_of_u_2_3_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q_2 = q_2_rate * over_k;
        let p_2 = p_2_rate * over_k;
        let u_2 = u_2_rate * over_k;
        series[order] = [q_2, p_2, u_2];
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
                p_2_1
                    .mul_add(
                        cos_p_last,
                        (count_last * p_2_last).mul_add(cos_p_1, next[0]),
                    ),
                p_2_1
                    .mul_add(
                        sin_p_last,
                        (count_last * p_2_last).mul_add(sin_p_1, next[1]),
                    ),
                q_2_1
                    .mul_add(
                        cos_q_last,
                        (count_last * q_2_last).mul_add(cos_q_1, next[2]),
                    ),
                q_2_1
                    .mul_add(
                        sin_q_last,
                        (count_last * q_2_last).mul_add(sin_q_1, next[3]),
                    ),
                q_2_plus_p_2_1
                    .mul_add(
                        cos_q_plus_p_last,
                        (count_last * q_2_plus_p_2_last).mul_add(cos_q_plus_p_1, next[4]),
                    ),
                q_2_plus_p_2_1
                    .mul_add(
                        sin_q_plus_p_last,
                        (count_last * q_2_plus_p_2_last).mul_add(sin_q_plus_p_1, next[5]),
                    ),
                cos_q_plus_p_1
                    .mul_add(
                        cos_q_cos_q_plus_p_inv_last,
                        cos_q_plus_p_last.mul_add(cos_q_cos_q_plus_p_inv_1, next[6]),
                    ),
                sin_q_plus_p_1
                    .mul_add(
                        cos_q_cos_q_plus_p_inv_last,
                        sin_q_plus_p_last.mul_add(cos_q_cos_q_plus_p_inv_1, next[7]),
                    ),
                sin_q_plus_p_1
                    .mul_add(
                        u_dot_of_q_2_p_2_2_last,
                        sin_q_plus_p_last.mul_add(u_dot_of_q_2_p_2_2_1, next[8]),
                    ),
                u_dot_of_place_1
                    .mul_add(
                        cos_q_cos_q_plus_p_inv_last,
                        u_dot_of_place_last.mul_add(cos_q_cos_q_plus_p_inv_1, next[9]),
                    ),
                (sin_q_1 + sin_q_1).mul_add(sin_q_last, next[10]),
                sin_q_1
                    .mul_add(
                        sin_q_plus_p_last,
                        sin_q_last.mul_add(sin_q_plus_p_1, next[11]),
                    ),
                sin_q_1
                    .mul_add(
                        u_dot_of_place_4_last,
                        sin_q_last.mul_add(u_dot_of_place_4_1, next[12]),
                    ),
                sin_q_1.mul_add(cos_q_last, sin_q_last.mul_add(cos_q_1, next[13])),
                cos_q_1
                    .mul_add(
                        sin_q_plus_p_last,
                        cos_q_last.mul_add(sin_q_plus_p_1, next[14]),
                    ),
                sin_q_plus_p_1
                    .mul_add(
                        u_dot_of_place_6_last,
                        sin_q_plus_p_last.mul_add(u_dot_of_place_6_1, next[15]),
                    ),
                cos_q_plus_p_1
                    .mul_add(
                        u_dot_of_place_9_last,
                        cos_q_plus_p_last.mul_add(u_dot_of_place_9_1, next[16]),
                    ),
                cos_q_1
                    .mul_add(
                        u_dot_of_place_10_last,
                        cos_q_last.mul_add(u_dot_of_place_10_1, next[17]),
                    ),
                cos_q_plus_p_1
                    .mul_add(
                        u_dot_of_place_13_last,
                        cos_q_plus_p_last.mul_add(u_dot_of_place_13_1, next[18]),
                    ),
                cos_q_1
                    .mul_add(
                        u_dot_of_place_14_last,
                        cos_q_last.mul_add(u_dot_of_place_14_1, next[19]),
                    ),
                cos_q_plus_p_1
                    .mul_add(
                        u_dot_of_place_17_last,
                        cos_q_plus_p_last.mul_add(u_dot_of_place_17_1, next[20]),
                    ),
                (u_2_1 + u_2_1).mul_add(u_2_last, next[21]),
                u_dot_of_place_18_1
                    .mul_add(
                        u_2_sq_last,
                        u_dot_of_place_18_last.mul_add(u_2_sq_1, next[22]),
                    ),
                u_dot_of_place_3_1
                    .mul_add(
                        u_dot_of_u_2_3_last,
                        u_dot_of_place_3_last.mul_add(u_dot_of_u_2_3_1, next[23]),
                    ),
                u_2_1
                    .mul_add(
                        p_2_of_r_l_q_2_p_2_last,
                        u_2_last.mul_add(p_2_of_r_l_q_2_p_2_1, next[24]),
                    ),
            ])
        };
        // sin_p = sin(p_2)
        let sin_p = p_2.mul_add(cos_p_0, sums[0] * over_k);
        // cos_p = cos(p_2)
        let cos_p = -p_2.mul_add(sin_p_0, sums[1] * over_k);
        // sin_q = sin(q_2)
        let sin_q = q_2.mul_add(cos_q_0, sums[2] * over_k);
        // cos_q = cos(q_2)
        let cos_q = -q_2.mul_add(sin_q_0, sums[3] * over_k);
        // q_2_plus_p_2 = q_2 + p_2
        let q_2_plus_p_2 = q_2 + p_2;
        // sin_q_plus_p = sin(q_2_plus_p_2)
        let sin_q_plus_p = q_2_plus_p_2.mul_add(cos_q_plus_p_0, sums[4] * over_k);
        // cos_q_plus_p = cos(q_2_plus_p_2)
        let cos_q_plus_p = -q_2_plus_p_2.mul_add(sin_q_plus_p_0, sums[5] * over_k);
        // cos_q_cos_q_plus_p_inv = cos_q/cos_q_plus_p
        let cos_q_cos_q_plus_p_inv = cos_q_plus_p
            .mul_add(
                -(cos_q_cos_q_plus_p_inv_0 * over_cos_q_plus_p),
                (cos_q - sums[6]) * over_cos_q_plus_p,
            );
        // u_dot_of_q_2_p_2 = sin_q_plus_p*cos_q_cos_q_plus_p_inv
        let u_dot_of_q_2_p_2 = cos_q_cos_q_plus_p_inv
            .mul_add(
                sin_q_plus_p_0,
                sin_q_plus_p.mul_add(cos_q_cos_q_plus_p_inv_0, sums[7]),
            );
        // u_dot_of_q_2_p_2_2 = 2*sin_q - u_dot_of_q_2_p_2
        let u_dot_of_q_2_p_2_2 = S::int(2) * sin_q - u_dot_of_q_2_p_2;
        // u_dot_of_q_2_p_2_3 = sin_q_plus_p*u_dot_of_q_2_p_2_2
        let u_dot_of_q_2_p_2_3 = u_dot_of_q_2_p_2_2
            .mul_add(
                sin_q_plus_p_0,
                sin_q_plus_p.mul_add(u_dot_of_q_2_p_2_2_0, sums[8]),
            );
        // u_dot_of_place = b_2_mr_plus_ir_by_l_2*cos_q_cos_q_plus_p_inv + minus_2_b_mr_by_l*cos_p +
        //   minus_mp*u_dot_of_q_2_p_2_3
        let u_dot_of_place = u_dot_of_q_2_p_2_3
            .mul_add(
                minus_mp,
                cos_q_cos_q_plus_p_inv
                    .mul_add(b_2_mr_plus_ir_by_l_2, minus_2_b_mr_by_l * cos_p),
            );
        // u_dot_of_place_2 = u_dot_of_place*cos_q_cos_q_plus_p_inv
        let u_dot_of_place_2 = u_dot_of_place
            .mul_add(
                cos_q_cos_q_plus_p_inv_0,
                cos_q_cos_q_plus_p_inv.mul_add(u_dot_of_place_0, sums[9]),
            );
        // sin_q_sq = sin_q*sin_q
        let sin_q_sq = sin_q.mul_add(sin_q_0 + sin_q_0, sums[10]);
        // u_dot_of_place_3 = i_plus_r_2_mr + r_2*u_dot_of_place_2 + r_2_mp*sin_q_sq
        let u_dot_of_place_3 = u_dot_of_place_2.mul_add(r_2, r_2_mp * sin_q_sq);
        // sin_q_sin_q_plus_p = sin_q*sin_q_plus_p
        let sin_q_sin_q_plus_p = sin_q_plus_p
            .mul_add(sin_q_0, sin_q.mul_add(sin_q_plus_p_0, sums[11]));
        // u_dot_of_place_4 = b_mr_by_l*cos_p + mp*sin_q_sin_q_plus_p
        let u_dot_of_place_4 = sin_q_sin_q_plus_p.mul_add(mp, b_mr_by_l * cos_p);
        // u_dot_of_place_5 = sin_q*u_dot_of_place_4
        let u_dot_of_place_5 = u_dot_of_place_4
            .mul_add(sin_q_0, sin_q.mul_add(u_dot_of_place_4_0, sums[12]));
        // sin_q_cos_q = sin_q*cos_q
        let sin_q_cos_q = cos_q.mul_add(sin_q_0, sin_q.mul_add(cos_q_0, sums[13]));
        // cos_q_sin_q_plus_p = cos_q*sin_q_plus_p
        let cos_q_sin_q_plus_p = sin_q_plus_p
            .mul_add(cos_q_0, cos_q.mul_add(sin_q_plus_p_0, sums[14]));
        // u_dot_of_place_6 = b_mr_by_l*cos_p + weight*cos_q_cos_q_plus_p_inv
        let u_dot_of_place_6 = cos_q_cos_q_plus_p_inv.mul_add(weight, b_mr_by_l * cos_p);
        // u_dot_of_place_7 = sin_q_plus_p*u_dot_of_place_6
        let u_dot_of_place_7 = u_dot_of_place_6
            .mul_add(sin_q_plus_p_0, sin_q_plus_p.mul_add(u_dot_of_place_6_0, sums[15]));
        // u_dot_of_place_8 = mp*sin_q + u_dot_of_place_7
        let u_dot_of_place_8 = mp * sin_q + u_dot_of_place_7;
        // u_dot_of_place_9 = u_dot_of_place_8/cos_q_plus_p
        let u_dot_of_place_9 = u_dot_of_place_8
            .mul_add(
                over_cos_q_plus_p,
                -(cos_q_plus_p.mul_add(u_dot_of_place_9_0, sums[16]) * over_cos_q_plus_p),
            );
        // u_dot_of_place_10 = b_mr_by_l*sin_p - u_dot_of_place_9
        let u_dot_of_place_10 = b_mr_by_l * sin_p - u_dot_of_place_9;
        // u_dot_of_place_11 = cos_q*u_dot_of_place_10
        let u_dot_of_place_11 = u_dot_of_place_10
            .mul_add(cos_q_0, cos_q.mul_add(u_dot_of_place_10_0, sums[17]));
        // u_dot_of_place_12 = r_by_l*u_dot_of_place_11 + weight_2*sin_q
        let u_dot_of_place_12 = u_dot_of_place_11.mul_add(r_by_l, weight_2 * sin_q);
        // u_dot_of_place_13 = u_dot_of_place_12/cos_q_plus_p
        let u_dot_of_place_13 = u_dot_of_place_12
            .mul_add(
                over_cos_q_plus_p,
                -(cos_q_plus_p.mul_add(u_dot_of_place_13_0, sums[18]) * over_cos_q_plus_p),
            );
        // u_dot_of_place_14 = b_mr_by_l*sin_p + mp*cos_q_sin_q_plus_p + u_dot_of_place_13
        let u_dot_of_place_14 = cos_q_sin_q_plus_p.mul_add(mp, b_mr_by_l * sin_p)
            + u_dot_of_place_13;
        // u_dot_of_place_15 = cos_q*u_dot_of_place_14
        let u_dot_of_place_15 = u_dot_of_place_14
            .mul_add(cos_q_0, cos_q.mul_add(u_dot_of_place_14_0, sums[19]));
        // u_dot_of_place_16 = u_dot_of_place_5 - u_dot_of_place_15
        let u_dot_of_place_16 = u_dot_of_place_5 - u_dot_of_place_15;
        // u_dot_of_place_17 = u_dot_of_place_16/cos_q_plus_p
        let u_dot_of_place_17 = u_dot_of_place_16
            .mul_add(
                over_cos_q_plus_p,
                -(cos_q_plus_p.mul_add(u_dot_of_place_17_0, sums[20]) * over_cos_q_plus_p),
            );
        // u_dot_of_place_18 = weight_3*sin_q_cos_q + u_dot_of_place_17
        let u_dot_of_place_18 = weight_3 * sin_q_cos_q + u_dot_of_place_17;
        // u_2_sq = u_2*u_2
        let u_2_sq = u_2.mul_add(u_2_0 + u_2_0, sums[21]);
        // u_dot_of_u_2 = u_dot_of_place_18*u_2_sq
        let u_dot_of_u_2 = u_dot_of_place_18
            .mul_add(u_2_sq_0, u_2_sq.mul_add(u_dot_of_place_18_0, sums[22]));
        // u_dot_of_u_2_2 = r*u_dot_of_u_2 + minus_g_mr_plus_mp*sin_q +
        //   g_b_mr_by_l_plus_mp*u_dot_of_q_2_p_2
        let u_dot_of_u_2_2 = u_dot_of_u_2
            .mul_add(
                r,
                u_dot_of_q_2_p_2.mul_add(g_b_mr_by_l_plus_mp, minus_g_mr_plus_mp * sin_q),
            );
        // u_dot_of_u_2_3 = u_dot_of_u_2_2/u_dot_of_place_3
        let u_dot_of_u_2_3 = u_dot_of_u_2_2
            .mul_add(
                over_u_dot_of_place_3,
                -(u_dot_of_place_3.mul_add(u_dot_of_u_2_3_0, sums[23]) * over_u_dot_of_place_3),
            );
        // p_2_of_r_l_q_2_p_2 = 1 + r_by_l*cos_q_cos_q_plus_p_inv
        let p_2_of_r_l_q_2_p_2 = r_by_l * cos_q_cos_q_plus_p_inv;
        // p_2_of_u_2 = u_2*p_2_of_r_l_q_2_p_2
        let p_2_of_u_2 = p_2_of_r_l_q_2_p_2
            .mul_add(u_2_0, u_2.mul_add(p_2_of_r_l_q_2_p_2_0, sums[24]));
        q_2_rate = u_2;
        p_2_rate = -p_2_of_u_2;
        u_2_rate = minus_r * u_dot_of_u_2_3;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * p_2,
                count * p_2,
                count * q_2,
                count * q_2,
                count * q_2_plus_p_2,
                count * q_2_plus_p_2,
                cos_q_plus_p, sin_q_plus_p, sin_q_plus_p, u_dot_of_place, sin_q, sin_q, sin_q,
                sin_q, cos_q, sin_q_plus_p, cos_q_plus_p, cos_q, cos_q_plus_p, cos_q, cos_q_plus_p,
                u_2, u_dot_of_place_18, u_dot_of_place_3, u_2,
            ]),
            padded([
                cos_p, sin_p, cos_q, sin_q, cos_q_plus_p, sin_q_plus_p, cos_q_cos_q_plus_p_inv,
                cos_q_cos_q_plus_p_inv, u_dot_of_q_2_p_2_2, cos_q_cos_q_plus_p_inv, sin_q,
                sin_q_plus_p, u_dot_of_place_4, cos_q, sin_q_plus_p, u_dot_of_place_6,
                u_dot_of_place_9, u_dot_of_place_10, u_dot_of_place_13, u_dot_of_place_14,
                u_dot_of_place_17, u_2, u_2_sq, u_dot_of_u_2_3, p_2_of_r_l_q_2_p_2,
            ]),
        ];
        count_last = count;
        q_2_last = q_2;
        p_2_last = p_2;
        u_2_last = u_2;
        sin_p_last = sin_p;
        cos_p_last = cos_p;
        sin_q_last = sin_q;
        cos_q_last = cos_q;
        q_2_plus_p_2_last = q_2_plus_p_2;
        sin_q_plus_p_last = sin_q_plus_p;
        cos_q_plus_p_last = cos_q_plus_p;
        cos_q_cos_q_plus_p_inv_last = cos_q_cos_q_plus_p_inv;
        u_dot_of_q_2_p_2_2_last = u_dot_of_q_2_p_2_2;
        u_dot_of_place_last = u_dot_of_place;
        u_dot_of_place_3_last = u_dot_of_place_3;
        u_dot_of_place_4_last = u_dot_of_place_4;
        u_dot_of_place_6_last = u_dot_of_place_6;
        u_dot_of_place_9_last = u_dot_of_place_9;
        u_dot_of_place_10_last = u_dot_of_place_10;
        u_dot_of_place_13_last = u_dot_of_place_13;
        u_dot_of_place_14_last = u_dot_of_place_14;
        u_dot_of_place_17_last = u_dot_of_place_17;
        u_dot_of_place_18_last = u_dot_of_place_18;
        u_2_sq_last = u_2_sq;
        u_dot_of_u_2_3_last = u_dot_of_u_2_3;
        p_2_of_r_l_q_2_p_2_last = p_2_of_r_l_q_2_p_2;
    }
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
        out.copy_from_slice(
            jacobian(&Parameters::from_slice(p), array(q), array(v)).as_flattened(),
        );
    }
    fn has_taylor(&self) -> bool {
        true
    }
    fn taylor_work(&self, order: usize) -> usize {
        64 * order + SLACK
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
    slice.try_into().expect("a slice of the length that System states")
}
