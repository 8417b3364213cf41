//! Slider-crank: Lagrange's equations, [E(q), -C(q)^T; C(q), 0] (q'', lambda) = (A(q, q'), b(q, q')).
//!
//! Generated from `models/slider_crank/model.toml`. Do not edit; run `tripos regenerate`.

use super::super::Parameters;

pub use super::kane::potential_energy;

use tripos_traits::{Dual, Lengths, Scalar, System, by_columns};

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

/// What a change of the state along a direction makes of its derivative: the Jacobian times the direction,
/// q first, by forward differentiation of the functions above.
#[must_use]
pub fn jacobian_product<S: Scalar>(
    p: &Parameters<S>,
    q: &[S; 2],
    q_dot: &[S; 2],
    direction: &[S; 4],
) -> [S; 4] {
    let p = Parameters::from_slice(&p.to_array().map(Dual::constant));
    let q = core::array::from_fn(|i| Dual {
        value: q[i], slope: direction[i],
    });
    let v = core::array::from_fn(|i| Dual {
        value: q_dot[i],
        slope: direction[2 + i],
    });
    let (of_q, of_v) = derivative(&p, &q, &v);
    let mut slopes = of_q.into_iter().chain(of_v).map(|rate| rate.slope);
    core::array::from_fn(|_| {
        slopes.next().expect("a slope for each component of the state")
    })
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
    slice.try_into().expect("a slice of the length that `System` requires")
}
