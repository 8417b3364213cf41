//! Slider-crank: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/slider_crank/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::series::{Factors, SLACK, padded, pair_sums, rows};
use tripos_traits::{Lengths, Scalar, System};

/// Matrix of the linear system [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')); rows q, p, constraint wrist_1.
///
/// 32 operations, 2 sines and cosines.
#[must_use]
pub fn mass_matrix<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    _q_dot: &[S; 2],
) -> [[S; 3]; 3] {
    let Parameters { r, l, b, I, mr, Ir, mp, .. } = *p;
    let [q_2, p_2] = *q;
    // Sines and cosines.
    let (sin_p, cos_p) = p_2.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    // Shared terms.
    // cos(q)*sin(p) + sin(q)*cos(p)
    let sin_q_plus_p = sin_q.mul_add(cos_p, cos_q * sin_p);
    let l_sin_q_plus_p = l * sin_q_plus_p;
    let b_mr = b * mr;
    // mp*l_sin_q_plus_p^2 + b*b_mr
    let m11_of_place = b.mul_add(b_mr, mp * l_sin_q_plus_p * l_sin_q_plus_p);
    // Ir + m11_of_place
    let ir_plus_m11_of_place = Ir + m11_of_place;
    let mp_sin_q = mp * sin_q;
    // r*(b_mr*cos(p) + l_sin_q_plus_p*mp_sin_q)
    let m11_of_place_2 = r * l_sin_q_plus_p.mul_add(mp_sin_q, b_mr * cos_p);
    // ir_plus_m11_of_place + m11_of_place_2
    let m12_of_place = ir_plus_m11_of_place + m11_of_place_2;
    // cos(q)*cos(p) - sin(q)*sin(p)
    let cos_q_plus_p = (-sin_q).mul_add(sin_p, cos_q * cos_p);
    let l_cos_q_plus_p = l * cos_q_plus_p;
    // r*cos(q) + l_cos_q_plus_p
    let m13_of_r_l_q_2_p_2 = r.mul_add(cos_q, l_cos_q_plus_p);
    // Entries that are not zero.
    // M11 = I + r^2*mr + b^2*mr + Ir + 2*r*b*mr*cos(p) + mp*(r*sin(q) + l*sin(q + p))^2
    let m11 = I + ir_plus_m11_of_place + r * r * mp_sin_q.mul_add(sin_q, mr)
        + S::int(2) * m11_of_place_2;
    // M12 = b^2*mr + Ir + r*b*mr*cos(p) + l*mp*sin(q + p)*(r*sin(q) + l*sin(q + p))
    let m12 = m12_of_place;
    // M13 = -r*cos(q) - l*cos(q + p)
    let m13 = -m13_of_r_l_q_2_p_2;
    // M21 = b^2*mr + Ir + r*b*mr*cos(p) + l*mp*sin(q + p)*(r*sin(q) + l*sin(q + p))
    let m21 = m12_of_place;
    // M22 = b^2*mr + Ir + l^2*mp*sin(q + p)^2
    let m22 = ir_plus_m11_of_place;
    // M23 = -l*cos(q + p)
    let m23 = -l_cos_q_plus_p;
    // M31 = r*cos(q) + l*cos(q + p)
    let m31 = m13_of_r_l_q_2_p_2;
    // M32 = l*cos(q + p)
    let m32 = l_cos_q_plus_p;
    let zero = S::int(0);
    [[m11, m12, m13], [m21, m22, m23], [m31, m32, zero]]
}

/// Right-hand side of the linear system; unknowns (q'', p'', lambda_wrist_1).
///
/// 40 operations, 2 sines and cosines.
#[must_use]
pub fn forcing<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> [S; 3] {
    let Parameters { r, l, b, mr, mp, g, .. } = *p;
    let [q_2, p_2] = *q;
    let [q_dot_2, p_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    let (sin_p, cos_p) = p_2.sin_cos();
    // Shared terms.
    let r_sin_q = r * sin_q;
    // cos(q)*sin(p) + sin(q)*cos(p)
    let sin_q_plus_p = sin_q.mul_add(cos_p, cos_q * sin_p);
    let l_sin_q_plus_p = l * sin_q_plus_p;
    // r_sin_q + l_sin_q_plus_p
    let f1_of_r_l_q_2_p_2 = r_sin_q + l_sin_q_plus_p;
    // cos(q)*cos(p) - sin(q)*sin(p)
    let cos_q_plus_p = (-sin_q).mul_add(sin_p, cos_q * cos_p);
    let l_cos_q_plus_p = l * cos_q_plus_p;
    let q_dot_2_sq = q_dot_2 * q_dot_2;
    // p'*(2*q' + p')
    let f1_of_motion = p_dot * q_dot_2.mul_add(S::int(2), p_dot);
    // q_dot_2_sq*(r*cos(q) + l_cos_q_plus_p) + l_cos_q_plus_p*f1_of_motion
    let f1_of_motion_2 = q_dot_2_sq * r.mul_add(cos_q, l_cos_q_plus_p)
        + l_cos_q_plus_p * f1_of_motion;
    // mp*(g - f1_of_motion_2)
    let f1_of_motion_3 = mp * (g - f1_of_motion_2);
    let b_mr = b * mr;
    let r_sin_p_b_mr = r * b_mr * sin_p;
    let g_sin_q_plus_p_b_mr = g * sin_q_plus_p * b_mr;
    // Values.
    // f1 = b*mr*g*sin(q + p) - mp*(r^2*q'^2*sin(q)*cos(q) + l*(sin(q + p)*(r*q'^2*cos(q) - g) + cos(q +
    //   p)*(p'^2*(r*sin(q) + l*sin(q + p)) + q'*(r*sin(q)*(q' + 2*p') + l*sin(q + p)*(q' + 2*p'))))) +
    //   r*(g*sin(q)*(mr + mp) + b*mr*p'*sin(p)*(2*q' + p'))
    let f1 = f1_of_r_l_q_2_p_2.mul_add(f1_of_motion_3, mr * g * r_sin_q)
        + f1_of_motion * r_sin_p_b_mr + g_sin_q_plus_p_b_mr;
    // f2 = sin(q + p)*(b*mr*g + l*mp*(g - r*q'^2*cos(q) - l*cos(q + p)*(p'^2 + q'*(q' + 2*p')))) -
    //   r*b*mr*q'^2*sin(p)
    let f2 = (-q_dot_2_sq).mul_add(r_sin_p_b_mr, l_sin_q_plus_p * f1_of_motion_3)
        + g_sin_q_plus_p_b_mr;
    // f3 = r*q'^2*sin(q) + l*sin(q + p)*(q' + p')^2
    let f3 = l_sin_q_plus_p.mul_add(f1_of_motion, f1_of_r_l_q_2_p_2 * q_dot_2_sq);
    [f1, f2, f3]
}

/// The accelerations (q'', p''), solved for when this code was generated.
///
/// 95 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn accelerations<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let Parameters { r, l, b, I, mr, Ir, mp, g, .. } = *p;
    let [q_2, p_2] = *q;
    let [q_dot_2, p_dot] = *q_dot;
    // Sines and cosines.
    let (sin_p, cos_p) = p_2.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let l_inv = S::int(1) / l;
    let b_mr = b * mr;
    // l_inv*(Ir + b*b_mr)
    let u_dot_of_l_b_mr_ir = l_inv * b.mul_add(b_mr, Ir);
    let cos_p_sq = cos_p * cos_p;
    let sin_p_sin_q = sin_q * sin_p;
    // mp + l_inv*b_mr
    let mp_plus_l_inv_b_mr = l_inv.mul_add(b_mr, mp);
    let cos_p_mp_plus_l_inv_b_mr = mp_plus_l_inv_b_mr * cos_p;
    // q + p
    let q_2_plus_p_2 = q_2 + p_2;
    let (sin_q_plus_p, cos_q_plus_p) = q_2_plus_p_2.sin_cos();
    let cos_q_plus_p_inv = S::int(1) / cos_q_plus_p;
    // 1 - b*l_inv
    let u_dot_of_l_b = (-b).mul_add(l_inv, S::int(1));
    // mr + mp
    let mr_plus_mp = mr + mp;
    let cos_p_cos_q = cos_q * cos_p;
    // cos_p_cos_q - sin_p_sin_q
    let u_dot_of_q_2_p_2 = cos_p_cos_q - sin_p_sin_q;
    // -u_dot_of_q_2_p_2
    let minus_u_dot_of_q_2_p_2 = -u_dot_of_q_2_p_2;
    let r_l_inv = r * l_inv;
    let cos_q_cos_q_plus_p_inv = cos_q_plus_p_inv * cos_q;
    // sin(q) + r_l_inv*cos_q_cos_q_plus_p_inv^2*sin(q + p)
    let u_dot_of_r_l_q_2_p_2 = sin_q
        + r_l_inv * cos_q_cos_q_plus_p_inv * cos_q_cos_q_plus_p_inv * sin_q_plus_p;
    let u_dot_of_r_l_q_2_p_2_2 = cos_q_plus_p_inv * u_dot_of_r_l_q_2_p_2;
    // sin_p_sin_q^2 + cos_p_cos_q^2
    let u_dot_of_q_2_p_2_2 = cos_p_cos_q.mul_add(cos_p_cos_q, sin_p_sin_q * sin_p_sin_q);
    // 2*sin_p_sin_q*cos_p_cos_q - u_dot_of_q_2_p_2_2
    let u_dot_of_q_2_p_2_3 = (sin_p_sin_q * cos_p_cos_q)
        .mul_add(S::int(2), -u_dot_of_q_2_p_2_2);
    let q_dot_2_sq = q_dot_2 * q_dot_2;
    // g*u_dot_of_q_2_p_2*(mr_plus_mp*sin(p) - mr*u_dot_of_l_b*cos(q)*(cos(q)*sin(p) + sin(q)*cos(p))) +
    //   u_dot_of_q_2_p_2_3*sin(p)*(p'^2 + q'*(q' + 2*p'))*(l*mp + b_mr)
    let u_dot_of_motion = g * u_dot_of_q_2_p_2
        * (-mr * u_dot_of_l_b * cos_q * sin_q.mul_add(cos_p, cos_q * sin_p) + mr_plus_mp * sin_p)
        + u_dot_of_q_2_p_2_3 * sin_p * (q_dot_2 * p_dot.mul_add(S::int(2), q_dot_2) + p_dot * p_dot)
            * l.mul_add(mp, b_mr);
    // u' = (sin(q)*sin(p) - cos(q)*cos(p))*(r^2*q'^2*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q +
    //   p)))*(cos(q)*(b^2*mr + Ir) + l*(l*mp*cos(q) + cos(p)*(b*mr*(sin(q)*sin(p) - cos(q)*cos(p)) +
    //   l*mp*(sin(q)*sin(p) - cos(q)*cos(p)))))/(l^2*cos(q + p)*(sin(q)*sin(p) - cos(q)*cos(p))) +
    //   r*(mr*g*sin(q)*cos(q)*cos(p)*(l - b) + sin(p)*(b*mr*cos(q)*(r*q'^2 - g*cos(q)) +
    //   l*(q'*(mp*(r*q'*cos(q) - l*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) -
    //   cos(q)*cos(p)))) - b*mr*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) - cos(q)*cos(p))))
    //   - mr*(g*(1 - cos(q)^2) + b*p'^2*(sin(q)*sin(p) - cos(q)*cos(p))) - mp*(g + l*p'^2*(sin(q)*sin(p) -
    //   cos(q)*cos(p))))))/(l*(sin(q)*sin(p) - cos(q)*cos(p))))/(I*(cos(q)*cos(p) - sin(q)*sin(p)) +
    //   r^2*(cos(q)*(mr*cos(p)*(1 - b/l) + (sin(q)*sin(p)*cos(p)*(b*mr/l + mp) + cos(q)*(((b^2*mr + Ir)/l -
    //   b*mr*cos(p)^2)/l + mp*(1 - cos(p)^2)))/cos(q + p)) - sin(q)*sin(p)*(mr + mp)))
    let u_dot = r
        * (r * q_dot_2_sq
            * (u_dot_of_q_2_p_2 * cos_q
                * (u_dot_of_r_l_q_2_p_2_2 * l_inv.mul_add(u_dot_of_l_b_mr_ir, mp)
                    + mp_plus_l_inv_b_mr * sin_p)
                + cos_p_mp_plus_l_inv_b_mr * u_dot_of_r_l_q_2_p_2_2 * u_dot_of_q_2_p_2_3)
            - u_dot_of_motion)
        / (minus_u_dot_of_q_2_p_2
            * (-r * r
                * (cos_q
                    * (cos_q_plus_p_inv
                        * (cos_q
                            * (l_inv * (-b_mr).mul_add(cos_p_sq, u_dot_of_l_b_mr_ir)
                                + mp * (S::int(1) - cos_p_sq))
                            + sin_p_sin_q * cos_p_mp_plus_l_inv_b_mr)
                        + mr * u_dot_of_l_b * cos_p) - sin_p_sin_q * mr_plus_mp)
                + I * minus_u_dot_of_q_2_p_2));
    // q'' = u'
    let q_ddot = u_dot;
    // p'' = r*q'^2*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q + p)))/(l*cos(q + p)) - u'*(1 +
    //   r*cos(q)/(l*cos(q + p)))
    let p_ddot = cos_q_plus_p_inv * r_l_inv
        * (-u_dot).mul_add(cos_q, u_dot_of_r_l_q_2_p_2 * q_dot_2_sq) - u_dot;
    [q_ddot, p_ddot]
}

/// Kinematic equations: the time derivatives of the coordinates.
///
/// 0 operations.
#[must_use]
pub fn coordinate_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 2] {
    let [q_dot_2, p_dot] = *q_dot;
    // Values.
    // q'
    let q_dot_value = q_dot_2;
    // p'
    let p_dot_value = p_dot;
    [q_dot_value, p_dot_value]
}

/// Kinetic energy T.
///
/// 33 operations, 2 sines and cosines.
#[must_use]
pub fn kinetic_energy<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> S {
    let Parameters { r, l, b, I, mr, Ir, mp, .. } = *p;
    let [q_2, p_2] = *q;
    let [q_dot_2, p_dot] = *q_dot;
    // Sines and cosines.
    let (sin_p, cos_p) = p_2.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    // Shared terms.
    let r_q_dot_2 = r * q_dot_2;
    // cos(q)*sin(p) + sin(q)*cos(p)
    let sin_q_plus_p = sin_q.mul_add(cos_p, cos_q * sin_p);
    let l_sin_q_plus_p = l * sin_q_plus_p;
    let mp_sin_q = mp * sin_q;
    let b_mr = b * mr;
    // mp*l_sin_q_plus_p^2 + b*b_mr
    let energy_of_place = b.mul_add(b_mr, mp * l_sin_q_plus_p * l_sin_q_plus_p);
    // Ir + energy_of_place
    let ir_plus_energy_of_place = Ir + energy_of_place;
    // r_q_dot_2^2*(mr + mp_sin_q*sin(q)) + q'^2*(I + ir_plus_energy_of_place)
    let energy_of_q_dot_2 = r_q_dot_2 * r_q_dot_2 * mp_sin_q.mul_add(sin_q, mr)
        + q_dot_2 * q_dot_2 * (I + ir_plus_energy_of_place);
    // p'*ir_plus_energy_of_place*(2*q' + p') + energy_of_q_dot_2
    let energy_of_motion = p_dot * ir_plus_energy_of_place
        * q_dot_2.mul_add(S::int(2), p_dot) + energy_of_q_dot_2;
    // Values.
    // T = q'^2*(I + r^2*mr + b^2*mr + Ir + 2*r*b*mr*cos(p) + mp*(r*sin(q) + l*sin(q + p))^2)/2 +
    //   p'^2*(b^2*mr + Ir + l^2*mp*sin(q + p)^2)/2 + q'*p'*(b^2*mr + Ir + r*b*mr*cos(p) + l*mp*sin(q +
    //   p)*(r*sin(q) + l*sin(q + p)))
    let energy = r_q_dot_2 * (q_dot_2 + p_dot) * b_mr.mul_add(cos_p, l_sin_q_plus_p * mp_sin_q)
        + S::ratio(1, 2) * energy_of_motion;
    energy
}

/// The generalized speeds u, from q and q'.
///
/// 0 operations.
#[must_use]
pub fn generalized_speeds<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 1] {
    let [q_dot_2, _] = *q_dot;
    // Values.
    // u = q'
    let u_value = q_dot_2;
    [u_value]
}

/// Their time derivatives u', from q, q' and q''.
///
/// 0 operations.
#[must_use]
pub fn generalized_speed_rates<S: Scalar>(
    _p: &Parameters<S>,
    _q: &[S; 2],
    _q_dot: &[S; 2],
    v_dot: &[S; 2],
) -> [S; 1] {
    let [q_ddot, _] = *v_dot;
    // Values.
    // u' = q''
    let u_dot_value = q_ddot;
    [u_dot_value]
}

/// q' from q and the generalized speeds u.
///
/// 7 operations, 2 sines and cosines.
#[must_use]
pub fn motion_variables<S: Scalar>(p: &Parameters<S>, q: &[S; 2], u: &[S; 1]) -> [S; 2] {
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

/// The derivative of the state: the rates of the coordinates, and the accelerations.
///
/// 95 operations, 3 sines and cosines.
#[must_use]
#[inline(always)]
pub fn derivative<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> ([S; 2], [S; 2]) {
    let Parameters { r, l, b, I, mr, Ir, mp, g, .. } = *p;
    let [q_2, p_2] = *q;
    let [q_dot_2, p_dot] = *q_dot;
    // Sines and cosines.
    let (sin_p, cos_p) = p_2.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let l_inv = S::int(1) / l;
    let b_mr = b * mr;
    // l_inv*(Ir + b*b_mr)
    let u_dot_of_l_b_mr_ir = l_inv * b.mul_add(b_mr, Ir);
    let cos_p_sq = cos_p * cos_p;
    let sin_p_sin_q = sin_q * sin_p;
    // mp + l_inv*b_mr
    let mp_plus_l_inv_b_mr = l_inv.mul_add(b_mr, mp);
    let cos_p_mp_plus_l_inv_b_mr = mp_plus_l_inv_b_mr * cos_p;
    // q + p
    let q_2_plus_p_2 = q_2 + p_2;
    let (sin_q_plus_p, cos_q_plus_p) = q_2_plus_p_2.sin_cos();
    let cos_q_plus_p_inv = S::int(1) / cos_q_plus_p;
    // 1 - b*l_inv
    let u_dot_of_l_b = (-b).mul_add(l_inv, S::int(1));
    // mr + mp
    let mr_plus_mp = mr + mp;
    let cos_p_cos_q = cos_q * cos_p;
    // cos_p_cos_q - sin_p_sin_q
    let u_dot_of_q_2_p_2 = cos_p_cos_q - sin_p_sin_q;
    // -u_dot_of_q_2_p_2
    let minus_u_dot_of_q_2_p_2 = -u_dot_of_q_2_p_2;
    let r_l_inv = r * l_inv;
    let cos_q_cos_q_plus_p_inv = cos_q_plus_p_inv * cos_q;
    // sin(q) + r_l_inv*cos_q_cos_q_plus_p_inv^2*sin(q + p)
    let u_dot_of_r_l_q_2_p_2 = sin_q
        + r_l_inv * cos_q_cos_q_plus_p_inv * cos_q_cos_q_plus_p_inv * sin_q_plus_p;
    let u_dot_of_r_l_q_2_p_2_2 = cos_q_plus_p_inv * u_dot_of_r_l_q_2_p_2;
    // sin_p_sin_q^2 + cos_p_cos_q^2
    let u_dot_of_q_2_p_2_2 = cos_p_cos_q.mul_add(cos_p_cos_q, sin_p_sin_q * sin_p_sin_q);
    // 2*sin_p_sin_q*cos_p_cos_q - u_dot_of_q_2_p_2_2
    let u_dot_of_q_2_p_2_3 = (sin_p_sin_q * cos_p_cos_q)
        .mul_add(S::int(2), -u_dot_of_q_2_p_2_2);
    let q_dot_2_sq = q_dot_2 * q_dot_2;
    // g*u_dot_of_q_2_p_2*(mr_plus_mp*sin(p) - mr*u_dot_of_l_b*cos(q)*(cos(q)*sin(p) + sin(q)*cos(p))) +
    //   u_dot_of_q_2_p_2_3*sin(p)*(p'^2 + q'*(q' + 2*p'))*(l*mp + b_mr)
    let u_dot_of_motion = g * u_dot_of_q_2_p_2
        * (-mr * u_dot_of_l_b * cos_q * sin_q.mul_add(cos_p, cos_q * sin_p) + mr_plus_mp * sin_p)
        + u_dot_of_q_2_p_2_3 * sin_p * (q_dot_2 * p_dot.mul_add(S::int(2), q_dot_2) + p_dot * p_dot)
            * l.mul_add(mp, b_mr);
    // u' = (sin(q)*sin(p) - cos(q)*cos(p))*(r^2*q'^2*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q +
    //   p)))*(cos(q)*(b^2*mr + Ir) + l*(l*mp*cos(q) + cos(p)*(b*mr*(sin(q)*sin(p) - cos(q)*cos(p)) +
    //   l*mp*(sin(q)*sin(p) - cos(q)*cos(p)))))/(l^2*cos(q + p)*(sin(q)*sin(p) - cos(q)*cos(p))) +
    //   r*(mr*g*sin(q)*cos(q)*cos(p)*(l - b) + sin(p)*(b*mr*cos(q)*(r*q'^2 - g*cos(q)) +
    //   l*(q'*(mp*(r*q'*cos(q) - l*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) -
    //   cos(q)*cos(p)))) - b*mr*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) - cos(q)*cos(p))))
    //   - mr*(g*(1 - cos(q)^2) + b*p'^2*(sin(q)*sin(p) - cos(q)*cos(p))) - mp*(g + l*p'^2*(sin(q)*sin(p) -
    //   cos(q)*cos(p))))))/(l*(sin(q)*sin(p) - cos(q)*cos(p))))/(I*(cos(q)*cos(p) - sin(q)*sin(p)) +
    //   r^2*(cos(q)*(mr*cos(p)*(1 - b/l) + (sin(q)*sin(p)*cos(p)*(b*mr/l + mp) + cos(q)*(((b^2*mr + Ir)/l -
    //   b*mr*cos(p)^2)/l + mp*(1 - cos(p)^2)))/cos(q + p)) - sin(q)*sin(p)*(mr + mp)))
    let u_dot = r
        * (r * q_dot_2_sq
            * (u_dot_of_q_2_p_2 * cos_q
                * (u_dot_of_r_l_q_2_p_2_2 * l_inv.mul_add(u_dot_of_l_b_mr_ir, mp)
                    + mp_plus_l_inv_b_mr * sin_p)
                + cos_p_mp_plus_l_inv_b_mr * u_dot_of_r_l_q_2_p_2_2 * u_dot_of_q_2_p_2_3)
            - u_dot_of_motion)
        / (minus_u_dot_of_q_2_p_2
            * (-r * r
                * (cos_q
                    * (cos_q_plus_p_inv
                        * (cos_q
                            * (l_inv * (-b_mr).mul_add(cos_p_sq, u_dot_of_l_b_mr_ir)
                                + mp * (S::int(1) - cos_p_sq))
                            + sin_p_sin_q * cos_p_mp_plus_l_inv_b_mr)
                        + mr * u_dot_of_l_b * cos_p) - sin_p_sin_q * mr_plus_mp)
                + I * minus_u_dot_of_q_2_p_2));
    // q'' = u'
    let q_ddot = u_dot;
    // p'' = r*q'^2*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q + p)))/(l*cos(q + p)) - u'*(1 +
    //   r*cos(q)/(l*cos(q + p)))
    let p_ddot = cos_q_plus_p_inv * r_l_inv
        * (-u_dot).mul_add(cos_q, u_dot_of_r_l_q_2_p_2 * q_dot_2_sq) - u_dot;
    // Values.
    // q'
    let q_dot_value = q_dot_2;
    // p'
    let p_dot_value = p_dot;
    ([q_dot_value, p_dot_value], [q_ddot, p_ddot])
}

/// Jacobian of the derivative by the state; columns q, p, q', p'.
///
/// 287 operations, 3 sines and cosines.
#[must_use]
pub fn jacobian<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [[S; 4]; 4] {
    let Parameters { r, l, b, I, mr, Ir, mp, g, .. } = *p;
    let [q_2, p_2] = *q;
    let [q_dot_2, p_dot] = *q_dot;
    // Sines and cosines.
    let (sin_p, cos_p) = p_2.sin_cos();
    let (sin_q, cos_q) = q_2.sin_cos();
    // Elimination, step by step, each after the terms that it shares.
    let sin_p_sin_q = sin_q * sin_p;
    let cos_p_cos_q = cos_q * cos_p;
    // sin_p_sin_q - cos_p_cos_q
    let u_dot_of_q_2_p_2 = sin_p_sin_q - cos_p_cos_q;
    // q' + 2*p'
    let u_dot_of_motion = p_dot.mul_add(S::int(2), q_dot_2);
    let u_dot_of_motion_2 = u_dot_of_q_2_p_2 * u_dot_of_motion;
    let r_cos_q = r * cos_q;
    let b_mr = b * mr;
    // mp*(q'*r_cos_q - l*u_dot_of_motion_2) - u_dot_of_motion_2*b_mr
    let u_dot_of_motion_3 = mp * (-l).mul_add(u_dot_of_motion_2, q_dot_2 * r_cos_q)
        - u_dot_of_motion_2 * b_mr;
    let p_dot_sq = p_dot * p_dot;
    let l_u_dot_of_q_2_p_2 = l * u_dot_of_q_2_p_2;
    let q_dot_2_sq = q_dot_2 * q_dot_2;
    let g_cos_q = g * cos_q;
    // r*q_dot_2_sq - g_cos_q
    let u_dot_of_q_dot_2 = r.mul_add(q_dot_2_sq, -g_cos_q);
    // l*(q'*u_dot_of_motion_3 + mr*(g*(cos(q)^2 - 1) - b*u_dot_of_q_2_p_2*p_dot_sq) - mp*(g +
    //   p_dot_sq*l_u_dot_of_q_2_p_2)) + b_mr*u_dot_of_q_dot_2*cos(q)
    let u_dot_of_motion_4 = l
        * (mr * (g * cos_q.mul_add(cos_q, -S::int(1)) - b * u_dot_of_q_2_p_2 * p_dot_sq)
            + q_dot_2 * u_dot_of_motion_3 - mp * p_dot_sq.mul_add(l_u_dot_of_q_2_p_2, g))
        + b_mr * u_dot_of_q_dot_2 * cos_q;
    let cos_p_sin_q = sin_q * cos_p;
    // mr*(l - b)
    let u_dot_of_l_b_mr = mr * (l - b);
    let g_cos_q_u_dot_of_l_b_mr = g_cos_q * u_dot_of_l_b_mr;
    let l_mp = l * mp;
    // b_mr + l_mp
    let b_mr_plus_l_mp = b_mr + l_mp;
    let u_dot_of_place = u_dot_of_q_2_p_2 * b_mr_plus_l_mp;
    // Ir + b*b_mr
    let ir_plus_b_b_mr = b.mul_add(b_mr, Ir);
    // l*(l_mp*cos(q) + u_dot_of_place*cos(p)) + ir_plus_b_b_mr*cos(q)
    let u_dot_of_place_2 = l * u_dot_of_place.mul_add(cos_p, l_mp * cos_q) + ir_plus_b_b_mr * cos_q;
    // q + p
    let q_2_plus_p_2 = q_2 + p_2;
    let (sin_q_plus_p, cos_q_plus_p) = q_2_plus_p_2.sin_cos();
    let cos_q_plus_p_inv = S::int(1) / cos_q_plus_p;
    let u_dot_of_q_2_p_2_2 = cos_q_plus_p_inv * sin_q_plus_p;
    let l_inv = S::int(1) / l;
    let r_l_inv = r * l_inv;
    let cos_q_plus_p_inv_r_l_inv = cos_q_plus_p_inv * r_l_inv;
    let u_dot_of_r_l_q_2_p_2 = cos_q_plus_p_inv_r_l_inv * cos_q;
    let u_dot_of_r_l_q_2_p_2_2 = u_dot_of_r_l_q_2_p_2 * cos_q;
    // sin(q) + u_dot_of_q_2_p_2_2*u_dot_of_r_l_q_2_p_2_2
    let u_dot_of_r_l_q_2_p_2_3 = u_dot_of_q_2_p_2_2
        .mul_add(u_dot_of_r_l_q_2_p_2_2, sin_q);
    let u_dot_of_q_dot_2_2 = q_dot_2_sq * cos_q_plus_p_inv_r_l_inv;
    let u_dot_of_q_dot_2_3 = u_dot_of_r_l_q_2_p_2_3 * u_dot_of_q_dot_2_2;
    let u_dot_of_q_dot_2_4 = u_dot_of_place_2 * u_dot_of_q_dot_2_3;
    // u_dot_of_motion_4*sin(p) + cos_p_sin_q*g_cos_q_u_dot_of_l_b_mr
    let u_dot_of_motion_5 = cos_p_sin_q
        .mul_add(g_cos_q_u_dot_of_l_b_mr, u_dot_of_motion_4 * sin_p);
    let u_dot_of_q_2_p_2_inv = S::int(1) / u_dot_of_q_2_p_2;
    let u_dot_of_r_l_q_2_p_2_4 = r_l_inv * u_dot_of_q_2_p_2_inv;
    // u_dot_of_r_l_q_2_p_2_4*(u_dot_of_q_dot_2_4 + u_dot_of_motion_5)
    let u_dot_of_motion_6 = u_dot_of_r_l_q_2_p_2_4 * (u_dot_of_q_dot_2_4 + u_dot_of_motion_5);
    let cos_p_sq = cos_p * cos_p;
    // l_inv*(ir_plus_b_b_mr*l_inv - b_mr*cos_p_sq) + mp*(1 - cos_p_sq)
    let u_dot_of_place_3 = l_inv * (-b_mr).mul_add(cos_p_sq, ir_plus_b_b_mr * l_inv)
        + mp * (S::int(1) - cos_p_sq);
    // mp + b_mr*l_inv
    let mp_plus_b_mr_l_inv = b_mr.mul_add(l_inv, mp);
    let sin_p_mp_plus_b_mr_l_inv = mp_plus_b_mr_l_inv * sin_p;
    // cos_q_plus_p_inv*(u_dot_of_place_3*cos(q) + cos_p_sin_q*sin_p_mp_plus_b_mr_l_inv)
    let u_dot_of_place_4 = cos_q_plus_p_inv
        * cos_p_sin_q.mul_add(sin_p_mp_plus_b_mr_l_inv, u_dot_of_place_3 * cos_q);
    // mr*(b*l_inv - 1)
    let u_dot_of_l_b_mr_2 = mr * b.mul_add(l_inv, -S::int(1));
    // u_dot_of_place_4 - u_dot_of_l_b_mr_2*cos(p)
    let u_dot_of_place_5 = (-u_dot_of_l_b_mr_2).mul_add(cos_p, u_dot_of_place_4);
    // mr + mp
    let mr_plus_mp = mr + mp;
    let r_sq = r * r;
    // -1/(I*u_dot_of_q_2_p_2 + r_sq*(sin_p_sin_q*mr_plus_mp - u_dot_of_place_5*cos(q)))
    let u_dot_of_place_6 = -S::int(1)
        / (r_sq * (-u_dot_of_place_5).mul_add(cos_q, sin_p_sin_q * mr_plus_mp)
            + I * u_dot_of_q_2_p_2);
    let u_dot_of_place_7 = u_dot_of_q_2_p_2 * u_dot_of_place_6;
    // u' = (sin(q)*sin(p) - cos(q)*cos(p))*(r^2*q'^2*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q +
    //   p)))*(cos(q)*(b^2*mr + Ir) + l*(l*mp*cos(q) + cos(p)*(b*mr*(sin(q)*sin(p) - cos(q)*cos(p)) +
    //   l*mp*(sin(q)*sin(p) - cos(q)*cos(p)))))/(l^2*cos(q + p)*(sin(q)*sin(p) - cos(q)*cos(p))) +
    //   r*(mr*g*sin(q)*cos(q)*cos(p)*(l - b) + sin(p)*(b*mr*cos(q)*(r*q'^2 - g*cos(q)) +
    //   l*(q'*(mp*(r*q'*cos(q) - l*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) -
    //   cos(q)*cos(p)))) - b*mr*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) - cos(q)*cos(p))))
    //   - mr*(g*(1 - cos(q)^2) + b*p'^2*(sin(q)*sin(p) - cos(q)*cos(p))) - mp*(g + l*p'^2*(sin(q)*sin(p) -
    //   cos(q)*cos(p))))))/(l*(sin(q)*sin(p) - cos(q)*cos(p))))/(I*(cos(q)*cos(p) - sin(q)*sin(p)) +
    //   r^2*(cos(q)*(mr*cos(p)*(1 - b/l) + (sin(q)*sin(p)*cos(p)*(b*mr/l + mp) + cos(q)*(((b^2*mr + Ir)/l -
    //   b*mr*cos(p)^2)/l + mp*(1 - cos(p)^2)))/cos(q + p)) - sin(q)*sin(p)*(mr + mp)))
    let u_dot = u_dot_of_motion_6 * u_dot_of_place_7;
    let sin_p_cos_q = cos_q * sin_p;
    // cos_p_sin_q + sin_p_cos_q
    let u_dot_by_q_of_q_2_p_2 = cos_p_sin_q + sin_p_cos_q;
    // u_dot_of_q_2_p_2_inv*(cos_q_plus_p_inv_r_l_inv*u_dot_of_q_dot_2_4*sin(q + p) -
    //   u_dot_of_motion_6*u_dot_by_q_of_q_2_p_2)
    let u_dot_by_q_of_motion = u_dot_of_q_2_p_2_inv
        * (-u_dot_of_motion_6)
            .mul_add(
                u_dot_by_q_of_q_2_p_2,
                cos_q_plus_p_inv_r_l_inv * u_dot_of_q_dot_2_4 * sin_q_plus_p,
            );
    let u_dot_by_q_of_motion_2 = u_dot_of_motion * u_dot_by_q_of_q_2_p_2;
    let sin_q_doubled = S::int(2) * sin_q;
    let u_dot_by_q_of_p_dot = p_dot_sq * u_dot_by_q_of_q_2_p_2;
    let u_dot_by_q_of_place = b_mr_plus_l_mp * u_dot_by_q_of_q_2_p_2 * cos_p;
    // g*cos_p_sin_q*u_dot_of_l_b_mr*sin(q) - cos_p_cos_q*g_cos_q_u_dot_of_l_b_mr +
    //   sin(p)*(b_mr*sin(q)*(u_dot_of_q_dot_2 - g_cos_q) + l*(q'*(b_mr*u_dot_by_q_of_motion_2 +
    //   mp*(r*q'*sin(q) + l*u_dot_by_q_of_motion_2)) + l_mp*u_dot_by_q_of_p_dot + mr*(g_cos_q*sin_q_doubled
    //   + b*u_dot_by_q_of_p_dot)))
    let u_dot_by_q_of_motion_3 = g * cos_p_sin_q * u_dot_of_l_b_mr * sin_q
        - cos_p_cos_q * g_cos_q_u_dot_of_l_b_mr
        + sin_p
            * (b_mr * sin_q * (u_dot_of_q_dot_2 - g_cos_q)
                + l
                    * (q_dot_2
                        * (mp * l.mul_add(u_dot_by_q_of_motion_2, r * q_dot_2 * sin_q)
                            + b_mr * u_dot_by_q_of_motion_2) + l_mp * u_dot_by_q_of_p_dot
                        + mr * b.mul_add(u_dot_by_q_of_p_dot, g_cos_q * sin_q_doubled)));
    let u_dot_by_q_of_q_2_p_2_2 = u_dot_of_q_2_p_2_2 * sin_q_doubled;
    let u_dot_of_q_2_p_2_2_sq = u_dot_of_q_2_p_2_2 * u_dot_of_q_2_p_2_2;
    // u_dot_of_r_l_q_2_p_2_2*(1 + 2*u_dot_of_q_2_p_2_2_sq)
    let u_dot_by_q_of_r_l_q_2_p_2 = u_dot_of_r_l_q_2_p_2_2
        * u_dot_of_q_2_p_2_2_sq.mul_add(S::int(2), S::int(1));
    let u_dot_by_q_of_place_2 = u_dot_of_place_2 * u_dot_of_r_l_q_2_p_2_4;
    let u_dot_by_q_of_q_dot_2 = u_dot_of_q_dot_2_2 * u_dot_by_q_of_place_2;
    let u_dot_by_q_of_motion_4 = u_dot_of_motion_6 * u_dot_of_place_6;
    let u_dot_by_q_of_place_3 = u_dot_of_q_2_p_2_2 * u_dot_of_place_4;
    let i_u_dot_by_q_of_q_2_p_2 = I * u_dot_by_q_of_q_2_p_2;
    // u_dot_by_q = (cos(q)*sin(p) + sin(q)*cos(p))*(r^2*q'^2*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q +
    //   p)))*(cos(q)*(b^2*mr + Ir) + l*(l*mp*cos(q) + cos(p)*(b*mr*(sin(q)*sin(p) - cos(q)*cos(p)) +
    //   l*mp*(sin(q)*sin(p) - cos(q)*cos(p)))))/(l^2*cos(q + p)*(sin(q)*sin(p) - cos(q)*cos(p))) +
    //   r*(mr*g*sin(q)*cos(q)*cos(p)*(l - b) + sin(p)*(b*mr*cos(q)*(r*q'^2 - g*cos(q)) +
    //   l*(q'*(mp*(r*q'*cos(q) - l*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) -
    //   cos(q)*cos(p)))) - b*mr*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) - cos(q)*cos(p))))
    //   - mr*(g*(1 - cos(q)^2) + b*p'^2*(sin(q)*sin(p) - cos(q)*cos(p))) - mp*(g + l*p'^2*(sin(q)*sin(p) -
    //   cos(q)*cos(p))))))/(l*(sin(q)*sin(p) - cos(q)*cos(p))))/(I*(cos(q)*cos(p) - sin(q)*sin(p)) +
    //   r^2*(cos(q)*(mr*cos(p)*(1 - b/l) + (sin(q)*sin(p)*cos(p)*(b*mr/l + mp) + cos(q)*(((b^2*mr + Ir)/l -
    //   b*mr*cos(p)^2)/l + mp*(1 - cos(p)^2)))/cos(q + p)) - sin(q)*sin(p)*(mr + mp))) + (sin(q)*sin(p) -
    //   cos(q)*cos(p))*(I*(cos(q)*sin(p) + sin(q)*cos(p)) + r^2*(cos(q)*sin(p)*(mr + mp) +
    //   sin(q)*(mr*cos(p)*(1 - b/l) + (sin(q)*sin(p)*cos(p)*(b*mr/l + mp) + cos(q)*(((b^2*mr + Ir)/l -
    //   b*mr*cos(p)^2)/l + mp*(1 - cos(p)^2)))/cos(q + p)) - cos(q)*(tan(q +
    //   p)*(sin(q)*sin(p)*cos(p)*(b*mr/l + mp) + cos(q)*(((b^2*mr + Ir)/l - b*mr*cos(p)^2)/l + mp*(1 -
    //   cos(p)^2)))/cos(q + p) + (cos(q)*sin(p)*cos(p)*(b*mr/l + mp) - sin(q)*(((b^2*mr + Ir)/l -
    //   b*mr*cos(p)^2)/l + mp*(1 - cos(p)^2)))/cos(q + p))))*(r^2*q'^2*(sin(q) + r*cos(q)^2*tan(q +
    //   p)/(l*cos(q + p)))*(cos(q)*(b^2*mr + Ir) + l*(l*mp*cos(q) + cos(p)*(b*mr*(sin(q)*sin(p) -
    //   cos(q)*cos(p)) + l*mp*(sin(q)*sin(p) - cos(q)*cos(p)))))/(l^2*cos(q + p)*(sin(q)*sin(p) -
    //   cos(q)*cos(p))) + r*(mr*g*sin(q)*cos(q)*cos(p)*(l - b) + sin(p)*(b*mr*cos(q)*(r*q'^2 - g*cos(q)) +
    //   l*(q'*(mp*(r*q'*cos(q) - l*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) -
    //   cos(q)*cos(p)))) - b*mr*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) - cos(q)*cos(p))))
    //   - mr*(g*(1 - cos(q)^2) + b*p'^2*(sin(q)*sin(p) - cos(q)*cos(p))) - mp*(g + l*p'^2*(sin(q)*sin(p) -
    //   cos(q)*cos(p))))))/(l*(sin(q)*sin(p) - cos(q)*cos(p))))/(I*(cos(q)*cos(p) - sin(q)*sin(p)) +
    //   r^2*(cos(q)*(mr*cos(p)*(1 - b/l) + (sin(q)*sin(p)*cos(p)*(b*mr/l + mp) + cos(q)*(((b^2*mr + Ir)/l -
    //   b*mr*cos(p)^2)/l + mp*(1 - cos(p)^2)))/cos(q + p)) - sin(q)*sin(p)*(mr + mp)))^2 + (cos(q)*cos(p) -
    //   sin(q)*sin(p))*(r^2*q'^2*tan(q + p)*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q + p)))*(cos(q)*(b^2*mr
    //   + Ir) + l*(l*mp*cos(q) + cos(p)*(b*mr*(sin(q)*sin(p) - cos(q)*cos(p)) + l*mp*(sin(q)*sin(p) -
    //   cos(q)*cos(p)))))/(l^2*cos(q + p)*(cos(q)*cos(p) - sin(q)*sin(p))) + r^2*q'^2*(cos(q)*sin(p) +
    //   sin(q)*cos(p))*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q + p)))*(cos(q)*(b^2*mr + Ir) +
    //   l*(l*mp*cos(q) + cos(p)*(b*mr*(sin(q)*sin(p) - cos(q)*cos(p)) + l*mp*(sin(q)*sin(p) -
    //   cos(q)*cos(p)))))/(l^2*cos(q + p)*(sin(q)*sin(p) - cos(q)*cos(p))^2) + r^2*q'^2*(cos(q)*(b^2*mr +
    //   Ir) + l*(l*mp*cos(q) + cos(p)*(b*mr*(sin(q)*sin(p) - cos(q)*cos(p)) + l*mp*(sin(q)*sin(p) -
    //   cos(q)*cos(p)))))*(cos(q) + r*cos(q)^2/(l*cos(q + p)) - 2*r*sin(q)*cos(q)*tan(q + p)/(l*cos(q + p))
    //   + 2*r*cos(q)^2*tan(q + p)^2/(l*cos(q + p)))/(l^2*cos(q + p)*(cos(q)*cos(p) - sin(q)*sin(p))) +
    //   r^2*q'^2*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q + p)))*(sin(q)*(b^2*mr + Ir) + l*(l*mp*sin(q) -
    //   cos(p)*(b*mr*(cos(q)*sin(p) + sin(q)*cos(p)) + l*mp*(cos(q)*sin(p) + sin(q)*cos(p)))))/(l^2*cos(q +
    //   p)*(sin(q)*sin(p) - cos(q)*cos(p))) + r*(cos(q)*sin(p) +
    //   sin(q)*cos(p))*(mr*g*sin(q)*cos(q)*cos(p)*(l - b) + sin(p)*(b*mr*cos(q)*(r*q'^2 - g*cos(q)) +
    //   l*(q'*(mp*(r*q'*cos(q) - l*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) -
    //   cos(q)*cos(p)))) - b*mr*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) - cos(q)*cos(p))))
    //   - mr*(g*(1 - cos(q)^2) + b*p'^2*(sin(q)*sin(p) - cos(q)*cos(p))) - mp*(g + l*p'^2*(sin(q)*sin(p) -
    //   cos(q)*cos(p))))))/(l*(sin(q)*sin(p) - cos(q)*cos(p))^2) + r*(mr*g*sin(q)^2*cos(p)*(l - b) +
    //   mr*g*cos(q)^2*cos(p)*(b - l) + sin(p)*(b*mr*sin(q)*(r*q'^2 - g*cos(q)) - b*mr*g*sin(q)*cos(q) +
    //   l*(l*mp*p'^2*(cos(q)*sin(p) + sin(q)*cos(p)) + q'*(b*mr*(q'*(cos(q)*sin(p) + sin(q)*cos(p)) +
    //   2*p'*(cos(q)*sin(p) + sin(q)*cos(p))) + mp*(r*q'*sin(q) + l*(q'*(cos(q)*sin(p) + sin(q)*cos(p)) +
    //   2*p'*(cos(q)*sin(p) + sin(q)*cos(p))))) + mr*(2*g*sin(q)*cos(q) + b*p'^2*(cos(q)*sin(p) +
    //   sin(q)*cos(p))))))/(l*(sin(q)*sin(p) - cos(q)*cos(p))))/(I*(cos(q)*cos(p) - sin(q)*sin(p)) +
    //   r^2*(cos(q)*(mr*cos(p)*(1 - b/l) + (sin(q)*sin(p)*cos(p)*(b*mr/l + mp) + cos(q)*(((b^2*mr + Ir)/l -
    //   b*mr*cos(p)^2)/l + mp*(1 - cos(p)^2)))/cos(q + p)) - sin(q)*sin(p)*(mr + mp)))
    let u_dot_by_q = u_dot_of_place_7
        * (u_dot_by_q_of_motion
            - u_dot_of_r_l_q_2_p_2_4
                * (u_dot_of_q_dot_2_3
                    * (l * l_mp.mul_add(sin_q, -u_dot_by_q_of_place)
                        + ir_plus_b_b_mr * sin_q) + u_dot_by_q_of_motion_3)
            + u_dot_by_q_of_q_dot_2
                * ((-u_dot_of_r_l_q_2_p_2).mul_add(u_dot_by_q_of_q_2_p_2_2, cos_q)
                    + u_dot_by_q_of_r_l_q_2_p_2))
        + u_dot_by_q_of_motion_4
            * (u_dot_by_q_of_q_2_p_2
                + u_dot_of_place_7
                    * (r_sq
                        * (u_dot_of_place_5 * sin_q + mr_plus_mp * sin_p_cos_q
                            - cos_q
                                * (cos_q_plus_p_inv
                                    * (-u_dot_of_place_3)
                                        .mul_add(sin_q, cos_p_cos_q * sin_p_mp_plus_b_mr_l_inv)
                                    + u_dot_by_q_of_place_3)) + i_u_dot_by_q_of_q_2_p_2));
    // cos(q)*(1 + 3*u_dot_of_q_2_p_2_2_sq)
    let p_ddot_by_q_of_q_2_p_2 = cos_q * u_dot_of_q_2_p_2_2_sq.mul_add(S::int(3), S::int(1));
    let p_ddot_by_q_of_q_dot_2 = q_dot_2_sq * u_dot_of_q_2_p_2_2;
    // p_ddot_by_q = r*(sin(q)*(q'^2*tan(q + p) + u') - cos(q)*(u'*tan(q + p) - q'^2*(1 + r*(cos(q)*(1 +
    //   3*tan(q + p)^2) - 2*sin(q)*tan(q + p))/(l*cos(q + p))) + u_dot_by_q))/(l*cos(q + p)) - u_dot_by_q
    let p_ddot_by_q = cos_q_plus_p_inv_r_l_inv
        * (sin_q * (u_dot + p_ddot_by_q_of_q_dot_2)
            - cos_q
                * (u_dot_by_q + u_dot * u_dot_of_q_2_p_2_2
                    + q_dot_2_sq
                        * (cos_q_plus_p_inv_r_l_inv
                            * (u_dot_by_q_of_q_2_p_2_2 - p_ddot_by_q_of_q_2_p_2)
                            - S::int(1)))) - u_dot_by_q;
    // u_dot_by_p = (cos(q)*sin(p) + sin(q)*cos(p))*(r^2*q'^2*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q +
    //   p)))*(cos(q)*(b^2*mr + Ir) + l*(l*mp*cos(q) + cos(p)*(b*mr*(sin(q)*sin(p) - cos(q)*cos(p)) +
    //   l*mp*(sin(q)*sin(p) - cos(q)*cos(p)))))/(l^2*cos(q + p)*(sin(q)*sin(p) - cos(q)*cos(p))) +
    //   r*(mr*g*sin(q)*cos(q)*cos(p)*(l - b) + sin(p)*(b*mr*cos(q)*(r*q'^2 - g*cos(q)) +
    //   l*(q'*(mp*(r*q'*cos(q) - l*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) -
    //   cos(q)*cos(p)))) - b*mr*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) - cos(q)*cos(p))))
    //   - mr*(g*(1 - cos(q)^2) + b*p'^2*(sin(q)*sin(p) - cos(q)*cos(p))) - mp*(g + l*p'^2*(sin(q)*sin(p) -
    //   cos(q)*cos(p))))))/(l*(sin(q)*sin(p) - cos(q)*cos(p))))/(I*(cos(q)*cos(p) - sin(q)*sin(p)) +
    //   r^2*(cos(q)*(mr*cos(p)*(1 - b/l) + (sin(q)*sin(p)*cos(p)*(b*mr/l + mp) + cos(q)*(((b^2*mr + Ir)/l -
    //   b*mr*cos(p)^2)/l + mp*(1 - cos(p)^2)))/cos(q + p)) - sin(q)*sin(p)*(mr + mp))) + (sin(q)*sin(p) -
    //   cos(q)*cos(p))*(I*(cos(q)*sin(p) + sin(q)*cos(p)) + r^2*(sin(q)*cos(p)*(mr + mp) -
    //   cos(q)*(mr*sin(p)*(b/l - 1) + tan(q + p)*(sin(q)*sin(p)*cos(p)*(b*mr/l + mp) + cos(q)*(((b^2*mr +
    //   Ir)/l - b*mr*cos(p)^2)/l + mp*(1 - cos(p)^2)))/cos(q + p) + (sin(q)*cos(p)^2*(b*mr/l + mp) -
    //   sin(q)*sin(p)^2*(b*mr/l + mp) + 2*cos(q)*(b*mr*sin(p)*cos(p)/l + mp*sin(p)*cos(p)))/cos(q +
    //   p))))*(r^2*q'^2*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q + p)))*(cos(q)*(b^2*mr + Ir) +
    //   l*(l*mp*cos(q) + cos(p)*(b*mr*(sin(q)*sin(p) - cos(q)*cos(p)) + l*mp*(sin(q)*sin(p) -
    //   cos(q)*cos(p)))))/(l^2*cos(q + p)*(sin(q)*sin(p) - cos(q)*cos(p))) + r*(mr*g*sin(q)*cos(q)*cos(p)*(l
    //   - b) + sin(p)*(b*mr*cos(q)*(r*q'^2 - g*cos(q)) + l*(q'*(mp*(r*q'*cos(q) - l*(q'*(sin(q)*sin(p) -
    //   cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) - cos(q)*cos(p)))) - b*mr*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) +
    //   2*p'*(sin(q)*sin(p) - cos(q)*cos(p)))) - mr*(g*(1 - cos(q)^2) + b*p'^2*(sin(q)*sin(p) -
    //   cos(q)*cos(p))) - mp*(g + l*p'^2*(sin(q)*sin(p) - cos(q)*cos(p))))))/(l*(sin(q)*sin(p) -
    //   cos(q)*cos(p))))/(I*(cos(q)*cos(p) - sin(q)*sin(p)) + r^2*(cos(q)*(mr*cos(p)*(1 - b/l) +
    //   (sin(q)*sin(p)*cos(p)*(b*mr/l + mp) + cos(q)*(((b^2*mr + Ir)/l - b*mr*cos(p)^2)/l + mp*(1 -
    //   cos(p)^2)))/cos(q + p)) - sin(q)*sin(p)*(mr + mp)))^2 + (cos(q)*cos(p) -
    //   sin(q)*sin(p))*(r^2*q'^2*tan(q + p)*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q + p)))*(cos(q)*(b^2*mr
    //   + Ir) + l*(l*mp*cos(q) + cos(p)*(b*mr*(sin(q)*sin(p) - cos(q)*cos(p)) + l*mp*(sin(q)*sin(p) -
    //   cos(q)*cos(p)))))/(l^2*cos(q + p)*(cos(q)*cos(p) - sin(q)*sin(p))) + r^2*q'^2*(cos(q)*sin(p) +
    //   sin(q)*cos(p))*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q + p)))*(cos(q)*(b^2*mr + Ir) +
    //   l*(l*mp*cos(q) + cos(p)*(b*mr*(sin(q)*sin(p) - cos(q)*cos(p)) + l*mp*(sin(q)*sin(p) -
    //   cos(q)*cos(p)))))/(l^2*cos(q + p)*(sin(q)*sin(p) - cos(q)*cos(p))^2) + r^2*q'^2*(cos(q)*(b^2*mr +
    //   Ir) + l*(l*mp*cos(q) + cos(p)*(b*mr*(sin(q)*sin(p) - cos(q)*cos(p)) + l*mp*(sin(q)*sin(p) -
    //   cos(q)*cos(p)))))*(r*cos(q)^2/(l*cos(q + p)) + 2*r*cos(q)^2*tan(q + p)^2/(l*cos(q + p)))/(l^2*cos(q
    //   + p)*(cos(q)*cos(p) - sin(q)*sin(p))) + r^2*q'^2*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q +
    //   p)))*(cos(p)*(b*mr*(cos(q)*sin(p) + sin(q)*cos(p)) + l*mp*(cos(q)*sin(p) + sin(q)*cos(p))) -
    //   sin(p)*(b*mr*(sin(q)*sin(p) - cos(q)*cos(p)) + l*mp*(sin(q)*sin(p) - cos(q)*cos(p))))/(l*cos(q +
    //   p)*(cos(q)*cos(p) - sin(q)*sin(p))) + r*(cos(q)*sin(p) +
    //   sin(q)*cos(p))*(mr*g*sin(q)*cos(q)*cos(p)*(l - b) + sin(p)*(b*mr*cos(q)*(r*q'^2 - g*cos(q)) +
    //   l*(q'*(mp*(r*q'*cos(q) - l*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) -
    //   cos(q)*cos(p)))) - b*mr*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) - cos(q)*cos(p))))
    //   - mr*(g*(1 - cos(q)^2) + b*p'^2*(sin(q)*sin(p) - cos(q)*cos(p))) - mp*(g + l*p'^2*(sin(q)*sin(p) -
    //   cos(q)*cos(p))))))/(l*(sin(q)*sin(p) - cos(q)*cos(p))^2) + r*(mr*g*sin(q)*cos(q)*sin(p)*(b - l) +
    //   cos(p)*(b*mr*cos(q)*(r*q'^2 - g*cos(q)) + l*(q'*(mp*(r*q'*cos(q) - l*(q'*(sin(q)*sin(p) -
    //   cos(q)*cos(p)) + 2*p'*(sin(q)*sin(p) - cos(q)*cos(p)))) - b*mr*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) +
    //   2*p'*(sin(q)*sin(p) - cos(q)*cos(p)))) - mr*(g*(1 - cos(q)^2) + b*p'^2*(sin(q)*sin(p) -
    //   cos(q)*cos(p))) - mp*(g + l*p'^2*(sin(q)*sin(p) - cos(q)*cos(p))))) -
    //   l*sin(p)*(b*mr*p'^2*(cos(q)*sin(p) + sin(q)*cos(p)) + l*mp*p'^2*(cos(q)*sin(p) + sin(q)*cos(p)) +
    //   q'*(b*mr*(q'*(cos(q)*sin(p) + sin(q)*cos(p)) + 2*p'*(cos(q)*sin(p) + sin(q)*cos(p))) +
    //   l*mp*(q'*(cos(q)*sin(p) + sin(q)*cos(p)) + 2*p'*(cos(q)*sin(p) +
    //   sin(q)*cos(p))))))/(l*(cos(q)*cos(p) - sin(q)*sin(p))))/(I*(cos(q)*cos(p) - sin(q)*sin(p)) +
    //   r^2*(cos(q)*(mr*cos(p)*(1 - b/l) + (sin(q)*sin(p)*cos(p)*(b*mr/l + mp) + cos(q)*(((b^2*mr + Ir)/l -
    //   b*mr*cos(p)^2)/l + mp*(1 - cos(p)^2)))/cos(q + p)) - sin(q)*sin(p)*(mr + mp)))
    let u_dot_by_p = u_dot_of_place_7
        * (u_dot_by_q_of_motion
            + u_dot_of_r_l_q_2_p_2_4
                * (u_dot_of_motion_4 * cos_p - sin_p_sin_q * g_cos_q_u_dot_of_l_b_mr
                    - l * sin_p
                        * b_mr_plus_l_mp
                            .mul_add(
                                u_dot_by_q_of_p_dot,
                                q_dot_2 * b_mr_plus_l_mp * u_dot_by_q_of_motion_2,
                            ))
            + r * u_dot_of_q_dot_2_3 * u_dot_of_q_2_p_2_inv
                * (-u_dot_of_place).mul_add(sin_p, u_dot_by_q_of_place)
            + u_dot_by_q_of_r_l_q_2_p_2 * u_dot_by_q_of_q_dot_2)
        + u_dot_by_q_of_motion_4
            * (u_dot_by_q_of_q_2_p_2
                + u_dot_of_place_7
                    * (r_sq
                        * (-cos_q
                            * (cos_q_plus_p_inv
                                * ((sin_p_mp_plus_b_mr_l_inv * cos_q * cos_p)
                                    .mul_add(
                                        S::int(2),
                                        cos_p_sin_q * mp_plus_b_mr_l_inv * cos_p,
                                    ) - sin_p_sin_q * sin_p_mp_plus_b_mr_l_inv)
                                + u_dot_of_l_b_mr_2 * sin_p + u_dot_by_q_of_place_3)
                            + cos_p_sin_q * mr_plus_mp) + i_u_dot_by_q_of_q_2_p_2));
    // p_ddot_by_p = r*(q'^2*sin(q)*tan(q + p) - cos(q)*((u'*sin(q + p) - r*q'^2*cos(q)*(1 + 3*tan(q +
    //   p)^2)/l)/cos(q + p) + u_dot_by_p))/(l*cos(q + p)) - u_dot_by_p
    let p_ddot_by_p = cos_q_plus_p_inv_r_l_inv
        * (-cos_q
            * (u_dot_by_p
                + cos_q_plus_p_inv
                    * (-(q_dot_2_sq * r_l_inv))
                        .mul_add(p_ddot_by_q_of_q_2_p_2, u_dot * sin_q_plus_p))
            + p_ddot_by_q_of_q_dot_2 * sin_q) - u_dot_by_p;
    let q_dot_2_doubled = S::int(2) * q_dot_2;
    let u_dot_by_q_dot_of_q_dot_2 = u_dot_of_r_l_q_2_p_2_3 * q_dot_2_doubled;
    // u_dot_by_q_dot = (sin(q)*sin(p) - cos(q)*cos(p))*(2*r^2*q'*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q
    //   + p)))*(cos(q)*(b^2*mr + Ir) + l*(l*mp*cos(q) + cos(p)*(b*mr*(sin(q)*sin(p) - cos(q)*cos(p)) +
    //   l*mp*(sin(q)*sin(p) - cos(q)*cos(p)))))/(l^2*cos(q + p)*(sin(q)*sin(p) - cos(q)*cos(p))) +
    //   r*sin(p)*(2*r*b*mr*q'*cos(q) + l*(q'*(mp*(r*cos(q) + l*(cos(q)*cos(p) - sin(q)*sin(p))) -
    //   b*mr*(sin(q)*sin(p) - cos(q)*cos(p))) - b*mr*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) +
    //   2*p'*(sin(q)*sin(p) - cos(q)*cos(p))) + mp*(r*q'*cos(q) - l*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) +
    //   2*p'*(sin(q)*sin(p) - cos(q)*cos(p))))))/(l*(sin(q)*sin(p) - cos(q)*cos(p))))/(I*(cos(q)*cos(p) -
    //   sin(q)*sin(p)) + r^2*(cos(q)*(mr*cos(p)*(1 - b/l) + (sin(q)*sin(p)*cos(p)*(b*mr/l + mp) +
    //   cos(q)*(((b^2*mr + Ir)/l - b*mr*cos(p)^2)/l + mp*(1 - cos(p)^2)))/cos(q + p)) - sin(q)*sin(p)*(mr +
    //   mp)))
    let u_dot_by_q_dot = u_dot_of_place_7
        * (u_dot_of_r_l_q_2_p_2_4 * sin_p
            * (l
                * (u_dot_of_motion_3
                    + q_dot_2
                        * (mp * (r_cos_q - l_u_dot_of_q_2_p_2) - u_dot_of_q_2_p_2 * b_mr))
                + r_cos_q * b_mr * q_dot_2_doubled)
            + cos_q_plus_p_inv_r_l_inv * u_dot_by_q_of_place_2 * u_dot_by_q_dot_of_q_dot_2);
    // p_ddot_by_q_dot = r*(2*q'*(sin(q) + r*cos(q)^2*tan(q + p)/(l*cos(q + p))) -
    //   u_dot_by_q_dot*cos(q))/(l*cos(q + p)) - u_dot_by_q_dot
    let p_ddot_by_q_dot = cos_q_plus_p_inv_r_l_inv
        * (-u_dot_by_q_dot).mul_add(cos_q, u_dot_by_q_dot_of_q_dot_2) - u_dot_by_q_dot;
    // u_dot_by_p_dot = -2*r*sin(p)*(b*mr*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + p'*(sin(q)*sin(p) -
    //   cos(q)*cos(p))) + l*mp*(q'*(sin(q)*sin(p) - cos(q)*cos(p)) + p'*(sin(q)*sin(p) -
    //   cos(q)*cos(p))))/(I*(cos(q)*cos(p) - sin(q)*sin(p)) + r^2*(cos(q)*(mr*cos(p)*(1 - b/l) +
    //   (sin(q)*sin(p)*cos(p)*(b*mr/l + mp) + cos(q)*(((b^2*mr + Ir)/l - b*mr*cos(p)^2)/l + mp*(1 -
    //   cos(p)^2)))/cos(q + p)) - sin(q)*sin(p)*(mr + mp)))
    let u_dot_by_p_dot = -S::int(2) * r * u_dot_of_q_2_p_2 * b_mr_plus_l_mp
        * u_dot_of_place_6 * sin_p * (q_dot_2 + p_dot);
    // p_ddot_by_p_dot = -u_dot_by_p_dot*(1 + r*cos(q)/(l*cos(q + p)))
    let p_ddot_by_p_dot = -u_dot_by_p_dot * (S::int(1) + u_dot_of_r_l_q_2_p_2);
    // Entries that are not zero.
    // d(q')/d(q') = 1
    let q_dot_by_q_dot_value = S::int(1);
    // d(p')/d(p') = 1
    let p_dot_by_p_dot_value = S::int(1);
    let zero = S::int(0);
    [
        [zero, zero, q_dot_by_q_dot_value, zero],
        [zero, zero, zero, p_dot_by_p_dot_value],
        [u_dot_by_q, u_dot_by_p, u_dot_by_q_dot, u_dot_by_p_dot],
        [p_ddot_by_q, p_ddot_by_p, p_ddot_by_q_dot, p_ddot_by_p_dot],
    ]
}

/// What the equations divide by: where one of these is zero, they have no value.
///
/// 1 operation, 1 sine and cosine.
#[must_use]
pub fn divisors<S: Scalar>(_p: &Parameters<S>, q: &[S; 2], _q_dot: &[S; 2]) -> [S; 1] {
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
/// 10 operations, 2 sines and cosines.
#[must_use]
pub fn constraints<S: Scalar>(p: &Parameters<S>, q: &[S; 2], q_dot: &[S; 2]) -> [S; 2] {
    let Parameters { r, l, .. } = *p;
    let [q_2, p_2] = *q;
    let [q_dot_2, p_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    // Shared terms.
    // q + p
    let q_2_plus_p_2 = q_2 + p_2;
    let (sin_q_plus_p, cos_q_plus_p) = q_2_plus_p_2.sin_cos();
    // Values.
    // wrist_1 = r*sin(q) + l*sin(q + p)
    let residual1 = l.mul_add(sin_q_plus_p, r * sin_q);
    // wrist_1' = r*q'*cos(q) + l*cos(q + p)*(q' + p')
    let residual2 = l * cos_q_plus_p * (q_dot_2 + p_dot) + r * q_dot_2 * cos_q;
    [residual1, residual2]
}

/// Slopes of the constraints, one after the other, along q, p, q', p'.
///
/// 12 operations, 2 sines and cosines.
#[must_use]
pub fn constraint_slopes<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
) -> [S; 8] {
    let Parameters { r, l, .. } = *p;
    let [q_2, p_2] = *q;
    let [q_dot_2, p_dot] = *q_dot;
    // Sines and cosines.
    let (sin_q, cos_q) = q_2.sin_cos();
    // Shared terms.
    // q + p
    let q_2_plus_p_2 = q_2 + p_2;
    let (sin_q_plus_p, cos_q_plus_p) = q_2_plus_p_2.sin_cos();
    let l_cos_q_plus_p = l * cos_q_plus_p;
    // r*cos(q) + l*cos(q + p)
    let residual1_by_q_of_r_l_q_2_p_2 = r.mul_add(cos_q, l_cos_q_plus_p);
    // l*sin(q + p)*(q' + p')
    let residual2_by_q_of_motion = l * sin_q_plus_p * (q_dot_2 + p_dot);
    // Values.
    // d(wrist_1)/d(q) = r*cos(q) + l*cos(q + p)
    let residual1_by_q = residual1_by_q_of_r_l_q_2_p_2;
    // d(wrist_1)/d(p) = l*cos(q + p)
    let residual1_by_p = l_cos_q_plus_p;
    // d(wrist_1')/d(q) = -r*q'*sin(q) - l*sin(q + p)*(q' + p')
    let residual2_by_q = (-(r * q_dot_2)).mul_add(sin_q, -residual2_by_q_of_motion);
    // d(wrist_1')/d(p) = -l*sin(q + p)*(q' + p')
    let residual2_by_p = -residual2_by_q_of_motion;
    // d(wrist_1')/d(q') = r*cos(q) + l*cos(q + p)
    let residual2_by_q_dot = residual1_by_q_of_r_l_q_2_p_2;
    // d(wrist_1')/d(p') = l*cos(q + p)
    let residual2_by_p_dot = l_cos_q_plus_p;
    let zero = S::int(0);
    [
        residual1_by_q, residual1_by_p, zero, zero, residual2_by_q, residual2_by_p,
        residual2_by_q_dot, residual2_by_p_dot,
    ]
}

/// Taylor coefficients of the motion in time: `series[order]` is the one of order k, from the state `series[0]`.
///
/// 35 convolutions and 68 linear operations an order.
#[inline(always)]
pub fn taylor<S: Scalar>(
    p: &Parameters<S>,
    series: &mut [[S; 4]],
    history: &mut [Factors<S, 40>],
) {
    let Parameters { r, l, b, I, mr, Ir, mp, g, .. } = *p;
    let [q_2_0, p_2_0, q_dot_2_0, p_dot_0] = series[0];
    // Shared terms.
    let b_sq_mr = b * b * mr;
    let l_mp = l * mp;
    let b_mr_2 = b * mr;
    // b*mr + l*mp
    let l_mp_plus_b_mr = b_mr_2 + l_mp;
    let l_inv_b_mr = b * mr / l;
    // Constant in time.
    // r_by_l = r/l
    let r_by_l = r / l;
    // minus_g = -g
    let minus_g = -g;
    // b_mr_plus_l_mp = b*mr + l*mp
    let b_mr_plus_l_mp = l_mp_plus_b_mr;
    // weight = b^2*mr + Ir + l^2*mp
    let weight = b_sq_mr + Ir + l * l * mp;
    // r_mp = r*mp
    let r_mp = r * mp;
    // minus_b_mr_minus_l_mp = -b*mr - l*mp
    let minus_b_mr_minus_l_mp = -b_mr_2 - l_mp;
    // minus_l_mr_g_plus_mp_g = -l*(mr*g + mp*g)
    let minus_l_mr_g_plus_mp_g = -l * mp.mul_add(g, mr * g);
    // minus_l_b_mr_plus_l_mp = -l*(b*mr + l*mp)
    let minus_l_b_mr_plus_l_mp = -l * l_mp_plus_b_mr;
    // l_mr_g = l*mr*g
    let l_mr_g = l * mr * g;
    // b_mr = b*mr
    let b_mr = b_mr_2;
    // mr_g_l_minus_b = mr*g*(l - b)
    let mr_g_l_minus_b = mr * g * (l - b);
    // weight_2 = (b^2*mr + Ir)/l^2 + mp
    let weight_2 = (b_sq_mr + Ir) / (l * l) + mp;
    // minus_b_mr_by_l_minus_mp = -b*mr/l - mp
    let minus_b_mr_by_l_minus_mp = -l_inv_b_mr - mp;
    // b_mr_by_l_plus_mp = b*mr/l + mp
    let b_mr_by_l_plus_mp = l_inv_b_mr + mp;
    // mr_1_minus_b_by_l = mr*(1 - b/l)
    let mr_1_minus_b_by_l = mr * (S::int(1) - b / l);
    // r_2 = r^2
    let r_2 = r * r;
    // minus_r_2_mr_plus_mp = -r^2*(mr + mp)
    let minus_r_2_mr_plus_mp = -r * r * (mr + mp);
    // minus_i = -I
    let minus_i = -I;
    // r_2_by_l_2 = r^2/l^2
    let r_2_by_l_2 = r * r / (l * l);
    // Order 0.
    let (sin_p_0, cos_p_0) = p_2_0.sin_cos();
    let (sin_q_0, cos_q_0) = q_2_0.sin_cos();
    let q_2_plus_p_2_0 = q_2_0 + p_2_0;
    let (sin_q_plus_p_0, cos_q_plus_p_0) = q_2_plus_p_2_0.sin_cos();
    let over_cos_q_plus_p = S::int(1) / cos_q_plus_p_0;
    let q_dot_2_cos_q_0 = q_dot_2_0 * cos_q_0;
    let sin_p_sin_q_0 = sin_p_0 * sin_q_0;
    let cos_p_cos_q_0 = cos_p_0 * cos_q_0;
    let u_dot_of_q_2_p_2_0 = sin_p_sin_q_0 - cos_p_cos_q_0;
    let over_u_dot_of_q_2_p_2 = S::int(1) / u_dot_of_q_2_p_2_0;
    let q_dot_2_sq_0 = q_dot_2_0 * q_dot_2_0;
    let cos_q_cos_q_plus_p_inv_0 = cos_q_0 * over_cos_q_plus_p;
    let u_dot_of_q_2_p_2_2_0 = sin_q_plus_p_0 * cos_q_cos_q_plus_p_inv_0;
    let u_dot_of_q_2_p_2_3_0 = cos_q_cos_q_plus_p_inv_0 * u_dot_of_q_2_p_2_2_0;
    let u_dot_of_r_l_q_2_p_2_0 = u_dot_of_q_2_p_2_3_0.mul_add(r_by_l, sin_q_0);
    let u_dot_of_q_dot_2_0 = q_dot_2_0 * u_dot_of_q_2_p_2_0;
    let u_dot_of_p_dot_0 = p_dot_0 * u_dot_of_q_2_p_2_0;
    let u_dot_of_motion_0 = u_dot_of_p_dot_0.mul_add(S::int(2), u_dot_of_q_dot_2_0);
    let u_dot_of_q_dot_2_2_0 = cos_q_0.mul_add(minus_g, r * q_dot_2_sq_0);
    let u_dot_of_place_0 = b_mr_plus_l_mp * u_dot_of_q_2_p_2_0;
    let u_dot_of_place_2_0 = cos_p_0 * u_dot_of_place_0;
    let u_dot_of_place_3_0 = u_dot_of_place_2_0.mul_add(l, weight * cos_q_0);
    let u_dot_of_motion_2_0 = u_dot_of_motion_0
        .mul_add(minus_b_mr_minus_l_mp, r_mp * q_dot_2_cos_q_0);
    let u_dot_of_motion_3_0 = q_dot_2_0 * u_dot_of_motion_2_0;
    let u_dot_of_p_dot_2_0 = p_dot_0 * u_dot_of_p_dot_0;
    let cos_q_sq_0 = cos_q_0 * cos_q_0;
    let u_dot_of_q_dot_2_3_0 = cos_q_0 * u_dot_of_q_dot_2_2_0;
    let u_dot_of_motion_4_0 = u_dot_of_motion_3_0
        .mul_add(
            l,
            u_dot_of_p_dot_2_0
                .mul_add(
                    minus_l_b_mr_plus_l_mp,
                    u_dot_of_q_dot_2_3_0
                        .mul_add(
                            b_mr,
                            cos_q_sq_0.mul_add(l_mr_g, minus_l_mr_g_plus_mp_g),
                        ),
                ),
        );
    let u_dot_of_motion_5_0 = sin_p_0 * u_dot_of_motion_4_0;
    let cos_p_sin_q_cos_q_0 = sin_q_0 * cos_p_cos_q_0;
    let u_dot_of_motion_6_0 = mr_g_l_minus_b * cos_p_sin_q_cos_q_0 + u_dot_of_motion_5_0;
    let u_dot_of_motion_7_0 = u_dot_of_motion_6_0 * over_u_dot_of_q_2_p_2;
    let u_dot_of_r_l_q_2_p_2_2_0 = u_dot_of_r_l_q_2_p_2_0 * over_cos_q_plus_p;
    let u_dot_of_q_dot_2_4_0 = q_dot_2_sq_0 * u_dot_of_r_l_q_2_p_2_2_0;
    let u_dot_of_place_4_0 = u_dot_of_place_3_0 * over_u_dot_of_q_2_p_2;
    let u_dot_of_q_dot_2_5_0 = u_dot_of_q_dot_2_4_0 * u_dot_of_place_4_0;
    let cos_p_sq_0 = cos_p_0 * cos_p_0;
    let u_dot_of_place_5_0 = cos_p_sq_0.mul_add(minus_b_mr_by_l_minus_mp, weight_2);
    let u_dot_of_place_6_0 = cos_q_0 * u_dot_of_place_5_0;
    let sin_p_cos_p_sin_q_0 = cos_p_0 * sin_p_sin_q_0;
    let u_dot_of_place_7_0 = b_mr_by_l_plus_mp * sin_p_cos_p_sin_q_0 + u_dot_of_place_6_0;
    let u_dot_of_place_8_0 = u_dot_of_place_7_0 * over_cos_q_plus_p;
    let u_dot_of_place_9_0 = mr_1_minus_b_by_l * cos_p_0 + u_dot_of_place_8_0;
    let u_dot_of_place_10_0 = cos_q_0 * u_dot_of_place_9_0;
    let u_dot_of_place_11_0 = u_dot_of_place_10_0
        .mul_add(
            r_2,
            u_dot_of_q_2_p_2_0.mul_add(minus_i, minus_r_2_mr_plus_mp * sin_p_sin_q_0),
        );
    let over_u_dot_of_place_11 = S::int(1) / u_dot_of_place_11_0;
    let u_dot_of_motion_8_0 = u_dot_of_motion_7_0
        .mul_add(r_by_l, r_2_by_l_2 * u_dot_of_q_dot_2_5_0);
    let u_dot_of_place_12_0 = u_dot_of_q_2_p_2_0 * over_u_dot_of_place_11;
    let q_dot_2_dot_0 = u_dot_of_motion_8_0 * u_dot_of_place_12_0;
    let p_ddot_of_r_l_q_2_p_2_0 = cos_q_cos_q_plus_p_inv_0.mul_add(r_by_l, S::int(1));
    let p_ddot_of_motion_0 = q_dot_2_dot_0 * p_ddot_of_r_l_q_2_p_2_0;
    let p_dot_dot_0 = r_by_l * u_dot_of_q_dot_2_4_0 - p_ddot_of_motion_0;
    // Order 1: the rates, and what follows from them.
    let q_2_1 = q_dot_2_0;
    let p_2_1 = p_dot_0;
    let q_dot_2_1 = q_dot_2_dot_0;
    let p_dot_1 = p_dot_dot_0;
    if series.len() > 1 {
        series[1] = [q_2_1, p_2_1, q_dot_2_1, p_dot_1];
    }
    let sin_p_1 = p_2_1 * cos_p_0;
    let cos_p_1 = -p_2_1 * sin_p_0;
    let sin_q_1 = q_2_1 * cos_q_0;
    let cos_q_1 = -q_2_1 * sin_q_0;
    let q_2_plus_p_2_1 = q_2_1 + p_2_1;
    let sin_q_plus_p_1 = q_2_plus_p_2_1 * cos_q_plus_p_0;
    let cos_q_plus_p_1 = -q_2_plus_p_2_1 * sin_q_plus_p_0;
    let q_dot_2_cos_q_1 = cos_q_1.mul_add(q_dot_2_0, q_dot_2_1 * cos_q_0);
    let sin_p_sin_q_1 = sin_q_1.mul_add(sin_p_0, sin_p_1 * sin_q_0);
    let cos_p_cos_q_1 = cos_q_1.mul_add(cos_p_0, cos_p_1 * cos_q_0);
    let u_dot_of_q_2_p_2_1 = sin_p_sin_q_1 - cos_p_cos_q_1;
    let q_dot_2_sq_1 = q_dot_2_1 * (q_dot_2_0 + q_dot_2_0);
    let cos_q_cos_q_plus_p_inv_1 = cos_q_plus_p_1
        .mul_add(
            -(cos_q_cos_q_plus_p_inv_0 * over_cos_q_plus_p),
            cos_q_1 * over_cos_q_plus_p,
        );
    let u_dot_of_q_2_p_2_2_1 = cos_q_cos_q_plus_p_inv_1
        .mul_add(sin_q_plus_p_0, sin_q_plus_p_1 * cos_q_cos_q_plus_p_inv_0);
    let u_dot_of_q_2_p_2_3_1 = u_dot_of_q_2_p_2_2_1
        .mul_add(
            cos_q_cos_q_plus_p_inv_0,
            cos_q_cos_q_plus_p_inv_1 * u_dot_of_q_2_p_2_2_0,
        );
    let u_dot_of_r_l_q_2_p_2_1 = u_dot_of_q_2_p_2_3_1.mul_add(r_by_l, sin_q_1);
    let u_dot_of_q_dot_2_1 = u_dot_of_q_2_p_2_1
        .mul_add(q_dot_2_0, q_dot_2_1 * u_dot_of_q_2_p_2_0);
    let u_dot_of_p_dot_1 = u_dot_of_q_2_p_2_1
        .mul_add(p_dot_0, p_dot_1 * u_dot_of_q_2_p_2_0);
    let u_dot_of_motion_1 = u_dot_of_p_dot_1.mul_add(S::int(2), u_dot_of_q_dot_2_1);
    let u_dot_of_q_dot_2_2_1 = cos_q_1.mul_add(minus_g, r * q_dot_2_sq_1);
    let u_dot_of_place_1 = b_mr_plus_l_mp * u_dot_of_q_2_p_2_1;
    let u_dot_of_place_2_1 = u_dot_of_place_1
        .mul_add(cos_p_0, cos_p_1 * u_dot_of_place_0);
    let u_dot_of_place_3_1 = u_dot_of_place_2_1.mul_add(l, weight * cos_q_1);
    let u_dot_of_motion_2_1 = u_dot_of_motion_1
        .mul_add(minus_b_mr_minus_l_mp, r_mp * q_dot_2_cos_q_1);
    let u_dot_of_motion_3_1 = u_dot_of_motion_2_1
        .mul_add(q_dot_2_0, q_dot_2_1 * u_dot_of_motion_2_0);
    let u_dot_of_p_dot_2_1 = u_dot_of_p_dot_1
        .mul_add(p_dot_0, p_dot_1 * u_dot_of_p_dot_0);
    let cos_q_sq_1 = cos_q_1 * (cos_q_0 + cos_q_0);
    let u_dot_of_q_dot_2_3_1 = u_dot_of_q_dot_2_2_1
        .mul_add(cos_q_0, cos_q_1 * u_dot_of_q_dot_2_2_0);
    let u_dot_of_motion_4_1 = u_dot_of_motion_3_1
        .mul_add(
            l,
            u_dot_of_p_dot_2_1
                .mul_add(
                    minus_l_b_mr_plus_l_mp,
                    u_dot_of_q_dot_2_3_1.mul_add(b_mr, l_mr_g * cos_q_sq_1),
                ),
        );
    let u_dot_of_motion_5_1 = u_dot_of_motion_4_1
        .mul_add(sin_p_0, sin_p_1 * u_dot_of_motion_4_0);
    let cos_p_sin_q_cos_q_1 = cos_p_cos_q_1.mul_add(sin_q_0, sin_q_1 * cos_p_cos_q_0);
    let u_dot_of_motion_6_1 = mr_g_l_minus_b * cos_p_sin_q_cos_q_1 + u_dot_of_motion_5_1;
    let u_dot_of_motion_7_1 = u_dot_of_q_2_p_2_1
        .mul_add(
            -(u_dot_of_motion_7_0 * over_u_dot_of_q_2_p_2),
            u_dot_of_motion_6_1 * over_u_dot_of_q_2_p_2,
        );
    let u_dot_of_r_l_q_2_p_2_2_1 = cos_q_plus_p_1
        .mul_add(
            -(u_dot_of_r_l_q_2_p_2_2_0 * over_cos_q_plus_p),
            u_dot_of_r_l_q_2_p_2_1 * over_cos_q_plus_p,
        );
    let u_dot_of_q_dot_2_4_1 = u_dot_of_r_l_q_2_p_2_2_1
        .mul_add(q_dot_2_sq_0, q_dot_2_sq_1 * u_dot_of_r_l_q_2_p_2_2_0);
    let u_dot_of_place_4_1 = u_dot_of_q_2_p_2_1
        .mul_add(
            -(u_dot_of_place_4_0 * over_u_dot_of_q_2_p_2),
            u_dot_of_place_3_1 * over_u_dot_of_q_2_p_2,
        );
    let u_dot_of_q_dot_2_5_1 = u_dot_of_q_dot_2_4_1
        .mul_add(u_dot_of_place_4_0, u_dot_of_place_4_1 * u_dot_of_q_dot_2_4_0);
    let cos_p_sq_1 = cos_p_1 * (cos_p_0 + cos_p_0);
    let u_dot_of_place_5_1 = minus_b_mr_by_l_minus_mp * cos_p_sq_1;
    let u_dot_of_place_6_1 = u_dot_of_place_5_1
        .mul_add(cos_q_0, cos_q_1 * u_dot_of_place_5_0);
    let sin_p_cos_p_sin_q_1 = sin_p_sin_q_1.mul_add(cos_p_0, cos_p_1 * sin_p_sin_q_0);
    let u_dot_of_place_7_1 = b_mr_by_l_plus_mp * sin_p_cos_p_sin_q_1 + u_dot_of_place_6_1;
    let u_dot_of_place_8_1 = cos_q_plus_p_1
        .mul_add(
            -(u_dot_of_place_8_0 * over_cos_q_plus_p),
            u_dot_of_place_7_1 * over_cos_q_plus_p,
        );
    let u_dot_of_place_9_1 = mr_1_minus_b_by_l * cos_p_1 + u_dot_of_place_8_1;
    let u_dot_of_place_10_1 = u_dot_of_place_9_1
        .mul_add(cos_q_0, cos_q_1 * u_dot_of_place_9_0);
    let u_dot_of_place_11_1 = u_dot_of_place_10_1
        .mul_add(
            r_2,
            u_dot_of_q_2_p_2_1.mul_add(minus_i, minus_r_2_mr_plus_mp * sin_p_sin_q_1),
        );
    let u_dot_of_motion_8_1 = u_dot_of_motion_7_1
        .mul_add(r_by_l, r_2_by_l_2 * u_dot_of_q_dot_2_5_1);
    let u_dot_of_place_12_1 = u_dot_of_place_11_1
        .mul_add(
            -(u_dot_of_place_12_0 * over_u_dot_of_place_11),
            u_dot_of_q_2_p_2_1 * over_u_dot_of_place_11,
        );
    let q_dot_2_dot_1 = u_dot_of_motion_8_1
        .mul_add(u_dot_of_place_12_0, u_dot_of_place_12_1 * u_dot_of_motion_8_0);
    let p_ddot_of_r_l_q_2_p_2_1 = r_by_l * cos_q_cos_q_plus_p_inv_1;
    let p_ddot_of_motion_1 = q_dot_2_dot_1
        .mul_add(p_ddot_of_r_l_q_2_p_2_0, p_ddot_of_r_l_q_2_p_2_1 * q_dot_2_dot_0);
    let p_dot_dot_1 = r_by_l * u_dot_of_q_dot_2_4_1 - p_ddot_of_motion_1;
    if series.len() > 2 {
        // Factors of the convolutions: left, right.
        history[1] = [
            padded([
                p_2_1, p_2_1, q_2_1, q_2_1, q_2_plus_p_2_1, q_2_plus_p_2_1, q_dot_2_1, sin_p_1,
                cos_p_1, q_dot_2_1, cos_q_plus_p_1, sin_q_plus_p_1, cos_q_cos_q_plus_p_inv_1,
                q_dot_2_1, p_dot_1, cos_p_1, q_dot_2_1, p_dot_1, cos_q_1, cos_q_1, sin_p_1, sin_q_1,
                u_dot_of_q_2_p_2_1, cos_q_plus_p_1, q_dot_2_sq_1, u_dot_of_q_2_p_2_1,
                u_dot_of_q_dot_2_4_1, cos_p_1, cos_q_1, cos_p_1, cos_q_plus_p_1, cos_q_1,
                u_dot_of_place_11_1, u_dot_of_motion_8_1, q_dot_2_dot_1,
            ]),
            padded([
                cos_p_1, sin_p_1, cos_q_1, sin_q_1, cos_q_plus_p_1, sin_q_plus_p_1, cos_q_1,
                sin_q_1, cos_q_1, q_dot_2_1, cos_q_cos_q_plus_p_inv_1, cos_q_cos_q_plus_p_inv_1,
                u_dot_of_q_2_p_2_2_1, u_dot_of_q_2_p_2_1, u_dot_of_q_2_p_2_1, u_dot_of_place_1,
                u_dot_of_motion_2_1, u_dot_of_p_dot_1, cos_q_1, u_dot_of_q_dot_2_2_1,
                u_dot_of_motion_4_1, cos_p_cos_q_1, u_dot_of_motion_7_1, u_dot_of_r_l_q_2_p_2_2_1,
                u_dot_of_r_l_q_2_p_2_2_1, u_dot_of_place_4_1, u_dot_of_place_4_1, cos_p_1,
                u_dot_of_place_5_1, sin_p_sin_q_1, u_dot_of_place_8_1, u_dot_of_place_9_1,
                u_dot_of_place_12_1, u_dot_of_place_12_1, p_ddot_of_r_l_q_2_p_2_1,
            ]),
        ];
    }
    let mut count_last = S::int(1);
    let mut q_2_last = q_2_1;
    let mut p_2_last = p_2_1;
    let mut q_dot_2_last = q_dot_2_1;
    let mut p_dot_last = p_dot_1;
    let mut sin_p_last = sin_p_1;
    let mut cos_p_last = cos_p_1;
    let mut sin_q_last = sin_q_1;
    let mut cos_q_last = cos_q_1;
    let mut q_2_plus_p_2_last = q_2_plus_p_2_1;
    let mut sin_q_plus_p_last = sin_q_plus_p_1;
    let mut cos_q_plus_p_last = cos_q_plus_p_1;
    let mut sin_p_sin_q_last = sin_p_sin_q_1;
    let mut cos_p_cos_q_last = cos_p_cos_q_1;
    let mut u_dot_of_q_2_p_2_last = u_dot_of_q_2_p_2_1;
    let mut q_dot_2_sq_last = q_dot_2_sq_1;
    let mut cos_q_cos_q_plus_p_inv_last = cos_q_cos_q_plus_p_inv_1;
    let mut u_dot_of_q_2_p_2_2_last = u_dot_of_q_2_p_2_2_1;
    let mut u_dot_of_p_dot_last = u_dot_of_p_dot_1;
    let mut u_dot_of_q_dot_2_2_last = u_dot_of_q_dot_2_2_1;
    let mut u_dot_of_place_last = u_dot_of_place_1;
    let mut u_dot_of_motion_2_last = u_dot_of_motion_2_1;
    let mut u_dot_of_motion_4_last = u_dot_of_motion_4_1;
    let mut u_dot_of_motion_7_last = u_dot_of_motion_7_1;
    let mut u_dot_of_r_l_q_2_p_2_2_last = u_dot_of_r_l_q_2_p_2_2_1;
    let mut u_dot_of_q_dot_2_4_last = u_dot_of_q_dot_2_4_1;
    let mut u_dot_of_place_4_last = u_dot_of_place_4_1;
    let mut u_dot_of_place_5_last = u_dot_of_place_5_1;
    let mut u_dot_of_place_8_last = u_dot_of_place_8_1;
    let mut u_dot_of_place_9_last = u_dot_of_place_9_1;
    let mut u_dot_of_place_11_last = u_dot_of_place_11_1;
    let mut u_dot_of_motion_8_last = u_dot_of_motion_8_1;
    let mut u_dot_of_place_12_last = u_dot_of_place_12_1;
    let mut q_dot_2_dot_last = q_dot_2_dot_1;
    let mut p_ddot_of_r_l_q_2_p_2_last = p_ddot_of_r_l_q_2_p_2_1;
    let mut next = [S::int(0); 40];
    // Rates at order k - 1.
    let mut q_2_rate = q_dot_2_1;
    let mut p_2_rate = p_dot_1;
    let mut q_dot_2_rate = q_dot_2_dot_1;
    let mut p_dot_rate = p_dot_dot_1;
    for order in 2..series.len() {
        let over_k = S::ratio(1, order as i64);
        // Order k, from lower orders: the states, over k since they are integrals, and what follows.
        let q_2 = q_2_rate * over_k;
        let p_2 = p_2_rate * over_k;
        let q_dot_2 = q_dot_2_rate * over_k;
        let p_dot = p_dot_rate * over_k;
        series[order] = [q_2, p_2, q_dot_2, p_dot];
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
                q_dot_2_1.mul_add(cos_q_last, q_dot_2_last.mul_add(cos_q_1, next[6])),
                sin_p_1.mul_add(sin_q_last, sin_p_last.mul_add(sin_q_1, next[7])),
                cos_p_1.mul_add(cos_q_last, cos_p_last.mul_add(cos_q_1, next[8])),
                (q_dot_2_1 + q_dot_2_1).mul_add(q_dot_2_last, next[9]),
                cos_q_plus_p_1
                    .mul_add(
                        cos_q_cos_q_plus_p_inv_last,
                        cos_q_plus_p_last.mul_add(cos_q_cos_q_plus_p_inv_1, next[10]),
                    ),
                sin_q_plus_p_1
                    .mul_add(
                        cos_q_cos_q_plus_p_inv_last,
                        sin_q_plus_p_last.mul_add(cos_q_cos_q_plus_p_inv_1, next[11]),
                    ),
                cos_q_cos_q_plus_p_inv_1
                    .mul_add(
                        u_dot_of_q_2_p_2_2_last,
                        cos_q_cos_q_plus_p_inv_last
                            .mul_add(u_dot_of_q_2_p_2_2_1, next[12]),
                    ),
                q_dot_2_1
                    .mul_add(
                        u_dot_of_q_2_p_2_last,
                        q_dot_2_last.mul_add(u_dot_of_q_2_p_2_1, next[13]),
                    ),
                p_dot_1
                    .mul_add(
                        u_dot_of_q_2_p_2_last,
                        p_dot_last.mul_add(u_dot_of_q_2_p_2_1, next[14]),
                    ),
                cos_p_1
                    .mul_add(
                        u_dot_of_place_last,
                        cos_p_last.mul_add(u_dot_of_place_1, next[15]),
                    ),
                q_dot_2_1
                    .mul_add(
                        u_dot_of_motion_2_last,
                        q_dot_2_last.mul_add(u_dot_of_motion_2_1, next[16]),
                    ),
                p_dot_1
                    .mul_add(
                        u_dot_of_p_dot_last,
                        p_dot_last.mul_add(u_dot_of_p_dot_1, next[17]),
                    ),
                (cos_q_1 + cos_q_1).mul_add(cos_q_last, next[18]),
                cos_q_1
                    .mul_add(
                        u_dot_of_q_dot_2_2_last,
                        cos_q_last.mul_add(u_dot_of_q_dot_2_2_1, next[19]),
                    ),
                sin_p_1
                    .mul_add(
                        u_dot_of_motion_4_last,
                        sin_p_last.mul_add(u_dot_of_motion_4_1, next[20]),
                    ),
                sin_q_1
                    .mul_add(
                        cos_p_cos_q_last,
                        sin_q_last.mul_add(cos_p_cos_q_1, next[21]),
                    ),
                u_dot_of_q_2_p_2_1
                    .mul_add(
                        u_dot_of_motion_7_last,
                        u_dot_of_q_2_p_2_last.mul_add(u_dot_of_motion_7_1, next[22]),
                    ),
                cos_q_plus_p_1
                    .mul_add(
                        u_dot_of_r_l_q_2_p_2_2_last,
                        cos_q_plus_p_last.mul_add(u_dot_of_r_l_q_2_p_2_2_1, next[23]),
                    ),
                q_dot_2_sq_1
                    .mul_add(
                        u_dot_of_r_l_q_2_p_2_2_last,
                        q_dot_2_sq_last.mul_add(u_dot_of_r_l_q_2_p_2_2_1, next[24]),
                    ),
                u_dot_of_q_2_p_2_1
                    .mul_add(
                        u_dot_of_place_4_last,
                        u_dot_of_q_2_p_2_last.mul_add(u_dot_of_place_4_1, next[25]),
                    ),
                u_dot_of_q_dot_2_4_1
                    .mul_add(
                        u_dot_of_place_4_last,
                        u_dot_of_q_dot_2_4_last.mul_add(u_dot_of_place_4_1, next[26]),
                    ),
                (cos_p_1 + cos_p_1).mul_add(cos_p_last, next[27]),
                cos_q_1
                    .mul_add(
                        u_dot_of_place_5_last,
                        cos_q_last.mul_add(u_dot_of_place_5_1, next[28]),
                    ),
                cos_p_1
                    .mul_add(
                        sin_p_sin_q_last,
                        cos_p_last.mul_add(sin_p_sin_q_1, next[29]),
                    ),
                cos_q_plus_p_1
                    .mul_add(
                        u_dot_of_place_8_last,
                        cos_q_plus_p_last.mul_add(u_dot_of_place_8_1, next[30]),
                    ),
                cos_q_1
                    .mul_add(
                        u_dot_of_place_9_last,
                        cos_q_last.mul_add(u_dot_of_place_9_1, next[31]),
                    ),
                u_dot_of_place_11_1
                    .mul_add(
                        u_dot_of_place_12_last,
                        u_dot_of_place_11_last.mul_add(u_dot_of_place_12_1, next[32]),
                    ),
                u_dot_of_motion_8_1
                    .mul_add(
                        u_dot_of_place_12_last,
                        u_dot_of_motion_8_last.mul_add(u_dot_of_place_12_1, next[33]),
                    ),
                q_dot_2_dot_1
                    .mul_add(
                        p_ddot_of_r_l_q_2_p_2_last,
                        q_dot_2_dot_last.mul_add(p_ddot_of_r_l_q_2_p_2_1, next[34]),
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
        // q_dot_2_cos_q = q_dot_2*cos_q
        let q_dot_2_cos_q = cos_q.mul_add(q_dot_2_0, q_dot_2.mul_add(cos_q_0, sums[6]));
        // sin_p_sin_q = sin_p*sin_q
        let sin_p_sin_q = sin_q.mul_add(sin_p_0, sin_p.mul_add(sin_q_0, sums[7]));
        // cos_p_cos_q = cos_p*cos_q
        let cos_p_cos_q = cos_q.mul_add(cos_p_0, cos_p.mul_add(cos_q_0, sums[8]));
        // u_dot_of_q_2_p_2 = sin_p_sin_q - cos_p_cos_q
        let u_dot_of_q_2_p_2 = sin_p_sin_q - cos_p_cos_q;
        // q_dot_2_sq = q_dot_2*q_dot_2
        let q_dot_2_sq = q_dot_2.mul_add(q_dot_2_0 + q_dot_2_0, sums[9]);
        // cos_q_cos_q_plus_p_inv = cos_q/cos_q_plus_p
        let cos_q_cos_q_plus_p_inv = cos_q_plus_p
            .mul_add(
                -(cos_q_cos_q_plus_p_inv_0 * over_cos_q_plus_p),
                (cos_q - sums[10]) * over_cos_q_plus_p,
            );
        // u_dot_of_q_2_p_2_2 = sin_q_plus_p*cos_q_cos_q_plus_p_inv
        let u_dot_of_q_2_p_2_2 = cos_q_cos_q_plus_p_inv
            .mul_add(
                sin_q_plus_p_0,
                sin_q_plus_p.mul_add(cos_q_cos_q_plus_p_inv_0, sums[11]),
            );
        // u_dot_of_q_2_p_2_3 = cos_q_cos_q_plus_p_inv*u_dot_of_q_2_p_2_2
        let u_dot_of_q_2_p_2_3 = u_dot_of_q_2_p_2_2
            .mul_add(
                cos_q_cos_q_plus_p_inv_0,
                cos_q_cos_q_plus_p_inv.mul_add(u_dot_of_q_2_p_2_2_0, sums[12]),
            );
        // u_dot_of_r_l_q_2_p_2 = sin_q + r_by_l*u_dot_of_q_2_p_2_3
        let u_dot_of_r_l_q_2_p_2 = u_dot_of_q_2_p_2_3.mul_add(r_by_l, sin_q);
        // u_dot_of_q_dot_2 = q_dot_2*u_dot_of_q_2_p_2
        let u_dot_of_q_dot_2 = u_dot_of_q_2_p_2
            .mul_add(q_dot_2_0, q_dot_2.mul_add(u_dot_of_q_2_p_2_0, sums[13]));
        // u_dot_of_p_dot = p_dot*u_dot_of_q_2_p_2
        let u_dot_of_p_dot = u_dot_of_q_2_p_2
            .mul_add(p_dot_0, p_dot.mul_add(u_dot_of_q_2_p_2_0, sums[14]));
        // u_dot_of_motion = u_dot_of_q_dot_2 + 2*u_dot_of_p_dot
        let u_dot_of_motion = u_dot_of_p_dot.mul_add(S::int(2), u_dot_of_q_dot_2);
        // u_dot_of_q_dot_2_2 = r*q_dot_2_sq + minus_g*cos_q
        let u_dot_of_q_dot_2_2 = cos_q.mul_add(minus_g, r * q_dot_2_sq);
        // u_dot_of_place = b_mr_plus_l_mp*u_dot_of_q_2_p_2
        let u_dot_of_place = b_mr_plus_l_mp * u_dot_of_q_2_p_2;
        // u_dot_of_place_2 = cos_p*u_dot_of_place
        let u_dot_of_place_2 = u_dot_of_place
            .mul_add(cos_p_0, cos_p.mul_add(u_dot_of_place_0, sums[15]));
        // u_dot_of_place_3 = weight*cos_q + l*u_dot_of_place_2
        let u_dot_of_place_3 = u_dot_of_place_2.mul_add(l, weight * cos_q);
        // u_dot_of_motion_2 = r_mp*q_dot_2_cos_q + minus_b_mr_minus_l_mp*u_dot_of_motion
        let u_dot_of_motion_2 = u_dot_of_motion
            .mul_add(minus_b_mr_minus_l_mp, r_mp * q_dot_2_cos_q);
        // u_dot_of_motion_3 = q_dot_2*u_dot_of_motion_2
        let u_dot_of_motion_3 = u_dot_of_motion_2
            .mul_add(q_dot_2_0, q_dot_2.mul_add(u_dot_of_motion_2_0, sums[16]));
        // u_dot_of_p_dot_2 = p_dot*u_dot_of_p_dot
        let u_dot_of_p_dot_2 = u_dot_of_p_dot
            .mul_add(p_dot_0, p_dot.mul_add(u_dot_of_p_dot_0, sums[17]));
        // cos_q_sq = cos_q*cos_q
        let cos_q_sq = cos_q.mul_add(cos_q_0 + cos_q_0, sums[18]);
        // u_dot_of_q_dot_2_3 = cos_q*u_dot_of_q_dot_2_2
        let u_dot_of_q_dot_2_3 = u_dot_of_q_dot_2_2
            .mul_add(cos_q_0, cos_q.mul_add(u_dot_of_q_dot_2_2_0, sums[19]));
        // u_dot_of_motion_4 = minus_l_mr_g_plus_mp_g + l*u_dot_of_motion_3 +
        //   minus_l_b_mr_plus_l_mp*u_dot_of_p_dot_2 + l_mr_g*cos_q_sq + b_mr*u_dot_of_q_dot_2_3
        let u_dot_of_motion_4 = u_dot_of_motion_3
            .mul_add(
                l,
                u_dot_of_p_dot_2
                    .mul_add(
                        minus_l_b_mr_plus_l_mp,
                        u_dot_of_q_dot_2_3.mul_add(b_mr, l_mr_g * cos_q_sq),
                    ),
            );
        // u_dot_of_motion_5 = sin_p*u_dot_of_motion_4
        let u_dot_of_motion_5 = u_dot_of_motion_4
            .mul_add(sin_p_0, sin_p.mul_add(u_dot_of_motion_4_0, sums[20]));
        // cos_p_sin_q_cos_q = sin_q*cos_p_cos_q
        let cos_p_sin_q_cos_q = cos_p_cos_q
            .mul_add(sin_q_0, sin_q.mul_add(cos_p_cos_q_0, sums[21]));
        // u_dot_of_motion_6 = u_dot_of_motion_5 + mr_g_l_minus_b*cos_p_sin_q_cos_q
        let u_dot_of_motion_6 = mr_g_l_minus_b * cos_p_sin_q_cos_q + u_dot_of_motion_5;
        // u_dot_of_motion_7 = u_dot_of_motion_6/u_dot_of_q_2_p_2
        let u_dot_of_motion_7 = u_dot_of_motion_6
            .mul_add(
                over_u_dot_of_q_2_p_2,
                -(u_dot_of_q_2_p_2.mul_add(u_dot_of_motion_7_0, sums[22]) * over_u_dot_of_q_2_p_2),
            );
        // u_dot_of_r_l_q_2_p_2_2 = u_dot_of_r_l_q_2_p_2/cos_q_plus_p
        let u_dot_of_r_l_q_2_p_2_2 = u_dot_of_r_l_q_2_p_2
            .mul_add(
                over_cos_q_plus_p,
                -(cos_q_plus_p.mul_add(u_dot_of_r_l_q_2_p_2_2_0, sums[23]) * over_cos_q_plus_p),
            );
        // u_dot_of_q_dot_2_4 = q_dot_2_sq*u_dot_of_r_l_q_2_p_2_2
        let u_dot_of_q_dot_2_4 = u_dot_of_r_l_q_2_p_2_2
            .mul_add(
                q_dot_2_sq_0,
                q_dot_2_sq.mul_add(u_dot_of_r_l_q_2_p_2_2_0, sums[24]),
            );
        // u_dot_of_place_4 = u_dot_of_place_3/u_dot_of_q_2_p_2
        let u_dot_of_place_4 = u_dot_of_place_3
            .mul_add(
                over_u_dot_of_q_2_p_2,
                -(u_dot_of_q_2_p_2.mul_add(u_dot_of_place_4_0, sums[25]) * over_u_dot_of_q_2_p_2),
            );
        // u_dot_of_q_dot_2_5 = u_dot_of_q_dot_2_4*u_dot_of_place_4
        let u_dot_of_q_dot_2_5 = u_dot_of_q_dot_2_4
            .mul_add(
                u_dot_of_place_4_0,
                u_dot_of_place_4.mul_add(u_dot_of_q_dot_2_4_0, sums[26]),
            );
        // cos_p_sq = cos_p*cos_p
        let cos_p_sq = cos_p.mul_add(cos_p_0 + cos_p_0, sums[27]);
        // u_dot_of_place_5 = weight_2 + minus_b_mr_by_l_minus_mp*cos_p_sq
        let u_dot_of_place_5 = minus_b_mr_by_l_minus_mp * cos_p_sq;
        // u_dot_of_place_6 = cos_q*u_dot_of_place_5
        let u_dot_of_place_6 = u_dot_of_place_5
            .mul_add(cos_q_0, cos_q.mul_add(u_dot_of_place_5_0, sums[28]));
        // sin_p_cos_p_sin_q = cos_p*sin_p_sin_q
        let sin_p_cos_p_sin_q = sin_p_sin_q
            .mul_add(cos_p_0, cos_p.mul_add(sin_p_sin_q_0, sums[29]));
        // u_dot_of_place_7 = u_dot_of_place_6 + b_mr_by_l_plus_mp*sin_p_cos_p_sin_q
        let u_dot_of_place_7 = b_mr_by_l_plus_mp * sin_p_cos_p_sin_q + u_dot_of_place_6;
        // u_dot_of_place_8 = u_dot_of_place_7/cos_q_plus_p
        let u_dot_of_place_8 = u_dot_of_place_7
            .mul_add(
                over_cos_q_plus_p,
                -(cos_q_plus_p.mul_add(u_dot_of_place_8_0, sums[30]) * over_cos_q_plus_p),
            );
        // u_dot_of_place_9 = u_dot_of_place_8 + mr_1_minus_b_by_l*cos_p
        let u_dot_of_place_9 = mr_1_minus_b_by_l * cos_p + u_dot_of_place_8;
        // u_dot_of_place_10 = cos_q*u_dot_of_place_9
        let u_dot_of_place_10 = u_dot_of_place_9
            .mul_add(cos_q_0, cos_q.mul_add(u_dot_of_place_9_0, sums[31]));
        // u_dot_of_place_11 = r_2*u_dot_of_place_10 + minus_r_2_mr_plus_mp*sin_p_sin_q +
        //   minus_i*u_dot_of_q_2_p_2
        let u_dot_of_place_11 = u_dot_of_place_10
            .mul_add(
                r_2,
                u_dot_of_q_2_p_2.mul_add(minus_i, minus_r_2_mr_plus_mp * sin_p_sin_q),
            );
        // u_dot_of_motion_8 = r_by_l*u_dot_of_motion_7 + r_2_by_l_2*u_dot_of_q_dot_2_5
        let u_dot_of_motion_8 = u_dot_of_motion_7
            .mul_add(r_by_l, r_2_by_l_2 * u_dot_of_q_dot_2_5);
        // u_dot_of_place_12 = u_dot_of_q_2_p_2/u_dot_of_place_11
        let u_dot_of_place_12 = u_dot_of_place_11
            .mul_add(
                -(u_dot_of_place_12_0 * over_u_dot_of_place_11),
                (u_dot_of_q_2_p_2 - sums[32]) * over_u_dot_of_place_11,
            );
        // q_dot_2_dot = u_dot_of_motion_8*u_dot_of_place_12
        let q_dot_2_dot = u_dot_of_motion_8
            .mul_add(
                u_dot_of_place_12_0,
                u_dot_of_place_12.mul_add(u_dot_of_motion_8_0, sums[33]),
            );
        // p_ddot_of_r_l_q_2_p_2 = 1 + r_by_l*cos_q_cos_q_plus_p_inv
        let p_ddot_of_r_l_q_2_p_2 = r_by_l * cos_q_cos_q_plus_p_inv;
        // p_ddot_of_motion = q_dot_2_dot*p_ddot_of_r_l_q_2_p_2
        let p_ddot_of_motion = q_dot_2_dot
            .mul_add(
                p_ddot_of_r_l_q_2_p_2_0,
                p_ddot_of_r_l_q_2_p_2.mul_add(q_dot_2_dot_0, sums[34]),
            );
        // p_dot_dot = r_by_l*u_dot_of_q_dot_2_4 - p_ddot_of_motion
        let p_dot_dot = r_by_l * u_dot_of_q_dot_2_4 - p_ddot_of_motion;
        q_2_rate = q_dot_2;
        p_2_rate = p_dot;
        q_dot_2_rate = q_dot_2_dot;
        p_dot_rate = p_dot_dot;
        // Factors of the convolutions: left, right.
        history[order] = [
            padded([
                count * p_2,
                count * p_2,
                count * q_2,
                count * q_2,
                count * q_2_plus_p_2,
                count * q_2_plus_p_2,
                q_dot_2, sin_p, cos_p, q_dot_2, cos_q_plus_p, sin_q_plus_p, cos_q_cos_q_plus_p_inv,
                q_dot_2, p_dot, cos_p, q_dot_2, p_dot, cos_q, cos_q, sin_p, sin_q, u_dot_of_q_2_p_2,
                cos_q_plus_p, q_dot_2_sq, u_dot_of_q_2_p_2, u_dot_of_q_dot_2_4, cos_p, cos_q, cos_p,
                cos_q_plus_p, cos_q, u_dot_of_place_11, u_dot_of_motion_8, q_dot_2_dot,
            ]),
            padded([
                cos_p, sin_p, cos_q, sin_q, cos_q_plus_p, sin_q_plus_p, cos_q, sin_q, cos_q,
                q_dot_2, cos_q_cos_q_plus_p_inv, cos_q_cos_q_plus_p_inv, u_dot_of_q_2_p_2_2,
                u_dot_of_q_2_p_2, u_dot_of_q_2_p_2, u_dot_of_place, u_dot_of_motion_2,
                u_dot_of_p_dot, cos_q, u_dot_of_q_dot_2_2, u_dot_of_motion_4, cos_p_cos_q,
                u_dot_of_motion_7, u_dot_of_r_l_q_2_p_2_2, u_dot_of_r_l_q_2_p_2_2, u_dot_of_place_4,
                u_dot_of_place_4, cos_p, u_dot_of_place_5, sin_p_sin_q, u_dot_of_place_8,
                u_dot_of_place_9, u_dot_of_place_12, u_dot_of_place_12, p_ddot_of_r_l_q_2_p_2,
            ]),
        ];
        count_last = count;
        q_2_last = q_2;
        p_2_last = p_2;
        q_dot_2_last = q_dot_2;
        p_dot_last = p_dot;
        sin_p_last = sin_p;
        cos_p_last = cos_p;
        sin_q_last = sin_q;
        cos_q_last = cos_q;
        q_2_plus_p_2_last = q_2_plus_p_2;
        sin_q_plus_p_last = sin_q_plus_p;
        cos_q_plus_p_last = cos_q_plus_p;
        sin_p_sin_q_last = sin_p_sin_q;
        cos_p_cos_q_last = cos_p_cos_q;
        u_dot_of_q_2_p_2_last = u_dot_of_q_2_p_2;
        q_dot_2_sq_last = q_dot_2_sq;
        cos_q_cos_q_plus_p_inv_last = cos_q_cos_q_plus_p_inv;
        u_dot_of_q_2_p_2_2_last = u_dot_of_q_2_p_2_2;
        u_dot_of_p_dot_last = u_dot_of_p_dot;
        u_dot_of_q_dot_2_2_last = u_dot_of_q_dot_2_2;
        u_dot_of_place_last = u_dot_of_place;
        u_dot_of_motion_2_last = u_dot_of_motion_2;
        u_dot_of_motion_4_last = u_dot_of_motion_4;
        u_dot_of_motion_7_last = u_dot_of_motion_7;
        u_dot_of_r_l_q_2_p_2_2_last = u_dot_of_r_l_q_2_p_2_2;
        u_dot_of_q_dot_2_4_last = u_dot_of_q_dot_2_4;
        u_dot_of_place_4_last = u_dot_of_place_4;
        u_dot_of_place_5_last = u_dot_of_place_5;
        u_dot_of_place_8_last = u_dot_of_place_8;
        u_dot_of_place_9_last = u_dot_of_place_9;
        u_dot_of_place_11_last = u_dot_of_place_11;
        u_dot_of_motion_8_last = u_dot_of_motion_8;
        u_dot_of_place_12_last = u_dot_of_place_12;
        q_dot_2_dot_last = q_dot_2_dot;
        p_ddot_of_r_l_q_2_p_2_last = p_ddot_of_r_l_q_2_p_2;
    }
}

/// Lagrange's equations of this model as a [`System`].
#[derive(Clone, Copy, Debug)]
pub struct Lagrange;

impl<S: Scalar> System<S> for Lagrange {
    fn lengths(&self) -> Lengths {
        Lengths {
            parameters: 9,
            coordinates: 2,
            variables: 2,
            speeds: 1,
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
        80 * order + SLACK
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
        2
    }
    fn constraint_name(&self, at: usize) -> &str {
        ["wrist_1", "wrist_1'"][at]
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
    slice.try_into().expect("a slice of the length that System states")
}
